(* Audit of theorems about matrices over any field of numbers: each theorem of theorems.tsv with its statement written out. *)
From mathcomp Require Import all_ssreflect all_algebra.
From Flockproof Require veerman_dimensions.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Import GRing.Theory Num.Theory.
Local Open Scope ring_scope.

(* veerman.dimL, veerman.eq1_matrix clause 3: the printed matrices, agents 0 (the leader) to N + 1 *)
Check (fun (K : numFieldType) N => erefl : veerman_dimensions.L1 K N = \matrix_(i, j) (if i == 0%N :> nat then 0 else if i == j then 1 else if i == j.+1 :> nat then - 1 else 0)).
Check (fun (K : numFieldType) N => erefl : veerman_dimensions.L2 K N = \matrix_(i, j) (if i == 0%N :> nat then 0 else if i == j then 1
  else if i == N.+1 :> nat then (if i == j.+1 :> nat then - 1 else 0)
  else if (i == j.+1 :> nat) || (j == i.+1 :> nat) then - 2%:R^-1 else 0)).
Check (fun (K : numFieldType) N => erefl : veerman_dimensions.P1 K N = \matrix_(i, j) (if i == j then 1 else if i == j.+1 :> nat then - 1 else 0)).
Check (fun (K : numFieldType) N => erefl : veerman_dimensions.P2 K N = \matrix_(i, j) (if i == j then 1 else if i == N :> nat then (if i == j.+1 :> nat then - 1 else 0)
  else if (i == j.+1 :> nat) || (j == i.+1 :> nat) then - 2%:R^-1 else 0)).
Check (fun N => erefl : @veerman_dimensions.front N = fun i j => i == j.+1 :> nat).
Check (fun N => erefl : @veerman_dimensions.both N = fun i j => (i != 0%N :> nat) && ((i == j.+1 :> nat) || ((j == i.+1 :> nat) && (i != N.+1 :> nat)))).
Check (fun N => erefl : @veerman_dimensions.tracked N = fun T i => #|[pred j | T i j]|).
Check (fun (K : numFieldType) N => erefl : @veerman_dimensions.directed_laplacian K N = fun T =>
  \matrix_(i, j) ((i == j)%:R * (veerman_dimensions.tracked T i != 0%N)%:R - (T i j)%:R / (veerman_dimensions.tracked T i)%:R)).
Check (@veerman_dimensions.dimL : forall (K : numFieldType) (N : nat),
  (veerman_dimensions.L1 K N = veerman_dimensions.directed_laplacian K (@veerman_dimensions.front N) /\
   veerman_dimensions.L2 K N = veerman_dimensions.directed_laplacian K (@veerman_dimensions.both N)) /\
  (veerman_dimensions.P1 K N = row' ord0 (col' ord0 (veerman_dimensions.L1 K N)) /\
   veerman_dimensions.P2 K N = row' ord0 (col' ord0 (veerman_dimensions.L2 K N))) /\
  forall m : nat, (m * 2 = N.+1 * 2)%N <-> m = N.+1).
Check (@veerman_dimensions.multiplicity_P1 : forall (K : numFieldType) (N : nat), char_poly (veerman_dimensions.P1 K N) = ('X - 1%:P) ^+ N.+1).
