(* Paley et al., text after eq (22), corrected: the phases that maximise W_1 on an undirected connected circulant graph.
     beyond.paley.bal.circ (clauses 2, 3), paley.bal.circ (corrected).
   Parseval: <x, L x> is the sum of lambda_m |x_m|^2, x_m = <f_m, x> for the Fourier columns f_m; so it is at most lambda_max |x|^2, with equality only for eigenvectors. *)
From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums paley_model paley_phase paley_laplacian paley_gradient paley_fourier.
Open Scope R_scope.

Lemma all_or_one p (A : nat -> Prop) : (forall m, {A m} + {~ A m}) -> (forall m, (m < p)%nat -> A m) \/ exists m, (m < p)%nat /\ ~ A m.
Proof.
  intros D. induction p as [|p [IH|(m & Hm & Nm)]]; [left; intros; lia| |right; exists m; split; [lia|exact Nm]].
  destruct (D p) as [Y|N]; [left; intros m Hm; destruct (Nat.eq_dec m p) as [->|]; [exact Y|apply IH; lia]|right; exists p; split; [lia|exact N]].
Qed.
Section Parseval.
Variables (n : nat) (adj : graph) (s : nat -> bool).
Hypotheses (Hn : (1 <= n)%nat) (S : undirected adj) (HC : circulant n adj s).
Notation L := (lap n adj).
Notation f := (dft n).
Definition lam (m : nat) : R := fst (circulant_eigenvalue n s m).
Definition coef (x : nat -> C) (m : nat) : C := Csum n (fun k => Cconj (f k m) * x k)%C.
Lemma dft_sym k m : f k m = f m k.
Proof. unfold dft, wave. do 2 f_equal. unfold Rdiv. ring. Qed.
Lemma Csum_conj h : Cconj (Csum n h) = Csum n (fun k => Cconj (h k)).
Proof. unfold Csum, Cconj. cbn [fst snd]. f_equal. rewrite <- (Rmult_1_l (Sum n (fun k => snd (h k)))). rewrite Ropp_mult_distr_l, <- Sum_scal. apply Sum_ext. intros. ring. Qed.
Lemma Cconj_mult (a b : C) : Cconj (a * b)%C = (Cconj a * Cconj b)%C.
Proof. apply injective_projections; cbn; ring. Qed.
Lemma Cconj_conj (a : C) : Cconj (Cconj a) = a.
Proof. apply injective_projections; cbn; ring. Qed.
(* completeness: the rows are orthonormal too *)
Lemma expansion x k : (k < n)%nat -> x k = Csum n (fun m => f k m * coef x m)%C.
Proof.
  intros Hk. unfold coef. rewrite (Csum_ext n _ (fun m => Csum n (fun j => (Cconj (f m j) * f m k) * x j)%C)).
  - rewrite Csum_swap. rewrite (Csum_ext n _ (fun j => (RtoC (delta j k) * x j)%C)).
    + apply injective_projections; unfold Csum; cbn; [rewrite <- (Sum_delta n k (fun j => fst (x j)) Hk)|rewrite <- (Sum_delta n k (fun j => snd (x j)) Hk)]; apply Sum_ext; intros; ring.
    + intros j Hj. rewrite (Csum_ext n _ (fun m => x j * (Cconj (f m j) * f m k))%C) by (intros; ring). rewrite Csum_scal, dft_unitary by assumption. ring.
  - intros m Hm. rewrite <- Csum_scal. apply Csum_ext. intros j Hj. rewrite (dft_sym k m), (dft_sym j m). ring.
Qed.
Lemma symmetric_row x y : Csum n (fun k => Cconj (x k) * row n L k y)%C = Csum n (fun k => Cconj (row n L k x) * y k)%C.
Proof.
  unfold row. rewrite (Csum_ext n _ (fun k => Csum n (fun j => Cconj (x k) * (RtoC (L k j) * y j))%C)) by (intros; symmetry; apply Csum_scal).
  rewrite Csum_swap. apply Csum_ext. intros j Hj. rewrite Csum_conj, Cmult_comm, <- Csum_scal. apply Csum_ext. intros k Hk.
  replace (L k j) with (L j k) by (apply lap_sym; exact S). apply injective_projections; cbn; ring.
