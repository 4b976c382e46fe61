(* Audit of solutions of (10), links by distance, that start and last: each theorem of theorems.tsv with its statement written out; the objects of the statements
  are restated first. *)
From Coq Require Import Reals.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums paley_model paley_phase.
From Flockproof Require tanner2_filippov tanner2_solutions tanner2_onward tanner2_limits tanner2_approach.
Open Scope R_scope.

(* Links join agents nearer than R0. K at a state is the convex hull of the limits of the whole law from states without a pair at the distance R0. Velocities are
   absolutely continuous, with derivatives in K but on a set of measure zero; positions have the velocities as derivatives. *)
Check (eq_refl : is_velocity = fun r t v => is_derive (fun s => fst (r s)) t (fst v) /\ is_derive (fun s => snd (r s)) t (snd v)).
Check (eq_refl : complete = fun k j => negb (Nat.eqb k j)).
Check (eq_refl : tanner2_filippov.pull = fun adj V' r i j =>
  (if adj i j then RtoC (V' i j (Cmod (r i - r j)) / Cmod (r i - r j)) * (r i - r j) else 0)%C).
Check (eq_refl : tanner2_filippov.law4 = fun n adj V' r v i =>
  (- Csum n (fun j => if adj i j then v i - v j else 0) - Csum n (tanner2_filippov.pull adj V' r i))%C).
Check (eq_refl : tanner2_filippov.by_distance = fun r R0 i j =>
  (negb (Nat.eqb i j) && if Rlt_dec (Cmod (r i - r j)%C) R0 then true else false)%bool).
Check (eq_refl : tanner2_filippov.apart_at = fun n adj r => forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> r i <> r j).
Check (eq_refl : tanner2_filippov.potentials = fun n adj V V' => (forall i j s, V i j s = V j i s) /\
  forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true ->
    (forall s, 0 < s -> is_derive (V i j) s (V' i j s) /\ continuity_pt (V' i j) s /\ 0 <= V i j s) /\
    (forall c, exists d, 0 < d /\ forall s, 0 < s < d -> c < V i j s) /\ (forall c, exists D, forall s, D < s -> c < V i j s)).
Check (eq_refl : tanner2_filippov.limit_of_law = fun n V' R0 r v y => forall e, 0 < e -> exists q u : nat -> C,
  (forall i, (i < n)%nat -> Cmod (q i - r i)%C < e /\ Cmod (u i - v i)%C < e) /\
  (forall i j, (i < n)%nat -> (j < n)%nat -> i <> j -> Cmod (q i - q j)%C <> R0) /\
  forall i, (i < n)%nat -> Cmod (tanner2_filippov.law4 n (tanner2_filippov.by_distance q R0) V' q u i - y i)%C < e).
Check (eq_refl : tanner2_filippov.K10 = fun n V' R0 r v z => exists m (c : nat -> R) (y : nat -> nat -> C),
  (forall k, (k < m)%nat -> 0 <= c k /\ tanner2_filippov.limit_of_law n V' R0 r v (y k)) /\ Sum m c = 1 /\
  forall i, (i < n)%nat -> z i = Csum m (fun k => RtoC (c k) * y k i)%C).
Check (eq_refl : tanner2_filippov.absolutely_continuous = fun z => forall T e, 0 < T -> 0 < e -> exists d, 0 < d /\ forall m (a b : nat -> R),
  (forall k, (k < m)%nat -> 0 <= a k <= b k /\ b k <= T) -> (forall k, (S k < m)%nat -> b k <= a (S k)) ->
  Sum m (fun k => b k - a k) < d -> Sum m (fun k => Cmod (z (b k) - z (a k))%C) < e).
Check (eq_refl : tanner2_filippov.negligible = fun N => forall e, 0 < e -> exists a b : nat -> R, (forall k, a k <= b k) /\
  (forall t, N t -> exists k, a k < t < b k) /\ forall m, Sum m (fun k => b k - a k) <= e).
Check (eq_refl : tanner2_filippov.motion10 = fun n V' R0 r v => tanner2_filippov.apart_at n complete (fun i => r i 0) /\
  (forall t i, 0 <= t -> (i < n)%nat -> is_velocity (r i) t (v i t)) /\
  (forall i, (i < n)%nat -> tanner2_filippov.absolutely_continuous (v i)) /\
  exists N, tanner2_filippov.negligible N /\ forall t, 0 <= t -> ~ N t -> tanner2_filippov.apart_at n complete (fun i => r i t) ->
    exists z, tanner2_filippov.K10 n V' R0 (fun i => r i t) (fun i => v i t) z /\ forall i, (i < n)%nat -> is_velocity (v i) t (z i)).

(* ---- tanner2.eq10_exist (corrected, clause 1) ---- *)
Check (tanner2_solutions.solution_from :
  forall (n : nat) (V V' : nat -> nat -> R -> R) (R0 : R) (q0 u0 : nat -> C), 0 < R0 -> tanner2_filippov.potentials n complete V V' -> tanner2_filippov.apart_at n complete q0 ->
  exists r v : nat -> R -> C, (forall i, (i < n)%nat -> r i 0 = q0 i /\ v i 0 = u0 i) /\ tanner2_filippov.motion10 n V' R0 r v).

(* ---- tanner2.thm2_vel; tanner2.arbswitch (corrected, clause 1): solutions until T, and those for all time ---- *)
Check (eq_refl : tanner2_filippov.motion10_until = fun T n V' R0 r v => tanner2_filippov.apart_at n complete (fun i => r i 0) /\
  (forall t i, 0 <= t < T -> (i < n)%nat -> is_velocity (r i) t (v i t)) /\
  (forall i, (i < n)%nat -> forall T' e, 0 < T' < T -> 0 < e -> exists d, 0 < d /\ forall m (a b : nat -> R),
    (forall k, (k < m)%nat -> 0 <= a k <= b k /\ b k <= T') -> (forall k, (S k < m)%nat -> b k <= a (S k)) ->
    Sum m (fun k => b k - a k) < d -> Sum m (fun k => Cmod (v i (b k) - v i (a k))%C) < e) /\
  exists N, tanner2_filippov.negligible N /\ forall t, 0 <= t < T -> ~ N t -> tanner2_filippov.apart_at n complete (fun i => r i t) ->
    exists z, tanner2_filippov.K10 n V' R0 (fun i => r i t) (fun i => v i t) z /\ forall i, (i < n)%nat -> is_velocity (v i) t (z i)).
Check (eq_refl : tanner2_onward.solutions_last = fun n V' R0 =>
  (forall q0 u0, tanner2_filippov.apart_at n complete q0 -> exists r v, (forall i, (i < n)%nat -> r i 0 = q0 i /\ v i 0 = u0 i) /\ tanner2_filippov.motion10 n V' R0 r v) /\
  forall T (r v : nat -> R -> C), 0 < T -> tanner2_filippov.motion10_until T n V' R0 r v ->
    exists r' v', (forall t i, t < T -> r' i t = r i t /\ v' i t = v i t) /\ tanner2_filippov.motion10 n V' R0 r' v').
Check (tanner2_onward.all_solutions_agree :
  forall (n : nat) (V V' : nat -> nat -> R -> R) (R0 : R), 0 < R0 -> tanner2_filippov.potentials n complete V V' -> tanner2_onward.solutions_last n V' R0 /\
  forall r v, tanner2_filippov.motion10 n V' R0 r v -> (forall t, 0 <= t -> strongly_connected n (tanner2_filippov.by_distance (fun i => r i t) R0)) ->
    forall i j, (i < n)%nat -> (j < n)%nat -> forall e, 0 < e -> exists T, forall t, T <= t -> Cmod (v i t - v j t)%C < e).

(* ---- tanner2.thm2_pot (corrected): near critical configurations, those with 0 in K of the gradients of all agents together ---- *)
Check (eq_refl : tanner2_filippov.gradV = fun n adj V' r i => Csum n (tanner2_filippov.pull adj V' r i)).
Check (eq_refl : tanner2_limits.generic = fun n R0 q => forall i j, (i < n)%nat -> (j < n)%nat -> i <> j -> Cmod (q i - q j)%C <> R0).
Check (eq_refl : tanner2_approach.limit_of_gradients = fun n V' R0 r y => forall e, 0 < e -> exists q : nat -> C, (forall i, (i < n)%nat -> Cmod (q i - r i)%C < e) /\
  tanner2_limits.generic n R0 q /\ forall i, (i < n)%nat -> Cmod (tanner2_filippov.gradV n (tanner2_filippov.by_distance q R0) V' q i - y i)%C < e).
Check (eq_refl : tanner2_approach.K_gradients = fun n V' R0 r z => exists m (c : nat -> R) (y : nat -> nat -> C),
  (forall k, (k < m)%nat -> 0 <= c k /\ tanner2_approach.limit_of_gradients n V' R0 r (y k)) /\ Sum m c = 1 /\
  forall i, (i < n)%nat -> z i = Csum m (fun k => RtoC (c k) * y k i)%C).
Check (eq_refl : tanner2_approach.critical = fun n V' R0 r => tanner2_filippov.apart_at n complete r /\ tanner2_approach.K_gradients n V' R0 r (fun _ => RtoC 0)).
Check (tanner2_approach.all_solutions_approach :
  forall (n : nat) (V V' : nat -> nat -> R -> R) (R0 : R), 0 < R0 -> tanner2_filippov.potentials n complete V V' -> tanner2_onward.solutions_last n V' R0 /\
  (forall r v, tanner2_filippov.motion10 n V' R0 r v -> (forall t, 0 <= t -> strongly_connected n (tanner2_filippov.by_distance (fun i => r i t) R0)) ->
    forall e, 0 < e -> exists T, forall t, T <= t -> exists q, tanner2_approach.critical n V' R0 q /\ forall i, (i < n)%nat -> Cmod (r i t - q i)%C < e) /\
  forall q, tanner2_approach.critical n V' R0 q -> tanner2_limits.generic n R0 q -> forall i, (i < n)%nat ->
    tanner2_filippov.gradV n (tanner2_filippov.by_distance q R0) V' q i = RtoC 0).
