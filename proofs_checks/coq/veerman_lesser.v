(* Veerman, Stosic, Olvera, Corollary 3: lesser resonances near the odd multiples of the main one.
     veerman.cor3 (both clauses), for a fixed multiple and large flocks.
   At tau times the frequency of Theorem 1 the angle M x is tau pi/2 + O(M^-2) and M y is O(1/M): |a_M|^-2 is small at tau = 2k - 1 and
   not at tau = 2k - 1 +- e, so that a local maximum lies between. *)
From Coq Require Import Reals Lra Lia Psatz.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums veerman_complex veerman_front veerman_chain veerman_stability veerman_amplitude.
From Flockproof Require Import veerman_coordinates veerman_bounds veerman_window veerman_theorem1.
From Flockproof Require veerman_numbers.
Open Scope R_scope.

Lemma angle_close f g w : f < 0 -> g < 0 -> 0 < w ->
  let a2 := w ^ 2 / - f in let beta := g ^ 2 / - f in let s := sqrt (a2 / 2) in a2 <= / 2 -> 3 * beta * a2 <= 1 ->
  exists x y, 0 <= x /\ 0 <= y /\ s * (1 - 3 * beta * a2) <= x / 2 <= s + 4 * s ^ 3 /\ y ^ 2 <= beta * a2 ^ 2 /\
  forall N, quiet f g N w = cos (INR (S N) * x) ^ 2 + sinh (INR (S N) * y) ^ 2.
