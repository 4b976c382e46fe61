(* Veerman, Stosic, Olvera, Theorem 1 and Proposition 2: how large the main resonance of system (2) is at least.
     veerman.prop2, veerman.thm1_amp.
   M = N + 1 followers.  There is a frequency w > 0 at which mu = rho e^(i phi) with phi = pi/(2 M) (intermediate value), so that
   |a_M| = 2/(rho^M - rho^-M).  With rho = C + S, C^2 - S^2 = 1, S = Im gamma/sin phi and delta = M S this is at least 1/delta - 1,
   and delta <= X/M (1 + O(M^-2)) with X = pi^2 |g|/(8 sqrt 2 sqrt|f|). *)
From Coq Require Import Reals Lra Lia Psatz.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import veerman_complex veerman_front veerman_chain.
Open Scope R_scope.

(* |a_(N+1)| at the frequency w of the leader: `response_solution` *)
Definition response (f g : R) (N : nat) (w : R) : R := Cmod (2 / trace2 (mat2_pow (Cmat (gamma f g w)) (S N)))%C.
Theorem response_solution f g w N a : f < 0 -> g < 0 -> a 0%nat = RtoC 1 -> equation_2 f g w N a ->
  Cmod (a (S N)) = response f g N w.
Proof. intros Hf Hg A E. unfold response. now rewrite (proj1 (lemma_2 f g w N a Hf Hg A E)). Qed.

Lemma trace_mu (gam mu : C) (n : nat) : mu <> 0%C -> (mu + / mu = 2 * gam)%C -> trace2 (mat2_pow (Cmat gam) n) = (Cpw mu n + / Cpw mu n)%C.
Proof.
  intros NZ H.
  assert (G : trace2 (mat2_pow (Cmat gam) n) = (Cpw mu n + / Cpw mu n)%C /\
    trace2 (mat2_pow (Cmat gam) (S n)) = (Cpw mu (S n) + / Cpw mu (S n))%C); [|apply G].
  induction n as [|n [IH0 IH1]].
  - split; cbn [Cpw mat2_pow]; unfold trace2, mat2_mul, Cmat; cbn [m11 m12 m21 m22].
    + field. exact C1_neq0.
    + rewrite !Cmult_1_r, H. ring.
  - split; [exact IH1|]. rewrite trace_recurrence, IH0, IH1, <- H. cbn [Cpw].
    pose proof (Cpw_neq0 mu n NZ). field. split; assumption.
Qed.

(* mu = rho (cos phi, sin phi) *)
Lemma Cpw_polar rho phi n : Cpw (rho * cos phi, rho * sin phi) n = (rho ^ n * cos (INR n * phi), rho ^ n * sin (INR n * phi)).
Proof.
  induction n as [|n IH].
  - cbn [Cpw pow INR]. rewrite Rmult_0_l, cos_0, sin_0. apply injective_projections; cbn; ring.
  - cbn [Cpw]. rewrite IH, S_INR. replace ((INR n + 1) * phi) with (phi + INR n * phi) by ring. rewrite cos_plus, sin_plus.
    apply injective_projections; cbn; ring.
Qed.
Lemma polar_trace f g w n rho phi : 1 < rho ->
  fst (gamma f g w) = (rho + / rho) / 2 * cos phi -> snd (gamma f g w) = (rho - / rho) / 2 * sin phi ->
  trace2 (mat2_pow (Cmat (gamma f g w)) n) =
    ((rho ^ n + / rho ^ n) * cos (INR n * phi), (rho ^ n - / rho ^ n) * sin (INR n * phi)).
Proof.
  intros Hr G1 G2. set (mu := (rho * cos phi, rho * sin phi) : C).
  assert (T : forall x, cos x ^ 2 + sin x ^ 2 = 1) by (intros x; pose proof (sin2_cos2 x) as T; unfold Rsqr in T; lra).
  assert (I : (/ mu)%C = (/ rho * cos phi, - (/ rho * sin phi))).
  { unfold mu, Cinv. cbn [fst snd]. replace ((rho * cos phi) ^ 2 + (rho * sin phi) ^ 2) with (rho ^ 2) by (transitivity (rho ^ 2 * (cos phi ^ 2 + sin phi ^ 2)); [rewrite T|]; ring).
    apply injective_projections; cbn; field; lra. }
  assert (NZ : mu <> 0%C).
  { intros E. assert (Z : (rho * cos phi) ^ 2 + (rho * sin phi) ^ 2 = 0) by (injection E as E1 E2; rewrite E1, E2; ring).
    assert (rho ^ 2 = 0) by (rewrite <- Z; transitivity (rho ^ 2 * (cos phi ^ 2 + sin phi ^ 2)); [rewrite T|]; ring). nra. }
  assert (H : (mu + / mu = 2 * gamma f g w)%C).
  { rewrite I. rewrite (surjective_pairing (gamma f g w)), G1, G2. unfold mu. apply injective_projections; cbn; field; lra. }
  rewrite (trace_mu _ mu n NZ H). unfold mu at 1 2. rewrite (Cpw_polar rho phi n).
  set (p := rho ^ n). assert (P : 0 < p) by (apply pow_lt; lra). specialize (T (INR n * phi)).
  set (c := cos (INR n * phi)) in *. set (d := sin (INR n * phi)) in *.
  assert (Q : (p * c) ^ 2 + (p * d) ^ 2 = p ^ 2) by (transitivity (p ^ 2 * (c ^ 2 + d ^ 2)); [|rewrite T]; ring).
  apply injective_projections; cbn [Cplus Cinv fst snd]; rewrite Q; field; lra.
