(* Lipschitz functions of one number have derivatives but on a set of measure zero.
   After F. Riesz: where g, which grows at rates between 1 and L, has a left rate below c and a right rate above C at points as near as one likes, c < C, the
   point is in an interval of a union on which g grows by at most c times the lengths, and there in one of a union on which it grows by at least C times the
   lengths: the lengths fall by the factor c/C, as often as one likes. The intervals are the components of open sets, counted by the first rational number in
   each, so that countably many covers are given without choice. *)
From Coq Require Import Reals Lra Lia Psatz Classical Arith.Cantor ConstructiveEpsilon ClassicalDedekindReals.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums inclusions tanner2_filippov tanner2_appendix.
Open Scope R_scope.

Definition decide (P : Prop) : {P} + {~ P} := match sig_not_dec P with left h => left (NNPP P h) | right h => right h end.
Definition some_nat (P : nat -> Prop) : nat := match decide (exists n, P n) with
  | left h => proj1_sig (constructive_indefinite_ground_description_nat P (fun n => decide (P n)) h) | right _ => O end.
Lemma some_nat_is P : (exists n, P n) -> P (some_nat P).
Proof. intros H. unfold some_nat. destruct (decide (exists n, P n)) as [h|h]; [exact (proj2_sig (constructive_indefinite_ground_description_nat P (fun n => decide (P n)) h))|contradiction]. Qed.
Lemma first_nat (P : nat -> Prop) : (exists n, P n) -> exists n, P n /\ forall m, (m < n)%nat -> ~ P m.
Proof.
  intros [n H]. revert H. induction n as [n IH] using lt_wf_ind. intros H. destruct (classic (exists m, (m < n)%nat /\ P m)) as [(m & Hm & Pm)|N]; [now apply (IH m)|].
  exists n. split; [exact H|]. intros m Hm Pm. apply N. now exists m.
Qed.

(* ---- components of an open set ---- *)
Definition open_set (U : R -> Prop) := forall x, U x -> exists d, 0 < d /\ forall y, Rabs (y - x) < d -> U y.
Definition joined_in (U : R -> Prop) x y := forall u, Rmin x y <= u <= Rmax x y -> U u.
Definition up_to (U : R -> Prop) x := real (Lub_Rbar (fun y => x <= y /\ joined_in U x y)).
Definition down_to (U : R -> Prop) x := - up_to (fun u => U (- u)) (- x).
Lemma joined_sym U x y : joined_in U x y -> joined_in U y x.
Proof. intros H u Hu. apply H. now rewrite Rmin_comm, Rmax_comm. Qed.
Lemma joined_trans U x y z : joined_in U x y -> joined_in U y z -> joined_in U x z.
Proof.
  intros A B u Hu. destruct (Rle_or_lt (Rmin x y) u) as [L|L]; [destruct (Rle_or_lt u (Rmax x y)) as [G|G]; [now apply A|]|]; apply B;
    unfold Rmin, Rmax in *; destruct (Rle_dec x y), (Rle_dec y z), (Rle_dec x z); lra.
Qed.
Lemma up_to_is U x b : open_set U -> (forall u, U u -> u < b) -> U x -> x < up_to U x /\ up_to U x <= b /\ (forall y, x <= y < up_to U x -> U y) /\ ~ U (up_to U x).
Proof.
  intros O B Ux. set (E := fun y => x <= y /\ joined_in U x y).
  assert (Ex : E x) by (split; [lra|]; intros u Hu; rewrite Rmin_left, Rmax_left in Hu by lra; now replace u with x by lra).
  assert (Bd : forall y, E y -> y <= b) by (intros y [Hy J]; left; apply B, J; rewrite Rmin_left, Rmax_right; lra).
  destruct (lub_is E x b Ex Bd) as [L1 L2]. change (real (Lub_Rbar E)) with (up_to U x) in *. set (m := up_to U x) in *.
  assert (In : forall y, x <= y < m -> U y).
  { intros y Hy. apply NNPP. intros N. assert (m <= y); [|lra]. apply L2. intros e [He J]. apply Rnot_lt_le. intros L. apply N, J. rewrite Rmin_left, Rmax_right by lra. lra. }
  assert (Xm : x < m).
  { destruct (O x Ux) as (d & Hd & Q). assert (x + d / 2 <= m); [|lra]. apply L1. split; [lra|]. intros u Hu. rewrite Rmin_left, Rmax_right in Hu by lra. apply Q. apply Rabs_def1; lra. }
  split; [exact Xm|]. split; [now apply L2|]. split; [exact In|]. intros Um. destruct (O m Um) as (d & Hd & Q). assert (m + d / 2 <= m); [|lra]. apply L1. split; [lra|].
  intros u Hu. rewrite Rmin_left, Rmax_right in Hu by lra. destruct (Rlt_or_le u m); [apply In; lra|]. apply Q. apply Rabs_def1; lra.
Qed.
Lemma down_to_is U x a : open_set U -> (forall u, U u -> a < u) -> U x -> down_to U x < x /\ a <= down_to U x /\ (forall y, down_to U x < y <= x -> U y) /\ ~ U (down_to U x).
Proof.
  intros O B Ux. unfold down_to. destruct (up_to_is (fun u => U (- u)) (- x) (- a)) as (Q1 & Q2 & Q3 & Q4).
  - intros y Uy. destruct (O (- y) Uy) as (d & Hd & Q). exists d. split; [exact Hd|]. intros z Hz. apply Q. rewrite <- Rabs_Ropp. now replace (- (- z - - y)) with (z - y) by ring.
  - intros u Hu. specialize (B _ Hu). lra.
  - now rewrite Ropp_involutive.
  - split; [lra|]. split; [lra|]. split; [|exact Q4]. intros y Hy. rewrite <- (Ropp_involutive y). apply Q3. lra.
