(* Paley et al., circulant graphs and Fourier columns: the columns of the discrete Fourier transform are orthonormal
   eigenvectors of every circulant Laplacian, with the eigenvalues 2 - 2 cos (2 pi m / N) on C_N; a balanced stationary
   point exists for N >= 2; but an eigenvector e^{i theta} need not be a symmetric pattern (rhombus on K_4 and C_12). *)
From Coq Require Import Reals Lra Lia Psatz ZArith Relations.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums paley_model paley_phase paley_laplacian paley_gradient.
Open Scope R_scope.

(* ---- when a phasor is 1 ---- *)
Lemma expi_2PI (z : Z) : expi (2 * PI * IZR z) = RtoC 1.
Proof.
  assert (N : forall m : nat, expi (2 * PI * INR m) = RtoC 1).
  { induction m as [|m IH]; [cbn [INR]; rewrite Rmult_0_r; apply expi_0|]. rewrite S_INR.
    replace (2 * PI * (INR m + 1)) with (2 * PI * INR m + 2 * PI) by ring. rewrite expi_plus, IH. unfold expi. rewrite cos_2PI, sin_2PI.
    apply injective_projections; cbn; ring. }
  destruct (Z_le_dec 0 z) as [P|P].
  - rewrite <- (Z2Nat.id z P), <- INR_IZR_INZ. apply N.
  - pose proof (N (Z.to_nat (- z))) as E. rewrite INR_IZR_INZ, Z2Nat.id, opp_IZR in E by lia.
    replace (2 * PI * - IZR z) with (- (2 * PI * IZR z)) in E by ring. unfold expi in *. rewrite cos_neg, sin_neg in E.
    injection E as E1 E2. unfold RtoC. f_equal; lra.
Qed.
Lemma expi_one a : expi a = RtoC 1 -> exists z : Z, a = 2 * PI * IZR z.
Proof.
  intros E. injection E as Ec Es. destruct (sin_eq_0_0 a Es) as [k Hk]. destruct (Z.Even_or_Odd k) as [[q ->]|[q ->]].
  - exists q. rewrite Hk, mult_IZR. ring.
  - exfalso. rewrite plus_IZR, mult_IZR in Hk. pose proof (expi_2PI q) as Q1.
    replace a with (2 * PI * IZR q + PI) in Ec by (rewrite Hk; ring).
    injection Q1 as Qc Qs. rewrite cos_plus, Qc, Qs, cos_PI, sin_PI in Ec. lra.
Qed.
Lemma expi_mult_nat m a b : expi a = expi b -> expi (INR m * a) = expi (INR m * b).
Proof.
  intros E. induction m as [|m IH]; [cbn [INR]; now rewrite !Rmult_0_l|]. rewrite S_INR, !Rmult_plus_distr_r, !Rmult_1_l, !expi_plus.
  now rewrite IH, E.
Qed.
Lemma expi_mod n m d : (1 <= n)%nat -> expi (2 * PI * INR m * INR (d mod n) / INR n) = expi (2 * PI * INR m * INR d / INR n).
Proof.
  intros Hn. pose proof (INR_pos n Hn). rewrite (Nat.div_mod d n) at 2 by lia. rewrite plus_INR, mult_INR.
  replace (2 * PI * INR m * (INR n * INR (d / n) + INR (d mod n)) / INR n)
    with (2 * PI * IZR (Z.of_nat (m * (d / n))) + 2 * PI * INR m * INR (d mod n) / INR n).
  - rewrite expi_plus, expi_2PI. symmetry. apply Cmult_1_l.
  - rewrite <- INR_IZR_INZ, mult_INR. field. lra.
Qed.

(* ---- the geometric sum ---- *)
Lemma geometric n a : (Csum n (fun k => expi (INR k * a)) * (expi a - RtoC 1))%C = (expi (INR n * a) - RtoC 1)%C.
Proof.
  induction n as [|n IH].
  - cbn [INR]. rewrite Rmult_0_l, expi_0. apply injective_projections; cbn; ring.
  - rewrite Csum_S, S_INR, Rmult_plus_distr_r, Rmult_1_l, expi_plus.
    replace ((Csum n (fun k => expi (INR k * a)) + expi (INR n * a)) * (expi a - RtoC 1))%C
      with (Csum n (fun k => expi (INR k * a)) * (expi a - RtoC 1) + expi (INR n * a) * (expi a - RtoC 1))%C by ring.
    rewrite IH. ring.
