(* Paley et al., eqs (14)-(16) and the gradient of W_1; the statements of the graph tutorial about the spectrum of
   the Laplacian of a directed graph (Gershgorin and the maximum principle). *)
From Coq Require Import Reals Lra Lia Psatz Relations.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums paley_model paley_phase paley_laplacian.
Open Scope R_scope.

Lemma inner_i_row n A th k : inner (Ci * expi (th k))%C (row n A k (phasors th)) = Sum n (fun j => A k j * sin (th j - th k)).
Proof. rewrite inner_row. apply Sum_ext; intros j _. unfold phasors. now rewrite inner_iexpi. Qed.
(* <i e^{i th_k}, L_k e^{i th}> *)
Definition gW (n : nat) (adj : graph) (th : nat -> R) (k : nat) : R :=
  inner (Ci * expi (th k))%C (row n (lap n adj) k (phasors th)).
Lemma gW_lap n adj th k : gW n adj th k = Sum n (fun j => lap n adj k j * sin (th j - th k)).
Proof. apply inner_i_row. Qed.
Theorem gW_sines n adj th k : (k < n)%nat -> gW n adj th k = Sum n (fun j => w adj k j * sin (th k - th j)).
Proof.
  intros Hk. rewrite gW_lap, (lap_mul n adj k (fun j => sin (th j - th k)) Hk). apply Sum_ext; intros j _.
  replace (th k - th k) with 0 by ring. rewrite sin_0. replace (th k - th j) with (- (th j - th k)) by ring. rewrite sin_neg. ring.
Qed.
Lemma gW_sum n adj th : undirected adj -> Sum n (gW n adj th) = 0.
Proof.
  intros S. rewrite (Sum_ext n _ (fun k => Sum n (fun j => w adj k j * sin (th k - th j)))) by (intros; now apply gW_sines).
  apply Sum_antisym. intros i j _ _. unfold w. rewrite (S j i). replace (th j - th i) with (- (th i - th j)) by ring. rewrite sin_neg. ring.
Qed.

(* the gradient; the first form holds for every directed graph *)
Theorem W1_gradient n adj th k : (1 <= n)%nat -> (k < n)%nat ->
  partial (W1 n adj) th k (/ (2 * INR n) * inner (Ci * expi (th k))%C (row n (fun k j => lap n adj k j + lap n adj j k) k (phasors th))).
Proof.
  intros Hn Hk. rewrite inner_i_row. eapply partial_ext; [intros; apply Q_phasors|].
  apply partial_scal, (partial_cos_pairs n (lap n adj) th k Hk).
Qed.
Theorem W1_gradient_undirected n adj th k : (1 <= n)%nat -> undirected adj -> (k < n)%nat ->
  / (2 * INR n) * inner (Ci * expi (th k))%C (row n (fun k j => lap n adj k j + lap n adj j k) k (phasors th)) = / INR n * gW n adj th k
  /\ partial (W1 n adj) th k (/ INR n * gW n adj th k).
Proof.
  intros Hn S Hk. pose proof (INR_pos n Hn).
  assert (E : / (2 * INR n) * inner (Ci * expi (th k))%C (row n (fun k j => lap n adj k j + lap n adj j k) k (phasors th)) = / INR n * gW n adj th k).
  { rewrite inner_i_row, gW_lap, (Sum_ext n _ (fun j => 2 * (lap n adj k j * sin (th j - th k)))).
    - rewrite Sum_scal. field. lra.
    - intros j _. rewrite (lap_sym n adj S j k). ring. }
  split; [exact E|]. rewrite <- E. now apply W1_gradient.
Qed.

(* along any curve *)
Lemma W1_along n adj (th : nat -> R -> R) om t : (1 <= n)%nat -> undirected adj ->
  (forall k, (k < n)%nat -> is_derive (th k) t (om k)) ->
  is_derive (fun s => W1 n adj (fun k => th k s)) t (/ INR n * Sum n (fun k => om k * gW n adj (fun k => th k t) k)).
Proof.
  intros Hn S H. pose proof (INR_pos n Hn).
  apply (is_derive_ext (fun s => / (2 * INR n) * cos_pairs n (lap n adj) (fun k => th k s))); [intros; symmetry; apply Q_phasors|].
  eapply D_eq; [apply D_scal, (D_cos_pairs n (lap n adj) th om t H)|].
  rewrite (Sum_ext n _ (fun k => 2 * (om k * gW n adj (fun k => th k t) k))).
  - rewrite Sum_scal. field. lra.
  - intros k _. rewrite gW_lap, <- !Sum_scal. apply Sum_ext; intros j _. rewrite (lap_sym n adj S j k). ring.
