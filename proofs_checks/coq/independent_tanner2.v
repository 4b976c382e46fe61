(* Clauses of the claims about Tanner's second paper, formalised from their words before the theorems were looked at. *)
From Coq Require Import Reals Lia List Relations.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums paley_model paley_phase paley_laplacian tanner_energy tanner_flock.
From Flockproof Require tanner_nonsmooth tanner_graph.
Open Scope R_scope.

(* the force of j on i and the control (4) *)
Definition pull (adj : graph) (V' : nat -> nat -> R -> R) (r : nat -> C) (i j : nat) : C :=
  (if adj i j then RtoC (V' i j (Cmod (r i - r j)) / Cmod (r i - r j)) * (r i - r j) else 0)%C.
Definition gradV n adj V' r i : C := Csum n (pull adj V' r i).
Definition law4 n (adj : graph) V' (r v : nat -> C) i : C :=
  (- Csum n (fun j => if adj i j then v i - v j else 0) - gradV n adj V' r i)%C.
Definition apart_at n (adj : graph) (r : nat -> C) := forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> r i <> r j.
(* a motion of (1) for all t >= 0 with (4) where (4) has a value, from a start in which no linked agents coincide *)
Definition motion n adj (V' : nat -> nat -> R -> R) (r v : nat -> R -> C) := apart_at n adj (fun i => r i 0) /\
  forall t i, 0 <= t -> (i < n)%nat -> is_velocity (r i) t (v i t) /\
    (apart_at n adj (fun i => r i t) -> is_velocity (v i) t (law4 n adj V' (fun i => r i t) (fun i => v i t) i)).
(* Definition 3 with a continuous derivative; the potentials of a pair are one *)
Definition potentials n (adj : graph) (V V' : nat -> nat -> R -> R) := (forall i j s, V i j s = V j i s) /\
  forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true ->
    (forall s, 0 < s -> is_derive (V i j) s (V' i j s) /\ continuity_pt (V' i j) s /\ 0 <= V i j s) /\
    (forall c, exists d, 0 < d /\ forall s, 0 < s < d -> c < V i j s) /\ (forall c, exists D, forall s, D < s -> c < V i j s).
Definition to_zero (z : R -> C) := forall e, 0 < e -> exists T, forall t, T <= t -> Cmod (z t) < e.
Definition simple_graph adj := undirected adj /\ no_loops adj.

(* tanner2.thm1a, thm1b, thm1c clause 2, cor3 *)
Definition thm1a : Prop := forall n adj V V' r v, simple_graph adj -> strongly_connected n adj -> potentials n adj V V' ->
  motion n adj V' r v -> forall i j, (i < n)%nat -> (j < n)%nat -> to_zero (fun t => v i t - v j t)%C.
Definition thm1b : Prop := forall n adj V V' r v, simple_graph adj -> strongly_connected n adj -> potentials n adj V V' ->
  motion n adj V' r v -> forall t, 0 <= t -> apart_at n adj (fun i => r i t).
Definition thm1c_2 : Prop := forall n adj V V' r v, simple_graph adj -> strongly_connected n adj -> potentials n adj V V' ->
  motion n adj V' r v -> forall i, (i < n)%nat -> to_zero (fun t => gradV n adj V' (fun j => r j t) i).
Definition cor3 : Prop := forall n adj V V' r v, simple_graph adj ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> i <> j -> adj i j = true) -> potentials n adj V V' ->
  motion n adj V' r v -> forall t i j, 0 <= t -> (i < n)%nat -> (j < n)%nat -> i <> j -> r i t <> r j t.
(* a tree: connected, without a way back: no path of three or more different vertices closes *)
Fixpoint path_from (n : nat) (adj : graph) (i : nat) (l : list nat) : Prop :=
  match l with nil => True | j :: l => (j < n)%nat /\ adj i j = true /\ path_from n adj j l end.
Definition acyclic n (adj : graph) := forall i l, (i < n)%nat -> NoDup (i :: l) -> path_from n adj i l -> (2 <= length l)%nat ->
  adj (last l i) i = false.
Definition is_tree n adj := strongly_connected n adj /\ acyclic n adj.
(* tanner2.cor1 clauses 4, 5, 6 *)
Definition cor1_4 : Prop := forall n adj V V' r v (d : nat -> nat -> R), simple_graph adj -> is_tree n adj -> potentials n adj V V' ->
  motion n adj V' r v ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> 0 < d i j /\ (forall s, 0 < s -> V' i j s = 0 -> s = d i j)) ->
  forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> is_lim (fun t => Cmod (r i t - r j t)%C) p_infty (d i j).
Definition cor1_5 : Prop := forall n adj V V' r v, simple_graph adj -> is_tree n adj ->
  (forall O y, tanner_graph.oriented n adj O -> (forall k, (k < n)%nat -> lsum O (fun f => inc k f * y f) = 0) -> forall f, In f O -> y f = 0) /\
  (potentials n adj V V' -> motion n adj V' r v ->
   forall i j, (i < n)%nat -> (j < n)%nat -> to_zero (fun t => pull adj V' (fun k => r k t) i j)).
Definition cor1_6 : Prop := forall n adj (V V' : nat -> nat -> R -> R) r (d : nat -> nat -> R), simple_graph adj -> is_tree n adj ->
  (forall i j s, V i j s = V j i s) ->
  (forall i j s, (i < n)%nat -> (j < n)%nat -> adj i j = true -> 0 < s -> is_derive (V i j) s (V' i j s) /\ (V' i j s = 0 -> s = d i j)) ->
  apart_at n adj r -> (forall i, (i < n)%nat -> gradV n adj V' r i = 0%C) ->
  forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> Cmod (r i - r j)%C = d i j.
(* tanner2.lem1 clauses 2, 3, 4; tanner2.lem2 clauses 2, 3; Clarke's derivatives *)
Definition saturate (V : R -> R) (R0 s : R) := if Rlt_dec s R0 then V s else V R0.
Definition usual_dd (f : R -> R) (x w l : R) := forall e, 0 < e -> exists d, 0 < d /\ forall h, 0 < h < d -> Rabs ((f (x + h * w) - f x) / h - l) < e.
Definition clarke_dd (f : R -> R) (x w l : R) :=
  (forall e, 0 < e -> exists d, 0 < d /\ forall y h, Rabs (y - x) < d -> 0 < h < d -> (f (y + h * w) - f y) / h < l + e) /\
  (forall e d, 0 < e -> 0 < d -> exists y h, Rabs (y - x) < d /\ 0 < h < d /\ l - e < (f (y + h * w) - f y) / h).
Definition regular_at f x := forall w, exists l, usual_dd f x w l /\ clarke_dd f x w l.
Definition smooth (V V' : R -> R) := forall s, 0 < s -> is_derive V s (V' s) /\ continuity_pt V' s.
Definition lem1_2 : Prop := forall V V' R0 s, smooth V V' -> 0 < R0 -> 0 < s -> s <> R0 -> regular_at (saturate V R0) s.
Definition lem1_3 : Prop := forall V V' R0, smooth V V' -> 0 < R0 -> 0 < V' R0 -> regular_at (fun s => - saturate V R0 s) R0.
Definition lem1_4 : Prop := forall V V' R0 w, smooth V V' -> 0 < R0 -> 0 < V' R0 ->
  usual_dd (saturate V R0) R0 w (Rmin 0 (V' R0 * w)) /\ clarke_dd (saturate V R0) R0 w (Rmax 0 (V' R0 * w)).
Definition lem2_2 : Prop := forall V V' R0 z, smooth V V' -> 0 < R0 -> 0 < V' R0 ->
  ((forall w l, clarke_dd (saturate V R0) R0 w l -> z * w <= l) <-> 0 <= z <= V' R0).
(* in the plane: U as a function of r_i; its generalised gradient is {z | <z, w> <= U°(r_i; w) for all w} *)
Definition clarke_dd2 (f : C -> R) (x w : C) (l : R) :=
  (forall e, 0 < e -> exists d, 0 < d /\ forall y h, Cmod (y - x)%C < d -> 0 < h < d -> (f (y + RtoC h * w)%C - f y) / h < l + e) /\
  (forall e d, 0 < e -> 0 < d -> exists y h, Cmod (y - x)%C < d /\ 0 < h < d /\ l - e < (f (y + RtoC h * w)%C - f y) / h).
Definition lem2_3 : Prop := forall V V' R0 ri rj z, smooth V V' -> 0 < R0 -> 0 < V' R0 -> Cmod (ri - rj)%C = R0 ->
  ((forall w l, clarke_dd2 (fun y => saturate V R0 (Cmod (y - rj)%C)) ri w l -> inner z w <= l) <->
   exists s, 0 <= s <= 1 /\ z = (RtoC s * (RtoC (V' R0 / R0) * (ri - rj)))%C).
(* the energy (6) *)
Definition energy6 n (adj : graph) (V : nat -> nat -> R -> R) (r v : nat -> C) : R :=
  / 2 * Sum n (fun i => Sum n (fun j => if adj i j then V i j (Cmod (r i - r j)%C) else 0) + Cmod (v i) ^ 2).
(* tanner2.bound_v clause 2, tanner2.bound_r clause 2; D is above every V_e^-1(c), that is where V_e <= c no longer *)
Definition bound_v : Prop := forall n adj V V' r v c, simple_graph adj -> potentials n adj V V' -> apart_at n adj r ->
  energy6 n adj V r v <= c -> forall i, (i < n)%nat -> Cmod (v i) ^ 2 <= 2 * c /\ Cmod (v i) <= sqrt (2 * c).
Definition bound_r : Prop := forall n adj V V' r v c D, (2 <= n)%nat -> simple_graph adj -> strongly_connected n adj -> potentials n adj V V' ->
  apart_at n adj r -> energy6 n adj V r v <= c ->
  (forall i j s, (i < n)%nat -> (j < n)%nat -> adj i j = true -> 0 < s -> V i j s <= c -> s <= D) ->
  forall i j, (i < n)%nat -> (j < n)%nat -> Cmod (r i - r j)%C <= (INR n - 1) * D.
(* tanner2.eq9 *)
Definition eq9 : Prop := forall n adj (V V' : nat -> nat -> R -> R) r v t, simple_graph adj -> (forall i j s, V i j s = V j i s) ->
  (forall i j s, (i < n)%nat -> (j < n)%nat -> adj i j = true -> 0 < s -> is_derive (V i j) s (V' i j s)) ->
  apart_at n adj (fun i => r i t) ->
  (forall i, (i < n)%nat -> is_velocity (r i) t (v i t) /\ is_velocity (v i) t (law4 n adj V' (fun i => r i t) (fun i => v i t) i)) ->
  let form x := Sum n (fun i => x i * Sum n (fun j => lap n adj i j * x j)) in
  is_derive (fun s => energy6 n adj V (fun i => r i s) (fun i => v i s)) t (- form (fun i => fst (v i t)) - form (fun i => snd (v i t))).
(* tanner2.Qdot: the graph at time t and around it is that of (10): linked below R *)
Definition by_distance (r : nat -> C) (R0 : R) : graph := fun i j =>
  andb (negb (Nat.eqb i j)) (if Rlt_dec (Cmod (r i - r j)%C) R0 then true else false).
Definition energy11 n (V : nat -> nat -> R -> R) R0 (r v : nat -> C) : R :=
  / 2 * Sum n (fun i => Sum n (fun j => if Nat.eqb i j then 0 else saturate (V i j) R0 (Cmod (r i - r j)%C)) + Cmod (v i) ^ 2).
Definition Qdot : Prop := forall n V V' R0 r v t, 0 < R0 -> (forall i j s, V i j s = V j i s) ->
  (forall i j s, (i < n)%nat -> (j < n)%nat -> i <> j -> 0 < s -> is_derive (V i j) s (V' i j s)) ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> i <> j -> r i t <> r j t /\ Cmod (r i t - r j t)%C <> R0) ->
  let adj := by_distance (fun i => r i t) R0 in
  (forall i, (i < n)%nat -> is_velocity (r i) t (v i t) /\ is_velocity (v i) t (law4 n adj V' (fun i => r i t) (fun i => v i t) i)) ->
  let form x := Sum n (fun i => x i * Sum n (fun j => lap n adj i j * x j)) in
  is_derive (fun s => energy11 n V R0 (fun i => r i s) (fun i => v i s)) t (- form (fun i => fst (v i t)) - form (fun i => snd (v i t))).
(* tanner2.Q: the pairs i < j that are not linked *)
Definition Q_1 : Prop := forall n (V : nat -> nat -> R -> R) R0 r v, (forall i j s, V i j s = V j i s) ->
  energy6 n (by_distance r R0) V r v +
    Sum n (fun i => Sum n (fun j => if Nat.ltb i j then (if by_distance r R0 i j then 0 else V i j R0) else 0)) = energy11 n V R0 r v.
(* tanner2.L clauses 4, 5 *)
Definition L_4 : Prop := forall n adj (x : nat -> R), undirected adj -> strongly_connected n adj ->
  ((forall i, (i < n)%nat -> Sum n (fun j => lap n adj i j * x j) = 0) <-> exists c, forall i, (i < n)%nat -> x i = c).
Definition L_5 : Prop := forall n adj lam (x : nat -> R), undirected adj -> strongly_connected n adj ->
  (forall i, (i < n)%nat -> Sum n (fun j => lap n adj i j * x j) = lam * x i) ->
  (exists i j, (i < n)%nat /\ (j < n)%nat /\ x i <> x j) -> 0 < lam.
(* tanner2.rangeB clause 1 *)
Definition rangeB_1 : Prop := forall n adj O (x : nat -> R), simple_graph adj -> strongly_connected n adj -> tanner_graph.oriented n adj O ->
  ((exists y, forall k, (k < n)%nat -> lsum O (fun f => inc k f * y f) = x k) <-> Sum n x = 0).
(* tanner2.eq7 clause 3, in the positions and velocities: the limits of points of Omega belong to it *)
Definition eq7_3 : Prop := forall n adj V V' c (r v : nat -> nat -> C) (r0 v0 : nat -> C), simple_graph adj -> potentials n adj V V' ->
  (forall m, apart_at n adj (r m) /\ energy6 n adj V (r m) (v m) <= c) ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> forall e, 0 < e -> exists M, forall m, (M <= m)%nat -> Cmod ((r m i - r m j) - (r0 i - r0 j))%C < e) ->
  (forall i, (i < n)%nat -> forall e, 0 < e -> exists M, forall m, (M <= m)%nat -> Cmod (v m i - v0 i)%C < e) ->
  apart_at n adj r0 /\ energy6 n adj V r0 v0 <= c.
(* tanner2.cor2_rate clauses 3 (inequality), 4; lam a lower bound of the form, so lam <= lambda_2, attained by lambda_2 *)
Definition rate_3 : Prop := forall n adj lam (v : nat -> R -> R), (2 <= n)%nat -> simple_graph adj -> strongly_connected n adj ->
  (forall x, Sum n x = 0 -> lam * Sum n (fun i => x i ^ 2) <= Sum n (fun i => x i * Sum n (fun j => lap n adj i j * x j))) ->
  (forall t i, 0 <= t -> (i < n)%nat -> is_derive (v i) t (- Sum n (fun j => if adj i j then v i t - v j t else 0))) ->
  let dev t := sqrt (Sum n (fun i => (v i t - / INR n * Sum n (fun j => v j t)) ^ 2)) in
  forall t, 0 <= t -> dev t <= exp (- lam * t) * dev 0.