Qed.
Lemma geometric_0 n a : expi a <> RtoC 1 -> expi (INR n * a) = RtoC 1 -> Csum n (fun k => expi (INR k * a)) = RtoC 0.
Proof.
  intros N E. pose proof (geometric n a) as G. rewrite E in G.
  replace (RtoC 1 - RtoC 1)%C with (RtoC 0) in G by (apply injective_projections; cbn; ring).
  destruct (Ceq_dec (Csum n (fun k => expi (INR k * a))) (RtoC 0)) as [Z|Z]; [exact Z|exfalso].
  apply (Cmult_neq_0 _ _ Z) in G; [exact G|]. intros F. apply N.
  replace (expi a) with ((expi a - RtoC 1) + RtoC 1)%C by ring. rewrite F. apply Cplus_0_l.
Qed.
Lemma roots_sum n (z : Z) : (1 <= n)%nat -> ~ (exists q : Z, z = (q * Z.of_nat n)%Z) ->
  Csum n (fun k => expi (INR k * (2 * PI * IZR z / INR n))) = RtoC 0.
Proof.
  intros Hn ND. pose proof (INR_pos n Hn). apply geometric_0.
  - intros E. apply expi_one in E as [q Hq]. apply ND. exists q. apply eq_IZR. rewrite mult_IZR, <- INR_IZR_INZ.
    pose proof PI_RGT_0. apply (Rmult_eq_reg_l (2 * PI / INR n)).
    + transitivity (2 * PI * IZR z / INR n); [field; lra|]. rewrite Hq. field. lra.
    + apply Rgt_not_eq. apply Rdiv_lt_0_compat; lra.
  - replace (INR n * (2 * PI * IZR z / INR n)) with (2 * PI * IZR z) by (field; lra). apply expi_2PI.
Qed.

(* ---- Fourier columns ---- *)
Definition wave (n m k : nat) : R := 2 * PI * INR m * INR k / INR n.
Definition dft (n k m : nat) : C := (RtoC (/ sqrt (INR n)) * expi (wave n m k))%C.   (* columns m = 0..n-1 *)
Theorem dft_unitary n m l : (1 <= n)%nat -> (m < n)%nat -> (l < n)%nat ->
  Csum n (fun k => Cconj (dft n k m) * dft n k l)%C = RtoC (delta m l).
Proof.
  intros Hn Hm Hl. pose proof (INR_pos n Hn) as P.
  assert (SQ : / sqrt (INR n) * / sqrt (INR n) = / INR n) by (rewrite <- Rinv_mult, sqrt_sqrt; lra).
  rewrite (Csum_ext n _ (fun k => RtoC (/ INR n) * expi (INR k * (2 * PI * IZR (Z.of_nat l - Z.of_nat m) / INR n)))%C).
  - rewrite Csum_scal. unfold delta. destruct (Nat.eqb_spec m l) as [->|D].
    + rewrite (Csum_ext n _ (fun _ => RtoC 1)).
      * rewrite Csum_const. apply injective_projections; cbn; field; lra.
      * intros k _. rewrite Z.sub_diag. replace (INR k * (2 * PI * 0 / INR n)) with 0 by (field; lra). apply expi_0.
    + rewrite roots_sum; [apply Cmult_0_r|assumption|]. intros [q Hq]. assert (q = 0)%Z by nia. lia.
  - intros k _. unfold dft. rewrite minus_IZR, <- !INR_IZR_INZ.
    replace (INR k * (2 * PI * (INR l - INR m) / INR n)) with (wave n l k - wave n m k) by (unfold wave; field; lra).
    unfold expi, Cconj, Cmult, RtoC; cbn [fst snd]. rewrite cos_minus, sin_minus, <- SQ. f_equal; ring.
Qed.

(* circulant graphs: whether j is a neighbour of k depends on j - k modulo n *)
Definition circulant (n : nat) (adj : graph) (s : nat -> bool) :=
  forall k j, (k < n)%nat -> (j < n)%nat -> adj k j = s ((j + n - k) mod n).
Lemma Sum_split a b f : Sum (a + b) f = Sum a f + Sum b (fun i => f (a + i)%nat).
Proof.
  induction b as [|b IH]; [rewrite Nat.add_0_r; cbn; ring|]. rewrite Nat.add_succ_r. cbn. rewrite IH. ring.
Qed.
Lemma Sum_rotate n k (f : nat -> R) : (k < n)%nat -> Sum n (fun j => f ((j + n - k) mod n)) = Sum n f.
Proof.
  intros Hk. set (g := fun j => f ((j + n - k) mod n)).
  transitivity (Sum (k + (n - k)) g); [now replace (k + (n - k))%nat with n by lia|].
  transitivity (Sum ((n - k) + k) f); [|now replace ((n - k) + k)%nat with n by lia].
  rewrite !Sum_split, Rplus_comm. unfold g. f_equal; apply Sum_ext; intros i Hi; f_equal.
  - replace (k + i + n - k)%nat with (i + 1 * n)%nat by lia. rewrite Nat.mod_add, Nat.mod_small; lia.
  - rewrite Nat.mod_small; lia.
