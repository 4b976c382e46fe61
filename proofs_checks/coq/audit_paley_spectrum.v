(* Audit of the theorems about the spectrum of circular formations and about inertia: each with its statement written out, and the
   definitions in it.  Written after the theorems. *)
From mathcomp Require all_ssreflect all_algebra.
From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums paley_model paley_phase paley_laplacian paley_gradient paley_particles paley_fourier paley_turning.
From Flockproof Require paley_circulant paley_circulant_reals paley_inertia.
Open Scope R_scope.

(* beyond.paley.circulant_spectrum: the frame, the derivatives, the determinant *)
Check (eq_refl : turning_rate = fun n adj w0 K0 K1 r th t i => let k := (i / 3)%nat in
  match (i mod 3)%nat with
  | 0%nat => cos (th k t) + w0 * snd (r k t) | 1%nat => sin (th k t) - w0 * fst (r k t)
  | _ => control5 n adj w0 K0 K1 r th t k - w0 end).
Check (eq_refl : control5 = fun n adj w0 K0 K1 r th t k => w0 + K1 / INR n * gW n adj (fun k => th k t) k
  + w0 * (K0 / INR n * aS n adj w0 (fun k => r k t) (fun k => th k t) k)).
Check (eq_refl : rest_place = fun w0 th k => (/ w0 * sin (th k), - / w0 * cos (th k))).
Check (eq_refl : along = fun j k a => if Nat.eqb (3 * k + a) j then 1 else 0).
Check (eq_refl : r_along = fun w0 th d k h => (fst (rest_place w0 th k) + h * d k 0%nat, snd (rest_place w0 th k) + h * d k 1%nat)).
Check (eq_refl : th_along = fun th d k h => th k + h * d k 2%nat).
Check (eq_refl : wave = fun n m k => 2 * PI * INR m * INR k / INR n).
Check (eq_refl : circulant = fun n adj s => forall k j, (k < n)%nat -> (j < n)%nat -> adj k j = s ((j + n - k) mod n)%nat).
Check (eq_refl : circulant_eigenvalue = fun n s m => Csum n (fun d => RtoC (if s d then 1 else 0) * (RtoC 1 - expi (wave n m d)))%C).
Check (circulant_eigenvector : forall n adj s m, (1 <= n)%nat -> circulant n adj s ->
  eigenvector n (lap n adj) (circulant_eigenvalue n s m) (fun k => expi (wave n m k))).
Check (fun A => eq_refl : Cdet 0 A = RtoC 1).
Check (fun n A => eq_refl : Cdet (S n) A = Csum (S n) (fun j => RtoC ((-1) ^ j) * (A 0%nat j * Cdet n (fun a b => A (S a) (if Nat.leb j b then S b else b))))%C).
Check (fun n f => eq_refl : Cprod (S n) f = (Cprod n f * f n)%C).
Check (eq_refl : cubic_value = fun n s m w0 K0 K1 z q =>
  let lam := circulant_eigenvalue n s in let k0 := RtoC (K0 / INR n) in let k1 := RtoC (K1 / INR n) in
  let C := ((lam (m + q)%nat + lam (m + (n - q))%nat) / RtoC 2)%C in
  let D := ((lam (m + q)%nat - lam (m + (n - q))%nat) / RtoC 2)%C in
  let t := (C - lam m)%C in
  (z * z * z + (k0 * C - k1 * t) * (z * z) + (RtoC (w0 * w0) - Ci * RtoC w0 * k0 * D) * z - k1 * t * RtoC (w0 * w0))%C).
Check (turning_frame : forall n adj w0 K0 K1 c0 r th t, (1 <= n)%nat -> w0 <> 0 -> forall k, (k < n)%nat ->
  is_velocity (r k) t (expi (th k t)) -> is_derive (th k) t (control5 n adj w0 K0 K1 r th t k) ->
  let r' := fun k t => (expi (- (w0 * t)) * (r k t - c0))%C in let th' := fun k t => th k t - w0 * t in
  is_velocity (r' k) t (turning_rate n adj w0 K0 K1 r' th' t (3 * k), turning_rate n adj w0 K0 K1 r' th' t (3 * k + 1)) /\
  is_derive (th' k) t (turning_rate n adj w0 K0 K1 r' th' t (3 * k + 2))).
Check (turning_rest_circulant : forall n adj s m w0 K0 K1 t i, (1 <= n)%nat -> w0 <> 0 -> undirected adj -> circulant n adj s ->
  (i < 3 * n)%nat -> turning_rate n adj w0 K0 K1 (fun k _ => rest_place w0 (wave n m) k) (fun k _ => wave n m k) t i = 0).
Module Determinant.
Import mathcomp.ssreflect.ssrbool mathcomp.ssreflect.ssrnat.
Check (@paley_circulant_reals.circulant_spectrum_reals :
  forall (n : nat) (adj : graph) (s : nat -> bool) (m : nat) (w0 K0 K1 : R),
  is_true (leq 1 n) -> circulant n adj s -> undirected adj -> is_true (leq m n) -> w0 <> 0 ->
  (forall i j, is_true (leq (S i) (muln 3 n)) ->
     is_derive (fun h => turning_rate n adj w0 K0 K1 (r_along w0 (wave n m) (along j)) (th_along (wave n m) (along j)) h i) 0
       (turning_matrix n adj w0 K0 K1 m i j)) /\
  (forall z, Cdet (muln 3 n) (fun i j => RtoC (delta i j) * z - RtoC (turning_matrix n adj w0 K0 K1 m i j))%C =
     Cprod n (cubic_value n s m w0 K0 K1 z))).
