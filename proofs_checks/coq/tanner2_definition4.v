(* Tanner, Jadbabaie, Pappas, links by distance: solutions of (10) after Definition 4, as curves in R^(4n) that are absolutely continuous and have a derivative in K of the
   whole vector field at almost all times.  They are the solutions of tanner2_filippov.v: positions have the velocities as derivatives at almost all times, and so, as
   these are continuous, at all; and K is the convex hull of the limits of the law (tanner2_field.v).  What is proved of those holds for these.
     tanner2.eq10_exist (corrected, clauses 1 and 2), tanner2.thm2_vel, tanner2.arbswitch (corrected, clause 1), tanner2.thm2_pot (corrected), tanner2.thm2_coll, tanner2.eq13. *)
From Coq Require Import Reals Lra Lia Psatz Classical.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums inclusions paley_model paley_phase paley_laplacian paley_gradient tanner_energy tanner_flock tanner2_filippov tanner2_limits tanner2_field.
From Flockproof Require tanner2_appendix tanner2_existence tanner2_solutions tanner2_onward tanner2_approach tanner2_unique tanner2_energies tanner2_facts.
Open Scope R_scope.

(* solutions after Definition 4 from a start in which no two agents coincide: until T, and for all t >= 0 *)
Definition solution_until T n V' R0 (x : R -> nat -> R) := apart_at n complete (place_of (x 0)) /\ tanner2_appendix.filippov (4 * n) (fun _ => field10 n V' R0) T x.
Definition solution_always n V' R0 (x : R -> nat -> R) := apart_at n complete (place_of (x 0)) /\ tanner2_existence.filippov_always (4 * n) (field10 n V' R0) x.

(* ---- solutions: in K positions have the velocities as derivatives, at almost all times and so, as these are continuous, at all ---- *)
Lemma primitive T (F g : R -> R) N : tanner2_appendix.ac_until T F -> tanner2_appendix.ac_until T g -> negligible N -> (forall t, 0 <= t < T -> ~ N t -> is_derive F t (g t)) ->
  forall t, 0 <= t < T -> is_derive (fun s => if Rlt_dec s 0 then F 0 + s * g 0 else F s) t (g t).
