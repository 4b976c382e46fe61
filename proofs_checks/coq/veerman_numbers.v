(* Veerman, Stosic, Olvera, sections 5 to 7: numbers, by enclosures in the kernel.
     veerman.sec7.omega0, table1_theory, table1.size, table1_numeric, thm1_x (the power), onlytwo,
     nth_neighbour. *)
From Coq Require Import Reals Lra Lia Psatz List.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import veerman_complex veerman_front veerman_chain IntervalStdZ.
Import ListNotations.
Open Scope R_scope.

(* Theorem 1: frequency and size of the main resonance to second order, M = N + 1 followers *)
Definition frequency (f : R) (M : R) : R := sqrt (Rabs f) * PI / (M * 2 * sqrt 2).
Definition amplitude (f g : R) (M : R) : R := 8 * sqrt (2 * Rabs f) / (PI ^ 2 * Rabs g) * M.

(* veerman.sec7.omega0 *)
Theorem omega_0 N : frequency (-1) (INR (N + 1)) = PI * sqrt 2 / (4 * (INR (N + 1))).
Proof.
  unfold frequency. rewrite Rabs_left by lra. replace (- -1) with 1 by lra. rewrite sqrt_1.
  assert (P : 0 < INR (N + 1)) by (apply lt_0_INR; lia).
  assert (S : sqrt 2 * sqrt 2 = 2) by (apply sqrt_sqrt; lra).
  assert (S0 : 0 < sqrt 2) by (apply sqrt_lt_R0; lra).
  replace (4 * INR (N + 1)) with (2 * INR (N + 1) * (sqrt 2 * sqrt 2)) by (rewrite S; ring).
  field. split; lra.
Qed.

(* f = g = -1 *)
Lemma frequency_unit M : frequency (-1) M = PI / (M * 2 * sqrt 2).
Proof. unfold frequency. rewrite Rabs_left by lra. replace (- -1) with 1 by lra. rewrite sqrt_1. f_equal. ring. Qed.
Lemma amplitude_unit M : amplitude (-1) (-1) M = 8 * sqrt 2 / PI ^ 2 * M.
Proof.
  unfold amplitude. rewrite Rabs_left by lra. replace (- -1) with 1 by ring.
  rewrite !Rmult_1_r. reflexivity.
Qed.

(* the printed cells: N, NFREQ, NAMP, TFREQ, TAMP, each pair with one unit of its last digit *)
Definition cell : Type := (R * R)%type.
Definition table : list (R * cell * cell * cell * cell) :=
  [ (4, (0.2776801836, 1e-10), (4.58527335, 1e-8), (0.2727291, 1e-7), (4.49064609, 1e-8));
    (8, (0.1388400918, 1e-10), (9.17054669, 1e-8), (0.1382221, 1e-7), (9.11739657, 1e-8));
    (16, (0.0694200459, 1e-10), (18.34109338, 1e-8), (0.06934994, 1e-8), (18.3135253, 1e-7));
    (32, (0.0347100229, 1e-10), (36.68218677, 1e-8), (0.03470038, 1e-8), (36.6683866, 1e-7));
    (64, (0.0173550115, 1e-10), (73.36437354, 1e-8), (0.017353935, 1e-9), (73.3562112, 1e-7));
    (128, (0.0086775057, 1e-10), (146.72874707, 1e-8), (0.008677381, 1e-9), (146.7227220, 1e-7)) ].
Definition agrees (c : cell) (x : R) : Prop := Rabs (fst c - x) <= snd c.

(* veerman.table1_theory, corrected: NFREQ and NAMP are Theorem 1 with N followers *)
Theorem table_theory : List.Forall (fun r => match r with (N, nf, na, tf, ta) =>
  agrees nf (frequency (-1) N) /\ agrees na (amplitude (-1) (-1) N) end) table.
Proof.
  repeat apply List.Forall_cons; try apply List.Forall_nil; unfold agrees; cbn [fst snd];
  rewrite frequency_unit, amplitude_unit; split; interval with (i_prec 60).
Qed.
(* as printed: no cell of TFREQ, TAMP is Theorem 1, for N + 1 followers or for N *)
Theorem table_theory_printed_fails : List.Forall (fun r => match r with (N, nf, na, tf, ta) =>
  ~ agrees tf (frequency (-1) (N + 1)) /\ ~ agrees ta (amplitude (-1) (-1) (N + 1)) /\
  ~ agrees tf (frequency (-1) N) /\ ~ agrees ta (amplitude (-1) (-1) N) end) table.
