(* Veerman, Stosic, Olvera, Theorem 1: the main resonance of M = N + 1 followers, for all f, g < 0.
     veerman.thm1_omega, veerman.thm1_amp.
   With w^2 = t^2 lambda |f| and Z = M^2 b^2 lambda^2/2, the bounds of veerman_window.v give |a_M|^-2 <= Z (1 + O(lambda)) at t = 1,
   |a_M|^-2 >= Z (1 - O(lambda)) everywhere, and more than the former where |t - 1| exceeds a multiple of lambda = pi^2/(8M^2) + O(M^-4). *)
From Coq Require Import Reals Lra Lia Psatz.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums veerman_complex veerman_front veerman_chain veerman_stability certificate_peaks.
From Flockproof Require Import veerman_settling veerman_rates veerman_unsettled veerman_coordinates veerman_bounds veerman_window.
From Flockproof Require veerman_numbers.
Open Scope R_scope.

(* ---- the amplitude is continuous, so that it has a maximum on a closed interval ---- *)
Definition Ccont (z : R -> C) (w : R) := continuous (fun v => fst (z v)) w /\ continuous (fun v => snd (z v)) w.
Lemma Ccont_mult z1 z2 w : Ccont z1 w -> Ccont z2 w -> Ccont (fun v => (z1 v * z2 v)%C) w.
Proof.
  intros [A B] [C D]. split; cbn [Cmult fst snd].
  - apply (continuous_minus (fun v => fst (z1 v) * fst (z2 v)) (fun v => snd (z1 v) * snd (z2 v))); now apply (continuous_mult (K := R_AbsRing)).
  - apply (continuous_plus (fun v => fst (z1 v) * snd (z2 v)) (fun v => snd (z1 v) * fst (z2 v))); now apply (continuous_mult (K := R_AbsRing)).
Qed.
Lemma Ccont_minus z1 z2 w : Ccont z1 w -> Ccont z2 w -> Ccont (fun v => (z1 v - z2 v)%C) w.
Proof.
  intros [A B] [C D]. split; cbn [Cminus Cplus Copp fst snd].
  - now apply (continuous_minus (fun v => fst (z1 v)) (fun v => fst (z2 v))).
  - now apply (continuous_minus (fun v => snd (z1 v)) (fun v => snd (z2 v))).
Qed.
Lemma Ccont_const z w : Ccont (fun _ => z) w.
Proof. split; apply continuous_const. Qed.
Lemma gamma_continuous f g w : f < 0 -> g < 0 -> Ccont (gamma f g) w.
Proof.
  intros Hf Hg.
  assert (Q : forall v, 0 < f ^ 2 + (v * g) ^ 2) by (intros v; pose proof (pow2_ge_0 (v * g)); assert (0 < f ^ 2) by (apply pow2_gt_0; lra); lra).
  split.
  - assert (E : forall v : R, ((f + v ^ 2) * f + (v * g) ^ 2) / (f ^ 2 + (v * g) ^ 2) = fst (gamma f g v)).
    { intros v. unfold gamma, num, den, Cdiv, Cinv, Cmult; cbn [fst snd]. specialize (Q v). field. nra. }
    apply (continuous_ext _ _ _ E).
    apply (ex_derive_continuous (V := R_NormedModule)). auto_derive. specialize (Q w). split; [nra|easy] || nra.
  - assert (E : forall v : R, - g * v ^ 3 / (f ^ 2 + (v * g) ^ 2) = snd (gamma f g v)) by (intros v; symmetry; now apply gamma_imaginary).
    apply (continuous_ext _ _ _ E).
    apply (ex_derive_continuous (V := R_NormedModule)). auto_derive. specialize (Q w). split; [nra|easy] || nra.
