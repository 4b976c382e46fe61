(* Chazelle, section 3 and Remark 2: what the contraction of tau_1 (chazelle_recurrent.v) says about velocities
   v(t+1) = P(t) v(t) when the network is connected only over windows of time.
     chazelle.fiedler.rate, chazelle.eq3.6.
   A later state is made of averages of an earlier one, so its rows stay in the hull of the earlier rows, and
   all later rows of all birds are as close as the contraction says: one Cauchy sequence with an explicit rate.
   Where Cauchy sequences converge (the real numbers) all velocities have one common limit. *)
Set Warnings "-notation-overridden,-ambiguous-paths".
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import ring zify.
From Flockproof Require Import chazelle_model chazelle_ergodicity chazelle_products chazelle_limits chazelle_recurrent.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Import GRing.Theory Num.Theory Order.Theory.
Local Open Scope ring_scope.

(* ---- a later state is made of averages of an earlier one ---- *)
Section Averages.
Variables (R : realFieldType) (n d : nat) (P : nat -> 'M[R]_n) (v : nat -> 'M[R]_(n, d)).
Hypothesis SP : forall t, stochastic (P t).
Hypothesis Hv : forall t, (0 < t)%N -> v t.+1 = P t *m v t.

Lemma later k l : v (k + l).+1 = span P k.+1 l *m v k.+1.
Proof.
elim: l => [|l IH]; first by rewrite addn0 mul1mx.
by rewrite addnS Hv // IH mulmxA /= addSn.
Qed.

Variable N : 'rV[R]_d -> R.
Hypothesis N0 : N 0 = 0.
Hypothesis NZ : forall a x, N (a *: x) = `|a| * N x.
Hypothesis ND : forall x y, N (x + y) <= N x + N y.

Lemma averages_close m (A B : 'M[R]_(m, n)) (V : 'M[R]_(n, d)) i j : stochastic A -> stochastic B ->
  N (row i (A *m V) - row j (B *m V)) <= diameter N V.
Proof.
move=> [A0 A1] [B0 B1]; have S : stochastic (col_mx A B).
  split=> [x k|x]; rewrite -(splitK x); case: (split x) => y /=.
  - by rewrite col_mxEu.
  - by rewrite col_mxEd.
  - by rewrite -[RHS](A1 y); apply: eq_bigr => k _; rewrite col_mxEu.
  by rewrite -[RHS](B1 y); apply: eq_bigr => k _; rewrite col_mxEd.
have -> : row i (A *m V) - row j (B *m V) = row (lshift m i) (col_mx A B *m V) - row (rshift m j) (col_mx A B *m V).
  by rewrite mul_col_mx rowKu rowKd.
apply: le_trans (diameter_ub _ _ _ _) _; apply: le_trans (diameter_mul N0 NZ ND _ S) _.
by rewrite -[X in _ <= X]mul1r; apply: ler_wpmul2r; [exact: max_ge0 | exact: tau1_le1].
Qed.

(* all birds at all times after k *)
Lemma after_close k t u i j : (k < t)%N -> (k < u)%N ->
  N (row i (v t) - row j (v u)) <= tau1 (span P 1 k) * diameter N (v 1%N).
Proof.
move=> kt ku; have SS s l := stochastic_span s l SP.
have -> : v t = span P k.+1 (t - k.+1) *m v k.+1 by rewrite -later -addSn subnKC.
have -> : v u = span P k.+1 (u - k.+1) *m v k.+1 by rewrite -later -addSn subnKC.
apply: le_trans (averages_close _ _ _ (SS _ _) (SS _ _)) _.
have -> : v k.+1 = span P 1 k *m v 1%N by rewrite -later.
exact: (diameter_mul N0 NZ ND (v 1%N) (SS 1%N k)).
Qed.
End Averages.

(* ---- windows of B consecutive times, directed networks ---- *)
Theorem velocities_repeatedly (R : realFieldType) n d (P : nat -> 'M[R]_n) (v : nat -> 'M[R]_(n, d)) gamma B
  (N : 'rV[R]_d -> R) k t u i j :
  N 0 = 0 -> (forall a x, N (a *: x) = `|a| * N x) -> (forall x y, N (x + y) <= N x + N y) ->
  (forall t, stochastic (P t)) -> (forall t i, 0 < P t i i) -> 0 < gamma ->
  (forall t i j, P t i j != 0 -> gamma <= P t i j) ->
  (forall s, rooted (window P s B)) -> (forall t, (0 < t)%N -> v t.+1 = P t *m v t) ->
  (k < t)%N -> (k < u)%N ->
  N (row i (v t) - row j (v u)) <= (1 - gamma ^+ (n.-1 * B)) ^+ (k %/ (n.-1 * B)) * diameter N (v 1%N).
