(* chazelle.pi, chazelle.lem3.3: where the powers of the matrix of a fixed connected network go, and Gamma, by integers.
   A vector whose entries differ by at most w is mapped by a matrix with tau_1 <= c to one whose entries differ by at most
   c w; so the columns of P^t flatten at least by c in every k steps, and the weights pi keep their mean. *)
From Coq Require Import ZArith QArith Qabs List Lia Lqa Bool.
From Flockproof Require Import certificate_matrices.
Import ListNotations.
Open Scope Q_scope.

Definition app n (A : qmat) (x : nat -> Q) : nat -> Q := fun i => sumQ n (fun l => A i l * x l).
Fixpoint orbit n A x (t : nat) : nat -> Q := match t with O => x | S u => app n A (orbit n A x u) end.
Definition spread n (x : nat -> Q) (w : Q) := forall i j, (i < n)%nat -> (j < n)%nat -> x i - x j <= w.
Definition eqv n (x y : nat -> Q) := forall i, (i < n)%nat -> x i == y i.

Lemma app_ext n A B x y : eqm n A B -> eqv n x y -> eqv n (app n A x) (app n B y).
Proof. intros H K i Hi. apply sum_ext. intros l Hl. rewrite (H i l Hi Hl), (K l Hl). reflexivity. Qed.
Lemma eqm_refl n A : eqm n A A. Proof. intros i j _ _. reflexivity. Qed.
Lemma app_mul n A B x i : app n (mulq n A B) x i == app n A (app n B x) i.
Proof.
  unfold app, mulq.
  rewrite (sum_ext n _ (fun l => sumQ n (fun k => A i k * (B k l * x l)))).
  - rewrite sum_swap. apply sum_ext. intros k Hk. now rewrite sum_scale.
  - intros l Hl. rewrite Qmult_comm, <- sum_scale. apply sum_ext. intros k Hk. ring.
Qed.
Lemma app_id n x i : (i < n)%nat -> app n idq x i == x i.
Proof. intros Hi. unfold app, idq. now apply sum_delta. Qed.
Lemma app_pow n A x t : eqv n (app n (powq n A t) x) (orbit n A x t).
Proof.
  induction t as [|t IH]; intros i Hi; [now apply app_id|]. cbn [powq orbit].
  rewrite app_mul. exact (app_ext n A A _ _ (eqm_refl n A) IH i Hi).
Qed.
Lemma orbit_add n A x s t : orbit n A x (s + t) = orbit n A (orbit n A x t) s.
Proof. induction s as [|s IH]; [reflexivity|]. cbn [Nat.add orbit]. now rewrite IH. Qed.

(* ---- flattening ---- *)
Lemma least n (x : nat -> Q) : (0 < n)%nat -> exists m, (m < n)%nat /\ forall l, (l < n)%nat -> x m <= x l.
Proof.
  induction n as [|n IH]; [lia|]. intros _. destruct n as [|n].
  - exists 0%nat. split; [lia|]. intros l Hl. replace l with 0%nat by lia. lra.
  - destruct IH as (m & Hm & M); [lia|]. destruct (Qlt_le_dec (x (S n)) (x m)) as [L|L].
    + exists (S n). split; [lia|]. intros l Hl. destruct (Nat.eq_dec l (S n)) as [->|]; [lra|].
      specialize (M l ltac:(lia)). lra.
    + exists m. split; [lia|]. intros l Hl. destruct (Nat.eq_dec l (S n)) as [->|]; [exact L|]. apply M. lia.
