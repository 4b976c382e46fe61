(* beyond.paley.circulant_spectrum, stated again from its words with own definitions of the graph, its eigenvalues, the law (22), the frame, the derivatives, the determinant and
   the cubics, after the theorems had been seen. Particles and nodes from 0; m, and q modulo N, are integers of either sign. *)
From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From mathcomp Require ssrnat.
From Flockproof Require Import RealSums paley_model paley_phase.
From Flockproof Require paley_laplacian paley_gradient paley_fourier paley_particles paley_turning paley_circulant_reals.
Open Scope R_scope.

Definition e (a : R) : C := (cos a, sin a).
Definition dot (x y : C) : R := fst x * fst y + snd x * snd y.
(* an undirected circulant graph: the shift of all numbers by one, modulo n, keeps it *)
Definition undirected_within n (adj : nat -> nat -> bool) := forall k j, (k < n)%nat -> (j < n)%nat -> adj k j = adj j k.
Definition shifted_alike n (adj : nat -> nat -> bool) := forall k j, (k < n)%nat -> (j < n)%nat -> adj (S k mod n) (S j mod n) = adj k j.
Definition laplacian n (adj : nat -> nat -> bool) (x : nat -> C) (k : nat) : C := Csum n (fun j => if adj k j then x k - x j else 0)%C.
Definition angle n (q : Z) (k : nat) : R := 2 * PI * IZR q * INR k / INR n.
Definition eigenvalues n adj (lam : Z -> C) := forall q k, (k < n)%nat -> laplacian n adj (fun j => e (angle n q j)) k = (lam q * e (angle n q k))%C.
(* (22) *)
Definition law22 n adj w0 K0 K1 (r : nat -> C) (th : nat -> R) (k : nat) : R :=
  w0 + (K1 - K0) / INR n * dot (Ci * e (th k))%C (laplacian n adj (fun j => e (th j)) k) + w0 * (K0 / INR n) * dot (e (th k)) (laplacian n adj r k).
Definition moves n adj w0 K0 K1 (r : nat -> R -> C) (th : nat -> R -> R) := forall t k, (k < n)%nat ->
  is_derive (fun s => fst (r k s)) t (cos (th k t)) /\ is_derive (fun s => snd (r k s)) t (sin (th k t)) /\
  is_derive (th k) t (law22 n adj w0 K0 K1 (fun j => r j t) (fun j => th j t) k).
(* states: the coordinates x_k, y_k, theta_k are those of the numbers 3k, 3k + 1, 3k + 2; the rates in a frame that turns at w0 *)
Definition place (x : nat -> R) (k : nat) : C := (x (3 * k)%nat, x (3 * k + 1)%nat).
Definition phase (x : nat -> R) (k : nat) : R := x (3 * k + 2)%nat.
Definition rates n adj w0 K0 K1 (x : nat -> R) (i : nat) : R := let k := (i / 3)%nat in
  match (i mod 3)%nat with
  | 0%nat => fst (e (phase x k) - Ci * RtoC w0 * place x k)%C
  | 1%nat => snd (e (phase x k) - Ci * RtoC w0 * place x k)%C
  | _ => law22 n adj w0 K0 K1 (place x) (phase x) k - w0
  end.
Definition seen w0 (c : C) (r : nat -> R -> C) (th : nat -> R -> R) (t : R) (x : nat -> R) n := forall k, (k < n)%nat ->
  place x k = (e (- (w0 * t)) * (r k t - c))%C /\ phase x k = th k t - w0 * t.
Definition frame : Prop := forall n adj w0 K0 K1 c r th (x : R -> nat -> R), (1 <= n)%nat -> w0 <> 0 -> moves n adj w0 K0 K1 r th ->
  (forall t, seen w0 c r th t (x t) n) -> forall t i, (i < 3 * n)%nat -> is_derive (fun s => x s i) t (rates n adj w0 K0 K1 (x t) i).