Qed.
Lemma cheb_continuous f g n w : f < 0 -> g < 0 -> Ccont (fun v => chebT (gamma f g v) n) w.
Proof.
  intros Hf Hg. assert (A : Ccont (fun v => chebT (gamma f g v) n) w /\ Ccont (fun v => chebT (gamma f g v) (S n)) w); [|apply A].
  induction n as [|n [A B]]; [split; [apply Ccont_const|now apply gamma_continuous]|]. split; [exact B|].
  apply (Ccont_minus (fun v => (2 * gamma f g v * chebT (gamma f g v) (S n))%C)); [|exact A].
  apply (Ccont_mult (fun v => (2 * gamma f g v)%C)); [|exact B]. apply (Ccont_mult (fun _ => RtoC 2)); [apply Ccont_const|now apply gamma_continuous].
Qed.
Lemma amplitude_is_continuous f g N w : f < 0 -> g < 0 -> continuity_pt (amplitude f g N) w.
Proof.
  intros Hf Hg. apply continuity_pt_filterlim. set (T := fun v => chebT (gamma f g v) (S N)).
  assert (E : forall v : R, / sqrt (fst (T v) ^ 2 + snd (T v) ^ 2) = amplitude f g N v).
  { intros v. unfold amplitude. rewrite Cmod_inv by now apply cheb_neq0. reflexivity. }
  apply (continuous_ext _ _ _ E).
  - destruct (cheb_continuous f g (S N) w Hf Hg) as [A B]. fold T in A, B.
    apply (continuous_comp (fun v => sqrt (fst (T v) ^ 2 + snd (T v) ^ 2)) Rinv).
    + apply (continuous_comp (fun v => fst (T v) ^ 2 + snd (T v) ^ 2) sqrt); [|apply continuous_sqrt].
      apply (continuous_plus (fun v => fst (T v) ^ 2) (fun v => snd (T v) ^ 2)).
      * apply (continuous_comp (fun v => fst (T v)) (fun x => x ^ 2)); [exact A|apply (ex_derive_continuous (V := R_NormedModule)); auto_derive; easy].
      * apply (continuous_comp (fun v => snd (T v)) (fun x => x ^ 2)); [exact B|apply (ex_derive_continuous (V := R_NormedModule)); auto_derive; easy].
    + apply continuous_Rinv. change (Cmod (T w) <> 0). assert (0 < Cmod (T w)); [|lra]. apply Cmod_gt_0. now apply cheb_neq0.
Qed.

(* ---- in units of lambda ---- *)
Section Units.
Variables (f g : R) (N : nat).
Hypotheses (Hf : f < 0) (Hg : g < 0).
Let beta := g ^ 2 / - f.
Let M := INR (S N).
Let lam := lowest N.
Let Z := M ^ 2 * (beta * lam ^ 2) / 2.
Let E1 := 1 + 304 * beta.
Definition spread : R := 12 * beta + 1 + beta * (1 + 306 * beta) + (1 + 304 * beta).
Hypotheses (H1 : 8 * beta * lam <= 1) (H2 : 2 * E1 * lam <= 1) (H3 : (1 + 4 * beta) * (3 + beta) * lam <= 1).
Let middle := sqrt (- f * lam).
Lemma units : 0 < beta /\ 0 < lam <= 1 /\ 1 <= M /\ 0 < Z <= beta * lam /\ 0 < middle /\ middle ^ 2 = - f * lam.
Proof using Hf Hg.
  assert (B : 0 < beta) by (apply Rdiv_lt_0_compat; [apply pow2_gt_0|]; lra). pose proof (lowest_range N) as L. fold lam in L.
  pose proof (M_ge1 N) as M1. fold M in M1. pose proof (lowest_small N) as LS. fold lam M in LS.
  assert (LM : M ^ 2 * lam <= 2).
  { pose proof PI_4. pose proof PI_RGT_0. assert (m2 : 0 < M ^ 2) by (apply pow_lt; lra). apply (Rmult_lt_compat_l (M ^ 2)) in LS; [|exact m2].
    replace (M ^ 2 * (PI ^ 2 / (8 * M ^ 2))) with (PI ^ 2 / 8) in LS by (field; lra). assert (PI ^ 2 <= 16) by nra. lra. }
  split; [exact B|]. split; [exact L|]. split; [exact M1|]. split; [|split].
  - split; unfold Z.
    + apply Rdiv_lt_0_compat; [|lra]. apply Rmult_lt_0_compat; [apply pow_lt; lra|]. apply Rmult_lt_0_compat; [exact B|apply pow_lt; lra].
    + replace (M ^ 2 * (beta * lam ^ 2) / 2) with (beta * lam * (M ^ 2 * lam) / 2) by field.
      assert (0 < beta * lam) by (apply Rmult_lt_0_compat; lra). assert (beta * lam * (M ^ 2 * lam) <= beta * lam * 2) by (apply Rmult_le_compat_l; lra). lra.
  - apply sqrt_lt_R0. apply Rmult_lt_0_compat; lra.
  - apply pow2_sqrt. apply Rmult_le_pos; lra.
