(* Real symmetric matrices over any real closed field: an orthonormal basis of eigenvectors, the eigenvalues in order, and the characteristic polynomial.
   No claim; no axioms. *)
Set Warnings "-notation-overridden,-ambiguous-paths".
From mathcomp Require Import all_ssreflect all_algebra perm zify ring.
Set Implicit Arguments.
Unset Strict Implicit.
Import GRing.Theory Num.Theory Order.TTheory.
Local Open Scope ring_scope.

Lemma largest (R : realFieldType) n (d : 'I_n.+1 -> R) : exists k, forall i, d i <= d k.
Proof.
elim: n d => [|n IH] d; first by exists ord0 => i; rewrite (ord1 i).
have [k H] := IH (fun i => d (lift ord0 i)); have [h|h] := lerP (d (lift ord0 k)) (d ord0).
  by exists ord0 => i; case: (unliftP ord0 i) => [j|] -> //; apply: le_trans (H j) h.
by exists (lift ord0 k) => i; case: (unliftP ord0 i) => [j|] ->; [apply: H|apply: ltW].
Qed.
Lemma arrow (R : rcfType) n (a : R) (b d : 'I_n.+1 -> R) : exists lam f0 (f : 'I_n.+1 -> R),
  [/\ f0 != 0 \/ exists i, f i != 0, a * f0 + \sum_i b i * f i = lam * f0 & forall i, b i * f0 + d i * f i = lam * f i].
Proof.
have [k dk] := largest d; pose mu := d k.
pose q : {poly R} := ('X - a%:P) * \prod_i ('X - (d i)%:P) - \sum_i ((b i) ^+ 2)%:P * \prod_(j | j != i) ('X - (d j)%:P).
have Q y : q.[y] = (y - a) * \prod_i (y - d i) - \sum_i b i ^+ 2 * \prod_(j | j != i) (y - d j).
  rewrite /q hornerD hornerN hornerM hornerXsubC horner_prod horner_sum; congr (_ * _ - _).
    by apply: eq_bigr => i _; rewrite hornerXsubC.
  by apply: eq_bigr => i _; rewrite hornerM hornerC horner_prod; congr (_ * _); apply: eq_bigr => j _; rewrite hornerXsubC.
have Qmu : q.[mu] = - (b k ^+ 2 * \prod_(j | j != k) (mu - d j)).
  rewrite Q (bigD1 k) //= subrr mul0r mulr0 sub0r; congr (- _).
  rewrite [LHS](bigD1 k) //= [X in _ + X]big1 ?addr0 // => i ik; by rewrite (bigD1 k) 1?eq_sym //= subrr mul0r mulr0.
have Q0 : q.[mu] <= 0.
  by rewrite Qmu oppr_le0 mulr_ge0 ?sqr_ge0 // prodr_ge0 // => j _; rewrite subr_ge0.
pose S := \sum_i b i ^+ 2; have S0 : 0 <= S by apply: sumr_ge0 => i _; apply: sqr_ge0.
pose X := mu + 1 + `|a - mu| + S.
have Xd i : 1 <= X - d i.
  rewrite (_ : X - d i = 1 + (mu - d i + `|a - mu| + S)); last by rewrite /X; ring.
  by rewrite ler_addl; apply: addr_ge0 => //; apply: addr_ge0; rewrite ?normr_ge0 // subr_ge0; apply: dk.
have Xmu : mu <= X by rewrite /X -!addrA ler_addl; apply: addr_ge0; rewrite ?ler01 //; apply: addr_ge0; rewrite ?normr_ge0.
have fac y : (forall i, y - d i != 0) -> q.[y] = \prod_i (y - d i) * ((y - a) - \sum_i b i ^+ 2 / (y - d i)).
  move=> z; rewrite Q mulrBr mulrC mulr_sumr; congr (_ - _); apply: eq_bigr => i _; rewrite [in RHS](bigD1 i) //=.
  by rewrite mulrCA mulrAC mulfV // mul1r.
