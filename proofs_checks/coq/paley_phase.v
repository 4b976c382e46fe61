(* Paley et al., the phase model with all-to-all coupling: eqs (7)-(10), (13) and the text after Theorem 1.
   Everything follows from N^2 |p|^2 = sum_kj cos (theta_j - theta_k); the saddles of U_1 are found by turning
   one phase of the smaller cluster (U_1 grows) or two phases of the larger cluster against each other (U_1 falls). *)
From Coq Require Import Reals Lra Lia Psatz Classical.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums paley_model.
Open Scope R_scope.

(* ---- eq (7) ---- *)
Lemma order_deficit n th : (1 <= n)%nat -> Cmod (order n th) ^ 2 =
  1 - / (INR n * INR n) * Sum n (fun k => Sum n (fun j => 1 - cos (th j - th k))).
Proof.
  intros Hn. pose proof (INR_pos n Hn) as P. pose proof (U1_pairs n th Hn) as U. unfold U1, cos_pairs in U.
  assert (E : Sum n (fun k => Sum n (fun j => 1 - cos (th j - th k)))
    = INR n * INR n - Sum n (fun k => Sum n (fun j => 1 * cos (th j - th k)))).
  { rewrite <- Sum_const, <- Sum_minus. apply Sum_ext; intros k _. rewrite <- (Rmult_1_r (INR n)), <- Sum_const, <- Sum_minus.
    apply Sum_ext; intros j _. ring. }
  rewrite E. set (s := Sum n _) in *. apply (Rmult_eq_reg_l (INR n / 2)); [|lra]. rewrite U. field. lra.
Qed.
Lemma pairs_ge0 n th : 0 <= Sum n (fun k => Sum n (fun j => 1 - cos (th j - th k))).
Proof. apply Sum_ge0; intros; apply Sum_ge0; intros. pose proof (COS_bound (th i0 - th i)). lra. Qed.
Lemma pairs_0 n th : Sum n (fun k => Sum n (fun j => 1 - cos (th j - th k))) = 0 <-> synchronized n th.
Proof.
  split; intros H.
  - intros j k Hj Hk. apply expi_eq_cos.
    assert (A : Sum n (fun j => 1 - cos (th j - th k)) = 0).
    { apply (Sum_eq0 n (fun k => Sum n (fun j => 1 - cos (th j - th k)))); try assumption.
      intros; apply Sum_ge0; intros. pose proof (COS_bound (th i - th j0)). lra. }
    assert (B : 1 - cos (th j - th k) = 0); [|lra].
    apply (Sum_eq0 n (fun j => 1 - cos (th j - th k))); try assumption.
    intros i _. pose proof (COS_bound (th i - th k)). lra.
  - apply Sum_zero; intros k Hk. apply Sum_zero; intros j Hj. rewrite (proj1 (expi_eq_cos _ _) (H j k Hj Hk)). ring.
Qed.

Theorem order_bounds n th : (1 <= n)%nat -> 0 <= Cmod (order n th) <= 1.
Proof.
  intros Hn. split; [apply Cmod_ge_0|]. pose proof (order_deficit n th Hn) as E. pose proof (pairs_ge0 n th).
  pose proof (INR_pos n Hn). assert (0 < / (INR n * INR n)) by (apply Rinv_0_lt_compat; nra).
  pose proof (Cmod_ge_0 (order n th)). nra.
Qed.
Theorem order_one n th : (1 <= n)%nat -> (Cmod (order n th) = 1 <-> synchronized n th).
Proof.
  intros Hn. pose proof (order_deficit n th Hn) as E. pose proof (INR_pos n Hn).
  assert (P : 0 < / (INR n * INR n)) by (apply Rinv_0_lt_compat; nra). rewrite <- pairs_0. split; intros H1.
  - rewrite H1 in E. nra.
  - rewrite H1 in E. pose proof (Cmod_ge_0 (order n th)). nra.