(* the circular formation about 0: each turns at w0, e^(i theta_k) = i w0 r_k *)
Definition formation n w0 (m : Z) (x : nat -> R) := forall k, (k < n)%nat -> phase x k = angle n m k /\ e (phase x k) = (Ci * RtoC w0 * place x k)%C.
Definition rests : Prop := forall n adj w0 K0 K1 m x, (1 <= n)%nat -> undirected_within n adj -> shifted_alike n adj -> w0 <> 0 -> formation n w0 m x ->
  (forall k, (k < n)%nat -> Cmod (place x k) = / Rabs w0) /\ forall i, (i < 3 * n)%nat -> rates n adj w0 K0 K1 x i = 0.
(* the matrix of the derivatives, determinants by their first row, the cubics *)
Definition changed (x : nat -> R) (j : nat) (h : R) (l : nat) : R := if Nat.eqb l j then x l + h else x l.
Definition linearised n (F : (nat -> R) -> nat -> R) (x : nat -> R) (A : nat -> nat -> R) := forall i j, (i < n)%nat -> (j < n)%nat ->
  is_derive (fun h => F (changed x j h) i) 0 (A i j).
Fixpoint det (n : nat) (A : nat -> nat -> C) : C := match n with
  | O => 1
  | S l => Csum n (fun j => (if Nat.even j then 1 else -1) * A 0%nat j * det l (fun a b => A (S a) (if Nat.ltb b j then b else S b)))
  end%C.
Definition cubic n (lam : Z -> C) w0 K0 K1 (m q : Z) (s : C) : C :=
  let k0 := RtoC (K0 / INR n) in let k1 := RtoC (K1 / INR n) in let w := RtoC w0 in
  let cq := ((lam (m + q)%Z + lam (m - q)%Z) / 2)%C in let dq := ((lam (m + q)%Z - lam (m - q)%Z) / 2)%C in let tq := (cq - lam m)%C in
  (s * s * s + (k0 * cq - k1 * tq) * (s * s) + (w * w - Ci * w * k0 * dq) * s - k1 * tq * (w * w))%C.
Fixpoint product (n : nat) (f : nat -> C) : C := match n with O => 1 | S l => product l f * f l end%C.
Definition defined : Prop := forall n adj w0 K0 K1 m x, (1 <= n)%nat -> undirected_within n adj -> shifted_alike n adj -> w0 <> 0 -> formation n w0 m x ->
  exists A lam, linearised (3 * n) (rates n adj w0 K0 K1) x A /\ eigenvalues n adj lam.
Definition circulant_spectrum : Prop := forall n adj w0 K0 K1 m x A lam, (1 <= n)%nat -> undirected_within n adj -> shifted_alike n adj -> w0 <> 0 -> formation n w0 m x ->
  linearised (3 * n) (rates n adj w0 K0 K1) x A -> eigenvalues n adj lam ->
  forall s, det (3 * n) (fun i j => (if Nat.eqb i j then s else 0) - RtoC (A i j))%C = product n (fun q => cubic n lam w0 K0 K1 m (Z.of_nat q) s).

(* ---- and the theorems prove these ---- *)
Module T := paley_turning.
Module F := paley_fourier.
Definition inside n (adj : nat -> nat -> bool) : graph := fun k j => andb (andb (Nat.ltb k n) (Nat.ltb j n)) (adj k j).
Lemma inside_is n adj k j : (k < n)%nat -> (j < n)%nat -> inside n adj k j = adj k j.
Proof. intros Hk Hj. unfold inside. now rewrite (proj2 (Nat.ltb_lt k n) Hk), (proj2 (Nat.ltb_lt j n) Hj). Qed.
Lemma inside_undirected n adj : undirected_within n adj -> undirected (inside n adj).
Proof.
  intros U k j. unfold inside. rewrite (Bool.andb_comm (Nat.ltb k n)). destruct (Nat.ltb_spec j n), (Nat.ltb_spec k n); cbn; try reflexivity. now apply U.
