(* Tanner, Jadbabaie, Pappas, fixed connected graph: bounds on speeds and distances from the energy, no collision of
   linked agents, and Theorem 1's velocities: every solution that exists for all t >= 0 has all velocities tending to
   the mean initial velocity (Barbalat's argument in place of LaSalle's; C^1 potentials). *)
From Coq Require Import Reals Lra Lia Psatz Relations Classical.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums paley_model paley_phase paley_laplacian paley_gradient paley_particles tanner_energy.
Open Scope R_scope.

(* Definition 3, for one pair: nonnegative, infinite at 0 and at infinity; V' is the derivative *)
Definition potential (V V' : R -> R) : Prop :=
  (forall s, 0 < s -> is_derive V s (V' s) /\ 0 <= V s) /\
  (forall c, exists d, 0 < d /\ forall s, 0 < s < d -> c < V s) /\ (forall c, exists D, forall s, D < s -> c < V s).

Lemma dist2_norm x y : dist2 x y = norm (x - y)%C ^ 2.
Proof. apply dist2_Cmod. Qed.
Lemma norm_neq x y : x <> y -> 0 < norm (x - y)%C.
Proof. intros N. apply norm_pos. intros E. apply N. replace x with ((x - y) + y)%C by ring. rewrite E. ring. Qed.

Lemma uniform (n : nat) (P : nat -> R -> Prop) : (forall i b b', P i b -> b <= b' -> P i b') ->
  (forall i, (i < n)%nat -> exists b, P i b) -> exists b, 0 < b /\ forall i, (i < n)%nat -> P i b.
Proof.
  intros M. induction n as [|n IH]; intros H; [exists 1; split; [lra|intros; lia]|].
  destruct IH as [b [Hb IH]]; [intros; apply H; lia|]. destruct (H n ltac:(lia)) as [c Hc]. exists (Rmax b c).
  pose proof (Rmax_l b c). pose proof (Rmax_r b c). split; [lra|]. intros i Hi. destruct (Nat.eq_dec i n) as [->|].
  - now apply (M n c).
  - apply (M i b); [apply IH; lia|assumption].
Qed.
Lemma uniform_pairs (n : nat) (P : nat -> nat -> R -> Prop) : (forall i j b b', P i j b -> b <= b' -> P i j b') ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> exists b, P i j b) -> exists b, 0 < b /\ forall i j, (i < n)%nat -> (j < n)%nat -> P i j b.
Proof.
  intros M H. destruct (uniform n (fun i b => forall j, (j < n)%nat -> P i j b)) as [b [Hb U]].
  - intros i b b' Q L j Hj. now apply (M i j b); [apply Q|].
  - intros i Hi. destruct (uniform n (P i) (M i) (fun j Hj => H i j Hi Hj)) as [b [_ U]]. now exists b.
  - exists b. split; [exact Hb|]. intros i j Hi Hj. now apply U.
Qed.

Section Bounds.
Variables (n : nat) (adj : graph) (V V' : nat -> nat -> R -> R).
Hypothesis Pot : forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> potential (V i j) (V' i j).
Variables (r v : nat -> C).
Hypothesis NC : forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> r i <> r j.

Lemma V_term_ge0 i j : (i < n)%nat -> (j < n)%nat -> 0 <= w adj i j * V i j (norm (r i - r j)%C).
Proof.
  intros Hi Hj. unfold w. destruct (adj i j) eqn:A; [|lra]. rewrite Rmult_1_l. apply (Pot i j Hi Hj A), norm_neq, (NC i j Hi Hj A).
Qed.
Lemma V_i_ge0 i : (i < n)%nat -> 0 <= V_i n adj V r i.
Proof. intros Hi. apply Sum_ge0; intros; now apply V_term_ge0. Qed.
Theorem energy_ge0 : 0 <= Wenergy n adj V r v.
Proof.
  unfold Wenergy. apply Rmult_le_pos; [lra|]. apply Sum_ge0; intros i Hi. pose proof (V_i_ge0 i Hi). pose proof (inner_self_ge0 (v i)). lra.
Qed.
(* the kinetic part: |v_i|^2 <= 2 W *)
Theorem speed_bound i : (i < n)%nat -> inner (v i) (v i) <= 2 * Wenergy n adj V r v.
Proof.
  intros Hi. unfold Wenergy. pose proof (Sum_term_le n (fun i => V_i n adj V r i + inner (v i) (v i)) i
    (fun j Hj => Rplus_le_le_0_compat _ _ (V_i_ge0 j Hj) (inner_self_ge0 (v j))) Hi) as T. cbv beta in T. pose proof (V_i_ge0 i Hi). lra.
Qed.
Corollary speed_bound_norm i c : (i < n)%nat -> Wenergy n adj V r v <= c -> norm (v i) <= sqrt (2 * c).
Proof.
  intros Hi Hc. rewrite norm_inner. apply sqrt_le_1_alt. pose proof (speed_bound i Hi). lra.
Qed.
(* each linked pair: V_ij <= W, for a symmetric potential *)
Hypothesis S : undirected adj.
Hypothesis VS : forall i j, V i j = V j i.
Hypothesis NL : no_loops adj.
Theorem pair_bound i j : (i < n)%nat -> (j < n)%nat -> adj i j = true -> V i j (norm (r i - r j)%C) <= Wenergy n adj V r v.
Proof.
  intros Hi Hj A. assert (D : i <> j) by (intros ->; rewrite NL in A; discriminate).
  set (F := fun a => V_i n adj V r a + inner (v a) (v a)).
  assert (P : forall a, (a < n)%nat -> 0 <= F a) by (intros a Ha; unfold F; pose proof (V_i_ge0 a Ha); pose proof (inner_self_ge0 (v a)); lra).
  assert (T : forall a b, (a < n)%nat -> (b < n)%nat -> adj a b = true -> V a b (norm (r a - r b)%C) <= F a).
  { intros a b Ha Hb Ab. unfold F. pose proof (Sum_term_le n (fun b => w adj a b * V a b (norm (r a - r b)%C)) b (fun b Hb => V_term_ge0 a b Ha Hb) Hb) as L.
    cbv beta in L. unfold w at 1 in L. rewrite Ab in L. pose proof (inner_self_ge0 (v a)). unfold V_i. lra. }
  assert (TT : F i + F j <= Sum n F).
  { rewrite <- (Sum_delta n i F Hi), <- (Sum_delta n j F Hj), <- Sum_plus. apply Sum_le; intros a Ha. pose proof (P a Ha). unfold delta.
    destruct (Nat.eqb_spec a i), (Nat.eqb_spec a j); subst; try lra. contradiction. }
  pose proof (T i j Hi Hj A) as Ti. assert (A' : adj j i = true) by (now rewrite S). pose proof (T j i Hj Hi A') as Tj.
  rewrite (VS j i), (norm_sym (r j)) in Tj. unfold Wenergy. fold F. lra.
Qed.
End Bounds.

(* linked distances: bounded away from 0 and from infinity on {W <= c}; and all distances bounded on a connected graph *)
Theorem linked_distances n adj V V' c : undirected adj -> no_loops adj -> (forall i j, V i j = V j i) ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> potential (V i j) (V' i j)) ->
  exists d D, 0 < d /\ forall r v, (forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> r i <> r j) -> Wenergy n adj V r v <= c ->
    forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> d <= norm (r i - r j)%C <= D.
Proof.
  intros S NL VS Pot.
  destruct (uniform_pairs n (fun i j b => adj i j = true -> forall s, 0 < s -> V i j s <= c -> / b <= s <= b /\ 0 < b)) as [b [Hb U]].
  - intros i j b b' Q L A s Hs Hc. destruct (Q A s Hs Hc) as [[Q1 Q2] Q3]. split; [|lra]. split; [|lra].
    apply Rle_trans with (/ b); [|assumption]. apply Rinv_le_contravar; lra.
  - intros i j Hi Hj. destruct (adj i j) eqn:A; [|exists 1; discriminate].
    destruct (Pot i j Hi Hj A) as [_ [Z I]]. destruct (Z c) as [d [Hd Z1]]. destruct (I c) as [D I1].
    exists (Rmax (/ d) (Rmax D 1)). intros _ s Hs Hc. pose proof (Rmax_l (/ d) (Rmax D 1)). pose proof (Rmax_r (/ d) (Rmax D 1)).
    pose proof (Rmax_l D 1). pose proof (Rmax_r D 1). assert (0 < / d) by now apply Rinv_0_lt_compat.
    assert (d <= s) by (apply Rnot_lt_le; intros L; specialize (Z1 s (conj Hs L)); lra).
    assert (s <= D) by (apply Rnot_lt_le; intros L; specialize (I1 s L); lra). split; [split|]; try lra.
    apply Rle_trans with (/ / d); [apply Rinv_le_contravar; lra|rewrite Rinv_inv; lra].
  - exists (/ b), b. split; [now apply Rinv_0_lt_compat|]. intros r v NC Hc i j Hi Hj A.
    apply (U i j Hi Hj A); [apply norm_neq; now apply NC|].
    apply Rle_trans with (Wenergy n adj V r v); [|assumption]. now apply (pair_bound n adj V V').
Qed.
Theorem all_distances n adj V V' c : (1 <= n)%nat -> undirected adj -> no_loops adj -> strongly_connected n adj -> (forall i j, V i j = V j i) ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> potential (V i j) (V' i j)) ->
  exists B, forall r v, (forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> r i <> r j) -> Wenergy n adj V r v <= c ->
    forall i j, (i < n)%nat -> (j < n)%nat -> norm (r i - r j)%C <= B.
Proof.
  intros Hn S NL SC VS Pot. destruct (linked_distances n adj V V' c S NL VS Pot) as [d [D [_ LD]]].
  destruct (spacing_proper n adj Hn S SC) as [K [HK PK]]. pose proof (INR_pos n Hn) as P.
  exists (sqrt (K * (INR n * INR n * D ^ 2))). intros r v NC Hc i j Hi Hj.
  apply Rsqr_incr_0; [|apply norm_ge0|apply sqrt_pos]. rewrite Rsqr_sqrt.
  - rewrite Rsqr_pow2, <- dist2_norm. apply Rle_trans with (1 := PK r i j Hi Hj). apply Rmult_le_compat_l; [exact HK|].
    rewrite Q_total by assumption. unfold total.
    assert (T : Sum n (fun k => Sum n (fun j => w adj k j * dist2 (r k) (r j))) <= INR n * (INR n * D ^ 2)).
    { rewrite <- Sum_const. apply Sum_le; intros a Ha. rewrite <- Sum_const. apply Sum_le; intros b Hb. unfold w.
      destruct (adj a b) eqn:A; [|pose proof (pow2_ge_0 D); lra]. rewrite dist2_norm. pose proof (LD r v NC Hc a b Ha Hb A) as [_ L].
      pose proof (norm_ge0 (r a - r b)%C). rewrite Rmult_1_l. apply pow_incr. lra. }
    assert (F : 0 < / (4 * INR n)) by (apply Rinv_0_lt_compat; lra).
    assert (G : / (4 * INR n) <= 1). { rewrite <- Rinv_1. apply Rinv_le_contravar; [lra|]. apply (le_INR 1) in Hn. cbn in Hn. lra. }
    assert (Z : 0 <= Sum n (fun k => Sum n (fun j => w adj k j * dist2 (r k) (r j)))) by (apply (total_ge0 n adj r)).
    nra.
  - apply Rmult_le_pos; [exact HK|]. apply Rmult_le_pos; [nra|apply pow2_ge_0].
Qed.

(* linked agents that start apart stay apart on [0, T], if they have a distance d as long as none have met *)
Lemma square_near (x y : R -> C) t a b : is_velocity x t a -> is_velocity y t b ->
  forall e, 0 < e -> exists d, 0 < d /\ forall s, Rabs (s - t) < d ->
    Rabs (inner (x s - y s)%C (x s - y s)%C - inner (x t - y t)%C (x t - y t)%C) < e.
Proof.
  intros HX HY e He. pose proof (velocity_minus x y t _ _ HX HY) as VM.
  pose proof (D_inner _ _ t _ _ VM VM) as D. apply is_derive_Reals in D.
  assert (Ct : continuity_pt (fun s => inner (x s - y s)%C (x s - y s)%C) t) by (apply derivable_continuous_pt; eexists; exact D).
  destruct (Ct e He) as [d [Hd B]]. exists d. split; [exact Hd|]. intros s Hs.
  destruct (Req_dec s t) as [->|N]; [rewrite Rminus_eq_0, Rabs_R0; exact He|].
  apply B. split; [split; [exact I|congruence]|exact Hs].
Qed.
Section Kept.
Variables (n : nat) (adj : graph) (r v : nat -> R -> C) (d T : R).
Hypothesis Hd : 0 < d.
Hypothesis HR : forall t i, 0 <= t <= T -> (i < n)%nat -> is_velocity (r i) t (v i t).
Notation apart t := (forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> r i t <> r j t).
Hypothesis Start : apart 0.
Hypothesis Keep : forall t, 0 <= t <= T -> (forall s, 0 <= s <= t -> apart s) ->
  forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> d <= norm (r i t - r j t)%C.
Notation square i j := (fun s => inner (r i s - r j s)%C (r i s - r j s)%C).
Theorem kept_apart t i j : 0 <= t <= T -> (i < n)%nat -> (j < n)%nat -> adj i j = true -> d <= norm (r i t - r j t)%C.
Proof.
  revert t i j.
  pose (kept := fun s => forall x, 0 <= x <= s -> forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> d ^ 2 <= square i j x).
  assert (K1 : forall s, 0 <= s <= T -> (forall x, 0 <= x <= s -> apart x) -> kept s).
  { intros s Hs A x Hx i j Hi Hj Lk. rewrite <- norm_sqr, <- Rsqr_pow2. fold (Rsqr (norm (r i x - r j x)%C)). apply Rsqr_incr_1; [|lra|apply norm_ge0].
    apply Keep; try assumption; [lra|]. intros y Hy. apply A. lra. }
  assert (K2 : forall s, kept s -> forall x, 0 <= x <= s -> apart x).
  { intros s Ks x Hx i j Hi Hj Lk Eq. specialize (Ks x Hx i j Hi Hj Lk). cbv beta in Ks. rewrite Eq in Ks.
    replace (r j x - r j x)%C with (RtoC 0) in Ks by ring. rewrite inner_xy in Ks. cbn in Ks. nra. }
  assert (Main : forall t, 0 <= t <= T -> kept t).
  { intros t Ht.
    assert (K0 : kept 0).
    { apply K1; [lra|]. intros x Hx. replace x with 0 by lra. exact Start. }
    destruct (completeness (fun s => 0 <= s <= t /\ kept s)) as [m [Ub Lub]].
    { exists t. intros s [Hs _]. lra. }
    { exists 0. split; [lra|exact K0]. }
    assert (M0 : 0 <= m) by (apply Ub; split; [lra|exact K0]).
    assert (M1 : m <= t) by (apply Lub; intros s [Hs _]; lra).
    assert (Before : forall x, 0 <= x < m -> forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> d ^ 2 <= square i j x).
    { intros x Hx i j Hi Hj Lk. apply Rnot_lt_le. intros F.
      assert (m <= x); [|lra]. apply Lub. intros s [Hs Ks]. apply Rnot_lt_le. intros G.
      specialize (Ks x ltac:(lra) i j Hi Hj Lk). cbv beta in Ks, F. lra. }
    assert (Km : kept m).
    { intros x Hx i j Hi Hj Lk. destruct (Rlt_le_dec x m) as [X|X]; [apply Before; try assumption; lra|].
      replace x with m by lra. destruct (Req_dec m 0) as [->|N]; [apply K0; try assumption; lra|].
      apply Rnot_lt_le. intros F. destruct (square_near (r i) (r j) m _ _ (HR m i ltac:(lra) Hi) (HR m j ltac:(lra) Hj) (d ^ 2 - square i j m)) as [e [He B]]; [cbv beta in F |- *; lra|].
      set (y := Rmax 0 (m - e / 2)).
      assert (Y : 0 <= y < m /\ m - e / 2 <= y).
      { unfold y. pose proof (Rmax_l 0 (m - e / 2)). pose proof (Rmax_r 0 (m - e / 2)). split; [split; [lra|apply Rmax_lub_lt; lra]|lra]. }
      specialize (B y). rewrite Rabs_left in B by lra. specialize (B ltac:(lra)). apply Rabs_def2 in B.
      pose proof (Before y ltac:(lra) i j Hi Hj Lk). cbv beta in *. lra. }
    destruct (Rle_lt_or_eq_dec m t M1) as [Lt| ->]; [exfalso|exact Km].
    destruct (uniform_pairs n (fun i j b => 0 < b /\ (adj i j = true -> forall s, Rabs (s - m) < / b -> 0 < square i j s))) as [b [Hb U]].
    { intros i j b b' [Pb Q] Le. split; [lra|]. intros A s Hs. apply (Q A s).
      apply Rlt_le_trans with (1 := Hs). apply Rinv_le_contravar; lra. }
    { intros i j Hi Hj. destruct (adj i j) eqn:A; [|exists 1; split; [lra|discriminate]].
      pose proof (Km m ltac:(lra) i j Hi Hj A) as Q.
      destruct (square_near (r i) (r j) m _ _ (HR m i ltac:(lra) Hi) (HR m j ltac:(lra) Hj) (d ^ 2)) as [e [He B]]; [nra|].
      exists (/ e). split; [now apply Rinv_0_lt_compat|]. intros _ s Hs.
      rewrite Rinv_inv in Hs. specialize (B s Hs). apply Rabs_def2 in B. cbv beta in *. lra. }
    set (y := Rmin t (m + / b / 2)).
    assert (Ib : 0 < / b) by now apply Rinv_0_lt_compat.
    assert (Y : m < y <= t /\ y <= m + / b / 2).
    { unfold y. pose proof (Rmin_l t (m + / b / 2)). pose proof (Rmin_r t (m + / b / 2)). split; [split; [apply Rmin_glb_lt; lra|lra]|lra]. }
    assert (Ky : kept y).
    { apply K1; [lra|]. intros x Hx. destruct (Rle_lt_dec x m) as [X|X]; [apply (K2 m Km); lra|].
      intros i j Hi Hj A Eq. pose proof (proj2 (U i j Hi Hj) A x) as P. rewrite Rabs_pos_eq in P by lra. specialize (P ltac:(lra)). cbv beta in P.
      rewrite Eq in P. replace (r j x - r j x)%C with (RtoC 0) in P by ring. rewrite inner_xy in P. cbn in P. lra. }
    assert (y <= m); [|lra]. apply Ub. split; [lra|exact Ky]. }
  intros t i j Ht Hi Hj A. pose proof (Main t Ht t ltac:(lra) i j Hi Hj A) as Q. cbv beta in Q. rewrite <- norm_sqr, <- Rsqr_pow2 in Q.
  apply Rsqr_incr_0; [exact Q|lra|apply norm_ge0].
Qed.
End Kept.

(* ---- solutions of the closed loop for all t >= 0 ---- *)
Section Solution.
Variables (n : nat) (adj : graph) (V V' : nat -> nat -> R -> R) (r v : nat -> R -> C).
Hypothesis Hn : (1 <= n)%nat.
Hypothesis S : undirected adj.
Hypothesis NL : no_loops adj.
Hypothesis SC : strongly_connected n adj.
Hypothesis VS : forall i j, V i j = V j i.
Hypothesis VS' : forall i j, V' i j = V' j i.
Hypothesis Pot : forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> potential (V i j) (V' i j).
Hypothesis C1 : forall i j s, (i < n)%nat -> (j < n)%nat -> adj i j = true -> 0 < s -> continuity_pt (V' i j) s.
Hypothesis NC : forall t i j, 0 <= t -> (i < n)%nat -> (j < n)%nat -> adj i j = true -> r i t <> r j t.
Hypothesis HR : forall t i, 0 <= t -> (i < n)%nat -> is_velocity (r i) t (v i t).
Hypothesis HU : forall t i, 0 <= t -> (i < n)%nat ->
  is_velocity (v i) t (control4 n adj V' (fun i => r i t) (fun i => v i t) i).
Notation E t := (Wenergy n adj V (fun i => r i t) (fun i => v i t)).
Notation u i t := (control4 n adj V' (fun i => r i t) (fun i => v i t) i).
Definition disagreement (t : R) : R := / 2 * total n adj (fun i => v i t).

Lemma energy_rate t : 0 <= t -> is_derive (fun s => E s) t (- disagreement t).
Proof.
  intros Ht. destruct (eq9 n adj V V' r v t S VS' (fun i Hi => HR t i Ht Hi) (fun i j Hi Hj A => NC t i j Ht Hi Hj A)) as [D _].
  - intros i j Hi Hj A. apply (Pot i j Hi Hj A), norm_neq. now apply NC.
  - intros i Hi. now apply HU.
  - eapply D_eq; [exact D|]. f_equal. rewrite kron_split, <- form_split. now apply lap_form.
Qed.
Theorem energy_nonincreasing s t : 0 <= s <= t -> E t <= E s.
Proof.
  intros H. apply (decreasing (fun t => E t) (fun t => - disagreement t)); [lra|intros; apply energy_rate; lra|].
  intros x _. unfold disagreement. pose proof (total_ge0 n adj (fun i => v i x)). lra.
Qed.
(* Theorem 1: linked agents keep a distance that depends on the initial energy only *)
Theorem no_collision : exists d, 0 < d /\ forall t i j, 0 <= t -> (i < n)%nat -> (j < n)%nat -> adj i j = true -> d <= norm (r i t - r j t)%C.
Proof.
  destruct (linked_distances n adj V V' (E 0) S NL VS Pot) as [d [D [Hd L]]]. exists d. split; [exact Hd|].
  intros t i j Ht Hi Hj A. apply (L (fun i => r i t) (fun i => v i t)); try assumption.
  - intros a b Ha Hb Ab. now apply NC.
  - apply energy_nonincreasing. lra.
Qed.
Lemma inner_Csum_le m f : inner (Csum m f) (Csum m f) <= INR m * Sum m (fun j => inner (f j) (f j)).
Proof.
  rewrite inner_xy. unfold Csum; cbn [fst snd]. pose proof (Sum_sqr_le m (fun j => fst (f j))). pose proof (Sum_sqr_le m (fun j => snd (f j))).
  rewrite (Sum_ext m (fun j => inner (f j) (f j)) (fun j => fst (f j) ^ 2 + snd (f j) ^ 2)) by (intros; rewrite inner_xy; ring).
  rewrite Sum_plus. lra.
Qed.
Lemma dist2_le x y : dist2 x y <= 2 * inner x x + 2 * inner y y.
Proof. rewrite dist2_xy, !inner_xy. pose proof (pow2_ge_0 (fst x + fst y)). pose proof (pow2_ge_0 (snd x + snd y)). lra. Qed.
Lemma control_bounded : exists B, 0 < B /\ forall t i, 0 <= t -> (i < n)%nat -> inner (u i t) (u i t) <= B.
Proof.
  destruct (linked_distances n adj V V' (E 0) S NL VS Pot) as [d [D [Hd L]]].
  destruct (uniform_pairs n (fun i j b => adj i j = true -> forall s, d <= s <= D -> V' i j s ^ 2 <= b)) as [b [Hb U]].
  { intros i j b b' Q L1 A s Hs. specialize (Q A s Hs). lra. }
  { intros i j Hi Hj. destruct (adj i j) eqn:A; [|exists 0; discriminate]. destruct (Rle_or_lt d D) as [LD|LD]; [|exists 0; intros; lra].
    destruct (continuity_ab_maj (fun s => V' i j s ^ 2) d D LD) as [m [M _]].
    - intros s Hs. apply (continuity_pt_ext (fun s => V' i j s * V' i j s)); [intros; ring|].
      apply continuity_pt_mult; apply C1; try assumption; lra.
    - exists (V' i j m ^ 2). intros _ s Hs. now apply M. }
  assert (P : 0 < INR n) by now apply INR_pos.
  assert (E0 : 0 <= E 0). { apply (energy_ge0 n adj V V' Pot). intros i j Hi Hj A. apply NC; try assumption. lra. }
  exists (INR n * (INR n * (2 * (8 * E 0) + 2 * b)) + 1). split; [apply Rplus_le_lt_0_compat; [|lra]; apply Rmult_le_pos; [lra|apply Rmult_le_pos; lra]|].
  intros t i Ht Hi.
  assert (EQ : u i t = Csum n (fun j => RtoC (-1) * (RtoC (w adj i j) * (v i t - v j t) + pair_grad adj V' (fun i => r i t) i j))%C).
  { rewrite Csum_scal, Csum_plus. unfold control4, grad_i. change (Csum n (pair_grad adj V' (fun i => r i t) i)) with (Csum n (fun j => pair_grad adj V' (fun i => r i t) i j)).
    apply injective_projections; cbn [fst snd Cminus Cplus Copp Cmult RtoC]; ring. }
  rewrite EQ. eapply Rle_trans; [apply inner_Csum_le|]. apply Rle_trans with (INR n * (INR n * (2 * (8 * E 0) + 2 * b))); [|lra].
  apply Rmult_le_compat_l; [lra|]. rewrite <- Sum_const. apply Sum_le; intros j Hj.
  assert (Et : E t <= E 0) by (apply energy_nonincreasing; lra).
  assert (NCt : forall a c, (a < n)%nat -> (c < n)%nat -> adj a c = true -> r a t <> r c t) by (intros; now apply NC).
  pose proof (speed_bound n adj V V' Pot (fun i => r i t) (fun i => v i t) NCt i Hi) as Vi.
  pose proof (speed_bound n adj V V' Pot (fun i => r i t) (fun i => v i t) NCt j Hj) as Vj. cbv beta in Vi, Vj.
  pose proof (dist2_le (v i t) (v j t)) as Dij. unfold pair_grad, w. destruct (adj i j) eqn:A.
  - set (x := (v i t - v j t)%C). set (g := grad (V' i j) (r i t) (r j t)).
    assert (Gb : inner g g <= b).
    { unfold g, grad. pose proof (norm_neq _ _ (NC t i j Ht Hi Hj A)) as N0. rewrite inner_scal, inner_sym, inner_scal, <- norm_sqr.
      set (s := norm (r i t - r j t)%C) in *. replace (V' i j s / s * (V' i j s / s * (s * s))) with (V' i j s ^ 2) by (field; lra).
      apply (U i j Hi Hj A). apply (L (fun i => r i t) (fun i => v i t)); assumption. }
    assert (Xb : inner x x <= 8 * E 0) by (unfold x; fold (dist2 (v i t) (v j t)); lra).
    assert (Q : inner (RtoC (-1) * (RtoC 1 * x + RtoC 1 * g))%C (RtoC (-1) * (RtoC 1 * x + RtoC 1 * g))%C <= 2 * inner x x + 2 * inner g g).
    { rewrite !inner_xy. unfold Cmult, Cplus, RtoC; cbn [fst snd].
      pose proof (pow2_ge_0 (fst x - fst g)). pose proof (pow2_ge_0 (snd x - snd g)). lra. }
    lra.
  - set (x := (v i t - v j t)%C). match goal with |- ?X <= _ => replace X with 0 by (rewrite inner_xy; unfold Cmult, Cplus, RtoC; cbn [fst snd]; ring) end. lra.
Qed.
Lemma disagreement_lipschitz : exists K, 0 < K /\ forall s t, 0 <= s <= t -> Rabs (disagreement t - disagreement s) <= K * (t - s).
Proof.
  destruct control_bounded as [B [HB UB]]. pose proof (INR_pos n Hn) as P.
  assert (E0 : 0 <= E 0). { apply (energy_ge0 n adj V V' Pot). intros i j Hi Hj A. apply NC; try assumption. lra. }
  pose (K := / 2 * (INR n * (INR n * (8 * E 0 + 4 * B)))).
  assert (HK : 0 < K) by (unfold K; repeat apply Rmult_lt_0_compat; lra).
  exists K. split; [exact HK|]. intros s t Hst.
  pose (d := fun x => / 2 * Sum n (fun i => Sum n (fun j => w adj i j * (2 * inner (v i x - v j x)%C (u i x - u j x)%C)))).
  assert (D : forall x, 0 <= x -> is_derive disagreement x (d x)).
  { intros x Hx. unfold disagreement, total, d. apply D_scal.
    apply (D_Sum n (fun i s => Sum n (fun j => w adj i j * dist2 (v i s) (v j s))) (fun i => Sum n (fun j => w adj i j * (2 * inner (v i x - v j x)%C (u i x - u j x)%C)))).
    intros i Hi. apply (D_Sum n (fun j s => w adj i j * dist2 (v i s) (v j s)) (fun j => w adj i j * (2 * inner (v i x - v j x)%C (u i x - u j x)%C))).
    intros j Hj. apply D_scal. pose proof (velocity_minus (v i) (v j) x _ _ (HU x i Hx Hi) (HU x j Hx Hj)) as VM.
    eapply D_eq; [apply (D_inner _ _ x _ _ VM VM)|]. cbv beta. rewrite (inner_sym (u i x - u j x)%C). ring. }
  assert (Bd : forall x, 0 <= x -> - K <= d x <= K).
  { intros x Hx.
    assert (T : forall i j, (i < n)%nat -> (j < n)%nat -> - (8 * E 0 + 4 * B) <= w adj i j * (2 * inner (v i x - v j x)%C (u i x - u j x)%C) <= 8 * E 0 + 4 * B).
    { intros i j Hi Hj. assert (Et : E x <= E 0) by (apply energy_nonincreasing; lra).
      assert (NCt : forall a c, (a < n)%nat -> (c < n)%nat -> adj a c = true -> r a x <> r c x) by (intros; now apply NC).
      pose proof (speed_bound n adj V V' Pot (fun i => r i x) (fun i => v i x) NCt i Hi) as Vi.
      pose proof (speed_bound n adj V V' Pot (fun i => r i x) (fun i => v i x) NCt j Hj) as Vj. cbv beta in Vi, Vj.
      pose proof (UB x i Hx Hi) as Ui. pose proof (UB x j Hx Hj) as Uj.
      pose proof (dist2_le (v i x) (v j x)) as D1. pose proof (dist2_le (u i x) (u j x)) as D2. unfold dist2 in D1, D2.
      set (a := (v i x - v j x)%C) in *. set (c := (u i x - u j x)%C) in *.
      assert (M1 : 2 * inner a c <= inner a a + inner c c).
      { rewrite !inner_xy. pose proof (pow2_ge_0 (fst a - fst c)). pose proof (pow2_ge_0 (snd a - snd c)). lra. }
      assert (M2 : - (inner a a + inner c c) <= 2 * inner a c).
      { rewrite !inner_xy. pose proof (pow2_ge_0 (fst a + fst c)). pose proof (pow2_ge_0 (snd a + snd c)). lra. }
      unfold w. destruct (adj i j); lra. }
    unfold d, K. split.
    - replace (- (/ 2 * (INR n * (INR n * (8 * E 0 + 4 * B))))) with (/ 2 * (INR n * (INR n * - (8 * E 0 + 4 * B)))) by ring.
      apply Rmult_le_compat_l; [lra|]. rewrite <- Sum_const. apply Sum_le; intros i Hi. rewrite <- Sum_const. apply Sum_le; intros j Hj. now apply T.
    - apply Rmult_le_compat_l; [lra|]. rewrite <- (Sum_const n (INR n * _)). apply Sum_le; intros i Hi. rewrite <- Sum_const. apply Sum_le; intros j Hj. now apply T. }
  destruct (MVT_le disagreement d s t) as [c [Hc Ec]]; [lra|intros x Hx; apply D; lra|]. rewrite Ec.
  pose proof (Bd c ltac:(lra)). apply Rabs_le. nra.
Qed.
Theorem disagreement_to_0 : forall e, 0 < e -> exists T, 0 <= T /\ forall t, T <= t -> disagreement t < e.
Proof.
  destruct disagreement_lipschitz as [K [HK L]].
  apply (barbalat (fun t => - E t) disagreement 0 K HK).
  - intros t Ht. eapply D_eq; [apply D_opp, energy_rate, Ht|]. ring.
  - intros t _. unfold disagreement. pose proof (total_ge0 n adj (fun i => v i t)). lra.
  - intros t Ht. assert (0 <= E t); [|lra]. apply (energy_ge0 n adj V V' Pot). intros; now apply NC.
  - exact L.
Qed.
(* Theorem 1: the velocity differences tend to 0 *)
Theorem velocities_agree i j : (i < n)%nat -> (j < n)%nat ->
  forall e, 0 < e -> exists T, 0 <= T /\ forall t, T <= t -> norm (v i t - v j t)%C < e.
Proof.
  intros Hi Hj e He. destruct (spacing_proper n adj Hn S SC) as [K [HK PK]]. pose proof (INR_pos n Hn) as P.
  destruct (disagreement_to_0 (e ^ 2 * INR n / (K + 1))) as [T [HT D]].
  { apply Rdiv_lt_0_compat; [|lra]. apply Rmult_lt_0_compat; [apply pow_lt; lra|lra]. }
  exists T. split; [exact HT|]. intros t Ht. specialize (D t Ht). pose proof (PK (fun i => v i t) i j Hi Hj) as Q. cbv beta in Q.
  rewrite Q_total, dist2_norm in Q by assumption. unfold disagreement in D.
  pose proof (total_ge0 n adj (fun i => v i t)) as T0. set (X := total n adj (fun i => v i t)) in *.
  assert (N2 : norm (v i t - v j t)%C ^ 2 < e ^ 2).
  { apply Rle_lt_trans with (1 := Q). apply (Rmult_lt_compat_r ((K + 1) * 2 / (4 * INR n))) in D; [|apply Rdiv_lt_0_compat; nra].
    replace (e ^ 2 * INR n / (K + 1) * ((K + 1) * 2 / (4 * INR n))) with (e ^ 2 / 2) in D by (field; lra).
    replace (/ 2 * X * ((K + 1) * 2 / (4 * INR n))) with (/ (4 * INR n) * X * (K + 1)) in D by (field; lra).
    assert (0 <= / (4 * INR n) * X) by (apply Rmult_le_pos; [left; apply Rinv_0_lt_compat; lra|exact T0]).
    pose proof (pow2_ge_0 e). nra. }
  pose proof (norm_ge0 (v i t - v j t)%C). nra.
Qed.
(* ... so every velocity tends to the mean of the initial velocities *)
Lemma mean_constant t : 0 <= t -> Csum n (fun i => v i t) = Csum n (fun i => v i 0).
Proof.
  intros Ht. assert (M : forall x, 0 <= x -> is_velocity (fun s => Csum n (fun i => v i s)) x (RtoC 0)).
  { intros x Hx. apply (momentum n adj V' r v x S VS'). intros i Hi. now apply HU. }
  apply injective_projections.
  - destruct (MVT_le (fun s => fst (Csum n (fun i => v i s))) (fun _ => 0) 0 t Ht) as [c [_ Ec]]; [intros x Hx; apply (M x); lra|]. lra.
  - destruct (MVT_le (fun s => snd (Csum n (fun i => v i s))) (fun _ => 0) 0 t Ht) as [c [_ Ec]]; [intros x Hx; apply (M x); lra|]. lra.
Qed.
Theorem velocities_to_mean i : (i < n)%nat ->
  forall e, 0 < e -> exists T, 0 <= T /\ forall t, T <= t -> norm (v i t - centre n (fun j => v j 0))%C < e.
Proof.
  intros Hi e He. pose proof (INR_pos n Hn) as P.
  assert (F : forall m, (m <= n)%nat -> exists T, 0 <= T /\ forall t, T <= t -> forall j, (j < m)%nat -> norm (v i t - v j t)%C < e).
  { induction m as [|m IH]; intros Hm; [exists 0; split; [lra|intros; lia]|]. destruct IH as [T1 [HT1 A]]; [lia|].
    destruct (velocities_agree i m Hi ltac:(lia) e He) as [T2 [HT2 B]]. exists (Rmax T1 T2). pose proof (Rmax_l T1 T2). pose proof (Rmax_r T1 T2).
    split; [lra|]. intros t Ht j Hj. destruct (Nat.eq_dec j m) as [->|]; [apply B; lra|apply A; [lra|lia]]. }
  destruct (F n (le_n n)) as [T [HT A]]. exists T. split; [exact HT|]. intros t Ht.
  assert (Eq : (v i t - centre n (fun j => v j 0%R))%C = (RtoC (/ INR n) * Csum n (fun j => v i t - v j t))%C).
  { unfold centre. rewrite <- (mean_constant t) by lra. rewrite Csum_minus, Csum_const.
    apply injective_projections; cbn; field; lra. }
  rewrite Eq. unfold norm in *. rewrite Cmod_mult, Cmod_R, Rabs_pos_eq by (left; now apply Rinv_0_lt_compat).
  assert (Tri : forall m, Cmod (Csum m (fun j => v i t - v j t)%C) <= Sum m (fun j => Cmod (v i t - v j t)%C)).
  { induction m as [|m IH]; [cbn; unfold Csum; cbn; change (0, 0) with (RtoC 0); rewrite Cmod_0; lra|]. rewrite Csum_S. cbn [Sum].
    eapply Rle_trans; [apply Cmod_triangle|]. lra. }
  apply Rle_lt_trans with (/ INR n * Sum n (fun j => Cmod (v i t - v j t)%C)).
  - apply Rmult_le_compat_l; [left; now apply Rinv_0_lt_compat|apply Tri].
  - assert (LT : Sum n (fun j => Cmod (v i t - v j t)%C) < INR n * e).
    { rewrite <- Sum_const. destruct n as [|m]; [lia|]. cbn [Sum]. apply Rplus_le_lt_compat.
      - apply Sum_le; intros j Hj. left. apply A; [assumption|lia].
      - apply A; [assumption|lia]. }
    apply (Rmult_lt_compat_l (/ INR n)) in LT; [|now apply Rinv_0_lt_compat]. rewrite <- Rmult_assoc, Rinv_l, Rmult_1_l in LT by lra. exact LT.
Qed.
End Solution.
