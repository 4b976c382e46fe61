(* Paley et al., the particle model (1), (2): energy, the circles of eq (3), the centres (18), the spacing potential
   (19), (20), the composite potential (21) with its sign, the controls (22), (29), (28), the limit set of Theorem 2. *)
From Coq Require Import Reals Lra Lia Psatz Relations.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums paley_model paley_phase paley_laplacian paley_gradient.
Open Scope R_scope.

Lemma velocity_expi (th : R -> R) t u : is_derive th t u -> is_velocity (fun s => expi (th s)) t (RtoC u * (Ci * expi (th t)))%C.
Proof.
  intros H. split; cbn [expi fst snd].
  - eapply D_eq; [apply D_cos, H|]. cbn. ring.
  - eapply D_eq; [apply D_sin, H|]. cbn. ring.
Qed.
Lemma velocity_eq (r : R -> C) t v w : is_velocity r t v -> v = w -> is_velocity r t w.
Proof. now intros H <-. Qed.

(* ---- kinetic energy ---- *)
Theorem energy (th : R -> R) t u : is_derive th t u ->
  is_velocity (fun s => expi (th s)) t (RtoC u * (Ci * expi (th t)))%C /\
  is_derive (fun s => / 2 * Cmod (expi (th s)) ^ 2) t (inner (expi (th t)) (RtoC u * (Ci * expi (th t)))%C) /\
  inner (expi (th t)) (RtoC u * (Ci * expi (th t)))%C = 0.
Proof.
  intros H. assert (Z : inner (expi (th t)) (RtoC u * (Ci * expi (th t)))%C = 0) by (rewrite inner_xy; cbn; ring).
  split; [now apply velocity_expi|]. split; [|exact Z]. rewrite Z.
  apply (is_derive_ext (fun _ => / 2 * 1 ^ 2)); [intros; now rewrite Cmod_expi|]. apply D_const.
Qed.
Theorem energy_total n (th : nat -> R -> R) (u : nat -> R) t : (forall k, (k < n)%nat -> is_derive (th k) t (u k)) ->
  is_derive (fun s => Sum n (fun k => / 2 * Cmod (expi (th k s)) ^ 2)) t 0.
Proof.
  intros H. eapply D_eq; [apply (D_Sum n (fun k s => / 2 * Cmod (expi (th k s)) ^ 2)
    (fun k => inner (expi (th k t)) (RtoC (u k) * (Ci * expi (th k t)))%C)); intros k Hk; now apply energy, H|].
  apply Sum_zero; intros k Hk. now apply (energy (th k) t (u k)), H.
Qed.

(* ---- eq (3): the centre of the circle, and (18) ---- *)
Definition circle_centre (w0 : R) (r : C) (th : R) : C := (r + RtoC (/ w0) * (Ci * expi th))%C.
Theorem eq18 w0 (r : R -> C) (th : R -> R) t u : is_velocity r t (expi (th t)) -> is_derive th t u ->
  is_velocity (fun s => circle_centre w0 (r s) (th s)) t (expi (th t) * RtoC (1 - / w0 * u))%C.
Proof.
  intros [R1 R2] H. unfold circle_centre. split.
  - apply (is_derive_ext (fun s => fst (r s) - / w0 * sin (th s))); [intros; cbn; ring|].
    eapply D_eq; [apply D_minus; [exact R1|apply D_scal, D_sin, H]|]. cbn. ring.
  - apply (is_derive_ext (fun s => snd (r s) + / w0 * cos (th s))); [intros; cbn; ring|].
    eapply D_eq; [apply D_plus; [exact R2|apply D_scal, D_cos, H]|]. cbn. ring.