Qed.
Lemma inside_circulant n adj : (1 <= n)%nat -> shifted_alike n adj -> F.circulant n (inside n adj) (fun d => inside n adj 0%nat d).
Proof.
  intros Hn Sh. assert (U : forall a, (a mod n < n)%nat) by (intros; apply Nat.mod_upper_bound; lia).
  assert (K : forall k d, (k < n)%nat -> (d < n)%nat -> adj k ((d + k) mod n) = adj 0%nat d).
  { induction k as [|k IH]; intros d Hk Hd; [now rewrite Nat.add_0_r, Nat.mod_small|]. rewrite <- (IH d) by lia. rewrite <- (Sh k ((d + k) mod n)%nat) by (auto; lia).
    f_equal; [now rewrite Nat.mod_small|]. rewrite <- (Nat.add_1_l ((d + k) mod n)), Nat.add_mod_idemp_r by lia. f_equal. lia. }
  intros k j Hk Hj. rewrite !inside_is by (auto; lia). rewrite <- (K k) by auto. f_equal. rewrite Nat.add_mod_idemp_l by lia.
  replace (j + n - k + k)%nat with (j + 1 * n)%nat by lia. rewrite Nat.mod_add, Nat.mod_small; lia.
Qed.
Lemma laplacian_is n adj x k : (k < n)%nat -> laplacian n adj x k = row n (lap n (inside n adj)) k x.
Proof.
  intros Hk. rewrite row_lap by exact Hk. apply Csum_ext. intros j Hj. unfold w. rewrite inside_is by assumption.
  destruct (adj k j); apply injective_projections; cbn; ring.
Qed.
Lemma dot_is x y : dot x y = inner x y.
Proof. now rewrite inner_xy. Qed.
Lemma angle_is n q a z k : (1 <= n)%nat -> q = (Z.of_nat a + Z.of_nat n * z)%Z -> e (angle n q k) = expi (F.wave n a k).
Proof.
  intros Hn ->. pose proof (INR_pos n Hn). replace (angle n (Z.of_nat a + Z.of_nat n * z) k) with (2 * PI * IZR (z * Z.of_nat k) + F.wave n a k).
  - change (expi (2 * PI * IZR (z * Z.of_nat k) + F.wave n a k) = expi (F.wave n a k)). rewrite expi_plus, F.expi_2PI. ring.
  - unfold angle, F.wave. rewrite plus_IZR, !mult_IZR, <- !INR_IZR_INZ. field. lra.
Qed.
Lemma lam_is n adj lam q a z : (1 <= n)%nat -> shifted_alike n adj -> eigenvalues n adj lam -> q = (Z.of_nat a + Z.of_nat n * z)%Z ->
  lam q = F.circulant_eigenvalue n (fun d => inside n adj 0%nat d) a.
Proof.
  intros Hn Sh E Q. pose proof (F.circulant_eigenvector n _ _ a Hn (inside_circulant n adj Hn Sh) 0%nat Hn) as V. specialize (E q 0%nat Hn).
  rewrite laplacian_is in E by exact Hn. unfold row in E, V.
  rewrite (Csum_ext n _ (fun j => RtoC (lap n (inside n adj) 0 j) * expi (F.wave n a j))%C) in E by (intros j _; now rewrite (angle_is n q a z)).
  rewrite V in E. rewrite (angle_is n q a z) in E by assumption.
  apply (f_equal (fun c => c * / expi (F.wave n a 0))%C) in E. rewrite <- !Cmult_assoc, Cinv_r, !Cmult_1_r in E by apply expi_neq0. now symmetry.
Qed.
Lemma rates_are n adj w0 K0 K1 x r th h i : (1 <= n)%nat -> w0 <> 0 -> (i < 3 * n)%nat ->
  (forall k, (k < n)%nat -> place x k = r k h /\ e (phase x k) = expi (th k h)) ->
  rates n adj w0 K0 K1 x i = T.turning_rate n (inside n adj) w0 K0 K1 r th h i.
