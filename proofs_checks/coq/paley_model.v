(* The objects of Paley et al.: phasors e^{i theta}, the inner product <x, y> = Re (x^* y), directed graphs with
   adjacency a_kj = 1 when j is a neighbour of k, the Laplacian L = D - A, the quadratic form (11), the order
   parameter (7), the potentials (8) and (12); and the trigonometric forms that the proofs use. *)
From Coq Require Import Reals Lra Lia Psatz Relations.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums.
Open Scope R_scope.

Definition expi (t : R) : C := (cos t, sin t).
Definition inner (x y : C) : R := Re (Cconj x * y)%C.
Definition Csum (n : nat) (f : nat -> C) : C := (Sum n (fun k => fst (f k)), Sum n (fun k => snd (f k))).

(* graphs on the nodes 0..n-1: adj k j says that j is a neighbour of k *)
Definition graph := nat -> nat -> bool.
Definition w (adj : graph) (k j : nat) : R := if adj k j then 1 else 0.
Definition no_loops (adj : graph) := forall k, adj k k = false.
Definition undirected (adj : graph) := forall k j, adj k j = adj j k.
Definition deg (n : nat) (adj : graph) (k : nat) : R := Sum n (w adj k).
Definition lap (n : nat) (adj : graph) (k j : nat) : R := delta k j * deg n adj k - w adj k j.
Definition complete (k j : nat) : bool := negb (Nat.eqb k j).
(* a path of arcs inside the nodes 0..n-1, in the direction of the information flow *)
Definition arc (n : nat) (adj : graph) (j k : nat) : Prop := (j < n)%nat /\ (k < n)%nat /\ adj k j = true.
Definition strongly_connected (n : nat) (adj : graph) :=
  forall j k, (j < n)%nat -> (k < n)%nat -> clos_refl_trans nat (arc n adj) j k.

(* the k-th entry of A x for a real matrix A, and the Laplacian quadratic form (11) *)
Definition row (n : nat) (A : nat -> nat -> R) (k : nat) (x : nat -> C) : C :=
  Csum n (fun j => RtoC (A k j) * x j)%C.
Definition Q (n : nat) (A : nat -> nat -> R) (x : nat -> C) : R :=
  / (2 * INR n) * Sum n (fun k => inner (x k) (row n A k x)).

Definition phasors (th : nat -> R) (k : nat) : C := expi (th k).
Definition order (n : nat) (th : nat -> R) : C := (RtoC (/ INR n) * Csum n (phasors th))%C.   (* (7) *)
Definition U1 (n : nat) (th : nat -> R) : R := INR n / 2 * Cmod (order n th) ^ 2.              (* (8) *)
Definition W1 (n : nat) (adj : graph) (th : nat -> R) : R := Q n (lap n adj) (phasors th).    (* (12) *)
Definition synchronized (n : nat) (th : nat -> R) :=
  forall j k, (j < n)%nat -> (k < n)%nat -> expi (th j) = expi (th k).
Definition balanced (n : nat) (th : nat -> R) := order n th = RtoC 0.

(* ---- the inner product ---- *)
Lemma inner_xy x y : inner x y = fst x * fst y + snd x * snd y.
Proof. unfold inner, Re, Cconj, Cmult; cbn. ring. Qed.
Lemma inner_sym x y : inner x y = inner y x.
Proof. rewrite !inner_xy. ring. Qed.
Lemma inner_self x : inner x x = Cmod x ^ 2.
Proof. rewrite inner_xy. unfold Cmod. rewrite <- Rsqr_pow2, Rsqr_sqrt; [ring|nra]. Qed.
Lemma inner_scal c x y : inner x (RtoC c * y)%C = c * inner x y.
Proof. rewrite !inner_xy. cbn. ring. Qed.
Lemma inner_plus x y z : inner x (y + z)%C = inner x y + inner x z.
Proof. rewrite !inner_xy. cbn. ring. Qed.
Lemma inner_minus x y z : inner x (y - z)%C = inner x y - inner x z.
Proof. rewrite !inner_xy. cbn. ring. Qed.
Lemma inner_Csum n x f : inner x (Csum n f) = Sum n (fun k => inner x (f k)).
Proof.
  rewrite inner_xy. unfold Csum; cbn [fst snd]. rewrite <- !Sum_scal, <- Sum_plus.
  apply Sum_ext; intros k _. now rewrite inner_xy.
