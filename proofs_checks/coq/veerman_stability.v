(* Veerman, Stosic, Olvera, section 2: the matrices of the two systems, their spectra, stability.
     veerman.eigAK, specP2, specM, lem1, eq1_matrix, eq2_matrix (the forces), dimL.
   N + 1 followers, numbered 1 to N + 1; vectors are functions of the number.  P_1 and P_2 act by their rows:
     P_1: x_k - x_{k-1} (x_0 := 0);   P_2: x_k - (x_{k-1} + x_{k+1})/2, last row x_{N+1} - x_N.
   An eigenvalue of M = I (x) A + P (x) K (complex, with an eigenvector (x, u)) gives
   (f + g nu) P x = nu^2 x; the eigenvalues of P are real and positive, so nu^2 - lambda g nu - lambda f = 0
   decides. *)
From Coq Require Import Reals Lra Lia Psatz.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import veerman_complex.
Open Scope R_scope.

(* row k of the reduced Laplacian; x_0 stands for the leader *)
Definition row1 (x : nat -> C) (k : nat) : C := (x k - x (k - 1)%nat)%C.
Definition row2 (N : nat) (x : nat -> C) (k : nat) : C :=
  if Nat.eqb k (S N) then (x k - x (k - 1)%nat)%C else (x k - / 2 * (x (k - 1)%nat + x (k + 1)%nat))%C.