Qed.
(* the phase model (6) with the control (14) *)
Theorem W1_rate n adj (th : nat -> R -> R) w0 K1 t : (1 <= n)%nat -> undirected adj ->
  (forall k, (k < n)%nat -> is_derive (th k) t (w0 + K1 / INR n * gW n adj (fun k => th k t) k)) ->
  is_derive (fun s => W1 n adj (fun k => th k s)) t (K1 / INR n ^ 2 * Sum n (fun k => gW n adj (fun k => th k t) k ^ 2)).
Proof.
  intros Hn S H. pose proof (INR_pos n Hn). eapply D_eq; [apply (W1_along n adj th _ t Hn S H)|]. cbv beta.
  set (g := gW n adj (fun k => th k t)).
  rewrite (Sum_ext n _ (fun k => w0 * g k + K1 / INR n * g k ^ 2)) by (intros; ring).
  rewrite Sum_plus, !Sum_scal. unfold g. rewrite gW_sum by assumption. field. lra.
Qed.
Theorem control14_sines n adj th k w0 K1 : (k < n)%nat ->
  w0 + K1 / INR n * gW n adj th k = w0 + K1 / INR n * Sum n (fun j => w adj k j * sin (th k - th j)).
Proof. intros Hk. now rewrite gW_sines. Qed.

(* eq (16) *)
Theorem eq16 n adj th : (1 <= n)%nat -> undirected adj ->
  ((forall k, (k < n)%nat -> gW n adj th k = 0) <-> stationary n (W1 n adj) th).
Proof.
  intros Hn S. pose proof (INR_pos n Hn). split; intros H1 k Hk.
  - pose proof (proj2 (W1_gradient_undirected n adj th k Hn S Hk)) as P. rewrite H1, Rmult_0_r in P; assumption.
  - pose proof (partial_unique _ _ _ _ _ (proj2 (W1_gradient_undirected n adj th k Hn S Hk)) (H1 k Hk)) as E.
    apply Rmult_integral in E as [E|E]; [|exact E]. apply Rinv_neq_0_compat in E; [contradiction|lra].
Qed.
Definition eigenvector (n : nat) (A : nat -> nat -> R) (lam : C) (x : nat -> C) :=
  forall k, (k < n)%nat -> row n A k x = (lam * x k)%C.
Lemma inner_i_mul a z : inner (Ci * z)%C (a * z)%C = snd a * inner z z.
Proof. rewrite !inner_xy. cbn. ring. Qed.
Lemma inner_mul a z : inner z (a * z)%C = fst a * inner z z.
Proof. rewrite !inner_xy. cbn. ring. Qed.
Lemma inner_expi_self t : inner (expi t) (expi t) = 1.
Proof. rewrite inner_expi. replace (t - t) with 0 by ring. apply cos_0. Qed.
(* phasors that form an eigenvector (for any complex eigenvalue): a stationary point of W_1, where (14) vanishes, so that
   every phase turns at the rate w0: an equilibrium of (6) when w0 = 0, a relative one for every w0 *)
Theorem eigenvector_stationary n adj th lam : (1 <= n)%nat -> undirected adj -> eigenvector n (lap n adj) lam (phasors th) ->
  stationary n (W1 n adj) th /\ forall w0 K1 k, (k < n)%nat -> w0 + K1 / INR n * gW n adj th k = w0.
Proof.
  intros Hn S E. pose proof (INR_pos n Hn).
  assert (G : forall k, (k < n)%nat -> gW n adj th k = snd lam).
  { intros k Hk. unfold gW. rewrite (E k Hk). unfold phasors. rewrite inner_i_mul, inner_expi_self. ring. }
  assert (Z : snd lam = 0).
  { pose proof (gW_sum n adj th S) as T. rewrite (Sum_ext n _ (fun _ => snd lam)) in T by (intros; now apply G).
    rewrite Sum_const in T. nra. }
  split.
  - apply eq16; try assumption. intros k Hk. rewrite G; assumption.
  - intros w0 K1 k Hk. rewrite G, Z by assumption. ring.
Qed.

(* ---- the tutorial: spectrum of the Laplacian of a directed graph ---- *)
Lemma argmax n (f : nat -> R) : (1 <= n)%nat -> exists k, (k < n)%nat /\ forall j, (j < n)%nat -> f j <= f k.
Proof.
  intros Hn. induction n as [|n IH]; [lia|]. destruct n as [|n].
  - exists 0%nat. split; [lia|]. intros j Hj. replace j with 0%nat by lia. lra.
  - destruct IH as [k [Hk M]]; [lia|]. destruct (Rle_or_lt (f (Datatypes.S n)) (f k)) as [L|L].
    + exists k. split; [lia|]. intros j Hj. destruct (Nat.eq_dec j (Datatypes.S n)) as [->|]; [exact L|apply M; lia].
    + exists (Datatypes.S n). split; [lia|]. intros j Hj. destruct (Nat.eq_dec j (Datatypes.S n)) as [->|]; [lra|].
      pose proof (M j ltac:(lia)). lra.
