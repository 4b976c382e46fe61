(* Veerman, Stosic, Olvera, Theorem 1, continued: the response of M = N + 1 followers against lambda = 1 - cos(pi/(2M)),
   for every M and w > 0: lower bounds everywhere, an upper bound where w^2 = lambda |f|. *)
From Coq Require Import Reals Lra Lia Psatz.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums veerman_complex veerman_front veerman_chain veerman_stability veerman_amplitude.
From Flockproof Require Import veerman_settling veerman_rates veerman_unsettled veerman_coordinates veerman_bounds.
Open Scope R_scope.

(* |a_M|^-2 *)
Definition quiet (f g : R) (N : nat) (w : R) : R := / amplitude f g N w ^ 2.
Lemma amplitude_pos f g N w : f < 0 -> g < 0 -> 0 < amplitude f g N w.
Proof.
  intros Hf Hg. pose proof (cheb_neq0 f g w (S N) Hf Hg) as NZ. unfold amplitude. rewrite Cmod_inv by exact NZ.
  apply Rinv_0_lt_compat. now apply Cmod_gt_0.
Qed.
Lemma one_minus_cos x : 1 - cos x = 2 * sin (x / 2) ^ 2.
Proof. replace (cos x) with (cos (2 * (x / 2))) by (f_equal; field). rewrite cos_2a_sin. ring. Qed.
Lemma jordan m : 0 <= m <= PI / 2 -> 2 / PI * m <= sin m.
Proof.
  intros M. pose proof PI_RGT_0 as P. pose proof (sin_concave (2 / PI * m) (PI / 2)) as H.
  replace (2 / PI * m * (PI / 2)) with m in H by (field; lra). rewrite sin_PI2, Rmult_1_r in H. apply H; [|lra].
  assert (0 < 2 / PI) by (apply Rdiv_lt_0_compat; lra). split; [apply Rmult_le_pos; lra|].
  replace 1 with (2 / PI * (PI / 2)) by (field; lra). apply Rmult_le_compat_l; lra.
Qed.

Section Window.
Variables (f g : R) (N : nat).
Hypotheses (Hf : f < 0) (Hg : g < 0).
Let beta := g ^ 2 / - f.
Let M := INR (S N).
Let lam := lowest N.
Let share (a2 : R) := beta * a2 / (1 + beta * a2).
Lemma M_ge1 : 1 <= M.
Proof using. unfold M. apply (le_INR 1). lia. Qed.
Lemma half_angle : lam = 2 * sin (PI / (4 * M)) ^ 2.
Proof using.
  unfold lam. rewrite (lowest_angle N). rewrite one_minus_cos. fold M. pose proof M_ge1. f_equal. f_equal. f_equal. field. lra.
Qed.

Lemma quiet_moderate w : 0 < w -> w ^ 2 / - f <= 4 -> M ^ 2 * share (w ^ 2 / - f) ^ 2 <= 2 * beta * quiet f g N w.
Proof using Hf Hg.
  intros Hw A4. destruct (frequency_coordinates f g w Hf Hg Hw) as (x & y & X & Y & F & Im & R1 & R2 & P2 & _).
  pose proof (sinh_moderate f g w Hf Hg Hw x y Im R1 P2 A4) as L. specialize (F N). fold M in F.
  pose proof (amplitude_pos f g N w Hf Hg) as A0. destruct (positives f g w Hf Hg Hw) as (B & _ & _). fold beta in B, L.
  assert (Q : quiet f g N w = cos (M * x) ^ 2 + sinh (M * y) ^ 2).
  { unfold quiet. apply (Rmult_eq_reg_l (amplitude f g N w ^ 2)); [|apply pow_nonzero; lra]. rewrite F. apply Rinv_r, pow_nonzero. lra. }
  rewrite Q. pose proof (sinh_mult (S N) y Y) as S1. fold M in S1. pose proof M_ge1.
  assert (0 <= sinh y) by (apply Rle_trans with y; [exact Y|now apply sinh_ge]).
  assert (S2 : M ^ 2 * sinh y ^ 2 <= sinh (M * y) ^ 2).
  { replace (M ^ 2 * sinh y ^ 2) with ((M * sinh y) ^ 2) by ring. apply pow_incr. split; [apply Rmult_le_pos; lra|exact S1]. }
  unfold share. apply Rle_trans with (M ^ 2 * (2 * beta * sinh y ^ 2)); [apply Rmult_le_compat_l; [apply pow2_ge_0|exact L]|].
  pose proof (pow2_ge_0 (cos (M * x))).
  replace (M ^ 2 * (2 * beta * sinh y ^ 2)) with (2 * beta * (M ^ 2 * sinh y ^ 2)) by ring. apply Rmult_le_compat_l; lra.
