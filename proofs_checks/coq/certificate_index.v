(* Sylvester's law of inertia for the forms of certificate_inertia.v: where x^T A x = sum d_k y_k^2 in coordinates y, the
   number of negative d_k is the largest dimension of a space on which the form is negative, so it depends on A only;
   the same for positive. The axes of the negative d_k span such a space; in a larger one some vector has y_k = 0 for all
   of them (fewer equations than unknowns), where the form is not negative. *)
From Coq Require Import ZArith QArith List Lia Lqa Bool.
From Flockproof Require Import certificate_matrices.
From Flockproof Require Import certificate_limits.
From Flockproof Require Import certificate_inertia.
Import ListNotations.
Open Scope Q_scope.

(* ---- spaces given by m vectors W 0, .., W (m-1) ---- *)
Definition combination m (c : nat -> Q) (W : nat -> nat -> Q) : nat -> Q := fun i => sumQ m (fun k => c k * W k i).
Definition nontrivial m (c : nat -> Q) : Prop := exists k, (k < m)%nat /\ ~ c k == 0.
(* Negative at all nontrivial combinations; the vectors are then linearly independent. *)
Definition negative_on n A m W : Prop := forall c, nontrivial m c -> quad n A (combination m c W) < 0.
Definition positive_on n A m W : Prop := forall c, nontrivial m c -> 0 < quad n A (combination m c W).
(* The largest dimension of such a space. *)
Definition negative_index n A q : Prop :=
  (exists W, negative_on n A q W) /\ forall m W, negative_on n A m W -> (m <= q)%nat.
Definition positive_index n A p : Prop :=
  (exists W, positive_on n A p W) /\ forall m W, positive_on n A m W -> (m <= p)%nat.

(* ---- fewer equations than unknowns ---- *)
Definition skip (a k : nat) : nat := if Nat.ltb k a then k else S k.
Definition unskip (a k : nat) : nat := if Nat.ltb k a then k else pred k.
Lemma unskip_skip a k : unskip a (skip a k) = k.
Proof.
  unfold unskip, skip.
  destruct (Nat.ltb_spec k a); [destruct (Nat.ltb_spec k a)|destruct (Nat.ltb_spec (S k) a)]; cbn; lia.
Qed.
Lemma skip_other a k : skip a k <> a.
Proof. unfold skip. destruct (Nat.ltb_spec k a); lia. Qed.
Lemma sum_skip a : forall m f, (a <= m)%nat -> sumQ (S m) f == f a + sumQ m (fun k => f (skip a k)).
Proof.
  induction m as [|m IH]; intros f H.
  - replace a with 0%nat by lia. cbn. ring.
  - destruct (Nat.eq_dec a (S m)) as [->|N].
    + change (sumQ (S (S m)) f) with (sumQ (S m) f + f (S m)).
      rewrite (sum_ext (S m) (fun k => f (skip (S m) k)) f); [ring|]. intros k Hk. unfold skip.
      destruct (Nat.ltb_spec k (S m)); [reflexivity|lia].
    + change (sumQ (S (S m)) f) with (sumQ (S m) f + f (S m)). rewrite IH by lia.
      change (sumQ (S m) (fun k => f (skip a k))) with (sumQ m (fun k => f (skip a k)) + f (skip a m)).
      replace (skip a m) with (S m) by (unfold skip; destruct (Nat.ltb_spec m a); lia). ring.
Qed.
Lemma some_or_none m (f : nat -> Q) : (forall k, (k < m)%nat -> f k == 0) \/ exists k, (k < m)%nat /\ ~ f k == 0.
Proof.
  induction m as [|m [IH|(k & Hk & F)]].
  - left. intros k Hk. lia.
  - destruct (Qeq_dec (f m) 0) as [Z|N]; [left|right; exists m; split; [lia|exact N]].
    intros k Hk. destruct (Nat.eq_dec k m) as [->|]; [exact Z|apply IH; lia].
  - right. exists k. split; [lia|exact F].