Qed.
Lemma velocity_constant (c : R -> C) : (forall t, is_velocity c t (RtoC 0)) -> forall s t, c s = c t.
Proof. intros H s t. apply injective_projections; apply (constant (fun u => _ (c u))); intros u; apply (H u). Qed.
Theorem straight_line (r : R -> C) (th : R -> R) : (forall t, is_velocity r t (expi (th t))) -> (forall t, is_derive th t 0) ->
  forall t, th t = th 0 /\ r t = (r 0%R + RtoC t * expi (th 0))%C.
Proof.
  intros H1 H2 t. assert (T : forall t, th t = th 0) by (intros; apply (constant th H2)). split; [apply T|].
  assert (E : forall t, (r t - RtoC t * expi (th 0%R))%C = (r 0%R - RtoC 0 * expi (th 0%R))%C).
  { intros s. apply (velocity_constant (fun t => r t - RtoC t * expi (th 0%R))%C). clear t s. intros t. destruct (H1 t) as [A B].
    rewrite T in A, B. split.
    - apply (is_derive_ext (fun s => fst (r s) - cos (th 0) * s)); [intros; cbn; ring|].
      eapply D_eq; [apply D_minus; [exact A|apply D_scal, D_id]|]. cbn. ring.
    - apply (is_derive_ext (fun s => snd (r s) - sin (th 0) * s)); [intros; cbn; ring|].
      eapply D_eq; [apply D_minus; [exact B|apply D_scal, D_id]|]. cbn. ring. }
  specialize (E t). replace (r t) with ((r t - RtoC t * expi (th 0%R)) + RtoC t * expi (th 0%R))%C by ring. rewrite E.
  apply injective_projections; cbn; ring.
Qed.
(* u = w0: the centre (3) is fixed, the radius is 1/|w0|, and the angle about the centre grows at the rate w0 *)
Theorem circle w0 (r : R -> C) (th : R -> R) : w0 <> 0 ->
  (forall t, is_velocity r t (expi (th t))) -> (forall t, is_derive th t w0) ->
  (forall t, circle_centre w0 (r t) (th t) = circle_centre w0 (r 0) (th 0)) /\
  (forall t, Cmod (r t - circle_centre w0 (r t) (th t))%C = / Rabs w0) /\
  exists phi, forall t, (r t - circle_centre w0 (r t) (th t) = RtoC (/ Rabs w0) * expi (phi + w0 * t))%C.
Proof.
  intros Hw H1 H2.
  assert (A : 0 < Rabs w0) by now apply Rabs_pos_lt.
  assert (T : forall t, th t = th 0 + w0 * t).
  { intros t. assert (E : th t - w0 * t = th 0 - w0 * 0); [|lra].
    apply (constant (fun t => th t - w0 * t)). intros s. eapply D_eq; [apply D_minus; [apply H2|apply D_scal, D_id]|]. ring. }
  assert (P : exists phi, forall t, (r t - circle_centre w0 (r t) (th t) = RtoC (/ Rabs w0) * expi (phi + w0 * t))%C).
  { assert (X : forall t, (r t - circle_centre w0 (r t) (th t))%C = (/ w0 * sin (th t), - / w0 * cos (th t))).
    { intros t. unfold circle_centre. apply injective_projections; cbn; ring. }
    destruct (Rtotal_order w0 0) as [L|[L|L]]; [|contradiction|].
    - exists (th 0 + PI / 2). intros t. rewrite X, T, Rabs_left by assumption.
      replace (th 0 + PI / 2 + w0 * t) with (PI / 2 + (th 0 + w0 * t)) by ring.
      apply injective_projections; cbn.
      + rewrite cos_plus, cos_PI2, sin_PI2. field. lra.
      + rewrite sin_plus, cos_PI2, sin_PI2. field. lra.
    - exists (th 0 - PI / 2). intros t. rewrite X, T, Rabs_right by lra.
      replace (th 0 - PI / 2 + w0 * t) with ((th 0 + w0 * t) - PI / 2) by ring.
      apply injective_projections; cbn.
      + rewrite cos_minus, cos_PI2, sin_PI2. field. lra.
      + rewrite sin_minus, cos_PI2, sin_PI2. field. lra. }
  split; [|split].
  - intros t. apply (velocity_constant (fun s => circle_centre w0 (r s) (th s))). intros s.
    eapply velocity_eq; [apply eq18; [apply H1|apply H2]|]. apply injective_projections; cbn; field; lra.
  - destruct P as [phi P]. intros t. rewrite P, Cmod_mult, Cmod_expi, Cmod_R, Rabs_pos_eq; [ring|].
    left. now apply Rinv_0_lt_compat.
  - exact P.
