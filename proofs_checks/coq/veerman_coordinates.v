(* Veerman, Stosic, Olvera, section 4: the response of the last car in the coordinates gamma = cos(x - i y),
     |a_M|^-2 = cos^2(M x) + sinh^2(M y),
   and bounds of y and x for every frequency (towards veerman.thm1_omega, veerman.thm1_amp).
   1 - gamma has modulus cosh y - cos x, 1 + gamma has cosh y + cos x, and sin x sinh y is the imaginary part. *)
From Coq Require Import Reals Lra Lia Psatz.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import veerman_complex veerman_front veerman_chain veerman_stability veerman_amplitude.
Open Scope R_scope.

Lemma cosh_plus x y : cosh (x + y) = cosh x * cosh y + sinh x * sinh y.
Proof. unfold cosh, sinh. rewrite Ropp_plus_distr, !exp_plus. field. Qed.
Lemma sinh_plus x y : sinh (x + y) = sinh x * cosh y + cosh x * sinh y.
Proof. unfold cosh, sinh. rewrite Ropp_plus_distr, !exp_plus. field. Qed.
Lemma cosh_sqr y : cosh y ^ 2 = 1 + sinh y ^ 2.
Proof.
  unfold cosh, sinh. pose proof (exp_plus y (- y)) as E. rewrite Rplus_opp_r, exp_0 in E.
  replace (((exp y + exp (- y)) / 2) ^ 2) with (exp y * exp (- y) + ((exp y - exp (- y)) / 2) ^ 2) by field. now rewrite <- E.
Qed.
Lemma cosh_ge1 y : 1 <= cosh y.
Proof.
  assert (P : 0 < cosh y) by (unfold cosh; pose proof (exp_pos y); pose proof (exp_pos (- y)); lra).
  pose proof (cosh_sqr y). pose proof (pow2_ge_0 (sinh y)). nra.
Qed.
Lemma sin_sqr x : sin x ^ 2 = 1 - cos x ^ 2.
Proof. pose proof (sin2_cos2 x) as H. rewrite !Rsqr_pow2 in H. lra. Qed.
Lemma sinh_mult n y : 0 <= y -> INR n * sinh y <= sinh (INR n * y).
Proof.
  intros Y. assert (S0 : 0 <= sinh y).
  { unfold sinh. assert (exp (- y) <= exp y); [|lra]. destruct Y as [Y|Y]; [left; apply exp_increasing; lra|rewrite <- Y, Ropp_0; lra]. }
  induction n as [|n IH]; [cbn [INR]; rewrite !Rmult_0_l, sinh_0; lra|].
  rewrite S_INR, Rmult_plus_distr_r, Rmult_1_l, Rmult_plus_distr_r, Rmult_1_l, sinh_plus.
  pose proof (cosh_ge1 y). pose proof (cosh_ge1 (INR n * y)). assert (0 <= INR n * sinh y) by (apply Rmult_le_pos; [apply pos_INR|exact S0]).
  assert (sinh (INR n * y) * 1 <= sinh (INR n * y) * cosh y) by (apply Rmult_le_compat_l; lra).
  assert (1 * sinh y <= cosh (INR n * y) * sinh y) by (apply Rmult_le_compat_r; lra). lra.
Qed.

Lemma cheb_coordinates x y n :
  chebT (cos x * cosh y, sin x * sinh y) n = (cos (INR n * x) * cosh (INR n * y), sin (INR n * x) * sinh (INR n * y)).
Proof.
  set (z := (cos x * cosh y, sin x * sinh y) : C).
  set (T := fun n => (cos (INR n * x) * cosh (INR n * y), sin (INR n * x) * sinh (INR n * y)) : C).
  assert (A : chebT z n = T n /\ chebT z (S n) = T (S n)); [|apply A].
  induction n as [|n [A B]].
  - unfold T. cbn [chebT INR]. rewrite !Rmult_0_l, !Rmult_1_l, cos_0, sin_0, cosh_0. split; [|reflexivity].
    apply injective_projections; cbn; ring.
  - split; [exact B|]. rewrite chebT_SS, A, B. unfold T, z.
    replace (INR (S (S n))) with (INR (S n) + 1) by (rewrite (S_INR (S n)); ring).
    replace (INR n) with (INR (S n) - 1) by (rewrite S_INR; ring). set (m := INR (S n)).
    replace ((m + 1) * x) with (m * x + x) by ring. replace ((m + 1) * y) with (m * y + y) by ring.
    replace ((m - 1) * x) with (m * x - x) by ring. replace ((m - 1) * y) with (m * y + - y) by ring.
    rewrite cos_plus, sin_plus, cos_minus, sin_minus, !cosh_plus, !sinh_plus.
    assert (Ec : cosh (- y) = cosh y) by (unfold cosh; rewrite Ropp_involutive; field).
    assert (Es : sinh (- y) = - sinh y) by (unfold sinh; rewrite Ropp_involutive; field). rewrite Ec, Es.
    apply injective_projections; cbn; ring.
