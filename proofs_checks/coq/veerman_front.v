(* Veerman, Stosic, Olvera, section 3: tracking only the car in front.
     veerman.cor1, cor1_special, cor1.proof, gain_iff, gain_max, sep_remark, prop1.
   Positions are complex functions of real time, derivatives are true derivatives.
   gamma = (f + i w g + w^2)/(f + i w g);  f, g < 0 where stability is assumed. *)
From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import veerman_complex.
Open Scope R_scope.

Definition num (f g w : R) : C := (f + w ^ 2, w * g).
Definition den (f g w : R) : C := (f, w * g).
Definition gamma (f g w : R) : C := (num f g w / den f g w)%C.
(* den = f + i w g and num = f + i w g + w^2 *)
Lemma den_printed f g w : den f g w = (RtoC f + Ci * w * g)%C.
Proof. apply injective_projections; cbn; ring. Qed.
Lemma num_printed f g w : num f g w = (RtoC f + Ci * w * g + RtoC (w ^ 2))%C.
Proof. apply injective_projections; cbn; ring. Qed.

Section Gains.
Variables f g w : R.
Hypotheses (Hf : f < 0) (Hg : g < 0).
Lemma den_neq0 : den f g w <> 0%C.
Proof. apply Cneq0_re; cbn; lra. Qed.
Lemma num_neq0 : num f g w <> 0%C.
Proof.
  destruct (Req_dec w 0) as [W|W].
  - apply Cneq0_re; cbn. rewrite W. lra.
  - apply Cneq0_im; cbn. intros E. apply Rmult_integral in E as [E|E]; lra.
Qed.
Lemma gamma_neq0 : gamma f g w <> 0%C.
Proof.
  intros E. apply (f_equal (fun z => z * den f g w)%C) in E. unfold gamma, Cdiv in E.
  rewrite <- Cmult_assoc, Cinv_l, Cmult_1_r, Cmult_0_l in E by exact den_neq0. exact (num_neq0 E).
Qed.
Lemma inv_gamma : (/ gamma f g w = den f g w / num f g w)%C.
Proof. unfold gamma. field. split; [exact num_neq0|exact den_neq0]. Qed.
End Gains.

(* ---- the motion behind the leader h_0 + e^{i w t} ---- *)
(* car k >= 1 obeys equation (1): u_k = x_k', u_k' = f((x_k - h_k) - (x_{k-1} - h_{k-1})) + g (u_k - u_{k-1}) *)
Definition equation_1 (f g : R) (h : nat -> R) (x u : nat -> R -> C) : Prop :=
  forall k t, Cderive (x (S k)) t (u (S k) t) /\
    Cderive (u (S k)) t ((f * ((x (S k) t - h (S k)) - (x k t - h k)) + g * (u (S k) t - u k t))%C).

(* deviations a_k e^{i w t} *)
Definition wave_x (h : nat -> R) (a : nat -> C) (w : R) (k : nat) (t : R) : C := (RtoC (h k) + a k * cis (w * t))%C.
Definition wave_u (a : nat -> C) (w : R) (k : nat) (t : R) : C := ((0, w) * (a k * cis (w * t)))%C.

Lemma Cderive_wave2 (a : C) (w t : R) :
  Cderive (fun s : R => ((0, w) * (a * cis (w * s)))%C) t ((- w ^ 2)%R * (a * cis (w * t)))%C.
Proof.
  split; unfold cis; cbn [fst snd Cmult]; (evar_last; [auto_derive; [easy|reflexivity] | ]); cbn; ring.
Qed.

(* veerman.cor1.proof, corrected: the substitution turns (1) into the printed relation of amplitudes *)
Theorem substitution f g h a w :
  equation_1 f g h (wave_x h a w) (wave_u a w) <->
  forall k, ((- w ^ 2)%R * a (S k) = f * (a (S k) - a k) + (0, w)%R * g * (a (S k) - a k))%C.