Proof.
  intros Hf Hg Hw a2 beta s A2 BA. destruct (positives f g w Hf Hg Hw) as (B & A & C). fold beta a2 in B, A, C.
  destruct (frequency_coordinates f g w Hf Hg Hw) as (x & y & X & Y & F & Im & R1 & R2 & P2 & _).
  pose proof (sinh_upper f g w Hf Hg Hw x y Im R1 R2 P2) as Up. fold beta a2 in Im, R1, R2, P2, Up. specialize (Up ltac:(lra)).
  set (c := beta * a2) in *. pose proof (pow2_ge_0 (sinh y)) as S0. pose proof (cosh_sqr y) as CS. set (S := sinh y ^ 2) in *.
  pose proof (cosh_ge1 y) as C1. pose proof PI_RGT_0 as P0. pose proof PI_4 as P4.
  assert (SB : S <= beta * a2 ^ 2) by (assert (0 <= (1 - a2) * S) by (apply Rmult_le_pos; lra); lra).
  assert (SY : y <= sinh y) by now apply sinh_ge.
  set (r := cosh y - cos x) in *.
  assert (RL : a2 - r <= beta * a2 ^ 2).
  { apply (Rmult_le_reg_r (a2 + r)); [lra|]. replace ((a2 - r) * (a2 + r)) with (a2 ^ 2 - r ^ 2) by ring. rewrite R2.
    replace (a2 ^ 2 - a2 ^ 2 / (1 + c)) with (a2 ^ 2 * c / (1 + c)) by (field; lra).
    assert (a2c : 0 < a2 ^ 2 * c) by (apply Rmult_lt_0_compat; [apply pow_lt|]; lra).
    apply Rle_trans with (a2 ^ 2 * c).
    - apply (Rmult_le_reg_r (1 + c)); [lra|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. assert (0 <= a2 ^ 2 * c * c) by (apply Rmult_le_pos; lra). lra.
    - replace (a2 ^ 2 * c) with (beta * a2 ^ 2 * a2) by (unfold c; ring). apply Rmult_le_compat_l; [apply Rmult_le_pos; [lra|apply pow2_ge_0]|lra]. }
  assert (CY : cosh y - 1 <= S / 2) by nra.
  assert (s0 : 0 < s) by (unfold s; apply sqrt_lt_R0; lra). assert (s2 : s ^ 2 = a2 / 2) by (unfold s; apply pow2_sqrt; lra).
  set (u := x / 2). assert (U : 0 <= u <= PI / 2) by (unfold u; lra). assert (OC : 1 - cos x = 2 * sin u ^ 2) by apply one_minus_cos.
  assert (Su : 0 <= sin u) by (apply sin_ge_0; lra).
  assert (SU : sin u <= s) by (apply Rsqr_incr_0_var; [|lra]; rewrite !Rsqr_pow2, s2; unfold r in *; lra).
  assert (SL : s * (1 - 3 * beta * a2) <= sin u).
  { apply Rsqr_incr_0_var; [|lra]. rewrite !Rsqr_pow2, Rpow_mult_distr, s2. replace (3 * beta * a2) with (3 * c) in * by (unfold c; ring).
    assert (Q : 2 * sin u ^ 2 >= a2 * (1 - 3 / 2 * c)) by (unfold r, c in *; lra).
    assert (0 <= a2 * (c * (9 / 2 - 9 * c))) by (apply Rmult_le_pos; [lra|apply Rmult_le_pos; lra]). lra. }
  assert (U2 : u <= 2 * s).
  { pose proof (jordan u U) as J. apply Rle_trans with (PI / 2 * sin u).
    - apply (Rmult_le_compat_l (PI / 2)) in J; [|lra]. replace (PI / 2 * (2 / PI * u)) with u in J by (field; lra). exact J.
    - apply Rmult_le_compat; lra. }
  assert (UL : u - u ^ 3 / 2 <= sin u).
  { destruct (MVT_le sin cos 0 u ltac:(lra)) as (p & P & E); [intros; apply is_derive_sin|]. rewrite sin_0 in E.
    assert (cos u <= cos p) by (apply cos_decr_1; lra). pose proof (one_minus_cos u) as O.
    assert (H2 : sin (u / 2) <= u / 2) by (destruct (proj1 U) as [U0|U0]; [left; apply sin_lt_x; lra|rewrite <- U0; replace (0 / 2) with 0 by field; rewrite sin_0; lra]).
    assert (0 <= sin (u / 2)) by (apply sin_ge_0; lra). assert (sin (u / 2) ^ 2 <= (u / 2) ^ 2) by (apply pow_incr; lra).
    assert ((1 - u ^ 2 / 2) * u <= cos p * u) by (apply Rmult_le_compat_r; lra). lra. }
  assert (u3 : u ^ 3 <= (2 * s) ^ 3) by (apply pow_incr; lra).
  assert (Uu : sin u <= u) by (destruct (proj1 U) as [U0|U0]; [left; now apply sin_lt_x|rewrite <- U0, sin_0; lra]).
  exists x, y. split; [lra|]. split; [exact Y|]. split; [fold u; lra|]. split.
  - apply Rle_trans with S; [apply pow_incr; lra|exact SB].
  - intros N. pose proof (amplitude_pos f g N w Hf Hg) as A0. unfold quiet.
    apply (Rmult_eq_reg_l (amplitude f g N w ^ 2)); [|apply pow_nonzero; lra]. rewrite F. apply Rinv_r, pow_nonzero. lra.
Qed.

(* at tau times the frequency of Theorem 1 *)
Lemma near_multiple f g tau top : f < 0 -> g < 0 -> 0 < tau <= top -> 1 <= top -> let beta := g ^ 2 / - f in
  forall N, let M := INR (S N) in 4 * top ^ 2 * (1 + 2 * beta) <= M -> exists ang v,
    Rabs (ang - tau * (PI / 2)) <= (12 * beta + 8) * top ^ 3 / M /\ 0 <= v <= 2 * (1 + beta) * top ^ 2 / M /\
    quiet f g N (tau * veerman_numbers.frequency f M) = cos ang ^ 2 + sinh v ^ 2.
Proof.
  intros Hf Hg T T1 beta N M HM. assert (B : 0 < beta) by (apply Rdiv_lt_0_compat; [apply pow2_gt_0|]; lra).
  pose proof (M_ge1 N) as M1. fold M in M1. pose proof PI_RGT_0 as P0. pose proof PI_4 as P4.
  assert (SF : 0 < sqrt (- f)) by (apply sqrt_lt_R0; lra). assert (SF2 : sqrt (- f) * sqrt (- f) = - f) by (apply sqrt_sqrt; lra).
  assert (R2 : 0 < sqrt 2) by (apply sqrt_lt_R0; lra). assert (R22 : sqrt 2 * sqrt 2 = 2) by (apply sqrt_sqrt; lra).
  set (w0 := veerman_numbers.frequency f M). assert (w0E : w0 = sqrt (- f) * PI / (M * 2 * sqrt 2)) by (unfold w0, veerman_numbers.frequency; now rewrite Rabs_left).
  assert (w00 : 0 < w0) by (rewrite w0E; apply Rdiv_lt_0_compat; apply Rmult_lt_0_compat; lra).
  assert (Hw : 0 < tau * w0) by (apply Rmult_lt_0_compat; lra).
  set (s := tau * PI / (4 * M)). assert (s0 : 0 < s) by (unfold s; apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat|]; lra).
  assert (AE : (tau * w0) ^ 2 / - f = 2 * s ^ 2).
  { rewrite w0E. unfold s. replace ((tau * (sqrt (- f) * PI / (M * 2 * sqrt 2))) ^ 2) with ((sqrt (- f) * sqrt (- f)) * tau ^ 2 * PI ^ 2 / (4 * M ^ 2 * (sqrt 2 * sqrt 2))) by (field; lra).
    rewrite SF2, R22. field. lra. }
  assert (sT : s <= top / M).
  { unfold s. apply (Rmult_le_reg_r (4 * M)); [lra|]. replace (tau * PI / (4 * M) * (4 * M)) with (tau * PI) by (field; lra). replace (top / M * (4 * M)) with (top * 4) by (field; lra).
    apply Rmult_le_compat; lra. }
  assert (t2 : 1 <= top ^ 2) by nra. assert (t20 : 0 < top ^ 2) by lra.
  set (h := / M). assert (h0 : 0 < h) by (unfold h; apply Rinv_0_lt_compat; lra). assert (hM : h * M = 1) by (unfold h; field; lra).
  assert (h1 : h <= 1) by (unfold h; rewrite <- Rinv_1; apply Rinv_le_contravar; lra).
  assert (hT : h * (4 * top ^ 2 * (1 + 2 * beta)) <= 1) by (apply Rle_trans with (h * M); [apply Rmult_le_compat_l; lra|lra]).
  assert (D : forall z, z / M = z * h) by (intros; reflexivity). rewrite !D in *.
  assert (s2 : s ^ 2 <= top ^ 2 * h * h) by (replace (top ^ 2 * h * h) with ((top * h) ^ 2) by ring; apply pow_incr; lra).
  assert (th : 0 < top ^ 2 * h) by (apply Rmult_lt_0_compat; lra). assert (tbh : 0 < top ^ 2 * h * beta) by (apply Rmult_lt_0_compat; lra).
  assert (s21 : s ^ 2 <= top ^ 2 * h) by (assert (top ^ 2 * h * h <= top ^ 2 * h * 1) by (apply Rmult_le_compat_l; lra); lra).
  assert (A1 : 2 * s ^ 2 <= / 2) by lra.
  assert (A3 : 3 * beta * (2 * s ^ 2) <= 1) by (assert (beta * s ^ 2 <= beta * (top ^ 2 * h)) by (apply Rmult_le_compat_l; lra); lra).
  destruct (angle_close f g (tau * w0) Hf Hg Hw) as (x & y & X & Y & XB & YB & F); fold beta; rewrite ?AE; [exact A1|exact A3|]. fold beta in XB, YB. rewrite AE in XB, YB.
  replace (2 * s ^ 2 / 2) with (s ^ 2) in XB by field. rewrite sqrt_pow2 in XB by lra.
  exists (M * x), (M * y). split; [|split; [split|apply F]].
  - assert (MS : 2 * M * s = tau * (PI / 2)) by (unfold s; field; lra).
    assert (s3 : M * s ^ 3 <= top ^ 3 * h).
    { apply Rle_trans with (M * (top * h) ^ 3); [apply Rmult_le_compat_l; [lra|apply pow_incr; lra]|].
      replace (M * (top * h) ^ 3) with (top ^ 3 * h * h * (h * M)) by ring. rewrite hM.
      assert (0 < top ^ 3 * h) by (apply Rmult_lt_0_compat; [apply pow_lt|]; lra). assert (top ^ 3 * h * h <= top ^ 3 * h * 1) by (apply Rmult_le_compat_l; lra). lra. }
    assert (L1 : 2 * M * (s * (1 - 3 * beta * (2 * s ^ 2))) <= 2 * M * (x / 2)) by (apply Rmult_le_compat_l; lra).
    assert (L2 : 2 * M * (x / 2) <= 2 * M * (s + 4 * s ^ 3)) by (apply Rmult_le_compat_l; lra).
    assert (12 * beta * (M * s ^ 3) <= 12 * beta * (top ^ 3 * h)) by (apply Rmult_le_compat_l; lra).
    assert (0 <= 12 * beta * (top ^ 3 * h)) by (apply Rmult_le_pos; [lra|apply Rmult_le_pos; [apply pow_le|]; lra]).
    assert (0 <= top ^ 3 * h) by (apply Rmult_le_pos; [apply pow_le|]; lra).
    apply Rabs_le. lra.
  - apply Rmult_le_pos; lra.
  - assert (YY : y <= (1 + beta) * (2 * s ^ 2)).
    { apply Rsqr_incr_0_var; [|apply Rmult_le_pos; [lra|pose proof (pow2_ge_0 s); lra]]. rewrite !Rsqr_pow2. eapply Rle_trans; [exact YB|].
      apply Rle_trans with ((1 + beta) ^ 2 * (2 * s ^ 2) ^ 2); [|right; ring]. apply Rmult_le_compat_r; [apply pow2_ge_0|]. pose proof (pow2_ge_0 beta). lra. }
    apply Rle_trans with (M * ((1 + beta) * (2 * (top ^ 2 * h * h)))); [apply Rmult_le_compat_l; [lra|]; eapply Rle_trans; [exact YY|]; apply Rmult_le_compat_l; lra|].
    replace (M * ((1 + beta) * (2 * (top ^ 2 * h * h)))) with (2 * (1 + beta) * top ^ 2 * h * (h * M)) by ring. rewrite hM. lra.
