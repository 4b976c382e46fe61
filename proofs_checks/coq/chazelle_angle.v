(* Chazelle, (3.15) from above with the best constant: the angle of (v, 1) and (w, 1) is at most |v - w|.
     beyond.chazelle.angle (with w = x/t), chazelle.eq3.15. *)
From Coq Require Import Reals Lra Lia Psatz.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums chazelle_worked.
Open Scope R_scope.

(* h cos h <= sin h *)
Lemma tangent h : 0 <= h <= PI -> h * cos h <= sin h.
Proof.
  intros H. assert (- (sin h - h * cos h) <= - (sin 0 - 0 * cos 0)); [|rewrite sin_0 in *; lra].
  apply (decreasing (fun x => - (sin x - x * cos x)) (fun x => - (x * sin x)) 0 h (proj1 H)).
  - intros x Hx. eapply D_eq; [apply D_opp, D_minus; [apply is_derive_sin|apply (D_mult (fun x => x) cos); [apply D_id|apply is_derive_cos]]|]. ring.
  - intros x Hx. pose proof (sin_ge_0 x ltac:(lra) ltac:(lra)). nra.
Qed.
(* cos D <= (1 - q)/(1 + q) with q = (D/2)^2 *)
Lemma cos_below D : 0 <= D <= PI -> cos D * (1 + (D / 2) ^ 2) <= 1 - (D / 2) ^ 2.
Proof.
  intros H. set (h := D / 2). assert (Hh : 0 <= h <= PI / 2) by (unfold h; lra). pose proof PI_RGT_0.
  pose proof (tangent h ltac:(lra)) as T. pose proof (cos_ge_0 h ltac:(lra) ltac:(lra)) as C0. pose proof (sin2_cos2 h) as SC. unfold Rsqr in SC.
  replace D with (2 * h) by (unfold h; lra). rewrite cos_2a_sin.
  assert (Q : (h * cos h) * (h * cos h) <= sin h * sin h) by (apply Rmult_le_compat; nra).
  assert (h ^ 2 * (1 - sin h * sin h) <= sin h * sin h); [|lra].
  replace (1 - sin h * sin h) with (cos h * cos h) by lra. lra.
Qed.
Theorem angle_le d v w : angle d v w <= chazelle_worked.norm d (diff v w).
Proof.
  set (n := chazelle_worked.norm d (diff v w)). assert (N0 : 0 <= n) by apply sqrt_pos.
  pose proof (dotp_sq d v) as V0. pose proof (dotp_sq d w) as W0.
  assert (N2 : n * n = dotp d v v - 2 * dotp d v w + dotp d w w).
  { unfold n, chazelle_worked.norm. rewrite sqrt_sqrt by apply dotp_sq. unfold diff. rewrite dotp_lin. ring. }
  assert (SUM : 0 <= dotp d v v + 2 * dotp d v w + dotp d w w).
  { pose proof (dotp_sq d (fun k => 1 * v k + 1 * w k)) as K. rewrite dotp_lin in K. lra. }
  pose proof (lagrange d v w) as LG.
  destruct (Rle_lt_dec PI n) as [Big|Small].
  { unfold angle. set (c := _ / _). pose proof (acos_bound c). lra. }
  unfold angle. set (p := sqrt (ldot d v v)). set (q := sqrt (ldot d w w)). set (s := ldot d v w).
  assert (P2 : p * p = 1 + dotp d v v) by (unfold p, ldot; rewrite sqrt_sqrt; lra).
  assert (Q2 : q * q = 1 + dotp d w w) by (unfold q, ldot; rewrite sqrt_sqrt; lra).
  assert (P1 : 1 <= p) by (unfold p, ldot; apply Rle_trans with (sqrt 1); [rewrite sqrt_1; lra | apply sqrt_le_1_alt; lra]).
  assert (Q1 : 1 <= q) by (unfold q, ldot; apply Rle_trans with (sqrt 1); [rewrite sqrt_1; lra | apply sqrt_le_1_alt; lra]).
  assert (S : dotp d v w = s - 1) by (unfold s, ldot; ring). rewrite S in *.
  set (g := (n / 2) ^ 2). assert (G0 : 0 <= g) by apply pow2_ge_0.
  assert (G : n * n = 4 * g) by (unfold g; field).
  assert (PQ : 1 <= p * q) by nra.
  assert (SG : 1 - g <= s) by lra.
  (* the Gram determinant of the lifted vectors *)
  assert (Gram : s ^ 2 + 4 * g <= (p * q) ^ 2).
  { replace ((p * q) ^ 2) with ((p * p) * (q * q)) by ring. rewrite P2, Q2. nra. }
  assert (Mean : p * q <= s + 2 * g) by (pose proof (pow2_ge_0 (p - q)); nra).
  set (c := s / (p * q)). assert (CE : c * (p * q) = s) by (unfold c; field; nra).
  assert (C1 : -1 <= c <= 1).
  { assert (c ^ 2 <= 1); [|nra]. rewrite <- CE in Gram. assert (0 < (p * q) ^ 2) by (apply pow_lt; lra).
    replace ((c * (p * q)) ^ 2) with (c ^ 2 * (p * q) ^ 2) in Gram by ring. nra. }
  assert (Key : (1 - g) <= c * (1 + g)).
  { apply (Rmult_le_reg_r (p * q)); [lra|]. replace (c * (1 + g) * (p * q)) with ((1 + g) * (c * (p * q))) by ring. rewrite CE.
    destruct (Rle_lt_dec 1 g) as [L|L].
    - destruct (Rle_lt_dec 0 s) as [T|T]; [assert (0 <= (g - 1) * (p * q)) by (apply Rmult_le_pos; lra); nra|].
      assert (A : (- s) ^ 2 * (1 + g) ^ 2 <= (g - 1) ^ 2 * (p * q) ^ 2).
      { apply Rle_trans with ((g - 1) ^ 2 * (s ^ 2 + 4 * g)); [|apply Rmult_le_compat_l; [apply pow2_ge_0|lra]].
        assert (s ^ 2 <= (g - 1) ^ 2) by nra. nra. }
      assert (B : - s * (1 + g) <= (g - 1) * (p * q)); [|lra].
      apply Rsqr_incr_0; [unfold Rsqr; nra|nra|apply Rmult_le_pos; lra].
    - apply Rle_trans with ((1 - g) * (s + 2 * g)); [apply Rmult_le_compat_l; lra|]. nra. }
  assert (CC : cos n <= c).
  { pose proof (cos_below n ltac:(lra)) as K. fold g in K. apply (Rmult_le_reg_r (1 + g)); lra. }
  destruct (Rle_lt_dec (acos c) n) as [L|L]; [exact L|exfalso].
  pose proof (acos_bound c) as [T0 T1]. pose proof (cos_decreasing_1 n (acos c) N0 ltac:(lra) T0 T1 L) as K. rewrite cos_acos in K by lra. lra.
