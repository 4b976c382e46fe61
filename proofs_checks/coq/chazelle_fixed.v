(* Chazelle, section 3 (Time-Invariant Flocking): one connected network that stays.
     chazelle.pi, chazelle.lem3.2, chazelle.eq3.9, chazelle.eq3.10, chazelle.fiedler.rate.
   No spectral theorem: the energy  E f = sum pi_i p_ij (f_i - f_j)^2  of a function of mean 0 is at
   least 2 w/(n-1)^2 times its square norm (a path joins any two birds), and one step of P lowers the
   square norm by at least (min p_ii) E f.  So |P^s f|^2 <= (1 - rate)^s |f|^2 with an explicit rate.
   Any ordered field, no axioms. *)
Set Warnings "-notation-overridden,-ambiguous-paths".
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import ring zify.
From Flockproof Require Import chazelle_model chazelle_ergodicity.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Import GRing.Theory Num.Theory Order.Theory.
Local Open Scope ring_scope.

Fixpoint mpow (R : ringType) n (A : 'M[R]_n) s : 'M[R]_n := if s is s'.+1 then A *m mpow A s' else 1%:M.

Lemma mpowSr (R : ringType) n (A : 'M[R]_n) s : mpow A s.+1 = mpow A s *m A.
Proof. by elim: s => [|s IH] /=; [rewrite mulmx1 mul1mx | rewrite -mulmxA -IH]. Qed.
Lemma mpowD (R : ringType) n (A : 'M[R]_n) s t : mpow A (s + t) = mpow A s *m mpow A t.
Proof. by elim: s => [|s IH] /=; [rewrite mul1mx | rewrite IH mulmxA]. Qed.
Lemma stochastic_mpow (R : realFieldType) n (A : 'M[R]_n) s : stochastic A -> stochastic (mpow A s).
Proof. by move=> SA; elim: s => [|s IH]; [exact: stochastic1 | exact: stochastic_mul]. Qed.

(* sums of squares with weights *)
Lemma weighted_cauchy (R : realFieldType) (I : finType) (a g : I -> R) : (forall i, 0 <= a i) ->
  (\sum_i a i * g i) ^+ 2 <= (\sum_i a i) * \sum_i a i * g i ^+ 2.
Proof.
move=> a0; rewrite -(ler_pmuln2r (ltn0Sn 1)) -subr_ge0.
have -> : ((\sum_i a i) * \sum_i a i * g i ^+ 2) *+ 2 - (\sum_i a i * g i) ^+ 2 *+ 2
  = \sum_i \sum_j a i * a j * (g i - g j) ^+ 2.
  have -> : \sum_i \sum_j a i * a j * (g i - g j) ^+ 2 = \sum_i \sum_j
     ((a i * g i ^+ 2) * a j + a i * (a j * g j ^+ 2) - (a i * g i) * (a j * g j) *+ 2).
    by apply: eq_bigr => i _; apply: eq_bigr => j _; ring.
  have D (u v : I -> R) : \sum_i \sum_j u i * v j = (\sum_i u i) * \sum_j v j.
    by rewrite mulr_suml; apply: eq_bigr => i _; rewrite mulr_sumr.
  rewrite [RHS](eq_bigr (fun i => \sum_j (a i * g i ^+ 2) * a j + \sum_j a i * (a j * g j ^+ 2)
     - (\sum_j (a i * g i) * (a j * g j)) *+ 2)); last first.
    by move=> i _; rewrite sumrB big_split sumrMnl.
  rewrite sumrB big_split /= !D sumrMnl D.
  by move: (\sum_i a i) (\sum_i a i * g i ^+ 2) (\sum_i a i * g i) => S T U; ring.
apply: sumr_ge0 => i _; apply: sumr_ge0 => j _; by rewrite mulr_ge0 ?sqr_ge0 // mulr_ge0.
Qed.

Section Fixed.
Variables (R : realFieldType) (n : nat) (G : rel 'I_n) (c : 'I_n -> R).
Hypothesis net : network G.
Hypothesis MD : model_D G c.
Hypothesis conn : forall i j, connect G i j.
Hypothesis c0 : forall i, 0 < c i.
Notation P := (transition G c).

(* pi = (tr C^-1)^-1 C^-1 1 *)
Definition trace : R := \sum_i (c i)^-1.
Definition stat (i : 'I_n) : R := trace^-1 * (c i)^-1.
Notation pi := stat.
Notation w := trace^-1.

Let SP : stochastic P. Proof. by case: (model_D_stochastic net MD). Qed.
Let P0 i j : 0 <= P i j. Proof. by case: SP. Qed.
Let P1 i : \sum_j P i j = 1. Proof. by case: SP. Qed.

Lemma ci0 i : 0 < (c i)^-1. Proof. by rewrite invr_gt0. Qed.
Lemma trace_gt0 (i : 'I_n) : 0 < trace.
Proof.
rewrite /trace (bigD1 i) //=; apply: ltr_paddr; last exact: ci0.
by apply: sumr_ge0 => j _; rewrite ltW ?ci0.
Qed.
Lemma stat_gt0 i : 0 < pi i. Proof. by rewrite mulr_gt0 ?ci0 // invr_gt0 (trace_gt0 i). Qed.
Lemma stat_sum (i : 'I_n) : \sum_j pi j = 1.
Proof. by rewrite -mulr_sumr mulVf // gt_eqF ?(trace_gt0 i). Qed.

Lemma stat_edge i j : G i j -> pi i * P i j = w.
Proof.
have [sym irr] := net; move=> Gij; rewrite transitionE //.
have /negbTE-> : i != j by apply: contraTneq Gij => ->; rewrite irr.
by rewrite Gij /stat mulfVK ?gt_eqF.
Qed.
Lemma balance i j : pi i * P i j = pi j * P j i.
Proof.
have [sym irr] := net; have [->//|ij] := eqVneq i j.
case Gij: (G i j); first by rewrite !stat_edge // sym.
have ji : (j == i) = false by rewrite eq_sym; exact: negbTE.
have Gji : G j i = false by rewrite sym.
by rewrite !transitionE // (negbTE ij) ji Gij Gji !mulr0.
Qed.
Lemma stat_left j : \sum_i pi i * P i j = pi j.
Proof. by rewrite (eq_bigr (fun i => pi j * P j i)) => [|i _]; [rewrite -mulr_sumr P1 mulr1 | exact: balance]. Qed.

(* functions on the birds *)
Implicit Types f g : 'I_n -> R.
Definition step f : 'I_n -> R := fun i => \sum_j P i j * f j.
Definition mean f : R := \sum_i pi i * f i.
Definition sqn f : R := \sum_i pi i * f i ^+ 2.
Definition energy f : R := \sum_i \sum_j pi i * P i j * (f i - f j) ^+ 2.

Lemma sqn_ge0 f : 0 <= sqn f.
Proof. by apply: sumr_ge0 => i _; rewrite mulr_ge0 ?sqr_ge0 // ltW ?stat_gt0. Qed.
Lemma energy_ge0 f : 0 <= energy f.
Proof.
apply: sumr_ge0 => i _; apply: sumr_ge0 => j _.
by rewrite mulr_ge0 ?sqr_ge0 // mulr_ge0 // ltW ?stat_gt0.
Qed.
Lemma mean_step f : mean (step f) = mean f.
Proof.
rewrite /mean /step (eq_bigr (fun i => \sum_j pi i * P i j * f j)); last first.
  by move=> i _; rewrite mulr_sumr; apply: eq_bigr => j _; rewrite mulrA.
by rewrite exchange_big /=; apply: eq_bigr => j _; rewrite -mulr_suml stat_left.
Qed.

(* the Dirichlet form *)
Lemma dirichlet f : (\sum_i pi i * f i * (f i - step f i)) *+ 2 = energy f.
Proof.
have E i : f i - step f i = \sum_j P i j * (f i - f j).
  rewrite -[X in X - _]mul1r -(P1 i) mulr_suml -sumrB; apply: eq_bigr => j _.
  by rewrite mulrBr.
have -> : \sum_i pi i * f i * (f i - step f i) = \sum_i \sum_j pi i * P i j * (f i * (f i - f j)).
  by apply: eq_bigr => i _; rewrite E mulr_sumr; apply: eq_bigr => j _; ring.
rewrite mulr2n {2}exchange_big /= -big_split /=; apply: eq_bigr => i _.
rewrite -big_split /=; apply: eq_bigr => j _; rewrite (balance j i); ring.
Qed.

Lemma edge_energy f i j : G i j -> w * (f i - f j) ^+ 2 *+ 2 <= energy f.
Proof.
have [sym irr] := net; move=> Gij.
have ij : i != j by apply: contraTneq Gij => ->; rewrite irr.
have Eij : w * (f i - f j) ^+ 2 = pi i * P i j * (f i - f j) ^+ 2 by rewrite stat_edge.
have Eji : w * (f i - f j) ^+ 2 = pi j * P j i * (f j - f i) ^+ 2.
  by rewrite stat_edge 1?sym // -[f j - f i]opprB sqrrN.
have t0 k l : 0 <= pi k * P k l * (f k - f l) ^+ 2.
  by rewrite mulr_ge0 ?sqr_ge0 // mulr_ge0 // ltW ?stat_gt0.
rewrite /energy pair_big /= (bigD1 (i, j)) //= (bigD1 (j, i)) /=; last by rewrite xpair_eqE negb_and eq_sym ij.
rewrite mulr2n {1}Eij Eji addrA ler_addl; apply: sumr_ge0 => k _; exact: t0.
Qed.

(* the largest difference along an edge *)
Definition steepest f : R := \big[Num.max/0]_(e : 'I_n * 'I_n) (if G e.1 e.2 then `|f e.1 - f e.2| else 0).

Lemma steepest_edge f i j : G i j -> `|f i - f j| <= steepest f.
Proof.
by move=> Gij; have := max_ub (fun e : 'I_n * 'I_n => if G e.1 e.2 then `|f e.1 - f e.2| else 0) (i, j); rewrite /= Gij.
Qed.
Lemma steepest_ge0 f : 0 <= steepest f. Proof. exact: max_ge0. Qed.
Lemma steepest_energy f (i : 'I_n) : w * steepest f ^+ 2 *+ 2 <= energy f.
Proof.
have w0 : 0 <= w by rewrite invr_ge0 ltW ?(trace_gt0 i).
have : 0 <= steepest f /\ w * steepest f ^+ 2 *+ 2 <= energy f; last by case.
apply: (big_ind (fun x => 0 <= x /\ w * x ^+ 2 *+ 2 <= energy f)).
- by split=> //; rewrite expr0n /= mulr0 mul0rn energy_ge0.
- by move=> x y [x0 Ex] [y0 Ey]; rewrite /Num.max; case: ifP.
move=> [k l] _ /=; case Gkl: (G k l); last by split=> //; rewrite expr0n /= mulr0 mul0rn energy_ge0.
by split; rewrite ?normr_ge0 // real_normK ?num_real // edge_energy.
Qed.

Lemma path_difference f i p : path G i p -> `|f i - f (last i p)| <= (size p)%:R * steepest f.
Proof.
elim: p i => [|j p IH] i /=; first by rewrite subrr normr0 mul0r.
case/andP=> Gij pth; rewrite -(addrNK (f j) (f i)) -addrA.
apply: le_trans (ler_norm_add _ _) _; rewrite mulrSr mulrDl mul1r addrC.
by apply: ler_add; [exact: IH | exact: steepest_edge].
Qed.

(* any two birds are joined by a path of at most n-1 edges *)
Lemma oscillation f i j : `|f i - f j| <= n.-1%:R * steepest f.
Proof.
have /connectP[p pth ->] := conn i j; case/shortenP: pth => q qth uq _.
apply: le_trans (path_difference f qth) _; apply: ler_wpmul2r; first exact: steepest_ge0.
rewrite ler_nat; have := max_card (mem (i :: q)); rewrite (card_uniqP uq) card_ord /=.
by move=> h; rewrite -ltnS (leq_trans h) // leqSpred.
Qed.

Lemma mean_zero_bound f i : mean f = 0 -> `|f i| <= n.-1%:R * steepest f.
Proof.
move=> m0; have -> : f i = \sum_j pi j * (f i - f j).
  rewrite (eq_bigr (fun j => pi j * f i - pi j * f j)) => [|j _]; last by rewrite mulrBr.
  by rewrite sumrB -mulr_suml (stat_sum i) mul1r -/(mean f) m0 subr0.
apply: le_trans (ler_norm_sum _ _ _) _; rewrite -[X in _ <= X]mul1r -{1}(stat_sum i) mulr_suml.
apply: ler_sum => j _; rewrite normrM gtr0_norm ?stat_gt0 //.
by apply: ler_wpmul2l; [exact: ltW (stat_gt0 j) | exact: oscillation].
Qed.

(* the energy of a function of mean 0 bounds its square norm *)
Lemma poincare f : mean f = 0 -> w * sqn f *+ 2 <= (n.-1 ^ 2)%:R * energy f.
Proof.
move=> m0; case: (pickP 'I_n) => [i _|no]; last first.
  have Z : sqn f = 0 by rewrite /sqn big1 // => i _; have := no i.
  by rewrite Z mulr0 mul0rn mulr_ge0 ?ler0n ?energy_ge0.
apply: (@le_trans _ _ ((n.-1 ^ 2)%:R * (w * steepest f ^+ 2 *+ 2))); last first.
  by apply: ler_wpmul2l; [rewrite ler0n | exact: steepest_energy f i].
rewrite mulrnAr mulrCA ler_muln2r /=; apply: ler_wpmul2l; first by rewrite invr_ge0 ltW ?(trace_gt0 i).
have E0 : 0 <= steepest f by exact: steepest_ge0.
rewrite -[X in _ <= X]mul1r -{1}(stat_sum i) mulr_suml.
apply: ler_sum => j _; apply: ler_wpmul2l; first exact: ltW (stat_gt0 j).
rewrite natrX -exprMn -real_normK ?num_real // ler_pexpn2r ?nnegrE ?mean_zero_bound //.
by rewrite mulr_ge0 ?ler0n ?steepest_ge0.
Qed.

(* one step takes away at least alpha times the energy *)
Variable alpha : R.
Hypothesis alpha_diag : forall i, alpha <= P i i.

Lemma step_drop f : sqn (step f) <= sqn f - alpha * energy f.
Proof.
have drop i : step f i ^+ 2 <= \sum_j P i j * f j ^+ 2 - alpha * \sum_j P i j * (f i - f j) ^+ 2.
  set Q := \sum_j P i j * (f i - f j) ^+ 2.
  have V : \sum_j P i j * f j ^+ 2 - step f i ^+ 2 = Q - (f i - step f i) ^+ 2.
    rewrite /Q [X in _ = X - _](eq_bigr (fun j => f i ^+ 2 * P i j + P i j * f j ^+ 2 - f i *+ 2 * (P i j * f j))); last first.
      by move=> j _; ring.
    rewrite sumrB big_split /= -!mulr_sumr P1 -/(step f i).
    by move: (\sum_j _) => S; ring.
  have C : (f i - step f i) ^+ 2 <= (1 - P i i) * Q.
    pose a j := if j == i then 0 else P i j.
    have a0 j : 0 <= a j by rewrite /a; case: ifP.
    have -> : f i - step f i = \sum_j a j * (f i - f j).
      rewrite -[X in X - _]mul1r -(P1 i) mulr_suml -sumrB; apply: eq_bigr => j _; rewrite -mulrBr /a.
      by case: eqP => // ->; rewrite subrr !mulr0.
    have -> : 1 - P i i = \sum_j a j.
      rewrite -(P1 i) (bigD1 i) //= addrC addKr [RHS](bigD1 i) //= {1}/a eqxx add0r.
      by apply: eq_bigr => j ji; rewrite /a (negbTE ji).
    have -> : Q = \sum_j a j * (f i - f j) ^+ 2.
      apply: eq_bigr => j _; rewrite /a; case: eqP => // ->; by rewrite subrr expr0n /= !mulr0.
    exact: weighted_cauchy.
  have Q0 : 0 <= Q by apply: sumr_ge0 => j _; rewrite mulr_ge0 ?sqr_ge0.
  rewrite -[X in X <= _](subKr (\sum_j P i j * f j ^+ 2)) V ler_add2l ler_opp2.
  apply: (@le_trans _ _ (P i i * Q)); first exact: ler_wpmul2r.
  by rewrite -[X in X * Q](subKr 1) mulrBl mul1r ler_add2l ler_opp2.
apply: (@le_trans _ _ (\sum_i pi i * (\sum_j P i j * f j ^+ 2 - alpha * \sum_j P i j * (f i - f j) ^+ 2))).
  apply: ler_sum => i _; apply: ler_wpmul2l; [exact: ltW (stat_gt0 i) | exact: drop].
rewrite (eq_bigr (fun i => \sum_j pi i * P i j * f j ^+ 2 - alpha * \sum_j pi i * P i j * (f i - f j) ^+ 2)); last first.
  move=> i _; rewrite mulrBr !mulr_sumr; congr (_ - _); first by apply: eq_bigr => j _; rewrite mulrA.
  by apply: eq_bigr => j _; ring.
rewrite sumrB -mulr_sumr -/(energy f) ler_add2r exchange_big /=.
by rewrite (eq_bigr (fun j => pi j * f j ^+ 2)) => [|j _]; rewrite // -mulr_suml stat_left.
Qed.

(* the rate: any number with rate (n-1)^2 <= 2 alpha w *)
Variable rate : R.
Hypothesis alpha0 : 0 <= alpha.
Hypothesis rate_le : rate * (n.-1 ^ 2)%:R <= alpha * w *+ 2.

Lemma contraction f : mean f = 0 -> sqn (step f) <= (1 - rate) * sqn f.
Proof.
move=> m0; apply: le_trans (step_drop f) _; rewrite mulrBl mul1r ler_add2l ler_opp2.
have [n1|n2] := leqP n 1.
  have Z : sqn f = 0.
    rewrite /sqn big1 // => i _; have := mean_zero_bound i m0.
    have -> : n.-1 = 0%N by case: (n) n1 => [|[]].
    by rewrite mul0r normr_le0 => /eqP->; rewrite expr0n mulr0.
  by rewrite Z mulr0 mulr_ge0 ?energy_ge0.
have q0 : 0 < (n.-1 ^ 2)%:R :> R by rewrite ltr0n expn_gt0; case: (n) n2 => [|[]].
rewrite -(ler_pmul2l q0) mulrA [X in X * _]mulrC.
apply: (@le_trans _ _ (alpha * w *+ 2 * sqn f)); first by apply: ler_wpmul2r; rewrite ?sqn_ge0.
have -> : alpha * w *+ 2 * sqn f = alpha * (w * sqn f *+ 2) by rewrite mulrnAl mulrnAr mulrA.
by rewrite [X in _ <= X]mulrCA; apply: ler_wpmul2l => //; exact: poincare.
Qed.

Definition iterate s f : 'I_n -> R := fun i => \sum_j mpow P s i j * f j.
Lemma iterate0 f i : iterate 0 f i = f i.
Proof.
rewrite /iterate (bigD1 i) //= mxE eqxx mul1r big1 ?addr0 // => j ji.
by rewrite mxE eq_sym (negbTE ji) mul0r.
Qed.
Lemma iterateS s f i : iterate s.+1 f i = step (iterate s f) i.
Proof.
rewrite /iterate /step /= (eq_bigr (fun j => \sum_k P i k * (mpow P s k j * f j))); last first.
  by move=> j _; rewrite mxE mulr_suml; apply: eq_bigr => k _; rewrite mulrA.
by rewrite exchange_big /=; apply: eq_bigr => k _; rewrite mulr_sumr.
Qed.
Lemma eq_mean f g : f =1 g -> mean f = mean g.
Proof. by move=> E; apply: eq_bigr => i _; rewrite E. Qed.
Lemma eq_sqn f g : f =1 g -> sqn f = sqn g.
Proof. by move=> E; apply: eq_bigr => i _; rewrite E. Qed.
Lemma mean_iterate s f : mean (iterate s f) = mean f.
Proof.
elim: s => [|s IH]; first exact: eq_mean (iterate0 f).
by rewrite (eq_mean (iterateS s f)) mean_step.
Qed.

Hypothesis rate1 : rate <= 1.
Lemma contraction_iterate s f : mean f = 0 -> sqn (iterate s f) <= (1 - rate) ^+ s * sqn f.
Proof.
move=> m0; elim: s => [|s IH]; first by rewrite (eq_sqn (iterate0 f)) expr0 mul1r.
rewrite (eq_sqn (iterateS s f)); apply: le_trans (contraction _) _; first by rewrite mean_iterate.
by rewrite exprS -mulrA; apply: ler_wpmul2l; rewrite ?subr_ge0.
Qed.

Lemma pointwise f i : pi i * f i ^+ 2 <= sqn f.
Proof.
rewrite /sqn (bigD1 i) //= ler_addl; apply: sumr_ge0 => j _.
by rewrite mulr_ge0 ?sqr_ge0 // ltW ?stat_gt0.
Qed.

(* |(P^s)_ij - pi_j|^2 <= (c_i/c_j) (1 - rate)^s, for all s *)
Theorem mixing s i j : (mpow P s i j - pi j) ^+ 2 <= c i / c j * (1 - rate) ^+ s.
Proof.
pose f k := (k == j)%:R - pi j.
have If k : iterate s f k = mpow P s k j - pi j.
  rewrite /iterate /f (eq_bigr (fun l => mpow P s k l * (l == j)%:R - mpow P s k l * pi j)); last first.
    by move=> l _; rewrite mulrBr.
  rewrite sumrB -mulr_suml; have [_ ->] := stochastic_mpow s SP; rewrite mul1r (bigD1 j) //= eqxx mulr1.
  by rewrite big1 ?addr0 // => l /negbTE->; rewrite mulr0.
have m0 : mean f = 0.
  rewrite /mean /f (eq_bigr (fun l => pi l * (l == j)%:R - pi l * pi j)); last by move=> l _; rewrite mulrBr.
  rewrite sumrB -mulr_suml (stat_sum i) mul1r (bigD1 j) //= eqxx mulr1 big1 ?addr0 ?subrr //.
  by move=> l /negbTE->; rewrite mulr0.
have q : sqn f <= pi j.
  have -> : sqn f = pi j - pi j ^+ 2.
    rewrite /sqn /f (eq_bigr (fun l => pi l * (l == j)%:R * (1 - pi j *+ 2) + pi l * pi j ^+ 2)); last first.
      move=> l _; have -> : (((l == j)%:R - pi j) ^+ 2 = (l == j)%:R * (1 - pi j *+ 2) + pi j ^+ 2).
        by case: (l == j); rewrite ?mul1r ?mul0r ?sub0r ?sqrrN ?add0r // sqrrB expr1n mul1r.
      by rewrite mulrDr mulrA.
    rewrite big_split /= -!mulr_suml (stat_sum i) mul1r (bigD1 j) //= eqxx mulr1 big1 => [|l /negbTE->]; last by rewrite mulr0.
    by rewrite addr0; ring.
  by rewrite ler_subl_addr ler_addl sqr_ge0.
have := pointwise (iterate s f) i; rewrite If => /le_trans/(_ (contraction_iterate s m0)) H.
rewrite -(ler_pmul2l (stat_gt0 i)); apply: le_trans H _.
have -> : pi i * (c i / c j * (1 - rate) ^+ s) = (1 - rate) ^+ s * pi j.
  by rewrite /stat [LHS]mulrA -[X in X * _ = _]mulrA mulKf ?gt_eqF // mulrC.
by apply: ler_wpmul2l; rewrite ?exprn_ge0 ?subr_ge0.
Qed.
End Fixed.