Qed.

Lemma cos_sqr_near k z : cos ((2 * INR k - 1) * (PI / 2) + z) ^ 2 = sin z ^ 2.
Proof.
  rewrite cos_plus, cos_odd. pose proof (sin_sqr ((2 * INR k - 1) * (PI / 2))) as S. rewrite cos_odd in S.
  replace ((0 * cos z - sin ((2 * INR k - 1) * (PI / 2)) * sin z) ^ 2) with (sin ((2 * INR k - 1) * (PI / 2)) ^ 2 * sin z ^ 2) by ring. rewrite S. ring.
Qed.
Lemma sin_sqr_le z : sin z ^ 2 <= z ^ 2.
Proof.
  assert (H : forall v, 0 <= v <= 1 -> sin v ^ 2 <= v ^ 2).
  { intros v V. apply pow_incr. pose proof PI_RGT_0. pose proof PI2_1. split; [apply sin_ge_0; lra|].
    destruct (proj1 V) as [V0|V0]; [left; now apply sin_lt_x|rewrite <- V0, sin_0; lra]. }
  destruct (Rle_lt_dec (Rabs z) 1) as [L|L].
  - apply Rabs_le_between in L. destruct (Rle_lt_dec 0 z) as [P|P]; [apply H; lra|].
    replace (sin z ^ 2) with (sin (- z) ^ 2) by (rewrite sin_neg; ring). replace (z ^ 2) with ((- z) ^ 2) by ring. apply H; lra.
  - rewrite sin_sqr. pose proof (pow2_ge_0 (cos z)). rewrite <- (pow2_abs z).
    assert (Q : 1 ^ 2 <= Rabs z ^ 2) by (apply pow_incr; lra). lra.
