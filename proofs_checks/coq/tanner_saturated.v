(* Tanner, Jadbabaie, Pappas, switching paper: what is true of Lemma 1.  The saturated potential U(s) = V(s) for s < R, V(R) for
   s >= R, is regular at every distance but R, and where V'(R) > 0 it is -U that is regular at R.  At the end
   the generalised gradient of U with respect to the place of one agent.
     beyond.tanner2.lem1, beyond.tanner2.lem2. *)
From Coq Require Import Reals Lra Lia Psatz.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums paley_model tanner_nonsmooth.
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

(* ---- in the plane, as a function of the place of one agent ---- *)
Definition clarke2 (f : C -> R) (x w : C) (l : R) :=
  (forall e, 0 < e -> exists d, 0 < d /\ forall y h, Cmod (y - x)%C < d -> 0 < h < d -> (f (y + RtoC h * w)%C - f y) / h < l + e) /\
  (forall e d, 0 < e -> 0 < d -> exists y h, Cmod (y - x)%C < d /\ 0 < h < d /\ l - e < (f (y + RtoC h * w)%C - f y) / h).
Definition gen_gradient2 (f : C -> R) (x z : C) := forall w l, clarke2 f x w l -> inner z w <= l.
Lemma clarke2_unique f x w l m : clarke2 f x w l -> clarke2 f x w m -> l = m.
Proof.
  assert (A : forall l m, clarke2 f x w l -> clarke2 f x w m -> l <= m).
  { clear. intros l m [_ L] [M _]. apply Rnot_lt_le. intros H. destruct (M ((l - m) / 2) ltac:(lra)) as [d [Hd Md]].
    destruct (L ((l - m) / 2) d ltac:(lra) Hd) as [y [h [Hy [Hh Q]]]]. specialize (Md y h Hy Hh). lra. }
  intros L M. apply Rle_antisym; now apply A.
Qed.
Lemma inner_le x y : inner x y <= Cmod x * Cmod y.
Proof.
  apply Rnot_lt_le. intros L. pose proof (Cmod_ge_0 x). pose proof (Cmod_ge_0 y).
  assert (Q : inner x y ^ 2 <= (Cmod x * Cmod y) ^ 2).
  { rewrite Rpow_mult_distr, <- !inner_self, !inner_xy. pose proof (pow2_ge_0 (fst x * snd y - snd x * fst y)). nra. }
  assert (0 <= Cmod x * Cmod y) by (apply Rmult_le_pos; assumption). nra.