Proof.
  intros Hn Hw Hi S. assert (Hk : (i / 3 < n)%nat) by (apply Nat.div_lt_upper_bound; lia).
  unfold rates, T.turning_rate. set (k := (i / 3)%nat) in *. destruct (S k Hk) as [Sp Sa]. destruct (i mod 3)%nat as [|[|a]].
  - rewrite Sp, Sa. cbn. ring.
  - rewrite Sp, Sa. cbn. ring.
  - f_equal. rewrite paley_particles.eq22 by assumption. unfold law22. rewrite !dot_is, !laplacian_is by exact Hk. unfold paley_gradient.gW. rewrite Sa. f_equal; [f_equal|]; f_equal; f_equal.
    + apply Csum_ext. intros j Hj. unfold phasors. now rewrite (proj2 (S j Hj)).
    + apply Csum_ext. intros j Hj. now rewrite (proj1 (S j Hj)).
Qed.
Theorem frame_proved : frame.
Proof.
  intros n adj w0 K0 K1 c r th x Hn Hw M S t i Hi. assert (Hk : (i / 3 < n)%nat) by (apply Nat.div_lt_upper_bound; lia). set (k := (i / 3)%nat) in *.
  destruct (M t k Hk) as (Mx & My & Mt).
  assert (L : law22 n adj w0 K0 K1 (fun j => r j t) (fun j => th j t) k = paley_particles.control5 n (inside n adj) w0 K0 K1 r th t k).
  { rewrite paley_particles.eq22 by assumption. unfold law22. now rewrite !dot_is, !laplacian_is by exact Hk. }
  rewrite L in Mt. destruct (T.turning_frame n (inside n adj) w0 K0 K1 c r th t Hn Hw k Hk (conj Mx My) Mt) as [[V1 V2] V3].
  rewrite (rates_are n adj w0 K0 K1 (x t) (T.r_turning w0 c r) (T.th_turning w0 th) t i Hn Hw Hi).
  2: { intros l Hl. destruct (S t l Hl) as [P A]. split; [exact P|now rewrite A]. }
  pose proof (Nat.div_mod i 3 ltac:(lia)) as D. pose proof (Nat.mod_upper_bound i 3 ltac:(lia)) as B. fold k in D.
  assert (P : forall s, x s (3 * k)%nat = fst (T.r_turning w0 c r k s) /\ x s (3 * k + 1)%nat = snd (T.r_turning w0 c r k s) /\ x s (3 * k + 2)%nat = T.th_turning w0 th k s).
  { intros s. destruct (S s k Hk) as [E1 E2]. unfold place in E1. injection E1 as E1 E3. split; [exact E1|split; [exact E3|exact E2]]. }
  assert (Q : i = (3 * k)%nat \/ i = (3 * k + 1)%nat \/ i = (3 * k + 2)%nat) by lia. destruct Q as [Q|[Q|Q]]; rewrite Q.
  - eapply is_derive_ext; [intros s; symmetry; apply P|exact V1].
  - eapply is_derive_ext; [intros s; symmetry; apply P|exact V2].
  - eapply is_derive_ext; [intros s; symmetry; apply P|exact V3].
Qed.
(* m modulo n *)
Lemma residue n (m : Z) : (1 <= n)%nat -> exists a z, (a <= n)%nat /\ m = (Z.of_nat a + Z.of_nat n * z)%Z.
Proof.
  intros Hn. exists (Z.to_nat (m mod Z.of_nat n)), (m / Z.of_nat n)%Z. pose proof (Z.mod_pos_bound m (Z.of_nat n) ltac:(lia)) as B. pose proof (Z.div_mod m (Z.of_nat n) ltac:(lia)).
  rewrite Z2Nat.id by lia. split; lia.
Qed.
Lemma formation_is n w0 m x a z k : (1 <= n)%nat -> w0 <> 0 -> formation n w0 m x -> m = (Z.of_nat a + Z.of_nat n * z)%Z -> (k < n)%nat ->
  e (phase x k) = expi (F.wave n a k) /\ place x k = T.rest_place w0 (F.wave n a) k.
Proof.
  intros Hn Hw Fo Q Hk. destruct (Fo k Hk) as [A B]. assert (E : e (phase x k) = expi (F.wave n a k)) by (rewrite A; now apply (angle_is n m a z)).
  split; [exact E|]. rewrite E in B. unfold expi, T.rest_place in *. destruct (place x k) as [p q]. cbn in B. injection B as B1 B2. rewrite B1, B2. apply injective_projections; cbn; field; exact Hw.