Proof.
  intros AF Ag HN D t Ht. set (b := (t + T) / 2). assert (Hb : t < b < T) by (unfold b; lra). pose proof (tanner2_appendix.stops T F b AF ltac:(lra)) as SF. pose proof (tanner2_appendix.stops T g b Ag ltac:(lra)) as Sg.
  assert (Near : forall e, 0 < e -> exists d, 0 < d /\ forall x y, 0 <= x < y -> y < b -> Rabs (x - t) < d -> Rabs (y - t) < d -> Rabs (F y - F x - (y - x) * g t) <= e * (y - x)).
  { intros e He. destruct (ac_near _ b e Sg ltac:(lra) He) as (d & Hd & L). exists d. split; [exact Hd|]. intros x y Hxy Hy Dx Dy. apply Rabs_def2 in Dx, Dy.
    assert (G : forall u, x <= u <= y -> Rabs (g u - g t) < e).
    { intros u Hu. destruct (Rle_or_lt u t) as [U|U]; [specialize (L u t ltac:(lra) ltac:(lra) ltac:(lra)); rewrite Rabs_minus_sym|specialize (L t u ltac:(lra) ltac:(lra) ltac:(lra))]; cbv beta in L; now rewrite !Rmin_left in L by lra. }
    assert (Up : F y <= F x + (g t + e) * (y - x)).
    { pose proof (ac_le _ N x y (g t + e) SF HN ltac:(lra)) as Q. cbv beta in Q. rewrite !Rmin_left in Q by lra. apply Q. intros u Hu Nu. exists (g u). specialize (G u Hu). apply Rabs_def2 in G.
      split; [|lra]. apply tanner2_appendix.D_stopped; [lra|]. apply D; [lra|exact Nu]. }
    assert (Lo : -1 * F y <= -1 * F x + (- g t + e) * (y - x)).
    { pose proof (ac_le _ N x y (- g t + e) (ac_scal (-1) _ SF) HN ltac:(lra)) as Q. cbv beta in Q. rewrite !Rmin_left in Q by lra. apply Q. intros u Hu Nu. exists (-1 * g u). specialize (G u Hu). apply Rabs_def2 in G.
      split; [|lra]. apply D_scal. apply tanner2_appendix.D_stopped; [lra|]. apply D; [lra|exact Nu]. }
    apply Rabs_le. lra. }
  assert (Quot : forall a h l e, 0 < h -> Rabs (a - h * l) <= e / 2 * h -> 0 < e -> Rabs (a / h - l) < e).
  { intros a h l e Hh Q He. replace (a / h - l) with ((a - h * l) / h) by (field; lra). unfold Rdiv. rewrite Rabs_mult, (Rabs_pos_eq (/ h)) by (left; now apply Rinv_0_lt_compat).
    apply Rle_lt_trans with (e / 2 * h * / h); [apply Rmult_le_compat_r; [left; now apply Rinv_0_lt_compat|exact Q]|]. rewrite Rmult_assoc, Rinv_r by lra. lra. }
  apply tanner2_appendix.rates_derivative; intros e He; destruct (Near (e / 2) ltac:(lra)) as (d & Hd & L).
  - exists (Rmin d (b - t)). pose proof (Rmin_l d (b - t)). pose proof (Rmin_r d (b - t)). split; [apply Rmin_glb_lt; lra|]. intros h Hh. destruct (Rlt_dec (t + 1 * h) 0); [lra|]. destruct (Rlt_dec t 0); [lra|].
    apply Quot; [lra| |exact He]. specialize (L t (t + 1 * h) ltac:(lra) ltac:(lra)). replace (t + 1 * h - t) with h in L by ring. apply L; [rewrite Rminus_eq_0, Rabs_R0; lra|rewrite Rabs_pos_eq; lra].
  - destruct (Req_dec t 0) as [->|Nt].
    + exists 1. split; [lra|]. intros h Hh. destruct (Rlt_dec (0 + -1 * h) 0); [|lra]. destruct (Rlt_dec 0 0); [lra|]. replace (_ / h - - g 0) with 0 by (field; lra). rewrite Rabs_R0. exact He.
    + exists (Rmin d t). pose proof (Rmin_l d t). pose proof (Rmin_r d t). split; [apply Rmin_glb_lt; lra|]. intros h Hh. destruct (Rlt_dec (t + -1 * h) 0); [lra|]. destruct (Rlt_dec t 0); [lra|].
      apply Quot; [lra| |exact He]. specialize (L (t + -1 * h) t ltac:(lra) ltac:(lra)). replace (t - (t + -1 * h)) with h in L by ring. rewrite <- Rabs_Ropp.
      replace (- (F (t + -1 * h) - F t - h * - g t)) with (F t - F (t + -1 * h) - h * g t) by ring. apply L; [|rewrite Rminus_eq_0, Rabs_R0; lra]. replace (t + -1 * h - t) with (- h) by ring. rewrite Rabs_Ropp, Rabs_pos_eq; lra.
