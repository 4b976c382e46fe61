(* Audit of paley: each theorem of theorems.tsv with its statement written out, and the axioms it rests on.
   The objects of the statements are restated first. *)
From Coq Require Import Reals Lra Lia ZArith Relations List.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums paley_centre paley_convergence paley_model paley_phase paley_laplacian paley_gradient paley_particles paley_fourier paley_patterns paley_composite paley_fish paley_behaviours tanner_energy tanner_flock tanner_nonsmooth tanner1_heading tanner1_examples tanner2_examples tanner2_facts tanner_graph paley_stability.
Open Scope R_scope.

(* the objects: phasors, inner product, graph Laplacian, quadratic form, order parameter, potentials *)
Check (eq_refl : expi = fun t => (cos t, sin t)).
Check (eq_refl : inner = fun x y => Re (Cconj x * y)%C).
Check (inner_xy : forall x y, inner x y = fst x * fst y + snd x * snd y).
Check (eq_refl : w = fun adj k j => if adj k j then 1 else 0).
Check (eq_refl : lap = fun n adj k j => delta k j * Sum n (w adj k) - w adj k j).
Check (eq_refl : arc = fun n adj j k => (j < n)%nat /\ (k < n)%nat /\ adj k j = true).
Check (eq_refl : Q = fun n A x => / (2 * INR n) * Sum n (fun k => inner (x k) (Csum n (fun j => RtoC (A k j) * x j)%C))).
Check (eq_refl : order = fun n th => (RtoC (/ INR n) * Csum n (fun k => expi (th k)))%C).
Check (eq_refl : U1 = fun n th => INR n / 2 * Cmod (order n th) ^ 2).
Check (eq_refl : W1 = fun n adj th => Q n (lap n adj) (fun k => expi (th k))).
Check (eq_refl : partial = fun f th k d => is_derive (fun s : R => f (upd th k s)) (th k) d).
Check (eq_refl : is_velocity = fun r t v => is_derive (fun s => fst (r s)) t (fst v) /\ is_derive (fun s => snd (r s)) t (snd v)).
Check (eq_refl : gW = fun n adj th k => inner (Ci * expi (th k))%C (row n (lap n adj) k (phasors th))).
Check (eq_refl : circle_centre = fun w0 r th => (r + RtoC (/ w0) * (Ci * expi th))%C).

(* paley.CN *)
Check (paley_fourier.complete_row :
  forall n j : nat, (1 <= n)%nat -> (j < n)%nat -> lap n complete 0 j = (if j =? 0 then INR n - 1 else -1)).

(* paley.CN *)
Check (paley_fourier.ring_row :
  forall n j : nat,
       (3 <= n)%nat ->
       (j < n)%nat ->
       lap n (ring_graph n) 0 j = (if j =? 0 then 2 else if ((j =? 1) || (j =? n - 1))%bool then -1 else 0) /\
       deg n (ring_graph n) j = 2).

(* paley.CN *)
Check (paley_fourier.ring_connected :
  forall n : nat, (1 <= n)%nat -> strongly_connected n (ring_graph n)).

(* paley.Rball *)
Check (paley_fish.centre_ball :
  forall (n : nat) (w0 : R) (r : nat -> R -> C) (th : nat -> R -> R),
       (1 <= n)%nat ->
       w0 <> 0 ->
       (forall (k : nat) (t : R), (k < n)%nat -> is_velocity (r k) t (expi (th k t))) ->
       (forall (k : nat) (t : R_AbsRing), (k < n)%nat -> is_derive (th k) t w0) ->
       exists c : C, forall t : R, Cmod (centre n (fun k : nat => r k t) - c)%C <= / Rabs w0).

(* paley.Um *)
Check (paley_patterns.Um_extremes :
  forall (n m : nat) (th : nat -> R),
       (1 <= n)%nat ->
       (1 <= m)%nat ->
       0 <= Um n m th <= INR n / (2 * INR m ^ 2) /\
       (Um n m th = 0 <-> moment n m th = 0) /\
       (Um n m th = INR n / (2 * INR m ^ 2) <->
        (forall j k : nat, (j < n)%nat -> (k < n)%nat -> exists z : Z, INR m * (th j - th k) = 2 * PI * IZR z))).

(* paley.Um *)
Check (paley_patterns.partial_rotation :
  forall (n : nat) (th : nat -> R) (k : nat) (a d : R),
       (1 <= n)%nat -> partial (U1 n) th k d -> partial (U1 n) (fun j : nat => th j + a) k d).

(* paley.VMN *)
Check (eq_refl : UMN = fun n M K th => Sum M (fun i => K (S i) * Um n (S i) th)).
Check (paley_composite.UMN_gradient :
  forall (n M : nat) (K th : nat -> R) (k : nat),
       (1 <= n)%nat -> (k < n)%nat -> partial (UMN n M K) th k (gUMN n M K th k)).
Check (eq_refl : pattern_control = fun n adj w0 K0 M K r th t k =>
  w0 - gUMN n M K (fun k => th k t) k + w0 * (K0 / INR n * aS n adj w0 (fun k => r k t) (fun k => th k t) k)).
Check (paley_composite.VMN_corrected :
  forall (n : nat) (adj : graph) (w0 K0 : R) (M : nat) (K : nat -> R),
       (1 <= n)%nat ->
       w0 <> 0 ->
       undirected adj ->
       forall (r : nat -> R -> C) (th : nat -> R -> R) (t : R),
       (forall k : nat, (k < n)%nat -> is_velocity (r k) t (expi (th k t))) ->
       (forall k : nat, (k < n)%nat -> is_derive (th k) t (pattern_control n adj w0 K0 M K r th t k)) ->
       is_derive
         (fun s => K0 * spacing n adj w0 (fun k => r k s) (fun k => th k s) + / w0 ^ 2 * UMN n M K (fun k => th k s)) t
         (- / w0 ^ 2 * Sum n (fun k => (pattern_control n adj w0 K0 M K r th t k - w0) ^ 2))).

(* paley.VMN *)
Check (paley_composite.VMN_printed_fails :
  ~ (forall (n M : nat) (adj : graph) (w0 K0 : R) (K : nat -> R),
       (1 <= n)%nat -> (1 <= M)%nat -> undirected adj -> strongly_connected n adj -> w0 <> 0 -> 0 < K0 ->
       (forall m : nat, (1 <= m < M)%nat -> 0 < K m) -> K M < 0 -> (exists q : nat, n = (q * M)%nat) ->
       forall (r : nat -> R -> C) (th : nat -> R -> R) (t d : R),
       (forall k : nat, (k < n)%nat -> is_velocity (r k) t (expi (th k t))) ->
       (forall k : nat, (k < n)%nat -> is_derive (th k) t (pattern_control n adj w0 K0 M K r th t k)) ->
       is_derive (fun s => K0 * spacing n adj w0 (fun k => r k s) (fun k => th k s) + UMN n M K (fun k => th k s)) t d ->
       d <= 0)).

(* paley.Wm *)
Check (paley_patterns.Wm_printed_fails :
  forall (n m : nat) (th : nat -> R),
       (1 <= n)%nat -> (2 <= m)%nat -> Wm n complete m th <> INR n / 2 - Um n m th).

