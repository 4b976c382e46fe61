(* Clauses of the claims about Tanner's first paper, formalised from their words before the theorems were looked at; the theorems
   prove them. *)
From Coq Require Import Reals Lra Lia List Relations Psatz.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums paley_model paley_phase paley_laplacian paley_gradient paley_particles tanner_energy tanner_flock
  tanner1_heading tanner1_motion.
From Flockproof Require tanner1_pair tanner_trees.
Open Scope R_scope.

(* agents (1) with (4), (5) at time t; a i j is what the law takes for theta_i - theta_j; V' i j the derivative of V i j *)
Definition law (n : nat) (adj : graph) (V' : nat -> nat -> R -> R) (a : nat -> nat -> R) (r v : nat -> C) (i : nat) : C :=
  (- Csum n (fun j => if adj i j then RtoC (V' i j (Cmod (r i - r j)) / Cmod (r i - r j)) * (r i - r j) else 0)
   - RtoC (Sum n (fun j => if adj i j then a i j / Cmod (r i - r j)%C ^ 2 else 0)%R) * (Ci * v i))%C.
Definition loop n adj (V V' : nat -> nat -> R -> R) (r v : nat -> R -> C) (a : nat -> nat -> R -> R) t :=
  forall i, (i < n)%nat -> is_velocity (r i) t (v i t) /\
    is_velocity (v i) t (law n adj V' (fun i j => a i j t) (fun i => r i t) (fun i => v i t) i) /\
    forall j, (j < n)%nat -> adj i j = true -> r i t <> r j t /\
      is_derive (V i j) (Cmod (r i t - r j t)%C) (V' i j (Cmod (r i t - r j t)%C)).
(* a pair has one potential and one derivative *)
Definition symmetric_V (V V' : nat -> nat -> R -> R) := (forall i j, V i j = V j i) /\ forall i j, V' i j = V' j i.
Definition kinetic_plus_V n (adj : graph) (V : nat -> nat -> R -> R) (r v : nat -> C) : R :=
  / 2 * Sum n (fun i => Sum n (fun j => if adj i j then V i j (Cmod (r i - r j)%C) else 0) + Cmod (v i) ^ 2).

(* beyond.tanner1.two_agents, clauses 1, 2, 3; headings ph of the velocities, which exist for moving agents *)
Definition pair_of (a : nat -> nat -> R -> R) (d : R -> R) := forall t, a 0%nat 1%nat t = d t /\ a 1%nat 0%nat t = - d t.
Definition two_agents_1 : Prop := forall adj V V' r v a d (ph : nat -> R), undirected adj -> adj 0%nat 1%nat = true ->
  symmetric_V V V' -> pair_of a d -> forall t, loop 2 adj V V' r v a t -> (forall i, v i t = (RtoC (Cmod (v i t)) * expi (ph i))%C) ->
  is_derive (fun s => / 2 * Cmod (v 0%nat s + v 1%nat s)%C ^ 2) t
    (2 * Cmod (v 0%nat t) * Cmod (v 1%nat t) * d t * sin (ph 0%nat - ph 1%nat) / Cmod (r 0%nat t - r 1%nat t)%C ^ 2).
Definition two_agents_2 : Prop := forall adj V V' r v a d (ph : nat -> R -> R), undirected adj -> adj 0%nat 1%nat = true ->
  symmetric_V V V' -> pair_of a d -> (forall t, 0 <= t -> loop 2 adj V V' r v a t) ->
  (forall t i, 0 <= t -> v i t = (RtoC (Cmod (v i t)) * expi (ph i t))%C) ->
  (forall t, 0 <= t -> - PI < d t <= PI /\ exists k : Z, d t = ph 0%nat t - ph 1%nat t + 2 * PI * IZR k) ->
  forall s t, 0 <= s <= t -> Cmod (v 0%nat s + v 1%nat s)%C <= Cmod (v 0%nat t + v 1%nat t)%C.
Definition two_agents_3 : Prop := forall adj V V' r v a d, undirected adj -> adj 0%nat 1%nat = true -> symmetric_V V V' -> pair_of a d ->
  (forall t, 0 <= t -> loop 2 adj V V' r v a t) -> forall t, 0 <= t ->
  kinetic_plus_V 2 adj V (fun i => r i t) (fun i => v i t) = kinetic_plus_V 2 adj V (fun i => r i 0) (fun i => v i 0).
(* tanner1.Vt_inv clauses 3, 4 and tanner1.propIV3b clause 2; whatever headings the law takes *)
Definition Vt_inv_3 : Prop := forall n adj V V' r v th, undirected adj -> symmetric_V V V' -> (forall t, 0 <= t -> loop n adj V V' r v (fun i j s => th i s - th j s) t) ->
  forall t, 0 <= t -> kinetic_plus_V n adj V (fun i => r i t) (fun i => v i t) = kinetic_plus_V n adj V (fun i => r i 0) (fun i => v i 0).
(* tanner1.anyV clauses 3, 4: the motion lasts at least until T; positions have a velocity at T; they do not meet at T either *)
Definition start_apart n (adj : graph) (r : nat -> R -> C) := forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> r i 0 <> r j 0.
Definition repels (V V' : R -> R) := (forall s, 0 < s -> is_derive V s (V' s) /\ 0 <= V s) /\
  forall c, exists d, 0 < d /\ forall s, 0 < s < d -> c < V s.
Definition binds (V : R -> R) := forall c, exists D, forall s, D < s -> c < V s.
Definition lasts n adj V V' (r v : nat -> R -> C) (th : nat -> R -> R) T :=
  forall t, 0 <= t < T -> loop n adj V V' r v (fun i j s => th i s - th j s) t.
Definition arrives n (r : nat -> R -> C) T := forall i, (i < n)%nat -> exists u, is_velocity (r i) T u.
Definition anyV_3 : Prop := forall n adj V V' r v th T, undirected adj -> symmetric_V V V' ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> repels (V i j) (V' i j)) -> start_apart n adj r ->
  0 <= T -> lasts n adj V V' r v th T -> arrives n r T ->
  forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> r i T <> r j T.
Definition anyV_4 : Prop := forall n adj V V' r v th, undirected adj -> symmetric_V V V' -> strongly_connected n adj ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> repels (V i j) (V' i j) /\ binds (V i j)) ->
  exists B, forall T, lasts n adj V V' r v th T ->
    forall t i j, 0 <= t < T -> (i < n)%nat -> (j < n)%nat -> Cmod (r i t - r j t)%C <= B.

(* ---- the theorems prove them ---- *)
Lemma law_is n adj V' (th : nat -> R) r v i : law n adj V' (fun i j => th i - th j) r v i = accel n adj V' r v th i.
Proof.
  unfold law, accel, gyro, grad_i.
  rewrite (Csum_ext n (fun j => if adj i j then (RtoC (V' i j (Cmod (r i - r j)) / Cmod (r i - r j)) * (r i - r j))%C else RtoC 0) (pair_grad adj V' r i)).
  - replace (Sum n (fun j => if adj i j then (th i - th j) / Cmod (r i - r j)%C ^ 2 else 0)) with (align n adj r th i).
    + apply injective_projections; cbn; ring.
    + unfold align. apply Sum_ext. intros j _. unfold w, norm. destruct (adj i j); ring.
  - intros j _. unfold pair_grad, w, grad, norm. destruct (adj i j); apply injective_projections; cbn; ring.
Qed.
Lemma energy_is n adj V r v : kinetic_plus_V n adj V r v = mechanical n adj V r v.
Proof.
  unfold kinetic_plus_V, mechanical. f_equal. apply Sum_ext. intros i _. f_equal.
  - unfold V_i. apply Sum_ext. intros j _. unfold w, norm. destruct (adj i j); ring.
  - rewrite <- norm_sqr. unfold norm. ring.
Qed.
Lemma steered_is n adj V V' r v th t : loop n adj V V' r v (fun i j s => th i s - th j s) t -> steered n adj V V' r v th t.
Proof.
  intros L. split; [intros i Hi; now apply (L i Hi)|]. split; [|split].
  - intros i j Hi Hj A. now apply (L i Hi).
  - intros i j Hi Hj A. now apply (L i Hi).
  - intros i Hi. rewrite <- law_is. now apply (L i Hi).
Qed.
Lemma Vt_inv_3_proved : Vt_inv_3.
Proof.
  intros n adj V V' r v th S [_ VS] L t Ht. rewrite !energy_is.
  refine (mechanical_constant n adj V V' r v th S VS (t + 1) _ t _); [|lra]. intros s Hs. apply steered_is, L. lra.
Qed.
(* two agents: the law takes th 0 - th 1 with th = (d, 0) *)
Definition as_headings (d : R -> R) (i : nat) : R -> R := match i with O => d | _ => fun _ => 0 end.
Lemma loop_pair adj V V' r v a d t : pair_of a d -> loop 2 adj V V' r v a t ->
  loop 2 adj V V' r v (fun i j s => as_headings d i s - as_headings d j s) t.
Proof.
  intros P L i Hi. destruct (L i Hi) as (A & B & C). split; [exact A|]. split; [|exact C].
  assert (N : forall k, (k < 2)%nat -> adj k k = false).
  { intros k Hk. destruct (adj k k) eqn:E; [|reflexivity]. destruct (L k Hk) as (_ & _ & Q). now destruct (Q k Hk E) as [Q' _]. }
  destruct (P t) as [P1 P2]. replace (law 2 adj V' (fun i j => as_headings d i t - as_headings d j t) (fun i => r i t) (fun i => v i t) i)
    with (law 2 adj V' (fun i j => a i j t) (fun i => r i t) (fun i => v i t) i); [exact B|].
  unfold law. f_equal. f_equal. f_equal. cbn [Sum]. pose proof (N 0%nat ltac:(lia)) as N0. pose proof (N 1%nat ltac:(lia)) as N1.
  destruct i as [|[|i]]; [| |lia]; rewrite ?N0, ?N1, ?P1, ?P2; cbn [as_headings]; rewrite ?Rminus_0_r, ?Rminus_0_l; reflexivity.
Qed.
Lemma two_agents_3_proved : two_agents_3.
Proof.
  intros adj V V' r v a d S A VS P L t Ht. apply (Vt_inv_3_proved 2%nat adj V V' r v (as_headings d) S VS); [|exact Ht].
  intros s Hs. apply (loop_pair adj V V' r v a d s P). now apply L.
Qed.
Lemma two_agents_2_proved : two_agents_2.
Proof.
  intros adj V V' r v a d ph S A [_ VS] P L E W s t Hst.
  apply (tanner1_pair.two_agents_gather adj V V' r v (as_headings d) ph (fun i x => Cmod (v i x)) S VS A nil s t); [lra| | |].
  - intros x i Hx Hi. destruct (L x ltac:(lra) i Hi) as (_ & [D1 D2] & _).
    split; apply derivable_continuous_pt, ex_derive_Reals_0; eexists; eassumption.
  - intros x i Hx Hi. split; [apply Cmod_ge_0|]. apply E. lra.
  - intros x Hx _. split; [apply steered_is, (loop_pair adj V V' r v a d x P), L; lra|]. right.
    destruct (W x ltac:(lra)) as [W1 [k Wk]]. cbn [as_headings]. rewrite Rminus_0_r. split; [lra|]. exists k. rewrite Wk. ring.
Qed.
Lemma two_agents_1_proved : two_agents_1.
Proof.
  intros adj V V' r v a d ph S A [_ VS] P t L E.
  pose proof (tanner1_pair.total_rate adj V V' r v (as_headings d) S VS A t (steered_is _ _ _ _ _ _ _ _ (loop_pair _ _ _ _ _ _ _ _ P L))) as Q.
  apply (is_derive_ext (fun x => / 2 * inner (v 0%nat x + v 1%nat x)%C (v 0%nat x + v 1%nat x)%C)).
  - intros x. rewrite <- norm_sqr. unfold norm. cbn. ring.
  - replace (2 * Cmod (v 0%nat t) * Cmod (v 1%nat t) * d t * sin (ph 0%nat - ph 1%nat))
      with (2 * (as_headings d 0 t - as_headings d 1 t) * cross (v 1%nat t) (v 0%nat t)); [exact Q|].
    cbn [as_headings]. rewrite Rminus_0_r. rewrite (E 0%nat), (E 1%nat) at 1. rewrite sin_minus. unfold cross, expi. cbn. ring.
Qed.
(* where agents are not linked the potential is never asked for *)
Definition filled (adj : graph) (V : nat -> nat -> R -> R) (i j : nat) (s : R) := if adj i j then V i j s else s + / s.
Lemma filled_steered n adj V V' r v th t : steered n adj V V' r v th t -> steered n adj (filled adj V) V' r v th t.
Proof.
  intros (A & B & C & D). split; [exact A|]. split; [exact B|]. split; [|exact D].
  intros i j Hi Hj L. apply (is_derive_ext (V i j)); [intros s; unfold filled; now rewrite L|]. now apply C.
Qed.
Lemma filled_repels n adj (V V' : nat -> nat -> R -> R) : (forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> repels (V i j) (V' i j)) ->
  (forall i j s, (i < n)%nat -> (j < n)%nat -> 0 < s -> 0 <= filled adj V i j s) /\
  (forall i j M, (i < n)%nat -> (j < n)%nat -> exists d, 0 < d /\ forall s, 0 < s < d -> M < filled adj V i j s).
Proof.
  intros H. split.
  - intros i j s Hi Hj Hs. unfold filled. destruct (adj i j) eqn:L; [now apply (H i j Hi Hj L)|].
    pose proof (Rinv_0_lt_compat s Hs). lra.
  - intros i j M Hi Hj. unfold filled. destruct (adj i j) eqn:L; [now apply (H i j Hi Hj L)|].
    exists (/ (Rabs M + 1)). pose proof (Rabs_pos M). split; [apply Rinv_0_lt_compat; lra|]. intros s [S1 S2].
    assert (Rabs M + 1 < / s). { rewrite <- (Rinv_inv (Rabs M + 1)). apply Rinv_lt_contravar; [|exact S2]. apply Rmult_lt_0_compat; [exact S1|]. apply Rinv_0_lt_compat. lra. }
    pose proof (Rle_abs M). lra.
Qed.
Lemma anyV_3_proved : anyV_3.
Proof.
  intros n adj V V' r v th T S [_ VS] Rp St HT L Ar i j Hi Hj A E.
  destruct (filled_repels n adj V V' Rp) as [F1 F2].
  destruct (linked_apart n adj (filled adj V) V' r v th S VS F1 F2 i j Hi Hj A) as [d [Hd Q]].
  specialize (Q T (fun t Ht => filled_steered _ _ _ _ _ _ _ _ (steered_is _ _ _ _ _ _ _ _ (L t Ht)))).
  destruct (Req_dec T 0) as [->|N]; [now apply (St i j Hi Hj A)|].
  destruct (Ar i Hi) as [ui Ui]. destruct (Ar j Hj) as [uj Uj].
  destruct (velocity_minus (r i) (r j) T _ _ Ui Uj) as [D1 D2].
  apply is_derive_Reals in D1. apply is_derive_Reals in D2.
  assert (C1 : continuity_pt (fun s => fst (r i s - r j s)%C) T) by (apply derivable_continuous_pt; eexists; exact D1).
  assert (C2 : continuity_pt (fun s => snd (r i s - r j s)%C) T) by (apply derivable_continuous_pt; eexists; exact D2).
  destruct (C1 (d / 2) ltac:(lra)) as [e1 [E1 P1]]. destruct (C2 (d / 2) ltac:(lra)) as [e2 [E2 P2]].
  set (t := Rmax 0 (T - Rmin e1 e2 / 2)).
  assert (M : 0 < Rmin e1 e2) by (apply Rmin_glb_lt; lra). pose proof (Rmin_l e1 e2). pose proof (Rmin_r e1 e2).
  assert (Y : 0 <= t < T /\ T - Rmin e1 e2 / 2 <= t).
  { unfold t. pose proof (Rmax_l 0 (T - Rmin e1 e2 / 2)). pose proof (Rmax_r 0 (T - Rmin e1 e2 / 2)). split; [split; [lra|apply Rmax_lub_lt; lra]|lra]. }
  assert (B : Rabs (t - T) < Rmin e1 e2) by (rewrite Rabs_left by lra; lra).
  assert (Z : (r i T - r j T)%C = RtoC 0) by (rewrite E; ring).
  specialize (P1 t). specialize (P2 t). specialize (Q t (proj1 Y)).
  assert (X : D_x no_cond T t) by (split; [exact I|intros K; lra]).
  assert (B1 : dist R_met t T < e1) by (apply Rlt_le_trans with (2 := H); exact B).
  assert (B2 : dist R_met t T < e2) by (apply Rlt_le_trans with (2 := H0); exact B).
  specialize (P1 (conj X B1)). specialize (P2 (conj X B2)).
  change (Rabs (fst (r i t - r j t)%C - fst (r i T - r j T)%C) < d / 2) in P1. change (Rabs (snd (r i t - r j t)%C - snd (r i T - r j T)%C) < d / 2) in P2. rewrite Z in P1, P2.
  change (fst (RtoC 0)) with 0 in P1. change (snd (RtoC 0)) with 0 in P2. rewrite Rminus_0_r in P1, P2. pose proof (tanner_trees.norm_le_sum (r i t - r j t)%C). lra.
Qed.
Lemma anyV_4_proved : anyV_4.
Proof.
  intros n adj V V' r v th S [_ VS] SC Rp.
  destruct (filled_repels n adj V V' (fun i j Hi Hj A => proj1 (Rp i j Hi Hj A))) as [F1 _].
  destruct (cohesion n adj (filled adj V) V' r v th S VS SC F1) as [B Q].
  - intros i j M Hi Hj. unfold filled. destruct (adj i j) eqn:L; [now apply (Rp i j Hi Hj L)|].
    exists (Rabs M). intros s Hs. pose proof (Rabs_pos M). pose proof (Rle_abs M). pose proof (Rinv_0_lt_compat s ltac:(lra)). lra.
  - exists B. intros T L. apply (Q T). intros t Ht. apply filled_steered, steered_is, (L t Ht).
Qed.
