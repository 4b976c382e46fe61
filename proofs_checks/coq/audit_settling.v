(* Audit of limits of the particle model (perpendicular motion, drift, beacon) and of the stationary points of U_m: each theorem of theorems.tsv with its
  statement written out; the objects of the statements are restated first. *)
From Coq Require Import Reals.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums paley_model paley_phase paley_laplacian paley_gradient paley_particles.
From Flockproof Require paley_patterns paley_isolated paley_settling.
Open Scope R_scope.

Check (eq_refl : expi = fun t => (cos t, sin t)).
Check (eq_refl : inner = fun x y => Re (Cconj x * y)%C).
Check (eq_refl : is_velocity = fun r t v => is_derive (fun s => fst (r s)) t (fst v) /\ is_derive (fun s => snd (r s)) t (snd v)).
Check (eq_refl : lap = fun n adj k j => delta k j * deg n adj k - w adj k j).
Check (eq_refl : row = fun n A k x => Csum n (fun j => RtoC (A k j) * x j)%C).
Check (eq_refl : circle_centre = fun w0 r th => (r + RtoC (/ w0) * (Ci * expi th))%C).
Check (eq22 : forall n adj w0 K0 K1, (1 <= n)%nat -> w0 <> 0 -> forall r th t k,
  control5 n adj w0 K0 K1 r th t k = w0 + (K1 - K0) / INR n * gW n adj (fun j => th j t) k
    + w0 * (K0 / INR n) * inner (expi (th k t)) (row n (lap n adj) k (fun j => r j t))).
Check (gW_sines : forall n adj th k, (k < n)%nat -> gW n adj th k = Sum n (fun j => w adj k j * sin (th k - th j))).

(* ---- paley.Um, clause 3 ---- *)
Check (eq_refl : partial = fun f th k d => is_derive (fun s : R => f (upd th k s)) (th k) d).
Check (eq_refl : stationary = fun n f th => forall k, (k < n)%nat -> partial f th k 0).
Check (eq_refl : saddle = fun n f th => stationary n f th /\ forall e, 0 < e ->
    (exists a, (forall k, (k < n)%nat -> Rabs (a k - th k) < e) /\ f a > f th) /\
    (exists b, (forall k, (k < n)%nat -> Rabs (b k - th k) < e) /\ f b < f th)).
Check (eq_refl : paley_patterns.moment = fun n m th => (RtoC (/ (INR m * INR n)) * Csum n (fun k => expi (INR m * th k)))%C).
Check (eq_refl : paley_patterns.Um = fun n m th => INR n / 2 * Cmod (paley_patterns.moment n m th) ^ 2).
Check (paley_isolated.other_points :
  forall (n m : nat) (th : nat -> R), (1 <= n)%nat -> (1 <= m)%nat -> stationary n (paley_patterns.Um n m) th -> paley_patterns.moment n m th <> RtoC 0 ->
  ~ (forall j k, (j < n)%nat -> (k < n)%nat -> exists z : Z, INR m * (th j - th k) = 2 * PI * IZR z) ->
  saddle n (paley_patterns.Um n m) th /\
  exists e, 0 < e /\ forall th', (forall k, (k < n)%nat -> Rabs (th' k - th k) < e) -> stationary n (paley_patterns.Um n m) th' ->
    exists a, forall k, (k < n)%nat -> th' k = th k + a).

(* ---- paley.beacon.form, clause 3 ---- *)
Check (eq_refl : paley_settling.beaconed = fun n w0 K0 c0 r th => forall k t, (k < n)%nat -> 0 <= t ->
  is_velocity (r k) t (expi (th k t)) /\
  is_derive (th k) t (w0 + w0 * (K0 / INR n * inner (expi (th k t)) (circle_centre w0 (r k t) (th k t) - c0)%C))).
Check (paley_settling.beacon_fixes :
  forall (n : nat) (w0 K0 : R) (c0 : C) (r : nat -> R -> C) (th : nat -> R -> R), (1 <= n)%nat -> w0 <> 0 -> 0 < K0 -> paley_settling.beaconed n w0 K0 c0 r th ->
  forall k, (k < n)%nat -> forall e, 0 < e -> exists T, 0 <= T /\ forall t, T <= t -> Cmod (circle_centre w0 (r k t) (th k t) - c0)%C < e).

(* ---- paley.fish28ori, clause 3 ---- *)
Check (eq_refl : paley_settling.shaped = fun n adj w0 K0 K1 r th => forall k t, (k < n)%nat -> 0 <= t ->
  is_velocity (r k) t (expi (th k t)) /\ is_derive (th k) t (control5 n adj w0 K0 K1 r th t k)).
Check (paley_settling.perpendicular_motion :
  forall (n : nat) (adj : graph) (w0 K0 K1 : R) (r : nat -> R -> C) (th : nat -> R -> R), (2 <= n)%nat -> undirected adj -> strongly_connected n adj ->
  0 < w0 -> 0 < K0 -> K1 <> 0 -> paley_settling.shaped n adj w0 K0 K1 r th -> forall k, (k < n)%nat -> forall e, 0 < e -> exists T, 0 <= T /\ forall t, T <= t ->
  Rabs (inner (expi (th k t)) (RtoC (/ deg n adj k) * row n (lap n adj) k (fun j => r j t))%C) < e).

(* ---- paley.drift ---- *)
Check (eq_refl : paley_settling.drifting = fun n adj w0 K0 K1 f r th => forall k t, (k < n)%nat -> 0 <= t ->
  is_velocity (r k) t (expi (th k t) + f)%C /\ is_derive (th k) t (control5 n adj w0 K0 K1 r th t k)).
Check (paley_settling.drift_travels :
  forall (n : nat) (adj : graph) (w0 K0 K1 : R) (f : C) (r : nat -> R -> C) (th : nat -> R -> R), (1 <= n)%nat -> undirected adj -> strongly_connected n adj ->
  w0 <> 0 -> 0 < K0 -> paley_settling.drifting n adj w0 K0 K1 f r th ->
  (exists B, forall t j k, 0 <= t -> (j < n)%nat -> (k < n)%nat -> Cmod (r k t - r j t)%C <= B) /\
  forall k, (k < n)%nat ->
    (forall e, 0 < e -> exists T, 0 <= T /\ forall t, T <= t -> Cmod (RtoC (/ t) * (r k t - r k 0%R) - f)%C < e) /\
    exists v, (forall t, 0 <= t -> is_velocity (fun s => circle_centre w0 (r k s) (th k s)) t (v t)) /\
      forall e, 0 < e -> exists T, 0 <= T /\ forall t, T <= t -> Cmod (v t - f)%C < e).