Proof.
move=> N0 NZ ND SP diag g0 gle W Hv kt ku.
apply: le_trans (after_close SP Hv N0 NZ ND i j kt ku) _.
by apply: ler_wpmul2r; [exact: max_ge0 | exact: tau1_repeatedly SP diag g0 gle W 1%N k].
Qed.

(* ---- the flock: networks, weights of model D, windows of any lengths ---- *)
Section Flock.
Variables (R : realFieldType) (n : nat) (G : nat -> rel 'I_n) (c : nat -> 'I_n -> R) (alpha : R).
Hypothesis net : forall t, network (G t).
Hypothesis MD : forall t, model_D (G t) (c t).
Let P t := transition (G t) (c t).
Hypothesis alpha0 : 0 < alpha.
Hypothesis alpha_le : forall t i j, P t i j != 0 -> alpha <= P t i j.

(* the union of the networks from time s to s + k - 1 *)
Definition union s k : rel 'I_n := fun i j => [exists u : 'I_k, G (s + u)%N i j].

Lemma union_window s k i j : connect (union s k) i j -> connect (window P s k) i j.
Proof.
apply: connect_sub => a b /existsP[u ab]; apply: connect1; apply/existsP; exists u.
by rewrite transition_edge // ab orbT.
Qed.
Fixpoint connected_windows s (ks : seq nat) : Prop :=
  if ks is k :: ks' then (forall i j, connect (union s k) i j) /\ connected_windows (s + k)%N ks' else True.

Let SP t : stochastic (P t). Proof. by case: (model_D_stochastic (net t) (@MD t)). Qed.
Let diag t i : 0 < P t i i. Proof. by case: (model_D_stochastic (net t) (@MD t)). Qed.
Let sym t i j : (P t i j != 0) = (P t j i != 0).
Proof. by rewrite !transition_edge // eq_sym; have [-> _] := net t. Qed.

