(* Veerman, Stosic, Olvera, Theorem 1: the main resonance of M = N + 1 followers, for all f, g < 0.
     veerman.thm1_omega, veerman.thm1_amp.
   With w^2 = t^2 lambda |f| and Z = M^2 b^2 lambda^2/2, the bounds of veerman_window.v give |a_M|^-2 <= Z (1 + O(lambda)) at t = 1,
   |a_M|^-2 >= Z (1 - O(lambda)) everywhere, and more than the former where |t - 1| exceeds a multiple of lambda = pi^2/(8M^2) + O(M^-4). *)
From Coq Require Import Reals Lra Lia Psatz.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums veerman_complex veerman_front veerman_chain veerman_stability veerman_amplitude.
From Flockproof Require Import veerman_settling veerman_rates veerman_unsettled veerman_coordinates veerman_bounds veerman_window.
From Flockproof Require veerman_numbers.
Open Scope R_scope.

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

(* ---- Theorem 1 ---- *)
Lemma quiet_amplitude f g N v w : f < 0 -> g < 0 -> amplitude f g N v <= amplitude f g N w -> quiet f g N w <= quiet f g N v.
Proof.
  intros Hf Hg H. pose proof (amplitude_pos f g N v Hf Hg). unfold quiet. apply Rinv_le_contravar; [now apply pow_lt|]. apply pow_incr. lra.
