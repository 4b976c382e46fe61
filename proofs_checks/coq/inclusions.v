(* Differential inclusions x' in F(x) in R^n, F bounded with values at every state: solutions for all t >= 0 from every start.
   A solution is a limit of motions along broken lines. What it keeps of F is stated by half-spaces: whatever contains all values of F near a
   state contains the difference quotients there; so its derivatives lie in the closed convex hull of the values near the state, and
   for a continuous right-hand side it is a solution in the usual sense (Peano).
   No choice is used: limits are taken coordinate by coordinate, each the largest one possible. *)
From Coq Require Import Reals Lra Lia Psatz Classical Arith.Cantor.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums.
Open Scope R_scope.

(* ---- compactness: a point at which arbitrarily small neighbourhoods are not small ---- *)
Section Cluster.
Variable big : ((nat -> R) -> Prop) -> Prop.
Hypothesis mono : forall A B : (nat -> R) -> Prop, (forall v, A v -> B v) -> big A -> big B.
Hypothesis split : forall A B : (nat -> R) -> Prop, big (fun v => A v \/ B v) -> big A \/ big B.
Hypothesis whole : big (fun _ => True).
Hypothesis bounded : forall k, exists B, ~ big (fun v => B < Rabs (v k)).
Definition close (k : nat) (a : nat -> R) e (v : nat -> R) := forall j, (j < k)%nat -> Rabs (v j - a j) < e.
Definition beyond k a b := forall e, 0 < e -> big (fun v => close k a e v /\ b < v k).
Fixpoint first (k : nat) : nat -> R := match k with
  | O => fun _ => 0
  | S k => fun j => if Nat.eqb j k then real (Lub_Rbar (beyond k (first k))) else first k j
  end.
Definition cluster j := first (S j) j.
Lemma first_is k j : (j < k)%nat -> first k j = cluster j.
Proof.
  induction k as [|k IH]; intros H; [lia|]. cbn [first]. destruct (Nat.eqb_spec j k) as [->|N].
  - unfold cluster. cbn [first]. now rewrite Nat.eqb_refl.
  - apply IH. lia.
Qed.
Lemma lub_is (E : R -> Prop) x B : E x -> (forall b, E b -> b <= B) -> is_lub E (real (Lub_Rbar E)).
Proof.
  intros Ex U. destruct (Lub_Rbar_correct E) as [L1 L2].
  assert (F : is_finite (Lub_Rbar E)).
  { specialize (L1 x Ex). specialize (L2 (Finite B) (fun b Hb => U b Hb)). destruct (Lub_Rbar E); cbn in *; try easy. }
  rewrite <- F in L1, L2. split.
  - intros b Hb. exact (L1 b Hb).
  - intros b Hb. exact (L2 (Finite b) (fun c Hc => Hb c Hc)).
Qed.
Theorem cluster_point k e : 0 < e -> big (close k cluster e).
Proof.
  revert e. induction k as [|k IH]; intros e He; [revert whole; apply mono; intros v _ j Hj; lia|].
  destruct (bounded k) as [B HB].
  assert (C : forall e v, close k (first k) e v <-> close k cluster e v).
  { intros d v. split; intros H j Hj; specialize (H j Hj); rewrite (first_is k j Hj) in *; exact H. }
  assert (L : is_lub (beyond k (first k)) (cluster k)).
  { unfold cluster. cbn [first]. rewrite Nat.eqb_refl. apply (lub_is _ (- B - 1) (Rabs B)).
    - intros d Hd. destruct (split (fun v => close k (first k) d v /\ - B - 1 < v k) (fun v => B < Rabs (v k))) as [H|H]; [|exact H|contradiction].
      specialize (IH d Hd). revert IH. apply mono. intros v Hv. destruct (Rlt_or_le (- B - 1) (v k)) as [Q|Q]; [left|right].
      + split; [now apply C|exact Q].
      + pose proof (Rle_abs (- v k)). rewrite Rabs_Ropp in H. lra.
    - intros b Hb. destruct (Rle_or_lt b (Rabs B)) as [Q|Q]; [exact Q|]. exfalso. apply HB. specialize (Hb 1 Rlt_0_1). revert Hb.
      apply mono. intros v [_ Hv]. pose proof (Rle_abs B). pose proof (Rle_abs (v k)). lra. }
  destruct L as [L1 L2].
  assert (X : exists b, beyond k (first k) b /\ cluster k - e < b).
  { apply NNPP. intros N. assert (U : cluster k <= cluster k - e); [|lra]. apply L2. intros b Hb. apply Rnot_lt_le. intros Q. apply N. now exists b. }
  destruct X as (b & Hb & Eb).
  assert (Y : ~ beyond k (first k) (cluster k + e / 2)) by (intros H; specialize (L1 _ H); lra).
  apply not_all_ex_not in Y. destruct Y as [d Y]. apply imply_to_and in Y. destruct Y as [Hd Y].
  pose proof (Rmin_glb_lt e d 0 He Hd) as Hm. specialize (Hb (Rmin e d) Hm).
  destruct (split (close (S k) cluster e) (fun v => close k (first k) d v /\ cluster k + e / 2 < v k)) as [H|H]; [|exact H|contradiction].
  revert Hb. apply mono. intros v [Hv Q]. pose proof (Rmin_l e d). pose proof (Rmin_r e d).
  destruct (Rlt_or_le (cluster k + e / 2) (v k)) as [G|G]; [right|left].
  - split; [|exact G]. intros j Hj. specialize (Hv j Hj). lra.
  - apply C in Hv. intros j Hj. destruct (Nat.eq_dec j k) as [->|N]; [apply Rabs_def1; lra|]. specialize (Hv j ltac:(lia)). lra.
Qed.
End Cluster.

(* ---- rational times ---- *)
Definition rat (c : nat) : R := let (a, b) := of_nat c in let (p, q) := of_nat a in (INR p - INR q) / INR (S b).
Lemma rat_dense t e : 0 < e -> exists c, Rabs (rat c - t) < e.
Proof.
  intros He. destruct (archimed_cor1 e He) as (b & Hb & Pb). assert (B : 0 < INR b) by (apply lt_0_INR; lia).
  set (z := up (t * INR b)). destruct (archimed (t * INR b)) as [A1 A2]. fold z in A1, A2.
  assert (Z : exists p q, INR p - INR q = IZR z).
  { exists (Z.to_nat z), (Z.to_nat (- z)). rewrite !INR_IZR_INZ, <- minus_IZR. f_equal. lia. }
  destruct Z as (p & q & Z). exists (to_nat (to_nat (p, q), pred b)). unfold rat. rewrite cancel_of_to. cbv beta iota. rewrite cancel_of_to. cbv beta iota.
  replace (S (pred b)) with b by lia. rewrite Z. replace (IZR z / INR b - t) with ((IZR z - t * INR b) * / INR b) by (field; lra).
  rewrite Rabs_mult, (Rabs_pos_eq (/ INR b)) by (left; now apply Rinv_0_lt_compat).
  apply Rle_lt_trans with (1 * / INR b); [|lra]. apply Rmult_le_compat_r; [left; now apply Rinv_0_lt_compat|]. apply Rabs_le. lra.
