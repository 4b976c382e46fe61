(* Veerman, Stosic, Olvera, section 7: followers that are not joined to the leader stay at rest (veerman.nth_neighbour, corrected). *)
From Coq Require Import Reals Lra Lia Psatz Classical.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums veerman_numbers.
Open Scope R_scope.

(* Deviations from the places. Agent k compares itself with those that it tracks, with any weights rho_kj (for system (2) 1/2 and 1/2, or 1; 0 for nobody). *)
Definition follows (n N : nat) (f g : R) (rho : nat -> nat -> R) (z v : nat -> R -> R) : Prop :=
  (forall k j, rho k j <> 0 -> tracks n N k j) /\ forall k t, (1 <= k <= S N)%nat -> 0 <= t -> is_derive (z k) t (v k t) /\
  is_derive (v k) t (Sum (S (S N)) (fun j => rho k j * (f * (z k t - z j t) + g * (v k t - v j t)))).
Lemma joined_end n N i j k : joined n N i j -> tracks n N j k -> joined n N i k.
Proof. intros H T. induction H as [i|i a b Ta _ IH]; [apply there with k; [exact T|constructor]|apply there with a; [exact Ta|now apply IH]]. Qed.
Lemma tracks_sym n N i j : tracks n N i j -> tracks n N j i.
Proof. unfold tracks. tauto. Qed.
Theorem unjoined_rest n N f g rho z v : follows n N f g rho z v ->
  (forall k, (1 <= k <= S N)%nat -> ~ joined n N 0 k -> z k 0 = 0 /\ v k 0 = 0) ->
  forall k t, (1 <= k <= S N)%nat -> ~ joined n N 0 k -> 0 <= t -> z k t = 0 /\ v k t = 0.
