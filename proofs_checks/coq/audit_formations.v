(* Audit of shape space, of the phases that maximise W_1 on circulant graphs and of the spacing terms of (22) and (28): each theorem of theorems.tsv with its statement written
   out; the objects of the statements are restated first. *)
From Coq Require Import Reals.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums paley_model paley_phase paley_laplacian paley_gradient paley_particles paley_fourier.
From Flockproof Require paley_patterns paley_composite paley_fish paley_releq paley_bal.
Open Scope R_scope.

Check (eq_refl : expi = fun t => (cos t, sin t)).
Check (eq_refl : lap = fun n adj k j => delta k j * Sum n (w adj k) - w adj k j).
Check (eq_refl : Q = fun n A x => / (2 * INR n) * Sum n (fun k => inner (x k) (Csum n (fun j => RtoC (A k j) * x j)%C))).
Check (eq_refl : W1 = fun n adj th => Q n (lap n adj) (fun k => expi (th k))).
Check (eq_refl : balanced = fun n th => order n th = RtoC 0).
Check (eq_refl : circulant = fun n adj s => forall k j, (k < n)%nat -> (j < n)%nat -> adj k j = s ((j + n - k) mod n)%nat).
Check (eq_refl : eigenvector = fun n A lam x => forall k, (k < n)%nat -> row n A k x = (lam * x k)%C).
Check (eq_refl : is_velocity = fun r t v => is_derive (fun s => fst (r s)) t (fst v) /\ is_derive (fun s => snd (r s)) t (snd v)).
Check (eq_refl : circle_centre = fun w0 r th => (r + RtoC (/ w0) * (Ci * expi th))%C).
Check (eq_refl : control5 = fun n adj w0 K0 K1 r th t k => w0 + K1 / INR n * gW n adj (fun j => th j t) k + w0 * (K0 / INR n * aS n adj w0 (fun j => r j t) (fun j => th j t) k)).