End Determinant.

Module Algebra.
Import mathcomp.ssreflect.all_ssreflect mathcomp.algebra.all_algebra GRing.Theory Num.Theory.
Delimit Scope nat_scope with N.
Delimit Scope ring_scope with F.
Local Open Scope ring_scope.
Import paley_circulant paley_inertia.
Check (erefl : steering = fun A n adj w0 k0 k1 x y c s k => w0 + (k1 - k0) * (\sum_(j | adj k j) (c k * (s k - s j) - s k * (c k - c j)))
     + w0 * k0 * \sum_(j | adj k j) (c k * (x k - x j) + s k * (y k - y j))).
Check (circulant_spectrum : forall (K : fieldType) (n : nat) (adj : rel 'I_n) (S : pred nat) (w im : K),
  (forall k j : 'I_n, adj k j = S ((j + n - k) %% n)%N) -> symmetric adj -> n.-primitive_root w -> im ^+ 2 = -1 ->
  2%:R != 0 :> K -> n%:R != 0 :> K -> forall (m : nat) (w0 k0 k1 : K), (m <= n)%N -> w0 != 0 ->
  let lam q := \sum_(d < n | S d) (1 - w ^+ (q * d)) in
  let C q := (lam (m + q)%N + lam (m + (n - q))%N) / 2%:R in let D q := (lam (m + q)%N - lam (m + (n - q))%N) / 2%:R in
  let t q := C q - lam m in
  char_poly (jacobian adj w im m w0 k0 k1) =
  \prod_(q < n) ('X^3 + (k0 * C q - k1 * t q)%:P * 'X^2 + (w0 ^+ 2 - im * w0 * k0 * D q)%:P * 'X - (k1 * t q * w0 ^+ 2)%:P)).
(* beyond.paley.inertia *)
Check (inertia_two_clusters : forall (R : realFieldType) (n : nat) (c s : 'I_n -> R), (0 < n)%N ->
  forall B : {set 'I_n}, (#|B| < n - #|B|)%N /\ (exists ce se : R, ce ^+ 2 + se ^+ 2 = 1 /\
    forall k, c k = (if k \in B then -1 else 1) * ce /\ s k = (if k \in B then -1 else 1) * se) ->
  inertia (hessian c s) #|B| (n - #|B| - 1) 1).
Check (inertia_balanced : forall (R : realFieldType) (n : nat) (c s : 'I_n -> R), (0 < n)%N ->
  \sum_j c j = 0 /\ \sum_j s j = 0 -> ~ (forall k j, c k * s j - s k * c j = 0) -> inertia (hessian c s) 2 0 (n - 2)).
Check (inertia_balanced_line : forall (R : realFieldType) (n : nat) (c s : 'I_n -> R), (0 < n)%N -> (forall k, c k ^+ 2 + s k ^+ 2 = 1) ->
  \sum_j c j = 0 /\ \sum_j s j = 0 -> (forall k j, c k * s j - s k * c j = 0) -> inertia (hessian c s) 1 0 (n - 1)).
Check (linearisation_two_clusters : forall (R : realFieldType) (n : nat) (c s : 'I_n -> R), (0 < n)%N -> forall (B : {set 'I_n}) (K1 : R),
  two_clusters c s B -> K1 != 0 ->
  if K1 < 0 then inertia (- K1 *: hessian c s) #|B| (n - #|B| - 1) 1 else inertia (- K1 *: hessian c s) (n - #|B| - 1) #|B| 1).
Check (critical_points : forall (R : realFieldType) (n : nat) (c s : 'I_n -> R), (0 < n)%N -> (forall k, c k ^+ 2 + s k ^+ 2 = 1) ->
  (forall k, gradient (2%:R * n%:R)^-1 c s k = 0) <-> balanced c s \/ exists B, two_clusters c s B).
Check (hessianE : forall (R : realFieldType) (n : nat) (c s : 'I_n -> R), (0 < n)%N -> forall k l,
  hessian c s k l = n%:R^-1 * (c k * c l + s k * s l - (k == l)%:R * (c k * (\sum_j c j) + s k * (\sum_j s j)))).
Check (gradientE : forall (A : comRingType) (n : nat) (h : A) (c s : 'I_n -> A) k,
  gradient h c s k = h *+ 2 * (c k * (\sum_j s j) - s k * (\sum_j c j))).
Check (fun (R : realFieldType) (n : nat) (H : 'M[R]_n) p q z => erefl : inertia H p q z =
  [/\ (exists2 W : 'M[R]_n, (forall v : 'rV[R]_n, (v <= W)%MS -> v != 0 -> 0 < (v *m H *m v^T) 0 0) & \rank W = p) /\
        (forall W : 'M[R]_n, (forall v : 'rV[R]_n, (v <= W)%MS -> v != 0 -> 0 < (v *m H *m v^T) 0 0) -> (\rank W <= p)%N),
      (exists2 W : 'M[R]_n, (forall v : 'rV[R]_n, (v <= W)%MS -> v != 0 -> (v *m H *m v^T) 0 0 < 0) & \rank W = q) /\
        (forall W : 'M[R]_n, (forall v : 'rV[R]_n, (v <= W)%MS -> v != 0 -> (v *m H *m v^T) 0 0 < 0) -> (\rank W <= q)%N)
    & \rank (kermx H) = z]).
End Algebra.