Qed.
Lemma Csum_rotate n k (f : nat -> C) : (k < n)%nat -> Csum n (fun j => f ((j + n - k) mod n)) = Csum n f.
Proof.
  intros Hk. unfold Csum. f_equal; [apply (Sum_rotate n k (fun j => fst (f j)) Hk)|apply (Sum_rotate n k (fun j => snd (f j)) Hk)].
Qed.
Definition circulant_eigenvalue (n : nat) (s : nat -> bool) (m : nat) : C :=
  Csum n (fun d => RtoC (if s d then 1 else 0) * (RtoC 1 - expi (wave n m d)))%C.
Theorem circulant_eigenvector n adj s m : (1 <= n)%nat -> circulant n adj s ->
  eigenvector n (lap n adj) (circulant_eigenvalue n s m) (fun k => expi (wave n m k)).
Proof.
  intros Hn HC k Hk. pose proof (INR_pos n Hn) as P. rewrite row_lap by assumption.
  rewrite Cmult_comm. unfold circulant_eigenvalue. rewrite <- Csum_scal.
  rewrite <- (Csum_rotate n k (fun d => expi (wave n m k) * (RtoC (if s d then 1 else 0) * (RtoC 1 - expi (wave n m d))))%C Hk).
  apply Csum_ext; intros j Hj. unfold w. rewrite (HC k j Hk Hj).
  assert (E : expi (wave n m j) = (expi (wave n m k) * expi (wave n m ((j + n - k) mod n)))%C).
  { unfold wave. rewrite expi_mod, <- expi_plus by assumption. rewrite minus_INR, plus_INR by lia.
    replace (2 * PI * INR m * INR k / INR n + 2 * PI * INR m * (INR j + INR n - INR k) / INR n)
      with (2 * PI * IZR (Z.of_nat m) + 2 * PI * INR m * INR j / INR n) by (rewrite <- INR_IZR_INZ; field; lra).
    rewrite expi_plus, expi_2PI. symmetry. apply Cmult_1_l. }
  rewrite E. apply injective_projections; cbn; ring.
Qed.
Lemma eigenvector_scal n A lam x (c : C) : eigenvector n A lam x -> eigenvector n A lam (fun k => c * x k)%C.
Proof.
  intros E k Hk. unfold row. rewrite (Csum_ext n _ (fun j => c * (RtoC (A k j) * x j))%C) by (intros; ring).
  rewrite Csum_scal. change (Csum n (fun j => RtoC (A k j) * x j)%C) with (row n A k x). rewrite (E k Hk). ring.
Qed.
Theorem dft_diagonalizes n adj s m : (1 <= n)%nat -> circulant n adj s ->
  eigenvector n (lap n adj) (circulant_eigenvalue n s m) (fun k => dft n k m).
Proof. intros Hn HC. apply (eigenvector_scal n (lap n adj) _ (fun k => expi (wave n m k))). now apply circulant_eigenvector. Qed.

(* ---- K_N and C_N ---- *)
Definition ring_offset (n d : nat) : bool := (Nat.eqb d 1 || Nat.eqb d (n - 1))%bool.
Definition ring_graph (n k j : nat) : bool := ring_offset n ((j + n - k) mod n).
Lemma ring_circulant n : circulant n (ring_graph n) (ring_offset n).
Proof. intros k j _ _. reflexivity. Qed.
Lemma complete_circulant n : circulant n complete (fun d => negb (Nat.eqb d 0)).
Proof.
  intros k j Hk Hj. unfold complete. f_equal. destruct (Nat.eqb_spec k j) as [->|D].
  - replace (j + n - j)%nat with (0 + 1 * n)%nat by lia. rewrite Nat.mod_add, Nat.mod_0_l by lia. reflexivity.
  - symmetry. apply Nat.eqb_neq. destruct (Nat.lt_ge_cases j k).
    + rewrite Nat.mod_small; lia.
    + replace (j + n - k)%nat with ((j - k) + 1 * n)%nat by lia. rewrite Nat.mod_add, Nat.mod_small; lia.