Qed.
Lemma response_modulus f g N w : trace2 (mat2_pow (Cmat (gamma f g w)) (S N)) <> 0%C ->
  response f g N w = 2 / Cmod (trace2 (mat2_pow (Cmat (gamma f g w)) (S N))).
Proof. intros NZ. unfold response. rewrite Cmod_div, Cmod_R, Rabs_pos_eq by (exact NZ || lra). reflexivity. Qed.
Lemma trace_neq0 f g w n : f < 0 -> g < 0 -> trace2 (mat2_pow (Cmat (gamma f g w)) n) <> 0%C.
Proof. intros Hf Hg. rewrite trace_power. now apply denominator_neq0. Qed.
(* where the cosine vanishes, and elsewhere *)
Lemma polar_response f g N w rho phi : f < 0 -> g < 0 -> 1 < rho -> cos (INR (S N) * phi) = 0 ->
  fst (gamma f g w) = (rho + / rho) / 2 * cos phi -> snd (gamma f g w) = (rho - / rho) / 2 * sin phi ->
  response f g N w = 2 / (rho ^ S N - / rho ^ S N).
Proof.
  intros Hf Hg Hr Hc G1 G2. rewrite response_modulus by now apply trace_neq0. rewrite (polar_trace f g w (S N) rho phi Hr G1 G2), Hc.
  pose proof (sin2_cos2 (INR (S N) * phi)) as T. rewrite Hc in T. unfold Rsqr in T.
  set (p := rho ^ S N). assert (P : 1 < p) by (apply Rlt_pow_R1; [exact Hr|lia]).
  assert (Q : / p < 1) by (rewrite <- Rinv_1; apply Rinv_lt_contravar; lra).
  f_equal. unfold Cmod; cbn [fst snd]. set (d := sin (INR (S N) * phi)) in *.
  replace (((p + / p) * 0) ^ 2 + ((p - / p) * d) ^ 2) with ((p - / p) ^ 2) by (transitivity ((p - / p) ^ 2 * (d * d + 0 * 0)); [rewrite T|]; ring).
  rewrite <- Rsqr_pow2, sqrt_Rsqr by lra. reflexivity.
Qed.
Lemma polar_bounded f g N w rho phi : f < 0 -> g < 0 -> 1 < rho -> cos (INR (S N) * phi) <> 0 ->
  fst (gamma f g w) = (rho + / rho) / 2 * cos phi -> snd (gamma f g w) = (rho - / rho) / 2 * sin phi ->
  response f g N w <= / Rabs (cos (INR (S N) * phi)).
Proof.
  intros Hf Hg Hr Hc G1 G2. rewrite response_modulus by now apply trace_neq0. rewrite (polar_trace f g w (S N) rho phi Hr G1 G2).
  set (p := rho ^ S N). assert (P : 1 < p) by (apply Rlt_pow_R1; [exact Hr|lia]). set (c := cos (INR (S N) * phi)) in *.
  set (z := ((p + / p) * c, (p - / p) * sin (INR (S N) * phi)) : C).
  assert (A : 0 < Rabs c) by now apply Rabs_pos_lt.
  assert (B : 2 * Rabs c <= Cmod z).
  { apply Rle_trans with (Rabs (fst z)).
    - unfold z; cbn [fst]. rewrite Rabs_mult. apply Rmult_le_compat_r; [apply Rabs_pos|].
      assert (E : p * / p = 1) by (apply Rinv_r; lra). assert (0 < / p) by (apply Rinv_0_lt_compat; lra).
      rewrite Rabs_pos_eq by lra. pose proof (pow2_ge_0 (p - 1)). apply (Rmult_le_reg_r p); [lra|]. nra.
    - apply Rle_trans with (2 := Rmax_Cmod z). apply Rmax_l. }
  apply Rle_trans with (2 / (2 * Rabs c)).
  - unfold Rdiv. apply Rmult_le_compat_l; [lra|]. apply Rinv_le_contravar; lra.
  - right. field. lra.
Qed.

(* 2/(rho^M - rho^-M) is at least 1/(M S) - 1 *)
Lemma bernoulli_down x n : 0 <= x <= 1 -> 1 - INR n * x <= (1 - x) ^ n.
Proof.
  intros Hx. induction n as [|n IH]; [cbn; lra|]. rewrite S_INR. cbn [pow]. pose proof (pos_INR n).
  apply Rle_trans with ((1 - x) * (1 - INR n * x)); [nra|]. apply Rmult_le_compat_l; [lra|exact IH].