Qed.
Lemma lowest_expansion N : let l0 := PI ^ 2 / (8 * INR (S N) ^ 2) in l0 * (1 - l0) <= lowest N <= l0.
Proof.
  intros l0. split; [|left; apply lowest_small]. rewrite lowest_angle. pose proof (M_ge1 N) as M1. set (M := INR (S N)) in *.
  pose proof PI_4. pose proof PI_RGT_0. set (t := PI / (2 * M)).
  assert (T : 0 < t <= 2).
  { unfold t. split; [apply Rdiv_lt_0_compat; lra|]. apply (Rmult_le_reg_r (2 * M)); [lra|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. lra. }
  destruct (pre_cos_bound t 0 ltac:(lra) ltac:(lra)) as [_ U].
  assert (E : cos_approx t (2 * (0 + 1)) = 1 - t ^ 2 / 2 + t ^ 4 / 24) by (unfold cos_approx, cos_term; cbn; field).
  rewrite E in U. assert (L : l0 = t ^ 2 / 2) by (unfold l0, t; field; lra). assert (0 <= t ^ 4) by (apply pow_le; lra).
  rewrite L. replace (t ^ 2 / 2 * (1 - t ^ 2 / 2)) with (t ^ 2 / 2 - t ^ 4 / 4) by field. lra.
Qed.

(* veerman.thm1_omega and veerman.thm1_amp, for M = N + 1 followers: C and M0 depend on f and g only *)
Theorem theorem_1 f g : f < 0 -> g < 0 -> exists C M0, forall N, M0 <= INR (S N) ->
  (exists w, main_resonance f g N w) /\ forall w, main_resonance f g N w ->
    Rabs (w - veerman_numbers.frequency f (INR (S N))) <= C / INR (S N) ^ 3 /\
    Rabs (amplitude f g N w - veerman_numbers.amplitude f g (INR (S N))) <= C / INR (S N).
Proof.
  intros Hf Hg. set (beta := g ^ 2 / - f). assert (B : 0 < beta) by (apply Rdiv_lt_0_compat; [apply pow2_gt_0|]; lra).
  set (E1 := 1 + 304 * beta). set (K := 2 + 6 * beta). set (G := spread f g).
  assert (G0 : 0 < G) by (unfold G, spread; fold beta; assert (0 < beta * (1 + 306 * beta)) by (apply Rmult_lt_0_compat; lra); lra).
  assert (BB : 0 < (1 + 4 * beta) * (3 + beta)) by (apply Rmult_lt_0_compat; lra).
  set (Q := 8 * beta + 2 * E1 + (1 + 4 * beta) * (3 + beta) + 2 * G + 2 * K).
  set (C1 := (G + 1) * (sqrt (- f) * PI ^ 3 / (16 * sqrt 2))). set (C2' := (K + E1) * (sqrt (2 * - f) / - g)).
  pose proof PI_4 as P4. pose proof PI_RGT_0 as P0. assert (R2 : 0 < sqrt 2) by (apply sqrt_lt_R0; lra).
  assert (R22 : sqrt 2 * sqrt 2 = 2) by (apply sqrt_sqrt; lra).
  assert (C10 : 0 <= C1).
  { apply Rmult_le_pos; [lra|]. apply Rmult_le_pos; [apply Rmult_le_pos; [apply sqrt_pos|apply pow_le; lra]|]. left. apply Rinv_0_lt_compat. lra. }
  assert (C20 : 0 <= C2').
  { apply Rmult_le_pos; [unfold K, E1; lra|]. apply Rmult_le_pos; [apply sqrt_pos|left; apply Rinv_0_lt_compat; lra]. }
  exists (C1 + C2'), (2 * Q). intros N HM. pose proof (M_ge1 N) as M1. destruct (lowest_expansion N) as [LL LU]. destruct (lowest_range N) as [L0 L1].
  set (M := INR (S N)) in *. set (l0 := PI ^ 2 / (8 * M ^ 2)) in *. set (lam := lowest N) in *.
  assert (Q1 : 2 <= Q) by (unfold Q, E1, K; lra).
  assert (QL : Q * l0 <= 1).
  { unfold l0. apply (Rmult_le_reg_r (8 * M ^ 2)); [assert (0 < M ^ 2) by (apply pow_lt; lra); lra|].
    replace (Q * (PI ^ 2 / (8 * M ^ 2)) * (8 * M ^ 2)) with (Q * PI ^ 2) by (field; lra).
    assert (PI ^ 2 <= 16) by nra. assert (Q * PI ^ 2 <= Q * 16) by (apply Rmult_le_compat_l; lra).
    assert (2 * Q * 1 <= M * M) by (apply Rmult_le_compat; lra). lra. }
  assert (part : forall q, 0 <= q -> q <= Q -> q * l0 <= 1) by (intros q q0 qQ; assert (q * l0 <= Q * l0) by (apply Rmult_le_compat_r; lra); lra).
  assert (below : forall q, 0 <= q -> q * lam <= q * l0) by (intros q q0; apply Rmult_le_compat_l; lra).
  assert (H1 : 8 * beta * lam <= 1).
  { eapply Rle_trans; [apply below; lra|]. apply part; [lra|]. unfold Q, E1, K. lra. }
  assert (H2 : 2 * (1 + 304 * beta) * lam <= 1).
  { eapply Rle_trans; [apply below; lra|]. apply part; [lra|]. unfold Q, E1, K. lra. }
  assert (H3 : (1 + 4 * beta) * (3 + beta) * lam <= 1).
  { eapply Rle_trans; [apply below; lra|]. apply part; [lra|]. unfold Q, E1, K. lra. }
  assert (H4 : 2 * G * l0 <= 1) by (apply part; [lra|]; unfold Q, E1, K; lra).
  assert (H5 : 2 * K * l0 <= 1) by (apply part; [unfold K; lra|]; unfold Q, E1, K; lra).
  assert (H6 : 2 * E1 * l0 <= 1) by (apply part; [unfold E1; lra|]; unfold Q, E1, K; lra).
  destruct (units f g N Hf Hg) as (_ & _ & _ & ZB & W0 & W2). fold beta M lam in ZB, W0, W2.
  pose proof (quiet_at_middle f g N Hf Hg H1) as Mid. pose proof (quiet_everywhere f g N Hf Hg H1 H3) as All.
  pose proof (close_to_middle f g N Hf Hg H1 H2 H3) as Close. fold beta M lam E1 G in Mid, All, Close.
  set (Z := M ^ 2 * (beta * lam ^ 2) / 2) in *. set (ws := sqrt (- f * lam)) in *.
  assert (Near : forall w, 0 < w -> amplitude f g N ws <= amplitude f g N w -> Rabs (w / ws - 1) <= G * lam).
  { intros w Hw H. apply Close; [exact Hw|]. apply (quiet_amplitude f g N ws w Hf Hg) in H. lra. }
  assert (GL : G * lam <= / 2) by (pose proof (below G ltac:(lra)); lra).
  split.
  - destruct (continuity_ab_maj (amplitude f g N) (ws / 2) (2 * ws) ltac:(lra)) as (w & Mx & W).
    { intros c _. now apply amplitude_continuous. }
    exists w. split; [lra|]. intros w' W'. pose proof (Mx ws ltac:(lra)) as Mw.
    destruct (Rle_lt_dec (amplitude f g N w') (amplitude f g N w)) as [D|D]; [exact D|]. apply Mx.
    pose proof (Near w' W' ltac:(lra)) as T. apply Rabs_le_between in T.
    replace w' with (w' / ws * ws) by (field; lra). split.
    + replace (ws / 2) with (/ 2 * ws) by field. apply Rmult_le_compat_r; lra.
    + apply Rmult_le_compat_r; lra.
  - intros w [Hw Hmax]. pose proof (Hmax ws W0) as Ha. pose proof (Near w Hw Ha) as T. split.
    + (* the frequency *)
      set (w0 := veerman_numbers.frequency f M). assert (SF : 0 < sqrt (- f)) by (apply sqrt_lt_R0; lra). assert (SF2 : sqrt (- f) * sqrt (- f) = - f) by (apply sqrt_sqrt; lra).
      assert (w0E : w0 = sqrt (- f) * PI / (M * 2 * sqrt 2)) by (unfold w0, veerman_numbers.frequency; now rewrite Rabs_left).
      assert (w00 : 0 < w0) by (rewrite w0E; apply Rdiv_lt_0_compat; apply Rmult_lt_0_compat; lra).
      assert (w02 : w0 ^ 2 = - f * l0).
      { rewrite w0E. unfold l0. replace ((sqrt (- f) * PI / (M * 2 * sqrt 2)) ^ 2) with ((sqrt (- f) * sqrt (- f)) * PI ^ 2 / (4 * M ^ 2 * (sqrt 2 * sqrt 2))) by (field; lra).
        rewrite SF2, R22. field. lra. }
      assert (LC : w0 * l0 = sqrt (- f) * PI ^ 3 / (16 * sqrt 2) / M ^ 3) by (rewrite w0E; unfold l0; field; lra).
      assert (l00 : 0 < l0) by lra. assert (l01 : l0 <= 1) by (assert (1 * l0 <= Q * l0) by (apply Rmult_le_compat_r; lra); lra).
      assert (U1 : ws <= w0).
      { apply Rsqr_incr_0_var; [|lra]. rewrite !Rsqr_pow2, W2, w02. apply Rmult_le_compat_l; lra. }
      assert (U2 : w0 * (1 - l0) <= ws).
      { apply Rsqr_incr_0_var; [|lra]. rewrite !Rsqr_pow2, W2. replace ((w0 * (1 - l0)) ^ 2) with (w0 ^ 2 * (1 - l0) * (1 - l0)) by ring. rewrite w02.
        replace (- f * l0 * (1 - l0) * (1 - l0)) with (- f * (l0 * (1 - l0) * (1 - l0))) by ring. apply Rmult_le_compat_l; [lra|].
        assert (l0 * (1 - l0) * (1 - l0) <= l0 * (1 - l0) * 1) by (apply Rmult_le_compat_l; [apply Rmult_le_pos; lra|lra]). lra. }
      assert (U3 : Rabs (w - ws) <= w0 * (G * l0)).
      { replace (w - ws) with (ws * (w / ws - 1)) by (field; lra). rewrite Rabs_mult, (Rabs_right ws) by lra.
        apply Rmult_le_compat; try lra; [apply Rabs_pos|]. pose proof (below G ltac:(lra)). lra. }
      assert (U4 : Rabs (ws - w0) <= w0 * l0) by (rewrite Rabs_left1 by lra; lra).
      apply Rle_trans with ((G + 1) * (w0 * l0)).
      * replace (w - w0) with ((w - ws) + (ws - w0)) by ring. pose proof (Rabs_triang (w - ws) (ws - w0)). lra.
      * rewrite LC. replace ((G + 1) * (sqrt (- f) * PI ^ 3 / (16 * sqrt 2) / M ^ 3)) with (C1 / M ^ 3) by (unfold C1, Rdiv; ring).
        apply Rmult_le_compat_r; [left; apply Rinv_0_lt_compat, pow_lt; lra|lra].
    + (* the amplitude *)
      set (A0 := veerman_numbers.amplitude f g M). set (A := amplitude f g N w) in *.
      set (Z0 := M ^ 2 * (beta * l0 ^ 2) / 2). assert (l00 : 0 < l0) by lra. assert (m2 : 0 < M ^ 2) by (apply pow_lt; lra).
      assert (Z00 : 0 < Z0) by (unfold Z0; apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat; [exact m2|apply Rmult_lt_0_compat; [exact B|now apply pow_lt]]|lra]).
      assert (S2 : 0 < sqrt (2 * - f)) by (apply sqrt_lt_R0; lra). assert (S22 : sqrt (2 * - f) * sqrt (2 * - f) = 2 * - f) by (apply sqrt_sqrt; lra).
      assert (p2 : 0 < PI ^ 2) by (apply pow_lt; lra).
      assert (A0E : A0 = 8 * sqrt (2 * - f) / (PI ^ 2 * - g) * M) by (unfold A0, veerman_numbers.amplitude; now rewrite !Rabs_left).
      assert (A00 : 0 < A0).
      { rewrite A0E. apply Rmult_lt_0_compat; [|lra]. apply Rdiv_lt_0_compat; [lra|]. apply Rmult_lt_0_compat; lra. }
      assert (AZ : A0 ^ 2 * Z0 = 1).
      { rewrite A0E. unfold Z0, l0, beta.
        replace ((8 * sqrt (2 * - f) / (PI ^ 2 * - g) * M) ^ 2) with (64 * (sqrt (2 * - f) * sqrt (2 * - f)) / (PI ^ 4 * g ^ 2) * M ^ 2) by (field; lra).
        rewrite S22. field. lra. }
      assert (LA : A0 * l0 = sqrt (2 * - f) / - g / M) by (rewrite A0E; unfold l0; field; lra).
      pose proof (amplitude_pos f g N w Hf Hg) as Ap. fold A in Ap.
      assert (AQ : A ^ 2 * quiet f g N w = 1) by (unfold quiet; fold A; apply Rinv_r, pow_nonzero; lra).
      assert (q1 : quiet f g N w <= Z * (1 + E1 * lam)) by (apply (quiet_amplitude f g N ws w Hf Hg) in Ha; lra).
      pose proof (All w Hw) as q2. set (q := quiet f g N w) in *.
      assert (ZU : Z <= Z0).
      { unfold Z, Z0. apply Rmult_le_compat_r; [lra|]. apply Rmult_le_compat_l; [lra|]. apply Rmult_le_compat_l; [lra|]. apply pow_incr. lra. }
      assert (ZL : Z0 * (1 - 2 * l0) <= Z).
      { assert (X : l0 ^ 2 * (1 - 2 * l0) <= lam ^ 2).
        { assert (K1 : 1 * l0 <= K * l0) by (apply Rmult_le_compat_r; unfold K; lra).
          assert ((l0 * (1 - l0)) ^ 2 <= lam ^ 2) by (apply pow_incr; split; [apply Rmult_le_pos; lra|lra]).
          assert (0 <= l0 ^ 2 * l0 ^ 2) by (apply Rmult_le_pos; apply pow2_ge_0). lra. }
        unfold Z, Z0. replace (M ^ 2 * (beta * l0 ^ 2) / 2 * (1 - 2 * l0)) with (M ^ 2 * (beta * (l0 ^ 2 * (1 - 2 * l0))) / 2) by field.
        apply Rmult_le_compat_r; [lra|]. apply Rmult_le_compat_l; [lra|]. apply Rmult_le_compat_l; lra. }
      set (e := E1 * l0). assert (E10 : 0 < E1) by (unfold E1; lra). assert (e0 : 0 < e) by (apply Rmult_lt_0_compat; lra). assert (e1 : e <= / 2) by (unfold e; lra).
      set (k := K * l0). assert (K0 : 0 < K) by (unfold K; lra). assert (k0 : 0 < k) by (apply Rmult_lt_0_compat; lra). assert (k1 : k <= / 2) by (unfold k; lra).
      assert (QU : q <= Z0 * (1 + e)).
      { eapply Rle_trans; [exact q1|]. pose proof (below E1 ltac:(lra)). assert (0 <= E1 * lam) by (apply Rmult_le_pos; lra).
        apply Rmult_le_compat; unfold e; lra. }
      assert (QD : Z0 * (1 - k) <= q).
      { eapply Rle_trans; [|exact q2]. pose proof (below (6 * beta) ltac:(lra)).
        assert (Z * (1 - 6 * beta * l0) <= Z * (1 - 6 * beta * lam)) by (apply Rmult_le_compat_l; lra).
        assert (X1 : 0 <= 1 - 6 * beta * l0) by (unfold k, K in k1; lra).
        assert (Z0 * (1 - 2 * l0) * (1 - 6 * beta * l0) <= Z * (1 - 6 * beta * l0)) by (apply Rmult_le_compat_r; lra).
        assert (0 <= Z0 * (2 * l0 * (6 * beta * l0))) by (apply Rmult_le_pos; [lra|]; apply Rmult_le_pos; [lra|apply Rmult_le_pos; lra]).
        unfold k, K. lra. }
      pose proof (pow2_ge_0 A) as A2. pose proof (pow2_ge_0 A0) as A02.
      (* A^2 (1 - k) <= A0^2 <= A^2 (1 + e) *)
      assert (V1 : A ^ 2 * (1 - k) <= A0 ^ 2).
      { apply (Rmult_le_reg_r Z0); [exact Z00|]. rewrite AZ, Rmult_assoc. apply Rle_trans with (A ^ 2 * q); [apply Rmult_le_compat_l; lra|lra]. }
      assert (V2 : A0 ^ 2 <= A ^ 2 * (1 + e)).
      { apply (Rmult_le_reg_r Z0); [exact Z00|]. rewrite AZ, Rmult_assoc. apply Rle_trans with (A ^ 2 * q); [lra|apply Rmult_le_compat_l; lra]. }
      assert (X1 : A <= A0 * (1 + k)).
      { apply Rsqr_incr_0_var; [|apply Rmult_le_pos; lra]. rewrite !Rsqr_pow2, Rpow_mult_distr.
        apply Rle_trans with (A ^ 2 * (1 - k) * (1 + k) ^ 2); [|apply Rmult_le_compat_r; [apply pow2_ge_0|exact V1]].
        rewrite Rmult_assoc, <- (Rmult_1_r (A ^ 2)) at 1. apply Rmult_le_compat_l; [exact A2|].
        assert (0 <= k * (1 - k - k * k)) by (apply Rmult_le_pos; [lra|]; assert (k * k <= k * / 2) by (apply Rmult_le_compat_l; lra); lra). lra. }
      assert (X2 : A0 * (1 - e) <= A).
      { apply Rsqr_incr_0_var; [|lra]. rewrite !Rsqr_pow2, Rpow_mult_distr.
        apply Rle_trans with (A ^ 2 * (1 + e) * (1 - e) ^ 2); [apply Rmult_le_compat_r; [apply pow2_ge_0|exact V2]|].
        rewrite Rmult_assoc. apply Rle_trans with (A ^ 2 * 1); [|lra]. apply Rmult_le_compat_l; [exact A2|].
        assert (0 <= e * (1 + e - e * e)) by (apply Rmult_le_pos; [lra|]; assert (e * e <= e * / 2) by (apply Rmult_le_compat_l; lra); lra). lra. }
      apply Rle_trans with ((K + E1) * (A0 * l0)).
      * apply Rabs_le. unfold k in X1. unfold e in X2. assert (0 <= A0 * l0 * K) by (apply Rmult_le_pos; [apply Rmult_le_pos|]; lra).
        assert (0 <= A0 * l0 * E1) by (apply Rmult_le_pos; [apply Rmult_le_pos|]; lra). lra.
      * rewrite LA. replace ((K + E1) * (sqrt (2 * - f) / - g / M)) with (C2' / M) by (unfold C2', Rdiv; ring).
        apply Rmult_le_compat_r; [left; apply Rinv_0_lt_compat; lra|lra].
Qed.
