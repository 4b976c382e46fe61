(* Chazelle, (3.7): the n eigenvalues of M in order.
     chazelle.eq3.7 (clause 2). *)
Set Warnings "-notation-overridden,-ambiguous-paths".
From mathcomp Require Import all_ssreflect all_algebra.
From Flockproof Require Import chazelle_model chazelle_fixed chazelle_network symmetric_spectra chazelle_spectral.
Set Implicit Arguments.
Unset Strict Implicit.
Import GRing.Theory Num.Theory Order.TTheory.
Local Open Scope ring_scope.

Theorem eigenvalues_in_order (R : rcfType) m (G : rel 'I_m.+1) (c : 'I_m.+1 -> R) :
  network G -> model_D G c -> (forall i j, connect G i j) -> (forall i, 0 < c i) ->
  exists lam : 'I_m.+1 -> R, [/\ char_poly (M G c) = \prod_k ('X - (lam k)%:P), lam ord0 = 1,
    forall k, k != ord0 -> lam k < 1, forall j k : 'I_m.+1, (j <= k)%N -> lam k <= lam j & forall k, - 1 <= lam k].
Proof.
move=> net MD con c0; have [_ sym [Mu1 u1u1] steps others] := eq_3_7 net MD con c0.
pose A := M G c; have At : A^T = A by apply/matrixP => i j; rewrite [LHS]mxE sym.
have mulE (f : 'cV[R]_m.+1) i : (A *m f) i 0 = \sum_j M G c i j * f j 0 by rewrite mxE.
have [U [lam [UU AU dec]]] := ordered_eigenvectors At.
have eig k i : \sum_j M G c i j * U j k = lam k * U i k.
  by have /matrixP/(_ i k) := AU; rewrite mul_mx_diag [LHS]mxE [RHS]mxE [X in _ = _ * X -> _]mxE [RHS]mulrC.
have norm1 k : \sum_i U i k * U i k = 1.
  by have /matrixP/(_ k k) := UU; rewrite !mxE eqxx mulr1n => <-; apply: eq_bigr => i _; rewrite mxE.
have orth j k : j != k -> \sum_i U i j * U i k = 0.
  by move/negPf => jk; have /matrixP/(_ j k) := UU; rewrite !mxE jk mulr0n => h; rewrite -[RHS]h; apply: eq_bigr => i _; rewrite mxE.
have nz k : exists i, U i k != 0.
  apply/existsP; apply: contraT; rewrite negb_exists => /forallP z; move: (norm1 k).
  by rewrite big1 => [/eqP|i _]; rewrite ?[0 == 1]eq_sym ?oner_eq0 //; have := z i; rewrite negbK => /eqP ->; rewrite mul0r.
(* a vector that M keeps is a multiple of that of the square roots of 1/c *)
have kept f : (forall i, \sum_j M G c i j * f j = f i) -> forall i j, Num.sqrt (c i) * f i = Num.sqrt (c j) * f j.
  move=> h i j; have E k : step G c (fun j => Num.sqrt (c j) * f j) k = Num.sqrt (c k) * f k.
    by rewrite -[RHS]mul1r; apply: (proj1 (steps 1 f)) => l; rewrite mul1r.
  exact: (fixed_constant net MD con c0 E i j).
have once j k : lam j = 1 -> lam k = 1 -> j = k.
  move=> j1 k1; apply/eqP; apply: contraT => jk; have := orth j k jk.
  have Kj := kept _ (fun i => etrans (eig j i) (etrans (congr1 (fun x => x * U i j) j1) (mul1r _))).
  have Kk := kept _ (fun i => etrans (eig k i) (etrans (congr1 (fun x => x * U i k) k1) (mul1r _))).
  have s0 i : Num.sqrt (c i) != 0 by rewrite gt_eqF // sqrtr_gt0.
  have [p pj] := nz j; have [q qk] := nz k.
  pose a := Num.sqrt (c p) * U p j; pose b := Num.sqrt (c q) * U q k.
  have a0 : a != 0 by rewrite mulf_neq0. have b0 : b != 0 by rewrite mulf_neq0.
  have Ej i : U i j = a / Num.sqrt (c i) by apply: (mulfI (s0 i)); rewrite (Kj i p) [RHS]mulrC divfK.
  have Ek i : U i k = b / Num.sqrt (c i) by apply: (mulfI (s0 i)); rewrite (Kk i q) [RHS]mulrC divfK.
  rewrite (eq_bigr (fun i => a * b * (c i)^-1)) => [|i _]; last first.
    by rewrite Ej Ek mulrACA -invfM -expr2 sqr_sqrtr // ltW.
  rewrite -mulr_sumr => /eqP; rewrite mulf_eq0 (negPf (mulf_neq0 a0 b0)) /=.
  rewrite psumr_eq0 => [|i _]; last by rewrite invr_ge0 ltW.
  by move/allP/(_ p (mem_index_enum _)); rewrite invr_eq0 gt_eqF.
have range k : lam k = 1 \/ -1 < lam k < 1 by apply: (others _ (fun i => U i k)) => // i; exact: eig.
(* 1 is one of them: the vector u1 is not 0 in the basis *)
have [k1 k1E] : exists k, lam k = 1.
  pose v : 'cV[R]_m.+1 := \col_i u1 c i; have Av : A *m v = v.
    by apply/colP => i; rewrite mulE [RHS]mxE -Mu1; apply: eq_bigr => l _; rewrite [v _ _]mxE.
  have UA : U^T *m A = diag_mx (\row_k lam k) *m U^T by rewrite -[LHS]trmxK trmx_mul trmxK At AU trmx_mul tr_diag_mx.
  pose g := U^T *m v; have Dg : diag_mx (\row_k lam k) *m g = g by rewrite /g mulmxA -UA -mulmxA Av.
  have : exists k, g k 0 != 0.
    apply/existsP; apply: contraT; rewrite negb_exists => /forallP z.
    have g0 : g = 0 by apply/colP => i; rewrite [RHS]mxE; apply/eqP; have := z i; rewrite negbK.
    have v0 : v = 0 by rewrite -[v]mul1mx -(mulmx1C UU) -mulmxA -/g g0 mulmx0.
    move: u1u1; rewrite big1 => [/eqP|i _]; first by rewrite eq_sym oner_eq0.
    by have /colP/(_ i) := v0; rewrite !mxE => ->; rewrite expr0n.
  case=> k gk; exists k; apply: (mulIf gk); rewrite mul1r -[RHS](congr1 (fun z : 'cV_m.+1 => z k 0) Dg).
  by rewrite mul_diag_mx !mxE.
have first : lam ord0 = 1.
  have := dec ord0 k1 (leq0n _); rewrite k1E => h; case: (range ord0) => // /andP[_ lt1].
  by move: (lt_le_trans lt1 h); rewrite ltxx.
exists lam; split=> //; first exact: eigenvalues_char_poly UU AU.
- move=> k k0; case: (range k) => [k1'|/andP[] //]; by rewrite (once _ _ k1' first) eqxx in k0.
by move=> k; case: (range k) => [->|/andP[/ltW //]]; apply: le_trans ler01; rewrite oppr_le0 ler01.
Qed.