Qed.
Lemma coordinates_exist (z : C) : 0 <= snd z -> exists x y, 0 <= x <= PI /\ 0 <= y /\
  z = (cos x * cosh y, sin x * sinh y) /\ cosh y - cos x = Cmod (1 - z)%C /\ cosh y + cos x = Cmod (1 + z)%C.
Proof.
  intros I. pose proof (Cmod_sqr (1 - z)%C) as E1. pose proof (Cmod_sqr (1 + z)%C) as E2.
  pose proof (Cmod_ge_0 (1 - z)%C) as P1. pose proof (Cmod_ge_0 (1 + z)%C) as P2.
  pose proof (Cmod_triangle (1 - z)%C (1 + z)%C) as T1.
  replace (1 - z + (1 + z))%C with (RtoC 2) in T1 by (rewrite C2; ring). rewrite Cmod_R, Rabs_right in T1 by lra.
  set (r := Cmod (1 - z)%C) in *. set (p := Cmod (1 + z)%C) in *. destruct z as [u v]. cbn [fst snd Cminus Cplus Copp RtoC] in *.
  assert (U : 4 * u = p ^ 2 - r ^ 2) by (rewrite E1, E2; ring).
  assert (V : r ^ 2 = (1 - u) ^ 2 + v ^ 2) by (rewrite E1; ring). clear E1 E2.
  assert (B : -1 <= (p - r) / 2 <= 1).
  { assert (Q : (p - r) ^ 2 <= 4).
    { assert (r ^ 2 = (1 - (p ^ 2 - r ^ 2) / 4) ^ 2 + v ^ 2) by (rewrite <- U; rewrite V at 1; field).
      assert (0 <= ((p + r) ^ 2 - 4) * (4 - (p - r) ^ 2)).
      { replace (((p + r) ^ 2 - 4) * (4 - (p - r) ^ 2)) with (16 * (r ^ 2 - (1 - (p ^ 2 - r ^ 2) / 4) ^ 2)) by field.
        assert (E : r ^ 2 - (1 - (p ^ 2 - r ^ 2) / 4) ^ 2 = v ^ 2) by lra. rewrite E. pose proof (pow2_ge_0 v). lra. }
      destruct T1 as [D|D].
      - apply Rnot_lt_le. intros L. assert (0 < (r + p - 2) * (r + p + 2)) by (apply Rmult_lt_0_compat; lra).
        assert (0 < ((p + r) ^ 2 - 4) * ((p - r) ^ 2 - 4)) by (apply Rmult_lt_0_compat; lra). lra.
      - assert (0 <= p * r) by now apply Rmult_le_pos. replace ((p - r) ^ 2) with ((r + p) ^ 2 - 4 * (p * r)) by ring. rewrite <- D. lra. }
    replace ((p - r) ^ 2) with (4 * ((p - r) / 2) ^ 2) in Q by field. split; nra. }
  set (s := sqrt (((p + r) / 2) ^ 2 - 1)). assert (S2 : s ^ 2 = ((p + r) / 2) ^ 2 - 1) by (apply pow2_sqrt; nra).
  exists (acos ((p - r) / 2)), (arcsinh s).
  assert (CX : cos (acos ((p - r) / 2)) = (p - r) / 2) by (apply cos_acos; exact B).
  assert (SY : sinh (arcsinh s) = s) by apply sinh_arcsinh.
  assert (CY : cosh (arcsinh s) = (p + r) / 2).
  { pose proof (cosh_sqr (arcsinh s)) as C. rewrite SY, S2 in C. pose proof (cosh_ge1 (arcsinh s)). nra. }
  assert (XB := acos_bound ((p - r) / 2)). assert (SX : 0 <= sin (acos ((p - r) / 2))) by (apply sin_ge_0; lra).
  assert (S0 : 0 <= s) by apply sqrt_pos.
  split; [exact XB|]. split.
  { rewrite <- arcsinh_0. destruct S0 as [S0|S0]; [left; now apply arcsinh_lt|rewrite <- S0; lra]. }
  rewrite CX, CY, SY. split; [|split; field]. apply injective_projections; cbn [fst snd]; [lra|].
  pose proof (sin_sqr (acos ((p - r) / 2))) as Q. rewrite CX in Q. set (sx := sin _) in *.
  assert (E : v ^ 2 = (sx * s) ^ 2).
  { rewrite Rpow_mult_distr, Q, S2. assert (v ^ 2 = r ^ 2 - (1 - (p ^ 2 - r ^ 2) / 4) ^ 2) by (rewrite <- U; rewrite V at 1; field). rewrite H. field. }
  apply Rsqr_inj; [exact I|now apply Rmult_le_pos|]. now rewrite !Rsqr_pow2.
Qed.
