(* More clauses, most of them corrected ones, formalised from their words before the theorems were looked at; the theorems prove them,
   but for those whose proof here is of its own. *)
From Coq Require Import Reals Lra Lia List Relations Psatz.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import IntervalStdZ RealSums paley_model paley_phase paley_laplacian paley_gradient paley_particles tanner_energy tanner_flock.
From Flockproof Require paley_gradient tanner_graph tanner1_heading tanner1_motion veerman_numbers chazelle_worked audit_independent_angle audit_independent_tanner1 audit_independent_veerman.
Module A := audit_independent_angle.
Module T1 := audit_independent_tanner1.
Module V := audit_independent_veerman.
Open Scope R_scope.

(* ======== Chazelle, in real numbers ======== *)
(* chazelle.epsineq clause 1 *)
Definition epsineq_1 : Prop := forall nu : nat, (1 <= nu)%nat -> exp (- (INR nu ^ (nu ^ 2))) < / INR nu ^ (nu ^ 4).
(* chazelle.eq3.15 clause 1; the lifted x_i(t), v_i(t) and w, and one constant for all flocks and times *)
Definition eq3_15_1 : Prop := exists B, forall (d : nat) (x v : nat -> R) (t : nat), (1 <= t)%nat ->
  let x' := A.lift d x (INR t) in let v' := A.lift d v 1 in let w k := x' k / INR t in
  (exists k, (k < S d)%nat /\ v' k <> w k) ->
  Rabs (A.angle_of (S d) x' v' / A.length_of (S d) (fun k => v' k - w k)) <= B.

(* ======== Tanner ======== *)
(* tanner1.L.ones clause 2 *)
Definition L_ones_2 : Prop := forall n adj, undirected adj -> no_loops adj -> strongly_connected n adj -> forall x : nat -> R,
  (exists i, (i < n)%nat /\ x i <> 0) ->
  ((forall i, (i < n)%nat -> Sum n (fun j => lap n adj i j * x j) = 0 * x i) <-> exists c, forall i, (i < n)%nat -> x i = c * 1).
(* tanner1.Lw clause 4; the incidence matrix D of an orientation O, and weights W of its edges *)
Definition inc_of (i : nat) (e : nat * nat) : R := if Nat.eqb i (fst e) then 1 else if Nat.eqb i (snd e) then - 1 else 0.
Definition DWD (O : list (nat * nat)) (W : nat * nat -> R) (i j : nat) : R := lsum O (fun e => inc_of i e * W e * inc_of j e).
Definition Lw_4 : Prop := forall n adj O W, undirected adj -> no_loops adj -> tanner_graph.oriented n adj O -> (forall e, In e O -> 0 < W e) ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> DWD O W i j = DWD O W j i) /\
  forall x : nat -> R, 0 <= Sum n (fun i => x i * Sum n (fun j => DWD O W i j * x j)).
(* tanner1.Vmono clause 2 *)
Definition Vmono_2 : Prop := forall i j r s, 0 < r < s ->
  (s <= 1 -> T1.fig2 i j s < T1.fig2 i j r) /\ (1 <= r -> T1.fig2 i j r < T1.fig2 i j s).
(* tanner1.collision clause 3; V_t of (8), with headings th: V_t exceeds every c where two linked agents are near enough, wherever the others are *)
Definition collision_3 : Prop := forall n adj, undirected adj -> no_loops adj -> forall c, exists e, 0 < e /\
  forall (r v : nat -> C) (th : nat -> R), (forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> r i <> r j) ->
  (exists i j, (i < n)%nat /\ (j < n)%nat /\ adj i j = true /\ Cmod (r i - r j)%C < e) -> c < T1.kinetic_plus_V n adj T1.fig2 r v + / 2 * Sum n (fun i => th i ^ 2).

(* ======== Veerman ======== *)
(* veerman.cor1.proof clause 2; h are the places of the cars *)
Definition cor1_proof_2 : Prop := forall (f g w : R) (h : nat -> R) (a : nat -> C) k t, (1 <= k)%nat ->
  let x j s := (RtoC (h j) + a j * expi (w * s))%C in let u j s := (Ci * RtoC w * a j * expi (w * s))%C in
  (is_velocity (x k) t (u k t) /\
   is_velocity (u k) t (RtoC f * ((x k t - RtoC (h k)) - (x (k - 1)%nat t - RtoC (h (k - 1)%nat))) + RtoC g * (u k t - u (k - 1)%nat t))%C) <->
  (- RtoC (w ^ 2) * a k = RtoC f * (a k - a (k - 1)%nat) + Ci * RtoC w * RtoC g * (a k - a (k - 1)%nat))%C.
(* veerman.nth_neighbour clause 3; the agents are 0, .., N + 1 *)
Definition joined (N n : nat) : nat -> nat -> Prop := clos_refl_sym_trans nat (fun k j => (k <= S N)%nat /\ (j <= S N)%nat /\ (k = j + n)%nat).
Definition nth_3 : Prop := forall N n, (2 <= n)%nat -> ~ forall i j, (i <= S N)%nat -> (j <= S N)%nat -> joined N n i j.
(* veerman.sep_remark clause 2; the cars of system (1) at the response to the leader h_0 + a_0 cos(w t) *)
Definition sep_remark_2 : Prop := forall (f g w a0 : R) (h : nat -> R) (a : nat -> C) (x : nat -> R -> R),
  V.z f g w <> 0%C -> V.gam f g w <> 0%C -> V.response1 f g w a -> (forall k t, x k t = h k + a0 * Re (a k * expi (w * t))%C) ->
  forall k, h (S k) - h k = 1 -> forall t,
  x (S k) t - x k t = a0 * Re (/ V.power (V.gam f g w) (k + 1) * expi (w * t))%C - a0 * Re (/ V.power (V.gam f g w) k * expi (w * t))%C + 1.
(* veerman.table1_theory clause 3; the numbers of column NFREQ, N = 4, 8, .., 128 *)
Definition table1_3 : Prop := forall N p, In (N, p) ((4, 0.2776801836) :: (8, 0.1388400918) :: (16, 0.0694200459) :: (32, 0.0347100229) ::
    (64, 0.0173550115) :: (128, 0.0086775057) :: nil) ->
  Rabs (sqrt (Rabs (- 1)) * PI / (N * 2 * sqrt 2) - p) <= / 10 ^ 10.
(* veerman.table1_theory clause 4; the numbers of column NAMP *)
Definition table1_4 : Prop := forall N p, In (N, p) ((4, 4.58527335) :: (8, 9.17054669) :: (16, 18.34109338) :: (32, 36.68218677) ::
    (64, 73.36437354) :: (128, 146.72874707) :: nil) ->
  Rabs (8 * sqrt (2 * Rabs (- 1)) / (PI ^ 2 * Rabs (- 1)) * N - p) <= / 10 ^ 8.
(* veerman.thm1_x clauses 3, 4: stated in audit_independent_veerman.v *)
Definition thm1_x_34 : Prop := V.thm1_x.

(* ---- the theorems prove them; DWD, the wave of (1), the n-th neighbours and the table have short proofs of their own ---- *)
Lemma epsineq_1_holds : epsineq_1.
Proof. intros nu H. rewrite <- pow_INR. exact (chazelle_worked.eps_inequality nu H). Qed.
Lemma eq3_15_1_holds : eq3_15_1.
Proof.
  exists 1. intros d x v t Ht x' v' w _. destruct (A.angle_1_proved d x v t Ht) as [L _].
  assert (T : 0 < INR t) by (apply lt_0_INR; lia).
  assert (E : A.length_of (S d) (fun k => v' k - w k) = A.length_of d (fun k => v k - x k / INR t)).
  { unfold A.length_of. f_equal. set (F := fun k => v' k - w k). change (A.inner_of (S d) F F) with (A.inner_of d F F + F d * F d).
    replace (F d) with 0 by (unfold F, w, v', x', A.lift; rewrite Nat.eqb_refl; field; lra). rewrite Rmult_0_l, Rplus_0_r.
    apply A.inner_ext. intros k Hk. unfold F, w, v', x', A.lift. destruct (Nat.eqb_spec k d); [lia|split; reflexivity]. }
  rewrite E. fold x' v' in L. set (l := A.length_of d _) in *. assert (L0 : 0 <= l) by apply sqrt_pos.
  assert (A0 : 0 <= A.angle_of (S d) x' v') by (unfold A.angle_of; apply acos_bound).
  destruct (Req_dec l 0) as [Z|N].
  - replace (A.angle_of (S d) x' v') with 0 by lra. unfold Rdiv. rewrite Rmult_0_l, Rabs_R0. lra.
  - assert (P : 0 < l) by lra. rewrite Rabs_right by (apply Rle_ge, Rdiv_le_0_compat; lra).
    apply (Rmult_le_reg_r l); [exact P|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra. lra.
Qed.
Lemma L_ones_2_holds : L_ones_2.
Proof.
  intros n adj _ _ SC x (i0 & Hi & _). split.
  - intros E. destruct (paley_gradient.lap_kernel n adj x ltac:(lia) SC) as [c Hc].
    + intros k Hk. unfold paley_gradient.lmul. rewrite (E k Hk). ring.
    + exists c. intros i H. rewrite (Hc i H). ring.
  - intros [c Hc] i H. rewrite Rmult_0_l, <- (paley_gradient.lap_ones n adj (c * 1) i H). unfold paley_gradient.lmul.
    apply Sum_ext. intros j Hj. now rewrite (Hc j Hj).
Qed.
Lemma Lw_4_holds : Lw_4.
Proof.
  intros n adj O W _ _ _ WP. split.
  - intros i j _ _. clear WP. induction O as [|e O IH]; [reflexivity|].
    change (inc_of i e * W e * inc_of j e + DWD O W i j = inc_of j e * W e * inc_of i e + DWD O W j i). rewrite IH. ring.
  - intros x. induction O as [|e O IH].
    + rewrite Sum_zero; [lra|]. intros i _. rewrite Sum_zero; [ring|]. intros j _. cbn. ring.
    + set (y := Sum n (fun i => x i * inc_of i e)).
      replace (Sum n (fun i => x i * Sum n (fun j => DWD (e :: O) W i j * x j)))
        with (W e * y * y + Sum n (fun i => x i * Sum n (fun j => DWD O W i j * x j))).
      * assert (0 <= W e * y * y). { rewrite Rmult_assoc. apply Rmult_le_pos; [left; apply WP; now left|apply Rle_0_sqr]. }
        specialize (IH (fun e' He => WP e' (or_intror He))). lra.
      * replace (W e * y * y) with (Sum n (fun i => x i * inc_of i e * (W e * y))) by (rewrite Sum_scal_r; fold y; ring).
        rewrite <- Sum_plus. apply Sum_ext. intros i _.
        replace (Sum n (fun j => DWD (e :: O) W i j * x j)) with (inc_of i e * W e * y + Sum n (fun j => DWD O W i j * x j)); [ring|].
        unfold y. rewrite <- Sum_scal, <- Sum_plus. apply Sum_ext. intros j _.
        change (DWD (e :: O) W i j) with (inc_of i e * W e * inc_of j e + DWD O W i j). ring.
Qed.
Lemma Vmono_2_holds : Vmono_2.
Proof. intros i j r s H. destruct tanner1_heading.fig2_shape as (A & B & _). split; intros L; [now apply A|apply B; lra]. Qed.
Lemma nth_3_holds : nth_3.
Proof.
  intros N n Hn H. assert (M : forall i j, joined N n i j -> (i mod n = j mod n)%nat).
  { clear H. intros i j H. induction H as [i j (_ & _ & ->)|i|i j _ IH|i j k _ IH1 _ IH2]; try congruence.
    rewrite <- (Nat.mul_1_l n) at 1. now rewrite Nat.mod_add by lia. }
  specialize (M _ _ (H 0%nat 1%nat ltac:(lia) ltac:(lia))). rewrite Nat.mod_0_l, Nat.mod_small in M by lia. discriminate.
Qed.
Lemma sep_remark_2_holds : sep_remark_2.
Proof.
  intros f g w a0 h a x Z G Hr Hx k Hh t. destruct (proj1 (V.cor1_proved f g w a Z G) Hr) as [_ E].
  rewrite !Hx, !E, Nat.add_1_r. lra.
Qed.
Lemma thm1_x_34_holds : thm1_x_34.
Proof. exact V.thm1_x_proved. Qed.
Lemma all_small n (P : nat -> R -> Prop) : (forall i e e', P i e -> 0 < e' <= e -> P i e') -> (forall i, (i < n)%nat -> exists e, 0 < e /\ P i e) ->
  exists e, 0 < e /\ forall i, (i < n)%nat -> P i e.
Proof.
  intros M. induction n as [|n IH]; intros H; [exists 1; split; [lra|lia]|].
  destruct IH as (e & E & He); [intros i Hi; apply H; lia|]. destruct (H n ltac:(lia)) as (e' & E' & He').
  assert (Q : 0 < Rmin e e') by (apply Rmin_glb_lt; assumption). exists (Rmin e e'). split; [exact Q|]. intros i Hi.
  destruct (Nat.eq_dec i n) as [->|N]; [apply (M _ e'); [exact He'|split; [exact Q|apply Rmin_r]]|].
  apply (M _ e); [apply He; lia|split; [exact Q|apply Rmin_l]].
Qed.
Lemma collision_3_holds : collision_3.
Proof.
  intros n adj _ _ c. destruct tanner1_heading.fig2_shape as (A & B & V1 & V1').
  assert (P1 : forall s, 0 < s -> 1 <= tanner1_heading.V2 s).
  { intros s Hs. destruct (Req_dec s 1) as [->|N]; [lra|]. specialize (V1' s Hs N). lra. }
  set (Q := fun i j e => forall r : nat -> C, (forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> r i <> r j) -> adj i j = true ->
    Cmod (r i - r j)%C < e -> c < tanner1_heading.Vt n adj T1.fig2 r (fun _ => RtoC 0) (fun _ => 0)).
  destruct (all_small n (fun i e => forall j, (j < n)%nat -> Q i j e)) as (e & E & He).
  - intros i e e' H L j Hj r R1 R2 R3. apply (H j Hj r R1 R2). lra.
  - intros i Hi. apply (all_small n (fun j e => Q i j e)).
    + intros j e e' H L r R1 R2 R3. apply (H r R1 R2). lra.
    + intros j Hj. destruct (adj i j) eqn:Aij; [|exists 1; split; [lra|intros r _ F; rewrite Aij in F; discriminate]].
      destruct (tanner1_motion.Vt_linked n adj T1.fig2 (fun _ => RtoC 0) (fun _ => 0) i j c) as (d & D & Hd); try assumption.
      * intros a b s _ _ Hs. specialize (P1 s Hs). unfold tanner1_heading.V2, T1.fig2 in *. lra.
      * intros a b M _ _. exact (proj2 T1.fig2_repels M).
      * exists d. split; [exact D|]. intros r R1 _ R3. apply Hd; assumption.
  - exists e. split; [exact E|]. intros r v th R1 (i & j & Hi & Hj & Aij & L).
    apply (Rlt_le_trans _ _ _ (He i Hi j Hj r R1 Aij L)).
    unfold tanner1_heading.Vt, T1.kinetic_plus_V. rewrite <- Rmult_plus_distr_l, <- Sum_plus. apply Rmult_le_compat_l; [lra|].
    apply Sum_le. intros a _. pose proof (pow2_ge_0 (Cmod (v a))). pose proof (pow2_ge_0 (th a)).
    replace (inner (RtoC 0) (RtoC 0)) with 0 by (cbn; ring).
    replace (V_i n adj T1.fig2 r a) with (Sum n (fun j => if adj a j then T1.fig2 a j (Cmod (r a - r j)%C) else 0)); [lra|].
    unfold V_i. apply Sum_ext. intros b _. unfold w, norm. destruct (adj a b); ring.
Qed.
Lemma expi_unit t : (expi t * expi (- t) = 1)%C.
Proof.
  pose proof (sin2_cos2 t) as H. unfold Rsqr in H. unfold expi. rewrite cos_neg, sin_neg.
  apply injective_projections; cbn; [lra|ring].
Qed.
Lemma wave_rate (b z : C) w t : is_velocity (fun s => (b + z * expi (w * s))%C) t (Ci * RtoC w * z * expi (w * t))%C.
Proof. split; cbn; auto_derive; trivial; ring. Qed.
Lemma cor1_proof_2_holds : cor1_proof_2.
Proof.
  intros f g w h a k t Hk x u.
  assert (X : is_velocity (x k) t (u k t)) by apply wave_rate.
  assert (U : is_velocity (u k) t (- RtoC (w ^ 2) * a k * expi (w * t))%C).
  { split; cbn; auto_derive; trivial; ring. }
  assert (E : (RtoC f * ((x k t - RtoC (h k)) - (x (k - 1)%nat t - RtoC (h (k - 1)%nat))) + RtoC g * (u k t - u (k - 1)%nat t) =
    (RtoC f * (a k - a (k - 1)%nat) + Ci * RtoC w * RtoC g * (a k - a (k - 1)%nat)) * expi (w * t))%C) by (unfold x, u; ring).
  rewrite E. split.
  - intros [_ U']. assert (F : (- RtoC (w ^ 2) * a k * expi (w * t) = (RtoC f * (a k - a (k - 1)%nat) + Ci * RtoC w * RtoC g * (a k - a (k - 1)%nat)) * expi (w * t))%C).
    { destruct U as [U1 U2], U' as [U3 U4].
      apply injective_projections; [rewrite <- (is_derive_unique _ _ _ U1); now apply is_derive_unique|rewrite <- (is_derive_unique _ _ _ U2); now apply is_derive_unique]. }
    apply (f_equal (fun z => (z * expi (- (w * t)))%C)) in F. rewrite <- !Cmult_assoc, !expi_unit in F.
    replace (- RtoC (w ^ 2) * a k)%C with (- RtoC (w ^ 2) * (a k * 1))%C by ring. rewrite F. ring.
  - intros F. split; [exact X|]. rewrite <- F. exact U.
Qed.
Lemma table1_3_holds : table1_3.
Proof.
  intros N p H. rewrite (Rabs_left (- 1)) by lra. replace (- - 1) with 1 by lra. rewrite sqrt_1.
  destruct H as [H|[H|[H|[H|[H|[H|[]]]]]]]; injection H as <- <-; interval with (i_prec 60).
Qed.
Lemma table1_4_holds : table1_4.
Proof.
  intros N p H. rewrite (Rabs_left (- 1)) by lra. replace (- - 1) with 1 by lra. rewrite !Rmult_1_r.
  destruct H as [H|[H|[H|[H|[H|[H|[]]]]]]]; injection H as <- <-; interval with (i_prec 60).
Qed.
