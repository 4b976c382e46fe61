(* Tanner, Jadbabaie, Pappas, both papers: rates along a motion that follow from the product rule and from the corrected (7).
     tanner1.eq6b, tanner1.eq9, tanner1.proof_cases, tanner1.proof_ratio (corrected), tanner1.eq9.chain, tanner1.Vt_inv, tanner1.Omega.bounded, tanner2.eq8. *)
From Coq Require Import Reals Lra Lia Psatz.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums paley_model paley_phase paley_laplacian paley_gradient paley_particles tanner_energy tanner_flock tanner_graph tanner1_heading tanner1_motion.
Open Scope R_scope.

Lemma parallel (z g : C) : 0 < inner z z -> cross z g = 0 -> g = (RtoC (inner z g / inner z z) * z)%C.
Proof.
  destruct z as [a b], g as [g1 g2]. unfold cross. rewrite !inner_xy. cbn [fst snd]. intros N X. assert (M : a * g2 = b * g1) by lra.
  assert (A : (a * g1 + b * g2) * a = g1 * (a * a + b * b)) by (transitivity (a * a * g1 + b * (a * g2)); [ring|rewrite M; ring]).
  assert (B : (a * g1 + b * g2) * b = g2 * (a * a + b * b)) by (transitivity (a * (b * g1) + b * b * g2); [ring|rewrite <- M; ring]).
  apply injective_projections; cbn [fst snd Cmult RtoC].
  - transitivity ((a * g1 + b * g2) * a * / (a * a + b * b)); [rewrite A; field; lra|field; lra].
  - transitivity ((a * g1 + b * g2) * b * / (a * a + b * b)); [rewrite B; field; lra|field; lra].
Qed.
Lemma ratios (z g : C) : cross z g = 0 -> fst z <> 0 -> fst g <> 0 -> snd g / fst g = snd z / fst z.
Proof.
  destruct z as [a b], g as [g1 g2]. unfold cross. cbn [fst snd]. intros X Nz Ng. apply (Rmult_eq_reg_r (a * g1)); [|now apply Rmult_integral_contrapositive_currified].
  replace (g2 / g1 * (a * g1)) with (a * g2) by (field; exact Ng). replace (b / a * (a * g1)) with (b * g1) by (field; exact Nz). lra.