Qed.

Definition local_maximum (F : R -> R) (w : R) : Prop := exists r, 0 < r /\ forall v, Rabs (v - w) < r -> F v <= F w.
Lemma maximum_inside (F : R -> R) lo mid hi : lo < mid < hi -> (forall w, continuity_pt F w) -> F lo < F mid -> F hi < F mid ->
  exists w, lo < w < hi /\ local_maximum F w.
Proof.
  intros B Co L H. destruct (continuity_ab_maj F lo hi ltac:(lra)) as (w & M & W); [intros c _; apply Co|].
  pose proof (M mid ltac:(lra)) as Mm. assert (W1 : lo < w) by (destruct (proj1 W) as [D|D]; [exact D|subst w; lra]).
  assert (W2 : w < hi) by (destruct (proj2 W) as [D|D]; [exact D|subst w; lra]).
  exists w. split; [lra|]. exists (Rmin (w - lo) (hi - w)). split; [apply Rmin_glb_lt; lra|]. intros v V. apply M.
  pose proof (Rmin_l (w - lo) (hi - w)). pose proof (Rmin_r (w - lo) (hi - w)). apply Rabs_def2 in V. lra.
Qed.

(* veerman.cor3: for every k and e, in large flocks a local maximum lies within e of 2k - 1 times the main resonance *)
Theorem corollary_3 f g k e : f < 0 -> g < 0 -> (1 <= k)%nat -> 0 < e -> exists M0, forall N, M0 <= INR (S N) ->
  forall main, main_resonance f g N main -> exists w, 0 < w /\ Rabs (w / main - (2 * INR k - 1)) <= e /\ local_maximum (amplitude f g N) w.