Qed.
Lemma centre n x w : (0 < n)%nat -> spread n x w -> exists c, forall l, (l < n)%nat -> Qabs (x l - c) <= (1 # 2) * w.
Proof.
  intros Hn S. destruct (least n x Hn) as (m & Hm & M). exists (x m + (1 # 2) * w). intros l Hl.
  specialize (M l Hl). specialize (S l m Hl Hm). apply Qabs_Qle_condition. lra.
Qed.
Lemma contracts n A c x w : (forall i, (i < n)%nat -> sumQ n (A i) == 1) ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> distq n A i j <= c) -> spread n x w -> spread n (app n A x) (c * w).
Proof.
  intros R D S i j Hi Hj. assert (W : 0 <= w) by (specialize (S i i Hi Hi); lra).
  destruct (centre n x w ltac:(lia) S) as (m & M).
  assert (E : app n A x i - app n A x j == sumQ n (fun l => (A i l - A j l) * (x l - m))).
  { rewrite (sum_ext n _ (fun l => (A i l * x l - A j l * x l) - m * (A i l - A j l))) by (intros; ring).
    rewrite sum_minus, sum_minus, sum_scale, sum_minus, (R i Hi), (R j Hj). unfold app. ring. }
  rewrite E. eapply Qle_trans; [apply Qle_Qabs|]. eapply Qle_trans; [apply sum_abs|].
  eapply Qle_trans.
  - apply (sum_le n _ (fun l => ((1 # 2) * w) * Qabs (A i l - A j l))). intros l Hl. rewrite Qabs_Qmult.
    rewrite Qmult_comm. apply Qmult_le_compat_r; [now apply M|apply Qabs_nonneg].
  - rewrite sum_scale. specialize (D i j Hi Hj). unfold distq in D.
    apply (Qmult_le_compat_r _ _ w) in D; [|exact W]. lra.
Qed.
Lemma dist_le_1 n A i j : stochastic n A -> (i < n)%nat -> (j < n)%nat -> distq n A i j <= 1.
Proof.
  intros S Hi Hj. unfold distq. destruct (S i Hi) as [Pi Si], (S j Hj) as [Pj Sj].
  assert (sumQ n (fun k => Qabs (A i k - A j k)) <= sumQ n (fun k => A i k + A j k)).
  { apply sum_le. intros k Hk. specialize (Pi k Hk). specialize (Pj k Hk). apply Qabs_Qle_condition. lra. }
  rewrite sum_plus in H. change (fun k => A i k) with (A i) in H. change (fun k => A j k) with (A j) in H. lra.
Qed.
Lemma stochastic_rows n A : stochastic n A -> forall i, (i < n)%nat -> sumQ n (A i) == 1.
Proof. intros S i Hi. apply (S i Hi). Qed.
Lemma spread_ext n x y w v : eqv n x y -> w == v -> spread n x w -> spread n y v.
Proof. intros E W S i j Hi Hj. rewrite <- (E i Hi), <- (E j Hj), <- W. now apply S. Qed.
Lemma orbit_keeps n A x w t : stochastic n A -> spread n x w -> spread n (orbit n A x t) w.
Proof.
  intros S K. induction t as [|t IH]; [exact K|]. cbn [orbit].
  apply (spread_ext n (app n A (orbit n A x t)) _ (1 * w)); [intros i Hi; reflexivity|ring|].
  apply contracts; [now apply stochastic_rows|intros; now apply dist_le_1|exact IH].
Qed.
Lemma ones n A t : (forall i, (i < n)%nat -> sumQ n (A i) == 1) -> eqv n (orbit n A (fun _ => 1) t) (fun _ => 1).
Proof.
  intros R. induction t as [|t IH]; intros i Hi; [reflexivity|]. cbn [orbit].
  rewrite (app_ext n A A _ _ (eqm_refl n A) IH i Hi). unfold app.
  rewrite (sum_ext n _ (A i)) by (intros; ring). now apply R.
Qed.
Lemma pow_rows n A t : (forall i, (i < n)%nat -> sumQ n (A i) == 1) ->
  forall i, (i < n)%nat -> sumQ n (powq n A t i) == 1.
Proof.
  intros R i Hi. rewrite <- (ones n A t R i Hi), <- (app_pow n A _ t i Hi). apply sum_ext. intros l Hl. ring.
Qed.
Lemma flattens n A k c x w : stochastic n A ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> distq n (powq n A k) i j <= c) -> spread n x w ->
  forall q r, spread n (orbit n A x (k * q + r)) (pow c q * w).
Proof.
  intros S D K q r. induction q as [|q IH].
  - rewrite Nat.mul_0_r. apply (spread_ext n (orbit n A x r) _ w); [intros i Hi; reflexivity|cbn; ring|].
    now apply orbit_keeps.
  - replace (k * Datatypes.S q + r)%nat with (k + (k * q + r))%nat by lia. rewrite orbit_add.
    apply (spread_ext n (app n (powq n A k) (orbit n A x (k * q + r))) _ (c * (pow c q * w))).
    + apply app_pow.
    + cbn. ring.
    + apply contracts; [apply pow_rows; now apply stochastic_rows|exact D|exact IH].
Qed.
Lemma flattens_at n A k c x w t : (0 < k)%nat -> stochastic n A ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> distq n (powq n A k) i j <= c) -> spread n x w ->
  spread n (orbit n A x t) (pow c (t / k) * w).
Proof. intros K S D W. rewrite (Nat.div_mod t k) at 1 by lia. now apply flattens. Qed.

(* ---- the mean with the weights pi ---- *)
Definition mean n (p x : nat -> Q) : Q := sumQ n (fun i => p i * x i).
Lemma mean_kept n A p x t : (forall j, (j < n)%nat -> sumQ n (fun i => p i * A i j) == p j) ->
  mean n p (orbit n A x t) == mean n p x.
Proof.
  intros H. induction t as [|t IH]; [reflexivity|]. rewrite <- IH. cbn [orbit]. unfold mean, app.
  rewrite (sum_ext n _ (fun i => sumQ n (fun l => p i * A i l * orbit n A x t l)));
    [|intros i Hi; rewrite <- sum_scale; apply sum_ext; intros l Hl; ring].
  rewrite sum_swap. apply sum_ext. intros l Hl.
  rewrite (sum_ext n _ (fun i => orbit n A x t l * (p i * A i l))) by (intros; ring). rewrite sum_scale, (H l Hl). ring.
Qed.
Lemma near_mean n p y w i : (forall j, (j < n)%nat -> 0 <= p j) -> sumQ n p == 1 -> spread n y w -> (i < n)%nat ->
  Qabs (y i - mean n p y) <= w.
Proof.
  intros P S W Hi. assert (E : y i - mean n p y == sumQ n (fun l => p l * (y i - y l))).
  { unfold mean. rewrite (sum_ext n (fun l => p l * (y i - y l)) (fun l => y i * p l - p l * y l)) by (intros; ring).
    rewrite sum_minus, sum_scale. change (fun k => p k) with p. rewrite S. ring. }
  rewrite E. eapply Qle_trans; [apply sum_abs|]. eapply Qle_trans.
  - apply (sum_le n _ (fun l => w * p l)). intros l Hl. rewrite Qabs_Qmult, (Qabs_pos (p l)) by now apply P.
    rewrite Qmult_comm. apply Qmult_le_compat_r; [|now apply P].
    apply Qabs_Qle_condition. pose proof (W i l Hi Hl). pose proof (W l i Hl Hi). lra.
  - rewrite sum_scale. change (fun k => p k) with p. rewrite S. lra.
Qed.

(* ---- Gamma ---- *)
(* Gamma_t = sum_(s < t) P^s - t 1 pi^T *)
Definition gamma_t n (A : qmat) (p : nat -> Q) (t : nat) : qmat :=
  fun i j => sumQ t (fun s => powq n A s i j) - inject_Z (Z.of_nat t) * p j.
Definition unit_vector (j : nat) : nat -> Q := fun i => if Nat.eqb i j then 1 else 0.

Lemma pow_column n A t i j : (i < n)%nat -> (j < n)%nat -> powq n A t i j == orbit n A (unit_vector j) t i.
Proof.
  intros Hi Hj. rewrite <- (app_pow n A _ t i Hi). unfold app, unit_vector.
  rewrite (sum_ext n _ (fun l => (if Nat.eqb j l then 1 else 0) * powq n A t i l)).
  - now rewrite sum_delta.
  - intros l Hl. rewrite (Nat.eqb_sym j l). ring.
Qed.
Lemma mean_unit n p j : (j < n)%nat -> mean n p (unit_vector j) == p j.
Proof.
  intros Hj. unfold mean, unit_vector. rewrite (sum_ext n _ (fun l => (if Nat.eqb j l then 1 else 0) * p l)).
  - now apply sum_delta.
  - intros l Hl. rewrite (Nat.eqb_sym j l). ring.
Qed.
(* One step of the orbit of g, where g - P g = e - b 1. *)
Lemma orbit_generator n A g e b t : (forall i, (i < n)%nat -> sumQ n (A i) == 1) ->
  (forall i, (i < n)%nat -> g i - app n A g i == e i - b) ->
  forall i, (i < n)%nat -> orbit n A g t i - orbit n A g (Datatypes.S t) i == orbit n A e t i - b.
Proof.
  intros R H. induction t as [|t IH]; intros i Hi; [exact (H i Hi)|]. cbn [orbit] in *. unfold app at 1 2 4.
  rewrite <- sum_minus.
  rewrite (sum_ext n _ (fun l => A i l * orbit n A e t l - b * A i l)).
  - rewrite sum_minus, sum_scale. change (fun k => A i k) with (A i). rewrite (R i Hi). ring.
  - intros l Hl. specialize (IH l Hl).
    assert (E : A i l * orbit n A g t l - A i l * app n A (orbit n A g t) l ==
                A i l * (orbit n A g t l - app n A (orbit n A g t) l)) by ring.
    rewrite E, IH. ring.
Qed.

(* ---- the certificate ---- *)
Definition vec (p : list Z * positive) : nat -> Q := fun j => nth j (fst p) 0%Z # snd p.
(* pi as every row of a matrix *)
Definition rowsz n (p : list Z * positive) : zmat := (tabulate n (fun _ => fst p), snd p).
Fixpoint powz n (A : zmat) (t : nat) : zmat := match t with O => idz n | S u => mulz n A (powz n A u) end.
Definition minusz n (A B : zmat) : zmat :=
  (table n (fun i j => ent (fst A) i j * Zpos (snd B) - ent (fst B) i j * Zpos (snd A))%Z, (snd A * snd B)%positive).
Definition zeroz n : zmat := (table n (fun _ _ => 0%Z), 1%positive).
Definition limit_check n (P : zmat) (p : list Z * positive) (G : zmat) (k : nat) (c : Q) : bool :=
  let E := rowsz n p in
  stochasticz n P && stochasticz n E && eqz n (mulz n E P) E &&
  eqz n (mulz n (minusz n (idz n) P) G) (minusz n (idz n) E) && eqz n (mulz n E G) (zeroz n) &&
  tau1_at_most n (powz n P k) c && Nat.ltb 0 k && Nat.ltb 0 n && negb (Qle_bool 1 c) && Qle_bool 0 c.

Lemma val_pow n A t : eqm n (val (powz n A t)) (powq n (val A) t).
Proof.
  induction t as [|t IH]; [apply val_id|]. cbn [powz powq]. eapply eqm_trans; [apply val_mul|].
  apply mulq_ext; [apply eqm_refl|exact IH].
Qed.
Lemma val_rows n p i j : (i < n)%nat -> val (rowsz n p) i j = vec p j.
Proof. intros Hi. unfold val, rowsz, vec, ent; cbn [fst snd]. now rewrite nth_tabulate. Qed.
Lemma val_minus n A B i j : (i < n)%nat -> (j < n)%nat -> val (minusz n A B) i j == val A i j - val B i j.
Proof.
  intros Hi Hj. unfold val, minusz; cbn [fst snd]. rewrite ent_table by assumption.
  unfold Qeq, Qminus, Qplus, Qopp; cbn [Qnum Qden]. rewrite !Pos2Z.inj_mul. ring.
Qed.
Lemma val_zero n i j : (i < n)%nat -> (j < n)%nat -> val (zeroz n) i j == 0.
Proof. intros Hi Hj. unfold val, zeroz; cbn [fst snd]. now rewrite ent_table. Qed.

(* With the rate c < 1 for every k steps: the powers of P go to the matrix whose rows all are pi, and Gamma_t goes to Gamma;
   w bounds how much the entries of a column of Gamma differ. *)
Definition converges n (P : qmat) (p : nat -> Q) (Gamma : qmat) (k : nat) (c : Q) : Prop :=
  stochastic n P /\ (0 <= c /\ c < 1) /\ (0 < k)%nat /\
  (forall j, (j < n)%nat -> sumQ n (fun i => p i * P i j) == p j) /\
  (forall j, (j < n)%nat -> 0 <= p j) /\ sumQ n p == 1 /\
  (forall t i j, (i < n)%nat -> (j < n)%nat -> Qabs (powq n P t i j - p j) <= pow c (t / k)) /\
  (forall j w, (j < n)%nat -> spread n (fun i => Gamma i j) w -> forall t i, (i < n)%nat ->
     Qabs (gamma_t n P p t i j - Gamma i j) <= pow c (t / k) * w).

(* chazelle.lem3.3 for every P and pi over Q whose powers contract, with Gamma given by two identities. *)
Theorem gamma_is_the_limit n (P : qmat) (p : nat -> Q) (Gamma : qmat) k c :
  (0 < n)%nat -> (0 < k)%nat -> 0 <= c -> c < 1 -> stochastic n P ->
  (forall j, (j < n)%nat -> sumQ n (fun i => p i * P i j) == p j) ->
  (forall j, (j < n)%nat -> 0 <= p j) -> sumQ n p == 1 ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> distq n (powq n P k) i j <= c) ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> Gamma i j - mulq n P Gamma i j == idq i j - p j) ->
  (forall j, (j < n)%nat -> sumQ n (fun i => p i * Gamma i j) == 0) ->
  converges n P p Gamma k c.
Proof.
  intros HN HK HC0 C1 HP Fixed Pi0 Pi1 D HG HZ.
  assert (Rows : forall i, (i < n)%nat -> sumQ n (P i) == 1) by now apply stochastic_rows.
  split; [exact HP|]. split; [split; assumption|]. split; [exact HK|]. split; [exact Fixed|]. split; [exact Pi0|].
  split; [exact Pi1|]. split.
  - intros t i j Hi Hj. rewrite (pow_column n _ t i j Hi Hj), <- (mean_unit n p j Hj).
    rewrite <- (mean_kept n P p (unit_vector j) t Fixed). rewrite <- (Qmult_1_r (pow c (t / k))).
    apply near_mean; try assumption. apply flattens_at; try assumption.
    intros a b _ _. unfold unit_vector. destruct (Nat.eqb a j), (Nat.eqb b j); lra.
  - intros j w Hj W t i Hi. set (g := fun i => Gamma i j).
    assert (Step : forall i, (i < n)%nat -> g i - app n P g i == unit_vector j i - p j) by (intros l Hl; exact (HG l j Hl Hj)).
    assert (Sum : forall t, gamma_t n P p t i j - g i == - orbit n P g t i).
    { induction t0 as [|t0 IH].
      - unfold gamma_t, g. cbn. ring.
      - pose proof (orbit_generator n P g (unit_vector j) (p j) t0 Rows Step i Hi) as O.
        rewrite <- (pow_column n _ t0 i j Hi Hj) in O. unfold gamma_t in *. cbn [sumQ].
        rewrite Nat2Z.inj_succ, <- Z.add_1_r, inject_Z_plus. change (inject_Z 1) with 1. lra. }
    change (Gamma i j) with (g i). rewrite (Sum t), Qabs_opp.
    setoid_replace (orbit n P g t i) with (orbit n P g t i - mean n p (orbit n P g t)).
    + apply near_mean; try assumption. now apply flattens_at.
    + rewrite (mean_kept n P p g t Fixed). change (mean n p g) with (sumQ n (fun i => p i * Gamma i j)). rewrite (HZ j Hj). ring.
Qed.

Theorem limit_certificate n P p G k c :
  limit_check n P p G k c = true -> converges n (val P) (vec p) (val G) k c.
Proof.
  unfold limit_check. cbv zeta. intros H. repeat (apply andb_prop in H as [H ?]).
  rename H into HP, H0 into HC0, H1 into HC1, H2 into HN, H3 into HK, H4 into HT, H5 into HZ, H6 into HG, H7 into HF, H8 into HE.
  apply stochasticz_true in HP. apply stochasticz_true in HE. apply eqz_true in HF, HG, HZ.
  apply Nat.ltb_lt in HN, HK. apply Qle_bool_iff in HC0. apply negb_true_iff in HC1.
  apply gamma_is_the_limit; try assumption.
  - apply Qnot_le_lt. intros L. apply Qle_bool_iff in L. congruence.
  - intros j Hj. specialize (HF 0%nat j HN Hj). rewrite (val_mul n _ _ 0%nat j HN Hj), val_rows in HF by exact HN.
    rewrite <- HF. unfold mulq. apply sum_ext. intros i Hi. now rewrite val_rows.
  - intros j Hj. rewrite <- (val_rows n p 0 j HN). now apply (HE 0%nat HN).
  - rewrite <- (proj2 (HE 0%nat HN)). apply sum_ext. intros j Hj. now rewrite val_rows.
  - intros i j Hi Hj. rewrite <- (dist_ext n _ _ i j (val_pow n P k) Hi Hj). now apply (tau1_at_most_true n).
  - intros l j Hl Hj. specialize (HG l j Hl Hj). rewrite (val_mul n _ _ l j Hl Hj), val_minus in HG by assumption.
    rewrite (val_id n l j Hl Hj), val_rows in HG by assumption. rewrite <- HG. unfold mulq.
    rewrite (sum_ext n (fun k0 => val (minusz n (idz n) P) l k0 * val G k0 j)
      (fun m => (if Nat.eqb l m then 1 else 0) * val G m j - val P l m * val G m j)).
    + rewrite sum_minus, (sum_delta n (fun m => val G m j) l Hl). reflexivity.
    + intros m Hm. rewrite val_minus, (val_id n l m Hl Hm) by assumption. unfold idq. ring.
  - intros j Hj. specialize (HZ 0%nat j HN Hj). rewrite (val_mul n _ _ 0%nat j HN Hj), val_zero in HZ by assumption.
    rewrite <- HZ. unfold mulq. apply sum_ext. intros l Hl. now rewrite val_rows.
Qed.
