(* Written by `flockproof certify --coq`. *)
From Coq Require Import Reals ZArith QArith List.
From Flockproof Require Import certificate_peaks.
Import ListNotations.
Open Scope Z_scope.

Theorem veerman_table1_numeric_M_16 :
  has_peak (Q2R ((-1) # 1)) (Q2R ((-1) # 1)) 15
    (Q2R (34675071 # 500000000)) (Q2R (34675141 # 500000000))
    (Q2R (9178917759899 # 500000000000)) (Q2R (18357835519801 # 1000000000000)).
Proof. apply (peak_certificate _ _ _ _ _ (6935021192807 # 100000000000000) _ _ 64). vm_cast_no_check (eq_refl true). Qed.

Theorem veerman_table1_numeric_M_4 :
  has_peak (Q2R ((-1) # 1)) (Q2R ((-1) # 1)) 3
    (Q2R (27310829 # 100000000)) (Q2R (27310884 # 100000000))
    (Q2R (23274497690367 # 5000000000000)) (Q2R (2327449769037 # 500000000000)).
Proof. apply (peak_certificate _ _ _ _ _ (853464263359 # 3125000000000) _ _ 64). vm_cast_no_check (eq_refl true). Qed.

Theorem veerman_table1_numeric_M_8 :
  has_peak (Q2R ((-1) # 1)) (Q2R ((-1) # 1)) 7
    (Q2R (13827819 # 100000000)) (Q2R (13827847 # 100000000))
    (Q2R (92043186764187 # 10000000000000)) (Q2R (46021593382099 # 5000000000000)).
Proof. apply (peak_certificate _ _ _ _ _ (13827832866607 # 100000000000000) _ _ 64). vm_cast_no_check (eq_refl true). Qed.
