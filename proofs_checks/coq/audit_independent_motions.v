(* Clauses about the motions of Tanner, Jadbabaie and Pappas, formalised from their words with own definitions by who proved them: motions last for all time, so that
   what is said of motions for all t >= 0 (tanner2.thm1a, tanner2.thm1c clause 2, tanner2.cor1 clauses 4, 5) is said of all; the angle of a velocity
   (tanner1.eq2, tanner2.eq2 clause 2); the set Omega (tanner1.Omega.bounded clause 3, tanner1.Omega.closed). *)
From Coq Require Import Reals Lra Lia Relations Psatz.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums paley_model paley_phase paley_laplacian tanner_energy tanner_flock.
From Flockproof Require tanner_trees tanner_rates tanner1_heading tanner2_motion tanner2_filippov tanner2_lasting tanner_angle audit_independent_tanner1 audit_independent_tanner2.
Module T1 := audit_independent_tanner1.
Module T2 := audit_independent_tanner2.
Open Scope R_scope.

(* ---- motions last ---- *)
Definition starts (n : nat) (adj : graph) (V' : nat -> nat -> R -> R) : Prop := forall r0 v0 : nat -> C, T2.apart_at n adj r0 ->
  exists r v, T2.motion n adj V' r v /\ forall i, (i < n)%nat -> r i 0 = r0 i /\ v i 0 = v0 i.
Definition moves_until (T : R) n adj (V' : nat -> nat -> R -> R) (r v : nat -> R -> C) := T2.apart_at n adj (fun i => r i 0) /\
  forall t i, 0 <= t < T -> (i < n)%nat -> is_velocity (r i) t (v i t) /\
    (T2.apart_at n adj (fun i => r i t) -> is_velocity (v i) t (T2.law4 n adj V' (fun i => r i t) (fun i => v i t) i)).
Definition goes_on n adj V' : Prop := forall T r v, 0 < T -> moves_until T n adj V' r v ->
  exists r' v', T2.motion n adj V' r' v' /\ forall t i, 0 <= t < T -> (i < n)%nat -> r' i t = r i t /\ v' i t = v i t.
Definition last_for_ever : Prop := forall n adj V V', T2.simple_graph adj -> T2.potentials n adj V V' -> starts n adj V' /\ goes_on n adj V'.
(* the clauses of motions for all t >= 0, with it *)
Definition thm1a : Prop := last_for_ever /\ T2.thm1a.
Definition thm1c_2 : Prop := last_for_ever /\ T2.thm1c_2.
Definition cor1_4 : Prop := last_for_ever /\ T2.cor1_4.
Definition cor1_5 : Prop := last_for_ever /\ T2.cor1_5.
(* ---- the angle: by half of it, as tan (theta/2) = y / (|v| + x) ---- *)
Definition angle (v : C) : R := if Req_EM_T (Cmod v + fst v) 0 then PI else 2 * atan (snd v / (Cmod v + fst v)).
Definition eq2 : Prop := forall v : C, v <> RtoC 0 ->
  (- PI < angle v <= PI /\ v = (RtoC (Cmod v) * expi (angle v))%C) /\
  (0 < fst v -> angle v = atan (snd v / fst v)) /\ (0 < snd v -> angle v = PI / 2 - atan (fst v / snd v)) /\
  (snd v < 0 -> angle v = - PI / 2 - atan (fst v / snd v)) /\ (snd v = 0 -> fst v < 0 -> angle v = PI).
(* ---- Omega: with the potential of Figure 2; x i j is r_ij ---- *)
Definition Omega n adj c (x : nat -> nat -> C) (v : nat -> C) (th : nat -> R) := (forall i, (i < n)%nat -> Rabs (th i) <= PI) /\
  exists r, (forall i j, (i < n)%nat -> (j < n)%nat -> x i j = (r i - r j)%C) /\ T1.linked_apart n adj r /\ T1.Vt n adj T1.fig2 r v th <= c.
Definition Omega_bounded_3 : Prop := forall n adj c x v th i, Omega n adj c x v th -> (i < n)%nat -> - PI <= th i <= PI.
Definition to (z : nat -> C) (l : C) := forall e, 0 < e -> exists K, forall k, (K <= k)%nat -> Cmod (z k - l)%C < e.
Definition Omega_closed : Prop := forall n adj c (x : nat -> nat -> nat -> C) (v : nat -> nat -> C) (th : nat -> nat -> R) y u al, undirected adj -> no_loops adj ->
  (forall k, Omega n adj c (x k) (v k) (th k)) ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> to (fun k => x k i j) (y i j)) -> (forall i, (i < n)%nat -> to (fun k => v k i) (u i)) ->
  (forall i, (i < n)%nat -> forall e, 0 < e -> exists K, forall k, (K <= k)%nat -> Rabs (th k i - al i) < e) -> Omega n adj c y u al.

