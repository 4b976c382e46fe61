(* The signs of the squares of a quadratic form, by integers: A = M D M^T with an invertible M is x^T A x = sum d_k y_k^2
   in the coordinates y = M^T x; that the signs of the d_k do not depend on M (Sylvester's law of inertia) is in
   certificate_index.v. *)
From Coq Require Import ZArith QArith Qabs List Lia Lqa Bool.
From Flockproof Require Import certificate_matrices.
From Flockproof Require Import certificate_limits.
Import ListNotations.
Open Scope Q_scope.

Definition quad n (A : qmat) (x : nat -> Q) : Q := sumQ n (fun i => x i * app n A x i).
Definition transpose (A : qmat) : qmat := fun i j => A j i.
Definition count n (f : nat -> bool) : nat := length (filter f (seq 0 n)).
Definition is_positive (q : Q) : bool := Z.ltb 0 (Qnum q).
Definition is_negative (q : Q) : bool := Z.ltb (Qnum q) 0.

(* Coordinates y = M^T x, x = K^T y, in which the form of A is sum d_k y_k^2 with p positive and q negative d_k. *)
Definition has_inertia n (A : qmat) (p q : nat) : Prop := exists (M K : qmat) (d : nat -> Q),
  (forall x, quad n A x == sumQ n (fun k => d k * (app n (transpose M) x k * app n (transpose M) x k))) /\
  (forall y k, (k < n)%nat -> app n (transpose M) (app n (transpose K) y) k == y k) /\
  (forall x k, (k < n)%nat -> app n (transpose K) (app n (transpose M) x) k == x k) /\
  count n (fun k => is_positive (d k)) = p /\ count n (fun k => is_negative (d k)) = q.

Definition inertia_check n (A M : zmat) (D : list Z * positive) (K : zmat) (p q : nat) : bool :=
  let MD := (table n (fun i k => ent (fst M) i k * nth k (fst D) 0)%Z, (snd M * snd D)%positive) in
  let MT := (table n (fun k j => ent (fst M) j k), snd M) in
  eqz n (mulz n MD MT) A && eqz n (mulz n M K) (idz n) && eqz n (mulz n K M) (idz n) &&
  Nat.eqb (count n (fun k => is_positive (vec D k))) p && Nat.eqb (count n (fun k => is_negative (vec D k))) q.

Lemma transpose_product n M K : eqm n (mulq n M K) idq ->
  forall x k, (k < n)%nat -> app n (transpose K) (app n (transpose M) x) k == x k.
Proof.
  intros H x k Hk. rewrite <- app_mul, <- (app_id n x k Hk). apply sum_ext. intros l Hl.
  apply Qmult_comp; [|reflexivity]. unfold mulq, transpose.
  rewrite (sum_ext n _ (fun m => M l m * K m k)) by (intros; ring).
  eapply Qeq_trans; [exact (H l k Hl Hk)|]. unfold idq. now rewrite Nat.eqb_sym.
Qed.

Theorem inertia_certificate n A M D K p q : inertia_check n A M D K p q = true -> has_inertia n (val A) p q.
Proof.
  unfold inertia_check. cbv zeta. intros H. repeat (apply andb_prop in H as [H ?]).
  apply Nat.eqb_eq in H0, H1. apply eqz_true in H, H2, H3.
  exists (val M), (val K), (vec D).
  assert (MK : eqm n (mulq n (val M) (val K)) idq).
  { intros i j Hi Hj. rewrite <- (val_mul n M K i j Hi Hj), <- (val_id n i j Hi Hj). now apply H3. }
  assert (KM : eqm n (mulq n (val K) (val M)) idq).
  { intros i j Hi Hj. rewrite <- (val_mul n K M i j Hi Hj), <- (val_id n i j Hi Hj). now apply H2. }
  assert (F : forall i j, (i < n)%nat -> (j < n)%nat -> val A i j == sumQ n (fun k => val M i k * vec D k * val M j k)).
  { intros i j Hi Hj. rewrite <- (H i j Hi Hj), (val_mul n _ _ i j Hi Hj). unfold mulq. apply sum_ext. intros k Hk.
    unfold val at 1 2; cbn [fst snd]. rewrite !ent_table by assumption. unfold val, vec, Qeq, Qmult; cbn [Qnum Qden].
    rewrite !Pos2Z.inj_mul. ring. }
  split; [|split; [now apply transpose_product|split; [now apply transpose_product|split; assumption]]].
  intros x. unfold quad, app, transpose.
  rewrite (sum_ext n _ (fun i => sumQ n (fun k => vec D k * (val M i k * x i) * sumQ n (fun l => val M l k * x l)))).
  - rewrite sum_swap. apply sum_ext. intros k Hk.
    rewrite (sum_ext n _ (fun i => (vec D k * sumQ n (fun l => val M l k * x l)) * (val M i k * x i))) by (intros; ring).
    rewrite sum_scale. ring.
  - intros i Hi.
    rewrite (sum_ext n (fun l => val A i l * x l) (fun l => sumQ n (fun k => val M i k * vec D k * (val M l k * x l)))).
    + rewrite sum_swap, <- sum_scale. apply sum_ext. intros k Hk. rewrite sum_scale. ring.
    + intros l Hl. rewrite (F i l Hi Hl), Qmult_comm, <- sum_scale. apply sum_ext. intros k Hk. ring.
Qed.

(* ---- what the numbers say ---- *)
Lemma sum_nonneg n f : (forall k, (k < n)%nat -> 0 <= f k) -> 0 <= sumQ n f.
Proof. intros H. rewrite <- (sum_zero n). now apply sum_le. Qed.
Lemma square_nonneg a : 0 <= a * a.
Proof. unfold Qle, Qmult; cbn. rewrite Z.mul_1_r. apply Z.square_nonneg. Qed.
Lemma count_zero n f : count n f = 0%nat -> forall k, (k < n)%nat -> f k = false.
Proof.
  unfold count. intros H k Hk. apply length_zero_iff_nil in H. destruct (f k) eqn:E; [|reflexivity].
  assert (I : In k (filter f (seq 0 n))) by (apply filter_In; split; [apply in_seq; lia|exact E]). now rewrite H in I.
Qed.
Lemma count_some n f : (0 < count n f)%nat -> exists k, (k < n)%nat /\ f k = true.
Proof.
  unfold count. intros H. destruct (filter f (seq 0 n)) as [|k l] eqn:E; [cbn in H; lia|].
  assert (I : In k (filter f (seq 0 n))) by (rewrite E; now left). apply filter_In in I as [I F]. apply in_seq in I.
  exists k. split; [lia|exact F].
Qed.
Lemma not_negative q : is_negative q = false -> 0 <= q.
Proof. unfold is_negative, Qle; cbn. intros H. apply Z.ltb_ge in H. lia. Qed.

(* No negative square: positive semidefinite. *)
Theorem semidefinite n A p : has_inertia n A p 0 -> forall x, 0 <= quad n A x.
Proof.
  intros (M & K & d & F & _ & _ & _ & N) x. rewrite F. apply sum_nonneg. intros k Hk.
  apply Qmult_le_0_compat; [|apply square_nonneg]. apply not_negative. exact (count_zero _ _ N k Hk).
Qed.
(* The form at the point where y_k = 1 and the other coordinates vanish. *)
Lemma at_axis n A M K (d : nat -> Q) k : (k < n)%nat ->
  (forall x, quad n A x == sumQ n (fun k => d k * (app n (transpose M) x k * app n (transpose M) x k))) ->
  (forall y k, (k < n)%nat -> app n (transpose M) (app n (transpose K) y) k == y k) ->
  quad n A (app n (transpose K) (idq k)) == d k.
Proof.
  intros Hk F I. rewrite F. rewrite (sum_ext n _ (fun l => (if Nat.eqb k l then 1 else 0) * d l)).
  - now apply sum_delta.
  - intros l Hl. rewrite (I (idq k) l Hl). unfold idq. destruct (Nat.eqb k l); ring.
Qed.
(* Squares of both signs: indefinite. *)
Theorem indefinite n A p q : has_inertia n A (S p) (S q) -> (exists x, 0 < quad n A x) /\ (exists x, quad n A x < 0).
Proof.
  intros (M & K & d & F & I & _ & P & N). split.
  - destruct (count_some n (fun k => is_positive (d k))) as (k & Hk & E); [rewrite P; lia|].
    exists (app n (transpose K) (idq k)). rewrite (at_axis n A M K d k Hk F I).
    unfold is_positive in E. apply Z.ltb_lt in E. unfold Qlt; cbn. lia.
  - destruct (count_some n (fun k => is_negative (d k))) as (k & Hk & E); [rewrite N; lia|].
    exists (app n (transpose K) (idq k)). rewrite (at_axis n A M K d k Hk F I).
    unfold is_negative in E. apply Z.ltb_lt in E. unfold Qlt; cbn. lia.
Qed.
