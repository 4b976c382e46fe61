(* Veerman, Stosic, Olvera: Lemma 1, and where the printed spectrum of M fails (f = 0).
     veerman.lem1, veerman.specM (corrected, negation), and the whole statements of veerman.specP2 and veerman.eigAK. *)
From Coq Require Import Reals Lra Lia Psatz.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import veerman_complex veerman_chain veerman_stability.
Open Scope R_scope.

(* Routh and Hurwitz for nu^2 - lambda g nu - lambda f with a real lambda > 0 *)
Lemma quadratic_stable (f g lam : R) : 0 < lam ->
  ((forall nu : C, (nu * nu - lam * g * nu - lam * f = 0)%C -> fst nu < 0) <-> f < 0 /\ g < 0).
Proof.
  intros L. split.
  - intros H. set (d := (lam * g) ^ 2 + 4 * lam * f).
    destruct (Rle_lt_dec 0 d) as [D|D].
    + assert (SQ : sqrt d * sqrt d = d) by now apply sqrt_sqrt.
      assert (R1 : (lam * g + sqrt d) / 2 < 0).
      { apply (H ((lam * g + sqrt d) / 2, 0)). apply injective_projections; cbn; [|ring].
        transitivity ((sqrt d * sqrt d - (lam * g) ^ 2 - 4 * lam * f) / 4); [field|]. rewrite SQ. unfold d. field. }
      pose proof (sqrt_pos d). assert (lam * g < 0) by lra. assert (G : g < 0) by nra. split; [|exact G].
      assert (sqrt d < - (lam * g)) by lra.
      assert (sqrt d * sqrt d < (- (lam * g)) * (- (lam * g))) by (apply Rmult_le_0_lt_compat; lra).
      unfold d in SQ. assert (4 * lam * f < 0) by (unfold d in *; nra). nra.
    + assert (R1 : lam * g / 2 < 0).
      { apply (H (lam * g / 2, sqrt (- d) / 2)). assert (SQ : sqrt (- d) * sqrt (- d) = - d) by (apply sqrt_sqrt; lra).
        apply injective_projections; cbn; [|field].
        transitivity (- (sqrt (- d) * sqrt (- d)) / 4 - (lam * g) ^ 2 / 4 - lam * f); [field|]. rewrite SQ. unfold d. field. }
      unfold d in D. pose proof (pow2_ge_0 (lam * g)). split; nra.
  - intros [F G] [p q] H. assert (H1 := f_equal fst H). assert (H2 := f_equal snd H). cbn in H1, H2 |- *.
    destruct (Req_dec q 0) as [Q|Q].
    + subst q. destruct (Rlt_le_dec p 0) as [P|P]; [exact P|exfalso].
      assert (0 < lam * - f) by (apply Rmult_lt_0_compat; lra). assert (0 <= lam * - g * p) by (repeat apply Rmult_le_pos; lra). nra.
    + assert (q * (2 * p - lam * g) = 0) by lra. apply Rmult_integral in H0 as [E|E]; [contradiction|].
      assert (0 < lam * - g) by (apply Rmult_lt_0_compat; lra). lra.
Qed.

Definition stable N P f g := forall nu, eigenvalue_M N P f g nu -> fst nu < 0.
(* all eigenvalues of P real and positive, and there is one *)
Definition positive_spectrum N P := (exists lam, eigenvalue N P lam) /\
  forall lam, eigenvalue N P lam -> exists r, 0 < r /\ lam = RtoC r.

Lemma stable_iff N P f g : local N P -> positive_spectrum N P -> (stable N P f g <-> f < 0 /\ g < 0).
Proof.
  intros LP [[lam0 H0] HP]. split.
  - intros S. destruct (HP lam0 H0) as (r & R0 & E). subst lam0. apply (quadratic_stable f g r R0).
    intros nu Hn. apply S. apply spectrum_M; [exact LP | now exists (RtoC r)|].
    exists (RtoC r). split; [exact H0|]. now apply eigenvalue_AK_iff.
  - intros FG nu Hn. apply spectrum_M in Hn as (lam & Hl & HA); [|exact LP | now exists lam0].
    destruct (HP lam Hl) as (r & R0 & E). subst lam. apply eigenvalue_AK_iff in HA.
    exact (proj2 (quadratic_stable f g r R0) FG nu HA).
