(* Chazelle: two worked matrices and two inequalities of real numbers.
     chazelle.ex15, chazelle.exAB, chazelle.epsineq, chazelle.eq3.15. *)
From Coq Require Import Reals Lra Lia Psatz.
From Coquelicot Require Import Coquelicot.
Open Scope R_scope.

(* ---- chazelle.ex15: P = (1/15) [[12, 3], [10, 5]] = I - C L for one edge, c = (3/15, 10/15) ---- *)
Definition P15 (x y : R) : R * R := (12 / 15 * x + 3 / 15 * y, 10 / 15 * x + 5 / 15 * y).
Theorem ex15_model : 
  (1 - 3 / 15 = 12 / 15 /\ 1 - 10 / 15 = 5 / 15) /\ 0 < 3 / 15 * 1 < 1 /\ 0 < 10 / 15 * 1 < 1.
Proof. lra. Qed.
(* the real eigenvalues are 1 and 2/15 = 0.1333...; (a complex one would be a root of the same polynomial) *)
Theorem ex15_eigenvalues lam : (exists x y, (x <> 0 \/ y <> 0) /\ P15 x y = (lam * x, lam * y)) <-> lam = 1 \/ lam = 2 / 15.
Proof.
  split.
  - intros (x & y & NZ & E). injection E as E1 E2.
    assert (K : x * ((lam - 1) * (lam - 2 / 15)) = 0 /\ y * ((lam - 1) * (lam - 2 / 15)) = 0).
    { assert (A : (lam - 12 / 15) * x = 3 / 15 * y) by lra. assert (B : (lam - 5 / 15) * y = 10 / 15 * x) by lra. split.
      - transitivity ((lam - 5 / 15) * ((lam - 12 / 15) * x) - 30 / 225 * x); [field|]. rewrite A.
        transitivity (3 / 15 * ((lam - 5 / 15) * y) - 30 / 225 * x); [field|]. rewrite B. field.
      - transitivity ((lam - 12 / 15) * ((lam - 5 / 15) * y) - 30 / 225 * y); [field|]. rewrite B.
        transitivity (10 / 15 * ((lam - 12 / 15) * x) - 30 / 225 * y); [field|]. rewrite A. field. }
    destruct K as [K1 K2]. assert (Z : (lam - 1) * (lam - 2 / 15) = 0).
    { destruct NZ as [NZ|NZ]; [apply Rmult_integral in K1 as [|]|apply Rmult_integral in K2 as [|]]; tauto. }
    apply Rmult_integral in Z as [Z|Z]; [left|right]; lra.
  - intros [-> | ->].
    + exists 1, 1. split; [left; lra|]. unfold P15. f_equal; field.
    + exists 3, (-10). split; [left; lra|]. unfold P15. f_equal; field.
Qed.
(* it stretches (1, 0) to a length that rounds to 1.041; 1^perp is not invariant; eigenvectors for 2/15 are not in it *)
Theorem ex15_stretch : Rabs (sqrt (fst (P15 1 0) ^ 2 + snd (P15 1 0) ^ 2) - 1.041) < 0.0005 /\
  Rabs (2 / 15 - 0.133) < 0.0005 /\
  fst (P15 1 (-1)) + snd (P15 1 (-1)) <> 0 /\
  (forall x y, (x <> 0 \/ y <> 0) -> P15 x y = (2 / 15 * x, 2 / 15 * y) -> x + y <> 0).
Proof.
  split; [|split; [|split]].
  - unfold P15; cbn [fst snd]. replace ((12 / 15 * 1 + 3 / 15 * 0) ^ 2 + (10 / 15 * 1 + 5 / 15 * 0) ^ 2) with (244 / 225) by field.
    apply Rabs_lt_between. split.
    + assert (1.0409 < sqrt (244 / 225)); [|lra]. rewrite <- (sqrt_pow2 1.0409) by lra. apply sqrt_lt_1_alt. lra.
    + assert (sqrt (244 / 225) < 1.0414); [|lra]. rewrite <- (sqrt_pow2 1.0414) by lra. apply sqrt_lt_1_alt. lra.
  - apply Rabs_lt_between. lra.
  - unfold P15; cbn [fst snd]. lra.
  - intros x y NZ E S. injection E as E1 E2. lra.
Qed.

