(* Clauses of the claims about Tanner's second paper, formalised from their words before the theorems were looked at; the theorems
   prove them. *)
From Coq Require Import Reals Lra Lia List Relations Psatz Classical.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums paley_model paley_phase paley_laplacian paley_gradient tanner_energy tanner_flock.
From Flockproof Require tanner_nonsmooth tanner_graph tanner_saturated tanner_trees tanner_paths tanner2_motion tanner2_facts tanner2_examples
  tanner2_switching tanner2_filippov.
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

(* tanner2.thm1a clause 1, tanner2.thm1b clause 1, tanner2.thm1c clause 2, tanner2.cor3 clause 1 *)
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

(* ---- the theorems prove them ---- *)
(* V_ij and V_ji are equal, so their derivatives are at every distance: one function for each pair *)
Import tanner2_filippov(both, both_sym, both_slope, equal_rates).
Lemma both_V (V : nat -> nat -> R -> R) i j s : (forall i j s, V i j s = V j i s) -> both V i j s = V i j s.
Proof. intros E. unfold both. destruct (Nat.leb i j); [reflexivity|apply E]. Qed.
Lemma both_derive (V V' : nat -> nat -> R -> R) i j s : (forall i j s, V i j s = V j i s) ->
  is_derive (V i j) s (V' i j s) -> is_derive (V j i) s (V' j i s) -> is_derive (both V i j) s (both V' i j s).
Proof.
  intros VS A B. rewrite (both_slope V V' i j s VS A B). apply (is_derive_ext (V i j)); [intros; symmetry; now apply both_V|exact A].
Qed.
Lemma both_law n adj V V' r v i : undirected adj -> (forall i j s, V i j s = V j i s) ->
  (forall i j s, (i < n)%nat -> (j < n)%nat -> adj i j = true -> 0 < s -> is_derive (V i j) s (V' i j s)) ->
  (i < n)%nat -> apart_at n adj r ->
  (forall j, (j < n)%nat -> pull adj (both V') r i j = pull adj V' r i j) /\ gradV n adj (both V') r i = gradV n adj V' r i /\ law4 n adj (both V') r v i = law4 n adj V' r v i.
Proof.
  intros S VS D Hi A. assert (Q : forall j, (j < n)%nat -> pull adj (both V') r i j = pull adj V' r i j).
  { intros j Hj. unfold pull. destruct (adj i j) eqn:E; [|reflexivity]. pose proof (tanner_flock.norm_neq _ _ (A i j Hi Hj E)) as N. unfold norm in N.
    rewrite (both_slope V V' i j _ VS); [reflexivity|now apply D|]. apply D; try assumption. now rewrite S. }
  split; [exact Q|]. assert (G : gradV n adj (both V') r i = gradV n adj V' r i) by (apply Csum_ext; exact Q).
  split; [exact G|]. unfold law4. now rewrite G.
Qed.
Lemma pull_is adj V' r i j : pull adj V' r i j = pair_grad adj V' r i j.
Proof. unfold pull, pair_grad, w, grad, norm. destruct (adj i j); apply injective_projections; cbn; ring. Qed.
Lemma gradV_is n adj V' r i : gradV n adj V' r i = grad_i n adj V' r i.
Proof. apply Csum_ext. intros j _. apply pull_is. Qed.
Lemma law4_is n adj V' r v i : law4 n adj V' r v i = control4 n adj V' r v i.
Proof.
  unfold law4, control4. rewrite gradV_is. f_equal. f_equal. apply Csum_ext. intros j _. unfold w.
  destruct (adj i j); apply injective_projections; cbn; ring.
Qed.
Lemma energy6_is n adj V r v : energy6 n adj V r v = Wenergy n adj V r v.
Proof.
  unfold energy6, Wenergy. f_equal. apply Sum_ext. intros i _. f_equal.
  - unfold V_i. apply Sum_ext. intros j _. unfold w, norm. destruct (adj i j); ring.
  - rewrite <- norm_sqr. unfold norm. ring.
Qed.
Lemma moves_is n adj V' r v : motion n adj V' r v -> tanner2_motion.distinct n adj (fun i => r i 0) /\
  forall t, 0 <= t -> tanner2_motion.moves n adj V' r v t.
Proof.
  intros [D M]. split; [exact D|]. intros t Ht. split; [intros i Hi; now apply M|]. intros A i Hi.
  rewrite <- law4_is. now apply M.
Qed.
(* the potentials of the theorems: V_ij and V_ji are one function, and so are their derivatives *)
Definition potentials_one n (adj : graph) (V V' : nat -> nat -> R -> R) := (forall i j, V i j = V j i) /\ (forall i j, V' i j = V' j i) /\
  forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true ->
    (forall s, 0 < s -> is_derive (V i j) s (V' i j s) /\ continuity_pt (V' i j) s /\ 0 <= V i j s) /\
    (forall c, exists d, 0 < d /\ forall s, 0 < s < d -> c < V i j s) /\ (forall c, exists D, forall s, D < s -> c < V i j s).
Lemma slopes_of n adj V V' : potentials n adj V V' ->
  forall i j s, (i < n)%nat -> (j < n)%nat -> adj i j = true -> 0 < s -> is_derive (V i j) s (V' i j s).
Proof. intros [_ P] i j s Hi Hj A Hs. now apply (P i j Hi Hj A). Qed.
Lemma one_of n adj V V' : undirected adj -> potentials n adj V V' -> potentials_one n adj (both V) (both V').
Proof.
  intros S [VS P]. split; [exact (both_sym V)|]. split; [exact (both_sym V')|]. intros i j Hi Hj A.
  assert (A' : adj j i = true) by (now rewrite S). destruct (P i j Hi Hj A) as (P1 & P2 & P3). destruct (P j i Hj Hi A') as (Q1 & _).
  split; [|split].
  - intros s Hs. rewrite (both_V V) by exact VS. split; [|split; [|now apply P1]].
    + apply both_derive; [exact VS|now apply P1|now apply Q1].
    + unfold both. destruct (Nat.leb i j); [now apply P1|now apply Q1].
  - intros c. destruct (P2 c) as [d [Hd B]]. exists d. split; [exact Hd|]. intros s Hs. rewrite (both_V V) by exact VS. now apply B.
  - intros c. destruct (P3 c) as [D B]. exists D. intros s Hs. rewrite (both_V V) by exact VS. now apply B.
Qed.
Lemma motion_both n adj V V' r v : undirected adj -> potentials n adj V V' -> motion n adj V' r v -> motion n adj (both V') r v.
Proof.
  intros S P [D M]. split; [exact D|]. intros t i Ht Hi. destruct (M t i Ht Hi) as [A B]. split; [exact A|]. intros Ap.
  destruct (both_law n adj V V' (fun i => r i t) (fun i => v i t) i S (proj1 P) (slopes_of n adj V V' P) Hi Ap) as (_ & _ & ->). now apply B.
Qed.
Lemma energy_both n adj V r v : (forall i j s, V i j s = V j i s) -> energy6 n adj (both V) r v = energy6 n adj V r v.
Proof.
  intros VS. unfold energy6. f_equal. apply Sum_ext. intros i _. f_equal. apply Sum_ext. intros j _. now rewrite (both_V V) by exact VS.
Qed.
Lemma potentials_are n adj V V' : potentials_one n adj V V' -> (forall i j, V i j = V j i) /\ (forall i j, V' i j = V' j i) /\
  (forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> potential (V i j) (V' i j)) /\
  (forall i j s, (i < n)%nat -> (j < n)%nat -> adj i j = true -> 0 < s -> continuity_pt (V' i j) s).
Proof.
  intros (A & B & C). split; [exact A|]. split; [exact B|]. split.
  - intros i j Hi Hj L. destruct (C i j Hi Hj L) as (P & Q). split; [|exact Q]. intros s Hs. split; now apply P.
  - intros i j s Hi Hj L Hs. now apply (C i j Hi Hj L).
Qed.
Lemma zero_is (z : R -> C) : (forall e, 0 < e -> exists T, 0 <= T /\ forall t, T <= t -> norm (z t) < e) -> to_zero z.
Proof. intros H e He. destruct (H e He) as [T [_ P]]. now exists T. Qed.

Lemma thm1a_one : forall n adj V V' r v, simple_graph adj -> strongly_connected n adj -> potentials_one n adj V V' ->
  motion n adj V' r v -> forall i j, (i < n)%nat -> (j < n)%nat -> to_zero (fun t => v i t - v j t)%C.
Proof.
  intros n adj V V' r v [S NL] SC P M i j Hi Hj. destruct (moves_is _ _ _ _ _ M) as [D W].
  destruct (potentials_are _ _ _ _ P) as (A & B & C & K). apply zero_is.
  now apply (tanner2_motion.motions_agree n adj V V' r v S NL A B C D ltac:(lia) SC K W).
Qed.
Lemma apart_of n adj V V' r v : simple_graph adj -> potentials_one n adj V V' -> motion n adj V' r v ->
  forall t, 0 <= t -> apart_at n adj (fun i => r i t).
Proof.
  intros [S NL] P M t Ht i j Hi Hj L E. destruct (moves_is _ _ _ _ _ M) as [D W].
  destruct (potentials_are _ _ _ _ P) as (A & B & C & K).
  destruct (tanner2_motion.linked_apart n adj V V' r v S NL A B C D) as [d [Hd Q]].
  specialize (Q (t + 1) (fun s Hs => W s (proj1 Hs)) t i j ltac:(lra) Hi Hj L). rewrite E in Q.
  replace (r j t - r j t)%C with (RtoC 0) in Q by ring. unfold norm in Q. rewrite Cmod_0 in Q. lra.
Qed.
Lemma apart_always n adj V V' r v : simple_graph adj -> potentials n adj V V' -> motion n adj V' r v ->
  forall t, 0 <= t -> apart_at n adj (fun i => r i t).
Proof.
  intros S P M t Ht. destruct S as [S NL].
  exact (apart_of n adj (both V) (both V') r v (conj S NL) (one_of n adj V V' S P) (motion_both n adj V V' r v S P M) t Ht).
Qed.
Lemma thm1a_proved : thm1a.
Proof.
  intros n adj V V' r v S SC P M. exact (thm1a_one n adj (both V) (both V') r v S SC (one_of n adj V V' (proj1 S) P) (motion_both n adj V V' r v (proj1 S) P M)).
Qed.
Lemma thm1b_proved : thm1b.
Proof. intros n adj V V' r v S _ P M t Ht. now apply (apart_always n adj V V' r v). Qed.
Lemma cor3_proved : cor3.
Proof. intros n adj V V' r v S K P M t i j Ht Hi Hj N. apply (apart_always n adj V V' r v S P M t Ht); auto. Qed.
Lemma thm1c_2_one : forall n adj V V' r v, simple_graph adj -> strongly_connected n adj -> potentials_one n adj V V' ->
  motion n adj V' r v -> forall i, (i < n)%nat -> to_zero (fun t => gradV n adj V' (fun j => r j t) i).
Proof.
  intros n adj V V' r v [S NL] SC P M i Hi e He. destruct (moves_is _ _ _ _ _ M) as [D W].
  destruct (potentials_are _ _ _ _ P) as (A & B & C & K).
  destruct (tanner_trees.forces_vanish n adj V V' r v S NL A B C D ltac:(lia) SC K W e He) as [T [_ Q]].
  exists T. intros t Ht. rewrite gradV_is. now apply Q.
Qed.
(* an edge of a connected graph without closed paths is a bridge *)
Lemma walk_path n adj j l : forall i, tanner_paths.walk n adj j l i -> undirected adj -> path_from n adj j l /\ last l j = i.
Proof.
  induction l as [|k l IH] in j |- *; intros i W S; [split; [exact I|exact W]|].
  destruct W as [[Hk [Hj A]] W]. destruct (IH k i W S) as [P L]. split.
  - split; [exact Hj|]. split; [|exact P]. rewrite S. exact A.
  - rewrite <- L. destruct l as [|m l]; [reflexivity|]. clear. revert m. induction l as [|p l IH]; intros m; [reflexivity|exact (IH p)].
Qed.
Lemma path_sub n adj a b l : forall i, path_from n (tanner_trees.without adj a b) i l -> path_from n adj i l.
Proof.
  induction l as [|k l IH]; intros i H; [exact I|]. destruct H as (Hk & A & P). split; [exact Hk|]. split; [|now apply IH].
  unfold tanner_trees.without in A. now apply Bool.andb_true_iff in A.
Qed.
Lemma tree_is n adj : simple_graph adj -> is_tree n adj -> tanner_trees.tree n adj.
Proof.
  intros [S NL] [SC Ac]. split; [exact SC|]. intros a b (Ha & Hb & A) SC'.
  assert (S' : undirected (tanner_trees.without adj a b)).
  { intros i j. unfold tanner_trees.without. rewrite (S i j). f_equal. f_equal.
    destruct (Nat.eqb i a), (Nat.eqb j b), (Nat.eqb i b), (Nat.eqb j a); reflexivity. }
  destruct (tanner_paths.joined n _ a b SC' Ha Hb) as [l0 [W0 _]].
  destruct (tanner_paths.simple_walk n _ b l0 a W0) as [l [W N]].
  destruct (walk_path n _ a l b W S') as [P L].
  assert (L2 : (2 <= length l)%nat).
  { destruct l as [|k [|k' l]]; [| |cbn; lia].
    - cbn in L. subst. rewrite NL in A. discriminate.
    - cbn in L. subst k. destruct P as (_ & P & _). unfold tanner_trees.without in P.
      rewrite !Nat.eqb_refl in P. rewrite Bool.andb_false_r in P. discriminate. }
  specialize (Ac a l Ha N (path_sub _ _ _ _ _ _ P) L2). rewrite L, S in Ac. rewrite S in A. rewrite A in Ac || (rewrite S in A; rewrite A in Ac). discriminate.
Qed.
Lemma cor1_4_one : forall n adj V V' r v (d : nat -> nat -> R), simple_graph adj -> is_tree n adj -> potentials_one n adj V V' ->
  motion n adj V' r v ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> 0 < d i j /\ (forall s, 0 < s -> V' i j s = 0 -> s = d i j)) ->
  forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> is_lim (fun t => Cmod (r i t - r j t)%C) p_infty (d i j).
Proof.
  intros n adj V V' r v d S T P M U i j Hi Hj L. pose proof (tree_is n adj S T) as T'. destruct T as [SC _]. destruct S as [S NL].
  destruct (moves_is _ _ _ _ _ M) as [D W]. destruct (potentials_are _ _ _ _ P) as (A & B & C & K).
  pose proof (tanner_trees.tree_distances n adj V V' r v S NL A B C D ltac:(lia) SC K W T' d) as Q.
  apply is_lim_spec. intros e. destruct (Q (fun i j s Hi Hj L => proj2 (U i j Hi Hj L) s) i j Hi Hj L e (cond_pos e)) as [T0 [_ Q']].
  exists T0. intros t Ht. apply Q'. lra.
Qed.
Lemma cor1_5_one : forall n adj V V' r v, simple_graph adj -> is_tree n adj -> potentials_one n adj V V' ->
  motion n adj V' r v -> forall i j, (i < n)%nat -> (j < n)%nat -> to_zero (fun t => pull adj V' (fun k => r k t) i j).
Proof.
  intros n adj V V' r v S T P M i j Hi Hj. pose proof (tree_is n adj S T) as T'. destruct T as [SC _]. destruct S as [S NL].
  destruct (moves_is _ _ _ _ _ M) as [D W]. destruct (potentials_are _ _ _ _ P) as (A & B & C & K).
  destruct (adj i j) eqn:L.
  - apply zero_is. intros e He.
    destruct (tanner_trees.tree_forces_vanish n adj V V' r v S NL A B C D ltac:(lia) SC K W T' i j Hi Hj L e He) as [T0 [H0 Q]].
    exists T0. split; [exact H0|]. intros t Ht. specialize (Q t Ht). unfold pull. rewrite L. exact Q.
  - intros e He. exists 0. intros t _. unfold pull. rewrite L, Cmod_0. exact He.
Qed.
Lemma cor1_6_one : forall n adj (V V' : nat -> nat -> R -> R) r (d : nat -> nat -> R), simple_graph adj -> is_tree n adj ->
  (forall i j, V' i j = V' j i) ->
  (forall i j s, (i < n)%nat -> (j < n)%nat -> adj i j = true -> 0 < s -> is_derive (V i j) s (V' i j s) /\ (V' i j s = 0 -> s = d i j)) ->
  apart_at n adj r -> (forall i, (i < n)%nat -> gradV n adj V' r i = 0%C) ->
  forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> Cmod (r i - r j)%C = d i j.
Proof.
  intros n adj V V' r d S T VS U D F i j Hi Hj L. pose proof (tree_is n adj S T) as T'. destruct S as [S NL].
  apply (tanner_trees.tree_equilibrium n adj V' d r (RtoC 0) S VS T'); try assumption.
  - intros. now apply (U i0 j0 s).
  - intros k Hk. unfold control4. rewrite <- gradV_is, (F k Hk).
    rewrite (Csum_ext n _ (fun _ => RtoC 0)) by (intros; apply injective_projections; cbn; ring).
    apply injective_projections; unfold Csum; cbn; clear; induction n; cbn in *; lra.
Qed.
Lemma thm1c_2_proved : thm1c_2.
Proof.
  intros n adj V V' r v S SC P M i Hi e He.
  destruct (thm1c_2_one n adj (both V) (both V') r v S SC (one_of n adj V V' (proj1 S) P) (motion_both n adj V V' r v (proj1 S) P M) i Hi e He) as [T Q].
  exists (Rmax 0 T). intros t Ht. pose proof (Rmax_l 0 T). pose proof (Rmax_r 0 T). specialize (Q t ltac:(lra)).
  destruct (both_law n adj V V' (fun i => r i t) (fun i => v i t) i (proj1 S) (proj1 P) (slopes_of n adj V V' P) Hi) as (_ & <- & _); [|exact Q].
  apply (apart_always n adj V V' r v S P M). lra.
Qed.
Lemma cor1_4_proved : cor1_4.
Proof.
  intros n adj V V' r v d S T P M U i j Hi Hj L.
  refine (cor1_4_one n adj (both V) (both V') r v d S T (one_of n adj V V' (proj1 S) P) (motion_both n adj V V' r v (proj1 S) P M) _ i j Hi Hj L).
  intros a b Ha Hb A. destruct (U a b Ha Hb A) as [U1 U2]. split; [exact U1|]. intros s Hs Z. apply (U2 s Hs).
  rewrite <- Z. symmetry. pose proof (slopes_of n adj V V' P) as D. apply (both_slope V V'); [exact (proj1 P)|now apply D|].
  apply D; try assumption. destruct S as [S _]. now rewrite S.
Qed.
Lemma cor1_5_proved : cor1_5.
Proof.
  intros n adj V V' r v S T. split.
  - intros O y HO Z. exact (tanner_graph.tree_columns n adj O y (proj1 S) (tree_is n adj S T) HO Z).
  - intros P M i j Hi Hj e He.
    destruct (cor1_5_one n adj (both V) (both V') r v S T (one_of n adj V V' (proj1 S) P) (motion_both n adj V V' r v (proj1 S) P M) i j Hi Hj e He) as [T0 Q].
    exists (Rmax 0 T0). intros t Ht. pose proof (Rmax_l 0 T0). pose proof (Rmax_r 0 T0). specialize (Q t ltac:(lra)).
    destruct (both_law n adj V V' (fun i => r i t) (fun i => v i t) i (proj1 S) (proj1 P) (slopes_of n adj V V' P) Hi) as (Q2 & _).
    + apply (apart_always n adj V V' r v S P M). lra.
    + now rewrite <- (Q2 j Hj).
Qed.
Lemma cor1_6_proved : cor1_6.
Proof.
  intros n adj V V' r d S T VS U A F. pose proof S as [Sy _].
  assert (D : forall i j s, (i < n)%nat -> (j < n)%nat -> adj i j = true -> 0 < s -> is_derive (V i j) s (V' i j s)) by (intros; now apply U).
  assert (D' : forall i j s, (i < n)%nat -> (j < n)%nat -> adj i j = true -> 0 < s -> is_derive (V j i) s (V' j i s)) by (intros; apply U; try assumption; now rewrite Sy).
  apply (cor1_6_one n adj (both V) (both V') r d S T (both_sym V')).
  - intros i j s Hi Hj L Hs. split; [apply both_derive; [exact VS|now apply D|now apply D']|].
    intros Z. apply (U i j s Hi Hj L Hs). rewrite <- Z. symmetry. apply (both_slope V V'); [exact VS|now apply D|now apply D'].
  - exact A.
  - intros i Hi. destruct (both_law n adj V V' r (fun _ => RtoC 0) i Sy VS D Hi A) as (_ & -> & _). now apply F.
Qed.
Lemma lem1_2_proved : lem1_2.
Proof. intros V V' R0 s H _ Hs N. apply (tanner_saturated.saturated_regular V V'); try assumption; intros; now apply H. Qed.
Lemma lem1_3_proved : lem1_3.
Proof. intros V V' R0 H HR Hc. apply (tanner_saturated.negative_regular V V'); try assumption; intros; now apply H. Qed.
Lemma lem1_4_proved : lem1_4.
Proof. intros V V' R0 w H HR Hc. apply (tanner_saturated.derivatives_at_R V V'); try assumption; intros; now apply H. Qed.
Lemma lem2_2_proved : lem2_2.
Proof. intros V V' R0 z H HR Hc. apply (tanner_nonsmooth.lemma2_fails V V' R0 (V' R0)); try assumption; try reflexivity; try (intros; now apply H). Qed.
Lemma bound_v_one : forall n adj V V' r v c, simple_graph adj -> potentials_one n adj V V' -> apart_at n adj r ->
  energy6 n adj V r v <= c -> forall i, (i < n)%nat -> Cmod (v i) ^ 2 <= 2 * c /\ Cmod (v i) <= sqrt (2 * c).
Proof.
  intros n adj V V' r v c S P D H i Hi. destruct (potentials_are _ _ _ _ P) as (A & B & C & K). rewrite energy6_is in H.
  pose proof (tanner_flock.speed_bound_norm n adj V V' C r v D i c Hi H) as Q. split; [|exact Q].
  pose proof (Cmod_ge_0 (v i)) as G. fold (norm (v i)) in *.
  assert (0 <= 2 * c). { destruct (Rle_or_lt 0 (2 * c)) as [?|?]; [assumption|]. pose proof (tanner_flock.energy_ge0 n adj V V' C r v D). lra. }
  rewrite <- (pow2_sqrt (2 * c)) by assumption. apply pow_incr. unfold norm in *. lra.
Qed.

Lemma bound_r_one : forall n adj V V' r v c D, (2 <= n)%nat -> simple_graph adj -> strongly_connected n adj -> potentials_one n adj V V' ->
  apart_at n adj r -> energy6 n adj V r v <= c ->
  (forall i j s, (i < n)%nat -> (j < n)%nat -> adj i j = true -> 0 < s -> V i j s <= c -> s <= D) ->
  forall i j, (i < n)%nat -> (j < n)%nat -> Cmod (r i - r j)%C <= (INR n - 1) * D.
Proof.
  intros n adj V V' r v c D Hn [S NL] SC P NC H B i j Hi Hj. destruct (potentials_are _ _ _ _ P) as (A & _ & C & K). rewrite energy6_is in H.
  refine (tanner_paths.bound_r_corrected n adj V V' r v c D ltac:(lia) S NL SC A C NC H _ B i j Hi Hj).
  assert (E : exists a b, arc n adj a b).
  { pose proof (SC 0%nat 1%nat ltac:(lia) ltac:(lia)) as Q. apply clos_rt_rt1n in Q. inversion Q; eauto. }
  destruct E as (b & a & Hb & Ha & L). pose proof (tanner_flock.pair_bound n adj V V' C r v NC S A NL a b Ha Hb L) as Q.
  pose proof (tanner_flock.norm_neq _ _ (NC a b Ha Hb L)) as N.
  pose proof (B a b (norm (r a - r b)%C) Ha Hb L N ltac:(lra)). lra.
Qed.
Lemma bound_v_proved : bound_v.
Proof.
  intros n adj V V' r v c S P A H. apply (bound_v_one n adj (both V) (both V') r v c S (one_of n adj V V' (proj1 S) P) A). now rewrite (energy_both n adj V r v (proj1 P)).
Qed.
Lemma bound_r_proved : bound_r.
Proof.
  intros n adj V V' r v c D Hn S SC P A H B. apply (bound_r_one n adj (both V) (both V') r v c D Hn S SC (one_of n adj V V' (proj1 S) P) A).
  - now rewrite (energy_both n adj V r v (proj1 P)).
  - intros i j s Hi Hj L Hs. rewrite (both_V V i j s (proj1 P)). now apply B.
Qed.
Lemma form_is n adj x : Sum n (fun i => x i * Sum n (fun j => lap n adj i j * x j)) = qform n (lap n adj) x.
Proof. reflexivity. Qed.
Lemma eq9_one : forall n adj (V V' : nat -> nat -> R -> R) r v t, simple_graph adj -> (forall i j, V' i j = V' j i) ->
  (forall i j s, (i < n)%nat -> (j < n)%nat -> adj i j = true -> 0 < s -> is_derive (V i j) s (V' i j s)) ->
  apart_at n adj (fun i => r i t) ->
  (forall i, (i < n)%nat -> is_velocity (r i) t (v i t) /\ is_velocity (v i) t (law4 n adj V' (fun i => r i t) (fun i => v i t) i)) ->
  let form x := Sum n (fun i => x i * Sum n (fun j => lap n adj i j * x j)) in
  is_derive (fun s => energy6 n adj V (fun i => r i s) (fun i => v i s)) t (- form (fun i => fst (v i t)) - form (fun i => snd (v i t))).
Proof.
  intros n adj V V' r v t [S NL] VS D A U form.
  destruct (tanner_energy.eq9 n adj V V' r v t S VS) as (Q & E & _).
  - intros i Hi. now apply U.
  - exact A.
  - intros i j Hi Hj L. apply D; try assumption. apply tanner_flock.norm_neq. now apply A.
  - intros i Hi. rewrite <- law4_is. now apply U.
  - apply (is_derive_ext (fun s => Wenergy n adj V (fun i => r i s) (fun i => v i s))); [intros; symmetry; apply energy6_is|].
    rewrite E in Q. unfold form. rewrite !form_is. replace (- _ - _) with (- (qform n (lap n adj) (fun i => fst (v i t)) + qform n (lap n adj) (fun i => snd (v i t)))) by ring. exact Q.
Qed.
Lemma eq9_proved : eq9.
Proof.
  intros n adj V V' r v t S VS D A U form.
  apply (is_derive_ext (fun s => energy6 n adj (both V) (fun i => r i s) (fun i => v i s))); [intros; now apply energy_both|].
  apply (eq9_one n adj (both V) (both V') r v t S (both_sym V')); [|exact A|].
  - intros i j s Hi Hj L Hs. apply both_derive; [exact VS|now apply D|]. apply D; try assumption. destruct S as [S _]. now rewrite S.
  - intros i Hi. destruct (U i Hi) as [U1 U2]. split; [exact U1|].
    destruct (both_law n adj V V' (fun i => r i t) (fun i => v i t) i (proj1 S) VS D Hi A) as (_ & _ & ->). exact U2.
Qed.
Lemma by_distance_is r R0 i j : by_distance r R0 i j = tanner2_facts.near r R0 i j.
Proof. unfold by_distance, tanner2_facts.near, norm. destruct (Nat.eqb i j); reflexivity. Qed.
Lemma energy11_is n V R0 r v : energy11 n V R0 r v = tanner2_facts.Qsat n V R0 r v.
Proof.
  unfold energy11, tanner2_facts.Qsat. f_equal. apply Sum_ext. intros i _. f_equal.
  rewrite <- norm_sqr. unfold norm. ring.
Qed.
Lemma Q_1_one : forall n (V : nat -> nat -> R -> R) R0 r v, (forall i j, V i j = V j i) ->
  energy6 n (by_distance r R0) V r v +
    Sum n (fun i => Sum n (fun j => if Nat.ltb i j then (if by_distance r R0 i j then 0 else V i j R0) else 0)) = energy11 n V R0 r v.
Proof.
  intros n V R0 r v VS. rewrite energy6_is, energy11_is, <- (tanner2_facts.Q_two_forms n V R0 r v VS). f_equal.
  - unfold Wenergy. f_equal. apply Sum_ext. intros i _. f_equal. apply Sum_ext. intros j _. unfold w. now rewrite by_distance_is.
  - (* pairs i < j or j < i *)
    assert (E : forall F : nat -> nat -> R, Sum n (fun i => Sum n (fun j => if Nat.ltb i j then F i j else 0)) =
      Sum n (fun j => Sum j (fun i => F i j))).
    { intros F. assert (G : forall m, Sum m (fun i => Sum m (fun j => if Nat.ltb i j then F i j else 0)) = Sum m (fun j => Sum j (fun i => F i j))).
      { induction m as [|m IH]; [reflexivity|]. cbn [Sum]. rewrite <- IH.
        rewrite (Sum_ext m (fun i => Sum m (fun j => if Nat.ltb i j then F i j else 0) + (if Nat.ltb i m then F i m else 0))
          (fun i => Sum m (fun j => if Nat.ltb i j then F i j else 0) + F i m)) by (intros i Hi; destruct (Nat.ltb_spec i m); [reflexivity|lia]).
        assert (Z : Sum m (fun j => if Nat.ltb m j then F m j else 0) = 0).
        { clear IH. assert (K : forall q, (q <= m)%nat -> Sum q (fun j => if Nat.ltb m j then F m j else 0) = 0).
          { induction q as [|q IHq]; intros Hq; [reflexivity|]. cbn [Sum]. rewrite IHq by lia. destruct (Nat.ltb_spec m q); [lia|ring]. }
          apply K. lia. }
        rewrite Z, Nat.ltb_irrefl.
        assert (A : forall (p q : nat -> R) k, Sum k (fun i => p i + q i) = Sum k p + Sum k q).
        { clear. induction k as [|k IH]; cbn [Sum]; [ring|rewrite IH; ring]. }
        rewrite A. ring. }
      apply G. }
    rewrite E. apply Sum_ext. intros j _. apply Sum_ext. intros i _. unfold w. rewrite <- by_distance_is.
    replace (by_distance r R0 j i) with (by_distance r R0 i j).
    + rewrite (VS j i). destruct (by_distance r R0 i j); ring.
    + unfold by_distance. rewrite (Nat.eqb_sym j i). replace (r j - r i)%C with (- (r i - r j))%C by ring. now rewrite Cmod_opp.
Qed.
Lemma Qdot_one : forall n V V' R0 r v t, 0 < R0 -> (forall i j, V' i j = V' j i) -> (forall i j s, 0 < s -> is_derive (V i j) s (V' i j s)) ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> i <> j -> r i t <> r j t /\ Cmod (r i t - r j t)%C <> R0) ->
  let adj := by_distance (fun i => r i t) R0 in
  (forall i, (i < n)%nat -> is_velocity (r i) t (v i t) /\ is_velocity (v i) t (law4 n adj V' (fun i => r i t) (fun i => v i t) i)) ->
  let form x := Sum n (fun i => x i * Sum n (fun j => lap n adj i j * x j)) in
  is_derive (fun s => energy11 n V R0 (fun i => r i s) (fun i => v i s)) t (- form (fun i => fst (v i t)) - form (fun i => snd (v i t))).
Proof.
  intros n V V' R0 r v t HR VS D A adj U form.
  assert (K : forall i, grad_i n adj V' (fun i => r i t) i = grad_i n (tanner2_facts.near (fun i => r i t) R0) V' (fun i => r i t) i).
  { intros i. apply Csum_ext. intros j _. unfold pair_grad, w. unfold adj. now rewrite by_distance_is. }
  pose proof (tanner2_facts.Q_rate n V V' R0 r v t HR VS D A (fun i Hi => proj1 (U i Hi))) as Q.
  apply (is_derive_ext (fun s => tanner2_facts.Qsat n V R0 (fun i => r i s) (fun i => v i s))); [intros; symmetry; apply energy11_is|].
  assert (E : forall x, qform n (lap n adj) x = qform n (lap n (tanner2_facts.near (fun i => r i t) R0)) x).
  { intros x. unfold qform. apply Sum_ext. intros i _. f_equal. apply Sum_ext. intros j _. f_equal. unfold lap, deg, w.
    rewrite (Sum_ext n _ (w (tanner2_facts.near (fun i => r i t) R0) i)); [unfold w, adj; now rewrite by_distance_is|].
    intros k _. unfold w, adj. now rewrite by_distance_is. }
  unfold form. rewrite !form_is, !E.
  replace (- _ - _) with (- qform (2 * n) (kron2 (lap n (tanner2_facts.near (fun i => r i t) R0))) (stack (fun i => v i t)))
    by (rewrite tanner_energy.kron_split; ring).
  apply Q. intros i Hi. pose proof (proj2 (U i Hi)) as W. rewrite law4_is in W. unfold control4 in *. rewrite <- K.
  rewrite (Csum_ext n _ (fun j => RtoC (w adj i j) * (v i t - v j t))%C); [exact W|].
  intros j _. unfold w, adj. now rewrite by_distance_is.
Qed.
Lemma Q_1_proved : Q_1.
Proof.
  intros n V R0 r v VS. assert (E : energy11 n (both V) R0 r v = energy11 n V R0 r v).
  { unfold energy11. f_equal. apply Sum_ext. intros i _. f_equal. apply Sum_ext. intros j _. unfold saturate. now rewrite !(both_V V) by exact VS. }
  rewrite <- E, <- (energy_both n _ V r v VS), <- (Q_1_one n (both V) R0 r v (both_sym V)). f_equal.
  apply Sum_ext. intros i _. apply Sum_ext. intros j _. now rewrite (both_V V) by exact VS.
Qed.
(* pairs of agents have the potentials of the clause; elsewhere they are not asked for *)
Definition extended (n : nat) (V W : nat -> nat -> R -> R) (i j : nat) : R -> R :=
  if (Nat.ltb i n && Nat.ltb j n && negb (Nat.eqb i j))%bool then both V i j else W i j.
Lemma extended_in n V W i j : (i < n)%nat -> (j < n)%nat -> i <> j -> extended n V W i j = both V i j.
Proof.
  intros Hi Hj N. unfold extended. destruct (Nat.ltb_spec i n), (Nat.ltb_spec j n), (Nat.eqb_spec i j); cbn; try lia. reflexivity.
Qed.
Lemma extended_sym n V W : (forall i j, W i j = W j i) -> forall i j, extended n V W i j = extended n V W j i.
Proof.
  intros E i j. unfold extended. rewrite (Nat.eqb_sym j i), (Bool.andb_comm (Nat.ltb j n)). rewrite (both_sym V i j), (E i j). reflexivity.
Qed.
Lemma Qdot_proved : Qdot.
Proof.
  intros n V V' R0 r v t HR VS D A adj U form. set (W := fun (_ _ : nat) (s : R) => s). set (W' := fun (_ _ : nat) (_ : R) => 1).
  assert (E : forall i j s, (i < n)%nat -> (j < n)%nat -> i <> j -> extended n V W i j s = V i j s).
  { intros i j s Hi Hj N. rewrite extended_in by assumption. now apply both_V. }
  apply (is_derive_ext (fun s => energy11 n (extended n V W) R0 (fun i => r i s) (fun i => v i s))).
  { intros s. unfold energy11. f_equal. apply Sum_ext. intros i Hi. f_equal. apply Sum_ext. intros j Hj.
    destruct (Nat.eqb_spec i j) as [|N]; [reflexivity|]. unfold saturate. now rewrite !E. }
  apply (Qdot_one n (extended n V W) (extended n V' W') R0 r v t HR (extended_sym n V' W' (fun _ _ => eq_refl))).
  - intros i j s Hs. unfold extended. destruct (Nat.ltb_spec i n), (Nat.ltb_spec j n), (Nat.eqb_spec i j); cbn; try exact (D_id s).
    apply both_derive; [exact VS|now apply D|]. apply D; try assumption. now apply not_eq_sym.
  - exact A.
  - intros i Hi. destruct (U i Hi) as [U1 U2]. split; [exact U1|]. fold adj.
    replace (law4 n adj (extended n V' W') (fun i => r i t) (fun i => v i t) i) with (law4 n adj V' (fun i => r i t) (fun i => v i t) i); [exact U2|].
    unfold law4. f_equal. apply Csum_ext. intros j Hj. unfold pull. destruct (adj i j) eqn:L; [|reflexivity].
    assert (N : i <> j). { intros ->. unfold adj, by_distance in L. rewrite Nat.eqb_refl in L. discriminate. }
    rewrite extended_in by assumption. pose proof (tanner_flock.norm_neq _ _ (proj1 (A i j Hi Hj N))) as P. unfold norm in P.
    rewrite (both_slope V V' i j _ VS); [reflexivity|now apply D|]. apply D; try assumption. now apply not_eq_sym.
Qed.
Lemma L_4_proved : L_4.
Proof.
  intros n adj x S SC. split.
  - intros H. destruct n as [|n]; [exists 0; intros; lia|]. apply (paley_gradient.lap_kernel (Datatypes.S n) adj x ltac:(lia) SC). exact H.
  - intros [c Hc] i Hi. rewrite (Sum_ext n _ (fun j => lap n adj i j * c)) by (intros j Hj; now rewrite (Hc j Hj)).
    apply (paley_gradient.lap_ones n adj c i Hi).
Qed.
Lemma rangeB_1_proved : rangeB_1.
Proof.
  intros n adj O x [S NL] SC HO. destruct n as [|n].
  - split; [reflexivity|]. intros _. exists (fun _ => 0). intros; lia.
  - now apply (tanner_graph.range_B (Datatypes.S n) adj O x ltac:(lia) S NL HO SC).
Qed.
Lemma tends_is (z : nat -> C) (l : C) :
  (forall e, 0 < e -> exists M, forall m, (M <= m)%nat -> Cmod (z m - l)%C < e) -> tanner_trees.tends z l.
Proof.
  intros Q. split; apply is_lim_seq_spec; intros e; destruct (Q e (cond_pos e)) as [M W]; exists M; intros m Hm;
    specialize (W m Hm); pose proof (Rmax_Cmod (z m - l)%C) as G.
  - pose proof (Rmax_l (Rabs (fst (z m - l)%C)) (Rabs (snd (z m - l)%C))) as G1. eapply Rle_lt_trans; [exact G1|]. lra.
  - pose proof (Rmax_r (Rabs (fst (z m - l)%C)) (Rabs (snd (z m - l)%C))) as G1. eapply Rle_lt_trans; [exact G1|]. lra.
Qed.
Lemma eq7_3_one : forall n adj V V' c (r v : nat -> nat -> C) (r0 v0 : nat -> C), simple_graph adj -> potentials_one n adj V V' ->
  (forall m, apart_at n adj (r m) /\ energy6 n adj V (r m) (v m) <= c) ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> forall e, 0 < e -> exists M, forall m, (M <= m)%nat -> Cmod ((r m i - r m j) - (r0 i - r0 j))%C < e) ->
  (forall i, (i < n)%nat -> forall e, 0 < e -> exists M, forall m, (M <= m)%nat -> Cmod (v m i - v0 i)%C < e) ->
  apart_at n adj r0 /\ energy6 n adj V r0 v0 <= c.
Proof.
  intros n adj V V' c r v r0 v0 [S NL] P H R1 R2. destruct (potentials_are _ _ _ _ P) as (A & B & C & K).
  destruct (tanner_trees.Omega_closed n adj V V' c r v (fun i j => r0 i - r0 j)%C v0 S NL A C) as (q & Q1 & Q2 & Q3).
  - intros k. rewrite <- energy6_is. apply H.
  - intros i j Hi Hj. apply tends_is. now apply R1.
  - intros i Hi. apply tends_is. now apply R2.
  - assert (N : forall i j, (i < n)%nat -> (j < n)%nat -> (r0 i - r0 j)%C = (q i - q j)%C) by (intros; now apply Q1).
    split.
    + intros i j Hi Hj L E. apply (Q2 i j Hi Hj L). specialize (N i j Hi Hj). rewrite E in N.
      replace (q i) with (q i - q j + q j)%C by ring. rewrite <- N. ring.
    + rewrite energy6_is. replace (Wenergy n adj V r0 v0) with (Wenergy n adj V q v0); [exact Q3|].
      unfold Wenergy. f_equal. apply Sum_ext. intros i Hi. f_equal. unfold V_i. apply Sum_ext. intros j Hj. now rewrite (N i j Hi Hj).
Qed.
Lemma eq7_3_proved : eq7_3.
Proof.
  intros n adj V V' c r v r0 v0 S P H R1 R2. rewrite <- (energy_both n adj V r0 v0 (proj1 P)).
  apply (eq7_3_one n adj (both V) (both V') c r v r0 v0 S (one_of n adj V V' (proj1 S) P)); [|exact R1|exact R2].
  intros m. rewrite (energy_both n adj V (r m) (v m) (proj1 P)). apply H.
Qed.
Lemma L_5_proved : L_5.
Proof.
  intros n adj lam x S SC E (i & j & Hi & Hj & N). assert (Hn : (1 <= n)%nat) by lia.
  destruct (tanner2_facts.second_positive n adj Hn S SC) as (m & M0 & B).
  set (c := tanner2_facts.mean n x). pose proof (B _ (tanner2_facts.centred_sum n x Hn)) as Q. fold c in Q.
  rewrite <- (tanner2_facts.cor2_decomposition n adj x c S) in Q.
  assert (F : qform n (lap n adj) x = lam * Sum n (fun i => x i ^ 2)).
  { unfold qform. rewrite <- Sum_scal. apply Sum_ext. intros k Hk. rewrite (E k Hk). ring. }
  assert (P : 0 < Sum n (fun i => (x i - c) ^ 2)).
  { assert (G : forall k, (k < n)%nat -> (x k - c) ^ 2 <= Sum n (fun i => (x i - c) ^ 2)).
    { intros k Hk. apply (Sum_term_le n (fun i => (x i - c) ^ 2) k); [intros; apply pow2_ge_0|exact Hk]. }
    pose proof (G i Hi). pose proof (G j Hj). apply Rnot_le_lt. intros Le. apply N.
    pose proof (pow2_ge_0 (x i - c)). pose proof (pow2_ge_0 (x j - c)). assert (x i - c = 0) by nra. assert (x j - c = 0) by nra. lra. }
  assert (P2 : 0 <= Sum n (fun i => x i ^ 2)) by (apply Sum_ge0; intros; apply pow2_ge_0).
  rewrite F in Q. assert (0 < m * Sum n (fun i => (x i - c) ^ 2)) by now apply Rmult_lt_0_compat. nra.
Qed.
Lemma rate_3_proved : rate_3.
Proof.
  intros n adj lam v Hn [S NL] SC B M dev t Ht. assert (n1 : (1 <= n)%nat) by lia.
  set (z := fun (i : nat) (s : R) => RtoC (v i s)).
  assert (Mz : forall t i, 0 <= t -> (i < n)%nat -> is_velocity (z i) t (- Csum n (fun j => RtoC (w adj i j) * (z i t - z j t)))%C).
  { intros s i Hs Hi. split.
    - eapply D_eq; [apply (M s i Hs Hi)|]. cbn. f_equal. apply Sum_ext. intros j _. unfold w. destruct (adj i j); ring.
    - eapply D_eq; [apply (D_const 0)|]. cbn. rewrite (Sum_zero n); [ring|]. intros; ring. }
  assert (E : forall s, dev s = tanner2_facts.deviation n (fun i => z i s)).
  { intros s. unfold dev, tanner2_facts.deviation. f_equal. rewrite tanner2_facts.deviation_axes. unfold z, tanner2_facts.mean. cbn [RtoC fst snd].
    rewrite (Sum_zero n (fun i => (0 - _) ^ 2)); [ring|]. intros i _. rewrite Sum_0. ring. }
  rewrite !E. exact (proj1 (tanner2_facts.alignment_rate n adj lam z n1 S Mz) B t Ht).
Qed.
Lemma clarke2_is f x w l : clarke_dd2 f x w l <-> tanner_saturated.clarke2 f x w l.
Proof. reflexivity. Qed.
Lemma lem2_3_proved : lem2_3.
Proof.
  intros V V' R0 ri rj z H HR Hc At.
  apply (tanner_saturated.plane_gradient V V' R0 (V' R0) ri rj HR); try assumption; try reflexivity; intros; now apply H.
Qed.

(* ---- more clauses, stated before their theorems were looked at ---- *)
(* Definition 3 whole: V_ij attains its unique minimum, at d_ij *)
Definition def3 n (adj : graph) V V' (d : nat -> nat -> R) := potentials n adj V V' /\
  forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> 0 < d i j /\ forall s, 0 < s -> s <> d i j -> V i j (d i j) < V i j s.
Definition form n (adj : graph) (x : nat -> R) : R := Sum n (fun i => x i * Sum n (fun j => lap n adj i j * x j)).
(* lambda_2: the least value of the form on unit vectors normal to 1, and there an eigenvector *)
Definition lambda2 n (adj : graph) (lam : R) := (forall x, Sum n x = 0 -> lam * Sum n (fun i => x i ^ 2) <= form n adj x) /\
  exists x, Sum n x = 0 /\ 0 < Sum n (fun i => x i ^ 2) /\ forall i, (i < n)%nat -> Sum n (fun j => lap n adj i j * x j) = lam * x i.
(* the rate of W at t along a motion *)
Definition Wdot n adj V (r v : nat -> R -> C) t (w : R) := is_derive (fun s => energy6 n adj V (fun i => r i s) (fun i => v i s)) t w.

(* tanner2.L clause 1: for any two orientations (and orders of the edges); the entries are those of lap *)
Definition L_1 : Prop := forall n adj O O', simple_graph adj -> tanner_graph.oriented n adj O -> tanner_graph.oriented n adj O' ->
  forall k m, (k < n)%nat -> (m < n)%nat ->
  lsum O (fun f => inc k f * inc m f) = lsum O' (fun f => inc k f * inc m f) /\ lsum O (fun f => inc k f * inc m f) = lap n adj k m.
(* tanner2.L clause 2 *)
Definition L_2 : Prop := forall n adj O, simple_graph adj -> tanner_graph.oriented n adj O ->
  let L k m := lsum O (fun f => inc k f * inc m f) in
  (forall k m, (k < n)%nat -> (m < n)%nat -> L k m = L m k) /\ (forall x, 0 <= Sum n (fun k => x k * Sum n (fun m => L k m * x m))).
(* tanner2.S_config clause 1, refuted: the printed statement with all the hypotheses of Theorem 1 *)
Definition S_config_1 : Prop := ~ forall n adj V V' d r v t, simple_graph adj -> strongly_connected n adj -> def3 n adj V V' d ->
  motion n adj V' r v -> 0 <= t -> Wdot n adj V r v t 0 -> (forall i j, (i < n)%nat -> (j < n)%nat -> v i t = v j t) ->
  forall i j, (i < n)%nat -> (j < n)%nat -> (r i t - r j t = 0)%C.
(* tanner2.bound_r clause 1, refuted; rho is the largest distance at which V_ij <= c (N - 1), and all pairs have potentials *)
Definition bound_r_1 : Prop := ~ forall n adj V V' d r v c, (2 <= n)%nat -> simple_graph adj -> strongly_connected n adj ->
  def3 n complete V V' d -> apart_at n adj r -> 0 < c -> energy6 n adj V r v <= c -> forall i j rho, (i < n)%nat -> (j < n)%nat -> i <> j ->
  0 < rho -> V i j rho <= c * (INR n - 1) -> (forall s, rho < s -> c * (INR n - 1) < V i j s) -> Cmod (r i - r j)%C <= rho.
(* tanner2.bound_v clause 1, refuted: both printed inequalities *)
Definition bound_v_1 : Prop :=
  let printed (P : R -> C -> Prop) := forall n adj V V' d r v c, simple_graph adj -> strongly_connected n adj -> def3 n adj V V' d ->
    apart_at n adj r -> 0 < c -> energy6 n adj V r v <= c -> forall i, (i < n)%nat -> P c (v i) in
  ~ printed (fun c z => inner z z <= c) /\ ~ printed (fun c z => Cmod z <= sqrt c).
(* tanner2.cor1 clause 1, refuted: distances of linked agents need not tend to the unique minima *)
Definition cor1_1 : Prop := ~ forall n adj V V' d r v, simple_graph adj -> is_tree n adj -> def3 n adj V V' d -> motion n adj V' r v ->
  forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> is_lim (fun t => Cmod (r i t - r j t)%C) p_infty (d i j).
(* tanner2.cor1 clause 2: what the display of the proof says, for every vector of gradients, and so for those of a configuration at rest *)
Definition cor1_2 : Prop := forall n adj, simple_graph adj -> is_tree n adj ->
  (forall O (g : nat * nat -> C), tanner_graph.oriented n adj O ->
    (forall k, (k < n)%nat -> lsum O (fun f => inc k f * fst (g f)) = 0 /\ lsum O (fun f => inc k f * snd (g f)) = 0) ->
    forall f, In f O -> g f = 0%C) /\
  (forall V V' r, potentials n adj V V' -> apart_at n adj r -> (forall i, (i < n)%nat -> gradV n adj V' r i = 0%C) ->
    forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> pull adj V' r i j = 0%C).
(* tanner2.cor1 clause 3, refuted *)
Definition cor1_3 : Prop := ~ forall V V' d, def3 2 complete V V' d -> forall s, 0 < s -> V' 0%nat 1%nat s = 0 -> s = d 0%nat 1%nat.
(* tanner2.cor2_decomp clause 1 *)
Definition parts n (v : nat -> C) (xp xn yp yn : nat -> R) := (forall i j, (i < n)%nat -> (j < n)%nat -> xp i = xp j /\ yp i = yp j) /\
  Sum n xn = 0 /\ Sum n yn = 0 /\ forall i, (i < n)%nat -> fst (v i) = xp i + xn i /\ snd (v i) = yp i + yn i.
Definition cor2_decomp : Prop := forall n adj (V V' : nat -> nat -> R -> R) r v t xp xn yp yn, simple_graph adj -> (forall i j s, V i j s = V j i s) ->
  (forall i j s, (i < n)%nat -> (j < n)%nat -> adj i j = true -> 0 < s -> is_derive (V i j) s (V' i j s)) ->
  apart_at n adj (fun i => r i t) ->
  (forall i, (i < n)%nat -> is_velocity (r i) t (v i t) /\ is_velocity (v i) t (law4 n adj V' (fun i => r i t) (fun i => v i t) i)) ->
  parts n (fun i => v i t) xp xn yp yn -> Wdot n adj V r v t (- form n adj xn - form n adj yn).
(* tanner2.cor2_sub clause 1, refuted *)
Definition cor2_sub_1 : Prop := ~ forall n adj V V' d r v t lam xp xn yp yn w, (2 <= n)%nat -> simple_graph adj -> strongly_connected n adj ->
  def3 n adj V V' d -> motion n adj V' r v -> 0 <= t -> lambda2 n adj lam -> parts n (fun i => v i t) xp xn yp yn -> Wdot n adj V r v t w ->
  w <= - lam * (Sum n (fun i => xp i ^ 2) + Sum n (fun i => yp i ^ 2)).
(* tanner2.cor2_rate clauses 1, 2, refuted; the rate is that of the loop linearised at the desired distances, where the second
   derivatives of V_ij are k_ij: modes exp(s t) (x, y) with a complex s and complex amplitudes *)
Definition mode n (adj : graph) (k : nat -> nat -> R) (r : nat -> C) (s : C) (x y : nat -> C) := forall i, (i < n)%nat ->
  let ex j := RtoC (fst (r i - r j)%C / Cmod (r i - r j)%C) in let ey j := RtoC (snd (r i - r j)%C / Cmod (r i - r j)%C) in
  let stretch j := (RtoC (k i j) * (ex j * (x i - x j) + ey j * (y i - y j)))%C in
  (s * s * x i + s * Csum n (fun j => if adj i j then x i - x j else 0) + Csum n (fun j => if adj i j then ex j * stretch j else 0) = 0 /\
   s * s * y i + s * Csum n (fun j => if adj i j then y i - y j else 0) + Csum n (fun j => if adj i j then ey j * stretch j else 0) = 0)%C.
(* all modes but those of rate 0 decay faster than exp(-rho t) *)
Definition decays n adj k r rho := forall s x y, mode n adj k r s x y -> (exists i, (i < n)%nat /\ (x i <> 0%C \/ y i <> 0%C)) ->
  fst s = 0 \/ fst s < - rho.
Definition at_distances n adj V V' d k (r : nat -> C) := (2 <= n)%nat /\ simple_graph adj /\ strongly_connected n adj /\ def3 n adj V V' d /\
  forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> Cmod (r i - r j)%C = d i j /\ is_derive (V' i j) (d i j) (k i j).
Definition rate_1 : Prop := ~ forall n adj V V' d k r m adm U U' e q s lam rho, at_distances n adj V V' d k r -> at_distances m adm U U' e q s ->
  lambda2 n adj lam -> lambda2 m adm lam -> 0 < rho -> decays n adj k r rho -> decays m adm q s rho.
Definition rate_2 : Prop := ~ forall n adj more V V' d k r s lam mu rho, at_distances n adj V V' d k r -> at_distances n more V V' d k s ->
  (forall i j, adj i j = true -> more i j = true) -> lambda2 n adj lam -> lambda2 n more mu -> lam < mu ->
  0 < rho -> decays n adj k r rho -> decays n more k s rho.
(* tanner2.eq14 clauses 1, 2, 3 in a fixed network; a motion stays in S where the rate of W is 0 at all times *)
Definition eq14_1 : Prop := forall n adj V V' r v, simple_graph adj -> potentials n adj V V' -> apart_at n adj r ->
  Sum n (fun i => fst (law4 n adj V' r v i)) = 0 /\ Sum n (fun i => snd (law4 n adj V' r v i)) = 0.
Definition eq14_2 : Prop := forall n adj V V' r v, simple_graph adj -> strongly_connected n adj -> potentials n adj V V' -> motion n adj V' r v ->
  (forall t, 0 <= t -> Wdot n adj V r v t 0) -> forall t, 0 <= t -> exists c, forall i, (i < n)%nat -> is_velocity (v i) t c.
Definition eq14_3 : Prop := forall n adj V V' r v, simple_graph adj -> strongly_connected n adj -> potentials n adj V V' -> motion n adj V' r v ->
  (forall t, 0 <= t -> Wdot n adj V r v t 0) -> forall t i, 0 <= t -> (i < n)%nat -> is_velocity (v i) t 0%C /\ v i t = v i 0.
(* tanner2.eq6 clause 1 *)
Definition eq6_1 : Prop := forall n (adj : graph) (V : nat -> nat -> R -> R) r v, apart_at n adj r ->
  (forall i j s, (i < n)%nat -> (j < n)%nat -> adj i j = true -> 0 < s -> 0 <= V i j s) -> 0 <= energy6 n adj V r v.
(* tanner2.eq7 clause 1 *)
Definition eq7_1 : Prop := forall n adj V V' c, simple_graph adj -> strongly_connected n adj -> potentials n adj V V' ->
  exists B, forall r v, apart_at n adj r -> energy6 n adj V r v <= c -> forall i j, (i < n)%nat -> (j < n)%nat -> Cmod (r i - r j)%C <= B.
(* tanner2.eq7 clause 2; connected or not *)
Definition eq7_2 : Prop := forall n adj V V' c, simple_graph adj -> potentials n adj V V' ->
  exists B, forall r v, apart_at n adj r -> energy6 n adj V r v <= c -> forall i, (i < n)%nat -> Cmod (v i) <= B.
(* tanner2.eq8 clauses 2, 3, 4; gradients by what they are, the edges once each in any orientation *)
Definition gradient (f : C -> R) (x g : C) := forall w, is_derive (fun h => f (x + RtoC h * w)%C) 0 (inner g w).
Definition eq8_234 : Prop := forall n adj (V V' : nat -> nat -> R -> R) r v t O (g gi gj : nat -> nat -> C) (G : nat -> C), simple_graph adj ->
  (forall i j s, V i j s = V j i s) -> (forall i j s, (i < n)%nat -> (j < n)%nat -> adj i j = true -> 0 < s -> is_derive (V i j) s (V' i j s)) ->
  apart_at n adj (fun i => r i t) -> (forall i, (i < n)%nat -> is_velocity (r i) t (v i t)) -> tanner_graph.oriented n adj O ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> gradient (fun z => V i j (Cmod z)) (r i t - r j t)%C (g i j) /\
    gradient (fun z => V i j (Cmod (z - r j t)%C)) (r i t) (gi i j) /\ gradient (fun z => V i j (Cmod (r i t - z)%C)) (r j t) (gj i j)) ->
  (forall i, (i < n)%nat -> gradient (fun z => Sum n (fun j => if adj i j then V i j (Cmod (z - r j t)%C) else 0)) (r i t) (G i)) ->
  let by_pair := lsum O (fun f => inner (v (fst f) t - v (snd f) t)%C (g (fst f) (snd f))) in
  let by_ends := lsum O (fun f => inner (v (fst f) t) (gi (fst f) (snd f)) + inner (v (snd f) t) (gj (fst f) (snd f))) in
  is_derive (fun s => / 2 * Sum n (fun i => Sum n (fun j => if adj i j then V i j (Cmod (r i s - r j s)%C) else 0))) t by_pair /\
  by_pair = by_ends /\ by_ends = Sum n (fun i => inner (v i t) (G i)).
(* tanner2.lem1 clause 1, refuted: regular for no such V at R, so the lemma is false *)
Definition lem1_1 : Prop := (forall V V' R0, smooth V V' -> 0 < R0 -> 0 < V' R0 -> ~ regular_at (saturate V R0) R0) /\
  ~ forall V V' d R0, def3 2 complete V V' d -> d 0%nat 1%nat < R0 -> 0 < V' 0%nat 1%nat R0 ->
    forall s, 0 < s -> regular_at (saturate (V 0%nat 1%nat) R0) s.
(* tanner2.lem2 clause 1, refuted: empty for no such V *)
Definition lem2_1 : Prop := forall V V' R0 ri rj, smooth V V' -> 0 < R0 -> 0 < V' R0 -> Cmod (ri - rj)%C = R0 ->
  exists z, forall w, exists l, clarke_dd2 (fun y => saturate V R0 (Cmod (y - rj)%C)) ri w l /\ inner z w <= l.
(* tanner2.thm1c clause 1, refuted, even for potentials whose derivatives vanish at the minimum only: V_i comes down to its least value *)
Definition thm1c_1 : Prop := ~ forall n adj V V' d r v, simple_graph adj -> strongly_connected n adj -> def3 n adj V V' d ->
  (forall i j s, (i < n)%nat -> (j < n)%nat -> adj i j = true -> 0 < s -> V' i j s = 0 -> s = d i j) -> motion n adj V' r v ->
  let Vi q i := Sum n (fun j => if adj i j then V i j (Cmod (q i - q j)%C) else 0) in
  forall i, (i < n)%nat -> forall q : nat -> C, apart_at n adj q -> forall e, 0 < e -> exists T, forall t, T <= t -> Vi (fun j => r j t) i < Vi q i + e.
(* tanner2.vdotB clause 1, refuted; vdot is what the law says *)
Definition vdotB_1 : Prop := ~ forall n adj V V' d r v O, simple_graph adj -> strongly_connected n adj -> def3 n adj V V' d ->
  apart_at n adj r -> (forall i j, (i < n)%nat -> (j < n)%nat -> v i = v j) -> tanner_graph.oriented n adj O -> forall k, (k < n)%nat ->
  law4 n adj V' r v k = (- gradV n adj V' r k)%C /\
  law4 n adj V' r v k = (- lsum O (fun f => inc k f * fst (pull adj V' r (fst f) (snd f))), - lsum O (fun f => inc k f * snd (pull adj V' r (fst f) (snd f)))).
(* beyond.tanner2.alternating_trees clause 1, the second corrected clause of tanner2.arbswitch; agents 0 to 3, tau the time for each; a motion for all times, along which (4) has a value *)
Definition links_of (l : list (nat * nat)) : graph := fun i j =>
  existsb (fun f => Nat.eqb i (fst f) && Nat.eqb j (snd f) || Nat.eqb j (fst f) && Nat.eqb i (snd f))%bool l.
Definition alternating_trees : Prop := forall tau (r v : nat -> R -> C), 0 < tau ->
  (forall t i, 0 <= t -> (i < 4)%nat -> is_velocity (r i) t (v i t) /\
    continuity_pt (fun s => fst (v i s)) t /\ continuity_pt (fun s => snd (v i s)) t) ->
  (forall k t, INR k * tau <= t < INR (k + 1) * tau ->
    let adj := if Nat.even k then links_of ((0, 1) :: (1, 2) :: (2, 3) :: nil)%nat else links_of ((1, 3) :: (3, 0) :: (0, 2) :: nil)%nat in
    apart_at 4 adj (fun i => r i t) /\
    (INR k * tau < t -> forall i, (i < 4)%nat ->
      is_velocity (v i) t (law4 4 adj (fun _ _ s => 2 * s - 2 / s ^ 3) (fun i => r i t) (fun i => v i t) i))) ->
  ~ forall i j, (i < 4)%nat -> (j < 4)%nat -> to_zero (fun t => v i t - v j t)%C.
(* tanner2.arbswitch clause 2, the first corrected one, and tanner2.thm2_vel clause 1: solutions of (10) after Definition 4, K of the whole field. At a state the limits of the field are
   finitely many, so that their convex hull is closed; N the set of measure zero *)
Definition limit_of_law n V' R0 (r v y : nat -> C) := forall e, 0 < e -> exists q u : nat -> C,
  (forall i, (i < n)%nat -> Cmod (q i - r i)%C < e /\ Cmod (u i - v i)%C < e) /\
  (forall i j, (i < n)%nat -> (j < n)%nat -> i <> j -> Cmod (q i - q j)%C <> R0) /\
  forall i, (i < n)%nat -> Cmod (law4 n (by_distance q R0) V' q u i - y i)%C < e.
Definition K10 n V' R0 (r v z : nat -> C) := exists m (c : nat -> R) (y : nat -> nat -> C),
  (forall k, (k < m)%nat -> 0 <= c k /\ limit_of_law n V' R0 r v (y k)) /\ Sum m c = 1 /\
  forall i, (i < n)%nat -> z i = Csum m (fun k => RtoC (c k) * y k i)%C.
Definition absolutely_continuous (z : R -> C) := forall T e, 0 < T -> 0 < e -> exists d, 0 < d /\ forall m (a b : nat -> R),
  (forall k, (k < m)%nat -> 0 <= a k <= b k /\ b k <= T) -> (forall k, (S k < m)%nat -> b k <= a (S k)) ->
  Sum m (fun k => b k - a k) < d -> Sum m (fun k => Cmod (z (b k) - z (a k))%C) < e.
Definition negligible (N : R -> Prop) := forall e, 0 < e -> exists a b : nat -> R, (forall k, a k <= b k) /\
  (forall t, N t -> exists k, a k < t < b k) /\ forall m, Sum m (fun k => b k - a k) <= e.
Definition motion10 n V' R0 (r v : nat -> R -> C) := apart_at n complete (fun i => r i 0) /\
  (forall t i, 0 <= t -> (i < n)%nat -> is_velocity (r i) t (v i t)) /\ (forall i, (i < n)%nat -> absolutely_continuous (v i)) /\
  exists N, negligible N /\ forall t, 0 <= t -> ~ N t -> apart_at n complete (fun i => r i t) ->
    exists z, K10 n V' R0 (fun i => r i t) (fun i => v i t) z /\ forall i, (i < n)%nat -> is_velocity (v i) t (z i).
Definition arbswitch_2 : Prop := forall n V V' R0 r v, 0 < R0 -> potentials n complete V V' -> motion10 n V' R0 r v ->
  (forall t, 0 <= t -> strongly_connected n (by_distance (fun i => r i t) R0)) ->
  forall i j, (i < n)%nat -> (j < n)%nat -> to_zero (fun t => v i t - v j t)%C.
(* tanner2.eq14 clauses 1, 2, 3 where links switch, (14): the limits of the law are normal to 1, and velocities that stay equal do not change *)
Definition eq14_switching : Prop := forall n V V' R0 r v, 0 < R0 -> potentials n complete V V' -> motion10 n V' R0 r v ->
  (forall t z, 0 <= t -> apart_at n complete (fun i => r i t) -> K10 n V' R0 (fun i => r i t) (fun i => v i t) z -> Csum n z = 0%C) /\
  ((forall t i j, 0 <= t -> (i < n)%nat -> (j < n)%nat -> v i t = v j t) -> forall t i, 0 <= t -> (i < n)%nat -> v i t = v i 0).

(* ---- and the theorems prove these ---- *)
Lemma L_1_holds : L_1.
Proof.
  intros n adj O O' [S _] H H' k m Hk Hm. split; [now apply (tanner_graph.L_orientation n adj)|now apply tanner_graph.L_incidence].
Qed.
Lemma L_2_holds : L_2.
Proof.
  intros n adj O [S _] H L. assert (E : forall k m, (k < n)%nat -> (m < n)%nat -> L k m = lap n adj k m) by (intros; now apply tanner_graph.L_incidence).
  split.
  - intros k m Hk Hm. rewrite !E by assumption. now apply (proj1 (paley_gradient.lap_psd n adj (fun _ => RtoC 0) S)).
  - intros x. destruct (paley_gradient.lap_psd n adj (fun i => RtoC (x i)) S) as [_ P]. apply Rle_trans with (1 := P). right.
    apply Sum_ext. intros k Hk. rewrite inner_row, <- Sum_scal. apply Sum_ext. intros m Hm. rewrite (E k m Hk Hm), inner_xy. cbn. ring.
Qed.
Lemma eq6_1_holds : eq6_1.
Proof.
  intros n adj V r v A P. unfold energy6. apply Rmult_le_pos; [lra|]. apply Sum_ge0. intros i Hi. apply Rplus_le_le_0_compat; [|apply pow2_ge_0].
  apply Sum_ge0. intros j Hj. destruct (adj i j) eqn:L; [|lra]. apply P; try assumption. apply tanner_flock.norm_neq. now apply A.
Qed.
Lemma eq7_1_holds : eq7_1.
Proof.
  intros n adj V V' c S SC P. destruct (potentials_are _ _ _ _ (one_of n adj V V' (proj1 S) P)) as (A & _ & C & _). destruct S as [S NL].
  destruct n as [|n]; [exists 0; intros; lia|].
  destruct (tanner_flock.all_distances (Datatypes.S n) adj (both V) (both V') c ltac:(lia) S NL SC A C) as [B Q].
  exists B. intros r v D E. apply (Q r v D). now rewrite <- energy6_is, (energy_both _ adj V r v (proj1 P)).
Qed.
Lemma eq7_2_holds : eq7_2.
Proof.
  intros n adj V V' c S P. exists (sqrt (2 * c)). intros r v D E i Hi. now apply (bound_v_proved n adj V V' r v c S P D E).
Qed.
Lemma cor2_decomp_holds : cor2_decomp.
Proof.
  intros n adj V V' r v t xp xn yp yn [S NL] VS D A U (Pp & Zx & Zy & Pv). unfold Wdot.
  apply (is_derive_ext (fun s => energy6 n adj (both V) (fun i => r i s) (fun i => v i s))); [intros; now apply energy_both|].
  apply (is_derive_ext (fun s => Wenergy n adj (both V) (fun i => r i s) (fun i => v i s))); [intros; symmetry; apply energy6_is|].
  assert (K : forall q : nat -> R, (forall i j, (i < n)%nat -> (j < n)%nat -> q i = q j) -> exists c, forall i, (i < n)%nat -> q i = c).
  { intros q Q. exists (q 0%nat). intros i Hi. apply Q; lia. }
  apply (tanner2_facts.cor2_decomp n adj (both V) (both V') r v t xp xn yp yn S (both_sym V')); try assumption.
  - intros i Hi. now apply U.
  - intros i j Hi Hj L. assert (0 < norm (r i t - r j t)%C) by (apply tanner_flock.norm_neq; now apply A).
    apply both_derive; [exact VS|now apply D|]. apply D; try assumption. now rewrite S.
  - intros i Hi. rewrite <- law4_is. destruct (both_law n adj V V' (fun i => r i t) (fun i => v i t) i S VS D Hi A) as (_ & _ & ->). now apply U.
  - apply K. intros; now apply Pp.
  - apply K. intros; now apply Pp.
Qed.
(* what vanishes from t on has the derivative 0 there *)
Lemma eq14_1_holds : eq14_1.
Proof. exact tanner2_filippov.balanced. Qed.
Lemma in_S n adj V V' r v : simple_graph adj -> strongly_connected n adj -> potentials n adj V V' -> motion n adj V' r v ->
  (forall t, 0 <= t -> Wdot n adj V r v t 0) -> forall t i j, 0 <= t -> (i < n)%nat -> (j < n)%nat -> v i t = v j t.
Proof.
  intros S SC P M Z t i j Ht Hi Hj. pose proof (apart_always n adj V V' r v S P M t Ht) as A.
  pose proof (eq9_proved n adj V V' r v t S (proj1 P) (slopes_of n adj V V' P) A) as E.
  assert (U : forall i, (i < n)%nat -> is_velocity (r i) t (v i t) /\ is_velocity (v i) t (law4 n adj V' (fun i => r i t) (fun i => v i t) i)).
  { intros k Hk. destruct M as [_ M]. destruct (M t k Ht Hk) as [M1 M2]. split; [exact M1|now apply M2]. }
  specialize (E U). cbv zeta in E. apply is_derive_unique in E. rewrite (is_derive_unique _ _ _ (Z t Ht)), !form_is in E.
  apply (tanner2_facts.S_config_corrected n adj (fun i => v i t)); try assumption; [lia|apply S|]. rewrite tanner_energy.kron_split. cbv beta in *. lra.
Qed.
Lemma moves_law n adj V V' r v t i : simple_graph adj -> potentials n adj V V' -> motion n adj V' r v -> 0 <= t -> (i < n)%nat ->
  is_velocity (v i) t (law4 n adj V' (fun i => r i t) (fun i => v i t) i).
Proof. intros S P M Ht Hi. destruct (proj2 M t i Ht Hi) as [_ Q]. apply Q. now apply (apart_always n adj V V' r v). Qed.
Lemma eq14_2_holds : eq14_2.
Proof.
  intros n adj V V' r v S SC P M Z t Ht. destruct n as [|n]; [exists 0%C; intros; lia|].
  exists (law4 (Datatypes.S n) adj V' (fun i => r i t) (fun i => v i t) 0%nat). intros i Hi.
  replace (law4 _ _ _ _ _ 0%nat) with (law4 (Datatypes.S n) adj V' (fun i => r i t) (fun i => v i t) i); [now apply (moves_law _ _ V)|].
  apply (equal_rates (v i) (v 0%nat) t); [now apply (moves_law _ _ V)|apply (moves_law _ _ V); try assumption; lia|].
  intros s Hs. apply (in_S (Datatypes.S n) adj V V' r v); try assumption; [lra|lia].
Qed.
Lemma still (f : R -> R) t : 0 <= t -> (forall s, 0 <= s -> is_derive f s 0) -> f t = f 0.
Proof.
  intros Ht D. apply Rle_antisym.
  - apply (decreasing f (fun _ => 0)); [exact Ht|intros; apply D; lra|intros; lra].
  - apply Ropp_le_cancel. apply (decreasing (fun s => - f s) (fun _ => 0)); [exact Ht| |intros; lra].
    intros s Hs. eapply D_eq; [apply D_opp, D; lra|]. apply Ropp_0.
Qed.
Lemma eq14_3_holds : eq14_3.
Proof.
  intros n adj V V' r v S SC P M Z.
  assert (K : forall t i, 0 <= t -> (i < n)%nat -> is_velocity (v i) t 0%C).
  { intros t i Ht Hi. pose proof (apart_always n adj V V' r v S P M t Ht) as A.
    destruct (eq14_2_holds n adj V V' r v S SC P M Z t Ht) as [c Hc].
    destruct (eq14_1_holds n adj V V' (fun i => r i t) (fun i => v i t) S P A) as [E1 E2].
    assert (L : forall j, (j < n)%nat -> law4 n adj V' (fun i => r i t) (fun i => v i t) j = c).
    { intros j Hj. apply (equal_rates (v j) (v j) t); [now apply (moves_law n adj V)|now apply Hc|reflexivity]. }
    rewrite (Sum_ext n _ (fun _ => fst c)) in E1 by (intros j Hj; now rewrite L). rewrite (Sum_ext n _ (fun _ => snd c)) in E2 by (intros j Hj; now rewrite L).
    rewrite Sum_const in E1, E2. assert (Pn : 0 < INR n) by (apply lt_0_INR; lia).
    assert (F1 : fst c = 0) by (apply (Rmult_eq_reg_l (INR n)); lra). assert (F2 : snd c = 0) by (apply (Rmult_eq_reg_l (INR n)); lra).
    assert (F : c = 0%C) by (apply injective_projections; assumption). rewrite <- F. now apply Hc. }
  intros t i Ht Hi. split; [now apply K|]. apply injective_projections.
  - apply (still (fun s => fst (v i s)) t Ht). intros s Hs. apply (K s i Hs Hi).
  - apply (still (fun s => snd (v i s)) t Ht). intros s Hs. apply (K s i Hs Hi).
Qed.
(* V = s^2 + s^-2 - 2, with the minimum 0 at 1 *)
Definition spring (s : R) : R := s ^ 2 + / s ^ 2 - 2.
Definition spring' (s : R) : R := 2 * s - 2 / s ^ 3.
Lemma spring_square s : 0 < s -> spring s = (s - / s) ^ 2.
Proof. intros Hs. unfold spring. field. lra. Qed.
Lemma spring_above s t : 1 <= s -> s < t -> spring s < spring t.
Proof.
  intros Hs Ht. rewrite !spring_square by lra. assert (/ t < / s) by (apply Rinv_lt_contravar; nra). assert (/ s <= 1) by (rewrite <- Rinv_1; apply Rinv_le_contravar; lra).
  assert (0 <= s - / s < t - / t) by lra. nra.
Qed.
Lemma spring_minimum s : 0 < s -> s <> 1 -> spring 1 < spring s.
Proof.
  intros Hs N. rewrite !spring_square by lra. replace ((1 - / 1) ^ 2) with 0 by field. apply pow2_gt_0. intros E. apply N.
  assert ((s - / s) * s = 0) by (rewrite E; ring). replace ((s - / s) * s) with ((s - 1) * (s + 1)) in H by (field; lra).
  apply Rmult_integral in H. lra.
Qed.
Lemma potentials_of n adj (V V' : R -> R) : tanner_flock.potential V V' -> (forall s, 0 < s -> continuity_pt V' s) ->
  potentials n adj (fun _ _ => V) (fun _ _ => V').
Proof.
  intros (P1 & P2 & P3) K. split; [reflexivity|]. intros i j _ _ _. split; [|split; [exact P2|exact P3]]. intros s Hs.
  destruct (P1 s Hs) as [A B]. split; [exact A|split; [now apply K|exact B]].
Qed.
Lemma spring_def3 n adj : def3 n adj (fun _ _ => spring) (fun _ _ => spring') (fun _ _ => 1).
Proof.
  split.
  - apply potentials_of; [exact tanner2_switching.spring_potential|]. intros s Hs. apply continuity_pt_filterlim, (ex_derive_continuous spring').
    unfold spring'. auto_derive. assert (0 < s ^ 3) by (apply pow_lt; lra). simpl in *. lra.
  - intros i j _ _ _. split; [lra|]. intros s. apply spring_minimum.
Qed.
Lemma lem1_1_holds : lem1_1.
Proof.
  assert (F : forall V V' R0, smooth V V' -> 0 < R0 -> 0 < V' R0 -> ~ regular_at (saturate V R0) R0).
  { intros V V' R0 H HR Hc. apply (tanner_nonsmooth.lemma1_fails V V' R0 (V' R0)); try assumption; try reflexivity; intros; now apply H. }
  split; [exact F|]. intros Q. pose proof (spring_def3 2 complete) as D.
  assert (P : 0 < spring' 2) by (unfold spring'; lra).
  apply (F spring spring' 2); [|lra|exact P|exact (Q _ _ _ 2 D ltac:(lra) P 2 ltac:(lra))].
  intros s Hs. destruct D as [[_ D] _]. destruct (D 0%nat 1%nat ltac:(lia) ltac:(lia) eq_refl) as [D1 _]. destruct (D1 s Hs) as (A & B & _). now split.
Qed.
(* two agents, linked *)
Lemma complete_simple : simple_graph complete.
Proof. split; [apply complete_undirected|apply complete_no_loops]. Qed.
Definition on_line (x : nat -> R) (i : nat) : C := RtoC (x i).
Lemma line_distance x i j : Cmod (on_line x i - on_line x j)%C = Rabs (x i - x j).
Proof. unfold on_line. rewrite <- RtoC_minus. apply Cmod_R. Qed.
Definition at2 (a : R) (i : nat) : R := match i with 0%nat => 0 | _ => a end.
Lemma pair_apart a : a <> 0 -> apart_at 2 complete (on_line (at2 a)).
Proof.
  intros Ha i j Hi Hj L E. apply (f_equal fst) in E. unfold on_line, at2 in E. cbn in E.
  destruct i as [|[|]], j as [|[|]]; try lia; try discriminate L; congruence.
Qed.
Lemma line_velocity (p u : C) t : is_velocity (fun s => p + RtoC s * u)%C t u.
Proof.
  split.
  - apply (is_derive_ext (fun s => fst p + s * fst u)); [intros s; cbn; ring|]. auto_derive; [exact I|ring].
  - apply (is_derive_ext (fun s => snd p + s * snd u)); [intros s; cbn; ring|]. auto_derive; [exact I|ring].
Qed.
Lemma rest_velocity (u : C) t : is_velocity (fun _ => u) t 0%C.
Proof. split; apply D_const. Qed.
(* they stay at a distance a at which V' = 0, in a common motion of velocity u *)
Lemma pair_motion V' a u : 0 < a -> V' a = 0 -> motion 2 complete (fun _ _ => V') (fun i s => on_line (at2 a) i + RtoC s * u)%C (fun _ _ => u).
Proof.
  intros Ha Z. split.
  - intros i j Hi Hj L E. apply (pair_apart a ltac:(lra) i j Hi Hj L). replace (on_line (at2 a) i) with (on_line (at2 a) i + RtoC 0 * u)%C by ring.
    rewrite E. ring.
  - intros t i Ht Hi. split; [apply line_velocity|]. intros _.
    replace (law4 _ _ _ _ _ i) with (RtoC 0); [apply rest_velocity|]. symmetry.
    assert (N : forall k j, (k < 2)%nat -> (j < 2)%nat -> complete k j = true -> V' (Cmod (on_line (at2 a) k + RtoC t * u - (on_line (at2 a) j + RtoC t * u))%C) = 0).
    { intros k j Hk Hj L. replace (on_line (at2 a) k + RtoC t * u - (on_line (at2 a) j + RtoC t * u))%C with (on_line (at2 a) k - on_line (at2 a) j)%C by ring.
      rewrite line_distance. rewrite <- Z. f_equal. unfold at2.
      destruct k as [|[|]], j as [|[|]]; try lia; try discriminate L; unfold Rabs; destruct (Rcase_abs _); lra. }
    unfold law4, gradV. rewrite !Csum_0; [ring| |].
    + intros j Hj. unfold pull. destruct (complete i j) eqn:L; [|reflexivity]. rewrite (N i j Hi Hj L). unfold Rdiv. rewrite Rmult_0_l. ring.
    + intros j _. destruct (complete i j); [ring|reflexivity].
Qed.
Lemma pair_energy V a u : 0 < a -> energy6 2 complete (fun _ _ => V) (on_line (at2 a)) u = V a + / 2 * (Cmod (u 0%nat) ^ 2 + Cmod (u 1%nat) ^ 2).
Proof.
  intros Ha. unfold energy6. cbn [Sum complete Nat.eqb negb]. rewrite !line_distance. unfold at2.
  replace (Rabs (0 - a)) with a by (rewrite Rabs_left; lra). replace (Rabs (a - 0)) with a by (rewrite Rabs_pos_eq; lra). field.
Qed.
Lemma energy_moved n adj V p w u : energy6 n adj V (fun i => p i + w)%C u = energy6 n adj V p u.
Proof.
  unfold energy6. f_equal. apply Sum_ext. intros i _. f_equal. apply Sum_ext. intros j _.
  replace (p i + w - (p j + w))%C with (p i - p j)%C by ring. reflexivity.
Qed.
Lemma pair_Wdot V a u t : Wdot 2 complete (fun _ _ => V) (fun i s => on_line (at2 a) i + RtoC s * u)%C (fun _ _ => u) t 0.
Proof.
  unfold Wdot. apply (is_derive_ext (fun _ => energy6 2 complete (fun _ _ => V) (on_line (at2 a)) (fun _ => u))); [intros s; symmetry; apply energy_moved|].
  apply D_const.
Qed.
Lemma complete_joined n : strongly_connected n complete.
Proof. apply tanner2_examples.complete_connected. Qed.
Lemma spring_rest : spring' 1 = 0.
Proof. unfold spring'. field. Qed.
Lemma S_config_1_holds : S_config_1.
Proof.
  intros Q. pose proof (Q 2%nat complete _ _ _ _ _ 0 complete_simple (complete_joined 2) (spring_def3 2 complete)
    (pair_motion spring' 1 0%C Rlt_0_1 spring_rest) (Rle_refl 0) (pair_Wdot spring 1 0%C 0) ltac:(reflexivity) 0%nat 1%nat ltac:(lia) ltac:(lia)) as E.
  apply (f_equal fst) in E. cbn in E. lra.
Qed.
Lemma bound_v_1_holds : bound_v_1.
Proof.
  set (u := fun i : nat => match i with 0%nat => RtoC 1 | _ => RtoC 0 end).
  assert (W : energy6 2 complete (fun _ _ => spring) (on_line (at2 1)) u <= / 2).
  { rewrite pair_energy by lra. unfold u. rewrite !Cmod_R, Rabs_R1, Rabs_R0. unfold spring. lra. }
  assert (A : apart_at 2 complete (on_line (at2 1))) by (apply pair_apart; lra).
  split; intros Q; pose proof (Q 2%nat complete _ _ _ _ u (/ 2) complete_simple (complete_joined 2) (spring_def3 2 complete) A ltac:(lra) W 0%nat ltac:(lia)) as E;
    unfold u in E; cbv beta iota in E.
  - rewrite inner_self, Cmod_R, Rabs_R1 in E. lra.
  - rewrite Cmod_R, Rabs_R1 in E. assert (sqrt (/ 2) < sqrt 1) by (apply sqrt_lt_1_alt; lra). rewrite sqrt_1 in H. lra.
Qed.
Lemma links_simple l : (forall f, In f l -> fst f <> snd f) -> simple_graph (links_of l).
Proof.
  intros H. split.
  - intros i j. unfold links_of. induction l as [|f l IH]; [reflexivity|]. cbn [existsb]. rewrite IH by (intros; apply H; now right).
    f_equal. apply Bool.orb_comm.
  - intros i. unfold links_of. induction l as [|f l IH]; [reflexivity|]. cbn [existsb]. rewrite IH by (intros; apply H; now right).
    pose proof (H f (or_introl eq_refl)). destruct (Nat.eqb_spec i (fst f)), (Nat.eqb_spec i (snd f)); cbn; congruence.
Qed.
Definition three : graph := links_of ((0, 1) :: (1, 2) :: nil)%nat.
Lemma three_simple : simple_graph three.
Proof. apply links_simple. intros f [<-|[<-|[]]]; cbn; lia. Qed.
Lemma three_joined : strongly_connected 3 three.
Proof.
  assert (A : forall j k, (j < 3)%nat -> (k < 3)%nat -> three k j = true -> clos_refl_trans nat (arc 3 three) j k) by (intros; apply rt_step; repeat split; assumption).
  assert (B : forall j, (j < 3)%nat -> clos_refl_trans nat (arc 3 three) j 1%nat /\ clos_refl_trans nat (arc 3 three) 1%nat j).
  { intros [|[|[|]]] H; try lia; split; try (apply A; [lia|lia|reflexivity]); apply rt_refl. }
  intros j k Hj Hk. apply rt_trans with 1%nat; now apply B.
Qed.
Lemma bound_r_1_holds : bound_r_1.
Proof.
  intros Q. assert (A : apart_at 3 three (on_line INR)).
  { intros i j Hi Hj L E. apply (f_equal fst) in E. apply INR_eq in E. subst. rewrite (proj2 three_simple) in L. discriminate. }
  assert (W : energy6 3 three (fun _ _ => spring) (on_line INR) (fun _ => 0%C) <= 25 / 72).
  { unfold energy6. cbn [Sum three links_of existsb Nat.eqb fst snd andb orb]. rewrite !line_distance, Cmod_0. cbn [INR].
    replace (Rabs (0 - 1)) with 1 by (rewrite Rabs_left; lra). replace (Rabs (1 - 0)) with 1 by (rewrite Rabs_pos_eq; lra).
    replace (Rabs (1 - (1 + 1))) with 1 by (rewrite Rabs_left; lra). replace (Rabs (1 + 1 - 1)) with 1 by (rewrite Rabs_pos_eq; lra).
    replace (spring 1) with 0 by (unfold spring; field). lra. }
  pose proof (Q 3%nat three _ _ _ _ _ (25 / 72) ltac:(lia) three_simple three_joined (spring_def3 3 complete) A ltac:(lra) W 0%nat 2%nat (3 / 2)
    ltac:(lia) ltac:(lia) ltac:(lia) ltac:(lra)) as E. cbv beta in E.
  replace (25 / 72 * (INR 3 - 1)) with (spring (3 / 2)) in E by (unfold spring; cbn [INR]; field).
  specialize (E (Rle_refl _) (fun s Hs => spring_above (3 / 2) s ltac:(lra) Hs)). rewrite line_distance in E. cbn [INR] in E.
  rewrite Rabs_left in E by lra. lra.
Qed.
(* the potential of Corollary 1 that is flat at 2 *)
Lemma flat_def3 n adj : def3 n adj (fun _ _ => tanner2_examples.VB) (fun _ _ => tanner2_examples.VB') (fun _ _ => 1).
Proof.
  split.
  - apply potentials_of; [exact tanner2_examples.VB_potential|]. intros s Hs. apply continuity_pt_filterlim, (ex_derive_continuous tanner2_examples.VB').
    unfold tanner2_examples.VB'. auto_derive. assert (0 < s ^ 2) by (apply pow_lt; lra). simpl in *. lra.
  - intros i j _ _ _. split; [lra|]. apply (proj1 (proj2 tanner2_examples.cor1_stuck)).
Qed.
Lemma flat_at_2 : tanner2_examples.VB' 2 = 0.
Proof. unfold tanner2_examples.VB'. field. Qed.
Lemma pair_tree : is_tree 2 complete.
Proof.
  split; [apply complete_joined|]. intros i [|a [|b l]] Hi N P L; cbn in L; try lia. destruct P as (Ha & _ & Hb & _).
  inversion N as [|? ? N1 N2]; subst. inversion N2 as [|? ? N3 _]; subst. cbn in N1, N3. lia.
Qed.
Lemma cor1_1_holds : cor1_1.
Proof.
  intros Q. pose proof (Q 2%nat complete _ _ _ _ _ complete_simple pair_tree (flat_def3 2 complete) (pair_motion _ 2 0%C Rlt_0_2 flat_at_2)
    0%nat 1%nat ltac:(lia) ltac:(lia) eq_refl) as E. cbv beta in E.
  apply (is_lim_ext _ (fun _ => 2)) in E.
  - apply is_lim_unique in E. rewrite Lim_const in E. injection E. lra.
  - intros t. replace (on_line (at2 2) 0 + RtoC t * 0 - (on_line (at2 2) 1 + RtoC t * 0))%C with (on_line (at2 2) 0%nat - on_line (at2 2) 1%nat)%C by ring.
    rewrite line_distance. cbn. rewrite Rabs_left; lra.
Qed.
Lemma cor1_2_holds : cor1_2.
Proof.
  intros n adj S T. split.
  - intros O g HO Z f Hf. destruct (cor1_5_proved n adj (fun _ _ _ => 0) (fun _ _ _ => 0) (fun _ _ => 0%C) (fun _ _ => 0%C) S T) as [K _].
    apply injective_projections; [apply (K O (fun f => fst (g f)) HO)|apply (K O (fun f => snd (g f)) HO)]; try assumption; intros k Hk; now apply Z.
  - intros V V' r P A Z i j Hi Hj L.
    assert (M : motion n adj V' (fun i _ => r i) (fun _ _ => 0%C)).
    { split; [exact A|]. intros t k _ Hk. split; [apply rest_velocity|]. intros _.
      replace (law4 _ _ _ _ _ k) with (RtoC 0); [apply rest_velocity|]. unfold law4. cbv beta.
      change (gradV n adj V' (fun i => r i) k) with (gradV n adj V' r k). rewrite (Z k Hk), Csum_0; [ring|]. intros m _. destruct (adj k m); [ring|reflexivity]. }
    pose proof (proj2 (cor1_5_proved n adj V V' _ _ S T) P M i j Hi Hj) as Q. cbv beta in Q.
    destruct (Req_dec (Cmod (pull adj V' r i j)) 0) as [E|N]; [now apply Cmod_eq_0|exfalso].
    pose proof (Cmod_ge_0 (pull adj V' r i j)). destruct (Q (Cmod (pull adj V' r i j)) ltac:(lra)) as [T0 B]. specialize (B T0 (Rle_refl _)).
    cbv beta in B. change (Cmod (pull adj V' r i j) < Cmod (pull adj V' r i j)) in B. lra.
Qed.
Lemma cor1_3_holds : cor1_3.
Proof. intros Q. pose proof (Q _ _ _ (flat_def3 2 complete) 2 Rlt_0_2 flat_at_2). cbv beta in H. lra. Qed.
Lemma lem2_1_holds : lem2_1.
Proof.
  intros V V' R0 ri rj H HR Hc At. exists 0%C. intros w. eexists. split.
  - apply clarke2_is. apply (tanner_saturated.plane_clarke V V' R0 (V' R0) ri rj HR); try assumption; try reflexivity; intros; now apply H.
  - rewrite inner_xy. cbn. rewrite !Rmult_0_l, Rplus_0_r. apply Rmax_l.
Qed.
Lemma alternating_trees_holds : alternating_trees.
Proof.
  intros tau r v Ht M L Q. refine (tanner2_switching.paths_never_agree tau r v Ht _ _ _).
  - intros t i H Hi. destruct (M t i ltac:(lra) Hi) as (A & B & D). split; [exact A|now split].
  - intros k t H. assert (E : INR (k + 1) = INR k + 1) by (rewrite plus_INR; reflexivity).
    destruct (L k t ltac:(rewrite E; lra)) as [A B]. split.
    + unfold tanner2_switching.turn. destruct (Nat.even k); exact A.
    + intros i Hi. specialize (B ltac:(lra) i Hi). rewrite law4_is in B. unfold tanner2_switching.turn. destruct (Nat.even k); exact B.
  - intros i j Hi Hj e He. destruct (Q i j Hi Hj e He) as [T B]. exists (Rmax 0 T). split; [apply Rmax_l|]. intros t Hm. apply B.
    pose proof (Rmax_r 0 T). lra.
Qed.
Lemma pair_lambda2 : lambda2 2 complete 2.
Proof.
  split.
  - intros x Z. unfold form, lap, deg, w, delta, complete. cbn [Sum Nat.eqb negb] in *. assert (x 1%nat = - x 0%nat) by lra. rewrite H. right. ring.
  - exists (fun i => match i with 0%nat => 1 | _ => -1 end). cbn [Sum]. split; [ring|]. split; [lra|].
    intros [|[|]] Hi; try lia; unfold lap, deg, w, delta, complete; cbn [Sum Nat.eqb negb]; ring.
Qed.
Lemma cor2_sub_1_holds : cor2_sub_1.
Proof.
  intros Q. assert (P : parts 2 (fun _ => RtoC 1) (fun _ => 1) (fun _ => 0) (fun _ => 0) (fun _ => 0)).
  { split; [split; reflexivity|]. cbn [Sum]. repeat split; try ring; cbn; ring. }
  pose proof (Q 2%nat complete _ _ _ _ _ 0 2 _ _ _ _ 0 ltac:(lia) complete_simple (complete_joined 2) (spring_def3 2 complete)
    (pair_motion spring' 1 (RtoC 1) Rlt_0_1 spring_rest) (Rle_refl 0) pair_lambda2 P (pair_Wdot spring 1 (RtoC 1) 0)) as E.
  cbn [Sum] in E. lra.
Qed.
(* ---- the two examples of rates: V = k (s^2 + s^-2 - 2) ---- *)
Definition soft (k s : R) : R := k * spring s.
Definition soft' (k s : R) : R := k * spring' s.
Lemma soft_def3 k n adj : 0 < k -> def3 n adj (fun _ _ => soft k) (fun _ _ => soft' k) (fun _ _ => 1).
Proof.
  intros Hk. split.
  - split; [reflexivity|]. intros i j Hi Hj L. destruct (spring_def3 n adj) as [[_ P] _]. destruct (P i j Hi Hj L) as (P1 & P2 & P3). split; [|split].
    + intros s Hs. destruct (P1 s Hs) as (A & B & D). split; [now apply D_scal|]. split; [|apply Rmult_le_pos; lra].
      now apply (continuity_pt_scal spring' k).
    + intros c. destruct (P2 (c / k)) as [d [Hd B]]. exists d. split; [exact Hd|]. intros s Hs. specialize (B s Hs). unfold soft.
      apply (Rmult_lt_compat_l k) in B; [|exact Hk]. replace (k * (c / k)) with c in B by (field; lra). exact B.
    + intros c. destruct (P3 (c / k)) as [d B]. exists d. intros s Hs. specialize (B s Hs). unfold soft.
      apply (Rmult_lt_compat_l k) in B; [|exact Hk]. replace (k * (c / k)) with c in B by (field; lra). exact B.
  - intros i j _ _ _. split; [lra|]. intros s Hs N. apply Rmult_lt_compat_l; [exact Hk|now apply spring_minimum].
Qed.
Lemma soft_second k : is_derive (soft' k) 1 (8 * k).
Proof.
  unfold soft', spring'. auto_derive; [lra|]. field.
Qed.
Lemma soft_at_distances k n adj r : 0 < k -> (2 <= n)%nat -> simple_graph adj -> strongly_connected n adj ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> Cmod (r i - r j)%C = 1) ->
  at_distances n adj (fun _ _ => soft k) (fun _ _ => soft' k) (fun _ _ => 1) (fun _ _ => 8 * k) r.
Proof.
  intros Hk Hn S SC D. split; [exact Hn|]. split; [exact S|]. split; [exact SC|]. split; [now apply soft_def3|].
  intros i j Hi Hj L. split; [now apply D|apply soft_second].
Qed.
(* complex roots of s^2 + p s + q *)
Lemma root_side p q rho s : rho < p / 2 -> 0 < rho ^ 2 - p * rho + q -> (s * s + RtoC p * s + RtoC q = 0)%C -> fst s < - rho.
Proof.
  intros Hp Hq E. pose proof (f_equal fst E) as E1. pose proof (f_equal snd E) as E2. destruct s as [a b]. cbn in E1, E2 |- *.
  assert (F2 : b * (2 * a + p) = 0) by lra. apply Rmult_integral in F2. destruct F2 as [->|F2]; [|lra].
  apply Rnot_le_lt. intros L. assert (0 <= (a + rho) * (a - rho + p)) by (apply Rmult_le_pos; lra). nra.
Qed.
Lemma Cmult_zero (a b : C) : (a * b = 0)%C -> a = 0%C \/ b = 0%C.
Proof.
  intros E. destruct (Req_dec (Cmod a) 0) as [A|A]; [left; now apply Cmod_eq_0|]. destruct (Req_dec (Cmod b) 0) as [B|B]; [right; now apply Cmod_eq_0|].
  exfalso. pose proof (f_equal Cmod E) as F. rewrite Cmod_mult, Cmod_0 in F. apply Rmult_integral in F. tauto.
Qed.
(* a combination z of amplitudes with (s^2 + p s + q) z = 0 *)
Lemma amplitude p q rho s z : 0 < rho < p / 2 -> q = 0 \/ 0 < rho ^ 2 - p * rho + q -> ((s * s + RtoC p * s + RtoC q) * z = 0)%C -> fst s = 0 \/ fst s < - rho \/ z = 0%C.
Proof.
  intros Hr Hq E. apply Cmult_zero in E. destruct E as [E|E]; [|tauto]. destruct Hq as [->|Hq].
  - replace (s * s + RtoC p * s + RtoC 0)%C with (s * (s + RtoC p))%C in E by ring. apply Cmult_zero in E. destruct E as [->|E]; [left; reflexivity|].
    right. left. pose proof (f_equal fst E) as E1. cbn in E1. lra.
  - right. left. now apply (root_side p q).
Qed.
Lemma amplitude0 s z : (s * s * z = 0)%C -> fst s = 0 \/ z = 0%C.
Proof. intros E. apply Cmult_zero in E. destruct E as [E|E]; [|tauto]. apply Cmult_zero in E. left. destruct E as [->| ->]; reflexivity. Qed.
Lemma Csum_2 f : Csum 2 f = (f 0%nat + f 1%nat)%C.
Proof. apply injective_projections; cbn; ring. Qed.
Lemma Csum_3 f : Csum 3 f = (f 0%nat + f 1%nat + f 2%nat)%C.
Proof. apply injective_projections; cbn; ring. Qed.
(* directions along the line *)
Lemma line_ex p i j : p i < p j -> fst (on_line p i - on_line p j)%C / Cmod (on_line p i - on_line p j)%C = -1 /\
  fst (on_line p j - on_line p i)%C / Cmod (on_line p j - on_line p i)%C = 1.
Proof.
  intros L. rewrite !line_distance, (Rabs_left (p i - p j)), (Rabs_pos_eq (p j - p i)) by lra. unfold on_line. cbn. split; field; lra.
Qed.
Lemma line_ey p i j : snd (on_line p i - on_line p j)%C / Cmod (on_line p i - on_line p j)%C = 0.
Proof. unfold on_line. cbn. unfold Rdiv. ring. Qed.
Lemma pair_modes k s x y : mode 2 complete (fun _ _ => k) (on_line (at2 1)) s x y ->
  (s * s * (x 0%nat + x 1%nat) = 0 /\ (s * s + RtoC 2 * s + RtoC (2 * k)) * (x 0%nat - x 1%nat) = 0 /\
   s * s * (y 0%nat + y 1%nat) = 0 /\ (s * s + RtoC 2 * s + RtoC 0) * (y 0%nat - y 1%nat) = 0)%C.
Proof.
  intros M. destruct (M 0%nat ltac:(lia)) as [A0 B0]. destruct (M 1%nat ltac:(lia)) as [A1 B1]. clear M. cbv zeta in A0, A1, B0, B1.
  rewrite !Csum_2 in A0, A1, B0, B1. cbn [complete Nat.eqb negb] in A0, A1, B0, B1. rewrite !line_ey in A0, A1, B0, B1.
  destruct (line_ex (at2 1) 0 1 ltac:(cbn; lra)) as [E1 E2]. rewrite !E1 in A0. rewrite !E1 in B0. rewrite !E2 in A1. rewrite !E2 in B1.
  replace (RtoC (2 * k)) with (RtoC 2 * RtoC k)%C by (apply injective_projections; cbn; ring).
  assert (N1 : RtoC (-1) = (- RtoC 1)%C) by (apply injective_projections; cbn; ring). rewrite !N1 in A0. rewrite !N1 in B0.
  assert (N2 : RtoC 2 = (RtoC 1 + RtoC 1)%C) by (apply injective_projections; cbn; ring). rewrite N2.
  split; [|split; [|split]].
  - match type of A0 with ?a0 = _ => match type of A1 with ?a1 = _ => transitivity (a0 + a1)%C; [|rewrite A0, A1; ring] end end. ring.
  - match type of A0 with ?a0 = _ => match type of A1 with ?a1 = _ => transitivity (a0 - a1)%C; [|rewrite A0, A1; ring] end end. ring.
  - match type of B0 with ?a0 = _ => match type of B1 with ?a1 = _ => transitivity (a0 + a1)%C; [|rewrite B0, B1; ring] end end. ring.
  - match type of B0 with ?a0 = _ => match type of B1 with ?a1 = _ => transitivity (a0 - a1)%C; [|rewrite B0, B1; ring] end end. ring.
Qed.
Lemma sum_gap (a b : C) : (a + b = 0)%C -> (a - b = 0)%C -> a = 0%C /\ b = 0%C.
Proof.
  intros E F. pose proof (f_equal fst E). pose proof (f_equal snd E). pose proof (f_equal fst F). pose proof (f_equal snd F). cbn in *.
  split; apply injective_projections; cbn; lra.
Qed.
Lemma pair_decays : decays 2 complete (fun _ _ => 8 * 1) (on_line (at2 1)) (1 / 2).
Proof.
  intros s x y M (i & Hi & N). destruct (pair_modes _ s x y M) as (X0 & X1 & Y0 & Y1). apply amplitude0 in X0. apply amplitude0 in Y0.
  apply (amplitude _ _ (1 / 2)) in X1; [|lra|right; lra]. apply (amplitude _ _ (1 / 2)) in Y1; [|lra|now left].
  destruct X0 as [X0|X0]; [now left|]. destruct Y0 as [Y0|Y0]; [now left|]. destruct X1 as [X1|[X1|X1]]; [now left|now right|]. destruct Y1 as [Y1|[Y1|Y1]]; [now left|now right|].
  exfalso. destruct (sum_gap _ _ X0 X1), (sum_gap _ _ Y0 Y1). destruct i as [|[|]]; try lia; tauto.
Qed.
Lemma pair_slow : ~ decays 2 complete (fun _ _ => 8 * / 32) (on_line (at2 1)) (1 / 2).
Proof.
  intros D. assert (Q : sqrt (1 / 2) * sqrt (1 / 2) = 1 / 2) by (apply sqrt_sqrt; lra). assert (L : 1 / 2 < sqrt (1 / 2)).
  { rewrite <- (sqrt_pow2 (1 / 2)) at 1 by lra. apply sqrt_lt_1_alt. lra. }
  assert (U : sqrt (1 / 2) < 1). { rewrite <- sqrt_1 at 2. apply sqrt_lt_1_alt. lra. }
  destruct (D (RtoC (-1 + sqrt (1 / 2))) (fun i => match i with 0%nat => RtoC 1 | _ => RtoC (-1) end) (fun _ => 0%C)) as [E|E].
  - destruct (line_ex (at2 1) 0 1 ltac:(cbn; lra)) as [E1 E2].
    intros [|[|]] Hi; try lia; cbv zeta; rewrite !Csum_2; cbn [complete Nat.eqb negb]; rewrite !line_ey; rewrite ?E1; rewrite ?E2;
      split; apply injective_projections; cbn; lra.
  - exists 0%nat. split; [lia|]. left. intros E. apply (f_equal fst) in E. cbn in E. lra.
  - cbn in E. lra.
  - cbn in E. lra.
Qed.
Lemma rate_1_holds : rate_1.
Proof.
  intros Q. apply pair_slow. assert (D : forall i j, (i < 2)%nat -> (j < 2)%nat -> complete i j = true -> Cmod (on_line (at2 1) i - on_line (at2 1) j)%C = 1).
  { intros i j Hi Hj L. rewrite line_distance. destruct i as [|[|]], j as [|[|]]; try lia; try discriminate L; cbn; unfold Rabs; destruct (Rcase_abs _); lra. }
  refine (Q 2%nat complete _ _ _ _ _ 2%nat complete _ _ _ _ _ 2 (1 / 2) (soft_at_distances 1 2 complete _ Rlt_0_1 (le_n 2) complete_simple (complete_joined 2) D)
    (soft_at_distances (/ 32) 2 complete _ _ (le_n 2) complete_simple (complete_joined 2) D) pair_lambda2 pair_lambda2 _ pair_decays); lra.
Qed.
Lemma three_modes k s x y : mode 3 three (fun _ _ => k) (on_line INR) s x y ->
  (s * s * (x 0%nat + x 1%nat + x 2%nat) = 0 /\ (s * s + RtoC 1 * s + RtoC k) * (x 0%nat - x 2%nat) = 0 /\
   (s * s + RtoC 3 * s + RtoC (3 * k)) * (x 0%nat + x 2%nat - RtoC 2 * x 1%nat) = 0 /\
   s * s * (y 0%nat + y 1%nat + y 2%nat) = 0 /\ (s * s + RtoC 1 * s + RtoC 0) * (y 0%nat - y 2%nat) = 0 /\
   (s * s + RtoC 3 * s + RtoC 0) * (y 0%nat + y 2%nat - RtoC 2 * y 1%nat) = 0)%C.
Proof.
  intros M. destruct (M 0%nat ltac:(lia)) as [A0 B0]. destruct (M 1%nat ltac:(lia)) as [A1 B1]. destruct (M 2%nat ltac:(lia)) as [A2 B2]. clear M.
  cbv zeta in A0, A1, A2, B0, B1, B2. rewrite !Csum_3 in A0, A1, A2, B0, B1, B2.
  cbn [three links_of existsb Nat.eqb fst snd andb orb] in A0, A1, A2, B0, B1, B2. 
  repeat rewrite line_ey in A0. repeat rewrite line_ey in A1. repeat rewrite line_ey in A2. repeat rewrite line_ey in B0. repeat rewrite line_ey in B1. repeat rewrite line_ey in B2.
  destruct (line_ex INR 0 1 ltac:(cbn; lra)) as [E1 E2]. destruct (line_ex INR 1 2 ltac:(cbn; lra)) as [E3 E4].
  assert (N1 : RtoC (-1) = (- RtoC 1)%C) by (apply injective_projections; cbn; ring).
  rewrite !E1 in A0. rewrite !E1 in B0. rewrite !E2 in A1. rewrite !E2 in B1. rewrite !E3 in A1. rewrite !E3 in B1. rewrite !E4 in A2. rewrite !E4 in B2.
  rewrite !N1 in A0. rewrite !N1 in B0. rewrite !N1 in A1. rewrite !N1 in B1.
  replace (RtoC (3 * k)) with (RtoC 3 * RtoC k)%C by (apply injective_projections; cbn; ring).
  assert (N2 : RtoC 2 = (RtoC 1 + RtoC 1)%C) by (apply injective_projections; cbn; ring). rewrite N2.
  assert (N3 : RtoC 3 = (RtoC 1 + RtoC 1 + RtoC 1)%C) by (apply injective_projections; cbn; ring). rewrite N3.
  match type of A0 with ?a0 = _ => match type of A1 with ?a1 = _ => match type of A2 with ?a2 = _ =>
    match type of B0 with ?b0 = _ => match type of B1 with ?b1 = _ => match type of B2 with ?b2 = _ =>
    split; [|split; [|split; [|split; [|split]]]];
    [transitivity (a0 + a1 + a2)%C; [|rewrite A0, A1, A2; ring]|transitivity (a0 - a2)%C; [|rewrite A0, A2; ring]
    |transitivity (a0 + a2 - (RtoC 1 + RtoC 1) * a1)%C; [|rewrite A0, A1, A2; ring]
    |transitivity (b0 + b1 + b2)%C; [|rewrite B0, B1, B2; ring]|transitivity (b0 - b2)%C; [|rewrite B0, B2; ring]
    |transitivity (b0 + b2 - (RtoC 1 + RtoC 1) * b1)%C; [|rewrite B0, B1, B2; ring]] end end end end end end; ring.
Qed.
Lemma three_gaps (a b c : C) : (a + b + c = 0)%C -> (a - c = 0)%C -> (a + c - RtoC 2 * b = 0)%C -> a = 0%C /\ b = 0%C /\ c = 0%C.
Proof.
  intros E F G. pose proof (f_equal fst E). pose proof (f_equal snd E). pose proof (f_equal fst F). pose proof (f_equal snd F).
  pose proof (f_equal fst G). pose proof (f_equal snd G). cbn in *. repeat split; apply injective_projections; cbn; lra.
Qed.
Lemma three_decays : decays 3 three (fun _ _ => 8 * / 32) (on_line INR) (1 / 5).
Proof.
  intros s x y M (i & Hi & N). destruct (three_modes _ s x y M) as (X0 & X1 & X2 & Y0 & Y1 & Y2). apply amplitude0 in X0. apply amplitude0 in Y0.
  apply (amplitude _ _ (1 / 5)) in X1; [|lra|right; lra]. apply (amplitude _ _ (1 / 5)) in Y1; [|lra|now left].
  apply (amplitude _ _ (1 / 5)) in X2; [|lra|right; lra]. apply (amplitude _ _ (1 / 5)) in Y2; [|lra|now left].
  destruct X0 as [X0|X0]; [now left|]. destruct Y0 as [Y0|Y0]; [now left|]. destruct X1 as [X1|[X1|X1]]; [now left|now right|]. destruct Y1 as [Y1|[Y1|Y1]]; [now left|now right|].
  destruct X2 as [X2|[X2|X2]]; [now left|now right|]. destruct Y2 as [Y2|[Y2|Y2]]; [now left|now right|].
  exfalso. destruct (three_gaps _ _ _ X0 X1 X2) as (? & ? & ?), (three_gaps _ _ _ Y0 Y1 Y2) as (? & ? & ?). destruct i as [|[|[|]]]; try lia; tauto.
Qed.
Definition corners (i : nat) : C := match i with 0%nat => (0, 0) | 1%nat => (1, 0) | _ => (1 / 2, sqrt 3 / 2) end.
Lemma sqrt_3 : sqrt 3 * sqrt 3 = 3.
Proof. apply sqrt_sqrt. lra. Qed.
Lemma corners_distance i j : (i < 3)%nat -> (j < 3)%nat -> complete i j = true -> Cmod (corners i - corners j)%C = 1.
Proof.
  intros Hi Hj L. pose proof sqrt_3 as Q. unfold Cmod. rewrite <- sqrt_1. f_equal.
  destruct i as [|[|[|]]], j as [|[|[|]]]; try lia; try discriminate L; cbn; nra.
Qed.
Lemma corners_slow : ~ decays 3 complete (fun _ _ => 8 * / 32) corners (1 / 5).
Proof.
  intros D. assert (Q : sqrt (15 / 2) * sqrt (15 / 2) = 15 / 2) by (apply sqrt_sqrt; lra). pose proof (sqrt_pos (15 / 2)) as P.
  assert (L : 13 / 5 < sqrt (15 / 2)) by nra. assert (U : sqrt (15 / 2) < 3) by nra.
  set (q := sqrt (15 / 2)) in *. pose proof sqrt_3 as Q3. set (h := sqrt 3) in *.
  destruct (D (RtoC ((-3 + q) / 2)) (fun i => match i with 0%nat => RtoC (- h) | 1%nat => RtoC h | _ => 0%C end)
    (fun i => match i with 0%nat => RtoC 1 | 1%nat => RtoC 1 | _ => RtoC (-2) end)) as [E|E].
  - assert (K : forall i j, (i < 3)%nat -> (j < 3)%nat -> complete i j = true -> Cmod (corners i - corners j)%C = 1) by exact corners_distance.
    assert (S2 : (-3 + q) / 2 * ((-3 + q) / 2) = - 3 * ((-3 + q) / 2) - 3 / 8) by nra. set (s := (-3 + q) / 2) in *.
    pose proof (f_equal (Rmult h) S2) as S3. pose proof (f_equal (Rmult h) Q3) as Q4.
    intros i Hi; cbv zeta; rewrite !Csum_3.
    destruct i as [|[|[|]]]; try lia; cbn [complete Nat.eqb negb]; repeat rewrite K by (try lia; reflexivity); unfold corners; fold h;
      split; apply injective_projections; cbn; lra.
  - exists 0%nat. split; [lia|]. right. intros E. apply (f_equal fst) in E. cbn in E. lra.
  - cbn in E. lra.
  - cbn in E. lra.
Qed.
Lemma three_lambda2 : lambda2 3 three 1.
Proof.
  split.
  - intros x Z. unfold form, lap, deg, w, delta, three, links_of. cbn [Sum Nat.eqb existsb fst snd andb orb] in *.
    assert (E : x 2%nat = - x 0%nat - x 1%nat) by lra. rewrite E. pose proof (pow2_ge_0 (x 1%nat)). lra.
  - exists (fun i => match i with 0%nat => 1 | 1%nat => 0 | _ => -1 end). cbn [Sum]. split; [ring|]. split; [lra|].
    intros [|[|[|]]] Hi; try lia; unfold lap, deg, w, delta, three, links_of; cbn [Sum Nat.eqb existsb fst snd andb orb]; ring.
Qed.
Lemma corners_lambda2 : lambda2 3 complete 3.
Proof.
  split.
  - intros x Z. unfold form, lap, deg, w, delta, complete. cbn [Sum Nat.eqb negb] in *.
    assert (E : x 2%nat = - x 0%nat - x 1%nat) by lra. rewrite E. right. ring.
  - exists (fun i => match i with 0%nat => 1 | 1%nat => 0 | _ => -1 end). cbn [Sum]. split; [ring|]. split; [lra|].
    intros [|[|[|]]] Hi; try lia; unfold lap, deg, w, delta, complete; cbn [Sum Nat.eqb negb]; ring.
Qed.
Lemma rate_2_holds : rate_2.
Proof.
  intros Q. apply corners_slow. assert (P : 0 < / 32) by lra.
  refine (Q 3%nat three complete _ _ _ _ _ _ 1 3 (1 / 5) (soft_at_distances (/ 32) 3 three _ P _ three_simple three_joined _)
    (soft_at_distances (/ 32) 3 complete _ P _ complete_simple (complete_joined 3) corners_distance) _ three_lambda2 corners_lambda2 _ _ three_decays); try lra; try lia.
  - intros i j Hi Hj L. rewrite line_distance.
    destruct i as [|[|[|]]], j as [|[|[|]]]; try lia; try discriminate L; cbn; unfold Rabs; destruct (Rcase_abs _); lra.
  - intros i j L. unfold complete. destruct (Nat.eqb_spec i j) as [->|]; [|reflexivity]. rewrite (proj2 three_simple) in L. discriminate.
Qed.
(* V = 3 s^2 + 8/s^2 of the theorem: the minimum is at the fourth root of 8/3, where alone V' vanishes *)
Lemma root4 : exists d, 0 < d /\ d ^ 4 = 8 / 3.
Proof.
  exists (sqrt (sqrt (8 / 3))). assert (P : 0 < sqrt (8 / 3)) by (apply sqrt_lt_R0; lra). split; [now apply sqrt_lt_R0|].
  replace (sqrt (sqrt (8 / 3)) ^ 4) with ((sqrt (sqrt (8 / 3)) ^ 2) ^ 2) by ring. rewrite pow2_sqrt by lra. apply pow2_sqrt. lra.
Qed.
Lemma fourth_power s d : 0 < s -> 0 < d -> s ^ 4 = d ^ 4 -> s = d.
Proof.
  intros Hs Hd E. assert (F : (s - d) * ((s + d) * (s * s + d * d)) = 0) by (replace (_ * _) with (s ^ 4 - d ^ 4) by ring; lra).
  apply Rmult_integral in F. destruct F as [F|F]; [lra|]. exfalso. assert (0 < (s + d) * (s * s + d * d)) by (apply Rmult_lt_0_compat; nra). lra.
Qed.
Lemma thm1c_1_holds : thm1c_1.
Proof.
  intros Q. destruct root4 as (d & Hd & D4). set (V := tanner2_examples.VA) in *. set (V' := tanner2_examples.VA') in *.
  assert (D : def3 3 complete (fun _ _ => V) (fun _ _ => V') (fun _ _ => d)).
  { split; [apply potentials_of; [exact tanner2_examples.VA_potential|exact tanner2_examples.VA'_continuous]|].
    intros i j _ _ _. split; [exact Hd|]. intros s Hs N. unfold V, tanner2_examples.VA.
    assert (I : forall x, 0 < x -> 3 * x ^ 2 + 8 / x ^ 2 = 3 * (x - d ^ 2 / x) ^ 2 + 6 * d ^ 2).
    { intros x Hx. replace 8 with (3 * d ^ 4) by lra. field. lra. }
    rewrite !I by assumption. replace (d - d ^ 2 / d) with 0 by (field; lra). assert (0 < (s - d ^ 2 / s) ^ 2); [|lra].
    apply pow2_gt_0. intros E. apply N. assert (F : (s - d ^ 2 / s) * s = 0) by (rewrite E; ring).
    replace ((s - d ^ 2 / s) * s) with ((s - d) * (s + d)) in F by (field; lra). apply Rmult_integral in F. lra. }
  assert (Z : forall i j s, (i < 3)%nat -> (j < 3)%nat -> complete i j = true -> 0 < s -> V' s = 0 -> s = d).
  { intros _ _ s _ _ _ Hs E. apply fourth_power; try assumption. rewrite D4. unfold V', tanner2_examples.VA' in E.
    assert (F : (6 * s - 16 / s ^ 3) * s ^ 3 = 0) by (rewrite E; ring). replace ((6 * s - 16 / s ^ 3) * s ^ 3) with (6 * s ^ 4 - 16) in F by (field; lra). lra. }
  assert (M : motion 3 complete (fun _ _ => V') (fun i _ => tanner2_examples.line3 i) (fun _ _ => 0%C)).
  { split; [exact tanner2_examples.line3_apart|]. intros t i Ht Hi. split; [apply rest_velocity|]. intros _. rewrite law4_is.
    destruct tanner2_examples.line3_solution as (_ & _ & _ & _ & _ & _ & _ & _ & _ & _ & S). now apply (S t i). }
  assert (A : apart_at 3 complete tanner2_examples.better).
  { intros i j Hi Hj L. destruct i as [|[|[|]]], j as [|[|[|]]]; try lia; try discriminate L; intros E; injection E; lra. }
  destruct (Q 3%nat complete _ _ _ _ _ complete_simple (complete_joined 3) D Z M 0%nat ltac:(lia) _ A 1 Rlt_0_1) as [T B].
  specialize (B T (Rle_refl T)). cbv beta zeta in B. cbn [Sum complete Nat.eqb negb] in B.
  unfold tanner2_examples.line3, tanner2_examples.better in B. rewrite <- !RtoC_minus, !Cmod_R in B.
  rewrite (Rabs_left (-1 - 0)), (Rabs_left (-1 - 1)), (Rabs_left (0 - 5 / 4)), (Rabs_pos_eq (0 - - (5 / 4))) in B by lra.
  replace (V (- (-1 - 0))) with 11 in B by (unfold V, tanner2_examples.VA; field). replace (V (- (-1 - 1))) with 14 in B by (unfold V, tanner2_examples.VA; field).
  replace (V (- (0 - 5 / 4))) with (3923 / 400) in B by (unfold V, tanner2_examples.VA; field). replace (V (0 - - (5 / 4))) with (3923 / 400) in B by (unfold V, tanner2_examples.VA; field). lra.
Qed.
Lemma pair_oriented : tanner_graph.oriented 2 complete ((0%nat, 1%nat) :: nil).
Proof.
  split; [repeat constructor; intros []|]. split.
  - intros i j [E|[]]. injection E as <- <-. lia.
  - intros i j Hi Hj. unfold member, w, complete. destruct i as [|[|]], j as [|[|]]; try lia;
      repeat match goal with |- context [in_dec ?p ?e ?l] => destruct (in_dec p e l) as [I|I] end;
      cbn in *; try lra; exfalso; repeat match goal with H : _ \/ _ |- _ => destruct H as [H|H] end; try congruence; tauto.
Qed.
Lemma vdotB_1_holds : vdotB_1.
Proof.
  intros Q. destruct (Q 2%nat complete _ _ _ (on_line (at2 2)) (fun _ => 0%C) _ complete_simple (complete_joined 2) (spring_def3 2 complete) (pair_apart 2 ltac:(lra))
    (fun _ _ _ _ => eq_refl) pair_oriented 0%nat ltac:(lia)) as [_ E]. apply (f_equal fst) in E.
  assert (V : spring' 2 = 15 / 4) by (unfold spring'; lra).
  unfold law4, gradV, pull in E. rewrite !Csum_2 in E. cbn [complete Nat.eqb negb lsum fold_right fst snd] in E. unfold inc, delta in E. cbn [Nat.eqb fst snd] in E.
  rewrite !line_distance in E. unfold at2 in E. rewrite !(Rabs_left (0 - 2)) in E by lra. replace (- (0 - 2)) with 2 in E by ring. rewrite V in E.
  unfold on_line in E. cbn in E. lra.
Qed.
Lemma gradient_unique f x g h : gradient f x g -> gradient f x h -> g = h.
Proof.
  intros G H. assert (K : forall z, inner g z = inner h z).
  { intros z. pose proof (is_derive_unique _ _ _ (G z)) as A. pose proof (is_derive_unique _ _ _ (H z)) as B. congruence. }
  pose proof (K (RtoC 1)) as A. pose proof (K Ci) as B. rewrite !inner_xy in A, B. cbn in A, B. apply injective_projections; lra.
Qed.
Lemma lsum_agree O (f g : nat * nat -> R) : (forall e, In e O -> f e = g e) -> lsum O f = lsum O g.
Proof.
  intros H. induction O as [|e O IH]; [reflexivity|]. change (f e + lsum O f = g e + lsum O g). rewrite (H e (or_introl eq_refl)), IH; [reflexivity|]. intros; apply H. now right.
Qed.
Lemma oriented_edge n adj O i j : tanner_graph.oriented n adj O -> In (i, j) O -> (i < n)%nat /\ (j < n)%nat /\ adj i j = true.
Proof.
  intros (_ & B & M) I. destruct (B i j I) as [Hi Hj]. split; [exact Hi|]. split; [exact Hj|]. specialize (M i j Hi Hj). unfold member, w in M.
  destruct (in_dec pair_dec (i, j) O); [|contradiction]. destruct (adj i j); [reflexivity|]. destruct (in_dec pair_dec (j, i) O); lra.
Qed.
Lemma eq8_234_holds : eq8_234.
Proof.
  intros n adj V V' r v t O g gi gj G [S NL] VS D A U HO HG HGi by_pair by_ends.
  set (q := fun i => r i t). set (p := fun i j => pull adj (both V') q i j).
  assert (Db : forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> is_derive (both V i j) (norm (q i - q j)%C) (both V' i j (norm (q i - q j)%C))).
  { intros i j Hi Hj L. pose proof (tanner_flock.norm_neq _ _ (A i j Hi Hj L)) as N. apply both_derive; [exact VS|now apply D|]. apply D; try assumption. now rewrite S. }
  assert (Gr : forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> g i j = p i j /\ gi i j = p i j /\ gj i j = (- p i j)%C).
  { intros i j Hi Hj L. destruct (HG i j Hi Hj L) as (G1 & G2 & G3).
    assert (P : p i j = grad (both V' i j) (q i) (q j)) by (unfold p, pull; rewrite L; reflexivity).
    pose proof (fun w => tanner_energy.tanner1_eq8_gradients (both V i j) (both V' i j) (q i) (q j) w (A i j Hi Hj L) (Db i j Hi Hj L)) as T. rewrite <- P in T.
    split; [|split].
    - apply (gradient_unique _ _ _ _ G1). intros z. destruct (T z) as (_ & _ & T3). revert T3. apply is_derive_ext. intros h. now apply both_V.
    - apply (gradient_unique _ _ _ _ G2). intros z. destruct (T z) as (T1 & _ & _). revert T1. apply is_derive_ext. intros h. now apply both_V.
    - apply (gradient_unique _ _ _ _ G3). intros z. destruct (T z) as (_ & T2 & _). apply (D_eq _ _ (- inner (p i j) z)).
      + revert T2. apply is_derive_ext. intros h. now apply both_V.
      + rewrite !inner_xy. cbn. ring. }
  assert (GG : forall i, (i < n)%nat -> G i = Csum n (p i)).
  { intros i Hi. apply (gradient_unique _ _ _ _ (HGi i Hi)). intros w. rewrite inner_sym, inner_Csum. apply D_Sum. intros j Hj.
    destruct (adj i j) eqn:L.
    - destruct (HG i j Hi Hj L) as (_ & G2 & _). rewrite inner_sym, <- (proj1 (proj2 (Gr i j Hi Hj L))). apply G2.
    - eapply D_eq; [apply D_const|]. unfold p, pull. rewrite L, inner_xy. cbn. ring. }
  assert (Ps : forall i j, p j i = (- p i j)%C).
  { intros i j. unfold p, pull. rewrite (S j i), (both_sym V' j i). replace (q j - q i)%C with (- (q i - q j))%C by ring. rewrite Cmod_opp.
    destruct (adj i j); [ring|apply injective_projections; cbn; ring]. }
  assert (E1 : by_pair = Sum n (fun i => inner (v i t) (Csum n (p i)))).
  { transitivity (lsum O (fun f => inner (v (fst f) t - v (snd f) t)%C (p (fst f) (snd f)))).
    - apply lsum_agree. intros [i j] I. cbn [fst snd]. destruct (oriented_edge n adj O i j HO I) as (Hi & Hj & L). now rewrite (proj1 (Gr i j Hi Hj L)).
    - rewrite (tanner_graph.lsum_oriented n adj O (fun f => inner (v (fst f) t - v (snd f) t)%C (p (fst f) (snd f))) HO).
      + etransitivity; [|exact (tanner_energy.pair_sum_swap n p v t (fun i j _ _ => Ps i j))]. f_equal. apply Sum_ext. intros k _. apply Sum_ext. intros j _. cbn [fst snd].
        rewrite (Ps k j). unfold w. destruct (adj k j) eqn:L; [rewrite !inner_xy; cbn; ring|].
        replace (p k j) with (RtoC 0) by (unfold p, pull; now rewrite L). rewrite !inner_xy. cbn. ring.
      + intros i j. cbn [fst snd]. rewrite (Ps i j), !inner_xy. cbn. ring. }
  assert (E2 : by_pair = by_ends).
  { apply lsum_agree. intros [i j] I. cbn [fst snd]. destruct (oriented_edge n adj O i j HO I) as (Hi & Hj & L).
    destruct (Gr i j Hi Hj L) as (-> & -> & ->). rewrite !inner_xy. cbn. ring. }
  assert (E3 : Sum n (fun i => inner (v i t) (Csum n (p i))) = Sum n (fun i => inner (v i t) (G i))) by (apply Sum_ext; intros i Hi; now rewrite GG).
  split; [|split; [exact E2|now rewrite <- E2, E1]].
  apply (is_derive_ext (fun s => / 2 * Sum n (fun i => V_i n adj (both V) (fun i => r i s) i))).
  - intros s. f_equal. apply Sum_ext. intros i _. apply Sum_ext. intros j _. unfold w. rewrite (both_V V) by exact VS. unfold norm. destruct (adj i j); ring.
  - rewrite E1. eapply D_eq; [apply (tanner_energy.eq8_potential n adj (both V) (both V') r v t S (both_sym V') U A Db)|].
    apply Sum_ext. intros i _. f_equal. apply Csum_ext. intros j _. symmetry. apply pull_is.
Qed.
(* ---- solutions after Definition 4 ---- *)
Lemma arbswitch_2_holds : arbswitch_2.
Proof. exact tanner2_filippov.velocities_agree. Qed.
Lemma eq14_switching_holds : eq14_switching.
Proof. exact tanner2_filippov.equal_stay. Qed.
(* the hypotheses can be met: two agents at rest at the desired distance 1, linked below R = 2 *)
Lemma motion10_met : motion10 2 (fun _ _ => spring') 2 (fun i _ => on_line (at2 1) i) (fun _ _ => 0%C) /\ strongly_connected 2 (by_distance (on_line (at2 1)) 2).
Proof.
  assert (D : forall i j, (i < 2)%nat -> (j < 2)%nat -> i <> j -> Cmod (on_line (at2 1) i - on_line (at2 1) j)%C = 1).
  { intros i j Hi Hj Ne. rewrite line_distance. destruct i as [|[|]], j as [|[|]]; try lia; cbn; unfold Rabs; destruct (Rcase_abs _); lra. }
  assert (L : forall i, (i < 2)%nat -> law4 2 (by_distance (on_line (at2 1)) 2) (fun _ _ => spring') (on_line (at2 1)) (fun _ => 0%C) i = 0%C).
  { intros i Hi. etransitivity; [exact (tanner2_filippov.law4_one 2 _ _ _ _ i)|]. apply Csum_0. intros j Hj. unfold tanner2_filippov.pull. destruct (by_distance (on_line (at2 1)) 2 i j) eqn:B; [|ring].
    assert (Ne : i <> j) by (intros ->; rewrite (proj2 (tanner2_filippov.by_distance_simple _ _) : forall i, by_distance _ _ i i = false) in B; discriminate). rewrite (D i j Hi Hj Ne), spring_rest. unfold Rdiv. rewrite Rmult_0_l. ring. }
  split.
  - split; [apply pair_apart; lra|]. split; [intros; apply rest_velocity|]. split.
    + intros i _ T e _ He. exists 1. split; [lra|]. intros m a b _ _ _. rewrite Sum_zero; [exact He|]. intros k _. replace (0 - 0)%C with (RtoC 0) by ring. apply Cmod_0.
    + exists (fun _ => False). split; [apply tanner2_filippov.negligible_none|]. intros t _ _ _. exists (fun _ => 0%C). split; [|intros; apply rest_velocity].
      exists 1%nat, (fun _ => 1), (fun _ _ => 0%C). split; [|split; [cbn; ring|intros i _; apply injective_projections; cbn; ring]].
      intros k _. split; [lra|]. intros e He. exists (on_line (at2 1)), (fun _ => 0%C). split; [|split].
      * intros i _. replace (on_line (at2 1) i - on_line (at2 1) i)%C with (RtoC 0) by ring. replace (0 - 0)%C with (RtoC 0) by ring. rewrite Cmod_0. lra.
      * intros i j Hi Hj Ne. rewrite (D i j Hi Hj Ne). lra.
      * intros i Hi. rewrite (L i Hi). replace (0 - 0)%C with (RtoC 0) by ring. now rewrite Cmod_0.
  - intros j k Hj Hk. destruct (Nat.eq_dec k j) as [->|Ne]; [apply rt_refl|]. apply rt_step. repeat split; try assumption. unfold by_distance.
    destruct (Nat.eqb_spec k j); [contradiction|]. rewrite (D k j Hk Hj Ne). cbn. destruct (Rlt_dec 1 2); [reflexivity|lra].
Qed.

(* ---- not independent: corrected clauses from their words, but after theorems on them had been seen ---- *)
(* tanner2.S_config clause 2 *)
Definition S_config_2 : Prop := forall n adj V V' r v t, simple_graph adj -> strongly_connected n adj -> potentials n adj V V' ->
  motion n adj V' r v -> 0 <= t -> Wdot n adj V r v t 0 -> forall i j, (i < n)%nat -> (j < n)%nat ->
  v i t = v j t /\ is_velocity (fun s => r i s - r j s)%C t 0%C.
(* tanner2.cor2_sub clause 2 *)
Definition cor2_sub_2 : Prop := forall n adj V V' r v t lam xp xn yp yn w, (2 <= n)%nat -> simple_graph adj -> strongly_connected n adj ->
  potentials n adj V V' -> motion n adj V' r v -> 0 <= t -> lambda2 n adj lam -> parts n (fun i => v i t) xp xn yp yn -> Wdot n adj V r v t w ->
  w <= - lam * (Sum n (fun i => xn i ^ 2) + Sum n (fun i => yn i ^ 2)).
(* tanner2.vdotB clause 2; the minus sign with 1 for outgoing edges is the same formula *)
Definition vdotB_2 : Prop := forall n adj V V' r v O, simple_graph adj -> potentials n adj V V' -> apart_at n adj r ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> v i = v j) -> tanner_graph.oriented n adj O -> forall k, (k < n)%nat ->
  law4 n adj V' r v k = (lsum O (fun f => inc k f * fst (pull adj V' r (fst f) (snd f))), lsum O (fun f => inc k f * snd (pull adj V' r (fst f) (snd f)))).
(* tanner2.cor2_rate clause 3 in the plane: with lambda_2, and equality where the deviations are eigenvectors *)
Definition rate_3_plane : Prop := forall n adj lam (v : nat -> R -> C), (2 <= n)%nat -> simple_graph adj -> strongly_connected n adj -> lambda2 n adj lam ->
  (forall t i, 0 <= t -> (i < n)%nat -> is_velocity (v i) t (- Csum n (fun j => if adj i j then v i t - v j t else 0))%C) ->
  let mean t := (RtoC (/ INR n) * Csum n (fun j => v j t))%C in let dev t := sqrt (Sum n (fun i => Cmod (v i t - mean t)%C ^ 2)) in
  forall t, 0 <= t -> dev t <= exp (- lam * t) * dev 0 /\
    ((forall i, (i < n)%nat -> Csum n (fun j => RtoC (lap n adj i j) * (v j 0 - mean 0))%C = (RtoC lam * (v i 0 - mean 0))%C) -> dev t = exp (- lam * t) * dev 0).
(* tanner2.cor2_rate clause 4 *)
Definition rate_4 : Prop := forall n adj more lam mu, (2 <= n)%nat -> simple_graph adj -> simple_graph more ->
  (forall i j, adj i j = true -> more i j = true) -> lambda2 n adj lam -> lambda2 n more mu -> lam <= mu.
(* tanner2.thm2_coll clause 1, for motions for all times: a collision is not excluded by what a motion is, and connected or not *)
Definition thm2_coll : Prop := forall n V V' R0 r v, 0 < R0 -> potentials n complete V V' -> motion10 n V' R0 r v ->
  forall t i j, 0 <= t -> (i < n)%nat -> (j < n)%nat -> i <> j -> r i t <> r j t.
Lemma S_config_2_holds : S_config_2.
Proof.
  intros n adj V V' r v t S SC P M Ht Z i j Hi Hj.
  assert (U : forall i, (i < n)%nat -> is_velocity (r i) t (v i t) /\ is_velocity (v i) t (law4 n adj V' (fun i => r i t) (fun i => v i t) i)).
  { intros k Hk. split; [now apply (proj2 M t k)|now apply (moves_law n adj V)]. }
  pose proof (eq9_proved n adj V V' r v t S (proj1 P) (slopes_of n adj V V' P) (apart_always n adj V V' r v S P M t Ht) U) as E.
  cbv zeta in E. apply is_derive_unique in E. rewrite (is_derive_unique _ _ _ Z), !form_is in E.
  assert (Q : v i t = v j t).
  { apply (tanner2_facts.S_config_corrected n adj (fun i => v i t)); try assumption; [lia|apply S|]. rewrite tanner_energy.kron_split. cbv beta in *. lra. }
  split; [exact Q|]. replace (RtoC 0) with (v i t - v j t)%C by (rewrite Q; ring). apply tanner_energy.velocity_minus; now apply U.
Qed.
Lemma cor2_sub_2_holds : cor2_sub_2.
Proof.
  intros n adj V V' r v t lam xp xn yp yn w Hn S SC P M Ht [Lam _] Pa W.
  assert (U : forall i, (i < n)%nat -> is_velocity (r i) t (v i t) /\ is_velocity (v i) t (law4 n adj V' (fun i => r i t) (fun i => v i t) i)).
  { intros k Hk. split; [now apply (proj2 M t k)|now apply (moves_law n adj V)]. }
  pose proof (cor2_decomp_holds n adj V V' r v t xp xn yp yn S (proj1 P) (slopes_of n adj V V' P) (apart_always n adj V V' r v S P M t Ht) U Pa) as E.
  unfold Wdot in *. apply is_derive_unique in E. rewrite (is_derive_unique _ _ _ W) in E. destruct Pa as (_ & Zx & Zy & _). pose proof (Lam xn Zx). pose proof (Lam yn Zy). lra.
Qed.
Lemma vdotB_2_holds : vdotB_2.
Proof.
  intros n adj V V' r v O [S NL] P A Eq HO k Hk. pose proof (slopes_of n adj V V' P) as D.
  assert (L : law4 n adj V' r v k = (- grad_i n adj (both V') r k)%C).
  { destruct (both_law n adj V V' r v k S (proj1 P) D Hk A) as (_ & G & _). unfold law4. rewrite <- G, gradV_is.
    rewrite Csum_0; [ring|]. intros j Hj. destruct (adj k j); [rewrite (Eq k j Hk Hj); ring|reflexivity]. }
  destruct (tanner_graph.B_gradients n adj O (both V') r k S (both_sym V') HO Hk) as [B1 B2]. unfold tanner_graph.applyB in B1, B2.
  assert (K : forall f, In f O -> pull adj V' r (fst f) (snd f) = grad (both V' (fst f) (snd f)) (r (fst f)) (r (snd f))).
  { intros [i j] I. cbn [fst snd]. destruct (oriented_edge n adj O i j HO I) as (Hi & Hj & Lij).
    destruct (both_law n adj V V' r v i S (proj1 P) D Hi A) as (Q & _). rewrite <- (Q j Hj). unfold pull. rewrite Lij. reflexivity. }
  rewrite L. apply injective_projections; cbn [fst snd Copp].
  - rewrite <- B1. apply lsum_agree. intros f I. now rewrite (K f I).
  - rewrite <- B2. apply lsum_agree. intros f I. now rewrite (K f I).
Qed.
Lemma rate_3_plane_holds : rate_3_plane.
Proof.
  intros n adj lam v Hn [S NL] SC [Lam _] Mv mean dev t Ht. assert (n1 : (1 <= n)%nat) by lia. assert (Pn : 0 < INR n) by (apply lt_0_INR; lia).
  set (m := mean 0). set (u := fun (i : nat) (t : R) => (v i t - m)%C).
  assert (Mu : forall t i, 0 <= t -> (i < n)%nat -> is_velocity (u i) t (- Csum n (fun j => RtoC (w adj i j) * (u i t - u j t)))%C).
  { intros x i Hx Hi. replace (- Csum n (fun j => RtoC (w adj i j) * (u i x - u j x)))%C with (- Csum n (fun j => if adj i j then v i x - v j x else 0) - 0)%C.
    - apply tanner_energy.velocity_minus; [now apply Mv|apply rest_velocity].
    - replace (- Csum n (fun j => if adj i j then v i x - v j x else 0) - 0)%C with (- Csum n (fun j => if adj i j then v i x - v j x else 0))%C by ring.
      f_equal. apply Csum_ext. intros j _. unfold w, u. destruct (adj i j); ring. }
  assert (Dv : forall x, tanner2_facts.deviation n (fun i => u i x) = dev x).
  { intros x. unfold tanner2_facts.deviation, dev. f_equal. apply Sum_ext. intros i _. f_equal. unfold norm. f_equal. unfold centre, mean, u.
    replace (Csum n (fun i => v i x - m)%C) with (Csum n (fun i => v i x) - RtoC (INR n) * m)%C.
    - apply injective_projections; cbn; field; lra.
    - apply injective_projections; cbn; rewrite Sum_plus, Sum_const; ring. }
  destruct (tanner2_facts.alignment_rate n adj lam u n1 S Mu) as [B1 B2]. rewrite <- !Dv. split.
  - apply B1; [exact Lam|exact Ht].
  - intros E. apply B2; [exact E|exact Ht].
Qed.
Lemma rate_4_holds : rate_4.
Proof.
  intros n adj more lam mu Hn [S _] [S' _] H [L _] [_ (x & Zx & Px & Ex)].
  destruct (tanner2_facts.more_edges n adj more S S' H) as [F _]. pose proof (L x Zx) as A. pose proof (F x) as B. unfold form in A. rewrite form_is in A.
  assert (C : qform n (lap n more) x = mu * Sum n (fun i => x i ^ 2)).
  { unfold qform. rewrite <- Sum_scal. apply Sum_ext. intros i Hi. rewrite (Ex i Hi). ring. }
  apply (Rmult_le_reg_r (Sum n (fun i => x i ^ 2))); [exact Px|]. lra.
Qed.
Lemma thm2_coll_holds : thm2_coll.
Proof.
  intros n V V' R0 r v HR P M t i j Ht Hi Hj Ne E. destruct (tanner2_filippov.kept_apart n V V' R0 r v HR P M) as (d & Hd & Far). specialize (Far t i j Ht Hi Hj Ne).
  rewrite E in Far. replace (r j t - r j t)%C with (RtoC 0) in Far by ring. rewrite Cmod_0 in Far. lra.
Qed.
(* the loop of cor2_rate is that of (4), linearised: the derivative of the forces at the desired distances *)
Lemma linearised n adj V V' d k r (x y : nat -> R) i : at_distances n adj V V' d k r -> (i < n)%nat ->
  let ex j := fst (r i - r j)%C / Cmod (r i - r j)%C in let ey j := snd (r i - r j)%C / Cmod (r i - r j)%C in
  let stretch j := k i j * (ex j * (x i - x j) + ey j * (y i - y j)) in
  is_velocity (fun h => gradV n adj V' (fun j => r j + RtoC h * (x j, y j))%C i) 0
    (Sum n (fun j => if adj i j then ex j * stretch j else 0), Sum n (fun j => if adj i j then ey j * stretch j else 0)).
Proof.
  intros (_ & S & _ & (P & Md) & Ds) Hi ex ey stretch.
  assert (K : forall j, (j < n)%nat -> is_velocity (fun h => pull adj V' (fun j => r j + RtoC h * (x j, y j))%C i j) 0
    (if adj i j then ex j * stretch j else 0, if adj i j then ey j * stretch j else 0)).
  { intros j Hj. unfold pull. destruct (adj i j) eqn:L; [|split; apply D_const]. destruct (Ds i j Hi Hj L) as [Di Dk]. destruct (Md i j Hi Hj L) as [Dp Mn].
    assert (Z : V' i j (d i j) = 0).
    { destruct P as [_ P]. destruct (P i j Hi Hj L) as (P1 & _). destruct (P1 (d i j) Dp) as (Dv & _).
      assert (Ex : derivable_pt_lim (V i j) (d i j) (V' i j (d i j))) by now apply is_derive_Reals.
      set (pr := exist _ _ Ex : derivable_pt (V i j) (d i j)). pose proof (deriv_minimum (V i j) (d i j / 2) (d i j + 1) (d i j) pr ltac:(lra) ltac:(lra)) as Q.
      assert (E : derive_pt (V i j) (d i j) pr = V' i j (d i j)) by reflexivity. rewrite <- E. apply Q. intros u H1 H2. destruct (Req_dec u (d i j)) as [->|Nu]; [lra|]. left. apply Mn; lra. }
    set (u := fun h => (r i + RtoC h * (x i, y i) - (r j + RtoC h * (x j, y j)))%C).
    assert (U : is_velocity u 0 ((x i - x j), (y i - y j))).
    { destruct (line_velocity (r i - r j)%C (x i - x j, y i - y j) 0) as [A B]. split; [revert A|revert B]; apply is_derive_ext; intros h; unfold u; cbn; ring. }
    assert (U0 : u 0 = (r i - r j)%C) by (unfold u; ring).
    assert (N0 : u 0 <> RtoC 0) by (rewrite U0; intros E; rewrite E, Cmod_0 in Di; lra).
    pose proof (tanner_energy.D_norm u 0 _ U N0) as Dn. change (is_derive (fun h => Cmod (u h)) 0 (inner (u 0) (x i - x j, y i - y j) / Cmod (u 0))) in Dn.
    assert (Dk' : is_derive (V' i j) (Cmod (u 0)) (k i j)) by (rewrite U0, Di; exact Dk).
    assert (Dq : is_derive (fun h => V' i j (Cmod (u h)) / Cmod (u h)) 0 (k i j * (inner (u 0) (x i - x j, y i - y j) / Cmod (u 0)) / d i j)).
    { eapply D_eq; [apply (is_derive_div (fun h => V' i j (Cmod (u h))) (fun h => Cmod (u h)) 0 _ _ (D_comp (V' i j) (fun h => Cmod (u h)) 0 (k i j) _ Dk' Dn) Dn)|].
      - rewrite U0, Di. lra.
      - rewrite U0, Di, Z. field. lra. }
    destruct U as [U1 U2]. split; cbn [fst snd].
    - apply (is_derive_ext (fun h => V' i j (Cmod (u h)) / Cmod (u h) * fst (u h))); [intros h; unfold u; cbn; ring|].
      eapply D_eq; [apply (D_mult _ _ 0 _ _ Dq U1)|]. rewrite U0, Di, Z, inner_xy. unfold stretch, ex, ey. rewrite Di. cbn. field. lra.
    - apply (is_derive_ext (fun h => V' i j (Cmod (u h)) / Cmod (u h) * snd (u h))); [intros h; unfold u; cbn; ring|].
      eapply D_eq; [apply (D_mult _ _ 0 _ _ Dq U2)|]. rewrite U0, Di, Z, inner_xy. unfold stretch, ex, ey. rewrite Di. cbn. field. lra. }
  split; unfold gradV, Csum; cbn [fst snd].
  - apply (D_Sum n (fun j h => fst (pull adj V' (fun j => r j + RtoC h * (x j, y j))%C i j)) (fun j => if adj i j then ex j * stretch j else 0)). intros j Hj. apply (K j Hj).
  - apply (D_Sum n (fun j h => snd (pull adj V' (fun j => r j + RtoC h * (x j, y j))%C i j)) (fun j => if adj i j then ey j * stretch j else 0)). intros j Hj. apply (K j Hj).
Qed.
(* tanner2.thm2_coll clause 1 as long as a motion lasts: until T, of which the distance kept does not depend *)
Definition motion10_until T n V' R0 (r v : nat -> R -> C) := apart_at n complete (fun i => r i 0) /\
  (forall t i, 0 <= t < T -> (i < n)%nat -> is_velocity (r i) t (v i t)) /\
  (forall i, (i < n)%nat -> forall T' e, 0 < T' < T -> 0 < e -> exists d, 0 < d /\ forall m (a b : nat -> R),
    (forall k, (k < m)%nat -> 0 <= a k <= b k /\ b k <= T') -> (forall k, (Datatypes.S k < m)%nat -> b k <= a (Datatypes.S k)) ->
    Sum m (fun k => b k - a k) < d -> Sum m (fun k => Cmod (v i (b k) - v i (a k))%C) < e) /\
  exists N, negligible N /\ forall t, 0 <= t < T -> ~ N t -> apart_at n complete (fun i => r i t) ->
    exists z, K10 n V' R0 (fun i => r i t) (fun i => v i t) z /\ forall i, (i < n)%nat -> is_velocity (v i) t (z i).
Definition thm2_coll_until : Prop := forall n V V' R0 (r v : nat -> R -> C), 0 < R0 -> potentials n complete V V' -> apart_at n complete (fun i => r i 0) ->
  exists d, 0 < d /\ forall T, motion10_until T n V' R0 r v -> forall t i j, 0 <= t < T -> (i < n)%nat -> (j < n)%nat -> i <> j -> d < Cmod (r i t - r j t)%C.
Lemma thm2_coll_until_holds : thm2_coll_until.
Proof. exact tanner2_filippov.pairs_apart. Qed.
