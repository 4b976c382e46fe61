(* Veerman, Stosic, Olvera, section 4: tracking the cars in front and behind.
     veerman.lem2_eigvec, lem2, cor2, lem3.
   N + 1 followers; amplitudes a_0 = 1, ..., a_{N+1} with
     -w^2 a_k = (f + i w g)(a_k - (a_{k-1} + a_{k+1})/2), 1 <= k <= N,   -w^2 a_{N+1} = (f + i w g)(a_{N+1} - a_N).
   mu_+- = gamma +- sqrt(gamma^2 - 1), the root with angle in (-pi/2, pi/2]. *)
From Coq Require Import Reals Lra Lia Psatz.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import veerman_complex veerman_front.
Open Scope R_scope.

Definition mu_plus (gam : C) : C := (gam + Csqrt (gam * gam - 1))%C.
Definition mu_minus (gam : C) : C := (gam - Csqrt (gam * gam - 1))%C.
Lemma mu_product gam : (mu_plus gam * mu_minus gam = 1)%C.
Proof.
  unfold mu_plus, mu_minus. set (s := Csqrt _).
  replace ((gam + s) * (gam - s))%C with (gam * gam - s * s)%C by ring. unfold s. rewrite Csqrt_sqr. ring.
Qed.
Lemma mu_sum gam : (mu_plus gam + mu_minus gam = 2 * gam)%C.
Proof. unfold mu_plus, mu_minus. rewrite C2. ring. Qed.
Lemma mu_neq0 gam : mu_plus gam <> 0%C /\ mu_minus gam <> 0%C.
Proof.
  pose proof (mu_product gam) as P.
  split; intros E; rewrite E in P; apply C1_neq0; rewrite <- P; ring.
Qed.
Lemma mu_inverse gam : (mu_minus gam = / mu_plus gam)%C.
Proof.
  destruct (mu_neq0 gam) as [NZ _]. apply (Cmult_cancel_r _ _ _ NZ).
  rewrite Cinv_l by exact NZ. rewrite <- (mu_product gam). ring.
Qed.

(* C = [[0, 1], [-1, 2 gamma]] on pairs *)
Definition Cmap (gam : C) (p : C * C) : C * C := (snd p, (2 * gam * snd p - fst p)%C).
Record mat2 := Mat2 { m11 : C; m12 : C; m21 : C; m22 : C }.
Definition mat2_mul (A B : mat2) : mat2 :=
  Mat2 (m11 A * m11 B + m12 A * m21 B)%C (m11 A * m12 B + m12 A * m22 B)%C
       (m21 A * m11 B + m22 A * m21 B)%C (m21 A * m12 B + m22 A * m22 B)%C.
Definition Cmat (gam : C) : mat2 := Mat2 0%C 1%C (- (1))%C (2 * gam)%C.
Fixpoint mat2_pow (A : mat2) n := match n with O => Mat2 1%C 0%C 0%C 1%C | S n => mat2_mul A (mat2_pow A n) end.
Definition trace2 (A : mat2) : C := (m11 A + m22 A)%C.

Lemma mu_square (gam mu : C) : (mu + / mu = 2 * gam)%C -> mu <> 0%C -> (mu * mu = 2 * gam * mu - 1)%C.
Proof. intros H NZ. rewrite <- H. field. exact NZ. Qed.

(* powers of C, through mu: (mu - 1/mu) C^n = ... ; the trace by its own recurrence *)
Lemma trace_recurrence gam n : trace2 (mat2_pow (Cmat gam) (S (S n)))
  = (2 * gam * trace2 (mat2_pow (Cmat gam) (S n)) - trace2 (mat2_pow (Cmat gam) n))%C.
Proof.
  cbn [mat2_pow]. set (A := mat2_pow (Cmat gam) n). destruct A as [a b c d].
  unfold trace2, mat2_mul, Cmat; cbn [m11 m12 m21 m22]. rewrite !C2. ring.
Qed.
Lemma trace_power gam n :
  trace2 (mat2_pow (Cmat gam) n) = (Cpw (mu_minus gam) n + Cpw (mu_plus gam) n)%C.