Qed.
Lemma inner_row n A x k y : inner x (row n A k y) = Sum n (fun j => A k j * inner x (y j)).
Proof. unfold row. rewrite inner_Csum. apply Sum_ext; intros j _. apply inner_scal. Qed.
Lemma inner_self_0 x : inner x x = 0 -> x = RtoC 0.
Proof.
  rewrite inner_xy. destruct x as [a b]; cbn. intros H. unfold RtoC. f_equal; nra.
Qed.
Lemma inner_self_ge0 x : 0 <= inner x x.
Proof. rewrite inner_xy. nra. Qed.

Lemma Csum_ext n f g : (forall k, (k < n)%nat -> f k = g k) -> Csum n f = Csum n g.
Proof. intros H. unfold Csum. f_equal; apply Sum_ext; intros k Hk; now rewrite H. Qed.
Lemma Csum_scal n (c : C) f : Csum n (fun k => c * f k)%C = (c * Csum n f)%C.
Proof.
  unfold Csum, Cmult; cbn. f_equal.
  - rewrite <- !Sum_scal, <- Sum_minus. reflexivity.
  - rewrite <- !Sum_scal, <- Sum_plus. reflexivity.
Qed.
Lemma Csum_plus n f g : Csum n (fun k => f k + g k)%C = (Csum n f + Csum n g)%C.
Proof. unfold Csum, Cplus; cbn. now rewrite !Sum_plus. Qed.
Lemma Csum_minus n f g : Csum n (fun k => f k - g k)%C = (Csum n f - Csum n g)%C.
Proof.
  unfold Csum, Cminus, Cplus, Copp; cbn.
  f_equal; rewrite <- Sum_opp, <- Sum_plus; reflexivity.
Qed.
Lemma Csum_0 n f : (forall k, (k < n)%nat -> f k = RtoC 0) -> Csum n f = RtoC 0.
Proof. intros H. unfold Csum, RtoC. f_equal; apply Sum_zero; intros k Hk; now rewrite H. Qed.
Lemma Csum_const n (c : C) : Csum n (fun _ => c) = (RtoC (INR n) * c)%C.
Proof. unfold Csum, RtoC, Cmult; cbn. rewrite !Sum_const. f_equal; ring. Qed.
Lemma Csum_S n f : Csum (Datatypes.S n) f = (Csum n f + f n)%C.
Proof. reflexivity. Qed.
Lemma Csum_swap n m f : Csum n (fun i => Csum m (fun j => f i j)) = Csum m (fun j => Csum n (fun i => f i j)).
Proof. unfold Csum; cbn. f_equal; apply Sum_swap. Qed.

(* ---- phasors ---- *)
Lemma expi_plus s t : expi (s + t) = (expi s * expi t)%C.
Proof. unfold expi, Cmult; cbn. rewrite cos_plus, sin_plus. f_equal; ring. Qed.
Lemma expi_0 : expi 0 = RtoC 1.
Proof. unfold expi, RtoC. now rewrite cos_0, sin_0. Qed.
Lemma sc2 t : sin t ^ 2 + cos t ^ 2 = 1.
Proof. pose proof (sin2_cos2 t). unfold Rsqr in H. lra. Qed.
Lemma Cmod_expi t : Cmod (expi t) = 1.
Proof. unfold Cmod, expi; cbn [fst snd]. replace (_ + _) with 1 by (pose proof (sc2 t); lra). apply sqrt_1. Qed.
Lemma expi_neq0 t : expi t <> RtoC 0.
Proof. intros E. pose proof (Cmod_expi t) as H. rewrite E, Cmod_0 in H. lra. Qed.
Lemma inner_expi s t : inner (expi s) (expi t) = cos (t - s).
Proof. rewrite inner_xy. cbn. rewrite cos_minus. ring. Qed.
Lemma inner_iexpi s t : inner (Ci * expi s)%C (expi t) = sin (t - s).
Proof. rewrite inner_xy. cbn. rewrite sin_minus. ring. Qed.
Lemma expi_eq_cos s t : expi s = expi t <-> cos (s - t) = 1.
Proof.
  split.
  - intros E. injection E as E1 E2. rewrite cos_minus, E1, E2. pose proof (sc2 t). lra.
  - intros E. rewrite cos_minus in E. unfold expi. pose proof (sc2 s). pose proof (sc2 t).
    assert ((cos s - cos t) ^ 2 + (sin s - sin t) ^ 2 = 0) by (ring_simplify; lra).
    pose proof (pow2_ge_0 (cos s - cos t)). pose proof (pow2_ge_0 (sin s - sin t)). f_equal; nra.
Qed.
Lemma expi_inj_minus s t : expi s = expi t -> expi (s - t) = RtoC 1.
Proof.
  intros E. rewrite <- expi_0. apply expi_eq_cos. apply expi_eq_cos in E. now rewrite Rminus_0_r.
