(* More theorems that the proofs of the independent statements go around: paley.length, paley.incid (corrected), paley.fig2 clause 2,
   paley.fishpeak, paley.scale clause 2 (corrected), tanner1.Vt_inv clause 2 (corrected), tanner2.eq14 clause 2. In words of their own, stated
   after the theorems had been seen. *)
From Coq Require Import Reals Lra Lia List.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums paley_model paley_phase.
From Flockproof Require paley_laplacian paley_fourier paley_fish tanner_energy tanner_graph tanner1_motion tanner_rates.
From Flockproof Require audit_independent_tanner1.
Module T1 := audit_independent_tanner1.
Open Scope R_scope.

(* all directed edges (j, k), each once: node k senses j *)
Definition directed_edges n (adj : graph) (E : list (nat * nat)) := NoDup E /\
  forall j k, In (j, k) E <-> (j < n)%nat /\ (k < n)%nat /\ adj k j = true.
Fixpoint total (E : list (nat * nat)) (f : nat -> nat -> R) : R := match E with nil => 0 | (j, k) :: E => f j k + total E f end.
Definition Q_L n (adj : graph) (x : nat -> C) : R :=
  / (2 * INR n) * Sum n (fun k => inner (x k) (Csum n (fun j => RtoC (lap n adj k j) * x j)%C)).
Definition length_of_edges : Prop := forall n adj E x, (1 <= n)%nat -> undirected adj -> directed_edges n adj E ->
  Q_L n adj x = / (4 * INR n) * total E (fun j k => Cmod (x j - x k)%C ^ 2).
Definition length_of_pairs : Prop := forall n adj x, (1 <= n)%nat -> undirected adj -> no_loops adj ->
  Q_L n adj x = / (2 * INR n) * Sum n (fun k => Sum k (fun j => if adj k j then Cmod (x j - x k)%C ^ 2 else 0)).
(* B has -1 at the tail and 1 at the head of a directed edge *)
Definition columns_of_B : Prop := forall n adj E k m, undirected adj -> no_loops adj -> directed_edges n adj E -> (k < n)%nat -> (m < n)%nat ->
  let b i j l := (if Nat.eqb i l then 1 else 0) - (if Nat.eqb i j then 1 else 0) in total E (fun j l => b k j l * b m j l) = 2 * lap n adj k m.
Definition polygon : Prop := forall n m k, (1 <= n)%nat -> (k < n)%nat -> let z j := expi (2 * PI * INR m * INR j / INR n) in
  z ((k + 1) mod n)%nat = (expi (2 * PI * INR m / INR n) * z k)%C.
Definition four_fish : Prop := forall a, let z k := expi (if Nat.eqb k 0 then a + PI else a) in
  2 / (3 + 1) * (/ (2 * 4) * Sum 4 (fun k => inner (z k) (Csum 4 (fun j => if Nat.eqb k j then 0 else z k - z j)%C))) = 0.75.
Definition all_others : Prop := forall n adj th, (2 <= n)%nat -> (forall k j, (k < n)%nat -> (j < n)%nat -> adj k j = negb (Nat.eqb k j)) ->
  0 <= 2 / (INR (n - 1) + 1) * (/ (2 * INR n) * Sum n (fun k => inner (expi (th k)) (Csum n (fun j => RtoC (lap n adj k j) * expi (th j))%C))) <= 1.
Definition sublevels : Prop := forall n adj V V' r v a J c t, undirected adj -> T1.symmetric_V V -> 0 <= t -> (forall s, 0 <= s <= t -> T1.jumping n adj V V' r v a J s) ->
  (T1.kinetic_plus_V n adj V (fun i => r i 0) (fun i => v i 0) <= c <-> T1.kinetic_plus_V n adj V (fun i => r i t) (fun i => v i t) <= c).
Definition common_acceleration : Prop := forall n (v : nat -> R -> C) (a : nat -> C) t, (forall s i j, (i < n)%nat -> (j < n)%nat -> v i s = v j s) ->
  (forall i, (i < n)%nat -> is_velocity (v i) t (a i)) -> exists c, forall i, (i < n)%nat -> a i = c.

Lemma edges_is n adj E : directed_edges n adj E -> paley_laplacian.lists_edges n adj E.
Proof. intros [N A]. split; [exact N|exact A]. Qed.
Lemma total_is E f : total E f = paley_laplacian.lsum E (fun e => f (fst e) (snd e)).
Proof. induction E as [|[j k] E IH]; [reflexivity|]. cbn. now rewrite IH. Qed.
Lemma total_ext E f g : (forall j k, f j k = g j k) -> total E f = total E g.
Proof. intros H. induction E as [|[j k] E IH]; [reflexivity|]. cbn. now rewrite H, IH. Qed.
Lemma square_is (z : C) : Cmod z ^ 2 = inner z z.
Proof. rewrite inner_xy. unfold Cmod. rewrite pow2_sqrt; [ring|]. pose proof (pow2_ge_0 (fst z)). pose proof (pow2_ge_0 (snd z)). lra. Qed.
Lemma length_of_edges_holds : length_of_edges.
Proof.
  intros n adj E x Hn S D. pose proof (paley_laplacian.length_corrected n adj E x Hn S (edges_is n adj E D)) as L. unfold Q, row in L. unfold Q_L. rewrite L. f_equal.
  rewrite (total_ext E _ (fun j k => paley_laplacian.dist2 (x j) (x k))) by (intros; apply square_is). now rewrite total_is.
