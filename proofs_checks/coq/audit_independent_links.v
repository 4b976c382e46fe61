(* Theorems that the proofs of the independent statements go around: what each says of a clause, with the definitions of those statements.
   Stated after the theorems had been seen: paley.vatt and paley.vrep (corrected), paley.zero.dir clause 3, paley.energy clause 2,
   paley.eq3 clauses 1, 2, paley.Rball, paley.eq7 clause 4 (motions at all times), paley.unbal, tanner2.eq14 clauses 1, 3. *)
From Coq Require Import Reals Lra Lia Relations.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums paley_model paley_phase.
From Flockproof Require paley_laplacian paley_fish paley_behaviours paley_particles tanner_energy tanner_graph tanner2_filippov.
From Flockproof Require audit_independent_paley audit_independent_particles audit_independent_tanner2.
Module P := audit_independent_particles.
Module T := audit_independent_tanner2.
Open Scope R_scope.

(* the fields of the neighbours, towards them and away from them *)
Definition fields : Prop := forall n (adj : graph) (r : nat -> C) k, (forall j, (j < n)%nat -> adj k j = true -> r j <> r k) ->
  let away := Csum n (fun j => if adj k j then (r k - r j) / RtoC (Cmod (r k - r j)) else 0)%C in
  let distances z := Sum n (fun j => if adj k j then Cmod (z - r j)%C else 0) in
  (is_derive (fun s => distances (r k + RtoC s * away)%C) 0 (Cmod away ^ 2) /\
   is_derive (fun s => distances (r k + RtoC s * - away)%C) 0 (- Cmod away ^ 2)) /\
  forall v, v = away \/ v = Copp away -> forall K (th : R -> R) a b, 0 < K -> a <= b ->
    (forall t, a <= t <= b -> is_derive th t (K * (cos (th t) * snd v - sin (th t) * fst v))) ->
    cos (th a) * fst v + sin (th a) * snd v <= cos (th b) * fst v + sin (th b) * snd v.
Definition zero_dir_3 : Prop := forall n (adj : graph) th, (1 <= n)%nat ->
  (/ (2 * INR n) * Sum n (fun k => inner (expi (th k)) (Csum n (fun j => RtoC (lap n adj k j) * expi (th j)))%C) = 0 <->
   forall j k, clos_refl_sym_trans nat (fun a b => (a < n)%nat /\ (b < n)%nat /\ adj b a = true) j k -> cos (th j) = cos (th k) /\ sin (th j) = sin (th k)).
(* particles of speed one; u k t is the rate of the heading of k at t *)
Definition moving n (r : nat -> R -> C) (th : nat -> R -> R) (u : nat -> R -> R) := forall k t, (k < n)%nat ->
  is_derive (fun s => fst (r k s)) t (cos (th k t)) /\ is_derive (fun s => snd (r k s)) t (sin (th k t)) /\ is_derive (th k) t (u k t).
Definition energy : Prop := forall n r th u, moving n r th u -> forall t,
  is_derive (fun s => Sum n (fun k => / 2 * (cos (th k s) ^ 2 + sin (th k s) ^ 2))) t 0.
Definition straight : Prop := forall n r th, moving n r th (fun _ _ => 0) -> forall k t, (k < n)%nat ->
  th k t = th k 0 /\ fst (r k t) = fst (r k 0) + t * cos (th k 0) /\ snd (r k t) = snd (r k 0) + t * sin (th k 0).
Definition circles : Prop := forall n r th w0, w0 <> 0 -> moving n r th (fun _ _ => w0) -> forall k, (k < n)%nat ->
  exists (c : C) phi, forall t, r k t = (c + RtoC (/ Rabs w0) * expi (phi + w0 * t))%C.
Definition ball : Prop := forall n r th w0, (1 <= n)%nat -> w0 <> 0 -> moving n r th (fun _ _ => w0) ->
  exists c : C, forall t, Cmod (RtoC (/ INR n) * Csum n (fun k => r k t) - c)%C <= / Rabs w0.