Qed.
(* the component with rat k, if no rational number before is in it *)
Definition cell (U : R -> Prop) a k : R * R := if decide (U (rat k) /\ forall j, (j < k)%nat -> ~ joined_in U (rat j) (rat k)) then (down_to U (rat k), up_to U (rat k)) else (a, a).
Section Cells.
Variables (U : R -> Prop) (a b : R).
Hypothesis O : open_set U.
Hypothesis In : forall u, U u -> a < u < b.
Hypothesis Hab : a <= b.
Lemma cell_is k : cell U a k = (a, a) \/ (U (rat k) /\ (forall j, (j < k)%nat -> ~ joined_in U (rat j) (rat k)) /\
  a <= fst (cell U a k) < rat k /\ rat k < snd (cell U a k) <= b /\ (forall y, fst (cell U a k) < y < snd (cell U a k) -> joined_in U (rat k) y) /\ ~ U (fst (cell U a k)) /\ ~ U (snd (cell U a k))).
Proof.
  unfold cell. destruct (decide (U (rat k) /\ forall j, (j < k)%nat -> ~ joined_in U (rat j) (rat k))) as [[Uk F]|N]; [right|now left]. cbn [fst snd].
  destruct (up_to_is U (rat k) b O (fun u Hu => proj2 (In u Hu)) Uk) as (P1 & P2 & P3 & P4). destruct (down_to_is U (rat k) a O (fun u Hu => proj1 (In u Hu)) Uk) as (Q1 & Q2 & Q3 & Q4).
  repeat split; try assumption. intros y Hy u Hu. destruct (Rle_or_lt u (rat k)); [apply Q3|apply P3]; unfold Rmin, Rmax in Hu; destruct (Rle_dec (rat k) y); lra.
Qed.
Lemma cell_within k : a <= fst (cell U a k) <= snd (cell U a k) /\ snd (cell U a k) <= b.
Proof. destruct (cell_is k) as [->|(_ & _ & Q1 & Q2 & _)]; cbn [fst snd]; lra. Qed.
Lemma cell_apart j k : (j < k)%nat -> snd (cell U a j) <= fst (cell U a k) \/ snd (cell U a k) <= fst (cell U a j).
Proof.
  intros Hjk. pose proof (cell_within j) as W1. pose proof (cell_within k) as W2. destruct (cell_is j) as [E|(_ & _ & J1 & J2 & J3 & _)]; [left; rewrite E; cbn; lra|].
  destruct (cell_is k) as [E|(_ & F & K1 & K2 & K3 & _)]; [right; rewrite E; cbn; lra|].
  destruct (Rle_or_lt (snd (cell U a j)) (fst (cell U a k))) as [L|L]; [now left|]. destruct (Rle_or_lt (snd (cell U a k)) (fst (cell U a j))) as [G|G]; [now right|]. exfalso.
  set (y := (Rmax (fst (cell U a j)) (fst (cell U a k)) + Rmin (snd (cell U a j)) (snd (cell U a k))) / 2).
  assert (Y : (fst (cell U a j) < y < snd (cell U a j)) /\ (fst (cell U a k) < y < snd (cell U a k))).
  { unfold y, Rmax, Rmin. destruct (Rle_dec (fst (cell U a j)) (fst (cell U a k))), (Rle_dec (snd (cell U a j)) (snd (cell U a k))); lra. }
  apply (F j Hjk). apply (joined_trans U _ y); [now apply J3|]. apply joined_sym. now apply K3.
Qed.
Lemma cell_covers x : U x -> exists k, fst (cell U a k) < x < snd (cell U a k).
Proof.
  intros Ux. destruct (first_nat (fun k => joined_in U (rat k) x)) as (k & Jk & F).
  { destruct (O x Ux) as (d & Hd & Q). destruct (rat_dense x d Hd) as [c Hc]. exists c. intros u Hu. apply Q. apply Rabs_def2 in Hc. apply Rabs_def1; unfold Rmin, Rmax in Hu; destruct (Rle_dec (rat c) x); lra. }
  exists k. assert (Uk : U (rat k)) by (apply Jk; unfold Rmin, Rmax; destruct (Rle_dec (rat k) x); lra).
  unfold cell. destruct (decide (U (rat k) /\ forall j, (j < k)%nat -> ~ joined_in U (rat j) (rat k))) as [_|N].
  2:{ exfalso. apply N. split; [exact Uk|]. intros j Hj J. apply (F j Hj). now apply (joined_trans U _ (rat k)). }
  cbn [fst snd]. destruct (up_to_is U (rat k) b O (fun u Hu => proj2 (In u Hu)) Uk) as (P1 & P2 & P3 & P4). destruct (down_to_is U (rat k) a O (fun u Hu => proj1 (In u Hu)) Uk) as (Q1 & Q2 & Q3 & Q4).
  split; apply Rnot_le_lt; intros L.
  - apply Q4, Jk. unfold Rmin, Rmax. destruct (Rle_dec (rat k) x); lra.
  - apply P4, Jk. unfold Rmin, Rmax. destruct (Rle_dec (rat k) x); lra.
Qed.
End Cells.

(* ---- sums over intervals apart ---- *)
Lemma apart_sum (phi : R -> R) : (forall x y, x <= y -> phi x <= phi y) -> forall m (p q : nat -> R) a b, a <= b -> (forall k, (k < m)%nat -> a <= p k <= q k /\ q k <= b) ->
  (forall j k, (j < k)%nat -> (k < m)%nat -> q j <= p k \/ q k <= p j) -> Sum m (fun k => phi (q k) - phi (p k)) <= phi b - phi a.
