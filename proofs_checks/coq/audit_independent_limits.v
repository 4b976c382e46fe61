(* Clauses about limits and stability of phases, formalised from their words with own definitions: paley.thm1.conv, paley.thm1.bal, paley.thm1.sync clause 2,
   paley.unbal clauses 2, 3, paley.balexist; and tanner2.noninter. Equilibria are taken modulo rotation. *)
From Coq Require Import Reals Lra Lia Classical.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums paley_model paley_phase tanner_energy tanner_flock.
From Flockproof Require inclusions paley_limits paley_fourier paley_directed tanner2_filippov tanner2_motion tanner2_collision audit_independent_tanner2.
Module T2 := audit_independent_tanner2.
Open Scope R_scope.

(* the model (6) with (9), written with sines *)
Definition motion6 n (w0 K1 : R) (th : nat -> R -> R) := forall t k, 0 <= t -> (k < n)%nat ->
  is_derive (th k) t (w0 - K1 / INR n * Sum n (fun j => sin (th j t - th k t))).
Definition motion6_until T n (w0 K1 : R) (th : nat -> R -> R) := forall t k, 0 <= t < T -> (k < n)%nat ->
  is_derive (th k) t (w0 - K1 / INR n * Sum n (fun j => sin (th j t - th k t))).
