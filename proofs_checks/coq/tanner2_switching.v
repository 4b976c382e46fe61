(* Tanner, Jadbabaie, Pappas, arbitrary switching: four agents that use the paths 0-1-2-3 and 1-3-0-2 in turn, each for
   the time P, never come to agree.
     beyond.tanner2.alternating_trees, tanner2.arbswitch (corrected, clause 2). *)
From Coq Require Import Reals Lra Lia Psatz List.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums paley_model paley_phase paley_laplacian paley_gradient paley_particles tanner_energy tanner_flock tanner2_motion tanner_paths tanner_trees IntervalStdZ.
Open Scope R_scope.

(* V = s + 1/s - 2 with s the squared distance, as a function of the distance *)
Definition spring (d : R) : R := d ^ 2 + / d ^ 2 - 2.
Definition spring' (d : R) : R := 2 * d - 2 / d ^ 3.
Definition linked (l : list (nat * nat)) : graph :=
  fun i j => existsb (fun e => (Nat.eqb i (fst e) && Nat.eqb j (snd e) || Nat.eqb j (fst e) && Nat.eqb i (snd e))%bool) l.
Definition first : graph := linked ((0, 1) :: (1, 2) :: (2, 3) :: nil)%nat.
Definition second : graph := linked ((1, 3) :: (3, 0) :: (0, 2) :: nil)%nat.
Definition turn (k : nat) : graph := if Nat.even k then first else second.

Theorem spring_potential : potential spring spring'.
Proof.
  assert (P2 : forall s, 0 < s -> 0 < s ^ 2) by (intros; apply pow_lt; assumption).
  split; [|split].
  - intros s Hs. pose proof (P2 s Hs). split.
    + unfold spring, spring'. auto_derive; [lra|]. field. lra.
    + unfold spring. assert (E : s ^ 2 + / s ^ 2 - 2 = (s - / s) ^ 2) by (field; lra). rewrite E. apply pow2_ge_0.
  - intros c. exists (/ (Rabs c + 2)). pose proof (Rabs_pos c). pose proof (Rle_abs c). split; [apply Rinv_0_lt_compat; lra|].
    intros s [Hs L]. pose proof (P2 s Hs). unfold spring. apply Rinv_lt_contravar in L; [|apply Rmult_lt_0_compat; [lra|apply Rinv_0_lt_compat; lra]].
    rewrite Rinv_inv in L. replace (/ s ^ 2) with ((/ s) ^ 2) by (field; lra).
    assert ((Rabs c + 2) ^ 2 <= (/ s) ^ 2) by (apply pow_incr; lra). assert ((Rabs c + 2) ^ 2 = Rabs c * Rabs c + 4 * Rabs c + 4) by ring. nra.
  - intros c. exists (Rabs c + 2). pose proof (Rabs_pos c). pose proof (Rle_abs c). intros s L. unfold spring.
    assert (0 < / s ^ 2) by (apply Rinv_0_lt_compat, P2; lra).
    assert ((Rabs c + 2) ^ 2 <= s ^ 2) by (apply pow_incr; lra). assert ((Rabs c + 2) ^ 2 = Rabs c * Rabs c + 4 * Rabs c + 4) by ring. nra.
Qed.

(* ---- the plane ---- *)
Lemma inner_norms (x y : C) : Rabs (inner x y) <= norm x * norm y.
Proof.
  pose proof (norm_ge0 x). pose proof (norm_ge0 y). rewrite <- (Rabs_pos_eq (norm x * norm y)) by (apply Rmult_le_pos; assumption). apply Rsqr_le_abs_0.
  unfold Rsqr. replace (norm x * norm y * (norm x * norm y)) with (norm x * norm x * (norm y * norm y)) by ring.
  rewrite !norm_sqr, !inner_xy. pose proof (pow2_ge_0 (fst x * snd y - snd x * fst y)). lra.
Qed.

Lemma MVT_inside (f f' : R -> R) a b : a < b -> (forall t, a <= t <= b -> continuity_pt f t) -> (forall t, a < t < b -> is_derive f t (f' t)) ->
  exists c, a < c < b /\ f b - f a = f' c * (b - a).