Qed.

(* ---- quadratic forms along a curve ---- *)
Lemma D_inner (x y : R -> C) t u v : is_velocity x t u -> is_velocity y t v ->
  is_derive (fun s => inner (x s) (y s)) t (inner u (y t) + inner (x t) v).
Proof.
  intros [A1 A2] [B1 B2].
  apply (is_derive_ext (fun s => fst (x s) * fst (y s) + snd (x s) * snd (y s))); [intros; now rewrite inner_xy|].
  eapply D_eq; [apply D_plus; apply D_mult; eassumption|]. rewrite !inner_xy. ring.
Qed.
Lemma Q_along n A (x : nat -> R -> C) (v : nat -> C) t : (1 <= n)%nat -> (forall k j, A k j = A j k) ->
  (forall k, (k < n)%nat -> is_velocity (x k) t (v k)) ->
  is_derive (fun s => Q n A (fun k => x k s)) t (/ INR n * Sum n (fun k => inner (v k) (row n A k (fun k => x k t)))).
Proof.
  intros Hn S H. pose proof (INR_pos n Hn).
  apply (is_derive_ext (fun s => / (2 * INR n) * Sum n (fun k => Sum n (fun j => A k j * inner (x k s) (x j s))))).
  { intros s. unfold Q. f_equal. apply Sum_ext; intros k _. now rewrite inner_row. }
  eapply D_eq.
  - apply D_scal. apply (D_Sum n (fun k s => Sum n (fun j => A k j * inner (x k s) (x j s)))
      (fun k => Sum n (fun j => A k j * (inner (v k) (x j t) + inner (x k t) (v j))))). intros k Hk.
    apply (D_Sum n (fun j s => A k j * inner (x k s) (x j s)) (fun j => A k j * (inner (v k) (x j t) + inner (x k t) (v j)))).
    intros j Hj. apply D_scal, D_inner; now apply H.
  - rewrite (Sum_ext n _ (fun k => Sum n (fun j => A k j * inner (v k) (x j t)) + Sum n (fun j => A j k * inner (v j) (x k t)))).
    + rewrite Sum_plus, (Sum_swap n n (fun k j => A j k * inner (v j) (x k t))).
      rewrite (Sum_ext n (fun k => inner (v k) (row n A k (fun k => x k t))) (fun k => Sum n (fun j => A k j * inner (v k) (x j t))))
        by (intros; apply inner_row). field. lra.
    + intros k _. rewrite <- Sum_plus. apply Sum_ext; intros j _. rewrite (S j k), (inner_sym (x k t)). ring.
Qed.

(* ---- the spacing control ---- *)
Section Spacing.
Variables (n : nat) (adj : graph) (w0 K0 K1 : R).
Hypotheses (Hn : (1 <= n)%nat) (Hw : w0 <> 0) (S : undirected adj).
Definition centres (r : nat -> C) (th : nat -> R) (k : nat) : C := circle_centre w0 (r k) (th k).
Definition spacing (r : nat -> C) (th : nat -> R) : R := Q n (lap n adj) (centres r th).            (* (17) *)
Definition aS (r : nat -> C) (th : nat -> R) (k : nat) : R := inner (expi (th k)) (row n (lap n adj) k (centres r th)).
Variables (r : nat -> R -> C) (th : nat -> R -> R) (u : nat -> R) (t : R).
Hypothesis R1 : forall k, (k < n)%nat -> is_velocity (r k) t (expi (th k t)).
Hypothesis R2 : forall k, (k < n)%nat -> is_derive (th k) t (u k).
Notation rt := (fun k => r k t).
Notation tht := (fun k => th k t).

