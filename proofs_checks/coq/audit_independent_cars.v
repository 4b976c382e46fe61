(* Theorems about Veerman's paper that the proofs of the independent statements go around: what each says of a clause, in words of its own.
   Stated after the theorems had been seen: veerman.lem1 (in time), veerman.sep_remark, veerman.table1_theory, veerman.lem2_eigvec clauses 3, 4,
   veerman.specM (corrected). *)
From Coq Require Import Reals Lra Lia List.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums.
From Flockproof Require veerman_complex veerman_settling veerman_unsettled veerman_front veerman_numbers veerman_chain veerman_lemma1 veerman_stability.
From Flockproof Require audit_independent_veerman.
Module V := audit_independent_veerman.
Open Scope R_scope.

(* car k of N + 1 followers: what it would change of its gap to the mean of those it sees *)
Definition seen (both : bool) (N : nat) (z : nat -> R) (k : nat) : R :=
  if both then if Nat.eqb k (S N) then z (k - 1)%nat else (z (k - 1)%nat + z (k + 1)%nat) / 2 else z (k - 1)%nat.
Definition drives (both : bool) f g N (h : nat -> R) (x u : nat -> R -> R) := forall k t, (1 <= k <= S N)%nat -> 0 <= t ->
  is_derive (x k) t (u k t) /\
  is_derive (u k) t (f * ((x k t - h k) - seen both N (fun j => x j t - h j) k) + g * (u k t - seen both N (fun j => u j t) k)).
Definition vanishes (z : R -> R) := forall e, 0 < e -> exists T, forall t, T < t -> Rabs (z t) < e.
Definition settles both f g N := forall h x u, drives both f g N h x u ->
  (exists c, forall t, 0 <= t -> x 0%nat t = x 0%nat 0 + c * t /\ u 0%nat t = c) -> forall k, (1 <= k <= S N)%nat ->
  vanishes (fun t => (x k t - x 0%nat t) - (h k - h 0%nat)) /\ vanishes (fun t => u k t - u 0%nat t).
Definition lemma_1 : Prop := forall f g N both, settles both f g N <-> f < 0 /\ g < 0.
(* cars of the front whose deviations are a_0 Re (z^k e^(iwt)) *)
Fixpoint power (z : C) (k : nat) : C := match k with O => RtoC 1 | S k => (z * power z k)%C end.
Definition separation : Prop := forall a0 (h : nat -> R) (gam : C) w k t, h (S k) - h k = 1 ->
  let car j := h j + a0 * fst (power (/ gam) j * (cos (w * t), sin (w * t)))%C in
  car (S k) - car k = a0 * fst (power (/ gam) (S k) * (cos (w * t), sin (w * t)))%C - a0 * fst (power (/ gam) k * (cos (w * t), sin (w * t)))%C + 1 /\
  (0 < a0 -> car (S k) - car k <>
     a0 * fst (power (/ gam) (S k) * (cos (w * t), sin (w * t)))%C - a0 * fst (power (/ gam) k * (cos (w * t), sin (w * t)) + 1)%C).
Definition columns : Prop := forall N nf na,
  In (N, nf, na) ((4, 0.2776801836, 4.58527335) :: (8, 0.1388400918, 9.17054669) :: (16, 0.0694200459, 18.34109338) ::
    (32, 0.0347100229, 36.68218677) :: (64, 0.0173550115, 73.36437354) :: (128, 0.0086775057, 146.72874707) :: nil) ->
  Rabs (nf - sqrt (Rabs (-1)) * PI / (N * 2 * sqrt 2)) <= 1e-10 /\ Rabs (na - 8 * sqrt (2 * Rabs (-1)) / (PI ^ 2 * Rabs (-1)) * N) <= 1e-8.
Definition eigenvectors : Prop := forall G : C, exists s : C, (s * s)%C = (G * G - 1)%C /\ 0 <= fst s /\
  forall sign : C, sign = RtoC 1 \/ sign = RtoC (-1) -> let mu := (G + sign * s)%C in
    (RtoC 0 * 1 + RtoC 1 * mu)%C = (mu * 1)%C /\ (- RtoC 1 * 1 + 2 * G * mu)%C = (mu * mu)%C /\ (1 - G * mu)%C = (- sign * s * mu)%C.
Definition spectrum : Prop := forall N p f g nu, p = V.p1 \/ p = V.p2 N ->
  (V.eig_M N p f g nu <-> exists lam, V.eig_L N p lam /\ lam <> 0%C /\ V.eig_AK f g lam nu).

Lemma vanishes_is z : vanishes z <-> is_lim z p_infty 0.
Proof.
  rewrite <- is_lim_spec. split.
  - intros H e. destruct (H e (cond_pos e)) as [T Q]. exists T. intros t Ht. rewrite Rminus_0_r. now apply Q.
  - intros H e He. destruct (H (mkposreal e He)) as [T Q]. exists T. intros t Ht. specialize (Q t Ht). cbn in Q. now rewrite Rminus_0_r in Q.
Qed.
Lemma drives_1 f g N h x u : drives false f g N h x u <-> veerman_settling.system_1 f g N h x u.
Proof. reflexivity. Qed.
Lemma drives_2 f g N h x u : drives true f g N h x u <-> veerman_settling.system_2 f g N h x u.
Proof.
  unfold drives, veerman_settling.system_2, seen. split; intros H k t Hk Ht; destruct (H k t Hk Ht) as [A B]; (split; [exact A|]);
  (eapply D_eq; [exact B|]); destruct (Nat.eqb k (S N)); field.