Qed.
(* ---- agents that move: v_i = s_i e^{i theta_i}, s_i > 0, with differentiable headings, under (1), (4), (5) at time t ---- *)
Section Headings.
Variables (n : nat) (adj : graph) (V' : nat -> nat -> R -> R) (r : nat -> C) (s th : nat -> R -> R) (ds dth : nat -> R) (t : R).
Notation v := (fun i => RtoC (s i t) * expi (th i t))%C.
Hypothesis Moving : forall i, (i < n)%nat -> 0 < s i t.
Hypothesis Ds : forall i, (i < n)%nat -> is_derive (s i) t (ds i).
Hypothesis Dt : forall i, (i < n)%nat -> is_derive (th i) t (dth i).
Hypothesis Law : forall i, (i < n)%nat -> is_velocity (fun x => RtoC (s i x) * expi (th i x))%C t (accel n adj V' r v (fun j => th j t) i).

Lemma moving_norm i : (i < n)%nat -> 0 < norm (v i).
Proof. intros Hi. unfold norm. rewrite Cmod_mult, Cmod_expi, Cmod_R, Rmult_1_r. pose proof (Moving i Hi). apply Rabs_pos_lt. lra. Qed.
Lemma heading_of i : (i < n)%nat -> dth i = - align n adj r (fun j => th j t) i - cross (v i) (grad_i n adj V' r i) / norm (v i) ^ 2.
Proof. intros Hi. exact (eq7_corrected n adj V' r s th ds dth t i (Moving i Hi) (Ds i Hi) (Dt i Hi) (Law i Hi)). Qed.
(* the sum before (7), with the turning by the potential *)
Theorem eq6b_corrected : Sum n (fun i => inner (r i) (v i) *
  (dth i + align n adj r (fun j => th j t) i + cross (v i) (grad_i n adj V' r i) / norm (v i) ^ 2)) = 0.
Proof. apply Sum_zero. intros i Hi. rewrite (heading_of i Hi). ring. Qed.
(* equal headings that do not change: the potential forces are along the velocities, and they are all of the accelerations *)
Hypothesis Equal : forall i j, (i < n)%nat -> (j < n)%nat -> th i t = th j t.
Hypothesis Constant : forall i, (i < n)%nat -> dth i = 0.
Lemma no_alignment i : (i < n)%nat -> align n adj r (fun j => th j t) i = 0.
Proof. intros Hi. unfold align. apply Sum_zero. intros j Hj. rewrite (Equal i j Hi Hj). unfold Rdiv. ring. Qed.
Theorem equal_headings_forces i : (i < n)%nat -> cross (v i) (grad_i n adj V' r i) = 0 /\
  exists c : R, grad_i n adj V' r i = (RtoC c * v i)%C.
Proof.
  intros Hi. pose proof (heading_of i Hi) as E. rewrite (Constant i Hi), (no_alignment i Hi) in E. pose proof (moving_norm i Hi) as P.
  assert (X : cross (v i) (grad_i n adj V' r i) = 0).
  { apply (Rmult_eq_reg_r (/ norm (v i) ^ 2)); [|apply Rinv_neq_0_compat, pow_nonzero; lra]. unfold Rdiv in E. cbv beta in *. lra. }
  split; [exact X|]. exists (inner (v i) (grad_i n adj V' r i) / inner (v i) (v i)).
  apply parallel; [|exact X]. rewrite <- norm_sqr. now apply Rmult_lt_0_compat.
Qed.
Theorem equal_headings_ratios i : (i < n)%nat -> let a := accel n adj V' r v (fun j => th j t) i in let g := grad_i n adj V' r i in
  fst (v i) <> 0 -> fst a <> 0 -> fst g <> 0 -> snd a / fst a = snd (v i) / fst (v i) /\ snd g / fst g = snd (v i) / fst (v i).
Proof.
  intros Hi a g Nv Na Ng. destruct (equal_headings_forces i Hi) as [X _]. fold g in X.
  assert (A : a = (- g)%C).
  { unfold a, accel, gyro. rewrite (no_alignment i Hi). fold g. apply injective_projections; cbn [fst snd Cplus Copp Cmult RtoC]; ring. }
  rewrite A in Na |- *. split; [|now apply ratios]. replace (snd (- g)%C / fst (- g)%C) with (snd g / fst g) by (cbn; field; exact Ng). now apply ratios.
Qed.
End Headings.

(* ---- the rate of V_t ---- *)
(* (9) as it should be: L_w has the weights 1/|r_ij|^2 *)
Theorem eq9_corrected n adj (V V' : nat -> nat -> R -> R) (r : nat -> R -> C) (s th : nat -> R -> R) (ds dth : nat -> R) (t : R) :
  let v := fun i x => (RtoC (s i x) * expi (th i x))%C in undirected adj -> (forall i j, V' i j = V' j i) ->
  (forall i, (i < n)%nat -> is_velocity (r i) t (v i t)) -> (forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> r i t <> r j t) ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> is_derive (V i j) (norm (r i t - r j t)%C) (V' i j (norm (r i t - r j t)%C))) ->
  (forall i, (i < n)%nat -> 0 < s i t /\ is_derive (s i) t (ds i) /\ is_derive (th i) t (dth i)) ->
  (forall i, (i < n)%nat -> is_velocity (v i) t (accel n adj V' (fun j => r j t) (fun j => v j t) (fun j => th j t) i)) ->
  let Lw := lapw n (fun i j => w adj i j * / norm (r i t - r j t)%C ^ 2) in
  is_derive (fun x => Vt n adj V (fun i => r i x) (fun i => v i x) (fun i => th i x)) t
    (- Sum n (fun i => th i t * Sum n (fun j => Lw i j * th j t))
     - Sum n (fun i => th i t * (cross (v i t) (grad_i n adj V' (fun j => r j t) i) / norm (v i t) ^ 2))).
Proof.
  intros v S VS HR HN HV M HU Lw.
  assert (Ms : forall i, (i < n)%nat -> 0 < s i t) by (intros; now apply M).
  assert (D1 : forall i, (i < n)%nat -> is_derive (s i) t (ds i)) by (intros; now apply M).
  assert (D2 : forall i, (i < n)%nat -> is_derive (th i) t (dth i)) by (intros; now apply M).
  eapply D_eq; [exact (eq9_chain n adj V V' r v th dth t S VS HR HN HV HU D2)|].
  rewrite <- Sum_opp, <- Sum_minus. apply Sum_ext. intros i Hi. unfold Lw. rewrite (lapw_mul n _ i (fun j => th j t) Hi).
  rewrite (heading_of n adj V' (fun j => r j t) s th ds dth t Ms D1 D2 HU i Hi). fold (v i t). unfold align.
  rewrite (Sum_ext n (fun j => w adj i j * ((th i t - th j t) / norm (r i t - r j t)%C ^ 2)) (fun j => w adj i j * / norm (r i t - r j t)%C ^ 2 * (th i t - th j t)))
    by (intros; unfold Rdiv; ring). ring.
Qed.

(* ---- sublevel sets of the mechanical energy, whatever rates of turning the law takes ---- *)
Theorem sublevel_invariant n adj (V V' : nat -> nat -> R -> R) (r v : nat -> R -> C) (q : nat -> R -> R) J c t : undirected adj -> (forall i j, V' i j = V' j i) -> 0 <= t ->
  (forall x, 0 <= x <= t -> turning n adj V' r v q J x /\ distinct n adj (fun i => r i x) /\
    forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> is_derive (V i j) (norm (r i x - r j x)%C) (V' i j (norm (r i x - r j x)%C))) ->
  (mechanical n adj V (fun i => r i 0) (fun i => v i 0) <= c <-> mechanical n adj V (fun i => r i t) (fun i => v i t) <= c).
Proof. intros S VS Ht H. pose proof (turning_constant n adj V V' r v q S VS J t Ht H) as E. cbv beta in E. rewrite E. reflexivity. Qed.

(* ---- the first equation of (8): the product rule; Vdot_i is whatever the rate of V_i is ---- *)
Theorem eq8_product n adj (V V' : nat -> nat -> R -> R) (r v : nat -> R -> C) (dV : nat -> R) (t : R) :
  (forall i, (i < n)%nat -> is_derive (fun x => V_i n adj V (fun j => r j x) i) t (dV i)) ->
  (forall i, (i < n)%nat -> is_velocity (v i) t (control4 n adj V' (fun j => r j t) (fun j => v j t) i)) ->
  is_derive (fun x => Wenergy n adj V (fun i => r i x) (fun i => v i x)) t (/ 2 * Sum n dV -
    Sum n (fun i => inner (v i t) (Csum n (fun j => RtoC (w adj i j) * (v i t - v j t)) + grad_i n adj V' (fun j => r j t) i)%C)).
Proof.
  intros HV HU. apply (is_derive_ext (fun x => / 2 * Sum n (fun i => V_i n adj V (fun j => r j x) i) + / 2 * Sum n (fun i => inner (v i x) (v i x)))).
  { intros x. unfold Wenergy. rewrite (Sum_plus n (fun i => V_i n adj V (fun j => r j x) i) (fun i => inner (v i x) (v i x))). Rring. }
  eapply D_eq.
  - apply D_plus; [|exact (kinetic_rate n v (control4 n adj V' (fun j => r j t) (fun j => v j t)) t HU)].
    apply D_scal. exact (D_Sum n (fun i x => V_i n adj V (fun j => r j x) i) dV t HV).
  - unfold Rminus. f_equal. rewrite <- Sum_opp. apply Sum_ext. intros i _. cbv beta. unfold control4.
    generalize (grad_i n adj V' (fun j => r j t) i) (Csum n (fun j => RtoC (w adj i j) * (v i t - v j t)))%C (v i t). intros g a b. rewrite !inner_xy. cbn. ring.
Qed.

(* ---- Omega = {V_t <= c} with the potential of Figure 2 is bounded ---- *)
Lemma V2_potential : potential V2 V2'.
Proof.
  assert (L : forall s, 0 < s -> ln (s ^ 2) = 2 * ln s) by (intros s Hs; rewrite ln_pow by exact Hs; cbn; ring).
  split; [|split].
  - intros s Hs. split; [now apply V2_derive|]. destruct fig2_shape as (_ & _ & O & G). destruct (Req_dec s 1) as [->|N]; [lra|]. pose proof (G s Hs N). lra.
  - intros c. exists (/ (2 + Rabs c)). pose proof (Rabs_pos c). pose proof (Rle_abs c). split; [apply Rinv_0_lt_compat; lra|]. intros s [Hs Hd].
    assert (X : 2 + Rabs c < / s). { rewrite <- (Rinv_inv (2 + Rabs c)). apply Rinv_lt_contravar; [|exact Hd]. apply Rmult_lt_0_compat; [exact Hs|apply Rinv_0_lt_compat; lra]. }
    assert (K : ln (/ s) <= / s - 1). { pose proof (exp_ineq1_le (ln (/ s))) as E. rewrite exp_ln in E by (apply Rinv_0_lt_compat; lra). lra. }
    rewrite ln_Rinv in K by exact Hs. unfold V2. rewrite (L s Hs). replace (/ s ^ 2) with (/ s * / s) by (field; lra). nra.
  - intros c. exists (exp (Rabs c)). intros s Hs. pose proof (exp_pos (Rabs c)). pose proof (Rle_abs c). pose proof (Rabs_pos c). assert (Ps : 0 < s) by lra.
    assert (K : Rabs c < ln s) by (rewrite <- (ln_exp (Rabs c)); now apply ln_increasing). unfold V2. rewrite (L s Ps).
    assert (0 < / s ^ 2) by (apply Rinv_0_lt_compat, pow_lt, Ps). lra.
Qed.
Theorem Omega_bounded n adj c : (1 <= n)%nat -> undirected adj -> no_loops adj -> strongly_connected n adj ->
  exists B, forall (r v : nat -> C) (th : nat -> R), distinct n adj r -> Vt n adj (fun _ _ => V2) r v th <= c ->
    (forall i j, (i < n)%nat -> (j < n)%nat -> norm (r i - r j)%C <= B) /\ forall i, (i < n)%nat -> norm (v i) <= sqrt (2 * c).
Proof.
  intros Hn S NL SC.
  assert (Pot : forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> potential ((fun _ _ => V2) i j) ((fun _ _ => V2') i j)) by (intros; apply V2_potential).
  destruct (all_distances n adj (fun _ _ => V2) (fun _ _ => V2') c Hn S NL SC (fun _ _ => eq_refl) Pot) as [B HB]. exists B. intros r v th D H.
  assert (W : Wenergy n adj (fun _ _ => V2) r v <= c).
  { apply Rle_trans with (2 := H). unfold Wenergy, Vt. apply Rmult_le_compat_l; [lra|]. apply Sum_le. intros i _. pose proof (pow2_ge_0 (th i)). lra. }
  split; [now apply (HB r v)|]. intros i Hi. now apply (speed_bound_norm n adj (fun _ _ => V2) (fun _ _ => V2') Pot r v D i c Hi).
Qed.
(* potentials that are not negative: W <= c bounds every speed *)
Theorem speeds_bounded n adj V (r v : nat -> C) c : (forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> 0 <= V i j (norm (r i - r j)%C)) ->
  Wenergy n adj V r v <= c -> forall i, (i < n)%nat -> inner (v i) (v i) <= 2 * c /\ norm (v i) <= sqrt (2 * c).
Proof.
  intros P H i Hi. assert (A : inner (v i) (v i) <= 2 * c); [|split; [exact A|rewrite norm_inner; now apply sqrt_le_1_alt]].
  assert (V0 : forall k, (k < n)%nat -> 0 <= V_i n adj V r k).
  { intros k Hk. apply Sum_ge0. intros j Hj. unfold w. destruct (adj k j) eqn:E; [rewrite Rmult_1_l; now apply P|lra]. }
  unfold Wenergy in H. pose proof (Sum_term_le n (fun k => V_i n adj V r k + inner (v k) (v k)) i (fun j Hj => Rplus_le_le_0_compat _ _ (V0 j Hj) (inner_self_ge0 (v j))) Hi) as T.
  cbv beta in T. specialize (V0 i Hi). lra.
Qed.
