(* Tanner, Jadbabaie, Pappas, switching paper: what is true of Lemma 1.  The saturated potential U(s) = V(s) for s < R, V(R) for
   s >= R, is regular at every distance but R, and where V'(R) > 0 it is -U that is regular at R.
     beyond.tanner2.lem1. *)
From Coq Require Import Reals Lra Lia Psatz.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums tanner_nonsmooth.
Open Scope R_scope.

Lemma one_sided_eq f x w l m : l = m -> one_sided f x w l -> one_sided f x w m.
Proof. now intros ->. Qed.
Lemma clarke_eq f x w l m : l = m -> clarke f x w l -> clarke f x w m.
Proof. now intros ->. Qed.

(* both derivatives of a function whose difference quotients near x are near c *)
Definition strict_derivative (f : R -> R) (x c : R) := forall e, 0 < e -> exists d, 0 < d /\
  forall a b, Rabs (a - x) < d -> Rabs (b - x) < d -> Rabs (f b - f a - c * (b - a)) <= e * Rabs (b - a).

Lemma strict_quotient f x c w : strict_derivative f x c -> forall e, 0 < e -> exists d, 0 < d /\
  forall y h, Rabs (y - x) < d -> 0 < h < d -> Rabs ((f (y + h * w) - f y) / h - c * w) < e.
