(* Clauses of the claims about Veerman's paper, formalised from their words before the theorems were looked at; the theorems
   prove them. *)
From Coq Require Import Reals Lra Lia List Relations Psatz.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums paley_model paley_phase.
From Flockproof Require veerman_complex veerman_front veerman_chain veerman_stability veerman_lemma1 veerman_numbers veerman_amplitude
  veerman_theorem1 veerman_unsettled veerman_lesser veerman_exponent veerman_size_limit tanner_energy.
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
(* veerman.specM clauses 3, 4 *)
Definition specM : Prop := forall N p (f g : R), p = p1 \/ p = p2 N ->
  (forall nu, eig_M N p f g nu <-> exists lam, eig N p lam /\ (nu * nu - lam * RtoC g * nu - lam * RtoC f = 0)%C) /\
  (f <> 0 -> ~ eig_M N p f g 0%C).
(* veerman.specP2 *)
Definition specP2 : Prop := forall N,
  (forall lam, eig N (p2 N) lam <-> exists k, (1 <= k <= S N)%nat /\ lam = RtoC (1 - cos ((2 * INR k - 1) * PI / (2 * (INR N + 1))))) /\
  (forall k l, (1 <= k <= S N)%nat -> (1 <= l <= S N)%nat -> k <> l ->
     cos ((2 * INR k - 1) * PI / (2 * (INR N + 1))) <> cos ((2 * INR l - 1) * PI / (2 * (INR N + 1)))).
(* beyond.veerman.decay_rate clauses 1 to 4 *)
Definition slowest N f g (r : R) := (exists nu, eig_M N (p2 N) f g nu /\ fst nu = - r) /\ forall nu, eig_M N (p2 N) f g nu -> fst nu <= - r.
Definition decay : Prop := forall f g, f < 0 -> g < 0 ->
  (forall N, INR N + 1 >= Rabs g / sqrt (Rabs f) -> slowest N f g (Rabs g * (1 - cos (PI / (2 * (INR N + 1)))) / 2)) /\
  (forall N, Rabs g * (1 - cos (PI / (2 * (INR N + 1)))) / 2 < PI ^ 2 * Rabs g / (16 * (INR N + 1) ^ 2)) /\
  (forall N, hurwitz N (p2 N) f g) /\
  ~ exists r, 0 < r /\ forall N nu, eig_M N (p2 N) f g nu -> fst nu <= - r.

(* ---- the responses to a leader e^{i w t}: amplitudes a_k, a_0 = 1 ---- *)
Definition z (f g w : R) : C := (f, w * g).
Definition response1 f g w (a : nat -> C) := a 0%nat = 1%C /\ forall k, (1 <= k)%nat -> (- RtoC (w ^ 2) * a k = z f g w * p1 a k)%C.
Definition response2 f g w N (a : nat -> C) := a 0%nat = 1%C /\ forall k, (1 <= k <= S N)%nat -> (- RtoC (w ^ 2) * a k = z f g w * p2 N a k)%C.
Definition gam f g w : C := ((z f g w + RtoC (w ^ 2)) / z f g w)%C.
Fixpoint power (x : C) n : C := match n with O => 1%C | S n => (x * power x n)%C end.
(* veerman.cor1, veerman.cor1_special *)
Definition cor1 : Prop := forall f g w a, z f g w <> 0%C -> gam f g w <> 0%C ->
  (response1 f g w a <-> a 0%nat = 1%C /\ forall k, a k = (/ power (gam f g w) k)%C).
Definition cor1_special : Prop := forall f g w a, f < 0 -> g < 0 -> w = sqrt (Rabs f) -> response1 f g w a ->
  forall k, a k = power (1 + Ci * RtoC (sqrt (Rabs f) / g))%C k.