Qed.
Lemma inner_le x y : inner x y <= / 2 * (inner x x + inner y y).
Proof. rewrite !inner_xy. pose proof (pow2_ge_0 (fst x - fst y)). pose proof (pow2_ge_0 (snd x - snd y)). lra. Qed.
Theorem lap_eigenvalues n adj lam x : eigenvector n (lap n adj) lam x -> (exists k, (k < n)%nat /\ x k <> RtoC 0) -> 0 <= fst lam.
Proof.
  intros E [i [Hi Xi]]. destruct (argmax n (fun k => inner (x k) (x k))) as [k [Hk M]]; [lia|].
  assert (P : 0 < inner (x k) (x k)).
  { apply Rlt_le_trans with (inner (x i) (x i)); [|now apply M]. destruct (inner_self_ge0 (x i)) as [|Z]; [assumption|].
    exfalso. apply Xi, inner_self_0. now symmetry. }
  assert (G : 0 <= inner (x k) (row n (lap n adj) k x)).
  { rewrite row_lap, inner_Csum by assumption. apply Sum_ge0; intros j Hj. rewrite inner_scal, inner_minus.
    apply Rmult_le_pos; [apply w_ge0|]. pose proof (inner_le (x k) (x j)). pose proof (M j Hj). lra. }
  rewrite (E k Hk), inner_mul in G. nra.
Qed.
Definition lmul (n : nat) (adj : graph) (y : nat -> R) (k : nat) : R := Sum n (fun j => lap n adj k j * y j).
Theorem lap_ones n adj c k : (k < n)%nat -> lmul n adj (fun _ => c) k = 0.
Proof. intros Hk. unfold lmul. rewrite (lap_mul n adj k (fun _ => c) Hk). apply Sum_zero; intros; ring. Qed.
Lemma lmul_opp n adj y k : lmul n adj (fun j => - y j) k = - lmul n adj y k.
Proof. unfold lmul. rewrite <- Sum_opp. apply Sum_ext; intros; ring. Qed.
(* L y = c 1 only for c = 0 *)
Lemma lap_not_onto_ones n adj y c : (1 <= n)%nat -> (forall k, (k < n)%nat -> lmul n adj y k = c) -> c = 0.
Proof.
  assert (A : forall y c, (1 <= n)%nat -> (forall k, (k < n)%nat -> lmul n adj y k = c) -> 0 <= c).
  { clear. intros y c Hn E. destruct (argmax n y Hn) as [k [Hk M]]. rewrite <- (E k Hk). unfold lmul.
    rewrite (lap_mul n adj k y Hk). apply Sum_ge0; intros j Hj. apply Rmult_le_pos; [apply w_ge0|]. pose proof (M j Hj). lra. }
  intros Hn E. apply Rle_antisym; [|now apply (A y)]. apply Ropp_le_cancel. rewrite Ropp_0.
  apply (A (fun j => - y j)); [assumption|]. intros k Hk. rewrite lmul_opp. now rewrite E.
Qed.
Theorem lap_kernel n adj y : (1 <= n)%nat -> strongly_connected n adj -> (forall k, (k < n)%nat -> lmul n adj y k = 0) ->
  exists c, forall k, (k < n)%nat -> y k = c.
Proof.
  intros Hn SC E. destruct (argmax n y Hn) as [k [Hk M]]. exists (y k). intros j Hj.
  assert (Step : forall a b, arc n adj a b -> y b = y k -> y a = y k).
  { intros a b [Ha [Hb A]] Yb. specialize (E b Hb). unfold lmul in E. rewrite (lap_mul n adj b y Hb) in E.
    assert (Z : w adj b a * (y b - y a) = 0).
    { apply (Sum_eq0 n (fun j => w adj b j * (y b - y j))); try assumption. intros i Hi.
      apply Rmult_le_pos; [apply w_ge0|]. rewrite Yb. pose proof (M i Hi). lra. }
    unfold w in Z. rewrite A in Z. lra. }
  pose proof (SC j k Hj Hk) as P. apply clos_rt_rt1n in P. induction P as [|a b c A P IH]; [reflexivity|].
  apply (Step a b A). destruct A as [_ [Hb _]]. now apply IH.
Qed.
(* multiplicity one, algebraic: no power of L has a larger kernel *)
Fixpoint lpow (n : nat) (adj : graph) (m : nat) (y : nat -> R) : nat -> R :=
  match m with O => y | Datatypes.S m => lmul n adj (lpow n adj m y) end.
