(* Veerman, Stosic, Olvera, Theorem 1: the root of gamma^2 - 1 for small frequencies.
     veerman.thm1_eps (corrected), beyond.veerman.thm1_eps. *)
From Coq Require Import Reals Lra Lia Psatz.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import veerman_complex veerman_front.
Open Scope R_scope.

(* i sqrt 2 (w/sqrt|f|) ((1 - i w |g|/(2|f|)) + (w^2/2) (- (3/4) g^2/f^2 - 1/(2|f|))) *)
Definition eps_series (f g w : R) : C := (Ci * RtoC (sqrt 2) * RtoC (w / sqrt (Rabs f)) *
  ((RtoC 1 - Ci * RtoC (w * Rabs g / (2 * Rabs f))) + RtoC (w ^ 2 / 2 * (- (3 / 4) * (g ^ 2 / f ^ 2) - 1 / (2 * Rabs f)))))%C.
Section Root.
Variables (f g : R).
Hypothesis Hf : f < 0.
Hypothesis Hg : g < 0.
Notation s := (sqrt (- f)).
Notation b := (- g / s).
Notation c := (- (3 * b ^ 2 / 8 + / 4)).
Notation e := (c + b ^ 2 / 2).
Definition re u := u ^ 4 * (e ^ 2 - b ^ 2 * c) - b ^ 2 * c ^ 2 * u ^ 6.
Definition im u := u ^ 3 * b * (2 * c + e) + 2 * e * b * c * u ^ 5.
Lemma s_pos : 0 < s.
Proof. apply sqrt_lt_R0. lra. Qed.
Lemma s_sqr : s * s = - f.
Proof. apply sqrt_sqrt. lra. Qed.
Lemma b_pos : 0 < b.
Proof. apply Rdiv_lt_0_compat; [lra|exact s_pos]. Qed.
Definition q u : C := (1, u * b).
Definition part u : C := (1 + c * u ^ 2, - (u * b / 2)).
Lemma series_is u : eps_series f g (u * s) = (Ci * RtoC (sqrt 2 * u) * part u)%C.
Proof.
  pose proof s_pos as P. pose proof s_sqr as Q. unfold eps_series, part. rewrite !Rabs_left by lra. revert P Q. generalize (sqrt (- f)). intros t P Q.
  assert (E : f = - (t * t)) by lra. rewrite !E. apply injective_projections; cbn; field; lra.
Qed.
Lemma q_neq0 u : q u <> RtoC 0.
Proof. intros E. apply (f_equal fst) in E. cbn in E. lra. Qed.
Lemma gamma_q u : (gamma f g (u * s) * q u = q u - RtoC (u ^ 2))%C.
Proof.
  pose proof s_pos as P. pose proof s_sqr as Q.
  assert (D : den f g (u * s) = (RtoC f * q u)%C).
  { unfold q. revert P Q. generalize (sqrt (- f)). intros t P Q. assert (E : f = - (t * t)) by lra. rewrite !E. apply injective_projections; cbn; field; lra. }
  assert (N : num f g (u * s) = (RtoC f * (q u - RtoC (u ^ 2)))%C).
  { unfold q. revert P Q. generalize (sqrt (- f)). intros t P Q. assert (E : f = - (t * t)) by lra. rewrite !E. apply injective_projections; cbn; field; lra. }
  unfold gamma. rewrite N, D. assert (F : RtoC f <> RtoC 0) by (intros E; injection E; lra). pose proof (q_neq0 u). field. split; assumption.
Qed.
(* the squares agree up to the fifth power *)
Lemma squares u : ((gamma f g (u * s) * gamma f g (u * s) - 1 - eps_series f g (u * s) * eps_series f g (u * s)) * (q u * q u) = RtoC (2 * u ^ 2) * (re u, im u))%C.
Proof.
  assert (A : (gamma f g (u * s) * gamma f g (u * s) * (q u * q u) = (q u - RtoC (u ^ 2)) * (q u - RtoC (u ^ 2)))%C) by (rewrite <- gamma_q; ring).
  assert (K : (eps_series f g (u * s) * eps_series f g (u * s) = - RtoC (2 * u ^ 2) * (part u * part u))%C).
  { rewrite series_is. replace (Ci * RtoC (sqrt 2 * u) * part u * (Ci * RtoC (sqrt 2 * u) * part u))%C with (Ci * Ci * (RtoC (sqrt 2 * u) * RtoC (sqrt 2 * u)) * (part u * part u))%C by ring.
    f_equal. rewrite <- RtoC_mult. replace (sqrt 2 * u * (sqrt 2 * u)) with (sqrt 2 * sqrt 2 * u ^ 2) by ring. rewrite sqrt_sqrt by lra. apply injective_projections; cbn; ring. }
  replace ((gamma f g (u * s) * gamma f g (u * s) - 1 - eps_series f g (u * s) * eps_series f g (u * s)) * (q u * q u))%C with
    (gamma f g (u * s) * gamma f g (u * s) * (q u * q u) - q u * q u - (eps_series f g (u * s) * eps_series f g (u * s)) * (q u * q u))%C by ring.
  rewrite A, K. unfold q, part, re, im. set (y := b). apply injective_projections; cbn; field.