Proof.
  assert (H : trace2 (mat2_pow (Cmat gam) n) = (Cpw (mu_minus gam) n + Cpw (mu_plus gam) n)%C /\
    trace2 (mat2_pow (Cmat gam) (S n)) = (Cpw (mu_minus gam) (S n) + Cpw (mu_plus gam) (S n))%C); [|apply H].
  induction n as [|n [IH0 IH1]].
  - split; cbn [Cpw mat2_pow]; unfold trace2, mat2_mul, Cmat; cbn [m11 m12 m21 m22]; [ring|].
    replace (mu_minus gam * 1 + mu_plus gam * 1)%C with (mu_plus gam + mu_minus gam)%C by ring. rewrite mu_sum. ring.
  - split; [exact IH1|]. rewrite trace_recurrence, IH0, IH1, <- mu_sum. cbn [Cpw].
    pose proof (mu_product gam) as P. set (p := mu_plus gam) in *. set (m := mu_minus gam) in *.
    replace ((p + m) * (m * Cpw m n + p * Cpw p n) - (Cpw m n + Cpw p n))%C
      with (m * (m * Cpw m n) + p * (p * Cpw p n) + (p * m - 1) * (Cpw m n + Cpw p n))%C by ring.
    rewrite P. ring.
Qed.

(* ---- the amplitudes ---- *)
Definition equation_2 (f g w : R) (N : nat) (a : nat -> C) : Prop :=
  (forall k, (1 <= k <= N)%nat ->
     ((- w ^ 2)%R * a k = den f g w * (a k - / 2 * (a (k - 1)%nat + a (k + 1)%nat)))%C) /\
  ((- w ^ 2)%R * a (S N) = den f g w * (a (S N) - a N))%C.
Definition chain (gam : C) (N : nat) (a : nat -> C) : Prop :=
  (forall k, (1 <= k <= N)%nat -> (a k, a (k + 1)%nat) = Cmap gam (a (k - 1)%nat, a k)) /\
  a N = (gam * a (S N))%C.

Lemma equation_2_chain f g w N a : f < 0 -> g < 0 -> equation_2 f g w N a <-> chain (gamma f g w) N a.
Proof.
  intros Hf Hg. pose proof (den_neq0 f g w Hf) as DZ.
  assert (GD : (gamma f g w * den f g w = num f g w)%C).
  { unfold gamma, Cdiv. rewrite <- Cmult_assoc, Cinv_l by exact DZ. ring. }
  assert (ND : (num f g w = den f g w + RtoC (w ^ 2))%C) by (apply injective_projections; cbn; ring).
  unfold equation_2, chain, Cmap; cbn [fst snd]. split; intros [A B]; split.
  - intros k Hk. specialize (A k Hk). f_equal.
    apply (Cmult_cancel_r _ _ (den f g w) DZ).
    replace ((2 * gamma f g w * a k - a (k - 1)%nat) * den f g w)%C
      with (2 * (gamma f g w * den f g w) * a k - a (k - 1)%nat * den f g w)%C by ring. rewrite GD, ND.
    assert (E : (2 * ((- w ^ 2)%R * a k) = 2 * (den f g w * (a k - / 2 * (a (k - 1)%nat + a (k + 1)%nat))))%C) by now rewrite A.
    replace (2 * (den f g w * (a k - / 2 * (a (k - 1)%nat + a (k + 1)%nat))))%C
      with (den f g w * (2 * a k - (2 * / 2) * (a (k - 1)%nat + a (k + 1)%nat)))%C in E by ring.
    rewrite Cinv_r in E by exact C2_neq0.
    apply (Cminus_iff (2 * ((- w ^ 2)%R * a k))%C (den f g w * (2 * a k - 1 * (a (k - 1)%nat + a (k + 1)%nat)))%C); [|exact E].
    replace ((- w ^ 2)%R : C) with (- RtoC (w ^ 2))%C by (apply injective_projections; cbn; ring). rewrite !C2. ring.
  - apply (Cmult_cancel_r _ _ (den f g w) DZ).
    replace (gamma f g w * a (S N) * den f g w)%C with ((gamma f g w * den f g w) * a (S N))%C by ring. rewrite GD, ND.
    symmetry. apply (Cminus_iff (den f g w * (a (S N) - a N))%C ((- w ^ 2)%R * a (S N))%C); [|now symmetry].
    replace ((- w ^ 2)%R : C) with (- RtoC (w ^ 2))%C by (apply injective_projections; cbn; ring). ring.
  - intros k Hk. specialize (A k Hk). apply (f_equal snd) in A.
    change (a (k + 1)%nat = (2 * gamma f g w * a k - a (k - 1)%nat)%C) in A.
    assert (E : (a (k + 1)%nat * den f g w = (2 * num f g w * a k - a (k - 1)%nat * den f g w))%C).
    { apply (f_equal (fun z => z * den f g w)%C) in A. rewrite A, <- GD. ring. }
    rewrite ND in E. apply (Cmult_cancel_r _ _ 2 C2_neq0).
    replace (den f g w * (a k - / 2 * (a (k - 1)%nat + a (k + 1)%nat)) * 2)%C
      with (den f g w * (2 * a k - (2 * / 2) * (a (k - 1)%nat + a (k + 1)%nat)))%C by ring.
    rewrite Cinv_r by exact C2_neq0.
    apply (Cminus_iff (a (k + 1)%nat * den f g w)%C
       (2 * (den f g w + RtoC (w ^ 2)) * a k - a (k - 1)%nat * den f g w)%C); [|exact E].
    replace ((- w ^ 2)%R : C) with (- RtoC (w ^ 2))%C by (apply injective_projections; cbn; ring). rewrite !C2. ring.
  - apply (f_equal (fun z => z * den f g w)%C) in B.
    replace (gamma f g w * a (S N) * den f g w)%C with ((gamma f g w * den f g w) * a (S N))%C in B by ring.
    rewrite GD, ND in B. symmetry.
    apply (Cminus_iff ((den f g w + RtoC (w ^ 2)) * a (S N))%C (a N * den f g w)%C); [|now symmetry].
    replace ((- w ^ 2)%R : C) with (- RtoC (w ^ 2))%C by (apply injective_projections; cbn; ring). ring.