Proof.
  assert (E : forall k t, (f * (wave_x h a w (S k) t - h (S k) - (wave_x h a w k t - h k))
      + g * (wave_u a w (S k) t - wave_u a w k t)
      = (f * (a (S k) - a k) + (0, w)%R * g * (a (S k) - a k)) * cis (w * t))%C).
  { intros k t. unfold wave_x, wave_u. ring. }
  split.
  - intros H k. destruct (H k 0) as [_ D]. rewrite E in D.
    pose proof (Cderive_unique _ _ _ _ D (Cderive_wave2 (a (S k)) w 0)) as U.
    rewrite Cmult_assoc in U. pose proof (cis_neq0 (w * 0)) as NZ.
    symmetry. exact (Cmult_cancel_r _ _ _ NZ U).
  - intros H k t. split.
    + apply Cderive_plus_const. apply Cderive_wave.
    + rewrite E, <- H, <- Cmult_assoc. apply Cderive_wave2.
Qed.

(* veerman.cor1: the particular solution behind x_0 - h_0 = e^{i w t} *)
Theorem corollary_1 f g h a w : f < 0 -> g < 0 -> a 0%nat = RtoC 1 ->
  (equation_1 f g h (wave_x h a w) (wave_u a w) <-> forall k, a k = Cpw (/ gamma f g w)%C k).
Proof.
  intros Hf Hg A0. rewrite substitution.
  assert (S1 : forall k, ((- w ^ 2)%R * a (S k) = f * (a (S k) - a k) + (0, w)%R * g * (a (S k) - a k))%C
    <-> a (S k) = (/ gamma f g w * a k)%C).
  { intros k. rewrite inv_gamma by assumption.
    assert (R : ((f * (a (S k) - a k) + (0, w)%R * g * (a (S k) - a k)) - (- w ^ 2)%R * a (S k)
      = num f g w * a (S k) - den f g w * a k)%C).
    { apply injective_projections; cbn; ring. }
    pose proof (num_neq0 f g w Hf Hg) as NZ. apply Cminus_iff in R. split; intros H.
    - symmetry in H. apply R in H. apply (Cmult_cancel_r _ _ (num f g w) NZ).
      rewrite Cmult_comm, H. unfold Cdiv.
      replace (den f g w * / num f g w * a k * num f g w)%C with (den f g w * a k * (/ num f g w * num f g w))%C by ring.
      rewrite Cinv_l by exact NZ. ring.
    - symmetry. apply R. rewrite H. unfold Cdiv.
      replace (num f g w * (den f g w * / num f g w * a k))%C with (num f g w * / num f g w * (den f g w * a k))%C by ring.
      rewrite Cinv_r by exact NZ. ring. }
  split; intros H k.
  - induction k as [|k IH]; [exact A0|]. cbn [Cpw]. rewrite <- IH. now apply S1.
  - apply S1. rewrite !H. reflexivity.
Qed.

(* veerman.cor1_special *)
Theorem corollary_1_special f g k : f < 0 -> g < 0 ->
  Cpw (/ gamma f g (sqrt (Rabs f)))%C k = Cpw (1, sqrt (Rabs f) / g) k.
Proof.
  intros Hf Hg. f_equal. rewrite inv_gamma by assumption. rewrite Rabs_left by assumption.
  assert (S2 : sqrt (- f) ^ 2 = - f) by (rewrite pow2_sqrt; lra).
  assert (SP : 0 < sqrt (- f)) by (apply sqrt_lt_R0; lra).
  set (s := sqrt (- f)) in *. pose proof (num_neq0 f g s Hf Hg) as NZ.
  apply (Cmult_cancel_r _ _ (num f g s) NZ). unfold Cdiv. rewrite <- Cmult_assoc, Cinv_l, Cmult_1_r by exact NZ.
  unfold num, den. rewrite S2. apply injective_projections; cbn [Cmult fst snd].
  - replace f with (- s ^ 2) by lra. field. lra.
  - field. lra.
Qed.

(* ---- the gain ---- *)
Definition gain2 (f g w : R) : R := (f ^ 2 + (w * g) ^ 2) / ((f + w ^ 2) ^ 2 + (w * g) ^ 2).
Lemma gain2_spec f g w : f < 0 -> g < 0 -> Cmod (/ gamma f g w)%C ^ 2 = gain2 f g w.
Proof.
  intros Hf Hg. rewrite inv_gamma, Cmod_div by (try assumption; now apply num_neq0).
  unfold Rdiv. rewrite Rpow_mult_distr, pow_inv, !Cmod_sqr. reflexivity.
