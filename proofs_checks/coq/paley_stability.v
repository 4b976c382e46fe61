(* Paley et al., Theorem 1, along solutions of (6) with (9) for all t >= 0: the gradient tends to 0 (Barbalat); for
   K_1 < 0 phases with |p| > 1 - 1/N synchronize exponentially fast; for K_1 > 0 phases with |p| < 1/N balance.
   Key inequality: with z = p/|p|, c_k = <e^{i theta_k}, z>, s_k = <i e^{i theta_k}, z>: s_k^2 >= 1 - |c_k|, sum c_k = N |p|. *)
From Coq Require Import Reals Lra Lia Psatz ZArith Classical.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums paley_model paley_phase.
Open Scope R_scope.

Lemma frame n th : (1 <= n)%nat -> 0 < Cmod (order n th) -> exists c s : nat -> R,
  (forall k, c k ^ 2 + s k ^ 2 = 1) /\ Sum n c = INR n * Cmod (order n th) /\ (forall k, g1 n th k = Cmod (order n th) * s k).
Proof.
  intros Hn M. pose proof (INR_pos n Hn) as P. set (p := order n th) in *. set (m := Cmod p) in *.
  set (z := (RtoC (/ m) * p)%C).
  assert (Z : inner z z = 1) by (unfold z; rewrite inner_scal, inner_sym, inner_scal, inner_self; fold m; field; lra).
  exists (fun k => inner (expi (th k)) z), (fun k => inner (Ci * expi (th k))%C z). split; [|split].
  - intros k. rewrite inner_xy in Z. rewrite !inner_xy. destruct z as [x y]. unfold expi. cbn in *. pose proof (sc2 (th k)) as S. cbn in S.
    transitivity ((cos (th k) * (cos (th k) * 1) + sin (th k) * (sin (th k) * 1)) * (x * x + y * y)); [ring|]. rewrite Z. lra.
  - transitivity (inner z (Csum n (phasors th))).
    + rewrite inner_Csum. apply Sum_ext; intros k _. apply inner_sym.
    + replace (Csum n (phasors th)) with (RtoC (INR n) * p)%C.
      * rewrite inner_scal. f_equal. unfold z. rewrite inner_sym, inner_scal, inner_self. fold m. field. lra.
      * unfold p, order. rewrite Cmult_assoc. replace (RtoC (INR n) * RtoC (/ INR n))%C with (RtoC 1); [apply Cmult_1_l|].
        unfold RtoC, Cmult; cbn. f_equal; field; lra.
  - intros k. unfold g1. fold p. unfold z. rewrite inner_scal. field. lra.
Qed.
Lemma g1_bound n th k : (1 <= n)%nat -> -1 <= g1 n th k <= 1.
Proof.
  intros Hn. pose proof (INR_pos n Hn) as P. rewrite g1_sines. assert (I : 0 < / INR n) by now apply Rinv_0_lt_compat.
  assert (A : - INR n <= Sum n (fun j => sin (th j - th k)) <= INR n).
  { split.
    - replace (- INR n) with (Sum n (fun _ => -1)) by (rewrite Sum_const; ring). apply Sum_le; intros. pose proof (SIN_bound (th i - th k)). lra.
    - replace (INR n) with (Sum n (fun _ => 1)) by (rewrite Sum_const; ring). apply Sum_le; intros. pose proof (SIN_bound (th i - th k)). lra. }
  pose proof (Rmult_le_compat_l (/ INR n) _ _ (Rlt_le _ _ I) (proj1 A)) as B1. pose proof (Rmult_le_compat_l (/ INR n) _ _ (Rlt_le _ _ I) (proj2 A)) as B2.
  replace (/ INR n * - INR n) with (-1) in B1 by (field; lra). replace (/ INR n * INR n) with 1 in B2 by (field; lra). lra.
Qed.

Section Flow.
Variables (n : nat) (w0 K1 : R) (th : nat -> R -> R).
Hypothesis Hn : (1 <= n)%nat.
Hypothesis HK : K1 <> 0.
Hypothesis HT : forall t k, 0 <= t -> (k < n)%nat -> is_derive (th k) t (w0 + - K1 * g1 n (fun j => th j t) k).
Notation g t k := (g1 n (fun j => th j t) k).
Notation U t := (U1 n (fun j => th j t)).
Notation p t := (Cmod (order n (fun j => th j t))).
Definition G (t : R) : R := Sum n (fun k => g1 n (fun j => th j t) k ^ 2).
Lemma G_ge0 t : 0 <= G t. Proof. apply Sum_ge0; intros; apply pow2_ge_0. Qed.
Lemma U_rate t : 0 <= t -> is_derive (fun s => U s) t (- K1 * G t).
Proof. intros Ht. apply (U1_rate n th w0 K1 t Hn). intros k Hk. now apply HT. Qed.