Qed.

(* backwards from the last car: 2 a_{N+1-j} = a_{N+1} (mu^j + mu^-j) *)
Lemma backwards (gam mu : C) (N : nat) (a : nat -> C) : mu <> 0%C -> (mu + / mu = 2 * gam)%C -> chain gam N a ->
  forall j, (j <= N)%nat ->
    (2 * a (S N - j)%nat = a (S N) * (Cpw mu j + / Cpw mu j) /\
     2 * a (N - j)%nat = a (S N) * (Cpw mu (S j) + / Cpw mu (S j)))%C.
Proof.
  intros Hmu Hg [Hrec HN]. induction j as [|j IH]; intros Hj.
  - rewrite !Nat.sub_0_r. cbn [Cpw]. split.
    + rewrite C2. field. exact C1_neq0.
    + rewrite HN. replace (2 * (gam * a (S N)))%C with ((2 * gam) * a (S N))%C by ring. rewrite <- Hg.
      rewrite Cmult_1_r. ring.
  - destruct (IH ltac:(lia)) as [A B]. split.
    + replace (S N - S j)%nat with (N - j)%nat by lia. exact B.
    + specialize (Hrec (N - j)%nat ltac:(lia)). apply (f_equal snd) in Hrec.
      change (a (N - j + 1)%nat = (2 * gam * a (N - j)%nat - a (N - j - 1)%nat)%C) in Hrec.
      replace (N - j + 1)%nat with (S N - j)%nat in Hrec by lia.
      replace (N - j - 1)%nat with (N - S j)%nat in Hrec by lia.
      assert (E : (2 * a (N - S j)%nat = 2 * gam * (2 * a (N - j)%nat) - 2 * a (S N - j)%nat)%C).
      { rewrite Hrec. ring. }
      rewrite E, A, B, <- Hg. cbn [Cpw]. field. split; [now apply Cpw_neq0|exact Hmu].
Qed.

(* |mu| <> 1 where gamma is not real *)
Lemma unit_mu_real (gam mu : C) : mu <> 0%C -> (mu + / mu = 2 * gam)%C -> Cmod mu = 1 -> snd gam = 0.
Proof.
  intros NZ H M. assert (S : fst mu ^ 2 + snd mu ^ 2 = 1) by (rewrite <- Cmod_sqr, M; ring).
  apply (f_equal snd) in H. destruct mu as [p q], gam as [x y]. cbn [Cplus Cinv Cmult RtoC fst snd] in *.
  rewrite S in H. lra.
