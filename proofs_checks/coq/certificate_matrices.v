(* Integer matrices over one common denominator, and the statements about matrices over Q that a boolean on them decides.
   Computing is done on Z by lists; what is stated is about functions nat -> nat -> Q. The file proves once that the
   boolean implies the statement; each certificate is then one evaluation (gen_*.v). *)
From Coq Require Import ZArith QArith Qabs List Lia Lqa Bool.
Import ListNotations.
Open Scope Q_scope.

(* ---- sums over 0 .. n-1 ---- *)
Fixpoint sumQ (n : nat) (f : nat -> Q) : Q := match n with O => 0 | S m => sumQ m f + f m end.
Fixpoint sumZ (n : nat) (f : nat -> Z) : Z := match n with O => 0%Z | S m => (sumZ m f + f m)%Z end.

Lemma sum_ext n f g : (forall k, (k < n)%nat -> f k == g k) -> sumQ n f == sumQ n g.
Proof.
  induction n as [|n IH]; intros H; cbn; [reflexivity|]. rewrite IH, (H n) by (intros; try apply H; lia). reflexivity.
Qed.
Lemma sum_le n f g : (forall k, (k < n)%nat -> f k <= g k) -> sumQ n f <= sumQ n g.
Proof.
  induction n as [|n IH]; intros H; cbn; [lra|]. apply Qplus_le_compat; [apply IH; intros; apply H; lia|apply H; lia].
Qed.
Lemma sum_plus n f g : sumQ n (fun k => f k + g k) == sumQ n f + sumQ n g.
Proof. induction n as [|n IH]; cbn; [lra|]. rewrite IH. ring. Qed.
Lemma sum_minus n f g : sumQ n (fun k => f k - g k) == sumQ n f - sumQ n g.
Proof. induction n as [|n IH]; cbn; [lra|]. rewrite IH. ring. Qed.
Lemma sum_scale n a f : sumQ n (fun k => a * f k) == a * sumQ n f.
Proof. induction n as [|n IH]; cbn; [ring|]. rewrite IH. ring. Qed.
Lemma sum_zero n : sumQ n (fun _ => 0) == 0.
Proof. induction n as [|n IH]; cbn; [reflexivity|]. rewrite IH. ring. Qed.
Lemma sum_swap m n (f : nat -> nat -> Q) : sumQ m (fun i => sumQ n (f i)) == sumQ n (fun j => sumQ m (fun i => f i j)).
Proof.
  induction m as [|m IH]; cbn; [symmetry; apply sum_zero|]. rewrite IH, <- sum_plus. reflexivity.
Qed.
Lemma sum_abs n f : Qabs (sumQ n f) <= sumQ n (fun k => Qabs (f k)).
Proof.
  induction n as [|n IH]; cbn; [lra|]. eapply Qle_trans; [apply Qabs_triangle|]. lra.
