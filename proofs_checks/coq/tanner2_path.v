(* Tanner, Jadbabaie, Pappas, fixed connected graph: agents that are not linked.
     tanner2.noninter, tanner2.sec4.flocking.
   On the path 0 - 1 - 2 on a line, with V = (s - 2)^2/4 + max(0, 1/s - 1)^2, the law is linear near the distance 2: the distance of 0
   and 2 is e^(-t/2) cos(t/2), which is 1 at t = 0 and 0 at t = pi.  In the limit both are at the same place, and there is an
   equilibrium with both there. *)
From Coq Require Import Reals Lra Lia Psatz Relations.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums paley_model paley_phase paley_laplacian paley_gradient paley_particles tanner_energy tanner_flock tanner_nonsmooth
  tanner1_examples tanner2_examples.
Open Scope R_scope.
Ltac Rfield := match goal with |- @eq _ ?a ?b => change (@eq R a b); field end.

(* ---- the potential ---- *)
Lemma D_sqr_max y : is_derive (fun x => Rmax 0 x ^ 2) y (2 * Rmax 0 y).
Proof.
  destruct (Rtotal_order y 0) as [L|[E|G]].
  - rewrite Rmax_left by lra. apply (is_derive_ext_loc (fun _ => 0)).
    + exists (mkposreal (- y) ltac:(lra)). intros x Hx. apply Rabs_lt_between in Hx. cbn in Hx. unfold minus, plus, opp in Hx; cbn in Hx.
      rewrite Rmax_left by lra. Rring.
    + eapply D_eq; [apply D_const|ring].
  - subst. rewrite Rmax_left by lra. apply is_derive_Reals. intros e He. exists (mkposreal e He). intros h Nh Hh. cbn in Hh.
    rewrite Rplus_0_l, (Rmax_left 0 0) by lra. unfold Rmax. destruct (Rle_dec 0 h) as [P|P].
    + replace ((h ^ 2 - 0 ^ 2) / h - 2 * 0) with h by (field; exact Nh). exact Hh.
    + replace ((0 ^ 2 - 0 ^ 2) / h - 2 * 0) with 0 by (field; exact Nh). now rewrite Rabs_R0.
  - rewrite Rmax_right by lra. apply (is_derive_ext_loc (fun x => x ^ 2)).
    + exists (mkposreal y ltac:(lra)). intros x Hx. apply Rabs_lt_between in Hx. cbn in Hx. unfold minus, plus, opp in Hx; cbn in Hx.
      rewrite Rmax_right by lra. reflexivity.
    + eapply D_eq; [apply (D_sqr (fun x => x)), D_id|ring].