(* paley.Wm *)
Check (paley_patterns.Wm_corrected :
  forall (n m : nat) (th : nat -> R),
       (1 <= n)%nat -> (1 <= m)%nat -> Wm n complete m th = INR n / (2 * INR m ^ 2) - Um n m th).


(* paley.balexist *)
Check (paley_fourier.balanced_needs_two :
  forall th : nat -> R, ~ balanced 1 th).

(* paley.beacon.form *)
Check (paley_fish.beacon_zero :
  forall (n : nat) (c : nat -> C) (c0 : C),
       (1 <= n)%nat -> beacon n c c0 = 0 <-> (forall k : nat, (k < n)%nat -> c k = c0)).

(* paley.beacon.form *)
Check (paley_fish.beacon_rate :
  forall (n : nat) (w0 K0 : R) (c0 : C) (r : nat -> R -> C) (th : nat -> R -> R) (t : R),
       (1 <= n)%nat ->
       w0 <> 0 ->
       (forall k : nat, (k < n)%nat -> is_velocity (r k) t (expi (th k t))) ->
       (forall k : nat,
        (k < n)%nat ->
        is_derive (th k) t
          (w0 + w0 * (K0 / INR n * inner (expi (th k t)) (circle_centre w0 (r k t) (th k t) - c0)%C))) ->
       is_derive (fun s : R_AbsRing => beacon n (fun k : nat => circle_centre w0 (r k s) (th k s)) c0) t
         (- (K0 / INR n ^ 2) *
          Sum n (fun k : nat => inner (expi (th k t)) (circle_centre w0 (r k t) (th k t) - c0)%C ^ 2))).

(* paley.chord *)
Check (paley_fish.chord :
  forall M : nat, (1 <= M)%nat -> Cmod (expi (2 * PI / INR M) - expi 0)%C = 2 * sin (PI / INR M)).

(* paley.eig.sym *)
Check (paley_patterns.eig_sym_printed_fails :
  ~
       (forall (n : nat) (adj : graph) (s : nat -> bool) (lam : C) (th : nat -> R),
        (2 <= n)%nat ->
        undirected adj ->
        circulant n adj s ->
        ~ synchronized n th -> eigenvector n (lap n adj) lam (phasors th) -> exists M : nat, pattern M n th)).

(* paley.eig.sym *)
Check (paley_fish.wave_pattern :
  forall n m : nat, (1 <= n)%nat -> pattern (n / Nat.gcd n m) n (wave n m)).

(* paley.energy *)
Check (paley_particles.energy :
  forall (th : R -> R) (t : R_AbsRing) (u : R_NormedModule),
       is_derive th t u ->
       is_velocity (fun s : R => expi (th s)) t (u * (Ci * expi (th t)))%C /\
       is_derive (fun s : R_AbsRing => / 2 * Cmod (expi (th s)) ^ 2) t
         (inner (expi (th t)) (u * (Ci * expi (th t)))%C) /\ inner (expi (th t)) (u * (Ci * expi (th t)))%C = 0).

(* paley.energy *)
Check (paley_particles.energy_total :
  forall (n : nat) (th : nat -> R -> R) (u : nat -> R) (t : R_AbsRing),
       (forall k : nat, (k < n)%nat -> is_derive (th k) t (u k)) ->
       is_derive (fun s : R_AbsRing => Sum n (fun k : nat => / 2 * Cmod (expi (th k s)) ^ 2)) t 0).

(* paley.eq11.kernel, paley.eq17 *)
Check (paley_laplacian.Q_kernel :
  forall (n : nat) (adj : graph) (x : nat -> C),
       (1 <= n)%nat ->
       undirected adj ->
       strongly_connected n adj ->
       0 <= Q n (lap n adj) x /\ (Q n (lap n adj) x = 0 <-> (exists c : C, forall k : nat, (k < n)%nat -> x k = c))).

(* paley.eq12.pos *)
Check (paley_laplacian.W1_formula :
  forall (n : nat) (adj : graph) (th : nat -> R),
       W1 n adj th = / (2 * INR n) * Sum n (fun k : nat => inner (phasors th k) (row n (lap n adj) k (phasors th))) /\
       W1 n adj th =
       / (2 * INR n) *
       Sum n (fun k : nat => deg n adj k - Sum n (fun j : nat => w adj k j * inner (expi (th k)) (expi (th j))))).

(* paley.eq12.pos *)
Check (paley_laplacian.W1_ge0 :
  forall (n : nat) (adj : graph) (th : nat -> R), (1 <= n)%nat -> 0 <= W1 n adj th).

(* paley.eq12.pos *)
Check (paley_laplacian.W1_strongly :
  forall (n : nat) (adj : graph) (th : nat -> R),
       (1 <= n)%nat -> strongly_connected n adj -> W1 n adj th = 0 <-> synchronized n th).

(* paley.eq13 *)
Check (paley_phase.eq13 :
  forall (n : nat) (th : nat -> R), (1 <= n)%nat -> W1 n complete th = INR n / 2 - U1 n th).

(* paley.eq13 *)
Check (paley_phase.eq13_stationary :
  forall (n : nat) (th : nat -> R), (1 <= n)%nat -> stationary n (W1 n complete) th <-> stationary n (U1 n) th).

(* paley.eq14_15 *)
Check (paley_gradient.W1_rate :
  forall (n : nat) (adj : graph) (th : nat -> R -> R) (w0 K1 : R) (t : R_AbsRing),
       (1 <= n)%nat ->
       undirected adj ->
       (forall k : nat, (k < n)%nat -> is_derive (th k) t (w0 + K1 / INR n * gW n adj (fun k0 : nat => th k0 t) k)) ->
       is_derive (fun s : R_AbsRing => W1 n adj (fun k : nat => th k s)) t
         (K1 / INR n ^ 2 * Sum n (fun k : nat => gW n adj (fun k0 : nat => th k0 t) k ^ 2))).

(* paley.eq14_15 *)
Check (paley_gradient.control14_sines :
  forall (n : nat) (adj : graph) (th : nat -> R) (k : nat) (w0 K1 : R),
       (k < n)%nat ->
       w0 + K1 / INR n * gW n adj th k = w0 + K1 / INR n * Sum n (fun j : nat => w adj k j * sin (th k - th j))).

(* paley.eq16 *)
Check (paley_gradient.eq16 :
  forall (n : nat) (adj : graph) (th : nat -> R),
       (1 <= n)%nat ->
       undirected adj -> (forall k : nat, (k < n)%nat -> gW n adj th k = 0) <-> stationary n (W1 n adj) th).

(* paley.eq16.eigvec, paley.fig2.caption *)
Check (paley_gradient.eigenvector_stationary :
  forall (n : nat) (adj : graph) (th : nat -> R) (lam : C),
       (1 <= n)%nat ->
       undirected adj ->
       eigenvector n (lap n adj) lam (phasors th) ->
       stationary n (W1 n adj) th /\
       (forall (w0 K1 : R) (k : nat), (k < n)%nat -> w0 + K1 / INR n * gW n adj th k = w0)).

(* paley.eq17 *)
Check (paley_gradient.spacing_proper :
  forall (n : nat) (adj : graph),
       (1 <= n)%nat ->
       undirected adj ->
       strongly_connected n adj ->
       exists B : R,
         0 <= B /\
         (forall (c : nat -> C) (j k : nat), (j < n)%nat -> (k < n)%nat -> dist2 (c j) (c k) <= B * Q n (lap n adj) c)).