(* ---- the theorems prove them ---- *)
Lemma one_pair n adj V V' : undirected adj -> T2.potentials n adj V V' ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> potential (tanner2_filippov.both V i j) (tanner2_filippov.both V' i j)) /\
  (forall i j s, (i < n)%nat -> (j < n)%nat -> adj i j = true -> 0 < s -> continuity_pt (tanner2_filippov.both V' i j) s).
Proof.
  intros S P. destruct (T2.one_of n adj V V' S P) as (_ & _ & Q). split.
  - intros i j Hi Hj A. destruct (Q i j Hi Hj A) as (Q1 & Q2 & Q3). split; [intros s Hs; split; now apply Q1|]. now split.
  - intros i j s Hi Hj A Hs. now apply (Q i j Hi Hj A).
Qed.
Lemma law_both n adj V V' r v i : undirected adj -> T2.potentials n adj V V' -> (i < n)%nat -> T2.apart_at n adj r ->
  control4 n adj (tanner2_filippov.both V') r v i = T2.law4 n adj V' r v i.
Proof.
  intros S P Hi A. rewrite <- T2.law4_is. now destruct (T2.both_law n adj V V' r v i S (proj1 P) (T2.slopes_of n adj V V' P) Hi A) as (_ & _ & ->).
Qed.
Lemma last_for_ever_proved : last_for_ever.
Proof.
  intros n adj V V' [S NL] P. destruct (one_pair n adj V V' S P) as [Pot C1]. set (W := tanner2_filippov.both V) in *. set (W' := tanner2_filippov.both V') in *.
  assert (VS : forall i j, W i j = W j i) by exact (tanner2_filippov.both_sym V). assert (VS' : forall i j, W' i j = W' j i) by exact (tanner2_filippov.both_sym V').
  assert (Mo : forall r v, tanner2_motion.distinct n adj (fun i => r i 0) -> (forall t, 0 <= t -> tanner2_motion.moves n adj W' r v t) -> T2.motion n adj V' r v).
  { intros r v A M. split; [exact A|]. intros t i Ht Hi. destruct (M t Ht) as [M1 M2]. split; [now apply M1|]. intros Ap.
    rewrite <- (law_both n adj V V' (fun i => r i t) (fun i => v i t) i S P Hi Ap). now apply M2. }
  split.
  - intros r0 v0 A. destruct (tanner2_lasting.starts n adj W W' S NL VS VS' Pot C1 r0 v0 A) as (r & v & E & M). exists r, v. split; [|exact E].
    apply Mo; [|exact M]. intros i j Hi Hj L. cbv beta. rewrite (proj1 (E i Hi)), (proj1 (E j Hj)). now apply A.
  - intros T r v HT [A M]. destruct (tanner2_lasting.goes_on n adj W W' S NL VS VS' Pot C1 T r v HT A) as (r' & v' & E & M').
    + intros t Ht. split; [intros i Hi; now apply (M t i Ht Hi)|]. intros Ap i Hi. unfold W'. rewrite (law_both n adj V V' (fun i => r i t) (fun i => v i t) i S P Hi Ap). now apply (M t i Ht Hi).
    + exists r', v'. split; [|intros t i Ht Hi; apply E; [apply Ht|exact Hi]]. apply Mo; [|exact M'].
      intros i j Hi Hj L. cbv beta. rewrite (proj1 (E 0 i HT Hi)), (proj1 (E 0 j HT Hj)). now apply A.
Qed.
Lemma thm1a_proved : thm1a.
Proof. split; [exact last_for_ever_proved|exact T2.thm1a_proved]. Qed.
Lemma thm1c_2_proved : thm1c_2.
Proof. split; [exact last_for_ever_proved|exact T2.thm1c_2_proved]. Qed.
Lemma cor1_4_proved : cor1_4.
Proof. split; [exact last_for_ever_proved|exact T2.cor1_4_proved]. Qed.
Lemma cor1_5_proved : cor1_5.
Proof. split; [exact last_for_ever_proved|exact T2.cor1_5_proved]. Qed.
Lemma angle_is (v : C) : v <> RtoC 0 -> tanner_angle.is_angle v (angle v).
Proof.
  intros N. assert (Pm : 0 < Cmod v) by (apply Cmod_gt_0; exact N). pose proof PI_RGT_0 as PP. unfold angle. destruct v as [x y]. cbn [fst snd] in *. set (m := Cmod (x, y)) in *.
  assert (Sq : x * x + y * y = m * m). { unfold m, Cmod. cbn [fst snd]. rewrite sqrt_sqrt; [ring|]. pose proof (Rle_0_sqr x). pose proof (Rle_0_sqr y). unfold Rsqr in *. nra. }
  destruct (Req_EM_T (m + x) 0) as [E|E].
  - assert (X : x = - m) by lra. assert (Y : y = 0) by nra. split; [lra|]. fold m. cbn [fst snd]. rewrite cos_PI, sin_PI. lra.
  - assert (Pd : 0 < m + x). { assert (- m <= x); [|lra]. pose proof (Rle_0_sqr y) as Q. unfold Rsqr in Q. apply Rnot_lt_le. intros L. nra. }
    set (q := y / (m + x)). pose proof (atan_bound q) as B. split; [lra|]. fold m. cbn [fst snd].
    pose proof (tanner_angle.root_pos q) as R0. pose proof (sqrt_sqrt (1 + q²) ltac:(pose proof (Rle_0_sqr q); lra)) as R2.
    rewrite cos_2a, sin_2a, cos_atan, sin_atan. unfold Rsqr in *. set (s := sqrt (1 + q * q)) in *.
    assert (Q1 : q * (m + x) = y) by (unfold q; field; lra).
    replace (1 / s * (1 / s) - q / s * (q / s)) with ((1 - q * q) / (s * s)) by (field; lra). replace (2 * (q / s) * (1 / s)) with (2 * q / (s * s)) by (field; lra). rewrite R2.
    assert (Dn : 0 < 1 + q * q) by (pose proof (Rle_0_sqr q) as Z; unfold Rsqr in Z; lra).
    assert (K1 : (1 + q * q) * (m + x) = 2 * m). { apply (Rmult_eq_reg_r (m + x)); [|lra]. replace ((1 + q * q) * (m + x) * (m + x)) with ((m + x) * (m + x) + (q * (m + x)) * (q * (m + x))) by ring. rewrite Q1. nra. }
    split; (apply (Rmult_eq_reg_r (1 + q * q)); [|lra]).
    + replace (m * ((1 - q * q) / (1 + q * q)) * (1 + q * q)) with (m * (1 - q * q)) by (field; lra). nra.
    + replace (m * (2 * q / (1 + q * q)) * (1 + q * q)) with (2 * m * q) by (field; lra). rewrite <- K1, <- Q1. ring.
Qed.
Lemma eq2_proved : eq2.
Proof.
  intros v N. destruct (tanner_angle.arctan2_angle v N) as [_ U]. pose proof (angle_is v N) as A. pose proof (U _ A) as E.
  destruct (tanner_angle.arctan2_formulas (fst v) (snd v)) as (F1 & F2 & F3 & F4). split; [split; [apply A|]|].
  - destruct A as (_ & A1 & A2). apply injective_projections; cbn; rewrite ?A1, ?A2; ring.
  - rewrite E. split; [exact F1|]. split; [exact F2|]. split; [intros H; rewrite (F3 H); field|intros H1 H2; now apply F4].
Qed.
Lemma Omega_bounded_3_proved : Omega_bounded_3.
Proof. intros n adj c x v th i [A _] Hi. apply Rabs_le_between. now apply A. Qed.
Lemma Omega_is n adj c x v th : Omega n adj c x v th <-> tanner_angle.in_Omega n adj T1.fig2 c x v th.
Proof.
  split; intros [A (r & B & Ap & W)]; split; try (intros i Hi; apply Rabs_le_between; now apply A); exists r; split; try exact B; split; try exact Ap; [rewrite <- T1.Vt_is|rewrite T1.Vt_is]; exact W.
Qed.
Lemma to_is z l : to z l -> tanner_trees.tends z l.
Proof.
  intros H. split; apply is_lim_seq_spec; intros e; destruct (H e (cond_pos e)) as [K HK]; exists K; intros k Hk; specialize (HK k Hk).
  - apply Rle_lt_trans with (2 := HK). apply (tanner_trees.fst_le (z k - l)%C).
  - apply Rle_lt_trans with (2 := HK). apply (tanner_trees.snd_le (z k - l)%C).
Qed.
Lemma Omega_closed_proved : Omega_closed.
Proof.
  intros n adj c x v th y u al S NL In X Vv A. apply Omega_is. apply (tanner_angle.Omega_limits n adj T1.fig2 (fun _ _ => tanner1_heading.V2') c x v th y u al S NL).
  - reflexivity.
  - intros i j _ _ _. exact tanner_rates.V2_potential.
  - intros k. now apply Omega_is.
  - intros i j Hi Hj. now apply to_is, X.
  - intros i Hi. now apply to_is, Vv.
  - intros i Hi. apply is_lim_seq_spec. intros e. destruct (A i Hi e (cond_pos e)) as [K HK]. exists K. intros k Hk. now apply HK.
Qed.