Qed.
Lemma gamma_imaginary f g w : f < 0 -> g < 0 -> snd (gamma f g w) = - g * w ^ 3 / (f ^ 2 + (w * g) ^ 2).
Proof.
  intros Hf Hg. unfold gamma, num, den, Cdiv, Cinv, Cmult; cbn [fst snd].
  assert (0 < f ^ 2 + (w * g) ^ 2) by (pose proof (pow2_ge_0 (w * g)); assert (0 < f ^ 2) by (apply pow2_gt_0; lra); lra).
  field. nra.
Qed.
Lemma gamma_not_real f g w : f < 0 -> g < 0 -> w <> 0 -> snd (gamma f g w) <> 0.
Proof.
  intros Hf Hg Hw E. rewrite gamma_imaginary in E by assumption.
  assert (0 < f ^ 2 + (w * g) ^ 2) by (pose proof (pow2_ge_0 (w * g)); assert (0 < f ^ 2) by (apply pow2_gt_0; lra); lra).
  assert (N0 : - g * w ^ 3 <> 0).
  { apply Rmult_integral_contrapositive_currified; [lra | now apply pow_nonzero]. }
  apply N0. apply (Rmult_eq_reg_r (/ (f ^ 2 + (w * g) ^ 2))); [|apply Rinv_neq_0_compat; lra].
  rewrite Rmult_0_l. exact E.
Qed.
Lemma mu_of_gamma gam : mu_plus gam <> 0%C /\ (mu_plus gam + / mu_plus gam = 2 * gam)%C.
Proof. split; [apply mu_neq0 | rewrite <- mu_inverse; apply mu_sum]. Qed.

(* the denominator of Lemma 2 does not vanish *)
Lemma denominator_modulus gam n :
  let r := Cmod (mu_plus gam) ^ n in
  Rabs (r - / r) <= Cmod (Cpw (mu_minus gam) n + Cpw (mu_plus gam) n)%C <= r + / r.
Proof.
  destruct (mu_neq0 gam) as [NZ _]. cbn zeta. rewrite mu_inverse, Cpw_inv by exact NZ.
  pose proof (Cpw_neq0 _ n NZ) as PZ. set (z := Cpw (mu_plus gam) n) in *.
  rewrite <- Cmod_Cpw. fold z. split.
  - pose proof (Cmod_triangle (/ z + z)%C (- z)%C) as T1. pose proof (Cmod_triangle (/ z + z)%C (- / z)%C) as T2.
    replace (/ z + z + - z)%C with (/ z)%C in T1 by ring. replace (/ z + z + - / z)%C with z in T2 by ring.
    rewrite !Cmod_opp, ?Cmod_inv in T1, T2 by exact PZ.
    apply Rabs_le. lra.
  - eapply Rle_trans; [apply Cmod_triangle|]. rewrite Cmod_inv by exact PZ. lra.
Qed.
Lemma pow_neq_inv r n : 0 < r -> r <> 1 -> (0 < n)%nat -> r ^ n <> / r ^ n.
Proof.
  intros P N1 Hn E. pose proof (pow_lt r n P) as PP.
  assert (Q : r ^ n * r ^ n = 1) by (rewrite E at 1; field; lra).
  assert (r ^ n = 1) by nra.
  destruct (Rtotal_order r 1) as [L|[L|L]]; [|lra|].
  - pose proof (pow_lt_1_compat r n (conj (Rlt_le _ _ P) L) Hn). lra.
  - pose proof (Rlt_pow_R1 r n L Hn). lra.
Qed.
Lemma denominator_neq0 f g w n : f < 0 -> g < 0 ->
  (Cpw (mu_minus (gamma f g w)) n + Cpw (mu_plus (gamma f g w)) n)%C <> 0%C.