(* paley.eq18 *)
Check (paley_particles.eq18 :
  forall (w0 : R) (r : R -> C) (th : R -> R) (t : R) (u : R_NormedModule),
       is_velocity r t (expi (th t)) ->
       is_derive th t u ->
       is_velocity (fun s : R => circle_centre w0 (r s) (th s)) t (expi (th t) * (1 - / w0 * u)%R)%C).

(* paley.eq19_20 *)
Check (paley_particles.eq19 :
  forall (n : nat) (adj : graph) (w0 : R),
       (1 <= n)%nat ->
       undirected adj ->
       forall (r : nat -> R -> C) (th : nat -> R -> R) (u : nat -> R) (t : R),
       (forall k : nat, (k < n)%nat -> is_velocity (r k) t (expi (th k t))) ->
       (forall k : nat, (k < n)%nat -> is_derive (th k) t (u k)) ->
       is_derive (fun s : R_AbsRing => spacing n adj w0 (fun k : nat => r k s) (fun k : nat => th k s)) t
         (/ INR n *
          Sum n (fun k : nat => aS n adj w0 (fun k0 : nat => r k0 t) (fun k0 : nat => th k0 t) k * (1 - / w0 * u k)))).

(* paley.eq19_20 *)
Check (paley_particles.eq20 :
  forall (n : nat) (adj : graph) (w0 K0 : R),
       (1 <= n)%nat ->
       w0 <> 0 ->
       undirected adj ->
       forall (r : nat -> R -> C) (th : nat -> R -> R) (u : nat -> R) (t : R),
       (forall k : nat, (k < n)%nat -> is_velocity (r k) t (expi (th k t))) ->
       (forall k : nat, (k < n)%nat -> is_derive (th k) t (u k)) ->
       (forall k : nat,
        (k < n)%nat ->
        u k = w0 + w0 * (K0 / INR n * aS n adj w0 (fun k0 : nat => r k0 t) (fun k0 : nat => th k0 t) k)) ->
       is_derive (fun s : R_AbsRing => spacing n adj w0 (fun k : nat => r k s) (fun k : nat => th k s)) t
         (- (K0 / INR n ^ 2) *
          Sum n (fun k : nat => aS n adj w0 (fun k0 : nat => r k0 t) (fun k0 : nat => th k0 t) k ^ 2))).

(* paley.eq19_20 *)
Check (paley_particles.eq20_sign :
  forall (n : nat) (adj : graph) (w0 K0 : R),
       (1 <= n)%nat ->
       forall (r : nat -> R -> C) (th : nat -> R -> R) (u : nat -> R) (t : R),
       0 < K0 ->
       (forall k : nat,
        (k < n)%nat ->
        u k = w0 + w0 * (K0 / INR n * aS n adj w0 (fun k0 : nat => r k0 t) (fun k0 : nat => th k0 t) k)) ->
       - (K0 / INR n ^ 2) *
       Sum n (fun k : nat => aS n adj w0 (fun k0 : nat => r k0 t) (fun k0 : nat => th k0 t) k ^ 2) <= 0).

(* paley.eq21 *)
Check (paley_particles.eq21_printed_fails :
  ~
       (forall (n : nat) (adj : graph) (w0 K0 K1 : R),
        (1 <= n)%nat ->
        undirected adj ->
        0 < K0 ->
        K1 <> 0 ->
        w0 <> 0 ->
        forall (r : nat -> R -> C) (th : nat -> R -> R) (t : R),
        (forall k : nat, (k < n)%nat -> is_velocity (r k) t (expi (th k t))) ->
        (forall k : nat, (k < n)%nat -> is_derive (th k) t (control5 n adj w0 K0 K1 r th t k)) ->
        is_derive
          (fun s : R_AbsRing =>
           K0 * spacing n adj w0 (fun k : nat => r k s) (fun k : nat => th k s) +
           K1 * / w0 * W1 n adj (fun k : nat => th k s)) t
          (- / INR n ^ 2 *
           Sum n
             (fun k : nat =>
              (K0 * aS n adj w0 (fun k0 : nat => r k0 t) (fun k0 : nat => th k0 t) k +
               K1 * / w0 * gW n adj (fun k0 : nat => th k0 t) k) ^ 2)))).

(* paley.eq21 *)
Check (paley_particles.eq21_corrected :
  forall (n : nat) (adj : graph) (w0 K0 K1 : R),
       (1 <= n)%nat ->
       w0 <> 0 ->
       undirected adj ->
       forall (r : nat -> R -> C) (th : nat -> R -> R) (u : nat -> R) (t : R),
       (forall k : nat, (k < n)%nat -> is_velocity (r k) t (expi (th k t))) ->
       (forall k : nat, (k < n)%nat -> is_derive (th k) t (u k)) ->
       (forall k : nat, (k < n)%nat -> u k = control5 n adj w0 K0 K1 r th t k) ->
       is_derive
         (fun s : R_AbsRing =>
          K0 * spacing n adj w0 (fun k : nat => r k s) (fun k : nat => th k s) -
          K1 / w0 ^ 2 * W1 n adj (fun k : nat => th k s)) t
         (- / INR n ^ 2 *
          Sum n
            (fun k : nat =>
             (K0 * aS n adj w0 (fun k0 : nat => r k0 t) (fun k0 : nat => th k0 t) k +
              K1 * / w0 * gW n adj (fun k0 : nat => th k0 t) k) ^ 2))).

(* paley.eq21 *)
Check (paley_particles.eq21_actual :
  forall (n : nat) (adj : graph) (w0 K0 K1 : R),
       (1 <= n)%nat ->
       w0 <> 0 ->
       undirected adj ->
       forall (r : nat -> R -> C) (th : nat -> R -> R) (u : nat -> R) (t : R),
       (forall k : nat, (k < n)%nat -> is_velocity (r k) t (expi (th k t))) ->
       (forall k : nat, (k < n)%nat -> is_derive (th k) t (u k)) ->
       (forall k : nat, (k < n)%nat -> u k = control5 n adj w0 K0 K1 r th t k) ->
       is_derive
         (fun s : R_AbsRing =>
          K0 * spacing n adj w0 (fun k : nat => r k s) (fun k : nat => th k s) +
          K1 * / w0 * W1 n adj (fun k : nat => th k s)) t
         (- / INR n ^ 2 *
          Sum n
            (fun k : nat =>
             (K0 * aS n adj w0 (fun k0 : nat => r k0 t) (fun k0 : nat => th k0 t) k -
              K1 * gW n adj (fun k0 : nat => th k0 t) k) *
             (K0 * aS n adj w0 (fun k0 : nat => r k0 t) (fun k0 : nat => th k0 t) k +
              K1 * / w0 * gW n adj (fun k0 : nat => th k0 t) k)))).

(* paley.eq22 *)
Check (paley_particles.eq22 :
  forall (n : nat) (adj : graph) (w0 K0 K1 : R),
       (1 <= n)%nat ->
       w0 <> 0 ->
       forall (r : nat -> R -> C) (th : nat -> R -> R) (t : R) (k : nat),
       control5 n adj w0 K0 K1 r th t k =
       w0 + (K1 - K0) / INR n * gW n adj (fun k0 : nat => th k0 t) k +
       w0 * (K0 / INR n) * inner (expi (th k t)) (row n (lap n adj) k (fun k0 : nat => r k0 t))).