Qed.
Lemma ring_sum n (f : nat -> R) : (3 <= n)%nat -> Sum n (fun d => (if ring_offset n d then 1 else 0) * f d) = f 1%nat + f (n - 1)%nat.
Proof.
  intros Hn. rewrite (Sum_ext n _ (fun d => delta d 1 * f d + delta d (n - 1) * f d)).
  - rewrite Sum_plus, !Sum_delta by lia. reflexivity.
  - intros d _. unfold ring_offset, delta. destruct (Nat.eqb_spec d 1), (Nat.eqb_spec d (n - 1)); cbn; subst; try lia; ring.
Qed.
Theorem ring_eigenvalue n m : (3 <= n)%nat -> circulant_eigenvalue n (ring_offset n) m = RtoC (2 - 2 * cos (2 * PI * INR m / INR n)).
Proof.
  intros Hn. pose proof (INR_pos n ltac:(lia)) as P.
  assert (E1 : wave n m 1 = 2 * PI * INR m / INR n) by (unfold wave; cbn [INR]; field; lra).
  assert (E2 : wave n m (n - 1) = 2 * PI * IZR (Z.of_nat m) - 2 * PI * INR m / INR n).
  { unfold wave. rewrite minus_INR, <- INR_IZR_INZ by lia. cbn [INR]. field. lra. }
  assert (E3 : expi (wave n m (n - 1)) = expi (- (2 * PI * INR m / INR n))).
  { rewrite E2. unfold Rminus. rewrite expi_plus, expi_2PI. apply Cmult_1_l. }
  unfold expi in E3. rewrite cos_neg, sin_neg in E3. injection E3 as E3c E3s.
  unfold circulant_eigenvalue, Csum, RtoC; cbn [fst snd]. f_equal.
  - rewrite (Sum_ext n _ (fun d => (if ring_offset n d then 1 else 0) * (1 - cos (wave n m d)))) by (intros; cbn; ring).
    rewrite ring_sum by assumption. rewrite E3c, E1. ring.
  - rewrite (Sum_ext n _ (fun d => (if ring_offset n d then 1 else 0) * (- sin (wave n m d)))) by (intros; cbn; ring).
    rewrite ring_sum by assumption. rewrite E3s, E1. ring.
Qed.
(* the neighbours on a ring, and phasors that are opposite two nodes apart, on a ring of a number of nodes that 4 divides *)
Lemma ring_neighbours n k (f : nat -> R) : (3 <= n)%nat -> (k < n)%nat ->
  Sum n (fun j => w (ring_graph n) k j * f j) = f ((k + 1) mod n) + f ((k + (n - 1)) mod n).
Proof.
  intros Hn Hk. rewrite <- (ring_sum n (fun d => f ((k + d) mod n)) Hn).
  rewrite <- (Sum_rotate n k (fun d => (if ring_offset n d then 1 else 0) * f ((k + d) mod n)) Hk).
  apply Sum_ext; intros j Hj. unfold w, ring_graph. do 2 f_equal.
  rewrite Nat.add_mod_idemp_r by lia. replace (k + (j + n - k))%nat with (j + 1 * n)%nat by lia. rewrite Nat.mod_add, Nat.mod_small; lia.
Qed.
Theorem ring_antipodal p (x : nat -> C) : (1 <= p)%nat -> (forall j, x (j + 2)%nat = (- x j)%C) ->
  eigenvector (4 * p) (lap (4 * p) (ring_graph (4 * p))) (RtoC 2) x.
Proof.
  intros Hp A k Hk. set (n := (4 * p)%nat) in *. assert (Hn : (3 <= n)%nat) by (unfold n; lia).
  assert (A4 : forall q j, x (j + 4 * q)%nat = x j).
  { induction q as [|q IH]; intros j; [f_equal; lia|]. replace (j + 4 * Datatypes.S q)%nat with (j + 4 * q + 2 + 2)%nat by lia. rewrite !A, IH. ring. }
  assert (Am : forall j, x (j mod n) = x j).
  { intros j. rewrite (Nat.div_mod j n) at 2 by lia. rewrite Nat.add_comm. replace (n * (j / n))%nat with (4 * (p * (j / n)))%nat by (unfold n; now rewrite Nat.mul_assoc). symmetry. apply A4. }
  assert (B : x ((k + (n - 1)) mod n) = (- x ((k + 1) mod n))%C).
  { rewrite !Am, <- A. replace (k + (n - 1))%nat with (k + 1 + 2 + 4 * (p - 1))%nat by (unfold n; lia). apply A4. }
  rewrite row_lap by exact Hk. unfold Csum. apply injective_projections; cbn [fst snd].
  - rewrite (Sum_ext n _ (fun j => w (ring_graph n) k j * (fst (x k) - fst (x j)))) by (intros; cbn; ring).
    rewrite (ring_neighbours n k (fun j => fst (x k) - fst (x j)) Hn Hk), B. cbn. ring.
  - rewrite (Sum_ext n _ (fun j => w (ring_graph n) k j * (snd (x k) - snd (x j)))) by (intros; cbn; ring).
    rewrite (ring_neighbours n k (fun j => snd (x k) - snd (x j)) Hn Hk), B. cbn. ring.