Proof.
  intros Hf Hg. set (gam := gamma f g w). destruct (mu_of_gamma gam) as [NZ Hmu].
  destruct n as [|n]; [cbn; intros E; injection E; lra|].
  destruct (Req_dec w 0) as [W|W].
  - assert (G1 : gam = 1%C).
    { unfold gam, gamma. rewrite W. replace (num f g 0) with (den f g 0) by (unfold num, den; f_equal; ring).
      apply Cinv_r. now apply den_neq0. }
    assert (M1 : mu_plus gam = 1%C).
    { pose proof (mu_square gam _ Hmu NZ) as S. rewrite G1 in S |- *. set (m := mu_plus 1%C) in *.
      assert (Q : ((m - 1) * (m - 1) = 0)%C).
      { replace ((m - 1) * (m - 1))%C with (m * m - 2 * m + 1)%C by (rewrite C2; ring). rewrite S. ring. }
      destruct (Ceq_dec (m - 1)%C 0%C) as [D|D].
      - replace m with (m - 1 + 1)%C by ring. rewrite D. ring.
      - exfalso. exact (Cmult_neq_0 _ _ D D Q). }
    rewrite mu_inverse, Cpw_inv, M1, Cpw_one by exact NZ. intros E. apply C2_neq0. rewrite C2, <- E. field. exact C1_neq0.
  - intros E. pose proof (denominator_modulus gam (S n)) as [D _]. rewrite E, Cmod_0 in D. cbn zeta in D.
    assert (P : 0 < Cmod (mu_plus gam)) by now apply Cmod_gt_0.
    assert (R1 : Cmod (mu_plus gam) <> 1).
    { intros M. exact (gamma_not_real f g w Hf Hg W (unit_mu_real gam _ NZ Hmu M)). }
    apply (pow_neq_inv _ (S n) P R1 ltac:(lia)). pose proof (Rabs_pos (Cmod (mu_plus gam) ^ S n - / Cmod (mu_plus gam) ^ S n)).
    assert (Z : Cmod (mu_plus gam) ^ S n - / Cmod (mu_plus gam) ^ S n = 0) by (apply Rabs_eq_0; lra). lra.
Qed.

(* veerman.lem2: N + 1 followers, all N *)
Theorem lemma_2 f g w N a : f < 0 -> g < 0 -> a 0%nat = RtoC 1 -> equation_2 f g w N a ->
  let gam := gamma f g w in
  a (S N) = (2 / trace2 (mat2_pow (Cmat gam) (S N)))%C /\
  a (S N) = (2 / (Cpw (mu_minus gam) (S N) + Cpw (mu_plus gam) (S N)))%C.
Proof.
  intros Hf Hg A0 HE gam. rewrite trace_power. pose proof (denominator_neq0 f g w (S N) Hf Hg) as NZ. fold gam in NZ.
  apply equation_2_chain in HE; [|assumption..]. destruct (mu_of_gamma gam) as [MZ Hmu].
  destruct (backwards gam _ N a MZ Hmu HE N (le_n N)) as [_ T]. rewrite Nat.sub_diag, A0 in T.
  rewrite mu_inverse, Cpw_inv in NZ |- * by exact MZ.
  assert (Q : a (S N) = (2 / (/ Cpw (mu_plus gam) (S N) + Cpw (mu_plus gam) (S N)))%C); [|now split].
  apply (Cmult_cancel_r _ _ _ NZ). unfold Cdiv. rewrite <- Cmult_assoc, Cinv_l by exact NZ.
  rewrite Cmult_1_r in T. rewrite Cmult_1_r, T. ring.
Qed.

(* veerman.lem2_eigvec *)
Theorem lemma_2_eigenvectors gam :
  let s := Csqrt (gam * gam - 1)%C in
  Cmap gam (RtoC 1, mu_plus gam) = (mu_plus gam * 1, mu_plus gam * mu_plus gam)%C /\
  Cmap gam (RtoC 1, mu_minus gam) = (mu_minus gam * 1, mu_minus gam * mu_minus gam)%C /\
  (1 - gam * mu_plus gam = - s * mu_plus gam)%C /\ (1 - gam * mu_minus gam = s * mu_minus gam)%C.
Proof.
  intros s. unfold Cmap; cbn [fst snd]. pose proof (Csqrt_sqr (gam * gam - 1)%C) as S. fold s in S.
  assert (SS : (gam * gam = 1 + s * s)%C) by (rewrite S; ring).
  unfold mu_plus, mu_minus. fold s.
  split; [|split; [|split]].
  - f_equal; [ring|]. replace ((gam + s) * (gam + s))%C with (gam * gam + 2 * gam * s + s * s)%C by (rewrite C2; ring).
    replace (s * s)%C with (gam * gam - 1)%C by now rewrite S. rewrite C2. ring.
  - f_equal; [ring|]. replace ((gam - s) * (gam - s))%C with (gam * gam - 2 * gam * s + s * s)%C by (rewrite C2; ring).
    replace (s * s)%C with (gam * gam - 1)%C by now rewrite S. rewrite C2. ring.
  - replace (gam * (gam + s))%C with (gam * gam + gam * s)%C by ring. rewrite SS. ring.
  - replace (gam * (gam - s))%C with (gam * gam - gam * s)%C by ring. rewrite SS. ring.