(* all gradients of U_1 vanish; all rates are equal, which is the same *)
Definition critical n (a : nat -> R) := forall k, (k < n)%nat -> Sum n (fun j => sin (a j - a k)) = 0.
Definition sum_zero n (a : nat -> R) := Sum n (fun k => cos (a k)) = 0 /\ Sum n (fun k => sin (a k)) = 0.
Definition in_phase n (a : nat -> R) := forall j k, (j < n)%nat -> (k < n)%nat -> cos (a j) = cos (a k) /\ sin (a j) = sin (a k).
Definition close_to n (th : nat -> R -> R) t (A : (nat -> R) -> Prop) e := exists a, A a /\ forall k, (k < n)%nat -> Rabs (th k t - a k) < e.
Definition thm1_conv : Prop := forall n w0 K1, (1 <= n)%nat -> K1 <> 0 ->
  (forall a : nat -> R, exists th, motion6 n w0 K1 th /\ forall k, (k < n)%nat -> th k 0 = a k) /\
  (forall T th, 0 < T -> motion6_until T n w0 K1 th -> exists th', motion6 n w0 K1 th' /\ forall t k, t < T -> (k < n)%nat -> th' k t = th k t) /\
  forall th, motion6 n w0 K1 th -> forall e, 0 < e -> exists T, forall t, T <= t -> close_to n th t (critical n) e.
Definition thm1_bal_1 : Prop := forall n w0 K1, (1 <= n)%nat -> 0 < K1 ->
  (forall e, 0 < e -> exists d, 0 < d /\ forall th, motion6 n w0 K1 th -> close_to n th 0 (sum_zero n) d -> forall t, 0 <= t -> close_to n th t (sum_zero n) e) /\
  exists d, 0 < d /\ forall th, motion6 n w0 K1 th -> close_to n th 0 (sum_zero n) d -> forall e, 0 < e -> exists T, forall t, T <= t -> close_to n th t (sum_zero n) e.
(* not stable: some neighbourhood of the rotations of a is left from starts as near to a as one likes *)
Definition leaves n w0 K1 (a : nat -> R) := exists e, 0 < e /\ forall d, 0 < d -> exists th t, motion6 n w0 K1 th /\ (forall k, (k < n)%nat -> Rabs (th k 0 - a k) < d) /\ 0 <= t /\
  forall c, exists k, (k < n)%nat /\ e <= Rabs (th k t - (a k + c)).
Definition thm1_bal_2 : Prop := forall n w0 K1 a, (2 <= n)%nat -> 0 < K1 -> critical n a -> ~ sum_zero n a -> leaves n w0 K1 a.
Definition thm1_sync_2 : Prop := forall n w0 K1 a, (2 <= n)%nat -> K1 < 0 -> critical n a -> ~ in_phase n a -> leaves n w0 K1 a.
(* M phases at th0, the others at th0 + pi, 1 <= M < N, M <> N/2 *)
Definition unbal_23 : Prop := forall n M w0 K1 th0 (a : nat -> R), (1 <= M < n)%nat -> (2 * M <> n)%nat -> K1 <> 0 -> (forall k, (k < n)%nat -> a k = if Nat.ltb k M then th0 else th0 + PI) ->
  critical n a /\ leaves n w0 K1 a /\ forall k, (k < n)%nat -> (cos (a k), sin (a k)) = if Nat.ltb k M then (cos th0, sin th0) else (- cos th0, - sin th0).
Definition noninter : Prop := forall n adj V V' i j, T2.simple_graph adj -> T2.potentials n adj V V' -> (i < n)%nat -> (j < n)%nat -> i <> j -> adj i j = false ->
  exists r v, T2.motion n adj V' r v /\ r i 0 <> r j 0 /\ exists T, 0 <= T /\ r i T = r j T.

(* ---- the theorems prove them ---- *)
Lemma rate_is n w0 K1 a k : w0 + - K1 * g1 n a k = w0 - K1 / INR n * Sum n (fun j => sin (a j - a k)).
Proof. rewrite g1_sines. unfold Rdiv. ring. Qed.
Lemma motion_is n w0 K1 th : motion6 n w0 K1 th <-> paley_limits.phases n w0 K1 th.
Proof. split; intros H t k Ht Hk; specialize (H t k Ht Hk); [rewrite rate_is|rewrite <- (rate_is n w0 K1 (fun j => th j t))]; exact H. Qed.
Lemma critical_is n a : (1 <= n)%nat -> (critical n a <-> stationary n (U1 n) a).
Proof.
  intros Hn. pose proof (INR_pos n Hn) as P. rewrite <- paley_limits.critical_iff by exact Hn. split; intros H.
  - apply Sum_zero. intros k Hk. rewrite g1_sines, (H k Hk). ring.
  - intros k Hk. pose proof (Sum_eq0 n (fun k => g1 n a k ^ 2) (fun j _ => pow2_ge_0 _) H k Hk) as Z. cbv beta in Z. assert (G : g1 n a k = 0) by nra. rewrite g1_sines in G.
    apply Rmult_integral in G. destruct G as [G|G]; [|exact G]. exfalso. apply Rinv_neq_0_compat in G; [exact G|lra].
Qed.
Lemma sum_zero_is n a : (1 <= n)%nat -> (sum_zero n a <-> balanced n a).
Proof.
  intros Hn. pose proof (INR_pos n Hn) as P. split.
  - intros [A B]. unfold balanced, order. replace (Csum n (phasors a)) with (RtoC 0); [ring|]. symmetry. apply injective_projections; cbn; assumption.
  - intros B. apply (paley_limits.balanced_sum n Hn) in B. injection B as B1 B2. now split.
Qed.
Lemma in_phase_is n a : in_phase n a <-> synchronized n a.
Proof. split; intros H j k Hj Hk; specialize (H j k Hj Hk); [destruct H as [A B]; unfold expi; now rewrite A, B|injection H as A B; now split]. Qed.
Lemma thm1_conv_proved : thm1_conv.
Proof.
  intros n w0 K1 Hn HK. destruct (paley_limits.converges n Hn w0 K1 HK) as [[L1 L2] C]. split; [|split].
  - intros a. destruct (L1 a) as (th & E & M). exists th. split; [now apply motion_is|exact E].
  - intros T th HT M. destruct (L2 T th HT) as (th' & E & M').
    + intros t k Ht Hk. rewrite (rate_is n w0 K1 (fun j => th j t)). now apply M.
    + exists th'. split; [now apply motion_is|exact E].
  - intros th M e He. destruct (C th (proj1 (motion_is n w0 K1 th) M) e He) as (T & _ & Q). exists T. intros t Ht. destruct (Q t Ht) as (a & A1 & A2). exists a. split; [now apply critical_is|exact A2].
Qed.
Lemma thm1_bal_1_proved : thm1_bal_1.
Proof.
  intros n w0 K1 Hn HK. destruct (paley_limits.balanced_stable n Hn w0 K1 HK) as [S (d & Hd & A)]. split.
  - intros e He. destruct (S e He) as (d' & Hd' & Q). exists d'. split; [exact Hd'|]. intros th M (a & A1 & A2) t Ht.
    destruct (Q th a (proj1 (motion_is n w0 K1 th) M) (proj1 (sum_zero_is n a Hn) A1) A2 t Ht) as (b & B1 & B2). exists b. split; [now apply sum_zero_is|exact B2].
  - exists d. split; [exact Hd|]. intros th M (a & A1 & A2) e He. destruct (A th a (proj1 (motion_is n w0 K1 th) M) (proj1 (sum_zero_is n a Hn) A1) A2 e He) as (T & _ & Q).
    exists T. intros t Ht. destruct (Q t Ht) as (b & B1 & B2). exists b. split; [now apply sum_zero_is|exact B2].
