(* Tanner, Jadbabaie, Pappas, Part I: the heading of a double integrator.  With v_i = s_i e^{i theta_i}, s_i > 0, the
   true heading rate carries the turning of the potential force as well, so that (7), the sum before it and
   the rate of V_t fail; the gyroscopic force does no work; the potential of Figure 2; collisions and Proposition IV.3. *)
From Coq Require Import Reals Lra Lia Psatz.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums paley_model paley_phase paley_laplacian paley_gradient paley_particles tanner_energy tanner_flock.
Open Scope R_scope.

Definition align (n : nat) (adj : graph) (r : nat -> C) (th : nat -> R) (i : nat) : R :=
  Sum n (fun j => w adj i j * ((th i - th j) / norm (r i - r j)%C ^ 2)).
(* eq (5): a_theta_i, with zhat x v = i v *)
Definition gyro (n : nat) (adj : graph) (r v : nat -> C) (th : nat -> R) (i : nat) : C := (RtoC (- align n adj r th i) * (Ci * v i))%C.
(* eq (4) *)
Definition accel (n : nat) (adj : graph) (V' : nat -> nat -> R -> R) (r v : nat -> C) (th : nat -> R) (i : nat) : C :=
  (- grad_i n adj V' r i + gyro n adj r v th i)%C.

Theorem gyro_no_work n adj r v th i : inner (v i) (gyro n adj r v th i) = 0.
Proof. unfold gyro. rewrite inner_scal, inner_xy. cbn. ring. Qed.
Theorem gyro_kinetic n adj r th (v : nat -> R -> C) (f : C) t i :
  is_velocity (v i) t (f + gyro n adj r (fun i => v i t) th i)%C -> is_derive (fun s => / 2 * inner (v i s) (v i s)) t (inner (v i t) f).
Proof.
  intros H. eapply D_eq; [apply D_scal, (D_inner (v i) (v i) t _ _ H H)|]. rewrite (inner_sym (_ + _)%C), inner_plus.
  pose proof (gyro_no_work n adj r (fun i => v i t) th i) as Z. cbv beta in Z. rewrite Z. field.
Qed.

(* the heading of a moving agent: thetadot |v|^2 = v x a *)
Theorem heading_rate (s th : R -> R) (t ds dth : R) (a : C) : 0 < s t -> is_derive s t ds -> is_derive th t dth ->
  is_velocity (fun x => RtoC (s x) * expi (th x))%C t a -> dth = cross (RtoC (s t) * expi (th t))%C a / norm (RtoC (s t) * expi (th t))%C ^ 2.
Proof.
  intros Hs Ds Dt [A1 A2].
  assert (E1 : is_derive (fun x => fst (RtoC (s x) * expi (th x))%C) t (ds * cos (th t) - s t * sin (th t) * dth)).
  { apply (is_derive_ext (fun x => s x * cos (th x))); [intros; cbn; Rring|]. eapply D_eq; [exact (D_mult s (fun x => cos (th x)) t _ _ Ds (D_cos th t _ Dt))|]. cbv beta. ring. }
  assert (E2 : is_derive (fun x => snd (RtoC (s x) * expi (th x))%C) t (ds * sin (th t) + s t * cos (th t) * dth)).
  { apply (is_derive_ext (fun x => s x * sin (th x))); [intros; cbn; Rring|]. eapply D_eq; [exact (D_mult s (fun x => sin (th x)) t _ _ Ds (D_sin th t _ Dt))|]. cbv beta. ring. }
  apply is_derive_unique in A1, A2, E1, E2. rewrite A1 in E1. rewrite A2 in E2.
  assert (N : norm (RtoC (s t) * expi (th t))%C ^ 2 = s t ^ 2).
  { replace (norm (RtoC (s t) * expi (th t))%C ^ 2) with (norm (RtoC (s t) * expi (th t))%C * norm (RtoC (s t) * expi (th t))%C) by ring.
    rewrite norm_sqr, inner_xy. cbn. pose proof (sc2 (th t)). cbn in H. nra. }
  rewrite N. unfold cross. rewrite E1, E2. cbn. pose proof (sc2 (th t)) as SC. cbn in SC.
  apply (Rmult_eq_reg_r (s t * s t)); [|nra]. field_simplify; [|nra].
  transitivity (s t ^ 2 * dth * (sin (th t) * (sin (th t) * 1) + cos (th t) * (cos (th t) * 1))); [rewrite SC; ring|ring].
Qed.
(* the corrected (7): the potential turns the velocity too *)
Theorem eq7_corrected n adj (V' : nat -> nat -> R -> R) (r : nat -> C) (s th : nat -> R -> R) (ds dth : nat -> R) (t : R) i :
  0 < s i t -> is_derive (s i) t (ds i) -> is_derive (th i) t (dth i) ->
  is_velocity (fun x => RtoC (s i x) * expi (th i x))%C t (accel n adj V' r (fun j => RtoC (s j t) * expi (th j t))%C (fun j => th j t) i) ->
  dth i = - align n adj r (fun j => th j t) i
    - cross (RtoC (s i t) * expi (th i t))%C (grad_i n adj V' r i) / norm (RtoC (s i t) * expi (th i t))%C ^ 2.
Proof.
  intros Hs Ds Dt A. rewrite (heading_rate (s i) (th i) t (ds i) (dth i) _ Hs Ds Dt A).
  set (v := (RtoC (s i t) * expi (th i t))%C) in *.
  assert (N : 0 < norm v). { unfold v, norm. rewrite Cmod_mult, Cmod_expi, Cmod_R, Rabs_pos_eq; lra. }
  assert (X : cross v (accel n adj V' r (fun j => RtoC (s j t) * expi (th j t))%C (fun j => th j t) i) =
    - cross v (grad_i n adj V' r i) - align n adj r (fun j => th j t) i * (norm v * norm v)).
  { rewrite norm_sqr, inner_xy. unfold accel, gyro. fold v. unfold cross. generalize (grad_i n adj V' r i). intros q. cbn. ring. }
  rewrite X. field. lra.
Qed.

(* ---- the potential of Figure 2 ---- *)
Definition V2 (s : R) : R := / s ^ 2 + ln (s ^ 2).
Definition V2' (s : R) : R := 2 / s - 2 / s ^ 3.
Lemma V2_derive s : 0 < s -> is_derive V2 s (V2' s).
Proof.
  intros Hs. unfold V2, V2'. assert (0 < s ^ 2) by (apply pow_lt; lra). auto_derive.
  - repeat split; try lra; apply Rgt_not_eq; simpl in *; lra.
  - field. lra.
Qed.
Lemma V2'_sign s : 0 < s -> V2' s = 2 * (s - 1) * (s + 1) / s ^ 3.
Proof. intros Hs. unfold V2'. field. lra. Qed.
Theorem fig2_shape : (forall s t, 0 < s < t -> t <= 1 -> V2 t < V2 s) /\ (forall s t, 1 <= s < t -> V2 s < V2 t) /\
  V2 1 = 1 /\ (forall s, 0 < s -> s <> 1 -> 1 < V2 s).
Proof.
  assert (A : forall s t, 0 < s < t -> t <= 1 -> V2 t < V2 s).
  { intros s t Hs Ht. destruct (MVT_gen V2 s t V2') as [c [Hc E]].
    - intros x Hx. apply V2_derive. rewrite Rmin_left in Hx by lra. lra.
    - intros x Hx. rewrite Rmin_left in Hx by lra. apply continuity_pt_filterlim, (ex_derive_continuous V2). eexists. apply V2_derive. lra.
    - rewrite Rmin_left, Rmax_right in Hc by lra. destruct (Req_dec c 1) as [->|N].
      + (* c = 1 only at the end: use a midpoint *)
        destruct (MVT_le V2 V2' s ((s + t) / 2)) as [c1 [Hc1 E1]]; [lra|intros; apply V2_derive; lra|].
        destruct (MVT_le V2 V2' ((s + t) / 2) t) as [c2 [Hc2 E2]]; [lra|intros; apply V2_derive; lra|].
        rewrite V2'_sign in E1, E2 by lra.
        assert (P1 : 2 * (c1 - 1) * (c1 + 1) / c1 ^ 3 < 0).
        { assert (0 < / c1 ^ 3) by (apply Rinv_0_lt_compat, pow_lt; lra). unfold Rdiv. assert ((c1 - 1) * (c1 + 1) < 0) by nra. nra. }
        assert (P2 : 2 * (c2 - 1) * (c2 + 1) / c2 ^ 3 <= 0).
        { assert (0 < / c2 ^ 3) by (apply Rinv_0_lt_compat, pow_lt; lra). unfold Rdiv. assert ((c2 - 1) * (c2 + 1) <= 0) by nra. nra. }
        nra.
      + rewrite V2'_sign in E by lra. assert (P1 : 2 * (c - 1) * (c + 1) / c ^ 3 < 0); [|nra].
        assert (0 < / c ^ 3) by (apply Rinv_0_lt_compat, pow_lt; lra). unfold Rdiv. assert ((c - 1) * (c + 1) < 0) by nra. nra. }
  assert (B : forall s t, 1 <= s < t -> V2 s < V2 t).
  { intros s t Hs. destruct (MVT_le V2 V2' s ((s + t) / 2)) as [c1 [Hc1 E1]]; [lra|intros; apply V2_derive; lra|].
    destruct (MVT_le V2 V2' ((s + t) / 2) t) as [c2 [Hc2 E2]]; [lra|intros; apply V2_derive; lra|].
    rewrite V2'_sign in E1, E2 by lra.
    assert (P1 : 0 <= 2 * (c1 - 1) * (c1 + 1) / c1 ^ 3).
    { assert (0 < / c1 ^ 3) by (apply Rinv_0_lt_compat, pow_lt; lra). unfold Rdiv. assert (0 <= (c1 - 1) * (c1 + 1)) by nra. nra. }
    assert (P2 : 0 < 2 * (c2 - 1) * (c2 + 1) / c2 ^ 3).
    { assert (0 < / c2 ^ 3) by (apply Rinv_0_lt_compat, pow_lt; lra). unfold Rdiv. assert (0 < (c2 - 1) * (c2 + 1)) by nra. nra. }
    nra. }
  assert (O : V2 1 = 1) by (unfold V2; rewrite pow1, ln_1, Rinv_1; ring).
  split; [exact A|]. split; [exact B|]. split; [exact O|]. intros s Hs N. rewrite <- O at 1.
  destruct (Rtotal_order s 1) as [L|[L|L]]; [apply A; lra|contradiction|apply B; lra].
Qed.
Theorem Vmono_fails : ~ forall s t, 0 < s < t -> V2 s <= V2 t.
Proof. intros H. destruct fig2_shape as [A _]. specialize (H (1 / 2) 1 ltac:(lra)). specialize (A (1 / 2) 1 ltac:(lra) ltac:(lra)). lra. Qed.

(* ---- V_t and its rate ---- *)
Definition Vt (n : nat) (adj : graph) (V : nat -> nat -> R -> R) (r v : nat -> C) (th : nat -> R) : R :=
  / 2 * Sum n (fun i => V_i n adj V r i + inner (v i) (v i) + th i ^ 2).
Theorem Vt_ge0 n adj V r v th : (forall i j s, (i < n)%nat -> (j < n)%nat -> 0 < s -> 0 <= V i j s) ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> r i <> r j) -> 0 <= Vt n adj V r v th.
Proof.
  intros P NC. unfold Vt. apply Rmult_le_pos; [lra|]. apply Sum_ge0; intros i Hi. pose proof (inner_self_ge0 (v i)). pose proof (pow2_ge_0 (th i)).
  assert (0 <= V_i n adj V r i); [|lra]. apply Sum_ge0; intros j Hj. unfold w. destruct (adj i j) eqn:A; [|lra].
  rewrite Rmult_1_l. apply P; try assumption. now apply norm_neq, NC.
Qed.
(* the rate of V_t by the product rule, whatever the accelerations u_i and the rates of the headings are *)
Theorem Vt_rate n adj (V V' : nat -> nat -> R -> R) (r v : nat -> R -> C) (th : nat -> R -> R) (dth : nat -> R) (t : R) (u : nat -> C) : undirected adj -> (forall i j, V' i j = V' j i) ->
  (forall i, (i < n)%nat -> is_velocity (r i) t (v i t)) ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> r i t <> r j t) ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> is_derive (V i j) (norm (r i t - r j t)%C) (V' i j (norm (r i t - r j t)%C))) ->
  (forall i, (i < n)%nat -> is_velocity (v i) t (u i)) -> (forall i, (i < n)%nat -> is_derive (th i) t (dth i)) ->
  is_derive (fun s => Vt n adj V (fun i => r i s) (fun i => v i s) (fun i => th i s)) t
    (Sum n (fun i => inner (grad_i n adj V' (fun i => r i t) i) (v i t)) + Sum n (fun i => inner (v i t) (u i)) + Sum n (fun i => th i t * dth i)).
Proof.
  intros S VS HR HN HV HU HT.
  pose proof (energy_chain n (fun i j s => w adj i j * V i j (norm (r i s - r j s)%C)) (pair_grad adj V' (fun i => r i t)) v u t
    (linked_rate n adj V V' r v t HR HN HV) (fun i j _ _ => pair_grad_antisym adj V' S VS (fun i => r i t) i j) HU) as D.
  apply (is_derive_ext (fun s => / 2 * Sum n (fun i => V_i n adj V (fun i => r i s) i + inner (v i s) (v i s)) + / 2 * Sum n (fun i => th i s ^ 2))).
  { intros s. unfold Vt. rewrite (Sum_plus n (fun i => V_i n adj V (fun i => r i s) i + inner (v i s) (v i s)) (fun i => th i s ^ 2)). Rring. }
  eapply D_eq.
  - apply (D_plus (fun s => / 2 * Sum n (fun i => V_i n adj V (fun i => r i s) i + inner (v i s) (v i s)))
      (fun s => / 2 * Sum n (fun i => th i s ^ 2))); [exact D|]. apply D_scal. apply (D_Sum n (fun i s => th i s ^ 2) (fun i => 2 * th i t * dth i)). intros i Hi. now apply D_sqr, HT.
  - cbv beta. rewrite (Sum_ext n (fun i => 2 * th i t * dth i) (fun i => 2 * (th i t * dth i))) by (intros; ring). rewrite Sum_scal.
    rewrite (Sum_ext n (fun i => inner (grad_i n adj V' (fun i => r i t) i) (v i t)) (fun i => inner (v i t) (Csum n (pair_grad adj V' (fun i => r i t) i)))) by (intros; apply inner_sym).
    change (fun i => inner (v i t) (Csum n (fun j => pair_grad adj V' (fun i => r i t) i j))) with (fun i => inner (v i t) (Csum n (pair_grad adj V' (fun i => r i t) i))). field.
Qed.
(* eq (9): along (1), (4), (5) the rate of V_t is the sum of theta_i thetadot_i, whatever thetadot is *)
Theorem eq9_chain n adj (V V' : nat -> nat -> R -> R) (r v : nat -> R -> C) (th : nat -> R -> R) (dth : nat -> R) (t : R) : undirected adj -> (forall i j, V' i j = V' j i) ->
  (forall i, (i < n)%nat -> is_velocity (r i) t (v i t)) ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> r i t <> r j t) ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> is_derive (V i j) (norm (r i t - r j t)%C) (V' i j (norm (r i t - r j t)%C))) ->
  (forall i, (i < n)%nat -> is_velocity (v i) t (accel n adj V' (fun j => r j t) (fun j => v j t) (fun j => th j t) i)) ->
  (forall i, (i < n)%nat -> is_derive (th i) t (dth i)) ->
  is_derive (fun s => Vt n adj V (fun i => r i s) (fun i => v i s) (fun i => th i s)) t (Sum n (fun i => th i t * dth i)).
Proof.
  intros S VS HR HN HV HU HT. eapply D_eq; [exact (Vt_rate n adj V V' r v th dth t _ S VS HR HN HV HU HT)|].
  rewrite <- Sum_plus, Sum_zero; [ring|]. intros i _. cbv beta. rewrite (inner_sym (grad_i _ _ _ _ _)), <- inner_plus. unfold accel.
  set (g := gyro _ _ _ _ _ _). set (f := grad_i _ _ _ _ _). replace (f + (- f + g))%C with g by ring.
  exact (gyro_no_work n adj (fun j => r j t) (fun j => v j t) (fun j => th j t) i).
Qed.

(* ---- counterexample: two linked agents, r = (2,1), (0,1), v = (0,1), (1,0), headings pi/2, 0, potential of Figure 2 ---- *)
Definition rc (i : nat) : C := match i with 0%nat => (2, 1) | _ => (0, 1) end.
Definition thc (i : nat) (t : R) : R := match i with 0%nat => PI / 2 + (3 / 4 - PI / 8) * t | _ => PI / 8 * t end.
Definition dthc (i : nat) : R := match i with 0%nat => 3 / 4 - PI / 8 | _ => PI / 8 end.
Definition sc (i : nat) (t : R) : R := match i with 0%nat => 1 | _ => 1 + 3 / 4 * t end.
Definition vc (i : nat) (t : R) : C := (RtoC (sc i t) * expi (thc i t))%C.
Definition rct (i : nat) (t : R) : C := (rc i + RtoC t * vc i 0)%C.
Lemma norm_2 : norm (rc 0 - rc 1)%C = 2 /\ norm (rc 1 - rc 0)%C = 2.
Proof.
  assert (E : norm (rc 0 - rc 1)%C = 2).
  { unfold norm, Cmod, rc; cbn. replace ((2 + - 0) * ((2 + - 0) * 1) + (1 + - (1)) * ((1 + - (1)) * 1)) with (2 * 2) by ring. apply sqrt_square. lra. }
  split; [exact E|]. rewrite norm_sym. exact E.
Qed.
Lemma thc_rate i : is_derive (thc i) 0 (dthc i).
Proof. destruct i; cbn; [eapply D_eq; [apply D_plus; [apply D_const|apply D_scal, D_id]|ring]|eapply D_eq; [apply D_scal, D_id|ring]]. Qed.
Lemma vc_values : vc 0 0 = (0, 1) /\ vc 1 0 = (1, 0).
Proof.
  unfold vc, sc, thc. rewrite !Rmult_0_r, !Rplus_0_r. unfold expi. rewrite cos_PI2, sin_PI2, cos_0, sin_0.
  split; apply injective_projections; cbn; ring.
Qed.
Lemma rc_motion i : is_velocity (rct i) 0 (vc i 0).
Proof.
  unfold rct. generalize (vc i 0) (rc i). intros a b. split.
  - apply (is_derive_ext (fun s : R => fst b + fst a * s)); [intros; cbn; Rring|]. eapply D_eq; [apply D_plus; [apply D_const|apply D_scal, D_id]|]. ring.
  - apply (is_derive_ext (fun s : R => snd b + snd a * s)); [intros; cbn; Rring|]. eapply D_eq; [apply D_plus; [apply D_const|apply D_scal, D_id]|]. ring.
Qed.
Lemma rct_0 i : rct i 0 = rc i.
Proof. unfold rct. apply injective_projections; cbn; ring. Qed.
Lemma grads : grad_i 2 complete (fun _ _ => V2') rc 0 = (3 / 4, 0) /\ grad_i 2 complete (fun _ _ => V2') rc 1 = (- (3 / 4), 0).
Proof.
  destruct norm_2 as [A B]. assert (E : V2' 2 = 3 / 4) by (unfold V2'; field).
  assert (Z : forall i, pair_grad complete (fun _ _ => V2') rc i i = RtoC 0).
  { intros i. unfold pair_grad, w, complete. rewrite Nat.eqb_refl. apply injective_projections; cbn [negb RtoC fst snd Cmult]; ring. }
  unfold grad_i, Csum. cbn [Sum]. rewrite !Z. unfold pair_grad, grad. rewrite A, B, E. unfold w, complete, rc. split; apply injective_projections; cbn; field.
Qed.
Lemma aligns : align 2 complete rc (fun i => thc i 0) 0 = PI / 8 /\ align 2 complete rc (fun i => thc i 0) 1 = - (PI / 8).
Proof.
  destruct norm_2 as [A B]. unfold align. cbn [Sum]. rewrite A, B. unfold w, complete, thc. cbn [Nat.eqb negb].
  rewrite !(Rmult_0_l (_ / _)). split; field.
Qed.
Lemma accels : accel 2 complete (fun _ _ => V2') rc (fun i => vc i 0) (fun i => thc i 0) 0 = (- (3 / 4) + PI / 8, 0) /\
  accel 2 complete (fun _ _ => V2') rc (fun i => vc i 0) (fun i => thc i 0) 1 = (3 / 4, PI / 8).
Proof.
  destruct grads as [G0 G1]. destruct aligns as [A0 A1]. destruct vc_values as [V0 V1]. unfold accel, gyro. rewrite G0, G1, A0, A1, V0, V1.
  split; apply injective_projections; cbn; field.
Qed.
Lemma vc_motion i : (i < 2)%nat -> is_velocity (vc i) 0 (accel 2 complete (fun _ _ => V2') rc (fun i => vc i 0) (fun i => thc i 0) i).
Proof.
  intros Hi. destruct accels as [A0 A1].
  assert (DS : is_derive (sc i) 0 (match i with 0%nat => 0 | _ => 3 / 4 end)).
  { destruct i; cbn; [apply D_const|eapply D_eq; [apply D_plus; [apply D_const|apply D_scal, D_id]|ring]]. }
  assert (E1 : is_derive (fun x => fst (vc i x)) 0 ((match i with 0%nat => 0 | _ => 3 / 4 end) * cos (thc i 0) + sc i 0 * (- sin (thc i 0) * dthc i))).
  { apply (is_derive_ext (fun x => sc i x * cos (thc i x))); [intros; unfold vc; cbn; Rring|]. exact (D_mult (sc i) (fun x => cos (thc i x)) 0 _ _ DS (D_cos (thc i) 0 _ (thc_rate i))). }
  assert (E2 : is_derive (fun x => snd (vc i x)) 0 ((match i with 0%nat => 0 | _ => 3 / 4 end) * sin (thc i 0) + sc i 0 * (cos (thc i 0) * dthc i))).
  { apply (is_derive_ext (fun x => sc i x * sin (thc i x))); [intros; unfold vc; cbn; Rring|]. exact (D_mult (sc i) (fun x => sin (thc i x)) 0 _ _ DS (D_sin (thc i) 0 _ (thc_rate i))). }
  destruct i as [|[|]]; [rewrite A0|rewrite A1|lia]; split; cbn [fst snd]; (eapply D_eq; [exact E1|] || (eapply D_eq; [exact E2|]));
  unfold sc, thc, dthc; rewrite ?Rmult_0_r, ?Rplus_0_r, ?cos_PI2, ?sin_PI2, ?cos_0, ?sin_0; try field.
Qed.
