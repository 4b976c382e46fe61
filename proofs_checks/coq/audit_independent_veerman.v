(* Clauses of the claims about Veerman's paper, formalised from their words before the theorems were looked at; the theorems
   prove them. *)
From Coq Require Import Reals Lra Lia List Psatz.
From Coquelicot Require Import Coquelicot.
From Flockproof Require veerman_complex veerman_front veerman_chain veerman_stability veerman_lemma1 veerman_numbers veerman_amplitude
  veerman_theorem1 veerman_unsettled.
Open Scope R_scope.

(* ---- systems (1), (2) on deviations: a leader 0 and followers 1, .., N + 1; rows of P_1, P_2 ---- *)
Definition p1 (x : nat -> C) (k : nat) : C := (x k - x (k - 1)%nat)%C.
Definition p2 (N : nat) (x : nat -> C) (k : nat) : C :=
  if Nat.eqb k (S N) then (x k - x (k - 1)%nat)%C else (x k - / 2 * (x (k - 1)%nat + x (k + 1)%nat))%C.
(* eigenvalue of a reduced matrix (x 0 = 0) and of M: x' = u, u' = f P x + g P u *)
Definition eig N (p : (nat -> C) -> nat -> C) (lam : C) := exists x : nat -> C, x 0%nat = 0%C /\ (exists k, (1 <= k <= S N)%nat /\ x k <> 0%C) /\
  forall k, (1 <= k <= S N)%nat -> p x k = (lam * x k)%C.
Definition eig_M N (p : (nat -> C) -> nat -> C) (f g : R) (nu : C) := exists x u : nat -> C, x 0%nat = 0%C /\ u 0%nat = 0%C /\
  (exists k, (1 <= k <= S N)%nat /\ (x k <> 0%C \/ u k <> 0%C)) /\
  forall k, (1 <= k <= S N)%nat -> u k = (nu * x k)%C /\ (RtoC f * p x k + RtoC g * p u k)%C = (nu * u k)%C.
Definition hurwitz N p f g := forall nu, eig_M N p f g nu -> fst nu < 0.
(* veerman.lem1 clauses 1, 2 *)
Definition lem1 : Prop := forall f g, ((forall N, hurwitz N p1 f g) <-> f < 0 /\ g < 0) /\ ((forall N, hurwitz N (p2 N) f g) <-> f < 0 /\ g < 0).
(* veerman.eigAK *)
Definition eigAK : Prop := forall (f g : R) (lam nu : C),
  ((exists a b : C, (a <> 0 \/ b <> 0)%C /\ b = (nu * a)%C /\ (lam * RtoC f * a + lam * RtoC g * b)%C = (nu * b)%C) <->
   (nu * nu - lam * RtoC g * nu - lam * RtoC f = 0)%C) /\
  forall s : C, (s * s)%C = ((lam * RtoC g) * (lam * RtoC g) + 4 * lam * RtoC f)%C ->
   ((nu * nu - lam * RtoC g * nu - lam * RtoC f = 0)%C <-> nu = (/ 2 * (lam * RtoC g + s))%C \/ nu = (/ 2 * (lam * RtoC g - s))%C).
(* veerman.specP2 *)
Definition specP2 : Prop := forall N,
  (forall lam, eig N (p2 N) lam <-> exists k, (1 <= k <= S N)%nat /\ lam = RtoC (1 - cos ((2 * INR k - 1) * PI / (2 * (INR N + 1))))) /\
  (forall k l, (1 <= k <= S N)%nat -> (1 <= l <= S N)%nat -> k <> l ->
     cos ((2 * INR k - 1) * PI / (2 * (INR N + 1))) <> cos ((2 * INR l - 1) * PI / (2 * (INR N + 1)))).
(* beyond.veerman.decay_rate clause 1 *)
Definition slowest N f g (r : R) := (exists nu, eig_M N (p2 N) f g nu /\ fst nu = - r) /\ forall nu, eig_M N (p2 N) f g nu -> fst nu <= - r.
Definition decay : Prop := forall f g N, f < 0 -> g < 0 -> INR N + 1 >= Rabs g / sqrt (Rabs f) ->
  slowest N f g (Rabs g * (1 - cos (PI / (2 * (INR N + 1)))) / 2).

