(* Three clauses formalised from their words before the theorems were looked at (veerman.dimL after): veerman.eq1_matrix clause 3; chazelle.lem3.6.i; veerman.dimL. *)
Set Warnings "-notation-overridden,-ambiguous-paths".
From mathcomp Require Import all_ssreflect all_algebra.
From Flockproof Require chazelle_ergodicity chazelle_switches chazelle_losses veerman_dimensions.
Set Implicit Arguments.
Unset Strict Implicit.
Import GRing.Theory Num.Theory.
Local Open Scope ring_scope.

(* lower bidiagonal, of order N + 1, with 1 on the diagonal and -1 below *)
Definition bidiagonal (K : numFieldType) N (A : 'M[K]_N.+1) : Prop :=
  (forall i, A i i = 1) /\ (forall i j : 'I_N.+1, i = j.+1 :> nat -> A i j = -1) /\
  forall i j : 'I_N.+1, i <> j :> nat -> i <> j.+1 :> nat -> A i j = 0.
(* the multiplicity of the eigenvalue 1 as a root of the characteristic polynomial *)
Definition eq1_matrix_3 : Prop := forall (K : numFieldType) N (A : 'M[K]_N.+1), bidiagonal A ->
  (('X - 1%:P) ^+ N.+1 %| char_poly A) /\ ~~ (('X - 1%:P) ^+ N.+2 %| char_poly A).
Theorem eq1_matrix_3_proved : eq1_matrix_3.
Proof.
move=> K N A [D [L Z]]; have -> : A = veerman_dimensions.P1 K N.
  apply/matrixP => i j; rewrite mxE; case: eqP => [-> | /eqP ij]; first exact: D.
  case: eqP => [e | e]; first exact: L.
  by apply: Z => // e'; move/eqP: ij; apply; apply: val_inj.
rewrite veerman_dimensions.multiplicity_P1; split=> //.
apply/negP => /dvdp_leq; rewrite monic_neq0 ?monic_exp ?monicXsubC // => /(_ isT).
by rewrite !size_exp_XsubC ltnn.
Qed.

(* flocks: birds i <> j are joined at time 0 within unit distance; later within unit distance, or where they were joined and their distance changes by less than a threshold.
   How they move does not matter for this clause, and any motion is admitted. *)
Definition distance (R : rcfType) n d (x : nat -> 'M[R]_(n, d)) t i j := Num.sqrt (\sum_k (x t i k - x t j k) ^+ 2).
Fixpoint joined (R : rcfType) n d (h : R) (x : nat -> 'M[R]_(n, d)) t (i j : 'I_n) : bool :=
  (i != j) && ((distance x t i j <= 1) || match t with
    | 0%N => false
    | s.+1 => joined h x s i j && (`|distance x t i j - distance x s i j| < h)
    end).
Definition lem3_6_i : Prop := forall (R : rcfType) n d (h : R) (x : nat -> 'M[R]_(n, d)) t i j, i <> j -> distance x t i j <= 1 -> joined h x t i j.
Theorem lem3_6_i_proved : lem3_6_i.
Proof. by move=> R n d h x [|t] i j /eqP ij near; rewrite /= ij near. Qed.
(* the flocks of the theorem are such *)
Lemma same_distance (R : rcfType) n d (x : nat -> 'M[R]_(n, d)) t i j :
  chazelle_ergodicity.norm2 (row i (x t) - row j (x t)) = distance x t i j.
Proof. by congr Num.sqrt; apply: eq_bigr => k _; rewrite !mxE. Qed.
Theorem flocks_are_joined (R : rcfType) n d (h : R) (x v : nat -> 'M[R]_(n, d)) G w :
  chazelle_switches.flock h x v G w -> forall t i j, G t i j = joined h x t i j.
Proof.
move=> [G0 Gs _ _ _]; elim=> [|t IH] i j; first by rewrite G0 same_distance /= orbF.
by rewrite Gs !same_distance IH.
Qed.
(* veerman.dimL: a leader 0 and the agents 1, .., N + 1 behind it; whom an agent tracks: nobody, the agent in front, in system (2) the one behind too if there is one *)
Definition tracks1 (k : nat) : seq nat := if k is j.+1 then [:: j] else [::].
Definition tracks2 N (k : nat) : seq nat := if k is j.+1 then (if (j < N)%N then [:: j; j.+2] else [:: j]) else [::].
(* the rows as printed: that of the leader is zero *)
Definition printed1 (K : numFieldType) (k i : nat) : K := if k is j.+1 then (if i == k then 1 else if i == j then -1 else 0) else 0.
Definition printed2 (K : numFieldType) N (k i : nat) : K :=
  if k is j.+1 then (if i == k then 1 else if (j < N)%N then (if (i == j) || (i == k.+1) then - (1 / 2%:R) else 0) else if i == j then -1 else 0) else 0.
(* a directed Laplacian: whoever tracks others is compared with their mean *)
Definition is_laplacian (K : numFieldType) N (T : nat -> seq nat) (L : 'M[K]_N.+2) : Prop := forall (x : nat -> K) (k : 'I_N.+2),
  \sum_i L k i * x i = if T k is [::] then 0 else x k - (\sum_(i <- T k) x i) / (size (T k))%:R.
(* without the row and the column of the leader; I_m (x) A and P (x) K with A and K of order 2 are of one order for m = N + 1 only *)
Definition dimL : Prop := forall (K : numFieldType) N (L L' : 'M[K]_N.+2) (P P' : 'M[K]_N.+1),
  (forall k i : 'I_N.+2, L k i = printed1 K k i) -> (forall k i : 'I_N.+2, L' k i = printed2 K N k i) ->
  (forall k i : 'I_N.+1, P k i = if i == k then 1 else if i.+1 == k :> nat then -1 else 0) ->
  (forall k i : 'I_N.+1, P' k i = if i == k then 1 else if (k < N)%N then (if (i.+1 == k :> nat) || (i == k.+1 :> nat) then - (1 / 2%:R) else 0) else if i.+1 == k :> nat then -1 else 0) ->
  [/\ forall m, (m * 2 = N.+1 * 2)%N -> m = N.+1, is_laplacian tracks1 L /\ is_laplacian (tracks2 N) L' &
      forall k i : 'I_N.+1, P k i = L (lift ord0 k) (lift ord0 i) /\ P' k i = L' (lift ord0 k) (lift ord0 i)].
Lemma few (K : numFieldType) n (a : 'I_n -> K) (s : seq 'I_n) : uniq s -> (forall i, i \notin s -> a i = 0) -> \sum_i a i = \sum_(i <- s) a i.
Proof. move=> u z; rewrite (big_uniq _ u) [RHS]big_mkcond; apply: eq_bigr => i _; case: ifP => // /negbT; exact: z. Qed.
(* the matrices of the theorem are the printed ones *)
Lemma same_L (K : numFieldType) N (L L' : 'M[K]_N.+2) : (forall k i : 'I_N.+2, L k i = printed1 K k i) -> (forall k i : 'I_N.+2, L' k i = printed2 K N k i) ->
  L = veerman_dimensions.L1 K N /\ L' = veerman_dimensions.L2 K N.
Proof.
move=> p p'; split; apply/matrixP => k i; rewrite mxE ?p ?p' -val_eqE /printed1 /printed2; case: k => [[|k] kN] /=; case: i => [i iN] //=.
- by rewrite [in k.+1 == i]eq_sym [in k.+1 == i.+1]eq_sym eqSS.
- rewrite [k.+1 == i]eq_sym [k.+1 == i.+1]eq_sym !eqSS; case: eqP => // _; have kN' : (k <= N)%N by []; rewrite ltn_neqAle kN' andbT.
  by case: eqP => //= _; rewrite div1r.
Qed.
Theorem dimL_proved : dimL.
Proof.
move=> K N L L' P P' p p' q q'; have [e e'] := same_L p p'.
have [[l l'] [[r r'] o]] := veerman_dimensions.dimL K N.
split; first by move=> m /o.
- split=> x k.
  + case: k => [[|k] kN] /=; first by rewrite big1 // => i _; rewrite p /= mul0r.
    have kN' : (k < N.+2)%N by apply: ltnW.
    rewrite (@few _ _ _ [:: Ordinal kN; Ordinal kN']) ?big_cons ?big_nil ?p /=.
    * by rewrite eqxx (ltn_eqF (ltnSn k)) eqxx mul1r mulN1r !addr0 divr1.
    * by rewrite !inE -val_eqE /= andbT eq_sym (ltn_eqF (ltnSn k)).
    * by move=> i; rewrite !inE negb_or -!val_eqE p /= => /andP[/negbTE-> /negbTE->]; rewrite mul0r.
  + case: k => [[|k] kN] /=; first by rewrite big1 // => i _; rewrite p' /= mul0r.
    have kN' : (k < N.+2)%N by apply: ltnW.
    case: ifP => kl.
    * have kN2 : (k.+2 < N.+2)%N by rewrite !ltnS.
      rewrite (@few _ _ _ [:: Ordinal kN; Ordinal kN'; Ordinal kN2]) ?big_cons ?big_nil ?p' /=.
      -- rewrite kl !eqxx (ltn_eqF (ltnSn k)) (gtn_eqF (ltnSn k.+1)) orbT /= mul1r !addr0 !mulNr mul1r -opprD -mulrDr.
         by congr (_ - _); rewrite mulrC.
      -- by rewrite !inE -!val_eqE /= negb_or !andbT (gtn_eqF (ltnSn k)) (ltn_eqF (ltnSn k.+1)) /= (ltn_eqF (ltnW (ltnSn k.+1))).
      -- move=> i; rewrite !inE !negb_or -!val_eqE p' /= kl => /and3P[/negbTE-> /negbTE-> /negbTE->].
         by rewrite mul0r.
    * rewrite (@few _ _ _ [:: Ordinal kN; Ordinal kN']) ?big_cons ?big_nil ?p' /=.
      -- by rewrite kl eqxx (ltn_eqF (ltnSn k)) eqxx mul1r mulN1r !addr0 divr1.
      -- by rewrite !inE -val_eqE /= andbT eq_sym (ltn_eqF (ltnSn k)).
      -- by move=> i; rewrite !inE negb_or -!val_eqE p' /= kl => /andP[/negbTE-> /negbTE->]; rewrite mul0r.
- move=> k i; rewrite q q' p p' /= /bump /= !add1n /printed1 /printed2 !eqSS -!val_eqE; split=> //.
Qed.
