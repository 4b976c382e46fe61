(* Audit of the limits and the stability of the phase model (6) with the gradient control (9): each theorem of theorems.tsv with its statement written out;
   the objects of the statements are restated first. *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums paley_model paley_phase.
From Flockproof Require paley_laplacian paley_fourier paley_directed paley_headings inclusions paley_limits.
Open Scope R_scope.

Check (eq_refl : expi = fun t => (cos t, sin t)).
Check (eq_refl : order = fun n th => (RtoC (/ INR n) * Csum n (fun k => expi (th k)))%C).
Check (eq_refl : U1 = fun n th => INR n / 2 * Cmod (order n th) ^ 2).
Check (eq_refl : partial = fun f th k d => is_derive (fun s : R => f (upd th k s)) (th k) d).
Check (eq_refl : stationary = fun n f th => forall k, (k < n)%nat -> partial f th k 0).
Check (eq_refl : balanced = fun n th => order n th = RtoC 0).
Check (eq_refl : synchronized = fun n th => forall j k, (j < n)%nat -> (k < n)%nat -> expi (th j) = expi (th k)).
Check (U1_gradient : forall n th k, (1 <= n)%nat -> (k < n)%nat -> partial (U1 n) th k (g1 n th k)).
(* the model (6) with (9): the rate of a phase is w0 - K1 dU_1/dtheta_k *)
Check (eq_refl : paley_limits.phases = fun n w0 K1 th => forall t k, 0 <= t -> (k < n)%nat -> is_derive (th k) t (w0 + - K1 * g1 n (fun j => th j t) k)).
Check (eq_refl : paley_limits.lasting = fun n w0 K1 => (forall a : nat -> R, exists th, (forall k, (k < n)%nat -> th k 0 = a k) /\ paley_limits.phases n w0 K1 th) /\
  forall T th, 0 < T -> (forall t k, 0 <= t < T -> (k < n)%nat -> is_derive (th k) t (w0 + - K1 * g1 n (fun j => th j t) k)) ->
    exists th', (forall t k, t < T -> (k < n)%nat -> th' k t = th k t) /\ paley_limits.phases n w0 K1 th').
Check (eq_refl : paley_limits.within = fun n th t e a => forall i, (i < n)%nat -> Rabs (th i t - a i) < e).
Check (eq_refl : paley_limits.stable = fun n w0 K1 a => forall e, 0 < e -> exists d, 0 < d /\ forall th, paley_limits.phases n w0 K1 th -> paley_limits.within n th 0 d a ->
  forall t, 0 <= t -> exists c, paley_limits.within n th t e (fun k => a k + c)).
(* paley.thm1.conv *)
Check (paley_limits.converges : forall n, (1 <= n)%nat -> forall w0 K1, K1 <> 0 -> paley_limits.lasting n w0 K1 /\ forall th, paley_limits.phases n w0 K1 th ->
  forall e, 0 < e -> exists T, 0 <= T /\ forall t, T <= t -> exists a, stationary n (U1 n) a /\ paley_limits.within n th t e a).
(* paley.thm1.bal *)
Check (paley_limits.balanced_stable : forall n, (1 <= n)%nat -> forall w0 K1, 0 < K1 ->
  (forall e, 0 < e -> exists d, 0 < d /\ forall th a, paley_limits.phases n w0 K1 th -> balanced n a -> paley_limits.within n th 0 d a ->
    forall t, 0 <= t -> exists b, balanced n b /\ paley_limits.within n th t e b) /\
  exists d, 0 < d /\ forall th a, paley_limits.phases n w0 K1 th -> balanced n a -> paley_limits.within n th 0 d a ->
    forall e, 0 < e -> exists T, 0 <= T /\ forall t, T <= t -> exists b, balanced n b /\ paley_limits.within n th t e b).
(* paley.thm1.bal clause 2, paley.thm1.sync clause 2 *)
Check (paley_limits.rest_unstable : forall n, (1 <= n)%nat -> forall w0 K1 a, (2 <= n)%nat -> stationary n (U1 n) a ->
  (0 < K1 -> ~ balanced n a -> ~ paley_limits.stable n w0 K1 a) /\ (K1 < 0 -> ~ synchronized n a -> ~ paley_limits.stable n w0 K1 a)).
(* paley.unbal *)
Check (paley_limits.clusters_unstable : forall n, (1 <= n)%nat -> forall w0 K1 (x : R) (s : nat -> bool) (a : nat -> R), K1 <> 0 -> (forall k, (k < n)%nat -> a k = if s k then x else x + PI) ->
  (exists j, (j < n)%nat /\ s j = true) -> (exists j, (j < n)%nat /\ s j = false) -> Sum n (fun k => if s k then 1 else 0) <> Sum n (fun k => if s k then 0 else 1) ->
  (stationary n (U1 n) a /\ ~ paley_limits.stable n w0 K1 a) /\ (expi (x + PI) = - expi x)%C /\ forall k, (k < n)%nat -> expi (a k) = if s k then expi x else expi (x + PI)).

(* paley.balexist: circulant graphs, directed ones too *)
Check (eq_refl : W1 = fun n adj th => / (2 * INR n) * Sum n (fun k => inner (expi (th k)) (Csum n (fun j => RtoC (lap n adj k j) * expi (th j))%C))).
Check (eq_refl : paley_fourier.circulant = fun n adj s => forall k j, (k < n)%nat -> (j < n)%nat -> adj k j = s ((j + n - k) mod n)%nat).
Check (paley_directed.balanced_exists_directed : forall (n : nat) (adj : graph) (s : nat -> bool), (2 <= n)%nat -> paley_fourier.circulant n adj s ->
  exists th, balanced n th /\ stationary n (W1 n adj) th).

(* paley.figS3.difference (corrected), clause 2: independent uniform headings, one integral after the other *)
Check (eq_refl : paley_headings.mean_of = fun F m th => / (2 * PI) * RInt (fun s => F (upd th m s)) 0 (2 * PI)).
Check (fun F th => eq_refl : paley_headings.mean_over 0 F th = F th).
Check (fun k F th => eq_refl : paley_headings.mean_over (S k) F th = paley_headings.mean_over k (paley_headings.mean_of F k) th).
Check (paley_headings.figS3_mean : forall (n : nat) (g h : graph) (b c : nat) (th : nat -> R), (1 <= n)%nat -> no_loops g -> no_loops h -> (1 <= b)%nat -> (1 <= c)%nat ->
  (forall k, (k < n)%nat -> deg n g k = INR b) -> (forall k, (k < n)%nat -> deg n h k = INR c) ->
  paley_headings.mean_over n (fun x => W1 n h x / INR c - W1 n g x / INR b) th = 0).