Proof.
  intros [Tr L] Z. set (m := S (S N)).
  assert (Dec : exists s : nat -> R, forall i, s i = 0 /\ joined n N 0 i \/ s i = 1 /\ ~ joined n N 0 i).
  { assert (H : forall M, exists s : nat -> R, forall i, (i < M)%nat -> s i = 0 /\ joined n N 0 i \/ s i = 1 /\ ~ joined n N 0 i).
    { induction M as [|M [s H]]; [exists (fun _ => 0); intros; lia|]. destruct (classic (joined n N 0 M)) as [J|J].
      - exists (fun i => if Nat.eqb i M then 0 else s i). intros i Hi. destruct (Nat.eqb_spec i M) as [->|]; [left; now split|apply H; lia].
      - exists (fun i => if Nat.eqb i M then 1 else s i). intros i Hi. destruct (Nat.eqb_spec i M) as [->|]; [right; now split|apply H; lia]. }
    destruct (H m) as [s Hs]. exists (fun i => if Nat.ltb i m then s i else 1). intros i. destruct (Nat.ltb_spec i m) as [A|A]; [now apply Hs|].
    right. split; [reflexivity|]. intros J. assert (B : forall a b, joined n N a b -> (a < m)%nat -> (b < m)%nat).
    { intros a b H1. induction H1 as [|a b c [_ [T _]] _ IH]; [easy|]. intros _. apply IH. unfold m. lia. }
    pose proof (B 0%nat i J ltac:(unfold m; lia)). lia. }
  destruct Dec as [s Hs].
  assert (s0 : s 0%nat = 0) by (destruct (Hs 0%nat) as [[E _]|[_ J]]; [exact E|exfalso; apply J; constructor]).
  assert (sk : forall k, 0 <= s k <= 1) by (intros k; destruct (Hs k) as [[-> _]|[-> _]]; lra).
  set (e := fun k t => z k t ^ 2 + v k t ^ 2). set (E := fun t => Sum m (fun k => s k * e k t)).
  assert (ep : forall k t, 0 <= e k t) by (intros k t; unfold e; pose proof (pow2_ge_0 (z k t)); pose proof (pow2_ge_0 (v k t)); lra).
  assert (le_E : forall k t, (k < m)%nat -> s k * e k t <= E t).
  { intros k t Hk. apply (Sum_term_le m (fun k => s k * e k t)); [|exact Hk]. intros j _. apply Rmult_le_pos; [apply sk|apply ep]. }
  set (acc := fun k t => Sum m (fun j => rho k j * (f * (z k t - z j t) + g * (v k t - v j t)))).
  set (E' := fun t => Sum m (fun k => s k * (2 * z k t * v k t + 2 * v k t * acc k t))).
  set (h := Rabs f + Rabs g). set (C := 1 * INR m + Sum m (fun k => Sum m (fun j => 6 * h * Rabs (rho k j)))).
  assert (D : forall t, 0 <= t -> is_derive E t (E' t)).
  { intros t Ht. unfold E, E'. apply (D_Sum m (fun k x => s k * e k x) (fun k => s k * (2 * z k t * v k t + 2 * v k t * acc k t))). intros k Hk.
    destruct (Nat.eq_dec k 0) as [->|Nk].
    - rewrite s0. apply (is_derive_ext (fun _ => 0)); [intros x; Rring|]. eapply D_eq; [apply D_const|ring].
    - destruct (L k t ltac:(unfold m in Hk; lia) Ht) as [D1 D2]. apply D_scal. unfold e. apply D_plus; apply D_sqr; assumption. }
  assert (Young : forall x y z', Rabs (2 * x * (y - z')) <= 2 * (x ^ 2 + y ^ 2 + z' ^ 2)).
  { intros x y z'. apply Rabs_le. pose proof (pow2_ge_0 (x - (y - z'))). pose proof (pow2_ge_0 (x + (y - z'))). pose proof (pow2_ge_0 (y + z')). nra. }
  assert (B : forall t, 0 <= t -> E' t <= C * E t).
  { intros t Ht. assert (EP : 0 <= E t) by (apply Sum_ge0; intros k _; apply Rmult_le_pos; [apply sk|apply ep]).
    unfold C. rewrite Rmult_plus_distr_r, Rmult_1_l. unfold E'.
    apply Rle_trans with (Sum m (fun k => E t + Sum m (fun j => 6 * h * Rabs (rho k j)) * E t)).
    2: { rewrite Sum_plus, Sum_const, Sum_scal_r. lra. }
    apply Sum_le. intros k Hk. destruct (Hs k) as [[-> _]|[Ek NJ]].
    { rewrite Rmult_0_l. rewrite <- Sum_scal_r. assert (0 <= Sum m (fun j => 6 * h * Rabs (rho k j) * E t)); [|lra]. apply Sum_ge0. intros j _.
      pose proof (Rabs_pos f). pose proof (Rabs_pos g). pose proof (Rabs_pos (rho k j)). unfold h. repeat apply Rmult_le_pos; lra. }
    rewrite Ek, Rmult_1_l. apply Rplus_le_compat.
    - pose proof (le_E k t Hk) as Q. rewrite Ek in Q. unfold e in Q. pose proof (pow2_ge_0 (z k t - v k t)). nra.
    - unfold acc. rewrite <- Sum_scal, <- Sum_scal_r. apply Sum_le. intros j Hj. destruct (Req_dec (rho k j) 0) as [Z0|NZ].
      + rewrite Z0, Rabs_R0. lra.
      + assert (Ej : s j = 1). { destruct (Hs j) as [[_ J]|[Q _]]; [|exact Q]. exfalso. apply NJ. apply (joined_end n N 0 j k J), tracks_sym, Tr, NZ. }
        pose proof (le_E k t Hk) as Qk. pose proof (le_E j t Hj) as Qj. rewrite Ek in Qk. rewrite Ej in Qj. unfold e in Qk, Qj.
        assert (Y1 := Young (v k t) (z k t) (z j t)). assert (Y2 := Young (v k t) (v k t) (v j t)).
        assert (Y : Rabs (f * (2 * v k t * (z k t - z j t)) + g * (2 * v k t * (v k t - v j t))) <= h * (6 * E t)).
        { eapply Rle_trans; [apply Rabs_triang|]. rewrite !Rabs_mult. unfold h. rewrite Rmult_plus_distr_r. pose proof (pow2_ge_0 (z k t)). pose proof (pow2_ge_0 (v k t)). pose proof (pow2_ge_0 (z j t)). pose proof (pow2_ge_0 (v j t)).
          rewrite !Rabs_mult in Y1, Y2. apply Rplus_le_compat; apply Rmult_le_compat_l; try apply Rabs_pos; lra. }
        replace (2 * v k t * (rho k j * (f * (z k t - z j t) + g * (v k t - v j t)))) with (rho k j * (f * (2 * v k t * (z k t - z j t)) + g * (2 * v k t * (v k t - v j t)))) by ring.
        eapply Rle_trans; [apply Rle_abs|]. rewrite Rabs_mult. replace (6 * h * Rabs (rho k j) * E t) with (Rabs (rho k j) * (h * (6 * E t))) by ring.
        apply Rmult_le_compat_l; [apply Rabs_pos|exact Y]. }
  assert (Start : E 0 = 0).
  { apply Sum_zero. intros k Hk. destruct (Hs k) as [[-> _]|[_ NJ]]; [ring|]. destruct (Nat.eq_dec k 0) as [->|Nk]; [exfalso; apply NJ; constructor|].
    destruct (Z k ltac:(unfold m in Hk; lia) NJ) as [A A']. unfold e. rewrite A, A'. ring. }
  intros k t Hk NJ Ht. assert (Et : E t <= 0).
  { pose proof (gronwall E E' (- C) D) as G. replace 0 with (E 0 * exp (- - C * t)) by (rewrite Start; ring). apply G; [|exact Ht]. intros x Hx. rewrite Ropp_involutive. now apply B. }
  pose proof (le_E k t ltac:(unfold m; lia)) as Q. destruct (Hs k) as [[_ J]|[Ek _]]; [contradiction|]. rewrite Ek in Q. unfold e in Q.
  pose proof (pow2_ge_0 (z k t)). pose proof (pow2_ge_0 (v k t)). split; nra.
Qed.
