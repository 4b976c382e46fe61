(* Small facts about Coquelicot's complex numbers that the Veerman files share. *)
From Coq Require Import Reals Lra Lia Psatz.
From Coquelicot Require Import Coquelicot.
Open Scope R_scope.

Lemma Cneq0_re (z : C) : fst z <> 0 -> z <> 0%C.
Proof. intros H E. apply H. now rewrite E. Qed.
Lemma Cneq0_im (z : C) : snd z <> 0 -> z <> 0%C.
Proof. intros H E. apply H. now rewrite E. Qed.
Lemma Cmod_sqr (z : C) : Cmod z ^ 2 = fst z ^ 2 + snd z ^ 2.
Proof.
  unfold Cmod. rewrite <- Rsqr_pow2, Rsqr_sqrt; [reflexivity|].
  pose proof (pow2_ge_0 (fst z)). pose proof (pow2_ge_0 (snd z)). lra.
Qed.
Lemma C2 : RtoC 2 = (RtoC 1 + RtoC 1)%C.
Proof. apply injective_projections; cbn; ring. Qed.
Lemma C1_neq0 : RtoC 1 <> 0%C.
Proof. apply Cneq0_re; cbn; lra. Qed.
Lemma C2_neq0 : RtoC 2 <> 0%C.
Proof. apply Cneq0_re; cbn; lra. Qed.

Lemma Cminus_iff (x y u v : C) : (x - y = u - v)%C -> (x = y <-> u = v).
Proof.
  destruct x as [x1 x2], y as [y1 y2], u as [u1 u2], v as [v1 v2]. intros E. injection E as E1 E2.
  split; intros H; injection H as H1 H2; f_equal; lra.
Qed.
Lemma Cmult_cancel_r (x y z : C) : z <> 0%C -> (x * z = y * z)%C -> x = y.
Proof.
  intros Hz E. apply (f_equal (fun u => u * / z)%C) in E.
  now rewrite <- !Cmult_assoc, Cinv_r, !Cmult_1_r in E.
Qed.

Fixpoint Cpw (z : C) (n : nat) : C := match n with O => RtoC 1 | S n => (z * Cpw z n)%C end.
Lemma Cpw_neq0 (z : C) (n : nat) : z <> 0%C -> Cpw z n <> 0%C.
Proof. intros Hz. induction n as [|n IH]; cbn [Cpw]; [exact C1_neq0 | now apply Cmult_neq_0]. Qed.
Lemma Cpw_inv (z : C) (n : nat) : z <> 0%C -> Cpw (/ z)%C n = (/ Cpw z n)%C.
Proof.
  intros Hz. induction n as [|n IH]; cbn [Cpw].
  - field. exact C1_neq0.
  - rewrite IH. field. split; [now apply Cpw_neq0 | assumption].
Qed.
Lemma Cpw_mult (y z : C) (n : nat) : (Cpw (y * z) n = Cpw y n * Cpw z n)%C.
Proof. induction n as [|n IH]; cbn [Cpw]; [ring | rewrite IH; ring]. Qed.
Lemma Cpw_one (n : nat) : Cpw (RtoC 1) n = RtoC 1.
Proof. induction n as [|n IH]; cbn [Cpw]; [reflexivity | rewrite IH; ring]. Qed.
Lemma Cmod_Cpw (z : C) (n : nat) : Cmod (Cpw z n) = Cmod z ^ n.
Proof. induction n as [|n IH]; cbn [Cpw pow]; [apply Cmod_1 | now rewrite Cmod_mult, IH]. Qed.

(* the principal square root *)
Definition Csqrt (z : C) : C :=
  let r := Cmod z in
  (sqrt ((r + fst z) / 2), if Rle_dec 0 (snd z) then sqrt ((r - fst z) / 2) else - sqrt ((r - fst z) / 2)).
Lemma Cmod_parts (z : C) : - Cmod z <= fst z <= Cmod z /\ Cmod z ^ 2 = fst z ^ 2 + snd z ^ 2.
Proof.
  pose proof (Cmod_sqr z) as E. pose proof (Cmod_ge_0 z) as P. pose proof (pow2_ge_0 (snd z)).
  split; [|exact E]. pose proof (Rmax_Cmod z) as M. pose proof (Rmax_l (Rabs (fst z)) (Rabs (snd z))).
  pose proof (Rle_abs (fst z)). pose proof (Rle_abs (- fst z)). rewrite Rabs_Ropp in *. lra.
Qed.
Lemma Csqrt_sqr (z : C) : (Csqrt z * Csqrt z)%C = z.
Proof.
  destruct (Cmod_parts z) as [[A B] E]. unfold Csqrt. set (r := Cmod z) in *.
  assert (P : sqrt ((r + fst z) / 2) * sqrt ((r + fst z) / 2) = (r + fst z) / 2) by (apply sqrt_sqrt; lra).
  assert (Q : sqrt ((r - fst z) / 2) * sqrt ((r - fst z) / 2) = (r - fst z) / 2) by (apply sqrt_sqrt; lra).
  assert (PQ : sqrt ((r + fst z) / 2) * sqrt ((r - fst z) / 2) = Rabs (snd z) / 2).
  { rewrite <- sqrt_mult by lra. replace ((r + fst z) / 2 * ((r - fst z) / 2)) with ((snd z / 2) ^ 2).
    - rewrite <- Rsqr_pow2, sqrt_Rsqr_abs. unfold Rdiv. rewrite Rabs_mult, (Rabs_right (/ 2)) by lra. reflexivity.
    - transitivity ((r ^ 2 - fst z ^ 2) / 4); [rewrite E; field | field]. }
  apply injective_projections; cbn [Cmult fst snd]; destruct (Rle_dec 0 (snd z)) as [S|S].
  - rewrite P, Q. field.
  - replace (- sqrt ((r - fst z) / 2) * - sqrt ((r - fst z) / 2)) with ((r - fst z) / 2)
      by (transitivity (sqrt ((r - fst z) / 2) * sqrt ((r - fst z) / 2)); [symmetry; exact Q | ring]).
    rewrite P. field.
  - rewrite (Rmult_comm (sqrt ((r - fst z) / 2))), PQ, Rabs_right by lra. field.
  - replace (- sqrt ((r - fst z) / 2) * sqrt ((r + fst z) / 2)) with
      (- (sqrt ((r + fst z) / 2) * sqrt ((r - fst z) / 2))) by ring.
    replace (sqrt ((r + fst z) / 2) * - sqrt ((r - fst z) / 2)) with
      (- (sqrt ((r + fst z) / 2) * sqrt ((r - fst z) / 2))) by ring.
    rewrite PQ, Rabs_left by lra. field.
Qed.
(* its angle is in (-pi/2, pi/2] *)
Lemma Csqrt_angle (z : C) : 0 < fst (Csqrt z) \/ (fst (Csqrt z) = 0 /\ 0 <= snd (Csqrt z)).
Proof.
  destruct (Cmod_parts z) as [[A B] E]. unfold Csqrt; cbn [fst snd]. set (r := Cmod z) in *.
  destruct (Rle_lt_or_eq_dec (- r) (fst z) A) as [L|L]; [left; apply sqrt_lt_R0; lra|right].
  assert (S : snd z = 0) by (rewrite <- L in E; nra).
  split; [replace ((r + fst z) / 2) with 0 by lra; apply sqrt_0|].
  destruct (Rle_dec 0 (snd z)) as [N|N]; [apply sqrt_pos|lra].
Qed.

(* e^{i t} *)
Definition cis (t : R) : C := (cos t, sin t).
Lemma cis_neq0 t : cis t <> 0%C.
Proof.
  intros E. pose proof (sin2_cos2 t) as H. injection E as Ec Es.
  rewrite Ec, Es in H. unfold Rsqr in H. lra.
Qed.

(* derivative of a complex function of a real variable, part by part *)
Definition Cderive (z : R -> C) (t : R) (d : C) : Prop :=
  is_derive (fun s : R => fst (z s)) t (fst d) /\ is_derive (fun s : R => snd (z s)) t (snd d).

Lemma Cderive_unique z t d d' : Cderive z t d -> Cderive z t d' -> d = d'.
Proof.
  intros [A B] [A' B']. apply injective_projections.
  - rewrite <- (is_derive_unique _ _ _ A). exact (is_derive_unique _ _ _ A').
  - rewrite <- (is_derive_unique _ _ _ B). exact (is_derive_unique _ _ _ B').
Qed.
Lemma Cderive_wave (a : C) (w t : R) :
  Cderive (fun s : R => (a * cis (w * s))%C) t ((0, w) * (a * cis (w * t)))%C.
Proof.
  split; unfold cis; cbn [fst snd Cmult]; (evar_last; [auto_derive; [easy|reflexivity] | ]); ring.
Qed.
Lemma is_derive_shift (u : R -> R) (t d k : R) : is_derive u t d -> is_derive (fun s : R => k + u s) t d.
Proof.
  intros H. replace d with (plus zero d) by (unfold plus, zero; cbn; ring).
  apply (@is_derive_plus R_AbsRing R_NormedModule (fun _ : R => k) u); [|exact H].
  exact (@is_derive_const R_AbsRing R_NormedModule k t).
Qed.
Lemma Cderive_plus_const z t d (h : C) : Cderive z t d -> Cderive (fun s : R => (h + z s)%C) t d.
Proof. intros [A B]. split; cbn [fst snd Cplus]; now apply is_derive_shift. Qed.
