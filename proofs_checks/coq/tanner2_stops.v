(* Tanner, Jadbabaie, Pappas, links by distance: where no limit configuration of a solution has more than one pair at the distance R, and all V_ij'(R) > 0, late pairs pass from one
   side of R to the other only if they stay at R for an interval of time in between.
   Late in the motion, near a limit configuration, the second derivative of |r_ij|^2 is nearly one number where the pair is not linked and nearly another one, smaller by
   2 (V_ij'(R) + V_ji'(R)) R, where it is. So it is at least a constant where the pair is farther than R, or at most a negative one where it is nearer; then from a time
   at which the pair turns from one side to the other the rate of |r_ij|^2 grows, forwards or backwards, for a unit of time, but it tends to 0.
     beyond.tanner2.thm2_stop. *)
From Coq Require Import Reals Lra Lia Psatz Classical.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums inclusions paley_model paley_phase paley_laplacian paley_gradient tanner_energy tanner_flock tanner2_filippov tanner2_limits.
From Flockproof Require lipschitz tanner2_appendix tanner2_approach tanner2_unique tanner2_onward tanner2_field tanner2_definition4 tanner_saturated.
Open Scope R_scope.

(* limit points of the relative positions; at most one pair at the distance R0 *)
Definition limit_point n (r : nat -> R -> C) (s : nat -> C) := forall T e, 0 < e -> exists t, T <= t /\
  forall i j, (i < n)%nat -> (j < n)%nat -> Cmod (r i t - r j t - (s i - s j))%C < e.
Definition one_pair_at n R0 (s : nat -> C) := forall i j k l, (i < n)%nat -> (j < n)%nat -> (k < n)%nat -> (l < n)%nat -> i <> j -> k <> l ->
  Cmod (s i - s j)%C = R0 -> Cmod (s k - s l)%C = R0 -> (k = i /\ l = j) \/ (k = j /\ l = i).
(* f passes from one side of R0 to the other between a and b; it stays at R0 for an interval of time in between *)
Definition passes R0 (f : R -> R) a b := (f a < R0 /\ R0 < f b) \/ (R0 < f a /\ f b < R0).
Definition stays R0 (f : R -> R) a b := exists c d, a <= c < d /\ d <= b /\ forall t, c <= t <= d -> f t = R0.
Definition switching_ends n R0 (r : nat -> R -> C) := exists T, 0 <= T /\ forall i j a b, (i < n)%nat -> (j < n)%nat -> i <> j -> T <= a < b ->
  passes R0 (fun t => Cmod (r i t - r j t)%C) a b -> stays R0 (fun t => Cmod (r i t - r j t)%C) a b.

(* ---- functions of one number with a rate p ---- *)
Section Push.
Variables (q p : R -> R) (lo hi k : R).
Hypothesis D : forall t, lo <= t <= hi -> is_derive q t (p t).
Hypothesis Hk : 0 < k.
Hypothesis H : forall a b, lo <= a < b -> b <= hi -> (forall t, a < t < b -> 0 < q t) -> k * (b - a) <= p b - p a.
Lemma q_near t e : lo <= t <= hi -> 0 < e -> exists d, 0 < d /\ forall u, Rabs (u - t) < d -> Rabs (q u - q t) < e.
Proof.
  intros Ht He. assert (Cn : continuity_pt q t) by (apply derivable_continuous_pt; exists (p t); now apply is_derive_Reals, D). exact (lipschitz.near_value q t e Cn He).
Qed.
Lemma not_lower a b : lo <= a <= b -> b <= hi -> (forall t, a <= t <= b -> 0 <= p t) -> q a <= q b.
Proof.
  intros Ha Hb Pp. destruct (MVT_le q p a b ltac:(lra)) as (c & Hc & E); [intros; apply D; lra|]. specialize (Pp c Hc). nra.
Qed.
(* once positive after a time at which it is not, it stays so *)
Lemma forward c x : lo <= c < x -> x <= hi -> q c <= 0 -> 0 < q x -> k * (hi - x) <= p hi.
Proof.
  intros Hc Hx Qc Qx. destruct (completeness (fun y => c <= y <= x /\ q y <= 0)) as [t [U L]]; [exists x; intros y [Y _]; lra|exists c; lra|].
  assert (Ct : c <= t) by (apply U; lra). assert (Tx : t <= x) by (apply L; intros y [Y _]; lra).
  assert (Qt : q t <= 0).
  { apply Rnot_lt_le. intros G. destruct (q_near t (q t) ltac:(lra) G) as (d & Hd & Nr). assert (t <= t - d / 2); [|lra]. apply L. intros y [Y Qy]. apply Rnot_lt_le. intros K.
    assert (y <= t) by (apply U; lra). specialize (Nr y ltac:(apply Rabs_def1; lra)). apply Rabs_def2 in Nr. lra. }
  assert (Lt : t < x) by (destruct (Req_dec t x) as [E|E]; [rewrite E in Qt; lra|lra]).
  assert (Pos : forall y, t < y <= x -> 0 < q y) by (intros y Hy; apply Rnot_le_lt; intros G; assert (y <= t) by (apply U; lra); lra).
  assert (Pt : 0 <= p t).
  { apply Rnot_lt_le. intros G. destruct (tanner2_unique.side_below q t (p t) (q t) (D t ltac:(lra)) (or_intror (conj eq_refl G))) as (h & Hh & S). pose proof (Rmin_l (x - t) (h / 2)). pose proof (Rmin_r (x - t) (h / 2)).
    assert (0 < Rmin (x - t) (h / 2)) by (apply Rmin_glb_lt; lra). specialize (S (t + Rmin (x - t) (h / 2)) ltac:(lra)). specialize (Pos (t + Rmin (x - t) (h / 2)) ltac:(lra)). lra. }
  assert (Grow : forall b, t < b <= hi -> (forall y, t < y < b -> 0 < q y) -> forall y, t <= y <= b -> k * (y - t) <= p y).
  { intros b Hb Pb y Hy. destruct (Req_dec y t) as [->|Ny]; [rewrite Rminus_eq_0, Rmult_0_r; exact Pt|]. specialize (H t y ltac:(lra) ltac:(lra)). assert (k * (y - t) <= p y - p t); [|lra]. apply H. intros u Hu. apply Pb. lra. }
  assert (Up : forall b, x <= b <= hi -> (forall y, t < y < b -> 0 < q y) -> q x <= q b).
  { intros b Hb Pb. apply not_lower; [lra|lra|]. intros y Hy. specialize (Grow b ltac:(lra) Pb y ltac:(lra)). assert (0 <= k * (y - t)) by (apply Rmult_le_pos; lra). lra. }
  assert (All : forall s, 0 <= s -> forall u, 0 <= u <= s -> x + u <= hi -> q x <= q (x + u)).
  { apply (real_induction (fun s => forall u, 0 <= u <= s -> x + u <= hi -> q x <= q (x + u))).
    - intros s Hs I u Hu Hb. destruct (Req_dec u s) as [->|Nu]; [|apply (I u); lra]. apply Up; [lra|]. intros y Hy. destruct (Rle_or_lt y x) as [G|G]; [apply Pos; lra|].
      specialize (I (y - x) ltac:(lra) (y - x) ltac:(lra) ltac:(lra)). replace (x + (y - x)) with y in I by ring. lra.
    - intros s Hs I. destruct (Rle_or_lt (x + s) hi) as [G|G].
      2: { exists 1. split; [lra|]. intros u' Hu' u Hu Hb. apply (I u); lra. }
      pose proof (I s ltac:(lra) G) as Is. destruct (q_near (x + s) (q x) ltac:(lra) Qx) as (d & Hd & Nr). exists d. split; [exact Hd|]. intros u' Hu' u Hu Hb.
      destruct (Rle_or_lt u s) as [Us|Us]; [apply (I u); lra|]. apply Up; [lra|]. intros y Hy. destruct (Rle_or_lt y x) as [Y|Y]; [apply Pos; lra|]. destruct (Rle_or_lt y (x + s)) as [Y'|Y'].
      + specialize (I (y - x) ltac:(lra) ltac:(lra)). replace (x + (y - x)) with y in I by ring. lra.
      + specialize (Nr y ltac:(apply Rabs_def1; lra)). apply Rabs_def2 in Nr. lra. }
  assert (Whole : forall y, t < y < hi -> 0 < q y).
  { intros y Hy. destruct (Rle_or_lt y x) as [G|G]; [apply Pos; lra|]. specialize (All (hi - x) ltac:(lra) (y - x) ltac:(lra) ltac:(lra)). replace (x + (y - x)) with y in All by ring. lra. }
  specialize (Grow hi ltac:(lra) Whole hi ltac:(lra)). apply Rle_trans with (k * (hi - t)); [apply Rmult_le_compat_l; lra|exact Grow].