Qed.
Lemma hyperbolic_lower c s n : 0 < s -> 0 < c -> c ^ 2 - s ^ 2 = 1 -> (1 <= n)%nat -> INR n * s < 1 ->
  / (INR n * s) - 1 <= 2 / ((c + s) ^ n - / (c + s) ^ n).
Proof.
  intros Hs Hc E Hn Hd. set (d := INR n * s) in *. assert (N1 : 1 <= INR n) by (apply (le_INR 1); lia).
  assert (D0 : 0 < d) by (unfold d; nra). assert (S1 : s < 1) by (unfold d in Hd; nra).
  assert (C1 : 1 <= c) by nra. assert (I : / (c + s) = c - s) by (apply (Rmult_eq_reg_l (c + s)); [rewrite Rinv_r; nra|lra]).
  assert (L : 1 - d <= (c - s) ^ n).
  { apply Rle_trans with ((1 - s) ^ n); [apply bernoulli_down; lra|]. apply pow_incr. lra. }
  set (p := (c + s) ^ n). assert (P1 : 1 < p) by (apply Rlt_pow_R1; [lra|lia]).
  assert (P : / p = (c - s) ^ n) by (unfold p; rewrite <- I, pow_inv; reflexivity). rewrite <- P in L.
  assert (U : p <= / (1 - d)). { rewrite <- (Rinv_inv p). apply Rinv_le_contravar; lra. }
  assert (W : 0 < p - / p). { assert (/ p < 1) by (rewrite <- Rinv_1; apply Rinv_lt_contravar; lra). lra. }
  apply (Rmult_le_reg_r (p - / p)); [exact W|]. replace (2 / (p - / p) * (p - / p)) with 2 by (unfold Rdiv; rewrite Rmult_assoc, Rinv_l by lra; ring).
  assert (B : p - / p <= d * (2 - d) / (1 - d)).
  { replace (d * (2 - d) / (1 - d)) with (/ (1 - d) - (1 - d)) by (field; lra). lra. }
  assert (K : 0 < / d - 1). { assert (1 < / d) by (rewrite <- Rinv_1 at 1; apply Rinv_lt_contravar; lra). lra. }
  apply Rle_trans with ((/ d - 1) * (d * (2 - d) / (1 - d))); [apply Rmult_le_compat_l; lra|].
  replace ((/ d - 1) * (d * (2 - d) / (1 - d))) with (2 - d) by (field; split; lra). lra.
Qed.

(* ---- the frequency at which mu has the angle phi ---- *)
Section Angle.
Variables (f g phi : R).
Hypotheses (Hf : f < 0) (Hg : g < 0).
Notation F := (- f).
Notation h := (phi ^ 2).
Definition stiffness_term : R := g ^ 2 / (2 * F).
Notation k := stiffness_term.
Hypothesis phi_pos : 0 < phi.
Hypothesis small : (/ 2 + 2 * k) * h < 1.

Lemma k_pos : 0 < k.
Proof. unfold stiffness_term. apply Rdiv_lt_0_compat; [apply pow2_gt_0; lra|lra]. Qed.
Lemma h_small : 0 < h /\ h < 2 /\ k * h < / 2.
Proof. pose proof k_pos. assert (0 < h) by (apply pow_lt; lra). split; [lra|]. split; nra. Qed.
Lemma phi_lt : phi < PI / 2.
Proof. destruct h_small as (_ & h2 & _). pose proof PI2_3_2. nra. Qed.
Lemma cos_lower : 1 - h / 2 <= cos phi.
Proof.
  assert (E : cos phi = 1 - 2 * sin (phi / 2) * sin (phi / 2)).
  { replace phi with (2 * (phi / 2)) at 1 by field. apply cos_2a_sin. }
  rewrite E. assert (0 < phi / 2) by lra. pose proof (sin_lt_x (phi / 2) H). destruct h_small as (_ & h2 & _).
  pose proof phi_lt.
  assert (0 <= sin (phi / 2)) by (apply sin_ge_0; lra). nra.
Qed.
Lemma phi_range : 0 < cos phi < 1 /\ phi * (1 - h / 2) <= sin phi /\ 0 < sin phi.
Proof.
  pose proof phi_pos as P. destruct h_small as (h0 & h2 & _). pose proof cos_lower as L.
  assert (C0 : 0 < cos phi) by lra.
  pose proof phi_lt as P2. pose proof PI_RGT_0.
  assert (S0 : 0 < sin phi) by (apply sin_gt_0; lra).
  split; [split; [exact C0|]|split; [|exact S0]].
  - rewrite <- cos_0. apply cos_decreasing_1; lra.
  - (* mean value: sin phi = phi cos xi >= phi cos phi *)
    destruct (MVT_cor2 sin cos 0 phi P) as (xi & E & X); [intros; apply derivable_pt_lim_sin|].
    rewrite sin_0, !Rminus_0_r in E. rewrite E.
    assert (cos phi <= cos xi) by (left; apply cos_decreasing_1; lra). nra.