Qed.
Lemma below_pos f g w : f < 0 -> g < 0 -> 0 < (f + w ^ 2) ^ 2 + (w * g) ^ 2.
Proof.
  intros Hf Hg. pose proof (pow2_ge_0 (f + w ^ 2)). pose proof (pow2_ge_0 (w * g)).
  destruct (Req_dec w 0) as [W|W].
  - rewrite W. replace ((f + 0 ^ 2) ^ 2 + (0 * g) ^ 2) with (f ^ 2) by ring. apply pow2_gt_0. lra.
  - assert (0 < (w * g) ^ 2); [|lra]. apply pow2_gt_0. intros E. apply Rmult_integral in E as [E|E]; lra.
Qed.

(* veerman.gain_iff, corrected: 0 < w^2 *)
Theorem gain_above_one f g w : f < 0 -> g < 0 ->
  (1 < Cmod (/ gamma f g w)%C <-> 0 < w ^ 2 < 2 * Rabs f).
Proof.
  intros Hf Hg. rewrite Rabs_left by exact Hf. assert (Hm := Cmod_ge_0 (/ gamma f g w)%C).
  assert (E := gain2_spec f g w Hf Hg). set (m := Cmod _) in *. clearbody m.
  pose proof (below_pos f g w Hf Hg) as HD. set (D := (f + w ^ 2) ^ 2 + (w * g) ^ 2) in *.
  assert (L : (m ^ 2 - 1) * D = w ^ 2 * (- 2 * f - w ^ 2)).
  { rewrite E. unfold gain2. fold D. unfold D in *. field. lra. }
  pose proof (pow2_ge_0 w) as W. split; intros H'.
  - assert (0 < (m ^ 2 - 1) * D) by (apply Rmult_lt_0_compat; [nra|exact HD]).
    rewrite L in *. destruct W as [W|W]; [|rewrite <- W in *; lra]. split; [exact W|]. nra.
  - assert (0 < (m ^ 2 - 1) * D) by (rewrite L; apply Rmult_lt_0_compat; lra).
    assert (0 < m ^ 2 - 1) by nra. nra.
Qed.
(* the printed statement fails at w = 0 *)
Theorem gain_iff_printed_fails :
  ~ (forall f g w, f < 0 -> g < 0 -> (1 < Cmod (/ gamma f g w)%C <-> w ^ 2 < 2 * Rabs f)).
Proof.
  intros H. assert (L : 0 ^ 2 < 2 * Rabs (-1)) by (rewrite Rabs_left; lra).
  apply (H (-1) (-1) 0 ltac:(lra) ltac:(lra)) in L. apply gain_above_one in L; lra.
Qed.

(* veerman.gain_max, corrected: the only maximum is at w^2 = (f^2/g^2)(sqrt(1 + 2 g^2/|f|) - 1) < |f| *)
Definition strongest (f g : R) : R := f ^ 2 / g ^ 2 * (sqrt (1 + 2 * g ^ 2 / Rabs f) - 1).

Lemma strongest_root f g : f < 0 -> g < 0 ->
  0 < strongest f g < - f /\ g ^ 2 * strongest f g ^ 2 + 2 * f ^ 2 * strongest f g = - 2 * f ^ 3.
Proof.
  intros Hf Hg. unfold strongest. rewrite Rabs_left by exact Hf.
  assert (G2 : 0 < g ^ 2) by (apply pow2_gt_0; lra). assert (F2 : 0 < f ^ 2) by (apply pow2_gt_0; lra).
  assert (Q : 0 < 2 * g ^ 2 / - f) by (apply Rdiv_lt_0_compat; lra).
  set (r := sqrt (1 + 2 * g ^ 2 / - f)).
  assert (R2 : r ^ 2 = 1 + 2 * g ^ 2 / - f) by (unfold r; rewrite pow2_sqrt; lra).
  assert (R1 : 1 < r).
  { unfold r. rewrite <- sqrt_1 at 1. apply sqrt_lt_1_alt. lra. }
  assert (EQ : g ^ 2 * (f ^ 2 / g ^ 2 * (r - 1)) ^ 2 + 2 * f ^ 2 * (f ^ 2 / g ^ 2 * (r - 1)) = - 2 * f ^ 3).
  { replace (g ^ 2 * (f ^ 2 / g ^ 2 * (r - 1)) ^ 2 + 2 * f ^ 2 * (f ^ 2 / g ^ 2 * (r - 1)))
      with (f ^ 4 / g ^ 2 * (r ^ 2 - 1)) by (field; lra).
    rewrite R2. field. lra. }
  split; [|exact EQ]. split.
  - apply Rmult_lt_0_compat; [apply Rdiv_lt_0_compat; lra | lra].
  - set (v := f ^ 2 / g ^ 2 * (r - 1)) in *.
    assert (0 < v) by (apply Rmult_lt_0_compat; [apply Rdiv_lt_0_compat; lra | lra]).
    destruct (Rlt_le_dec v (- f)) as [L|L]; [exact L|exfalso].
    assert (0 < g ^ 2 * v ^ 2) by (apply Rmult_lt_0_compat; [lra | apply pow2_gt_0; lra]).
    assert (f ^ 2 * (v + f) >= 0) by nra. nra.
