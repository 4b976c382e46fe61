(* Clauses of the claims about Paley's paper, formalised from their words before the theorems were looked at; the theorems
   prove them. *)
From Coq Require Import Reals Lra Lia List Relations Psatz.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums paley_model paley_phase paley_laplacian paley_gradient paley_fourier paley_particles paley_patterns.
From Flockproof Require paley_fish paley_centre paley_convergence paley_composite paley_stability.
Open Scope R_scope.

(* particles (1), (2) with steering u at time t *)
Definition particles (n : nat) (r : nat -> R -> C) (th : nat -> R -> R) (u : nat -> R) (t : R) :=
  forall k, (k < n)%nat -> is_velocity (r k) t (expi (th k t)) /\ is_derive (th k) t (u k).
Notation at_time f t := (fun k => f k t) (only parsing).
(* circle centres c_k = r_k + i e^{i th_k}/w0, and <e^{i th_k}, L_k c> *)
Definition ck (w0 : R) (r : nat -> C) (th : nat -> R) (k : nat) : C := (r k + RtoC (/ w0) * (Ci * expi (th k)))%C.
Definition Lc (n : nat) (adj : graph) (w0 : R) (r : nat -> C) (th : nat -> R) (k : nat) : R :=
  inner (expi (th k)) (Csum n (fun j => RtoC (lap n adj k j) * ck w0 r th j))%C.
Definition Lth (n : nat) (adj : graph) (th : nat -> R) (k : nat) : R :=
  inner (Ci * expi (th k))%C (Csum n (fun j => RtoC (lap n adj k j) * expi (th j)))%C.
Definition S17 (n : nat) (adj : graph) (w0 : R) (r : nat -> C) (th : nat -> R) : R :=
  / (2 * INR n) * Sum n (fun k => inner (ck w0 r th k) (Csum n (fun j => RtoC (lap n adj k j) * ck w0 r th j))%C).
Definition u20 n adj w0 K0 r th k := w0 + w0 * (K0 / INR n) * Lc n adj w0 r th k.

(* paley.thm2.center clause 1: under (20) thdot tends to w0 and the centres to one point; undirected connected graph *)
Definition thm2_1 : Prop := forall n adj w0 K0 r th, (1 <= n)%nat -> undirected adj -> no_loops adj -> strongly_connected n adj ->
  w0 <> 0 -> 0 < K0 -> (forall t, 0 <= t -> particles n r th (u20 n adj w0 K0 (at_time r t) (at_time th t)) t) ->
  exists c0 : C, forall k, (k < n)%nat -> forall e, 0 < e -> exists T, forall t, T <= t ->
    Cmod (ck w0 (at_time r t) (at_time th t) k - c0)%C < e /\ Rabs (u20 n adj w0 K0 (at_time r t) (at_time th t) k - w0) < e.
(* clause 2: of two motions from one initial state the centres are the same *)
Definition ends_at n w0 (r : nat -> R -> C) (th : nat -> R -> R) (c0 : C) := forall k, (k < n)%nat -> forall e, 0 < e ->
  exists T, forall t, T <= t -> Cmod (ck w0 (at_time r t) (at_time th t) k - c0)%C < e.
Definition thm2_2 : Prop := forall n adj w0 K0 r th r' th' c0 c0', (1 <= n)%nat -> undirected adj -> no_loops adj ->
  strongly_connected n adj -> w0 <> 0 -> 0 < K0 ->
  (forall t, 0 <= t -> particles n r th (u20 n adj w0 K0 (at_time r t) (at_time th t)) t) ->
  (forall t, 0 <= t -> particles n r' th' (u20 n adj w0 K0 (at_time r' t) (at_time th' t)) t) ->
  (forall k, (k < n)%nat -> r k 0 = r' k 0 /\ expi (th k 0) = expi (th' k 0)) ->
  ends_at n w0 r th c0 -> ends_at n w0 r' th' c0' -> c0 = c0'.

(* paley.thm3.min *)
Definition UMN (n M : nat) (K : nat -> R) (th : nat -> R) : R :=
  Sum M (fun i => K (S i) * (INR n / 2 * Cmod (RtoC (/ (INR (S i) * INR n)) * Csum n (fun k => expi (INR (S i) * th k)))%C ^ 2)).
Definition thm3 : Prop := forall n M K th, (1 <= n)%nat -> (1 <= M)%nat -> (exists q, n = (M * q)%nat) ->
  (forall m, (1 <= m < M)%nat -> 0 < K m) -> K M < 0 ->
  (pattern M n th <-> forall th', UMN n M K th <= UMN n M K th').
(* paley.eq21 clause 2 *)
Definition u22 n adj w0 K0 K1 r th k :=
  w0 + (K1 - K0) / INR n * Lth n adj th k + w0 * (K0 / INR n) * inner (expi (th k)) (Csum n (fun j => RtoC (lap n adj k j) * r j))%C.
Definition eq21_2 : Prop := forall n adj w0 K0 K1 r th t, (1 <= n)%nat -> undirected adj -> w0 <> 0 ->
  particles n r th (u22 n adj w0 K0 K1 (at_time r t) (at_time th t)) t ->
  is_derive (fun s => K0 * S17 n adj w0 (at_time r s) (at_time th s) - K1 * / w0 ^ 2 * W1 n adj (at_time th s)) t
    (- / INR n ^ 2 * Sum n (fun k => (K0 * Lc n adj w0 (at_time r t) (at_time th t) k + K1 * / w0 * Lth n adj (at_time th t) k) ^ 2)).