Qed.

(* gamma *)
Definition re (w : R) : R := 1 - w ^ 2 * F / (f ^ 2 + (w * g) ^ 2).
Definition im (w : R) : R := - g * w ^ 3 / (f ^ 2 + (w * g) ^ 2).
Lemma den_pos w : 0 < f ^ 2 + (w * g) ^ 2.
Proof. pose proof (pow2_ge_0 (w * g)). assert (0 < f ^ 2) by (apply pow2_gt_0; lra). lra. Qed.
Lemma gamma_re w : fst (gamma f g w) = re w.
Proof.
  unfold re, gamma, num, den, Cdiv, Cinv, Cmult; cbn [fst snd]. pose proof (den_pos w). field. nra.
Qed.
Lemma gamma_im w : snd (gamma f g w) = im w.
Proof. now apply gamma_imaginary. Qed.

(* the largest frequency to look at: re w1 = cos phi *)
Definition kappa : R := 1 - cos phi.
Definition w1 : R := sqrt (kappa * f ^ 2 / (F - kappa * g ^ 2)).
Lemma kappa_range : 0 < kappa <= h / 2 /\ F / 2 < F - kappa * g ^ 2.
Proof.
  destruct phi_range as ((C0 & C1) & _). pose proof cos_lower. destruct h_small as (h0 & _ & kh). unfold kappa. split; [lra|].
  assert (E : h * g ^ 2 < F). { unfold stiffness_term in kh. replace (g ^ 2 / (2 * F) * h) with (h * g ^ 2 / (2 * F)) in kh by (field; lra).
    apply (Rmult_lt_compat_r (2 * F)) in kh; [|lra]. replace (h * g ^ 2 / (2 * F) * (2 * F)) with (h * g ^ 2) in kh by (field; lra). lra. }
  assert (0 < g ^ 2) by (apply pow2_gt_0; lra). nra.
Qed.
Lemma w1_sqr : w1 ^ 2 = kappa * f ^ 2 / (F - kappa * g ^ 2) /\ 0 < w1.
Proof.
  destruct kappa_range as ((K0 & _) & D). assert (0 < kappa * f ^ 2 / (F - kappa * g ^ 2)).
  { apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat; [lra|apply pow2_gt_0; lra]|lra]. }
  split; [unfold w1; rewrite <- Rsqr_pow2, Rsqr_sqrt; lra|now apply sqrt_lt_R0].
Qed.
Lemma re_w1 : re w1 = cos phi.
Proof.
  destruct kappa_range as ((K0 & _) & D). destruct w1_sqr as (E & P). unfold re. rewrite Rpow_mult_distr, E.
  assert (Z : 0 < f ^ 2) by (apply pow2_gt_0; lra). assert (cos phi = 1 - kappa) by (unfold kappa; ring). rewrite H. clear H.
  f_equal. field. repeat split; try lra. nra.
Qed.
(* (re/cos phi)^2 - (im/sin phi)^2 = 1 somewhere below w1 *)
Lemma peak_frequency : exists w, 0 < w <= w1 /\ (re w / cos phi) ^ 2 - (im w / sin phi) ^ 2 = 1.
Proof.
  destruct phi_range as ((C0 & C1) & _ & S0). destruct w1_sqr as (E & P).
  set (H := fun w => 1 - ((re w / cos phi) ^ 2 - (im w / sin phi) ^ 2)).
  assert (Cont : continuity H).
  { intros w. apply continuity_pt_filterlim, (ex_derive_continuous H). unfold H, re, im. auto_derive.
    pose proof (den_pos w). simpl in *. repeat split; lra. }
  assert (H0 : H 0 < 0).
  { unfold H, re, im. replace (0 ^ 2 * F / (f ^ 2 + (0 * g) ^ 2)) with 0 by (field; pose proof (den_pos 0); lra).
    replace (- g * 0 ^ 3 / (f ^ 2 + (0 * g) ^ 2)) with 0 by (field; pose proof (den_pos 0); lra).
    replace ((1 - 0) / cos phi) with (/ cos phi) by (field; lra). replace (0 / sin phi) with 0 by (field; lra).
    assert (1 < / cos phi) by (rewrite <- Rinv_1 at 1; apply Rinv_lt_contravar; lra). nra. }
  assert (H1 : 0 <= H w1).
  { unfold H. rewrite re_w1. replace (cos phi / cos phi) with 1 by (field; lra). pose proof (pow2_ge_0 (im w1 / sin phi)). lra. }
  destruct H1 as [H1|H1].
  - destruct (IVT H 0 w1 Cont P H0 H1) as (w & W & Z). exists w. unfold H in Z. split; [|lra].
    split; [|lra]. destruct (Req_dec w 0) as [->|]; [|lra]. unfold H in H0. lra.
  - exists w1. unfold H in H1. split; lra.
