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
Definition symmetric_V (V : nat -> nat -> R -> R) := forall i j s, V i j s = V j i s.
Definition kinetic_plus_V n (adj : graph) (V : nat -> nat -> R -> R) (r v : nat -> C) : R :=
  / 2 * Sum n (fun i => Sum n (fun j => if adj i j then V i j (Cmod (r i - r j)%C) else 0) + Cmod (v i) ^ 2).

(* beyond.tanner1.two_agents, clauses 1, 2, 3; headings ph of the velocities, which exist for moving agents *)
Definition pair_of (a : nat -> nat -> R -> R) (d : R -> R) := forall t, a 0%nat 1%nat t = d t /\ a 1%nat 0%nat t = - d t.
Definition two_agents_1 : Prop := forall adj V V' r v a d (ph : nat -> R), undirected adj -> adj 0%nat 1%nat = true ->
  symmetric_V V -> pair_of a d -> forall t, loop 2 adj V V' r v a t -> (forall i, v i t = (RtoC (Cmod (v i t)) * expi (ph i))%C) ->
  is_derive (fun s => / 2 * Cmod (v 0%nat s + v 1%nat s)%C ^ 2) t
    (2 * Cmod (v 0%nat t) * Cmod (v 1%nat t) * d t * sin (ph 0%nat - ph 1%nat) / Cmod (r 0%nat t - r 1%nat t)%C ^ 2).