Qed.
Lemma length_of_pairs_holds : length_of_pairs.
Proof.
  intros n adj x Hn S NL. pose proof (paley_laplacian.length_once n adj x Hn S NL) as L. unfold Q, row in L. unfold Q_L. rewrite L. f_equal.
  apply Sum_ext. intros k _. apply Sum_ext. intros j _. unfold w. destruct (adj k j); [rewrite square_is; unfold paley_laplacian.dist2|]; ring.
Qed.
Lemma columns_of_B_hold : columns_of_B.
Proof.
  intros n adj E k m S NL D Hk Hm b. rewrite <- (paley_laplacian.incidence_directed n adj E k m S NL (edges_is n adj E D) Hk Hm), total_is. reflexivity.
Qed.
Lemma polygon_holds : polygon.
Proof. intros n m k Hn Hk z. exact (paley_fourier.wave_polygon n m k Hn Hk). Qed.
Lemma four_fish_holds : four_fish.
Proof.
  intros a z. pose proof (paley_fish.fish_peak a) as F. unfold W1, Q, row in F. replace (INR 3) with 3 in F by (cbn; ring). replace (INR 4) with 4 in F by (cbn; ring).
  rewrite (Sum_ext 4 _ (fun k => inner (z k) (Csum 4 (fun j => RtoC (lap 4 complete k j) * z j)%C))).
  - transitivity (75 / 100); [exact F|lra].
  - intros k Hk. f_equal. generalize z. intros y. unfold Csum, lap, deg, w, complete, delta. cbn [Sum].
    destruct k as [|[|[|[|k]]]]; [..|lia]; apply injective_projections; cbn; ring.
Qed.
Lemma all_others_hold : all_others.
Proof.
  intros n adj th Hn A. apply (paley_fish.scale_all_neighbours n adj (fun _ => RtoC 0) th Hn). intros k Hk. split; [|split].
  - rewrite A by assumption. now rewrite Nat.eqb_refl.
  - unfold deg. rewrite (Sum_ext n (w adj k) (fun j => 1 - delta j k * 1)).
    + rewrite Sum_minus, Sum_const, (Sum_delta n k (fun _ => 1) Hk), minus_INR by lia. cbn. ring.
    + intros j Hj. unfold w, delta. rewrite (A k j Hk Hj), (Nat.eqb_sym j k). destruct (Nat.eqb k j); cbn; ring.
  - intros i j Hi Hj Ni _ B. rewrite (A k i Hk Hi) in B. destruct (Nat.eqb_spec k i) as [E|]; [congruence|discriminate B].
Qed.
Lemma sublevels_hold : sublevels.
Proof.
  intros n adj V V' r v a J c t S VS Ht L. rewrite !T1.energy_is.
  refine (tanner_rates.sublevel_invariant n adj V (T1.both V') r v (T1.rate n adj a r) J c t S (T1.both_sym V') Ht _). intros s Hs. destruct (L s Hs) as [C0 Ls].
  assert (Q : forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> is_derive (V i j) (Cmod (r i s - r j s)%C) (T1.both V' i j (Cmod (r i s - r j s)%C))).
  { intros i j Hi Hj A. destruct (C0 i Hi) as (_ & _ & _ & Ci). destruct (C0 j Hj) as (_ & _ & _ & Cj). apply T1.both_slope; [exact VS|now apply Ci|].
    replace (Cmod (r i s - r j s)%C) with (Cmod (r j s - r i s)%C) by apply tanner_energy.norm_sym. apply Cj; [exact Hi|now rewrite S]. }
  split; [split|split].
  - intros i Hi. now apply (C0 i Hi).
  - intros _ i Hi. split; [now apply (C0 i Hi)|]. split; [now apply (C0 i Hi)|]. intros NJ. rewrite <- T1.law_turned.
    now apply (T1.loop_both n adj V V' r v a s S VS (Ls NJ) i Hi).
  - intros i j Hi Hj A. now apply (C0 i Hi).
  - exact Q.
Qed.
Lemma common_acceleration_holds : common_acceleration.
Proof. intros n v a t E V. apply (tanner_graph.eq14_common n v a t); [|exact V]. intros i j s Hi Hj. now apply E. Qed.
