(* Veerman, Stosic, Olvera, section 4: the amplitude of the last of N + 1 followers as a function of the frequency.
   It is |T_(N+1)(gamma)|^-1: that of every solution of equation (2) with a_0 = 1, of which there is one. It is continuous. *)
From Coq Require Import Reals Lra Lia Psatz.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import veerman_complex veerman_front veerman_chain veerman_stability.
Open Scope R_scope.

Definition amplitude (f g : R) (N : nat) (w : R) : R := Cmod (/ chebT (gamma f g w) (S N))%C.
Lemma cheb_mu gam n : (2 * chebT gam n = Cpw (mu_minus gam) n + Cpw (mu_plus gam) n)%C.
Proof.
  rewrite <- trace_power.
  assert (A : (2 * chebT gam n = trace2 (mat2_pow (Cmat gam) n) /\ 2 * chebT gam (S n) = trace2 (mat2_pow (Cmat gam) (S n)))%C); [|apply A].
  induction n as [|n [A B]].
  - cbn [chebT mat2_pow]. unfold trace2, mat2_mul, Cmat. cbn [m11 m12 m21 m22]. rewrite C2. split; ring.
  - split; [exact B|]. rewrite chebT_SS, trace_recurrence, <- A, <- B. ring.
Qed.
Lemma cheb_neq0 f g w n : f < 0 -> g < 0 -> chebT (gamma f g w) n <> 0%C.
Proof.
  intros Hf Hg E. apply (denominator_neq0 f g w n Hf Hg). rewrite <- cheb_mu, E. ring.
Qed.
Theorem amplitude_spec f g N w : f < 0 -> g < 0 ->
  (exists a, a 0%nat = RtoC 1 /\ equation_2 f g w N a) /\
  forall a, a 0%nat = RtoC 1 -> equation_2 f g w N a -> Cmod (a (S N)) = amplitude f g N w.
Proof.
  intros Hf Hg. pose proof (cheb_neq0 f g w (S N) Hf Hg) as NZ. set (gam := gamma f g w) in *. split.
  - exists (fun k => (chebT gam (S N - k) / chebT gam (S N))%C). split; [rewrite Nat.sub_0_r; now apply Cinv_r|].
    apply equation_2_chain; [assumption..|]. fold gam. split.
    + intros k Hk. unfold Cmap. cbn [fst snd]. f_equal. replace (S N - (k - 1))%nat with (S (S (S N - (k + 1)))) by lia.
      replace (S N - k)%nat with (S (S N - (k + 1))) by lia. rewrite chebT_SS. field. exact NZ.
    + rewrite Nat.sub_diag. replace (S N - N)%nat with 1%nat by lia. cbn [chebT]. field. exact NZ.
  - intros a A0 HE. destruct (lemma_2 f g w N a Hf Hg A0 HE) as [_ E]. fold gam in E. rewrite <- cheb_mu in E.
    unfold amplitude. fold gam. f_equal. rewrite E. field. split; [exact NZ|exact C2_neq0].
Qed.
(* the frequencies of the largest amplitude *)
Definition main_resonance (f g : R) (N : nat) (w : R) : Prop := 0 < w /\ forall w', 0 < w' -> amplitude f g N w' <= amplitude f g N w.

(* ---- the amplitude is continuous, so that it has a maximum on a closed interval ---- *)
Definition Ccont (z : R -> C) (w : R) := continuous (fun v => fst (z v)) w /\ continuous (fun v => snd (z v)) w.
Lemma Ccont_mult z1 z2 w : Ccont z1 w -> Ccont z2 w -> Ccont (fun v => (z1 v * z2 v)%C) w.
Proof.
  intros [A B] [C D]. split; cbn [Cmult fst snd].
  - apply (continuous_minus (fun v => fst (z1 v) * fst (z2 v)) (fun v => snd (z1 v) * snd (z2 v))); now apply (continuous_mult (K := R_AbsRing)).
  - apply (continuous_plus (fun v => fst (z1 v) * snd (z2 v)) (fun v => snd (z1 v) * fst (z2 v))); now apply (continuous_mult (K := R_AbsRing)).