Definition two_agents_2 : Prop := forall adj V V' r v a d (ph : nat -> R -> R), undirected adj -> adj 0%nat 1%nat = true ->
  symmetric_V V -> pair_of a d -> (forall t, 0 <= t -> loop 2 adj V V' r v a t) ->
  (forall t i, 0 <= t -> v i t = (RtoC (Cmod (v i t)) * expi (ph i t))%C) ->
  (forall t, 0 <= t -> - PI < d t <= PI /\ exists k : Z, d t = ph 0%nat t - ph 1%nat t + 2 * PI * IZR k) ->
  forall s t, 0 <= s <= t -> Cmod (v 0%nat s + v 1%nat s)%C <= Cmod (v 0%nat t + v 1%nat t)%C.
Definition two_agents_3 : Prop := forall adj V V' r v a d, undirected adj -> adj 0%nat 1%nat = true -> symmetric_V V -> pair_of a d ->
  (forall t, 0 <= t -> loop 2 adj V V' r v a t) -> forall t, 0 <= t ->
  kinetic_plus_V 2 adj V (fun i => r i t) (fun i => v i t) = kinetic_plus_V 2 adj V (fun i => r i 0) (fun i => v i 0).
(* tanner1.Vt_inv clauses 3, 4 and tanner1.propIV3b clause 2; whatever the law takes for the differences of headings *)
Definition Vt_inv_3 : Prop := forall n adj V V' r v a, undirected adj -> symmetric_V V -> (forall t, 0 <= t -> loop n adj V V' r v a t) ->
  forall t, 0 <= t -> kinetic_plus_V n adj V (fun i => r i t) (fun i => v i t) = kinetic_plus_V n adj V (fun i => r i 0) (fun i => v i 0).
(* tanner1.anyV clauses 3, 4: as long as the motion lasts, until T; that no linked agents meet is the conclusion *)
Definition loop_apart n adj (V' : nat -> nat -> R -> R) (r v : nat -> R -> C) a t :=
  forall i, (i < n)%nat -> is_velocity (r i) t (v i t) /\
    ((forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> r i t <> r j t) ->
     is_velocity (v i) t (law n adj V' (fun i j => a i j t) (fun i => r i t) (fun i => v i t) i)).
Definition start_apart n (adj : graph) (r : nat -> R -> C) := forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> r i 0 <> r j 0.
Definition repels (V V' : R -> R) := (forall s, 0 < s -> is_derive V s (V' s) /\ 0 <= V s) /\
  forall c, exists d, 0 < d /\ forall s, 0 < s < d -> c < V s.
Definition binds (V : R -> R) := forall c, exists D, forall s, D < s -> c < V s.
Definition anyV_3 : Prop := forall n adj V V' r v a T, undirected adj -> no_loops adj -> symmetric_V V ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> repels (V i j) (V' i j)) -> start_apart n adj r ->
  (forall t, 0 <= t <= T -> loop_apart n adj V' r v a t) ->
  forall t i j, 0 <= t <= T -> (i < n)%nat -> (j < n)%nat -> adj i j = true -> r i t <> r j t.
Definition anyV_4 : Prop := forall n adj V V' r v a, undirected adj -> no_loops adj -> symmetric_V V -> strongly_connected n adj ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> repels (V i j) (V' i j) /\ binds (V i j)) -> start_apart n adj r ->
  exists B, forall T, (forall t, 0 <= t <= T -> loop_apart n adj V' r v a t) ->
    forall t i j, 0 <= t <= T -> (i < n)%nat -> (j < n)%nat -> Cmod (r i t - r j t)%C <= B.
(* tanner1.collision clause 4, with the potential of Figure 2 *)
Definition fig2 (i j : nat) (s : R) := / s ^ 2 + ln (s ^ 2).
Definition fig2' (i j : nat) (s : R) := - 2 / s ^ 3 + 2 / s.
Definition collision_4 : Prop := forall n adj r v a T, undirected adj -> no_loops adj -> start_apart n adj r ->
  (forall t, 0 <= t <= T -> loop_apart n adj fig2' r v a t) ->
  (forall t i j, 0 <= t <= T -> (i < n)%nat -> (j < n)%nat -> adj i j = true -> r i t <> r j t) /\
  ((forall i j, (i < n)%nat -> (j < n)%nat -> i <> j -> adj i j = true) ->
   forall t i j, 0 <= t <= T -> (i < n)%nat -> (j < n)%nat -> i <> j -> r i t <> r j t).
(* tanner1.eq7 clause 2: the heading th_i of a moving agent, differentiable at t *)
Definition eq7_2 : Prop := forall n adj V V' r v (th : nat -> R -> R) i t, (i < n)%nat ->
  loop n adj V V' r v (fun i j s => th i s - th j s) t -> v i t <> 0%C -> ex_derive (th i) t ->
  locally t (fun s => v i s = (RtoC (Cmod (v i s)) * expi (th i s))%C) ->
  is_derive (th i) t (- Sum n (fun j => if adj i j then (th i t - th j t) / Cmod (r i t - r j t)%C ^ 2 else 0)
    - cross (v i t) (Csum n (fun j => if adj i j then RtoC (V' i j (Cmod (r i t - r j t)%C) / Cmod (r i t - r j t)) * (r i t - r j t) else 0))%C
      / Cmod (v i t) ^ 2).
(* tanner1.eq6 clauses 1, 2, 3; no motion is needed: vdot_i is what the law says *)
Definition eq6_123 : Prop := forall n adj V' (r v : nat -> C) (th : nat -> R), undirected adj -> symmetric_V V' ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> r i <> r j) ->
  let q i j := if adj i j then (th i - th j) / Cmod (r i - r j)%C ^ 2 else 0 in
  let pull i j := (if adj i j then RtoC (V' i j (Cmod (r i - r j)) / Cmod (r i - r j)) * (r i - r j) else 0)%C in
  Sum n (fun i => Sum n (fun j => cross (r i) (pull i j))) = 0 /\
  Sum n (fun i => cross (r i) (law n adj V' (fun i j => th i - th j) r v i)) =
  - Sum n (fun i => cross (r i) (Csum n (fun j => RtoC (q i j) * (Ci * v i))%C)).

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
(* V_ij and V_ji are equal, so their derivatives are where they are asked for: one function for each pair *)
Definition both (V' : nat -> nat -> R -> R) (i j : nat) : R -> R := if Nat.leb i j then V' i j else V' j i.
Lemma both_sym V' i j : both V' i j = both V' j i.
Proof. unfold both. destruct (Nat.leb_spec i j), (Nat.leb_spec j i); try reflexivity; try lia. now replace j with i by lia. Qed.
Lemma both_slope (V V' : nat -> nat -> R -> R) i j s : symmetric_V V -> is_derive (V i j) s (V' i j s) -> is_derive (V j i) s (V' j i s) ->
  is_derive (V i j) s (both V' i j s) /\ both V' i j s = V' i j s.
Proof.
  intros VS A B. assert (E : V' j i s = V' i j s).
  { apply is_derive_unique in A. rewrite <- A. symmetry. apply is_derive_unique. apply (is_derive_ext (V j i)); [intros; apply VS|exact B]. }
  assert (F : both V' i j s = V' i j s) by (unfold both; destruct (Nat.leb i j); [reflexivity|exact E]). now rewrite F.
Qed.
Lemma loop_both n adj V V' r v a t : undirected adj -> symmetric_V V -> loop n adj V V' r v a t -> loop n adj V (both V') r v a t.
Proof.
  intros S VS L. assert (Q : forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true ->
    is_derive (V i j) (Cmod (r i t - r j t)%C) (both V' i j (Cmod (r i t - r j t)%C)) /\ both V' i j (Cmod (r i t - r j t)%C) = V' i j (Cmod (r i t - r j t)%C)).
  { intros i j Hi Hj A. destruct (L i Hi) as (_ & _ & Li). destruct (L j Hj) as (_ & _ & Lj). destruct (Li j Hj A) as [_ D].
    destruct (Lj i Hi ltac:(now rewrite S)) as [_ D']. apply both_slope; [exact VS|exact D|]. unfold Cmod in *.
    replace (fst (r i t - r j t)%C ^ 2 + snd (r i t - r j t)%C ^ 2) with (fst (r j t - r i t)%C ^ 2 + snd (r j t - r i t)%C ^ 2) by (cbn; ring). exact D'. }
  intros i Hi. destruct (L i Hi) as (A & B & K). split; [exact A|]. split.
  - replace (law n adj (both V') (fun i j => a i j t) (fun i => r i t) (fun i => v i t) i)
      with (law n adj V' (fun i j => a i j t) (fun i => r i t) (fun i => v i t) i); [exact B|].
    unfold law. f_equal. f_equal. apply Csum_ext. intros j Hj. destruct (adj i j) eqn:E; [|reflexivity]. now rewrite (proj2 (Q i j Hi Hj E)).
  - intros j Hj E. split; [now apply K|]. now apply Q.
Qed.
(* the rate at which the law turns the velocity of i *)
Definition rate n (adj : graph) (a : nat -> nat -> R -> R) (r : nat -> R -> C) (i : nat) (t : R) : R :=
  - Sum n (fun j => if adj i j then a i j t / Cmod (r i t - r j t)%C ^ 2 else 0).
Lemma law_turned n adj V' (a : nat -> nat -> R -> R) (r v : nat -> R -> C) i t :
  law n adj V' (fun i j => a i j t) (fun i => r i t) (fun i => v i t) i =
  turned n adj V' (fun i => r i t) (fun i => v i t) (fun i => rate n adj a r i t) i.
Proof.
  unfold law, turned, rate, grad_i.
  rewrite (Csum_ext n (fun j => if adj i j then (RtoC (V' i j (Cmod (r i t - r j t)) / Cmod (r i t - r j t)) * (r i t - r j t))%C else RtoC 0) (pair_grad adj V' (fun i => r i t) i)).
  - apply injective_projections; cbn; ring.
  - intros j _. unfold pair_grad, w, grad, norm. destruct (adj i j); apply injective_projections; cbn; ring.
Qed.
Lemma Vt_inv_3_proved : Vt_inv_3.
Proof.
  intros n adj V V' r v a S VS L t Ht. rewrite !energy_is.
  refine (turning_constant n adj V (both V') r v (rate n adj a r) S (both_sym V') t Ht _). intros s Hs.
  pose proof (loop_both n adj V V' r v a s S VS (L s ltac:(lra))) as Ls. split; [split|split].
  - intros i Hi. now apply (Ls i Hi).
  - intros _ i Hi. rewrite <- law_turned. now apply (Ls i Hi).
  - intros i j Hi Hj A. now apply (Ls i Hi).
  - intros i j Hi Hj A. now apply (Ls i Hi).
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
Proof. intros adj V V' r v a d S A VS P L. exact (Vt_inv_3_proved 2%nat adj V V' r v a S VS L). Qed.
Lemma two_agents_2_proved : two_agents_2.
Proof.
  intros adj V V' r v a d ph S A VS P L E W s t Hst.
  apply (tanner1_pair.two_agents_gather adj V (both V') r v (as_headings d) ph (fun i x => Cmod (v i x)) S (both_sym V') A nil s t); [lra| | |].
  - intros x i Hx Hi. destruct (L x ltac:(lra) i Hi) as (_ & [D1 D2] & _).
    split; apply derivable_continuous_pt, ex_derive_Reals_0; eexists; eassumption.
  - intros x i Hx Hi. split; [apply Cmod_ge_0|]. apply E. lra.
  - intros x Hx _. split; [apply steered_is, (loop_pair adj V (both V') r v a d x P), loop_both, L; [assumption|assumption|lra]|]. right.
    destruct (W x ltac:(lra)) as [W1 [k Wk]]. cbn [as_headings]. rewrite Rminus_0_r. split; [lra|]. exists k. rewrite Wk. ring.
Qed.
Lemma two_agents_1_proved : two_agents_1.
Proof.
  intros adj V V' r v a d ph S A VS P t L E.
  pose proof (tanner1_pair.total_rate adj V (both V') r v (as_headings d) S (both_sym V') A t
    (steered_is _ _ _ _ _ _ _ _ (loop_pair _ _ _ _ _ _ _ _ P (loop_both _ _ _ _ _ _ _ _ S VS L)))) as Q.
  apply (is_derive_ext (fun x => / 2 * inner (v 0%nat x + v 1%nat x)%C (v 0%nat x + v 1%nat x)%C)).
  - intros x. rewrite <- norm_sqr. unfold norm. cbn. ring.
  - replace (2 * Cmod (v 0%nat t) * Cmod (v 1%nat t) * d t * sin (ph 0%nat - ph 1%nat))
      with (2 * (as_headings d 0 t - as_headings d 1 t) * cross (v 1%nat t) (v 0%nat t)); [exact Q|].
    cbn [as_headings]. rewrite Rminus_0_r. rewrite (E 0%nat), (E 1%nat) at 1. rewrite sin_minus. unfold cross, expi. cbn. ring.
Qed.
(* a motion of the clauses is one of the theorems *)
Lemma turning_is n adj V V' r v a t : undirected adj -> symmetric_V V ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> repels (V i j) (V' i j)) ->
  loop_apart n adj V' r v a t -> turning n adj (both V') r v (rate n adj a r) t.
Proof.
  intros S VS Rp L. split; [intros i Hi; now apply (L i Hi)|]. intros D i Hi. rewrite <- law_turned.
  replace (law n adj (both V') (fun i j => a i j t) (fun i => r i t) (fun i => v i t) i)
    with (law n adj V' (fun i j => a i j t) (fun i => r i t) (fun i => v i t) i); [now apply (L i Hi)|].
  unfold law. f_equal. f_equal. apply Csum_ext. intros j Hj. destruct (adj i j) eqn:E; [|reflexivity].
  pose proof (norm_neq _ _ (D i j Hi Hj E)) as N. unfold norm in N.
  rewrite (proj2 (both_slope V V' i j (Cmod (r i t - r j t)%C) VS (proj1 (proj1 (Rp i j Hi Hj E) _ N))
    (proj1 (proj1 (Rp j i Hj Hi ltac:(now rewrite S)) _ N)))). reflexivity.
Qed.
Lemma repels_both n (adj : graph) (V V' : nat -> nat -> R -> R) : undirected adj -> symmetric_V V ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> repels (V i j) (V' i j)) ->
  (forall i j s, (i < n)%nat -> (j < n)%nat -> adj i j = true -> 0 < s -> is_derive (V i j) s (both V' i j s) /\ 0 <= V i j s) /\
  forall i j M, (i < n)%nat -> (j < n)%nat -> adj i j = true -> exists d, 0 < d /\ forall s, 0 < s < d -> M < V i j s.
Proof.
  intros S VS Rp. split.
  - intros i j s Hi Hj A Hs. destruct (proj1 (Rp i j Hi Hj A) s Hs) as [D V0]. split; [|exact V0].
    apply both_slope; [exact VS|exact D|]. now apply (Rp j i Hj Hi ltac:(now rewrite S)).
  - intros i j M Hi Hj A. now apply (Rp i j Hi Hj A).
Qed.
Lemma anyV_3_proved : anyV_3.
Proof.
  intros n adj V V' r v a T S _ VS Rp St L t i j Ht Hi Hj A E. destruct (repels_both n adj V V' S VS Rp) as [F1 F2].
  destruct (turning_apart n adj V (both V') r v (rate n adj a r) S (both_sym V') F1 St F2) as [d [Hd Q]].
  specialize (Q T (fun s Hs => turning_is n adj V V' r v a s S VS Rp (L s Hs)) t i j Ht Hi Hj A). rewrite E in Q.
  replace (r j t - r j t)%C with (RtoC 0) in Q by ring. unfold norm in Q. rewrite Cmod_0 in Q. lra.
Qed.
Lemma anyV_4_proved : anyV_4.
Proof.
  intros n adj V V' r v a S _ VS SC Rp St.
  assert (Rp' : forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> repels (V i j) (V' i j)) by (intros; now apply Rp).
  destruct (repels_both n adj V V' S VS Rp') as [F1 F2].
  destruct (turning_cohesion n adj V (both V') r v (rate n adj a r) S (both_sym V') F1 St F2 SC) as [B Q].
  - intros i j M Hi Hj A. now apply (Rp i j Hi Hj A).
  - exists B. intros T L. exact (Q T (fun s Hs => turning_is n adj V V' r v a s S VS Rp' (L s Hs))).
Qed.
Lemma fig2_repels : repels (fig2 0 0) (fig2' 0 0).
Proof.
  split.
  - intros s Hs. split.
    + replace (fig2' 0 0 s) with (V2' s) by (unfold fig2', V2'; field; lra). exact (V2_derive s Hs).
    + change (0 <= V2 s). destruct fig2_shape as (_ & _ & E1 & M). destruct (Req_dec s 1) as [->|N]; [lra|]. pose proof (M s Hs N). lra.
  - intros c. set (q := / (2 * (Rabs c + 2))). pose proof (Rabs_pos c) as C0. pose proof (Rle_abs c) as C1.
    assert (q0 : 0 < q) by (apply Rinv_0_lt_compat; lra). assert (q1 : q < 1).
    { unfold q. rewrite <- Rinv_1. apply Rinv_lt_contravar; lra. }
    exists q. split; [exact q0|]. intros s [S0 S1]. unfold fig2. assert (s2 : 0 < s ^ 2) by now apply pow_lt.
    set (u := / s ^ 2). assert (u0 : 0 < u) by now apply Rinv_0_lt_compat.
    replace (ln (s ^ 2)) with (- ln u) by (unfold u; rewrite ln_Rinv by exact s2; ring).
    assert (U : 2 * (Rabs c + 2) < u).
    { unfold u. replace (2 * (Rabs c + 2)) with (/ q) by (unfold q; rewrite Rinv_inv; reflexivity). apply Rinv_lt_contravar; [nra|]. nra. }
    assert (L : ln u <= u / 2).
    { replace u with (2 * (u / 2)) at 1 by field. rewrite ln_mult by lra. pose proof (exp_ineq1_le (ln (u / 2))) as X. rewrite exp_ln in X by lra.
      assert (ln 2 < 1). { rewrite <- (ln_exp 1). apply ln_increasing; [lra|]. pose proof (exp_ineq1 1 ltac:(lra)). lra. } lra. }
    lra.
Qed.
Lemma collision_4_proved : collision_4.
Proof.
  intros n adj r v a T S NL St L.
  assert (Q : forall t i j, 0 <= t <= T -> (i < n)%nat -> (j < n)%nat -> adj i j = true -> r i t <> r j t).
  { apply (anyV_3_proved n adj fig2 fig2' r v a T S NL); [intros i j s; reflexivity|intros; exact fig2_repels|exact St|exact L]. }
  split; [exact Q|]. intros K t i j Ht Hi Hj N. apply Q; try assumption. now apply K.
Qed.
Lemma eq6_123_proved : eq6_123.
Proof.
  intros n adj V' r v th S VS NC q pull.
  assert (P : forall i j, pull i j = pair_grad adj (both V') r i j).
  { intros i j. unfold pull, pair_grad, w, grad, norm. destruct (adj i j); [|apply injective_projections; cbn; ring].
    replace (both V' i j (Cmod (r i - r j)%C)) with (V' i j (Cmod (r i - r j)%C)); [apply injective_projections; cbn; ring|].
    unfold both. destruct (Nat.leb i j); [reflexivity|apply VS]. }
  set (al := fun i => (- Csum n (fun j => RtoC (q i j) * (Ci * v i)))%C).
  destruct (tanner1_eq6 n adj (both V') r al S (both_sym V')) as [E _].
  assert (X : forall (x y z : C), cross x (y + z)%C = cross x y + cross x z) by (intros; unfold cross; cbn; ring).
  assert (Z : Sum n (fun i => cross (r i) (grad_i n adj (both V') r i)) = 0).
  { rewrite (Sum_ext n _ (fun i => cross (r i) (- grad_i n adj (both V') r i)%C + cross (r i) (al i))) in E by (intros; apply X).
    rewrite Sum_plus in E. rewrite (Sum_ext n _ (fun i => - cross (r i) (- grad_i n adj (both V') r i)%C)) by (intros; unfold cross; cbn; ring).
    rewrite Sum_opp. lra. }
  split.
  - rewrite <- Z. apply Sum_ext. intros i _. unfold grad_i. rewrite cross_Csum. apply Sum_ext. intros j _. now rewrite P.
  - rewrite <- Sum_opp. transitivity (Sum n (fun i => cross (r i) (al i))).
    + rewrite <- E. apply Sum_ext. intros i Hi. f_equal. unfold law, grad_i, al.
      rewrite (Csum_ext n (fun j => if adj i j then _ else _) (pair_grad adj (both V') r i)) by (intros j _; apply P).
      unfold Cminus. f_equal. f_equal. rewrite (Csum_ext n _ (fun j => (Ci * v i) * RtoC (q i j))%C) by (intros; ring).
      rewrite Csum_scal. rewrite Cmult_comm. f_equal. apply injective_projections; cbn; [reflexivity|symmetry; apply Sum_0].
    + apply Sum_ext. intros i _. unfold al, cross. cbn. ring.
Qed.
Lemma eq7_2_proved : eq7_2.
Proof.
  intros n adj V V' r v th i t Hi L N [dth Dt] Loc. destruct (L i Hi) as (_ & [B1 B2] & _).
  set (s := fun x => Cmod (v i x)). assert (s0 : 0 < s t) by now apply Cmod_gt_0.
  assert (Ds : exists ds, is_derive s t ds).
  { assert (I : is_derive (fun x => fst (v i x) ^ 2 + snd (v i x) ^ 2) t (2 * fst (v i t) * _ + 2 * snd (v i t) * _)) by (apply D_plus; apply D_sqr; eassumption).
    eexists. unfold s, Cmod. apply (is_derive_comp sqrt (fun x => fst (v i x) ^ 2 + snd (v i x) ^ 2)); [|exact I].
    apply is_derive_Reals, derivable_pt_lim_sqrt. unfold s, Cmod in s0. apply Rnot_le_lt. intros Le. rewrite sqrt_neg_0 in s0 by exact Le. lra. }
  destruct Ds as [ds Ds].
  assert (VE : v i t = (RtoC (s t) * expi (th i t))%C) by exact (locally_singleton _ _ Loc).
  set (s' := fun (k : nat) x => s x).
  pose proof (eq7_corrected n adj V' (fun j => r j t) s' th (fun _ => ds) (fun _ => dth) t i s0 Ds Dt) as Q. cbv beta in Q.
  unfold s' in Q. rewrite <- VE in Q.
  replace (- Sum n (fun j => if adj i j then (th i t - th j t) / Cmod (r i t - r j t)%C ^ 2 else 0) -
     cross (v i t) (Csum n (fun j => if adj i j then RtoC (V' i j (Cmod (r i t - r j t)%C) / Cmod (r i t - r j t)) * (r i t - r j t) else 0))%C / Cmod (v i t) ^ 2)
    with (- align n adj (fun j => r j t) (fun j => th j t) i - cross (v i t) (grad_i n adj V' (fun j => r j t) i) / norm (v i t) ^ 2).
  - rewrite <- Q; [exact Dt|].
    assert (F : accel n adj V' (fun j => r j t) (fun j => (RtoC (s t) * expi (th j t))%C) (fun j => th j t) i
      = law n adj V' (fun i j => th i t - th j t) (fun i => r i t) (fun i => v i t) i).
    { rewrite law_is. unfold accel, gyro. now rewrite <- VE. }
    rewrite F. split; [apply (is_derive_ext_loc (fun x => fst (v i x)))|apply (is_derive_ext_loc (fun x => snd (v i x)))]; try assumption;
      apply (filter_imp _ _ (fun x Hx => f_equal _ Hx) Loc).
  - f_equal; [f_equal; unfold align; apply Sum_ext; intros j _; unfold w, norm; destruct (adj i j); ring|].
    f_equal. f_equal. unfold grad_i. apply Csum_ext. intros j _. unfold pair_grad, w, grad, norm. destruct (adj i j); apply injective_projections; cbn; ring.
Qed.

(* ======== the remaining clauses: statements first ======== *)
Definition simple_connected n adj := undirected adj /\ no_loops adj /\ strongly_connected n adj.
(* the headings of moving agents, as atan2 gives them *)
Definition headings n (v : nat -> R -> C) (th : nat -> R -> R) t := forall i, (i < n)%nat ->
  v i t <> 0%C /\ v i t = (RtoC (Cmod (v i t)) * expi (th i t))%C /\ - PI < th i t <= PI.
Definition closed n adj (V V' : nat -> nat -> R -> R) r v (th : nat -> R -> R) t :=
  loop n adj V V' r v (fun i j s => th i s - th j s) t /\ headings n v th t.
Definition Vi n (adj : graph) (V : nat -> nat -> R -> R) (r : nat -> C) i := Sum n (fun j => if adj i j then V i j (Cmod (r i - r j)%C) else 0).
Definition Vt n adj V (r v : nat -> C) (th : nat -> R) := / 2 * Sum n (fun i => Vi n adj V r i + Cmod (v i) ^ 2 + th i ^ 2).
Definition a_theta n (adj : graph) (r v : nat -> C) (th : nat -> R) i : C :=
  (- RtoC (Sum n (fun j => if adj i j then (th i - th j) / Cmod (r i - r j)%C ^ 2 else 0)%R) * (Ci * v i))%C.
Definition gradV n (adj : graph) (V' : nat -> nat -> R -> R) (r : nat -> C) i : C :=
  Csum n (fun j => if adj i j then RtoC (V' i j (Cmod (r i - r j)) / Cmod (r i - r j)) * (r i - r j) else 0)%C.
Definition linked_apart n (adj : graph) (r : nat -> C) := forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> r i <> r j.
(* the entries of Delta, A and of the incidence matrix D; an arc (i, j) goes from i to j; an orientation takes each edge in one direction *)
Definition valency n (adj : graph) i k : R := if Nat.eqb i k then Sum n (fun j => if adj i j then 1 else 0) else 0.
Definition adjacency (adj : graph) i k : R := if adj i k then 1 else 0.
Definition lapL n adj i k := valency n adj i k - adjacency adj i k.
Definition incD (i : nat) (e : nat * nat) : R := if Nat.eqb i (snd e) then 1 else if Nat.eqb i (fst e) then - 1 else 0.
Definition orientation n (adj : graph) (O : list (nat * nat)) := NoDup O /\
  (forall i j, In (i, j) O -> (i < n)%nat /\ (j < n)%nat /\ adj i j = true) /\
  forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> (In (i, j) O /\ ~ In (j, i) O) \/ (In (j, i) O /\ ~ In (i, j) O).
Definition psd n (M : nat -> nat -> R) := forall x : nat -> R, 0 <= Sum n (fun i => x i * Sum n (fun j => M i j * x j)).
Definition sym n (M : nat -> nat -> R) := forall i j, (i < n)%nat -> (j < n)%nat -> M i j = M j i.

(* tanner1.L clause 1 *)
Definition L_1 : Prop := forall n adj O i k, undirected adj -> no_loops adj -> orientation n adj O -> (i < n)%nat -> (k < n)%nat ->
  lapL n adj i k = lsum O (fun e => incD i e * incD k e).
(* tanner1.L clause 2 *)
Definition L_2 : Prop := forall n adj O O' i k, undirected adj -> no_loops adj -> orientation n adj O -> orientation n adj O' ->
  (i < n)%nat -> (k < n)%nat -> lsum O (fun e => incD i e * incD k e) = lsum O' (fun e => incD i e * incD k e).
(* tanner1.L clause 3 *)
Definition L_3 : Prop := forall n adj, undirected adj -> no_loops adj -> sym n (lapL n adj) /\ psd n (lapL n adj).
(* tanner1.L.ones clause 1: refuted, as printed it is said of every graph *)
Definition L_ones_1 : Prop := ~ forall n adj, undirected adj -> no_loops adj -> forall x : nat -> R,
  (exists i, (i < n)%nat /\ x i <> 0) -> (forall i, (i < n)%nat -> Sum n (fun j => lapL n adj i j * x j) = 0) ->
  exists c, forall i, (i < n)%nat -> x i = c.
(* tanner1.Lw clause 1: refuted; D W D has a value where there are as many edges as vertices, and there each of the properties fails *)
Definition DWD n (O : list (nat * nat)) (wt : nat -> R) i j := Sum n (fun k => incD i (nth k O (0, 0)%nat) * wt k * incD k (nth j O (0, 0)%nat)).
Definition square n adj O (wt : nat -> R) := simple_connected n adj /\ orientation n adj O /\ length O = n /\ forall k, 0 < wt k.
Definition Lw_1 : Prop := (exists n adj O, simple_connected n adj /\ orientation n adj O /\ length O <> n) /\
  (~ forall n adj O wt, square n adj O wt -> sym n (DWD n O wt)) /\ (~ forall n adj O wt, square n adj O wt -> psd n (DWD n O wt)) /\
  (~ forall n adj O O' wt, square n adj O wt -> square n adj O' wt ->
     (forall k, (k < n)%nat -> let e := nth k O (0, 0)%nat in let e' := nth k O' (0, 0)%nat in e' = e \/ e' = (snd e, fst e)) ->
     forall i j, (i < n)%nat -> (j < n)%nat -> DWD n O wt i j = DWD n O' wt i j) /\
  (~ forall n adj O wt, square n adj O wt -> forall i, (i < n)%nat -> Sum n (DWD n O wt i) = 0).
(* tanner1.Lw clause 2; the weight of an edge is a i j = a j i *)
Definition Lw_2 : Prop := forall n adj O (a : nat -> nat -> R) i k, undirected adj -> no_loops adj -> orientation n adj O ->
  (forall i j, adj i j = true -> a i j = a j i /\ 0 < a i j) -> (i < n)%nat -> (k < n)%nat ->
  lsum O (fun e => incD i e * a (fst e) (snd e) * incD k e) =
  (if Nat.eqb i k then Sum n (fun j => if adj i j then a i j else 0) else 0) - (if adj i k then a i k else 0).
(* tanner1.Lw clause 3 *)
Definition Lw_3 : Prop := forall n adj O O' (a : nat -> nat -> R) i k, undirected adj -> no_loops adj -> orientation n adj O -> orientation n adj O' ->
  (forall i j, adj i j = true -> a i j = a j i /\ 0 < a i j) -> (i < n)%nat -> (k < n)%nat ->
  lsum O (fun e => incD i e * a (fst e) (snd e) * incD k e) = lsum O' (fun e => incD i e * a (fst e) (snd e) * incD k e).
(* tanner1.Vmono clause 1: refuted *)
Definition Vmono_1 : Prop := ~ forall s t, 0 < s <= t -> fig2 0 0 s <= fig2 0 0 t.
(* tanner1.fig2 clause 1 *)
Definition fig2_1 : Prop := exists s0, 0 < s0 /\ (forall s, 0 < s -> s <> s0 -> fig2 0 0 s0 < fig2 0 0 s) /\
  (forall s t, 0 < s < t -> t <= s0 -> fig2 0 0 t < fig2 0 0 s) /\ forall s t, s0 <= s < t -> fig2 0 0 s < fig2 0 0 t.
(* tanner1.Vt clause 1 *)
Definition Vt_1 : Prop := forall n adj r v th, linked_apart n adj r -> 0 <= Vt n adj fig2 r v th /\
  Vt n adj fig2 r v th = / 2 * Sum n (fun i => Sum n (fun j => if adj i j then fig2 i j (Cmod (r i - r j)%C) else 0) + inner (v i) (v i) + th i ^ 2).
(* tanner1.Vt_inv clause 1: refuted, with the potential of Figure 2 and away from jumps and agents at rest *)
Definition Vt_inv_1 : Prop := ~ forall n adj r v th T, simple_connected n adj ->
  (forall t, 0 <= t <= T -> closed n adj fig2 fig2' r v th t /\ forall i, (i < n)%nat -> ex_derive (th i) t) -> forall s t, 0 <= s <= t -> t <= T ->
  Vt n adj fig2 (fun i => r i t) (fun i => v i t) (fun i => th i t) <= Vt n adj fig2 (fun i => r i s) (fun i => v i s) (fun i => th i s).
(* tanner1.anyV clause 1: refuted, even for non-negative potentials that tend to infinity with the distance *)
Definition anyV_1 : Prop := ~ forall n adj V V' r v (th : nat -> R -> R), simple_connected n adj -> symmetric_V V ->
  (forall i j s, 0 < s -> is_derive (V i j) s (V' i j s) /\ 0 <= V i j s) -> (forall i j, binds (V i j)) -> start_apart n adj r ->
  (forall t, 0 <= t -> loop_apart n adj V' r v (fun i j s => th i s - th j s) t /\ headings n v th t) ->
  forall t i j, 0 <= t -> (i < n)%nat -> (j < n)%nat -> adj i j = true -> r i t <> r j t.
(* tanner1.anyV clause 2: refuted, even for non-negative potentials that tend to infinity at 0 *)
Definition anyV_2 : Prop := ~ forall n adj V V' r v (th : nat -> R -> R), simple_connected n adj -> symmetric_V V ->
  (forall i j, repels (V i j) (V' i j)) -> start_apart n adj r -> (forall t, 0 <= t -> closed n adj V V' r v th t) ->
  exists B, forall t i j, 0 <= t -> (i < n)%nat -> (j < n)%nat -> Cmod (r i t - r j t)%C <= B.
(* tanner1.collision clause 1: refuted, for connected graphs *)
Definition collision_1 : Prop := ~ forall n adj i j, simple_connected n adj -> (i < n)%nat -> (j < n)%nat -> i <> j ->
  forall c, exists d, 0 < d /\ forall r v th, linked_apart n adj r -> r i <> r j -> Cmod (r i - r j)%C < d -> c < Vt n adj fig2 r v th.
(* tanner1.collision clause 2: refuted, for connected graphs and motions that last *)
Definition collision_2 : Prop := ~ forall n adj r v th, simple_connected n adj ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> i <> j -> r i 0 <> r j 0) -> (forall t, 0 <= t -> closed n adj fig2 fig2' r v th t) ->
  forall t i j, 0 <= t -> (i < n)%nat -> (j < n)%nat -> i <> j -> r i t <> r j t.
(* tanner1.eq7 clause 1: refuted, with the potential of Figure 2 and away from jumps and agents at rest *)
Definition eq7_1 : Prop := ~ forall n adj r v th t i, simple_connected n adj -> (i < n)%nat ->
  locally t (closed n adj fig2 fig2' r v th) -> ex_derive (th i) t ->
  is_derive (th i) t (- Sum n (fun j => if adj i j then (th i t - th j t) / Cmod (r i t - r j t)%C ^ 2 else 0)).
(* tanner1.eq8 clause 1; gradients of functions of a vector by derivatives in all directions *)
Definition gradient (F : C -> R) (x g : C) := forall u : C, is_derive (fun h => F (x + RtoC h * u)%C) 0 (inner g u).
Definition eq8_1 : Prop := forall (V : R -> R) (ri rj : C), ri <> rj -> ex_derive V (Cmod (ri - rj)%C) -> exists g,
  gradient (fun x => V (Cmod x)) (ri - rj)%C g /\ gradient (fun x => V (Cmod (x - rj)%C)) ri g /\ gradient (fun x => V (Cmod (ri - x)%C)) rj (- g)%C.
(* tanner1.eq8 clause 2; gradV is the gradient of V_i with respect to r_i *)
Definition eq8_2 : Prop := forall n adj V V' (r : nat -> R -> C) (v : nat -> C) t, undirected adj -> no_loops adj -> symmetric_V V ->
  (forall i, (i < n)%nat -> is_velocity (r i) t (v i)) -> linked_apart n adj (fun i => r i t) ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> is_derive (V i j) (Cmod (r i t - r j t)%C) (V' i j (Cmod (r i t - r j t)%C))) ->
  is_derive (fun s => Sum n (fun i => / 2 * Vi n adj V (fun j => r j s) i)) t (Sum n (fun i => inner (gradV n adj V' (fun j => r j t) i) (v i))) /\
  forall i, (i < n)%nat -> gradient (fun x => Sum n (fun j => if adj i j then V i j (Cmod (x - r j t)%C) else 0)) (r i t) (gradV n adj V' (fun j => r j t) i).
(* tanner1.eq9.chain clause 2 *)
Definition eq9_2 : Prop := forall n adj V V' r v th (dth : nat -> R) t, undirected adj -> no_loops adj -> symmetric_V V ->
  closed n adj V V' r v th t -> (forall i, (i < n)%nat -> is_derive (th i) t (dth i)) ->
  is_derive (fun s => Vt n adj V (fun i => r i s) (fun i => v i s) (fun i => th i s)) t (Sum n (fun i => th i t * dth i)).
(* tanner1.gyro clause 1 *)
Definition gyro_1 : Prop := forall n adj r v th i, inner (v i) (a_theta n adj r v th i) = 0.
(* tanner1.gyro clause 2: the kinetic energy changes as if the component were not there *)
Definition gyro_2 : Prop := forall n adj (r v : nat -> R -> C) (th : nat -> R -> R) (a_r : nat -> C) t,
  (forall i, (i < n)%nat -> is_velocity (v i) t (a_r i + a_theta n adj (fun j => r j t) (fun j => v j t) (fun j => th j t) i)%C) ->
  is_derive (fun s => Sum n (fun i => / 2 * Cmod (v i s) ^ 2)) t (Sum n (fun i => inner (v i t) (a_r i))).
(* tanner1.propIV3b clause 1: refuted; the distances of linked agents need not even tend to limits *)
Definition propIV3b_1 : Prop := ~ forall n adj r v th, simple_connected n adj -> (forall t, 0 <= t -> closed n adj fig2 fig2' r v th t) ->
  forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> exists d : R, is_lim (fun t => Cmod (r i t - r j t)%C) p_infty d.
