(* Tanner, Jadbabaie, Pappas, switching paper: the saturated potential U(s) = V(s) for s < R, V(R) for s >= R, with
   V'(R) = c > 0.  One-sided derivatives, Clarke's directional derivative max(0, c w) and the generalised gradient
   [0, c] at R: U is continuous but not regular (Lemma 1 fails) and its generalised gradient is not empty (Lemma 2 fails). *)
From Coq Require Import Reals Lra Lia Psatz.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums.
Open Scope R_scope.

(* Definitions 5-7 of the appendix *)
Definition one_sided (f : R -> R) (x w l : R) := forall e, 0 < e -> exists d, 0 < d /\ forall h, 0 < h < d -> Rabs ((f (x + h * w) - f x) / h - l) < e.
Definition clarke (f : R -> R) (x w l : R) :=
  (forall e, 0 < e -> exists d, 0 < d /\ forall y h, Rabs (y - x) < d -> 0 < h < d -> (f (y + h * w) - f y) / h < l + e) /\
  (forall e d, 0 < e -> 0 < d -> exists y h, Rabs (y - x) < d /\ 0 < h < d /\ l - e < (f (y + h * w) - f y) / h).
Definition regular (f : R -> R) (x : R) := forall w, exists l, one_sided f x w l /\ clarke f x w l.
Definition gen_gradient (f : R -> R) (x z : R) := forall w l, clarke f x w l -> z * w <= l.

Lemma clarke_unique f x w l m : clarke f x w l -> clarke f x w m -> l = m.
Proof.
  assert (A : forall l m, clarke f x w l -> clarke f x w m -> l <= m).
  { clear. intros l m [_ L] [M _]. apply Rnot_lt_le. intros H. destruct (M ((l - m) / 2) ltac:(lra)) as [d [Hd Md]].
    destruct (L ((l - m) / 2) d ltac:(lra) Hd) as [y [h [Hy [Hh Q]]]]. specialize (Md y h Hy Hh). lra. }
  intros L M. apply Rle_antisym; now apply A.
Qed.

