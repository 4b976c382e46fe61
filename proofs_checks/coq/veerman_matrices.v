(* Veerman, Stosic, Olvera, section 2: the equations of motion in matrix form.
     veerman.eq1_matrix, veerman.eq2_matrix, veerman.dimL.
   Agents 0 (the leader) to N + 1.  The directed Laplacians L_1, L_2 are (N+2) x (N+2); P_i is what is left without the
   leader's row and column, L_l the rest of its column.  Row k of  I (x) A x + P (x) K (x - zeta) + L_l (x) (K (x_l - zeta_l))
   has the two components below (A = [[0,1],[0,0]], K = [[0,0],[f,g]]). *)
From Coq Require Import Reals Lra Lia.
Open Scope R_scope.

(* entries of the printed matrices, indices 0 to N + 1 *)
Definition L1 (i j : nat) : R := if Nat.eqb i 0 then 0 else if Nat.eqb i j then 1 else if Nat.eqb i (S j) then -1 else 0.
Definition L2 (N i j : nat) : R :=
  if Nat.eqb i 0 then 0 else if Nat.eqb i j then 1
  else if Nat.eqb i (S N) then (if Nat.eqb i (S j) then -1 else 0)
  else if Nat.eqb i (S j) then - / 2 else if Nat.eqb j (S i) then - / 2 else 0.
(* sum over the followers 1 to n *)
Fixpoint sum (F : nat -> R) (n : nat) : R := match n with O => 0 | S n => sum F n + F (S n) end.

(* the two components of row k of the vector form; (x, u) is the state, z = x - zeta with zeta = (h, 0) *)
Definition A12 : R := 1.
Definition form_x (u : nat -> R) (k : nat) : R := A12 * u k.
Definition form_u (f g : R) (L : nat -> nat -> R) (N : nat) (x h u : nat -> R) (k : nat) : R :=
  sum (fun j => L k j * (f * (x j - h j) + g * u j)) (S N) + L k 0%nat * (f * (x 0%nat - h 0%nat) + g * u 0%nat).

Lemma sum_ext F F' n : (forall k, (1 <= k <= n)%nat -> F k = F' k) -> sum F n = sum F' n.
Proof. induction n as [|n IH]; intros H; cbn [sum]; [reflexivity|]. rewrite IH, H by (intros; try apply H; lia). reflexivity. Qed.
Lemma sum_zero F n : (forall k, (1 <= k <= n)%nat -> F k = 0) -> sum F n = 0.
Proof. induction n as [|n IH]; intros H; cbn [sum]; [reflexivity|]. rewrite IH, H by (intros; try apply H; lia). ring. Qed.
Lemma sum_plus F F' n : sum (fun k => F k + F' k) n = sum F n + sum F' n.
Proof. induction n as [|n IH]; cbn [sum]; [ring|rewrite IH; ring]. Qed.
Lemma sum_pick F n k : (1 <= k <= n)%nat -> sum (fun j => if Nat.eqb j k then F j else 0) n = F k.
Proof.
  induction n as [|n IH]; intros H; [lia|]. cbn [sum]. destruct (Nat.eqb_spec (S n) k) as [E|E].
  - subst k. rewrite sum_zero; [ring|]. intros j Hj. replace (Nat.eqb j (S n)) with false; [reflexivity|].
    symmetry. apply Nat.eqb_neq. lia.
  - rewrite IH by lia. ring.
Qed.
Lemma sum_pick0 F n : sum (fun j => if Nat.eqb j 0 then F j else 0) n = 0.
Proof. apply sum_zero. intros k H. replace (Nat.eqb k 0) with false; [reflexivity|]. symmetry. apply Nat.eqb_neq. lia. Qed.

Ltac calc := cbv beta iota; ring.
Ltac cases_eqb := repeat match goal with |- context [Nat.eqb ?a ?b] => destruct (Nat.eqb_spec a b); [try (exfalso; lia)|try (exfalso; lia)] end.
(* veerman.eq1_matrix: the forces *)
Theorem equation_1_vector f g N x h u k : (1 <= k <= S N)%nat ->
  form_x u k = u k /\
  form_u f g L1 N x h u k = f * ((x k - h k) - (x (k - 1)%nat - h (k - 1)%nat)) + g * (u k - u (k - 1)%nat).
