(* Tanner, Jadbabaie, Pappas, fixed graph: Omega is closed; forces tend to zero; on a tree every pair force is a sum of agents'
   forces, so each of them tends to zero, and distances tend to the desired ones where the gradients vanish there only.
     tanner2.eq7 (clause 3), beyond.tanner2.cor1. *)
From Coq Require Import Reals Lra Lia Psatz Relations Classical.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums paley_model paley_phase paley_laplacian paley_gradient paley_particles tanner_energy tanner_flock tanner2_motion.
Open Scope R_scope.

(* ---- distances and the vectors of the plane ---- *)
Lemma norm_triangle (x y : C) : norm (x + y)%C <= norm x + norm y.
Proof. apply Cmod_triangle. Qed.
Lemma norm_near (x y : C) : Rabs (norm x - norm y) <= norm (x - y)%C.
Proof.
  apply Rabs_le. pose proof (norm_triangle (x - y)%C y). pose proof (norm_triangle (y - x)%C x).
  replace (x - y + y)%C with x in H by ring. replace (y - x + x)%C with y in H0 by ring. rewrite (norm_sym y x) in H0. lra.
Qed.
Lemma norm_scal (a : R) (z : C) : norm (RtoC a * z)%C = Rabs a * norm z.
Proof. unfold norm. now rewrite Cmod_mult, Cmod_R. Qed.
Lemma fst_le (z : C) : Rabs (fst z) <= norm z.
Proof. eapply Rle_trans; [|apply Rmax_Cmod]. apply Rmax_l. Qed.
Lemma snd_le (z : C) : Rabs (snd z) <= norm z.
Proof. eapply Rle_trans; [|apply Rmax_Cmod]. apply Rmax_r. Qed.
Lemma norm_le_sum (z : C) : norm z <= Rabs (fst z) + Rabs (snd z).
Proof.
  replace z with (RtoC (fst z) + RtoC (snd z) * Ci)%C at 1 by (apply injective_projections; cbn; ring).
  eapply Rle_trans; [apply norm_triangle|]. unfold norm. rewrite Cmod_mult, !Cmod_R. replace (Cmod Ci) with 1; [lra|].
  unfold Cmod, Ci; cbn. replace (0 * (0 * 1) + 1 * (1 * 1)) with 1 by ring. now rewrite sqrt_1.
Qed.

(* ---- trees ---- *)
Definition without (adj : graph) (a b : nat) : graph :=
  fun i j => (adj i j && negb (Nat.eqb i a && Nat.eqb j b || Nat.eqb i b && Nat.eqb j a))%bool.
(* connected, and no longer so without any one of its edges *)
Definition tree (n : nat) (adj : graph) : Prop :=
  strongly_connected n adj /\ forall a b, arc n adj a b -> ~ strongly_connected n (without adj a b).

Lemma decided n (P : nat -> Prop) : exists s : nat -> bool, forall i, (i < n)%nat -> (s i = true <-> P i).
Proof.
  induction n as [|n [s H]]; [exists (fun _ => true); intros; lia|].
  destruct (classic (P n)) as [Y|N].
  - exists (fun i => if Nat.eqb i n then true else s i). intros i Hi. destruct (Nat.eqb_spec i n) as [->|D]; [easy|apply H; lia].
  - exists (fun i => if Nat.eqb i n then false else s i). intros i Hi. destruct (Nat.eqb_spec i n) as [->|D]; [easy|apply H; lia].
Qed.
(* an edge of a tree is the only one between two sides *)
Lemma sides n adj a b : undirected adj -> tree n adj -> (a < n)%nat -> (b < n)%nat -> adj a b = true ->
  exists s : nat -> bool, s a = true /\ s b = false /\
    forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> s i = true -> s j = false -> i = a /\ j = b.
