(* Clauses that were proved last, formalised from their words with own definitions: chazelle.lower_bound (corrected), chazelle.lower_paths,
   veerman.thm1_eps (corrected), tanner2.eq6 clause 2, tanner2.Qjump. *)
From Coq Require Import Reals Lra Lia Psatz Relations.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums paley_model tanner_energy.
From Flockproof Require chazelle_lower veerman_complex veerman_front veerman_root tanner_flock tanner_nonsmooth tanner2_facts tanner2_filippov tanner2_energies audit_independent_tanner2.
Module T2 := audit_independent_tanner2.
Open Scope R_scope.

(* ---- model D on the line: who is linked, the mean over those who are, the rule of the network with the threshold h ---- *)
Definition number n (G : nat -> nat -> bool) i := Sum n (fun j => if G i j then 1 else 0).
Record flight (n : nat) (h : R) (x v : nat -> nat -> R) (G : nat -> nat -> nat -> bool) : Prop := {
  first : forall i j, (i < n)%nat -> (j < n)%nat -> (G 0%nat i j = true <-> i <> j /\ Rabs (x 0%nat i - x 0%nat j) <= 1);
  rule : forall t i j, (i < n)%nat -> (j < n)%nat -> (G (S t) i j = true <-> i <> j /\ (Rabs (x (S t) i - x (S t) j) <= 1 \/
    G t i j = true /\ Rabs (Rabs (x (S t) i - x (S t) j) - Rabs (x t i - x t j)) < h));
  moved : forall t i, (i < n)%nat -> x (S t) i - x t i = v (S t) i;
  alone : forall t i, (1 <= t)%nat -> (i < n)%nat -> number n (G t) i = 0 -> v (S t) i = v t i;
  weighed : forall t i, (1 <= t)%nat -> (i < n)%nat -> number n (G t) i <> 0 ->
    v (S t) i = / 3 * v t i + Sum n (fun j => if G t i j then 2 / 3 / number n (G t) i * v t j else 0) }.
Definition from_start n (c : R) (x v : nat -> nat -> R) := (forall l, (2 * l + 1 < n)%nat -> x 0%nat (2 * l)%nat = 2 * INR l /\ x 0%nat (2 * l + 1)%nat = 2 * INR l + 2 / 3) /\
  forall g, (4 * g + 3 < n)%nat -> v 1%nat (4 * g)%nat = Rpower (INR n) (- c) /\ v 1%nat (4 * g + 1)%nat = 0 /\ v 1%nat (4 * g + 2)%nat = - Rpower (INR n) (- c) /\ v 1%nat (4 * g + 3)%nat = 0.
(* the integer next above n^c / 3 *)
Definition ceiling (a : R) (T : nat) := a <= INR T < a + 1.
Definition lower_bound : Prop := forall n c h x v G T, (0 < n)%nat -> (exists m, n = (4 * m)%nat) -> 8 <= Rpower (INR n) c -> flight n h x v G -> from_start n c x v -> ceiling (Rpower (INR n) c / 3) T ->
  (exists t, T = S t /\ exists i j, (i < n)%nat /\ (j < n)%nat /\ G T i j <> G t i j) /\
  forall t, S t <> T -> forall i j, (i < n)%nat -> (j < n)%nat -> G (S t) i j = G t i j.
(* a flock is a single path: the birds that can be reached from one are the numbers from a to b, and who is next to whom in this row is linked, no others *)
Definition lower_paths : Prop := forall n c h x v G, (0 < n)%nat -> (exists m, n = (4 * m)%nat) -> 8 <= Rpower (INR n) c -> flight n h x v G -> from_start n c x v ->
  forall t i, (i < n)%nat -> exists a b, (a <= i <= b)%nat /\ (b < n)%nat /\
    (forall j, (j < n)%nat -> (clos_refl_trans nat (fun k l => (l < n)%nat /\ G t k l = true) i j <-> (a <= j <= b)%nat)) /\
    forall j k, (a <= j <= b)%nat -> (a <= k <= b)%nat -> (G t j k = true <-> S j = k \/ S k = j).
