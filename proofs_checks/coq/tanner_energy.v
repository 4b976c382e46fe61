(* Tanner, Jadbabaie, Pappas, Part I and the fixed/switching paper: the energy identities (eqs (8), (9) of both), the
   angular momentum (eq (6)), with real derivatives, n agents in the plane, pair potentials V_ij of the distance. *)
From Coq Require Import Reals Lra Lia Psatz Relations List.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums paley_model paley_phase paley_laplacian paley_gradient paley_particles.
Open Scope R_scope.

Definition norm (z : C) : R := Cmod z.
Lemma norm_sqr z : norm z * norm z = inner z z.
Proof. unfold norm. rewrite inner_self. ring. Qed.
Lemma norm_pos z : z <> RtoC 0 -> 0 < norm z.
Proof. apply Cmod_gt_0. Qed.
Lemma norm_ge0 z : 0 <= norm z.
Proof. apply Cmod_ge_0. Qed.
Lemma norm_0 z : norm z = 0 -> z = RtoC 0.
Proof. apply Cmod_eq_0. Qed.
Lemma norm_inner z : norm z = sqrt (inner z z).
Proof. unfold norm, Cmod. rewrite inner_xy. f_equal. ring. Qed.
Lemma D_norm (z : R -> C) t v : is_velocity z t v -> z t <> RtoC 0 -> is_derive (fun s => norm (z s)) t (inner (z t) v / norm (z t)).
Proof.
  intros V N. pose proof (norm_pos _ N) as P. pose proof (norm_sqr (z t)) as S.
  apply (is_derive_ext (fun s => sqrt (inner (z s) (z s)))); [intros; now rewrite norm_inner|].
  assert (PI0 : 0 < inner (z t) (z t)) by (rewrite <- S; nra).
  eapply D_eq; [apply (D_comp sqrt (fun s => inner (z s) (z s)) t (/ (2 * sqrt (inner (z t) (z t)))))|].
  - apply is_derive_Reals. now apply derivable_pt_lim_sqrt.
  - apply (D_inner z z t v v V V).
  - rewrite <- norm_inner, (inner_sym v). field. lra.
Qed.
Lemma velocity_minus (x y : R -> C) t u v : is_velocity x t u -> is_velocity y t v -> is_velocity (fun s => x s - y s)%C t (u - v)%C.
Proof.
  intros [A B] [A' B']. split.
  - apply (is_derive_ext (fun s => fst (x s) - fst (y s))); [reflexivity|]. now apply D_minus.
  - apply (is_derive_ext (fun s => snd (x s) - snd (y s))); [reflexivity|]. now apply D_minus.
Qed.

