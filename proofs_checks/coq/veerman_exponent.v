(* Veerman, Stosic, Olvera, proof of Theorem 1: |mu_+-|^(N+1) = e^(+-x/(N+1)) + O(N^-3) at the main resonance.
     veerman.thm1_mod; veerman.thm1_x, with x = pi^2 |g|/(8 sqrt2 sqrt|f|) (printed with |f| in the place of sqrt|f|).
   In the coordinates gamma = cos(x - i y) the roots are mu_+- = e^(+-(y + i x)), and sinh y = a^2 b/sqrt2 (1 + O(a^2)). *)
From Coq Require Import Reals Lra Lia Psatz.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums veerman_complex veerman_front veerman_chain veerman_stability veerman_amplitude.
From Flockproof Require Import veerman_coordinates veerman_bounds veerman_theorem1 veerman_size_limit.
From Flockproof Require veerman_numbers.
Open Scope R_scope.

Lemma cosh_plus_sinh y : cosh y + sinh y = exp y.
Proof. unfold cosh, sinh. field. Qed.
Lemma cosh_minus_sinh y : cosh y - sinh y = exp (- y).
Proof. unfold cosh, sinh. field. Qed.
Lemma mu_modulus (gam : C) x y : gam = (cos x * cosh y, sin x * sinh y) -> 0 < cos x -> 0 < y ->
  Cmod (mu_plus gam) = exp y /\ Cmod (mu_minus gam) = exp (- y).
Proof.
  intros E X Y. set (q := (sinh y * cos x, cosh y * sin x) : C). set (s := Csqrt (gam * gam - 1)%C).
  assert (SY : 0 < sinh y) by (apply Rlt_le_trans with y; [exact Y|apply sinh_ge; lra]).
  assert (Q : (q * q = gam * gam - 1)%C).
  { rewrite E. unfold q. pose proof (cosh_sqr y) as C. pose proof (sin_sqr x) as S.
    apply injective_projections; cbn; [|ring].
    transitivity (sinh y ^ 2 * cos x ^ 2 - cosh y ^ 2 * sin x ^ 2); [ring|]. transitivity (cos x ^ 2 * cosh y ^ 2 - sin x ^ 2 * sinh y ^ 2 - 1); [|ring].
    rewrite C, S. ring. }
  assert (SQ : s = q).
  { assert (P : ((s - q) * (s + q) = 0)%C).
    { replace ((s - q) * (s + q))%C with (s * s - q * q)%C by ring. unfold s. rewrite Csqrt_sqr, Q. ring. }
    destruct (Ceq_dec (s - q)%C 0%C) as [A|A]; [replace s with (s - q + q)%C by ring; rewrite A; ring|].
    destruct (Ceq_dec (s + q)%C 0%C) as [B|B]; [|exfalso; exact (Cmult_neq_0 _ _ A B P)].
    exfalso. pose proof (Csqrt_angle (gam * gam - 1)%C) as An. fold s in An. 
    assert (Bf : fst s + sinh y * cos x = 0) by exact (f_equal fst B).
    assert (0 < sinh y * cos x) by (apply Rmult_lt_0_compat; lra). destruct An as [An|[An _]]; lra. }
  assert (U : forall r z : R, 0 < r -> Cmod (r * cos z, r * sin z) = r).
  { intros r z R0. apply Rsqr_inj; [apply Cmod_ge_0|lra|]. rewrite !Rsqr_pow2, Cmod_sqr. cbn [fst snd]. rewrite !Rpow_mult_distr, sin_sqr. ring. }
  unfold mu_plus, mu_minus. fold s. rewrite SQ, E. unfold q. split.
  - rewrite <- (U (exp y) x (exp_pos y)). f_equal. rewrite <- cosh_plus_sinh. apply injective_projections; cbn; ring.
  - rewrite <- (U (exp (- y)) (- x) (exp_pos (- y))), cos_neg, sin_neg. f_equal. rewrite <- cosh_minus_sinh. apply injective_projections; cbn; ring.
Qed.

(* at one frequency *)
Lemma exponent_bounds f g w : f < 0 -> g < 0 -> 0 < w ->
  let a2 := w ^ 2 / - f in let beta := g ^ 2 / - f in let k := sqrt (beta / 2) in a2 <= / 2 -> 2 * k * a2 <= 1 ->
  exists y, 0 < y /\ Cmod (mu_plus (gamma f g w)) = exp y /\ Cmod (mu_minus (gamma f g w)) = exp (- y) /\
    k * a2 * (1 - beta * a2) - 2 * (2 * k * a2) ^ 3 <= y <= k * a2 * (1 + a2).