(* paley.eq23 *)
Check (paley_patterns.eq23 :
  forall (M n : nat) (th : nat -> R),
       (1 <= n)%nat ->
       pattern M n th -> (forall m : nat, (1 <= m < M)%nat -> moment n m th = 0) /\ INR M * Cmod (moment n M th) = 1).

(* paley.eq23 *)
Check (paley_patterns.pattern_balanced :
  forall (M n : nat) (th : nat -> R), (1 <= n)%nat -> (2 <= M)%nat -> pattern M n th -> balanced n th).

(* paley.eq26 *)
Check (paley_fish.eq26_printed_fails :
  forall T : R,
       T < 1 ->
       ~ (exists h : R, forall (r : C) (th u : R), (r + h * expi th)%C = (r + expi th)%C /\ th + h * u = th + T * u)).

(* paley.eq26 *)
Check (paley_fish.eq26_step :
  forall h T : R,
       (forall (r : C) (th u : R), (r + h * expi th)%C = (r + expi th)%C /\ th + h * u = th + T * u) <->
       h = 1 /\ T = 1).

(* paley.eq28 *)
Check (paley_fish.eq28_attraction_sign :
  forall (n : nat) (att : graph) (r : nat -> C) (th : R) (k : nat),
       (k < n)%nat ->
       inner (Ci * expi th)%C (row n (lap n att) k r) =
       - inner (Ci * expi th)%C (Csum n (fun j : nat => (w att k j * (r j - r k))%C))).

(* paley.eq29 *)
Check (paley_particles.eq29_printed_fails :
  ~
       (forall (n : nat) (ori att : graph) (w0 K0 K1 : R) (r : nat -> C) (th : nat -> R) (k : nat),
        (1 <= n)%nat ->
        w0 <> 0 ->
        0 < K0 -> (k < n)%nat -> control5_two n ori att w0 K0 K1 r th k = control29 n ori att w0 K0 K1 r th k)).

(* paley.eq29 *)
Check (paley_particles.eq29_corrected :
  forall (n : nat) (ori att : graph) (w0 K0 K1 : R) (r : nat -> C) (th : nat -> R) (k : nat),
       (1 <= n)%nat ->
       w0 <> 0 ->
       control5_two n ori att w0 K0 K1 r th k =
       w0 + K1 / INR n * gW n ori th k - K0 / INR n * gW n att th k +
       w0 * (K0 / INR n) * inner (expi (th k)) (row n (lap n att) k r)).

(* paley.eq3 *)
Check (paley_particles.straight_line :
  forall (r : R -> C) (th : R -> R),
       (forall t : R, is_velocity r t (expi (th t))) ->
       (forall t : R_AbsRing, is_derive th t 0) -> forall t : R, th t = th 0 /\ r t = (r 0 + t * expi (th 0))%C).

(* paley.eq3 *)
Check (paley_particles.circle :
  forall (w0 : R) (r : R -> C) (th : R -> R),
       w0 <> 0 ->
       (forall t : R, is_velocity r t (expi (th t))) ->
       (forall t : R_AbsRing, is_derive th t w0) ->
       (forall t : R, circle_centre w0 (r t) (th t) = circle_centre w0 (r 0) (th 0)) /\
       (forall t : R, Cmod (r t - circle_centre w0 (r t) (th t))%C = / Rabs w0) /\
       (exists phi : R,
          forall t : R, (r t - circle_centre w0 (r t) (th t))%C = ((/ Rabs w0)%R * expi (phi + w0 * t))%C)).

(* paley.eq7 *)
Check (paley_phase.eq7 :
  forall (n : nat) (th : nat -> R),
       (1 <= n)%nat ->
       (0 <= Cmod (order n th) <= 1 /\ (Cmod (order n th) = 1 <-> synchronized n th)) /\
       (forall (r : nat -> R -> C) (t : R),
        (forall k : nat, (k < n)%nat -> is_velocity (r k) t (expi (th k))) ->
        is_velocity (fun s : R => centre n (fun k : nat => r k s)) t (order n th) /\
        (balanced n th <-> is_velocity (fun s : R => centre n (fun k : nat => r k s)) t 0))).

(* paley.eq7 *)
Check (paley_phase.balanced_fixed_centre :
  forall (n : nat) (r : nat -> R -> C) (th : nat -> R -> R),
       (forall (k : nat) (t : R), (k < n)%nat -> is_velocity (r k) t (expi (th k t))) ->
       (forall t : R, balanced n (fun k : nat => th k t)) ->
       forall t s : R, centre n (fun k : nat => r k t) = centre n (fun k : nat => r k s)).

(* paley.eq8.ext *)
Check (paley_phase.U1_rotation :
  forall (n : nat) (th : nat -> R) (a : R), (1 <= n)%nat -> U1 n (fun k : nat => th k + a) = U1 n th).

(* paley.eq8.ext *)
Check (paley_phase.U1_extremes :
  forall (n : nat) (th : nat -> R),
       (1 <= n)%nat ->
       (synchronized n th <-> (forall th' : nat -> R, U1 n th' <= U1 n th)) /\
       (balanced n th -> forall th' : nat -> R, U1 n th <= U1 n th')).

(* paley.eq8.ext *)
Check (paley_fourier.U1_minimizers :
  forall (n : nat) (th : nat -> R),
       (2 <= n)%nat -> balanced n th <-> (forall th' : nat -> R, U1 n th <= U1 n th')).

(* paley.eq8_10 *)
Check (paley_phase.U1_gradient :
  forall (n : nat) (th : nat -> R) (k : nat), (1 <= n)%nat -> (k < n)%nat -> partial (U1 n) th k (g1 n th k)).

(* paley.eq8_10 *)
Check (paley_phase.gradient_orthogonal :
  forall (n : nat) (th : nat -> R), Sum n (g1 n th) = 0).

(* paley.eq8_10 *)
Check (paley_phase.control9_sines :
  forall (n : nat) (th : nat -> R) (k : nat) (w0 K1 : R),
       w0 + - K1 * g1 n th k = w0 + K1 / INR n * Sum n (fun j : nat => sin (th k - th j))).

(* paley.eq8_10 *)
Check (paley_phase.U1_rate :
  forall (n : nat) (th : nat -> R -> R) (w0 K1 : R) (t : R_AbsRing),
       (1 <= n)%nat ->
       (forall k : nat, (k < n)%nat -> is_derive (th k) t (w0 + - K1 * g1 n (fun k0 : nat => th k0 t) k)) ->
       is_derive (fun s : R_AbsRing => U1 n (fun k : nat => th k s)) t
         (- K1 * Sum n (fun k : nat => g1 n (fun k0 : nat => th k0 t) k ^ 2))).

(* paley.fig2, paley.graph *)
Check (paley_fourier.dft_diagonalizes :
  forall (n : nat) (adj : graph) (s : nat -> bool) (m : nat),
       (1 <= n)%nat ->
       circulant n adj s -> eigenvector n (lap n adj) (circulant_eigenvalue n s m) (fun k : nat => dft n k m)).