Qed.
(* ---- the eigenvectors of the ring with entries of modulus one: columns of the Fourier matrix up to rotation, or opposite two nodes apart ---- *)
Lemma unit_sqr t : fst (expi t) ^ 2 + snd (expi t) ^ 2 = 1.
Proof. unfold expi; cbn [fst snd]. pose proof (sin2_cos2 t) as H. unfold Rsqr in H. lra. Qed.
Theorem ring_unit_eigenvectors n th lam : (3 <= n)%nat -> eigenvector n (lap n (ring_graph n)) lam (phasors th) ->
  (exists m, (m < n)%nat /\ forall k, (k < n)%nat -> expi (th k) = (expi (th 0%nat) * expi (wave n m k))%C) \/
  ((exists p, n = (4 * p)%nat) /\ forall k, (k < n)%nat -> expi (th ((k + 2) mod n)) = (- expi (th k))%C).
Proof.
  intros Hn E. pose proof (INR_pos n ltac:(lia)) as Pn.
  (* around the ring for ever: psi (k + n) = psi k; the turn from k to k + 1 is q + i p *)
  set (ps := fun k => th (k mod n)). set (c := (RtoC 2 - lam)%C).
  assert (Per : forall k, ps (k + n)%nat = ps k).
  { intros k. unfold ps. f_equal. replace (k + n)%nat with (k + 1 * n)%nat by lia. rewrite Nat.mod_add by lia. reflexivity. }
  assert (Rec : forall k, (expi (ps k) + expi (ps (k + 2)%nat))%C = (c * expi (ps (k + 1)%nat))%C).
  { intros k. set (j := ((k + 1) mod n)%nat). assert (Hj : (j < n)%nat) by (apply Nat.mod_upper_bound; lia). pose proof (E j Hj) as R.
    assert (A : ((j + 1) mod n)%nat = ((k + 2) mod n)%nat) by (unfold j; rewrite Nat.add_mod_idemp_l by lia; f_equal; lia).
    assert (B : ((j + (n - 1)) mod n)%nat = (k mod n)%nat).
    { unfold j. rewrite Nat.add_mod_idemp_l by lia. replace (k + 1 + (n - 1))%nat with (k + 1 * n)%nat by lia. apply Nat.mod_add. lia. }
    assert (S : row n (lap n (ring_graph n)) j (phasors th) = (RtoC 2 * expi (ps (k + 1)%nat) - (expi (ps k) + expi (ps (k + 2)%nat)))%C).
    { rewrite row_lap by exact Hj. unfold Csum, ps. apply injective_projections; cbn [fst snd].
      - rewrite (Sum_ext n _ (fun i => w (ring_graph n) j i * (fst (phasors th j) - fst (phasors th i)))) by (intros; cbn; ring).
        rewrite (ring_neighbours n j (fun i => fst (phasors th j) - fst (phasors th i)) Hn Hj), A, B. unfold phasors. fold j. cbn. ring.
      - rewrite (Sum_ext n _ (fun i => w (ring_graph n) j i * (snd (phasors th j) - snd (phasors th i)))) by (intros; cbn; ring).
        rewrite (ring_neighbours n j (fun i => snd (phasors th j) - snd (phasors th i)) Hn Hj), A, B. unfold phasors. fold j. cbn. ring. }
    rewrite S in R. unfold phasors in R. change (th j) with (ps (k + 1)%nat) in R. unfold c.
    transitivity (RtoC 2 * expi (ps (k + 1)%nat) - (RtoC 2 * expi (ps (k + 1)%nat) - (expi (ps k) + expi (ps (k + 2)%nat))))%C; [ring|]. rewrite R. ring. }
  set (d := fun k => ps (k + 1)%nat - ps k). set (p := fun k => cos (d k)). set (q := fun k => sin (d k)).
  assert (PQ : forall k, p k ^ 2 + q k ^ 2 = 1) by (intros k; exact (unit_sqr (d k))).
  assert (Turn : forall k, p (k + 1)%nat + p k = fst c /\ q (k + 1)%nat - q k = snd c).
  { intros k. pose proof (Rec k) as R. unfold p, q, d. replace (k + 1 + 1)%nat with (k + 2)%nat by lia. unfold expi in R.
    assert (R1 := f_equal fst R). assert (R2 := f_equal snd R). cbn [fst snd Cplus Cmult] in R1, R2. rewrite !cos_minus, !sin_minus.
    pose proof (sin2_cos2 (ps (k + 1)%nat)) as U. unfold Rsqr in U. set (s1 := sin (ps (k + 1)%nat)) in *. set (c1 := cos (ps (k + 1)%nat)) in *. split.
    - transitivity ((cos (ps k) + cos (ps (k + 2)%nat)) * c1 + (sin (ps k) + sin (ps (k + 2)%nat)) * s1); [ring|]. rewrite R1, R2.
      transitivity (fst c * (s1 * s1 + c1 * c1)); [ring|rewrite U; ring].
    - transitivity ((sin (ps k) + sin (ps (k + 2)%nat)) * c1 - (cos (ps k) + cos (ps (k + 2)%nat)) * s1); [ring|]. rewrite R1, R2.
      transitivity (snd c * (s1 * s1 + c1 * c1)); [ring|rewrite U; ring]. }
  assert (Qk : forall k, q k = q 0%nat + INR k * snd c).
  { induction k as [|k IH]; [cbn; ring|]. rewrite S_INR. destruct (Turn k) as [_ T]. replace (Datatypes.S k) with (k + 1)%nat by lia. lra. }
  assert (Im : snd c = 0).
  { assert (Q : q n = q 0%nat). { unfold q, d. replace (n + 1)%nat with (1 + n)%nat by lia. rewrite Per, (Per 0%nat : ps n = ps 0%nat). reflexivity. }
    rewrite (Qk n) in Q. apply (Rmult_eq_reg_l (INR n)); lra. }
  assert (Qc : forall k, q k = q 0%nat) by (intros k; rewrite Qk, Im; ring).
  destruct (Req_dec (fst c) 0) as [Z|NZ].
  - (* opposite two nodes apart *)
    right. assert (Op : forall k, expi (ps (k + 2)%nat) = (- expi (ps k))%C).
    { intros k. pose proof (Rec k) as R. assert (C0 : c = RtoC 0) by (apply injective_projections; [exact Z|exact Im]). rewrite C0, Cmult_0_l in R.
      transitivity ((expi (ps k) + expi (ps (k + 2)%nat)) - expi (ps k))%C; [ring|]. rewrite R. ring. }
    assert (Op2 : forall j k, expi (ps (k + 2 * j)%nat) = (RtoC ((-1) ^ j) * expi (ps k))%C).
    { induction j as [|j IH]; intros k; [rewrite Nat.mul_0_r, Nat.add_0_r; cbn; ring|].
      replace (k + 2 * Datatypes.S j)%nat with (k + 2 * j + 2)%nat by lia. rewrite Op, IH. cbn [pow]. rewrite RtoC_mult. apply injective_projections; cbn; ring. }
    split.
    + assert (Sign : forall j, expi (ps (0 + 2 * j)%nat) = expi (ps 0%nat) -> (-1) ^ j = 1).
      { intros j H. rewrite Op2 in H. assert (H1 := f_equal fst H). assert (H2 := f_equal snd H). cbn in H1, H2. pose proof (sin2_cos2 (ps 0%nat)) as U. unfold Rsqr in U.
        assert (A : ((-1) ^ j - 1) * cos (ps 0%nat) = 0) by lra. assert (B : ((-1) ^ j - 1) * sin (ps 0%nat) = 0) by lra.
        assert (C : ((-1) ^ j - 1) * (sin (ps 0%nat) * sin (ps 0%nat) + cos (ps 0%nat) * cos (ps 0%nat)) = 0).
        { rewrite Rmult_plus_distr_l, <- !Rmult_assoc, A, B. ring. } rewrite U in C. lra. }
      destruct (Nat.Even_or_Odd n) as [[h H]|[h H]].
      * assert (S1 : (-1) ^ h = 1) by (apply Sign; f_equal; rewrite <- H; exact (Per 0%nat)).
        destruct (Nat.Even_or_Odd h) as [[g G]|[g G]]; [exists g; lia|]. exfalso. rewrite G, pow_add, pow_1, pow_1_even in S1. lra.
      * exfalso. assert (S1 : (-1) ^ n = 1). { apply Sign. f_equal. replace (0 + 2 * n)%nat with (0 + n + n)%nat by lia. rewrite !Per. reflexivity. }
        rewrite H, pow_add, pow_1, pow_1_even in S1. lra.
    + intros k Hk. pose proof (Op k) as R. unfold ps in R. now rewrite (Nat.mod_small k n Hk) in R.
  - (* one turn for all *)
    left. assert (Pc : forall k, p k = fst c / 2).
    { intros k. destruct (Turn k) as [T _]. pose proof (PQ k) as A. pose proof (PQ (k + 1)%nat) as B. rewrite Qc in A, B.
      assert (M : fst c * (fst c - 2 * p k) = 0). { replace (p (k + 1)%nat) with (fst c - p k) in B by lra. lra. }
      apply Rmult_integral in M as [M|M]; [contradiction|lra]. }
    set (phi := d 0%nat). assert (Step : forall k, expi (ps (k + 1)%nat) = (expi (ps k) * expi phi)%C).
    { intros k. rewrite <- expi_plus. replace (ps (k + 1)%nat) with (ps k + d k) by (unfold d; ring). rewrite !expi_plus. f_equal. unfold expi. f_equal.
      - change (p k = p 0%nat). now rewrite !Pc.
      - change (q k = q 0%nat). apply Qc. }
    assert (All : forall k, expi (ps k) = (expi (ps 0%nat) * expi (INR k * phi))%C).
    { induction k as [|k IH]; [cbn [INR]; rewrite Rmult_0_l, expi_0; ring|]. replace (Datatypes.S k) with (k + 1)%nat by lia. rewrite Step, IH, plus_INR. cbn [INR].
      rewrite Rmult_plus_distr_r, Rmult_1_l, expi_plus. ring. }
    assert (One : expi (INR n * phi) = RtoC 1).
    { pose proof (All n) as R. rewrite (Per 0%nat : ps n = ps 0%nat) in R. transitivity (/ expi (ps 0%nat) * (expi (ps 0%nat) * expi (INR n * phi)))%C; [field; apply expi_neq0|]. rewrite <- R. field. apply expi_neq0. }
    destruct (expi_one _ One) as [z Hz]. assert (Hph : phi = 2 * PI * IZR z / INR n) by (apply (Rmult_eq_reg_l (INR n)); [rewrite Hz; field; lra|lra]).
    set (m := Z.to_nat (z mod Z.of_nat n)). assert (Bz : (0 <= z mod Z.of_nat n < Z.of_nat n)%Z) by (apply Z.mod_pos_bound; lia).
    exists m. split; [unfold m; lia|]. intros k Hk. pose proof (All k) as R. unfold ps in R at 1. rewrite (Nat.mod_small k n Hk) in R. rewrite R. unfold ps. rewrite Nat.mod_0_l by lia. f_equal.
    assert (Zm : IZR z = INR n * IZR (z / Z.of_nat n) + INR m).
    { rewrite (Z.div_mod z (Z.of_nat n)) at 1 by lia. rewrite plus_IZR, mult_IZR, <- INR_IZR_INZ. unfold m. rewrite (INR_IZR_INZ (Z.to_nat _)), Z2Nat.id by lia. reflexivity. }
    unfold wave. replace (INR k * phi) with (2 * PI * IZR (Z.of_nat k * (z / Z.of_nat n)) + 2 * PI * INR m * INR k / INR n).
    + rewrite expi_plus, expi_2PI. ring.
    + rewrite Hph, Zm, mult_IZR, <- INR_IZR_INZ. field. lra.