(* paley.VMN clause 2; (25): the partial derivatives of U^{M,N} are g *)
Definition VMN_2 : Prop := forall n adj w0 K0 M K r th t (g : nat -> R), (1 <= n)%nat -> (1 <= M)%nat -> undirected adj -> w0 <> 0 ->
  (forall k, (k < n)%nat -> partial (UMN n M K) (at_time th t) k (g k)) ->
  let u k := w0 - g k + w0 * (K0 / INR n) * Lc n adj w0 (at_time r t) (at_time th t) k in
  particles n r th u t ->
  is_derive (fun s => K0 * S17 n adj w0 (at_time r s) (at_time th s) + / w0 ^ 2 * UMN n M K (at_time th s)) t
    (- / w0 ^ 2 * Sum n (fun k => (u k - w0) ^ 2)).
(* paley.eq19_20 clauses 1, 2, 3 *)
Definition eq19 : Prop := forall n adj w0 r th u t, (1 <= n)%nat -> undirected adj -> w0 <> 0 -> particles n r th u t ->
  is_derive (fun s => S17 n adj w0 (at_time r s) (at_time th s)) t
    (/ INR n * Sum n (fun k => Lc n adj w0 (at_time r t) (at_time th t) k * (1 - / w0 * u k))).
Definition eq20 : Prop := forall n adj w0 K0 r th t, (1 <= n)%nat -> undirected adj -> w0 <> 0 ->
  particles n r th (u20 n adj w0 K0 (at_time r t) (at_time th t)) t ->
  let rate := - (K0 / INR n ^ 2) * Sum n (fun k => Lc n adj w0 (at_time r t) (at_time th t) k ^ 2) in
  is_derive (fun s => S17 n adj w0 (at_time r s) (at_time th s)) t rate /\ (0 < K0 -> rate <= 0).
(* paley.eq14_15 *)
Definition eq14_1 : Prop := forall n adj w0 K1 th t, (1 <= n)%nat -> undirected adj ->
  (forall k, (k < n)%nat -> is_derive (th k) t (w0 + K1 / INR n * Lth n adj (at_time th t) k)) ->
  is_derive (fun s => W1 n adj (at_time th s)) t (K1 / INR n ^ 2 * Sum n (fun k => Lth n adj (at_time th t) k ^ 2)).
Definition eq14_2 : Prop := forall n adj w0 K1 th k, (1 <= n)%nat -> (k < n)%nat ->
  w0 + K1 / INR n * Lth n adj th k = w0 + K1 / INR n * Sum n (fun j => (if adj k j then 1 else 0) * sin (th k - th j)).
(* paley.eq12.pos *)
Definition eq12 : Prop := forall n adj th, (1 <= n)%nat ->
  W1 n adj th = / (2 * INR n) * Sum n (fun k => deg n adj k - Sum n (fun j => (if adj k j then 1 else 0) * inner (expi (th k)) (expi (th j)))) /\
  0 <= W1 n adj th /\
  (strongly_connected n adj -> (W1 n adj th = 0 <-> synchronized n th) /\ (~ synchronized n th -> 0 < W1 n adj th)).
(* paley.zero.dir clauses 3, 4: for every directed graph *)
Definition zero_dir : Prop := forall n adj th, (1 <= n)%nat ->
  let same := forall j k, clos_refl_sym_trans nat (arc n adj) j k -> expi (th j) = expi (th k) in
  (W1 n adj th = 0 <-> same) /\ (~ same -> 0 < W1 n adj th).
(* paley.graph clauses 1 to 5 *)
Definition eigenpair n adj (lam : C) (x : nat -> C) := (exists k, (k < n)%nat /\ x k <> 0%C) /\
  forall k, (k < n)%nat -> Csum n (fun j => RtoC (lap n adj k j) * x j)%C = (lam * x k)%C.
Definition graph_1 : Prop := forall n adj lam x, eigenpair n adj lam x -> 0 <= fst lam.
Definition graph_2 : Prop := forall n adj k, (k < n)%nat -> Sum n (fun j => lap n adj k j) = 0.
(* the kernel of no power of L is larger than the constant vectors, complex ones included *)
Definition apply_L n adj (x : nat -> C) (k : nat) : C := Csum n (fun j => RtoC (lap n adj k j) * x j)%C.
Definition graph_3 : Prop := forall n adj m (x : nat -> C), (1 <= n)%nat -> strongly_connected n adj ->
  (forall k, (k < n)%nat -> Nat.iter m (apply_L n adj) x k = 0%C) -> forall j k, (j < n)%nat -> (k < n)%nat -> x j = x k.
Definition graph_4 : Prop := forall n adj, undirected adj -> (forall j k, lap n adj j k = lap n adj k j) /\
  forall x : nat -> R, 0 <= Sum n (fun k => x k * Sum n (fun j => lap n adj k j * x j)).
