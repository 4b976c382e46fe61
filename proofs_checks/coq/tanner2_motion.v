(* Tanner, Jadbabaie, Pappas, Part II, fixed graph: motions under (4) from a start in which no linked agents are in one place.
   The law is demanded only at times when it has a value; that linked agents never coincide is the conclusion.
     tanner2.thm1b, tanner2.cor3, tanner2.thm1a. *)
From Coq Require Import Reals Lra Lia Psatz.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums paley_model paley_phase paley_laplacian paley_gradient paley_particles tanner_energy tanner_flock.
Open Scope R_scope.

Definition distinct (n : nat) (adj : graph) (r : nat -> C) : Prop :=
  forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> r i <> r j.

(* agents (1) at time t, with the control (4) where it has a value *)
Definition moves (n : nat) (adj : graph) (V' : nat -> nat -> R -> R) (r v : nat -> R -> C) (t : R) : Prop :=
  (forall i, (i < n)%nat -> is_velocity (r i) t (v i t)) /\
  (distinct n adj (fun i => r i t) ->
   forall i, (i < n)%nat -> is_velocity (v i) t (control4 n adj V' (fun i => r i t) (fun i => v i t) i)).

Section Motion.
Variables (n : nat) (adj : graph) (V V' : nat -> nat -> R -> R) (r v : nat -> R -> C).
Hypothesis S : undirected adj.
Hypothesis NL : no_loops adj.
Hypothesis VS : forall i j, V i j = V j i.
Hypothesis VS' : forall i j, V' i j = V' j i.
Hypothesis Pot : forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> potential (V i j) (V' i j).
Hypothesis Start : distinct n adj (fun i => r i 0).
Notation E t := (Wenergy n adj V (fun i => r i t) (fun i => v i t)).

Lemma energy_before t : 0 <= t -> (forall s, 0 <= s <= t -> moves n adj V' r v s /\ distinct n adj (fun i => r i s)) -> E t <= E 0.
Proof.
  intros Ht H.
  apply (decreasing (fun t => E t) (fun t => - qform (2 * n) (kron2 (lap n adj)) (stack (fun i => v i t))) 0 t Ht).
  - intros x Hx. destruct (H x Hx) as [[HR HU] A].
    apply (eq9 n adj V V' r v x S VS' HR A); [|now apply HU].
    intros i j Hi Hj L. apply (Pot i j Hi Hj L), norm_neq. now apply A.
  - intros x Hx. destruct (H x Hx) as [[HR HU] A].
    destruct (eq9 n adj V V' r v x S VS' HR A) as (_ & _ & P); [|now apply HU|lra].
    intros i j Hi Hj L. apply (Pot i j Hi Hj L), norm_neq. now apply A.
Qed.

(* linked agents keep a distance that depends on the start only, for as long as the motion lasts *)
Theorem linked_apart : exists d, 0 < d /\ forall T, (forall t, 0 <= t < T -> moves n adj V' r v t) ->
  forall t i j, 0 <= t < T -> (i < n)%nat -> (j < n)%nat -> adj i j = true -> d <= norm (r i t - r j t)%C.
Proof.
  destruct (linked_distances n adj V V' (E 0) S NL VS Pot) as [d [D [Hd L]]]. exists d. split; [exact Hd|]. intros T H t i j Ht.
  apply (kept_apart n adj r v d t Hd); [intros s k Hs; apply H; lra|exact Start| |lra].
  intros s Hs A a b Ha Hb Lk. apply (L (fun i => r i s) (fun i => v i s)); try assumption; [apply A; lra|].
  apply energy_before; [lra|]. intros y Hy. split; [apply H; lra|exact (A y ltac:(lra))].
Qed.

(* Theorem 1 for every motion that goes on for all t >= 0: that linked agents never coincide is no hypothesis *)
Hypothesis Hn : (1 <= n)%nat.
Hypothesis SC : strongly_connected n adj.
Hypothesis C1 : forall i j s, (i < n)%nat -> (j < n)%nat -> adj i j = true -> 0 < s -> continuity_pt (V' i j) s.
Hypothesis H : forall t, 0 <= t -> moves n adj V' r v t.
Lemma never_meet t i j : 0 <= t -> (i < n)%nat -> (j < n)%nat -> adj i j = true -> r i t <> r j t.
Proof.
  intros Ht Hi Hj A Eq. destruct linked_apart as [d [Hd L]].
  specialize (L (t + 1) (fun x Hx => H x ltac:(lra)) t i j ltac:(lra) Hi Hj A). rewrite Eq in L.
  replace (r j t - r j t)%C with (RtoC 0) in L by ring. unfold norm in L. rewrite Cmod_0 in L. lra.
Qed.
Theorem motions_agree i j : (i < n)%nat -> (j < n)%nat ->
  forall e, 0 < e -> exists T, 0 <= T /\ forall t, T <= t -> norm (v i t - v j t)%C < e.
Proof.
  apply (velocities_agree n adj V V' r v); try assumption; [intros; now apply never_meet|intros; now apply H|].
  intros t k Ht Hk. apply (proj2 (H t Ht)); [|exact Hk]. intros a b Ha Hb. now apply never_meet.
Qed.
Theorem motions_to_mean i : (i < n)%nat ->
  forall e, 0 < e -> exists T, 0 <= T /\ forall t, T <= t -> norm (v i t - centre n (fun j => v j 0))%C < e.
Proof.
  apply (velocities_to_mean n adj V V' r v); try assumption; [intros; now apply never_meet|intros; now apply H|].
  intros t k Ht Hk. apply (proj2 (H t Ht)); [|exact Hk]. intros a b Ha Hb. now apply never_meet.
Qed.
End Motion.