Qed.
Lemma quiet_at_middle : quiet f g N middle <= Z * (1 + E1 * lam).
Proof using Hf Hg H1.
  destruct units as (B & L & M1 & ZB & P & P2).
  assert (A : middle ^ 2 / - f = lam) by (rewrite P2; field; lra).
  pose proof (quiet_middle f g N Hf Hg middle P A) as Q. fold beta M lam in Q. cbv zeta in Q.
  replace (M ^ 2 * (beta * lam ^ 2)) with (2 * Z) in Q by (unfold Z; field).
  assert (V : 2 * Z / (2 - lam) <= Z * (1 + lam)).
  { apply (Rmult_le_reg_r (2 - lam)); [lra|]. replace (2 * Z / (2 - lam) * (2 - lam)) with (2 * Z) by (field; lra).
    assert (0 <= Z * (lam * (1 - lam))) by (apply Rmult_le_pos; [lra|apply Rmult_le_pos; lra]). lra. }
  assert (Z1 : Z <= / 8) by lra. assert (V2 : Z * (1 + lam) <= 2 * Z) by (assert (Z * lam <= Z * 1) by (apply Rmult_le_compat_l; lra); lra).
  assert (V0 : 0 <= 2 * Z / (2 - lam)) by (apply Rmult_le_pos; [lra|left; apply Rinv_0_lt_compat; lra]).
  set (V' := 2 * Z / (2 - lam)) in *. specialize (Q ltac:(lra)). eapply Rle_trans; [exact Q|].
  assert (S1 : (1 + 2 * V') ^ 2 <= 1 + 24 * Z).
  { apply Rle_trans with ((1 + 4 * Z) ^ 2); [apply pow_incr; lra|]. assert (Z * Z <= Z * 1) by (apply Rmult_le_compat_l; lra). lra. }
  assert (S2 : V' * (1 + 2 * V') ^ 2 <= Z * (1 + lam) * (1 + 24 * Z)) by (apply Rmult_le_compat; try lra; apply pow2_ge_0).
  assert (S3 : Z * (304 * Z) <= Z * (304 * (beta * lam))) by (apply Rmult_le_compat_l; lra).
  assert (S4 : Z * (24 * Z * lam) <= Z * (24 * Z)) by (apply Rmult_le_compat_l; [lra|]; assert (24 * Z * lam <= 24 * Z * 1) by (apply Rmult_le_compat_l; lra); lra).
  unfold E1. assert (0 <= Z * Z) by (apply Rmult_le_pos; lra). lra.
Qed.
Lemma share_mono a b : 0 <= a <= b -> beta * a / (1 + beta * a) <= beta * b / (1 + beta * b).
Proof using Hf Hg.
  intros [A AB]. assert (B : 0 < beta) by (apply Rdiv_lt_0_compat; [apply pow2_gt_0|]; lra). assert (0 <= beta * a) by (apply Rmult_le_pos; lra). assert (beta * a <= beta * b) by (apply Rmult_le_compat_l; lra).
  replace (beta * a / (1 + beta * a)) with (1 - / (1 + beta * a)) by (field; lra). replace (beta * b / (1 + beta * b)) with (1 - / (1 + beta * b)) by (field; lra).
  assert (/ (1 + beta * b) <= / (1 + beta * a)) by (apply Rinv_le_contravar; lra). lra.
Qed.
(* Z_ = M^2 share(lambda)^2/(2 beta) *)
Let Z_ := Z / (1 + beta * lam) ^ 2.
Lemma Z_bounds : 0 < Z_ <= Z /\ Z * (1 - 2 * beta * lam) <= Z_.
Proof using Hf Hg.
  destruct units as (B & L & M1 & ZB & _). assert (K : 0 < beta * lam) by (apply Rmult_lt_0_compat; lra). set (k := beta * lam) in *.
  assert (D : 0 < (1 + k) ^ 2) by (apply pow_lt; lra). unfold Z_. split; [split|].
  - apply Rdiv_lt_0_compat; lra.
  - apply (Rmult_le_reg_r ((1 + k) ^ 2)); [exact D|]. replace (Z / (1 + k) ^ 2 * (1 + k) ^ 2) with Z by (field; lra).
    assert (0 <= Z * (2 * k + k ^ 2)) by (apply Rmult_le_pos; [lra|pose proof (pow2_ge_0 k); lra]). lra.
  - apply (Rmult_le_reg_r ((1 + k) ^ 2)); [exact D|]. replace (Z / (1 + k) ^ 2 * (1 + k) ^ 2) with Z by (field; lra).
    replace (2 * beta * lam) with (2 * k) by (unfold k; ring).
    assert (0 <= Z * (3 * k ^ 2 + 2 * k ^ 3)) by (apply Rmult_le_pos; [lra|]; pose proof (pow2_ge_0 k); assert (0 < k ^ 3) by (apply pow_lt; lra); lra). lra.
Qed.
(* the three regions *)
Lemma regions w : 0 < w -> let t := w / middle in
  (t <= 1 /\ Z_ + (1 - t) ^ 2 - 4 * (1 - t) * Z_ <= quiet f g N w) \/
  (1 <= t /\ Z_ <= quiet f g N w /\ (beta * (t ^ 2 * lam) / (1 + beta * (t ^ 2 * lam))) ^ 2 * M ^ 2 <= 2 * beta * quiet f g N w) \/
  2 * Z <= quiet f g N w.
Proof using Hf Hg H1 H3.
  intros Hw t. destruct units as (B & L & M1 & ZB & P & P2). assert (T0 : 0 < t) by now apply Rdiv_lt_0_compat.
  assert (A : w ^ 2 / - f = t ^ 2 * lam).
  { unfold t. replace ((w / middle) ^ 2) with (w ^ 2 / middle ^ 2) by (field; lra). rewrite P2. field. lra. }
  assert (ZS : M ^ 2 * (beta * lam / (1 + beta * lam)) ^ 2 / (2 * beta) = Z_).
  { unfold Z_, Z. assert (0 < beta * lam) by (apply Rmult_lt_0_compat; lra). field. lra. }
  assert (BL : 0 < beta * lam) by (apply Rmult_lt_0_compat; lra). pose proof Z_bounds as [ZZ _].
  destruct (Rle_lt_dec t 1) as [T|T]; [left|right].
  - split; [exact T|]. pose proof (quiet_below f g N Hf Hg w t Hw ltac:(lra) A) as Q. fold beta M lam in Q. cbv beta zeta in Q. rewrite A in Q.
    assert (t2 : t ^ 2 <= 1) by nra. assert (t20 : 0 < t ^ 2) by (apply pow_lt; lra).
    assert (Sh : t ^ 2 * (beta * lam / (1 + beta * lam)) <= beta * (t ^ 2 * lam) / (1 + beta * (t ^ 2 * lam))).
    { assert (I : t ^ 2 * (beta * lam) <= 1 * (beta * lam)) by (apply Rmult_le_compat_r; lra).
      assert (I2 : 0 < t ^ 2 * (beta * lam)) by (apply Rmult_lt_0_compat; lra).
      replace (beta * (t ^ 2 * lam)) with (t ^ 2 * (beta * lam)) by ring. set (k := beta * lam) in *.
      replace (t ^ 2 * (k / (1 + k))) with (t ^ 2 * k * / (1 + k)) by (field; lra). apply Rmult_le_compat_l; [lra|]. apply Rinv_le_contravar; lra. }
    assert (S2 : t ^ 4 * Z_ <= M ^ 2 * (beta * (t ^ 2 * lam) / (1 + beta * (t ^ 2 * lam))) ^ 2 / (2 * beta)).
    { rewrite <- ZS. replace (t ^ 4 * (M ^ 2 * (beta * lam / (1 + beta * lam)) ^ 2 / (2 * beta)))
        with (M ^ 2 * (t ^ 2 * (beta * lam / (1 + beta * lam))) ^ 2 / (2 * beta)) by (field; lra).
      apply Rmult_le_compat_r; [left; apply Rinv_0_lt_compat; lra|]. apply Rmult_le_compat_l; [apply pow2_ge_0|]. apply pow_incr. split; [|exact Sh].
      apply Rmult_le_pos; [lra|]. apply Rmult_le_pos; [lra|left; apply Rinv_0_lt_compat; lra]. }
    assert (T4 : (1 - 4 * (1 - t)) * Z_ <= t ^ 4 * Z_).
    { apply Rmult_le_compat_r; [lra|]. assert (0 <= (1 - t) ^ 2 * (3 + 2 * t + t ^ 2)) by (apply Rmult_le_pos; [apply pow2_ge_0|lra]). lra. }
    lra.
  - destruct (Rle_lt_dec (w ^ 2 / - f) 4) as [F4|F4]; [left|right].
    + split; [lra|]. pose proof (quiet_moderate f g N Hf Hg w Hw F4) as Q. fold beta M lam in Q. cbv beta zeta in Q. rewrite A in Q. split; [|lra].
      assert (t2 : 1 <= t ^ 2) by nra.
      assert (Sh : beta * lam / (1 + beta * lam) <= beta * (t ^ 2 * lam) / (1 + beta * (t ^ 2 * lam))).
      { apply share_mono. assert (1 * lam <= t ^ 2 * lam) by (apply Rmult_le_compat_r; lra). lra. }
      rewrite <- ZS. apply (Rmult_le_reg_r (2 * beta)); [lra|]. replace (M ^ 2 * (beta * lam / (1 + beta * lam)) ^ 2 / (2 * beta) * (2 * beta))
        with (M ^ 2 * (beta * lam / (1 + beta * lam)) ^ 2) by (field; lra).
      eapply Rle_trans; [|rewrite Rmult_comm; exact Q]. apply Rmult_le_compat_l; [apply pow2_ge_0|]. apply pow_incr. split; [|exact Sh].
      apply Rmult_le_pos; [lra|left; apply Rinv_0_lt_compat; lra].
    + pose proof (quiet_large f g N Hf Hg w Hw ltac:(lra)) as Q. fold beta M in Q. cbv beta zeta in Q.
      pose proof (share_mono 4 (w ^ 2 / - f) ltac:(lra)) as Sh. assert (m2 : 0 < M ^ 2) by (apply pow_lt; lra).
      apply (Rmult_le_compat_l (M ^ 2)) in Sh; [|lra].
      apply (Rmult_le_reg_l (3 + beta)); [lra|]. eapply Rle_trans; [|exact Q]. eapply Rle_trans; [|exact Sh].
      unfold Z. replace ((3 + beta) * (2 * (M ^ 2 * (beta * lam ^ 2) / 2))) with (M ^ 2 * ((3 + beta) * (beta * lam ^ 2))) by field.
      apply Rmult_le_compat_l; [lra|]. apply (Rmult_le_reg_r (1 + beta * 4)); [lra|].
      replace (beta * 4 / (1 + beta * 4) * (1 + beta * 4)) with (beta * 4) by (field; lra).
      assert (K : (1 + 4 * beta) * (3 + beta) * lam * lam <= 1 * 1) by (apply Rmult_le_compat; try lra; apply Rmult_le_pos; [apply Rmult_le_pos|]; lra).
      assert (beta * ((1 + 4 * beta) * (3 + beta) * lam * lam) <= beta * 4) by (apply Rmult_le_compat_l; lra). lra.
Qed.
Lemma quiet_everywhere w : 0 < w -> Z * (1 - 6 * beta * lam) <= quiet f g N w.
Proof using Hf Hg H1 H3.
  intros Hw. destruct units as (B & L & M1 & ZB & P & P2). pose proof Z_bounds as [[Z0 Z1] Z2].
  assert (BL : 0 < beta * lam) by (apply Rmult_lt_0_compat; lra).
  assert (Zs : Z_ * Z_ <= Z * (beta * lam)) by (apply Rmult_le_compat; lra).
  assert (0 <= Z * (beta * lam)) by (apply Rmult_le_pos; lra).
  destruct (regions w Hw) as [[T Q]|[(_ & Q & _)|Q]]; [|lra|lra].
  set (dl := 1 - w / middle) in *. assert (0 <= (dl - 2 * Z_) ^ 2) by apply pow2_ge_0. lra.
Qed.
(* where the response is not above that at the middle *)
Lemma close_to_middle w : 0 < w -> quiet f g N w <= Z * (1 + E1 * lam) -> Rabs (w / middle - 1) <= spread * lam.
Proof using Hf Hg H1 H2 H3.
  intros Hw H. destruct units as (B & L & M1 & ZB & P & P2). pose proof Z_bounds as [[Z0 Z1] Z2].
  assert (BL : 0 < beta * lam) by (apply Rmult_lt_0_compat; lra). assert (EL : 0 < E1 * lam) by (apply Rmult_lt_0_compat; unfold E1; lra).
  assert (B2 : 0 <= beta * beta) by (apply Rmult_le_pos; lra).
  destruct (regions w Hw) as [[T Q]|[(T & _ & Q)|Q]].
  - set (t := w / middle) in *. rewrite Rabs_left1 by lra. set (dl := - (t - 1)). assert (D0 : 0 <= dl) by (unfold dl; lra).
    replace (1 - t) with dl in Q by (unfold dl; ring).
    assert (X : dl ^ 2 - 4 * (beta * lam) * dl <= beta * lam * ((1 + 306 * beta) * lam)).
    { assert (dl * Z_ <= dl * (beta * lam)) by (apply Rmult_le_compat_l; lra).
      assert (Z * ((1 + 306 * beta) * lam) <= beta * lam * ((1 + 306 * beta) * lam)) by (apply Rmult_le_compat_r; [apply Rmult_le_pos; lra|lra]).
      unfold E1 in H. lra. }
    apply Rnot_lt_le. intros G. set (G0 := 4 * beta + 1 + beta * (1 + 306 * beta)).
    assert (G1 : G0 * lam < dl).
    { eapply Rle_lt_trans; [|exact G]. apply Rmult_le_compat_r; [lra|]. unfold G0, spread. fold beta. lra. }
    assert (U1 : 0 < G0) by (unfold G0; assert (0 <= beta * (1 + 306 * beta)) by (apply Rmult_le_pos; lra); lra).
    assert (U2 : (G0 - 4 * beta) * lam < dl - 4 * (beta * lam)) by lra.
    assert (U3 : 1 <= G0 - 4 * beta) by (unfold G0; assert (0 <= beta * (1 + 306 * beta)) by (apply Rmult_le_pos; lra); lra).
    assert (U4 : 0 < G0 * lam) by (apply Rmult_lt_0_compat; lra). assert (U5 : 0 < (G0 - 4 * beta) * lam) by (apply Rmult_lt_0_compat; lra).
    assert (U6 : G0 * lam * ((G0 - 4 * beta) * lam) < dl * (dl - 4 * (beta * lam))) by (apply Rmult_le_0_lt_compat; lra).
    assert (U7 : G0 * lam * (1 * lam) <= G0 * lam * ((G0 - 4 * beta) * lam)) by (apply Rmult_le_compat_l; [lra|apply Rmult_le_compat_r; lra]).
    assert (U8 : beta * (1 + 306 * beta) * (lam * lam) <= G0 * (lam * lam)).
    { apply Rmult_le_compat_r; [apply Rmult_le_pos; lra|unfold G0; lra]. }
    lra.
  - set (t := w / middle) in *. rewrite Rabs_right by lra. set (k := t ^ 2) in *. assert (K1 : 1 <= k) by (unfold k; nra). assert (TK : t <= k) by (unfold k; nra).
    set (sh := beta * (k * lam) / (1 + beta * (k * lam))) in *. assert (m2 : 0 < M ^ 2) by (apply pow_lt; lra).
    assert (BK : 0 < beta * (k * lam)) by (apply Rmult_lt_0_compat; [lra|apply Rmult_lt_0_compat; lra]).
    assert (S0 : 0 < sh) by (apply Rdiv_lt_0_compat; lra).
    assert (S1 : sh <= beta * lam * (1 + E1 * lam)).
    { apply Rsqr_incr_0_var; [|apply Rmult_le_pos; lra]. rewrite !Rsqr_pow2. apply (Rmult_le_reg_r (M ^ 2)); [exact m2|].
      eapply Rle_trans; [exact Q|]. apply Rle_trans with (2 * beta * (Z * (1 + E1 * lam))); [apply Rmult_le_compat_l; lra|].
      replace (2 * beta * (Z * (1 + E1 * lam))) with ((beta * lam) ^ 2 * M ^ 2 * (1 + E1 * lam)) by (unfold Z; field).
      replace ((beta * lam * (1 + E1 * lam)) ^ 2 * M ^ 2) with ((beta * lam) ^ 2 * M ^ 2 * ((1 + E1 * lam) * (1 + E1 * lam))) by ring.
      apply Rmult_le_compat_l; [apply Rmult_le_pos; [apply pow2_ge_0|lra]|]. pose proof (pow2_ge_0 (E1 * lam)). lra. }
    assert (S2 : beta * lam * k <= beta * lam * ((1 + E1 * lam) * (1 + beta * (k * lam)))).
    { apply (Rmult_le_compat_r (1 + beta * (k * lam))) in S1; [|lra]. unfold sh in S1.
      replace (beta * (k * lam) / (1 + beta * (k * lam)) * (1 + beta * (k * lam))) with (beta * lam * k) in S1 by (field; lra). lra. }
    assert (S3 : k <= (1 + E1 * lam) * (1 + beta * (k * lam))) by (apply (Rmult_le_reg_l (beta * lam)); lra).
    assert (S4 : (1 + E1 * lam) * (beta * (k * lam)) <= 2 * (beta * (k * lam))) by (apply Rmult_le_compat_r; lra).
    assert (S5 : beta * (k * lam) <= k * / 8) by (replace (beta * (k * lam)) with (k * (beta * lam)) by ring; apply Rmult_le_compat_l; lra).
    assert (K2 : k <= 4) by lra.
    assert (S6 : beta * (k * lam) <= 4 * (beta * lam)) by (replace (beta * (k * lam)) with (k * (beta * lam)) by ring; apply Rmult_le_compat_r; lra).
    assert (0 <= beta * (1 + 306 * beta) * lam) by (apply Rmult_le_pos; [apply Rmult_le_pos; lra|lra]).
    unfold spread. fold beta. unfold E1 in *. lra.
  - exfalso. assert (Z * (E1 * lam) <= Z * / 2) by (apply Rmult_le_compat_l; lra). lra.
Qed.
End Units.