(* paley.fig2 *)
Check (paley_fourier.ring_eigenvalue :
  forall n m : nat,
       (3 <= n)%nat -> circulant_eigenvalue n (ring_offset n) m = 2 - 2 * cos (2 * PI * INR m / INR n)).

(* paley.fig2 *)
Check (paley_fourier.wave_polygon :
  forall n m k : nat,
       (1 <= n)%nat ->
       (k < n)%nat -> expi (wave n m ((k + 1) mod n)) = (expi (2 * PI * INR m / INR n) * expi (wave n m k))%C).

(* paley.fig2.caption *)
Check (paley_patterns.fig2_caption_printed_fails :
  ~
       (forall (lam : C) (th : nat -> R),
        eigenvector 12 (lap 12 (ring_graph 12)) lam (phasors th) -> exists M : nat, pattern M 12 th)).

(* paley.fig3.max *)
Check (paley_fish.ring_max :
  forall (n : nat) (th : nat -> R),
       (3 <= n)%nat ->
       W1 n (ring_graph n) th <= 2 /\
       (W1 n (ring_graph n) th = 2 <-> (forall j k : nat, arc n (ring_graph n) j k -> cos (th j - th k) = -1))).

(* paley.fig3.max *)
Check (paley_fish.ring_maximizer_pattern :
  forall (n : nat) (th : nat -> R),
       (3 <= n)%nat -> W1 n (ring_graph n) th = 2 -> pattern 2 n th /\ balanced n th).

(* paley.fish.zero *)
Check (paley_laplacian.fish_zero :
  forall (n : nat) (adj : graph) (th : nat -> R),
       (1 <= n)%nat ->
       0 <= W1 n adj th /\
       (synchronized n th -> W1 n adj th = 0) /\
       (W1 n adj th = 0 -> forall j k : nat, weakly_joined n adj j k -> expi (th j) = expi (th k))).

(* paley.fish28ori *)
Check (paley_fish.fish28_alignment :
  forall (n : nat) (adj : graph) (K0 K1 Kori : R) (th : nat -> R) (k : nat),
       (1 <= n)%nat -> K1 - K0 = - Kori * INR n -> (K1 - K0) / INR n * gW n adj th k = - Kori * gW n adj th k).

(* paley.fishpeak *)
Check (paley_fish.fish_peak :
  forall a : R, 2 / (INR 3 + 1) * W1 4 complete (fun k : nat => if k =? 0 then a + PI else a) = 75 / 100).

(* paley.gradW *)
Check (paley_gradient.W1_gradient_undirected :
  forall (n : nat) (adj : graph) (th : nat -> R) (k : nat),
       (1 <= n)%nat ->
       undirected adj ->
       (k < n)%nat ->
       / (2 * INR n) *
       inner (Ci * expi (th k))%C (row n (fun k0 j : nat => lap n adj k0 j + lap n adj j k0) k (phasors th)) =
       / INR n * gW n adj th k /\ partial (W1 n adj) th k (/ INR n * gW n adj th k)).

(* paley.gradW *)
Check (paley_gradient.W1_gradient :
  forall (n : nat) (adj : graph) (th : nat -> R) (k : nat),
       (1 <= n)%nat ->
       (k < n)%nat ->
       partial (W1 n adj) th k
         (/ (2 * INR n) *
          inner (Ci * expi (th k))%C (row n (fun k0 j : nat => lap n adj k0 j + lap n adj j k0) k (phasors th)))).

(* paley.graph *)
Check (paley_gradient.lap_eigenvalues :
  forall (n : nat) (adj : graph) (lam : C) (x : nat -> C),
       eigenvector n (lap n adj) lam x -> (exists k : nat, (k < n)%nat /\ x k <> 0) -> 0 <= fst lam).

(* paley.graph *)
Check (paley_gradient.lap_ones :
  forall (n : nat) (adj : graph) (c : R) (k : nat), (k < n)%nat -> lmul n adj (fun _ : nat => c) k = 0).

(* paley.graph *)
Check (paley_gradient.lap_zero_simple :
  forall (n : nat) (adj : graph) (m : nat) (y : nat -> R),
       (1 <= n)%nat ->
       strongly_connected n adj ->
       (forall k : nat, (k < n)%nat -> lpow n adj (S m) y k = 0) ->
       exists c : R, forall k : nat, (k < n)%nat -> y k = c).

(* paley.graph *)
Check (paley_gradient.lap_psd :
  forall (n : nat) (adj : graph) (x : nat -> C),
       undirected adj ->
       (forall k j : nat, lap n adj k j = lap n adj j k) /\
       0 <= Sum n (fun k : nat => inner (x k) (row n (lap n adj) k x))).

(* paley.graph *)
Check (paley_fourier.dft_unitary :
  forall n m l : nat,
       (1 <= n)%nat ->
       (m < n)%nat -> (l < n)%nat -> Csum n (fun k : nat => (Cconj (dft n k m) * dft n k l)%C) = delta m l).

(* paley.incid *)
Check (paley_laplacian.incidence_printed_fails :
  ~
       (forall (n : nat) (adj : graph) (E : list (nat * nat)) (k m : nat),
        undirected adj ->
        no_loops adj ->
        lists_edges n adj E ->
        (k < n)%nat -> (m < n)%nat -> lap n adj k m = lsum E (fun f : nat * nat => inc k f * inc m f))).

(* paley.incid *)
Check (paley_laplacian.incidence_directed :
  forall (n : nat) (adj : graph) (E : list (nat * nat)) (k m : nat),
       undirected adj ->
       no_loops adj ->
       lists_edges n adj E ->
       (k < n)%nat -> (m < n)%nat -> lsum E (fun f : nat * nat => inc k f * inc m f) = 2 * lap n adj k m).

(* one column for each edge, with its direction *)
Check (eq_refl : inc = fun k f => delta k (snd f) - delta k (fst f)).
Check (eq_refl : tanner_graph.oriented = fun n adj B => NoDup B /\
       (forall i j : nat, In (i, j) B -> (i < n)%nat /\ (j < n)%nat) /\
       (forall i j : nat, (i < n)%nat -> (j < n)%nat -> member B (i, j) + member B (j, i) = w adj i j)).
Check (eq_refl : member = fun B e => if in_dec pair_dec e B then 1 else 0).
(* paley.incid *)
Check (tanner_graph.L_incidence :
  forall (n : nat) (adj : graph) (B : list (nat * nat)) (k m : nat),
       undirected adj ->
       tanner_graph.oriented n adj B ->
       (k < n)%nat -> (m < n)%nat -> lsum B (fun f : nat * nat => inc k f * inc m f) = lap n adj k m).

(* paley.length *)
Check (paley_laplacian.length_printed_fails :
  ~
       (forall (n : nat) (adj : graph) (E : list (nat * nat)) (x : nat -> C),
        (1 <= n)%nat ->
        undirected adj ->
        no_loops adj ->
        lists_edges n adj E ->
        Q n (lap n adj) x = / (2 * INR n) * lsum E (fun e : nat * nat => dist2 (x (fst e)) (x (snd e))))).

(* paley.length *)
Check (paley_laplacian.length_corrected :
  forall (n : nat) (adj : graph) (E : list (nat * nat)) (x : nat -> C),
       (1 <= n)%nat ->
       undirected adj ->
       lists_edges n adj E ->
       Q n (lap n adj) x = / (4 * INR n) * lsum E (fun e : nat * nat => dist2 (x (fst e)) (x (snd e)))).

