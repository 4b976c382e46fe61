(* Paley et al.: the stationary points of U_m that are neither minima nor maxima are saddle points and isolated up to rotation.
     paley.Um, clause 3. *)
From Coq Require Import Reals Lra Lia Psatz.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums paley_model paley_phase paley_laplacian paley_gradient paley_patterns paley_convergence.
Open Scope R_scope.

Lemma multiple_upd m th k s j : multiple m (upd th k s) j = upd (multiple m th) k (INR m * s) j.
Proof. unfold multiple, upd. now destruct (Nat.eqb j k). Qed.
Lemma order_ext n th th' : (forall k, (k < n)%nat -> th k = th' k) -> order n th = order n th'.
Proof. intros E. unfold order. f_equal. apply Csum_ext. intros k Hk. unfold phasors. now rewrite E. Qed.
Lemma U1_ext n th th' : (forall k, (k < n)%nat -> th k = th' k) -> U1 n th = U1 n th'.
Proof. intros E. unfold U1. now rewrite (order_ext n th th' E). Qed.
Lemma stationary_multiple n m th : (1 <= n)%nat -> (1 <= m)%nat -> stationary n (Um n m) th -> stationary n (U1 n) (multiple m th).
Proof.
  intros Hn Hm H k Hk. pose proof (INR_pos m Hm) as P. pose proof (U1_gradient n (multiple m th) k Hn Hk) as G. set (g := g1 n (multiple m th) k) in *.
  assert (D : partial (Um n m) th k (/ INR m ^ 2 * (INR m * g))).
  { unfold partial. apply (is_derive_ext (fun s => / INR m ^ 2 * U1 n (upd (multiple m th) k (INR m * s)))).
    - intros s. rewrite Um_U1 by assumption. f_equal. apply U1_ext. intros j _. symmetry. apply multiple_upd.
    - apply D_scal. unfold partial in G. eapply D_eq; [apply (D_comp (fun s => U1 n (upd (multiple m th) k s)) (fun s => INR m * s) (th k) g (INR m * 1)); [exact G|apply D_scal, D_id]|ring]. }
  pose proof (partial_unique _ _ _ _ _ D (H k Hk)) as E2.
  replace 0 with g; [exact G|]. assert (F : / INR m ^ 2 * (INR m * g) = g / INR m) by (field; lra). rewrite F in E2.
  apply (Rmult_eq_reg_r (/ INR m)); [unfold Rdiv in E2; lra|apply Rinv_neq_0_compat; lra].
Qed.
Lemma sines_zero n th : (1 <= n)%nat -> stationary n (U1 n) th -> ~ balanced n th -> forall j k, (j < n)%nat -> (k < n)%nat -> sin (th k - th j) = 0.
Proof.
  intros Hn S B j k Hj Hk. destruct (critical_signs n th Hn S B) as (z & c & Z & E & _). rewrite <- (inner_iexpi (th j) (th k)).
  rewrite (proj2 (E j Hj)), (proj2 (E k Hk)), inner_xy. cbn. ring.
Qed.
Lemma Csum_near n x y e : (forall k, (k < n)%nat -> Cmod (x k - y k)%C <= e) -> Cmod (Csum n x - Csum n y)%C <= INR n * e.
Proof.
  intros H. induction n as [|n IH].
  - replace (Csum 0 x - Csum 0 y)%C with (RtoC 0) by (apply injective_projections; cbn; ring). rewrite Cmod_0. cbn. lra.
  - replace (Csum (S n) x - Csum (S n) y)%C with ((Csum n x - Csum n y) + (x n - y n))%C by (apply injective_projections; cbn; ring).
    eapply Rle_trans; [apply Cmod_triangle|]. specialize (IH ltac:(intros; apply H; lia)). specialize (H n ltac:(lia)). rewrite S_INR. lra.
Qed.

Theorem other_points : forall n m th, (1 <= n)%nat -> (1 <= m)%nat -> stationary n (Um n m) th -> moment n m th <> RtoC 0 ->
  ~ (forall j k, (j < n)%nat -> (k < n)%nat -> exists z : Z, INR m * (th j - th k) = 2 * PI * IZR z) ->
  saddle n (Um n m) th /\
  exists e, 0 < e /\ forall th', (forall k, (k < n)%nat -> Rabs (th' k - th k) < e) -> stationary n (Um n m) th' -> exists a, forall k, (k < n)%nat -> th' k = th k + a.
