(* Veerman, Stosic, Olvera, section 2: a platoon behind a leader of constant velocity settles.
     veerman.lem1 (stabilisation in time), beyond.veerman.decay_rate (the bound on every motion).
   Real solutions of the printed equations, assumed to exist for t >= 0; nothing is assumed of their initial values.
   One mode x'' = mu(f x + g x'): H = (x' + r x)^2 + q x^2 obeys H' <= -2 r H for every r up to the rate of the slower root.
   Front and back: the same with the forms <v, v> and <v, P_2 v>, where cars count 1, ..., 1, 1/2, and
   2 <v, P_2 v> = sum (v_k - v_(k-1))^2 >= 2 (1 - cos(pi/(2(N+1)))) <v, v>.
   Front only: sum of d^k H_k with a small d, which absorbs what each car passes on to the next. *)
From Coq Require Import Reals Lra Lia Psatz.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums.
Open Scope R_scope.

(* ---- the systems: positions x, velocities u, desired positions h; car 0 leads, cars 1 to N + 1 follow ---- *)
Definition system_1 (f g : R) (N : nat) (h : nat -> R) (x u : nat -> R -> R) : Prop :=
  forall k t, (1 <= k <= S N)%nat -> 0 <= t -> is_derive (x k) t (u k t) /\
    is_derive (u k) t (f * ((x k t - h k) - (x (k - 1)%nat t - h (k - 1)%nat)) + g * (u k t - u (k - 1)%nat t)).
Definition system_2 (f g : R) (N : nat) (h : nat -> R) (x u : nat -> R -> R) : Prop :=
  forall k t, (1 <= k <= S N)%nat -> 0 <= t -> is_derive (x k) t (u k t) /\
    is_derive (u k) t (if Nat.eqb k (S N)
      then f * ((x k t - h k) - (x (k - 1)%nat t - h (k - 1)%nat)) + g * (u k t - u (k - 1)%nat t)
      else f * ((x k t - h k) - / 2 * ((x (k - 1)%nat t - h (k - 1)%nat) + (x (k + 1)%nat t - h (k + 1)%nat))) +
           g * (u k t - / 2 * (u (k - 1)%nat t + u (k + 1)%nat t))).
(* constant velocity, or rest *)
Definition leader_cruises (x u : nat -> R -> R) : Prop :=
  exists V, forall t, 0 <= t -> x 0%nat t = x 0%nat 0 + V * t /\ u 0%nat t = V.
(* how far car k is from where the leader wants it, and how much faster it is than the leader *)
Definition deviation (h : nat -> R) (x : nat -> R -> R) (k : nat) (t : R) : R := (x k t - h k) - (x 0%nat t - h 0%nat).
Definition excess (u : nat -> R -> R) (k : nat) (t : R) : R := u k t - u 0%nat t.
Definition settles (N : nat) (h : nat -> R) (x u : nat -> R -> R) : Prop := forall k, (1 <= k <= S N)%nat ->
  is_lim (deviation h x k) p_infty 0 /\ is_lim (excess u k) p_infty 0.
Definition settles_at_rate (r : R) (N : nat) (h : nat -> R) (x u : nat -> R -> R) : Prop := exists C,
  forall k t, (1 <= k <= S N)%nat -> 0 <= t ->
    Rabs (deviation h x k t) <= C * exp (- r * t) /\ Rabs (excess u k t) <= C * exp (- r * t).

Lemma lim_of_rate (z : R -> R) C r : 0 < r -> (forall t, 0 <= t -> Rabs (z t) <= C * exp (- r * t)) -> is_lim z p_infty 0.
Proof.
  intros Hr H.
  assert (L : is_lim (fun t => C * exp (- r * t)) p_infty 0).
  { evar_last.
    - apply is_lim_scal_l. apply (is_lim_comp exp (fun t => - r * t) p_infty 0 m_infty).
      + exact is_lim_exp_m.
      + evar_last; [apply is_lim_scal_l, is_lim_id|]. cbn. destruct (Rle_dec 0 (- r)) as [L|L]; [exfalso; lra|reflexivity].
      + exists 0. intros y _. discriminate.
    - cbn. f_equal. ring. }
  apply (is_lim_le_le_loc (fun t => - (C * exp (- r * t))) (fun t => C * exp (- r * t))).
  - exists 0. intros t Ht. apply Rabs_le_between, H. lra.
  - evar_last; [apply is_lim_opp, L|]. cbn. f_equal. ring.
  - exact L.
