(* Veerman, Stosic, Olvera, section 2: at which rate the platoons settle, and that f, g < 0 is necessary.
     veerman.lem1 (stabilisation in time), beyond.veerman.decay_rate. *)
From Coq Require Import Reals Lra Lia Psatz.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums veerman_complex veerman_stability veerman_lemma1 veerman_settling.
Open Scope R_scope.

Lemma lowest_range N : 0 < lowest N <= 1.
Proof.
  unfold lowest. pose proof (pos_INR N). pose proof PI_RGT_0.
  assert (A : 0 < PI / (2 * (INR N + 1)) <= PI / 2).
  { split; [apply Rdiv_lt_0_compat; lra|]. apply Rmult_le_compat_l; [lra|]. apply Rinv_le_contravar; lra. }
  assert (cos (PI / (2 * (INR N + 1))) < cos 0) by (apply cos_decreasing_1; lra). rewrite cos_0 in *.
  pose proof (cos_ge_0 (PI / (2 * (INR N + 1))) ltac:(lra) ltac:(lra)). lra.
Qed.

(* ---- front and back ---- *)
Section TwoSided.
Variables (f g r : R) (N : nat) (e d : nat -> R -> R).
Hypotheses (Hr : 0 < r) (Hf : - g * r <= - f) (Hg : 2 * r <= - g * lowest N).
Hypothesis (HE : errors N (force f g (back2 N)) e d).
Let v k t := d k t + r * e k t.
Definition energy (t : R) : R :=
  dot N (fun k => v k t) (fun k => v k t) + (- f + g * r) * dot N (fun k => e k t) (back2 N (fun k => e k t)) +
  r ^ 2 * dot N (fun k => e k t) (fun k => e k t).