Definition dg (t : R) (k : nat) : R := / INR n * Sum n (fun j => cos (th j t - th k t) * (- K1 * (g t j - g t k))).
Lemma g_rate t k : 0 <= t -> (k < n)%nat -> is_derive (fun s => g s k) t (dg t k).
Proof.
  intros Ht Hk. apply (is_derive_ext (fun s => / INR n * Sum n (fun j => sin (th j s - th k s)))); [intros; symmetry; apply g1_sines|].
  unfold dg. apply D_scal. apply (D_Sum n (fun j s => sin (th j s - th k s)) (fun j => cos (th j t - th k t) * (- K1 * (g t j - g t k)))).
  intros j Hj. apply (D_sin (fun s => th j s - th k s)). eapply D_eq; [apply D_minus; apply HT; assumption|]. ring.
Qed.
Lemma dg_bound t k : Rabs (dg t k) <= 2 * Rabs K1.
Proof.
  pose proof (INR_pos n Hn) as P. assert (I : 0 < / INR n) by now apply Rinv_0_lt_compat. unfold dg. rewrite Rabs_mult, (Rabs_pos_eq (/ INR n)) by lra.
  replace (2 * Rabs K1) with (/ INR n * (INR n * (2 * Rabs K1))) by (field; lra). apply Rmult_le_compat_l; [lra|].
  eapply Rle_trans; [apply Sum_Rabs|]. rewrite <- Sum_const. apply Sum_le; intros j _. rewrite !Rabs_mult, Rabs_Ropp.
  pose proof (g1_bound n (fun j => th j t) j Hn). pose proof (g1_bound n (fun j => th j t) k Hn).
  assert (A : Rabs (g t j - g t k) <= 2) by (apply Rabs_le; lra). assert (B : Rabs (cos (th j t - th k t)) <= 1) by (apply Rabs_le; apply COS_bound).
  pose proof (Rabs_pos K1). pose proof (Rabs_pos (g t j - g t k)). pose proof (Rabs_pos (cos (th j t - th k t))).
  replace (2 * Rabs K1) with (1 * (Rabs K1 * 2)) by ring. apply Rmult_le_compat; try assumption; [apply Rmult_le_pos; assumption|apply Rmult_le_compat_l; assumption].
Qed.
Theorem thm1_gradient_to_0 : forall e, 0 < e -> exists T, 0 <= T /\ forall t, T <= t -> G t < e.
Proof.
  pose proof (INR_pos n Hn) as P. assert (AK : 0 < Rabs K1) by now apply Rabs_pos_lt.
  apply (barbalat (fun t => - / K1 * U t) G (/ Rabs K1 * (INR n / 2)) (INR n * (4 * Rabs K1))).
  - apply Rmult_lt_0_compat; lra.
  - intros t Ht. eapply D_eq; [apply D_scal, U_rate, Ht|]. field. exact HK.
  - intros t _. apply G_ge0.
  - intros t _. pose proof (U1_min n (fun j => th j t) Hn) as [L _]. pose proof (U1_max n (fun j => th j t) Hn) as [H _].
    apply Rle_trans with (Rabs (- / K1 * U t)); [apply Rle_abs|]. rewrite Rabs_mult, Rabs_Ropp, Rabs_inv, (Rabs_pos_eq (U t)) by exact L.
    apply Rmult_le_compat_l; [left; now apply Rinv_0_lt_compat|exact H].
  - intros s t Hst. destruct (MVT_le G (fun x => Sum n (fun k => 2 * g x k * dg x k)) s t) as [c [Hc E]]; [lra| |].
    + intros x Hx. apply (D_Sum n (fun k s => g s k ^ 2) (fun k => 2 * g x k * dg x k)). intros k Hk. apply (D_sqr (fun s => g s k)). apply g_rate; [lra|assumption].
    + rewrite E, Rabs_mult, (Rabs_pos_eq (t - s)) by lra. apply Rmult_le_compat_r; [lra|]. eapply Rle_trans; [apply Sum_Rabs|].
      rewrite <- Sum_const. apply Sum_le; intros k _. rewrite !Rabs_mult, (Rabs_pos_eq 2) by lra.
      pose proof (g1_bound n (fun j => th j c) k Hn). assert (A : Rabs (g c k) <= 1) by (apply Rabs_le; lra). pose proof (dg_bound c k).
      pose proof (Rabs_pos (g c k)). pose proof (Rabs_pos (dg c k)). nra.
