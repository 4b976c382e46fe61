(* Chazelle, Lemma 3.5: how long the entries of Gamma and of the limit configuration are.
     chazelle.lem3.5.
   Gamma = (I - 1 pi^T | 0)(I - P | 1)^-1.  With c_i = p_i/q_i the rows of (I - P | 1) times q_i are integers of at most
   q_i <= n^a, so the inverse is an adjugate over a determinant, which are at most n! n^(an); pi has the
   denominator sum_i q_i prod_(k /= i) p_k.  Any ordered field, no axioms. *)
Set Warnings "-notation-overridden,-ambiguous-paths".
From mathcomp Require Import all_ssreflect all_fingroup all_algebra.
From mathcomp Require Import ring zify.
From Flockproof Require Import chazelle_model chazelle_ergodicity chazelle_fixed chazelle_network chazelle_limits
  chazelle_products.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Import GRing.Theory Num.Theory Order.Theory.
Local Open Scope ring_scope.

Lemma fact_le_exp k : (k`! <= k ^ k)%N.
Proof.
elim: k => // k IH; rewrite factS expnS leq_mul2l /=; apply: leq_trans IH _.
by case: k => // k; rewrite leq_exp2r.
Qed.

(* Leibniz: a determinant with entries of at most q *)
Lemma det_le (R : realFieldType) k (M : 'M[R]_k) q : (forall i j, `|M i j| <= q) -> `|\det M| <= k`!%:R * q ^+ k.
Proof.
move=> H; rewrite /determinant; apply: le_trans (ler_norm_sum _ _ _) _.
have -> : k`!%:R * q ^+ k = \sum_(s : 'S_k) q ^+ k.
  by rewrite sumr_const (_ : #|_| = k`!) ?mulr_natl // -card_Sn; apply: eq_card.