Proof.
  intros Mo. induction m as [|m IH]; intros p q a b Hab I A; cbn [Sum]; [specialize (Mo a b Hab); lra|]. destruct (I m ltac:(lia)) as [I1 I2].
  assert (E : Sum m (fun k => phi (q k) - phi (p k)) = Sum m (fun k => phi (Rmin (q k) (p m)) - phi (Rmin (p k) (p m))) + Sum m (fun k => phi (Rmax (q k) (q m)) - phi (Rmax (p k) (q m)))).
  { rewrite <- Sum_plus. apply Sum_ext. intros k Hk. destruct (I k ltac:(lia)) as [K1 K2]. destruct (A k m Hk ltac:(lia)) as [L|L].
    - rewrite (Rmin_left (q k)), (Rmin_left (p k)), (Rmax_right (q k)), (Rmax_right (p k)) by lra. ring.
    - rewrite (Rmin_right (q k)), (Rmin_right (p k)), (Rmax_left (q k)), (Rmax_left (p k)) by lra. ring. }
  rewrite E. pose proof (IH (fun k => Rmin (p k) (p m)) (fun k => Rmin (q k) (p m)) a (p m)) as H1. pose proof (IH (fun k => Rmax (p k) (q m)) (fun k => Rmax (q k) (q m)) (q m) b) as H2. cbv beta in H1, H2.
  assert (X : forall x y z, x <= y -> Rmin x z <= Rmin y z /\ Rmax x z <= Rmax y z) by (intros x y z H; split; unfold Rmin, Rmax; destruct (Rle_dec x z), (Rle_dec y z); lra).
  specialize (H1 ltac:(lra)). specialize (H2 ltac:(lra)).
  assert (G1 : Sum m (fun k => phi (Rmin (q k) (p m)) - phi (Rmin (p k) (p m))) <= phi (p m) - phi a).
  { apply H1.
    - intros k Hk. destruct (I k ltac:(lia)) as [K1 K2]. split; [|apply Rmin_r]. split; [apply Rmin_glb; lra|apply X; lra].
    - intros j k Hj Hk. destruct (A j k Hj ltac:(lia)) as [L|L]; [left|right]; now apply X. }
  assert (G2 : Sum m (fun k => phi (Rmax (q k) (q m)) - phi (Rmax (p k) (q m))) <= phi b - phi (q m)).
  { apply H2.
    - intros k Hk. destruct (I k ltac:(lia)) as [K1 K2]. split; [|apply Rmax_lub; lra]. split; [apply Rmax_r|apply X; lra].
    - intros j k Hj Hk. destruct (A j k Hj ltac:(lia)) as [L|L]; [left|right]; now apply X. }
  lra.
Qed.
Lemma code_sum (x : nat -> nat -> R) (y : nat -> R) Z : (forall j k, 0 <= x j k) -> (forall j m, Sum m (x j) <= y j) -> (forall m, Sum m y <= Z) ->
  forall m, Sum m (fun n => x (fst (of_nat n)) (snd (of_nat n))) <= Z.
Proof.
  intros X0 Xy Yz m. apply Rle_trans with (Sum m (fun j => Sum m (x j))); [|eapply Rle_trans; [apply Sum_le; intros j _; apply Xy|apply Yz]].
  apply Rle_trans with (Sum m (fun n => Sum m (fun j => Sum m (fun k => delta n (to_nat (j, k)) * x j k)))).
  - apply Sum_le. intros n Hn. destruct (of_nat n) as [j k] eqn:E. cbn [fst snd]. assert (En : to_nat (j, k) = n) by (rewrite <- E; apply cancel_to_of).
    assert (Hb : (j < m)%nat /\ (k < m)%nat) by (pose proof (to_nat_non_decreasing j k); lia). destruct Hb as [Hj Hk].
    assert (D0 : forall i l, 0 <= delta n (to_nat (i, l)) * x i l) by (intros i l; apply Rmult_le_pos; [unfold delta; destruct (Nat.eqb n (to_nat (i, l))); lra|apply X0]).
    apply Rle_trans with (Sum m (fun k => delta n (to_nat (j, k)) * x j k)).
    + pose proof (Sum_term_le m (fun k => delta n (to_nat (j, k)) * x j k) k (fun l _ => D0 j l) Hk) as Q. cbv beta in Q. rewrite En, delta_eq, Rmult_1_l in Q. exact Q.
    + exact (Sum_term_le m (fun j => Sum m (fun k => delta n (to_nat (j, k)) * x j k)) j (fun i _ => Sum_ge0 m _ (fun l _ => D0 i l)) Hj).
  - rewrite Sum_swap. apply Sum_le. intros j Hj. rewrite Sum_swap. apply Sum_le. intros k Hk. rewrite Sum_scal_r. rewrite <- (Rmult_1_l (x j k)) at 2. apply Rmult_le_compat_r; [apply X0|].
    destruct (Nat.lt_ge_cases (to_nat (j, k)) m) as [L|L].
    + right. rewrite (Sum_ext m _ (fun n => delta n (to_nat (j, k)) * 1)) by (intros; ring). now apply (Sum_delta m (to_nat (j, k)) (fun _ => 1)).
    + rewrite Sum_zero; [lra|]. intros n Hn. apply delta_neq. lia.
Qed.

(* ---- points with a higher one to the right, or to the left ---- *)
Definition shadow (h : R -> R) a b x := a < x < b /\ exists y, x < y < b /\ h x < h y.
Definition shadow_left (h : R -> R) a b x := a < x < b /\ exists y, a < y < x /\ h x < h y.
Lemma near_value (h : R -> R) x e : continuity_pt h x -> 0 < e -> exists d, 0 < d /\ forall u, Rabs (u - x) < d -> Rabs (h u - h x) < e.
Proof.
  intros C He. destruct (C e He) as (d & Hd & Q). exists d. split; [exact Hd|]. intros u Hu. destruct (Req_dec u x) as [->|N]; [rewrite Rminus_eq_0, Rabs_R0; exact He|].
  apply Q. split; [split; [exact I|congruence]|exact Hu].
Qed.
Lemma shadow_open h a b : (forall x, continuity_pt h x) -> open_set (shadow h a b).
Proof.
  intros C x (Hx & y & Hy & L). destruct (near_value h x (h y - h x) (C x) ltac:(lra)) as (d & Hd & Q). exists (Rmin d (Rmin (x - a) (y - x))). pose proof (Rmin_l d (Rmin (x - a) (y - x))). pose proof (Rmin_r d (Rmin (x - a) (y - x))).
  pose proof (Rmin_l (x - a) (y - x)). pose proof (Rmin_r (x - a) (y - x)). split; [repeat apply Rmin_glb_lt; lra|]. intros u Hu. specialize (Q u ltac:(lra)). apply Rabs_def2 in Hu. apply Rabs_def2 in Q.
  split; [lra|]. exists y. lra.