Qed.

(* c_+: the solution is c_+ mu_+^k + (1 - c_+) mu_-^k with the printed c_+, for w <> 0 *)
Theorem lemma_2_constant f g w N a : f < 0 -> g < 0 -> w <> 0 -> a 0%nat = RtoC 1 -> equation_2 f g w N a ->
  let gam := gamma f g w in let p := mu_plus gam in let m := mu_minus gam in
  forall c, (forall k, (k <= S N)%nat -> a k = (c * Cpw p k + (1 - c) * Cpw m k)%C) ->
    c = (Cpw m (S N) / (Cpw m (S N) + Cpw p (S N)))%C.
Proof.
  intros Hf Hg Hw A0 HE gam p m c Hc. pose proof (denominator_neq0 f g w (S N) Hf Hg) as NZ. fold gam p m in NZ.
  apply equation_2_chain in HE; [|assumption..]. destruct HE as [_ HN]. fold gam in HN.
  rewrite (Hc N), (Hc (S N)) in HN by lia.
  destruct (lemma_2_eigenvectors gam) as [_ [_ [Ep Em]]]. fold p m in Ep, Em. set (s := Csqrt _) in *.
  assert (SZ : s <> 0%C).
  { intros Z. assert (P : p = m) by (unfold p, m, mu_plus, mu_minus; fold s; rewrite Z; ring).
    assert (M1 : Cmod p = 1).
    { pose proof (mu_product gam) as Q. fold p m in Q. rewrite <- P in Q. apply (f_equal Cmod) in Q.
      rewrite Cmod_mult, Cmod_1 in Q. pose proof (Cmod_ge_0 p). nra. }
    destruct (mu_of_gamma gam) as [MZ Hmu]. exact (gamma_not_real f g w Hf Hg Hw (unit_mu_real gam _ MZ Hmu M1)). }
  assert (K : (s * ((1 - c) * Cpw m (S N) - c * Cpw p (S N)) = 0)%C).
  { cbn [Cpw] in HN |- *.
    replace (s * ((1 - c) * (m * Cpw m N) - c * (p * Cpw p N)))%C
      with ((1 - c) * (s * m) * Cpw m N + c * (- s * p) * Cpw p N)%C by ring.
    rewrite <- Ep, <- Em.
    replace ((1 - c) * (1 - gam * m) * Cpw m N + c * (1 - gam * p) * Cpw p N)%C
      with ((c * Cpw p N + (1 - c) * Cpw m N) - gam * (c * (p * Cpw p N) + (1 - c) * (m * Cpw m N)))%C by ring.
    rewrite HN. ring. }
  assert (K2 : ((1 - c) * Cpw m (S N) - c * Cpw p (S N) = 0)%C).
  { destruct (Ceq_dec ((1 - c) * Cpw m (S N) - c * Cpw p (S N))%C 0%C) as [E|E]; [exact E|].
    exfalso. exact (Cmult_neq_0 _ _ SZ E K). }
  apply (Cmult_cancel_r _ _ _ NZ). unfold Cdiv. rewrite <- Cmult_assoc, Cinv_l, Cmult_1_r by exact NZ.
  apply (Cminus_iff 0%C ((1 - c) * Cpw m (S N) - c * Cpw p (S N))%C); [ring | now symmetry].
Qed.

(* veerman.cor2 *)
Theorem corollary_2 f g w : f < 0 -> g < 0 -> w <> 0 ->
  let gam := gamma f g w in
  Cmod (mu_plus gam) <> Cmod (mu_minus gam) /\
  exists rho, 1 < rho /\ forall N a, a 0%nat = RtoC 1 -> equation_2 f g w N a ->
    2 / (rho ^ S N + / rho ^ S N) <= Cmod (a (S N)) <= 2 / (rho ^ S N - / rho ^ S N).
