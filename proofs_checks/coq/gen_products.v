(* Written by `flockproof certify --coq`. *)
From Coq Require Import ZArith QArith List.
From Flockproof Require Import certificate_matrices.
Import ListNotations.
Open Scope Z_scope.

Definition chazelle_exAB_60_factors_factors : list zmat := [
  ([[0; 2; 0];
   [1; 0; 1];
   [0; 2; 0]],
  2%positive);
  ([[0; 1; 0];
   [1; 0; 0];
   [0; 0; 1]],
  1%positive);
  ([[0; 2; 0];
   [1; 0; 1];
   [0; 2; 0]],
  2%positive);
  ([[0; 1; 0];
   [1; 0; 0];
   [0; 0; 1]],
  1%positive);
  ([[0; 2; 0];
   [1; 0; 1];
   [0; 2; 0]],
  2%positive);
  ([[0; 1; 0];
   [1; 0; 0];
   [0; 0; 1]],
  1%positive);
  ([[0; 2; 0];
   [1; 0; 1];
   [0; 2; 0]],
  2%positive);
  ([[0; 1; 0];
   [1; 0; 0];
   [0; 0; 1]],
  1%positive);
  ([[0; 2; 0];
   [1; 0; 1];
   [0; 2; 0]],
  2%positive);
  ([[0; 1; 0];
   [1; 0; 0];
   [0; 0; 1]],
  1%positive);
  ([[0; 2; 0];
   [1; 0; 1];
   [0; 2; 0]],
  2%positive);
  ([[0; 1; 0];
   [1; 0; 0];
   [0; 0; 1]],
  1%positive);
  ([[0; 2; 0];
   [1; 0; 1];
   [0; 2; 0]],
  2%positive);
  ([[0; 1; 0];
   [1; 0; 0];
   [0; 0; 1]],
  1%positive);
  ([[0; 2; 0];
   [1; 0; 1];
   [0; 2; 0]],
  2%positive);
  ([[0; 1; 0];
   [1; 0; 0];
   [0; 0; 1]],
  1%positive);
  ([[0; 2; 0];
   [1; 0; 1];
   [0; 2; 0]],
  2%positive);
  ([[0; 1; 0];
   [1; 0; 0];
   [0; 0; 1]],
  1%positive);
  ([[0; 2; 0];
   [1; 0; 1];
   [0; 2; 0]],
  2%positive);
  ([[0; 1; 0];
   [1; 0; 0];
   [0; 0; 1]],
  1%positive);
  ([[0; 2; 0];
   [1; 0; 1];
   [0; 2; 0]],
  2%positive);
  ([[0; 1; 0];
   [1; 0; 0];
   [0; 0; 1]],
  1%positive);
  ([[0; 2; 0];
   [1; 0; 1];
   [0; 2; 0]],
  2%positive);
  ([[0; 1; 0];
   [1; 0; 0];
   [0; 0; 1]],
  1%positive);
  ([[0; 2; 0];
   [1; 0; 1];
   [0; 2; 0]],
  2%positive);
  ([[0; 1; 0];
   [1; 0; 0];
   [0; 0; 1]],
  1%positive);
  ([[0; 2; 0];
   [1; 0; 1];
   [0; 2; 0]],
  2%positive);
  ([[0; 1; 0];
   [1; 0; 0];
   [0; 0; 1]],
  1%positive);
  ([[0; 2; 0];
   [1; 0; 1];
   [0; 2; 0]],
  2%positive);
  ([[0; 1; 0];
   [1; 0; 0];
   [0; 0; 1]],
  1%positive);
  ([[0; 2; 0];
   [1; 0; 1];
   [0; 2; 0]],
  2%positive);
  ([[0; 1; 0];
   [1; 0; 0];
   [0; 0; 1]],
  1%positive);
  ([[0; 2; 0];
   [1; 0; 1];
   [0; 2; 0]],
  2%positive);
  ([[0; 1; 0];
   [1; 0; 0];
   [0; 0; 1]],
  1%positive);
  ([[0; 2; 0];
   [1; 0; 1];
   [0; 2; 0]],
  2%positive);
  ([[0; 1; 0];
   [1; 0; 0];
   [0; 0; 1]],
  1%positive);
  ([[0; 2; 0];
   [1; 0; 1];
   [0; 2; 0]],
  2%positive);
  ([[0; 1; 0];
   [1; 0; 0];
   [0; 0; 1]],
  1%positive);
  ([[0; 2; 0];
   [1; 0; 1];
   [0; 2; 0]],
  2%positive);
  ([[0; 1; 0];
   [1; 0; 0];
   [0; 0; 1]],
  1%positive);
  ([[0; 2; 0];
   [1; 0; 1];
   [0; 2; 0]],
  2%positive);
  ([[0; 1; 0];
   [1; 0; 0];
   [0; 0; 1]],
  1%positive);
  ([[0; 2; 0];
   [1; 0; 1];
   [0; 2; 0]],
  2%positive);
  ([[0; 1; 0];
   [1; 0; 0];
   [0; 0; 1]],
  1%positive);
  ([[0; 2; 0];
   [1; 0; 1];
   [0; 2; 0]],
  2%positive);
  ([[0; 1; 0];
   [1; 0; 0];
   [0; 0; 1]],
  1%positive);
  ([[0; 2; 0];
   [1; 0; 1];
   [0; 2; 0]],
  2%positive);
  ([[0; 1; 0];
   [1; 0; 0];
   [0; 0; 1]],
  1%positive);
  ([[0; 2; 0];
   [1; 0; 1];
   [0; 2; 0]],
  2%positive);
  ([[0; 1; 0];
   [1; 0; 0];
   [0; 0; 1]],
  1%positive);
  ([[0; 2; 0];
   [1; 0; 1];
   [0; 2; 0]],
  2%positive);
  ([[0; 1; 0];
   [1; 0; 0];
   [0; 0; 1]],
  1%positive);
  ([[0; 2; 0];
   [1; 0; 1];
   [0; 2; 0]],
  2%positive);
  ([[0; 1; 0];
   [1; 0; 0];
   [0; 0; 1]],
  1%positive);
  ([[0; 2; 0];
   [1; 0; 1];
   [0; 2; 0]],
  2%positive);
  ([[0; 1; 0];
   [1; 0; 0];
   [0; 0; 1]],
  1%positive);
  ([[0; 2; 0];
   [1; 0; 1];
   [0; 2; 0]],
  2%positive);
  ([[0; 1; 0];
   [1; 0; 0];
   [0; 0; 1]],
  1%positive);
  ([[0; 2; 0];
   [1; 0; 1];
   [0; 2; 0]],
  2%positive);
  ([[0; 1; 0];
   [1; 0; 0];
   [0; 0; 1]],
  1%positive)].
