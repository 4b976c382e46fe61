(* Tanner, Jadbabaie, Pappas, switching paper: the printed statements that fail, with their counterexamples, and the
   corrected ones: bounds from the energy, stuck equilibria, the projection in Corollary 2, the arctan of eq (2),
   the interval after (13), and the rate of Q away from the threshold. *)
From Coq Require Import Reals Lra Lia Psatz Relations.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums paley_model paley_phase paley_laplacian paley_gradient paley_particles tanner_energy tanner_flock tanner_nonsmooth tanner1_examples.
Open Scope R_scope.

Lemma potential_of_bounds V V' K : (forall s, 0 < s -> is_derive V s (V' s) /\ 0 <= V s) ->
  (forall s, 0 < s -> / s - K <= V s /\ s - K <= V s) -> potential V V'.
Proof.
  intros D B. split; [exact D|]. split; intros c.
  - exists (/ (Rabs (c + K) + 1)). pose proof (Rabs_pos (c + K)). pose proof (Rle_abs (c + K)). split; [apply Rinv_0_lt_compat; lra|].
    intros s Hs. assert (Rabs (c + K) + 1 < / s). { rewrite <- (Rinv_inv (Rabs (c + K) + 1)). apply Rinv_lt_contravar; [apply Rmult_lt_0_compat; lra|lra]. }
    pose proof (proj1 (B s ltac:(lra))). lra.
  - exists (Rabs (c + K) + 1). pose proof (Rabs_pos (c + K)). pose proof (Rle_abs (c + K)). intros s Hs. pose proof (proj2 (B s ltac:(lra))). lra.
Qed.