Qed.
(* |p| - |q| is between <q, p - q>/|q| and <p, p - q>/|p| *)
Lemma norm_step p q : 0 < Cmod p -> Cmod p - Cmod q <= inner p (p - q)%C / Cmod p.
Proof.
  intros P. apply Rmult_le_reg_r with (Cmod p); [exact P|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra.
  rewrite inner_minus, inner_self. pose proof (inner_le p q). nra.
Qed.
Lemma Cmod_gap x y : Rabs (Cmod x - Cmod y) <= Cmod (x - y)%C.
Proof.
  apply Rabs_le. pose proof (Cmod_triangle (x - y)%C y) as A. pose proof (Cmod_triangle (- (x - y))%C x) as B. rewrite Cmod_opp in B.
  replace (x - y + y)%C with x in A by ring. replace (- (x - y) + x)%C with y in B by ring. lra.
Qed.
(* the direction of p is near that of q *)
Lemma direction_near p q w : 0 < Cmod p -> 0 < Cmod q -> inner p w / Cmod p - inner q w / Cmod q <= 2 * Cmod w * Cmod (p - q)%C / Cmod q.
Proof.
  intros P Q. pose proof (Cmod_gap q p) as G. replace (Cmod (q - p)%C) with (Cmod (p - q)%C) in G by (rewrite <- Cmod_opp; f_equal; ring).
  pose proof (inner_le (p - q)%C w) as I1. pose proof (inner_le p w) as I2. pose proof (inner_le (- p)%C w) as I3. rewrite Cmod_opp in I3.
  assert (I4 : Rabs (inner p w) <= Cmod p * Cmod w).
  { apply Rabs_le. split; [|exact I2]. replace (inner (- p)%C w) with (- inner p w) in I3 by (rewrite !inner_xy; cbn; ring). lra. }
  assert (E : inner (p - q)%C w = inner p w - inner q w) by (rewrite !inner_xy; cbn; ring). rewrite E in I1.
  replace (inner p w / Cmod p - inner q w / Cmod q) with ((inner p w - inner q w) / Cmod q + inner p w / Cmod p * (Cmod q - Cmod p) / Cmod q) by (field; lra).
  assert (B : inner p w / Cmod p * (Cmod q - Cmod p) <= Cmod w * Cmod (p - q)%C).
  { eapply Rle_trans; [apply Rle_abs|]. rewrite Rabs_mult. apply Rmult_le_compat; try apply Rabs_pos; [|exact G].
    unfold Rdiv. rewrite Rabs_mult, (Rabs_pos_eq (/ Cmod p)) by (left; now apply Rinv_0_lt_compat).
    apply Rmult_le_reg_r with (Cmod p); [exact P|]. rewrite Rmult_assoc, Rinv_l by lra. lra. }
  replace (2 * Cmod w * Cmod (p - q)%C / Cmod q) with (Cmod (p - q)%C * Cmod w / Cmod q + Cmod w * Cmod (p - q)%C / Cmod q) by (field; lra).
  unfold Rdiv at 1 2 3 4. apply Rplus_le_compat; (apply Rmult_le_compat_r; [left; now apply Rinv_0_lt_compat|assumption]).
Qed.

Section Plane.
Variables (V V' : R -> R) (R0 c : R) (ri rj : C).
Hypothesis HR : 0 < R0.
Hypothesis D : forall s, 0 < s -> is_derive V s (V' s).
Hypothesis Cn : continuity_pt V' R0.
Hypothesis Vc : V' R0 = c.
Hypothesis Hc : 0 < c.
Hypothesis At : Cmod (ri - rj)%C = R0.
Notation U := (fun y : C => saturated V R0 (Cmod (y - rj)%C)).
Notation n := (ri - rj)%C.
Lemma slope_near e : 0 < e -> exists d, 0 < d /\ d < R0 /\ forall s, Rabs (s - R0) < d -> Rabs (V' s - c) < e.
Proof. exact (near_slope V' R0 c HR Cn Vc e). Qed.
Lemma moved_distance y h w : 0 < h -> Rabs (Cmod (y + RtoC h * w - rj)%C - Cmod (y - rj)%C) <= h * Cmod w.
Proof.
  intros Hh. eapply Rle_trans; [apply Cmod_gap|]. replace (y + RtoC h * w - rj - (y - rj))%C with (RtoC h * w)%C by ring.
  rewrite Cmod_mult, Cmod_R, Rabs_pos_eq; lra.
Qed.
Lemma distance_near y : Rabs (Cmod (y - rj)%C - R0) <= Cmod (y - ri)%C.
Proof. rewrite <- At. eapply Rle_trans; [apply Cmod_gap|]. right. f_equal. ring. Qed.
Lemma inner_shift p h w : inner p (RtoC h * w)%C = h * inner p w.
Proof. rewrite !inner_xy. cbn. ring. Qed.
Theorem plane_clarke w : clarke2 U ri w (Rmax 0 (c * (inner n w / R0))).
Proof.
  set (g := inner n w / R0). pose proof (Cmod_ge_0 w) as W0. split.
  - intros e He. set (b := Cmod w + 1). assert (b0 : 0 < b) by (unfold b; lra).
    destruct (slope_near (Rmin c (e / (4 * b)))) as [d [Hd [HdR Sl]]].
    { apply Rmin_glb_lt; [lra|apply Rdiv_lt_0_compat; lra]. }
    set (q := Rmin (d / 2) (e * R0 / (16 * c * b * b))).
    assert (q0 : 0 < q). { apply Rmin_glb_lt; [lra|]. apply Rdiv_lt_0_compat; [nra|]. repeat apply Rmult_lt_0_compat; lra. }
    pose proof (Rmin_l (d / 2) (e * R0 / (16 * c * b * b))) as q1. pose proof (Rmin_r (d / 2) (e * R0 / (16 * c * b * b))) as q2. fold q in q1, q2.
    exists (q / b). assert (qb : 0 < q / b) by now apply Rdiv_lt_0_compat.
    assert (qb1 : q / b <= q). { unfold Rdiv. rewrite <- (Rmult_1_r q) at 2. apply Rmult_le_compat_l; [lra|]. rewrite <- Rinv_1. apply Rinv_le_contravar; unfold b; lra. }
    split; [exact qb|]. intros y h Hy Hh.
    assert (hw : h * Cmod w < q). { apply Rle_lt_trans with (h * b); [unfold b; nra|]. apply Rlt_le_trans with (q / b * b); [nra|right; field; lra]. }
    pose proof (distance_near y) as Ny. pose proof (moved_distance y h w ltac:(lra)) as Mv.
    set (s := Cmod (y - rj)%C) in *. set (s' := Cmod (y + RtoC h * w - rj)%C) in *.
    apply Rabs_le_between in Ny. apply Rabs_le_between in Mv.
    destruct (saturated_diff V V' R0 D d s s' HdR) as [x [Hx E]]; [apply Rabs_def1; lra|apply Rabs_def1; lra|].
    specialize (Sl x Hx). apply Rabs_lt_between in Sl. pose proof (Rmin_l c (e / (4 * b))) as m1. pose proof (Rmin_r c (e / (4 * b))) as m2.
    assert (s'0 : 0 < s') by lra.
    pose proof (norm_step (y + RtoC h * w - rj)%C (y - rj)%C s'0) as St. fold s s' in St.
    replace (y + RtoC h * w - rj - (y - rj))%C with (RtoC h * w)%C in St by ring. rewrite inner_shift in St.
    pose proof (direction_near (y + RtoC h * w - rj)%C n w s'0 ltac:(rewrite At; exact HR)) as Dn. fold s' in Dn. rewrite At in Dn.
    fold g in Dn. assert (Sm : Cmod (y + RtoC h * w - rj - n)%C <= 2 * q).
    { replace (y + RtoC h * w - rj - n)%C with ((y - ri) + RtoC h * w)%C by ring. eapply Rle_trans; [apply Cmod_triangle|]. rewrite Cmod_mult, Cmod_R, Rabs_pos_eq by lra. lra. }
    assert (Gr : 2 * Cmod w * Cmod (y + RtoC h * w - rj - n)%C / R0 <= e / (4 * c)).
    { apply Rmult_le_reg_r with R0; [exact HR|]. unfold Rdiv at 1. rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra.
      apply Rle_trans with (2 * b * (2 * q)); [apply Rmult_le_compat; [lra|apply Cmod_ge_0|unfold b; lra|exact Sm]|].
      apply Rle_trans with (4 * b * (e * R0 / (16 * c * b * b))); [nra|].
      replace (4 * b * (e * R0 / (16 * c * b * b))) with (e * R0 / (4 * c) * / b) by (field; lra).
      replace (e / (4 * c) * R0) with (e * R0 / (4 * c) * 1) by (field; lra). apply Rmult_le_compat_l.
      - left. apply Rdiv_lt_0_compat; [nra|lra].
      - rewrite <- Rinv_1. apply Rinv_le_contravar; unfold b; lra. }
    set (k := g + e / (4 * c)) in *.
    assert (Di : s' - s <= h * k).
    { apply Rle_trans with (1 := St). unfold Rdiv. rewrite Rmult_assoc. apply Rmult_le_compat_l; [lra|]. unfold k. unfold Rdiv in *. lra. }
    assert (Di2 : s' - s <= h * b) by (unfold b; nra).
    rewrite E. apply (Rmult_lt_reg_r h); [lra|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra.
    assert (V0 : 0 < V' x) by lra.
    assert (Cl : Rmin s' R0 - Rmin s R0 <= Rmax 0 (s' - s)).
    { unfold Rmin, Rmax. destruct (Rle_dec s' R0), (Rle_dec s R0), (Rle_dec 0 (s' - s)); lra. }
    pose proof (Rmax_l 0 (c * g)) as L0. pose proof (Rmax_r 0 (c * g)) as L1.
    destruct (Rle_or_lt (s' - s) 0) as [N|N].
    + rewrite Rmax_left in Cl by lra. apply Rle_lt_trans with 0; [nra|]. apply Rmult_lt_0_compat; lra.
    + rewrite Rmax_right in Cl by lra. apply Rle_lt_trans with (V' x * (s' - s)); [apply Rmult_le_compat_l; lra|].
      apply Rle_lt_trans with (c * (h * k) + e / (4 * b) * (h * b)).
      * replace (V' x * (s' - s)) with (c * (s' - s) + (V' x - c) * (s' - s)) by ring.
        apply Rplus_le_compat; [apply Rmult_le_compat_l; lra|].
        assert (eb : 0 < e / (4 * b)) by (apply Rdiv_lt_0_compat; lra).
        apply Rle_trans with (e / (4 * b) * (s' - s)); [apply Rmult_le_compat_r; lra|apply Rmult_le_compat_l; lra].
      * replace (e / (4 * b) * (h * b)) with (e / 4 * h) by (field; lra). unfold k.
        replace (c * (h * (g + e / (4 * c)))) with (c * g * h + e / 4 * h) by (field; lra). nra.
  - intros e d He Hd. destruct (Rle_or_lt g 0) as [G|G].
    + (* outside: U is constant *)
      set (t := Rmin 1 (d / (2 * R0))). assert (t0 : 0 < t) by (apply Rmin_glb_lt; [lra|apply Rdiv_lt_0_compat; lra]).
      pose proof (Rmin_r 1 (d / (2 * R0))) as t1. fold t in t1.
      assert (tR : t * R0 <= d / 2). { apply (Rmult_le_compat_r R0) in t1; [|lra]. replace (d / (2 * R0) * R0) with (d / 2) in t1 by (field; lra). exact t1. }
      assert (tp : 0 < t * R0) by now apply Rmult_lt_0_compat.
      exists (ri + RtoC t * n)%C, (Rmin (d / 2) (t * R0 / (Cmod w + 1))).
      assert (h0 : 0 < Rmin (d / 2) (t * R0 / (Cmod w + 1))) by (apply Rmin_glb_lt; [lra|apply Rdiv_lt_0_compat; lra]).
      pose proof (Rmin_l (d / 2) (t * R0 / (Cmod w + 1))) as h1. pose proof (Rmin_r (d / 2) (t * R0 / (Cmod w + 1))) as h2. set (h := Rmin (d / 2) (t * R0 / (Cmod w + 1))) in *.
      assert (hw : h * Cmod w <= t * R0). { apply (Rmult_le_compat_r (Cmod w + 1)) in h2; [|lra]. replace (t * R0 / (Cmod w + 1) * (Cmod w + 1)) with (t * R0) in h2 by (field; lra). apply Rle_trans with (2 := h2). apply Rmult_le_compat_l; lra. }
      assert (Sy : Cmod (ri + RtoC t * n - rj)%C = (1 + t) * R0).
      { replace (ri + RtoC t * n - rj)%C with (RtoC (1 + t) * n)%C by (apply injective_projections; cbn; ring). rewrite Cmod_mult, Cmod_R, Rabs_pos_eq, At; lra. }
      split; [|split; [lra|]].
      * replace (ri + RtoC t * n - ri)%C with (RtoC t * n)%C by ring. rewrite Cmod_mult, Cmod_R, Rabs_pos_eq, At; lra.
      * pose proof (moved_distance (ri + RtoC t * n)%C h w h0) as Mv. rewrite Sy in Mv. apply Rabs_le_between in Mv.
        rewrite !saturated_min, Sy, !Rmin_right by lra. unfold Rdiv. rewrite Rminus_eq_0, Rmult_0_l. rewrite Rmax_left by nra. lra.
    + (* inside: U is V, and distances grow at least at the rate g *)
      destruct (slope_near (Rmin c (e / g))) as [b [Hb [HbR Sl]]]; [apply Rmin_glb_lt; [lra|now apply Rdiv_lt_0_compat]|].
      pose (m := Rmin b d). assert (Hm : 0 < m) by (unfold m; apply Rmin_glb_lt; lra). pose proof (Rmin_l b d) as mb. pose proof (Rmin_r b d) as md. fold m in mb, md.
      set (t := m / (2 * R0)). assert (t0 : 0 < t) by (apply Rdiv_lt_0_compat; lra). assert (tR : t * R0 = m / 2) by (unfold t; field; lra).
      assert (t1 : t < 1). { apply Rmult_lt_reg_r with R0; [exact HR|]. lra. }
      exists (ri - RtoC t * n)%C, (Rmin (m / 4 / (Cmod w + 1)) (m / 2)).
      assert (P : 0 < m / 4 / (Cmod w + 1)) by (apply Rdiv_lt_0_compat; lra).
      assert (h0 : 0 < Rmin (m / 4 / (Cmod w + 1)) (m / 2)) by (apply Rmin_glb_lt; lra).
      pose proof (Rmin_l (m / 4 / (Cmod w + 1)) (m / 2)) as h1. pose proof (Rmin_r (m / 4 / (Cmod w + 1)) (m / 2)) as h2. set (h := Rmin (m / 4 / (Cmod w + 1)) (m / 2)) in *.
      assert (hw : h * Cmod w <= m / 4). { apply (Rmult_le_compat_r (Cmod w + 1)) in h1; [|lra]. replace (m / 4 / (Cmod w + 1) * (Cmod w + 1)) with (m / 4) in h1 by (field; lra). apply Rle_trans with (2 := h1). apply Rmult_le_compat_l; lra. }
      assert (Ny : (ri - RtoC t * n - rj)%C = (RtoC (1 - t) * n)%C) by (apply injective_projections; cbn; ring).
      assert (Sy : Cmod (ri - RtoC t * n - rj)%C = R0 - m / 2) by (rewrite Ny, Cmod_mult, Cmod_R, Rabs_pos_eq, At; lra).
      split; [|split; [lra|]].
      * replace (ri - RtoC t * n - ri)%C with (RtoC (- t) * n)%C by (apply injective_projections; cbn; ring). rewrite Cmod_mult, Cmod_R, Rabs_Ropp, Rabs_pos_eq, At; lra.
      * pose proof (moved_distance (ri - RtoC t * n)%C h w h0) as Mv. rewrite Sy in Mv. apply Rabs_le_between in Mv.
        pose proof (norm_step (ri - RtoC t * n - rj)%C (ri - RtoC t * n + RtoC h * w - rj)%C ltac:(rewrite Sy; lra)) as St. rewrite Sy in St.
        replace (ri - RtoC t * n - rj - (ri - RtoC t * n + RtoC h * w - rj))%C with (RtoC (- h) * w)%C in St by (apply injective_projections; cbn; ring).
        rewrite Ny in St. assert (F : inner (RtoC (1 - t) * n)%C (RtoC (- h) * w)%C = - h * (1 - t) * (g * R0)).
        { unfold g. replace (inner n w / R0 * R0) with (inner n w) by (field; lra). rewrite !inner_xy. cbn. ring. }
        rewrite F in St. replace (- h * (1 - t) * (g * R0) / (R0 - m / 2)) with (- (h * g)) in St by (rewrite <- tR; field; nra).
        set (s' := Cmod (ri - RtoC t * n + RtoC h * w - rj)%C) in *.
        destruct (saturated_diff V V' R0 D b (R0 - m / 2) s' HbR) as [x [Hx E]]; [apply Rabs_def1; lra|apply Rabs_def1; lra|].
        rewrite Sy, E, !Rmin_left by lra. specialize (Sl x Hx). apply Rabs_lt_between in Sl.
        pose proof (Rmin_l c (e / g)) as m1. pose proof (Rmin_r c (e / g)) as m2. assert (V0 : 0 < V' x) by lra.
        apply (Rmult_lt_reg_r h); [exact h0|]. replace (V' x * (s' - (R0 - m / 2)) / h * h) with (V' x * (s' - (R0 - m / 2))) by (field; lra).
        apply Rlt_le_trans with (V' x * (h * g)); [|apply Rmult_le_compat_l; lra].
        rewrite Rmax_right by nra. assert (eg : e / g * g = e) by (field; lra). assert (hg : 0 < h * g) by now apply Rmult_lt_0_compat.
        assert ((c - e / g) * (h * g) < V' x * (h * g)) by (apply Rmult_lt_compat_r; lra).
        replace ((c * g - e) * h) with ((c - e / g) * (h * g)) by (field; lra). assumption.
Qed.
(* tanner2.lem2: the segment from 0 to the gradient of V *)
Theorem plane_gradient z : gen_gradient2 U ri z <-> exists s, 0 <= s <= 1 /\ z = (RtoC s * (RtoC (c / R0) * n))%C.
Proof.
  assert (NN : inner n n = R0 ^ 2) by (rewrite inner_self, At; reflexivity). set (k := c / R0). assert (k0 : 0 < k) by now apply Rdiv_lt_0_compat.
  assert (L : forall w, Rmax 0 (c * (inner n w / R0)) = Rmax 0 (k * inner n w)) by (intros w; f_equal; unfold k; field; lra). split.
  - intros G. assert (Le : forall w, inner z w <= Rmax 0 (k * inner n w)) by (intros w; rewrite <- L; apply G, plane_clarke).
    pose proof (Le (Ci * n)%C) as A1. pose proof (Le (- (Ci * n))%C) as A2. pose proof (Le n) as A3. pose proof (Le (- n)%C) as A4.
    replace (inner n (Ci * n)%C) with 0 in A1 by (rewrite inner_xy; cbn; ring). replace (inner n (- (Ci * n))%C) with 0 in A2 by (rewrite inner_xy; cbn; ring).
    rewrite Rmult_0_r, Rmax_left in A1, A2 by lra. replace (inner z (- (Ci * n))%C) with (- inner z (Ci * n)%C) in A2 by (rewrite !inner_xy; cbn; ring).
    replace (inner z (- n)%C) with (- inner z n) in A4 by (rewrite !inner_xy; cbn; ring). replace (inner n (- n)%C) with (- inner n n) in A4 by (rewrite !inner_xy; cbn; ring).
    rewrite NN in A3, A4. assert (R2 : 0 < R0 ^ 2) by now apply pow_lt. assert (kR : 0 < k * R0 ^ 2) by now apply Rmult_lt_0_compat.
    rewrite Rmax_right in A3 by lra. rewrite Rmax_left in A4 by lra. assert (A0 : inner z (Ci * n)%C = 0) by lra.
    exists (inner z n / (k * R0 ^ 2)). split.
    + split; [apply Rmult_le_pos; [lra|left; now apply Rinv_0_lt_compat]|]. apply Rmult_le_reg_r with (k * R0 ^ 2); [exact kR|].
      unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. lra.
    + assert (E : forall p : C, inner p p = R0 ^ 2 -> inner z (Ci * p)%C = 0 -> z = (RtoC (inner z p / (k * R0 ^ 2)) * (RtoC k * p))%C).
      { intros [p1 p2] N2 O. destruct z as [z1 z2]. rewrite inner_xy in N2, O |- *. cbn [fst snd Ci Cmult] in N2, O |- *.
        assert (N3 : 0 < p1 * p1 + p2 * p2) by lra. rewrite <- N2. assert (O' : z2 * p1 = z1 * p2) by lra.
        apply injective_projections; cbn [fst snd Cmult RtoC]; apply (Rmult_eq_reg_r (p1 * p1 + p2 * p2)); try lra.
        - transitivity ((z1 * p1 + z2 * p2) * p1); [|field; lra]. replace ((z1 * p1 + z2 * p2) * p1) with (z1 * p1 * p1 + (z2 * p1) * p2) by ring. rewrite O'. ring.
        - transitivity ((z1 * p1 + z2 * p2) * p2); [|field; lra]. replace ((z1 * p1 + z2 * p2) * p2) with ((z1 * p2) * p1 + z2 * p2 * p2) by ring. rewrite <- O'. ring. }
      exact (E n NN A0).
  - intros (s & Hs & ->) w l K. rewrite (clarke2_unique _ _ _ _ _ K (plane_clarke w)), L.
    replace (inner (RtoC s * (RtoC k * n))%C w) with (s * (k * inner n w)) by (rewrite !inner_xy; cbn; ring).
    pose proof (Rmax_l 0 (k * inner n w)). pose proof (Rmax_r 0 (k * inner n w)). destruct (Rle_or_lt 0 (k * inner n w)); nra.
Qed.
End Plane.