Qed.
End Push.
Lemma D_turned (q : R -> R) t l : is_derive q (- t) l -> is_derive (fun s => q (- s)) t (- l).
Proof. intros D. eapply D_eq; [apply (D_comp q (fun s => - s)); [exact D|apply D_opp, D_id]|]. ring. Qed.
Lemma backward (q p : R -> R) lo hi k c x : (forall t, lo <= t <= hi -> is_derive q t (p t)) -> 0 < k ->
  (forall a b, lo <= a < b -> b <= hi -> (forall t, a < t < b -> 0 < q t) -> k * (b - a) <= p b - p a) ->
  lo <= x < c -> c <= hi -> q c <= 0 -> 0 < q x -> k * (x - lo) <= - p lo.
Proof.
  intros D Hk H Hx Hc Qc Qx.
  pose proof (forward (fun t => q (- t)) (fun t => - p (- t)) (- hi) (- lo) k) as F.
  replace (k * (x - lo)) with (k * (- lo - - x)) by ring. rewrite <- (Ropp_involutive lo) at 2. apply (F) with (c := - c); cbv beta; rewrite ?Ropp_involutive; try lra.
  - intros t Ht. apply D_turned, D. lra.
  - intros a b Ha Hb Pb. replace (b - a) with (- a - - b) by ring. replace (- p (- b) - - p (- a)) with (p (- a) - p (- b)) by ring. apply H; try lra. intros t Ht. rewrite <- (Ropp_involutive t). apply Pb. lra.
Qed.
(* both: a point near the middle of a window where q is positive, a zero in the middle *)
Lemma pushed (q p : R -> R) c w k x : (forall t, c - w <= t <= c + w -> is_derive q t (p t)) -> 0 < k ->
  (forall a b, c - w <= a < b -> b <= c + w -> (forall t, a < t < b -> 0 < q t) -> k * (b - a) <= p b - p a) ->
  q c = 0 -> Rabs (x - c) < w / 2 -> 0 < q x -> k * (w / 2) <= Rabs (p (c + w)) \/ k * (w / 2) <= Rabs (p (c - w)).
Proof.
  intros D Hk H Qc Hx Qx. apply Rabs_def2 in Hx. destruct (Rtotal_order x c) as [L|[->|L]]; [right| |left].
  - pose proof (backward q p (c - w) (c + w) k c x D Hk H ltac:(lra) ltac:(lra) ltac:(lra) Qx) as B. pose proof (Rle_abs (- p (c - w))) as A. rewrite Rabs_Ropp in A.
    apply Rle_trans with (k * (x - (c - w))); [apply Rmult_le_compat_l; lra|lra].
  - lra.
  - pose proof (forward q p (c - w) (c + w) k D Hk H c x ltac:(lra) ltac:(lra) ltac:(lra) Qx) as B. pose proof (Rle_abs (p (c + w))) as A.
    apply Rle_trans with (k * (c + w - x)); [apply Rmult_le_compat_l; lra|lra].
Qed.

(* ---- a time at which q turns ---- *)
Definition turns (q : R -> R) c := q c = 0 /\ forall d, 0 < d -> (exists x, Rabs (x - c) < d /\ 0 < q x) /\ exists x, Rabs (x - c) < d /\ q x < 0.
Lemma turning (q : R -> R) a b : a < b -> (forall t, a <= t <= b -> continuity_pt q t) -> q a < 0 < q b -> (exists c, a <= c <= b /\ turns q c) \/ stays 0 q a b.
Proof.
  intros Hab Cn Hq. destruct (completeness (fun y => a <= y <= b /\ q y < 0)) as [c [U L]]; [exists b; intros y [Y _]; lra|exists a; lra|].
  assert (Ac : a <= c) by (apply U; lra). assert (Cb : c <= b) by (apply L; intros y [Y _]; lra).
  assert (Above : forall y, c < y <= b -> 0 <= q y) by (intros y Hy; apply Rnot_lt_le; intros G; assert (y <= c) by (apply U; lra); lra).
  assert (Below : forall d, 0 < d -> exists y, c - d < y <= c /\ a <= y /\ q y < 0).
  { intros d Hd. apply NNPP. intros N. assert (c <= c - d); [|lra]. apply L. intros y [Y Qy]. apply Rnot_lt_le. intros G. apply N. exists y. split; [split; [exact G|apply U; lra]|lra]. }
  assert (Qc : q c = 0).
  { apply Rle_antisym.
    - apply Rnot_lt_le. intros G. destruct (lipschitz.near_value q c (q c) (Cn c ltac:(lra)) G) as (d & Hd & Nr). destruct (Below d Hd) as (y & Y1 & Y2 & Y3). specialize (Nr y ltac:(apply Rabs_def1; lra)). apply Rabs_def2 in Nr. lra.
    - apply Rnot_lt_le. intros G. destruct (lipschitz.near_value q c (- q c) (Cn c ltac:(lra)) ltac:(lra)) as (d & Hd & Nr). assert (Lb : c < b) by (destruct (Req_dec c b) as [E|E]; [rewrite E in G; lra|lra]).
      pose proof (Rmin_l (b - c) (d / 2)). pose proof (Rmin_r (b - c) (d / 2)). assert (0 < Rmin (b - c) (d / 2)) by (apply Rmin_glb_lt; lra).
      specialize (Nr (c + Rmin (b - c) (d / 2)) ltac:(apply Rabs_def1; lra)). specialize (Above (c + Rmin (b - c) (d / 2)) ltac:(lra)). apply Rabs_def2 in Nr. lra. }
  destruct (classic (exists d, 0 < d /\ forall x, Rabs (x - c) < d -> q x <= 0)) as [(d & Hd & Z)|N].
  - right. assert (Lb : c < b) by (destruct (Req_dec c b) as [E|E]; [rewrite E in Qc; lra|lra]). pose proof (Rmin_l (b - c) (d / 2)). pose proof (Rmin_r (b - c) (d / 2)). assert (0 < Rmin (b - c) (d / 2)) by (apply Rmin_glb_lt; lra).
    exists c, (c + Rmin (b - c) (d / 2)). split; [lra|]. split; [lra|]. intros t Ht. destruct (Req_dec t c) as [->|Nt]; [exact Qc|]. specialize (Above t ltac:(lra)). specialize (Z t ltac:(apply Rabs_def1; lra)). lra.
  - left. exists c. split; [lra|]. split; [exact Qc|]. intros d Hd. split.
    + apply NNPP. intros K. apply N. exists d. split; [exact Hd|]. intros x Hx. apply Rnot_lt_le. intros G. apply K. now exists x.
    + destruct (Below d Hd) as (y & Y1 & Y2 & Y3). exists y. split; [apply Rabs_def1; lra|exact Y3].