Theorem chazelle_exAB_60_factors :
  (forall M, In M chazelle_exAB_60_factors_factors -> stochastic 3 (val M)) /\
  is_tau1 3 (prodq 3 chazelle_exAB_60_factors_factors) (1 # 536870912).
Proof. apply product_certificate. vm_cast_no_check (eq_refl true). Qed.

Definition chazelle_tau1_four_birds_16_factors_factors : list zmat := [
  ([[1; 2; 0; 0];
   [2; 1; 0; 0];
   [0; 0; 1; 2];
   [0; 0; 2; 1]],
  3%positive);
  ([[1; 2; 0; 0];
   [1; 1; 1; 0];
   [0; 1; 1; 1];
   [0; 0; 2; 1]],
  3%positive);
  ([[1; 2; 0; 0];
   [2; 1; 0; 0];
   [0; 0; 1; 2];
   [0; 0; 2; 1]],
  3%positive);
  ([[1; 2; 0; 0];
   [1; 1; 1; 0];
   [0; 1; 1; 1];
   [0; 0; 2; 1]],
  3%positive);
  ([[1; 2; 0; 0];
   [2; 1; 0; 0];
   [0; 0; 1; 2];
   [0; 0; 2; 1]],
  3%positive);
  ([[1; 2; 0; 0];
   [1; 1; 1; 0];
   [0; 1; 1; 1];
   [0; 0; 2; 1]],
  3%positive);
  ([[1; 2; 0; 0];
   [2; 1; 0; 0];
   [0; 0; 1; 2];
   [0; 0; 2; 1]],
  3%positive);
  ([[1; 2; 0; 0];
   [1; 1; 1; 0];
   [0; 1; 1; 1];
   [0; 0; 2; 1]],
  3%positive);
  ([[1; 2; 0; 0];
   [2; 1; 0; 0];
   [0; 0; 1; 2];
   [0; 0; 2; 1]],
  3%positive);
  ([[1; 2; 0; 0];
   [1; 1; 1; 0];
   [0; 1; 1; 1];
   [0; 0; 2; 1]],
  3%positive);
  ([[1; 2; 0; 0];
   [2; 1; 0; 0];
   [0; 0; 1; 2];
   [0; 0; 2; 1]],
  3%positive);
  ([[1; 2; 0; 0];
   [1; 1; 1; 0];
   [0; 1; 1; 1];
   [0; 0; 2; 1]],
  3%positive);
  ([[1; 2; 0; 0];
   [2; 1; 0; 0];
   [0; 0; 1; 2];
   [0; 0; 2; 1]],
  3%positive);
  ([[1; 2; 0; 0];
   [1; 1; 1; 0];
   [0; 1; 1; 1];
   [0; 0; 2; 1]],
  3%positive);
  ([[1; 2; 0; 0];
   [2; 1; 0; 0];
   [0; 0; 1; 2];
   [0; 0; 2; 1]],
  3%positive);
  ([[1; 2; 0; 0];
   [1; 1; 1; 0];
   [0; 1; 1; 1];
   [0; 0; 2; 1]],
  3%positive)].
Theorem chazelle_tau1_four_birds_16_factors :
  (forall M, In M chazelle_tau1_four_birds_16_factors_factors -> stochastic 4 (val M)) /\
  is_tau1 4 (prodq 4 chazelle_tau1_four_birds_16_factors_factors) (895795 # 14348907).
Proof. apply product_certificate. vm_cast_no_check (eq_refl true). Qed.