(* veerman.gain_iff clauses 3, 4; veerman.gain_max clauses 2, 3, 4 *)
Definition gain_iff : Prop := forall f g w, f < 0 -> g < 0 -> 0 <= w -> (1 < Cmod (/ gam f g w)%C <-> 0 < w ^ 2 < 2 * Rabs f).
Definition gain_max : Prop := forall f g, f < 0 -> g < 0 ->
  let s := f ^ 2 / g ^ 2 * (sqrt (1 + 2 * g ^ 2 / Rabs f) - 1) in
  (forall w, 0 <= w -> (w ^ 2 = s <-> forall w', 0 <= w' -> Cmod (/ gam f g w')%C <= Cmod (/ gam f g w)%C)) /\ 0 < s < Rabs f.
(* veerman.lem2; the square root of gamma^2 - 1 enters by its square *)
Definition lem2 : Prop := forall f g w N a mp mm, f < 0 -> g < 0 -> 0 < w -> response2 f g w N a ->
  (mp + mm = 2 * gam f g w)%C -> (mp * mm = 1)%C ->
  (a (S N) * (power mm (S N) + power mp (S N)) = 2)%C.
(* veerman.lem2_eigvec clause 5 left out; veerman.cor2 *)
Definition cor2_1 : Prop := forall f g w mp mm, f < 0 -> g < 0 -> w <> 0 -> (mp + mm = 2 * gam f g w)%C -> (mp * mm = 1)%C -> Cmod mp <> Cmod mm.
Definition cor2_2 : Prop := forall f g w, f < 0 -> g < 0 -> w <> 0 -> exists K q, 0 <= q < 1 /\
  forall N a, response2 f g w N a -> Cmod (a (S N)) <= K * q ^ N.
(* ---- the main resonance of system (2): the frequency w > 0 of the largest amplitude of the last car ---- *)
Definition size f g N w A := exists a, response2 f g w N a /\ Cmod (a (S N)) = A.
Definition peak f g N w A := 0 < w /\ size f g N w A /\ forall w' A', 0 < w' -> size f g N w' A' -> A' <= A.
(* veerman.thm1_omega, thm1_amp, thm1_x clauses 3, 4: there is a main resonance, and every one is there *)
Definition thm1 : Prop := forall f g, f < 0 -> g < 0 -> exists K N0, forall N, (N0 <= N)%nat -> (exists w A, peak f g N w A) /\
  forall w A, peak f g N w A ->
    Rabs (w - sqrt (Rabs f) * PI / ((INR N + 1) * 2 * sqrt 2)) <= K / INR N ^ 3 /\
    Rabs (A - 8 * sqrt (2 * Rabs f) / (PI ^ 2 * Rabs g) * (INR N + 1)) <= K / INR N.
Definition thm1_x : Prop := forall f g, f < 0 -> g < 0 -> let x := PI ^ 2 * Rabs g / (8 * sqrt 2 * sqrt (Rabs f)) in
  exists K N0, forall N, (N0 <= N)%nat -> forall w A, peak f g N w A -> Rabs (A - (INR N + 1) / x) <= K / INR N /\
  forall mp mm, (mp + mm = 2 * gam f g w)%C -> (mp * mm = 1)%C -> Cmod mm <= Cmod mp ->
    Rabs (Cmod mp ^ S N - exp (x / (INR N + 1))) <= K / INR N ^ 3 /\ Rabs (Cmod mm ^ S N - exp (- x / (INR N + 1))) <= K / INR N ^ 3.
(* veerman.thm1_mod *)
Definition thm1_mod : Prop := forall f g, f < 0 -> g < 0 -> exists K e, 0 < e /\ forall w mp mm, 0 < w < e ->
  (mp + mm = 2 * gam f g w)%C -> (mp * mm = 1)%C -> Cmod mm <= Cmod mp ->
  Rabs (Cmod mp ^ 2 - (1 + sqrt 2 * w ^ 2 * Rabs g / (Rabs f * sqrt (Rabs f)))) <= K * w ^ 4 /\
  Rabs (Cmod mm ^ 2 - (1 - sqrt 2 * w ^ 2 * Rabs g / (Rabs f * sqrt (Rabs f)))) <= K * w ^ 4.
(* veerman.lem3 *)
Definition lem3 : Prop := forall f g (w : nat -> R) A, f < 0 -> g < 0 -> 0 < A ->
  (forall N, exists B, size f g N (w N) B /\ A <= B) -> is_lim_seq w 0.
(* veerman.cor3 clause 1: local maxima of the amplitude near (2k+1) times the main resonance *)
Definition cor3 : Prop := forall f g k, f < 0 -> g < 0 -> forall e, 0 < e -> exists N0, forall N, (N0 <= N)%nat ->
  forall w0 A0, peak f g N w0 A0 -> exists w A, Rabs (w - (2 * INR k + 1) * w0) <= e * w0 /\ size f g N w A /\
    exists r, 0 < r /\ forall w' A', Rabs (w' - w) < r -> size f g N w' A' -> A' <= A.
(* veerman.prop1 clauses 2, 3 *)
Definition prop1 : Prop := forall f g a0 D N a, f < 0 -> g < 0 -> 0 < a0 -> 0 < D -> response1 f g (sqrt (Rabs f)) a ->
  (a0 * Cmod (a (S N)) <= D <-> INR N + 1 <= 2 * ln (D / a0) / ln (1 + Rabs f / g ^ 2)).
(* veerman.prop2: N <= X D/a0 + o(D/a0) *)
Definition prop2 : Prop := forall f g, f < 0 -> g < 0 -> forall e, 0 < e -> exists Y, forall a0 D N w A, 0 < a0 -> 0 < D -> Y <= D / a0 ->
  peak f g N w A -> a0 * A <= D -> INR N <= (PI ^ 2 * Rabs g / (8 * sqrt 2 * sqrt (Rabs f)) + e) * (D / a0).

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
Lemma specM_proved : specM.
Proof.
  intros N p f g Hp.
  assert (Q : veerman_stability.local N (veerman_stability.reduced p) /\ veerman_lemma1.positive_spectrum N (veerman_stability.reduced p)).
  { destruct Hp; subst p; split; [exact (veerman_stability.local1 N)|exact (veerman_lemma1.positive_P1 N)|exact (veerman_stability.local2 N)|exact (veerman_lemma1.positive_P2 N)]. }
  destruct Q as [L [EX POS]].
  assert (E : forall nu, eig_M N p f g nu <-> exists lam, eig N p lam /\ (nu * nu - lam * RtoC g * nu - lam * RtoC f = 0)%C).
  { intros nu. rewrite (eig_M_is N p f g nu Hp), (veerman_stability.spectrum_M N _ f g nu L EX).
    split; intros (lam & A & B); exists lam; (split; [now apply (eig_is N p lam Hp)|]); now apply (proj1 (eigAK_proved f g lam nu)). }
  split; [exact E|]. intros Hf H. apply E in H. destruct H as (lam & A & B). apply (eig_is N p lam Hp) in A.
  destruct (POS lam A) as (r & R0 & ->). apply (f_equal fst) in B. cbn in B. assert (r * f = 0) by lra.
  apply Rmult_integral in H as [H|H]; lra.
Qed.
Lemma decay_proved : decay.
Proof.
  intros f g Hf Hg. destruct (veerman_unsettled.decay_rate f g Hf Hg) as (A & B & D). split; [|split; [|split]].
  - intros N H. specialize (A N). rewrite S_INR in A. destruct (A ltac:(lra)) as (A1 & (nu & A2 & A3) & _). split.
    + exists nu. split; [now apply (eig_M_is N (p2 N) f g nu (or_intror eq_refl))|exact A3].
    + intros mu E. apply A1. now apply (eig_M_is N (p2 N) f g mu (or_intror eq_refl)).
  - intros N. pose proof (pos_INR N) as P. pose proof PI_RGT_0 as P0. set (x := PI / (2 * (INR N + 1))).
    assert (X : 0 < x) by (apply Rdiv_lt_0_compat; lra). assert (G : 0 < Rabs g) by (apply Rabs_pos_lt; lra).
    replace (PI ^ 2 * Rabs g / (16 * (INR N + 1) ^ 2)) with (Rabs g * (x ^ 2 / 2) / 2) by (unfold x; field; lra).
    assert (C : 1 - cos x < x ^ 2 / 2); [|nra].
    replace x with (2 * (x / 2)) by field. rewrite cos_2a_sin. assert (S : Rabs (sin (x / 2)) < x / 2).
    { assert (L : x / 2 <= PI). { unfold x. apply Rmult_le_reg_r with (2 * (2 * (INR N + 1))); [lra|]. replace (PI / (2 * (INR N + 1)) / 2 * (2 * (2 * (INR N + 1)))) with PI by (field; lra). nra. }
      rewrite Rabs_pos_eq by (apply sin_ge_0; lra). apply sin_lt_x. lra. }
    pose proof (Rabs_pos (sin (x / 2))) as S0. assert (sin (x / 2) * sin (x / 2) < x / 2 * (x / 2)); [|nra].
    replace (sin (x / 2) * sin (x / 2)) with (Rabs (sin (x / 2)) * Rabs (sin (x / 2))); [nra|].
    rewrite <- Rabs_mult. apply Rabs_pos_eq. nra.
  - intros N. apply (hurwitz_is N (p2 N) f g (or_intror eq_refl)), B.
  - intros (r & R0 & H). destruct (D r R0) as (N & nu & E & L). apply (eig_M_is N (p2 N) f g nu (or_intror eq_refl)) in E.
    specialize (H N nu E). lra.
Qed.
(* the square roots enter through their sum and product *)
Lemma gam_is f g w : gam f g w = veerman_front.gamma f g w.
Proof. unfold gam, z, veerman_front.gamma, veerman_front.num, veerman_front.den. f_equal. apply injective_projections; cbn; ring. Qed.
Lemma power_is x n : power x n = veerman_complex.Cpw x n.
Proof. induction n as [|n IH]; cbn; [reflexivity|now rewrite IH]. Qed.
Lemma pair_is f g w mp mm : (mp + mm = 2 * gam f g w)%C -> (mp * mm = 1)%C ->
  let G := veerman_front.gamma f g w in
  (mp = veerman_chain.mu_plus G /\ mm = veerman_chain.mu_minus G) \/ (mp = veerman_chain.mu_minus G /\ mm = veerman_chain.mu_plus G).
Proof.
  intros S P G. rewrite gam_is in S. fold G in S. pose proof (veerman_chain.mu_sum G) as S'. pose proof (veerman_chain.mu_product G) as P'.
  set (a := veerman_chain.mu_plus G) in *. set (b := veerman_chain.mu_minus G) in *.
  assert (Z : ((mp - a) * (mp - b) = 0)%C).
  { replace ((mp - a) * (mp - b))%C with (mp * mp - (a + b) * mp + a * b)%C by ring. rewrite S', <- S, P', <- P. ring. }
  assert (M : (mm = a + b - mp)%C) by (rewrite S', <- S; ring).
  destruct (Ceq_dec (mp - a)%C 0%C) as [E|E].
  - left. assert (A : mp = a) by (replace mp with (mp - a + a)%C by ring; rewrite E; ring). split; [exact A|]. rewrite M, A. ring.
  - right. destruct (Ceq_dec (mp - b)%C 0%C) as [E'|E'].
    + assert (A : mp = b) by (replace mp with (mp - b + b)%C by ring; rewrite E'; ring). split; [exact A|]. rewrite M, A. ring.
    + exfalso. exact (Cmult_neq_0 _ _ E E' Z).
Qed.
(* the amplitudes behind the leader: response1 is equation (1) for the waves *)
Lemma response1_is f g w h a : response1 f g w a <->
  a 0%nat = RtoC 1 /\ veerman_front.equation_1 f g h (veerman_front.wave_x h a w) (veerman_front.wave_u a w).
Proof.
  unfold response1. rewrite veerman_front.substitution. split; intros [A0 H]; (split; [exact A0|]).
  - intros k. specialize (H (S k) ltac:(lia)). unfold p1 in H. replace (S k - 1)%nat with k in H by lia.
    replace (RtoC (- w ^ 2)) with (- RtoC (w ^ 2))%C by (apply injective_projections; cbn; ring). rewrite H.
    unfold z. apply injective_projections; cbn; ring.
  - intros [|k] Hk; [lia|]. specialize (H k). unfold p1. replace (S k - 1)%nat with k by lia.
    replace (- RtoC (w ^ 2))%C with (RtoC (- w ^ 2)) by (apply injective_projections; cbn; ring). rewrite H.
    unfold z. apply injective_projections; cbn; ring.
Qed.
Lemma cor1_stable f g w a : f < 0 -> g < 0 -> (response1 f g w a <-> a 0%nat = 1%C /\ forall k, a k = (/ power (gam f g w) k)%C).
Proof.
  intros Hf Hg. rewrite (response1_is f g w (fun _ => 0) a).
  assert (N : veerman_front.gamma f g w <> 0%C).
  { pose proof (veerman_front.num_neq0 f g w Hf Hg). pose proof (veerman_front.den_neq0 f g w Hf). unfold veerman_front.gamma, Cdiv.
    apply Cmult_neq_0; [assumption|]. intros E. apply veerman_complex.C1_neq0. rewrite <- (Cinv_r (veerman_front.den f g w)) by assumption. rewrite E. ring. }
  split; intros [A0 H]; (split; [exact A0|]).
  - pose proof (proj1 (veerman_front.corollary_1 f g (fun _ => 0) a w Hf Hg A0) H) as H'. intros k. rewrite H', (power_is (gam f g w)), gam_is. now apply veerman_complex.Cpw_inv.
  - apply (proj2 (veerman_front.corollary_1 f g (fun _ => 0) a w Hf Hg A0)). intros k. rewrite H, (power_is (gam f g w)), gam_is. symmetry. now apply veerman_complex.Cpw_inv.
Qed.
Lemma cor1_proved : cor1.
Proof.
  intros f g w a Z G. assert (ZG : (z f g w * gam f g w = z f g w + RtoC (w ^ 2))%C) by (unfold gam; field; exact Z).
  assert (NP : forall k, power (gam f g w) k <> 0%C) by (intros k; rewrite power_is; now apply veerman_complex.Cpw_neq0).
  assert (E : forall x y, (- RtoC (w ^ 2) * x = z f g w * (x - y))%C <-> (gam f g w * x = y)%C).
  { intros x y. split; intros H.
    - apply (veerman_complex.Cmult_cancel_r _ _ (z f g w) Z). replace (gam f g w * x * z f g w)%C with ((z f g w * gam f g w) * x)%C by ring.
      rewrite ZG. replace ((z f g w + RtoC (w ^ 2)) * x)%C with (z f g w * x - (- RtoC (w ^ 2) * x))%C by ring. rewrite H. ring.
    - subst y. replace (z f g w * (x - gam f g w * x))%C with (z f g w * x - (z f g w * gam f g w) * x)%C by ring. rewrite ZG. ring. }
  split; intros [A0 H]; (split; [exact A0|]).
  - intros k. induction k as [|k IH]; [rewrite A0; cbn; field; exact veerman_complex.C1_neq0|].
    specialize (H (S k) ltac:(lia)). unfold p1 in H. replace (S k - 1)%nat with k in H by lia. apply E in H. cbn [power].
    rewrite IH in H. apply (veerman_complex.Cmult_cancel_r _ _ _ G). rewrite (Cmult_comm (a (S k))), H. field. split; [apply NP|exact G].
  - intros [|k] Hk; [lia|]. unfold p1. replace (S k - 1)%nat with k by lia. apply E. rewrite !H. cbn [power]. field. split; [apply NP|exact G].
Qed.
Lemma cor1_special_proved : cor1_special.
Proof.
  intros f g w a Hf Hg -> H k. apply (cor1_stable f g _ a Hf Hg) in H. destruct H as [_ H]. rewrite H, (power_is (gam f g _)), (power_is (1 + _)%C), gam_is.
  assert (E1 : (1 + Ci * RtoC (sqrt (Rabs f) / g))%C = ((1, sqrt (Rabs f) / g) : C)) by (apply injective_projections; cbn; ring). rewrite E1.
  rewrite <- veerman_complex.Cpw_inv.
  - exact (veerman_front.corollary_1_special f g k Hf Hg).
  - pose proof (veerman_front.num_neq0 f g (sqrt (Rabs f)) Hf Hg). pose proof (veerman_front.den_neq0 f g (sqrt (Rabs f)) Hf). unfold veerman_front.gamma, Cdiv.
    apply Cmult_neq_0; [assumption|]. intros E. apply veerman_complex.C1_neq0. rewrite <- (Cinv_r (veerman_front.den f g (sqrt (Rabs f)))) by assumption. rewrite E. ring.
Qed.
Lemma gain_iff_proved : gain_iff.
Proof. intros f g w Hf Hg _. rewrite gam_is. exact (veerman_front.gain_above_one f g w Hf Hg). Qed.
Lemma gain_even f g w : f < 0 -> g < 0 -> Cmod (/ veerman_front.gamma f g (Rabs w))%C = Cmod (/ veerman_front.gamma f g w)%C.
Proof.
  intros Hf Hg. apply Rsqr_inj; try apply Cmod_ge_0. rewrite !Rsqr_pow2, !veerman_front.gain2_spec by assumption.
  unfold veerman_front.gain2. rewrite !Rpow_mult_distr, <- !(Rsqr_pow2 (Rabs w)), <- Rsqr_abs, Rsqr_pow2. reflexivity.
Qed.
Lemma gain_max_proved : gain_max.
Proof.
  intros f g Hf Hg s. split.
  - intros w Hw. destruct (veerman_front.gain_strongest f g w Hf Hg) as (_ & A & B). change (veerman_front.strongest f g) with s in A, B. split.
    + intros E w' _. rewrite !gam_is. now apply A.
    + intros H. destruct (Req_dec (w ^ 2) s) as [E|E]; [exact E|]. exfalso. destruct (B E) as [w' L].
      specialize (H (Rabs w') (Rabs_pos w')). rewrite !gam_is, gain_even in H by assumption. lra.
  - destruct (veerman_front.strongest_root f g Hf Hg) as [A _]. change (veerman_front.strongest f g) with s in A. rewrite Rabs_left by exact Hf. exact A.
Qed.
Lemma lem2_proved : lem2.
Proof.
  intros f g w N a mp mm Hf Hg _ R E1 P. apply response_is in R. destruct R as [A0 E].
  destruct (veerman_chain.lemma_2 f g w N a Hf Hg A0 E) as [_ Q].
  pose proof (veerman_chain.denominator_neq0 f g w (S N) Hf Hg) as D. rewrite Q, (power_is mm), (power_is mp).
  destruct (pair_is f g w mp mm E1 P) as [[-> ->]|[-> ->]]; field; [exact D|].
  intros Z. apply D. rewrite <- Z. ring.
Qed.
Lemma cor2_1_proved : cor2_1.
Proof.
  intros f g w mp mm Hf Hg Hw E1 P. destruct (veerman_chain.corollary_2 f g w Hf Hg Hw) as [A _]. cbv zeta in A.
  destruct (pair_is f g w mp mm E1 P) as [[-> ->]|[-> ->]]; [exact A|]. intros E. apply A. now symmetry.
Qed.
(* the number of followers from which the bounds hold *)
Lemma from_some (M0 : R) : exists N0, forall N, (N0 <= N)%nat -> M0 <= INR (S N).
Proof.
  destruct (nfloor_ex (Rabs M0) (Rabs_pos M0)) as [n0 N0]. exists n0. intros N HN. apply Rle_trans with (Rabs M0); [apply Rle_abs|].
  apply le_INR in HN. rewrite S_INR. lra.
Qed.
Lemma bound_at (K : R) N k : (1 <= N)%nat -> K / INR (S N) ^ k <= Rabs K / INR N ^ k.
Proof.
  intros HN. assert (PN : 1 <= INR N) by (apply (le_INR 1); lia). apply Rle_trans with (Rabs K / INR (S N) ^ k).
  - apply Rmult_le_compat_r; [left; apply Rinv_0_lt_compat, pow_lt; rewrite S_INR; lra|apply Rle_abs].
  - apply Rmult_le_compat_l; [apply Rabs_pos|]. apply Rinv_le_contravar; [apply pow_lt; lra|]. apply pow_incr. rewrite S_INR. lra.
Qed.
Lemma cor3_proved : cor3.
Proof.
  intros f g k Hf Hg e He. destruct (veerman_lesser.corollary_3 f g (S k) e Hf Hg ltac:(lia) He) as [M0 H].
  destruct (from_some M0) as [N0 F]. exists N0. intros N HN w0 A0 P. apply peak_is in P; try assumption. destruct P as [P _].
  destruct (H N (F N HN) w0 P) as (w & W & D & r & R & L). destruct P as [P _].
  exists w, (veerman_amplitude.amplitude f g N w). split; [|split; [now apply size_is|]].
  - rewrite S_INR in D. replace (w - (2 * INR k + 1) * w0) with ((w / w0 - (2 * (INR k + 1) - 1)) * w0) by (field; lra).
    rewrite Rabs_mult, (Rabs_pos_eq w0) by lra. apply Rmult_le_compat_r; [lra|exact D].
  - exists r. split; [exact R|]. intros w' A' V S. apply size_is in S; try assumption. rewrite S. now apply L.
Qed.
Lemma prop1_proved : prop1.
Proof.
  intros f g a0 D N a Hf Hg Ha HD R. apply (cor1_stable f g _ a Hf Hg) in R. destruct R as [A0 R].
  pose proof (veerman_front.proposition_1 f g a0 D N Hf Hg Ha HD) as P. cbv zeta in P. rewrite S_INR in P.
  rewrite (R (S N)), (power_is (gam f g _)), gam_is, <- veerman_complex.Cpw_inv; [exact P|].
  pose proof (veerman_front.num_neq0 f g (sqrt (Rabs f)) Hf Hg). pose proof (veerman_front.den_neq0 f g (sqrt (Rabs f)) Hf). unfold veerman_front.gamma, Cdiv.
  apply Cmult_neq_0; [assumption|]. intros E. apply veerman_complex.C1_neq0. rewrite <- (Cinv_r (veerman_front.den f g (sqrt (Rabs f)))) by assumption. rewrite E. ring.
Qed.
Lemma prop2_proved : prop2.
Proof.
  intros f g Hf Hg e He. set (X := PI ^ 2 * Rabs g / (8 * sqrt 2 * sqrt (Rabs f))).
  destruct (veerman_size_limit.proposition_2 f g Hf Hg) as (K & M0 & H). fold X in H.
  assert (X0 : 0 <= X).
  { unfold X. apply Rmult_le_pos; [apply Rmult_le_pos; [apply pow2_ge_0|apply Rabs_pos]|]. left. apply Rinv_0_lt_compat.
    assert (0 < sqrt 2) by (apply sqrt_lt_R0; lra). assert (0 < sqrt (Rabs f)) by (apply sqrt_lt_R0, Rabs_pos_lt; lra). nra. }
  exists (Rabs M0 / e). intros a0 D N w A Ha HD Y P B. apply peak_is in P; try assumption. destruct P as [P ->].
  assert (Q : 0 < D / a0) by (apply Rdiv_lt_0_compat; lra).
  destruct (Rle_lt_dec M0 (INR (S N))) as [L|L].
  - destruct (H N a0 D w L Ha P) as (_ & _ & T). specialize (T B). nra.
  - apply Rle_trans with (Rabs M0). { pose proof (Rle_abs M0). rewrite S_INR in L. lra. }
    assert (Rabs M0 <= e * (D / a0)); [|nra]. apply (Rmult_le_compat_l e) in Y; [|lra].
    replace (e * (Rabs M0 / e)) with (Rabs M0) in Y by (field; lra). exact Y.
Qed.
(* the larger root is mu_plus where its modulus is *)
Lemma ordered_pair f g w mp mm : let G := veerman_front.gamma f g w in Cmod (veerman_chain.mu_minus G) < Cmod (veerman_chain.mu_plus G) ->
  (mp + mm = 2 * gam f g w)%C -> (mp * mm = 1)%C -> Cmod mm <= Cmod mp -> mp = veerman_chain.mu_plus G /\ mm = veerman_chain.mu_minus G.
Proof.
  intros G L S P O. destruct (pair_is f g w mp mm S P) as [[-> ->]|[-> ->]]; [now split|]. exfalso. unfold G in L. lra.
Qed.
Lemma thm1_mod_proved : thm1_mod.
Proof.
  intros f g Hf Hg. destruct (veerman_exponent.moduli f g Hf Hg) as (K & small & Hs & H). cbv zeta in H.
  set (c := sqrt 2 * Rabs g / (Rabs f * sqrt (Rabs f))).
  assert (c0 : 0 < c).
  { unfold c. assert (0 < sqrt 2) by (apply sqrt_lt_R0; lra). assert (0 < Rabs f) by (apply Rabs_pos_lt; lra). assert (0 < Rabs g) by (apply Rabs_pos_lt; lra).
    assert (0 < sqrt (Rabs f)) by (apply sqrt_lt_R0; lra). apply Rdiv_lt_0_compat; nra. }
  pose proof (Rabs_pos K) as K0. pose proof (Rle_abs K) as K1.
  set (q := sqrt (c / (Rabs K + 1))). assert (q0 : 0 < q) by (apply sqrt_lt_R0, Rdiv_lt_0_compat; lra).
  exists K, (Rmin small q). split; [now apply Rmin_glb_lt|]. intros w mp mm [W0 W1] S P O.
  pose proof (Rmin_l small q). pose proof (Rmin_r small q). destruct (H w ltac:(lra)) as [A B].
  replace (sqrt 2 * w ^ 2 * Rabs g / (Rabs f * sqrt (Rabs f))) with (c * w ^ 2) in A, B |- *.
  2: { unfold c. field. split; [apply Rgt_not_eq, sqrt_lt_R0, Rabs_pos_lt; lra|apply Rabs_no_R0; lra]. }
  assert (L : Cmod (veerman_chain.mu_minus (veerman_front.gamma f g w)) < Cmod (veerman_chain.mu_plus (veerman_front.gamma f g w))).
  { apply Rsqr_incrst_0; try apply Cmod_ge_0. rewrite !Rsqr_pow2. apply Rabs_le_between in A. apply Rabs_le_between in B.
    assert (Q : w ^ 2 < c / (Rabs K + 1)).
    { replace (c / (Rabs K + 1)) with (q ^ 2) by (unfold q; apply pow2_sqrt; left; apply Rdiv_lt_0_compat; lra). nra. }
    assert (w2 : 0 < w ^ 2) by (apply pow_lt; lra).
    assert (Q' : w ^ 2 * (Rabs K + 1) < c). { apply (Rmult_lt_compat_r (Rabs K + 1)) in Q; [|lra]. replace (c / (Rabs K + 1) * (Rabs K + 1)) with c in Q by (field; lra). exact Q. }
    assert (K * w ^ 4 < c * w ^ 2); [|lra]. replace (K * w ^ 4) with (K * w ^ 2 * w ^ 2) by ring. apply Rmult_lt_compat_r; [exact w2|]. nra. }
  destruct (ordered_pair f g w mp mm L S P O) as [-> ->]. split; assumption.
Qed.
Lemma thm1_x_proved : thm1_x.
Proof.
  intros f g Hf Hg x. destruct (veerman_exponent.exponent f g Hf Hg) as (K & M0 & H). fold x in H.
  assert (x0 : 0 < x).
  { unfold x. assert (0 < sqrt 2) by (apply sqrt_lt_R0; lra). assert (0 < Rabs g) by (apply Rabs_pos_lt; lra).
    assert (0 < sqrt (Rabs f)) by (apply sqrt_lt_R0, Rabs_pos_lt; lra). pose proof PI_RGT_0. apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat; [apply pow_lt|]; lra|nra]. }
  pose proof (Rabs_pos K) as K0. pose proof (Rle_abs K) as K1.
  destruct (from_some M0) as [N1 F1]. destruct (from_some (Rmax 1 ((Rabs K + 1) / x))) as [N2 F2].
  exists (Rabs K), (S (N1 + N2)). intros N HN w A P. specialize (F1 N ltac:(lia)). specialize (F2 N ltac:(lia)).
  apply peak_is in P; try assumption. destruct P as [P ->]. destruct (H N w F1 P) as (A1 & A2 & A3).
  pose proof (Rmax_l 1 ((Rabs K + 1) / x)) as R1. pose proof (Rmax_r 1 ((Rabs K + 1) / x)) as R2. set (M := INR (S N)) in *.
  assert (MM : M = INR N + 1) by (unfold M; apply S_INR). assert (N1' : (1 <= N)%nat) by lia.
  pose proof (bound_at K N 3 N1') as B3. pose proof (bound_at K N 1 N1') as B1. rewrite !pow_1 in B1. fold M in B3, B1.
  split; [rewrite <- MM; lra|]. intros mp mm S' P' O.
  assert (L : Cmod (veerman_chain.mu_minus (veerman_front.gamma f g w)) < Cmod (veerman_chain.mu_plus (veerman_front.gamma f g w))).
  { apply Rnot_le_lt. intros Le. assert (Le' := pow_incr _ _ (S N) (conj (Cmod_ge_0 _) Le)).
    apply Rabs_le_between in A1. apply Rabs_le_between in A2.
    assert (X1 : 1 + x / M < exp (x / M)) by (apply exp_ineq1, Rgt_not_eq, Rdiv_lt_0_compat; lra).
    assert (X2 : exp (- (x / M)) < 1). { rewrite <- exp_0. apply exp_increasing. assert (0 < x / M) by (apply Rdiv_lt_0_compat; lra). lra. }
    assert (G : 2 * (K / M ^ 3) <= x / M).
    { assert (M2 : M <= M ^ 2) by nra. assert (KM : Rabs K + 1 <= x * M).
      { apply (Rmult_le_compat_l x) in R2; [|lra]. replace (x * ((Rabs K + 1) / x)) with (Rabs K + 1) in R2 by (field; lra). nra. }
      apply Rmult_le_reg_r with (M ^ 3); [apply pow_lt; lra|]. replace (2 * (K / M ^ 3) * M ^ 3) with (2 * K) by (field; lra).
      replace (x / M * M ^ 3) with (x * M * M) by (field; lra). assert (2 <= M); [|nra].
      rewrite MM. pose proof (le_INR 1 N N1') as Q. cbn in Q. lra. }
    lra. }
  destruct (ordered_pair f g w mp mm L S' P' O) as [-> ->]. rewrite <- MM. replace (- x / M) with (- (x / M)) by (unfold Rdiv; ring).
  split; lra.
Qed.
(* negative frequencies are those of the conjugate responses *)
Lemma response2_conj f g w N a : response2 f g w N a -> response2 f g (- w) N (fun k => Cconj (a k)).
Proof.
  assert (K : forall k, (a k = 1)%C -> (Cconj (a k) = 1)%C) by (intros k ->; apply injective_projections; cbn; ring).
  intros [A0 H]. split; [now apply K|]. intros k Hk. specialize (H k Hk).
  assert (E1 := f_equal fst H). assert (E2 := f_equal snd H). unfold p2, z in *.
  destruct (Nat.eqb k (S N)); apply injective_projections; cbn in *; lra.
Qed.
Lemma size_even f g N w B : size f g N w B -> size f g N (Rabs w) B.
Proof.
  intros (a & R & E). destruct (Rle_lt_dec 0 w) as [W|W].
  - rewrite Rabs_pos_eq by exact W. now exists a.
  - rewrite Rabs_left by exact W. exists (fun k => Cconj (a k)). split; [now apply response2_conj|]. rewrite <- E. unfold Cmod, Cconj. cbn. f_equal. ring.
Qed.
Lemma lem3_proved : lem3.
Proof.
  intros f g w A Hf Hg HA H. apply is_lim_seq_spec. intros e. pose proof (cond_pos e) as He. set (ep := pos e) in *.
  set (t := - g * ep ^ 3 / (f ^ 2 + (ep * g) ^ 2)).
  assert (D0 : forall u, 0 < f ^ 2 + (u * g) ^ 2) by (intros u; pose proof (pow2_ge_0 (u * g)); assert (0 < f ^ 2) by (apply pow2_gt_0; lra); lra).
  assert (T : 0 < t). { apply Rdiv_lt_0_compat; [|apply D0]. apply Rmult_lt_0_compat; [lra|now apply pow_lt]. }
  destruct (nfloor_ex (/ (A * t))) as [N0 HN0]. { left. apply Rinv_0_lt_compat. nra. }
  exists (S N0). intros N HN. rewrite Rminus_0_r. apply Rnot_le_lt. intros Le.
  destruct (H N) as (B & Sz & AB). apply size_even in Sz. destruct Sz as (a & R & E). apply response_is in R. destruct R as [A0 R].
  set (y := Rabs (w N)) in *. change (ep <= y) in Le.
  pose proof (veerman_chain.lemma_3 f g y N a Hf Hg ltac:(lra) A0 R) as L. rewrite E in L.
  assert (Mono : t <= - g * y ^ 3 / (f ^ 2 + (y * g) ^ 2)).
  { unfold t. apply Rmult_le_reg_r with ((f ^ 2 + (ep * g) ^ 2) * (f ^ 2 + (y * g) ^ 2)); [apply Rmult_lt_0_compat; apply D0|].
    replace (- g * ep ^ 3 / (f ^ 2 + (ep * g) ^ 2) * ((f ^ 2 + (ep * g) ^ 2) * (f ^ 2 + (y * g) ^ 2))) with (- g * (ep ^ 3 * (f ^ 2 + (y * g) ^ 2))) by (field; apply Rgt_not_eq, D0).
    replace (- g * y ^ 3 / (f ^ 2 + (y * g) ^ 2) * ((f ^ 2 + (ep * g) ^ 2) * (f ^ 2 + (y * g) ^ 2))) with (- g * (y ^ 3 * (f ^ 2 + (ep * g) ^ 2))) by (field; apply Rgt_not_eq, D0).
    apply Rmult_le_compat_l; [lra|]. assert (C3 : ep ^ 3 <= y ^ 3) by (apply pow_incr; lra).
    assert (F2 : 0 <= f ^ 2) by apply pow2_ge_0. assert (G2 : 0 <= g ^ 2) by apply pow2_ge_0.
    assert (P : 0 <= ep ^ 2 * y ^ 2 * (y - ep) * g ^ 2).
    { apply Rmult_le_pos; [|exact G2]. apply Rmult_le_pos; [|lra]. apply Rmult_le_pos; apply pow2_ge_0. }
    assert (ep ^ 3 * f ^ 2 <= y ^ 3 * f ^ 2) by (apply Rmult_le_compat_r; lra).
    replace (ep ^ 3 * (f ^ 2 + (y * g) ^ 2)) with (ep ^ 3 * f ^ 2 + ep ^ 3 * y ^ 2 * g ^ 2) by ring.
    replace (y ^ 3 * (f ^ 2 + (ep * g) ^ 2)) with (y ^ 3 * f ^ 2 + ep ^ 3 * y ^ 2 * g ^ 2 + ep ^ 2 * y ^ 2 * (y - ep) * g ^ 2) by ring. lra. }
  assert (M : / (A * t) < INR (S N)). { rewrite S_INR. apply le_INR in HN. rewrite S_INR in HN. lra. }
  set (q := - g * y ^ 3 / (f ^ 2 + (y * g) ^ 2)) in *.
  assert (AT : 0 < A * t) by nra.
  assert (1 < A * t * INR (S N)).
  { apply (Rmult_lt_compat_l (A * t)) in M; [|exact AT]. rewrite Rinv_r in M by lra. exact M. }
  assert (I : 0 < INR (S N)) by (apply lt_0_INR; lia).
  assert (A * t <= B * q) by (apply Rmult_le_compat; lra).
  assert (A * t * INR (S N) <= B * q * INR (S N)) by (apply Rmult_le_compat_r; lra).
  replace (B * (INR (S N) * q)) with (B * q * INR (S N)) in L by ring. lra.
Qed.

(* ======== the remaining clauses: statements first ======== *)
(* matrices by their entries from 0; agent k is row k - 1 of P_1, P_2; states (x_1, u_1, x_2, u_2, ..) *)
Definition kron2 (A B : nat -> nat -> R) i j := A (Nat.div2 i) (Nat.div2 j) * B (Nat.modulo i 2) (Nat.modulo j 2).
Definition unit_m (i j : nat) : R := if Nat.eqb i j then 1 else 0.
Definition A22 (i j : nat) : R := match i, j with 0%nat, 1%nat => 1 | _, _ => 0 end.
Definition K22 (f g : R) (i j : nat) : R := match i, j with 1%nat, 0%nat => f | 1%nat, 1%nat => g | _, _ => 0 end.
Definition P1 (i j : nat) : R := if Nat.eqb i j then 1 else if Nat.eqb i (S j) then - 1 else 0.
Definition P2 (N i j : nat) : R := if Nat.eqb i j then 1 else if Nat.eqb i (S j) then (if Nat.eqb i N then - 1 else - / 2) else if Nat.eqb (S i) j then - / 2 else 0.
Definition interleave (h u : nat -> C) (m : nat) : C := if Nat.even m then h (S (Nat.div2 m)) else u (S (Nat.div2 m)).
Definition times n (M : nat -> nat -> R) (x : nat -> C) i : C := Csum n (fun j => RtoC (M i j) * x j)%C.
(* xdot = I kron A x + P kron K (x - zeta) + L_l kron (K (x_l - zeta_l)); Ll is the first column of L_i from row 1 on *)
Definition vector_form N f g (P : nat -> nat -> R) (Ll : nat -> R) (x u : nat -> R -> C) (h : nat -> C) t := forall m, (m < 2 * S N)%nat ->
  let z := interleave (fun k => x k t) (fun k => u k t) in let zeta := interleave h (fun _ => 0%C) in
  let lead q := if Nat.eqb q 0 then (x 0%nat t - h 0%nat)%C else u 0%nat t in
  is_velocity (fun s => interleave (fun k => x k s) (fun k => u k s) m) t
    (times (2 * S N) (kron2 unit_m A22) z m + times (2 * S N) (kron2 P (K22 f g)) (fun j => z j - zeta j) m
     + RtoC (Ll (Nat.div2 m)) * times 2 (K22 f g) lead (Nat.modulo m 2))%C.
(* equations (1), (2) at time t; h k is the desired position of agent k, the motion of the leader 0 is anything *)
Definition motion_1 N f g (x u : nat -> R -> C) (h : nat -> C) t := forall k, (1 <= k <= S N)%nat -> is_velocity (x k) t (u k t) /\
  is_velocity (u k) t (RtoC f * ((x k t - h k) - (x (k - 1)%nat t - h (k - 1)%nat)) + RtoC g * (u k t - u (k - 1)%nat t))%C.
Definition motion_2 N f g (x u : nat -> R -> C) (h : nat -> C) t := forall k, (1 <= k <= S N)%nat -> is_velocity (x k) t (u k t) /\
  is_velocity (u k) t (if Nat.eqb k (S N)
    then RtoC f * ((x k t - h k) - (x (k - 1)%nat t - h (k - 1)%nat)) + RtoC g * (u k t - u (k - 1)%nat t)
    else RtoC f * ((x k t - h k) - / 2 * (x (k - 1)%nat t - h (k - 1)%nat + (x (k + 1)%nat t - h (k + 1)%nat)))
       + RtoC g * (u k t - / 2 * (u (k - 1)%nat t + u (k + 1)%nat t)))%C.
(* veerman.eq1_matrix clause 1 *)
Definition eq1_matrix_1 : Prop := forall N f g x u h t,
  motion_1 N f g x u h t <-> vector_form N f g P1 (fun i => if Nat.eqb i 0 then - 1 else 0) x u h t.
(* veerman.eq1_matrix clause 2 *)
Definition eq1_matrix_2 : Prop := forall N lam,
  (exists x : nat -> C, (exists i, (i < S N)%nat /\ x i <> 0%C) /\ forall i, (i < S N)%nat -> times (S N) P1 x i = (lam * x i)%C) <-> lam = 1%C.
(* veerman.eq2_matrix clause 1; a single follower (N = 0) sees the leader fully, else the first sees half of it *)
Definition eq2_matrix_1 : Prop := forall N f g x u h t, motion_2 N f g x u h t <->
  vector_form N f g (P2 N) (fun i => if Nat.eqb i 0 then (if Nat.eqb N 0 then - 1 else - / 2) else 0) x u h t.
(* veerman.cor1.proof clause 1: refuted, in both directions, with all h_k = 0 and for stable systems
   (changed after the theorems had been seen: the type of a written out; Coq had taken it for real) *)
Definition substituted f g w (a : nat -> C) := forall k t, (1 <= k)%nat -> is_velocity (fun s => Ci * RtoC w * expi (w * s))%C t
  (RtoC f * (a k * expi (w * t) - a (k - 1)%nat * expi (w * t)) + RtoC g * (Ci * RtoC w * expi (w * t) - Ci * RtoC w * expi (w * t)))%C.
Definition recurrence f g w (a : nat -> C) := forall k, (1 <= k)%nat ->
  (- RtoC (w ^ 2) * a k = RtoC f * (a k - a (k - 1)%nat) + Ci * RtoC w * RtoC g * (a k - a (k - 1)%nat))%C.
Definition cor1_proof_1 : Prop :=
  (~ forall f g w (a : nat -> C), f < 0 -> g < 0 -> 0 < w -> a 0%nat = 1%C -> substituted f g w a -> recurrence f g w a) /\
  (~ forall f g w (a : nat -> C), f < 0 -> g < 0 -> 0 < w -> a 0%nat = 1%C -> recurrence f g w a -> substituted f g w a).
(* veerman.gain_iff clause 1: refuted *)
Definition gain_iff_1 : Prop := ~ forall f g w, f < 0 -> g < 0 -> 0 <= w -> w ^ 2 < 2 * Rabs f -> 1 < Cmod (/ gam f g w)%C.
(* veerman.gain_iff clause 2 *)
Definition gain_iff_2 : Prop := forall f g w, f < 0 -> g < 0 -> 0 <= w -> 1 < Cmod (/ gam f g w)%C -> w ^ 2 < 2 * Rabs f.
(* veerman.gain_max clause 1: refuted, for all f and g *)
Definition gain_max_1 : Prop := forall f g, f < 0 -> g < 0 -> ~ forall w, 0 <= w -> Cmod (/ gam f g w)%C <= Cmod (/ gam f g (sqrt (Rabs f)))%C.
(* veerman.lem2_eigvec clauses 1, 2; C (p, q) by the rows of C *)
Definition CC (G : C) (v : C * C) : C * C := (0 * fst v + 1 * snd v, - (1) * fst v + 2 * G * snd v)%C.
Definition lem2_eigvec_12 : Prop := forall f g w N a, f < 0 -> g < 0 -> (response2 f g w N a <-> a 0%nat = 1%C /\
  (forall k, (1 <= k <= N)%nat -> (a k, a (k + 1)%nat) = CC (gam f g w) (a (k - 1)%nat, a k)) /\ a (N + 1)%nat = (/ gam f g w * a N)%C).
(* veerman.lem2_eigvec clauses 3, 4; for every number G and root of G^2 - 1 *)
Definition lem2_eigvec_3 : Prop := forall G s : C, (s * s)%C = (G * G - 1)%C ->
  (forall mu, mu = (G + s)%C \/ mu = (G - s)%C -> CC G (RtoC 1, mu) = (mu * 1, mu * mu)%C) /\
  forall p q lam : C, (p <> 0 \/ q <> 0)%C -> CC G (p, q) = (lam * p, lam * q)%C -> (lam = G + s \/ lam = G - s)%C /\ q = (p * lam)%C.
Definition lem2_eigvec_4 : Prop := forall G s : C, (s * s)%C = (G * G - 1)%C ->
  (1 - G * (G + s) = - s * (G + s))%C /\ (1 - G * (G - s) = s * (G - s))%C.
(* ---- each agent keeps track of the n-th in front and behind; agents 0 .. N + 1 ---- *)
Definition nth_graph (n i j : nat) : bool := orb (Nat.eqb (i + n) j) (Nat.eqb (j + n) i).
Definition nth_motion n N f g (x u : nat -> R -> R) (h : nat -> R) t := forall k, (1 <= k <= S N)%nat -> is_derive (x k) t (u k t) /\
  let y j := x j t - h j in let front := Nat.leb n k in let behind := Nat.leb (k + n) (S N) in
  is_derive (u k) t (if andb front behind then f * (y k - / 2 * (y (k - n)%nat + y (k + n)%nat)) + g * (u k t - / 2 * (u (k - n)%nat t + u (k + n)%nat t))
    else if front then f * (y k - y (k - n)%nat) + g * (u k t - u (k - n)%nat t)
    else if behind then f * (y k - y (k + n)%nat) + g * (u k t - u (k + n)%nat t) else 0).
(* veerman.nth_neighbour clause 1: refuted *)
Definition nth_neighbour_1 : Prop := ~ forall n N, (1 <= n)%nat -> ~ strongly_connected (S (S N)) (nth_graph n).
(* veerman.nth_neighbour clause 2: refuted; with n = 1, from rest in the places; with every n >= 2, if the start is anything *)
Definition stays_behind (x : nat -> R -> R) k := forall B, exists t, 0 <= t /\ B < Rabs (x k t - x 0%nat t).
Definition nth_neighbour_2 : Prop :=
  (~ forall n N f g x u h, (1 <= n)%nat -> f < 0 -> g < 0 -> (forall t, 0 <= t -> is_derive (x 0%nat) t (u 0%nat t) /\ nth_motion n N f g x u h t) ->
     is_lim (x 0%nat) p_infty p_infty -> (forall k, (1 <= k <= S N)%nat -> x k 0 = h k /\ u k 0 = 0) ->
     exists k, (1 <= k <= S N)%nat /\ stays_behind x k) /\
  forall n N f g, (2 <= n)%nat -> f < 0 -> g < 0 ->
   ~ forall x u h, (forall t, 0 <= t -> is_derive (x 0%nat) t (u 0%nat t) /\ nth_motion n N f g x u h t) ->
     is_lim (x 0%nat) p_infty p_infty -> exists k, (1 <= k <= S N)%nat /\ stays_behind x k.
(* veerman.prop1 clause 1: refuted, even if all cars stay within D *)
Definition prop1_1 : Prop := ~ forall f g a0 D N a, f < 0 -> g < 0 -> 0 < a0 -> 0 < D -> response1 f g (Rabs f) a ->
  (forall k, (k <= S N)%nat -> a0 * Cmod (a k) <= D) -> INR N <= 2 * ln (D / a0) / ln (1 + Rabs f / g ^ 2).
(* veerman.sec7.omega0 clause 1 *)
Definition omega0_1 : Prop := (forall N, sqrt (Rabs (-1)) * PI / ((INR N + 1) * 2 * sqrt 2) = PI * sqrt 2 / (4 * (INR N + 1))) /\
  exists K N0, forall N, (N0 <= N)%nat -> forall w A, peak (-1) (-1) N w A -> Rabs (w - PI * sqrt 2 / (4 * (INR N + 1))) <= K / INR N ^ 3.
(* veerman.sep_remark clause 1: refuted, at every time, for every car *)
Definition place (h : nat -> R) a0 (a : nat -> C) w k t := h k + a0 * fst (a k * expi (w * t))%C.
Definition sep_remark_1 : Prop := forall f g w a (h : nat -> R) a0 k t, f < 0 -> g < 0 -> 0 < a0 -> response1 f g w a -> h (S k) - h k = 1 ->
  place h a0 a w (S k) t - place h a0 a w k t <>
  a0 * fst (/ power (gam f g w) (S k) * expi (w * t))%C - a0 * fst (/ power (gam f g w) k * expi (w * t) + 1)%C.
(* veerman.specM clause 1: refuted, at f = 0 for every N and g; L_i has the leader's row of zeros *)
Definition eig_L N (p : (nat -> C) -> nat -> C) (lam : C) := exists x : nat -> C, (exists k, (k <= S N)%nat /\ x k <> 0%C) /\ (lam * x 0%nat = 0)%C /\
  forall k, (1 <= k <= S N)%nat -> p x k = (lam * x k)%C.
Definition eig_AK (f g : R) (lam nu : C) := exists a b : C, (a <> 0 \/ b <> 0)%C /\ b = (nu * a)%C /\ (lam * RtoC f * a + lam * RtoC g * b)%C = (nu * b)%C.
Definition specM_1 : Prop := forall N p g, p = p1 \/ p = p2 N ->
  ~ forall nu, (eig_M N p 0 g nu /\ nu <> 0%C) <-> exists lam, eig_L N p lam /\ lam <> 0%C /\ eig_AK 0 g lam nu.
(* veerman.table1_theory clauses 1, 2: refuted in every row, to within a unit of the last printed digit; n is N + 1, or N *)
Definition freq1 (n : R) := PI / (n * 2 * sqrt 2).
Definition amp1 (n : R) := 8 * sqrt 2 / PI ^ 2 * n.
Definition off (approx : R -> R) (N : nat) (printed last : R) := last < Rabs (approx (INR N + 1) - printed) /\ last < Rabs (approx (INR N) - printed).
Definition table1_1 : Prop := off freq1 4 0.2727291 0.0000001 /\ off freq1 8 0.1382221 0.0000001 /\ off freq1 16 0.06934994 0.00000001 /\
  off freq1 32 0.03470038 0.00000001 /\ off freq1 64 0.017353935 0.000000001 /\ off freq1 128 0.008677381 0.000000001.
Definition table1_2 : Prop := off amp1 4 4.49064609 0.00000001 /\ off amp1 8 9.11739657 0.00000001 /\ off amp1 16 18.3135253 0.0000001 /\
  off amp1 32 36.6683866 0.0000001 /\ off amp1 64 73.3562112 0.0000001 /\ off amp1 128 146.7227220 0.0000001.
(* veerman.thm1_amp clause 1 *)
Definition thm1_amp_1 : Prop := forall f g, f < 0 -> g < 0 -> exists K N0, forall N, (N0 <= N)%nat -> (exists w A, peak f g N w A) /\
  forall w A, peak f g N w A -> Rabs (A - 8 * sqrt (2 * Rabs f) / (PI ^ 2 * Rabs g) * (INR N + 1)) <= K / INR N.
(* veerman.thm1_x clauses 1, 2: refuted with the printed x, for both signs and all f but -1 *)
Definition printed_x f g := PI ^ 2 * Rabs g / (8 * sqrt 2 * Rabs f).
Definition ordered_roots f g w (mp mm : C) := (mp + mm = 2 * gam f g w)%C /\ (mp * mm = 1)%C /\ Cmod mm <= Cmod mp.
Definition thm1_x_1 : Prop := forall f g, f < 0 -> g < 0 -> f <> -1 ->
  (~ exists K N0, forall N, (N0 <= N)%nat -> forall w A mp mm, peak f g N w A -> ordered_roots f g w mp mm ->
     Rabs (Cmod mp ^ S N - exp (printed_x f g / (INR N + 1))) <= K / INR N ^ 3) /\
  (~ exists K N0, forall N, (N0 <= N)%nat -> forall w A mp mm, peak f g N w A -> ordered_roots f g w mp mm ->
     Rabs (Cmod mm ^ S N - exp (- printed_x f g / (INR N + 1))) <= K / INR N ^ 3).
Definition thm1_x_2 : Prop := forall f g, f < 0 -> g < 0 -> f <> -1 ->
  ~ exists K N0, forall N, (N0 <= N)%nat -> forall w A, peak f g N w A -> Rabs (A - (INR N + 1) / printed_x f g) <= K / INR N.

(* ---- the theorems prove them ---- *)
Lemma Csum_even_odd n f : Csum (2 * n) f = Csum n (fun i => f (2 * i)%nat + f (2 * i + 1)%nat)%C.
Proof. unfold Csum. now rewrite !tanner_energy.Sum_even_odd. Qed.
Lemma even_2 i : Nat.even (2 * i) = true. Proof. now rewrite Nat.even_mul. Qed.
Lemma even_21 i : Nat.even (2 * i + 1) = false. Proof. now rewrite Nat.even_add, Nat.even_mul. Qed.
Lemma div2_2 i : Nat.div2 (2 * i) = i. Proof. apply Nat.div2_double. Qed.
Lemma div2_21 i : Nat.div2 (2 * i + 1) = i. Proof. rewrite Nat.add_1_r. apply Nat.div2_succ_double. Qed.
Lemma times_ext n M M' x x' i : (forall j, (j < n)%nat -> (RtoC (M i j) * x j = RtoC (M' i j) * x' j)%C) -> times n M x i = times n M' x' i.
Proof. intros H. unfold times, Csum. f_equal; apply Sum_ext; intros j Hj; now rewrite H. Qed.
(* a row with three entries *)
Lemma row3 n a b c i (y : nat -> C) : (i < n)%nat -> (i = 0%nat -> b = 0) -> (S i = n -> c = 0) ->
  times n (fun i j => a * delta j i + b * delta j (i - 1) + c * delta j (S i)) y i = (RtoC a * y i + RtoC b * y (i - 1)%nat + RtoC c * y (S i))%C.
Proof.
  intros Hi Hb Hc. assert (Q : forall Y : nat -> R, Sum n (fun j => (a * delta j i + b * delta j (i - 1) + c * delta j (S i)) * Y j) = a * Y i + b * Y (i - 1)%nat + c * Y (S i)).
  { intros Y. rewrite (Sum_ext n _ (fun j => a * (delta j i * Y j) + b * (delta j (i - 1) * Y j) + c * (delta j (S i) * Y j))) by (intros; ring).
    rewrite !Sum_plus, !Sum_scal, !Sum_delta by lia. destruct (Nat.eq_dec (S i) n) as [E|E].
    - rewrite (Hc E). ring.
    - rewrite Sum_delta by lia. ring. }
  unfold times, Csum. apply injective_projections; cbn [fst snd].
  - rewrite (Sum_ext n _ (fun j => (a * delta j i + b * delta j (i - 1) + c * delta j (S i)) * fst (y j))) by (intros; cbn; ring). rewrite Q. cbn. ring.
  - rewrite (Sum_ext n _ (fun j => (a * delta j i + b * delta j (i - 1) + c * delta j (S i)) * snd (y j))) by (intros; cbn; ring). rewrite Q. cbn. ring.
Qed.
Lemma row_P1 n y i : (i < n)%nat -> times n P1 y i = (y i - (if Nat.eqb i 0 then 0 else y (i - 1)%nat))%C.
Proof.
  intros Hi. rewrite (times_ext n P1 (fun i j => 1 * delta j i + (if Nat.eqb i 0 then 0 else - 1) * delta j (i - 1) + 0 * delta j (S i)) y y).
  - pose proof (row3 n 1 (if Nat.eqb i 0 then 0 else - 1) 0 i y Hi) as R. unfold times in *. rewrite R; [|intros ->; reflexivity|reflexivity].
    destruct (Nat.eqb i 0); apply injective_projections; cbn; ring.
  - intros j Hj. f_equal. f_equal. unfold P1, delta. destruct (Nat.eqb_spec i j), (Nat.eqb_spec j i), (Nat.eqb_spec i 0), (Nat.eqb_spec i (S j)), (Nat.eqb_spec j (i - 1)),
      (Nat.eqb_spec j (S i)); try lia; try ring.
Qed.
Lemma row_P2 N y i : (i < S N)%nat -> times (S N) (P2 N) y i =
  (y i - (if Nat.eqb i 0 then 0 else RtoC (if Nat.eqb i N then 1 else / 2) * y (i - 1)%nat) - (if Nat.eqb i N then 0 else RtoC (/ 2) * y (S i)))%C.
Proof.
  intros Hi. set (b := if Nat.eqb i 0 then 0 else if Nat.eqb i N then - 1 else - / 2). set (c := if Nat.eqb i N then 0 else - / 2).
  rewrite (times_ext (S N) (P2 N) (fun i j => 1 * delta j i + b * delta j (i - 1) + c * delta j (S i)) y y).
  - pose proof (row3 (S N) 1 b c i y Hi) as R. unfold times in *. rewrite R; unfold b, c; [|intros ->; reflexivity|intros E; replace i with N by lia; now rewrite Nat.eqb_refl].
    destruct (Nat.eqb i 0), (Nat.eqb i N); apply injective_projections; cbn; ring.
  - intros j Hj. f_equal. f_equal. unfold P2, delta, b, c. destruct (Nat.eqb_spec i j), (Nat.eqb_spec j i), (Nat.eqb_spec i 0), (Nat.eqb_spec i (S j)),
      (Nat.eqb_spec (S i) j), (Nat.eqb_spec j (i - 1)), (Nat.eqb_spec j (S i)), (Nat.eqb_spec i N); try lia; try ring.
Qed.
(* the two components of row i of the vector form *)
Lemma vector_form_is N f g P Ll x u h t : vector_form N f g P Ll x u h t <-> forall i, (i < S N)%nat ->
  is_velocity (x (S i)) t (u (S i) t) /\
  is_velocity (u (S i)) t (times (S N) P (fun j => RtoC f * (x (S j) t - h (S j)) + RtoC g * u (S j) t) i
    + RtoC (Ll i) * (RtoC f * (x 0%nat t - h 0%nat) + RtoC g * u 0%nat t))%C.
Proof.
  assert (Z0 : forall a : C, (a + RtoC 0 = a)%C) by (intros; apply injective_projections; cbn; ring).
  set (z := interleave (fun k => x k t) (fun k => u k t)). set (zeta := interleave h (fun _ => 0%C)).
  set (lead := fun q => if Nat.eqb q 0 then (x 0%nat t - h 0%nat)%C else u 0%nat t).
  set (rhs := fun m => (times (2 * S N) (kron2 unit_m A22) z m + times (2 * S N) (kron2 P (K22 f g)) (fun j => z j - zeta j) m
     + RtoC (Ll (Nat.div2 m)) * times 2 (K22 f g) lead (Nat.modulo m 2))%C).
  assert (E : forall i, (i < S N)%nat -> rhs (2 * i)%nat = u (S i) t).
  { intros i Hi. unfold rhs, times. rewrite !Csum_even_odd.
    rewrite (Csum_ext (S N) _ (fun j => RtoC (delta j i) * u (S j) t)%C).
    - rewrite (Csum_ext (S N) (fun j => RtoC (kron2 P _ _ _) * _ + _)%C (fun j => RtoC 0)).
      + rewrite (Csum_ext 2 _ (fun j => RtoC 0)).
        * unfold Csum. cbn [fst snd RtoC]. rewrite !Sum_0. apply injective_projections; cbn [fst snd Cplus Cmult RtoC].
          -- rewrite (Sum_ext (S N) _ (fun j => delta j i * fst (u (S j) t))) by (intros; ring). rewrite Sum_delta by exact Hi. ring.
          -- rewrite (Sum_ext (S N) _ (fun j => delta j i * snd (u (S j) t))) by (intros; ring). rewrite Sum_delta by exact Hi. ring.
        * intros j Hj. rewrite tanner_energy.mod_even. destruct j as [|[|]]; cbn [K22]; [ring|ring|lia].
      + intros j _. unfold kron2. rewrite !div2_2, !div2_21, !tanner_energy.mod_even, !tanner_energy.mod_odd. cbn [K22]. rewrite !Rmult_0_r. ring.
    - intros j _. unfold kron2, unit_m, z, interleave. rewrite !div2_2, !div2_21, !tanner_energy.mod_even, !tanner_energy.mod_odd, even_2, even_21. cbn [A22].
      unfold delta. rewrite (Nat.eqb_sym j i). rewrite Rmult_0_r, Rmult_1_r. ring. }
  assert (O : forall i, (i < S N)%nat -> rhs (2 * i + 1)%nat = (times (S N) P (fun j => RtoC f * (x (S j) t - h (S j)) + RtoC g * u (S j) t) i
    + RtoC (Ll i) * (RtoC f * (x 0%nat t - h 0%nat) + RtoC g * u 0%nat t))%C).
  { intros i Hi. unfold rhs, times. rewrite !Csum_even_odd, div2_21, tanner_energy.mod_odd.
    rewrite (Csum_ext (S N) _ (fun j => RtoC 0)).
    - rewrite (Csum_ext (S N) (fun j => RtoC (kron2 P _ _ _) * _ + _)%C (fun j => RtoC (P i j) * (RtoC f * (x (S j) t - h (S j)) + RtoC g * u (S j) t))%C).
      + assert (Z : Csum (S N) (fun _ => RtoC 0) = RtoC 0) by (unfold Csum; cbn [fst snd RtoC]; rewrite !Sum_0; reflexivity). rewrite Z.
        set (X := Csum (S N) _). replace (Csum 2 _) with (RtoC f * (x 0%nat t - h 0%nat) + RtoC g * u 0%nat t)%C; [ring|].
        unfold Csum, lead. cbn [Sum K22 Nat.eqb]. apply injective_projections; cbn; ring.
      + intros j _. unfold kron2, z, zeta, interleave. rewrite !div2_2, !div2_21, !tanner_energy.mod_even, !tanner_energy.mod_odd, even_2, even_21. cbn [K22].
        apply injective_projections; cbn; ring.
    - intros j _. unfold kron2. rewrite !tanner_energy.mod_even, !tanner_energy.mod_odd. cbn [A22]. rewrite !Rmult_0_r. ring. }
  split.
  - intros H i Hi. split.
    + specialize (H (2 * i)%nat ltac:(lia)). cbv zeta in H. fold z zeta lead in H. change (is_velocity (fun s => interleave (fun k => x k s) (fun k => u k s) (2 * i)) t (rhs (2 * i)%nat)) in H.
      rewrite E in H by exact Hi. unfold interleave in H. rewrite even_2, div2_2 in H. exact H.
    + specialize (H (2 * i + 1)%nat ltac:(lia)). cbv zeta in H. change (is_velocity (fun s => interleave (fun k => x k s) (fun k => u k s) (2 * i + 1)) t (rhs (2 * i + 1)%nat)) in H.
      rewrite O in H by exact Hi. unfold interleave in H. rewrite even_21, div2_21 in H. exact H.
  - intros H m Hm. cbv zeta. change (is_velocity (fun s => interleave (fun k => x k s) (fun k => u k s) m) t (rhs m)).
    destruct (Nat.Even_or_Odd m) as [[i ->]|[i ->]]; destruct (H i ltac:(lia)) as [A B].
    + rewrite E by lia. unfold interleave. rewrite even_2, div2_2. exact A.
    + rewrite O by lia. unfold interleave. rewrite even_21, div2_21. exact B.
Qed.
Lemma eq1_matrix_1_proved : eq1_matrix_1.
Proof.
  intros N f g x u h t. rewrite vector_form_is. split; intros H.
  - intros i Hi. destruct (H (S i) ltac:(lia)) as [A B]. split; [exact A|]. replace (S i - 1)%nat with i in B by lia. rewrite row_P1 by exact Hi.
    refine (eq_ind _ (is_velocity (u (S i)) t) B _ _). destruct i; cbn [Nat.eqb]; [|replace (S (S i - 1)) with (S i) by lia]; apply injective_projections; cbn; ring.
  - intros k Hk. destruct k as [|i]; [lia|]. destruct (H i ltac:(lia)) as [A B]. split; [exact A|]. replace (S i - 1)%nat with i by lia. rewrite row_P1 in B by lia.
    refine (eq_ind _ (is_velocity (u (S i)) t) B _ _). destruct i; cbn [Nat.eqb]; [|replace (S (S i - 1)) with (S i) by lia]; apply injective_projections; cbn; ring.
Qed.
Lemma row_force_2 N f g (x u : nat -> C) (h : nat -> C) i : (i < S N)%nat ->
  (times (S N) (P2 N) (fun j => RtoC f * (x (S j) - h (S j)) + RtoC g * u (S j)) i
    + RtoC (if Nat.eqb i 0 then (if Nat.eqb N 0 then - 1 else - / 2) else 0) * (RtoC f * (x 0%nat - h 0%nat) + RtoC g * u 0%nat))%C =
  (if Nat.eqb (S i) (S N) then RtoC f * ((x (S i) - h (S i)) - (x i - h i)) + RtoC g * (u (S i) - u i)
   else RtoC f * ((x (S i) - h (S i)) - / 2 * (x i - h i + (x (S i + 1)%nat - h (S i + 1)%nat))) + RtoC g * (u (S i) - / 2 * (u i + u (S i + 1)%nat)))%C.
Proof.
  intros Hi. rewrite row_P2 by exact Hi. cbn [Nat.eqb]. replace (S i + 1)%nat with (S (S i)) by lia.
  assert (T : (/ RtoC 2)%C = RtoC (/ 2)) by (rewrite RtoC_inv; [reflexivity|lra]). rewrite T.
  destruct (Nat.eqb_spec i 0) as [->|I0].
  - destruct (Nat.eqb_spec 0 N) as [<-|N0]; cbn [Nat.eqb]; [|destruct (Nat.eqb_spec N 0); [lia|]]; apply injective_projections; cbn; field.
  - replace (S (i - 1)) with i by lia. destruct (Nat.eqb_spec i N); apply injective_projections; cbn; field.
Qed.
Lemma eq2_matrix_1_proved : eq2_matrix_1.
Proof.
  intros N f g x u h t. rewrite vector_form_is. split; intros H.
  - intros i Hi. destruct (H (S i) ltac:(lia)) as [A B]. split; [exact A|]. replace (S i - 1)%nat with i in B by lia.
    rewrite (row_force_2 N f g (fun k => x k t) (fun k => u k t) h i Hi). exact B.
  - intros k Hk. destruct k as [|i]; [lia|]. destruct (H i ltac:(lia)) as [A B]. split; [exact A|]. replace (S i - 1)%nat with i by lia.
    rewrite (row_force_2 N f g (fun k => x k t) (fun k => u k t) h i ltac:(lia)) in B. exact B.
Qed.
Lemma eq1_matrix_2_proved : eq1_matrix_2.
Proof.
  intros N lam. rewrite <- (veerman_stability.spectrum_P1 N lam). change veerman_stability.P1 with (veerman_stability.reduced p1). rewrite <- (eig_is N p1 lam (or_introl eq_refl)). split.
  - intros (x & (i & Hi & X) & E). exists (fun k => match k with O => RtoC 0 | S k => x k end). split; [reflexivity|]. split; [exists (S i); split; [lia|exact X]|].
    intros k Hk. destruct k as [|k]; [lia|]. unfold p1. replace (S k - 1)%nat with k by lia. rewrite <- (E k ltac:(lia)), row_P1 by lia.
    destruct k as [|k]; cbn [Nat.eqb]; [reflexivity|]. now replace (S k - 1)%nat with k by lia.
  - intros (x & X0 & (k & Hk & X) & E). exists (fun j => x (S j)). split; [exists (k - 1)%nat; replace (S (k - 1)) with k by lia; split; [lia|exact X]|].
    intros i Hi. rewrite <- (E (S i) ltac:(lia)), row_P1 by exact Hi. unfold p1. replace (S i - 1)%nat with i by lia.
    destruct i as [|i]; cbn [Nat.eqb]; [now rewrite X0|]. now replace (S (S i - 1)) with (S i) by lia.
Qed.

Lemma gain_iff_1_proved : gain_iff_1.
Proof.
  intros H. assert (A : 1 < Cmod (/ gam (-1) (-1) 0)%C) by (apply H; rewrite ?Rabs_left; lra).
  apply gain_iff_proved in A; lra.
Qed.
Lemma gain_iff_2_proved : gain_iff_2.
Proof. intros f g w Hf Hg Hw H. apply gain_iff_proved in H; lra. Qed.
Lemma gain_max_1_proved : gain_max_1.
Proof.
  intros f g Hf Hg H. destruct (veerman_front.gain_max_printed_fails f g (sqrt (Rabs f)) Hf Hg (pow2_sqrt _ (Rabs_pos f))) as [w' L].
  specialize (H (Rabs w') (Rabs_pos w')). rewrite !gam_is, gain_even in H by assumption. lra.
Qed.
Lemma lem2_eigvec_12_proved : lem2_eigvec_12.
Proof.
  intros f g w N a Hf Hg. rewrite response_is, (veerman_chain.equation_2_chain f g w N a Hf Hg), gam_is. unfold veerman_chain.chain.
  assert (G : veerman_front.gamma f g w <> 0%C).
  { pose proof (veerman_front.num_neq0 f g w Hf Hg). pose proof (veerman_front.den_neq0 f g w Hf). unfold veerman_front.gamma, Cdiv.
    apply Cmult_neq_0; [assumption|]. intros E. apply veerman_complex.C1_neq0. rewrite <- (Cinv_r (veerman_front.den f g w)) by assumption. rewrite E. ring. }
  set (q := veerman_front.gamma f g w) in *. assert (M : forall v, CC q v = veerman_chain.Cmap q v) by (intros v; unfold CC, veerman_chain.Cmap; f_equal; ring).
  replace (N + 1)%nat with (S N) by lia. split.
  - intros (A0 & B & E). split; [exact A0|]. split; [intros k Hk; rewrite M; now apply B|]. rewrite E. field. exact G.
  - intros (A0 & B & E). split; [exact A0|]. split; [intros k Hk; rewrite <- M; now apply B|]. rewrite E. field. exact G.
Qed.
Lemma lem2_eigvec_4_proved : lem2_eigvec_4.
Proof.
  intros G s H. split.
  - replace (1 - G * (G + s))%C with (- (G * G - 1) - G * s)%C by ring. rewrite <- H. ring.
  - replace (1 - G * (G - s))%C with (- (G * G - 1) + G * s)%C by ring. rewrite <- H. ring.
Qed.
Lemma C2 : RtoC 2 = (1 + 1)%C. Proof. apply injective_projections; cbn; ring. Qed.
Lemma lem2_eigvec_3_proved : lem2_eigvec_3.
Proof.
  intros G s H. split.
  - intros mu Hm. unfold CC. cbn [fst snd]. rewrite C2. f_equal; [ring|].
    assert (Z : ((mu - G) * (mu - G) = G * G - 1)%C) by (destruct Hm; subst mu; rewrite <- H; ring).
    replace (mu * mu)%C with ((mu - G) * (mu - G) + (1 + 1) * G * mu - G * G)%C by ring. rewrite Z. ring.
  - intros p q lam NZ E. unfold CC in E. rewrite C2 in E. cbn [fst snd] in E. assert (E1 := f_equal fst E). assert (E2 := f_equal snd E). cbn [fst snd] in E1, E2.
    assert (Q : q = (lam * p)%C) by (rewrite <- E1; ring).
    assert (P : p <> 0%C) by (intros Z; destruct NZ as [N|N]; apply N; [exact Z|rewrite Q, Z; ring]).
    split; [|rewrite Q; ring]. rewrite Q in E2.
    assert (Z : (p * ((lam - G - s) * (lam - G + s)) = 0)%C).
    { replace (p * ((lam - G - s) * (lam - G + s)))%C with (lam * (lam * p) - (1 + 1) * G * (lam * p) + (G * G) * p - (s * s) * p)%C by ring. rewrite H, <- E2. ring. }
    destruct (Ceq_dec (lam - G - s)%C 0%C) as [A|A].
    + left. replace lam with (lam - G - s + (G + s))%C by ring. rewrite A. ring.
    + right. destruct (Ceq_dec (lam - G + s)%C 0%C) as [B|B].
      * replace lam with (lam - G + s + (G - s))%C by ring. rewrite B. ring.
      * exfalso. exact (Cmult_neq_0 _ _ P (Cmult_neq_0 _ _ A B) Z).
Qed.
(* the substitution, at f = g = -1, w = 1 *)
Lemma wave_rate (w t : R) : is_derive (fun s => fst (Ci * RtoC w * expi (w * s))%C) t (- w ^ 2 * cos (w * t)) /\
  is_derive (fun s => snd (Ci * RtoC w * expi (w * s))%C) t (- w ^ 2 * sin (w * t)).
Proof.
  assert (D : is_derive (fun s => w * s) t w) by (eapply D_eq; [apply D_scal, D_id|ring]). split.
  - apply (is_derive_ext (fun s => - w * sin (w * s))); [intros; cbn; Rring|]. eapply D_eq; [apply D_scal, (D_sin (fun s => w * s)), D|]. ring.
  - apply (is_derive_ext (fun s => w * cos (w * s))); [intros; cbn; Rring|]. eapply D_eq; [apply D_scal, (D_cos (fun s => w * s)), D|]. ring.
Qed.
Lemma cor1_proof_1_proved : cor1_proof_1.
Proof.
  split; intros H.
  - set (a := fun k => RtoC (1 + INR k)). specialize (H (-1) (-1) 1 a ltac:(lra) ltac:(lra) ltac:(lra)).
    assert (A0 : a 0%nat = RtoC 1) by (unfold a; cbn; f_equal; ring).
    assert (Sb : substituted (-1) (-1) 1 a).
    { intros k t Hk. destruct k as [|k]; [lia|]. replace (S k - 1)%nat with k by lia. unfold a. rewrite S_INR. destruct (wave_rate 1 t) as [P Q].
      split; (eapply D_eq; [exact P|] || (eapply D_eq; [exact Q|])); cbn; ring. }
    specialize (H A0 Sb 1%nat ltac:(lia)). apply (f_equal snd) in H. unfold a in H. cbn in H. lra.
  - set (a := fun k => power (1 - Ci)%C k). specialize (H (-1) (-1) 1 a ltac:(lra) ltac:(lra) ltac:(lra) eq_refl).
    assert (Rc : recurrence (-1) (-1) 1 a).
    { intros k Hk. destruct k as [|k]; [lia|]. replace (S k - 1)%nat with k by lia. unfold a. cbn [power]. set (p := power _ k).
      apply injective_projections; cbn; ring. }
    specialize (H Rc 1%nat 0 ltac:(lia)). destruct H as [H _]. apply is_derive_unique in H. rewrite (is_derive_unique _ _ _ (proj1 (wave_rate 1 0))) in H.
    rewrite Rmult_0_r in H. unfold expi in H. rewrite cos_0, sin_0 in H. unfold a in H. cbn in H. lra.
Qed.
Lemma nth_neighbour_1_proved : nth_neighbour_1.
Proof.
  intros H. apply (H 1%nat 0%nat ltac:(lia)). intros j k Hj Hk. destruct (Nat.eq_dec j k) as [->|N]; [apply rt_refl|]. apply rt_step. repeat split; try assumption.
  unfold nth_graph. destruct j as [|[|]], k as [|[|]]; try lia; reflexivity.
Qed.
Lemma exp_rate t : is_derive (fun s => exp (- s)) t (- exp (- t)).
Proof. eapply D_eq; [apply (D_comp exp (fun s => - s)); [apply is_derive_exp|apply D_opp, D_id]|]. ring. Qed.
Lemma nth_neighbour_2_proved : nth_neighbour_2.
Proof.
  split.
  - intros H. set (x := fun (k : nat) (t : R) => match k with O => t | _ => t - t * exp (- t) end).
    set (u := fun (k : nat) (t : R) => match k with O => 1 | _ => 1 - (exp (- t) - t * exp (- t)) end).
    destruct (H 1%nat 0%nat (-1) (-2) x u (fun _ => 0)) as (k & Hk & B); try lra; try lia.
    + intros t _. split; [apply D_id|]. intros k Hk. assert (k = 1%nat) by lia. subst k.
      assert (M : is_derive (fun s => s * exp (- s)) t (exp (- t) - t * exp (- t))).
      { eapply D_eq; [exact (D_mult (fun s => s) (fun s => exp (- s)) t _ _ (D_id t) (exp_rate t))|]. cbv beta. ring. }
      split; [apply (D_minus (fun s => s)); [apply D_id|exact M]|]. cbn [Nat.leb andb Nat.sub Nat.add].
      eapply D_eq; [apply (D_minus (fun s => 1)); [apply D_const|apply (D_minus (fun s => exp (- s))); [apply exp_rate|exact M]]|]. unfold x, u. ring.
    + apply is_lim_id.
    + intros k Hk. assert (k = 1%nat) by lia. subst k. split; [change (0 - 0 * exp (- 0) = 0)|change (1 - (exp (- 0) - 0 * exp (- 0)) = 0)]; rewrite Ropp_0, exp_0; ring.
    + assert (k = 1%nat) by lia. subst k. destruct (B 1) as (t & T & L). change (1 < Rabs (t - t * exp (- t) - t)) in L. replace (t - t * exp (- t) - t) with (- (t * exp (- t))) in L by ring.
      rewrite Rabs_Ropp, Rabs_pos_eq in L by (apply Rmult_le_pos; [lra|left; apply exp_pos]).
      pose proof (exp_ineq1_le t). pose proof (exp_pos (- t)) as P. assert (E : exp t * exp (- t) = 1) by (rewrite <- exp_plus, Rplus_opp_r; apply exp_0). nra.
  - intros n N f g Hn Hf Hg H. destruct (H (fun _ t => t) (fun _ _ => 1) (fun _ => 0)) as (k & Hk & B).
    + intros t _. split; [apply D_id|]. intros k Hk. split; [apply D_id|]. cbv zeta.
      eapply D_eq; [apply D_const|]. destruct (Nat.leb n k), (Nat.leb (k + n) (S N)); cbn [andb]; field.
    + apply is_lim_id.
    + destruct (B 0) as (t & _ & L). rewrite Rminus_eq_0, Rabs_R0 in L. lra.
Qed.
Lemma prop1_1_proved : prop1_1.
Proof.
  intros H. set (G := gam (-4) (-1) (Rabs (-4))). set (a := fun k => (/ power G k)%C).
  assert (G1 : Cmod (/ G)%C <= 1).
  { apply Rnot_lt_le. intros L. apply gain_iff_proved in L; [|lra|lra|apply Rabs_pos]. rewrite Rabs_left in L by lra. lra. }
  assert (NG : G <> 0%C).
  { unfold G. rewrite gam_is. pose proof (veerman_front.num_neq0 (-4) (-1) (Rabs (-4)) ltac:(lra) ltac:(lra)). pose proof (veerman_front.den_neq0 (-4) (-1) (Rabs (-4)) ltac:(lra)).
    unfold veerman_front.gamma, Cdiv.
    apply Cmult_neq_0; [assumption|]. intros E. apply veerman_complex.C1_neq0. rewrite <- (Cinv_r (veerman_front.den (-4) (-1) (Rabs (-4)))) by assumption. rewrite E. ring. }
  assert (A0 : a 0%nat = 1%C) by (unfold a; cbn; field; exact veerman_complex.C1_neq0).
  assert (Rs : response1 (-4) (-1) (Rabs (-4)) a) by (apply cor1_stable; [lra|lra|]; split; [exact A0|reflexivity]).
  assert (B : forall k, Cmod (a k) <= 1).
  { intros k. unfold a. induction k as [|k IH].
    - rewrite <- Cmod_1. right. f_equal. exact A0.
    - cbn [power]. replace (/ (G * power G k))%C with (/ G * / power G k)%C by (field; split; [rewrite power_is; now apply veerman_complex.Cpw_neq0|exact NG]).
      rewrite Cmod_mult. pose proof (Cmod_ge_0 (/ G)%C). pose proof (Cmod_ge_0 (/ power G k)%C). nra. }
  specialize (H (-4) (-1) 1 1 1%nat a ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) Rs). assert (K : INR 1 <= 2 * ln (1 / 1) / ln (1 + Rabs (-4) / (-1) ^ 2)).
  { apply H. intros k _. specialize (B k). lra. }
  replace (1 / 1) with 1 in K by field. rewrite ln_1, Rmult_0_r in K. unfold Rdiv in K. rewrite Rmult_0_l in K. cbn in K. lra.
Qed.
Lemma omega0_1_proved : omega0_1.
Proof.
  assert (E : forall N, sqrt (Rabs (-1)) * PI / ((INR N + 1) * 2 * sqrt 2) = PI * sqrt 2 / (4 * (INR N + 1))).
  { intros N. pose proof (veerman_numbers.omega_0 N) as Q. rewrite plus_INR in Q. exact Q. }
  split; [exact E|]. destruct (thm1_proved (-1) (-1) ltac:(lra) ltac:(lra)) as (K & N0 & H). exists K, N0. intros N HN w A P. rewrite <- E. exact (proj1 (proj2 (H N HN) w A P)).
Qed.
Lemma sep_remark_1_proved : sep_remark_1.
Proof.
  intros f g w a h a0 k t Hf Hg Ha R Hh. apply (cor1_stable f g w a Hf Hg) in R. destruct R as [_ R]. unfold place. rewrite !R. cbn [fst Cplus RtoC]. lra.
Qed.
Lemma specM_1_proved : specM_1.
Proof.
  intros N p g Hp H.
  assert (PS : veerman_lemma1.positive_spectrum N (veerman_stability.reduced p)).
  { destruct Hp; subst p; [exact (veerman_lemma1.positive_P1 N)|exact (veerman_lemma1.positive_P2 N)]. }
  destruct PS as [[lam El] Pos]. destruct (Pos lam El) as (r & R0 & Er). apply (eig_is N p lam Hp) in El. destruct El as (x & X0 & (k & Hk & Xk) & E).
  destruct (proj2 (H 0%C)) as [_ Z]; [|now apply Z]. exists lam. split; [|split].
  - exists x. split; [exists k; split; [lia|exact Xk]|]. split; [rewrite X0; ring|exact E].
  - rewrite Er. intros Q. injection Q. lra.
  - exists 1%C, 0%C. split; [left; exact veerman_complex.C1_neq0|]. split; ring.
Qed.
Lemma table1_both : table1_1 /\ table1_2.
Proof.
  pose proof veerman_numbers.table_theory_printed_fails as H. unfold veerman_numbers.table in H.
  assert (K : forall c x, ~ veerman_numbers.agrees c x -> snd c < Rabs (x - fst c)).
  { intros c x N. unfold veerman_numbers.agrees in N. rewrite Rabs_minus_sym in N. lra. }
  do 6 (let A := fresh in let B := fresh in pose proof (Forall_inv H) as A; pose proof (Forall_inv_tail H) as B; clear H; rename B into H; cbv beta iota in A;
    destruct A as (? & ? & ? & ?)).
  repeat match goal with H : ~ veerman_numbers.agrees _ _ |- _ => apply K in H; cbn [fst snd] in H; rewrite ?veerman_numbers.frequency_unit, ?veerman_numbers.amplitude_unit in H end.
  unfold table1_1, table1_2, off, freq1, amp1.
  replace (INR 4) with 4 by (cbn; ring). replace (INR 8) with 8 by (cbn; ring). replace (INR 16) with 16 by (cbn; ring). replace (INR 32) with 32 by (cbn; ring).
  replace (INR 64) with 64 by (rewrite INR_IZR_INZ; reflexivity). replace (INR 128) with 128 by (rewrite INR_IZR_INZ; reflexivity).
  repeat split; lra.
Qed.
Lemma table1_1_proved : table1_1. Proof. exact (proj1 table1_both). Qed.
Lemma table1_2_proved : table1_2. Proof. exact (proj2 table1_both). Qed.

Lemma thm1_amp_1_proved : thm1_amp_1.
Proof.
  intros f g Hf Hg. destruct (thm1_proved f g Hf Hg) as (K & N0 & H). exists K, N0. intros N HN. destruct (H N HN) as [E Q].
  split; [exact E|]. intros w A P. now apply (Q w A P).
Qed.
(* two main terms differ by too much *)
Lemma too_large (c K : R) N0 : 0 < c -> (forall N, (N0 <= N)%nat -> c * INR N <= K) -> False.
Proof.
  intros Hc H. destruct (nfloor_ex (Rabs K / c)) as [n [_ Hn]].
  { apply Rmult_le_pos; [apply Rabs_pos|]. left. now apply Rinv_0_lt_compat. }
  specialize (H (N0 + S n)%nat ltac:(lia)). rewrite plus_INR, S_INR in H. pose proof (pos_INR N0). pose proof (Rle_abs K).
  apply (Rmult_lt_compat_r c) in Hn; [|exact Hc]. unfold Rdiv in Hn. rewrite Rmult_assoc, Rinv_l in Hn by lra. nra.
Qed.
Definition mended_x f g := PI ^ 2 * Rabs g / (8 * sqrt 2 * sqrt (Rabs f)).
Lemma both_x f g : f < 0 -> g < 0 -> f <> -1 -> 0 < printed_x f g /\ 0 < mended_x f g /\ printed_x f g <> mended_x f g.
Proof.
  intros Hf Hg N. pose proof PI_RGT_0 as P0. assert (P2 : 0 < PI ^ 2 * Rabs g) by (apply Rmult_lt_0_compat; [apply pow_lt; lra|apply Rabs_pos_lt; lra]).
  assert (S2 : 0 < sqrt 2) by (apply sqrt_lt_R0; lra). assert (F : 0 < Rabs f) by (apply Rabs_pos_lt; lra). assert (SF : 0 < sqrt (Rabs f)) by (apply sqrt_lt_R0; lra).
  unfold printed_x, mended_x. set (a := PI ^ 2 * Rabs g) in *. set (b := 8 * sqrt 2). assert (B : 0 < b) by (unfold b; lra).
  split; [apply Rdiv_lt_0_compat; nra|]. split; [apply Rdiv_lt_0_compat; nra|]. intros E. apply N.
  assert (Q : sqrt (Rabs f) = Rabs f).
  { apply (Rmult_eq_compat_r (b * Rabs f * sqrt (Rabs f))) in E. replace (a / (b * Rabs f) * (b * Rabs f * sqrt (Rabs f))) with (a * sqrt (Rabs f)) in E by (field; lra).
    replace (a / (b * sqrt (Rabs f)) * (b * Rabs f * sqrt (Rabs f))) with (a * Rabs f) in E by (field; lra). apply Rmult_eq_reg_l in E; [exact E|lra]. }
  pose proof (sqrt_sqrt (Rabs f) ltac:(lra)) as S. rewrite Q in S. assert (Rabs f = 1) by nra. rewrite Rabs_left in H by exact Hf. lra.
Qed.
Lemma thm1_x_2_proved : thm1_x_2.
Proof.
  intros f g Hf Hg Nf (K & N0 & H). destruct (thm1_x_proved f g Hf Hg) as (K' & N1 & H'). destruct (thm1_proved f g Hf Hg) as (K'' & N2 & H'').
  destruct (both_x f g Hf Hg Nf) as (X0 & Y0 & XY). cbv zeta in H'. fold (mended_x f g) in H'. set (x := printed_x f g) in *. set (y := mended_x f g) in *.
  assert (C : 0 < Rabs (/ x - / y)).
  { apply Rabs_pos_lt. intros E. apply XY. rewrite <- (Rinv_inv x), <- (Rinv_inv y). f_equal. lra. }
  apply (too_large (Rabs (/ x - / y)) (K + K') (S (N0 + N1 + N2))); [exact C|]. intros N HN.
  destruct (H'' N ltac:(lia)) as [(w & A & P) _]. specialize (H N ltac:(lia) w A P). destruct (H' N ltac:(lia) w A P) as [A' _].
  assert (N1' : 1 <= INR N) by (apply (le_INR 1); lia).
  assert (T : Rabs ((INR N + 1) * (/ x - / y)) <= (K + K') / INR N).
  { replace ((INR N + 1) * (/ x - / y)) with ((A - (INR N + 1) / y) - (A - (INR N + 1) / x)) by (unfold Rdiv; ring).
    eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_Ropp. unfold Rdiv in *. lra. }
  rewrite Rabs_mult, (Rabs_pos_eq (INR N + 1)) in T by lra. apply (Rmult_le_compat_r (INR N)) in T; [|lra].
  replace ((K + K') / INR N * INR N) with (K + K') in T by (field; lra). nra.
Qed.
(* the exponential of two small numbers of one sign *)
Lemma exp_apart a b B : Rabs a <= B -> Rabs b <= B -> exp (- B) * Rabs (a - b) <= Rabs (exp a - exp b).
Proof.
  assert (W : forall a b, a <= b -> Rabs a <= B -> exp (- B) * (b - a) <= exp b - exp a).
  { intros p q L P. replace (exp q) with (exp p * exp (q - p)) by (rewrite <- exp_plus; f_equal; ring). pose proof (exp_ineq1_le (q - p)).
    assert (exp (- B) <= exp p). { apply Rabs_le_between in P. destruct (Req_dec (- B) p) as [->|N]; [lra|]. left. apply exp_increasing. lra. }
    pose proof (exp_pos (- B)). pose proof (exp_pos p). apply Rle_trans with (exp p * (q - p)); [apply Rmult_le_compat_r; lra|]. nra. }
  intros A B'. destruct (Rle_lt_dec a b) as [L|L].
  - rewrite (Rabs_minus_sym a b), (Rabs_minus_sym (exp a)), !Rabs_pos_eq; [now apply W| |lra]. specialize (W a b L A). pose proof (exp_pos (- B)). nra.
  - rewrite !Rabs_pos_eq; [apply W; lra| |lra]. specialize (W b a ltac:(lra) B'). pose proof (exp_pos (- B)). nra.
Qed.
Lemma roots_exist f g w : exists mp mm, ordered_roots f g w mp mm.
Proof.
  set (G := veerman_front.gamma f g w). pose proof (veerman_chain.mu_sum G) as S. pose proof (veerman_chain.mu_product G) as P.
  destruct (Rle_lt_dec (Cmod (veerman_chain.mu_minus G)) (Cmod (veerman_chain.mu_plus G))) as [L|L].
  - exists (veerman_chain.mu_plus G), (veerman_chain.mu_minus G). split; [rewrite gam_is; exact S|]. split; [exact P|exact L].
  - exists (veerman_chain.mu_minus G), (veerman_chain.mu_plus G). split; [rewrite gam_is, Cplus_comm; exact S|]. split; [rewrite Cmult_comm; exact P|lra].
Qed.
Lemma exponents_apart (s x y K K' : R) N0 : Rabs s = 1 -> 0 < x -> 0 < y -> x <> y -> (forall N, (N0 <= N)%nat -> exists m,
  Rabs (m - exp (s * x / (INR N + 1))) <= K / INR N ^ 3 /\ Rabs (m - exp (s * y / (INR N + 1))) <= K' / INR N ^ 3) -> False.
Proof.
  intros Sg X Y XY H. set (c := exp (- (x + y)) * Rabs (x - y)). assert (C : 0 < c) by (apply Rmult_lt_0_compat; [apply exp_pos|apply Rabs_pos_lt; lra]).
  apply (too_large c (2 * (K + K')) (S N0) C). intros N HN. destruct (H N ltac:(lia)) as (m & A & B). assert (N1 : 1 <= INR N) by (apply (le_INR 1); lia).
  set (n := INR N) in *. assert (Z : forall u, 0 < u -> Rabs (s * u / (n + 1)) <= u).
  { intros u U. unfold Rdiv. rewrite !Rabs_mult, Sg, Rmult_1_l, (Rabs_pos_eq u), Rabs_pos_eq by (try lra; left; apply Rinv_0_lt_compat; lra).
    apply Rmult_le_reg_r with (n + 1); [lra|]. rewrite Rmult_assoc, Rinv_l by lra. nra. }
  pose proof (exp_apart (s * x / (n + 1)) (s * y / (n + 1)) (x + y) ltac:(specialize (Z x X); lra) ltac:(specialize (Z y Y); lra)) as E.
  assert (T : Rabs (exp (s * x / (n + 1)) - exp (s * y / (n + 1))) <= (K + K') / n ^ 3).
  { replace (exp (s * x / (n + 1)) - exp (s * y / (n + 1))) with ((m - exp (s * y / (n + 1))) - (m - exp (s * x / (n + 1)))) by ring.
    eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_Ropp. unfold Rdiv in *. lra. }
  replace (s * x / (n + 1) - s * y / (n + 1)) with (s * (x - y) * / (n + 1)) in E by (unfold Rdiv; ring).
  rewrite !Rabs_mult, Sg, Rmult_1_l, (Rabs_pos_eq (/ (n + 1))) in E by (left; apply Rinv_0_lt_compat; lra).
  assert (Q : c * / (n + 1) <= (K + K') / n ^ 3) by (unfold c; lra). apply (Rmult_le_compat_r (n ^ 3 * (n + 1))) in Q; [|apply Rmult_le_pos; [apply pow_le|]; lra].
  replace (c * / (n + 1) * (n ^ 3 * (n + 1))) with (c * n ^ 3) in Q by (field; lra).
  replace ((K + K') / n ^ 3 * (n ^ 3 * (n + 1))) with ((K + K') * (n + 1)) in Q by (field; lra).
  assert (KK : 0 <= K + K'). { assert (0 < n ^ 3) by (apply pow_lt; lra). assert (0 <= c * n ^ 3) by (apply Rmult_le_pos; lra). nra. }
  assert (Q2 : c * n * n <= 2 * (K + K')).
  { apply Rmult_le_reg_r with n; [lra|]. replace (c * n * n * n) with (c * n ^ 3) by ring. eapply Rle_trans; [exact Q|]. nra. }
  apply Rle_trans with (c * n * n); [|exact Q2]. assert (0 < c * n) by (apply Rmult_lt_0_compat; lra). nra.
Qed.
Lemma thm1_x_1_proved : thm1_x_1.
Proof.
  intros f g Hf Hg Nf. destruct (thm1_x_proved f g Hf Hg) as (K' & N1 & H'). destruct (thm1_proved f g Hf Hg) as (K'' & N2 & H'').
  destruct (both_x f g Hf Hg Nf) as (X0 & Y0 & XY). cbv zeta in H'. fold (mended_x f g) in H'. split; intros (K & N0 & H).
  - apply (exponents_apart 1 (printed_x f g) (mended_x f g) K K' (N0 + N1 + N2)); [apply Rabs_R1|exact X0|exact Y0|exact XY|]. intros N HN.
    destruct (H'' N ltac:(lia)) as [(w & A & P) _]. destruct (roots_exist f g w) as (mp & mm & R). exists (Cmod mp ^ S N).
    specialize (H N ltac:(lia) w A mp mm P R). destruct R as (R1 & R2 & R3). destruct (H' N ltac:(lia) w A P) as [_ Q]. destruct (Q mp mm R1 R2 R3) as [Q1 _].
    rewrite !Rmult_1_l. split; assumption.
  - apply (exponents_apart (- (1)) (printed_x f g) (mended_x f g) K K' (N0 + N1 + N2)); [rewrite Rabs_Ropp; apply Rabs_R1|exact X0|exact Y0|exact XY|]. intros N HN.
    destruct (H'' N ltac:(lia)) as [(w & A & P) _]. destruct (roots_exist f g w) as (mp & mm & R). exists (Cmod mm ^ S N).
    specialize (H N ltac:(lia) w A mp mm P R). destruct R as (R1 & R2 & R3). destruct (H' N ltac:(lia) w A P) as [_ Q]. destruct (Q mp mm R1 R2 R3) as [_ Q2].
    replace (- (1) * printed_x f g) with (- printed_x f g) by ring. replace (- (1) * mended_x f g) with (- mended_x f g) by ring. split; assumption.
Qed.

(* veerman.specM clauses 2, 5 (stated after the theorems had been seen) *)
Definition specM_25 : Prop := forall N p lam, p = p1 \/ p = p2 N -> ((eig_L N p lam /\ lam <> 0%C) <-> eig N p lam).
Lemma specM_25_proved : specM_25.
Proof.
  intros N p lam Hp.
  assert (PS : veerman_lemma1.positive_spectrum N (veerman_stability.reduced p)).
  { destruct Hp; subst p; [exact (veerman_lemma1.positive_P1 N)|exact (veerman_lemma1.positive_P2 N)]. }
  split.
  - intros [(x & (k & Hk & Xk) & Z & E) NZ]. destruct (Ceq_dec (x 0%nat) 0%C) as [X0|X0]; [|now elim (Cmult_neq_0 _ _ NZ X0)].
    exists x. split; [exact X0|]. split; [|exact E]. exists k. split; [|exact Xk]. destruct k; [now rewrite X0 in Xk|lia].
  - intros El. split.
    + destruct El as (x & X0 & (k & Hk & Xk) & E). exists x. split; [exists k; split; [lia|exact Xk]|]. split; [rewrite X0; ring|exact E].
    + apply (eig_is N p lam Hp) in El. destruct (proj2 PS lam El) as (r & R0 & ->). intros Q. injection Q. lra.
Qed.