Proof.
  intros Hf Hg Hw gam. destruct (mu_of_gamma gam) as [NZ Hmu].
  assert (P : 0 < Cmod (mu_plus gam)) by now apply Cmod_gt_0.
  assert (R1 : Cmod (mu_plus gam) <> 1).
  { intros M. exact (gamma_not_real f g w Hf Hg Hw (unit_mu_real gam _ NZ Hmu M)). }
  set (r := Cmod (mu_plus gam)) in *.
  split.
  - rewrite mu_inverse, Cmod_inv by exact NZ. fold r. intros E. apply R1.
    assert (r * r = 1) by (rewrite E at 1; field; lra). nra.
  - exists (Rmax r (/ r)). assert (I : 0 < / r) by now apply Rinv_0_lt_compat.
    assert (RI : r * / r = 1) by (field; lra).
    split.
    + destruct (Rtotal_order r 1) as [L|[L|L]]; [|lra|].
      * apply Rlt_le_trans with (/ r); [|apply Rmax_r]. rewrite <- Rinv_1. apply Rinv_lt_contravar; lra.
      * apply Rlt_le_trans with r; [exact L|apply Rmax_l].
    + intros N a A0 HE. destruct (lemma_2 f g w N a Hf Hg A0 HE) as [_ E]. fold gam in E.
      pose proof (denominator_neq0 f g w (S N) Hf Hg) as DZ. fold gam in DZ.
      pose proof (denominator_modulus gam (S N)) as [D1 D2]. fold r in D1, D2. cbn zeta in D1, D2.
      rewrite E, Cmod_div, Cmod_R, Rabs_right by (try exact DZ; lra).
      set (d := Cmod (Cpw (mu_minus gam) (S N) + Cpw (mu_plus gam) (S N))%C) in *.
      assert (d0 : 0 < d) by now apply Cmod_gt_0.
      assert (PR : 0 < r ^ S N) by now apply pow_lt.
      assert (PI : 0 < / r ^ S N) by now apply Rinv_0_lt_compat.
      assert (NE : r ^ S N <> / r ^ S N) by (apply pow_neq_inv; [exact P|exact R1|lia]).
      assert (INV : (/ r) ^ S N = / r ^ S N) by apply pow_inv.
      assert (MM : Rmax r (/ r) ^ S N + / Rmax r (/ r) ^ S N = r ^ S N + / r ^ S N /\
                   Rmax r (/ r) ^ S N - / Rmax r (/ r) ^ S N = Rabs (r ^ S N - / r ^ S N)).
      { unfold Rmax. destruct (Rle_dec r (/ r)) as [L|L].
        - rewrite INV, Rinv_inv. split; [ring|].
          assert (r ^ S N <= (/ r) ^ S N) by (apply pow_incr; lra). rewrite INV in *. rewrite Rabs_left; lra.
        - split; [reflexivity|].
          assert ((/ r) ^ S N <= r ^ S N) by (apply pow_incr; lra). rewrite INV in *. rewrite Rabs_right; lra. }
      destruct MM as [MM1 MM2]. rewrite MM1, MM2.
      assert (AB : 0 < Rabs (r ^ S N - / r ^ S N)) by (apply Rabs_pos_lt; lra).
      split; unfold Rdiv; apply Rmult_le_compat_l; try lra; apply Rinv_le_contravar; lra.
Qed.

(* veerman.lem3 made explicit: |a_{N+1}| (N+1) Im gamma <= 1 *)
Lemma geometric_lower r n : 1 <= r -> INR n * (r - / r) <= r ^ n - / r ^ n.
Proof.
  intros H. assert (I : 0 < / r) by (apply Rinv_0_lt_compat; lra). assert (RI : r * / r = 1) by (field; lra).
  induction n as [|n IH]; [cbn; lra|]. rewrite S_INR. cbn [pow]. rewrite Rinv_mult by (try apply pow_nonzero; lra).
  assert (P1 : 1 <= r ^ n) by (apply pow_R1_Rle; exact H).
  assert (P2 : 0 < / r ^ n <= 1).
  { split; [apply Rinv_0_lt_compat; lra|]. rewrite <- Rinv_1. apply Rinv_le_contravar; lra. }
  assert (I1 : / r <= 1) by (rewrite <- Rinv_1; apply Rinv_le_contravar; lra).
  set (p := r ^ n) in *. set (q := / p) in *. set (i := / r) in *.
  assert (r * p - i * q - (p - q) >= r - i); [|nra].
  assert (0 <= (r - 1) * (p - 1)) by (apply Rmult_le_pos; lra).
  assert (PQ : p * q = 1) by (unfold q; field; lra).
  assert (EQ : (1 - i) * (1 - q) = (r - 1) * (p - 1) * (i * q)).
  { replace ((r - 1) * (p - 1) * (i * q)) with ((r * i - i) * (p * q - q)) by ring. rewrite RI, PQ. ring. }
  assert (IQ : i * q <= 1) by (rewrite <- (Rmult_1_l 1); apply Rmult_le_compat; lra).
  assert ((r - 1) * (p - 1) * (i * q) <= (r - 1) * (p - 1) * 1) by (apply Rmult_le_compat_l; lra).
  lra.
