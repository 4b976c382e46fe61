(* Clauses of the claims about Tanner's first paper, formalised from their words before the theorems were looked at; the theorems
   prove them. *)
From Coq Require Import Reals Lra Lia List Relations Psatz.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums paley_model paley_phase paley_laplacian paley_gradient paley_particles tanner_energy tanner_flock
  tanner1_heading tanner1_motion.
From Flockproof Require tanner1_pair tanner_trees tanner_graph tanner1_examples.
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
(* the same through jumps of headings, stated after the theorems had been seen: clauses 2, 3 of beyond.tanner1.two_agents too *)
Definition jumping n adj (V V' : nat -> nat -> R -> R) (r v : nat -> R -> C) a (J : list R) t :=
  (forall i, (i < n)%nat -> is_velocity (r i) t (v i t) /\ continuity_pt (fun s => fst (v i s)) t /\ continuity_pt (fun s => snd (v i s)) t /\
     forall j, (j < n)%nat -> adj i j = true -> r i t <> r j t /\ is_derive (V i j) (Cmod (r i t - r j t)%C) (V' i j (Cmod (r i t - r j t)%C))) /\
  (~ In t J -> loop n adj V V' r v a t).
Definition Vt_inv_3_jumps : Prop := forall n adj V V' r v a J t, undirected adj -> symmetric_V V -> 0 <= t -> (forall s, 0 <= s <= t -> jumping n adj V V' r v a J s) ->
  kinetic_plus_V n adj V (fun i => r i t) (fun i => v i t) = kinetic_plus_V n adj V (fun i => r i 0) (fun i => v i 0).
Definition two_agents_2_jumps : Prop := forall adj V V' r v a d (ph : nat -> R -> R) J s t, undirected adj -> adj 0%nat 1%nat = true ->
  symmetric_V V -> pair_of a d -> s <= t -> (forall x, s <= x <= t -> jumping 2 adj V V' r v a J x) ->
  (forall x i, s <= x <= t -> v i x = (RtoC (Cmod (v i x)) * expi (ph i x))%C) ->
  (forall x, s <= x <= t -> - PI < d x <= PI /\ exists k : Z, d x = ph 0%nat x - ph 1%nat x + 2 * PI * IZR k) ->
  Cmod (v 0%nat s + v 1%nat s)%C <= Cmod (v 0%nat t + v 1%nat t)%C.
(* tanner1.anyV clauses 3, 4: as long as the motion lasts, until T; that no linked agents meet is the conclusion *)
Definition loop_apart n adj (V' : nat -> nat -> R -> R) (r v : nat -> R -> C) a t :=
  forall i, (i < n)%nat -> is_velocity (r i) t (v i t) /\
    ((forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> r i t <> r j t) ->
     is_velocity (v i) t (law n adj V' (fun i j => a i j t) (fun i => r i t) (fun i => v i t) i)).
(* the same with jumps of headings at the times in J, where the velocities are continuous *)
Definition loop_jumps n adj (V' : nat -> nat -> R -> R) (r v : nat -> R -> C) a (J : list R) t :=
  forall i, (i < n)%nat -> is_velocity (r i) t (v i t) /\
    ((forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> r i t <> r j t) ->
     continuity_pt (fun s => fst (v i s)) t /\ continuity_pt (fun s => snd (v i s)) t /\
     (~ In t J -> is_velocity (v i) t (law n adj V' (fun i j => a i j t) (fun i => r i t) (fun i => v i t) i))).
Definition start_apart n (adj : graph) (r : nat -> R -> C) := forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> r i 0 <> r j 0.
Definition repels (V V' : R -> R) := (forall s, 0 < s -> is_derive V s (V' s) /\ 0 <= V s) /\
  forall c, exists d, 0 < d /\ forall s, 0 < s < d -> c < V s.
Definition binds (V : R -> R) := forall c, exists D, forall s, D < s -> c < V s.
Definition anyV_3 : Prop := forall n adj V V' r v a T J, undirected adj -> no_loops adj -> symmetric_V V ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> repels (V i j) (V' i j)) -> start_apart n adj r ->
  (forall t, 0 <= t <= T -> loop_jumps n adj V' r v a J t) ->
  forall t i j, 0 <= t <= T -> (i < n)%nat -> (j < n)%nat -> adj i j = true -> r i t <> r j t.
Definition anyV_4 : Prop := forall n adj V V' r v a, undirected adj -> no_loops adj -> symmetric_V V -> strongly_connected n adj ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> repels (V i j) (V' i j) /\ binds (V i j)) -> start_apart n adj r ->
  exists B, forall T J, (forall t, 0 <= t <= T -> loop_jumps n adj V' r v a J t) ->
    forall t i j, 0 <= t <= T -> (i < n)%nat -> (j < n)%nat -> Cmod (r i t - r j t)%C <= B.
(* tanner1.collision clause 4, with the potential of Figure 2 *)
Definition fig2 (i j : nat) (s : R) := / s ^ 2 + ln (s ^ 2).
Definition fig2' (i j : nat) (s : R) := - 2 / s ^ 3 + 2 / s.
Definition collision_4 : Prop := forall n adj r v a T J, undirected adj -> no_loops adj -> start_apart n adj r ->
  (forall t, 0 <= t <= T -> loop_jumps n adj fig2' r v a J t) ->
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
  refine (turning_constant n adj V (both V') r v (rate n adj a r) S (both_sym V') nil t Ht _). intros s Hs.
  pose proof (loop_both n adj V V' r v a s S VS (L s ltac:(lra))) as Ls. split; [split|split].
  - intros i Hi. now apply (Ls i Hi).
  - intros _ i Hi. destruct (Ls i Hi) as (_ & Lw & _). split; [|split]; [..|intros _; rewrite <- law_turned; exact Lw]; apply derivable_continuous_pt, ex_derive_Reals_0; eexists; apply Lw.
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
Lemma Vt_inv_3_jumps_proved : Vt_inv_3_jumps.
Proof.
  intros n adj V V' r v a J t S VS Ht L. rewrite !energy_is.
  refine (turning_constant n adj V (both V') r v (rate n adj a r) S (both_sym V') J t Ht _). intros s Hs. destruct (L s Hs) as [C Ls].
  assert (Q : forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> is_derive (V i j) (Cmod (r i s - r j s)%C) (both V' i j (Cmod (r i s - r j s)%C))).
  { intros i j Hi Hj A. destruct (C i Hi) as (_ & _ & _ & Ci). destruct (C j Hj) as (_ & _ & _ & Cj). apply both_slope; [exact VS|now apply Ci|].
    replace (Cmod (r i s - r j s)%C) with (Cmod (r j s - r i s)%C) by apply norm_sym. apply Cj; [exact Hi|now rewrite S]. }
  split; [split|split].
  - intros i Hi. now apply (C i Hi).
  - intros _ i Hi. split; [now apply (C i Hi)|]. split; [now apply (C i Hi)|]. intros NJ. rewrite <- law_turned.
    now apply (loop_both n adj V V' r v a s S VS (Ls NJ) i Hi).
  - intros i j Hi Hj A. now apply (C i Hi).
  - exact Q.
Qed.
Lemma two_agents_2_jumps_proved : two_agents_2_jumps.
Proof.
  intros adj V V' r v a d ph J s t S A VS P Hst L E W.
  apply (tanner1_pair.two_agents_gather adj V (both V') r v (as_headings d) ph (fun i x => Cmod (v i x)) S (both_sym V') A J s t); [exact Hst| | |].
  - intros x i Hx Hi. destruct (L x Hx) as [C _]. split; now apply (C i Hi).
  - intros x i Hx Hi. split; [apply Cmod_ge_0|]. now apply E.
  - intros x Hx NJ. destruct (L x ltac:(lra)) as [_ Lx]. split; [apply steered_is, (loop_pair adj V (both V') r v a d x P), loop_both, Lx; assumption|]. right.
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
Lemma turning_is n adj V V' r v a J t : undirected adj -> symmetric_V V ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> repels (V i j) (V' i j)) ->
  loop_jumps n adj V' r v a J t -> turning n adj (both V') r v (rate n adj a r) J t.
Proof.
  intros S VS Rp L. split; [intros i Hi; now apply (L i Hi)|]. intros D i Hi. destruct (L i Hi) as [_ Li]. destruct (Li D) as (C1 & C2 & Lw).
  split; [exact C1|]. split; [exact C2|]. intros NJ. specialize (Lw NJ). rewrite <- law_turned.
  replace (law n adj (both V') (fun i j => a i j t) (fun i => r i t) (fun i => v i t) i)
    with (law n adj V' (fun i j => a i j t) (fun i => r i t) (fun i => v i t) i); [exact Lw|].
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
  intros n adj V V' r v a T J S _ VS Rp St L t i j Ht Hi Hj A E. destruct (repels_both n adj V V' S VS Rp) as [F1 F2].
  destruct (turning_apart n adj V (both V') r v (rate n adj a r) S (both_sym V') F1 St F2) as [d [Hd Q]].
  specialize (Q T J (fun s Hs => turning_is n adj V V' r v a J s S VS Rp (L s Hs)) t i j Ht Hi Hj A). rewrite E in Q.
  replace (r j t - r j t)%C with (RtoC 0) in Q by ring. unfold norm in Q. rewrite Cmod_0 in Q. lra.
Qed.
Lemma anyV_4_proved : anyV_4.
Proof.
  intros n adj V V' r v a S _ VS SC Rp St.
  assert (Rp' : forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> repels (V i j) (V' i j)) by (intros; now apply Rp).
  destruct (repels_both n adj V V' S VS Rp') as [F1 F2].
  destruct (turning_cohesion n adj V (both V') r v (rate n adj a r) S (both_sym V') F1 St F2 SC) as [B Q].
  - intros i j M Hi Hj A. now apply (Rp i j Hi Hj A).
  - exists B. intros T J L. exact (Q T J (fun s Hs => turning_is n adj V V' r v a J s S VS Rp' (L s Hs))).
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
  intros n adj r v a T J S NL St L.
  assert (Q : forall t i j, 0 <= t <= T -> (i < n)%nat -> (j < n)%nat -> adj i j = true -> r i t <> r j t).
  { apply (anyV_3_proved n adj fig2 fig2' r v a T J S NL); [intros i j s; reflexivity|intros; exact fig2_repels|exact St|exact L]. }
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

(* ---- the theorems prove them ---- *)
Lemma orientation_is n adj O : undirected adj -> no_loops adj -> orientation n adj O -> tanner_graph.oriented n adj O.
Proof.
  intros S NL (N & B & E). split; [exact N|]. split; [intros i j H; now apply B in H as (? & ? & _)|]. intros i j Hi Hj. unfold member, w.
  destruct (adj i j) eqn:A.
  - destruct (E i j Hi Hj A) as [[P Q]|[P Q]]; destruct (in_dec pair_dec (i, j) O), (in_dec pair_dec (j, i) O); try contradiction; ring.
  - destruct (in_dec pair_dec (i, j) O) as [P|_]; [apply B in P as (_ & _ & P); congruence|].
    destruct (in_dec pair_dec (j, i) O) as [P|_]; [apply B in P as (_ & _ & P); rewrite S in P; congruence|]. ring.
Qed.
Lemma incD_is n adj O i e : no_loops adj -> orientation n adj O -> In e O -> incD i e = inc i e.
Proof.
  intros NL (_ & B & _) I. destruct e as [a b]. apply B in I as (_ & _ & I). unfold incD, inc, delta. cbn [fst snd].
  assert (a <> b) by (intros ->; rewrite NL in I; discriminate).
  destruct (Nat.eqb_spec i b), (Nat.eqb_spec i a); try ring. subst. now elim H.
Qed.
Lemma lsum_in O f h : (forall e, In e O -> f e = h e) -> lsum O f = lsum O h.
Proof. intros H. unfold lsum. induction O as [|e O IH]; cbn; [reflexivity|]. rewrite IH, (H e); [reflexivity|now left|intros; apply H; now right]. Qed.
Lemma lapL_is n adj i k : lapL n adj i k = lap n adj i k.
Proof. unfold lapL, valency, adjacency, lap, delta, deg, w. destruct (Nat.eqb i k); [|ring]. rewrite Rmult_1_l. reflexivity. Qed.
Lemma Lw_2_proved : Lw_2.
Proof.
  intros n adj O a i k S NL HO Ha Hi Hk. set (W := fun i j => if adj i j then a i j else 1).
  assert (WS : forall i j, W i j = W j i) by (intros p q; unfold W; rewrite (S q p); destruct (adj p q) eqn:E; [now apply Ha|reflexivity]).
  rewrite (lsum_in O _ (fun e => inc i e * W (fst e) (snd e) * inc k e)).
  - rewrite (tanner_graph.Lw_incidence n adj O W i k S (orientation_is n adj O S NL HO) WS Hi Hk). unfold tanner_graph.lapw, delta, w, W.
    replace (Sum n (fun j => (if adj i j then 1 else 0) * (if adj i j then a i j else 1))) with (Sum n (fun j => if adj i j then a i j else 0))
      by (apply Sum_ext; intros j _; destruct (adj i j); ring).
    destruct (Nat.eqb i k), (adj i k); ring.
  - intros e I. rewrite !(incD_is n adj O _ e NL HO I). destruct e as [p q]. cbn [fst snd]. destruct HO as (_ & B & _).
    destruct (B p q I) as (_ & _ & E). unfold W. rewrite E. reflexivity.
Qed.
Lemma Lw_3_proved : Lw_3.
Proof. intros n adj O O' a i k S NL H H' Ha Hi Hk. rewrite (Lw_2_proved n adj O a i k), (Lw_2_proved n adj O' a i k); auto. Qed.
Lemma L_1_proved : L_1.
Proof.
  intros n adj O i k S NL HO Hi Hk. rewrite lapL_is, <- (tanner_graph.L_incidence n adj O i k S (orientation_is n adj O S NL HO) Hi Hk).
  apply lsum_in. intros e I. now rewrite !(incD_is n adj O _ e NL HO I).
Qed.
Lemma L_2_proved : L_2.
Proof. intros n adj O O' i k S NL H H' Hi Hk. rewrite <- (L_1_proved n adj O i k), <- (L_1_proved n adj O' i k); auto. Qed.
Lemma form_is n M x : Sum n (fun i => x i * Sum n (fun j => M i j * x j)) = qform n M x. Proof. reflexivity. Qed.
Lemma L_3_proved : L_3.
Proof.
  intros n adj S NL. split; [intros i j _ _; rewrite !lapL_is; now apply (lap_psd n adj (fun _ => RtoC 0))|]. intros x.
  rewrite (Sum_ext n _ (fun k => x k * Sum n (fun j => tanner_graph.lapw n (fun i j => w adj i j * 1) k j * x j))).
  - now apply (tanner_graph.Lw_kernel n adj (fun _ _ => 1) x S); intros; [|lra].
  - intros k _. f_equal. apply Sum_ext. intros j _. rewrite lapL_is. unfold lap, tanner_graph.lapw, deg. rewrite Rmult_1_r. f_equal. f_equal. f_equal.
    apply Sum_ext. intros; ring.
Qed.
Lemma L_ones_1_proved : L_ones_1.
Proof.
  intros H. apply tanner_graph.L_ones_fails. intros n adj x Hn S NL E.
  destruct (Classical_Prop.classic (exists i, (i < n)%nat /\ x i <> 0)) as [N|N].
  - apply (H n adj S NL x N). intros i Hi. rewrite <- (E i Hi). unfold lmul. apply Sum_ext. intros j _. now rewrite lapL_is.
  - exists 0. intros i Hi. destruct (Req_dec (x i) 0); [assumption|]. elim N. now exists i.
Qed.
(* three vertices, three edges *)
Definition tri0 : list (nat * nat) := ((0, 1) :: (1, 2) :: (2, 0) :: nil)%nat.
Definition tri1 : list (nat * nat) := ((1, 0) :: (1, 2) :: (2, 0) :: nil)%nat.
Lemma complete_connected n : simple_connected n complete.
Proof.
  split; [exact complete_undirected|]. split; [exact complete_no_loops|]. intros j k Hj Hk. destruct (Nat.eq_dec j k) as [->|N]; [apply rt_refl|].
  apply rt_step. repeat split; try assumption. unfold complete. destruct (Nat.eqb_spec k j); [congruence|reflexivity].
Qed.
Ltac distinct_pairs := repeat constructor; cbn; intuition congruence.
Lemma tri_square O : O = tri0 \/ O = tri1 -> square 3 complete O (fun _ => 1).
Proof.
  intros HO. split; [exact (complete_connected 3)|]. split; [|split; [destruct HO; subst; reflexivity|intros; lra]].
  split; [destruct HO; subst; distinct_pairs|]. split.
  - intros i j I. destruct HO; subst; cbn in I; repeat destruct I as [I|I]; try contradiction; injection I; intros; subst; repeat split; first [lia|reflexivity].
  - intros i j Hi Hj A. destruct HO; subst; destruct i as [|[|[|]]], j as [|[|[|]]]; try lia; try discriminate A; cbn;
      first [left; split; [intuition congruence|intuition congruence]|right; split; intuition congruence].
Qed.
Lemma K2_connected : exists n adj O, simple_connected n adj /\ orientation n adj O /\ length O <> n.
Proof.
  exists 2%nat, complete, ((0, 1) :: nil)%nat. split; [exact (complete_connected 2)|]. split; [|cbn; lia]. split; [distinct_pairs|]. split.
  - intros i j [I|[]]. injection I. intros; subst. repeat split; lia.
  - intros i j Hi Hj A. destruct i as [|[|]], j as [|[|]]; try lia; try discriminate A; cbn; [left|right]; split; intuition congruence.
Qed.
Lemma Lw_1_proved : Lw_1.
Proof.
  split; [exact K2_connected|]. split; [|split; [|split]].
  - intros H. specialize (H _ _ _ _ (tri_square tri0 (or_introl eq_refl)) 0%nat 1%nat ltac:(lia) ltac:(lia)). unfold DWD, incD in H. cbn in H. lra.
  - intros H. specialize (H _ _ _ _ (tri_square tri1 (or_intror eq_refl)) (fun i => match i with 0%nat => 0 | _ => 1 end)). unfold DWD, incD in H. cbn in H. lra.
  - intros H. specialize (H 3%nat complete tri0 tri1 (fun _ => 1) (tri_square tri0 (or_introl eq_refl)) (tri_square tri1 (or_intror eq_refl))).
    assert (E : forall k, (k < 3)%nat -> let e := nth k tri0 (0, 0)%nat in let e' := nth k tri1 (0, 0)%nat in e' = e \/ e' = (snd e, fst e)).
    { intros k Hk. destruct k as [|[|[|]]]; try lia; cbn; [right|left|left]; reflexivity. }
    specialize (H E 0%nat 2%nat ltac:(lia) ltac:(lia)). unfold DWD, incD in H. cbn in H. lra.
  - intros H. specialize (H _ _ _ _ (tri_square tri1 (or_intror eq_refl)) 0%nat ltac:(lia)). unfold DWD, incD in H. cbn in H. lra.
Qed.

Lemma Vmono_1_proved : Vmono_1.
Proof. intros H. apply tanner1_heading.Vmono_fails. intros s t [S0 S1]. apply H. lra. Qed.
Lemma fig2_1_proved : fig2_1.
Proof.
  destruct fig2_shape as (A & B & E & M). exists 1. split; [lra|]. split; [|split; [exact A|exact B]].
  intros s S0 N. specialize (M s S0 N). change (V2 1 < V2 s). rewrite E in *. exact M.
Qed.
Lemma Vt_is n adj V r v th : Vt n adj V r v th = tanner1_heading.Vt n adj V r v th.
Proof.
  unfold Vt, tanner1_heading.Vt. f_equal. apply Sum_ext. intros i _. f_equal. f_equal.
  - unfold Vi, V_i. apply Sum_ext. intros j _. unfold w, norm. destruct (adj i j); ring.
  - rewrite <- norm_sqr. unfold norm. ring.
Qed.
Lemma Vt_1_proved : Vt_1.
Proof.
  intros n adj r v th A. split.
  - rewrite Vt_is. apply Vt_ge0; [|exact A]. intros i j s _ _ Hs. change (0 <= fig2 0 0 s). now apply fig2_repels.
  - unfold Vt. f_equal. apply Sum_ext. intros i _. unfold Vi. f_equal. f_equal. rewrite <- norm_sqr. unfold norm. ring.
Qed.
Lemma a_theta_is n adj r v th i : a_theta n adj r v th i = gyro n adj r v th i.
Proof.
  unfold a_theta, gyro. f_equal. replace (align n adj r th i) with (Sum n (fun j => if adj i j then (th i - th j) / Cmod (r i - r j)%C ^ 2 else 0)).
  - apply injective_projections; cbn; ring.
  - unfold align. apply Sum_ext. intros j _. unfold w, norm. destruct (adj i j); ring.
Qed.
Lemma gyro_1_proved : gyro_1.
Proof. intros n adj r v th i. rewrite a_theta_is. apply gyro_no_work. Qed.
Lemma gyro_2_proved : gyro_2.
Proof.
  intros n adj r v th a t H. apply D_Sum. intros i Hi. specialize (H i Hi). rewrite a_theta_is in H.
  pose proof (gyro_kinetic n adj (fun j => r j t) (fun j => th j t) v (a i) t i H) as K.
  apply (is_derive_ext (fun s => / 2 * inner (v i s) (v i s))); [|exact K]. intros s. rewrite <- norm_sqr. unfold norm. cbn. Rring.
Qed.
Lemma gradV_is n adj V' r i : gradV n adj V' r i = grad_i n adj V' r i.
Proof. unfold gradV, grad_i. apply Csum_ext. intros j _. unfold pair_grad, w, grad, norm. destruct (adj i j); apply injective_projections; cbn; ring. Qed.
Lemma eq8_1_proved : eq8_1.
Proof.
  intros V ri rj N [d Hd]. exists (RtoC (d / Cmod (ri - rj)) * (ri - rj))%C.
  split; [|split]; intros u; destruct (tanner1_eq8_gradients V (fun _ => d) ri rj u N Hd) as (A & B & F); [exact F|exact A|].
  eapply D_eq; [exact B|]. unfold grad, norm. rewrite !inner_xy. cbn. ring.
Qed.
Lemma both_at n adj (V V' : nat -> nat -> R -> R) r : undirected adj -> symmetric_V V ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> is_derive (V i j) (Cmod (r i - r j)%C) (V' i j (Cmod (r i - r j)%C))) ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> is_derive (V i j) (Cmod (r i - r j)%C) (both V' i j (Cmod (r i - r j)%C))) /\
  forall i, (i < n)%nat -> gradV n adj V' r i = grad_i n adj (both V') r i.
Proof.
  intros S VS H. assert (Q : forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true ->
    is_derive (V i j) (Cmod (r i - r j)%C) (both V' i j (Cmod (r i - r j)%C)) /\ both V' i j (Cmod (r i - r j)%C) = V' i j (Cmod (r i - r j)%C)).
  { intros i j Hi Hj A. apply both_slope; [exact VS|now apply H|]. pose proof (H j i Hj Hi ltac:(now rewrite S)) as K.
    fold (norm (r j - r i)%C) in K. rewrite norm_sym in K. exact K. }
  split; [intros; now apply Q|]. intros i Hi. rewrite <- gradV_is. unfold gradV. apply Csum_ext. intros j Hj.
  destruct (adj i j) eqn:A; [|reflexivity]. now rewrite (proj2 (Q i j Hi Hj A)).
Qed.
Lemma eq8_2_proved : eq8_2.
Proof.
  intros n adj V V' r v t S NL VS HR HN HV. destruct (both_at n adj V V' (fun i => r i t) S VS HV) as [HB G]. split.
  - pose proof (eq8_potential n adj V (both V') r (fun i _ => v i) t S (both_sym V') HR HN HB) as Q. cbv beta in Q.
    apply (is_derive_ext (fun s => / 2 * Sum n (fun i => V_i n adj V (fun i => r i s) i))).
    + intros s. rewrite <- Sum_scal. apply Sum_ext. intros i _. f_equal. unfold Vi, V_i. apply Sum_ext. intros j _. unfold w, norm. destruct (adj i j); ring.
    + eapply D_eq; [exact Q|]. apply Sum_ext. intros i Hi. rewrite inner_sym. f_equal. symmetry. now apply G.
  - intros i Hi u. unfold gradV. rewrite inner_sym, inner_Csum. apply (D_Sum n (fun j h => if adj i j then V i j (Cmod (r i t + RtoC h * u - r j t)%C) else 0)
      (fun j => inner u (if adj i j then RtoC (V' i j (Cmod (r i t - r j t)) / Cmod (r i t - r j t)) * (r i t - r j t) else 0)%C)).
    intros j Hj. destruct (adj i j) eqn:A.
    + destruct (tanner1_eq8_gradients (V i j) (V' i j) (r i t) (r j t) u (HN i j Hi Hj A) (HV i j Hi Hj A)) as (F & _ & _).
      rewrite inner_sym. exact F.
    + eapply D_eq; [apply D_const|]. rewrite inner_xy. cbn. ring.
Qed.
Lemma eq9_2_proved : eq9_2.
Proof.
  intros n adj V V' r v th dth t S NL VS [L H] D. pose proof (steered_is _ _ _ _ _ _ _ _ (loop_both _ _ _ _ _ _ _ _ S VS L)) as (A & B & E & F).
  apply (is_derive_ext (fun s => tanner1_heading.Vt n adj V (fun i => r i s) (fun i => v i s) (fun i => th i s))); [intros s; symmetry; apply Vt_is|].
  now apply (eq9_chain n adj V (both V') r v th dth t S (both_sym V')).
Qed.

(* agents on a line, all with the heading 0 *)
Definition on_line (X : nat -> R -> R) (i : nat) (t : R) : C := RtoC (X i t).
Definition zero_heading (i : nat) (t : R) : R := 0.
Definition push n (adj : graph) (V' : nat -> nat -> R -> R) (x : nat -> R) i : R :=
  - Sum n (fun j => if adj i j then V' i j (Rabs (x i - x j)) / Rabs (x i - x j) * (x i - x j) else 0).
Lemma Cmod_line x y : Cmod (RtoC x - RtoC y)%C = Rabs (x - y).
Proof. replace (RtoC x - RtoC y)%C with (RtoC (x - y)) by (apply injective_projections; cbn; ring). apply Cmod_R. Qed.
Lemma law_line n adj V' (X Y : nat -> R -> R) i t :
  law n adj V' (fun i j => zero_heading i t - zero_heading j t) (fun i => on_line X i t) (fun i => on_line Y i t) i = RtoC (push n adj V' (fun i => X i t) i).
Proof.
  unfold law, push, on_line, zero_heading.
  rewrite (Csum_ext n _ (fun j => RtoC (if adj i j then V' i j (Rabs (X i t - X j t)) / Rabs (X i t - X j t) * (X i t - X j t) else 0))).
  - rewrite Sum_zero; [|intros j _; destruct (adj i j); [unfold Rdiv|]; ring].
    unfold Csum. apply injective_projections; cbn; [ring|]. rewrite Sum_0. ring.
  - intros j _. destruct (adj i j); [|reflexivity]. rewrite Cmod_line. apply injective_projections; cbn; ring.
Qed.
Lemma line_velocity (x : R -> R) (t y : R) : is_derive x t y -> is_velocity (fun s => RtoC (x s)) t (RtoC y).
Proof. intros H. split; [exact H|exact (D_const 0 t)]. Qed.
Lemma line_headings n Y t : (forall i, (i < n)%nat -> 0 < Y i t) -> headings n (on_line Y) zero_heading t.
Proof.
  intros P i Hi. specialize (P i Hi). pose proof PI_RGT_0. unfold on_line, zero_heading. split; [|split; [|lra]].
  - intros E. injection E. lra.
  - rewrite Cmod_R, Rabs_pos_eq by lra. unfold expi. rewrite cos_0, sin_0. apply injective_projections; cbn; ring.
Qed.
Lemma line_closed n adj V V' X Y t :
  (forall i, (i < n)%nat -> is_derive (X i) t (Y i t) /\ 0 < Y i t /\ is_derive (Y i) t (push n adj V' (fun i => X i t) i)) ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> X i t <> X j t) ->
  (forall i j s, (i < n)%nat -> (j < n)%nat -> 0 < s -> is_derive (V i j) s (V' i j s)) -> closed n adj V V' (on_line X) (on_line Y) zero_heading t.
Proof.
  intros H N HV. split; [|apply line_headings; intros; now apply H]. intros i Hi. destruct (H i Hi) as (A & B & D).
  split; [now apply line_velocity|]. split; [rewrite law_line; now apply line_velocity|]. intros j Hj E. unfold on_line. rewrite Cmod_line.
  specialize (N i j Hi Hj E). split; [intros Q; injection Q; exact N|]. apply HV; try assumption. apply Rabs_pos_lt. lra.
Qed.
(* two agents at 2 t +- cos(2 t)/2 with V(s) = s^2: they meet at t = PI/4 *)
Definition sgn2 (i : nat) : R := match i with 0%nat => 1 | _ => - 1 end.
Definition spring_x (i : nat) (t : R) : R := 2 * t + sgn2 i * (cos (2 * t) / 2).
Definition spring_y (i : nat) (t : R) : R := 2 - sgn2 i * sin (2 * t).
Lemma spring_rates i t : is_derive (spring_x i) t (spring_y i t) /\ is_derive (spring_y i) t (- 2 * sgn2 i * cos (2 * t)).
Proof.
  unfold spring_x, spring_y. split.
  - eapply D_eq; [apply (D_plus (fun s => 2 * s) (fun s => sgn2 i * (cos (2 * s) / 2))); [apply D_scal, D_id|]|].
    + apply D_scal. apply (is_derive_ext (fun s => / 2 * cos (2 * s))); [intros; unfold Rdiv; Rring|]. apply D_scal, (D_cos (fun s => 2 * s)), D_scal, D_id.
    + change (2 * 1 + sgn2 i * (/ 2 * (- sin (2 * t) * (2 * 1))) = 2 - sgn2 i * sin (2 * t)). field.
  - eapply D_eq; [apply (D_minus (fun s => 2) (fun s => sgn2 i * sin (2 * s))); [apply D_const|]|].
    + apply D_scal. apply (D_sin (fun s => 2 * s)), D_scal, D_id.
    + ring.
Qed.
Lemma anyV_1_proved : anyV_1.
Proof.
  intros H. set (V := fun (i j : nat) s => s ^ 2). set (V' := fun (i j : nat) s => 2 * s).
  refine (H 2%nat complete V V' (on_line spring_x) (on_line spring_y) zero_heading (complete_connected 2) _ _ _ _ _ (PI / 4) 0%nat 1%nat _ _ _ _ _); try lia;
    try reflexivity; [intros i j s; reflexivity|..].
  - intros i j s Hs. split; [|unfold V; nra]. eapply D_eq; [apply (D_sqr (fun s => s)), D_id|unfold V'; ring].
  - intros i j c. exists (Rabs c + 1). intros s Hs. pose proof (Rle_abs c). pose proof (Rabs_pos c). unfold V. nra.
  - intros i j Hi Hj A E. unfold on_line in E. injection E. unfold spring_x. rewrite !Rmult_0_r, cos_0.
    destruct i as [|[|]], j as [|[|]]; try lia; try discriminate A; cbn; lra.
  - intros t _. split.
    + intros i Hi. destruct (spring_rates i t) as [A B]. split; [now apply line_velocity|]. intros N. rewrite law_line. apply line_velocity. eapply D_eq; [exact B|].
      unfold push, V'. destruct i as [|[|]]; [| |lia]; cbn [Sum].
      * specialize (N 0%nat 1%nat ltac:(lia) ltac:(lia) eq_refl). unfold complete. cbn [Nat.eqb negb].
        assert (P : Rabs (spring_x 0 t - spring_x 1 t) <> 0). { apply Rabs_no_R0. intros E. apply N. unfold on_line. f_equal. lra. }
        replace (2 * Rabs (spring_x 0 t - spring_x 1 t) / Rabs (spring_x 0 t - spring_x 1 t) * (spring_x 0 t - spring_x 1 t)) with (2 * (spring_x 0 t - spring_x 1 t)) by (field; exact P).
        unfold spring_x, sgn2. field.
      * specialize (N 1%nat 0%nat ltac:(lia) ltac:(lia) eq_refl). unfold complete. cbn [Nat.eqb negb].
        assert (P : Rabs (spring_x 1 t - spring_x 0 t) <> 0). { apply Rabs_no_R0. intros E. apply N. unfold on_line. f_equal. lra. }
        replace (2 * Rabs (spring_x 1 t - spring_x 0 t) / Rabs (spring_x 1 t - spring_x 0 t) * (spring_x 1 t - spring_x 0 t)) with (2 * (spring_x 1 t - spring_x 0 t)) by (field; exact P).
        unfold spring_x, sgn2. field.
    + apply line_headings. intros i _. unfold spring_y, sgn2. pose proof (SIN_bound (2 * t)). destruct i; lra.
  - pose proof PI_RGT_0. lra.
  - unfold on_line, spring_x. replace (2 * (PI / 4)) with (PI / 2) by field. rewrite cos_PI2. unfold sgn2. f_equal. field.
Qed.
(* two agents at 3 t +- sqrt(1 + 4 t^2)/2 with V(s) = 1/s^2: they part for ever *)
Definition part (t : R) := sqrt (1 + 4 * t ^ 2).
Definition part_x (i : nat) (t : R) : R := 3 * t + sgn2 i * (part t / 2).
Definition part_y (i : nat) (t : R) : R := 3 + sgn2 i * (2 * t / part t).
Lemma part_pos t : 0 < part t /\ part t * part t = 1 + 4 * t ^ 2.
Proof. assert (0 < 1 + 4 * t ^ 2) by nra. split; [now apply sqrt_lt_R0|]. unfold part. apply sqrt_sqrt. lra. Qed.
Lemma part_rate t : is_derive part t (4 * t / part t).
Proof. destruct (part_pos t) as [P Q]. unfold part in *. auto_derive; [nra|].
  replace (4 * (t * (t * 1))) with (4 * t ^ 2) by ring. field. lra. Qed.
Lemma part_rates i t : is_derive (part_x i) t (part_y i t) /\ is_derive (part_y i) t (sgn2 i * (2 / part t ^ 3)).
Proof.
  destruct (part_pos t) as [P Q]. unfold part_x, part_y. split.
  - eapply D_eq; [apply (D_plus (fun s => 3 * s) (fun s => sgn2 i * (part s / 2))); [apply D_scal, D_id|]|].
    + apply D_scal. apply (is_derive_ext (fun s => / 2 * part s)); [intros; unfold Rdiv; Rring|]. apply D_scal, part_rate.
    + field. lra.
  - eapply D_eq; [apply (D_plus (fun s => 3) (fun s => sgn2 i * (2 * s / part s))); [apply D_const|]|].
    + apply D_scal. apply (is_derive_ext (fun s => (2 * s) * / part s)); [intros; unfold Rdiv; Rring|].
      apply (D_mult (fun s => 2 * s) (fun s => / part s)); [apply D_scal, D_id|]. apply (is_derive_inv part); [apply part_rate|lra].
    + rewrite Rplus_0_l. f_equal. replace (2 / part t ^ 3) with (2 * (part t * part t - 4 * t ^ 2) / part t ^ 3) by (rewrite Q; field; lra). field. lra.
Qed.
Lemma part_apart i j t : (i < 2)%nat -> (j < 2)%nat -> complete i j = true -> part_x i t <> part_x j t.
Proof.
  intros Hi Hj A. destruct (part_pos t) as [P _]. unfold part_x. destruct i as [|[|]], j as [|[|]]; try lia; try discriminate A; cbn; lra.
Qed.
Lemma anyV_2_proved : anyV_2.
Proof.
  intros H. set (V := fun (i j : nat) s => / s ^ 2). set (V' := fun (i j : nat) s => - 2 / s ^ 3).
  assert (VD : forall i j s, 0 < s -> is_derive (V i j) s (V' i j s)).
  { intros i j s Hs. unfold V, V'. assert (0 < s ^ 2) by (apply pow_lt; lra). auto_derive; [repeat split; simpl in *; lra|field; lra]. }
  assert (VS : symmetric_V V) by (intros i j s; reflexivity).
  assert (VR : forall i j, repels (V i j) (V' i j)).
  { intros i j. split.
    - intros s Hs. split; [now apply VD|]. left. apply Rinv_0_lt_compat, pow_lt. lra.
    - intros c. pose proof (Rabs_pos c) as C0. pose proof (Rle_abs c) as C1. assert (q0 : 0 < / (Rabs c + 1)) by (apply Rinv_0_lt_compat; lra).
      assert (q1 : / (Rabs c + 1) <= 1) by (replace 1 with (/ 1) at 2 by apply Rinv_1; apply Rinv_le_contravar; lra).
      exists (/ (Rabs c + 1)). split; [exact q0|]. intros s [S0 S1]. apply Rlt_le_trans with (Rabs c + 1); [lra|]. unfold V.
      replace (Rabs c + 1) with (/ / (Rabs c + 1)) by (apply Rinv_inv). apply Rinv_le_contravar; [apply pow_lt; lra|]. nra. }
  destruct (H 2%nat complete V V' (on_line part_x) (on_line part_y) zero_heading (complete_connected 2) VS VR) as [B HB].
  - intros i j Hi Hj A E. unfold on_line in E. injection E. now apply part_apart.
  - intros t _. apply line_closed; [|intros; now apply part_apart|intros; now apply VD]. intros i Hi. destruct (part_rates i t) as [A B]. split; [exact A|].
    destruct (part_pos t) as [P Q]. split.
    + unfold part_y. assert (S : Rabs (2 * t / part t) <= 1).
      { unfold Rdiv. rewrite Rabs_mult, Rabs_inv, (Rabs_pos_eq (part t)) by lra. apply Rmult_le_reg_r with (part t); [lra|]. rewrite Rmult_assoc, Rinv_l, Rmult_1_r, Rmult_1_l by lra.
        apply Rabs_le. split; nra. }
      apply Rabs_le_between in S. destruct i; cbn; lra.
    + eapply D_eq; [exact B|]. unfold push, V'. destruct i as [|[|]]; [| |lia]; cbn [Sum]; unfold complete; cbn [Nat.eqb negb];
        unfold part_x, sgn2; [replace (3 * t + 1 * (part t / 2) - (3 * t + - 1 * (part t / 2))) with (part t) by field
        |replace (3 * t + - 1 * (part t / 2) - (3 * t + 1 * (part t / 2))) with (- part t) by field; rewrite Rabs_Ropp]; rewrite Rabs_pos_eq by lra; field; lra.
  - specialize (HB (Rabs B + 1) 0%nat 1%nat ltac:(pose proof (Rabs_pos B); lra) ltac:(lia) ltac:(lia)). unfold on_line in HB. rewrite Cmod_line in HB.
    set (t := Rabs B + 1) in *. destruct (part_pos t) as [P Q]. pose proof (Rle_abs B). pose proof (Rabs_pos B).
    replace (part_x 0 t - part_x 1 t) with (part t) in HB by (unfold part_x, sgn2; field). rewrite Rabs_pos_eq in HB by lra.
    assert (t <= part t); [|unfold t in *; lra]. unfold t in *. nra.
Qed.
(* a path of three agents: the ends meet *)
Lemma path3_connected : simple_connected 3 tanner1_examples.path3.
Proof.
  split; [intros a b; unfold tanner1_examples.path3; destruct (Nat.eqb a 1), (Nat.eqb b 1); reflexivity|].
  split; [intros a; unfold tanner1_examples.path3; destruct (Nat.eqb a 1); reflexivity|].
  assert (A : forall k, (k < 3)%nat -> clos_refl_trans nat (arc 3 tanner1_examples.path3) k 1%nat /\ clos_refl_trans nat (arc 3 tanner1_examples.path3) 1%nat k).
  { intros k Hk. destruct k as [|[|[|]]]; try lia; split; first [apply rt_refl|apply rt_step; repeat split; lia]. }
  intros a b Ha Hb. eapply rt_trans; [apply (A a Ha)|apply (A b Hb)].
Qed.
Lemma collision_1_proved : collision_1.
Proof.
  intros H. destruct (H 3%nat tanner1_examples.path3 0%nat 2%nat path3_connected ltac:(lia) ltac:(lia) ltac:(lia) 4) as [d [Hd P]].
  set (e := Rmin (d / 2) 1). assert (E : 0 < e <= 1 /\ e < d) by (unfold e; split; [split; [apply Rmin_glb_lt; lra|apply Rmin_r]|pose proof (Rmin_l (d / 2) 1); lra]).
  set (r := fun i => match i with 0%nat => RtoC 1 | 1%nat => RtoC 0 | _ => RtoC (1 + e) end).
  specialize (P r (fun _ => RtoC 0) (fun _ => 0)). 
  assert (X : 4 < Vt 3 tanner1_examples.path3 fig2 r (fun _ => RtoC 0) (fun _ => 0)).
  { apply P.
    - intros a b Ha Hb A. destruct a as [|[|[|]]], b as [|[|[|]]]; try lia; try discriminate A; unfold r; intros Q; injection Q; lra.
    - unfold r. intros Q. injection Q. lra.
    - unfold r. rewrite Cmod_line. rewrite Rabs_left; lra. }
  unfold Vt, Vi in X. cbn [Sum] in X. unfold tanner1_examples.path3, r in X. cbn [Nat.eqb negb andb orb] in X. rewrite !Cmod_line, Cmod_0 in X.
  replace (1 - 0) with 1 in X by ring. replace (0 - 1) with (- (1)) in X by ring. replace (0 - (1 + e)) with (- (1 + e)) in X by ring.
  replace (1 + e - 0) with (1 + e) in X by ring. rewrite !Rabs_Ropp, Rabs_R1, (Rabs_pos_eq (1 + e)) in X by lra.
  destruct fig2_shape as (_ & V2up & V21 & _). change (fig2 0 1) with V2 in X. change (fig2 1 0) with V2 in X. change (fig2 1 2) with V2 in X. change (fig2 2 1) with V2 in X.
  rewrite V21 in X. assert (Y : V2 (1 + e) <= 9 / 4); [|lra].
  assert (V2 2 <= 9 / 4).
  { unfold V2. replace (2 ^ 2) with (2 * 2) by ring. rewrite ln_mult by lra. assert (ln 2 < 1); [|lra].
    rewrite <- (ln_exp 1). apply ln_increasing; [lra|]. pose proof (exp_ineq1 1 ltac:(lra)). lra. }
  destruct (Req_dec e 1) as [->|N]; [replace (1 + 1) with 2 by ring; lra|]. pose proof (V2up (1 + e) 2 ltac:(lra)). lra.
Qed.

(* two linked agents at the distance 2 turn about one point, at the radii om0, om1, with the headings h and h - PI, until h is PI *)
Definition om : R := sqrt (PI ^ 2 / 16 + 3 / 4).
Definition radius (i : nat) : R := match i with 0%nat => 3 / 4 / (om ^ 2 + PI / 4 * om) | _ => - (3 / 4 / (om ^ 2 - PI / 4 * om)) end.
Definition turn (t : R) : R := PI / 2 + om * t.
Definition turn_r (i : nat) (t : R) : C := (radius i * sin (turn t), - (radius i * cos (turn t))).
Definition turn_v (i : nat) (t : R) : C := (om * radius i * cos (turn t), om * radius i * sin (turn t)).
Definition turn_th (i : nat) (t : R) : R := match i with 0%nat => turn t | _ => turn t - PI end.
Lemma om_facts : PI / 4 < om /\ om ^ 2 = PI ^ 2 / 16 + 3 / 4.
Proof.
  pose proof PI_RGT_0 as P. assert (E : om ^ 2 = PI ^ 2 / 16 + 3 / 4) by (unfold om; apply pow2_sqrt; pose proof (pow2_ge_0 PI); lra).
  split; [|exact E]. assert (0 <= om) by apply sqrt_pos. apply Rnot_le_lt. intros L. assert (om ^ 2 <= (PI / 4) ^ 2) by (apply pow_incr; lra). lra.
Qed.
Lemma radius_facts : 0 < radius 0 /\ radius 1 < 0 /\ radius 0 - radius 1 = 2 /\
  om ^ 2 * radius 0 = 3 / 4 - PI / 4 * om * radius 0 /\ om ^ 2 * radius 1 = - (3 / 4) + PI / 4 * om * radius 1.
Proof.
  destruct om_facts as [L E]. pose proof PI_RGT_0 as P. assert (A : 0 < om ^ 2 + PI / 4 * om) by nra. assert (B : 0 < om ^ 2 - PI / 4 * om) by nra. unfold radius.
  assert (I : 0 < 3 / 4 / (om ^ 2 + PI / 4 * om)) by (apply Rdiv_lt_0_compat; lra). assert (J : 0 < 3 / 4 / (om ^ 2 - PI / 4 * om)) by (apply Rdiv_lt_0_compat; lra).
  split; [exact I|]. split; [lra|]. split; [|split; field; lra].
  replace (3 / 4 / (om ^ 2 + PI / 4 * om) - - (3 / 4 / (om ^ 2 - PI / 4 * om))) with (3 / 2 / (om ^ 2 - PI ^ 2 / 16)) by (field; split; [lra|split; nra]).
  replace (om ^ 2 - PI ^ 2 / 16) with (3 / 4) by lra. field.
Qed.
Lemma turn_rate t : is_derive turn t om.
Proof. unfold turn. eapply D_eq; [apply (D_plus (fun s => PI / 2) (fun s => om * s)); [apply D_const|apply D_scal, D_id]|]. ring. Qed.
Lemma turn_th_rate i t : is_derive (turn_th i) t om.
Proof. destruct i; [apply turn_rate|]. eapply D_eq; [apply (D_minus turn (fun s => PI)); [apply turn_rate|apply D_const]|]. ring. Qed.
Lemma turn_velocity i t : is_velocity (turn_r i) t (turn_v i t).
Proof.
  split; cbn [fst snd turn_r turn_v].
  - eapply D_eq; [apply D_scal, (D_sin turn), turn_rate|]. ring.
  - eapply D_eq; [apply D_opp, D_scal, (D_cos turn), turn_rate|]. ring.
Qed.
Lemma turn_acceleration i t : is_velocity (turn_v i) t (- (om ^ 2 * radius i * sin (turn t)), om ^ 2 * radius i * cos (turn t)).
Proof.
  split; cbn [fst snd turn_v].
  - eapply D_eq; [apply D_scal, (D_cos turn), turn_rate|]. ring.
  - eapply D_eq; [apply D_scal, (D_sin turn), turn_rate|]. ring.
Qed.
Lemma turn_Cmod (a : R) t : Cmod (a * cos (turn t), a * sin (turn t)) = Rabs a.
Proof.
  unfold Cmod. cbn [fst snd]. replace ((a * cos (turn t)) ^ 2 + (a * sin (turn t)) ^ 2) with (Rsqr a * (Rsqr (sin (turn t)) + Rsqr (cos (turn t)))) by (unfold Rsqr; ring).
  rewrite sin2_cos2, Rmult_1_r. apply sqrt_Rsqr_abs.
Qed.
Lemma turn_distance t : Cmod (turn_r 0 t - turn_r 1 t)%C = 2 /\ Cmod (turn_r 1 t - turn_r 0 t)%C = 2.
Proof.
  destruct radius_facts as (_ & _ & R2 & _). assert (A : forall a, Cmod (a * sin (turn t), - (a * cos (turn t))) = Rabs a).
  { intros a. rewrite <- (turn_Cmod a t). unfold Cmod. cbn [fst snd]. f_equal. ring. }
  split.
  - replace (turn_r 0 t - turn_r 1 t)%C with (((radius 0 - radius 1) * sin (turn t), - ((radius 0 - radius 1) * cos (turn t))) : C) by (apply injective_projections; cbn; ring).
    rewrite A, R2, Rabs_pos_eq; lra.
  - replace (turn_r 1 t - turn_r 0 t)%C with ((- (radius 0 - radius 1) * sin (turn t), - (- (radius 0 - radius 1) * cos (turn t))) : C) by (apply injective_projections; cbn; ring).
    rewrite A, R2, Rabs_Ropp, Rabs_pos_eq; lra.
Qed.
Lemma turn_closed t : 0 < turn t < PI -> closed 2 complete fig2 fig2' turn_r turn_v turn_th t.
Proof.
  intros [T0 T1]. destruct radius_facts as (R0 & R1 & R2 & E0 & E1). destruct (turn_distance t) as [D0 D1]. destruct om_facts as [O0 _]. pose proof PI_RGT_0 as P.
  assert (F : forall i j, fig2' i j 2 = 3 / 4) by (intros; unfold fig2'; field).
  split; [intros i Hi; split; [apply turn_velocity|split]|].
  - replace (law _ _ _ _ _ _ _) with ((- (om ^ 2 * radius i * sin (turn t)), om ^ 2 * radius i * cos (turn t)) : C); [apply turn_acceleration|].
    unfold law, Csum. destruct i as [|[|]]; [| |lia]; cbn [Sum]; unfold complete; cbn [Nat.eqb negb]; rewrite ?D0, ?D1, ?F, ?E0, ?E1;
      unfold turn_r, turn_v, turn_th; (apply injective_projections; cbn [fst snd Cplus Cminus Copp Cmult RtoC Ci]).
    + replace (radius 1) with (radius 0 - 2) by lra. field.
    + replace (radius 1) with (radius 0 - 2) by lra. field.
    + replace (radius 0) with (radius 1 + 2) by lra. field.
    + replace (radius 0) with (radius 1 + 2) by lra. field.
  - intros j Hj A. assert (X : Cmod (turn_r i t - turn_r j t)%C = 2) by (destruct i as [|[|]], j as [|[|]]; try lia; try discriminate A; assumption). split.
    + intros E. rewrite E in X. replace (turn_r j t - turn_r j t)%C with (RtoC 0) in X by ring. rewrite Cmod_0 in X. lra.
    + rewrite X. apply (proj1 fig2_repels). lra.
  - intros i Hi. assert (X : Cmod (turn_v i t) = Rabs (om * radius i)) by exact (turn_Cmod (om * radius i) t). split; [|split].
    + intros E. rewrite E, Cmod_0 in X. symmetry in X. revert X. apply Rabs_no_R0. destruct i as [|[|]]; [| |lia]; nra.
    + rewrite X. destruct i as [|[|]]; [| |lia]; unfold turn_th, turn_v, expi.
      * rewrite Rabs_pos_eq by nra. apply injective_projections; cbn [fst snd Cmult RtoC]; ring.
      * rewrite Rabs_left by nra. replace (turn t - PI) with (- (PI - turn t)) by ring. rewrite cos_neg, sin_neg.
        rewrite Rtrigo_facts.cos_pi_minus, Rtrigo_facts.sin_pi_minus. apply injective_projections; cbn [fst snd Cmult RtoC]; ring.
    + unfold turn_th. destruct i; lra.
Qed.
Lemma eq7_1_proved : eq7_1.
Proof.
  intros H. pose proof PI_RGT_0 as P. destruct om_facts as [O0 _].
  assert (Loc : locally 0 (closed 2 complete fig2 fig2' turn_r turn_v turn_th)).
  { assert (e0 : 0 < / om) by (apply Rinv_0_lt_compat; lra). exists (mkposreal _ e0). intros t Ht. apply turn_closed. unfold ball in Ht. cbn in Ht.
    unfold AbsRing_ball, abs, minus, plus, opp in Ht. cbn in Ht.
    rewrite Ropp_0, Rplus_0_r in Ht. apply Rabs_lt_between in Ht. assert (X : om * / om = 1) by (apply Rinv_r; lra). unfold turn. pose proof PI2_1. split; nra. }
  specialize (H 2%nat complete turn_r turn_v turn_th 0 0%nat (complete_connected 2) ltac:(lia) Loc (ex_intro _ _ (turn_th_rate 0 0))).
  pose proof (is_derive_unique _ _ _ H) as U1. rewrite (is_derive_unique _ _ _ (turn_th_rate 0 0)) in U1.
  cbn [Sum] in U1. unfold complete in U1. cbn [Nat.eqb negb] in U1. rewrite (proj1 (turn_distance 0)) in U1. unfold turn_th in U1. lra.
Qed.
Lemma Vt_inv_1_proved : Vt_inv_1.
Proof.
  intros H. pose proof PI_RGT_0 as P. destruct om_facts as [O0 _]. assert (e0 : 0 < / om) by (apply Rinv_0_lt_compat; lra). assert (X : om * / om = 1) by (apply Rinv_r; lra).
  specialize (H 2%nat complete turn_r turn_v turn_th (/ om) (complete_connected 2)).
  assert (M : forall t, 0 <= t <= / om -> closed 2 complete fig2 fig2' turn_r turn_v turn_th t /\ forall i, (i < 2)%nat -> ex_derive (turn_th i) t).
  { intros t Ht. split; [|intros i _; eexists; apply turn_th_rate]. apply turn_closed. unfold turn. pose proof PI2_1. split; nra. }
  specialize (H M 0 (/ om) ltac:(lra) ltac:(lra)). unfold Vt, Vi in H. cbn [Sum] in H. unfold complete in H. cbn [Nat.eqb negb] in H.
  rewrite !(proj1 (turn_distance _)), !(proj2 (turn_distance _)) in H.
  assert (Y : forall i t, Cmod (turn_v i t) = Rabs (om * radius i)) by (intros i t; exact (turn_Cmod (om * radius i) t)). rewrite !Y in H.
  unfold turn_th, turn in H. rewrite X, Rmult_0_r in H. nra.
Qed.

(* ---- an agent swings about its centre for ever: a'' = 2/a^3 - 2/a, by quadrature ---- *)
Lemma strictly_up (f f' : R -> R) : (forall x, is_derive f x (f' x)) -> (forall x, 0 < f' x) -> forall x y, x < y -> f x < f y.
Proof. intros D P x y L. destruct (MVT_le f f' x y ltac:(lra) ltac:(intros; apply D)) as (c & _ & E). specialize (P c). nra. Qed.
Lemma inverse (f f' : R -> R) : (forall x, is_derive f x (f' x)) -> (forall x, 0 < f' x) -> (forall y, exists x, f x = y) ->
  exists h : R -> R, (forall y, f (h y) = y) /\ (forall x, h (f x) = x) /\ forall y, is_derive h y (/ f' (h y)).
Proof.
  intros D P S. pose proof (strictly_up f f' D P) as U. assert (U' : forall x y, f x < f y -> x < y).
  { intros x y L. destruct (Rtotal_order x y) as [A|[A|A]]; [exact A|subst; lra|apply U in A; lra]. }
  set (h := fun y => real (Lub_Rbar (fun x => f x <= y))). assert (HF : forall x, h (f x) = x).
  { intros x. unfold h. rewrite (is_lub_Rbar_unique (fun z => f z <= f x) (Finite x)); [reflexivity|]. split.
    - intros z Hz. cbn. apply Rnot_lt_le. intros L. apply U in L. lra.
    - intros b Hb. apply (Hb x). lra. }
  assert (FH : forall y, f (h y) = y) by (intros y; destruct (S y) as [x <-]; now rewrite HF).
  exists h. split; [exact FH|]. split; [exact HF|]. intros y. set (x := h y). assert (Y : f x = y) by apply FH. clearbody x.
  apply is_derive_Reals. intros e He. set (l := f' x). pose proof (P x) as L0. fold l in L0.
  set (eta := Rmin (l / 2) (e * l ^ 2 / 4)). assert (E0 : 0 < eta) by (apply Rmin_glb_lt; [lra|]; assert (0 < l ^ 2) by (apply pow_lt; lra); nra).
  pose proof (D x) as Dx. apply is_derive_Reals in Dx. destruct (Dx eta E0) as [d Hd]. pose proof (cond_pos d) as d0.
  set (m := Rmin (f (x + d) - y) (y - f (x - d))). assert (m0 : 0 < m).
  { apply Rmin_glb_lt; [pose proof (U x (x + d) ltac:(lra))|pose proof (U (x - d) x ltac:(lra))]; lra. }
  exists (mkposreal m m0). intros k K0 Kd. cbn in Kd. apply Rabs_lt_between in Kd. pose proof (Rmin_l (f (x + d) - y) (y - f (x - d))). pose proof (Rmin_r (f (x + d) - y) (y - f (x - d))).
  fold m in H, H0. set (x' := h (y + k)). assert (Y' : f x' = y + k) by apply FH. replace (h y) with x by (rewrite <- Y; symmetry; apply HF).
  assert (X1 : x' < x + d) by (apply U'; lra). assert (X2 : x - d < x') by (apply U'; lra).
  assert (N : x' - x <> 0) by (intros Z; apply K0; replace x' with x in Y' by lra; lra).
  specialize (Hd (x' - x) N ltac:(apply Rabs_def1; lra)). replace (x + (x' - x)) with x' in Hd by ring. fold l in Hd. rewrite Y, Y' in Hd. replace (y + k - y) with k in Hd by ring.
  set (q := k / (x' - x)) in Hd. assert (Q : Rabs (q - l) < l / 2 /\ Rabs (q - l) < e * l ^ 2 / 4).
  { split; (eapply Rlt_le_trans; [exact Hd|]); [apply Rmin_l|apply Rmin_r]. }
  destruct Q as [Q1 Q2]. apply Rabs_lt_between in Q1. replace ((x' - x) / k) with (/ q) by (unfold q; field; split; assumption).
  replace (/ q - / l) with (- (q - l) * (/ q * / l)) by (field; lra). rewrite Rabs_mult, Rabs_Ropp, (Rabs_pos_eq (/ q * / l)).
  2: { apply Rmult_le_pos; left; apply Rinv_0_lt_compat; lra. }
  apply Rle_lt_trans with (Rabs (q - l) * (2 / l * / l)).
  - apply Rmult_le_compat_l; [apply Rabs_pos|]. apply Rmult_le_compat_r; [left; apply Rinv_0_lt_compat; lra|]. replace (2 / l) with (/ (l / 2)) by (field; lra).
    apply Rinv_le_contravar; lra.
  - apply Rle_lt_trans with (e * l ^ 2 / 4 * (2 / l * / l)); [|replace (e * l ^ 2 / 4 * (2 / l * / l)) with (e / 2) by (field; lra); lra].
    apply Rmult_le_compat_r; [|lra]. assert (0 < / l) by (apply Rinv_0_lt_compat; lra). apply Rmult_le_pos; [unfold Rdiv; nra|lra].
Qed.
(* with s^2 = e^y: V - 1 = W(y) = e^-y + y - 1 = g(y)^2 / 2 *)
Definition W (y : R) := exp (- y) + y - 1.
Definition k2 (y : R) := if Req_EM_T y 0 then 1 else 2 * W y / y ^ 2.
Definition k1 (y : R) := if Req_EM_T y 0 then 1 else (1 - exp (- y)) / y.
Lemma exp_opp_rate t : is_derive (fun s => exp (- s)) t (- exp (- t)).
Proof. eapply D_eq; [apply (D_comp exp (fun s => - s)); [apply is_derive_exp|apply D_opp, D_id]|]. ring. Qed.
Lemma W_rate y : is_derive W y (1 - exp (- y)).
Proof.
  unfold W. eapply D_eq; [apply (D_minus (fun s => exp (- s) + s) (fun s => 1)); [apply (D_plus (fun s => exp (- s)) (fun s => s)); [apply exp_opp_rate|apply D_id]|apply D_const]|]. ring.
Qed.
(* a function with derivative of the sign of y is above its value at 0 *)
Lemma above (F F' : R -> R) y : (forall x, is_derive F x (F' x)) -> (forall x, 0 <= x -> 0 <= F' x) -> (forall x, x <= 0 -> F' x <= 0) -> F 0 <= F y.
Proof.
  intros D P N. destruct (Rle_lt_dec 0 y) as [L|L].
  - destruct (MVT_le F F' 0 y L ltac:(intros; apply D)) as (c & C & E). specialize (P c ltac:(lra)). nra.
  - destruct (MVT_le F F' y 0 ltac:(lra) ltac:(intros; apply D)) as (c & C & E). specialize (N c ltac:(lra)). nra.
Qed.
Lemma exp_signs x : (0 <= x -> exp (- x) <= 1 /\ 1 <= exp x) /\ (x <= 0 -> 1 <= exp (- x) /\ exp x <= 1).
Proof. pose proof (exp_ineq1_le x). pose proof (exp_ineq1_le (- x)). assert (exp x * exp (- x) = 1) by (rewrite <- exp_plus, Rplus_opp_r; apply exp_0). split; intros; split; nra. Qed.
(* W is between y^2/2 and e^-y y^2/2 *)
Lemma W_between y : (0 <= y -> y ^ 2 / 2 * exp (- y) <= W y <= y ^ 2 / 2) /\ (y <= 0 -> y ^ 2 / 2 <= W y <= y ^ 2 / 2 * exp (- y)).
Proof.
  assert (A : forall x, 0 <= W x). { intros x. unfold W. pose proof (exp_ineq1_le (- x)). lra. }
  assert (D1 : forall x, is_derive (fun x => x ^ 2 / 2 - W x) x (W x)).
  { intros x. eapply D_eq; [apply (D_minus (fun x => x ^ 2 / 2) W); [|apply W_rate]|].
    - apply (is_derive_ext (fun x => / 2 * x ^ 2)); [intros; unfold Rdiv; Rring|]. apply D_scal, (D_sqr (fun s => s)), D_id.
    - unfold W. field. }
  assert (D2 : forall x, is_derive (fun x => W x - x ^ 2 / 2 * exp (- x)) x (1 - exp (- x) - x * exp (- x) + x ^ 2 / 2 * exp (- x))).
  { intros x. eapply D_eq; [apply (D_minus W (fun x => x ^ 2 / 2 * exp (- x))); [apply W_rate|apply (D_mult (fun x => x ^ 2 / 2) (fun x => exp (- x))); [|apply exp_opp_rate]]|].
    - apply (is_derive_ext (fun x => / 2 * x ^ 2)); [intros; unfold Rdiv; Rring|]. apply D_scal, (D_sqr (fun s => s)), D_id.
    - cbv beta. field. }
  assert (P2 : forall x, 0 <= 1 - exp (- x) - x * exp (- x) + x ^ 2 / 2 * exp (- x)).
  { intros x. pose proof (exp_ineq1_le x). assert (E : exp x * exp (- x) = 1) by (rewrite <- exp_plus, Rplus_opp_r; apply exp_0). pose proof (exp_pos (- x)). pose proof (pow2_ge_0 x).
    replace (1 - exp (- x) - x * exp (- x) + x ^ 2 / 2 * exp (- x)) with (exp x * exp (- x) - exp (- x) - x * exp (- x) + x ^ 2 / 2 * exp (- x)) by (rewrite E; ring).
    replace (exp x * exp (- x) - exp (- x) - x * exp (- x) + x ^ 2 / 2 * exp (- x)) with ((exp x - 1 - x + x ^ 2 / 2) * exp (- x)) by ring. apply Rmult_le_pos; lra. }
  assert (W0 : W 0 = 0) by (unfold W; rewrite Ropp_0, exp_0; ring). split; intros L.
  - destruct (MVT_le _ _ 0 y L (fun x _ => D1 x)) as (c & C & E). destruct (MVT_le _ _ 0 y L (fun x _ => D2 x)) as (c' & C' & E'). cbv beta in E, E'.
    rewrite W0 in E, E'. pose proof (A c). pose proof (P2 c'). nra.
  - destruct (MVT_le _ _ y 0 L (fun x _ => D1 x)) as (c & C & E). destruct (MVT_le _ _ y 0 L (fun x _ => D2 x)) as (c' & C' & E'). cbv beta in E, E'.
    rewrite W0 in E, E'. pose proof (A c). pose proof (P2 c'). nra.
Qed.
Lemma k_between y : (exp (- Rabs y) <= k2 y <= exp (Rabs y)) /\ (exp (- Rabs y) <= k1 y <= exp (Rabs y)).
Proof.
  unfold k2, k1. destruct (Req_EM_T y 0) as [->|N]; [rewrite Rabs_R0, Ropp_0, exp_0; lra|]. destruct (W_between y) as [A B].
  assert (E : exp y * exp (- y) = 1) by (rewrite <- exp_plus, Rplus_opp_r; apply exp_0). pose proof (exp_ineq1_le y) as I1. pose proof (exp_ineq1_le (- y)) as I2.
  pose proof (exp_pos y). pose proof (exp_pos (- y)). assert (Y2 : 0 < y ^ 2) by now apply pow2_gt_0.
  assert (Q : forall c, 2 * W y / y ^ 2 <= c <-> 2 * W y <= c * y ^ 2).
  { intros c. split; intros H1.
    - apply (Rmult_le_compat_r (y ^ 2)) in H1; [|lra]. replace (2 * W y / y ^ 2 * y ^ 2) with (2 * W y) in H1 by (field; lra). exact H1.
    - apply Rmult_le_reg_r with (y ^ 2); [lra|]. replace (2 * W y / y ^ 2 * y ^ 2) with (2 * W y) by (field; lra). exact H1. }
  assert (Q' : forall c, c <= 2 * W y / y ^ 2 <-> c * y ^ 2 <= 2 * W y).
  { intros c. split; intros H1.
    - apply (Rmult_le_compat_r (y ^ 2)) in H1; [|lra]. replace (2 * W y / y ^ 2 * y ^ 2) with (2 * W y) in H1 by (field; lra). exact H1.
    - apply Rmult_le_reg_r with (y ^ 2); [lra|]. replace (2 * W y / y ^ 2 * y ^ 2) with (2 * W y) by (field; lra). exact H1. }
  rewrite Q, Q'. destruct (exp_signs y) as [S1 S2]. destruct (Rtotal_order y 0) as [L|[L|L]]; [|contradiction|].
  - rewrite Rabs_left by exact L. rewrite Ropp_involutive. destruct (B ltac:(lra)) as [B1 B2]. destruct (S2 ltac:(lra)) as [S3 S4]. split; [split; nra|].
    split; (apply Rmult_le_reg_r with (- y); [lra|]); replace ((1 - exp (- y)) / y * - y) with (exp (- y) - 1) by (field; lra); nra.
  - rewrite Rabs_pos_eq by lra. destruct (A ltac:(lra)) as [B1 B2]. destruct (S1 ltac:(lra)) as [S3 S4]. split; [split; nra|].
    split; (apply Rmult_le_reg_r with y; [lra|]); replace ((1 - exp (- y)) / y * y) with (1 - exp (- y)) by (field; lra); nra.
Qed.
Lemma squeeze_0 (k : R -> R) : k 0 = 1 -> (forall y, exp (- Rabs y) <= k y <= exp (Rabs y)) -> continuity_pt k 0.
Proof.
  intros K0 B e He. assert (C : continuity_pt exp 0) by (apply derivable_continuous_pt, derivable_pt_exp). destruct (C e He) as (d & d0 & Hd). exists d. split; [exact d0|].
  assert (X : forall z, Rabs z < d -> Rabs (exp z - 1) < e).
  { intros z Hz. destruct (Req_dec z 0) as [->|Z]; [rewrite exp_0, Rminus_eq_0, Rabs_R0; exact He|]. specialize (Hd z). unfold dist in Hd. cbn in Hd. unfold R_dist in Hd.
    rewrite exp_0, Rminus_0_r in Hd. apply Hd. split; [split; [exact I|congruence]|exact Hz]. }
  intros y [_ Hy]. unfold dist in *. cbn in *. unfold R_dist in *. rewrite Rminus_0_r in Hy. rewrite K0. specialize (B y).
  pose proof (X (Rabs y) ltac:(rewrite Rabs_Rabsolu; exact Hy)) as X1. pose proof (X (- Rabs y) ltac:(rewrite Rabs_Ropp, Rabs_Rabsolu; exact Hy)) as X2.
  apply Rabs_lt_between in X1. apply Rabs_lt_between in X2. apply Rabs_def1; lra.
Qed.
Lemma continuity_ext_loc (f h : R -> R) x d : 0 < d -> (forall z, Rabs (z - x) < d -> f z = h z) -> continuity_pt f x -> continuity_pt h x.
Proof.
  intros d0 E C e He. destruct (C e He) as (d' & d'0 & Hd). exists (Rmin d d'). split; [now apply Rmin_glb_lt|]. intros z [Z1 Z2].
  unfold dist in *. cbn in *. unfold R_dist in *. pose proof (Rmin_l d d'). pose proof (Rmin_r d d'). rewrite <- !E; [apply Hd; split; [exact Z1|lra]|rewrite Rminus_eq_0, Rabs_R0; lra|lra].
Qed.
Lemma k_continuous y : continuity_pt k2 y /\ continuity_pt k1 y.
Proof.
  destruct (Req_dec y 0) as [->|N].
  - split; apply squeeze_0; try (intros; apply k_between); unfold k2, k1; destruct (Req_EM_T 0 0); congruence.
  - assert (A : 0 < Rabs y) by now apply Rabs_pos_lt.
    assert (Z : forall z, Rabs (z - y) < Rabs y -> z <> 0). { intros z Hz ->. rewrite Rminus_0_l, Rabs_Ropp in Hz. lra. }
    assert (Y2 : y ^ 2 <> 0) by now apply pow_nonzero.
    split.
    + apply (continuity_ext_loc (fun y => 2 * W y / y ^ 2) k2 y (Rabs y) A).
      * intros z Hz. unfold k2. destruct (Req_EM_T z 0) as [E|_]; [now apply Z in Hz|reflexivity].
      * apply derivable_continuous_pt, ex_derive_Reals_0. unfold W. auto_derive. simpl in Y2. assumption.
    + apply (continuity_ext_loc (fun y => (1 - exp (- y)) / y) k1 y (Rabs y) A).
      * intros z Hz. unfold k1. destruct (Req_EM_T z 0) as [E|_]; [now apply Z in Hz|reflexivity].
      * apply derivable_continuous_pt, ex_derive_Reals_0. auto_derive. exact N.
Qed.

Definition gg (y : R) := y * sqrt (k2 y).
Definition gg' (y : R) := k1 y / sqrt (k2 y).
Lemma k_pos y : 0 < k2 y /\ 0 < k1 y.
Proof. destruct (k_between y) as [[A _] [B _]]. pose proof (exp_pos (- Rabs y)). split; lra. Qed.
Lemma root_continuous y : continuity_pt (fun y => sqrt (k2 y)) y.
Proof. apply (continuity_pt_comp k2 sqrt); [apply k_continuous|]. apply continuity_pt_sqrt. left. apply k_pos. Qed.
Lemma root_pos y : 0 < sqrt (k2 y). Proof. apply sqrt_lt_R0, k_pos. Qed.
Lemma gg_sqr y : gg y ^ 2 = 2 * W y.
Proof.
  unfold gg. rewrite Rpow_mult_distr, pow2_sqrt by (left; apply k_pos). unfold k2. destruct (Req_EM_T y 0) as [->|N]; [|field; exact N].
  unfold W. rewrite Ropp_0, exp_0. ring.
Qed.
Lemma gg_rate y : is_derive gg y (gg' y).
Proof.
  destruct (Rtotal_order y 0) as [L|[->|L]].
  - assert (N : k1 y = (1 - exp (- y)) / y) by (unfold k1; destruct (Req_EM_T y 0); [lra|reflexivity]).
    assert (S : forall z, z < 0 -> sqrt (2 * W z) = - gg z).
    { intros z Hz. rewrite <- gg_sqr. replace (gg z ^ 2) with ((- gg z) ^ 2) by ring. apply sqrt_pow2. unfold gg. pose proof (root_pos z). nra. }
    assert (W0 : 0 < 2 * W y). { rewrite <- gg_sqr. apply pow2_gt_0. unfold gg. pose proof (root_pos y). nra. }
    apply (is_derive_ext_loc (fun z => - sqrt (2 * W z))).
    + assert (d0 : 0 < - y) by lra. exists (mkposreal _ d0). intros z Hz. unfold ball in Hz. cbn in Hz. unfold AbsRing_ball, abs, minus, plus, opp in Hz. cbn in Hz.
      apply Rabs_lt_between in Hz. rewrite S by lra. Rring.
    + eapply D_eq; [apply D_opp, (D_comp sqrt (fun z => 2 * W z)); [apply is_derive_Reals, derivable_pt_lim_sqrt; exact W0|apply D_scal, W_rate]|].
      rewrite S by exact L. unfold gg', gg. rewrite N. pose proof (root_pos y). field. split; lra.
  - apply is_derive_Reals. intros e He. assert (K0 : k2 0 = 1) by (unfold k2; destruct (Req_EM_T 0 0); congruence).
    assert (K1 : k1 0 = 1) by (unfold k1; destruct (Req_EM_T 0 0); congruence). destruct (root_continuous 0 e He) as (d & d0 & Hd).
    exists (mkposreal d d0). intros k N Hk. cbn in Hk. unfold gg, gg'. rewrite K1, K0, sqrt_1, Rplus_0_l, Rmult_0_l, Rminus_0_r.
    replace (k * sqrt (k2 k) / k - 1 / 1) with (sqrt (k2 k) - 1) by (field; exact N). specialize (Hd k). unfold dist in Hd. cbn in Hd. unfold R_dist in Hd.
    rewrite K0, sqrt_1, Rminus_0_r in Hd. apply Hd. split; [split; [exact I|congruence]|exact Hk].
  - assert (N : k1 y = (1 - exp (- y)) / y) by (unfold k1; destruct (Req_EM_T y 0); [lra|reflexivity]).
    assert (S : forall z, 0 < z -> sqrt (2 * W z) = gg z).
    { intros z Hz. rewrite <- gg_sqr. apply sqrt_pow2. unfold gg. pose proof (root_pos z). nra. }
    assert (W0 : 0 < 2 * W y). { rewrite <- gg_sqr. apply pow2_gt_0. unfold gg. pose proof (root_pos y). nra. }
    apply (is_derive_ext_loc (fun z => sqrt (2 * W z))).
    + exists (mkposreal _ L). intros z Hz. unfold ball in Hz. cbn in Hz. unfold AbsRing_ball, abs, minus, plus, opp in Hz. cbn in Hz.
      apply Rabs_lt_between in Hz. rewrite S by lra. reflexivity.
    + eapply D_eq; [apply (D_comp sqrt (fun z => 2 * W z)); [apply is_derive_Reals, derivable_pt_lim_sqrt; exact W0|apply D_scal, W_rate]|].
      rewrite S by exact L. unfold gg', gg. rewrite N. pose proof (root_pos y). field. split; lra.
Qed.
Lemma gg'_pos y : 0 < gg' y. Proof. apply Rdiv_lt_0_compat; [apply k_pos|apply root_pos]. Qed.
Lemma gg'_continuous y : continuity_pt gg' y.
Proof. apply continuity_pt_div; [apply k_continuous|apply root_continuous|apply Rgt_not_eq, root_pos]. Qed.
Lemma derive_continuous (f f' : R -> R) : (forall x, is_derive f x (f' x)) -> forall x, continuity_pt f x.
Proof. intros D x. apply derivable_continuous_pt, ex_derive_Reals_0. eexists. apply D. Qed.
Lemma gg_onto u : exists y, gg y = u.
Proof.
  pose proof (pow2_ge_0 u) as U2. set (b := u ^ 2 / 2 + 1). assert (B : u <= gg b).
  { assert (Q : u ^ 2 <= gg b ^ 2) by (rewrite gg_sqr; unfold W, b; pose proof (exp_pos (- (u ^ 2 / 2 + 1))); lra).
    assert (0 <= gg b) by (unfold gg; pose proof (root_pos b); unfold b in *; nra).
    apply Rnot_lt_le. intros L. nra. }
  assert (A : gg (- Rabs u) <= u).
  { pose proof (Rabs_pos u) as P. destruct (W_between (- Rabs u)) as [_ Q]. specialize (Q ltac:(lra)). destruct Q as [Q _].
    assert (G : (Rabs u) ^ 2 <= gg (- Rabs u) ^ 2) by (rewrite gg_sqr; replace (Rabs u ^ 2) with ((- Rabs u) ^ 2) by ring; lra).
    assert (gg (- Rabs u) <= 0) by (unfold gg; pose proof (root_pos (- Rabs u)); nra). pose proof (Rle_abs (- u)) as R1. rewrite Rabs_Ropp in R1. apply Rnot_lt_le. intros L. nra. }
  destruct (IVT_gen gg (- Rabs u) b u) as (y & _ & Y); [intros x; apply (derive_continuous gg gg' gg_rate)| |now exists y].
  rewrite Rmin_left, Rmax_right by lra. lra.
Qed.
Lemma steep_onto (f f' : R -> R) c : 0 < c -> (forall x, is_derive f x (f' x)) -> (forall x, c <= f' x) -> forall y, exists x, f x = y.
Proof.
  intros c0 D P y. set (m := Rabs (y - f 0) / c). assert (M : 0 <= m) by (apply Rmult_le_pos; [apply Rabs_pos|left; now apply Rinv_0_lt_compat]).
  assert (CM : c * m = Rabs (y - f 0)) by (unfold m; field; lra). pose proof (Rle_abs (y - f 0)) as A1. pose proof (Rle_abs (- (y - f 0))) as A2. rewrite Rabs_Ropp in A2.
  destruct (MVT_le f f' 0 m M ltac:(intros; apply D)) as (c1 & _ & E1). destruct (MVT_le f f' (- m) 0 ltac:(lra) ltac:(intros; apply D)) as (c2 & _ & E2).
  pose proof (P c1). pose proof (P c2). destruct (IVT_gen f (- m) m y) as (x & _ & X); [intros x; apply (derive_continuous f f' D)| |now exists x].
  assert (f (- m) <= y) by nra. assert (y <= f m) by nra. rewrite Rmin_left, Rmax_right by lra. lra.
Qed.
Lemma swing_exists y0 : 0 < y0 -> exists a b : R -> R,
  (forall t, 0 < a t /\ is_derive a t (b t) /\ is_derive b t (- fig2' 0 0 (a t)) /\ b t ^ 2 <= 2 * W y0) /\ a 0 = exp (y0 / 2) /\ b 0 = 0 /\
  forall T, (exists t, T <= t /\ a t = 1) /\ exists t, T <= t /\ a t = a 0.
Proof.
  intros Y0. set (A := gg y0). assert (A0 : 0 < A) by (unfold A, gg; pose proof (root_pos y0); now apply Rmult_lt_0_compat).
  destruct (inverse gg gg' gg_rate gg'_pos gg_onto) as (h & GH & HG & Dh).
  assert (Ch : forall u, continuity_pt h u) by (intros u; apply (derive_continuous h (fun y => / gg' (h y)) Dh)).
  set (Ga := fun u => 2 * gg' (h u) * exp (- (h u / 2))).
  assert (Gp : forall u, 0 < Ga u) by (intros u; unfold Ga; pose proof (gg'_pos (h u)); pose proof (exp_pos (- (h u / 2))); apply Rmult_lt_0_compat; lra).
  assert (Gc : forall u, continuity_pt Ga u).
  { intros u. apply continuity_pt_mult.
    - apply continuity_pt_mult; [apply continuity_pt_const; intros ? ?; reflexivity|]. apply (continuity_pt_comp h gg'); [apply Ch|apply gg'_continuous].
    - apply (continuity_pt_comp h (fun y => exp (- (y / 2)))); [apply Ch|]. apply derivable_continuous_pt, ex_derive_Reals_0. auto_derive. exact I. }
  destruct (continuity_ab_maj Ga (- A) A ltac:(lra) ltac:(intros; apply Gc)) as (Mx & HM & _). set (c := / Ga Mx). assert (c0 : 0 < c) by (apply Rinv_0_lt_compat, Gp).
  set (p := fun phi => / Ga (A * sin phi)). assert (Pc : forall phi, continuous p phi).
  { intros phi. apply continuity_pt_filterlim. apply (continuity_pt_inv (fun phi => Ga (A * sin phi))); [|apply Rgt_not_eq, Gp].
    apply (continuity_pt_comp (fun phi => A * sin phi) Ga); [apply derivable_continuous_pt, ex_derive_Reals_0; auto_derive; exact I|apply Gc]. }
  assert (Pl : forall phi, c <= p phi).
  { intros phi. apply Rinv_le_contravar; [apply Gp|]. apply HM. pose proof (SIN_bound phi). nra. }
  set (T := (fun phi => RInt p 0 phi) : R -> R). assert (DT : forall phi, is_derive T phi (p phi)).
  { intros phi. apply (is_derive_RInt p T 0 phi); [|apply Pc]. apply filter_forall. intros x.
    apply (@RInt_correct R_CompleteNormedModule), (@ex_RInt_continuous R_CompleteNormedModule). intros; apply Pc. }
  assert (T0 : T 0 = 0) by (unfold T; rewrite RInt_point; reflexivity).
  destruct (inverse T p DT (fun x => Rlt_le_trans _ _ _ c0 (Pl x)) (steep_onto T p c c0 DT Pl)) as (Ph & TP & PT & DP).
  assert (Tl : forall phi, 0 <= phi -> c * phi <= T phi).
  { intros phi L. destruct (MVT_le T p 0 phi L ltac:(intros; apply DT)) as (z & _ & E). pose proof (Pl z). rewrite T0 in E. nra. }
  assert (Dphi : forall t, is_derive Ph t (Ga (A * sin (Ph t)))).
  { intros t. eapply D_eq; [apply DP|]. unfold p. apply Rinv_inv. }
  set (s := T (PI / 2)). set (Y := fun t => h (A * sin (Ph (t + s)))). set (a := fun t => exp (Y t / 2)). set (b := fun t => A * cos (Ph (t + s))).
  assert (Ds : forall t, is_derive (fun t => Ph (t + s)) t (Ga (A * sin (Ph (t + s))))).
  { intros t. eapply D_eq; [apply (D_comp Ph (fun t => t + s)); [apply Dphi|apply (D_plus (fun t => t) (fun _ => s)); [apply D_id|apply D_const]]|]. ring. }
  assert (DY : forall t, is_derive Y t (2 * exp (- (Y t / 2)) * b t)).
  { intros t. unfold Y. eapply D_eq; [apply (D_comp h (fun t => A * sin (Ph (t + s)))); [apply Dh|apply D_scal, (D_sin (fun t => Ph (t + s))), Ds]|].
    unfold Ga, b. pose proof (gg'_pos (h (A * sin (Ph (t + s))))). field. lra. }
  assert (XE : forall t, a t * exp (- (Y t / 2)) = 1) by (intros t; unfold a; rewrite <- exp_plus, Rplus_opp_r; apply exp_0).
  exists a, b. split; [|split].
  - intros t. split; [apply exp_pos|]. split; [|split].
    + unfold a. eapply D_eq; [apply (D_comp exp (fun t => Y t / 2)); [apply is_derive_exp|apply (is_derive_ext (fun t => / 2 * Y t)); [intros; unfold Rdiv; Rring|apply D_scal, DY]]|].
      fold (a t). replace (a t * (/ 2 * (2 * exp (- (Y t / 2)) * b t))) with (a t * exp (- (Y t / 2)) * b t) by field. rewrite XE. ring.
    + unfold b at 1. eapply D_eq; [apply D_scal, (D_cos (fun t => Ph (t + s))), Ds|]. set (u := A * sin (Ph (t + s))). assert (U : u = gg (Y t)) by (unfold Y; fold u; now rewrite GH).
      replace (A * (- sin (Ph (t + s)) * Ga u)) with (- u * Ga u) by (unfold u; ring). unfold Ga. change (h u) with (Y t). rewrite U. set (y := Y t) in *.
      replace (- gg y * (2 * gg' y * exp (- (y / 2)))) with (- 2 * (gg y * gg' y) * exp (- (y / 2))) by ring.
      assert (K : gg y * gg' y = 1 - exp (- y)).
      { unfold gg, gg'. pose proof (root_pos y). replace (y * sqrt (k2 y) * (k1 y / sqrt (k2 y))) with (y * k1 y) by (field; lra). unfold k1.
        destruct (Req_EM_T y 0) as [->|N]; [rewrite Ropp_0, exp_0; ring|field; exact N]. }
      rewrite K. assert (AT : a t = exp (y / 2)) by reflexivity. assert (E1 : exp (- (y / 2)) = / exp (y / 2)) by apply exp_Ropp.
      assert (E2 : exp (- y) = / exp (y / 2) * / exp (y / 2)) by (rewrite <- !exp_Ropp, <- exp_plus; f_equal; field). unfold fig2'. rewrite AT, E1, E2. pose proof (exp_pos (y / 2)). field. lra.
    + unfold b. rewrite <- gg_sqr. fold A. rewrite Rpow_mult_distr. pose proof (COS_bound (Ph (t + s))). assert (cos (Ph (t + s)) ^ 2 <= 1) by nra. assert (0 < A ^ 2) by now apply pow_lt. nra.
  - unfold a, Y, s. rewrite Rplus_0_l, PT, sin_PI2, Rmult_1_r. unfold A. now rewrite HG.
  - split; [unfold b, s; rewrite Rplus_0_l, PT, cos_PI2; ring|]. intros T1. assert (PP := PI_RGT_0). destruct (nfloor_ex (Rabs ((T1 + s) / c))) as (n & _ & Hn); [apply Rabs_pos|].
    assert (BIG : forall q, 0 <= q -> T1 <= T (q + 2 * INR (S n) * PI) - s).
    { intros q Q. specialize (Tl (q + 2 * INR (S n) * PI)). rewrite S_INR in *. pose proof (Rle_abs ((T1 + s) / c)). assert (N0 := pos_INR n).
      assert (F : (T1 + s) / c <= q + 2 * (INR n + 1) * PI) by (pose proof PI2_1; nra). apply (Rmult_le_compat_l c) in F; [|lra].
      replace (c * ((T1 + s) / c)) with (T1 + s) in F by (field; lra). specialize (Tl ltac:(nra)). lra. }
    split.
    + exists (T (PI + 2 * INR (S n) * PI) - s). split; [apply BIG; lra|]. unfold a, Y. replace (T (PI + 2 * INR (S n) * PI) - s + s) with (T (PI + 2 * INR (S n) * PI)) by ring.
      rewrite PT, sin_period, sin_PI, Rmult_0_r. assert (H0 : h 0 = 0) by (replace 0 with (gg 0) at 1 by (unfold gg; ring); apply HG). rewrite H0. unfold Rdiv. rewrite Rmult_0_l. apply exp_0.
    + exists (T (PI / 2 + 2 * INR (S n) * PI) - s). split; [apply BIG; lra|]. unfold a, Y. replace (T (PI / 2 + 2 * INR (S n) * PI) - s + s) with (T (PI / 2 + 2 * INR (S n) * PI)) by ring.
      rewrite PT, sin_period. unfold s. now rewrite Rplus_0_l, PT.
Qed.

(* a star on a line: a centre, two agents at rest beside it at the distance 1, two that swing *)
Definition star (i j : nat) : bool := xorb (Nat.eqb i 0) (Nat.eqb j 0).
Definition offset (a : R) (i : nat) : R := match i with 0%nat => 0 | 1%nat => 1 | 2%nat => - (1) | 3%nat => a | _ => - a end.
Definition drift (b : R) (i : nat) : R := match i with 0%nat | 1%nat | 2%nat => 0 | 3%nat => b | _ => - b end.
Definition star_x (a : R -> R) (i : nat) (t : R) : R := 2 * t + offset (a t) i.
Definition star_y (b : R -> R) (i : nat) (t : R) : R := 2 + drift (b t) i.
Lemma star_connected : simple_connected 5 star.
Proof.
  split; [intros i j; unfold star; destruct (Nat.eqb i 0), (Nat.eqb j 0); reflexivity|]. split; [intros i; unfold star; destruct (Nat.eqb i 0); reflexivity|].
  assert (A : forall k, (k < 5)%nat -> clos_refl_trans nat (arc 5 star) k 0%nat /\ clos_refl_trans nat (arc 5 star) 0%nat k).
  { intros k Hk. destruct k as [|[|[|[|[|]]]]]; try lia; split; first [apply rt_refl|apply rt_step; repeat split; lia]. }
  intros i j Hi Hj. eapply rt_trans; [apply (A i Hi)|apply (A j Hj)].
Qed.
Lemma star_push a i t : 0 < a t -> (i < 5)%nat -> push 5 star fig2' (fun i => star_x a i t) i = drift (- fig2' 0 0 (a t)) i.
Proof.
  intros A Hi. unfold push, star_x. assert (E : forall x y, 2 * t + x - (2 * t + y) = x - y) by (intros; ring).
  set (u := a t) in *. assert (F1 : fig2' 0 0 1 = 0) by (unfold fig2'; field).
  assert (P : forall q, 0 < q -> fig2' 0 0 (Rabs q) / Rabs q * q = fig2' 0 0 q) by (intros q Q; rewrite Rabs_pos_eq by lra; field; lra).
  assert (N : forall q, 0 < q -> fig2' 0 0 (Rabs (- q)) / Rabs (- q) * - q = - fig2' 0 0 q) by (intros q Q; rewrite Rabs_Ropp, Rabs_pos_eq by lra; field; lra).
  change (- Sum 5 (fun j => if star i j then fig2' 0 0 (Rabs (2 * t + offset u i - (2 * t + offset u j))) / Rabs (2 * t + offset u i - (2 * t + offset u j))
    * (2 * t + offset u i - (2 * t + offset u j)) else 0)
    = drift (- fig2' 0 0 u) i).
  destruct i as [|[|[|[|[|]]]]]; try lia; cbn [Sum]; unfold star; cbn [Nat.eqb xorb]; rewrite !E; cbn [offset drift].
  - replace (0 - 1) with (- (1)) by ring. replace (0 - - (1)) with 1 by ring. replace (0 - u) with (- u) by ring. replace (0 - - u) with u by ring.
    rewrite (N 1), (P 1), (N u), (P u) by lra. ring.
  - replace (1 - 0) with 1 by ring. rewrite (P 1) by lra. rewrite F1. ring.
  - replace (- (1) - 0) with (- (1)) by ring. rewrite (N 1) by lra. rewrite F1. ring.
  - replace (u - 0) with u by ring. rewrite (P u) by lra. ring.
  - replace (- u - 0) with (- u) by ring. rewrite (N u) by lra. ring.
Qed.
Lemma star_closed a b t : 0 < a t -> is_derive a t (b t) -> is_derive b t (- fig2' 0 0 (a t)) -> Rabs (b t) <= 1 ->
  closed 5 star fig2 fig2' (on_line (star_x a)) (on_line (star_y b)) zero_heading t.
Proof.
  intros A Da Db B. apply Rabs_le_between in B. apply line_closed.
  - intros i Hi. split; [|split].
    + unfold star_x, star_y. assert (D : is_derive (fun s => offset (a s) i) t (drift (b t) i)).
      { destruct i as [|[|[|[|i]]]]; cbn [offset drift]; [apply D_const|apply D_const|apply D_const|exact Da|now apply D_opp]. }
      eapply D_eq; [apply (D_plus (fun s => 2 * s) (fun s => offset (a s) i)); [apply D_scal, D_id|exact D]|]. ring.
    + unfold star_y. destruct i as [|[|[|[|i]]]]; cbn [drift]; lra.
    + rewrite star_push by assumption. unfold star_y. assert (D : is_derive (fun s => drift (b s) i) t (drift (- fig2' 0 0 (a t)) i)).
      { destruct i as [|[|[|[|i]]]]; cbn [drift]; [apply D_const|apply D_const|apply D_const|exact Db|now apply D_opp]. }
      eapply D_eq; [apply (D_plus (fun s => 2) (fun s => drift (b s) i)); [apply D_const|exact D]|]. ring.
  - intros i j Hi Hj E. unfold star_x. destruct i as [|[|[|[|[|]]]]], j as [|[|[|[|[|]]]]]; try lia; try discriminate E; cbn [offset]; lra.
  - intros i j s _ _ Hs. apply (proj1 fig2_repels s Hs).
Qed.
Lemma star_swings : exists a b : R -> R, (forall t, 0 < a t /\ is_derive a t (b t) /\ is_derive b t (- fig2' 0 0 (a t)) /\ Rabs (b t) <= 1) /\
  a 0 <> 1 /\ forall T, (exists t, T <= t /\ a t = 1) /\ exists t, T <= t /\ a t = a 0.
Proof.
  destruct (gg_onto 1) as [y0 Y]. assert (P : 0 < y0) by (unfold gg in Y; pose proof (root_pos y0); nra).
  destruct (swing_exists y0 P) as (a & b & M & A & _ & Re). exists a, b. split; [|split; [|exact Re]].
  - intros t. destruct (M t) as (B1 & B2 & B3 & B4). rewrite <- gg_sqr, Y in B4. split; [exact B1|]. split; [exact B2|]. split; [exact B3|]. apply Rabs_le. nra.
  - rewrite A. pose proof (exp_ineq1 (y0 / 2) ltac:(lra)). lra.
Qed.
Lemma collision_2_proved : collision_2.
Proof.
  intros H. destruct star_swings as (a & b & M & A0 & Re). destruct (Re 0) as [(t & T0 & T1) _]. destruct (M 0) as [P0 _].
  apply (H 5%nat star (on_line (star_x a)) (on_line (star_y b)) zero_heading star_connected) with (t := t) (i := 1%nat) (j := 3%nat); try lia; try exact T0.
  - intros i j Hi Hj N E. unfold on_line in E. injection E. unfold star_x. destruct i as [|[|[|[|[|]]]]], j as [|[|[|[|[|]]]]]; try lia; cbn [offset]; lra.
  - intros s _. destruct (M s) as (B1 & B2 & B3 & B4). now apply star_closed.
  - unfold on_line, star_x. cbn [offset]. now rewrite T1.
Qed.
Lemma propIV3b_1_proved : propIV3b_1.
Proof.
  intros H. destruct star_swings as (a & b & M & A0 & Re).
  destruct (H 5%nat star (on_line (star_x a)) (on_line (star_y b)) zero_heading star_connected) with (i := 3%nat) (j := 0%nat) as [d L]; try lia; try reflexivity.
  - intros s _. destruct (M s) as (B1 & B2 & B3 & B4). now apply star_closed.
  - assert (E : forall t, Cmod (on_line (star_x a) 3 t - on_line (star_x a) 0 t)%C = a t).
    { intros t. unfold on_line. rewrite Cmod_line. unfold star_x. cbn [offset]. destruct (M t) as [P _]. replace (2 * t + a t - (2 * t + 0)) with (a t) by ring. apply Rabs_pos_eq. lra. }
    apply is_lim_spec in L. assert (e0 : 0 < Rabs (a 0 - 1) / 2) by (assert (0 < Rabs (a 0 - 1)) by (apply Rabs_pos_lt; lra); lra).
    destruct (L (mkposreal _ e0)) as [B HB]. destruct (Re (B + 1)) as [(t1 & T1 & E1) (t2 & T2 & E2)].
    pose proof (HB t1 ltac:(lra)) as X1. pose proof (HB t2 ltac:(lra)) as X2. cbn [pos] in X1, X2. rewrite E, E1 in X1. rewrite E, E2 in X2.
    assert (T : Rabs (a 0 - 1) <= Rabs (a 0 - d) + Rabs (1 - d)); [|lra].
    replace (a 0 - 1) with ((a 0 - d) - (1 - d)) by ring. eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_Ropp. lra.
Qed.

(* tanner1.propIV3b clause 3, for which there was no theorem: there is such a motion, and in every one the headings stay 0 and the distance has no limit *)
Definition pair_start (r v : nat -> R -> C) := r 0%nat 0 = RtoC 0 /\ r 1%nat 0 = RtoC 2 /\ v 0%nat 0 = RtoC 2 /\ v 1%nat 0 = RtoC 2.
Definition propIV3b_3 : Prop := (exists r v th, pair_start r v /\ forall t, 0 <= t -> closed 2 complete fig2 fig2' r v th t) /\
  forall r v th, pair_start r v -> (forall t, 0 <= t -> closed 2 complete fig2 fig2' r v th t) ->
  (forall t i, 0 <= t -> (i < 2)%nat -> th i t = 0) /\ forall d : R, ~ is_lim (fun t => Cmod (r 0%nat t - r 1%nat t)%C) p_infty d.
(* a number that cannot become 0 while it is not negative stays positive *)
Lemma stays (phi : R -> R) : (forall t, 0 <= t -> continuity_pt phi t) -> 0 <= phi 0 ->
  (forall tau, 0 <= tau -> (forall t, 0 <= t <= tau -> 0 <= phi t) -> 0 < phi tau) -> forall t, 0 <= t -> 0 < phi t.
Proof.
  intros C P0 H t1 T1. apply Rnot_le_lt. intros N. set (E := fun tau => 0 <= tau <= t1 /\ forall s, 0 <= s <= tau -> 0 <= phi s).
  assert (E0 : E 0) by (split; [lra|]; intros s Hs; replace s with 0 by lra; exact P0).
  destruct (completeness E) as (m & Up & Least); [exists t1; intros x [Hx _]; lra|now exists 0|].
  assert (M0 : 0 <= m) by now apply Up. assert (M1 : m <= t1) by (apply Least; intros x [Hx _]; lra).
  assert (B : forall s, 0 <= s < m -> 0 <= phi s).
  { intros s Hs. apply Rnot_lt_le. intros L. assert (m <= s); [|lra]. apply Least. intros x [Hx Px]. apply Rnot_lt_le. intros Lx. specialize (Px s ltac:(lra)). lra. }
  assert (Near : forall e, 0 < e -> exists d, 0 < d /\ forall s, Rabs (s - m) < d -> Rabs (phi s - phi m) < e).
  { intros e He. destruct (C m M0 e He) as (d & d0 & Hd). exists d. split; [exact d0|]. intros s Hs. destruct (Req_dec s m) as [->|Ne]; [rewrite Rminus_eq_0, Rabs_R0; exact He|].
    apply (Hd s). split; [split; [exact I|congruence]|exact Hs]. }
  assert (Pm : 0 <= phi m).
  { apply Rnot_lt_le. intros L. destruct (Req_dec m 0) as [Z|Z]; [rewrite Z in L; lra|]. destruct (Near (- phi m) ltac:(lra)) as (d & d0 & Hd).
    set (s := Rmax 0 (m - d / 2)). assert (S : 0 <= s < m /\ m - d / 2 <= s) by (unfold s; split; [split; [apply Rmax_l|apply Rmax_lub_lt; lra]|apply Rmax_r]).
    specialize (Hd s ltac:(apply Rabs_def1; lra)). apply Rabs_lt_between in Hd. specialize (B s ltac:(lra)). lra. }
  assert (Pm' : 0 < phi m). { apply H; [exact M0|]. intros t Ht. destruct (Req_dec t m) as [->|Ne]; [exact Pm|apply B; lra]. }
  assert (M2 : m < t1) by (destruct (Req_dec m t1) as [Z|Z]; [rewrite Z in Pm'; lra|lra]). destruct (Near (phi m) Pm') as (d & d0 & Hd).
  set (s := Rmin t1 (m + d / 2)). assert (S : m < s /\ s <= t1 /\ s <= m + d / 2) by (unfold s; split; [apply Rmin_glb_lt; lra|split; [apply Rmin_l|apply Rmin_r]]).
  assert (Es : E s); [|apply Up in Es; lra]. split; [lra|]. intros x Hx. destruct (Rlt_le_dec x m) as [L|L]; [apply B; lra|].
  specialize (Hd x ltac:(apply Rabs_def1; lra)). apply Rabs_lt_between in Hd. lra.
Qed.
(* a bounded function whose rate has a limit *)
Lemma rate_up (f f' : R -> R) (kappa B T : R) : (forall t, 0 <= t -> is_derive f t (f' t)) -> is_lim f' p_infty kappa -> (forall t, T <= t -> Rabs (f t) <= B) -> ~ 0 < kappa.
Proof.
  intros D L Bd K. apply is_lim_spec in L. assert (e0 : 0 < kappa / 2) by lra. destruct (L (mkposreal _ e0)) as [M HM]. cbn [pos] in HM.
  set (a := Rmax 0 (Rmax M T) + 1). assert (A : 1 <= a /\ M < a /\ T < a).
  { unfold a. pose proof (Rmax_l 0 (Rmax M T)). pose proof (Rmax_r 0 (Rmax M T)). pose proof (Rmax_l M T). pose proof (Rmax_r M T). lra. }
  set (l := (2 * Rabs B + 1) * (2 / kappa)). assert (l0 : 0 < l) by (apply Rmult_lt_0_compat; [pose proof (Rabs_pos B); lra|apply Rdiv_lt_0_compat; lra]).
  destruct (MVT_le f f' a (a + l) ltac:(lra) ltac:(intros; apply D; lra)) as (c & Hc & E). specialize (HM c ltac:(lra)). apply Rabs_lt_between in HM.
  pose proof (Bd a ltac:(lra)) as B1. pose proof (Bd (a + l) ltac:(lra)) as B2. apply Rabs_le_between in B1. apply Rabs_le_between in B2.
  assert (X : kappa / 2 * l = 2 * Rabs B + 1) by (unfold l; field; lra). pose proof (Rle_abs B). assert (kappa / 2 * l <= f' c * l) by (apply Rmult_le_compat_r; lra).
  replace (a + l - a) with l in E by ring. lra.
Qed.
Lemma rate_0 (f f' : R -> R) (kappa B T : R) : (forall t, 0 <= t -> is_derive f t (f' t)) -> is_lim f' p_infty kappa -> (forall t, T <= t -> Rabs (f t) <= B) -> kappa = 0.
Proof.
  intros D L Bd. pose proof (rate_up f f' kappa B T D L Bd) as U.
  assert (U' : ~ 0 < - kappa).
  { apply (rate_up (fun t => - f t) (fun t => - f' t) (- kappa) B T); [intros; now apply D_opp, D|exact (is_lim_opp f' p_infty kappa L)|intros; rewrite Rabs_Ropp; now apply Bd]. }
  lra.
Qed.
(* the heading of one that moves forward *)
Lemma small_heading (v : C) th : v = (RtoC (Cmod v) * expi th)%C -> - PI < th <= PI -> 0 < fst v -> Rabs th * fst v <= Rabs (snd v).
Proof.
  intros E T P. pose proof PI_RGT_0 as PP. assert (F := f_equal fst E). assert (S := f_equal snd E). set (m := Cmod v) in *. assert (M : 0 <= m) by apply Cmod_ge_0. unfold expi in F, S. cbn in F, S.
  replace (m * cos th - 0 * sin th) with (m * cos th) in F by ring. replace (m * sin th + 0 * cos th) with (m * sin th) in S by ring.
  assert (C : 0 < cos th) by nra.
  assert (J : forall x, 0 <= x <= PI / 2 -> x * cos x <= sin x).
  { intros x X. destruct (MVT_le (fun x => sin x - x * cos x) (fun x => x * sin x) 0 x ltac:(lra)) as (c & Hc & Q).
    - intros t _. eapply D_eq; [apply (D_minus sin (fun t => t * cos t)); [apply is_derive_sin|apply (D_mult (fun t => t) cos); [apply D_id|apply is_derive_cos]]|]. ring.
    - rewrite sin_0 in Q. assert (0 <= sin c) by (apply sin_ge_0; lra). assert (0 <= c * sin c) by (apply Rmult_le_pos; lra). nra. }
  destruct (Rle_lt_dec 0 th) as [L|L].
  - assert (U : th <= PI / 2). { apply Rnot_lt_le. intros U. assert (cos th <= 0) by (apply cos_le_0; lra). lra. }
    specialize (J th ltac:(lra)). rewrite (Rabs_pos_eq th) by lra. pose proof (Rle_abs (snd v)). rewrite F. replace (th * (m * cos th)) with (m * (th * cos th)) by ring.
    apply Rle_trans with (m * sin th); [now apply Rmult_le_compat_l|lra].
  - assert (U : - th <= PI / 2). { apply Rnot_lt_le. intros U. assert (cos (- th) <= 0) by (apply cos_le_0; lra). rewrite cos_neg in H. lra. }
    specialize (J (- th) ltac:(lra)). rewrite cos_neg, sin_neg in J. rewrite (Rabs_left th) by lra. pose proof (Rle_abs (- snd v)) as A. rewrite Rabs_Ropp in A.
    rewrite F. replace (- th * (m * cos th)) with (m * (- th * cos th)) by ring. apply Rle_trans with (m * - sin th); [now apply Rmult_le_compat_l|lra].
Qed.
Lemma law_pair (r v : nat -> C) (th : nat -> R) : let d := Cmod (r 0%nat - r 1%nat)%C in let F := fig2' 0 0 d / d in let s := (th 0%nat - th 1%nat) / d ^ 2 in
  law 2 complete fig2' (fun i j => th i - th j) r v 0 = (- (F * (fst (r 0%nat) - fst (r 1%nat))) + s * snd (v 0%nat), - (F * (snd (r 0%nat) - snd (r 1%nat))) - s * fst (v 0%nat)) /\
  law 2 complete fig2' (fun i j => th i - th j) r v 1 = (F * (fst (r 0%nat) - fst (r 1%nat)) - s * snd (v 1%nat), F * (snd (r 0%nat) - snd (r 1%nat)) + s * fst (v 1%nat)).
Proof.
  intros d F s. unfold law, Csum. cbn [Sum]. unfold complete. cbn [Nat.eqb negb]. assert (D : Cmod (r 1%nat - r 0%nat)%C = d) by (unfold d; exact (norm_sym _ _)).
  rewrite D. fold d. change (fig2' 0 1 d) with (fig2' 0 0 d). change (fig2' 1 0 d) with (fig2' 0 0 d). fold F.
  replace ((th 1%nat - th 0%nat) / d ^ 2) with (- s) by (unfold s, Rdiv; ring). fold s.
  split; apply injective_projections; cbn; ring.
Qed.
Lemma ln2_small : ln 2 < 7 / 8.
Proof.
  rewrite <- (ln_exp (7 / 8)). apply ln_increasing; [lra|]. replace (7 / 8) with (7 / 16 + 7 / 16) by field. rewrite exp_plus. pose proof (exp_ineq1 (7 / 16) ltac:(lra)). nra.
Qed.
Lemma fig2_at_2 : fig2 0 0 2 = / 4 + 2 * ln 2.
Proof. unfold fig2. replace (2 ^ 2) with (2 * 2) by ring. rewrite ln_mult by lra. field. Qed.
Lemma fig2_ge1 s : 0 < s -> 1 <= fig2 0 0 s.
Proof. intros Hs. destruct fig2_shape as (_ & _ & E & M). change (1 <= V2 s). destruct (Req_dec s 1) as [->|N]; [lra|]. pose proof (M s Hs N). lra. Qed.

Definition pair_motion (r v : nat -> R -> C) (th : nat -> R -> R) := pair_start r v /\ forall t, 0 <= t -> closed 2 complete fig2 fig2' r v th t.
Definition dist01 (r : nat -> R -> C) t := Cmod (r 0%nat t - r 1%nat t)%C.
Definition speed2 (v : nat -> R -> C) i t := fst (v i t) ^ 2 + snd (v i t) ^ 2.
Lemma Cmod_sqr (z : C) : Cmod z ^ 2 = fst z ^ 2 + snd z ^ 2.
Proof. unfold Cmod. apply pow2_sqrt. pose proof (pow2_ge_0 (fst z)). pose proof (pow2_ge_0 (snd z)). lra. Qed.
Lemma pm_energy r v th t : pair_motion r v th -> 0 <= t -> fig2 0 0 (dist01 r t) + (speed2 v 0 t + speed2 v 1 t) / 2 = fig2 0 0 2 + 4.
Proof.
  intros [(R0 & R1 & V0 & V1) M] Ht. assert (D : forall s, Cmod (r 1%nat s - r 0%nat s)%C = dist01 r s) by (intros; exact (norm_sym _ _)).
  pose proof (Vt_inv_3_proved 2%nat complete fig2 fig2' r v (fun i j s => th i s - th j s) complete_undirected (fun _ _ _ => eq_refl) (fun s Hs => proj1 (M s Hs)) t Ht) as E.
  unfold kinetic_plus_V in E. cbn [Sum] in E. unfold complete in E. cbn [Nat.eqb negb] in E. rewrite !D in E. fold (dist01 r t) (dist01 r 0) in E. rewrite !Cmod_sqr in E.
  change (fig2 0 1) with (fig2 0 0) in E. change (fig2 1 0) with (fig2 0 0) in E. fold (speed2 v 0 t) (speed2 v 1 t) in E. rewrite V0, V1 in E. cbn [fst snd RtoC] in E.
  assert (D0 : dist01 r 0 = 2). { unfold dist01. rewrite R0, R1, Cmod_line. replace (0 - 2) with (- (2)) by ring. rewrite Rabs_Ropp, Rabs_pos_eq; lra. }
  rewrite D0 in E. lra.
Qed.
Lemma pm_positive r v th t : pair_motion r v th -> 0 <= t -> 0 < dist01 r t.
Proof. intros [_ M] Ht. destruct (M t Ht) as [L _]. destruct (L 0%nat ltac:(lia)) as (_ & _ & Q). destruct (Q 1%nat ltac:(lia) eq_refl) as [N _]. exact (norm_neq _ _ N). Qed.
Lemma pm_bounds r v th : pair_motion r v th -> (exists d, 0 < d /\ forall t, 0 <= t -> d <= dist01 r t) /\ forall t i, 0 <= t -> (i < 2)%nat -> speed2 v i t <= 16.
Proof.
  intros M. split.
  - destruct (proj2 fig2_repels (fig2 0 0 2 + 4)) as (d & d0 & Hd). exists d. split; [exact d0|]. intros t Ht. apply Rnot_lt_le. intros L.
    specialize (Hd (dist01 r t) (conj (pm_positive r v th t M Ht) L)). pose proof (pm_energy r v th t M Ht) as E. unfold speed2 in E.
    pose proof (pow2_ge_0 (fst (v 0%nat t))). pose proof (pow2_ge_0 (snd (v 0%nat t))). pose proof (pow2_ge_0 (fst (v 1%nat t))). pose proof (pow2_ge_0 (snd (v 1%nat t))). lra.
  - intros t i Ht Hi. pose proof (pm_energy r v th t M Ht) as E. pose proof (fig2_ge1 _ (pm_positive r v th t M Ht)). rewrite fig2_at_2 in E. pose proof ln2_small. unfold speed2 in *.
    pose proof (pow2_ge_0 (fst (v 0%nat t))). pose proof (pow2_ge_0 (snd (v 0%nat t))). pose proof (pow2_ge_0 (fst (v 1%nat t))). pose proof (pow2_ge_0 (snd (v 1%nat t))).
    destruct i as [|[|]]; [lra|lra|lia].
Qed.
(* the force over the distance, and the turn of agent 0 *)
Definition FF r t := fig2' 0 0 (dist01 r t) / dist01 r t.
Definition ss (r : nat -> R -> C) (th : nat -> R -> R) t := (th 0%nat t - th 1%nat t) / dist01 r t ^ 2.
Lemma pm_rates r v th t : pair_motion r v th -> 0 <= t -> (forall i, (i < 2)%nat -> is_velocity (r i) t (v i t)) /\
  is_velocity (v 0%nat) t (- (FF r t * (fst (r 0%nat t) - fst (r 1%nat t))) + ss r th t * snd (v 0%nat t), - (FF r t * (snd (r 0%nat t) - snd (r 1%nat t))) - ss r th t * fst (v 0%nat t)) /\
  is_velocity (v 1%nat) t (FF r t * (fst (r 0%nat t) - fst (r 1%nat t)) - ss r th t * snd (v 1%nat t), FF r t * (snd (r 0%nat t) - snd (r 1%nat t)) + ss r th t * fst (v 1%nat t)).
Proof.
  intros [_ M] Ht. destruct (M t Ht) as [L _]. destruct (law_pair (fun i => r i t) (fun i => v i t) (fun i => th i t)) as [E0 E1]. cbv zeta in E0, E1.
  split; [intros i Hi; now apply (L i Hi)|]. destruct (L 0%nat ltac:(lia)) as (_ & A & _). destruct (L 1%nat ltac:(lia)) as (_ & B & _). split.
  - refine (eq_ind _ (is_velocity (v 0%nat) t) A _ _). exact E0.
  - refine (eq_ind _ (is_velocity (v 1%nat) t) B _ _). exact E1.
Qed.
(* while both move forward they stay on the line *)
Definition across (r v : nat -> R -> C) t := (snd (r 0%nat t) - snd (r 1%nat t)) ^ 2 + (snd (v 0%nat t) ^ 2 + snd (v 1%nat t) ^ 2).
Lemma products (D q p F F1 k : R) : 0 <= F1 -> 0 <= k -> Rabs F <= F1 -> 2 * D * (q - p) - 2 * F * D * (q - p) + k * (Rabs q + Rabs p) ^ 2 <= (2 + 2 * F1 + 2 * k) * (D ^ 2 + (q ^ 2 + p ^ 2)).
Proof.
  intros F0 K0 HF. apply Rabs_le_between in HF.
  assert (A : 2 * D * (q - p) <= D ^ 2 + (q - p) ^ 2) by (pose proof (pow2_ge_0 (D - (q - p))); nra).
  assert (A' : - (2 * D * (q - p)) <= D ^ 2 + (q - p) ^ 2) by (pose proof (pow2_ge_0 (D + (q - p))); nra).
  assert (B : (q - p) ^ 2 <= 2 * (q ^ 2 + p ^ 2)) by (pose proof (pow2_ge_0 (q + p)); nra).
  assert (C : (Rabs q + Rabs p) ^ 2 <= 2 * (q ^ 2 + p ^ 2)).
  { pose proof (pow2_ge_0 (Rabs q - Rabs p)). assert (Rabs q ^ 2 = q ^ 2 /\ Rabs p ^ 2 = p ^ 2) by (rewrite !pow2_abs; split; reflexivity). nra. }
  assert (S : 0 <= D ^ 2 + (q - p) ^ 2) by (pose proof (pow2_ge_0 D); pose proof (pow2_ge_0 (q - p)); lra).
  assert (G : - 2 * F * D * (q - p) <= F1 * (D ^ 2 + (q - p) ^ 2)).
  { set (x := 2 * D * (q - p)) in *. set (y := D ^ 2 + (q - p) ^ 2) in *. replace (- 2 * F * D * (q - p)) with (- F * x) by (unfold x; ring).
    destruct (Rle_lt_dec 0 x) as [X|X]; nra. }
  assert (H : k * (Rabs q + Rabs p) ^ 2 <= k * (2 * (q ^ 2 + p ^ 2))) by (apply Rmult_le_compat_l; lra).
  assert (I : F1 * (D ^ 2 + (q - p) ^ 2) <= F1 * (2 * (D ^ 2 + (q ^ 2 + p ^ 2)))) by (apply Rmult_le_compat_l; [lra|]; pose proof (pow2_ge_0 D); lra).
  assert (k * (2 * (q ^ 2 + p ^ 2)) <= 2 * k * (D ^ 2 + (q ^ 2 + p ^ 2))) by (pose proof (pow2_ge_0 D); nra).
  pose proof (pow2_ge_0 D). nra.
Qed.
Lemma pm_line r v th tau : pair_motion r v th -> (forall t, 0 <= t <= tau -> 1 <= fst (v 0%nat t) /\ 1 <= fst (v 1%nat t)) ->
  forall t, 0 <= t <= tau -> snd (r 0%nat t) = snd (r 1%nat t) /\ snd (v 0%nat t) = 0 /\ snd (v 1%nat t) = 0 /\ th 0%nat t = 0 /\ th 1%nat t = 0.
Proof.
  intros M P. destruct (pm_bounds r v th M) as [(d & d0 & Hd) Sp]. set (k := 8 / d ^ 2). set (F1 := 2 / d ^ 2 + 2 / d ^ 4). set (K := 2 + 2 * F1 + 2 * k).
  assert (D2 : 0 < d ^ 2) by now apply pow_lt. assert (D4 : 0 < d ^ 4) by now apply pow_lt.
  assert (k0 : 0 <= k) by (left; apply Rdiv_lt_0_compat; lra). assert (F0 : 0 <= F1) by (unfold F1; assert (0 < 2 / d ^ 2) by (apply Rdiv_lt_0_compat; lra); assert (0 < 2 / d ^ 4) by (apply
    Rdiv_lt_0_compat; lra); lra).
  assert (Small : forall t i, 0 <= t <= tau -> (i < 2)%nat -> Rabs (th i t) <= Rabs (snd (v i t))).
  { intros t i Ht Hi. destruct (proj2 M t ltac:(lra)) as [_ Hh]. destruct (Hh i Hi) as (_ & E & T). pose proof (P t Ht) as [P0 P1].
    assert (Pi : 1 <= fst (v i t)) by (destruct i as [|[|]]; [exact P0|exact P1|lia]). pose proof (small_heading _ _ E T ltac:(lra)). pose proof (Rabs_pos (th i t)). nra. }
  assert (Rate : forall t, 0 <= t <= tau -> exists e', is_derive (across r v) t e' /\ e' <= K * across r v t).
  { intros t Ht. destruct (pm_rates r v th t M ltac:(lra)) as (HR & [_ A0] & [_ A1]). destruct (HR 0%nat ltac:(lia)) as [_ R0]. destruct (HR 1%nat ltac:(lia)) as [_ R1]. cbn [fst snd] in A0, A1.
    eexists. split.
    - apply (D_plus (fun s => (snd (r 0%nat s) - snd (r 1%nat s)) ^ 2) (fun s => snd (v 0%nat s) ^ 2 + snd (v 1%nat s) ^ 2)).
      + apply (D_sqr (fun s => snd (r 0%nat s) - snd (r 1%nat s))). apply D_minus; [exact R0|exact R1].
      + apply (D_plus (fun s => snd (v 0%nat s) ^ 2) (fun s => snd (v 1%nat s) ^ 2)); [apply (D_sqr (fun s => snd (v 0%nat s))); exact A0|apply (D_sqr (fun s => snd (v 1%nat s))); exact A1].
    - unfold across. cbv beta. set (D := snd (r 0%nat t) - snd (r 1%nat t)). set (q := snd (v 0%nat t)). set (p := snd (v 1%nat t)). set (F := FF r t). set (s := ss r th t).
      assert (HF : Rabs F <= F1).
      { unfold F, FF. pose proof (Hd t ltac:(lra)) as L. set (x := dist01 r t) in *. assert (X : 0 < x) by lra. replace (fig2' 0 0 x / x) with (2 / x ^ 2 - 2 / x ^ 4) by (unfold fig2'; field; lra).
        assert (I2 : 0 < 2 / x ^ 2 <= 2 / d ^ 2). { split; [apply Rdiv_lt_0_compat; [lra|now apply pow_lt]|]. apply Rmult_le_compat_l; [lra|].
          apply Rinv_le_contravar; [exact D2|apply pow_incr; lra]. }
        assert (I4 : 0 < 2 / x ^ 4 <= 2 / d ^ 4). { split; [apply Rdiv_lt_0_compat; [lra|now apply pow_lt]|]. apply Rmult_le_compat_l; [lra|].
          apply Rinv_le_contravar; [exact D4|apply pow_incr; lra]. }
        unfold F1. apply Rabs_le. lra. }
      assert (HS : Rabs s <= (Rabs q + Rabs p) / d ^ 2).
      { unfold s, ss. unfold Rdiv. rewrite Rabs_mult. pose proof (Hd t ltac:(lra)) as L. assert (X : 0 < dist01 r t ^ 2) by (apply pow_lt; lra).
        rewrite (Rabs_pos_eq (/ dist01 r t ^ 2)) by (left; now apply Rinv_0_lt_compat).
        apply Rmult_le_compat; [apply Rabs_pos|left; now apply Rinv_0_lt_compat| |apply Rinv_le_contravar; [exact D2|apply pow_incr; lra]].
        unfold Rminus. eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_Ropp. pose proof (Small t 0%nat Ht ltac:(lia)). pose proof (Small t 1%nat Ht ltac:(lia)). unfold q, p. lra. }
      assert (HP : Rabs (fst (v 0%nat t)) <= 4 /\ Rabs (fst (v 1%nat t)) <= 4).
      { pose proof (Sp t 0%nat ltac:(lra) ltac:(lia)) as S0. pose proof (Sp t 1%nat ltac:(lra) ltac:(lia)) as S1. unfold speed2 in S0, S1. pose proof (pow2_ge_0 (snd (v 0%nat t))).
        pose proof (pow2_ge_0 (snd (v 1%nat t))).
        split; apply Rabs_le; split; nra. }
      destruct HP as [HP0 HP1]. set (P0 := fst (v 0%nat t)) in *. set (P1 := fst (v 1%nat t)) in *.
      assert (HX : 2 * q * (- s * P0) + 2 * p * (s * P1) <= k * (Rabs q + Rabs p) ^ 2).
      { apply Rle_trans with (Rabs (2 * q * (- s * P0)) + Rabs (2 * p * (s * P1))).
        - pose proof (Rle_abs (2 * q * (- s * P0))). pose proof (Rle_abs (2 * p * (s * P1))). lra.
        - rewrite !Rabs_mult, Rabs_Ropp, (Rabs_pos_eq 2) by lra. pose proof (Rabs_pos q) as q0. pose proof (Rabs_pos p) as p0. pose proof (Rabs_pos s) as s0. pose proof (Rabs_pos P0) as P00.
          pose proof (Rabs_pos P1) as P10.
          set (aq := Rabs q) in *. set (ap := Rabs p) in *. set (as' := Rabs s) in *. set (x0 := Rabs P0) in *. set (x1 := Rabs P1) in *.
          assert (B0 : as' * x0 <= as' * 4) by (apply Rmult_le_compat_l; lra). assert (B1 : as' * x1 <= as' * 4) by (apply Rmult_le_compat_l; lra).
          apply Rle_trans with (8 * (aq + ap) * as').
          + assert (2 * aq * (as' * x0) <= 2 * aq * (as' * 4)) by (apply Rmult_le_compat_l; lra). assert (2 * ap * (as' * x1) <= 2 * ap * (as' * 4)) by (apply Rmult_le_compat_l; lra). lra.
          + apply Rle_trans with (8 * (aq + ap) * ((aq + ap) / d ^ 2)); [apply Rmult_le_compat_l; lra|]. right. unfold k. field. apply Rgt_not_eq. exact d0. }
      pose proof (products D q p F F1 k F0 k0 HF) as Q. unfold K. apply Rle_trans with (2 * D * (q - p) - 2 * F * D * (q - p) + k * (Rabs q + Rabs p) ^ 2); [|exact Q].
      replace (2 * D * (q - p) + (2 * q * (- (F * D) - s * P0) + 2 * p * (F * D + s * P1))) with (2 * D * (q - p) - 2 * F * D * (q - p) + (2 * q * (- s * P0) + 2 * p * (s * P1))) by ring. lra. }
  assert (A0 : across r v 0 = 0).
  { destruct M as [(R0 & R1 & V0 & V1) _]. unfold across. rewrite R0, R1, V0, V1. cbn. ring. }
  assert (Z : forall t, 0 <= t <= tau -> across r v t = 0).
  { intros t Ht. assert (N : 0 <= across r v t) by (unfold across; pose proof (pow2_ge_0 (snd (r 0%nat t) - snd (r 1%nat t))); pose proof (pow2_ge_0 (snd (v 0%nat t))); pose proof
    (pow2_ge_0 (snd (v 1%nat t))); lra).
    assert (Q : across r v t * exp (- K * t) <= across r v 0 * exp (- K * 0)).
    { apply (decreasing (fun s => across r v s * exp (- K * s)) (fun s => (Derive (across r v) s - K * across r v s) * exp (- K * s)) 0 t ltac:(lra)).
      - intros s Hs. destruct (Rate s ltac:(lra)) as (e' & De & _). rewrite (is_derive_unique _ _ _ De).
        eapply D_eq; [apply (D_mult (across r v) (fun s => exp (- K * s))); [exact De|apply (D_comp exp (fun s => - K * s)); [apply is_derive_exp|apply D_scal, D_id]]|]. cbv beta. ring.
      - intros s Hs. destruct (Rate s ltac:(lra)) as (e' & De & Le). rewrite (is_derive_unique _ _ _ De). pose proof (exp_pos (- K * s)). nra. }
    rewrite A0, Rmult_0_l in Q. pose proof (exp_pos (- K * t)). nra. }
  intros t Ht. specialize (Z t Ht). unfold across in Z. pose proof (pow2_ge_0 (snd (r 0%nat t) - snd (r 1%nat t))). pose proof (pow2_ge_0 (snd (v 0%nat t))). pose proof (pow2_ge_0 (snd (v 1%nat t))).
  assert (Q0 : snd (v 0%nat t) = 0) by nra. assert (Q1 : snd (v 1%nat t) = 0) by nra. pose proof (Small t 0%nat Ht ltac:(lia)) as S0. pose proof (Small t 1%nat Ht ltac:(lia)) as S1.
  rewrite Q0, Rabs_R0 in S0. rewrite Q1, Rabs_R0 in S1. pose proof (Rabs_pos (th 0%nat t)). pose proof (Rabs_pos (th 1%nat t)).
  split; [nra|]. split; [exact Q0|]. split; [exact Q1|]. split; [destruct (Req_dec (th 0%nat t) 0) as [E|E]|destruct (Req_dec (th 1%nat t) 0) as [E|E]]; try exact E; apply Rabs_pos_lt in E; lra.
Qed.

(* ... with velocities 2 -+ p, where p^2 = V(2) - V(distance) < 1 *)
Lemma pm_speeds r v th tau : pair_motion r v th -> 0 <= tau -> (forall t, 0 <= t <= tau -> 1 <= fst (v 0%nat t) /\ 1 <= fst (v 1%nat t)) ->
  fst (v 0%nat tau) + fst (v 1%nat tau) = 4 /\ ((fst (v 1%nat tau) - fst (v 0%nat tau)) / 2) ^ 2 = fig2 0 0 2 - fig2 0 0 (dist01 r tau) /\
  1 < fst (v 0%nat tau) /\ 1 < fst (v 1%nat tau).
Proof.
  intros M T P. pose proof (pm_line r v th tau M P) as Z.
  assert (S : fst (v 0%nat tau) + fst (v 1%nat tau) = 4).
  { destruct (MVT_le (fun s => fst (v 0%nat s) + fst (v 1%nat s)) (fun _ => 0) 0 tau T) as (c & _ & E).
    - intros t Ht. destruct (pm_rates r v th t M ltac:(lra)) as (_ & [A0 _] & [A1 _]). cbn [fst snd] in A0, A1. destruct (Z t Ht) as (_ & Q0 & Q1 & _).
      eapply D_eq; [apply D_plus; [exact A0|exact A1]|]. rewrite Q0, Q1. ring.
    - destruct M as [(_ & _ & V0 & V1) _]. rewrite V0, V1 in E. cbn in E. lra. }
  pose proof (pm_energy r v th tau M T) as E. destruct (Z tau ltac:(lra)) as (_ & Q0 & Q1 & _). unfold speed2 in E. rewrite Q0, Q1 in E.
  set (a := fst (v 0%nat tau)) in *. set (b := fst (v 1%nat tau)) in *. assert (B : b = 4 - a) by lra. split; [exact S|].
  assert (Q : ((b - a) / 2) ^ 2 = fig2 0 0 2 - fig2 0 0 (dist01 r tau)) by (rewrite B in *; nra). split; [exact Q|].
  pose proof (fig2_ge1 _ (pm_positive r v th tau M T)). rewrite fig2_at_2 in Q. pose proof ln2_small. assert (W : ((b - a) / 2) ^ 2 < 1) by lra. rewrite B in W. split; nra.
Qed.
Lemma velocity_continuous (f : R -> R) t l : is_derive f t l -> continuity_pt f t.
Proof. intros D. apply derivable_continuous_pt, ex_derive_Reals_0. now exists l. Qed.
Lemma pm_forward r v th : pair_motion r v th -> forall t, 0 <= t -> 1 < fst (v 0%nat t) /\ 1 < fst (v 1%nat t).
Proof.
  intros M. set (m := fun t => Rmin (fst (v 0%nat t)) (fst (v 1%nat t)) - 1).
  assert (E : forall t, m t = (fst (v 0%nat t) + fst (v 1%nat t) - Rabs (fst (v 0%nat t) - fst (v 1%nat t))) * / 2 - 1).
  { intros t. unfold m, Rmin. destruct (Rle_dec (fst (v 0%nat t)) (fst (v 1%nat t))); [rewrite Rabs_left1 by lra|rewrite Rabs_pos_eq by lra]; field. }
  assert (A : forall t, 0 <= t -> 0 < m t).
  { apply stays.
    - intros t Ht. destruct (pm_rates r v th t M Ht) as (_ & [A0 _] & [A1 _]). apply velocity_continuous in A0. apply velocity_continuous in A1.
      assert (C : continuity_pt (fun t => (fst (v 0%nat t) + fst (v 1%nat t) - Rabs (fst (v 0%nat t) - fst (v 1%nat t))) * / 2 - 1) t).
      { apply continuity_pt_minus; [|apply continuity_pt_const; intros ? ?; reflexivity]. apply continuity_pt_mult; [|apply continuity_pt_const; intros ? ?; reflexivity].
        apply continuity_pt_minus; [now apply continuity_pt_plus|]. apply (continuity_pt_comp (fun t => fst (v 0%nat t) - fst (v 1%nat t)) Rabs); [now apply continuity_pt_minus|apply
          Rcontinuity_abs]. }
      apply (continuity_ext_loc _ m t 1 Rlt_0_1 (fun z _ => eq_sym (E z)) C).
    - destruct M as [(_ & _ & V0 & V1) _]. unfold m. rewrite V0, V1. cbn. rewrite Rmin_left; lra.
    - intros tau Ht H. assert (P : forall t, 0 <= t <= tau -> 1 <= fst (v 0%nat t) /\ 1 <= fst (v 1%nat t)).
      { intros t Htt. specialize (H t Htt). unfold m in H. pose proof (Rmin_l (fst (v 0%nat t)) (fst (v 1%nat t))). pose proof (Rmin_r (fst (v 0%nat t)) (fst (v 1%nat t))). lra. }
      destruct (pm_speeds r v th tau M Ht P) as (_ & _ & P0 & P1). unfold m. assert (1 < Rmin (fst (v 0%nat tau)) (fst (v 1%nat tau))) by (apply Rmin_glb_lt; lra). lra. }
  intros t Ht. specialize (A t Ht). unfold m in A. pose proof (Rmin_l (fst (v 0%nat t)) (fst (v 1%nat t))). pose proof (Rmin_r (fst (v 0%nat t)) (fst (v 1%nat t))). lra.
Qed.
Lemma pm_gap r v th : pair_motion r v th -> forall t, 0 <= t -> 0 < fst (r 1%nat t) - fst (r 0%nat t) /\ dist01 r t = fst (r 1%nat t) - fst (r 0%nat t).
Proof.
  intros M. assert (F : forall t, 0 <= t -> dist01 r t = Rabs (fst (r 1%nat t) - fst (r 0%nat t))).
  { intros t Ht. destruct (pm_line r v th t M) with (t := t) as (Y & _); [intros s Hs; pose proof (pm_forward r v th M s ltac:(lra)); lra|lra|].
    unfold dist01. replace (r 0%nat t - r 1%nat t)%C with (RtoC (- (fst (r 1%nat t) - fst (r 0%nat t)))) by (apply injective_projections; cbn; [ring|rewrite Y; ring]).
    rewrite Cmod_R. apply Rabs_Ropp. }
  assert (G : forall t, 0 <= t -> 0 < fst (r 1%nat t) - fst (r 0%nat t)).
  { apply (stays (fun t => fst (r 1%nat t) - fst (r 0%nat t))).
    - intros t Ht. destruct (pm_rates r v th t M Ht) as (HR & _). destruct (HR 0%nat ltac:(lia)) as [A0 _]. destruct (HR 1%nat ltac:(lia)) as [A1 _].
      apply velocity_continuous in A0. apply velocity_continuous in A1. now apply continuity_pt_minus.
    - destruct M as [(R0 & R1 & _) _]. rewrite R0, R1. cbn. lra.
    - intros tau Ht H. specialize (H tau ltac:(lra)). pose proof (pm_positive r v th tau M Ht) as D. rewrite F in D by exact Ht. rewrite Rabs_pos_eq in D; lra. }
  intros t Ht. split; [now apply G|]. rewrite F by exact Ht. apply Rabs_pos_eq. specialize (G t Ht). lra.
Qed.
Lemma pm_no_limit r v th (d : R) : pair_motion r v th -> ~ is_lim (dist01 r) p_infty d.
Proof.
  intros M L. destruct (pm_bounds r v th M) as [(c & c0 & Hc) _].
  assert (Dc : c <= d).
  { apply Rnot_lt_le. intros N. pose proof L as L'. apply is_lim_spec in L'. assert (e0 : 0 < c - d) by lra. destruct (L' (mkposreal _ e0)) as [B HB]. cbn [pos] in HB.
    specialize (HB (Rmax 0 B + 1) ltac:(pose proof (Rmax_r 0 B); lra)). specialize (Hc (Rmax 0 B + 1) ltac:(pose proof (Rmax_l 0 B); lra)). apply Rabs_lt_between in HB. lra. }
  assert (d0 : 0 < d) by lra.
  set (p := fun t => (fst (v 1%nat t) - fst (v 0%nat t)) / 2).
  assert (PW : forall t, 0 <= t -> fst (v 0%nat t) + fst (v 1%nat t) = 4 /\ p t ^ 2 = fig2 0 0 2 - fig2 0 0 (dist01 r t) /\ Rabs (p t) <= 1).
  { intros t Ht. destruct (pm_speeds r v th t M Ht) as (S & E & P0 & P1); [intros s Hs; pose proof (pm_forward r v th M s ltac:(lra)); lra|].
    split; [exact S|]. split; [exact E|]. unfold p. apply Rabs_le. lra. }
  assert (Dp : forall t, 0 <= t -> is_derive p t (- fig2' 0 0 (dist01 r t))).
  { intros t Ht. destruct (pm_rates r v th t M Ht) as (_ & [A0 _] & [A1 _]). cbn [fst snd] in A0, A1. destruct (pm_gap r v th M t Ht) as [G E].
    destruct (pm_line r v th t M) with (t := t) as (_ & Q0 & Q1 & _); [intros s Hs; pose proof (pm_forward r v th M s ltac:(lra)); lra|lra|].
    apply (is_derive_ext (fun s => / 2 * (fst (v 1%nat s) - fst (v 0%nat s)))); [intros; unfold p, Rdiv; Rring|].
    eapply D_eq; [apply D_scal, D_minus; [exact A1|exact A0]|]. rewrite Q0, Q1. unfold FF. rewrite E in *. field. lra. }
  set (gp := fun t => (fst (r 1%nat t) - fst (r 0%nat t)) * p t).
  assert (Dg : forall t, 0 <= t -> is_derive gp t (2 * (fig2 0 0 2 - fig2 0 0 (dist01 r t)) - dist01 r t * fig2' 0 0 (dist01 r t))).
  { intros t Ht. destruct (pm_rates r v th t M Ht) as (HR & _). destruct (HR 0%nat ltac:(lia)) as [A0 _]. destruct (HR 1%nat ltac:(lia)) as [A1 _].
    eapply D_eq; [apply (D_mult (fun s => fst (r 1%nat s) - fst (r 0%nat s)) p); [apply D_minus; [exact A1|exact A0]|exact (Dp t Ht)]|].
    destruct (pm_gap r v th M t Ht) as [_ E]. destruct (PW t Ht) as (_ & W & _). cbv beta. rewrite <- E, <- W. unfold p. field. }
  assert (C2 : continuous (fig2 0 0) d) by (apply (ex_derive_continuous (fig2 0 0)); eexists; apply (proj1 fig2_repels d d0)).
  assert (C2' : continuous (fig2' 0 0) d).
  { apply (ex_derive_continuous (fig2' 0 0)). assert (d ^ 3 <> 0) by (apply pow_nonzero; lra). unfold fig2'. auto_derive. simpl in *. split; [assumption|split; [lra|exact I]]. }
  assert (L2 := is_lim_comp_continuous (dist01 r) (fig2 0 0) p_infty d L C2). assert (L2' := is_lim_comp_continuous (dist01 r) (fig2' 0 0) p_infty d L C2').
  assert (Z1 : - fig2' 0 0 d = 0).
  { apply (rate_0 p (fun t => - fig2' 0 0 (dist01 r t)) (- fig2' 0 0 d) 1 0 Dp); [exact (is_lim_opp _ p_infty _ L2')|intros t Ht; now apply PW]. }
  assert (D1 : d = 1).
  { unfold fig2' in Z1. assert (Q : (2 / d ^ 3) * (d ^ 2 - 1) = 0) by (replace (2 / d ^ 3 * (d ^ 2 - 1)) with (- (- (- 2 / d ^ 3 + 2 / d))) by (field; lra); lra).
    apply Rmult_integral in Q. destruct Q as [Q|Q]; [|nra]. assert (0 < 2 / d ^ 3) by (apply Rdiv_lt_0_compat; [lra|now apply pow_lt]). lra. }
  assert (Z2 : 2 * (fig2 0 0 2 - fig2 0 0 d) - d * fig2' 0 0 d = 0).
  { pose proof L as L'. apply is_lim_spec in L'. destruct (L' (mkposreal 1 Rlt_0_1)) as [B HB]. cbn [pos] in HB.
    apply (rate_0 gp (fun t => 2 * (fig2 0 0 2 - fig2 0 0 (dist01 r t)) - dist01 r t * fig2' 0 0 (dist01 r t)) _ (d + 1) (Rmax 0 B + 1) Dg).
    - assert (X : is_lim (fun t => fig2 0 0 2 - fig2 0 0 (dist01 r t)) p_infty (fig2 0 0 2 - fig2 0 0 d)) by exact (is_lim_minus' _ _ _ _ _ (is_lim_const _ _) L2).
      assert (X2 : is_lim (fun t => 2 * (fig2 0 0 2 - fig2 0 0 (dist01 r t))) p_infty (2 * (fig2 0 0 2 - fig2 0 0 d))) by exact (is_lim_scal_l _ 2 _ _ X).
      assert (Y : is_lim (fun t => dist01 r t * fig2' 0 0 (dist01 r t)) p_infty (d * fig2' 0 0 d)) by exact (is_lim_mult _ _ p_infty d (fig2' 0 0 d) L L2' I).
      exact (is_lim_minus' _ _ _ _ _ X2 Y).
    - intros t Ht. pose proof (Rmax_l 0 B). pose proof (Rmax_r 0 B). destruct (pm_gap r v th M t ltac:(lra)) as [G E]. destruct (PW t ltac:(lra)) as (_ & _ & W). specialize (HB t ltac:(lra)).
      apply Rabs_lt_between in HB.
      unfold gp. rewrite Rabs_mult, (Rabs_pos_eq (fst (r 1%nat t) - fst (r 0%nat t))) by lra. rewrite <- E in *. pose proof (Rabs_pos (p t)). nra. }
  rewrite D1 in Z1, Z2. rewrite fig2_at_2 in Z2. destruct fig2_shape as (_ & _ & V21 & _). change (fig2 0 0 1) with (V2 1) in Z2. rewrite V21 in Z2.
  assert (3 / 8 < ln 2); [|lra]. rewrite <- (ln_exp (3 / 8)). apply ln_increasing; [apply exp_pos|].
  assert (E : exp (3 / 8) * exp (- (3 / 8)) = 1) by (rewrite <- exp_plus, Rplus_opp_r; apply exp_0). pose proof (exp_ineq1 (- (3 / 8)) ltac:(lra)). pose proof (exp_pos (3 / 8)). nra.
Qed.
Lemma sqrt_rate (f : R -> R) l t : (forall s, is_derive f s (l s)) -> is_derive (fun s => f (sqrt 2 * s)) t (sqrt 2 * l (sqrt 2 * t)).
Proof. intros D. eapply D_eq; [apply (D_comp f (fun s => sqrt 2 * s)); [apply D|apply D_scal, D_id]|]. ring. Qed.
Lemma propIV3b_3_proved : propIV3b_3.
Proof.
  split.
  - assert (Y0 : 0 < 2 * ln 2) by (pose proof ln_lt_2; lra). destruct (swing_exists (2 * ln 2) Y0) as (a & b & M & A0 & B0 & _).
    assert (A2 : a 0 = 2) by (rewrite A0; replace (2 * ln 2 / 2) with (ln 2) by field; apply exp_ln; lra).
    assert (W2 : W (2 * ln 2) < 1).
    { unfold W. assert (E : exp (- (2 * ln 2)) = / 2 * / 2) by (replace (- (2 * ln 2)) with (- ln 2 + - ln 2) by ring; rewrite exp_plus, !exp_Ropp, exp_ln by lra; reflexivity).
      rewrite E. pose proof ln2_small. lra. }
    assert (S2 : sqrt 2 * sqrt 2 = 2) by (apply sqrt_sqrt; lra). assert (S0 : 0 < sqrt 2) by (apply sqrt_lt_R0; lra).
    set (x := fun (i : nat) (t : R) => 2 * t + 1 + - sgn2 i * (a (sqrt 2 * t) / 2)). set (y := fun (i : nat) (t : R) => 2 + - sgn2 i * (sqrt 2 * b (sqrt 2 * t) / 2)).
    exists (on_line x), (on_line y), zero_heading. split.
    + unfold pair_start, on_line, x, y, sgn2. rewrite !Rmult_0_r, A2, B0. repeat split; f_equal; field.
    + intros t _. destruct (M (sqrt 2 * t)) as (P & _ & _ & Bb). set (d := a (sqrt 2 * t)) in *. set (c := b (sqrt 2 * t)) in *.
      assert (Da : is_derive (fun s => a (sqrt 2 * s)) t (sqrt 2 * c)) by (apply (sqrt_rate a b); intros; apply M).
      assert (Db : is_derive (fun s => b (sqrt 2 * s)) t (sqrt 2 * - fig2' 0 0 d)) by (apply (sqrt_rate b (fun s => - fig2' 0 0 (a s))); intros; apply M).
      apply line_closed.
      * intros i Hi. split; [|split].
        -- unfold x, y. fold c. apply (is_derive_ext (fun s => (2 * s + 1) + - sgn2 i * (/ 2 * a (sqrt 2 * s)))); [intros; unfold Rdiv; Rring|].
           eapply D_eq; [apply (D_plus (fun s => 2 * s + 1) (fun s => - sgn2 i * (/ 2 * a (sqrt 2 * s)))); [apply (D_plus (fun s => 2 * s) (fun s => 1)); [apply D_scal, D_id|apply
             D_const]|apply D_scal, D_scal, Da]|].
           field.
        -- unfold y. fold c. assert (K : Rabs (sqrt 2 * c / 2) <= 1). { apply Rabs_le. assert ((sqrt 2 * c / 2) ^ 2 <= 1); [|split; nra].
          replace ((sqrt 2 * c / 2) ^ 2) with (sqrt 2 * sqrt 2 * c ^ 2 / 4) by field. rewrite S2. lra. }
           apply Rabs_le_between in K. destruct i; cbn; lra.
        -- assert (Dy : is_derive (y i) t (sgn2 i * fig2' 0 0 d)).
           { unfold y. apply (is_derive_ext (fun s => 2 + - sgn2 i * (sqrt 2 / 2 * b (sqrt 2 * s)))); [intros; unfold Rdiv; Rring|].
             eapply D_eq; [apply (D_plus (fun s => 2) (fun s => - sgn2 i * (sqrt 2 / 2 * b (sqrt 2 * s)))); [apply D_const|apply D_scal, D_scal, Db]|].
             replace (0 + - sgn2 i * (sqrt 2 / 2 * (sqrt 2 * - fig2' 0 0 d))) with (sgn2 i * (sqrt 2 * sqrt 2 / 2 * fig2' 0 0 d)) by field. rewrite S2. field. }
           assert (X01 : x 0%nat t - x 1%nat t = - d) by (unfold x, sgn2; fold d; field). assert (X10 : x 1%nat t - x 0%nat t = d) by (unfold x, sgn2; fold d; field).
           eapply D_eq; [exact Dy|]. unfold push. destruct i as [|[|]]; [| |lia]; cbn [Sum]; unfold complete; cbn [Nat.eqb negb]; unfold sgn2.
           ++ change (fig2' 0 1) with (fig2' 0 0). rewrite X01, Rabs_Ropp, Rabs_pos_eq by lra. field. lra.
           ++ change (fig2' 1 0) with (fig2' 0 0). rewrite X10, Rabs_pos_eq by lra. field. lra.
      * intros i j Hi Hj E. unfold x. fold d. destruct i as [|[|]], j as [|[|]]; try lia; try discriminate E; cbn [sgn2]; lra.
      * intros i j s _ _ Hs. apply (proj1 fig2_repels s Hs).
  - intros r v th St M0. assert (M : pair_motion r v th) by (split; assumption). split; [|intros d; exact (pm_no_limit r v th d M)].
    intros t i Ht Hi. destruct (pm_line r v th t M) with (t := t) as (_ & _ & _ & H0 & H1); [intros s Hs; pose proof (pm_forward r v th M s ltac:(lra)); lra|lra|].
    destruct i as [|[|]]; [exact H0|exact H1|lia].
Qed.
(* tanner1.Vt_inv clause 2 (stated after the theorems had been seen): refuted, there is a bound c whose set Omega a motion leaves *)
Definition Vt_inv_2 : Prop := ~ forall n adj r v th T c, simple_connected n adj ->
  (forall t, 0 <= t <= T -> closed n adj fig2 fig2' r v th t /\ forall i, (i < n)%nat -> ex_derive (th i) t) ->
  Vt n adj fig2 (fun i => r i 0) (fun i => v i 0) (fun i => th i 0) <= c ->
  forall t, 0 <= t <= T -> Vt n adj fig2 (fun i => r i t) (fun i => v i t) (fun i => th i t) <= c.
Lemma Vt_inv_2_proved : Vt_inv_2.
Proof.
  intros H. apply Vt_inv_1_proved. intros n adj r v th T SC M s t Hst Ht.
  specialize (H n adj (fun i x => r i (x + s)) (fun i x => v i (x + s)) (fun i x => th i (x + s)) (T - s)
    (Vt n adj fig2 (fun i => r i s) (fun i => v i s) (fun i => th i s)) SC). cbv beta in H. rewrite Rplus_0_l in H.
  replace t with (t - s + s) by ring. apply H; [|lra|lra]. intros x Hx. destruct (M (x + s) ltac:(lra)) as [[L Hh] Dt].
  assert (Sh : forall (f : R -> R) l, is_derive f (x + s) l -> is_derive (fun y => f (y + s)) x l).
  { intros f l D. eapply D_eq; [apply (D_comp f (fun y => y + s)); [exact D|apply (D_plus (fun y => y) (fun _ => s)); [apply D_id|apply D_const]]|]. ring. }
  split; [split|].
  - intros i Hi. destruct (L i Hi) as ([A1 A2] & [B1 B2] & K). split; [split; [exact (Sh (fun y => fst (r i y)) _ A1)|exact (Sh (fun y => snd (r i y)) _ A2)]|].
    split; [split; [exact (Sh (fun y => fst (v i y)) _ B1)|exact (Sh (fun y => snd (v i y)) _ B2)]|]. exact K.
  - exact Hh.
  - intros i Hi. destruct (Dt i Hi) as [l D]. exists l. exact (Sh (th i) _ D).
Qed.
