(* Chazelle, section 2 (Ergodicity) and (2.3): the coefficients tau_1 and tau_2, Lemma 2.4, the
   display before (3.6), Lemma 2.1 and the bound on velocities.
     chazelle.tau1, chazelle.lem2.4, chazelle.tau2sqrt2, chazelle.lem2.1, chazelle.eq2.3.
   tau_1 over any ordered field; Lemma 2.4 for every norm N; the Euclidean norm over any real closed
   field (square roots exist there; the real numbers are one).  No axioms. *)
Set Warnings "-notation-overridden,-ambiguous-paths".
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import ring.
From Flockproof Require Import chazelle_model.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Import GRing.Theory Num.Theory Order.Theory.
Local Open Scope ring_scope.

(* ---- maxima and minima over a finite type ---- *)
Section Extrema.
Variable R : realFieldType.
Lemma max_ub (I : finType) (F : I -> R) i : F i <= \big[Num.max/0]_i F i.
Proof.
have: i \in index_enum I by apply: mem_index_enum.
elim: (index_enum I) => // a s IH; rewrite in_cons big_cons le_maxr.
by case/orP => [/eqP->|/IH->]; rewrite ?lexx ?orbT.
Qed.
Lemma max_le (I : finType) (F : I -> R) c :
  0 <= c -> (forall i, F i <= c) -> \big[Num.max/0]_i F i <= c.
Proof. by move=> c0 H; elim/big_ind: _ => // a b ac bc; rewrite le_maxl ac bc. Qed.
Lemma max_ge0 (I : finType) (F : I -> R) : 0 <= \big[Num.max/0]_i F i.
Proof. by elim/big_rec: _ => // i x _ x0; rewrite le_maxr x0 orbT. Qed.
Lemma min_lb (I : finType) (F : I -> R) i : \big[Num.min/1]_i F i <= F i.
Proof.
have: i \in index_enum I by apply: mem_index_enum.
elim: (index_enum I) => // a s IH; rewrite in_cons big_cons le_minl.
by case/orP => [/eqP->|/IH->]; rewrite ?lexx ?orbT.
Qed.
(* 1 - max of 1 - F is the minimum of F, for F <= 1 *)
Lemma one_minus_max (I : finType) (F : I -> R) :
  \big[Num.max/0]_i (1 - F i) = 1 - \big[Num.min/1]_i F i.
Proof.
elim/big_rec2: _ => [|i x y _ ->]; first by rewrite subrr.
by rewrite /Num.max /Num.min ltr_add2l ltr_opp2; case: ltgtP => // ->.
Qed.
End Extrema.

Section Tau1.
Variable R : realFieldType.
Implicit Types (m n p : nat).

(* half the l1-distance of two rows; half the l1-diameter of the rows *)
Definition dist1 m n (A : 'M[R]_(m, n)) (i j : 'I_m) : R := 2%:R^-1 * \sum_k `|A i k - A j k|.
Definition tau1 m n (A : 'M[R]_(m, n)) : R := \big[Num.max/0]_(ij : 'I_m * 'I_m) dist1 A ij.1 ij.2.
Definition overlap m n (A : 'M[R]_(m, n)) (i j : 'I_m) : R := \sum_k Num.min (A i k) (A j k).

Lemma dist1_overlap m n (A : 'M[R]_(m, n)) i j : stochastic A -> dist1 A i j = 1 - overlap A i j.
Proof.
case=> _ sA; rewrite /dist1 /overlap.
have E k : `|A i k - A j k| = A i k + A j k - (Num.min (A i k) (A j k)) *+ 2.
  case: (leP (A i k) (A j k)) => H.
    by rewrite ler0_norm ?subr_le0 //; ring.
  by rewrite gtr0_norm ?subr_gt0 //; ring.
rewrite (eq_bigr _ (fun k _ => E k)) !big_split /= !sA sumrN sumrMnl.
by move: (\sum_k Num.min _ _) => S; field.
Qed.