Qed.
Lemma real_eigenvalue m : (m < n)%nat -> circulant_eigenvalue n s m = RtoC (lam m).
Proof.
  intros Hm. pose proof (dft_diagonalizes n adj s m Hn HC) as E. pose proof (symmetric_row (fun k => f k m) (fun k => f k m)) as Y. set (mu := circulant_eigenvalue n s m) in *.
  rewrite (Csum_ext n _ (fun k => mu * (Cconj (f k m) * f k m))%C) in Y by (intros k Hk; rewrite (E k Hk); ring).
  rewrite (Csum_ext n (fun k => Cconj (row n L k (fun k0 => f k0 m)) * f k m)%C (fun k => Cconj mu * (Cconj (f k m) * f k m))%C) in Y
    by (intros k Hk; rewrite (E k Hk), Cconj_mult; ring).
  rewrite !Csum_scal, dft_unitary, delta_eq, !Cmult_1_r in Y by assumption. unfold lam. fold mu. destruct mu as [a b]. injection Y as Y. cbn. unfold RtoC. f_equal. lra.
Qed.
Lemma coef_row x m : (m < n)%nat -> coef (fun k => row n L k x) m = (RtoC (lam m) * coef x m)%C.
Proof.
  intros Hm. unfold coef. rewrite symmetric_row. pose proof (dft_diagonalizes n adj s m Hn HC) as E. rewrite <- Csum_scal. apply Csum_ext. intros k Hk.
  rewrite (E k Hk), Cconj_mult, (real_eigenvalue m Hm). apply injective_projections; cbn; ring.
Qed.
Lemma parseval x y : Sum n (fun k => inner (x k) (y k)) = Sum n (fun m => inner (coef x m) (coef y m)).
Proof.
  assert (E : forall a b : C, inner a b = fst (Cconj a * b)%C) by reflexivity.
  assert (T : Csum n (fun k => Cconj (x k) * y k)%C = Csum n (fun m => Cconj (coef x m) * coef y m)%C).
  { transitivity (Csum n (fun k => Csum n (fun m => Cconj (x k) * (f k m * coef y m))%C)); [apply Csum_ext; intros k Hk; rewrite Csum_scal, <- (expansion y k Hk); reflexivity|].
    rewrite Csum_swap. apply Csum_ext. intros m Hm. unfold coef at 2. rewrite Csum_conj, Cmult_comm, <- Csum_scal. apply Csum_ext. intros k Hk. rewrite Cconj_mult, Cconj_conj. ring. }
  apply (f_equal fst) in T. exact T.
Qed.
(* x is an eigenvector of the largest lambda_m *)
Variable top : nat.
Hypothesis Htop : (top < n)%nat.
Hypothesis Ltop : forall m, (m < n)%nat -> lam m <= lam top.
Lemma Q_coef x : Q n L x = / (2 * INR n) * Sum n (fun m => lam m * inner (coef x m) (coef x m)).
Proof.
  unfold Q. fold (row n L). f_equal. transitivity (Sum n (fun k => inner (x k) ((fun j => row n L j x) k))); [reflexivity|]. rewrite parseval. apply Sum_ext. intros m Hm.
  rewrite (coef_row x m Hm). apply inner_scal.
Qed.
Lemma Q_top x : Q n L x <= lam top / (2 * INR n) * Sum n (fun k => inner (x k) (x k)).
Proof.
  pose proof (INR_pos n Hn) as P. rewrite Q_coef, (parseval x x).
  replace (lam top / (2 * INR n) * Sum n (fun m => inner (coef x m) (coef x m))) with (/ (2 * INR n) * Sum n (fun m => lam top * inner (coef x m) (coef x m))) by (rewrite Sum_scal; unfold Rdiv; ring).
  apply Rmult_le_compat_l; [left; apply Rinv_0_lt_compat; lra|]. apply Sum_le. intros m Hm. apply Rmult_le_compat_r; [apply inner_self_ge0|now apply Ltop].
