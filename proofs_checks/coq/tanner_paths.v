(* Tanner, Jadbabaie, Pappas: in a connected graph of n vertices a walk of at most n - 1 edges joins any two.
     tanner2.bound_r (corrected), tanner1.anyV (by tanner1_motion.turning_cohesion). *)
From Coq Require Import Reals Lra Lia List Relations.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums paley_model paley_phase paley_laplacian paley_gradient paley_particles tanner_energy tanner_flock.
Open Scope R_scope.

(* from i along the vertices of l to j *)
Fixpoint walk (n : nat) (adj : graph) (i : nat) (l : list nat) (j : nat) : Prop :=
  match l with
  | nil => i = j
  | k :: rest => arc n adj i k /\ walk n adj k rest j
  end.

Lemma walk_from n adj i l1 m l2 : forall k l, walk n adj k l i -> k :: l = l1 ++ m :: l2 -> walk n adj m l2 i.
Proof.
  induction l1 as [|a l1 IH]; intros k l W Eq; injection Eq as -> ->; [exact W|].
  destruct (l1 ++ m :: l2) as [|b rest] eqn:F; [now destruct l1|]. destruct W as [_ W]. now apply (IH b rest).
Qed.
Lemma NoDup_end (l1 l : list nat) : NoDup (l1 ++ l) -> NoDup l.
Proof. induction l1 as [|a l1 IH]; [easy|]. intros N. inversion N. now apply IH. Qed.
Lemma simple_walk n adj j l : forall i, walk n adj i l j -> exists l', walk n adj i l' j /\ NoDup (i :: l').
Proof.
  induction l as [|k l IH]; intros i W.
  - exists nil. split; [exact W|]. constructor; [easy|constructor].
  - destruct W as [A W]. destruct (IH k W) as [l' [W' N]]. destruct (in_dec Nat.eq_dec i (k :: l')) as [I|I].
    + destruct (in_split _ _ I) as [l1 [l2 Eq]]. exists l2. split; [now apply (walk_from n adj j l1 i l2 k l')|].
      rewrite Eq in N. now apply NoDup_end in N.
    + exists (k :: l'). split; [now split|]. now constructor.
Qed.
Lemma walk_below n adj j l : forall i, (i < n)%nat -> walk n adj i l j -> incl (i :: l) (seq 0 n).
Proof.
  induction l as [|k l IH]; intros i Hi W x Hx.
  - destruct Hx as [<-|[]]. apply in_seq. lia.
  - destruct W as [A W]. destruct Hx as [<-|Hx]; [apply in_seq; lia|]. now apply (IH k (proj1 (proj2 A)) W).
Qed.
Lemma joined n adj i j : strongly_connected n adj -> (i < n)%nat -> (j < n)%nat -> exists l, walk n adj i l j /\ (length l <= n - 1)%nat.
Proof.
  intros SC Hi Hj. assert (E : exists l, walk n adj i l j).
  { pose proof (SC i j Hi Hj) as P. apply clos_rt_rt1n in P. clear Hi Hj. induction P as [i|i k j A P [l W]]; [now exists nil|now exists (k :: l)]. }
  destruct E as [l W]. destruct (simple_walk n adj j l i W) as [l' [W' N]]. exists l'. split; [exact W'|].
  pose proof (NoDup_incl_length N (walk_below n adj j l' i Hi W')) as L. rewrite seq_length in L. cbn in L. lia.
Qed.
Lemma walk_length n adj (r : nat -> C) D j l : (forall i k, arc n adj i k -> norm (r i - r k)%C <= D) ->
  forall i, walk n adj i l j -> norm (r i - r j)%C <= INR (length l) * D.
Proof.
  intros B. induction l as [|k l IH]; intros i W.
  - cbn in W. subst. replace (r j - r j)%C with (RtoC 0) by ring. unfold norm. rewrite Cmod_0. cbn. lra.
  - destruct W as [A W]. specialize (IH k W). specialize (B i k A). cbn [length]. rewrite S_INR.
    replace (r i - r j)%C with ((r i - r k) + (r k - r j))%C by ring. unfold norm in *.
    eapply Rle_trans; [apply Cmod_triangle|]. lra.
Qed.

(* D is at least V_e^{-1}(c) for every edge e *)
Theorem bound_r_corrected n adj V V' r v c D : (1 <= n)%nat -> undirected adj -> no_loops adj -> strongly_connected n adj ->
  (forall i j, V i j = V j i) -> (forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> potential (V i j) (V' i j)) ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> r i <> r j) -> Wenergy n adj V r v <= c -> 0 <= D ->
  (forall i j s, (i < n)%nat -> (j < n)%nat -> adj i j = true -> 0 < s -> V i j s <= c -> s <= D) ->
  forall i j, (i < n)%nat -> (j < n)%nat -> norm (r i - r j)%C <= (INR n - 1) * D.
Proof.
  intros Hn S NL SC VS Pot NC Hc HD B i j Hi Hj. destruct (joined n adj i j SC Hi Hj) as [l [W L]].
  apply Rle_trans with (INR (length l) * D).
  - apply (walk_length n adj r D j l); [|exact W]. intros a b (Ha & Hb & A). assert (A' : adj a b = true) by (now rewrite S).
    apply (B a b); try assumption; [apply norm_neq; now apply NC|]. apply Rle_trans with (2 := Hc).
    now apply (pair_bound n adj V V').
  - apply Rmult_le_compat_r; [exact HD|]. apply le_INR in L. rewrite minus_INR in L by lia. cbn in L. lra.
Qed.

(* the Gram determinant of three vectors of the plane is 0 *)
Lemma gram (a b c : C) :
  inner a a * (inner b b * inner c c - inner b c * inner b c) - inner a b * (inner a b * inner c c - inner b c * inner a c) +
  inner a c * (inner a b * inner b c - inner b b * inner a c) = 0.
Proof. rewrite !inner_xy. ring. Qed.
