(* Clauses of the claims about Chazelle's paper, most of them corrected ones, formalised from their words before the theorems were
   looked at; the theorems prove them. *)
Set Warnings "-notation-overridden,-ambiguous-paths".
From mathcomp Require Import all_ssreflect all_algebra ring zify.
From Flockproof Require Import chazelle_model chazelle_ergodicity chazelle_fixed chazelle_limits chazelle_products chazelle_entries.
From Flockproof Require chazelle_stabilisers chazelle_losses chazelle_network chazelle_spectral chazelle_eigenvalues chazelle_distances chazelle_switches audit_independent_chazelle.
Module A := audit_independent_chazelle.
Set Implicit Arguments.
Unset Strict Implicit.
Import GRing.Theory Num.Theory Order.TTheory.
Local Open Scope ring_scope.

(* N(t,s) with s < u <= t, of matrices with any footprints *)
Definition new_footprint (R : realFieldType) n (P : nat -> 'M[R]_n) u := [exists i, exists j, (P u i j != 0) != (P u.-1 i j != 0)].
Definition N_of (R : realFieldType) n (P : nat -> 'M[R]_n) t s := count (new_footprint P) (iota s.+1 (t - s)).
(* chazelle.Nts clause 3 *)
Definition Nts_3 : Prop := forall (R : realFieldType) n (P : nat -> 'M[R]_n) (tk : nat -> nat) k,
  tk k.+1 = (tk k).+1 -> (N_of P (tk k.+1) (tk k) <= 1)%N.
(* chazelle.Nts clause 4 *)
Definition Nts_4 : Prop := forall (R : realFieldType) n (P : nat -> 'M[R]_n) (tk : nat -> nat) s l,
  tk 0%N = s -> (forall k, (k < l)%N -> (tk k <= tk k.+1)%N) ->
  N_of P (tk l) s = (\sum_(1 <= k < l.+1) N_of P (tk k) (tk k.-1))%N.
(* chazelle.chi clause 2; row i of v is v_i, so that (A kron I_d) v is A *m v; every sequence of matrices *)
Definition chi_of (R : realFieldType) n (i j : 'I_n) : 'rV[R]_n := \row_k (if k == i then 1 else if k == j then -1 else 0).
Definition chi_2 : Prop := forall (R : realFieldType) n d (P : nat -> 'M[R]_n) (v : nat -> 'M[R]_(n, d)) i j, i != j ->
  (forall t, (0 < t)%N -> v t.+1 = P t *m v t) ->
  forall t, (1 < t)%N -> row i (v t) - row j (v t) = chi_of R i j *m pprod P t.-1 1 *m v 1%N.
(* chazelle.fiedler.rate clause 4, to the power n^c; after t steps *)
Definition fiedler_4 : Prop := forall a, exists c K, (0 < c)%N /\ forall (R : rcfType) n d (G : rel 'I_n) (w : 'I_n -> R)
  (v : nat -> 'M[R]_(n, d)) (N : 'rV[R]_d -> R), (1 < n)%N -> A.is_norm N -> A.fixed G w -> short_weights a w ->
  (forall t, (0 < t)%N -> v t.+1 = transition G w *m v t) ->
  forall t, 2%:R ^+ t * diameter N (v t.+1) ^+ (n ^ c) <= (n%:R ^+ K * diameter N (v 1%N)) ^+ (n ^ c).

(* T_0 = s - 1 < T_1 < ... and V_0 >= V_1 >= ...: T_(k+1) is the least time at which the footprint of P(t, T_k + 1) on V_k is
   final, V_(k+1) the ones of the column of a bird b_k of V_k there *)
Definition final_from (R : realFieldType) n (P : nat -> 'M[R]_n) (V : {set 'I_n}) s T :=
  (s <= T)%N /\ forall t i j, (T < t)%N -> i \in V -> j \in V -> (pprod P t s i j != 0) = (pprod P T s i j != 0).
Definition stages (R : realFieldType) n (P : nat -> 'M[R]_n) (s : nat) (T : nat -> nat) (V : nat -> {set 'I_n}) (b : nat -> 'I_n) :=
  [/\ (T 0%N).+1 = s, V 0%N = [set: 'I_n] & forall k,
    [/\ b k \in V k, final_from P (V k) (T k).+1 (T k.+1), forall T', final_from P (V k) (T k).+1 T' -> (T k.+1 <= T')%N &
      V k.+1 = [set i in V k | pprod P (T k.+1) (T k).+1 i (b k) != 0]]].
(* A_{|V x W} with zeros in the other places *)
Definition on (R : realFieldType) n (V W : {set 'I_n}) (A : 'M[R]_n) : 'M[R]_n := \matrix_(i, j) if (i \in V) && (j \in W) then A i j else 0.
Fixpoint chain (R : realFieldType) n (P : nat -> 'M[R]_n) (T : nat -> nat) (V : nat -> {set 'I_n}) k : 'M[R]_n :=
  if k is k'.+1 then (if k' is 0%N then on (V 1%N) (V 0%N) (pprod P (T 1%N) (T 0%N).+1)
    else on (V k) (V k') (pprod P (T k) (T k').+1) *m chain P T V k') else 1%:M.
(* chazelle.eq3.5 clause 2 *)
Definition eq3_5_2 : Prop := forall (R : realFieldType) n (G : nat -> rel 'I_n) (c : nat -> 'I_n -> R) s T V b,
  (0 < s)%N -> (forall t, (0 < t)%N -> network (G t)) -> (forall t, (0 < t)%N -> model_D (G t) (c t)) ->
  let P := fun t => transition (G t) (c t) in stages P s T V b ->
  forall k t, (0 < k)%N -> (T k < t)%N -> on (V k) (V 0%N) (pprod P t s) = on (V k) (V k) (pprod P t (T k).+1) *m chain P T V k.
(* chazelle.lem3.1.count clause 3; up to every time T', so that M need not be finite *)
Definition changes_in n (G : nat -> rel 'I_n) t s := count (A.differs G) (iota s.+1 (t - s)).
Definition changes_outside n (G : nat -> rel 'I_n) (V : {set 'I_n}) t s :=
  count (fun u => [exists i, exists j, [&& i \notin V, j \notin V & G u i j != G u.-1 i j]]) (iota s.+1 (t - s)).
Definition count_3 : Prop := forall (R : realFieldType) n (G : nat -> rel 'I_n) (P : nat -> 'M[R]_n) T V b,
  (forall t, (0 < t)%N -> network (G t)) ->
  (forall t, (0 < t)%N -> (forall i j, 0 <= P t i j) /\ (forall i, \sum_j P t i j = 1) /\ (forall i, 0 < P t i i) /\ forall i j, i != j -> (0 < P t i j) = G t i j) ->
  stages P 1 T V b -> forall k, (0 < k)%N ->
  (forall u i j, (T k < u)%N -> i \in V k -> j \in V k -> G u i j -> G u.+1 i j) ->
  forall T', (A.switches_up_to G T' <= \sum_(2 <= l < k.+1) changes_in G (T l) (T l.-1) + changes_in G (T 1%N) 1
    + 1 + 'C(#|V k|, 2) + changes_outside G (V k) T' (T k).+1)%N.
(* beyond.chazelle.losses *)
Definition losses_1 : Prop := forall (R : rcfType) n d a (x v : nat -> 'M[R]_(n, d)) (G : nat -> rel 'I_n) (w : nat -> 'I_n -> R),
  (4 <= n)%N -> (d <= n ^ 2)%N -> a = 1%N \/ a = 2%N -> A.flock_D a 1 x v G w ->
  (forall t, (0 < t)%N -> (forall i j, G t.+1 i j = G t i j) -> forall i, w t.+1 i = w t i) -> (forall i q, `|x 0%N i q| <= n%:R) ->
  forall t i j, (n ^ (n ^ 4 + 2 * n.-1 ^ 2 + 10 * n.-1 + 17) < t)%N -> G t.-1 i j -> G t i j.
(* chazelle.eq3.16 clause 2; f numbers the m + 1 birds of the flock of bird f a, H and cf are its network and weights; the columns of U
   are the u_k, the first of them to the eigenvalue 1 *)
Definition eq3_16_2 : Prop := forall (R : rcfType) n m d (G : nat -> rel 'I_n) (c : nat -> 'I_n -> R) (x v : nat -> 'M[R]_(n, d)) t1 t
  (f : 'I_m.+1 -> 'I_n) (a : 'I_m.+1) (U : 'M[R]_m.+1) (lam : 'I_m.+1 -> R), (t1 < t)%N ->
  (forall u, (t1 <= u < t)%N -> (forall i j, G u i j = G t1 i j) /\ forall i, c u i = c t1 i) ->
  (forall u, x u.+1 = x u + v u.+1) -> (forall u, (0 < u)%N -> v u.+1 = transition (G u) (c u) *m v u) ->
  network (G t1) -> model_D (G t1) (c t1) -> injective f -> (forall i, connect (G t1) (f a) i = (i \in codom f)) ->
  let H := fun p q => G t1 (f p) (f q) in let cf := fun p => c t1 (f p) in
  let P := transition H cf in let root := diag_mx (\row_p Num.sqrt (cf p)) in let unroot := diag_mx (\row_p (Num.sqrt (cf p))^-1) in
  let vf := \matrix_(p, q) v t1.+1 (f p) q : 'M[R]_(m.+1, d) in let pi := \row_p ((\sum_q (cf q)^-1)^-1 * (cf p)^-1) in
  (forall p, 0 < cf p) -> U^T *m U = 1%:M -> unroot *m P *m root *m U = U *m diag_mx (\row_p lam p) -> lam ord0 = 1 ->
  row (f a) (x t) = row (f a) (x t1) + row a (A.Gamma_of H cf) *m vf + (t - t1)%:R *: (pi *m vf)
    - \sum_(k | k != ord0) (lam k ^+ (t - t1) / (1 - lam k)) *: (row a (root *m col k U *m (col k U)^T *m unroot) *m vf).

(* ---- the theorems prove them ---- *)
Lemma Nts_3_holds : Nts_3.
Proof. by move=> R n P tk k ->; apply: chazelle_stabilisers.N_step. Qed.
Lemma Nts_4_holds : Nts_4.
Proof.
move=> R n P tk s l <-; elim: l => [|l IH] mono; first by rewrite big_geq // /N_of subnn.
have tl : (tk 0 <= tk l)%N.
  have : forall k, (k <= l)%N -> (tk 0 <= tk k)%N.
    by elim=> // k IHk kl; apply: (leq_trans (IHk (ltnW kl))); apply: mono; apply: leqW.
  exact.
rewrite big_nat_recr //= -IH => [|k kl]; last by apply: mono; apply: leqW.
exact: (chazelle_stabilisers.N_split (new_footprint P) tl (mono l (ltnSn l))).
Qed.
Lemma chi_2_holds : chi_2.
Proof.
move=> R n d P v i j ij Hv [|[|t]] // _.
have -> : chi_of R i j = chi R i j.
  apply/rowP => k; rewrite !mxE /= (eq_sym k i) (eq_sym k j); case: eqP => [e|_]; case: eqP => [e'|_] //=.
  - by move: ij; rewrite e e' eqxx.
  - by rewrite subr0.
  - by rewrite sub0r.
  - by rewrite subrr.
rewrite /pprod /= subn1 /=; exact: (chi_difference (P := P) i j t.+1 Hv).
Qed.
Lemma fiedler_4_holds : fiedler_4.
Proof.
move=> a; exists (2 * a + 4)%N, (a + 2)%N; split; first by rewrite addn_gt0 orbT.
move=> R n d G w v N n1 [_ [N0 NZ ND]] F sw Hv t; have [B1 B2] := A.short_bounds n1 F sw; case: F => net MD con c0.
have [_ H] := chazelle_network.fiedler_rate R net con.
have n0 : (0 < n)%N by apply: ltnW.
set m := (n ^ (2 * a + 4))%N; have m0 : (0 < m)%N by rewrite expn_gt0 n0.
have D0 (y : 'M[R]_(n, d)) : 0 <= diameter N y by exact: max_ge0.
have D : diameter N (v t.+1) <= n%:R ^+ a.+1 * 2%:R^-1 ^+ (t %/ m) * diameter N (v 1%N).
  apply: max_le => [|[i j] /=]; first by rewrite !mulr_ge0 ?exprn_ge0 ?invr_ge0 ?ler0n.
  exact: (H d a w v N t i j N0 NZ ND MD c0 n1 B1 B2 Hv).
have two : (2%:R : R) != 0 by rewrite pnatr_eq0.
apply: (@le_trans _ _ (2%:R ^+ t * (n%:R ^+ a.+1 * 2%:R^-1 ^+ (t %/ m) * diameter N (v 1%N)) ^+ m)).
  by apply: ler_wpmul2l; [rewrite exprn_ge0 ?ler0n | apply: ler_expn2r => //; rewrite ?nnegrE ?D0 // !mulr_ge0 ?exprn_ge0 ?invr_ge0 ?ler0n].
have -> : 2%:R ^+ t * (n%:R ^+ a.+1 * 2%:R^-1 ^+ (t %/ m) * diameter N (v 1%N)) ^+ m =
    2%:R ^+ (t %% m) * (n%:R ^+ a.+1 * diameter N (v 1%N)) ^+ m :> R.
  rewrite {1}(divn_eq t m) exprD (mulrAC _ (_ ^+ _) (diameter _ _)) [X in _ * X]exprMn -exprM exprVn.
  have b0 : (2%:R : R) ^+ (t %/ m * m) != 0 by rewrite expf_neq0.
  move: (_ ^+ (t %/ m * m)) b0 => B B0; move: ((_ * _) ^+ m) => Y; move: (_ ^+ (t %% m)) => b.
  by field.
apply: (@le_trans _ _ (2%:R ^+ m * (n%:R ^+ a.+1 * diameter N (v 1%N)) ^+ m)).
  apply: ler_wpmul2r; first by rewrite exprn_ge0 // mulr_ge0 ?exprn_ge0 ?ler0n.
  by apply: ler_weexpn2l; [rewrite ler1n | apply/ltnW; rewrite ltn_mod].
rewrite -exprMn; apply: ler_expn2r; rewrite ?nnegrE ?mulr_ge0 ?exprn_ge0 ?ler0n //.
by rewrite mulrA addn2 [n%:R ^+ a.+2]exprS; apply: ler_wpmul2r => //; apply: ler_wpmul2r; rewrite ?exprn_ge0 ?ler0n // ler_nat.
Qed.

(* (3.5) and the count: proofs of their own, as the b_k may differ here, and the footprints are those of all columns *)
Section Stages.
Variables (R : realFieldType) (n : nat) (P : nat -> 'M[R]_n) (s : nat) (T : nat -> nat) (V : nat -> {set 'I_n}) (b : nat -> 'I_n).
Hypothesis P0 : forall t i j, (0 < t)%N -> 0 <= P t i j.
Hypothesis sym : forall t i j, (0 < t)%N -> P t i j != 0 -> P t j i != 0.
Hypothesis S : stages P s T V b.
Lemma span0 m r i j : (0 < m)%N -> 0 <= span P m r i j.
Proof.
move=> m0; elim: r i j => [|r IH] i j /=; first by rewrite mxE ler0n.
by rewrite mxE; apply: sumr_ge0 => l _; rewrite mulr_ge0 ?IH ?P0 // ltn_addr.
Qed.
Lemma T_next k : (T k < T k.+1)%N. Proof. by case: S => _ _ /(_ k)[_ [h _] _ _]. Qed.
Lemma sub_next k i : i \in V k.+1 -> i \in V k. Proof. by case: S => _ _ /(_ k)[_ _ _ ->]; rewrite inE => /andP[]. Qed.
Lemma pprodS t m : (m <= t)%N -> pprod P t.+1 m = P t.+1 *m pprod P t m.
Proof. by move=> mt; rewrite /pprod subSn //= addnS subnKC. Qed.
Lemma cut k u i j : (T k < u)%N -> i \in V k -> j \notin V k -> P u i j = 0.
Proof.
elim: k i j => [|k IH] i j Tu iV jV; first by case: S => _ V0 _; rewrite V0 inE in jV.
have Tk := T_next k; have u0 : (0 < u)%N by lia.
have [jk|jk] := boolP (j \in V k); last by apply: IH => //; [lia | exact: sub_next].
apply/eqP; apply: contraNT jV => pz; have ik := sub_next iV.
case: (S) => _ _ /(_ k)[bV [_ fin] _ Vn]; rewrite Vn inE jk /= -(fin u j (b k) Tu jk bV).
clear IH; case: u Tu u0 pz => // u Tu u0 pz; rewrite pprodS; last by lia.
rewrite mxE (bigD1 i) //=; apply: lt0r_neq0; apply: ltr_paddr.
  by apply: sumr_ge0 => l _; rewrite mulr_ge0 ?P0 // /pprod span0.
have ib : pprod P u (T k).+1 i (b k) != 0.
  move: iV; rewrite Vn inE => /andP[_ h]; move: Tu; rewrite ltnS leq_eqVlt => /orP[/eqP <- //|Tu]; by rewrite fin.
by apply: mulr_gt0; rewrite lt_def; apply/andP; split; [exact: sym | exact: P0 | exact: ib | exact: span0].
Qed.
Lemma cut_prod k r i j : i \in V k -> j \notin V k -> span P (T k).+1 r i j = 0.
Proof.
move=> iV jV; elim: r i iV => [|r IH] i iV /=; rewrite mxE.
  by case: eqP => // e; rewrite -e iV in jV.
rewrite big1 // => l _; have [lV|lV] := boolP (l \in V k); first by rewrite IH // mulr0.
by rewrite (cut _ iV lV) ?mul0r // leq_addr.
Qed.
Lemma pprodD m t r : (r <= m)%N -> (m < t)%N -> pprod P t r = pprod P t m.+1 *m pprod P m r.
Proof.
move=> rm; elim: t => // t IH; rewrite ltnS leq_eqVlt => /orP[/eqP <-|mt]; first by rewrite pprodS // pprod_self.
by rewrite !pprodS ?IH ?mulmxA //; lia.
Qed.
Lemma on_step k t r W : (T k < t)%N -> (r <= T k)%N ->
  on (V k) W (pprod P t r) = on (V k) (V k) (pprod P t (T k).+1) *m on (V k) W (pprod P (T k) r).
Proof.
move=> Tt rT; apply/matrixP=> i j; rewrite (pprodD rT Tt) mxE [RHS]mxE.
have [iV|iV] /= := boolP (i \in V k); last by rewrite big1 // => l _; rewrite mxE (negPf iV) mul0r.
case jW: (j \in W); last by rewrite big1 // => l _; rewrite !mxE jW andbF mulr0.
rewrite mxE; apply: eq_bigr => l _; rewrite [X in _ = X * _]mxE [X in _ = _ * X]mxE iV jW andbT /=.
by case lV: (l \in V k) => //; rewrite /pprod cut_prod ?lV // !mul0r.
Qed.
Lemma product_chain k t : (0 < k)%N -> (T k < t)%N ->
  on (V k) (V 0%N) (pprod P t s) = on (V k) (V k) (pprod P t (T k).+1) *m chain P T V k.
Proof.
case: (S) => Ts _ _; have sT m : (s <= T m.+1)%N.
  by rewrite -Ts; elim: m => [|m IH]; [exact: T_next | exact: leq_trans IH (ltnW (T_next _))].
case: k => // k _; elim: k t => [|k IH] t Tt; first by rewrite on_step // -Ts.
rewrite on_step //; congr (_ *m _).
have := IH _ (T_next k.+1); move=> /matrixP E; apply/matrixP=> i j.
have -> : chain P T V k.+2 = on (V k.+2) (V k.+1) (pprod P (T k.+2) (T k.+1).+1) *m chain P T V k.+1 by [].
rewrite mxE [RHS]mxE; have [iV|iV] /= := boolP (i \in V k.+2); last by rewrite big1 // => l _; rewrite mxE (negPf iV) mul0r.
have := E i j; rewrite mxE [X in _ = X -> _]mxE (sub_next iV) /= => ->.
by apply: eq_bigr => l _; rewrite [X in X * _ = _]mxE [X in _ = X * _]mxE iV (sub_next iV).
Qed.
End Stages.
Lemma model_P (R : realFieldType) n (G : nat -> rel 'I_n) (c : nat -> 'I_n -> R) : (forall t, (0 < t)%N -> network (G t)) ->
  (forall t, (0 < t)%N -> model_D (G t) (c t)) -> (forall t i j, (0 < t)%N -> 0 <= transition (G t) (c t) i j) /\
  forall t i j, (0 < t)%N -> transition (G t) (c t) i j != 0 -> transition (G t) (c t) j i != 0.
Proof.
move=> net MD; split=> t i j t0; have [[p0 _] _] := model_D_stochastic (net t t0) (MD t t0); first exact: p0.
have [sy _] := net t t0; by rewrite !(transition_edge _ _ (net t t0) (MD t t0)) eq_sym sy.
Qed.
Lemma eq3_5_2_holds : eq3_5_2.
Proof. by move=> R n G c s T V b _ net MD P S k t; have [A B] := model_P net MD; apply: (product_chain A B S). Qed.
Lemma count_3_holds : count_3.
Proof.
move=> R n G P T V b net MD S k k0 last t.
have ft w i j : (0 < w)%N -> (P w i j != 0) = (i == j) || G w i j.
  move=> w0; have [p0 [_ [dg foot]]] := MD w w0; case: (i =P j) => [->|/eqP ne]; first by rewrite gt_eqF.
  by rewrite -foot // lt_def p0 andbT.
have Pp w i j : (0 < w)%N -> 0 <= P w i j by move=> w0; have [p0 _] := MD w w0.
have Ps w i j : (0 < w)%N -> P w i j != 0 -> P w j i != 0 by move=> w0; have [sy _] := net w w0; rewrite !ft // eq_sym sy.
have Tn := T_next S.
have T0 : T 0%N = 0%N by case: (S) => [[]].
pose ch := A.differs G; pose N := chazelle_stabilisers.N.
have mono l m : (l <= m)%N -> (T l <= T m)%N.
  by elim: m => [|m IH]; [rewrite leqn0 => /eqP-> | rewrite leq_eqVlt => /orP[/eqP-> //|/IH h]; exact: leq_trans h (ltnW (Tn m))].
have T1 : (0 < T 1)%N by rewrite -[X in (X < _)%N]T0.
have -> : A.switches_up_to G t = N ch t 1%N by rewrite /A.switches_up_to /N /chazelle_stabilisers.N subn1.
change (N ch t 1%N <= \sum_(2 <= l < k.+1) N ch (T l) (T l.-1) + N ch (T 1%N) 1%N + 1 + 'C(#|V k|, 2)
  + changes_outside G (V k) t (T k).+1)%N.
have upto : (N ch (T k) 1 = \sum_(2 <= l < k.+1) N ch (T l) (T l.-1) + N ch (T 1) 1)%N.
  elim: (k) k0 => // -[|m] IH _; first by rewrite big_geq.
  rewrite big_nat_recr //= addnAC -IH //; exact: (chazelle_stabilisers.N_split _ (leq_trans T1 (mono 1%N m.+1 _)) (mono m.+1 m.+2 _)).
have [tk|kt] := leqP t (T k).+1.
  apply: leq_trans (leq_addr _ _); apply: leq_trans (leq_addr _ _); rewrite -upto.
  apply: leq_trans (chazelle_switches.N_next _ _ _).
  have [t1|t1] := leqP t 1; first by rewrite /N chazelle_switches.N_empty.
  by rewrite /N (chazelle_stabilisers.N_split _ (ltnW t1) tk) leq_addr.
have s1 : (1 <= (T k).+1)%N by [].
rewrite /N (chazelle_stabilisers.N_split _ s1 (ltnW kt)) -/N -upto -addnA; apply: leq_add; first exact: chazelle_switches.N_next.
pose G' u (i j : 'I_#|V k|) := G u.-1.+1 (enum_val i) (enum_val j).
have grow : (N (chazelle_switches.changes_in G (V k)) t (T k).+1 <= 'C(#|V k|, 2))%N.
  have -> : N (chazelle_switches.changes_in G (V k)) t (T k).+1 = N (chazelle_count.changes G') t (T k).+1.
    apply: eq_in_count => u; rewrite mem_iota => /andP[uT _]; rewrite chazelle_switches.changes_inP.
    by case: u uT => [|[|u]].
  apply: chazelle_switches.growing => [u|u i j uT].
    by have [sy ir] := net u.-1.+1 isT; split=> [i j|i]; [exact: sy | exact: ir].
  by case: u uT => // u uT; apply: last; rewrite ?enum_valP.
apply: leq_trans (leq_add grow (leqnn _)); rewrite /N /chazelle_stabilisers.N /changes_outside -count_predUI; apply: leq_trans (leq_addr _ _).
apply: chazelle_switches.count_in => u; rewrite mem_iota => /andP[uT _] /existsP[x /existsP[y ne]] /=.
have uk : (T k < u)%N by exact: ltn_trans uT.
have uk' : (T k < u.-1)%N by move: uT; clear; lia.
have un w i j : (T k < w)%N -> i \in V k -> j \notin V k -> G w i j = false.
  move=> wT iV jV; have w0 : (0 < w)%N by apply: leq_ltn_trans wT.
  have /eqP := cut Pp Ps S wT iV jV; rewrite -[_ == 0]negbK (ft w i j w0).
  by rewrite negb_or => /andP[_ /negbTE].
have [y1 _] := net u (leq_ltn_trans (leq0n _) uk); have [y2 _] := net u.-1 (leq_ltn_trans (leq0n _) uk').
case xS: (x \in V k); case yS: (y \in V k).
- by apply/orP; left; apply/exists_inP; exists x => //; apply/exists_inP; exists y.
- by rewrite !un ?yS ?eqxx in ne.
- by rewrite y1 [G u.-1 x y]y2 !un ?xS ?eqxx in ne.
by apply/orP; right; apply/existsP; exists x; apply/existsP; exists y; rewrite xS yS.
Qed.
(* (3.16): the birds that bird f a is connected with are a flock in the sense of the other file, whose rows of a step are those of the
   flock alone *)
Lemma flock_of n m (G : rel 'I_n) (f : 'I_m.+1 -> 'I_n) a : symmetric G -> injective f ->
  (forall i, connect G (f a) i = (i \in codom f)) -> A.is_flock f G.
Proof.
move=> sy fi C; have closed k j : G (f k) j -> exists l, f l = j.
  move=> kj; have /codomP[l ->] : j \in codom f; last by exists l.
  by rewrite -C; apply: connect_trans (connect1 kj); rewrite C codom_f.
have lift p k l : path G (f k) p -> f l = last (f k) p -> connect (A.own_network f G) k l.
  elim: p k => [|j p IH] k /=; first by move=> _ /fi ->; exact: connect0.
  move=> /andP[kj pth] e; have [k' fk] := closed k j kj; subst j.
  by apply: connect_trans (IH k' pth e); apply: connect1.
have from k : connect (A.own_network f G) a k.
  have /connectP[p pth e] : connect G (f a) (f k) by rewrite C codom_f.
  exact: lift pth e.
have sym : connect_sym (A.own_network f G) by apply: sym_connect_sym => i j; exact: sy.
by split=> // k l; apply: connect_trans (from l); rewrite sym.
Qed.
Lemma eq3_16_2_holds : eq3_16_2.
Proof.
move=> R n m d G c x v t1 t f a U lam tt un Hx Hv net MD fi C H cf P root unroot vf pi c0 orth eig lam1.
have FL : A.is_flock f (G t1) by case: (net) => sy _; exact: flock_of C.
pose u k := col k U.
have EB : A.eigenbasis H cf lam u.
  split=> // [k l|k].
    by move/matrixP/(_ k l): orth; rewrite !mxE => <-; apply: eq_bigr => i _; rewrite !mxE.
  rewrite /A.M_of -/P -/root -/unroot /u colE mulmxA eig; apply/colP => i.
  by rewrite -!colE mxE mul_mx_diag !mxE mulrC.
rewrite (A.Gamma_row net MD Hx Hv FL c0 EB a (ltnW tt) un); congr (_ - _); first by rewrite row_mul.
by apply: eq_bigr => k _; rewrite scalerA /A.Phi -rowE.
Qed.
Lemma losses_1_holds : losses_1.
Proof.
move=> R n d a x v G w n4 dn a12 F same X0 [|t] i j // late Gij.
have a0 : (0 < a <= 2)%N by case: a12 => ->.
have [G0 Gn Hx W] := F.
apply: (@chazelle_losses.losses R n d a x v G (A.from_0 G w) n4 dn a0 (A.flock_is F)) => //.
- by case=> // u p q _; case: (W u.+1 isT) => _ _ + _; apply.
- by case=> // u _ e; apply: same.
- by move=> p; have := A.flock_speed F p; rewrite expr1.
by rewrite !subn1; apply: ltnW.
Qed.

(* chazelle.lem3.6.ii, lem3.7 and lem3.8, written after the theorems; inputs and weights are rationals of b log n bits, the dimension is
   fixed, n is large enough.  Birds are joined at time 0 within unit distance, later within unit distance or where they were joined and their
   distance changes by less than n^(-n^4); v(t+1) = P(t) v(t), weights vary only when the network does. *)
Definition paper_flock (R : rcfType) b n d (x v : nat -> 'M[R]_(n, d)) (G : nat -> rel 'I_n) (w : nat -> 'I_n -> R) :=
  let dist t i j := Num.sqrt (\sum_q (x t i q - x t j q) ^+ 2) in
  [/\ (forall i j, G 0%N i j = (i != j) && (dist 0%N i j <= 1)) /\
      (forall t i j, G t.+1 i j = (i != j) && ((dist t.+1 i j <= 1) ||
        (G t i j && (`|dist t.+1 i j - dist t i j| < (n%:R ^+ (n ^ 4))^-1)))),
      forall t, x t.+1 = x t + v t.+1,
      forall t, (0 < t)%N -> model_D (G t) (w t) /\ v t.+1 = transition (G t) (w t) *m v t,
      forall t, (0 < t)%N -> (forall i j, G t.+1 i j = G t i j) -> forall i, w t.+1 i = w t i &
      [/\ short_input b (x 0%N), short_input b (v 1%N) & forall t, (0 < t)%N -> short_weights b (w t)]].
Definition lem3_6_ii : Prop := forall b d, exists n0, forall (R : rcfType) n (x v : nat -> 'M[R]_(n, d)) G w, (n0 <= n)%N ->
  paper_flock b x v G w -> forall t i j, 1 + (n%:R ^+ (n ^ 3))^-1 < Num.sqrt (\sum_q (x t i q - x t j q) ^+ 2) -> ~~ G t i j.
(* the length that the angle of the lifted birds does not exceed (audit_independent_angle.angle_1), at all times *)
Definition lem3_7 : Prop := forall b d, exists n0 K, forall (R : rcfType) n (x v : nat -> 'M[R]_(n, d)) G w, (n0 <= n)%N ->
  paper_flock b x v G w -> forall t i, (0 < t)%N ->
  Num.sqrt (\sum_q (v t i q - x t i q / t%:R) ^+ 2) <= n%:R ^+ (K * n ^ 3) / t%:R.
Definition lem3_8 : Prop := forall b d, exists n0, forall (R : rcfType) n (x v : nat -> 'M[R]_(n, d)) G w, (n0 <= n)%N ->
  paper_flock b x v G w -> forall t i j, (n ^ (2 * n ^ 4) < t)%N -> G t.-1 i j -> G t i j.
(* lazy and vicsek weights are such fractions with a = 2: the theorems hold for them with speeds up to n from n = 4 on *)
Lemma usual_weights_short (R : realFieldType) n (G : rel 'I_n) : (1 < n)%N -> network G -> short_weights 2 (lazy R G) /\ short_weights 2 (vicsek R G).
Proof.
move=> n1 [_ irr]; have dn i : (degree G i < n)%N.
  rewrite -[X in (_ < X)%N]card_ord; apply: proper_card; apply/properP; split; first by apply/subsetP.
  by exists i; rewrite // inE irr.
have sq : (n * 2 <= n ^ 2)%N by rewrite -mulnn leq_mul2l n1 orbT.
split.
  exists (fun i => if degree G i == 0%N then 0%N else 2%N), (fun i => if degree G i == 0%N then 1%N else (3 * degree G i)%N) => i; have := dn i.
  rewrite /lazy; case: (degree G i =P 0%N) => [->|/eqP d0] h.
    by split; rewrite ?mulr0n ?mulr0 ?invr0 ?mulr0 ?mul0r // expn_gt0 ltnW.
  split; [by rewrite natrM | by rewrite muln_gt0 /= lt0n d0 | move: h n1; rewrite -mulnn; nia].
exists (fun=> 1%N), (fun i => (degree G i).+1) => i; split=> //; first by rewrite /vicsek mul1r.
by apply: leq_trans (dn i) _; rewrite -mulnn leq_pmull // ltnW.
Qed.
Lemma distance_is (R : rcfType) n d (y : 'M[R]_(n, d)) i j : Num.sqrt (\sum_q (y i q - y j q) ^+ 2) = norm2 (row i y - row j y).
Proof. by congr Num.sqrt; apply: eq_bigr => q _; rewrite !mxE. Qed.
(* n0 = b + b + d + 6: the theorems with a = b + 1, c = b + 1 *)
Lemma paper_is (R : rcfType) b n d (x v : nat -> 'M[R]_(n, d)) G w : (b + b + d + 6 <= n)%N -> paper_flock b x v G w ->
  [/\ (4 <= n)%N /\ (b.+1 + b.+1 < n)%N, chazelle_switches.flock (n%:R ^- (n ^ 4)) x v G (A.from_0 G w),
      (forall t, (0 < t)%N -> short_weights b.+1 (A.from_0 G w t)) /\
        (forall t, (0 < t)%N -> (forall i j, G t.+1 i j = G t i j) -> forall i, A.from_0 G w t.+1 i = A.from_0 G w t i),
      forall i, norm2 (row i (v 1%N)) <= n%:R ^+ b.+1 &
      (d <= n ^ 2)%N /\ forall i q, `|x 0%N i q| <= n%:R ^+ b.+1].
Proof.
move=> big [[G0 Gn] Hx HD st [[zx [qx X]] [zv [qv V]] W]].
have n0 : (0 < n)%N by apply: leq_trans big; rewrite addnS.
have n1 : (n ^ b <= n ^ b.+1)%N by apply: leq_pexp2l.
have dn : (d <= n ^ 2)%N by apply: (@leq_trans n); [lia | rewrite -{1}[n]expn1; apply: leq_pexp2l].
have le y (z : int) q : y = z%:~R / q%:R -> (0 < q)%N -> (`|z| <= n ^ b)%N -> `|y| <= (n%:R : R) ^+ b.
  move=> -> q0 zb; rewrite normrM normfV normr_nat ler_pdivr_mulr ?ltr0n //.
  rewrite -intr_norm -abszE -natrX -natrM -[X in X <= _]/(`|z|%N%:R) ler_nat.
  by apply: leq_trans zb _; rewrite leq_pmulr.
have net t : network (G t).
  elim: t => [|t [sy ir]]; split=> [i j|i]; rewrite ?G0 ?Gn ?eqxx // !distance_is eq_sym.
    by rewrite -norm2N opprB.
  by rewrite sy -norm2N opprB -[X in `|_ - X|]norm2N opprB.
split.
- by split; lia.
- split=> // [i j|t i j|[|t]|[|t]] //; rewrite ?G0 ?Gn ?distance_is //; first exact: vicsek_model_D.
    by case: (HD t.+1 isT).
  by move=> _; case: (HD t.+1 isT).
- split=> [[|t] // _|[|t] // _]; last exact: (st t.+1 isT).
  have [p [q H]] := W t.+1 isT; exists p, q => i; have [e q0 qb] := H i; split=> //; exact: leq_trans qb n1.
- move=> i; rewrite exprS; apply: chazelle_losses.norm2_le => // [|q]; first by rewrite exprn_ge0 ?ler0n.
  by rewrite mxE; have [e q0 _ zb] := V i q; exact: le e q0 zb.
split=> // i q; have [e q0 _ zb] := X i q; apply: (le_trans (le _ _ _ e q0 zb)).
by rewrite -!natrX ler_nat.
Qed.
Lemma lem3_6_ii_holds : lem3_6_ii.
Proof.
move=> b d; exists (b + b + d + 6)%N => R n x v G w big /(paper_is big)[[n4 acn] F [W st] V _] t i j; rewrite distance_is.
exact: (@chazelle_losses.lemma_3_6_ii R n d b.+1 b.+1 x v G _ n4 isT acn F W st V).
Qed.
Lemma lem3_7_holds : lem3_7.
Proof.
move=> b d; exists (b + b + d + 6)%N, (4 * b + 23)%N => R n x v G w big /(paper_is big)[[n4 acn] F [W st] V [dn X]] t i t0.
have tR : 0 < t%:R :> R by rewrite ltr0n.
rewrite ler_pdivl_mulr // mulrC.
have -> : t%:R * Num.sqrt (\sum_q (v t i q - x t i q / t%:R) ^+ 2) = norm2 (row i (x t) - t%:R *: row i (v t)) :> R.
  have -> : row i (x t) - t%:R *: row i (v t) = t%:R *: (\row_q (x t i q / t%:R - v t i q)).
    by apply/rowP => q; rewrite !mxE mulrBr mulrCA divff ?gt_eqF // mulr1.
  rewrite norm2Z gtr0_norm //; congr (_ * Num.sqrt _); apply: eq_bigr => q _.
  by rewrite !mxE -sqrrN opprB.
apply: (le_trans (@chazelle_losses.lemma_3_7_origins R n d b.+1 b.+1 x v G _ n4 isT acn F W st V dn X t i t0)).
apply: ler_weexpn2l; first by rewrite ler1n (leq_trans _ n4).
have n0 : (0 < n)%N by exact: leq_trans n4.
have p1 : (n.-1 <= n ^ 3)%N by apply: leq_trans (leq_pred n) _; rewrite -{1}[n]expn1; apply: leq_pexp2l.
have p2 : (n.-1 ^ 2 <= n ^ 3)%N by apply: (@leq_trans (n ^ 2)); [rewrite leq_exp2r // leq_pred | apply: leq_pexp2l].
have p0 : (1 <= n ^ 3)%N by rewrite expn_gt0 n0.
rewrite subn1; move: (n.-1) (n.-1 ^ 2)%N (n ^ 3)%N p0 p1 p2 => m s N N1 mN sN.
have h1 : (b.+1 * s <= b.+1 * N)%N by rewrite leq_mul2l sN orbT.
have h2 : ((b.+1 + 9) * m <= (b.+1 + 9) * N)%N by rewrite leq_mul2l mN orbT.
have h3 : (2 * b.+1 + 10 <= (2 * b.+1 + 10) * N)%N by rewrite leq_pmulr.
have -> : ((4 * b + 23) * N = b.+1 * N + (b.+1 + 9) * N + (2 * b.+1 + 10) * N)%N by rewrite -!mulnDl; congr (_ * _)%N; lia.
by rewrite -addnA; apply: leq_add => //; exact: leq_add.
Qed.
Lemma lem3_8_holds : lem3_8.
Proof.
move=> b d; exists (b + b + d + 6)%N => R n x v G w big /(paper_is big)[[n4 acn] F [W st] V [dn X]] [|t] i j // late.
exact: (@chazelle_losses.lemma_3_8 R n d b.+1 b.+1 x v G _ n4 isT acn F W st V dn X t i j (ltnW late)).
Qed.

(* chazelle.eq3.18, written after the theorem: birds f i and g j of two flocks that have n birds at most together, or of one flock (f = g), with
   B = 0 and |A| = 1; terms are the mu_k with the Psi_k of (3.17) *)
Definition in_3_18 (R : rcfType) n d m m' (x v : nat -> 'M[R]_(n, d)) G w t1 (f : 'I_m.+1 -> 'I_n) (g : 'I_m'.+1 -> 'I_n) i j : Prop :=
  let c := fun k => w t1 (f k) in let c' := fun k => w t1 (g k) in
  let Gf := A.own_network f (G t1) in let Gg := A.own_network g (G t1) in
  let v1 := A.own_rows f (v t1.+1) in let v1' := A.own_rows g (v t1.+1) in
  let A0 := row (f i) (x t1) - row (g j) (x t1) + (row i (A.Gamma_of Gf c *m v1) - row j (A.Gamma_of Gg c' *m v1')) in
  A.y_of c v1 = A.y_of c' v1' -> Num.sqrt (\sum_q A0 0 q ^+ 2) = 1 ->
  exists (terms : seq (R * 'rV[R]_d)) (rho : seq R) (up um : R -> R),
  [/\ forall p, p \in terms -> `|p.1| < 1 /\ (A.is_eigenvalue (transition Gf c) p.1 \/ A.is_eigenvalue (transition Gg c') p.1),
    sorted (fun r r' => r' < r) rho /\ (forall r, r \in rho -> 0 < r < 1),
    forall r, (r \in rho) <-> r != 0 /\ ((exists2 p, p \in terms & r = `|p.1|) \/ exists p q, [/\ p \in terms, q \in terms & r = `|p.1 * q.1|]),
    (size rho < n ^ 2)%N &
    forall t, (t1 < t)%N -> A.unchanged G w t1 t ->
      row (f i) (x t) - row (g j) (x t) = A0 - \sum_(p <- terms) p.1 ^+ (t - t1) *: p.2 /\
      \sum_q (x t (f i) q - x t (g j) q) ^+ 2 - 1 = \sum_(r <- rho) (up r + (-1) ^+ t * um r) * r ^+ (t - t1)].
Definition eq3_18 : Prop := forall (R : rcfType) n d m m' (x v : nat -> 'M[R]_(n, d)) G w t1
  (f : 'I_m.+1 -> 'I_n) (g : 'I_m'.+1 -> 'I_n) lam u lam' u' i j,
  A.motion_D x v G w -> (0 < t1)%N -> A.is_flock f (G t1) -> A.is_flock g (G t1) -> (forall k, 0 < w t1 (f k)) -> (forall k, 0 < w t1 (g k)) ->
  A.eigenbasis (A.own_network f (G t1)) (fun k => w t1 (f k)) lam u -> A.eigenbasis (A.own_network g (G t1)) (fun k => w t1 (g k)) lam' u' ->
  (forall k l, f k <> g l) -> in_3_18 x v G w t1 f g i j.
Definition eq3_18_one : Prop := forall (R : rcfType) n d m (x v : nat -> 'M[R]_(n, d)) G w t1 (f : 'I_m.+1 -> 'I_n) lam u i j,
  A.motion_D x v G w -> (0 < t1)%N -> A.is_flock f (G t1) -> (forall k, 0 < w t1 (f k)) ->
  A.eigenbasis (A.own_network f (G t1)) (fun k => w t1 (f k)) lam u -> in_3_18 x v G w t1 f f i j.
(* a matrix of order m + 1 with the eigenvalue 1 has at most m others *)
Lemma others_few (R : realFieldType) m (P : 'M[R]_m.+1) (s : seq R) : (forall i, \sum_j P i j = 1) -> uniq s ->
  (forall y, y \in s -> y != 1 /\ A.is_eigenvalue P y) -> (size s <= m)%N.
Proof.
move=> P1 un ev; have root_of y (z : 'cV[R]_m.+1) : z != 0 -> P *m z = y *: z -> root (char_poly P^T) y.
  move=> z0 E; rewrite -eigenvalue_root_char; apply/eigenvalueP; exists z^T; last by rewrite trmx_eq0.
  by rewrite -trmx_mul E linearZ.
pose s1 : seq R := 1 :: s; suff H : (size s1 < size (char_poly P^T))%N by move: H; rewrite size_char_poly /= !ltnS.
apply: max_poly_roots.
- by rewrite monic_neq0 // char_poly_monic.
- apply/andP; split; last by apply/allP => y /ev[_ [z [z0 E]]]; exact: root_of z0 E.
  apply: (root_of 1 (const_mx 1)); last by apply/colP => i; rewrite !mxE mul1r -[RHS](P1 i); apply: eq_bigr => k _; rewrite mxE mulr1.
  by apply/eqP => /matrixP/(_ ord0 ord0) /eqP; rewrite !mxE oner_eq0.
by rewrite /s1 /= un andbT; apply/negP => /ev[]; rewrite eqxx.
Qed.
Lemma in_3_18_holds (R : rcfType) n d m m' (x v : nat -> 'M[R]_(n, d)) G w t1 (f : 'I_m.+1 -> 'I_n) (g : 'I_m'.+1 -> 'I_n) lam u lam' u' i j :
  A.motion_D x v G w -> (0 < t1)%N -> A.is_flock f (G t1) -> A.is_flock g (G t1) -> (forall k, 0 < w t1 (f k)) -> (forall k, 0 < w t1 (g k)) ->
  A.eigenbasis (A.own_network f (G t1)) (fun k => w t1 (f k)) lam u -> A.eigenbasis (A.own_network g (G t1)) (fun k => w t1 (g k)) lam' u' ->
  (forall s : seq R, uniq s -> (forall y, y \in s -> y != 1 /\ (A.is_eigenvalue (transition (A.own_network f (G t1)) (fun k => w t1 (f k))) y \/
    A.is_eigenvalue (transition (A.own_network g (G t1)) (fun k => w t1 (g k))) y)) -> (size s < n)%N) -> in_3_18 x v G w t1 f g i j.
Proof.
move=> MO t10 FL FL' w0 w0' EB EB' few c c' Gf Gg v1 v1' A0 B0 A1.
have [terms [_ ev E]] := A.eq3_17_proved i j MO t10 FL FL' w0 w0' EB EB'.
pose mu := [seq p.1 | p <- terms]; have inmu p : p \in terms -> p.1 \in mu by exact: map_f.
have [up [um X]] := @chazelle_distances.expansion R d A0 terms mu inmu A1 t1.
exists terms, (chazelle_distances.moduli mu), up, um; split=> //.
- split; first exact: chazelle_distances.moduli_sorted.
  by apply: chazelle_distances.moduli_range => y /mapP[p pm ->]; case: (ev p pm).
- move=> r; rewrite chazelle_distances.in_moduli; split.
    move/andP=> [r0 H]; split=> //; case/orP: H => [/mapP[y /mapP[p pm ->] ->]|/allpairsP[[y z] /= [/mapP[p pm ->] /mapP[q qm ->] ->]]].
      by left; exists p.
    by right; exists p, q.
  move=> [-> H] /=; case: H => [[p pm ->]|[p [q [pm qm ->]]]]; first by rewrite map_f // inmu.
  by apply/orP; right; apply/allpairsP; exists (p.1, q.1); rewrite !inmu.
- have le : (size (undup mu) < n)%N.
    apply: few (undup_uniq _) _ => y; rewrite mem_undup => /mapP[p pm ->]; have [lt e] := ev p pm; split=> //.
    by apply: contraTneq lt => ->; rewrite normr1 ltxx.
  rewrite -(ltn_pmul2l (isT : 0 < 2)%N); exact: leq_ltn_trans (chazelle_distances.moduli_few (leqnn _)) (chazelle_distances.fewer le).
move=> t tt un; have := E t (ltnW tt) un; rewrite B0 subrr scaler0 addr0 => D; split=> //.
have s0 : (0 < t - t1)%N by rewrite subn_gt0.
have := X (t - t1)%N s0; rewrite subnKC ?(ltnW tt) // -D norm2_sqr => <-; congr (_ - 1); apply: eq_bigr => q _.
by rewrite !mxE.
Qed.
Lemma flock_rows (R : rcfType) n d m (x v : nat -> 'M[R]_(n, d)) G w t1 (f : 'I_m.+1 -> 'I_n) : A.motion_D x v G w -> (0 < t1)%N -> A.is_flock f (G t1) ->
  (forall k, 0 < w t1 (f k)) -> forall i, \sum_j transition (A.own_network f (G t1)) (fun k => w t1 (f k)) i j = 1.
Proof. by move=> [/(_ t1) MD _ _] t10 FL w0 i; have [net D] := MD t10; have [nf _ _ _] := A.own_fixed FL net D w0; exact: transition_row_sum. Qed.
Lemma eq3_18_holds : eq3_18.
Proof.
move=> R n d m m' x v G w t1 f g lam u lam' u' i j MO t10 FL FL' w0 w0' EB EB' fg; apply: (in_3_18_holds MO t10 FL FL' w0 w0' EB EB').
move=> s un ev; have R1 := flock_rows MO t10 FL w0; have R2 := flock_rows MO t10 FL' w0'.
pose P1 := transition (A.own_network f (G t1)) (fun k => w t1 (f k)).
pose a := [seq y <- s | eigenvalue P1^T y]; pose b := [seq y <- s | ~~ eigenvalue P1^T y].
have is_ev k (P : 'M[R]_k) y : A.is_eigenvalue P y <-> eigenvalue P^T y.
  split=> [[z [z0 E]]|/eigenvalueP[z E z0]].
    by apply/eigenvalueP; exists z^T; [rewrite -trmx_mul E linearZ | rewrite trmx_eq0].
  by exists z^T; rewrite trmx_eq0 z0; split=> //; rewrite -[P]trmxK -trmx_mul E linearZ.
have sa : (size a <= m)%N.
  apply: (others_few R1) => [|y]; first exact: filter_uniq.
  by rewrite mem_filter => /andP[e /ev[y1 _]]; split=> //; apply/is_ev.
have sb : (size b <= m')%N.
  apply: (others_few R2) => [|y]; first exact: filter_uniq.
  by rewrite mem_filter => /andP[e /ev[y1 [/is_ev h|h]]]; [rewrite h in e | split].
have all : size s = (size a + size b)%N by rewrite /a /b !size_filter count_predC.
have birds : (m.+1 + m'.+1 <= n)%N.
  have [fi _ _] := FL; have [gi _ _] := FL'.
  pose h (k : 'I_m.+1 + 'I_m'.+1) := match k with inl k => f k | inr k => g k end.
  have hi : injective h by move=> [k|k] [l|l] /= e; [rewrite (fi _ _ e) | case: (fg _ _ e) | case: (fg _ _ (esym e)) | rewrite (gi _ _ e)].
  by have := leq_card h hi; rewrite card_sum !card_ord.
by rewrite all; lia.
Qed.
Lemma eq3_18_one_holds : eq3_18_one.
Proof.
move=> R n d m x v G w t1 f lam u i j MO t10 FL w0 EB; apply: (in_3_18_holds MO t10 FL FL w0 w0 EB EB).
move=> s un ev; have R1 := flock_rows MO t10 FL w0; have [fi _ _] := FL.
have le : (m.+1 <= n)%N by have := leq_card f fi; rewrite !card_ord.
by apply: leq_trans le; rewrite ltnS; apply: (others_few R1) => // y /ev[y1 [e|e]].
Qed.

(* chazelle.eq3.7 clause 2, written after the theorem: the list of the eigenvalues with their multiplicities, from the largest to the smallest *)
Definition eq3_7_2 : Prop := forall (R : rcfType) m (G : rel 'I_m.+1) (c : 'I_m.+1 -> R), A.fixed G c ->
  exists s : seq R, [/\ size s = m.+1, char_poly (A.M_of G c) = \prod_(x <- s) ('X - x%:P), sorted (fun x y => y <= x) s,
    nth 0 s 0 = 1 /\ (forall k, (0 < k < m.+1)%N -> nth 0 s k < 1) & forall x, x \in s -> - 1 <= x].
Lemma eq3_7_2_holds : eq3_7_2.
Proof.
move=> R m G c [net MD con c0]; rewrite A.M_is.
have [lam [-> first less dec low]] := chazelle_eigenvalues.eigenvalues_in_order net MD con c0.
pose s := [tuple lam i | i < m.+1]; have nthE (k : 'I_m.+1) : nth 0 s k = lam k by rewrite (nth_mktuple _ _ k).
have at_ k (h : (k < m.+1)%N) : nth 0 s k = lam (Ordinal h) by rewrite -nthE.
exists s; split; first by rewrite size_tuple.
- by rewrite big_tuple; apply: eq_bigr => i _; rewrite tnth_mktuple.
- apply/(sortedP 0) => k; rewrite size_tuple => h; rewrite (at_ _ h) (at_ _ (ltnW h)); by apply: dec; rewrite /= leqnSn.
- split=> [|k /andP[k0 h]]; first by rewrite -first -(nthE ord0).
  by rewrite (at_ _ h); apply: less; rewrite -val_eqE /= -lt0n.
by move=> x /tnthP[k ->]; rewrite tnth_mktuple.
Qed.
