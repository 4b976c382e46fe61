(* Chazelle, section 3 (Time-Invariant Flocking) and Remark 2: the claims on one connected network that
   stays, from chazelle_fixed.v.
     chazelle.pi, chazelle.lem3.2, chazelle.eq3.9, chazelle.eq3.10, chazelle.fiedler.rate.
   "n^O(1)" needs bounded input: c_i and 1 - c_i d_i are at least n^-a (rationals of O(log n) bits). *)
Set Warnings "-notation-overridden,-ambiguous-paths".
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import ring zify.
From Flockproof Require Import chazelle_model chazelle_ergodicity chazelle_fixed.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Import GRing.Theory Num.Theory Order.Theory.
Local Open Scope ring_scope.

(* (1 - 1/m)^s <= 2^-floor(s/m) *)
Section Halving.
Variable R : realFieldType.
Lemma bernoulli (x : R) m : 0 <= x <= 1 -> (1 - x) ^+ m * (1 + x *+ m) <= 1.
Proof.
case/andP=> x0 x1; elim: m => [|m IH]; first by rewrite expr0 mulr0n addr0 mul1r.
apply: le_trans IH; rewrite exprSr -mulrA; apply: ler_wpmul2l; first by rewrite exprn_ge0 ?subr_ge0.
have -> : (1 - x) * (1 + x *+ m.+1) = 1 + x *+ m - x ^+ 2 *+ m.+1.
  by rewrite mulrBl mul1r mulrDr mulr1 mulrnAr -expr2 mulrS; ring.
by rewrite ler_subl_addr ler_addl mulrn_wge0 ?sqr_ge0.
Qed.
Lemma halving m s : (0 < m)%N -> (1 - m%:R^-1 : R) ^+ s <= (2%:R^-1) ^+ (s %/ m).
Proof.
move=> m0; have mR : (0 : R) < m%:R by rewrite ltr0n.
have x01 : 0 <= (m%:R^-1 : R) <= 1 by rewrite invr_ge0 ler0n invf_le1 // ler1n.
have y0 : 0 <= 1 - m%:R^-1 :> R by rewrite subr_ge0; case/andP: x01.
have h : (1 - m%:R^-1 : R) ^+ m <= 2%:R^-1.
  have := bernoulli m x01; rewrite -[m%:R^-1 *+ m]mulr_natr mulVf ?gt_eqF //.
  by rewrite -[1 + 1]/(2%:R) -ler_pdivl_mulr ?ltr0n // mul1r.
rewrite {1}(divn_eq s m) exprD mulnC exprM -[X in _ <= X]mulr1.
apply: ler_pmul; rewrite ?exprn_ge0 //; first by apply: ler_expn2r; rewrite ?nnegrE ?exprn_ge0 ?invr_ge0 ?ler0n.
by apply: exprn_ile1 => //; rewrite ler_subl_addr ler_addl invr_ge0 ler0n.
Qed.
End Halving.

Section Network.
Variables (R : realFieldType) (n : nat) (G : rel 'I_n) (c : 'I_n -> R).
Hypothesis net : network G.
Hypothesis MD : model_D G c.
Hypothesis conn : forall i j, connect G i j.
Hypothesis c0 : forall i, 0 < c i.
Notation P := (transition G c).
Notation pi := (stat c).
Notation step := (step G c).
Implicit Types f g : 'I_n -> R.

Let SP : stochastic P. Proof. by case: (model_D_stochastic net MD). Qed.
Let diag i : 0 < P i i. Proof. by case: (model_D_stochastic net MD). Qed.

