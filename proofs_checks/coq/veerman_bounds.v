(* Veerman, Stosic, Olvera, Theorem 1: bounds of |a_M|^-2 = cos^2(M x) + sinh^2(M y) for every number M = N + 1 of followers.
   In a^2 = w^2/|f|, c = b^2 a^2 with b^2 = g^2/|f|, and lambda = 1 - cos(pi/(2M)): nothing is asymptotic here.
   Below a^2 = lambda the cosine keeps |a_M| small, above it the sinh; at a^2 = lambda both are small. *)
From Coq Require Import Reals Lra Lia Psatz.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums veerman_complex veerman_front veerman_chain veerman_stability veerman_amplitude.
From Flockproof Require Import veerman_settling veerman_rates veerman_coordinates.
Open Scope R_scope.

Lemma sin_concave t u : 0 <= t <= 1 -> 0 <= u <= PI -> t * sin u <= sin (t * u).
Proof.
  intros T U. assert (B : 0 <= t * u <= u) by nra.
  destruct (MVT_le sin cos 0 (t * u)) as (p & P & Ep); [lra|intros; apply is_derive_sin|].
  destruct (MVT_le sin cos (t * u) u) as (q & Q & Eq); [lra|intros; apply is_derive_sin|]. rewrite sin_0 in Ep.
  assert (C : cos q <= cos p) by (apply cos_decr_1; lra).
  assert (t * (u * (1 - t)) * cos q <= t * (u * (1 - t)) * cos p).
  { apply Rmult_le_compat_l; [|exact C]. apply Rmult_le_pos; [lra|]. apply Rmult_le_pos; lra. }
  assert (E1 : sin (t * u) = cos p * (t * u)) by lra. assert (E2 : sin u = sin (t * u) + cos q * (u - t * u)) by lra.
  rewrite E2. replace (t * (sin (t * u) + cos q * (u - t * u))) with (t * sin (t * u) + t * (u * (1 - t)) * cos q) by ring.
  replace (t * (u * (1 - t)) * cos p) with ((1 - t) * (cos p * (t * u))) in H by ring. rewrite <- E1 in H. lra.
Qed.
Lemma D_sinh y : is_derive sinh y (cosh y).
Proof. apply is_derive_Reals, derivable_pt_lim_sinh. Qed.
Lemma D_cosh y : is_derive cosh y (sinh y).
Proof. apply is_derive_Reals, derivable_pt_lim_cosh. Qed.
Lemma sinh_ge y : 0 <= y -> y <= sinh y.
Proof.
  intros Y. destruct (MVT_le sinh cosh 0 y Y) as (p & _ & E); [intros; apply D_sinh|]. rewrite sinh_0 in E.
  pose proof (cosh_ge1 p). assert (1 * y <= cosh p * y) by (apply Rmult_le_compat_r; lra). lra.
Qed.
Lemma sinh_mono x y : x <= y -> sinh x <= sinh y.
Proof. intros [L|E]; [left; now apply sinh_lt|rewrite E; lra]. Qed.
Lemma cosh_mono x y : 0 <= x <= y -> cosh x <= cosh y.
Proof.
  intros B. destruct (MVT_le cosh sinh x y ltac:(lra)) as (p & P & E); [intros; apply D_cosh|].
  pose proof (sinh_ge p ltac:(lra)). assert (0 <= sinh p * (y - x)) by (apply Rmult_le_pos; lra). lra.
Qed.
Lemma sinh_le v : 0 <= v <= 1 -> sinh v <= v * (1 + 2 * v ^ 2).
Proof.
  intros V. assert (C2 : cosh v <= 2).
  { apply Rle_trans with (cosh 1); [now apply cosh_mono|]. unfold cosh. pose proof exp_le_3.
    assert (exp (- (1)) <= exp 0) by (left; apply exp_increasing; lra). rewrite exp_0 in *. lra. }
  destruct (MVT_le sinh cosh 0 v ltac:(lra)) as (p & P & E); [intros; apply D_sinh|]. rewrite sinh_0 in E.
  pose proof (cosh_mono p v ltac:(lra)) as M. assert (S1 : sinh v <= v * cosh v) by (assert (cosh p * (v - 0) <= cosh v * (v - 0)) by (apply Rmult_le_compat_r; lra); lra).
  destruct (MVT_le cosh sinh 0 v ltac:(lra)) as (q & Q & E2); [intros; apply D_cosh|]. rewrite cosh_0 in E2.
  pose proof (sinh_mono q v ltac:(lra)) as M2. assert (S2 : cosh v <= 1 + v * sinh v) by (assert (sinh q * (v - 0) <= sinh v * (v - 0)) by (apply Rmult_le_compat_r; lra); lra).
  assert (v * sinh v <= v * (v * 2)). { apply Rmult_le_compat_l; [lra|]. assert (v * cosh v <= v * 2) by (apply Rmult_le_compat_l; lra). lra. }
  assert (v * cosh v <= v * (1 + 2 * v ^ 2)) by (apply Rmult_le_compat_l; lra). lra.
