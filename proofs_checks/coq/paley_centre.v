(* Paley et al., the spacing loop of Theorem 2: a motion is determined by its start, and so is the common centre to which it tends.
     paley.thm2.center (clause 2). *)
From Coq Require Import Reals Lra Lia Psatz.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums paley_model paley_phase paley_laplacian paley_gradient paley_particles.
Open Scope R_scope.

(* particles (1) under the spacing control (20) for all t >= 0 *)
Definition spaced (n : nat) (adj : graph) (w0 K0 : R) (r : nat -> R -> C) (th : nat -> R -> R) : Prop := forall k t, (k < n)%nat -> 0 <= t ->
  is_velocity (r k) t (expi (th k t)) /\
  is_derive (th k) t (w0 + w0 * (K0 / INR n * aS n adj w0 (fun j => r j t) (fun j => th j t) k)).
(* ... and the centres of their circles tend to c *)
Definition centres_tend (n : nat) (w0 : R) (r : nat -> R -> C) (th : nat -> R -> R) (c : C) : Prop :=
  forall k, (k < n)%nat -> forall e, 0 < e -> exists T, forall t, T <= t -> Cmod (circle_centre w0 (r k t) (th k t) - c)%C < e.

Lemma sin_near a b : Rabs (sin a - sin b) <= Rabs (a - b).
Proof.
  assert (H : forall a b, a <= b -> Rabs (sin b - sin a) <= Rabs (b - a)).
  { clear. intros a b L. destruct (MVT_le sin cos a b L) as [c [_ E]]; [intros; apply is_derive_sin|]. rewrite E, Rabs_mult.
    pose proof (COS_bound c). assert (Rabs (cos c) <= 1) by (apply Rabs_le; lra). pose proof (Rabs_pos (b - a)). nra. }
  destruct (Rle_or_lt a b); [rewrite (Rabs_minus_sym (sin a)), (Rabs_minus_sym a); now apply H|apply H; lra].
Qed.
Lemma cos_near a b : Rabs (cos a - cos b) <= Rabs (a - b).
Proof. rewrite !cos_sin. replace (a - b) with (PI / 2 + a - (PI / 2 + b)) by ring. apply sin_near. Qed.

Lemma aS_sum n adj w0 r th k : aS n adj w0 r th k =
  Sum n (fun j => lap n adj k j * (cos (th k) * fst (r j) + sin (th k) * snd (r j) + / w0 * sin (th k - th j))).
Proof.
  unfold aS, row, centres, circle_centre. rewrite inner_xy. unfold Csum; cbn [fst snd]. rewrite <- !Sum_scal, <- Sum_plus.
  apply Sum_ext; intros j _. rewrite sin_minus. unfold expi. cbn. ring.
Qed.

Section Unique.
Variables (n : nat) (adj : graph) (w0 K0 : R) (r q : nat -> R -> C) (th ph : nat -> R -> R).
Hypothesis A : spaced n adj w0 K0 r th.
Hypothesis B : spaced n adj w0 K0 q ph.
Definition gap (t : R) : R := Sum n (fun k => (fst (r k t) - fst (q k t)) ^ 2 + (snd (r k t) - snd (q k t)) ^ 2 + (th k t - ph k t) ^ 2).

Lemma within t k : (k < n)%nat -> 0 <= gap t /\ Rabs (fst (r k t) - fst (q k t)) <= sqrt (gap t) /\ Rabs (snd (r k t) - snd (q k t)) <= sqrt (gap t) /\
  Rabs (th k t - ph k t) <= sqrt (gap t).
Proof.
  intros Hk. assert (P : forall j, 0 <= (fst (r j t) - fst (q j t)) ^ 2 + (snd (r j t) - snd (q j t)) ^ 2 + (th j t - ph j t) ^ 2).
  { intros j. pose proof (pow2_ge_0 (fst (r j t) - fst (q j t))). pose proof (pow2_ge_0 (snd (r j t) - snd (q j t))). pose proof (pow2_ge_0 (th j t - ph j t)). lra. }
  pose proof (Sum_term_le n _ k (fun j _ => P j) Hk) as T. cbv beta in T. fold (gap t) in T.
  pose proof (pow2_ge_0 (fst (r k t) - fst (q k t))). pose proof (pow2_ge_0 (snd (r k t) - snd (q k t))). pose proof (pow2_ge_0 (th k t - ph k t)).
  split; [lra|]. repeat split; rewrite <- sqrt_Rsqr_abs; apply sqrt_le_1_alt; unfold Rsqr; nra.