(* paley.length *)
Check (paley_laplacian.length_once :
  forall (n : nat) (adj : graph) (x : nat -> C),
       (1 <= n)%nat ->
       undirected adj ->
       no_loops adj ->
       Q n (lap n adj) x =
       / (2 * INR n) * Sum n (fun k : nat => Sum k (fun j : nat => w adj k j * dist2 (x j) (x k)))).

(* paley.patterns.two *)
Check (paley_patterns.two_patterns :
  forall n : nat, (1 <= n)%nat -> pattern 1 n (pattern_phases 1) /\ pattern n n (pattern_phases n)).

(* paley.patterns.two *)
Check (paley_patterns.two_patterns_differ :
  forall (n : nat) (th : nat -> R), (2 <= n)%nat -> pattern 1 n th -> ~ pattern n n th).

(* paley.patterns.two *)
Check (paley_patterns.one_pattern_only :
  forall (M : nat) (th : nat -> R), (pattern M 1 th -> M = 1%nat) /\ pattern 1 1 th).

(* paley.ref *)
Check (paley_fish.reference :
  forall (n : nat) (adj : graph) (th0 : R) (th : nat -> R),
       (1 <= n)%nat ->
       0 <= W1 n adj th + 1 - cos (th0 - th (n - 1)%nat) /\ W1 n adj (fun _ : nat => th0) + 1 - cos (th0 - th0) = 0).

(* paley.scale *)
Check (paley_fish.scale_printed_fails :
  ~
       (forall (n m : nat) (adj : graph) (r : nat -> C) (th : nat -> R),
        (1 <= m < n)%nat -> nearest n m adj r -> (2 / INR m + 1) * W1 n adj th <= 1) /\
       ~
       (forall (n m : nat) (adj : graph) (r : nat -> C) (th : nat -> R),
        (1 <= m < n)%nat -> nearest n m adj r -> 2 / (INR m + 1) * W1 n adj th <= 1)).

(* paley.scale *)
Check (paley_fish.W1_le_degree :
  forall (n : nat) (adj : graph) (th : nat -> R) (d : R),
       (1 <= n)%nat -> (forall k : nat, (k < n)%nat -> deg n adj k = d) -> 0 <= W1 n adj th <= d).

(* the nearest m of n fish are the neighbours *)
Check (eq_refl : nearest = fun n m adj r => forall k : nat, (k < n)%nat -> adj k k = false /\ deg n adj k = INR m /\
       forall i j : nat, (i < n)%nat -> (j < n)%nat -> i <> k -> adj k j = true -> adj k i = false ->
       Cmod (r j - r k)%C <= Cmod (r i - r k)%C).
(* paley.scale *)
Check (paley_fish.scale_all_neighbours :
  forall (N : nat) (adj : graph) (r : nat -> C) (th : nat -> R),
       (2 <= N)%nat -> nearest N (N - 1) adj r -> 0 <= 2 / (INR (N - 1) + 1) * W1 N adj th <= 1).

(* paley.scale.complete *)
Check (paley_fish.scale_complete_printed_fails :
  forall (n : nat) (th : nat -> R),
       (2 <= n)%nat ->
       Cmod (order n th) <> 1 -> (2 / INR (n - 1) + 1) * W1 n complete th <> 1 - Cmod (order n th) ^ 2).

(* paley.scale.complete *)
Check (paley_fish.scale_complete_corrected :
  forall (n : nat) (th : nat -> R),
       (2 <= n)%nat -> 2 / (INR (n - 1) + 1) * W1 n complete th = 1 - Cmod (order n th) ^ 2).

(* paley.sync.par *)
Check (paley_fish.sync_par_printed_fails :
  ~
       (forall (n : nat) (th : nat -> R -> R) (om : nat -> R),
        (forall (k : nat) (t : R_AbsRing), (k < n)%nat -> is_derive (th k) t (om k)) ->
        (forall t : R, synchronized n (fun k : nat => th k t)) ->
        (forall j k : nat, (j < n)%nat -> (k < n)%nat -> om k - om j = 0) -> forall k : nat, (k < n)%nat -> om k = 0)).



(* paley.thm1.saddle *)
Check (paley_phase.thm1_saddle :
  forall (n : nat) (th : nat -> R),
       (1 <= n)%nat ->
       stationary n (U1 n) th ->
       ~ synchronized n th ->
       ~ balanced n th ->
       (forall j k : nat, (j < n)%nat -> (k < n)%nat -> sin (th k - th j) = 0) /\ saddle n (U1 n) th).

(* paley.thm1.sync *)
Check (paley_stability.thm1_synchronize :
  forall (n : nat) (w0 K1 : R) (th : nat -> R -> R),
       (1 <= n)%nat ->
       K1 <> 0 ->
       (forall (t : R) (k : nat),
        0 <= t -> (k < n)%nat -> is_derive (th k) t (w0 + - K1 * g1 n (fun j : nat => th j t) k)) ->
       K1 < 0 ->
       1 - / INR n < Cmod (order n (fun j : nat => th j 0)) ->
       forall t : R,
       0 <= t ->
       INR n / 2 - U1 n (fun j : nat => th j t) <=
       (INR n / 2 - U1 n (fun j : nat => th j 0)) * exp (- (- K1 * Cmod (order n (fun j : nat => th j 0)) ^ 2) * t) /\
       (forall j k : nat,
        (j < n)%nat ->
        (k < n)%nat -> 1 - cos (th j t - th k t) <= 2 * INR n * (INR n / 2 - U1 n (fun j0 : nat => th j0 t)))).

(* paley.thm2.center *)
Check (paley_particles.thm2_limit_set :
  forall (n : nat) (adj : graph) (w0 K0 : R) (r : nat -> R -> C) (th : nat -> R -> R),
       (1 <= n)%nat ->
       undirected adj ->
       strongly_connected n adj ->
       w0 <> 0 ->
       0 < K0 ->
       (forall (k : nat) (t : R), (k < n)%nat -> is_velocity (r k) t (expi (th k t))) ->
       (forall (k : nat) (t : R_AbsRing),
        (k < n)%nat ->
        is_derive (th k) t
          (w0 + w0 * (K0 / INR n * aS n adj w0 (fun k0 : nat => r k0 t) (fun k0 : nat => th k0 t) k))) ->
       (forall t : R,
        spacing n adj w0 (fun k : nat => r k t) (fun k : nat => th k t) =
        spacing n adj w0 (fun k : nat => r k 0) (fun k : nat => th k 0)) ->
       (forall (k : nat) (t : R_AbsRing), (k < n)%nat -> is_derive (th k) t w0) /\
       (exists c0 : C, forall (k : nat) (t : R), (k < n)%nat -> circle_centre w0 (r k t) (th k t) = c0)).

(* paley.thm3.min *)
Check (paley_patterns.thm3_minimizers :
  forall (n M q : nat) (K th : nat -> R),
       (1 <= q)%nat ->
       (1 <= M)%nat ->
       n = (q * M)%nat ->
       (forall m : nat, (1 <= m < M)%nat -> 0 < K m) ->
       K M < 0 -> pattern M n th <-> (forall th' : nat -> R, UMN n M K th <= UMN n M K th')).