Qed.

Section OneFrequency.
Variables (f g w : R).
Hypotheses (Hf : f < 0) (Hg : g < 0) (Hw : 0 < w).
Let beta := g ^ 2 / - f.
Let a2 := w ^ 2 / - f.
Let c := beta * a2.
Lemma positives : 0 < beta /\ 0 < a2 /\ 0 < c.
Proof using Hf Hg Hw.
  assert (0 < beta) by (apply Rdiv_lt_0_compat; [apply pow2_gt_0|]; lra). assert (0 < a2) by (apply Rdiv_lt_0_compat; [apply pow_lt|]; lra).
  split; [assumption|]. split; [assumption|]. now apply Rmult_lt_0_compat.
Qed.
Lemma gamma_parts : fst (gamma f g w) = 1 - a2 / (1 + c) /\ snd (gamma f g w) ^ 2 = a2 ^ 2 * c / (1 + c) ^ 2 /\ 0 <= snd (gamma f g w).
Proof using Hf Hg Hw.
  destruct positives as (B & A & C). assert (Q : 0 < f ^ 2 + (w * g) ^ 2).
  { assert (0 < f ^ 2) by (apply pow2_gt_0; lra). pose proof (pow2_ge_0 (w * g)). lra. }
  assert (Q1 : 1 + c = (f ^ 2 + (w * g) ^ 2) / f ^ 2) by (unfold c, beta, a2; field; lra).
  split; [|split].
  - rewrite Q1. unfold a2, gamma, num, den, Cdiv, Cinv, Cmult; cbn [fst snd]. field. split; [lra|nra].
  - rewrite gamma_imaginary by assumption. rewrite Q1. unfold c, beta, a2. field. split; [lra|nra].
  - rewrite gamma_imaginary by assumption. apply Rmult_le_pos; [|left; now apply Rinv_0_lt_compat].
    apply Rmult_le_pos; [lra|]. apply pow_le. lra.
Qed.

(* S = sinh^2 y, s = sin^2 x *)
Lemma frequency_coordinates : exists x y, 0 <= x <= PI /\ 0 <= y /\
  (forall N, amplitude f g N w ^ 2 * (cos (INR (S N) * x) ^ 2 + sinh (INR (S N) * y) ^ 2) = 1) /\
  sin x ^ 2 * sinh y ^ 2 = a2 ^ 2 * c / (1 + c) ^ 2 /\
  0 <= cosh y - cos x <= a2 /\ (cosh y - cos x) ^ 2 = a2 ^ 2 / (1 + c) /\
  (cosh y + cos x) ^ 2 = 4 - 4 * (a2 / (1 + c)) + a2 ^ 2 / (1 + c) /\
  gamma f g w = (cos x * cosh y, sin x * sinh y).
Proof using Hf Hg Hw.
  destruct positives as (B & A & C). destruct gamma_parts as (G1 & G2 & G3).
  destruct (coordinates_exist (gamma f g w) G3) as (x & y & X & Y & Z & R & P). exists x, y. split; [exact X|]. split; [exact Y|].
  pose proof (Cmod_ge_0 (1 - gamma f g w)%C) as R0. pose proof (Cmod_sqr (1 - gamma f g w)%C) as R2. pose proof (Cmod_sqr (1 + gamma f g w)%C) as P2.
  cbn [fst snd Cminus Cplus Copp RtoC] in R2, P2. rewrite G1 in R2, P2.
  replace ((0 + - snd (gamma f g w)) ^ 2) with (snd (gamma f g w) ^ 2) in R2 by ring. rewrite Rplus_0_l, G2 in P2. rewrite G2 in R2.
  assert (RR : (cosh y - cos x) ^ 2 = a2 ^ 2 / (1 + c)) by (rewrite R, R2; field; lra).
  split; [|split; [|split; [split; [rewrite R; exact R0|]|split; [exact RR|split; [rewrite P, P2; field; lra|exact Z]]]]].
  - intros N. pose proof (cheb_neq0 f g w (S N) Hf Hg) as NZ. unfold amplitude. rewrite Cmod_inv by exact NZ.
    assert (M : Cmod (chebT (gamma f g w) (S N)) ^ 2 = cos (INR (S N) * x) ^ 2 + sinh (INR (S N) * y) ^ 2).
    { rewrite Z, cheb_coordinates, Cmod_sqr. cbn [fst snd]. set (mx := INR (S N) * x). set (my := INR (S N) * y).
      rewrite !Rpow_mult_distr, sin_sqr, cosh_sqr. ring. }
    rewrite <- M. apply Cmod_gt_0 in NZ. field. lra.
  - rewrite <- G2, Z. cbn [snd]. ring.
  - apply Rsqr_incr_0_var; [|lra]. rewrite !Rsqr_pow2, RR. apply (Rmult_le_reg_r (1 + c)); [lra|].
    replace (a2 ^ 2 / (1 + c) * (1 + c)) with (a2 ^ 2) by (field; lra). pose proof (pow2_ge_0 a2). assert (0 <= a2 ^ 2 * c) by (apply Rmult_le_pos; lra). lra.