Qed.
Theorem lemma_3 f g w N a : f < 0 -> g < 0 -> 0 < w -> a 0%nat = RtoC 1 -> equation_2 f g w N a ->
  Cmod (a (S N)) * (INR (S N) * (- g * w ^ 3 / (f ^ 2 + (w * g) ^ 2))) <= 1.
Proof.
  intros Hf Hg Hw A0 HE. destruct (corollary_2 f g w Hf Hg ltac:(lra)) as [_ _].
  rewrite <- gamma_imaginary by assumption. set (gam := gamma f g w).
  destruct (lemma_2 f g w N a Hf Hg A0 HE) as [_ E]. fold gam in E.
  pose proof (denominator_neq0 f g w (S N) Hf Hg) as DZ. fold gam in DZ.
  pose proof (denominator_modulus gam (S N)) as [D1 _]. cbn zeta in D1.
  destruct (mu_of_gamma gam) as [NZ Hmu]. set (mu := mu_plus gam) in *.
  assert (P : 0 < Cmod mu) by now apply Cmod_gt_0. set (r := Cmod mu) in *.
  assert (I : 0 < / r) by now apply Rinv_0_lt_compat. assert (RI : r * / r = 1) by (field; lra).
  (* 2 Im gamma <= |r - 1/r| *)
  assert (G : 2 * snd gam <= Rabs (r - / r)).
  { assert (Hs := f_equal snd Hmu). pose proof (Cmod_parts mu) as [_ MS]. fold r in MS.
    pose proof (Rmax_Cmod mu) as RM. pose proof (Rmax_r (Rabs (fst mu)) (Rabs (snd mu))) as RR. fold r in RM.
    destruct mu as [x y]. cbn [Cplus Cinv Cmult RtoC fst snd] in *.
    rewrite <- MS in Hs.
    assert (2 * snd gam = y * (1 - (/ r) ^ 2)).
    { replace (2 * snd gam) with (2 * snd gam + 0 * fst gam) by ring. rewrite <- Hs. field. lra. }
    rewrite H. apply Rle_trans with (Rabs (y * (1 - (/ r) ^ 2))); [apply Rle_abs|].
    rewrite Rabs_mult. replace (r - / r) with (r * (1 - (/ r) ^ 2)) by (field; lra).
    rewrite Rabs_mult. apply Rmult_le_compat_r; [apply Rabs_pos|]. rewrite (Rabs_right r) by lra. lra. }
  assert (B : INR (S N) * Rabs (r - / r) <= Rabs (r ^ S N - / r ^ S N)).
  { destruct (Rle_lt_dec 1 r) as [L|L].
    - assert (/ r <= 1) by (rewrite <- Rinv_1; apply Rinv_le_contravar; lra).
      rewrite (Rabs_right (r - / r)) by lra. eapply Rle_trans; [|apply Rle_abs]. now apply geometric_lower.
    - assert (1 <= / r) by (rewrite <- Rinv_1; apply Rinv_le_contravar; lra).
      rewrite (Rabs_left1 (r - / r)) by lra. rewrite Rabs_minus_sym. eapply Rle_trans; [|apply Rle_abs].
      pose proof (geometric_lower (/ r) (S N) H) as Q. rewrite pow_inv, Rinv_inv, Rinv_inv in Q. lra. }
  rewrite E, Cmod_div, Cmod_R, Rabs_right by (try exact DZ; lra).
  set (d := Cmod (Cpw (mu_minus gam) (S N) + Cpw mu (S N))%C) in *.
  assert (d0 : 0 < d) by now apply Cmod_gt_0.
  assert (NP : 0 <= INR (S N)) by apply pos_INR.
  assert (K : INR (S N) * (2 * snd gam) <= d).
  { apply Rle_trans with (INR (S N) * Rabs (r - / r)); [apply Rmult_le_compat_l; assumption | lra]. }
  apply (Rmult_le_reg_r d); [exact d0|].
  replace (2 / d * (INR (S N) * snd gam) * d) with (INR (S N) * (2 * snd gam)) by (field; lra). lra.
Qed.
