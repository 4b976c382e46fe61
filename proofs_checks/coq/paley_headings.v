(* Paley and others, Figure S3: the mean of W_1 over independent uniform headings.
     beyond.paley.figS3.difference (clause 2). *)
From Coq Require Import Reals Lra Lia FunctionalExtensionality.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums paley_model paley_laplacian.
Open Scope R_scope.

(* the mean over the headings of the nodes 0, .., k - 1, each uniform on [0, 2 pi], one after the other *)
Definition mean_of (F : (nat -> R) -> R) (m : nat) (th : nat -> R) : R := / (2 * PI) * RInt (fun s => F (upd th m s)) 0 (2 * PI).
Fixpoint mean_over (k : nat) (F : (nat -> R) -> R) : (nat -> R) -> R := match k with O => F | S k => mean_over k (mean_of F k) end.
Definition cosines n (c : R) (a : nat -> nat -> R) (th : nat -> R) := c + Sum n (fun i => Sum n (fun j => a i j * cos (th i - th j))).
Definition without (m : nat) (a : nat -> nat -> R) i j := if orb (Nat.eqb i m) (Nat.eqb j m) then 0 else a i j.
Lemma wave_integral c p q : is_RInt (fun s => c + p * cos s + q * sin s) 0 (2 * PI) (2 * PI * c).
Proof.
  assert (Z : 2 * PI * c = minus ((fun s => c * s + p * sin s - q * cos s) (2 * PI)) ((fun s => c * s + p * sin s - q * cos s) 0)).
  { unfold minus, plus, opp. cbn. rewrite sin_2PI, cos_2PI, sin_0, cos_0. ring. }
  rewrite Z. apply (is_RInt_derive (fun s => c * s + p * sin s - q * cos s)).
  - intros s _. auto_derive; [exact I|ring].
  - intros s _. apply (ex_derive_continuous (fun s => c + p * cos s + q * sin s)). auto_derive. exact I.
Qed.
Lemma mean_cosines n c a m : (forall i, a i i = 0) -> mean_of (cosines n c a) m = cosines n c (without m a).
Proof.
  intros D. apply functional_extensionality. intros th. unfold mean_of.
  set (p := Sum n (fun i => Sum n (fun j => if Nat.eqb i m then (if Nat.eqb j m then 0 else a i j * cos (th j)) else if Nat.eqb j m then a i j * cos (th i) else 0))).
  set (q := Sum n (fun i => Sum n (fun j => if Nat.eqb i m then (if Nat.eqb j m then 0 else a i j * sin (th j)) else if Nat.eqb j m then a i j * sin (th i) else 0))).
  assert (E : forall s, cosines n c a (upd th m s) = cosines n c (without m a) th + p * cos s + q * sin s).
  { intros s. unfold cosines, p, q. rewrite !Rplus_assoc. f_equal. rewrite <- !Sum_scal_r, <- !Sum_plus. apply Sum_ext. intros i _. rewrite <- !Sum_scal_r, <- !Sum_plus. apply Sum_ext. intros j _.
    unfold without, upd. destruct (Nat.eqb_spec i m) as [->|Ni], (Nat.eqb_spec j m) as [->|Nj]; cbn [orb].
    - rewrite D. ring.
    - rewrite cos_minus. ring.
    - rewrite cos_minus. ring.
    - ring. }
  rewrite (RInt_ext _ (fun s => cosines n c (without m a) th + p * cos s + q * sin s)) by (intros s _; apply E).
  rewrite (is_RInt_unique _ _ _ _ (wave_integral (cosines n c (without m a) th) p q)). field. apply PI_neq0.
Qed.
Lemma mean_all n c a : (forall i, a i i = 0) -> (forall i j, a i j <> 0 -> (i < n)%nat /\ (j < n)%nat) -> forall k, (forall i j, a i j <> 0 -> (i < k)%nat /\ (j < k)%nat) ->
  forall th, mean_over k (cosines n c a) th = c.