Qed.

(* from the coordinates: lower bounds of sinh^2 y *)
Section Coordinates.
Variables (x y : R).
Hypotheses (Im : sin x ^ 2 * sinh y ^ 2 = a2 ^ 2 * c / (1 + c) ^ 2) (R1 : 0 <= cosh y - cos x <= a2)
  (R2 : (cosh y - cos x) ^ 2 = a2 ^ 2 / (1 + c)) (P2 : (cosh y + cos x) ^ 2 = 4 - 4 * (a2 / (1 + c)) + a2 ^ 2 / (1 + c)).
Let u := c / (1 + c).
Lemma both : sin x ^ 2 + sinh y ^ 2 = (cosh y - cos x) * (cosh y + cos x).
Proof using. rewrite sin_sqr. pose proof (cosh_sqr y). lra. Qed.
Lemma plus_ge0 : 0 <= cosh y + cos x.
Proof using. pose proof (cosh_ge1 y). pose proof (COS_bound x). lra. Qed.
Lemma sinh_moderate : a2 <= 4 -> u ^ 2 <= 2 * beta * sinh y ^ 2.
Proof using Hf Hg Hw Im R1 P2.
  intros A4. destruct positives as (B & A & C). pose proof both as RP. pose proof plus_ge0 as P0.
  assert (P : cosh y + cos x <= 2).
  { apply Rsqr_incr_0_var; [|lra]. rewrite !Rsqr_pow2, P2.
    assert (0 <= a2 * (4 - a2) / (1 + c)) by (apply Rmult_le_pos; [apply Rmult_le_pos; lra|left; apply Rinv_0_lt_compat; lra]).
    replace (4 - 4 * (a2 / (1 + c)) + a2 ^ 2 / (1 + c)) with (4 - a2 * (4 - a2) / (1 + c)) by (field; lra). lra. }
  set (S := sinh y ^ 2) in *. pose proof (pow2_ge_0 (sinh y)) as S0. fold S in S0. pose proof (pow2_ge_0 (sin x)) as X0.
  assert (L : a2 ^ 2 * c / (1 + c) ^ 2 <= 2 * a2 * S).
  { rewrite <- Im. apply Rmult_le_compat_r; [exact S0|].
    assert ((cosh y - cos x) * (cosh y + cos x) <= a2 * 2) by (apply Rmult_le_compat; lra). lra. }
  apply (Rmult_le_reg_r a2); [exact A|].
  replace (u ^ 2 * a2) with (beta * (a2 ^ 2 * c / (1 + c) ^ 2)) by (unfold u, c; field; fold c; lra).
  replace (2 * beta * S * a2) with (beta * (2 * a2 * S)) by ring. apply Rmult_le_compat_l; lra.
