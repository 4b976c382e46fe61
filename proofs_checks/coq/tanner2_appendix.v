(* Tanner, Jadbabaie, Pappas, switching paper, Appendix: solutions in the sense of Filippov of xdot = f(x, t) in R^n.  One-sided bounds
   almost everywhere make them unique forwards; the chain rule of Theorem 4.
     tanner2.appA_uniq (corrected), tanner2.appA.thm4 (corrected). *)
From Coq Require Import Reals Lra Lia Psatz Classical Arith.Cantor.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums inclusions tanner2_filippov.
Open Scope R_scope.

(* sets of measure zero of R^n: the first n coordinates count *)
Fixpoint Product (n : nat) (f : nat -> R) : R := match n with O => 1 | Datatypes.S m => Product m f * f m end.
Definition null n (Z : (nat -> R) -> Prop) := forall e, 0 < e -> exists a b : nat -> nat -> R, (forall k i, (i < n)%nat -> a k i <= b k i) /\
  (forall x, Z x -> exists k, forall i, (i < n)%nat -> a k i < x i < b k i) /\ forall m, Sum m (fun k => Product n (fun i => b k i - a k i)) <= e.
(* closed convex hulls, and K[f](x) *)
Definition closed_hull n (A : (nat -> R) -> Prop) (z : nat -> R) := forall e, 0 < e -> exists m (c : nat -> R) (y : nat -> nat -> R),
  (forall k, (k < m)%nat -> 0 <= c k /\ A (y k)) /\ Sum m c = 1 /\ forall i, (i < n)%nat -> Rabs (z i - Sum m (fun k => c k * y k i)) < e.
Definition values n (f : (nat -> R) -> nat -> R) x d (Z : (nat -> R) -> Prop) (y : nat -> R) :=
  exists q, near n d q x /\ ~ Z q /\ forall i, (i < n)%nat -> y i = f q i.
Definition K n f x z := forall d Z, 0 < d -> null n Z -> closed_hull n (values n f x d Z) z.
(* absolutely continuous on every [0, b], b < T; Filippov solutions until T *)
Definition ac_until T (F : R -> R) := forall b e, 0 < b < T -> 0 < e -> exists d, 0 < d /\ forall m (p q : nat -> R),
  (forall k, (k < m)%nat -> 0 <= p k <= q k /\ q k <= b) -> (forall k, (Datatypes.S k < m)%nat -> q k <= p (Datatypes.S k)) ->
  Sum m (fun k => q k - p k) < d -> Sum m (fun k => Rabs (F (q k) - F (p k))) < e.
Definition filippov n (f : R -> (nat -> R) -> nat -> R) T (x : R -> nat -> R) := (forall i, (i < n)%nat -> ac_until T (fun t => x t i)) /\
  exists N, negligible N /\ forall t, 0 <= t < T -> ~ N t -> exists z, K n (f t) (x t) z /\ forall i, (i < n)%nat -> is_derive (fun s => x s i) t (z i).

Lemma stops T F b : ac_until T F -> 0 < b < T -> ac (fun t => F (Rmin t b)).
Proof.
  intros A Hb T' e _ He. destruct (A b e Hb He) as (d & Hd & P). exists d. split; [exact Hd|]. intros m p q I O Q.
  apply (P m (fun k => Rmin (p k) b) (fun k => Rmin (q k) b)).
  - intros k Hk. destruct (I k Hk) as [[I1 I2] I3]. split; [split; [apply Rmin_glb; lra|apply Rle_min_compat_r; lra]|apply Rmin_r].
  - intros k Hk. apply Rle_min_compat_r. now apply O.
  - apply Rle_lt_trans with (2 := Q). apply Sum_le. intros k Hk. destruct (I k Hk) as [[I1 I2] I3]. unfold Rmin.
    destruct (Rle_dec (q k) b), (Rle_dec (p k) b); lra.
Qed.
Lemma negligible_at x : 0 <= x -> negligible (fun t => t = x).
Proof. intros Hx. apply negligible_isolated. intros t ->. split; [exact Hx|]. exists 1. split; [lra|]. intros s -> _. reflexivity. Qed.
Lemma D_stopped (F : R -> R) b t l : t < b -> is_derive F t l -> is_derive (fun s => F (Rmin s b)) t l.
Proof.
  intros Ht. apply is_derive_ext_loc. exists (mkposreal (b - t) ltac:(lra)). intros x Hx. cbn in Hx. unfold ball in Hx. cbn in Hx.
  unfold AbsRing_ball, abs, minus, plus, opp in Hx. cbn in Hx. apply Rabs_lt_between in Hx. now rewrite Rmin_left by lra.
Qed.

Lemma hull_le n A z l c : closed_hull n A z -> (forall y, A y -> dot n l y <= c) -> dot n l z <= c.
Proof.
  intros H B. apply Rnot_lt_le. intros L. set (W := Sum n (fun i => Rabs (l i)) + 1).
  assert (HW : 1 <= W) by (unfold W; pose proof (Sum_ge0 n (fun i => Rabs (l i)) ltac:(intros; apply Rabs_pos)); lra).
  destruct (H ((dot n l z - c) / W)) as (m & w & y & P & S1 & Q); [apply Rdiv_lt_0_compat; lra|]. set (e := (dot n l z - c) / W) in *.
  assert (E : dot n l (fun i => Sum m (fun k => w k * y k i)) <= c).
  { unfold dot. rewrite (Sum_ext n _ (fun i => Sum m (fun k => l i * (w k * y k i)))) by (intros; symmetry; apply Sum_scal). rewrite Sum_swap.
    apply Rle_trans with (Sum m (fun k => w k * c)); [|rewrite Sum_scal_r, S1; lra]. apply Sum_le. intros k Hk. destruct (P k Hk) as [P1 P2].
    rewrite (Sum_ext n _ (fun i => w k * (l i * y k i))) by (intros; ring). rewrite Sum_scal. apply Rmult_le_compat_l; [exact P1|]. now apply B. }
  assert (G : dot n l z - dot n l (fun i => Sum m (fun k => w k * y k i)) <= e * Sum n (fun i => Rabs (l i))).
  { unfold dot. rewrite <- Sum_minus, <- Sum_scal. apply Sum_le. intros i Hi. specialize (Q i Hi).
    rewrite <- Rmult_minus_distr_l. eapply Rle_trans; [apply Rle_abs|]. rewrite Rabs_mult, Rmult_comm. apply Rmult_le_compat_r; [apply Rabs_pos|lra]. }
  assert (e * W = dot n l z - c) by (unfold e; field; lra). assert (0 < e) by (unfold e; apply Rdiv_lt_0_compat; lra). unfold W in *. nra.
