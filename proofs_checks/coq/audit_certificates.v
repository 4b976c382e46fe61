(* What the certificates prove, written out again, with the axioms under each theorem. *)
From Coq Require Import ZArith QArith Qabs List Bool.
From Flockproof Require Import certificate_matrices.
From Flockproof Require Import certificate_limits.
From Flockproof Require Import certificate_inertia.
From Flockproof Require Import certificate_index.
From Flockproof Require Import certificate_flocks.
From Flockproof Require Import gen_limits.
From Flockproof Require Import gen_inertia.
From Flockproof Require Import certificate_instances.
Import ListNotations.
Open Scope Q_scope.

(* ---- the words of the statements ---- *)
Check (fun n f => eq_refl : sumQ (S n) f = sumQ n f + f n).
Check (fun n A B i j => eq_refl : mulq n A B i j = sumQ n (fun k => A i k * B k j)).
Check (fun n A t => eq_refl : powq n A (S t) = mulq n A (powq n A t)).
Check (fun c t => eq_refl : pow c (S t) = c * pow c t).
Check (fun n A i j => eq_refl : distq n A i j = (1 # 2) * sumQ n (fun k => Qabs (A i k - A j k))).
Check (fun n A c => eq_refl : is_tau1 n A c =
  ((forall i j, (i < n)%nat -> (j < n)%nat -> distq n A i j <= c) /\
   exists i j, (i < n)%nat /\ (j < n)%nat /\ distq n A i j == c)).
Check (fun M1 M2 => eq_refl : prodq 2 [M1; M2] = mulq 2 (val M2) (mulq 2 (val M1) idq)).
Check (fun n A p t i j => eq_refl : gamma_t n A p t i j = sumQ t (fun s => powq n A s i j) - inject_Z (Z.of_nat t) * p j).
Check (fun n x w => eq_refl : spread n x w = (forall i j, (i < n)%nat -> (j < n)%nat -> x i - x j <= w)).
Check (fun n P p G k c => eq_refl : converges n P p G k c =
  (stochastic n P /\ (0 <= c /\ c < 1) /\ (0 < k)%nat /\
   (forall j, (j < n)%nat -> sumQ n (fun i => p i * P i j) == p j) /\
   (forall j, (j < n)%nat -> 0 <= p j) /\ sumQ n p == 1 /\
   (forall t i j, (i < n)%nat -> (j < n)%nat -> Qabs (powq n P t i j - p j) <= pow c (t / k)) /\
   (forall j w, (j < n)%nat -> spread n (fun i => G i j) w -> forall t i, (i < n)%nat ->
      Qabs (gamma_t n P p t i j - G i j) <= pow c (t / k) * w))).
Check (fun n A x => eq_refl : quad n A x = sumQ n (fun i => x i * sumQ n (fun j => A i j * x j))).
Check (fun m c W i => eq_refl : combination m c W i = sumQ m (fun k => c k * W k i)).
Check (fun n A q => eq_refl : negative_index n A q =
  ((exists W, forall c, (exists k, (k < q)%nat /\ ~ c k == 0) -> quad n A (combination q c W) < 0) /\
   forall m W, (forall c, (exists k, (k < m)%nat /\ ~ c k == 0) -> quad n A (combination m c W) < 0) -> (m <= q)%nat)).
Check (fun n A p => eq_refl : positive_index n A p =
  ((exists W, forall c, (exists k, (k < p)%nat /\ ~ c k == 0) -> 0 < quad n A (combination p c W)) /\
   forall m W, (forall c, (exists k, (k < m)%nat /\ ~ c k == 0) -> 0 < quad n A (combination m c W)) -> (m <= p)%nat)).
Check (fun x v => eq_refl : edge (start x v) = fun i j => Qle_bool (Qabs (x i - x j)) 1).
Check (fun n w h s i j => eq_refl : edge (step n w h s) i j =
  (Qle_bool (Qabs ((place s i + speed s i) - (place s j + speed s j))) 1 ||
   (edge s i j && negb (Qle_bool h (Qabs (Qabs ((place s i + speed s i) - (place s j + speed s j)) -
                                          Qabs (place s i - place s j))))))).
Check (fun n w h s i => eq_refl : speed (step n w h s) i =
  let e := edge (step n w h s) in
  speed s i + w (length (filter (fun j => negb (Nat.eqb i j) && e i j) (seq 0 n))) *
  sumQ n (fun j => if negb (Nat.eqb i j) && e i j then speed s j - speed s i else 0)).
Check (eq_refl : map lazy_weight [1; 2; 3]%nat = [2 # 3; 2 # 6; 2 # 9]).
Check (eq_refl : map four_x [0; 1; 2; 3]%nat = [0 # 16; 8 # 16; 21 # 16; 29 # 16]).
Check (eq_refl : map four_v [0; 1; 2; 3]%nat = [1 # 8; (-1) # 8; 1 # 8; (-1) # 8]).
Check (eq_refl : path4 = [(0, 1); (1, 2); (2, 3)]%nat).
Check (eq_refl : pairs4 = [(0, 1); (2, 3)]%nat).
Check (fun l i j => eq_refl : listed l i j = existsb (fun p => Nat.eqb (fst p) i && Nat.eqb (snd p) j) l).

(* ---- chazelle ---- *)
Check (gamma_is_the_limit : forall n (P : qmat) (p : nat -> Q) (Gamma : qmat) k c,
  (0 < n)%nat -> (0 < k)%nat -> 0 <= c -> c < 1 -> stochastic n P ->
  (forall j, (j < n)%nat -> sumQ n (fun i => p i * P i j) == p j) ->
  (forall j, (j < n)%nat -> 0 <= p j) -> sumQ n p == 1 ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> distq n (powq n P k) i j <= c) ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> Gamma i j - mulq n P Gamma i j == idq i j - p j) ->
  (forall j, (j < n)%nat -> sumQ n (fun i => p i * Gamma i j) == 0) ->
  converges n P p Gamma k c).
Check (chazelle_lem3_3_one_edge :
  converges 2 (val ([[12; 3]; [10; 5]]%Z, 15%positive)) (vec ([10; 3]%Z, 13%positive))
    (val ([[45; -45]; [-150; 150]]%Z, 169%positive)) 1 (2 # 15)).
Check (chazelle_lem3_3_path_4_lazy :
  converges 4 (val ([[1; 2; 0; 0]; [1; 1; 1; 0]; [0; 1; 1; 1]; [0; 0; 2; 1]]%Z, 3%positive)) (vec ([1; 2; 2; 1]%Z, 6%positive))
    (val ([[35; 10; -26; -19]; [5; 22; -14; -13]; [-13; -14; 22; 5]; [-19; -26; 10; 35]]%Z, 24%positive)) 2 (5 # 9)).
Check (four_birds_alternate : forall t i j, (t <= 64)%nat -> (i < j < 4)%nat ->
  edge (run 4 lazy_weight 0 (start four_x four_v) t) i j = listed (if Nat.even t then path4 else pairs4) i j).
Check (four_birds_held : forall t i j, (t <= 330)%nat -> (i < j < 4)%nat ->
  edge (run 4 lazy_weight (1 # 4 ^ 256) (start four_x four_v) t) i j =
  listed (if Nat.even t || Nat.leb 322 t then path4 else pairs4) i j).
Check (product_AB : is_tau1 3 (prodq 3 (concat (repeat
  [([[0; 2; 0]; [1; 0; 1]; [0; 2; 0]]%Z, 2%positive); ([[0; 1; 0]; [1; 0; 0]; [0; 0; 1]]%Z, 1%positive)] 30))) (1 # 2 ^ 29)).
Check (product_four_birds : is_tau1 4 (prodq 4 (concat (repeat
  [([[1; 2; 0; 0]; [2; 1; 0; 0]; [0; 0; 1; 2]; [0; 0; 2; 1]]%Z, 3%positive);
   ([[1; 2; 0; 0]; [1; 1; 1; 0]; [0; 1; 1; 1]; [0; 0; 2; 1]]%Z, 3%positive)] 8))) (895795 # 3 ^ 15)).

(* ---- quadratic forms ---- *)
Check (law_of_inertia : forall n A p q p' q', has_inertia n A p q -> has_inertia n A p' q' -> p = p' /\ q = q').
Check (index_certificate : forall n A M D K p q, inertia_check n A M D K p q = true ->
  positive_index n (val A) p /\ negative_index n (val A) q).
Check (path6_semidefinite :
  let A := val ([[1; -1; 0; 0; 0; 0]; [-1; 2; -1; 0; 0; 0]; [0; -1; 2; -1; 0; 0];
    [0; 0; -1; 2; -1; 0]; [0; 0; 0; -1; 2; -1]; [0; 0; 0; 0; -1; 1]]%Z, 1%positive) in
  (forall x, 0 <= quad 6 A x) /\ positive_index 6 A 5).
Check (ring5_and_path3_semidefinite :
  let A := val ([[2; -1; 0; 0; -1; 0; 0; 0]; [-1; 2; -1; 0; 0; 0; 0; 0];
    [0; -1; 2; -1; 0; 0; 0; 0]; [0; 0; -1; 2; -1; 0; 0; 0]; [-1; 0; 0; -1; 2; 0; 0; 0]; [0; 0; 0; 0; 0; 1; -1; 0];
    [0; 0; 0; 0; 0; -1; 2; -1]; [0; 0; 0; 0; 0; 0; -1; 1]]%Z, 1%positive) in
  (forall x, 0 <= quad 8 A x) /\ positive_index 8 A 6).
Check (saddle_three_and_one :
  let A := val ([[-1; 1; 1; -1]; [1; -1; 1; -1]; [1; 1; -1; -1]; [-1; -1; -1; 3]]%Z, 4%positive) in
  ((exists x, 0 < quad 4 A x) /\ (exists x, quad 4 A x < 0)) /\ positive_index 4 A 1 /\ negative_index 4 A 2).
Check (saddle_four_and_two :
  let A := val (hessian [1; 1; 1; 1; -1; -1]%Z) in
  ((exists x, 0 < quad 6 A x) /\ (exists x, quad 6 A x < 0)) /\ positive_index 6 A 2 /\ negative_index 6 A 3).
Check (eq_refl : hessian [1; 1; 1; 1; -1; -1]%Z = ([[-1; 1; 1; 1; -1; -1]; [1; -1; 1; 1; -1; -1]; [1; 1; -1; 1; -1; -1];
  [1; 1; 1; -1; -1; -1]; [-1; -1; -1; -1; 3; 1]; [-1; -1; -1; -1; 1; 3]]%Z, 6%positive)).