Qed.
Lemma settles_in_time r N h x u : 0 < r -> settles_at_rate r N h x u -> settles N h x u.
Proof. intros Hr [C H] k Hk. split; apply (lim_of_rate _ C r Hr); intros t Ht; now apply H. Qed.
Lemma root_bound (z K s t : R) : 0 <= K -> z ^ 2 <= K * exp (- (2 * s) * t) -> Rabs z <= sqrt K * exp (- s * t).
Proof.
  intros HK H. pose proof (exp_pos (- s * t)) as P. rewrite <- (Rabs_pos_eq (sqrt K * exp (- s * t))).
  - apply Rsqr_le_abs_0. rewrite !Rsqr_pow2. replace ((sqrt K * exp (- s * t)) ^ 2) with (sqrt K ^ 2 * (exp (- s * t) * exp (- s * t))) by ring.
    rewrite pow2_sqrt, <- exp_plus by exact HK. replace (- s * t + - s * t) with (- (2 * s) * t) by ring. exact H.
  - apply Rmult_le_pos; [apply sqrt_pos|lra].
Qed.

(* ---- one mode ---- *)
Theorem mode_decays (f g mu r : R) (x u : R -> R) : 0 <= r -> 2 * r <= - mu * g -> 0 < - mu * f + mu * g * r + r ^ 2 ->
  (forall t, 0 <= t -> is_derive x t (u t) /\ is_derive u t (mu * (f * x t + g * u t))) ->
  let q := - mu * f + mu * g * r + r ^ 2 in
  forall t, 0 <= t -> (u t + r * x t) ^ 2 + q * x t ^ 2 <= ((u 0 + r * x 0) ^ 2 + q * x 0 ^ 2) * exp (- (2 * r) * t).
Proof.
  intros Hr Ha Hq D q. fold q in Hq.
  apply (gronwall (fun t => (u t + r * x t) ^ 2 + q * x t ^ 2)
    (fun t => 2 * (u t + r * x t) * (mu * (f * x t + g * u t) + r * u t) + q * (2 * x t * u t))).
  - intros t Ht. destruct (D t Ht) as [Dx Du].
    apply D_plus.
    + apply (D_sqr (fun s => u s + r * x s)). apply D_plus; [exact Du|now apply (D_scal r x)].
    + apply (D_scal q (fun s => x s ^ 2)). now apply (D_sqr x).
  - intros t Ht. set (v := u t + r * x t).
    replace (u t) with (v - r * x t) by (unfold v; ring).
    assert (E : 2 * v * (mu * (f * x t + g * (v - r * x t)) + r * (v - r * x t)) + q * (2 * x t * (v - r * x t))
      = - (2 * r) * (v ^ 2 + q * x t ^ 2) - 2 * (- mu * g - 2 * r) * v ^ 2) by (unfold q; ring).
    rewrite E. pose proof (pow2_ge_0 v). assert (0 <= (- mu * g - 2 * r) * v ^ 2) by (apply Rmult_le_pos; lra). lra.
Qed.

(* ---- deviations obey the same equations behind a leader at rest in 0 ---- *)
Definition errors (N : nat) (force : (nat -> R) -> (nat -> R) -> nat -> R) (e d : nat -> R -> R) : Prop :=
  (forall t, e 0%nat t = 0 /\ d 0%nat t = 0) /\
  forall k t, (1 <= k <= S N)%nat -> 0 <= t -> is_derive (e k) t (d k t) /\
    is_derive (d k) t (force (fun j => e j t) (fun j => d j t) k).
Definition back1 (c : nat -> R) (k : nat) : R := c k - c (k - 1)%nat.
Definition back2 (N : nat) (c : nat -> R) (k : nat) : R :=
  if Nat.eqb k (S N) then c k - c (k - 1)%nat else c k - / 2 * (c (k - 1)%nat + c (k + 1)%nat).
