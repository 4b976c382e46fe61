(* Chazelle, Natural algorithms, sections 1 and 2: the matrices of the two models, products
   of them, footprints, and the Kronecker product.
     chazelle.modelD.stoch, chazelle.modelK.matrix, chazelle.foot.mono, chazelle.chi, chazelle.kron.
   A network G is any symmetric irreflexive relation on the n birds; P = I - C L; the coordinates of
   the birds are the rows of an n x d matrix, so that (P kron I_d) v is the matrix product P v
   (`stacked` proves that this is the same).  Everything over any ordered field, no axioms. *)
Set Warnings "-notation-overridden,-ambiguous-paths".
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import ring.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Import GRing.Theory Num.Theory Order.Theory.
Local Open Scope ring_scope.

Definition stochastic (R : realFieldType) m n (A : 'M[R]_(m, n)) : Prop :=
  (forall i k, 0 <= A i k) /\ (forall i, \sum_k A i k = 1).

Section Model.
Variables (R : realFieldType) (n : nat).
Implicit Types (G : rel 'I_n) (c : 'I_n -> R).

(* the number of neighbours; the Laplacian; P = I - C L *)
Definition degree G (i : 'I_n) : nat := #|[pred j | G i j]|.
Definition laplacian G : 'M[R]_n :=
  \matrix_(i, j) (if i == j then (degree G i)%:R else if G i j then -1 else 0).
Definition transition G c : 'M[R]_n := 1%:M - diag_mx (\row_i c i) *m laplacian G.

Definition network G := symmetric G /\ irreflexive G.
(* 0 < c_i d_i < 1; a bird without neighbours is exempt (its row is that of the identity) *)
Definition model_D G c := forall i, (0 < degree G i)%N -> 0 < c i * (degree G i)%:R < 1.
Definition vicsek G (i : 'I_n) : R := (degree G i).+1%:R^-1.

Lemma transitionE G c i j : irreflexive G ->
  transition G c i j = if i == j then 1 - c i * (degree G i)%:R else if G i j then c i else 0.
Proof.
move=> irr; rewrite !mxE (bigD1 i) //= big1 ?addr0; last first.
  by move=> k ki; rewrite !mxE eq_sym (negbTE ki) mulr0n mul0r.
rewrite !mxE eqxx mulr1n; case: (i =P j) => [->|_]; first by [].
by case: (G i j); rewrite ?mulrN1 ?mulr0 ?sub0r ?subr0 ?opprK ?oppr0.
Qed.

Lemma degree_sum G i : (degree G i)%:R = \sum_j (G i j)%:R :> R.
Proof.
rewrite /degree -sum1_card natr_sum big_mkcond /=; apply: eq_bigr => j _.
by rewrite inE; case: (G i j).
Qed.

Lemma edge_degree G i j : G i j -> (0 < degree G i)%N.
Proof. by move=> Gij; apply/card_gt0P; exists j; rewrite inE. Qed.

Lemma weight_gt0 G c i j : model_D G c -> G i j -> 0 < c i.
Proof.
move=> H Gij; have d0 := edge_degree Gij; have /andP[h _] := H i d0.
by rewrite pmulr_lgt0 ?ltr0n in h.
Qed.

Lemma transition_row_sum G c i : network G -> \sum_j transition G c i j = 1.
Proof.
move=> [_ irr]; rewrite (bigD1 i) //= transitionE // eqxx.
rewrite (eq_bigr (fun j => c i * (G i j)%:R)) => [|j ji]; last first.
  by rewrite transitionE // eq_sym (negbTE ji); case: (G i j); rewrite ?mulr1 ?mulr0.
by rewrite -mulr_sumr degree_sum (bigD1 i) //= irr add0r subrK.
Qed.

(* chazelle.modelD.stoch *)
Theorem model_D_stochastic G c : network G -> model_D G c ->
  stochastic (transition G c) /\ forall i, 0 < transition G c i i.
Proof.
move=> net H; have [sym irr] := net.
have diag i : 0 < transition G c i i.
  rewrite transitionE // eqxx; case d0: (0 < degree G i)%N.
    by have /andP[_ h] := H i d0; rewrite subr_gt0.
  by move/negbT: d0; rewrite lt0n negbK => /eqP->; rewrite mulr0 subr0 ltr01.
split=> //; split=> [i j|i]; last exact: transition_row_sum.
case: (i =P j) => [->|/eqP ij]; first exact: ltW.
rewrite transitionE // (negbTE ij); case: ifP => // Gij; exact: ltW (weight_gt0 H Gij).
Qed.

(* the positive entries off the diagonal are the edges *)
Lemma transition_edge G c i j : network G -> model_D G c ->
  (transition G c i j != 0) = (i == j) || G i j.
Proof.
move=> net H; have [sym irr] := net; have [_ diag] := model_D_stochastic net H.
case: (i =P j) => [<-|/eqP ij] /=; first by rewrite gt_eqF ?diag.
rewrite transitionE // (negbTE ij); case Gij: (G i j); last by rewrite eqxx.
by rewrite gt_eqF // (weight_gt0 H Gij).
Qed.

(* chazelle.modelK.matrix: the printed rule, as a matrix, and as I - C L *)
Theorem model_K_matrix G (theta : 'cV[R]_n) i : network G ->
  (transition G (vicsek G) *m theta) i 0
    = (theta i 0 + \sum_(j | G i j) theta j 0) / (degree G i).+1%:R
  /\ forall j, transition G (vicsek G) i j
       = if (i == j) || G i j then (degree G i).+1%:R^-1 else 0.
Proof.
move=> net; have [sym irr] := net.
have d0 : (degree G i).+1%:R != 0 :> R by rewrite pnatr_eq0.
have E j : transition G (vicsek G) i j = if (i == j) || G i j then (degree G i).+1%:R^-1 else 0.
  rewrite transitionE //; case: (i =P j) => [<-|_] //=; rewrite /vicsek.
  have -> : (degree G i)%:R = (degree G i).+1%:R - 1 :> R by rewrite [X in _ = X - 1]mulrSr addrK.
  by rewrite mulrBr mulVf // mulr1 opprB addrCA subrr addr0.
split=> //; rewrite mxE [RHS]mulrC mulrDr mulr_sumr (bigD1 i) //= E eqxx /=; congr (_ + _).
rewrite [RHS]big_mkcond [RHS](bigD1 i) //= irr add0r; apply: eq_bigr => j ji.
by rewrite E eq_sym (negbTE ji) /=; case: (G i j); rewrite ?mul0r.
Qed.

(* ---- products ---- *)
Section Products.
Variable P : nat -> 'M[R]_n.

(* span s k = P(s+k-1) ... P(s+1) P(s): k factors, the new one on the left *)
Fixpoint span s k : 'M[R]_n := if k is k'.+1 then P (s + k') *m span s k' else 1%:M.
(* P(t,s) for t >= s *)
Definition pprod t s := span s (t - s).+1.

Lemma pprod_self t : pprod t t = P t.
Proof. by rewrite /pprod subnn /= addn0 mulmx1. Qed.
Lemma pprod_next t s : (s <= t)%N -> pprod t.+1 s = P t.+1 *m pprod t s.
Proof. by move=> st; rewrite /pprod subSn //= addnS subnKC. Qed.

(* velocities: v(t+1) = P(t) v(t) for t >= 1 *)
Lemma velocities_span d (v : nat -> 'M[R]_(n, d)) :
  (forall t, (0 < t)%N -> v t.+1 = P t *m v t) -> forall k, v k.+1 = span 1 k *m v 1%N.
Proof.
move=> H; elim=> [|k IH]; first by rewrite mul1mx.
by rewrite H // IH mulmxA /= add1n.
Qed.

(* chazelle.chi, corrected: chi(i,j) is 1 at i and -1 at j *)
Definition chi (i j : 'I_n) : 'rV[R]_n := delta_mx 0 i - delta_mx 0 j.

Theorem chi_difference d (v : nat -> 'M[R]_(n, d)) i j k :
  (forall t, (0 < t)%N -> v t.+1 = P t *m v t) ->
  row i (v k.+1) - row j (v k.+1) = (chi i j *m span 1 k) *m v 1%N.
Proof.
by move=> H; rewrite -mulmxA -(velocities_span H) /chi mulmxBl -!rowE.
Qed.
End Products.

Lemma span_ext (P Q : nat -> 'M[R]_n) s k : (forall t, (s <= t)%N -> P t = Q t) -> span P s k = span Q s k.
Proof. by move=> E; elim: k => //= k ->; rewrite E ?leq_addr. Qed.

(* ---- footprints ---- *)
Definition footprint (A : 'M[R]_n) : 'I_n -> 'I_n -> bool := fun i j => A i j != 0.

Lemma mul_ge0 (A B : 'M[R]_n) : (forall i j, 0 <= A i j) -> (forall i j, 0 <= B i j) ->
  forall i j, 0 <= (A *m B) i j.
Proof. by move=> A0 B0 i j; rewrite mxE sumr_ge0 // => k _; rewrite mulr_ge0. Qed.

Lemma mul_ge_term (A B : 'M[R]_n) i k j : (forall i j, 0 <= A i j) -> (forall i j, 0 <= B i j) ->
  A i k * B k j <= (A *m B) i j.
Proof.
move=> A0 B0; rewrite mxE (bigD1 k) //= ler_addl sumr_ge0 // => l _; exact: mulr_ge0.
Qed.

Lemma span_ge0 (P : nat -> 'M[R]_n) s k : (forall t i j, 0 <= P t i j) ->
  forall i j, 0 <= span P s k i j.
Proof.
move=> P0; elim: k => [|k IH] i j /=; first by rewrite mxE ler0n.
exact: mul_ge0.
Qed.

(* chazelle.foot.mono: a one is never lost, and one factor has a symmetric footprint with a full diagonal *)
Theorem footprint_monotone (G : nat -> rel 'I_n) (c : nat -> 'I_n -> R) s k :
  (forall t, network (G t)) -> (forall t, model_D (G t) (c t)) ->
  let P t := transition (G t) (c t) in
  (forall i j, footprint (span P s k) i j -> footprint (span P s k.+1) i j) /\
  (forall t i j, footprint (P t) i j = footprint (P t) j i) /\
  (forall t i, footprint (P t) i i).
Proof.
move=> net H P; have S t := model_D_stochastic (net t) (H t).
have P0 t i j : 0 <= P t i j by have [[]] := S t.
split; last split.
- move=> i j; rewrite /footprint => nz; apply: lt0r_neq0.
  have /= := @mul_ge_term (P (s + k)%N) (span P s k) i i j (P0 _) (span_ge0 _ _ P0).
  apply: lt_le_trans; have [_ h] := S (s + k)%N.
  by apply: mulr_gt0; [exact: h | rewrite lt_def nz span_ge0].
- move=> t i j; rewrite /footprint !transition_edge //; have [-> _] := net t.
  by rewrite eq_sym.
by move=> t i; rewrite /footprint transition_edge // eqxx.
Qed.
End Model.


(* the footprint of a product need not be symmetric: edge 1-2 at time 1, edge 2-3 at time 2 *)
Section Asymmetric.
Variable R : realFieldType.
Definition pair3 (a b : nat) : rel 'I_3 :=
  fun i j => ((i == a :> nat) && (j == b :> nat)) || ((i == b :> nat) && (j == a :> nat)).
Definition meet (t : nat) : rel 'I_3 := if t == 1%N then pair3 0 1 else pair3 1 2.

Lemma meet_network t : network (meet t).
Proof.
by rewrite /meet; case: eqP => _; split=> [] [[|[|[|?]]] ?] // [[|[|[|?]]] ?].
Qed.

Lemma vicsek_model_D n (G : rel 'I_n) : @model_D R n G (vicsek R G).
Proof.
move=> i d0; rewrite /vicsek mulr_gt0 ?invr_gt0 ?ltr0n //=.
by rewrite ltr_pdivr_mull ?ltr0n // mulr1 ltr_nat.
Qed.

Theorem footprint_asymmetric :
  let P t := transition (meet t) (vicsek R (meet t)) in
  footprint (span P 1 2) (inord 2) (inord 0) /\ ~~ footprint (span P 1 2) (inord 0) (inord 2).
Proof.
move=> P.
have D t : @model_D R 3 (meet t) (vicsek R (meet t)) by exact: vicsek_model_D.
have S t := model_D_stochastic (meet_network t) (D t).
have P0 t i j : 0 <= P t i j by have [[]] := S t.
have nz t i j : (P t i j != 0) = (i == j) || meet t i j by exact: transition_edge (meet_network t) (D t).
have pos t i j : (i == j) || meet t i j -> 0 < P t i j by move=> h; rewrite lt_def nz h P0.
have zer t i j : ~~ ((i == j) || meet t i j) -> P t i j = 0 by rewrite -nz negbK => /eqP.
have e (i : nat) : (i < 3)%N -> (@inord 2 i : nat) = i by exact: inordK.
have E : span P 1 2 = P 2%N *m P 1%N by rewrite /= mulmx1.
rewrite /footprint E; split.
  apply: lt0r_neq0; apply: lt_le_trans (@mul_ge_term _ _ _ _ _ (inord 1) _ (P0 _) (P0 _)).
  by rewrite mulr_gt0 // pos // -val_eqE /meet /pair3 /= !e.
rewrite negbK mxE; apply/eqP/big1 => l _; case: (eqVneq l (inord 0)) => [->|l0].
  by rewrite [X in _ * X]zer ?mulr0 // -val_eqE /meet /pair3 /= !e.
have n0 : (inord 0 == l) = false by rewrite eq_sym; exact: negbTE.
by rewrite (zer 2%N) ?mul0r // n0 /meet /pair3 /= !e.
Qed.
End Asymmetric.

(* ---- chazelle.kron (footnote 2), indices from 0; matrices as functions of two numbers ---- *)
Section Kronecker.
Variable R : comRingType.
Implicit Types (A B C D : nat -> nat -> R).

Definition kron p q A B : nat -> nat -> R := fun r c => A (r %/ p)%N (c %/ q)%N * B (r %% p)%N (c %% q)%N.
(* the product with n in the middle *)
Definition mulf n A B : nat -> nat -> R := fun i k => \sum_(j < n) A i j * B j k.

(* the printed rule; it reaches every entry of the (m p) x (n q) matrix, each once *)
Theorem kron_entry p q A B i j k l : (j < p)%N -> (l < q)%N ->
  kron p q A B (i * p + j) (k * q + l) = A i k * B j l.
Proof.
move=> jp lq; have [p0 q0] := (leq_ltn_trans (leq0n _) jp, leq_ltn_trans (leq0n _) lq).
by rewrite /kron !divnMDl // !modnMDl !divn_small // !modn_small // !addn0.
Qed.

Lemma kron_index p r : (0 < p)%N -> forall m, (r < m * p)%N ->
  exists i j, [/\ (i < m)%N, (j < p)%N & r = (i * p + j)%N].
Proof.
move=> p0 m rm; exists (r %/ p)%N, (r %% p)%N; split; last exact: divn_eq.
  by rewrite ltn_divLR.
exact: ltn_pmod.
Qed.

Lemma sum_blocks n q (F : nat -> R) : (0 < q)%N ->
  \sum_(c < n * q) F c = \sum_(k < n) \sum_(l < q) F (k * q + l)%N.
Proof.
move=> q0; elim: n => [|n IH]; first by rewrite mul0n !big_ord0.
by rewrite big_ord_recr /= -IH mulSn addnC big_split_ord.
Qed.

(* the mixed product: A is m x n, C is n x r; B is p x q, D is q x s *)
Theorem kron_mixed n p q s A B C D : (0 < q)%N -> forall i k,
  mulf (n * q) (kron p q A B) (kron q s C D) i k = kron p s (mulf n A C) (mulf q B D) i k.
Proof.
move=> q0 i k; rewrite /mulf (sum_blocks n (fun c => kron p q A B i c * kron q s C D c k)) //.
rewrite /kron mulr_suml; apply: eq_bigr => u _.
rewrite mulr_sumr; apply: eq_bigr => w _.
by rewrite divnMDl // modnMDl (divn_small (ltn_ord w)) (modn_small (ltn_ord w)) addn0; ring.
Qed.

(* (A kron I_d) x on the stacked vector is A acting on every coordinate *)
Theorem stacked n d A (x : nat -> nat -> R) i k : (k < d)%N ->
  \sum_(c < n * d) kron d d A (fun a b => (a == b)%:R) (i * d + k) c * x (c %/ d)%N (c %% d)%N
    = \sum_(j < n) A i j * x j k.
Proof.
move=> kd; have d0 := leq_ltn_trans (leq0n _) kd.
rewrite (sum_blocks n (fun c => kron d d A _ (i * d + k) c * x (c %/ d)%N (c %% d)%N)) //.
apply: eq_bigr => j _; rewrite (bigD1 (Ordinal kd)) //= big1 ?addr0 => [|l lk].
  by rewrite kron_entry // eqxx mulr1 divnMDl // modnMDl (divn_small kd) (modn_small kd) addn0.
have lk' : (k == l :> nat) = false by apply/negbTE; apply: contra lk => /eqP h; apply/eqP/val_inj.
by rewrite kron_entry // lk' mulr0 mul0r.
Qed.
End Kronecker.

(* chazelle.chi as printed: with the second index i the vector would be one number in two places *)
Theorem chi_printed_impossible (R : realFieldType) n (i : 'I_n) (chi : 'rV[R]_n) :
  chi 0 i = 1 -> chi 0 i = -1 -> False.
Proof. by move=> -> /eqP; rewrite -subr_eq0 opprK -mulr2n pnatr_eq0. Qed.

(* chazelle.kron, both halves *)
Theorem kronecker (R : comRingType) n p q s (A B C D : nat -> nat -> R) :
  (forall i j k l, (j < p)%N -> (l < q)%N -> kron p q A B (i * p + j) (k * q + l) = A i k * B j l) /\
  ((0 < q)%N -> forall i k,
     mulf (n * q) (kron p q A B) (kron q s C D) i k = kron p s (mulf n A C) (mulf q B D) i k).
Proof. by split=> [i j k l|q0]; [exact: kron_entry | exact: kron_mixed]. Qed.

(* chazelle.foot.mono, both halves *)
Theorem footprints (R : realFieldType) :
  (forall n (G : nat -> rel 'I_n) (c : nat -> 'I_n -> R) s k,
     (forall t, network (G t)) -> (forall t, model_D (G t) (c t)) ->
     let P t := transition (G t) (c t) in
     (forall i j, footprint (span P s k) i j -> footprint (span P s k.+1) i j) /\
     (forall t i j, footprint (P t) i j = footprint (P t) j i) /\ (forall t i, footprint (P t) i i)) /\
  (exists (G : nat -> rel 'I_3) (c : nat -> 'I_3 -> R), (forall t, network (G t)) /\ (forall t, model_D (G t) (c t)) /\
     exists i j, let P t := transition (G t) (c t) in footprint (span P 1 2) i j /\ ~~ footprint (span P 1 2) j i).
Proof.
split; first by move=> n G c s k; exact: footprint_monotone.
exists meet, (fun t => vicsek R (meet t)); split; [exact: meet_network | split; first by move=> t; exact: vicsek_model_D].
exists (inord 2), (inord 0); exact: footprint_asymmetric.
Qed.