(* paley.vatt, corrected: v = - sum rhat_kj shortens the sum of the distances to the neighbours at the rate |v|^2, and with K > 0 a heading
   that turns at the rate K <i e^{i th}, v> does not turn away from v *)
Check (paley_behaviours.attraction :
  forall (n : nat) (nbr : nat -> bool) (r : nat -> C) (k : nat),
       (forall j : nat, (j < n)%nat -> nbr j = true -> r j <> r k) ->
       let v := (- Csum n (fun j : nat => RtoC (if nbr j then 1 else 0) * paley_fish.unit_from (r k) (r j)))%C in
       is_derive (fun s : R => Sum n (fun j : nat => (if nbr j then 1 else 0) * Cmod (r k + RtoC s * v - r j)%C)) 0
         (- Cmod v ^ 2) /\
       (forall (K : R) (th : R -> R) (a b : R), 0 < K -> a <= b ->
          (forall t : R, a <= t <= b -> is_derive th t (K * inner (Ci * expi (th t))%C v)) ->
          inner (expi (th a)) v <= inner (expi (th b)) v)).

(* paley.vrep, corrected: the same with v = sum rhat_kj, which lengthens them *)
Check (paley_behaviours.repulsion :
  forall (n : nat) (nbr : nat -> bool) (r : nat -> C) (k : nat),
       (forall j : nat, (j < n)%nat -> nbr j = true -> r j <> r k) ->
       let v := Csum n (fun j : nat => RtoC (if nbr j then 1 else 0) * paley_fish.unit_from (r k) (r j))%C in
       is_derive (fun s : R => Sum n (fun j : nat => (if nbr j then 1 else 0) * Cmod (r k + RtoC s * v - r j)%C)) 0
         (Cmod v ^ 2) /\
       (forall (K : R) (th : R -> R) (a b : R), 0 < K -> a <= b ->
          (forall t : R, a <= t <= b -> is_derive th t (K * inner (Ci * expi (th t))%C v)) ->
          inner (expi (th a)) v <= inner (expi (th b)) v)).
Check (fun rk rj : C => eq_refl : paley_fish.unit_from rk rj = (RtoC (/ Cmod (rk - rj)) * (rk - rj))%C).

(* paley.vatt *)
Check (paley_fish.vatt_printed_repels :
  forall r : nat -> C,
       r 0%nat <> r 1%nat ->
       exists d : R_NormedModule,
         is_derive (fun s : R_AbsRing => dist2 (r 0%nat + s * v_att 2 (fun j : nat => j =? 1) r 0)%C (r 1%nat)) 0 d /\
         0 < d).

(* paley.vrep *)
Check (paley_fish.vrep_printed_attracts :
  forall r : nat -> C,
       r 0%nat <> r 1%nat ->
       exists d : R_NormedModule,
         is_derive (fun s : R_AbsRing => dist2 (r 0%nat + s * v_rep 2 (fun j : nat => j =? 1) r 0)%C (r 1%nat)) 0 d /\
         d < 0).

(* paley.zero.dir *)
Check (paley_laplacian.zero_dir_printed_fails :
  ~
       (forall (n : nat) (adj : graph) (th : nat -> R),
        (1 <= n)%nat ->
        no_loops adj ->
        ~ strongly_connected n adj ->
        W1 n adj th = 0 <->
        (forall j k : nat, (j < n)%nat -> (k < n)%nat -> same_strong n adj j k -> expi (th j) = expi (th k)))).

(* paley.zero.dir *)
Check (paley_laplacian.W1_weakly :
  forall (n : nat) (adj : graph) (th : nat -> R),
       (1 <= n)%nat -> W1 n adj th = 0 <-> (forall j k : nat, weakly_joined n adj j k -> expi (th j) = expi (th k))).

(* the spacing loop for all t >= 0, and centres of circles that tend to one point *)
Check (eq_refl : paley_centre.spaced = fun n adj w0 K0 r th => forall k t, (k < n)%nat -> 0 <= t ->
  is_velocity (r k) t (expi (th k t)) /\
  is_derive (th k) t (w0 + w0 * (K0 / INR n * aS n adj w0 (fun j => r j t) (fun j => th j t) k))).
Check (eq_refl : paley_centre.centres_tend = fun n w0 r th c => forall k, (k < n)%nat -> forall e, 0 < e ->
  exists T, forall t, T <= t -> Cmod (circle_centre w0 (r k t) (th k t) - c)%C < e).