Qed.
(* consecutive phasors of a Fourier column differ by one rotation: the edges of C_N are drawn as the polygon {N/m} *)
Theorem wave_polygon n m k : (1 <= n)%nat -> (k < n)%nat ->
  expi (wave n m ((k + 1) mod n)) = (expi (2 * PI * INR m / INR n) * expi (wave n m k))%C.
Proof.
  intros Hn _. pose proof (INR_pos n Hn). unfold wave. rewrite expi_mod, <- expi_plus by assumption. f_equal.
  rewrite plus_INR. cbn [INR]. field. lra.
Qed.
Theorem complete_row n j : (1 <= n)%nat -> (j < n)%nat -> lap n complete 0 j = (if Nat.eqb j 0 then INR n - 1 else -1).
Proof.
  intros Hn Hj. assert (D : deg n complete 0 = INR n - 1).
  { unfold deg. rewrite (Sum_ext n _ (fun j => 1 - delta j 0 * 1)).
    - rewrite Sum_minus, Sum_const, (Sum_delta n 0 (fun _ => 1)) by lia. ring.
    - intros i _. unfold w, complete, delta. destruct i; cbn; ring. }
  unfold lap. rewrite D. unfold w, complete, delta. destruct j; cbn; ring.
Qed.
Theorem ring_row n j : (3 <= n)%nat -> (j < n)%nat ->
  lap n (ring_graph n) 0 j = (if Nat.eqb j 0 then 2 else if (Nat.eqb j 1 || Nat.eqb j (n - 1))%bool then -1 else 0)
  /\ deg n (ring_graph n) j = 2.