Qed.
Lemma turns_opp q c : turns (fun t => - q t) c -> turns q c.
Proof.
  intros [Z H]. split; [lra|]. intros d Hd. destruct (H d Hd) as [(x & X1 & X2) (y & Y1 & Y2)]. split; [exists y|exists x]; split; try assumption; lra.
Qed.

(* ---- the law does not change when all positions, or all velocities, are moved by one amount ---- *)
Lemma law4_moved n g V' r v a b i : law4 n g V' (fun k => (r k - a)%C) (fun k => (v k - b)%C) i = law4 n g V' r v i.
Proof.
  rewrite !law4_one. unfold Csum. apply injective_projections; cbn [fst snd]; apply Sum_ext; intros j _; unfold pull;
    replace (r i - a - (r j - a))%C with (r i - r j)%C by ring; replace (v i - b - (v j - b))%C with (v i - v j)%C by ring; reflexivity.
Qed.
Lemma ac_mult F G : ac F -> ac G -> ac (fun t => F t * G t).
Proof.
  intros A B. pose proof (ac_plus _ _ (ac_sqr _ (ac_plus F G A B)) (ac_plus _ _ (ac_scal (-1) _ (ac_sqr F A)) (ac_scal (-1) _ (ac_sqr G B)))) as S.
  apply (ac_scal (/ 2)) in S. intros T e HT He. destruct (S T e HT He) as (d & Hd & Q). exists d. split; [exact Hd|]. intros m a b I O L. eapply Rle_lt_trans; [|exact (Q m a b I O L)].
  right. apply Sum_ext. intros k _. f_equal. field.
Qed.