Definition balanced_rests : Prop := forall n r th u, moving n r th u ->
  (forall t, (RtoC (/ INR n) * Csum n (fun k => expi (th k t)))%C = 0%C) ->
  forall t, (RtoC (/ INR n) * Csum n (fun k => r k t))%C = (RtoC (/ INR n) * Csum n (fun k => r k 0))%C.
Definition clusters : Prop := forall n (th : nat -> R) a w0 K1 k, (k < n)%nat -> (forall j, (j < n)%nat -> th j = a \/ th j = a + PI) ->
  w0 + - K1 * inner (Ci * expi (th k))%C (RtoC (/ INR n) * Csum n (fun j => expi (th j)))%C = w0.
Definition rest14 : Prop := forall n adj V V' r v t, (1 <= n)%nat -> T.simple_graph adj -> T.potentials n adj V V' -> T.motion n adj V' r v -> 0 <= t ->
  let a i := T.law4 n adj V' (fun i => r i t) (fun i => v i t) i in
  (Sum n (fun i => fst (a i)) = 0 /\ Sum n (fun i => snd (a i)) = 0) /\
  ((forall i j, (i < n)%nat -> (j < n)%nat -> a i = a j) -> forall i, (i < n)%nat -> a i = 0%C).

Lemma away_is n (adj : graph) (r : nat -> C) k : (forall j, (j < n)%nat -> adj k j = true -> r j <> r k) ->
  Csum n (fun j => if adj k j then (r k - r j) / RtoC (Cmod (r k - r j)) else 0)%C =
  Csum n (fun j => RtoC (if adj k j then 1 else 0) * paley_fish.unit_from (r k) (r j))%C.
Proof.
  intros N. apply Csum_ext. intros j Hj. destruct (adj k j) eqn:A; [|ring]. unfold paley_fish.unit_from, Cdiv. rewrite RtoC_inv; [ring|].
  intros Z. apply Cmod_eq_0 in Z. apply (N j Hj A). replace (r k) with ((r k - r j) + r j)%C by ring. rewrite Z. ring.
