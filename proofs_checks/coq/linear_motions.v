(* Linear systems x' = A x of any finite order: from every start a solution for all times, as a power series. *)
From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums.
Open Scope R_scope.

Lemma PSeries_Sum p (b : nat -> R) (c : nat -> nat -> R) t : (forall j, (j < p)%nat -> ex_pseries (c j) t) ->
  ex_pseries (fun m => Sum p (fun j => b j * c j m)) t /\ PSeries (fun m => Sum p (fun j => b j * c j m)) t = Sum p (fun j => b j * PSeries (c j) t).
Proof.
  induction p as [|p IH]; intros H.
  - cbn [Sum]. split; [|apply PSeries_const_0]. apply CV_radius_inside. rewrite CV_radius_const_0. exact I.
  - destruct (IH (fun j Hj => H j ltac:(lia))) as [E V]. specialize (H p ltac:(lia)).
    assert (E2 : ex_pseries (PS_scal (b p) (c p)) t) by (apply ex_pseries_scal; [apply Rmult_comm|exact H]).
    assert (X : forall m, PS_plus (fun m => Sum p (fun j => b j * c j m)) (PS_scal (b p) (c p)) m = Sum (S p) (fun j => b j * c j m)) by (intros m; reflexivity).
    split.
    + apply (ex_pseries_ext _ _ t X). now apply ex_pseries_plus.
    + rewrite <- (PSeries_ext _ _ t X), PSeries_plus, PSeries_scal, V by assumption. reflexivity.
Qed.
Lemma entire (a : nat -> R) K B : (forall m, Rabs (a m) <= K * (B ^ m / INR (fact m))) -> forall t, Rbar_lt (Finite (Rabs t)) (CV_radius a).
Proof.
  intros H t. apply Rbar_lt_le_trans with (Finite (Rabs t + 1)); [cbn; lra|]. apply (proj1 (CV_radius_bounded a)). set (r := Rabs t + 1).
  destruct (maj_by_pos (fun m => (B * r) ^ m / INR (fact m))) as (l & Hl & L); [exists 0; apply cv_speed_pow_fact|]. exists (Rabs K * l). intros m.
  rewrite Rabs_mult. apply Rle_trans with (K * (B ^ m / INR (fact m)) * Rabs (r ^ m)); [apply Rmult_le_compat_r; [apply Rabs_pos|apply H]|].
  apply Rle_trans with (1 := Rle_abs _). rewrite !Rabs_mult, Rabs_Rabsolu, Rmult_assoc, <- Rabs_mult.
  apply Rmult_le_compat_l; [apply Rabs_pos|]. specialize (L m). rewrite Rpow_mult_distr in L. replace (B ^ m / INR (fact m) * r ^ m) with (B ^ m * r ^ m / INR (fact m)) by (unfold Rdiv; ring). exact L.
Qed.
Section Linear.
Variables (n : nat) (A : nat -> nat -> R) (x0 : nat -> R).
Fixpoint coefficient (m : nat) (i : nat) : R := match m with O => x0 i | S m => Sum n (fun j => A i j * coefficient m j) / INR (S m) end.
Lemma Sum_abs p (b c : nat -> R) K : (forall j, (j < p)%nat -> Rabs (c j) <= K) -> Rabs (Sum p (fun j => b j * c j)) <= Sum p (fun j => Rabs (b j)) * K.
Proof.
  induction p as [|p IH]; intros H; cbn [Sum]; [rewrite Rabs_R0; lra|]. eapply Rle_trans; [apply Rabs_triang|]. rewrite Rmult_plus_distr_r. apply Rplus_le_compat; [apply IH; intros; apply H; lia|].
  rewrite Rabs_mult. apply Rmult_le_compat_l; [apply Rabs_pos|apply H; lia].
Qed.
Lemma bounded_below p (h : nat -> R) : exists K, 0 <= K /\ forall i, (i < p)%nat -> h i <= K.
Proof.
  induction p as [|p (K & K0 & HK)]; [exists 0; split; [lra|intros; lia]|]. exists (Rmax K (h p)). pose proof (Rmax_l K (h p)). pose proof (Rmax_r K (h p)). split; [lra|].
  intros i Hi. destruct (Nat.eq_dec i p) as [->|N]; [lra|]. specialize (HK i ltac:(lia)). lra.
Qed.
Lemma coefficient_bound : exists K B, forall i m, (i < n)%nat -> Rabs (coefficient m i) <= K * (B ^ m / INR (fact m)).
Proof.
  destruct (bounded_below n (fun i => Rabs (x0 i))) as (K & K0 & HK). destruct (bounded_below n (fun i => Sum n (fun j => Rabs (A i j)))) as (B & B0 & HB). exists K, B. intros i m. revert i.
  induction m as [|m IH]; intros i Hi; [cbn; specialize (HK i Hi); lra|]. pose proof (lt_0_INR (S m) ltac:(lia)) as P. pose proof (INR_fact_lt_0 m) as Q.
  assert (T : 0 <= K * (B ^ m / INR (fact m))) by (apply Rmult_le_pos; [exact K0|apply Rdiv_le_0_compat; [now apply pow_le|exact Q]]).
  cbn [coefficient]. unfold Rdiv. rewrite Rabs_mult, (Rabs_pos_eq (/ INR (S m))) by (left; now apply Rinv_0_lt_compat).
  rewrite fact_simpl, mult_INR. replace (K * (B ^ S m * / (INR (S m) * INR (fact m)))) with (B * (K * (B ^ m / INR (fact m))) * / INR (S m)) by (cbn [pow]; field; split; lra).
  apply Rmult_le_compat_r; [left; now apply Rinv_0_lt_compat|]. eapply Rle_trans; [apply Sum_abs; exact IH|]. apply Rmult_le_compat_r; [exact T|now apply HB].
Qed.
Theorem linear_motion : exists x : nat -> R -> R, (forall i, (i < n)%nat -> x i 0 = x0 i) /\ forall i t, (i < n)%nat -> is_derive (x i) t (Sum n (fun j => A i j * x j t)).
Proof.
  destruct coefficient_bound as (K & B & H). exists (fun i t => PSeries (fun m => coefficient m i) t).
  assert (E : forall i t, (i < n)%nat -> Rbar_lt (Finite (Rabs t)) (CV_radius (fun m => coefficient m i))) by (intros i t Hi; apply (entire _ K B); intros m; now apply H).
  split; [intros i Hi; apply PSeries_0|]. intros i t Hi. evar_last; [apply is_derive_PSeries; now apply E|].
  rewrite (PSeries_ext _ (fun m => Sum n (fun j => A i j * coefficient m j)) t).
  - apply (PSeries_Sum n (A i) (fun j m => coefficient m j) t). intros j Hj. apply CV_radius_inside. now apply E.
  - intros m. unfold PS_derive. cbn [coefficient]. field. apply not_0_INR. lia.
Qed.
End Linear.