Proof.
  intros Hk. split; [unfold form_x, A12; ring|]. unfold form_u. destruct k as [|k]; [lia|]. replace (S k - 1)%nat with k by lia.
  set (y := fun j => f * (x j - h j) + g * u j).
  rewrite (sum_ext _ (fun j => (if Nat.eqb j (S k) then y j else 0) + (if Nat.eqb j k then - y j else 0))).
  - rewrite sum_plus, (sum_pick y) by lia. unfold L1. cbn [Nat.eqb]. destruct k as [|k].
    + rewrite (sum_pick0 (fun j => - y j)). cbn [Nat.eqb]. unfold y. calc.
    + rewrite (sum_pick (fun j => - y j)) by lia. cbn [Nat.eqb]. unfold y. calc.
  - intros j Hj. unfold L1. fold (y j). cases_eqb; subst; ring.
Qed.

(* veerman.eq2_matrix: the forces; the last car tracks its predecessor only *)
Theorem equation_2_vector f g N x h u k : (1 <= k <= S N)%nat ->
  form_x u k = u k /\
  form_u f g (L2 N) N x h u k =
    if Nat.eqb k (S N) then f * ((x k - h k) - (x (k - 1)%nat - h (k - 1)%nat)) + g * (u k - u (k - 1)%nat)
    else f * ((x k - h k) - / 2 * (x (k - 1)%nat - h (k - 1)%nat + (x (k + 1)%nat - h (k + 1)%nat)))
         + g * (u k - / 2 * (u (k - 1)%nat + u (k + 1)%nat)).
Proof.
  intros Hk. split; [unfold form_x, A12; ring|]. unfold form_u. destruct k as [|k]; [lia|].
  replace (S k - 1)%nat with k by lia. replace (S k + 1)%nat with (S (S k)) by lia.
  set (y := fun j => f * (x j - h j) + g * u j).
  destruct (Nat.eqb_spec (S k) (S N)) as [EN|EN].
  - injection EN as ->.
    rewrite (sum_ext _ (fun j => (if Nat.eqb j (S N) then y j else 0) + (if Nat.eqb j N then - y j else 0))).
    + rewrite sum_plus, (sum_pick y) by lia. unfold L2. cbn [Nat.eqb]. rewrite Nat.eqb_refl. destruct N as [|N].
      * rewrite (sum_pick0 (fun j => - y j)). cbn [Nat.eqb]. unfold y. calc.
      * rewrite (sum_pick (fun j => - y j)) by lia. cbn [Nat.eqb]. unfold y. calc.
    + intros j Hj. unfold L2. fold (y j). cases_eqb; try subst j; ring.
  - assert (EN' : Nat.eqb k N = false) by (apply Nat.eqb_neq; lia).
    rewrite (sum_ext _ (fun j => ((if Nat.eqb j (S k) then y j else 0) + (if Nat.eqb j k then - / 2 * y j else 0))
       + (if Nat.eqb j (S (S k)) then - / 2 * y j else 0))).
    + rewrite !sum_plus, (sum_pick y), (sum_pick (fun j => - / 2 * y j) _ (S (S k))) by lia.
      unfold L2. cbn [Nat.eqb]. rewrite EN'. destruct k as [|k].
      * rewrite (sum_pick0 (fun j => - / 2 * y j)). cbn [Nat.eqb]. unfold y. calc.
      * rewrite (sum_pick (fun j => - / 2 * y j)) by lia. cbn [Nat.eqb]. unfold y. calc.
    + intros j Hj. unfold L2. fold (y j). cases_eqb; try subst j; ring.
Qed.
(* the rows of the Laplacians sum to zero: a shift of all desired positions changes nothing; row 0 is the leader's *)
Theorem leader_row N j : L1 0 j = 0 /\ L2 N 0 j = 0.
Proof. split; reflexivity. Qed.
