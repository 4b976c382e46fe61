(* Paley et al., the composite potential of an (M,N)-pattern circular formation: with the control (5), u^ori the negative gradient
   of (25) and u^spac (20), the potential K_0 S + w0^-2 U^{M,N} has the rate - w0^-2 sum (u_k - w0)^2; the printed K_0 S + U^{M,N}
   can grow.
     paley.VMN. *)
From Coq Require Import Reals Lra Lia Psatz.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums paley_model paley_phase paley_laplacian paley_gradient paley_particles paley_patterns.
Open Scope R_scope.

(* the partial derivatives of U^{M,N} *)
Definition gUMN (n M : nat) (K : nat -> R) (th : nat -> R) (k : nat) : R :=
  Sum M (fun i => K (Datatypes.S i) * (/ INR (Datatypes.S i) * g1 n (multiple (Datatypes.S i) th) k)).

Lemma UMN_along n M K (th : nat -> R -> R) om t : (1 <= n)%nat -> (forall k, (k < n)%nat -> is_derive (th k) t (om k)) ->
  is_derive (fun s => UMN n M K (fun k => th k s)) t (Sum n (fun k => om k * gUMN n M K (fun k => th k t) k)).
Proof.
  intros Hn H. eapply D_eq.
  - apply (D_Sum M (fun i s => K (Datatypes.S i) * Um n (Datatypes.S i) (fun k => th k s))
      (fun i => K (Datatypes.S i) * (/ INR (Datatypes.S i) ^ 2 * Sum n (fun k => INR (Datatypes.S i) * om k * g1 n (multiple (Datatypes.S i) (fun k => th k t)) k)))).
    intros i _. apply D_scal.
    apply (is_derive_ext (fun s => / INR (Datatypes.S i) ^ 2 * U1 n (fun k => INR (Datatypes.S i) * th k s))).
    + intros s. symmetry. apply Um_U1; lia.
    + apply D_scal. apply (U1_along n (fun k s => INR (Datatypes.S i) * th k s) (fun k => INR (Datatypes.S i) * om k) t Hn).
      intros k Hk. apply D_scal, H, Hk.
  - unfold gUMN.
    rewrite (Sum_ext n (fun k => om k * Sum M _) (fun k => Sum M (fun i => om k * (K (Datatypes.S i) * (/ INR (Datatypes.S i) * g1 n (multiple (Datatypes.S i) (fun k => th k t)) k))))).
    2:{ intros k _. symmetry. apply Sum_scal. }
    rewrite Sum_swap. apply Sum_ext. intros i _. rewrite <- !Sum_scal. apply Sum_ext. intros k _.
    pose proof (INR_pos (Datatypes.S i) ltac:(lia)). field. lra.
Qed.
Lemma gUMN_sum n M K th : Sum n (gUMN n M K th) = 0.
Proof.
  unfold gUMN. rewrite Sum_swap. apply Sum_zero. intros i _. rewrite !Sum_scal, gradient_orthogonal. ring.
Qed.
Theorem UMN_gradient n M K th k : (1 <= n)%nat -> (k < n)%nat -> partial (UMN n M K) th k (gUMN n M K th k).
Proof.
  intros Hn Hk. unfold partial. eapply D_eq.
  - apply (UMN_along n M K (fun j s => upd th k s j) (fun j => delta j k) (th k) Hn). intros j Hj. apply D_upd.
  - rewrite (Sum_ext n _ (fun j => delta j k * gUMN n M K th j)).
    + apply (Sum_delta n k (gUMN n M K th) Hk).
    + intros j Hj. f_equal. unfold gUMN. apply Sum_ext. intros i _. f_equal. f_equal. rewrite !g1_sines. f_equal.
      apply Sum_ext. intros l _. unfold multiple. now rewrite !upd_same.
Qed.

