(* Tanner, Jadbabaie, Pappas, equation (2): the two-argument arctangent of a velocity is its angle; the set Omega of the first paper, whose angles
   lie in [-pi, pi], is closed.
     tanner1.eq2, beyond.tanner2.eq2, tanner1.Omega.closed, tanner1.Omega.bounded (clause 3). *)
From Coq Require Import Reals Lra Lia Psatz.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums paley_model paley_phase paley_laplacian tanner_energy tanner_flock tanner2_motion tanner_trees tanner1_heading.
Open Scope R_scope.

Definition arctan2 (y x : R) : R := if Rlt_dec 0 x then atan (y / x) else if Rlt_dec 0 y then PI / 2 - atan (x / y)
  else if Rlt_dec y 0 then - (PI / 2) - atan (x / y) else PI.
Definition is_angle (v : C) (a : R) := - PI < a <= PI /\ fst v = Cmod v * cos a /\ snd v = Cmod v * sin a.

Lemma angle_half a : - PI < a < PI -> sin a = 0 -> a = 0.
Proof.
  intros H S. destruct (Rtotal_order a 0) as [L|[E|L]]; [|exact E|].
  - pose proof (sin_gt_0 (- a) ltac:(lra) ltac:(lra)) as P. rewrite sin_neg in P. lra.
  - pose proof (sin_gt_0 a L ltac:(lra)). lra.
Qed.
Lemma angle_unique (v : C) a b : v <> 0%C -> is_angle v a -> is_angle v b -> a = b.
Proof.
  intros N (Ha & A1 & A2) (Hb & B1 & B2). assert (P : 0 < Cmod v) by (apply Cmod_gt_0; exact N).
  assert (E1 : cos a = cos b) by (apply (Rmult_eq_reg_l (Cmod v)); lra). assert (E2 : sin a = sin b) by (apply (Rmult_eq_reg_l (Cmod v)); lra).
  assert (S : sin ((a - b) / 2) = 0).
  { assert (K : cos (a - b) = 1) by (rewrite cos_minus, E1, E2; pose proof (sin2_cos2 b) as Q; unfold Rsqr in Q; lra).
    replace (a - b) with (2 * ((a - b) / 2)) in K by field. rewrite cos_2a_sin in K. nra. }
  apply angle_half in S; lra.
Qed.
Lemma root_right x y : 0 < x -> Cmod (x, y) = x * sqrt (1 + (y / x)²).
Proof.
  intros H. unfold Cmod. cbn [fst snd]. rewrite <- (sqrt_pow2 x) at 2 by lra. rewrite <- sqrt_mult_alt by apply pow2_ge_0. f_equal. unfold Rsqr. field. lra.
Qed.
Lemma root_up x y : 0 < y -> Cmod (x, y) = y * sqrt (1 + (x / y)²).
Proof.
  intros H. unfold Cmod. cbn [fst snd]. rewrite <- (sqrt_pow2 y) at 2 by lra. rewrite <- sqrt_mult_alt by apply pow2_ge_0. f_equal. unfold Rsqr. field. lra.
Qed.
Lemma root_down x y : y < 0 -> Cmod (x, y) = - y * sqrt (1 + (x / y)²).
Proof.
  intros H. unfold Cmod. cbn [fst snd]. rewrite <- (sqrt_pow2 (- y)) by lra. rewrite <- sqrt_mult_alt by apply pow2_ge_0. f_equal. unfold Rsqr. field. lra.
Qed.
Lemma root_pos q : 0 < sqrt (1 + q²).
Proof. apply sqrt_lt_R0. pose proof (Rle_0_sqr q). lra. Qed.
Lemma angle_right x y : 0 < x -> is_angle (x, y) (atan (y / x)).
Proof.
  intros H. pose proof (atan_bound (y / x)). pose proof PI_RGT_0. pose proof (root_pos (y / x)). split; [lra|]. cbn [fst snd].
  rewrite (root_right x y H), cos_atan, sin_atan. split; field; lra.
Qed.
Lemma angle_up x y : 0 < y -> is_angle (x, y) (PI / 2 - atan (x / y)).
Proof.
  intros H. pose proof (atan_bound (x / y)). pose proof PI_RGT_0. pose proof (root_pos (x / y)). split; [lra|]. cbn [fst snd].
  rewrite (root_up x y H), cos_shift, sin_shift, cos_atan, sin_atan. split; field; lra.
Qed.
Lemma angle_down x y : y < 0 -> is_angle (x, y) (- (PI / 2) - atan (x / y)).
Proof.
  intros H. pose proof (atan_bound (x / y)). pose proof PI_RGT_0. pose proof (root_pos (x / y)). split; [lra|]. cbn [fst snd].
  replace (- (PI / 2) - atan (x / y)) with (- (PI / 2 - - atan (x / y))) by ring.
  rewrite (root_down x y H), cos_neg, sin_neg, cos_shift, sin_shift, sin_neg, cos_neg, cos_atan, sin_atan. split; field; lra.