Theorem eq19 : is_derive (fun s => spacing (fun k => r k s) (fun k => th k s)) t
  (/ INR n * Sum n (fun k => aS rt tht k * (1 - / w0 * u k))).
Proof.
  eapply D_eq; [apply (Q_along n (lap n adj) (fun k s => circle_centre w0 (r k s) (th k s))
    (fun k => (expi (th k t) * RtoC (1 - / w0 * u k))%C) t Hn (lap_sym n adj S))|].
  - intros k Hk. apply eq18; [now apply R1|now apply R2].
  - f_equal. apply Sum_ext; intros k _. unfold aS, centres.
    set (z := row n (lap n adj) k _). rewrite (inner_sym (expi (th k t) * _)%C), (Cmult_comm (expi _)), inner_scal, (inner_sym z). ring.
Qed.
Theorem eq20 : (forall k, (k < n)%nat -> u k = w0 + w0 * (K0 / INR n * aS rt tht k)) ->
  is_derive (fun s => spacing (fun k => r k s) (fun k => th k s)) t (- (K0 / INR n ^ 2) * Sum n (fun k => aS rt tht k ^ 2)).
Proof.
  intros U. pose proof (INR_pos n Hn). eapply D_eq; [apply eq19|]. rewrite <- !Sum_scal. apply Sum_ext; intros k Hk.
  rewrite (U k Hk). field. split; lra.
Qed.
Corollary eq20_sign : 0 < K0 -> (forall k, (k < n)%nat -> u k = w0 + w0 * (K0 / INR n * aS rt tht k)) ->
  - (K0 / INR n ^ 2) * Sum n (fun k => aS rt tht k ^ 2) <= 0.
Proof.
  intros HK _. pose proof (INR_pos n Hn). assert (0 < K0 / INR n ^ 2) by (apply Rdiv_lt_0_compat; [lra|nra]).
  assert (0 <= Sum n (fun k => aS rt tht k ^ 2)) by (apply Sum_ge0; intros; apply pow2_ge_0). nra.
Qed.

(* (22): the control (5) with (14) and (20), on any graph *)
Definition control5 (k : nat) : R := w0 + K1 / INR n * gW n adj tht k + w0 * (K0 / INR n * aS rt tht k).
Theorem eq22 k : control5 k = w0 + (K1 - K0) / INR n * gW n adj tht k
   + w0 * (K0 / INR n) * inner (expi (th k t)) (row n (lap n adj) k rt).
Proof.
  pose proof (INR_pos n Hn). unfold control5, aS, gW. rewrite !inner_row.
  rewrite (Sum_ext n (fun j => lap n adj k j * inner (expi (th k t)) (centres rt tht j))
    (fun j => lap n adj k j * inner (expi (th k t)) (r j t) - / w0 * (lap n adj k j * inner (Ci * expi (th k t))%C (phasors tht j)))).
  - rewrite Sum_minus, Sum_scal. field. split; lra.
  - intros j _. unfold centres, circle_centre, phasors. rewrite !inner_xy. cbn. ring.
Qed.

(* (21): with V = K0 S - K1 w0^-2 W_1 the printed rate is right *)
Theorem eq21_corrected : (forall k, (k < n)%nat -> u k = control5 k) ->
  is_derive (fun s => K0 * spacing (fun k => r k s) (fun k => th k s) - K1 / w0 ^ 2 * W1 n adj (fun k => th k s)) t
    (- / INR n ^ 2 * Sum n (fun k => (K0 * aS rt tht k + K1 * / w0 * gW n adj tht k) ^ 2)).