Proof.
  assert (K : forall c x, snd c < Rabs (fst c - x) -> ~ agrees c x) by (unfold agrees; intros; lra).
  repeat apply List.Forall_cons; try apply List.Forall_nil; rewrite !frequency_unit, !amplitude_unit;
  repeat split; apply K; cbn [fst snd]; interval with (i_prec 60).
Qed.
(* veerman.table1.size: with N + 1 followers no cell of NFREQ, NAMP agrees *)
Theorem table_size_printed_fails : List.Forall (fun r => match r with (N, nf, na, tf, ta) =>
  ~ agrees nf (frequency (-1) (N + 1)) /\ ~ agrees na (amplitude (-1) (-1) (N + 1)) end) table.
Proof.
  assert (K : forall c x, snd c < Rabs (fst c - x) -> ~ agrees c x) by (unfold agrees; intros; lra).
  repeat apply List.Forall_cons; try apply List.Forall_nil; rewrite !frequency_unit, !amplitude_unit;
  repeat split; apply K; cbn [fst snd]; interval with (i_prec 60).
Qed.

(* ---- a flock that answers more than the printed "resonance": f = g = -1, 4 or 5 followers ---- *)
Definition cx (w : R) : R := 1 / (1 + w ^ 2).
Definition cz (w : R) : R := w ^ 3 / (1 + w ^ 2).
Lemma gamma_unit w : gamma (-1) (-1) w = (cx w, cz w).
Proof.
  unfold gamma, num, den, cx, cz, Cdiv, Cinv, Cmult; cbn [fst snd].
  apply injective_projections; cbn [fst snd]; field; nra.
Qed.
(* real and imaginary parts of T_4 and T_5 at x + i z *)
Definition re4 (x z : R) : R := 8 * ((x^2 - z^2)^2 - (2*x*z)^2) - 8 * (x^2 - z^2) + 1.
Definition im4 (x z : R) : R := 16 * (x^2 - z^2) * (2*x*z) - 8 * (2*x*z).
Definition re3 (x z : R) : R := 4 * (x ^ 3 - 3 * x * z ^ 2) - 3 * x.
Definition im3 (x z : R) : R := 4 * (3 * x ^ 2 * z - z ^ 3) - 3 * z.
Definition re5 (x z : R) : R := 2 * (x * re4 x z - z * im4 x z) - re3 x z.
Definition im5 (x z : R) : R := 2 * (x * im4 x z + z * re4 x z) - im3 x z.
Lemma chain4 (a : nat -> C) g : a 0%nat = RtoC 1 -> chain g 3 a -> (a 4%nat * (re4 (fst g) (snd g), im4 (fst g) (snd g)) = 1)%C.
Proof.
  intros A0 [H E3]. pose proof (f_equal snd (H 3%nat ltac:(lia))) as H3. pose proof (f_equal snd (H 2%nat ltac:(lia))) as H2.
  pose proof (f_equal snd (H 1%nat ltac:(lia))) as H1. cbn in E3.
  change (a 4%nat = (2 * g * a 3%nat - a 2%nat)%C) in H3. change (a 3%nat = (2 * g * a 2%nat - a 1%nat)%C) in H2.
  change (a 2%nat = (2 * g * a 1%nat - a 0%nat)%C) in H1.
  assert (E2 : a 2%nat = (2 * g * a 3%nat - a 4%nat)%C) by (rewrite H3; ring).
  assert (E1 : a 1%nat = (2 * g * a 2%nat - a 3%nat)%C) by (rewrite H2; ring).
  assert (E0 : a 0%nat = (2 * g * a 1%nat - a 2%nat)%C) by (rewrite H1; ring).
  rewrite A0, E1, E2, E3 in E0. transitivity (RtoC 1); [|reflexivity]. rewrite E0.
  destruct g as [x z], (a 4%nat) as [p q]. unfold re4, im4. apply injective_projections; cbn; ring.