Lemma energy_decays t : 0 <= t -> energy t <= energy 0 * exp (- (2 * r) * t).
Proof using HE Hg Hr.
  destruct HE as [Z D].
  assert (De : forall k t, (k <= S N)%nat -> 0 <= t -> is_derive (e k) t (d k t)).
  { intros [|k] s Hk Hs; [|apply D; lia || exact Hs]. destruct (Z s) as [_ ->].
    apply (is_derive_ext (fun _ => 0)); [intros x; symmetry; apply Z|apply D_const]. }
  set (P := fun t => back2 N (fun k => e k t)). set (v' := fun t k => force f g (back2 N) (fun j => e j t) (fun j => d j t) k + r * d k t).
  assert (Dv : forall k t, (1 <= k <= S N)%nat -> 0 <= t -> is_derive (v k) t (v' t k)).
  { intros k s Hk Hs. unfold v, v'. apply D_plus; [now apply D|]. apply (D_scal r (e k)). apply De; [lia|exact Hs]. }
  set (rate := fun t => (dot N (v' t) (fun k => v k t) + dot N (fun k => v k t) (v' t)) +
    (- f + g * r) * (dot N (fun k => d k t) (P t) + dot N (fun k => e k t) (back2 N (fun k => d k t))) +
    r ^ 2 * (dot N (fun k => d k t) (fun k => e k t) + dot N (fun k => e k t) (fun k => d k t))).
  apply (gronwall energy rate); clear t; intros t Ht.
  - unfold energy, rate. apply D_plus; [apply D_plus|].
    + apply (D_dot N v v); intros; now apply Dv.
    + apply (D_scal _ (fun s => dot N (fun k => e k s) (back2 N (fun k => e k s)))).
      apply (D_dot N e (fun k s => back2 N (fun j => e j s) k) (fun k => d k t) (back2 N (fun k => d k t)));
        intros k Hk; [apply De; [lia|exact Ht]|]. apply (D_back2 N e (fun k => d k t)); [exact Hk|].
      intros j Hj. now apply De.
    + apply (D_scal _ (fun s => dot N (fun k => e k s) (fun k => e k s))). apply (D_dot N e e); intros; apply De; lia || exact Ht.
  - set (vt := fun k => v k t). set (et := fun k => e k t).
    assert (V0 : vt 0%nat = 0) by (unfold vt, v; destruct (Z t) as [-> ->]; ring). assert (E0 : et 0%nat = 0) by apply Z.
    (* d = v - r e;  v' = -(|f| - |g| r) P e - |g| P v + r v - r^2 e *)
    assert (Dd : forall a, dot N a (fun k => d k t) = dot N a vt - r * dot N a et).
    { intros a. rewrite (dot_ext N a _ (fun k => 1 * vt k + - r * et k)) by (intros; unfold vt, et, v; ring). rewrite dot_lin. ring. }
    assert (Pd : forall a, dot N a (back2 N (fun k => d k t)) = dot N a (back2 N vt) - r * dot N a (back2 N et)).
    { intros a. rewrite (dot_ext N a _ (fun k => 1 * back2 N vt k + - r * back2 N et k)).
      - rewrite dot_lin. ring.
      - intros k Hk. rewrite <- back2_lin. unfold back2, vt, et, v. destruct (Nat.eqb k (S N)); ring. }
    assert (Dv' : forall a, dot N a (v' t) = f * dot N a (back2 N et) + g * dot N a (back2 N (fun k => d k t)) + r * dot N a (fun k => d k t)).
    { intros a. rewrite (dot_ext N a _ (fun k => 1 * (f * back2 N et k + g * back2 N (fun k => d k t) k) + r * d k t)).
      - rewrite dot_lin, dot_lin. ring.
      - intros k Hk. unfold v', force, et. ring. }
    pose proof (poincare N vt V0) as PV.
    unfold rate, energy. fold vt et. change (P t) with (back2 N et).
    rewrite (dot_sym N (v' t)), (dot_sym N (fun k => d k t) (back2 N et)), (dot_sym N (fun k => d k t) et), !Dv', !Pd, !Dd.
    rewrite (dot_sym N (back2 N et) vt), (dot_sym N (back2 N et) et), (dot_sym N et vt), (back2_sym N et vt E0 V0).
    set (vv := dot N vt vt) in *. set (vPv := dot N vt (back2 N vt)) in *. set (vPe := dot N vt (back2 N et)).
    set (ePe := dot N et (back2 N et)). set (ve := dot N vt et). set (ee := dot N et et).
    pose proof (lowest_range N) as LR. assert (G : 0 <= - g).
    { apply Rnot_lt_le. intros G. assert (0 < g * lowest N) by (apply Rmult_lt_0_compat; lra). lra. }
    assert (0 <= vv) by apply dot_ge0. assert (0 <= - g * (vPv - lowest N * vv)) by (apply Rmult_le_pos; lra).
    assert (0 <= (- g * lowest N - 2 * r) * vv) by (apply Rmult_le_pos; lra). nra.
Qed.

Lemma energy_bounds t : r ^ 2 * dot N (fun k => e k t) (fun k => e k t) <= energy t /\ dot N (fun k => v k t) (fun k => v k t) <= energy t.
Proof using HE Hf.
  unfold energy. destruct HE as [Z _]. set (et := fun k => e k t).
  assert (Q : 0 <= dot N et (back2 N et)).
  { rewrite by_parts by apply Z. apply Rmult_le_pos; [lra|]. apply Sum_ge0. intros i _. apply Rle_0_sqr. }
  assert (0 <= (- f + g * r) * dot N et (back2 N et)) by (apply Rmult_le_pos; lra).
  pose proof (dot_ge0 N et). pose proof (dot_ge0 N (fun k => v k t)). pose proof (pow2_ge_0 r).
  assert (0 <= r ^ 2 * dot N et et) by (apply Rmult_le_pos; lra). lra.
Qed.
(* every car, with the constant in terms of the energy at the start *)
Lemma two_sided_bounds k t : (1 <= k <= S N)%nat -> 0 <= t ->
  Rabs (e k t) <= sqrt (2 * energy 0) / r * exp (- r * t) /\ Rabs (d k t) <= 2 * sqrt (2 * energy 0) * exp (- r * t).
Proof using HE Hf Hg Hr.
  intros Hk Ht. pose proof (energy_decays t Ht) as D. destruct (energy_bounds t) as [B1 B2]. destruct (energy_bounds 0) as [B0 _].
  pose proof (dot_ge0 N (fun k => e k 0)). pose proof (pow2_ge_0 r).
  assert (E0 : 0 <= 2 * energy 0). { assert (0 <= r ^ 2 * dot N (fun k => e k 0) (fun k => e k 0)) by (apply Rmult_le_pos; lra). lra. }
  pose proof (dot_term N (fun k => e k t) k Hk) as T1. pose proof (dot_term N (fun k => v k t) k Hk) as T2. cbv beta in T1, T2.
  assert (X : Rabs (r * e k t) <= sqrt (2 * energy 0) * exp (- r * t)).
  { apply root_bound; [exact E0|]. assert (r ^ 2 * (/ 2 * e k t ^ 2) <= r ^ 2 * dot N (fun k => e k t) (fun k => e k t)) by (apply Rmult_le_compat_l; lra).
    replace ((r * e k t) ^ 2) with (2 * (r ^ 2 * (/ 2 * e k t ^ 2))) by field. lra. }
  assert (Y : Rabs (v k t) <= sqrt (2 * energy 0) * exp (- r * t)) by (apply root_bound; [exact E0|lra]).
  split.
  - rewrite Rabs_mult, (Rabs_right r) in X by lra. apply (Rmult_le_reg_l r); [exact Hr|].
    replace (r * (sqrt (2 * energy 0) / r * exp (- r * t))) with (sqrt (2 * energy 0) * exp (- r * t)) by (field; lra). exact X.
  - replace (d k t) with (v k t + - (r * e k t)) by (unfold v; ring).
    eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_Ropp. lra.
Qed.
End TwoSided.

Theorem two_sided_settles f g r N h x u : 0 < r -> - g * r <= - f -> 2 * r <= - g * lowest N ->
  system_2 f g N h x u -> leader_cruises x u -> settles_at_rate r N h x u.
Proof.
  intros Hr Hf Hg HS HL. destruct (errors_of f g N h x u HL) as (e & d & A & _ & B). specialize (B HS).
  set (s := sqrt (2 * energy f g r N e d 0)). assert (S0 : 0 <= s) by apply sqrt_pos.
  assert (S1 : 0 <= s / r) by (apply Rmult_le_pos; [exact S0|left; now apply Rinv_0_lt_compat]).
  exists (s / r + 2 * s). intros k t Hk Ht. destruct (A k t Hk Ht) as [<- <-].
  destruct (two_sided_bounds f g r N e d Hr Hf Hg B k t Hk Ht) as [X Y]. fold s in X, Y.
  pose proof (exp_pos (- r * t)). assert (0 <= s / r * exp (- r * t)) by (apply Rmult_le_pos; lra).
  assert (0 <= s * exp (- r * t)) by (apply Rmult_le_pos; lra). split; lra.
Qed.

(* ---- front only: one rate for all N ---- *)
Section OneSided.
Variables (f g r : R) (N : nat) (e d : nat -> R -> R).
Hypotheses (Hr : 0 <= r) (Hg : 2 * r < - g) (Hq : 0 < - f + g * r + r ^ 2).
Hypothesis (HE : errors N (force f g back1) e d).
Let q := - f + g * r + r ^ 2.
Let v k t := d k t + r * e k t.
Let H k t := v k t ^ 2 + q * e k t ^ 2.
(* what a car passes on *)
Definition passed : R := (2 * (- f + g * r) ^ 2 / q + 2 * g ^ 2) / (2 * (- g - 2 * r)).
Let H' k t := 2 * v k t * (force f g back1 (fun j => e j t) (fun j => d j t) k + r * d k t) + q * (2 * e k t * d k t).

Lemma car_derive k t : (1 <= k <= S N)%nat -> 0 <= t -> is_derive (H k) t (H' k t).
Proof using HE.
  destruct HE as [_ D]. intros Hk Ht. destruct (D k t Hk Ht) as [De Dd]. unfold H, H', v. apply D_plus.
  - apply (D_sqr (fun s => d k s + r * e k s)). apply D_plus; [exact Dd|now apply (D_scal r (e k))].
  - apply (D_scal q (fun s => e k s ^ 2)). now apply (D_sqr (e k)).
Qed.
Lemma car_rate k t : H' (S k) t <= - (2 * r) * H (S k) t + passed * H k t.
Proof using Hg Hq.
  unfold H, H', force, back1. replace (S k - 1)%nat with k by lia.
  set (V := v (S k) t). set (W := v k t). set (x := e (S k) t). set (y := e k t).
  replace (d (S k) t) with (V - r * x) by (unfold V, x, v; ring). replace (d k t) with (W - r * y) by (unfold W, y, v; ring).
  set (D := (- f + g * r) * y + - g * W). set (p := - g - 2 * r). assert (P : 0 < p) by (unfold p; lra).
  assert (E : 2 * V * (f * (x - y) + g * (V - r * x - (W - r * y)) + r * (V - r * x)) + q * (2 * x * (V - r * x)) =
    - (2 * r) * (V ^ 2 + q * x ^ 2) - 2 * p * V ^ 2 + 2 * V * D) by (unfold q, p, D; ring).
  rewrite E. clear E.
  assert (Y : 2 * V * D - 2 * p * V ^ 2 <= D ^ 2 / (2 * p)).
  { assert (I : D ^ 2 / (2 * p) - 2 * V * D + 2 * p * V ^ 2 = (D - 2 * p * V) ^ 2 / (2 * p)) by (field; lra).
    assert (0 <= (D - 2 * p * V) ^ 2 / (2 * p)); [|lra]. apply Rmult_le_pos; [apply pow2_ge_0|]. left. apply Rinv_0_lt_compat. lra. }
  assert (B : D ^ 2 <= (2 * (- f + g * r) ^ 2 / q + 2 * g ^ 2) * (W ^ 2 + q * y ^ 2)).
  { set (b := - f + g * r) in *. pose proof (pow2_ge_0 (b * y - - g * W)). fold q in Hq.
    assert (I : (2 * b ^ 2 / q + 2 * g ^ 2) * (W ^ 2 + q * y ^ 2) = 2 * b ^ 2 * y ^ 2 + 2 * g ^ 2 * W ^ 2 + (2 * b ^ 2 / q * W ^ 2 + 2 * g ^ 2 * q * y ^ 2))
      by (field; lra).
    assert (0 <= 2 * b ^ 2 / q * W ^ 2).
    { apply Rmult_le_pos; [|apply pow2_ge_0]. apply Rmult_le_pos; [pose proof (pow2_ge_0 b); lra|]. left. now apply Rinv_0_lt_compat. }
    assert (0 <= 2 * g ^ 2 * q * y ^ 2).
    { apply Rmult_le_pos; [|apply pow2_ge_0]. apply Rmult_le_pos; [pose proof (pow2_ge_0 g)|]; lra. }
    rewrite I. unfold D. nra. }
  assert (M : D ^ 2 / (2 * p) <= passed * (W ^ 2 + q * y ^ 2)).
  { unfold passed. fold p. unfold Rdiv at 2. replace ((2 * (- f + g * r) ^ 2 / q + 2 * g ^ 2) * / (2 * p) * (W ^ 2 + q * y ^ 2))
      with ((2 * (- f + g * r) ^ 2 / q + 2 * g ^ 2) * (W ^ 2 + q * y ^ 2) / (2 * p)) by (field; split; [lra|fold q in Hq; lra]).
    apply Rmult_le_compat_r; [left; apply Rinv_0_lt_compat; lra|exact B]. }
  lra.
Qed.
Lemma passed_ge0 : 0 <= passed.
Proof using Hg Hq.
  unfold passed. apply Rmult_le_pos; [|left; apply Rinv_0_lt_compat; lra]. pose proof (pow2_ge_0 g).
  assert (0 <= 2 * (- f + g * r) ^ 2 / q); [|lra]. apply Rmult_le_pos; [pose proof (pow2_ge_0 (- f + g * r)); lra|].
  left. now apply Rinv_0_lt_compat.
Qed.
Lemma Sum_first n F : Sum (S n) F = F 0%nat + Sum n (fun i => F (S i)).
Proof. induction n as [|n IH]; [cbn [Sum]; ring|]. cbn [Sum] in IH |- *. lra. Qed.
Lemma all_cars dl t : 0 < dl -> 0 <= t ->
  Sum (S N) (fun i => dl ^ i * H (S i) t) <= Sum (S N) (fun i => dl ^ i * H (S i) 0) * exp (- (2 * r - passed * dl) * t).
Proof using HE Hg Hq.
  intros Hd Ht. pose proof passed_ge0 as P0. assert (H0 : forall k t, 0 <= H k t).
  { intros k s. unfold H. pose proof (pow2_ge_0 (v k s)). assert (0 <= q * e k s ^ 2) by (apply Rmult_le_pos; [unfold q; lra|apply pow2_ge_0]). lra. }
  apply (gronwall (fun t => Sum (S N) (fun i => dl ^ i * H (S i) t)) (fun t => Sum (S N) (fun i => dl ^ i * H' (S i) t))); [| |exact Ht].
  - intros s Hs. apply (D_Sum (S N) (fun i s => dl ^ i * H (S i) s)). intros i Hi. apply (D_scal (dl ^ i) (H (S i))). apply car_derive; [lia|exact Hs].
  - intros s _.
    apply Rle_trans with (Sum (S N) (fun i => (- (2 * r)) * (dl ^ i * H (S i) s) + passed * (dl ^ i * H i s))).
    + apply Sum_le. intros i _. assert (0 < dl ^ i) by now apply pow_lt. pose proof (car_rate i s) as C.
      apply (Rmult_le_compat_l (dl ^ i)) in C; lra.
    + rewrite Sum_plus, !Sum_scal, (Sum_first N (fun i => dl ^ i * H i s)).
      assert (Z : H 0%nat s = 0) by (unfold H, v; destruct (proj1 HE s) as [-> ->]; ring).
      rewrite Z, (Sum_ext N (fun i => dl ^ S i * H (S i) s) (fun i => dl * (dl ^ i * H (S i) s))) by (intros; cbn [pow]; ring).
      rewrite Sum_scal. cbn [Sum]. set (T := Sum N _). pose proof (H0 (S N) s). assert (0 < dl ^ N) by now apply pow_lt.
      assert (0 <= dl * (dl ^ N * H (S N) s)) by (apply Rmult_le_pos; [lra|apply Rmult_le_pos; lra]).
      assert (0 <= passed * (dl * (dl ^ N * H (S N) s))) by (apply Rmult_le_pos; assumption). lra.
Qed.
End OneSided.

Theorem one_sided_settles f g s N h x u : g < 0 -> 0 <= s -> 2 * s < - g -> 0 < - f + g * s + s ^ 2 ->
  system_1 f g N h x u -> leader_cruises x u -> settles_at_rate s N h x u.
Proof.
  intros Gn Hs Hg Hq HS HL. destruct (errors_of f g N h x u HL) as (e & d & A & B & _). specialize (B HS).
  set (eta := Rmin ((- g - 2 * s) / 4) ((- f + g * s + s ^ 2) / (2 * - g))).
  assert (Q1 : 0 < (- f + g * s + s ^ 2) / (2 * - g)) by (apply Rdiv_lt_0_compat; lra).
  assert (E0 : 0 < eta) by (unfold eta; apply Rmin_glb_lt; lra).
  assert (E1 : eta <= (- g - 2 * s) / 4) by apply Rmin_l.
  assert (E2 : - g * eta <= (- f + g * s + s ^ 2) / 2).
  { apply Rle_trans with (- g * ((- f + g * s + s ^ 2) / (2 * - g))); [apply Rmult_le_compat_l; [lra|apply Rmin_r]|]. right. field. lra. }
  set (r := s + eta). assert (R0 : 0 <= r) by (unfold r; lra). assert (R1 : 2 * r < - g) by (unfold r; lra).
  assert (R2 : 0 < - f + g * r + r ^ 2).
  { unfold r. assert (0 <= s * eta) by (apply Rmult_le_pos; lra). pose proof (pow2_ge_0 eta). nra. }
  pose proof (passed_ge0 f g r R1 R2) as P0. set (p := passed f g r) in *.
  set (dl := Rmin 1 (2 * eta / (p + 1))).
  assert (L0 : 0 < 2 * eta / (p + 1)) by (apply Rdiv_lt_0_compat; lra).
  assert (D0 : 0 < dl) by (unfold dl; apply Rmin_glb_lt; lra). assert (D1 : dl <= 1) by apply Rmin_l.
  assert (D2 : p * dl <= 2 * eta).
  { apply Rle_trans with (p * (2 * eta / (p + 1))); [apply Rmult_le_compat_l; [exact P0|apply Rmin_r]|].
    apply (Rmult_le_reg_r (p + 1)); [lra|]. replace (p * (2 * eta / (p + 1)) * (p + 1)) with (2 * eta * p) by (field; lra).
    assert (0 <= 2 * eta * 1) by lra. lra. }
  set (q := - f + g * r + r ^ 2) in *.
  set (H := fun k t => (d k t + r * e k t) ^ 2 + q * e k t ^ 2).
  assert (H0 : forall k t, 0 <= H k t).
  { intros k t. unfold H. pose proof (pow2_ge_0 (d k t + r * e k t)). assert (0 <= q * e k t ^ 2) by (apply Rmult_le_pos; [lra|apply pow2_ge_0]). lra. }
  set (W := Sum (S N) (fun i => dl ^ i * H (S i) 0)).
  assert (W0 : 0 <= W) by (apply Sum_ge0; intros; apply Rmult_le_pos; [now apply pow_le, Rlt_le|apply H0]).
  set (K := W / dl ^ N). assert (DN : 0 < dl ^ N) by now apply pow_lt.
  assert (K0 : 0 <= K) by (apply Rmult_le_pos; [exact W0|left; now apply Rinv_0_lt_compat]).
  assert (B1 : forall k t, (1 <= k <= S N)%nat -> 0 <= t -> H k t <= K * exp (- (2 * s) * t)).
  { intros k t Hk Ht. destruct k as [|i]; [lia|].
    pose proof (all_cars f g r N e d R1 R2 B dl t D0 Ht) as T. fold p in T. fold q in T.
    change (Sum (S N) (fun i => dl ^ i * H (S i) t) <= W * exp (- (2 * r - p * dl) * t)) in T.
    assert (X : exp (- (2 * r - p * dl) * t) <= exp (- (2 * s) * t)).
    { assert (Y : - (2 * r - p * dl) * t <= - (2 * s) * t) by (apply Rmult_le_compat_r; [exact Ht|unfold r; lra]).
      destruct Y as [Y|Y]; [left; now apply exp_increasing|rewrite Y; right; reflexivity]. }
    pose proof (Sum_term_le (S N) (fun i => dl ^ i * H (S i) t) i) as M. cbv beta in M.
    specialize (M ltac:(intros; apply Rmult_le_pos; [now apply pow_le, Rlt_le|apply H0]) ltac:(lia)).
    assert (Pw : dl ^ N <= dl ^ i).
    { replace N with (i + (N - i))%nat by lia. rewrite pow_add. assert (0 < dl ^ i) by now apply pow_lt.
      assert (dl ^ (N - i) <= 1) by (rewrite <- (pow1 (N - i)); apply pow_incr; lra).
      rewrite <- (Rmult_1_r (dl ^ i)) at 2. apply Rmult_le_compat_l; lra. }
    assert (dl ^ N * H (S i) t <= dl ^ i * H (S i) t) by (apply Rmult_le_compat_r; [apply H0|exact Pw]).
    assert (W * exp (- (2 * r - p * dl) * t) <= W * exp (- (2 * s) * t)) by (apply Rmult_le_compat_l; assumption).
    apply (Rmult_le_reg_l (dl ^ N)); [exact DN|]. unfold K. replace (dl ^ N * (W / dl ^ N * exp (- (2 * s) * t))) with (W * exp (- (2 * s) * t)) by (field; lra). lra. }
  exists (sqrt (K / q) + (sqrt K + r * sqrt (K / q))). intros k t Hk Ht. destruct (A k t Hk Ht) as [<- <-].
  specialize (B1 k t Hk Ht). unfold H in B1. pose proof (pow2_ge_0 (d k t + r * e k t)). pose proof (pow2_ge_0 (e k t)).
  assert (0 <= q * e k t ^ 2) by (apply Rmult_le_pos; lra). pose proof (exp_pos (- s * t)) as EP.
  assert (KQ : 0 <= K / q) by (apply Rmult_le_pos; [exact K0|left; now apply Rinv_0_lt_compat]).
  assert (X : Rabs (e k t) <= sqrt (K / q) * exp (- s * t)).
  { apply root_bound; [exact KQ|]. apply (Rmult_le_reg_l q); [exact R2|].
    replace (q * (K / q * exp (- (2 * s) * t))) with (K * exp (- (2 * s) * t)) by (field; lra). lra. }
  assert (Y : Rabs (d k t + r * e k t) <= sqrt K * exp (- s * t)) by (apply root_bound; [exact K0|lra]).
  pose proof (sqrt_pos K). pose proof (sqrt_pos (K / q)).
  assert (0 <= r * sqrt (K / q) * exp (- s * t)) by (repeat apply Rmult_le_pos; lra).
  assert (0 <= sqrt K * exp (- s * t)) by (apply Rmult_le_pos; lra).
  assert (0 <= sqrt (K / q) * exp (- s * t)) by (apply Rmult_le_pos; lra).
  split; [lra|].
  replace (d k t) with ((d k t + r * e k t) + - (r * e k t)) by ring. eapply Rle_trans; [apply Rabs_triang|].
  rewrite Rabs_Ropp, Rabs_mult, (Rabs_right r) by lra. apply (Rmult_le_compat_l r) in X; lra.
Qed.
