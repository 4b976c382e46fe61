(* Chazelle, proof of Lemma 3.1: counting switches, and the stabilisers.
     chazelle.Nts, chazelle.stab, chazelle.eq3.5.
   Matrices are functions of two birds; a product restricted to rows V and columns W sums its inner indices
   over V (the product of blocks).  Any ordered field, no axioms. *)
Set Warnings "-notation-overridden,-ambiguous-paths".
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import ring zify.
From Flockproof Require Import chazelle_model chazelle_ergodicity.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Import GRing.Theory Num.Theory Order.Theory.

(* ---- chazelle.Nts: c u says that the footprint of P(u) differs from that of P(u-1) ---- *)
Section Counting.
Variable c : nat -> bool.
Definition N_printed t s := count (fun u => c u && (s < u) && (u < t))%N (iota 0 t).
Definition N t s := count c (iota s.+1 (t - s)).            (* s < u <= t *)

Lemma N_split t u s : (s <= u)%N -> (u <= t)%N -> N t s = (N u s + N t u)%N.
Proof.
move=> su ut; rewrite /N (_ : t - s = (u - s) + (t - u))%N; last by lia.
rewrite iotaD count_cat; congr (_ + count _ (iota _ _))%N; lia.
Qed.
(* corrected: additive over any increasing times, and at most 1 on one step *)
Theorem N_additive (t : nat -> nat) l : (forall k, t k <= t k.+1)%N ->
  N (t l) (t 0%N) = (\sum_(1 <= k < l.+1) N (t k) (t k.-1))%N.
Proof.
move=> mono; elim: l => [|l IH]; first by rewrite big_geq // /N subnn.
have tl : (t 0 <= t l)%N by elim: (l) => // k; move/leq_trans; apply.
by rewrite big_nat_recr //= -IH -(N_split tl (mono l)).
Qed.
Theorem N_step t : (N t.+1 t <= 1)%N.
Proof. by rewrite /N subSn // subnn /= addn0 leq_b1. Qed.
Theorem N_corrected (t : nat -> nat) l : (forall k, t k <= t k.+1)%N ->
  (forall k, t k.+1 = (t k).+1 -> (N (t k.+1) (t k) <= 1)%N) /\
  N (t l) (t 0%N) = (\sum_(1 <= k < l.+1) N (t k) (t k.-1))%N.
Proof. by move=> mono; split; [move=> k ->; exact: N_step | exact: N_additive]. Qed.
End Counting.
(* as printed (s < u < t) one step holds no u at all, so it is never 1 *)
Theorem N_printed_step c t : N_printed c t.+1 t = 0%N.
Proof.
rewrite /N_printed; apply/eqP; rewrite -leqn0 leqNgt -has_count; apply/hasPn => u _.
by apply/negP => /andP[/andP[_ tu] ut]; lia.
Qed.
(* and it is not additive: a change at the middle time is lost *)
Theorem N_printed_not_additive : exists c, N_printed c 2 0 <> (N_printed c 1 0 + N_printed c 2 1)%N.
Proof. by exists (pred1 1%N). Qed.