Proof.
  intros L Ct D. destruct (MVT_gen f a b (fun t => if Rlt_dec a t then if Rlt_dec t b then f' t else (f b - f a) / (b - a) + 1 else (f b - f a) / (b - a) + 1)) as [c [Hc E]].
  - intros x Hx. rewrite Rmin_left, Rmax_right in Hx by lra. destruct (Rlt_dec a x); [|lra]. destruct (Rlt_dec x b); [|lra]. now apply D.
  - intros x Hx. rewrite Rmin_left, Rmax_right in Hx by lra. now apply Ct.
  - assert (F : (((f b - f a) / (b - a) + 1) * (b - a) = f b - f a + (b - a))) by (field; lra).
    exists c. destruct (Rlt_dec a c); [|lra]. destruct (Rlt_dec c b); [|lra]. split; [split; assumption|exact E].
Qed.
Lemma velocity_continuous (x : R -> C) t u : is_velocity x t u -> continuity_pt (fun s => fst (x s)) t /\ continuity_pt (fun s => snd (x s)) t.
Proof. intros [A B]. split; apply continuity_pt_filterlim; [apply (ex_derive_continuous (fun s => fst (x s)))|apply (ex_derive_continuous (fun s => snd (x s)))]; eexists; eassumption. Qed.
Lemma drift (x w : R -> C) a b e : (forall t, a <= t <= b -> is_velocity x t (w t)) -> (forall t, a <= t <= b -> norm (w t) <= e) ->
  forall s t, a <= s <= b -> a <= t <= b -> Rabs (norm (x s) - norm (x t)) <= 2 * e * (b - a).
Proof.
  intros V B.
  assert (M : forall s t, a <= s <= t -> t <= b -> norm (x t - x s)%C <= 2 * e * (b - a)).
  { intros s t Hs Ht.
    destruct (MVT_le (fun t => fst (x t)) (fun t => fst (w t)) s t (proj2 Hs)) as [c [Hc E1]]; [intros; apply V; lra|].
    destruct (MVT_le (fun t => snd (x t)) (fun t => snd (w t)) s t (proj2 Hs)) as [c' [Hc' E2]]; [intros; apply V; lra|].
    pose proof (Rle_trans _ _ _ (fst_le _) (B c ltac:(lra))) as F1. pose proof (Rle_trans _ _ _ (snd_le _) (B c' ltac:(lra))) as F2.
    replace (x t - x s)%C with (RtoC (fst (w c) * (t - s)) + RtoC (snd (w c') * (t - s)) * Ci)%C
      by (apply injective_projections; cbn; lra).
    eapply Rle_trans; [apply norm_triangle|]. unfold norm. rewrite Cmod_mult, !Cmod_R. replace (Cmod Ci) with 1.
    - rewrite !Rabs_mult, (Rabs_pos_eq (t - s)) by lra. pose proof (Rabs_pos (fst (w c))). pose proof (Rabs_pos (snd (w c'))).
      assert (Rabs (fst (w c)) * (t - s) <= e * (b - a)) by (apply Rmult_le_compat; lra).
      assert (Rabs (snd (w c')) * (t - s) <= e * (b - a)) by (apply Rmult_le_compat; lra). lra.
    - unfold Cmod, Ci; cbn. replace (0 * (0 * 1) + 1 * (1 * 1)) with 1 by ring. now rewrite sqrt_1. }
  intros s t Hs Ht. eapply Rle_trans; [apply norm_near|]. destruct (Rle_or_lt s t).
  - rewrite norm_sym. apply M; lra.
  - apply M; lra.
Qed.

(* ---- one edge: the virial <d, Y> ---- *)
Definition pull (d : C) : C := (RtoC (spring' (norm d) / norm d) * d)%C.
Lemma pull_virial d : d <> RtoC 0 -> inner d (pull d) = 2 * norm d ^ 2 - 2 / norm d ^ 2.
Proof.
  intros N. pose proof (norm_pos _ N). unfold pull. rewrite inner_scal, <- norm_sqr. unfold spring'. field. lra.
Qed.
Lemma edge_near P h : 0 < P -> 0 < h <= 1 -> exists e, 0 < e /\ forall (a : R) (d w Y : R -> C),
  (forall t, a <= t <= a + P -> is_velocity d t (w t) /\ norm (w t) <= e /\ norm (Y t) <= 3 * e /\
     continuity_pt (fun s => fst (Y s)) t /\ continuity_pt (fun s => snd (Y s)) t) ->
  (forall t, a < t < a + P -> d t <> RtoC 0 /\ is_velocity Y t (- w t - pull (d t))%C) ->
  forall t, a <= t <= a + P -> Rabs (norm (d t) - 1) < h.
Proof.
  intros HP Hh. set (m := 1 + h / 2). set (m' := 1 - h / 2).
  assert (M : 1 < m) by (unfold m; lra). assert (M' : 0 < m' < 1) by (unfold m'; lra).
  assert (M2 : 0 < m' ^ 2 < 1) by (split; [apply pow_lt; lra|apply pow_lt_1_compat; [lra|lia]]). assert (M4 : 1 < m ^ 4) by (apply Rlt_pow_R1; [lra|lia]).
  set (c := Rmin (2 * (1 - / m ^ 4)) (2 * (/ m' ^ 2 - m' ^ 2))).
  assert (Hc : 0 < c).
  { unfold c. apply Rmin_glb_lt.
    - assert (/ m ^ 4 < 1); [|lra]. rewrite <- Rinv_1. apply Rinv_lt_contravar; lra.
    - assert (1 < / m' ^ 2); [|lra]. rewrite <- Rinv_1 at 1. apply Rinv_lt_contravar; lra. }
  pose proof (Rmin_l (2 * (1 - / m ^ 4)) (2 * (/ m' ^ 2 - m' ^ 2))) as C1. pose proof (Rmin_r (2 * (1 - / m ^ 4)) (2 * (/ m' ^ 2 - m' ^ 2))) as C2.
  fold c in C1, C2.
  set (e := Rmin 1 (Rmin (h / (4 * P)) (P * c / (2 * (12 + 4 * P))))).
  assert (P1 : 0 < P * c / (2 * (12 + 4 * P))) by (apply Rdiv_lt_0_compat; [now apply Rmult_lt_0_compat|lra]).
  assert (P2 : 0 < h / (4 * P)) by (apply Rdiv_lt_0_compat; lra).
  assert (He : 0 < e) by (unfold e; repeat apply Rmin_glb_lt; lra).
  assert (E1 : e <= 1) by apply Rmin_l. assert (E2 : 2 * e * P <= h / 2).
  { assert (e <= h / (4 * P)) by (unfold e; eapply Rle_trans; [apply Rmin_r|apply Rmin_l]).
    apply Rle_trans with (2 * (h / (4 * P)) * P); [apply Rmult_le_compat_r; lra|right; field; lra]. }
  assert (E3 : e * (12 + 4 * P) < P * c).
  { assert (e <= P * c / (2 * (12 + 4 * P))) by (unfold e; eapply Rle_trans; [apply Rmin_r|apply Rmin_r]).
    apply Rle_lt_trans with (P * c / (2 * (12 + 4 * P)) * (12 + 4 * P)); [apply Rmult_le_compat_r; lra|].
    replace (P * c / (2 * (12 + 4 * P)) * (12 + 4 * P)) with (P * c / 2) by (field; lra).
    assert (0 < P * c) by (now apply Rmult_lt_0_compat). lra. }
  exists e. split; [exact He|]. intros a d w Y H D.
  assert (Dr : forall s t, a <= s <= a + P -> a <= t <= a + P -> Rabs (norm (d s) - norm (d t)) <= h / 2).
  { intros s t Hs Ht. eapply Rle_trans; [apply (drift d w a (a + P) e); try assumption; intros; now apply H|].
    replace (a + P - a) with P by ring. exact E2. }
  assert (Bf : forall t, a <= t <= a + P -> Rabs (inner (d t) (Y t)) <= norm (d t) * (3 * e)).
  { intros t Ht. eapply Rle_trans; [apply inner_norms|]. apply Rmult_le_compat_l; [apply norm_ge0|]. now apply H. }
  destruct (MVT_inside (fun t => inner (d t) (Y t)) (fun t => inner (w t) (Y t) + inner (d t) (- w t - pull (d t))%C) a (a + P)) as [t1 [H1 E]]; [lra| | |].
  { intros t Ht. destruct (H t Ht) as (V & _ & _ & Y1 & Y2). destruct (velocity_continuous d t _ V) as [X1 X2].
    apply (continuity_pt_ext (fun s => fst (d s) * fst (Y s) + snd (d s) * snd (Y s))); [intros; now rewrite inner_xy|].
    apply continuity_pt_plus; now apply continuity_pt_mult. }
  { intros t Ht. apply D_inner; [apply H; lra|now apply D]. }
  destruct (D t1 H1) as [N _]. pose proof (norm_pos _ N) as S0.
  assert (I : inner (d t1) (- w t1 - pull (d t1))%C = - inner (d t1) (w t1) - (2 * norm (d t1) ^ 2 - 2 / norm (d t1) ^ 2)).
  { rewrite <- (pull_virial _ N), !inner_xy. cbn. ring. }
  rewrite I in E. replace (a + P - a) with P in E by ring.
  destruct (H t1 ltac:(lra)) as (_ & W1 & Y1 & _).
  pose proof (inner_norms (w t1) (Y t1)) as A1. pose proof (inner_norms (d t1) (w t1)) as A2.
  assert (A3 : norm (w t1) * norm (Y t1) <= e * (3 * e)) by (apply Rmult_le_compat; try apply norm_ge0; assumption).
  assert (A4 : norm (d t1) * norm (w t1) <= norm (d t1) * e) by (apply Rmult_le_compat_l; [apply norm_ge0|assumption]).
  apply Rabs_le_between in A1, A2.
  pose proof (Bf a ltac:(lra)) as Ba. pose proof (Bf (a + P) ltac:(lra)) as Bb. apply Rabs_le_between in Ba, Bb.
  pose proof (Dr a t1 ltac:(lra) ltac:(lra)) as Da. pose proof (Dr (a + P) t1 ltac:(lra) ltac:(lra)) as Db. apply Rabs_le_between in Da, Db.
  intros t Ht. pose proof (Dr t t1 Ht ltac:(lra)) as Dt. apply Rabs_le_between in Dt.
  set (s := norm (d t1)) in *. set (sa := norm (d a)) in *. set (sb := norm (d (a + P))) in *. set (st := norm (d t)) in *.
  set (fa := inner (d a) (Y a)) in *. set (fb := inner (d (a + P)) (Y (a + P))) in *.
  set (p := inner (w t1) (Y t1)) in *. set (q := inner (d t1) (w t1)) in *.
  assert (S2 : 0 < s ^ 2) by (apply pow_lt; exact S0).
  apply Rnot_le_lt. intros F. unfold Rabs in F. destruct (Rcase_abs (st - 1)) as [X|X].
  - assert (Ls : s <= m') by (unfold m'; lra).
    assert (Q1 : s ^ 2 <= m' ^ 2) by (apply pow_incr; lra).
    assert (Q2 : / m' ^ 2 <= / s ^ 2) by (apply Rinv_le_contravar; lra).
    assert (ee : e * e <= 1 * e) by (apply Rmult_le_compat_r; lra). assert (se : s * e <= 1 * e) by (apply Rmult_le_compat_r; unfold m' in Ls; lra).
    assert (G : c - 4 * e <= p + (- q - (2 * s ^ 2 - 2 / s ^ 2))) by (unfold Rdiv; lra).
    assert (sa * (3 * e) <= 1 * (3 * e)) by (apply Rmult_le_compat_r; unfold m' in *; lra).
    assert (sb * (3 * e) <= 1 * (3 * e)) by (apply Rmult_le_compat_r; unfold m' in *; lra).
    apply (Rmult_le_compat_r P) in G; lra.
  - assert (Ls : m <= s) by (unfold m; lra). assert (L1 : 1 <= s) by lra.
    assert (Q1 : m ^ 4 <= s ^ 4) by (apply pow_incr; lra).
    assert (Q2 : / s ^ 2 <= s ^ 2 * / m ^ 4).
    { apply (Rmult_le_reg_r (m ^ 4 * s ^ 2)); [apply Rmult_lt_0_compat; lra|].
      replace (/ s ^ 2 * (m ^ 4 * s ^ 2)) with (m ^ 4) by (field; lra). replace (s ^ 2 * / m ^ 4 * (m ^ 4 * s ^ 2)) with (s ^ 4) by (field; lra). exact Q1. }
    assert (G1 : c * s ^ 2 <= 2 * (1 - / m ^ 4) * s ^ 2) by (apply Rmult_le_compat_r; lra).
    assert (G2 : c * s <= c * s ^ 2).
    { apply Rmult_le_compat_l; [lra|]. replace (s ^ 2) with (s * s) by ring. rewrite <- (Rmult_1_l s) at 1. apply Rmult_le_compat_r; lra. }
    assert (ee : e * e <= s * e) by (apply Rmult_le_compat_r; lra).
    assert (G : p + (- q - (2 * s ^ 2 - 2 / s ^ 2)) <= s * (4 * e - c)) by (unfold Rdiv; lra).
    assert (sa * (3 * e) <= (2 * s) * (3 * e)) by (apply Rmult_le_compat_r; lra).
    assert (sb * (3 * e) <= (2 * s) * (3 * e)) by (apply Rmult_le_compat_r; lra).
    apply (Rmult_le_compat_r P) in G; [|lra].
    assert (0 < s * (P * c - e * (12 + 4 * P))) by (apply Rmult_lt_0_compat; lra). lra.
Qed.

(* ---- the path: the mean velocity of one side of an edge, relative to the mean of all ---- *)
Definition share (i j : nat) : R := (if Nat.leb j i then 1 else 0) - (INR i + 1) / 4.
Definition side_velocity (u : nat -> R -> C) (i : nat) (t : R) : C := Csum 4 (fun j => RtoC (share i j) * u j t)%C.
Notation control q u i := (control4 4 first (fun _ _ => spring') q u i).

Lemma side_acceleration (q u : nat -> C) i : (i < 3)%nat ->
  Csum 4 (fun j => RtoC (share i j) * control q u j)%C = (- (u i - u (i + 1)%nat) - pull (q i - q (i + 1)%nat))%C.
Proof.
  intros Hi. change (pull (q i - q (i + 1)%nat)%C) with (grad spring' (q i) (q (i + 1)%nat)).
  unfold control4, grad_i, pair_grad, Csum, w. pose proof (grad_antisym spring') as A. revert A. generalize (grad spring'). intros g A.
  cbn [Sum first linked existsb Nat.eqb fst snd andb orb]. rewrite (A (q 0%nat) (q 1%nat)), (A (q 1%nat) (q 2%nat)), (A (q 2%nat) (q 3%nat)).
  destruct i as [|[|[|i]]]; [| | |lia]; unfold share; cbn [Nat.leb Nat.add INR]; clear A; apply injective_projections; cbn; field.
Qed.
Lemma side_velocity_le u t e i : (i < 3)%nat -> (forall j k, (j < 4)%nat -> (k < 4)%nat -> norm (u j t - u k t)%C <= e) -> norm (side_velocity u i t) <= 3 * e.
Proof.
  intros Hi B. assert (E : side_velocity u i t = Csum 4 (fun j => RtoC (share i j) * (u j t - u 0%nat t))%C).
  { unfold side_velocity, Csum, share. destruct i as [|[|[|i]]]; [| | |lia]; cbn [Sum Nat.leb INR]; apply injective_projections; cbn; field. }
  assert (0 <= e) by (eapply Rle_trans; [apply norm_ge0|apply (B 0%nat 0%nat); lia]).
  rewrite E. eapply Rle_trans; [apply norm_Csum|]. apply Rle_trans with (Sum 4 (fun j => 3 / 4 * e)); [|cbn [Sum]; lra].
  apply Sum_le; intros j Hj. rewrite norm_scal. apply Rmult_le_compat; [apply Rabs_pos|apply norm_ge0| |apply B; lia].
  unfold share. destruct i as [|[|[|i]]]; [| | |lia]; destruct j as [|[|[|[|j]]]]; try lia; cbn [Nat.leb INR]; apply Rabs_le; lra.
Qed.
Lemma velocity_Csum m (c : nat -> R) (x : nat -> R -> C) (y : nat -> C) t : (forall j, (j < m)%nat -> is_velocity (x j) t (y j)) ->
  is_velocity (fun s => Csum m (fun j => RtoC (c j) * x j s)%C) t (Csum m (fun j => RtoC (c j) * y j)%C).
Proof.
  intros H. split; unfold Csum; cbn [fst snd].
  - apply (D_Sum m (fun j s => fst (RtoC (c j) * x j s)%C) (fun j => fst (RtoC (c j) * y j)%C)). intros j Hj.
    apply (is_derive_ext (fun s => c j * fst (x j s))); [intros; cbn; Rring|]. eapply D_eq; [apply D_scal; exact (proj1 (H j Hj))|]. cbn. ring.
  - apply (D_Sum m (fun j s => snd (RtoC (c j) * x j s)%C) (fun j => snd (RtoC (c j) * y j)%C)). intros j Hj.
    apply (is_derive_ext (fun s => c j * snd (x j s))); [intros; cbn; Rring|]. eapply D_eq; [apply D_scal; exact (proj2 (H j Hj))|]. cbn. ring.
Qed.
Lemma continuity_Sum m (f : nat -> R -> R) t : (forall j, (j < m)%nat -> continuity_pt (f j) t) -> continuity_pt (fun s => Sum m (fun j => f j s)) t.
Proof.
  intros H. induction m as [|m IH]; cbn [Sum]; [apply continuity_pt_const; intros ? ?; reflexivity|].
  apply continuity_pt_plus; [apply IH; intros; apply H; lia|apply H; lia].
Qed.
Definition continuous_at (x : R -> C) (t : R) : Prop := continuity_pt (fun s => fst (x s)) t /\ continuity_pt (fun s => snd (x s)) t.
Lemma continuous_Csum m (c : nat -> R) (x : nat -> R -> C) t : (forall j, (j < m)%nat -> continuous_at (x j) t) ->
  continuous_at (fun s => Csum m (fun j => RtoC (c j) * x j s)%C) t.
Proof.
  intros H. split; unfold Csum; cbn [fst snd].
  - apply (continuity_Sum m (fun j s => fst (RtoC (c j) * x j s)%C)). intros j Hj.
    apply (continuity_pt_ext (fun s => c j * fst (x j s))); [intros; cbn; ring|]. apply continuity_pt_mult; [apply continuity_pt_const; intros ? ?; reflexivity|now apply H].
  - apply (continuity_Sum m (fun j s => snd (RtoC (c j) * x j s)%C)). intros j Hj.
    apply (continuity_pt_ext (fun s => c j * snd (x j s))); [intros; cbn; ring|]. apply continuity_pt_mult; [apply continuity_pt_const; intros ? ?; reflexivity|now apply H].
Qed.
Lemma path_near P h : 0 < P -> 0 < h <= 1 -> exists e, 0 < e /\ forall (a : R) (q u : nat -> R -> C),
  (forall t i, a <= t <= a + P -> (i < 4)%nat -> is_velocity (q i) t (u i t) /\ continuous_at (u i) t) ->
  (forall t i j, a <= t <= a + P -> (i < 4)%nat -> (j < 4)%nat -> norm (u i t - u j t)%C <= e) ->
  (forall t, a < t < a + P -> distinct 4 first (fun i => q i t) /\
     forall i, (i < 4)%nat -> is_velocity (u i) t (control (fun i => q i t) (fun i => u i t) i)) ->
  forall t i, a <= t <= a + P -> (i < 3)%nat -> Rabs (norm (q i t - q (i + 1)%nat t)%C - 1) < h.
Proof.
  intros HP Hh. destruct (edge_near P h HP Hh) as [e [He K]]. exists e. split; [exact He|]. intros a q u V B U t i Ht Hi.
  apply (K a (fun t => q i t - q (i + 1)%nat t)%C (fun t => u i t - u (i + 1)%nat t)%C (side_velocity u i)); [| |exact Ht].
  - intros s Hs. split; [apply velocity_minus; apply V; (lra || lia)|]. split; [apply B; (lra || lia)|].
    split; [apply side_velocity_le; [exact Hi|intros; now apply B]|]. apply (continuous_Csum 4 (share i) u). intros j Hj. now apply V.
  - intros s Hs. destruct (U s Hs) as [N A]. split.
    + intros E. assert (L : first i (i + 1)%nat = true) by (destruct i as [|[|[|i]]]; [reflexivity..|lia]).
      apply (N i (i + 1)%nat ltac:(lia) ltac:(lia) L). replace (q i s) with ((q i s - q (i + 1)%nat s) + q (i + 1)%nat s)%C by ring. rewrite E. ring.
    + rewrite <- (side_acceleration (fun i => q i s) (fun i => u i s) i Hi). apply (velocity_Csum 4 (share i) u). exact A.
Qed.

(* ---- the other path is the first one in the order 1, 3, 0, 2 ---- *)
Definition order2 (i : nat) : nat := match i with 0%nat => 1%nat | 1%nat => 3%nat | 2%nat => 0%nat | _ => 2%nat end.
Lemma second_control (q u : nat -> C) i : (i < 4)%nat ->
  control4 4 second (fun _ _ => spring') q u (order2 i) = control (fun i => q (order2 i)) (fun i => u (order2 i)) i.
Proof.
  intros Hi. unfold control4, grad_i, pair_grad, Csum, w. generalize (grad spring'). intros g.
  destruct i as [|[|[|[|i]]]]; [| | | |lia]; cbn [Sum first second linked order2 existsb Nat.eqb fst snd andb orb]; apply injective_projections; cbn; ring.
Qed.
Lemma second_distinct (q : nat -> C) : distinct 4 second q -> distinct 4 first (fun i => q (order2 i)).
Proof.
  intros N i j Hi Hj A. destruct i as [|[|[|[|i]]]]; try lia; destruct j as [|[|[|[|j]]]]; try lia; try discriminate A; now apply N; cbn; try lia.
Qed.

(* four points of the plane do not have all distances near 1 *)
Lemma no_four_near (x : nat -> C) : ~ forall i j, (i < 4)%nat -> (j < 4)%nat -> i <> j -> Rabs (norm (x i - x j)%C - 1) < / 100.
Proof.
  intros H. assert (G : forall i j, (i < 4)%nat -> (j < 4)%nat -> i <> j -> 0.98 <= inner (x i - x j)%C (x i - x j)%C <= 1.0201).
  { intros i j Hi Hj N. specialize (H i j Hi Hj N). apply Rabs_lt_between in H. rewrite <- norm_sqr. pose proof (norm_ge0 (x i - x j)%C). split; nra. }
  set (a := (x 1%nat - x 0%nat)%C). set (b := (x 2%nat - x 0%nat)%C). set (c := (x 3%nat - x 0%nat)%C).
  assert (A : 0.98 <= inner a a <= 1.0201) by (apply G; lia). assert (B : 0.98 <= inner b b <= 1.0201) by (apply G; lia).
  assert (D : 0.98 <= inner c c <= 1.0201) by (apply G; lia).
  assert (P : forall u v, inner (u - v)%C (u - v)%C = inner u u + inner v v - 2 * inner u v) by (intros; rewrite !inner_xy; cbn; ring).
  assert (AB : 0.46 <= inner a b <= 0.54).
  { pose proof (G 1%nat 2%nat ltac:(lia) ltac:(lia) ltac:(lia)) as E. replace (x 1%nat - x 2%nat)%C with (a - b)%C in E by (unfold a, b; ring). rewrite P in E. lra. }
  assert (AC : 0.46 <= inner a c <= 0.54).
  { pose proof (G 1%nat 3%nat ltac:(lia) ltac:(lia) ltac:(lia)) as E. replace (x 1%nat - x 3%nat)%C with (a - c)%C in E by (unfold a, c; ring). rewrite P in E. lra. }
  assert (BC : 0.46 <= inner b c <= 0.54).
  { pose proof (G 2%nat 3%nat ltac:(lia) ltac:(lia) ltac:(lia)) as E. replace (x 2%nat - x 3%nat)%C with (b - c)%C in E by (unfold b, c; ring). rewrite P in E. lra. }
  pose proof (gram a b c) as Z. clearbody a b c. clear G H P.
  assert (0 < inner a a * (inner b b * inner c c - inner b c * inner b c) - inner a b * (inner a b * inner c c - inner b c * inner a c) +
  inner a c * (inner a b * inner b c - inner b b * inner a c)) by (interval with (i_prec 60)). lra.
Qed.

(* ---- switching for ever ---- *)
Theorem paths_never_agree (P : R) (r v : nat -> R -> C) : 0 < P ->
  (forall t i, 0 < t -> (i < 4)%nat -> is_velocity (r i) t (v i t) /\ continuous_at (v i) t) ->
  (forall k t, INR k * P < t < (INR k + 1) * P -> distinct 4 (turn k) (fun i => r i t) /\
     forall i, (i < 4)%nat -> is_velocity (v i) t (control4 4 (turn k) (fun _ _ => spring') (fun i => r i t) (fun i => v i t) i)) ->
  ~ forall i j, (i < 4)%nat -> (j < 4)%nat -> forall e, 0 < e -> exists T, 0 <= T /\ forall t, T <= t -> norm (v i t - v j t)%C < e.
Proof.
  intros HP Mo La Ag. destruct (path_near P (/ 100) HP ltac:(lra)) as [e [He K]].
  destruct (uniform_pairs 4 (fun i j T => forall t, T <= t -> norm (v i t - v j t)%C < e)) as [T [HT U]].
  { intros i j T T' Q Le t Ht. apply Q. lra. }
  { intros i j Hi Hj. destruct (Ag i j Hi Hj e He) as [T [_ Q]]. now exists T. }
  destruct (nfloor_ex (T / P)) as [m [_ Hm]]; [left; now apply Rdiv_lt_0_compat|].
  set (k := (2 * (m + 1))%nat). assert (Kk : INR k = 2 * INR m + 2) by (unfold k; rewrite mult_INR, plus_INR; cbn; lra).
  assert (KT : T < INR k * P).
  { apply (Rmult_lt_compat_r P) in Hm; [|exact HP]. replace (T / P * P) with T in Hm by (field; lra).
    apply Rlt_le_trans with (1 := Hm). apply Rmult_le_compat_r; [lra|]. pose proof (pos_INR m). lra. }
  assert (KS : INR (Datatypes.S k) = INR k + 1) by apply S_INR.
  assert (T1 : turn k = first) by (unfold turn, k; rewrite Nat.even_mul; reflexivity).
  assert (T2 : turn (Datatypes.S k) = second) by (unfold turn, k; rewrite Nat.even_succ, <- Nat.negb_even, Nat.even_mul; reflexivity).
  assert (O : forall i, (i < 4)%nat -> (order2 i < 4)%nat) by (intros i Hi; destruct i as [|[|[|i]]]; cbn; lia).
  set (t := (INR k + 1) * P).
  assert (E1 : forall i, (i < 3)%nat -> Rabs (norm (r i t - r (i + 1)%nat t)%C - 1) < / 100).
  { intros i Hi. apply (K (INR k * P) r v); [| | |unfold t; lra|exact Hi].
    - intros s j Hs Hj. apply Mo; [lra|exact Hj].
    - intros s j l Hs Hj Hl. left. apply U; (lra || assumption).
    - intros s Hs. specialize (La k s). rewrite T1 in La. apply La. lra. }
  assert (E2 : forall i, (i < 3)%nat -> Rabs (norm (r (order2 i) t - r (order2 (i + 1)) t)%C - 1) < / 100).
  { intros i Hi. apply (K t (fun i => r (order2 i)) (fun i => v (order2 i))); [| | |lra|exact Hi]; unfold t.
    - intros s j Hs Hj. apply Mo; [lra|now apply O].
    - intros s j l Hs Hj Hl. left. apply U; [now apply O|now apply O|lra].
    - intros s Hs. specialize (La (Datatypes.S k) s). rewrite T2, KS in La. destruct La as [N A]; [lra|]. split; [now apply (second_distinct (fun i => r i s))|].
      intros i' Hi'. rewrite <- (second_control (fun i => r i s) (fun i => v i s) i' Hi'). now apply A, O. }
  apply (no_four_near (fun i => r i t)). intros i j Hi Hj N.
  pose proof (E1 0%nat ltac:(lia)) as D01. pose proof (E1 1%nat ltac:(lia)) as D12. pose proof (E1 2%nat ltac:(lia)) as D23.
  pose proof (E2 0%nat ltac:(lia)) as D13. pose proof (E2 1%nat ltac:(lia)) as D30. pose proof (E2 2%nat ltac:(lia)) as D02. cbn [order2 Nat.add] in *.
  destruct i as [|[|[|[|i]]]]; try lia; destruct j as [|[|[|[|j]]]]; try lia; try assumption; rewrite norm_sym; assumption.
Qed.