Theorem ex15 :
  (forall lam, (exists x y, (x <> 0 \/ y <> 0) /\ P15 x y = (lam * x, lam * y)) <-> lam = 1 \/ lam = 2 / 15) /\
  Rabs (2 / 15 - 0.133) < 0.0005 /\
  Rabs (sqrt (fst (P15 1 0) ^ 2 + snd (P15 1 0) ^ 2) - 1.041) < 0.0005 /\
  fst (P15 1 (-1)) + snd (P15 1 (-1)) <> 0 /\
  (forall x y, (x <> 0 \/ y <> 0) -> P15 x y = (2 / 15 * x, 2 / 15 * y) -> x + y <> 0).
Proof. destruct ex15_stretch as (A & B & C & D). split; [exact ex15_eigenvalues|]. now repeat split. Qed.

(* ---- chazelle.exAB ---- *)
Definition mat := nat -> nat -> R.
Definition mat3 (a b c d e f g h k : R) : mat := fun i j =>
  match i, j with O, O => a | O, 1%nat => b | O, _ => c | 1%nat, O => d | 1%nat, 1%nat => e | 1%nat, _ => f
  | _, O => g | _, 1%nat => h | _, _ => k end.
Definition mul3 (A B : mat) : mat := fun i j => A i 0%nat * B 0%nat j + A i 1%nat * B 1%nat j + A i 2%nat * B 2%nat j.
Definition mA : mat := mat3 0 1 0 1 0 0 0 0 1.
Definition mB : mat := mat3 0 1 0 (1 / 2) 0 (1 / 2) 0 1 0.
(* P(t) = A for even t, B for odd t; product t = P(t) ... P(1) *)
Fixpoint product (t : nat) : mat := match t with
  | O => mat3 1 0 0 0 1 0 0 0 1 | S u => mul3 (if Nat.even (S u) then mA else mB) (product u) end.
Theorem exAB m i j : (1 <= m)%nat -> (i < 3)%nat -> (j < 3)%nat ->
  product (2 * m) i j = mat3 ((1 / 2) ^ m) (1 - 2 * (1 / 2) ^ m) ((1 / 2) ^ m) 0 1 0 0 1 0 i j.
Proof.
  intros Hm. revert i j. induction m as [|m IH]; [lia|].
  assert (E : forall i j, product (2 * S m) i j = mul3 mA (mul3 mB (product (2 * m))) i j).
  { intros i j. replace (2 * S m)%nat with (S (S (2 * m))) by lia. cbn [product].
    replace (Nat.even (S (S (2 * m)))) with true by (symmetry; apply Nat.even_spec; exists (S m); lia).
    replace (Nat.even (S (2 * m))) with false; [reflexivity|].
    rewrite Nat.even_succ, <- Nat.negb_even. replace (Nat.even (2 * m)) with true; [reflexivity|].
    symmetry. apply Nat.even_spec. now exists m. }
  intros i j Hi Hj. rewrite E. destruct (Nat.eq_dec m 0) as [->|M].
  - destruct i as [|[|[|i]]]; [| | |lia]; destruct j as [|[|[|j]]]; try lia; unfold mul3, mA, mB; cbn; field.
  - unfold mul3. rewrite !IH by lia.
    destruct i as [|[|[|i]]]; [| | |lia]; destruct j as [|[|[|j]]]; try lia; unfold mA, mB; cbn; field.
Qed.

(* ---- chazelle.epsineq: e^(-nu^(nu^2)) < nu^(-nu^4) for every nu >= 1 ---- *)
Lemma exp_gt_double : forall x, 2 * x < exp x.
Proof.
  intros x. pose proof (exp_ineq1_le (x - 1)) as A.
  (* e^x = e e^(x-1) >= e x *)
  assert (E : exp x = exp 1 * exp (x - 1)) by (rewrite <- exp_plus; f_equal; ring).
  pose proof exp_le_3. assert (2.5 < exp 1).
  { assert (B : exp 1 = exp (1 / 2) * exp (1 / 2)) by (rewrite <- exp_plus; f_equal; lra).
    assert (C : exp (1 / 2) = exp (1 / 4) * exp (1 / 4)) by (rewrite <- exp_plus; f_equal; lra).
    assert (D : exp (1 / 4) = exp (1 / 8) * exp (1 / 8)) by (rewrite <- exp_plus; f_equal; lra).
    pose proof (exp_ineq1_le (1 / 8)) as F. assert (81 / 64 <= exp (1 / 4)) by nra. assert (1.6 <= exp (1 / 2)) by nra. nra. }
  pose proof (exp_pos x). destruct (Rle_lt_dec x 0) as [L|L]; [nra|].
  rewrite E. assert (exp 1 * x <= exp 1 * exp (x - 1)) by (apply Rmult_le_compat_l; lra). nra.