Qed.
(* positions on [0, T] *)
Lemma held T k t : (k < n)%nat -> 0 <= t <= T -> Rabs (fst (r k t)) <= Sum n (fun j => Rabs (fst (r j 0)) + Rabs (snd (r j 0))) + T /\
  Rabs (snd (r k t)) <= Sum n (fun j => Rabs (fst (r j 0)) + Rabs (snd (r j 0))) + T.
Proof.
  intros Hk Ht. pose proof (Sum_term_le n (fun j => Rabs (fst (r j 0)) + Rabs (snd (r j 0))) k) as S. cbv beta in S.
  specialize (S (fun j _ => Rplus_le_le_0_compat _ _ (Rabs_pos _) (Rabs_pos _)) Hk). pose proof (Rabs_pos (fst (r k 0))). pose proof (Rabs_pos (snd (r k 0))).
  destruct (MVT_le (fun s => fst (r k s)) (fun s => cos (th k s)) 0 t) as [c [Hc E]]; [lra|intros x Hx; apply (A k x Hk ltac:(lra))|].
  destruct (MVT_le (fun s => snd (r k s)) (fun s => sin (th k s)) 0 t) as [d [Hd F]]; [lra|intros x Hx; apply (A k x Hk ltac:(lra))|].
  pose proof (COS_bound (th k c)). pose proof (SIN_bound (th k d)).
  pose proof (Rle_abs (fst (r k 0))). pose proof (Rle_abs (snd (r k 0))). pose proof (Rle_abs (- fst (r k 0))). pose proof (Rle_abs (- snd (r k 0))). rewrite Rabs_Ropp in *.
  split; apply Rabs_le; nra.
Qed.
Lemma control_near T t k : (k < n)%nat -> 0 <= t <= T ->
  Rabs (aS n adj w0 (fun j => r j t) (fun j => th j t) k - aS n adj w0 (fun j => q j t) (fun j => ph j t) k) <=
  Sum n (fun i => Sum n (fun j => Rabs (lap n adj i j))) * (2 * (Sum n (fun j => Rabs (fst (r j 0)) + Rabs (snd (r j 0))) + T) + 2 + 2 * Rabs (/ w0)) * sqrt (gap t).