(* ---- the root of gamma^2 - 1 for f, g < 0: E is the principal one ---- *)
Definition principal (z E : C) := (E * E)%C = z /\ (0 < Re E \/ Re E = 0 /\ 0 <= Im E).
Definition thm1_eps : Prop := forall f g : R, f < 0 -> g < 0 -> exists K w0, 0 < w0 /\ forall (w : R) (gam E : C), 0 < w < w0 ->
  (gam * (RtoC f + Ci * RtoC w * RtoC g) = RtoC f + Ci * RtoC w * RtoC g + RtoC (w ^ 2))%C -> principal (gam * gam - 1)%C E ->
  Cmod (E - Ci * RtoC (sqrt 2) * RtoC (w / sqrt (Rabs f)) *
    (1 - Ci * RtoC w * RtoC (Rabs g / (2 * Rabs f)) + RtoC (w ^ 2 / 2 * (- (3 / 4) * g ^ 2 / f ^ 2 - 1 / (2 * Rabs f)))))%C <= K * w ^ 4.
(* ---- the energy (6) is differentiable, with the force of (4) as minus its gradient ---- *)
Definition differentiable n (E : (nat -> C) -> (nat -> C) -> R) (r v a b : nat -> C) := forall e, 0 < e -> exists d, 0 < d /\ forall q u : nat -> C,
  (forall i, (i < n)%nat -> Cmod (q i - r i)%C < d /\ Cmod (u i - v i)%C < d) ->
  Rabs (E q u - E r v - Sum n (fun i => fst (a i) * fst (q i - r i)%C + snd (a i) * snd (q i - r i)%C + (fst (b i) * fst (u i - v i)%C + snd (b i) * snd (u i - v i)%C))) <=
    e * Sum n (fun i => Cmod (q i - r i)%C + Cmod (u i - v i)%C).