Qed.
Lemma sum_val n (f : nat -> Z) p : sumQ n (fun k => f k # p) == sumZ n f # p.
Proof.
  induction n as [|n IH]; cbn; [reflexivity|]. rewrite IH. unfold Qeq, Qplus; cbn. rewrite !Pos2Z.inj_mul. ring.
Qed.
Lemma sum_delta n f i : (i < n)%nat -> sumQ n (fun k => (if Nat.eqb i k then 1 else 0) * f k) == f i.
Proof.
  induction n as [|n IH]; intros H; [lia|]. cbn. destruct (Nat.eqb_spec i n) as [->|N].
  - rewrite (sum_ext n _ (fun _ => 0)); [rewrite sum_zero; ring|]. intros k Hk.
    destruct (Nat.eqb_spec n k); [lia|ring].
  - rewrite IH by lia. ring.
Qed.

(* ---- matrices and vectors over Q ---- *)
Definition qmat := nat -> nat -> Q.
Definition eqm n (A B : qmat) := forall i j, (i < n)%nat -> (j < n)%nat -> A i j == B i j.
Definition mulq n (A B : qmat) : qmat := fun i j => sumQ n (fun k => A i k * B k j).
Definition idq : qmat := fun i j => if Nat.eqb i j then 1 else 0.
Fixpoint powq n (A : qmat) (t : nat) : qmat := match t with O => idq | S u => mulq n A (powq n A u) end.
Fixpoint pow (c : Q) (t : nat) : Q := match t with O => 1 | S u => c * pow c u end.
Definition stochastic n (A : qmat) := forall i, (i < n)%nat ->
  (forall j, (j < n)%nat -> 0 <= A i j) /\ sumQ n (A i) == 1.
(* Half the l1-distance of two rows; tau_1 is the largest. *)
Definition distq n (A : qmat) i j : Q := (1 # 2) * sumQ n (fun k => Qabs (A i k - A j k)).
Definition is_tau1 n (A : qmat) (c : Q) : Prop :=
  (forall i j, (i < n)%nat -> (j < n)%nat -> distq n A i j <= c) /\
  exists i j, (i < n)%nat /\ (j < n)%nat /\ distq n A i j == c.

Lemma mulq_ext n A B C D : eqm n A B -> eqm n C D -> eqm n (mulq n A C) (mulq n B D).
Proof. intros H K i j Hi Hj. apply sum_ext. intros k Hk. rewrite (H i k Hi Hk), (K k j Hk Hj). reflexivity. Qed.
Lemma eqm_trans n A B C : eqm n A B -> eqm n B C -> eqm n A C.
Proof. intros H K i j Hi Hj. rewrite (H i j Hi Hj). exact (K i j Hi Hj). Qed.
Lemma dist_ext n A B i j : eqm n A B -> (i < n)%nat -> (j < n)%nat -> distq n A i j == distq n B i j.
Proof.
  intros H Hi Hj. unfold distq. rewrite (sum_ext n _ (fun k => Qabs (B i k - B j k))); [reflexivity|].
  intros k Hk. rewrite (H i k Hi Hk), (H j k Hj Hk). reflexivity.
Qed.

(* ---- the same as integers over a common denominator ---- *)
Definition zmat := (list (list Z) * positive)%type.
Definition ent (A : list (list Z)) i j : Z := nth j (nth i A []) 0%Z.
Definition val (A : zmat) : qmat := fun i j => ent (fst A) i j # snd A.
Definition tabulate {T} n (f : nat -> T) : list T := map f (seq 0 n).
Definition table n (f : nat -> nat -> Z) : list (list Z) := tabulate n (fun i => tabulate n (f i)).
Definition all n (f : nat -> bool) : bool := forallb f (seq 0 n).
Definition mulz n (A B : zmat) : zmat :=
  (table n (fun i j => sumZ n (fun k => ent (fst A) i k * ent (fst B) k j)%Z), (snd A * snd B)%positive).
Definition idz n : zmat := (table n (fun i j => if Nat.eqb i j then 1%Z else 0%Z), 1%positive).
Definition eqz n (A B : zmat) : bool :=
  all n (fun i => all n (fun j => Z.eqb (ent (fst A) i j * Zpos (snd B)) (ent (fst B) i j * Zpos (snd A)))).
Definition stochasticz n (A : zmat) : bool := all n (fun i =>
  all n (fun j => Z.leb 0 (ent (fst A) i j)) && Z.eqb (sumZ n (ent (fst A) i)) (Zpos (snd A))).
Definition l1z n (A : zmat) i j : Z := sumZ n (fun k => Z.abs (ent (fst A) i k - ent (fst A) j k)).
Definition tau1_at_most n (A : zmat) (c : Q) : bool :=
  all n (fun i => all n (fun j => Z.leb (l1z n A i j * Zpos (Qden c)) (Qnum c * Zpos (2 * snd A)))).
Definition tau1_attained n (A : zmat) (c : Q) : bool := existsb (fun i => existsb (fun j =>
  Z.eqb (l1z n A i j * Zpos (Qden c)) (Qnum c * Zpos (2 * snd A))) (seq 0 n)) (seq 0 n).

Lemma nth_tabulate {T} (d : T) f n i : (i < n)%nat -> nth i (tabulate n f) d = f i.
Proof.
  intros H. unfold tabulate. rewrite (nth_indep _ d (f 0%nat)) by (now rewrite map_length, seq_length).
  rewrite map_nth, seq_nth by exact H. reflexivity.
Qed.
Lemma ent_table n f i j : (i < n)%nat -> (j < n)%nat -> ent (table n f) i j = f i j.
Proof. intros Hi Hj. unfold ent, table. now rewrite !nth_tabulate. Qed.
Lemma all_true n f : all n f = true -> forall i, (i < n)%nat -> f i = true.
Proof. unfold all. rewrite forallb_forall. intros H i Hi. apply H, in_seq. lia. Qed.
Lemma val_mul n A B : eqm n (val (mulz n A B)) (mulq n (val A) (val B)).
Proof.
  intros i j Hi Hj. unfold val at 1, mulz; cbn [fst snd]. rewrite ent_table, <- sum_val by assumption.
  apply sum_ext. intros k Hk. reflexivity.
Qed.
Lemma val_id n : eqm n (val (idz n)) idq.
Proof.
  intros i j Hi Hj. unfold val, idz, idq; cbn [fst snd]. rewrite ent_table by assumption. now destruct (Nat.eqb i j).
Qed.
Lemma eqz_true n A B : eqz n A B = true -> eqm n (val A) (val B).
Proof.
  intros H i j Hi Hj. pose proof (all_true _ _ (all_true _ _ H i Hi) j Hj) as E. cbv beta in E. apply Z.eqb_eq in E.
  exact E.
Qed.
Lemma stochasticz_true n A : stochasticz n A = true -> stochastic n (val A).
Proof.
  intros H i Hi. pose proof (all_true _ _ H i Hi) as E. cbv beta in E. apply andb_prop in E as [E S]. split.
  - intros j Hj. pose proof (all_true _ _ E j Hj) as P. cbv beta in P. apply Z.leb_le in P. unfold val, Qle; cbn. lia.
  - unfold val. rewrite sum_val. apply Z.eqb_eq in S. unfold Qeq; cbn. change (fun j => ent (fst A) i j) with (ent (fst A) i).
    lia.
Qed.
Lemma dist_val n A i j : distq n (val A) i j == l1z n A i j # (2 * snd A).
Proof.
  unfold distq. rewrite (sum_ext n _ (fun k => Z.abs (ent (fst A) i k - ent (fst A) j k) # snd A)).
  - rewrite sum_val. unfold l1z, Qeq, Qmult; cbn [Qnum Qden]. now rewrite Z.mul_1_l.
  - intros k Hk. unfold val, Qabs, Qminus, Qplus, Qopp, Qeq; cbn [Qnum Qden].
    rewrite <- Z.mul_add_distr_r, Z.abs_mul, Pos2Z.inj_mul. cbn [Z.abs]. rewrite Z.add_opp_r. ring.
Qed.
Lemma tau1_at_most_true n A c : tau1_at_most n A c = true ->
  forall i j, (i < n)%nat -> (j < n)%nat -> distq n (val A) i j <= c.
Proof.
  intros H i j Hi Hj. rewrite dist_val. pose proof (all_true _ _ (all_true _ _ H i Hi) j Hj) as E. cbv beta in E.
  apply Z.leb_le in E. exact E.
Qed.
Lemma tau1_true n A c : tau1_at_most n A c && tau1_attained n A c = true -> is_tau1 n (val A) c.
Proof.
  intros H. apply andb_prop in H as [L E]. split; [now apply tau1_at_most_true|].
  apply existsb_exists in E as (i & Ii & E). apply existsb_exists in E as (j & Ij & E).
  apply in_seq in Ii. apply in_seq in Ij. exists i, j. repeat split; try lia. rewrite dist_val. now apply Z.eqb_eq in E.
Qed.
Lemma tau1_ext n A B c : eqm n A B -> is_tau1 n A c -> is_tau1 n B c.
Proof.
  intros H [L (i & j & Hi & Hj & E)]. split.
  - intros k l Hk Hl. rewrite <- (dist_ext n A B k l H Hk Hl). now apply L.
  - exists i, j. repeat split; try assumption. now rewrite <- (dist_ext n A B i j H Hi Hj).
Qed.

(* ---- products: the new factor comes on the left ---- *)
Definition prodq n (Ms : list zmat) : qmat := fold_left (fun P M => mulq n (val M) P) Ms idq.
Definition prodz n (Ms : list zmat) : zmat := fold_left (fun P M => mulz n M P) Ms (idz n).
Lemma prod_val n Ms : eqm n (val (prodz n Ms)) (prodq n Ms).
Proof.
  unfold prodz, prodq. assert (G : forall I J, eqm n (val I) J ->
    eqm n (val (fold_left (fun P M => mulz n M P) Ms I)) (fold_left (fun P M => mulq n (val M) P) Ms J)).
  { induction Ms as [|M Ms IH]; intros I J H; [exact H|]. cbn. apply IH.
    eapply eqm_trans; [apply val_mul|]. apply mulq_ext; [|exact H]. intros i j _ _. reflexivity. }
  apply G, val_id.
Qed.

Definition product_check n (Ms : list zmat) (c : Q) : bool :=
  forallb (stochasticz n) Ms && (let P := prodz n Ms in tau1_at_most n P c && tau1_attained n P c).

Theorem product_certificate n Ms c : product_check n Ms c = true ->
  (forall M, In M Ms -> stochastic n (val M)) /\ is_tau1 n (prodq n Ms) c.
Proof.
  unfold product_check. cbv zeta. intros H. apply andb_prop in H as [S T]. split.
  - intros M I. rewrite forallb_forall in S. apply stochasticz_true, S, I.
  - exact (tau1_ext _ _ _ _ (prod_val n Ms) (tau1_true _ _ _ T)).
Qed.