Qed.

Lemma above r : exists N, r < INR N.
Proof.
  exists (Z.to_nat (up r)). destruct (archimed r) as [A _]. rewrite INR_IZR_INZ. eapply Rlt_le_trans; [exact A|]. apply IZR_le. lia.
Qed.
Definition dot (n : nat) (l y : nat -> R) := Sum n (fun i => l i * y i).
Definition near (n : nat) (d : R) (x y : nat -> R) := forall i, (i < n)%nat -> Rabs (x i - y i) < d.
Lemma dot_ext n l y z : (forall i, (i < n)%nat -> y i = z i) -> dot n l y = dot n l z.
Proof. intros H. apply Sum_ext. intros i Hi. now rewrite H. Qed.
Lemma dot_plus n l y z : dot n l (fun i => y i + z i) = dot n l y + dot n l z.
Proof. unfold dot. rewrite <- Sum_plus. apply Sum_ext. intros. ring. Qed.
Lemma dot_scal n l c y : dot n l (fun i => c * y i) = c * dot n l y.
Proof. unfold dot. rewrite <- Sum_scal. apply Sum_ext. intros. ring. Qed.
Lemma dot_gap n l y z e : (forall i, (i < n)%nat -> Rabs (y i - z i) <= e) -> dot n l y <= dot n l z + e * Sum n (fun i => Rabs (l i)).
Proof.
  intros H. unfold dot. rewrite <- Sum_scal, <- Sum_plus. apply Sum_le. intros i Hi. specialize (H i Hi).
  assert (Q : l i * (y i - z i) <= e * Rabs (l i)); [|lra]. eapply Rle_trans; [apply Rle_abs|]. rewrite Rabs_mult, Rmult_comm.
  apply Rmult_le_compat_r; [apply Rabs_pos|exact H].
Qed.

Section Inclusion.
Variables (n : nat) (F : (nat -> R) -> (nat -> R) -> Prop) (M : R) (x0 : nat -> R).
Hypothesis M0 : 0 <= M.
Hypothesis Fext : forall x x' y, (forall i, (i < n)%nat -> x i = x' i) -> F x y -> F x' y.
Hypothesis Fsome : forall x, exists y, F x y.
Hypothesis Fbound : forall x y i, F x y -> (i < n)%nat -> Rabs (y i) <= M.

(* a broken line until T: over each interval the mean slope is in every half-space that contains the values of F on the way, with a delay h *)
Definition approx (h T : R) (x : R -> nat -> R) := (forall i, (i < n)%nat -> x 0 i = x0 i) /\
  (forall i s t, (i < n)%nat -> s <= t -> Rabs (x t i - x s i) <= M * (t - s)) /\
  forall s t, s <= t <= T -> forall l c, (forall u y, 0 <= u -> s - h <= u <= Rmax t 0 -> F (x u) y -> dot n l y <= c) ->
    dot n l (fun i => x t i - x s i) <= c * (t - s).
Lemma approx_weaker h h' T T' x : h <= h' -> T' <= T -> approx h T x -> approx h' T' x.
Proof.
  intros Hh HT (A & B & C). split; [exact A|]. split; [exact B|]. intros s t Hst l c H. apply C; [lra|]. intros u y Hu Hs. apply H; lra.
Qed.
Lemma approx_some h k : 0 < h -> exists x, approx h (INR k * h) x.
Proof.
  intros Hh. induction k as [|k IH].
  - destruct (Fsome x0) as [y Hy]. exists (fun t i => x0 i + t * y i). split; [intros; ring|]. split.
    + intros i s t Hi Hst. replace (x0 i + t * y i - (x0 i + s * y i)) with (y i * (t - s)) by ring. rewrite Rabs_mult, (Rabs_pos_eq (t - s)) by lra.
      apply Rmult_le_compat_r; [lra|]. now apply (Fbound x0 y).
    + cbn [INR]. intros s t Hst l c H. specialize (H 0 y ltac:(lra)).
      rewrite (dot_ext n l _ (fun i => (t - s) * y i)) by (intros; ring). rewrite dot_scal, Rmult_comm. apply Rmult_le_compat_r; [lra|]. apply H.
      * pose proof (Rmax_r t 0). lra.
      * apply (Fext x0); [intros; ring|exact Hy].
  - destruct IH as (x & A & B & C). set (b := INR k * h) in *. assert (B0 : 0 <= b) by (apply Rmult_le_pos; [apply pos_INR|lra]).
    assert (Eb : INR (S k) * h = b + h) by (rewrite S_INR; unfold b; ring). rewrite Eb.
    destruct (Fsome (x b)) as [y Hy]. set (z := fun t : R => if Rle_dec t b then x t else fun i => x b i + (t - b) * y i).
    assert (Z1 : forall t, t <= b -> z t = x t) by (intros t Ht; unfold z; now destruct (Rle_dec t b)).
    assert (Z2 : forall t i, b <= t -> z t i = x b i + (t - b) * y i).
    { intros t i Ht. unfold z. destruct (Rle_dec t b) as [L|L]; [|reflexivity]. replace t with b by lra. ring. }
    assert (Q : forall i s t, (i < n)%nat -> b <= s -> s <= t -> Rabs (z t i - z s i) <= M * (t - s)).
    { intros i s t Hi Hs Ht. rewrite !Z2 by lra. replace (x b i + (t - b) * y i - (x b i + (s - b) * y i)) with (y i * (t - s)) by ring.
      rewrite Rabs_mult, (Rabs_pos_eq (t - s)) by lra. apply Rmult_le_compat_r; [lra|]. now apply (Fbound (x b) y). }
    assert (V : forall s t, b <= s -> s <= t -> forall l c, dot n l y <= c -> dot n l (fun i => z t i - z s i) <= c * (t - s)).
    { intros s t Hs Ht l c H. rewrite (dot_ext n l _ (fun i => (t - s) * y i)); [rewrite dot_scal, Rmult_comm; apply Rmult_le_compat_r; lra|].
      intros i _. rewrite !Z2 by lra. ring. }
    exists z. split; [intros i Hi; rewrite Z1 by lra; now apply A|]. split.
    + intros i s t Hi Hst. destruct (Rle_or_lt t b) as [L|L]; [rewrite !Z1 by lra; now apply B|].
      destruct (Rle_or_lt b s) as [G|G]; [now apply Q|]. replace (z t i - z s i) with (z t i - z b i + (z b i - z s i)) by ring.
      eapply Rle_trans; [apply Rabs_triang|]. pose proof (Q i b t Hi ltac:(lra) ltac:(lra)). rewrite (Z1 b), (Z1 s) in * by lra.
      pose proof (B i s b Hi ltac:(lra)). lra.
    + intros s t Hst l c H.
      assert (Hb : s - h <= b -> b <= t -> dot n l y <= c).
      { intros H1 H2. apply (H b y B0); [|now rewrite Z1 by lra]. pose proof (Rmax_l t 0). lra. }
      destruct (Rle_or_lt t b) as [L|L].
      * rewrite !Z1 by lra. apply C; [lra|]. intros u w Hu Hs Hw. apply (H u w Hu Hs). rewrite Z1; [exact Hw|]. unfold Rmax in Hs. destruct (Rle_dec t 0); lra.
      * destruct (Rle_or_lt b s) as [G|G]; [apply V; try lra; apply Hb; lra|].
        rewrite (dot_ext n l _ (fun i => (z t i - z b i) + (z b i - z s i))) by (intros; ring). rewrite dot_plus.
        pose proof (V b t ltac:(lra) ltac:(lra) l c (Hb ltac:(lra) ltac:(lra))) as V1. rewrite (Z1 s), (Z1 b) in * by lra.
        assert (V2 : dot n l (fun i => x b i - x s i) <= c * (b - s)); [|lra].
        apply C; [lra|]. intros u w Hu Hs Hw. rewrite Rmax_left in Hs by lra. apply (H u w Hu); [|now rewrite Z1 by lra]. pose proof (Rmax_l t 0). lra.