Qed.
Lemma K_speeds n V' R0 x w i : K4 n V' R0 x w -> (i < n)%nat -> w (4 * i)%nat = x (4 * i + 2)%nat /\ w (4 * i + 1)%nat = x (4 * i + 3)%nat.
Proof.
  intros H Hi. assert (G : forall a b, (a < 4 * n)%nat -> (b < 4 * n)%nat -> (forall q, field10 n V' R0 q a = q b) -> w a = x b).
  { intros a b Ha Hb Q. apply cond_eq. intros e He. destruct (H (e / 2) (fun _ => False) ltac:(lra) (tanner2_existence.null_none (4 * n) ltac:(lia)) (e / 2) ltac:(lra)) as (m & c & y & C1 & C2 & C3).
    replace (w a - x b) with ((w a - Sum m (fun k => c k * y k a)) + Sum m (fun k => c k * (y k a - x b))).
    2: { rewrite (Sum_ext m (fun k => c k * (y k a - x b)) (fun k => c k * y k a - c k * x b)) by (intros; ring). rewrite Sum_minus, (Sum_scal_r m), C2. ring. }
    eapply Rle_lt_trans; [apply Rabs_triang|]. specialize (C3 a Ha). assert (B : Rabs (Sum m (fun k => c k * (y k a - x b))) <= e / 2); [|lra].
    eapply Rle_trans; [apply Sum_Rabs|]. apply Rle_trans with (Sum m (fun k => c k * (e / 2))); [|rewrite Sum_scal_r, C2; lra]. apply Sum_le. intros k Hk. destruct (C1 k Hk) as [C0 (q & N1 & _ & E)].
    rewrite Rabs_mult, (Rabs_pos_eq (c k)) by exact C0. apply Rmult_le_compat_l; [exact C0|]. rewrite (E a Ha), Q. left. now apply N1. }
  split; apply G; try lia; intros q; unfold field10; [rewrite (proj1 (at_agent _ _ i))|rewrite (proj1 (proj2 (at_agent _ _ i)))]; reflexivity.
Qed.
(* positions and velocities of the n agents; before 0 with the velocity at 0 *)
Definition place_at (x : R -> nat -> R) (i : nat) (t : R) : C := if Rlt_dec t 0 then (place_of (x 0) i + RtoC t * speed_of (x 0) i)%C else place_of (x t) i.
Definition speed_at (x : R -> nat -> R) (i : nat) (t : R) : C := if Rlt_dec t 0 then speed_of (x 0) i else speed_of (x t) i.
Lemma after_0 x t : 0 <= t -> (fun i => place_at x i t) = place_of (x t) /\ (fun i => speed_at x i t) = speed_of (x t).
Proof. intros H. split; apply FunctionalExtensionality.functional_extensionality; intros i; unfold place_at, speed_at; destruct (Rlt_dec t 0); try reflexivity; lra. Qed.
Lemma at_state (r v : nat -> R -> C) t : place_of (state (fun i => r i t) (fun i => v i t)) = (fun i => r i t) /\ speed_of (state (fun i => r i t) (fun i => v i t)) = (fun i => v i t).
Proof. split; apply FunctionalExtensionality.functional_extensionality; intros i; apply agents_of. Qed.
Section Solutions.
Variables (n : nat) (V V' : nat -> nat -> R -> R) (R0 : R).
Hypothesis HR : 0 < R0.
Hypothesis P : potentials n complete V V'.
Lemma velocities_until T x i t : tanner2_appendix.filippov (4 * n) (fun _ => field10 n V' R0) T x -> 0 <= t < T -> (i < n)%nat -> is_velocity (place_at x i) t (speed_at x i t).
Proof.
  intros (A & N & HN & F) Ht Hi. assert (D : forall a b, (a < 4 * n)%nat -> (b < 4 * n)%nat -> (forall s w, K4 n V' R0 (x s) w -> w a = x s b) ->
    is_derive (fun s => if Rlt_dec s 0 then x 0 a + s * x 0 b else x s a) t (x t b)).
  { intros a b Ha Hb Q. apply (primitive T (fun s => x s a) (fun s => x s b) N (A a Ha) (A b Hb) HN); [|exact Ht]. intros s Hs Ns. destruct (F s Hs Ns) as (w & Kw & Dw). rewrite <- (Q s w Kw). now apply Dw. }
  assert (E : speed_at x i t = speed_of (x t) i) by (unfold speed_at; destruct (Rlt_dec t 0); [lra|reflexivity]). rewrite E. split.
  - apply (is_derive_ext (fun s => if Rlt_dec s 0 then x 0 (4 * i)%nat + s * x 0 (4 * i + 2)%nat else x s (4 * i)%nat)); [|apply D; try lia; intros s w Kw; now apply (K_speeds n V' R0 (x s) w i Kw)].
    intros s. unfold place_at. destruct (Rlt_dec s 0); cbn; [ring|reflexivity].
  - apply (is_derive_ext (fun s => if Rlt_dec s 0 then x 0 (4 * i + 1)%nat + s * x 0 (4 * i + 3)%nat else x s (4 * i + 1)%nat)); [|apply D; try lia; intros s w Kw; now apply (K_speeds n V' R0 (x s) w i Kw)].
    intros s. unfold place_at. destruct (Rlt_dec s 0); cbn; [ring|reflexivity].
Qed.
Lemma law_of_K x t w : 0 < t -> apart_at n complete (fun i => place_at x i t) -> K4 n V' R0 (x t) w -> (forall j, (j < 4 * n)%nat -> is_derive (fun s => x s j) t (w j)) ->
  exists z, K10 n V' R0 (fun i => place_at x i t) (fun i => speed_at x i t) z /\ forall i, (i < n)%nat -> is_velocity (speed_at x i) t (z i).
Proof.
  intros Ht A Kw D. destruct (after_0 x t ltac:(lra)) as [E1 E2]. rewrite E1 in A. rewrite E1, E2.
  replace (x t) with (state (place_of (x t)) (speed_of (x t))) in Kw by (apply FunctionalExtensionality.functional_extensionality; intros j; apply state_of).
  apply (K_is_K10 n V V' R0 _ _ _ HR P A) in Kw. destruct Kw as (z & Kz & E). exists z. split; [exact Kz|]. intros i Hi. destruct (at_agent (speed_of (x t)) z i) as (_ & _ & Z2 & Z3).
  assert (G : forall a l, (a < 4 * n)%nat -> w a = l -> is_derive (fun s => if Rlt_dec s 0 then x 0 a else x s a) t l).
  { intros a l Ha <-. apply (is_derive_ext_loc (fun s => x s a)); [|now apply D]. exists (mkposreal t Ht). intros s Hs. change (Rabs (s - t) < t) in Hs. apply Rabs_def2 in Hs. destruct (Rlt_dec s 0); [lra|reflexivity]. }
  split; [apply (is_derive_ext (fun s => if Rlt_dec s 0 then x 0 (4 * i + 2)%nat else x s (4 * i + 2)%nat))|apply (is_derive_ext (fun s => if Rlt_dec s 0 then x 0 (4 * i + 3)%nat else x s (4 * i + 3)%nat))];
    try (intros s; unfold speed_at; destruct (Rlt_dec s 0); reflexivity); apply G; try lia; rewrite E by lia; assumption.
Qed.
Lemma negligible_and_0 N : negligible N -> negligible (fun t => N t \/ t = 0).
Proof. intros H. apply negligible_or; [exact H|]. apply tanner2_appendix.negligible_at. lra. Qed.
Lemma speeds_ac x i : tanner2_filippov.ac (fun t => x t (4 * i + 2)%nat) -> tanner2_filippov.ac (fun t => x t (4 * i + 3)%nat) -> absolutely_continuous (speed_at x i).
Proof.
  assert (G : forall (f : R -> R) c, tanner2_filippov.ac f -> tanner2_filippov.ac (fun t => if Rlt_dec t 0 then c else f t)).
  { intros f c A T e HT He. destruct (A T e HT He) as (d & Hd & Q). exists d. split; [exact Hd|]. intros m a b I O S. rewrite (Sum_ext m _ (fun k => Rabs (f (b k) - f (a k)))); [now apply Q|].
    intros k Hk. destruct (I k Hk). destruct (Rlt_dec (b k) 0), (Rlt_dec (a k) 0); try reflexivity; lra. }
  intros A2 A3. apply (G _ (x 0 (4 * i + 2)%nat)) in A2. apply (G _ (x 0 (4 * i + 3)%nat)) in A3. apply tanner2_onward.axes_ac.
  - intros T e HT He. destruct (A2 T e HT He) as (d & Hd & Q). exists d. split; [exact Hd|]. intros m a b I O S. eapply Rle_lt_trans; [|exact (Q m a b I O S)]. right. apply Sum_ext. intros k _. unfold speed_at.
    destruct (Rlt_dec (b k) 0), (Rlt_dec (a k) 0); reflexivity.
  - intros T e HT He. destruct (A3 T e HT He) as (d & Hd & Q). exists d. split; [exact Hd|]. intros m a b I O S. eapply Rle_lt_trans; [|exact (Q m a b I O S)]. right. apply Sum_ext. intros k _. unfold speed_at.
    destruct (Rlt_dec (b k) 0), (Rlt_dec (a k) 0); reflexivity.
Qed.
Lemma motion_until T x : solution_until T n V' R0 x -> motion10_until T n V' R0 (place_at x) (speed_at x).
Proof.
  intros [S0 Fi]. split; [rewrite (proj1 (after_0 x 0 (Rle_refl 0))); exact S0|]. split; [intros t i Ht Hi; now apply (velocities_until T)|]. destruct Fi as (A & N & HN & F). split.
  - intros i Hi T' e HT' He. assert (Ac : absolutely_continuous (speed_at (fun t => x (Rmin t T')) i)) by (apply speeds_ac; [apply (tanner2_appendix.stops T (fun t => x t (4 * i + 2)%nat) T')|apply (tanner2_appendix.stops T (fun t => x t (4 * i + 3)%nat) T')]; try apply A; lia || lra).
    destruct (Ac T' e ltac:(lra) He) as (d & Hd & Q). exists d. split; [exact Hd|]. intros m a b I O S. eapply Rle_lt_trans; [|exact (Q m a b I O S)]. right. apply Sum_ext. intros k Hk. destruct (I k Hk). unfold speed_at.
    destruct (Rlt_dec (b k) 0), (Rlt_dec (a k) 0); try lra. now rewrite !Rmin_left by lra.
  - exists (fun t => N t \/ t = 0). split; [now apply negligible_and_0|]. intros t Ht Nt At. destruct (F t Ht ltac:(tauto)) as (w & Kw & Dw). apply (law_of_K x t w); try assumption. assert (t <> 0) by tauto. lra.
Qed.
Lemma motion_always x : solution_always n V' R0 x -> motion10 n V' R0 (place_at x) (speed_at x).
Proof.
  intros [S0 (A & N & HN & F)]. assert (Fi : forall T, tanner2_appendix.filippov (4 * n) (fun _ => field10 n V' R0) T x).
  { intros T. split; [intros i Hi b e Hb He; now apply (A i Hi b e)|]. exists N. split; [exact HN|]. intros t Ht. now apply F. }
  split; [rewrite (proj1 (after_0 x 0 (Rle_refl 0))); exact S0|]. split; [intros t i Ht Hi; apply (velocities_until (t + 1)); [apply Fi|lra|exact Hi]|]. split.
  - intros i Hi. apply speeds_ac; apply A; lia.
  - exists (fun t => N t \/ t = 0). split; [now apply negligible_and_0|]. intros t Ht Nt At. destruct (F t Ht ltac:(tauto)) as (w & Kw & Dw). apply (law_of_K x t w); try assumption. assert (t <> 0) by tauto. lra.
Qed.
Lemma K_of_law (r v : nat -> R -> C) t z : apart_at n complete (fun i => r i t) -> K10 n V' R0 (fun i => r i t) (fun i => v i t) z -> (forall i, (i < n)%nat -> is_velocity (r i) t (v i t) /\ is_velocity (v i) t (z i)) ->
  exists w, K4 n V' R0 (state (fun i => r i t) (fun i => v i t)) w /\ forall j, (j < 4 * n)%nat -> is_derive (fun s => state (fun i => r i s) (fun i => v i s) j) t (w j).
Proof.
  intros A Kz D. exists (state (fun i => v i t) z). split; [apply (K_is_K10 n V V' R0 _ _ _ HR P A); now exists z|]. intros j Hj. assert (Hi : (j / 4 < n)%nat) by (apply Nat.div_lt_upper_bound; lia).
  destruct (D _ Hi) as [[D1 D2] [D3 D4]]. unfold state. destruct (j mod 4)%nat as [|[|[|]]]; assumption.
Qed.
Lemma coordinates_ac (r v : nat -> R -> C) during j : moves_while n V' R0 r v during -> (j < 4 * n)%nat -> tanner2_filippov.ac (fun t => state (fun i => r i t) (fun i => v i t) j).
Proof.
  intros W Hj. assert (Hi : (j / 4 < n)%nat) by (apply Nat.div_lt_upper_bound; lia). destruct (tanner2_unique.place_axes n V' R0 r v during _ W Hi) as [A1 A2]. destruct (v_axes n V' R0 r v during W _ Hi) as [A3 A4].
  unfold state. destruct (j mod 4)%nat as [|[|[|]]]; assumption.
Qed.
Lemma solution_of_until T r v : motion10_until T n V' R0 r v -> solution_until T n V' R0 (fun t => state (fun i => r i t) (fun i => v i t)).
Proof.
  intros M. split; [rewrite (proj1 (at_state r v 0)); apply M|]. split.
  - intros j Hj b e Hb He. destruct (straightened n V' R0 r v T b M ltac:(lra)) as (q & p & E & W). destruct (coordinates_ac q p _ j W Hj b e ltac:(lra) He) as (d & Hd & Q). exists d. split; [exact Hd|].
    intros m a c I O S. eapply Rle_lt_trans; [|exact (Q m a c I O S)]. right. apply Sum_ext. intros k Hk. destruct (I k Hk). f_equal.
    f_equal; apply (state_ext n); try exact Hj; intros i _; (destruct (E i (a k) ltac:(lra)), (E i (c k) ltac:(lra)); split; symmetry; assumption).
  - destruct (pairs_apart n V V' R0 r v HR P (proj1 M)) as (d & Hd & Far). pose proof (Far T M) as Fa. destruct M as (_ & Mv & _ & N & HN & F). exists N. split; [exact HN|]. intros t Ht Nt.
    assert (At : apart_at n complete (fun i => r i t)).
    { intros i j Hi Hj C0 E. assert (Ne : i <> j) by (intros ->; unfold complete in C0; now rewrite Nat.eqb_refl in C0). specialize (Fa t i j Ht Hi Hj Ne). rewrite E in Fa. replace (r j t - r j t)%C with (RtoC 0) in Fa by ring. rewrite Cmod_0 in Fa. lra. }
    destruct (F t Ht Nt At) as (z & Kz & Vz). apply (K_of_law r v t z At Kz). intros i Hi. split; [now apply Mv|now apply Vz].
Qed.
Lemma solution_of_always r v : motion10 n V' R0 r v -> solution_always n V' R0 (fun t => state (fun i => r i t) (fun i => v i t)).
Proof.
  intros M. split; [rewrite (proj1 (at_state r v 0)); apply M|]. split; [intros j Hj; exact (coordinates_ac r v _ j (always_moves n V' R0 r v M) Hj)|].
  destruct (kept_apart n V V' R0 r v HR P M) as (d & Hd & Fa). destruct M as (_ & Mv & _ & N & HN & F). exists N. split; [exact HN|]. intros t Ht Nt.
  assert (At : apart_at n complete (fun i => r i t)).
  { intros i j Hi Hj C0 E. assert (Ne : i <> j) by (intros ->; unfold complete in C0; now rewrite Nat.eqb_refl in C0). specialize (Fa t i j Ht Hi Hj Ne). rewrite E in Fa. replace (r j t - r j t)%C with (RtoC 0) in Fa by ring. rewrite Cmod_0 in Fa. lra. }
  destruct (F t Ht Nt At) as (z & Kz & Vz). apply (K_of_law r v t z At Kz). intros i Hi. split; [now apply Mv|now apply Vz].
Qed.
End Solutions.

(* ---- what holds for them ---- *)
Lemma same_places n x t : 0 <= t -> forall i, (i < n)%nat -> place_at x i t = place_of (x t) i /\ speed_at x i t = speed_of (x t) i.
Proof. intros Ht i _. unfold place_at, speed_at. destruct (Rlt_dec t 0); [lra|]. split; reflexivity. Qed.
(* from every start in which no two agents coincide one starts and lasts *)
Theorem solution_starts : forall n V V' R0 (q0 u0 : nat -> C), 0 < R0 -> potentials n complete V V' -> apart_at n complete q0 ->
  exists x, (forall i, (i < n)%nat -> place_of (x 0) i = q0 i /\ speed_of (x 0) i = u0 i) /\ solution_always n V' R0 x.
Proof.
  intros n V V' R0 q0 u0 HR P A. destruct (tanner2_solutions.solution_from n V V' R0 q0 u0 HR P A) as (r & v & S & M). exists (fun t => state (fun i => r i t) (fun i => v i t)).
  split; [|now apply (solution_of_always n V)]. intros i Hi. destruct (at_state r v 0) as [-> ->]. now apply S.
Qed.
(* every one until T goes on for all time *)
Lemma solution_goes_on : forall n V V' R0 T x, 0 < R0 -> 0 < T -> potentials n complete V V' -> solution_until T n V' R0 x ->
  exists y, (forall t j, 0 <= t < T -> (j < 4 * n)%nat -> y t j = x t j) /\ solution_always n V' R0 y.
Proof.
  intros n V V' R0 T x HR HT P Sx. destruct (proj2 (proj1 (tanner2_onward.all_solutions_agree n V V' R0 HR P)) T _ _ HT (motion_until n V V' R0 HR P T x Sx)) as (r & v & E & M).
  exists (fun t => state (fun i => r i t) (fun i => v i t)). split; [|now apply (solution_of_always n V)]. intros t j Ht Hj. transitivity (state (place_of (x t)) (speed_of (x t)) j); [|apply state_of].
  apply (state_ext n); [|exact Hj]. intros i Hi. destruct (E t i ltac:(lra)) as [-> ->]. apply (same_places n); [lra|exact Hi].
Qed.
(* one solution only, while no pair at the distance R turns there *)
Theorem solutions_unique : forall n V V' R0 T x y, 0 < R0 -> potentials n complete V V' -> tanner2_unique.lipschitz_gradients n V' ->
  solution_until T n V' R0 x -> solution_until T n V' R0 y -> (forall j, (j < 4 * n)%nat -> x 0 j = y 0 j) ->
  (forall t i j, 0 <= t < T -> (i < n)%nat -> (j < n)%nat -> i <> j -> Cmod (place_of (x t) i - place_of (x t) j)%C = R0 ->
    inner (place_of (x t) i - place_of (x t) j)%C (speed_of (x t) i - speed_of (x t) j)%C <> 0) ->
  forall t j, 0 <= t < T -> (j < 4 * n)%nat -> x t j = y t j.
Proof.
  intros n V V' R0 T x y HR P Lg Sx Sy E Ac t j Ht Hj.
  assert (Q : forall t i, 0 <= t < T -> (i < n)%nat -> place_at x i t = place_at y i t /\ speed_at x i t = speed_at y i t).
  { apply (tanner2_unique.unique_across n V V' R0 T); try assumption; [now apply (motion_until n V V' R0 HR P)|now apply (motion_until n V V' R0 HR P)| |].
    - intros i Hi. destruct (same_places n x 0 (Rle_refl 0) i Hi) as [-> ->], (same_places n y 0 (Rle_refl 0) i Hi) as [-> ->]. unfold place_of, speed_of. rewrite !E by lia. split; reflexivity.
    - intros s i k Hs Hi Hk Ne. destruct (same_places n x s ltac:(lra) i Hi) as [-> ->], (same_places n x s ltac:(lra) k Hk) as [-> ->]. now apply Ac. }
  rewrite <- (state_of (x t) j), <- (state_of (y t) j). apply (state_ext n); [|exact Hj]. intros i Hi. destruct (Q t i Ht Hi) as [Q1 Q2].
  destruct (same_places n x t ltac:(lra) i Hi) as [E1 E2], (same_places n y t ltac:(lra) i Hi) as [E3 E4]. now rewrite <- E1, <- E2, <- E3, <- E4.
Qed.
(* all pairs keep a distance *)
Theorem solutions_apart : forall n V V' R0 (x : R -> nat -> R), 0 < R0 -> potentials n complete V V' -> apart_at n complete (place_of (x 0)) ->
  exists d, 0 < d /\ forall T, solution_until T n V' R0 x -> forall t i j, 0 <= t < T -> (i < n)%nat -> (j < n)%nat -> i <> j -> d < Cmod (place_of (x t) i - place_of (x t) j)%C.
Proof.
  intros n V V' R0 x HR P A. destruct (pairs_apart n V V' R0 (place_at x) (speed_at x) HR P) as (d & Hd & F); [now rewrite (proj1 (after_0 x 0 (Rle_refl 0)))|]. exists d. split; [exact Hd|].
  intros T Sx t i j Ht Hi Hj Ne. specialize (F T (motion_until n V V' R0 HR P T x Sx) t i j Ht Hi Hj Ne). destruct (same_places n x t ltac:(lra) i Hi) as [E1 _], (same_places n x t ltac:(lra) j Hj) as [E2 _]. now rewrite E1, E2 in F.
Qed.
(* both: solutions start from every such state, and last *)
Definition solutions_last n V' R0 :=
  (forall q0 u0, apart_at n complete q0 -> exists x, (forall i, (i < n)%nat -> place_of (x 0) i = q0 i /\ speed_of (x 0) i = u0 i) /\ solution_always n V' R0 x) /\
  forall T x, 0 < T -> solution_until T n V' R0 x -> exists y, (forall t j, 0 <= t < T -> (j < 4 * n)%nat -> y t j = x t j) /\ solution_always n V' R0 y.
Lemma all_last n V V' R0 : 0 < R0 -> potentials n complete V V' -> solutions_last n V' R0.
Proof. intros HR P. split; [intros q0 u0 A; now apply (solution_starts n V)|intros T x HT Sx; now apply (solution_goes_on n V V')]. Qed.
Definition connected_always n R0 (x : R -> nat -> R) := forall t, 0 <= t -> strongly_connected n (by_distance (place_of (x t)) R0).
Lemma connected_places n R0 x : connected_always n R0 x -> forall t, 0 <= t -> strongly_connected n (by_distance (fun i => place_at x i t) R0).
Proof. intros H t Ht. rewrite (proj1 (after_0 x t Ht)). now apply H. Qed.
(* velocities agree in the limit *)
Theorem solutions_agree : forall n V V' R0, 0 < R0 -> potentials n complete V V' -> solutions_last n V' R0 /\
  forall x, solution_always n V' R0 x -> connected_always n R0 x -> forall i j, (i < n)%nat -> (j < n)%nat ->
    forall e, 0 < e -> exists T, forall t, T <= t -> Cmod (speed_of (x t) i - speed_of (x t) j)%C < e.
Proof.
  intros n V V' R0 HR P. split; [now apply (all_last n V)|]. intros x Sx Cx i j Hi Hj e He.
  destruct (proj2 (tanner2_onward.all_solutions_agree n V V' R0 HR P) _ _ (motion_always n V V' R0 HR P x Sx) (connected_places n R0 x Cx) i j Hi Hj e He) as [T H].
  exists (Rmax T 0). intros t Ht. pose proof (Rmax_l T 0). pose proof (Rmax_r T 0). specialize (H t ltac:(lra)).
  destruct (same_places n x t ltac:(lra) i Hi) as [_ E1], (same_places n x t ltac:(lra) j Hj) as [_ E2]. now rewrite E1, E2 in H.
Qed.
(* configurations approach those with 0 in K of the gradients of all agents together, K by the words of Definition 4 too *)
Definition critical4 n V' R0 (q : nat -> C) := apart_at n complete q /\ tanner2_appendix.K (2 * n) (gradient_field n V' R0) (tanner2_approach.flat n q) (fun _ => 0).
Lemma critical_is n V V' R0 q : 0 < R0 -> potentials n complete V V' -> critical4 n V' R0 q <-> tanner2_approach.critical n V' R0 q.
Proof.
  intros HR P. split; intros [A K]; (split; [exact A|]).
  - apply (K_is_K_gradients n V V' R0 q _ HR P A) in K. destruct K as (z & (m & c & y & Y1 & Y2 & Y3) & E). exists m, c, y. split; [exact Y1|]. split; [exact Y2|]. intros i Hi. rewrite <- Y3 by exact Hi.
    pose proof (E i ltac:(lia)) as E0. pose proof (E (n + i)%nat ltac:(lia)) as E1. unfold tanner2_approach.flat in E0, E1. destruct (Nat.ltb_spec i n); [|lia]. destruct (Nat.ltb_spec (n + i) n); [lia|].
    replace (n + i - n)%nat with i in E1 by lia. apply injective_projections; assumption.
  - apply (K_is_K_gradients n V V' R0 q _ HR P A). exists (fun _ => RtoC 0). split; [exact K|]. intros j Hj. unfold tanner2_approach.flat. destruct (Nat.ltb j n); reflexivity.
Qed.
Theorem solutions_approach : forall n V V' R0, 0 < R0 -> potentials n complete V V' -> solutions_last n V' R0 /\
  (forall x, solution_always n V' R0 x -> connected_always n R0 x ->
    forall e, 0 < e -> exists T, forall t, T <= t -> exists q, critical4 n V' R0 q /\ forall i, (i < n)%nat -> Cmod (place_of (x t) i - q i)%C < e) /\
  forall q, critical4 n V' R0 q -> generic n R0 q -> forall i, (i < n)%nat -> gradV n (by_distance q R0) V' q i = RtoC 0.
Proof.
  intros n V V' R0 HR P. destruct (tanner2_approach.all_solutions_approach n V V' R0 HR P) as (_ & H & G). split; [now apply (all_last n V)|split].
  - intros x Sx Cx e He. destruct (H _ _ (motion_always n V V' R0 HR P x Sx) (connected_places n R0 x Cx) e He) as [T Q]. exists (Rmax T 0). intros t Ht. pose proof (Rmax_l T 0). pose proof (Rmax_r T 0).
    destruct (Q t ltac:(lra)) as (q & Cq & D). exists q. split; [now apply (critical_is n V)|]. intros i Hi. specialize (D i Hi). destruct (same_places n x t ltac:(lra) i Hi) as [E _]. now rewrite E in D.
  - intros q Cq. apply G. now apply (critical_is n V).
Qed.
(* Q does not increase *)
Theorem solutions_lose_Q : forall n V V' R0 T x, 0 < R0 -> potentials n complete V V' -> solution_until T n V' R0 x -> forall a b, 0 <= a <= b -> b < T ->
  tanner2_facts.Qsat n V R0 (place_of (x b)) (speed_of (x b)) <= tanner2_facts.Qsat n V R0 (place_of (x a)) (speed_of (x a)).
Proof.
  intros n V V' R0 T x HR P Sx a b Hab Hb. pose proof (tanner2_energies.Q_falls n V V' R0 _ _ T HR P (motion_until n V V' R0 HR P T x Sx) a b Hab Hb) as Q.
  destruct (after_0 x a ltac:(lra)) as [E1 E2], (after_0 x b ltac:(lra)) as [E3 E4]. now rewrite E1, E2, E3, E4 in Q.
Qed.
(* (13), with K of the whole vector field in the generalised time derivative *)
Definition derivative13 n V' R0 (r v : nat -> C) x := forall a b, tanner2_energies.gradient_Q n V' R0 r v a b -> exists w, K4 n V' R0 (state r v) w /\
  x = Sum n (fun i => inner (a i) (place_of w i) + inner (b i) (speed_of w i)).
Theorem derivative_within : forall n V V' R0 (r v : nat -> C), 0 < R0 -> potentials n complete V V' -> apart_at n complete r ->
  forall x, derivative13 n V' R0 r v x -> tanner2_energies.hull13 n R0 r v (- x) /\ x <= 0.
Proof.
  intros n V V' R0 r v HR P A x D.
  assert (Q : tanner2_energies.derivative_Q n V' R0 r v x).
  { intros a b G. destruct (D a b G) as (w & Kw & E). apply (K_is_K10 n V V' R0 r v w HR P A) in Kw. destruct Kw as (z & Kz & W). exists z. split; [exact Kz|]. rewrite E. apply Sum_ext. intros i Hi.
    destruct (at_agent v z i) as (W0 & W1 & W2 & W3). unfold place_of, speed_of. rewrite !W by lia. now rewrite W0, W1, W2, W3, <- !surjective_pairing. }
  split; [now apply (tanner2_energies.eq13 n V V' R0 r v HR P A)|now apply (tanner2_energies.eq13_negative n V V' R0 r v HR P A)].
Qed.