Lemma tau1_ub m n (A : 'M[R]_(m, n)) i j : dist1 A i j <= tau1 A.
Proof. exact: (max_ub (fun ij : 'I_m * 'I_m => dist1 A ij.1 ij.2) (i, j)). Qed.
Lemma tau1_le m n (A : 'M[R]_(m, n)) c : 0 <= c -> (forall i j, dist1 A i j <= c) -> tau1 A <= c.
Proof. by move=> c0 H; apply: max_le. Qed.
Lemma tau1_ge0 m n (A : 'M[R]_(m, n)) : 0 <= tau1 A.
Proof. exact: max_ge0. Qed.
Lemma tau1_le1 m n (A : 'M[R]_(m, n)) : stochastic A -> tau1 A <= 1.
Proof.
move=> SA; apply: tau1_le; rewrite ?ler01 // => i j.
rewrite dist1_overlap // ler_subl_addr ler_addl sumr_ge0 // => k _.
by case: SA => A0 _; rewrite le_minr !A0.
Qed.

(* chazelle.tau1 *)
Theorem tau1_overlap m n (A : 'M[R]_(m, n)) : stochastic A ->
  0 <= tau1 A /\
  tau1 A = 1 - (\big[Num.min/1]_(ij : 'I_m * 'I_m) \sum_k Num.min (A ij.1 k) (A ij.2 k)) /\
  tau1 A <= 1.
Proof.
move=> SA; split; [exact: tau1_ge0 | split; last exact: tau1_le1].
rewrite -one_minus_max /tau1; apply: eq_bigr => ij _; exact: dist1_overlap.
Qed.

(* a common column of entries at least b brings tau_1 down to 1 - b *)
Lemma tau1_column m n (A : 'M[R]_(m, n)) k b : stochastic A -> 0 <= b <= 1 ->
  (forall i, b <= A i k) -> tau1 A <= 1 - b.
Proof.
move=> SA /andP[b0 b1] H; apply: tau1_le; rewrite ?subr_ge0 // => i j.
rewrite dist1_overlap // ler_add2l ler_opp2 /overlap (bigD1 k) //= -[b]addr0 ler_add //.
  by rewrite le_minr !H.
by apply: sumr_ge0 => l _; case: SA => A0 _; rewrite le_minr !A0.
Qed.

Lemma stochastic_mul m n p (A : 'M[R]_(m, n)) (B : 'M[R]_(n, p)) :
  stochastic A -> stochastic B -> stochastic (A *m B).
Proof.
move=> [A0 sA] [B0 sB]; split=> [i k|i].
  by rewrite mxE sumr_ge0 // => l _; rewrite mulr_ge0.
rewrite (eq_bigr (fun k => \sum_l A i l * B l k)); last by move=> k _; rewrite mxE.
rewrite exchange_big /= -[RHS](sA i); apply: eq_bigr => l _.
by rewrite -mulr_sumr sB mulr1.
Qed.
Lemma stochastic1 n : stochastic (1%:M : 'M[R]_n).
Proof.
split=> [i k|i]; first by rewrite mxE ler0n.
by rewrite (bigD1 i) //= mxE eqxx big1 ?addr0 // => k ki; rewrite mxE eq_sym (negbTE ki).
Qed.
Lemma stochastic_exp n (A : 'M[R]_n.+1) s : stochastic A -> stochastic (A ^+ s).
Proof.
move=> SA; elim: s => [|s IH]; first by rewrite expr0; exact: stochastic1.
by rewrite exprS; exact: stochastic_mul.
Qed.
Lemma stochastic_span n (P : nat -> 'M[R]_n) s k : (forall t, stochastic (P t)) -> stochastic (span P s k).
Proof. by move=> H; elim: k => [|k IH] /=; [exact: stochastic1 | exact: stochastic_mul]. Qed.

(* ---- Lemma 2.4 for every norm ---- *)
Section EveryNorm.
Variables (p : nat) (N : 'rV[R]_p -> R).
Hypothesis N0 : N 0 = 0.
Hypothesis NZ : forall a x, N (a *: x) = `|a| * N x.
Hypothesis ND : forall x y, N (x + y) <= N x + N y.

Definition diameter m (A : 'M[R]_(m, p)) : R :=
  \big[Num.max/0]_(ij : 'I_m * 'I_m) N (row ij.1 A - row ij.2 A).

Lemma diameter_ub m (A : 'M[R]_(m, p)) i j : N (row i A - row j A) <= diameter A.
Proof. exact: (max_ub (fun ij : 'I_m * 'I_m => N (row ij.1 A - row ij.2 A)) (i, j)). Qed.

Lemma norm_sum (I : finType) (F : I -> 'rV[R]_p) : N (\sum_i F i) <= \sum_i N (F i).
Proof.
elim/big_rec2: _ => [|i x y _ H]; first by rewrite N0.
exact: le_trans (ND _ _) (ler_add _ H).
Qed.

(* a zero-sum combination of the rows of B: at most half its weight times the diameter *)
Lemma zero_sum_diameter n (B : 'M[R]_(n, p)) (u : 'I_n -> R) : \sum_l u l = 0 ->
  N (\sum_l u l *: row l B) <= 2%:R^-1 * (\sum_l `|u l|) * diameter B.
Proof.
move=> u0.
pose a l := Num.max (u l) 0; pose b l := Num.max (- u l) 0.
have a0 l : 0 <= a l by rewrite /a le_maxr lexx orbT.
have b0 l : 0 <= b l by rewrite /b le_maxr lexx orbT.
have uab l : u l = a l - b l.
  rewrite /a /b; case: (leP (u l) 0) => H.
    by rewrite max_l ?oppr_ge0 // sub0r opprK.
  by rewrite max_r ?oppr_le0 1?ltW // subr0.
have nab l : `|u l| = a l + b l.
  rewrite /a /b; case: (leP (u l) 0) => H.
    by rewrite max_l ?oppr_ge0 // add0r ler0_norm.
  by rewrite max_r ?oppr_le0 1?ltW // addr0 gtr0_norm.
pose s := \sum_l a l.
have sb : \sum_l b l = s.
  apply/eqP; rewrite eq_sym -subr_eq0 /s -sumrB; apply/eqP; rewrite -[RHS]u0.
  by apply: eq_bigr => l _; rewrite uab.
have nu : 2%:R^-1 * (\sum_l `|u l|) = s.
  by rewrite (eq_bigr _ (fun l _ => nab l)) big_split /= sb -/s; field.
have s0 : 0 <= s by apply: sumr_ge0.
rewrite nu; have [s1|sn0] := eqVneq s 0.
  have uz l : u l = 0.
    have az : a l = 0.
      by have /(_ (fun l _ => a0 l)) := @psumr_eq0P _ _ predT a; move/(_ s1 l isT).
    have bz : b l = 0.
      have /(_ (fun l _ => b0 l)) := @psumr_eq0P _ _ predT b.
      by move/(_ (etrans sb s1) l isT).
    by rewrite uab az bz subr0.
  rewrite s1 mul0r big1 ?N0 // => l _; by rewrite uz scale0r.
have sgt : 0 < s by rewrite lt_def sn0.
have key : s *: (\sum_l u l *: row l B) =
   \sum_l \sum_l' (a l * b l') *: (row l B - row l' B).
  have -> : \sum_l u l *: row l B = \sum_l a l *: row l B - \sum_l b l *: row l B.
    by rewrite -sumrB; apply: eq_bigr => l _; rewrite uab scalerBl.
  have -> : \sum_l \sum_l' (a l * b l') *: (row l B - row l' B)
      = (\sum_l \sum_l' (a l * b l') *: row l B) - \sum_l \sum_l' (a l * b l') *: row l' B.
    rewrite -sumrB; apply: eq_bigr => l _; rewrite -sumrB; apply: eq_bigr => l' _.
    by rewrite scalerBr.
  rewrite scalerBr; congr (_ - _).
    rewrite scaler_sumr; apply: eq_bigr => l _.
    by rewrite -scaler_suml -mulr_sumr sb scalerA mulrC.
  rewrite [RHS]exchange_big /= scaler_sumr; apply: eq_bigr => l' _.
  by rewrite -scaler_suml -mulr_suml scalerA.
rewrite -(ler_pmul2l sgt) -{1}(gtr0_norm sgt) -NZ key.
apply: (@le_trans _ _ (\sum_l \sum_l' a l * b l' * diameter B)).
  apply: le_trans (norm_sum _) _; apply: ler_sum => l _.
  apply: le_trans (norm_sum _) _; apply: ler_sum => l' _.
  rewrite NZ ger0_norm ?mulr_ge0 //; apply: ler_wpmul2l; [exact: mulr_ge0 | exact: diameter_ub].
rewrite (eq_bigr (fun l => a l * (s * diameter B))) => [|l _]; last first.
  by rewrite -mulr_suml -mulr_sumr sb mulrA.
by rewrite -mulr_suml.
Qed.

Theorem diameter_mul m n (A : 'M[R]_(m, n)) (B : 'M[R]_(n, p)) : stochastic A ->
  diameter (A *m B) <= tau1 A * diameter B.
Proof.
case=> _ sA; have d0 : 0 <= diameter B by exact: max_ge0.
apply: max_le => [|[i j] /=]; first by rewrite mulr_ge0 ?tau1_ge0.
have -> : row i (A *m B) - row j (A *m B) = \sum_l (A i l - A j l) *: row l B.
  rewrite !row_mul !mulmx_sum_row -sumrB; apply: eq_bigr => l _.
  by rewrite !mxE scalerBl.
apply: le_trans (zero_sum_diameter _ _) _; first by rewrite sumrB !sA subrr.
by apply: ler_wpmul2r => //; exact: (tau1_ub A i j).
Qed.
End EveryNorm.

(* tau_1 itself is (half) the diameter for the l1-norm *)
Theorem tau1_mul m n p (A : 'M[R]_(m, n)) (B : 'M[R]_(n, p)) :
  stochastic A -> tau1 (A *m B) <= tau1 A * tau1 B.
Proof.
move=> SA; pose N1 (x : 'rV[R]_p) := 2%:R^-1 * \sum_k `|x 0 k|.
have E q (X : 'M[R]_(q, p)) : tau1 X = diameter N1 X.
  apply: eq_bigr => ij _; congr (_ * _); apply: eq_bigr => k _; by rewrite !mxE.
have h0 : 0 <= 2%:R^-1 :> R by rewrite invr_ge0 ler0n.
rewrite !E; apply: diameter_mul => //.
- by rewrite /N1 big1 ?mulr0 // => k _; rewrite mxE normr0.
- move=> a x; rewrite /N1 mulrCA; congr (_ * _); rewrite mulr_sumr.
  by apply: eq_bigr => k _; rewrite mxE normrM.
move=> x y; rewrite /N1 -mulrDr; apply: ler_wpmul2l => //; rewrite -big_split /=.
by apply: ler_sum => k _; rewrite mxE; exact: ler_norm_add.
Qed.
End Tau1.

(* ---- the Euclidean norm ---- *)
Section Euclid.
Variable R : rcfType.

Definition dot p (x y : 'rV[R]_p) : R := \sum_k x 0 k * y 0 k.
Definition norm2 p (x : 'rV[R]_p) : R := Num.sqrt (\sum_k x 0 k ^+ 2).
Lemma norm2_ge0 p (x : 'rV[R]_p) : 0 <= norm2 x. Proof. exact: sqrtr_ge0. Qed.
Lemma sumsq_ge0 p (x : 'rV[R]_p) : 0 <= \sum_k x 0 k ^+ 2.
Proof. by apply: sumr_ge0 => k _; rewrite sqr_ge0. Qed.
Lemma norm2_sqr p (x : 'rV[R]_p) : norm2 x ^+ 2 = \sum_k x 0 k ^+ 2.
Proof. by rewrite /norm2 sqr_sqrtr ?sumsq_ge0. Qed.
Lemma norm2_0 p : norm2 (0 : 'rV[R]_p) = 0.
Proof. by rewrite /norm2 big1 ?sqrtr0 // => k _; rewrite mxE expr0n. Qed.
Lemma norm2Z p a (x : 'rV[R]_p) : norm2 (a *: x) = `|a| * norm2 x.
Proof.
rewrite /norm2 (eq_bigr (fun k => a ^+ 2 * x 0 k ^+ 2)) => [|k _]; last by rewrite mxE exprMn.
by rewrite -mulr_sumr sqrtrM ?sqr_ge0 // sqrtr_sqr.
Qed.

Lemma cauchy_schwarz p (x y : 'rV[R]_p) : dot x y <= norm2 x * norm2 y.
Proof.
have [x0|xn0] := eqVneq (norm2 x) 0.
  have xz k : x 0 k = 0.
    have /eqP := norm2_sqr x; rewrite x0 expr0n /= eq_sym => /eqP.
    move=> H; have /(_ (fun l _ => sqr_ge0 _)) := @psumr_eq0P _ _ predT (fun k => x 0 k ^+ 2).
    by move/(_ H k isT)/eqP; rewrite sqrf_eq0 => /eqP.
  by rewrite x0 mul0r /dot big1 // => k _; rewrite xz mul0r.
have [y0|yn0] := eqVneq (norm2 y) 0.
  have yz k : y 0 k = 0.
    have /eqP := norm2_sqr y; rewrite y0 expr0n /= eq_sym => /eqP.
    move=> H; have /(_ (fun l _ => sqr_ge0 _)) := @psumr_eq0P _ _ predT (fun k => y 0 k ^+ 2).
    by move/(_ H k isT)/eqP; rewrite sqrf_eq0 => /eqP.
  by rewrite y0 mulr0 /dot big1 // => k _; rewrite yz mulr0.
have xg : 0 < norm2 x by rewrite lt_def xn0 norm2_ge0.
have yg : 0 < norm2 y by rewrite lt_def yn0 norm2_ge0.
have H : 0 <= \sum_k (norm2 y * x 0 k - norm2 x * y 0 k) ^+ 2.
  by apply: sumr_ge0 => k _; rewrite sqr_ge0.
have E : \sum_k (norm2 y * x 0 k - norm2 x * y 0 k) ^+ 2
   = (norm2 x * norm2 y) * (norm2 x * norm2 y - dot x y) *+ 2.
  rewrite (eq_bigr (fun k => norm2 y ^+ 2 * x 0 k ^+ 2 + norm2 x ^+ 2 * y 0 k ^+ 2
      + (- (norm2 x * norm2 y) *+ 2) * (x 0 k * y 0 k))) => [|k _]; last by ring.
  by rewrite !big_split /= -!mulr_sumr -!norm2_sqr -/(dot x y); ring.
by move: H; rewrite E pmulrn_lge0 // pmulr_rge0 ?mulr_gt0 // subr_ge0.
Qed.

Lemma norm2D p (x y : 'rV[R]_p) : norm2 (x + y) <= norm2 x + norm2 y.
Proof.
rewrite -(@ler_pexpn2r _ 2) // ?nnegrE ?addr_ge0 ?norm2_ge0 // sqrrD !norm2_sqr.
rewrite (eq_bigr (fun k => x 0 k ^+ 2 + (x 0 k * y 0 k) *+ 2 + y 0 k ^+ 2)) => [|k _]; last first.
  by rewrite mxE sqrrD.
rewrite !big_split /= ler_add2r ler_add2l.
by rewrite -mulr2n ler_muln2r /= cauchy_schwarz.
Qed.
Lemma norm2N p (x : 'rV[R]_p) : norm2 (- x) = norm2 x.
Proof. by rewrite -scaleN1r norm2Z normrN1 mul1r. Qed.

(* the l2-diameter of the rows (of their convex hull: see convex_hull) *)
Definition tau2 m p (A : 'M[R]_(m, p)) : R := diameter (@norm2 p) A.

(* chazelle.lem2.4 *)
Theorem lemma_2_4 m n p (A : 'M[R]_(m, n)) (B : 'M[R]_(n, p)) :
  stochastic A -> stochastic B -> tau2 (A *m B) <= tau1 A * tau2 B.
Proof.
move=> SA _; apply: diameter_mul => //; [exact: norm2_0 | exact: norm2Z | exact: norm2D].
Qed.

Lemma tau2_identity n : tau2 (1%:M : 'M[R]_n) <= Num.sqrt 2%:R.
Proof.
apply: max_le => [|[i j] /=]; first exact: sqrtr_ge0.
rewrite ler_wsqrtr // (eq_bigr (fun k => ((k == i)%:R - (k == j)%:R) ^+ 2)) => [|k _]; last first.
  by rewrite !mxE ![_ == k]eq_sym.
apply: (@le_trans _ _ (\sum_k ((k == i)%:R + (k == j)%:R))).
  by apply: ler_sum => k _; case: (k == i); case: (k == j); rewrite ?subrr ?subr0 ?sub0r ?sqrrN ?expr1n
    ?expr0n ?addr0 ?add0r ?lexx ?ler0n // addr_ge0 ?ler01.
have one (l : 'I_n) : \sum_k (k == l)%:R = 1 :> R.
  by rewrite (bigD1 l) //= eqxx big1 ?addr0 // => k /negbTE->.
by rewrite big_split /= !one -mulr2n.
Qed.

(* chazelle.tau2sqrt2 *)
Theorem tau2_le_tau1 m n (A : 'M[R]_(m, n)) : stochastic A ->
  tau2 A <= tau1 A * tau2 (1%:M : 'M[R]_n) /\
  tau1 A * tau2 (1%:M : 'M[R]_n) <= Num.sqrt 2%:R * tau1 A.
Proof.
move=> SA; split; first by rewrite -{1}[A]mulmx1; apply: lemma_2_4 => //; exact: stochastic1.
by rewrite mulrC; apply: ler_wpmul2r; [exact: tau1_ge0 | exact: tau2_identity].
Qed.

(* points of the convex hull of the rows are no farther apart than two rows *)
Theorem convex_hull m p (A : 'M[R]_(m, p)) (a b : 'rV[R]_m) : stochastic a -> stochastic b ->
  norm2 (a *m A - b *m A) <= tau2 A.
Proof.
move=> [a0 sa] [b0 sb]; pose W : 'M[R]_(2, m) := \matrix_(i, k) (if i == 0 then a 0 k else b 0 k).
have SW : stochastic W.
  split=> [i k|i]; first by rewrite mxE; case: eqP.
  rewrite (eq_bigr (fun k => if i == 0 then a 0 k else b 0 k)) => [|k _]; last by rewrite mxE.
  by case: eqP.
have ra : row 0 W = a by apply/rowP=> k; rewrite !mxE.
have rb : row (lift ord0 ord0) W = b by apply/rowP=> k; rewrite !mxE.
have := diameter_ub (@norm2 p) (W *m A) 0 (lift ord0 ord0); rewrite !row_mul ra rb => H.
apply: le_trans H _; apply: le_trans (diameter_mul (norm2_0 _) (@norm2Z _) (@norm2D _) A SW) _.
rewrite -[X in _ <= X]mul1r; apply: ler_wpmul2r; [exact: max_ge0 | exact: tau1_le1].
Qed.

(* chazelle.lem2.1: x(t) = x(t-1) + v(t), birds are rows *)
Theorem lemma_2_1 n d (x v : nat -> 'M[R]_(n, d)) t (i j : 'I_n) :
  (forall t, (0 < t)%N -> x t = x t.-1 + v t) -> (0 < t)%N ->
  `| norm2 (row i (x t) - row j (x t)) - norm2 (row i (x t.-1) - row j (x t.-1)) |
     <= norm2 (row i (v t) - row j (v t)).
Proof.
move=> H t0; set r := row i (x t.-1) - _; set w := row i (v t) - _.
have -> : row i (x t) - row j (x t) = r + w.
  by rewrite H // !linearD /= /r /w addrACA -opprD.
rewrite ler_norml; apply/andP; split.
  rewrite ler_oppl opprB ler_subl_addr -{1}[r](addrK w) addrC.
  by apply: le_trans (norm2D _ _) _; rewrite norm2N addrC.
by rewrite ler_subl_addl norm2D.
Qed.

(* chazelle.eq2.3: the whole vector v(t), all coordinates of all birds *)
Definition length n d (v : 'M[R]_(n, d)) : R := Num.sqrt (\sum_i \sum_k v i k ^+ 2).
Definition fastest n d (v : 'M[R]_(n, d)) : R := \big[Num.max/0]_i norm2 (row i v).

Lemma fastest_mul n d (A : 'M[R]_n) (v : 'M[R]_(n, d)) : stochastic A -> fastest (A *m v) <= fastest v.
Proof.
move=> [A0 sA]; apply: max_le => [|i]; first exact: max_ge0.
rewrite row_mul mulmx_sum_row.
apply: le_trans (norm_sum (norm2_0 _) (@norm2D _) _) _.
apply: (@le_trans _ _ (\sum_l A i l * fastest v)); last by rewrite -mulr_suml sA mul1r.
apply: ler_sum => l _; rewrite norm2Z mxE ger0_norm //; apply: ler_wpmul2l => //.
exact: (max_ub (fun l => norm2 (row l v)) l).
Qed.

Theorem velocity_bound n d (P : nat -> 'M[R]_n) (v : nat -> 'M[R]_(n, d)) t :
  (forall t, stochastic (P t)) -> (forall t, (0 < t)%N -> v t.+1 = P t *m v t) -> (0 < t)%N ->
  length (v t) <= Num.sqrt n%:R * fastest (v 1%N).
Proof.
move=> SP H; case: t => // t _.
have F : fastest (v t.+1) <= fastest (v 1%N).
  elim: t => // t IH; rewrite H //; exact: le_trans (fastest_mul _ (SP _)) IH.
have f0 : 0 <= fastest (v 1%N) by exact: max_ge0.
rewrite -[X in _ <= _ * X]ger0_norm // -sqrtr_sqr -sqrtrM ?ler0n // ler_wsqrtr //.
apply: (@le_trans _ _ (\sum_(i < n) fastest (v 1%N) ^+ 2)); last first.
  by rewrite sumr_const card_ord -mulr_natl.
apply: ler_sum => i _.
have -> : \sum_k v t.+1 i k ^+ 2 = norm2 (row i (v t.+1)) ^+ 2.
  by rewrite norm2_sqr; apply: eq_bigr => k _; rewrite mxE.
rewrite ler_pexpn2r ?nnegrE ?norm2_ge0 //; apply: le_trans F.
exact: (max_ub (fun l => norm2 (row l (v t.+1))) i).
Qed.

(* with coordinates of v(1) at most n^b: the bound is n^{O(1)} for fixed d (sqrt(n d) n^b) *)
Theorem velocity_polynomial n d b (P : nat -> 'M[R]_n) (v : nat -> 'M[R]_(n, d)) t :
  (forall t, stochastic (P t)) -> (forall t, (0 < t)%N -> v t.+1 = P t *m v t) -> (0 < t)%N ->
  (forall i k, `|v 1%N i k| <= n%:R ^+ b) ->
  length (v t) <= Num.sqrt (n%:R * d%:R) * n%:R ^+ b.
Proof.
move=> SP H t0 B; apply: le_trans (velocity_bound SP H t0) _.
have c0 : 0 <= n%:R ^+ b :> R by rewrite exprn_ge0 ?ler0n.
rewrite sqrtrM ?ler0n // -mulrA; apply: ler_wpmul2l; first exact: sqrtr_ge0.
apply: max_le => [|i]; first by rewrite mulr_ge0 ?sqrtr_ge0.
rewrite -[X in _ <= _ * X]ger0_norm // -sqrtr_sqr -sqrtrM ?ler0n // ler_wsqrtr //.
apply: (@le_trans _ _ (\sum_(k < d) (n%:R ^+ b) ^+ 2)); last first.
  by rewrite sumr_const card_ord -mulr_natl.
apply: ler_sum => k _; rewrite mxE -real_normK ?num_real // ler_pexpn2r ?nnegrE //; exact: B.
Qed.
End Euclid.