(* ---- the responses to a leader e^{i w t}: amplitudes a_k, a_0 = 1 ---- *)
Definition z (f g w : R) : C := (f, w * g).
Definition response2 f g w N (a : nat -> C) := a 0%nat = 1%C /\ forall k, (1 <= k <= S N)%nat -> (- RtoC (w ^ 2) * a k = z f g w * p2 N a k)%C.
(* veerman.cor2 clause 2 *)
Definition cor2_2 : Prop := forall f g w, f < 0 -> g < 0 -> w <> 0 -> exists K q, 0 <= q < 1 /\
  forall N a, response2 f g w N a -> Cmod (a (S N)) <= K * q ^ N.
(* ---- the main resonance of system (2): the frequency w > 0 of the largest amplitude of the last car ---- *)
Definition size f g N w A := exists a, response2 f g w N a /\ Cmod (a (S N)) = A.
Definition peak f g N w A := 0 < w /\ size f g N w A /\ forall w' A', 0 < w' -> size f g N w' A' -> A' <= A.
(* veerman.thm1_omega, thm1_amp: there is a main resonance, and every one is there *)
Definition thm1 : Prop := forall f g, f < 0 -> g < 0 -> exists K N0, forall N, (N0 <= N)%nat -> (exists w A, peak f g N w A) /\
  forall w A, peak f g N w A ->
    Rabs (w - sqrt (Rabs f) * PI / ((INR N + 1) * 2 * sqrt 2)) <= K / INR N ^ 3 /\
    Rabs (A - 8 * sqrt (2 * Rabs f) / (PI ^ 2 * Rabs g) * (INR N + 1)) <= K / INR N.

(* ---- the theorems prove them ---- *)
Lemma eig_is N (p : (nat -> C) -> nat -> C) lam : p = p1 \/ p = p2 N ->
  eig N p lam <-> veerman_stability.eigenvalue N (veerman_stability.reduced p) lam.
Proof.
  intros Hp. assert (L : forall x y k, (1 <= k <= S N)%nat -> (forall j, (j <= S N)%nat -> x j = y j) -> p x k = p y k).
  { intros x y k Hk E. destruct Hp; subst p; unfold p1, p2; [rewrite !E by lia; reflexivity|].
    destruct (Nat.eqb_spec k (S N)); rewrite !E by lia; reflexivity. }
  split.
  - intros (x & X0 & X1 & X2). exists x. split; [exact X1|]. intros k Hk. unfold veerman_stability.reduced. rewrite <- (X2 k Hk).
    apply L; [exact Hk|]. intros [|j] _; [now rewrite X0|reflexivity].
  - intros (x & [k0 [K1 K2]] & X2). exists (fun j => match j with O => RtoC 0 | _ => x j end). split; [reflexivity|]. split.
    + exists k0. split; [exact K1|]. destruct k0; [lia|exact K2].
    + intros k Hk. destruct k; [lia|]. exact (X2 (S k) Hk).
Qed.
Lemma eig_M_is N (p : (nat -> C) -> nat -> C) f g nu : p = p1 \/ p = p2 N ->
  eig_M N p f g nu <-> veerman_stability.eigenvalue_M N (veerman_stability.reduced p) f g nu.
Proof.
  intros Hp. assert (L : forall x y k, (1 <= k <= S N)%nat -> (forall j, (j <= S N)%nat -> x j = y j) -> p x k = p y k).
  { intros x y k Hk E. destruct Hp; subst p; unfold p1, p2; [rewrite !E by lia; reflexivity|].
    destruct (Nat.eqb_spec k (S N)); rewrite !E by lia; reflexivity. }
  set (cut := fun (x : nat -> C) j => match j with O => RtoC 0 | _ => x j end). split.
  - intros (x & u & X0 & U0 & [k0 [K1 K2]] & E). exists x, u. split.
    + destruct K2; [left|right]; exists k0; split; assumption.
    + intros k Hk. destruct (E k Hk) as [E1 E2]. split; [exact E1|]. rewrite <- E2. unfold veerman_stability.reduced.
      rewrite (L (fun j => match j with O => RtoC 0 | _ => x j end) x k Hk), (L (fun j => match j with O => RtoC 0 | _ => u j end) u k Hk); [reflexivity| |];
        intros [|j] _; congruence.
  - intros (x & u & NZ & E). exists (cut x), (cut u). split; [reflexivity|]. split; [reflexivity|]. split.
    + destruct NZ as [[k0 [K1 K2]]|[k0 [K1 K2]]]; exists k0; (split; [exact K1|]); destruct k0; try lia; [left|right]; exact K2.
    + intros k Hk. destruct (E k Hk) as [E1 E2]. destruct k; [lia|]. split; [exact E1|exact E2].