Qed.
Lemma quiet_large w : 0 < w -> 4 <= w ^ 2 / - f -> M ^ 2 * share (w ^ 2 / - f) <= (3 + beta) * quiet f g N w.
Proof using Hf Hg.
  intros Hw A4. destruct (frequency_coordinates f g w Hf Hg Hw) as (x & y & X & Y & F & Im & R1 & R2 & P2 & _).
  pose proof (sinh_large f g w Hf Hg Hw x y Im R1 R2 P2 A4) as L. specialize (F N). fold M in F.
  pose proof (amplitude_pos f g N w Hf Hg) as A0. destruct (positives f g w Hf Hg Hw) as (B & _ & _). fold beta in B, L.
  assert (Q : quiet f g N w = cos (M * x) ^ 2 + sinh (M * y) ^ 2).
  { unfold quiet. apply (Rmult_eq_reg_l (amplitude f g N w ^ 2)); [|apply pow_nonzero; lra]. rewrite F. apply Rinv_r, pow_nonzero. lra. }
  rewrite Q. pose proof (sinh_mult (S N) y Y) as S1. fold M in S1. pose proof M_ge1.
  assert (0 <= sinh y) by (apply Rle_trans with y; [exact Y|now apply sinh_ge]).
  assert (S2 : M ^ 2 * sinh y ^ 2 <= sinh (M * y) ^ 2).
  { replace (M ^ 2 * sinh y ^ 2) with ((M * sinh y) ^ 2) by ring. apply pow_incr. split; [apply Rmult_le_pos; lra|exact S1]. }
  unfold share. apply Rle_trans with (M ^ 2 * ((3 + beta) * sinh y ^ 2)); [apply Rmult_le_compat_l; [apply pow2_ge_0|exact L]|].
  pose proof (pow2_ge_0 (cos (M * x))).
  replace (M ^ 2 * ((3 + beta) * sinh y ^ 2)) with ((3 + beta) * (M ^ 2 * sinh y ^ 2)) by ring. apply Rmult_le_compat_l; lra.
Qed.
(* where a^2 = t^2 lambda, t <= 1, the angle is at most t times that of the first zero of T_M *)
Lemma angle_below x t : 0 <= x <= PI -> 0 <= t <= 1 -> 1 - cos x <= t ^ 2 * lam -> M * x <= t * (PI / 2).
Proof using.
  intros X T H. pose proof M_ge1 as M1. pose proof PI_RGT_0 as P. rewrite one_minus_cos, half_angle in H.
  assert (U : 0 < PI / (4 * M) <= PI / 4).
  { split; [apply Rdiv_lt_0_compat; lra|]. apply Rmult_le_compat_l; [lra|]. apply Rinv_le_contravar; lra. }
  set (u := PI / (4 * M)) in *. assert (S0 : 0 <= sin u) by (apply sin_ge_0; lra).
  assert (TU : 0 <= t * u <= u) by nra.
  assert (C : sin (x / 2) <= sin (t * u)).
  { apply Rle_trans with (t * sin u); [|apply sin_concave; lra].
    apply Rsqr_incr_0_var; [|apply Rmult_le_pos; lra]. rewrite !Rsqr_pow2. rewrite Rpow_mult_distr. lra. }
  assert (L : x / 2 <= t * u) by (apply sin_incr_0; lra).
  replace (t * (PI / 2)) with (2 * M * (t * u)) by (unfold u; field; lra). apply (Rmult_le_compat_l (2 * M)) in L; lra.
