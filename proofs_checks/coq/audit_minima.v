(* Audit of the stability of minima of the sum of all potentials: each theorem of theorems.tsv with its statement written out; the objects of the statements are restated first. *)
From Coq Require Import Reals.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums paley_model paley_phase tanner_energy tanner_flock tanner2_motion.
From Flockproof Require tanner2_apart tanner2_lasting tanner2_minima.
Open Scope R_scope.

Check (eq_refl : norm = Cmod).
Check (eq_refl : grad = fun V' ri rj => (RtoC (V' (Cmod (ri - rj)%C) / Cmod (ri - rj)%C) * (ri - rj))%C).
Check (eq_refl : grad_i = fun n adj V' r i => Csum n (fun j => RtoC (w adj i j) * grad (V' i j) (r i) (r j))%C).
Check (eq_refl : tanner2_apart.all_apart = fun n r => forall i j, (i < n)%nat -> (j < n)%nat -> i <> j -> r i <> r j).
Check (eq_refl : tanner2_apart.sum_of_all = fun n V r => Sum n (fun i => Sum n (fun j => if Nat.eqb i j then 0 else V i j (norm (r i - r j)%C)))).
Check (eq_refl : tanner2_apart.not_above = fun n V r q => tanner2_apart.all_apart n q -> tanner2_apart.all_apart n r /\ tanner2_apart.sum_of_all n V r <= tanner2_apart.sum_of_all n V q).
Check (eq_refl : tanner2_apart.below = fun n V r q => tanner2_apart.all_apart n q -> tanner2_apart.all_apart n r /\ tanner2_apart.sum_of_all n V r < tanner2_apart.sum_of_all n V q).
Check (eq_refl : tanner2_apart.moved_by = fun n a b r q => Cmod a = 1 /\ forall i, (i < n)%nat -> q i = (a * r i + b)%C).
Check (eq_refl : tanner2_apart.strict_minimum = fun n V r => exists d, 0 < d /\ forall q, (forall i, (i < n)%nat -> norm (q i - r i)%C < d) ->
  tanner2_apart.not_above n V r q /\ (tanner2_apart.below n V r q \/ exists a b, tanner2_apart.moved_by n a b r q)).

(* ---- tanner2.sec4.flocking (corrected), clause 1: V_ij = V_ji as functions of the distance ---- *)
Check (eq_refl : complete = fun k j => negb (Nat.eqb k j)).
Check (eq_refl : is_velocity = fun r t v => is_derive (fun s => fst (r s)) t (fst v) /\ is_derive (fun s => snd (r s)) t (snd v)).
Check (eq_refl : control4 = fun n adj V' r v i => (- Csum n (fun j => RtoC (w adj i j) * (v i - v j)) - grad_i n adj V' r i)%C).
Check (eq_refl : distinct = fun n adj r => forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> r i <> r j).
Check (eq_refl : potential = fun V V' => (forall s, 0 < s -> is_derive V s (V' s) /\ 0 <= V s) /\
  (forall c, exists d, 0 < d /\ forall s, 0 < s < d -> c < V s) /\ (forall c, exists D, forall s, D < s -> c < V s)).
Check (eq_refl : moves = fun n adj V' r v t => (forall i, (i < n)%nat -> is_velocity (r i) t (v i t)) /\
  (distinct n adj (fun i => r i t) -> forall i, (i < n)%nat -> is_velocity (v i) t (control4 n adj V' (fun i => r i t) (fun i => v i t) i))).
Check (eq_refl : tanner2_lasting.lasting = fun n adj V' =>
  (forall r0 v0, distinct n adj r0 -> exists r v, (forall i, (i < n)%nat -> r i 0 = r0 i /\ v i 0 = v0 i) /\ forall t, 0 <= t -> moves n adj V' r v t) /\
  forall T r v, 0 < T -> distinct n adj (fun i => r i 0) -> (forall t, 0 <= t < T -> moves n adj V' r v t) ->
    exists r' v', (forall t i, t < T -> (i < n)%nat -> r' i t = r i t /\ v' i t = v i t) /\ forall t, 0 <= t -> moves n adj V' r' v' t).
Check (eq_refl : tanner2_minima.rel_near = fun n e q p => forall i j, (i < n)%nat -> (j < n)%nat -> Cmod (q i - q j - (p i - p j))%C < e).
Check (eq_refl : tanner2_minima.near_orbit = fun n e s q => exists a, Cmod a = 1 /\ tanner2_minima.rel_near n e q (fun i => (a * s i)%C)).
Check (eq_refl : tanner2_minima.on_orbit = fun n s q => exists a b, tanner2_apart.moved_by n a b s q).
Check (eq_refl : tanner2_minima.isolated = fun n V' s => exists d, 0 < d /\ forall q, tanner2_minima.near_orbit n d s q -> tanner2_apart.all_apart n q ->
  (forall i, (i < n)%nat -> grad_i n complete V' q i = 0%C) -> tanner2_minima.on_orbit n s q).
Check (eq_refl : tanner2_minima.motion = fun n V' r v => distinct n complete (fun i => r i 0) /\ forall t, 0 <= t -> moves n complete V' r v t).
Check (eq_refl : tanner2_minima.close_to = fun n s e q u => tanner2_minima.near_orbit n e s q /\ forall i j, (i < n)%nat -> (j < n)%nat -> Cmod (u i - u j)%C < e).
Check (eq_refl : tanner2_minima.stable = fun n V' s => forall e, 0 < e -> exists d, 0 < d /\ forall r v, tanner2_minima.motion n V' r v ->
  tanner2_minima.close_to n s d (fun i => r i 0) (fun i => v i 0) -> forall t, 0 <= t -> tanner2_minima.close_to n s e (fun i => r i t) (fun i => v i t)).
Check (eq_refl : tanner2_minima.attractive = fun n V' s => exists d, 0 < d /\ forall r v, tanner2_minima.motion n V' r v ->
  tanner2_minima.close_to n s d (fun i => r i 0) (fun i => v i 0) -> forall e, 0 < e -> exists T, forall t, T <= t -> tanner2_minima.close_to n s e (fun i => r i t) (fun i => v i t)).
Check (tanner2_minima.minima_attract : forall (n : nat) (V V' : nat -> nat -> R -> R) (s : nat -> C), (2 <= n)%nat -> (forall i j, V i j = V j i) -> (forall i j, V' i j = V' j i) ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> complete i j = true -> potential (V i j) (V' i j)) ->
  (forall i j x, (i < n)%nat -> (j < n)%nat -> complete i j = true -> 0 < x -> continuity_pt (V' i j) x) ->
  tanner2_apart.strict_minimum n V s -> tanner2_minima.isolated n V' s ->
  (forall q c, tanner2_minima.on_orbit n s q -> forall t, moves n complete V' (fun i t => (q i + RtoC t * c)%C) (fun _ _ => c) t) /\
  tanner2_lasting.lasting n complete V' /\ tanner2_minima.stable n V' s /\ tanner2_minima.attractive n V' s).