(* ---- the pair force: the gradient of V(|r_i - r_j|) with respect to r_i ---- *)
Definition grad (V' : R -> R) (ri rj : C) : C := (RtoC (V' (norm (ri - rj)%C) / norm (ri - rj)%C) * (ri - rj))%C.
Lemma norm_opp z : norm (- z)%C = norm z.
Proof. apply Cmod_opp. Qed.
Lemma norm_sym x y : norm (x - y)%C = norm (y - x)%C.
Proof. rewrite <- norm_opp. f_equal. ring. Qed.
Theorem grad_antisym V' ri rj : grad V' rj ri = (- grad V' ri rj)%C.
Proof. unfold grad. rewrite norm_sym. ring. Qed.
(* along any motion of the two agents *)
Theorem pair_rate (V V' : R -> R) (ri rj : R -> C) t vi vj : is_velocity ri t vi -> is_velocity rj t vj -> ri t <> rj t ->
  is_derive V (norm (ri t - rj t)%C) (V' (norm (ri t - rj t)%C)) ->
  is_derive (fun s => V (norm (ri s - rj s)%C)) t (inner (grad V' (ri t) (rj t)) (vi - vj)%C).
Proof.
  intros Hi Hj N HV. assert (N0 : (ri t - rj t)%C <> RtoC 0).
  { intros E. apply N. replace (ri t) with ((ri t - rj t) + rj t)%C by ring. rewrite E. ring. }
  pose proof (norm_pos _ N0) as P.
  eapply D_eq; [apply (D_comp V (fun s => norm (ri s - rj s)%C) t _ _ HV (D_norm _ t _ (velocity_minus ri rj t vi vj Hi Hj) N0))|].
  unfold grad. rewrite (inner_sym (_ * _)%C), inner_scal, (inner_sym (vi - vj)%C). field. lra.
Qed.
(* eq (8) of Part I: dV/dr_ij = dV/dr_i = - dV/dr_j as directional derivatives *)
Theorem tanner1_eq8_gradients (V V' : R -> R) (ri rj e : C) : ri <> rj -> is_derive V (norm (ri - rj)%C) (V' (norm (ri - rj)%C)) ->
  is_derive (fun s => V (norm (ri + RtoC s * e - rj)%C)) 0 (inner (grad V' ri rj) e) /\
  is_derive (fun s => V (norm (ri - (rj + RtoC s * e))%C)) 0 (- inner (grad V' ri rj) e) /\
  is_derive (fun s => V (norm ((ri - rj) + RtoC s * e)%C)) 0 (inner (grad V' ri rj) e).
Proof.
  intros N HV.
  assert (L : forall a : C, is_velocity (fun s => a + RtoC s * e)%C 0 e).
  { intros a. split.
    - apply (is_derive_ext (fun s : R => fst a + fst e * s)); [intros; cbn; ring|]. eapply D_eq; [apply D_plus; [apply D_const|apply D_scal, D_id]|]. ring.
    - apply (is_derive_ext (fun s : R => snd a + snd e * s)); [intros; cbn; ring|]. eapply D_eq; [apply D_plus; [apply D_const|apply D_scal, D_id]|]. ring. }
  assert (K : forall a : C, is_velocity (fun _ => a) 0 (RtoC 0)) by (intros; split; apply D_const).
  assert (Z : forall a : C, (a + RtoC 0 * e)%C = a) by (intros; apply injective_projections; cbn; ring).
  pose proof (pair_rate V V' (fun s => ri + RtoC s * e)%C (fun _ => rj) 0 e (RtoC 0) (L ri) (K rj)) as A.
  pose proof (pair_rate V V' (fun _ => ri) (fun s => rj + RtoC s * e)%C 0 (RtoC 0) e (K ri) (L rj)) as B. cbv beta in A, B.
  rewrite Z in A, B. specialize (A N HV). specialize (B N HV).
  assert (A' : is_derive (fun s => V (norm (ri + RtoC s * e - rj)%C)) 0 (inner (grad V' ri rj) e)).
  { eapply D_eq; [exact A|]. f_equal. apply injective_projections; cbn; ring. }
  split; [exact A'|split].
  - eapply D_eq; [exact B|]. rewrite !inner_xy. cbn [fst snd Cminus Cplus Copp RtoC]. ring.
  - apply (is_derive_ext (fun s => V (norm (ri + RtoC s * e - rj)%C))); [|exact A']. intros s. do 2 f_equal. ring.
Qed.

(* ---- the chain rule of the group energy ---- *)
Section Energy.
Variables (n : nat) (f : nat -> nat -> R -> R) (g : nat -> nat -> C) (v : nat -> R -> C) (u : nat -> C) (t : R).
(* pair energies f_ij with rates <g_ij, v_i - v_j>, g_ji = - g_ij; accelerations u_i *)
Hypothesis F : forall i j, (i < n)%nat -> (j < n)%nat -> is_derive (f i j) t (inner (g i j) (v i t - v j t)%C).
Hypothesis G : forall i j, (i < n)%nat -> (j < n)%nat -> g j i = (- g i j)%C.
Hypothesis U : forall i, (i < n)%nat -> is_velocity (v i) t (u i).

Lemma pair_sum_swap : / 2 * Sum n (fun i => Sum n (fun j => inner (g i j) (v i t - v j t)%C)) =
  Sum n (fun i => inner (v i t) (Csum n (fun j => g i j))).
Proof.
  pose proof (half_swap n (fun i j => fst (g i j)) (fun i => fst (v i t))) as H1.
  pose proof (half_swap n (fun i j => snd (g i j)) (fun i => snd (v i t))) as H2. cbv beta in H1, H2.
  rewrite (Sum_ext n (fun i => inner (v i t) _) (fun i => fst (v i t) * Sum n (fun j => fst (g i j)) + snd (v i t) * Sum n (fun j => snd (g i j))))
    by (intros; rewrite inner_xy; reflexivity).
  rewrite (Sum_ext n (fun i => Sum n (fun j => inner (g i j) (v i t - v j t)%C))
    (fun i => Sum n (fun j => fst (g i j) * (fst (v i t) - fst (v j t))) + Sum n (fun j => snd (g i j) * (snd (v i t) - snd (v j t))))).
  - rewrite !Sum_plus, H1, H2; [field|intros i j Hi Hj; rewrite (G i j Hi Hj); reflexivity..].
  - intros i _. rewrite <- Sum_plus. apply Sum_ext; intros j _. rewrite inner_xy. cbn. ring.
Qed.
Theorem potential_rate : is_derive (fun s => / 2 * Sum n (fun i => Sum n (fun j => f i j s))) t
  (Sum n (fun i => inner (v i t) (Csum n (fun j => g i j)))).
Proof.
  rewrite <- pair_sum_swap. apply D_scal. apply (D_Sum n (fun i s => Sum n (fun j => f i j s))
    (fun i => Sum n (fun j => inner (g i j) (v i t - v j t)%C))). intros i Hi.
  apply (D_Sum n (fun j s => f i j s) (fun j => inner (g i j) (v i t - v j t)%C)). intros j Hj. now apply F.
Qed.
Theorem kinetic_rate : is_derive (fun s => / 2 * Sum n (fun i => inner (v i s) (v i s))) t (Sum n (fun i => inner (v i t) (u i))).
Proof.
  eapply D_eq.
  - apply D_scal. apply (D_Sum n (fun i s => inner (v i s) (v i s)) (fun i => inner (u i) (v i t) + inner (v i t) (u i))).
    intros i Hi. apply D_inner; now apply U.
  - rewrite (Sum_ext n _ (fun i => 2 * inner (v i t) (u i))) by (intros; rewrite (inner_sym (u i)); ring). rewrite Sum_scal. field.
Qed.
Theorem energy_chain : is_derive (fun s => / 2 * Sum n (fun i => Sum n (fun j => f i j s) + inner (v i s) (v i s))) t
  (Sum n (fun i => inner (v i t) (Csum n (fun j => g i j))) + Sum n (fun i => inner (v i t) (u i))).
Proof.
  apply (is_derive_ext (fun s => / 2 * Sum n (fun i => Sum n (fun j => f i j s)) + / 2 * Sum n (fun i => inner (v i s) (v i s)))).
  { intros s. rewrite Sum_plus. Rring. }
  apply D_plus; [apply potential_rate|apply kinetic_rate].
Qed.
End Energy.

(* ---- the closed loop of the fixed graph (eq (4) of the switching paper) ---- *)
Definition pair_grad (adj : graph) (V' : nat -> nat -> R -> R) (r : nat -> C) (i j : nat) : C :=
  (RtoC (w adj i j) * grad (V' i j) (r i) (r j))%C.
Definition grad_i (n : nat) (adj : graph) (V' : nat -> nat -> R -> R) (r : nat -> C) (i : nat) : C := Csum n (pair_grad adj V' r i).
Definition control4 (n : nat) (adj : graph) (V' : nat -> nat -> R -> R) (r v : nat -> C) (i : nat) : C :=
  (- Csum n (fun j => RtoC (w adj i j) * (v i - v j)) - grad_i n adj V' r i)%C.
Definition V_i (n : nat) (adj : graph) (V : nat -> nat -> R -> R) (r : nat -> C) (i : nat) : R :=
  Sum n (fun j => w adj i j * V i j (norm (r i - r j)%C)).
Definition Wenergy (n : nat) (adj : graph) (V : nat -> nat -> R -> R) (r v : nat -> C) : R :=
  / 2 * Sum n (fun i => V_i n adj V r i + inner (v i) (v i)).
(* v^T (L x I_2) v, with the agents' velocities stacked as (x_1, y_1, x_2, y_2, ...) *)
Definition kron2 (L : nat -> nat -> R) (a b : nat) : R := L (a / 2)%nat (b / 2)%nat * delta (a mod 2) (b mod 2).
Definition stack (v : nat -> C) (a : nat) : R := if Nat.even a then fst (v (a / 2)%nat) else snd (v (a / 2)%nat).
Definition qform (m : nat) (A : nat -> nat -> R) (x : nat -> R) : R := Sum m (fun a => x a * Sum m (fun b => A a b * x b)).

Lemma Sum_even_odd n f : Sum (2 * n) f = Sum n (fun i => f (2 * i)%nat + f (2 * i + 1)%nat).
Proof.
  induction n as [|n IH]; [reflexivity|]. replace (2 * Datatypes.S n)%nat with (Datatypes.S (Datatypes.S (2 * n))) by lia. cbn [Sum].
  rewrite IH. replace (2 * n + 1)%nat with (Datatypes.S (2 * n)) by lia. ring.
Qed.
Lemma half_even i : ((2 * i) / 2 = i)%nat. Proof. rewrite Nat.mul_comm. now apply Nat.div_mul. Qed.
Lemma half_odd i : ((2 * i + 1) / 2 = i)%nat. Proof. rewrite Nat.mul_comm, Nat.div_add_l by lia. cbn. lia. Qed.
Lemma mod_even i : ((2 * i) mod 2 = 0)%nat. Proof. rewrite Nat.mul_comm. now apply Nat.mod_mul. Qed.
Lemma mod_odd i : ((2 * i + 1) mod 2 = 1)%nat. Proof. rewrite Nat.add_comm, Nat.mul_comm, Nat.mod_add by lia. reflexivity. Qed.
Lemma stack_even v i : stack v (2 * i) = fst (v i).
Proof. unfold stack. rewrite Nat.even_mul, half_even. reflexivity. Qed.
Lemma stack_odd v i : stack v (2 * i + 1) = snd (v i).
Proof. unfold stack. rewrite half_odd, Nat.even_add, Nat.even_mul. reflexivity. Qed.
Theorem kron_split n L v : qform (2 * n) (kron2 L) (stack v) = qform n L (fun i => fst (v i)) + qform n L (fun i => snd (v i)).
Proof.
  unfold qform. rewrite Sum_even_odd, <- Sum_plus. apply Sum_ext; intros i _. rewrite !Sum_even_odd, stack_even, stack_odd.
  f_equal; f_equal; apply Sum_ext; intros j _; unfold kron2; rewrite !half_even, !half_odd, !mod_even, !mod_odd, stack_even, stack_odd;
  unfold delta; cbn [Nat.eqb]; ring.
Qed.
Theorem form_split n L v : Sum n (fun i => inner (v i) (row n L i v)) = qform n L (fun i => fst (v i)) + qform n L (fun i => snd (v i)).
Proof.
  unfold qform. rewrite <- Sum_plus. apply Sum_ext; intros i _. rewrite inner_xy. unfold row, Csum; cbn [fst snd].
  f_equal; f_equal; apply Sum_ext; intros; cbn; ring.
Qed.

Section Fixed.
Variables (n : nat) (adj : graph) (V V' : nat -> nat -> R -> R) (r v : nat -> R -> C) (t : R).
Hypothesis S : undirected adj.
Hypothesis VS : forall i j, V' i j = V' j i.
Hypothesis HR : forall i, (i < n)%nat -> is_velocity (r i) t (v i t).
Hypothesis HN : forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> r i t <> r j t.
Hypothesis HV : forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true ->
  is_derive (V i j) (norm (r i t - r j t)%C) (V' i j (norm (r i t - r j t)%C)).
Notation rt := (fun i => r i t).
Notation vt := (fun i => v i t).

Lemma pair_grad_antisym (q : nat -> C) i j : pair_grad adj V' q j i = (- pair_grad adj V' q i j)%C.
Proof. unfold pair_grad. rewrite (grad_antisym (V' j i) (q i) (q j)), VS. unfold w. rewrite (S j i). ring. Qed.
Lemma linked_rate i j : (i < n)%nat -> (j < n)%nat ->
  is_derive (fun s => w adj i j * V i j (norm (r i s - r j s)%C)) t (inner (pair_grad adj V' rt i j) (v i t - v j t)%C).
Proof.
  intros Hi Hj. unfold pair_grad, w. destruct (adj i j) eqn:A.
  - eapply D_eq; [apply D_scal, (pair_rate (V i j) (V' i j) (r i) (r j) t _ _ (HR i Hi) (HR j Hj) (HN i j Hi Hj A) (HV i j Hi Hj A))|].
    rewrite (inner_sym (RtoC 1 * _)%C), inner_scal, (inner_sym (v i t - v j t)%C). reflexivity.
  - apply (is_derive_ext (fun _ : R => 0)); [intros; Rring|]. eapply D_eq; [apply D_const|]. rewrite inner_xy. cbn. ring.
Qed.
(* eq (8): half the sum of the dV_i/dt is the sum of <v_i, grad_i V_i> *)
Theorem eq8_potential : is_derive (fun s => / 2 * Sum n (fun i => V_i n adj V (fun i => r i s) i)) t
  (Sum n (fun i => inner (v i t) (grad_i n adj V' rt i))).
Proof.
  exact (potential_rate n (fun i j s => w adj i j * V i j (norm (r i s - r j s)%C)) (pair_grad adj V' rt) v t
    linked_rate (fun i j _ _ => pair_grad_antisym rt i j)).
Qed.
(* ... and the sum over the edges i < j of <rdot_ij, grad_ij> and of <rdot_i, grad_i> + <rdot_j, grad_j> *)
Theorem eq8_edges : no_loops adj ->
  Sum n (fun i => inner (v i t) (grad_i n adj V' rt i)) =
    Sum n (fun i => Sum i (fun j => w adj i j * inner (v i t - v j t)%C (grad (V' i j) (r i t) (r j t)))) /\
  Sum n (fun i => inner (v i t) (grad_i n adj V' rt i)) =
    Sum n (fun i => Sum i (fun j => w adj i j * (inner (v i t) (grad (V' i j) (r i t) (r j t)) + inner (v j t) (grad (V' i j) (r j t) (r i t))))).
Proof.
  intros NL.
  assert (E : Sum n (fun i => inner (v i t) (grad_i n adj V' rt i)) =
    Sum n (fun i => Sum i (fun j => w adj i j * inner (v i t - v j t)%C (grad (V' i j) (r i t) (r j t))))).
  { transitivity (/ 2 * Sum n (fun i => Sum n (fun j => inner (pair_grad adj V' rt i j) (v i t - v j t)%C))).
    { symmetry. exact (pair_sum_swap n (pair_grad adj V' rt) v t (fun i j _ _ => pair_grad_antisym rt i j)). }
    assert (H : forall m, Sum m (fun i => Sum m (fun j => inner (pair_grad adj V' rt i j) (v i t - v j t)%C)) =
      2 * Sum m (fun i => Sum i (fun j => w adj i j * inner (v i t - v j t)%C (grad (V' i j) (r i t) (r j t))))).
    { assert (P : forall i j, inner (pair_grad adj V' rt i j) (v i t - v j t)%C = w adj i j * inner (v i t - v j t)%C (grad (V' i j) (r i t) (r j t))).
      { intros i j. unfold pair_grad. rewrite inner_sym, inner_scal. reflexivity. }
      induction m as [|m IH]; [cbn; ring|]. cbn [Sum]. rewrite Sum_plus, IH, !P.
      replace (w adj m m) with 0 by (unfold w; now rewrite NL).
      rewrite (Sum_ext m (fun i => inner (pair_grad adj V' rt i m) (v i t - v m t)%C) (fun j => w adj m j * inner (v m t - v j t)%C (grad (V' m j) (r m t) (r j t)))).
      - rewrite (Sum_ext m (fun j => inner (pair_grad adj V' rt m j) (v m t - v j t)%C) (fun j => w adj m j * inner (v m t - v j t)%C (grad (V' m j) (r m t) (r j t)))) by (intros; apply P). ring.
      - intros i _. rewrite P, (grad_antisym (V' i m) (r m t) (r i t)), VS. unfold w. rewrite (S i m). rewrite !inner_xy. cbn. ring. }
    rewrite H. field. }
  split; [exact E|]. rewrite E. apply Sum_ext; intros i _; apply Sum_ext; intros j _. f_equal.
  rewrite (grad_antisym (V' i j) (r i t) (r j t)), !inner_xy. cbn. ring.
Qed.
(* eq (9): the energy's rate under the control (4) *)
Hypothesis HU : forall i, (i < n)%nat -> is_velocity (v i) t (control4 n adj V' rt vt i).
Lemma control_power : Sum n (fun i => inner (v i t) (grad_i n adj V' rt i)) + Sum n (fun i => inner (v i t) (control4 n adj V' rt vt i)) =
  - Sum n (fun i => inner (v i t) (row n (lap n adj) i vt)).
Proof.
  rewrite <- Sum_plus, <- Sum_opp. apply Sum_ext; intros i Hi. rewrite row_lap by assumption. unfold control4.
  rewrite !inner_xy. cbn. ring.
Qed.
Theorem eq9 : is_derive (fun s => Wenergy n adj V (fun i => r i s) (fun i => v i s)) t
  (- qform (2 * n) (kron2 (lap n adj)) (stack vt)) /\
  qform (2 * n) (kron2 (lap n adj)) (stack vt) = qform n (lap n adj) (fun i => fst (v i t)) + qform n (lap n adj) (fun i => snd (v i t)) /\
  0 <= qform (2 * n) (kron2 (lap n adj)) (stack vt).
Proof.
  pose proof (kron_split n (lap n adj) vt) as K. pose proof (form_split n (lap n adj) vt) as Fs. cbv beta in K, Fs. split; [|split].
  - eapply D_eq; [apply (energy_chain n (fun i j s => w adj i j * V i j (norm (r i s - r j s)%C)) (pair_grad adj V' rt) v
      (control4 n adj V' rt vt) t linked_rate (fun i j _ _ => pair_grad_antisym rt i j) HU)|].
    pose proof control_power as C0. unfold grad_i in C0. rewrite K, <- Fs, <- C0. reflexivity.
  - exact K.
  - rewrite K, <- Fs. exact (proj2 (lap_psd n adj vt S)).
Qed.
(* the total momentum is conserved *)
Theorem momentum : is_velocity (fun s => Csum n (fun i => v i s)) t (RtoC 0).
Proof.
  assert (E : Csum n (fun i => control4 n adj V' rt vt i) = RtoC 0).
  { unfold Csum at 1, RtoC. apply injective_projections; cbn [fst snd].
    - rewrite (Sum_ext n _ (fun i => Sum n (fun j => - (w adj i j * (fst (v i t) - fst (v j t)) + fst (pair_grad adj V' rt i j))))).
      + apply Sum_antisym. intros i j _ _. rewrite (pair_grad_antisym rt i j). unfold w. rewrite (S j i). cbn. ring.
      + intros i _. rewrite Sum_opp. unfold control4, grad_i, Csum, Cminus, Cplus, Copp; cbn [fst snd].
        rewrite <- Ropp_plus_distr, <- Sum_plus. f_equal. apply Sum_ext; intros j _. unfold Cmult, RtoC; cbn [fst snd]. ring.
    - rewrite (Sum_ext n _ (fun i => Sum n (fun j => - (w adj i j * (snd (v i t) - snd (v j t)) + snd (pair_grad adj V' rt i j))))).
      + apply Sum_antisym. intros i j _ _. rewrite (pair_grad_antisym rt i j). unfold w. rewrite (S j i). cbn. ring.
      + intros i _. rewrite Sum_opp. unfold control4, grad_i, Csum, Cminus, Cplus, Copp; cbn [fst snd].
        rewrite <- Ropp_plus_distr, <- Sum_plus. f_equal. apply Sum_ext; intros j _. unfold Cmult, RtoC; cbn [fst snd]. ring. }
  rewrite <- E. split.
  - apply (D_Sum n (fun i s => fst (v i s)) (fun i => fst (control4 n adj V' rt vt i))). intros; now apply HU.
  - apply (D_Sum n (fun i s => snd (v i s)) (fun i => snd (control4 n adj V' rt vt i))). intros; now apply HU.
Qed.
End Fixed.

(* ---- angular momentum (eq (6) of Part I): the pair forces drop out ---- *)
Definition cross (x y : C) : R := fst x * snd y - snd x * fst y.
Theorem pair_torque V' ri rj : cross (ri - rj)%C (grad V' ri rj) = 0.
Proof. unfold cross, grad. set (c := _ / _). cbn. ring. Qed.
Lemma cross_Csum n x f : cross x (Csum n f) = Sum n (fun j => cross x (f j)).
Proof. unfold cross, Csum; cbn [fst snd]. now rewrite <- !Sum_scal, <- Sum_minus. Qed.
Theorem tanner1_eq6 n adj V' r (a : nat -> C) : undirected adj -> (forall i j, V' i j = V' j i) ->
  Sum n (fun i => cross (r i) (- grad_i n adj V' r i + a i)%C) = Sum n (fun i => cross (r i) (a i)) /\
  Sum n (fun i => Sum n (fun j => w adj i j * cross (r i - r j)%C (grad (V' i j) (r i) (r j)))) = 0.
Proof.
  intros S VS. split.
  - assert (Z : Sum n (fun i => cross (r i) (grad_i n adj V' r i)) = 0).
    { unfold grad_i. rewrite (Sum_ext n _ (fun i => Sum n (fun j => cross (r i) (pair_grad adj V' r i j)))) by (intros; apply cross_Csum).
      apply Sum_antisym. intros i j _ _. rewrite (pair_grad_antisym adj V' S VS r i j).
      pose proof (pair_torque (V' i j) (r i) (r j)) as T. unfold pair_grad. set (g := grad _ _ _) in *. clearbody g.
      unfold cross, Cminus, Cplus, Copp, Cmult, RtoC in *; cbn [fst snd] in *.
      assert (H : fst (r i) * snd g - snd (r i) * fst g = fst (r j) * snd g - snd (r j) * fst g) by lra.
      transitivity (- (w adj i j * (fst (r j) * snd g - snd (r j) * fst g))); [ring|]. rewrite <- H. ring. }
    transitivity (Sum n (fun i => cross (r i) (a i)) - Sum n (fun i => cross (r i) (grad_i n adj V' r i))); [|rewrite Z; ring].
    rewrite <- Sum_minus. apply Sum_ext; intros i _. unfold cross. cbn. ring.
  - apply Sum_zero; intros i _; apply Sum_zero; intros j _. rewrite pair_torque. ring.
Qed.
