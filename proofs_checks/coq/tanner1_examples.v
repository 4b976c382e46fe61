(* Tanner, Jadbabaie, Pappas, Part I: the printed statements that fail, each with an explicit motion. *)
From Coq Require Import Reals Lra Lia Psatz Relations.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums paley_model paley_phase paley_laplacian paley_gradient paley_particles tanner_energy tanner_flock tanner1_heading.
Open Scope R_scope.

(* agents (1) with the control (4), (5), the headings being those of the velocities: v_i = s_i e^{i theta_i}, s_i > 0 *)
Definition closed_loop (n : nat) (adj : graph) (V' : nat -> nat -> R -> R) (r : nat -> R -> C) (s th : nat -> R -> R) (t : R) : Prop :=
  forall i, (i < n)%nat -> 0 < s i t /\ ex_derive (s i) t /\ is_velocity (r i) t (RtoC (s i t) * expi (th i t))%C /\
    is_velocity (fun x => RtoC (s i x) * expi (th i x))%C t
      (accel n adj V' (fun j => r j t) (fun j => RtoC (s j t) * expi (th j t))%C (fun j => th j t) i).

Lemma accel_ext n adj V' r q v th i : (forall j, (j < n)%nat -> r j = q j) -> (i < n)%nat -> accel n adj V' r v th i = accel n adj V' q v th i.
Proof.
  intros E Hi. unfold accel, gyro, align, grad_i. f_equal.
  - f_equal. apply Csum_ext; intros j Hj. unfold pair_grad. now rewrite !E.
  - f_equal. f_equal. f_equal. apply Sum_ext; intros j Hj. now rewrite !E.
Qed.
Lemma example_loop : closed_loop 2 complete (fun _ _ => V2') rct sc thc 0.
Proof.
  intros i Hi. split; [|split; [|split]].
  - unfold sc. destruct i; lra.
  - unfold sc. destruct i; [eexists; apply D_const|eexists; apply D_plus; [apply D_const|apply D_scal, D_id]].
  - exact (rc_motion i).
  - rewrite (accel_ext 2 complete _ (fun j => rct j 0) rc) by (intros; auto using rct_0). exact (vc_motion i Hi).
Qed.
Lemma complete_S : undirected complete. Proof. apply complete_undirected. Qed.
Lemma PI8 : 0 < PI / 8 <= 1 / 2.
Proof. pose proof PI_RGT_0. pose proof PI_4. lra. Qed.

(* (7) as printed *)
Theorem eq7_printed_fails : ~ forall n adj V V' r s th dth t, undirected adj -> strongly_connected n adj ->
  (forall i j x, 0 < x -> is_derive (V i j) x (V' i j x)) -> (forall i j, V i j = V j i) ->
  closed_loop n adj V' r s th t -> (forall i, (i < n)%nat -> is_derive (th i) t (dth i)) ->
  forall i, (i < n)%nat -> dth i = - align n adj (fun j => r j t) (fun j => th j t) i.
Proof.
  intros H. assert (SC : strongly_connected 2 complete).
  { intros j k Hj Hk. destruct (Nat.eq_dec j k) as [->|N]; [apply rt_refl|]. apply rt_step. repeat split; try assumption.
    unfold complete. destruct (Nat.eqb_spec k j); [congruence|reflexivity]. }
  specialize (H 2%nat complete (fun _ _ => V2) (fun _ _ => V2') rct sc thc dthc 0 complete_S SC (fun _ _ x Hx => V2_derive x Hx)
    (fun _ _ => eq_refl) example_loop (fun i _ => thc_rate i) 0%nat ltac:(lia)).
  assert (A : align 2 complete (fun j => rct j 0) (fun j => thc j 0) 0 = PI / 8).
  { rewrite <- (proj1 aligns). unfold align. apply Sum_ext; intros j _. now rewrite !rct_0. }
  rewrite A in H. unfold dthc in H. lra.
Qed.
(* the sum before (7): sum (r_i . v_i)(thetadot_i + ...) is 3/4 here *)
Theorem eq6b_printed_fails : ~ forall n adj V V' r s th dth t, undirected adj ->
  (forall i j x, 0 < x -> is_derive (V i j) x (V' i j x)) -> (forall i j, V i j = V j i) ->
  closed_loop n adj V' r s th t -> (forall i, (i < n)%nat -> is_derive (th i) t (dth i)) ->
  Sum n (fun i => inner (r i t) (RtoC (s i t) * expi (th i t))%C * (dth i + align n adj (fun j => r j t) (fun j => th j t) i)) = 0.
Proof.
  intros H. specialize (H 2%nat complete (fun _ _ => V2) (fun _ _ => V2') rct sc thc dthc 0 complete_S (fun _ _ x Hx => V2_derive x Hx)
    (fun _ _ => eq_refl) example_loop (fun i _ => thc_rate i)).
  assert (A : forall i, (i < 2)%nat -> align 2 complete (fun j => rct j 0) (fun j => thc j 0) i = align 2 complete rc (fun j => thc j 0) i).
  { intros i _. unfold align. apply Sum_ext; intros j _. now rewrite !rct_0. }
  cbn [Sum] in H. rewrite !A in H by lia. destruct aligns as [A0 A1]. rewrite A0, A1, !rct_0 in H.
  destruct vc_values as [V0 V1]. unfold vc in V0, V1. rewrite V0, V1 in H. rewrite !inner_xy in H. unfold rc, dthc in H. cbn in H. lra.
Qed.
(* V_t grows at the rate (pi/2)(3/4 - pi/8) > 0 here: neither the rate - theta^T L_w theta nor <= 0 *)
Definition Lw_form (n : nat) (adj : graph) (r : nat -> C) (th : nat -> R) : R := Sum n (fun i => th i * align n adj r th i).
Theorem Vt_grows : exists d, 0 < d /\
  is_derive (fun x => Vt 2 complete (fun _ _ => V2) (fun i => rct i x) (fun i => RtoC (sc i x) * expi (thc i x))%C (fun i => thc i x)) 0 d.
Proof.
  exists (Sum 2 (fun i => thc i 0 * dthc i)). split.
  - cbn [Sum]. unfold thc, dthc. rewrite !Rmult_0_r, !Rplus_0_r. pose proof PI8. nra.
  - apply (eq9_chain 2 complete (fun _ _ => V2) (fun _ _ => V2') rct vc thc dthc 0 complete_S (fun _ _ => eq_refl)).
    + intros i Hi. apply rc_motion.
    + intros i j Hi Hj A. rewrite !rct_0. destruct i as [|[|]], j as [|[|]]; try lia; try discriminate A; unfold rc; intros E; injection E; lra.
    + intros i j Hi Hj A. apply V2_derive. apply norm_neq. rewrite !rct_0.
      destruct i as [|[|]], j as [|[|]]; try lia; try discriminate A; unfold rc; intros E; injection E; lra.
    + intros i Hi. rewrite (accel_ext 2 complete _ (fun j => rct j 0) rc) by (intros; auto using rct_0). exact (vc_motion i Hi).
    + intros i Hi. apply thc_rate.
Qed.
Theorem eq9_printed_fails : ~ forall n adj V V' r s th t d, undirected adj ->
  (forall i j x, 0 < x -> is_derive (V i j) x (V' i j x)) -> (forall i j, V i j = V j i) -> closed_loop n adj V' r s th t ->
  (forall i, (i < n)%nat -> ex_derive (th i) t) ->
  is_derive (fun x => Vt n adj V (fun i => r i x) (fun i => RtoC (s i x) * expi (th i x))%C (fun i => th i x)) t d ->
  d = - Lw_form n adj (fun i => r i t) (fun i => th i t) /\ d <= 0.
Proof.
  intros H. destruct Vt_grows as [d [Hd D]].
  destruct (H 2%nat complete (fun _ _ => V2) (fun _ _ => V2') rct sc thc 0 d complete_S (fun _ _ x Hx => V2_derive x Hx)
    (fun _ _ => eq_refl) example_loop (fun i _ => ex_intro _ _ (thc_rate i)) D). lra.
Qed.

(* "any potential can be used": V = 0 is symmetric, and two agents on one line run into each other *)
Lemma velocity_const (a b : R) (t : R) : is_velocity (fun s : R => RtoC (a + b * s)) t (RtoC b).
Proof.
  split; cbn; [|apply D_const]. eapply D_eq; [apply D_plus; [apply D_const|apply D_scal, D_id]|ring].
Qed.
Lemma expi_0' : expi 0 = (1, 0). Proof. rewrite expi_0. reflexivity. Qed.
Lemma free_motion (a b : R) t : is_velocity (fun s => RtoC (a + b * s)) t (RtoC b * expi 0)%C.
Proof. rewrite expi_0, Cmult_1_r. apply velocity_const. Qed.
Lemma gyro_aligned n adj r v i : gyro n adj r v (fun _ => 0) i = RtoC 0.
Proof.
  unfold gyro, align. rewrite Sum_zero; [apply injective_projections; cbn; ring|]. intros j _. unfold Rdiv. ring.
Qed.
Lemma no_force n adj r i : grad_i n adj (fun _ _ _ => 0) r i = RtoC 0.
Proof. unfold grad_i. apply Csum_0. intros j _. unfold pair_grad, grad. apply injective_projections; unfold Rdiv; cbn; ring. Qed.
Lemma C0_plus : (- RtoC 0 + RtoC 0)%C = RtoC 0. Proof. apply injective_projections; cbn; ring. Qed.
Definition place (i : nat) (t : R) : R := match i with 0%nat => 0 + 2 * t | _ => 1 + 1 * t end.
Definition speed (i : nat) (t : R) : R := match i with 0%nat => 2 | _ => 1 end.
Theorem anyV_fails : (forall t, t <> 1 -> closed_loop 2 complete (fun _ _ _ => 0) (fun i t => RtoC (place i t)) speed (fun _ _ => 0) t) /\
  (forall s : R, is_derive (fun _ : R => 0) s 0) /\
  place 0 1 = place 1 1.
Proof.
  split; [|split; [intros; apply D_const|unfold place; ring]]. intros t _ i Hi. split; [unfold speed; destruct i; lra|]. split; [unfold speed; eexists; apply D_const|]. split.
  - unfold place, speed. destruct i; apply free_motion.
  - unfold accel. rewrite gyro_aligned, no_force, C0_plus. unfold speed. split; apply D_const.
Qed.

(* collisions of agents that are not linked leave V_t bounded: path 0 - 1 - 2, agents 0 and 2 meet *)
Definition path3 (k j : nat) : bool := (Nat.eqb k 1 && negb (Nat.eqb j 1)) || (Nat.eqb j 1 && negb (Nat.eqb k 1)).
Definition meet (e : R) (i : nat) : C := match i with 0%nat => RtoC 1 | 1%nat => RtoC 0 | _ => RtoC (1 + e) end.
Lemma norm_real a : norm (RtoC a) = Rabs a. Proof. apply Cmod_R. Qed.
Lemma RtoC_minus' a b : (RtoC a - RtoC b)%C = RtoC (a - b). Proof. apply injective_projections; cbn; ring. Qed.
Theorem collision_fails : ~ forall n adj v th, undirected adj -> strongly_connected n adj -> forall i j, (i < n)%nat -> (j < n)%nat -> i <> j ->
  forall c, exists d, 0 < d /\ forall r, (forall a b, (a < n)%nat -> (b < n)%nat -> adj a b = true -> r a <> r b) -> norm (r i - r j)%C < d -> c < Vt n adj (fun _ _ => V2) r v th.
Proof.
  intros H. assert (US : undirected path3) by (intros a b; unfold path3; destruct (Nat.eqb a 1), (Nat.eqb b 1); reflexivity).
  assert (SC : strongly_connected 3 path3).
  { assert (A : forall k, (k < 3)%nat -> clos_refl_trans nat (arc 3 path3) k 1%nat /\ clos_refl_trans nat (arc 3 path3) 1%nat k).
    { intros k Hk. destruct k as [|[|[|]]]; try lia; split; first [apply rt_refl|apply rt_step; repeat split; lia]. }
    intros a b Ha Hb. eapply rt_trans; [apply (A a Ha)|apply (A b Hb)]. }
  destruct (H 3%nat path3 (fun _ => RtoC 0) (fun _ => 0) US SC 0%nat 2%nat ltac:(lia) ltac:(lia) ltac:(lia) 2) as [d [Hd P]].
  specialize (P (meet 0)). unfold Vt, V_i in P. cbn [Sum] in P. unfold w, path3, meet in P. cbn [Nat.eqb negb andb orb] in P.
  rewrite !RtoC_minus', !norm_real in P. replace (1 - (1 + 0)) with 0 in P by ring. rewrite Rabs_R0 in P.
  replace (0 - 1) with (-1) in P by ring. replace (0 - (1 + 0)) with (-1) in P by ring. replace (1 + 0 - 0) with 1 in P by ring. replace (1 - 0) with 1 in P by ring.
  rewrite Rabs_m1, Rabs_R1 in P. destruct fig2_shape as [_ [_ [V1 _]]]. rewrite V1, !inner_xy in P. cbn in P. rewrite !Rmult_0_l in P.
  assert (X : 2 < / 2 * 4); [|lra]. eapply Rlt_le_trans; [apply P; [|exact Hd]|right; field].
  intros a b Ha Hb A. destruct a as [|[|[|]]], b as [|[|[|]]]; try lia; try discriminate A; intros E; injection E; lra.
Qed.

(* Proposition IV.3: a pair that keeps the heading 0 for ever oscillates without loss; the potential energy does not settle *)
Definition Vh (s : R) : R := (s - 2) ^ 2 + Rmax 0 (/ s - 1) ^ 2.
Definition Vh' (s : R) : R := 2 * (s - 2) - (if Rlt_dec s 1 then 2 * (/ s - 1) / s ^ 2 else 0).
Lemma Vh_derive s : 1 < s -> is_derive Vh s (Vh' s).
Proof.
  intros Hs. apply (is_derive_ext_loc (fun x => (x - 2) ^ 2)).
  - exists (mkposreal (s - 1) ltac:(lra)). intros y Hy. apply Rabs_lt_between in Hy. cbn in Hy. unfold minus, plus, opp in Hy; cbn in Hy.
    unfold Vh. rewrite Rmax_left; [Rring|]. assert (/ y < 1); [|lra]. rewrite <- Rinv_1. apply Rinv_lt_contravar; lra.
  - unfold Vh'. destruct (Rlt_dec s 1); [lra|]. eapply D_eq; [apply (D_sqr (fun x => x - 2)); apply D_minus; [apply D_id|apply D_const]|]. ring.
Qed.
Definition gap (t : R) : R := 2 + / 2 * cos (2 * t).
(* c is the speed of the centre *)
Definition swing (c : R) (i : nat) (t : R) : C := match i with 0%nat => RtoC (c * t + / 2 * gap t) | _ => RtoC (c * t - / 2 * gap t) end.
Definition swing_speed (c : R) (i : nat) (t : R) : R := match i with 0%nat => c - / 2 * sin (2 * t) | _ => c + / 2 * sin (2 * t) end.
Definition r_osc := swing 3.
Definition s_osc := swing_speed 3.
Lemma gap_range t : 3 / 2 <= gap t <= 5 / 2.
Proof. unfold gap. pose proof (COS_bound (2 * t)). lra. Qed.
Lemma D_cos2 t : is_derive (fun s => cos (2 * s)) t (- 2 * sin (2 * t)).
Proof. eapply D_eq; [apply (D_cos (fun s => 2 * s)), D_scal, D_id|]. ring. Qed.
Lemma D_sin2 t : is_derive (fun s => sin (2 * s)) t (2 * cos (2 * t)).
Proof. eapply D_eq; [apply (D_sin (fun s => 2 * s)), D_scal, D_id|]. ring. Qed.
Lemma D_gap t : is_derive gap t (- sin (2 * t)).
Proof. unfold gap. eapply D_eq; [apply D_plus; [apply D_const|apply D_scal, D_cos2]|]. field. Qed.
Lemma swing_loop c t : (forall i, 0 < swing_speed c i t) -> closed_loop 2 complete (fun _ _ => Vh') (swing c) (swing_speed c) (fun _ _ => 0) t.
Proof.
  intros P. pose proof (gap_range t) as G.
  assert (N : norm (swing c 0 t - swing c 1 t)%C = gap t /\ norm (swing c 1 t - swing c 0 t)%C = gap t).
  { assert (E : norm (swing c 0 t - swing c 1 t)%C = gap t).
    { unfold swing. rewrite RtoC_minus', norm_real. replace (c * t + / 2 * gap t - (c * t - / 2 * gap t)) with (gap t) by field. apply Rabs_pos_eq. lra. }
    split; [exact E|]. rewrite norm_sym. exact E. }
  destruct N as [N0 N1].
  assert (Vg : Vh' (gap t) = cos (2 * t)). { unfold Vh'. destruct (Rlt_dec (gap t) 1); [lra|]. unfold gap. field. }
  assert (Z : forall i, pair_grad complete (fun _ _ => Vh') (fun j => swing c j t) i i = RtoC 0).
  { intros i. unfold pair_grad, w, complete. rewrite Nat.eqb_refl. apply injective_projections; cbn [negb RtoC fst snd Cmult]; ring. }
  assert (F : grad_i 2 complete (fun _ _ => Vh') (fun j => swing c j t) 0 = RtoC (cos (2 * t)) /\ grad_i 2 complete (fun _ _ => Vh') (fun j => swing c j t) 1 = RtoC (- cos (2 * t))).
  { unfold grad_i, Csum. cbn [Sum]. rewrite !Z. unfold pair_grad, grad. rewrite N0, N1, Vg. unfold w, complete, swing.
    split; apply injective_projections; cbn; field; lra. }
  destruct F as [F0 F1]. intros i Hi. unfold accel. rewrite gyro_aligned. destruct i as [|[|]]; [| |lia].
  - split; [apply P|]. split; [unfold swing_speed; eexists; apply D_minus; [apply D_const|apply D_scal, D_sin2]|]. rewrite F0, expi_0. split.
    + rewrite Cmult_1_r. split; cbn; [|apply D_const]. eapply D_eq; [apply D_plus; [apply D_scal, D_id|apply D_scal, D_gap]|]. ring.
    + split; cbn [fst snd].
      * apply (is_derive_ext (fun x => c - / 2 * sin (2 * x))); [intros; cbn; try rewrite cos_0; Rring|].
        eapply D_eq; [apply D_minus; [apply D_const|apply D_scal, D_sin2]|]. cbn. field.
      * apply (is_derive_ext (fun _ : R => 0)); [intros; cbn; try rewrite sin_0; Rring|]. eapply D_eq; [apply D_const|]. cbn. ring.
  - split; [apply P|]. split; [unfold swing_speed; eexists; apply D_plus; [apply D_const|apply D_scal, D_sin2]|]. rewrite F1, expi_0. split.
    + rewrite Cmult_1_r. split; cbn; [|apply D_const]. eapply D_eq; [apply D_minus; [apply D_scal, D_id|apply D_scal, D_gap]|]. ring.
    + split; cbn [fst snd].
      * apply (is_derive_ext (fun x => c + / 2 * sin (2 * x))); [intros; cbn; try rewrite cos_0; Rring|].
        eapply D_eq; [apply D_plus; [apply D_const|apply D_scal, D_sin2]|]. cbn. field.
      * apply (is_derive_ext (fun _ : R => 0)); [intros; cbn; try rewrite sin_0; Rring|]. eapply D_eq; [apply D_const|]. cbn. ring.
Qed.
Lemma osc_loop t : closed_loop 2 complete (fun _ _ => Vh') r_osc s_osc (fun _ _ => 0) t.
Proof. apply swing_loop. intros i. pose proof (SIN_bound (2 * t)). unfold swing_speed. destruct i; lra. Qed.
(* the distance returns to 5/2 for ever, where V = 1/4; the minimum of V is 0, at distance 2 *)
Theorem propIV3b_fails : (forall t, closed_loop 2 complete (fun _ _ => Vh') r_osc s_osc (fun _ _ => 0) t) /\
  (forall s, 0 < s -> 0 <= Vh s /\ (Vh s = 0 <-> s = 2)) /\
  (forall s, 1 < s -> is_derive Vh s (Vh' s)) /\
  forall m : nat, norm (r_osc 0 (INR m * PI) - r_osc 1 (INR m * PI))%C = 5 / 2 /\ Vh (norm (r_osc 0 (INR m * PI) - r_osc 1 (INR m * PI))%C) = 1 / 4.
Proof.
  split; [exact osc_loop|]. split.
  - intros s Hs. unfold Vh. pose proof (pow2_ge_0 (s - 2)). pose proof (pow2_ge_0 (Rmax 0 (/ s - 1))). split; [lra|]. split; intros E.
    + nra.
    + subst. rewrite Rmax_left by lra. ring.
  - split; [exact Vh_derive|]. intros m. assert (E : norm (r_osc 0 (INR m * PI) - r_osc 1 (INR m * PI))%C = 5 / 2).
    { unfold r_osc, swing. rewrite RtoC_minus', norm_real. unfold gap. replace (2 * (INR m * PI)) with (0 + 2 * INR m * PI) by ring. rewrite cos_period, cos_0.
      replace (3 * (INR m * PI) + / 2 * (2 + / 2 * 1) - (3 * (INR m * PI) - / 2 * (2 + / 2 * 1))) with (5 / 2) by field. apply Rabs_pos_eq. lra. }
    split; [exact E|]. rewrite E. unfold Vh. rewrite Rmax_left; [field|]. assert (/ (5 / 2) = 2 / 5) by field. lra.
Qed.
