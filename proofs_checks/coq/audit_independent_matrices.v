(* Two clauses formalised from their words before the theorems were looked at: veerman.eq1_matrix clause 3; chazelle.lem3.6.i. *)
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