Qed.
Lemma quiet_below w t : 0 < w -> 0 <= t <= 1 -> w ^ 2 / - f = t ^ 2 * lam ->
  (1 - t) ^ 2 + M ^ 2 * share (w ^ 2 / - f) ^ 2 / (2 * beta) <= quiet f g N w.
Proof using Hf Hg.
  intros Hw T E. destruct (frequency_coordinates f g w Hf Hg Hw) as (x & y & X & Y & F & Im & R1 & R2 & P2 & _).
  assert (A4 : w ^ 2 / - f <= 4).
  { rewrite E. destruct (lowest_range N) as [L0 L1]. fold lam in L0, L1. assert (t ^ 2 <= 1) by nra. assert (t ^ 2 * lam <= 1 * 1) by (apply Rmult_le_compat; try lra; apply pow2_ge_0). lra. }
  pose proof (sinh_moderate f g w Hf Hg Hw x y Im R1 P2 A4) as L. specialize (F N). fold M in F.
  pose proof (amplitude_pos f g N w Hf Hg) as A0. destruct (positives f g w Hf Hg Hw) as (B & _ & _). fold beta in B, L.
  assert (Q : quiet f g N w = cos (M * x) ^ 2 + sinh (M * y) ^ 2).
  { unfold quiet. apply (Rmult_eq_reg_l (amplitude f g N w ^ 2)); [|apply pow_nonzero; lra]. rewrite F. apply Rinv_r, pow_nonzero. lra. }
  rewrite Q. pose proof (sinh_mult (S N) y Y) as S1. fold M in S1. pose proof M_ge1 as M1.
  assert (0 <= sinh y) by (apply Rle_trans with y; [exact Y|now apply sinh_ge]).
  assert (S2 : M ^ 2 * sinh y ^ 2 <= sinh (M * y) ^ 2).
  { replace (M ^ 2 * sinh y ^ 2) with ((M * sinh y) ^ 2) by ring. apply pow_incr. split; [apply Rmult_le_pos; lra|exact S1]. }
  apply Rplus_le_compat.
  - pose proof (cosh_ge1 y). pose proof PI_RGT_0 as P.
    pose proof (angle_below x t X T ltac:(rewrite <- E; lra)) as MX.
    assert (0 <= M * x) by (apply Rmult_le_pos; lra). apply pow_incr. split; [lra|].
    apply Rle_trans with (cos (t * (PI / 2))); [|apply cos_decr_1; nra].
    replace (t * (PI / 2)) with (PI / 2 - (1 - t) * (PI / 2)) by field. rewrite cos_shift.
    pose proof (sin_concave (1 - t) (PI / 2) ltac:(lra) ltac:(lra)) as SC. rewrite sin_PI2 in SC. lra.
  - apply Rle_trans with (M ^ 2 * sinh y ^ 2); [|exact S2]. unfold share, Rdiv at 1. rewrite Rmult_assoc. apply Rmult_le_compat_l; [apply pow2_ge_0|].
    apply (Rmult_le_reg_r (2 * beta)); [lra|]. rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra. lra.
Qed.
(* an upper bound at the middle *)
Lemma quiet_middle w : 0 < w -> w ^ 2 / - f = lam -> let V := M ^ 2 * (beta * lam ^ 2) / (2 - lam) in V <= 1 ->
  quiet f g N w <= 64 * (M ^ 2 * (beta * lam ^ 2)) ^ 2 + V * (1 + 2 * V) ^ 2.