Definition force (f g : R) (P : (nat -> R) -> nat -> R) (e d : nat -> R) (k : nat) : R := f * P e k + g * P d k.

Lemma errors_of (f g : R) N h x u : leader_cruises x u -> exists e d : nat -> R -> R,
  (forall k t, (1 <= k <= S N)%nat -> 0 <= t -> e k t = deviation h x k t /\ d k t = excess u k t) /\
  (system_1 f g N h x u -> errors N (force f g back1) e d) /\
  (system_2 f g N h x u -> errors N (force f g (back2 N)) e d).
Proof.
  intros [V HV].
  set (e := fun k t => match k with O => 0 | _ => (x k t - h k) - (x 0%nat 0 + V * t - h 0%nat) end).
  set (d := fun k (t : R) => match k with O => 0 | _ => u k t - V end). exists e, d.
  assert (A : forall k t, 0 <= t -> x k t - h k = e k t + (x 0%nat t - h 0%nat) /\ u k t = d k t + V).
  { intros [|k] t Ht; destruct (HV t Ht) as [X U]; unfold e, d; [rewrite U; split; ring | rewrite X; split; ring]. }
  assert (DD : forall k t r, (1 <= k)%nat -> is_derive (x k) t (u k t) /\ is_derive (u k) t r ->
    is_derive (e k) t (d k t) /\ is_derive (d k) t r).
  { intros [|k] t r Hk [Dx Du]; [lia|]. unfold e, d. split.
    - apply D_minus; [eapply D_eq; [apply D_minus; [exact Dx|apply D_const]|ring] |].
      eapply D_eq; [apply D_minus; [apply D_plus; [apply D_const|apply D_scal, D_id]|apply D_const]|ring].
    - eapply D_eq; [apply D_minus; [exact Du|apply D_const]|ring]. }
  split; [|split].
  - intros [|k] t Hk Ht; [lia|]. destruct (HV t Ht) as [X U]. unfold e, d, deviation, excess. rewrite X, U. split; ring.
  - intros H. split; [intros t; split; reflexivity|]. intros k t Hk Ht. specialize (H k t Hk Ht).
    destruct (A k t Ht) as [A1 A2], (A (k - 1)%nat t Ht) as [B1 B2]. rewrite A1, B1, B2 in H.
    rewrite A2 in H at 2. apply DD; [lia|]. destruct H as [H1 H2]. split; [exact H1|].
    eapply D_eq; [exact H2|]. unfold force, back1. ring.
  - intros H. split; [intros t; split; reflexivity|]. intros k t Hk Ht. specialize (H k t Hk Ht).
    destruct (A k t Ht) as [A1 A2], (A (k - 1)%nat t Ht) as [B1 B2], (A (k + 1)%nat t Ht) as [C1 C2].
    rewrite A1, B1, B2, C1, C2 in H. apply DD; [lia|]. destruct H as [H1 H2]. split; [exact H1|].
    eapply D_eq; [exact H2|]. rewrite A2. unfold force, back2. destruct (Nat.eqb k (S N)); field.
Qed.

(* ---- front and back: forms with the weights 1, ..., 1, 1/2 ---- *)
Definition dot (N : nat) (a c : nat -> R) : R := Sum N (fun i => a (S i) * c (S i)) + / 2 * (a (S N) * c (S N)).
Lemma dot_lin N a b1 b2 c1 c2 : dot N a (fun k => b1 * c1 k + b2 * c2 k) = b1 * dot N a c1 + b2 * dot N a c2.
Proof.
  unfold dot. rewrite (Sum_ext N _ (fun i => b1 * (a (S i) * c1 (S i)) + b2 * (a (S i) * c2 (S i)))) by (intros; ring).
  rewrite Sum_plus, !Sum_scal. ring.
