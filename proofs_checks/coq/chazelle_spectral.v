(* Chazelle, section 3: the symmetric matrix M, the spectral form of P^s, and the closed forms in the proof of
   Lemma 3.9.
     chazelle.eq3.7, chazelle.eq3.8, chazelle.xi.closed, chazelle.eq3.16, chazelle.eq3.17.
   Over any real closed field (square roots; the real numbers are one).  An orthonormal basis u_k of eigenvectors of
   M with u_1 = sqrt(pi) is taken as given (it exists by the spectral theorem, which is not proved here); everything
   else is proved for any such basis.  The printed index k = 1 is the index 0 here.  No axioms. *)
Set Warnings "-notation-overridden,-ambiguous-paths".
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import ring zify.
From Flockproof Require Import chazelle_model chazelle_ergodicity chazelle_fixed chazelle_network chazelle_limits.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Import GRing.Theory Num.Theory Order.Theory.
Local Open Scope ring_scope.

Section Spectral.
Variables (R : rcfType) (m : nat).
Notation n := m.+1.
Variables (G : rel 'I_n) (c : 'I_n -> R).
Hypothesis net : network G.
Hypothesis MD : model_D G c.
Hypothesis conn : forall i j, connect G i j.
Hypothesis c0 : forall i, 0 < c i.
Notation P := (transition G c).
Notation pi := (stat c).
Notation root i := (Num.sqrt (c i)).

Lemma root_gt0 i : 0 < root i. Proof. by rewrite sqrtr_gt0. Qed.
Lemma root_neq0 i : root i != 0. Proof. by rewrite gt_eqF ?root_gt0. Qed.
Lemma root_sqr i : root i * root i = c i. Proof. by rewrite -expr2 sqr_sqrtr // ltW. Qed.

Lemma root_c i : (root i)^-1 * c i = root i.
Proof. by apply: (mulfI (root_neq0 i)); rewrite mulVKf ?root_neq0 // root_sqr. Qed.