Qed.

(* K_1 < 0 *)
Lemma p_U t : p t ^ 2 = 2 / INR n * U t.
Proof. pose proof (INR_pos n Hn). unfold U1. field. lra. Qed.
Lemma deficit_bound t : 1 - / INR n < p t -> INR n / 2 - U t <= G t / p t ^ 2.
Proof.
  intros Hp. pose proof (INR_pos n Hn) as P. assert (I1 : / INR n <= 1). { rewrite <- Rinv_1. apply Rinv_le_contravar; [lra|]. apply (le_INR 1) in Hn. cbn in Hn. lra. }
  assert (M : 0 < p t) by lra. destruct (frame n (fun j => th j t) Hn M) as [c [s [CS [SC GS]]]].
  pose proof (order_bounds n (fun j => th j t) Hn) as [_ B]. set (m := p t) in *.
  assert (C0 : forall k, (k < n)%nat -> 0 <= c k).
  { intros k Hk. apply Rnot_lt_le. intros L.
    assert (T : Sum n c <= Sum n (fun j => 1 - delta j k * 1)).
    { apply Sum_le; intros j Hj. unfold delta. destruct (Nat.eqb_spec j k) as [->|]; [lra|]. pose proof (CS j). pose proof (pow2_ge_0 (s j)). nra. }
    rewrite Sum_minus, Sum_const, (Sum_delta n k (fun _ => 1) Hk), SC in T.
    apply (Rmult_lt_compat_l (INR n)) in Hp; [|exact P]. replace (INR n * (1 - / INR n)) with (INR n - 1) in Hp by (field; lra). lra. }
  assert (S1 : INR n * (1 - m) <= Sum n (fun k => s k ^ 2)).
  { replace (INR n * (1 - m)) with (Sum n (fun k => 1 - c k)) by (rewrite Sum_minus, Sum_const, SC; ring).
    apply Sum_le; intros k Hk. pose proof (CS k). pose proof (C0 k Hk). pose proof (pow2_ge_0 (s k)). nra. }
  assert (E : G t / m ^ 2 = Sum n (fun k => s k ^ 2)).
  { unfold G. rewrite (Sum_ext n _ (fun k => m ^ 2 * s k ^ 2)) by (intros k _; rewrite GS; fold m; ring). rewrite Sum_scal. field. lra. }
  rewrite E. unfold U1. fold m. apply Rle_trans with (INR n * (1 - m)); [|exact S1].
  assert (X : 0 <= INR n / 2 * ((1 - m) * (1 - m))) by (apply Rmult_le_pos; [lra|apply Rmult_le_pos; lra]).
  replace (INR n / 2 - INR n / 2 * m ^ 2) with (INR n * (1 - m) - INR n / 2 * ((1 - m) * (1 - m))) by field. lra.
Qed.
Theorem thm1_synchronize : K1 < 0 -> 1 - / INR n < p 0 -> forall t, 0 <= t ->
  INR n / 2 - U t <= (INR n / 2 - U 0) * exp (- (- K1 * p 0 ^ 2) * t) /\
  forall j k, (j < n)%nat -> (k < n)%nat -> 1 - cos (th j t - th k t) <= 2 * INR n * (INR n / 2 - U t).