Proof.
  intros Hn Hj.
  assert (D : forall k, (k < n)%nat -> deg n (ring_graph n) k = 2).
  { intros k Hk. unfold deg, w, ring_graph.
    rewrite (Sum_rotate n k (fun d => if ring_offset n d then 1 else 0) Hk).
    rewrite (Sum_ext n _ (fun d => (if ring_offset n d then 1 else 0) * 1)) by (intros; ring).
    rewrite (ring_sum n (fun _ => 1) Hn). ring. }
  split; [|now apply D]. unfold lap. rewrite D by lia. unfold w, ring_graph.
  replace ((j + n - 0) mod n)%nat with j.
  - unfold ring_offset, delta. destruct (Nat.eqb_spec j 0) as [->|]; [|destruct j; [contradiction|cbn [Nat.eqb]]].
    + destruct (Nat.eqb_spec 0 1); [lia|]. destruct (Nat.eqb_spec 0 (n - 1)); [lia|]. cbn. ring.
    + destruct (_ || _)%bool; ring.
  - replace (j + n - 0)%nat with (j + 1 * n)%nat by lia. rewrite Nat.mod_add, Nat.mod_small; lia.
Qed.
Theorem ring_connected n : (1 <= n)%nat -> strongly_connected n (ring_graph n).
Proof.
  intros Hn. assert (N : forall a, (S a < n)%nat -> arc n (ring_graph n) a (S a) /\ arc n (ring_graph n) (S a) a).
  { intros a Ha. repeat split; try lia; unfold ring_graph, ring_offset.
    - replace ((a + n - S a) mod n)%nat with (n - 1)%nat by (rewrite Nat.mod_small; lia). rewrite Nat.eqb_refl. now destruct (Nat.eqb _ _).
    - replace (S a + n - a)%nat with (1 + 1 * n)%nat by lia. rewrite Nat.mod_add by lia.
      destruct (Nat.eq_dec n 1); [lia|]. rewrite Nat.mod_small by lia. reflexivity. }
  assert (P : forall k, (k < n)%nat -> clos_refl_trans nat (arc n (ring_graph n)) 0%nat k /\ clos_refl_trans nat (arc n (ring_graph n)) k 0%nat).
  { induction k as [|k IH]; intros Hk; [split; apply rt_refl|]. destruct IH as [A B]; [lia|]. destruct (N k Hk) as [U V]. split.
    - eapply rt_trans; [exact A|now apply rt_step].
    - eapply rt_trans; [apply rt_step; exact V|exact B]. }
  intros j k Hj Hk. eapply rt_trans; [apply (P j Hj)|apply (P k Hk)].