Section Saturated.
Variables (V V' : R -> R) (R0 c : R).
Hypothesis HR : 0 < R0.
Hypothesis D : forall s, 0 < s -> is_derive V s (V' s).
Hypothesis C : continuity_pt V' R0.
Hypothesis Vc : V' R0 = c.
Hypothesis Hc : 0 < c.
Definition saturated (s : R) : R := if Rlt_dec s R0 then V s else V R0.
Lemma saturated_min s : saturated s = V (Rmin s R0).
Proof. unfold saturated. destruct (Rlt_dec s R0); [now rewrite Rmin_left by lra|now rewrite Rmin_right by lra]. Qed.
Lemma near_slope e : 0 < e -> exists d, 0 < d /\ d < R0 /\ forall s, Rabs (s - R0) < d -> Rabs (V' s - c) < e.
Proof.
  intros He. destruct (C e He) as [d [Hd P]]. exists (Rmin d (R0 / 2)).
  pose proof (Rmin_l d (R0 / 2)). pose proof (Rmin_r d (R0 / 2)). assert (0 < Rmin d (R0 / 2)) by (apply Rmin_glb_lt; lra).
  split; [lra|]. split; [lra|]. intros s Hs. destruct (Req_dec s R0) as [->|N]; [rewrite Vc, Rminus_eq_0, Rabs_R0; exact He|].
  rewrite <- Vc. apply (P s). split; [split; [exact I|congruence]|]. unfold dist; cbn; unfold R_dist. lra.
Qed.
(* a difference of U near R0 is V' at a nearby point times the difference of the clipped arguments *)
Lemma saturated_diff d a b : d < R0 -> Rabs (a - R0) < d -> Rabs (b - R0) < d ->
  exists x, Rabs (x - R0) < d /\ saturated b - saturated a = V' x * (Rmin b R0 - Rmin a R0).
Proof.
  intros Hd Ha Hb. rewrite !saturated_min. apply Rabs_lt_between in Ha, Hb.
  assert (M : forall p, - d < p - R0 < d -> - d < Rmin p R0 - R0 < d) by (intros p Hp; unfold Rmin; destruct (Rle_dec p R0); lra).
  apply M in Ha, Hb. set (p := Rmin a R0) in *. set (q := Rmin b R0) in *. destruct (Rle_or_lt p q) as [L|L].
  - destruct (MVT_le V V' p q L) as [x [Hx E]]; [intros; apply D; lra|]. exists x. split; [apply Rabs_def1; lra|exact E].
  - destruct (MVT_le V V' q p ltac:(lra)) as [x [Hx E]]; [intros; apply D; lra|]. exists x. split; [apply Rabs_def1; lra|lra].
Qed.

Theorem saturated_right w : 0 <= w -> one_sided saturated R0 w 0.
Proof.
  intros Hw e He. exists 1. split; [lra|]. intros h Hh. rewrite !saturated_min, !Rmin_right by nra.
  unfold Rdiv. rewrite Rminus_eq_0, Rmult_0_l, Rminus_eq_0, Rabs_R0. exact He.
Qed.
Theorem saturated_left w : w < 0 -> one_sided saturated R0 w (c * w).
Proof.
  intros Hw e He. destruct (near_slope (e / - w)) as [d [Hd [HdR S]]]; [apply Rdiv_lt_0_compat; lra|].
  exists (d / - w). assert (P : 0 < d / - w) by (apply Rdiv_lt_0_compat; lra). split; [exact P|]. intros h Hh.
  assert (L : h * - w < d). { apply Rlt_le_trans with (d / - w * - w); [nra|right; field; lra]. }
  destruct (saturated_diff d R0 (R0 + h * w) HdR) as [x [Hx E]].
  - rewrite Rminus_eq_0, Rabs_R0. lra.
  - replace (R0 + h * w - R0) with (h * w) by ring. rewrite Rabs_left by nra. lra.
  - rewrite E. rewrite (Rmin_left (R0 + h * w)), (Rmin_left R0) by nra.
    replace (V' x * (R0 + h * w - R0) / h - c * w) with ((V' x - c) * w) by (field; lra). rewrite Rabs_mult, (Rabs_left w) by lra.
    apply Rlt_le_trans with (e / - w * - w); [apply Rmult_lt_compat_r; [lra|now apply S]|right; field; lra].
Qed.
Theorem saturated_clarke w : clarke saturated R0 w (Rmax 0 (c * w)).
Proof.
  split.
  - intros e He. destruct (near_slope (Rmin c (e / (Rabs w + 1)))) as [d [Hd [HdR S]]].
    { apply Rmin_glb_lt; [lra|apply Rdiv_lt_0_compat; [lra|pose proof (Rabs_pos w); lra]]. }
    exists (d / (2 * (Rabs w + 1))). pose proof (Rabs_pos w) as Aw.
    assert (P : 0 < d / (2 * (Rabs w + 1))) by (apply Rdiv_lt_0_compat; lra). split; [exact P|]. intros y h Hy Hh.
    assert (L : h * Rabs w < d / 2). { apply Rle_lt_trans with (h * (Rabs w + 1)); [nra|].
      apply Rlt_le_trans with (d / (2 * (Rabs w + 1)) * (Rabs w + 1)); [nra|right; field; lra]. }
    assert (Ld : d / (2 * (Rabs w + 1)) <= d / 2). { unfold Rdiv. apply Rmult_le_compat_l; [lra|]. apply Rinv_le_contravar; lra. }
    destruct (saturated_diff d y (y + h * w) HdR) as [x [Hx E]]; [lra| |].
    + replace (y + h * w - R0) with ((y - R0) + h * w) by ring. eapply Rle_lt_trans; [apply Rabs_triang|]. rewrite Rabs_mult, (Rabs_pos_eq h) by lra. lra.
    + specialize (S x Hx). apply Rabs_lt_between in S. pose proof (Rmin_l c (e / (Rabs w + 1))). pose proof (Rmin_r c (e / (Rabs w + 1))).
      rewrite E. apply (Rmult_lt_reg_r h); [lra|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra.
      assert (V0 : 0 < V' x) by lra. pose proof (Rmax_l 0 (c * w)). pose proof (Rmax_r 0 (c * w)).
      destruct (Rle_or_lt 0 w) as [W|W].
      * rewrite (Rabs_pos_eq w) in * by lra. assert (Q : 0 <= Rmin (y + h * w) R0 - Rmin y R0 <= h * w).
        { unfold Rmin. destruct (Rle_dec (y + h * w) R0), (Rle_dec y R0); nra. }
        assert (B : e / (w + 1) * w < e). { apply Rlt_le_trans with (e / (w + 1) * (w + 1)); [|right; field; lra].
          apply Rmult_lt_compat_l; [apply Rdiv_lt_0_compat|]; lra. }
        apply Rle_lt_trans with (V' x * (h * w)); [apply Rmult_le_compat_l; lra|].
        apply Rle_lt_trans with ((c + e / (w + 1)) * (h * w)); [apply Rmult_le_compat_r; [nra|lra]|]. nra.
      * assert (Q : Rmin (y + h * w) R0 - Rmin y R0 <= 0) by (unfold Rmin; destruct (Rle_dec (y + h * w) R0), (Rle_dec y R0); nra).
        apply Rle_lt_trans with 0; [nra|]. apply Rmult_lt_0_compat; lra.
  - intros e d He Hd. destruct (Rle_or_lt w 0) as [W|W].
    + exists (R0 + d / 4 * - w / (1 + - w)), (Rmin (d / 4 / (1 + - w)) (d / 2)).
      assert (P : 0 < d / 4 / (1 + - w)) by (repeat apply Rdiv_lt_0_compat; lra).
      assert (P2 : 0 < Rmin (d / 4 / (1 + - w)) (d / 2)) by (apply Rmin_glb_lt; lra).
      pose proof (Rmin_l (d / 4 / (1 + - w)) (d / 2)). pose proof (Rmin_r (d / 4 / (1 + - w)) (d / 2)).
      assert (F : d / 4 * - w / (1 + - w) = d / 4 / (1 + - w) * - w) by (field; lra).
      assert (G : d / 4 / (1 + - w) * - w <= d / 4). { apply Rle_trans with (d / 4 / (1 + - w) * (1 + - w)); [nra|right; field; lra]. }
      split; [|split; [lra|]].
      * rewrite F. replace (R0 + d / 4 / (1 + - w) * - w - R0) with (d / 4 / (1 + - w) * - w) by ring. rewrite Rabs_pos_eq by nra. lra.
      * rewrite !saturated_min, !Rmin_right by (rewrite F; nra). unfold Rdiv. rewrite Rminus_eq_0, Rmult_0_l.
        rewrite Rmax_left by nra. lra.
    + destruct (near_slope (e / (2 * w))) as [b [Hb [HbR S]]]; [apply Rdiv_lt_0_compat; lra|].
      pose (m := Rmin b d). assert (Hm : 0 < m) by (unfold m; apply Rmin_glb_lt; lra). pose proof (Rmin_l b d). pose proof (Rmin_r b d). fold m in H, H0.
      exists (R0 - m / 2), (Rmin (m / 4 / w) (m / 2)).
      assert (P : 0 < m / 4 / w) by (repeat apply Rdiv_lt_0_compat; lra).
      assert (P2 : 0 < Rmin (m / 4 / w) (m / 2)) by (apply Rmin_glb_lt; lra).
      pose proof (Rmin_l (m / 4 / w) (m / 2)). pose proof (Rmin_r (m / 4 / w) (m / 2)). set (h := Rmin (m / 4 / w) (m / 2)) in *.
      assert (G : h * w <= m / 4). { apply Rle_trans with (m / 4 / w * w); [nra|right; field; lra]. }
      split; [|split; [lra|]].
      * replace (R0 - m / 2 - R0) with (- (m / 2)) by ring. rewrite Rabs_Ropp, Rabs_pos_eq; lra.
      * destruct (saturated_diff b (R0 - m / 2) (R0 - m / 2 + h * w) HbR) as [x [Hx E]].
        -- apply Rabs_def1; lra.
        -- apply Rabs_def1; nra.
        -- rewrite E, !Rmin_left by nra. replace (V' x * (R0 - m / 2 + h * w - (R0 - m / 2)) / h) with (V' x * w) by (field; lra).
           specialize (S x Hx). apply Rabs_lt_between in S. rewrite Rmax_right by nra.
           assert (B : e / (2 * w) * w = e / 2) by (field; lra). nra.
Qed.

Theorem lemma1_fails : ~ regular saturated R0.
Proof.
  intros H. destruct (H (-1)) as [l [O K]]. pose proof (clarke_unique _ _ _ _ _ K (saturated_clarke (-1))) as E.
  rewrite Rmax_left in E by lra. subst l. destruct (O (c / 2) ltac:(lra)) as [d [Hd P]].
  destruct (saturated_left (-1) ltac:(lra) (c / 2) ltac:(lra)) as [d' [Hd' P']].
  set (h := Rmin d d' / 2). assert (0 < Rmin d d') by (now apply Rmin_glb_lt). pose proof (Rmin_l d d'). pose proof (Rmin_r d d').
  specialize (P h ltac:(unfold h; lra)). specialize (P' h ltac:(unfold h; lra)). apply Rabs_lt_between in P, P'. lra.
Qed.
Theorem lemma2_fails : forall z, gen_gradient saturated R0 z <-> 0 <= z <= c.
Proof.
  intros z. split.
  - intros G. pose proof (G 1 _ (saturated_clarke 1)) as A. pose proof (G (-1) _ (saturated_clarke (-1))) as B.
    rewrite Rmax_right in A by lra. rewrite Rmax_left in B by lra. lra.
  - intros Hz w l K. rewrite (clarke_unique _ _ _ _ _ K (saturated_clarke w)). pose proof (Rmax_l 0 (c * w)). pose proof (Rmax_r 0 (c * w)).
    destruct (Rle_or_lt 0 w); nra.
Qed.
Theorem saturated_not_differentiable : ~ ex_derive saturated R0.
Proof.
  intros [l Dl]. apply is_derive_Reals in Dl.
  assert (O : forall w, w <> 0 -> one_sided saturated R0 w (l * w)).
  { intros w Hw e He. assert (Aw : 0 < Rabs w) by now apply Rabs_pos_lt. destruct (Dl (e / Rabs w)) as [d P]; [apply Rdiv_lt_0_compat; lra|].
    pose proof (cond_pos d) as Hd. exists (d / Rabs w). split; [apply Rdiv_lt_0_compat; lra|]. intros h Hh.
    assert (Hhw : h * w <> 0) by (apply Rmult_integral_contrapositive; split; lra).
    specialize (P (h * w) Hhw). rewrite Rabs_mult, (Rabs_pos_eq h) in P by lra.
    assert (L : h * Rabs w < d). { apply Rlt_le_trans with (d / Rabs w * Rabs w); [nra|right; field; lra]. }
    specialize (P L). replace ((saturated (R0 + h * w) - saturated R0) / h - l * w) with (((saturated (R0 + h * w) - saturated R0) / (h * w) - l) * w) by (field; split; lra).
    rewrite Rabs_mult. apply Rlt_le_trans with (e / Rabs w * Rabs w); [nra|right; field; lra]. }
  assert (U : forall w a b, one_sided saturated R0 w a -> one_sided saturated R0 w b -> a = b).
  { intros w a b A B. destruct (Req_dec a b) as [|N]; [assumption|exfalso]. assert (P : 0 < Rabs (a - b)) by (apply Rabs_pos_lt; lra).
    destruct (A (Rabs (a - b) / 2) ltac:(lra)) as [d [Hd A']]. destruct (B (Rabs (a - b) / 2) ltac:(lra)) as [d' [Hd' B']].
    set (h := Rmin d d' / 2). assert (0 < Rmin d d') by (now apply Rmin_glb_lt). pose proof (Rmin_l d d'). pose proof (Rmin_r d d').
    specialize (A' h ltac:(unfold h; lra)). specialize (B' h ltac:(unfold h; lra)). set (q := _ / h) in *.
    assert (T : Rabs (a - b) <= Rabs (q - b) + Rabs (q - a)).
    { replace (a - b) with ((q - b) + - (q - a)) by ring. eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_Ropp. lra. }
    lra. }
  pose proof (U 1 _ _ (O 1 ltac:(lra)) (saturated_right 1 ltac:(lra))) as E1.
  pose proof (U (-1) _ _ (O (-1) ltac:(lra)) (saturated_left (-1) ltac:(lra))) as E2. lra.
Qed.
Theorem saturated_continuous s : 0 < s -> continuity_pt saturated s.
Proof.
  intros Hs. apply (continuity_pt_ext (fun x => V (Rmin x R0))); [intros; symmetry; apply saturated_min|].
  apply continuity_pt_comp with (f1 := fun x => Rmin x R0).
  - apply (continuity_pt_ext (fun x => (x + R0 - Rabs (x - R0)) / 2)).
    + intros x. unfold Rmin, Rabs. destruct (Rle_dec x R0), (Rcase_abs (x - R0)); lra.
    + unfold Rdiv. apply continuity_pt_mult; [|apply continuity_pt_const; intros ? ?; reflexivity].
      apply continuity_pt_minus; [apply continuity_pt_plus; [apply derivable_continuous_pt, derivable_pt_id|apply continuity_pt_const; intros ? ?; reflexivity]|].
      apply continuity_pt_comp with (f1 := fun x => x - R0) (f2 := Rabs); [|apply Rcontinuity_abs].
      apply continuity_pt_minus; [apply derivable_continuous_pt, derivable_pt_id|apply continuity_pt_const; intros ? ?; reflexivity].
  - apply continuity_pt_filterlim. apply (ex_derive_continuous V). eexists. apply D. apply Rmin_glb_lt; lra.
Qed.
End Saturated.

(* existence without uniqueness: x' = 2 sqrt |x|, a continuous right-hand side, has two solutions from 0 *)
Definition late (t : R) : R := if Rle_dec t 0 then 0 else t * t.
Theorem two_solutions : (forall t, is_derive (fun _ : R => 0) t (2 * sqrt (Rabs 0))) /\ (forall t, is_derive late t (2 * sqrt (Rabs (late t)))) /\
  late 0 = 0 /\ late 1 = 1.
Proof.
  split; [|split; [|split]].
  - intros t. rewrite Rabs_R0, sqrt_0, Rmult_0_r. apply D_const.
  - intros t. destruct (Rtotal_order t 0) as [L|[->|L]].
    + replace (late t) with 0 by (unfold late; destruct (Rle_dec t 0); lra). rewrite Rabs_R0, sqrt_0, Rmult_0_r.
      apply (is_derive_ext_loc (fun _ : R => 0)); [|apply D_const]. exists (mkposreal (- t) ltac:(lra)). intros y Hy.
      apply Rabs_lt_between in Hy. unfold late. cbn in Hy. unfold minus, plus, opp in Hy; cbn in Hy. destruct (Rle_dec y 0); [reflexivity|lra].
    + replace (late 0) with 0 by (unfold late; destruct (Rle_dec 0 0); lra). rewrite Rabs_R0, sqrt_0, Rmult_0_r. apply is_derive_Reals.
      intros e He. exists (mkposreal e He). intros h Hh Hhe. cbn in Hhe. unfold late. rewrite Rplus_0_l, Rminus_0_r.
      destruct (Rle_dec 0 0); [|lra]. destruct (Rle_dec h 0).
      * replace ((0 - 0) / h) with 0 by (field; lra). rewrite Rabs_R0. exact He.
      * replace ((h * h - 0) / h) with h by (field; lra). exact Hhe.
    + assert (E : late t = t * t) by (unfold late; destruct (Rle_dec t 0); lra). rewrite E, Rabs_pos_eq, sqrt_square by nra.
      apply (is_derive_ext_loc (fun s : R => s * s)).
      * exists (mkposreal t L). intros y Hy. apply Rabs_lt_between in Hy. cbn in Hy. unfold minus, plus, opp in Hy; cbn in Hy.
        unfold late. destruct (Rle_dec y 0); [lra|reflexivity].
      * eapply D_eq; [apply (D_mult (fun s : R => s) (fun s : R => s) t 1 1); apply D_id|]. ring.
  - unfold late. destruct (Rle_dec 0 0); lra.
  - unfold late. destruct (Rle_dec 1 0); lra.
Qed.
