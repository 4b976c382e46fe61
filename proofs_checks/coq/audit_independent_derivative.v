(* tanner2.eq13, stated again from its words after the theorems had been seen. Q of (11), the potentials, K of the whole vector field and the solutions of (10) are those of
   audit_independent_tanner2; the generalised gradient is Clarke's (the convex hull of the limits of gradients at near states where Q has one), the generalised time derivative that of (A.2),
   v^T L v is written by entries of L. Were the generalised gradient empty, eq13_2 would be false. *)
From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums paley_model paley_phase.
From Flockproof Require tanner2_energies tanner2_facts tanner2_filippov tanner2_limits tanner2_motion tanner_energy audit_independent_tanner2.
Module T := audit_independent_tanner2.
Open Scope R_scope.

Definition dot (x y : C) : R := fst x * fst y + snd x * snd y.
Definition closer n (q r : nat -> C) (e : R) := forall i, (i < n)%nat -> Cmod (q i - r i)%C < e.
(* E is differentiable at the state (r, v), with the gradients a i in r_i and b i in v_i *)
Definition differentiable n (E : (nat -> C) -> (nat -> C) -> R) (r v a b : nat -> C) := forall e, 0 < e -> exists d, 0 < d /\ forall q u, closer n q r d -> closer n u v d ->
  Rabs (E q u - E r v - Sum n (fun i => dot (a i) (q i - r i)%C + dot (b i) (u i - v i)%C)) <= e * Sum n (fun i => Cmod (q i - r i)%C + Cmod (u i - v i)%C).
Definition limit_gradient n E (r v a b : nat -> C) := forall e, 0 < e -> exists q u a' b', closer n q r e /\ closer n u v e /\ differentiable n E q u a' b' /\ closer n a' a e /\ closer n b' b e.
Definition convex (m : nat) (c : nat -> R) := (forall k, (k < m)%nat -> 0 <= c k) /\ Sum m c = 1.
Definition clarke n E (r v a b : nat -> C) := exists m c (y z : nat -> nat -> C), convex m c /\ (forall k, (k < m)%nat -> limit_gradient n E r v (y k) (z k)) /\
  forall i, (i < n)%nat -> a i = Csum m (fun k => RtoC (c k) * y k i)%C /\ b i = Csum m (fun k => RtoC (c k) * z k i)%C.
(* (A.2): what xi . f is for every xi of the generalised gradient, with some f of K[(v, u)]; f may be another one for each xi *)
Definition time_derivative n V V' R0 (r v : nat -> C) (x : R) := forall a b, clarke n (T.energy11 n V R0) r v a b ->
  exists z, T.K10 n V' R0 r v z /\ x = Sum n (fun i => dot (a i) (v i) + dot (b i) (z i)).
(* the networks at near states where no pair is at the distance R; v_x^T L v_x + v_y^T L v_y by the entries of L *)
Definition near_network n R0 (r : nat -> C) (g : nat -> nat -> bool) := forall e, 0 < e -> exists q, closer n q r e /\
  (forall i j, (i < n)%nat -> (j < n)%nat -> i <> j -> Cmod (q i - q j)%C <> R0) /\
  forall i j, (i < n)%nat -> (j < n)%nat -> g i j = true <-> i <> j /\ Cmod (q i - q j)%C < R0.
Definition entry n (g : nat -> nat -> bool) (i j : nat) : R := if Nat.eqb i j then Sum n (fun l => if g i l then 1 else 0) else if g i j then -1 else 0.
Definition form n g (x : nat -> R) : R := Sum n (fun i => Sum n (fun j => x i * entry n g i j * x j)).
Definition right_side n R0 (r v : nat -> C) (x : R) := exists m c (g : nat -> nat -> nat -> bool), convex m c /\ (forall k, (k < m)%nat -> near_network n R0 r (g k)) /\
  x = - Sum m (fun k => c k * (form n (g k) (fun i => fst (v i)) + form n (g k) (fun i => snd (v i)))).
Definition eq13_1 : Prop := forall n V V' R0 r v x, 0 < R0 -> T.potentials n complete V V' -> T.apart_at n complete r ->
  time_derivative n V V' R0 r v x -> right_side n R0 r v x.
Definition eq13_2 : Prop := forall n V V' R0 r v x, 0 < R0 -> T.potentials n complete V V' -> T.apart_at n complete r ->
  time_derivative n V V' R0 r v x -> x <= 0.
Definition eq13_3 : Prop := forall n V V' R0 r v T, 0 < R0 -> T.potentials n complete V V' -> T.motion10_until T n V' R0 r v -> forall s t, 0 <= s <= t -> t < T ->
  T.energy11 n V R0 (fun i => r i t) (fun i => v i t) <= T.energy11 n V R0 (fun i => r i s) (fun i => v i s).