Qed.
Lemma hurwitz_is N p f g : p = p1 \/ p = p2 N -> hurwitz N p f g <-> veerman_lemma1.stable N (veerman_stability.reduced p) f g.
Proof.
  intros Hp. unfold hurwitz, veerman_lemma1.stable. split; intros H nu E; apply H; now apply (eig_M_is N p f g nu Hp).
Qed.
Lemma lem1_proved : lem1.
Proof.
  intros f g. destruct (veerman_lemma1.lemma_1 f g) as (A & B & _).
  split; split.
  - intros H. apply (A 0%nat), (hurwitz_is 0 p1 f g (or_introl eq_refl)), H.
  - intros H N. apply (hurwitz_is N p1 f g (or_introl eq_refl)), A, H.
  - intros H. apply (B 0%nat), (hurwitz_is 0 (p2 0) f g (or_intror eq_refl)), H.
  - intros H N. apply (hurwitz_is N (p2 N) f g (or_intror eq_refl)), B, H.
Qed.
Lemma eigAK_proved : eigAK.
Proof.
  intros f g lam nu. destruct (veerman_lemma1.eigenvalues_AK f g lam) as [A B]. split; [exact (A nu)|].
  intros s Hs. rewrite <- (B nu s Hs). symmetry. exact (A nu).
Qed.
Lemma specP2_proved : specP2.
Proof.
  intros N. destruct (veerman_lemma1.spectrum_P2_whole N) as (A & B & _). split.
  - intros lam. rewrite (eig_is N (p2 N) lam (or_intror eq_refl)). rewrite (A lam). split; intros (k & Hk & E); exists k; (split; [exact Hk|]);
      rewrite E; apply injective_projections; cbn; ring.
  - intros k l Hk Hl Nkl E. apply (B k l Hk Hl Nkl). unfold veerman_stability.angle. now rewrite E.
Qed.
Lemma decay_proved : decay.
Proof.
  intros f g N Hf Hg H. destruct (veerman_unsettled.decay_rate f g Hf Hg) as (A & _). specialize (A N). rewrite S_INR in A.
  destruct (A ltac:(lra)) as (A1 & (nu & A2 & A3) & _). split.
  - exists nu. split; [now apply (eig_M_is N (p2 N) f g nu (or_intror eq_refl))|exact A3].
  - intros mu E. apply A1. now apply (eig_M_is N (p2 N) f g mu (or_intror eq_refl)).
Qed.
Lemma response_is f g w N a : response2 f g w N a <-> a 0%nat = RtoC 1 /\ veerman_chain.equation_2 f g w N a.
Proof.
  unfold response2, veerman_chain.equation_2. assert (Z : (- RtoC (w ^ 2))%C = RtoC (- w ^ 2)%R) by (apply injective_projections; cbn; ring).
  rewrite Z. split; intros [A0 H]; (split; [exact A0|]).
  - split.
    + intros k Hk. rewrite (H k ltac:(lia)). unfold p2. destruct (Nat.eqb_spec k (S N)); [lia|reflexivity].
    + rewrite (H (S N) ltac:(lia)). unfold p2. rewrite Nat.eqb_refl. replace (S N - 1)%nat with N by lia. reflexivity.
  - destruct H as [H1 H2]. intros k Hk. unfold p2. destruct (Nat.eqb_spec k (S N)) as [->|K].
    + replace (S N - 1)%nat with N by lia. exact H2.
    + apply H1. lia.
Qed.
Lemma size_is f g N w A : f < 0 -> g < 0 -> size f g N w A <-> A = veerman_amplitude.amplitude f g N w.
Proof.
  intros Hf Hg. destruct (veerman_amplitude.amplitude_spec f g N w Hf Hg) as [[a [A0 A1]] U]. split.
  - intros [b [B E]]. apply response_is in B. destruct B as [B0 B1]. rewrite <- E. now apply U.
  - intros ->. exists a. split; [now apply response_is|now apply U].
