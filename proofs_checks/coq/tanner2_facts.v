(* Tanner, Jadbabaie, Pappas, switching paper: the bound on the speeds, the sentence "r_ij = 0", the projection in
   Corollary 2, the second eigenvalue, the arctan of eq (2), the saturated energy Q of eq (11) and its rate. *)
From Coq Require Import Reals Lra Lia Psatz Relations.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums paley_model paley_phase paley_laplacian paley_gradient paley_particles tanner_energy tanner_flock tanner_nonsmooth tanner1_examples tanner2_examples.
Open Scope R_scope.

(* W <= c does not give |v_i| <= sqrt c: a lone agent of speed 1 has W = 1/2 (any potential, N = 1), and with the
   speeds 1 and 0 at the distance where V_B = 0 two linked agents have W = 1/2 as well *)
Definition pair1 (i : nat) : C := match i with 0%nat => RtoC 0 | _ => RtoC 1 end.
Theorem bound_v_fails : ~ forall n adj V V' r v c, undirected adj -> no_loops adj -> strongly_connected n adj -> (forall i j, V i j = V j i) ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> potential (V i j) (V' i j)) ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> r i <> r j) -> Wenergy n adj V r v <= c ->
  forall i, (i < n)%nat -> norm (v i) <= sqrt c.