Qed.
Definition VP (s : R) : R := (s - 2) ^ 2 / 4 + Rmax 0 (/ s - 1) ^ 2.
Definition VP' (s : R) : R := (s - 2) / 2 - 2 * Rmax 0 (/ s - 1) / s ^ 2.
Lemma VP_derive s : 0 < s -> is_derive VP s (VP' s).
Proof.
  intros Hs. unfold VP, VP'. eapply D_eq.
  - apply D_plus.
    + apply (is_derive_ext (fun x => / 4 * (x - 2) ^ 2)); [intros x; Rfield|].
      apply D_scal, (D_sqr (fun x => x - 2)), D_minus; [apply D_id|apply D_const].
    + apply (D_comp (fun x => Rmax 0 x ^ 2) (fun x => / x - 1) s (2 * Rmax 0 (/ s - 1)) (- / s ^ 2)); [apply D_sqr_max|].
      auto_derive; [lra|]. field. lra.
  - field. lra.
Qed.

Lemma VP_potential : potential VP VP'.
Proof.
  apply (potential_of_bounds VP VP' 7); intros s Hs.
  - split; [now apply VP_derive|]. unfold VP. pose proof (pow2_ge_0 (s - 2)). pose proof (pow2_ge_0 (Rmax 0 (/ s - 1))). lra.
  - unfold VP. pose proof (pow2_ge_0 (s - 2)). pose proof (pow2_ge_0 (s - 4)). pose proof (pow2_ge_0 (Rmax 0 (/ s - 1))).
    pose proof (Rmax_r 0 (/ s - 1)). pose proof (Rmax_l 0 (/ s - 1)). pose proof (pow2_ge_0 (Rmax 0 (/ s - 1) - 1)). split; nra.
Qed.
Lemma VP_minimum s : 0 < s -> s <> 2 -> VP 2 < VP s.
Proof.
  intros Hs N. unfold VP. rewrite (Rmax_left 0 (/ 2 - 1)) by lra. assert (0 < (s - 2) ^ 2) by (apply pow2_gt_0; lra).
  pose proof (pow2_ge_0 (Rmax 0 (/ s - 1))). lra.
Qed.
Lemma VP'_continuous s : 0 < s -> continuity_pt VP' s.
Proof.
  intros Hs. apply continuity_pt_filterlim. unfold VP'.
  apply (continuous_minus (fun s => (s - 2) / 2) (fun s => 2 * Rmax 0 (/ s - 1) / s ^ 2)).
  - apply (ex_derive_continuous (fun s => (s - 2) / 2)). auto_derive. exact I.
  - apply (continuous_mult (fun s => 2 * Rmax 0 (/ s - 1)) (fun s => / s ^ 2)).
    + apply (continuous_mult (fun _ => 2) (fun s => Rmax 0 (/ s - 1))); [apply continuous_const|].
      apply (continuous_ext (fun s => (0 + (/ s - 1) + Rabs (0 - (/ s - 1))) / 2)).
      { intros x. unfold Rmax, Rabs. destruct (Rle_dec 0 (/ x - 1)), (Rcase_abs (0 - (/ x - 1))); lra. }
      apply (continuous_mult (fun s => 0 + (/ s - 1) + Rabs (0 - (/ s - 1))) (fun _ => / 2)); [|apply continuous_const].
      apply (continuous_plus (fun s => 0 + (/ s - 1)) (fun s => Rabs (0 - (/ s - 1)))).
      * apply (ex_derive_continuous (fun s => 0 + (/ s - 1))). auto_derive. lra.
      * apply (continuous_comp (fun s => 0 - (/ s - 1)) Rabs); [|apply continuous_Rabs].
        apply (ex_derive_continuous (fun s => 0 - (/ s - 1))). auto_derive. lra.
    + apply (ex_derive_continuous (fun s => / s ^ 2)). auto_derive. assert (0 < s ^ 2) by (apply pow_lt; lra). simpl in *. lra.
Qed.
Lemma VP'_linear s : 1 <= s -> VP' s = (s - 2) / 2.
Proof.
  intros Hs. unfold VP'. rewrite Rmax_left; [field; lra|]. assert (/ s <= / 1) by (apply Rinv_le_contravar; lra). rewrite Rinv_1 in H. lra.
Qed.

(* ---- the path ---- *)
Lemma path3_undirected : undirected path3.
Proof. intros a b. unfold path3. destruct (Nat.eqb a 1), (Nat.eqb b 1); reflexivity. Qed.
Lemma path3_no_loops : no_loops path3.
Proof. intros a. unfold path3. destruct (Nat.eqb a 1); reflexivity. Qed.
Lemma path3_connected : strongly_connected 3 path3.
Proof.
  assert (A : forall k, (k < 3)%nat -> clos_refl_trans nat (arc 3 path3) k 1%nat /\ clos_refl_trans nat (arc 3 path3) 1%nat k).
  { intros k Hk. destruct k as [|[|[|]]]; try lia; split; first [apply rt_refl|apply rt_step; repeat split; lia]. }
  intros a b Ha Hb. eapply rt_trans; [apply (A a Ha)|apply (A b Hb)].
Qed.
(* 1 stays at 0, the other two are at 2 + d/2 and 2 - d/2 *)
Definition place2 (d : R) (i : nat) : C := match i with 0%nat => RtoC (2 + d / 2) | 1%nat => RtoC 0 | _ => RtoC (2 - d / 2) end.
Definition speed2 (e : R) (i : nat) : C := match i with 0%nat => RtoC (e / 2) | 1%nat => RtoC 0 | _ => RtoC (- e / 2) end.
Lemma path_control d e i : -1 <= d <= 1 -> (i < 3)%nat ->
  control4 3 path3 (fun _ _ => VP') (place2 d) (speed2 e) i = speed2 (- e - d / 2) i.
Proof.
  intros Hd Hi.
  assert (N01 : norm (place2 d 0 - place2 d 1)%C = 2 + d / 2 /\ norm (place2 d 1 - place2 d 0)%C = 2 + d / 2).
  { unfold place2. rewrite !RtoC_minus', !norm_real. split; unfold Rabs; destruct (Rcase_abs _); lra. }
  assert (N12 : norm (place2 d 1 - place2 d 2)%C = 2 - d / 2 /\ norm (place2 d 2 - place2 d 1)%C = 2 - d / 2).
  { unfold place2. rewrite !RtoC_minus', !norm_real. split; unfold Rabs; destruct (Rcase_abs _); lra. }
  assert (F0 : VP' (2 + d / 2) = d / 4) by (rewrite VP'_linear by lra; field).
  assert (F2 : VP' (2 - d / 2) = - d / 4) by (rewrite VP'_linear by lra; field).
  destruct N01 as [A B], N12 as [A' B'].
  assert (Z : forall a b, path3 a b = false -> pair_grad path3 (fun _ _ => VP') (place2 d) a b = RtoC 0).
  { intros a b E. unfold pair_grad, w. rewrite E. apply injective_projections; cbn [RtoC fst snd Cmult]; ring. }
  unfold control4, grad_i, Csum. cbn [Sum].
  destruct i as [|[|[|]]]; try lia.
  - rewrite (Z 0%nat 0%nat), (Z 0%nat 2%nat) by reflexivity. unfold pair_grad, grad. rewrite A, F0.
    unfold w, path3, speed2, place2; apply injective_projections; cbn; field; lra.
  - rewrite (Z 1%nat 1%nat) by reflexivity. unfold pair_grad, grad. rewrite B, A', F0, F2.
    unfold w, path3, speed2, place2; apply injective_projections; cbn; field; lra.
  - rewrite (Z 2%nat 0%nat), (Z 2%nat 2%nat) by reflexivity. unfold pair_grad, grad. rewrite B', F2.
    unfold w, path3, speed2, place2; apply injective_projections; cbn; field; lra.
Qed.
Lemma path_solution (d e : R -> R) : (forall t, 0 <= t -> -1 <= d t <= 1) -> (forall t, is_derive d t (e t)) ->
  (forall t, is_derive e t (- e t - d t / 2)) ->
  solution 3 path3 (fun _ _ => VP) (fun _ _ => VP') (fun i t => place2 (d t) i) (fun i t => speed2 (e t) i).
Proof.
  intros Hd D E.
  split; [lia|]. split; [apply path3_undirected|]. split; [apply path3_no_loops|]. split; [apply path3_connected|].
  split; [reflexivity|]. split; [reflexivity|]. split; [intros; apply VP_potential|]. split; [intros; now apply VP'_continuous|].
  split. { intros t i j Ht Hi Hj A. specialize (Hd t Ht). unfold place2. destruct i as [|[|[|]]], j as [|[|[|]]]; try lia; try discriminate A; intros X; injection X; lra. }
  assert (H : forall (y : R -> R) a t, is_derive y t a -> is_derive (fun s => 2 + y s / 2) t (a / 2) /\ is_derive (fun s => 2 - y s / 2) t (- a / 2) /\
    is_derive (fun s => y s / 2) t (a / 2) /\ is_derive (fun s => - y s / 2) t (- a / 2)).
  { intros y a t Y. assert (Y2 : is_derive (fun s => y s / 2) t (a / 2)).
    { apply (is_derive_ext (fun s => / 2 * y s)); [intros; Rfield|]. eapply D_eq; [apply D_scal, Y|field]. }
    split; [eapply D_eq; [apply D_plus; [apply D_const|exact Y2]|ring]|]. split; [eapply D_eq; [apply D_minus; [apply D_const|exact Y2]|field]|].
    split; [exact Y2|]. apply (is_derive_ext (fun s => - (y s / 2))); [intros; Rfield|]. eapply D_eq; [apply D_opp, Y2|field]. }
  split.
  - intros t i _ Hi. destruct (H d (e t) t (D t)) as [P [M _]]. destruct i as [|[|[|]]]; try lia; split; cbn; try apply D_const; assumption.
  - intros t i Ht Hi. eapply velocity_eq; [|symmetry; apply path_control; [now apply Hd|exact Hi]].
    destruct (H e (- e t - d t / 2) t (E t)) as [_ [_ [P M]]]. destruct i as [|[|[|]]]; try lia; split; cbn; try apply D_const; assumption.
Qed.

Definition apart (t : R) : R := exp (- t / 2) * cos (t / 2).
Definition apart' (t : R) : R := - / 2 * exp (- t / 2) * (cos (t / 2) + sin (t / 2)).
Lemma apart_range t : 0 <= t -> -1 <= apart t <= 1.
Proof.
  intros Ht. unfold apart. pose proof (exp_pos (- t / 2)). pose proof (COS_bound (t / 2)).
  assert (exp (- t / 2) <= 1). { rewrite <- exp_0. destruct (Req_dec t 0) as [->|]; [right; f_equal; field|left; apply exp_increasing; lra]. }
  split; nra.
Qed.
(* the two agents that are not linked start 1 apart and meet at t = pi; all the hypotheses of Theorem 1 hold *)
Theorem unlinked_meet :
  solution 3 path3 (fun _ _ => VP) (fun _ _ => VP') (fun i t => place2 (apart t) i) (fun i t => speed2 (apart' t) i) /\
  (forall s, 0 < s -> s <> 2 -> VP 2 < VP s) /\ path3 0 2 = false /\
  norm (place2 (apart 0) 0 - place2 (apart 0) 2)%C = 1 /\ place2 (apart PI) 0 = place2 (apart PI) 2.
Proof.
  split; [apply path_solution; [exact apart_range| |]|split; [exact VP_minimum|split; [reflexivity|split]]].
  - intros t. unfold apart, apart'. auto_derive; [exact I|]. unfold Rdiv. generalize (exp (- t * / 2)), (cos (t * / 2)), (sin (t * / 2)). intros. Rfield.
  - intros t. unfold apart, apart'. auto_derive; [exact I|]. unfold Rdiv. generalize (exp (- t * / 2)), (cos (t * / 2)), (sin (t * / 2)). intros. Rfield.
  - unfold place2. rewrite RtoC_minus', norm_real. unfold apart. replace (- 0 / 2) with 0 by field. replace (0 / 2) with 0 by field.
    rewrite exp_0, cos_0. replace (2 + 1 * 1 / 2 - (2 - 1 * 1 / 2)) with 1 by field. apply Rabs_R1.
  - unfold place2, apart. rewrite cos_PI2, Rmult_0_r. f_equal. field.
Qed.
(* ... and there is an equilibrium with both at the same place for ever *)
Theorem unlinked_together :
  solution 3 path3 (fun _ _ => VP) (fun _ _ => VP') (fun i _ => place2 0 i) (fun i _ => speed2 0 i) /\
  (forall s, 0 < s -> s <> 2 -> VP 2 < VP s) /\ (forall i, speed2 0 i = RtoC 0) /\ place2 0 0 = place2 0 2.
Proof.
  split; [|split; [exact VP_minimum|split]].
  - apply (path_solution (fun _ => 0) (fun _ => 0)); [intros; lra|intros; apply D_const|intros; eapply D_eq; [apply D_const|field]].
  - intros [|[|i]]; unfold speed2; f_equal; field.
  - unfold place2. f_equal. field.
Qed.