Qed.
Definition quotient : R := 1 - k * h.
Notation q := quotient.
Lemma quotient_range : / 2 < q < 1 /\ h / 2 < q.
Proof. destruct h_small as (h0 & _ & kh). pose proof k_pos. unfold quotient. repeat split; nra. Qed.
Lemma w1_le : w1 ^ 2 <= h * F / (2 * q).
Proof.
  destruct w1_sqr as (E & _). destruct kappa_range as ((K0 & K1) & D). destruct quotient_range as ((Q0 & Q1) & _). destruct h_small as (h0 & _ & _).
  rewrite E. assert (G2 : 0 < g ^ 2) by (apply pow2_gt_0; lra). assert (F2 : 0 < f ^ 2) by (apply pow2_gt_0; lra).
  assert (EQ : h * F / (2 * q) = h / 2 * f ^ 2 / (F - h / 2 * g ^ 2)).
  { unfold quotient, stiffness_term. assert (Z : F - h / 2 * g ^ 2 = F * (1 - g ^ 2 / (2 * F) * h)) by (field; lra).
    rewrite Z. fold stiffness_term. fold quotient. field. split; lra. }
  assert (D2 : 0 < F - h / 2 * g ^ 2).
  { replace (F - h / 2 * g ^ 2) with (F * q) by (unfold quotient, stiffness_term; field; lra). apply Rmult_lt_0_compat; lra. }
  rewrite EQ. apply (Rmult_le_reg_r (F - kappa * g ^ 2)); [lra|]. apply (Rmult_le_reg_r (F - h / 2 * g ^ 2)); [exact D2|].
  replace (kappa * f ^ 2 / (F - kappa * g ^ 2) * (F - kappa * g ^ 2) * (F - h / 2 * g ^ 2)) with (kappa * f ^ 2 * (F - h / 2 * g ^ 2)) by (field; lra).
  replace (h / 2 * f ^ 2 / (F - h / 2 * g ^ 2) * (F - kappa * g ^ 2) * (F - h / 2 * g ^ 2)) with (h / 2 * f ^ 2 * (F - kappa * g ^ 2)) by (field; lra).
  assert (0 <= f ^ 2 * F * (h / 2 - kappa)) by (apply Rmult_le_pos; [apply Rmult_le_pos; lra|lra]). nra.
Qed.
(* S = im/sin phi is at most of the order phi^2 *)
Definition height : R := - g / (2 * sqrt 2 * sqrt F).
Lemma height_pos : 0 < height.
Proof.
  unfold height. assert (0 < sqrt F) by (apply sqrt_lt_R0; lra). assert (0 < sqrt 2) by (apply sqrt_lt_R0; lra).
  apply Rdiv_lt_0_compat; [lra|]. apply Rmult_lt_0_compat; lra.
Qed.
Lemma sinh_le w : 0 < w <= w1 -> im w / sin phi <= height * h / (q ^ 2 * (1 - h / 2)).
Proof.
  intros W. destruct phi_range as (_ & S1 & S0). destruct quotient_range as ((Q0 & Q1) & _).
  destruct h_small as (h0 & h2 & _). pose proof w1_le as L. destruct w1_sqr as (_ & P1).
  set (r := sqrt F). assert (R0 : 0 < r) by (apply sqrt_lt_R0; lra). assert (R2 : r * r = F) by (apply sqrt_sqrt; lra).
  set (t := sqrt 2). assert (T0 : 0 < t) by (apply sqrt_lt_R0; lra). assert (T2 : t * t = 2) by (apply sqrt_sqrt; lra).
  (* w <= phi r/(t q) *)
  set (b := phi * r / (t * q)). assert (B0 : 0 < b) by (apply Rdiv_lt_0_compat; apply Rmult_lt_0_compat; lra).
  assert (WB : w <= b).
  { apply Rle_trans with w1; [lra|]. apply Rsqr_incr_0; [|lra|lra]. rewrite !Rsqr_pow2. apply Rle_trans with (h * F / (2 * q)); [exact L|].
    unfold b. replace ((phi * r / (t * q)) ^ 2) with (h * (r * r) / (t * t * q * q)) by (field; split; lra). rewrite R2, T2.
    apply (Rmult_le_reg_r (2 * q * q)); [nra|]. replace (h * F / (2 * q) * (2 * q * q)) with (h * F * q) by (field; lra).
    replace (h * F / (2 * q * q) * (2 * q * q)) with (h * F) by (field; lra). assert (0 < h * F) by (apply Rmult_lt_0_compat; lra). nra. }
  assert (W2 : w ^ 2 <= h * F / (2 * q)) by (apply Rle_trans with (w1 ^ 2); [apply pow_incr; lra|exact L]).
  assert (W3 : w ^ 3 <= h * F / (2 * q) * b).
  { replace (w ^ 3) with (w ^ 2 * w) by ring. apply Rmult_le_compat; try lra. apply pow2_ge_0. }
  assert (I : im w <= - g * (h * F / (2 * q) * b) / f ^ 2).
  { unfold im. pose proof (den_pos w). assert (F2 : 0 < f ^ 2) by (apply pow2_gt_0; lra).
    apply Rle_trans with (- g * w ^ 3 / f ^ 2).
    - unfold Rdiv. apply Rmult_le_compat_l; [apply Rmult_le_pos; [lra|apply pow_le; lra]|]. apply Rinv_le_contravar; [exact F2|]. pose proof (pow2_ge_0 (w * g)). lra.
    - unfold Rdiv at 1 2. apply Rmult_le_compat_r; [left; now apply Rinv_0_lt_compat|]. apply Rmult_le_compat_l; lra. }
  set (J := - g * (h * F / (2 * q) * b) / f ^ 2) in *.
  assert (J0 : 0 < J). { unfold J. apply Rdiv_lt_0_compat; [|apply pow2_gt_0; lra]. apply Rmult_lt_0_compat; [lra|]. apply Rmult_lt_0_compat; [|exact B0].
    apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat; lra|lra]. }
  assert (D0 : 0 < phi * (1 - h / 2)) by (apply Rmult_lt_0_compat; lra).
  apply Rle_trans with (J / (phi * (1 - h / 2))).
  - apply Rle_trans with (J / sin phi).
    + unfold Rdiv. apply Rmult_le_compat_r; [left; now apply Rinv_0_lt_compat|exact I].
    + unfold Rdiv. apply Rmult_le_compat_l; [lra|]. now apply Rinv_le_contravar.
  - right. unfold J, b, height. fold r. fold t.
    assert (EF : f ^ 2 = r * r * (r * r)) by (rewrite R2; ring). rewrite EF, <- R2.
    assert (1 - h / 2 <> 0) by lra. field. repeat split; lra.