Qed.
(* p_theta is the velocity of the centre of mass R = (1/N) sum r_k of particles with velocities e^{i theta_k} *)
Definition is_velocity (r : R -> C) (t : R) (v : C) :=
  is_derive (fun s => fst (r s)) t (fst v) /\ is_derive (fun s => snd (r s)) t (snd v).
Definition centre (n : nat) (r : nat -> C) : C := (RtoC (/ INR n) * Csum n r)%C.
Lemma centre_xy n r : centre n r = (/ INR n * Sum n (fun k => fst (r k)), / INR n * Sum n (fun k => snd (r k))).
Proof. unfold centre, Csum, RtoC, Cmult; cbn. f_equal; ring. Qed.
Lemma centre_velocity n (r : nat -> R -> C) (v : nat -> C) t :
  (forall k, (k < n)%nat -> is_velocity (r k) t (v k)) -> is_velocity (fun s => centre n (fun k => r k s)) t (centre n v).
Proof.
  intros H. split.
  - apply (is_derive_ext (fun s => / INR n * Sum n (fun k => fst (r k s)))); [intros; now rewrite centre_xy|].
    rewrite centre_xy. cbn [fst]. apply D_scal. apply (D_Sum n (fun k s => fst (r k s)) (fun k => fst (v k))). intros; now apply H.
  - apply (is_derive_ext (fun s => / INR n * Sum n (fun k => snd (r k s)))); [intros; now rewrite centre_xy|].
    rewrite centre_xy. cbn [snd]. apply D_scal. apply (D_Sum n (fun k s => snd (r k s)) (fun k => snd (v k))). intros; now apply H.
Qed.
Theorem order_is_velocity n (r : nat -> R -> C) (th : nat -> R) t :
  (forall k, (k < n)%nat -> is_velocity (r k) t (expi (th k))) ->
  is_velocity (fun s => centre n (fun k => r k s)) t (order n th).
Proof. exact (centre_velocity n r (phasors th) t). Qed.
(* phases that stay balanced keep the centre of mass where it is *)
Theorem balanced_fixed_centre n (r : nat -> R -> C) (th : nat -> R -> R) :
  (forall k t, (k < n)%nat -> is_velocity (r k) t (expi (th k t))) -> (forall t, balanced n (fun k => th k t)) ->
  forall t s, centre n (fun k => r k t) = centre n (fun k => r k s).
Proof.
  intros D B t s.
  assert (V : forall u, is_velocity (fun s => centre n (fun k => r k s)) u (RtoC 0)).
  { intros u. rewrite <- (B u). apply order_is_velocity. intros; now apply D. }
  apply injective_projections.
  - apply (constant (fun u => fst (centre n (fun k => r k u)))). intros u. apply V.
  - apply (constant (fun u => snd (centre n (fun k => r k u)))). intros u. apply V.
Qed.
Theorem eq7 n th : (1 <= n)%nat ->
  (0 <= Cmod (order n th) <= 1 /\ (Cmod (order n th) = 1 <-> synchronized n th)) /\
  (forall (r : nat -> R -> C) t, (forall k, (k < n)%nat -> is_velocity (r k) t (expi (th k))) ->
     is_velocity (fun s => centre n (fun k => r k s)) t (order n th) /\
     (balanced n th <-> is_velocity (fun s => centre n (fun k => r k s)) t (RtoC 0))).
Proof.
  intros Hn. split; [split; [now apply order_bounds|now apply order_one]|]. intros r t D.
  pose proof (order_is_velocity n r th t D) as V. split; [exact V|]. split.
  - intros B. rewrite <- B. exact V.
  - intros [A1 A2]. destruct V as [V1 V2]. unfold balanced.
    apply is_derive_unique in A1, A2, V1, V2. apply injective_projections; congruence.
Qed.

(* ---- eq (8) ---- *)
Theorem U1_rotation n th a : (1 <= n)%nat -> U1 n (fun k => th k + a) = U1 n th.
Proof.
  intros Hn. rewrite !U1_pairs by assumption. f_equal. unfold cos_pairs.
  apply Sum_ext; intros k _; apply Sum_ext; intros j _. do 2 f_equal. ring.