Qed.
Lemma chain5 (a : nat -> C) g : a 0%nat = RtoC 1 -> chain g 4 a -> (a 5%nat * (re5 (fst g) (snd g), im5 (fst g) (snd g)) = 1)%C.
Proof.
  intros A0 [H E4]. pose proof (f_equal snd (H 4%nat ltac:(lia))) as H4. pose proof (f_equal snd (H 3%nat ltac:(lia))) as H3.
  pose proof (f_equal snd (H 2%nat ltac:(lia))) as H2. pose proof (f_equal snd (H 1%nat ltac:(lia))) as H1. cbn in E4.
  change (a 5%nat = (2 * g * a 4%nat - a 3%nat)%C) in H4. change (a 4%nat = (2 * g * a 3%nat - a 2%nat)%C) in H3.
  change (a 3%nat = (2 * g * a 2%nat - a 1%nat)%C) in H2. change (a 2%nat = (2 * g * a 1%nat - a 0%nat)%C) in H1.
  assert (E3 : a 3%nat = (2 * g * a 4%nat - a 5%nat)%C) by (rewrite H4; ring).
  assert (E2 : a 2%nat = (2 * g * a 3%nat - a 4%nat)%C) by (rewrite H3; ring).
  assert (E1 : a 1%nat = (2 * g * a 2%nat - a 3%nat)%C) by (rewrite H2; ring).
  assert (E0 : a 0%nat = (2 * g * a 1%nat - a 2%nat)%C) by (rewrite H1; ring).
  rewrite A0, E1, E2, E3, E4 in E0. transitivity (RtoC 1); [|reflexivity]. rewrite E0.
  destruct g as [x z], (a 5%nat) as [p q]. unfold re5, im5, re4, im4, re3, im3. apply injective_projections; cbn; ring.
Qed.
Lemma modulus_from (z : C) r i : (z * (r, i) = 1)%C -> Cmod z ^ 2 * (r ^ 2 + i ^ 2) = 1.
Proof.
  intros H. apply (f_equal Cmod) in H. rewrite Cmod_mult, Cmod_1 in H.
  pose proof (Cmod_sqr (r, i)) as S. cbn [fst snd] in S. rewrite <- S. rewrite <- Rpow_mult_distr, H. ring.
Qed.
(* veerman.table1_numeric: the first row is not the maximum of |a_M| over w, for N + 1 = 5 or for N = 4 followers *)
Theorem table_numeric_fails :
  (forall a, a 0%nat = RtoC 1 -> equation_2 (-1) (-1) 0.27311 3 a -> 4.6548 <= Cmod (a 4%nat)) /\
  (forall a, a 0%nat = RtoC 1 -> equation_2 (-1) (-1) 0.22 4 a -> 5.7 <= Cmod (a 5%nat)).
Proof.
  assert (LB : forall (m s b : R), 0 <= m -> 0 <= b -> m ^ 2 * s = 1 -> 0 < s -> s * b ^ 2 <= 1 -> b <= m).
  { intros m s b Hm Hb E Hs H. destruct (Rle_lt_dec b m) as [L|L]; [exact L|exfalso].
    assert (m * m < b * b) by (apply Rmult_le_0_lt_compat; lra).
    assert (s * (m * m) < s * (b * b)) by (apply Rmult_lt_compat_l; lra).
    replace (m ^ 2 * s) with (s * (m * m)) in E by ring. replace (s * b ^ 2) with (s * (b * b)) in H by ring. lra. }
  split; intros a A0 HE; apply equation_2_chain in HE; try lra.
  - pose proof (modulus_from _ _ _ (chain4 a _ A0 HE)) as E. rewrite gamma_unit in E. cbn [fst snd] in E.
    assert (B0 : 0 <= 4.6548) by lra.
    apply (LB _ _ _ (Cmod_ge_0 _) B0 E); unfold re4, im4, cx, cz; interval with (i_prec 60).
  - pose proof (modulus_from _ _ _ (chain5 a _ A0 HE)) as E. rewrite gamma_unit in E. cbn [fst snd] in E.
    assert (B0 : 0 <= 5.7) by lra.
    apply (LB _ _ _ (Cmod_ge_0 _) B0 E); unfold re5, im5, re4, im4, re3, im3, cx, cz; interval with (i_prec 60).
Qed.