Proof.
  intros Hk Ht. rewrite !aS_sum, <- Sum_minus. eapply Rle_trans; [apply Sum_Rabs|].
  set (X := Sum n (fun j => Rabs (fst (r j 0)) + Rabs (snd (r j 0))) + T). set (N := sqrt (gap t)).
  assert (HN : 0 <= N) by apply sqrt_pos. pose proof (Rabs_pos (/ w0)) as HW.
  assert (HX : 0 <= X). { pose proof (proj1 (held T k t Hk Ht)). pose proof (Rabs_pos (fst (r k t))). unfold X. lra. }
  apply Rle_trans with (Sum n (fun j => Rabs (lap n adj k j)) * ((2 * X + 2 + 2 * Rabs (/ w0)) * N)).
  - rewrite <- Sum_scal_r. apply Sum_le; intros j Hj. rewrite <- Rmult_minus_distr_l, Rabs_mult. apply Rmult_le_compat_l; [apply Rabs_pos|].
    destruct (within t k Hk) as (_ & _ & _ & Tk). destruct (within t j Hj) as (_ & Xj & Yj & Tj). fold N in Tk, Xj, Yj, Tj.
    destruct (held T j t Hj Ht) as [Bx By]. fold X in Bx, By.
    pose proof (cos_near (th k t) (ph k t)) as C1. pose proof (sin_near (th k t) (ph k t)) as C2.
    pose proof (sin_near (th k t - th j t) (ph k t - ph j t)) as C3.
    assert (C3' : Rabs (th k t - th j t - (ph k t - ph j t)) <= 2 * N).
    { replace (th k t - th j t - (ph k t - ph j t)) with ((th k t - ph k t) + - (th j t - ph j t)) by ring. eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_Ropp. lra. }
    match goal with |- Rabs ?z <= _ => replace z with ((cos (th k t) - cos (ph k t)) * fst (r j t) + cos (ph k t) * (fst (r j t) - fst (q j t))
      + ((sin (th k t) - sin (ph k t)) * snd (r j t) + sin (ph k t) * (snd (r j t) - snd (q j t)))
      + / w0 * (sin (th k t - th j t) - sin (ph k t - ph j t))) by ring end.
    eapply Rle_trans; [apply Rabs_triang|]. eapply Rle_trans; [apply Rplus_le_compat_r, Rabs_triang|].
    eapply Rle_trans; [apply Rplus_le_compat_r, Rplus_le_compat; apply Rabs_triang|]. rewrite !Rabs_mult.
    pose proof (COS_bound (ph k t)). pose proof (SIN_bound (ph k t)).
    assert (U1 : Rabs (cos (ph k t)) <= 1) by (apply Rabs_le; lra). assert (U2 : Rabs (sin (ph k t)) <= 1) by (apply Rabs_le; lra).
    assert (Q1 : Rabs (cos (th k t) - cos (ph k t)) * Rabs (fst (r j t)) <= N * X) by (apply Rmult_le_compat; try apply Rabs_pos; lra).
    assert (Q2 : Rabs (sin (th k t) - sin (ph k t)) * Rabs (snd (r j t)) <= N * X) by (apply Rmult_le_compat; try apply Rabs_pos; lra).
    assert (Q3 : Rabs (cos (ph k t)) * Rabs (fst (r j t) - fst (q j t)) <= 1 * N) by (apply Rmult_le_compat; try apply Rabs_pos; lra).
    assert (Q4 : Rabs (sin (ph k t)) * Rabs (snd (r j t) - snd (q j t)) <= 1 * N) by (apply Rmult_le_compat; try apply Rabs_pos; lra).
    assert (Q5 : Rabs (/ w0) * Rabs (sin (th k t - th j t) - sin (ph k t - ph j t)) <= Rabs (/ w0) * (2 * N)) by (apply Rmult_le_compat_l; lra).
    lra.
  - rewrite Rmult_assoc. apply Rmult_le_compat_r; [apply Rmult_le_pos; lra|].
    apply (Sum_term_le n (fun i => Sum n (fun j => Rabs (lap n adj i j))) k); [|exact Hk]. intros i _. apply Sum_ge0. intros; apply Rabs_pos.
Qed.
Theorem same_motion : (forall k, (k < n)%nat -> r k 0 = q k 0 /\ th k 0 = ph k 0) -> forall t k, 0 <= t -> (k < n)%nat -> r k t = q k t /\ th k t = ph k t.
Proof.
  intros I T k HT Hk.
  set (M := Sum n (fun i => Sum n (fun j => Rabs (lap n adj i j))) * (2 * (Sum n (fun j => Rabs (fst (r j 0)) + Rabs (snd (r j 0))) + T) + 2 + 2 * Rabs (/ w0))).
  set (F := Rabs (w0 * (K0 / INR n)) * M). set (K := INR n * (4 + 2 * F)).
  assert (HG : forall t, 0 <= gap t) by (intros t; apply (within t k Hk)).
  pose (d := fun t => Sum n (fun i => 2 * (fst (r i t) - fst (q i t)) * (cos (th i t) - cos (ph i t)) + 2 * (snd (r i t) - snd (q i t)) * (sin (th i t) - sin (ph i t))
    + 2 * (th i t - ph i t) * (w0 * (K0 / INR n) * (aS n adj w0 (fun j => r j t) (fun j => th j t) i - aS n adj w0 (fun j => q j t) (fun j => ph j t) i)))).
  assert (D : forall t, 0 <= t -> is_derive gap t (d t)).
  { intros t Ht. unfold gap, d. apply (D_Sum n (fun i s => (fst (r i s) - fst (q i s)) ^ 2 + (snd (r i s) - snd (q i s)) ^ 2 + (th i s - ph i s) ^ 2)
      (fun i => 2 * (fst (r i t) - fst (q i t)) * (cos (th i t) - cos (ph i t)) + 2 * (snd (r i t) - snd (q i t)) * (sin (th i t) - sin (ph i t))
    + 2 * (th i t - ph i t) * (w0 * (K0 / INR n) * (aS n adj w0 (fun j => r j t) (fun j => th j t) i - aS n adj w0 (fun j => q j t) (fun j => ph j t) i)))).
    intros i Hi. destruct (A i t Hi Ht) as [[A1 A2] A3]. destruct (B i t Hi Ht) as [[B1 B2] B3].
    apply D_plus; [apply D_plus|]; (eapply D_eq; [apply D_sqr, D_minus; eassumption|]); cbn [fst snd expi]; unfold expi; cbn [fst snd]; ring. }
  assert (Bd : forall t, 0 <= t <= T -> d t <= K * gap t).
  { intros t Ht. unfold d, K. replace (INR n * (4 + 2 * F) * gap t) with (INR n * ((4 + 2 * F) * gap t)) by ring. rewrite <- Sum_const. apply Sum_le; intros i Hi.
    destruct (within t i Hi) as (_ & Xi & Yi & Ti). pose proof (control_near T t i Hi Ht) as Cn. fold M in Cn.
    pose proof (cos_near (th i t) (ph i t)) as C1. pose proof (sin_near (th i t) (ph i t)) as C2.
    pose proof (sqrt_sqrt (gap t) (HG t)) as SS. set (N := sqrt (gap t)) in *.
    assert (P : forall a b s, Rabs a <= N -> Rabs b <= s * N -> 2 * a * b <= 2 * s * gap t).
    { intros a b s Ha Hb. rewrite <- SS. pose proof (Rle_abs (a * b)) as L. rewrite Rabs_mult in L. pose proof (Rabs_pos a). pose proof (Rabs_pos b).
      assert (Rabs a * Rabs b <= N * (s * N)) by (apply Rmult_le_compat; assumption). lra. }
    assert (G : Rabs (w0 * (K0 / INR n) * (aS n adj w0 (fun j => r j t) (fun j => th j t) i - aS n adj w0 (fun j => q j t) (fun j => ph j t) i)) <= F * N).
    { rewrite Rabs_mult. unfold F. rewrite Rmult_assoc. apply Rmult_le_compat_l; [apply Rabs_pos|exact Cn]. }
    pose proof (P _ _ 1 Xi (Rle_trans _ _ (1 * N) C1 ltac:(lra))). pose proof (P _ _ 1 Yi (Rle_trans _ _ (1 * N) C2 ltac:(lra))). pose proof (P _ _ F Ti G). lra. }
  assert (G0 : gap 0 = 0).
  { unfold gap. apply Sum_zero; intros i Hi. destruct (I i Hi) as [E1 E2]. rewrite E1, E2. ring. }
  assert (Z : gap T = 0).
  { assert (L : gap T * exp (- K * T) <= gap 0 * exp (- K * 0)).
    { apply (decreasing (fun s => gap s * exp (- K * s)) (fun s => d s * exp (- K * s) + gap s * (exp (- K * s) * - K)) 0 T HT).
      - intros s Hs. apply (D_mult gap (fun x => exp (- K * x))); [apply D; lra|].
        apply (D_comp exp (fun x => - K * x) s (exp (- K * s)) (- K)); [apply is_derive_exp|]. eapply D_eq; [apply D_scal, D_id|]. ring.
      - intros s Hs. pose proof (Bd s Hs). pose proof (exp_pos (- K * s)). nra. }
    rewrite G0, Rmult_0_l in L. pose proof (exp_pos (- K * T)). pose proof (HG T). nra. }
  destruct (within T k Hk) as (_ & Xk & Yk & Tk). rewrite Z, sqrt_0 in Xk, Yk, Tk. apply Rabs_le_between in Xk, Yk, Tk.
  split; [apply injective_projections|]; lra.
Qed.
End Unique.
(* the limit of the centres is a function of the initial state, for given n, network, w0 and K_0 *)
Theorem centre_by_start n adj w0 K0 (r q : nat -> R -> C) (th ph : nat -> R -> R) (c c' : C) : (1 <= n)%nat ->
  spaced n adj w0 K0 r th -> spaced n adj w0 K0 q ph -> (forall k, (k < n)%nat -> r k 0 = q k 0 /\ th k 0 = ph k 0) ->
  centres_tend n w0 r th c -> centres_tend n w0 q ph c' -> c = c'.
Proof.
  intros Hn A B I L L'. destruct (Ceq_dec c c') as [|N]; [assumption|exfalso].
  assert (P : 0 < Cmod (c - c')%C). { apply Cmod_gt_0. intros E. apply N. replace c with ((c - c') + c')%C by ring. rewrite E. ring. }
  destruct (L 0%nat ltac:(lia) (Cmod (c - c')%C / 2) ltac:(lra)) as [T HT]. destruct (L' 0%nat ltac:(lia) (Cmod (c - c')%C / 2) ltac:(lra)) as [T' HT'].
  set (t := Rmax 0 (Rmax T T')). pose proof (Rmax_l 0 (Rmax T T')). pose proof (Rmax_r 0 (Rmax T T')). pose proof (Rmax_l T T'). pose proof (Rmax_r T T'). fold t in H, H0.
  specialize (HT t ltac:(lra)). specialize (HT' t ltac:(lra)).
  destruct (same_motion n adj w0 K0 r q th ph A B I t 0%nat ltac:(lra) ltac:(lia)) as [E1 E2]. rewrite E1, E2 in HT.
  set (z := circle_centre w0 (q 0%nat t) (ph 0%nat t)) in *.
  pose proof (Cmod_triangle (z - c')%C (- (z - c))%C) as Tr. rewrite Cmod_opp in Tr.
  replace ((z - c') + - (z - c))%C with (c - c')%C in Tr by ring. lra.
Qed.