Definition eq6_2 : Prop := forall n adj V V' r v, T2.simple_graph adj -> T2.potentials n adj V V' -> T2.apart_at n adj r ->
  (forall i, T2.law4 n adj V' r v i = (- Csum n (fun j => if adj i j then v i - v j else 0) + - T2.gradV n adj V' r i)%C) /\
  differentiable n (T2.energy6 n adj V) r v (T2.gradV n adj V' r) v.
(* ---- Q of (11): every pair has the energy V_ij at the smaller one of its distance and R ---- *)
Definition Q11 n (V : nat -> nat -> R -> R) R0 (r v : nat -> C) := / 2 * Sum n (fun i => Sum n (fun j => if Nat.eqb i j then 0 else V i j (Rmin (Cmod (r i - r j)%C) R0)) + Cmod (v i) ^ 2).
Definition Qjump_1 : Prop := forall n V V' R0 r v, 0 < R0 -> T2.potentials n complete V V' -> T2.apart_at n complete r -> forall e, 0 < e -> exists d, 0 < d /\
  forall q u : nat -> C, (forall i, (i < n)%nat -> Cmod (q i - r i)%C < d /\ Cmod (u i - v i)%C < d) -> Rabs (Q11 n V R0 q u - Q11 n V R0 r v) < e.
Definition Qjump_2 : Prop := forall n V V' R0 r v i j, 0 < R0 -> T2.potentials n complete V V' -> T2.apart_at n complete r ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> i <> j -> 0 < V' i j R0) ->
  (i < n)%nat -> (j < n)%nat -> i <> j -> Cmod (r i - r j)%C = R0 -> forall a b, ~ differentiable n (Q11 n V R0) r v a b.

(* ---- the theorems prove them ---- *)
Lemma flight_is n h x v G : flight n h x v G -> chazelle_lower.flock_line n h x v G.
Proof.
  intros [A B C D E]. split; [exact A|]. split; [exact B|]. split; [intros t i Hi; rewrite <- (C t i Hi); ring|]. split; [exact D|]. intros t i Ht Hi N.
  rewrite (E t i Ht Hi N). unfold number, chazelle_lower.joined, chazelle_lower.heard in *. set (k := Sum n (fun j => if G t i j then 1 else 0)) in *.
  rewrite (Sum_ext n _ (fun j => 2 / (3 * k) * (if G t i j then v t j else 0))); [rewrite Sum_scal; field; exact N|]. intros j _. destruct (G t i j); [field; exact N|ring].
Qed.
Lemma start_is m c x v : from_start (4 * m) c x v -> (forall i, (i < 4 * m)%nat -> x 0%nat i = chazelle_lower.place0 i) /\ forall i, (i < 4 * m)%nat -> v 1%nat i = chazelle_lower.speed0 (Rpower (INR (4 * m)) (- c)) i.
Proof.
  intros [A B]. split; intros i Hi.
  - unfold chazelle_lower.place0. pose proof (Nat.div_mod i 2 ltac:(lia)) as D. pose proof (Nat.mod_upper_bound i 2 ltac:(lia)) as U. destruct (A (i / 2)%nat ltac:(lia)) as [A1 A2]. rewrite mult_INR. cbn [INR].
    assert (E : i = (2 * (i / 2))%nat \/ i = (2 * (i / 2) + 1)%nat) by lia. destruct E as [E|E].
    + assert (Ev : Nat.even i = true) by (rewrite E, Nat.even_mul; reflexivity). rewrite Ev. rewrite E at 1. rewrite A1. ring.
    + assert (Ev : Nat.even i = false) by (rewrite E, Nat.even_add, Nat.even_mul; reflexivity). rewrite Ev. rewrite E at 1. rewrite A2. ring.
  - destruct (chazelle_lower.group_of i m Hi) as (g & k & Hg & Hk & ->). destruct (B g ltac:(lia)) as (B0 & B1 & B2 & B3). unfold chazelle_lower.speed0.
    replace ((4 * g + k) / 2)%nat with (2 * g + k / 2)%nat by (replace (4 * g + k)%nat with ((2 * g) * 2 + k)%nat by lia; now rewrite Nat.div_add_l by lia).
    replace (4 * g + k)%nat with (2 * (2 * g) + k)%nat by lia. rewrite !Nat.even_add, !Nat.even_mul. cbn [Nat.even orb]. replace (2 * (2 * g) + k)%nat with (4 * g + k)%nat by lia.
    destruct k as [|[|[|[|k]]]]; [rewrite Nat.add_0_r; exact B0|exact B1|exact B2|exact B3|lia].
Qed.
Lemma lower_bound_proved : lower_bound.
Proof.
  intros n c h x v G T Hn [m ->] H8 F St HT. destruct (start_is m c x v St) as [X0 V1].
  destruct (chazelle_lower.lower_bound m c h x v G T ltac:(lia) H8 (flight_is _ _ _ _ _ F) X0 V1 HT) as (_ & _ & Tp & (i & j & Hi & Hj & N) & A).
  split; [|exact A]. exists (T - 1)%nat. split; [lia|]. exists i, j. now repeat split.
Qed.
Lemma lower_paths_proved : lower_paths.
Proof.
  intros n c h x v G Hn [m ->] H8 F St t i Hi. destruct (start_is m c x v St) as [X0 V1].
  destruct (chazelle_lower.lower_paths m c h x v G ltac:(lia) H8 (flight_is _ _ _ _ _ F) X0 V1 t) as (w & Hw & L).
  assert (W : exists q, (4 * m = q * w)%nat) by (destruct Hw as [->| ->]; [exists (2 * m)%nat|exists m]; lia). destruct W as [q Hq]. assert (W0 : (w <> 0)%nat) by lia.
  pose proof (Nat.div_mod i w W0) as D. pose proof (Nat.mod_upper_bound i w W0) as U. set (g := (i / w)%nat) in *. assert (Hg : (g < q)%nat) by (apply Nat.div_lt_upper_bound; lia).
  assert (Blk : forall j, (w * g <= j < w * g + w)%nat <-> (j / w)%nat = g).
  { intros j. split; intros H.
    - symmetry. apply (Nat.div_unique j w g (j - w * g)%nat); lia.
    - pose proof (Nat.div_mod j w W0). pose proof (Nat.mod_upper_bound j w W0). rewrite H in *. lia. }
  assert (In : forall j, (w * g <= j < w * g + w)%nat -> (j < 4 * m)%nat) by (intros j Hj; nia).
  exists (w * g)%nat, (w * g + w - 1)%nat. split; [lia|]. split; [apply In; lia|]. split.
  - intros j Hj. split; intros H.
    + assert (K : forall k l, clos_refl_trans nat (fun k l => (l < 4 * m)%nat /\ G t k l = true) k l -> (k < 4 * m)%nat -> (k / w)%nat = (l / w)%nat /\ (l < 4 * m)%nat).
      { intros k l Q. induction Q as [k l [Hl Q]|k|k l p Q1 I1 Q2 I2]; intros Hk; [split; [|exact Hl]; now apply (proj1 (L k l Hk Hl))|now split|].
        destruct (I1 Hk) as [E1 L1]. destruct (I2 L1) as [E2 L2]. split; [congruence|exact L2]. }
      destruct (K i j H Hi) as [E _]. assert (w * g <= j < w * g + w)%nat by (apply Blk; unfold g; congruence). lia.
    + assert (Stp : forall k, (w * g <= k)%nat -> (S k < w * g + w)%nat -> G t k (S k) = true /\ G t (S k) k = true).
      { intros k H1 H2. assert (E1 : (k / w)%nat = g) by (apply Blk; lia). assert (E2 : (S k / w)%nat = g) by (apply Blk; lia).
        split; apply L; try (apply In; lia); (split; [congruence|lia]). }
      assert (Upw : forall d k, (w * g <= k)%nat -> (k + d < w * g + w)%nat -> clos_refl_trans nat (fun k l => (l < 4 * m)%nat /\ G t k l = true) k (k + d)%nat).
      { induction d as [|d IH]; intros k H1 H2; [rewrite Nat.add_0_r; apply rt_refl|]. apply rt_trans with (k + d)%nat; [apply IH; lia|]. apply rt_step. rewrite Nat.add_succ_r. split; [apply In; lia|apply Stp; lia]. }
      assert (Dnw : forall d k, (w * g <= k)%nat -> (k + d < w * g + w)%nat -> clos_refl_trans nat (fun k l => (l < 4 * m)%nat /\ G t k l = true) (k + d)%nat k).
      { induction d as [|d IH]; intros k H1 H2; [rewrite Nat.add_0_r; apply rt_refl|]. apply rt_trans with (k + d)%nat; [|apply IH; lia]. apply rt_step. rewrite Nat.add_succ_r. split; [apply In; lia|apply Stp; lia]. }
      destruct (Nat.le_gt_cases i j) as [Q|Q]; [replace j with (i + (j - i))%nat by lia; apply Upw; lia|replace i with (j + (i - j))%nat by lia; apply Dnw; lia].
  - intros j k Hj Hk. rewrite (L j k) by (apply In; lia). assert (E1 : (j / w)%nat = g) by (apply Blk; lia). assert (E2 : (k / w)%nat = g) by (apply Blk; lia). rewrite E1, E2. tauto.
Qed.
Lemma root_unique (z E E' : C) : principal z E -> principal z E' -> E = E'.
Proof.
  intros [A P] [A' P']. assert (H : ((E - E') * (E + E') = 0)%C) by (replace ((E - E') * (E + E'))%C with (E * E - E' * E')%C by ring; rewrite A, A'; ring).
  assert (Z : (E - E')%C = 0%C \/ (E + E')%C = 0%C).
  { apply (f_equal Cmod) in H. rewrite Cmod_mult, Cmod_0 in H. apply Rmult_integral in H. destruct H as [H|H]; apply Cmod_eq_0 in H; [now left|now right]. }
  destruct Z as [Z|Z]; [replace E with ((E - E') + E')%C by ring; rewrite Z; ring|].
  pose proof (f_equal fst Z) as Z1. pose proof (f_equal snd Z) as Z2. unfold Re, Im in *. cbn in Z1, Z2. apply injective_projections; destruct P as [P|[P Q]], P' as [P'|[P' Q']]; lra.
Qed.
Lemma thm1_eps_proved : thm1_eps.
Proof.
  intros f g Hf Hg. destruct (veerman_root.thm1_eps f g Hf Hg) as (K & w0 & _ & Hw0 & B). exists K, w0. split; [exact Hw0|]. intros w gam E Hw Hgam HE.
  assert (Dn : veerman_front.den f g w <> RtoC 0) by (intros Z; apply (f_equal fst) in Z; cbn in Z; lra).
  assert (Eg : gam = veerman_front.gamma f g w).
  { unfold veerman_front.gamma. apply (veerman_complex.Cmult_cancel_r _ _ _ Dn). transitivity (veerman_front.num f g w); [|now field].
    replace (veerman_front.den f g w) with (RtoC f + Ci * RtoC w * RtoC g)%C by (apply injective_projections; cbn; ring). rewrite Hgam. apply injective_projections; cbn; ring. }
  subst gam. assert (Es : E = veerman_complex.Csqrt (veerman_front.gamma f g w * veerman_front.gamma f g w - 1)%C).
  { apply (root_unique (veerman_front.gamma f g w * veerman_front.gamma f g w - 1)%C); [exact HE|]. split; [apply veerman_complex.Csqrt_sqr|apply veerman_complex.Csqrt_angle]. }
  rewrite Es. specialize (B w Hw). unfold veerman_root.eps_series in B. revert B. assert (Hs : sqrt (Rabs f) <> 0) by (apply Rgt_not_eq, sqrt_lt_R0; rewrite Rabs_left; lra).
  replace (Ci * RtoC w * RtoC (Rabs g / (2 * Rabs f)))%C with (Ci * RtoC (w * Rabs g / (2 * Rabs f)))%C.
  - replace (- (3 / 4) * g ^ 2 / f ^ 2) with (- (3 / 4) * (g ^ 2 / f ^ 2)) by (field; lra). intros B. exact B.
  - apply injective_projections; cbn; field; apply Rabs_no_R0; lra.
Qed.
Lemma differentiable_is n E r v a b : (forall q q' u u', (forall i, (i < n)%nat -> q i = q' i /\ u i = u' i) -> E q u = E q' u') ->
  (tanner2_energies.total_derivative n E r v a b <-> differentiable n E r v a b).
Proof.
  intros Ex. split; intros H e He; destruct (H e He) as (d & Hd & K); exists d; (split; [exact Hd|]).
  - intros q u B. specialize (K (fun i => q i - r i)%C (fun i => u i - v i)%C B). cbv beta in K. rewrite (Ex (fun i => r i + (q i - r i))%C q (fun i => v i + (u i - v i))%C u) in K by (intros; split; ring).
    rewrite (Sum_ext n (fun i => inner (a i) (q i - r i)%C + inner (b i) (u i - v i)%C) (fun i => fst (a i) * fst (q i - r i)%C + snd (a i) * snd (q i - r i)%C + (fst (b i) * fst (u i - v i)%C + snd (b i) * snd (u i - v i)%C))) in K by (intros; now rewrite !inner_xy).
    exact K.
  - intros p u B. specialize (K (fun i => r i + p i)%C (fun i => v i + u i)%C). cbv beta in K.
    assert (Z : forall i, (r i + p i - r i)%C = p i /\ (v i + u i - v i)%C = u i) by (intros; split; ring).
    rewrite (Sum_ext n _ (fun i => inner (a i) (p i) + inner (b i) (u i))) in K by (intros; destruct (Z i) as [-> ->]; now rewrite !inner_xy).
    rewrite (Sum_ext n (fun i => Cmod _ + Cmod _) (fun i => norm (p i) + norm (u i))) in K by (intros; destruct (Z i) as [-> ->]; reflexivity). apply K. intros i Hi. destruct (Z i) as [-> ->]. now apply B.
Qed.
Lemma eq6_2_proved : eq6_2.
Proof.
  intros n adj V V' r v [S NL] P A. split; [intros i; unfold T2.law4; ring|]. apply differentiable_is.
  - intros q q' u u' E. unfold T2.energy6. f_equal. apply Sum_ext. intros i Hi. destruct (E i Hi) as [E1 ->]. f_equal. apply Sum_ext. intros j Hj. destruct (E j Hj) as [E2 _]. now rewrite E1, E2.
  - intros e He. destruct (tanner2_energies.energy_differentiable n adj (tanner2_filippov.both V) (tanner2_filippov.both V') r v S (tanner2_filippov.both_sym V')) with (e := e) as (d & Hd & K).
    + intros i j s Hi Hj Ad Hs. destruct (T2.one_of n adj V V' S P) as (_ & _ & Q). now apply (Q i j Hi Hj Ad).
    + exact A.
    + exact He.
    + exists d. split; [exact Hd|]. intros p u B. specialize (K p u B). rewrite <- !T2.energy6_is, !(T2.energy_both n adj V _ _ (proj1 P)) in K.
      rewrite (Sum_ext n (fun i => inner (T2.gradV n adj V' r i) (p i) + inner (v i) (u i)) (fun i => inner (grad_i n adj (tanner2_filippov.both V') r i) (p i) + inner (v i) (u i))); [exact K|].
      intros i Hi. rewrite <- T2.gradV_is. destruct (T2.both_law n adj V V' r v i S (proj1 P) (T2.slopes_of n adj V V' P) Hi A) as (_ & -> & _). reflexivity.
Qed.
Lemma Q11_is n V R0 r v : (forall i j s, V i j s = V j i s) -> Q11 n V R0 r v = tanner2_facts.Qsat n (tanner2_filippov.both V) R0 r v.
Proof.
  intros VS. unfold Q11, tanner2_facts.Qsat. f_equal. apply Sum_ext. intros i _. f_equal; [|rewrite <- norm_sqr; unfold norm; ring]. apply Sum_ext. intros j _. unfold tanner2_facts.sat_pair.
  destruct (Nat.eqb i j); [reflexivity|]. rewrite tanner_nonsmooth.saturated_min, T2.both_V by exact VS. reflexivity.
Qed.
Lemma pair_derivative n V V' : T2.potentials n complete V V' -> forall i j s, (i < n)%nat -> (j < n)%nat -> i <> j -> 0 < s -> is_derive (tanner2_filippov.both V i j) s (tanner2_filippov.both V' i j s).
Proof.
  intros P i j s Hi Hj Ne Hs. destruct (T2.one_of n complete V V') as (_ & _ & Q); [|exact P|].
  - intros a b. unfold complete. now rewrite Nat.eqb_sym.
  - apply (Q i j Hi Hj); [|exact Hs]. unfold complete. destruct (Nat.eqb_spec i j); [contradiction|reflexivity].
Qed.
Lemma Qjump_1_proved : Qjump_1.
Proof.
  intros n V V' R0 r v HR P A e He. destruct (tanner2_energies.Q_continuous n (tanner2_filippov.both V) (tanner2_filippov.both V') R0 HR (pair_derivative n V V' P) r v A e He) as (d & Hd & K).
  exists d. split; [exact Hd|]. intros q u B. rewrite !Q11_is by apply P. now apply K.
Qed.
Lemma Qjump_2_proved : Qjump_2.
Proof.
  intros n V V' R0 r v i j HR P A Up Hi Hj Ne E a b D.
  apply (tanner2_energies.Q_nonsmooth n (tanner2_filippov.both V) (tanner2_filippov.both V') R0 r v HR (tanner2_filippov.both_sym V) (pair_derivative n V V' P)) with (i0 := i) (j0 := j); try assumption.
  - intros k l Hk Hl Nkl. unfold tanner2_filippov.both. destruct (Nat.leb k l); apply Up; congruence.
  - exists a, b. apply differentiable_is.
    + intros q q' u u' Eq. unfold tanner2_facts.Qsat. f_equal. apply Sum_ext. intros k Hk. destruct (Eq k Hk) as [E1 ->]. f_equal. apply Sum_ext. intros l Hl. destruct (Eq l Hl) as [E2 _]. unfold tanner2_facts.sat_pair. now rewrite E1, E2.
    + intros e He. destruct (D e He) as (d & Hd & K). exists d. split; [exact Hd|]. intros q u B. rewrite <- !(Q11_is n V R0) by apply P. now apply K.
Qed.