Proof.
  intros U. pose proof (INR_pos n Hn).
  eapply D_eq; [apply D_minus; apply D_scal; [apply eq19|apply (W1_along n adj th u t Hn S R2)]|].
  pose proof (gW_sum n adj tht S) as G. set (a := aS rt tht) in *. set (b := gW n adj tht) in *.
  transitivity (/ INR n * Sum n (fun k => K0 * (a k * (1 - / w0 * u k)) - K1 / w0 ^ 2 * (u k * b k)) + K1 / w0 / INR n * Sum n b).
  - rewrite Sum_minus, !Sum_scal, G. ring.
  - rewrite <- !Sum_scal, <- Sum_plus. apply Sum_ext; intros k Hk. rewrite (U k Hk). unfold control5. fold a b. field. split; lra.
Qed.
(* the rate of the printed V = K0 S + K1 w0^-1 W_1 under the same control *)
Theorem eq21_actual : (forall k, (k < n)%nat -> u k = control5 k) ->
  is_derive (fun s => K0 * spacing (fun k => r k s) (fun k => th k s) + K1 * / w0 * W1 n adj (fun k => th k s)) t
    (- / INR n ^ 2 * Sum n (fun k => (K0 * aS rt tht k - K1 * gW n adj tht k) * (K0 * aS rt tht k + K1 * / w0 * gW n adj tht k))).
Proof.
  intros U. pose proof (INR_pos n Hn).
  eapply D_eq; [apply D_plus; apply D_scal; [apply eq19|apply (W1_along n adj th u t Hn S R2)]|].
  pose proof (gW_sum n adj tht S) as G. set (a := aS rt tht) in *. set (b := gW n adj tht) in *.
  transitivity (/ INR n * Sum n (fun k => K0 * (a k * (1 - / w0 * u k)) + K1 * / w0 * (u k * b k)) - K1 / INR n * Sum n b).
  - rewrite Sum_plus, !Sum_scal, G. ring.
  - rewrite <- !Sum_scal, <- Sum_minus. apply Sum_ext; intros k Hk. rewrite (U k Hk). unfold control5. fold a b. field. split; lra.
Qed.
End Spacing.

(* two particles at the origin with phases 0 and pi/2, w0 = K0 = 1, K1 = 2: the printed V grows at the rate 3/2 *)
Section Counterexample21.
Definition th21 (k : nat) : R := if Nat.eqb k 0 then 0 else PI / 2.
Definition r21 (k : nat) : C := RtoC 0.
Definition u21 (k : nat) : R := if Nat.eqb k 0 then 1 / 2 else 3 / 2.
Definition curve_th (k : nat) (s : R) : R := th21 k + u21 k * s.
Definition curve_r (k : nat) (s : R) : C := (RtoC s * expi (th21 k))%C.
Lemma curve_r_velocity k : is_velocity (curve_r k) 0 (expi (curve_th k 0)).
Proof.
  unfold curve_r, curve_th. rewrite Rmult_0_r, Rplus_0_r. split; cbn.
  - apply (is_derive_ext (fun s : R => cos (th21 k) * s)); [intros; cbn; ring|]. eapply D_eq; [apply D_scal, D_id|ring].
  - apply (is_derive_ext (fun s : R => sin (th21 k) * s)); [intros; cbn; ring|]. eapply D_eq; [apply D_scal, D_id|ring].
Qed.
Lemma curve_th_rate k : is_derive (curve_th k) 0 (u21 k).
Proof. unfold curve_th. eapply D_eq; [apply D_plus; [apply D_const|apply D_scal, D_id]|ring]. Qed.
Lemma values21 : gW 2 complete (fun k => curve_th k 0) 0 = -1 /\ gW 2 complete (fun k => curve_th k 0) 1 = 1 /\
  aS 2 complete 1 (fun k => curve_r k 0) (fun k => curve_th k 0) 0 = 1 /\
  aS 2 complete 1 (fun k => curve_r k 0) (fun k => curve_th k 0) 1 = -1.