Qed.
Lemma K_above n f x z Z d e l : K n f x z -> null n Z -> 0 < d -> 0 < e -> exists q, near n d q x /\ ~ Z q /\ dot n l z - e <= dot n l (f q).
Proof.
  intros H HZ Hd He. apply NNPP. intros No. assert (dot n l z <= dot n l z - e); [|lra]. apply (hull_le n _ _ l _ (H d Z Hd HZ)).
  intros y (q & Q1 & Q2 & Q3). apply Rnot_lt_le. intros L. apply No. exists q. split; [exact Q1|]. split; [exact Q2|].
  replace (dot n l (f q)) with (dot n l y); [lra|]. unfold dot. apply Sum_ext. intros i Hi. now rewrite Q3.
Qed.

(* ---- one-sided bounds for almost all x, and for each of them for almost all y ---- *)
Definition gap2 n (x y : nat -> R) := Sum n (fun i => (x i - y i) ^ 2).
Definition bound_fails n f p d l (x y : nat -> R) := near n d y p /\ ~ dot n (fun i => f x i - f y i) (fun i => x i - y i) <= l * gap2 n x y.
Definition one_sided_near n f p d l := null n (fun x => near n d x p /\ ~ null n (bound_fails n f p d l x)).

Lemma hulls_bounded n f p d d' l M : 0 < d <= d' -> (forall x, near n d x p -> forall i, (i < n)%nat -> Rabs (f x i) <= M) ->
  one_sided_near n f p d' l -> forall x y z w, near n (d / 2) x p -> near n (d / 2) y p -> K n f x z -> K n f y w ->
  dot n (fun i => z i - w i) (fun i => x i - y i) <= l * gap2 n x y.
