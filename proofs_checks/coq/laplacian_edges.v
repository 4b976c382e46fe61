(* Laplacians of graphs: a new edge decreases no eigenvalue, and their sum grows by 2 (Courant and Fischer).
     tanner2.cor2_merris. *)
Set Warnings "-notation-overridden,-ambiguous-paths".
From mathcomp Require Import all_ssreflect all_algebra ring zify.
From Flockproof Require Import chazelle_model symmetric_spectra.
Set Implicit Arguments.
Unset Strict Implicit.
Import GRing.Theory Num.Theory Order.TTheory.
Local Open Scope ring_scope.

(* lam are the eigenvalues of the symmetric A from the largest to the smallest, as often as their multiplicity: an orthonormal basis U of eigenvectors belongs to them *)
Definition eigenvalues_of (R : rcfType) m (A : 'M[R]_m.+1) (lam : 'I_m.+1 -> R) : Prop := exists U : 'M[R]_m.+1,
  [/\ U^T *m U = 1%:M, A *m U = U *m diag_mx (\row_k lam k) & forall j k : 'I_m.+1, (j <= k)%N -> lam k <= lam j].
Lemma form_in_basis (R : rcfType) m (A U : 'M[R]_m.+1) (lam : 'I_m.+1 -> R) (w : 'cV[R]_m.+1) : U^T *m U = 1%:M -> A *m U = U *m diag_mx (\row_k lam k) ->
  ((U *m w)^T *m A *m (U *m w)) 0 0 = \sum_i lam i * w i 0 ^+ 2 /\ ((U *m w)^T *m (U *m w)) 0 0 = \sum_i w i 0 ^+ 2.
Proof.
move=> UU AU; rewrite trmx_mul; split.
  rewrite -!mulmxA (mulmxA A) AU -!mulmxA (mulmxA U^T) UU mul1mx mxE; apply: eq_bigr => i _.
  by rewrite mxE mul_diag_mx !mxE expr2 mulrCA.
by rewrite -!mulmxA (mulmxA U^T) UU mul1mx mxE; apply: eq_bigr => i _; rewrite mxE expr2.
Qed.
Lemma monotone (R : rcfType) m (A B : 'M[R]_m.+1) (lam mu : 'I_m.+1 -> R) : eigenvalues_of A lam -> eigenvalues_of B mu ->
  (forall x : 'cV[R]_m.+1, (x^T *m A *m x) 0 0 <= (x^T *m B *m x) 0 0) -> forall k, lam k <= mu k.
Proof.
move=> [U [UU AU dl]] [V [VV BV dm]] AB k.
pose C : 'M[R]_m.+1 := \matrix_(i, j) if (k < i)%N then (i == j)%:R else if (i < k)%N then (V^T *m U) i j else 0.
have d0 : \det C^T == 0 by rewrite det_tr (expand_det_row _ k) big1 // => j _; rewrite mxE ltnn mul0r.
have /det0P[v vn vC] := d0.
pose y := v^T; have Cy i : \sum_j C i j * y j 0 = 0.
  by have /matrixP/(_ 0 i) := vC; rewrite !mxE => h; rewrite -[RHS]h; apply: eq_bigr => j _; rewrite !mxE mulrC.
have y0 (i : 'I_m.+1) : (k < i)%N -> y i 0 = 0.
  move=> ki; rewrite -[RHS](Cy i) (bigD1 i) //= [C i i]mxE ki eqxx mul1r big1 ?addr0 // => j ji.
  by rewrite [C i j]mxE ki eq_sym (negbTE ji) mul0r.
pose z := V^T *m (U *m y); have z0 (i : 'I_m.+1) : (i < k)%N -> z i 0 = 0.
  move=> ik; rewrite -[RHS](Cy i) /z mulmxA mxE; apply: eq_bigr => j _; by rewrite [C i j]mxE ltnNge (ltnW ik) /= ik.
have VVt : V *m V^T = 1%:M by exact: mulmx1C.
have xz : U *m y = V *m z by rewrite /z mulmxA VVt mul1mx.
have [fA nA] := form_in_basis y UU AU; have [fB nB] := form_in_basis z VV BV.
have yz : \sum_i z i 0 ^+ 2 = \sum_i y i 0 ^+ 2 by rewrite -nA -nB xz.
have pos : 0 < \sum_i y i 0 ^+ 2.
  rewrite lt_def sumr_ge0 ?andbT => [|i _]; last by rewrite sqr_ge0.
  apply: contraNneq vn => /eqP; rewrite psumr_eq0 => [/allP h|i _]; last by rewrite sqr_ge0.
  apply/eqP/rowP => i; rewrite mxE; have := h i (mem_index_enum i); by rewrite /= mxE sqrf_eq0 => /eqP.
have lo : lam k * (\sum_i y i 0 ^+ 2) <= \sum_i lam i * y i 0 ^+ 2.
  rewrite mulr_sumr; apply: ler_sum => i _; case: (leqP i k) => ik; first by rewrite ler_wpmul2r ?sqr_ge0 // dl.
  by rewrite y0 // expr0n /= !mulr0.
have hi : \sum_i mu i * z i 0 ^+ 2 <= mu k * (\sum_i z i 0 ^+ 2).
  rewrite mulr_sumr; apply: ler_sum => i _; case: (leqP k i) => ik; first by rewrite ler_wpmul2r ?sqr_ge0 // dm.
  by rewrite z0 // expr0n /= !mulr0.
rewrite -(ler_pmul2r pos); apply: le_trans lo _; rewrite -fA; apply: le_trans (AB _) _.
by rewrite xz fB -yz.
Qed.
Lemma trace_of (R : rcfType) m (A : 'M[R]_m.+1) (lam : 'I_m.+1 -> R) : eigenvalues_of A lam -> \tr A = \sum_k lam k.
Proof.
move=> [U [UU AU _]]; have UUt : U *m U^T = 1%:M by exact: mulmx1C.
rewrite -[A]mulmx1 -UUt mulmxA AU mxtrace_mulC mulmxA UU mul1mx mxtrace_diag.
by apply: eq_bigr => k _; rewrite mxE.
Qed.
Section NewEdge.
Variables (R : rcfType) (m : nat) (G G' : rel 'I_m.+1) (p q : 'I_m.+1).
Hypothesis net : network G.
Hypothesis pq : p != q.
Hypothesis new : ~~ G p q.
Hypothesis more : forall i j, G' i j = [|| G i j, (i == p) && (j == q) | (i == q) && (j == p)].
Let b : 'cV[R]_m.+1 := \col_i ((i == p)%:R - (i == q)%:R).
Lemma degree_more i : (degree G' i = degree G i + (i == p) + (i == q))%N.
Proof.
have [sym irr] := net; rewrite /degree -!sum1_card !(big_mkcond (fun j => j \in _)) /=.
have one (a : bool) (c : 'I_m.+1) : (\sum_(j < m.+1) (a && (j == c)) = a)%N.
  by rewrite (bigD1 c) //= eqxx andbT big1 ?addn0 // => j /negbTE->; rewrite andbF.
rewrite -(one (i == p) q) -(one (i == q) p) -!big_split /=; apply: eq_bigr => j _; rewrite !inE more.
have hA : (i == p) && (j == q) -> G i j = false by case/andP => /eqP-> /eqP->; apply: negbTE.
have hB : (i == q) && (j == p) -> G i j = false by case/andP => /eqP-> /eqP->; rewrite sym; apply: negbTE.
have hAB : (i == p) && (j == q) -> (i == q) && (j == p) = false by case/andP => /eqP-> _; rewrite (negbTE pq).
move: hA hB hAB; case: (G i j); case: (_ && _); case: (_ && _) => //=; by [move=> /(_ isT) | move=> _ /(_ isT) | move=> _ _ /(_ isT)].
Qed.
Lemma laplacian_more : laplacian R G' = laplacian R G + b *m b^T.
Proof.
apply/matrixP => i j; rewrite !mxE big_ord1 !mxE; case: (eqVneq i j) => [<-|ij].
  rewrite degree_more !natrD -addrA; congr (_ + _).
  have [->|ip] := eqVneq i p; first by rewrite (negbTE pq) subr0 addr0 mulr1.
  by have [_|_] := eqVneq i q; rewrite ?sub0r ?subr0 ?mulrNN ?mulr1 ?add0r ?mulr0 ?addr0.
rewrite more; have [ip|ip] := eqVneq i p.
  have jp : (j == p) = false by rewrite eq_sym -ip; exact: negbTE.
  rewrite ip (negbTE pq) jp /= orbF; have [->|jq] := eqVneq j q; first by rewrite (negbTE new) /= subr0 mul1r sub0r add0r.
  by rewrite orbF /= subrr mulr0 addr0.
have [iq|iq] := eqVneq i q.
  have jq : (j == q) = false by rewrite eq_sym -iq; exact: negbTE.
  rewrite iq jq /=; have [->|jp] := eqVneq j p; last by rewrite orbF subrr mulr0 addr0.
  by have [sym _] := net; rewrite sym (negbTE new) /= sub0r subr0 mulr1 add0r.
by rewrite /= orbF subrr mul0r addr0.
Qed.
(* no eigenvalue decreases, and their sum grows by 2 *)
Theorem new_edge (lam mu : 'I_m.+1 -> R) : eigenvalues_of (laplacian R G) lam -> eigenvalues_of (laplacian R G') mu ->
  (forall k, lam k <= mu k) /\ \sum_k mu k = \sum_k lam k + 2%:R.
Proof.
move=> L L'; split.
  apply: (monotone L L') => x; rewrite laplacian_more mulmxDr mulmxDl [X in _ <= X]mxE ler_addl.
  rewrite mulmxA -mulmxA; have -> : b^T *m x = (x^T *m b)^T by rewrite trmx_mul trmxK.
  by rewrite mxE big_ord1 [X in _ * X]mxE -expr2 sqr_ge0.
rewrite -(trace_of L) -(trace_of L') laplacian_more mxtraceD; congr (_ + _).
rewrite mxtrace_mulC /mxtrace big_ord1 mxE (bigD1 p) //= (bigD1 q) ?(eq_sym q p) //= big1 => [|i /andP[ip iq]].
  by rewrite !mxE !eqxx (negbTE pq) (eq_sym q p) (negbTE pq) subr0 sub0r mulrNN !mulr1 addr0.
by rewrite !mxE (negbTE ip) (negbTE iq) subrr mulr0.
Qed.
End NewEdge.
(* the eigenvalues of a Laplacian: they exist, and are the roots of the characteristic polynomial with their multiplicities *)
Theorem laplacian_eigenvalues (R : rcfType) m (G : rel 'I_m.+1) : network G ->
  (exists lam, eigenvalues_of (laplacian R G) lam) /\ forall lam, eigenvalues_of (laplacian R G) lam -> char_poly (laplacian R G) = \prod_k ('X - (lam k)%:P).
Proof.
move=> [sym irr]; split; last by move=> lam [U [UU AU _]]; exact: eigenvalues_char_poly UU AU.
have S : (laplacian R G)^T = laplacian R G by apply/matrixP => i j; rewrite !mxE eq_sym sym; case: eqP => [->|].
by have [U [lam [UU AU dec]]] := ordered_eigenvectors S; exists lam, U.
Qed.