Qed.

Lemma positive_P1 N : positive_spectrum N P1.
Proof.
  split; [exists (RtoC 1); now apply spectrum_P1|]. intros lam H. apply spectrum_P1 in H. exists 1. split; [lra|exact H].
Qed.
Lemma positive_P2 N : positive_spectrum N (P2 N).
Proof.
  split.
  - exists (RtoC (1 - cos (angle N 1))). apply spectrum_P2. exists 1%nat. split; [lia|reflexivity].
  - intros lam H. apply spectrum_P2 in H as (k & Hk & E). fold (angle N k) in E. exists (1 - cos (angle N k)).
    split; [|exact E]. pose proof (angle_range N k Hk) as A.
    assert (cos (angle N k) < cos 0); [|rewrite cos_0 in *; lra]. apply cos_decreasing_1; lra.
Qed.

(* veerman.lem1: for every N, and so for all N together *)
Theorem lemma_1 f g :
  (forall N, stable N P1 f g <-> f < 0 /\ g < 0) /\ (forall N, stable N (P2 N) f g <-> f < 0 /\ g < 0) /\
  ((forall N, stable N P1 f g /\ stable N (P2 N) f g) <-> f < 0 /\ g < 0).
Proof.
  assert (A : forall N, stable N P1 f g <-> f < 0 /\ g < 0) by (intros; apply stable_iff; [apply local1|apply positive_P1]).
  assert (B : forall N, stable N (P2 N) f g <-> f < 0 /\ g < 0) by (intros; apply stable_iff; [apply local2|apply positive_P2]).
  split; [exact A|]. split; [exact B|]. split.
  - intros H. apply (A 0%nat), H.
  - intros H N. split; [now apply A|now apply B].
Qed.

(* veerman.specM for both systems, without removing 0, for all real f and g *)
Theorem spectrum_M_systems N f g nu :
  (eigenvalue_M N P1 f g nu <-> exists lam, L_eigenvalue N row1 lam /\ lam <> 0%C /\ eigenvalue_AK f g lam nu) /\
  (eigenvalue_M N (P2 N) f g nu <-> exists lam, L_eigenvalue N (row2 N) lam /\ lam <> 0%C /\ eigenvalue_AK f g lam nu).
Proof.
  assert (G : forall row, local N (reduced row) -> positive_spectrum N (reduced row) ->
    (forall x y k, (1 <= k <= S N)%nat -> (forall j, (j <= S N)%nat -> x j = y j) -> row x k = row y k) ->
    (eigenvalue_M N (reduced row) f g nu <-> exists lam, L_eigenvalue N row lam /\ lam <> 0%C /\ eigenvalue_AK f g lam nu)).
  { intros row LP [EX POS] LE. rewrite spectrum_M by assumption. split.
    - intros (lam & Hl & HA). exists lam.
      assert (NZ : lam <> 0%C). { destruct (POS lam Hl) as (r & R0 & E). rewrite E. intros Z. injection Z as Z. lra. }
      split; [now apply spectrum_L|]. now split.
    - intros (lam & Hl & NZ & HA). exists lam. split; [now apply spectrum_L|exact HA]. }
  split; apply G.
  - apply local1.
  - apply positive_P1.
  - intros x y k Hk E. unfold row1. now rewrite !E by lia.
  - apply local2.
  - apply positive_P2.
  - intros x y k Hk E. unfold row2. destruct (Nat.eqb_spec k (S N)) as [L|L]; now rewrite !E by lia.
Qed.

(* 0 is no eigenvalue of P_1, P_2, so the nonzero eigenvalues of L are all of those of P; and none of M if f <> 0 *)
Theorem spectrum_L_systems N lam : (L_eigenvalue N row1 lam /\ lam <> 0%C <-> eigenvalue N P1 lam) /\
  (L_eigenvalue N (row2 N) lam /\ lam <> 0%C <-> eigenvalue N (P2 N) lam).