Proof.
  intros K H0. pose proof (INR_pos n Hn) as P.
  assert (I1 : / INR n <= 1). { rewrite <- Rinv_1. apply Rinv_le_contravar; [lra|]. apply (le_INR 1) in Hn. cbn in Hn. lra. }
  assert (Up : forall t, 0 <= t -> U 0 <= U t).
  { intros t Ht. apply Ropp_le_cancel. apply (decreasing (fun s => - U s) (fun s => - (- K1 * G s))); [exact Ht|intros; apply D_opp, U_rate; lra|].
    intros x _. pose proof (G_ge0 x). nra. }
  assert (Pm : forall t, 0 <= t -> p 0 <= p t).
  { intros t Ht. pose proof (p_U 0) as E0. pose proof (p_U t) as Et. pose proof (Up t Ht).
    assert (0 < 2 / INR n) by (apply Rdiv_lt_0_compat; lra). pose proof (Cmod_ge_0 (order n (fun j => th j t))).
    apply Rnot_lt_le. intros L. assert (p t ^ 2 < p 0 ^ 2) by nra. nra. }
  intros t Ht. split.
  - apply (gronwall (fun t => INR n / 2 - U t) (fun t => K1 * G t) (- K1 * p 0 ^ 2)); [| |exact Ht].
    + intros x Hx. eapply D_eq; [apply D_minus; [apply D_const|apply U_rate, Hx]|]. ring.
    + intros x Hx. pose proof (Pm x Hx) as L. pose proof (deficit_bound x ltac:(lra)) as D.
      assert (Q : 0 < p x ^ 2) by (apply pow_lt; lra). apply (Rmult_le_compat_r (p x ^ 2)) in D; [|lra].
      replace (G x / p x ^ 2 * p x ^ 2) with (G x) in D by (field; lra).
      pose proof (proj1 (U1_max n (fun j => th j x) Hn)) as M. assert (p 0 ^ 2 <= p x ^ 2) by nra.
      assert ((INR n / 2 - U x) * p 0 ^ 2 <= G x) by nra. nra.
  - intros j k Hj Hk. rewrite (U1_pairs n (fun j => th j t) Hn). unfold cos_pairs.
    pose proof (order_deficit n (fun j => th j t) Hn) as OD. pose proof (p_U t) as E. rewrite (U1_pairs n (fun j => th j t) Hn) in E. unfold cos_pairs in E.
    assert (T : 1 - cos (th j t - th k t) <= Sum n (fun k => Sum n (fun j => 1 - cos (th j t - th k t)))).
    { apply Rle_trans with (Sum n (fun j => 1 - cos (th j t - th k t))).
      - apply (Sum_term_le n (fun j => 1 - cos (th j t - th k t)) j); [|exact Hj]. intros i _. pose proof (COS_bound (th i t - th k t)). lra.
      - apply (Sum_term_le n (fun k => Sum n (fun j => 1 - cos (th j t - th k t))) k); [|exact Hk].
        intros i _. apply Sum_ge0; intros l _. pose proof (COS_bound (th l t - th i t)). lra. }
    apply Rle_trans with (1 := T). set (X := Sum n (fun k => Sum n (fun j => 1 - cos (th j t - th k t)))) in *.
    rewrite E in OD. set (Y := / (2 * INR n) * _) in *. apply (Rmult_eq_compat_l (INR n * INR n)) in OD.
    replace (INR n * INR n * (1 - / (INR n * INR n) * X)) with (INR n * INR n - X) in OD by (field; lra).
    replace (INR n * INR n * (2 / INR n * Y)) with (2 * INR n * Y) in OD by (field; lra). lra.
Qed.

(* K_1 > 0 *)
Lemma lattice_bound t : 0 < p t -> INR n * p t < 1 -> Rmin (INR n * p t) (1 - INR n * p t) * p t ^ 2 <= G t.
Proof.
  intros M L. pose proof (INR_pos n Hn) as P. destruct (frame n (fun j => th j t) Hn M) as [c [s [CS [SC GS]]]]. set (m := p t) in *.
  pose (sg := fun k => if Rle_dec 0 (c k) then 1 else -1).
  assert (I : forall a, exists q : Z, Sum a sg = IZR q).
  { induction a as [|a [q Hq]]; [now exists 0%Z|]. cbn. rewrite Hq. unfold sg. destruct (Rle_dec 0 (c a)); [exists (q + 1)%Z|exists (q - 1)%Z]; rewrite ?plus_IZR, ?minus_IZR; lra. }
  destruct (I n) as [q Hq].
  assert (A : Rabs (Sum n sg - Sum n c) <= Sum n (fun k => s k ^ 2)).
  { rewrite <- Sum_minus. eapply Rle_trans; [apply Sum_Rabs|]. apply Sum_le; intros k _. pose proof (CS k). pose proof (pow2_ge_0 (s k)).
    unfold sg. destruct (Rle_dec 0 (c k)); [rewrite Rabs_pos_eq|rewrite Rabs_left1]; nra. }
  rewrite Hq, SC in A. fold m in A.
  assert (B : Rmin (INR n * m) (1 - INR n * m) <= Rabs (IZR q - INR n * m)).
  { assert (0 < INR n * m) by nra. destruct (Z_le_dec q 0) as [Z|Z].
    - apply IZR_le in Z. rewrite Rabs_left1 by lra. pose proof (Rmin_l (INR n * m) (1 - INR n * m)). lra.
    - assert (1 <= q)%Z as Z1 by lia. apply IZR_le in Z1. rewrite Rabs_pos_eq by lra. pose proof (Rmin_r (INR n * m) (1 - INR n * m)). lra. }
  assert (E : G t = m ^ 2 * Sum n (fun k => s k ^ 2)).
  { unfold G. rewrite (Sum_ext n _ (fun k => m ^ 2 * s k ^ 2)) by (intros k _; rewrite GS; fold m; ring). apply Sum_scal. }
  rewrite E, Rmult_comm. apply Rmult_le_compat_l; [apply pow2_ge_0|lra].