Qed.
Lemma shadow_left_open h a b : (forall x, continuity_pt h x) -> open_set (shadow_left h a b).
Proof.
  intros C x (Hx & y & Hy & L). destruct (near_value h x (h y - h x) (C x) ltac:(lra)) as (d & Hd & Q). exists (Rmin d (Rmin (b - x) (x - y))). pose proof (Rmin_l d (Rmin (b - x) (x - y))). pose proof (Rmin_r d (Rmin (b - x) (x - y))).
  pose proof (Rmin_l (b - x) (x - y)). pose proof (Rmin_r (b - x) (x - y)). split; [repeat apply Rmin_glb_lt; lra|]. intros u Hu. specialize (Q u ltac:(lra)). apply Rabs_def2 in Hu. apply Rabs_def2 in Q.
  split; [lra|]. exists y. lra.
Qed.
Lemma shadow_rises h a b p q : (forall x, continuity_pt h x) -> a <= p -> p < q -> q <= b -> (forall y, p < y < q -> shadow h a b y) -> ~ shadow h a b q -> h p <= h q.
Proof.
  intros C Ha Hpq Hb In Nq. apply Rnot_lt_le. intros L. destruct (near_value h p (h p - h q) (C p) ltac:(lra)) as (d & Hd & Q).
  set (x := p + Rmin (d / 2) ((q - p) / 2)). pose proof (Rmin_l (d / 2) ((q - p) / 2)). pose proof (Rmin_r (d / 2) ((q - p) / 2)). assert (0 < Rmin (d / 2) ((q - p) / 2)) by (apply Rmin_glb_lt; lra).
  specialize (Q x ltac:(apply Rabs_def1; unfold x; lra)). apply Rabs_def2 in Q. destruct (continuity_ab_maj h x q ltac:(unfold x; lra) (fun c _ => C c)) as (m & Mx & Hm).
  pose proof (Mx x ltac:(unfold x in *; lra)) as Mxx. assert (m <> q) by (intros ->; lra). destruct (In m ltac:(unfold x in *; lra)) as (_ & y & Hy & Ly).
  destruct (Rle_or_lt y q) as [G|G]; [specialize (Mx y ltac:(unfold x in *; lra)); lra|]. apply Nq. split; [lra|]. exists y. lra.
Qed.
Lemma shadow_left_falls h a b p q : (forall x, continuity_pt h x) -> a <= p -> p < q -> q <= b -> (forall y, p < y < q -> shadow_left h a b y) -> ~ shadow_left h a b p -> h q <= h p.
Proof.
  intros C Ha Hpq Hb In Np. apply Rnot_lt_le. intros L. destruct (near_value h q (h q - h p) (C q) ltac:(lra)) as (d & Hd & Q).
  set (x := q - Rmin (d / 2) ((q - p) / 2)). pose proof (Rmin_l (d / 2) ((q - p) / 2)). pose proof (Rmin_r (d / 2) ((q - p) / 2)). assert (0 < Rmin (d / 2) ((q - p) / 2)) by (apply Rmin_glb_lt; lra).
  specialize (Q x ltac:(apply Rabs_def1; unfold x; lra)). apply Rabs_def2 in Q. destruct (continuity_ab_maj h p x ltac:(unfold x; lra) (fun c _ => C c)) as (m & Mx & Hm).
  pose proof (Mx x ltac:(unfold x in *; lra)) as Mxx. assert (m <> p) by (intros ->; lra). destruct (In m ltac:(unfold x in *; lra)) as (_ & y & Hy & Ly).
  destruct (Rle_or_lt p y) as [G|G]; [specialize (Mx y ltac:(unfold x in *; lra)); lra|]. apply Np. split; [lra|]. exists y. lra.
Qed.

(* ---- left rates below c and right rates above C ---- *)
Section Rates.
Variable g : R -> R.
Hypothesis Cg : forall x, continuity_pt g x.
Hypothesis Mg : forall x y, x <= y -> g x <= g y.
Definition split_rates c C x := (forall d, 0 < d -> exists y, x - d < y < x /\ g x - g y < c * (x - y)) /\ (forall d, 0 < d -> exists y, x < y < x + d /\ C * (y - x) < g y - g x).
Lemma tilted_continuous c x : continuity_pt (fun t => g t - c * t) x.
Proof. apply continuity_pt_minus; [apply Cg|]. apply continuity_pt_scal, derivable_continuous_pt, derivable_pt_id. Qed.
Section Cover.
Variables c C : R.
Hypothesis Hc : 0 <= c < C.
Definition slow_cell a b k := cell (shadow_left (fun t => g t - c * t) a b) a k.
Definition fast_cell a b k := cell (shadow (fun t => g t - C * t) a b) a k.
Lemma slow_in a b k : a <= b -> a <= fst (slow_cell a b k) <= snd (slow_cell a b k) /\ snd (slow_cell a b k) <= b.
Proof. intros Hab. apply cell_within; [apply shadow_left_open; intros; apply tilted_continuous|intros u [H _]; exact H|exact Hab]. Qed.
Lemma fast_in a b k : a <= b -> a <= fst (fast_cell a b k) <= snd (fast_cell a b k) /\ snd (fast_cell a b k) <= b.
Proof. intros Hab. apply cell_within; [apply shadow_open; intros; apply tilted_continuous|intros u [H _]; exact H|exact Hab]. Qed.
Lemma slow_gain a b k : a <= b -> g (snd (slow_cell a b k)) - g (fst (slow_cell a b k)) <= c * (snd (slow_cell a b k) - fst (slow_cell a b k)).
Proof.
  intros Hab. unfold slow_cell. set (U := shadow_left (fun t => g t - c * t) a b). destruct (cell_is U a b (shadow_left_open _ a b (tilted_continuous c)) (fun u H => proj1 H) k) as [->|(_ & _ & Q1 & Q2 & Q3 & Q4 & Q5)]; [cbn; lra|].
  pose proof (shadow_left_falls (fun t => g t - c * t) a b (fst (cell U a k)) (snd (cell U a k)) (tilted_continuous c) ltac:(lra) ltac:(lra) ltac:(lra)) as F. cbv beta in F.
  specialize (F (fun y Hy => Q3 y Hy y ltac:(unfold Rmin, Rmax; destruct (Rle_dec (rat k) y); lra)) Q4). lra.