Qed.
Lemma eigen_top x : Q n L x = lam top / (2 * INR n) * Sum n (fun k => inner (x k) (x k)) -> eigenvector n L (RtoC (lam top)) x.
Proof.
  pose proof (INR_pos n Hn) as P. intros E. rewrite Q_coef, (parseval x x) in E.
  assert (Z : Sum n (fun m => (lam top - lam m) * inner (coef x m) (coef x m)) = 0).
  { rewrite (Sum_ext n _ (fun m => lam top * inner (coef x m) (coef x m) + - (lam m * inner (coef x m) (coef x m)))) by (intros; ring). rewrite Sum_plus, Sum_scal.
    rewrite (Sum_ext n (fun m => - (lam m * inner (coef x m) (coef x m))) (fun m => -1 * (lam m * inner (coef x m) (coef x m)))) by (intros; ring). rewrite Sum_scal.
    apply (Rmult_eq_compat_l (2 * INR n)) in E. rewrite <- Rmult_assoc, Rinv_r, Rmult_1_l in E by lra. rewrite E. field. lra. }
  assert (T : forall m, (m < n)%nat -> (RtoC (lam m) * coef x m)%C = (RtoC (lam top) * coef x m)%C).
  { intros m Hm. pose proof (Sum_eq0 n _ (fun m Hm => Rmult_le_pos _ _ (proj1 (Rminus_le_0 _ _) (Ltop m Hm)) (inner_self_ge0 (coef x m))) Z m Hm) as Q0. cbv beta in Q0.
    apply Rmult_integral in Q0. destruct Q0 as [Q0|Q0]; [replace (lam m) with (lam top) by lra; reflexivity|]. rewrite (inner_self_0 _ Q0). ring. }
  intros k Hk. rewrite (expansion (fun j => row n L j x) k Hk), (expansion x k Hk), <- Csum_scal. apply Csum_ext. intros m Hm. rewrite (coef_row x m Hm), (T m Hm). ring.
Qed.
Lemma other_eigenvalues mu x : (exists k, (k < n)%nat /\ x k <> RtoC 0) -> eigenvector n L mu x -> exists m, (m < n)%nat /\ mu = RtoC (lam m).
Proof.
  intros (k & Hk & Nz) E.
  destruct (all_or_one n (fun m => coef x m = RtoC 0)) as [A|(m & Hm & Cm)]; [intros m; apply Ceq_dec| |].
  - exfalso. apply Nz. rewrite (expansion x k Hk). apply Csum_0. intros m Hm. rewrite (A m Hm). ring.
  - exists m. split; [exact Hm|]. pose proof (coef_row x m Hm) as R. unfold coef at 1 in R. rewrite (Csum_ext n _ (fun k => mu * (Cconj (f k m) * x k))%C) in R by (intros i Hi; rewrite (E i Hi); ring).
    rewrite Csum_scal in R. fold (coef x m) in R. assert (Z : ((mu - RtoC (lam m)) * coef x m)%C = RtoC 0) by (replace ((mu - RtoC (lam m)) * coef x m)%C with (mu * coef x m - RtoC (lam m) * coef x m)%C by ring; rewrite R; ring).
    destruct (Ceq_dec (mu - RtoC (lam m))%C (RtoC 0)) as [D|D]; [|exfalso; exact (Cmult_neq_0 _ _ D Cm Z)].
    replace mu with ((mu - RtoC (lam m)) + RtoC (lam m))%C by ring. rewrite D. ring.
Qed.
End Parseval.

