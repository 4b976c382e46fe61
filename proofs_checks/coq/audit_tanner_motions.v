(* Audit of the motions of both papers of Tanner, Jadbabaie and Pappas: that they last, and what they do; angles and the set Omega.
   Each theorem of theorems.tsv with its statement written out; the objects of the statements are restated first. *)
From Coq Require Import Reals Lra Lia Relations List.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums paley_model paley_phase paley_laplacian paley_gradient paley_particles tanner_energy tanner_flock tanner2_motion tanner_trees tanner1_heading.
From Flockproof Require tanner2_lasting tanner_angle tanner2_collision.
Open Scope R_scope.

Check (eq_refl : is_velocity = fun r t v => is_derive (fun s => fst (r s)) t (fst v) /\ is_derive (fun s => snd (r s)) t (snd v)).
Check (eq_refl : grad = fun V' ri rj => (RtoC (V' (Cmod (ri - rj)%C) / Cmod (ri - rj)%C) * (ri - rj))%C).
Check (eq_refl : grad_i = fun n adj V' r i => Csum n (fun j => (RtoC (w adj i j) * grad (V' i j) (r i) (r j))%C)).
Check (eq_refl : control4 = fun n adj V' r v i => (- Csum n (fun j => RtoC (w adj i j) * (v i - v j)) - grad_i n adj V' r i)%C).
Check (eq_refl : distinct = fun n adj r => forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> r i <> r j).
Check (eq_refl : potential = fun V V' => (forall s, 0 < s -> is_derive V s (V' s) /\ 0 <= V s) /\
  (forall c, exists d, 0 < d /\ forall s, 0 < s < d -> c < V s) /\ (forall c, exists D, forall s, D < s -> c < V s)).
Check (eq_refl : moves = fun n adj V' r v t => (forall i, (i < n)%nat -> is_velocity (r i) t (v i t)) /\
  (distinct n adj (fun i => r i t) -> forall i, (i < n)%nat -> is_velocity (v i) t (control4 n adj V' (fun i => r i t) (fun i => v i t) i))).