Qed.
Lemma Ccont_minus z1 z2 w : Ccont z1 w -> Ccont z2 w -> Ccont (fun v => (z1 v - z2 v)%C) w.
Proof.
  intros [A B] [C D]. split; cbn [Cminus Cplus Copp fst snd].
  - now apply (continuous_minus (fun v => fst (z1 v)) (fun v => fst (z2 v))).
  - now apply (continuous_minus (fun v => snd (z1 v)) (fun v => snd (z2 v))).
Qed.
Lemma Ccont_const z w : Ccont (fun _ => z) w.
Proof. split; apply continuous_const. Qed.
Lemma gamma_continuous f g w : f < 0 -> g < 0 -> Ccont (gamma f g) w.
Proof.
  intros Hf Hg.
  assert (Q : forall v, 0 < f ^ 2 + (v * g) ^ 2) by (intros v; pose proof (pow2_ge_0 (v * g)); assert (0 < f ^ 2) by (apply pow2_gt_0; lra); lra).
  split.
  - assert (E : forall v : R, ((f + v ^ 2) * f + (v * g) ^ 2) / (f ^ 2 + (v * g) ^ 2) = fst (gamma f g v)).
    { intros v. unfold gamma, num, den, Cdiv, Cinv, Cmult; cbn [fst snd]. specialize (Q v). field. nra. }
    apply (continuous_ext _ _ _ E).
    apply (ex_derive_continuous (V := R_NormedModule)). auto_derive. specialize (Q w). split; [nra|easy] || nra.
  - assert (E : forall v : R, - g * v ^ 3 / (f ^ 2 + (v * g) ^ 2) = snd (gamma f g v)) by (intros v; symmetry; now apply gamma_imaginary).
    apply (continuous_ext _ _ _ E).
    apply (ex_derive_continuous (V := R_NormedModule)). auto_derive. specialize (Q w). split; [nra|easy] || nra.
Qed.
Lemma cheb_continuous f g n w : f < 0 -> g < 0 -> Ccont (fun v => chebT (gamma f g v) n) w.
Proof.
  intros Hf Hg. assert (A : Ccont (fun v => chebT (gamma f g v) n) w /\ Ccont (fun v => chebT (gamma f g v) (S n)) w); [|apply A].
  induction n as [|n [A B]]; [split; [apply Ccont_const|now apply gamma_continuous]|]. split; [exact B|].
  apply (Ccont_minus (fun v => (2 * gamma f g v * chebT (gamma f g v) (S n))%C)); [|exact A].
  apply (Ccont_mult (fun v => (2 * gamma f g v)%C)); [|exact B]. apply (Ccont_mult (fun _ => RtoC 2)); [apply Ccont_const|now apply gamma_continuous].
Qed.
Lemma amplitude_continuous f g N w : f < 0 -> g < 0 -> continuity_pt (amplitude f g N) w.
Proof.
  intros Hf Hg. apply continuity_pt_filterlim. set (T := fun v => chebT (gamma f g v) (S N)).
  assert (E : forall v : R, / sqrt (fst (T v) ^ 2 + snd (T v) ^ 2) = amplitude f g N v).
  { intros v. unfold amplitude. rewrite Cmod_inv by now apply cheb_neq0. reflexivity. }
  apply (continuous_ext _ _ _ E).
  - destruct (cheb_continuous f g (S N) w Hf Hg) as [A B]. fold T in A, B.
    apply (continuous_comp (fun v => sqrt (fst (T v) ^ 2 + snd (T v) ^ 2)) Rinv).
    + apply (continuous_comp (fun v => fst (T v) ^ 2 + snd (T v) ^ 2) sqrt); [|apply continuous_sqrt].
      apply (continuous_plus (fun v => fst (T v) ^ 2) (fun v => snd (T v) ^ 2)).
      * apply (continuous_comp (fun v => fst (T v)) (fun x => x ^ 2)); [exact A|apply (ex_derive_continuous (V := R_NormedModule)); auto_derive; easy].
      * apply (continuous_comp (fun v => snd (T v)) (fun x => x ^ 2)); [exact B|apply (ex_derive_continuous (V := R_NormedModule)); auto_derive; easy].
    + apply continuous_Rinv. change (Cmod (T w) <> 0). assert (0 < Cmod (T w)); [|lra]. apply Cmod_gt_0. now apply cheb_neq0.
Qed.