Qed.
Theorem rests_proved : rests.
Proof.
  intros n adj w0 K0 K1 m x Hn U Sh Hw Fo. destruct (residue n m Hn) as (a & z & Ha & Q). split.
  - intros k Hk. destruct (Fo k Hk) as [_ B]. apply (f_equal Cmod) in B. rewrite !Cmod_mult, Cmod_R in B.
    assert (C1 : Cmod (e (phase x k)) = 1). { unfold Cmod, e. cbn [fst snd]. replace (cos (phase x k) ^ 2 + sin (phase x k) ^ 2) with 1; [apply sqrt_1|]. pose proof (sin2_cos2 (phase x k)). unfold Rsqr in *. lra. }
    assert (C2 : Cmod Ci = 1). { unfold Cmod, Ci. cbn [fst snd]. replace (0 ^ 2 + 1 ^ 2) with 1 by ring. apply sqrt_1. }
    rewrite C1, C2, Rmult_1_l in B. pose proof (Rabs_pos_lt w0 Hw). apply (Rmult_eq_reg_l (Rabs w0)); [|lra]. rewrite <- B. field. lra.
  - intros i Hi. rewrite (rates_are n adj w0 K0 K1 x (fun k _ => T.rest_place w0 (F.wave n a) k) (fun k _ => F.wave n a k) 0 i Hn Hw Hi).
    + apply (T.turning_rest_circulant n (inside n adj) (fun d => inside n adj 0%nat d)); try assumption; [now apply inside_undirected|now apply inside_circulant].
    + intros k Hk. destruct (formation_is n w0 m x a z k Hn Hw Fo Q Hk). now split.
Qed.
Lemma along_is (x : nat -> R) j h k b : changed x j h (3 * k + b)%nat = x (3 * k + b)%nat + h * T.along j k b.
Proof. unfold changed, T.along. destruct (Nat.eqb (3 * k + b) j); ring. Qed.
Lemma derivatives n adj w0 K0 K1 m x a z i j : (1 <= n)%nat -> undirected_within n adj -> shifted_alike n adj -> w0 <> 0 -> formation n w0 m x ->
  (a <= n)%nat -> m = (Z.of_nat a + Z.of_nat n * z)%Z -> (i < 3 * n)%nat ->
  is_derive (fun h => rates n adj w0 K0 K1 (changed x j h) i) 0 (T.turning_matrix n (inside n adj) w0 K0 K1 a i j).
Proof.
  intros Hn U Sh Hw Fo Ha Q Hi.
  destruct (@paley_circulant_reals.circulant_spectrum_reals n (inside n adj) (fun d => inside n adj 0%nat d) a w0 K0 K1) as [D _]; try assumption.
  - now apply (ssrbool.introT ssrnat.ltP).
  - now apply inside_circulant.
  - now apply inside_undirected.
  - now apply (ssrbool.introT ssrnat.leP).
  - eapply is_derive_ext; [|apply (D i j); now apply (ssrbool.introT ssrnat.ltP)]. intros h. symmetry. apply rates_are; try assumption. intros k Hk.
    destruct (formation_is n w0 m x a z k Hn Hw Fo Q Hk) as [E P]. split.
    + unfold place in *. pose proof (along_is x j h k 0) as A0. rewrite Nat.add_0_r in A0. rewrite A0, along_is. unfold T.r_along. now rewrite <- P.
    + unfold phase in *. rewrite along_is. change (expi (x (3 * k + 2)%nat + h * T.along j k 2) = expi (F.wave n a k + h * T.along j k 2)). rewrite !expi_plus.
      change (e (x (3 * k + 2)%nat)) with (expi (x (3 * k + 2)%nat)) in E. now rewrite E.