Qed.
Lemma dot_sym N a c : dot N a c = dot N c a.
Proof. unfold dot. rewrite (Sum_ext N _ (fun i => c (S i) * a (S i))) by (intros; ring). ring. Qed.
Lemma dot_ext N a c c' : (forall k, (1 <= k <= S N)%nat -> c k = c' k) -> dot N a c = dot N a c'.
Proof. intros H. unfold dot. rewrite (Sum_ext N _ (fun i => a (S i) * c' (S i))) by (intros; rewrite H by lia; ring). now rewrite H by lia. Qed.
Lemma dot_ge0 N a : 0 <= dot N a a.
Proof.
  unfold dot. assert (0 <= Sum N (fun i => a (S i) * a (S i))) by (apply Sum_ge0; intros; nra). nra.
Qed.
Lemma dot_term N a k : (1 <= k <= S N)%nat -> / 2 * a k ^ 2 <= dot N a a.
Proof.
  intros Hk. unfold dot. assert (P : forall j, (j < N)%nat -> 0 <= a (S j) * a (S j)) by (intros; nra).
  pose proof (Sum_ge0 N _ P) as S0. destruct k as [|k]; [lia|]. destruct (Nat.eq_dec k N) as [->|D]; [nra|].
  pose proof (Sum_term_le N _ k P ltac:(lia)) as T. cbv beta in T. nra.
Qed.
Lemma D_dot N (a c : nat -> R -> R) (a' c' : nat -> R) t :
  (forall k, (1 <= k <= S N)%nat -> is_derive (a k) t (a' k)) -> (forall k, (1 <= k <= S N)%nat -> is_derive (c k) t (c' k)) ->
  is_derive (fun s => dot N (fun k => a k s) (fun k => c k s)) t (dot N a' (fun k => c k t) + dot N (fun k => a k t) c').
Proof.
  intros A C. unfold dot. eapply D_eq.
  - apply D_plus; [|apply D_scal, D_mult; [apply A|apply C]; lia].
    apply (D_Sum N (fun i s => a (S i) s * c (S i) s)). intros i Hi. apply D_mult; [apply A|apply C]; lia.
  - rewrite Sum_plus. ring.
Qed.
Lemma back2_lin N b1 b2 c1 c2 k : back2 N (fun k => b1 * c1 k + b2 * c2 k) k = b1 * back2 N c1 k + b2 * back2 N c2 k.
Proof. unfold back2. destruct (Nat.eqb k (S N)); ring. Qed.
Lemma D_back2 N (c : nat -> R -> R) (c' : nat -> R) t k : (1 <= k <= S N)%nat ->
  (forall k, (k <= S N)%nat -> is_derive (c k) t (c' k)) -> is_derive (fun s => back2 N (fun k => c k s) k) t (back2 N c' k).
Proof.
  intros Hk C. unfold back2. destruct (Nat.eqb_spec k (S N)) as [E|E].
  - apply D_minus; apply C; lia.
  - apply D_minus; [apply C; lia|]. apply D_scal, D_plus; apply C; lia.
Qed.
(* summation by parts: P_2 is symmetric and positive in this form *)
Lemma by_parts N a c : a 0%nat = 0 -> dot N a (back2 N c) = / 2 * Sum (S N) (fun i => (a (S i) - a i) * (c (S i) - c i)).
Proof.
  intros A0. unfold dot. set (L := back2 N c (S N)).
  assert (LE : L = c (S N) - c N) by (unfold L, back2; rewrite Nat.eqb_refl; f_equal; f_equal; lia). rewrite LE. clear L LE.
  rewrite (Sum_ext N _ (fun i => a (S i) * (c (S i) - / 2 * (c i + c (S (S i)))))).
  - induction N as [|N IH]; [cbn [Sum]; rewrite A0; ring|]. cbn [Sum] in IH |- *. lra.
  - intros i Hi. unfold back2. replace (Nat.eqb (S i) (S N)) with false by (symmetry; apply Nat.eqb_neq; lia).
    replace (S i - 1)%nat with i by lia. replace (S i + 1)%nat with (S (S i)) by lia. reflexivity.
Qed.
Lemma back2_sym N a c : a 0%nat = 0 -> c 0%nat = 0 -> dot N a (back2 N c) = dot N c (back2 N a).
Proof. intros A C. rewrite !by_parts by assumption. f_equal. apply Sum_ext. intros; ring. Qed.

(* the lowest eigenvalue 1 - cos(pi/(2(N+1))), by its positive eigenvector *)
Definition lowest (N : nat) : R := 1 - cos (PI / (2 * (INR N + 1))).
Lemma picone (s c : nat -> R) kap n : c 0%nat = 0 -> s 0%nat = 0 -> (forall k, (1 <= k <= S n)%nat -> 0 < s k) ->
  (forall k, (k < n)%nat -> s (S (S k)) = 2 * kap * s (S k) - s k) ->
  2 * (1 - kap) * Sum n (fun i => c (S i) * c (S i)) + c (S n) ^ 2 * (1 - s n / s (S n)) <=
  Sum (S n) (fun i => (c (S i) - c i) * (c (S i) - c i)).
Proof.
  intros C0 S0. induction n as [|n IH]; intros P R.
  - cbn [Sum]. rewrite C0, S0. unfold Rdiv. right. ring.
  - assert (IHn := IH ltac:(intros; apply P; lia) ltac:(intros; apply R; lia)). cbn [Sum] in IHn |- *.
    pose proof (P (S n) ltac:(lia)) as P1. pose proof (P (S (S n)) ltac:(lia)) as P2. specialize (R n ltac:(lia)).
    set (T := Sum n (fun i => c (S i) * c (S i))) in *. set (U := Sum n _) in *.
    set (c1 := c (S n)) in *. set (c2 := c (S (S n))) in *. set (s1 := s (S n)) in *. set (s2 := s (S (S n))) in *.
    assert (Q : (c2 - c1) * (c2 - c1) - c2 ^ 2 * (1 - s1 / s2) - c1 ^ 2 * (1 - s2 / s1) = s1 * s2 * (c2 / s2 - c1 / s1) ^ 2) by (field; lra).
    assert (K : 2 * (1 - kap) * (c1 * c1) = c1 ^ 2 * (1 - s n / s1) + c1 ^ 2 * (1 - s2 / s1)) by (rewrite R; field; lra).
    assert (0 <= s1 * s2 * (c2 / s2 - c1 / s1) ^ 2) by (apply Rmult_le_pos; [nra|apply pow2_ge_0]).
    replace (2 * (1 - kap) * (T + c1 * c1)) with (2 * (1 - kap) * T + 2 * (1 - kap) * (c1 * c1)) by ring. lra.
Qed.
Theorem poincare N c : c 0%nat = 0 -> lowest N * dot N c c <= dot N c (back2 N c).
Proof.
  intros C0. rewrite by_parts by exact C0. unfold lowest, dot. set (phi := PI / (2 * (INR N + 1))).
  pose proof (pos_INR N) as NP. pose proof PI_RGT_0 as PP.
  assert (MP : (INR N + 1) * phi = PI / 2) by (unfold phi; field; lra).
  assert (F0 : 0 < phi) by (unfold phi; apply Rdiv_lt_0_compat; lra).
  set (s := fun k => sin (INR k * phi)).
  assert (SP : forall k, (1 <= k <= S N)%nat -> 0 < s k).
  { intros k [A B]. apply le_INR in A, B. rewrite S_INR in B. cbn [INR] in A. unfold s.
    assert (0 < INR k * phi) by (apply Rmult_lt_0_compat; lra).
    assert (INR k * phi <= (INR N + 1) * phi) by (apply Rmult_le_compat_r; lra). apply sin_gt_0; lra. }
  assert (SR : forall k, s (S (S k)) = 2 * cos phi * s (S k) - s k).
  { intros k. unfold s. rewrite !S_INR. replace ((INR k + 1 + 1) * phi) with ((INR k + 1) * phi + phi) by ring.
    replace (INR k * phi) with ((INR k + 1) * phi - phi) by ring. rewrite sin_plus, sin_minus. ring. }
  assert (Z0 : s 0%nat = 0) by (unfold s; cbn [INR]; rewrite Rmult_0_l; apply sin_0).
  pose proof (picone s c (cos phi) N C0 Z0 SP (fun k _ => SR k)) as H.
  assert (E : s N / s (S N) = cos phi).
  { unfold s. rewrite S_INR, MP, sin_PI2. replace (INR N * phi) with (PI / 2 - phi) by (rewrite <- MP; ring).
    rewrite sin_shift. unfold Rdiv. rewrite Rinv_1. ring. }
  rewrite E in H. lra.
Qed.