Qed.
Lemma sinh_large : 4 <= a2 -> u <= (3 + beta) * sinh y ^ 2.
Proof using Hf Hg Hw Im R1 R2 P2.
  intros A4. destruct positives as (B & A & C). pose proof both as RP. pose proof plus_ge0 as P0.
  set (S := sinh y ^ 2) in *. pose proof (pow2_ge_0 (sinh y)) as S0. fold S in S0. set (r := cosh y - cos x) in *.
  assert (A0 : 0 < a2 / (1 + c)) by (apply Rdiv_lt_0_compat; lra).
  assert (P : cosh y + cos x <= 2 + r).
  { apply Rsqr_incr_0_var; [|lra]. rewrite !Rsqr_pow2, P2. replace ((2 + r) ^ 2) with (4 + 4 * r + r ^ 2) by ring. rewrite R2. lra. }
  assert (L : a2 ^ 2 * c / (1 + c) ^ 2 <= (1 + 2 * (a2 ^ 2 / (1 + c))) * S).
  { rewrite <- Im. apply Rmult_le_compat_r; [exact S0|].
    assert (r * (cosh y + cos x) <= r * (2 + r)) by (apply Rmult_le_compat_l; lra).
    assert (r * (2 + r) <= 1 + 2 * r ^ 2) by (pose proof (pow2_ge_0 (r - 1)); lra). rewrite R2 in *. lra. }
  assert (K : 1 + c <= (1 + beta) * a2 ^ 2).
  { unfold c. assert (1 <= a2) by lra. assert (a2 * 1 <= a2 * a2) by (apply Rmult_le_compat_l; lra).
    assert (beta * a2 <= beta * (a2 * a2)) by (apply Rmult_le_compat_l; lra). lra. }
  apply (Rmult_le_compat_r ((1 + c) / a2 ^ 2)) in L; [|apply Rmult_le_pos; [lra|left; apply Rinv_0_lt_compat, pow_lt; lra]].
  replace (a2 ^ 2 * c / (1 + c) ^ 2 * ((1 + c) / a2 ^ 2)) with u in L by (unfold u; field; lra).
  replace ((1 + 2 * (a2 ^ 2 / (1 + c))) * S * ((1 + c) / a2 ^ 2)) with (((1 + c) / a2 ^ 2 + 2) * S) in L by (field; lra).
  assert (Q : (1 + c) / a2 ^ 2 <= 1 + beta).
  { apply (Rmult_le_reg_r (a2 ^ 2)); [apply pow_lt; lra|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by (apply pow_nonzero; lra). lra. }
  assert (((1 + c) / a2 ^ 2 + 2) * S <= (3 + beta) * S) by (apply Rmult_le_compat_r; lra). lra.
Qed.
(* an upper bound *)
Lemma sinh_upper : a2 <= 1 -> (2 - a2) * sinh y ^ 2 <= beta * a2 ^ 2.
Proof using Hf Hg Hw Im R1 R2 P2.
  intros A1. destruct positives as (B & A & C). pose proof (sin_sqr x) as X. pose proof (cosh_sqr y) as Y.
  set (S := sinh y ^ 2) in *. pose proof (pow2_ge_0 (sinh y)) as S0. fold S in S0.
  assert (U : 4 * (cos x * cosh y) = 4 - 4 * (a2 / (1 + c))) by (transitivity ((cosh y + cos x) ^ 2 - (cosh y - cos x) ^ 2); [ring|rewrite P2, R2; ring]).
  assert (W : cos x ^ 2 * cosh y ^ 2 = (1 - a2 / (1 + c)) ^ 2) by (transitivity ((cos x * cosh y) ^ 2); [ring|f_equal; lra]).
  assert (X1 : a2 * (2 - a2) / (1 + c) <= sin x ^ 2).
  { assert (E : sin x ^ 2 = S + 1 - cos x ^ 2 * cosh y ^ 2 - sin x ^ 2 * S) by (rewrite Y, X; ring).
    rewrite E, W, Im. replace (S + 1 - (1 - a2 / (1 + c)) ^ 2 - a2 ^ 2 * c / (1 + c) ^ 2) with (S + a2 * (2 - a2) / (1 + c)) by (field; lra). lra. }
  assert (L : a2 * (2 - a2) / (1 + c) * S <= a2 ^ 2 * c / (1 + c) ^ 2) by (rewrite <- Im; apply Rmult_le_compat_r; assumption).
  apply (Rmult_le_compat_r ((1 + c) / a2)) in L; [|left; apply Rdiv_lt_0_compat; lra].
  replace (a2 * (2 - a2) / (1 + c) * S * ((1 + c) / a2)) with ((2 - a2) * S) in L by (field; lra).
  replace (a2 ^ 2 * c / (1 + c) ^ 2 * ((1 + c) / a2)) with (beta * a2 ^ 2 / (1 + c)) in L by (unfold c; field; fold c; lra).
  assert (beta * a2 ^ 2 / (1 + c) <= beta * a2 ^ 2); [|lra]. apply (Rmult_le_reg_r (1 + c)); [lra|].
  replace (beta * a2 ^ 2 / (1 + c) * (1 + c)) with (beta * a2 ^ 2) by (field; lra).
  assert (0 <= beta * a2 ^ 2 * c) by (apply Rmult_le_pos; [apply Rmult_le_pos; [lra|apply pow2_ge_0]|lra]). lra.
Qed.
End Coordinates.
End OneFrequency.