Qed.
Lemma settles_is both f g N : settles both f g N <-> if both then veerman_unsettled.stable_2 f g N else veerman_unsettled.stable_1 f g N.
Proof.
  assert (E : forall (h : nat -> R) (x : nat -> R -> R) k, vanishes (fun t => (x k t - x 0%nat t) - (h k - h 0%nat)) <-> is_lim (veerman_settling.deviation h x k) p_infty 0).
  { intros h x k. rewrite vanishes_is. split; apply is_lim_ext; intros t; unfold veerman_settling.deviation; ring. }
  assert (F : forall u k, vanishes (fun t => u k t - u 0%nat t) <-> is_lim (veerman_settling.excess u k) p_infty 0) by (intros; apply vanishes_is).
  destruct both; split; intros H h x u D L k Hk.
  - apply drives_2 in D. destruct (H h x u D L k Hk) as [A B]. split; [now apply E|now apply F].
  - apply drives_2 in D. destruct (H h x u D L k Hk) as [A B]. split; [now apply E|now apply F].
  - apply drives_1 in D. destruct (H h x u D L k Hk) as [A B]. split; [now apply E|now apply F].
  - apply drives_1 in D. destruct (H h x u D L k Hk) as [A B]. split; [now apply E|now apply F].
Qed.
Lemma lemma_1_holds : lemma_1.
Proof. intros f g N both. rewrite settles_is. destruct (veerman_unsettled.lemma_1_in_time f g) as [A B]. destruct both; [apply B|apply A]. Qed.
Lemma power_is z k : power z k = veerman_complex.Cpw z k.
Proof. induction k as [|k IH]; [reflexivity|]. cbn. now rewrite IH. Qed.
Lemma separation_holds : separation.
Proof.
  intros a0 h gam w k t Hh car. assert (Q : forall j, car j = veerman_front.position a0 h gam w j t).
  { intros j. unfold car, veerman_front.position. rewrite power_is. unfold veerman_complex.cis. set (z := (_ * _)%C). cbn. ring. }
  rewrite (Q (S k)), (Q k), (power_is (/ gam)%C (S k)), (power_is (/ gam)%C k). split.
  - exact (veerman_front.separation a0 h gam w k t Hh).
  - intros P. exact (veerman_front.separation_printed_fails a0 h gam w k t P Hh).
Qed.
Lemma columns_hold : columns.
Proof.
  intros N nf na I. pose proof veerman_numbers.table_theory as T. unfold veerman_numbers.table in T.
  pose proof (Forall_inv T) as T1. apply Forall_inv_tail in T. pose proof (Forall_inv T) as T2. apply Forall_inv_tail in T. pose proof (Forall_inv T) as T3.
  apply Forall_inv_tail in T. pose proof (Forall_inv T) as T4. apply Forall_inv_tail in T. pose proof (Forall_inv T) as T5. apply Forall_inv_tail in T.
  pose proof (Forall_inv T) as T6. clear T.
  destruct I as [I|[I|[I|[I|[I|[I|[]]]]]]]; injection I as <- <- <-; [exact T1|exact T2|exact T3|exact T4|exact T5|exact T6].
Qed.
Lemma eigenvectors_hold : eigenvectors.
Proof.
  intros G. destruct (veerman_chain.lemma_2_eigenvectors G) as (A & B & C0 & D). exists (veerman_complex.Csqrt (G * G - 1)%C). set (s := veerman_complex.Csqrt _) in *.
  split; [apply veerman_complex.Csqrt_sqr|]. split; [apply sqrt_pos|].
  assert (A2 := f_equal snd A). assert (B2 := f_equal snd B). clear A B. unfold veerman_chain.Cmap, veerman_chain.mu_plus, veerman_chain.mu_minus in A2, B2, C0, D. fold s in A2, B2, C0, D. cbn [fst snd] in A2, B2.
  intros sign Hs mu. destruct Hs as [Hs|Hs].
  - assert (E : mu = (G + s)%C) by (unfold mu; rewrite Hs; ring). rewrite E, Hs. split; [ring|]. split; [rewrite <- A2; ring|rewrite C0; ring].
  - assert (E : mu = (G - s)%C) by (unfold mu; rewrite Hs; apply injective_projections; cbn; ring). rewrite E, Hs. split; [ring|]. split; [rewrite <- B2; ring|].
    rewrite D. apply injective_projections; cbn; ring.
Qed.
Lemma spectrum_holds : spectrum.
Proof.
  intros N p f g nu Hp. rewrite (V.eig_M_is N p f g nu Hp). destruct (veerman_lemma1.spectrum_M_systems N f g nu) as [A B].
  assert (E : forall row lam, p = row -> (V.eig_L N p lam <-> veerman_stability.L_eigenvalue N row lam)).
  { intros row lam ->. split; intros (x & K & Z & H); exists x; (split; [exact K|]); (split; [now symmetry|exact H]). }
  destruct Hp as [Hp|Hp]; [rewrite Hp at 1|rewrite Hp at 1]; [change (veerman_stability.reduced V.p1) with veerman_stability.P1; rewrite A|
    change (veerman_stability.reduced (V.p2 N)) with (veerman_stability.P2 N); rewrite B];
  split; intros (lam & L1 & L2 & L3); exists lam; (split; [now apply (E _ lam Hp)|split; assumption]).
Qed.
