(* Veerman, Stosic, Olvera, section 6, communication graphs on a line: how the peak response of the last car grows with their number.
     beyond.veerman.growth.
   Car k of the graphs here tracks one car, parent k, and answers with gamma to the power of minus its depth; the last cars form a chain of about p log M. *)
From Coq Require Import Reals Lra Lia Relations.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums veerman_complex veerman_front.
From Flockproof Require paley_model.
Open Scope R_scope.

(* follower k tracks the agents j with sees k j, of 0, .., M; 0 is the leader *)
Definition number (M : nat) (sees : nat -> nat -> bool) (k : nat) : R := Sum (S M) (fun j => if sees k j then 1 else 0).
Definition mean (M : nat) (sees : nat -> nat -> bool) (z : nat -> C) (k : nat) : C :=
  (RtoC (/ number M sees k) * paley_model.Csum (S M) (fun j => if sees k j then z j else RtoC 0))%C.
(* z_k'' = f (z_k - m_k) + g (z_k' - m_k') *)
Definition follows (f g : R) (M : nat) (sees : nat -> nat -> bool) (z u : nat -> R -> C) : Prop :=
  forall k t, (1 <= k <= M)%nat -> Cderive (z k) t (u k t) /\
    Cderive (u k) t (f * (z k t - mean M sees (fun j => z j t) k) + g * (u k t - mean M sees (fun j => u j t) k))%C.
(* the equilibrium oscillation behind a leader of amplitude 1 and frequency w: all deviations are a_k e^{i w t} *)
Definition oscillation (f g : R) (M : nat) (sees : nat -> nat -> bool) (w : R) (a : nat -> C) : Prop := a 0%nat = RtoC 1 /\
  follows f g M sees (fun k t => (a k * cis (w * t))%C) (fun k t => ((0, w) * (a k * cis (w * t)))%C).
(* the largest amplitude of the last car over all frequencies *)
Definition peak (f g : R) (M : nat) (sees : nat -> nat -> bool) (A : R) : Prop :=
  (forall w a, 0 < w -> oscillation f g M sees w a -> Cmod (a M) <= A) /\ exists w a, 0 < w /\ oscillation f g M sees w a /\ Cmod (a M) = A.
(* from the leader a path leads to k: each agent is tracked by the next one *)
Definition reached (M : nat) (sees : nat -> nat -> bool) (k : nat) : Prop :=
  clos_refl_trans nat (fun i j => (i <= M)%nat /\ (1 <= j <= M)%nat /\ sees j i = true) 0%nat k.

(* ---- every car tracks one ---- *)
Definition tree (parent : nat -> nat) (k j : nat) : bool := Nat.eqb j (parent k).
Lemma delta_if i p (x : R) : (if Nat.eqb i p then x else 0) = delta i p * x.
Proof. unfold delta. destruct (Nat.eqb i p); ring. Qed.
Lemma Csum_one n p (z : nat -> C) : (p < n)%nat -> paley_model.Csum n (fun j => if Nat.eqb j p then z j else RtoC 0) = z p.
Proof.
  intros H. apply injective_projections; unfold paley_model.Csum; cbn [fst snd].
  - rewrite <- (Sum_delta n p (fun j => fst (z j)) H). apply Sum_ext. intros j _. rewrite <- delta_if. now destruct (Nat.eqb j p).
  - rewrite <- (Sum_delta n p (fun j => snd (z j)) H). apply Sum_ext. intros j _. rewrite <- delta_if. now destruct (Nat.eqb j p).
Qed.
Lemma mean_tree M parent z k : (parent k <= M)%nat -> mean M (tree parent) z k = z (parent k).
Proof.
  intros H. unfold mean, number, tree. rewrite Csum_one by lia.
  rewrite (Sum_ext (S M) _ (fun j => delta j (parent k) * 1)) by (intros; apply delta_if). rewrite (Sum_delta (S M) (parent k) (fun _ => 1)) by lia.
  rewrite Rinv_1. ring.