Qed.
Theorem U1_max n th : (1 <= n)%nat -> U1 n th <= INR n / 2 /\ (U1 n th = INR n / 2 <-> synchronized n th).
Proof.
  intros Hn. pose proof (order_bounds n th Hn). pose proof (INR_pos n Hn). rewrite <- (order_one n th Hn).
  unfold U1. set (m := Cmod _) in *. assert (L : m ^ 2 <= 1) by nra. split; [|split; intros H1].
  - apply Rle_trans with (INR n / 2 * 1); [apply Rmult_le_compat_l|]; lra.
  - apply (Rmult_eq_compat_l (2 / INR n)) in H1. field_simplify in H1; [|lra..]. nra.
  - rewrite H1. lra.
Qed.
Theorem U1_min n th : (1 <= n)%nat -> 0 <= U1 n th /\ (U1 n th = 0 <-> balanced n th).
Proof.
  intros Hn. pose proof (INR_pos n Hn). unfold U1, balanced. split; [pose proof (pow2_ge_0 (Cmod (order n th))); nra|].
  split; intros E.
  - apply Cmod_eq_0. assert (Cmod (order n th) ^ 2 = 0) by nra. nra.
  - rewrite E, Cmod_0. ring.
Qed.
Theorem U1_extremes n th : (1 <= n)%nat ->
  (synchronized n th <-> forall th', U1 n th' <= U1 n th) /\ (balanced n th -> forall th', U1 n th <= U1 n th').
Proof.
  intros Hn. destruct (U1_max n th Hn) as [_ S]. destruct (U1_min n th Hn) as [_ B]. split; [split|].
  - intros H th'. apply S in H. rewrite H. now apply U1_max.
  - intros H. apply S. apply Rle_antisym; [now apply U1_max|].
    rewrite <- (proj2 (proj2 (U1_max n (fun _ => 0) Hn))); [apply H|]. intros j k _ _. reflexivity.
  - intros H th'. apply B in H. rewrite H. now apply U1_min.
Qed.

(* ---- the gradient of U_1, and the model (6) with the control (9) ---- *)
Definition g1 (n : nat) (th : nat -> R) (k : nat) : R := inner (Ci * expi (th k))%C (order n th).
Lemma g1_sines n th k : g1 n th k = / INR n * Sum n (fun j => sin (th j - th k)).
Proof. unfold g1. rewrite inner_order. f_equal. apply Sum_ext; intros; apply inner_iexpi. Qed.
Theorem U1_gradient n th k : (1 <= n)%nat -> (k < n)%nat -> partial (U1 n) th k (g1 n th k).
Proof.
  intros Hn Hk. pose proof (INR_pos n Hn). eapply partial_ext; [intros; now apply U1_pairs|].
  unfold partial. eapply D_eq; [apply partial_scal, partial_cos_pairs, Hk|].
  rewrite g1_sines, (Sum_ext n _ (fun j => 2 * sin (th j - th k))) by (intros; ring).
  rewrite Sum_scal. field. lra.
Qed.
Theorem gradient_orthogonal n th : Sum n (g1 n th) = 0.
Proof.
  rewrite (Sum_ext n _ (fun k => / INR n * Sum n (fun j => sin (th j - th k)))) by (intros; apply g1_sines).
  rewrite Sum_scal, Sum_antisym; [ring|]. intros i j _ _. rewrite <- sin_neg. f_equal. ring.
Qed.
Theorem control9_sines n th k w0 K1 :
  w0 + - K1 * g1 n th k = w0 + K1 / INR n * Sum n (fun j => sin (th k - th j)).
Proof.
  rewrite g1_sines. unfold Rdiv.
  rewrite (Sum_ext n (fun j => sin (th k - th j)) (fun j => - sin (th j - th k))).
  - rewrite Sum_opp. ring.
  - intros j _. rewrite <- sin_neg. f_equal. ring.
Qed.
Lemma U1_along n (th : nat -> R -> R) om t : (1 <= n)%nat -> (forall k, (k < n)%nat -> is_derive (th k) t (om k)) ->
  is_derive (fun s => U1 n (fun k => th k s)) t (Sum n (fun k => om k * g1 n (fun k => th k t) k)).
