(* Tanner, Jadbabaie, Pappas, links by distance: solutions of (10) after Definition 4 (Filippov), with K of the whole vector field.
   All pairs keep a distance that the start allows, and velocities come to agree while the graph is connected.
     tanner2.arbswitch (corrected, clause 1), tanner2.thm2_vel, tanner2.thm2_coll. *)
From Coq Require Import Reals Lra Lia Psatz Classical Arith.Cantor.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums paley_model paley_phase paley_laplacian paley_gradient tanner_energy tanner_flock.
From Flockproof Require tanner_saturated tanner_trees tanner2_facts tanner2_distance.
Open Scope R_scope.

(* ---- the law and its solutions ---- *)
(* the force of j on i, the control (4), links by distance as in (10) *)
Definition pull (adj : graph) (V' : nat -> nat -> R -> R) (r : nat -> C) (i j : nat) : C :=
  (if adj i j then RtoC (V' i j (Cmod (r i - r j)) / Cmod (r i - r j)) * (r i - r j) else 0)%C.
Definition gradV n adj V' r i : C := Csum n (pull adj V' r i).
Definition law4 n (adj : graph) V' (r v : nat -> C) i : C :=
  (- Csum n (fun j => if adj i j then v i - v j else 0) - gradV n adj V' r i)%C.
Definition by_distance (r : nat -> C) (R0 : R) : graph := fun i j =>
  andb (negb (Nat.eqb i j)) (if Rlt_dec (Cmod (r i - r j)%C) R0 then true else false).
(* no agents of a set of pairs coincide; Definition 3 with a continuous derivative, V_ij and V_ji being one function of the distance *)
Definition apart_at n (adj : graph) (r : nat -> C) := forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> r i <> r j.
Definition potentials n (adj : graph) (V V' : nat -> nat -> R -> R) := (forall i j s, V i j s = V j i s) /\
  forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true ->
    (forall s, 0 < s -> is_derive (V i j) s (V' i j s) /\ continuity_pt (V' i j) s /\ 0 <= V i j s) /\
    (forall c, exists d, 0 < d /\ forall s, 0 < s < d -> c < V i j s) /\ (forall c, exists D, forall s, D < s -> c < V i j s).
Definition simple_graph adj := undirected adj /\ no_loops adj.
(* limits of the law at a state from states without a pair at the distance R; K is their convex hull, closed since they are finitely many *)
Definition limit_of_law n V' R0 (r v y : nat -> C) := forall e, 0 < e -> exists q u : nat -> C,
  (forall i, (i < n)%nat -> Cmod (q i - r i)%C < e /\ Cmod (u i - v i)%C < e) /\
  (forall i j, (i < n)%nat -> (j < n)%nat -> i <> j -> Cmod (q i - q j)%C <> R0) /\
  forall i, (i < n)%nat -> Cmod (law4 n (by_distance q R0) V' q u i - y i)%C < e.
Definition K10 n V' R0 (r v z : nat -> C) := exists m (c : nat -> R) (y : nat -> nat -> C),
  (forall k, (k < m)%nat -> 0 <= c k /\ limit_of_law n V' R0 r v (y k)) /\ Sum m c = 1 /\
  forall i, (i < n)%nat -> z i = Csum m (fun k => RtoC (c k) * y k i)%C.
(* absolutely continuous on every [0, T]; of measure zero *)
Definition absolutely_continuous (z : R -> C) := forall T e, 0 < T -> 0 < e -> exists d, 0 < d /\ forall m (a b : nat -> R),
  (forall k, (k < m)%nat -> 0 <= a k <= b k /\ b k <= T) -> (forall k, (S k < m)%nat -> b k <= a (S k)) ->
  Sum m (fun k => b k - a k) < d -> Sum m (fun k => Cmod (z (b k) - z (a k))%C) < e.
Definition negligible (N : R -> Prop) := forall e, 0 < e -> exists a b : nat -> R, (forall k, a k <= b k) /\
  (forall t, N t -> exists k, a k < t < b k) /\ forall m, Sum m (fun k => b k - a k) <= e.
(* a solution for all t >= 0 from a start in which no agents coincide: K is asked for at times at which the law has a value *)
Definition motion10 n V' R0 (r v : nat -> R -> C) := apart_at n complete (fun i => r i 0) /\
  (forall t i, 0 <= t -> (i < n)%nat -> is_velocity (r i) t (v i t)) /\ (forall i, (i < n)%nat -> absolutely_continuous (v i)) /\
  exists N, negligible N /\ forall t, 0 <= t -> ~ N t -> apart_at n complete (fun i => r i t) ->
    exists z, K10 n V' R0 (fun i => r i t) (fun i => v i t) z /\ forall i, (i < n)%nat -> is_velocity (v i) t (z i).
(* and one that lasts until T *)
Definition motion10_until T n V' R0 (r v : nat -> R -> C) := apart_at n complete (fun i => r i 0) /\
  (forall t i, 0 <= t < T -> (i < n)%nat -> is_velocity (r i) t (v i t)) /\
  (forall i, (i < n)%nat -> forall T' e, 0 < T' < T -> 0 < e -> exists d, 0 < d /\ forall m (a b : nat -> R),
    (forall k, (k < m)%nat -> 0 <= a k <= b k /\ b k <= T') -> (forall k, (Datatypes.S k < m)%nat -> b k <= a (Datatypes.S k)) ->
    Sum m (fun k => b k - a k) < d -> Sum m (fun k => Cmod (v i (b k) - v i (a k))%C) < e) /\
  exists N, negligible N /\ forall t, 0 <= t < T -> ~ N t -> apart_at n complete (fun i => r i t) ->
    exists z, K10 n V' R0 (fun i => r i t) (fun i => v i t) z /\ forall i, (i < n)%nat -> is_velocity (v i) t (z i).

(* ---- forces of a pair: V_ij and V_ji are equal, so their derivatives are at every distance ---- *)
Definition both (V' : nat -> nat -> R -> R) (i j : nat) : R -> R := if Nat.leb i j then V' i j else V' j i.
Lemma both_sym V' i j : both V' i j = both V' j i.
Proof. unfold both. destruct (Nat.leb_spec i j), (Nat.leb_spec j i); try reflexivity; try lia. now replace j with i by lia. Qed.
Lemma both_slope (V V' : nat -> nat -> R -> R) i j s : (forall i j s, V i j s = V j i s) ->
  is_derive (V i j) s (V' i j s) -> is_derive (V j i) s (V' j i s) -> both V' i j s = V' i j s.
Proof.
  intros VS A B. unfold both. destruct (Nat.leb i j); [reflexivity|]. apply is_derive_unique in A. rewrite <- A. symmetry.
  apply is_derive_unique. apply (is_derive_ext (V j i)); [intros; apply VS|exact B].
Qed.
Lemma slopes_of n adj V V' : potentials n adj V V' ->
  forall i j s, (i < n)%nat -> (j < n)%nat -> adj i j = true -> 0 < s -> is_derive (V i j) s (V' i j s).
Proof. intros [_ P] i j s Hi Hj A Hs. now apply (P i j Hi Hj A). Qed.
Lemma by_distance_is r R0 i j : by_distance r R0 i j = tanner2_facts.near r R0 i j.
Proof. unfold by_distance, tanner2_facts.near, norm. destruct (Nat.eqb i j); reflexivity. Qed.
Lemma pull_swap n adj V V' r i j : simple_graph adj -> potentials n adj V V' -> apart_at n adj r -> (i < n)%nat -> (j < n)%nat ->
  pull adj V' r j i = (- pull adj V' r i j)%C.
Proof.
  intros [S NL] P A Hi Hj. pose proof (slopes_of n adj V V' P) as D. unfold pull. rewrite (S j i). destruct (adj i j) eqn:L.
  - assert (N : Cmod (r j - r i)%C = Cmod (r i - r j)%C) by (replace (r j - r i)%C with (- (r i - r j))%C by ring; apply Cmod_opp). rewrite N.
    pose proof (tanner_flock.norm_neq _ _ (A i j Hi Hj L)) as Q. unfold norm in Q.
    assert (L' : adj j i = true) by now rewrite S.
    rewrite <- (both_slope V V' j i _ (proj1 P) (D j i _ Hj Hi L' Q) (D i j _ Hi Hj L Q)), (both_sym V' j i).
    rewrite (both_slope V V' i j _ (proj1 P) (D i j _ Hi Hj L Q) (D j i _ Hj Hi L' Q)). ring.
  - apply injective_projections; cbn; ring.
Qed.
(* on every undirected graph the accelerations add up to 0 *)
Lemma balanced n adj V V' r v : simple_graph adj -> potentials n adj V V' -> apart_at n adj r ->
  Sum n (fun i => fst (law4 n adj V' r v i)) = 0 /\ Sum n (fun i => snd (law4 n adj V' r v i)) = 0.
Proof.
  intros S P A.
  assert (K : forall p : C -> R, (forall a b, p (a + b)%C = p a + p b) -> (forall a, p (- a)%C = - p a) -> p 0%C = 0 ->
    (forall f, p (Csum n f) = Sum n (fun j => p (f j))) -> Sum n (fun i => p (law4 n adj V' r v i)) = 0).
  { intros p P1 P2 P0 P3. rewrite (Sum_ext n _ (fun i => Sum n (fun j => - p (if adj i j then v i - v j else 0)%C - p (pull adj V' r i j)))).
    - apply Sum_antisym. intros i j Hi Hj. rewrite (pull_swap n adj V V' r i j S P A Hi Hj), P2, (proj1 S j i).
      destruct (adj i j); [|rewrite P0; ring]. replace (v j - v i)%C with (- (v i - v j))%C by ring. rewrite P2. ring.
    - intros i Hi. unfold law4, gradV, Cminus. rewrite P1, !P2, !P3, Sum_minus, Sum_opp. reflexivity. }
  split; (apply K; [intros; reflexivity|intros; reflexivity|reflexivity|intros; reflexivity]).
Qed.
(* equal from a time on, so equal in their rates then *)
Lemma zero_from (f : R -> R) t l : is_derive f t l -> (forall s, t <= s -> f s = 0) -> l = 0.
Proof.
  intros D Z. apply is_derive_Reals in D. apply cond_eq. intros e He. destruct (D e He) as [d Hd].
  pose proof (cond_pos d) as P. specialize (Hd (d / 2) ltac:(lra)). rewrite Rabs_pos_eq in Hd by lra. specialize (Hd ltac:(lra)).
  rewrite !Z in Hd by lra. replace ((0 - 0) / (d / 2) - l) with (- (l - 0)) in Hd by (field; lra). now rewrite Rabs_Ropp in Hd.
Qed.
Lemma equal_rates (x y : R -> C) t a b : is_velocity x t a -> is_velocity y t b -> (forall s, t <= s -> x s = y s) -> a = b.
Proof.
  intros [X1 X2] [Y1 Y2] E. apply injective_projections; apply Rminus_diag_uniq.
  - apply (zero_from (fun s => fst (x s) - fst (y s)) t); [now apply D_minus|]. intros s Hs. rewrite (E s Hs). ring.
  - apply (zero_from (fun s => snd (x s) - snd (y s)) t); [now apply D_minus|]. intros s Hs. rewrite (E s Hs). ring.
Qed.

(* ---- functions that are absolutely continuous on every [0, T] ---- *)
Definition ac (F : R -> R) := forall T e, 0 < T -> 0 < e -> exists d, 0 < d /\ forall m (a b : nat -> R),
  (forall k, (k < m)%nat -> 0 <= a k <= b k /\ b k <= T) -> (forall k, (S k < m)%nat -> b k <= a (S k)) ->
  Sum m (fun k => b k - a k) < d -> Sum m (fun k => Rabs (F (b k) - F (a k))) < e.
Lemma ac_of (F : R -> R) G : ac G -> (forall T, 0 < T -> exists L, 0 < L /\ forall x y, 0 <= x <= y -> y <= T -> Rabs (F y - F x) <= L * Rabs (G y - G x)) -> ac F.
Proof.
  intros A H T e HT He. destruct (H T HT) as (L & HL & B). destruct (A T (e / L) HT ltac:(now apply Rdiv_lt_0_compat)) as (d & Hd & Q).
  exists d. split; [exact Hd|]. intros m a b I O S. specialize (Q m a b I O S).
  apply Rle_lt_trans with (Sum m (fun k => L * Rabs (G (b k) - G (a k)))).
  - apply Sum_le. intros k Hk. destruct (I k Hk). now apply B.
  - rewrite Sum_scal. apply (Rmult_lt_compat_l L) in Q; [|exact HL]. replace (L * (e / L)) with e in Q by (field; lra). exact Q.
Qed.
Lemma ac_id : ac (fun t => t).
Proof.
  intros T e HT He. exists e. split; [exact He|]. intros m a b I _ S. rewrite (Sum_ext m _ (fun k => b k - a k)); [exact S|].
  intros k Hk. destruct (I k Hk). apply Rabs_pos_eq. lra.
Qed.
Lemma ac_lipschitz F : (forall T, 0 < T -> exists L, 0 < L /\ forall x y, 0 <= x <= y -> y <= T -> Rabs (F y - F x) <= L * (y - x)) -> ac F.
Proof.
  intros H. apply (ac_of F (fun t => t) ac_id). intros T HT. destruct (H T HT) as (L & HL & B). exists L. split; [exact HL|].
  intros x y Hx Hy. rewrite (Rabs_pos_eq (y - x)) by lra. now apply B.
Qed.
Lemma ac_plus F G : ac F -> ac G -> ac (fun t => F t + G t).
Proof.
  intros A B T e HT He. destruct (A T (e / 2) HT ltac:(lra)) as (d & Hd & P). destruct (B T (e / 2) HT ltac:(lra)) as (d' & Hd' & Q).
  exists (Rmin d d'). split; [now apply Rmin_glb_lt|]. intros m a b I O S. pose proof (Rmin_l d d'). pose proof (Rmin_r d d').
  specialize (P m a b I O ltac:(lra)). specialize (Q m a b I O ltac:(lra)).
  apply Rle_lt_trans with (Sum m (fun k => Rabs (F (b k) - F (a k)) + Rabs (G (b k) - G (a k)))); [|rewrite Sum_plus; lra].
  apply Sum_le. intros k _. replace (F (b k) + G (b k) - (F (a k) + G (a k))) with (F (b k) - F (a k) + (G (b k) - G (a k))) by ring. apply Rabs_triang.
Qed.
Lemma ac_scal c F : ac F -> ac (fun t => c * F t).
Proof.
  intros A. apply (ac_of _ F A). intros T _. exists (Rabs c + 1). pose proof (Rabs_pos c). split; [lra|]. intros x y _ _.
  replace (c * F y - c * F x) with (c * (F y - F x)) by ring. rewrite Rabs_mult. apply Rmult_le_compat_r; [apply Rabs_pos|lra].
Qed.
Lemma ac_Sum n (F : nat -> R -> R) : (forall i, (i < n)%nat -> ac (F i)) -> ac (fun t => Sum n (fun i => F i t)).
Proof.
  intros H. induction n as [|n IH].
  - apply ac_lipschitz. intros T _. exists 1. split; [lra|]. intros x y Hx _. cbn. rewrite Rminus_0_r, Rabs_R0. lra.
  - cbn [Sum]. apply ac_plus; [apply IH; intros; apply H; lia|apply H; lia].
Qed.
Lemma ac_near F T e : ac F -> 0 < T -> 0 < e -> exists d, 0 < d /\ forall x y, 0 <= x <= y -> y <= T -> y - x < d -> Rabs (F y - F x) < e.
Proof.
  intros A HT He. destruct (A T e HT He) as (d & Hd & P). exists d. split; [exact Hd|]. intros x y Hx Hy Hd'.
  specialize (P 1%nat (fun _ => x) (fun _ => y)). cbn [Sum] in P. rewrite !Rplus_0_l in P. apply P; [intros; lra|intros; lia|exact Hd'].
Qed.
Lemma ac_continuous F t : ac F -> continuity_pt (fun s => F (Rmax s 0)) t.
Proof.
  intros A e He. set (T := Rmax t 0 + 1). pose proof (Rmax_r t 0). destruct (ac_near F T e A ltac:(unfold T; lra) He) as (d & Hd & P).
  exists (Rmin d 1). split; [apply Rmin_glb_lt; lra|]. intros s [_ Hs]. cbn in *. unfold R_dist in *. pose proof (Rmin_l d 1). pose proof (Rmin_r d 1).
  assert (Q : 0 <= Rmax s 0 /\ 0 <= Rmax t 0 /\ Rabs (Rmax s 0 - Rmax t 0) <= Rabs (s - t)).
  { split; [apply Rmax_r|]. split; [apply Rmax_r|]. unfold Rmax, Rabs. destruct (Rle_dec s 0), (Rle_dec t 0); repeat destruct (Rcase_abs _); lra. }
  destruct Q as (Q1 & Q2 & Q3). destruct (Rle_or_lt (Rmax s 0) (Rmax t 0)) as [L|L].
  - rewrite Rabs_minus_sym. rewrite Rabs_left1 in Q3 by lra. apply P; unfold T; lra.
  - rewrite Rabs_pos_eq in Q3 by lra. apply P; unfold T; lra.
Qed.
Lemma ac_bounded F T : ac F -> exists B, 0 < B /\ forall t, 0 <= t <= T -> Rabs (F t) <= B.
Proof.
  intros A. destruct (Rle_or_lt 0 T) as [HT|HT]; [|exists 1; split; [lra|]; intros; lra].
  destruct (continuity_ab_maj (fun s => Rabs (F (Rmax s 0))) 0 T HT) as (x & M & _).
  - intros s _. apply continuity_pt_comp with (f1 := fun s => F (Rmax s 0)) (f2 := Rabs); [now apply ac_continuous|apply Rcontinuity_abs].
  - exists (Rabs (F (Rmax x 0)) + 1). pose proof (Rabs_pos (F (Rmax x 0))). split; [lra|]. intros t Ht. specialize (M t Ht). cbv beta in M.
    rewrite (Rmax_left t 0) in M by lra. lra.
Qed.
Lemma ac_sqr F : ac F -> ac (fun t => F t ^ 2).
Proof.
  intros A. apply (ac_of _ F A). intros T _. destruct (ac_bounded F T A) as (B & HB & M). exists (2 * B). split; [lra|]. intros x y Hx Hy.
  replace (F y ^ 2 - F x ^ 2) with ((F y + F x) * (F y - F x)) by ring. rewrite Rabs_mult. apply Rmult_le_compat_r; [apply Rabs_pos|].
  eapply Rle_trans; [apply Rabs_triang|]. pose proof (M x ltac:(lra)). pose proof (M y ltac:(lra)). lra.
Qed.
(* it does not grow if its derivative is nowhere positive but on a set of measure zero *)
Section Grow.
Variables (F : R -> R) (N : R -> Prop) (a b : R).
Hypothesis A : ac F.
Hypothesis HN : negligible N.
Hypothesis Hab : 0 <= a <= b.
Hypothesis D : forall t, a <= t <= b -> ~ N t -> exists l, is_derive F t l /\ l <= 0.
Variables (lo hi : nat -> R) (c : R).
Hypothesis Hc : 0 < c.
Hypothesis Lh : forall k, lo k <= hi k.
Definition inside x j := Rmin (Rmax x (lo j)) (hi j) - lo j.
Lemma inside_mono x y j : x <= y -> inside x j <= inside y j.
Proof. intros H. unfold inside, Rmin, Rmax. pose proof (Lh j). destruct (Rle_dec x (lo j)), (Rle_dec y (lo j)); repeat destruct (Rle_dec _ _); lra. Qed.
Lemma inside_ge0 x j : 0 <= inside x j.
Proof. unfold inside, Rmin, Rmax. pose proof (Lh j). destruct (Rle_dec x (lo j)); repeat destruct (Rle_dec _ _); lra. Qed.
Lemma inside_le x j : inside x j <= hi j - lo j.
Proof. unfold inside. pose proof (Rmin_r (Rmax x (lo j)) (hi j)). lra. Qed.
Definition reached x := exists m (p q : nat -> R) J, (forall k, (k < m)%nat -> a <= p k <= q k /\ q k <= x) /\ (forall k, (S k < m)%nat -> q k <= p (S k)) /\
  Sum m (fun k => q k - p k) <= Sum J (inside x) /\ F x <= F a + c * (x - a) + Sum m (fun k => Rabs (F (q k) - F (p k))).
Lemma reached_first : reached a.
Proof. exists 0%nat, (fun _ => 0), (fun _ => 0), 0%nat. cbn. repeat split; try (intros; lia); lra. Qed.
Lemma reached_slope x y : reached x -> x <= y -> F y - F x <= c * (y - x) -> reached y.
Proof.
  intros (m & p & q & J & P1 & P2 & P3 & P4) L S. exists m, p, q, J. split; [|split; [exact P2|split]].
  - intros k Hk. destruct (P1 k Hk). lra.
  - apply Rle_trans with (1 := P3). apply Sum_le. intros j _. now apply inside_mono.
  - lra.
Qed.
Lemma reached_cover x y j : reached x -> a <= x <= y -> lo j < x -> y < hi j -> reached y.
Proof.
  intros (m & p & q & J & P1 & P2 & P3 & P4) L X Y. set (ext := fun (f : nat -> R) z k => if Nat.eqb k m then z else f k).
  assert (E : forall f z k, (k < m)%nat -> ext f z k = f k) by (intros f z k Hk; unfold ext; destruct (Nat.eqb_spec k m); [lia|reflexivity]).
  assert (E' : forall f z, ext f z m = z) by (intros; unfold ext; now rewrite Nat.eqb_refl).
  exists (S m), (ext p x), (ext q y), (J + S j)%nat. split; [|split; [|split]].
  - intros k Hk. destruct (Nat.eq_dec k m) as [->|Ne]; [rewrite !E'; lra|]. rewrite !E by lia. destruct (P1 k ltac:(lia)). lra.
  - intros k Hk. rewrite E by lia. destruct (Nat.eq_dec (S k) m) as [E0|Ne]; [rewrite E0, E'; apply (P1 k); lia|]. rewrite E by lia. apply P2. lia.
  - cbn [Sum]. rewrite !E', (Sum_ext m _ (fun k => q k - p k)) by (intros k Hk; now rewrite !E).
    assert (M : forall u v g, (forall k, 0 <= g k) -> Sum u g <= Sum (u + v) g).
    { intros u v g G. induction v as [|v IH]; [rewrite Nat.add_0_r; lra|]. rewrite Nat.add_succ_r. cbn [Sum]. specialize (G (u + v)%nat). lra. }
    pose proof (M J (S j) (inside x) (inside_ge0 x)) as M1.
    assert (M2 : inside y j - inside x j <= Sum (J + S j) (fun k => inside y k - inside x k)).
    { apply (Sum_term_le (J + S j) (fun k => inside y k - inside x k) j); [|lia]. intros k _. pose proof (inside_mono x y k ltac:(lra)). lra. }
    rewrite Sum_minus in M2. assert (Ix : inside x j = x - lo j) by (unfold inside; rewrite Rmax_left, Rmin_left by lra; ring).
    assert (Iy : inside y j = y - lo j) by (unfold inside; rewrite Rmax_left, Rmin_left by lra; ring). lra.
  - cbn [Sum]. rewrite !E', (Sum_ext m _ (fun k => Rabs (F (q k) - F (p k)))) by (intros k Hk; now rewrite !E).
    pose proof (Rle_abs (F y - F x)). assert (0 <= c * (y - x)) by (apply Rmult_le_pos; lra). lra.
Qed.
Hypothesis Cov : forall t, N t -> exists k, lo k < t < hi k.
Lemma reached_last : reached b.
Proof.
  destruct (completeness (fun x => a <= x <= b /\ reached x)) as (m & Ub & Lub).
  { exists b. intros x [Hx _]. lra. }
  { exists a. split; [lra|apply reached_first]. }
  assert (Ma : a <= m) by (apply Ub; split; [lra|apply reached_first]). assert (Mb : m <= b) by (apply Lub; intros x [Hx _]; lra).
  assert (Near : forall d, 0 < d -> exists x, m - d < x <= m /\ a <= x /\ reached x).
  { intros d Hd. apply NNPP. intros No. assert (m <= m - d); [|lra]. apply Lub. intros x [Hx Rx]. apply Rnot_lt_le. intros L. apply No.
    exists x. split; [split; [lra|apply Ub; now split]|]. now split. }
  assert (Go : exists d, 0 < d /\ forall x y, m - d < x <= m -> a <= x -> m <= y < m + d -> y <= b -> reached x -> reached y).
  { destruct (classic (N m)) as [Nm|Nm].
    - destruct (Cov m Nm) as [j Hj]. exists (Rmin (m - lo j) (hi j - m)). split; [apply Rmin_glb_lt; lra|].
      pose proof (Rmin_l (m - lo j) (hi j - m)). pose proof (Rmin_r (m - lo j) (hi j - m)). intros x y Hx Hax Hy _ Rx. apply (reached_cover x y j Rx); lra.
    - destruct (D m ltac:(lra) Nm) as (l & Dl & Hl). apply is_derive_Reals in Dl. destruct (Dl c Hc) as [d Hd]. exists d. split; [apply cond_pos|].
      intros x y Hx Hax Hy Hyb Rx. apply (reached_slope x y Rx); [lra|].
      assert (Up : forall h, h <> 0 -> Rabs h < d -> 0 < h -> F (m + h) - F m <= c * h).
      { intros h H0 Hh Hp. specialize (Hd h H0 Hh). apply Rabs_lt_between in Hd. assert (Q : (F (m + h) - F m) / h < c) by lra.
        apply (Rmult_lt_compat_r h) in Q; [|exact Hp]. replace ((F (m + h) - F m) / h * h) with (F (m + h) - F m) in Q by (field; lra). lra. }
      assert (Down : forall h, h <> 0 -> Rabs h < d -> h < 0 -> F m - F (m + h) <= c * (- h)).
      { intros h H0 Hh Hp. specialize (Hd h H0 Hh). apply Rabs_lt_between in Hd. assert (Q : (F (m + h) - F m) / h < c) by lra.
        apply (Rmult_lt_compat_r (- h)) in Q; [|lra]. replace ((F (m + h) - F m) / h * - h) with (F m - F (m + h)) in Q by (field; lra). lra. }
      assert (U1 : F y - F m <= c * (y - m)).
      { destruct (Req_dec y m) as [->|Ne]; [lra|]. specialize (Up (y - m) ltac:(lra) ltac:(rewrite Rabs_pos_eq; lra) ltac:(lra)). replace (m + (y - m)) with y in Up by ring. exact Up. }
      assert (U2 : F m - F x <= c * (m - x)).
      { destruct (Req_dec x m) as [->|Ne]; [lra|]. specialize (Down (x - m) ltac:(lra) ltac:(rewrite Rabs_left; lra) ltac:(lra)). replace (m + (x - m)) with x in Down by ring. lra. }
      lra. }
  destruct Go as (d & Hd & Go). destruct (Near d Hd) as (x & Hx & Hax & Rx).
  assert (Rm : reached (Rmin b (m + d / 2))).
  { pose proof (Rmin_l b (m + d / 2)). pose proof (Rmin_r b (m + d / 2)). apply (Go x); try assumption; [split; [apply Rmin_glb; lra|lra]]. }
  assert (Le : Rmin b (m + d / 2) <= m) by (apply Ub; split; [split; [apply Rmin_glb; lra|apply Rmin_l]|exact Rm]).
  replace (Rmin b (m + d / 2)) with b in Rm; [exact Rm|]. unfold Rmin in *. destruct (Rle_dec b (m + d / 2)); lra.
Qed.
End Grow.
Lemma ac_falls F N a b : ac F -> negligible N -> 0 <= a <= b -> (forall t, a <= t <= b -> ~ N t -> exists l, is_derive F t l /\ l <= 0) -> F b <= F a.
Proof.
  intros A HN Hab D. apply Rnot_lt_le. intros L. set (e := (F b - F a) / 2). assert (He : 0 < e) by (unfold e; lra).
  destruct (A (b + 1) e ltac:(lra) He) as (d & Hd & P). destruct (HN (d / 2) ltac:(lra)) as (lo & hi & H1 & H2 & H3).
  set (c := e / (b - a + 1)). assert (Hc : 0 < c) by (apply Rdiv_lt_0_compat; lra).
  destruct (reached_last F N a b Hab D lo hi c Hc H1 H2) as (m & p & q & J & P1 & P2 & P3 & P4).
  specialize (P m p q). assert (Q : Sum m (fun k => Rabs (F (q k) - F (p k))) < e).
  { apply P; [|exact P2|].
    - intros k Hk. destruct (P1 k Hk). lra.
    - apply Rle_lt_trans with (1 := P3). apply Rle_lt_trans with (Sum J (fun k => hi k - lo k)); [apply Sum_le; intros; now apply inside_le|]. specialize (H3 J). lra. }
  assert (c * (b - a) < e). { unfold c. apply Rmult_lt_reg_r with (b - a + 1); [lra|]. replace (e / (b - a + 1) * (b - a) * (b - a + 1)) with (e * (b - a)) by (field; lra). nra. }
  unfold e in *. lra.
Qed.
Lemma ac_le F N a b c : ac F -> negligible N -> 0 <= a <= b -> (forall t, a <= t <= b -> ~ N t -> exists l, is_derive F t l /\ l <= c) -> F b <= F a + c * (b - a).
Proof.
  intros A HN Hab D. assert (Q : F b + - c * b <= F a + - c * a); [|lra].
  apply (ac_falls (fun t => F t + - c * t) N a b); [apply ac_plus; [exact A|apply ac_scal, ac_id]|exact HN|exact Hab|].
  intros t Ht Nt. destruct (D t Ht Nt) as (l & Dl & Hl). exists (l + - c * 1). split; [|lra]. apply D_plus; [exact Dl|]. apply D_scal, D_id.
Qed.
Lemma Sum_part n m g : (forall k, 0 <= g k) -> (n <= m)%nat -> Sum n g <= Sum m g.
Proof. intros G. induction 1 as [|m _ IH]; [lra|]. cbn [Sum]. specialize (G m). lra. Qed.
Lemma negligible_or P Q : negligible P -> negligible Q -> negligible (fun t => P t \/ Q t).
Proof.
  intros A B e He. destruct (A (e / 2) ltac:(lra)) as (a & b & A1 & A2 & A3). destruct (B (e / 2) ltac:(lra)) as (a' & b' & B1 & B2 & B3).
  set (mix := fun (f g : nat -> R) k => if Nat.even k then f (Nat.div2 k) else g (Nat.div2 k)).
  exists (mix a a'), (mix b b'). split; [|split].
  - intros k. unfold mix. destruct (Nat.even k); [apply A1|apply B1].
  - intros t [H|H].
    + destruct (A2 t H) as [k Hk]. exists (2 * k)%nat. unfold mix. rewrite Nat.even_mul. cbn [Nat.even orb]. now rewrite Nat.div2_double.
    + destruct (B2 t H) as [k Hk]. exists (Datatypes.S (2 * k)). unfold mix. rewrite Nat.even_succ, <- Nat.negb_even, Nat.even_mul. cbn [Nat.even orb negb]. now rewrite Nat.div2_succ_double.
  - intros m. assert (K : forall n, Sum (2 * n) (fun k => mix b b' k - mix a a' k) = Sum n (fun k => b k - a k) + Sum n (fun k => b' k - a' k)).
    { induction n as [|n IH]; [cbn; ring|]. replace (2 * Datatypes.S n)%nat with (Datatypes.S (Datatypes.S (2 * n))) by lia. cbn [Sum]. rewrite IH. unfold mix.
      rewrite Nat.even_succ, <- Nat.negb_even, Nat.even_mul. cbn [Nat.even orb negb]. rewrite Nat.div2_double, Nat.div2_succ_double. ring. }
    apply Rle_trans with (Sum (2 * m) (fun k => mix b b' k - mix a a' k)).
    + apply Sum_part; [|lia]. intros k. unfold mix. specialize (A1 (Nat.div2 k)). specialize (B1 (Nat.div2 k)). destruct (Nat.even k); lra.
    + rewrite K. specialize (A3 m). specialize (B3 m). lra.
Qed.
Lemma negligible_sub (P Q : R -> Prop) : (forall t, P t -> Q t) -> negligible Q -> negligible P.
Proof. intros H A e He. destruct (A e He) as (a & b & A1 & A2 & A3). exists a, b. split; [exact A1|]. split; [|exact A3]. intros t Ht. apply A2. now apply H. Qed.
Lemma negligible_none : negligible (fun _ => False).
Proof. intros e He. exists (fun _ => 0), (fun _ => 0). split; [intros; lra|]. split; [intros t []|]. intros m. rewrite Sum_zero; [lra|]. intros; ring. Qed.
Lemma negligible_some n (P : nat -> R -> Prop) : (forall i, (i < n)%nat -> negligible (P i)) -> negligible (fun t => exists i, (i < n)%nat /\ P i t).
Proof.
  intros H. induction n as [|n IH].
  - apply (negligible_sub _ (fun _ => False)); [intros t (i & Hi & _); lia|apply negligible_none].
  - apply (negligible_sub _ (fun t => (exists i, (i < n)%nat /\ P i t) \/ P n t)).
    + intros t (i & Hi & Q). destruct (Nat.eq_dec i n) as [->|Ne]; [now right|]. left. exists i. split; [lia|exact Q].
    + apply negligible_or; [apply IH; intros; apply H; lia|apply H; lia].
Qed.
(* each point of P has a neighbourhood without another *)
Lemma negligible_isolated (P : R -> Prop) : (forall t, P t -> 0 <= t /\ exists d, 0 < d /\ forall s, P s -> Rabs (s - t) < d -> s = t) -> negligible P.
Proof.
  intros H e He.
  (* cell j, k: the point of P in [j/2^k, (j + 1)/2^k), if it is alone there *)
  set (cell := fun n t => let '(j, k) := Cantor.of_nat n in P t /\ INR j <= t * 2 ^ k < INR j + 1 /\ forall s, P s -> INR j <= s * 2 ^ k < INR j + 1 -> s = t).
  set (x := fun n => real (Lub_Rbar (cell n))). set (h := fun n : nat => e / 4 * (/ 2) ^ n).
  assert (Hh : forall n, 0 < h n) by (intros n; unfold h; apply Rmult_lt_0_compat; [lra|apply pow_lt; lra]).
  assert (X : forall n t, cell n t -> x n = t).
  { intros n t Ct. unfold x. replace (Lub_Rbar (cell n)) with (Finite t); [reflexivity|]. symmetry. apply is_lub_Rbar_unique. split.
    - intros s Cs. replace s with t; [apply Rle_refl|]. unfold cell in *. destruct (Cantor.of_nat n) as [j k]. destruct Ct as (T1 & T2 & T3), Cs as (S1 & S2 & S3). now apply S3.
    - intros b Ub. now apply Ub. }
  exists (fun n => x n - h n), (fun n => x n + h n). split; [intros n; specialize (Hh n); lra|]. split.
  - intros t Pt. destruct (H t Pt) as (T0 & d & Hd & Iso).
    destruct (nfloor_ex (/ d) ltac:(left; now apply Rinv_0_lt_compat)) as [k Hk]. pose (q := Datatypes.S k).
    assert (B : forall m, INR m + 1 <= 2 ^ m) by (induction m as [|m IH]; [cbn; lra|rewrite S_INR; cbn [pow]; pose proof (pos_INR m); lra]).
    assert (P2 : / d < 2 ^ q) by (pose proof (B q) as Bq; unfold q in *; rewrite S_INR in Bq; lra). assert (Pq : 0 < 2 ^ q) by (apply pow_lt; lra).
    destruct (nfloor_ex (t * 2 ^ q)) as [j Hj]; [apply Rmult_le_pos; lra|].
    exists (Cantor.to_nat (j, q)). rewrite (X _ t); [specialize (Hh (Cantor.to_nat (j, q))); lra|]. unfold cell. rewrite Cantor.cancel_of_to.
    split; [exact Pt|]. split; [lra|]. intros s Ps Hs. apply Iso; [exact Ps|]. apply (Rmult_lt_reg_r (2 ^ q)); [exact Pq|].
    assert (1 < d * 2 ^ q). { apply (Rmult_lt_compat_l d) in P2; [|exact Hd]. rewrite Rinv_r in P2 by lra. exact P2. }
    rewrite <- (Rabs_pos_eq (2 ^ q)) at 1 by lra. rewrite <- Rabs_mult, Rmult_minus_distr_r. apply Rle_lt_trans with 1; [apply Rabs_le; lra|exact H0].
  - intros m. rewrite (Sum_ext m _ (fun n => e / 2 * (/ 2) ^ n)) by (intros n _; unfold h; field).
    assert (G : Sum m (fun n => e / 2 * (/ 2) ^ n) = e * (1 - (/ 2) ^ m)).
    { induction m as [|m IH]; cbn [Sum pow]; [ring|]. rewrite IH. field. }
    rewrite G. assert (0 < (/ 2) ^ m) by (apply pow_lt; lra). nra.
Qed.
(* a differentiable function crosses a value in isolated points *)
Lemma negligible_crossings (s : R -> R) (s' : R -> R) R0 : (forall t, 0 <= t -> s t = R0 -> is_derive s t (s' t)) -> negligible (fun t => 0 <= t /\ s t = R0 /\ s' t <> 0).
Proof.
  intros D. apply negligible_isolated. intros t (Ht & E & Ne). split; [exact Ht|]. pose proof (D t Ht E) as Dt. apply is_derive_Reals in Dt.
  destruct (Dt (Rabs (s' t)) ltac:(now apply Rabs_pos_lt)) as [d Hd]. exists d. split; [apply cond_pos|]. intros u (_ & Eu & _) L.
  destruct (Req_dec u t) as [Q|Q]; [exact Q|exfalso]. specialize (Hd (u - t) ltac:(lra) L). replace (t + (u - t)) with u in Hd by ring.
  rewrite Eu, E in Hd. replace ((R0 - R0) / (u - t) - s' t) with (- s' t) in Hd by (field; lra). rewrite Rabs_Ropp in Hd. lra.
Qed.
Lemma small n (P : nat -> R -> Prop) : (forall i d d', P i d -> 0 < d' <= d -> P i d') -> (forall i, (i < n)%nat -> exists d, 0 < d /\ P i d) ->
  exists d, 0 < d /\ forall i, (i < n)%nat -> P i d.
Proof.
  intros M. induction n as [|n IH]; intros H; [exists 1; split; [lra|intros; lia]|].
  destruct IH as (d & Hd & Q); [intros; apply H; lia|]. destruct (H n ltac:(lia)) as (d' & Hd' & Q'). pose proof (Rmin_l d d'). pose proof (Rmin_r d d').
  assert (0 < Rmin d d') by now apply Rmin_glb_lt. exists (Rmin d d'). split; [assumption|]. intros i Hi.
  destruct (Nat.eq_dec i n) as [->|Ne]; [apply (M n d'); [exact Q'|lra]|apply (M i d); [apply Q; lia|lra]].
Qed.
Lemma small2 n (P : nat -> nat -> R -> Prop) : (forall i j d d', P i j d -> 0 < d' <= d -> P i j d') ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> exists d, 0 < d /\ P i j d) -> exists d, 0 < d /\ forall i j, (i < n)%nat -> (j < n)%nat -> P i j d.
Proof.
  intros M H. destruct (small n (fun i d => forall j, (j < n)%nat -> P i j d)) as (d & Hd & Q).
  - intros i d d' Q L j Hj. apply (M i j d); [now apply Q|exact L].
  - intros i Hi. apply (small n (fun j d => P i j d)); [intros j; apply M|intros; now apply H].
  - exists d. split; [exact Hd|]. intros i j Hi Hj. now apply Q.
Qed.
(* the force of a pair is continuous where they are apart *)
Lemma force_near (f : R -> R) z0 e : 0 < Cmod z0 -> continuity_pt f (Cmod z0) -> 0 < e ->
  exists d, 0 < d /\ forall z, Cmod (z - z0)%C < d -> Cmod (RtoC (f (Cmod z) / Cmod z) * z - RtoC (f (Cmod z0) / Cmod z0) * z0)%C < e.
Proof.
  intros Hz Cf He. set (s0 := Cmod z0) in *. set (g := fun s => f s / s).
  assert (Cg : continuity_pt g s0) by (apply continuity_pt_div; [exact Cf|apply derivable_continuous_pt, derivable_pt_id|cbn; unfold id; lra]).
  set (e1 := e / (2 * (s0 + 1))). assert (E1 : 0 < e1) by (apply Rdiv_lt_0_compat; lra). destruct (Cg e1 E1) as (d & Hd & Q).
  set (M := Rabs (g s0) + e1 + 1). assert (HM : 0 < M) by (unfold M; pose proof (Rabs_pos (g s0)); lra).
  assert (E2 : 0 < e / (2 * M)) by (apply Rdiv_lt_0_compat; lra).
  exists (Rmin d (e / (2 * M))). split; [now apply Rmin_glb_lt|]. intros z L. pose proof (Rmin_l d (e / (2 * M))). pose proof (Rmin_r d (e / (2 * M))).
  assert (K : Rabs (g (Cmod z) - g s0) < e1).
  { destruct (Req_dec (Cmod z) s0) as [->|Ne]; [rewrite Rminus_eq_0, Rabs_R0; exact E1|]. apply (Q (Cmod z)). split; [split; [exact I|now apply not_eq_sym]|].
    cbn. unfold R_dist. pose proof (tanner_saturated.Cmod_gap z z0) as G. fold s0 in G. lra. }
  fold (g (Cmod z)) (g s0).
  replace (RtoC (g (Cmod z)) * z - RtoC (g s0) * z0)%C with (RtoC (g (Cmod z)) * (z - z0) + RtoC (g (Cmod z) - g s0) * z0)%C by (rewrite RtoC_minus; ring).
  eapply Rle_lt_trans; [apply Cmod_triangle|]. rewrite !Cmod_mult, !Cmod_R. fold s0.
  assert (B1 : Rabs (g (Cmod z)) <= M). { replace (g (Cmod z)) with (g s0 + (g (Cmod z) - g s0)) by ring. eapply Rle_trans; [apply Rabs_triang|]. unfold M. lra. }
  assert (T1 : Rabs (g (Cmod z)) * Cmod (z - z0)%C <= e / 2).
  { apply Rle_trans with (M * (e / (2 * M))); [apply Rmult_le_compat; [apply Rabs_pos|apply Cmod_ge_0|exact B1|lra]|right; field; lra]. }
  assert (T2 : Rabs (g (Cmod z) - g s0) * s0 < e / 2).
  { apply Rle_lt_trans with (e1 * s0); [apply Rmult_le_compat_r; lra|]. unfold e1. apply Rmult_lt_reg_r with (2 * (s0 + 1)); [lra|].
    replace (e / (2 * (s0 + 1)) * s0 * (2 * (s0 + 1))) with (e * s0) by (field; lra). nra. }
  lra.
Qed.
Lemma by_distance_simple q R0 : simple_graph (by_distance q R0).
Proof.
  split; [intros i j; rewrite !by_distance_is; apply tanner2_facts.near_undirected|]. intros i. unfold by_distance. now rewrite Nat.eqb_refl.
Qed.
Lemma potentials_part n adj V V' : no_loops adj -> potentials n complete V V' -> potentials n adj V V'.
Proof.
  intros NL [A P]. split; [exact A|]. intros i j Hi Hj L. apply P; try assumption. unfold complete. destruct (Nat.eqb_spec i j) as [->|]; [|reflexivity].
  rewrite NL in L. discriminate.
Qed.
Lemma apart_part n adj r : no_loops adj -> apart_at n complete r -> apart_at n adj r.
Proof.
  intros NL A i j Hi Hj L. apply A; try assumption. unfold complete. destruct (Nat.eqb_spec i j) as [->|]; [|reflexivity]. rewrite NL in L. discriminate.
Qed.
Lemma Csum_gap n f g : (Csum n f - Csum n g)%C = Csum n (fun j => f j - g j)%C.
Proof. apply injective_projections; cbn; rewrite <- Sum_opp, <- Sum_plus; reflexivity. Qed.
Lemma law4_one n adj V' r v i : law4 n adj V' r v i = Csum n (fun j => - (if adj i j then v i - v j else 0) - pull adj V' r i j)%C.
Proof. unfold law4, gradV. apply injective_projections; cbn; rewrite <- !Sum_opp, <- Sum_plus; reflexivity. Qed.

(* ---- limits of the law at a state: what they take from the energy, their size, their sum ---- *)
Section Limits.
Variables (n : nat) (V V' : nat -> nat -> R -> R) (R0 : R) (r v : nat -> C).
Hypothesis P : potentials n complete V V'.
Hypothesis A : apart_at n complete r.
Notation force i j := (pull complete V' r i j).
Lemma limit_weights y e : limit_of_law n V' R0 r v y -> 0 < e -> exists adj, simple_graph adj /\
  (forall i j, (i < n)%nat -> (j < n)%nat -> i <> j -> (Cmod (r i - r j)%C < R0 -> adj i j = true) /\ (R0 < Cmod (r i - r j)%C -> adj i j = false)) /\
  forall i, (i < n)%nat -> Cmod (y i - law4 n adj V' r v i)%C < e.
Proof.
  intros Ly He. set (h := e / (4 * (INR n + 1))). pose proof (pos_INR n) as Pn. assert (Hh : 0 < h) by (apply Rdiv_lt_0_compat; lra).
  destruct (small2 n (fun i j d => i <> j -> forall q : nat -> C, Cmod (q i - r i)%C < d -> Cmod (q j - r j)%C < d ->
    (Cmod (r i - r j)%C < R0 -> Cmod (q i - q j)%C < R0) /\ (R0 < Cmod (r i - r j)%C -> R0 < Cmod (q i - q j)%C) /\
    Cmod (pull complete V' q i j - force i j)%C < h)) as (d & Hd & Q).
  { intros i j d d' H L Ne q H1 H2. apply (H Ne); lra. }
  { intros i j Hi Hj. destruct (Nat.eq_dec i j) as [->|Ne]; [exists 1; split; [lra|congruence]|].
    assert (L : complete i j = true) by (unfold complete; destruct (Nat.eqb_spec i j); [contradiction|reflexivity]).
    pose proof (tanner_flock.norm_neq _ _ (A i j Hi Hj L)) as N. change (0 < Cmod (r i - r j)%C) in N.
    destruct P as [_ P']. destruct (P' i j Hi Hj L) as (P1 & _). destruct (P1 _ N) as (_ & Cn & _).
    destruct (force_near (V' i j) (r i - r j)%C h N Cn Hh) as (d1 & Hd1 & F).
    set (gap := Rabs (Cmod (r i - r j)%C - R0)). set (d2 := if Req_EM_T gap 0 then 1 else gap). assert (Hd2 : 0 < d2).
    { unfold d2. destruct (Req_EM_T gap 0); [lra|]. pose proof (Rabs_pos (Cmod (r i - r j)%C - R0)). fold gap in H. lra. }
    exists (Rmin (d1 / 2) (d2 / 2)). split; [apply Rmin_glb_lt; lra|]. intros _ q H1 H2. pose proof (Rmin_l (d1 / 2) (d2 / 2)). pose proof (Rmin_r (d1 / 2) (d2 / 2)).
    assert (Z : Cmod (q i - q j - (r i - r j))%C < Rmin d1 d2).
    { replace (q i - q j - (r i - r j))%C with ((q i - r i) + - (q j - r j))%C by ring. eapply Rle_lt_trans; [apply Cmod_triangle|]. rewrite Cmod_opp.
      unfold Rmin in *. destruct (Rle_dec d1 d2), (Rle_dec (d1 / 2) (d2 / 2)); lra. }
    pose proof (Rmin_l d1 d2). pose proof (Rmin_r d1 d2). pose proof (tanner_saturated.Cmod_gap (q i - q j)%C (r i - r j)%C) as G. apply Rabs_le_between in G.
    split; [|split].
    - intros Lt. assert (d2 = R0 - Cmod (r i - r j)%C); [|lra]. unfold d2. assert (gap = R0 - Cmod (r i - r j)%C) by (unfold gap; rewrite Rabs_left; lra). destruct (Req_EM_T gap 0); lra.
    - intros Lt. assert (d2 = Cmod (r i - r j)%C - R0); [|lra]. unfold d2. assert (gap = Cmod (r i - r j)%C - R0) by (unfold gap; rewrite Rabs_pos_eq; lra). destruct (Req_EM_T gap 0); lra.
    - unfold pull. rewrite L. apply F. lra. }
  destruct (Ly (Rmin d h) ltac:(now apply Rmin_glb_lt)) as (q & u & Q1 & Q2 & Q3). pose proof (Rmin_l d h). pose proof (Rmin_r d h).
  pose proof (by_distance_simple q R0) as Sim. exists (by_distance q R0). split; [exact Sim|]. split.
  - intros i j Hi Hj Ne. destruct (Q1 i Hi), (Q1 j Hj). destruct (Q i j Hi Hj Ne q ltac:(lra) ltac:(lra)) as (N1 & N2 & _). unfold by_distance.
    destruct (Nat.eqb_spec i j); [contradiction|]. cbn [negb andb]. destruct (Rlt_dec (Cmod (q i - q j)%C) R0) as [L|L]; split; intros H'; try reflexivity.
    + specialize (N2 H'). lra.
    + specialize (N1 H'). lra.
  - intros i Hi. set (G := by_distance q R0) in *.
    replace (y i - law4 n G V' r v i)%C with (- (law4 n G V' q u i - y i) + (law4 n G V' q u i - law4 n G V' r v i))%C by ring.
    eapply Rle_lt_trans; [apply Cmod_triangle|]. rewrite Cmod_opp. specialize (Q3 i Hi).
    assert (E : Cmod (law4 n G V' q u i - law4 n G V' r v i)%C <= INR n * (3 * h)).
    { rewrite !law4_one, Csum_gap.
      eapply Rle_trans; [apply tanner_trees.norm_Csum|]. rewrite <- Sum_const. apply Sum_le. intros j Hj. unfold norm, pull.
        destruct (G i j) eqn:Gij; [|replace (- 0 - 0 - (- 0 - 0))%C with (RtoC 0) by ring; rewrite Cmod_0; lra].
        assert (Ne : i <> j) by (intros ->; rewrite (proj2 Sim) in Gij; discriminate).
        assert (L : complete i j = true) by (unfold complete; destruct (Nat.eqb_spec i j); [contradiction|reflexivity]).
        destruct (Q1 i Hi) as [I1 I2], (Q1 j Hj) as [J1 J2]. destruct (Q i j Hi Hj Ne q ltac:(lra) ltac:(lra)) as (_ & _ & F). unfold pull in F. rewrite L in F.
        set (a := (RtoC (V' i j (Cmod (q i - q j)) / Cmod (q i - q j)) * (q i - q j))%C) in *. set (b := (RtoC (V' i j (Cmod (r i - r j)) / Cmod (r i - r j)) * (r i - r j))%C) in *.
        replace (- (u i - u j) - a - (- (v i - v j) - b))%C with (- (u i - v i) + ((u j - v j) + - (a - b)))%C by ring.
        eapply Rle_trans; [apply Cmod_triangle|]. rewrite Cmod_opp. pose proof (Cmod_triangle (u j - v j)%C (- (a - b))%C) as T. rewrite Cmod_opp in T. lra. }
    assert (h * (4 * (INR n + 1)) = e) by (unfold h; field; lra). nra.
Qed.
(* what falls while pairs at R keep their distance *)
Definition near_rate := / 2 * Sum n (fun i => Sum n (fun j => if by_distance r R0 i j then inner (force i j) (v i - v j)%C else 0)).
Definition near_total := Sum n (fun i => Sum n (fun j => if by_distance r R0 i j then dist2 (v i) (v j) else 0)).
Lemma graph_power adj : simple_graph adj ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> i <> j -> (Cmod (r i - r j)%C < R0 -> adj i j = true) /\ (R0 < Cmod (r i - r j)%C -> adj i j = false)) ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> i <> j -> Cmod (r i - r j)%C = R0 -> inner (force i j) (v i - v j)%C = 0) ->
  Sum n (fun i => inner (v i) (law4 n adj V' r v i)) <= - / 2 * near_total - near_rate.
Proof.
  intros S W Z. pose proof (potentials_part n adj V V' (proj2 S) P) as Pa. pose proof (apart_part n adj r (proj2 S) A) as Aa.
  set (g := fun i j => ((if adj i j then v j - v i else 0) - pull adj V' r i j)%C).
  assert (E : Sum n (fun i => inner (v i) (law4 n adj V' r v i)) = / 2 * Sum n (fun i => Sum n (fun j => inner (g i j) (v i - v j)%C))).
  { etransitivity; [|symmetry; refine (tanner_energy.pair_sum_swap n g (fun i _ => v i) 0 _)].
    - apply Sum_ext. intros i _. f_equal. rewrite law4_one. apply Csum_ext. intros j _. unfold g. destruct (adj i j); ring.
    - intros i j Hi Hj. unfold g. rewrite (pull_swap n adj V V' r i j S Pa Aa Hi Hj), (proj1 S j i). destruct (adj i j); [ring|apply injective_projections; cbn; ring]. }
  rewrite E. unfold near_total, near_rate.
  replace (- / 2 * _ - / 2 * _) with (/ 2 * (- Sum n (fun i => Sum n (fun j => if by_distance r R0 i j then dist2 (v i) (v j) else 0)) -
    Sum n (fun i => Sum n (fun j => if by_distance r R0 i j then inner (force i j) (v i - v j)%C else 0)))) by ring.
  apply Rmult_le_compat_l; [lra|]. rewrite <- Sum_opp, <- Sum_minus. apply Sum_le. intros i Hi. rewrite <- Sum_opp, <- Sum_minus. apply Sum_le. intros j Hj.
  unfold g, pull, by_distance. destruct (Nat.eqb_spec i j) as [->|Ne].
  - cbn [negb andb]. rewrite (proj2 S). rewrite inner_xy. cbn. lra.
  - cbn [negb andb]. assert (L : complete i j = true) by (unfold complete; destruct (Nat.eqb_spec i j); [contradiction|reflexivity]).
    destruct (W i j Hi Hj Ne) as [W1 W2]. specialize (Z i j Hi Hj Ne). unfold pull in Z. rewrite L in Z |- *. pose proof (dist2_ge0 (v i) (v j)) as D0. rewrite dist2_xy in *.
    destruct (Rlt_dec (Cmod (r i - r j)%C) R0) as [Lt|Lt].
    + rewrite (W1 Lt). rewrite !inner_xy. cbn. lra.
    + destruct (Req_dec (Cmod (r i - r j)%C) R0) as [Eq|Nq].
      * specialize (Z Eq). destruct (adj i j); [|rewrite inner_xy; cbn; lra]. rewrite !inner_xy in *. cbn in *. lra.
      * rewrite (W2 ltac:(lra)), inner_xy. cbn. lra.
Qed.
Lemma limit_power y : limit_of_law n V' R0 r v y ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> i <> j -> Cmod (r i - r j)%C = R0 -> inner (force i j) (v i - v j)%C = 0) ->
  Sum n (fun i => inner (v i) (y i)) <= - / 2 * near_total - near_rate.
Proof.
  intros Ly Z. set (X := - / 2 * near_total - near_rate). set (M := Sum n (fun i => Cmod (v i))).
  assert (HM : 0 <= M) by (apply Sum_ge0; intros; apply Cmod_ge_0). apply Rnot_lt_le. intros L.
  set (e := (Sum n (fun i => inner (v i) (y i)) - X) / (M + 1)). assert (He : 0 < e) by (apply Rdiv_lt_0_compat; lra).
  destruct (limit_weights y e Ly He) as (adj & S & W & Q). pose proof (graph_power adj S W Z) as G. fold X in G.
  assert (B : Sum n (fun i => inner (v i) (y i)) - Sum n (fun i => inner (v i) (law4 n adj V' r v i)) <= e * M).
  { rewrite <- Sum_minus. unfold M. rewrite <- Sum_scal. apply Sum_le. intros i Hi. rewrite <- inner_minus.
    eapply Rle_trans; [apply tanner_saturated.inner_le|]. rewrite (Rmult_comm e). apply Rmult_le_compat_l; [apply Cmod_ge_0|]. left. now apply Q. }
  assert (e * (M + 1) = Sum n (fun i => inner (v i) (y i)) - X) by (unfold e; field; lra). lra.
Qed.
Lemma limit_bounded y S b : limit_of_law n V' R0 r v y -> (forall i, (i < n)%nat -> Cmod (v i) <= S) ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> i <> j -> Cmod (r i - r j)%C <= R0 -> Cmod (force i j) <= b) -> 0 <= S -> 0 <= b ->
  forall i, (i < n)%nat -> Cmod (y i) <= INR n * (2 * S + b).
Proof.
  intros Ly HS Hb S0 b0 i Hi. apply Rnot_lt_le. intros L. set (e := Cmod (y i) - INR n * (2 * S + b)) in *. assert (He : 0 < e) by (unfold e; lra).
  destruct (limit_weights y e Ly He) as (adj & Sg & W & Q). specialize (Q i Hi).
  assert (B : Cmod (law4 n adj V' r v i) <= INR n * (2 * S + b)).
  { rewrite law4_one. eapply Rle_trans; [apply tanner_trees.norm_Csum|]. rewrite <- Sum_const. apply Sum_le. intros j Hj. unfold norm, pull.
    destruct (adj i j) eqn:Gij; [|replace (- 0 - 0)%C with (RtoC 0) by ring; rewrite Cmod_0; lra].
    assert (Ne : i <> j) by (intros ->; rewrite (proj2 Sg) in Gij; discriminate). destruct (W i j Hi Hj Ne) as [_ W2].
    assert (Le : Cmod (r i - r j)%C <= R0) by (apply Rnot_lt_le; intros H; rewrite (W2 H) in Gij; discriminate). specialize (Hb i j Hi Hj Ne Le).
    unfold pull in Hb. replace (complete i j) with true in Hb by (unfold complete; destruct (Nat.eqb_spec i j); [contradiction|reflexivity]).
    set (a := (RtoC _ * _)%C) in *. unfold Cminus at 1. eapply Rle_trans; [apply Cmod_triangle|]. rewrite !Cmod_opp.
    pose proof (Cmod_triangle (v i) (- v j)%C) as T. rewrite Cmod_opp in T. pose proof (HS i Hi). pose proof (HS j Hj). unfold Cminus. lra. }
  pose proof (Cmod_triangle (y i - law4 n adj V' r v i)%C (law4 n adj V' r v i)) as T. replace (y i - law4 n adj V' r v i + law4 n adj V' r v i)%C with (y i) in T by ring.
  unfold e in *. lra.
Qed.
Lemma limit_balanced y : limit_of_law n V' R0 r v y -> Csum n y = 0%C.
Proof.
  intros Ly. assert (K : forall p : C -> R, (forall a b, p (a - b)%C = p a - p b) -> (forall a, Rabs (p a) <= Cmod a) ->
    (forall adj, simple_graph adj -> Sum n (fun i => p (law4 n adj V' r v i)) = 0) -> Sum n (fun i => p (y i)) = 0).
  { intros p P1 P2 P3. apply cond_eq. intros e He. pose proof (pos_INR n) as Pn. assert (H : 0 < e / (INR n + 1)) by (apply Rdiv_lt_0_compat; lra).
    destruct (limit_weights y _ Ly H) as (adj & S & _ & Q). unfold R_dist. rewrite Rminus_0_r.
    replace (Sum n (fun i => p (y i))) with (Sum n (fun i => p (y i)) - Sum n (fun i => p (law4 n adj V' r v i))) by (rewrite (P3 adj S); ring).
    rewrite <- Sum_minus. eapply Rle_lt_trans; [apply Sum_Rabs|]. apply Rle_lt_trans with (INR n * (e / (INR n + 1))).
    - rewrite <- Sum_const. apply Sum_le. intros i Hi. rewrite <- P1. eapply Rle_trans; [apply P2|]. left. now apply Q.
    - apply Rmult_lt_reg_r with (INR n + 1); [lra|]. replace (INR n * (e / (INR n + 1)) * (INR n + 1)) with (INR n * e) by (field; lra). lra. }
  assert (B : forall adj, simple_graph adj -> Sum n (fun i => fst (law4 n adj V' r v i)) = 0 /\ Sum n (fun i => snd (law4 n adj V' r v i)) = 0).
  { intros adj S. apply (balanced n adj V V' r v S); [apply potentials_part; [apply S|exact P]|apply apart_part; [apply S|exact A]]. }
  apply injective_projections; cbn; apply K; try reflexivity; try (intros; now apply B).
  - intros a. eapply Rle_trans; [apply Rmax_l|apply Rmax_Cmod].
  - intros a. eapply Rle_trans; [apply Rmax_r|apply Rmax_Cmod].
Qed.
(* and so for the convex hull *)
Lemma hull_power z : K10 n V' R0 r v z ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> i <> j -> Cmod (r i - r j)%C = R0 -> inner (force i j) (v i - v j)%C = 0) ->
  Sum n (fun i => inner (v i) (z i)) <= - / 2 * near_total - near_rate.
Proof.
  intros (m & c & y & Y & C1 & E) Z. set (X := - / 2 * near_total - near_rate).
  rewrite (Sum_ext n _ (fun i => Sum m (fun k => c k * inner (v i) (y k i)))).
  - rewrite Sum_swap. replace X with (Sum m (fun k => c k * X)) by (rewrite Sum_scal_r, C1; ring). apply Sum_le. intros k Hk. destruct (Y k Hk) as [Ck Lk].
    rewrite Sum_scal. apply Rmult_le_compat_l; [exact Ck|]. now apply limit_power.
  - intros i Hi. rewrite (E i Hi), inner_Csum. apply Sum_ext. intros k _. apply inner_scal.
Qed.
Lemma hull_bounded z S b : K10 n V' R0 r v z -> (forall i, (i < n)%nat -> Cmod (v i) <= S) ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> i <> j -> Cmod (r i - r j)%C <= R0 -> Cmod (force i j) <= b) -> 0 <= S -> 0 <= b ->
  forall i, (i < n)%nat -> Cmod (z i) <= INR n * (2 * S + b).
Proof.
  intros (m & c & y & Y & C1 & E) HS Hb S0 b0 i Hi. rewrite (E i Hi). eapply Rle_trans; [apply tanner_trees.norm_Csum|]. unfold norm.
  set (X := INR n * (2 * S + b)). replace X with (Sum m (fun k => c k * X)) by (rewrite Sum_scal_r, C1; ring). apply Sum_le. intros k Hk. destruct (Y k Hk) as [Ck Lk].
  rewrite Cmod_mult, Cmod_R, Rabs_pos_eq by exact Ck. apply Rmult_le_compat_l; [exact Ck|]. now apply (limit_bounded (y k) S b).
Qed.
Lemma hull_balanced z : K10 n V' R0 r v z -> Csum n z = 0%C.
Proof.
  intros (m & c & y & Y & C1 & E). assert (Q : forall k, (k < m)%nat -> Csum n (y k) = 0%C) by (intros k Hk; apply limit_balanced; now apply Y).
  apply injective_projections; cbn.
  - rewrite (Sum_ext n _ (fun i => Sum m (fun k => c k * fst (y k i)))); [|intros i Hi; rewrite (E i Hi); cbn; apply Sum_ext; intros; ring].
    rewrite Sum_swap. apply Sum_zero. intros k Hk. rewrite Sum_scal. pose proof (f_equal fst (Q k Hk)) as F. cbn in F. rewrite F. ring.
  - rewrite (Sum_ext n _ (fun i => Sum m (fun k => c k * snd (y k i)))); [|intros i Hi; rewrite (E i Hi); cbn; apply Sum_ext; intros; ring].
    rewrite Sum_swap. apply Sum_zero. intros k Hk. rewrite Sum_scal. pose proof (f_equal snd (Q k Hk)) as F. cbn in F. rewrite F. ring.
Qed.
End Limits.

(* ---- the energy (11) along a solution; a distance counts as one between d and R ---- *)
(* a function between two values stops at the lower and at the upper *)
Definition clamp (d R0 s : R) := Rmin (Rmax s d) R0.
Lemma clamp_in d R0 s : d < R0 -> d <= clamp d R0 s <= R0.
Proof. intros H. unfold clamp, Rmin, Rmax. destruct (Rle_dec s d); destruct (Rle_dec _ R0); lra. Qed.
Lemma clamp_gap d R0 s t : Rabs (clamp d R0 s - clamp d R0 t) <= Rabs (s - t).
Proof. unfold clamp, Rmin, Rmax, Rabs. destruct (Rle_dec s d), (Rle_dec t d); repeat destruct (Rle_dec _ _); repeat destruct (Rcase_abs _); lra. Qed.
Lemma clamp_mid d R0 s : d < s -> clamp d R0 s = Rmin s R0.
Proof. intros H. unfold clamp. now rewrite Rmax_left by lra. Qed.
(* a derivative that is 0 bounds what lies nearer *)
Lemma D_nearer (f g : R -> R) t : is_derive g t 0 -> (forall s, Rabs (f s - f t) <= Rabs (g s - g t)) -> is_derive f t 0.
Proof.
  intros D H. apply is_derive_Reals. apply is_derive_Reals in D. intros e He. destruct (D e He) as [d Hd]. exists d. intros h H0 Hh. specialize (Hd h H0 Hh).
  rewrite Rminus_0_r in *. apply Rle_lt_trans with (2 := Hd). unfold Rdiv. rewrite !Rabs_mult. apply Rmult_le_compat_r; [apply Rabs_pos|apply H].
Qed.
Lemma D_clamp d R0 (s : R -> R) t s' : d < s t -> d < R0 -> is_derive s t s' -> (s t = R0 -> s' = 0) ->
  is_derive (fun x => clamp d R0 (s x)) t (if Rlt_dec (s t) R0 then s' else 0).
Proof.
  intros Hd HR D Z. assert (C : continuous s t) by (apply (ex_derive_continuous s); now exists s').
  assert (Near : forall e, 0 < e -> locally t (fun x => Rabs (s x - s t) < e)).
  { intros e He. apply (C (fun y => Rabs (y - s t) < e)). exists (mkposreal e He). intros y Hy. exact Hy. }
  destruct (Rlt_dec (s t) R0) as [L|L].
  - apply (is_derive_ext_loc s); [|exact D]. generalize (Near (Rmin (s t - d) (R0 - s t)) ltac:(apply Rmin_glb_lt; lra)). apply filter_imp. intros x Hx.
    pose proof (Rmin_l (s t - d) (R0 - s t)). pose proof (Rmin_r (s t - d) (R0 - s t)). apply Rabs_lt_between in Hx. rewrite clamp_mid, Rmin_left by lra. reflexivity.
  - destruct (Req_dec (s t) R0) as [E|E].
    + rewrite (Z E) in D. apply (D_nearer _ s t D). intros x. apply clamp_gap.
    + apply (is_derive_ext_loc (fun _ => R0)); [|apply D_const]. generalize (Near (s t - R0) ltac:(lra)). apply filter_imp. intros x Hx.
      apply Rabs_lt_between in Hx. rewrite clamp_mid, Rmin_right by lra. reflexivity.
Qed.
Lemma slope_bound (f f' : R -> R) d R0 : 0 < d <= R0 -> (forall s, 0 < s -> is_derive f s (f' s) /\ continuity_pt f' s) ->
  exists L, 0 < L /\ (forall s, d <= s <= R0 -> Rabs (f' s) <= L) /\ forall x y, d <= x <= R0 -> d <= y <= R0 -> Rabs (f y - f x) <= L * Rabs (y - x).
Proof.
  intros Hd H. destruct (continuity_ab_maj (fun s => Rabs (f' s)) d R0 ltac:(lra)) as (m & M & _).
  { intros s Hs. apply continuity_pt_comp with (f1 := f') (f2 := Rabs); [apply H; lra|apply Rcontinuity_abs]. }
  exists (Rabs (f' m) + 1). pose proof (Rabs_pos (f' m)). split; [lra|]. split; [intros s Hs; specialize (M s Hs); lra|].
  assert (K : forall x y, d <= x <= y -> y <= R0 -> Rabs (f y - f x) <= (Rabs (f' m) + 1) * Rabs (y - x)).
  { intros x y Hx Hy. destruct (MVT_le f f' x y ltac:(lra)) as (c & Hc & E); [intros; apply H; lra|]. rewrite E, Rabs_mult. apply Rmult_le_compat_r; [apply Rabs_pos|].
    specialize (M c ltac:(lra)). lra. }
  intros x y Hx Hy. destruct (Rle_or_lt x y) as [L|L]; [apply K; lra|]. rewrite (Rabs_minus_sym (f y)), (Rabs_minus_sym y). apply K; lra.
Qed.
Lemma ac_axes (z : R -> C) : absolutely_continuous z -> ac (fun t => fst (z t)) /\ ac (fun t => snd (z t)).
Proof.
  intros A. split; intros T e HT He; destruct (A T e HT He) as (d & Hd & Q); exists d; (split; [exact Hd|]); intros m a b I O S; apply Rle_lt_trans with (2 := Q m a b I O S);
    apply Sum_le; intros k _.
  - eapply Rle_trans; [|apply Rmax_Cmod]. apply Rmax_l.
  - eapply Rle_trans; [|apply Rmax_Cmod]. apply Rmax_r.
Qed.
Lemma travelled (f f' : R -> R) : ac f' -> (forall t, 0 <= t -> is_derive f t (f' t)) -> forall T, 0 < T ->
  exists L, 0 < L /\ forall x y, 0 <= x <= y -> y <= T -> Rabs (f y - f x) <= L * (y - x).
Proof.
  intros A D T HT. destruct (ac_bounded f' T A) as (B & HB & M). exists B. split; [exact HB|]. intros x y Hx Hy.
  destruct (MVT_le f f' x y ltac:(lra)) as (c & Hc & E); [intros; apply D; lra|]. rewrite E, Rabs_mult, (Rabs_pos_eq (y - x)) by lra.
  apply Rmult_le_compat_r; [lra|]. apply M. lra.
Qed.
Lemma axes_Cmod z : Cmod z <= Rabs (fst z) + Rabs (snd z).
Proof.
  pose proof (Rabs_pos (fst z)). pose proof (Rabs_pos (snd z)). unfold Cmod. apply Rsqr_incr_0_var; [|lra]. rewrite Rsqr_sqrt by nra. unfold Rsqr.
  rewrite <- (pow2_abs (fst z)), <- (pow2_abs (snd z)). nra.
Qed.
(* motions of (10) while a condition on time holds; what a start allows *)
Definition moves_while n V' R0 (r v : nat -> R -> C) (during : R -> Prop) := apart_at n complete (fun i => r i 0) /\
  (forall t i, 0 <= t -> (i < n)%nat -> is_velocity (r i) t (v i t)) /\ (forall i, (i < n)%nat -> absolutely_continuous (v i)) /\
  exists N, negligible N /\ forall t, 0 <= t -> during t -> ~ N t -> apart_at n complete (fun i => r i t) ->
    exists z, K10 n V' R0 (fun i => r i t) (fun i => v i t) z /\ forall i, (i < n)%nat -> is_velocity (v i) t (z i).
Lemma always_moves n V' R0 r v : motion10 n V' R0 r v -> moves_while n V' R0 r v (fun _ => True).
Proof. intros (A & B & C & N & HN & Q). split; [exact A|]. split; [exact B|]. split; [exact C|]. exists N. split; [exact HN|]. intros t Ht _. now apply Q. Qed.
Definition start_power n (V : nat -> nat -> R -> R) R0 (q u : nat -> C) :=
  / 2 * Sum n (fun i => Sum n (fun j => if Nat.eqb i j then 0 else V i j (Rmin (Cmod (q i - q j)%C) R0)) + (fst (u i) ^ 2 + snd (u i) ^ 2)).
Definition allows n (V : nat -> nat -> R -> R) R0 (q u : nat -> C) d1 := 0 < d1 < R0 /\ forall i j, (i < n)%nat -> (j < n)%nat -> i <> j ->
  d1 < Cmod (q i - q j)%C /\ 2 * start_power n V R0 q u < V i j d1.
Section Switch.
Variables (n : nat) (V V' : nat -> nat -> R -> R) (R0 : R) (r v : nat -> R -> C).
Hypothesis HR : 0 < R0.
Hypothesis P : potentials n complete V V'.
Variable during : R -> Prop.
Hypothesis M : moves_while n V' R0 r v during.
Notation s i j t := (Cmod (r i t - r j t)%C).
Notation rs t := (fun i => r i t).
Notation vs t := (fun i => v i t).
Lemma v_axes i : (i < n)%nat -> ac (fun t => fst (v i t)) /\ ac (fun t => snd (v i t)).
Proof. intros Hi. apply ac_axes. now apply M. Qed.
Lemma linked_pair i j : i <> j -> complete i j = true.
Proof. intros Ne. unfold complete. destruct (Nat.eqb_spec i j); [contradiction|reflexivity]. Qed.
Lemma pair_slopes i j : (i < n)%nat -> (j < n)%nat -> i <> j -> forall x, 0 < x -> is_derive (V i j) x (V' i j x) /\ continuity_pt (V' i j) x /\ 0 <= V i j x.
Proof. intros Hi Hj Ne x Hx. apply (proj2 P i j Hi Hj (linked_pair i j Ne)). exact Hx. Qed.
Lemma distance_lipschitz i j : (i < n)%nat -> (j < n)%nat -> forall T, 0 < T -> exists L, 0 < L /\ forall x y, 0 <= x <= y -> y <= T -> Rabs (s i j y - s i j x) <= L * (y - x).
Proof.
  intros Hi Hj T HT. destruct M as (_ & Mv & _).
  destruct (travelled _ _ (proj1 (v_axes i Hi)) (fun t Ht => proj1 (Mv t i Ht Hi)) T HT) as (L1 & P1 & Q1).
  destruct (travelled _ _ (proj2 (v_axes i Hi)) (fun t Ht => proj2 (Mv t i Ht Hi)) T HT) as (L2 & P2 & Q2).
  destruct (travelled _ _ (proj1 (v_axes j Hj)) (fun t Ht => proj1 (Mv t j Ht Hj)) T HT) as (L3 & P3 & Q3).
  destruct (travelled _ _ (proj2 (v_axes j Hj)) (fun t Ht => proj2 (Mv t j Ht Hj)) T HT) as (L4 & P4 & Q4).
  exists (L1 + L2 + L3 + L4). split; [lra|]. intros x y Hx Hy. eapply Rle_trans; [apply tanner_saturated.Cmod_gap|].
  replace (r i y - r j y - (r i x - r j x))%C with ((r i y - r i x) - (r j y - r j x))%C by ring. eapply Rle_trans; [apply Cmod_triangle|]. rewrite Cmod_opp.
  pose proof (axes_Cmod (r i y - r i x)%C) as A1. pose proof (axes_Cmod (r j y - r j x)%C) as A2. cbn in A1, A2.
  specialize (Q1 x y Hx Hy). specialize (Q2 x y Hx Hy). specialize (Q3 x y Hx Hy). specialize (Q4 x y Hx Hy). cbv beta in *. unfold Rminus in *. lra.
Qed.
(* the rate of a distance of agents that are apart *)
Definition opening i j t := inner (r i t - r j t)%C (v i t - v j t)%C / s i j t.
Lemma distance_rate i j t : (i < n)%nat -> (j < n)%nat -> 0 <= t -> 0 < s i j t -> is_derive (fun x => s i j x) t (opening i j t).
Proof.
  intros Hi Hj Ht Hs. destruct M as (_ & Mv & _).
  refine (tanner_energy.D_norm (fun x => r i x - r j x)%C t (v i t - v j t)%C _ _).
  - apply tanner_energy.velocity_minus; now apply Mv.
  - intros E. cbv beta in E. rewrite E, Cmod_0 in Hs. lra.
Qed.
Section Floor.
Variable d : R.
Hypothesis Hd : 0 < d < R0.
Definition store i j t := if Nat.eqb i j then 0 else V i j (clamp d R0 (s i j t)).
Definition power t := / 2 * Sum n (fun i => Sum n (fun j => store i j t) + (fst (v i t) ^ 2 + snd (v i t) ^ 2)).
Lemma store_ac i j : (i < n)%nat -> (j < n)%nat -> ac (store i j).
Proof.
  intros Hi Hj. unfold store. destruct (Nat.eqb_spec i j) as [_|Ne].
  - apply ac_lipschitz. intros T _. exists 1. split; [lra|]. intros. rewrite Rminus_eq_0, Rabs_R0. lra.
  - apply (ac_of _ (fun t => s i j t)); [apply ac_lipschitz; intros; now apply distance_lipschitz|]. intros T _.
    destruct (slope_bound (V i j) (V' i j) d R0 ltac:(lra)) as (L & HL & _ & Q); [intros x Hx; destruct (pair_slopes i j Hi Hj Ne x Hx) as (A & B & _); now split|].
    exists L. split; [exact HL|]. intros x y _ _. eapply Rle_trans; [apply Q; apply clamp_in; lra|]. apply Rmult_le_compat_l; [lra|apply clamp_gap].
Qed.
Lemma power_ac : ac power.
Proof.
  apply ac_scal. apply (ac_Sum n (fun i t => Sum n (fun j => store i j t) + (fst (v i t) ^ 2 + snd (v i t) ^ 2))). intros i Hi. apply ac_plus.
  - apply (ac_Sum n (fun j t => store i j t)). intros j Hj. now apply store_ac.
  - apply ac_plus; apply ac_sqr; now apply v_axes.
Qed.
Lemma store_ge0 i j t : (i < n)%nat -> (j < n)%nat -> 0 <= store i j t.
Proof.
  intros Hi Hj. unfold store. destruct (Nat.eqb_spec i j) as [_|Ne]; [lra|]. apply pair_slopes; try assumption. pose proof (clamp_in d R0 (s i j t) ltac:(lra)). lra.
Qed.
Lemma power_row i t : (i < n)%nat -> Sum n (fun j => store i j t) + (fst (v i t) ^ 2 + snd (v i t) ^ 2) <= 2 * power t.
Proof.
  intros Hi. unfold power. replace (2 * (/ 2 * Sum n (fun i => Sum n (fun j => store i j t) + (fst (v i t) ^ 2 + snd (v i t) ^ 2))))
    with (Sum n (fun i => Sum n (fun j => store i j t) + (fst (v i t) ^ 2 + snd (v i t) ^ 2))) by field.
  apply (Sum_term_le n (fun i => Sum n (fun j => store i j t) + (fst (v i t) ^ 2 + snd (v i t) ^ 2))); [|exact Hi]. intros k Hk.
  pose proof (pow2_ge_0 (fst (v k t))). pose proof (pow2_ge_0 (snd (v k t))). assert (0 <= Sum n (fun j => store k j t)) by (apply Sum_ge0; intros; now apply store_ge0). lra.
Qed.
Lemma store_le i j t : (i < n)%nat -> (j < n)%nat -> store i j t <= 2 * power t.
Proof.
  intros Hi Hj. pose proof (power_row i t Hi). pose proof (pow2_ge_0 (fst (v i t))). pose proof (pow2_ge_0 (snd (v i t))).
  pose proof (Sum_term_le n (fun j => store i j t) j (fun k Hk => store_ge0 i k t Hi Hk) Hj). cbv beta in *. lra.
Qed.
Lemma speed_le i t : (i < n)%nat -> Cmod (v i t) ^ 2 <= 2 * power t.
Proof.
  intros Hi. pose proof (power_row i t Hi). assert (0 <= Sum n (fun j => store i j t)) by (apply Sum_ge0; intros; now apply store_ge0).
  rewrite <- inner_self, inner_xy. lra.
Qed.
(* the times at which a rate may be missing *)
Definition crossing t := exists i, (i < n)%nat /\ exists j, (j < n)%nat /\ 0 <= t /\ s i j t = R0 /\ opening i j t <> 0.
Lemma crossing_negligible : negligible crossing.
Proof.
  unfold crossing. apply (negligible_some n (fun i t => exists j, (j < n)%nat /\ 0 <= t /\ s i j t = R0 /\ opening i j t <> 0)). intros i Hi.
  apply (negligible_some n (fun j t => 0 <= t /\ s i j t = R0 /\ opening i j t <> 0)). intros j Hj.
  apply (negligible_crossings (fun t => s i j t) (opening i j) R0). intros t Ht E. apply distance_rate; try assumption. lra.
Qed.
Lemma force_opening i j t : (i < n)%nat -> (j < n)%nat -> i <> j -> inner (pull complete V' (rs t) i j) (v i t - v j t)%C = V' i j (s i j t) * opening i j t.
Proof.
  intros Hi Hj Ne. unfold pull, opening. rewrite (linked_pair i j Ne), inner_sym, inner_scal, inner_sym. unfold Rdiv. ring.
Qed.
Lemma store_rate i j t : (i < n)%nat -> (j < n)%nat -> 0 <= t -> (i <> j -> d < s i j t) -> ~ crossing t ->
  is_derive (store i j) t (if by_distance (rs t) R0 i j then inner (pull complete V' (rs t) i j) (v i t - v j t)%C else 0).
Proof.
  intros Hi Hj Ht Hs Nc. unfold store, by_distance. destruct (Nat.eqb_spec i j) as [_|Ne]; [apply D_const|]. cbn [negb andb]. specialize (Hs Ne).
  assert (Dc : is_derive (fun x => clamp d R0 (s i j x)) t (if Rlt_dec (s i j t) R0 then opening i j t else 0)).
  { apply (D_clamp d R0 (fun x => s i j x) t (opening i j t) Hs); [lra|apply distance_rate; try assumption; lra|]. intros E. apply NNPP. intros Q. apply Nc.
    exists i. split; [exact Hi|]. exists j. now repeat split. }
  pose proof (clamp_in d R0 (s i j t) ltac:(lra)) as Ci. destruct (pair_slopes i j Hi Hj Ne (clamp d R0 (s i j t)) ltac:(lra)) as (Dv & _).
  eapply D_eq; [apply (D_comp (V i j) (fun x => clamp d R0 (s i j x)) t _ _ Dv Dc)|].
  destruct (Rlt_dec (s i j t) R0) as [L|L]; [|ring]. rewrite force_opening by assumption. rewrite clamp_mid, Rmin_left by lra. reflexivity.
Qed.
Lemma power_rate : exists N, negligible N /\ forall t, 0 <= t -> during t -> ~ N t -> (forall i j, (i < n)%nat -> (j < n)%nat -> i <> j -> d < s i j t) ->
  exists z, K10 n V' R0 (rs t) (vs t) z /\ (forall i, (i < n)%nat -> is_velocity (v i) t (z i)) /\
    exists l, is_derive power t l /\ l <= - / 2 * near_total n R0 (rs t) (vs t).
Proof.
  destruct M as (_ & _ & _ & N & HN & Mz). exists (fun t => N t \/ crossing t). split; [apply negligible_or; [exact HN|exact crossing_negligible]|].
  intros t Ht Du No Hs. assert (A : apart_at n complete (rs t)).
  { intros i j Hi Hj L E. assert (Ne : i <> j) by (intros ->; unfold complete in L; rewrite Nat.eqb_refl in L; discriminate).
    specialize (Hs i j Hi Hj Ne). rewrite E in Hs. replace (r j t - r j t)%C with (RtoC 0) in Hs by ring. rewrite Cmod_0 in Hs. lra. }
  destruct (Mz t Ht Du ltac:(tauto) A) as (z & Kz & Vz). exists z. split; [exact Kz|]. split; [exact Vz|].
  exists (near_rate n V' R0 (rs t) (vs t) + Sum n (fun i => inner (v i t) (z i))). split.
  - unfold power. eapply D_eq.
    + apply D_scal. apply (D_Sum n (fun i x => Sum n (fun j => store i j x) + (fst (v i x) ^ 2 + snd (v i x) ^ 2))
        (fun i => Sum n (fun j => if by_distance (rs t) R0 i j then inner (pull complete V' (rs t) i j) (v i t - v j t)%C else 0) +
          (2 * fst (v i t) * fst (z i) + 2 * snd (v i t) * snd (z i)))).
      intros i Hi. apply D_plus.
      * apply (D_Sum n (fun j x => store i j x)). intros j Hj. apply store_rate; try assumption; [now apply Hs|tauto].
      * apply D_plus; apply D_sqr; now apply Vz.
    + rewrite Sum_plus, Rmult_plus_distr_l. unfold near_rate. f_equal. rewrite <- Sum_scal. apply Sum_ext. intros i _. rewrite inner_xy. field.
  - assert (Q : Sum n (fun i => inner (v i t) (z i)) <= - / 2 * near_total n R0 (rs t) (vs t) - near_rate n V' R0 (rs t) (vs t)); [|lra].
    apply (hull_power n V V' R0 (rs t) (vs t) P A z Kz). intros i j Hi Hj Ne E. rewrite force_opening by assumption.
    assert (O : opening i j t = 0); [|rewrite O; ring]. apply NNPP. intros Q. apply No. right. exists i. split; [exact Hi|]. exists j. now repeat split.
Qed.
Lemma near_total_ge0 t : 0 <= near_total n R0 (rs t) (vs t).
Proof. apply Sum_ge0. intros i _. apply Sum_ge0. intros j _. destruct (by_distance (rs t) R0 i j); [apply dist2_ge0|lra]. Qed.
Lemma power_falls a b c : 0 <= a <= b -> (forall t, a <= t <= b -> during t) -> (forall t i j, a <= t <= b -> (i < n)%nat -> (j < n)%nat -> i <> j -> d < s i j t) ->
  (forall t, a <= t <= b -> 2 * c <= near_total n R0 (rs t) (vs t)) -> power b <= power a - c * (b - a).
Proof.
  intros Hab Du Hs Hc. destruct power_rate as (N & HN & Q). replace (power a - c * (b - a)) with (power a + - c * (b - a)) by ring.
  apply (ac_le power N a b (- c) power_ac HN Hab). intros t Ht Nt. destruct (Q t ltac:(lra) (Du t Ht) Nt (fun i j => Hs t i j Ht)) as (z & _ & _ & l & Dl & Hl).
  exists l. split; [exact Dl|]. specialize (Hc t Ht). lra.
Qed.
End Floor.
Lemma distance_near i j t e : (i < n)%nat -> (j < n)%nat -> 0 <= t -> 0 < e -> exists h, 0 < h /\ forall u, 0 <= u -> Rabs (u - t) < h -> Rabs (s i j u - s i j t) < e.
Proof.
  intros Hi Hj Ht He. destruct (distance_lipschitz i j Hi Hj (t + 1) ltac:(lra)) as (L & HL & Q). assert (E : 0 < e / (L + 1)) by (apply Rdiv_lt_0_compat; lra).
  exists (Rmin 1 (e / (L + 1))). split; [apply Rmin_glb_lt; lra|]. intros u Hu Hh. pose proof (Rmin_l 1 (e / (L + 1))). pose proof (Rmin_r 1 (e / (L + 1))).
  assert (K : forall x y, 0 <= x <= y -> y <= t + 1 -> y - x < e / (L + 1) -> Rabs (s i j y - s i j x) < e).
  { intros x y Hx Hy G. apply Rle_lt_trans with (1 := Q x y Hx Hy). apply Rle_lt_trans with ((L + 1) * (y - x)); [apply Rmult_le_compat_r; lra|].
    apply (Rmult_lt_compat_l (L + 1)) in G; [|lra]. replace ((L + 1) * (e / (L + 1))) with e in G by (field; lra). exact G. }
  apply Rabs_lt_between in Hh. destruct (Rle_or_lt u t) as [G|G]; [rewrite Rabs_minus_sym|]; apply K; lra.
Qed.
(* linked or not, the agents keep a distance that the start allows *)
Lemma kept_apart_while d1 : allows n V R0 (rs 0) (vs 0) d1 -> forall t, 0 <= t -> (forall u, 0 <= u <= t -> during u) ->
  forall i j, (i < n)%nat -> (j < n)%nat -> i <> j -> d1 < s i j t.
Proof.
  intros (Hd1 & Al) t2 Ht2 Du. set (c0 := start_power n V R0 (rs 0) (vs 0)) in *. set (ok := fun t => forall i j, (i < n)%nat -> (j < n)%nat -> i <> j -> d1 < s i j t).
  assert (Ok0 : ok 0) by (intros i j Hi Hj Ne; now apply (Al i j)).
  change (ok t2). apply NNPP. intros Bad.
  destruct (completeness (fun t => 0 <= t /\ forall u, 0 <= u <= t -> ok u)) as (t1 & Ub & Lub).
  { exists t2. intros t [Ht K]. apply Rnot_lt_le. intros L. apply Bad, K. lra. }
  { exists 0. split; [lra|]. intros u Hu. now replace u with 0 by lra. }
  assert (T0 : 0 <= t1) by (apply Ub; split; [lra|]; intros u Hu; now replace u with 0 by lra).
  assert (T2 : t1 <= t2) by (apply Lub; intros t [Ht K]; apply Rnot_lt_le; intros L; apply Bad, K; lra).
  assert (Before : forall u, 0 <= u < t1 -> ok u).
  { intros u Hu. apply NNPP. intros B. assert (t1 <= u); [|lra]. apply Lub. intros t [Ht K]. apply Rnot_lt_le. intros L. apply B, K. lra. }
  assert (At : forall i j, (i < n)%nat -> (j < n)%nat -> i <> j -> d1 <= s i j t1).
  { intros i j Hi Hj Ne. destruct (Req_dec t1 0) as [->|N0]; [left; now apply Ok0|]. apply Rnot_lt_le. intros L.
    destruct (distance_near i j t1 (d1 - s i j t1) Hi Hj T0 ltac:(lra)) as (h & Hh & K). set (u := Rmax 0 (t1 - h / 2)).
    assert (U : 0 <= u < t1 /\ Rabs (u - t1) < h). { unfold u, Rmax. destruct (Rle_dec 0 (t1 - h / 2)); rewrite Rabs_left by lra; lra. }
    pose proof (Before u (proj1 U) i j Hi Hj Ne). specialize (K u (proj1 (proj1 U)) (proj2 U)). apply Rabs_lt_between in K. lra. }
  destruct (classic (ok t1)) as [Good|Meet].
  - destruct (small2 n (fun i j h => i <> j -> forall u, 0 <= u -> Rabs (u - t1) < h -> d1 < s i j u)) as (h & Hh & K).
    { intros i j h h' K L Ne u Hu Hx. apply (K Ne u Hu). lra. }
    { intros i j Hi Hj. destruct (Nat.eq_dec i j) as [->|Ne]; [exists 1; split; [lra|congruence]|]. pose proof (Good i j Hi Hj Ne) as G.
      destruct (distance_near i j t1 (s i j t1 - d1) Hi Hj T0 ltac:(lra)) as (h & Hh & K). exists h. split; [exact Hh|]. intros _ u Hu Hx.
      specialize (K u Hu Hx). apply Rabs_lt_between in K. lra. }
    assert (t1 + h / 2 <= t1); [|lra]. apply Ub. split; [lra|]. intros u Hu. destruct (Rlt_le_dec u t1) as [L|L]; [apply Before; lra|].
    intros i j Hi Hj Ne. apply (K i j Hi Hj Ne u ltac:(lra)). rewrite Rabs_pos_eq; lra.
  - (* the energy forbids it *)
    assert (Pair : exists i j, (i < n)%nat /\ (j < n)%nat /\ i <> j /\ s i j t1 = d1).
    { apply NNPP. intros No. apply Meet. intros i j Hi Hj Ne. destruct (At i j Hi Hj Ne) as [L|E]; [exact L|]. exfalso. apply No. exists i, j. now repeat split. }
    destruct Pair as (i & j & Hi & Hj & Ne & E). set (d := d1 / 2). assert (Hd : 0 < d < R0) by (unfold d; lra).
    assert (F : power d t1 <= power d 0 - 0 * (t1 - 0)).
    { apply (power_falls d Hd); [lra|intros t Ht; apply Du; lra| |].
      - intros t k l Ht Hk Hl Nkl. assert (d1 <= s k l t); [|unfold d; lra]. destruct (Req_dec t t1) as [->|Nt]; [now apply At|]. left. apply (Before t ltac:(lra)); assumption.
      - intros t _. pose proof (near_total_ge0 t). lra. }
    assert (E0 : power d 0 = c0).
    { unfold power, c0, start_power. f_equal. apply Sum_ext. intros k Hk. f_equal. apply Sum_ext. intros l Hl. unfold store. destruct (Nat.eqb_spec k l) as [_|Nkl]; [reflexivity|].
      pose proof (Ok0 k l Hk Hl Nkl). rewrite clamp_mid by (unfold d; lra). reflexivity. }
    pose proof (store_le d Hd i j t1 Hi Hj) as G. unfold store in G. destruct (Nat.eqb_spec i j); [contradiction|].
    rewrite clamp_mid, Rmin_left in G by (rewrite E; unfold d; lra). rewrite E in G. pose proof (proj2 (Al i j Hi Hj Ne)). lra.
Qed.
End Switch.
Lemma start_allows n V V' R0 q u : 0 < R0 -> potentials n complete V V' -> apart_at n complete q -> exists d1, allows n V R0 q u d1.
Proof.
  intros HR P A0. set (c0 := start_power n V R0 q u).
  destruct (small2 n (fun i j e => i <> j -> 2 * e < Cmod (q i - q j)%C /\ forall x, 0 < x <= e -> 2 * c0 < V i j x)) as (e & He & Q).
  { intros i j e e' H L Ne. destruct (H Ne) as [H1 H2]. split; [lra|]. intros x Hx. apply H2. lra. }
  { intros i j Hi Hj. destruct (Nat.eq_dec i j) as [->|Ne]; [exists 1; split; [lra|congruence]|].
    pose proof (tanner_flock.norm_neq _ _ (A0 i j Hi Hj (linked_pair i j Ne))) as N. change (0 < Cmod (q i - q j)%C) in N.
    destruct (proj2 P i j Hi Hj (linked_pair i j Ne)) as (_ & Z & _). destruct (Z (2 * c0)) as (x & Hx & Zx).
    exists (Rmin (Cmod (q i - q j)%C / 3) (x / 2)). split; [apply Rmin_glb_lt; lra|]. intros _.
    pose proof (Rmin_l (Cmod (q i - q j)%C / 3) (x / 2)). pose proof (Rmin_r (Cmod (q i - q j)%C / 3) (x / 2)).
    split; [lra|]. intros y Hy. apply Zx. lra. }
  pose proof (Rmin_l e (R0 / 2)). pose proof (Rmin_r e (R0 / 2)). assert (H1 : 0 < Rmin e (R0 / 2)) by (apply Rmin_glb_lt; lra).
  exists (Rmin e (R0 / 2)). split; [lra|]. intros i j Hi Hj Ne. destruct (Q i j Hi Hj Ne) as [Q1 Q2]. split; [lra|]. apply Q2. lra.
Qed.
Lemma kept_apart n V V' R0 r v : 0 < R0 -> potentials n complete V V' -> motion10 n V' R0 r v ->
  exists d1, 0 < d1 < R0 /\ forall t i j, 0 <= t -> (i < n)%nat -> (j < n)%nat -> i <> j -> d1 < Cmod (r i t - r j t)%C.
Proof.
  intros HR P M. destruct (start_allows n V V' R0 (fun i => r i 0) (fun i => v i 0) HR P (proj1 M)) as (d1 & Al). exists d1. split; [apply Al|].
  intros t i j Ht. apply (kept_apart_while n V V' R0 r v HR P _ (always_moves n V' R0 r v M) d1 Al t Ht). intros; exact I.
Qed.

(* ---- agreement ---- *)
Section Agree.
Variables (n : nat) (V V' : nat -> nat -> R -> R) (R0 : R) (r v : nat -> R -> C).
Hypothesis HR : 0 < R0.
Hypothesis P : potentials n complete V V'.
Hypothesis M : motion10 n V' R0 r v.
Notation s i j t := (Cmod (r i t - r j t)%C).
Variable d : R.
Hypothesis Hd : 0 < d < R0.
Hypothesis Far : forall t i j, 0 <= t -> (i < n)%nat -> (j < n)%nat -> i <> j -> d < s i j t.
Notation E t := (power n V R0 r v d t).
Lemma E_falls a b : 0 <= a <= b -> E b <= E a.
Proof.
  intros Hab. replace (E a) with (E a - 0 * (b - a)) by ring. apply (power_falls n V V' R0 r v P _ (always_moves n V' R0 r v M) d Hd a b 0 Hab (fun _ _ => I)).
  - intros t i j Ht. apply Far. lra.
  - intros t _. pose proof (near_total_ge0 n R0 r v t). lra.
Qed.
Lemma E_ge0 t : 0 <= E t.
Proof.
  unfold power. apply Rmult_le_pos; [lra|]. apply Sum_ge0. intros i Hi. pose proof (pow2_ge_0 (fst (v i t))). pose proof (pow2_ge_0 (snd (v i t))).
  assert (0 <= Sum n (fun j => store V R0 r d i j t)) by (apply Sum_ge0; intros; now apply (store_ge0 n V V')). lra.
Qed.
Notation S := (2 * E 0 + 1).
Lemma v_bounded t i : 0 <= t -> (i < n)%nat -> Cmod (v i t) <= S.
Proof.
  intros Ht Hi. pose proof (speed_le n V V' R0 r v P d Hd i t Hi) as Q. pose proof (E_falls 0 t ltac:(lra)) as F. pose proof (E_ge0 0) as G.
  pose proof (Cmod_ge_0 (v i t)) as C0. apply Rnot_lt_le. intros L. nra.
Qed.
Lemma rates_bounded : exists N B, negligible N /\ 0 < B /\ forall t, 0 <= t -> ~ N t -> exists z, Csum n z = 0%C /\
  forall i, (i < n)%nat -> is_velocity (v i) t (z i) /\ Cmod (z i) <= B.
Proof.
  destruct (power_rate n V V' R0 r v P _ (always_moves n V' R0 r v M) d Hd) as (N & HN & Q).
  assert (Fb : exists b, 0 < b /\ forall i j, (i < n)%nat -> (j < n)%nat -> i <> j -> forall x, d <= x <= R0 -> Rabs (V' i j x) <= b).
  { apply (tanner_flock.uniform_pairs n (fun i j b => i <> j -> forall x, d <= x <= R0 -> Rabs (V' i j x) <= b)).
    - intros i j b b' H L Ne x Hx. specialize (H Ne x Hx). lra.
    - intros i j Hi Hj. destruct (Nat.eq_dec i j) as [->|Ne]; [exists 1; congruence|].
      destruct (slope_bound (V i j) (V' i j) d R0 ltac:(lra)) as (L & HL & B & _).
      { intros x Hx. destruct (pair_slopes n V V' P i j Hi Hj Ne x Hx) as (A1 & A2 & _). now split. }
      exists L. intros _. exact B. }
  destruct Fb as (b & Hb & Fb). pose proof (E_ge0 0) as G. pose proof (pos_INR n) as Pn.
  exists N, (INR n * (2 * S + b) + 1). split; [exact HN|]. split; [assert (0 <= INR n * (2 * S + b)) by (apply Rmult_le_pos; lra); lra|].
  intros t Ht Nt. destruct (Q t Ht I Nt (fun i j => Far t i j Ht)) as (z & Kz & Vz & _). exists z.
  assert (A : apart_at n complete (fun i => r i t)).
  { intros i j Hi Hj L X. assert (Ne : i <> j) by (intros ->; unfold complete in L; rewrite Nat.eqb_refl in L; discriminate).
    pose proof (Far t i j Ht Hi Hj Ne) as F. rewrite X in F. replace (r j t - r j t)%C with (RtoC 0) in F by ring. rewrite Cmod_0 in F. lra. }
  split; [now apply (hull_balanced n V V' R0 (fun i => r i t) (fun i => v i t) P A)|]. intros i Hi. split; [now apply Vz|].
  pose proof (hull_bounded n V V' R0 (fun i => r i t) (fun i => v i t) P A z S b Kz (fun k Hk => v_bounded t k Ht Hk)) as H.
  specialize (H ltac:(intros k l Hk Hl Ne Le; unfold pull; rewrite (linked_pair k l Ne), Cmod_mult, Cmod_R; pose proof (Far t k l Ht Hk Hl Ne);
    unfold Rdiv; rewrite Rabs_mult, (Rabs_pos_eq (/ _)) by (left; apply Rinv_0_lt_compat; lra); rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra; apply Fb; try assumption; lra)
    ltac:(lra) ltac:(lra) i Hi). lra.
Qed.
Definition gaps t := Sum n (fun i => Sum n (fun j => (fst (v i t) + -1 * fst (v j t)) ^ 2 + (snd (v i t) + -1 * snd (v j t)) ^ 2)).
Lemma gaps_slow : exists K, 0 < K /\ forall a b, 0 <= a <= b -> gaps a - K * (b - a) <= gaps b.
Proof.
  destruct rates_bounded as (N & B & HN & HB & Q). pose proof (E_ge0 0) as G. pose proof (pos_INR n) as Pn. set (k := 2 * (2 * S * (2 * B))).
  assert (Hk : 0 < k) by (unfold k; assert (0 < 2 * S * (2 * B)) by (apply Rmult_lt_0_compat; lra); lra).
  assert (Hn : 0 <= INR n * (INR n * k)) by (apply Rmult_le_pos; [lra|apply Rmult_le_pos; lra]). exists (INR n * (INR n * k) + 1). split; [lra|]. intros a b Hab.
  assert (F : -1 * gaps b <= -1 * gaps a + (INR n * (INR n * k) + 1) * (b - a)); [|lra].
  apply (ac_le (fun t => -1 * gaps t) N a b); [|exact HN|exact Hab|].
  - apply ac_scal. apply (ac_Sum n (fun i t => Sum n (fun j => (fst (v i t) + -1 * fst (v j t)) ^ 2 + (snd (v i t) + -1 * snd (v j t)) ^ 2))). intros i Hi.
    apply (ac_Sum n (fun j t => (fst (v i t) + -1 * fst (v j t)) ^ 2 + (snd (v i t) + -1 * snd (v j t)) ^ 2)). intros j Hj.
    destruct (v_axes n V' R0 r v _ (always_moves n V' R0 r v M) i Hi), (v_axes n V' R0 r v _ (always_moves n V' R0 r v M) j Hj).
    apply ac_plus; apply (ac_sqr (fun t => _ (v i t) + -1 * _ (v j t))); apply ac_plus; try assumption; now apply ac_scal.
  - intros t Ht Nt. destruct (Q t ltac:(lra) Nt) as (z & _ & Vz). eexists. split.
    + apply D_scal. apply (D_Sum n (fun i t => Sum n (fun j => (fst (v i t) + -1 * fst (v j t)) ^ 2 + (snd (v i t) + -1 * snd (v j t)) ^ 2))
        (fun i => Sum n (fun j => 2 * (fst (v i t) + -1 * fst (v j t)) * (fst (z i) + -1 * fst (z j)) + 2 * (snd (v i t) + -1 * snd (v j t)) * (snd (z i) + -1 * snd (z j))))).
      intros i Hi. apply (D_Sum n (fun j t => (fst (v i t) + -1 * fst (v j t)) ^ 2 + (snd (v i t) + -1 * snd (v j t)) ^ 2)
        (fun j => 2 * (fst (v i t) + -1 * fst (v j t)) * (fst (z i) + -1 * fst (z j)) + 2 * (snd (v i t) + -1 * snd (v j t)) * (snd (z i) + -1 * snd (z j)))).
      intros j Hj. destruct (Vz i Hi) as [[Z1 Z2] _], (Vz j Hj) as [[Z3 Z4] _].
      apply D_plus; [apply (D_sqr (fun t => fst (v i t) + -1 * fst (v j t)))|apply (D_sqr (fun t => snd (v i t) + -1 * snd (v j t)))]; apply D_plus; try assumption; now apply D_scal.
    + cbv beta. rewrite <- Sum_scal. apply Rle_trans with (INR n * (INR n * k)); [|lra]. rewrite <- Sum_const. apply Sum_le. intros i Hi. rewrite <- Sum_scal, <- Sum_const.
      apply Sum_le. intros j Hj. destruct (Vz i Hi) as [_ Bi], (Vz j Hj) as [_ Bj]. pose proof (v_bounded t i ltac:(lra) Hi) as Si. pose proof (v_bounded t j ltac:(lra) Hj) as Sj.
      pose proof (tanner_saturated.inner_le (v j t - v i t)%C (z i - z j)%C) as I.
      assert (A1 : Cmod (v j t - v i t)%C <= 2 * S) by (eapply Rle_trans; [apply Cmod_triangle|]; rewrite Cmod_opp; lra).
      assert (A2 : Cmod (z i - z j)%C <= 2 * B) by (eapply Rle_trans; [apply Cmod_triangle|]; rewrite Cmod_opp; lra).
      assert (A3 : Cmod (v j t - v i t)%C * Cmod (z i - z j)%C <= 2 * S * (2 * B)) by (apply Rmult_le_compat; try apply Cmod_ge_0; assumption).
      rewrite inner_xy in I. cbn in I. unfold k. lra.
Qed.
Hypothesis Co : forall t, 0 <= t -> strongly_connected n (by_distance (fun i => r i t) R0).
Lemma gaps_total t : 0 <= t -> gaps t <= INR n ^ 4 * near_total n R0 (fun i => r i t) (fun i => v i t).
Proof.
  intros Ht. assert (T : near_total n R0 (fun i => r i t) (fun i => v i t) = total n (by_distance (fun i => r i t) R0) (fun i => v i t)).
  { apply Sum_ext. intros i _. apply Sum_ext. intros j _. unfold w. destruct (by_distance _ R0 i j); ring. }
  rewrite T. set (X := total _ _ _). replace (INR n ^ 4 * X) with (INR n * (INR n * (INR n * INR n * X))) by ring.
  unfold gaps. rewrite <- Sum_const. apply Sum_le. intros i Hi. rewrite <- Sum_const. apply Sum_le. intros j Hj.
  pose proof (tanner2_distance.connected_le n _ (fun i => v i t) i j (Co t Ht) Hi Hj) as Q. rewrite dist2_xy in Q. fold X in Q. cbv beta in Q. lra.
Qed.
Lemma gaps_vanish : (1 <= n)%nat -> forall e, 0 < e -> exists T, 0 <= T /\ forall t, T <= t -> gaps t < e.
Proof.
  intros Hn. destruct gaps_slow as (K & HK & Slow). assert (Pn : 0 < INR n) by (apply lt_0_INR; lia). assert (P4 : 0 < INR n ^ 4) by now apply pow_lt.
  apply (tanner2_distance.settles (fun t => E t) gaps).
  - intros a b Hab. now apply E_falls.
  - intros t _. apply E_ge0.
  - intros e He. set (h := e / (2 * K)). set (c := e / (4 * INR n ^ 4)).
    assert (Ph : 0 < h) by (apply Rdiv_lt_0_compat; lra). assert (Pc : 0 < c) by (apply Rdiv_lt_0_compat; lra).
    exists (c * h), h. split; [now apply Rmult_lt_0_compat|]. split; [exact Ph|]. intros t Ht G.
    replace (c * h) with (c * (t + h - t)) by ring. apply (power_falls n V V' R0 r v P _ (always_moves n V' R0 r v M) d Hd t (t + h) c ltac:(lra) (fun _ _ => I)).
    + intros u i j Hu. apply Far. lra.
    + intros u Hu. pose proof (Slow t u ltac:(lra)) as Sx. pose proof (gaps_total u ltac:(lra)) as Gx.
      assert (K * (u - t) <= e / 2). { apply Rle_trans with (K * h); [apply Rmult_le_compat_l; lra|]. unfold h. right. field. lra. }
      apply (Rmult_le_reg_l (INR n ^ 4)); [exact P4|]. replace (INR n ^ 4 * (2 * c)) with (e / 2) by (unfold c; field; lra). lra.
Qed.
End Agree.
(* tanner2.arbswitch, the first corrected clause; tanner2.thm2_vel: velocities agree in the limit *)
Theorem velocities_agree : forall n V V' R0 r v, 0 < R0 -> potentials n complete V V' -> motion10 n V' R0 r v ->
  (forall t, 0 <= t -> strongly_connected n (by_distance (fun i => r i t) R0)) ->
  forall i j, (i < n)%nat -> (j < n)%nat -> forall e, 0 < e -> exists T, forall t, T <= t -> Cmod (v i t - v j t)%C < e.
Proof.
  intros n V V' R0 r v HR P M Co i j Hi Hj e He. destruct (kept_apart n V V' R0 r v HR P M) as (d & Hd & Far).
  destruct (gaps_vanish n V V' R0 r v P M d Hd Far Co ltac:(lia) (e ^ 2) ltac:(cbn; nra)) as (T & _ & Q). exists T. intros t Ht. specialize (Q t Ht).
  apply Rnot_le_lt. intros L. apply (Rlt_irrefl (e ^ 2)). apply Rle_lt_trans with (2 := Q). apply Rle_trans with (Cmod (v i t - v j t)%C ^ 2); [apply pow_incr; lra|].
  rewrite <- inner_self, inner_xy. unfold gaps.
  set (g := fun i j => (fst (v i t) + -1 * fst (v j t)) ^ 2 + (snd (v i t) + -1 * snd (v j t)) ^ 2).
  assert (G0 : forall a b, 0 <= g a b) by (intros a b; unfold g; pose proof (pow2_ge_0 (fst (v a t) + -1 * fst (v b t))); pose proof (pow2_ge_0 (snd (v a t) + -1 * snd (v b t))); lra).
  apply Rle_trans with (g i j); [unfold g; cbn; right; ring|]. apply Rle_trans with (Sum n (g i)); [now apply (Sum_term_le n (g i) j)|].
  apply (Sum_term_le n (fun i => Sum n (g i)) i); [|exact Hi]. intros a _. now apply Sum_ge0.
Qed.
(* tanner2.eq14 where links switch: the limits of the law are normal to 1, and velocities that stay equal do not change *)
Theorem equal_stay : forall n V V' R0 r v, 0 < R0 -> potentials n complete V V' -> motion10 n V' R0 r v ->
  (forall t z, 0 <= t -> apart_at n complete (fun i => r i t) -> K10 n V' R0 (fun i => r i t) (fun i => v i t) z -> Csum n z = 0%C) /\
  ((forall t i j, 0 <= t -> (i < n)%nat -> (j < n)%nat -> v i t = v j t) -> forall t i, 0 <= t -> (i < n)%nat -> v i t = v i 0).
Proof.
  intros n V V' R0 r v HR P M. split.
  - intros t z _ A Kz. now apply (hull_balanced n V V' R0 (fun i => r i t) (fun i => v i t) P A).
  - intros Eq t i Ht Hi. destruct (kept_apart n V V' R0 r v HR P M) as (d & Hd & Far).
    destruct (rates_bounded n V V' R0 r v P M d Hd Far) as (N & B & HN & _ & Q).
    assert (Z : forall u, 0 <= u -> ~ N u -> is_velocity (v i) u 0%C).
    { intros u Hu Nu. destruct (Q u Hu Nu) as (z & Zs & Vz). assert (Pn : 0 < INR n) by (apply lt_0_INR; lia).
      assert (Ez : forall k, (k < n)%nat -> z k = z i).
      { intros k Hk. apply (equal_rates (v k) (v i) u); [now apply Vz|now apply Vz|]. intros x Hx. apply Eq; try assumption. lra. }
      assert (F : z i = 0%C).
      { pose proof (f_equal fst Zs) as Z1. pose proof (f_equal snd Zs) as Z2. unfold Csum in Z1, Z2. cbn [fst snd RtoC] in Z1, Z2.
        rewrite (Sum_ext n _ (fun _ => fst (z i))) in Z1 by (intros k Hk; now rewrite Ez). rewrite (Sum_ext n _ (fun _ => snd (z i))) in Z2 by (intros k Hk; now rewrite Ez).
        rewrite Sum_const in Z1, Z2. apply injective_projections; cbn; apply (Rmult_eq_reg_l (INR n)); lra. }
      rewrite <- F. now apply Vz. }
    assert (K : forall p : C -> R, ac (fun u => p (v i u)) -> (forall u, 0 <= u -> ~ N u -> is_derive (fun u => p (v i u)) u 0) -> p (v i t) = p (v i 0)).
    { intros p A D. apply Rle_antisym.
      - apply (ac_falls (fun u => p (v i u)) N 0 t A HN ltac:(lra)). intros u Hu Nu. exists 0. split; [apply D; [lra|exact Nu]|lra].
      - apply Ropp_le_cancel. replace (- p (v i t)) with (-1 * p (v i t)) by ring. replace (- p (v i 0)) with (-1 * p (v i 0)) by ring.
        apply (ac_falls (fun u => -1 * p (v i u)) N 0 t (ac_scal (-1) _ A) HN ltac:(lra)). intros u Hu Nu. exists (-1 * 0). split; [apply D_scal, D; [lra|exact Nu]|lra]. }
    destruct (v_axes n V' R0 r v _ (always_moves n V' R0 r v M) i Hi) as [A1 A2]. apply injective_projections.
    + apply (K fst A1). intros u Hu Nu. apply (Z u Hu Nu).
    + apply (K snd A2). intros u Hu Nu. apply (Z u Hu Nu).
Qed.
(* ---- motions that last until T ---- *)
(* a function that goes on straight from c *)
Lemma straight_on (f : R -> R) c l t l' : 0 <= t -> (t <= c -> is_derive f t l') -> (c <= t -> l' = l) ->
  is_derive (fun u => f (Rmin u c) + l * Rmax (u - c) 0) t l'.
Proof.
  intros Ht D E. destruct (Rtotal_order t c) as [L|[Q|L]].
  - specialize (D ltac:(lra)). apply (is_derive_ext_loc f); [|exact D]. exists (mkposreal (c - t) ltac:(lra)). intros u Hu. change (Rabs (u - t) < c - t) in Hu.
    apply Rabs_lt_between in Hu. rewrite Rmin_left, Rmax_right by lra. Rring.
  - subst t. specialize (D ltac:(lra)). rewrite (E ltac:(lra)) in *.
    assert (Z : is_derive (fun u => f (Rmin u c) + l * Rmax (u - c) 0 + - l * u) c 0).
    { apply (D_nearer _ (fun u => f u + - l * u)).
      - eapply D_eq; [apply D_plus; [exact D|apply D_scal, D_id]|]. Rring.
      - intros s. rewrite (Rmin_left c c), (Rmax_right (c - c) 0) by lra. destruct (Rle_or_lt s c) as [L|L].
        + rewrite Rmin_left, Rmax_right by lra. right. f_equal. ring.
        + rewrite Rmin_right, Rmax_left by lra. replace (f c + l * (s - c) + - l * s - (f c + l * 0 + - l * c)) with 0 by ring. rewrite Rabs_R0. apply Rabs_pos. }
    apply (is_derive_ext (fun u => f (Rmin u c) + l * Rmax (u - c) 0 + - l * u + l * u)); [intros; Rring|].
    eapply D_eq; [apply D_plus; [exact Z|apply D_scal, D_id]|]. Rring.
  - rewrite (E ltac:(lra)). apply (is_derive_ext_loc (fun u => f c + l * (u - c))).
    + exists (mkposreal (t - c) ltac:(lra)). intros u Hu. change (Rabs (u - t) < t - c) in Hu. apply Rabs_lt_between in Hu. rewrite Rmin_right, Rmax_left by lra. reflexivity.
    + auto_derive; [exact I|ring].
Qed.
(* a motion until T is, until an earlier time c, one that goes on straight *)
Lemma straightened n V' R0 (r v : nat -> R -> C) T c : motion10_until T n V' R0 r v -> 0 < c < T ->
  exists q p : nat -> R -> C, (forall i u, u <= c -> q i u = r i u /\ p i u = v i u) /\ moves_while n V' R0 q p (fun u => u < c).
Proof.
  intros (A0 & Mv & Ma & N & HN & Mz) Hc.
  set (q := fun (i : nat) (u : R) => (r i (Rmin u c) + RtoC (Rmax (u - c) 0) * v i c)%C). set (p := fun (i : nat) (u : R) => v i (Rmin u c)).
  assert (Eq : forall i u, u <= c -> q i u = r i u /\ p i u = v i u).
  { intros k u Hu. unfold q, p. rewrite Rmin_left, Rmax_right by lra. split; [ring|reflexivity]. }
  assert (W : moves_while n V' R0 q p (fun u => u < c)).
  { split; [|split; [|split]].
    - intros k l Hk Hl L E. rewrite (proj1 (Eq k 0 ltac:(lra))), (proj1 (Eq l 0 ltac:(lra))) in E. now apply (A0 k l).
    - intros u k Hu Hk. assert (C1 : u <= c -> p k u = v k u) by (intros; now apply Eq). assert (C2 : c <= u -> p k u = v k c) by (intros; unfold p; now rewrite Rmin_right by lra).
      split.
      + apply (is_derive_ext (fun u => fst (r k (Rmin u c)) + fst (v k c) * Rmax (u - c) 0)); [intros; unfold q; cbn; ring|].
        apply (straight_on (fun u => fst (r k u))); [exact Hu| |intros L; now rewrite C2]. intros L. rewrite C1 by exact L. apply Mv; [lra|exact Hk].
      + apply (is_derive_ext (fun u => snd (r k (Rmin u c)) + snd (v k c) * Rmax (u - c) 0)); [intros; unfold q; cbn; ring|].
        apply (straight_on (fun u => snd (r k u))); [exact Hu| |intros L; now rewrite C2]. intros L. rewrite C1 by exact L. apply Mv; [lra|exact Hk].
    - intros k Hk S e HS He. destruct (Ma k Hk c e ltac:(lra) He) as (h & Hh & Q). exists h. split; [exact Hh|]. intros m a b I O Sm.
      apply (Q m (fun x => Rmin (a x) c) (fun x => Rmin (b x) c)).
      + intros x Hx. destruct (I x Hx). split; [|apply Rmin_r]. split; [apply Rmin_glb; lra|apply Rle_min_compat_r; lra].
      + intros x Hx. apply Rle_min_compat_r. now apply O.
      + apply Rle_lt_trans with (2 := Sm). apply Sum_le. intros x Hx. destruct (I x Hx). unfold Rmin. destruct (Rle_dec (b x) c), (Rle_dec (a x) c); lra.
    - exists N. split; [exact HN|]. intros u Hu Lu Nu Au.
      assert (E1 : (fun k => q k u) = (fun k => r k u)) by (apply FunctionalExtensionality.functional_extensionality; intros k; apply Eq; lra).
      assert (E2 : (fun k => p k u) = (fun k => v k u)) by (apply FunctionalExtensionality.functional_extensionality; intros k; apply Eq; lra).
      rewrite E1 in *. rewrite E2. destruct (Mz u ltac:(lra) Nu Au) as (z & Kz & Vz). exists z. split; [exact Kz|]. intros k Hk.
      assert (Lo : locally u (fun x => v k x = p k x)).
      { exists (mkposreal (c - u) ltac:(lra)). intros x Hx. change (Rabs (x - u) < c - u) in Hx. apply Rabs_lt_between in Hx. symmetry. apply Eq. lra. }
      destruct (Vz k Hk) as [V1 V2]. split.
      + apply (is_derive_ext_loc (fun x => fst (v k x))); [|exact V1]. revert Lo. apply filter_imp. intros x Hx. now rewrite Hx.
      + apply (is_derive_ext_loc (fun x => snd (v k x))); [|exact V2]. revert Lo. apply filter_imp. intros x Hx. now rewrite Hx. }
  exists q, p. split; [exact Eq|exact W].
Qed.
(* tanner2.thm2_coll: all pairs keep a distance as long as a motion lasts, the same for every T; connected or not *)
Theorem pairs_apart : forall n V V' R0 (r v : nat -> R -> C), 0 < R0 -> potentials n complete V V' -> apart_at n complete (fun i => r i 0) ->
  exists d, 0 < d /\ forall T, motion10_until T n V' R0 r v -> forall t i j, 0 <= t < T -> (i < n)%nat -> (j < n)%nat -> i <> j -> d < Cmod (r i t - r j t)%C.
Proof.
  intros n V V' R0 r v HR P A0. destruct (start_allows n V V' R0 (fun i => r i 0) (fun i => v i 0) HR P A0) as (d & Al). exists d. split; [apply Al|].
  intros T M t i j Ht Hi Hj Ne. set (c := (t + T) / 2). destruct (straightened n V' R0 r v T c M ltac:(unfold c; lra)) as (q & p & Eq & W). assert (Hc : t < c < T) by (unfold c; lra).
  assert (Al' : allows n V R0 (fun i => q i 0) (fun i => p i 0) d).
  { assert (E1 : (fun k => q k 0) = (fun k => r k 0)) by (apply FunctionalExtensionality.functional_extensionality; intros k; apply Eq; lra).
    assert (E2 : (fun k => p k 0) = (fun k => v k 0)) by (apply FunctionalExtensionality.functional_extensionality; intros k; apply Eq; lra). rewrite E1, E2. exact Al. }
  pose proof (kept_apart_while n V V' R0 q p HR P _ W d Al' t ltac:(lra) ltac:(intros; lra) i j Hi Hj Ne) as K.
  rewrite (proj1 (Eq i t ltac:(lra))), (proj1 (Eq j t ltac:(lra))) in K. exact K.
Qed.