Proof.
  intros Hd B O x y z w Hx Hy Kz Kw. apply Rnot_lt_le. intros L. set (D := dot n (fun i => z i - w i) (fun i => x i - y i)) in *. set (h := (D - l * gap2 n x y) / 4).
  assert (Hh : 0 < h) by (unfold h; lra). set (M' := Rabs M). pose proof (Rabs_pos M) as HM. fold M' in HM.
  set (C := INR n * (4 * M') + INR n * (Rabs l * (4 * d + 4))). pose proof (pos_INR n) as Hn. pose proof (Rabs_pos l) as Hl.
  assert (HC : 0 <= C) by (unfold C; apply Rplus_le_le_0_compat; apply Rmult_le_pos; try lra; apply Rmult_le_pos; lra).
  set (r := Rmin (Rmin 1 (d / 2)) (h / (C + 1))). assert (Hr : 0 < r) by (unfold r; repeat apply Rmin_glb_lt; try lra; apply Rdiv_lt_0_compat; lra).
  assert (R1 : r <= 1) by (unfold r; eapply Rle_trans; [apply Rmin_l|apply Rmin_l]). assert (R2 : r <= d / 2) by (unfold r; eapply Rle_trans; [apply Rmin_l|apply Rmin_r]).
  assert (R3 : C * r <= h).
  { assert (r <= h / (C + 1)) by apply Rmin_r. apply Rle_trans with ((C + 1) * (h / (C + 1))); [|right; field; lra]. nra. }
  set (e := fun i => x i - y i).
  destruct (K_above n f x z _ r h e Kz O Hr Hh) as (x' & X1 & X2 & X3).
  assert (Near : forall q s, near n (d / 2) q p -> near n r s q -> near n d s p).
  { intros q s Hq Hs i Hi. specialize (Hq i Hi). specialize (Hs i Hi). replace (s i - p i) with ((s i - q i) + (q i - p i)) by ring.
    eapply Rle_lt_trans; [apply Rabs_triang|]. lra. }
  assert (Wide : forall q, near n d q p -> near n d' q p) by (intros q Hq i Hi; specialize (Hq i Hi); lra).
  pose proof (Near x x' Hx X1) as Nx. assert (Nu : null n (bound_fails n f p d' l x')).
  { apply NNPP. intros No. apply X2. split; [now apply Wide|exact No]. }
  destruct (K_above n f y w _ r h (fun i => - e i) Kw Nu Hr Hh) as (y' & Y1 & Y2 & Y3). pose proof (Near y y' Hy Y1) as Ny.
  assert (Q : dot n (fun i => f x' i - f y' i) (fun i => x' i - y' i) <= l * gap2 n x' y').
  { apply NNPP. intros No. apply Y2. split; [now apply Wide|exact No]. }
  assert (E : D - 2 * h <= dot n (fun i => f x' i - f y' i) e).
  { assert (T : forall a : nat -> R, dot n (fun i => - e i) a = - dot n e a) by (intros a; unfold dot; rewrite <- Sum_opp; apply Sum_ext; intros; ring).
    rewrite !T in Y3. replace D with (dot n e z - dot n e w); [|unfold D, dot; rewrite <- Sum_minus; apply Sum_ext; intros; unfold e; ring].
    replace (dot n (fun i => f x' i - f y' i) e) with (dot n e (f x') - dot n e (f y')) by (unfold dot; rewrite <- Sum_minus; apply Sum_ext; intros; ring). lra. }
  assert (G1 : dot n (fun i => f x' i - f y' i) e - dot n (fun i => f x' i - f y' i) (fun i => x' i - y' i) <= INR n * (4 * M' * r)).
  { unfold dot. rewrite <- Sum_minus, <- Sum_const. apply Sum_le. intros i Hi. rewrite <- Rmult_minus_distr_l. eapply Rle_trans; [apply Rle_abs|]. rewrite Rabs_mult.
    replace (4 * M' * r) with ((2 * M') * (2 * r)) by ring. apply Rmult_le_compat; try apply Rabs_pos.
    - pose proof (B x' Nx i Hi). pose proof (B y' Ny i Hi). pose proof (Rle_abs M). fold M' in H1. unfold Rminus. eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_Ropp. lra.
    - unfold e. specialize (X1 i Hi). specialize (Y1 i Hi). replace (x i - y i - (x' i - y' i)) with (- (x' i - x i) + (y' i - y i)) by ring.
      eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_Ropp. lra. }
  assert (G2 : l * gap2 n x' y' - l * gap2 n x y <= INR n * (Rabs l * (4 * d + 4) * r)).
  { unfold gap2. rewrite <- !Sum_scal, <- Sum_minus, <- Sum_const. apply Sum_le. intros i Hi.
    replace (l * (x' i - y' i) ^ 2 - l * (x i - y i) ^ 2) with (l * (((x' i - y' i) + (x i - y i)) * ((x' i - y' i) - (x i - y i)))) by ring.
    eapply Rle_trans; [apply Rle_abs|]. rewrite !Rabs_mult. replace (Rabs l * (4 * d + 4) * r) with (Rabs l * ((2 * d + 2) * (2 * r))) by ring.
    apply Rmult_le_compat_l; [exact Hl|]. specialize (X1 i Hi). specialize (Y1 i Hi). specialize (Hx i Hi). specialize (Hy i Hi).
    apply Rmult_le_compat; try apply Rabs_pos; apply Rabs_lt_between in X1, Y1, Hx, Hy; apply Rabs_le; lra. }
  unfold C, h in *. lra.
Qed.

Theorem unique_forwards : forall n (f : (nat -> R) -> nat -> R),
  (forall p, exists d M, 0 < d /\ forall x, near n d x p -> forall i, (i < n)%nat -> Rabs (f x i) <= M) ->
  (forall p, exists d l, 0 < d /\ one_sided_near n f p d l) ->
  forall T x y, filippov n (fun _ => f) T x -> filippov n (fun _ => f) T y -> (forall i, (i < n)%nat -> x 0 i = y 0 i) ->
  forall t, 0 <= t < T -> forall i, (i < n)%nat -> x t i = y t i.
Proof.
  intros n f LB OS T x y [Ax (N & HN & Sx)] [Ay (N' & HN' & Sy)] E0 b Hb.
  destruct (Req_dec b 0) as [->|Hb0]; [exact E0|].
  set (X := fun t => x (Rmin t b)). set (Y := fun t => y (Rmin t b)). set (u := fun t => Sum n (fun i => (X t i + -1 * Y t i) ^ 2)).
  assert (AX : forall i, (i < n)%nat -> ac (fun t => X t i)) by (intros i Hi; apply (stops T (fun t => x t i)); [now apply Ax|lra]).
  assert (AY : forall i, (i < n)%nat -> ac (fun t => Y t i)) by (intros i Hi; apply (stops T (fun t => y t i)); [now apply Ay|lra]).
  assert (Au : ac u) by (apply ac_Sum; intros i Hi; apply ac_sqr, ac_plus; [now apply AX|now apply ac_scal, AY]).
  assert (U0 : forall t, 0 <= u t) by (intros t; apply Sum_ge0; intros; apply pow2_ge_0).
  assert (Uz : forall t, u t = 0 -> forall i, (i < n)%nat -> X t i = Y t i).
  { intros t Z i Hi. pose proof (Sum_eq0 n _ (fun j _ => pow2_ge_0 _) Z i Hi) as P. cbv beta in P. nra. }
  set (Good := fun t => 0 <= t <= b /\ forall s, 0 <= s <= t -> u s = 0).
  assert (G0 : Good 0).
  { split; [lra|]. intros s Hs. replace s with 0 by lra. unfold u. apply Sum_zero. intros i Hi. unfold X, Y. rewrite Rmin_left by lra. rewrite (E0 i Hi). ring. }
  destruct (completeness Good) as (m & Ub & Lub); [exists b; intros s [Hs _]; lra|exists 0; exact G0|].
  assert (Mb : m <= b) by (apply Lub; intros s [Hs _]; lra). assert (M0 : 0 <= m) by now apply Ub.
  assert (Before : forall s, 0 <= s < m -> u s = 0).
  { intros s Hs. apply NNPP. intros No. assert (m <= s); [|lra]. apply Lub. intros t [Ht Gt]. apply Rnot_lt_le. intros L. apply No, Gt. lra. }
  assert (Um : u m = 0).
  { destruct (Req_dec m 0) as [->|Ne]; [apply G0; lra|]. apply NNPP. intros No. specialize (U0 m).
    destruct (ac_near u b (u m) Au ltac:(lra) ltac:(lra)) as (d & Hd & P). set (s := Rmax 0 (m - d / 2)).
    assert (Hs : 0 <= s < m) by (unfold s; split; [apply Rmax_l|apply Rmax_lub_lt; lra]). pose proof (Rmax_r 0 (m - d / 2)) as Hs'. fold s in Hs'.
    specialize (P s m ltac:(lra) ltac:(lra) ltac:(lra)). rewrite (Before s Hs), Rminus_0_r, Rabs_pos_eq in P; lra. }
  assert (Gm : Good m).
  { split; [lra|]. intros s Hs. destruct (Req_dec s m) as [->|Ne]; [exact Um|apply Before; lra]. }
  destruct (Req_dec m b) as [E|Ne].
  { intros i Hi. assert (Ub' : u b = 0) by (rewrite <- E; exact Um). specialize (Uz b Ub' i Hi). unfold X, Y in Uz. now rewrite Rmin_left in Uz by lra. }
  exfalso. set (p := X m). destruct (LB p) as (d1 & M & Hd1 & B). destruct (OS p) as (d2 & l & Hd2 & O).
  set (d := Rmin d1 d2). assert (Hd : 0 < d) by (unfold d; now apply Rmin_glb_lt). pose proof (Rmin_l d1 d2) as D1. pose proof (Rmin_r d1 d2) as D2. fold d in D1, D2.
  assert (Close : exists h, 0 < h /\ forall i, (i < n)%nat -> forall t, m <= t <= b -> t - m < h -> Rabs (X t i - p i) < d / 2 /\ Rabs (Y t i - p i) < d / 2).
  { apply small.
    - intros i h h' H Hh t Ht Hth. apply H; lra.
    - intros i Hi. destruct (ac_near _ b (d / 2) (AX i Hi) ltac:(lra) ltac:(lra)) as (h1 & H1 & P1). destruct (ac_near _ b (d / 2) (AY i Hi) ltac:(lra) ltac:(lra)) as (h2 & H2 & P2).
      exists (Rmin h1 h2). split; [now apply Rmin_glb_lt|]. intros t Ht Hth. pose proof (Rmin_l h1 h2). pose proof (Rmin_r h1 h2). split; [apply P1; lra|].
      unfold p. rewrite (Uz m Um i Hi). apply P2; lra. }
  destruct Close as (h & Hh & Close). set (L := Rmax l 0). assert (HL : 0 <= L) by apply Rmax_r. assert (HlL : l <= L) by apply Rmax_l.
  set (k := Rmin (Rmin (h / 2) (b - m)) (/ (4 * L + 1))). assert (Hk : 0 < k) by (unfold k; repeat apply Rmin_glb_lt; try lra; apply Rinv_0_lt_compat; lra).
  assert (K1 : k <= h / 2) by (unfold k; eapply Rle_trans; [apply Rmin_l|apply Rmin_l]). assert (K2 : k <= b - m) by (unfold k; eapply Rle_trans; [apply Rmin_l|apply Rmin_r]).
  assert (K3 : 2 * L * k <= / 2).
  { assert (k <= / (4 * L + 1)) by apply Rmin_r. apply Rle_trans with (2 * L * / (4 * L + 1)); [apply Rmult_le_compat_l; lra|].
    apply Rmult_le_reg_r with (4 * L + 1); [lra|]. rewrite Rmult_assoc, Rinv_l by lra. lra. }
  destruct (continuity_ab_maj (fun s => u (Rmax s 0)) m (m + k) ltac:(lra)) as (q & Mx & Hq); [intros s _; now apply ac_continuous|].
  rewrite (Rmax_left q) in Mx by lra.
  assert (Top : forall s, m <= s <= m + k -> u s <= u q) by (intros s Hs; specialize (Mx s Hs); now rewrite (Rmax_left s) in Mx by lra).
  assert (Rise : u q <= u m + 2 * L * u q * (q - m)).
  { apply (ac_le u (fun t => (N t \/ N' t) \/ t = b) m q); [exact Au|apply negligible_or; [now apply negligible_or|apply negligible_at; lra]|lra|].
    intros t Ht Nt. assert (Tb : t < b) by (destruct (Req_dec t b) as [E|E]; [exfalso; apply Nt; now right|lra]).
    destruct (Sx t ltac:(lra) ltac:(tauto)) as (z & Kz & Dz). destruct (Sy t ltac:(lra) ltac:(tauto)) as (w & Kw & Dw).
    exists (Sum n (fun i => 2 * (X t i + -1 * Y t i) * (z i + -1 * w i))). split.
    - apply (D_Sum n (fun i s => (X s i + -1 * Y s i) ^ 2) (fun i => 2 * (X t i + -1 * Y t i) * (z i + -1 * w i))). intros i Hi.
      apply (D_sqr (fun s => X s i + -1 * Y s i)), (D_plus (fun s => X s i) (fun s => -1 * Y s i)); [|apply (D_scal (-1) (fun s => Y s i))].
      + apply (D_stopped (fun s => x s i)); [exact Tb|now apply Dz].
      + apply (D_stopped (fun s => y s i)); [exact Tb|now apply Dw].
    - assert (Q : dot n (fun i => z i - w i) (fun i => X t i - Y t i) <= l * gap2 n (X t) (Y t)).
      { apply (hulls_bounded n f p d d2 l M); try assumption.
        - lra.
        - intros s Hs. apply B. intros i Hi. specialize (Hs i Hi). lra.
        - intros i Hi. apply (Close i Hi t); lra.
        - intros i Hi. apply (Close i Hi t); lra.
        - unfold X. now rewrite Rmin_left by lra.
        - unfold Y. now rewrite Rmin_left by lra. }
      replace (Sum n (fun i => 2 * (X t i + -1 * Y t i) * (z i + -1 * w i))) with (2 * dot n (fun i => z i - w i) (fun i => X t i - Y t i))
        by (unfold dot; rewrite <- Sum_scal; apply Sum_ext; intros; ring).
      replace (gap2 n (X t) (Y t)) with (u t) in Q by (unfold u, gap2; apply Sum_ext; intros; ring).
      specialize (Top t ltac:(lra)). specialize (U0 t). assert (l * u t <= L * u q) by nra. lra. }
  assert (Zq : u q = 0). { rewrite Um in Rise. specialize (U0 q). assert (2 * L * u q * (q - m) <= u q * / 2); [|lra].
    replace (2 * L * u q * (q - m)) with (u q * (2 * L * (q - m))) by ring. apply Rmult_le_compat_l; [exact U0|]. apply Rle_trans with (2 * L * k); [|exact K3].
    apply Rmult_le_compat_l; lra. }
  assert (Good (m + k)).
  { split; [lra|]. intros s Hs. destruct (Rle_or_lt s m) as [A|A]; [now apply Gm|]. specialize (Top s ltac:(lra)). specialize (U0 s). lra. }
  specialize (Ub _ H). lra.
Qed.

(* ---- the chain rule: V on R^(n+1), the time being the last coordinate; Clarke's directional derivative, regular functions, the generalised gradient ---- *)
Definition moved (p w : nat -> R) (h : R) (i : nat) : R := p i + h * w i.
Definition slope_along (V : (nat -> R) -> R) p w l := forall e, 0 < e -> exists d, 0 < d /\ forall h, 0 < h < d -> Rabs ((V (moved p w h) - V p) / h - l) < e.
Definition clarke_slope n (V : (nat -> R) -> R) p w l :=
  (forall e, 0 < e -> exists d, 0 < d /\ forall q h, near n d q p -> 0 < h < d -> (V (moved q w h) - V q) / h < l + e) /\
  (forall e d, 0 < e -> 0 < d -> exists q h, near n d q p /\ 0 < h < d /\ l - e < (V (moved q w h) - V q) / h).
Definition regular_at n V p := forall w, exists l, slope_along V p w l /\ clarke_slope n V p w l.
Definition generalised_gradient n V p xi := forall w l, clarke_slope n V p w l -> dot n xi w <= l.
Definition lipschitz_at n (V : (nat -> R) -> R) p := exists d L, 0 < d /\ forall q s, near n d q p -> near n d s p -> Rabs (V q - V s) <= L * Sum n (fun i => Rabs (q i - s i)).
Definition with_time (n : nat) (x : nat -> R) (t : R) (i : nat) : R := if Nat.ltb i n then x i else t.

(* countable sets *)
Lemma negligible_countable (P : R -> Prop) (cell : nat -> R -> Prop) : (forall t, P t -> exists k, cell k t) -> (forall k s t, cell k s -> cell k t -> s = t) -> negligible P.
Proof.
  intros H One e He. set (x := fun k => real (Lub_Rbar (cell k))). set (h := fun k : nat => e / 4 * (/ 2) ^ k).
  assert (Hh : forall k, 0 < h k) by (intros k; unfold h; apply Rmult_lt_0_compat; [lra|apply pow_lt; lra]).
  assert (X : forall k t, cell k t -> x k = t).
  { intros k t Ct. unfold x. replace (Lub_Rbar (cell k)) with (Finite t); [reflexivity|]. symmetry. apply is_lub_Rbar_unique. split.
    - intros s Cs. replace s with t; [apply Rle_refl|]. now apply (One k).
    - intros b Ub. now apply Ub. }
  exists (fun k => x k - h k), (fun k => x k + h k). split; [intros k; specialize (Hh k); lra|]. split.
  - intros t Pt. destruct (H t Pt) as [k Ck]. exists k. rewrite (X k t Ck). specialize (Hh k). lra.
  - intros m. rewrite (Sum_ext m _ (fun k => e / 2 * (/ 2) ^ k)) by (intros k _; unfold h; field).
    assert (G : Sum m (fun k => e / 2 * (/ 2) ^ k) = e * (1 - (/ 2) ^ m)) by (induction m as [|m IH]; cbn [Sum pow]; [ring|]; rewrite IH; field).
    rewrite G. assert (0 < (/ 2) ^ m) by (apply pow_lt; lra). nra.
Qed.
(* the rate of g forwards (a = 1) and backwards (a = -1); they are opposite but at countably many times *)
Definition one_rate (g : R -> R) a t l := forall e, 0 < e -> exists d, 0 < d /\ forall h, 0 < h < d -> Rabs ((g (t + a * h) - g t) / h - l) < e.
Lemma rate_above g a t l c : one_rate g a t l -> c < l -> exists d, 0 < d /\ forall h, 0 < h < d -> c * h < g (t + a * h) - g t.
Proof.
  intros H L. destruct (H (l - c) ltac:(lra)) as (d & Hd & P). exists d. split; [exact Hd|]. intros h Hh. specialize (P h Hh). apply Rabs_lt_between in P.
  assert (Q : c < (g (t + a * h) - g t) / h) by lra. apply (Rmult_lt_compat_r h) in Q; [|lra]. replace ((g (t + a * h) - g t) / h * h) with (g (t + a * h) - g t) in Q by (field; lra). exact Q.
Qed.
Lemma convex_kinks g : negligible (fun t => 0 <= t /\ exists l m, one_rate g 1 t l /\ one_rate g (-1) t m /\ - m < l).
Proof.
  set (cell := fun k t => let (a, b) := Cantor.of_nat k in let (j, i) := Cantor.of_nat b in INR j <= t * 2 ^ i < INR j + 1 /\
    forall h, 0 < h -> h * 2 ^ i < 1 -> rat a * h < g (t + 1 * h) - g t /\ - rat a * h < g (t + -1 * h) - g t).
  apply (negligible_countable _ cell).
  - intros t (T0 & l & m & Hl & Hm & L). destruct (rat_dense ((l - m) / 2) ((l + m) / 2) ltac:(lra)) as [a Ha]. apply Rabs_lt_between in Ha.
    destruct (rate_above g 1 t l (rat a) Hl ltac:(lra)) as (d1 & H1 & P1). destruct (rate_above g (-1) t m (- rat a) Hm ltac:(lra)) as (d2 & H2 & P2).
    set (d := Rmin d1 d2). assert (Hd : 0 < d) by now apply Rmin_glb_lt. pose proof (Rmin_l d1 d2) as Q1. pose proof (Rmin_r d1 d2) as Q2. fold d in Q1, Q2.
    destruct (nfloor_ex (/ d) ltac:(left; now apply Rinv_0_lt_compat)) as [k Hk]. pose (q := Datatypes.S k).
    assert (B : forall m, INR m + 1 <= 2 ^ m) by (induction m0 as [|i IH]; [cbn; lra|rewrite S_INR; cbn [pow]; pose proof (pos_INR i); lra]).
    assert (P3 : / d < 2 ^ q) by (pose proof (B q) as Bq; unfold q in *; rewrite S_INR in Bq; lra). assert (Pq : 0 < 2 ^ q) by (apply pow_lt; lra).
    destruct (nfloor_ex (t * 2 ^ q)) as [j Hj]; [apply Rmult_le_pos; lra|].
    exists (Cantor.to_nat (a, Cantor.to_nat (j, q))). unfold cell. rewrite !Cantor.cancel_of_to. split; [lra|]. intros h Hh Hs.
    assert (h < d). { apply (Rmult_lt_reg_r (2 ^ q)); [exact Pq|]. apply Rlt_trans with (1 := Hs). apply (Rmult_lt_compat_l d) in P3; [|exact Hd]. rewrite Rinv_r in P3 by lra. exact P3. }
    split; [apply P1|apply P2]; lra.
  - assert (A : forall k s t, cell k s -> cell k t -> s < t -> False).
    { intros k s t. unfold cell. destruct (Cantor.of_nat k) as [a b]. destruct (Cantor.of_nat b) as [j i]. intros [S1 S2] [T1 T2] L.
      assert (Q : (t - s) * 2 ^ i < 1) by lra. destruct (S2 (t - s) ltac:(lra) Q) as [A _]. destruct (T2 (t - s) ltac:(lra) Q) as [_ A'].
      replace (s + 1 * (t - s)) with t in A by ring. replace (t + -1 * (t - s)) with s in A' by ring. lra. }
    intros k s t Cs Ct. destruct (Rtotal_order s t) as [L|[E|L]]; [exfalso; now apply (A k s t)|exact E|exfalso; now apply (A k t s)].
Qed.
Lemma kinks g : negligible (fun t => 0 <= t /\ exists l m, one_rate g 1 t l /\ one_rate g (-1) t m /\ - m <> l).
Proof.
  assert (O : forall a t l, one_rate g a t l -> one_rate (fun s => - g s) a t (- l)).
  { intros a t l H e He. destruct (H e He) as (d & Hd & P). exists d. split; [exact Hd|]. intros h Hh. specialize (P h Hh).
    replace ((- g (t + a * h) - - g t) / h - - l) with (- ((g (t + a * h) - g t) / h - l)) by (field; lra). now rewrite Rabs_Ropp. }
  eapply negligible_sub; [|exact (negligible_or _ _ (convex_kinks g) (convex_kinks (fun s => - g s)))].
  intros t (H0 & l & m & Hl & Hm & Ne). cbv beta. destruct (Rtotal_order (- m) l) as [L|[L|L]]; [left|contradiction|right].
  - split; [exact H0|]. now exists l, m.
  - split; [exact H0|]. exists (- l), (- m). split; [now apply O|]. split; [now apply O|]. lra.
Qed.
Lemma rates_derivative g t l : one_rate g 1 t l -> one_rate g (-1) t (- l) -> is_derive g t l.
Proof.
  intros F B. apply is_derive_Reals. intros e He. destruct (F e He) as (d & Hd & P). destruct (B e He) as (d' & Hd' & Q).
  exists (mkposreal (Rmin d d') ltac:(now apply Rmin_glb_lt)). cbn. intros h Hh Hs. pose proof (Rmin_l d d'). pose proof (Rmin_r d d').
  apply Rabs_lt_between in Hs. destruct (Rle_or_lt h 0) as [L|L].
  - specialize (Q (- h) ltac:(lra)). replace (t + -1 * - h) with (t + h) in Q by ring.
    replace ((g (t + h) - g t) / - h - - l) with (- ((g (t + h) - g t) / h - l)) in Q by (field; lra). now rewrite Rabs_Ropp in Q.
  - specialize (P h ltac:(lra)). now replace (t + 1 * h) with (t + h) in P by ring.
Qed.

(* along a differentiable curve V has the slope of the tangent *)
Lemma curve_rate n V (c : R -> nat -> R) t z a l : a = 1 \/ a = -1 -> lipschitz_at n V (c t) -> (forall i, (i < n)%nat -> is_derive (fun s => c s i) t (z i)) ->
  slope_along V (c t) (fun i => a * z i) l -> one_rate (fun s => V (c s)) a t l.
Proof.
  intros Ha (d0 & L & Hd0 & Lip) D Sl e He. set (L0 := Rabs L + 1). assert (HL0 : 1 <= L0) by (unfold L0; pose proof (Rabs_pos L); lra).
  set (k := e / (4 * L0 * (INR n + 1))). pose proof (pos_INR n) as Hn. assert (Hk : 0 < k) by (unfold k; apply Rdiv_lt_0_compat; [lra|]; apply Rmult_lt_0_compat; lra).
  assert (Ek : L0 * (INR n * k) <= e / 4). { apply Rle_trans with (L0 * ((INR n + 1) * k)); [apply Rmult_le_compat_l; [lra|]; apply Rmult_le_compat_r; lra|]. right. unfold k. field. split; lra. }
  assert (N : exists d, 0 < d /\ forall i, (i < n)%nat -> forall h, 0 < h < d -> Rabs (c (t + a * h) i - moved (c t) (fun i => a * z i) h i) <= k * h /\
    Rabs (c (t + a * h) i - c t i) < d0 /\ Rabs (moved (c t) (fun i => a * z i) h i - c t i) < d0).
  { apply small; [intros i d d' H Hd h Hh; apply H; lra|]. intros i Hi. pose proof (D i Hi) as Di. apply is_derive_Reals in Di. destruct (Di k Hk) as [d Hd]. pose proof (cond_pos d) as Pd.
    pose proof (Rabs_pos (z i)) as Az. exists (Rmin d (d0 / (Rabs (z i) + k + 1))). split; [apply Rmin_glb_lt; [exact Pd|apply Rdiv_lt_0_compat; lra]|].
    intros h Hh. pose proof (Rmin_l d (d0 / (Rabs (z i) + k + 1))). pose proof (Rmin_r d (d0 / (Rabs (z i) + k + 1))).
    assert (Aa : Rabs a = 1) by (destruct Ha as [-> | ->]; [apply Rabs_R1|rewrite Rabs_left; lra]).
    assert (a0 : a <> 0) by (destruct Ha as [-> | ->]; lra).
    specialize (Hd (a * h) ltac:(apply Rmult_integral_contrapositive_currified; lra) ltac:(rewrite Rabs_mult, Aa, (Rabs_pos_eq h); lra)).
    assert (Q1 : Rabs (c (t + a * h) i - moved (c t) (fun i => a * z i) h i) <= k * h).
    { unfold moved. replace (c (t + a * h) i - (c t i + h * (a * z i))) with (((c (t + a * h) i - c t i) / (a * h) - z i) * (a * h)) by (field; split; lra).
      rewrite Rabs_mult, (Rabs_mult a), Aa, (Rabs_pos_eq h), Rmult_1_l by lra. apply Rmult_le_compat_r; lra. }
    assert (Q2 : Rabs (moved (c t) (fun i => a * z i) h i - c t i) = Rabs (z i) * h).
    { unfold moved. replace (c t i + h * (a * z i) - c t i) with (z i * (a * h)) by ring. rewrite !Rabs_mult, Aa, (Rabs_pos_eq h) by lra. ring. }
    assert (Q3 : (Rabs (z i) + k + 1) * h < d0).
    { apply Rlt_le_trans with ((Rabs (z i) + k + 1) * (d0 / (Rabs (z i) + k + 1))); [apply Rmult_lt_compat_l; lra|right; field; lra]. }
    split; [exact Q1|]. split; [|rewrite Q2; nra].
    replace (c (t + a * h) i - c t i) with ((c (t + a * h) i - moved (c t) (fun i => a * z i) h i) + (moved (c t) (fun i => a * z i) h i - c t i)) by ring.
    eapply Rle_lt_trans; [apply Rabs_triang|]. rewrite Q2. nra. }
  destruct N as (d1 & Hd1 & N). destruct (Sl (e / 2) ltac:(lra)) as (d2 & Hd2 & S2). exists (Rmin d1 d2). split; [now apply Rmin_glb_lt|].
  intros h Hh. pose proof (Rmin_l d1 d2). pose proof (Rmin_r d1 d2). specialize (S2 h ltac:(lra)). set (q := moved (c t) (fun i => a * z i) h) in *.
  assert (B : Rabs (V (c (t + a * h)) - V q) <= e / 4 * h).
  { eapply Rle_trans; [apply Lip; intros i Hi; apply (N i Hi h); lra|]. apply Rle_trans with (L0 * (INR n * k) * h); [|apply Rmult_le_compat_r; lra].
    apply Rle_trans with (L0 * (INR n * (k * h))); [|right; ring].
    apply Rle_trans with (L0 * Sum n (fun i => Rabs (c (t + a * h) i - q i))).
    - apply Rmult_le_compat_r; [apply Sum_ge0; intros; apply Rabs_pos|]. unfold L0. pose proof (Rle_abs L). lra.
    - apply Rmult_le_compat_l; [lra|]. rewrite <- Sum_const. apply Sum_le. intros i Hi. apply (N i Hi h). lra. }
  replace ((V (c (t + a * h)) - V (c t)) / h - l) with ((V (c (t + a * h)) - V q) / h + ((V q - V (c t)) / h - l)) by (field; lra).
  eapply Rle_lt_trans; [apply Rabs_triang|]. assert (Rabs ((V (c (t + a * h)) - V q) / h) <= e / 4); [|lra].
  unfold Rdiv. rewrite Rabs_mult, Rabs_inv, (Rabs_pos_eq h) by lra. apply (Rmult_le_reg_r h); [lra|]. rewrite Rmult_assoc, Rinv_l by lra. lra.
Qed.

(* a bound near each time is one for all short intervals *)
Lemma uniform (g : R -> R) (W : R -> R -> R) b : 0 < b -> (forall x y, 0 <= W x y) ->
  (forall t, 0 <= t <= b -> exists d L, 0 < d /\ forall x y, 0 <= x <= y -> y <= b -> Rabs (x - t) < d -> Rabs (y - t) < d -> Rabs (g y - g x) <= L * W x y) ->
  exists d L, 0 < d /\ 0 < L /\ forall x y, 0 <= x <= y -> y <= b -> y - x < d -> Rabs (g y - g x) <= L * W x y.
Proof.
  intros Hb HW H. set (E := fun t => 0 <= t <= b /\ exists d L, 0 < d /\ 0 < L /\ forall x y, 0 <= x <= y -> y <= t -> y - x < d -> Rabs (g y - g x) <= L * W x y).
  assert (E0 : E 0).
  { split; [lra|]. exists 1, 1. split; [lra|]. split; [lra|]. intros x y Hx Hy _. replace y with x by lra. rewrite Rminus_eq_0, Rabs_R0, Rmult_1_l. apply HW. }
  destruct (completeness E) as (m & Ub & Lub); [exists b; intros s [Hs _]; lra|now exists 0|].
  assert (Mb : m <= b) by (apply Lub; intros s [Hs _]; lra). assert (M0 : 0 <= m) by now apply Ub.
  destruct (H m ltac:(lra)) as (d & L & Hd & P).
  assert (Near : exists t, m - d / 2 < t <= m /\ E t).
  { apply NNPP. intros No. assert (m <= m - d / 2); [|lra]. apply Lub. intros s Es. apply Rnot_lt_le. intros A. apply No. exists s. split; [|exact Es]. split; [lra|now apply Ub]. }
  destruct Near as (t & Ht & Et & d' & L' & Hd' & HL' & P'). set (s := Rmin b (m + d / 2)). pose proof (Rmin_l b (m + d / 2)) as S1. pose proof (Rmin_r b (m + d / 2)) as S2. fold s in S1, S2.
  assert (Es : E s).
  { split; [split; [unfold s; apply Rmin_glb; lra|lra]|]. exists (Rmin d' (d / 4)), (Rmax L L'). pose proof (Rmin_l d' (d / 4)). pose proof (Rmin_r d' (d / 4)). pose proof (Rmax_l L L'). pose proof (Rmax_r L L').
    split; [apply Rmin_glb_lt; lra|]. split; [lra|]. intros x y Hx Hy Hxy. specialize (HW x y). destruct (Rle_or_lt y t) as [A|A].
    - apply Rle_trans with (L' * W x y); [apply P'; lra|now apply Rmult_le_compat_r].
    - apply Rle_trans with (L * W x y); [apply P; try lra; apply Rabs_def1; lra|now apply Rmult_le_compat_r]. }
  assert (Sm : s <= m) by now apply Ub. assert (Sb : s = b) by (unfold s in *; unfold Rmin in *; destruct (Rle_dec b (m + d / 2)); lra).
  rewrite Sb in Es. now destruct Es.
Qed.

Theorem chain_rule : forall n (f : R -> (nat -> R) -> nat -> R) (V : (nat -> R) -> R) T x, filippov n f T x ->
  (forall p, lipschitz_at (Datatypes.S n) V p) -> (forall p, regular_at (Datatypes.S n) V p) ->
  ac_until T (fun t => V (with_time n (x t) t)) /\ exists N, negligible N /\ forall t, 0 <= t < T -> ~ N t ->
    exists l, is_derive (fun s => V (with_time n (x s) s)) t l /\
      forall xi, generalised_gradient (Datatypes.S n) V (with_time n (x t) t) xi -> exists k, K n (f t) (x t) k /\ l = dot (Datatypes.S n) xi (with_time n k 1).
Proof.
  intros n f V T x [Ax (N & HN & Sx)] Lip Reg. set (c := fun t => with_time n (x t) t). set (g := fun t => V (c t)). split.
  - intros b e Hb He.
    assert (AC : forall i, (i < Datatypes.S n)%nat -> ac (fun t => c (Rmin t b) i)).
    { intros i Hi. unfold c, with_time. destruct (Nat.ltb_spec i n) as [L|L]; [apply (stops T (fun t => x t i)); [now apply Ax|lra]|].
      apply ac_lipschitz. intros T' _. exists 1. split; [lra|]. intros s t Hs Ht. rewrite Rmult_1_l. unfold Rmin. destruct (Rle_dec t b), (Rle_dec s b); rewrite Rabs_pos_eq; lra. }
    set (W := fun s t => Sum (Datatypes.S n) (fun i => Rabs (c t i - c s i))).
    destruct (uniform g W b ltac:(lra)) as (d & L & Hd & HL & U).
    { intros s t. apply Sum_ge0. intros. apply Rabs_pos. }
    { intros t Ht. destruct (Lip (c t)) as (d0 & L & Hd0 & P).
      assert (Q : exists d, 0 < d /\ forall i, (i < Datatypes.S n)%nat -> forall s, 0 <= s <= b -> Rabs (s - t) < d -> Rabs (c s i - c t i) < d0).
      { apply small; [intros i d d' H Hd s Hs Hst; apply H; lra|]. intros i Hi. destruct (ac_near _ b d0 (AC i Hi) ltac:(lra) Hd0) as (d & Hd & Q). exists d. split; [exact Hd|].
        intros s Hs Hst. apply Rabs_lt_between in Hst. destruct (Rle_or_lt s t) as [A|A].
        - specialize (Q s t ltac:(lra) ltac:(lra) ltac:(lra)). cbv beta in Q. rewrite !Rmin_left in Q by lra. now rewrite Rabs_minus_sym.
        - specialize (Q t s ltac:(lra) ltac:(lra) ltac:(lra)). cbv beta in Q. now rewrite !Rmin_left in Q by lra. }
      destruct Q as (d & Hd & Q). exists d, L. split; [exact Hd|]. intros s s' Hs Hs' D D'. apply P; intros i Hi; apply Q; try assumption; lra. }
    pose proof (pos_INR (Datatypes.S n)) as Hn. set (e' := e / (L * (INR (Datatypes.S n) + 1))). assert (He' : 0 < e') by (unfold e'; apply Rdiv_lt_0_compat; [lra|]; apply Rmult_lt_0_compat; lra).
    assert (Q : exists d, 0 < d /\ forall i, (i < Datatypes.S n)%nat -> forall m (p q : nat -> R), (forall k, (k < m)%nat -> 0 <= p k <= q k /\ q k <= b) ->
      (forall k, (Datatypes.S k < m)%nat -> q k <= p (Datatypes.S k)) -> Sum m (fun k => q k - p k) < d -> Sum m (fun k => Rabs (c (q k) i - c (p k) i)) < e').
    { apply small; [intros i d1 d2 H H12 m p q I O S; apply H; try assumption; lra|]. intros i Hi. destruct (AC i Hi b e' ltac:(lra) He') as (d1 & Hd1 & Q). exists d1. split; [exact Hd1|].
      intros m p q I O S. specialize (Q m p q I O S). cbv beta in Q. erewrite Sum_ext; [exact Q|]. intros k Hk. destruct (I k Hk). cbv beta. now rewrite !Rmin_left by lra. }
    destruct Q as (d1 & Hd1 & Q). exists (Rmin d d1). pose proof (Rmin_l d d1). pose proof (Rmin_r d d1). split; [now apply Rmin_glb_lt|]. intros m p q I O S.
    apply Rle_lt_trans with (Sum m (fun k => L * W (p k) (q k))).
    + apply Sum_le. intros k Hk. destruct (I k Hk). apply U; try lra.
      assert (q k - p k <= Sum m (fun k => q k - p k)); [|lra]. apply (Sum_term_le m (fun k => q k - p k)); [|exact Hk]. intros j Hj. destruct (I j Hj). lra.
    + rewrite Sum_scal. unfold W. rewrite Sum_swap. apply Rle_lt_trans with (L * (INR (Datatypes.S n) * e')).
      * apply Rmult_le_compat_l; [lra|]. rewrite <- Sum_const. apply Sum_le. intros i Hi. left. apply Q; try assumption. lra.
      * unfold e'. apply Rmult_lt_reg_r with (INR (Datatypes.S n) + 1); [lra|].
        replace (L * (INR (Datatypes.S n) * (e / (L * (INR (Datatypes.S n) + 1)))) * (INR (Datatypes.S n) + 1)) with (INR (Datatypes.S n) * e) by (field; lra). nra.
  - exists (fun t => N t \/ (0 <= t /\ exists l m, one_rate g 1 t l /\ one_rate g (-1) t m /\ - m <> l)). split; [apply negligible_or; [exact HN|apply kinks]|].
    intros t Ht Nt. destruct (Sx t Ht ltac:(tauto)) as (z & Kz & Dz). set (ze := with_time n z 1).
    assert (Dc : forall i, (i < Datatypes.S n)%nat -> is_derive (fun s => c s i) t (ze i)).
    { intros i Hi. unfold c, ze, with_time. destruct (Nat.ltb_spec i n) as [L|L]; [now apply Dz|apply D_id]. }
    destruct (Reg (c t) (fun i => 1 * ze i)) as (l & Sl & Cl). destruct (Reg (c t) (fun i => -1 * ze i)) as (m & Sm & Cm).
    pose proof (curve_rate _ V c t ze 1 l (or_introl eq_refl) (Lip (c t)) Dc Sl) as R1. pose proof (curve_rate _ V c t ze (-1) m (or_intror eq_refl) (Lip (c t)) Dc Sm) as R2.
    assert (E : - m = l). { apply NNPP. intros No. apply Nt. right. split; [lra|]. now exists l, m. }
    exists l. split; [apply rates_derivative; [exact R1|replace (- l) with m by lra; exact R2]|].
    intros xi Hxi. exists z. split; [exact Kz|]. fold ze. pose proof (Hxi _ _ Cl) as A. pose proof (Hxi _ _ Cm) as B.
    assert (T1 : forall a, dot (Datatypes.S n) xi (fun i => a * ze i) = a * dot (Datatypes.S n) xi ze) by (intros a; unfold dot; rewrite <- Sum_scal; apply Sum_ext; intros; ring).
    rewrite T1 in A, B. fold (c t) in *. lra.
Qed.
