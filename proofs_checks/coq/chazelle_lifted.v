(* Chazelle, (3.15): lengths of v_i(t) and w = x_i(t)/t are n^O(1) along every motion of the model, so that the lower bound 1/(1 + B^2) of the quotient
   (chazelle_worked.angle_bounds) is n^-O(1).
     chazelle.eq3.15 (clause 2).
   Averaging keeps coordinates of velocities below n^b, and those of x(t) below (t + 1) n^b.  Any real closed field, no axioms. *)
Set Warnings "-notation-overridden,-ambiguous-paths".
From mathcomp Require Import all_ssreflect all_algebra.
From Flockproof Require Import chazelle_model chazelle_ergodicity.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Import GRing.Theory Num.Theory Order.Theory.
Local Open Scope ring_scope.

Section Lifted.
Variables (R : rcfType) (n d b : nat) (P : nat -> 'M[R]_n) (x v : nat -> 'M[R]_(n, d)).
Hypothesis n2 : (2 <= n)%N.
Hypothesis dn : (d <= n ^ 2)%N.
Hypothesis SP : forall t, (0 < t)%N -> stochastic (P t).
Hypothesis Hv : forall t, (0 < t)%N -> v t.+1 = P t *m v t.
Hypothesis Hx : forall t, x t.+1 = x t + v t.+1.
Hypothesis v1 : forall i q, `|v 1%N i q| <= n%:R ^+ b.
Hypothesis x0 : forall i q, `|x 0%N i q| <= n%:R ^+ b.
Let N0 : 0 <= n%:R ^+ b :> R. Proof. by rewrite exprn_ge0 ?ler0n. Qed.

Lemma velocity_le t i q : (0 < t)%N -> `|v t i q| <= n%:R ^+ b.
Proof.
case: t => // t _; elim: t i => [|t IH] i; first exact: v1.
have [P0 P1] := SP (ltn0Sn t); rewrite Hv // mxE; apply: le_trans (ler_norm_sum _ _ _) _.
move: (n%:R ^+ b) IH => B IH; rewrite -[X in _ <= X]mul1r -(P1 i) mulr_suml; apply: ler_sum => k _.
by rewrite normrM ger0_norm ?P0 //; apply: ler_wpmul2l; [exact: P0 | exact: IH].
Qed.
Lemma position_le t i q : `|x t i q| <= t.+1%:R * n%:R ^+ b.
Proof.
elim: t => [|t IH]; first by rewrite mul1r.
rewrite Hx mxE; apply: le_trans (ler_norm_add _ _) _; rewrite [t.+2%:R]mulrSr mulrDl mul1r; apply: ler_add => //; exact: velocity_le.
Qed.
Lemma length_le (y : 'rV[R]_d) : (forall q, `|y 0 q| <= 2%:R * n%:R ^+ b) -> 1 + norm2 y ^+ 2 <= n%:R ^+ (2 * b + 5).
Proof.
move=> H; rewrite norm2_sqr; set S := \sum_k _.
have le : S <= (n ^ (2 * b + 4))%:R.
  apply: (@le_trans _ _ (\sum_(k < d) (4 * n ^ (2 * b))%:R)).
    apply: ler_sum => k _; have -> : (4 * n ^ (2 * b))%:R = (2%:R * n%:R ^+ b) ^+ 2 :> R.
      by rewrite exprMn -exprM [(b * 2)%N]mulnC natrM natrX -[2%:R ^+ 2]natrX.
    rewrite -(real_normK (num_real (y 0 k))); apply: ler_expn2r; [by rewrite nnegrE | by rewrite nnegrE (le_trans _ (H k)) | exact: H].
  rewrite sumr_const card_ord -mulr_natr -natrM ler_nat expnD [(4 * _)%N]mulnC -mulnA leq_mul2l; apply/orP; right.
  rewrite (_ : (n ^ 4 = n ^ 2 * n ^ 2)%N); last by rewrite -expnD.
  by rewrite leq_mul // (leq_exp2r 2 n (isT : 0 < 2)%N).
apply: (@le_trans _ _ (1 + (n ^ (2 * b + 4))%:R)); first by rewrite ler_add2l.
have -> : n%:R ^+ (2 * b + 5) = (n * n ^ (2 * b + 4))%:R :> R by rewrite -natrX -expnS -addnS.
rewrite -[1]/(1%:R) -natrD ler_nat.
have : (0 < n ^ (2 * b + 4))%N by rewrite expn_gt0 (leq_trans _ n2).
move: (n ^ (2 * b + 4))%N => M M0; apply: (@leq_trans (2 * M)); last by rewrite leq_mul2r n2 orbT.
by rewrite mul2n -addnn leq_add2r.
Qed.
(* chazelle.eq3.15, clause 2: the quotient is at least 1/(1 + B^2) where B is the larger length *)
Theorem lifted_lengths t i : (0 < t)%N ->
  1 + norm2 (row i (v t)) ^+ 2 <= n%:R ^+ (2 * b + 5) /\ 1 + norm2 (t%:R^-1 *: row i (x t)) ^+ 2 <= n%:R ^+ (2 * b + 5).
Proof.
move=> t0; have tR : 0 < t%:R :> R by rewrite ltr0n.
split; apply: length_le => q; rewrite !mxE.
  by apply: le_trans (velocity_le i q t0) _; rewrite ler_pemull // ler1n.
rewrite normrM normfV normr_nat ler_pdivr_mull // mulrA; apply: le_trans (position_le t i q) _; apply: ler_wpmul2r => //.
by rewrite -natrM ler_nat muln2 -addnn -addn1 leq_add2l.
Qed.
End Lifted.