Proof.
  intros n m th Hn Hm St Mo Nm. pose proof (INR_pos m Hm) as P. pose proof (INR_pos n Hn) as Pn. set (q := multiple m th).
  pose proof (stationary_multiple n m th Hn Hm St) as S1. fold q in S1.
  assert (B1 : ~ balanced n q) by (intros B; apply Mo; now apply (moment_0 n m th Hn Hm)).
  assert (F : 0 < / INR m ^ 2) by (apply Rinv_0_lt_compat; nra). split.
  - assert (N1 : ~ synchronized n q).
    { intros Sy. apply Nm. apply (proj2 (proj2 (Um_extremes n m th Hn Hm))). rewrite Um_U1 by assumption. fold q.
      destruct (U1_max n q Hn) as [_ E]. rewrite (proj2 E Sy). field. lra. }
    destruct (thm1_saddle n q Hn S1 N1 B1) as (_ & _ & Sd). split; [exact St|]. intros e He.
    destruct (Sd (INR m * e) ltac:(nra)) as [[a [A1 A2]] [b [C1 C2]]].
    assert (Q : forall p : nat -> R, (forall k, (k < n)%nat -> Rabs (p k - q k) < INR m * e) ->
      (forall k, (k < n)%nat -> Rabs (p k / INR m - th k) < e) /\ Um n m (fun k => p k / INR m) = / INR m ^ 2 * U1 n p).
    { intros p Hp. split.
      - intros k Hk. specialize (Hp k Hk). unfold q, multiple in Hp. replace (p k / INR m - th k) with ((p k - INR m * th k) * / INR m) by (field; lra).
        rewrite Rabs_mult, (Rabs_pos_eq (/ INR m)) by (left; now apply Rinv_0_lt_compat). apply Rmult_lt_reg_r with (INR m); [exact P|].
        rewrite Rmult_assoc, Rinv_l by lra. lra.
      - rewrite Um_U1 by assumption. f_equal. apply U1_ext. intros k _. unfold multiple. field. lra. }
    assert (E : Um n m th = / INR m ^ 2 * U1 n q) by now apply Um_U1.
    split; [exists (fun k => a k / INR m); destruct (Q a A1) as [Q1 Q2]|exists (fun k => b k / INR m); destruct (Q b C1) as [Q1 Q2]]; (split; [exact Q1|]);
      rewrite E, Q2; [apply Rmult_gt_compat_l|apply Rmult_lt_compat_l]; lra.
  - pose proof (critical_signs n q Hn S1 B1) as (z & c & Z & _ & CS & SP). set (s := Cmod (Csum n (phasors q))).
    assert (Hs : 0 < s).
    { unfold s. rewrite CS, Cmod_mult, Cmod_R, Rabs_pos_eq by lra. apply Rmult_lt_0_compat; [exact SP|].
      destruct (Cmod_ge_0 z) as [|E]; [assumption|]. exfalso. symmetry in E. apply Cmod_eq_0 in E. rewrite E, inner_xy in Z. cbn in Z. lra. }
    set (e := Rmin (1 / (2 * INR m)) (s / (4 * INR n * INR m))). pose proof PI_RGT_0. pose proof PI2_3_2 as P32.
    assert (Mn : 0 < 4 * INR n * INR m) by nra. assert (He : 0 < e) by (unfold e; apply Rmin_glb_lt; apply Rdiv_lt_0_compat; lra).
    assert (E1 : 2 * INR m * e <= 1).
    { apply Rle_trans with (2 * INR m * (1 / (2 * INR m))); [apply Rmult_le_compat_l; [lra|apply Rmin_l]|right; field; lra]. }
    assert (E2 : 4 * INR n * INR m * e <= s).
    { apply Rle_trans with (4 * INR n * INR m * (s / (4 * INR n * INR m))); [apply Rmult_le_compat_l; [lra|apply Rmin_r]|right; field; lra]. }
    exists e. split; [exact He|]. intros th' Hc St'. set (q' := multiple m th'). pose proof (stationary_multiple n m th' Hn Hm St') as S2. fold q' in S2.
    assert (Near : forall k, (k < n)%nat -> Rabs (q' k - q k) <= INR m * e).
    { intros k Hk. unfold q', q, multiple. rewrite <- Rmult_minus_distr_l, Rabs_mult, (Rabs_pos_eq (INR m)) by lra. apply Rmult_le_compat_l; [lra|]. left. now apply Hc. }
    assert (B2 : ~ balanced n q').
    { intros B. assert (Z0 : Csum n (phasors q') = RtoC 0).
      { replace (Csum n (phasors q')) with (RtoC (INR n) * order n q')%C; [rewrite B; apply Cmult_0_r|]. unfold order. rewrite Cmult_assoc.
        replace (RtoC (INR n) * RtoC (/ INR n))%C with (RtoC 1); [apply Cmult_1_l|]. apply injective_projections; cbn; field; lra. }
      pose proof (Csum_near n (phasors q) (phasors q') (2 * (INR m * e))) as L. rewrite Z0 in L.
      replace (Csum n (phasors q) - RtoC 0)%C with (Csum n (phasors q)) in L by ring. fold s in L.
      assert (s <= INR n * (2 * (INR m * e))); [|nra]. apply L. intros k Hk. unfold phasors. eapply Rle_trans; [apply expi_near|]. rewrite Rabs_minus_sym. specialize (Near k Hk). lra. }
    exists (th' 0%nat - th 0%nat). intros k Hk. pose proof (sines_zero n q Hn S1 B1 0%nat k ltac:(lia) Hk) as A1. pose proof (sines_zero n q' Hn S2 B2 0%nat k ltac:(lia) Hk) as A2.
    set (d := (q' k - q' 0%nat) - (q k - q 0%nat)).
    assert (Sd : sin d = 0) by (unfold d; rewrite sin_minus, A1, A2; ring).
    assert (Hd : Rabs d <= 1).
    { pose proof (Near k Hk) as L1. pose proof (Near 0%nat ltac:(lia)) as L2. unfold d. replace (q' k - q' 0%nat - (q k - q 0%nat)) with ((q' k - q k) + - (q' 0%nat - q 0%nat)) by ring.
      eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_Ropp. lra. }
    assert (d = 0).
    { apply Rabs_le_between in Hd. destruct (Rtotal_order d 0) as [L|[L|L]]; [|exact L|]; exfalso.
      - assert (0 < sin (- d)) by (apply sin_gt_0; lra). rewrite sin_neg in H0. lra.
      - assert (0 < sin d) by (apply sin_gt_0; lra). lra. }
    unfold d, q', q, multiple in H0. apply (Rmult_eq_reg_l (INR m)); lra.
Qed.