Qed.
Theorem defined_proved : defined.
Proof.
  intros n adj w0 K0 K1 m x Hn U Sh Hw Fo. destruct (residue n m Hn) as (a & z & Ha & Q).
  exists (T.turning_matrix n (inside n adj) w0 K0 K1 a), (fun q => F.circulant_eigenvalue n (fun d => inside n adj 0%nat d) (Z.to_nat (q mod Z.of_nat n))). split.
  - intros i j Hi _. now apply (derivatives n adj w0 K0 K1 m x a z).
  - intros q k Hk. rewrite laplacian_is by exact Hk. set (b := Z.to_nat (q mod Z.of_nat n)).
    assert (B : q = (Z.of_nat b + Z.of_nat n * (q / Z.of_nat n))%Z).
    { unfold b. pose proof (Z.mod_pos_bound q (Z.of_nat n) ltac:(lia)). pose proof (Z.div_mod q (Z.of_nat n) ltac:(lia)). rewrite Z2Nat.id by lia. lia. }
    rewrite (angle_is n q b _ k Hn B). rewrite <- (F.circulant_eigenvector n _ _ b Hn (inside_circulant n adj Hn Sh) k Hk). apply Csum_ext. intros j _. now rewrite (angle_is n q b _ j Hn B).
Qed.
Lemma det_is n : forall A B, (forall i j, (i < n)%nat -> (j < n)%nat -> A i j = B i j) -> det n A = T.Cdet n B.
Proof.
  induction n as [|n IH]; intros A B E; [reflexivity|]. cbn [det T.Cdet]. apply Csum_ext. intros j Hj. rewrite (E 0%nat j) by lia.
  rewrite (IH _ (fun a b => B (S a) (if Nat.leb j b then S b else b))).
  - assert (Sg : (if Nat.even j then RtoC 1 else RtoC (-1)) = RtoC ((-1) ^ j)).
    { clear. induction j as [|j IH]; [reflexivity|]. rewrite Nat.even_succ, <- Nat.negb_even. cbn [pow]. destruct (Nat.even j); cbn [negb]; apply (f_equal fst) in IH; cbn in IH; rewrite <- IH; apply injective_projections; cbn; ring. }
    rewrite Sg. ring.
  - intros a b Ha Hb. destruct (Nat.ltb_spec b j), (Nat.leb_spec j b); try lia; apply E; lia.
Qed.
Theorem circulant_spectrum_proved : circulant_spectrum.
Proof.
  intros n adj w0 K0 K1 m x A lam Hn U Sh Hw Fo L E s. destruct (residue n m Hn) as (a & z & Ha & Q).
  destruct (@paley_circulant_reals.circulant_spectrum_reals n (inside n adj) (fun d => inside n adj 0%nat d) a w0 K0 K1) as [_ D]; try assumption.
  - now apply (ssrbool.introT ssrnat.ltP).
  - now apply inside_circulant.
  - now apply inside_undirected.
  - now apply (ssrbool.introT ssrnat.leP).
  - specialize (D s). rewrite (det_is _ _ (fun i j => RtoC (delta i j) * s - RtoC (T.turning_matrix n (inside n adj) w0 K0 K1 a i j))%C).
    + etransitivity; [exact D|].
      assert (Pr : forall l f g, (forall q, (q < l)%nat -> f q = g q) -> T.Cprod l f = product l g).
      { induction l as [|l IHl]; intros f g H; [reflexivity|]. cbn. rewrite (IHl f g), H by (intros; try apply H; lia). reflexivity. }
      apply Pr. intros q Hq. unfold cubic, T.cubic_value.
      rewrite (lam_is n adj lam (m + Z.of_nat q) (a + q) z Hn Sh E) by lia. rewrite (lam_is n adj lam (m - Z.of_nat q) (a + (n - q)) (z - 1) Hn Sh E) by lia. rewrite (lam_is n adj lam m a z Hn Sh E Q).
      rewrite RtoC_mult. ring.
    + intros i j Hi Hj. pose proof (is_derive_unique _ _ _ (L i j Hi Hj)) as U1. pose proof (is_derive_unique _ _ _ (derivatives n adj w0 K0 K1 m x a z i j Hn U Sh Hw Fo Ha Q Hi)) as U2.
      rewrite <- U1, U2. unfold delta. destruct (Nat.eqb i j); ring.
Qed.