Local Open Scope ring_scope.
(* ---- stabilisers ---- *)
Section Stabilisers.
Variables (R : realFieldType) (n : nat) (P : nat -> 'M[R]_n).
Hypothesis SP : forall t, stochastic (P t).
Hypothesis diag : forall t i, 0 < P t i i.
Hypothesis sym : forall t i j, (P t i j != 0) = (P t j i != 0).
Variable b : 'I_n.                                   (* the first bird *)

Let P0 t i j : 0 <= P t i j. Proof. by have [] := SP t. Qed.

(* block V s k: the product P(s+k-1) ... P(s) of the blocks with rows and columns in V *)
Fixpoint block (V : {set 'I_n}) s k : 'I_n -> 'I_n -> R :=
  if k is k'.+1 then fun i j => \sum_(l in V) P (s + k')%N i l * block V s k' l j else fun i j => (i == j)%:R.

Lemma block_all s k i j : block setT s k i j = span P s k i j.
Proof.
elim: k i => [|k IH] i /=; first by rewrite mxE.
by rewrite mxE; apply: eq_big => [l|l _]; rewrite ?inE ?IH.
Qed.
Lemma block_ge0 V s k i j : 0 <= block V s k i j.
Proof. elim: k i => [|k IH] i /=; [exact: ler0n | apply: sumr_ge0 => l _; exact: mulr_ge0]. Qed.
Lemma block_split V s k l i j : block V s (k + l) i j
  = \sum_(m in V) block V (s + k) l i m * block V s k m j \/ i \notin V \/ j \notin V.
Proof.
case iV: (i \in V); last by right; left.
case jV: (j \in V); last by right; right.
left; elim: l i iV => [|l IH] i iV.
  rewrite addn0 (bigD1 i) //= eqxx mul1r big1 ?addr0 // => m /andP[_ mi].
  by rewrite eq_sym (negbTE mi) mul0r.
rewrite addnS /= addnA (eq_bigr (fun q => \sum_(m in V) P (s + k + l)%N i q * block V (s + k) l q m * block V s k m j)).
  rewrite exchange_big /=; apply: eq_bigr => m _; by rewrite mulr_suml.
by move=> q qV; rewrite IH // mulr_sumr; apply: eq_bigr => m _; rewrite mulrA.
Qed.

(* T_k and V_k: the column of the first bird in the product of blocks over V_{k-1} from time T_{k-1} + 1 on *)
Variables (T : nat -> nat) (V : nat -> {set 'I_n}).
Hypothesis V0 : V 0 = setT.
Hypothesis T_incr : forall k, (T k < T k.+1)%N.
(* V_{k+1} indexes the ones of the column at T_{k+1}, and nothing changes afterwards *)
Hypothesis V_next : forall k i, (i \in V k.+1) = (i \in V k) && (block (V k) (T k).+1 (T k.+1 - T k) i b != 0).
Hypothesis V_stable : forall k t i, (T k.+1 <= t)%N -> i \in V k ->
  block (V k) (T k).+1 (t - T k) i b != 0 -> i \in V k.+1.

Lemma column_next k u i l : i \in V k -> l \in V k -> P ((T k).+1 + u)%N i l != 0 ->
  block (V k) (T k).+1 u l b != 0 -> block (V k) (T k).+1 u.+1 i b != 0.
Proof.
move=> iV lV pz bz /=; rewrite (bigD1 l) //= lt0r_neq0 //; apply: ltr_paddr.
  by apply: sumr_ge0 => m _; rewrite mulr_ge0 ?block_ge0.
by rewrite mulr_gt0 // lt_def ?pz ?bz ?P0 ?block_ge0.
Qed.
Lemma column_stays k u i : i \in V k -> block (V k) (T k).+1 u i b != 0 -> block (V k) (T k).+1 u.+1 i b != 0.
Proof. by move=> iV; apply: column_next => //; rewrite lt0r_neq0. Qed.
Lemma column_member k u i : (T k.+1 <= T k + u)%N -> i \in V k.+1 -> block (V k) (T k).+1 u i b != 0.
Proof.
move=> Tu; rewrite V_next => /andP[iV bz].
have -> : u = (u - (T k.+1 - T k) + (T k.+1 - T k))%N by have := T_incr k; lia.
elim: (u - _)%N => [|m IH] //; exact: column_stays.
Qed.

(* chazelle.stab: nested; no edge of V_{k+1} to the rest of V_k after T_{k+1}; the first column is positive *)
Theorem stabilisers k :
  [/\ V k.+1 \subset V k,
      b \in V k,
      (forall t i j, (T k.+1 < t)%N -> i \in V k.+1 -> j \in V k -> j \notin V k.+1 -> P t i j = 0 /\ P t j i = 0) &
      (forall i, i \in V k.+1 -> 0 < block (V k) (T k).+1 (T k.+1 - T k) i b)].
Proof.
split.
- by apply/subsetP=> i; rewrite V_next => /andP[].
- elim: k => [|k IH]; first by rewrite V0 inE.
  rewrite V_next IH /=; elim: (T k.+1 - T k)%N => [|u IHu]; first by rewrite /= eqxx oner_neq0.
  exact: column_stays.
- move=> t i j Tt iV jV jN.
  have Pji : P t j i = 0.
    apply/eqP; apply: contraNT jN => pz; have tk := T_incr k.
    apply: (V_stable (t := t)) => //; first by rewrite ltnW.
    have -> : (t - T k = (t - T k).-1.+1)%N by lia.
    apply: (@column_next k _ j i) => //; first by move: iV; rewrite V_next => /andP[].
      by rewrite (_ : (T k).+1 + (t - T k).-1 = t)%N //; lia.
    by apply: column_member => //; lia.
  by split=> //; apply/eqP; rewrite -[_ == _]negbK sym negbK Pji.
by move=> i iV; rewrite lt_def block_ge0 andbT; apply: column_member => //; have := T_incr k; lia.
Qed.

(* after T_{k+1} the matrices on V_k are block diagonal: products of blocks are blocks of products *)
Lemma block_restrict k s u i j : (T k.+1 < s)%N -> i \in V k.+1 -> j \in V k ->
  block (V k) s u i j = if j \in V k.+1 then block (V k.+1) s u i j else 0.
Proof.
move=> Ts; have [sub _ cut _] := stabilisers k; elim: u i => [|u IH] i iV jV /=.
  by case: ifP => // jN; case: eqP => // E; rewrite -E iV in jN.
rewrite (bigID (fun l => l \in V k.+1)) /= [X in _ + X]big1 ?addr0; last first.
  by move=> l /andP[lV lN]; have [-> _] := cut (s + u)%N i l (leq_trans Ts (leq_addr _ _)) iV lV lN; rewrite mul0r.
rewrite (eq_bigl (fun l => l \in V k.+1)); last first.
  by move=> l; case lV: (l \in V k.+1); rewrite ?andbF // (subsetP sub l lV).
rewrite (eq_bigr (fun l => P (s + u)%N i l * (if j \in V k.+1 then block (V k.+1) s u l j else 0))); last first.
  by move=> l lV; rewrite IH.
by case: ifP => // _; rewrite big1 // => l _; rewrite mulr0.
Qed.

(* chazelle.eq3.5, corrected: the factor of T_i has rows V_i and columns V_{i-1}; inner indices of the product run over V_i.
   tower k u: P_{|V_k x V_k}(t, T_k+1) P_{|V_k x V_{k-1}}(T_k, T_{k-1}+1) ... P_{|V_1 x V_0}(T_1, T_0+1), t = T_k + u *)
Fixpoint tower k : 'I_n -> 'I_n -> R :=
  if k is k'.+1 then fun i j => \sum_(l in V k') block (V k') (T k').+1 (T k'.+1 - T k') i l * tower k' l j
  else fun i j => (i == j)%:R.
Theorem eq_3_5 k u i j : i \in V k ->
  span P (T 0).+1 (T k - T 0 + u) i j = \sum_(l in V k) block (V k) (T k).+1 u i l * tower k l j.
Proof.
elim: k u i => [|k IH] u i iV.
  rewrite subnn add0n -block_all V0 (bigD1 j) ?inE //= eqxx mulr1 big1 ?addr0 // => l /andP[_ lj].
  by rewrite (negbTE lj) mulr0.
have [sub _ _ _] := stabilisers k; have iVk := subsetP sub i iV.
have T0 : (T 0 <= T k)%N by elim: (k) => // m h; apply: leq_trans h (ltnW (T_incr m)).
have Tk := T_incr k.
rewrite (_ : T k.+1 - T 0 + u = T k - T 0 + (T k.+1 - T k + u))%N; last by lia.
rewrite IH // (eq_bigr (fun l => \sum_(m in V k.+1) block (V k.+1) (T k.+1).+1 u i m
   * block (V k) (T k).+1 (T k.+1 - T k) m l * tower k l j)).
  rewrite exchange_big /=; apply: eq_bigr => m mV; rewrite mulr_sumr.
  by apply: eq_bigr => l _; rewrite mulrA.
move=> l lV; rewrite -mulr_suml; congr (_ * _).
have [-> |[]] := block_split (V k) (T k).+1 (T k.+1 - T k) u i l; last 2 first.
- by rewrite iVk.
- by rewrite lV.
rewrite (_ : (T k).+1 + (T k.+1 - T k) = (T k.+1).+1)%N; last by lia.
rewrite (bigID (fun m => m \in V k.+1)) /= [X in _ + X]big1 ?addr0; last first.
  by move=> m /andP[mV /negbTE mN]; rewrite block_restrict ?mN ?mul0r // ltnS.
apply: eq_big => [m|m /andP[mV mV']]; first by case mV: (m \in V k.+1); rewrite ?andbF // (subsetP sub m mV).
by rewrite block_restrict ?mV' // ltnS.
Qed.
End Stabilisers.