Check (eq_refl : tree = fun n adj => strongly_connected n adj /\ forall a b, arc n adj a b -> ~ strongly_connected n (without adj a b)).
Check (eq_refl : Vt = fun n adj V r v th => / 2 * Sum n (fun i => V_i n adj V r i + inner (v i) (v i) + th i ^ 2)).
Check (eq_refl : tends = fun z l => is_lim_seq (fun k => fst (z k)) (fst l) /\ is_lim_seq (fun k => snd (z k)) (snd l)).
(* motions last: one for all t >= 0 from every start, and every motion until T is the beginning of one *)
Check (eq_refl : tanner2_lasting.lasting = fun n adj V' =>
  (forall r0 v0, distinct n adj r0 -> exists r v, (forall i, (i < n)%nat -> r i 0 = r0 i /\ v i 0 = v0 i) /\ forall t, 0 <= t -> moves n adj V' r v t) /\
  forall T r v, 0 < T -> distinct n adj (fun i => r i 0) -> (forall t, 0 <= t < T -> moves n adj V' r v t) ->
    exists r' v', (forall t i, t < T -> (i < n)%nat -> r' i t = r i t /\ v' i t = v i t) /\ forall t, 0 <= t -> moves n adj V' r' v' t).
(* tanner2.thm1a, tanner2.thm1c (corrected), tanner2.cor1 (corrected) *)
Check (tanner2_lasting.all_agree : forall (n : nat) (adj : graph) (V V' : nat -> nat -> R -> R),
  undirected adj -> no_loops adj -> (forall i j, V i j = V j i) -> (forall i j, V' i j = V' j i) ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> potential (V i j) (V' i j)) ->
  (forall i j s, (i < n)%nat -> (j < n)%nat -> adj i j = true -> 0 < s -> continuity_pt (V' i j) s) ->
  (1 <= n)%nat -> strongly_connected n adj ->
  tanner2_lasting.lasting n adj V' /\
  forall r v : nat -> R -> C, distinct n adj (fun i => r i 0) -> (forall t, 0 <= t -> moves n adj V' r v t) ->
    forall i j, (i < n)%nat -> (j < n)%nat -> forall e, 0 < e -> exists T, 0 <= T /\ forall t, T <= t -> norm (v i t - v j t)%C < e).
Check (tanner2_lasting.all_forces_vanish : forall (n : nat) (adj : graph) (V V' : nat -> nat -> R -> R),
  undirected adj -> no_loops adj -> (forall i j, V i j = V j i) -> (forall i j, V' i j = V' j i) ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> potential (V i j) (V' i j)) ->
  (forall i j s, (i < n)%nat -> (j < n)%nat -> adj i j = true -> 0 < s -> continuity_pt (V' i j) s) ->
  (1 <= n)%nat -> strongly_connected n adj ->
  tanner2_lasting.lasting n adj V' /\
  forall r v : nat -> R -> C, distinct n adj (fun i => r i 0) -> (forall t, 0 <= t -> moves n adj V' r v t) ->
    forall e, 0 < e -> exists T, 0 <= T /\ forall t i, T <= t -> (i < n)%nat -> norm (grad_i n adj V' (fun j => r j t) i) < e).
Check (tanner2_lasting.all_tree_distances : forall (n : nat) (adj : graph) (V V' : nat -> nat -> R -> R),
  undirected adj -> no_loops adj -> (forall i j, V i j = V j i) -> (forall i j, V' i j = V' j i) ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> potential (V i j) (V' i j)) ->
  (forall i j s, (i < n)%nat -> (j < n)%nat -> adj i j = true -> 0 < s -> continuity_pt (V' i j) s) ->
  (1 <= n)%nat -> strongly_connected n adj -> tree n adj ->
  tanner2_lasting.lasting n adj V' /\
  forall r v : nat -> R -> C, distinct n adj (fun i => r i 0) -> (forall t, 0 <= t -> moves n adj V' r v t) ->
    forall m : nat -> nat -> R, (forall i j s, (i < n)%nat -> (j < n)%nat -> adj i j = true -> 0 < s -> V' i j s = 0 -> s = m i j) ->
    forall a b, (a < n)%nat -> (b < n)%nat -> adj a b = true ->
    forall e, 0 < e -> exists T, 0 <= T /\ forall t, T <= t -> Rabs (norm (r a t - r b t)%C - m a b) < e).
Check (tanner2_lasting.all_tree_forces_vanish : forall (n : nat) (adj : graph) (V V' : nat -> nat -> R -> R),
  undirected adj -> no_loops adj -> (forall i j, V i j = V j i) -> (forall i j, V' i j = V' j i) ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> potential (V i j) (V' i j)) ->
  (forall i j s, (i < n)%nat -> (j < n)%nat -> adj i j = true -> 0 < s -> continuity_pt (V' i j) s) ->
  (1 <= n)%nat -> strongly_connected n adj -> tree n adj ->
  tanner2_lasting.lasting n adj V' /\
  forall r v : nat -> R -> C, distinct n adj (fun i => r i 0) -> (forall t, 0 <= t -> moves n adj V' r v t) ->
    forall a b, (a < n)%nat -> (b < n)%nat -> adj a b = true ->
    forall e, 0 < e -> exists T, 0 <= T /\ forall t, T <= t -> norm (grad (V' a b) (r a t) (r b t)) < e).

(* tanner1.eq2, tanner2.eq2 (corrected): the angle in (-pi, pi], and the two-argument arctangent *)
Check (eq_refl : tanner_angle.is_angle = fun v a => - PI < a <= PI /\ fst v = Cmod v * cos a /\ snd v = Cmod v * sin a).
Check (tanner_angle.arctan2_formulas : forall x y : R, (0 < x -> tanner_angle.arctan2 y x = atan (y / x)) /\ (0 < y -> tanner_angle.arctan2 y x = PI / 2 - atan (x / y)) /\
  (y < 0 -> tanner_angle.arctan2 y x = - (PI / 2) - atan (x / y)) /\ (x < 0 -> y = 0 -> tanner_angle.arctan2 y x = PI)).
Check (tanner_angle.arctan2_angle : forall v : C, v <> RtoC 0 -> tanner_angle.is_angle v (tanner_angle.arctan2 (snd v) (fst v)) /\
  forall a, tanner_angle.is_angle v a -> a = tanner_angle.arctan2 (snd v) (fst v)).
(* tanner1.Omega.bounded, clause 3, tanner1.Omega.closed: relative positions, velocities and angles; linked agents are apart *)
Check (eq_refl : tanner_angle.in_Omega = fun n adj V c x v th => (forall i, (i < n)%nat -> - PI <= th i <= PI) /\
  exists r : nat -> C, (forall i j, (i < n)%nat -> (j < n)%nat -> x i j = (r i - r j)%C) /\ distinct n adj r /\ Vt n adj V r v th <= c).
Check (tanner_angle.Omega_angles : forall (n : nat) (adj : graph) (V : nat -> nat -> R -> R) (c : R) (x : nat -> nat -> C) (v : nat -> C) (th : nat -> R) (i : nat),
  tanner_angle.in_Omega n adj V c x v th -> (i < n)%nat -> - PI <= th i <= PI).
Check (tanner_angle.Omega_limits : forall (n : nat) (adj : graph) (V V' : nat -> nat -> R -> R) (c : R) (x : nat -> nat -> nat -> C) (v : nat -> nat -> C) (th : nat -> nat -> R)
    (y : nat -> nat -> C) (u : nat -> C) (al : nat -> R),
  undirected adj -> no_loops adj -> (forall i j, V i j = V j i) ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> potential (V i j) (V' i j)) ->
  (forall k, tanner_angle.in_Omega n adj V c (x k) (v k) (th k)) ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> tends (fun k => x k i j) (y i j)) ->
  (forall i, (i < n)%nat -> tends (fun k => v k i) (u i)) ->
  (forall i, (i < n)%nat -> is_lim_seq (fun k => th k i) (al i)) -> tanner_angle.in_Omega n adj V c y u al).

(* tanner2.noninter: any graph, any pair that is not linked *)
Check (tanner2_collision.unlinked_collide : forall (n : nat) (adj : graph) (V V' : nat -> nat -> R -> R) (i j : nat),
  undirected adj -> no_loops adj -> (forall a b, V a b = V b a) -> (forall a b, V' a b = V' b a) ->
  (forall a b, (a < n)%nat -> (b < n)%nat -> adj a b = true -> potential (V a b) (V' a b)) ->
  (forall a b s, (a < n)%nat -> (b < n)%nat -> adj a b = true -> 0 < s -> continuity_pt (V' a b) s) ->
  (i < n)%nat -> (j < n)%nat -> i <> j -> adj i j = false ->
  exists r v : nat -> R -> C, distinct n adj (fun k => r k 0) /\ (forall t, 0 <= t -> moves n adj V' r v t) /\ r i 0 <> r j 0 /\ exists T, 0 < T /\ r i T = r j T).
