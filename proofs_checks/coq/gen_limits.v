(* Written by `flockproof certify --coq`. *)
From Coq Require Import ZArith QArith List.
From Flockproof Require Import certificate_matrices.
From Flockproof Require Import certificate_limits.
Import ListNotations.
Open Scope Z_scope.

Definition chazelle_lem3_3_one_edge_P : zmat :=
  ([[12; 3];
   [10; 5]],
  15%positive).
Definition chazelle_lem3_3_one_edge_pi : list Z * positive :=
  ([10; 3], 13%positive).
Definition chazelle_lem3_3_one_edge_Gamma : zmat :=
  ([[45; (-45)];
   [(-150); 150]],
  169%positive).
Theorem chazelle_lem3_3_one_edge :
  converges 2 (val chazelle_lem3_3_one_edge_P) (vec chazelle_lem3_3_one_edge_pi) (val chazelle_lem3_3_one_edge_Gamma) 1 (2 # 15).
Proof. apply limit_certificate. vm_cast_no_check (eq_refl true). Qed.

Definition chazelle_lem3_3_path_4_lazy_P : zmat :=
  ([[1; 2; 0; 0];
   [1; 1; 1; 0];
   [0; 1; 1; 1];
   [0; 0; 2; 1]],
  3%positive).
Definition chazelle_lem3_3_path_4_lazy_pi : list Z * positive :=
  ([1; 2; 2; 1], 6%positive).
Definition chazelle_lem3_3_path_4_lazy_Gamma : zmat :=
  ([[35; 10; (-26); (-19)];
   [5; 22; (-14); (-13)];
   [(-13); (-14); 22; 5];
   [(-19); (-26); 10; 35]],
  24%positive).
Theorem chazelle_lem3_3_path_4_lazy :
  converges 4 (val chazelle_lem3_3_path_4_lazy_P) (vec chazelle_lem3_3_path_4_lazy_pi) (val chazelle_lem3_3_path_4_lazy_Gamma) 2 (5 # 9).
Proof. apply limit_certificate. vm_cast_no_check (eq_refl true). Qed.

Definition chazelle_lem3_3_ring_6_uneven_P : zmat :=
  ([[420; 210; 0; 0; 0; 210];
   [280; 280; 280; 0; 0; 0];
   [0; 315; 210; 315; 0; 0];
   [0; 0; 336; 168; 336; 0];
   [0; 0; 0; 350; 140; 350];
   [360; 0; 0; 0; 360; 120]],
  840%positive).
Definition chazelle_lem3_3_ring_6_uneven_pi : list Z * positive :=
  ([120; 90; 80; 75; 72; 70], 507%positive).
Definition chazelle_lem3_3_ring_6_uneven_Gamma : zmat :=
  ([[414678; 4527; (-146724); (-177480); (-117450); 22449];
   [6036; 340668; 37824; (-111570); (-156996); (-115962)];
   [(-220086); 42552; 344052; 68415; (-87030); (-147903)];
   [(-283968); (-133884); 72976; 349800; 80280; (-85204)];
   [(-195750); (-196245); (-96700); 83625; 338850; 66220];
   [38484; (-149094); (-169032); (-91290); 68112; 302820]],
  257049%positive).
Theorem chazelle_lem3_3_ring_6_uneven :
  converges 6 (val chazelle_lem3_3_ring_6_uneven_P) (vec chazelle_lem3_3_ring_6_uneven_pi) (val chazelle_lem3_3_ring_6_uneven_Gamma) 2 (253 # 504).
Proof. apply limit_certificate. vm_cast_no_check (eq_refl true). Qed.

Definition chazelle_lem3_3_star_5_vicsek_P : zmat :=
  ([[2; 2; 2; 2; 2];
   [5; 5; 0; 0; 0];
   [5; 0; 5; 0; 0];
   [5; 0; 0; 5; 0];
   [5; 0; 0; 0; 5]],
  10%positive).
Definition chazelle_lem3_3_star_5_vicsek_pi : list Z * positive :=
  ([5; 2; 2; 2; 2], 13%positive).
Definition chazelle_lem3_3_star_5_vicsek_Gamma : zmat :=
  ([[80; (-20); (-20); (-20); (-20)];
   [(-50); 266; (-72); (-72); (-72)];
   [(-50); (-72); 266; (-72); (-72)];
   [(-50); (-72); (-72); 266; (-72)];
   [(-50); (-72); (-72); (-72); 266]],
  169%positive).
Theorem chazelle_lem3_3_star_5_vicsek :
  converges 5 (val chazelle_lem3_3_star_5_vicsek_P) (vec chazelle_lem3_3_star_5_vicsek_pi) (val chazelle_lem3_3_star_5_vicsek_Gamma) 1 (3 # 5).
Proof. apply limit_certificate. vm_cast_no_check (eq_refl true). Qed.
