(* What the generated theorems say, in the terms of the claims. *)
From Coq Require Import ZArith QArith Qabs List Lia Lqa Bool Arith.
From Flockproof Require Import certificate_matrices.
From Flockproof Require Import certificate_limits.
From Flockproof Require Import certificate_inertia.
From Flockproof Require Import certificate_index.
From Flockproof Require Import certificate_flocks.
From Flockproof Require Import gen_products.
From Flockproof Require Import gen_limits.
From Flockproof Require Import gen_switches.
From Flockproof Require Import gen_inertia.
Import ListNotations.
Open Scope Q_scope.

(* ---- the four birds of chazelle.ex4birds, birds from 0 ---- *)
Definition four_x (i : nat) : Q := nth i [0; 8; 21; 29]%Z 0%Z # 16.
Definition four_v (i : nat) : Q := nth i [1; -1; 1; -1]%Z 0%Z # 8.
Definition path4 : list (nat * nat) := [(0, 1); (1, 2); (2, 3)]%nat.
Definition pairs4 : list (nat * nat) := [(0, 1); (2, 3)]%nat.

(* A start enters only by the values of its numbers. *)
Definition same n (r s : flock) := (forall i, (i < n)%nat -> place r i == place s i) /\
  (forall i, (i < n)%nat -> speed r i == speed s i) /\
  (forall i j, (i < n)%nat -> (j < n)%nat -> edge r i j = edge s i j).
Lemma near_same x y i j : x i == y i -> x j == y j -> is_near x i j = is_near y i j.
Proof. intros A B. unfold is_near. apply eq_true_iff_eq. now rewrite !Qle_bool_iff, A, B. Qed.
Lemma step_same n w h r s : same n r s -> same n (step n w h r) (step n w h s).
Proof.
  intros (X & V & E). unfold step. set (er := fun i j => _ || _). set (es := fun i j : nat => _ || _).
  assert (Y : forall i, (i < n)%nat -> place r i + speed r i == place s i + speed s i).
  { intros i Hi. now rewrite (X i Hi), (V i Hi). }
  assert (EE : forall i j, (i < n)%nat -> (j < n)%nat -> er i j = es i j).
  { intros i j Hi Hj. unfold er, es. rewrite (E i j Hi Hj). f_equal; [apply near_same; now apply Y|]. f_equal.
    unfold is_held. f_equal. apply eq_true_iff_eq. now rewrite !Qle_bool_iff, !Y, !X by assumption. }
  split; [exact Y|]. split; [|exact EE]. intros i Hi. cbn [speed].
  assert (N : forall j, (j < n)%nat -> neighbour er i j = neighbour es i j) by
    (intros j Hj; unfold neighbour; now rewrite (EE i j Hi Hj)).
  assert (D : degree n er i = degree n es i) by (unfold degree; f_equal; apply filter_ext_seq; exact N).
  rewrite D, (V i Hi). apply Qplus_comp; [reflexivity|]. apply Qmult_comp; [reflexivity|].
  apply sum_ext. intros j Hj. rewrite (N j Hj). destruct (neighbour es i j); [now rewrite (V i Hi), (V j Hj)|reflexivity].
Qed.
Lemma run_same n w h r s t : same n r s -> same n (run n w h r t) (run n w h s t).
Proof. intros H. induction t as [|t IH]; [exact H|]. cbn [run]. now apply step_same. Qed.
Lemma start_same n x v y u : (forall i, (i < n)%nat -> x i == y i) -> (forall i, (i < n)%nat -> v i == u i) ->
  same n (start x v) (start y u).
Proof. intros H K. split; [exact H|]. split; [exact K|]. intros i j Hi Hj. apply near_same; now apply H. Qed.

(* Two lists of edges for all times up to a bound. *)
Definition list_eqb (a b : list (nat * nat)) : bool :=
  Nat.eqb (length a) (length b) && forallb (fun p => Nat.eqb (fst (fst p)) (fst (snd p)) && Nat.eqb (snd (fst p)) (snd (snd p))) (combine a b).
