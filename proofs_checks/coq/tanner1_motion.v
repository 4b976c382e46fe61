(* Tanner, Jadbabaie, Pappas, Part I: the mechanical energy, which the alignment does not change, and what it decides.
     tanner1.Vt_inv, tanner1.propIV3b, tanner1.collision, tanner1.anyV (corrected), tanner1.decoupled (part).
   At the end a motion that stops: Proposition IV.3 read as including that the motion exists for all t >= 0. *)
From Coq Require Import Reals Lra Lia Psatz List.
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
End Energy.

(* ---- whatever the law takes for the differences of headings: the velocity is turned at any rate q_i(t) ---- *)
Definition turned (n : nat) (adj : graph) (V' : nat -> nat -> R -> R) (r v : nat -> C) (q : nat -> R) (i : nat) : C :=
  (- grad_i n adj V' r i + RtoC (q i) * (Ci * v i))%C.
Definition distinct (n : nat) (adj : graph) (r : nat -> C) := forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> r i <> r j.
(* a continuous function with a rate that is not negative, but for finitely many instants *)
Lemma increasing_inside (f : R -> R) a b : a <= b -> (forall x, a <= x <= b -> continuity_pt f x) ->
  (forall x, a < x < b -> exists l, is_derive f x l /\ 0 <= l) -> f a <= f b.
Proof.
  intros Hab C D. destruct (Req_dec a b) as [->|N]; [lra|].
  assert (P : forall x, a < x < b -> derivable_pt f x) by (intros x Hx; apply ex_derive_Reals_0; destruct (D x Hx) as [l [Dl _]]; now exists l).
  destruct (MVT f id a b P (fun c _ => derivable_pt_id c) ltac:(lra) C) as [c [Hc E]].
  { intros c _. apply derivable_continuous_pt, derivable_pt_id. }
  rewrite derive_pt_id in E. destruct (D c Hc) as [l [Dl Hl]]. apply is_derive_Reals in Dl.
  rewrite (derive_pt_eq_0 f c l (P c Hc) Dl) in E. unfold id in E. assert (0 <= (b - a) * l) by (apply Rmult_le_pos; lra). lra.
Qed.
Lemma increasing_but (f : R -> R) L : forall a b, a <= b -> (forall x, a <= x <= b -> continuity_pt f x) ->
  (forall x, a < x < b -> ~ In x L -> exists l, is_derive f x l /\ 0 <= l) -> f a <= f b.
Proof.
  induction L as [|y L IH]; intros a b Hab C D; [now apply increasing_inside; [| |intros x Hx; apply D]|].
  destruct (Rlt_dec a y) as [A|A]; [destruct (Rlt_dec y b) as [B|B]|].
  - apply Rle_trans with (f y); apply IH; try lra; intros x Hx; try (apply C; lra); intros N; (apply D; [lra|intros [E|E]; [lra|contradiction]]).
  - apply IH; try assumption. intros x Hx N. apply D; [exact Hx|intros [E|E]; [lra|contradiction]].
  - apply IH; try assumption. intros x Hx N. apply D; [exact Hx|intros [E|E]; [lra|contradiction]].
Qed.

(* agents (1) at time t; the law is demanded only where it has a value, and not at the times in J, at which headings may jump: there the
   velocities are continuous *)
Definition turning (n : nat) (adj : graph) (V' : nat -> nat -> R -> R) (r v : nat -> R -> C) (q : nat -> R -> R) (J : list R) (t : R) : Prop :=
  (forall i, (i < n)%nat -> is_velocity (r i) t (v i t)) /\
  (distinct n adj (fun i => r i t) ->
   forall i, (i < n)%nat -> continuity_pt (fun s => fst (v i s)) t /\ continuity_pt (fun s => snd (v i s)) t /\
     (~ In t J -> is_velocity (v i) t (turned n adj V' (fun i => r i t) (fun i => v i t) (fun i => q i t) i))).
Section Turning.
Variables (n : nat) (adj : graph) (V V' : nat -> nat -> R -> R) (r v : nat -> R -> C) (q : nat -> R -> R).
Hypothesis S : undirected adj.
Hypothesis VS : forall i j, V' i j = V' j i.
Notation E := (fun s => mechanical n adj V (fun i => r i s) (fun i => v i s)).
Notation slopes := (fun s => forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true ->
  is_derive (V i j) (norm (r i s - r j s)%C) (V' i j (norm (r i s - r j s)%C))).
Lemma turning_rate J t : turning n adj V' r v q J t -> distinct n adj (fun i => r i t) -> slopes t -> ~ In t J -> is_derive E t 0.
Proof.
  intros [HR HT] A HD NJ. assert (HU : forall i, (i < n)%nat -> is_velocity (v i) t (turned n adj V' (fun i => r i t) (fun i => v i t) (fun i => q i t) i)).
  { intros i Hi. now apply (HT A i Hi). }
  pose proof (energy_chain n (fun i j s => w adj i j * V i j (norm (r i s - r j s)%C)) (pair_grad adj V' (fun i => r i t)) v
    (turned n adj V' (fun j => r j t) (fun j => v j t) (fun j => q j t)) t
    (linked_rate n adj V V' r v t HR A HD) (fun i j _ _ => pair_grad_antisym adj V' S VS (fun i => r i t) i j) HU) as D.
  eapply D_eq; [exact D|]. cbv beta. rewrite <- Sum_plus. apply Sum_zero. intros i _. rewrite <- inner_plus. unfold turned, grad_i.
  change (Csum n (fun j => pair_grad adj V' (fun i => r i t) i j)) with (Csum n (pair_grad adj V' (fun i => r i t) i)).
  set (A0 := Csum n _). replace (A0 + (- A0 + RtoC (q i t) * (Ci * v i t)))%C with (RtoC (q i t) * (Ci * v i t))%C by ring.
  rewrite inner_scal, inner_xy. cbn. ring.
Qed.
Lemma continuous_Sum m (f : nat -> R -> R) t : (forall i, (i < m)%nat -> continuity_pt (f i) t) -> continuity_pt (fun s => Sum m (fun i => f i s)) t.
Proof.
  induction m as [|m IH]; intros H; [apply continuity_pt_const; intros ? ?; reflexivity|].
  apply (continuity_pt_plus (fun s => Sum m (fun i => f i s)) (f m)); [apply IH; intros; apply H; lia|apply H; lia].
Qed.
(* through the jumps too the energy is continuous *)
Lemma turning_continuous J t : turning n adj V' r v q J t -> distinct n adj (fun i => r i t) -> slopes t -> continuity_pt E t.
Proof.
  intros [HR HT] A HD. unfold mechanical.
  apply (continuity_pt_mult (fun _ => / 2) (fun s => Sum n (fun i => V_i n adj V (fun i => r i s) i + inner (v i s) (v i s)))); [apply continuity_pt_const; intros ? ?; reflexivity|].
  apply (continuous_Sum n (fun i s => V_i n adj V (fun i => r i s) i + inner (v i s) (v i s))). intros i Hi.
  apply (continuity_pt_plus (fun s => V_i n adj V (fun i => r i s) i) (fun s => inner (v i s) (v i s))).
  - unfold V_i. apply (continuous_Sum n (fun j s => w adj i j * V i j (norm (r i s - r j s)%C))). intros j Hj.
    apply derivable_continuous_pt, ex_derive_Reals_0. eexists. exact (linked_rate n adj V V' r v t HR A HD i j Hi Hj).
  - destruct (HT A i Hi) as (C1 & C2 & _). apply (continuity_pt_ext (fun s => fst (v i s) * fst (v i s) + snd (v i s) * snd (v i s))); [intros; now rewrite inner_xy|].
    apply (continuity_pt_plus (fun s => fst (v i s) * fst (v i s)) (fun s => snd (v i s) * snd (v i s)));
      [now apply (continuity_pt_mult (fun s => fst (v i s)) (fun s => fst (v i s)))|now apply (continuity_pt_mult (fun s => snd (v i s)) (fun s => snd (v i s)))].
Qed.
Theorem turning_constant J t : 0 <= t -> (forall s, 0 <= s <= t -> turning n adj V' r v q J s /\ distinct n adj (fun i => r i s) /\ slopes s) -> E t = E 0.
Proof.
  intros Ht H.
  assert (C : forall x, 0 <= x <= t -> continuity_pt E x) by (intros x Hx; destruct (H x Hx) as (A & B & D); now apply (turning_continuous J)).
  assert (D : forall x, 0 < x < t -> ~ In x J -> is_derive E x 0) by (intros x Hx N; destruct (H x ltac:(lra)) as (A & B & K); now apply (turning_rate J)).
  apply Rle_antisym.
  - apply Ropp_le_cancel. apply (increasing_but (fun x => - E x) J 0 t Ht).
    + intros x Hx. apply (continuity_pt_opp E). now apply C.
    + intros x Hx N. exists (- 0). split; [now apply D_opp, D|lra].
  - apply (increasing_but E J 0 t Ht); [exact C|]. intros x Hx N. exists 0. split; [now apply D|lra].
Qed.
Hypothesis P : forall i j s, (i < n)%nat -> (j < n)%nat -> adj i j = true -> 0 < s -> is_derive (V i j) s (V' i j s) /\ 0 <= V i j s.
Lemma slopes_everywhere t : distinct n adj (fun i => r i t) -> slopes t.
Proof. intros A i j Hi Hj L. apply P; try assumption. apply norm_neq. now apply A. Qed.
Lemma linked_energy t : distinct n adj (fun i => r i t) -> forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true ->
  V i j (norm (r i t - r j t)%C) <= 2 * E t.
Proof.
  intros A i j Hi Hj L. unfold mechanical.
  assert (G : forall a b, (a < n)%nat -> (b < n)%nat -> 0 <= w adj a b * V a b (norm (r a t - r b t)%C)).
  { intros a b Ha Hb. unfold w. destruct (adj a b) eqn:F; [|lra]. rewrite Rmult_1_l. apply P; try assumption. apply norm_neq. now apply A. }
  assert (K : V i j (norm (r i t - r j t)%C) <= V_i n adj V (fun i => r i t) i).
  { replace (V i j (norm (r i t - r j t)%C)) with (w adj i j * V i j (norm (r i t - r j t)%C)) by (unfold w; rewrite L; ring).
    apply (Sum_term_le n (fun b => w adj i b * V i b (norm (r i t - r b t)%C)) j); [|exact Hj]. intros b Hb. now apply G. }
  assert (G' : forall b, (b < n)%nat -> 0 <= V_i n adj V (fun i => r i t) b + inner (v b t) (v b t)).
  { intros b Hb. pose proof (inner_self_ge0 (v b t)). assert (0 <= V_i n adj V (fun i => r i t) b); [|lra]. apply Sum_ge0. intros; now apply G. }
  pose proof (Sum_term_le n (fun i => V_i n adj V (fun i => r i t) i + inner (v i t) (v i t)) i G' Hi) as L2. cbv beta in L2.
  pose proof (inner_self_ge0 (v i t)). lra.
Qed.
Hypothesis Start : distinct n adj (fun i => r i 0).
Hypothesis U : forall i j M, (i < n)%nat -> (j < n)%nat -> adj i j = true -> exists d, 0 < d /\ forall s, 0 < s < d -> M < V i j s.
(* linked agents that start apart keep a distance, the same for every T; that they never meet is the conclusion *)
Theorem turning_apart : exists d, 0 < d /\ forall T J, (forall t, 0 <= t <= T -> turning n adj V' r v q J t) ->
  forall t i j, 0 <= t <= T -> (i < n)%nat -> (j < n)%nat -> adj i j = true -> d <= norm (r i t - r j t)%C.
Proof.
  destruct (uniform_pairs n (fun i j b => 0 < b /\ (adj i j = true -> forall s, 0 < s < / b -> 2 * E 0 < V i j s))) as [b [Hb B]].
  { intros i j b b' [Pb Q] Le. split; [lra|]. intros A s Hs. apply (Q A s). split; [lra|].
    apply Rlt_le_trans with (1 := proj2 Hs). apply Rinv_le_contravar; lra. }
  { intros i j Hi Hj. destruct (adj i j) eqn:A; [|exists 1; split; [lra|discriminate]].
    destruct (U i j (2 * E 0) Hi Hj A) as [d [Hd Q]]. exists (/ d). split; [now apply Rinv_0_lt_compat|]. intros _ s Hs.
    rewrite Rinv_inv in Hs. now apply Q. }
  exists (/ b). split; [now apply Rinv_0_lt_compat|]. intros T J H t i j Ht.
  apply (kept_apart n adj r v (/ b) T); [now apply Rinv_0_lt_compat|intros s k Hs; now apply H|exact Start| |exact Ht].
  intros s Hs A a c Ha Hc L. apply Rnot_lt_le. intros F.
  assert (Ds : distinct n adj (fun i => r i s)) by exact (A s ltac:(lra)).
  pose proof (proj2 (B a c Ha Hc) L _ (conj (norm_neq _ _ (Ds a c Ha Hc L)) F)) as Q.
  pose proof (linked_energy s Ds a c Ha Hc L) as K.
  pose proof (turning_constant J s ltac:(lra) (fun x Hx => conj (H x ltac:(lra)) (conj (A x ltac:(lra)) (slopes_everywhere x (A x ltac:(lra)))))) as M. cbv beta in *. lra.
Qed.
(* all distances of a connected graph stay bounded, one bound for all T *)
Theorem turning_cohesion : strongly_connected n adj ->
  (forall i j M, (i < n)%nat -> (j < n)%nat -> adj i j = true -> exists D, forall s, D < s -> M < V i j s) ->
  exists B, forall T J, (forall t, 0 <= t <= T -> turning n adj V' r v q J t) ->
    forall t i j, 0 <= t <= T -> (i < n)%nat -> (j < n)%nat -> norm (r i t - r j t)%C <= B.
Proof.
  intros SC I. destruct turning_apart as [d [Hd A]].
  destruct (uniform_pairs n (fun i j b => adj i j = true -> forall s, b < s -> 2 * E 0 < V i j s)) as [D [HD B]].
  { intros i j b b' Q Le L s Hs. apply (Q L). lra. }
  { intros i j Hi Hj. destruct (adj i j) eqn:L; [|exists 1; discriminate]. destruct (I i j (2 * E 0) Hi Hj L) as [D Q]. now exists D. }
  exists (INR n * D). intros T J H t i j Ht Hi Hj. destruct (joined n adj i j SC Hi Hj) as [l [W L]].
  assert (Ds : forall s, 0 <= s <= t -> distinct n adj (fun i => r i s)).
  { intros s Hs a b Ha Hb Ab Eq. pose proof (A T J H s a b ltac:(lra) Ha Hb Ab) as Q. rewrite Eq in Q.
    replace (r b s - r b s)%C with (RtoC 0) in Q by ring. unfold norm in Q. rewrite Cmod_0 in Q. lra. }
  apply Rle_trans with (INR (length l) * D).
  - apply (walk_length n adj (fun i => r i t) D j l); [|exact W]. intros a b (Ha & Hb & Ab).
    assert (A' : adj a b = true) by (now rewrite S). apply Rnot_lt_le. intros F. specialize (B a b Ha Hb A' _ F).
    pose proof (linked_energy t (Ds t ltac:(lra)) a b Ha Hb A') as Q.
    pose proof (turning_constant J t ltac:(lra) (fun x Hx => conj (H x ltac:(lra)) (conj (Ds x Hx) (slopes_everywhere x (Ds x Hx))))) as M. cbv beta in *. lra.
  - apply Rmult_le_compat_r; [lra|]. apply le_INR. lia.
Qed.
End Turning.

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