Qed.
(* the frequency, with c = cosh y and s = sinh y *)
Theorem angle_frequency : exists w c s, 0 < w /\ w ^ 2 <= h * F / (2 * q) /\ 0 < s /\ 1 < c /\ c ^ 2 - s ^ 2 = 1 /\
  fst (gamma f g w) = c * cos phi /\ snd (gamma f g w) = s * sin phi /\ s <= height * h / (q ^ 2 * (1 - h / 2)).
Proof.
  destruct peak_frequency as (w & W & E). pose proof (sinh_le w W) as L.
  destruct phi_range as ((C0 & C1) & S1 & S0). destruct quotient_range as ((Q0 & Q1) & Q2). destruct h_small as (h0 & h2 & kh). pose proof k_pos.
  assert (WL : w ^ 2 <= h * F / (2 * q)) by (apply Rle_trans with (w1 ^ 2); [apply pow_incr; lra|apply w1_le]).
  assert (W2 : w ^ 2 < F).
  { apply Rle_lt_trans with (1 := WL). apply (Rmult_lt_reg_r (2 * q)); [lra|]. replace (h * F / (2 * q) * (2 * q)) with (h * F) by (field; lra). nra. }
  assert (RE : 0 < re w).
  { unfold re. pose proof (den_pos w) as DP. assert (w ^ 2 * F / (f ^ 2 + (w * g) ^ 2) < 1); [|lra].
    apply (Rmult_lt_reg_r (f ^ 2 + (w * g) ^ 2)); [exact DP|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. pose proof (pow2_ge_0 (w * g)).
    assert (w ^ 2 * F < f ^ 2) by nra. lra. }
  assert (IM : 0 < im w).
  { unfold im. pose proof (den_pos w). apply Rdiv_lt_0_compat; [|lra]. apply Rmult_lt_0_compat; [lra|apply pow_lt; lra]. }
  exists w, (re w / cos phi), (im w / sin phi). set (c := re w / cos phi) in *. set (s := im w / sin phi) in *.
  assert (c0 : 0 < c) by (apply Rdiv_lt_0_compat; lra). assert (s0 : 0 < s) by (apply Rdiv_lt_0_compat; lra).
  repeat split; try assumption; try lra.
  - nra.
  - rewrite gamma_re. unfold c. field. lra.
  - rewrite gamma_im. unfold s. field. lra.
Qed.
End Angle.

(* rho = c + s and 1/rho = c - s *)
Lemma hyperbolic_pair c s : 0 < s -> 1 < c -> c ^ 2 - s ^ 2 = 1 ->
  1 < c + s /\ / (c + s) = c - s /\ (c + s + / (c + s)) / 2 = c /\ (c + s - / (c + s)) / 2 = s.
Proof.
  intros Hs Hc E. assert (I : / (c + s) = c - s) by (apply (Rmult_eq_reg_l (c + s)); [rewrite Rinv_r; nra|lra]).
  rewrite I. repeat split; lra.
Qed.

(* ---- the main resonance: phi = pi/(2 M), M = N + 1 ---- *)
Definition slope (f g : R) : R := PI ^ 2 * Rabs g / (8 * sqrt 2 * sqrt (Rabs f)).              (* the X of Proposition 2 *)
Definition peak_angle (N : nat) : R := PI / (2 * INR (S N)).
Lemma M_pos N : 1 <= INR (S N).
Proof. apply (le_INR 1). lia. Qed.
Lemma slope_pos f g : f < 0 -> g < 0 -> 0 < slope f g.
Proof.
  intros Hf Hg. unfold slope. pose proof PI_RGT_0. assert (0 < Rabs g) by (apply Rabs_pos_lt; lra). assert (0 < sqrt (Rabs f)) by (apply sqrt_lt_R0, Rabs_pos_lt; lra).
  assert (0 < sqrt 2) by (apply sqrt_lt_R0; lra). apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat; [apply pow_lt; lra|lra]|]. apply Rmult_lt_0_compat; lra.