Qed.
Lemma fast_gain a b k : a <= b -> C * (snd (fast_cell a b k) - fst (fast_cell a b k)) <= g (snd (fast_cell a b k)) - g (fst (fast_cell a b k)).
Proof.
  intros Hab. unfold fast_cell. set (U := shadow (fun t => g t - C * t) a b). destruct (cell_is U a b (shadow_open _ a b (tilted_continuous C)) (fun u H => proj1 H) k) as [->|(_ & _ & Q1 & Q2 & Q3 & Q4 & Q5)]; [cbn; lra|].
  pose proof (shadow_rises (fun t => g t - C * t) a b (fst (cell U a k)) (snd (cell U a k)) (tilted_continuous C) ltac:(lra) ltac:(lra) ltac:(lra)) as F. cbv beta in F.
  specialize (F (fun y Hy => Q3 y Hy y ltac:(unfold Rmin, Rmax; destruct (Rle_dec (rat k) y); lra)) Q5). lra.
Qed.
Lemma slow_sum a b m : a <= b -> Sum m (fun k => g (snd (slow_cell a b k)) - g (fst (slow_cell a b k))) <= c * (b - a).
Proof.
  intros Hab. eapply Rle_trans; [apply Sum_le; intros k _; now apply slow_gain|]. rewrite Sum_scal. apply Rmult_le_compat_l; [lra|].
  apply (apart_sum (fun x => x) ltac:(intros; lra) m (fun k => fst (slow_cell a b k)) (fun k => snd (slow_cell a b k)) a b Hab); [intros; now apply slow_in|].
  intros j k Hj _. apply (cell_apart _ a b); [apply shadow_left_open; intros; apply tilted_continuous|intros u [H _]; exact H|exact Hab|exact Hj].
Qed.
Lemma fast_sum a b m : a <= b -> Sum m (fun k => snd (fast_cell a b k) - fst (fast_cell a b k)) <= (g b - g a) / C.
Proof.
  intros Hab. apply Rmult_le_reg_l with C; [lra|]. replace (C * ((g b - g a) / C)) with (g b - g a) by (field; lra). rewrite <- Sum_scal. eapply Rle_trans; [apply Sum_le; intros k _; now apply fast_gain|].
  apply (apart_sum g Mg m (fun k => fst (fast_cell a b k)) (fun k => snd (fast_cell a b k)) a b Hab); [intros; now apply fast_in|].
  intros j k Hj _. apply (cell_apart _ a b); [apply shadow_open; intros; apply tilted_continuous|intros u [H _]; exact H|exact Hab|exact Hj].
Qed.
Definition next_cell a b n := let s := slow_cell a b (fst (of_nat n)) in fast_cell (fst s) (snd s) (snd (of_nat n)).
Lemma next_in a b n : a <= b -> a <= fst (next_cell a b n) <= snd (next_cell a b n) /\ snd (next_cell a b n) <= b.
Proof. intros Hab. unfold next_cell. pose proof (slow_in a b (fst (of_nat n)) Hab) as S. set (s := slow_cell a b (fst (of_nat n))) in *. pose proof (fast_in (fst s) (snd s) (snd (of_nat n)) ltac:(lra)). lra. Qed.
Lemma next_sum a b m : a <= b -> Sum m (fun n => snd (next_cell a b n) - fst (next_cell a b n)) <= c / C * (b - a).
Proof.
  intros Hab. apply (code_sum (fun j k => snd (fast_cell (fst (slow_cell a b j)) (snd (slow_cell a b j)) k) - fst (fast_cell (fst (slow_cell a b j)) (snd (slow_cell a b j)) k))
    (fun j => (g (snd (slow_cell a b j)) - g (fst (slow_cell a b j))) / C)).
  - intros j k. pose proof (slow_in a b j Hab). pose proof (fast_in (fst (slow_cell a b j)) (snd (slow_cell a b j)) k ltac:(lra)). lra.
  - intros j n. apply fast_sum. pose proof (slow_in a b j Hab). lra.
  - intros n. unfold Rdiv. rewrite Sum_scal_r. replace (c * / C * (b - a)) with (c * (b - a) * / C) by ring. apply Rmult_le_compat_r; [left; apply Rinv_0_lt_compat; lra|]. now apply slow_sum.
Qed.
Fixpoint cover_cell i a b n : R * R := match i with O => if Nat.eqb n 0 then (a, b) else (a, a) | S i =>
  let s := next_cell a b (fst (of_nat n)) in cover_cell i (fst s) (snd s) (snd (of_nat n)) end.
Lemma cover_in i : forall a b n, a <= b -> fst (cover_cell i a b n) <= snd (cover_cell i a b n).
Proof.
  induction i as [|i IH]; intros a b n Hab; cbn [cover_cell]; [destruct (Nat.eqb n 0); cbn; lra|]. apply IH. pose proof (next_in a b (fst (of_nat n)) Hab). lra.
Qed.
Lemma cover_sum i : forall a b m, a <= b -> Sum m (fun n => snd (cover_cell i a b n) - fst (cover_cell i a b n)) <= (c / C) ^ i * (b - a).
Proof.
  assert (Hr : 0 <= c / C) by (apply Rdiv_le_0_compat; lra).
  induction i as [|i IH]; intros a b m Hab.
  - rewrite pow_O, Rmult_1_l. destruct m as [|m]; [cbn; lra|]. rewrite (Sum_ext (S m) _ (fun n => delta n 0 * (b - a))).
    + rewrite (Sum_delta (S m) 0 (fun _ => b - a)) by lia. lra.
    + intros n _. cbn [cover_cell]. unfold delta. destruct (Nat.eqb n 0); cbn [fst snd]; ring.
  - apply (code_sum (fun j k => snd (cover_cell i (fst (next_cell a b j)) (snd (next_cell a b j)) k) - fst (cover_cell i (fst (next_cell a b j)) (snd (next_cell a b j)) k))
      (fun j => (c / C) ^ i * (snd (next_cell a b j) - fst (next_cell a b j)))).
    + intros j k. pose proof (next_in a b j Hab). pose proof (cover_in i (fst (next_cell a b j)) (snd (next_cell a b j)) k ltac:(lra)). lra.
    + intros j n. apply IH. pose proof (next_in a b j Hab). lra.
    + intros n. rewrite Sum_scal. cbn [pow]. replace (c / C * (c / C) ^ i * (b - a)) with ((c / C) ^ i * (c / C * (b - a))) by ring. apply Rmult_le_compat_l; [now apply pow_le|]. now apply next_sum.