Proof.
  intros Hn H. pose proof (INR_pos n Hn).
  apply (is_derive_ext (fun s => / (2 * INR n) * cos_pairs n (fun _ _ => 1) (fun k => th k s))); [intros; symmetry; now apply U1_pairs|].
  eapply D_eq; [apply D_scal, (D_cos_pairs n (fun _ _ => 1) th om t H)|].
  rewrite <- Sum_scal. apply Sum_ext; intros k _. rewrite g1_sines.
  rewrite (Sum_ext n (fun j => (1 + 1) * _) (fun j => 2 * sin (th j t - th k t))) by (intros; ring).
  rewrite Sum_scal. field. lra.
Qed.
Theorem U1_rate n (th : nat -> R -> R) w0 K1 t : (1 <= n)%nat ->
  (forall k, (k < n)%nat -> is_derive (th k) t (w0 + - K1 * g1 n (fun k => th k t) k)) ->
  is_derive (fun s => U1 n (fun k => th k s)) t (- K1 * Sum n (fun k => g1 n (fun k => th k t) k ^ 2)).
Proof.
  intros Hn H. eapply D_eq; [apply (U1_along n th _ t Hn H)|]. cbv beta.
  set (g := g1 n (fun k => th k t)).
  rewrite (Sum_ext n _ (fun k => w0 * g k + - K1 * g k ^ 2)) by (intros; ring).
  rewrite Sum_plus, !Sum_scal. unfold g. rewrite gradient_orthogonal. ring.
Qed.

(* ---- eq (13) ---- *)
Theorem eq13 n th : (1 <= n)%nat -> W1 n complete th = INR n / 2 - U1 n th.
Proof.
  intros Hn. pose proof (INR_pos n Hn). rewrite W1_arcs. unfold U1. rewrite order_deficit by assumption.
  rewrite (Sum_ext n _ (fun k => Sum n (fun j => 1 - cos (th j - th k)))).
  - set (s := Sum n _). field. lra.
  - intros k _. apply Sum_ext; intros j _. unfold w, complete. destruct (Nat.eqb_spec k j) as [->|]; cbn; [|ring].
    replace (th j - th j) with 0 by ring. rewrite cos_0. ring.
Qed.
Theorem eq13_stationary n th : (1 <= n)%nat -> (stationary n (W1 n complete) th <-> stationary n (U1 n) th).
Proof.
  intros Hn. assert (A : forall f g : (nat -> R) -> R, (forall th, f th = INR n / 2 - g th) -> stationary n g th -> stationary n f th).
  { intros f g E S k Hk. eapply partial_ext; [exact E|]. unfold partial.
    eapply D_eq; [apply D_minus; [apply D_const|apply (S k Hk)]|]. ring. }
  split; apply A; intros th'; rewrite (eq13 n th' Hn); ring.
Qed.

(* ---- the critical points of U_1 that are neither synchronized nor balanced ---- *)
Lemma Sum_upd n th k s (f : R -> R) : (k < n)%nat ->
  Sum n (fun j => f (upd th k s j)) = Sum n (fun j => f (th j)) + (f s - f (th k)).
Proof.
  intros Hk. rewrite <- (Sum_delta n k (fun j => f s - f (th j)) Hk), <- Sum_plus. apply Sum_ext; intros j _.
  unfold upd, delta. destruct (Nat.eqb_spec j k) as [->|]; ring.
Qed.
Lemma Csum_upd n th k s : (k < n)%nat ->
  Csum n (phasors (upd th k s)) = (Csum n (phasors th) + (expi s - expi (th k)))%C.
Proof.
  intros Hk. unfold Csum, phasors, expi, Cplus, Cminus, Copp; cbn [fst snd].
  f_equal; [apply (Sum_upd n th k s cos Hk)|apply (Sum_upd n th k s sin Hk)].