Proof.
  unfold gW, aS. rewrite !inner_row. unfold lap, deg, w, complete, delta, centres, circle_centre, phasors, curve_r, curve_th, th21. cbn.
  rewrite ?Rmult_0_r, ?Rplus_0_r. rewrite cos_0, sin_0, cos_PI2, sin_PI2. repeat split; rewrite ?inner_xy; unfold inner; cbn;
  rewrite ?cos_0, ?sin_0, ?cos_PI2, ?sin_PI2; field.
Qed.
Theorem eq21_printed_fails : ~ forall n adj w0 K0 K1, (1 <= n)%nat -> undirected adj -> 0 < K0 -> K1 <> 0 -> w0 <> 0 ->
  forall (r : nat -> R -> C) (th : nat -> R -> R) t,
  (forall k, (k < n)%nat -> is_velocity (r k) t (expi (th k t))) ->
  (forall k, (k < n)%nat -> is_derive (th k) t (control5 n adj w0 K0 K1 r th t k)) ->
  is_derive (fun s => K0 * spacing n adj w0 (fun k => r k s) (fun k => th k s) + K1 * / w0 * W1 n adj (fun k => th k s)) t
    (- / INR n ^ 2 * Sum n (fun k => (K0 * aS n adj w0 (fun k => r k t) (fun k => th k t) k
       + K1 * / w0 * gW n adj (fun k => th k t) k) ^ 2)).
Proof.
  intros H. destruct values21 as [b0 [b1 [a0 a1]]].
  assert (U : forall k, (k < 2)%nat -> u21 k = control5 2 complete 1 1 2 curve_r curve_th 0 k).
  { intros k Hk. unfold control5. destruct k as [|[|k]]; [| |lia].
    - rewrite b0, a0. unfold u21. cbn. field.
    - rewrite b1, a1. unfold u21. cbn. field. }
  assert (R2 : forall k, (k < 2)%nat -> is_derive (curve_th k) 0 (control5 2 complete 1 1 2 curve_r curve_th 0 k)).
  { intros k Hk. rewrite <- (U k Hk). apply curve_th_rate. }
  pose proof (H 2%nat complete 1 1 2 ltac:(lia) complete_undirected ltac:(lra) ltac:(lra) ltac:(lra) curve_r curve_th 0
    (fun k _ => curve_r_velocity k) R2) as P.
  pose proof (eq21_actual 2 complete 1 1 2 ltac:(lia) ltac:(lra) complete_undirected curve_r curve_th
    (control5 2 complete 1 1 2 curve_r curve_th 0) 0 (fun k _ => curve_r_velocity k) R2 (fun k _ => eq_refl)) as T.
  apply is_derive_unique in P, T. rewrite T in P. cbn [Sum INR] in P. rewrite b0, b1, a0, a1 in P. lra.
Qed.
End Counterexample21.

(* ---- the limit set of Theorem 2: a solution on which S stays constant is a circular formation ---- *)
Theorem thm2_limit_set n adj w0 K0 (r : nat -> R -> C) (th : nat -> R -> R) : (1 <= n)%nat -> undirected adj ->
  strongly_connected n adj -> w0 <> 0 -> 0 < K0 ->
  (forall k t, (k < n)%nat -> is_velocity (r k) t (expi (th k t))) ->
  (forall k t, (k < n)%nat -> is_derive (th k) t (w0 + w0 * (K0 / INR n * aS n adj w0 (fun k => r k t) (fun k => th k t) k))) ->
  (forall t, spacing n adj w0 (fun k => r k t) (fun k => th k t) = spacing n adj w0 (fun k => r k 0) (fun k => th k 0)) ->
  (forall k t, (k < n)%nat -> is_derive (th k) t w0) /\
  exists c0 : C, forall k t, (k < n)%nat -> circle_centre w0 (r k t) (th k t) = c0.
