(* Veerman, Stosic, Olvera, section 2: what the printed matrices are.
     veerman.dimL, veerman.eq1_matrix (clause 3).
   Agents 0 (the leader) to N + 1.  Any field of numbers, no axioms. *)
Set Warnings "-notation-overridden,-ambiguous-paths".
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import ring zify.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Import GRing.Theory Num.Theory Order.Theory.
Local Open Scope ring_scope.

Section Printed.
Variables (K : numFieldType) (N : nat).
(* the matrices as printed, L_i of order N + 2 and P_i of order N + 1, entries counted from 0 *)
Definition L1 : 'M[K]_N.+2 := \matrix_(i, j) (if i == 0%N :> nat then 0 else if i == j then 1 else if i == j.+1 :> nat then - 1 else 0).
Definition L2 : 'M[K]_N.+2 := \matrix_(i, j) (if i == 0%N :> nat then 0 else if i == j then 1
  else if i == N.+1 :> nat then (if i == j.+1 :> nat then - 1 else 0)
  else if (i == j.+1 :> nat) || (j == i.+1 :> nat) then - 2%:R^-1 else 0).
Definition P1 : 'M[K]_N.+1 := \matrix_(i, j) (if i == j then 1 else if i == j.+1 :> nat then - 1 else 0).
Definition P2 : 'M[K]_N.+1 := \matrix_(i, j) (if i == j then 1 else if i == N :> nat then (if i == j.+1 :> nat then - 1 else 0)
  else if (i == j.+1 :> nat) || (j == i.+1 :> nat) then - 2%:R^-1 else 0).
(* whom an agent tracks: nobody (the leader), the car in front, or in system (2) both neighbours, the last car the one in front *)
Definition front : rel 'I_N.+2 := fun i j => i == j.+1 :> nat.
Definition both : rel 'I_N.+2 := fun i j => (i != 0%N :> nat) && ((i == j.+1 :> nat) || ((j == i.+1 :> nat) && (i != N.+1 :> nat))).
(* the directed Laplacian: each agent compares itself with the mean of those that it tracks *)
Definition tracked (T : rel 'I_N.+2) i := #|[pred j | T i j]|.
Definition directed_laplacian (T : rel 'I_N.+2) : 'M[K]_N.+2 :=
  \matrix_(i, j) ((i == j)%:R * (tracked T i != 0%N)%:R - (T i j)%:R / (tracked T i)%:R).

Lemma pred_ltn (i : 'I_N.+2) : (i.-1 < N.+2)%N.
Proof. by move: (ltn_ord i); lia. Qed.
Lemma front_tracked i : tracked front i = (i != 0%N :> nat).
Proof.
rewrite /tracked; case: (eqVneq (i : nat) 0%N) => [i0 | i0] /=.
  by apply: eq_card0 => j; rewrite !inE /front i0.
rewrite (eq_card (B := pred1 (Ordinal (pred_ltn i)))) ?card1 // => j; rewrite !inE /front -val_eqE /=; lia.
Qed.
Lemma both_last (i : 'I_N.+2) : i = N.+1 :> nat -> tracked both i = 1%N.
Proof.
move=> iN; rewrite /tracked (eq_card (B := pred1 (Ordinal (pred_ltn i)))) ?card1 // => j; rewrite !inE /both -val_eqE /=; lia.
Qed.
Lemma both_mid (i : 'I_N.+2) : i != 0%N :> nat -> i != N.+1 :> nat -> tracked both i = 2%N.
Proof.
move=> i0 iN; have iS : (i.+1 < N.+2)%N by move: (ltn_ord i); lia.
rewrite /tracked (eq_card (B := pred2 (Ordinal (pred_ltn i)) (Ordinal iS))); last by move=> j; rewrite !inE /both -!val_eqE /=; lia.
by rewrite card2 -val_eqE /=; have -> : (i.-1 != i.+1)%N by lia.
Qed.
Theorem dimL :
  (L1 = directed_laplacian front /\ L2 = directed_laplacian both) /\
  (P1 = row' ord0 (col' ord0 L1) /\ P2 = row' ord0 (col' ord0 L2)) /\
  (* I_m (x) A and P_i (x) K, with A and K of order 2, are of one order for m = N + 1 only *)
  forall m, (m * 2 = N.+1 * 2)%N <-> m = N.+1.
Proof.
split; last split; last by move=> m; split; lia.
- split; apply/matrixP => i j; rewrite !mxE.
    rewrite front_tracked /front; case: (eqVneq (i : nat) 0%N) => [i0 | i0] /=.
      by rewrite i0 mulr0 mul0r subr0.
    rewrite invr1 !mulr1; case: (eqVneq i j) => [-> | ij] /=; last by rewrite sub0r; case: eqP; rewrite ?oppr0.
    by rewrite ltn_eqF // subr0.
  case: (eqVneq (i : nat) 0%N) => [i0 | i0].
    have -> : both i j = false by rewrite /both i0.
    have -> : tracked both i = 0%N by rewrite /tracked; apply: eq_card0 => k; rewrite !inE /both i0.
    by rewrite eqxx mulr0 mul0r subr0.
  case: (eqVneq (i : nat) N.+1) => [iN | iN].
    rewrite both_last // /both i0 /= iN eqxx andbF orbF invr1 !mulr1; case: (eqVneq i j) => [ij | ij] /=; last by rewrite sub0r; case: eqP; rewrite ?oppr0.
    have -> : (N.+1 == j.+1 :> nat) = false by move: iN; rewrite ij => ->; rewrite ltn_eqF.
    by rewrite subr0.
  rewrite both_mid // /both i0 iN /= mulr1 andbT; case: (eqVneq i j) => [-> | ij] /=; last by rewrite sub0r; case: ifP; rewrite ?mul1r ?mul0r ?oppr0.
  by rewrite !ltn_eqF // mul0r subr0.
- by split; apply/matrixP => i j; rewrite !mxE /= !(inj_eq (@lift_inj _ _)) /bump /= ?add1n ?eqSS.
Qed.
(* the multiplicity of the eigenvalue 1 of P_1 *)
Theorem multiplicity_P1 : char_poly P1 = ('X - 1%:P) ^+ N.+1.
Proof.
rewrite char_poly_trig; last first.
  apply/is_trig_mxP => i j ij; rewrite !mxE; have -> : (i == j) = false by apply/negbTE; rewrite neq_ltn ij.
  by rewrite ltn_eqF // ltnS ltnW.
by rewrite (eq_bigr (fun=> 'X - 1%:P)) => [|i _]; rewrite ?mxE ?eqxx // prodr_const card_ord.
Qed.
End Printed.
