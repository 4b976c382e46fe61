(* Clauses of the claims about Tanner's first paper, formalised from their words before the theorems were looked at. *)
From Coq Require Import Reals Lia Relations.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums paley_model paley_phase paley_laplacian tanner_energy tanner1_heading tanner1_motion.
Open Scope R_scope.

(* agents (1) with (4), (5) at time t; a i j is what the law takes for theta_i - theta_j; V' i j the derivative of V i j *)
Definition law (n : nat) (adj : graph) (V' : nat -> nat -> R -> R) (a : nat -> nat -> R) (r v : nat -> C) (i : nat) : C :=
  (- Csum n (fun j => if adj i j then RtoC (V' i j (Cmod (r i - r j)) / Cmod (r i - r j)) * (r i - r j) else 0)
   - RtoC (Sum n (fun j => if adj i j then a i j / Cmod (r i - r j)%C ^ 2 else 0)%R) * (Ci * v i))%C.
Definition loop n adj (V V' : nat -> nat -> R -> R) (r v : nat -> R -> C) (a : nat -> nat -> R -> R) t :=
  forall i, (i < n)%nat -> is_velocity (r i) t (v i t) /\
    is_velocity (v i) t (law n adj V' (fun i j => a i j t) (fun i => r i t) (fun i => v i t) i) /\
    forall j, (j < n)%nat -> adj i j = true -> r i t <> r j t /\
      is_derive (V i j) (Cmod (r i t - r j t)%C) (V' i j (Cmod (r i t - r j t)%C)).
Definition symmetric_V (V : nat -> nat -> R -> R) := forall i j s, V i j s = V j i s.
Definition kinetic_plus_V n (adj : graph) (V : nat -> nat -> R -> R) (r v : nat -> C) : R :=
  / 2 * Sum n (fun i => Sum n (fun j => if adj i j then V i j (Cmod (r i - r j)%C) else 0) + Cmod (v i) ^ 2).

(* beyond.tanner1.two_agents, clauses 1, 2, 3; headings ph of the velocities, which exist for moving agents *)
Definition pair_of (a : nat -> nat -> R -> R) (d : R -> R) := forall t, a 0%nat 1%nat t = d t /\ a 1%nat 0%nat t = - d t.
Definition two_agents_1 : Prop := forall adj V V' r v a d (ph : nat -> R), undirected adj -> adj 0%nat 1%nat = true ->
  symmetric_V V -> pair_of a d -> forall t, loop 2 adj V V' r v a t -> (forall i, v i t = (RtoC (Cmod (v i t)) * expi (ph i))%C) ->
  is_derive (fun s => / 2 * Cmod (v 0%nat s + v 1%nat s)%C ^ 2) t
    (2 * Cmod (v 0%nat t) * Cmod (v 1%nat t) * d t * sin (ph 0%nat - ph 1%nat) / Cmod (r 0%nat t - r 1%nat t)%C ^ 2).
Definition two_agents_2 : Prop := forall adj V V' r v a d (ph : nat -> R -> R), undirected adj -> adj 0%nat 1%nat = true ->
  symmetric_V V -> pair_of a d -> (forall t, 0 <= t -> loop 2 adj V V' r v a t) ->
  (forall t i, 0 <= t -> v i t = (RtoC (Cmod (v i t)) * expi (ph i t))%C) ->
  (forall t, 0 <= t -> - PI < d t <= PI /\ exists k : Z, d t = ph 0%nat t - ph 1%nat t + 2 * PI * IZR k) ->
  forall s t, 0 <= s <= t -> Cmod (v 0%nat s + v 1%nat s)%C <= Cmod (v 0%nat t + v 1%nat t)%C.
Definition two_agents_3 : Prop := forall adj V V' r v a d, undirected adj -> adj 0%nat 1%nat = true -> symmetric_V V -> pair_of a d ->
  (forall t, 0 <= t -> loop 2 adj V V' r v a t) -> forall t, 0 <= t ->
  kinetic_plus_V 2 adj V (fun i => r i t) (fun i => v i t) = kinetic_plus_V 2 adj V (fun i => r i 0) (fun i => v i 0).
(* tanner1.Vt_inv clauses 3, 4 and tanner1.propIV3b clause 2; whatever the law takes for the differences of headings *)
Definition Vt_inv_3 : Prop := forall n adj V V' r v a, undirected adj -> symmetric_V V -> (forall t, 0 <= t -> loop n adj V V' r v a t) ->
  forall t, 0 <= t -> kinetic_plus_V n adj V (fun i => r i t) (fun i => v i t) = kinetic_plus_V n adj V (fun i => r i 0) (fun i => v i 0).
(* tanner1.anyV clauses 3, 4: as long as the motion lasts, until T; that no linked agents meet is the conclusion *)
Definition loop_apart n adj (V' : nat -> nat -> R -> R) (r v : nat -> R -> C) a t :=
  forall i, (i < n)%nat -> is_velocity (r i) t (v i t) /\
    ((forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> r i t <> r j t) ->
     is_velocity (v i) t (law n adj V' (fun i j => a i j t) (fun i => r i t) (fun i => v i t) i)).
Definition start_apart n (adj : graph) (r : nat -> R -> C) := forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> r i 0 <> r j 0.
Definition repels (V V' : R -> R) := (forall s, 0 < s -> is_derive V s (V' s) /\ 0 <= V s) /\
  forall c, exists d, 0 < d /\ forall s, 0 < s < d -> c < V s.
Definition binds (V : R -> R) := forall c, exists D, forall s, D < s -> c < V s.
Definition anyV_3 : Prop := forall n adj V V' r v a T, undirected adj -> no_loops adj -> symmetric_V V ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> repels (V i j) (V' i j)) -> start_apart n adj r ->
  (forall t, 0 <= t <= T -> loop_apart n adj V' r v a t) ->
  forall t i j, 0 <= t <= T -> (i < n)%nat -> (j < n)%nat -> adj i j = true -> r i t <> r j t.
Definition anyV_4 : Prop := forall n adj V V' r v a, undirected adj -> no_loops adj -> symmetric_V V -> strongly_connected n adj ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> repels (V i j) (V' i j) /\ binds (V i j)) -> start_apart n adj r ->
  exists B, forall T, (forall t, 0 <= t <= T -> loop_apart n adj V' r v a t) ->
    forall t i j, 0 <= t <= T -> (i < n)%nat -> (j < n)%nat -> Cmod (r i t - r j t)%C <= B.
(* tanner1.collision clause 4, with the potential of Figure 2 *)
Definition fig2 (i j : nat) (s : R) := / s ^ 2 + ln (s ^ 2).
Definition fig2' (i j : nat) (s : R) := - 2 / s ^ 3 + 2 / s.
Definition collision_4 : Prop := forall n adj r v a T, undirected adj -> no_loops adj -> start_apart n adj r ->
  (forall t, 0 <= t <= T -> loop_apart n adj fig2' r v a t) ->
  (forall t i j, 0 <= t <= T -> (i < n)%nat -> (j < n)%nat -> adj i j = true -> r i t <> r j t) /\
  ((forall i j, (i < n)%nat -> (j < n)%nat -> i <> j -> adj i j = true) ->
   forall t i j, 0 <= t <= T -> (i < n)%nat -> (j < n)%nat -> i <> j -> r i t <> r j t).
(* tanner1.eq7 clause 2: the heading th_i of a moving agent, differentiable at t *)
Definition eq7_2 : Prop := forall n adj V V' r v (th : nat -> R -> R) i t, (i < n)%nat ->
  loop n adj V V' r v (fun i j s => th i s - th j s) t -> v i t <> 0%C -> ex_derive (th i) t ->
  locally t (fun s => v i s = (RtoC (Cmod (v i s)) * expi (th i s))%C) ->
  is_derive (th i) t (- Sum n (fun j => if adj i j then (th i t - th j t) / Cmod (r i t - r j t)%C ^ 2 else 0)
    - cross (v i t) (Csum n (fun j => if adj i j then RtoC (V' i j (Cmod (r i t - r j t)%C) / Cmod (r i t - r j t)) * (r i t - r j t) else 0))%C
      / Cmod (v i t) ^ 2).
(* tanner1.eq6 clauses 1, 2, 3; no motion is needed: vdot_i is what the law says *)
Definition eq6_123 : Prop := forall n adj V' (r v : nat -> C) (th : nat -> R), undirected adj -> symmetric_V V' ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> r i <> r j) ->
  let q i j := if adj i j then (th i - th j) / Cmod (r i - r j)%C ^ 2 else 0 in
  let pull i j := (if adj i j then RtoC (V' i j (Cmod (r i - r j)) / Cmod (r i - r j)) * (r i - r j) else 0)%C in
  Sum n (fun i => Sum n (fun j => cross (r i) (pull i j))) = 0 /\
  Sum n (fun i => cross (r i) (law n adj V' (fun i j => th i - th j) r v i)) =
  - Sum n (fun i => cross (r i) (Csum n (fun j => RtoC (q i j) * (Ci * v i))%C)).