Proof.
  assert (G : forall row, positive_spectrum N (reduced row) -> (forall x y k, (1 <= k <= S N)%nat -> (forall j, (j <= S N)%nat -> x j = y j) -> row x k = row y k) ->
    (L_eigenvalue N row lam /\ lam <> 0%C <-> eigenvalue N (reduced row) lam)).
  { intros row [_ POS] LE. split.
    - intros [H NZ]. now apply (spectrum_L N row lam LE NZ).
    - intros H. assert (NZ : lam <> 0%C). { destruct (POS lam H) as (r & R0 & E). rewrite E. intros Z. injection Z as Z. lra. }
      split; [now apply (spectrum_L N row lam LE NZ)|exact NZ]. }
  split; apply G; [apply positive_P1| |apply positive_P2|]; intros x y k Hk E.
  - unfold row1. now rewrite !E by lia.
  - unfold row2. destruct (Nat.eqb_spec k (S N)) as [L|L]; now rewrite !E by lia.
Qed.
Theorem spectrum_M_nonzero N f g : f <> 0 -> ~ eigenvalue_M N P1 f g 0%C /\ ~ eigenvalue_M N (P2 N) f g 0%C.
Proof.
  intros F. assert (G : forall lam : C, lam <> 0%C -> ~ eigenvalue_AK f g lam 0%C).
  { intros lam NZ H. apply eigenvalue_AK_iff in H. assert (E : (lam * f)%C = 0%C) by (transitivity (- (0 * 0 - lam * g * 0 - lam * f))%C; [ring|rewrite H; ring]).
    apply NZ, (Cmult_cancel_r _ _ (RtoC f)); [intros Z; injection Z as Z; contradiction|rewrite E; ring]. }
  split; intros H; [apply (proj1 (spectrum_M_systems N f g 0%C)) in H|apply (proj2 (spectrum_M_systems N f g 0%C)) in H]; destruct H as (lam & _ & NZ & H); now apply (G lam NZ).
Qed.

(* as printed, with 0 removed on the left only, it fails at f = 0: 0 is then an eigenvalue of every A + lambda K *)
Theorem spectrum_M_printed_fails N g : exists nu lam, L_eigenvalue N row1 lam /\ lam <> 0%C /\ eigenvalue_AK 0 g lam nu /\
  ~ (eigenvalue_M N P1 0 g nu /\ nu <> 0%C).
Proof.
  exists 0%C, (RtoC 1). split; [|split; [exact C1_neq0|split]].
  - apply spectrum_L; [|exact C1_neq0 | now apply spectrum_P1].
    intros x y k Hk E. unfold row1. now rewrite !E by lia.
  - apply eigenvalue_AK_iff. ring.
  - intros [_ H]. now apply H.
Qed.

(* veerman.specP2, whole *)
Theorem spectrum_P2_whole N :
  (forall lam, eigenvalue N (P2 N) lam <->
     exists k, (1 <= k <= S N)%nat /\ lam = RtoC (1 - cos ((2 * INR k - 1) * PI / (2 * (INR N + 1))))) /\
  (forall j k, (1 <= j <= S N)%nat -> (1 <= k <= S N)%nat -> j <> k -> 1 - cos (angle N j) <> 1 - cos (angle N k)) /\
  (forall lam x y, eigenvector N (P2 N) lam x -> eigenvector N (P2 N) lam y ->
     exists c, forall k, (1 <= k <= S N)%nat -> y k = (c * x k)%C).
Proof. split; [exact (spectrum_P2 N)|exact (spectrum_P2_simple N)]. Qed.
(* veerman.eigAK, whole *)
Theorem eigenvalues_AK (f g : R) (lam : C) :
  (forall nu, eigenvalue_AK f g lam nu <-> (nu * nu - lam * g * nu - lam * f = 0)%C) /\
  (forall nu s, (s * s = (lam * g) * (lam * g) + 4 * lam * f)%C ->
     (eigenvalue_AK f g lam nu <-> nu = (/ 2 * (lam * g + s))%C \/ nu = (/ 2 * (lam * g - s))%C)).
Proof.
  split; [intros nu; apply eigenvalue_AK_iff|]. intros nu s Hs. rewrite eigenvalue_AK_iff. now apply quadratic_formula.
Qed.