Section Composite.
Variables (n : nat) (adj : graph) (w0 K0 : R) (M : nat) (K : nat -> R).
Hypotheses (Hn : (1 <= n)%nat) (Hw : w0 <> 0) (S : undirected adj).
Variables (r : nat -> R -> C) (th : nat -> R -> R) (t : R).
Notation rt := (fun k => r k t).
Notation tht := (fun k => th k t).
(* (5): w0 + u^ori + u^spac with the negative gradient of (25) and (20) *)
Definition pattern_control (k : nat) : R := w0 - gUMN n M K tht k + w0 * (K0 / INR n * aS n adj w0 rt tht k).
Hypothesis R1 : forall k, (k < n)%nat -> is_velocity (r k) t (expi (th k t)).
Hypothesis R2 : forall k, (k < n)%nat -> is_derive (th k) t (pattern_control k).

(* the rate of K_0 S + a U^{M,N} for any weight a *)
Lemma weighted_rate a : is_derive (fun s => K0 * spacing n adj w0 (fun k => r k s) (fun k => th k s) + a * UMN n M K (fun k => th k s)) t
  (Sum n (fun k => (pattern_control k - w0) * (a * gUMN n M K tht k - / w0 * (K0 / INR n * aS n adj w0 rt tht k)))).
Proof.
  pose proof (INR_pos n Hn). eapply D_eq.
  - apply D_plus; apply D_scal; [apply (eq19 n adj w0 Hn S r th pattern_control t R1 R2)|apply (UMN_along n M K th pattern_control t Hn R2)].
  - pose proof (gUMN_sum n M K tht) as G. set (x := aS n adj w0 rt tht) in *. set (g := gUMN n M K tht) in *.
    transitivity (Sum n (fun k => K0 * (/ INR n * (x k * (1 - / w0 * pattern_control k))) + a * (pattern_control k * g k)) - a * w0 * Sum n g).
    + rewrite G, Sum_plus, !Sum_scal. ring.
    + rewrite <- Sum_scal, <- Sum_minus. apply Sum_ext. intros k _. field. split; lra.
Qed.
Theorem VMN_corrected :
  is_derive (fun s => K0 * spacing n adj w0 (fun k => r k s) (fun k => th k s) + / w0 ^ 2 * UMN n M K (fun k => th k s)) t
    (- / w0 ^ 2 * Sum n (fun k => (pattern_control k - w0) ^ 2)).
Proof.
  pose proof (INR_pos n Hn). eapply D_eq; [apply weighted_rate|]. rewrite <- Sum_scal. apply Sum_ext. intros k _.
  unfold pattern_control. field. split; lra.
Qed.
End Composite.

(* two particles, w0 = 2, K_0 = 1, M = 1, K_1 = -1, theta = (0, pi/2), r = (0, 3/2 + 3/2 i): the printed V grows at the rate 1/4 *)
Definition phase0 (k : nat) : R := if Nat.eqb k 0 then 0 else PI / 2.
Definition turn0 (k : nat) : R := if Nat.eqb k 0 then 3 / 2 else 5 / 2.
Definition place0 (k : nat) : C := if Nat.eqb k 0 then RtoC 0 else (3 / 2, 3 / 2).
Definition phases_along (k : nat) (s : R) : R := phase0 k + turn0 k * s.
Definition places_along (k : nat) (s : R) : C := (place0 k + RtoC s * expi (phase0 k))%C.
Lemma along_velocity k : is_velocity (places_along k) 0 (expi (phases_along k 0)).
Proof.
  unfold places_along, phases_along. rewrite Rmult_0_r, Rplus_0_r. split; cbn.
  - apply (is_derive_ext (fun s : R => fst (place0 k) + cos (phase0 k) * s)); [intros; cbn; ring|].
    eapply D_eq; [apply D_plus; [apply D_const|apply D_scal, D_id]|ring].
  - apply (is_derive_ext (fun s : R => snd (place0 k) + sin (phase0 k) * s)); [intros; cbn; ring|].
    eapply D_eq; [apply D_plus; [apply D_const|apply D_scal, D_id]|ring].