(* ---- and the theorems prove these ---- *)
Module E := tanner2_energies.
Lemma dot_is x y : dot x y = inner x y.
Proof. now rewrite inner_xy. Qed.
Lemma complete_of i j : i <> j -> complete i j = true.
Proof. intros N. unfold complete. now destruct (Nat.eqb_spec i j). Qed.
(* Q where no pair is at R *)
Lemma gradient_is n V V' R0 q u : T.potentials n complete V V' -> T.apart_at n complete q -> tanner2_limits.generic n R0 q ->
  differentiable n (T.energy11 n V R0) q u (T.gradV n (T.by_distance q R0) V' q) u.
Proof.
  intros P A G e He. pose proof (T.slopes_of n complete V V' P) as D. destruct P as [VS P].
  assert (Db : forall i j s, (i < n)%nat -> (j < n)%nat -> i <> j -> 0 < s -> is_derive (tanner2_filippov.both V i j) s (tanner2_filippov.both V' i j s)).
  { intros i j s Hi Hj N Hs. apply T.both_derive; [exact VS| |]; apply D; try assumption; apply complete_of; auto. }
  destruct (E.Q_gradient n (tanner2_filippov.both V) (tanner2_filippov.both V') R0 q u (tanner2_filippov.both_sym V) (tanner2_filippov.both_sym V') Db A G e He) as (d & Hd & K).
  exists d. split; [exact Hd|]. intros q2 u2 Cq Cu. specialize (K (fun i => q2 i - q i)%C (fun i => u2 i - u i)%C (fun i Hi => conj (Cq i Hi) (Cu i Hi))).
  assert (En : forall a b, T.energy11 n V R0 a b = tanner2_facts.Qsat n (tanner2_filippov.both V) R0 a b).
  { intros a b. rewrite <- T.energy11_is. unfold T.energy11. f_equal. apply Sum_ext. intros i _. f_equal. apply Sum_ext. intros j _. unfold T.saturate. now rewrite !(T.both_V V) by exact VS. }
  rewrite !En. replace (tanner2_facts.Qsat n (tanner2_filippov.both V) R0 q2 u2) with
    (tanner2_facts.Qsat n (tanner2_filippov.both V) R0 (fun i => q i + (q2 i - q i))%C (fun i => u i + (u2 i - u i))%C).
  2: { unfold tanner2_facts.Qsat, tanner2_facts.sat_pair. f_equal. apply Sum_ext. intros i _. f_equal; [|f_equal; ring].
       apply Sum_ext. intros j _. destruct (Nat.eqb i j); [reflexivity|]. do 2 f_equal. ring. }
  rewrite (Sum_ext n (fun i => dot _ _ + _) (fun i => inner (tanner_energy.grad_i n (tanner2_facts.near q R0) (tanner2_filippov.both V') q i) (q2 i - q i)%C + inner (u i) (u2 i - u i)%C)); [exact K|].
  intros i Hi. rewrite !dot_is. f_equal. f_equal.
  destruct (T.both_law n (T.by_distance q R0) V V' q u i) as (_ & <- & _); try assumption.
  - apply tanner2_filippov.by_distance_simple.
  - intros k j s Hk Hj B Hs. apply D; try assumption. apply complete_of. intros ->. now rewrite (proj2 (tanner2_filippov.by_distance_simple q R0) j : T.by_distance q R0 j j = false) in B.
  - intros k j Hk Hj B. apply A; try assumption. apply complete_of. intros ->. now rewrite (proj2 (tanner2_filippov.by_distance_simple q R0) j : T.by_distance q R0 j j = false) in B.
  - rewrite T.gradV_is. apply Csum_ext. intros j _. unfold tanner_energy.pair_grad, w. now rewrite T.by_distance_is.
Qed.
Lemma stay_apart n (r : nat -> C) : T.apart_at n complete r -> exists d, 0 < d /\ forall q, closer n q r d -> T.apart_at n complete q.
Proof.
  intros A. destruct (tanner2_filippov.small2 n (fun i j d => complete i j = true -> forall q : nat -> C, Cmod (q i - r i)%C < d -> Cmod (q j - r j)%C < d -> q i <> q j)) as (d & Hd & K).
  - intros i j d d' H L Cm q H1 H2. apply (H Cm); lra.
  - intros i j Hi Hj. destruct (complete i j) eqn:Cm; [|exists 1; split; [lra|discriminate]]. pose proof (A i j Hi Hj Cm) as N.
    assert (P : 0 < Cmod (r i - r j)%C) by (apply tanner_flock.norm_neq; exact N). exists (Cmod (r i - r j)%C / 2). split; [lra|]. intros _ q H1 H2 E.
    assert (L : Cmod (r i - r j)%C <= Cmod (q i - r i)%C + Cmod (q j - r j)%C).
    { replace (r i - r j)%C with ((q j - r j) - (q i - r i))%C by (rewrite E; ring). rewrite Rplus_comm. apply E.norm_sub. }
    lra.
  - exists d. split; [exact Hd|]. intros q H i j Hi Hj Cm. apply (K i j Hi Hj Cm q); now apply H.
Qed.
Lemma limits_are n V V' R0 r v y z : T.potentials n complete V V' -> T.apart_at n complete r -> E.limit_of_gradient n V' R0 r v y z -> limit_gradient n (T.energy11 n V R0) r v y z.
Proof.
  intros P A L e He. destruct (stay_apart n r A) as (d & Hd & K). destruct (L (Rmin e d) ltac:(now apply Rmin_glb_lt)) as (q & u & B & G & F). pose proof (Rmin_l e d). pose proof (Rmin_r e d).
  exists q, u, (T.gradV n (T.by_distance q R0) V' q), u. split; [intros i Hi; destruct (B i Hi); lra|]. split; [intros i Hi; destruct (B i Hi); lra|].
  split; [|split; intros i Hi; destruct (F i Hi) as [F1 F2]].
  - apply gradient_is; try assumption. apply K. intros i Hi. destruct (B i Hi). lra.
  - eapply Rlt_le_trans; [exact F1|assumption].
  - eapply Rlt_le_trans; [exact F2|assumption].
Qed.
Lemma derivative_is n V V' R0 r v x : T.potentials n complete V V' -> T.apart_at n complete r -> time_derivative n V V' R0 r v x -> E.derivative_Q n V' R0 r v x.
Proof.
  intros P A H a b (m & c & y & z & L & S1 & Eq). destruct (H a b) as (f & Kf & ->).
  - exists m, c, y, z. split; [split; [intros k Hk; now apply L|exact S1]|]. split; [|exact Eq]. intros k Hk. apply (limits_are n V V'); try assumption. now apply L.
  - exists f. split; [exact Kf|]. apply Sum_ext. intros i _. now rewrite !dot_is.
Qed.
Lemma form_is n g v : (forall i, (i < n)%nat -> g i i = false) -> form n g (fun i => fst (v i)) + form n g (fun i => snd (v i)) = E.disagreement n v g.
Proof.
  intros N. assert (F : forall x : nat -> R, form n g x = Sum n (fun i => x i * Sum n (fun j => if g i j then x i - x j else 0))).
  { intros x. apply Sum_ext. intros i Hi. rewrite (Sum_ext n (fun j => if g i j then x i - x j else 0) (fun j => (if g i j then 1 else 0) * x i - (if g i j then x j else 0))) by (intros j _; destruct (g i j); ring).
    rewrite Sum_minus, Sum_scal_r, Rmult_minus_distr_l. rewrite (Sum_ext n _ (fun j => delta i j * (x i * (Sum n (fun l => if g i l then 1 else 0) * x j)) - x i * (if g i j then x j else 0))).
    - rewrite Sum_minus, Sum_scal. rewrite (Sum_delta_l n i (fun j => x i * (Sum n (fun l => if g i l then 1 else 0) * x j)) Hi). ring.
    - intros j Hj. unfold entry, delta. destruct (Nat.eqb_spec i j) as [<-|]; [rewrite (N i Hi); ring|destruct (g i j); ring]. }
  rewrite !F, <- Sum_plus. apply Sum_ext. intros i _. rewrite inner_xy. unfold Csum. cbn [fst snd]. f_equal; f_equal; apply Sum_ext; intros j _; destruct (g i j); cbn; ring.
Qed.
Lemma network_is n R0 r g : tanner2_limits.occurs n R0 r g -> near_network n R0 r g.
Proof.
  intros O e He. destruct (O e He) as (q & Q1 & Q2 & Q3). exists q. split; [exact Q1|]. split; [exact Q2|]. intros i j Hi Hj. rewrite (Q3 i j Hi Hj). unfold tanner2_filippov.by_distance.
  destruct (Nat.eqb_spec i j) as [E|N], (Rlt_dec (Cmod (q i - q j)%C) R0); cbn; split; intros; try discriminate; tauto.
Qed.
Theorem eq13_1_proved : eq13_1.
Proof.
  intros n V V' R0 r v x HR P A H. destruct (E.eq13 n V V' R0 r v HR P A x (derivative_is n V V' R0 r v x P A H)) as (m & c & g & G & S1 & Eq).
  exists m, c, g. split; [split; [intros k Hk; now apply G|exact S1]|]. split; [intros k Hk; now apply network_is, G|].
  rewrite (Sum_ext m _ (fun k => c k * E.disagreement n v (g k))); [lra|]. intros k Hk. f_equal. apply form_is. intros i Hi.
  destruct (network_is n R0 r (g k) (proj2 (G k Hk)) 1 Rlt_0_1) as (q & _ & _ & B). destruct (g k i i) eqn:L; [|reflexivity]. destruct (proj1 (B i i Hi Hi) L) as [N _]. now contradiction N.
Qed.
Theorem eq13_2_proved : eq13_2.
Proof. intros n V V' R0 r v x HR P A H. exact (E.eq13_negative n V V' R0 r v HR P A x (derivative_is n V V' R0 r v x P A H)). Qed.
Theorem eq13_3_proved : eq13_3.
Proof. intros n V V' R0 r v T0 HR P M s t Hs Ht. rewrite !T.energy11_is. exact (E.Q_falls n V V' R0 r v T0 HR P M s t Hs Ht). Qed.