Proof.
  intros H. pose (v := fun i : nat => match i with 0%nat => RtoC 1 | _ => RtoC 0 end).
  assert (N : norm (pair1 0 - pair1 1)%C = 1 /\ norm (pair1 1 - pair1 0)%C = 1).
  { unfold pair1. rewrite !RtoC_minus', !norm_real. split; unfold Rabs; destruct (Rcase_abs _); lra. }
  assert (Wv : Wenergy 2 complete (fun _ _ => VB) pair1 v <= 1 / 2).
  { unfold Wenergy, V_i. cbn [Sum]. destruct N as [N0 N1]. rewrite N0, N1. assert (Z : VB 1 = 0) by (unfold VB; field). rewrite Z.
    unfold w, complete. cbn [Nat.eqb negb]. rewrite !inner_xy. unfold v. cbn. lra. }
  assert (X : norm (v 0%nat) <= sqrt (1 / 2)).
  { apply (H 2%nat complete (fun _ _ => VB) (fun _ _ => VB') pair1 v (1 / 2)); try lia; try assumption.
    - apply complete_undirected.
    - apply complete_no_loops.
    - apply complete_connected.
    - reflexivity.
    - intros; apply VB_potential.
    - intros i j Hi Hj A. destruct i as [|[|]], j as [|[|]]; try lia; try discriminate A; intros E; injection E; lra. }
  unfold v in X. rewrite norm_real, Rabs_R1 in X. pose proof (sqrt_lt_1 (1 / 2) 1) as L. rewrite sqrt_1 in L. specialize (L ltac:(lra) ltac:(lra) ltac:(lra)). lra.
Qed.

(* |r_ij| <= V^-1(c (N-1)) fails for a potential that grows faster than s^2: path of three agents at -2, 0, 2 *)
Definition V4 (s : R) : R := (s ^ 2 - / s ^ 2) ^ 2.
Definition V4' (s : R) : R := 2 * (s ^ 2 - / s ^ 2) * (2 * s + 2 / s ^ 3).
Lemma V4_potential : potential V4 V4'.
Proof.
  apply (potential_of_bounds V4 V4' 8); intros s Hs; assert (P2 : 0 < s ^ 2) by (apply pow_lt; lra).
  - split; [|apply pow2_ge_0]. unfold V4, V4'. auto_derive; [apply Rgt_not_eq; simpl in *; lra|field; lra].
  - assert (I1 : 0 < / s) by now apply Rinv_0_lt_compat. assert (E : V4 s = s ^ 4 - 2 + (/ s) ^ 4) by (unfold V4; field; lra). rewrite E.
    assert (A : forall x, 0 < x -> x - 6 <= x ^ 4) by (intros x Hx; pose proof (pow2_ge_0 (x ^ 2 - 1)); pose proof (pow2_ge_0 (x - 1)); lra).
    pose proof (A s Hs). pose proof (A (/ s) I1). pose proof (pow2_ge_0 (s ^ 2)). pose proof (pow2_ge_0 ((/ s) ^ 2)). split; lra.
Qed.
Definition spread (i : nat) : C := match i with 0%nat => RtoC (-2) | 1%nat => RtoC 0 | _ => RtoC 2 end.
Lemma path3_facts : undirected path3 /\ no_loops path3 /\ strongly_connected 3 path3.
Proof.
  split; [|split].
  - intros a b. unfold path3. destruct (Nat.eqb a 1), (Nat.eqb b 1); reflexivity.
  - intros a. unfold path3. destruct (Nat.eqb a 1); reflexivity.
  - assert (A : forall k, (k < 3)%nat -> clos_refl_trans nat (arc 3 path3) k 1%nat /\ clos_refl_trans nat (arc 3 path3) 1%nat k).
    { intros k Hk. destruct k as [|[|[|]]]; try lia; split; first [apply rt_refl|apply rt_step; repeat split; lia]. }
    intros a b Ha Hb. eapply rt_trans; [apply (A a Ha)|apply (A b Hb)].
Qed.
Theorem bound_r_fails : ~ forall n adj V V' r v c, undirected adj -> no_loops adj -> strongly_connected n adj ->
  potential V V' -> (forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> r i <> r j) -> Wenergy n adj (fun _ _ => V) r v <= c ->
  forall i j b, (i < n)%nat -> (j < n)%nat -> (forall s, 0 < s -> V s <= c * (INR n - 1) -> s <= b) -> norm (r i - r j)%C <= b.
Proof.
  intros H. destruct path3_facts as [US [NL SC]].
  assert (V2 : V4 2 = 225 / 16) by (unfold V4; field).
  assert (N : norm (spread 0 - spread 1)%C = 2 /\ norm (spread 1 - spread 0)%C = 2 /\ norm (spread 1 - spread 2)%C = 2 /\ norm (spread 2 - spread 1)%C = 2 /\ norm (spread 0 - spread 2)%C = 4).
  { unfold spread. rewrite !RtoC_minus', !norm_real. repeat split; unfold Rabs; destruct (Rcase_abs _); lra. }
  destruct N as [A [B [C0 [D E]]]].
  assert (Wv : Wenergy 3 path3 (fun _ _ => V4) spread (fun _ => RtoC 0) <= 225 / 8).
  { unfold Wenergy, V_i. cbn [Sum]. rewrite A, B, C0, D, V2. unfold w, path3. cbn [Nat.eqb negb andb orb]. rewrite !Rmult_0_l, !inner_xy. cbn. lra. }
  pose proof (H 3%nat path3 V4 V4' spread (fun _ => RtoC 0) (225 / 8) US NL SC V4_potential) as P.
  assert (X : norm (spread 0 - spread 2)%C <= 3); [|lra].
  apply P; try lia; try assumption.
  - intros a b Ha Hb Ab. destruct a as [|[|[|]]], b as [|[|[|]]]; try lia; try discriminate Ab; intros Q; injection Q; lra.
  - intros s Hs L. cbn [INR] in L. apply Rnot_lt_le. intros G. assert (E4 : V4 s = s ^ 4 - 2 + (/ s) ^ 4) by (unfold V4; field; lra). rewrite E4 in L.
    assert (0 <= (/ s) ^ 4) by (apply pow_le; left; now apply Rinv_0_lt_compat). assert (9 < s ^ 2) by nra. assert (81 < s ^ 4) by nra. lra.
Qed.

(* equal velocities do not give r_ij = 0 *)
Theorem S_config_fails : ~ forall n adj (r v : nat -> C), undirected adj -> strongly_connected n adj ->
  qform (2 * n) (kron2 (lap n adj)) (stack v) = 0 -> forall i j, (i < n)%nat -> (j < n)%nat -> (r i - r j)%C = RtoC 0.
Proof.
  intros H. assert (E : (pair1 0 - pair1 1)%C = RtoC 0).
  { apply (H 2%nat complete pair1 (fun _ => RtoC 0)); try lia; [apply complete_undirected|apply complete_connected|].
    rewrite kron_split. unfold qform. rewrite !Sum_zero; [ring|intros; cbn; ring..]. }
  unfold pair1 in E. injection E. lra.
Qed.
Theorem S_config_corrected n adj v : (1 <= n)%nat -> undirected adj -> strongly_connected n adj ->
  (qform (2 * n) (kron2 (lap n adj)) (stack v) = 0 <-> forall i j, (i < n)%nat -> (j < n)%nat -> v i = v j).
Proof.
  intros Hn S SC. rewrite kron_split, <- form_split, lap_form by assumption. split; intros H.
  - intros i j Hi Hj. apply (equal_along n adj v); [apply total_0; lra|now apply SC].
  - rewrite (proj2 (total_0 n adj v)); [ring|]. intros j k [Hj [Hk _]]. now apply H.
Qed.

(* ---- Corollary 2 ---- *)
Definition mean (n : nat) (x : nat -> R) : R := / INR n * Sum n x.
Lemma qform_edges n adj x : undirected adj -> qform n (lap n adj) x = / 2 * Sum n (fun k => Sum n (fun j => w adj k j * (x k - x j) ^ 2)).
Proof.
  intros S. pose proof (lap_form n adj (fun k => RtoC (x k)) S) as E. rewrite form_split in E. unfold total in E.
  replace (qform n (lap n adj) (fun i => snd (RtoC (x i)))) with 0 in E.
  - rewrite Rplus_0_r in E. transitivity (qform n (lap n adj) (fun i => fst (RtoC (x i)))); [reflexivity|]. rewrite E. f_equal.
    apply Sum_ext; intros k _; apply Sum_ext; intros j _. rewrite dist2_xy. cbn. ring.
  - unfold qform. symmetry. apply Sum_zero; intros k _. cbn. ring.
Qed.
Theorem cor2_decomposition n adj x c : undirected adj -> qform n (lap n adj) x = qform n (lap n adj) (fun i => x i - c).
Proof. intros S. rewrite !qform_edges by assumption. f_equal. apply Sum_ext; intros k _; apply Sum_ext; intros j _. ring. Qed.
(* tanner2.cor2_decomp: any splitting of the velocities of each axis into a multiple of 1 and a part normal to 1 *)
Theorem cor2_decomp n adj V V' r v t (xp xn yp yn : nat -> R) : undirected adj -> (forall i j, V' i j = V' j i) ->
  (forall i, (i < n)%nat -> is_velocity (r i) t (v i t)) ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> r i t <> r j t) ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true ->
     is_derive (V i j) (norm (r i t - r j t)%C) (V' i j (norm (r i t - r j t)%C))) ->
  (forall i, (i < n)%nat -> is_velocity (v i) t (control4 n adj V' (fun i => r i t) (fun i => v i t) i)) ->
  (forall i, (i < n)%nat -> fst (v i t) = xp i + xn i /\ snd (v i t) = yp i + yn i) ->
  (exists c, forall i, (i < n)%nat -> xp i = c) -> (exists c, forall i, (i < n)%nat -> yp i = c) ->
  Sum n xn = 0 -> Sum n yn = 0 ->
  is_derive (fun s => Wenergy n adj V (fun i => r i s) (fun i => v i s)) t
    (- qform n (lap n adj) xn - qform n (lap n adj) yn).
Proof.
  intros S VS HR HN HV HU Split [c Cx] [e Cy] _ _.
  destruct (eq9 n adj V V' r v t S VS HR HN HV HU) as [D [K _]].
  replace (- qform n (lap n adj) xn - qform n (lap n adj) yn) with (- qform (2 * n) (kron2 (lap n adj)) (stack (fun i => v i t))); [exact D|].
  rewrite K, (cor2_decomposition n adj (fun i => fst (v i t)) c S), (cor2_decomposition n adj (fun i => snd (v i t)) e S).
  assert (E : forall x y, (forall i, (i < n)%nat -> x i = y i) -> qform n (lap n adj) x = qform n (lap n adj) y).
  { intros x y H. unfold qform. apply Sum_ext; intros i Hi. rewrite (H i Hi). f_equal. apply Sum_ext; intros j Hj. now rewrite (H j Hj). }
  rewrite (E _ xn), (E (fun i => snd (v i t) - e) yn); [ring|..]; intros i Hi; destruct (Split i Hi) as [X Y].
  - rewrite Y, (Cy i Hi). ring.
  - rewrite X, (Cx i Hi). ring.
Qed.
(* lam is a lower bound of the form on the vectors orthogonal to 1: by Courant and Fischer, lam <= lambda_2 *)
Definition below_second (n : nat) (adj : graph) (lam : R) := forall x, Sum n x = 0 -> lam * Sum n (fun i => x i ^ 2) <= qform n (lap n adj) x.
Lemma centred_sum n x : (1 <= n)%nat -> Sum n (fun i => x i - mean n x) = 0.
Proof. intros Hn. pose proof (INR_pos n Hn). rewrite Sum_minus, Sum_const. unfold mean. field. lra. Qed.
Theorem cor2_corrected n adj lam v : (1 <= n)%nat -> undirected adj -> below_second n adj lam ->
  - qform (2 * n) (kron2 (lap n adj)) (stack v) <=
  - lam * (Sum n (fun i => (fst (v i) - mean n (fun j => fst (v j))) ^ 2) + Sum n (fun i => (snd (v i) - mean n (fun j => snd (v j))) ^ 2)).
Proof.
  intros Hn S B. rewrite kron_split, (cor2_decomposition n adj (fun i => fst (v i)) (mean n (fun j => fst (v j))) S),
    (cor2_decomposition n adj (fun i => snd (v i)) (mean n (fun j => snd (v j))) S).
  pose proof (B _ (centred_sum n (fun j => fst (v j)) Hn)). pose proof (B _ (centred_sum n (fun j => snd (v j)) Hn)). lra.
Qed.
(* as printed, with the projection on span 1 instead: false on every graph, for every positive lam *)
Theorem cor2_sub_fails n adj lam : (1 <= n)%nat -> undirected adj -> 0 < lam ->
  ~ forall v, - qform (2 * n) (kron2 (lap n adj)) (stack v) <=
    - lam * (INR n * mean n (fun j => fst (v j)) ^ 2 + INR n * mean n (fun j => snd (v j)) ^ 2).
Proof.
  intros Hn S HL H. pose proof (INR_pos n Hn). specialize (H (fun _ => RtoC 1)). rewrite kron_split, !qform_edges in H by assumption. cbn [RtoC fst snd] in H.
  unfold mean in H. rewrite !Sum_const in H. rewrite !(Sum_zero n (fun k => Sum n _)) in H by (intros; apply Sum_zero; intros; ring).
  replace (/ INR n * (INR n * 1)) with 1 in H by (field; lra). nra.
Qed.
(* lambda_2 > 0 on a connected graph, and more edges do not lower it *)
Theorem second_positive n adj : (1 <= n)%nat -> undirected adj -> strongly_connected n adj -> exists lam, 0 < lam /\ below_second n adj lam.
Proof.
  intros Hn S SC. pose proof (INR_pos n Hn) as P. destruct (spacing_proper n adj Hn S SC) as [B [HB PB]].
  exists (/ (B * INR n + 1)). assert (P1 : 0 < B * INR n + 1) by nra. split; [now apply Rinv_0_lt_compat|]. intros x Z.
  set (q := qform n (lap n adj) x).
  assert (Qx : Q n (lap n adj) (fun k => RtoC (x k)) = / (2 * INR n) * q).
  { unfold Q. f_equal. rewrite form_split. unfold q. replace (qform n (lap n adj) (fun i => snd (RtoC (x i)))) with 0; [rewrite Rplus_0_r; reflexivity|].
    unfold qform. symmetry. apply Sum_zero; intros k _. cbn. ring. }
  assert (T : Sum n (fun k => Sum n (fun j => (x k - x j) ^ 2)) <= INR n * (INR n * (B * (/ (2 * INR n) * q)))).
  { rewrite <- Sum_const. apply Sum_le; intros k Hk. rewrite <- Sum_const. apply Sum_le; intros j Hj.
    pose proof (PB (fun k => RtoC (x k)) k j Hk Hj) as D. rewrite Qx, dist2_xy in D. cbn [RtoC fst snd] in D. lra. }
  assert (E : Sum n (fun k => Sum n (fun j => (x k - x j) ^ 2)) = 2 * INR n * Sum n (fun i => x i ^ 2)).
  { transitivity (Sum n (fun k => INR n * x k ^ 2 - 2 * x k * Sum n x + Sum n (fun j => x j ^ 2))).
    - apply Sum_ext; intros k _. rewrite <- Sum_const, <- Sum_scal, <- Sum_minus, <- Sum_plus. apply Sum_ext; intros j _. ring.
    - rewrite Z, Sum_plus, Sum_minus, Sum_scal, Sum_const, (Sum_zero n (fun i => 2 * x i * 0)) by (intros; ring). ring. }
  rewrite E in T. set (s := Sum n (fun i => x i ^ 2)) in *. assert (S0 : 0 <= s) by (apply Sum_ge0; intros; apply pow2_ge_0).
  assert (T2 : s <= B / 4 * q). { apply (Rmult_le_reg_l (2 * INR n)); [lra|]. apply Rle_trans with (1 := T). right. field. lra. }
  assert (Q0 : 0 <= q). { unfold q. rewrite qform_edges by assumption. apply Rmult_le_pos; [lra|]. apply Sum_ge0; intros; apply Sum_ge0; intros.
    apply Rmult_le_pos; [apply w_ge0|apply pow2_ge_0]. }
  apply (Rmult_le_reg_l (B * INR n + 1)); [lra|]. rewrite <- Rmult_assoc, Rinv_r, Rmult_1_l by lra. apply (le_INR 1) in Hn. cbn in Hn. nra.
Qed.
Theorem more_edges n adj adj' : undirected adj -> undirected adj' -> (forall i j, adj i j = true -> adj' i j = true) ->
  (forall x, qform n (lap n adj) x <= qform n (lap n adj') x) /\ (forall lam, below_second n adj lam -> below_second n adj' lam).
Proof.
  intros S S' I. assert (A : forall x, qform n (lap n adj) x <= qform n (lap n adj') x).
  { intros x. rewrite !qform_edges by assumption. apply Rmult_le_compat_l; [lra|]. apply Sum_le; intros i _; apply Sum_le; intros j _.
    apply Rmult_le_compat_r; [apply pow2_ge_0|]. specialize (I i j). unfold w. destruct (adj i j), (adj' i j); try lra; discriminate (I eq_refl). }
  split; [exact A|]. intros lam B x Z. apply Rle_trans with (1 := B x Z). apply A.
Qed.

(* tanner2.cor2_rate: without potentials, v' = - L v; along one axis first *)
Section Alignment.
Variables (n : nat) (adj : graph) (lam : R).
Hypothesis Hn : (1 <= n)%nat.
Hypothesis S : undirected adj.
Definition aligns (u : nat -> R -> R) := forall t i, 0 <= t -> (i < n)%nat -> is_derive (u i) t (- Sum n (fun j => w adj i j * (u i t - u j t))).
Lemma lap_apply x i : (i < n)%nat -> Sum n (fun j => lap n adj i j * x j) = Sum n (fun j => w adj i j * (x i - x j)).
Proof.
  intros Hi. unfold lap. transitivity (Sum n (fun j => delta i j * (deg n adj i * x j)) - Sum n (fun j => w adj i j * x j)).
  - rewrite <- Sum_minus. apply Sum_ext; intros; ring.
  - rewrite (Sum_delta_l n i (fun j => deg n adj i * x j) Hi). unfold deg. rewrite <- Sum_scal_r, <- Sum_minus. apply Sum_ext; intros; ring.
Qed.
Lemma squares_rate u c : aligns u -> forall t, 0 <= t ->
  is_derive (fun s => Sum n (fun i => (u i s - c) ^ 2)) t (- 2 * qform n (lap n adj) (fun i => u i t - c)).
Proof.
  intros A t Ht. eapply D_eq.
  - apply (D_Sum n (fun i s => (u i s - c) ^ 2) (fun i => 2 * (u i t - c) * (- Sum n (fun j => w adj i j * (u i t - u j t))))). intros i Hi.
    eapply D_eq; [apply D_sqr, D_minus; [apply A; assumption|apply D_const]|]. cbv beta. ring.
  - unfold qform. rewrite <- Sum_scal. apply Sum_ext; intros i Hi. rewrite (lap_apply (fun i => u i t - c) i Hi).
    rewrite (Sum_ext n (fun j => w adj i j * (u i t - c - (u j t - c))) (fun j => w adj i j * (u i t - u j t))) by (intros; ring). ring.
Qed.
Lemma mean_kept u : aligns u -> forall t, 0 <= t -> mean n (fun i => u i t) = mean n (fun i => u i 0).
Proof.
  intros A t Ht. assert (Z : forall s, 0 <= s -> is_derive (fun s => Sum n (fun i => u i s)) s 0).
  { intros s Hs. eapply D_eq; [apply (D_Sum n u (fun i => - Sum n (fun j => w adj i j * (u i s - u j s)))); intros i Hi; now apply A|].
    rewrite Sum_opp, (Sum_antisym n (fun i j => w adj i j * (u i s - u j s))); [ring|]. intros i j _ _. unfold w. rewrite (S j i). ring. }
  unfold mean. f_equal. destruct (Req_dec t 0) as [->|N]; [reflexivity|]. symmetry.
  apply (eq_is_derive (fun s => Sum n (fun i => u i s)) 0 t); [|lra]. intros s Hs. apply Z. lra.
Qed.
Lemma axis_rate u : below_second n adj lam -> aligns u -> forall t, 0 <= t ->
  Sum n (fun i => (u i t - mean n (fun j => u j t)) ^ 2) <= exp (- (2 * lam) * t) * Sum n (fun i => (u i 0 - mean n (fun j => u j 0)) ^ 2).
Proof.
  intros B A t Ht. rewrite (mean_kept u A t Ht). set (c := mean n (fun j => u j 0)).
  rewrite Rmult_comm. apply (gronwall (fun s => Sum n (fun i => (u i s - c) ^ 2)) (fun s => - 2 * qform n (lap n adj) (fun i => u i s - c)) (2 * lam)); [|  |exact Ht].
  - intros s Hs. now apply squares_rate.
  - intros s Hs. assert (Z : Sum n (fun i => u i s - c) = 0).
    { unfold c. rewrite <- (mean_kept u A s Hs). apply centred_sum. exact Hn. }
    pose proof (B (fun i => u i s - c) Z). cbv beta in *. lra.
Qed.
(* from an eigenvector the motion stays on it *)
Lemma axis_eigenvector u : aligns u -> (forall i, (i < n)%nat -> Sum n (fun j => lap n adj i j * u j 0) = lam * u i 0) ->
  forall t i, 0 <= t -> (i < n)%nat -> u i t = exp (- lam * t) * u i 0.
Proof.
  intros A Ei t i Ht Hi. set (q := fun k s => u k s - exp (- lam * s) * u k 0).
  assert (De : forall s, is_derive (fun x => exp (- lam * x)) s (exp (- lam * s) * - lam)).
  { intros s. apply (D_comp exp (fun x => - lam * x) s); [apply is_derive_exp|]. eapply D_eq; [apply D_scal, D_id|]. ring. }
  assert (Q : aligns q).
  { intros s k Hs Hk. eapply D_eq; [apply D_minus; [apply A; assumption|apply (D_mult (fun x => exp (- lam * x)) (fun _ => u k 0)); [apply De|apply D_const]]|].
    cbv beta. unfold q. specialize (Ei k Hk). rewrite (lap_apply (fun j => u j 0) k Hk) in Ei.
    rewrite (Sum_ext n (fun j => w adj k j * (u k s - exp (- lam * s) * u k 0 - (u j s - exp (- lam * s) * u j 0)))
      (fun j => w adj k j * (u k s - u j s) - exp (- lam * s) * (w adj k j * (u k 0 - u j 0)))) by (intros; ring).
    rewrite Sum_minus, Sum_scal, Ei. ring. }
  assert (Z0 : Sum n (fun k => (q k 0 - 0) ^ 2) = 0).
  { apply Sum_zero; intros k _. unfold q. rewrite Rmult_0_r, exp_0. ring. }
  assert (Zt : Sum n (fun k => (q k t - 0) ^ 2) <= Sum n (fun k => (q k 0 - 0) ^ 2)).
  { apply (decreasing (fun s => Sum n (fun k => (q k s - 0) ^ 2)) (fun s => - 2 * qform n (lap n adj) (fun k => q k s - 0)) 0 t Ht).
    - intros s Hs. apply squares_rate; [exact Q|lra].
    - intros s Hs. rewrite qform_edges by assumption. assert (0 <= Sum n (fun k => Sum n (fun j => w adj k j * (q k s - 0 - (q j s - 0)) ^ 2))); [|lra].
      apply Sum_ge0; intros; apply Sum_ge0; intros. apply Rmult_le_pos; [apply w_ge0|apply pow2_ge_0]. }
  rewrite Z0 in Zt. pose proof (Sum_term_le n (fun k => (q k t - 0) ^ 2) i (fun k _ => pow2_ge_0 _) Hi) as L. cbv beta in L.
  assert (E : q i t = 0) by nra. unfold q in E. lra.
Qed.
End Alignment.
(* the distance of all velocities from their mean *)
Definition deviation (n : nat) (v : nat -> C) : R := sqrt (Sum n (fun i => norm (v i - centre n v)%C ^ 2)).
Lemma deviation_axes n v : Sum n (fun i => norm (v i - centre n v)%C ^ 2) =
  Sum n (fun i => (fst (v i) - mean n (fun j => fst (v j))) ^ 2) + Sum n (fun i => (snd (v i) - mean n (fun j => snd (v j))) ^ 2).
Proof.
  rewrite <- Sum_plus. apply Sum_ext; intros i _. replace (norm (v i - centre n v)%C ^ 2) with (norm (v i - centre n v)%C * norm (v i - centre n v)%C) by ring.
  rewrite norm_sqr, inner_xy, centre_xy. unfold mean. cbn. ring.
Qed.
(* lam is at most lambda_2; with lam = lambda_2 both parts are what Corollary 2 means to say *)
Theorem alignment_rate n adj lam (v : nat -> R -> C) : (1 <= n)%nat -> undirected adj ->
  (forall t i, 0 <= t -> (i < n)%nat -> is_velocity (v i) t (- Csum n (fun j => RtoC (w adj i j) * (v i t - v j t)))%C) ->
  (below_second n adj lam -> forall t, 0 <= t -> deviation n (fun i => v i t) <= exp (- lam * t) * deviation n (fun i => v i 0)) /\
  ((forall i, (i < n)%nat -> Csum n (fun j => RtoC (lap n adj i j) * v j 0%R)%C = (RtoC lam * v i 0%R)%C) ->
   forall t, 0 <= t -> deviation n (fun i => v i t) = exp (- lam * t) * deviation n (fun i => v i 0)).
Proof.
  intros Hn S M. set (X := fun i s => fst (v i s)). set (Y := fun i s => snd (v i s)).
  assert (AX : aligns n adj X).
  { intros t i Ht Hi. eapply D_eq; [apply (M t i Ht Hi)|]. cbn. f_equal. apply Sum_ext; intros j _. unfold X. ring. }
  assert (AY : aligns n adj Y).
  { intros t i Ht Hi. eapply D_eq; [apply (M t i Ht Hi)|]. cbn. f_equal. apply Sum_ext; intros j _. unfold Y. ring. }
  assert (E2 : forall t, exp (- (2 * lam) * t) = exp (- lam * t) * exp (- lam * t)) by (intros t; rewrite <- exp_plus; f_equal; ring).
  split.
  - intros B t Ht. unfold deviation. rewrite <- (sqrt_square (exp (- lam * t))) by (left; apply exp_pos).
    rewrite <- sqrt_mult_alt by (left; apply Rmult_lt_0_compat; apply exp_pos). apply sqrt_le_1_alt. rewrite !deviation_axes, <- E2, Rmult_plus_distr_l.
    apply Rplus_le_compat; [exact (axis_rate n adj lam Hn S X B AX t Ht)|exact (axis_rate n adj lam Hn S Y B AY t Ht)].
  - intros Ei t Ht.
    assert (EX : forall i, (i < n)%nat -> Sum n (fun j => lap n adj i j * X j 0) = lam * X i 0).
    { intros i Hi. pose proof (f_equal fst (Ei i Hi)) as F. cbn in F. unfold X. rewrite (Sum_ext n _ (fun j => lap n adj i j * fst (v j 0) - 0 * snd (v j 0))) by (intros; ring). lra. }
    assert (EY : forall i, (i < n)%nat -> Sum n (fun j => lap n adj i j * Y j 0) = lam * Y i 0).
    { intros i Hi. pose proof (f_equal snd (Ei i Hi)) as F. cbn in F. unfold Y. rewrite (Sum_ext n _ (fun j => lap n adj i j * snd (v j 0) + 0 * fst (v j 0))) by (intros; ring). lra. }
    pose proof (axis_eigenvector n adj lam S X AX EX) as FX. pose proof (axis_eigenvector n adj lam S Y AY EY) as FY.
    unfold deviation. rewrite <- (sqrt_square (exp (- lam * t))) by (left; apply exp_pos).
    rewrite <- sqrt_mult_alt by (left; apply Rmult_lt_0_compat; apply exp_pos). f_equal. rewrite !deviation_axes, Rmult_plus_distr_l.
    assert (G : forall u : nat -> R -> R, (forall t i, 0 <= t -> (i < n)%nat -> u i t = exp (- lam * t) * u i 0) ->
      Sum n (fun i => (u i t - mean n (fun j => u j t)) ^ 2) = exp (- lam * t) * exp (- lam * t) * Sum n (fun i => (u i 0 - mean n (fun j => u j 0)) ^ 2)).
    { intros u F. assert (Mn : mean n (fun j => u j t) = exp (- lam * t) * mean n (fun j => u j 0)).
      { unfold mean. rewrite (Sum_ext n (fun j => u j t) (fun j => exp (- lam * t) * u j 0)) by (intros; now apply F). rewrite Sum_scal. ring. }
      rewrite Mn, <- Sum_scal. apply Sum_ext; intros i Hi. rewrite (F t i Ht Hi). ring. }
    f_equal; [exact (G X FX)|exact (G Y FY)].
Qed.

(* ---- eq (2): arctan of the quotient loses the quadrant ---- *)
Theorem eq2_fails : ~ forall v : C, fst v <> 0 -> v = (RtoC (norm v) * expi (atan (snd v / fst v)))%C.
Proof.
  intros H. specialize (H (RtoC (-1))). cbn [RtoC fst snd] in H. replace (0 / -1) with 0 in H by field. rewrite atan_0, expi_0, Cmult_1_r in H.
  rewrite norm_real in H. assert (E : RtoC (-1) = RtoC (Rabs (-1))) by (apply H; lra). injection E as E. rewrite Rabs_m1 in E. lra.
Qed.

(* ---- eq (11): the saturated energy, and its rate where no pair is at the threshold ---- *)
Definition near (r : nat -> C) (R0 : R) (i j : nat) : bool :=
  if Nat.eqb i j then false else if Rlt_dec (norm (r i - r j)%C) R0 then true else false.
Definition sat_pair (V : nat -> nat -> R -> R) (R0 : R) (r : nat -> C) (i j : nat) : R :=
  if Nat.eqb i j then 0 else saturated (V i j) R0 (norm (r i - r j)%C).
Definition Qsat (n : nat) (V : nat -> nat -> R -> R) (R0 : R) (r v : nat -> C) : R :=
  / 2 * Sum n (fun i => Sum n (fun j => sat_pair V R0 r i j) + inner (v i) (v i)).
Lemma near_undirected r R0 : undirected (near r R0).
Proof. intros i j. unfold near. rewrite (Nat.eqb_sym j i), (norm_sym (r j)). reflexivity. Qed.
(* the first form of Q: linked pairs, and V_ij(R) once for each unordered pair that is not linked *)
Theorem Q_two_forms n V R0 r v : (forall i j, V i j = V j i) ->
  Wenergy n (near r R0) V r v + Sum n (fun i => Sum i (fun j => (1 - w (near r R0) i j) * V i j R0)) = Qsat n V R0 r v.
Proof.
  intros VS. unfold Wenergy, Qsat, V_i.
  assert (T : Sum n (fun i => Sum n (fun j => sat_pair V R0 r i j)) =
    Sum n (fun i => Sum n (fun j => w (near r R0) i j * V i j (norm (r i - r j)%C))) + 2 * Sum n (fun i => Sum i (fun j => (1 - w (near r R0) i j) * V i j R0))).
  { assert (P : forall i j, i <> j -> sat_pair V R0 r i j = w (near r R0) i j * V i j (norm (r i - r j)%C) + (1 - w (near r R0) i j) * V i j R0).
    { intros i j N. unfold sat_pair, w, near, saturated. destruct (Nat.eqb_spec i j); [contradiction|]. destruct (Rlt_dec _ R0); ring. }
    assert (Sy : forall i j, (1 - w (near r R0) i j) * V i j R0 = (1 - w (near r R0) j i) * V j i R0).
    { intros i j. unfold w. now rewrite (near_undirected r R0 i j), VS. }
    induction n as [|m IH]; [cbn; ring|]. cbn [Sum]. rewrite !Sum_plus, IH.
    rewrite (Sum_ext m (fun i => sat_pair V R0 r i m) (fun i => w (near r R0) i m * V i m (norm (r i - r m)%C) + (1 - w (near r R0) m i) * V m i R0))
      by (intros i Hi; rewrite P by lia; now rewrite (Sy i m)).
    rewrite (Sum_ext m (fun j => sat_pair V R0 r m j) (fun j => w (near r R0) m j * V m j (norm (r m - r j)%C) + (1 - w (near r R0) m j) * V m j R0)) by (intros j Hj; apply P; lia).
    rewrite !Sum_plus. assert (D0 : sat_pair V R0 r m m = 0) by (unfold sat_pair; now rewrite Nat.eqb_refl).
    assert (D1 : w (near r R0) m m = 0) by (unfold w, near; now rewrite Nat.eqb_refl). rewrite D0, D1. ring. }
  rewrite !Sum_plus, T. field.
Qed.
Theorem Q_rate n (V V' : nat -> nat -> R -> R) R0 (r v : nat -> R -> C) t : 0 < R0 -> (forall i j, V' i j = V' j i) ->
  (forall i j s, 0 < s -> is_derive (V i j) s (V' i j s)) ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> i <> j -> r i t <> r j t /\ norm (r i t - r j t)%C <> R0) ->
  (forall i, (i < n)%nat -> is_velocity (r i) t (v i t)) ->
  (forall i, (i < n)%nat -> is_velocity (v i) t (control4 n (near (fun i => r i t) R0) V' (fun i => r i t) (fun i => v i t) i)) ->
  is_derive (fun s => Qsat n V R0 (fun i => r i s) (fun i => v i s)) t
    (- qform (2 * n) (kron2 (lap n (near (fun i => r i t) R0))) (stack (fun i => v i t))).
Proof.
  intros HR0 VS HV HN HR HU. set (adj := near (fun i => r i t) R0) in *.
  pose proof (near_undirected (fun i => r i t) R0) as S. fold adj in S.
  assert (F : forall i j, (i < n)%nat -> (j < n)%nat -> is_derive (fun s => sat_pair V R0 (fun i => r i s) i j) t
     (inner (pair_grad adj V' (fun i => r i t) i j) (v i t - v j t)%C)).
  { intros i j Hi Hj. unfold sat_pair, pair_grad, w, adj, near. destruct (Nat.eqb_spec i j) as [E|E].
    - eapply D_eq; [apply D_const|]. rewrite inner_xy. cbn. ring.
    - destruct (HN i j Hi Hj E) as [N1 N2]. pose proof (norm_neq _ _ N1) as P. set (d := norm (r i t - r j t)%C) in *.
      set (U' := fun s => if Rlt_dec s R0 then V' i j s else 0).
      assert (DU : is_derive (saturated (V i j) R0) d (U' d)).
      { unfold U'. destruct (Rlt_dec d R0) as [L|L].
        - apply (is_derive_ext_loc (V i j)); [|now apply HV]. exists (mkposreal (R0 - d) ltac:(lra)). intros y Hy. apply Rabs_lt_between in Hy. cbn in Hy.
          unfold minus, plus, opp in Hy; cbn in Hy. unfold saturated. destruct (Rlt_dec y R0); [reflexivity|lra].
        - apply (is_derive_ext_loc (fun _ => V i j R0)); [|apply D_const]. exists (mkposreal (d - R0) ltac:(lra)). intros y Hy. apply Rabs_lt_between in Hy. cbn in Hy.
          unfold minus, plus, opp in Hy; cbn in Hy. unfold saturated. destruct (Rlt_dec y R0); [lra|reflexivity]. }
      eapply D_eq; [apply (pair_rate (saturated (V i j) R0) U' (r i) (r j) t _ _ (HR i Hi) (HR j Hj) N1 DU)|].
      unfold grad, U'. fold d. destruct (Rlt_dec d R0); rewrite !inner_xy; unfold Cmult, RtoC; cbn [fst snd]; unfold Rdiv; ring. }
  eapply D_eq; [apply (energy_chain n (fun i j s => sat_pair V R0 (fun i => r i s) i j) (pair_grad adj V' (fun i => r i t)) v _ t F
    (fun i j _ _ => pair_grad_antisym adj V' S VS (fun i => r i t) i j) HU)|].
  pose proof (control_power n adj V' r v t) as CP. unfold grad_i in CP. rewrite kron_split, <- form_split, <- CP. reflexivity.
Qed.
(* "for any graph the right hand side of (13) is [e, 0] with e < 0": with no pair at the threshold it is one point *)
Definition allowed (n : nat) (r : nat -> C) (R0 : R) (adj : graph) := undirected adj /\ no_loops adj /\
  forall i j, (i < n)%nat -> (j < n)%nat -> i <> j ->
    (norm (r i - r j)%C < R0 -> adj i j = true) /\ (R0 < norm (r i - r j)%C -> adj i j = false).
Definition rhs13 (n : nat) (r v : nat -> C) (R0 x : R) := exists a b, allowed n r R0 a /\ allowed n r R0 b /\
  - qform (2 * n) (kron2 (lap n a)) (stack v) <= x <= - qform (2 * n) (kron2 (lap n b)) (stack v).
Theorem eq13_interval_fails : ~ forall n r v R0, exists e, e < 0 /\ forall x, rhs13 n r v R0 x <-> e <= x <= 0.
Proof.
  intros H. destruct (H 2%nat pair1 (fun _ => RtoC 0) 2) as [e [He E]]. assert (R : rhs13 2 pair1 (fun _ => RtoC 0) 2 e) by (apply E; lra).
  destruct R as [a [b [_ [_ [R1 _]]]]]. rewrite kron_split in R1. unfold qform in R1. rewrite !Sum_zero in R1; [lra|intros; cbn; ring..].
Qed.
(* ---- (13): the links of the pairs at the threshold are free, and each of them adds |v_i - v_j|^2 to the form ---- *)
Definition linked_where (f : R -> bool) (r : nat -> C) : graph := fun i j => (negb (i =? j)%nat && f (norm (r i - r j)%C))%bool.
Definition linked_below (r : nat -> C) (R0 : R) : graph := linked_where (fun s => if Rlt_dec s R0 then true else false) r.
Definition linked_upto (r : nat -> C) (R0 : R) : graph := linked_where (fun s => if Rle_dec s R0 then true else false) r.
Notation form n adj v := (qform (2 * n) (kron2 (lap n adj)) (stack v)).
Lemma form_total n adj v : undirected adj -> form n adj v = / 2 * total n adj v.
Proof. intros S. rewrite kron_split, <- form_split, lap_form by assumption. reflexivity. Qed.
Lemma total_mono n (g h : graph) v : (forall i j, (i < n)%nat -> (j < n)%nat -> g i j = true -> h i j = true) -> total n g v <= total n h v.
Proof.
  intros M. unfold total. apply Sum_le; intros i Hi. apply Sum_le; intros j Hj. pose proof (dist2_ge0 (v i) (v j)) as P. specialize (M i j Hi Hj).
  unfold w. destruct (g i j), (h i j); try lra.
Qed.
Lemma where_allowed n r R0 f : (forall s, (s < R0 -> f s = true) /\ (R0 < s -> f s = false)) -> allowed n r R0 (linked_where f r).
Proof.
  intros F. split; [|split].
  - intros i j. unfold linked_where. rewrite (Nat.eqb_sym i j), (norm_sym (r i) (r j)). reflexivity.
  - intros i. unfold linked_where. now rewrite Nat.eqb_refl.
  - intros i j _ _ N. unfold linked_where. apply Nat.eqb_neq in N. rewrite N. exact (F (norm (r i - r j)%C)).
Qed.
Lemma below_allowed n r R0 : allowed n r R0 (linked_below r R0).
Proof. apply where_allowed. intros s. split; intros L; destruct (Rlt_dec s R0); try reflexivity; lra. Qed.
Lemma upto_allowed n r R0 : allowed n r R0 (linked_upto r R0).
Proof. apply where_allowed. intros s. split; intros L; destruct (Rle_dec s R0); try reflexivity; lra. Qed.
Lemma allowed_between n r v R0 adj : allowed n r R0 adj ->
  form n (linked_below r R0) v <= form n adj v <= form n (linked_upto r R0) v.
Proof.
  intros (S & NL & A). rewrite (form_total n adj v S), (form_total n _ v (proj1 (below_allowed n r R0))), (form_total n _ v (proj1 (upto_allowed n r R0))). split; apply Rmult_le_compat_l; try lra; apply total_mono; intros i j Hi Hj L.
  - unfold linked_below, linked_where in L. destruct (Nat.eqb_spec i j) as [->|N]; [discriminate|]. cbn in L. destruct (Rlt_dec _ R0) as [Lt|]; [|discriminate]. now apply (A i j).
  - unfold linked_upto, linked_where. destruct (Nat.eqb_spec i j) as [->|N]; [rewrite NL in L; discriminate|]. cbn. destruct (Rle_dec _ R0) as [|G]; [reflexivity|].
    destruct (A i j Hi Hj N) as [_ Q]. rewrite Q in L by lra. discriminate.
Qed.
Theorem eq13_interval n r v R0 : exists e f, e <= f <= 0 /\ forall x, rhs13 n r v R0 x <-> e <= x <= f.
Proof.
  exists (- form n (linked_upto r R0) v), (- form n (linked_below r R0) v).
  assert (P : 0 <= form n (linked_below r R0) v).
  { rewrite (form_total n _ v (proj1 (below_allowed n r R0))). apply Rmult_le_pos; [lra|apply total_ge0]. }
  pose proof (allowed_between n r v R0 _ (below_allowed n r R0)) as [_ U]. split; [lra|]. intros x. split.
  - intros (a & b & Aa & Ab & H). pose proof (allowed_between n r v R0 a Aa). pose proof (allowed_between n r v R0 b Ab). lra.
  - intros H. exists (linked_upto r R0), (linked_below r R0). split; [apply upto_allowed|]. split; [apply below_allowed|exact H].
Qed.
Theorem eq13_no_tie n r v R0 adj : (forall i j, (i < n)%nat -> (j < n)%nat -> i <> j -> norm (r i - r j)%C <> R0) -> allowed n r R0 adj ->
  forall x, rhs13 n r v R0 x <-> x = - form n adj v.
Proof.
  intros NT A. pose proof (allowed_between n r v R0 adj A) as B.
  assert (E : form n (linked_upto r R0) v <= form n (linked_below r R0) v).
  { rewrite (form_total n _ v (proj1 (below_allowed n r R0))), (form_total n _ v (proj1 (upto_allowed n r R0))). apply Rmult_le_compat_l; [lra|]. apply total_mono. intros i j Hi Hj L.
    unfold linked_upto, linked_where in L. unfold linked_below, linked_where. destruct (Nat.eqb_spec i j) as [->|N]; [discriminate|]. cbn in L |- *. destruct (Rle_dec _ R0) as [Le|]; [|discriminate].
    destruct (Rlt_dec _ R0) as [|G]; [reflexivity|]. exfalso. apply (NT i j Hi Hj N). lra. }
  intros x. split.
  - intros (a & b & Aa & Ab & H). pose proof (allowed_between n r v R0 a Aa). pose proof (allowed_between n r v R0 b Ab). lra.
  - intros ->. exists adj, adj. split; [exact A|]. split; [exact A|lra].
Qed.