Definition smallest : R := \big[Num.min/1]_i P i i.
Lemma smallest_gt0 : 0 < smallest.
Proof.
apply: (big_ind (fun x => 0 < x)) => // x y x0 y0; by rewrite lt_minr x0.
Qed.
Lemma smallest_le i : smallest <= P i i. Proof. exact: (min_lb (fun i => P i i) i). Qed.
Definition some_rate : R := (smallest * (trace c)^-1 *+ 2) / ((n.-1 ^ 2).+1)%:R.
Lemma some_rate_gt0 (i : 'I_n) : 0 < some_rate.
Proof.
by rewrite /some_rate divr_gt0 ?ltr0n // pmulrn_rgt0 // mulr_gt0 ?smallest_gt0 // invr_gt0 (trace_gt0 c0 i).
Qed.
Lemma some_rate_le (i : 'I_n) : some_rate * (n.-1 ^ 2)%:R <= smallest * (trace c)^-1 *+ 2.
Proof.
rewrite /some_rate -mulrA -[X in _ <= X]mulr1; apply: ler_wpmul2l.
  by rewrite mulrn_wge0 // mulr_ge0 ?(ltW smallest_gt0) // invr_ge0 ltW ?(trace_gt0 c0 i).
by rewrite mulrC ler_pdivr_mulr ?ltr0n // mul1r ler_nat.
Qed.
Lemma contracts f (i : 'I_n) : mean c f = 0 -> sqn c (step f) <= (1 - some_rate) * sqn c f.
Proof.
apply: (contraction net MD conn c0 smallest_le (ltW smallest_gt0)); exact: some_rate_le.
Qed.
Lemma sqn_eq0 f : sqn c f = 0 -> forall i, f i = 0.
Proof.
move=> Z i; have := pointwise c0 f i; rewrite Z => h.
have : stat c i * f i ^+ 2 = 0 by apply/le_anti; rewrite h mulr_ge0 ?sqr_ge0 // ltW ?(stat_gt0 c0).
by move/eqP; rewrite mulf_eq0 gt_eqF ?(stat_gt0 c0) //= sqrf_eq0 => /eqP.
Qed.
Lemma sqnZ a f : sqn c (fun i => a * f i) = a ^+ 2 * sqn c f.
Proof. by rewrite /sqn mulr_sumr; apply: eq_bigr => i _; ring. Qed.
Lemma meanZ a f : mean c (fun i => a * f i) = a * mean c f.
Proof. by rewrite /mean mulr_sumr; apply: eq_bigr => i _; ring. Qed.

(* an eigenvalue other than 1 *)
Lemma eigenvalue_bound lam f rate alpha : (forall i, alpha <= P i i) -> 0 <= alpha ->
  rate * (n.-1 ^ 2)%:R <= alpha * (trace c)^-1 *+ 2 ->
  (forall i, step f i = lam * f i) -> (exists i, f i != 0) -> lam != 1 -> lam ^+ 2 <= 1 - rate.
Proof.
move=> al al0 rl E [i fi] l1.
have m0 : mean c f = 0.
  have := mean_step net MD c0 f; rewrite (eq_mean c E) meanZ => /eqP.
  by rewrite -subr_eq0 -{2}[mean c f]mul1r -mulrBl mulf_eq0 subr_eq0 (negbTE l1) /= => /eqP.
have q0 : 0 < sqn c f.
  rewrite lt_def sqn_ge0 // andbT; apply/eqP => Z; move: fi; by rewrite (sqn_eq0 Z) eqxx.
have := contraction net MD conn c0 al al0 rl m0.
by rewrite (eq_sqn c E) sqnZ ler_pmul2r.
Qed.

Lemma fixed_constant f : (forall i, step f i = f i) -> forall i j, f i = f j.
Proof.
move=> E i j; pose m := mean c f; pose g k := f k - m.
have stepg k : step g k = g k.
  rewrite /g -[in RHS](E k) /step; have [_ s1] := SP.
  rewrite (eq_bigr (fun l => P k l * f l - P k l * m)) => [|l _]; last by rewrite mulrBr.
  by rewrite sumrB -mulr_suml s1 mul1r.
have mg : mean c g = 0.
  rewrite /mean /g (eq_bigr (fun l => pi l * f l - pi l * m)) => [|l _]; last by rewrite mulrBr.
  by rewrite sumrB -mulr_suml (stat_sum c0 i) mul1r subrr.
have := contracts i mg; rewrite (eq_sqn c stepg) mulrBl mul1r -subr_ge0 addrAC subrr sub0r oppr_ge0.
rewrite pmulr_rle0 ?(some_rate_gt0 i) // => q0.
have Z : sqn c g = 0 by apply/le_anti; rewrite q0 sqn_ge0.
have gz k : f k = m by apply/eqP; rewrite -subr_eq0 -/(g k) (sqn_eq0 Z).
by rewrite !gz.
Qed.

(* chazelle.pi: right eigenvector 1, left eigenvector pi, the eigenvalue 1 is simple (geometrically on
   both sides, and algebraically) and dominant; complex eigenvalues do not exist *)
Theorem stationary (i0 : 'I_n) :
  [/\ (forall i, \sum_j P i j = 1) /\ (forall j, \sum_i pi i * P i j = pi j),
      (forall i, 0 < pi i) /\ \sum_i pi i = 1,
      (forall f, (forall i, step f i = f i) -> forall i j, f i = f j) /\
      (forall y, (forall j, \sum_i y i * P i j = y j) -> exists k, forall i, y i = k * pi i),
      (forall f, let g i := f i - step f i in (forall i, g i - step g i = 0) -> forall i j, f i = f j) &
      (forall lam f, (forall i, step f i = lam * f i) -> (exists i, f i != 0) -> lam = 1 \/ `|lam| < 1) /\
      (forall x y f g, (forall i, step f i = x * f i - y * g i) -> (forall i, step g i = x * g i + y * f i) ->
         (exists i, (f i != 0) || (g i != 0)) -> y = 0)].
Proof.
have [A0 A1] := SP; split.
- by split=> // j; exact: stat_left net MD c0 j.
- by split; [exact: stat_gt0 c0 | exact: stat_sum c0 i0].
- split; first exact: fixed_constant.
  move=> y Hy; pose f i := y i / pi i; exists (f i0) => i.
  have pz k : pi k != 0 by rewrite gt_eqF ?(stat_gt0 c0).
  have E k : step f k = f k.
    rewrite /step /f -(mulKf (pz k) (\sum_j _)) mulr_sumr [RHS]mulrC -[X in _ = _ * X]Hy; congr (_ * _).
    apply: eq_bigr => j _; rewrite [LHS]mulrA (balance net c0 k j) mulrC -mulrA; congr (_ * _).
    by rewrite mulrA mulVf ?mul1r.
  by rewrite -(fixed_constant E i i0) /f divfK.
- move=> f g Hg; have gc i j : g i = g j.
    by apply: fixed_constant => k; apply/eqP; rewrite eq_sym -subr_eq0 Hg.
  have mg : mean c g = 0.
    rewrite /mean /g (eq_bigr (fun l => pi l * f l - pi l * step f l)) => [|l _]; last by rewrite mulrBr.
    by rewrite sumrB -/(mean c f) -/(mean c (step f)) mean_step // subrr.
  have gz i : g i = 0.
    move: mg; rewrite /mean (eq_bigr (fun l => pi l * g i)) => [|l _]; last by rewrite (gc l i).
    by rewrite -mulr_suml (stat_sum c0 i) mul1r.
  by apply: fixed_constant => i; apply/eqP; rewrite eq_sym -subr_eq0 -/(g i) gz.
split.
  move=> lam f E nz; have [->|l1] := eqVneq lam 1; [by left|right].
  have := eigenvalue_bound smallest_le (ltW smallest_gt0) (some_rate_le i0) E nz l1.
  move=> h; rewrite -(@ltr_pexpn2r _ 2) // ?nnegrE ?ler01 // expr1n real_normK ?num_real //.
  by apply: le_lt_trans h _; rewrite ltr_subl_addr ltr_addl (some_rate_gt0 i0).
move=> x y f g Ef Eg [i nz]; apply/eqP; rewrite -[y == 0]orbF.
have sym (u v : 'I_n -> R) : \sum_i pi i * (u i * step v i) = \sum_i pi i * (v i * step u i).
  have D (a b : 'I_n -> R) : \sum_i pi i * (a i * step b i) = \sum_i \sum_j pi i * P i j * (a i * b j).
    by apply: eq_bigr => k _; rewrite /step !mulr_sumr; apply: eq_bigr => l _; ring.
  rewrite !D exchange_big /=; apply: eq_bigr => k _; apply: eq_bigr => l _.
  by rewrite (balance net c0 l k); ring.
have key : y * (sqn c f + sqn c g) = 0.
  have /eqP := sym f g; rewrite -subr_eq0 -sumrB => /eqP <-.
  rewrite /sqn -big_split /= mulr_sumr; apply: eq_bigr => k _.
  by rewrite Ef Eg; ring.
move/eqP: key; rewrite mulf_eq0 => /orP[->//|]; rewrite paddr_eq0 ?sqn_ge0 //.
by case/andP=> /eqP/sqn_eq0 fz /eqP/sqn_eq0 gz; rewrite fz gz eqxx in nz.
Qed.

(* ---- bounded input ---- *)
Variable a : nat.
Hypothesis n2 : (1 < n)%N.
Hypothesis small_c : forall i, (n%:R ^+ a)^-1 <= c i.
Hypothesis small_d : forall i, (n%:R ^+ a)^-1 <= P i i.

Let N0 : 0 < n%:R :> R. Proof. by rewrite ltr0n (ltnW n2). Qed.
Let N1 : 1 <= n%:R :> R. Proof. by rewrite ler1n (ltnW n2). Qed.
Let Nk k : 0 < n%:R ^+ k :> R. Proof. exact: exprn_gt0. Qed.
Let i0 : 'I_n := Ordinal (ltnW n2).

Lemma inverse_weight i : (c i)^-1 <= n%:R ^+ a.
Proof. by rewrite -[n%:R ^+ a]invrK lef_pinv ?posrE ?invr_gt0. Qed.
Lemma trace_le : trace c <= n%:R ^+ a.+1.
Proof.
rewrite /trace exprS; apply: (@le_trans _ _ (\sum_(i < n) n%:R ^+ a)).
  by apply: ler_sum => i _; exact: inverse_weight.
by rewrite sumr_const card_ord mulr_natl.
Qed.
Lemma has_neighbour i : exists j, G i j.
Proof.
have [j ij] : exists j, i != j.
  pose j1 : 'I_n := Ordinal n2; have [->|?] := eqVneq i i0; last by exists i0.
  by exists j1.
have /connectP[[|k p] /=] := conn i j; first by move=> _ E; rewrite E eqxx in ij.
by case/andP=> Gik _ _; exists k.
Qed.
Lemma weight_le1 i : c i <= 1.
Proof.
have [j Gij] := has_neighbour i; have d0 := edge_degree Gij; have /andP[_ h] := MD d0.
apply: ltW; apply: le_lt_trans h; rewrite -{1}[c i]mulr1; apply: ler_wpmul2l; first exact: ltW.
by rewrite ler1n.
Qed.

Definition poly_rate : R := (n%:R ^+ (2 * a + 3))^-1.
Definition slow : R := (n%:R ^+ (2 * a + 4))^-1.
Lemma poly_rate_le : poly_rate * (n.-1 ^ 2)%:R <= (n%:R ^+ a)^-1 * (trace c)^-1 *+ 2.
Proof.
have w1 : (n%:R ^+ a.+1)^-1 <= (trace c)^-1 by rewrite lef_pinv ?posrE // ?(trace_gt0 c0 i0) // trace_le.
apply: (@le_trans _ _ ((n%:R ^+ a)^-1 * (n%:R ^+ a.+1)^-1)); last first.
  rewrite mulr2n -[X in X <= _]addr0; apply: ler_add.
    by apply: ler_wpmul2l => //; rewrite invr_ge0 ltW.
  by rewrite mulr_ge0 // invr_ge0 ltW // (trace_gt0 c0 i0).
rewrite /poly_rate mulrC ler_pdivr_mulr // -invfM -exprD.
rewrite ler_pdivl_mull // -!natrX -natrM ler_nat.
have -> : (2 * a + 3 = (a + a.+1) + 2)%N by lia.
by rewrite [X in (_ <= X)%N]expnD leq_mul2l leq_exp2r // leq_pred orbT.
Qed.
Lemma slow_gt0 : 0 < slow. Proof. by rewrite invr_gt0. Qed.
Lemma slow_le1 : slow <= 1.
Proof. by rewrite invf_le1 // exprn_ege1. Qed.
Lemma slow_rate : slow *+ 2 <= poly_rate.
Proof.
rewrite /slow /poly_rate.
have -> : (2 * a + 4 = (2 * a + 3).+1)%N by rewrite -addnS.
rewrite -[X in X <= _]mulr_natr ler_pdivr_mull ?Nk // exprS -mulrA mulfV ?gt_eqF ?Nk // mulr1.
by rewrite ler_nat.
Qed.
Lemma poly_rate_le1 : poly_rate <= 1.
Proof. by rewrite invf_le1 // exprn_ege1. Qed.
Lemma one_minus_slow : 1 - poly_rate <= (1 - slow) ^+ 2.
Proof.
have -> : (1 - slow) ^+ 2 = 1 - slow *+ 2 + slow ^+ 2 by ring.
rewrite -[X in X <= _]addr0 ler_add ?sqr_ge0 // ler_add2l ler_opp2; exact: slow_rate.
Qed.

(* chazelle.lem3.2: mu = max over the other eigenvalues; they are all real by `stationary` *)
Theorem lemma_3_2 lam f : (forall i, step f i = lam * f i) -> (exists i, f i != 0) -> lam != 1 ->
  `|lam| <= 1 - (n%:R ^+ (2 * a + 4))^-1.
Proof.
move=> E nz l1; have al0 : 0 <= (n%:R ^+ a)^-1 :> R by rewrite invr_ge0 ltW.
have := eigenvalue_bound small_d al0 poly_rate_le E nz l1 => h.
rewrite -/slow -(@ler_pexpn2r _ 2) // ?nnegrE ?subr_ge0 ?slow_le1 // real_normK ?num_real //.
exact: le_trans h one_minus_slow.
Qed.

(* chazelle.eq3.9, with (1 - n^-k)^s <= e^(-s n^-k) *)
Theorem eq_3_9 s i j : `|mpow P s i j - pi j| <= n%:R ^+ a * (1 - (n%:R ^+ (2 * a + 4))^-1) ^+ s.
Proof.
have al0 : 0 <= (n%:R ^+ a)^-1 :> R by rewrite invr_ge0 ltW.
have s0 : 0 <= 1 - slow by rewrite subr_ge0 slow_le1.
have := mixing net MD conn c0 small_d al0 poly_rate_le poly_rate_le1 s i j => h.
rewrite -/slow -(@ler_pexpn2r _ 2) // ?nnegrE ?mulr_ge0 ?exprn_ge0 //; last exact: ltW.
rewrite real_normK ?num_real //; apply: le_trans h _; rewrite exprMn -[((1 - slow) ^+ s) ^+ 2]exprM mulnC exprM.
apply: ler_pmul; rewrite ?exprn_ge0 ?subr_ge0 ?poly_rate_le1 //.
- by rewrite divr_ge0 ?ltW.
- apply: (@le_trans _ _ (n%:R ^+ a)); last by rewrite expr2 ler_pemulr ?exprn_ege1 // ltW.
  rewrite -[X in _ <= X]mul1r; apply: ler_pmul; rewrite ?invr_ge0 ?(ltW (c0 _)) ?weight_le1 //.
  exact: inverse_weight.
by apply: ler_expn2r; rewrite ?nnegrE ?subr_ge0 ?poly_rate_le1 ?exprn_ge0 // one_minus_slow.
Qed.

Lemma tau1_mixing s : tau1 (mpow P s) <= n%:R ^+ a.+1 * (1 - slow) ^+ s.
Proof.
pose eps := n%:R ^+ a * (1 - slow) ^+ s.
have s0 : 0 <= 1 - slow by rewrite subr_ge0 slow_le1.
have e0 : 0 <= eps by rewrite mulr_ge0 ?exprn_ge0 // ltW.
rewrite exprS -mulrA -/eps; apply: tau1_le; first by rewrite mulr_ge0 // ltW.
move=> i j; rewrite dist1_overlap; last exact: stochastic_mpow.
rewrite ler_subl_addr -ler_subl_addl.
apply: (@le_trans _ _ (\sum_k (pi k - eps))).
  by rewrite sumrB (stat_sum c0 i0) sumr_const card_ord -[eps *+ n]mulr_natl.
apply: ler_sum => k _; have H l : pi k - eps <= mpow P s l k.
  have := eq_3_9 s l k; rewrite -/slow -/eps ler_norml => /andP[h _].
  by rewrite ler_subr_addr addrC in h.
by rewrite le_minr !H.
Qed.

(* chazelle.eq3.10 with c_0 = 3a + 6 *)
Theorem eq_3_10 s : (n ^ (3 * a + 6) < s)%N ->
  tau1 (mpow P s) <= 1 - \sum_k (pi k - n%:R ^+ a * (1 - (n%:R ^+ (2 * a + 4))^-1) ^+ s) /\
  1 - \sum_k (pi k - n%:R ^+ a * (1 - (n%:R ^+ (2 * a + 4))^-1) ^+ s) < 2%:R^-1.
Proof.
move=> ss; have -> : 1 - \sum_k (pi k - n%:R ^+ a * (1 - (n%:R ^+ (2 * a + 4))^-1) ^+ s)
    = n%:R ^+ a.+1 * (1 - slow) ^+ s.
  rewrite -/slow; set eps := n%:R ^+ a * _.
  by rewrite sumrB (stat_sum c0 i0) sumr_const card_ord -[eps *+ n]mulr_natl subKr exprS -mulrA.
split; first exact: tau1_mixing.
have m0 : (0 < n ^ (2 * a + 4))%N by rewrite expn_gt0 (ltnW n2).
have H := @halving R (n ^ (2 * a + 4)) s m0; rewrite natrX -/slow in H.
apply: le_lt_trans (ler_wpmul2l _ H) _; first exact: ltW.
set q := (s %/ _)%N; have qn : (n ^ (a + 2) <= q)%N.
  rewrite /q leq_divRL // -expnD; apply: leq_trans (ltnW ss).
  by rewrite leq_pexp2l ?(ltnW n2) //; lia.
rewrite exprVn ltr_pdivr_mulr ?exprn_gt0 ?ltr0n // mulrC ltr_pdivl_mulr ?ltr0n //.
rewrite -!natrX -natrM ltr_nat; apply: (@leq_trans (2 ^ (n ^ (a + 2)))); last by rewrite leq_exp2l.
apply: (@leq_trans (2 ^ (n * a.+1 + 1))).
  by rewrite expnD expn1 ltn_mul2r /= expnM ltn_exp2r // ltn_expl.
rewrite leq_exp2l // addn2 expnS.
have h : (a.+2 <= n ^ a.+1)%N.
  by apply: (leq_trans (ltn_expl a.+1 (ltnSn 1))); rewrite leq_exp2r.
have : (n * a.+2 <= n * n ^ a.+1)%N by rewrite leq_mul2l h orbT.
by move: n2 => h2 h3; apply: leq_trans h3; rewrite !mulnS; lia.
Qed.
End Network.

(* ---- chazelle.fiedler.rate ---- *)
(* every eigenvalue of the Laplacian of a connected graph, except the simple 0, is at least 1/(n (n-1)^2) *)
Section Fiedler.
Variables (R : realFieldType) (n : nat) (G : rel 'I_n).
Hypothesis net : network G.
Hypothesis conn : forall i j, connect G i j.
Notation L := (laplacian R G).
Let c (_ : 'I_n) : R := n%:R^-1.

Lemma uniform_model_D : model_D G c.
Proof.
have [_ irr] := net; move=> i d0; have n0 : (0 < n)%N by exact: leq_ltn_trans (leq0n _) (ltn_ord i).
rewrite /c mulr_gt0 ?invr_gt0 ?ltr0n //= mulrC ltr_pdivr_mulr ?ltr0n // mul1r ltr_nat.
rewrite -[X in (_ < X)%N]card_ord; apply: proper_card; apply/properP; split; first by apply/subsetP.
by exists i; rewrite // inE irr.
Qed.

Theorem fiedler_number lam (f : 'I_n -> R) :
  (forall i, \sum_j L i j * f j = lam * f i) -> (exists i, f i != 0) -> lam != 0 ->
  1 <= lam * (n * n.-1 ^ 2)%:R.
Proof.
move=> E [i fi] l0; have n0 : (0 < n)%N by exact: leq_ltn_trans (leq0n _) (ltn_ord i).
have N0 : 0 < n%:R :> R by rewrite ltr0n.
have c0 j : 0 < c j by rewrite invr_gt0.
have MD := uniform_model_D; have [sym irr] := net.
have st j : f j - step G c f j = n%:R^-1 * (lam * f j).
  rewrite -E /step (eq_bigr (fun k => (j == k)%:R * f k - n%:R^-1 * (L j k * f k))) => [|k _]; last first.
    have -> : transition G c j k = (j == k)%:R - n%:R^-1 * L j k.
      rewrite transitionE // !mxE /c; case: (j == k); first by [].
      by case: (G j k); rewrite ?mulrN1 ?mulr0 ?sub0r ?opprK ?oppr0.
    by rewrite mulrBl mulrA.
  rewrite sumrB -mulr_sumr (bigD1 j) //= eqxx mul1r big1 ?addr0 ?subKr // => k kj.
  by rewrite eq_sym (negbTE kj) mul0r.
have st1 j : step G c f j = (1 - n%:R^-1 * lam) * f j.
  by rewrite -[LHS](subKr (f j)) st mulrBl mul1r mulrA.
have m0 : mean c f = 0.
  have := mean_step net MD c0 f; rewrite (eq_mean c st1) meanZ => /eqP.
  rewrite -subr_eq0 mulrBl mul1r addrAC subrr sub0r oppr_eq0 mulf_eq0 mulf_eq0 invr_eq0 (gt_eqF N0) (negbTE l0) /=.
  by move/eqP.
have q0 : 0 < sqn c f.
  rewrite lt_def sqn_ge0 // andbT; apply/eqP => Z; move: fi; by rewrite (sqn_eq0 c0 Z) eqxx.
have := poincare net MD conn c0 m0; rewrite -(dirichlet net MD c0 f).
have -> : \sum_j stat c j * f j * (f j - step G c f j) = n%:R^-1 * lam * sqn c f.
  rewrite /sqn mulr_sumr; apply: eq_bigr => j _; rewrite st; ring.
have -> : trace c = n%:R * n%:R.
  by rewrite /trace (eq_bigr (fun=> n%:R)) => [|j _]; rewrite ?invrK // sumr_const card_ord -mulr_natl.
rewrite [X in _ <= X]mulrnAr ler_muln2r /= -(ler_pmul2l (mulr_gt0 N0 N0)) mulrA mulfV ?mul1r ?gt_eqF ?mulr_gt0 //.
rewrite -[X in X <= _]mul1r.
have -> : n%:R * n%:R * ((n.-1 ^ 2)%:R * (n%:R^-1 * lam * sqn c f)) = lam * (n * n.-1 ^ 2)%:R * sqn c f.
  by rewrite natrM; move: (gt_eqF N0) => nz; field; rewrite nz.
by rewrite ler_pmul2r.
Qed.
End Fiedler.

(* differences of velocities in R^d, in any norm, decay like n^(a+1) 2^-floor(t/n^(2a+4)) *)
Theorem velocity_differences (R : rcfType) n d a (G : rel 'I_n) (c : 'I_n -> R) (v : nat -> 'M[R]_(n, d)) (N : 'rV[R]_d -> R) t i j :
  N 0 = 0 -> (forall b y, N (b *: y) = `|b| * N y) -> (forall y z, N (y + z) <= N y + N z) -> network G -> model_D G c -> (forall i j, connect G i j) -> (forall i, 0 < c i) -> (1 < n)%N ->
  (forall i, (n%:R ^+ a)^-1 <= c i) -> (forall i, (n%:R ^+ a)^-1 <= transition G c i i) ->
  (forall t, (0 < t)%N -> v t.+1 = transition G c *m v t) ->
  N (row i (v t.+1) - row j (v t.+1)) <=
    n%:R ^+ a.+1 * (2%:R^-1) ^+ (t %/ n ^ (2 * a + 4)) * diameter N (v 1%N).
Proof.
move=> N_0 N_Z N_D net MD conn c0 n2 sc sd Hv.
have SP : stochastic (transition G c) by case: (model_D_stochastic net MD).
have E : v t.+1 = mpow (transition G c) t *m v 1%N.
  elim: t => [|t IH]; first by rewrite mul1mx.
  by rewrite Hv // IH mulmxA.
have d0 : 0 <= diameter N (v 1%N) by exact: max_ge0.
rewrite E; apply: le_trans (diameter_ub _ _ _ _) _.
apply: le_trans (diameter_mul N_0 N_Z N_D _ (stochastic_mpow t SP)) _.
apply: ler_wpmul2r => //; apply: le_trans (tau1_mixing net MD conn c0 n2 sc sd t) _.
have N0 : 0 < n%:R :> R by rewrite ltr0n ltnW.
apply: ler_wpmul2l; first by rewrite exprn_ge0 // ltW.
rewrite /slow -natrX; apply: halving; by rewrite expn_gt0 ltnW.
Qed.


(* chazelle.fiedler.rate: both halves *)
Theorem fiedler_rate (R : rcfType) n (G : rel 'I_n) : network G -> (forall i j, connect G i j) ->
  (forall lam (f : 'I_n -> R), (forall i, \sum_j laplacian R G i j * f j = lam * f i) -> (exists i, f i != 0) ->
     lam != 0 -> 1 <= lam * (n * n.-1 ^ 2)%:R) /\
  (forall d a (c : 'I_n -> R) (v : nat -> 'M[R]_(n, d)) (N : 'rV[R]_d -> R) t i j,
     N 0 = 0 -> (forall b y, N (b *: y) = `|b| * N y) -> (forall y z, N (y + z) <= N y + N z) -> model_D G c -> (forall i, 0 < c i) -> (1 < n)%N ->
     (forall i, (n%:R ^+ a)^-1 <= c i) -> (forall i, (n%:R ^+ a)^-1 <= transition G c i i) ->
     (forall t, (0 < t)%N -> v t.+1 = transition G c *m v t) ->
     N (row i (v t.+1) - row j (v t.+1)) <=
       n%:R ^+ a.+1 * (2%:R^-1) ^+ (t %/ n ^ (2 * a + 4)) * diameter N (v 1%N)).
Proof.
move=> net conn; split; first exact: (fiedler_number net conn).
by move=> d a c v N t i j N0 NZ ND MD c0 n2 sc sd Hv; exact: (velocity_differences t i j N0 NZ ND net MD conn c0 n2 sc sd Hv).
Qed.
