(* Paley et al., the second half: Fourier columns as patterns, the maximum of W_1 on C_N, the reference phase and the
   beacon, the ball that holds the centre of mass, and the fish model: its step (26), its signs, its scalings. *)
From Coq Require Import Reals Lra Lia Psatz ZArith Relations Bool.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums paley_model paley_phase paley_laplacian paley_gradient paley_particles paley_fourier paley_patterns.
Open Scope R_scope.

(* ---- a Fourier column is a symmetric pattern (the corrected form of the sentence after eq (16)) ---- *)
Theorem wave_pattern n m : (1 <= n)%nat -> pattern (n / Nat.gcd n m) n (wave n m).
Proof.
  intros Hn. pose proof (INR_pos n Hn) as P. set (g := Nat.gcd n m).
  assert (Hg : g <> 0%nat) by (unfold g; intros E; apply Nat.gcd_eq_0_l in E; lia).
  destruct (Nat.gcd_divide_l n m) as [M EM]. destruct (Nat.gcd_divide_r n m) as [b Eb]. fold g in EM, Eb.
  pose proof (Nat.gcd_div_gcd n m g Hg eq_refl) as CP. clearbody g.
  assert (D : (n / g = M)%nat) by (subst n; now apply Nat.div_mul).
  assert (D' : (m / g = b)%nat) by (subst m; now apply Nat.div_mul). rewrite D, D' in CP. rewrite D.
  assert (HM : (1 <= M)%nat) by (destruct M; lia).
  apply moments_pattern; try assumption.
  - intros q Hq. unfold moment. rewrite (Csum_ext n _ (fun k => expi (INR k * (2 * PI * IZR (Z.of_nat (q * m)) / INR n)))).
    + rewrite roots_sum; [apply Cmult_0_r|assumption|]. intros [z Hz].
      assert (DV : Nat.divide M q).
      { apply (Nat.gauss M b q); [|exact CP]. exists (Z.to_nat z).
        assert (0 <= z)%Z by nia. apply Nat2Z.inj. rewrite !Nat2Z.inj_mul, Z2Nat.id by assumption.
        rewrite EM, Eb, !Nat2Z.inj_mul in Hz. assert (0 < Z.of_nat g)%Z by lia. clear - Hz H0. nia. }
      apply Nat.divide_pos_le in DV; lia.
    + intros k _. f_equal. unfold wave. rewrite <- INR_IZR_INZ, mult_INR. field. lra.
  - intros j k _ _. assert (T : forall k, expi (multiple M (wave n m) k) = RtoC 1).
    { intros i. unfold multiple, wave. replace (INR M * (2 * PI * INR m * INR i / INR n)) with (2 * PI * IZR (Z.of_nat (b * i))).
      - apply expi_2PI.
      - rewrite <- INR_IZR_INZ, mult_INR, Eb, EM, !mult_INR.
        assert (INR M <> 0) by (apply not_0_INR; lia). assert (INR g <> 0) by (now apply not_0_INR). field. split; assumption. }
    now rewrite !T.
Qed.

(* ---- the maximum of W_1 on the cyclic graph ---- *)
Theorem ring_max n th : (3 <= n)%nat -> W1 n (ring_graph n) th <= 2 /\
  (W1 n (ring_graph n) th = 2 <-> forall j k, arc n (ring_graph n) j k -> cos (th j - th k) = -1).
Proof.
  intros Hn. pose proof (INR_pos n ltac:(lia)) as P.
  set (D := Sum n (fun k => Sum n (fun j => w (ring_graph n) k j * (1 + cos (th j - th k))))).
  assert (E : W1 n (ring_graph n) th = 2 - / (2 * INR n) * D).
  { assert (T : Sum n (fun k => Sum n (fun j => w (ring_graph n) k j * (1 - cos (th j - th k)))) = INR n * 4 - D).
    { unfold D. rewrite <- Sum_const, <- Sum_minus. apply Sum_ext; intros k Hk.
      pose proof (proj2 (ring_row n k Hn Hk)) as G. unfold deg in G.
      replace 4 with (2 * Sum n (w (ring_graph n) k)) by (rewrite G; ring). rewrite <- Sum_scal, <- Sum_minus. apply Sum_ext; intros; ring. }
    rewrite W1_arcs, T. field. lra. }
  assert (T : forall k j, 0 <= w (ring_graph n) k j * (1 + cos (th j - th k)))
    by (intros k j; pose proof (COS_bound (th j - th k)); apply Rmult_le_pos; [apply w_ge0|lra]).
  assert (D0 : 0 <= D) by (apply Sum_ge0; intros; apply Sum_ge0; intros; apply T).
  assert (F : 0 < / (2 * INR n)) by (apply Rinv_0_lt_compat; lra).
  rewrite E. split; [nra|]. split.
  - intros H j k [Hj [Hk A]]. assert (Z : D = 0) by nra.
    assert (Z1 : w (ring_graph n) k j * (1 + cos (th j - th k)) = 0).
    { apply (Sum_eq0 n (fun j => w (ring_graph n) k j * (1 + cos (th j - th k)))); try assumption; [intros; apply T|].
      apply (Sum_eq0 n (fun k => Sum n (fun j => w (ring_graph n) k j * (1 + cos (th j - th k))))); try assumption.
      intros; apply Sum_ge0; intros; apply T. }
    unfold w in Z1. rewrite A in Z1. lra.
  - intros H. replace D with 0; [ring|]. symmetry. unfold D. apply Sum_zero; intros k Hk; apply Sum_zero; intros j Hj.
    unfold w. destruct (ring_graph n k j) eqn:A; [|ring]. rewrite (H j k (conj Hj (conj Hk A))). ring.
Qed.
Lemma opposite s t : cos (s - t) = -1 -> expi s = (- expi t)%C.
Proof.
  intros H. replace (- expi t)%C with (expi (t + PI)).
  - apply expi_eq_cos. replace (s - (t + PI)) with ((s - t) - PI) by ring. rewrite cos_minus, H, cos_PI, sin_PI. ring.
  - unfold expi, Copp; cbn. now rewrite neg_cos, neg_sin.
Qed.
(* every maximiser is a balanced (2,N)-pattern, with alternating phases along the ring *)
Theorem ring_maximizer_pattern n th : (3 <= n)%nat -> W1 n (ring_graph n) th = 2 -> pattern 2 n th /\ balanced n th.
Proof.
  intros Hn H. pose proof (INR_pos n ltac:(lia)) as P. pose proof (proj1 (proj2 (ring_max n th Hn)) H) as A.
  assert (NX : forall k, (k < n)%nat -> arc n (ring_graph n) ((k + 1) mod n) k).
  { intros k Hk. repeat split; [apply Nat.mod_upper_bound; lia|assumption|]. unfold ring_graph, ring_offset.
    assert (X : (((k + 1) mod n + n - k) mod n = 1)%nat).
    { destruct (Nat.eq_dec (k + 1) n) as [E|E].
      - rewrite E, Nat.mod_same by lia. replace (0 + n - k)%nat with 1%nat by lia. apply Nat.mod_small. lia.
      - rewrite (Nat.mod_small (k + 1)) by lia. replace (k + 1 + n - k)%nat with (1 + 1 * n)%nat by lia. rewrite Nat.mod_add, Nat.mod_small; lia. }
    now rewrite X. }
  assert (PT : pattern 2 n th).
  { apply moments_pattern; try lia.
    - intros m Hm. replace m with 1%nat by lia. unfold moment.
      set (S0 := Csum n (fun k => expi (INR 1 * th k))).
      assert (R : Csum n (fun k => expi (INR 1 * th ((k + 1) mod n))) = S0).
      { unfold S0. rewrite <- (Csum_rotate n (n - 1) (fun k => expi (INR 1 * th k))) by lia. apply Csum_ext; intros k _.
        do 3 f_equal. replace (k + n - (n - 1))%nat with (k + 1)%nat by lia. reflexivity. }
      assert (N : Csum n (fun k => expi (INR 1 * th ((k + 1) mod n))) = (RtoC (-1) * S0)%C).
      { unfold S0. rewrite <- Csum_scal. apply Csum_ext; intros k Hk. cbn [INR]. rewrite !Rmult_1_l.
        rewrite (opposite _ _ (A _ _ (NX k Hk))). apply injective_projections; cbn; ring. }
      rewrite R in N. assert (Z : S0 = RtoC 0).
      { destruct S0 as [x y]. unfold Cmult in N; cbn in N. injection N as N1 N2. unfold RtoC. f_equal; lra. }
      rewrite Z. apply Cmult_0_r.
    - intros j k Hj Hk. apply (equal_along n (ring_graph n) (phasors (multiple 2 th))); [|apply ring_connected; lia].
      intros a b Hab. unfold phasors, multiple. replace (INR 2) with 2 by (cbn; ring).
      replace (2 * th a) with (th a + th a) by ring. replace (2 * th b) with (th b + th b) by ring.
      rewrite !expi_plus, (opposite _ _ (A a b Hab)). ring. }
  split; [exact PT|]. apply (pattern_balanced 2); [lia|lia|exact PT].
Qed.

(* ---- synchronized phases need not be a parallel formation ---- *)
Theorem sync_par_printed_fails : ~ forall n (th : nat -> R -> R) (om : nat -> R),
  (forall k t, (k < n)%nat -> is_derive (th k) t (om k)) -> (forall t, synchronized n (fun k => th k t)) ->
  (forall j k, (j < n)%nat -> (k < n)%nat -> om k - om j = 0) -> forall k, (k < n)%nat -> om k = 0.
Proof.
  intros H. assert (E : 1 = 0); [|lra]. apply (H 2%nat (fun _ t => t) (fun _ => 1)) with (k := 0%nat); try lia.
  - intros k t _. apply D_id.
  - intros t j k _ _. reflexivity.
  - intros; ring.
Qed.

(* synchronised at all times: one direction, which turns at the common rate; the formation is parallel where that is zero, and (9) and (14) make it w0 *)
Theorem sync_par n (th dth : nat -> R -> R) : (forall k t, (k < n)%nat -> is_derive (th k) t (dth k t)) -> (forall t, synchronized n (fun k => th k t)) ->
  (forall j k t, (j < n)%nat -> (k < n)%nat -> dth j t = dth k t) /\
  (forall k t, (k < n)%nat -> is_velocity (fun s => expi (th k s)) t (RtoC (dth k t) * (Ci * expi (th k t)))%C) /\
  (forall k t, (k < n)%nat -> (is_velocity (fun s => expi (th k s)) t (RtoC 0) <-> dth k t = 0)).
Proof.
  intros D S.
  assert (V : forall k t, (k < n)%nat -> is_velocity (fun s => expi (th k s)) t (RtoC (dth k t) * (Ci * expi (th k t)))%C) by (intros; now apply velocity_expi, D).
  assert (U : forall (z : R -> C) t a b, is_velocity z t a -> is_velocity z t b -> a = b).
  { intros z t a b [A1 A2] [B1 B2]. apply is_derive_unique in A1, A2, B1, B2. apply injective_projections; congruence. }
  assert (I : forall a b x, (RtoC a * (Ci * expi x))%C = (RtoC b * (Ci * expi x))%C -> a = b).
  { intros a b x E. assert (E1 := f_equal fst E). assert (E2 := f_equal snd E). cbn in E1, E2. pose proof (sin2_cos2 x) as T. unfold Rsqr in T.
    transitivity (a * (sin x * sin x + cos x * cos x)); [rewrite T; ring|]. transitivity (b * (sin x * sin x + cos x * cos x)); [|rewrite T; ring].
    assert (a * sin x = b * sin x) by lra. assert (a * cos x = b * cos x) by lra.
    rewrite !Rmult_plus_distr_l, <- !Rmult_assoc. congruence. }
  split; [|split; [exact V|]].
  - intros j k t Hj Hk. apply (I _ _ (th k t)). apply (U (fun s => expi (th k s)) t); [|now apply V].
    rewrite <- (S t j k Hj Hk). destruct (V j t Hj) as [A B]. split; [eapply is_derive_ext; [|exact A]|eapply is_derive_ext; [|exact B]]; intros s; cbv beta; now rewrite (S s j k Hj Hk).
  - intros k t Hk. split; intros H.
    + apply (I _ _ (th k t)). rewrite (U _ _ _ _ (V k t Hk) H). ring.
    + pose proof (V k t Hk) as P. rewrite H in P. now rewrite Cmult_0_l in P.
Qed.
(* phases that differ by multiples of pi do not move under (9) but by w0 *)
Theorem sines_rest n th w0 K k : (forall j, (j < n)%nat -> sin (th k - th j) = 0) -> w0 + - K * g1 n th k = w0.
Proof. intros Z. rewrite control9_sines, Sum_zero; [ring|exact Z]. Qed.
Theorem sync_rate n adj th w0 K k : (k < n)%nat -> synchronized n th ->
  w0 + - K * g1 n th k = w0 /\ w0 + K / INR n * gW n adj th k = w0.
Proof.
  intros Hk S. assert (Z : forall j, (j < n)%nat -> sin (th k - th j) = 0).
  { intros j Hj. pose proof (S k j Hk Hj) as E. unfold expi in E. injection E as E1 E2. rewrite sin_minus, E1, E2. ring. }
  split; [now apply sines_rest|].
  rewrite gW_sines, Sum_zero; [ring| |exact Hk]. intros j Hj. rewrite (Z j Hj). ring.
Qed.
(* two clusters in opposite directions, of any sizes *)
Corollary clusters_rest n th a w0 K k : (k < n)%nat -> (forall j, (j < n)%nat -> th j = a \/ th j = a + PI) -> w0 + - K * g1 n th k = w0.
Proof.
  intros Hk H. apply sines_rest. intros j Hj. destruct (H k Hk) as [-> | ->], (H j Hj) as [-> | ->].
  - replace (a - a) with 0 by ring. apply sin_0.
  - replace (a - (a + PI)) with (- PI) by ring. rewrite sin_neg, sin_PI. ring.
  - replace (a + PI - a) with PI by ring. apply sin_PI.
  - replace (a + PI - (a + PI)) with 0 by ring. apply sin_0.
Qed.

(* ---- the reference phase and the beacon ---- *)
Theorem reference n adj th0 th : (1 <= n)%nat -> 0 <= W1 n adj th + 1 - cos (th0 - th (n - 1)%nat) /\
  W1 n adj (fun _ => th0) + 1 - cos (th0 - th0) = 0.
Proof.
  intros Hn. pose proof (W1_ge0 n adj th Hn). pose proof (COS_bound (th0 - th (n - 1)%nat)). split; [lra|].
  rewrite (proj2 (W1_zero n adj (fun _ => th0) Hn)) by reflexivity. replace (th0 - th0) with 0 by ring. rewrite cos_0. ring.
Qed.
Definition beacon (n : nat) (c : nat -> C) (c0 : C) : R := / (2 * INR n) * Sum n (fun k => dist2 (c k) c0).
Theorem beacon_zero n c c0 : (1 <= n)%nat -> (beacon n c c0 = 0 <-> forall k, (k < n)%nat -> c k = c0).
Proof.
  intros Hn. pose proof (INR_pos n Hn). assert (F : / (2 * INR n) <> 0) by (apply Rinv_neq_0_compat; lra). unfold beacon. split.
  - intros E k Hk. apply dist2_0. apply (Sum_eq0 n (fun k => dist2 (c k) c0)); try assumption; [intros; apply dist2_ge0|].
    apply Rmult_integral in E as [E|E]; [contradiction|exact E].
  - intros E. rewrite Sum_zero; [ring|]. intros k Hk. now apply dist2_0, E.
Qed.
Theorem beacon_rate n w0 K0 c0 (r : nat -> R -> C) (th : nat -> R -> R) t : (1 <= n)%nat -> w0 <> 0 ->
  (forall k, (k < n)%nat -> is_velocity (r k) t (expi (th k t))) ->
  (forall k, (k < n)%nat -> is_derive (th k) t
     (w0 + w0 * (K0 / INR n * inner (expi (th k t)) (circle_centre w0 (r k t) (th k t) - c0)%C))) ->
  is_derive (fun s => beacon n (fun k => circle_centre w0 (r k s) (th k s)) c0) t
    (- (K0 / INR n ^ 2) * Sum n (fun k => inner (expi (th k t)) (circle_centre w0 (r k t) (th k t) - c0)%C ^ 2)).
Proof.
  intros Hn Hw R1 R2. pose proof (INR_pos n Hn). unfold beacon. eapply D_eq.
  - apply D_scal. apply (D_Sum n (fun k s => dist2 (circle_centre w0 (r k s) (th k s)) c0)
      (fun k => 2 * (- (K0 / INR n) * inner (expi (th k t)) (circle_centre w0 (r k t) (th k t) - c0)%C ^ 2))). intros k Hk.
    pose proof (eq18 w0 (r k) (th k) t _ (R1 k Hk) (R2 k Hk)) as [V1 V2].
    assert (V : is_velocity (fun s => circle_centre w0 (r k s) (th k s) - c0)%C t
      (expi (th k t) * RtoC (- (K0 / INR n) * inner (expi (th k t)) (circle_centre w0 (r k t) (th k t) - c0)%C))%C).
    { set (a := inner (expi (th k t)) _) in *. split.
      - apply (is_derive_ext (fun s => fst (circle_centre w0 (r k s) (th k s)) - fst c0)); [reflexivity|].
        eapply D_eq; [apply D_minus; [exact V1|apply D_const]|]. cbn. field. split; lra.
      - apply (is_derive_ext (fun s => snd (circle_centre w0 (r k s) (th k s)) - snd c0)); [reflexivity|].
        eapply D_eq; [apply D_minus; [exact V2|apply D_const]|]. cbn. field. split; lra. }
    eapply D_eq; [apply (D_inner _ _ t _ _ V V)|]. cbv beta. generalize (circle_centre w0 (r k t) (th k t) - c0)%C. intros x.
    rewrite !inner_xy. unfold Cmult, RtoC. cbn [fst snd]. ring.
  - rewrite !Sum_scal. field. lra.
Qed.

(* ---- the centre of mass stays in a ball of radius 1/|w0| ---- *)
Theorem centre_ball n w0 (r : nat -> R -> C) (th : nat -> R -> R) : (1 <= n)%nat -> w0 <> 0 ->
  (forall k t, (k < n)%nat -> is_velocity (r k) t (expi (th k t))) -> (forall k t, (k < n)%nat -> is_derive (th k) t w0) ->
  exists c : C, forall t, Cmod (centre n (fun k => r k t) - c)%C <= / Rabs w0.
Proof.
  intros Hn Hw R1 R2. exists (centre n (fun k => circle_centre w0 (r k 0) (th k 0))). intros t.
  pose proof (INR_pos n Hn). assert (A : 0 < / Rabs w0) by (apply Rinv_0_lt_compat; now apply Rabs_pos_lt).
  assert (E : (centre n (fun k => r k t) - centre n (fun k => circle_centre w0 (r k 0%R) (th k 0%R)))%C =
     ((RtoC (/ w0) * - Ci) * order n (fun k => th k t))%C).
  { replace (centre n (fun k => circle_centre w0 (r k 0) (th k 0))) with (centre n (fun k => circle_centre w0 (r k t) (th k t))).
    - unfold centre, order, circle_centre, phasors. rewrite Csum_plus, Csum_scal, Csum_scal. ring.
    - unfold centre. f_equal. apply Csum_ext; intros k Hk.
      apply (velocity_constant (fun s => circle_centre w0 (r k s) (th k s))). intros s.
      eapply velocity_eq; [apply eq18; [now apply R1|now apply R2]|]. apply injective_projections; cbn; field; assumption. }
  assert (CI : Cmod Ci = 1) by (unfold Cmod; cbn; replace (0 * (0 * 1) + 1 * (1 * 1)) with 1 by ring; apply sqrt_1).
  rewrite E, !Cmod_mult, Cmod_opp, CI, Cmod_R, Rabs_inv. pose proof (order_bounds n (fun k => th k t) Hn). nra.
Qed.

(* ---- the fish model ---- *)
(* (26) is a forward Euler step of (1), (2) only for the step 1 and T = 1 *)
Theorem eq26_step h T : (forall (r : C) (th u : R), (r + RtoC h * expi th)%C = (r + expi th)%C /\ th + h * u = th + T * u) <-> h = 1 /\ T = 1.
Proof.
  split.
  - intros H. destruct (H (RtoC 0) 0 1) as [A B]. injection A as A _. cbn in A. rewrite cos_0, sin_0 in A. split; lra.
  - intros [-> ->] r th u. split; [|reflexivity]. now rewrite Cmult_1_l.
Qed.
Corollary eq26_printed_fails T : T < 1 -> ~ exists h, forall (r : C) (th u : R),
  (r + RtoC h * expi th)%C = (r + expi th)%C /\ th + h * u = th + T * u.
Proof. intros HT [h H]. apply eq26_step in H. lra. Qed.
Definition unit_from (rk rj : C) : C := (RtoC (/ Cmod (rk - rj)) * (rk - rj))%C.                  (* rhat_kj *)
Definition v_rep (n : nat) (nbr : nat -> bool) (r : nat -> C) (k : nat) : C :=
  (- Csum n (fun j => RtoC (if nbr j then 1 else 0) * unit_from (r k) (r j)))%C.                   (* as printed *)
Definition v_att (n : nat) (nbr : nat -> bool) (r : nat -> C) (k : nat) : C :=
  Csum n (fun j => RtoC (if nbr j then 1 else 0) * unit_from (r k) (r j))%C.                       (* as printed *)
Lemma approach rk rj v : is_derive (fun s => dist2 (rk + RtoC s * v)%C rj) 0 (2 * inner v (rk - rj)%C).
Proof.
  apply (is_derive_ext (fun s => (fst rk + s * fst v - fst rj) ^ 2 + (snd rk + s * snd v - snd rj) ^ 2)).
  { intros s. rewrite dist2_xy. cbn. ring. }
  assert (A : forall a b c : R, is_derive (fun s : R => a + s * b - c) 0 b).
  { intros a b c. eapply D_eq; [apply D_minus; [apply D_plus; [apply D_const|]|apply D_const]|].
    - apply (is_derive_ext (fun s : R => b * s)); [intros; cbn; ring|apply D_scal, D_id].
    - ring. }
  eapply D_eq; [apply D_plus; apply D_sqr, A|]. rewrite inner_xy. cbn. ring.
Qed.
Lemma unit_from_inner rk rj : rk <> rj -> inner (unit_from rk rj) (rk - rj)%C = Cmod (rk - rj)%C.
Proof.
  intros N. assert (P : 0 < Cmod (rk - rj)%C).
  { apply Cmod_gt_0. intros E. apply N. replace rk with ((rk - rj) + rj)%C by ring. rewrite E. ring. }
  unfold unit_from. rewrite inner_sym, inner_scal, inner_self. field. lra.
Qed.
(* one neighbour, fish 1 of two: moving along the printed v_rep shortens the distance, along the printed v_att it grows *)
Theorem vrep_printed_attracts r : r 0%nat <> r 1%nat ->
  exists d, is_derive (fun s => dist2 (r 0%nat + RtoC s * v_rep 2 (fun j => Nat.eqb j 1) r 0)%C (r 1%nat)) 0 d /\ d < 0.
Proof.
  intros N. eexists. split; [apply approach|]. pose proof (unit_from_inner _ _ N) as U.
  assert (P : 0 < Cmod (r 0%nat - r 1%nat)%C).
  { apply Cmod_gt_0. intros E. apply N. replace (r 0%nat) with ((r 0%nat - r 1%nat) + r 1%nat)%C by ring. rewrite E. ring. }
  rewrite inner_xy in *. unfold v_rep, Csum. cbn [Sum fst snd Nat.eqb Copp]. set (u := unit_from (r 0%nat) (r 1%nat)) in *.
  set (d := (r 0%nat - r 1%nat)%C) in *. unfold Cmult, RtoC. cbn [fst snd]. nra.
Qed.
Theorem vatt_printed_repels r : r 0%nat <> r 1%nat ->
  exists d, is_derive (fun s => dist2 (r 0%nat + RtoC s * v_att 2 (fun j => Nat.eqb j 1) r 0)%C (r 1%nat)) 0 d /\ 0 < d.
Proof.
  intros N. eexists. split; [apply approach|]. pose proof (unit_from_inner _ _ N) as U.
  assert (P : 0 < Cmod (r 0%nat - r 1%nat)%C).
  { apply Cmod_gt_0. intros E. apply N. replace (r 0%nat) with ((r 0%nat - r 1%nat) + r 1%nat)%C by ring. rewrite E. ring. }
  rewrite inner_xy in *. unfold v_att, Csum. cbn [Sum fst snd Nat.eqb]. set (u := unit_from (r 0%nat) (r 1%nat)) in *.
  set (d := (r 0%nat - r 1%nat)%C) in *. unfold Cmult, RtoC. cbn [fst snd]. nra.
Qed.
(* (28): its K_att term steers along L_k r = sum (r_k - r_j), away from the neighbours *)
Theorem eq28_attraction_sign n att r th k : (k < n)%nat ->
  inner (Ci * expi th)%C (row n (lap n att) k r) = - inner (Ci * expi th)%C (Csum n (fun j => RtoC (w att k j) * (r j - r k))%C).
Proof.
  intros Hk. rewrite row_lap, !inner_Csum, <- Sum_opp by assumption. apply Sum_ext; intros j _. rewrite !inner_scal, !inner_minus. ring.
Qed.
(* the alignment term of (28) is that of (22) when K1 - K0 = - K_ori N; the spacing terms are Re (e^* L r) and Re ((i e)^* L r) *)
Theorem fish28_alignment n adj K0 K1 Kori th k : (1 <= n)%nat -> K1 - K0 = - Kori * INR n ->
  (K1 - K0) / INR n * gW n adj th k = - Kori * gW n adj th k.
Proof. intros Hn E. pose proof (INR_pos n Hn). rewrite E. field. lra. Qed.

(* (28), and (22) with matched gains: beside w0 and equal alignment terms one and the same spacing term, at e^{i theta_k} in (22) and at i e^{i theta_k} in (28) *)
Definition control28 (n : nat) (adj : graph) (w0 Kori Katt : R) (r : nat -> C) (th : nat -> R) (k : nat) : R :=
  w0 - Kori * gW n adj th k + Katt * inner (Ci * expi (th k))%C (row n (lap n adj) k r).
Theorem fish28_spacing n adj w0 K0 K1 Kori (r : nat -> R -> C) (th : nat -> R -> R) k t : (1 <= n)%nat -> w0 <> 0 -> K1 - K0 = - Kori * INR n ->
  let term z := w0 * K0 / INR n * inner z (row n (lap n adj) k (fun j => r j t)) in
  control5 n adj w0 K0 K1 r th t k = w0 - Kori * gW n adj (fun j => th j t) k + term (expi (th k t)) /\
  control28 n adj w0 Kori (w0 * K0 / INR n) (fun j => r j t) (fun j => th j t) k = w0 - Kori * gW n adj (fun j => th j t) k + term (Ci * expi (th k t))%C.
Proof.
  intros Hn Hw E. pose proof (INR_pos n Hn). cbv zeta. split; [|reflexivity]. rewrite (eq22 n adj w0 K0 K1 Hn Hw r th t k).
  rewrite E. field. lra.
Qed.

(* the chord between neighbours of M evenly spaced points on the unit circle *)
Theorem chord M : (1 <= M)%nat -> Cmod (expi (2 * PI / INR M) - expi 0)%C = 2 * sin (PI / INR M).
Proof.
  intros HM. pose proof (INR_pos M HM) as P. pose proof PI_RGT_0.
  assert (S : 0 <= sin (PI / INR M)).
  { apply sin_ge_0; [left; apply Rdiv_lt_0_compat; lra|]. apply (Rmult_le_reg_r (INR M)); [lra|].
    unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. apply (le_INR 1) in HM. cbn in HM. nra. }
  apply Rsqr_inj; [apply Cmod_ge_0|lra|]. rewrite !Rsqr_pow2, <- dist2_Cmod, dist2_xy. unfold expi; cbn [fst snd].
  replace (2 * PI / INR M) with (2 * (PI / INR M)) by (field; lra). rewrite sin_2a, cos_2a_sin, cos_0, sin_0.
  pose proof (sc2 (PI / INR M)). nra.
Qed.

(* ---- the scalings of the sidebar ---- *)
Theorem scale_complete_corrected n th : (2 <= n)%nat -> 2 / (INR (n - 1) + 1) * W1 n complete th = 1 - Cmod (order n th) ^ 2.
Proof.
  intros Hn. pose proof (INR_pos n ltac:(lia)). rewrite eq13 by lia. rewrite minus_INR by lia. unfold U1. cbn [INR]. field. lra.
Qed.
Theorem scale_complete_printed_fails n th : (2 <= n)%nat -> Cmod (order n th) <> 1 ->
  (2 / INR (n - 1) + 1) * W1 n complete th <> 1 - Cmod (order n th) ^ 2.
Proof.
  intros Hn NS E. rewrite <- (scale_complete_corrected n th Hn) in E.
  pose proof (order_bounds n th ltac:(lia)) as B. pose proof (INR_pos (n - 1) ltac:(lia)) as P. set (x := INR (n - 1)) in *.
  pose proof (eq13 n th ltac:(lia)) as W. unfold U1 in W. pose proof (INR_pos n ltac:(lia)).
  assert (W0 : 0 < W1 n complete th) by (rewrite W; set (m := Cmod _) in *; replace (INR n / 2 - INR n / 2 * m ^ 2) with (INR n / 2 * ((1 - m) * (1 + m))) by ring;
    apply Rmult_lt_0_compat; [lra|apply Rmult_lt_0_compat; lra]).
  assert (F : 2 / x + 1 = 2 / (x + 1)) by (apply (Rmult_eq_reg_r (W1 n complete th)); lra).
  assert (2 / (x + 1) < 2 / x) by (apply Rmult_lt_compat_l; [lra|]; apply Rinv_lt_contravar; [apply Rmult_lt_0_compat|]; lra). lra.
Qed.
(* no graph has a larger W_1 than the complete one *)
Lemma W1_le_complete n adj th : (1 <= n)%nat -> W1 n adj th <= W1 n complete th.
Proof.
  intros Hn. pose proof (INR_pos n Hn). rewrite !W1_arcs.
  apply Rmult_le_compat_l; [left; apply Rinv_0_lt_compat; lra|]. apply Sum_le; intros k _. apply Sum_le; intros j _.
  pose proof (COS_bound (th j - th k)). unfold w, complete. destruct (Nat.eqb_spec k j) as [<-|_]; cbn [negb].
  - replace (th k - th k) with 0 by ring. rewrite cos_0. destruct (adj k k); lra.
  - destruct (adj k j); lra.
Qed.
(* with out-degree m the range of W_1 is within [0, m] *)
Theorem W1_le_degree n adj th d : (1 <= n)%nat -> (forall k, (k < n)%nat -> deg n adj k = d) -> 0 <= W1 n adj th <= d.
Proof.
  intros Hn D. pose proof (INR_pos n Hn). split; [now apply W1_ge0|]. rewrite W1_arcs.
  apply Rle_trans with (/ (2 * INR n) * Sum n (fun _ => 2 * d)).
  - apply Rmult_le_compat_l; [left; apply Rinv_0_lt_compat; lra|]. apply Sum_le; intros k Hk. rewrite <- (D k Hk). unfold deg.
    rewrite <- Sum_scal. apply Sum_le; intros j _. pose proof (COS_bound (th j - th k)). pose proof (w_ge0 adj k j). nra.
  - rewrite Sum_const. right. field. lra.
Qed.
(* four fish on the corners of a square, two nearest neighbours each, neighbours in opposite directions: W_1 = 2 = n *)
Definition square (k : nat) : C := match k with 0%nat => (0, 0) | 1%nat => (1, 0) | 2%nat => (1, 1) | _ => (0, 1) end.
Definition nearest (n m : nat) (adj : graph) (r : nat -> C) :=
  forall k, (k < n)%nat -> adj k k = false /\ deg n adj k = INR m /\
    forall i j, (i < n)%nat -> (j < n)%nat -> i <> k -> adj k j = true -> adj k i = false -> Cmod (r j - r k)%C <= Cmod (r i - r k)%C.
(* all others as neighbours, whatever the positions *)
Theorem scale_all_neighbours n adj (r : nat -> C) th : (2 <= n)%nat -> nearest n (n - 1) adj r ->
  0 <= 2 / (INR (n - 1) + 1) * W1 n adj th <= 1.
Proof.
  intros Hn _. pose proof (INR_pos (n - 1) ltac:(lia)) as P. pose proof (order_bounds n th ltac:(lia)) as B.
  assert (F : 0 < 2 / (INR (n - 1) + 1)) by (apply Rdiv_lt_0_compat; lra).
  pose proof (W1_ge0 n adj th ltac:(lia)) as L. pose proof (W1_le_complete n adj th ltac:(lia)) as U.
  pose proof (scale_complete_corrected n th Hn) as C. split; [apply Rmult_le_pos; lra|].
  apply Rle_trans with (2 / (INR (n - 1) + 1) * W1 n complete th); [apply Rmult_le_compat_l; lra|]. rewrite C. nra.
Qed.
Definition alternating (k : nat) : R := if Nat.even k then 0 else PI.
Lemma square_nearest : nearest 4 2 (ring_graph 4) square.
Proof.
  intros k Hk. split; [|split].
  - destruct k as [|[|[|[|]]]]; reflexivity || lia.
  - rewrite (proj2 (ring_row 4 k ltac:(lia) Hk)). cbn. ring.
  - intros i j Hi Hj Hik A B. apply Rsqr_incr_0; try apply Cmod_ge_0. rewrite !Rsqr_pow2, <- !dist2_Cmod, !dist2_xy.
    destruct k as [|[|[|[|]]]]; try lia; destruct j as [|[|[|[|]]]]; try lia; try discriminate A;
    destruct i as [|[|[|[|]]]]; try lia; try discriminate B; cbn; lra.
Qed.
Theorem square_potential : W1 4 (ring_graph 4) alternating = 2.
Proof.
  apply ring_max; [lia|]. intros j k [Hj [Hk A]]. unfold alternating.
  destruct k as [|[|[|[|]]]]; try lia; destruct j as [|[|[|[|]]]]; try lia; try discriminate A; cbn [Nat.even];
  rewrite ?Rminus_0_r, ?Rminus_0_l, ?cos_neg; apply cos_PI.
Qed.
Theorem scale_printed_fails : ~ (forall n m adj r th, (1 <= m < n)%nat -> nearest n m adj r -> (2 / INR m + 1) * W1 n adj th <= 1) /\
  ~ (forall n m adj r th, (1 <= m < n)%nat -> nearest n m adj r -> 2 / (INR m + 1) * W1 n adj th <= 1).
Proof.
  split; intros H; specialize (H 4%nat 2%nat _ _ alternating ltac:(lia) square_nearest); rewrite square_potential in H; cbn in H; lra.
Qed.
(* three fish parallel and one opposite *)
Theorem fish_peak a : 2 / (INR 3 + 1) * W1 4 complete (fun k => if Nat.eqb k 0 then a + PI else a) = 75 / 100.
Proof.
  rewrite W1_arcs. unfold w, complete. cbn [Sum Nat.eqb negb]. cbn.
  replace (a - (a + PI)) with (- PI) by ring. replace (a + PI - a) with PI by ring. replace (a - a) with 0 by ring.
  rewrite ?cos_neg, cos_PI, cos_0. field.
Qed.

(* the difference of W_1/m for two graphs in which every node has m and m' neighbours *)
Definition arcs_mean (n : nat) (adj : graph) (th : nat -> R) : R :=
  Sum n (fun k => Sum n (fun j => w adj k j * (1 - cos (th j - th k)))) / Sum n (deg n adj).
Theorem figS3_difference n (g h : graph) (a b : nat) th : (1 <= n)%nat -> (1 <= a)%nat -> (1 <= b)%nat ->
  (forall k, (k < n)%nat -> deg n g k = INR a) -> (forall k, (k < n)%nat -> deg n h k = INR b) ->
  (0 < W1 n h th / INR b - W1 n g th / INR a <-> arcs_mean n g th < arcs_mean n h th).
Proof.
  intros Hn Ha Hb G H. pose proof (INR_pos n Hn) as Pn. pose proof (INR_pos a Ha) as Pa. pose proof (INR_pos b Hb) as Pb.
  assert (F : forall (f : graph) m, 0 < m -> (forall k, (k < n)%nat -> deg n f k = m) -> W1 n f th / m = arcs_mean n f th / 2).
  { intros f m Pm D. unfold arcs_mean. rewrite (Sum_ext n (deg n f) (fun _ => m) D), Sum_const, W1_arcs. field. lra. }
  rewrite (F g (INR a) Pa G), (F h (INR b) Pb H). split; lra.
Qed.
(* column m + 1 of the Fourier matrix on the ring: an eigenvector, and a symmetric pattern *)
Theorem fourier_column n m : (3 <= n)%nat -> eigenvector n (lap n (ring_graph n)) (RtoC (2 - 2 * cos (2 * PI * INR m / INR n))) (phasors (wave n m)) /\
  pattern (n / Nat.gcd n m) n (wave n m).
Proof.
  intros Hn. split; [|apply wave_pattern; lia]. rewrite <- (ring_eigenvalue n m Hn).
  exact (circulant_eigenvector n (ring_graph n) (ring_offset n) m ltac:(lia) (ring_circulant n)).
Qed.
(* every eigenvector of the ring with entries of modulus one is a symmetric pattern iff 4 does not divide the number of nodes *)
Theorem ring_patterns n : (3 <= n)%nat ->
  ((forall lam th, eigenvector n (lap n (ring_graph n)) lam (phasors th) -> exists M, pattern M n th) <-> ~ exists p, n = (4 * p)%nat).
Proof.
  intros Hn. split.
  - intros H [p ->]. destruct (H (RtoC 2) rhombus) as [M P]; [|now apply (rhombus_no_pattern (4 * p) M) in P; [|exists p; split; [lia|reflexivity]]].
    apply ring_antipodal; [lia|]. intros j. unfold phasors, rhombus. destruct rhombus_phasors as (A & B & C & D).
    assert (Cases : (j mod 4 = 0 /\ (j + 2) mod 4 = 2 \/ j mod 4 = 1 /\ (j + 2) mod 4 = 3 \/ j mod 4 = 2 /\ (j + 2) mod 4 = 0 \/ j mod 4 = 3 /\ (j + 2) mod 4 = 1)%nat).
    { rewrite <- (Nat.add_mod_idemp_l j 2 4) by lia. pose proof (Nat.mod_upper_bound j 4 ltac:(lia)). destruct (j mod 4)%nat as [|[|[|[|]]]]; cbn; try lia; tauto. }
    destruct Cases as [[E F]|[[E F]|[[E F]|[E F]]]]; rewrite E, F, ?A, ?B, ?C, ?D; apply injective_projections; cbn; field.
  - intros N4 lam th E. destruct (ring_unit_eigenvectors n th lam Hn E) as [(m & _ & H)|[F _]]; [|contradiction].
    destruct (wave_pattern n m ltac:(lia)) as [HM (t0 & cl & K & S)]. exists (n / Nat.gcd n m)%nat. split; [exact HM|]. exists (th 0%nat + t0), cl. split; [|exact S].
    intros k Hk. destruct (K k Hk) as [L V]. split; [exact L|]. rewrite (H k Hk), V, <- expi_plus. f_equal. ring.
Qed.