Proof.
  intros Hf Hg Hw a2 beta k A2 KA. destruct (positives f g w Hf Hg Hw) as (B & A & C). fold beta a2 in B, A, C.
  destruct (frequency_coordinates f g w Hf Hg Hw) as (x & y & X & Y & _ & Im & R1 & R2 & P2 & Z).
  pose proof (sinh_upper f g w Hf Hg Hw x y Im R1 R2 P2) as Up. pose proof (sinh_moderate f g w Hf Hg Hw x y Im R1 P2) as Lo.
  fold beta a2 in Im, R1, R2, P2, Up, Lo. specialize (Up ltac:(lra)). specialize (Lo ltac:(lra)). set (c := beta * a2) in *.
  assert (K2 : k * k = beta / 2) by (unfold k; apply sqrt_sqrt; lra). assert (K0 : 0 < k) by (unfold k; apply sqrt_lt_R0; lra).
  assert (Y0 : 0 < y).
  { destruct Y as [Y|Y]; [exact Y|]. exfalso. rewrite <- Y, sinh_0 in Im. assert (0 < a2 ^ 2 * c / (1 + c) ^ 2); [|lra].
    apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat; [apply pow_lt|]; lra|apply pow_lt; lra]. }
  assert (SY : y <= sinh y) by now apply sinh_ge. pose proof (cosh_ge1 y).
  assert (U : sinh y <= k * a2 * (1 + a2)).
  { apply Rsqr_incr_0_var; [|apply Rmult_le_pos; [apply Rmult_le_pos|]; lra]. rewrite !Rsqr_pow2.
    replace ((k * a2 * (1 + a2)) ^ 2) with (k * k * (a2 ^ 2 * (1 + a2) ^ 2)) by ring. rewrite K2.
    apply (Rmult_le_reg_l (2 - a2)); [lra|]. eapply Rle_trans; [exact Up|].
    assert (0 <= beta / 2 * a2 ^ 2 * (a2 * (3 - a2 * a2))); [|lra]. apply Rmult_le_pos; [apply Rmult_le_pos; [lra|apply pow2_ge_0]|].
    apply Rmult_le_pos; [lra|]. assert (a2 * a2 <= 1 * 1) by (apply Rmult_le_compat; lra). lra. }
  assert (KA0 : 0 < k * a2) by (apply Rmult_lt_0_compat; lra).
  assert (U2 : sinh y <= 2 * k * a2) by (assert (k * a2 * (1 + a2) <= k * a2 * 2) by (apply Rmult_le_compat_l; lra); lra).
  assert (L : k * a2 * (1 - c) <= sinh y).
  { destruct (Rle_lt_dec 1 c) as [D|D]; [assert (0 <= k * a2 * (c - 1)) by (apply Rmult_le_pos; lra); lra|].
    apply Rsqr_incr_0_var; [|lra]. rewrite !Rsqr_pow2. replace ((k * a2 * (1 - c)) ^ 2) with (k * k * (a2 ^ 2 * (1 - c) ^ 2)) by ring. rewrite K2.
    apply (Rmult_le_reg_l (2 * beta)); [lra|]. eapply Rle_trans; [|exact Lo].
    replace (2 * beta * (beta / 2 * (a2 ^ 2 * (1 - c) ^ 2))) with ((c * (1 - c)) ^ 2) by (unfold c; field).
    apply pow_incr. split; [apply Rmult_le_pos; lra|]. apply (Rmult_le_reg_r (1 + c)); [lra|]. replace (c / (1 + c) * (1 + c)) with c by (field; lra).
    assert (0 <= c * (c * c)) by (apply Rmult_le_pos; [lra|apply Rmult_le_pos; lra]). lra. }
  exists y. split; [exact Y0|].
  destruct (mu_modulus (gamma f g w) x y Z ltac:(lra) Y0) as [M1 M2]. split; [exact M1|]. split; [exact M2|]. split; [|lra].
  pose proof (sinh_le y ltac:(lra)) as SL. assert (y ^ 3 <= (2 * k * a2) ^ 3) by (apply pow_incr; lra). lra.
Qed.

Lemma exp_close u v : Rabs u <= 1 -> Rabs v <= 1 -> Rabs (exp u - exp v) <= 3 * Rabs (u - v).
Proof.
  assert (H : forall a b, a <= b -> b <= 1 -> exp b - exp a <= 3 * (b - a)).
  { intros a b AB B1. destruct (MVT_le exp exp a b AB) as (c & C & E); [intros; apply is_derive_exp|]. rewrite E.
    apply Rmult_le_compat_r; [lra|]. apply Rle_trans with (exp 1); [|apply exp_le_3].
    assert (c <= 1) by lra. destruct H as [H|H]; [left; now apply exp_increasing|rewrite H; lra]. }
  assert (Mo : forall a b, a <= b -> exp a <= exp b) by (intros a b [L|L]; [left; now apply exp_increasing|rewrite L; lra]).
  intros U V. apply Rabs_le_between in U, V. destruct (Rle_lt_dec u v) as [L|L].
  - rewrite Rabs_left1, Rabs_left1 by (try lra; pose proof (Mo u v L); lra). pose proof (H u v L ltac:(lra)). lra.
  - rewrite Rabs_right, Rabs_right by (try lra; pose proof (Mo v u ltac:(lra)); lra). pose proof (H v u ltac:(lra) ltac:(lra)). lra.