Qed.
Lemma solution : forall q m (B : nat -> nat -> Q), (q < m)%nat ->
  exists c, nontrivial m c /\ forall r, (r < q)%nat -> sumQ m (fun k => c k * B r k) == 0.
Proof.
  induction q as [|q IH]; intros m B H.
  - exists (fun _ => 1). split; [|intros r Hr; lia]. exists 0%nat. split; [lia|]. intros E. discriminate E.
  - destruct (some_or_none m (B q)) as [Z|(a & Ha & P)].
    + destruct (IH m B ltac:(lia)) as (c & N & Sol). exists c. split; [exact N|]. intros r Hr.
      destruct (Nat.eq_dec r q) as [->|]; [|apply Sol; lia]. rewrite <- (sum_zero m). apply sum_ext. intros k Hk.
      rewrite (Z k Hk). ring.
    + destruct m as [|m]; [lia|].
      destruct (IH m (fun r k => B r (skip a k) - B r a / B q a * B q (skip a k)) ltac:(lia)) as (c & (k0 & Hk0 & N) & Sol).
      set (s := sumQ m (fun k => c k * B q (skip a k))).
      exists (fun k => if Nat.eqb k a then - (s / B q a) else c (unskip a k)). split.
      * exists (skip a k0). split; [unfold skip; destruct (Nat.ltb_spec k0 a); lia|].
        destruct (Nat.eqb_spec (skip a k0) a) as [E|_]; [destruct (skip_other a k0 E)|]. now rewrite unskip_skip.
      * intros r Hr. rewrite (sum_skip a) by lia. rewrite Nat.eqb_refl.
        rewrite (sum_ext m _ (fun k => c k * B r (skip a k))).
        2:{ intros k Hk. destruct (Nat.eqb_spec (skip a k) a) as [E|_]; [destruct (skip_other a k E)|].
            rewrite unskip_skip. reflexivity. }
        destruct (Nat.eq_dec r q) as [->|].
        -- fold s. field. exact P.
        -- specialize (Sol r ltac:(lia)). cbn beta in Sol.
           rewrite (sum_ext m _ (fun k => c k * B r (skip a k) - B r a / B q a * (c k * B q (skip a k)))) in Sol
             by (intros; field; exact P).
           rewrite sum_minus, sum_scale in Sol. fold s in Sol.
           setoid_replace (- (s / B q a) * B r a) with (- (B r a / B q a * s)) by (field; exact P).
           rewrite <- Sol. ring.
Qed.

(* ---- the indices of the negative d_k ---- *)
Definition chosen n (f : nat -> bool) : list nat := filter f (seq 0 n).
Lemma chosen_in n f l : In l (chosen n f) <-> (l < n)%nat /\ f l = true.
Proof. unfold chosen. rewrite filter_In, in_seq. intuition lia. Qed.
Lemma chosen_nth n f k : (k < count n f)%nat -> (nth k (chosen n f) 0%nat < n)%nat /\ f (nth k (chosen n f) 0%nat) = true.
Proof. intros H. apply chosen_in, nth_In. exact H. Qed.
Lemma negative_true d : is_negative d = true -> d < 0.
Proof. unfold is_negative, Qlt; cbn. intros H. apply Z.ltb_lt in H. lia. Qed.

Lemma app_combination n A m c W i : app n A (combination m c W) i == sumQ m (fun k => c k * app n A (W k) i).
Proof.
  unfold app, combination.
  rewrite (sum_ext n _ (fun l => sumQ m (fun k => A i l * (c k * W k l)))) by (intros; now rewrite <- sum_scale).
  rewrite sum_swap. apply sum_ext. intros k Hk. rewrite <- sum_scale. apply sum_ext. intros l Hl. ring.
Qed.