Theorem lap_zero_simple n adj m y : (1 <= n)%nat -> strongly_connected n adj ->
  (forall k, (k < n)%nat -> lpow n adj (Datatypes.S m) y k = 0) -> exists c, forall k, (k < n)%nat -> y k = c.
Proof.
  intros Hn SC. induction m as [|m IH]; intros H; [now apply (lap_kernel n adj y)|].
  destruct (lap_kernel n adj (lpow n adj (Datatypes.S m) y) Hn SC H) as [c Hc]. apply IH. intros k Hk. rewrite Hc by assumption.
  apply (lap_not_onto_ones n adj (lpow n adj m y) c Hn). exact Hc.
Qed.
Theorem lap_psd n adj x : undirected adj -> (forall k j, lap n adj k j = lap n adj j k) /\
  0 <= Sum n (fun k => inner (x k) (row n (lap n adj) k x)).
Proof. intros S. split; [now apply lap_sym|]. rewrite lap_form by assumption. pose proof (total_ge0 n adj x). lra. Qed.

(* ---- eq (17): the spacing potential is definite and proper in the relative centres ---- *)
Lemma path_bound n adj j k : undirected adj -> clos_refl_trans nat (arc n adj) j k ->
  exists B, 0 <= B /\ forall x, dist2 (x j) (x k) <= B * total n adj x.
Proof.
  intros S P. induction P as [j k A|j|j i k _ [B [HB IB]] _ [D [HD ID]]].
  - exists 1. split; [lra|]. intros x. destruct A as [Hj [Hk A]].
    assert (T : forall k j, 0 <= w adj k j * dist2 (x k) (x j)) by (intros; apply Rmult_le_pos; [apply w_ge0|apply dist2_ge0]).
    assert (L : w adj k j * dist2 (x k) (x j) <= total n adj x).
    { apply Rle_trans with (Sum n (fun j => w adj k j * dist2 (x k) (x j))).
      - apply (Sum_term_le n (fun j => w adj k j * dist2 (x k) (x j))); [intros; apply T|assumption].
      - apply (Sum_term_le n (fun k => Sum n (fun j => w adj k j * dist2 (x k) (x j)))); [|assumption].
        intros; apply Sum_ge0; intros; apply T. }
    unfold w in L. rewrite A in L. rewrite dist2_xy in L |- *. lra.
  - exists 0. split; [lra|]. intros x. rewrite dist2_xy. lra.
  - exists (2 * B + 2 * D). split; [lra|]. intros x. specialize (IB x). specialize (ID x). rewrite dist2_xy in *.
    pose proof (pow2_ge_0 ((fst (x j) - fst (x i)) - (fst (x i) - fst (x k)))).
    pose proof (pow2_ge_0 ((snd (x j) - snd (x i)) - (snd (x i) - snd (x k)))). lra.
Qed.
Theorem spacing_proper n adj : (1 <= n)%nat -> undirected adj -> strongly_connected n adj ->
  exists B, 0 <= B /\ forall c j k, (j < n)%nat -> (k < n)%nat -> dist2 (c j) (c k) <= B * Q n (lap n adj) c.
Proof.
  intros Hn S SC. pose proof (INR_pos n Hn).
  assert (F : forall m, (m <= n)%nat -> exists B, 0 <= B /\ forall x k, (k < m)%nat -> dist2 (x 0%nat) (x k) <= B * total n adj x).
  { induction m as [|m IH]; intros Hm; [exists 0; split; [lra|intros; lia]|]. destruct IH as [B [HB IB]]; [lia|].
    destruct (path_bound n adj 0 m S (SC 0%nat m ltac:(lia) ltac:(lia))) as [D [HD ID]]. exists (B + D). split; [lra|].
    intros x k Hk. pose proof (total_ge0 n adj x). destruct (Nat.eq_dec k m) as [->|].
    - pose proof (ID x). nra.
    - pose proof (IB x k ltac:(lia)). nra. }
  destruct (F n (le_n n)) as [B [HB IB]]. exists (4 * B * (4 * INR n)). split; [apply Rmult_le_pos; lra|]. intros c j k Hj Hk.
  rewrite Q_total by assumption. replace (4 * B * (4 * INR n) * (/ (4 * INR n) * total n adj c)) with (4 * (B * total n adj c)) by (field; lra).
  pose proof (IB c j Hj) as Ij. pose proof (IB c k Hk) as Ik. rewrite dist2_xy in *.
  pose proof (pow2_ge_0 ((fst (c 0%nat) - fst (c j)) + (fst (c 0%nat) - fst (c k)))).
  pose proof (pow2_ge_0 ((snd (c 0%nat) - snd (c j)) + (snd (c 0%nat) - snd (c k)))). lra.
Qed.