Qed.
Lemma angle_pos N : 0 < peak_angle N.
Proof. unfold peak_angle. pose proof (M_pos N). pose proof PI_RGT_0. apply Rdiv_lt_0_compat; lra. Qed.
Theorem peak_lower f g N : f < 0 -> g < 0 -> (/ 2 + 2 * stiffness_term f g) * peak_angle N ^ 2 < 1 ->
  exists w, 0 < w /\ INR (S N) / slope f g * (1 - (/ 2 + 2 * stiffness_term f g) * peak_angle N ^ 2) - 1 <= response f g N w.
Proof.
  intros Hf Hg small. pose proof (angle_pos N) as P. pose proof (M_pos N) as M1. set (phi := peak_angle N) in *. set (M := INR (S N)) in *.
  destruct (angle_frequency f g phi Hf Hg P small) as (w & c & s & W & _ & s0 & c1 & E & G1 & G2 & L). exists w. split; [exact W|].
  destruct (h_small f g phi Hf Hg P small) as (h0 & h2 & kh). destruct (quotient_range f g phi Hf Hg P small) as ((Q0 & Q1) & Q2).
  pose proof (k_pos f g Hf Hg) as K0. pose proof (slope_pos f g Hf Hg) as X0. set (X := slope f g) in *. set (k := stiffness_term f g) in *.
  destruct (hyperbolic_pair c s s0 c1 E) as (R1 & I & A & B). set (q := quotient f g phi) in *. set (h := phi ^ 2) in *.
  assert (MP : M * phi = PI / 2) by (unfold phi, peak_angle; fold M; field; lra).
  assert (RESP : response f g N w = 2 / ((c + s) ^ S N - / (c + s) ^ S N)).
  { apply (polar_response f g N w (c + s) phi Hf Hg R1); [fold M; rewrite MP; apply cos_PI2|now rewrite A|now rewrite B]. }
  (* M s <= X/M (1 + ..) *)
  assert (HX : M * (height f g * h) = X / M).
  { unfold height, X, slope, h, phi, peak_angle. fold M. rewrite (Rabs_left g), (Rabs_left f) by lra.
    assert (0 < sqrt (- f)) by (apply sqrt_lt_R0; lra). assert (0 < sqrt 2) by (apply sqrt_lt_R0; lra). field. repeat split; lra. }
  assert (V : 0 < q ^ 2 * (1 - h / 2)) by (apply Rmult_lt_0_compat; [apply pow_lt|]; lra).
  assert (L2 : M * s <= X / M / (q ^ 2 * (1 - h / 2))).
  { rewrite <- HX. replace (M * (height f g * h) / (q ^ 2 * (1 - h / 2))) with (M * (height f g * h / (q ^ 2 * (1 - h / 2)))) by (field; split; lra).
    apply Rmult_le_compat_l; lra. }
  assert (D0 : 0 < M * s) by (apply Rmult_lt_0_compat; lra).
  assert (U : M / X * (1 - (/ 2 + 2 * k) * h) <= / (M * s)).
  { apply Rle_trans with (M / X * (q ^ 2 * (1 - h / 2))).
    - apply Rmult_le_compat_l; [left; apply Rdiv_lt_0_compat; lra|]. unfold q, quotient. fold k. fold h. assert (0 <= k * h) by nra.
      assert (0 <= k ^ 2 * h ^ 2 * (1 - h / 2)) by (apply Rmult_le_pos; [apply Rmult_le_pos; apply pow2_ge_0|lra]). nra.
    - replace (M / X * (q ^ 2 * (1 - h / 2))) with (/ (X / M / (q ^ 2 * (1 - h / 2)))) by (field; repeat split; lra).
      now apply Rinv_le_contravar. }
  destruct (Rlt_le_dec (M * s) 1) as [D1|D1].
  - rewrite RESP. apply Rle_trans with (/ (M * s) - 1); [lra|]. apply hyperbolic_lower; try assumption; [lra|lia].
  - assert (/ (M * s) <= 1) by (rewrite <- Rinv_1; apply Rinv_le_contravar; lra). pose proof (Cmod_ge_0 (2 / trace2 (mat2_pow (Cmat (gamma f g w)) (S N)))%C).
    unfold response. lra.
Qed.

Lemma unbounded (A : R) : exists n, A < INR n.
Proof.
  destruct (nfloor_ex (Rmax 0 A) (Rmax_l 0 A)) as (n & _ & L). exists (S n). rewrite S_INR. pose proof (Rmax_r 0 A). lra.