Qed.

Lemma order_xy n th : order n th =
  (/ INR n * Sum n (fun k => cos (th k)), / INR n * Sum n (fun k => sin (th k))).
Proof. unfold order, Csum, phasors, RtoC, Cmult; cbn. f_equal; ring. Qed.
Lemma inner_order n z th : inner z (order n th) = / INR n * Sum n (fun j => inner z (expi (th j))).
Proof. unfold order. now rewrite inner_scal, inner_Csum. Qed.

Lemma INR_pos n : (1 <= n)%nat -> 0 < INR n.
Proof. intros H. apply lt_0_INR. lia. Qed.

(* the potentials as sums of cosines *)
Definition cos_pairs (n : nat) (A : nat -> nat -> R) (th : nat -> R) : R :=
  Sum n (fun k => Sum n (fun j => A k j * cos (th j - th k))).
Lemma Q_phasors n A th : Q n A (phasors th) = / (2 * INR n) * cos_pairs n A th.
Proof.
  unfold Q, cos_pairs. f_equal. apply Sum_ext; intros k _. rewrite inner_row.
  apply Sum_ext; intros j _. unfold phasors. now rewrite inner_expi.
Qed.
Lemma U1_pairs n th : (1 <= n)%nat -> U1 n th = / (2 * INR n) * cos_pairs n (fun _ _ => 1) th.
Proof.
  intros Hn. pose proof (INR_pos n Hn). unfold U1, cos_pairs. rewrite <- inner_self, order_xy, inner_xy; cbn [fst snd].
  replace (/ INR n * _ * (/ INR n * _) + _) with (/ INR n * / INR n *
    (Sum n (fun k => cos (th k)) * Sum n (fun k => cos (th k)) + Sum n (fun k => sin (th k)) * Sum n (fun k => sin (th k)))) by ring.
  rewrite !Sum_sqr, <- Sum_plus.
  rewrite (Sum_ext n _ (fun k => Sum n (fun j => 1 * cos (th j - th k)))).
  - field. lra.
  - intros k _. rewrite <- Sum_plus. apply Sum_ext; intros j _. rewrite cos_minus. ring.
Qed.

(* the Laplacian acts by differences *)
Lemma lap_mul n adj k x : (k < n)%nat ->
  Sum n (fun j => lap n adj k j * x j) = Sum n (fun j => w adj k j * (x k - x j)).
Proof.
  intros Hk. unfold lap, deg.
  transitivity (Sum n (fun j => delta k j * (Sum n (w adj k) * x j)) - Sum n (fun j => w adj k j * x j)).
  - rewrite <- Sum_minus. apply Sum_ext; intros; ring.
  - rewrite (Sum_delta_l n k (fun j => Sum n (w adj k) * x j) Hk), <- Sum_scal_r, <- Sum_minus.
    apply Sum_ext; intros; ring.
Qed.
Lemma row_lap n adj k x : (k < n)%nat -> row n (lap n adj) k x = Csum n (fun j => RtoC (w adj k j) * (x k - x j))%C.
Proof.
  intros Hk. unfold row, Csum. cbn. f_equal.
  - rewrite <- (Sum_ext n (fun j => lap n adj k j * fst (x j))) by (intros; ring).
    rewrite (lap_mul n adj k (fun j => fst (x j)) Hk). apply Sum_ext; intros; ring.
  - rewrite <- (Sum_ext n (fun j => lap n adj k j * snd (x j))) by (intros; ring).
    rewrite (lap_mul n adj k (fun j => snd (x j)) Hk). apply Sum_ext; intros; ring.
Qed.
Lemma lap_sym n adj : undirected adj -> forall k j, lap n adj k j = lap n adj j k.
Proof.
  intros S k j. unfold lap. destruct (Nat.eq_dec k j) as [->|N]; [reflexivity|].
  rewrite (delta_neq k j N), (delta_neq j k) by congruence. unfold w. rewrite (S k j). ring.
Qed.
Lemma w_ge0 adj k j : 0 <= w adj k j.
Proof. unfold w. destruct (adj k j); lra. Qed.

(* the potential W_1 of ANY directed graph: sum over the arcs of 1 - cos *)
Lemma inner_lap n adj th k : (k < n)%nat ->
  inner (phasors th k) (row n (lap n adj) k (phasors th)) = Sum n (fun j => w adj k j * (1 - cos (th j - th k))).