Proof.
  intros Hf Hg Hk He. destruct (theorem_1 f g Hf Hg) as (C & M1 & T). set (J := 2 * INR k - 1).
  assert (J1 : 1 <= J) by (unfold J; pose proof (le_INR 1 k Hk) as I; cbn [INR] in I; lra).
  set (d := Rmin (e / 4) (/ 2)). assert (d0 : 0 < d) by (unfold d; apply Rmin_glb_lt; lra). assert (d1 : d <= e / 4) by apply Rmin_l. assert (d2 : d <= / 2) by apply Rmin_r.
  set (beta := g ^ 2 / - f). assert (B : 0 < beta) by (apply Rdiv_lt_0_compat; [apply pow2_gt_0|]; lra). set (top := J + 1).
  set (A1 := (12 * beta + 8) * top ^ 3). set (A2 := 2 * (1 + beta) * top ^ 2).
  assert (A10 : 0 < A1) by (apply Rmult_lt_0_compat; [lra|apply pow_lt; unfold top; lra]). assert (A20 : 0 < A2) by (apply Rmult_lt_0_compat; [lra|apply pow_lt; unfold top; lra]).
  pose proof PI_RGT_0 as P0. pose proof PI_4 as P4. pose proof PI2_1 as P2. assert (SF : 0 < sqrt (- f)) by (apply sqrt_lt_R0; lra).
  assert (R2 : 0 < sqrt 2) by (apply sqrt_lt_R0; lra). assert (R2B : sqrt 2 <= 2) by (apply Rsqr_incr_0_var; [|lra]; rewrite Rsqr_sqrt by lra; unfold Rsqr; lra).
  set (w1 := sqrt (- f) * PI / (2 * sqrt 2)). assert (w10 : 0 < w1) by (unfold w1; apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat|]; lra).
  set (A3 := Rabs C * (J + e) / w1).
  exists (Rabs M1 + 4 * top ^ 2 * (1 + 2 * beta) + 8 * A1 / d + 24 * A2 / d + 4 * A3 / e + 2 * Rabs C / w1 + 1).
  intros N HM main W. pose proof (Rabs_pos C) as C0. pose proof (Rle_abs M1) as AM. pose proof (Rabs_pos M1) as AM0.
  assert (P1 : 0 < 8 * A1 / d) by (apply Rdiv_lt_0_compat; lra). assert (P3 : 0 < 24 * A2 / d) by (apply Rdiv_lt_0_compat; lra).
  assert (A30 : 0 <= A3) by (unfold A3; apply Rmult_le_pos; [apply Rmult_le_pos; lra|left; now apply Rinv_0_lt_compat]).
  assert (P5 : 0 <= 4 * A3 / e) by (apply Rmult_le_pos; [lra|left; now apply Rinv_0_lt_compat]).
  assert (P6 : 0 <= 2 * Rabs C / w1) by (apply Rmult_le_pos; [lra|left; now apply Rinv_0_lt_compat]).
  assert (P7 : 0 < 4 * top ^ 2 * (1 + 2 * beta)) by (apply Rmult_lt_0_compat; [assert (0 < top ^ 2) by (apply pow_lt; unfold top; lra); lra|lra]).
  set (M := INR (S N)) in *. assert (Mp : 1 <= M) by lra.
  assert (half : forall z q b, 0 < q -> z / q <= M -> z / M * b <= q * b \/ b < 0).
  { intros z q b q0 H. destruct (Rle_lt_dec 0 b) as [b0|b0]; [left|now right]. apply Rmult_le_compat_r; [exact b0|].
    apply (Rmult_le_reg_r M); [lra|]. replace (z / M * M) with z by (field; lra). apply (Rmult_le_compat_l q) in H; [|lra]. replace (q * (z / q)) with z in H by (field; lra). lra. }
  assert (B1 : A1 / M <= d / 8) by (destruct (half (8 * A1) d 1 d0 ltac:(lra)) as [H|H]; [replace (8 * A1 / M * 1) with (8 * (A1 / M)) in H by (field; lra); lra|lra]).
  assert (B2 : A2 / M <= d / 24) by (destruct (half (24 * A2) d 1 d0 ltac:(lra)) as [H|H]; [replace (24 * A2 / M * 1) with (24 * (A2 / M)) in H by (field; lra); lra|lra]).
  destruct (T N ltac:(unfold M in *; lra)) as [_ U]. destruct (U main W) as [F1 _]. fold M in F1.
  set (w0 := veerman_numbers.frequency f M) in *. assert (w0E : w0 = w1 / M) by (unfold w0, veerman_numbers.frequency, w1; rewrite Rabs_left by lra; field; lra).
  assert (w00 : 0 < w0) by (rewrite w0E; apply Rdiv_lt_0_compat; lra).
  (* the response at J and at J +- d *)
  assert (At : forall tau, 0 < tau <= top -> exists ang v, Rabs (ang - tau * (PI / 2)) <= d / 8 /\ 0 <= v <= d / 24 /\ quiet f g N (tau * w0) = cos ang ^ 2 + sinh v ^ 2).
  { intros tau Ht. destruct (near_multiple f g tau top Hf Hg Ht ltac:(unfold top; lra) N ltac:(fold beta M; lra)) as (ang & v & X & V & E). fold beta M A1 in X. fold beta M A2 in V.
    exists ang, v. split; [lra|]. split; [lra|exact E]. }
  assert (Mid : quiet f g N (J * w0) < d ^ 2 / 4).
  { destruct (At J ltac:(unfold top; lra)) as (ang & v & X & V & E). rewrite E. replace ang with (J * (PI / 2) + (ang - J * (PI / 2))) by ring. unfold J at 1. rewrite cos_sqr_near. fold J.
    set (z := ang - J * (PI / 2)) in *. pose proof (sin_sqr_le z) as S. assert (Z2 : z ^ 2 <= (d / 8) ^ 2) by (rewrite <- (pow2_abs z); apply pow_incr; split; [apply Rabs_pos|exact X]).
    pose proof (sinh_le v ltac:(lra)) as Sv. assert (v3 : v * (1 + 2 * v ^ 2) <= v * 3) by (apply Rmult_le_compat_l; [lra|]; nra).
    assert (Sv0 : 0 <= sinh v) by (rewrite <- sinh_0; apply sinh_mono; lra). assert (sinh v ^ 2 <= (d / 8) ^ 2) by (apply pow_incr; lra).
    assert (0 < d ^ 2) by (apply pow_lt; lra). lra. }
  assert (Ends : forall sg, sg = d \/ sg = - d -> d ^ 2 / 4 <= quiet f g N ((J + sg) * w0)).
  { intros sg Sg. destruct (At (J + sg) ltac:(unfold top; destruct Sg; lra)) as (ang & v & X & V & E). rewrite E.
    apply Rabs_le_between in X. set (z := ang - J * (PI / 2)). replace ang with (J * (PI / 2) + z) by (unfold z; ring). unfold J at 1. rewrite cos_sqr_near.
    assert (Zb : d / 2 * (PI / 2) <= Rabs z <= PI / 2).
    { assert (d * 1 <= d * (PI / 2)) by (apply Rmult_le_compat_l; lra). assert (d * (PI / 2) <= / 2 * (PI / 2)) by (apply Rmult_le_compat_r; lra).
      destruct Sg as [->| ->]; [rewrite Rabs_right by (unfold z; lra)|rewrite Rabs_left by (unfold z; lra)]; unfold z; lra. }
    assert (Q : sin z ^ 2 = sin (Rabs z) ^ 2) by (unfold Rabs; destruct (Rcase_abs z); [rewrite sin_neg; ring|reflexivity]).
    rewrite Q. pose proof (jordan (Rabs z) ltac:(split; [apply Rabs_pos|lra])) as Jz. assert (PP : 0 < 2 / PI) by (apply Rdiv_lt_0_compat; lra).
    assert (d / 2 <= sin (Rabs z)).
    { eapply Rle_trans; [|exact Jz]. replace (d / 2) with (2 / PI * (d / 2 * (PI / 2))) by (field; lra). apply Rmult_le_compat_l; lra. }
    assert ((d / 2) ^ 2 <= sin (Rabs z) ^ 2) by (apply pow_incr; lra). pose proof (pow2_ge_0 (sinh v)). lra. }
  assert (Up : forall a b, quiet f g N a < quiet f g N b -> amplitude f g N b < amplitude f g N a).
  { intros a b H. apply Rnot_le_lt. intros L. apply (quiet_amplitude f g N a b Hf Hg) in L. lra. }
  destruct (maximum_inside (amplitude f g N) ((J + - d) * w0) (J * w0) ((J + d) * w0)) as (w & Wb & Lm).
  - split; apply Rmult_lt_compat_r; lra.
  - intros v. now apply amplitude_continuous.
  - apply Up. pose proof (Ends (- d) ltac:(now right)). lra.
  - apply Up. pose proof (Ends d ltac:(now left)). lra.
  - assert (JD : 0 < (J + - d) * w0) by (apply Rmult_lt_0_compat; lra).
    exists w. split; [lra|]. split; [|exact Lm].
    (* from w0 to the main resonance *)
    assert (Cw : Rabs (main - w0) <= Rabs C / M * w0 / w1).
    { eapply Rle_trans; [exact F1|]. rewrite w0E. replace (Rabs C / M * (w1 / M) / w1) with (Rabs C / M ^ 2) by (field; lra).
      assert (M2 : 0 < M ^ 2) by (apply pow_lt; lra). assert (M23 : M ^ 2 <= M ^ 3) by (replace (M ^ 3) with (M ^ 2 * M) by ring; rewrite <- (Rmult_1_r (M ^ 2)) at 1; apply Rmult_le_compat_l; lra).
      apply Rle_trans with (Rabs C / M ^ 3); [apply Rmult_le_compat_r; [left; apply Rinv_0_lt_compat; lra|apply Rle_abs]|].
      apply Rmult_le_compat_l; [lra|]. apply Rinv_le_contravar; lra. }
    set (eta := Rabs C / M / w1). assert (eta0 : 0 <= eta) by (unfold eta; apply Rmult_le_pos; [apply Rmult_le_pos; [lra|left; apply Rinv_0_lt_compat; lra]|left; now apply Rinv_0_lt_compat]).
    replace (Rabs C / M * w0 / w1) with (eta * w0) in Cw by (unfold eta; field; lra). apply Rabs_le_between in Cw.
    assert (eta1 : eta <= / 2).
    { destruct (half (2 * Rabs C / w1) 1 1 Rlt_0_1) as [H|H]; [replace (2 * Rabs C / w1 / 1) with (2 * Rabs C / w1) by (field; lra); lra| |lra].
      replace (2 * Rabs C / w1 / M * 1) with (2 * eta) in H by (unfold eta; field; lra). lra. }
    assert (eta2 : (J + e) * eta <= e / 4).
    { destruct (half (4 * A3) e 1 He ltac:(lra)) as [H|H]; [|lra]. replace (4 * A3 / M * 1) with (4 * ((J + e) * eta)) in H by (unfold A3, eta; field; lra). lra. }
    assert (m0 : 0 < main) by apply W.
    assert (Jw : 0 <= J * eta) by (apply Rmult_le_pos; lra). assert (ew : 0 <= e * eta) by (apply Rmult_le_pos; lra).
    assert (K1 : (J - e) * main <= w).
    { destruct (Rle_lt_dec (J - e) 0) as [L|L]; [assert (0 <= (e - J) * main) by (apply Rmult_le_pos; lra); lra|].
      apply Rle_trans with ((J - e) * ((1 + eta) * w0)); [apply Rmult_le_compat_l; lra|]. apply Rle_trans with ((J + - d) * w0); [|lra].
      replace ((J - e) * ((1 + eta) * w0)) with (((J - e) * (1 + eta)) * w0) by ring. apply Rmult_le_compat_r; lra. }
    assert (K2 : w <= (J + e) * main).
    { apply Rle_trans with ((J + d) * w0); [lra|]. apply Rle_trans with ((J + e) * ((1 - eta) * w0)); [|apply Rmult_le_compat_l; lra].
      replace ((J + e) * ((1 - eta) * w0)) with (((J + e) * (1 - eta)) * w0) by ring. apply Rmult_le_compat_r; lra. }
    apply Rabs_le. split; apply (Rmult_le_reg_r main); try exact m0.
    + replace ((w / main - J) * main) with (w - J * main) by (field; lra). lra.
    + replace ((w / main - J) * main) with (w - J * main) by (field; lra). lra.