Qed.
Section Trees.
Variables (f g : R) (M : nat) (parent : nat -> nat).
Hypotheses (Hf : f < 0) (Hg : g < 0).
Hypothesis below : forall k, (1 <= k <= M)%nat -> (parent k < k)%nat.
Lemma oscillation_tree w a : oscillation f g M (tree parent) w a <-> a 0%nat = RtoC 1 /\ forall k, (1 <= k <= M)%nat -> a k = (/ gamma f g w * a (parent k))%C.
Proof.
  pose proof (num_neq0 f g w Hf Hg) as NZ.
  assert (S1 : forall k, ((- w ^ 2)%R * a k = f * (a k - a (parent k)) + (0, w)%R * g * (a k - a (parent k)))%C <-> a k = (/ gamma f g w * a (parent k))%C).
  { intros k. rewrite inv_gamma by assumption.
    assert (R : ((f * (a k - a (parent k)) + (0, w)%R * g * (a k - a (parent k))) - (- w ^ 2)%R * a k = num f g w * a k - den f g w * a (parent k))%C)
      by (apply injective_projections; cbn; ring).
    apply Cminus_iff in R. split; intros H.
    - symmetry in H. apply R in H. apply (Cmult_cancel_r _ _ (num f g w) NZ). rewrite Cmult_comm, H. unfold Cdiv.
      replace (den f g w * / num f g w * a (parent k) * num f g w)%C with (den f g w * a (parent k) * (/ num f g w * num f g w))%C by ring. rewrite Cinv_l by exact NZ. ring.
    - symmetry. apply R. rewrite H. unfold Cdiv.
      replace (num f g w * (den f g w * / num f g w * a (parent k)))%C with (num f g w * / num f g w * (den f g w * a (parent k)))%C by ring. rewrite Cinv_r by exact NZ. ring. }
  unfold oscillation, follows. split; intros [A0 H]; (split; [exact A0|]); intros k.
  - intros Hk. destruct (H k 0 Hk) as [_ D]. rewrite !mean_tree in D by (specialize (below k Hk); lia).
    apply S1. pose proof (Cderive_unique _ _ _ _ D (Cderive_wave2 (a k) w 0)) as U. pose proof (cis_neq0 (w * 0)) as CZ.
    apply (Cmult_cancel_r _ _ _ CZ). rewrite <- Cmult_assoc, <- U. ring.
  - intros t Hk. split; [apply Cderive_wave|]. rewrite !mean_tree by (specialize (below k Hk); lia). pose proof (Cderive_wave2 (a k) w t) as D.
    rewrite Cmult_assoc in D. rewrite (proj2 (S1 k) (H k Hk)) in D.
    match goal with |- Cderive _ _ ?d => replace d with ((f * (a k - a (parent k)) + (0, w) * g * (a k - a (parent k))) * cis (w * t))%C by ring end. exact D.
Qed.
Lemma all_reached k : (k <= M)%nat -> reached M (tree parent) k.
Proof.
  induction k as [k IH] using (well_founded_induction lt_wf). intros Hk. destruct (Nat.eq_dec k 0) as [->|N]; [apply rt_refl|].
  assert (K : (1 <= k <= M)%nat) by lia. specialize (below k K). apply rt_trans with (parent k); [apply IH; lia|]. apply rt_step. split; [lia|]. split; [exact K|]. apply Nat.eqb_refl.
Qed.
Variable depth : nat -> nat.
Hypothesis depth_0 : depth 0%nat = 0%nat.
Hypothesis depth_S : forall k, (1 <= k <= M)%nat -> depth k = S (depth (parent k)).
Lemma oscillation_depth w a : oscillation f g M (tree parent) w a -> forall k, (k <= M)%nat -> a k = Cpw (/ gamma f g w)%C (depth k).
Proof.
  intros H. apply oscillation_tree in H. destruct H as [A0 H]. intros k. induction k as [k IH] using (well_founded_induction lt_wf). intros Hk.
  destruct (Nat.eq_dec k 0) as [->|N]; [now rewrite depth_0|]. assert (K : (1 <= k <= M)%nat) by lia. specialize (below k K).
  rewrite (H k K), (depth_S k K), (IH (parent k)) by lia. reflexivity.