Qed.
Lemma cover_covers x : split_rates c C x -> forall i a b, a < x < b -> exists n, fst (cover_cell i a b n) < x < snd (cover_cell i a b n).
Proof.
  intros [Sl Sr]. induction i as [|i IH]; intros a b Hx; [exists 0%nat; exact Hx|].
  assert (U1 : shadow_left (fun t => g t - c * t) a b x) by (split; [exact Hx|]; destruct (Sl (x - a) ltac:(lra)) as (y & Hy & L); exists y; lra).
  destruct (cell_covers _ a b (shadow_left_open _ a b (tilted_continuous c)) (fun u H => proj1 H) x U1) as [j Hj]. fold (slow_cell a b j) in Hj. set (s := slow_cell a b j) in *.
  assert (U2 : shadow (fun t => g t - C * t) (fst s) (snd s) x) by (split; [exact Hj|]; destruct (Sr (snd s - x) ltac:(lra)) as (y & Hy & L); exists y; lra).
  destruct (cell_covers _ (fst s) (snd s) (shadow_open _ (fst s) (snd s) (tilted_continuous C)) (fun u H => proj1 H) x U2) as [k Hk]. fold (fast_cell (fst s) (snd s) k) in Hk.
  destruct (IH (fst (fast_cell (fst s) (snd s) k)) (snd (fast_cell (fst s) (snd s) k)) Hk) as [n Hn].
  exists (to_nat (to_nat (j, k), n)). cbn [cover_cell]. rewrite cancel_of_to. cbn [fst snd]. unfold next_cell. rewrite cancel_of_to. cbn [fst snd]. exact Hn.
Qed.
End Cover.
Lemma split_negligible : negligible (fun x => exists i j, 0 <= rat i < rat j /\ split_rates (rat i) (rat j) x).
Proof.
  intros e He. set (small := fun k : nat => e / 2 * (/ 2) ^ k). assert (Hs : forall k, 0 < small k) by (intros k; unfold small; apply Rmult_lt_0_compat; [lra|apply pow_lt; lra]).
  set (cov := fun k n => let i := fst (of_nat k) in let j := fst (of_nat (snd (of_nat k))) in let T := INR (snd (of_nat (snd (of_nat k)))) in
    if decide (0 <= rat i < rat j) then cover_cell (rat i) (rat j) (some_nat (fun N => (rat i / rat j) ^ N * (2 * T) <= small k)) (- T) T n else (0, 0)).
  assert (In : forall k n, fst (cov k n) <= snd (cov k n)).
  { intros k n. unfold cov. set (i := fst (of_nat k)). set (j := fst (of_nat (snd (of_nat k)))). set (T := INR (snd (of_nat (snd (of_nat k))))). assert (T0 : 0 <= T) by apply pos_INR.
    destruct (decide (0 <= rat i < rat j)) as [D|_]; [|cbn; lra]. apply cover_in; lra. }
  assert (Sm : forall k m, Sum m (fun n => snd (cov k n) - fst (cov k n)) <= small k).
  { intros k m. unfold cov. set (i := fst (of_nat k)). set (j := fst (of_nat (snd (of_nat k)))). set (T := INR (snd (of_nat (snd (of_nat k))))). assert (T0 : 0 <= T) by apply pos_INR.
    destruct (decide (0 <= rat i < rat j)) as [D|_]; [|rewrite Sum_zero; [left; apply Hs|intros; cbn; lra]].
    eapply Rle_trans; [apply cover_sum; [exact D|lra]|]. replace (T - - T) with (2 * T) by ring. apply (some_nat_is (fun N => (rat i / rat j) ^ N * (2 * T) <= small k)).
    assert (R1 : Rabs (rat i / rat j) < 1). { rewrite Rabs_pos_eq by (apply Rdiv_le_0_compat; lra). apply Rmult_lt_reg_r with (rat j); [lra|]. replace (rat i / rat j * rat j) with (rat i) by (field; lra). lra. }
    destruct (pow_lt_1_zero _ R1 (small k / (2 * T + 1))) as [N Q]; [apply Rdiv_lt_0_compat; [apply Hs|lra]|]. exists N. specialize (Q N (Nat.le_refl N)). apply Rabs_def2 in Q. specialize (Hs k).
    apply Rle_trans with (small k / (2 * T + 1) * (2 * T)); [apply Rmult_le_compat_r; lra|]. apply Rmult_le_reg_r with (2 * T + 1); [lra|]. replace (small k / (2 * T + 1) * (2 * T) * (2 * T + 1)) with (small k * (2 * T)) by (field; lra). apply Rmult_le_compat_l; lra. }
  exists (fun n => fst (cov (fst (of_nat n)) (snd (of_nat n)))), (fun n => snd (cov (fst (of_nat n)) (snd (of_nat n)))). split; [intros; apply In|]. split.
  - intros x (i & j & D & S). destruct (nfloor_ex (Rabs x) (Rabs_pos x)) as [t Ht]. set (k := to_nat (i, to_nat (j, Datatypes.S t))). assert (Hx : - INR (Datatypes.S t) < x < INR (Datatypes.S t)) by (rewrite S_INR; destruct Ht as [_ Ht]; apply Rabs_def2 in Ht; lra).
    destruct (cover_covers (rat i) (rat j) x S (some_nat (fun N => (rat i / rat j) ^ N * (2 * INR (Datatypes.S t)) <= small k)) (- INR (Datatypes.S t)) (INR (Datatypes.S t)) Hx) as [n Hn].
    exists (to_nat (k, n)). rewrite cancel_of_to. cbn [fst snd]. assert (E : of_nat k = (i, to_nat (j, Datatypes.S t))) by apply cancel_of_to.
    unfold cov. rewrite E. cbn [fst snd]. rewrite cancel_of_to. cbn [fst snd]. destruct (decide (0 <= rat i < rat j)) as [_|N]; [exact Hn|contradiction].
  - apply (code_sum (fun k n => snd (cov k n) - fst (cov k n)) small); [intros k n; specialize (In k n); lra|exact Sm|]. intros m. unfold small.
    assert (G : Sum m (fun k => e / 2 * (/ 2) ^ k) = e * (1 - (/ 2) ^ m)) by (induction m as [|m IH]; cbn [Sum pow]; [ring|]; rewrite IH; field).
    rewrite G. assert (0 < (/ 2) ^ m) by (apply pow_lt; lra). nra.