(* ---- paley.releq ---- *)
Check (eq_refl : paley_releq.turn = fun th k j => expi (th k - th j)).
Check (eq_refl : paley_releq.place = fun r th k j => ((r k - r j) * expi (- th k))%C).
Check (eq_refl : paley_releq.same_shape = fun n r th r' th' => forall k j, (k < n)%nat -> (j < n)%nat ->
  paley_releq.turn th k j = paley_releq.turn th' k j /\ paley_releq.place r th k j = paley_releq.place r' th' k j).
Check (eq_refl : paley_releq.moved = fun n a b r th r' th' => forall k, (k < n)%nat -> expi (th' k) = expi (th k + a) /\ r' k = (expi a * r k + b)%C).
Check (eq_refl : paley_releq.shape_control = fun n u => forall r th r' th', paley_releq.same_shape n r th r' th' -> forall k, (k < n)%nat -> u r th k = u r' th' k).
Check (eq_refl : paley_releq.closed_loop = fun n u r th => forall k t, (k < n)%nat -> 0 <= t ->
  is_velocity (r k) t (expi (th k t)) /\ is_derive (th k) t (u (fun j => r j t) (fun j => th j t) k)).
Check (eq_refl : paley_releq.shape_rests = fun n r th => forall t, 0 <= t -> paley_releq.same_shape n (fun k => r k 0) (fun k => th k 0) (fun k => r k t) (fun k => th k t)).
Check (eq_refl : paley_releq.relative_equilibrium = fun n u r0 th0 => exists r th, paley_releq.closed_loop n u r th /\
  (forall k, (k < n)%nat -> r k 0 = r0 k /\ th k 0 = th0 k) /\ paley_releq.shape_rests n r th).
Check (eq_refl : paley_releq.parallel_formation = fun n v th => forall k j, (k < n)%nat -> (j < n)%nat -> v k = 0 /\ expi (th k) = expi (th j)).
Check (eq_refl : paley_releq.circular_formation = fun n v r th => exists u, u <> 0 /\ forall k j, (k < n)%nat -> (j < n)%nat ->
  v k = u /\ circle_centre u (r k) (th k) = circle_centre u (r j) (th j)).
(* paley.releq, clause 1 *)
Check (paley_releq.evolves_on_shapes : forall n u, paley_releq.shape_control n u -> forall r th r' th' t t', paley_releq.closed_loop n u r th -> paley_releq.closed_loop n u r' th' -> 0 <= t -> 0 <= t' ->
  paley_releq.same_shape n (fun k => r k t) (fun k => th k t) (fun k => r' k t') (fun k => th' k t') -> forall k j, (k < n)%nat -> (j < n)%nat -> exists (d : R) (e : C),
  is_derive (fun s => th k s - th j s) t d /\ is_derive (fun s => th' k s - th' j s) t' d /\
  is_velocity (fun s => paley_releq.place (fun i => r i s) (fun i => th i s) k j) t e /\ is_velocity (fun s => paley_releq.place (fun i => r' i s) (fun i => th' i s) k j) t' e).
(* paley.releq, clause 2 *)
Check (paley_releq.three_fewer : forall n, (1 <= n)%nat ->
  (forall r th r' th', paley_releq.same_shape n r th r' th' <-> exists a b, paley_releq.moved n a b r th r' th') /\
  (forall a b r th, paley_releq.moved n a b r th r th -> expi a = RtoC 1 /\ b = RtoC 0) /\
  (forall (s : nat -> C) (a : nat -> R), exists r th, forall k, (1 <= k < n)%nat -> paley_releq.place r th 0 k = s k /\ paley_releq.turn th k 0 = expi (a k)) /\
  (forall r th r' th', (forall k, (1 <= k < n)%nat -> paley_releq.place r th 0 k = paley_releq.place r' th' 0 k /\ paley_releq.turn th k 0 = paley_releq.turn th' k 0) <->
    paley_releq.same_shape n r th r' th')).
(* paley.releq, clauses 3 and 4 *)
Check (paley_releq.relative_equilibria : forall n u r0 th0, paley_releq.shape_control n u ->
  (paley_releq.relative_equilibrium n u r0 th0 <-> paley_releq.parallel_formation n (u r0 th0) th0 \/ paley_releq.circular_formation n (u r0 th0) r0 th0)).

(* ---- paley.thm3.stab, clause 1 ---- *)
Check (eq_refl : paley_patterns.pattern = fun M n th => (1 <= M)%nat /\ exists (th0 : R) (cl : nat -> nat),
  (forall k, (k < n)%nat -> (cl k < M)%nat /\ expi (th k) = expi (th0 + 2 * PI * INR (cl k) / INR M)) /\
  (forall l, (l < M)%nat -> INR M * Sum n (fun k => delta (cl k) l) = INR n)).
Check (eq_refl : paley_releq.pattern_law = fun n adj w0 K0 M K r th k => w0 - paley_composite.gUMN n M K th k + w0 * (K0 / INR n * aS n adj w0 r th k)).
Check (paley_composite.UMN_gradient : forall n M K th k, (1 <= n)%nat -> (k < n)%nat -> partial (paley_patterns.UMN n M K) th k (paley_composite.gUMN n M K th k)).
Check (paley_releq.pattern_equilibrium : forall n adj w0 K0 M K r0 th0, (1 <= n)%nat -> w0 <> 0 -> paley_patterns.pattern M n th0 ->
  (forall k j, (k < n)%nat -> (j < n)%nat -> circle_centre w0 (r0 k) (th0 k) = circle_centre w0 (r0 j) (th0 j)) ->
  paley_releq.relative_equilibrium n (paley_releq.pattern_law n adj w0 K0 M K) r0 th0 /\ forall k, (k < n)%nat -> paley_releq.pattern_law n adj w0 K0 M K r0 th0 k = w0).

(* ---- paley.bal.circ (corrected), clauses 2 and 3: the phases of a circular formation are any phases ---- *)
Check (eq_refl : paley_bal.maximises = fun n adj th => forall th', W1 n adj th' <= W1 n adj th).
Check (eq_refl : paley_bal.largest_eigenvalue = fun n adj l => (exists x, (exists k, (k < n)%nat /\ x k <> RtoC 0) /\ eigenvector n (lap n adj) (RtoC l) x) /\
  forall (mu : C) x, (exists k, (k < n)%nat /\ x k <> RtoC 0) -> eigenvector n (lap n adj) mu x -> snd mu = 0 /\ fst mu <= l).
Check (paley_bal.maximisers_balanced : forall n adj s, (2 <= n)%nat -> undirected adj -> circulant n adj s -> strongly_connected n adj ->
  exists l, paley_bal.largest_eigenvalue n adj l /\ 0 < l /\ (exists th, paley_bal.maximises n adj th) /\
  forall th, paley_bal.maximises n adj th -> eigenvector n (lap n adj) (RtoC l) (phasors th) /\ balanced n th).
Check (paley_bal.complete_maximisers : forall n th, (2 <= n)%nat -> (paley_bal.maximises n complete th <-> balanced n th)).

(* ---- paley.fish28ori, clause 2 ---- *)
Check (eq_refl : paley_fish.control28 = fun n adj w0 Kori Katt r th k => w0 - Kori * gW n adj th k + Katt * inner (Ci * expi (th k))%C (row n (lap n adj) k r)).
Check (paley_fish.fish28_spacing : forall n adj w0 K0 K1 Kori (r : nat -> R -> C) (th : nat -> R -> R) k t, (1 <= n)%nat -> w0 <> 0 -> K1 - K0 = - Kori * INR n ->
  let term z := w0 * K0 / INR n * inner z (row n (lap n adj) k (fun j => r j t)) in
  control5 n adj w0 K0 K1 r th t k = w0 - Kori * gW n adj (fun j => th j t) k + term (expi (th k t)) /\
  paley_fish.control28 n adj w0 Kori (w0 * K0 / INR n) (fun j => r j t) (fun j => th j t) k = w0 - Kori * gW n adj (fun j => th j t) k + term (Ci * expi (th k t))%C).