(* l is the largest eigenvalue of the Laplacian; all of them are real *)
Definition largest_eigenvalue n adj (l : R) : Prop :=
  (exists x, (exists k, (k < n)%nat /\ x k <> RtoC 0) /\ eigenvector n (lap n adj) (RtoC l) x) /\
  forall (mu : C) x, (exists k, (k < n)%nat /\ x k <> RtoC 0) -> eigenvector n (lap n adj) mu x -> snd mu = 0 /\ fst mu <= l.
Definition maximises n adj (th : nat -> R) : Prop := forall th', W1 n adj th' <= W1 n adj th.
Lemma unit_norms n th : Sum n (fun k => inner (phasors th k) (phasors th k)) = INR n.
Proof. rewrite (Sum_ext n _ (fun _ => 1)); [rewrite Sum_const; ring|]. intros k _. unfold phasors. rewrite inner_expi, Rminus_eq_0. apply cos_0. Qed.
Lemma column_sums n adj x : undirected adj -> Csum n (fun k => row n (lap n adj) k x) = RtoC 0.
Proof.
  intros S. unfold row. rewrite Csum_swap. apply Csum_0. intros j Hj.
  rewrite (Csum_ext n _ (fun k => x j * RtoC (lap n adj j k))%C) by (intros k _; rewrite (lap_sym n adj S k j); ring). rewrite Csum_scal.
  replace (Csum n (fun k => RtoC (lap n adj j k))) with (RtoC 0); [ring|]. unfold Csum, RtoC. cbn [fst snd]. f_equal.
  - symmetry. unfold lap. rewrite (Sum_ext n _ (fun k => delta k j * deg n adj j + - w adj j k)) by (intros; rewrite delta_sym; ring). rewrite Sum_plus, (Sum_delta n j (fun _ => deg n adj j)) by exact Hj.
    rewrite (Sum_ext n (fun i => - w adj j i) (fun i => -1 * w adj j i)) by (intros; ring). rewrite Sum_scal. unfold deg. ring.
  - symmetry. apply Sum_zero. intros; reflexivity.
Qed.
Lemma argmax (h : nat -> R) n : (1 <= n)%nat -> exists k, (k < n)%nat /\ forall m, (m < n)%nat -> h m <= h k.
Proof.
  intros Hn. induction n as [|n IH]; [lia|]. destruct n as [|n]; [exists 0%nat; split; [lia|]; intros m Hm; replace m with 0%nat by lia; lra|].
  destruct (IH ltac:(lia)) as (k & Hk & K). destruct (Rle_or_lt (h (Datatypes.S n)) (h k)) as [L|L].
  - exists k. split; [lia|]. intros m Hm. destruct (Nat.eq_dec m (Datatypes.S n)) as [->|N]; [exact L|apply K; lia].
  - exists (Datatypes.S n). split; [lia|]. intros m Hm. destruct (Nat.eq_dec m (Datatypes.S n)) as [->|N]; [lra|]. specialize (K m ltac:(lia)). lra.
Qed.
Theorem maximisers_balanced n adj s : (2 <= n)%nat -> undirected adj -> circulant n adj s -> strongly_connected n adj ->
  exists l, largest_eigenvalue n adj l /\ 0 < l /\ (exists th, maximises n adj th) /\
  forall th, maximises n adj th -> eigenvector n (lap n adj) (RtoC l) (phasors th) /\ balanced n th.