Qed.
Lemma exp_times n y : exp y ^ n = exp (INR n * y).
Proof. induction n as [|n IH]; [cbn [pow INR]; now rewrite Rmult_0_l, exp_0|]. cbn [pow]. rewrite IH, S_INR, <- exp_plus. f_equal. ring. Qed.

(* veerman.thm1_x, corrected *)
Theorem exponent f g : f < 0 -> g < 0 -> let X := PI ^ 2 * Rabs g / (8 * sqrt 2 * sqrt (Rabs f)) in
  exists C M0, forall N w, M0 <= INR (S N) -> main_resonance f g N w ->
    let M := INR (S N) in
    Rabs (Cmod (mu_plus (gamma f g w)) ^ S N - exp (X / M)) <= C / M ^ 3 /\
    Rabs (Cmod (mu_minus (gamma f g w)) ^ S N - exp (- (X / M))) <= C / M ^ 3 /\
    Rabs (amplitude f g N w - M / X) <= C / M.
Proof.
  intros Hf Hg X. destruct (theorem_1 f g Hf Hg) as (C & M0 & T).
  set (beta := g ^ 2 / - f). set (k := sqrt (beta / 2)). set (L := PI ^ 2 / 8). set (C' := Rabs C * (4 * sqrt (- f) + Rabs C) / - f).
  assert (B : 0 < beta) by (apply Rdiv_lt_0_compat; [apply pow2_gt_0|]; lra). assert (K0 : 0 < k) by (unfold k; apply sqrt_lt_R0; lra).
  pose proof PI_4 as P4. pose proof PI_RGT_0 as P0. assert (L2 : 0 < L <= 2) by (unfold L; split; [assert (0 < PI ^ 2) by (apply pow_lt; lra); lra|nra]).
  assert (SF : 0 < sqrt (- f)) by (apply sqrt_lt_R0; lra). assert (SF2 : sqrt (- f) * sqrt (- f) = - f) by (apply sqrt_sqrt; lra).
  assert (R2 : 0 < sqrt 2) by (apply sqrt_lt_R0; lra). assert (R22 : sqrt 2 * sqrt 2 = 2) by (apply sqrt_sqrt; lra).
  pose proof (Rabs_pos C) as CP.
  assert (C'0 : 0 <= C') by (unfold C'; apply Rmult_le_pos; [apply Rmult_le_pos; lra|left; apply Rinv_0_lt_compat; lra]).
  (* X = k L, since k = |g|/(sqrt2 sqrt|f|) *)
  assert (XK : X = k * L).
  { assert (KE : k = - g / (sqrt 2 * sqrt (- f))).
    { apply Rsqr_inj; [lra|left; apply Rdiv_lt_0_compat; [|apply Rmult_lt_0_compat]; lra|]. unfold k. rewrite Rsqr_sqrt by lra.
      unfold beta, Rsqr. replace (- g / (sqrt 2 * sqrt (- f)) * (- g / (sqrt 2 * sqrt (- f)))) with (g ^ 2 / ((sqrt 2 * sqrt 2) * (sqrt (- f) * sqrt (- f)))) by (field; lra).
      rewrite R22, SF2. field. lra. }
    rewrite KE. unfold X, L. rewrite !Rabs_left by assumption. field. lra. }
  set (E := k * C' + 9 * k * (1 + beta) + 432 * k ^ 3).
  assert (E0 : 0 <= E).
  { unfold E. assert (0 < k ^ 3) by (apply pow_lt; lra). assert (0 <= k * C') by (apply Rmult_le_pos; lra). assert (0 <= k * (1 + beta)) by (apply Rmult_le_pos; lra). lra. }
  exists (3 * E + Rabs C), (Rmax (Rmax M0 (1 + C')) (Rmax (6 + 6 * k) (2 * k + E))). intros N w HM W M.
  assert (HM1 : M0 <= M /\ 1 + C' <= M /\ 6 + 6 * k <= M /\ 2 * k + E <= M).
  { unfold M. pose proof (Rmax_l (Rmax M0 (1 + C')) (Rmax (6 + 6 * k) (2 * k + E))). pose proof (Rmax_r (Rmax M0 (1 + C')) (Rmax (6 + 6 * k) (2 * k + E))).
    pose proof (Rmax_l M0 (1 + C')). pose proof (Rmax_r M0 (1 + C')). pose proof (Rmax_l (6 + 6 * k) (2 * k + E)). pose proof (Rmax_r (6 + 6 * k) (2 * k + E)). lra. }
  destruct HM1 as (HM0 & HMC & HM3 & HM4). destruct (T N HM0) as [_ TT]. destruct (TT w W) as [TW TA]. destruct W as [Hw _]. fold M in TW, TA.
  destruct (amplitude_factor f g M Hf Hg) as [X0 XM]. change (size_factor f g) with X in X0, XM.
  assert (M1 : 1 <= M) by lra. set (h := / M). assert (h0 : 0 < h) by (unfold h; apply Rinv_0_lt_compat; lra). assert (hM : h * M = 1) by (unfold h; field; lra).
  assert (h1 : h <= 1) by (unfold h; rewrite <- Rinv_1; apply Rinv_le_contravar; lra).
  assert (hC : C' * h <= 1) by (apply (Rmult_le_reg_r M); [lra|]; rewrite Rmult_assoc, hM; lra).
  assert (h6 : h * (6 + 6 * k) <= 1) by (rewrite <- hM; apply Rmult_le_compat_l; lra).
  assert (hE : h * (2 * k + E) <= 1) by (rewrite <- hM; apply Rmult_le_compat_l; lra).
  assert (D3 : forall c, c / M ^ 3 = c * h ^ 3) by (intros c; unfold h; field; lra). assert (D1 : forall c, c / M = c * h) by (intros c; unfold h; field; lra).
  rewrite !D3, !D1 in *. pose proof (Rle_abs C) as CA. assert (h3 : 0 < h ^ 3) by (apply pow_lt; lra). assert (h2 : 0 < h ^ 2) by (apply pow_lt; lra).
  assert (h4 : 0 < h ^ 4) by (apply pow_lt; lra).
  (* the frequency *)
  set (a2 := w ^ 2 / - f). set (w0 := veerman_numbers.frequency f M) in *.
  assert (A2 : Rabs (a2 - L * h ^ 2) <= C' * h ^ 4).
  { assert (w0E : w0 = sqrt (- f) * PI / (2 * sqrt 2) * h) by (unfold w0, veerman_numbers.frequency, h; rewrite Rabs_left by lra; field; lra).
    assert (W02 : w0 ^ 2 = - f * (L * h ^ 2)).
    { rewrite w0E. unfold L. replace ((sqrt (- f) * PI / (2 * sqrt 2) * h) ^ 2) with ((sqrt (- f) * sqrt (- f)) * PI ^ 2 / (4 * (sqrt 2 * sqrt 2)) * h ^ 2) by (field; lra).
      rewrite SF2, R22. field. }
    assert (W0U : 0 <= w0 <= 2 * sqrt (- f) * h).
    { split; [rewrite w0E; apply Rmult_le_pos; [left; apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat|]; lra|lra]|].
      apply Rsqr_incr_0_var; [|apply Rmult_le_pos; lra]. rewrite !Rsqr_pow2, W02.
      replace ((2 * sqrt (- f) * h) ^ 2) with (4 * (sqrt (- f) * sqrt (- f)) * h ^ 2) by ring. rewrite SF2.
      replace (- f * (L * h ^ 2)) with (L * (- f * h ^ 2)) by ring. replace (4 * - f * h ^ 2) with (4 * (- f * h ^ 2)) by ring.
      apply Rmult_le_compat_r; [apply Rmult_le_pos; lra|lra]. }
    assert (Dw : Rabs (w - w0) <= Rabs C * h ^ 3) by (eapply Rle_trans; [exact TW|]; apply Rmult_le_compat_r; lra).
    assert (h31 : h ^ 3 <= h) by (replace (h ^ 3) with (h * (h * h)) by ring; assert (h * h <= 1 * 1) by (apply Rmult_le_compat; lra); assert (h * (h * h) <= h * 1) by (apply Rmult_le_compat_l; lra); lra).
    assert (Sw : Rabs (w + w0) <= (4 * sqrt (- f) + Rabs C) * h).
    { replace (w + w0) with ((w - w0) + 2 * w0) by ring. eapply Rle_trans; [apply Rabs_triang|]. rewrite (Rabs_right (2 * w0)) by lra.
      assert (Rabs C * h ^ 3 <= Rabs C * h) by (apply Rmult_le_compat_l; lra). lra. }
    replace (a2 - L * h ^ 2) with ((w - w0) * (w + w0) / - f) by (unfold a2; replace (L * h ^ 2) with (w0 ^ 2 / - f) by (rewrite W02; field; lra); field; lra).
    unfold Rdiv. rewrite !Rabs_mult, (Rabs_right (/ - f)) by (left; apply Rinv_0_lt_compat; lra).
    replace (C' * h ^ 4) with (Rabs C * h ^ 3 * ((4 * sqrt (- f) + Rabs C) * h) * / - f) by (unfold C'; field; lra).
    apply Rmult_le_compat_r; [left; apply Rinv_0_lt_compat; lra|]. apply Rmult_le_compat; try apply Rabs_pos; assumption. }
  apply Rabs_le_between in A2.
  assert (CH : C' * h ^ 4 <= h ^ 2).
  { replace (C' * h ^ 4) with (h ^ 2 * (C' * h * h)) by ring. rewrite <- (Rmult_1_r (h ^ 2)) at 2. apply Rmult_le_compat_l; [lra|].
    assert (C' * h * h <= 1 * 1) by (apply Rmult_le_compat; try lra; apply Rmult_le_pos; lra). lra. }
  assert (LH : L * h ^ 2 <= 2 * h ^ 2) by (apply Rmult_le_compat_r; lra).
  assert (A3 : 0 < a2 <= 3 * h ^ 2) by (split; [unfold a2; apply Rdiv_lt_0_compat; [apply pow_lt|]; lra|lra]).
  assert (hh : h ^ 2 <= / 6 * h) by (replace (h ^ 2) with (h * h) by ring; apply Rmult_le_compat_r; [lra|]; assert (0 < h * k) by (apply Rmult_lt_0_compat; lra); lra).
  assert (KH : k * h <= / 6) by lra.
  assert (KA : k * a2 <= / 2 * h).
  { apply Rle_trans with (k * (3 * h ^ 2)); [apply Rmult_le_compat_l; lra|]. replace (k * (3 * h ^ 2)) with (3 * h * (k * h)) by ring.
    assert (3 * h * (k * h) <= 3 * h * / 6) by (apply Rmult_le_compat_l; lra). lra. }
  destruct (exponent_bounds f g w Hf Hg Hw) as (y & Y0 & Mp & Mm & YL & YU); fold beta k a2; [lra|lra|]. fold beta k a2 in YL, YU.
  rewrite Mp, Mm, !exp_times. fold M.
  assert (My : Rabs (M * y - X * h) <= E * h ^ 3).
  { assert (XH : X * h = M * (k * (L * h ^ 2))) by (rewrite XK; replace (M * (k * (L * h ^ 2))) with (k * L * h * (h * M)) by ring; rewrite hM; ring).
    rewrite XH, <- Rmult_minus_distr_l, Rabs_mult, (Rabs_right M) by lra.
    replace (E * h ^ 3) with (M * (E * h ^ 4)) by (replace (M * (E * h ^ 4)) with (E * h ^ 3 * (h * M)) by ring; rewrite hM; ring).
    apply Rmult_le_compat_l; [lra|].
    assert (Q1 : a2 * a2 <= 9 * h ^ 4) by (replace (9 * h ^ 4) with ((3 * h ^ 2) * (3 * h ^ 2)) by ring; apply Rmult_le_compat; lra).
    assert (Q2 : k * (a2 * a2) <= k * (9 * h ^ 4)) by (apply Rmult_le_compat_l; lra).
    assert (Q3 : k * beta * (a2 * a2) <= k * beta * (9 * h ^ 4)) by (apply Rmult_le_compat_l; [apply Rmult_le_pos|]; lra).
    assert (Q4 : (2 * k * a2) ^ 3 <= 216 * k ^ 3 * h ^ 4).
    { replace (216 * k ^ 3 * h ^ 4) with ((2 * k) ^ 3 * (27 * h ^ 4)) by ring. rewrite Rpow_mult_distr. apply Rmult_le_compat_l; [apply pow_le; lra|].
      apply Rle_trans with ((3 * h ^ 2) ^ 3); [apply pow_incr; lra|]. replace ((3 * h ^ 2) ^ 3) with (27 * h ^ 4 * (h * h)) by ring.
      assert (h * h <= 1 * 1) by (apply Rmult_le_compat; lra). assert (27 * h ^ 4 * (h * h) <= 27 * h ^ 4 * 1) by (apply Rmult_le_compat_l; lra). lra. }
    assert (Q5 : k * (a2 - L * h ^ 2) <= k * (C' * h ^ 4)) by (apply Rmult_le_compat_l; lra).
    assert (Q6 : k * (- (C' * h ^ 4)) <= k * (a2 - L * h ^ 2)) by (apply Rmult_le_compat_l; lra).
    assert (Q7 : 0 <= k * beta * (9 * h ^ 4)) by (apply Rmult_le_pos; [apply Rmult_le_pos|]; lra). assert (Q8 : 0 <= k * (9 * h ^ 4)) by (apply Rmult_le_pos; lra).
    assert (Q9 : 0 <= k ^ 3 * h ^ 4) by (apply Rmult_le_pos; [apply pow_le|]; lra).
    unfold E. apply Rabs_le. lra. }
  assert (XH1 : 0 <= X * h <= / 2 * 1).
  { split; [apply Rmult_le_pos; lra|]. rewrite XK. assert (k * L * h <= k * 2 * h) by (apply Rmult_le_compat_r; [lra|]; apply Rmult_le_compat_l; lra). lra. }
  assert (MyU : 0 <= M * y <= 1).
  { split; [apply Rmult_le_pos; lra|]. assert (a2 <= 1) by lra.
    assert (y <= h). { assert (k * a2 * (1 + a2) <= / 2 * h * 2) by (apply Rmult_le_compat; try lra; apply Rmult_le_pos; lra). lra. }
    apply Rle_trans with (M * h); [apply Rmult_le_compat_l; lra|lra]. }
  pose proof (exp_close (M * y) (X * h) ltac:(rewrite Rabs_right; lra) ltac:(rewrite Rabs_right; lra)) as EC1.
  pose proof (exp_close (- (M * y)) (- (X * h)) ltac:(rewrite Rabs_Ropp, Rabs_right; lra) ltac:(rewrite Rabs_Ropp, Rabs_right; lra)) as EC2.
  replace (- (M * y) - - (X * h)) with (- (M * y - X * h)) in EC2 by ring. rewrite Rabs_Ropp in EC2.
  assert (CH3 : 0 <= Rabs C * h ^ 3) by (apply Rmult_le_pos; lra).
  replace (M * - y) with (- (M * y)) by ring. split; [lra|]. split; [lra|].
  replace (M / X) with (veerman_numbers.amplitude f g M) by (apply (Rmult_eq_reg_l X); [rewrite XM; field; lra|lra]).
  assert (C * h <= Rabs C * h) by (apply Rmult_le_compat_r; lra). assert (0 <= E * h) by (apply Rmult_le_pos; lra). lra.
Qed.
(* as printed, with |f|, it contradicts Theorem 1 at f = -4, g = -1: the printed x is half of the true one *)
Theorem exponent_printed_fails : ~ (forall f g, f < 0 -> g < 0 -> let x := PI ^ 2 * Rabs g / (8 * sqrt 2 * Rabs f) in
  exists C M0, forall N w, M0 <= INR (S N) -> main_resonance f g N w -> Rabs (amplitude f g N w - INR (S N) / x) <= C / INR (S N)).
Proof.
  intros H. destruct (H (-4) (-1) ltac:(lra) ltac:(lra)) as (C & M0 & P). clear H.
  destruct (exponent (-4) (-1) ltac:(lra) ltac:(lra)) as (C' & M0' & T). destruct (theorem_1 (-4) (-1) ltac:(lra) ltac:(lra)) as (C'' & M0'' & E).
  assert (S4 : sqrt (Rabs (-4)) = 2) by (rewrite Rabs_left by lra; replace (- -4) with (2 * 2) by ring; apply sqrt_square; lra).
  rewrite S4 in T. set (X := PI ^ 2 * Rabs (-1) / (8 * sqrt 2 * 2)) in *.
  assert (XP : 0 < X).
  { unfold X. rewrite Rabs_left by lra. pose proof PI_RGT_0. assert (0 < sqrt 2) by (apply sqrt_lt_R0; lra).
    apply Rdiv_lt_0_compat; [assert (0 < PI ^ 2) by (apply pow_lt; lra); lra|lra]. }
  set (big := Rabs M0 + Rabs M0' + Rabs M0'' + X * (Rabs C + Rabs C') + 1).
  pose proof (Rle_abs M0). pose proof (Rle_abs M0'). pose proof (Rle_abs M0''). pose proof (Rabs_pos M0). pose proof (Rabs_pos M0'). pose proof (Rabs_pos M0'').
  pose proof (Rabs_pos C). pose proof (Rabs_pos C'). pose proof (Rle_abs C). pose proof (Rle_abs C').
  assert (XC : 0 <= X * (Rabs C + Rabs C')) by (apply Rmult_le_pos; lra).
  destruct (nfloor_ex big) as [N [_ HN]]; [unfold big; lra|]. rewrite <- S_INR in HN. unfold big in HN.
  destruct (E N ltac:(lra)) as [(w & W) _]. specialize (P N w ltac:(lra) W). destruct (T N w ltac:(lra) W) as (_ & _ & Q).
  set (M := INR (S N)) in *. set (A := amplitude (-4) (-1) N w) in *.
  assert (R2 : 0 < sqrt 2) by (apply sqrt_lt_R0; lra).
  replace (M / (PI ^ 2 * Rabs (-1) / (8 * sqrt 2 * Rabs (-4)))) with (2 * (M / X)) in P.
  2: { unfold X. rewrite !Rabs_left by lra. pose proof PI_RGT_0. field. lra. }
  apply Rabs_le_between in P, Q.
  assert (MX : M / X <= (Rabs C + Rabs C') / M).
  { assert (C / M <= Rabs C / M) by (apply Rmult_le_compat_r; [left; apply Rinv_0_lt_compat|]; lra).
    assert (C' / M <= Rabs C' / M) by (apply Rmult_le_compat_r; [left; apply Rinv_0_lt_compat|]; lra).
    replace ((Rabs C + Rabs C') / M) with (Rabs C / M + Rabs C' / M) by (field; lra). lra. }
  apply (Rmult_le_compat_r (M * X)) in MX; [|apply Rmult_le_pos; lra].
  replace (M / X * (M * X)) with (M * M) in MX by (field; lra). replace ((Rabs C + Rabs C') / M * (M * X)) with (X * (Rabs C + Rabs C')) in MX by (field; lra).
  assert (1 * M <= M * M) by (apply Rmult_le_compat_r; lra). lra.
Qed.

Lemma exp_second u : Rabs u <= 1 -> Rabs (exp u - (1 + u)) <= 3 * u ^ 2.
Proof.
  intros U. assert (M : exists c, Rabs c <= Rabs u /\ exp u - 1 = exp c * u).
  { apply Rabs_le_between in U. destruct (Rle_lt_dec 0 u) as [L|L].
    - destruct (MVT_le exp exp 0 u L) as (c & P & E); [intros; apply is_derive_exp|]. rewrite exp_0, Rminus_0_r in E.
      exists c. split; [rewrite !Rabs_right; lra|exact E].
    - destruct (MVT_le exp exp u 0 ltac:(lra)) as (c & P & E); [intros; apply is_derive_exp|]. rewrite exp_0 in E.
      exists c. split; [rewrite !Rabs_left1; lra|lra]. }
  destruct M as (c & P & E). pose proof (exp_close c 0 ltac:(lra) ltac:(rewrite Rabs_R0; lra)) as C. rewrite exp_0, Rminus_0_r in C.
  replace (exp u - (1 + u)) with ((exp c - 1) * u) by lra. rewrite Rabs_mult. replace (3 * u ^ 2) with (3 * Rabs u * Rabs u).
  - apply Rmult_le_compat_r; [apply Rabs_pos|]. lra.
  - rewrite Rmult_assoc, <- Rabs_mult, Rabs_right; [ring|]. pose proof (pow2_ge_0 u). lra.
Qed.
(* veerman.thm1_mod: |mu_+-|^2 = 1 +- sqrt2 w^2 |g|/|f|^(3/2) + O(w^4) *)
Theorem moduli f g : f < 0 -> g < 0 -> exists C small, 0 < small /\ forall w, 0 < w <= small ->
  let u := sqrt 2 * w ^ 2 * Rabs g / (Rabs f * sqrt (Rabs f)) in
  Rabs (Cmod (mu_plus (gamma f g w)) ^ 2 - (1 + u)) <= C * w ^ 4 /\ Rabs (Cmod (mu_minus (gamma f g w)) ^ 2 - (1 - u)) <= C * w ^ 4.
Proof.
  intros Hf Hg. set (beta := g ^ 2 / - f). set (k := sqrt (beta / 2)).
  assert (B : 0 < beta) by (apply Rdiv_lt_0_compat; [apply pow2_gt_0|]; lra). assert (K0 : 0 < k) by (unfold k; apply sqrt_lt_R0; lra).
  assert (SF : 0 < sqrt (- f)) by (apply sqrt_lt_R0; lra). assert (SF2 : sqrt (- f) * sqrt (- f) = - f) by (apply sqrt_sqrt; lra).
  assert (R2 : 0 < sqrt 2) by (apply sqrt_lt_R0; lra). assert (R22 : sqrt 2 * sqrt 2 = 2) by (apply sqrt_sqrt; lra).
  assert (KE : k = - g / (sqrt 2 * sqrt (- f))).
  { apply Rsqr_inj; [lra|left; apply Rdiv_lt_0_compat; [|apply Rmult_lt_0_compat]; lra|]. unfold k. rewrite Rsqr_sqrt by lra.
    unfold beta, Rsqr. replace (- g / (sqrt 2 * sqrt (- f)) * (- g / (sqrt 2 * sqrt (- f)))) with (g ^ 2 / ((sqrt 2 * sqrt 2) * (sqrt (- f) * sqrt (- f)))) by (field; lra).
    rewrite R22, SF2. field. lra. }
  set (E := k * (1 + beta) + 16 * k ^ 3). assert (k3 : 0 < k ^ 3) by (apply pow_lt; lra). assert (kb : 0 < k * (1 + beta)) by (apply Rmult_lt_0_compat; lra).
  set (room := / (2 + 8 * k)). assert (r0 : 0 < room) by (apply Rinv_0_lt_compat; lra).
  exists ((2 * E + 48 * k ^ 2) / f ^ 2), (sqrt (- f * room)). assert (fr : 0 < - f * room) by (apply Rmult_lt_0_compat; lra).
  split; [now apply sqrt_lt_R0|]. intros w [Hw Ws] u. set (a2 := w ^ 2 / - f).
  assert (A : 0 < a2) by (unfold a2; apply Rdiv_lt_0_compat; [apply pow_lt|]; lra).
  assert (AR : a2 <= room).
  { unfold a2. apply (Rmult_le_reg_r (- f)); [lra|]. replace (w ^ 2 / - f * - f) with (w ^ 2) by (field; lra).
    apply Rle_trans with (sqrt (- f * room) ^ 2); [apply pow_incr; lra|]. rewrite pow2_sqrt by lra. lra. }
  assert (AQ : a2 * (2 + 8 * k) <= 1) by (rewrite <- (Rinv_l (2 + 8 * k)) by lra; apply Rmult_le_compat_r; [lra|exact AR]).
  assert (KA : 0 < k * a2) by (apply Rmult_lt_0_compat; lra).
  destruct (exponent_bounds f g w Hf Hg Hw) as (y & Y0 & Mp & Mm & YL & YU); fold beta k a2; [lra|lra|]. fold beta k a2 in YL, YU.
  assert (UE : u = 2 * (k * a2)).
  { unfold u, a2. rewrite KE, !Rabs_left by assumption. replace 2 with (sqrt 2 * sqrt 2) at 2 by exact R22. field. lra. }
  assert (A2 : 0 < a2 ^ 2) by now apply pow_lt.
  assert (D : Rabs (2 * y - u) <= 2 * E * a2 ^ 2).
  { rewrite UE. assert (0 < k * beta * a2 ^ 2) by (apply Rmult_lt_0_compat; [apply Rmult_lt_0_compat|]; lra). assert (0 < k * a2 ^ 2) by (apply Rmult_lt_0_compat; lra).
    assert (k ^ 3 * (a2 ^ 2 * a2) <= k ^ 3 * (a2 ^ 2 * 1)) by (apply Rmult_le_compat_l; [lra|]; apply Rmult_le_compat_l; lra).
    assert (0 < k ^ 3 * a2 ^ 2) by (apply Rmult_lt_0_compat; lra). unfold E. apply Rabs_le. lra. }
  assert (YB : y <= 2 * (k * a2)) by (assert (k * a2 * (1 + a2) <= k * a2 * 2) by (apply Rmult_le_compat_l; lra); lra).
  assert (S2 : (2 * y) ^ 2 <= 16 * k ^ 2 * a2 ^ 2).
  { replace (16 * k ^ 2 * a2 ^ 2) with ((2 * (2 * (k * a2))) ^ 2) by ring. apply pow_incr. lra. }
  assert (CE : (2 * E + 48 * k ^ 2) / f ^ 2 * w ^ 4 = 2 * E * a2 ^ 2 + 48 * k ^ 2 * a2 ^ 2) by (unfold a2; field; lra).
  rewrite CE, Mp, Mm, !exp_times. cbn [INR]. replace ((1 + 1) * y) with (2 * y) by ring. replace ((1 + 1) * - y) with (- (2 * y)) by ring.
  split.
  - pose proof (exp_second (2 * y) ltac:(rewrite Rabs_right; lra)) as X. replace (exp (2 * y) - (1 + u)) with ((exp (2 * y) - (1 + 2 * y)) + (2 * y - u)) by ring.
    eapply Rle_trans; [apply Rabs_triang|]. lra.
  - pose proof (exp_second (- (2 * y)) ltac:(rewrite Rabs_Ropp, Rabs_right; lra)) as X.
    replace (exp (- (2 * y)) - (1 - u)) with ((exp (- (2 * y)) - (1 + - (2 * y))) + - (2 * y - u)) by ring.
    eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_Ropp. replace ((- (2 * y)) ^ 2) with ((2 * y) ^ 2) in X by ring. lra.
Qed.