Proof using Hf Hg.
  intros Hw E V V1. destruct (frequency_coordinates f g w Hf Hg Hw) as (x & y & X & Y & F & Im & R1 & R2 & P2 & _).
  destruct (lowest_range N) as [L0 L1]. fold lam in L0, L1.
  pose proof (sinh_upper f g w Hf Hg Hw x y Im R1 R2 P2) as L. specialize (F N). fold M in F.
  pose proof (amplitude_pos f g N w Hf Hg) as A0. destruct (positives f g w Hf Hg Hw) as (B & _ & C). fold beta in B, L, R2, C.
  rewrite E in L, R1, R2, C. specialize (L ltac:(lra)).
  assert (Q : quiet f g N w = cos (M * x) ^ 2 + sinh (M * y) ^ 2).
  { unfold quiet. apply (Rmult_eq_reg_l (amplitude f g N w ^ 2)); [|apply pow_nonzero; lra]. rewrite F. apply Rinv_r, pow_nonzero. lra. }
  rewrite Q. pose proof M_ge1 as M1. pose proof PI_RGT_0 as P. pose proof PI_4 as P4.
  set (S := sinh y ^ 2) in *. pose proof (pow2_ge_0 (sinh y)) as S0. fold S in S0. set (K := beta * lam ^ 2) in *.
  assert (K0 : 0 <= K) by (apply Rmult_le_pos; [lra|apply pow2_ge_0]).
  assert (SV : M ^ 2 * S <= V).
  { unfold V. apply (Rmult_le_reg_r (2 - lam)); [lra|]. replace (M ^ 2 * K / (2 - lam) * (2 - lam)) with (M ^ 2 * K) by (field; lra).
    rewrite Rmult_assoc, (Rmult_comm S). apply Rmult_le_compat_l; [apply pow2_ge_0|exact L]. }
  apply Rplus_le_compat.
  - (* the cosine *)
    assert (SK : S <= K) by (assert (0 <= (1 - lam) * S) by (apply Rmult_le_pos; lra); lra).
    pose proof (cosh_ge1 y) as C1. pose proof (cosh_sqr y) as CS. fold S in CS.
    assert (CY : cosh y - 1 <= K) by nra.
    set (r := cosh y - cos x) in *.
    assert (LR : lam - r <= K).
    { apply (Rmult_le_reg_r (lam + r)); [lra|]. replace ((lam - r) * (lam + r)) with (lam ^ 2 - r ^ 2) by ring. rewrite R2.
      replace (lam ^ 2 - lam ^ 2 / (1 + beta * lam)) with (beta * lam ^ 2 * lam / (1 + beta * lam)) by (field; lra).
      apply Rle_trans with (K * lam).
      - fold K. apply (Rmult_le_reg_r (1 + beta * lam)); [lra|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra.
        assert (0 <= K * lam * (beta * lam)) by (apply Rmult_le_pos; [apply Rmult_le_pos; lra|lra]). lra.
      - apply Rmult_le_compat_l; lra. }
    set (x0 := PI / (2 * M)). assert (MX0 : M * x0 = PI / 2) by (unfold x0; field; lra).
    pose proof (angle_below x 1 X ltac:(lra) ltac:(unfold r in *; lra)) as MX. rewrite Rmult_1_l in MX.
    assert (XX : x <= x0) by (apply (Rmult_le_reg_l M); lra).
    assert (X0 : 0 < x0 <= PI / 2).
    { split; [unfold x0; apply Rdiv_lt_0_compat; lra|]. assert (1 * x0 <= M * x0); [|lra]. apply Rmult_le_compat_r; [|exact M1]. unfold x0. left. apply Rdiv_lt_0_compat; lra. }
    assert (CL : cos x0 = 1 - lam) by (unfold lam; rewrite (lowest_angle N); fold M; unfold x0; ring).
    assert (D : cos x - cos x0 <= 2 * K) by (unfold r in *; lra).
    assert (DX : x0 - x <= PI * M * (2 * K)).
    { assert (T : 2 * (2 / PI * (x0 / 2)) * (2 / PI * ((x0 - x) / 2)) <= cos x - cos x0).
      { rewrite form2. replace ((x - x0) / 2) with (- ((x0 - x) / 2)) by field. rewrite sin_neg.
        pose proof (jordan ((x0 - x) / 2) ltac:(lra)) as J1. pose proof (jordan (x0 / 2) ltac:(lra)) as J2.
        assert (J3 : sin (x0 / 2) <= sin ((x + x0) / 2)) by (apply sin_incr_1; lra).
        assert (H2 : 0 < 2 / PI) by (apply Rdiv_lt_0_compat; lra).
        assert (0 <= 2 / PI * (x0 / 2)) by (apply Rmult_le_pos; lra). assert (0 <= 2 / PI * ((x0 - x) / 2)) by (apply Rmult_le_pos; lra).
        assert (2 / PI * (x0 / 2) * (2 / PI * ((x0 - x) / 2)) <= sin ((x + x0) / 2) * sin ((x0 - x) / 2)) by (apply Rmult_le_compat; lra). lra. }
      replace (2 * (2 / PI * (x0 / 2)) * (2 / PI * ((x0 - x) / 2))) with ((x0 - x) / (PI * M)) in T by (unfold x0 at 2; field; lra).
      assert (PM : 0 < PI * M) by (apply Rmult_lt_0_compat; lra).
      apply (Rmult_le_reg_r (/ (PI * M))); [now apply Rinv_0_lt_compat|]. replace (PI * M * (2 * K) * / (PI * M)) with (2 * K) by (field; lra). unfold Rdiv in T. lra. }
    replace (64 * (M ^ 2 * K) ^ 2) with ((8 * (M ^ 2 * K)) ^ 2) by ring. apply pow_incr. split.
    + apply cos_ge_0; [|lra]. assert (0 <= M * x) by (apply Rmult_le_pos; lra). lra.
    + replace (M * x) with (PI / 2 - M * (x0 - x)) by (rewrite Rmult_minus_distr_l, MX0; ring). rewrite cos_shift.
      assert (Z : 0 <= M * (x0 - x)) by (apply Rmult_le_pos; lra).
      assert (SL : sin (M * (x0 - x)) <= M * (x0 - x)) by (destruct Z as [Z|Z]; [left; now apply sin_lt_x|rewrite <- Z, sin_0; lra]).
      assert (M * (x0 - x) <= M * (PI * M * (2 * K))) by (apply Rmult_le_compat_l; lra).
      assert (0 <= M ^ 2 * K) by (apply Rmult_le_pos; [apply pow2_ge_0|exact K0]).
      assert (PI * (2 * (M ^ 2 * K)) <= 4 * (2 * (M ^ 2 * K))) by (apply Rmult_le_compat_r; lra). lra.
  - (* the hyperbolic sine *)
    set (v := M * sinh y). assert (Sy : y <= sinh y) by now apply sinh_ge. assert (V2 : v ^ 2 <= V) by (unfold v; rewrite Rpow_mult_distr; exact SV).
    assert (V0 : 0 <= v) by (apply Rmult_le_pos; lra). assert (VB : v <= 1) by nra.
    assert (sinh (M * y) <= v * (1 + 2 * v ^ 2)).
    { apply Rle_trans with (sinh v); [apply sinh_mono, Rmult_le_compat_l; lra|apply sinh_le; lra]. }
    assert (0 <= sinh (M * y)) by (rewrite <- sinh_0; apply sinh_mono, Rmult_le_pos; lra).
    apply Rle_trans with ((v * (1 + 2 * v ^ 2)) ^ 2); [apply pow_incr; lra|]. rewrite Rpow_mult_distr.
    pose proof (pow2_ge_0 v). apply Rmult_le_compat; [lra|apply pow2_ge_0|exact V2|]. apply pow_incr. lra.
Qed.
End Window.