(* ---- veerman.onlytwo: when everyone tracks the leader, the peak does not grow at all ---- *)
Definition equation_star (f g w : R) (a : nat -> C) : Prop := a 0%nat = RtoC 1 /\
  forall k, ((- w ^ 2)%R * a (S k) = den f g w * (a (S k) - a 0%nat))%C.
Theorem star_response f g w a k : f < 0 -> g < 0 -> equation_star f g w a -> a (S k) = (/ gamma f g w)%C.
Proof.
  intros Hf Hg [A0 H]. specialize (H k). rewrite A0 in H. rewrite inv_gamma by assumption.
  pose proof (num_neq0 f g w Hf Hg) as NZ. apply (Cmult_cancel_r _ _ _ NZ). unfold Cdiv.
  rewrite <- Cmult_assoc, Cinv_l, Cmult_1_r by exact NZ. symmetry.
  apply (Cminus_iff ((- w ^ 2)%R * a (S k))%C (den f g w * (a (S k) - 1))%C); [|exact H].
  apply injective_projections; cbn; ring.
Qed.
(* the peak response of the last car is the same number > 1 for every size: neither exponential nor linear growth *)
Theorem star_peak f g : f < 0 -> g < 0 -> exists A, 1 < A /\ forall N,
  (exists w, forall a, equation_star f g w a -> Cmod (a (S N)) = A) /\
  (forall w a, equation_star f g w a -> Cmod (a (S N)) <= A).
Proof.
  intros Hf Hg. set (v := strongest f g). destruct (strongest_root f g Hf Hg) as [[V0 V1] _]. fold v in V0, V1.
  set (w := sqrt v). assert (W2 : w ^ 2 = v) by (unfold w; rewrite pow2_sqrt; lra).
  exists (Cmod (/ gamma f g w)%C). split.
  - apply gain_above_one; try assumption. rewrite W2, Rabs_left by lra. lra.
  - intros N. split.
    + exists w. intros a H. now rewrite (star_response f g w a N Hf Hg H).
    + intros w' a H. rewrite (star_response f g w' a N Hf Hg H).
      destruct (gain_strongest f g w Hf Hg) as [_ [M _]]. now apply M.
Qed.

(* ---- veerman.nth_neighbour ---- *)
(* agents 0 to N + 1; n-th neighbours *)
Definition tracks (n N i j : nat) : Prop := (i <= S N)%nat /\ (j <= S N)%nat /\ (j = i + n \/ i = j + n)%nat.
Inductive joined (n N : nat) : nat -> nat -> Prop :=
| here i : joined n N i i
| there i j k : tracks n N i j -> joined n N j k -> joined n N i k.
Theorem nth_neighbour n N : (2 <= n)%nat -> ~ joined n N 0 1.
Proof.
  intros Hn H. assert (K : forall i j, joined n N i j -> i mod n = j mod n).
  { clear H. intros i j H. induction H as [|i j k [_ [_ T]] _ IH]; [reflexivity|]. rewrite <- IH.
    destruct T as [->| ->]; [symmetry|]; rewrite <- (Nat.mul_1_l n) at 1; now rewrite Nat.mod_add by lia. }
  apply K in H. rewrite Nat.mod_0_l, Nat.mod_small in H by lia. discriminate.
Qed.
(* and agent 1 stays at rest whatever the leader does: the motion that ignores the leader solves its equation
   in every class that does not contain the leader *)
Theorem nth_neighbour_printed_fails N : forall i j, (i <= S N)%nat -> (j <= S N)%nat -> joined 1 N i j.
Proof.
  assert (U : forall d i, (i + d <= S N)%nat -> joined 1 N i (i + d)).
  { induction d as [|d IH]; intros i H; [rewrite Nat.add_0_r; constructor|].
    apply there with (i + 1)%nat; [repeat split; lia|]. replace (i + S d)%nat with (i + 1 + d)%nat by lia. apply IH. lia. }
  assert (D : forall d i, (i + d <= S N)%nat -> joined 1 N (i + d) i).
  { induction d as [|d IH]; intros i H; [rewrite Nat.add_0_r; constructor|].
    apply there with (i + d)%nat; [repeat split; lia|]. apply IH. lia. }
  intros i j Hi Hj. destruct (le_ge_dec i j) as [L|L].
  - replace j with (i + (j - i))%nat by lia. apply U. lia.
  - replace i with (j + (i - j))%nat by lia. apply D. lia.
Qed.