(* M = C^{-1/2} P C^{1/2} *)
Definition M : 'M[R]_n := \matrix_(i, j) ((root i)^-1 * P i j * root j).
Lemma ME i j : M i j = (root i)^-1 * P i j * root j. Proof. by rewrite mxE. Qed.
Definition u1 (i : 'I_n) : R := Num.sqrt (pi i).

Lemma M_laplacian i j : M i j = (i == j)%:R - root i * laplacian R G i j * root j.
Proof.
have [sym irr] := net; have PE : P i j = (i == j)%:R - c i * laplacian R G i j.
  rewrite transitionE // mxE; case: (i == j); first by [].
  by case: (G i j); rewrite ?mulrN1 ?mulr0 ?sub0r ?opprK ?oppr0.
rewrite ME PE mulrBr mulrBl; congr (_ - _).
  by case: (eqVneq i j) => [->|_]; rewrite ?mulr1 ?mulVf ?root_neq0 // mulr0 mul0r.
by rewrite mulrA root_c.
Qed.
Lemma laplacian_sym i j : laplacian R G i j = laplacian R G j i.
Proof. by have [sym _] := net; rewrite !mxE eq_sym sym; case: (eqVneq j i) => [->|]. Qed.
Lemma u1_root i : u1 i * root i = Num.sqrt (trace c)^-1.
Proof.
rewrite /u1 -sqrtrM ?(ltW (stat_gt0 c0 i)) //; congr Num.sqrt; by rewrite /stat mulfVK ?gt_eqF.
Qed.

(* chazelle.eq3.7: M is symmetric, it is I - C^{1/2} L C^{1/2}, u_1 belongs to 1, P has the same eigenvalues, and all
   others lie strictly between -1 and 1 *)
Theorem eq_3_7 :
  [/\ (forall i j, M i j = (i == j)%:R - root i * laplacian R G i j * root j), (forall i j, M i j = M j i),
      (forall i, \sum_j M i j * u1 j = u1 i) /\ \sum_i u1 i ^+ 2 = 1,
      (forall lam f, (forall i, \sum_j M i j * f j = lam * f i) <->
         (forall i, step G c (fun j => root j * f j) i = lam * (root i * f i))) &
      (forall lam f, (forall i, \sum_j M i j * f j = lam * f i) -> (exists i, f i != 0) -> lam = 1 \/ -1 < lam < 1)].
Proof.
have conj f i : step G c (fun j => root j * f j) i = root i * \sum_j M i j * f j.
  rewrite /step mulr_sumr; apply: eq_bigr => j _; by rewrite ME !mulrA mulfV ?root_neq0 // mul1r.
have same lam f : (forall i, \sum_j M i j * f j = lam * f i) <->
     (forall i, step G c (fun j => root j * f j) i = lam * (root i * f i)).
  split=> H i; first by rewrite conj H mulrCA.
  by apply: (mulfI (root_neq0 i)); rewrite -conj H mulrCA.
split=> //; first exact: M_laplacian.
- by move=> i j; rewrite !M_laplacian eq_sym (laplacian_sym i j); congr (_ - _); ring.
- split=> [i|].
    rewrite -[RHS]mul1r; apply: (proj2 (same 1 u1)) => k; rewrite mul1r.
    have E j : root j * u1 j = Num.sqrt (trace c)^-1 by rewrite mulrC u1_root.
    rewrite E /step (eq_bigr (fun j => P k j * Num.sqrt (trace c)^-1)) => [|j _]; last by rewrite E.
    by rewrite -mulr_suml transition_row_sum // mul1r.
  by rewrite -[RHS](stat_sum c0 (0 : 'I_n)); apply: eq_bigr => i _; rewrite sqr_sqrtr // ltW ?(stat_gt0 c0).
move=> lam f /same H [i fi]; have [_ _ _ _ [dom _]] := stationary net MD conn c0 (0 : 'I_n).
have nz : exists i, root i * f i != 0 by exists i; rewrite mulf_neq0 ?root_neq0.
case: (dom lam _ H nz) => [->|]; [by left | rewrite ltr_norml; by right].
Qed.

(* an orthonormal basis of eigenvectors, u_k = column k of U *)
Variables (U : 'M[R]_n) (lam : 'I_n -> R).
Hypothesis U_orth : U^T *m U = 1%:M.
Hypothesis U_eig : forall i k, \sum_j M i j * U j k = lam k * U i k.
Hypothesis U_first : forall i, U i 0 = u1 i.
Hypothesis lam_first : lam 0 = 1.

Lemma U_orth' i j : \sum_k U i k * U j k = (i == j)%:R.
Proof.
have /matrixP/(_ i j) := mulmx1C U_orth; rewrite !mxE => <-; by apply: eq_bigr => k _; rewrite mxE.
Qed.
Lemma power_M s i j : mpow P s i j = root i * (\sum_k lam k ^+ s * U i k * U j k) / root j.
Proof.
elim: s i => [|s IH] i.
  rewrite (eq_bigr (fun k => U i k * U j k)) => [|k _]; last by rewrite expr0 mul1r.
  rewrite U_orth' /= mxE; case: (eqVneq i j) => [->|_]; first by rewrite mulr1 mulfV ?root_neq0.
  by rewrite mulr0 mul0r.
rewrite /= mxE (eq_bigr (fun l => root i * (M i l * \sum_k lam k ^+ s * U l k * U j k) / root j)); last first.
  by move=> l _; rewrite IH ME; set S := \sum_k _; rewrite !mulrA mulfV ?root_neq0 // mul1r.
rewrite -mulr_suml -mulr_sumr; congr (_ * _ / _).
rewrite (eq_bigr (fun l => \sum_k lam k ^+ s * U j k * (M i l * U l k))); last first.
  by move=> l _; rewrite mulr_sumr; apply: eq_bigr => k _; ring.
rewrite exchange_big /=; apply: eq_bigr => k _; rewrite -mulr_sumr U_eig exprS; ring.
Qed.
Lemma first_term i j : root i * (U i 0 * U j 0) / root j = pi j.
Proof.
rewrite !U_first mulrA [root i * _]mulrC u1_root -mulrA.
have -> : u1 j / root j = Num.sqrt (trace c)^-1 / c j.
  rewrite -(u1_root j) -mulrA; congr (_ * _); apply: (mulfI (root_neq0 j)).
  by rewrite mulfV ?root_neq0 // mulrA root_sqr mulfV ?gt_eqF.
by rewrite mulrA -expr2 sqr_sqrtr ?invr_ge0 ?ltW ?(trace_gt0 c0 (0 : 'I_n)).
Qed.

(* chazelle.eq3.8, for every s >= 0 (0^0 = 1) *)
Theorem eq_3_8 s i j : mpow P s i j
  = pi j + \sum_(k | k != 0) lam k ^+ s * (root i * (U i k * U j k) / root j).
Proof.
rewrite power_M mulr_sumr mulr_suml (bigD1 (0 : 'I_n)) //= lam_first expr1n mul1r first_term; congr (_ + _).
by apply: eq_bigr => k _; ring.
Qed.
(* left and right eigenvectors; they form inverse matrices *)
Theorem eq_3_8_vectors :
  (forall k i, \sum_j P i j * (root j * U j k) = lam k * (root i * U i k)) /\
  (forall k j, \sum_i ((root i)^-1 * U i k) * P i j = lam k * ((root j)^-1 * U j k)) /\
  (forall k l, \sum_i ((root i)^-1 * U i k) * (root i * U i l) = (k == l)%:R).
Proof.
have [_ sym _ same _] := eq_3_7; split; last split.
- by move=> k; apply: (proj1 (same (lam k) (fun j => U j k))) => i; exact: U_eig.
- move=> k j; have PM i : (root i)^-1 * P i j = M i j / root j by rewrite ME mulfK ?root_neq0.
  rewrite (eq_bigr (fun i => (root j)^-1 * (M j i * U i k))) => [|i _]; last by rewrite mulrAC PM sym; ring.
  by rewrite -mulr_sumr U_eig mulrCA.
move=> k l; have /matrixP/(_ k l) := U_orth; rewrite !mxE => <-; apply: eq_bigr => i _.
by rewrite mxE mulrACA mulVf ?root_neq0 // mul1r.
Qed.

(* the other eigenvalues are not 1 *)
Lemma lam_neq1 k : k != 0 -> lam k != 1.
Proof.
move=> k0; apply/eqP => l1; have [_ _ _ same _] := eq_3_7.
have fix_ i : step G c (fun j => root j * U j k) i = root i * U i k.
  by rewrite -[RHS]mul1r -l1; apply: (proj1 (same (lam k) (fun j => U j k))) => i'; exact: U_eig.
have const := fixed_constant net MD conn c0 fix_.
have orth : \sum_i U i 0 * U i k = 0.
  have k0' : (0 == k) = false by rewrite eq_sym; exact: negbTE.
  have /matrixP/(_ 0 k) := U_orth; rewrite !mxE k0' mulr0n => h; rewrite -[RHS]h; apply: eq_bigr => i _; by rewrite mxE.
have unit_ : \sum_i U i k * U i k = 1.
  have /matrixP/(_ k k) := U_orth; rewrite !mxE eqxx mulr1n => h; rewrite -[RHS]h; apply: eq_bigr => i _; by rewrite mxE.
have zero : root 0 * U 0 k = 0.
  have pos : 0 < \sum_(i < n) U i 0 / root i.
    rewrite (bigD1 (0 : 'I_n)) //=; apply: ltr_paddr.
      by apply: sumr_ge0 => i _; rewrite U_first divr_ge0 ?sqrtr_ge0.
    by rewrite U_first divr_gt0 ?root_gt0 // sqrtr_gt0 (stat_gt0 c0).
  apply: (mulfI (lt0r_neq0 pos)); rewrite mulr0 -[RHS]orth mulr_suml; apply: eq_bigr => i _.
  by rewrite (const 0 i) mulrA divfK ?root_neq0.
have Uz i : U i k = 0 by apply: (mulfI (root_neq0 i)); rewrite (const i 0) zero mulr0.
by move: unit_; rewrite big1 => [/eqP|i _]; rewrite ?Uz ?mul0r // eq_sym oner_eq0.
Qed.
Lemma geometric_sum x t : x != 1 -> \sum_(s < t) x ^+ s = (1 - x ^+ t) / (1 - x) :> R.
Proof.
move=> x1; have y0 : 1 - x != 0 by rewrite subr_eq0 eq_sym.
elim: t => [|t IH]; first by rewrite big_ord0 expr0 subrr mul0r.
by rewrite big_ord_recr /= IH exprS; field.
Qed.

(* the flock from time t1 on *)
Section ClosedForms.
Variables (d : nat) (x v : nat -> 'M[R]_(n, d)) (t1 : nat).
Hypothesis Hx : forall t, (t1 <= t)%N -> x t.+1 = x t + v t.+1.
Hypothesis Hv : forall t, (t1 < t)%N -> v t.+1 = P *m v t.

Lemma flight_from tau : x (t1 + tau) = x t1 + (\sum_(s < tau) mpow P s) *m v t1.+1.
Proof.
have V s : v (t1 + s).+1 = mpow P s *m v t1.+1.
  elim: s => [|s IH]; first by rewrite addn0 mul1mx.
  by rewrite addnS Hv ?ltnS ?leq_addr // IH mulmxA.
elim: tau => [|s IH]; first by rewrite addn0 big_ord0 mul0mx addr0.
by rewrite addnS Hx ?leq_addr // IH V big_ord_recr /= mulmxDl addrA.
Qed.

(* y = (pi^T kron I) v(t1+1), Phi_k = (chi(i)^T C^1/2 u_k u_k^T C^-1/2 kron I) v(t1+1); coordinate q *)
Definition drift (q : 'I_d) : R := \sum_j pi j * v t1.+1 j q.
Definition Phi i k (q : 'I_d) : R := \sum_j (root i * (U i k * U j k) / root j) * v t1.+1 j q.

(* chazelle.xi.closed *)
Theorem xi_closed tau i q : x (t1 + tau) i q = x t1 i q + drift q *+ tau
  + \sum_(k | k != 0) (1 - lam k ^+ tau) / (1 - lam k) * Phi i k q.
Proof.
rewrite flight_from mxE -addrA; congr (_ + _).
rewrite mulmx_suml summxE (eq_bigr (fun s : 'I_tau => drift q + \sum_(k | k != 0) lam k ^+ s * Phi i k q)).
  rewrite big_split /= sumr_const card_ord; congr (_ + _); rewrite exchange_big /=.
  by apply: eq_bigr => k k0; rewrite -mulr_suml geometric_sum // lam_neq1.
move=> s _; rewrite mxE (eq_bigr (fun j => pi j * v t1.+1 j q
    + \sum_(k | k != 0) lam k ^+ s * ((root i * (U i k * U j k) / root j) * v t1.+1 j q))); last first.
  by move=> j _; rewrite eq_3_8 mulrDl mulr_suml; congr (_ + _); apply: eq_bigr => k _; rewrite -[LHS]mulrA.
rewrite big_split /=; congr (_ + _); rewrite exchange_big /=; apply: eq_bigr => k _.
by rewrite -mulr_sumr.
Qed.

(* Gamma = sum_{k >= 2} C^1/2 u_k u_k^T C^-1/2/(1 - lambda_k) *)
Lemma Gamma_spectral i j : Gamma G c i j = \sum_(k | k != 0) (root i * (U i k * U j k) / root j) / (1 - lam k).
Proof.
pose S : 'M[R]_n := \matrix_(i, j) \sum_(k | k != 0) (root i * (U i k * U j k) / root j) / (1 - lam k).
suff -> : Gamma G c = S by rewrite mxE.
have [_ [lft _]] := eq_3_8_vectors.
have SP : S *m (1%:M - P) = 1%:M - rank1 c.
  apply/matrixP=> a b; rewrite mulmxBr mulmx1 !mxE.
  have -> : \sum_(l < n) S a l * P l b = \sum_(k | k != 0) lam k * (root a * (U a k * U b k) / root b) / (1 - lam k).
    rewrite (eq_bigr (fun l => \sum_(k | k != 0) (root a * U a k / (1 - lam k)) * (((root l)^-1 * U l k) * P l b))).
      rewrite exchange_big /=; apply: eq_bigr => k _; rewrite -mulr_sumr lft; ring.
    by move=> l _; rewrite mxE mulr_suml; apply: eq_bigr => k _; ring.
  rewrite -sumrB big_ord1 !mxE mul1r.
  have := eq_3_8 0 a b; rewrite /= mxE => ->; rewrite addrAC subrr add0r; apply: eq_bigr => k k0.
  have y0 : 1 - lam k != 0 by rewrite subr_eq0 eq_sym lam_neq1.
  by rewrite expr0; field; rewrite y0 root_neq0.
have S1 : S *m ones R m = 0.
  apply/colP=> a; rewrite !mxE (eq_bigr (fun l => \sum_(k | k != 0) (root a * U a k / (1 - lam k)) * ((root l)^-1 * U l k))); last first.
    by move=> l _; rewrite !mxE mulr1; apply: eq_bigr => k _; ring.
  rewrite exchange_big /= big1 // => k k0; rewrite -mulr_sumr.
  have orth : \sum_i U i 0 * U i k = 0.
    have k0' : (0 == k) = false by rewrite eq_sym; exact: negbTE.
  have /matrixP/(_ 0 k) := U_orth; rewrite !mxE k0' mulr0n => h; rewrite -[RHS]h; apply: eq_bigr => i' _; by rewrite mxE.
  have w0 : Num.sqrt (trace c)^-1 != 0.
    by rewrite gt_eqF // sqrtr_gt0 invr_gt0 (trace_gt0 c0 (0 : 'I_n)).
  suff -> : \sum_(i < n) (root i)^-1 * U i k = 0 by rewrite mulr0.
  apply: (mulfI w0); rewrite mulr0 -[RHS]orth mulr_sumr; apply: eq_bigr => l _.
  by rewrite mulrA U_first -(u1_root l) mulfK ?root_neq0.
by rewrite /Gamma -S1 -SP -mul_last_col mulmxK // bordered_unit.
Qed.

(* chazelle.eq3.16, corrected: the sum starts at k = 2 (here: leaves out k = 0) *)
Theorem eq_3_16 tau i q : x (t1 + tau) i q = x t1 i q + (Gamma G c *m v t1.+1) i q + drift q *+ tau
  - \sum_(k | k != 0) lam k ^+ tau * (Phi i k q / (1 - lam k)).
Proof.
rewrite xi_closed -!addrA; congr (_ + _); rewrite [RHS]addrCA; congr (_ + _).
have -> : (Gamma G c *m v t1.+1) i q = \sum_(k | k != 0) Phi i k q / (1 - lam k).
  rewrite mxE (eq_bigr (fun j => \sum_(k | k != 0) (root i * (U i k * U j k) / root j) * v t1.+1 j q / (1 - lam k))).
    by rewrite exchange_big /=; apply: eq_bigr => k _; rewrite -mulr_suml.
  by move=> j _; rewrite Gamma_spectral mulr_suml; apply: eq_bigr => k _; rewrite mulrAC.
rewrite -sumrB; apply: eq_bigr => k _; ring.
Qed.
End ClosedForms.
End Spectral.

(* chazelle.eq3.17: birds i and i' of two flocks (or of one), each with its own data; the mu_k are the lam k and lam' k, k <> 0,
   all of modulus less than 1 *)
Theorem eq_3_17 (R : rcfType) d t1 tau (q : 'I_d)
  m (G : rel 'I_m.+1) (c : 'I_m.+1 -> R) (U : 'M[R]_m.+1) (lam : 'I_m.+1 -> R) (x v : nat -> 'M[R]_(m.+1, d)) (i : 'I_m.+1)
  m' (G' : rel 'I_m'.+1) (c' : 'I_m'.+1 -> R) (U' : 'M[R]_m'.+1) (lam' : 'I_m'.+1 -> R)
  (x' v' : nat -> 'M[R]_(m'.+1, d)) (i' : 'I_m'.+1) :
  network G -> model_D G c -> (forall a b, connect G a b) -> (forall a, 0 < c a) ->
  U^T *m U = 1%:M -> (forall a k, \sum_b M G c a b * U b k = lam k * U a k) -> (forall a, U a 0 = u1 c a) -> lam 0 = 1 ->
  (forall t, (t1 <= t)%N -> x t.+1 = x t + v t.+1) -> (forall t, (t1 < t)%N -> v t.+1 = transition G c *m v t) ->
  network G' -> model_D G' c' -> (forall a b, connect G' a b) -> (forall a, 0 < c' a) ->
  U'^T *m U' = 1%:M -> (forall a k, \sum_b M G' c' a b * U' b k = lam' k * U' a k) -> (forall a, U' a 0 = u1 c' a) -> lam' 0 = 1 ->
  (forall t, (t1 <= t)%N -> x' t.+1 = x' t + v' t.+1) -> (forall t, (t1 < t)%N -> v' t.+1 = transition G' c' *m v' t) ->
  let A := x t1 i q - x' t1 i' q + ((Gamma G c *m v t1.+1) i q - (Gamma G' c' *m v' t1.+1) i' q) in
  let B := drift c v t1 q - drift c' v' t1 q in
  x (t1 + tau)%N i q - x' (t1 + tau)%N i' q = A + B *+ tau
    - (\sum_(k | k != 0) Phi c U v t1 i k q / (1 - lam k) * lam k ^+ tau
       + \sum_(k | k != 0) - (Phi c' U' v' t1 i' k q / (1 - lam' k)) * lam' k ^+ tau).
Proof.
move=> n1 D1 k1 p1 o1 e1 f1 l1 X1 V1 n2 D2 k2 p2 o2 e2 f2 l2 X2 V2 A B.
rewrite (eq_3_16 n1 D1 k1 p1 o1 e1 f1 l1 X1 V1 tau i q) (eq_3_16 n2 D2 k2 p2 o2 e2 f2 l2 X2 V2 tau i' q).
have -> : \sum_(k | k != 0) Phi c U v t1 i k q / (1 - lam k) * lam k ^+ tau
    = \sum_(k | k != 0) lam k ^+ tau * (Phi c U v t1 i k q / (1 - lam k)).
  by apply: eq_bigr => k _; rewrite mulrC.
have -> : \sum_(k | k != 0) - (Phi c' U' v' t1 i' k q / (1 - lam' k)) * lam' k ^+ tau
    = - \sum_(k | k != 0) lam' k ^+ tau * (Phi c' U' v' t1 i' k q / (1 - lam' k)).
  by rewrite -sumrN; apply: eq_bigr => k _; rewrite mulNr mulrC.
rewrite /A /B mulrnBl; move: (\sum_(k | k != 0) _) (\sum_(k | k != 0) _) => S S'.
by move: (_ *+ tau) (_ *+ tau) => y y'; ring.
Qed.