have Q1 : 0 <= q.[X].
  have E := fac X (fun i => lt0r_neq0 (lt_le_trans ltr01 (Xd i))).
  rewrite E mulr_ge0 ?prodr_ge0 // => [i _|]; first by apply: le_trans (Xd i); rewrite ler01.
  rewrite subr_ge0; apply: (@le_trans _ _ S).
    apply: ler_sum => i _; rewrite ler_pdivr_mulr; last by apply: lt_le_trans (Xd i); exact: ltr01.
    by apply: ler_pemulr; rewrite ?sqr_ge0 ?Xd.
  rewrite -subr_ge0 (_ : X - a - S = 1 + (`|a - mu| - (a - mu))); last by rewrite /X; ring.
  by rewrite addr_ge0 // subr_ge0 ler_norm.
have [x /andP[mx _] /rootP qx] := poly_ivt Xmu (introT andP (conj Q0 Q1)).
have [x_mu|x_mu] := eqVneq x mu; last first.
  have z i : x - d i != 0 by apply: lt0r_neq0; rewrite subr_gt0; apply: le_lt_trans (dk i) _; rewrite lt_def x_mu.
  exists x, 1, (fun i => b i / (x - d i)); split=> [||i]; first by left; rewrite oner_neq0.
    have P0 : \prod_i (x - d i) != 0 by apply/prodf_neq0 => i _; apply: z.
    move: qx; rewrite (fac x z).
    move/eqP; rewrite mulf_eq0 (negPf P0) /= subr_eq0 subr_eq => /eqP E; rewrite !mulr1 [RHS]E addrC; congr (_ + _).
    by apply: eq_bigr => i _; rewrite expr2 mulrA.
  by rewrite mulr1 -{1}[b i](divfK (z i)) [_ / _ * _]mulrC -mulrDl subrK.
move: qx; rewrite x_mu Qmu => /eqP; rewrite oppr_eq0 mulf_eq0 sqrf_eq0 => /orP[/eqP bk|].
  exists mu, 0, (fun i => (i == k)%:R); split=> [||i].
  - by right; exists k; rewrite eqxx oner_neq0.
  - by rewrite (bigD1 k) //= bk mul0r big1 ?addr0 ?mulr0 // => i /negPf ->; rewrite mulr0.
  by rewrite mulr0 add0r; case: eqP => [->|_]; rewrite ?mulr0.
have [bk _|bk] := eqVneq (b k) 0.
  exists mu, 0, (fun i => (i == k)%:R); split=> [||i].
  - by right; exists k; rewrite eqxx oner_neq0.
  - by rewrite (bigD1 k) //= bk mul0r big1 ?addr0 ?mulr0 // => i /negPf ->; rewrite mulr0.
  by rewrite mulr0 add0r; case: eqP => [->|_]; rewrite ?mulr0.
move/prodf_eq0 => [j jk /eqP]; move/eqP; rewrite subr_eq0 => /eqP dj.
exists mu, 0, (fun i => b j * (i == k)%:R - b k * (i == j)%:R); split=> [||i].
- by right; exists j; rewrite eqxx (negPf jk) mulr0 sub0r mulr1 oppr_eq0.
- rewrite (bigD1 k) //= (bigD1 j) //= big1 ?addr0 => [|i /andP[/negPf ik /negPf ij]]; last by rewrite ik ij !mulr0 subrr mulr0.
  by rewrite !eqxx (negPf jk) [k == j]eq_sym (negPf jk) /=; ring.
rewrite mulr0 add0r; case: (eqVneq i k) => [->|_] //; case: (eqVneq i j) => [->|_]; first by rewrite -dj.
by rewrite !mulr0 subrr !mulr0.
Qed.
Lemma reflection (R : rcfType) n (u : 'cV[R]_n.+1) : u^T *m u = 1%:M ->
  exists H : 'M[R]_n.+1, [/\ H^T = H, H *m H = 1%:M & H *m delta_mx 0 0 = u].
Proof.
move=> uu; pose e : 'cV[R]_n.+1 := delta_mx 0 0.
have [->|ue] := eqVneq u e; first by exists 1%:M; rewrite trmx1 !mul1mx.
pose w := u - e; have wT : w^T = u^T - e^T by rewrite /w raddfB.
have s11 (B : 'M[R]_1) : B = (B 0 0)%:M by apply: mx11_scalar.
pose s := (w^T *m w) 0 0; have ws : w^T *m w = s%:M by apply: s11.
have s0 : s != 0.
  apply: contraNneq ue => z; rewrite -subr_eq0 -/w; apply/eqP/colP => i; rewrite [RHS]mxE; apply/eqP; rewrite -sqrf_eq0.
  move: z; rewrite /s mxE => /psumr_eq0P h; have := h (fun k _ => _) i isT; rewrite mxE -expr2 => -> // k.
  by rewrite mxE -expr2 sqr_ge0.
have ee : e^T *m e = 1%:M by rewrite trmx_delta mul_delta_mx; apply/matrixP => i j; rewrite !mxE !ord1.
have we : w^T *m e = (- (s / 2%:R))%:M.
  pose r := (u^T *m e) 0 0; have ur : u^T *m e = r%:M by apply: s11.
  have er : e^T *m u = r%:M by rewrite -[LHS]trmxK trmx_mul trmxK ur tr_scalar_mx.
  have sE : s = 2%:R - 2%:R * r.
    rewrite /s wT mulmxBl !mulmxBr uu ee ur er !mxE eqxx !mulr1n; ring.
  by rewrite wT mulmxBl ur ee -raddfB /= sE; congr (_%:M); field.
exists (1%:M - (2%:R / s) *: (w *m w^T)); split.
- by rewrite raddfB /= linearZ /= trmx1 trmx_mul trmxK.
- set W := w *m w^T; have WW : W *m W = s *: W by rewrite /W mulmxA -(mulmxA w) ws mul_mx_scalar -scalemxAl.
  rewrite mulmxBl mul1mx -scalemxAl mulmxBr mulmx1 -scalemxAr WW scalerA divfK // scaler_nat mulr2n opprD addrA subrr sub0r.
  by rewrite scalerN opprK subrK.
rewrite mulmxBl mul1mx -scalemxAl -mulmxA we mul_mx_scalar scalerA mulrN (_ : 2%:R / s * (s / 2%:R) = 1); last by field.
by rewrite scaleN1r opprK addrC subrK.
Qed.
Lemma unit_eigenvector (R : rcfType) n (A : 'M[R]_n) (v : 'cV[R]_n) lam : v != 0 -> A *m v = lam *: v ->
  exists e : 'cV[R]_n, e^T *m e = 1%:M /\ A *m e = lam *: e.
Proof.
move=> v0 Av; pose s := (v^T *m v) 0 0; have vs : v^T *m v = s%:M by apply: mx11_scalar.
have s0 : 0 < s.
  rewrite lt_def /s mxE sumr_ge0 ?andbT => [|k _]; last by rewrite mxE -expr2 sqr_ge0.
  apply: contraNneq v0 => z; apply/eqP/colP => i; rewrite [RHS]mxE; apply/eqP; rewrite -sqrf_eq0.
  have h : forall k, true -> 0 <= v^T 0 k * v k 0 by move=> k _; rewrite mxE -expr2 sqr_ge0.
  by have := psumr_eq0P h z (i := i) isT; rewrite mxE -expr2 => ->.
exists ((Num.sqrt s)^-1 *: v); split; last by rewrite -scalemxAr Av !scalerA mulrC.
have -> : ((Num.sqrt s)^-1 *: v)^T = (Num.sqrt s)^-1 *: v^T by apply/matrixP => i j; rewrite !mxE.
rewrite -scalemxAl -scalemxAr scalerA vs scale_scalar_mx -invfM -expr2 sqr_sqrtr ?ltW // mulVf //.
by rewrite gt_eqF.
Qed.
Lemma spectral_theorem (R : rcfType) n (A : 'M[R]_n.+1) : A^T = A ->
  exists (U : 'M[R]_n.+1) (D : 'rV[R]_n.+1), U^T *m U = 1%:M /\ A *m U = U *m diag_mx D.
Proof.
elim: n A => [|n IH] A At.
  exists 1%:M, (\row_i A 0 0); rewrite trmx1 !mul1mx mulmx1; split=> //.
  by apply/matrixP => i j; rewrite !ord1 !mxE eqxx.
have [e [lam [ee Ae]]] : exists (e : 'cV[R]_n.+2) lam, e^T *m e = 1%:M /\ A *m e = lam *: e.
  pose B : 'M[R]_(1 + n.+1) := A; pose rho := ursubmx B; pose A' := drsubmx B.
  have Bt : B^T = B := At.
  have A't : A'^T = A' by rewrite /A' trmx_drsub Bt.
  have dl : dlsubmx B = rho^T by rewrite /rho trmx_ursub Bt.
  have [U [D [UU AU]]] := IH A' A't; have UU' := mulmx1C UU.
  pose a := ulsubmx B 0 0; have ul : ulsubmx B = a%:M by apply: mx11_scalar.
  have [lam [f0 [f [nz E1 E2]]]] := arrow a (fun i => (rho *m U) 0 i) (fun i => D 0 i).
  pose F : 'cV[R]_n.+1 := \col_i f i; pose v : 'cV[R]_(1 + n.+1) := col_mx f0%:M (U *m F).
  have Bv : B *m v = lam *: v.
    rewrite -[B]submxK /v mul_block_col scale_col_mx dl ul -/rho -/A'; congr col_mx.
      rewrite [X in _ + X]mx11_scalar -scalar_mxM -raddfD /= scale_scalar_mx -E1; congr ((_ + _)%:M).
      by rewrite mulmxA mxE; apply: eq_bigr => i _; rewrite [F _ _]mxE.
    have -> : rho^T = U *m (rho *m U)^T by rewrite trmx_mul mulmxA UU' mul1mx.
    rewrite mulmxA AU -!mulmxA -mulmxDr scalemxAr; congr (_ *m _); apply/colP => i.
    rewrite mul_mx_scalar mul_diag_mx [LHS]mxE [X in X + _]mxE [X in _ + X]mxE [RHS]mxE [F i _]mxE.
    by rewrite -E2 [(rho *m U)^T _ _]mxE mulrC.
  have v0 : v != 0.
    apply/eqP => z; have [z1 z2] : (f0%:M : 'M[R]_1) = 0 /\ U *m F = 0.
      by split; [rewrite -[LHS](col_mxKu _ (U *m F))|rewrite -[LHS](col_mxKd (f0%:M : 'M[R]_1))]; rewrite -/v z linear0.
    have F0 : F = 0 by rewrite -[F]mul1mx -UU -mulmxA z2 mulmx0.
    case: nz => [|[i]]; first by move/matrixP/(_ 0 0): z1; rewrite !mxE eqxx mulr1n => ->; rewrite eqxx.
    by move/colP/(_ i): F0; rewrite !mxE => ->; rewrite eqxx.
  have [e He] := unit_eigenvector v0 Bv; by exists e, lam.
have [H [Ht HH He]] := reflection ee.
pose C0 : 'M[R]_n.+2 := H *m A *m H.
have Ct0 : C0^T = C0 by rewrite /C0 !trmx_mul Ht At mulmxA.
have Ce : C0 *m delta_mx 0 0 = lam *: (delta_mx 0 0 : 'cV_n.+2).
  by rewrite /C0 -!mulmxA He Ae -scalemxAr -He mulmxA HH mul1mx.
have Ci0 i : C0 i 0 = lam * (i == 0)%:R by have /colP/(_ i) := Ce; rewrite -colE !mxE eqxx andbT.
have E : A *m H = H *m C0 by rewrite /C0 !mulmxA HH mul1mx.
clearbody C0; pose C : 'M[R]_(1 + n.+1) := C0; have Ct : C^T = C := Ct0.
have Ci (i : 'I_(1 + n.+1)) : C i 0 = lam * (i == 0)%:R := Ci0 i.
have l0 (j : 'I_1) : lshift n.+1 j = 0 by apply: val_inj; rewrite /= (ord1 j).
have dl0 : dlsubmx C = 0 by apply/matrixP => i j; rewrite !mxE l0 Ci mulr0.
have ur0 : ursubmx C = 0 by rewrite -[ursubmx C]trmxK trmx_ursub Ct dl0 trmx0.
have ul0 : ulsubmx C = lam%:M.
  by rewrite [LHS]mx11_scalar; congr (_%:M); rewrite !mxE l0 Ci eqxx mulr1.
pose A' := drsubmx C; have A't : A'^T = A' by rewrite /A' trmx_drsub Ct.
have [U [D [UU AU]]] := IH A' A't.
pose W : 'M[R]_(1 + n.+1) := block_mx 1%:M 0 0 U.
have CW : C *m W = W *m diag_mx (row_mx lam%:M D).
  rewrite diag_mx_row -[C]submxK dl0 ur0 ul0 /W !mulmx_block !mulmx0 !mul0mx !addr0 !add0r mulmx1 mul1mx -/A' AU.
  congr block_mx; by apply/matrixP => i j; rewrite !ord1 !mxE eqxx.
have WW : W^T *m W = 1%:M.
  by rewrite /W tr_block_mx !trmx0 trmx1 mulmx_block !mulmx0 !mul0mx mul1mx UU !addr0 !add0r -scalar_mx_block.
exists (H *m W), (row_mx lam%:M D); split.
  by rewrite trmx_mul Ht mulmxA -(mulmxA W^T) HH mulmx1; exact: WW.
by rewrite mulmxA E -!mulmxA; congr (_ *m _); exact: CW.
Qed.
(* the same with the eigenvalues from the largest to the smallest *)
Theorem ordered_eigenvectors (R : rcfType) n (A : 'M[R]_n.+1) : A^T = A ->
  exists (U : 'M[R]_n.+1) (lam : 'I_n.+1 -> R), [/\ U^T *m U = 1%:M, A *m U = U *m diag_mx (\row_k lam k) &
    forall j k : 'I_n.+1, (j <= k)%N -> lam k <= lam j].
Proof.
move=> At; have [U [D [UU AU]]] := spectral_theorem At.
pose t := [tuple D 0 i | i < n.+1]; pose ge := fun x y : R => y <= x.
have ge_total : total ge by move=> x y; rewrite /ge; apply: le_total.
have ge_trans : transitive ge by move=> y x z xy yz; apply: le_trans yz xy.
have ge_refl : reflexive ge by move=> x; rewrite /ge.
have /tuple_permP[p sp] : perm_eq (sort ge t) t by rewrite perm_sort.
have nth_p (i : 'I_n.+1) : nth 0 (sort ge t) i = D 0 (p i).
  by rewrite sp (nth_mktuple _ _ i) tnth_mktuple.
exists (col_perm p U), (fun i => D 0 (p i)); split.
- apply/matrixP => i j; have /matrixP/(_ (p i) (p j)) := UU; rewrite !mxE (inj_eq perm_inj) => <-.
  by apply: eq_bigr => k _; rewrite !mxE.
- apply/matrixP => i j; rewrite mul_mx_diag !mxE; have /matrixP/(_ i (p j)) := AU; rewrite mul_mx_diag !mxE => <-.
  by apply: eq_bigr => k _; rewrite !mxE.
move=> j k jk; rewrite -!nth_p; apply: (sorted_leq_nth ge_trans ge_refl 0 (sort_sorted ge_total t)) => //;
  by rewrite inE size_sort size_tuple.
Qed.
Theorem eigenvalues_char_poly (R : rcfType) n (A U : 'M[R]_n.+1) (lam : 'I_n.+1 -> R) : U^T *m U = 1%:M ->
  A *m U = U *m diag_mx (\row_k lam k) -> char_poly A = \prod_k ('X - (lam k)%:P).
Proof.
move=> UU AU; set d := \row_k lam k in AU.
have -> : \prod_k ('X - (lam k)%:P) = char_poly (diag_mx d).
  by rewrite char_poly_trig ?diag_mx_is_trig //; apply: eq_bigr => k _; rewrite !mxE eqxx.
have AE : A = U *m diag_mx d *m U^T by rewrite -AU -mulmxA (mulmx1C UU) mulmx1.
rewrite /char_poly; set X := char_poly_mx (diag_mx d).
have -> : char_poly_mx A = map_mx polyC U *m X *m map_mx polyC U^T.
  rewrite /X /char_poly_mx mulmxBr mulmxBl AE !map_mxM; congr (_ - _).
  by rewrite mul_mx_scalar -scalemxAl -map_mxM (mulmx1C UU) map_mx1 scalemx1.
by rewrite !det_mulmx mulrAC -det_mulmx -map_mxM (mulmx1C UU) map_mx1 det1 mul1r.
Qed.