Qed.
Definition K0 := 2 * (Rabs (e ^ 2 - b ^ 2 * c) + b ^ 2 * c ^ 2 + Rabs (b * (2 * c + e)) + Rabs (2 * e * b * c)) + 1.
Lemma K0_pos : 0 < K0.
Proof.
  unfold K0. pose proof (Rabs_pos (e ^ 2 - b ^ 2 * c)). pose proof (Rabs_pos (b * (2 * c + e))). pose proof (Rabs_pos (2 * e * b * c)).
  assert (0 <= b ^ 2 * c ^ 2) by (apply Rmult_le_pos; apply pow2_ge_0). lra.
Qed.
Lemma squares_near u : 0 < u <= 1 -> Cmod (gamma f g (u * s) * gamma f g (u * s) - 1 - eps_series f g (u * s) * eps_series f g (u * s))%C <= K0 * u ^ 5.
Proof.
  intros Hu. set (d := (gamma f g (u * s) * gamma f g (u * s) - 1 - eps_series f g (u * s) * eps_series f g (u * s))%C). pose proof (squares u) as E. fold d in E.
  assert (Q1 : 1 <= Cmod (q u)). { pose proof (Cmod_parts (q u)) as [P _]. cbn in P. lra. }
  assert (B : Cmod d <= 2 * u ^ 2 * Cmod (re u, im u)).
  { apply (f_equal Cmod) in E. rewrite !Cmod_mult, Cmod_R, Rabs_pos_eq in E by nra. rewrite <- E. rewrite <- (Rmult_1_r (Cmod d)) at 1. apply Rmult_le_compat_l; [apply Cmod_ge_0|nra]. }
  assert (P3 : u ^ 4 <= u ^ 3 /\ u ^ 5 <= u ^ 3 /\ u ^ 6 <= u ^ 3 /\ 0 <= u ^ 3).
  { assert (Z : 0 <= u ^ 3) by (apply pow_le; lra). assert (M : forall x, x <= 1 -> u ^ 3 * x <= u ^ 3) by (intros x Hx; rewrite <- (Rmult_1_r (u ^ 3)) at 2; now apply Rmult_le_compat_l).
    assert (U2 : u * u <= 1 * 1) by (apply Rmult_le_compat; lra). assert (U3 : u * u * u <= 1 * 1 * 1) by (apply Rmult_le_compat; try lra; apply Rmult_le_pos; lra).
    replace (u ^ 4) with (u ^ 3 * u) by ring. replace (u ^ 5) with (u ^ 3 * (u * u)) by ring. replace (u ^ 6) with (u ^ 3 * (u * u * u)) by ring.
    repeat split; try exact Z; apply M; lra. }
  assert (R : Cmod (re u, im u) <= (K0 - 1) / 2 * u ^ 3).
  { assert (C : Cmod (re u, im u) <= Rabs (re u) + Rabs (im u)).
    { replace (re u, im u) with (RtoC (re u) + Ci * RtoC (im u))%C by (apply injective_projections; cbn; ring). eapply Rle_trans; [apply Cmod_triangle|].
      rewrite Cmod_mult, !Cmod_R. replace (Cmod Ci) with 1; [lra|]. unfold Cmod, Ci; cbn. replace (0 * (0 * 1) + 1 * (1 * 1)) with 1 by ring. now rewrite sqrt_1. }
    eapply Rle_trans; [exact C|]. assert (A : 0 <= b ^ 2 * c ^ 2) by (apply Rmult_le_pos; apply pow2_ge_0).
    assert (T1 : Rabs (re u) <= (Rabs (e ^ 2 - b ^ 2 * c) + b ^ 2 * c ^ 2) * u ^ 3).
    { unfold re. unfold Rminus at 1. eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_Ropp, !Rabs_mult, (Rabs_pos_eq (u ^ 4)), (Rabs_pos_eq (u ^ 6)) by (apply pow_le; lra).
      rewrite (Rabs_pos_eq (b ^ 2)), (Rabs_pos_eq (c ^ 2)) by apply pow2_ge_0. pose proof (Rabs_pos (e ^ 2 - b ^ 2 * c)).
      apply Rle_trans with (u ^ 3 * Rabs (e ^ 2 - b ^ 2 * c) + b ^ 2 * c ^ 2 * u ^ 3); [apply Rplus_le_compat; [apply Rmult_le_compat_r|apply Rmult_le_compat_l]; tauto|lra]. }
    assert (T2 : Rabs (im u) <= (Rabs (b * (2 * c + e)) + Rabs (2 * e * b * c)) * u ^ 3).
    { unfold im. replace (u ^ 3 * b * (2 * c + e)) with (u ^ 3 * (b * (2 * c + e))) by ring. eapply Rle_trans; [apply Rabs_triang|].
      rewrite (Rabs_mult (u ^ 3)), (Rabs_mult (2 * e * b * c)), (Rabs_pos_eq (u ^ 3)), (Rabs_pos_eq (u ^ 5)) by (apply pow_le; lra). pose proof (Rabs_pos (2 * e * b * c)).
      assert (Rabs (2 * e * b * c) * u ^ 5 <= Rabs (2 * e * b * c) * u ^ 3) by (apply Rmult_le_compat_l; tauto). lra. }
    unfold K0. lra. }
  eapply Rle_trans; [exact B|]. assert (0 <= u ^ 2) by nra. apply Rle_trans with (2 * u ^ 2 * ((K0 - 1) / 2 * u ^ 3)); [apply Rmult_le_compat_l; lra|].
  replace (2 * u ^ 2 * ((K0 - 1) / 2 * u ^ 3)) with ((K0 - 1) * u ^ 5) by field. assert (0 <= u ^ 5) by (apply pow_le; lra). nra.
