(* beyond.paley.inertia: the second derivatives of U_1 = |sum e^(i theta)|^2/(2N) in real phases are those written out in
   audit_independent_inertia; and beyond.paley.cyclic_eigenvectors clause 4. Stated after the theorems had been seen. *)
From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums paley_model paley_phase paley_laplacian paley_gradient.
From Flockproof Require paley_fourier paley_patterns paley_fish audit_independent_corrected.
Module P := audit_independent_corrected.
Open Scope R_scope.

Definition potential n (th : nat -> R) : R := / (2 * INR n) * (Sum n (fun j => cos (th j)) ^ 2 + Sum n (fun j => sin (th j)) ^ 2).
Definition moved (th : nat -> R) (k : nat) (h : R) (j : nat) : R := if Nat.eqb j k then th j + h else th j.
Definition slope n (th : nat -> R) (k : nat) : R := - / INR n * Sum n (fun j => sin (th k - th j)).
Definition second n (th : nat -> R) (k l : nat) : R :=
  / INR n * (if Nat.eqb k l then - Sum n (fun j => if Nat.eqb j k then 0 else cos (th j - th k)) else cos (th k - th l)).
Definition derivatives : Prop := forall n th k l, (1 <= n)%nat -> (k < n)%nat -> (l < n)%nat ->
  is_derive (fun h => potential n (moved th k h)) 0 (slope n th k) /\ is_derive (fun h => slope n (moved th l h) k) 0 (second n th k l).
(* every eigenvector of the Laplacian of C_N with entries of modulus one is a symmetric pattern if and only if 4 does not divide N *)
Definition cyclic_4 : Prop := forall n adj, (3 <= n)%nat -> P.cyclic n adj ->
  ((forall lam th, P.eigenvector n adj lam (fun k => expi (th k)) -> exists M, paley_patterns.pattern M n th) <-> ~ exists q, n = (4 * q)%nat).

Lemma moved_D th k j : is_derive (fun h => moved th k h j) 0 (delta j k).
Proof.
  unfold moved, delta. destruct (Nat.eqb j k); [|apply D_const]. eapply D_eq; [apply D_plus; [apply D_const|apply D_id]|]. ring.
Qed.
Lemma moved_0 th k j : moved th k 0 j = th j.
Proof. unfold moved. destruct (Nat.eqb j k); ring. Qed.
Lemma derivatives_hold : derivatives.
Proof.
  intros n th k l Hn Hk Hl. pose proof (INR_pos n Hn) as P. split.
  - unfold potential. eapply D_eq.
    + apply D_scal, D_plus; apply D_sqr.
      * apply (D_Sum n (fun j h => cos (moved th k h j)) (fun j => - sin (th j) * delta j k)). intros j _.
        eapply D_eq; [apply D_cos, moved_D|]. cbv beta. now rewrite moved_0.
      * apply (D_Sum n (fun j h => sin (moved th k h j)) (fun j => cos (th j) * delta j k)). intros j _.
        eapply D_eq; [apply D_sin, moved_D|]. cbv beta. now rewrite moved_0.
    + cbv beta. rewrite (Sum_ext n (fun j => - sin (th j) * delta j k) (fun j => delta j k * - sin (th j))) by (intros; ring).
      rewrite (Sum_ext n (fun j => cos (th j) * delta j k) (fun j => delta j k * cos (th j))) by (intros; ring).
      rewrite (Sum_delta n k (fun j => - sin (th j)) Hk), (Sum_delta n k (fun j => cos (th j)) Hk).
      rewrite (Sum_ext n (fun j => cos (moved th k 0 j)) (fun j => cos (th j))) by (intros; now rewrite moved_0).
      rewrite (Sum_ext n (fun j => sin (moved th k 0 j)) (fun j => sin (th j))) by (intros; now rewrite moved_0).
      unfold slope. rewrite (Sum_ext n (fun j => sin (th k - th j)) (fun j => sin (th k) * cos (th j) - cos (th k) * sin (th j))) by (intros; apply sin_minus).
      rewrite Sum_minus, !Sum_scal. field. lra.
  - unfold slope. eapply D_eq.
    + apply D_scal. apply (D_Sum n (fun j h => sin (moved th l h k - moved th l h j)) (fun j => cos (th k - th j) * (delta k l - delta j l))). intros j _.
      eapply D_eq; [apply D_sin, D_minus; apply moved_D|]. cbv beta. now rewrite !moved_0.
    + unfold second. destruct (Nat.eqb_spec k l) as [<-|N].
      * rewrite delta_eq. replace (- / INR n) with (/ INR n * -1) by ring. rewrite Rmult_assoc. f_equal. rewrite <- Sum_scal, <- Sum_opp. apply Sum_ext. intros j _.
        unfold delta. destruct (Nat.eqb_spec j k) as [->|_]; [ring|]. replace (th j - th k) with (- (th k - th j)) by ring. rewrite cos_neg. ring.
      * rewrite (Sum_ext n _ (fun j => delta j l * - cos (th k - th j))) by (intros; rewrite (delta_neq k l N); ring).
        rewrite (Sum_delta n l (fun j => - cos (th k - th j)) Hl). ring.
Qed.
Lemma cyclic_4_holds : cyclic_4.
Proof.
  intros n adj Hn Cy. rewrite <- (paley_fish.ring_patterns n Hn).
  assert (E : forall lam th, P.eigenvector n adj lam (fun k => expi (th k)) <-> eigenvector n (lap n (paley_fourier.ring_graph n)) lam (phasors th)).
  { intros lam th. assert (Q : forall k, (k < n)%nat -> Csum n (fun j => RtoC (lap n adj k j) * expi (th j))%C = row n (lap n (paley_fourier.ring_graph n)) k (phasors th)).
    { intros k Hk. exact (P.cyclic_same n adj Hn Cy (fun j => expi (th j)) k Hk). }
    split.
    - intros [_ H] k Hk. rewrite <- Q by exact Hk. now apply H.
    - intros H. split; [|intros k Hk; rewrite Q by exact Hk; now apply H]. exists 0%nat. split; [lia|]. intros Z. apply (f_equal fst) in Z as Z1. apply (f_equal snd) in Z as Z2.
      cbn in Z1, Z2. pose proof (sin2_cos2 (th 0%nat)) as X. unfold Rsqr in X. rewrite Z1, Z2 in X. lra. }
  split; intros H lam th K; apply (H lam th); now apply E.
Qed.