Qed.
Lemma oscillation_exists w : oscillation f g M (tree parent) w (fun k => Cpw (/ gamma f g w)%C (depth k)).
Proof. apply oscillation_tree. split; [now rewrite depth_0|]. intros k Hk. now rewrite (depth_S k Hk). Qed.
End Trees.
(* the largest answer of one car to the one it tracks *)
Lemma best f g : f < 0 -> g < 0 -> exists w, 0 < w /\ 1 < Cmod (/ gamma f g w)%C /\ forall w', Cmod (/ gamma f g w')%C <= Cmod (/ gamma f g w)%C.
Proof.
  intros Hf Hg. destruct (strongest_root f g Hf Hg) as [[V0 V1] _]. set (v := strongest f g) in *. exists (sqrt v). assert (W2 : sqrt v ^ 2 = v) by (rewrite pow2_sqrt; lra).
  split; [now apply sqrt_lt_R0|]. split; [apply gain_above_one; try assumption; rewrite W2, Rabs_left by lra; lra|].
  intros w'. destruct (gain_strongest f g (sqrt v) Hf Hg) as (_ & H & _). now apply H.
Qed.
Lemma peak_tree f g M parent depth : f < 0 -> g < 0 -> (forall k, (1 <= k <= M)%nat -> (parent k < k)%nat) -> depth 0%nat = 0%nat ->
  (forall k, (1 <= k <= M)%nat -> depth k = S (depth (parent k))) -> forall w, 0 < w -> (forall w', Cmod (/ gamma f g w')%C <= Cmod (/ gamma f g w)%C) ->
  peak f g M (tree parent) (Cmod (/ gamma f g w)%C ^ depth M).
Proof.
  intros Hf Hg B D0 DS w Hw Best. split.
  - intros w' a _ O. rewrite (oscillation_depth f g M parent Hf Hg B depth D0 DS w' a O M) by lia. rewrite Cmod_Cpw. apply pow_incr. split; [apply Cmod_ge_0|apply Best].
  - exists w, (fun k => Cpw (/ gamma f g w)%C (depth k)). split; [exact Hw|]. split; [now apply oscillation_exists|]. apply Cmod_Cpw.
Qed.
(* system (1): everyone tracks the car in front; the peak is G^M with one G > 1 *)
Theorem one_sided_growth f g : f < 0 -> g < 0 -> exists G, 1 < G /\ forall M, peak f g M (tree pred) (G ^ M).
Proof.
  intros Hf Hg. destruct (best f g Hf Hg) as (w & W0 & G1 & Best). exists (Cmod (/ gamma f g w)%C). split; [exact G1|]. intros M.
  apply (peak_tree f g M pred (fun k => k)); try assumption; try reflexivity; intros; lia.
Qed.
(* the last L cars are a chain, the others track the leader *)
Definition chain_parent (M L k : nat) : nat := if Nat.leb k (M - L + 1) then 0%nat else pred k.
Definition chain_depth (M L k : nat) : nat := if Nat.eqb k 0 then 0%nat else if Nat.leb k (M - L + 1) then 1%nat else (k - (M - L))%nat.
Theorem every_degree f g p : f < 0 -> g < 0 -> 0 <= p -> exists c1 c2, 0 < c1 /\ 0 < c2 /\ forall M, (1 <= M)%nat -> exists sees,
  (forall k, (1 <= k <= M)%nat -> sees k k = false /\ exists j, (j <= M)%nat /\ sees k j = true) /\ (forall k, (k <= M)%nat -> reached M sees k) /\
  exists A, peak f g M sees A /\ c1 * Rpower (INR M) p <= A <= c2 * Rpower (INR M) p.