Section Pair.
Variables (n : nat) (V V' : nat -> nat -> R -> R) (R0 : R) (r v : nat -> R -> C) (i j : nat).
Hypothesis HR : 0 < R0.
Hypothesis P : potentials n complete V V'.
Hypothesis Pull : forall k l, (k < n)%nat -> (l < n)%nat -> k <> l -> 0 < V' k l R0.
Hypothesis M : motion10 n V' R0 r v.
Hypothesis SC : forall t, 0 <= t -> strongly_connected n (by_distance (fun k => r k t) R0).
Hypothesis One : forall s, limit_point n r s -> one_pair_at n R0 s.
Hypothesis Hi : (i < n)%nat.
Hypothesis Hj : (j < n)%nat.
Hypothesis Ne : i <> j.
Definition gap t : C := (r i t - r j t)%C.
Definition drift t : C := (v i t - v j t)%C.
Definition q t := fst (gap t) ^ 2 + snd (gap t) ^ 2 - R0 ^ 2.
Definition p t := 2 * (fst (gap t) * fst (drift t) + snd (gap t) * snd (drift t)).
Lemma q_is t : q t = Cmod (gap t) ^ 2 - R0 ^ 2.
Proof. unfold q. rewrite <- inner_self, inner_xy. ring. Qed.
Lemma q_sides t : (q t < 0 <-> Cmod (gap t) < R0) /\ (0 < q t <-> R0 < Cmod (gap t)) /\ (q t = 0 <-> Cmod (gap t) = R0).
Proof. rewrite q_is. pose proof (Cmod_ge_0 (gap t)). repeat split; intros G; nra. Qed.
Lemma D_q t : 0 <= t -> is_derive q t (p t).
Proof.
  intros Ht. destruct M as (_ & Mv & _). destruct (Mv t i Ht Hi) as [A1 A2]. destruct (Mv t j Ht Hj) as [B1 B2]. eapply D_eq.
  - unfold q. apply D_minus; [apply D_plus; apply D_sqr|apply D_const]; unfold gap; cbn [fst snd Cminus Cplus Copp]; (apply D_minus; eassumption).
  - unfold p, drift, gap. cbn [fst snd Cminus Cplus Copp]. ring.
Qed.
Lemma p_le t : Rabs (p t) <= 2 * (Cmod (gap t) * Cmod (drift t)).
Proof.
  unfold p. rewrite Rabs_mult, (Rabs_pos_eq 2) by lra. apply Rmult_le_compat_l; [lra|]. rewrite <- inner_xy. apply Rabs_le. pose proof (tanner_saturated.inner_le (gap t) (drift t)) as A.
  pose proof (tanner_saturated.inner_le (- gap t)%C (drift t)) as B. rewrite Cmod_opp in B. replace (inner (- gap t)%C (drift t)) with (- inner (gap t) (drift t)) in B by (rewrite !inner_xy; cbn; ring). lra.
Qed.
Lemma p_ac : ac p.
Proof.
  pose proof (always_moves n V' R0 r v M) as W. destruct (tanner2_unique.place_axes n V' R0 r v _ i W Hi) as [A1 A2]. destruct (tanner2_unique.place_axes n V' R0 r v _ j W Hj) as [B1 B2].
  destruct (v_axes n V' R0 r v _ W i Hi) as [C1 C2]. destruct (v_axes n V' R0 r v _ W j Hj) as [D1 D2].
  assert (S : forall F G, ac F -> ac G -> ac (fun t => F t + - G t)) by (intros F G HF HG; apply ac_plus; [exact HF|]; intros T e HT He; destruct (HG T e HT He) as (d & Hd & Q); exists d; (split; [exact Hd|]);
    intros m a b I O L; eapply Rle_lt_trans; [|exact (Q m a b I O L)]; right; apply Sum_ext; intros k _; rewrite <- Rabs_Ropp; f_equal; ring).
  apply (ac_scal 2 (fun t => fst (gap t) * fst (drift t) + snd (gap t) * snd (drift t))). apply ac_plus; apply ac_mult; unfold gap, drift; cbn [fst snd Cminus Cplus Copp]; apply S; assumption.
Qed.
Lemma D_p t z : 0 <= t -> is_velocity (v i) t (z i) -> is_velocity (v j) t (z j) -> is_derive p t (2 * Cmod (drift t) ^ 2 + 2 * inner (gap t) (z i - z j)%C).
Proof.
  intros Ht [A1 A2] [B1 B2]. destruct M as (_ & Mv & _). destruct (Mv t i Ht Hi) as [C1 C2]. destruct (Mv t j Ht Hj) as [D1 D2]. eapply D_eq.
  - unfold p. apply D_scal. apply D_plus; apply D_mult; unfold gap, drift; cbn [fst snd Cminus Cplus Copp]; (apply D_minus; eassumption).
  - rewrite <- inner_self, !inner_xy. unfold gap, drift. cbn [fst snd Cminus Cplus Copp]. ring.
Qed.

(* ---- at a limit configuration with this pair at R0 ---- *)
Variable s : nat -> C.
Hypothesis As : apart_at n complete s.
Hypothesis Ls : limit_point n r s.
Hypothesis At : Cmod (s i - s j)%C = R0.
Definition this k l := (Nat.eqb k i && Nat.eqb l j || Nat.eqb k j && Nat.eqb l i)%bool.
Definition linked (b : bool) : graph := fun k l => if this k l then b else by_distance s R0 k l.
Lemma this_is k l : this k l = true <-> (k = i /\ l = j) \/ (k = j /\ l = i).
Proof. unfold this. rewrite Bool.orb_true_iff, !Bool.andb_true_iff, !Nat.eqb_eq. tauto. Qed.
Lemma linked_loopless b : loopless n (linked b).
Proof.
  intros k _. unfold linked. destruct (this k k) eqn:T; [|apply by_distance_simple]. apply this_is in T. destruct T as [[-> E]|[-> E]]; congruence.
Qed.
Lemma others_keep : exists g, 0 < g /\ forall x : nat -> C, (forall k, (k < n)%nat -> Cmod (x k - s k)%C < g) -> forall k l, (k < n)%nat -> (l < n)%nat -> k <> l -> this k l = false ->
  (Cmod (x k - x l)%C < R0 <-> Cmod (s k - s l)%C < R0) /\ Cmod (x k - x l)%C <> R0.
Proof.
  destruct (small2 n (fun k l g => k <> l -> this k l = false -> forall x : nat -> C, Cmod (x k - s k)%C < g -> Cmod (x l - s l)%C < g -> (Cmod (x k - x l)%C < R0 <-> Cmod (s k - s l)%C < R0) /\ Cmod (x k - x l)%C <> R0)) as (g & Hg & Q).
  - intros k l d d' H L Nk T x A B. apply (H Nk T); lra.
  - intros k l Hk Hl. destruct (this k l) eqn:T; [exists 1; split; [lra|]; discriminate|]. destruct (Nat.eq_dec k l) as [->|Nk]; [exists 1; split; [lra|congruence]|].
    assert (N : Cmod (s k - s l)%C <> R0).
    { intros E. pose proof (One s Ls i j k l Hi Hj Hk Hl Ne Nk At E) as X. apply this_is in X. congruence. }
    exists (Rabs (Cmod (s k - s l)%C - R0) / 2). split; [apply Rdiv_lt_0_compat; [apply Rabs_pos_lt|]; lra|]. intros _ _ x A B.
    pose proof (tanner2_field.distance_near (x k) (x l) (s k) (s l) _ A B) as L1. apply Rabs_def2 in L1.
    unfold Rabs in *. destruct (Rcase_abs (Cmod (s k - s l)%C - R0)); split; try split; lra.
  - exists g. split; [exact Hg|]. intros x N k l Hk Hl Nk T. apply (Q k l Hk Hl Nk T); now apply N.
Qed.
Definition pushed_by b : C := (law4 n (linked b) V' s tanner2_approach.rest i - law4 n (linked b) V' s tanner2_approach.rest j)%C.
Definition curve b := 2 * inner (s i - s j)%C (pushed_by b).
Definition jump := 2 * (V' i j R0 + V' j i R0) * R0.
Lemma jump_pos : 0 < jump.
Proof. unfold jump. pose proof (Pull i j Hi Hj Ne). pose proof (Pull j i Hj Hi ltac:(congruence)). apply Rmult_lt_0_compat; lra. Qed.
Lemma grad_more k l : (k = i /\ l = j) \/ (k = j /\ l = i) -> gradV n (linked true) V' s k = (gradV n (linked false) V' s k + RtoC (V' k l R0 / R0) * (s k - s l))%C.
Proof.
  intros K. assert (Hl : (l < n)%nat) by (destruct K as [[_ ->]|[_ ->]]; assumption).
  assert (D : Cmod (s k - s l)%C = R0) by (destruct K as [[-> ->]|[-> ->]]; [exact At|rewrite <- At, <- Cmod_opp; f_equal; ring]).
  assert (E : forall m, pull (linked true) V' s k m = (pull (linked false) V' s k m + RtoC (delta m l) * (RtoC (V' k l R0 / R0) * (s k - s l)))%C).
  { intros m. unfold pull, linked, delta. destruct (this k m) eqn:T.
    - apply this_is in T. assert (m = l) as -> by (destruct K as [[-> ->]|[-> ->]], T as [[? ?]|[? ?]]; congruence). rewrite Nat.eqb_refl, D. ring.
    - destruct (Nat.eqb_spec m l) as [->|]; [|destruct (by_distance s R0 k m); ring]. exfalso. assert (this k l = true) by (apply this_is; destruct K as [[-> ->]|[-> ->]]; tauto). congruence. }
  unfold gradV. rewrite (Csum_ext n _ _ (fun m _ => E m)). unfold Csum. apply injective_projections; cbn [fst snd Cplus]; rewrite Sum_plus; f_equal.
  - rewrite (Sum_ext n _ (fun m => delta m l * fst (RtoC (V' k l R0 / R0) * (s k - s l))%C)); [now apply (Sum_delta n l (fun _ => fst (RtoC (V' k l R0 / R0) * (s k - s l))%C))|]. intros m _. cbn. ring.
  - rewrite (Sum_ext n _ (fun m => delta m l * snd (RtoC (V' k l R0 / R0) * (s k - s l))%C)); [now apply (Sum_delta n l (fun _ => snd (RtoC (V' k l R0 / R0) * (s k - s l))%C))|]. intros m _. cbn. ring.
Qed.
Lemma curve_jump : curve true = curve false - jump.
Proof.
  unfold curve, pushed_by, jump. rewrite !tanner2_approach.law4_rest, (grad_more i j), (grad_more j i) by tauto. pose proof (inner_self (s i - s j)%C) as I. rewrite At in I.
  set (a := gradV n (linked false) V' s i). set (b := gradV n (linked false) V' s j). set (D := (s i - s j)%C) in *. replace (s j - s i)%C with (- D)%C by (unfold D; ring).
  replace (inner D (- (a + RtoC (V' i j R0 / R0) * D) - - (b + RtoC (V' j i R0 / R0) * - D))%C) with (inner D (- a - - b)%C - (V' i j R0 / R0 + V' j i R0 / R0) * inner D D) by (rewrite !inner_xy; cbn; ring).
  rewrite I. field. lra.
Qed.
(* near it the second derivative of |r_ij|^2 is nearly one of two numbers *)
Lemma linked_here (x : nat -> C) (b : bool) : (forall k l, (k < n)%nat -> (l < n)%nat -> k <> l -> this k l = false -> (Cmod (x k - x l)%C < R0 <-> Cmod (s k - s l)%C < R0) /\ Cmod (x k - x l)%C <> R0) ->
  (if b then Cmod (x i - x j)%C < R0 else R0 < Cmod (x i - x j)%C) -> generic n R0 x /\ same_pairs n (by_distance x R0) (linked b).
Proof.
  intros O B. assert (B' : if b then Cmod (x j - x i)%C < R0 else R0 < Cmod (x j - x i)%C) by (rewrite <- (Cmod_opp (x j - x i)%C); replace (- (x j - x i))%C with (x i - x j)%C by ring; exact B). split.
  - intros k l Hk Hl Nk. destruct (this k l) eqn:T; [|now apply O]. apply this_is in T. destruct T as [[-> ->]|[-> ->]], b; lra.
  - intros k l Hk Hl. unfold linked. destruct (this k l) eqn:T.
    + apply this_is in T. unfold by_distance. destruct (Nat.eqb_spec k l) as [E|_]; [destruct T as [[-> ->]|[-> ->]]; congruence|]. cbn [negb andb].
      destruct T as [[-> ->]|[-> ->]], b; (match goal with |- (if ?c then _ else _) = _ => destruct c end); try reflexivity; lra.
    + unfold by_distance. destruct (Nat.eqb_spec k l) as [E|Nk]; [reflexivity|]. cbn [negb andb]. destruct (O k l Hk Hl Nk T) as [I _].
      destruct (Rlt_dec (Cmod (x k - x l)%C) R0), (Rlt_dec (Cmod (s k - s l)%C) R0); tauto || reflexivity.
Qed.
Lemma acceleration : exists N, negligible N /\ exists h, 0 < h /\ forall t b, 0 <= t -> ~ N t -> (forall k, (k < n)%nat -> Cmod (tanner2_approach.shape r t k - s k)%C < h) ->
  (forall k l, (k < n)%nat -> (l < n)%nat -> Cmod (v k t - v l t)%C < h) -> (if b : bool then q t < 0 else 0 < q t) ->
  exists l, is_derive p t l /\ curve b - jump / 4 <= l <= curve b + 3 * jump / 8.
Proof.
  destruct (kept_apart n V V' R0 r v HR P M) as (d0 & Hd0 & Far). pose proof (proj2 (proj2 (proj2 M))) as (N & HN & Mz). exists N. split; [exact HN|].
  pose proof jump_pos as J0. set (J := jump) in *. set (L := Cmod (pushed_by true) + Cmod (pushed_by false) + 1).
  pose proof (Cmod_ge_0 (pushed_by true)) as Lt. pose proof (Cmod_ge_0 (pushed_by false)) as Lf. assert (L1 : 1 <= L) by (unfold L; lra).
  set (e := Rmin (/ 2) (J / (32 * R0))). assert (e0 : 0 < e) by (apply Rmin_glb_lt; [lra|apply Rdiv_lt_0_compat; lra]). assert (e1 : e <= / 2) by apply Rmin_l.
  assert (e2 : 4 * R0 * e <= J / 8). { apply Rle_trans with (4 * R0 * (J / (32 * R0))); [apply Rmult_le_compat_l; [lra|apply Rmin_r]|right; field; lra]. }
  destruct others_keep as (g & Hg & Keep). destruct (law4_near n V V' s tanner2_approach.rest P As (linked true) e (linked_loopless true) e0) as (d1 & H1 & F1).
  destruct (law4_near n V V' s tanner2_approach.rest P As (linked false) e (linked_loopless false) e0) as (d2 & H2 & F2).
  set (h := Rmin (Rmin g (Rmin d1 d2)) (Rmin (J / (32 * L)) (Rmin 1 (J / 16)))).
  pose proof (Rmin_l (Rmin g (Rmin d1 d2)) (Rmin (J / (32 * L)) (Rmin 1 (J / 16)))) as A1. pose proof (Rmin_r (Rmin g (Rmin d1 d2)) (Rmin (J / (32 * L)) (Rmin 1 (J / 16)))) as A2. fold h in A1, A2.
  pose proof (Rmin_l g (Rmin d1 d2)) as A3. pose proof (Rmin_r g (Rmin d1 d2)) as A4. pose proof (Rmin_l d1 d2) as A5. pose proof (Rmin_r d1 d2) as A6. pose proof (Rmin_l (J / (32 * L)) (Rmin 1 (J / 16))) as A7. pose proof (Rmin_r (J / (32 * L)) (Rmin 1 (J / 16))) as A8.
  pose proof (Rmin_l 1 (J / 16)) as A9. pose proof (Rmin_r 1 (J / 16)) as A10.
  assert (Hh : 0 < h) by (unfold h; repeat apply Rmin_glb_lt; try assumption; try lra; apply Rdiv_lt_0_compat; lra).
  assert (h1 : 4 * h * L <= J / 8). { apply Rle_trans with (4 * (J / (32 * L)) * L); [|right; field; lra]. apply Rmult_le_compat_r; [lra|]. apply Rmult_le_compat_l; lra. }
  exists h. split; [exact Hh|]. intros t b Ht Nt Near Slow Side. set (x := tanner2_approach.shape r t) in *. set (u := fun k => (v k t - v 0%nat t)%C).
  assert (X : forall k l, (x k - x l)%C = (r k t - r l t)%C) by (intros k l; unfold x, tanner2_approach.shape; ring).
  assert (At' : apart_at n complete (fun k => r k t)).
  { intros k l Hk Hl C0 E. assert (Nk : k <> l) by (intros ->; unfold complete in C0; now rewrite Nat.eqb_refl in C0). specialize (Far t k l Ht Hk Hl Nk). rewrite E in Far. replace (r l t - r l t)%C with (RtoC 0) in Far by ring. rewrite Cmod_0 in Far. lra. }
  destruct (linked_here x b) as [G Sp].
  { intros k l Hk Hl Nk T. apply (Keep x); try assumption. intros m Hm. specialize (Near m Hm). lra. }
  { rewrite X. destruct (q_sides t) as (Q1 & Q2 & _). unfold gap in *. destruct b; tauto. }
  destruct (Mz t Ht Nt At') as (z & Kz & Vz).
  assert (Zl : forall k, (k < n)%nat -> z k = law4 n (linked b) V' x u k).
  { intros k Hk. rewrite (tanner2_unique.off_ties n V V' R0 (fun k => r k t) (fun k => v k t) z P At'); [| |exact Kz|exact Hk].
    - rewrite (law4_pairs n _ (linked b) V' _ _ k); [|intros k' l' Hk' Hl'; rewrite <- (Sp k' l' Hk' Hl'); unfold by_distance; now rewrite X|exact Hk].
      unfold x, u, tanner2_approach.shape. symmetry. apply (law4_moved n (linked b) V' (fun k => r k t) (fun k => v k t)).
    - intros k' l' Hk' Hl' Nk'. rewrite <- X. now apply G. }
  assert (Zn : forall k, (k < n)%nat -> Cmod (z k - law4 n (linked b) V' s tanner2_approach.rest k)%C < e).
  { intros k Hk. rewrite (Zl k Hk). assert (Cl : forall m, (m < n)%nat -> Cmod (x m - s m)%C < h /\ Cmod (u m - tanner2_approach.rest m)%C < h).
    { intros m Hm. split; [now apply Near|]. unfold u, tanner2_approach.rest. replace (v m t - v 0%nat t - 0)%C with (v m t - v 0%nat t)%C by ring. apply Slow; [exact Hm|lia]. }
    destruct b; [apply F1|apply F2]; try exact Hk; intros m Hm; destruct (Cl m Hm); split; lra. }
  exists (2 * Cmod (drift t) ^ 2 + 2 * inner (gap t) (z i - z j)%C). split; [apply D_p; [exact Ht|now apply Vz|now apply Vz]|].
  set (D := (s i - s j)%C). set (W := (z i - z j)%C). set (Y := pushed_by b).
  assert (B1 : Cmod (gap t - D)%C <= 2 * h).
  { unfold gap, D. rewrite <- X. replace (x i - x j - (s i - s j))%C with ((x i - s i) + - (x j - s j))%C by ring. eapply Rle_trans; [apply Cmod_triangle|]. rewrite Cmod_opp. pose proof (Near i Hi). pose proof (Near j Hj). lra. }
  assert (B2 : Cmod (W - Y)%C <= 2 * e).
  { unfold W, Y, pushed_by. set (y1 := law4 n (linked b) V' s tanner2_approach.rest i). set (y2 := law4 n (linked b) V' s tanner2_approach.rest j). replace (z i - z j - (y1 - y2))%C with ((z i - y1) + - (z j - y2))%C by ring.
    eapply Rle_trans; [apply Cmod_triangle|]. rewrite Cmod_opp. pose proof (Zn i Hi). pose proof (Zn j Hj). unfold y1, y2. lra. }
  assert (BY : Cmod Y + 1 <= L) by (unfold Y, L; destruct b; lra).
  assert (B3 : Cmod W <= L). { replace W with (Y + (W - Y))%C by ring. eapply Rle_trans; [apply Cmod_triangle|]. lra. }
  assert (Split : 2 * inner (gap t) W = curve b + (2 * inner (gap t - D)%C W + 2 * inner D (W - Y)%C)) by (unfold curve; fold D Y; rewrite !inner_xy; cbn; ring).
  assert (In : forall (a c : C) A B, Cmod a <= A -> Cmod c <= B -> Rabs (inner a c) <= A * B).
  { intros a c A B HA HB. pose proof (Cmod_ge_0 a). pose proof (Cmod_ge_0 c). assert (Cmod a * Cmod c <= A * B) by (apply Rmult_le_compat; assumption). pose proof (tanner_saturated.inner_le a c) as I1.
    pose proof (tanner_saturated.inner_le (- a)%C c) as I2. rewrite Cmod_opp in I2. replace (inner (- a)%C c) with (- inner a c) in I2 by (rewrite !inner_xy; cbn; ring). apply Rabs_le. lra. }
  pose proof (In (gap t - D)%C W (2 * h) L B1 B3) as I1. pose proof (In D (W - Y)%C R0 (2 * e) (Req_le _ _ At) B2) as I2. apply Rabs_le_between in I1, I2.
  assert (Dr : 0 <= Cmod (drift t) ^ 2 <= J / 16). { pose proof (Cmod_ge_0 (drift t)). pose proof (Slow i j Hi Hj) as S. fold (drift t) in S. split; [apply pow2_ge_0|]. nra. }
  rewrite Split. lra.
Qed.
(* so it cannot be met again and again at times at which this pair turns *)
Lemma few_turns : (forall T e, 0 < e -> exists c, T <= c /\ 0 <= c /\ turns q c /\ forall k, (k < n)%nat -> Cmod (tanner2_approach.shape r c k - s k)%C < e) -> False.
Proof.
  intros Rt. assert (Hn : (1 <= n)%nat) by lia. destruct acceleration as (N & HN & h & Hh & Acc). pose proof jump_pos as J0. set (J := jump) in *.
  set (e := Rmin (h / 8) (Rmin 1 (J / (128 * (R0 + 2))))). assert (He : 0 < e) by (repeat apply Rmin_glb_lt; try lra; apply Rdiv_lt_0_compat; lra).
  assert (e1 : e <= h / 8) by apply Rmin_l. pose proof (Rmin_r (h / 8) (Rmin 1 (J / (128 * (R0 + 2))))) as e2. fold e in e2. pose proof (Rmin_l 1 (J / (128 * (R0 + 2)))) as e3. pose proof (Rmin_r 1 (J / (128 * (R0 + 2)))) as e4.
  assert (e5 : 2 * ((R0 + 2) * e) < J / 32). { apply Rle_lt_trans with (2 * ((R0 + 2) * (J / (128 * (R0 + 2))))); [apply Rmult_le_compat_l; [lra|]; apply Rmult_le_compat_l; lra|]. replace (2 * ((R0 + 2) * (J / (128 * (R0 + 2))))) with (J / 64) by (field; lra). lra. }
  destruct (tanner2_approach.agree_late n V V' R0 r v HR P M SC e He) as (T & HT & Ag). destruct (Rt (T + 1) e He) as (c & Hc & _ & [Qc Tc] & Near).
  assert (Close : forall t, c - 1 <= t <= c + 1 -> forall k, (k < n)%nat -> Cmod (tanner2_approach.shape r t k - s k)%C < h /\ Cmod (tanner2_approach.shape r t k - tanner2_approach.shape r c k)%C <= 2 * e).
  { intros t Ht k Hk. assert (B : Cmod (tanner2_approach.shape r t k - tanner2_approach.shape r c k)%C <= 2 * e).
    { destruct (Rle_or_lt c t) as [G|G].
      - pose proof (tanner2_approach.shape_slow n V' R0 r v Hn M T e c t Ag HT ltac:(lra) k Hk) as S. assert (e * (t - c) <= e * 1) by (apply Rmult_le_compat_l; lra). lra.
      - pose proof (tanner2_approach.shape_slow n V' R0 r v Hn M T e t c Ag HT ltac:(lra) k Hk) as S. assert (e * (c - t) <= e * 1) by (apply Rmult_le_compat_l; lra). rewrite <- Cmod_opp.
        replace (- (tanner2_approach.shape r t k - tanner2_approach.shape r c k))%C with (tanner2_approach.shape r c k - tanner2_approach.shape r t k)%C by ring. lra. }
    split; [|exact B]. specialize (Near k Hk). replace (tanner2_approach.shape r t k - s k)%C with ((tanner2_approach.shape r t k - tanner2_approach.shape r c k) + (tanner2_approach.shape r c k - s k))%C by ring.
    eapply Rle_lt_trans; [apply Cmod_triangle|]. lra. }
  (* the rate of |r_ij|^2 is small *)
  assert (Small : forall t, c - 1 <= t <= c + 1 -> Rabs (p t) < J / 16).
  { intros t Ht. eapply Rle_lt_trans; [apply p_le|]. destruct (q_sides c) as (_ & _ & Q3). assert (Gc : Cmod (gap c) = R0) by tauto.
    assert (Gt : Cmod (gap t) <= R0 + 4).
    { replace (gap t) with (gap c + ((tanner2_approach.shape r t i - tanner2_approach.shape r c i) + - (tanner2_approach.shape r t j - tanner2_approach.shape r c j)))%C by (unfold gap, tanner2_approach.shape; ring).
      eapply Rle_trans; [apply Cmod_triangle|]. rewrite Gc. apply Rplus_le_compat_l. eapply Rle_trans; [apply Cmod_triangle|]. rewrite Cmod_opp. destruct (Close t Ht i Hi), (Close t Ht j Hj). lra. }
    pose proof (Ag t ltac:(lra) i j Hi Hj) as S. fold (drift t) in S. pose proof (Cmod_ge_0 (drift t)). pose proof (Cmod_ge_0 (gap t)).
    assert (Cmod (gap t) * Cmod (drift t) <= (R0 + 4) * e) by (apply Rmult_le_compat; lra). assert ((R0 + 4) * e <= 2 * ((R0 + 2) * e)) by nra. lra. }
  assert (Rate : forall b t, c - 1 <= t <= c + 1 -> ~ N t -> (if b : bool then q t < 0 else 0 < q t) -> exists l, is_derive p t l /\ curve b - J / 4 <= l <= curve b + 3 * J / 8).
  { intros b t Ht Nt Sd. apply (Acc t b); [lra|exact Nt|intros k Hk; now apply Close| |exact Sd]. intros k l Hk Hl. eapply Rlt_le_trans; [apply Ag; [lra|exact Hk|exact Hl]|lra]. }
  assert (N2 : forall a b, 0 <= a -> 0 <= b -> negligible (fun t => N t \/ (t = a \/ t = b))) by (intros a b Ha Hb; apply negligible_or; [exact HN|]; apply negligible_or; apply tanner2_appendix.negligible_at; assumption).
  assert (Contra : J / 8 * (1 / 2) <= Rabs (p (c + 1)) \/ J / 8 * (1 / 2) <= Rabs (p (c - 1)) -> False).
  { intros [G|G]; [pose proof (Small (c + 1) ltac:(lra))|pose proof (Small (c - 1) ltac:(lra))]; lra. }
  apply Contra. destruct (Tc (1 / 2) ltac:(lra)) as [(x & X1 & X2) (y & Y1 & Y2)]. destruct (Rle_or_lt (J / 2) (curve false)) as [Big|Sm].
  - apply (pushed q p c 1 (J / 8) x); try assumption; try lra; [intros t Ht; apply D_q; lra|]. intros a b Ha Hb Pb.
    assert (U : -1 * p b <= -1 * p a + - (J / 8) * (b - a)); [|lra]. apply (ac_le (fun t => -1 * p t) _ a b (- (J / 8)) (ac_scal (-1) p p_ac) (N2 a b ltac:(lra) ltac:(lra)) ltac:(lra)).
    intros t Ht Nt. destruct (Rate false t ltac:(lra) ltac:(tauto)) as (l & Dl & L1 & L2).
    { apply Pb. split; apply Rnot_le_lt; intros G; apply Nt; right; [left|right]; lra. }
    exists (-1 * l). split; [now apply D_scal|lra].
  - pose proof curve_jump as Cj. fold J in Cj. assert (Q : J / 8 * (1 / 2) <= Rabs (- p (c + 1)) \/ J / 8 * (1 / 2) <= Rabs (- p (c - 1))); [|now rewrite !Rabs_Ropp in Q].
    apply (pushed (fun t => - q t) (fun t => - p t) c 1 (J / 8) y); try assumption; try lra; [intros t Ht; apply D_opp, D_q; lra|]. intros a b Ha Hb Pb.
    assert (U : p b <= p a + - (J / 8) * (b - a)); [|lra]. apply (ac_le p _ a b (- (J / 8)) p_ac (N2 a b ltac:(lra) ltac:(lra)) ltac:(lra)).
    intros t Ht Nt. destruct (Rate true t ltac:(lra) ltac:(tauto)) as (l & Dl & L1 & L2).
    { assert (0 < - q t); [|lra]. apply Pb. split; apply Rnot_le_lt; intros G; apply Nt; right; [left|right]; lra. }
    exists l. split; [exact Dl|lra].
Qed.
End Pair.

(* ---- late pairs do not turn, so they stay where they pass ---- *)
Lemma no_late_turns n V V' R0 r v i j : 0 < R0 -> potentials n complete V V' -> (forall k l, (k < n)%nat -> (l < n)%nat -> k <> l -> 0 < V' k l R0) -> motion10 n V' R0 r v ->
  (forall t, 0 <= t -> strongly_connected n (by_distance (fun k => r k t) R0)) -> (forall s, limit_point n r s -> one_pair_at n R0 s) -> (i < n)%nat -> (j < n)%nat -> i <> j ->
  exists T, forall c, T <= c -> 0 <= c -> ~ turns (q R0 r i j) c.
Proof.
  intros HR P Pl M SC One Hi Hj Ne. apply NNPP. intros No. assert (Hn : (1 <= n)%nat) by lia.
  destruct (tanner2_approach.returns n R0 r (turns (q R0 r i j)) Hn SC) as [s Rt].
  { intros T. apply NNPP. intros K. apply No. exists T. intros c Hc H0 Tc. apply K. now exists c. }
  assert (Ls : limit_point n r s).
  { intros T e He. destruct (Rt T (e / 2) ltac:(lra)) as (t & Ht & _ & _ & Near). exists t. split; [exact Ht|]. intros k l Hk Hl.
    replace (r k t - r l t - (s k - s l))%C with ((tanner2_approach.shape r t k - s k) + - (tanner2_approach.shape r t l - s l))%C by (unfold tanner2_approach.shape; ring).
    eapply Rle_lt_trans; [apply Cmod_triangle|]. rewrite Cmod_opp. pose proof (Near k Hk). pose proof (Near l Hl). lra. }
  destruct (kept_apart n V V' R0 r v HR P M) as (d0 & Hd0 & Far). apply (few_turns n V V' R0 r v i j HR P Pl M SC One Hi Hj Ne s); [|exact Ls| |exact Rt].
  - intros k l Hk Hl C0 E. assert (Nk : k <> l) by (intros ->; unfold complete in C0; now rewrite Nat.eqb_refl in C0). destruct (Ls 0 d0 ltac:(lra)) as (t & Ht & Near). specialize (Near k l Hk Hl). specialize (Far t k l Ht Hk Hl Nk).
    rewrite E in Near. replace (r k t - r l t - (s l - s l))%C with (r k t - r l t)%C in Near by ring. lra.
  - apply cond_eq. intros e He. destruct (Rt 0 (e / 2) ltac:(lra)) as (t & _ & _ & [Qt _] & Near). apply q_sides in Qt; [|exact HR]. unfold gap in Qt. rewrite <- Qt.
    set (x := tanner2_approach.shape r t) in *. replace (r i t - r j t)%C with (x i - x j)%C by (unfold x, tanner2_approach.shape; ring).
    rewrite Rabs_minus_sym. replace e with (2 * (e / 2)) by field. apply tanner2_field.distance_near; now apply Near.
Qed.
Lemma switching_stops10 n V V' R0 r v : 0 < R0 -> potentials n complete V V' -> (forall k l, (k < n)%nat -> (l < n)%nat -> k <> l -> 0 < V' k l R0) -> motion10 n V' R0 r v ->
  (forall t, 0 <= t -> strongly_connected n (by_distance (fun k => r k t) R0)) -> (forall s, limit_point n r s -> one_pair_at n R0 s) -> switching_ends n R0 r.
Proof.
  intros HR P Pl M SC One. destruct (small2 n (fun i j d => i <> j -> forall c, / d <= c -> 0 <= c -> ~ turns (q R0 r i j) c)) as (d & Hd & Q).
  - intros i j d d' H L Ne c Hc. apply (H Ne). eapply Rle_trans; [|exact Hc]. apply Rinv_le_contravar; lra.
  - intros i j Hi Hj. destruct (Nat.eq_dec i j) as [->|Ne]; [exists 1; split; [lra|congruence]|]. destruct (no_late_turns n V V' R0 r v i j HR P Pl M SC One Hi Hj Ne) as [T H].
    exists (/ (Rabs T + 1)). pose proof (Rabs_pos T). split; [apply Rinv_0_lt_compat; lra|]. intros _ c Hc. rewrite Rinv_inv in Hc. apply H. pose proof (Rle_abs T). lra.
  - exists (/ d). assert (0 < / d) by now apply Rinv_0_lt_compat. split; [lra|]. intros i j a b Hi Hj Ne Hab Ps.
    assert (Cn : forall t, a <= t <= b -> continuity_pt (q R0 r i j) t).
    { intros t Ht. apply derivable_continuous_pt. exists (p r v i j t). apply is_derive_Reals. apply (D_q n V' R0 r v i j M Hi Hj). lra. }
    assert (Done : (exists c, a <= c <= b /\ turns (q R0 r i j) c) \/ stays 0 (q R0 r i j) a b).
    { destruct Ps as [[A B]|[A B]]; apply q_sides in A, B; try exact HR.
      - apply turning; [lra|exact Cn|lra].
      - destruct (turning (fun t => - q R0 r i j t) a b) as [(c & Hc & Tc)|(c & e & H1 & H2 & H3)]; [lra|intros t Ht; now apply continuity_pt_opp, Cn|lra| |].
        + left. exists c. split; [exact Hc|now apply turns_opp].
        + right. exists c, e. split; [exact H1|]. split; [exact H2|]. intros t Ht. specialize (H3 t Ht). lra. }
    destruct Done as [(c & Hc & Tc)|(c & e & H1 & H2 & H3)].
    + exfalso. apply (Q i j Hi Hj Ne c); [lra|lra|exact Tc].
    + exists c, e. split; [exact H1|]. split; [exact H2|]. intros t Ht. specialize (H3 t Ht). apply q_sides in H3; [exact H3|exact HR].
Qed.
(* for solutions after Definition 4, K of the whole vector field *)
Theorem switching_stops : forall n V V' R0 x, 0 < R0 -> potentials n complete V V' -> (forall k l, (k < n)%nat -> (l < n)%nat -> k <> l -> 0 < V' k l R0) ->
  tanner2_definition4.solution_always n V' R0 x -> tanner2_definition4.connected_always n R0 x ->
  (forall s, limit_point n (fun i t => tanner2_field.place_of (x t) i) s -> one_pair_at n R0 s) -> switching_ends n R0 (fun i t => tanner2_field.place_of (x t) i).
Proof.
  intros n V V' R0 x HR P Pl Sx Cx One.
  assert (E : forall i t, 0 <= t -> tanner2_definition4.place_at x i t = tanner2_field.place_of (x t) i) by (intros i t Ht; unfold tanner2_definition4.place_at; destruct (Rlt_dec t 0); [lra|reflexivity]).
  destruct (switching_stops10 n V V' R0 _ _ HR P Pl (tanner2_definition4.motion_always n V V' R0 HR P x Sx) (tanner2_definition4.connected_places n R0 x Cx)) as (T & HT & H).
  - intros s Ls. apply One. intros T e He. destruct (Ls (Rmax T 0) e He) as (t & Ht & Q). pose proof (Rmax_l T 0). pose proof (Rmax_r T 0). exists t. split; [lra|]. intros i j Hi Hj. specialize (Q i j Hi Hj). now rewrite !E in Q by lra.
  - exists T. split; [exact HT|]. intros i j a b Hi Hj Ne Hab Ps. destruct (H i j a b Hi Hj Ne Hab) as (c & d & H1 & H2 & H3).
    + unfold passes in *. now rewrite !E by lra.
    + exists c, d. split; [exact H1|]. split; [exact H2|]. intros t Ht. specialize (H3 t Ht). now rewrite !E in H3 by lra.
Qed.