Qed.

(* ---- a balanced stationary point ---- *)
Lemma splay_balanced n : (2 <= n)%nat -> balanced n (wave n 1).
Proof.
  intros Hn. pose proof (INR_pos n ltac:(lia)). unfold balanced, order, phasors.
  rewrite (Csum_ext n _ (fun k => expi (INR k * (2 * PI * IZR 1 / INR n)))).
  - rewrite roots_sum; [apply Cmult_0_r|lia|]. intros [q Hq].
    destruct (Z_le_dec q 0); [|assert (1 <= q)%Z by lia]; nia.
  - intros k _. f_equal. unfold wave. cbn [INR]. field. lra.
Qed.
Theorem balanced_exists n adj s : (2 <= n)%nat -> undirected adj -> circulant n adj s ->
  exists th, balanced n th /\ stationary n (W1 n adj) th.
Proof.
  intros Hn S HC. exists (wave n 1). split; [now apply splay_balanced|].
  apply (eigenvector_stationary n adj (wave n 1) (circulant_eigenvalue n s 1)); try lia; [assumption|].
  apply (circulant_eigenvector n adj s 1); [lia|assumption].
Qed.
Theorem balanced_needs_two th : ~ balanced 1 th.
Proof.
  unfold balanced, order, Csum, phasors. cbn. intros E. apply (expi_neq0 (th 0%nat)).
  injection E as E1 E2. unfold RtoC, expi. cbn in *. f_equal; lra.
Qed.
(* eq (8): for N >= 2 the minimisers of U_1 are exactly the balanced arrangements *)
Theorem U1_minimizers n th : (2 <= n)%nat -> (balanced n th <-> forall th', U1 n th <= U1 n th').
Proof.
  intros Hn. split; [apply U1_extremes; lia|]. intros H. apply (U1_min n th); [lia|]. apply Rle_antisym; [|apply U1_min; lia].
  rewrite <- (proj2 (proj2 (U1_min n (wave n 1) ltac:(lia))) (splay_balanced n Hn)). apply H.
Qed.