Qed.
Lemma along_turn k : is_derive (phases_along k) 0 (turn0 k).
Proof. unfold phases_along. eapply D_eq; [apply D_plus; [apply D_const|apply D_scal, D_id]|ring]. Qed.
Lemma along_values :
  gUMN 2 1 (fun _ => -1) (fun k => phases_along k 0) 0 = - / 2 /\ gUMN 2 1 (fun _ => -1) (fun k => phases_along k 0) 1 = / 2 /\
  aS 2 complete 2 (fun k => places_along k 0) (fun k => phases_along k 0) 0 = -1 /\
  aS 2 complete 2 (fun k => places_along k 0) (fun k => phases_along k 0) 1 = 1.
Proof.
  unfold gUMN. cbn [Sum]. rewrite !g1_sines. unfold aS. rewrite !inner_row.
  unfold lap, deg, w, complete, delta, centres, circle_centre, multiple, places_along, phases_along, place0, phase0, turn0. cbn.
  rewrite ?Rmult_0_r, ?Rplus_0_r, ?Rmult_1_l. replace (0 - PI / 2) with (- (PI / 2)) by ring. rewrite ?Rminus_0_r, ?Rminus_eq_0.
  rewrite ?sin_neg, ?cos_0, ?sin_0, ?cos_PI2, ?sin_PI2. repeat split; rewrite ?inner_xy; unfold inner; cbn;
  rewrite ?cos_0, ?sin_0, ?cos_PI2, ?sin_PI2; field.
Qed.
Theorem VMN_printed_fails : ~ forall n M adj w0 K0 K, (1 <= n)%nat -> (1 <= M)%nat -> undirected adj -> strongly_connected n adj -> w0 <> 0 -> 0 < K0 ->
  (forall m, (1 <= m < M)%nat -> 0 < K m) -> K M < 0 -> (exists q, n = (q * M)%nat) ->
  forall (r : nat -> R -> C) (th : nat -> R -> R) t d,
  (forall k, (k < n)%nat -> is_velocity (r k) t (expi (th k t))) ->
  (forall k, (k < n)%nat -> is_derive (th k) t (pattern_control n adj w0 K0 M K r th t k)) ->
  is_derive (fun s => K0 * spacing n adj w0 (fun k => r k s) (fun k => th k s) + UMN n M K (fun k => th k s)) t d -> d <= 0.
Proof.
  intros H. destruct along_values as [g0 [g1 [a0 a1]]].
  assert (U : forall k, (k < 2)%nat -> turn0 k = pattern_control 2 complete 2 1 1 (fun _ => -1) places_along phases_along 0 k).
  { intros k Hk. unfold pattern_control. destruct k as [|[|k]]; [| |lia].
    - rewrite g0, a0. unfold turn0. cbn. field.
    - rewrite g1, a1. unfold turn0. cbn. field. }
  assert (R2 : forall k, (k < 2)%nat -> is_derive (phases_along k) 0 (pattern_control 2 complete 2 1 1 (fun _ => -1) places_along phases_along 0 k)).
  { intros k Hk. rewrite <- (U k Hk). apply along_turn. }
  assert (SC : strongly_connected 2 complete).
  { intros j k Hj Hk. destruct (Nat.eq_dec j k) as [->|N]; [apply Relation_Operators.rt_refl|]. apply Relation_Operators.rt_step.
    repeat split; try assumption. unfold complete. destruct (Nat.eqb_spec k j); [congruence|reflexivity]. }
  assert (D := weighted_rate 2 complete 2 1 1 (fun _ => -1) ltac:(lia) ltac:(lra) complete_undirected places_along phases_along 0
    (fun k _ => along_velocity k) R2 1).
  assert (X := H 2%nat 1%nat complete 2 1 (fun _ => -1) ltac:(lia) ltac:(lia) complete_undirected SC ltac:(lra) ltac:(lra)
    ltac:(intros; lia) ltac:(lra) (ex_intro _ 2%nat eq_refl) places_along phases_along 0 _ (fun k _ => along_velocity k) R2
    (is_derive_ext _ _ 0 _ (fun s => f_equal (Rplus _) (Rmult_1_l _)) D)).
  cbn [Sum] in X. rewrite <- !U, g0, g1, a0, a1 in X by lia. unfold turn0 in X. cbn in X. lra.
Qed.
