(* Paley et al.: the law (1), (2) with (22) in the frame that turns at the rate w0 about a point, and its derivatives at circular
   formations.
     beyond.paley.circulant_spectrum (F1, F2 of notes/paley_phases.md; the spectrum is in paley_circulant_reals.v).
   `turning_frame`: a motion seen from that frame has the rates `turning_rate`, any graph.  `turning_rest`: the circular formation whose
   phasors are an eigenvector of the Laplacian is at rest there.  `D_turning_rate`: the derivatives of the rates along a displacement of
   the positions and phases, at any phases. *)
From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums paley_model paley_phase paley_laplacian paley_gradient paley_fourier paley_particles.
Open Scope R_scope.

Section Turning.
Variables (n : nat) (adj : graph) (w0 K0 K1 : R).
Hypotheses (Hn : (1 <= n)%nat) (Hw : w0 <> 0).
(* along a curve: the rates of x_k, y_k, theta_k for i = 3k, 3k + 1, 3k + 2 *)
Definition turning_rate (r : nat -> R -> C) (th : nat -> R -> R) (t : R) (i : nat) : R :=
  let k := (i / 3)%nat in
  match (i mod 3)%nat with
  | 0%nat => cos (th k t) + w0 * snd (r k t)
  | 1%nat => sin (th k t) - w0 * fst (r k t)
  | _ => control5 n adj w0 K0 K1 r th t k - w0
  end.
Lemma control5_sums r th t k : (k < n)%nat -> control5 n adj w0 K0 K1 r th t k = w0
  + (K1 / INR n - K0 / INR n) * Sum n (fun j => w adj k j *
      (cos (th k t) * (sin (th k t) - sin (th j t)) - sin (th k t) * (cos (th k t) - cos (th j t))))
  + w0 * (K0 / INR n) * Sum n (fun j => w adj k j *
      (cos (th k t) * (fst (r k t) - fst (r j t)) + sin (th k t) * (snd (r k t) - snd (r j t)))).
Proof.
  intros Hk. pose proof (INR_pos n Hn). rewrite (eq22 n adj w0 K0 K1 Hn Hw r th t k). rewrite gW_sines by assumption.
  rewrite row_lap by assumption. rewrite inner_Csum.
  rewrite (Sum_ext n (fun j => w adj k j * sin (th k t - th j t)) (fun j => w adj k j *
      (cos (th k t) * (sin (th k t) - sin (th j t)) - sin (th k t) * (cos (th k t) - cos (th j t))))).
  2: { intros j _. rewrite sin_minus. ring. }
  rewrite (Sum_ext n (fun j => inner (expi (th k t)) (RtoC (w adj k j) * (r k t - r j t))%C) (fun j => w adj k j *
      (cos (th k t) * (fst (r k t) - fst (r j t)) + sin (th k t) * (snd (r k t) - snd (r j t))))).
  2: { intros j _. rewrite inner_scal, inner_xy. cbn. ring. }
  field. lra.
Qed.

(* displacements d of a relative equilibrium c = 0 with the phases th *)
Variables (th : nat -> R) (d : nat -> nat -> R).
Definition rest_place (k : nat) : C := (/ w0 * sin (th k), - / w0 * cos (th k)).       (* - (i/w0) e^(i theta_k) *)
Lemma rest_centre k : circle_centre w0 (rest_place k) (th k) = RtoC 0.
Proof. unfold circle_centre, rest_place. apply injective_projections; cbn; ring. Qed.
Definition r_along (k : nat) (h : R) : C := (fst (rest_place k) + h * d k 0%nat, snd (rest_place k) + h * d k 1%nat).
Definition th_along (k : nat) (h : R) : R := th k + h * d k 2%nat.
Definition turning_derivative (k a : nat) : R :=
  match a with
  | 0%nat => - sin (th k) * d k 2%nat + w0 * d k 1%nat
  | 1%nat => cos (th k) * d k 2%nat - w0 * d k 0%nat
  | _ => (K1 / INR n - K0 / INR n) * Sum n (fun j => w adj k j *
      (cos (th k) * (cos (th k) * d k 2%nat - cos (th j) * d j 2%nat) - sin (th k) * d k 2%nat * (sin (th k) - sin (th j))
       - (sin (th k) * (- sin (th k) * d k 2%nat + sin (th j) * d j 2%nat) + cos (th k) * d k 2%nat * (cos (th k) - cos (th j)))))
    + w0 * (K0 / INR n) * Sum n (fun j => w adj k j *
      (cos (th k) * (d k 0%nat - d j 0%nat) - sin (th k) * d k 2%nat * (fst (rest_place k) - fst (rest_place j))
       + (sin (th k) * (d k 1%nat - d j 1%nat) + cos (th k) * d k 2%nat * (snd (rest_place k) - snd (rest_place j)))))
  end.