(* paley.thm2.center, clause 2 *)
Check (paley_centre.centre_by_start :
  forall (n : nat) (adj : graph) (w0 K0 : R) (r r' : nat -> R -> C) (th th' : nat -> R -> R) (c c' : C), (1 <= n)%nat ->
       paley_centre.spaced n adj w0 K0 r th -> paley_centre.spaced n adj w0 K0 r' th' ->
       (forall k, (k < n)%nat -> r k 0 = r' k 0 /\ th k 0 = th' k 0) ->
       paley_centre.centres_tend n w0 r th c -> paley_centre.centres_tend n w0 r' th' c' -> c = c').

(* paley.thm2.center, clauses 1 and 3: every solution, one point c0 *)
Check (paley_convergence.centres_meet :
  forall (n : nat) (adj : graph) (w0 K0 : R) (r : nat -> R -> C) (th : nat -> R -> R), (1 <= n)%nat ->
       undirected adj -> strongly_connected n adj -> w0 <> 0 -> 0 < K0 -> paley_centre.spaced n adj w0 K0 r th ->
       exists (c0 : C) (T A m : R), 0 <= T /\ 0 < m /\ forall k t, (k < n)%nat -> T <= t ->
         Cmod (circle_centre w0 (r k t) (th k t) - c0)%C <= A * exp (- m * t) /\
         Rabs (w0 * (K0 / INR n * aS n adj w0 (fun j => r j t) (fun j => th j t) k)) <= A * exp (- m * t)).

(* paley.thm2: every solution tends to a circular formation, in position and in heading; the last line says that position and heading belong
   to one circle about c0, and the angle phi + w0 t about c0 turns in the direction of the sign of w0 *)
Check (paley_convergence.thm2 :
  forall (n : nat) (adj : graph) (w0 K0 : R) (r : nat -> R -> C) (th : nat -> R -> R), (1 <= n)%nat ->
       undirected adj -> strongly_connected n adj -> w0 <> 0 -> 0 < K0 -> paley_centre.spaced n adj w0 K0 r th ->
       exists (c0 : C) (T A m : R), 0 < m /\ forall k, (k < n)%nat -> exists psi phi : R, forall t, T <= t ->
         Rabs (th k t - (psi + w0 * t)) <= A * exp (- m * t) /\
         Cmod (r k t - (c0 + RtoC (/ Rabs w0) * expi (phi + w0 * t)))%C <= A * exp (- m * t) /\
         circle_centre w0 (c0 + RtoC (/ Rabs w0) * expi (phi + w0 * t))%C (psi + w0 * t) = c0).

(* paley.eq12.pos, paley.zero.dir *)
Check (paley_laplacian.W1_positive :
  forall (n : nat) (adj : graph) (th : nat -> R), (1 <= n)%nat ->
       ~ (forall j k, clos_refl_sym_trans nat (arc n adj) j k -> expi (th j) = expi (th k)) -> 0 < W1 n adj th).
(* paley.eq28, corrected: (27) with its three fields, z the heading of fish k *)
Check (eq_refl : behaviour = fun wk Krep Kori Katt z rep ori att => wk + inner (Ci * z)%C (RtoC Krep * rep + RtoC Kori * ori + RtoC Katt * att)%C).
Check (eq_refl : v_ori = fun n nbr th k => (expi (th k) + Csum n (fun j => RtoC (if nbr j then 1 else 0) * expi (th j)))%C).
Check (eq_refl : v_att_plain = fun n nbr r k => (- Csum n (fun j => RtoC (if nbr j then 1 else 0) * (r k - r j)))%C).
Check (paley_behaviours.eq28_corrected :
  forall (n : nat) (rep : nat -> bool) (ori att : graph) (r : nat -> C) (th : nat -> R) (wk Krep Kori Katt : R) (k : nat),
       (k < n)%nat -> (forall j, (j < n)%nat -> rep j = false) ->
       behaviour wk Krep Kori Katt (expi (th k)) (v_rep n rep r k) (v_ori n (ori k) th k) (v_att_plain n (att k) r k) =
       wk - Kori * inner (Ci * expi (th k))%C (row n (lap n ori) k (fun j => expi (th j))) - Katt * inner (Ci * expi (th k))%C (row n (lap n att) k r)).
Check (paley_behaviours.eq28_steers :
  forall (n : nat) (ori att : graph) (r : nat -> C) (th : nat -> R) (K : R) (k : nat), (k < n)%nat ->
       let s := Csum n (fun j => RtoC (w att k j) * (r j - r k))%C in let m := Csum n (fun j => RtoC (w ori k j) * expi (th j))%C in
       - K * inner (Ci * expi (th k))%C (row n (lap n att) k r) = K * inner (Ci * expi (th k))%C s /\
       - K * inner (Ci * expi (th k))%C (row n (lap n ori) k (fun j => expi (th j))) = K * inner (Ci * expi (th k))%C m /\
       forall (v : C) (ph : R -> R) t, v = s \/ v = m -> 0 < K -> is_derive ph t (K * inner (Ci * expi (ph t))%C v) ->
         exists d, is_derive (fun x => inner (expi (ph x)) v) t d /\ 0 <= d /\ (inner (Ci * expi (ph t))%C v <> 0 -> 0 < d)).
Check (paley_behaviours.eq28_distances :
  (forall (n : nat) (att : nat -> bool) (r : nat -> C) (th : nat -> R) (wk Krep Kori Katt : R) (rep ori : C) (k : nat),
       (forall j, (j < n)%nat -> att j = true -> Cmod (r k - r j)%C = 1) ->
       behaviour wk Krep Kori Katt (expi (th k)) rep ori (- v_att n att r k)%C = behaviour wk Krep Kori Katt (expi (th k)) rep ori (v_att_plain n att r k)) /\
  exists (r : nat -> C) (att : nat -> bool) (th : nat -> R), r 0%nat <> r 1%nat /\
       behaviour 0 0 0 1 (expi (th 0%nat)) (RtoC 0) (RtoC 0) (- v_att 2 att r 0)%C <> behaviour 0 0 0 1 (expi (th 0%nat)) (RtoC 0) (RtoC 0) (v_att_plain 2 att r 0)).
(* paley.figS3.difference *)
Check (paley_fish.figS3_difference :
  forall (n : nat) (g h : graph) (a b : nat) (th : nat -> R), (1 <= n)%nat -> (1 <= a)%nat -> (1 <= b)%nat ->
       (forall k, (k < n)%nat -> deg n g k = INR a) -> (forall k, (k < n)%nat -> deg n h k = INR b) ->
       let mean := fun f => Sum n (fun k => Sum n (fun j => w f k j * (1 - cos (th j - th k)))) / Sum n (deg n f) in
       (0 < W1 n h th / INR b - W1 n g th / INR a <-> mean g < mean h)).
(* paley.sync.par, corrected; paley.unbal, paley.thm1.saddle: equilibria *)
Check (paley_fish.sync_par :
  forall (n : nat) (th dth : nat -> R -> R), (forall k t, (k < n)%nat -> is_derive (th k) t (dth k t)) ->
       (forall t j k, (j < n)%nat -> (k < n)%nat -> expi (th j t) = expi (th k t)) ->
       (forall j k t, (j < n)%nat -> (k < n)%nat -> dth j t = dth k t) /\
       (forall k t, (k < n)%nat -> is_velocity (fun s => expi (th k s)) t (RtoC (dth k t) * (Ci * expi (th k t)))%C) /\
       (forall k t, (k < n)%nat -> (is_velocity (fun s => expi (th k s)) t (RtoC 0) <-> dth k t = 0))).
Check (paley_fish.sync_rate :
  forall (n : nat) (adj : graph) (th : nat -> R) (w0 K : R) (k : nat), (k < n)%nat ->
       (forall i j, (i < n)%nat -> (j < n)%nat -> expi (th i) = expi (th j)) ->
       w0 + - K * inner (Ci * expi (th k))%C (order n th) = w0 /\ w0 + K / INR n * gW n adj th k = w0).
Check (paley_fish.sines_rest :
  forall (n : nat) (th : nat -> R) (w0 K : R) (k : nat), (forall j, (j < n)%nat -> sin (th k - th j) = 0) ->
       w0 + - K * inner (Ci * expi (th k))%C (order n th) = w0).
Check (paley_fish.clusters_rest :
  forall (n : nat) (th : nat -> R) (a w0 K : R) (k : nat), (k < n)%nat -> (forall j, (j < n)%nat -> th j = a \/ th j = a + PI) ->
       w0 + - K * inner (Ci * expi (th k))%C (order n th) = w0).
(* columns of the Fourier matrix and (u, v, -u, -v, ..) on the ring: beyond.paley.cyclic_eigenvectors, paley.fig2.caption *)
Check (paley_fish.fourier_column :
  forall n m : nat, (3 <= n)%nat ->
       eigenvector n (lap n (ring_graph n)) (RtoC (2 - 2 * cos (2 * PI * INR m / INR n))) (fun k => expi (wave n m k)) /\ pattern (n / Nat.gcd n m) n (wave n m)).
Check (paley_fourier.ring_antipodal :
  forall (p : nat) (x : nat -> C), (1 <= p)%nat -> (forall j, x (j + 2)%nat = (- x j)%C) ->
       eigenvector (4 * p) (lap (4 * p) (ring_graph (4 * p))) (RtoC 2) x).
Check (paley_fourier.ring_unit_eigenvectors :
  forall (n : nat) (th : nat -> R) (lam : C), (3 <= n)%nat -> eigenvector n (lap n (ring_graph n)) lam (fun k => expi (th k)) ->
       (exists m, (m < n)%nat /\ forall k, (k < n)%nat -> expi (th k) = (expi (th 0%nat) * expi (wave n m k))%C) \/
       ((exists p, n = (4 * p)%nat) /\ forall k, (k < n)%nat -> expi (th ((k + 2) mod n)) = (- expi (th k))%C)).
Check (paley_fish.ring_patterns :
  forall n : nat, (3 <= n)%nat ->
       ((forall lam th, eigenvector n (lap n (ring_graph n)) lam (fun k => expi (th k)) -> exists M, pattern M n th) <-> ~ exists p, n = (4 * p)%nat)).
