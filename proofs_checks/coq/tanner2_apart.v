(* Tanner, Jadbabaie, Pappas II, section 4, corrected: in a minimum of the sum of all potentials no two agents are in one place.
     beyond.tanner2.sec4.flocking (clause 2), tanner2.sec4.flocking (corrected).
   Potentials of Definition 3 are infinite where two agents meet, so the sum is infinite there, and near every configuration there is one where all agents are apart. *)
From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums paley_model tanner_energy tanner_flock.
Open Scope R_scope.

Definition all_apart n (r : nat -> C) : Prop := forall i j, (i < n)%nat -> (j < n)%nat -> i <> j -> r i <> r j.
Definition sum_of_all n (V : nat -> nat -> R -> R) (r : nat -> C) : R := Sum n (fun i => Sum n (fun j => if Nat.eqb i j then 0 else V i j (norm (r i - r j)%C))).
(* the sum of the V_ij at r is at most that at q, as numbers up to infinity: infinite where two agents are in one place *)
Definition not_above n V (r q : nat -> C) : Prop := all_apart n q -> all_apart n r /\ sum_of_all n V r <= sum_of_all n V q.
Definition below n V (r q : nat -> C) : Prop := all_apart n q -> all_apart n r /\ sum_of_all n V r < sum_of_all n V q.
(* a rotation by a, |a| = 1, and a translation by b *)
Definition moved_by n (a b : C) (r q : nat -> C) : Prop := Cmod a = 1 /\ forall i, (i < n)%nat -> q i = (a * r i + b)%C.
(* a strict minimum up to motions *)
Definition strict_minimum n V (r : nat -> C) : Prop := exists d, 0 < d /\ forall q, (forall i, (i < n)%nat -> norm (q i - r i)%C < d) ->
  not_above n V r q /\ (below n V r q \/ exists a b, moved_by n a b r q).
Lemma apart_near n (r : nat -> C) d : 0 < d -> exists q, (forall i, (i < n)%nat -> norm (q i - r i)%C < d) /\ all_apart n q.
Proof.
  intros Hd. set (x := fun i => fst (r i)).
  destruct (uniform_pairs n (fun i j b => x i <> x j -> / b <= Rabs (x i - x j) /\ 0 < b)) as (b & Hb & B).
  - intros i j c c' H L N. destruct (H N) as [H1 H2]. split; [|lra]. apply Rle_trans with (/ c); [|exact H1]. apply Rinv_le_contravar; lra.
  - intros i j _ _. destruct (Req_dec (x i) (x j)) as [E|N]; [exists 1; intros Q; contradiction|]. exists (/ Rabs (x i - x j)).
    assert (P : 0 < Rabs (x i - x j)) by (apply Rabs_pos_lt; lra). intros _. rewrite Rinv_inv. split; [lra|now apply Rinv_0_lt_compat].
  - set (t := Rmin (d / (INR n + 1)) (/ b / (INR n + 1))). pose proof (pos_INR n) as Pn. assert (Ib : 0 < / b) by now apply Rinv_0_lt_compat.
    assert (T0 : 0 < t) by (unfold t; apply Rmin_glb_lt; apply Rdiv_lt_0_compat; lra).
    assert (T1 : t * (INR n + 1) <= d). { unfold t. apply Rle_trans with (d / (INR n + 1) * (INR n + 1)); [apply Rmult_le_compat_r; [lra|apply Rmin_l]|right; field; lra]. }
    assert (T2 : t * (INR n + 1) <= / b). { unfold t. apply Rle_trans with (/ b / (INR n + 1) * (INR n + 1)); [apply Rmult_le_compat_r; [lra|apply Rmin_r]|right; field; lra]. }
    exists (fun i => (r i + RtoC (t * INR i))%C). split.
    + intros i Hi. replace (r i + RtoC (t * INR i) - r i)%C with (RtoC (t * INR i)) by ring. unfold norm. rewrite Cmod_R. apply lt_INR in Hi. pose proof (pos_INR i).
      rewrite Rabs_pos_eq by (apply Rmult_le_pos; lra). apply Rlt_le_trans with (2 := T1). apply Rmult_lt_compat_l; lra.
    + intros i j Hi Hj N E. apply (f_equal fst) in E. cbn in E. fold (x i) (x j) in E. apply lt_INR in Hi as Hi'. apply lt_INR in Hj as Hj'. pose proof (pos_INR i). pose proof (pos_INR j).
      assert (NI : INR i <> INR j) by (intros Q; apply INR_eq in Q; contradiction).
      destruct (Req_dec (x i) (x j)) as [Q|Q].
      * apply NI. apply (Rmult_eq_reg_l t); lra.
      * destruct (B i j Hi Hj Q) as [B1 _]. assert (D : x i - x j = t * (INR j - INR i)) by lra. rewrite D, Rabs_mult, (Rabs_pos_eq t) in B1 by lra.
        assert (Ab : Rabs (INR j - INR i) < INR n + 1) by (apply Rabs_lt_between; lra). assert (t * Rabs (INR j - INR i) < t * (INR n + 1)) by (apply Rmult_lt_compat_l; assumption). lra.
Qed.
Theorem minimum_apart n V r : strict_minimum n V r -> forall a b q, moved_by n a b r q -> all_apart n q.
Proof.
  intros (d & Hd & M) a b q [Ha Q]. destruct (apart_near n r d Hd) as (p & P1 & P2). destruct (M p P1) as [L _]. destruct (L P2) as [A _].
  intros i j Hi Hj N E. rewrite (Q i Hi), (Q j Hj) in E. apply (A i j Hi Hj N).
  assert (Z : (a * (r i - r j))%C = RtoC 0) by (replace (a * (r i - r j))%C with ((a * r i + b) - (a * r j + b))%C by ring; rewrite E; ring).
  assert (W : (r i - r j)%C = RtoC 0).
  { apply Cmod_eq_0. apply (f_equal Cmod) in Z. rewrite Cmod_mult, Ha, Cmod_0 in Z. lra. }
  replace (r i) with ((r i - r j) + r j)%C by ring. rewrite W. ring.
Qed.