Proof.
  intros H2 S HC CN. assert (Hn : (1 <= n)%nat) by lia. pose proof (INR_pos n Hn) as P. destruct (argmax (lam n s) n Hn) as (top & Htop & Ltop). exists (lam n s top).
  pose proof (real_eigenvalue n adj s Hn S HC) as Re.
  assert (W : forall th, W1 n adj th <= lam n s top / 2).
  { intros th. unfold W1. eapply Rle_trans; [apply (Q_top n adj s Hn S HC top Ltop)|]. rewrite unit_norms. right. field. lra. }
  assert (At : W1 n adj (wave n top) = lam n s top / 2).
  { unfold W1, Q. pose proof (circulant_eigenvector n adj s top Hn HC) as E. rewrite (Re top Htop) in E.
    rewrite (Sum_ext n _ (fun k => lam n s top * inner (phasors (wave n top) k) (phasors (wave n top) k))).
    - rewrite Sum_scal, unit_norms. field. lra.
    - intros k Hk. change (Csum n (fun j => RtoC (lap n adj k j) * phasors (wave n top) j)%C) with (row n (lap n adj) k (phasors (wave n top))).
      change (phasors (wave n top)) with (fun k => expi (wave n top k)). rewrite (E k Hk). apply inner_scal. }
  assert (Lp : 0 < lam n s top).
  { pose (th := fun k : nat => if Nat.eqb k 0 then PI else 0). assert (N : W1 n adj th <> 0).
    { intros Z. apply (W1_strongly n adj th Hn CN) in Z. specialize (Z 0%nat 1%nat ltac:(lia) ltac:(lia)). unfold th, expi in Z. cbn [Nat.eqb] in Z. rewrite cos_PI, cos_0 in Z. injection Z as Z _. lra. }
    pose proof (W1_ge0 n adj th Hn). pose proof (W th). lra. }
  split.
  { split.
    - exists (fun k => expi (wave n top k)). split; [exists 0%nat; split; [lia|apply expi_neq0]|]. pose proof (circulant_eigenvector n adj s top Hn HC) as E. now rewrite (Re top Htop) in E.
    - intros mu x Nz E. destruct (other_eigenvalues n adj s Hn S HC mu x Nz E) as (m & Hm & ->). cbn. split; [reflexivity|now apply Ltop]. }
  split; [exact Lp|]. split; [exists (wave n top); intros th'; rewrite At; apply W|].
  intros th M. assert (Top : W1 n adj th = lam n s top / 2) by (apply Rle_antisym; [apply W|rewrite <- At; apply M]).
  assert (E : eigenvector n (lap n adj) (RtoC (lam n s top)) (phasors th)).
  { apply (eigen_top n adj s Hn S HC top Ltop). unfold W1 in Top. rewrite Top, unit_norms. field. lra. }
  split; [exact E|]. pose proof (column_sums n adj (phasors th) S) as Z. rewrite (Csum_ext n _ (fun k => RtoC (lam n s top) * phasors th k)%C) in Z by (intros k Hk; now apply E).
  rewrite Csum_scal in Z. unfold balanced, order. destruct (Ceq_dec (Csum n (phasors th)) (RtoC 0)) as [->|N]; [ring|]. exfalso. apply (Cmult_neq_0 (RtoC (lam n s top)) (Csum n (phasors th))); [|exact N|exact Z].
  intros Q. injection Q as Q. lra.
Qed.
(* complete graphs: the maximisers are the balanced arrangements *)
Theorem complete_maximisers n th : (2 <= n)%nat -> (maximises n complete th <-> balanced n th).
Proof.
  intros Hn. pose proof (INR_pos n ltac:(lia)) as P.
  assert (F : forall a, W1 n complete a = INR n / 2 * (1 - Cmod (order n a) ^ 2)) by (intros a; rewrite eq13 by lia; unfold U1; lra).
  assert (Z : forall a, Cmod (order n a) ^ 2 = 0 <-> balanced n a).
  { intros a. unfold balanced. split; intros H; [|rewrite H, Cmod_0; ring]. apply Cmod_eq_0. pose proof (Cmod_ge_0 (order n a)). nra. }
  split.
  - intros M. apply Z. specialize (M (wave n 1)). rewrite !F, (proj2 (Z (wave n 1)) (splay_balanced n Hn)) in M. pose proof (pow2_ge_0 (Cmod (order n th))). nra.
  - intros B th'. rewrite !F, (proj2 (Z th) B). pose proof (pow2_ge_0 (Cmod (order n th'))). nra.
Qed.