Proof.
  intros D _ k. revert a D. induction k as [|k IH]; intros a D B th; cbn [mean_over].
  - unfold cosines. rewrite (Sum_zero n); [ring|]. intros i _. apply Sum_zero. intros j _. destruct (Req_dec (a i j) 0) as [->|N]; [ring|]. destruct (B i j N). lia.
  - rewrite mean_cosines by exact D. apply IH.
    + intros i. unfold without. rewrite D. now destruct (orb _ _).
    + intros i j N. unfold without in N. destruct (Nat.eqb i k) eqn:E1; [now elim N|]. destruct (Nat.eqb j k) eqn:E2; [now elim N|]. apply Nat.eqb_neq in E1, E2. cbn in N. destruct (B i j N). lia.
Qed.
(* W_1 of a network without loops is such a sum *)
Definition weights n (adj : graph) i j := if andb (Nat.ltb i n) (Nat.ltb j n) then - / (2 * INR n) * w adj i j else 0.
Lemma W1_cosines n adj x : W1 n adj x = cosines n (/ (2 * INR n) * Sum n (fun k => Sum n (w adj k))) (weights n adj) x.
Proof.
  rewrite W1_arcs. unfold cosines. rewrite <- !Sum_scal, <- Sum_plus. apply Sum_ext. intros i Hi. rewrite <- !Sum_scal, <- Sum_plus. apply Sum_ext. intros j Hj.
  unfold weights. apply Nat.ltb_lt in Hi, Hj. rewrite Hi, Hj. cbn [andb]. replace (x i - x j) with (- (x j - x i)) by ring. rewrite cos_neg. ring.
Qed.
Lemma weights_in n adj i j : weights n adj i j <> 0 -> (i < n)%nat /\ (j < n)%nat.
Proof. unfold weights. destruct (Nat.ltb_spec i n), (Nat.ltb_spec j n); cbn; intros N; try (now elim N). now split. Qed.
(* the difference of Figure S3, W_1/c for the c nearest of each less W_1/b for the b nearest, has mean zero *)
Theorem figS3_mean n (g h : graph) (b c : nat) th : (1 <= n)%nat -> no_loops g -> no_loops h -> (1 <= b)%nat -> (1 <= c)%nat ->
  (forall k, (k < n)%nat -> deg n g k = INR b) -> (forall k, (k < n)%nat -> deg n h k = INR c) ->
  mean_over n (fun x => W1 n h x / INR c - W1 n g x / INR b) th = 0.
Proof.
  intros Hn Ng Nh Hb Hc Dg Dh. pose proof (INR_pos n Hn) as P. pose proof (INR_pos b Hb) as Pb. pose proof (INR_pos c Hc) as Pc.
  assert (E : (fun x => W1 n h x / INR c - W1 n g x / INR b) = cosines n 0 (fun i j => weights n h i j / INR c - weights n g i j / INR b)).
  { apply functional_extensionality. intros x. rewrite !W1_cosines. unfold cosines. rewrite (Sum_ext n (fun k => Sum n (w h k)) (fun _ => INR c) Dh), (Sum_ext n (fun k => Sum n (w g k)) (fun _ => INR b) Dg), !Sum_const.
    rewrite (Sum_ext n (fun i => Sum n (fun j => (weights n h i j / INR c - weights n g i j / INR b) * cos (x i - x j))) (fun i => / INR c * Sum n (fun j => weights n h i j * cos (x i - x j)) - / INR b * Sum n (fun j => weights n g i j * cos (x i - x j)))).
    - rewrite Sum_minus, !Sum_scal. field. lra.
    - intros i _. rewrite <- !Sum_scal, <- Sum_minus. apply Sum_ext. intros j _. unfold Rdiv. ring. }
  assert (B : forall i j, weights n h i j / INR c - weights n g i j / INR b <> 0 -> (i < n)%nat /\ (j < n)%nat).
  { intros i j N. destruct (Req_dec (weights n h i j) 0) as [Z|Z]; [|now apply (weights_in n h)]. destruct (Req_dec (weights n g i j) 0) as [Y|Y]; [|now apply (weights_in n g)]. elim N. rewrite Z, Y. unfold Rdiv. ring. }
  rewrite E. apply mean_all; [|exact B..]. intros i. unfold weights, w. rewrite Ng, Nh. unfold Rdiv. destruct (andb _ _); ring.
Qed.