Lemma list_eqb_true a : forall b, list_eqb a b = true -> a = b.
Proof.
  induction a as [|[i j] a IH]; intros [|[k l] b]; unfold list_eqb; cbn; try discriminate; [reflexivity|].
  intros H. apply andb_prop in H as [L H]. apply andb_prop in H as [H K]. apply andb_prop in H as [P Q].
  apply Nat.eqb_eq in P, Q. subst. f_equal. apply IH. unfold list_eqb. now rewrite L, K.
Qed.
Lemma for_all_times (f g : nat -> list (nat * nat)) until :
  forallb (fun t => list_eqb (f t) (g t)) (seq 0 (S until)) = true -> forall t, (t <= until)%nat -> f t = g t.
Proof.
  intros H t Ht. rewrite forallb_forall in H. apply list_eqb_true, H, in_seq. lia.
Qed.

(* chazelle.ex4birds.alt up to t = 64: no hysteresis, the path at even t and two pairs at odd t. *)
Theorem four_birds_alternate t i j : (t <= 64)%nat -> (i < j < 4)%nat ->
  edge (run 4 lazy_weight 0 (start four_x four_v) t) i j = listed (if Nat.even t then path4 else pairs4) i j.
Proof.
  intros Ht Hij. pose proof (chazelle_ex4birds_alt_to_64 t Ht i j Hij) as H.
  assert (N : forall t, (t <= 64)%nat -> network_at chazelle_ex4birds_alt_to_64_first chazelle_ex4birds_alt_to_64_later t = if Nat.even t then path4 else pairs4).
  { apply for_all_times. vm_compute. reflexivity. }
  rewrite (N t Ht) in H. rewrite <- H. symmetry. refine (proj2 (proj2 (run_same 4 lazy_weight _ _ _ t (start_same 4 _ _ _ _ _ _))) i j _ _); try lia.
  all: intros k Hk; do 4 (destruct k as [|k]; [vm_compute; reflexivity|]); lia.
Qed.