Proof.
  intros Hn S SC Hw HK R1 R2 E. pose proof (INR_pos n Hn).
  assert (A : forall k t, (k < n)%nat -> aS n adj w0 (fun k => r k t) (fun k => th k t) k = 0).
  { intros k t Hk. pose proof (eq20 n adj w0 K0 Hn Hw S r th _ t (fun k Hk => R1 k t Hk) (fun k Hk => R2 k t Hk) (fun k _ => eq_refl)) as D.
    assert (Z : is_derive (fun s => spacing n adj w0 (fun k => r k s) (fun k => th k s)) t 0).
    { apply (is_derive_ext (fun _ : R => spacing n adj w0 (fun k => r k 0) (fun k => th k 0))); [intros s; symmetry; apply E|apply D_const]. }
    apply is_derive_unique in D, Z. rewrite D in Z.
    assert (F : 0 < K0 / INR n ^ 2) by (apply Rdiv_lt_0_compat; [lra|nra]).
    assert (T : Sum n (fun k => aS n adj w0 (fun k => r k t) (fun k => th k t) k ^ 2) = 0) by nra.
    pose proof (Sum_eq0 n (fun k => aS n adj w0 (fun k => r k t) (fun k => th k t) k ^ 2) (fun _ _ => pow2_ge_0 _) T k Hk) as Q0. cbv beta in Q0.
    nra. }
  assert (W : forall k t, (k < n)%nat -> is_derive (th k) t w0).
  { intros k t Hk. eapply D_eq; [apply R2, Hk|]. rewrite A by assumption. ring. }
  split; [exact W|].
  assert (CC : forall k t, (k < n)%nat -> circle_centre w0 (r k t) (th k t) = circle_centre w0 (r k 0) (th k 0)).
  { intros k t Hk. apply (velocity_constant (fun s => circle_centre w0 (r k s) (th k s))). intros s.
    eapply velocity_eq; [apply eq18; [now apply R1|now apply W]|]. apply injective_projections; cbn; field; lra. }
  pose (c := fun k => circle_centre w0 (r k 0) (th k 0)).
  assert (Z : forall k, (k < n)%nat -> row n (lap n adj) k c = RtoC 0).
  { intros k Hk. set (z := row n (lap n adj) k c).
    assert (I : forall t, inner (expi (th k t)) z = 0).
    { intros t. rewrite <- (A k t Hk). unfold aS, z, row. f_equal. apply Csum_ext; intros j Hj. f_equal.
      symmetry. exact (CC j t Hj). }
    clearbody z. pose proof (velocity_expi (th k) 0 w0 (W k 0 Hk)) as V.
    assert (J : inner (RtoC w0 * (Ci * expi (th k 0%R)))%C z = 0).
    { assert (D : is_derive (fun s => inner (expi (th k s)) z) 0 (inner (RtoC w0 * (Ci * expi (th k 0%R)))%C z + inner (expi (th k 0)) (RtoC 0))).
      { apply (D_inner (fun s => expi (th k s)) (fun _ => z)); [exact V|]. split; apply D_const. }
      assert (D0 : is_derive (fun s => inner (expi (th k s)) z) 0 0).
      { apply (is_derive_ext (fun _ : R => 0)); [intros s; symmetry; apply I|apply D_const]. }
      apply is_derive_unique in D, D0. rewrite D in D0. rewrite !inner_xy in D0 |- *. cbn in D0 |- *. lra. }
    specialize (I 0). rewrite inner_xy in I, J. cbn in I, J. pose proof (sc2 (th k 0)) as SCk.
    destruct z as [x y]; cbn in *. set (a := cos (th k 0)) in *. set (b := sin (th k 0)) in *.
    assert (J2 : a * y - b * x = 0).
    { apply (Rmult_eq_reg_l w0); [|assumption]. rewrite Rmult_0_r. etransitivity; [|exact J]. ring. }
    unfold RtoC. f_equal.
    - transitivity ((b * (b * 1) + a * (a * 1)) * x); [rewrite SCk; ring|]. transitivity (a * (a * x + b * y) - b * (a * y - b * x)); [ring|]. rewrite I, J2. ring.
    - transitivity ((b * (b * 1) + a * (a * 1)) * y); [rewrite SCk; ring|]. transitivity (b * (a * x + b * y) + a * (a * y - b * x)); [ring|]. rewrite I, J2. ring. }
  assert (Q0 : Q n (lap n adj) c = 0).
  { unfold Q. rewrite Sum_zero; [ring|]. intros k Hk. rewrite Z by assumption. rewrite inner_xy. cbn [fst snd RtoC]. ring. }
  apply (Q_kernel n adj c Hn S SC) in Q0. destruct Q0 as [c0 H0]. exists c0. intros k t Hk.
  transitivity (c k); [now apply CC|now apply H0].