Lemma D_line (a b : R) : is_derive (fun h : R => a + h * b) 0 b.
Proof.
  apply (is_derive_ext (fun h : R => a + b * h)); [intros; cbn; ring|].
  eapply D_eq; [apply D_plus; [apply D_const|apply D_scal, D_id]|ring].
Qed.
Lemma D_cos_along k : is_derive (fun h => cos (th_along k h)) 0 (- sin (th k) * d k 2%nat).
Proof. eapply D_eq; [apply D_cos, D_line|]. unfold th_along. rewrite Rmult_0_l, Rplus_0_r. reflexivity. Qed.
Lemma D_sin_along k : is_derive (fun h => sin (th_along k h)) 0 (cos (th k) * d k 2%nat).
Proof. eapply D_eq; [apply D_sin, D_line|]. unfold th_along. rewrite Rmult_0_l, Rplus_0_r. reflexivity. Qed.
Lemma along_0 k : th_along k 0 = th k /\ r_along k 0 = rest_place k.
Proof. unfold th_along, r_along. split; [ring|]. apply injective_projections; cbn; ring. Qed.
Theorem D_turning_rate i : (i < 3 * n)%nat -> is_derive (fun h => turning_rate r_along th_along h i) 0 (turning_derivative (i / 3) (i mod 3)).
Proof.
  intros Hi. assert (Hk : (i / 3 < n)%nat) by (apply Nat.div_lt_upper_bound; lia).
  unfold turning_rate, turning_derivative. set (k := (i / 3)%nat) in *. destruct (i mod 3)%nat as [|[|a]].
  - cbn [r_along fst snd]. apply D_plus; [apply D_cos_along|]. apply D_scal, D_line.
  - cbn [r_along fst snd]. apply D_minus; [apply D_sin_along|]. apply D_scal, D_line.
  - apply (is_derive_ext (fun h => w0
  + (K1 / INR n - K0 / INR n) * Sum n (fun j => w adj k j *
      (cos (th_along k h) * (sin (th_along k h) - sin (th_along j h)) - sin (th_along k h) * (cos (th_along k h) - cos (th_along j h))))
  + w0 * (K0 / INR n) * Sum n (fun j => w adj k j *
      (cos (th_along k h) * (fst (r_along k h) - fst (r_along j h)) + sin (th_along k h) * (snd (r_along k h) - snd (r_along j h)))) - w0)).
    { intros h. rewrite (control5_sums r_along th_along h k Hk). reflexivity. }
        eapply D_eq.
    + apply D_minus; [apply D_plus; [apply D_plus; [apply D_const|]|]|apply D_const].
      * apply D_scal. apply (D_Sum n _ (fun j => w adj k j *
      (cos (th k) * (cos (th k) * d k 2%nat - cos (th j) * d j 2%nat) - sin (th k) * d k 2%nat * (sin (th k) - sin (th j))
       - (sin (th k) * (- sin (th k) * d k 2%nat + sin (th j) * d j 2%nat) + cos (th k) * d k 2%nat * (cos (th k) - cos (th j)))))).
        intros j _. apply (D_scal (w adj k j) (fun h => cos (th_along k h) * (sin (th_along k h) - sin (th_along j h)) - sin (th_along k h) * (cos (th_along k h) - cos (th_along j h)))).
        eapply D_eq.
        { apply (D_minus (fun h => cos (th_along k h) * (sin (th_along k h) - sin (th_along j h)))
            (fun h => sin (th_along k h) * (cos (th_along k h) - cos (th_along j h)))).
          - apply (D_mult (fun h => cos (th_along k h)) (fun h => sin (th_along k h) - sin (th_along j h)) 0 _ _ (D_cos_along k)
              (D_minus (fun h => sin (th_along k h)) (fun h => sin (th_along j h)) 0 _ _ (D_sin_along k) (D_sin_along j))).
          - apply (D_mult (fun h => sin (th_along k h)) (fun h => cos (th_along k h) - cos (th_along j h)) 0 _ _ (D_sin_along k)
              (D_minus (fun h => cos (th_along k h)) (fun h => cos (th_along j h)) 0 _ _ (D_cos_along k) (D_cos_along j))). }
        rewrite (proj1 (along_0 k)), (proj1 (along_0 j)). ring.
      * apply D_scal. apply (D_Sum n _ (fun j => w adj k j * 
      (cos (th k) * (d k 0%nat - d j 0%nat) - sin (th k) * d k 2%nat * (fst (rest_place k) - fst (rest_place j))
       + (sin (th k) * (d k 1%nat - d j 1%nat) + cos (th k) * d k 2%nat * (snd (rest_place k) - snd (rest_place j)))))).
        intros j _. apply (D_scal (w adj k j) (fun h => cos (th_along k h) * (fst (r_along k h) - fst (r_along j h))
          + sin (th_along k h) * (snd (r_along k h) - snd (r_along j h)))). eapply D_eq.
        { apply (D_plus (fun h => cos (th_along k h) * (fst (r_along k h) - fst (r_along j h)))
            (fun h => sin (th_along k h) * (snd (r_along k h) - snd (r_along j h)))).
          - apply (D_mult (fun h => cos (th_along k h)) (fun h => fst (r_along k h) - fst (r_along j h)) 0 _ _ (D_cos_along k)
              (D_minus (fun h => fst (r_along k h)) (fun h => fst (r_along j h)) 0 _ _ (D_line _ _) (D_line _ _))).
          - apply (D_mult (fun h => sin (th_along k h)) (fun h => snd (r_along k h) - snd (r_along j h)) 0 _ _ (D_sin_along k)
              (D_minus (fun h => snd (r_along k h)) (fun h => snd (r_along j h)) 0 _ _ (D_line _ _) (D_line _ _))). }
        rewrite (proj1 (along_0 k)), (proj2 (along_0 k)), (proj2 (along_0 j)). ring.
    + ring.