Qed.
Lemma U1_sum n th : (1 <= n)%nat -> U1 n th = / (2 * INR n) * inner (Csum n (phasors th)) (Csum n (phasors th)).
Proof.
  intros Hn. pose proof (INR_pos n Hn). unfold U1. rewrite <- inner_self. unfold order.
  rewrite inner_scal, inner_sym, inner_scal. field. lra.
Qed.
(* values 1 and -1 with a positive sum, not all 1: two of them are 1 *)
Lemma two_ones n f : (forall k, (k < n)%nat -> f k = 1 \/ f k = -1) -> 0 < Sum n f ->
  (exists k, (k < n)%nat /\ f k = -1) -> exists a b, (a < n)%nat /\ (b < n)%nat /\ a <> b /\ f a = 1 /\ f b = 1.
Proof.
  intros V P [k [Hk Ek]]. apply NNPP. intros N.
  assert (Ex : exists a, (a < n)%nat /\ f a = 1).
  { apply NNPP. intros M. assert (Sum n f <= Sum n (fun _ => -1)); [|rewrite Sum_const in H; pose proof (pos_INR n); lra].
    apply Sum_le. intros i Hi. destruct (V i Hi) as [E|E]; [|lra]. exfalso; apply M; now exists i. }
  destruct Ex as [a [Ha Ea]].
  assert (E : Sum n f = 2 + - INR n).
  { rewrite (Sum_ext n f (fun j => delta j a * 2 + -1)).
    - rewrite Sum_plus, (Sum_delta n a (fun _ => 2) Ha), Sum_const. ring.
    - intros j Hj. unfold delta. destruct (Nat.eqb_spec j a) as [->|Hja]; [rewrite Ea; ring|].
      destruct (V j Hj) as [E|E]; [|rewrite E; ring]. exfalso. apply N. now exists a, j; repeat split; auto. }
  assert (2 <= n)%nat by (assert (a <> k) by (intros ->; lra); lia). apply le_INR in H. cbn in H. lra.
Qed.
Lemma cos_small e : 0 < e -> exists d, 0 < d < e /\ 1 / 2 <= cos d < 1.
Proof.
  intros He. pose proof PI_RGT_0. exists (Rmin (e / 2) (PI / 3)).
  assert (0 < Rmin (e / 2) (PI / 3)) by (apply Rmin_glb_lt; lra).
  pose proof (Rmin_l (e / 2) (PI / 3)). pose proof (Rmin_r (e / 2) (PI / 3)). repeat split; try lra.
  - rewrite <- cos_PI3. apply cos_decr_1; lra.
  - assert (L := cos_decreasing_1 0 (Rmin (e / 2) (PI / 3))). rewrite cos_0 in L. apply L; lra.
Qed.

Definition saddle (n : nat) (f : (nat -> R) -> R) (th : nat -> R) :=
  stationary n f th /\ forall e, 0 < e ->
    (exists a, (forall k, (k < n)%nat -> Rabs (a k - th k) < e) /\ f a > f th) /\
    (exists b, (forall k, (k < n)%nat -> Rabs (b k - th k) < e) /\ f b < f th).

(* at such a point every phasor is plus or minus the unit vector z of p_theta *)
Lemma critical_signs n th : (1 <= n)%nat -> stationary n (U1 n) th -> ~ balanced n th ->
  exists (z : C) (c : nat -> R), inner z z = 1 /\ (forall k, (k < n)%nat -> (c k = 1 \/ c k = -1) /\ expi (th k) = (RtoC (c k) * z)%C)
    /\ Csum n (phasors th) = (RtoC (Sum n c) * z)%C /\ 0 < Sum n c.