Qed.
Definition level (N : nat) := approx (/ (INR N + 1)) (INR N).
Lemma level_some N : exists x, level N x.
Proof.
  assert (P : 0 < INR N + 1) by (pose proof (pos_INR N); lra).
  destruct (approx_some (/ (INR N + 1)) (N * S N)) as [x Hx]; [now apply Rinv_0_lt_compat|].
  exists x. revert Hx. apply approx_weaker; [lra|]. rewrite mult_INR, S_INR. right. field. lra.
Qed.
Lemma level_weaker N N' x : (N <= N')%nat -> level N' x -> level N x.
Proof.
  intros H. apply le_INR in H. pose proof (pos_INR N). apply approx_weaker; [|exact H]. apply Rinv_le_contravar; lra.
Qed.

Definition coord (x : R -> nat -> R) k := let (c, i) := of_nat k in if Nat.ltb i n then x (rat c) i else 0.
Definition often (P : (nat -> R) -> Prop) := forall N, exists x, level N x /\ P (coord x).
Definition val c i := cluster often (to_nat (c, i)).
Lemma val_close K e N : 0 < e -> exists x, level N x /\ forall c i, (i < n)%nat -> (to_nat (c, i) < K)%nat -> Rabs (x (rat c) i - val c i) < e.
Proof.
  intros He. destruct (cluster_point often) with (k := K) (e := e) (5 := He) (N := N) as (x & Hx & C).
  - intros P Q H S N'. destruct (S N') as (x & Hx & Px). exists x. split; [exact Hx|]. now apply H.
  - intros P Q H. destruct (classic (often P)) as [Y|Y]; [now left|right]. intros N'. apply not_all_ex_not in Y. destruct Y as [N1 Y].
    destruct (H (max N1 N')) as (x & Hx & [HP|HQ]).
    + exfalso. apply Y. exists x. split; [|exact HP]. revert Hx. apply level_weaker. lia.
    + exists x. split; [|exact HQ]. revert Hx. apply level_weaker. lia.
  - intros N'. destruct (level_some N') as [x Hx]. exists x. now split.
  - intros k. destruct (of_nat k) as [c i] eqn:E.
    exists (Rabs (x0 i) + M * Rabs (rat c)). intros H. destruct (H 0%nat) as (x & (A & B & _) & Q). revert Q.
    pose proof (Rabs_pos (x0 i)). pose proof (Rabs_pos (rat c)). assert (0 <= M * Rabs (rat c)) by (now apply Rmult_le_pos).
    unfold coord. rewrite E. destruct (Nat.ltb_spec i n) as [L|L]; [|rewrite Rabs_R0; lra]. apply Rle_not_lt.
    replace (x (rat c) i) with (x0 i + (x (rat c) i - x 0 i)) by (rewrite (A i L); ring). eapply Rle_trans; [apply Rabs_triang|]. apply Rplus_le_compat_l.
    destruct (Rle_or_lt 0 (rat c)) as [G|G].
    + eapply Rle_trans; [apply (B i 0 (rat c) L G)|]. rewrite (Rabs_pos_eq (rat c)) by lra. lra.
    + rewrite Rabs_minus_sym. eapply Rle_trans; [apply (B i (rat c) 0 L); lra|]. rewrite (Rabs_left (rat c)) by lra. lra.
  - exists x. split; [exact Hx|]. intros c i Hi HK. specialize (C _ HK). unfold coord, val in *. rewrite cancel_of_to in C. cbv beta iota in C.
    apply Nat.ltb_lt in Hi. rewrite Hi in C. exact C.
Qed.
Lemma val_lipschitz c c' i : (i < n)%nat -> Rabs (val c i - val c' i) <= M * Rabs (rat c - rat c').
Proof.
  intros Hi. apply Rnot_lt_le. intros L. set (e := (Rabs (val c i - val c' i) - M * Rabs (rat c - rat c')) / 2).
  destruct (val_close (S (max (to_nat (c, i)) (to_nat (c', i)))) e 0) as (x & (_ & B & _) & C); [unfold e; lra|].
  pose proof (C c i Hi ltac:(lia)) as C1. pose proof (C c' i Hi ltac:(lia)) as C2.
  assert (G : Rabs (x (rat c) i - x (rat c') i) <= M * Rabs (rat c - rat c')).
  { destruct (Rle_or_lt (rat c) (rat c')) as [G|G].
    - rewrite Rabs_minus_sym, (Rabs_minus_sym (rat c)), (Rabs_pos_eq (rat c' - rat c)) by lra. now apply B.
    - rewrite (Rabs_pos_eq (rat c - rat c')) by lra. apply B; [exact Hi|lra]. }
  pose proof (Rabs_triang (x (rat c) i - x (rat c') i) (val c i - x (rat c) i + (x (rat c') i - val c' i))) as T1.
  pose proof (Rabs_triang (val c i - x (rat c) i) (x (rat c') i - val c' i)) as T2. rewrite (Rabs_minus_sym (val c i)) in T2.
  replace (x (rat c) i - x (rat c') i + (val c i - x (rat c) i + (x (rat c') i - val c' i))) with (val c i - val c' i) in T1 by ring. unfold e in *. lra.
Qed.
Definition lower t i z := exists c, z = val c i - M * Rabs (t - rat c).
Definition solution (t : R) (i : nat) : R := real (Lub_Rbar (lower t i)).
Lemma solution_lub t i : (i < n)%nat -> is_lub (lower t i) (solution t i).
Proof.
  intros Hi. apply (lub_is _ (val 0 i - M * Rabs (t - rat 0)) (val 0 i + M * Rabs (t - rat 0))); [now exists 0%nat|].
  intros b [c ->]. pose proof (val_lipschitz c 0 i Hi) as L. pose proof (Rle_abs (val c i - val 0 i)).
  pose proof (Rabs_triang (t - rat 0) (- (t - rat c))) as T. replace (t - rat 0 + - (t - rat c)) with (rat c - rat 0) in T by ring. rewrite Rabs_Ropp in T.
  apply (Rmult_le_compat_l M) in T; [|exact M0]. lra.
Qed.
Lemma solution_rat c i : (i < n)%nat -> solution (rat c) i = val c i.
Proof.
  intros Hi. destruct (solution_lub (rat c) i Hi) as [U L]. apply Rle_antisym.
  - apply L. intros b [c' ->]. pose proof (val_lipschitz c' c i Hi). pose proof (Rle_abs (val c' i - val c i)). rewrite (Rabs_minus_sym (rat c)). lra.
  - apply U. exists c. rewrite Rminus_eq_0, Rabs_R0. ring.
Qed.
Lemma solution_below s t i : (i < n)%nat -> solution t i <= solution s i + M * Rabs (t - s).
Proof.
  intros Hi. apply (solution_lub t i Hi). intros b [c ->]. assert (L : val c i - M * Rabs (s - rat c) <= solution s i) by (apply (solution_lub s i Hi); now exists c).
  pose proof (Rabs_triang (t - rat c) (- (t - s))) as T. replace (t - rat c + - (t - s)) with (s - rat c) in T by ring. rewrite Rabs_Ropp in T.
  apply (Rmult_le_compat_l M) in T; [|exact M0]. lra.
Qed.
Theorem solution_lipschitz s t i : (i < n)%nat -> Rabs (solution t i - solution s i) <= M * Rabs (t - s).
Proof. intros Hi. pose proof (solution_below s t i Hi). pose proof (solution_below t s i Hi). rewrite (Rabs_minus_sym s t) in *. apply Rabs_le. lra. Qed.
Lemma code_bound m c : exists K, forall i, (i < m)%nat -> (to_nat (c, i) < K)%nat.
Proof.
  induction m as [|m [K H]]; [exists 0%nat; intros; lia|]. exists (max K (S (to_nat (c, m)))). intros i Hi.
  destruct (Nat.eq_dec i m) as [->|]; [lia|]. specialize (H i ltac:(lia)). lia.
Qed.
Lemma approx_lip h T x i s t : approx h T x -> (i < n)%nat -> Rabs (x t i - x s i) <= M * Rabs (t - s).
Proof.
  intros (_ & B & _) Hi. destruct (Rle_or_lt s t) as [G|G].
  - rewrite (Rabs_pos_eq (t - s)) by lra. now apply B.
  - rewrite (Rabs_minus_sym (x t i)), (Rabs_minus_sym t), (Rabs_pos_eq (s - t)) by lra. apply B; [exact Hi|lra].
Qed.
Lemma solution_close s t e N : 0 < e -> exists x, level N x /\ forall i, (i < n)%nat -> Rabs (x s i - solution s i) < e /\ Rabs (x t i - solution t i) < e.
Proof.
  intros He. set (d := e / (4 * (M + 1))). assert (Hd : 0 < d) by (apply Rdiv_lt_0_compat; lra).
  assert (Md : M * d <= e / 4). { unfold d. replace (M * (e / (4 * (M + 1)))) with (e / 4 * (M / (M + 1))) by (field; lra).
    rewrite <- (Rmult_1_r (e / 4)) at 2. apply Rmult_le_compat_l; [lra|]. apply Rmult_le_reg_r with (M + 1); [lra|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l; lra. }
  destruct (rat_dense s d Hd) as [c Hc]. destruct (rat_dense t d Hd) as [c' Hc']. destruct (code_bound n c) as [K HK]. destruct (code_bound n c') as [K' HK'].
  destruct (val_close (max K K') (e / 4) N ltac:(lra)) as (x & Hx & C). exists x. split; [exact Hx|]. intros i Hi.
  assert (G : forall c r, Rabs (rat c - r) < d -> (to_nat (c, i) < max K K')%nat -> Rabs (x r i - solution r i) < e).
  { intros b r Hb Hk. pose proof (C b i Hi Hk) as C1. pose proof (approx_lip _ _ x i (rat b) r Hx Hi) as C2.
    pose proof (solution_lipschitz r (rat b) i Hi) as C3. rewrite (solution_rat b i Hi) in C3. rewrite (Rabs_minus_sym r) in C2.
    assert (Q : M * Rabs (rat b - r) <= e / 4) by (eapply Rle_trans; [apply Rmult_le_compat_l; [exact M0|left; exact Hb]|exact Md]).
    replace (x r i - solution r i) with (x r i - x (rat b) i + (x (rat b) i - val b i) + (val b i - solution r i)) by ring.
    eapply Rle_lt_trans; [apply Rabs_triang|]. eapply Rle_lt_trans; [apply Rplus_le_compat_r, Rabs_triang|]. lra. }
  specialize (HK i Hi). specialize (HK' i Hi). split; [exact (G c s Hc ltac:(lia))|exact (G c' t Hc' ltac:(lia))].
Qed.
Theorem solution_start i : (i < n)%nat -> solution 0 i = x0 i.
Proof.
  intros Hi. apply cond_eq. intros e He. destruct (solution_close 0 0 e 0 He) as (x & (A & _) & C). destruct (C i Hi) as [C1 _].
  rewrite (A i Hi), Rabs_minus_sym in C1. exact C1.
Qed.
(* the mean slope between t0 >= 0 and t is in every half-space that contains the values of F near the state at t0 *)
Theorem solution_slope t0 s t d l c : 0 <= t0 -> s <= t -> s = t0 \/ t = t0 -> 0 < d ->
  (forall x y, near n (M * (t - s) + d) x (solution t0) -> F x y -> dot n l y <= c) -> dot n l (fun i => solution t i - solution s i) <= c * (t - s).
Proof.
  intros H0 Hst H Hd K. destruct (Req_dec s t) as [->|Ne].
  { rewrite (dot_ext n l _ (fun _ => 0)) by (intros; ring). unfold dot. rewrite (Sum_ext n _ (fun _ => 0)) by (intros; ring). rewrite Sum_0. lra. }
  set (S1 := Sum n (fun i => Rabs (l i))). assert (S0 : 0 <= S1) by (apply Sum_ge0; intros; apply Rabs_pos).
  apply Rnot_lt_le. intros L. set (gap := dot n l (fun i => solution t i - solution s i) - c * (t - s)).
  set (e := Rmin (d / 4) (gap / (2 * (S1 + 1)))). assert (Hg : 0 < gap) by (unfold gap; lra).
  assert (He : 0 < e) by (apply Rmin_glb_lt; [lra|]; apply Rdiv_lt_0_compat; lra).
  assert (E1 : e <= d / 4) by apply Rmin_l. assert (E2 : 2 * e * S1 < gap).
  { apply Rle_lt_trans with (2 * (gap / (2 * (S1 + 1))) * S1); [apply Rmult_le_compat_r; [exact S0|]; apply Rmult_le_compat_l; [lra|apply Rmin_r]|].
    replace (2 * (gap / (2 * (S1 + 1))) * S1) with (gap * (S1 / (S1 + 1))) by (field; lra). rewrite <- (Rmult_1_r gap) at 2. apply Rmult_lt_compat_l; [exact Hg|].
    apply Rmult_lt_reg_r with (S1 + 1); [lra|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l; lra. }
  assert (X : exists N, t <= INR N /\ M * / (INR N + 1) < d / 2 /\ / (INR N + 1) <= t - s).
  { destruct (above (Rabs t + 2 * M / d + / (t - s))) as [N HN]. exists N. pose proof (Rle_abs t). pose proof (Rabs_pos t).
    assert (G1 : 0 <= 2 * M / d) by (apply Rmult_le_pos; [lra|left; now apply Rinv_0_lt_compat]).
    assert (G2 : 0 < / (t - s)) by (apply Rinv_0_lt_compat; lra).
    split; [lra|]. split.
    - apply Rmult_lt_reg_r with (INR N + 1); [lra|]. rewrite Rmult_assoc, Rinv_l by lra.
      apply Rle_lt_trans with (d / 2 * (2 * M / d)); [right; field; lra|]. apply Rmult_lt_compat_l; lra.
    - rewrite <- (Rinv_inv (t - s)). apply Rinv_le_contravar; [exact G2|lra]. }
  destruct X as (N & X1 & X2 & X3). destruct (solution_close s t e N He) as (x & Hx & C). pose proof Hx as (_ & _ & A).
  assert (G : dot n l (fun i => x t i - x s i) <= c * (t - s)).
  { apply A; [lra|]. intros u y Hu Hr Fy. apply (K (x u) y); [|exact Fy]. intros i Hi. destruct (C i Hi) as [C1 C2].
    assert (Ct : Rabs (x t0 i - solution t0 i) < e) by (destruct H as [->| ->]; assumption).
    pose proof (approx_lip _ _ x i t0 u Hx Hi) as C3. assert (Cu : Rabs (u - t0) <= t - s + / (INR N + 1)).
    { assert (0 < / (INR N + 1)) by (apply Rinv_0_lt_compat; pose proof (pos_INR N); lra).
      unfold Rmax in Hr. destruct (Rle_dec t 0), H as [E|E]; apply Rabs_le; lra. }
    apply (Rmult_le_compat_l M) in Cu; [|exact M0]. replace (x u i - solution t0 i) with (x u i - x t0 i + (x t0 i - solution t0 i)) by ring.
    eapply Rle_lt_trans; [apply Rabs_triang|]. lra. }
  pose proof (dot_gap n l (fun i => solution t i - solution s i) (fun i => x t i - x s i) (2 * e)) as Q. fold S1 in Q.
  assert (Q' : dot n l (fun i => solution t i - solution s i) <= dot n l (fun i => x t i - x s i) + 2 * e * S1); [|unfold gap in *; lra].
  apply Q. intros i Hi. destruct (C i Hi) as [C1 C2].
  replace (solution t i - solution s i - (x t i - x s i)) with ((x s i - solution s i) - (x t i - solution t i)) by ring.
  eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_Ropp. lra.
Qed.
(* so are derivatives *)
Definition hull (x z : nat -> R) := forall l c d, 0 < d -> (forall x' y, near n d x' x -> F x' y -> dot n l y <= c) -> dot n l z <= c.
Theorem solution_derivative t z : 0 <= t -> (forall i, (i < n)%nat -> is_derive (fun s => solution s i) t (z i)) -> hull (solution t) z.
Proof.
  intros Ht D l c d Hd K.
  assert (Dl : is_derive (fun s => dot n l (solution s)) t (dot n l z)).
  { apply D_Sum. intros i Hi. apply D_scal. now apply D. }
  apply Rnot_lt_le. intros L. apply is_derive_Reals in Dl. destruct (Dl (dot n l z - c) ltac:(lra)) as [h Hh]. pose proof (cond_pos h) as Ph.
  set (k := Rmin (h / 2) (d / (2 * (M + 1)))). assert (Hk : 0 < k) by (apply Rmin_glb_lt; [lra|apply Rdiv_lt_0_compat; lra]).
  assert (k <= h / 2) by apply Rmin_l.
  assert (Mk : M * k <= d / 2).
  { apply Rle_trans with ((M + 1) * k); [apply Rmult_le_compat_r; lra|]. apply Rle_trans with ((M + 1) * (d / (2 * (M + 1)))).
    - apply Rmult_le_compat_l; [lra|apply Rmin_r].
    - right. field. lra. }
  specialize (Hh k ltac:(lra)). rewrite Rabs_pos_eq in Hh by lra. specialize (Hh ltac:(lra)).
  pose proof (solution_slope t t (t + k) (d / 2) l c Ht ltac:(lra) (or_introl eq_refl) ltac:(lra)) as G.
  assert (G' : dot n l (fun i => solution (t + k) i - solution t i) <= c * k).
  { replace (c * k) with (c * (t + k - t)) by ring. apply G. intros x y Nx. apply K. intros i Hi. specialize (Nx i Hi). lra. }
  rewrite (dot_ext n l _ (fun i => solution (t + k) i + (-1) * solution t i)) in G' by (intros; ring). rewrite dot_plus, dot_scal in G'.
  apply Rabs_def2 in Hh. destruct Hh as [_ Hh].
  assert (Q : (dot n l (solution (t + k)) - dot n l (solution t)) / k <= c); [|lra].
  apply Rmult_le_reg_r with k; [exact Hk|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. lra.
Qed.
End Inclusion.

(* ---- continuous right-hand sides ---- *)
Definition continuous_at n (f : (nat -> R) -> nat -> R) x := forall e, 0 < e -> exists d, 0 < d /\
  forall y, near n d y x -> forall i, (i < n)%nat -> Rabs (f y i - f x i) < e.
Lemma dot_delta n k y : (k < n)%nat -> dot n (delta k) y = y k.
Proof. intros. unfold dot. now apply Sum_delta_l. Qed.
Lemma dot_delta_opp n k y : (k < n)%nat -> dot n (fun i => - delta k i) y = - y k.
Proof. intros. unfold dot. rewrite (Sum_ext n _ (fun i => - (delta k i * y i))) by (intros; ring). rewrite Sum_opp. f_equal. now apply Sum_delta_l. Qed.
(* Peano: a bounded continuous field has a solution for all t >= 0 from every start *)
Theorem peano n (f : (nat -> R) -> nat -> R) M x0 : (forall x i, (i < n)%nat -> Rabs (f x i) <= M) -> (forall x, continuous_at n f x) ->
  exists x : R -> nat -> R, (forall i, (i < n)%nat -> x 0 i = x0 i) /\ forall t i, 0 <= t -> (i < n)%nat -> is_derive (fun s => x s i) t (f (x t) i).
Proof.
  intros B C. destruct n as [|n']; [exists (fun _ _ => 0); split; intros; lia|]. set (n := S n') in *.
  assert (M0 : 0 <= M) by (eapply Rle_trans; [apply Rabs_pos|apply (B x0 0%nat); unfold n; lia]).
  set (F := fun x y : nat -> R => forall i, (i < n)%nat -> y i = f x i).
  assert (Fext : forall x x' y, (forall i, (i < n)%nat -> x i = x' i) -> F x y -> F x' y).
  { intros x x' y E H i Hi. rewrite (H i Hi). apply cond_eq. intros e He. destruct (C x' e He) as (d & Hd & K). apply K; [|exact Hi].
    intros j Hj. rewrite (E j Hj), Rminus_eq_0, Rabs_R0. exact Hd. }
  assert (Fsome : forall x, exists y, F x y) by (intros x; exists (f x); intros i _; reflexivity).
  assert (Fb : forall x y i, F x y -> (i < n)%nat -> Rabs (y i) <= M) by (intros x y i H Hi; rewrite (H i Hi); now apply B).
  exists (solution n F M x0). split; [intros; now apply solution_start|]. intros t k Ht Hk. apply is_derive_Reals. intros e He.
  destruct (C (solution n F M x0 t) (e / 2) ltac:(lra)) as (d & Hd & K).
  assert (Hdel : 0 < d / (2 * (M + 1))) by (apply Rdiv_lt_0_compat; lra). exists (mkposreal _ Hdel). cbn. intros h Nh Hh.
  assert (Mh : M * Rabs h <= d / 2).
  { apply Rle_trans with ((M + 1) * Rabs h); [apply Rmult_le_compat_r; [apply Rabs_pos|lra]|]. apply Rle_trans with ((M + 1) * (d / (2 * (M + 1)))).
    - apply Rmult_le_compat_l; [lra|now left].
    - right. field. lra. }
  set (fx := f (solution n F M x0 t)) in *. set (g := solution n F M x0) in *.
  assert (U : forall s u, s <= u -> s = t \/ u = t -> u - s = Rabs h -> Rabs (g u k - g s k - fx k * (u - s)) <= e / 2 * (u - s)).
  { intros s u Hsu E Eh.
    assert (N1 : forall x y, near n (M * (u - s) + d / 2) x (g t) -> F x y -> Rabs (y k - fx k) < e / 2).
    { intros x y Nx Fy. rewrite (Fy k Hk). apply K; [|exact Hk]. intros i Hi. specialize (Nx i Hi). rewrite Eh in Nx. lra. }
    pose proof (solution_slope n F M x0 M0 Fext Fsome Fb t s u (d / 2) (delta k) (fx k + e / 2) Ht Hsu E ltac:(lra)) as A1.
    pose proof (solution_slope n F M x0 M0 Fext Fsome Fb t s u (d / 2) (fun i => - delta k i) (- fx k + e / 2) Ht Hsu E ltac:(lra)) as A2.
    rewrite dot_delta in A1 by exact Hk. rewrite dot_delta_opp in A2 by exact Hk. fold g in A1, A2.
    assert (A1' : g u k - g s k <= (fx k + e / 2) * (u - s)).
    { apply A1. intros x y Nx Fy. rewrite dot_delta by exact Hk. pose proof (N1 x y Nx Fy) as Q. apply Rabs_def2 in Q. lra. }
    assert (A2' : - (g u k - g s k) <= (- fx k + e / 2) * (u - s)).
    { apply A2. intros x y Nx Fy. rewrite dot_delta_opp by exact Hk. pose proof (N1 x y Nx Fy) as Q. apply Rabs_def2 in Q. lra. }
    apply Rabs_le. lra. }
  assert (Ph : 0 < Rabs h) by now apply Rabs_pos_lt.
  assert (V : Rabs (g (t + h) k - g t k - fx k * h) <= e / 2 * Rabs h).
  { destruct (Rle_or_lt 0 h) as [G|G].
    - specialize (U t (t + h) ltac:(lra) (or_introl eq_refl)). replace (t + h - t) with h in U by ring. rewrite (Rabs_pos_eq h) in * by lra. now apply U.
    - specialize (U (t + h) t ltac:(lra) (or_intror eq_refl)). replace (t - (t + h)) with (- h) in U by ring. rewrite (Rabs_left h) in * by lra.
      specialize (U eq_refl). rewrite <- Rabs_Ropp. eapply Rle_trans; [|exact U]. right. f_equal. ring. }
  replace ((g (t + h) k - g t k) / h - fx k) with ((g (t + h) k - g t k - fx k * h) / h) by (now field).
  unfold Rdiv at 1. rewrite Rabs_mult, Rabs_inv by exact Nh. apply Rle_lt_trans with (e / 2 * Rabs h * / Rabs h).
  - apply Rmult_le_compat_r; [left; now apply Rinv_0_lt_compat|exact V].
  - rewrite Rmult_assoc, Rinv_r; lra.
Qed.

(* ---- motions that go on ---- *)
(* what holds at a time if it holds before, and then goes on holding, holds always *)
Lemma real_induction (P : R -> Prop) : (forall t, 0 <= t -> (forall u, 0 <= u < t -> P u) -> P t) ->
  (forall t, 0 <= t -> P t -> exists e, 0 < e /\ forall u, t <= u < t + e -> P u) -> forall t, 0 <= t -> P t.
Proof.
  intros A B t Ht. apply NNPP. intros N. set (E := fun s => 0 <= s /\ forall u, 0 <= u < s -> P u).
  assert (U : forall s, E s -> s <= t).
  { intros s [_ Hs]. apply Rnot_lt_le. intros L. apply N, Hs. lra. }
  destruct (completeness E) as [m [M1 M2]]; [exists t; exact U|exists 0; split; [lra|intros; lra]|].
  assert (Hm : 0 <= m) by (apply M1; split; [lra|intros; lra]).
  assert (Pm : P m).
  { apply A; [exact Hm|]. intros u Hu. apply NNPP. intros Nu. assert (m <= u); [|lra]. apply M2. intros s [_ Hs]. apply Rnot_lt_le. intros L. apply Nu, Hs. lra. }
  destruct (B m Hm Pm) as (e & He & K). assert (E (m + e)); [|specialize (M1 _ H); lra].
  split; [lra|]. intros u Hu. destruct (Rle_or_lt m u) as [L|L]; [apply K; lra|].
  apply A; [lra|]. intros x Hx. apply NNPP. intros Nx. assert (m <= x); [|lra]. apply M2. intros s [_ Hs]. apply Rnot_lt_le. intros G. apply Nx, Hs. lra.
Qed.
Lemma slope_le (f f' : R -> R) B s t : s <= t -> (forall u, s <= u <= t -> is_derive f u (f' u) /\ Rabs (f' u) <= B) -> Rabs (f t - f s) <= B * (t - s).
Proof.
  intros Hst H. apply Rabs_le. split.
  - assert (X : forall u, s <= u <= t -> is_derive (fun u => - f u) u (- f' u)) by (intros; apply D_opp; now apply H).
    pose proof (decreasing (fun u => - f u + - B * u) (fun u => - f' u + - B * 1) s t Hst) as G.
    assert (- f t + - B * t <= - f s + - B * s); [|lra]. apply G.
    + intros u Hu. apply D_plus; [now apply X|]. apply D_scal, D_id.
    + intros u Hu. destruct (H u Hu) as [_ Hb]. apply Rabs_le_between in Hb. lra.
  - pose proof (decreasing (fun u => f u + - B * u) (fun u => f' u + - B * 1) s t Hst) as G.
    assert (f t + - B * t <= f s + - B * s); [|lra]. apply G.
    + intros u Hu. apply D_plus; [now apply H|]. apply D_scal, D_id.
    + intros u Hu. destruct (H u Hu) as [_ Hb]. apply Rabs_le_between in Hb. lra.
Qed.
(* a function that is Lipschitz before T has a limit there *)
Definition end_limit (f : R -> R) B T := real (Lub_Rbar (fun z => exists u, 0 <= u < T /\ z = f u - B * (T - u))).
Lemma end_limit_near f B T t : 0 < T -> 0 <= B -> (forall s u, 0 <= s <= u -> u < T -> Rabs (f u - f s) <= B * (u - s)) -> 0 <= t < T ->
  Rabs (f t - end_limit f B T) <= B * (T - t).
Proof.
  intros HT HB L Ht. set (E := fun z => exists u, 0 <= u < T /\ z = f u - B * (T - u)).
  assert (U : forall s, 0 <= s < T -> forall z, E z -> z <= f s + B * (T - s)).
  { intros s Hs z (u & Hu & ->). destruct (Rle_or_lt u s) as [G|G].
    - pose proof (L u s ltac:(lra) ltac:(lra)) as Q. apply Rabs_le_between in Q. assert (B * (s - u) <= B * (T - u)) by (apply Rmult_le_compat_l; lra).
      assert (0 <= B * (T - s)) by (apply Rmult_le_pos; lra). lra.
    - pose proof (L s u ltac:(lra) ltac:(lra)) as Q. apply Rabs_le_between in Q. assert (B * (u - s) <= B * (T - s)) by (apply Rmult_le_compat_l; lra).
      assert (0 <= B * (T - u)) by (apply Rmult_le_pos; lra). lra. }
  destruct (lub_is E (f t - B * (T - t)) (f t + B * (T - t))) as [U1 U2]; [exists t; split; [lra|reflexivity]|now apply U|].
  fold (end_limit f B T) in U1, U2. fold E in U1, U2. change (real (Lub_Rbar E)) with (end_limit f B T) in *.
  assert (f t - B * (T - t) <= end_limit f B T) by (apply U1; exists t; split; [lra|reflexivity]).
  assert (end_limit f B T <= f t + B * (T - t)) by (apply U2; intros z Hz; now apply U). apply Rabs_le. lra.
Qed.
(* a motion until T of a bounded continuous field goes on for all time *)
Theorem peano_on n (f : (nat -> R) -> nat -> R) M T (x : R -> nat -> R) : (forall x i, (i < n)%nat -> Rabs (f x i) <= M) -> (forall x, continuous_at n f x) ->
  0 < T -> (forall t i, 0 <= t < T -> (i < n)%nat -> is_derive (fun s => x s i) t (f (x t) i)) ->
  exists y : R -> nat -> R, (forall t, t < T -> y t = x t) /\ forall t i, 0 <= t -> (i < n)%nat -> is_derive (fun s => y s i) t (f (y t) i).
Proof.
  intros B C HT D. destruct n as [|n']; [exists x; split; [reflexivity|intros; lia]|]. set (n := S n') in *.
  assert (M0 : 0 <= M) by (eapply Rle_trans; [apply Rabs_pos|apply (B (fun _ => 0) 0%nat); unfold n; lia]).
  assert (L : forall i s u, (i < n)%nat -> 0 <= s <= u -> u < T -> Rabs (x u i - x s i) <= M * (u - s)).
  { intros i s u Hi Hs Hu. apply (slope_le (fun t => x t i) (fun t => f (x t) i)); [lra|]. intros t Ht. split; [apply D; [lra|exact Hi]|now apply B]. }
  set (xT := fun i => end_limit (fun t => x t i) M T).
  assert (E : forall t i, 0 <= t < T -> (i < n)%nat -> Rabs (x t i - xT i) <= M * (T - t)).
  { intros t i Ht Hi. apply (end_limit_near (fun t => x t i) M T t HT M0); [intros; now apply L|exact Ht]. }
  destruct (peano n f M xT B C) as (z & Z0 & Z1).
  set (y := fun t => if Rlt_dec t T then x t else z (t - T)). exists y.
  assert (Y1 : forall t, t < T -> y t = x t) by (intros t Ht; unfold y; destruct (Rlt_dec t T); [reflexivity|contradiction]).
  assert (Y2 : forall t, T <= t -> y t = z (t - T)) by (intros t Ht; unfold y; destruct (Rlt_dec t T); [lra|reflexivity]).
  split; [exact Y1|]. intros t i Ht Hi. destruct (Rtotal_order t T) as [H|[H|H]].
  - rewrite (Y1 t H). apply (is_derive_ext_loc (fun s => x s i)); [|apply D; [lra|exact Hi]].
    assert (P : 0 < T - t) by lra. exists (mkposreal _ P). intros s Hs. cbn in Hs. unfold ball in Hs. cbn in Hs. unfold AbsRing_ball, abs, minus, plus, opp in Hs. cbn in Hs.
    apply Rabs_def2 in Hs. symmetry. now rewrite (Y1 s) by lra.
  - subst t. apply is_derive_Reals. intros e He.
    assert (Zr : derivable_pt_lim (fun s => z s i) 0 (f (z 0) i)) by (apply is_derive_Reals, Z1; [lra|exact Hi]).
    destruct (Zr e He) as [d1 K1]. rewrite (Y2 T ltac:(lra)), Rminus_eq_0.
    destruct (C (z 0) (e / 2) ltac:(lra)) as (d2 & Hd2 & K2). pose proof (cond_pos d1).
    set (d := Rmin (Rmin d1 T) (d2 / (M + 1))). assert (Hd : 0 < d) by (repeat apply Rmin_glb_lt; try lra; apply Rdiv_lt_0_compat; lra).
    assert (d <= d1 /\ d <= T /\ (M + 1) * d <= d2) as (Q1 & Q2 & Q3).
    { pose proof (Rmin_l (Rmin d1 T) (d2 / (M + 1))). pose proof (Rmin_l d1 T). pose proof (Rmin_r d1 T). fold d in H0. repeat split; try lra.
      apply Rle_trans with ((M + 1) * (d2 / (M + 1))); [apply Rmult_le_compat_l; [lra|apply Rmin_r]|right; field; lra]. }
    exists (mkposreal d Hd). cbn. intros h Nh Hh. destruct (Rle_or_lt 0 h) as [G|G].
    + rewrite Y2 by lra. replace (T + h - T) with (0 + h) by ring. specialize (K1 h Nh ltac:(lra)). exact K1.
    + rewrite Rabs_left in Hh by lra. rewrite (Z0 i Hi), (Y1 (T + h)) by lra. set (c := f (z 0) i).
      assert (V : Rabs (xT i - x (T + h) i - c * (- h)) <= e / 2 * (- h)).
      { apply Rnot_lt_le. intros F. set (gap := Rabs (xT i - x (T + h) i - c * (- h)) - e / 2 * (- h)).
        assert (M1 : 0 <= Rabs c) by apply Rabs_pos. set (k := Rmin (- h / 2) (gap / (2 * (M + Rabs c + 1)))).
        assert (Hk : 0 < k) by (apply Rmin_glb_lt; [lra|apply Rdiv_lt_0_compat; unfold gap; lra]).
        assert (k <= - h / 2) by apply Rmin_l.
        assert (Gk : (M + Rabs c) * k <= gap / 2).
        { apply Rle_trans with ((M + Rabs c + 1) * k); [apply Rmult_le_compat_r; lra|]. apply Rle_trans with ((M + Rabs c + 1) * (gap / (2 * (M + Rabs c + 1)))).
          - apply Rmult_le_compat_l; [lra|apply Rmin_r].
          - right. field. lra. }
        assert (W : Rabs (x (T - k) i - c * (T - k) - (x (T + h) i - c * (T + h))) <= e / 2 * (T - k - (T + h))).
        { apply (slope_le (fun t => x t i - c * t) (fun t => f (x t) i - c * 1)); [lra|]. intros t Ht'. split; [apply D_minus; [apply D; [lra|exact Hi]|apply D_scal, D_id]|].
          rewrite Rmult_1_r. left. apply K2; [|exact Hi]. intros j Hj. rewrite (Z0 j Hj). eapply Rle_lt_trans; [apply E; [lra|exact Hj]|].
          apply Rlt_le_trans with ((M + 1) * d); [|exact Q3]. apply Rle_lt_trans with (M * d); [apply Rmult_le_compat_l; lra|]. lra. }
        pose proof (E (T - k) i ltac:(lra) Hi) as E1. rewrite Rabs_minus_sym in E1.
        assert (T1 : Rabs (xT i - x (T + h) i - c * - h) <= Rabs (xT i - x (T - k) i) + Rabs (- (c * k)) + Rabs (x (T - k) i - c * (T - k) - (x (T + h) i - c * (T + h)))).
        { replace (xT i - x (T + h) i - c * - h) with (xT i - x (T - k) i + - (c * k) + (x (T - k) i - c * (T - k) - (x (T + h) i - c * (T + h)))) by ring.
          eapply Rle_trans; [apply Rabs_triang|]. apply Rplus_le_compat_r. apply Rabs_triang. }
        rewrite Rabs_Ropp, Rabs_mult, (Rabs_pos_eq k) in T1 by lra.
        assert (M * (T - (T - k)) = M * k) by ring. assert (e / 2 * (T - k - (T + h)) <= e / 2 * (- h)) by (apply Rmult_le_compat_l; lra). unfold gap in *. lra. }
      replace ((x (T + h) i - xT i) / h - c) with ((xT i - x (T + h) i - c * - h) / (- h)) by (field; lra). unfold Rdiv at 1. rewrite Rabs_mult, (Rabs_pos_eq (/ - h)).
      * apply Rle_lt_trans with (e / 2 * - h * / - h); [apply Rmult_le_compat_r; [left; apply Rinv_0_lt_compat; lra|exact V]|]. rewrite Rmult_assoc, Rinv_r; lra.
      * left. apply Rinv_0_lt_compat. lra.
  - rewrite (Y2 t ltac:(lra)). apply (is_derive_ext_loc (fun s => z (s - T) i)).
    + assert (P : 0 < t - T) by lra. exists (mkposreal _ P). intros s Hs. cbn in Hs. unfold ball in Hs. cbn in Hs. unfold AbsRing_ball, abs, minus, plus, opp in Hs. cbn in Hs.
      apply Rabs_def2 in Hs. now rewrite (Y2 s) by lra.
    + eapply D_eq; [apply (D_comp (fun s => z s i) (fun s => s - T)); [apply (Z1 (t - T) i ltac:(lra) Hi)|apply D_minus; [apply D_id|apply D_const]]|]. ring.
Qed.
