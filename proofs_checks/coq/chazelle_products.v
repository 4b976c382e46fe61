(* Chazelle, section 2 (Numerical Complexity): how small the nonzero entries of a product
   P(t,s) are, and how long its entries and the state are.
     chazelle.lem2.2.entries, chazelle.lem2.2.bits, chazelle.lem2.3.
   Entries: follow the support of one column; it can grow at most n-1 times, and only then does the
   smallest positive entry drop (by the factor alpha at worst).
   Lengths: a row of P(t) has the denominator of its c_i, a product the product of the denominators.
   Any ordered field, no axioms. *)
Set Warnings "-notation-overridden,-ambiguous-paths".
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import ring zify.
From Flockproof Require Import chazelle_model chazelle_ergodicity.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Import GRing.Theory Num.Theory Order.Theory.
Local Open Scope ring_scope.

Section Entries.
Variables (R : realFieldType) (n : nat) (P : nat -> 'M[R]_n) (alpha : R).
Hypothesis SP : forall t, stochastic (P t).
Hypothesis diag : forall t i, 0 < P t i i.
Hypothesis sym : forall t i j, (P t i j != 0) = (P t j i != 0).
Hypothesis alpha0 : 0 < alpha.
Hypothesis alpha_le : forall t i j, P t i j != 0 -> alpha <= P t i j.

Let P0 t i j : 0 <= P t i j. Proof. by have [] := SP t. Qed.
Let Ppos t i j : P t i j != 0 -> 0 < P t i j. Proof. by move=> h; rewrite lt_def h P0. Qed.

Lemma alpha_le1 (i : 'I_n) : alpha <= 1.
Proof.
have := alpha_le (lt0r_neq0 (diag 0 i)) => /le_trans; apply.
have [_ s1] := SP 0; rewrite -(s1 i) (bigD1 i) //= ler_addl sumr_ge0 // => j _; exact: P0.
Qed.

Variables (s : nat) (j : 'I_n).
Definition supp k : {set 'I_n} := [set i | span P s k i j != 0].
Let Y k i := span P s k i j.
Let Y0 k i : 0 <= Y k i. Proof. exact: span_ge0. Qed.
Let Ypos k i : i \in supp k -> 0 < Y k i.
Proof. by rewrite inE => h; rewrite lt_def h Y0. Qed.
Let YS k i : Y k.+1 i = \sum_l P (s + k)%N i l * Y k l. Proof. by rewrite /Y /= mxE. Qed.

Lemma supp_mono k : supp k \subset supp k.+1.
Proof.
apply/subsetP=> i ik; rewrite inE -/(Y _ _) lt0r_neq0 // YS (bigD1 i) //=.
apply: ltr_paddr; first by apply: sumr_ge0 => l _; rewrite mulr_ge0.
by apply: mulr_gt0; [exact: diag | exact: Ypos].
Qed.

Lemma supp_card_gt0 k : (0 < #|supp k|)%N.
Proof.
have: j \in supp k.
  elim: k => [|k IH]; first by rewrite inE /= mxE eqxx oner_neq0.
  exact: subsetP (supp_mono k) _ IH.
by move=> jk; apply/card_gt0P; exists j.
Qed.

Lemma entries_support k i : i \in supp k -> alpha ^+ (#|supp k|.-1) <= Y k i.
Proof.
have a1 := alpha_le1 j; have a0 := ltW alpha0.
elim: k i => [|k IH] i ik.
  have -> : Y 0 i = 1.
    by move: ik; rewrite inE /Y /= mxE; case: (i == j); rewrite ?eqxx.
  exact: exprn_ile1.
have sub := supp_mono k.
case: (eqVneq (supp k.+1) (supp k)) => [E|nE].
  rewrite E in ik *; rewrite YS.
  have inside l : P (s + k)%N i l != 0 -> l \in supp k.
    move=> nz; rewrite -E inE -/(Y _ _) lt0r_neq0 // YS (bigD1 i) //=.
    apply: ltr_paddr; first by apply: sumr_ge0 => m _; rewrite mulr_ge0.
    by apply: mulr_gt0; [apply: Ppos; rewrite sym | exact: Ypos].
  have [_ sum1] := SP (s + k)%N; rewrite -[X in X <= _]mul1r -(sum1 i) mulr_suml.
  apply: ler_sum => l _; have [->|nz] := eqVneq (P (s + k)%N i l) 0; first by rewrite !mul0r.
  by apply: ler_wpmul2l => //; apply: IH; exact: inside.
have lt : (#|supp k| < #|supp k.+1|)%N.
  by apply: proper_card; rewrite properEneq eq_sym nE sub.
have [l nz lk] : exists2 l, P (s + k)%N i l != 0 & l \in supp k.
  apply/exists_inP; apply: contraLR ik => /exists_inPn H; rewrite inE negbK -/(Y _ _) YS big1 // => l _.
  have [-> | /H lk] := eqVneq (P (s + k)%N i l) 0; first by rewrite mul0r.
  by move: lk; rewrite inE negbK -/(Y _ _) => /eqP->; rewrite mulr0.
apply: (@le_trans _ _ (alpha * alpha ^+ #|supp k|.-1)).
  rewrite -exprS prednK ?supp_card_gt0 //; apply: ler_wiexpn2l => //.
  by rewrite -ltnS (ltn_predK lt).
rewrite YS (bigD1 l) //= -[X in X <= _]addr0 ler_add //; last first.
  by apply: sumr_ge0 => m _; rewrite mulr_ge0.
by apply: ler_pmul => //; [exact: exprn_ge0 | exact: alpha_le | exact: IH].
Qed.

(* every nonzero entry is at least alpha^(n-1), however long the product *)
Theorem entries_bound k i : span P s k i j != 0 -> alpha ^+ n.-1 <= span P s k i j.
Proof.
move=> nz; have ik : i \in supp k by rewrite inE.
apply: le_trans (entries_support ik); apply: ler_wiexpn2l; [exact: ltW | exact: (alpha_le1 j) | ].
have := max_card (mem (supp k)); rewrite card_ord; case: #|_| => [|m] //; case: (n) => [|n'] //=.
Qed.
End Entries.

(* chazelle.lem2.2.entries: with positive entries of every P(t) at least n^-a (c_i of O(log n) bits) *)
Theorem lemma_2_2_entries (R : realFieldType) n a (G : nat -> rel 'I_n) (c : nat -> 'I_n -> R) s t i j :
  (forall u, network (G u)) -> (forall u, model_D (G u) (c u)) ->
  let P u := transition (G u) (c u) in
  (forall u i j, P u i j != 0 -> (n%:R ^+ a)^-1 <= P u i j) -> (s <= t)%N ->
  pprod P t s i j != 0 ->
  (n%:R ^+ (a * n.-1))^-1 <= pprod P t s i j /\ (n%:R ^+ (a * n ^ 2))^-1 <= pprod P t s i j.
Proof.
move=> net D P al _; rewrite /pprod; set k := (_).+1 => nz.
have n0 : (0 < n)%N by exact: leq_ltn_trans (leq0n _) (ltn_ord i).
have nR : 1 <= n%:R :> R by rewrite ler1n.
have S u := model_D_stochastic (net u) (D u).
have H := @entries_bound R n P (n%:R ^+ a)^-1 (fun u => proj1 (S u)) (fun u => proj2 (S u)) _ _ al s j k i nz.
have {}H : (n%:R ^+ (a * n.-1))^-1 <= span P s k i j.
  rewrite exprM -exprVn; apply: H.
    move=> u x y; rewrite !transition_edge //; have [-> _] := net u; by rewrite eq_sym.
  by rewrite invr_gt0 exprn_gt0 // ltr0n.
split=> //; apply: le_trans H; rewrite lef_pinv ?posrE ?exprn_gt0 ?ltr0n //.
apply: ler_weexpn2l => //; rewrite leq_mul2l; apply/orP; right.
by apply: leq_trans (leq_pred n) _; rewrite -{1}[n]expn1 leq_pexp2l.
Qed.

(* ---- lengths ---- *)
Section Lengths.
Variables (R : realFieldType) (n : nat).

(* all entries are fractions with the denominator D *)
Definition denominator m p (A : 'M[R]_(m, p)) (D : nat) := forall i j, exists z : int, A i j = z%:~R / D%:R.

Lemma denominator_mul m p q (A : 'M[R]_(m, p)) (B : 'M[R]_(p, q)) D E :
  denominator A D -> denominator B E -> denominator (A *m B) (D * E).
Proof.
move=> HA HB i k; rewrite mxE.
suff: exists z : int, \sum_j A i j * B j k = z%:~R / (D * E)%:R by [].
elim/big_rec: _ => [|j x _ [z ->]]; first by exists 0; rewrite mul0r.
have [a ->] := HA i j; have [b ->] := HB j k; exists (a * b + z).
by rewrite intrD mulrDl intrM natrM invfM mulrACA.
Qed.
Lemma denominator1 : denominator (1%:M : 'M[R]_n) 1.
Proof. by move=> i j; exists (i == j)%:Z; rewrite mxE divr1; case: (i == j). Qed.
Lemma denominator_dvd m p (A : 'M[R]_(m, p)) D E : (0 < D)%N -> (0 < E)%N -> denominator A D -> denominator A (E * D).
Proof.
move=> D0 E0 HA i j; have [z ->] := HA i j; exists (z * E%:Z).
have d0 : D%:R != 0 :> R by rewrite pnatr_eq0 -lt0n.
have e0 : E%:R != 0 :> R by rewrite pnatr_eq0 -lt0n.
by rewrite intrM natrM -[E%:Z%:~R]/(E%:R); field; rewrite d0 e0.
Qed.
Lemma denominatorD m p (A B : 'M[R]_(m, p)) D : denominator A D -> denominator B D -> denominator (A + B) D.
Proof.
move=> HA HB i j; have [a Ea] := HA i j; have [b Eb] := HB i j; exists (a + b).
by rewrite mxE Ea Eb intrD mulrDl.
Qed.

(* weights c_i = p_i / q_i with q_i <= n^a *)
Definition short_weights a (c : 'I_n -> R) :=
  exists p q : 'I_n -> nat, forall i, [/\ c i = (p i)%:R / (q i)%:R, (0 < q i)%N & (q i <= n ^ a)%N].

Lemma transition_denominator a (G : rel 'I_n) (c : 'I_n -> R) : irreflexive G -> short_weights a c ->
  exists D, [/\ (0 < D)%N, (D <= n ^ (a * n))%N & denominator (transition G c) D].
Proof.
move=> irr [p [q H]]; exists (\prod_i q i)%N; split.
- by rewrite prodn_gt0 // => i; have [] := H i.
- rewrite mulnC expnM expnAC -expnM mulnC expnM.
  apply: (@leq_trans (\prod_(i < n) n ^ a)%N); last by rewrite prod_nat_const card_ord -!expnM mulnC.
  by apply: leq_prod => i _; have [] := H i.
move=> i j; have [ci qi _] := H i.
have q0 k : (q k)%:R != 0 :> R by rewrite pnatr_eq0 -lt0n; have [] := H k.
have [z Ez] : exists z : int, transition G c i j = z%:~R / (q i)%:R.
  rewrite transitionE // ci; case: (i == j); last case: (G i j).
  - exists ((q i)%:Z - (p i)%:Z * (degree G i)%:Z); rewrite rmorphB rmorphM /=; move: (q0 i).
    rewrite -[(q i)%:Z%:~R]/((q i)%:R) -[(p i)%:Z%:~R]/((p i)%:R) -[(degree G i)%:Z%:~R]/((degree G i)%:R).
    by move=> qz; field.
  - by exists (p i).
  - by exists 0; rewrite mul0r.
rewrite (bigD1 i) //=; set m := (\prod_(k | k != i) q k)%N.
exists (z * m%:Z); rewrite Ez natrM intrM; have m0 : m%:R != 0 :> R.
  by rewrite pnatr_eq0 -lt0n prodn_cond_gt0 // => k _; have [] := H k.
by rewrite -[m%:Z%:~R]/(m%:R); field; rewrite (q0 i) m0.
Qed.

Variables (a : nat) (G : nat -> rel 'I_n) (c : nat -> 'I_n -> R).
Hypothesis net : forall u, network (G u).
Hypothesis D : forall u, model_D (G u) (c u).
Hypothesis short : forall u, short_weights a (c u).
Let P u := transition (G u) (c u).

Lemma span_denominator s k : exists E, [/\ (0 < E)%N, (E <= n ^ (a * n * k))%N & denominator (span P s k) E].
Proof.
elim: k => [|k [E [E0 Ele HE]]]; first by exists 1%N; rewrite muln0 expn0; split=> //; exact: denominator1.
have [_ irr] := net (s + k)%N.
have [F [F0 Fle HF]] := transition_denominator irr (short (s + k)%N).
exists (F * E)%N; split; rewrite ?muln_gt0 ?F0 //; last exact: denominator_mul.
by rewrite mulnS expnD leq_mul.
Qed.

(* chazelle.lem2.2.bits: one denominator D <= n^(a n (t-s+1)) and numerators from 0 to D *)
Theorem lemma_2_2_bits s t : (s <= t)%N ->
  exists E, [/\ (0 < E)%N, (E <= n ^ (a * n * (t - s + 1)))%N &
    forall i j, exists k, (k <= E)%N /\ pprod P t s i j = k%:R / E%:R].
Proof.
move=> _; rewrite /pprod addn1; have [E [E0 Ele HE]] := span_denominator s (t - s).+1.
exists E; split=> // i j; have [z Ez] := HE i j.
have [A0 A1] := stochastic_span s (t - s).+1 (fun u => proj1 (model_D_stochastic (net u) (@D u))).
have e0 : 0 < E%:R :> R by rewrite ltr0n.
have zE : z%:~R = span P s (t - s).+1 i j * E%:R by rewrite Ez divfK // gt_eqF.
have z0 : 0 <= z by rewrite -(ler0z R) zE mulr_ge0 ?ler0n //; exact: A0.
exists `|z|%N; split; last by rewrite Ez; congr (_ / _); rewrite -{1}(gez0_abs z0).
have zR : `|z|%N%:R = z%:~R :> R by rewrite -{2}(gez0_abs z0).
rewrite -(ler_nat R) zR zE -[X in _ <= X]mul1r; apply: ler_wpmul2r; first by rewrite ler0n.
rewrite -(A1 i) (bigD1 j) //= ler_addl sumr_ge0 // => l _; exact: A0.
Qed.

(* chazelle.lem2.3 *)
Section State.
Variables (d b : nat) (x v : nat -> 'M[R]_(n, d)).
Hypothesis Hv : forall t, (0 < t)%N -> v t.+1 = P t *m v t.
Hypothesis Hx : forall t, x t.+1 = x t + v t.+1.
(* input: numerators and denominators at most n^b *)
Definition short_input (y : 'M[R]_(n, d)) := exists (z : 'I_n -> 'I_d -> int) (q : 'I_n -> 'I_d -> nat),
  forall i k, [/\ y i k = (z i k)%:~R / (q i k)%:R, (0 < q i k)%N, (q i k <= n ^ b)%N & (`|z i k| <= n ^ b)%N].
Hypothesis Hx0 : short_input (x 0%N).
Hypothesis Hv1 : short_input (v 1%N).

Lemma input_denominator y : short_input y ->
  exists Q, [/\ (0 < Q)%N, (Q <= n ^ (b * (n * d)))%N, denominator y Q & forall i k, `|y i k| <= (n ^ b)%:R].
Proof.
move=> [z [q H]]; exists (\prod_i \prod_k q i k)%N; split.
- by rewrite prodn_gt0 // => i; rewrite prodn_gt0 // => k; have [] := H i k.
- apply: (@leq_trans (\prod_(i < n) \prod_(k < d) n ^ b)%N).
    by apply: leq_prod => i _; apply: leq_prod => k _; have [] := H i k.
  by rewrite !prod_nat_const !card_ord -!expnM (mulnC n) mulnA.
- move=> i k; have [E q0 _ _] := H i k.
  rewrite (bigD1 i) //= (bigD1 k) //= -mulnA; set m := (X in (q i k * X)%N).
  have m0 : (0 < m)%N.
    rewrite muln_gt0; apply/andP; split; first by rewrite prodn_cond_gt0 // => k' _; have [] := H i k'.
    by rewrite prodn_cond_gt0 // => i' _; rewrite prodn_gt0 // => k'; have [] := H i' k'.
  exists (z i k * m%:Z); rewrite E natrM intrM -[m%:Z%:~R]/(m%:R).
  have qz : (q i k)%:R != 0 :> R by rewrite pnatr_eq0 -lt0n.
  have mz : m%:R != 0 :> R by rewrite pnatr_eq0 -lt0n.
  by field; rewrite qz mz.
move=> i k; have [-> q0 _ zb] := H i k; rewrite normrM normfV normr_nat.
rewrite ler_pdivr_mulr ?ltr0n // -intr_norm -abszE -natrM -[X in X <= _]/(`|z i k|%N%:R) ler_nat.
by apply: leq_trans zb _; rewrite leq_pmulr.
Qed.

Theorem lemma_2_3 t : (0 < t)%N -> (1 < n)%N ->
  exists E, [/\ (0 < E)%N, (E <= n ^ ((2 * b * d + a) * (t * n)))%N &
    forall i k, exists z w : int,
      [/\ v t i k = z%:~R / E%:R, x t i k = w%:~R / E%:R,
          (`|z| <= E * n ^ b)%N & (`|w| <= E * (n ^ b * t.+1))%N]].
Proof.
move=> t0 n1; have [Q [Q0 Qle Qx Bx]] := input_denominator Hx0.
have [Q' [Q'0 Q'le Qv Bv]] := input_denominator Hv1.
have SP u := proj1 (model_D_stochastic (net u) (@D u)).
(* one denominator for all spans up to k *)
have den k : exists F, [/\ (0 < F)%N, (F <= n ^ (a * n * k))%N &
    forall m, (m <= k)%N -> denominator (span P 1 m) F].
  elim: k => [|k [F [F0 Fle HF]]].
    by exists 1%N; split=> [//||m]; rewrite ?muln0 ?expn0 // leqn0 => /eqP->; exact: denominator1.
  have [_ irr] := net (1 + k)%N.
  have [F' [F'0 F'le HF']] := transition_denominator irr (short (1 + k)%N).
  exists (F' * F)%N; split; rewrite ?muln_gt0 ?F'0 //; first by rewrite mulnS expnD leq_mul.
  move=> m; rewrite leq_eqVlt => /orP[/eqP->|mk]; first by apply: denominator_mul => //; exact: HF.
  by apply: denominator_dvd => //; exact: HF.
have [F [F0 Fle HF]] := den t.-1.
have vE m : v m.+1 = span P 1 m *m v 1%N by apply: velocities_span.
have vden m : (m <= t.-1)%N -> denominator (v m.+1) (F * Q').
  by move=> mt; rewrite vE; apply: denominator_mul => //; exact: HF.
have vb m i k : `|v m.+1 i k| <= (n ^ b)%:R.
  have [A0 A1] := stochastic_span 1 m SP.
  move: Bv; set B := (n ^ b)%:R => BB.
  rewrite vE mxE; apply: le_trans (ler_norm_sum _ _ _) _.
  rewrite -[X in _ <= X]mul1r -(A1 i) mulr_suml; apply: ler_sum => l _.
  by rewrite normrM ger0_norm ?A0 //; apply: ler_wpmul2l; [exact: A0 | exact: BB].
have xden m : (m <= t)%N -> denominator (x m) (Q * (F * Q')).
  elim: m => [|m IH] mt; first by rewrite mulnC; apply: denominator_dvd; rewrite ?muln_gt0 ?F0.
  rewrite Hx; apply: denominatorD; first by apply: IH; exact: ltnW.
  apply: denominator_dvd; rewrite ?muln_gt0 ?F0 //; apply: vden; by rewrite -ltnS prednK.
have xb m i k : `|x m i k| <= (n ^ b * m.+1)%:R.
  elim: m => [|m IH]; first by rewrite muln1.
  rewrite Hx mxE; apply: le_trans (ler_norm_add _ _) _.
  by rewrite mulnS addnC natrD ler_add.
exists (Q * (F * Q'))%N; split; first by rewrite !muln_gt0 Q0 F0.
  apply: (@leq_trans (n ^ (b * (n * d)) * (n ^ (a * n * t.-1) * n ^ (b * (n * d))))%N).
    by rewrite !leq_mul.
  rewrite -!expnD leq_pexp2l ?(ltnW n1) //.
  case: (t) t0 => // u _ /=.
  have -> : ((2 * b * d + a) * (u.+1 * n) = 2 * b * d * (u.+1 * n) + a * n * u.+1)%N by lia.
  have h1 : (b * (n * d) + b * (n * d) <= 2 * b * d * (u.+1 * n))%N.
    have -> : (b * (n * d) + b * (n * d) = 2 * b * d * n)%N by lia.
    by rewrite leq_mul2l leq_pmull ?orbT.
  have h2 : (a * n * u <= a * n * u.+1)%N by rewrite leq_mul2l leqnSn orbT.
  by rewrite addnCA addnC leq_add.
have big0 : (0 < Q * (F * Q'))%N by rewrite !muln_gt0 Q0 F0.
have numer (y : R) (z : int) B : y = z%:~R / (Q * (F * Q'))%:R -> `|y| <= B%:R -> (`|z| <= Q * (F * Q') * B)%N.
  move=> -> ; rewrite normrM normfV normr_nat ler_pdivr_mulr ?ltr0n // -intr_norm -abszE -natrM -[X in X <= _]/(`|z|%N%:R) ler_nat.
  by rewrite mulnC.
have vd : denominator (v t) (Q * (F * Q')).
  apply: denominator_dvd; rewrite ?muln_gt0 ?F0 //; rewrite -(prednK t0); exact: vden.
move=> i k; have [z Ez] := vd i k; have [w Ew] := xden t (leqnn _) i k.
exists z, w; split=> //; first by apply: (numer _ _ _ Ez); rewrite -(prednK t0); exact: vb.
exact: (numer _ _ _ Ew).
Qed.
End State.
End Lengths.