Qed.
Lemma peak_is f g N w A : f < 0 -> g < 0 -> peak f g N w A <-> veerman_amplitude.main_resonance f g N w /\ A = veerman_amplitude.amplitude f g N w.
Proof.
  intros Hf Hg. unfold peak, veerman_amplitude.main_resonance. rewrite (size_is f g N w A Hf Hg). split.
  - intros (W & E & M). split; [split; [exact W|]|exact E]. intros w' W'. rewrite <- E. apply (M w' _ W'). now apply size_is.
  - intros ((W & M) & E). split; [exact W|]. split; [exact E|]. intros w' A' W' S. apply size_is in S; try assumption. subst. now apply M.
Qed.
Lemma cor2_2_proved : cor2_2.
Proof.
  intros f g w Hf Hg Hw. destruct (veerman_chain.corollary_2 f g w Hf Hg Hw) as [_ [rho [R1 H]]].
  assert (P : 0 < / rho < 1). { split; [apply Rinv_0_lt_compat; lra|]. rewrite <- Rinv_1. apply Rinv_lt_contravar; lra. }
  exists (2 / (1 - / rho)), (/ rho). split; [lra|]. intros N a R. apply response_is in R. destruct R as [A0 E].
  destruct (H N a A0 E) as [_ L]. eapply Rle_trans; [exact L|].
  assert (Q : 0 < rho ^ S N) by (apply pow_lt; lra). assert (Q' : 1 <= rho ^ N) by (apply pow_R1_Rle; lra).
  assert (G : rho ^ S N - / rho ^ S N >= rho ^ N * (1 - / rho)).
  { cbn [pow]. rewrite Rinv_mult. assert (/ rho ^ N <= rho ^ N). { apply Rle_trans with 1; [|exact Q']. rewrite <- Rinv_1. apply Rinv_le_contravar; lra. }
    assert (0 < / rho ^ N) by (apply Rinv_0_lt_compat; lra). nra. }
  rewrite pow_inv. unfold Rdiv. rewrite Rmult_assoc, <- Rinv_mult. apply Rmult_le_compat_l; [lra|]. apply Rinv_le_contravar; [|].
  - apply Rmult_lt_0_compat; lra.
  - lra.
Qed.
Lemma thm1_proved : thm1.
Proof.
  intros f g Hf Hg. destruct (veerman_theorem1.theorem_1 f g Hf Hg) as (K & M0 & H).
  destruct (nfloor_ex (Rabs M0) (Rabs_pos M0)) as [n0 N0].
  exists (Rabs K), (S n0). intros N HN. assert (L : M0 <= INR (S N)).
  { apply Rle_trans with (Rabs M0); [apply Rle_abs|]. apply le_INR in HN. rewrite !S_INR in *. lra. }
  destruct (H N L) as [[w W] U]. assert (PN : 1 <= INR N) by (apply (le_INR 1); lia).
  assert (D : forall k, (1 <= k)%nat -> K / INR (S N) ^ k <= Rabs K / INR N ^ k).
  { intros k Hk. apply Rle_trans with (Rabs K / INR (S N) ^ k).
    - apply Rmult_le_compat_r; [left; apply Rinv_0_lt_compat, pow_lt; rewrite S_INR; lra|apply Rle_abs].
    - apply Rmult_le_compat_l; [apply Rabs_pos|]. apply Rinv_le_contravar; [apply pow_lt; lra|]. apply pow_incr. rewrite S_INR. lra. }
  split.
  - exists w, (veerman_amplitude.amplitude f g N w). now apply peak_is.
  - intros w' A' P. apply peak_is in P; try assumption. destruct P as [P ->]. destruct (U w' P) as [U1 U2].
    unfold veerman_numbers.frequency, veerman_numbers.amplitude in *. rewrite S_INR in U1 at 1. rewrite S_INR in U2 at 1. split.
    + eapply Rle_trans; [exact U1|]. now apply (D 3%nat ltac:(lia)).
    + eapply Rle_trans; [exact U2|]. pose proof (D 1%nat ltac:(lia)) as D1. rewrite !pow_1 in D1. exact D1.
Qed.
