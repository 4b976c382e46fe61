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
Notation square i j := (fun s => inner (r i s - r j s)%C (r i s - r j s)%C).

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

Lemma square_near i j t : (i < n)%nat -> (j < n)%nat -> moves n adj V' r v t ->
  forall e, 0 < e -> exists d, 0 < d /\ forall s, Rabs (s - t) < d -> Rabs (square i j s - square i j t) < e.
Proof.
  intros Hi Hj [HR _] e He. pose proof (velocity_minus (r i) (r j) t _ _ (HR i Hi) (HR j Hj)) as VM.
  pose proof (D_inner _ _ t _ _ VM VM) as D. apply is_derive_Reals in D.
  assert (Ct : continuity_pt (square i j) t) by (apply derivable_continuous_pt; eexists; exact D).
  destruct (Ct e He) as [d [Hd B]]. exists d. split; [exact Hd|]. intros s Hs.
  destruct (Req_dec s t) as [->|N]; [rewrite Rminus_eq_0, Rabs_R0; exact He|].
  apply B. split; [split; [exact I|congruence]|exact Hs].
Qed.

(* linked agents keep a distance that depends on the start only, for as long as the motion lasts *)
Theorem linked_apart : exists d, 0 < d /\ forall T, (forall t, 0 <= t < T -> moves n adj V' r v t) ->
  forall t i j, 0 <= t < T -> (i < n)%nat -> (j < n)%nat -> adj i j = true -> d <= norm (r i t - r j t)%C.
Proof.
  destruct (linked_distances n adj V V' (E 0) S NL VS Pot) as [d [D [Hd L]]]. exists d. split; [exact Hd|]. intros T H t1.
  pose (kept := fun s => forall x, 0 <= x <= s -> forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> d ^ 2 <= square i j x).
  assert (K1 : forall s, 0 <= s < T -> (forall x, 0 <= x <= s -> distinct n adj (fun i => r i x)) -> kept s).
  { intros s Hs A x Hx i j Hi Hj Lk. rewrite <- norm_sqr, <- Rsqr_pow2. fold (Rsqr (norm (r i x - r j x)%C)). apply Rsqr_incr_1; [|lra|apply norm_ge0].
    apply (L (fun i => r i x) (fun i => v i x)); try assumption; [now apply A|].
    apply energy_before; [lra|]. intros y Hy. split; [apply H; lra|apply A; lra]. }
  assert (K2 : forall s, kept s -> forall x, 0 <= x <= s -> distinct n adj (fun i => r i x)).
  { intros s Ks x Hx i j Hi Hj Lk Eq. specialize (Ks x Hx i j Hi Hj Lk). cbv beta in Ks. rewrite Eq in Ks.
    replace (r j x - r j x)%C with (RtoC 0) in Ks by ring. rewrite inner_xy in Ks. cbn in Ks. nra. }
  assert (Main : forall t, 0 <= t < T -> kept t).
  { intros t Ht.
    assert (K0 : kept 0).
    { apply K1; [lra|]. intros x Hx. replace x with 0 by lra. exact Start. }
    destruct (completeness (fun s => 0 <= s <= t /\ kept s)) as [m [Ub Lub]].
    { exists t. intros s [Hs _]. lra. }
    { exists 0. split; [lra|exact K0]. }
    assert (M0 : 0 <= m) by (apply Ub; split; [lra|exact K0]).
    assert (M1 : m <= t) by (apply Lub; intros s [Hs _]; lra).
    assert (Before : forall x, 0 <= x < m -> forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> d ^ 2 <= square i j x).
    { intros x Hx i j Hi Hj Lk. apply Rnot_lt_le. intros F.
      assert (m <= x); [|lra]. apply Lub. intros s [Hs Ks]. apply Rnot_lt_le. intros G.
      specialize (Ks x ltac:(lra) i j Hi Hj Lk). cbv beta in Ks, F. lra. }
    assert (Km : kept m).
    { intros x Hx i j Hi Hj Lk. destruct (Rlt_le_dec x m) as [X|X]; [apply Before; try assumption; lra|].
      replace x with m by lra. destruct (Req_dec m 0) as [->|N]; [apply K0; try assumption; lra|].
      apply Rnot_lt_le. intros F. destruct (square_near i j m Hi Hj (H m ltac:(lra)) (d ^ 2 - square i j m)) as [e [He B]]; [cbv beta in F |- *; lra|].
      set (y := Rmax 0 (m - e / 2)).
      assert (Y : 0 <= y < m /\ m - e / 2 <= y).
      { unfold y. pose proof (Rmax_l 0 (m - e / 2)). pose proof (Rmax_r 0 (m - e / 2)). split; [split; [lra|apply Rmax_lub_lt; lra]|lra]. }
      specialize (B y). rewrite Rabs_left in B by lra. specialize (B ltac:(lra)). apply Rabs_def2 in B.
      pose proof (Before y ltac:(lra) i j Hi Hj Lk). cbv beta in *. lra. }
    destruct (Rle_lt_or_eq_dec m t M1) as [Lt| ->]; [exfalso|exact Km].
    destruct (uniform_pairs n (fun i j b => 0 < b /\ (adj i j = true -> forall s, Rabs (s - m) < / b -> 0 < square i j s))) as [b [Hb U]].
    { intros i j b b' [Pb Q] Le. split; [lra|]. intros A s Hs. apply (Q A s).
      apply Rlt_le_trans with (1 := Hs). apply Rinv_le_contravar; lra. }
    { intros i j Hi Hj. destruct (adj i j) eqn:A; [|exists 1; split; [lra|discriminate]].
      pose proof (Km m ltac:(lra) i j Hi Hj A) as Q.
      destruct (square_near i j m Hi Hj (H m ltac:(lra)) (d ^ 2)) as [e [He B]]; [nra|].
      exists (/ e). split; [now apply Rinv_0_lt_compat|]. intros _ s Hs.
      rewrite Rinv_inv in Hs. specialize (B s Hs). apply Rabs_def2 in B. cbv beta in *. lra. }
    set (y := Rmin t (m + / b / 2)).
    assert (Ib : 0 < / b) by now apply Rinv_0_lt_compat.
    assert (Y : m < y <= t /\ y <= m + / b / 2).
    { unfold y. pose proof (Rmin_l t (m + / b / 2)). pose proof (Rmin_r t (m + / b / 2)). split; [split; [apply Rmin_glb_lt; lra|lra]|lra]. }
    assert (Ky : kept y).
    { apply K1; [lra|]. intros x Hx. destruct (Rle_lt_dec x m) as [X|X]; [apply (K2 m Km); lra|].
      intros i j Hi Hj A Eq. pose proof (proj2 (U i j Hi Hj) A x) as P. rewrite Rabs_pos_eq in P by lra. specialize (P ltac:(lra)). cbv beta in P.
      rewrite Eq in P. replace (r j x - r j x)%C with (RtoC 0) in P by ring. rewrite inner_xy in P. cbn in P. lra. }
    assert (y <= m); [|lra]. apply Ub. split; [lra|exact Ky]. }
  intros i j Ht Hi Hj A. pose proof (Main t1 Ht t1 ltac:(lra) i j Hi Hj A) as Q. cbv beta in Q. rewrite <- norm_sqr, <- Rsqr_pow2 in Q.
  apply Rsqr_incr_0; [exact Q|lra|apply norm_ge0].
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