Proof.
  intros F e He. pose proof (Rabs_pos w) as Aw.
  destruct (F (e / (2 * (Rabs w + 1)))) as [d [Hd P]]; [apply Rdiv_lt_0_compat; lra|].
  exists (d / (2 * (Rabs w + 1))). assert (B : d / (2 * (Rabs w + 1)) <= d / 2).
  { unfold Rdiv. apply Rmult_le_compat_l; [lra|]. apply Rinv_le_contravar; lra. }
  split; [apply Rdiv_lt_0_compat; lra|]. intros y h Hy Hh.
  assert (L : h * Rabs w < d / 2). { apply Rle_lt_trans with (h * (Rabs w + 1)); [nra|].
    apply Rlt_le_trans with (d / (2 * (Rabs w + 1)) * (Rabs w + 1)); [nra|right; field; lra]. }
  assert (Z : Rabs (y + h * w - x) < d).
  { replace (y + h * w - x) with ((y - x) + h * w) by ring. eapply Rle_lt_trans; [apply Rabs_triang|].
    rewrite Rabs_mult, (Rabs_pos_eq h) by lra. lra. }
  specialize (P y (y + h * w) ltac:(lra) Z). replace (y + h * w - y) with (h * w) in P by ring.
  replace ((f (y + h * w) - f y) / h - c * w) with ((f (y + h * w) - f y - c * (h * w)) / h) by (field; lra).
  unfold Rdiv at 1. rewrite Rabs_mult, (Rabs_pos_eq (/ h)) by (left; apply Rinv_0_lt_compat; lra).
  apply Rle_lt_trans with (e / (2 * (Rabs w + 1)) * Rabs (h * w) * / h).
  - apply Rmult_le_compat_r; [left; apply Rinv_0_lt_compat; lra|exact P].
  - rewrite Rabs_mult, (Rabs_pos_eq h) by lra. replace (e / (2 * (Rabs w + 1)) * (h * Rabs w) * / h) with (e / 2 * (Rabs w / (Rabs w + 1))) by (field; lra).
    assert (Q : Rabs w / (Rabs w + 1) < 1). { apply (Rmult_lt_reg_r (Rabs w + 1)); [lra|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l; lra. }
    nra.
Qed.
Lemma strict_regular f x c : strict_derivative f x c -> regular f x.
Proof.
  intros F w. exists (c * w). pose proof (strict_quotient f x c w F) as P. split; [|split].
  - intros e He. destruct (P e He) as [d [Hd Q]]. exists d. split; [exact Hd|]. intros h Hh. apply Q; [|exact Hh].
    rewrite Rminus_eq_0, Rabs_R0. exact Hd.
  - intros e He. destruct (P e He) as [d [Hd Q]]. exists d. split; [exact Hd|]. intros y h Hy Hh. specialize (Q y h Hy Hh).
    apply Rabs_lt_between in Q. lra.
  - intros e d He Hd. destruct (P e He) as [b [Hb Q]]. exists x, (Rmin b d / 2).
    assert (M : 0 < Rmin b d) by (now apply Rmin_glb_lt). pose proof (Rmin_l b d). pose proof (Rmin_r b d).
    rewrite Rminus_eq_0, Rabs_R0. split; [exact Hd|]. split; [lra|].
    specialize (Q x (Rmin b d / 2)). rewrite Rminus_eq_0, Rabs_R0 in Q. specialize (Q Hb ltac:(lra)). apply Rabs_lt_between in Q. lra.
Qed.

Section Corrected.
Variables (V V' : R -> R) (R0 : R).
Hypothesis HR : 0 < R0.
Hypothesis D : forall s, 0 < s -> is_derive V s (V' s).
Hypothesis C : forall s, 0 < s -> continuity_pt V' s.
Notation U := (saturated V R0).

Lemma smooth_strict x : 0 < x -> forall e, 0 < e -> exists d, 0 < d < x /\
  forall a b, Rabs (a - x) < d -> Rabs (b - x) < d -> Rabs (V b - V a - V' x * (b - a)) <= e * Rabs (b - a).
Proof.
  intros Hx e He. destruct (C x Hx e He) as [d [Hd P]]. exists (Rmin d (x / 2)).
  assert (M : 0 < Rmin d (x / 2)) by (apply Rmin_glb_lt; lra). pose proof (Rmin_l d (x / 2)). pose proof (Rmin_r d (x / 2)).
  split; [lra|].
  assert (S : forall s, Rabs (s - x) < Rmin d (x / 2) -> Rabs (V' s - V' x) <= e).
  { intros s Hs. destruct (Req_dec s x) as [->|N]; [rewrite Rminus_eq_0, Rabs_R0; lra|]. left.
    apply (P s). split; [split; [exact I|congruence]|]. unfold dist; cbn; unfold R_dist. lra. }
  assert (W : forall a b, a <= b -> Rabs (a - x) < Rmin d (x / 2) -> Rabs (b - x) < Rmin d (x / 2) -> Rabs (V b - V a - V' x * (b - a)) <= e * Rabs (b - a)).
  { intros a b Hab Ha Hb. assert (Pa := Ha). assert (Pb := Hb). apply Rabs_lt_between in Pa, Pb.
    destruct (MVT_le V V' a b Hab) as [c [Hc E]]; [intros; apply D; lra|]. rewrite E.
    replace (V' c * (b - a) - V' x * (b - a)) with ((V' c - V' x) * (b - a)) by ring. rewrite Rabs_mult.
    apply Rmult_le_compat_r; [apply Rabs_pos|]. apply S, Rabs_def1; lra. }
  intros a b Ha Hb. destruct (Rle_or_lt a b) as [L|L]; [now apply W|].
  replace (V b - V a - V' x * (b - a)) with (- (V a - V b - V' x * (a - b))) by ring. rewrite Rabs_Ropp, (Rabs_minus_sym b a). apply W; lra.
Qed.
(* clause 1 *)
Theorem saturated_regular x : 0 < x -> x <> R0 -> regular U x.
Proof.
  intros Hx N. destruct (Rlt_or_le x R0) as [L|L].
  - apply (strict_regular U x (V' x)). intros e He. destruct (smooth_strict x Hx e He) as [d [Hd P]].
    exists (Rmin d (R0 - x)). pose proof (Rmin_l d (R0 - x)). pose proof (Rmin_r d (R0 - x)).
    split; [apply Rmin_glb_lt; lra|]. intros a b Ha Hb. assert (Pa := Ha). assert (Pb := Hb). apply Rabs_lt_between in Pa, Pb.
    unfold saturated. destruct (Rlt_dec a R0); [|lra]. destruct (Rlt_dec b R0); [|lra]. apply P; lra.
  - apply (strict_regular U x 0). intros e He. exists (x - R0). split; [lra|]. intros a b Ha Hb. apply Rabs_lt_between in Ha, Hb.
    unfold saturated. destruct (Rlt_dec a R0); [lra|]. destruct (Rlt_dec b R0); [lra|].
    replace (V R0 - V R0 - 0 * (b - a)) with 0 by ring. rewrite Rabs_R0. apply Rmult_le_pos; [lra|apply Rabs_pos].
Qed.

Hypothesis Hc : 0 < V' R0.
(* clause 3 *)
Theorem derivatives_at_R w : one_sided U R0 w (Rmin 0 (V' R0 * w)) /\ clarke U R0 w (Rmax 0 (V' R0 * w)).
Proof.
  pose proof (C R0 HR) as CR. split; [|now apply (saturated_clarke V V' R0 (V' R0))].
  destruct (Rle_or_lt 0 w) as [W|W].
  - apply (one_sided_eq _ _ _ 0); [rewrite Rmin_left; nra|]. now apply (saturated_right V R0).
  - apply (one_sided_eq _ _ _ (V' R0 * w)); [rewrite Rmin_right; nra|]. now apply (saturated_left V V' R0 (V' R0)).
Qed.
(* clause 2 *)
Lemma one_sided_opp f x w l : one_sided f x w l -> one_sided (fun s => - f s) x w (- l).
Proof.
  intros O e He. destruct (O e He) as [d [Hd P]]. exists d. split; [exact Hd|]. intros h Hh. specialize (P h Hh).
  replace ((- f (x + h * w) - - f x) / h - - l) with (- ((f (x + h * w) - f x) / h - l)) by (field; lra). now rewrite Rabs_Ropp.
Qed.
(* a quotient of -f from y along w is one of f from y + h w along -w *)
Lemma clarke_opp f x w l : clarke f x (- w) l -> clarke (fun s => - f s) x w l.
Proof.
  intros [K1 K2]. pose proof (Rabs_pos w) as Aw.
  assert (Move : forall d, 0 < d -> exists d', 0 < d' <= d /\ forall y h v, Rabs v = Rabs w -> Rabs (y - x) < d' -> 0 < h < d' -> Rabs (y + h * v - x) < d).
  { intros d Hd. exists (d / (2 * (Rabs w + 1))).
    assert (B : d / (2 * (Rabs w + 1)) <= d / 2). { unfold Rdiv. apply Rmult_le_compat_l; [lra|]. apply Rinv_le_contravar; lra. }
    split; [split; [apply Rdiv_lt_0_compat; lra|lra]|]. intros y h v Ev Hy Hh.
    assert (L : h * Rabs w < d / 2). { apply Rle_lt_trans with (h * (Rabs w + 1)); [nra|].
      apply Rlt_le_trans with (d / (2 * (Rabs w + 1)) * (Rabs w + 1)); [nra|right; field; lra]. }
    replace (y + h * v - x) with ((y - x) + h * v) by ring. eapply Rle_lt_trans; [apply Rabs_triang|].
    rewrite Rabs_mult, (Rabs_pos_eq h), Ev by lra. lra. }
  split.
  - intros e He. destruct (K1 e He) as [d [Hd P]]. destruct (Move d Hd) as [d' [Hd' M]]. exists d'. split; [lra|]. intros y h Hy Hh.
    specialize (P (y + h * w) h (M y h w eq_refl Hy Hh) ltac:(lra)). replace (y + h * w + h * - w) with y in P by ring.
    replace ((- f (y + h * w) - - f y) / h) with ((f y - f (y + h * w)) / h) by (field; lra). exact P.
  - intros e d He Hd. destruct (Move d Hd) as [d' [Hd' M]]. destruct (K2 e d' He ltac:(lra)) as [y [h [Hy [Hh P]]]].
    exists (y + h * - w), h. split; [apply M; [apply Rabs_Ropp|assumption|lra]|]. split; [lra|].
    replace (y + h * - w + h * w) with y by ring.
    replace ((- f y - - f (y + h * - w)) / h) with ((f (y + h * - w) - f y) / h) by (field; lra). exact P.
Qed.
Theorem negative_regular : regular (fun s => - U s) R0.
Proof.
  intros w. exists (Rmax 0 (V' R0 * - w)). split.
  - apply (one_sided_eq _ _ _ (- Rmin 0 (V' R0 * w))); [unfold Rmin, Rmax; destruct (Rle_dec 0 (V' R0 * w)), (Rle_dec 0 (V' R0 * - w)); lra|].
    apply one_sided_opp, derivatives_at_R.
  - apply clarke_opp, derivatives_at_R.
Qed.
End Corrected.