Qed.
End Rates.

(* ---- where neither of the two ways round has rates apart there is a derivative ---- *)
Definition turned (g : R -> R) (t : R) := - g (- t).
Lemma has_derivative g L x : (forall s t, s < t -> 1 * (t - s) <= g t - g s <= L * (t - s)) ->
  (forall i j, 0 <= rat i < rat j -> ~ split_rates g (rat i) (rat j) x /\ ~ split_rates (turned g) (rat i) (rat j) (- x)) -> exists l, is_derive g x l.
Proof.
  intros Sl No. set (E := fun c => exists d, 0 < d /\ forall y, x - d < y < x -> c * (x - y) <= g x - g y).
  destruct (completeness E) as [l [Up Le]].
  { exists L. intros c (d & Hd & Q). specialize (Q (x - d / 2) ltac:(lra)). pose proof (Sl (x - d / 2) x ltac:(lra)) as S. replace (x - (x - d / 2)) with (d / 2) in * by ring. assert (c * (d / 2) <= L * (d / 2)) by lra. apply Rmult_le_reg_r with (d / 2); lra. }
  { exists 1. exists 1. split; [lra|]. intros y Hy. now apply Sl. }
  assert (l1 : 1 <= l) by (apply Up; exists 1; split; [lra|]; intros y Hy; now apply Sl).
  assert (Rat : forall a b, a < b -> exists i, a < rat i < b).
  { intros a b Hab. destruct (rat_dense ((a + b) / 2) ((b - a) / 2) ltac:(lra)) as [i Hi]. apply Rabs_def2 in Hi. exists i. lra. }
  (* left rates from below *)
  assert (F1 : forall c, c < l -> E c).
  { intros c Hcl. apply NNPP. intros N. assert (l <= c); [|lra]. apply Le. intros c' (d & Hd & Q). apply Rnot_lt_le. intros G. apply N. exists d. split; [exact Hd|]. intros y Hy. specialize (Q y Hy). assert (c * (x - y) <= c' * (x - y)) by (apply Rmult_le_compat_r; lra). lra. }
  (* right rates from above *)
  assert (F2 : forall C, l < C -> exists d, 0 < d /\ forall y, x < y < x + d -> g y - g x <= C * (y - x)).
  { intros C HC. destruct (Rat l C HC) as [i Hi]. destruct (Rat (rat i) C ltac:(lra)) as [j Hj]. destruct (No i j ltac:(lra)) as [N _]. apply NNPP. intros M. apply N. split.
    - intros d Hd. apply NNPP. intros K. assert (rat i <= l); [|lra]. apply Up. exists d. split; [exact Hd|]. intros y Hy. apply Rnot_lt_le. intros G. apply K. now exists y.
    - intros d Hd. apply NNPP. intros K. apply M. exists d. split; [exact Hd|]. intros y Hy. apply Rnot_lt_le. intros G. apply K. exists y. split; [exact Hy|].
      assert (rat j * (y - x) <= C * (y - x)) by (apply Rmult_le_compat_r; lra). lra. }
  (* the other way round *)
  assert (Alt : forall i j, 0 <= rat i < rat j -> (exists d, 0 < d /\ forall y, x < y < x + d -> rat i * (y - x) <= g y - g x) \/ (exists d, 0 < d /\ forall y, x - d < y < x -> g x - g y <= rat j * (x - y))).
  { intros i j D. destruct (No i j D) as [_ N]. apply NNPP. intros M. apply N. unfold turned. split.
    - intros d Hd. apply NNPP. intros K. apply M. left. exists d. split; [exact Hd|]. intros y Hy. apply Rnot_lt_le. intros G. apply K. exists (- y). split; [lra|]. rewrite !Ropp_involutive. replace (- x - - y) with (y - x) by ring. lra.
    - intros d Hd. apply NNPP. intros K. apply M. right. exists d. split; [exact Hd|]. intros y Hy. apply Rnot_lt_le. intros G. apply K. exists (- y). split; [lra|]. rewrite !Ropp_involutive. replace (- y - - x) with (x - y) by ring. lra. }
  assert (F3 : forall c, c < l -> exists d, 0 < d /\ forall y, x < y < x + d -> c * (y - x) <= g y - g x).
  { intros c Hcl. destruct (Rat (Rmax c (1 / 2)) l) as [i Hi]; [apply Rmax_lub_lt; lra|]. pose proof (Rmax_l c (1 / 2)). pose proof (Rmax_r c (1 / 2)). destruct (Rat (rat i) l ltac:(lra)) as [j Hj].
    destruct (Alt i j ltac:(lra)) as [(d & Hd & Q)|(d & Hd & Q)].
    - exists d. split; [exact Hd|]. intros y Hy. specialize (Q y Hy). assert (c * (y - x) <= rat i * (y - x)) by (apply Rmult_le_compat_r; lra). lra.
    - exfalso. destruct (F1 ((rat j + l) / 2) ltac:(lra)) as (d' & Hd' & Q'). pose proof (Rmin_l d d'). pose proof (Rmin_r d d'). assert (0 < Rmin d d') by (now apply Rmin_glb_lt). set (y := x - Rmin d d' / 2) in *.
      specialize (Q y ltac:(unfold y; lra)). specialize (Q' y ltac:(unfold y; lra)). assert (0 < x - y) by (unfold y; lra). nra. }
  assert (F4 : forall C, l < C -> exists d, 0 < d /\ forall y, x - d < y < x -> g x - g y <= C * (x - y)).
  { intros C HC. destruct (Rat l C HC) as [i Hi]. destruct (Rat (rat i) C ltac:(lra)) as [j Hj]. destruct (Alt i j ltac:(lra)) as [(d & Hd & Q)|(d & Hd & Q)].
    - exfalso. destruct (F2 ((rat i + l) / 2) ltac:(lra)) as (d' & Hd' & Q'). pose proof (Rmin_l d d'). pose proof (Rmin_r d d'). assert (0 < Rmin d d') by (now apply Rmin_glb_lt). set (y := x + Rmin d d' / 2) in *.
      specialize (Q y ltac:(unfold y; lra)). specialize (Q' y ltac:(unfold y; lra)). assert (0 < y - x) by (unfold y; lra). nra.
    - exists d. split; [exact Hd|]. intros y Hy. specialize (Q y Hy). assert (rat j * (x - y) <= C * (x - y)) by (apply Rmult_le_compat_r; lra). lra. }
  exists l. apply rates_derivative.
  - intros e He. destruct (F2 (l + e / 2) ltac:(lra)) as (d & Hd & Q). destruct (F3 (l - e / 2) ltac:(lra)) as (d' & Hd' & Q'). exists (Rmin d d'). pose proof (Rmin_l d d'). pose proof (Rmin_r d d'). split; [now apply Rmin_glb_lt|]. intros h Hh.
    specialize (Q (x + h) ltac:(lra)). specialize (Q' (x + h) ltac:(lra)). replace (x + h - x) with h in * by ring. rewrite Rmult_1_l. set (D := g (x + h) - g x) in *.
    assert (W : D / h * h = D) by (field; lra). assert (eh : 0 < e * h) by (apply Rmult_lt_0_compat; lra). apply Rabs_def1; apply Rmult_lt_reg_r with h; try lra; rewrite Rmult_minus_distr_r, W; lra.
  - intros e He. destruct (F4 (l + e / 2) ltac:(lra)) as (d & Hd & Q). destruct (F1 (l - e / 2) ltac:(lra)) as (d' & Hd' & Q'). exists (Rmin d d'). pose proof (Rmin_l d d'). pose proof (Rmin_r d d'). split; [now apply Rmin_glb_lt|]. intros h Hh.
    specialize (Q (x - h) ltac:(lra)). specialize (Q' (x - h) ltac:(lra)). replace (x - (x - h)) with h in * by ring. replace (x + -1 * h) with (x - h) by ring. set (D := g (x - h) - g x). assert (Q1 : - D <= (l + e / 2) * h) by (unfold D; lra). assert (Q2 : (l - e / 2) * h <= - D) by (unfold D; lra).
    assert (W : D / h * h = D) by (field; lra). assert (eh : 0 < e * h) by (apply Rmult_lt_0_compat; lra). apply Rabs_def1; apply Rmult_lt_reg_r with h; try lra; rewrite Rmult_minus_distr_r, W; lra.
Qed.
Lemma negligible_turned (P : R -> Prop) : negligible P -> negligible (fun x => P (- x)).
Proof.
  intros H e He. destruct (H e He) as (a & b & A1 & A2 & A3). exists (fun k => - b k), (fun k => - a k). split; [intros k; specialize (A1 k); lra|]. split.
  - intros t Pt. destruct (A2 (- t) Pt) as [k Hk]. exists k. lra.
  - intros m. rewrite (Sum_ext m _ (fun k => b k - a k)) by (intros; ring). apply A3.
Qed.
Theorem lipschitz_derivatives f M : (forall s t, Rabs (f t - f s) <= M * Rabs (t - s)) -> negligible (fun t => ~ exists l, is_derive f t l).
Proof.
  intros Lf. set (g := fun t => f t + (M + 1) * t).
  assert (Sl : forall s t, s < t -> 1 * (t - s) <= g t - g s <= (2 * M + 1) * (t - s)).
  { intros s t Hst. specialize (Lf s t). rewrite (Rabs_pos_eq (t - s)) in Lf by lra. apply Rabs_le_between in Lf. unfold g. lra. }
  assert (Cont : forall h : R -> R, (forall s t, s < t -> 1 * (t - s) <= h t - h s <= (2 * M + 1) * (t - s)) -> forall x, continuity_pt h x).
  { intros h Sh x e He. assert (M0 : 0 <= 2 * M + 1) by (specialize (Sh 0 1 ltac:(lra)); lra). exists (e / (2 * M + 2)). split; [apply Rdiv_lt_0_compat; lra|]. intros y [_ Hy]. cbn in *. unfold R_dist in *.
    assert (Q : Rabs (h y - h x) <= (2 * M + 1) * Rabs (y - x)).
    { destruct (Rtotal_order y x) as [G|[->|G]].
      - specialize (Sh y x G). rewrite (Rabs_left (y - x)) by lra. apply Rabs_le. lra.
      - rewrite !Rminus_eq_0, Rabs_R0. lra.
      - specialize (Sh x y G). rewrite (Rabs_pos_eq (y - x)) by lra. apply Rabs_le. lra. }
    eapply Rle_lt_trans; [exact Q|]. apply Rle_lt_trans with ((2 * M + 1) * (e / (2 * M + 2))); [apply Rmult_le_compat_l; lra|]. apply Rmult_lt_reg_r with (2 * M + 2); [lra|]. replace ((2 * M + 1) * (e / (2 * M + 2)) * (2 * M + 2)) with ((2 * M + 1) * e) by (field; lra). lra. }
  assert (Mono : forall h : R -> R, (forall s t, s < t -> 1 * (t - s) <= h t - h s <= (2 * M + 1) * (t - s)) -> forall x y, x <= y -> h x <= h y).
  { intros h Sh x y [H| ->]; [specialize (Sh x y H); lra|lra]. }
  assert (St : forall s t, s < t -> 1 * (t - s) <= turned g t - turned g s <= (2 * M + 1) * (t - s)).
  { intros s t Hst. unfold turned. specialize (Sl (- t) (- s) ltac:(lra)). lra. }
  pose proof (split_negligible g (Cont g Sl) (Mono g Sl)) as N1. pose proof (negligible_turned _ (split_negligible (turned g) (Cont _ St) (Mono _ St))) as N2.
  eapply negligible_sub; [|exact (negligible_or _ _ N1 N2)]. intros t Nd. apply NNPP. intros K. apply Nd.
  destruct (has_derivative g (2 * M + 1) t Sl) as [l Dl].
  { intros i j D. split; intros S; apply K; [left|right]; now exists i, j. }
  exists (l + - (M + 1) * 1). apply (is_derive_ext (fun s => g s + - (M + 1) * s)); [intros s; unfold g; change (f s + (M + 1) * s + - (M + 1) * s = f s); ring|]. apply D_plus; [exact Dl|]. apply D_scal, D_id.
Qed.