Qed.
(* veerman.prop2: for every eps > 0 and all large flocks.  The leader has the amplitude a0 at the frequency wp of the largest
   response, and the last car stays within D. *)
Theorem proposition_2 f g : f < 0 -> g < 0 -> forall eps, 0 < eps -> exists N0, forall N, (N0 <= N)%nat -> forall a0 D wp, 0 < a0 ->
  (forall w, response f g N w <= response f g N wp) -> a0 * response f g N wp <= D ->
  INR (N + 1) <= (1 + eps) * (PI ^ 2 * Rabs g / (8 * sqrt 2 * sqrt (Rabs f)) * (D / a0)).
Proof.
  intros Hf Hg eps He. pose proof (slope_pos f g Hf Hg) as X0. fold (slope f g). set (X := slope f g) in *.
  pose proof (k_pos f g Hf Hg) as K0. set (K := / 2 + 2 * stiffness_term f g). assert (Kp : 0 < K) by (unfold K; lra).
  destruct (unbounded (2 * (1 + eps) * X / eps + K * PI ^ 2 * (1 + eps) / (2 * eps))) as (N0 & B). exists N0.
  intros N HN a0 D wp Ha Hmax Hd. rewrite Nat.add_1_r. set (M := INR (S N)).
  assert (MB : 2 * (1 + eps) * X / eps + K * PI ^ 2 * (1 + eps) / (2 * eps) < M).
  { apply Rlt_le_trans with (INR N0); [lra|]. apply le_INR. lia. }
  pose proof PI_RGT_0 as P. assert (PP : 0 < PI ^ 2) by (apply pow_lt; lra).
  assert (T1 : 0 < 2 * (1 + eps) * X / eps) by (apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat; lra|lra]).
  assert (T2 : 0 < K * PI ^ 2 * (1 + eps) / (2 * eps)) by (apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat; [apply Rmult_lt_0_compat; assumption|lra]|lra]).
  pose proof (M_pos N) as M1. fold M in M1.
  assert (HH : K * peak_angle N ^ 2 <= eps / (2 * (1 + eps))).
  { unfold peak_angle. fold M. replace (K * (PI / (2 * M)) ^ 2) with (K * PI ^ 2 / (4 * M * M)) by (field; lra).
    apply (Rmult_le_reg_r (4 * M * M)); [nra|]. replace (K * PI ^ 2 / (4 * M * M) * (4 * M * M)) with (K * PI ^ 2) by (field; lra).
    assert (Y : K * PI ^ 2 <= 2 * eps / (1 + eps) * M).
    { apply (Rmult_le_reg_r ((1 + eps) / (2 * eps))); [apply Rdiv_lt_0_compat; lra|].
      replace (2 * eps / (1 + eps) * M * ((1 + eps) / (2 * eps))) with M by (field; split; lra).
      replace (K * PI ^ 2 * ((1 + eps) / (2 * eps))) with (K * PI ^ 2 * (1 + eps) / (2 * eps)) by (field; lra). lra. }
    apply Rle_trans with (1 := Y). replace (eps / (2 * (1 + eps)) * (4 * M * M)) with (2 * eps / (1 + eps) * (M * M)) by (field; lra).
    apply Rmult_le_compat_l; [left; apply Rdiv_lt_0_compat; lra|nra]. }
  assert (E1 : eps / (2 * (1 + eps)) < 1).
  { apply (Rmult_lt_reg_r (2 * (1 + eps))); [lra|]. replace (eps / (2 * (1 + eps)) * (2 * (1 + eps))) with eps by (field; lra). lra. }
  destruct (peak_lower f g N Hf Hg ltac:(fold K; lra)) as (w & _ & L). fold K X M in L. specialize (Hmax w).
  set (e := K * peak_angle N ^ 2) in *.
  assert (R : response f g N w <= D / a0).
  { apply (Rmult_le_reg_r a0); [exact Ha|]. replace (D / a0 * a0) with D by (field; lra). nra. }
  assert (U : M * (1 - e) - X <= X * (D / a0)).
  { replace (M * (1 - e) - X) with (X * (M / X * (1 - e) - 1)) by (field; lra). apply Rmult_le_compat_l; lra. }
  apply Rle_trans with ((1 + eps) * (M * (1 - e) - X)); [|apply Rmult_le_compat_l; lra].
  assert (V : (1 + eps) * e <= eps / 2).
  { replace (eps / 2) with ((1 + eps) * (eps / (2 * (1 + eps)))) by (field; lra). apply Rmult_le_compat_l; lra. }
  assert (W : 2 * (1 + eps) * X <= eps * M).
  { apply (Rmult_le_reg_r (/ eps)); [now apply Rinv_0_lt_compat|]. replace (eps * M * / eps) with M by (field; lra).
    replace (2 * (1 + eps) * X * / eps) with (2 * (1 + eps) * X / eps) by reflexivity. lra. }
  assert (Z : M * ((1 + eps) * e) <= M * (eps / 2)) by (apply Rmult_le_compat_l; lra). nra.
Qed.