Qed.

(* ---- (29): different networks for orientation and spacing ---- *)
Definition control29 (n : nat) (ori att : graph) (w0 K0 K1 : R) (r : nat -> C) (th : nat -> R) (k : nat) : R :=
  w0 + (K1 - K0) / INR n * gW n ori th k + w0 * (K0 / INR n) * inner (expi (th k)) (row n (lap n att) k r).   (* as printed *)
Definition control5_two (n : nat) (ori att : graph) (w0 K0 K1 : R) (r : nat -> C) (th : nat -> R) (k : nat) : R :=
  w0 + K1 / INR n * gW n ori th k + w0 * (K0 / INR n * aS n att w0 r th k).                          (* (5), (14), (20) *)
Theorem eq29_corrected n ori att w0 K0 K1 r th k : (1 <= n)%nat -> w0 <> 0 ->
  control5_two n ori att w0 K0 K1 r th k =
  w0 + K1 / INR n * gW n ori th k - K0 / INR n * gW n att th k + w0 * (K0 / INR n) * inner (expi (th k)) (row n (lap n att) k r).
Proof.
  intros Hn Hw.
  assert (E : w0 + 0 / INR n * gW n att th k + w0 * (K0 / INR n * aS n att w0 r th k) =
    w0 + (0 - K0) / INR n * gW n att th k + w0 * (K0 / INR n) * inner (expi (th k)) (row n (lap n att) k r))
    by exact (eq22 n att w0 K0 0 Hn Hw (fun k _ => r k) (fun k _ => th k) 0 k).
  unfold control5_two. pose proof (INR_pos n Hn). unfold Rdiv in *. lra.
Qed.
Theorem eq29_same n adj w0 K0 K1 r th k : (1 <= n)%nat -> w0 <> 0 -> control5_two n adj adj w0 K0 K1 r th k = control29 n adj adj w0 K0 K1 r th k.
Proof. intros Hn Hw. rewrite eq29_corrected by assumption. unfold control29, Rdiv. ring. Qed.
Definition no_arcs (k j : nat) : bool := false.
Theorem eq29_printed_fails : ~ forall n ori att w0 K0 K1 r th k, (1 <= n)%nat -> w0 <> 0 -> 0 < K0 -> (k < n)%nat ->
  control5_two n ori att w0 K0 K1 r th k = control29 n ori att w0 K0 K1 r th k.
Proof.
  intros H. specialize (H 2%nat no_arcs complete 1 1 1 (fun _ => RtoC 0) th21 0%nat ltac:(lia) ltac:(lra) ltac:(lra) ltac:(lia)).
  rewrite eq29_corrected in H by (try lia; lra). unfold control29 in H.
  rewrite !gW_sines in H by lia. unfold w, complete, no_arcs, th21 in H. cbn in H.
  replace (0 - PI / 2) with (- (PI / 2)) in H by ring. rewrite sin_neg, sin_PI2 in H. lra.
Qed.