Qed.
End Turning.

(* ---- the turning frame: a motion of (1), (2) with (22), seen from a frame that turns at w0 about any point c0 ---- *)
Section Frame.
Variables (n : nat) (adj : graph) (w0 K0 K1 : R) (c0 : C) (r : nat -> R -> C) (th : nat -> R -> R) (t : R).
Hypotheses (Hn : (1 <= n)%nat) (Hw : w0 <> 0).
Definition r_turning (k : nat) (t : R) : C := (expi (- (w0 * t)) * (r k t - c0))%C.
Definition th_turning (k : nat) (t : R) : R := th k t - w0 * t.
Lemma control5_turning k : (k < n)%nat -> control5 n adj w0 K0 K1 r_turning th_turning t k = control5 n adj w0 K0 K1 r th t k.
Proof.
  intros Hk. rewrite !control5_sums by assumption. pose proof (sc2 (w0 * t)) as E. f_equal; [f_equal|]; f_equal; apply Sum_ext; intros j _; f_equal.
  - unfold th_turning. rewrite !cos_minus, !sin_minus.
    transitivity ((cos (th k t) * (sin (th k t) - sin (th j t)) - sin (th k t) * (cos (th k t) - cos (th j t))) * (sin (w0 * t) ^ 2 + cos (w0 * t) ^ 2));
      [ring|rewrite E; ring].
  - unfold th_turning, r_turning. rewrite !cos_minus, !sin_minus. cbn [expi Cmult Cminus Cplus Copp fst snd]. rewrite cos_neg, sin_neg.
    transitivity ((cos (th k t) * (fst (r k t) - fst (r j t)) + sin (th k t) * (snd (r k t) - snd (r j t))) * (sin (w0 * t) ^ 2 + cos (w0 * t) ^ 2));
      [ring|rewrite E; ring].