Qed.

(* maximum minus value, as an explicit non-negative quantity *)
Lemma gain2_deficit f g w : f < 0 -> g < 0 ->
  let v := strongest f g in let top := f ^ 2 / (f ^ 2 - v ^ 2) in
  top - gain2 f g w = top * (w ^ 2 - v) ^ 2 / ((f + w ^ 2) ^ 2 + (w * g) ^ 2).
Proof.
  intros Hf Hg v top. destruct (strongest_root f g Hf Hg) as [[V0 V1] EQ]. fold v in V0, V1, EQ.
  pose proof (below_pos f g w Hf Hg) as HD. unfold gain2, top.
  assert (FV : 0 < f ^ 2 - v ^ 2) by nra.
  assert (G : g ^ 2 = (- 2 * f ^ 3 - 2 * f ^ 2 * v) / v ^ 2).
  { rewrite <- EQ. field. lra. }
  set (D := (f + w ^ 2) ^ 2 + (w * g) ^ 2) in *.
  apply (Rmult_eq_reg_r ((f ^ 2 - v ^ 2) * D)); [|apply Rgt_not_eq, Rmult_lt_0_compat; assumption].
  transitivity (f ^ 2 * D - (f ^ 2 - v ^ 2) * (f ^ 2 + (w * g) ^ 2)); [field; split; lra|].
  transitivity (f ^ 2 * (w ^ 2 - v) ^ 2); [|field; split; lra].
  unfold D. replace ((w * g) ^ 2) with (w ^ 2 * g ^ 2) by ring. rewrite G. field. lra.
Qed.

Theorem gain_strongest f g w : f < 0 -> g < 0 ->
  let v := strongest f g in v < Rabs f /\
  (w ^ 2 = v -> forall w', Cmod (/ gamma f g w')%C <= Cmod (/ gamma f g w)%C) /\
  (w ^ 2 <> v -> exists w', Cmod (/ gamma f g w)%C < Cmod (/ gamma f g w')%C).