(* F^* L F is diagonal and F is unitary: the columns of F are eigenvectors, orthonormal *)
Definition fourier (n m k : nat) : C := (RtoC (/ sqrt (INR n)) * expi (2 * PI / INR n * (INR m * INR k)))%C.
Definition graph_5 : Prop := forall n adj, (1 <= n)%nat ->
  (forall k j k' j', (k < n)%nat -> (j < n)%nat -> (k' < n)%nat -> (j' < n)%nat ->
     ((j + n - k) mod n = (j' + n - k') mod n)%nat -> adj k j = adj k' j') ->
  (forall m, (m < n)%nat -> exists lam, forall k, (k < n)%nat -> apply_L n adj (fourier n m) k = (lam * fourier n m k)%C) /\
  forall m m', (m < n)%nat -> (m' < n)%nat ->
    Csum n (fun k => Cconj (fourier n m k) * fourier n m' k)%C = if Nat.eqb m m' then 1%C else 0%C.
(* paley.thm1.saddle clauses 1, 2 *)
Definition saddle_12 : Prop := forall n th, (1 <= n)%nat -> stationary n (U1 n) th -> ~ synchronized n th -> ~ balanced n th ->
  (forall e, 0 < e -> (exists a, (forall k, (k < n)%nat -> Rabs (a k - th k) < e) /\ U1 n th < U1 n a) /\
                      exists b, (forall k, (k < n)%nat -> Rabs (b k - th k) < e) /\ U1 n b < U1 n th) /\
  forall j k, (j < n)%nat -> (k < n)%nat -> sin (th k - th j) = 0.
(* paley.thm1.sync clause 1: the set of synchronised arrangements is stable and attracts its neighbours *)
Definition apart n (th : nat -> R) (d : R) := forall j k, (j < n)%nat -> (k < n)%nat -> Cmod (expi (th j) - expi (th k))%C < d.
Definition sync_1 : Prop := forall n w0 K1, (1 <= n)%nat -> K1 < 0 ->
  let moves th := forall t, 0 <= t -> forall k, (k < n)%nat ->
    is_derive (th k) t (w0 - K1 * inner (Ci * expi (th k t))%C (RtoC (/ INR n) * Csum n (fun j => expi (th j t)))%C) in
  (forall e, 0 < e -> exists d, 0 < d /\ forall th, moves th -> apart n (at_time th 0) d -> forall t, 0 <= t -> apart n (at_time th t) e) /\
  exists d, 0 < d /\ forall th, moves th -> apart n (at_time th 0) d -> forall e, 0 < e -> exists T, forall t, T <= t -> apart n (at_time th t) e.
(* paley.eq17 clauses 1, 2, 3: proper: bounded S bounds the relative centres *)
Definition S_of n adj (c : nat -> C) := / (2 * INR n) * Sum n (fun k => inner (c k) (apply_L n adj c k)).
Definition eq17 : Prop := forall n adj, (1 <= n)%nat -> undirected adj -> strongly_connected n adj ->
  (forall c, (S_of n adj c = 0 <-> exists c0, forall k, (k < n)%nat -> c k = c0) /\ 0 <= S_of n adj c) /\
  forall b, exists B, forall c, S_of n adj c <= b -> forall j k, (j < n)%nat -> (k < n)%nat -> Cmod (c k - c j)%C <= B.
(* paley.eq16, paley.gradW, paley.eq8_10 clauses 1, 2, 4 *)
Definition eq16 : Prop := forall n adj th, (1 <= n)%nat -> undirected adj ->
  ((forall k, (k < n)%nat -> Lth n adj th k = 0) <-> stationary n (W1 n adj) th).
Definition gradW : Prop := forall n adj th k, (1 <= n)%nat -> undirected adj -> (k < n)%nat ->
  partial (W1 n adj) th k (/ (2 * INR n) * inner (Ci * expi (th k))%C (Csum n (fun j => RtoC (lap n adj k j + lap n adj j k) * expi (th j)))%C) /\
  partial (W1 n adj) th k (/ INR n * Lth n adj th k).
Definition eq8_124 : Prop := forall n th, (1 <= n)%nat ->
  let g th k := inner (Ci * expi (th k))%C (order n th) in
  (forall k, (k < n)%nat -> partial (U1 n) th k (g th k)) /\ Sum n (g th) = 0 /\
  forall w0 K1 (ph : nat -> R -> R) t, (forall k, (k < n)%nat -> is_derive (ph k) t (w0 - K1 * g (at_time ph t) k)) ->
    is_derive (fun s => U1 n (at_time ph s)) t (- K1 * Sum n (fun k => g (at_time ph t) k ^ 2)).
(* paley.eig.sym clause 2; columns counted from 1 *)
Definition eig_sym_2 : Prop := forall n m th, (1 <= n)%nat -> (2 <= m <= n)%nat ->
  (exists rot, forall k, (k < n)%nat -> expi (th k) = expi (rot + 2 * PI / INR n * (INR (m - 1) * INR k))) ->
  pattern (n / Nat.gcd n (m - 1)) n th.
(* paley.eq23 clauses 1, 2, 3 *)
Definition eq23 : Prop := forall M n th, (1 <= n)%nat -> pattern M n th ->
  (forall m, (1 <= m < M)%nat -> Csum n (fun k => expi (INR m * th k)) = 0%C) /\
  INR M * Cmod (RtoC (/ (INR M * INR n)) * Csum n (fun k => expi (INR M * th k)))%C = 1 /\
  (~ synchronized n th -> balanced n th).

(* ---- the theorems prove them ---- *)
Lemma thm3_proved : thm3.
Proof.
  intros n M K th Hn HM [q E] P1 P2. apply (thm3_minimizers n M q K th); try assumption; [|lia].
  destruct q; [lia|lia].
Qed.
Lemma eq19_proved : eq19.
Proof.
  intros n adj w0 r th u t Hn S W P. apply (paley_particles.eq19 n adj w0 Hn S r th u t); intros k Hk; now apply P.
Qed.
Lemma eq20_proved : eq20.
Proof.
  intros n adj w0 K0 r th t Hn S W P rate. split.
  - apply (paley_particles.eq20 n adj w0 K0 Hn W S r th _ t (fun k Hk => proj1 (P k Hk)) (fun k Hk => proj2 (P k Hk))).
    intros k Hk. unfold u20. rewrite Rmult_assoc. reflexivity.
  - intros HK. apply (eq20_sign n adj w0 K0 Hn r th (u20 n adj w0 K0 (fun k => r k t) (fun k => th k t)) t HK).
    intros k Hk. unfold u20. rewrite Rmult_assoc. reflexivity.
Qed.
Lemma eq21_2_proved : eq21_2.
Proof.
  intros n adj w0 K0 K1 r th t Hn S W P.
  refine (eq21_corrected n adj w0 K0 K1 Hn W S r th _ t (fun k Hk => proj1 (P k Hk)) (fun k Hk => proj2 (P k Hk)) _).
  intros k Hk. rewrite (eq22 n adj w0 K0 K1 Hn W). reflexivity.
Qed.
Lemma VMN_2_proved : VMN_2.
Proof.
  intros n adj w0 K0 M K r th t g Hn HM S W G u P.
  assert (E : forall k, (k < n)%nat -> u k = paley_composite.pattern_control n adj w0 K0 M K r th t k).
  { intros k Hk. unfold u, paley_composite.pattern_control.
    pose proof (is_derive_unique _ _ _ (G k Hk)) as U1. pose proof (is_derive_unique _ _ _ (paley_composite.UMN_gradient n M K (fun k => th k t) k Hn Hk)) as U2.
    change (paley_patterns.UMN n M K) with (UMN n M K) in U2. rewrite U2 in U1. rewrite <- U1. rewrite Rmult_assoc. reflexivity. }
  rewrite (Sum_ext n _ (fun k => (paley_composite.pattern_control n adj w0 K0 M K r th t k - w0) ^ 2)) by (intros k Hk; now rewrite (E k Hk)).
  apply (paley_composite.VMN_corrected n adj w0 K0 M K Hn W S r th t).
  - intros k Hk. apply (P k Hk).
  - intros k Hk. rewrite <- (E k Hk). apply (P k Hk).
Qed.
Lemma eq14_1_proved : eq14_1.
Proof. intros n adj w0 K1 th t Hn S D. exact (W1_rate n adj th w0 K1 t Hn S D). Qed.
Lemma eq14_2_proved : eq14_2.
Proof. intros n adj w0 K1 th k Hn Hk. exact (control14_sines n adj th k w0 K1 Hk). Qed.
Lemma eq12_proved : eq12.
Proof.
  intros n adj th Hn. split; [exact (proj2 (W1_formula n adj th))|]. pose proof (W1_ge0 n adj th Hn) as G. split; [exact G|].
  intros SC. pose proof (W1_strongly n adj th Hn SC) as Q. split; [exact Q|]. intros N.
  destruct (Rle_lt_or_eq_dec _ _ G) as [L|E]; [exact L|]. exfalso. apply N, Q. now symmetry.
Qed.
Lemma zero_dir_proved : zero_dir.
Proof.
  intros n adj th Hn same. destruct (fish_zero n adj th Hn) as (G & _ & Q).
  assert (E : W1 n adj th = 0 <-> same).
  { split; [exact Q|]. intros H. destruct (W1_formula n adj th) as [_ F]. rewrite F.
    rewrite (Sum_ext n _ (fun _ => 0)); [|].
    - replace (Sum n (fun _ => 0)) with 0; [ring|]. clear. induction n; cbn; lra.
    - intros k Hk. unfold deg. replace (Sum n (w adj k)) with (Sum n (fun j => w adj k j * inner (expi (th k)) (expi (th j)))); [ring|].
      apply Sum_ext. intros j Hj. unfold w. destruct (adj k j) eqn:A; [|ring].
      rewrite (H j k); [|apply rst_step; repeat split; assumption].
      rewrite Rmult_1_l. unfold inner, expi, Re, Cconj. cbn. pose proof (sin2_cos2 (th k)) as T. unfold Rsqr in T. nra. }
  split; [exact E|]. intros N. destruct (Rle_lt_or_eq_dec _ _ G) as [L|Z]; [exact L|]. exfalso. apply N, E. now symmetry.
Qed.
Lemma graph_1_proved : graph_1.
Proof. intros n adj lam x [N E]. exact (lap_eigenvalues n adj lam x E N). Qed.
Lemma graph_2_proved : graph_2.
Proof.
  intros n adj k Hk. rewrite (Sum_ext n _ (fun j => lap n adj k j * 1)) by (intros; ring). exact (lap_ones n adj 1 k Hk).
Qed.
Lemma graph_4_proved : graph_4.
Proof.
  intros n adj S. split; [intros j k; now apply (lap_psd n adj (fun _ => 0%C) S)|].
  intros x. destruct (lap_psd n adj (fun k => RtoC (x k)) S) as [_ P].
  rewrite (Sum_ext n _ (fun k => x k * Sum n (fun j => lap n adj k j * x j))) in P; [exact P|].
  intros k _. unfold row, Csum, inner, Re, Cconj. cbn.
  rewrite (Sum_ext n (fun j => lap n adj k j * x j - 0 * 0) (fun j => lap n adj k j * x j)) by (intros; ring). ring.
Qed.
Lemma saddle_12_proved : saddle_12.
Proof.
  intros n th Hn S N B. destruct (thm1_saddle n th Hn S N B) as [P [_ Q]]. split; [|exact P].
  intros e He. destruct (Q e He) as [[a [A1 A2]] [b [B1 B2]]]. split; [exists a|exists b]; split; assumption.
Qed.
Lemma eq17_proved : eq17.
Proof.
  intros n adj Hn S SC. split.
  - intros c. destruct (Q_kernel n adj c Hn S SC) as [P Q]. split; assumption.
  - intros b. destruct (spacing_proper n adj Hn S SC) as [B [HB P]]. exists (sqrt (B * Rmax 0 b)). intros c Hc j k Hj Hk.
    specialize (P c k j Hk Hj). rewrite <- (sqrt_pow2 (Cmod (c k - c j)%C)) by apply Cmod_ge_0. apply sqrt_le_1_alt.
    assert (E : Cmod (c k - c j)%C ^ 2 = dist2 (c k) (c j)).
    { unfold dist2, inner, Re, Cconj, Cmod. rewrite pow2_sqrt; [cbn; ring|]. apply Rplus_le_le_0_compat; apply pow2_ge_0. }
    rewrite E. eapply Rle_trans; [exact P|]. apply Rmult_le_compat_l; [exact HB|].
    eapply Rle_trans; [exact Hc|apply Rmax_r].
Qed.
Lemma eq16_proved : eq16.
Proof. intros n adj th Hn S. exact (paley_gradient.eq16 n adj th Hn S). Qed.
Lemma gradW_proved : gradW.
Proof.
  intros n adj th k Hn S Hk. split; [exact (W1_gradient n adj th k Hn Hk)|exact (proj2 (W1_gradient_undirected n adj th k Hn S Hk))].
Qed.
Lemma eq8_124_proved : eq8_124.
Proof.
  intros n th Hn g. split; [intros k Hk; exact (U1_gradient n th k Hn Hk)|]. split; [exact (gradient_orthogonal n th)|].
  intros w0 K1 ph t D. apply (U1_rate n ph w0 K1 t Hn). intros k Hk. specialize (D k Hk).
  replace (w0 + - K1 * g1 n (fun k0 => ph k0 t) k) with (w0 - K1 * g (fun k => ph k t) k) by (unfold g, g1; ring). exact D.
Qed.
Lemma eig_sym_2_proved : eig_sym_2.
Proof.
  intros n m th Hn Hm [rot E]. destruct (paley_fish.wave_pattern n (m - 1) Hn) as [H1 [th0 [cl [P Q]]]].
  split; [exact H1|]. exists (rot + th0), cl. split; [|exact Q]. intros k Hk. destruct (P k Hk) as [A B]. split; [exact A|].
  rewrite (E k Hk). assert (X : forall a b, expi (a + b) = (expi a * expi b)%C).
  { intros a b. unfold expi. rewrite cos_plus, sin_plus. apply injective_projections; cbn; ring. }
  rewrite Rplus_assoc, !(X rot). f_equal. rewrite <- B. f_equal. unfold wave. field. apply not_0_INR. lia.
Qed.
Lemma eq23_proved : eq23.
Proof.
  intros M n th Hn P. destruct (paley_patterns.eq23 M n th Hn P) as [A B]. split; [|split].
  - intros m Hm. specialize (A m Hm). unfold moment in A.
    assert (N : RtoC (/ (INR m * INR n)) <> 0%C).
    { intros Z. apply (f_equal fst) in Z. cbn in Z. assert (0 < INR m) by (apply lt_0_INR; lia). assert (0 < INR n) by (apply lt_0_INR; lia).
      assert (0 < / (INR m * INR n)) by (apply Rinv_0_lt_compat, Rmult_lt_0_compat; assumption). lra. }
    set (z := Csum n _) in *. destruct (Ceq_dec z 0%C) as [Z|Z]; [exact Z|]. exfalso. exact (Cmult_neq_0 _ _ N Z A).
  - exact B.
  - intros N. apply (pattern_balanced M n th Hn); [|exact P]. destruct (Nat.le_gt_cases 2 M) as [L|L]; [exact L|]. exfalso. apply N.
    destruct P as [HM [th0 [cl [P _]]]]. intros j k Hj Hk. destruct (P j Hj) as [Cj Ej]. destruct (P k Hk) as [Ck Ek].
    rewrite Ej, Ek. replace (cl j) with (cl k) by lia. reflexivity.
Qed.
Lemma thm2_1_proved : thm2_1.
Proof.
  intros n adj w0 K0 r th Hn S _ SC W HK M.
  destruct (paley_convergence.centres_meet n adj w0 K0 r th Hn S SC W HK) as (c0 & T & A & m & _ & Hm & H).
  { intros k t Hk Ht. destruct (M t Ht k Hk) as [V D]. split; [exact V|]. unfold u20 in D. rewrite Rmult_assoc in D. exact D. }
  exists c0. intros k Hk e He. destruct (paley_convergence.exp_small m e A Hm He) as [T' [_ L]]. exists (Rmax T T'). intros t Ht.
  pose proof (Rmax_l T T'). pose proof (Rmax_r T T'). specialize (L t ltac:(lra)). destruct (H k t Hk ltac:(lra)) as [P Q]. split.
  - exact (Rle_lt_trans _ _ _ P L).
  - unfold u20. rewrite Rmult_assoc. match goal with |- Rabs (?a + ?b - ?a) < e => replace (a + b - a) with b by ring end.
    exact (Rle_lt_trans _ _ _ Q L).
Qed.
(* equal directions: phases apart by whole turns; a motion with each phase moved by whole turns is a motion *)
Lemma turned n adj w0 K0 r th (s : nat -> R) t : (forall k a, expi (th k a + s k) = expi (th k a)) ->
  particles n r th (u20 n adj w0 K0 (at_time r t) (at_time th t)) t ->
  particles n r (fun k a => th k a + s k) (u20 n adj w0 K0 (at_time r t) (fun k => th k t + s k)) t.
Proof.
  intros E M k Hk. destruct (M k Hk) as [A B]. split; [rewrite E; exact A|].
  replace (u20 n adj w0 K0 (at_time r t) (fun k => th k t + s k) k) with (u20 n adj w0 K0 (at_time r t) (at_time th t) k + 0).
  - apply D_plus; [exact B|apply D_const].
  - rewrite Rplus_0_r. unfold u20, Lc, ck. f_equal. f_equal. rewrite E. f_equal. apply Csum_ext. intros j _. now rewrite E.
Qed.
Lemma expi_whole a b : expi a = expi b -> exists z : Z, a - b = 2 * PI * IZR z.
Proof. intros E. apply expi_one. now apply expi_inj_minus. Qed.
Lemma thm2_2_proved : thm2_2.
Proof.
  intros n adj w0 K0 r th r' th' c0 c0' Hn _ _ _ _ _ M M' E T T'.
  set (s := fun k => if Nat.ltb k n then th k 0 - th' k 0 else 0).
  assert (W : forall k a, expi (th' k a + s k) = expi (th' k a)).
  { intros k a. unfold s. destruct (Nat.ltb_spec k n) as [Hk|_]; [|f_equal; ring]. destruct (E k Hk) as [_ E2].
    destruct (expi_whole _ _ E2) as [z ->]. rewrite expi_plus, expi_2PI. apply Cmult_1_r. }
  apply (paley_centre.centre_by_start n adj w0 K0 r r' th (fun k a => th' k a + s k) c0 c0' Hn).
  - intros k t Hk Ht. destruct (M t Ht k Hk) as [A B]. split; [exact A|]. unfold u20 in B. rewrite Rmult_assoc in B. exact B.
  - intros k t Hk Ht. destruct (turned n adj w0 K0 r' th' s t W (M' t Ht) k Hk) as [A B]. split; [exact A|]. unfold u20 in B. rewrite Rmult_assoc in B. exact B.
  - intros k Hk. destruct (E k Hk) as [E1 _]. split; [exact E1|]. unfold s. destruct (Nat.ltb_spec k n); [ring|lia].
  - exact T.
  - intros k Hk e He. destruct (T' k Hk e He) as [X H]. exists X. intros t Ht. specialize (H t Ht). unfold ck in H.
    unfold paley_particles.circle_centre. rewrite W. exact H.
Qed.
Lemma graph_3_proved : graph_3.
Proof.
  intros n adj m x Hn SC H j k Hj Hk.
  assert (R3 : forall y : nat -> R, (forall k, (k < n)%nat -> Nat.iter m (fun y k => Sum n (fun j => lap n adj k j * y j)) y k = 0) -> y j = y k).
  { intros y Hy. assert (P : forall z, (forall k, (k < n)%nat -> lpow n adj (S m) z k = 0) -> z j = z k).
    { intros z Hz. destruct (lap_zero_simple n adj m z Hn SC Hz) as [c Q]. now rewrite (Q j Hj), (Q k Hk). }
    assert (E : forall q i, lpow n adj q y i = Nat.iter q (fun y k => Sum n (fun j => lap n adj k j * y j)) y i).
    { induction q as [|q IH]; intros i; [reflexivity|]. cbn [lpow Nat.iter]. unfold lmul. apply Sum_ext. intros l _. now rewrite IH. }
    apply P. intros i Hi. cbn [lpow]. unfold lmul. apply Sum_zero. intros l Hl. rewrite E, (Hy l Hl). ring. }
  assert (It : forall A (F : A -> A) q y, Nat.iter (S q) F y = F (Nat.iter q F y)) by reflexivity.
  assert (F : forall q i, fst (Nat.iter q (apply_L n adj) x i) = Nat.iter q (fun y k => Sum n (fun j => lap n adj k j * y j)) (fun i => fst (x i)) i).
  { induction q as [|q IH]; intros i; [reflexivity|]. rewrite !It. unfold apply_L at 1, Csum. cbn [fst]. apply Sum_ext. intros l _.
    rewrite <- IH. cbn. ring. }
  assert (G : forall q i, snd (Nat.iter q (apply_L n adj) x i) = Nat.iter q (fun y k => Sum n (fun j => lap n adj k j * y j)) (fun i => snd (x i)) i).
  { induction q as [|q IH]; intros i; [reflexivity|]. rewrite !It. unfold apply_L at 1, Csum. cbn [snd]. apply Sum_ext. intros l _.
    rewrite <- IH. cbn. ring. }
  apply injective_projections.
  - apply (R3 (fun i => fst (x i))). intros i Hi. rewrite <- F, (H i Hi). reflexivity.
  - apply (R3 (fun i => snd (x i))). intros i Hi. rewrite <- G, (H i Hi). reflexivity.
Qed.
Lemma fourier_is n m k : (1 <= n)%nat -> fourier n m k = dft n k m.
Proof. intros Hn. pose proof (INR_pos n Hn). unfold fourier, dft, wave. f_equal. f_equal. field. lra. Qed.
Lemma graph_5_proved : graph_5.
Proof.
  intros n adj Hn Ci. assert (HC : circulant n adj (fun d => adj 0%nat d)).
  { intros k j Hk Hj. assert (L : ((j + n - k) mod n < n)%nat) by (apply Nat.mod_upper_bound; lia). apply Ci; try lia.
    rewrite Nat.sub_0_r. replace ((j + n - k) mod n + n)%nat with ((j + n - k) mod n + 1 * n)%nat by lia.
    rewrite Nat.mod_add by lia. now rewrite Nat.mod_mod by lia. }
  split.
  - intros m _. exists (circulant_eigenvalue n (fun d => adj 0%nat d) m). intros k Hk.
    pose proof (dft_diagonalizes n adj _ m Hn HC k Hk) as E. rewrite (fourier_is n m k Hn), <- E. unfold apply_L, row.
    apply Csum_ext. intros j _. now rewrite (fourier_is n m j Hn).
  - intros m m' Hm Hm'. rewrite (Csum_ext n _ (fun k => Cconj (dft n k m) * dft n k m')%C) by (intros; now rewrite !fourier_is).
    rewrite dft_unitary by assumption. unfold delta. now destruct (Nat.eqb m m').
Qed.
(* the chord between two phases *)
Lemma chord a b : Cmod (expi a - expi b)%C ^ 2 = 2 * (1 - cos (a - b)).
Proof.
  unfold Cmod. rewrite pow2_sqrt by (apply Rplus_le_le_0_compat; apply pow2_ge_0). unfold expi. cbn. rewrite cos_minus.
  pose proof (sin2_cos2 a) as A. pose proof (sin2_cos2 b) as B. unfold Rsqr in A, B. nra.
Qed.
(* chords below d at the start: the deficit of |p| decays *)
Lemma sync_decay n w0 K1 th d : (1 <= n)%nat -> K1 < 0 ->
  (forall t, 0 <= t -> forall k, (k < n)%nat ->
    is_derive (th k) t (w0 - K1 * inner (Ci * expi (th k t))%C (RtoC (/ INR n) * Csum n (fun j => expi (th j t)))%C)) ->
  0 < d <= / INR n -> apart n (at_time th 0) d ->
  exists q, 0 < q /\ forall t j k, 0 <= t -> (j < n)%nat -> (k < n)%nat -> Cmod (expi (th j t) - expi (th k t))%C ^ 2 <= (INR n * d) ^ 2 * exp (- q * t).
Proof.
  intros Hn HK M Hd A. pose proof (INR_pos n Hn) as P. pose proof (le_INR 1 n Hn) as N1. cbn in N1.
  assert (I1 : 0 < / INR n <= 1). { split; [now apply Rinv_0_lt_compat|]. rewrite <- Rinv_1. apply Rinv_le_contravar; lra. }
  assert (HT : forall t k, 0 <= t -> (k < n)%nat -> is_derive (th k) t (w0 + - K1 * g1 n (fun j => th j t) k)).
  { intros t k Ht Hk. specialize (M t Ht k Hk). eapply D_eq; [exact M|]. unfold g1, order, phasors. ring. }
  set (p := Cmod (order n (at_time th 0))). set (X := Sum n (fun k => Sum n (fun j => 1 - cos (th j 0 - th k 0)))).
  assert (PX : p ^ 2 = 1 - / (INR n * INR n) * X) by exact (order_deficit n (at_time th 0) Hn).
  assert (p0 : 0 <= p) by apply Cmod_ge_0.
  assert (XB : X <= INR n * (INR n * (d ^ 2 / 2))).
  { unfold X. rewrite <- Sum_const. apply Sum_le. intros k Hk. rewrite <- Sum_const. apply Sum_le. intros j Hj.
    pose proof (A j k Hj Hk) as L. cbv beta in L. pose proof (Cmod_ge_0 (expi (th j 0) - expi (th k 0))%C). pose proof (chord (th j 0) (th k 0)). nra. }
  assert (PB : 1 - d ^ 2 / 2 <= p ^ 2).
  { rewrite PX. apply (Rmult_le_compat_l (/ (INR n * INR n))) in XB; [|left; apply Rinv_0_lt_compat; nra].
    replace (/ (INR n * INR n) * (INR n * (INR n * (d ^ 2 / 2)))) with (d ^ 2 / 2) in XB by (field; lra). lra. }
  assert (Big : 1 - / INR n < p) by nra.
  destruct (Rlt_le_dec 0 p) as [pp|pp]; [|nra].
  exists (- K1 * p ^ 2). split; [apply Rmult_lt_0_compat; [lra|now apply pow_lt]|]. intros t j k Ht Hj Hk.
  destruct (paley_stability.thm1_synchronize n w0 K1 th Hn (Rlt_not_eq _ _ HK) HT HK Big t Ht) as [Dc Bd]. fold p in Dc.
  rewrite chord. specialize (Bd j k Hj Hk). set (E := exp (- (- K1 * p ^ 2) * t)) in *.
  assert (E0 : 0 < E) by apply exp_pos.
  assert (U0 : INR n / 2 - U1 n (at_time th 0) = INR n / 2 * (1 - p ^ 2)) by (unfold U1; fold p; field).
  rewrite U0 in Dc.
  assert (F1 : INR n / 2 * (1 - p ^ 2) <= INR n / 2 * (d ^ 2 / 2)) by (apply Rmult_le_compat_l; lra).
  assert (F2 : INR n / 2 - U1 n (fun j0 => th j0 t) <= INR n / 2 * (d ^ 2 / 2) * E).
  { apply Rle_trans with (1 := Dc). apply Rmult_le_compat_r; lra. }
  apply (Rmult_le_compat_l (2 * INR n)) in F2; [|lra].
  replace ((INR n * d) ^ 2 * E) with (2 * (2 * INR n * (INR n / 2 * (d ^ 2 / 2) * E))) by field. lra.
Qed.
Lemma sync_1_proved : sync_1.
Proof.
  intros n w0 K1 Hn HK moves. pose proof (INR_pos n Hn) as P. assert (I0 : 0 < / INR n) by now apply Rinv_0_lt_compat. split.
  - intros e He. exists (Rmin (/ INR n) (e / (2 * INR n))).
    assert (Q : 0 < e / (2 * INR n)) by (apply Rdiv_lt_0_compat; lra).
    assert (D0 : 0 < Rmin (/ INR n) (e / (2 * INR n))) by now apply Rmin_glb_lt. split; [exact D0|].
    pose proof (Rmin_l (/ INR n) (e / (2 * INR n))) as L1. pose proof (Rmin_r (/ INR n) (e / (2 * INR n))) as L2. set (d := Rmin _ _) in *.
    intros th M A t Ht j k Hj Hk. destruct (sync_decay n w0 K1 th d Hn HK M ltac:(lra) A) as [q [Hq H]]. specialize (H t j k Ht Hj Hk). clear M A.
    assert (Ex : exp (- q * t) <= 1). { rewrite <- exp_0. destruct (Req_dec t 0) as [->|]; [right; f_equal; ring|left; apply exp_increasing; nra]. }
    assert (ND : INR n * d <= e / 2). { apply (Rmult_le_compat_l (INR n)) in L2; [|lra]. replace (INR n * (e / (2 * INR n))) with (e / 2) in L2 by (field; lra). exact L2. }
    pose proof (exp_pos (- q * t)). assert (0 <= INR n * d) by nra. pose proof (Cmod_ge_0 (expi (th j t) - expi (th k t))%C).
    assert (Sq : (INR n * d) ^ 2 <= (e / 2) ^ 2) by (apply pow_incr; lra).
    assert (S1 : (INR n * d) ^ 2 * exp (- q * t) <= (INR n * d) ^ 2 * 1) by (apply Rmult_le_compat_l; [apply pow2_ge_0|exact Ex]).
    apply Rnot_le_lt. intros F. assert (e ^ 2 <= Cmod (expi (th j t) - expi (th k t))%C ^ 2) by (apply pow_incr; lra).
    replace ((e / 2) ^ 2) with (e ^ 2 / 4) in Sq by field. assert (0 < e ^ 2) by now apply pow_lt. lra.
  - exists (/ INR n). split; [exact I0|]. intros th M A e He. destruct (sync_decay n w0 K1 th (/ INR n) Hn HK M ltac:(lra) A) as [q [Hq H]].
    exists (Rmax 0 (/ (q * e ^ 2))). intros t Ht j k Hj Hk. pose proof (Rmax_l 0 (/ (q * e ^ 2))). pose proof (Rmax_r 0 (/ (q * e ^ 2))).
    specialize (H t j k ltac:(lra) Hj Hk). replace (INR n * / INR n) with 1 in H by (field; lra). rewrite pow1, Rmult_1_l in H.
    assert (e2 : 0 < e ^ 2) by now apply pow_lt. assert (qe : 0 < q * e ^ 2) by nra.
    assert (t0 : 0 < t) by (pose proof (Rinv_0_lt_compat _ qe); lra).
    assert (X : exp (- q * t) < e ^ 2).
    { replace (- q * t) with (- (q * t)) by ring. rewrite exp_Ropp. pose proof (exp_ineq1 (q * t) ltac:(nra)) as B.
      assert (L : 1 <= q * e ^ 2 * t). { assert (Ht' : / (q * e ^ 2) <= t) by lra. apply (Rmult_le_compat_l (q * e ^ 2)) in Ht'; [|lra]. rewrite Rinv_r in Ht' by lra. exact Ht'. }
      apply Rmult_lt_reg_r with (exp (q * t)); [apply exp_pos|]. rewrite Rinv_l by (apply Rgt_not_eq, exp_pos). nra. }
    pose proof (Cmod_ge_0 (expi (th j t) - expi (th k t))%C). nra.
Qed.