Qed.
Lemma velocity_turning k : is_velocity (r k) t (expi (th k t)) ->
  is_velocity (r_turning k) t (cos (th_turning k t) + w0 * snd (r_turning k t), sin (th_turning k t) - w0 * fst (r_turning k t)).
Proof.
  intros [A B].
  assert (L : is_derive (fun s => w0 * s) t w0) by (eapply D_eq; [apply D_scal, D_id|ring]).
  pose proof (D_cos (fun s => w0 * s) t w0 L) as DC. pose proof (D_sin (fun s => w0 * s) t w0 L) as DS. cbv beta in DC, DS.
  assert (X : is_derive (fun s => fst (r k s) - fst c0) t (cos (th k t))) by (eapply D_eq; [exact (D_minus (fun s => fst (r k s)) (fun _ => fst c0) t _ _ A (D_const _ t))|cbn; ring]).
  assert (Y : is_derive (fun s => snd (r k s) - snd c0) t (sin (th k t))) by (eapply D_eq; [exact (D_minus (fun s => snd (r k s)) (fun _ => snd c0) t _ _ B (D_const _ t))|cbn; ring]).
  split; cbn [fst snd].
  - apply (is_derive_ext (fun s => cos (w0 * s) * (fst (r k s) - fst c0) + sin (w0 * s) * (snd (r k s) - snd c0))).
    { intros s. cbn. rewrite cos_neg, sin_neg. ring. }
    eapply D_eq; [exact (D_plus _ _ t _ _ (D_mult _ _ t _ _ DC X) (D_mult _ _ t _ _ DS Y))|].
    unfold th_turning, r_turning, expi, Cmult, Cminus, Cplus, Copp; cbn [fst snd]. rewrite cos_minus, cos_neg, sin_neg. ring.
  - apply (is_derive_ext (fun s => cos (w0 * s) * (snd (r k s) - snd c0) - sin (w0 * s) * (fst (r k s) - fst c0))).
    { intros s. cbn. rewrite cos_neg, sin_neg. ring. }
    eapply D_eq; [exact (D_minus _ _ t _ _ (D_mult _ _ t _ _ DC Y) (D_mult _ _ t _ _ DS X))|].
    unfold th_turning, r_turning, expi, Cmult, Cminus, Cplus, Copp; cbn [fst snd]. rewrite sin_minus, cos_neg, sin_neg. ring.
Qed.
Theorem turning_frame k : (k < n)%nat -> is_velocity (r k) t (expi (th k t)) -> is_derive (th k) t (control5 n adj w0 K0 K1 r th t k) ->
  is_velocity (r_turning k) t (turning_rate n adj w0 K0 K1 r_turning th_turning t (3 * k),
                               turning_rate n adj w0 K0 K1 r_turning th_turning t (3 * k + 1)) /\
  is_derive (th_turning k) t (turning_rate n adj w0 K0 K1 r_turning th_turning t (3 * k + 2)).
Proof.
  intros Hk V D. unfold turning_rate.
  assert (Q : forall a, (a < 3)%nat -> ((3 * k + a) / 3 = k)%nat /\ ((3 * k + a) mod 3 = a)%nat).
  { intros a Ha. split; symmetry; [apply (Nat.div_unique _ 3 k a)|apply (Nat.mod_unique _ 3 k a)]; lia. }
  assert (Z1 : (3 * k / 3 = k)%nat) by (rewrite Nat.mul_comm; apply Nat.div_mul; lia).
  assert (Z2 : ((3 * k) mod 3 = 0)%nat) by (rewrite Nat.mul_comm; apply Nat.mod_mul; lia).
  destruct (Q 1%nat ltac:(lia)) as [A1 A2]. destruct (Q 2%nat ltac:(lia)) as [B1 B2].
  rewrite Z1, Z2, A1, A2, B1, B2.
  split; [now apply velocity_turning|]. rewrite control5_turning by assumption.
  eapply D_eq; [apply D_minus; [exact D|apply D_scal, D_id]|ring].