Qed.
(* they are lesser: for k >= 2 the response near 2k - 1 times the main resonance is lower than at it, at every local maximum there is *)
Theorem lesser f g k e : f < 0 -> g < 0 -> (2 <= k)%nat -> 0 < e <= 1 -> exists M0, forall N, M0 <= INR (S N) -> forall main, main_resonance f g N main ->
  (exists w, 0 < w /\ Rabs (w / main - (2 * INR k - 1)) <= e /\ local_maximum (amplitude f g N) w) /\
  forall w, Rabs (w / main - (2 * INR k - 1)) <= e -> amplitude f g N w < amplitude f g N main.
Proof.
  intros Hf Hg Hk He. destruct (corollary_3 f g k e Hf Hg ltac:(lia) ltac:(lra)) as (M1 & L). destruct (theorem_1 f g Hf Hg) as (C & M2 & T).
  pose proof PI_RGT_0 as P0. assert (SF : 0 < sqrt (- f)) by (apply sqrt_lt_R0; lra). assert (R2 : 0 < sqrt 2) by (apply sqrt_lt_R0; lra).
  set (w1 := sqrt (- f) * PI / (2 * sqrt 2)). assert (w10 : 0 < w1) by (unfold w1; apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat|]; lra).
  pose proof (Rabs_pos C) as C0. assert (Q : 0 <= 4 * Rabs C / w1) by (apply Rmult_le_pos; [lra|left; now apply Rinv_0_lt_compat]).
  exists (Rabs M1 + Rabs M2 + 4 * Rabs C / w1 + 1). intros N HN main W. pose proof (Rle_abs M1). pose proof (Rle_abs M2). pose proof (Rabs_pos M1). pose proof (Rabs_pos M2).
  split; [apply (L N ltac:(lra) main W)|]. intros w Hw. apply Rnot_le_lt. intros Hge.
  destruct (T N ltac:(lra)) as [_ U]. set (M := INR (S N)) in *. set (w0 := veerman_numbers.frequency f M) in *.
  assert (w0E : w0 = w1 / M) by (unfold w0, veerman_numbers.frequency, w1; rewrite Rabs_left by lra; field; lra). assert (w00 : 0 < w0) by (rewrite w0E; apply Rdiv_lt_0_compat; lra).
  assert (Small : C / M ^ 3 <= w0 / 4).
  { apply Rle_trans with (Rabs C / M ^ 3); [apply Rmult_le_compat_r; [left; apply Rinv_0_lt_compat, pow_lt; lra|apply Rle_abs]|].
    rewrite w0E. apply (Rmult_le_reg_r (4 * M ^ 3)); [assert (0 < M ^ 3) by (apply pow_lt; lra); lra|]. replace (Rabs C / M ^ 3 * (4 * M ^ 3)) with (4 * Rabs C) by (field; lra).
    replace (w1 / M / 4 * (4 * M ^ 3)) with (w1 * M ^ 2) by (field; lra). assert (4 * Rabs C <= w1 * M).
    { apply (Rmult_le_reg_r (/ w1)); [now apply Rinv_0_lt_compat|]. replace (w1 * M * / w1) with M by (field; lra). change (4 * Rabs C * / w1) with (4 * Rabs C / w1). lra. }
    assert (M * 1 <= M * M) by (apply Rmult_le_compat_l; lra). assert (w1 * M <= w1 * (M * M)) by (apply Rmult_le_compat_l; lra). replace (M ^ 2) with (M * M) by ring. lra. }
  destruct W as [m0 Wm]. assert (K : 2 <= INR k) by (apply (le_INR 2) in Hk; cbn in Hk; lra).
  apply Rabs_le_between in Hw. assert (Lo : 2 * main <= w).
  { assert (E : w = w / main * main) by (field; lra). rewrite E. apply Rmult_le_compat_r; lra. }
  assert (Mw : main_resonance f g N w) by (split; [lra|]; intros v Hv; eapply Rle_trans; [apply Wm, Hv|exact Hge]).
  destruct (U w Mw) as [U1 _]. destruct (U main (conj m0 Wm)) as [U2 _]. fold w0 in U1, U2. apply Rabs_le_between in U1. apply Rabs_le_between in U2. lra.
Qed.