Qed.
Lemma leaves_is n w0 K1 a : ~ paley_limits.stable n w0 K1 a -> leaves n w0 K1 a.
Proof.
  intros H. apply not_all_ex_not in H. destruct H as [e H]. apply imply_to_and in H. destruct H as [He H]. exists e. split; [exact He|]. intros d Hd.
  apply NNPP. intros N. apply H. exists d. split; [exact Hd|]. intros th M W t Ht. apply NNPP. intros Q. apply N. exists th, t. split; [now apply motion_is|]. split; [exact W|]. split; [exact Ht|].
  intros c. apply NNPP. intros X. apply Q. exists c. intros k Hk. apply Rnot_le_lt. intros L. apply X. now exists k.
Qed.
Lemma thm1_bal_2_proved : thm1_bal_2.
Proof.
  intros n w0 K1 a N2 HK C NB. assert (Hn : (1 <= n)%nat) by lia. apply leaves_is. apply (proj1 (paley_limits.rest_unstable n Hn w0 K1 a N2 (proj1 (critical_is n a Hn) C)) HK). now rewrite <- sum_zero_is.
Qed.
Lemma thm1_sync_2_proved : thm1_sync_2.
Proof.
  intros n w0 K1 a N2 HK C NB. assert (Hn : (1 <= n)%nat) by lia. apply leaves_is. apply (proj2 (paley_limits.rest_unstable n Hn w0 K1 a N2 (proj1 (critical_is n a Hn) C)) HK). now rewrite <- in_phase_is.
Qed.
Lemma count_first M : forall n, (M <= n)%nat -> Sum n (fun k => if Nat.ltb k M then 1 else 0) = INR M /\ Sum n (fun k => if Nat.ltb k M then 0 else 1) = INR n - INR M.
Proof.
  assert (A : forall m, (m <= M)%nat -> Sum m (fun k => if Nat.ltb k M then 1 else 0) = INR m /\ Sum m (fun k => if Nat.ltb k M then 0 else 1) = 0).
  { induction m as [|m IH]; intros H; [now split|]. destruct (IH ltac:(lia)) as [I1 I2]. cbn [Sum]. rewrite I1, I2. destruct (Nat.ltb_spec m M); [|lia]. rewrite S_INR. split; ring. }
  intros n H. replace n with (M + (n - M))%nat by lia. induction (n - M)%nat as [|d IH]; [rewrite Nat.add_0_r; destruct (A M (le_n M)) as [-> ->]; split; ring|].
  rewrite Nat.add_succ_r. cbn [Sum]. destruct IH as [-> ->]. destruct (Nat.ltb_spec (M + d) M); [lia|]. rewrite S_INR. split; ring.
Qed.
Lemma unbal_23_proved : unbal_23.
Proof.
  intros n M w0 K1 th0 a HM Ne HK A. assert (Hn : (1 <= n)%nat) by lia. destruct (count_first M n ltac:(lia)) as [C1 C2].
  destruct (paley_limits.clusters_unstable n Hn w0 K1 th0 (fun k => Nat.ltb k M) a HK A) as ((S1 & S2) & Op & E).
  - exists 0%nat. split; [lia|]. apply Nat.ltb_lt. lia.
  - exists M. split; [lia|]. apply Nat.ltb_irrefl.
  - rewrite C1, C2. intros Q. apply Ne. apply INR_eq. rewrite mult_INR. cbn [INR]. lra.
  - split; [now apply critical_is|]. split; [now apply leaves_is|]. intros k Hk. specialize (E k Hk). unfold expi in E at 1. rewrite E. destruct (Nat.ltb k M); [reflexivity|]. rewrite Op. reflexivity.