Qed.
Lemma ln_lt_half x : 0 < x -> 2 * ln x < x.
Proof. intros H. pose proof (exp_gt_double (ln x)). rewrite exp_ln in *; assumption. Qed.

Theorem eps_inequality (nu : nat) : (1 <= nu)%nat ->
  exp (- INR (nu ^ (nu ^ 2))) < / (INR nu ^ (nu ^ 4)).
Proof.
  intros H. assert (N1 : 1 <= INR nu) by (apply (le_INR 1); exact H).
  assert (NP : 0 < INR nu) by lra.
  rewrite <- (exp_ln (INR nu)) by exact NP.
  assert (PE : forall n x, exp x ^ n = exp (INR n * x)).
  { induction n as [|n IH]; intros x; [cbn; rewrite Rmult_0_l, exp_0; reflexivity|].
    cbn [pow]. rewrite IH, <- exp_plus, S_INR. f_equal. ring. }
  rewrite PE, <- exp_Ropp. apply exp_increasing, Ropp_lt_contravar.
  destruct (Nat.eq_dec nu 1) as [->|N2].
  - cbn. rewrite ln_1. lra.
  - destruct (Nat.eq_dec nu 2) as [->|N3].
    + change (2 ^ 2 ^ 2)%nat with 16%nat. change (2 ^ 4)%nat with 16%nat.
      assert (L2 : 2 * ln (INR 2) < 2) by (apply ln_lt_half; cbn; lra).
      assert (I16 : INR 16 = 16) by (rewrite INR_IZR_INZ; reflexivity). rewrite I16. lra.
    + assert (N3' : (3 <= nu)%nat) by lia.
      pose proof (ln_lt_half (INR nu) NP) as L.
      assert (Q : (nu ^ 5 <= nu ^ (nu ^ 2))%nat).
      { apply Nat.pow_le_mono_r; [lia|]. cbn [Nat.pow]. nia. }
      apply le_INR in Q. apply Rlt_le_trans with (INR (nu ^ 5)); [|exact Q].
      replace (nu ^ 5)%nat with (nu ^ 4 * nu)%nat by (cbn [Nat.pow]; ring). rewrite mult_INR.
      apply Rmult_lt_compat_l; [|lra]. apply lt_0_INR. apply Nat.neq_0_lt_0, Nat.pow_nonzero. lia.
Qed.

(* ---- chazelle.eq3.15: the angle of (v, 1) and (w, 1) ---- *)
Fixpoint dotp (d : nat) (x y : nat -> R) : R := match d with O => 0 | S d => dotp d x y + x d * y d end.
Definition norm (d : nat) (x : nat -> R) : R := sqrt (dotp d x x).
(* lifted by the coordinate 1 *)
Definition ldot (d : nat) (x y : nat -> R) : R := dotp d x y + 1.
Definition angle (d : nat) (x y : nat -> R) : R := acos (ldot d x y / (sqrt (ldot d x x) * sqrt (ldot d y y))).
Lemma dotp_sq d x : 0 <= dotp d x x.
Proof. induction d as [|d IH]; cbn; [lra|]. pose proof (Rle_0_sqr (x d)). unfold Rsqr in *. lra. Qed.
Lemma dotp_lin d a b x y : dotp d (fun k => a * x k + b * y k) (fun k => a * x k + b * y k)
  = a ^ 2 * dotp d x x + 2 * a * b * dotp d x y + b ^ 2 * dotp d y y.
Proof. induction d as [|d IH]; cbn [dotp]; [ring|]. rewrite IH. ring. Qed.
Lemma lagrange d x y : dotp d x y ^ 2 <= dotp d x x * dotp d y y.
Proof.
  pose proof (dotp_sq d x) as X. pose proof (dotp_sq d y) as Y.
  pose proof (dotp_sq d (fun k => dotp d y y * x k + - dotp d x y * y k)) as H. rewrite dotp_lin in H.
  destruct (Req_dec (dotp d y y) 0) as [Z|Z].
  - destruct (Req_dec (dotp d x y) 0) as [T|T]; [rewrite T, Z; lra|exfalso].
    pose proof (dotp_sq d (fun k => 1 * x k + - (1 + dotp d x x) / dotp d x y * y k)) as K.
    rewrite dotp_lin, Z in K.
    replace (2 * 1 * (- (1 + dotp d x x) / dotp d x y) * dotp d x y) with (- 2 * (1 + dotp d x x)) in K by (field; exact T). lra.
  - assert (0 < dotp d y y) by lra.
    assert (0 <= dotp d y y * (dotp d x x * dotp d y y - dotp d x y ^ 2)) by nra. nra.
Qed.
Lemma sin_lower x : 0 <= x <= 2 -> 4 / 10 * x <= sin x.
Proof.
  intros [A B]. assert (XP : x <= PI) by (pose proof PI2_3_2; unfold PI2 in *; lra).
  destruct (SIN x A XP) as [L _]. apply Rle_trans with (2 := L).
  unfold sin_lb, sin_approx, sin_term. cbn [sum_f_R0 Nat.mul Nat.add].
  assert (F : INR (fact 1) = 1 /\ INR (fact 3) = 6 /\ INR (fact 5) = 120 /\ INR (fact 7) = 5040).
  { rewrite !INR_IZR_INZ. repeat split. }
  destruct F as (F1 & F3 & F5 & F7). rewrite F1, F3, F5, F7.
  replace ((-1) ^ 0 * (x ^ 1 / 1) + (-1) ^ 1 * (x ^ 3 / 6) + (-1) ^ 2 * (x ^ 5 / 120) + (-1) ^ 3 * (x ^ 7 / 5040))
    with (x * (1 - x ^ 2 / 6 + (x ^ 2) ^ 2 / 120 - (x ^ 2) ^ 3 / 5040)) by field.
  rewrite Rmult_comm. apply Rmult_le_compat_l; [exact A|].
  assert (Y0 : 0 <= x ^ 2 <= 4) by (split; [apply pow2_ge_0|nra]). set (y := x ^ 2) in *. clearbody y.
  assert (y ^ 3 <= 4 * y ^ 2) by (replace (y ^ 3) with (y * y ^ 2) by ring; apply Rmult_le_compat_r; [apply pow2_ge_0|lra]).
  assert (0 <= (4 - y) * (5 - y)) by (apply Rmult_le_pos; lra). nra.
Qed.
Definition diff (x y : nat -> R) : nat -> R := fun k => 1 * x k + (-1) * y k.
Theorem angle_bounds d v w B : 0 < norm d (diff v w) -> norm d v <= B -> norm d w <= B ->
  / (1 + B ^ 2) <= angle d v w / norm d (diff v w) <= 5 / 2.
Proof.
  intros D HV HW. pose proof (dotp_sq d v) as V0. pose proof (dotp_sq d w) as W0.
  set (p := sqrt (ldot d v v)). set (q := sqrt (ldot d w w)).
  assert (P2 : p * p = 1 + dotp d v v) by (unfold p, ldot; rewrite sqrt_sqrt; lra).
  assert (Q2 : q * q = 1 + dotp d w w) by (unfold q, ldot; rewrite sqrt_sqrt; lra).
  assert (P1 : 1 <= p) by (unfold p, ldot; apply Rle_trans with (sqrt 1); [rewrite sqrt_1; lra | apply sqrt_le_1_alt; lra]).
  assert (Q1 : 1 <= q) by (unfold q, ldot; apply Rle_trans with (sqrt 1); [rewrite sqrt_1; lra | apply sqrt_le_1_alt; lra]).
  set (n := norm d (diff v w)) in *.
  assert (N2 : n * n = dotp d v v - 2 * dotp d v w + dotp d w w).
  { unfold n, norm. rewrite sqrt_sqrt by apply dotp_sq. unfold diff. rewrite dotp_lin. ring. }
  pose proof (lagrange d v w) as LG.
  set (s := ldot d v w) in *. assert (S : dotp d v w = s - 1) by (unfold s, ldot; ring). rewrite S in *.
  set (c := s / (p * q)). unfold angle. fold p q s c.
  assert (PQ : 1 <= p * q) by nra.
  assert (CE : c * (p * q) = s) by (unfold c; field; nra).
  assert (SC : n * n <= (p * q) ^ 2 - s ^ 2).
  { replace ((p * q) ^ 2) with ((p * p) * (q * q)) by ring. rewrite P2, Q2, N2.
    replace ((1 + dotp d v v) * (1 + dotp d w w) - s ^ 2)
      with (dotp d v v - 2 * (s - 1) + dotp d w w + (dotp d v v * dotp d w w - (s - 1) ^ 2)) by ring. lra. }
  assert (C1 : c ^ 2 <= 1).
  { pose proof (pow2_ge_0 n) as NN. replace (n ^ 2) with (n * n) in NN by ring. rewrite <- CE in SC.
    replace ((p * q) ^ 2 - (c * (p * q)) ^ 2) with ((p * q) ^ 2 * (1 - c ^ 2)) in SC by ring.
    assert (0 < (p * q) ^ 2) by (apply pow_lt; lra).
    destruct (Rle_lt_dec (c ^ 2) 1) as [L|L]; [exact L|exfalso].
    assert (0 < (p * q) ^ 2 * (c ^ 2 - 1)) by (apply Rmult_lt_0_compat; lra). lra. }
  assert (CB : -1 <= c <= 1) by nra.
  set (th := acos c). pose proof (acos_bound c) as [T0 T1]. fold th in T0, T1.
  assert (CT : cos th = c) by (apply cos_acos; lra).
  assert (SQ : sin th ^ 2 = 1 - c ^ 2) by (pose proof (sin2_cos2 th) as K; unfold Rsqr in K; rewrite CT in K; nra).
  assert (S0 : 0 <= sin th) by (apply sin_ge_0; lra).
  split.
  - apply Rcomplements.Rle_div_r; [lra|].
    assert (PQB : p * q <= 1 + B ^ 2).
    { assert (dotp d v v <= B ^ 2).
      { unfold norm in HV. rewrite <- (sqrt_sqrt (dotp d v v)) by lra. pose proof (sqrt_pos (dotp d v v)). nra. }
      assert (dotp d w w <= B ^ 2).
      { unfold norm in HW. rewrite <- (sqrt_sqrt (dotp d w w)) by lra. pose proof (sqrt_pos (dotp d w w)). nra. }
      nra. }
    assert (ST : sin th <= th).
    { destruct (Rle_lt_or_eq_dec 0 th T0) as [L|L]; [left; now apply sin_lt_x|rewrite <- L, sin_0; lra]. }
    assert (NS : n <= p * q * sin th).
    { destruct (Rle_lt_dec n (p * q * sin th)) as [L|L]; [exact L|exfalso].
      assert (0 <= p * q * sin th) by (apply Rmult_le_pos; lra).
      assert ((p * q * sin th) * (p * q * sin th) < n * n) by (apply Rmult_le_0_lt_compat; assumption).
      assert ((p * q * sin th) * (p * q * sin th) = (p * q) ^ 2 * sin th ^ 2) by ring. rewrite SQ in *.
      assert ((p * q) ^ 2 * (1 - c ^ 2) = (p * q) ^ 2 - s ^ 2) by (rewrite <- CE; ring). lra. }
    apply (Rmult_le_reg_l (1 + B ^ 2)); [pose proof (pow2_ge_0 B); lra|].
    rewrite <- Rmult_assoc, Rinv_r, Rmult_1_l by (pose proof (pow2_ge_0 B); lra).
    apply Rle_trans with (1 := NS). apply Rmult_le_compat; lra.
  - apply Rcomplements.Rle_div_l; [lra|].
    (* chord: 2 (1 - cos th) <= n^2, and th <= (5/2) 2 sin(th/2) *)
    assert (CH : 2 * (1 - c) <= n * n).
    { assert (X : n * n = (p - q) ^ 2 + 2 * (p * q) * (1 - c)).
      { replace (2 * (p * q) * (1 - c)) with (2 * (p * q) - 2 * s) by (rewrite <- CE; ring). rewrite N2.
        replace ((p - q) ^ 2) with (p * p - 2 * (p * q) + q * q) by ring. rewrite P2, Q2. ring. }
      rewrite X. pose proof (pow2_ge_0 (p - q)). assert (0 <= (p * q - 1) * (1 - c)) by (apply Rmult_le_pos; lra). lra. }
    assert (H2 : c = 1 - 2 * sin (th / 2) ^ 2).
    { rewrite <- CT. replace th with (2 * (th / 2)) at 1 by field. rewrite cos_2a_sin. ring. }
    pose proof PI_RGT_0 as PP.
    assert (SH0 : 0 <= sin (th / 2)) by (apply sin_ge_0; lra).
    assert (SN : 2 * sin (th / 2) <= n).
    { destruct (Rle_lt_dec (2 * sin (th / 2)) n) as [L|L]; [exact L|exfalso].
      assert (n * n < (2 * sin (th / 2)) * (2 * sin (th / 2))) by (apply Rmult_le_0_lt_compat; lra). nra. }
    assert (J : 4 / 10 * (th / 2) <= sin (th / 2)) by (apply sin_lower; pose proof PI_4; lra).
    lra.
Qed.