Lemma sum_nonpos n f : (forall k, (k < n)%nat -> f k <= 0) -> sumQ n f <= 0.
Proof. intros H. rewrite <- (sum_zero n). now apply sum_le. Qed.
Lemma sum_negative n f a : (forall k, (k < n)%nat -> f k <= 0) -> (a < n)%nat -> f a < 0 -> sumQ n f < 0.
Proof.
  intros H Ha F. destruct n as [|n]; [lia|]. rewrite (sum_skip a) by lia.
  assert (sumQ n (fun k => f (skip a k)) <= 0); [|lra].
  apply sum_nonpos. intros k Hk. apply H. unfold skip. destruct (Nat.ltb_spec k a); lia.
Qed.
Lemma square_positive a : ~ a == 0 -> 0 < a * a.
Proof.
  intros N. pose proof (square_nonneg a). destruct (Qlt_le_dec 0 (a * a)) as [|L]; [assumption|].
  exfalso. assert (E : a * a == 0) by lra. destruct (Qmult_integral _ _ E); contradiction.
Qed.

Theorem sylvester_negative n A p q : has_inertia n A p q -> negative_index n A q.
Proof.
  intros (M & K & d & F & I & _ & _ & N). set (neg := fun k => is_negative (d k)) in *.
  pose (at_ := fun k => nth k (chosen n neg) 0%nat). split.
  - exists (fun k => app n (transpose K) (idq (at_ k))). intros c (k0 & Hk0 & C). rewrite F.
    assert (Y : forall l, (l < n)%nat ->
      app n (transpose M) (combination q c (fun k => app n (transpose K) (idq (at_ k)))) l == sumQ q (fun k => c k * idq (at_ k) l)).
    { intros l Hl. rewrite app_combination. apply sum_ext. intros k Hk. now rewrite (I _ l Hl). }
    assert (T : forall l, (l < n)%nat -> neg l = false -> sumQ q (fun k => c k * idq (at_ k) l) == 0).
    { intros l Hl E. rewrite <- (sum_zero q). apply sum_ext. intros k Hk. unfold idq.
      destruct (Nat.eqb_spec (at_ k) l) as [<-|_]; [|ring]. destruct (chosen_nth n neg k) as [_ G]; [lia|].
      unfold at_ in E. congruence. }
    destruct (chosen_nth n neg k0) as [B0 G0]; [lia|]. fold (at_ k0) in B0, G0.
    apply (sum_negative n _ (at_ k0)); [|exact B0|].
    + intros l Hl. rewrite (Y l Hl). destruct (neg l) eqn:E.
      * apply negative_true in E. pose proof (square_nonneg (sumQ q (fun k => c k * idq (at_ k) l))). nra.
      * rewrite (T l Hl E). lra.
    + rewrite (Y _ B0). apply negative_true in G0.
      assert (S0 : sumQ q (fun k => c k * idq (at_ k) (at_ k0)) == c k0).
      { rewrite <- (sum_delta q c k0 Hk0) at 1. apply sum_ext. intros k Hk. unfold idq.
        destruct (Nat.eqb_spec k0 k) as [->|D]; [rewrite Nat.eqb_refl; ring|].
        destruct (Nat.eqb_spec (at_ k) (at_ k0)) as [E|_]; [|ring]. exfalso. apply D. symmetry.
        apply (proj1 (NoDup_nth (chosen n neg) 0%nat) (NoDup_filter _ (seq_NoDup n 0))); [| |exact E];
          unfold count in N; fold (chosen n neg) in N; lia. }
      rewrite S0. pose proof (square_positive _ C). nra.
  - intros m W H. destruct (Nat.le_gt_cases m q) as [|L]; [assumption|]. exfalso.
    destruct (solution q m (fun r k => app n (transpose M) (W k) (at_ r)) L) as (c & C & Z).
    specialize (H c C). rewrite F in H. apply (Qlt_not_le _ _ H). apply sum_nonneg. intros l Hl.
    destruct (neg l) eqn:E.
    + assert (J : In l (chosen n neg)) by (apply chosen_in; now split).
      destruct (In_nth _ _ 0%nat J) as (r & Hr & <-). fold (at_ r). rewrite app_combination.
      rewrite (Z r) by (unfold count in N; fold (chosen n neg) in N; lia). lra.
    + apply Qmult_le_0_compat; [now apply not_negative|apply square_nonneg].