Qed.
(* beyond.chazelle.angle, clause 1: the lifted birds (x, t) and (v, 1) of R^(d+1), and |v - x/t| = |x - t v|/t *)
Definition lifted (d : nat) (x : nat -> R) (h : R) (k : nat) : R := if Nat.eqb k d then h else x k.
Lemma dotp_ext d x y x' y' : (forall k, (k < d)%nat -> x k = x' k /\ y k = y' k) -> dotp d x y = dotp d x' y'.
Proof. induction d as [|d IH]; intros H; [reflexivity|]. cbn. rewrite IH by (intros; apply H; lia). destruct (H d ltac:(lia)) as [-> ->]. reflexivity. Qed.
Lemma dotp_scal d a b x y : dotp d (fun k => a * x k) (fun k => b * y k) = a * b * dotp d x y.
Proof. induction d as [|d IH]; cbn; [ring|rewrite IH; ring]. Qed.
Lemma dotp_lifted d x y h g : dotp (S d) (lifted d x h) (lifted d y g) = dotp d x y + h * g.
Proof.
  cbn. unfold lifted at 3 4. rewrite Nat.eqb_refl. f_equal. apply dotp_ext. intros k Hk. unfold lifted. destruct (Nat.eqb_spec k d); [lia|split; reflexivity].
Qed.
Lemma scaled_by d a b x y z w : (forall k, (k < d)%nat -> x k = a * z k /\ y k = b * w k) -> dotp d x y = a * b * dotp d z w.
Proof. intros H. rewrite <- dotp_scal. now apply dotp_ext. Qed.
Theorem lifted_birds d x v t : 0 < t ->
  acos (dotp (S d) (lifted d x t) (lifted d v 1) / (chazelle_worked.norm (S d) (lifted d x t) * chazelle_worked.norm (S d) (lifted d v 1)))
    <= chazelle_worked.norm d (fun k => v k - x k / t) /\
  chazelle_worked.norm d (fun k => v k - x k / t) = chazelle_worked.norm d (fun k => x k - t * v k) / t.
Proof.
  intros T. pose proof (Rinv_0_lt_compat _ T). split.
  - set (y := fun k => x k / t). pose proof (angle_le d v y) as H0. unfold angle, ldot in H0. unfold chazelle_worked.norm. rewrite !dotp_lifted.
    assert (C : forall p q, dotp d p q = dotp d q p) by (intros; induction d as [|d' IH] in |- *; cbn; [reflexivity|rewrite IH; ring]).
    rewrite (scaled_by d t 1 x v y v), (scaled_by d t t x x y y), (C y v) by (intros k _; unfold y; split; field; lra).
    pose proof (dotp_sq d y). pose proof (dotp_sq d v).
    replace (t * t * dotp d y y + t * t) with (t * t * (dotp d y y + 1)) by ring. replace (1 * 1) with 1 by ring.
    rewrite (sqrt_mult (t * t)), sqrt_square by nra.
    assert (P1 : 0 < sqrt (dotp d y y + 1)) by (apply sqrt_lt_R0; lra). assert (P2 : 0 < sqrt (dotp d v v + 1)) by (apply sqrt_lt_R0; lra).
    replace ((t * 1 * dotp d v y + t * 1) / (t * sqrt (dotp d y y + 1) * sqrt (dotp d v v + 1)))
      with ((dotp d v y + 1) / (sqrt (dotp d v v + 1) * sqrt (dotp d y y + 1))) by (field; lra).
    unfold chazelle_worked.norm in H0. rewrite (dotp_ext d (diff v y) (diff v y) (fun k => v k - x k / t) (fun k => v k - x k / t)) in H0; [exact H0|].
    intros k _. unfold diff, y. split; unfold Rdiv; ring.
  - unfold chazelle_worked.norm. rewrite (scaled_by d (- / t) (- / t) _ _ (fun k => x k - t * v k) (fun k => x k - t * v k)) by (intros k _; split; field; lra).
    replace (- / t * - / t) with (/ t * / t) by ring. rewrite sqrt_mult, sqrt_square by (try apply dotp_sq; nra). unfold Rdiv. ring.
Qed.