Qed.
Lemma angle_left x : x < 0 -> is_angle (x, 0) PI.
Proof.
  intros H. pose proof PI_RGT_0. split; [lra|]. cbn [fst snd]. rewrite cos_PI, sin_PI. split; [|ring].
  unfold Cmod. cbn [fst snd]. replace (x ^ 2 + 0 ^ 2) with ((- x) ^ 2) by ring. rewrite sqrt_pow2 by lra. ring.
Qed.
(* the angle of a velocity, in (-pi, pi]; in each half plane it is what the one-argument arctangent gives *)
Theorem arctan2_angle (v : C) : v <> 0%C -> is_angle v (arctan2 (snd v) (fst v)) /\ forall a, is_angle v a -> a = arctan2 (snd v) (fst v).
Proof.
  intros N. assert (A : is_angle v (arctan2 (snd v) (fst v))).
  { destruct v as [x y]. unfold arctan2. cbn [fst snd]. destruct (Rlt_dec 0 x); [now apply angle_right|]. destruct (Rlt_dec 0 y); [now apply angle_up|].
    destruct (Rlt_dec y 0); [now apply angle_down|]. replace y with 0 in * by lra. apply angle_left.
    destruct (Req_dec x 0) as [->|]; [exfalso; now apply N|lra]. }
  split; [exact A|]. intros a Ha. now apply (angle_unique v).
Qed.
Theorem arctan2_formulas x y : (0 < x -> arctan2 y x = atan (y / x)) /\ (0 < y -> arctan2 y x = PI / 2 - atan (x / y)) /\
  (y < 0 -> arctan2 y x = - (PI / 2) - atan (x / y)) /\ (x < 0 -> y = 0 -> arctan2 y x = PI).
Proof.
  assert (K : forall a, ((x, y) : C) <> RtoC 0 -> is_angle (x, y) a -> arctan2 y x = a).
  { intros a N H. destruct (arctan2_angle (x, y) N) as [_ U]. symmetry. now apply U. }
  assert (Nx : x <> 0 -> ((x, y) : C) <> RtoC 0) by (intros Q E; injection E as E1 E2; contradiction).
  assert (Ny : y <> 0 -> ((x, y) : C) <> RtoC 0) by (intros Q E; injection E as E1 E2; contradiction).
  repeat split; intros; apply K; try (apply Nx; lra); try (apply Ny; lra); [now apply angle_right|now apply angle_up|now apply angle_down|subst y; now apply angle_left].
Qed.

(* ---- Omega: triples of relative positions, velocities and angles in [-pi, pi] with V_t <= c, linked agents apart ---- *)
Definition in_Omega n adj V c (x : nat -> nat -> C) (v : nat -> C) (th : nat -> R) := (forall i, (i < n)%nat -> - PI <= th i <= PI) /\
  exists r : nat -> C, (forall i j, (i < n)%nat -> (j < n)%nat -> x i j = (r i - r j)%C) /\ distinct n adj r /\ Vt n adj V r v th <= c.
Lemma Vt_energy n adj V r v th : Vt n adj V r v th = Wenergy n adj V r v + / 2 * Sum n (fun i => th i ^ 2).
Proof. unfold Vt, Wenergy. rewrite <- Rmult_plus_distr_l, <- Sum_plus. reflexivity. Qed.
Theorem Omega_angles n adj V c x v th i : in_Omega n adj V c x v th -> (i < n)%nat -> - PI <= th i <= PI.
Proof. intros [A _] Hi. now apply A. Qed.
(* a limit of points of Omega is one *)
Theorem Omega_limits n adj V V' c (x : nat -> nat -> nat -> C) (v : nat -> nat -> C) (th : nat -> nat -> R) (y : nat -> nat -> C) (u : nat -> C) (al : nat -> R) :
  undirected adj -> no_loops adj -> (forall i j, V i j = V j i) ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> potential (V i j) (V' i j)) ->
  (forall k, in_Omega n adj V c (x k) (v k) (th k)) ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> tends (fun k => x k i j) (y i j)) -> (forall i, (i < n)%nat -> tends (fun k => v k i) (u i)) ->
  (forall i, (i < n)%nat -> is_lim_seq (fun k => th k i) (al i)) -> in_Omega n adj V c y u al.