Qed.

(* ---- positive squares: the form of - A ---- *)
Definition opposite (A : qmat) : qmat := fun i j => - A i j.
Lemma quad_opposite n A x : quad n (opposite A) x == - quad n A x.
Proof.
  unfold quad, app, opposite. setoid_replace (- sumQ n (fun i => x i * sumQ n (fun l => A i l * x l)))
    with ((-1) * sumQ n (fun i => x i * sumQ n (fun l => A i l * x l))) by ring.
  rewrite <- sum_scale. apply sum_ext. intros i Hi.
  rewrite (sum_ext n (fun l => - A i l * x l) (fun l => (-1) * (A i l * x l))) by (intros; ring).
  rewrite sum_scale. ring.
Qed.
Lemma count_ext n f g : (forall k, f k = g k) -> count n f = count n g.
Proof. intros H. unfold count. now rewrite (filter_ext f g H). Qed.
Lemma has_inertia_opposite n A p q : has_inertia n A p q -> has_inertia n (opposite A) q p.
Proof.
  intros (M & K & d & F & I & J & P & N). exists M, K, (fun k => - d k). repeat split; try assumption.
  - intros x. rewrite quad_opposite, F.
    setoid_replace (- sumQ n (fun k => d k * (app n (transpose M) x k * app n (transpose M) x k)))
      with ((-1) * sumQ n (fun k => d k * (app n (transpose M) x k * app n (transpose M) x k))) by ring.
    rewrite <- sum_scale. apply sum_ext. intros k Hk. ring.
  - rewrite <- N. apply count_ext. intros k. unfold is_positive, is_negative. cbn.
    destruct (Z.ltb_spec 0 (- Qnum (d k))), (Z.ltb_spec (Qnum (d k)) 0); try reflexivity; lia.
  - rewrite <- P. apply count_ext. intros k. unfold is_positive, is_negative. cbn.
    destruct (Z.ltb_spec (- Qnum (d k)) 0), (Z.ltb_spec 0 (Qnum (d k))); try reflexivity; lia.
Qed.
Lemma negative_on_opposite n A m W : negative_on n (opposite A) m W <-> positive_on n A m W.
Proof.
  split; intros H c C; specialize (H c C); rewrite quad_opposite in *; lra.
Qed.
Theorem sylvester_positive n A p q : has_inertia n A p q -> positive_index n A p.
Proof.
  intros H. destruct (sylvester_negative _ _ _ _ (has_inertia_opposite _ _ _ _ H)) as ((W & N) & L). split.
  - exists W. now apply negative_on_opposite.
  - intros m U G. apply (L m U). now apply negative_on_opposite.
Qed.

(* The law: two diagonalisations have the same numbers of signs. *)
Theorem law_of_inertia n A p q p' q' : has_inertia n A p q -> has_inertia n A p' q' -> p = p' /\ q = q'.
Proof.
  intros H G.
  destruct (sylvester_negative _ _ _ _ H) as ((W & N) & L), (sylvester_negative _ _ _ _ G) as ((W' & N') & L').
  destruct (sylvester_positive _ _ _ _ H) as ((U & P) & B), (sylvester_positive _ _ _ _ G) as ((U' & P') & B').
  specialize (L _ _ N'). specialize (L' _ _ N). specialize (B _ _ P'). specialize (B' _ _ P). lia.
Qed.

(* What a certificate proves. *)
Theorem index_certificate n A M D K p q : inertia_check n A M D K p q = true ->
  positive_index n (val A) p /\ negative_index n (val A) q.
Proof.
  intros H. apply inertia_certificate in H. split; [exact (sylvester_positive _ _ _ _ H)|exact (sylvester_negative _ _ _ _ H)].
Qed.