(* the reduced matrix: the leader's column is left out, that is x_0 = 0 *)
Definition reduced (row : (nat -> C) -> nat -> C) (x : nat -> C) (k : nat) : C :=
  row (fun j => match j with O => RtoC 0 | _ => x j end) k.
Definition P1 := reduced row1.
Definition P2 (N : nat) := reduced (row2 N).

Definition nonzero (N : nat) (x : nat -> C) := exists k, (1 <= k <= S N)%nat /\ x k <> 0%C.
Definition eigenvector (N : nat) (P : (nat -> C) -> nat -> C) (lam : C) (x : nat -> C) :=
  nonzero N x /\ forall k, (1 <= k <= S N)%nat -> P x k = (lam * x k)%C.
Definition eigenvalue N P lam := exists x, eigenvector N P lam x.

(* M (x, u): (x, u) -> (u, f P x + g P u) *)
Definition eigenvector_M (N : nat) (P : (nat -> C) -> nat -> C) (f g : R) (nu : C) (x u : nat -> C) :=
  (nonzero N x \/ nonzero N u) /\
  forall k, (1 <= k <= S N)%nat -> u k = (nu * x k)%C /\ (f * P x k + g * P u k)%C = (nu * u k)%C.
Definition eigenvalue_M N P f g nu := exists x u, eigenvector_M N P f g nu x u.

(* A + lambda K = [[0, 1], [lambda f, lambda g]] acts on pairs *)
Definition eigenvalue_AK (f g : R) (lam nu : C) := exists a b : C, (a <> 0%C \/ b <> 0%C) /\
  b = (nu * a)%C /\ (lam * f * a + lam * g * b)%C = (nu * b)%C.

(* veerman.eigAK *)
Theorem eigenvalue_AK_iff (f g : R) (lam nu : C) :
  eigenvalue_AK f g lam nu <-> (nu * nu - lam * g * nu - lam * f = 0)%C.
Proof.
  split.
  - intros (a & b & NZ & Hb & H). subst b.
    assert (A0 : a <> 0%C).
    { destruct NZ as [NZ|NZ]; [exact NZ|]. intros E. apply NZ. rewrite E. ring. }
    apply (Cmult_cancel_r _ _ a A0).
    replace ((nu * nu - lam * g * nu - lam * f) * a)%C
      with (nu * (nu * a) - (lam * f * a + lam * g * (nu * a)))%C by ring. rewrite H. ring.
  - intros H. exists (RtoC 1), nu. split; [left; exact C1_neq0|]. split; [ring|].
    replace (nu * nu)%C with ((nu * nu - lam * g * nu - lam * f) + (lam * f + lam * g * nu))%C by ring.
    rewrite H. ring.
Qed.
(* the quadratic formula, for any square root s of (lambda g)^2 + 4 lambda f *)
Theorem quadratic_formula (f g : R) (lam nu s : C) : (s * s = (lam * g) * (lam * g) + 4 * lam * f)%C ->
  (nu * nu - lam * g * nu - lam * f = 0)%C <->
  nu = (/ 2 * (lam * g + s))%C \/ nu = (/ 2 * (lam * g - s))%C.
Proof.
  intros Hs. assert (C4 : RtoC 4 = (RtoC 1 + RtoC 1 + RtoC 1 + RtoC 1)%C) by (apply injective_projections; cbn; ring).
  assert (F : (4 * (nu * nu - lam * g * nu - lam * f) = (2 * nu - lam * g - s) * (2 * nu - lam * g + s))%C).
  { replace ((2 * nu - lam * g - s) * (2 * nu - lam * g + s))%C
      with ((2 * nu - lam * g) * (2 * nu - lam * g) - s * s)%C by ring. rewrite Hs, C4, C2. ring. }
  assert (I2 : (2 * / 2 = 1)%C) by (apply Cinv_r, C2_neq0).
  split.
  - intros H. rewrite H, Cmult_0_r in F. symmetry in F.
    destruct (Ceq_dec (2 * nu - lam * g - s)%C 0%C) as [E|E].
    + left. apply (Cmult_cancel_r _ _ 2 C2_neq0).
      replace (/ 2 * (lam * g + s) * 2)%C with ((2 * / 2) * (lam * g + s))%C by ring. rewrite I2.
      apply (Cminus_iff (2 * nu - lam * g - s)%C 0%C); [ring | exact E].
    + destruct (Ceq_dec (2 * nu - lam * g + s)%C 0%C) as [E'|E'].
      * right. apply (Cmult_cancel_r _ _ 2 C2_neq0).
        replace (/ 2 * (lam * g - s) * 2)%C with ((2 * / 2) * (lam * g - s))%C by ring. rewrite I2.
        apply (Cminus_iff (2 * nu - lam * g + s)%C 0%C); [ring | exact E'].
      * exfalso. exact (Cmult_neq_0 _ _ E E' F).
  - intros H. assert (N4 : RtoC 4 <> 0%C) by (apply Cneq0_re; cbn; lra).
    apply (Cmult_cancel_r _ _ 4 N4). rewrite Cmult_comm, F.
    destruct H as [H|H]; rewrite H.
    + replace (2 * (/ 2 * (lam * g + s)) - lam * g - s)%C with ((2 * / 2) * (lam * g + s) - lam * g - s)%C by ring.
      rewrite I2. ring.
    + replace (2 * (/ 2 * (lam * g - s)) - lam * g + s)%C with ((2 * / 2) * (lam * g - s) - lam * g + s)%C by ring.
      rewrite I2. ring.
Qed.

(* ---- both reduced matrices are linear in this sense ---- *)
Definition local (N : nat) (P : (nat -> C) -> nat -> C) :=
  (forall z x k, (1 <= k <= S N)%nat -> P (fun j => (z * x j)%C) k = (z * P x k)%C) /\
  (forall x y k, (1 <= k <= S N)%nat -> (forall j, (1 <= j <= S N)%nat -> x j = y j) -> P x k = P y k).
Lemma local1 N : local N P1.
Proof.
  split.
  - intros z x k Hk. unfold P1, reduced, row1. destruct k as [|k]; [lia|].
    replace (S k - 1)%nat with k by lia. destruct k; ring.
  - intros x y k Hk E. unfold P1, reduced, row1. destruct k as [|k]; [lia|].
    replace (S k - 1)%nat with k by lia. rewrite (E (S k)) by lia. destruct k; [reflexivity|]. now rewrite (E (S k)) by lia.
Qed.
Lemma local2 N : local N (P2 N).
Proof.
  split.
  - intros z x k Hk. unfold P2, reduced, row2. destruct k as [|k]; [lia|].
    replace (S k - 1)%nat with k by lia. replace (S k + 1)%nat with (S (S k)) by lia.
    destruct (Nat.eqb (S k) (S N)); destruct k; ring.
  - intros x y k Hk E. unfold P2, reduced, row2. destruct k as [|k]; [lia|].
    replace (S k - 1)%nat with k by lia. replace (S k + 1)%nat with (S (S k)) by lia.
    destruct (Nat.eqb_spec (S k) (S N)) as [L|L]; rewrite (E (S k)) by lia.
    + destruct k; [reflexivity|]. now rewrite (E (S k)) by lia.
    + rewrite (E (S (S k))) by lia. destruct k; [reflexivity|]. now rewrite (E (S k)) by lia.
Qed.

(* ---- veerman.specM: eigenvalues of M, as a set, for every real f, g ---- *)
Theorem spectrum_M (N : nat) (P : (nat -> C) -> nat -> C) (f g : R) (nu : C) : local N P -> (exists lam, eigenvalue N P lam) ->
  eigenvalue_M N P f g nu <-> exists lam, eigenvalue N P lam /\ eigenvalue_AK f g lam nu.
Proof.
  intros [LZ LE] [lam0 H0]. split.
  - intros (x & u & NZ & H).
    assert (X : nonzero N x).
    { destruct NZ as [NZ|(k & Hk & Hu)]; [exact NZ|]. exists k. split; [exact Hk|]. intros E.
      apply Hu. destruct (H k Hk) as [-> _]. rewrite E. ring. }
    assert (R1 : forall k, (1 <= k <= S N)%nat -> ((RtoC f + g * nu) * P x k = nu * nu * x k)%C).
    { intros k Hk. destruct (H k Hk) as [Hu HP].
      rewrite (LE u (fun j => (nu * x j)%C) k Hk) in HP by (intros j Hj; apply H; exact Hj).
      rewrite LZ, Hu in HP by exact Hk.
      replace ((RtoC f + g * nu) * P x k)%C with (f * P x k + g * (nu * P x k))%C by ring. rewrite HP. ring. }
    destruct (Ceq_dec (RtoC f + g * nu)%C 0%C) as [Z|Z].
    + assert (N0 : (nu * nu = 0)%C).
      { destruct X as (k & Hk & Xk). specialize (R1 k Hk). rewrite Z, Cmult_0_l in R1.
        apply (Cmult_cancel_r _ _ (x k) Xk). rewrite <- R1. ring. }
      exists lam0. split; [exact H0|]. apply eigenvalue_AK_iff. rewrite N0.
      replace (0 - lam0 * g * nu - lam0 * f)%C with (- lam0 * (RtoC f + g * nu))%C by ring. rewrite Z. ring.
    + exists (nu * nu * / (RtoC f + g * nu))%C. split.
      * exists x. split; [exact X|]. intros k Hk. specialize (R1 k Hk).
        apply (Cmult_cancel_r _ _ (RtoC f + g * nu)%C Z).
        replace (nu * nu * / (RtoC f + g * nu) * x k * (RtoC f + g * nu))%C
          with ((/ (RtoC f + g * nu) * (RtoC f + g * nu)) * (nu * nu * x k))%C by ring.
        rewrite Cinv_l, <- R1 by exact Z. ring.
      * apply eigenvalue_AK_iff.
        replace (nu * nu - nu * nu * / (RtoC f + g * nu) * g * nu - nu * nu * / (RtoC f + g * nu) * f)%C
          with (nu * nu - nu * nu * (/ (RtoC f + g * nu) * (RtoC f + g * nu)))%C by ring.
        rewrite Cinv_l by exact Z. ring.
  - intros (lam & (x & X & Hx) & HA). apply eigenvalue_AK_iff in HA.
    exists x, (fun k => (nu * x k)%C). split; [left; exact X|]. intros k Hk. split; [reflexivity|].
    rewrite LZ, Hx by exact Hk.
    replace (nu * (nu * x k))%C with ((nu * nu - lam * g * nu - lam * f) * x k + (f * (lam * x k) + g * (nu * (lam * x k))))%C by ring.
    rewrite HA. ring.
Qed.

(* the Laplacian with the leader: its row is zero; the nonzero eigenvalues are those of P, and 0 is not one of P *)
Definition L_eigenvalue (N : nat) (row : (nat -> C) -> nat -> C) (lam : C) := exists x : nat -> C,
  (exists k, (k <= S N)%nat /\ x k <> 0%C) /\ (RtoC 0 = lam * x 0%nat)%C /\
  forall k, (1 <= k <= S N)%nat -> row x k = (lam * x k)%C.
Theorem spectrum_L (N : nat) (row : (nat -> C) -> nat -> C) (lam : C) :
  (forall x y k, (1 <= k <= S N)%nat -> (forall j, (j <= S N)%nat -> x j = y j) -> row x k = row y k) ->
  lam <> 0%C -> (L_eigenvalue N row lam <-> eigenvalue N (reduced row) lam).
Proof.
  intros LE NZ. split.
  - intros (x & (k & Hk & Xk) & H0 & H).
    assert (X0 : x 0%nat = 0%C).
    { apply (Cmult_cancel_r _ _ lam NZ). rewrite Cmult_0_l, Cmult_comm. now symmetry. }
    exists x. split.
    + exists k. split; [|exact Xk]. destruct k; [contradiction|lia].
    + intros j Hj. unfold reduced. rewrite <- (H j Hj). apply LE; [exact Hj|]. intros [|i] Hi; [now symmetry|reflexivity].
  - intros (x & (k & Hk & Xk) & H). exists (fun j => match j with O => RtoC 0 | _ => x j end).
    split; [exists k; split; [lia|destruct k; [lia|exact Xk]]|]. split; [ring|].
    intros j Hj. specialize (H j Hj). unfold reduced in H. rewrite H. destruct j; [lia|reflexivity].
Qed.

(* ---- the spectrum of P_1 ---- *)
Theorem spectrum_P1 (N : nat) (lam : C) : eigenvalue N P1 lam <-> lam = RtoC 1.
Proof.
  split.
  - intros (x & (k & Hk & Xk) & H).
    destruct (Ceq_dec lam 1%C) as [E|E]; [exact E|exfalso].
    assert (Z : forall j, (1 <= j <= S N)%nat -> x j = 0%C).
    { induction j as [|j IH]; [lia|]. intros Hj. specialize (H (S j) Hj). unfold P1, reduced, row1 in H.
      replace (S j - 1)%nat with j in H by lia.
      assert (D : (lam - 1)%C <> 0%C).
      { intros D. apply E. replace lam with ((lam - 1) + 1)%C by ring. rewrite D. ring. }
      apply (Cmult_cancel_r _ _ (lam - 1)%C D).
      destruct j as [|j].
      - replace (x 1%nat * (lam - 1))%C with (lam * x 1%nat - x 1%nat)%C by ring. rewrite <- H. ring.
      - rewrite IH in H by lia.
        replace (x (S (S j)) * (lam - 1))%C with (lam * x (S (S j)) - x (S (S j)))%C by ring. rewrite <- H. ring. }
    apply Xk. now apply Z.
  - intros ->. exists (fun j => if Nat.eqb j (S N) then RtoC 1 else RtoC 0). split.
    + exists (S N). rewrite Nat.eqb_refl. split; [lia|exact C1_neq0].
    + intros k Hk. unfold P1, reduced, row1. destruct k as [|k]; [lia|]. replace (S k - 1)%nat with k by lia.
      assert (E : (match k with O => RtoC 0 | S _ => if Nat.eqb k (S N) then RtoC 1 else RtoC 0 end) = RtoC 0).
      { destruct k; [reflexivity|]. replace (Nat.eqb (S k) (S N)) with false; [reflexivity|]. symmetry. apply Nat.eqb_neq. lia. }
      cbv beta. rewrite E. ring.
Qed.

(* ---- the spectrum of P_2: real, through cosines ---- *)
(* sums over the followers with weights 1, ..., 1, 1/2 make P_2 symmetric *)
Fixpoint sum (F : nat -> R) (n : nat) : R := match n with O => 0 | S n => sum F n + F (S n) end.
Lemma sum_ext F F' n : (forall k, (1 <= k <= n)%nat -> F k = F' k) -> sum F n = sum F' n.
Proof. induction n as [|n IH]; intros H; cbn [sum]; [reflexivity|]. rewrite IH, H by (intros; try apply H; lia). reflexivity. Qed.
Lemma sum_nonneg F n : (forall k, (1 <= k <= n)%nat -> 0 <= F k) -> 0 <= sum F n.
Proof. induction n as [|n IH]; intros H; cbn [sum]; [lra|]. assert (0 <= sum F n) by (apply IH; intros; apply H; lia). specialize (H (S n) ltac:(lia)). lra. Qed.
Lemma sum_pos F n k : (forall k, (1 <= k <= n)%nat -> 0 <= F k) -> (1 <= k <= n)%nat -> 0 < F k -> 0 < sum F n.
Proof.
  induction n as [|n IH]; intros H Hk P; [lia|]. cbn [sum].
  assert (0 <= sum F n) by (apply sum_nonneg; intros; apply H; lia). pose proof (H (S n) ltac:(lia)).
  destruct (Nat.eq_dec k (S n)) as [E|E]; [subst; lra|].
  assert (0 < sum F n) by (apply IH; [intros; apply H; lia | lia | exact P]). lra.
Qed.

(* backwards: x_{M-j} = T_j(1 - lambda) x_M *)
Fixpoint chebT (z : C) (n : nat) : C := match n with
  | O => 1%C | S O => z | S (S m as k) => (2 * z * chebT z k - chebT z m)%C end.
Lemma chebT_SS z n : chebT z (S (S n)) = (2 * z * chebT z (S n) - chebT z n)%C.
Proof. reflexivity. Qed.

Lemma P2_backwards (N : nat) (lam : C) (x : nat -> C) : (forall k, (1 <= k <= S N)%nat -> P2 N x k = (lam * x k)%C) ->
  let y := fun j => match j with O => RtoC 0 | _ => x j end in
  forall j, (j <= N)%nat ->
    y (S N - j)%nat = (chebT (1 - lam)%C j * x (S N))%C /\ y (N - j)%nat = (chebT (1 - lam)%C (S j) * x (S N))%C.
Proof.
  intros H y. assert (yE : forall j, (1 <= j)%nat -> y j = x j) by (intros [|j] Hj; [lia|reflexivity]).
  induction j as [|j IH]; intros Hj.
  - rewrite !Nat.sub_0_r. split; [change (x (S N) = (RtoC 1 * x (S N))%C); ring|].
    specialize (H (S N) ltac:(lia)). change (P2 N x (S N)) with (row2 N y (S N)) in H. unfold row2 in H. rewrite Nat.eqb_refl in H.
    replace (S N - 1)%nat with N in H by lia. cbn [chebT]. change (y (S N)) with (x (S N)) in H.
    replace ((1 - lam) * x (S N))%C with (x (S N) - lam * x (S N))%C by ring. rewrite <- H. ring.
  - destruct (IH ltac:(lia)) as [A B]. split.
    + replace (S N - S j)%nat with (N - j)%nat by lia. exact B.
    + specialize (H (N - j)%nat ltac:(lia)). change (P2 N x (N - j)%nat) with (row2 N y (N - j)%nat) in H. unfold row2 in H.
      replace (Nat.eqb (N - j) (S N)) with false in H by (symmetry; apply Nat.eqb_neq; lia).
      replace (N - j - 1)%nat with (N - S j)%nat in H by lia. replace (N - j + 1)%nat with (S N - j)%nat in H by lia.
      rewrite <- (yE (N - j)%nat) in H by lia. rewrite chebT_SS.
      assert (I2 : (2 * / 2 = 1)%C) by (apply Cinv_r, C2_neq0).
      assert (E : (y (N - S j)%nat = 2 * (1 - lam) * y (N - j)%nat - y (S N - j)%nat)%C).
      { apply (f_equal (fun z => 2 * z)%C) in H.
        replace (2 * (y (N - j)%nat - / 2 * (y (N - S j)%nat + y (S N - j)%nat)))%C
          with (2 * y (N - j)%nat - (2 * / 2) * (y (N - S j)%nat + y (S N - j)%nat))%C in H by ring.
        rewrite I2 in H.
        apply (Cminus_iff (2 * (lam * y (N - j)%nat))%C (2 * y (N - j)%nat - 1 * (y (N - S j)%nat + y (S N - j)%nat))%C);
          [rewrite C2; ring | now symmetry]. }
      rewrite E, A, B. ring.
Qed.
(* lambda is an eigenvalue iff T_{N+1}(1 - lambda) = 0, and then the eigenvector is unique up to a factor *)
Lemma P2_cheb (N : nat) (lam : C) : eigenvalue N (P2 N) lam <-> chebT (1 - lam)%C (S N) = RtoC 0.
Proof.
  split.
  - intros (x & (k & Hk & Xk) & H). pose proof (P2_backwards N lam x H) as B. cbn zeta in B.
    destruct (B N (le_n N)) as [_ T]. rewrite Nat.sub_diag in T.
    assert (XN : x (S N) <> 0%C).
    { intros E. apply Xk. destruct (B (S N - k)%nat ltac:(lia)) as [A _].
      replace (S N - (S N - k))%nat with k in A by lia. destruct k as [|k]; [lia|]. rewrite A, E. ring. }
    apply (Cmult_cancel_r _ _ (x (S N)) XN). rewrite <- T. ring.
  - intros T. exists (fun j => chebT (1 - lam)%C (S N - j)). split.
    + exists (S N). split; [lia|]. rewrite Nat.sub_diag. exact C1_neq0.
    + intros k Hk. unfold P2, reduced, row2. destruct k as [|k]; [lia|]. replace (S k - 1)%nat with k by lia.
      assert (K0 : (match k with O => RtoC 0 | S _ => chebT (1 - lam)%C (S N - k) end) = chebT (1 - lam)%C (S N - k)).
      { destruct k; [|reflexivity]. rewrite Nat.sub_0_r. now symmetry. }
      cbv beta. rewrite K0. destruct (Nat.eqb_spec (S k) (S N)) as [E|E].
      * injection E as ->. rewrite Nat.sub_diag. replace (S N - N)%nat with 1%nat by lia. cbn [chebT]. ring.
      * replace (S k + 1)%nat with (S (S k)) by lia. replace (S N - k)%nat with (S (S (S N - S (S k)))) by lia.
        replace (S N - S k)%nat with (S (S N - S (S k))) by lia. rewrite chebT_SS.
        set (t1 := chebT (1 - lam)%C (S (S N - S (S k)))). set (t0 := chebT (1 - lam)%C (S N - S (S k))).
        replace (t1 - / 2 * (2 * (1 - lam) * t1 - t0 + t0))%C with (t1 - (2 * / 2) * ((1 - lam) * t1))%C by ring.
        rewrite Cinv_r by exact C2_neq0. ring.
Qed.

(* eigenvalues of P_2 are real *)
Lemma P2_real (N : nat) (lam : C) : eigenvalue N (P2 N) lam -> snd lam = 0.
Proof.
  intros (x & (k0 & Hk0 & Xk0) & H). destruct lam as [al be]. cbn [snd].
  set (y := fun j => match j with O => (RtoC 0) | _ => x j end).
  set (W := fun k => fst (y k) * snd (y (k + 1)%nat) - snd (y k) * fst (y (k + 1)%nat)).
  assert (E : forall k, (1 <= k <= N)%nat -> W k - W (k - 1)%nat = - 2 * be * (fst (x k) ^ 2 + snd (x k) ^ 2)).
  { intros k Hk. specialize (H k ltac:(lia)). change (P2 N x k) with (row2 N y k) in H. unfold row2 in H.
    replace (Nat.eqb k (S N)) with false in H by (symmetry; apply Nat.eqb_neq; lia).
    assert (Y : y k = x k) by (destruct k; [lia|reflexivity]). rewrite <- Y in H |- *. unfold W.
    replace (k - 1 + 1)%nat with k by lia.
    destruct (y k) as [p q], (y (k - 1)%nat) as [p0 q0], (y (k + 1)%nat) as [p1 q1].
    assert (H1 := f_equal fst H). assert (H2 := f_equal snd H). cbn in H1, H2 |- *.
    assert (P1' : p1 = 2 * p - p0 - 2 * (al * p - be * q)) by lra.
    assert (Q1' : q1 = 2 * q - q0 - 2 * (al * q + be * p)) by lra.
    rewrite P1', Q1'. ring. }
  assert (EN : W N = be * (fst (x (S N)) ^ 2 + snd (x (S N)) ^ 2)).
  { specialize (H (S N) ltac:(lia)). change (P2 N x (S N)) with (row2 N y (S N)) in H. unfold row2 in H. rewrite Nat.eqb_refl in H.
    replace (S N - 1)%nat with N in H by lia. change (y (S N)) with (x (S N)) in H. unfold W.
    replace (N + 1)%nat with (S N) by lia. change (y (S N)) with (x (S N)).
    destruct (x (S N)) as [p q], (y N) as [p0 q0].
    assert (H1 := f_equal fst H). assert (H2 := f_equal snd H). cbn in H1, H2 |- *.
    assert (P0' : p0 = p - (al * p - be * q)) by lra. assert (Q0' : q0 = q - (al * q + be * p)) by lra.
    rewrite P0', Q0'. ring. }
  set (F := fun k => fst (x k) ^ 2 + snd (x k) ^ 2).
  assert (F0 : forall k, 0 <= F k).
  { intros k. unfold F. pose proof (pow2_ge_0 (fst (x k))). pose proof (pow2_ge_0 (snd (x k))). lra. }
  assert (T : forall n, (n <= N)%nat -> W n = - 2 * be * sum F n).
  { induction n as [|n IH]; intros Hn.
    - unfold W. cbn. ring.
    - specialize (E (S n) ltac:(lia)). replace (S n - 1)%nat with n in E by lia. rewrite IH in E by lia.
      cbn [sum]. unfold F at 2. lra. }
  specialize (T N (le_n N)). rewrite EN in T. fold (F (S N)) in T.
  assert (P : 0 < 2 * sum F N + F (S N)).
  { assert (Fk : 0 < F k0).
    { unfold F. rewrite <- Cmod_sqr. apply pow_lt. now apply Cmod_gt_0. }
    destruct (Nat.eq_dec k0 (S N)) as [->|D].
    - assert (0 <= sum F N) by (apply sum_nonneg; intros; apply F0). lra.
    - assert (0 < sum F N) by (apply (sum_pos F N k0); [intros; apply F0 | lia | exact Fk]). pose proof (F0 (S N)). lra. }
  assert (be * (2 * sum F N + F (S N)) = 0) by lra. apply Rmult_integral in H0 as [B|B]; [exact B|lra].
Qed.

(* T_n(cos t) = cos (n t); outside [-1, 1] the polynomial has no zero *)
Lemma chebT_cos t n : chebT (RtoC (cos t)) n = RtoC (cos (INR n * t)).
Proof.
  assert (A : chebT (RtoC (cos t)) n = RtoC (cos (INR n * t)) /\ chebT (RtoC (cos t)) (S n) = RtoC (cos (INR (S n) * t))); [|apply A].
  induction n as [|n [IH0 IH1]].
  - split; cbn [chebT INR]; f_equal; [rewrite Rmult_0_l, cos_0; reflexivity | f_equal; ring].
  - split; [exact IH1|]. rewrite chebT_SS, IH0, IH1.
    replace (INR (S (S n)) * t) with (INR (S n) * t + t) by (rewrite (S_INR (S n)); ring).
    replace (INR n * t) with (INR (S n) * t - t) by (rewrite (S_INR n); ring).
    rewrite cos_plus, cos_minus. apply injective_projections; cbn; ring.
Qed.
Lemma chebT_outside z n : 1 < Rabs z -> chebT (RtoC z) n <> 0%C.
Proof.
  intros Hz. assert (A : exists p q, chebT (RtoC z) n = RtoC p /\ chebT (RtoC z) (S n) = RtoC q /\ 0 < Rabs p < Rabs q).
  { induction n as [|n (p & q & Hp & Hq & PQ)].
    - exists 1, z. split; [reflexivity|]. split; [reflexivity|]. rewrite Rabs_R1. lra.
    - exists q, (2 * z * q - p). split; [exact Hq|]. split; [rewrite chebT_SS, Hp, Hq; apply injective_projections; cbn; ring|].
      split; [lra|]. pose proof (Rabs_triang_inv (2 * z * q) p) as T. rewrite !Rabs_mult, (Rabs_right 2) in T by lra.
      assert (Rabs q * 1 < Rabs q * Rabs z) by (apply Rmult_lt_compat_l; lra). lra. }
  destruct A as (p & q & Hp & _ & P). rewrite Hp. intros E. injection E as E. rewrite E, Rabs_R0 in P. lra.
Qed.

Definition angle (N k : nat) : R := (2 * INR k - 1) * PI / (2 * (INR N + 1)).
Lemma angle_mult N k : INR (S N) * angle N k = (2 * INR k - 1) * (PI / 2).
Proof. unfold angle. rewrite S_INR. pose proof (pos_INR N). field. lra. Qed.
Lemma angle_range N k : (1 <= k <= S N)%nat -> 0 < angle N k < PI.
Proof.
  intros [A B]. apply le_INR in A, B. rewrite S_INR in B. cbn [INR] in A. pose proof (pos_INR N). pose proof PI_RGT_0.
  unfold angle. split.
  - apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat; lra|lra].
  - apply (Rmult_lt_reg_r (2 * (INR N + 1))); [lra|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. nra.
Qed.
Lemma cos_odd k : cos ((2 * INR k - 1) * (PI / 2)) = 0.
Proof.
  apply cos_eq_0_1. exists (Z.of_nat k - 1)%Z. rewrite minus_IZR, <- INR_IZR_INZ. field.
Qed.

(* veerman.specP2: the eigenvalues are exactly 1 - cos((2k-1) pi/(2(N+1))), k = 1, ..., N+1, all different *)
Theorem spectrum_P2 (N : nat) (lam : C) : eigenvalue N (P2 N) lam <->
  exists k, (1 <= k <= S N)%nat /\ lam = RtoC (1 - cos ((2 * INR k - 1) * PI / (2 * (INR N + 1)))).
Proof.
  split.
  - intros H. pose proof (P2_real N lam H) as RE. apply P2_cheb in H. destruct lam as [al be]. cbn [snd] in RE. subst be.
    replace (1 - (al, 0))%C with (RtoC (1 - al)) in H by (apply injective_projections; cbn; ring).
    destruct (Rle_lt_dec (Rabs (1 - al)) 1) as [L|L]; [|exfalso; exact (chebT_outside _ _ L H)].
    apply Rabs_le_between in L. set (t := acos (1 - al)).
    assert (Ct : cos t = 1 - al) by (apply cos_acos; lra). rewrite <- Ct, chebT_cos in H.
    apply (f_equal fst) in H. change (cos (INR (S N) * t) = 0) in H.
    apply cos_eq_0_0 in H as [z Hz]. pose proof (acos_bound (1 - al)) as [T0 T1]. fold t in T0, T1.
    pose proof PI_RGT_0 as PP. pose proof (pos_INR N) as PN. rewrite S_INR in Hz.
    assert (Z1 : (0 <= z)%Z).
    { apply Z.lt_pred_le. apply lt_IZR. assert (0 <= (INR N + 1) * t) by (apply Rmult_le_pos; lra).
      change (Z.pred 0) with (-1)%Z. nra. }
    assert (Z2 : (z < Z.of_nat (S N))%Z).
    { apply lt_IZR. rewrite <- INR_IZR_INZ, S_INR.
      assert ((INR N + 1) * t <= (INR N + 1) * PI) by (apply Rmult_le_compat_l; lra). nra. }
    exists (S (Z.to_nat z)). split; [lia|].
    assert (ZI : INR (Z.to_nat z) = IZR z) by (rewrite INR_IZR_INZ, Z2Nat.id by lia; reflexivity).
    assert (AT : (2 * INR (S (Z.to_nat z)) - 1) * PI / (2 * (INR N + 1)) = t).
    { rewrite S_INR, ZI. apply (Rmult_eq_reg_l (INR N + 1)); [|lra]. rewrite Hz. field. lra. }
    rewrite AT, Ct. apply injective_projections; cbn; ring.
  - intros (k & Hk & ->). apply P2_cheb. fold (angle N k).
    replace (1 - RtoC (1 - cos (angle N k)))%C with (RtoC (cos (angle N k))) by (apply injective_projections; cbn; ring).
    rewrite chebT_cos, angle_mult, cos_odd. reflexivity.
Qed.
Theorem spectrum_P2_simple N :
  (forall j k, (1 <= j <= S N)%nat -> (1 <= k <= S N)%nat -> j <> k ->
     1 - cos (angle N j) <> 1 - cos (angle N k)) /\
  (forall lam x y, eigenvector N (P2 N) lam x -> eigenvector N (P2 N) lam y ->
     exists c, forall k, (1 <= k <= S N)%nat -> y k = (c * x k)%C).
Proof.
  split.
  - intros j k Hj Hk D E. apply D. apply INR_eq.
    assert (A : angle N j = angle N k).
    { pose proof (angle_range N j Hj). pose proof (angle_range N k Hk).
      rewrite <- (acos_cos (angle N j)), <- (acos_cos (angle N k)) by lra. f_equal. lra. }
    pose proof (angle_mult N j) as MJ. rewrite A, angle_mult in MJ. pose proof PI_RGT_0.
    assert (2 * INR k - 1 = 2 * INR j - 1); [|lra]. apply (Rmult_eq_reg_r (PI / 2)); lra.
  - intros lam x y (X & Hx) (_ & Hy). pose proof (P2_backwards N lam x Hx) as Bx. pose proof (P2_backwards N lam y Hy) as By.
    cbn zeta in Bx, By. destruct (Ceq_dec (x (S N)) 0%C) as [Z|Z].
    + exfalso. destruct X as (k & Hk & Xk). apply Xk. destruct (Bx (S N - k)%nat ltac:(lia)) as [A _].
      replace (S N - (S N - k))%nat with k in A by lia. destruct k as [|k]; [lia|]. rewrite A, Z. ring.
    + exists (y (S N) * / x (S N))%C. intros k Hk.
      destruct (Bx (S N - k)%nat ltac:(lia)) as [A _]. destruct (By (S N - k)%nat ltac:(lia)) as [B _].
      replace (S N - (S N - k))%nat with k in A, B by lia. destruct k as [|k]; [lia|]. rewrite A, B.
      replace (y (S N) * / x (S N) * (chebT (1 - lam)%C (S N - S k) * x (S N)))%C
        with ((/ x (S N) * x (S N)) * (chebT (1 - lam)%C (S N - S k) * y (S N)))%C by ring.
      rewrite Cinv_l by exact Z. ring.
Qed.
