(* Chazelle, section 3 (The Rationality of Model D): Gamma_t, its limit, and the relative positions.
     chazelle.lem3.3, chazelle.eq3.12-13, chazelle.lem3.4.
   (Y | y) replaces the last column of Y.  Gamma_t (I - P | 1) = (I - P^t | 0), the matrix on the left
   is invertible, and P^t tends to 1 pi^T geometrically.  Birds are the rows of n x d matrices.
   Limits are over archimedean ordered fields (the rational and the real numbers are such); no axioms. *)
Set Warnings "-notation-overridden,-ambiguous-paths".
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import ring zify.
From Flockproof Require Import chazelle_model chazelle_ergodicity chazelle_fixed chazelle_network.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Import GRing.Theory Num.Theory Order.Theory.
Local Open Scope ring_scope.

(* convergence of a sequence of matrices, entry by entry *)
Definition converges (R : realFieldType) m n (A : nat -> 'M[R]_(m, n)) (B : 'M[R]_(m, n)) :=
  forall eps : R, 0 < eps -> exists T, forall t, (T <= t)%N -> forall i j, `|A t i j - B i j| < eps.

Lemma mulmxnl (R : ringType) m n p (A : 'M[R]_(m, n)) (B : 'M[R]_(n, p)) t : A *m B *+ t = (A *+ t) *m B.
Proof. by elim: t => [|t IH]; rewrite ?mulr0n ?mul0mx // !mulrSr mulmxDl IH. Qed.
Lemma mulmxnr (R : ringType) m n p (A : 'M[R]_(m, n)) (B : 'M[R]_(n, p)) t : A *m B *+ t = A *m (B *+ t).
Proof. by elim: t => [|t IH]; rewrite ?mulr0n ?mulmx0 // !mulrSr mulmxDr IH. Qed.

Section Powers.
Variable R : archiFieldType.
(* a geometric sequence tends to 0 *)
Lemma geometric_small (x : R) eps : 0 <= x < 1 -> 0 < eps -> exists T, forall t, (T <= t)%N -> x ^+ t < eps.
Proof.
case/andP=> x0 x1 e0; pose y := 1 - x; have y0 : 0 < y by rewrite subr_gt0.
have y1 : 0 <= y <= 1 by rewrite (ltW y0) /= ler_subl_addr ler_addl.
have b0 : 0 <= (eps * y)^-1 by rewrite invr_ge0 ltW ?mulr_gt0.
have := archi_boundP b0; set T := Num.bound _ => hT; exists T => t Tt.
have := bernoulli t y1; rewrite /y subKr -/y => h.
have d0 : 0 < 1 + y *+ t by rewrite ltr_paddr ?mulrn_wge0 ?ltr01 // ltW.
have : x ^+ t <= (1 + y *+ t)^-1 by rewrite -[X in _ <= X]mul1r ler_pdivl_mulr.
move/le_lt_trans; apply; rewrite -[eps]invrK ltf_pinv ?posrE ?invr_gt0 //.
apply: (@lt_le_trans _ _ (y *+ t)); last by rewrite ler_addr ler01.
rewrite -mulr_natr -ltr_pdivr_mull //; apply: lt_le_trans (_ : T%:R <= _); last by rewrite ler_nat.
by rewrite -invfM mulrC.
Qed.
End Powers.

Section Limits.
Variables (R : realFieldType) (m : nat).
Notation n := m.+1.
Variables (G : rel 'I_n) (c : 'I_n -> R).
Hypothesis net : network G.
Hypothesis MD : model_D G c.
Hypothesis conn : forall i j, connect G i j.
Hypothesis c0 : forall i, 0 < c i.
Notation P := (transition G c).
Notation pi := (stat c).
Let SP : stochastic P. Proof. by case: (model_D_stochastic net MD). Qed.

Definition ones : 'cV[R]_n := \col_i 1.
Definition pirow : 'rV[R]_n := \row_j pi j.
Definition rank1 : 'M[R]_n := ones *m pirow.
Lemma rank1E i j : rank1 i j = pi j.
Proof. by rewrite mxE big_ord1 !mxE mul1r. Qed.
Lemma P_ones : P *m ones = ones.
Proof. apply/colP=> i; rewrite mxE [RHS]mxE; case: SP => _ s1; rewrite -[RHS](s1 i); by apply: eq_bigr => j _; rewrite [X in _ * X]mxE mulr1. Qed.
Lemma pi_P : pirow *m P = pirow.
Proof. apply/rowP=> j; rewrite mxE [RHS]mxE -[RHS](stat_left net MD c0 j); by apply: eq_bigr => i _; rewrite [X in X * _]mxE. Qed.
Lemma pi_ones : pirow *m ones = 1%:M.
Proof.
apply/matrixP=> i j; rewrite !ord1 !mxE eqxx -[RHS](stat_sum c0 (0 : 'I_n)).
by apply: eq_bigr => k _; rewrite !mxE mulr1.
Qed.
Lemma rank1_P : rank1 *m P = rank1. Proof. by rewrite /rank1 -mulmxA pi_P. Qed.
Lemma P_rank1 : P *m rank1 = rank1. Proof. by rewrite /rank1 mulmxA P_ones. Qed.

Lemma good_rate : exists r, [/\ 0 < r, r <= 1 & r * (n.-1 ^ 2)%:R <= smallest G c * (trace c)^-1 *+ 2].
Proof.
have s0 := some_rate_gt0 net MD c0 (0 : 'I_n); have sl := some_rate_le net MD c0 (0 : 'I_n).
have [s1|s1] := leP (some_rate G c) 1; first by exists (some_rate G c).
exists 1; split=> //; apply: le_trans sl; apply: ler_wpmul2r; [by rewrite ler0n | exact: ltW].
Qed.

(* Gamma_t = - 1 pi^T t + sum_{s<t} P^s *)
Definition Gamma_t (t : nat) : 'M[R]_n := \sum_(s < t) mpow P s - rank1 *+ t.
Definition last_col (Y : 'M[R]_n) (y : 'cV[R]_n) : 'M[R]_n := \matrix_(i, j) (if j == ord_max then y i 0 else Y i j).
Definition Gamma : 'M[R]_n := last_col (1%:M - rank1) 0 *m invmx (last_col (1%:M - P) ones).

Lemma mul_last_col (A Y : 'M[R]_n) y : A *m last_col Y y = last_col (A *m Y) (A *m y).
Proof.
apply/matrixP=> i j; rewrite !mxE; case: (eqVneq j ord_max) => [E|nE].
  by apply: eq_bigr => k _; rewrite mxE E eqxx.
by apply: eq_bigr => k _; rewrite mxE (negbTE nE).
Qed.

Lemma Gamma_t_P t : Gamma_t t *m (1%:M - P) = 1%:M - mpow P t.
Proof.
rewrite /Gamma_t mulmxBr mulmx1 mulmxBl.
elim: t => [|t IH]; first by rewrite !big_ord0 mulr0n !mul0mx !subr0 subrr.
rewrite big_ord_recr /= mulrSr; set S := \sum_(s < t) _ in IH *; set K := rank1 *+ t in IH *.
rewrite [(S + _) *m P]mulmxDl [(K + _) *m P]mulmxDl rank1_P -[mpow P t *m P]mpowSr /=.
have -> : S + mpow P t - (K + rank1) - (S *m P + P *m mpow P t - (K *m P + rank1))
   = (S - K - (S *m P - K *m P)) + mpow P t - P *m mpow P t.
  by rewrite !opprD !opprK; apply/eqP; rewrite -subr_eq0; apply/eqP/matrixP=> i j; rewrite !mxE; ring.
by rewrite IH subrK.
Qed.
Lemma mpow_ones s : mpow P s *m ones = ones.
Proof. by elim: s => [|s IH] /=; rewrite ?mul1mx // -mulmxA IH P_ones. Qed.
Lemma pi_mpow s : pirow *m mpow P s = pirow.
Proof. by elim: s => [|s IH] /=; rewrite ?mulmx1 // mulmxA pi_P. Qed.
Lemma rank1_ones : rank1 *m ones = ones. Proof. by rewrite /rank1 -mulmxA pi_ones mulmx1. Qed.
Lemma Gamma_t_ones t : Gamma_t t *m ones = 0.
Proof.
rewrite /Gamma_t mulmxBl mulmx_suml (eq_bigr (fun=> ones)) => [|s _]; last exact: mpow_ones.
rewrite sumr_const card_ord; have -> : rank1 *+ t *m ones = ones *+ t by rewrite -mulmxnl rank1_ones.
by rewrite subrr.
Qed.

(* (I - P | 1) is invertible *)
Lemma bordered_unit : last_col (1%:M - P) ones \in unitmx.
Proof.
set B := last_col _ _; rewrite unitmxE unitfE; apply/negP => /eqP d0.
have [v vn0 vB] : exists2 v : 'cV[R]_n, v != 0 & B *m v = 0.
  have : \det B^T == 0 by rewrite det_tr d0.
  case/det0P => u un0 uB; exists u^T; first by rewrite -trmx0 (inj_eq trmx_inj).
  by apply: trmx_inj; rewrite trmx_mul trmxK uB trmx0.
move/negP: vn0; apply; apply/eqP.
pose l := v ord_max 0; pose v' : 'cV[R]_n := \col_i (if i == ord_max then 0 else v i 0).
have E : (1%:M - P) *m v' + l *: ones = 0.
  rewrite -vB; apply/colP=> i; rewrite !mxE mulr1 (bigD1 ord_max) //= [RHS](bigD1 ord_max) //= !mxE eqxx mulr0 add0r.
  rewrite mul1r addrC; congr (_ + _); apply: eq_bigr => j jm; by rewrite !mxE (negbTE jm).
have l0 : l = 0.
  have := congr1 (mulmx pirow) E; rewrite mulmxDr mulmxA mulmxBr mulmx1 pi_P subrr mul0mx add0r mulmx0.
  rewrite -scalemxAr pi_ones => /matrixP/(_ 0 0); by rewrite !mxE eqxx mulr1.
have fv i : step G c (fun k => v' k 0) i = v' i 0.
  move: E; rewrite l0 scale0r addr0 mulmxBl mul1mx => /eqP; rewrite subr_eq0 => /eqP/colP/(_ i) ->.
  by rewrite [RHS]mxE.
have const := fixed_constant net MD conn c0 fv.
apply/colP=> i; rewrite mxE; have [->|im] := eqVneq i ord_max; first exact: l0.
by have := const i ord_max; rewrite !mxE eqxx (negbTE im).
Qed.

Lemma Gamma_tE t : Gamma_t t = last_col (1%:M - mpow P t) 0 *m invmx (last_col (1%:M - P) ones).
Proof. by rewrite -(mulmxK bordered_unit (Gamma_t t)) mul_last_col Gamma_t_P Gamma_t_ones. Qed.

Lemma last_colB (Y Z : 'M[R]_n) : last_col Y 0 - last_col Z 0 = last_col (Y - Z) 0.
Proof. by apply/matrixP=> i j; rewrite !mxE; case: eqP => _; rewrite ?subrr // !mxE. Qed.

(* an explicit rate, in every ordered field *)
Definition weight : R := \sum_i \sum_j `|invmx (last_col (1%:M - P) ones) i j|.
Lemma Gamma_rate t eps : (forall i j, `|mpow P t i j - pi j| <= eps) -> 
  forall i j, `|Gamma_t t i j - Gamma i j| <= eps * weight.
Proof.
move=> H i j; have e0 : 0 <= eps by apply: le_trans (H 0 0); exact: normr_ge0.
set W := invmx (last_col (1%:M - P) ones).
have -> : Gamma_t t i j - Gamma i j = ((Gamma_t t - Gamma) i j) by rewrite !mxE.
rewrite Gamma_tE /Gamma -mulmxBl last_colB mxE.
apply: le_trans (ler_norm_sum _ _ _) _; rewrite /weight mulr_sumr; apply: ler_sum => k _.
rewrite normrM; apply: (@le_trans _ _ (eps * `|W k j|)).
  apply: ler_wpmul2r => //; rewrite mxE; case: eqP => _; first by rewrite mxE normr0.
  have -> : (1%:M - mpow P t - (1%:M - rank1)) i k = - (mpow P t i k - pi k).
    have -> : 1%:M - mpow P t - (1%:M - rank1) = rank1 - mpow P t by rewrite opprB addrC addrA subrK.
    by rewrite mxE [X in _ + X]mxE rank1E opprB.
  by rewrite normrN.
apply: ler_wpmul2l => //; rewrite (bigD1 j) //= ler_addl; apply: sumr_ge0 => l _; exact: normr_ge0.
Qed.

(* ---- positions ---- *)
Section Motion.
Variables (d : nat) (x v : nat -> 'M[R]_(n, d)).
Hypothesis Hx : forall t, x t.+1 = x t + v t.+1.
Hypothesis Hv : forall t, (0 < t)%N -> v t.+1 = P *m v t.

Lemma velocity_power s : v s.+1 = mpow P s *m v 1%N.
Proof. by elim: s => [|s IH]; [rewrite mul1mx | rewrite Hv // IH mulmxA]. Qed.

(* chazelle.eq3.12-13 *)
Theorem eq_3_12 t : x t = x 0%N + (\sum_(s < t) mpow P s) *m v 1%N.
Proof.
elim: t => [|t IH]; first by rewrite big_ord0 mul0mx addr0.
by rewrite Hx IH big_ord_recr /= mulmxDl -addrA (velocity_power t).
Qed.
Theorem eq_3_13 t : x t = x 0%N + (rank1 *m v 1%N) *+ t + Gamma_t t *m v 1%N.
Proof.
rewrite eq_3_12 -addrA /Gamma_t mulmxBl; congr (_ + _).
by rewrite -mulmxnl addrC subrK.
Qed.

(* chazelle.lem3.4: x^r = x - 1 m_pi[x], m_pi[x] = pi^T x *)
Definition relative (y : 'M[R]_(n, d)) : 'M[R]_(n, d) := y - ones *m (pirow *m y).
Lemma pi_Gamma_t t : pirow *m Gamma_t t = 0.
Proof.
rewrite /Gamma_t mulmxBr mulmx_sumr (eq_bigr (fun=> pirow)) => [|s _]; last exact: pi_mpow.
rewrite sumr_const card_ord; have -> : pirow *m (rank1 *+ t) = pirow *+ t.
  by rewrite -mulmxnr /rank1 mulmxA pi_ones mul1mx.
by rewrite subrr.
Qed.
Lemma relative_position t : relative (x t) = (1%:M - rank1) *m x 0%N + Gamma_t t *m v 1%N.
Proof.
rewrite /relative eq_3_13 !mulmxDr [pirow *m (Gamma_t t *m _)]mulmxA pi_Gamma_t mul0mx mulmx0 addr0.
have -> : ones *m (pirow *m (rank1 *m v 1%N *+ t)) = rank1 *m v 1%N *+ t.
  by rewrite -!mulmxnr !mulmxA -[ones *m pirow *m ones]mulmxA pi_ones mulmx1.
rewrite [(1%:M - rank1) *m _]mulmxBl mul1mx /rank1 [ones *m (pirow *m x 0%N)]mulmxA.
by rewrite opprD addrAC addrACA subrr addr0.
Qed.
Theorem mass_centre t : pirow *m x t.+1 - pirow *m x t = pirow *m v 1%N.
Proof. by rewrite Hx mulmxDr addrAC subrr add0r (velocity_power t) mulmxA pi_mpow. Qed.
End Motion.
End Limits.

Section Convergence.
Variables (R : archiFieldType) (m : nat).
Notation n := m.+1.
Variables (G : rel 'I_n) (c : 'I_n -> R).
Hypothesis net : network G.
Hypothesis MD : model_D G c.
Hypothesis conn : forall i j, connect G i j.
Hypothesis c0 : forall i, 0 < c i.
Notation P := (transition G c).


Theorem powers_converge : converges (mpow P) (rank1 c).
Proof.
move=> eps e0; have [r [r0 r1 rl]] := good_rate net MD c0.
pose K := \sum_i \sum_j c i / c j.
have K0 : 0 <= K by apply: sumr_ge0 => i _; apply: sumr_ge0 => j _; rewrite divr_ge0 ?ltW.
have y01 : 0 <= 1 - r < 1 by rewrite subr_ge0 r1 ltr_subl_addr ltr_addl r0.
have K1 : 0 < K + 1 by exact: ltr_paddl K0 ltr01.
have e1 : 0 < eps ^+ 2 / (K + 1) by rewrite divr_gt0 ?exprn_gt0.
have [T HT] := geometric_small y01 e1; exists T => t /HT ht i j.
have := mixing net MD conn c0 (smallest_le G c) (ltW (smallest_gt0 net MD)) rl r1 t i j.
rewrite rank1E => h; rewrite -(@ltr_pexpn2r _ 2) // ?nnegrE ?(ltW e0) // real_normK ?num_real //.
apply: le_lt_trans h _; apply: (@le_lt_trans _ _ (K * (1 - r) ^+ t)).
  apply: ler_wpmul2r; first by rewrite exprn_ge0 ?subr_ge0.
  rewrite /K (bigD1 i) //= (bigD1 j) //= -addrA ler_addl addr_ge0 //.
    by apply: sumr_ge0 => k _; rewrite divr_ge0 ?ltW.
  by apply: sumr_ge0 => k _; apply: sumr_ge0 => l _; rewrite divr_ge0 ?ltW.
apply: (@le_lt_trans _ _ ((K + 1) * (1 - r) ^+ t)).
  by apply: ler_wpmul2r; rewrite ?exprn_ge0 ?subr_ge0 // ler_addl ler01.
by rewrite mulrC -ltr_pdivl_mulr.
Qed.

(* chazelle.lem3.3 *)
Theorem lemma_3_3 : converges (Gamma_t G c) (Gamma G c).
Proof.
move=> eps e0; pose W := weight G c.
have W0 : 0 <= W by apply: sumr_ge0 => i _; apply: sumr_ge0 => j _; exact: normr_ge0.
have W1 : 0 < W + 1 by exact: ltr_paddl W0 ltr01.
have e1 : 0 < eps / (W + 1) by rewrite divr_gt0.
have [T HT] := powers_converge e1; exists T => t /HT ht i j.
have h k l : `|mpow P t k l - stat c l| <= eps / (W + 1) by have := ht k l; rewrite rank1E; exact: ltW.
apply: le_lt_trans (Gamma_rate net MD conn c0 h i j) _; rewrite -/W -mulrA gtr_pmulr //.
by rewrite mulrC ltr_pdivr_mulr // mul1r ltr_addl ltr01.
Qed.

Lemma converges_mul p q (A : nat -> 'M[R]_(p, n)) B (y : 'M[R]_(n, q)) (z : 'M[R]_(p, q)) :
  converges A B -> converges (fun t => z + A t *m y) (z + B *m y).
Proof.
move=> H eps e0; pose K := \sum_i \sum_j `|y i j|.
have K0 : 0 <= K by apply: sumr_ge0 => i _; apply: sumr_ge0 => j _; exact: normr_ge0.
have K1 : 0 < K + 1 by exact: ltr_paddl K0 ltr01.
have e1 : 0 < eps / (K + 1) by rewrite divr_gt0.
have [T HT] := H _ e1; exists T => t /HT ht i j.
have -> : (z + A t *m y) i j - (z + B *m y) i j = \sum_k (A t i k - B i k) * y k j.
  rewrite !mxE opprD addrACA subrr add0r -sumrB; apply: eq_bigr => k _; by rewrite mulrBl.
apply: le_lt_trans (ler_norm_sum _ _ _) _.
apply: (@le_lt_trans _ _ (eps / (K + 1) * K)).
  rewrite /K mulr_sumr; apply: ler_sum => k _; rewrite normrM.
  apply: ler_pmul => //; first exact: ltW (ht i k).
  by rewrite (bigD1 j) //= ler_addl; apply: sumr_ge0 => l _; exact: normr_ge0.
by rewrite -mulrA gtr_pmulr // mulrC ltr_pdivr_mulr // mul1r ltr_addl ltr01.
Qed.

(* chazelle.lem3.4 *)
Theorem lemma_3_4 d (x v : nat -> 'M[R]_(n, d)) :
  (forall t, x t.+1 = x t + v t.+1) -> (forall t, (0 < t)%N -> v t.+1 = P *m v t) ->
  converges (fun t => relative c (x t)) ((1%:M - rank1 c) *m x 0%N + Gamma G c *m v 1%N) /\
  (forall t, pirow c *m x t.+1 - pirow c *m x t = pirow c *m v 1%N).
Proof.
move=> Hx Hv; split; last exact: (mass_centre net MD c0 Hx Hv).
have H := converges_mul (v 1%N) ((1%:M - rank1 c) *m x 0%N) lemma_3_3.
move=> eps /H[T HT]; exists T => t Tt; rewrite (relative_position net MD c0 Hx Hv); exact: HT.
Qed.

(* velocities of a fixed connected flock converge to the stationary velocity 1 pi^T v(1) *)
Theorem velocities_converge d (v : nat -> 'M[R]_(n, d)) :
  (forall t, (0 < t)%N -> v t.+1 = P *m v t) ->
  converges (fun t => v t.+1) (rank1 c *m v 1%N).
Proof.
move=> Hv; have H := converges_mul (v 1%N) (0 : 'M[R]_(n, d)) powers_converge.
move=> eps /H[T HT]; exists T => t Tt i j; have := HT t Tt i j; rewrite !add0r.
suff -> : v t.+1 = mpow P t *m v 1%N by [].
by elim: (t) => [|s IH]; [rewrite mul1mx | rewrite Hv // IH mulmxA].
Qed.
End Convergence.


(* chazelle.eq3.12-13, both *)
Theorem eq_3_12_13 (R : realFieldType) m (G : rel 'I_m.+1) (c : 'I_m.+1 -> R) d (x v : nat -> 'M[R]_(m.+1, d)) t :
  (forall t, x t.+1 = x t + v t.+1) -> (forall t, (0 < t)%N -> v t.+1 = transition G c *m v t) ->
  x t = x 0%N + (\sum_(s < t) mpow (transition G c) s) *m v 1%N /\
  x t = x 0%N + (rank1 c *m v 1%N) *+ t + Gamma_t G c t *m v 1%N.
Proof. by move=> Hx Hv; split; [exact: eq_3_12 | exact: eq_3_13]. Qed.