Lemma connected_rooted (i : 'I_n) s ks : connected_windows s ks -> rooted_windows P s ks.
Proof.
elim: ks s => [|k ks IH] s //= [C W]; split; last exact: IH.
by exists i => j; exact: union_window.
Qed.

(* q (n-1) windows, of any lengths: tau_1 is at most (1 - alpha^(n-1))^q *)
Theorem recurrent_tau1 s ks : connected_windows s ks ->
  tau1 (span P s (sumn ks)) <= (1 - alpha ^+ n.-1) ^+ (size ks %/ n.-1).
Proof.
move=> W; case: (pickP 'I_n) => [i _|none].
  exact: (tau1_connected_windows SP diag sym alpha0 alpha_le (connected_rooted i W)).
have n0 : n = 0%N by case: (n) none => // m /(_ ord0).
have -> : (size ks %/ n.-1 = 0)%N by rewrite n0 divn0.
by rewrite expr0; exact: tau1_le1 (stochastic_span _ _ SP).
Qed.

Variables (d : nat) (v : nat -> 'M[R]_(n, d)) (N : 'rV[R]_d -> R).
Hypothesis Hv : forall t, (0 < t)%N -> v t.+1 = P t *m v t.
Hypothesis N0 : N 0 = 0.
Hypothesis NZ : forall a x, N (a *: x) = `|a| * N x.
Hypothesis ND : forall x y, N (x + y) <= N x + N y.

Theorem recurrent_velocities ks t u i j : connected_windows 1 ks -> (sumn ks < t)%N -> (sumn ks < u)%N ->
  N (row i (v t) - row j (v u)) <= (1 - alpha ^+ n.-1) ^+ (size ks %/ n.-1) * diameter N (v 1%N).
Proof.
move=> W tk uk; apply: le_trans (after_close SP Hv N0 NZ ND i j tk uk) _.
by apply: ler_wpmul2r; [exact: max_ge0 | exact: recurrent_tau1].
Qed.

(* connected again and again, no bound on the windows: no rate in time, but any number of factors *)
Theorem recurrent_eventually q : (forall s, exists k, forall i j, connect (union s k) i j) ->
  exists T, forall t u i j, (T < t)%N -> (T < u)%N ->
    N (row i (v t) - row j (v u)) <= (1 - alpha ^+ n.-1) ^+ q * diameter N (v 1%N).
Proof.
move=> rec; case: (pickP 'I_n) => [i0 _|none]; last by exists 0%N => t u i; have := none i.
have rec' s : exists k, rooted (window P s k).
  by have [k C] := rec s; exists k, i0 => i; exact: union_window.
have [T HT] := tau1_recurrent SP diag sym alpha0 alpha_le rec' 1 q.
exists T => t u i j Tt Tu; apply: le_trans (after_close SP Hv N0 NZ ND i j Tt Tu) _.
by apply: ler_wpmul2r; [exact: max_ge0 | exact: HT].
Qed.
End Flock.

(* ---- the common limit ---- *)
Definition cauchy (R : realFieldType) (a : nat -> R) :=
  forall eps, 0 < eps -> exists T, forall t u, (T < t)%N -> (T < u)%N -> `|a t - a u| <= eps.
Definition complete (R : realFieldType) := forall a : nat -> R, cauchy a ->
  exists l, forall eps, 0 < eps -> exists T, forall t, (T < t)%N -> `|a t - l| <= eps.

Section Limit.
Variables (R : archiFieldType) (n d : nat) (v : nat -> 'M[R]_(n, d)).

Lemma finite_choice m (Q : 'I_m -> R -> Prop) : (forall i, exists x, Q i x) -> exists f : 'rV[R]_m, forall i, Q i (f 0 i).
Proof.
move=> H; have [s Hs] : exists s : seq R, forall i : 'I_m, Q i (nth 0 s i).
  have key l : (l <= m)%N -> exists s : seq R, size s = l /\ forall i : 'I_m, (i < l)%N -> Q i (nth 0 s i).
    elim: l => [|l IH] lm; first by exists [::].
    have [s [sz Hs]] := IH (ltnW lm); have [x Qx] := H (Ordinal lm).
    exists (rcons s x); split; first by rewrite size_rcons sz.
    move=> i; rewrite ltnS leq_eqVlt nth_rcons sz => /orP[/eqP E|il].
      by rewrite E ltnn eqxx; have -> : i = Ordinal lm by apply/ord_inj.
    by rewrite il; exact: Hs.
  by have [s [_ Hs]] := key m (leqnn m); exists s => i; exact: Hs.
by exists (\row_i nth 0 s i) => i; rewrite mxE; exact: Hs.
Qed.

(* if all birds at all late times are close in every coordinate, they have one common limit; a number x
   that bounds all differences after time k bounds the distances to the limit too *)
Theorem common_limit : complete R -> (0 < n)%N ->
  (forall eps, 0 < eps -> exists T, forall t u i j l, (T < t)%N -> (T < u)%N -> `|v t i l - v u j l| <= eps) ->
  exists y : 'rV[R]_d, converges (fun t => v t.+1) (\matrix_(i, l) y 0 l) /\
    forall k l x, (forall t u i j, (k < t)%N -> (k < u)%N -> `|v t i l - v u j l| <= x) ->
      forall t i, (k < t)%N -> `|v t i l - y 0 l| <= x.
Proof.
move=> cR n0 H; pose i0 := Ordinal n0.
have [y Hy] : exists y : 'rV[R]_d, forall l eps, 0 < eps -> exists T, forall t, (T < t)%N -> `|v t i0 l - y 0 l| <= eps.
  apply: (finite_choice (Q := fun l x => forall eps, 0 < eps -> exists T, forall t, (T < t)%N -> `|v t i0 l - x| <= eps)).
  move=> l; apply: (cR (fun t => v t i0 l)) => eps /H[T HT]; exists T => t u Tt Tu; exact: HT.
have near k l x : (forall t u i j, (k < t)%N -> (k < u)%N -> `|v t i l - v u j l| <= x) ->
    forall t i, (k < t)%N -> `|v t i l - y 0 l| <= x.
  move=> B t i kt; rewrite leNgt; apply/negP => gt.
  pose eps := (`|v t i l - y 0 l| - x) / 2%:R.
  have e0 : 0 < eps by rewrite divr_gt0 ?ltr0n // subr_gt0.
  have [T HT] := Hy l eps e0; pose u := (maxn k T).+1.
  have ku : (k < u)%N by rewrite ltnS leq_maxl.
  have Tu : (T < u)%N by rewrite ltnS leq_maxr.
  have : `|v t i l - y 0 l| <= x + eps.
    rewrite -(subrK (v u i0 l) (v t i l)) -addrA; apply: le_trans (ler_norm_add _ _) _.
    by apply: ler_add; [exact: B | exact: HT].
  rewrite -ler_subl_addl leNgt => /negP; apply.
  by rewrite /eps ltr_pdivr_mulr ?ltr0n // mulr_natr mulr2n ltr_addl subr_gt0.
exists y; split=> // eps e0; have e2 : 0 < eps / 2%:R by rewrite divr_gt0 ?ltr0n.
have [T HT] := H _ e2; exists T => t Tt i l; rewrite [X in _ - X]mxE.
apply: (@le_lt_trans _ _ (eps / 2%:R)); last by rewrite ltr_pdivr_mulr ?ltr0n // mulr_natr mulr2n ltr_addl.
by apply: (near T) => //; move=> s u a b; exact: HT.
Qed.


(* one coordinate as a seminorm *)
Definition coordinate (l : 'I_d) (x : 'rV[R]_d) : R := `|x 0 l|.
Lemma coordinate0 l : coordinate l 0 = 0. Proof. by rewrite /coordinate mxE normr0. Qed.
Lemma coordinateZ l a x : coordinate l (a *: x) = `|a| * coordinate l x.
Proof. by rewrite /coordinate mxE normrM. Qed.
Lemma coordinateD l x y : coordinate l (x + y) <= coordinate l x + coordinate l y.
Proof. by rewrite /coordinate mxE ler_norm_add. Qed.
Lemma coordinate_rows l t u i j : coordinate l (row i (v t) - row j (v u)) = `|v t i l - v u j l|.
Proof. by rewrite /coordinate !mxE. Qed.
(* the largest difference of two birds in coordinate l *)
Definition extent (l : 'I_d) : R := diameter (coordinate l) (v 1%N).
Lemma extent_ge0 l : 0 <= extent l. Proof. exact: max_ge0. Qed.

Lemma extent_one l : (forall i j : 'I_n, i = j) -> extent l = 0.
Proof.
move=> one; apply/le_anti; rewrite extent_ge0 andbT; apply: max_le => // -[i j] /=.
by rewrite (one i j) subrr coordinate0.
Qed.

Lemma shrinking (x : R) (b : R) : 0 <= x < 1 -> 0 <= b ->
  forall eps, 0 < eps -> exists q, x ^+ q * b <= eps.
Proof.
move=> x01 b0 eps e0; have [T HT] := geometric_small x01 (divr_gt0 e0 (ltr_paddl b0 ltr01)).
exists T; apply: (@le_trans _ _ (x ^+ T * (b + 1))).
  by apply: ler_wpmul2l; [rewrite exprn_ge0 //; case/andP: x01 | rewrite ler_addl ler01].
rewrite -ler_pdivl_mulr; first exact: ltW (HT T (leqnn T)).
by rewrite ltr_paddl ?ltr01.
Qed.
End Limit.

(* every window of B times is rooted: after time k all coordinates of all birds are within
   (1 - gamma^((n-1)B))^floor(k/((n-1)B)) times the largest initial difference, which tends to 0 *)
Theorem repeatedly_cauchy (R : archiFieldType) n d (P : nat -> 'M[R]_n) (v : nat -> 'M[R]_(n, d)) gamma B :
  (forall t, stochastic (P t)) -> (forall t i, 0 < P t i i) -> 0 < gamma ->
  (forall t i j, P t i j != 0 -> gamma <= P t i j) ->
  (forall s, rooted (window P s B)) -> (forall t, (0 < t)%N -> v t.+1 = P t *m v t) ->
  (forall k t u i j l, (k < t)%N -> (k < u)%N ->
     `|v t i l - v u j l| <= (1 - gamma ^+ (n.-1 * B)) ^+ (k %/ (n.-1 * B)) * extent v l) /\
  (forall eps, 0 < eps -> exists T, forall t u i j l, (T < t)%N -> (T < u)%N -> `|v t i l - v u j l| <= eps).
Proof.
move=> SP diag g0 gle W Hv.
have close k t u i j l : (k < t)%N -> (k < u)%N ->
    `|v t i l - v u j l| <= (1 - gamma ^+ (n.-1 * B)) ^+ (k %/ (n.-1 * B)) * extent v l.
  move=> kt ku; rewrite -coordinate_rows.
  apply: (velocities_repeatedly (N := coordinate l) i j _ _ _ SP diag g0 gle W Hv kt ku).
  - exact: coordinate0.
  - exact: coordinateZ.
  exact: coordinateD.
split=> // eps e0; have g1 := gamma_le1 SP diag gle W.
pose m := (n.-1 * B)%N; pose x := 1 - gamma ^+ m; pose b := \sum_l extent v l.
have b0 : 0 <= b by apply: sumr_ge0 => l _; exact: extent_ge0.
have le_b l : extent v l <= b by rewrite /b (bigD1 l) //= ler_addl; apply: sumr_ge0 => l' _; exact: extent_ge0.
have [m0|mn] := posnP m.
  have one : forall i j : 'I_n, i = j.
    move: m0 => /eqP; rewrite /m muln_eq0 => /orP[/eqP n1 i j|/eqP B0 i j].
      have {}n1 : (n <= 1)%N by move: n1; case: (n) => [|[]].
      by apply/ord_inj; move: (leq_trans (ltn_ord i) n1) (leq_trans (ltn_ord j) n1); rewrite !ltnS !leqn0 => /eqP-> /eqP->.
    have [q Wq] := W 0%N; suff all k : k = q by rewrite (all i) (all j).
    have /connectP[[|k' p] /=] := Wq k; first by move=> _ ->.
    by case/andP=> /existsP[[u]]; rewrite B0.
  exists 0%N => t u i j l t0 u0; apply: le_trans (close _ _ _ _ _ _ t0 u0) _.
  by rewrite (extent_one v l one) mulr0 ltW.
have x01 : 0 <= x < 1 by rewrite /x subr_ge0 exprn_ile1 ?(ltW g0) //= ltr_subl_addr ltr_addl exprn_gt0.
have [q Hq] := shrinking x01 b0 e0.
exists (q * m)%N => t u i j l tq uq; apply: le_trans (close _ _ _ _ _ _ tq uq) _; rewrite -/m mulnK // -/x.
apply: le_trans Hq; apply: ler_wpmul2l => //; by rewrite exprn_ge0 //; case/andP: x01.
Qed.
(* ... so all velocities converge to one common limit, at this rate *)
Theorem velocities_repeatedly_limit (R : archiFieldType) n d (P : nat -> 'M[R]_n) (v : nat -> 'M[R]_(n, d)) gamma B :
  complete R -> (forall t, stochastic (P t)) -> (forall t i, 0 < P t i i) -> 0 < gamma ->
  (forall t i j, P t i j != 0 -> gamma <= P t i j) ->
  (forall s, rooted (window P s B)) -> (forall t, (0 < t)%N -> v t.+1 = P t *m v t) ->
  exists y : 'rV[R]_d, converges (fun t => v t.+1) (\matrix_(i, l) y 0 l) /\
    forall k t i l, (k < t)%N ->
      `|v t i l - y 0 l| <= (1 - gamma ^+ (n.-1 * B)) ^+ (k %/ (n.-1 * B)) * extent v l.
Proof.
move=> cR SP diag g0 gle W Hv; have [r _] := W 0%N.
have n0 : (0 < n)%N by exact: leq_ltn_trans (leq0n _) (ltn_ord r).
have [close cau] := repeatedly_cauchy SP diag g0 gle W Hv.
have [y [Cy Ny]] := common_limit cR n0 cau.
exists y; split=> // k t i l kt; apply: Ny kt => t' u i' j; exact: close.
Qed.

(* the flock of model D, connected again and again: all late velocities are close *)
Theorem recurrent_cauchy (R : archiFieldType) n d (G : nat -> rel 'I_n) (c : nat -> 'I_n -> R)
  (v : nat -> 'M[R]_(n, d)) alpha :
  (forall t, network (G t)) -> (forall t, model_D (G t) (c t)) -> 0 < alpha ->
  (forall t i j, transition (G t) (c t) i j != 0 -> alpha <= transition (G t) (c t) i j) ->
  (forall s, exists k, forall i j, connect (union G s k) i j) ->
  (forall t, (0 < t)%N -> v t.+1 = transition (G t) (c t) *m v t) ->
  forall eps, 0 < eps -> exists T, forall t u i j l, (T < t)%N -> (T < u)%N -> `|v t i l - v u j l| <= eps.
Proof.
move=> net MD a0 ale rec Hv eps e0; pose x := 1 - alpha ^+ n.-1; pose b := \sum_l extent v l.
case: (pickP 'I_n) => [i0 _|none]; last by exists 0%N => t u i; have := none i.
have b0 : 0 <= b by apply: sumr_ge0 => l _; exact: extent_ge0.
have le_b l : extent v l <= b by rewrite /b (bigD1 l) //= ler_addl; apply: sumr_ge0 => l' _; exact: extent_ge0.
have SP t := proj1 (model_D_stochastic (net t) (@MD t)).
have diag t := proj2 (model_D_stochastic (net t) (@MD t)).
have a1 : alpha <= 1 by exact: (alpha_le1 SP diag ale i0).
have x01 : 0 <= x < 1 by rewrite /x subr_ge0 exprn_ile1 ?(ltW a0) //= ltr_subl_addr ltr_addl exprn_gt0.
have [q Hq] := shrinking x01 b0 e0.
have rec' s : exists k, rooted (window (fun t => transition (G t) (c t)) s k).
  by have [k C] := rec s; exists k, i0 => i; exact: (union_window net MD).
have sym t i j : (transition (G t) (c t) i j != 0) = (transition (G t) (c t) j i != 0).
  by rewrite !transition_edge // eq_sym; have [-> _] := net t.
have [T HT] := tau1_recurrent SP diag sym a0 ale rec' 1 q.
exists T => t u i j l Tt Tu; rewrite -coordinate_rows.
have := after_close SP Hv (coordinate0 R l) (coordinateZ l) (coordinateD l) i j Tt Tu => /le_trans; apply.
apply: le_trans Hq; apply: ler_pmul; [exact: tau1_ge0 | exact: extent_ge0 | exact: HT | exact: le_b].
Qed.
(* ... so all velocities converge to one common limit *)
Theorem recurrent_limit (R : archiFieldType) n d (G : nat -> rel 'I_n) (c : nat -> 'I_n -> R)
  (v : nat -> 'M[R]_(n, d)) alpha :
  complete R -> (0 < n)%N -> (forall t, network (G t)) -> (forall t, model_D (G t) (c t)) -> 0 < alpha ->
  (forall t i j, transition (G t) (c t) i j != 0 -> alpha <= transition (G t) (c t) i j) ->
  (forall s, exists k, forall i j, connect (union G s k) i j) ->
  (forall t, (0 < t)%N -> v t.+1 = transition (G t) (c t) *m v t) ->
  exists y : 'rV[R]_d, converges (fun t => v t.+1) (\matrix_(i, l) y 0 l).
Proof.
move=> cR n0 net MD a0 ale rec Hv.
by have [y [Cy _]] := common_limit cR n0 (recurrent_cauchy net MD a0 ale rec Hv); exists y.
Qed.
