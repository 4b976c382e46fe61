(* Tanner, Jadbabaie, Pappas, Part I: the mechanical energy, which the alignment does not change, and what it decides.
     tanner1.Vt_inv, tanner1.propIV3b, tanner1.collision, tanner1.anyV (corrected), tanner1.decoupled (part).
   At the end a motion that stops: Proposition IV.3 read as including that the motion exists for all t >= 0. *)
From Coq Require Import Reals Lra Lia Psatz.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums paley_model paley_phase paley_laplacian paley_gradient paley_particles tanner_energy tanner_flock tanner_paths tanner1_heading tanner1_examples.
Open Scope R_scope.

Definition mechanical (n : nat) (adj : graph) (V : nat -> nat -> R -> R) (r v : nat -> C) : R :=
  / 2 * Sum n (fun i => V_i n adj V r i + inner (v i) (v i)).

(* agents (1) with the control (4), (5) at time t; th are the headings that the law uses, whatever they are *)
Definition steered (n : nat) (adj : graph) (V V' : nat -> nat -> R -> R) (r v : nat -> R -> C) (th : nat -> R -> R) (t : R) : Prop :=
  (forall i, (i < n)%nat -> is_velocity (r i) t (v i t)) /\
  (forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> r i t <> r j t) /\
  (forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true ->
     is_derive (V i j) (norm (r i t - r j t)%C) (V' i j (norm (r i t - r j t)%C))) /\
  (forall i, (i < n)%nat -> is_velocity (v i) t (accel n adj V' (fun j => r j t) (fun j => v j t) (fun j => th j t) i)).

Section Energy.
Variables (n : nat) (adj : graph) (V V' : nat -> nat -> R -> R) (r v : nat -> R -> C) (th : nat -> R -> R).
Hypothesis S : undirected adj.
Hypothesis VS : forall i j, V' i j = V' j i.
Notation E := (fun s => mechanical n adj V (fun i => r i s) (fun i => v i s)).

Lemma mechanical_rate t : steered n adj V V' r v th t -> is_derive E t 0.
Proof.
  intros (HR & HN & HV & HU).
  pose proof (energy_chain n (fun i j s => w adj i j * V i j (norm (r i s - r j s)%C)) (pair_grad adj V' (fun i => r i t)) v
    (accel n adj V' (fun j => r j t) (fun j => v j t) (fun j => th j t)) t
    (linked_rate n adj V V' r v t HR HN HV) (fun i j _ _ => pair_grad_antisym adj V' S VS (fun i => r i t) i j) HU) as D.
  eapply D_eq; [exact D|]. cbv beta. rewrite <- Sum_plus. apply Sum_zero. intros i _. rewrite <- inner_plus. unfold accel, grad_i.
  replace (Csum n (fun j => pair_grad adj V' (fun i => r i t) i j) + (- Csum n (pair_grad adj V' (fun i => r i t) i) + gyro n adj (fun j => r j t) (fun j => v j t) (fun j => th j t) i))%C
    with (gyro n adj (fun j => r j t) (fun j => v j t) (fun j => th j t) i).
  - exact (gyro_no_work n adj (fun j => r j t) (fun j => v j t) (fun j => th j t) i).
  - change (Csum n (fun j => pair_grad adj V' (fun i => r i t) i j)) with (Csum n (pair_grad adj V' (fun i => r i t) i)).
    set (A := Csum n _). set (B := gyro _ _ _ _ _ _). ring.
Qed.

(* constant as long as the motion lasts *)
Theorem mechanical_constant T : (forall t, 0 <= t < T -> steered n adj V V' r v th t) -> forall t, 0 <= t < T -> E t = E 0.
Proof.
  intros H t Ht. destruct (Req_dec t 0) as [->|N]; [reflexivity|]. symmetry.
  apply (eq_is_derive E 0 t); [|lra]. intros x Hx. apply mechanical_rate, H. lra.
Qed.

(* V_ij of a linked pair is at most twice the energy, where no potential is negative *)
Lemma pair_energy t : steered n adj V V' r v th t ->
  (forall i j s, (i < n)%nat -> (j < n)%nat -> 0 < s -> 0 <= V i j s) ->
  forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> V i j (norm (r i t - r j t)%C) <= 2 * E t.
Proof.
  intros (_ & HN & _ & _) P i j Hi Hj A. unfold mechanical.
  assert (G : forall a b, (a < n)%nat -> (b < n)%nat -> 0 <= w adj a b * V a b (norm (r a t - r b t)%C)).
  { intros a b Ha Hb. unfold w. destruct (adj a b) eqn:F; [|lra]. rewrite Rmult_1_l. apply P; try assumption. now apply norm_neq, HN. }
  assert (K : V i j (norm (r i t - r j t)%C) <= V_i n adj V (fun i => r i t) i).
  { replace (V i j (norm (r i t - r j t)%C)) with (w adj i j * V i j (norm (r i t - r j t)%C)) by (unfold w; rewrite A; ring).
    unfold V_i. apply (Sum_term_le n (fun b => w adj i b * V i b (norm (r i t - r b t)%C)) j); [|exact Hj]. intros b Hb. now apply G. }
  assert (L2 : V_i n adj V (fun i => r i t) i + inner (v i t) (v i t) <= Sum n (fun i => V_i n adj V (fun i => r i t) i + inner (v i t) (v i t))).
  { apply (Sum_term_le n (fun i => V_i n adj V (fun i => r i t) i + inner (v i t) (v i t)) i); [|exact Hi]. intros b Hb.
    pose proof (inner_self_ge0 (v b t)). assert (0 <= V_i n adj V (fun i => r i t) b); [|lra]. apply Sum_ge0. intros; now apply G. }
  pose proof (inner_self_ge0 (v i t)). lra.
Qed.

(* linked agents keep a distance, one for all T: V_ij >= 0 is unbounded at 0 *)
Theorem linked_apart :
  (forall i j s, (i < n)%nat -> (j < n)%nat -> 0 < s -> 0 <= V i j s) ->
  (forall i j M, (i < n)%nat -> (j < n)%nat -> exists d, 0 < d /\ forall s, 0 < s < d -> M < V i j s) ->
  forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true ->
  exists d, 0 < d /\ forall T, (forall t, 0 <= t < T -> steered n adj V V' r v th t) ->
    forall t, 0 <= t < T -> d <= norm (r i t - r j t)%C.
Proof.
  intros P U i j Hi Hj A. destruct (U i j (2 * E 0) Hi Hj) as (d & Hd & B). exists d. split; [exact Hd|]. intros T H t Ht.
  destruct (Rle_lt_dec d (norm (r i t - r j t)%C)) as [|L]; [assumption|]. exfalso.
  pose proof (pair_energy t (H t Ht) P i j Hi Hj A) as Q. pose proof (mechanical_constant T H t Ht) as M.
  destruct (H t Ht) as (_ & HN & _ & _). specialize (B _ (conj (norm_neq _ _ (HN i j Hi Hj A)) L)). cbv beta in *. lra.
Qed.

(* all distances of a connected graph stay bounded, one bound for all T: V_ij >= 0 is unbounded at infinity *)
Theorem cohesion : strongly_connected n adj ->
  (forall i j s, (i < n)%nat -> (j < n)%nat -> 0 < s -> 0 <= V i j s) ->
  (forall i j M, (i < n)%nat -> (j < n)%nat -> exists D, forall s, D < s -> M < V i j s) ->
  exists B, forall T, (forall t, 0 <= t < T -> steered n adj V V' r v th t) ->
    forall t i j, 0 <= t < T -> (i < n)%nat -> (j < n)%nat -> norm (r i t - r j t)%C <= B.
Proof.
  intros SC P U.
  destruct (uniform_pairs n (fun i j b => forall s, b < s -> 2 * E 0 < V i j s)) as [D [HD B]].
  { intros i j b b' Q Le s Hs. apply Q. lra. }
  { intros i j Hi Hj. now apply U. }
  exists (INR n * D). intros T H t i j Ht Hi Hj. destruct (joined n adj i j SC Hi Hj) as [l [W L]].
  apply Rle_trans with (INR (length l) * D).
  - apply (walk_length n adj (fun i => r i t) D j l); [|exact W]. intros a b (Ha & Hb & A).
    assert (A' : adj a b = true) by (now rewrite S). apply Rnot_lt_le. intros F. specialize (B a b Ha Hb _ F).
    pose proof (pair_energy t (H t Ht) P a b Ha Hb A') as Q. pose proof (mechanical_constant T H t Ht) as M. cbv beta in *. lra.
  - apply Rmult_le_compat_r; [lra|]. apply le_INR. lia.
Qed.
End Energy.

(* ---- Proposition IV.3 with headings for all t >= 0: a motion that ends; that motions are unique is not proved ---- *)
(* two functions that agree before a have the same derivative there *)
Lemma left_derivative (f g : R -> R) a l m : is_derive f a l -> is_derive g a m ->
  (forall x, 0 <= x < a -> f x = g x) -> 0 < a -> l = m.
Proof.
  intros F G Ex Ha. destruct (Req_dec l m) as [|N]; [assumption|]. exfalso.
  assert (D : derivable_pt_lim (fun x => f x - g x) a (l - m)) by (apply is_derive_Reals, D_minus; assumption).
  assert (P : 0 < Rabs (l - m) / 3) by (apply Rdiv_lt_0_compat; [apply Rabs_pos_lt; lra|lra]).
  destruct (D _ P) as [d Hd]. set (k := - (Rmin d a / 2)).
  assert (K : 0 < Rmin d a / 2 < d /\ Rmin d a / 2 < a).
  { pose proof (cond_pos d). pose proof (Rmin_l d a). pose proof (Rmin_r d a). assert (0 < Rmin d a) by (apply Rmin_glb_lt; lra). lra. }
  assert (A : forall h, k <= h < 0 -> Rabs ((0 - (f a - g a)) / h - (l - m)) < Rabs (l - m) / 3).
  { intros h Hh. assert (X : f (a + h) - g (a + h) = 0) by (rewrite Ex; [ring|unfold k in Hh; lra]).
    rewrite <- X. apply Hd; [lra|]. rewrite Rabs_left; unfold k in Hh; lra. }
  pose proof (A k ltac:(unfold k; lra)) as A1. pose proof (A (k / 2) ltac:(unfold k; lra)) as A2.
  replace ((0 - (f a - g a)) / (k / 2)) with (2 * ((0 - (f a - g a)) / k)) in A2 by (field; unfold k; lra).
  set (q := (0 - (f a - g a)) / k) in *. apply Rabs_lt_between in A1, A2.
  unfold Rabs in A1, A2. destruct (Rcase_abs (l - m)); lra.
Qed.
Lemma early_speed t : 0 <= t < PI / 12 -> forall i, 0 < swing_speed (/ 4) i t.
Proof.
  intros Ht i. pose proof PI_RGT_0. assert (0 <= sin (2 * t)) by (apply sin_ge_0; lra).
  assert (sin (2 * t) < / 2).
  { replace (/ 2) with (1 / 2) by field. rewrite <- sin_PI6. apply sin_increasing_1; lra. }
  unfold swing_speed. destruct i; lra.
Qed.
Lemma swing_stops : is_velocity (swing (/ 4) 0) (PI / 12) (RtoC 0).
Proof.
  split; cbn; [|apply D_const]. eapply D_eq; [apply D_plus; [apply D_scal, D_id|apply D_scal, D_gap]|].
  replace (2 * (PI / 12)) with (PI / 6) by field. rewrite sin_PI6. field.
Qed.
(* two linked agents on a line with the common velocity 1/4 and the heading 0: at t = pi/12 the front one stands still, and no
   motion that agrees with this one before has a heading there *)
Theorem propIV3a_ends :
  (forall t, 0 <= t < PI / 12 -> closed_loop 2 complete (fun _ _ => Vh') (swing (/ 4)) (swing_speed (/ 4)) (fun _ _ => 0) t) /\
  forall (r : nat -> R -> C) (s th : nat -> R -> R), (forall t i, 0 <= t < PI / 12 -> (i < 2)%nat -> r i t = swing (/ 4) i t) ->
    ~ closed_loop 2 complete (fun _ _ => Vh') r s th (PI / 12).
Proof.
  split; [intros t Ht; apply swing_loop; now apply early_speed|].
  intros r s th A L. destruct (L 0%nat ltac:(lia)) as (Hs & _ & [V1 V2] & _). pose proof PI_RGT_0. destruct swing_stops as [W1 W2].
  assert (E1 := left_derivative _ _ _ _ _ V1 W1 (fun x Hx => f_equal fst (A x 0%nat Hx ltac:(lia))) ltac:(lra)).
  assert (E2 := left_derivative _ _ _ _ _ V2 W2 (fun x Hx => f_equal snd (A x 0%nat Hx ltac:(lia))) ltac:(lra)).
  cbn in E1, E2. rewrite Rmult_0_l, Rminus_0_r in E1. rewrite Rmult_0_l, Rplus_0_r in E2.
  pose proof (sin2_cos2 (th 0%nat (PI / 12))) as T. unfold Rsqr in T.
  destruct (Rmult_integral _ _ E1) as [Z|Z]; [lra|]. destruct (Rmult_integral _ _ E2) as [Y|Y]; [lra|]. rewrite Z, Y in T. lra.
Qed.

(* V_t passes every bound as two linked agents approach each other *)
Theorem Vt_linked n adj (V : nat -> nat -> R -> R) (v : nat -> C) (th : nat -> R) i j c :
  (forall i j s, (i < n)%nat -> (j < n)%nat -> 0 < s -> 0 <= V i j s) ->
  (forall i j M, (i < n)%nat -> (j < n)%nat -> exists d, 0 < d /\ forall s, 0 < s < d -> M < V i j s) ->
  (i < n)%nat -> (j < n)%nat -> adj i j = true ->
  exists d, 0 < d /\ forall r, (forall a b, (a < n)%nat -> (b < n)%nat -> adj a b = true -> r a <> r b) ->
    norm (r i - r j)%C < d -> c < Vt n adj V r v th.
Proof.
  intros P U Hi Hj A. destruct (U i j (2 * c) Hi Hj) as [d [Hd B]]. exists d. split; [exact Hd|]. intros r HN L.
  specialize (B _ (conj (norm_neq _ _ (HN i j Hi Hj A)) L)).
  assert (G : forall a b, (a < n)%nat -> (b < n)%nat -> 0 <= w adj a b * V a b (norm (r a - r b)%C)).
  { intros a b Ha Hb. unfold w. destruct (adj a b) eqn:F; [|lra]. rewrite Rmult_1_l. apply P; try assumption. now apply norm_neq, HN. }
  assert (K : V i j (norm (r i - r j)%C) <= V_i n adj V r i).
  { replace (V i j (norm (r i - r j)%C)) with (w adj i j * V i j (norm (r i - r j)%C)) by (unfold w; rewrite A; ring).
    unfold V_i. apply (Sum_term_le n (fun b => w adj i b * V i b (norm (r i - r b)%C)) j); [|exact Hj]. intros b Hb. now apply G. }
  assert (L2 : V_i n adj V r i + inner (v i) (v i) + th i ^ 2 <= Sum n (fun i => V_i n adj V r i + inner (v i) (v i) + th i ^ 2)).
  { apply (Sum_term_le n (fun i => V_i n adj V r i + inner (v i) (v i) + th i ^ 2) i); [|exact Hi]. intros b Hb.
    pose proof (inner_self_ge0 (v b)). pose proof (pow2_ge_0 (th b)). assert (0 <= V_i n adj V r b); [|lra]. apply Sum_ge0. intros; now apply G. }
  pose proof (inner_self_ge0 (v i)). pose proof (pow2_ge_0 (th i)). unfold Vt. lra.
Qed.