Proof.
  intros Hn S B. pose proof (INR_pos n Hn) as P. set (p := order n th) in *.
  assert (M : 0 < Cmod p).
  { destruct (Cmod_ge_0 p) as [|E]; [assumption|]. exfalso. apply B. now apply Cmod_eq_0. }
  set (m := Cmod p) in *. pose (z := (RtoC (/ m) * p)%C). pose (c := fun k => inner (expi (th k)) z).
  assert (Z : inner z z = 1).
  { unfold z. rewrite inner_scal, inner_sym, inner_scal, inner_self. fold m. field. lra. }
  assert (G : forall k, (k < n)%nat -> inner (Ci * expi (th k))%C z = 0).
  { intros k Hk. unfold z. rewrite inner_scal.
    replace (inner (Ci * expi (th k))%C p) with (g1 n th k) by reflexivity.
    rewrite (partial_unique _ _ _ _ _ (U1_gradient n th k Hn Hk) (S k Hk)). ring. }
  assert (E : forall k, (k < n)%nat -> (c k = 1 \/ c k = -1) /\ expi (th k) = (RtoC (c k) * z)%C).
  { intros k Hk. specialize (G k Hk). unfold c. rewrite inner_xy in G, Z. rewrite inner_xy.
    destruct z as [x y]; cbn in *. set (u := cos (th k)) in *. set (v := sin (th k)) in *.
    assert (UV : u * u + v * v = 1) by (pose proof (sc2 (th k)); unfold u, v; lra).
    assert (D : u * y = v * x) by lra.
    assert (T : (u * x + v * y) * (u * x + v * y) = 1).
    { replace ((u * x + v * y) * (u * x + v * y)) with ((u * u + v * v) * (x * x + y * y) - (u * y - v * x) * (u * y - v * x)) by ring.
      rewrite UV, Z, D. ring. }
    split.
    - assert ((u * x + v * y - 1) * (u * x + v * y + 1) = 0) by (ring_simplify; ring_simplify in T; lra).
      apply Rmult_integral in H as [H|H]; lra.
    - unfold expi, Cmult, RtoC; cbn. fold u v. f_equal.
      + transitivity (u * (x * x + y * y)); [rewrite Z; ring|]. transitivity (u * x * x + (u * y) * y); [ring|]. rewrite D. ring.
      + transitivity (v * (x * x + y * y)); [rewrite Z; ring|]. transitivity ((v * x) * x + v * y * y); [ring|]. rewrite <- D. ring. }
  assert (CS : Csum n (phasors th) = (RtoC (Sum n c) * z)%C).
  { rewrite (Csum_ext n _ (fun k => z * RtoC (c k))%C).
    - rewrite Csum_scal. replace (Csum n (fun k => RtoC (c k))) with (RtoC (Sum n c)); [apply Cmult_comm|].
      apply injective_projections; [reflexivity|symmetry; apply Sum_0].
    - intros k Hk. unfold phasors. rewrite (proj2 (E k Hk)). apply injective_projections; cbn; ring. }
  assert (SC : Sum n c = INR n * m).
  { transitivity (inner z (Csum n (phasors th))).
    - rewrite CS, inner_scal, Z. ring.
    - replace (Csum n (phasors th)) with (RtoC (INR n) * p)%C.
      + rewrite inner_scal. f_equal. unfold z. rewrite inner_sym, inner_scal, inner_self. fold m. field. lra.
      + unfold p, order. rewrite Cmult_assoc. replace (RtoC (INR n) * RtoC (/ INR n))%C with (RtoC 1); [apply Cmult_1_l|].
        unfold RtoC, Cmult; cbn. f_equal; field; lra. }
  exists z, c. repeat split; try assumption; try (now apply E). rewrite SC. nra.
Qed.

Theorem thm1_saddle n th : (1 <= n)%nat -> stationary n (U1 n) th -> ~ synchronized n th -> ~ balanced n th ->
  (forall j k, (j < n)%nat -> (k < n)%nat -> sin (th k - th j) = 0) /\ saddle n (U1 n) th.