Qed.
Theorem thm1_balance : 0 < K1 -> INR n * p 0 < 1 -> forall e, 0 < e -> exists T, 0 <= T /\ forall t, T <= t -> p t < e.
Proof.
  intros K H0 e He. pose proof (INR_pos n Hn) as P.
  assert (Down : forall s t, 0 <= s <= t -> U t <= U s).
  { intros s t Hst. apply (decreasing (fun s => U s) (fun s => - K1 * G s)); [lra|intros; apply U_rate; lra|]. intros x _. pose proof (G_ge0 x). nra. }
  assert (Pm : forall s t, 0 <= s <= t -> p t <= p s).
  { intros s t Hst. pose proof (p_U s) as Es. pose proof (p_U t) as Et. pose proof (Down s t Hst).
    assert (0 < 2 / INR n) by (apply Rdiv_lt_0_compat; lra). pose proof (Cmod_ge_0 (order n (fun j => th j s))).
    apply Rnot_lt_le. intros L. assert (p s ^ 2 < p t ^ 2) by nra. nra. }
  set (r := Rmin (INR n * e) (1 - INR n * p 0) * e ^ 2).
  assert (Hr : 0 < r). { unfold r. apply Rmult_lt_0_compat; [apply Rmin_glb_lt; nra|apply pow_lt; lra]. }
  set (T := U 0 / (K1 * r) + 1). pose proof (proj1 (U1_min n (fun j => th j 0) Hn)) as U0.
  assert (HT0 : 0 < T). { unfold T. assert (0 <= U 0 / (K1 * r)); [|lra]. apply Rmult_le_pos; [exact U0|left; apply Rinv_0_lt_compat; nra]. }
  exists T. split; [lra|]. intros t Ht. apply Rle_lt_trans with (p T); [apply Pm; lra|]. apply Rnot_le_lt. intros L.
  assert (GT : forall x, 0 <= x <= T -> r <= G x).
  { intros x Hx. pose proof (Pm x T Hx). pose proof (Pm 0 x ltac:(lra)). pose proof (lattice_bound x ltac:(lra) ltac:(nra)) as B.
    apply Rle_trans with (2 := B). unfold r.
    assert (Rmin (INR n * e) (1 - INR n * p 0) <= Rmin (INR n * p x) (1 - INR n * p x)).
    { apply Rmin_glb; [apply Rle_trans with (1 := Rmin_l _ _)|apply Rle_trans with (1 := Rmin_r _ _)]; nra. }
    assert (0 < Rmin (INR n * e) (1 - INR n * p 0)) by (apply Rmin_glb_lt; nra).
    apply Rmult_le_compat; [lra|apply pow2_ge_0|assumption|]. apply pow_incr. lra. }
  destruct (MVT_le (fun s => U s) (fun s => - K1 * G s) 0 T) as [c [Hc E]]; [lra|intros; apply U_rate; lra|].
  pose proof (GT c Hc). pose proof (proj1 (U1_min n (fun j => th j T) Hn)).
  assert (K1 * r * T = U 0 + K1 * r). { unfold T. field. split; lra. }
  assert (K1 * r * T <= K1 * G c * T) by (apply Rmult_le_compat_r; [lra|nra]). nra.
Qed.
End Flow.
