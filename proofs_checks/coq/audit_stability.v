(* Audit of circular formations that are exponentially stable, or unstable: each theorem of theorems.tsv with its statement written out; the objects of the statements are
  restated first. *)
From Coq Require Import Reals ZArith.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums paley_model paley_phase paley_laplacian paley_gradient paley_particles paley_fourier.
From Flockproof Require paley_settling paley_formations paley_cycles.
Open Scope R_scope.

Check (eq_refl : expi = fun t => (cos t, sin t)).
Check (eq_refl : dist2 = fun x y => inner (x - y)%C (x - y)%C).
Check (eq_refl : circle_centre = fun w0 r th => (r + RtoC (/ w0) * (Ci * expi th))%C).
Check (eq22 : forall n adj w0 K0 K1, (1 <= n)%nat -> w0 <> 0 -> forall r th t k,
  control5 n adj w0 K0 K1 r th t k = w0 + (K1 - K0) / INR n * gW n adj (fun j => th j t) k
    + w0 * (K0 / INR n) * inner (expi (th k t)) (row n (lap n adj) k (fun j => r j t))).
Check (gW_sines : forall n adj th k, (k < n)%nat -> gW n adj th k = Sum n (fun j => w adj k j * sin (th k - th j))).
Check (eq_refl : paley_settling.shaped = fun n adj w0 K0 K1 r th => forall k t, (k < n)%nat -> 0 <= t ->
  is_velocity (r k) t (expi (th k t)) /\ is_derive (th k) t (control5 n adj w0 K0 K1 r th t k)).
Check (eq_refl : paley_settling.drifting = fun n adj w0 K0 K1 f r th => forall k t, (k < n)%nat -> 0 <= t ->
  is_velocity (r k) t (expi (th k t) + f)%C /\ is_derive (th k) t (control5 n adj w0 K0 K1 r th t k)).
(* squares of all differences of centres, and of headings turned back by phi: 0 at the formations with the phases phi up to rotation, and at no others *)
Check (eq_refl : paley_formations.spread = fun n w0 phi r th =>
  Sum n (fun k => Sum n (fun j => dist2 (circle_centre w0 (r k) (th k)) (circle_centre w0 (r j) (th j)) + dist2 (expi (th k - phi k)) (expi (th j - phi j))))).

(* ---- paley.sync.exp (f = 0), paley.fig6.gain (corrected) ---- *)
Check (paley_formations.synchronized_stable :
  forall (n : nat) (adj : graph) (w0 K0 K1 : R) (f : C), (1 <= n)%nat -> undirected adj -> strongly_connected n adj -> w0 <> 0 -> 0 < K0 -> K1 < 0 ->
  exists e A m, 0 < e /\ 0 < A /\ 0 < m /\ forall r th, paley_settling.drifting n adj w0 K0 K1 f r th ->
    paley_formations.spread n w0 (fun _ => 0) (fun k => r k 0) (fun k => th k 0) < e ->
    forall t, 0 <= t -> paley_formations.spread n w0 (fun _ => 0) (fun k => r k t) (fun k => th k t) <=
      A * paley_formations.spread n w0 (fun _ => 0) (fun k => r k 0) (fun k => th k 0) * exp (- m * t)).

(* ---- paley.fig3.gain (corrected), clauses 1 (m = 5) and 2 (m = 6) ---- *)
Check (eq_refl : ring_graph = fun n k j => ring_offset n ((j + n - k) mod n)).
Check (eq_refl : ring_offset = fun n d => (Nat.eqb d 1 || Nat.eqb d (n - 1))%bool).
Check (eq_refl : paley_formations.cycle_graph = fun n k j => (Nat.ltb k n && Nat.ltb j n && ring_graph n k j)%bool).
Check (eq_refl : paley_formations.turned_by = fun n m k => 2 * PI * INR m * INR k / INR n).
Check (paley_formations.fig3_stable :
  forall (m : nat) (w0 K0 K1 : R), m = 5%nat \/ m = 6%nat -> w0 <> 0 -> 0 < K0 -> 0 < K1 ->
  exists e A q, 0 < e /\ 0 < A /\ 0 < q /\ forall r th, paley_settling.shaped 12 (paley_formations.cycle_graph 12) w0 K0 K1 r th ->
    paley_formations.spread 12 w0 (paley_formations.turned_by 12 m) (fun k => r k 0) (fun k => th k 0) < e ->
    forall t, 0 <= t -> paley_formations.spread 12 w0 (paley_formations.turned_by 12 m) (fun k => r k t) (fun k => th k t) <=
      A * paley_formations.spread 12 w0 (paley_formations.turned_by 12 m) (fun k => r k 0) (fun k => th k 0) * exp (- q * t)).

(* ---- beyond.paley.cyclic_patterns ---- *)
Check (eq_refl : paley_cycles.begins = fun n r th r0 th0 => forall k, (k < n)%nat -> r k 0 = r0 k /\ th k 0 = th0 k).
Check (eq_refl : paley_cycles.lasts = fun n adj w0 K0 K1 => forall r0 th0, exists r th, paley_cycles.begins n r th r0 th0 /\ paley_settling.shaped n adj w0 K0 K1 r th).
Check (eq_refl : paley_cycles.exponentially_stable = fun n adj w0 K0 K1 phi => exists e A q, 0 < e /\ 0 < A /\ 0 < q /\ forall r th, paley_settling.shaped n adj w0 K0 K1 r th ->
  paley_formations.spread n w0 phi (fun k => r k 0) (fun k => th k 0) < e ->
  forall t, 0 <= t -> paley_formations.spread n w0 phi (fun k => r k t) (fun k => th k t) <= A * paley_formations.spread n w0 phi (fun k => r k 0) (fun k => th k 0) * exp (- q * t)).
Check (eq_refl : paley_cycles.unstable = fun n adj w0 K0 K1 phi => exists e, 0 < e /\ forall d, 0 < d -> exists r0 th0, paley_formations.spread n w0 phi r0 th0 < d /\
  forall r th, paley_settling.shaped n adj w0 K0 K1 r th -> paley_cycles.begins n r th r0 th0 ->
    exists t, 0 <= t /\ e <= paley_formations.spread n w0 phi (fun k => r k t) (fun k => th k t)).
Check (eq_refl : paley_cycles.pattern = fun n m k => 2 * PI * IZR m * INR k / INR n).
Check (paley_cycles.cyclic_patterns :
  forall (n : nat) (m : Z) (w0 K0 K1 : R), (3 <= n)%nat -> w0 <> 0 -> 0 < K0 ->
  paley_cycles.lasts n (paley_formations.cycle_graph n) w0 K0 K1 /\
  (paley_cycles.exponentially_stable n (paley_formations.cycle_graph n) w0 K0 K1 (paley_cycles.pattern n m) <-> K1 * cos (2 * PI * IZR m / INR n) < 0) /\
  (0 < K1 * cos (2 * PI * IZR m / INR n) -> paley_cycles.unstable n (paley_formations.cycle_graph n) w0 K0 K1 (paley_cycles.pattern n m))).