Proof.
  intros Hn S NS NB. pose proof (INR_pos n Hn) as P.
  destruct (critical_signs n th Hn S NB) as [z [c [Z [E [CS SP]]]]]. set (s := Sum n c) in *.
  assert (Neg : exists k, (k < n)%nat /\ c k = -1).
  { apply NNPP. intros N. apply NS. intros j k Hj Hk. rewrite (proj2 (E j Hj)), (proj2 (E k Hk)).
    destruct (proj1 (E j Hj)) as [->|Cj]; [|exfalso; apply N; now exists j].
    destruct (proj1 (E k Hk)) as [->|Ck]; [reflexivity|exfalso; apply N; now exists k]. }
  destruct (two_ones n c (fun k Hk => proj1 (E k Hk)) SP Neg) as [a [b [Ha [Hb [Hab [Ca Cb]]]]]].
  assert (s1 : 1 <= s).
  { (* a positive sum of signs is an integer *)
    assert (I : forall m, (m <= n)%nat -> exists q : BinNums.Z, Sum m c = IZR q).
    { induction m as [|m IH]; intros Hm; [now exists 0%Z|]. destruct IH as [q Hq]; [lia|]. cbn. rewrite Hq.
      destruct (proj1 (E m Hm)) as [->| ->]; [exists (q + 1)%Z|exists (q - 1)%Z]; rewrite ?plus_IZR, ?minus_IZR; lra. }
    destruct (I n (le_n n)) as [q Hq]. fold s in Hq. rewrite Hq in *. apply (IZR_le 1). apply lt_IZR in SP. lia. }
  destruct Neg as [k [Hk Ck]].
  split; [|split; [exact S|]].
  - intros j l Hj Hl. pose proof (inner_iexpi (th j) (th l)) as I. rewrite <- I.
    rewrite (proj2 (E j Hj)), (proj2 (E l Hl)). rewrite inner_xy. cbn. ring.
  - intros e He. destruct (cos_small e He) as [d [Hd Hc]].
    pose proof (sc2 d) as SC. set (C0 := cos d) in *. set (S0 := sin d) in *.
    assert (UZ : U1 n th = / (2 * INR n) * (s * s)).
    { rewrite U1_sum, CS, inner_scal, inner_sym, inner_scal, Z by assumption. ring. }
    assert (F : 0 < / (2 * INR n)) by (apply Rinv_0_lt_compat; lra).
    rewrite inner_xy in Z. split.
    + exists (upd th k (th k + d)). split.
      * intros j Hj. unfold upd. destruct (Nat.eqb_spec j k) as [->|].
        -- replace (th k + d - th k) with d by ring. rewrite Rabs_pos_eq; lra.
        -- replace (th j - th j) with 0 by ring. rewrite Rabs_R0. lra.
      * rewrite UZ, U1_sum, Csum_upd, CS, expi_plus, (proj2 (E k Hk)), Ck by assumption.
        apply Rlt_gt, Rmult_lt_compat_l; [exact F|]. rewrite inner_xy. destruct z as [x y].
        unfold expi; cbn in *. fold C0 S0.
        match goal with |- _ < ?X => replace X with ((x * x + y * y) * ((s + 1 - C0) ^ 2 + S0 ^ 2)) by ring end.
        rewrite Z. nra.
    + exists (upd (upd th a (th a + d)) b (th b - d)). split.
      * intros j Hj. unfold upd. destruct (Nat.eqb_spec j b) as [->|].
        -- replace (th b - d - th b) with (- d) by ring. rewrite Rabs_Ropp, Rabs_pos_eq; lra.
        -- destruct (Nat.eqb_spec j a) as [->|].
           ++ replace (th a + d - th a) with d by ring. rewrite Rabs_pos_eq; lra.
           ++ replace (th j - th j) with 0 by ring. rewrite Rabs_R0. lra.
      * assert (Ub : upd th a (th a + d) b = th b) by (unfold upd; destruct (Nat.eqb_spec b a); congruence).
        rewrite UZ, U1_sum, !Csum_upd, Ub, CS by assumption. replace (th b - d) with (th b + - d) by ring.
        rewrite !expi_plus, (proj2 (E a Ha)), (proj2 (E b Hb)), Ca, Cb.
        apply Rmult_lt_compat_l; [exact F|]. rewrite inner_xy. destruct z as [x y].
        unfold expi; cbn in *. rewrite cos_neg, sin_neg. fold C0 S0.
        match goal with |- ?X < _ => replace X with ((x * x + y * y) * (s - 2 + 2 * C0) ^ 2) by ring end.
        rewrite Z. nra.
Qed.