Qed.
(* veerman.thm1_eps, corrected: the principal root is within O(w^4) of the series *)
Theorem thm1_eps : exists K w0, 0 < K /\ 0 < w0 /\ forall w, 0 < w < w0 ->
  Cmod (Csqrt (gamma f g w * gamma f g w - 1) - eps_series f g w)%C <= K * w ^ 4.
Proof.
  pose proof s_pos as S. pose proof b_pos as B. pose proof K0_pos as KP. pose proof s_sqr as SS.
  assert (C0 : 0 <= - c) by (pose proof (pow2_ge_0 b); lra).
  set (u1 := Rmin 1 (Rmin (/ (2 * (- c + 1))) (b / (4 * K0)))).
  assert (U1 : 0 < u1) by (repeat apply Rmin_glb_lt; [lra|apply Rinv_0_lt_compat; lra|apply Rdiv_lt_0_compat; lra]).
  exists (2 * K0 / s ^ 4), (u1 * s). split; [apply Rdiv_lt_0_compat; [lra|now apply pow_lt]|]. split; [now apply Rmult_lt_0_compat|]. intros w Hw. set (u := w / s).
  assert (Hu : 0 < u < u1). { unfold u. split; [apply Rdiv_lt_0_compat; lra|]. apply Rmult_lt_reg_r with s; [exact S|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l; lra. }
  assert (Ew : w = u * s) by (unfold u; field; lra). rewrite Ew.
  assert (L : u < 1 /\ u < / (2 * (- c + 1)) /\ u < b / (4 * K0)).
  { pose proof (Rmin_l 1 (Rmin (/ (2 * (- c + 1))) (b / (4 * K0)))). pose proof (Rmin_r 1 (Rmin (/ (2 * (- c + 1))) (b / (4 * K0)))).
    pose proof (Rmin_l (/ (2 * (- c + 1))) (b / (4 * K0))). pose proof (Rmin_r (/ (2 * (- c + 1))) (b / (4 * K0))). unfold u1 in Hu. lra. }
  destruct L as (L1 & L2 & L3). pose proof (squares_near u ltac:(lra)) as N. set (gg := (gamma f g (u * s) * gamma f g (u * s) - 1)%C) in *. set (a := eps_series f g (u * s)) in *.
  set (r := Csqrt gg). assert (Er : (r * r)%C = gg) by apply Csqrt_sqr.
  assert (Pr : 0 <= fst r) by (destruct (Csqrt_angle gg) as [H|[H _]]; fold r in H; lra).
  assert (F : Cmod (r - a)%C * Cmod (r + a)%C <= K0 * u ^ 5).
  { rewrite <- Cmod_mult. replace ((r - a) * (r + a))%C with (r * r - a * a)%C by ring. rewrite Er. exact N. }
  assert (A1 : fst a = sqrt 2 * u * (u * b / 2) /\ snd a = sqrt 2 * u * (1 + c * u ^ 2)).
  { unfold a. rewrite series_is. unfold part. split; cbn; ring. }
  destruct A1 as [A1 A2]. assert (R2 : 1 <= sqrt 2) by (rewrite <- sqrt_1; apply sqrt_le_1_alt; lra).
  assert (Cu : - / 2 <= c * u ^ 2).
  { assert (- c * u ^ 2 <= / 2); [|lra]. assert (u * (2 * (- c + 1)) < 1). { apply Rmult_lt_compat_r with (r := 2 * (- c + 1)) in L2; [|lra]. rewrite Rinv_l in L2 by lra. exact L2. }
    assert (- c * u <= / 2) by lra. replace (- c * u ^ 2) with (- c * u * u) by ring. assert (0 <= - c * u) by (apply Rmult_le_pos; lra). nra. }
  assert (A3 : u / 2 <= snd a).
  { rewrite A2. replace (u / 2) with (1 * u * / 2) by field. apply Rmult_le_compat; try lra. apply Rmult_le_compat_r; lra. }
  assert (A4 : u ^ 2 * b / 2 <= fst a).
  { rewrite A1. replace (u ^ 2 * b / 2) with (1 * (u * (u * b / 2))) by (unfold Rdiv; ring). rewrite Rmult_assoc. apply Rmult_le_compat_r; [|exact R2].
    apply Rmult_le_pos; [lra|]. assert (0 <= u * b) by (apply Rmult_le_pos; lra). lra. }
  assert (A5 : u / 2 <= Cmod a) by (pose proof (Rmax_Cmod a); pose proof (Rmax_r (Rabs (fst a)) (Rabs (snd a))); pose proof (Rle_abs (snd a)); lra).
  assert (P5 : u ^ 5 = u * u ^ 4) by ring. assert (P4 : 0 <= u ^ 4) by (apply pow_le; lra).
  destruct (Rlt_or_le (Cmod (r + a)%C) (u / 2)) as [H|H].
  - exfalso. pose proof (Cmod_triangle (r + a)%C (- (r - a))%C) as T. rewrite Cmod_opp in T. replace (r + a + - (r - a))%C with (a + a)%C in T by ring.
    replace (a + a)%C with (RtoC 2 * a)%C in T by (rewrite C2; ring). rewrite Cmod_mult, Cmod_R, Rabs_pos_eq in T by lra.
    pose proof (Cmod_ge_0 (r + a)%C) as P0.
    assert (T2 : u / 2 <= Cmod (r - a)%C) by lra. assert (Z : Cmod (r + a)%C <= 2 * K0 * u ^ 4).
    { apply Rmult_le_reg_l with (u / 2); [lra|]. apply Rle_trans with (K0 * u ^ 5); [|rewrite P5; right; field]. apply Rle_trans with (2 := F). now apply Rmult_le_compat_r. }
    assert (Y : u ^ 2 * b / 2 <= 2 * K0 * u ^ 4).
    { apply Rle_trans with (2 := Z). pose proof (Cmod_parts (r + a)%C) as [Q _]. change (fst (r + a)%C) with (fst r + fst a) in Q. lra. }
    assert (u * (4 * K0) < b). { apply Rmult_lt_compat_r with (r := 4 * K0) in L3; [|lra]. unfold Rdiv in L3. rewrite Rmult_assoc, Rinv_l in L3; lra. }
    assert (0 < u ^ 2) by (apply pow_lt; lra). replace (u ^ 4) with (u ^ 2 * u ^ 2) in Y by ring. assert (u ^ 2 <= u) by nra.
    assert (b / 2 <= 2 * K0 * u ^ 2) by (apply Rmult_le_reg_l with (u ^ 2); [assumption|lra]). assert (2 * K0 * u ^ 2 <= 2 * K0 * u) by (apply Rmult_le_compat_l; lra). lra.
  - apply Rmult_le_reg_r with (u / 2); [lra|]. replace (2 * K0 / s ^ 4 * (u * s) ^ 4 * (u / 2)) with (K0 * u ^ 5) by (field; lra).
    apply Rle_trans with (2 := F). apply Rmult_le_compat_l; [apply Cmod_ge_0|exact H].
Qed.
End Root.