(* chazelle.hyst: with the threshold 4^(-4^4) the same flock alternates up to t = 321 and keeps the path from 322 to 330. *)
Theorem four_birds_held t i j : (t <= 330)%nat -> (i < j < 4)%nat ->
  edge (run 4 lazy_weight (1 # 4 ^ 256) (start four_x four_v) t) i j =
  listed (if Nat.even t || Nat.leb 322 t then path4 else pairs4) i j.
Proof.
  intros Ht Hij. pose proof (chazelle_hyst_four_birds_to_330 t Ht i j Hij) as H.
  assert (N : forall t, (t <= 330)%nat -> network_at chazelle_hyst_four_birds_to_330_first chazelle_hyst_four_birds_to_330_later t = if Nat.even t || Nat.leb 322 t then path4 else pairs4).
  { apply for_all_times. vm_compute. reflexivity. }
  rewrite (N t Ht) in H. rewrite <- H. symmetry.
  replace (1 # 4 ^ 256) with chazelle_hyst_four_birds_to_330_threshold by (vm_compute; reflexivity).
  refine (proj2 (proj2 (run_same 4 lazy_weight _ _ _ t (start_same 4 _ _ _ _ _ _))) i j _ _); try lia.
  all: intros k Hk; do 4 (destruct k as [|k]; [vm_compute; reflexivity|]); lia.
Qed.

(* ---- products ---- *)
Definition matrix_A : zmat := ([[0; 1; 0]; [1; 0; 0]; [0; 0; 1]]%Z, 1%positive).
Definition matrix_B : zmat := ([[0; 2; 0]; [1; 0; 1]; [0; 2; 0]]%Z, 2%positive).
(* chazelle.exAB at t = 60, B first: tau_1((AB)^30) = 2^(1 - t/2). *)
Theorem product_AB : is_tau1 3 (prodq 3 (concat (repeat [matrix_B; matrix_A] 30))) (1 # 2 ^ 29).
Proof. exact (proj2 chazelle_exAB_60_factors). Qed.

Definition matrix_pairs : zmat := ([[1; 2; 0; 0]; [2; 1; 0; 0]; [0; 0; 1; 2]; [0; 0; 2; 1]]%Z, 3%positive).
Definition matrix_path : zmat := ([[1; 2; 0; 0]; [1; 1; 1; 0]; [0; 1; 1; 1]; [0; 0; 2; 1]]%Z, 3%positive).
(* chazelle.tau1 on the product P(16) ... P(1) of the four birds. *)
Theorem product_four_birds :
  is_tau1 4 (prodq 4 (concat (repeat [matrix_pairs; matrix_path] 8))) (895795 # 3 ^ 15).
Proof. exact (proj2 chazelle_tau1_four_birds_16_factors). Qed.

(* ---- quadratic forms ---- *)
(* The sum of (x_i - x_j)^2 over the edges is the form of the Laplacian; here only the signs: not negative, and positive on a
   space of n - 1 (n - 2) dimensions and no larger one, as for one (two) connected components. *)
Theorem path6_semidefinite :
  (forall x, 0 <= quad 6 (val tanner2_L_path_6_A) x) /\ positive_index 6 (val tanner2_L_path_6_A) 5.
Proof.
  split; [exact (semidefinite 6 _ 5 tanner2_L_path_6)|exact (sylvester_positive 6 _ 5 0 tanner2_L_path_6)].
Qed.
Theorem ring5_and_path3_semidefinite :
  (forall x, 0 <= quad 8 (val tanner1_L_ring_5_and_path_3_A) x) /\ positive_index 8 (val tanner1_L_ring_5_and_path_3_A) 6.
Proof.
  split; [exact (semidefinite 8 _ 6 tanner1_L_ring_5_and_path_3)|exact (sylvester_positive 8 _ 6 0 tanner1_L_ring_5_and_path_3)].
Qed.
(* The Hessian of U_1 = |sum_k e^(i theta_k)|^2/(2 N) where e^(i theta_k) = s_k is 1 or -1: (1 - s_k sum s)/N on the
   diagonal, s_k s_j/N beside it. *)
Definition hessian (s : list Z) : zmat :=
  let total := fold_right Z.add 0%Z s in
  (table (length s) (fun k j => if Nat.eqb k j then (1 - nth k s 0 * total)%Z else (nth k s 0 * nth j s 0)%Z),
   Pos.of_nat (length s)).
Theorem saddle_three_and_one :
  ((exists x, 0 < quad 4 (val (hessian [1; 1; 1; -1]%Z)) x) /\ (exists x, quad 4 (val (hessian [1; 1; 1; -1]%Z)) x < 0)) /\
  positive_index 4 (val (hessian [1; 1; 1; -1]%Z)) 1 /\ negative_index 4 (val (hessian [1; 1; 1; -1]%Z)) 2.
Proof.
  split; [exact (indefinite 4 _ 0 1 paley_thm1_saddle_three_and_one)|]. split.
  - exact (sylvester_positive 4 _ 1 2 paley_thm1_saddle_three_and_one).
  - exact (sylvester_negative 4 _ 1 2 paley_thm1_saddle_three_and_one).
Qed.
Theorem saddle_four_and_two :
  ((exists x, 0 < quad 6 (val (hessian [1; 1; 1; 1; -1; -1]%Z)) x) /\
   (exists x, quad 6 (val (hessian [1; 1; 1; 1; -1; -1]%Z)) x < 0)) /\
  positive_index 6 (val (hessian [1; 1; 1; 1; -1; -1]%Z)) 2 /\ negative_index 6 (val (hessian [1; 1; 1; 1; -1; -1]%Z)) 3.
Proof.
  split; [exact (indefinite 6 _ 1 2 paley_thm1_saddle_four_and_two)|]. split.
  - exact (sylvester_positive 6 _ 2 3 paley_thm1_saddle_four_and_two).
  - exact (sylvester_negative 6 _ 2 3 paley_thm1_saddle_four_and_two).
Qed.