(* ---- V = 3 s^2 + 8/s^2: three collinear agents at rest at -1, 0, 1 are in equilibrium ---- *)
Definition VA (s : R) : R := 3 * s ^ 2 + 8 / s ^ 2.
Definition VA' (s : R) : R := 6 * s - 16 / s ^ 3.
Lemma VA_potential : potential VA VA'.
Proof.
  apply (potential_of_bounds VA VA' 1); intros s Hs; assert (P2 : 0 < s ^ 2) by (apply pow_lt; lra); assert (I2 : 0 < / s ^ 2) by now apply Rinv_0_lt_compat.
  - unfold VA, VA'. split; [|unfold Rdiv; nra]. auto_derive; [apply Rgt_not_eq; simpl in *; lra|field; lra].
  - unfold VA, Rdiv. assert (I1 : 0 < / s) by now apply Rinv_0_lt_compat. replace (/ s ^ 2) with (/ s * / s) by (field; lra).
    split; [pose proof (pow2_ge_0 (/ s - 1)); nra|pose proof (pow2_ge_0 (s - 1)); nra].
Qed.
Lemma VA'_continuous s : 0 < s -> continuity_pt VA' s.
Proof.
  intros Hs. apply continuity_pt_filterlim, (ex_derive_continuous VA'). unfold VA'. auto_derive. assert (0 < s ^ 3) by (apply pow_lt; lra). simpl in *. lra.
Qed.
Definition line3 (i : nat) : C := match i with 0%nat => RtoC (-1) | 1%nat => RtoC 0 | _ => RtoC 1 end.
Lemma line3_norms : norm (line3 0 - line3 1)%C = 1 /\ norm (line3 0 - line3 2)%C = 2 /\ norm (line3 1 - line3 0)%C = 1 /\
  norm (line3 1 - line3 2)%C = 1 /\ norm (line3 2 - line3 0)%C = 2 /\ norm (line3 2 - line3 1)%C = 1.
Proof. unfold line3. rewrite !RtoC_minus', !norm_real. repeat split; unfold Rabs; destruct (Rcase_abs _); lra. Qed.
Lemma self_grad V' q i : pair_grad complete V' q i i = RtoC 0.
Proof. unfold pair_grad, w, complete. rewrite Nat.eqb_refl. apply injective_projections; cbn [negb RtoC fst snd Cmult]; ring. Qed.
Lemma line3_balance i : (i < 3)%nat -> grad_i 3 complete (fun _ _ => VA') line3 i = RtoC 0.
Proof.
  intros Hi. destruct line3_norms as [A [B [C0 [D [E F]]]]]. assert (V1 : VA' 1 = -10) by (unfold VA'; field). assert (V2 : VA' 2 = 10) by (unfold VA'; field).
  unfold grad_i, Csum. cbn [Sum]. destruct i as [|[|[|]]]; try lia; rewrite self_grad; unfold pair_grad, grad; rewrite ?A, ?B, ?C0, ?D, ?E, ?F, ?V1, ?V2;
  unfold w, complete, line3; apply injective_projections; cbn; field.
Qed.
Lemma rest_control n adj V' q i : grad_i n adj V' q i = RtoC 0 -> control4 n adj V' q (fun _ => RtoC 0) i = RtoC 0.
Proof.
  intros H. unfold control4. rewrite H, Csum_0; [apply injective_projections; cbn; ring|]. intros j _. apply injective_projections; cbn; ring.
Qed.
Lemma rest_velocity (c : C) t : is_velocity (fun _ => c) t (RtoC 0).
Proof. split; apply D_const. Qed.
Lemma complete_connected n : strongly_connected n complete.
Proof.
  intros j k Hj Hk. destruct (Nat.eq_dec j k) as [->|N]; [apply rt_refl|]. apply rt_step. repeat split; try assumption.
  unfold complete. destruct (Nat.eqb_spec k j); [congruence|reflexivity].
Qed.
Lemma line3_apart i j : (i < 3)%nat -> (j < 3)%nat -> complete i j = true -> line3 i <> line3 j.
Proof. intros Hi Hj A. destruct i as [|[|[|]]], j as [|[|[|]]]; try lia; try discriminate A; intros E; injection E; lra. Qed.

(* the hypotheses of Theorem 1, for a solution that exists for all t >= 0 *)
Definition solution (n : nat) (adj : graph) (V V' : nat -> nat -> R -> R) (r v : nat -> R -> C) : Prop :=
  (1 <= n)%nat /\ undirected adj /\ no_loops adj /\ strongly_connected n adj /\ (forall i j, V i j = V j i) /\ (forall i j, V' i j = V' j i) /\
  (forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> potential (V i j) (V' i j)) /\
  (forall i j s, (i < n)%nat -> (j < n)%nat -> adj i j = true -> 0 < s -> continuity_pt (V' i j) s) /\
  (forall t i j, 0 <= t -> (i < n)%nat -> (j < n)%nat -> adj i j = true -> r i t <> r j t) /\
  (forall t i, 0 <= t -> (i < n)%nat -> is_velocity (r i) t (v i t)) /\
  (forall t i, 0 <= t -> (i < n)%nat -> is_velocity (v i) t (control4 n adj V' (fun i => r i t) (fun i => v i t) i)).
Lemma line3_solution : solution 3 complete (fun _ _ => VA) (fun _ _ => VA') (fun i _ => line3 i) (fun _ _ => RtoC 0).
Proof.
  split; [lia|]. split; [apply complete_undirected|]. split; [apply complete_no_loops|]. split; [apply complete_connected|].
  split; [reflexivity|]. split; [reflexivity|]. split; [intros; apply VA_potential|]. split; [intros; now apply VA'_continuous|].
  split; [intros t i j _ Hi Hj A; now apply line3_apart|]. split; [intros t i _ _; apply rest_velocity|].
  intros t i _ Hi. eapply velocity_eq; [apply rest_velocity|]. symmetry. apply rest_control. now apply line3_balance.
Qed.
Definition better (i : nat) : C := match i with 0%nat => RtoC 0 | 1%nat => RtoC (5 / 4) | _ => RtoC (- (5 / 4)) end.
Lemma self_term q i : w complete i i * VA (norm (q i - q i)%C) = 0.
Proof. unfold w, complete. rewrite Nat.eqb_refl. apply Rmult_0_l. Qed.
(* Theorem 1's last statement fails: this solution stays at V_0 = 25, while 19.6... is possible *)
Theorem thm1c_fails : ~ forall n adj V V' r v, solution n adj V V' r v -> forall i, (i < n)%nat -> forall e, 0 < e ->
  exists T, forall t, T <= t -> forall q : nat -> C, (forall a b, (a < n)%nat -> (b < n)%nat -> adj a b = true -> q a <> q b) ->
    V_i n adj V (fun j => r j t) i <= V_i n adj V q i + e.
Proof.
  intros H. destruct (H _ _ _ _ _ _ line3_solution 0%nat ltac:(lia) 1 ltac:(lra)) as [T L]. specialize (L T ltac:(lra) better). cbv beta in L.
  destruct line3_norms as [A [B _]]. unfold V_i in L. cbn [Sum] in L.
  rewrite (self_term (fun j => line3 j) 0), (self_term better 0), A, B in L. unfold better in L. rewrite !RtoC_minus', !norm_real in L.
  assert (N1 : Rabs (0 - 5 / 4) = 5 / 4) by (unfold Rabs; destruct (Rcase_abs _); lra).
  assert (N2 : Rabs (0 - - (5 / 4)) = 5 / 4) by (unfold Rabs; destruct (Rcase_abs _); lra). rewrite N1, N2 in L.
  assert (V1 : VA 1 = 11) by (unfold VA; field). assert (V2 : VA 2 = 14) by (unfold VA; field). assert (V54 : VA (5 / 4) = 3923 / 400) by (unfold VA; field).
  rewrite V1, V2, V54 in L. unfold w, complete in L. cbn [Nat.eqb negb] in L.
  assert (X : 0 + 0 + 1 * 11 + 1 * 14 <= 0 + 0 + 1 * (3923 / 400) + 1 * (3923 / 400) + 1); [|lra]. apply L.
  intros a b Ha Hb Ab. destruct a as [|[|[|]]], b as [|[|[|]]]; try lia; try discriminate Ab; intros E; injection E; lra.
Qed.
(* ... and it is no local minimum of V_0 either: a small sideways move of agent 0 lowers V_0 *)
Theorem thm1c_not_local : forall e, 0 < e -> exists q : nat -> C, (forall j, j <> 0%nat -> q j = line3 j) /\ norm (q 0%nat - line3 0%nat)%C < e /\
  V_i 3 complete (fun _ _ => VA) q 0 < V_i 3 complete (fun _ _ => VA) line3 0.
Proof.
  intros e He. set (y := Rmin (e / 2) (1 / 2)). assert (Hy : 0 < y) by (unfold y; apply Rmin_glb_lt; lra). pose proof (Rmin_l (e / 2) (1 / 2)). pose proof (Rmin_r (e / 2) (1 / 2)). fold y in H, H0.
  exists (fun j => match j with 0%nat => (-1, y) | _ => line3 j end). split; [intros [|j] Hj; [contradiction|reflexivity]|]. split.
  - unfold norm, Cmod, line3; cbn. replace ((-1 + - -1) * ((-1 + - -1) * 1) + (y + - 0) * ((y + - 0) * 1)) with (y * y) by ring. rewrite sqrt_square; lra.
  - destruct line3_norms as [A [B _]]. unfold V_i. cbn [Sum].
    rewrite (self_term line3 0), A, B.
    assert (S2 : forall x yy, VA (norm (x, yy)) = 3 * (x * x + yy * yy) + 8 / (x * x + yy * yy)).
    { intros x yy. unfold VA. replace (norm (x, yy) ^ 2) with (x * x + yy * yy); [reflexivity|]. replace (norm (x, yy) ^ 2) with (norm (x, yy) * norm (x, yy)) by ring. now rewrite norm_sqr, inner_xy. }
    assert (V1 : VA 1 = 11) by (unfold VA; field). assert (V2 : VA 2 = 14) by (unfold VA; field). rewrite V1, V2.
    unfold w, complete, line3. cbn [Nat.eqb negb]. unfold Cminus, Cplus, Copp, RtoC; cbn [fst snd]. rewrite !S2.
    set (Y := y * y). assert (HY : 0 < Y <= 1 / 4) by (unfold Y; nra).
    replace ((-1 + - 0) * (-1 + - 0) + (y + - 0) * (y + - 0)) with (1 + Y) by (unfold Y; ring).
    replace ((-1 + - (1)) * (-1 + - (1)) + (y + - 0) * (y + - 0)) with (4 + Y) by (unfold Y; ring).
    assert (I1 : 8 / (1 + Y) = 8 - 8 * Y / (1 + Y)) by (field; lra). assert (I2 : 8 / (4 + Y) = 2 - 2 * Y / (4 + Y)) by (field; lra). rewrite I1, I2.
    assert (J1 : 6 * Y < 8 * Y / (1 + Y)). { apply (Rmult_lt_reg_r (1 + Y)); [lra|]. replace (8 * Y / (1 + Y) * (1 + Y)) with (8 * Y) by (field; lra). nra. }
    assert (J2 : 0 < 2 * Y / (4 + Y)) by (apply Rdiv_lt_0_compat; lra). lra.
Qed.

(* ---- Corollary 1: a potential with a unique minimum at 1 whose derivative vanishes at 2 as well ---- *)
Definition VB (s : R) : R := s ^ 3 / 3 - 9 / 4 * s ^ 2 + 11 / 2 * s + 2 / s - 67 / 12.
Definition VB' (s : R) : R := (s - 1) * (s - 2) ^ 2 * (s + 1 / 2) / s ^ 2.
Lemma VB_factor s : 0 < s -> VB s = (s - 1) ^ 2 * (4 * s ^ 2 - 19 * s + 24) / (12 * s).
Proof. intros Hs. unfold VB. field. lra. Qed.
Lemma VB_pos s : 0 < s -> 0 <= VB s /\ (s <> 1 -> 0 < VB s).
Proof.
  intros Hs. rewrite VB_factor by assumption. assert (Q : 0 < 4 * s ^ 2 - 19 * s + 24) by (pose proof (pow2_ge_0 (2 * s - 19 / 4)); nra).
  assert (I : 0 < / (12 * s)) by (apply Rinv_0_lt_compat; lra). pose proof (pow2_ge_0 (s - 1)). unfold Rdiv. split.
  - apply Rmult_le_pos; [apply Rmult_le_pos; lra|lra].
  - intros N. assert (0 < (s - 1) ^ 2) by (apply pow2_gt_0; lra). apply Rmult_lt_0_compat; [apply Rmult_lt_0_compat; lra|lra].
Qed.
Lemma VB_potential : potential VB VB'.
Proof.
  apply (potential_of_bounds VB VB' 7); intros s Hs.
  - split; [|now apply VB_pos]. unfold VB, VB'. auto_derive; [lra|]. field. lra.
  - assert (I : 0 < / s) by now apply Rinv_0_lt_compat. unfold VB, Rdiv. pose proof (pow2_ge_0 (s - 27 / 8)).
    assert (P : 0 <= s * (s ^ 2 / 3 - 9 / 4 * s + 9 / 2)) by (apply Rmult_le_pos; [lra|nra]). split; nra.
Qed.
Theorem cor1_step_fails : ~ forall V V' rd, potential V V' -> (forall s, 0 < s -> s <> rd -> V rd < V s) -> forall s, 0 < s -> V' s = 0 -> s = rd.
Proof.
  intros H. assert (E : 2 = 1); [|lra]. apply (H VB VB' 1 VB_potential).
  - intros s Hs N. assert (Z : VB 1 = 0) by (unfold VB; field). rewrite Z. now apply VB_pos.
  - lra.
  - unfold VB'. field.
Qed.
(* two linked agents at rest at the distance 2 stay there for ever, although V has its unique minimum at 1 *)
Definition pair2 (i : nat) : C := match i with 0%nat => RtoC 0 | _ => RtoC 2 end.
Theorem cor1_stuck : solution 2 complete (fun _ _ => VB) (fun _ _ => VB') (fun i _ => pair2 i) (fun _ _ => RtoC 0) /\
  (forall s, 0 < s -> s <> 1 -> VB 1 < VB s) /\ norm (pair2 0 - pair2 1)%C = 2.
Proof.
  assert (N : norm (pair2 0 - pair2 1)%C = 2 /\ norm (pair2 1 - pair2 0)%C = 2).
  { unfold pair2. rewrite !RtoC_minus', !norm_real. split; unfold Rabs; destruct (Rcase_abs _); lra. }
  assert (B : forall i, (i < 2)%nat -> grad_i 2 complete (fun _ _ => VB') pair2 i = RtoC 0).
  { intros i Hi. assert (V2 : VB' 2 = 0) by (unfold VB'; field). unfold grad_i, Csum. cbn [Sum]. destruct N as [N0 N1].
    destruct i as [|[|]]; try lia; rewrite self_grad; unfold pair_grad, grad; rewrite ?N0, ?N1, V2; unfold w, complete; apply injective_projections; cbn; field. }
  split; [|split; [|apply N]].
  - split; [lia|]. split; [apply complete_undirected|]. split; [apply complete_no_loops|]. split; [apply complete_connected|].
    split; [reflexivity|]. split; [reflexivity|]. split; [intros; apply VB_potential|]. split.
    { intros i j s _ _ _ Hs. apply continuity_pt_filterlim, (ex_derive_continuous VB'). unfold VB'. auto_derive.
      assert (0 < s ^ 2) by (apply pow_lt; lra). simpl in *. lra. }
    split. { intros t i j _ Hi Hj A. destruct i as [|[|]], j as [|[|]]; try lia; try discriminate A; intros E; injection E; lra. }
    split; [intros t i _ _; apply rest_velocity|].
    intros t i _ Hi. eapply velocity_eq; [apply rest_velocity|]. symmetry. apply rest_control. now apply B.
  - intros s Hs N1. assert (Z : VB 1 = 0) by (unfold VB; field). rewrite Z. now apply VB_pos.
Qed.