Proof.
  intros S NL VS Pot In TX TV TA.
  assert (Rel : forall q q' : nat -> C, (forall i j, (i < n)%nat -> (j < n)%nat -> (q i - q j)%C = (q' i - q' j)%C) -> forall z, Wenergy n adj V q z = Wenergy n adj V q' z).
  { intros q q' E z. unfold Wenergy, V_i. f_equal. apply Sum_ext. intros i Hi. f_equal. apply Sum_ext. intros j Hj. now rewrite (E i j Hi Hj). }
  set (r := fun k i => x k i 0%nat).
  assert (Xr : forall k i j, (i < n)%nat -> (j < n)%nat -> x k i j = (r k i - r k j)%C).
  { intros k i j Hi Hj. destruct (In k) as (_ & q & E & _). unfold r. rewrite !E by lia. ring. }
  assert (Wr : forall k, distinct n adj (r k) /\ Wenergy n adj V (r k) (v k) + / 2 * Sum n (fun i => th k i ^ 2) <= c).
  { intros k. destruct (In k) as (_ & q & E & D & W). rewrite Vt_energy in W. split.
    - intros i j Hi Hj A F. apply (D i j Hi Hj A). replace (q i) with ((q i - q j) + q j)%C by ring. rewrite <- E, Xr, F by assumption. ring.
    - rewrite (Rel (r k) q); [exact W|]. intros i j Hi Hj. rewrite <- E, <- Xr by assumption. reflexivity. }
  assert (TX' : forall K i j, (i < n)%nat -> (j < n)%nat -> tends (fun k => r (k + K)%nat i - r (k + K)%nat j)%C (y i j)).
  { intros K i j Hi Hj. destruct (TX i j Hi Hj) as [A B].
    split; [apply (is_lim_seq_ext (fun k => fst (x (k + K)%nat i j)))|apply (is_lim_seq_ext (fun k => snd (x (k + K)%nat i j)))];
      try (intros k; now rewrite (Xr (k + K)%nat i j Hi Hj)); [now apply (is_lim_seq_incr_n (fun k => fst (x k i j)) K)|now apply (is_lim_seq_incr_n (fun k => snd (x k i j)) K)]. }
  assert (TV' : forall K i, (i < n)%nat -> tends (fun k => v (k + K)%nat i) (u i)).
  { intros K i Hi. destruct (TV i Hi) as [A B]. split; [now apply (is_lim_seq_incr_n (fun k => fst (v k i)) K)|now apply (is_lim_seq_incr_n (fun k => snd (v k i)) K)]. }
  assert (Lim : forall c' K, (forall k, Wenergy n adj V (r (k + K)%nat) (v (k + K)%nat) <= c') ->
    exists q : nat -> C, (forall i j, (i < n)%nat -> (j < n)%nat -> y i j = (q i - q j)%C) /\ distinct n adj q /\ Wenergy n adj V q u <= c').
  { intros c' K B. apply (Omega_closed n adj V V' c' (fun k => r (k + K)%nat) (fun k => v (k + K)%nat) y u S NL VS Pot).
    - intros k. split; [apply Wr|apply B].
    - apply TX'.
    - apply TV'. }
  assert (SA : is_lim_seq (fun k => / 2 * Sum n (fun i => th k i ^ 2)) (/ 2 * Sum n (fun i => al i ^ 2))).
  { apply (is_lim_seq_scal_l _ (/ 2) (Sum n (fun i => al i ^ 2))). apply (tends_Sum n (fun i k => th k i ^ 2) (fun i => al i ^ 2)). intros i Hi.
    apply (is_lim_seq_ext (fun k => th k i * th k i)); [intros; cbn; Rring|]. replace (al i ^ 2) with (al i * al i) by Rring. apply is_lim_seq_mult'; now apply TA. }
  destruct (Lim c 0%nat) as (q & Q1 & Q2 & Q3).
  { intros k. destruct (Wr (k + 0)%nat) as [_ B]. assert (0 <= Sum n (fun i => th (k + 0)%nat i ^ 2)) by (apply Sum_ge0; intros; apply pow2_ge_0). lra. }
  split.
  - intros i Hi. pose proof (TA i Hi) as T. split.
    + apply (is_lim_seq_le (fun _ => - PI) (fun k => th k i) (- PI) (al i)); [intros k; now apply In|apply is_lim_seq_const|exact T].
    + apply (is_lim_seq_le (fun k => th k i) (fun _ => PI) (al i) PI); [intros k; now apply In|exact T|apply is_lim_seq_const].
  - exists q. split; [exact Q1|]. split; [exact Q2|]. rewrite Vt_energy. apply le_epsilon. intros e He.
    apply is_lim_seq_spec in SA. destruct (SA (mkposreal e He)) as [K HK]. cbn [pos] in HK.
    destruct (Lim (c - / 2 * Sum n (fun i => al i ^ 2) + e) K) as (q' & P1 & P2 & P3).
    { intros k. destruct (Wr (k + K)%nat) as [_ B]. specialize (HK (k + K)%nat ltac:(lia)). apply Rabs_def2 in HK. cbv beta in HK. lra. }
    rewrite (Rel q q'); [lra|]. intros i j Hi Hj. now rewrite <- Q1, <- P1.
Qed.