Proof.
  intros S [SC T] Ha Hb A. assert (A' : adj b a = true) by (now rewrite S).
  pose (reach := clos_refl_trans nat (arc n (without adj a b))).
  assert (WS : undirected (without adj a b)).
  { intros k j. unfold without. rewrite (S k j). f_equal. f_equal. destruct (Nat.eqb k a), (Nat.eqb j b), (Nat.eqb k b), (Nat.eqb j a); reflexivity. }
  assert (back : forall x y, reach x y -> reach y x).
  { intros x y H. induction H as [x y H| |x y z H1 I1 H2 I2]; [|apply rt_refl|now apply rt_trans with y].
    apply rt_step. destruct H as (H1 & H2 & H3). repeat split; try assumption. now rewrite WS. }
  destruct (decided n (reach a)) as [s Hs].
  assert (NB : ~ reach a b).
  { intros F. apply (T a b); [repeat split; assumption|]. intros j k Hj Hk. pose proof (SC j k Hj Hk) as P. fold reach.
    change (reach j k). clear Hj Hk. induction P as [x y H| |x y z H1 I1 H2 I2]; [|apply rt_refl|now apply rt_trans with y].
    destruct H as (H1 & H2 & H3). destruct (without adj a b y x) eqn:E; [now apply rt_step|]. unfold without in E. rewrite H3 in E. cbn in E.
    apply Bool.negb_false_iff, Bool.orb_true_iff in E.
    destruct E as [E|E]; apply Bool.andb_true_iff in E; destruct E as [E1 E2]; apply Nat.eqb_eq in E1, E2; subst; [now apply back|exact F]. }
  exists s. split; [apply Hs; [assumption|apply rt_refl]|]. split.
  - destruct (s b) eqn:E; [|reflexivity]. exfalso. now apply NB, Hs.
  - intros i j Hi Hj Lk Si Sj. apply (Hs i Hi) in Si. assert (N : ~ reach a j) by (intros F; apply (Hs j Hj) in F; congruence).
    destruct (without adj a b j i) eqn:E.
    + exfalso. apply N. apply rt_trans with i; [exact Si|]. apply rt_step. repeat split; assumption.
    + unfold without in E. rewrite (S j i), Lk in E. cbn in E. apply Bool.negb_false_iff, Bool.orb_true_iff in E.
      destruct E as [E|E]; apply Bool.andb_true_iff in E; destruct E as [E1 E2]; apply Nat.eqb_eq in E1, E2; subst.
      * exfalso. apply N, rt_refl.
      * split; reflexivity.
Qed.

(* the force on an edge of a tree: the sum of the agents' forces on one side of it *)
Definition side (s : nat -> bool) (i : nat) : R := if s i then 1 else 0.
Lemma side_sum n adj V' (q : nat -> C) s : undirected adj -> (forall i j, V' i j = V' j i) ->
  Csum n (fun i => RtoC (side s i) * grad_i n adj V' q i)%C =
  Csum n (fun i => Csum n (fun j => RtoC (side s i * (1 - side s j)) * pair_grad adj V' q i j)%C).
Proof.
  intros S VS.
  assert (P : forall i j, pair_grad adj V' q j i = (- pair_grad adj V' q i j)%C) by (intros; now apply pair_grad_antisym).
  assert (K : forall f : C -> R, (forall x y, f (x + y)%C = f x + f y) -> (forall x, f (- x)%C = - f x) -> (forall a x, f (RtoC a * x)%C = a * f x) ->
    Sum n (fun i => side s i * Sum n (fun j => f (pair_grad adj V' q i j))) =
    Sum n (fun i => Sum n (fun j => side s i * (1 - side s j) * f (pair_grad adj V' q i j)))).
  { intros f _ F2 _.
    assert (Z : Sum n (fun i => Sum n (fun j => side s i * side s j * f (pair_grad adj V' q i j))) = 0).
    { apply Sum_antisym. intros i j _ _. rewrite (P i j), F2. ring. }
    rewrite (Sum_ext n (fun i => Sum n (fun j => side s i * (1 - side s j) * f (pair_grad adj V' q i j)))
      (fun i => side s i * Sum n (fun j => f (pair_grad adj V' q i j)) - Sum n (fun j => side s i * side s j * f (pair_grad adj V' q i j)))).
    - rewrite Sum_minus, Z. ring.
    - intros i _. rewrite <- Sum_scal, <- Sum_minus. apply Sum_ext. intros j _. ring. }
  unfold grad_i, Csum at 1 3. apply injective_projections; cbn [fst snd].
  - rewrite (Sum_ext n _ (fun i => side s i * Sum n (fun j => fst (pair_grad adj V' q i j)))).
    + rewrite (K fst); [|intros; reflexivity|intros; reflexivity|intros; cbn; ring].
      apply Sum_ext; intros i _. unfold Csum; cbn [fst snd]. apply Sum_ext; intros j _. cbn. ring.
    + intros i _. unfold Csum. cbn. ring.
  - rewrite (Sum_ext n _ (fun i => side s i * Sum n (fun j => snd (pair_grad adj V' q i j)))).
    + rewrite (K snd); [|intros; reflexivity|intros; reflexivity|intros; cbn; ring].
      apply Sum_ext; intros i _. unfold Csum; cbn [fst snd]. apply Sum_ext; intros j _. cbn. ring.
    + intros i _. unfold Csum. cbn. ring.
Qed.
Lemma edge_force n adj V' (q : nat -> C) a b s : undirected adj -> (forall i j, V' i j = V' j i) -> (a < n)%nat -> (b < n)%nat -> adj a b = true ->
  s a = true -> s b = false -> (forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> s i = true -> s j = false -> i = a /\ j = b) ->
  grad (V' a b) (q a) (q b) = Csum n (fun i => RtoC (side s i) * grad_i n adj V' q i)%C.
Proof.
  intros S VS Ha Hb A Sa Sb U. rewrite (side_sum n adj V' q s S VS).
  assert (E : forall i j, (i < n)%nat -> (j < n)%nat ->
    (RtoC (side s i * (1 - side s j)) * pair_grad adj V' q i j)%C = (RtoC (delta j b * delta i a) * grad (V' a b) (q a) (q b))%C).
  { intros i j Hi Hj. unfold pair_grad, w. destruct (adj i j) eqn:L.
    - destruct (s i) eqn:Si, (s j) eqn:Sj; unfold side; rewrite Si, Sj.
      + rewrite (delta_neq j b) by congruence. apply injective_projections; cbn; ring.
      + destruct (U i j Hi Hj L Si Sj) as [-> ->]. rewrite !delta_eq. apply injective_projections; cbn; ring.
      + rewrite (delta_neq j b) by congruence. apply injective_projections; cbn; ring.
      + rewrite (delta_neq i a) by congruence. apply injective_projections; cbn; ring.
    - unfold delta. destruct (Nat.eqb_spec j b), (Nat.eqb_spec i a); subst; [congruence|apply injective_projections; cbn; ring..]. }
  set (g := grad (V' a b) (q a) (q b)) in *.
  unfold Csum at 1. apply injective_projections; cbn [fst snd].
  - transitivity (Sum n (fun i => delta i a * fst g)); [now rewrite (Sum_delta n a (fun _ => fst g) Ha)|].
    apply Sum_ext; intros i Hi. unfold Csum; cbn [fst snd].
    transitivity (Sum n (fun j => delta j b * (delta i a * fst g))); [now rewrite (Sum_delta n b (fun _ => delta i a * fst g) Hb)|].
    apply Sum_ext; intros j Hj. rewrite E by assumption. cbn. ring.
  - transitivity (Sum n (fun i => delta i a * snd g)); [now rewrite (Sum_delta n a (fun _ => snd g) Ha)|].
    apply Sum_ext; intros i Hi. unfold Csum; cbn [fst snd].
    transitivity (Sum n (fun j => delta j b * (delta i a * snd g))); [now rewrite (Sum_delta n b (fun _ => delta i a * snd g) Hb)|].
    apply Sum_ext; intros j Hj. rewrite E by assumption. cbn. ring.
Qed.

(* ---- forces tend to zero ---- *)
Lemma norm_grad f (x y : C) : x <> y -> norm (grad f x y) = Rabs (f (norm (x - y)%C)).
Proof.
  intros N. pose proof (norm_neq _ _ N) as P. unfold grad. rewrite norm_scal. unfold Rdiv.
  rewrite Rabs_mult, (Rabs_pos_eq (/ _)) by (left; now apply Rinv_0_lt_compat). field. lra.
Qed.
Lemma norm_Csum m (f : nat -> C) : norm (Csum m f) <= Sum m (fun j => norm (f j)).
Proof.
  induction m as [|m IH]; [cbn; unfold Csum, norm; cbn; change (0, 0) with (RtoC 0); rewrite Cmod_0; lra|]. rewrite Csum_S. cbn [Sum].
  eapply Rle_trans; [apply norm_triangle|]. lra.
Qed.
Lemma grad_uniform f d D : 0 < d <= D -> (forall s, d <= s <= D -> continuity_pt f s) -> forall e, 0 < e -> exists h, 0 < h /\
  forall x y x' y' : C, d <= norm (x - y)%C <= D -> d <= norm (x' - y')%C <= D -> norm ((x - y) - (x' - y'))%C < h ->
    norm (grad f x y - grad f x' y')%C < e.
Proof.
  intros Hd C e He. set (phi := fun s => f s * / s).
  assert (CP : forall s, d <= s <= D -> continuity_pt phi s).
  { intros s Hs. unfold phi. apply continuity_pt_mult; [now apply C|]. apply continuity_pt_inv; [apply derivable_continuous_pt, derivable_pt_id|lra]. }
  destruct (continuity_ab_maj (fun s => Rabs (phi s)) d D (proj2 Hd)) as [m [M Hm]].
  { intros s Hs. apply continuity_pt_comp with (f1 := phi) (f2 := Rabs); [now apply CP|apply Rcontinuity_abs]. }
  set (B := Rabs (phi m)) in *. assert (HB : 0 <= B) by apply Rabs_pos.
  assert (P1 : 0 < e / (2 * (D + 1))) by (apply Rdiv_lt_0_compat; lra).
  destruct (Heine_cor2 CP (mkposreal _ P1)) as [h Hh]. pose proof (cond_pos h) as H0. cbn in Hh.
  assert (P2 : 0 < e / (2 * (B + 1))) by (apply Rdiv_lt_0_compat; lra).
  exists (Rmin h (e / (2 * (B + 1)))). split; [now apply Rmin_glb_lt|]. intros x y x' y' Hx Hx' Hz.
  pose proof (Rmin_l h (e / (2 * (B + 1)))). pose proof (Rmin_r h (e / (2 * (B + 1)))).
  set (z := (x - y)%C) in *. set (z' := (x' - y')%C) in *.
  assert (E : (grad f x y - grad f x' y')%C = (RtoC (phi (norm z) - phi (norm z')) * z + RtoC (phi (norm z')) * (z - z'))%C).
  { unfold grad, phi, Rdiv. fold z z'. apply injective_projections; cbn; ring. }
  rewrite E. eapply Rle_lt_trans; [apply norm_triangle|]. rewrite !norm_scal.
  pose proof (norm_near z z') as Nz. assert (A1 : Rabs (phi (norm z) - phi (norm z')) < e / (2 * (D + 1))) by (apply Hh; try assumption; lra).
  pose proof (M (norm z') Hx') as A2. fold B in A2. cbv beta in A2. pose proof (Rabs_pos (phi (norm z'))). pose proof (Rabs_pos (phi (norm z) - phi (norm z'))).
  pose proof (norm_ge0 (z - z')%C).
  assert (T1 : Rabs (phi (norm z) - phi (norm z')) * norm z <= e / 2).
  { apply Rle_trans with (e / (2 * (D + 1)) * (D + 1)); [apply Rmult_le_compat; lra|right; field; lra]. }
  assert (T2 : Rabs (phi (norm z')) * norm (z - z')%C < e / 2).
  { apply Rle_lt_trans with (B * norm (z - z')%C); [apply Rmult_le_compat_r; lra|].
    apply Rle_lt_trans with (B * (e / (2 * (B + 1)))); [apply Rmult_le_compat_l; lra|].
    replace (e / 2) with ((B + 1) * (e / (2 * (B + 1)))) by (field; lra). nra. }
  lra.
Qed.

Section Limit.
Variables (n : nat) (adj : graph) (V V' : nat -> nat -> R -> R) (r v : nat -> R -> C).
Hypothesis S : undirected adj.
Hypothesis NL : no_loops adj.
Hypothesis VS : forall i j, V i j = V j i.
Hypothesis VS' : forall i j, V' i j = V' j i.
Hypothesis Pot : forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> potential (V i j) (V' i j).
Hypothesis Start : distinct n adj (fun i => r i 0).
Hypothesis Hn : (1 <= n)%nat.
Hypothesis SC : strongly_connected n adj.
Hypothesis C1 : forall i j s, (i < n)%nat -> (j < n)%nat -> adj i j = true -> 0 < s -> continuity_pt (V' i j) s.
Hypothesis H : forall t, 0 <= t -> moves n adj V' r v t.
Notation force i t := (grad_i n adj V' (fun j => r j t) i).

Lemma kept_apart t i j : 0 <= t -> (i < n)%nat -> (j < n)%nat -> adj i j = true -> r i t <> r j t.
Proof. now apply (never_meet n adj V V' r v). Qed.
Lemma accelerates t i : 0 <= t -> (i < n)%nat -> is_velocity (v i) t (control4 n adj V' (fun i => r i t) (fun i => v i t) i).
Proof. intros Ht Hi. apply (proj2 (H t Ht)); [|exact Hi]. intros a b Ha Hb. now apply kept_apart. Qed.
Lemma range_of_distances : exists d D, 0 < d <= D /\ forall t i j, 0 <= t -> (i < n)%nat -> (j < n)%nat -> adj i j = true -> d <= norm (r i t - r j t)%C <= D.
Proof.
  destruct (linked_distances n adj V V' (Wenergy n adj V (fun i => r i 0) (fun i => v i 0)) S NL VS Pot) as [d [D [Hd L]]].
  exists d, (Rmax d D). pose proof (Rmax_l d D). pose proof (Rmax_r d D). split; [lra|]. intros t i j Ht Hi Hj A.
  assert (d <= norm (r i t - r j t)%C <= D); [|lra]. apply (L (fun i => r i t) (fun i => v i t)); try assumption; [intros; now apply kept_apart|].
  apply (energy_nonincreasing n adj V V' r v S VS' Pot); [intros; now apply kept_apart|intros; now apply H|intros; now apply accelerates|lra].
Qed.
Lemma forces_uniform d D : 0 < d <= D -> forall e, 0 < e -> exists h, 0 < h /\ forall q q' : nat -> C,
  (forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> d <= norm (q i - q j)%C <= D /\ d <= norm (q' i - q' j)%C <= D /\
     norm ((q i - q j) - (q' i - q' j))%C < h) ->
  forall i, (i < n)%nat -> norm (grad_i n adj V' q i - grad_i n adj V' q' i)%C < e.
Proof.
  intros Hd e He. pose proof (INR_pos n Hn) as P. assert (He' : 0 < e / (2 * INR n)) by (apply Rdiv_lt_0_compat; lra).
  destruct (uniform_pairs n (fun i j b => 0 < b /\ (adj i j = true -> forall x y x' y' : C, d <= norm (x - y)%C <= D -> d <= norm (x' - y')%C <= D ->
    norm ((x - y) - (x' - y'))%C < / b -> norm (grad (V' i j) x y - grad (V' i j) x' y')%C < e / (2 * INR n)))) as [b [Hb U]].
  { intros i j b b' [Pb Q] Le. split; [lra|]. intros A x y x' y' X X' Z. apply (Q A); try assumption.
    apply Rlt_le_trans with (1 := Z). apply Rinv_le_contravar; lra. }
  { intros i j Hi Hj. destruct (adj i j) eqn:A; [|exists 1; split; [lra|discriminate]].
    destruct (grad_uniform (V' i j) d D Hd) with (e := e / (2 * INR n)) as [h [Hh G]]; [intros; apply C1; try assumption; lra|assumption|].
    exists (/ h). split; [now apply Rinv_0_lt_compat|]. intros _. now rewrite Rinv_inv. }
  exists (/ b). split; [now apply Rinv_0_lt_compat|]. intros q q' Q i Hi. unfold grad_i. rewrite <- Csum_minus.
  apply Rle_lt_trans with (e / 2); [|lra]. eapply Rle_trans; [apply norm_Csum|].
  apply Rle_trans with (Sum n (fun _ => e / (2 * INR n))); [|rewrite Sum_const; right; field; lra].
  apply Sum_le; intros j Hj. unfold pair_grad, w. destruct (adj i j) eqn:A.
  - destruct (Q i j Hi Hj A) as (Q1 & Q2 & Q3). left. replace (RtoC 1 * grad (V' i j) (q i) (q j) - RtoC 1 * grad (V' i j) (q' i) (q' j))%C
      with (grad (V' i j) (q i) (q j) - grad (V' i j) (q' i) (q' j))%C by ring. now apply (U i j Hi Hj).
  - match goal with |- norm ?z <= _ => replace z with (RtoC 0) by (apply injective_projections; cbn; ring) end. unfold norm. rewrite Cmod_0. lra.
Qed.
Lemma late_velocities e : 0 < e -> exists T, 0 <= T /\ forall t, T <= t -> forall i j, (i < n)%nat -> (j < n)%nat ->
  norm (v i t - v j t)%C < e /\ norm (v i t - centre n (fun k => v k 0%R))%C < e.
Proof.
  intros He. destruct (uniform_pairs n (fun i j T => forall t, T <= t -> 0 <= t -> norm (v i t - v j t)%C < e /\ norm (v i t - centre n (fun k => v k 0%R))%C < e)) as [T [HT U]].
  - intros i j T T' Q Le t Ht P. apply Q; lra.
  - intros i j Hi Hj. destruct (motions_agree n adj V V' r v S NL VS VS' Pot Start Hn SC C1 H i j Hi Hj e He) as [T1 [H1 A]].
    destruct (motions_to_mean n adj V V' r v S NL VS VS' Pot Start Hn SC C1 H i Hi e He) as [T2 [H2 B]]. exists (Rmax T1 T2).
    pose proof (Rmax_l T1 T2). pose proof (Rmax_r T1 T2). intros t Ht _. split; [apply A|apply B]; lra.
  - exists T. split; [lra|]. intros t Ht i j Hi Hj. apply U; try assumption; lra.
Qed.
Lemma drift_of_pairs i j s t e : (i < n)%nat -> (j < n)%nat -> 0 <= s <= t -> t <= s + 1 -> 0 <= e -> (forall x, s <= x -> norm (v i x - v j x)%C <= e) ->
  norm ((r i t - r j t) - (r i s - r j s))%C <= 2 * e.
Proof.
  intros Hi Hj Hst Ht He B. eapply Rle_trans; [apply norm_le_sum|].
  assert (VM : forall x, s <= x <= t -> is_velocity (fun x => r i x - r j x)%C x (v i x - v j x)%C).
  { intros x Hx. apply velocity_minus; apply (H x ltac:(lra)); assumption. }
  destruct (MVT_le (fun x => fst (r i x - r j x)%C) (fun x => fst (v i x - v j x)%C) s t (proj2 Hst)) as [c [Hc E1]]; [intros x Hx; now apply VM|].
  destruct (MVT_le (fun x => snd (r i x - r j x)%C) (fun x => snd (v i x - v j x)%C) s t (proj2 Hst)) as [c' [Hc' E2]]; [intros x Hx; now apply VM|].
  pose proof (Rle_trans _ _ _ (fst_le _) (B c ltac:(lra))) as F1. pose proof (Rle_trans _ _ _ (snd_le _) (B c' ltac:(lra))) as F2.
  change (fst ((r i t - r j t) - (r i s - r j s))%C) with (fst (r i t - r j t)%C - fst (r i s - r j s)%C).
  change (snd ((r i t - r j t) - (r i s - r j s))%C) with (snd (r i t - r j t)%C - snd (r i s - r j s)%C).
  rewrite E1, E2, !Rabs_mult, (Rabs_pos_eq (t - s)) by lra.
  pose proof (Rabs_pos (fst (v i c - v j c)%C)). pose proof (Rabs_pos (snd (v i c' - v j c')%C)). nra.
Qed.
(* the potential force on every agent tends to zero *)
Theorem forces_vanish e : 0 < e -> exists T, 0 <= T /\ forall t i, T <= t -> (i < n)%nat -> norm (force i t) < e.
Proof.
  intros He. destruct range_of_distances as [d [D [Hd L]]].
  destruct (forces_uniform d D Hd (e / 8) ltac:(lra)) as [h [Hh U]]. pose proof (INR_pos n Hn) as P.
  set (y := Rmin (h / 4) (e / (16 * (INR n + 2)))).
  assert (Py : 0 < y) by (apply Rmin_glb_lt; [lra|apply Rdiv_lt_0_compat; lra]).
  assert (Y1 : y <= h / 4) by apply Rmin_l. assert (Y2 : (INR n + 2) * y <= e / 16).
  { apply Rle_trans with ((INR n + 2) * (e / (16 * (INR n + 2)))); [apply Rmult_le_compat_l; [lra|apply Rmin_r]|right; field; lra]. }
  destruct (late_velocities y Py) as [T [HT A]]. exists T. split; [exact HT|]. intros t i Ht Hi.
  assert (Near : forall c, t <= c <= t + 1 -> norm (force i c - force i t)%C < e / 8).
  { intros c Hc. apply U; [|exact Hi]. intros a b Ha Hb Lk. split; [apply L; try assumption; lra|]. split; [apply L; try assumption; lra|].
    apply Rle_lt_trans with (2 * y); [|lra]. apply drift_of_pairs; try assumption; try lra. intros x Hx. left. now apply A; [lra| |]. }
  assert (Damp : forall c, t <= c -> norm (Csum n (fun j => RtoC (w adj i j) * (v i c - v j c)))%C <= INR n * y).
  { intros c Hc. eapply Rle_trans; [apply norm_Csum|]. rewrite <- Sum_const. apply Sum_le; intros j Hj. rewrite norm_scal.
    pose proof (proj1 (A c ltac:(lra) i j Hi Hj)). pose proof (norm_ge0 (v i c - v j c)%C). unfold w. destruct (adj i j); rewrite ?Rabs_R1, ?Rabs_R0; lra. }
  assert (Change : norm (v i (t + 1)%R - v i t)%C <= 2 * y).
  { set (mu := centre n (fun k => v k 0%R)) in *. replace (v i (t + 1)%R - v i t)%C with ((v i (t + 1)%R - mu) - (v i t - mu))%C by ring.
    unfold Cminus at 1. eapply Rle_trans; [apply norm_triangle|]. rewrite norm_opp. pose proof (proj2 (A t Ht i i Hi Hi)). pose proof (proj2 (A (t + 1) ltac:(lra) i i Hi Hi)). lra. }
  assert (Cor : forall p : C -> R, (forall z, Rabs (p z) <= norm z) -> (forall x z, p (x - z)%C = p x - p z) -> (forall z, p (- z)%C = - p z) ->
    (forall x, t <= x -> is_derive (fun s => p (v i s)) x (p (control4 n adj V' (fun i => r i x) (fun i => v i x) i))) -> Rabs (p (force i t)) <= e / 8 + (INR n + 2) * y).
  { intros p P1 P2 P3 PD. destruct (MVT_le (fun s => p (v i s)) (fun x => p (control4 n adj V' (fun i => r i x) (fun i => v i x) i)) t (t + 1)) as [c [Hc E]]; [lra|intros x Hx; apply PD; lra|].
    unfold control4 in E. rewrite P2, P3, <- P2 in E. set (dmp := Csum n _) in E.
    pose proof (Rle_trans _ _ _ (P1 _) (Damp c ltac:(lra))) as F1. fold dmp in F1.
    pose proof (Rle_trans _ _ _ (P1 _) Change) as F2. pose proof (Rle_lt_trans _ _ _ (P1 _) (Near c Hc)) as F3. rewrite P2 in F3.
    apply Rabs_le_between in F1, F2. apply Rabs_lt_between in F3. apply Rabs_le. lra. }
  eapply Rle_lt_trans; [apply norm_le_sum|].
  pose proof (Cor fst fst_le (fun _ _ => eq_refl) (fun _ => eq_refl) (fun x Hx => proj1 (accelerates x i ltac:(lra) Hi))).
  pose proof (Cor snd snd_le (fun _ _ => eq_refl) (fun _ => eq_refl) (fun x Hx => proj2 (accelerates x i ltac:(lra) Hi))). lra.
Qed.

(* beyond.tanner2.cor1, clause 2 *)
Hypothesis Tr : tree n adj.
Theorem tree_forces_vanish a b : (a < n)%nat -> (b < n)%nat -> adj a b = true ->
  forall e, 0 < e -> exists T, 0 <= T /\ forall t, T <= t -> norm (grad (V' a b) (r a t) (r b t)) < e.
Proof.
  intros Ha Hb A e He. destruct (sides n adj a b S Tr Ha Hb A) as [s [Sa [Sb U]]]. pose proof (INR_pos n Hn) as P.
  destruct (forces_vanish (e / (2 * INR n))) as [T [HT F]]; [apply Rdiv_lt_0_compat; lra|]. exists T. split; [exact HT|]. intros t Ht.
  rewrite (edge_force n adj V' (fun j => r j t) a b s S VS' Ha Hb A Sa Sb U). apply Rle_lt_trans with (e / 2); [|lra].
  eapply Rle_trans; [apply norm_Csum|]. apply Rle_trans with (Sum n (fun _ => e / (2 * INR n))); [|rewrite Sum_const; right; field; lra].
  apply Sum_le; intros i Hi. specialize (F t i Ht Hi). rewrite norm_scal. pose proof (norm_ge0 (force i t)).
  unfold side. destruct (s i); rewrite ?Rabs_R1, ?Rabs_R0; lra.
Qed.
(* clause 1 *)
Lemma least_off f p q : (forall s, p <= s <= q -> continuity_pt f s) -> (forall s, p <= s <= q -> f s <> 0) ->
  exists c, 0 < c /\ forall s, p <= s <= q -> c <= Rabs (f s).
Proof.
  intros C N. destruct (Rle_or_lt p q) as [L|L]; [|exists 1; split; [lra|intros; lra]].
  destruct (continuity_ab_min (fun s => Rabs (f s)) p q L) as [m [M Hm]].
  - intros s Hs. apply continuity_pt_comp with (f1 := f) (f2 := Rabs); [now apply C|apply Rcontinuity_abs].
  - exists (Rabs (f m)). split; [apply Rabs_pos_lt; now apply N|exact M].
Qed.
Theorem tree_distances (m : nat -> nat -> R) :
  (forall i j s, (i < n)%nat -> (j < n)%nat -> adj i j = true -> 0 < s -> V' i j s = 0 -> s = m i j) ->
  forall a b, (a < n)%nat -> (b < n)%nat -> adj a b = true ->
  forall e, 0 < e -> exists T, 0 <= T /\ forall t, T <= t -> Rabs (norm (r a t - r b t)%C - m a b) < e.
Proof.
  intros M a b Ha Hb A e He. destruct range_of_distances as [d [D [Hd L]]].
  destruct (least_off (V' a b) d (m a b - e)) as [c1 [P1 F1]]; [intros; apply C1; try assumption; lra|intros s Hs Z; apply (M a b s Ha Hb A) in Z; lra|].
  destruct (least_off (V' a b) (Rmax d (m a b + e)) D) as [c2 [P2 F2]].
  { intros s Hs. pose proof (Rmax_l d (m a b + e)). apply C1; try assumption; lra. }
  { intros s Hs Z. pose proof (Rmax_l d (m a b + e)). pose proof (Rmax_r d (m a b + e)). apply (M a b s Ha Hb A) in Z; lra. }
  destruct (tree_forces_vanish a b Ha Hb A (Rmin c1 c2)) as [T [HT F]]; [now apply Rmin_glb_lt|]. exists T. split; [exact HT|]. intros t Ht.
  specialize (F t Ht). rewrite norm_grad in F by (apply kept_apart; try assumption; lra). specialize (L t a b ltac:(lra) Ha Hb A).
  set (s := norm (r a t - r b t)%C) in *. pose proof (Rmin_l c1 c2). pose proof (Rmin_r c1 c2). apply Rnot_le_lt. intros G.
  unfold Rabs in G. destruct (Rcase_abs (s - m a b)).
  - specialize (F1 s ltac:(lra)). lra.
  - assert (Rmax d (m a b + e) <= s) by (apply Rmax_lub; lra). specialize (F2 s ltac:(lra)). lra.
Qed.
End Limit.

(* clause 3 *)
Theorem tree_equilibrium n adj V' (m : nat -> nat -> R) (q : nat -> C) (u : C) : undirected adj -> (forall i j, V' i j = V' j i) -> tree n adj ->
  (forall i j s, (i < n)%nat -> (j < n)%nat -> adj i j = true -> 0 < s -> V' i j s = 0 -> s = m i j) -> distinct n adj q ->
  (forall i, (i < n)%nat -> control4 n adj V' q (fun _ => u) i = RtoC 0) ->
  forall a b, (a < n)%nat -> (b < n)%nat -> adj a b = true -> norm (q a - q b)%C = m a b.
Proof.
  intros S VS Tr M N Z a b Ha Hb A. destruct (sides n adj a b S Tr Ha Hb A) as [s [Sa [Sb U]]].
  pose proof (edge_force n adj V' q a b s S VS Ha Hb A Sa Sb U) as E.
  assert (G : forall i, (i < n)%nat -> grad_i n adj V' q i = RtoC 0).
  { intros i Hi. specialize (Z i Hi). unfold control4 in Z. rewrite (Csum_ext n _ (fun _ => RtoC 0)) in Z by (intros; apply injective_projections; cbn; ring).
    rewrite Csum_const in Z. replace (grad_i n adj V' q i) with (- (- (RtoC (INR n) * RtoC 0) - grad_i n adj V' q i))%C by ring. rewrite Z. ring. }
  rewrite (Csum_ext n _ (fun _ => RtoC 0)), Csum_const in E by (intros i Hi; rewrite (G i Hi); ring).
  apply (M a b _ Ha Hb A); [apply norm_neq; now apply N|]. pose proof (norm_grad (V' a b) (q a) (q b) (N a b Ha Hb A)) as F.
  rewrite E in F. replace (RtoC (INR n) * RtoC 0)%C with (RtoC 0) in F by ring. unfold norm at 1 in F. rewrite Cmod_0 in F.
  destruct (Req_dec (V' a b (norm (q a - q b)%C)) 0) as [|K]; [assumption|]. apply Rabs_no_R0 in K. congruence.
Qed.

(* ---- Omega is closed in the relative positions and velocities ---- *)
Definition tends (z : nat -> C) (l : C) : Prop := is_lim_seq (fun k => fst (z k)) (fst l) /\ is_lim_seq (fun k => snd (z k)) (snd l).
Lemma tends_inner z l : tends z l -> is_lim_seq (fun k => inner (z k) (z k)) (inner l l).
Proof.
  intros [A B]. rewrite inner_xy. apply (is_lim_seq_ext (fun k => fst (z k) * fst (z k) + snd (z k) * snd (z k))); [intros; now rewrite inner_xy|].
  apply is_lim_seq_plus'; now apply is_lim_seq_mult'.
Qed.
Lemma tends_norm z l : tends z l -> is_lim_seq (fun k => norm (z k)) (norm l).
Proof.
  intros T. rewrite norm_inner. apply (is_lim_seq_ext (fun k => sqrt (inner (z k) (z k)))); [intros; now rewrite norm_inner|].
  apply (is_lim_seq_continuous sqrt _ (inner l l)); [apply continuity_pt_sqrt, inner_self_ge0|now apply tends_inner].
Qed.
Lemma tends_unique z l m : tends z l -> tends z m -> l = m.
Proof.
  intros [A B] [A' B']. apply is_lim_seq_unique in A, A', B, B'. rewrite A in A'. rewrite B in B'. injection A'. injection B'. intros.
  now apply injective_projections.
Qed.
Lemma tends_Sum m (f : nat -> nat -> R) (l : nat -> R) : (forall i, (i < m)%nat -> is_lim_seq (f i) (l i)) -> is_lim_seq (fun k => Sum m (fun i => f i k)) (Sum m l).
Proof.
  induction m as [|m IH]; intros T; cbn [Sum]; [apply is_lim_seq_const|]. apply is_lim_seq_plus'; [apply IH; intros; apply T; lia|apply T; lia].
Qed.
Theorem Omega_closed n adj V V' c (r v : nat -> nat -> C) (x : nat -> nat -> C) (y : nat -> C) : undirected adj -> no_loops adj -> (forall i j, V i j = V j i) ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> potential (V i j) (V' i j)) ->
  (forall k, distinct n adj (r k) /\ Wenergy n adj V (r k) (v k) <= c) ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> tends (fun k => r k i - r k j)%C (x i j)) -> (forall i, (i < n)%nat -> tends (fun k => v k i) (y i)) ->
  exists q : nat -> C, (forall i j, (i < n)%nat -> (j < n)%nat -> x i j = (q i - q j)%C) /\ distinct n adj q /\ Wenergy n adj V q y <= c.
Proof.
  intros S NL VS Pot In TX TY. exists (fun i => x i 0%nat).
  assert (X : forall i j, (i < n)%nat -> (j < n)%nat -> x i j = (x i 0%nat - x j 0%nat)%C).
  { intros i j Hi Hj. apply (tends_unique (fun k => r k i - r k j)%C); [now apply TX|]. destruct (TX i 0%nat Hi ltac:(lia)) as [A B]. destruct (TX j 0%nat Hj ltac:(lia)) as [A' B'].
    split.
    - apply (is_lim_seq_ext (fun k => fst (r k i - r k 0%nat)%C - fst (r k j - r k 0%nat)%C)); [intros; cbn; Rring|]. now apply is_lim_seq_minus'.
    - apply (is_lim_seq_ext (fun k => snd (r k i - r k 0%nat)%C - snd (r k j - r k 0%nat)%C)); [intros; cbn; Rring|]. now apply is_lim_seq_minus'. }
  split; [exact X|]. destruct (linked_distances n adj V V' c S NL VS Pot) as [d [D [Hd L]]].
  assert (Far : forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> d <= norm (x i 0%nat - x j 0%nat)%C).
  { intros i j Hi Hj A. rewrite <- X by assumption. pose proof (tends_norm _ _ (TX i j Hi Hj)) as T.
    apply (is_lim_seq_le (fun _ => d) (fun k => norm (r k i - r k j)%C) d (norm (x i j))); [|apply is_lim_seq_const|exact T].
    intros k. destruct (In k) as [NC W]. now apply (L (r k) (v k) NC W). }
  assert (Di : distinct n adj (fun i => x i 0%nat)).
  { intros i j Hi Hj A E. specialize (Far i j Hi Hj A). cbv beta in E. rewrite E in Far. replace (x j 0%nat - x j 0%nat)%C with (RtoC 0) in Far by ring.
    unfold norm in Far. rewrite Cmod_0 in Far. lra. }
  split; [exact Di|].
  apply (is_lim_seq_le (fun k => Wenergy n adj V (r k) (v k)) (fun _ => c) (Wenergy n adj V (fun i => x i 0%nat) y) c); [intros k; apply In| |apply is_lim_seq_const].
  unfold Wenergy. apply (is_lim_seq_scal_l _ (/ 2) (Sum n (fun i => V_i n adj V (fun i => x i 0%nat) i + inner (y i) (y i)))).
  apply (tends_Sum n (fun i k => V_i n adj V (r k) i + inner (v k i) (v k i)) (fun i => V_i n adj V (fun i => x i 0%nat) i + inner (y i) (y i))).
  intros i Hi. apply is_lim_seq_plus'; [|now apply tends_inner, TY]. unfold V_i.
  apply (tends_Sum n (fun j k => w adj i j * V i j (norm (r k i - r k j)%C)) (fun j => w adj i j * V i j (norm (x i 0%nat - x j 0%nat)%C))).
  intros j Hj. unfold w. destruct (adj i j) eqn:A.
  - apply is_lim_seq_mult'; [apply is_lim_seq_const|]. apply (is_lim_seq_continuous (V i j)).
    + apply continuity_pt_filterlim, (ex_derive_continuous (V i j)). eexists. apply (Pot i j Hi Hj A), norm_neq. now apply Di.
    + rewrite <- X by assumption. now apply tends_norm, TX.
  - apply (is_lim_seq_ext (fun _ => 0)); [intros; Rring|]. rewrite Rmult_0_l. apply is_lim_seq_const.
Qed.