Qed.
Lemma noninter_proved : noninter.
Proof.
  intros n adj V V' i j [S NL] P Hi Hj Ne U. destruct (T2.one_of n adj V V' S P) as (_ & _ & Q).
  destruct (tanner2_collision.unlinked_collide n adj (tanner2_filippov.both V) (tanner2_filippov.both V') i j S NL (tanner2_filippov.both_sym V) (tanner2_filippov.both_sym V')) as (r & v & A & M & N & T & HT & E); try assumption.
  - intros a b Ha Hb L. destruct (Q a b Ha Hb L) as (Q1 & Q2 & Q3). split; [intros s Hs; split; now apply Q1|]. now split.
  - intros a b s Ha Hb L Hs. now apply (Q a b Ha Hb L).
  - exists r, v. split; [|split; [exact N|exists T; split; [lra|exact E]]]. split; [exact A|]. intros t k Ht Hk. destruct (M t Ht) as [M1 M2]. split; [now apply M1|]. intros Ap.
    specialize (M2 Ap k Hk). rewrite <- T2.law4_is in M2.
    now destruct (T2.both_law n adj V V' (fun k => r k t) (fun k => v k t) k S (proj1 P) (T2.slopes_of n adj V V' P) Hk Ap) as (_ & _ & <-).
Qed.

(* ---- paley.balexist, directed graphs too: the neighbours of k are at the same offsets, modulo n, as those of node 0 ---- *)
Definition ring_like n (adj : graph) := forall k j k' j', (k < n)%nat -> (j < n)%nat -> (k' < n)%nat -> (j' < n)%nat ->
  (exists m, (j + k' + m * n = j' + k \/ j + k' = j' + k + m * n)%nat) -> adj k j = adj k' j'.
(* W_1 = 1/(2N) sum over arcs of 1 - cos; changed in one phase only, its derivative is 0 *)
Definition W_arcs n (adj : graph) th := / (2 * INR n) * Sum n (fun k => Sum n (fun j => if adj k j then 1 - cos (th j - th k) else 0)).
Definition level n (W : (nat -> R) -> R) th := forall k, (k < n)%nat -> is_derive (fun s => W (fun l => if Nat.eqb l k then s else th l)) (th k) 0.
Definition balexist : Prop := forall n adj, (2 <= n)%nat -> ring_like n adj ->
  exists th, Sum n (fun k => cos (th k)) = 0 /\ Sum n (fun k => sin (th k)) = 0 /\ level n (W_arcs n adj) th.
Lemma W_arcs_is n adj th : W_arcs n adj th = W1 n adj th.
Proof.
  unfold W_arcs, W1. rewrite Q_phasors. f_equal. unfold cos_pairs. apply Sum_ext. intros k Hk.
  rewrite (Sum_ext n (fun j => lap n adj k j * cos (th j - th k)) (fun j => deg n adj k * (delta k j * cos (th j - th k)) - w adj k j * cos (th j - th k))) by (intros; unfold lap; ring).
  rewrite Sum_minus, Sum_scal, (Sum_delta_l n k (fun j => cos (th j - th k))) by assumption. rewrite Rminus_eq_0, cos_0, Rmult_1_r. unfold deg. rewrite <- Sum_minus.
  apply Sum_ext. intros j _. unfold w. destruct (adj k j); ring.
Qed.
Theorem balexist_proved : balexist.
Proof.
  intros n adj Hn Ci. assert (H1 : (1 <= n)%nat) by lia. pose proof (INR_pos n H1) as P.
  assert (C : paley_fourier.circulant n adj (fun d => adj 0%nat d)).
  { intros k j Hk Hj. apply Ci; try assumption; try lia; [apply Nat.mod_upper_bound; lia|].
    pose proof (Nat.div_mod (j + n - k) n ltac:(lia)) as E. destruct (le_lt_dec k j) as [L|L].
    - replace ((j + n - k) mod n)%nat with (j - k)%nat; [exists 0%nat; left; lia|].
      replace (j + n - k)%nat with (j - k + 1 * n)%nat by lia. rewrite Nat.mod_add, Nat.mod_small by lia. reflexivity.
    - rewrite Nat.mod_small by lia. exists 1%nat. left. lia. }
  destruct (paley_directed.balanced_exists_directed n adj _ Hn C) as (th & B & St). exists th.
  assert (Z : Sum n (fun k => cos (th k)) = 0 /\ Sum n (fun k => sin (th k)) = 0).
  { unfold balanced in B. rewrite order_xy in B. injection B as B1 B2.
    pose proof (Rinv_0_lt_compat _ P) as I. split.
    - apply (Rmult_eq_reg_l (/ INR n)); [lra|lra].
    - apply (Rmult_eq_reg_l (/ INR n)); [lra|lra]. }
  destruct Z as [Z1 Z2]. split; [exact Z1|split; [exact Z2|]]. intros k Hk. specialize (St k Hk). unfold partial in St.
  apply (is_derive_ext (fun s => W1 n adj (upd th k s))); [|exact St]. intros s. unfold upd. now rewrite <- W_arcs_is.
Qed.