Proof.
  intros Hf Hg Hp. destruct (best f g Hf Hg) as (w & W0 & G1 & Best). set (G := Cmod (/ gamma f g w)%C) in *.
  assert (L0 : 0 < ln G) by (rewrite <- ln_1; apply ln_increasing; lra). set (l := ln G) in *. set (K := Rmax 0 ((p + 1) * ln ((p + 1) / l))).
  assert (K0 : 0 <= K) by apply Rmax_l. exists (exp (- K)), G. split; [apply exp_pos|]. split; [lra|]. intros M HM.
  assert (M1 : 1 <= INR M) by (apply (le_INR 1); exact HM). assert (lM : 0 <= ln (INR M)) by (rewrite <- ln_1; destruct M1 as [M1|<-]; [left; apply ln_increasing; lra|lra]).
  set (x := p * ln (INR M)) in *. assert (X0 : 0 <= x) by (apply Rmult_le_pos; assumption).
  assert (pos : forall n, G ^ n = exp (INR n * l)) by (intros n; rewrite <- (exp_ln (G ^ n)) by (apply pow_lt; lra); f_equal; unfold l; apply ln_pow; lra).
  (* x <= M l + K *)
  assert (XM : x <= INR M * l + K).
  { set (y := INR M * l / (p + 1)). assert (Y0 : 0 < y) by (unfold y; apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat; lra|lra]).
    assert (E : INR M = y * ((p + 1) / l)) by (unfold y; field; split; lra). pose proof (exp_ineq1_le (ln y)) as Q. rewrite exp_ln in Q by exact Y0.
    assert (LE : ln (INR M) = ln y + ln ((p + 1) / l)) by (rewrite E at 1; apply ln_mult; [exact Y0|apply Rdiv_lt_0_compat; lra]).
    assert (x <= (p + 1) * ln (INR M)) by (unfold x; nra). pose proof (Rmax_r 0 ((p + 1) * ln ((p + 1) / l))) as KR. fold K in KR.
    assert ((p + 1) * y = INR M * l) by (unfold y; field; lra). nra. }
  (* the length of the chain *)
  destruct (Rle_or_lt 0 (x / l)) as [Z|Z]; [|apply (Rmult_lt_compat_r l) in Z; [|exact L0]; unfold Rdiv in Z; rewrite Rmult_assoc, Rinv_l in Z; lra].
  destruct (nfloor_ex (x / l) Z) as [n [N1 N2]]. apply (Rmult_le_compat_r l) in N1; [|lra]. apply (Rmult_lt_compat_r l) in N2; [|exact L0].
  unfold Rdiv in N1, N2. rewrite Rmult_assoc, Rinv_l, Rmult_1_r in N1, N2 by lra.
  set (L := Nat.min (S n) M). assert (HL : (1 <= L <= M)%nat) by (unfold L; lia).
  assert (B : forall k, (1 <= k <= M)%nat -> (chain_parent M L k < k)%nat) by (intros k Hk; unfold chain_parent; destruct (Nat.leb k (M - L + 1)); lia).
  exists (tree (chain_parent M L)). split; [|split; [intros k Hk; now apply (all_reached M (chain_parent M L) B)|]].
  - intros k Hk. specialize (B k Hk). split; [apply Nat.eqb_neq; lia|]. exists (chain_parent M L k). split; [lia|apply Nat.eqb_refl].
  - exists (G ^ L). split.
    + assert (D : chain_depth M L M = L) by (unfold chain_depth; destruct (Nat.eqb_spec M 0); [lia|]; destruct (Nat.leb_spec M (M - L + 1)); lia).
      assert (P : peak f g M (tree (chain_parent M L)) (Cmod (/ gamma f g w)%C ^ chain_depth M L M)); [|rewrite D in P; exact P].
      apply peak_tree; try assumption; [reflexivity|]. intros k Hk. unfold chain_depth, chain_parent. destruct (Nat.eqb_spec k 0); [lia|]. destruct (Nat.leb_spec k (M - L + 1)); [reflexivity|].
      destruct (Nat.eqb_spec (pred k) 0); [lia|]. destruct (Nat.leb_spec (pred k) (M - L + 1)); lia.
    + unfold Rpower. fold x. rewrite pos. assert (EG : G = exp l) by (unfold l; rewrite exp_ln; lra). rewrite EG. rewrite <- !exp_plus.
      assert (E : forall a b, a <= b -> exp a <= exp b) by (intros a b [Q| ->]; [left; now apply exp_increasing|lra]).
      assert (I : INR L <= INR n + 1) by (rewrite <- S_INR; apply le_INR; unfold L; lia).
      split; apply E; [|nra]. destruct (Nat.le_gt_cases (S n) M) as [Q|Q].
      * replace L with (S n) by (unfold L; lia). rewrite S_INR. lra.
      * replace L with M by (unfold L; lia). lra.
Qed.