apply: ler_sum => s _; rewrite normrM normrX normrN1 expr1n mul1r normr_prod.
rewrite -[X in _ <= _ ^+ X]card_ord -prodr_const; apply: ler_prod => i _; by rewrite normr_ge0 H.
Qed.
Lemma adj_le (R : realFieldType) k (M : 'M[R]_k.+1) q : (forall i j, `|M i j| <= q) ->
  forall i j, `|\adj M i j| <= k`!%:R * q ^+ k.
Proof.
move=> H i j; rewrite mxE /cofactor normrM normrX normrN1 expr1n mul1r.
by apply: det_le => x y; rewrite !mxE.
Qed.

Section Bits.
Variables (R : realFieldType) (m : nat).
Notation n := m.+1.
Variables (G : rel 'I_n) (c : 'I_n -> R) (a : nat).
Hypothesis net : network G.
Hypothesis MD : model_D G c.
Hypothesis conn : forall i j, connect G i j.
Hypothesis c0 : forall i, 0 < c i.
Hypothesis m0 : (0 < m)%N.
Variables p q : 'I_n -> nat.
Hypothesis pq : forall i, [/\ c i = (p i)%:R / (q i)%:R, (0 < q i)%N & (q i <= n ^ a)%N].
Notation P := (transition G c).

Let q0 i : (0 < q i)%N. Proof. by have [] := pq i. Qed.
Let qn i : (q i <= n ^ a)%N. Proof. by have [] := pq i. Qed.
Let qR i : (q i)%:R != 0 :> R. Proof. by rewrite pnatr_eq0 -lt0n. Qed.
Let cq i : c i * (q i)%:R = (p i)%:R. Proof. by have [-> _ _] := pq i; rewrite divfK. Qed.
Let p0 i : (0 < p i)%N.
Proof. by rewrite -(ltr_nat R) -cq mulr_gt0 // ltr0n. Qed.

Lemma degree_gt0 i : (0 < degree G i)%N.
Proof.
have [j ij] : exists j : 'I_n, i != j.
  exists (if i == 0 then ord_max else 0); case: (eqVneq i 0) => [->|//].
  by rewrite -val_eqE /= eq_sym -lt0n.
have /connectP[[|k r] /=] := conn i j; first by move=> _ E; rewrite E eqxx in ij.
by case/andP=> ik _ _; exact: edge_degree ik.
Qed.
Lemma p_degree i : (p i * degree G i <= q i)%N.
Proof.
have /andP[_] := MD (degree_gt0 i); rewrite -(ltr_pmul2r (x := (q i)%:R)) ?ltr0n //.
by rewrite mul1r mulrAC cq -natrM ltr_nat => /ltnW.
Qed.
Lemma p_le i : (p i <= q i)%N.
Proof. by apply: leq_trans (p_degree i); rewrite leq_pmulr ?degree_gt0. Qed.

(* ---- (I - P | 1), times q_i in row i ---- *)
Definition scaled : 'M[int]_n := \matrix_(i, j)
  (if j == ord_max then (q i)%:Z else if i == j then (p i * degree G i)%:Z else if G i j then - (p i)%:Z else 0).
Notation B := (last_col (1%:M - P) (ones R m)).
Notation S := (map_mx intr scaled : 'M[R]_n).
Lemma borderE i j : B i j = if j == ord_max then 1 else (i == j)%:R - P i j.
Proof.
rewrite mxE; case: ifP => _; first by rewrite mxE.
by rewrite mxE [(1%:M : 'M[R]_n) i j]mxE [(- P) i j]mxE.
Qed.
Lemma scaledE : S = diag_mx (\row_i (q i)%:R) *m B.
Proof.
have [_ irr] := net; apply/matrixP=> i j; rewrite [LHS]mxE [scaled i j]mxE mul_diag_mx [RHS]mxE [(\row__ _) _ i]mxE borderE.
case: (j == ord_max); first by rewrite mulr1.
rewrite transitionE //; case: (i == j); first by rewrite opprB addrC subrK mulrA [_ * c i]mulrC cq -natrM.
case: (G i j); last by rewrite subr0 mulr0.
by rewrite sub0r mulrN mulrC cq mulrNz.
Qed.
Lemma scaled_le i j : `|S i j| <= (n ^ a)%:R.
Proof.
rewrite mxE mxE; case: (j == ord_max); first by rewrite normr_nat ler_nat.
case: (i == j); first by rewrite normr_nat ler_nat (leq_trans (p_degree i)).
case: (G i j); last by rewrite normr0 ler0n.
by rewrite mulrNz normrN normr_nat ler_nat (leq_trans (p_le i)).
Qed.
Lemma B_unit : B \in unitmx. Proof. exact: (bordered_unit net MD conn c0). Qed.
Definition D : int := \det scaled.
Lemma det_S : \det S = D%:~R. Proof. by rewrite det_map_mx. Qed.
Lemma D_neq0 : D != 0.
Proof.
rewrite -(intr_eq0 R) -det_S scaledE det_mulmx mulf_neq0 //; last by have := B_unit; rewrite unitmxE unitfE.
rewrite det_diag prodf_seq_neq0; apply/allP => i _; by rewrite mxE qR.
Qed.
Lemma D_le : (`|D| <= n ^ (a.+1 * n))%N.
Proof.
rewrite -(ler_nat R) -[`|D|%N%:R]/(`|D|%N%:Z%:~R) abszE intr_norm -det_S.
apply: le_trans (det_le scaled_le) _; rewrite -natrX -natrM ler_nat mulSn expnD -expnM.
by rewrite leq_mul // fact_le_exp.
Qed.
Lemma inverseE i j : invmx B i j = (\adj scaled i j * (q j)%:Z)%:~R / D%:~R.
Proof.
have D0 : D%:~R != 0 :> R by rewrite intr_eq0 D_neq0.
pose X := (D%:~R)^-1 *: (\adj S *m diag_mx (\row_i (q i)%:R)).
have XB : X *m B = 1%:M.
  by rewrite /X -scalemxAl -mulmxA -scaledE mul_adj_mx det_S scale_scalar_mx mulVf.
have -> : invmx B = X by have := mulmxK B_unit X; rewrite XB mul1mx.
rewrite mxE mul_mx_diag mxE -map_mx_adj [map_mx _ _ i j]mxE [(\row__ _) 0 j]mxE intrM mulrC; by [].
Qed.
Lemma inverse_denominator : denominator (invmx B) `|D|.
Proof.
move=> i j; exists (sgz D * (\adj scaled i j * (q j)%:Z)); rewrite inverseE.
have D0 : D%:~R != 0 :> R by rewrite intr_eq0 D_neq0.
have E : (`|D|%N%:R : R) = (sgz D)%:~R * D%:~R.
  by rewrite -[`|D|%N%:R]/(`|D|%N%:Z%:~R) abszE -intrM; congr (_%:~R); rewrite -normrEsg.
have s0 : (sgz D)%:~R != 0 :> R by rewrite intr_eq0 sgz_eq0 D_neq0.
by rewrite E [X in _ = X / _]intrM -mulf_div divff // mul1r.
Qed.
Lemma inverse_le i j : `|invmx B i j| <= (n ^ (a.+1 * n + a))%:R.
Proof.
rewrite inverseE normrM normfV -[X in _ <= X]mulr1; apply: ler_pmul; rewrite ?invr_ge0 //.
  rewrite intrM normrM expnD natrM; apply: ler_pmul => //; last by rewrite normr_nat ler_nat.
  have -> : (\adj scaled i j)%:~R = (\adj S) i j :> R by rewrite -map_mx_adj [RHS]mxE.
  apply: le_trans (adj_le scaled_le _ _) _; rewrite -natrX -natrM ler_nat mulSn expnD -expnM.
  have h : (m ^ m <= n ^ n)%N by apply: (@leq_trans (n ^ m)); [rewrite leq_exp2r | rewrite leq_pexp2l].
  by apply: leq_mul; [exact: leq_trans (fact_le_exp m) h | rewrite leq_pexp2l // leq_mul2l leqnSn orbT].
rewrite invf_le1 ?normr_gt0 ?intr_eq0 ?D_neq0 // -intr_norm -[1]/(1%:~R) ler_int.
by rewrite -abszE; have := D_neq0; rewrite -absz_gt0.
Qed.

(* ---- pi ---- *)
Definition W (i : 'I_n) : nat := (q i * \prod_(k | k != i) p k)%N.
Definition total : nat := (\sum_i W i)%N.
Lemma total_gt0 : (0 < total)%N.
Proof. by rewrite /total (bigD1 0) //= ltn_addr // muln_gt0 q0 prodn_cond_gt0 // => k _; exact: p0. Qed.
Lemma statE j : stat c j = (W j)%:R / total%:R.
Proof.
have pR k : (p k)%:R != 0 :> R by rewrite pnatr_eq0 -lt0n.
have E k : (c k)^-1 = (W k)%:R / (\prod_i p i)%N%:R.
  have [-> _ _] := pq k; rewrite invf_div (bigD1 k) //= !natrM; set w := (\prod_(_ | _) _)%N.
  have w0 : w%:R != 0 :> R by rewrite pnatr_eq0 -lt0n prodn_cond_gt0 // => l _; exact: p0.
  by field; rewrite pR w0.
have A0 : (\prod_i p i)%N%:R != 0 :> R by rewrite pnatr_eq0 -lt0n prodn_gt0.
have T0 : total%:R != 0 :> R by rewrite pnatr_eq0 -lt0n total_gt0.
rewrite /stat /trace (eq_bigr _ (fun k _ => E k)) -mulr_suml -natr_sum -/total E.
by field; rewrite T0 A0.
Qed.
Lemma total_le : (total <= n ^ (a * n + 1))%N.
Proof.
apply: (@leq_trans (\sum_(i < n) n ^ (a * n))%N); last by rewrite sum_nat_const card_ord addn1 expnS.
apply: leq_sum => i _; apply: (@leq_trans (\prod_(k < n) n ^ a)%N); last by rewrite prod_nat_const card_ord -expnM.
rewrite /W [X in (_ <= X)%N](bigD1 i) //=; apply: leq_mul; first exact: qn.
by apply: leq_prod => k _; exact: leq_trans (p_le k) (qn k).
Qed.
Lemma left_denominator : denominator (1%:M - rank1 c : 'M[R]_n) total.
Proof.
move=> i j; exists ((i == j)%:Z * total%:Z - (W j)%:Z).
have T0 : total%:R != 0 :> R by rewrite pnatr_eq0 -lt0n total_gt0.
rewrite mxE [(1%:M : 'M[R]_n) i j]mxE [(- rank1 c) i j]mxE rank1E statE rmorphB rmorphM /=.
by rewrite mulrBl mulfK //; case: (i == j).
Qed.
Lemma left_le i j : `|(1%:M - rank1 c : 'M[R]_n) i j| <= 1.
Proof.
rewrite mxE [(1%:M : 'M[R]_n) i j]mxE [(- rank1 c) i j]mxE rank1E.
have s0 := ltW (stat_gt0 c0 j); have s1 : stat c j <= 1.
  by rewrite -(stat_sum c0 j) [X in _ <= X](bigD1 j) //= ler_addl sumr_ge0 // => k _; exact: ltW (stat_gt0 c0 k).
case: (i == j); last by rewrite sub0r normrN ger0_norm.
by rewrite ger0_norm ?subr_ge0 // ler_subl_addr ler_addl.
Qed.

(* ---- Gamma ---- *)
Lemma Gamma_denominator : denominator (Gamma G c) (total * `|D|).
Proof.
apply: denominator_mul inverse_denominator => i j; rewrite mxE; case: ifP => _; last exact: left_denominator.
by exists 0; rewrite mxE mul0r.
Qed.
Lemma Gamma_le i j : `|Gamma G c i j| <= (n ^ (a.+1 * n + a + 1))%:R.
Proof.
rewrite mxE; apply: le_trans (ler_norm_sum _ _ _) _.
apply: (@le_trans _ _ (\sum_(k < n) (n ^ (a.+1 * n + a))%:R)); last first.
  by rewrite sumr_const card_ord -[_ *+ n]mulr_natl -natrM addn1 expnS.
apply: ler_sum => k _; rewrite normrM -[X in _ <= X]mul1r; apply: ler_pmul => //; last exact: inverse_le.
by rewrite mxE; case: ifP => _; [rewrite mxE normr0 ler01 | exact: left_le].
Qed.
Lemma both_le : (total * `|D| <= n ^ ((2 * a + 1) * n + 1))%N.
Proof.
apply: leq_trans (leq_mul total_le D_le) _; rewrite -expnD leq_pexp2l //.
by rewrite mulnDl mul1n mulSn -mulnA mul2n -addnn; lia.
Qed.
Lemma both_gt0 : (0 < total * `|D|)%N. Proof. by rewrite muln_gt0 total_gt0 absz_gt0 D_neq0. Qed.

(* a number with a denominator and a bound *)
Lemma numerator (y : R) E M : (0 < E)%N -> (exists z : int, y = z%:~R / E%:R) -> `|y| <= M%:R ->
  exists z : int, y = z%:~R / E%:R /\ (`|z| <= E * M)%N.
Proof.
move=> E0 [z Ez] yM; exists z; split=> //; move: yM.
rewrite Ez normrM normfV normr_nat ler_pdivr_mulr ?ltr0n // -natrM mulnC -intr_norm -abszE.
by rewrite -[X in X <= _]/(`|z|%N%:R) ler_nat.
Qed.

Lemma bits : exists E, [/\ (0 < E)%N, (E <= n ^ ((2 * a + 1) * n + 1))%N &
  forall i j, exists z : int, Gamma G c i j = z%:~R / E%:R /\ (`|z| <= E * n ^ (a.+1 * n + a + 1))%N].
Proof.
exists (total * `|D|)%N; split; [exact: both_gt0 | exact: both_le | move=> i j].
by apply: numerator; [exact: both_gt0 | exact: Gamma_denominator | exact: Gamma_le].
Qed.

Variables (b d : nat) (x v : 'M[R]_(n, d)).
Hypothesis Hx : short_input b x.
Hypothesis Hv : short_input b v.
Lemma limit_bits : exists E, [/\ (0 < E)%N, (E <= n ^ ((2 * a + 1) * n + 1 + 2 * b * n * d))%N &
  forall i k, exists z : int, ((1%:M - rank1 c) *m x + Gamma G c *m v) i k = z%:~R / E%:R /\
    (`|z| <= E * n ^ (a.+1 * n + a + b + 3))%N].
Proof.
have [X [X0 Xle HX Xb]] := input_denominator Hx; have [Y [Y0 Yle HY Yb]] := input_denominator Hv.
pose F := (total * `|D|)%N; have F0 : (0 < F)%N := both_gt0.
have EXY0 : (0 < F * (X * Y))%N by rewrite muln_gt0 F0 muln_gt0 X0 Y0.
exists (F * (X * Y))%N; split; first exact: EXY0.
  apply: leq_trans (leq_mul both_le (leq_mul Xle Yle)) _; rewrite -!expnD leq_pexp2l //.
  by rewrite leq_add2l addnn -mul2n -!mulnA.
move=> i k; apply: numerator; first exact: EXY0.
  have HG : denominator (Gamma G c *m v) (F * Y) by exact: (denominator_mul Gamma_denominator HY).
  have HL : denominator ((1%:M - rank1 c) *m x) (total * X) by exact: (denominator_mul left_denominator HX).
  have dY : (0 < `|D| * Y)%N by rewrite muln_gt0 Y0 absz_gt0 D_neq0.
  have -> : (F * (X * Y) = (`|D| * Y) * (total * X))%N by rewrite /F; lia.
  apply: denominatorD; first by apply: denominator_dvd => //; rewrite muln_gt0 total_gt0.
  have -> : ((`|D| * Y) * (total * X) = X * (F * Y))%N by rewrite /F; lia.
  by apply: denominator_dvd => //; rewrite muln_gt0 F0.
rewrite mxE; apply: le_trans (ler_norm_add _ _) _.
have part (A : 'M[R]_n) (y : 'M[R]_(n, d)) M : (forall i j, `|A i j| <= M%:R) -> (forall i k, `|y i k| <= (n ^ b)%:R) ->
    `|(A *m y) i k| <= (M * n ^ b.+1)%:R.
  move=> HA Hy; rewrite mxE; apply: le_trans (ler_norm_sum _ _ _) _.
  apply: (@le_trans _ _ (\sum_(l < n) (M * n ^ b)%:R)).
    by apply: ler_sum => l _; rewrite normrM natrM; apply: ler_pmul.
  by rewrite sumr_const card_ord -[_ *+ n]mulr_natr -natrM -mulnA -expnSr.
apply: le_trans (ler_add (part _ _ 1%N left_le Xb) (part _ _ _ Gamma_le Yb)) _.
rewrite -natrD ler_nat mul1n -expnD; apply: (@leq_trans (2 * n ^ (a.+1 * n + a + 1 + b.+1))%N).
  by rewrite mul2n -addnn leq_add2r leq_pexp2l // leq_addl.
have -> : (a.+1 * n + a + b + 3 = (a.+1 * n + a + 1 + b.+1).+1)%N by lia.
by rewrite expnS leq_mul2r; apply/orP; right.
Qed.
End Bits.

Lemma one_bird (R : realFieldType) m (G : rel 'I_m.+1) (c : 'I_m.+1 -> R) : (forall i, 0 < c i) -> m = 0%N ->
  Gamma G c = 0 /\ 1%:M - rank1 c = 0.
Proof.
move=> c0 m0; subst m; split; apply/matrixP=> i j.
  have Z k : last_col (1%:M - rank1 c) 0 i k = 0 by rewrite mxE (_ : k == ord_max) ?mxE // (ord1 k) (ord1 ord_max).
  by rewrite mxE big1 ?mxE // => k _; rewrite Z mul0r.
rewrite mxE [(1%:M : 'M[R]_1) i j]mxE [(- rank1 c) i j]mxE rank1E [RHS]mxE !ord1 eqxx.
by have := stat_sum c0 0; rewrite big_ord1 => ->; rewrite subrr.
Qed.

(* chazelle.lem3.5: with c_i and the input of O(log n) bits *)
Theorem lemma_3_5 (R : realFieldType) m a b d (G : rel 'I_m.+1) (c : 'I_m.+1 -> R) (x v : 'M[R]_(m.+1, d)) :
  network G -> model_D G c -> (forall i j, connect G i j) -> (forall i, 0 < c i) -> short_weights a c ->
  let n := m.+1 in
  (exists E, [/\ (0 < E)%N, (E <= n ^ ((2 * a + 1) * n + 1))%N &
    forall i j, exists z : int, Gamma G c i j = z%:~R / E%:R /\ (`|z| <= E * n ^ (a.+1 * n + a + 1))%N]) /\
  (short_input b x -> short_input b v ->
   exists E, [/\ (0 < E)%N, (E <= n ^ ((2 * a + 1) * n + 1 + 2 * b * n * d))%N &
    forall i k, exists z : int, ((1%:M - rank1 c) *m x + Gamma G c *m v) i k = z%:~R / E%:R /\
      (`|z| <= E * n ^ (a.+1 * n + a + b + 3))%N]).
Proof.
move=> net MD conn c0 [p [q pq]] n; have [m0|m0] := posnP m; last first.
  split; first exact: (bits net MD conn c0 m0 pq).
  by move=> Hx Hv; exact: (limit_bits net MD conn c0 m0 pq Hx Hv).
have [G0 L0] := one_bird G c0 m0; have zero (y : R) M : y = 0 -> exists z : int, y = z%:~R / 1%N%:R /\ (`|z| <= 1 * M)%N.
  by move=> ->; exists 0; rewrite mul0r.
split=> [|_ _]; exists 1%N; split; rewrite ?expn_gt0 // => i j; apply: zero.
  by rewrite G0 mxE.
by rewrite G0 L0 !mul0mx addr0 mxE.
Qed.
