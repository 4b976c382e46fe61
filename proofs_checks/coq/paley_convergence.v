(* Paley et al., Theorem 2 for every solution: under the spacing loop (20) on a connected undirected graph S decays exponentially from some time
   on, all centres of circles tend to one point, and every particle to a uniform motion on one circle about it.
   The rate of S vanishes at instants. S - (d/w0) sum g_k h_k decreases strictly: g_k and h_k are the components of (L c)_k along and across
   the heading, which turns the one into the other, and d is small. Barbalat's lemma for S makes the g_k small first.
     paley.thm2, paley.thm2.center (clauses 1, 3). *)
From Coq Require Import Reals Lra Lia Psatz Relations.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums paley_model paley_phase paley_laplacian paley_gradient paley_particles paley_centre.
Open Scope R_scope.

(* ---- functions of time ---- *)
Lemma sqr_Rabs x b : 0 <= b -> x ^ 2 <= b ^ 2 -> Rabs x <= b.
Proof. intros Hb H. apply Rabs_le. nra. Qed.
(* a rate that dies out exponentially leads to a limit *)
Lemma settles (f f' : R -> R) A m : 0 < m -> (forall t, 0 <= t -> is_derive f t (f' t)) ->
  (forall t, 0 <= t -> Rabs (f' t) <= A * exp (- m * t)) ->
  exists l, forall t, 0 <= t -> Rabs (f t - l) <= A / m * exp (- m * t).
Proof.
  intros Hm D B. set (q := A / m). assert (mq : m * q = A) by (unfold q; field; lra).
  assert (A0 : 0 <= A). { specialize (B 0 ltac:(lra)). rewrite Rmult_0_r, exp_0 in B. pose proof (Rabs_pos (f' 0)). lra. }
  assert (q0 : 0 <= q). { unfold q, Rdiv. apply Rmult_le_pos; [exact A0|left; now apply Rinv_0_lt_compat]. }
  assert (DE : forall t, is_derive (fun s => q * exp (- m * s)) t (- A * exp (- m * t))).
  { intros t. eapply D_eq; [apply D_scal, (D_comp exp (fun s => - m * s) t (exp (- m * t)) (- m)); [apply is_derive_exp|]|].
    - eapply D_eq; [apply D_scal, D_id|ring].
    - rewrite <- mq. ring. }
  assert (Up : forall s t, 0 <= s <= t -> f s - q * exp (- m * s) <= f t - q * exp (- m * t)).
  { intros s t H. apply Ropp_le_cancel.
    apply (decreasing (fun x => - (f x - q * exp (- m * x))) (fun x => - (f' x - - A * exp (- m * x)))); [lra|..].
    - intros x Hx. apply D_opp, D_minus; [apply D; lra|apply DE].
    - intros x Hx. pose proof (B x ltac:(lra)) as Bx. apply Rabs_le_between in Bx. lra. }
  assert (Down : forall s t, 0 <= s <= t -> f t + q * exp (- m * t) <= f s + q * exp (- m * s)).
  { intros s t H. apply (decreasing (fun x => f x + q * exp (- m * x)) (fun x => f' x + - A * exp (- m * x))); [lra|..].
    - intros x Hx. apply D_plus; [apply D; lra|apply DE].
    - intros x Hx. pose proof (B x ltac:(lra)) as Bx. apply Rabs_le_between in Bx. lra. }
  assert (Cross : forall s t, 0 <= s -> 0 <= t -> f s - q * exp (- m * s) <= f t + q * exp (- m * t)).
  { intros s t Hs Ht. assert (E : forall x, 0 <= q * exp (- m * x)) by (intros x; apply Rmult_le_pos; [exact q0|left; apply exp_pos]).
    destruct (Rle_or_lt s t) as [L|L].
    - pose proof (Up s t ltac:(lra)). pose proof (E t). lra.
    - pose proof (Down t s ltac:(lra)). pose proof (E s). lra. }
  destruct (completeness (fun y => exists s, 0 <= s /\ y = f s - q * exp (- m * s))) as [l [U L]].
  - exists (f 0 + q * exp (- m * 0)). intros y [s [Hs ->]]. apply Cross; lra.
  - exists (f 0 - q * exp (- m * 0)), 0. split; [lra|reflexivity].
  - exists l. intros t Ht. apply Rabs_le.
    assert (P1 : f t - q * exp (- m * t) <= l) by (apply U; exists t; split; [exact Ht|reflexivity]).
    assert (P2 : l <= f t + q * exp (- m * t)) by (apply L; intros y [s [Hs ->]]; now apply Cross).
    lra.
Qed.
Lemma exp_small m e M : 0 < m -> 0 < e -> exists T, 0 <= T /\ forall t, T <= t -> M * exp (- m * t) < e.
Proof.
  intros Hm He. exists (Rmax 0 (M / (m * e))). split; [apply Rmax_l|]. intros t Ht.
  pose proof (Rmax_l 0 (M / (m * e))). pose proof (Rmax_r 0 (M / (m * e))). assert (t0 : 0 <= t) by lra.
  replace (- m * t) with (- (m * t)) by ring. rewrite exp_Ropp.
  assert (X : 1 + m * t <= exp (m * t)).
  { destruct (Req_dec t 0) as [->|N]; [rewrite Rmult_0_r, exp_0; lra|]. left. apply exp_ineq1. nra. }
  assert (L : M <= m * e * t).
  { assert (Q1 : M / (m * e) <= t) by lra. apply (Rmult_le_compat_l (m * e)) in Q1; [|nra].
    replace (m * e * (M / (m * e))) with M in Q1 by (field; lra). exact Q1. }
  apply Rmult_lt_reg_r with (exp (m * t)); [apply exp_pos|]. rewrite Rmult_assoc, Rinv_l by (apply Rgt_not_eq, exp_pos). nra.
Qed.

(* ---- |L c|^2 and S bound each other ---- *)
Definition lap2 (n : nat) (adj : graph) (c : nat -> C) : R := Sum n (fun k => inner (row n (lap n adj) k c) (row n (lap n adj) k c)).
Lemma lap2_le n adj c : (1 <= n)%nat -> undirected adj -> lap2 n adj c <= 4 * INR n ^ 2 * Q n (lap n adj) c.
Proof.
  intros Hn S. pose proof (INR_pos n Hn). rewrite Q_total by assumption.
  replace (4 * INR n ^ 2 * (/ (4 * INR n) * total n adj c)) with (INR n * total n adj c) by (field; lra).
  unfold lap2, total. rewrite <- Sum_scal. apply Sum_le; intros k Hk. rewrite row_lap, inner_xy by assumption. unfold Csum; cbn [fst snd].
  rewrite (Sum_ext n (fun j => w adj k j * dist2 (c k) (c j))
    (fun j => (w adj k j * (fst (c k) - fst (c j))) ^ 2 + (w adj k j * (snd (c k) - snd (c j))) ^ 2)).
  - rewrite Sum_plus, Rmult_plus_distr_l.
    pose proof (Sum_sqr_le n (fun j => w adj k j * (fst (c k) - fst (c j)))) as L1.
    pose proof (Sum_sqr_le n (fun j => w adj k j * (snd (c k) - snd (c j)))) as L2.
    apply Rplus_le_compat; (eapply Rle_trans; [|first [exact L1|exact L2]]); right; rewrite <- Rsqr_pow2; unfold Rsqr; f_equal; apply Sum_ext; intros; cbn; ring.
  - intros j _. rewrite dist2_xy. unfold w. destruct (adj k j); ring.
Qed.
Lemma le_lap2 n adj : (1 <= n)%nat -> undirected adj -> strongly_connected n adj ->
  exists B, 0 < B /\ forall c, Q n (lap n adj) c <= B * lap2 n adj c.
Proof.
  intros Hn S SC. pose proof (INR_pos n Hn) as Pn. destruct (spacing_proper n adj Hn S SC) as [B [HB P]].
  exists ((B + 1) / (4 * INR n)). split; [apply Rdiv_lt_0_compat; lra|]. intros c.
  assert (Q0 : 0 <= Q n (lap n adj) c) by now apply Q_kernel.
  (* the row sums of L are 0 over the rows too, so c_k - c_0 may stand for c_k *)
  assert (Z : Sum n (fun k => inner (c 0%nat) (row n (lap n adj) k c)) = 0).
  { rewrite (Sum_ext n _ (fun k => Sum n (fun j => w adj k j * (inner (c 0%nat) (c k) - inner (c 0%nat) (c j))))).
    - apply Sum_antisym. intros i j _ _. unfold w. rewrite (S j i). ring.
    - intros k Hk. rewrite inner_row. now rewrite (lap_mul n adj k (fun j => inner (c 0%nat) (c j)) Hk). }
  assert (E : 2 * INR n * Q n (lap n adj) c = Sum n (fun k => inner (c k - c 0%nat)%C (row n (lap n adj) k c))).
  { transitivity (Sum n (fun k => inner (c k) (row n (lap n adj) k c)) - Sum n (fun k => inner (c 0%nat) (row n (lap n adj) k c))).
    - rewrite Z. unfold Q. field. lra.
    - rewrite <- Sum_minus. apply Sum_ext; intros k _. rewrite !inner_xy. cbn. ring. }
  assert (Y : Sum n (fun k => inner (c k - c 0%nat)%C (row n (lap n adj) k c)) <=
              Sum n (fun k => / (B + 1) * dist2 (c k) (c 0%nat) + (B + 1) / 4 * inner (row n (lap n adj) k c) (row n (lap n adj) k c))).
  { apply Sum_le; intros k _. set (z := row n (lap n adj) k c). unfold dist2. set (y := (c k - c 0%nat)%C). rewrite !inner_xy.
    assert (F : forall a b, a * b <= / (B + 1) * (a * a) + (B + 1) / 4 * (b * b)).
    { intros a b. apply Rmult_le_reg_l with (B + 1); [lra|].
      replace ((B + 1) * (/ (B + 1) * (a * a) + (B + 1) / 4 * (b * b))) with (a * a + ((B + 1) / 2 * b) ^ 2) by (field; lra).
      pose proof (pow2_ge_0 (a - (B + 1) / 2 * b)). lra. }
    pose proof (F (fst y) (fst z)). pose proof (F (snd y) (snd z)). lra. }
  rewrite Sum_plus, !Sum_scal, <- E in Y. fold (lap2 n adj c) in Y.
  assert (X : / (B + 1) * Sum n (fun k => dist2 (c k) (c 0%nat)) <= INR n * Q n (lap n adj) c).
  { apply Rmult_le_reg_l with (B + 1); [lra|]. rewrite <- Rmult_assoc, Rinv_r, Rmult_1_l by lra.
    apply Rle_trans with (INR n * (B * Q n (lap n adj) c)).
    - rewrite <- Sum_const. apply Sum_le; intros k Hk. apply P; lia.
    - nra. }
  apply Rmult_le_reg_l with (INR n); [lra|]. replace (INR n * ((B + 1) / (4 * INR n) * lap2 n adj c)) with ((B + 1) / 4 * lap2 n adj c) by (field; lra).
  lra.
Qed.

(* a component along a heading, and the one across it *)
Lemma inner_scal_l a x y : inner (RtoC a * x)%C y = a * inner x y.
Proof. rewrite !inner_xy. cbn. ring. Qed.
Lemma velocity_across (th : R -> R) t u : is_derive th t u -> is_velocity (fun s => Ci * expi (th s))%C t (RtoC (- u) * expi (th t))%C.
Proof.
  intros D. destruct (velocity_expi th t u D) as [V1 V2]. split.
  - apply (is_derive_ext (fun s => - snd (expi (th s)))); [intros s; cbn; ring|]. eapply D_eq; [apply D_opp, V2|]. cbn. ring.
  - apply (is_derive_ext (fun s => fst (expi (th s)))); [intros s; cbn; ring|]. eapply D_eq; [exact V1|]. cbn. ring.
Qed.
Lemma along_across a z : inner (expi a) z ^ 2 + inner (Ci * expi a)%C z ^ 2 = inner z z.
Proof.
  rewrite !inner_xy. unfold expi. cbn. pose proof (sc2 a) as T. transitivity ((sin a ^ 2 + cos a ^ 2) * (fst z * fst z + snd z * snd z)); [ring|].
  rewrite T. ring.
Qed.
Lemma velocity_row n A (x : nat -> R -> C) (v : nat -> C) k t : (forall j, (j < n)%nat -> is_velocity (x j) t (v j)) ->
  is_velocity (fun s => row n A k (fun j => x j s)) t (row n A k v).
Proof.
  intros D. unfold row, Csum. split; cbn [fst snd].
  - apply (D_Sum n (fun j s => fst (RtoC (A k j) * x j s)%C) (fun j => fst (RtoC (A k j) * v j)%C)). intros j Hj. destruct (D j Hj) as [D1 _].
    apply (is_derive_ext (fun s => A k j * fst (x j s))); [intros s; cbn; ring|].
    apply (D_eq _ t (A k j * fst (v j))); [exact (D_scal (A k j) (fun s => fst (x j s)) t _ D1)|cbn; ring].
  - apply (D_Sum n (fun j s => snd (RtoC (A k j) * x j s)%C) (fun j => snd (RtoC (A k j) * v j)%C)). intros j Hj. destruct (D j Hj) as [_ D2].
    apply (is_derive_ext (fun s => A k j * snd (x j s))); [intros s; cbn; ring|].
    apply (D_eq _ t (A k j * snd (v j))); [exact (D_scal (A k j) (fun s => snd (x j s)) t _ D2)|cbn; ring].
Qed.
Lemma Cmod_le z : Cmod z <= Rabs (fst z) + Rabs (snd z).
Proof.
  pose proof (Rabs_pos (fst z)). pose proof (Rabs_pos (snd z)). rewrite <- (Rabs_pos_eq (Cmod z)) by apply Cmod_ge_0.
  apply sqr_Rabs; [lra|]. rewrite <- inner_self, inner_xy. pose proof (pow2_abs (fst z)). pose proof (pow2_abs (snd z)). nra.
Qed.

Section Loop.
Variables (n : nat) (adj : graph) (w0 K0 : R) (r : nat -> R -> C) (th : nat -> R -> R).
Hypotheses (Hn : (1 <= n)%nat) (HS : undirected adj) (SC : strongly_connected n adj) (Hw : w0 <> 0) (HK : 0 < K0).
Hypothesis M : spaced n adj w0 K0 r th.
Let kap := K0 / INR n.
Let c (k : nat) (t : R) : C := circle_centre w0 (r k t) (th k t).
Let l (k : nat) (t : R) : C := row n (lap n adj) k (fun j => c j t).
Let g (k : nat) (t : R) : R := inner (expi (th k t)) (l k t).
Let h (k : nat) (t : R) : R := inner (Ci * expi (th k t))%C (l k t).
Let u (k : nat) (t : R) : R := w0 + w0 * (kap * g k t).
Let S (t : R) : R := Q n (lap n adj) (fun k => c k t).
Let E (t : R) : R := lap2 n adj (fun k => c k t).
Let G (t : R) : R := Sum n (fun k => g k t ^ 2).
(* the rate of (L c)_k, and its components *)
Let v (j : nat) (t : R) : C := (RtoC (- kap * g j t) * expi (th j t))%C.
Let p (k : nat) (t : R) : R := inner (expi (th k t)) (row n (lap n adj) k (fun j => v j t)).
Let q (k : nat) (t : R) : R := inner (Ci * expi (th k t))%C (row n (lap n adj) k (fun j => v j t)).

Let nn : 0 < INR n.
Proof. exact (INR_pos n Hn). Qed.
Let kp : 0 < kap.
Proof. unfold kap. now apply Rdiv_lt_0_compat. Qed.

Lemma loop_heading k t : (k < n)%nat -> 0 <= t -> is_derive (th k) t (u k t).
Proof. intros Hk Ht. exact (proj2 (M k t Hk Ht)). Qed.
Lemma loop_centre k t : (k < n)%nat -> 0 <= t -> is_velocity (c k) t (v k t).
Proof.
  intros Hk Ht. eapply velocity_eq; [apply eq18; [exact (proj1 (M k t Hk Ht))|exact (loop_heading k t Hk Ht)]|].
  unfold v, u. rewrite Cmult_comm. do 2 f_equal. field. exact Hw.
Qed.
Lemma loop_l k t : 0 <= t -> is_velocity (l k) t (row n (lap n adj) k (fun j => v j t)).
Proof. intros Ht. apply (velocity_row n (lap n adj) c (fun j => v j t)). intros j Hj. now apply loop_centre. Qed.
Lemma loop_g k t : (k < n)%nat -> 0 <= t -> is_derive (g k) t (u k t * h k t + p k t).
Proof.
  intros Hk Ht. eapply D_eq; [apply D_inner; [apply velocity_expi, (loop_heading k t Hk Ht)|apply (loop_l k t Ht)]|].
  rewrite inner_scal_l. reflexivity.
Qed.
Lemma loop_h k t : (k < n)%nat -> 0 <= t -> is_derive (h k) t (- u k t * g k t + q k t).
Proof.
  intros Hk Ht. eapply D_eq; [apply D_inner; [apply velocity_across, (loop_heading k t Hk Ht)|apply (loop_l k t Ht)]|].
  rewrite inner_scal_l. reflexivity.
Qed.
Lemma loop_S t : 0 <= t -> is_derive S t (- (kap / INR n) * G t).
Proof.
  intros Ht. apply (D_eq S t (- (K0 / INR n ^ 2) * G t)); [|unfold kap; field; lra].
  apply (paley_particles.eq20 n adj w0 K0 Hn Hw HS r th (fun k => u k t) t (fun k Hk => proj1 (M k t Hk Ht)) (fun k Hk => loop_heading k t Hk Ht)).
  intros k Hk. reflexivity.
Qed.

(* ---- bounds ---- *)
Lemma loop_gh k t : g k t ^ 2 + h k t ^ 2 = inner (l k t) (l k t).
Proof. apply along_across. Qed.
Lemma loop_E t : E t = G t + Sum n (fun k => h k t ^ 2).
Proof. unfold E, lap2, G. rewrite <- Sum_plus. apply Sum_ext; intros k _. symmetry. apply loop_gh. Qed.
Lemma loop_gE k t : (k < n)%nat -> g k t ^ 2 <= E t /\ h k t ^ 2 <= E t /\ g k t ^ 2 <= G t.
Proof.
  intros Hk. pose proof (Sum_term_le n (fun k => g k t ^ 2) k (fun _ _ => pow2_ge_0 _) Hk) as A.
  pose proof (Sum_term_le n (fun k => h k t ^ 2) k (fun _ _ => pow2_ge_0 _) Hk) as B.
  cbv beta in A, B. fold (G t) in A. rewrite loop_E.
  assert (0 <= G t) by (apply Sum_ge0; intros; apply pow2_ge_0). assert (0 <= Sum n (fun k => h k t ^ 2)) by (apply Sum_ge0; intros; apply pow2_ge_0). lra.
Qed.
Let P := INR n * Sum n (fun i => Sum n (fun j => lap n adj i j ^ 2)) * kap ^ 2.
Lemma P_ge0 : 0 <= P.
Proof. apply Rmult_le_pos; [apply Rmult_le_pos; [lra|]|apply pow2_ge_0]. apply Sum_ge0; intros; apply Sum_ge0; intros; apply pow2_ge_0. Qed.
Lemma unit_row z k t : (forall a, inner z (expi a) ^ 2 <= 1) -> (k < n)%nat -> inner z (row n (lap n adj) k (fun j => v j t)) ^ 2 <= P * G t.
Proof.
  intros Hz Hk. rewrite inner_row. eapply Rle_trans; [apply Sum_sqr_le|]. unfold P, G. rewrite !Rmult_assoc. apply Rmult_le_compat_l; [lra|].
  rewrite <- Rmult_assoc.
  set (D := Sum n (fun k => Sum n (fun j => lap n adj k j ^ 2))). rewrite <- Sum_scal. apply Sum_le; intros j Hj.
  unfold v. rewrite inner_scal.
  assert (LD : lap n adj k j ^ 2 <= D).
  { apply Rle_trans with (Sum n (fun j => lap n adj k j ^ 2)).
    - apply (Sum_term_le n (fun j => lap n adj k j ^ 2)); [intros; apply pow2_ge_0|exact Hj].
    - apply (Sum_term_le n (fun k => Sum n (fun j => lap n adj k j ^ 2))); [intros; apply Sum_ge0; intros; apply pow2_ge_0|exact Hk]. }
  pose proof (Hz (th j t)) as H1. set (x := inner z (expi (th j t))) in *.
  replace ((lap n adj k j * (- kap * g j t * x)) ^ 2) with (lap n adj k j ^ 2 * x ^ 2 * (kap ^ 2 * g j t ^ 2)) by ring.
  replace (D * kap ^ 2 * g j t ^ 2) with (D * 1 * (kap ^ 2 * g j t ^ 2)) by ring.
  apply Rmult_le_compat_r; [apply Rmult_le_pos; apply pow2_ge_0|]. apply Rmult_le_compat; try apply pow2_ge_0; assumption.
Qed.
Lemma loop_p k t : (k < n)%nat -> p k t ^ 2 <= P * G t.
Proof.
  intros Hk. apply unit_row; [|exact Hk]. intros a. rewrite inner_expi. pose proof (COS_bound (a - th k t)). nra.
Qed.
Lemma loop_q k t : (k < n)%nat -> q k t ^ 2 <= P * G t.
Proof.
  intros Hk. apply unit_row; [|exact Hk]. intros a. rewrite inner_iexpi. pose proof (SIN_bound (a - th k t)). nra.
Qed.
Lemma S_ge0 t : 0 <= S t.
Proof. now apply Q_kernel. Qed.
Lemma G_ge0 t : 0 <= G t.
Proof. apply Sum_ge0; intros; apply pow2_ge_0. Qed.
Lemma S_down s t : 0 <= s <= t -> S t <= S s.
Proof.
  intros H. apply (decreasing S (fun x => - (kap / INR n) * G x)); [lra|intros; apply loop_S; lra|]. intros x _. pose proof (G_ge0 x).
  assert (0 < kap / INR n) by (apply Rdiv_lt_0_compat; lra). nra.
Qed.
Lemma E_le t : E t <= 4 * INR n ^ 2 * S t.
Proof. exact (lap2_le n adj (fun k => c k t) Hn HS). Qed.

(* ---- the controls tend to w0 ---- *)
Lemma G_to_0 e : 0 < e -> exists T, 0 <= T /\ forall t, T <= t -> G t < e.
Proof.
  intros He. set (b := 4 * INR n ^ 2 * S 0 + 1). pose proof (S_ge0 0) as S0.
  assert (b1 : 1 <= b) by (unfold b; nra).
  assert (Eb : forall t, 0 <= t -> E t <= b ^ 2).
  { intros t Ht. pose proof (E_le t). pose proof (S_down 0 t ltac:(lra)). assert (4 * INR n ^ 2 * S t <= 4 * INR n ^ 2 * S 0) by (apply Rmult_le_compat_l; nra).
    unfold b in *. nra. }
  pose proof P_ge0 as HP. set (C := INR n * (2 * b * (Rabs w0 * (1 + kap * b) * b + (P + 1) * b))).
  assert (C0 : 0 < C).
  { unfold C. pose proof (Rabs_pos w0). assert (0 <= Rabs w0 * (1 + kap * b) * b) by (apply Rmult_le_pos; [apply Rmult_le_pos; nra|lra]).
    apply Rmult_lt_0_compat; [lra|]. apply Rmult_lt_0_compat; nra. }
  set (a := kap / INR n). assert (a0 : 0 < a) by (unfold a; apply Rdiv_lt_0_compat; lra).
  destruct (barbalat (fun t => - S t) (fun t => a * G t) 0 (a * C)) with (e := a * e) as [T [HT HG]].
  - now apply Rmult_lt_0_compat.
  - intros t Ht. eapply D_eq; [apply D_opp, loop_S, Ht|]. unfold a. ring.
  - intros t _. pose proof (G_ge0 t). nra.
  - intros t _. pose proof (S_ge0 t). lra.
  - intros s t Hst. destruct (MVT_le G (fun x => Sum n (fun k => 2 * g k x * (u k x * h k x + p k x))) s t) as [x [Hx Ex]]; [lra|..].
    + intros x Hx. unfold G. apply (D_Sum n (fun k y => g k y ^ 2) (fun k => 2 * g k x * (u k x * h k x + p k x))). intros k Hk.
      apply D_sqr, loop_g; [exact Hk|lra].
    + rewrite <- Rmult_minus_distr_l, Ex, Rabs_mult, (Rabs_right a) by lra. rewrite Rmult_assoc. apply Rmult_le_compat_l; [lra|].
      rewrite Rabs_mult, (Rabs_right (t - s)) by lra. apply Rmult_le_compat_r; [lra|]. eapply Rle_trans; [apply Sum_Rabs|].
      unfold C. rewrite <- Sum_const. apply Sum_le; intros k Hk. pose proof (Eb x ltac:(lra)) as B0. destruct (loop_gE k x Hk) as (B1 & B2 & B3).
      assert (g1 : Rabs (g k x) <= b) by (apply sqr_Rabs; lra). assert (h1 : Rabs (h k x) <= b) by (apply sqr_Rabs; lra).
      assert (p1 : Rabs (p k x) <= (P + 1) * b).
      { apply sqr_Rabs; [nra|]. pose proof (loop_p k x Hk). pose proof (G_ge0 x).
        assert (G x <= b ^ 2). { rewrite loop_E in B0. assert (0 <= Sum n (fun k => h k x ^ 2)) by (apply Sum_ge0; intros; apply pow2_ge_0). lra. }
        assert (P * G x <= P * b ^ 2) by (apply Rmult_le_compat_l; assumption). assert (0 <= b ^ 2) by apply pow2_ge_0.
        replace (((P + 1) * b) ^ 2) with (P * b ^ 2 + (P ^ 2 + P + 1) * b ^ 2) by ring. nra. }
      assert (u1 : Rabs (u k x) <= Rabs w0 * (1 + kap * b)).
      { unfold u. replace (w0 + w0 * (kap * g k x)) with (w0 * (1 + kap * g k x)) by ring. rewrite Rabs_mult. apply Rmult_le_compat_l; [apply Rabs_pos|].
        eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_R1, Rabs_mult, (Rabs_right kap) by lra. apply Rplus_le_compat_l, Rmult_le_compat_l; lra. }
      rewrite !Rabs_mult, (Rabs_right 2) by lra. apply Rmult_le_compat; [pose proof (Rabs_pos (g k x)); lra|apply Rabs_pos|lra|].
      eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_mult. apply Rplus_le_compat; [|exact p1]. apply Rmult_le_compat; try apply Rabs_pos; assumption.
  - now apply Rmult_lt_0_compat.
  - exists T. split; [exact HT|]. intros t Ht. apply Rmult_lt_reg_l with a; [exact a0|]. now apply HG.
Qed.

(* ---- the strict function: S' sees g only, the cross term brings in h once all |kap g_k| are at most 1/2 ---- *)
Let V (d t : R) : R := S t - d / w0 * Sum n (fun k => g k t * h k t).
Let V' (d t : R) : R := - (kap / INR n) * G t - d / w0 * Sum n (fun k => (u k t * h k t + p k t) * h k t + g k t * (- u k t * g k t + q k t)).
Lemma V_rate d t : 0 <= t -> is_derive (V d) t (V' d t).
Proof.
  intros Ht. unfold V, V'. apply D_minus; [now apply loop_S|]. apply D_scal.
  apply (D_Sum n (fun k s => g k s * h k s) (fun k => (u k t * h k t + p k t) * h k t + g k t * (- u k t * g k t + q k t))). intros k Hk.
  apply D_mult; [now apply loop_g|now apply loop_h].
Qed.
Let m0 := 7 / 4 + 2 * INR n * P / w0 ^ 2.
Lemma m0_ge : 7 / 4 <= m0.
Proof.
  pose proof P_ge0 as HP. pose proof (pow2_gt_0 w0 Hw) as w2. unfold m0, Rdiv at 2.
  assert (0 <= 2 * INR n * P * / w0 ^ 2) by (apply Rmult_le_pos; [apply Rmult_le_pos; lra|left; now apply Rinv_0_lt_compat]). lra.
Qed.
Lemma V_down d t : 0 <= d -> d * m0 <= kap / INR n / 2 -> kap ^ 2 * G t <= / 4 -> V' d t <= - (d / 4) * E t.
Proof.
  intros Hd Hm Hs. pose proof P_ge0 as HP. pose proof (G_ge0 t) as HG. set (H := Sum n (fun k => h k t ^ 2)).
  pose proof (pow2_gt_0 w0 Hw) as w2.
  assert (A : - (/ w0) * Sum n (fun k => (u k t * h k t + p k t) * h k t + g k t * (- u k t * g k t + q k t)) <= m0 * G t - / 4 * H).
  { apply Rle_trans with (Sum n (fun k => 7 / 4 * g k t ^ 2 - / 4 * h k t ^ 2 + 2 * (P * G t / w0 ^ 2))).
    - rewrite <- Sum_scal. apply Sum_le; intros k Hk.
      pose proof (loop_p k t Hk) as B1. pose proof (loop_q k t Hk) as B2. destruct (loop_gE k t Hk) as (_ & _ & B3).
      set (x := kap * g k t). assert (x1 : Rabs x <= / 2).
      { apply sqr_Rabs; [lra|]. unfold x. replace ((kap * g k t) ^ 2) with (kap ^ 2 * g k t ^ 2) by ring.
        assert (kap ^ 2 * g k t ^ 2 <= kap ^ 2 * G t) by (apply Rmult_le_compat_l; [apply pow2_ge_0|exact B3]). lra. }
      apply Rabs_le_between in x1. unfold u. fold x. set (gg := g k t) in *. set (hh := h k t) in *.
      set (pp := p k t / w0). set (qq := q k t / w0).
      replace (- / w0 * (((w0 + w0 * x) * hh + p k t) * hh + gg * (- (w0 + w0 * x) * gg + q k t)))
        with ((1 + x) * gg ^ 2 - (1 + x) * hh ^ 2 - pp * hh - qq * gg) by (unfold pp, qq; field; exact Hw).
      assert (p2 : pp ^ 2 <= P * G t / w0 ^ 2).
      { unfold pp, Rdiv. rewrite Rpow_mult_distr, pow_inv. apply Rmult_le_compat_r; [left; now apply Rinv_0_lt_compat|exact B1]. }
      assert (q2 : qq ^ 2 <= P * G t / w0 ^ 2).
      { unfold qq, Rdiv. rewrite Rpow_mult_distr, pow_inv. apply Rmult_le_compat_r; [left; now apply Rinv_0_lt_compat|exact B2]. }
      pose proof (pow2_ge_0 (pp + / 2 * hh)) as Y1. pose proof (pow2_ge_0 (qq + / 2 * gg)) as Y2.
      pose proof (pow2_ge_0 gg) as Y3. pose proof (pow2_ge_0 hh) as Y4.
      assert (Z1 : (1 + x) * gg ^ 2 <= 3 / 2 * gg ^ 2) by (apply Rmult_le_compat_r; lra).
      assert (Z2 : / 2 * hh ^ 2 <= (1 + x) * hh ^ 2) by (apply Rmult_le_compat_r; lra).
      lra.
    - rewrite Sum_plus, Sum_minus, !Sum_scal, Sum_const. fold (G t). fold H. unfold m0. right. field. lra. }
  apply (Rmult_le_compat_l d) in A; [|exact Hd]. unfold V'. set (X := Sum n _) in *. rewrite loop_E. fold H.
  replace (d / w0 * X) with (- (d * (- / w0 * X))) by (field; exact Hw).
  assert (B : d * (m0 * G t) <= kap / INR n / 2 * G t) by (rewrite <- Rmult_assoc; now apply Rmult_le_compat_r).
  pose proof m0_ge as m1.
  assert (D : d / 4 * G t <= kap / INR n / 2 * G t) by (apply Rmult_le_compat_r; [exact HG|nra]).
  lra.
Qed.
Lemma V_near d t : 0 <= d -> d * (4 * INR n ^ 2) <= Rabs w0 -> S t <= 2 * V d t /\ 2 * V d t <= 3 * S t.
Proof.
  intros Hd Hb. pose proof (S_ge0 t) as S0. pose proof (Rabs_pos_lt w0 Hw) as aw. pose proof (E_le t) as El.
  assert (X : Rabs (Sum n (fun k => g k t * h k t)) <= E t / 2).
  { eapply Rle_trans; [apply Sum_Rabs|]. rewrite loop_E. unfold G. rewrite <- Sum_plus. unfold Rdiv. rewrite <- Sum_scal_r. apply Sum_le; intros k _.
    pose proof (pow2_ge_0 (g k t - h k t)). pose proof (pow2_ge_0 (g k t + h k t)). apply Rabs_le. split; lra. }
  assert (Y : Rabs (d / w0 * Sum n (fun k => g k t * h k t)) <= S t / 2).
  { unfold Rdiv at 1. rewrite !Rabs_mult, Rabs_inv, (Rabs_right d) by lra.
    apply Rle_trans with (d * / Rabs w0 * (4 * INR n ^ 2 * S t / 2)).
    - apply Rmult_le_compat_l; [apply Rmult_le_pos; [exact Hd|left; now apply Rinv_0_lt_compat]|]. lra.
    - replace (d * / Rabs w0 * (4 * INR n ^ 2 * S t / 2)) with (d * (4 * INR n ^ 2) * / Rabs w0 * (S t / 2)) by (field; lra).
      apply Rle_trans with (1 * (S t / 2)); [|lra]. apply Rmult_le_compat_r; [lra|]. apply Rmult_le_reg_r with (Rabs w0); [exact aw|].
      rewrite Rmult_assoc, Rinv_l by lra. lra. }
  apply Rabs_le_between in Y. unfold V. lra.
Qed.
Lemma S_decays : exists T A m, 0 <= T /\ 0 < m /\ 0 <= A /\ forall t, 0 <= t -> S (T + t) <= A * exp (- m * t).
Proof.
  destruct (le_lap2 n adj Hn HS SC) as [B [HB LB]].
  pose proof (Rabs_pos_lt w0 Hw) as aw. pose proof m0_ge as m1.
  assert (kn : 0 < kap / INR n / 2) by (apply Rdiv_lt_0_compat; [apply Rdiv_lt_0_compat|]; lra). assert (n4 : 0 < 4 * INR n ^ 2) by nra.
  set (d := Rmin (kap / INR n / 2 / m0) (Rabs w0 / (4 * INR n ^ 2))).
  assert (d0 : 0 < d) by (apply Rmin_glb_lt; apply Rdiv_lt_0_compat; lra).
  assert (d1 : d * m0 <= kap / INR n / 2).
  { apply Rle_trans with (kap / INR n / 2 / m0 * m0); [apply Rmult_le_compat_r; [lra|apply Rmin_l]|]. right. field. split; lra. }
  assert (d2 : d * (4 * INR n ^ 2) <= Rabs w0).
  { apply Rle_trans with (Rabs w0 / (4 * INR n ^ 2) * (4 * INR n ^ 2)); [apply Rmult_le_compat_r; [lra|apply Rmin_r]|]. right. field. lra. }
  clearbody d.
  destruct (G_to_0 (/ (4 * kap ^ 2))) as [T [HT GT]]; [apply Rinv_0_lt_compat; nra|].
  exists T, (2 * V d T), (d / (6 * B)). split; [exact HT|]. split; [apply Rdiv_lt_0_compat; lra|].
  split; [pose proof (V_near d T ltac:(lra) d2); pose proof (S_ge0 T); lra|].
  intros t Ht.
  assert (K : V d (T + t) <= V d (T + 0) * exp (- (d / (6 * B)) * t)).
  { apply (gronwall (fun s => V d (T + s)) (fun s => V' d (T + s))); [| |exact Ht].
    - intros s Hs. eapply D_eq; [apply (D_comp (V d) (fun s => T + s) s (V' d (T + s)) 1)|ring]; [apply V_rate; lra|].
      eapply D_eq; [apply D_plus; [apply D_const|apply D_id]|ring].
    - intros s Hs. eapply Rle_trans; [apply (V_down d (T + s)); [lra|exact d1|]|].
      + pose proof (GT (T + s) ltac:(lra)) as L. apply (Rmult_lt_compat_l (kap ^ 2)) in L; [|nra].
        replace (kap ^ 2 * / (4 * kap ^ 2)) with (/ 4) in L by (field; lra). lra.
      + pose proof (LB (fun k => c k (T + s))) as L. fold (S (T + s)) (E (T + s)) in L. destruct (V_near d (T + s) ltac:(lra) d2) as [_ N].
        apply Rmult_le_reg_l with (6 * B); [lra|]. replace (6 * B * (- (d / (6 * B)) * V d (T + s))) with (- (d * V d (T + s))) by (field; lra).
        replace (6 * B * (- (d / 4) * E (T + s))) with (- (d * (3 / 2 * (B * E (T + s))))) by field.
        apply Ropp_le_contravar, Rmult_le_compat_l; lra. }
  rewrite Rplus_0_r in K. destruct (V_near d (T + t) ltac:(lra) d2) as [N _]. lra.
Qed.
Lemma loop_converges : exists (c0 : C) (T A m : R), 0 <= T /\ 0 < m /\ forall k t, (k < n)%nat -> 0 <= t ->
  Cmod (c k (T + t) - c0)%C <= A * exp (- m * t) /\ Rabs (w0 * (kap * g k (T + t))) <= A * exp (- m * t).
Proof.
  destruct S_decays as (T & A & m & HT & Hm & HA & HD). destruct (spacing_proper n adj Hn HS SC) as [B [HB LB]].
  set (b := 2 * INR n * sqrt A). pose proof (sqrt_pos A) as sA. assert (b0 : 0 <= b) by (unfold b; nra).
  assert (ex : forall t, exp (- m * t) = exp (- (m / 2) * t) ^ 2).
  { intros t. replace (- m * t) with (- (m / 2) * t + - (m / 2) * t) by field. rewrite exp_plus. ring. }
  assert (Gb : forall k t, (k < n)%nat -> 0 <= t -> Rabs (g k (T + t)) <= b * exp (- (m / 2) * t)).
  { intros k t Hk Ht. pose proof (exp_pos (- (m / 2) * t)) as Ep. apply sqr_Rabs; [apply Rmult_le_pos; lra|].
    replace ((b * exp (- (m / 2) * t)) ^ 2) with (4 * INR n ^ 2 * (sqrt A * sqrt A * exp (- (m / 2) * t) ^ 2)) by (unfold b; ring).
    rewrite sqrt_sqrt, <- ex by exact HA. destruct (loop_gE k (T + t) Hk) as [B1 _]. pose proof (E_le (T + t)).
    assert (4 * INR n ^ 2 * S (T + t) <= 4 * INR n ^ 2 * (A * exp (- m * t))) by (apply Rmult_le_compat_l; [nra|now apply HD]). lra. }
  assert (Vb : forall x t, 0 <= t -> Rabs x <= 1 -> Rabs (- kap * g 0 (T + t) * x) <= kap * b * exp (- (m / 2) * t)).
  { intros x t Ht Hx. rewrite !Rabs_mult, Rabs_Ropp, (Rabs_right kap) by lra. pose proof (Gb 0%nat t ltac:(lia) Ht) as L.
    pose proof (Rabs_pos (g 0 (T + t))). pose proof (Rabs_pos x). rewrite (Rmult_assoc kap b), Rmult_assoc. apply Rmult_le_compat_l; [lra|]. nra. }
  assert (Sh : forall (f : R -> R) (d t : R), is_derive f (T + t) d -> is_derive (fun s => f (T + s)) t d).
  { intros f d t D. eapply D_eq; [apply (D_comp f (fun s => T + s) t d 1 D)|ring]. eapply D_eq; [apply D_plus; [apply D_const|apply D_id]|ring]. }
  destruct (settles (fun t => fst (c 0 (T + t))) (fun t => - kap * g 0 (T + t) * cos (th 0%nat (T + t))) (kap * b) (m / 2)) as [x Hx].
  - lra.
  - intros t Ht. apply (Sh (fun s => fst (c 0 s))). destruct (loop_centre 0 (T + t) ltac:(lia) ltac:(lra)) as [D _].
    apply (D_eq _ _ _ _ D). unfold v, expi. cbn [fst snd Cmult RtoC]. ring.
  - intros t Ht. apply Vb; [exact Ht|]. pose proof (COS_bound (th 0%nat (T + t))). apply Rabs_le; lra.
  - destruct (settles (fun t => snd (c 0 (T + t))) (fun t => - kap * g 0 (T + t) * sin (th 0%nat (T + t))) (kap * b) (m / 2)) as [y Hy].
    + lra.
    + intros t Ht. apply (Sh (fun s => snd (c 0 s))). destruct (loop_centre 0 (T + t) ltac:(lia) ltac:(lra)) as [_ D].
      apply (D_eq _ _ _ _ D). unfold v, expi. cbn [fst snd Cmult RtoC]. ring.
    + intros t Ht. apply Vb; [exact Ht|]. pose proof (SIN_bound (th 0%nat (T + t))). apply Rabs_le; lra.
    + set (D := kap * b / (m / 2)) in *. pose proof (sqrt_pos (B * A)) as sBA. assert (BA : 0 <= B * A) by now apply Rmult_le_pos.
      pose proof (Rabs_pos w0) as aw. assert (D0 : 0 <= D) by (unfold D, Rdiv; apply Rmult_le_pos; [nra|left; apply Rinv_0_lt_compat; lra]).
      assert (F0 : 0 <= Rabs w0 * (kap * b)) by (apply Rmult_le_pos; nra).
      exists (x, y), T, (2 * (D + sqrt (B * A)) + Rabs w0 * (kap * b)), (m / 2). split; [exact HT|]. split; [lra|]. intros k t Hk Ht.
      pose proof (exp_pos (- (m / 2) * t)) as Ep. set (e := exp (- (m / 2) * t)) in *. split.
      * apply Rle_trans with (2 * (D + sqrt (B * A)) * e); [|apply Rmult_le_compat_r; lra].
        specialize (Hx t Ht). specialize (Hy t Ht). cbv beta in Hx, Hy. fold e in Hx, Hy.
        pose proof (LB (fun k => c k (T + t)) k 0%nat Hk ltac:(lia)) as L. cbv beta in L. fold (S (T + t)) in L. rewrite dist2_xy in L.
        assert (L2 : B * S (T + t) <= (sqrt (B * A) * e) ^ 2).
        { replace ((sqrt (B * A) * e) ^ 2) with (sqrt (B * A) * sqrt (B * A) * e ^ 2) by ring. rewrite sqrt_sqrt by exact BA. unfold e. rewrite <- ex, Rmult_assoc.
          apply Rmult_le_compat_l; [exact HB|now apply HD]. }
        pose proof (pow2_ge_0 (fst (c k (T + t)) - fst (c 0%nat (T + t)))). pose proof (pow2_ge_0 (snd (c k (T + t)) - snd (c 0%nat (T + t)))).
        assert (0 <= sqrt (B * A) * e) by (apply Rmult_le_pos; lra).
        assert (X1 : Rabs (fst (c k (T + t)) - fst (c 0%nat (T + t))) <= sqrt (B * A) * e) by (apply sqr_Rabs; lra).
        assert (X2 : Rabs (snd (c k (T + t)) - snd (c 0%nat (T + t))) <= sqrt (B * A) * e) by (apply sqr_Rabs; lra).
        eapply Rle_trans; [apply Cmod_le|]. change (fst (c k (T + t) - (x, y))%C) with (fst (c k (T + t)) - x).
        change (snd (c k (T + t) - (x, y))%C) with (snd (c k (T + t)) - y).
        apply Rabs_le_between in X1, X2, Hx, Hy.
        assert (Y1 : Rabs (fst (c k (T + t)) - x) <= (D + sqrt (B * A)) * e) by (apply Rabs_le; lra).
        assert (Y2 : Rabs (snd (c k (T + t)) - y) <= (D + sqrt (B * A)) * e) by (apply Rabs_le; lra). lra.
      * apply Rle_trans with (Rabs w0 * (kap * b) * e); [|apply Rmult_le_compat_r; lra].
        rewrite !Rabs_mult, (Rabs_right kap), !Rmult_assoc by lra. apply Rmult_le_compat_l; [exact aw|]. apply Rmult_le_compat_l; [lra|now apply Gb].
Qed.
End Loop.

(* the centres tend to one point and the rates of turning to w0, exponentially *)
Theorem centres_meet n adj w0 K0 (r : nat -> R -> C) (th : nat -> R -> R) : (1 <= n)%nat -> undirected adj -> strongly_connected n adj ->
  w0 <> 0 -> 0 < K0 -> spaced n adj w0 K0 r th ->
  exists (c0 : C) (T A m : R), 0 <= T /\ 0 < m /\ forall k t, (k < n)%nat -> T <= t ->
    Cmod (circle_centre w0 (r k t) (th k t) - c0)%C <= A * exp (- m * t) /\
    Rabs (w0 * (K0 / INR n * aS n adj w0 (fun j => r j t) (fun j => th j t) k)) <= A * exp (- m * t).
Proof.
  intros Hn HS SC Hw HK M. destruct (loop_converges n adj w0 K0 r th Hn HS SC Hw HK M) as (c0 & T & A & m & HT & Hm & H).
  exists c0, T, (A * exp (m * T)), m. split; [exact HT|]. split; [exact Hm|]. intros k t Hk Ht. specialize (H k (t - T) Hk ltac:(lra)). cbv beta in H.
  replace (T + (t - T)) with t in H by ring. rewrite Rmult_assoc, <- exp_plus. replace (m * T + - m * t) with (- m * (t - T)) by ring. exact H.
Qed.

(* ---- the particles tend to uniform motions on one circle ---- *)
Lemma expi_near a b : Cmod (expi a - expi b)%C <= 2 * Rabs (a - b).
Proof.
  eapply Rle_trans; [apply Cmod_le|]. change (fst (expi a - expi b)%C) with (cos a - cos b). change (snd (expi a - expi b)%C) with (sin a - sin b).
  pose proof (cos_near a b). pose proof (sin_near a b). lra.
Qed.
(* where a particle is on its circle, as an angle about the centre *)
Lemma quarter_turn w0 psi : w0 <> 0 -> exists phi, forall a, (RtoC (/ w0) * (Ci * expi (psi + a)) = - (RtoC (/ Rabs w0) * expi (phi + a)))%C.
Proof.
  intros Hw. destruct (Rtotal_order w0 0) as [L|[L|L]]; [|contradiction|].
  - exists (PI / 2 + psi). intros a. rewrite Rabs_left by assumption. replace (PI / 2 + psi + a) with (PI / 2 + (psi + a)) by ring.
    generalize (psi + a). intros x. apply injective_projections; cbn.
    + rewrite cos_plus, cos_PI2, sin_PI2. field. lra.
    + rewrite sin_plus, cos_PI2, sin_PI2. field. lra.
  - exists (psi - PI / 2). intros a. rewrite Rabs_right by lra. replace (psi - PI / 2 + a) with ((psi + a) - PI / 2) by ring.
    generalize (psi + a). intros x. apply injective_projections; cbn.
    + rewrite cos_minus, cos_PI2, sin_PI2. field. lra.
    + rewrite sin_minus, cos_PI2, sin_PI2. field. lra.
Qed.
(* Theorem 2: every solution tends to a circular formation: one centre, the radius 1/|w0|, headings and angles about the centre that turn at w0 *)
Theorem thm2 n adj w0 K0 (r : nat -> R -> C) (th : nat -> R -> R) : (1 <= n)%nat -> undirected adj -> strongly_connected n adj ->
  w0 <> 0 -> 0 < K0 -> spaced n adj w0 K0 r th ->
  exists (c0 : C) (T A m : R), 0 < m /\ forall k, (k < n)%nat -> exists psi phi : R, forall t, T <= t ->
    Rabs (th k t - (psi + w0 * t)) <= A * exp (- m * t) /\
    Cmod (r k t - (c0 + RtoC (/ Rabs w0) * expi (phi + w0 * t)))%C <= A * exp (- m * t) /\
    circle_centre w0 (c0 + RtoC (/ Rabs w0) * expi (phi + w0 * t))%C (psi + w0 * t) = c0.
Proof.
  intros Hn HS SC Hw HK M. destruct (centres_meet n adj w0 K0 r th Hn HS SC Hw HK M) as (c0 & T & A & m & HT & Hm & H).
  pose proof (Rinv_0_lt_compat _ (Rabs_pos_lt w0 Hw)) as aw.
  assert (A0 : 0 <= A).
  { destruct (H 0%nat T ltac:(lia) ltac:(lra)) as [_ L]. pose proof (exp_pos (- m * T)).
    pose proof (Rle_trans _ _ _ (Rabs_pos _) L). nra. }
  assert (Am : 0 <= A / m) by (unfold Rdiv; apply Rmult_le_pos; [exact A0|left; now apply Rinv_0_lt_compat]).
  assert (F0 : 0 <= / Rabs w0 * (2 * (A / m))) by (apply Rmult_le_pos; lra).
  exists c0, T, (A + A / m + / Rabs w0 * (2 * (A / m))), m. split; [exact Hm|]. intros k Hk.
  destruct (settles (fun s => th k (T + s) - w0 * s)
    (fun s => w0 * (K0 / INR n * aS n adj w0 (fun j => r j (T + s)) (fun j => th j (T + s)) k)) (A * exp (- m * T)) m) as [l Hl].
  - exact Hm.
  - intros s Hs. destruct (M k (T + s) Hk ltac:(lra)) as [_ D].
    eapply D_eq; [apply D_minus; [apply (D_comp (th k) (fun s => T + s) s _ 1 D)|apply D_scal, D_id]|ring].
    eapply D_eq; [apply D_plus; [apply D_const|apply D_id]|ring].
  - intros s Hs. rewrite Rmult_assoc, <- exp_plus. replace (- m * T + - m * s) with (- m * (T + s)) by ring. apply (H k (T + s) Hk). lra.
  - set (psi := l - w0 * T). destruct (quarter_turn w0 psi Hw) as [phi Hphi]. exists psi, phi. intros t Ht.
    pose proof (exp_pos (- m * t)) as Ep. specialize (Hl (t - T) ltac:(lra)). cbv beta in Hl. replace (T + (t - T)) with t in Hl by ring.
    assert (Hth : Rabs (th k t - (psi + w0 * t)) <= A / m * exp (- m * t)).
    { replace (th k t - (psi + w0 * t)) with (th k t - w0 * (t - T) - l) by (unfold psi; ring). eapply Rle_trans; [exact Hl|]. right.
      replace (- m * t) with (- m * T + - m * (t - T)) by ring. rewrite exp_plus. field. lra. }
    split; [|split].
    + apply Rle_trans with (1 := Hth). apply Rmult_le_compat_r; lra.
    + replace (r k t - (c0 + RtoC (/ Rabs w0) * expi (phi + w0 * t)))%C with
        ((circle_centre w0 (r k t) (th k t) - c0) + - (RtoC (/ w0) * (Ci * (expi (th k t) - expi (psi + w0 * t)))))%C.
      * eapply Rle_trans; [apply Cmod_triangle|]. rewrite Cmod_opp, !Cmod_mult, Cmod_R, Rabs_inv.
        replace (Cmod Ci) with 1 by (unfold Cmod, Ci; cbn [fst snd]; replace (0 ^ 2 + 1 ^ 2) with 1 by ring; symmetry; apply sqrt_1).
        pose proof (expi_near (th k t) (psi + w0 * t)) as N. destruct (H k t Hk Ht) as [L _].
        assert (N2 : / Rabs w0 * (1 * Cmod (expi (th k t) - expi (psi + w0 * t))%C) <= / Rabs w0 * (2 * (A / m * exp (- m * t)))) by (apply Rmult_le_compat_l; lra).
        assert (0 <= A / m * exp (- m * t)) by (apply Rmult_le_pos; lra). lra.
      * pose proof (Hphi (w0 * t)) as E. unfold circle_centre.
        replace (c0 + RtoC (/ Rabs w0) * expi (phi + w0 * t))%C with (c0 - - (RtoC (/ Rabs w0) * expi (phi + w0 * t)))%C by ring. rewrite <- E. ring.
    + unfold circle_centre. rewrite Hphi. ring.
Qed.
