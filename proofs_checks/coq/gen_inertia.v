(* Written by `flockproof certify --coq`. *)
From Coq Require Import ZArith QArith List.
From Flockproof Require Import certificate_matrices.
From Flockproof Require Import certificate_inertia.
Import ListNotations.
Open Scope Z_scope.

Definition paley_thm1_saddle_four_and_two_A : zmat :=
  ([[(-1); 1; 1; 1; (-1); (-1)];
   [1; (-1); 1; 1; (-1); (-1)];
   [1; 1; (-1); 1; (-1); (-1)];
   [1; 1; 1; (-1); (-1); (-1)];
   [(-1); (-1); (-1); (-1); 3; 1];
   [(-1); (-1); (-1); (-1); 1; 3]],
  6%positive).
Theorem paley_thm1_saddle_four_and_two : has_inertia 6 (val paley_thm1_saddle_four_and_two_A) 2 3.
Proof. apply (inertia_certificate _ _
  ([[2; 0; 0; 0; 0; 0];
   [(-2); (-1); 2; 0; 0; 0];
   [(-2); (-1); (-2); (-1); 2; 0];
   [(-2); (-1); (-2); (-1); (-2); 2];
   [2; 2; 0; 0; 0; 0];
   [2; 1; 2; 2; 0; 0]],
  2%positive)
  ([(-1); 4; (-1); 4; (-1); 0], 6%positive)
  ([[2; 0; 0; 0; 0; 0];
   [(-2); 0; 0; 0; 2; 0];
   [1; 2; 0; 0; 1; 0];
   [(-2); (-2); 0; 0; (-2); 2];
   [1; 1; 2; 0; 1; 1];
   [2; 2; 2; 2; 2; 2]],
  2%positive)). vm_cast_no_check (eq_refl true). Qed.

Definition paley_thm1_saddle_three_and_one_A : zmat :=
  ([[(-1); 1; 1; (-1)];
   [1; (-1); 1; (-1)];
   [1; 1; (-1); (-1)];
   [(-1); (-1); (-1); 3]],
  4%positive).
Theorem paley_thm1_saddle_three_and_one : has_inertia 4 (val paley_thm1_saddle_three_and_one_A) 1 2.
Proof. apply (inertia_certificate _ _
  ([[2; 0; 0; 0];
   [(-2); (-1); 2; 0];
   [(-2); (-1); (-2); 2];
   [2; 2; 0; 0]],
  2%positive)
  ([(-1); 4; (-1); 0], 4%positive)
  ([[2; 0; 0; 0];
   [(-2); 0; 0; 2];
   [1; 2; 0; 1];
   [2; 2; 2; 2]],
  2%positive)). vm_cast_no_check (eq_refl true). Qed.

Definition tanner1_L_ring_5_and_path_3_A : zmat :=
  ([[2; (-1); 0; 0; (-1); 0; 0; 0];
   [(-1); 2; (-1); 0; 0; 0; 0; 0];
   [0; (-1); 2; (-1); 0; 0; 0; 0];
   [0; 0; (-1); 2; (-1); 0; 0; 0];
   [(-1); 0; 0; (-1); 2; 0; 0; 0];
   [0; 0; 0; 0; 0; 1; (-1); 0];
   [0; 0; 0; 0; 0; (-1); 2; (-1)];
   [0; 0; 0; 0; 0; 0; (-1); 1]],
  1%positive).
Theorem tanner1_L_ring_5_and_path_3 : has_inertia 8 (val tanner1_L_ring_5_and_path_3_A) 6 0.
Proof. apply (inertia_certificate _ _
  ([[12; 0; 0; 0; 0; 0; 0; 0];
   [(-6); 12; 0; 0; 0; 0; 0; 0];
   [0; (-8); 12; 0; 0; 0; 0; 0];
   [0; 0; (-9); 12; 0; 0; 0; 0];
   [(-6); (-4); (-3); (-12); 0; 0; 12; 0];
   [0; 0; 0; 0; 12; 0; 0; 0];
   [0; 0; 0; 0; (-12); 12; 0; 0];
   [0; 0; 0; 0; 0; (-12); 0; 12]],
  12%positive)
  ([24; 18; 16; 15; 12; 12; 0; 0], 12%positive)
  ([[12; 0; 0; 0; 0; 0; 0; 0];
   [6; 12; 0; 0; 0; 0; 0; 0];
   [4; 8; 12; 0; 0; 0; 0; 0];
   [3; 6; 9; 12; 0; 0; 0; 0];
   [0; 0; 0; 0; 0; 12; 0; 0];
   [0; 0; 0; 0; 0; 12; 12; 0];
   [12; 12; 12; 12; 12; 0; 0; 0];
   [0; 0; 0; 0; 0; 12; 12; 12]],
  12%positive)). vm_cast_no_check (eq_refl true). Qed.

Definition tanner2_L_path_6_A : zmat :=
  ([[1; (-1); 0; 0; 0; 0];
   [(-1); 2; (-1); 0; 0; 0];
   [0; (-1); 2; (-1); 0; 0];
   [0; 0; (-1); 2; (-1); 0];
   [0; 0; 0; (-1); 2; (-1)];
   [0; 0; 0; 0; (-1); 1]],
  1%positive).
Theorem tanner2_L_path_6 : has_inertia 6 (val tanner2_L_path_6_A) 5 0.
Proof. apply (inertia_certificate _ _
  ([[1; 0; 0; 0; 0; 0];
   [(-1); 1; 0; 0; 0; 0];
   [0; (-1); 1; 0; 0; 0];
   [0; 0; (-1); 1; 0; 0];
   [0; 0; 0; (-1); 1; 0];
   [0; 0; 0; 0; (-1); 1]],
  1%positive)
  ([1; 1; 1; 1; 1; 0], 1%positive)
  ([[1; 0; 0; 0; 0; 0];
   [1; 1; 0; 0; 0; 0];
   [1; 1; 1; 0; 0; 0];
   [1; 1; 1; 1; 0; 0];
   [1; 1; 1; 1; 1; 0];
   [1; 1; 1; 1; 1; 1]],
  1%positive)). vm_cast_no_check (eq_refl true). Qed.