Proof.
  intros Hk. rewrite row_lap by assumption. rewrite inner_Csum. apply Sum_ext; intros j _.
  rewrite inner_scal, inner_minus. unfold phasors. rewrite !inner_expi. replace (th k - th k) with 0 by ring.
  now rewrite cos_0.
Qed.
Lemma W1_arcs n adj th :
  W1 n adj th = / (2 * INR n) * Sum n (fun k => Sum n (fun j => w adj k j * (1 - cos (th j - th k)))).
Proof. unfold W1, Q. f_equal. apply Sum_ext; intros k Hk. now apply inner_lap. Qed.

(* ---- derivatives ---- *)
(* along a curve theta(t) with rates om *)
Lemma D_cos_pairs n A (th : nat -> R -> R) (om : nat -> R) (t : R) :
  (forall k, (k < n)%nat -> is_derive (th k) t (om k)) ->
  is_derive (fun s => cos_pairs n A (fun k => th k s)) t
    (Sum n (fun k => om k * Sum n (fun j => (A k j + A j k) * sin (th j t - th k t)))).
Proof.
  intros H. unfold cos_pairs. eapply D_eq.
  - apply (D_Sum n (fun k s => Sum n (fun j => A k j * cos (th j s - th k s)))
      (fun k => Sum n (fun j => A k j * (- sin (th j t - th k t) * (om j - om k))))).
    intros k Hk. apply (D_Sum n (fun j s => A k j * cos (th j s - th k s))
      (fun j => A k j * (- sin (th j t - th k t) * (om j - om k)))).
    intros j Hj. apply D_scal. apply (D_cos (fun s => th j s - th k s)). apply D_minus; apply H; assumption.
  - rewrite (Sum_ext n (fun k => om k * _) (fun k => Sum n (fun j => A k j * sin (th j t - th k t) * om k)
      + Sum n (fun j => - (A j k * sin (th k t - th j t)) * om k))).
    + rewrite Sum_plus, (Sum_swap n n (fun k j => - (A j k * sin (th k t - th j t)) * om k)), <- Sum_plus.
      apply Sum_ext; intros k _. rewrite <- Sum_plus. apply Sum_ext; intros j _. ring.
    + intros k _. rewrite <- Sum_scal, <- Sum_plus. apply Sum_ext; intros j _.
      replace (th j t - th k t) with (- (th k t - th j t)) by ring. rewrite sin_neg. ring.
Qed.

(* partial derivatives: only the phase of node k varies *)
Definition upd (th : nat -> R) (k : nat) (s : R) (j : nat) : R := if Nat.eqb j k then s else th j.
Lemma upd_same th k j : upd th k (th k) j = th j.
Proof. unfold upd. destruct (Nat.eqb_spec j k) as [->|]; reflexivity. Qed.
Lemma D_upd th k j (s : R) : is_derive (fun s : R => upd th k s j) s (delta j k).
Proof. unfold upd, delta. destruct (Nat.eqb j k); [apply D_id|apply D_const]. Qed.
Definition partial (f : (nat -> R) -> R) (th : nat -> R) (k : nat) (d : R) :=
  is_derive (fun s : R => f (upd th k s)) (th k) d.
Definition stationary (n : nat) (f : (nat -> R) -> R) (th : nat -> R) :=
  forall k, (k < n)%nat -> partial f th k 0.

Lemma partial_cos_pairs n A th k : (k < n)%nat ->
  partial (cos_pairs n A) th k (Sum n (fun j => (A k j + A j k) * sin (th j - th k))).
Proof.
  intros Hk. unfold partial. eapply D_eq.
  - apply (D_cos_pairs n A (fun j s => upd th k s j) (fun j => delta j k)). intros j _. apply D_upd.
  - cbv beta. rewrite (Sum_delta n k (fun m => Sum n (fun j =>
      (A m j + A j m) * sin (upd th k (th k) j - upd th k (th k) m))) Hk).
    apply Sum_ext; intros j _. now rewrite !upd_same.
Qed.
Lemma partial_ext f g th k d : (forall th, f th = g th) -> partial g th k d -> partial f th k d.
Proof. intros E. unfold partial. apply is_derive_ext. intros; symmetry; apply E. Qed.
Lemma partial_scal c f th k d : partial f th k d -> partial (fun th => c * f th) th k (c * d).
Proof. intros H. unfold partial. apply (D_scal c (fun s => f (upd th k s))). exact H. Qed.
Lemma partial_unique f th k d e : partial f th k d -> partial f th k e -> d = e.
Proof.
  intros H K. apply is_derive_unique in H. apply is_derive_unique in K. congruence.
Qed.