Qed.
Lemma distances_is n (adj : graph) (r : nat -> C) k z : Sum n (fun j => if adj k j then Cmod (z - r j)%C else 0) = Sum n (fun j => (if adj k j then 1 else 0) * Cmod (z - r j)%C).
Proof. apply Sum_ext. intros j _. destruct (adj k j); ring. Qed.
Lemma fields_hold : fields.
Proof.
  intros n adj r k N away distances. destruct (paley_behaviours.attraction n (adj k) r k N) as [A1 A2]. destruct (paley_behaviours.repulsion n (adj k) r k N) as [B1 B2].
  rewrite <- (away_is n adj r k N) in A1, A2, B1, B2. fold away in A1, A2, B1, B2. split; [split|].
  - eapply is_derive_ext; [intros s; symmetry; apply distances_is|exact B1].
  - rewrite Cmod_opp in A1. eapply is_derive_ext; [intros s; symmetry; apply distances_is|exact A1].
  - intros v Hv K th a b HK Hab D.
    assert (E : forall t, inner (expi (th t)) v = cos (th t) * fst v + sin (th t) * snd v) by (intros; apply inner_xy).
    rewrite <- !E. assert (D' : forall t, a <= t <= b -> is_derive th t (K * inner (Ci * expi (th t))%C v)).
    { intros t Ht. eapply D_eq; [now apply D|]. rewrite inner_xy. cbn. ring. }
    destruct Hv as [->| ->]; [now apply (B2 K th)|now apply (A2 K th)].
Qed.
Lemma zero_dir_3_holds : zero_dir_3.
Proof.
  intros n adj th Hn. pose proof (paley_laplacian.W1_weakly n adj th Hn) as W. rewrite <- P.W12_is in W. unfold P.W12 in W. rewrite W. split; intros H j k J.
  - specialize (H j k J). injection H as H1 H2. now split.
  - destruct (H j k J) as [H1 H2]. unfold expi. now rewrite H1, H2.
Qed.
Lemma velocity n r th u : moving n r th u -> forall k t, (k < n)%nat -> is_velocity (r k) t (expi (th k t)).
Proof. intros M k t Hk. destruct (M k t Hk) as (A & B & _). now split. Qed.
Lemma energy_holds : energy.
Proof.
  intros n r th u M t. pose proof (paley_particles.energy_total n th (fun k => u k t) t (fun k Hk => proj2 (proj2 (M k t Hk)))) as E.
  revert E. apply is_derive_ext. intros s. apply Sum_ext. intros k _. f_equal. unfold Cmod, expi. cbn [fst snd]. apply pow2_sqrt.
  pose proof (pow2_ge_0 (cos (th k s))). pose proof (pow2_ge_0 (sin (th k s))). lra.
Qed.
Lemma straight_holds : straight.
Proof.
  intros n r th M k t Hk. destruct (paley_particles.straight_line (r k) (th k) (fun s => velocity n r th _ M k s Hk) (fun s => proj2 (proj2 (M k s Hk))) t) as [A B].
  split; [exact A|]. rewrite B. cbn. split; ring.
Qed.
Lemma circles_hold : circles.
Proof.
  intros n r th w0 N M k Hk. destruct (paley_particles.circle w0 (r k) (th k) N (fun s => velocity n r th _ M k s Hk) (fun s => proj2 (proj2 (M k s Hk)))) as (A & _ & phi & B).
  exists (paley_particles.circle_centre w0 (r k 0) (th k 0)), phi. intros t. specialize (B t). rewrite (A t) in B. rewrite <- B. ring.
Qed.
Lemma ball_holds : ball.
Proof.
  intros n r th w0 Hn N M. exact (paley_fish.centre_ball n w0 r th Hn N (fun k t Hk => velocity n r th _ M k t Hk) (fun k t Hk => proj2 (proj2 (M k t Hk)))).
Qed.
Lemma balanced_rests_holds : balanced_rests.
Proof. intros n r th u M B t. exact (balanced_fixed_centre n r th (fun k s Hk => velocity n r th u M k s Hk) B t 0). Qed.
Lemma clusters_hold : clusters.
Proof. exact paley_fish.clusters_rest. Qed.
Lemma rest14_holds : rest14.
Proof.
  intros n adj V V' r v t Hn S P M Ht a. pose proof (T.apart_always n adj V V' r v S P M t Ht) as A. pose proof (T.slopes_of n adj V V' P) as D.
  assert (E : forall i, (i < n)%nat -> a i = tanner_energy.control4 n adj (tanner2_filippov.both V') (fun i => r i t) (fun i => v i t) i).
  { intros i Hi. rewrite <- T.law4_is. destruct (T.both_law n adj V V' (fun i => r i t) (fun i => v i t) i (proj1 S) (proj1 P) D Hi A) as (_ & _ & ->). reflexivity. }
  assert (U : forall i, (i < n)%nat -> is_velocity (v i) t (tanner_energy.control4 n adj (tanner2_filippov.both V') (fun i => r i t) (fun i => v i t) i)).
  { intros i Hi. rewrite <- E by exact Hi. now apply (T.moves_law n adj V). }
  destruct (tanner_graph.eq14_sum n adj (tanner2_filippov.both V') r v t (proj1 S) (tanner2_filippov.both_sym V') U) as [Z1 Z2]. split; [split|].
  - rewrite <- Z1. apply Sum_ext. intros i Hi. now rewrite E.
  - rewrite <- Z2. apply Sum_ext. intros i Hi. now rewrite E.
  - intros Q i Hi. rewrite E by exact Hi. apply (tanner_graph.eq14 n adj (tanner2_filippov.both V') r v t Hn (proj1 S) (tanner2_filippov.both_sym V') U); [|exact Hi].
    intros j k Hj Hk. rewrite <- !E by assumption. now apply Q.
Qed.