Qed.
End Frame.

(* phases that are an eigenvector of the Laplacian, Fourier columns of a circulant one among them: at rest in that frame *)
Theorem turning_rest n adj w0 K0 K1 th lam t i : (1 <= n)%nat -> w0 <> 0 -> undirected adj -> eigenvector n (lap n adj) lam (phasors th) ->
  (i < 3 * n)%nat -> turning_rate n adj w0 K0 K1 (fun k _ => rest_place w0 th k) (fun k _ => th k) t i = 0.
Proof.
  intros Hn Hw U E Hi. assert (Hk : (i / 3 < n)%nat) by (apply Nat.div_lt_upper_bound; lia).
  unfold turning_rate. set (k := (i / 3)%nat) in *. destruct (i mod 3)%nat as [|[|a]]; [cbn; field; lra|cbn; field; lra|].
  pose proof (proj2 (eigenvector_stationary n adj th lam Hn U E) w0 K1 k Hk) as G. unfold control5.
  assert (Z : aS n adj w0 (fun k => rest_place w0 th k) (fun k => th k) k = 0).
  { unfold aS. rewrite inner_row. apply Sum_zero. intros j _. unfold centres. rewrite rest_centre, inner_xy. cbn. ring. }
  rewrite Z. change (fun k0 : nat => th k0) with th. rewrite G. ring.
Qed.
Corollary turning_rest_circulant n adj s m w0 K0 K1 t i : (1 <= n)%nat -> w0 <> 0 -> undirected adj -> circulant n adj s ->
  (i < 3 * n)%nat -> turning_rate n adj w0 K0 K1 (fun k _ => rest_place w0 (wave n m) k) (fun k _ => wave n m k) t i = 0.
Proof. intros Hn Hw U H. apply (turning_rest n adj w0 K0 K1 (wave n m) (circulant_eigenvalue n s m)); try assumption. now apply circulant_eigenvector. Qed.

(* ---- what the theorem about the spectrum (paley_circulant_reals.v) speaks of ---- *)
(* the displacement along the coordinate j: x_k, y_k, theta_k for j = 3k, 3k + 1, 3k + 2; the matrix of the derivatives there *)
Definition along (j k a : nat) : R := if Nat.eqb (3 * k + a) j then 1 else 0.
Definition turning_matrix (n : nat) (adj : graph) (w0 K0 K1 : R) (m i j : nat) : R :=
  turning_derivative n adj w0 K0 K1 (wave n m) (along j) (i / 3) (i mod 3).
(* determinants by their first row, products *)
Fixpoint Cdet (n : nat) (A : nat -> nat -> C) : C :=
  match n with
  | O => RtoC 1
  | Datatypes.S l => Csum n (fun j => RtoC ((-1) ^ j) * (A 0%nat j * Cdet l (fun a b => A (Datatypes.S a) (if Nat.leb j b then Datatypes.S b else b))))%C
  end.
Fixpoint Cprod (n : nat) (f : nat -> C) : C := match n with O => RtoC 1 | Datatypes.S l => (Cprod l f * f l)%C end.
(* p_q(z); the index m - q as m + (n - q) *)
Definition cubic_value (n : nat) (s : nat -> bool) (m : nat) (w0 K0 K1 : R) (z : C) (q : nat) : C :=
  let lam := circulant_eigenvalue n s in
  let k0 := RtoC (K0 / INR n) in let k1 := RtoC (K1 / INR n) in
  let C := ((lam (m + q)%nat + lam (m + (n - q))%nat) / RtoC 2)%C in
  let D := ((lam (m + q)%nat - lam (m + (n - q))%nat) / RtoC 2)%C in
  let t := (C - lam m)%C in
  (z * z * z + (k0 * C - k1 * t) * (z * z) + (RtoC (w0 * w0) - Ci * RtoC w0 * k0 * D) * z - k1 * t * RtoC (w0 * w0))%C.