Proof.
  intros Hf Hg v. destruct (strongest_root f g Hf Hg) as [[V0 V1] EQ]. fold v in V0, V1, EQ.
  assert (FV : 0 < f ^ 2 - v ^ 2) by nra.
  assert (T : 0 < f ^ 2 / (f ^ 2 - v ^ 2)) by (apply Rdiv_lt_0_compat; [apply pow2_gt_0; lra|lra]).
  set (top := f ^ 2 / (f ^ 2 - v ^ 2)) in *.
  assert (D : forall w, top - gain2 f g w = top * (w ^ 2 - v) ^ 2 / ((f + w ^ 2) ^ 2 + (w * g) ^ 2))
    by (intros; now apply gain2_deficit).
  assert (AT : forall y, y ^ 2 = v -> gain2 f g y = top).
  { intros y Hy. specialize (D y). rewrite Hy in D. replace ((v - v) ^ 2) with 0 in D by ring.
    unfold Rdiv in D. rewrite Rmult_0_r, Rmult_0_l in D. lra. }
  split; [rewrite Rabs_left; lra|]. split.
  - intros Hw w'. apply Rsqr_incr_0; try apply Cmod_ge_0. rewrite !Rsqr_pow2, !gain2_spec by assumption.
    rewrite (AT w Hw). specialize (D w').
    assert (0 <= top * (w' ^ 2 - v) ^ 2 / ((f + w' ^ 2) ^ 2 + (w' * g) ^ 2)); [|lra].
    apply Rcomplements.Rdiv_le_0_compat; [|now apply below_pos]. apply Rmult_le_pos; [lra|apply pow2_ge_0].
  - intros Hw. exists (sqrt v).
    apply Rsqr_incrst_0; try apply Cmod_ge_0. rewrite !Rsqr_pow2, !gain2_spec by assumption.
    rewrite (AT (sqrt v)) by (rewrite pow2_sqrt; lra). specialize (D w).
    assert (0 < top * (w ^ 2 - v) ^ 2 / ((f + w ^ 2) ^ 2 + (w * g) ^ 2)); [|lra].
    apply Rdiv_lt_0_compat; [|now apply below_pos]. apply Rmult_lt_0_compat; [lra|]. apply pow2_gt_0. lra.
Qed.

(* f = g = -1: at w^2 = sqrt 3 - 1 *)
Theorem strongest_unit : strongest (-1) (-1) = sqrt 3 - 1.
Proof.
  unfold strongest. rewrite Rabs_left by lra. replace (1 + 2 * (-1) ^ 2 / - -1) with 3 by field. field.
Qed.

(* the printed place w^2 = |f| is never the strongest one *)
Theorem gain_max_printed_fails f g w : f < 0 -> g < 0 -> w ^ 2 = Rabs f ->
  exists w', Cmod (/ gamma f g w)%C < Cmod (/ gamma f g w')%C.
Proof.
  intros Hf Hg Hw. destruct (gain_strongest f g w Hf Hg) as [L [_ H]]. apply H. lra.
Qed.

(* ---- veerman.sep_remark ---- *)
(* cars at h_k + Re(a_0 gamma^-k e^{i w t}), h_{k+1} - h_k = 1 *)
Definition position (a0 : R) (h : nat -> R) (gam : C) (w : R) (k : nat) (t : R) : R :=
  h k + fst (RtoC a0 * (Cpw (/ gam)%C k * cis (w * t)))%C.
Theorem separation a0 h gam w k t : h (S k) - h k = 1 ->
  position a0 h gam w (S k) t - position a0 h gam w k t
  = a0 * fst (Cpw (/ gam)%C (S k) * cis (w * t))%C - a0 * fst (Cpw (/ gam)%C k * cis (w * t))%C + 1.
Proof.
  intros H. unfold position. set (z := (Cpw (/ gam)%C (S k) * cis (w * t))%C).
  set (y := (Cpw (/ gam)%C k * cis (w * t))%C). cbn [Cmult RtoC fst snd]. lra.
Qed.
Theorem separation_printed_fails a0 h gam w k t : 0 < a0 -> h (S k) - h k = 1 ->
  position a0 h gam w (S k) t - position a0 h gam w k t
  <> a0 * fst (Cpw (/ gam)%C (S k) * cis (w * t))%C - a0 * fst (Cpw (/ gam)%C k * cis (w * t) + 1)%C.
Proof.
  intros A H E. rewrite (separation a0 h gam w k t H) in E. cbn [Cplus fst RtoC] in E. lra.
Qed.

(* ---- veerman.prop1 ---- *)
(* at the frequency sqrt|f| the amplitude of car k is a_0 (1 + |f|/g^2)^{k/2} *)
Lemma gain_at_f f g : f < 0 -> g < 0 -> Cmod (/ gamma f g (sqrt (Rabs f)))%C ^ 2 = 1 + Rabs f / g ^ 2.
Proof.
  intros Hf Hg. rewrite gain2_spec by assumption. unfold gain2. rewrite Rabs_left by assumption.
  rewrite Rpow_mult_distr, pow2_sqrt by lra. field. split; [lra|].
  replace ((f + - f) ^ 2 + - f * g ^ 2) with (- f * g ^ 2) by ring. apply Rgt_not_eq, Rmult_lt_0_compat; [lra|]. apply pow2_gt_0. lra.
Qed.
Theorem proposition_1 f g a0 D N : f < 0 -> g < 0 -> 0 < a0 -> 0 < D ->
  let A := a0 * Cmod (Cpw (/ gamma f g (sqrt (Rabs f)))%C (S N)) in
  A <= D <-> INR (S N) <= 2 * ln (D / a0) / ln (1 + Rabs f / g ^ 2).
Proof.
  intros Hf Hg Ha HD A. unfold A. rewrite Cmod_Cpw. pose proof (gain_at_f f g Hf Hg) as E.
  set (m := Cmod (/ gamma f g (sqrt (Rabs f)))%C) in *.
  assert (Q : 0 < Rabs f / g ^ 2).
  { apply Rdiv_lt_0_compat; [apply Rabs_pos_lt; lra | apply pow2_gt_0; lra]. }
  assert (M0 : 0 <= m) by apply Cmod_ge_0.
  assert (M1 : 1 < m).
  { destruct (Rlt_le_dec 1 m) as [H|H]; [exact H|exfalso].
    assert (m * m <= 1 * 1) by (apply Rmult_le_compat; lra). replace (m ^ 2) with (m * m) in E by ring. lra. }
  rewrite <- E. rewrite (ln_pow m) by lra. cbn [INR].
  assert (L0 : 0 < ln m) by (rewrite <- ln_1; apply ln_increasing; lra).
  assert (P0 : 0 < m ^ S N) by (apply pow_lt; lra).
  transitivity (INR (S N) * ln m <= ln (D / a0)).
  - rewrite <- ln_pow by lra. split; intros H.
    + apply Rcomplements.ln_le; [exact P0|]. apply (proj1 (Rcomplements.Rle_div_r (m ^ S N) D a0 Ha)). lra.
    + destruct (Rle_lt_dec (m ^ S N) (D / a0)) as [L|L].
      * apply (proj2 (Rcomplements.Rle_div_r (m ^ S N) D a0 Ha)) in L. lra.
      * apply ln_increasing in L; [lra|]. apply Rdiv_lt_0_compat; lra.
  - replace (2 * ln (D / a0) / ((1 + 1) * ln m)) with (ln (D / a0) / ln m) by (field; lra).
    apply (Rcomplements.Rle_div_r _ _ _ L0).
Qed.
(* at the printed frequency |f| there need be no limit at all: f = -4, g = -1 damps *)
Theorem proposition_1_printed_fails :
  ~ (forall f g a0 D N, f < 0 -> g < 0 -> 0 < a0 -> a0 < D ->
      a0 * Cmod (Cpw (/ gamma f g (Rabs f))%C (S N)) <= D -> INR N <= 2 * ln (D / a0) / ln (1 + Rabs f / g ^ 2)).
Proof.
  intros H. pose proof (gain2_spec (-4) (-1) (Rabs (-4)) ltac:(lra) ltac:(lra)) as G.
  assert (R4 : Rabs (-4) = 4) by (rewrite Rabs_left; lra). rewrite R4 in G.
  unfold gain2 in G. pose proof (Cmod_ge_0 (/ gamma (-4) (-1) 4)%C) as M0.
  set (m := Cmod (/ gamma (-4) (-1) 4)%C) in *.
  assert (M1 : m <= 1).
  { destruct (Rle_lt_dec m 1) as [L|L]; [exact L|exfalso].
    assert (1 * 1 <= m * m) by (apply Rmult_le_compat; lra). replace (m ^ 2) with (m * m) in G by ring. lra. }
  destruct (nfloor_ex (2 * ln (2 / 1) / ln (1 + 4 / (-1) ^ 2)) ) as [N [_ HN]].
  { apply Rcomplements.Rdiv_le_0_compat.
    - assert (0 < ln 2) by (rewrite <- ln_1; apply ln_increasing; lra). replace (2 / 1) with 2 by field. lra.
    - rewrite <- ln_1. apply ln_increasing; [lra|]. replace (1 + 4 / (-1) ^ 2) with 5 by field. lra. }
  specialize (H (-4) (-1) 1 2 (S N) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra)).
  rewrite R4, Cmod_Cpw in H. fold m in H. rewrite S_INR in H. cbn [INR] in H.
  assert (m ^ S (S N) <= 1) by (rewrite <- (pow1 (S (S N))); apply pow_incr; lra).
  specialize (H ltac:(lra)). lra.
Qed.
