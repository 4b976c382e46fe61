(* More clauses of the claims about Paley's paper (graphs, phase potentials, patterns), formalised from their words before the
   theorems were looked at; the theorems prove them. Nodes, particles and columns are numbered from 0. *)
From Coq Require Import Reals Lra Lia List Relations Psatz.
From Coq Require FinFun.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums paley_model paley_phase paley_laplacian paley_gradient paley_fourier paley_particles paley_patterns.
From Flockproof Require Import audit_independent_paley.
From Flockproof Require paley_fish paley_centre paley_convergence paley_composite paley_stability.
Open Scope R_scope.

(* the complete graph, the cyclic graph, connected graphs *)
Definition KN : graph := fun k j => negb (Nat.eqb k j).
Definition CN (n : nat) : graph := fun k j => orb (Nat.eqb j (S k mod n)) (Nat.eqb k (S j mod n)).
Definition connected (n : nat) (adj : graph) := undirected adj /\ strongly_connected n adj.
(* moments (23), potentials (24), Laplacian potentials W_m *)
Definition pm (n m : nat) (th : nat -> R) : C := (RtoC (/ (INR m * INR n)) * Csum n (fun k => expi (INR m * th k)))%C.
Definition U_m (n m : nat) (th : nat -> R) : R := INR n / 2 * Cmod (pm n m th) ^ 2.
Definition W_m (n : nat) (adj : graph) (m : nat) (th : nat -> R) : R := S_of n adj (fun k => RtoC (/ INR m) * expi (INR m * th k))%C.
Definition minimal (f : (nat -> R) -> R) (th : nat -> R) := forall th', f th <= f th'.
Definition maximal (f : (nat -> R) -> R) (th : nat -> R) := forall th', f th' <= f th.
Definition phasor (th : nat -> R) (k : nat) : C := expi (th k).

(* paley.CN clause 1 *)
Definition CN_1 : Prop := forall n k j, (k < n)%nat -> (j < n)%nat ->
  deg n KN k = INR n - 1 /\ lap n KN 0 j = if Nat.eqb j 0 then INR n - 1 else -1.
(* paley.CN clause 2 *)
Definition CN_2 : Prop := forall n, (3 <= n)%nat -> connected n (CN n).
(* paley.CN clause 3; no node is its own neighbour *)
Definition CN_3 : Prop := forall n k, (3 <= n)%nat -> (k < n)%nat -> CN n k k = false /\ deg n (CN n) k = 2.
(* paley.CN clause 4 *)
Definition CN_4 : Prop := forall n j, (3 <= n)%nat -> (j < n)%nat ->
  lap n (CN n) 0 j = if Nat.eqb j 0 then 2 else if Nat.eqb j 1 then -1 else if Nat.eqb j (n - 1) then -1 else 0.

(* paley.Um clause 1: where p_m = 0, there the minimum is, and p_m = 0 happens *)
Definition Um_1 : Prop := forall n m, (2 <= n)%nat -> (1 <= m)%nat ->
  (forall th, pm n m th = 0%C <-> minimal (U_m n m) th) /\ exists th, pm n m th = 0%C.
(* paley.Um clause 2 *)
Definition Um_2 : Prop := forall n m th, (2 <= n)%nat -> (1 <= m)%nat ->
  (maximal (U_m n m) th <-> forall j k, (j < n)%nat -> (k < n)%nat -> exists z : Z, th j - th k = IZR z * (2 * PI / INR m)).

(* paley.VMN clause 1 as printed: V = K_0 S + U^{M,N} never increases under the control of Theorem 3. It can increase. *)
Definition VMN_printed : Prop := forall n adj w0 K0 M K r th t (g : nat -> R) d, (1 <= n)%nat -> connected n adj -> no_loops adj ->
  w0 <> 0 -> 0 < K0 -> (1 <= M)%nat -> Nat.divide M n -> (forall m, (1 <= m < M)%nat -> 0 < K m) -> K M < 0 ->
  (forall k, (k < n)%nat -> partial (UMN n M K) (at_time th t) k (g k)) ->
  particles n r th (fun k => w0 + w0 * (K0 / INR n) * Lc n adj w0 (at_time r t) (at_time th t) k - g k) t ->
  is_derive (fun s => K0 * S17 n adj w0 (at_time r s) (at_time th s) + UMN n M K (at_time th s)) t d -> d <= 0.
Definition VMN_1 : Prop := ~ VMN_printed.

(* paley.Wm clause 1 as printed, refuted; it fails at every arrangement for every m >= 2 *)
Definition Wm_printed : Prop := forall n m th, (1 <= n)%nat -> (1 <= m)%nat -> W_m n KN m th = INR n / 2 - U_m n m th.
Definition Wm_1 : Prop := ~ Wm_printed /\ forall n m th, (1 <= n)%nat -> (2 <= m)%nat -> W_m n KN m th <> INR n / 2 - U_m n m th.

(* paley.eig.sym clause 1 as printed, refuted even for connected undirected graphs *)
Definition circulant_laplacian (n : nat) (adj : graph) := forall k j k' j', (k < n)%nat -> (j < n)%nat -> (k' < n)%nat -> (j' < n)%nat ->
  ((j + n - k) mod n = (j' + n - k') mod n)%nat -> lap n adj k j = lap n adj k' j'.
Definition symmetric_pattern (n : nat) (th : nat -> R) := exists M, Nat.divide M n /\ pattern M n th.
Definition eig_sym_printed : Prop := forall n adj th lam, (1 <= n)%nat -> connected n adj -> no_loops adj -> circulant_laplacian n adj ->
  eigenpair n adj lam (phasor th) -> ~ synchronized n th -> symmetric_pattern n th.
Definition eig_sym_1 : Prop := ~ eig_sym_printed.

(* paley.eq11.kernel clauses 1, 2 *)
Definition in_span_1 (n : nat) (x : nat -> C) := exists c : C, forall k, (k < n)%nat -> x k = c.
Definition kernel_1 : Prop := forall n adj x, (1 <= n)%nat -> connected n adj -> (S_of n adj x = 0 <-> in_span_1 n x).
Definition kernel_2 : Prop := forall n adj x, (1 <= n)%nat -> connected n adj -> ~ in_span_1 n x -> 0 < S_of n adj x.

(* paley.eq13 clauses 1, 2 *)
Definition eq13_1 : Prop := forall n th, (1 <= n)%nat -> S_of n KN (phasor th) = INR n / 2 - U1 n th.
Definition eq13_2 : Prop := forall n th, (1 <= n)%nat ->
  (stationary n (fun th => S_of n KN (phasor th)) th <-> stationary n (U1 n) th).

(* paley.eq16.eigvec clause 1 *)
Definition eigvec_1 : Prop := forall n adj th lam, (1 <= n)%nat -> undirected adj -> eigenpair n adj lam (phasor th) ->
  stationary n (W1 n adj) th.
(* paley.eq16.eigvec clause 2: under (6), (14) all phases turn at the rate w0 and keep their differences *)
Definition eigvec_2 : Prop := forall n adj th lam w0 K1, (1 <= n)%nat -> undirected adj -> eigenpair n adj lam (phasor th) ->
  (forall k, (k < n)%nat -> w0 + K1 / INR n * Lth n adj th k = w0) /\
  forall t k, (k < n)%nat -> is_derive (fun s => th k + w0 * s) t (w0 + K1 / INR n * Lth n adj (fun j => th j + w0 * t) k).

(* paley.eq21 clause 1 as printed, refuted; V of (21) can increase too *)
Definition V21 n adj w0 K0 K1 (r : nat -> C) (th : nat -> R) := K0 * S17 n adj w0 r th + K1 * / w0 * W1 n adj th.
Definition case21 n adj w0 K0 K1 r th t := (1 <= n)%nat /\ connected n adj /\ no_loops adj /\ 0 < K0 /\ K1 <> 0 /\ w0 <> 0 /\
  particles n r th (u22 n adj w0 K0 K1 (at_time r t) (at_time th t)) t.
Definition eq21_printed : Prop := forall n adj w0 K0 K1 r th t, case21 n adj w0 K0 K1 r th t ->
  let rate := - / INR n ^ 2 * Sum n (fun k => (K0 * Lc n adj w0 (at_time r t) (at_time th t) k + K1 * / w0 * Lth n adj (at_time th t) k) ^ 2) in
  is_derive (fun s => V21 n adj w0 K0 K1 (at_time r s) (at_time th s)) t rate /\ rate <= 0.
Definition eq21_falls : Prop := forall n adj w0 K0 K1 r th t d, case21 n adj w0 K0 K1 r th t ->
  is_derive (fun s => V21 n adj w0 K0 K1 (at_time r s) (at_time th s)) t d -> d <= 0.
Definition eq21_1 : Prop := ~ eq21_printed /\ ~ eq21_falls.

(* paley.eq3 clause 1 *)
Definition eq3_1 : Prop := forall n r th, (forall t, 0 <= t -> particles n r th (fun _ => 0) t) ->
  forall t k, 0 <= t -> (k < n)%nat -> th k t = th k 0 /\ r k t = (r k 0 + RtoC t * expi (th k 0))%C.
(* paley.eq3 clause 2: the centre stands still, the particle is at its distance 1/|w0| and turns at the rate w0, so all the way round *)
Definition eq3_2 : Prop := forall n r th w0, w0 <> 0 -> (forall t, 0 <= t -> particles n r th (fun _ => w0) t) ->
  forall k, (k < n)%nat -> let c t := ck w0 (at_time r t) (at_time th t) k in
    (forall t, 0 <= t -> c t = c 0 /\ Cmod (r k t - c 0)%C = / Rabs w0) /\
    exists phi, forall t, 0 <= t -> r k t = (c 0 + RtoC (/ Rabs w0) * expi (phi + w0 * t))%C.
(* paley.eq3 clause 3: the velocity is to the left or to the right of the radius *)
Definition eq3_3 : Prop := forall n r th w0, w0 <> 0 -> (forall t, 0 <= t -> particles n r th (fun _ => w0) t) ->
  forall k t, (k < n)%nat -> 0 <= t -> let radius := (r k t - ck w0 (at_time r t) (at_time th t) k)%C in
    (0 < w0 -> 0 < inner (Ci * radius)%C (expi (th k t))) /\ (w0 < 0 -> inner (Ci * radius)%C (expi (th k t)) < 0).

(* paley.eq8.ext clauses 1, 2, 3 *)
Definition ext_1 : Prop := forall n th a, (1 <= n)%nat -> U1 n (fun k => th k + a) = U1 n th.
Definition ext_2 : Prop := forall n th, (1 <= n)%nat -> (maximal (U1 n) th <-> synchronized n th).
Definition ext_3 : Prop := forall n, (2 <= n)%nat -> (forall th, minimal (U1 n) th <-> balanced n th) /\ exists th, balanced n th.

(* paley.eq8_10 clause 3 *)
Definition eq10 : Prop := forall n w0 K1 (th : nat -> R -> R) t, (1 <= n)%nat ->
  let u9 k := - K1 * inner (Ci * expi (th k t))%C (order n (at_time th t)) in
  (forall k, (k < n)%nat -> is_derive (th k) t (w0 + u9 k)) <->
  (forall k, (k < n)%nat -> is_derive (th k) t (w0 + K1 / INR n * Sum n (fun j => sin (th k t - th j t)))).

(* paley.fig2 clause 1, for every cyclic graph, with the eigenvalues *)
Definition fig2_1 : Prop := forall n m, (3 <= n)%nat -> (m < n)%nat ->
  eigenpair n (CN n) (RtoC (2 - 2 * cos (2 * PI * INR m / INR n))) (fourier n m).
(* paley.fig2 clause 2: the generalised regular polygon {p/d}: p different corners, each the corner before turned by 2 pi d/p,
   p and d without a common factor; the edges of the graph drawn at the phasors of column m are its sides *)
Definition polygon (p d : nat) (z : nat -> C) := (1 <= p)%nat /\ Nat.gcd p d = 1%nat /\
  (forall k, z (S k) = (expi (2 * PI * INR d / INR p) * z k)%C) /\ forall j k, z j = z k <-> (j mod p = k mod p)%nat.
Definition fig2_2 : Prop := forall n m, (3 <= n)%nat -> (m < n)%nat -> let z k := expi (2 * PI / INR n * (INR m * INR k)) in
  exists p d, Nat.divide p n /\ polygon p d z /\ forall a b : C,
    (exists k j, (k < n)%nat /\ (j < n)%nat /\ CN n k j = true /\ a = z k /\ b = z j) <->
    (exists i, (i < p)%nat /\ ((a = z i /\ b = z (S i)) \/ (b = z i /\ a = z (S i)))).

(* paley.fig2.caption clause 1 *)
Definition caption_1 : Prop := forall th lam, eigenpair 12 (CN 12) lam (phasor th) -> stationary 12 (W1 12 (CN 12)) th.

(* paley.fig3.max clauses 1, 2, for every even cycle: neighbours on the cycle are opposite *)
Definition alternating (n : nat) (th : nat -> R) := exists a, forall k, (k < n)%nat -> expi (th k) = expi (a + PI * INR k).
Definition fig3_1 : Prop := forall q th, (2 <= q)%nat -> alternating (2 * q) th ->
  balanced (2 * q) th /\ pattern 2 (2 * q) th /\ maximal (W1 (2 * q) (CN (2 * q))) th.
Definition fig3_2 : Prop := forall q th, (2 <= q)%nat -> maximal (W1 (2 * q) (CN (2 * q))) th -> alternating (2 * q) th.

(* paley.incid: column f of B belongs to the edge from j = tl f to k = hd f *)
Definition incidence (n e : nat) (tl hd : nat -> nat) (B : nat -> nat -> R) := forall f, (f < e)%nat ->
  B (hd f) f = 1 /\ B (tl f) f = -1 /\ forall i, (i < n)%nat -> i <> hd f -> i <> tl f -> B i f = 0.
Definition is_BBT (n e : nat) (adj : graph) (B : nat -> nat -> R) := forall i j, (i < n)%nat -> (j < n)%nat ->
  lap n adj i j = Sum e (fun f => B i f * B j f).
(* one column for each directed edge; one for each undirected edge, directed either way *)
Definition directed_edges n adj e (tl hd : nat -> nat) := (forall f, (f < e)%nat -> arc n adj (tl f) (hd f)) /\
  forall j k, arc n adj j k -> exists! f, (f < e)%nat /\ tl f = j /\ hd f = k.
Definition undirected_edges n adj e (tl hd : nat -> nat) := (forall f, (f < e)%nat -> arc n adj (tl f) (hd f)) /\
  forall j k, arc n adj j k -> exists! f, (f < e)%nat /\ ((tl f = j /\ hd f = k) \/ (tl f = k /\ hd f = j)).
(* paley.incid clause 1 as printed, refuted; it fails for every graph with an edge *)
Definition incid_printed : Prop := forall n adj e tl hd B, undirected adj -> no_loops adj -> directed_edges n adj e tl hd ->
  incidence n e tl hd B -> is_BBT n e adj B.
Definition incid_1 : Prop := ~ incid_printed /\ forall n adj e tl hd B, undirected adj -> no_loops adj -> directed_edges n adj e tl hd ->
  incidence n e tl hd B -> (exists j k, arc n adj j k) -> ~ is_BBT n e adj B.
(* paley.incid clause 2 *)
Definition incid_2 : Prop := forall n adj e tl hd B, undirected adj -> no_loops adj -> undirected_edges n adj e tl hd ->
  incidence n e tl hd B -> is_BBT n e adj B.

(* paley.patterns.two clause 1; a splay state: the phases are those of the N roots of unity, turned, in some order *)
Definition splay (n : nat) (th : nat -> R) := exists a (place : nat -> nat), (forall k, (k < n)%nat -> (place k < n)%nat) /\
  (forall j k, (j < n)%nat -> (k < n)%nat -> place j = place k -> j = k) /\
  forall k, (k < n)%nat -> expi (th k) = expi (a + 2 * PI * INR (place k) / INR n).
Definition two_1 : Prop := forall n, (2 <= n)%nat ->
  (exists th, pattern 1 n th) /\ (forall th, pattern 1 n th <-> synchronized n th) /\
  (exists th, pattern n n th) /\ (forall th, pattern n n th <-> splay n th).
(* paley.patterns.two clause 2: both are symmetric patterns, and no arrangement is both *)
Definition two_2 : Prop := forall n, (2 <= n)%nat -> Nat.divide 1 n /\ Nat.divide n n /\
  (forall th, pattern 1 n th \/ pattern n n th -> symmetric_pattern n th) /\ forall th, ~ (pattern 1 n th /\ pattern n n th).

(* paley.zero.dir clause 1 as printed, refuted; a strongly connected subgraph: nodes that reach each other *)
Definition reach (n : nat) (adj : graph) := clos_refl_trans nat (arc n adj).
Definition zero_printed : Prop := forall n adj th, (1 <= n)%nat -> no_loops adj -> ~ strongly_connected n adj ->
  (W1 n adj th = 0 <-> forall j k, (j < n)%nat -> (k < n)%nat -> reach n adj j k -> reach n adj k j -> expi (th j) = expi (th k)).
Definition zero_1 : Prop := ~ zero_printed.

(* ---- the theorems prove them ---- *)
(* graphs that agree on the nodes *)
Lemma agree_deg n (a b : graph) k : (forall j, (j < n)%nat -> a k j = b k j) -> deg n a k = deg n b k.
Proof. intros H. unfold deg, w. apply Sum_ext. intros j Hj. now rewrite H. Qed.
Definition agree n (a b : graph) := forall k j, (k < n)%nat -> (j < n)%nat -> a k j = b k j.
Lemma agree_lap n a b k j : agree n a b -> (k < n)%nat -> (j < n)%nat -> lap n a k j = lap n b k j.
Proof. intros H Hk Hj. unfold lap. rewrite (agree_deg n a b k) by (intros; now apply H). unfold w. now rewrite H. Qed.
Lemma agree_row n a b k x : agree n a b -> (k < n)%nat -> row n (lap n a) k x = row n (lap n b) k x.
Proof. intros H Hk. unfold row. apply Csum_ext. intros j Hj. now rewrite (agree_lap n a b). Qed.
Lemma agree_W1 n a b th : agree n a b -> W1 n a th = W1 n b th.
Proof. intros H. unfold W1, Q. f_equal. apply Sum_ext. intros k Hk. now rewrite (agree_row n a b). Qed.
Lemma agree_strong n a b : agree n a b -> strongly_connected n a -> strongly_connected n b.
Proof.
  intros H S j k Hj Hk. specialize (S j k Hj Hk). clear Hj Hk. induction S as [x y [A [B E]]| |]; [|apply rt_refl|eapply rt_trans; eassumption].
  apply rt_step. repeat split; try assumption. now rewrite <- H.
Qed.
Lemma step_mod n k : (k < n)%nat -> (S k mod n = if Nat.eqb (S k) n then 0 else S k)%nat.
Proof. intros H. destruct (Nat.eqb_spec (S k) n) as [->|N]; [apply Nat.mod_same; lia|apply Nat.mod_small; lia]. Qed.
Lemma diff_mod n k j : (k < n)%nat -> (j < n)%nat -> ((j + n - k) mod n = if Nat.leb k j then j - k else j + n - k)%nat.
Proof.
  intros Hk Hj. destruct (Nat.leb_spec k j); [|apply Nat.mod_small; lia].
  replace (j + n - k)%nat with (j - k + 1 * n)%nat by lia. rewrite Nat.mod_add, Nat.mod_small; lia.
Qed.
Lemma CN_ring n : (3 <= n)%nat -> agree n (ring_graph n) (CN n).
Proof.
  intros Hn k j Hk Hj. unfold CN, ring_graph, ring_offset. rewrite diff_mod, !step_mod by assumption.
  destruct (Nat.leb_spec k j), (Nat.eqb_spec (S k) n), (Nat.eqb_spec (S j) n);
  repeat match goal with |- context [Nat.eqb ?a ?b] => destruct (Nat.eqb_spec a b) end; cbn; try reflexivity; lia.
Qed.
Lemma CN_undirected n : undirected (CN n).
Proof. intros k j. unfold CN. apply Bool.orb_comm. Qed.

Lemma CN_1_proved : CN_1.
Proof.
  intros n k j Hk Hj. split; [|apply (complete_row n j); lia]. unfold deg.
  rewrite (Sum_ext n _ (fun j => 1 - delta j k * 1)); [|intros i _; unfold w, KN, delta; rewrite (Nat.eqb_sym k i); destruct (Nat.eqb i k); cbn; ring].
  rewrite Sum_minus, Sum_const, (Sum_delta n k (fun _ => 1) Hk). ring.
Qed.
Lemma CN_2_proved : CN_2.
Proof.
  intros n Hn. split; [apply CN_undirected|]. apply (agree_strong n (ring_graph n)); [now apply CN_ring|]. apply ring_connected. lia.
Qed.
Lemma CN_3_proved : CN_3.
Proof.
  intros n k Hn Hk. split.
  - unfold CN. rewrite step_mod by assumption. destruct (Nat.eqb_spec (S k) n), (Nat.eqb_spec k 0), (Nat.eqb_spec k (S k)); cbn; try lia; reflexivity.
  - rewrite <- (agree_deg n (ring_graph n)); [apply ring_row; assumption|]. intros j Hj. now apply CN_ring.
Qed.
Lemma CN_4_proved : CN_4.
Proof.
  intros n j Hn Hj. rewrite <- (agree_lap n (ring_graph n)); [|now apply CN_ring|lia|assumption].
  rewrite (proj1 (ring_row n j Hn Hj)). now destruct (Nat.eqb j 0), (Nat.eqb j 1), (Nat.eqb j (n - 1)).
Qed.

Lemma pm_zero n m : (2 <= n)%nat -> (1 <= m)%nat -> exists th, pm n m th = 0%C.
Proof.
  intros Hn Hm. pose proof (INR_pos m Hm). pose proof (INR_pos n ltac:(lia)). exists (fun k => / INR m * wave n 1 k).
  pose proof (splay_balanced n Hn) as B. unfold balanced, order in B. unfold pm.
  rewrite (Csum_ext n _ (phasors (wave n 1))) by (intros k _; unfold phasors; f_equal; field; lra).
  replace (RtoC (/ (INR m * INR n))) with (RtoC (/ INR m) * RtoC (/ INR n))%C by (rewrite <- RtoC_mult; f_equal; field; lra).
  rewrite <- Cmult_assoc, B. apply Cmult_0_r.
Qed.
Lemma Um_1_proved : Um_1.
Proof.
  intros n m Hn Hm. split; [|now apply pm_zero]. intros th. destruct (Um_extremes n m th) as (_ & Z & _); try lia. split.
  - intros E th'. apply Z in E. destruct (Um_extremes n m th') as ((P & _) & _); try lia.
    change (Um n m th <= Um n m th'). now rewrite E.
  - intros H. apply Z. destruct (pm_zero n m Hn Hm) as [th' E]. destruct (Um_extremes n m th') as (_ & Z' & _); try lia.
    specialize (H th'). apply Z' in E. change (Um n m th <= Um n m th') in H. rewrite E in H.
    destruct (Um_extremes n m th) as ((P & _) & _); try lia. lra.
Qed.
Lemma Um_2_proved : Um_2.
Proof.
  intros n m th Hn Hm. pose proof (INR_pos m Hm) as Pm. destruct (Um_extremes n m th) as (B & _ & X); try lia. split.
  - intros H j k Hj Hk. destruct (Um_extremes n m (fun _ => 0)) as (_ & _ & Y); try lia.
    assert (E : Um n m (fun _ => 0) = INR n / (2 * INR m ^ 2)). { apply Y. intros. exists 0%Z. ring. }
    specialize (H (fun _ => 0)). change (Um n m (fun _ => 0) <= Um n m th) in H.
    destruct (proj1 X ltac:(lra) j k Hj Hk) as [z Z]. exists z.
    apply (Rmult_eq_reg_l (INR m)); [|lra]. rewrite Z. field. lra.
  - intros H th'. destruct (Um_extremes n m th') as (B' & _); try lia. change (Um n m th' <= Um n m th).
    assert (E : Um n m th = INR n / (2 * INR m ^ 2)); [|lra]. apply X. intros j k Hj Hk. destruct (H j k Hj Hk) as [z Z].
    exists z. rewrite Z. field. lra.
Qed.

Lemma strong_K2 : strongly_connected 2 complete.
Proof.
  intros j k Hj Hk. destruct (Nat.eq_dec j k) as [->|N]; [apply rt_refl|]. apply rt_step.
  repeat split; try assumption. unfold complete. destruct (Nat.eqb_spec k j); [congruence|reflexivity].
Qed.
Lemma VMN_1_proved : VMN_1.
Proof.
  intros H. destruct paley_composite.along_values as [g0 [g1 [a0 a1]]].
  set (r := paley_composite.places_along) in *. set (th := paley_composite.phases_along) in *. set (K := fun _ : nat => -1) in *.
  assert (U : forall k, (k < 2)%nat -> paley_composite.turn0 k = paley_composite.pattern_control 2 complete 2 1 1 K r th 0 k).
  { intros k Hk. unfold paley_composite.pattern_control. destruct k as [|[|k]]; [| |lia].
    - rewrite g0, a0. unfold paley_composite.turn0. cbn. field.
    - rewrite g1, a1. unfold paley_composite.turn0. cbn. field. }
  assert (R2 : forall k, (k < 2)%nat -> is_derive (th k) 0 (paley_composite.pattern_control 2 complete 2 1 1 K r th 0 k)).
  { intros k Hk. rewrite <- (U k Hk). apply paley_composite.along_turn. }
  assert (D := paley_composite.weighted_rate 2 complete 2 1 1 K ltac:(lia) ltac:(lra) complete_undirected r th 0
    (fun k _ => paley_composite.along_velocity k) R2 1).
  assert (P : particles 2 r th (fun k => 2 + 2 * (1 / INR 2) * Lc 2 complete 2 (at_time r 0) (at_time th 0) k
     - paley_composite.gUMN 2 1 K (fun k0 => th k0 0) k) 0).
  { intros k Hk. split; [apply paley_composite.along_velocity|]. eapply D_eq; [exact (R2 k Hk)|].
    unfold paley_composite.pattern_control. unfold aS. cbn [INR]. unfold Lc, row, centres, circle_centre, ck. ring. }
  assert (X := H 2%nat complete 2 1 1%nat K r th 0 (paley_composite.gUMN 2 1 K (fun k => th k 0)) _ ltac:(lia) (conj complete_undirected strong_K2)
    complete_no_loops ltac:(lra) ltac:(lra) ltac:(lia) (Nat.divide_1_l 2) ltac:(intros; lia) ltac:(unfold K; lra)
    (fun k Hk => paley_composite.UMN_gradient 2 1 K (fun j => th j 0) k ltac:(lia) Hk) P
    (is_derive_ext _ _ 0 _ (fun s => f_equal (Rplus _) (Rmult_1_l _)) D)).
  cbn [Sum] in X. rewrite <- !U, g0, g1, a0, a1 in X by lia. unfold paley_composite.turn0 in X. cbn in X. lra.
Qed.

Lemma Wm_1_proved : Wm_1.
Proof.
  assert (N : forall n m th, (1 <= n)%nat -> (2 <= m)%nat -> W_m n KN m th <> INR n / 2 - U_m n m th).
  { intros n m th Hn Hm. exact (Wm_printed_fails n m th Hn Hm). }
  split; [|exact N]. intros H. apply (N 1%nat 2%nat (fun _ => 0)); try lia. apply H; lia.
Qed.
Lemma eig_sym_1_proved : eig_sym_1.
Proof.
  intros H. destruct rhombus_phasors as (E0 & _ & E2 & _).
  destruct (H 4%nat complete rhombus (RtoC 4)) as [M [_ P]]; [lia|split; [apply complete_undirected|]|apply complete_no_loops| | | |].
  - intros j k Hj Hk. destruct (Nat.eq_dec j k) as [->|N]; [apply rt_refl|]. apply rt_step. repeat split; try assumption.
    unfold complete. destruct (Nat.eqb_spec k j); [congruence|reflexivity].
  - assert (L : forall k j, (k < 4)%nat -> (j < 4)%nat -> lap 4 complete k j = if Nat.eqb ((j + 4 - k) mod 4)%nat 0 then 3 else -1).
    { intros k j Hk Hj. unfold lap. change (deg 4 complete k) with (deg 4 KN k). rewrite (proj1 (CN_1_proved 4%nat k j Hk Hj)). rewrite diff_mod by assumption. unfold w, complete, delta.
      destruct (Nat.leb_spec k j), (Nat.eqb_spec k j); match goal with |- context [Nat.eqb ?a 0] => destruct (Nat.eqb_spec a 0) end; try lia; cbn; ring. }
    intros k j k' j' Hk Hj Hk' Hj' E. now rewrite !L, E.
  - split; [exists 0%nat; split; [lia|apply expi_neq0]|]. exact rhombus_eigen_K4.
  - intros S. specialize (S 0%nat 2%nat ltac:(lia) ltac:(lia)). change (expi 0 = expi PI) in S. rewrite E0, E2 in S. injection S as S. lra.
  - exact (rhombus_no_pattern 4 M (ex_intro _ 1%nat (conj (le_n 1) eq_refl)) P).
Qed.
Lemma kernel_1_proved : kernel_1.
Proof. intros n adj x Hn [S C]. exact (proj2 (Q_kernel n adj x Hn S C)). Qed.
Lemma kernel_2_proved : kernel_2.
Proof.
  intros n adj x Hn [S C] N. destruct (Q_kernel n adj x Hn S C) as [P Z].
  destruct (Rle_lt_or_eq_dec _ _ P) as [L|E]; [exact L|]. exfalso. apply N, Z. now symmetry.
Qed.
Lemma eq13_1_proved : eq13_1.
Proof. intros n th Hn. exact (eq13 n th Hn). Qed.
Lemma eq13_2_proved : eq13_2.
Proof. intros n th Hn. exact (eq13_stationary n th Hn). Qed.
Lemma eigvec_1_proved : eigvec_1.
Proof. intros n adj th lam Hn S [_ E]. exact (proj1 (eigenvector_stationary n adj th lam Hn S E)). Qed.
Lemma eigvec_2_proved : eigvec_2.
Proof.
  intros n adj th lam w0 K1 Hn S [_ E]. pose proof (proj2 (eigenvector_stationary n adj th lam Hn S E)) as R.
  split; [exact (R w0 K1)|]. intros t k Hk. specialize (R w0 K1 k Hk).
  eapply D_eq; [apply D_plus; [apply D_const|apply D_scal, D_id]|].
  change (Lth n adj (fun j => th j + w0 * t) k) with (gW n adj (fun j => th j + w0 * t) k).
  replace (gW n adj (fun j => th j + w0 * t) k) with (gW n adj th k); [rewrite R; ring|].
  rewrite !gW_lap. apply Sum_ext. intros j _. do 2 f_equal. ring.
Qed.

(* two particles at the origin with phases 0 and pi/2, w0 = K_0 = 1, K_1 = 2 *)
Lemma rate21 : case21 2 complete 1 1 2 curve_r curve_th 0 /\
  is_derive (fun s => V21 2 complete 1 1 2 (at_time curve_r s) (at_time curve_th s)) 0 (3 / 2).
Proof.
  destruct values21 as [b0 [b1 [a0 a1]]].
  assert (U : forall k, (k < 2)%nat -> u21 k = control5 2 complete 1 1 2 curve_r curve_th 0 k).
  { intros k Hk. unfold control5. destruct k as [|[|k]]; [| |lia].
    - rewrite b0, a0. unfold u21. cbn. field.
    - rewrite b1, a1. unfold u21. cbn. field. }
  split.
  - split; [lia|]. split; [split; [apply complete_undirected|apply strong_K2]|]. split; [apply complete_no_loops|]. split; [lra|]. split; [lra|]. split; [lra|].
    intros k Hk. split; [apply curve_r_velocity|]. eapply D_eq; [apply curve_th_rate|]. rewrite (U k Hk).
    exact (eq22 2 complete 1 1 2 ltac:(lia) ltac:(lra) curve_r curve_th 0 k).
  - eapply D_eq; [apply (eq21_actual 2 complete 1 1 2 ltac:(lia) ltac:(lra) complete_undirected curve_r curve_th u21 0)|].
    + intros k _. apply curve_r_velocity.
    + intros k _. apply curve_th_rate.
    + exact U.
    + cbn [Sum INR]. rewrite b0, b1, a0, a1. field.
Qed.
Lemma eq21_1_proved : eq21_1.
Proof.
  destruct rate21 as [I D]. split.
  - intros H. destruct (H _ _ _ _ _ _ _ _ I) as [E L]. apply is_derive_unique in E, D. rewrite E in D. lra.
  - intros H. specialize (H _ _ _ _ _ _ _ _ _ I D). lra.
Qed.

(* the theorems on (3) speak of all times; here a motion begins at 0, so the same steps from 0 on *)
Lemma stays (f : R -> R) : (forall t, 0 <= t -> is_derive f t 0) -> forall t, 0 <= t -> f t = f 0.
Proof.
  intros D t Ht. destruct (MVT_le f (fun _ => 0) 0 t Ht) as [c [_ E]]; [intros; apply D; lra|]. lra.
Qed.
Lemma stays_C (z : R -> C) : (forall t, 0 <= t -> is_velocity z t 0%C) -> forall t, 0 <= t -> z t = z 0.
Proof.
  intros D t Ht. apply injective_projections.
  - apply (stays (fun s => fst (z s))); [|exact Ht]. intros s Hs. apply (D s Hs).
  - apply (stays (fun s => snd (z s))); [|exact Ht]. intros s Hs. apply (D s Hs).
Qed.
Lemma eq3_1_proved : eq3_1.
Proof.
  intros n r th M t k Ht Hk.
  assert (T : forall t, 0 <= t -> th k t = th k 0) by (apply stays; intros s Hs; apply (M s Hs k Hk)). split; [now apply T|].
  assert (E : (r k t - RtoC t * expi (th k 0%R))%C = (r k 0%R - RtoC 0 * expi (th k 0%R))%C).
  { apply (stays_C (fun s => r k s - RtoC s * expi (th k 0%R))%C); [|exact Ht]. intros s Hs. destruct (M s Hs k Hk) as [[A B] _].
    rewrite (T s Hs) in A, B. split; cbn.
    - apply (is_derive_ext (fun s => fst (r k s) - cos (th k 0) * s)); [intros; cbn; ring|].
      eapply D_eq; [apply D_minus; [exact A|apply D_scal, D_id]|]. cbn. ring.
    - apply (is_derive_ext (fun s => snd (r k s) - sin (th k 0) * s)); [intros; cbn; ring|].
      eapply D_eq; [apply D_minus; [exact B|apply D_scal, D_id]|]. cbn. ring. }
  replace (r k t) with ((r k t - RtoC t * expi (th k 0%R)) + RtoC t * expi (th k 0%R))%C by ring. rewrite E.
  apply injective_projections; cbn; ring.
Qed.
Definition spoke (w0 a : R) : C := (/ w0 * sin a, - / w0 * cos a).
Lemma radius_is w0 (r : nat -> C) (th : nat -> R) k : (r k - ck w0 r th k)%C = spoke w0 (th k).
Proof. unfold ck, spoke. apply injective_projections; cbn; ring. Qed.
Lemma eq3_2_proved : eq3_2.
Proof.
  intros n r th w0 W M k Hk c. assert (A : 0 < Rabs w0) by now apply Rabs_pos_lt.
  assert (T : forall t, 0 <= t -> th k t = th k 0 + w0 * t).
  { intros t Ht. assert (E : th k t - w0 * t = th k 0 - w0 * 0); [|lra]. apply (stays (fun t => th k t - w0 * t)); [|exact Ht].
    intros s Hs. eapply D_eq; [apply D_minus; [apply (M s Hs k Hk)|apply D_scal, D_id]|]. ring. }
  assert (CC : forall t, 0 <= t -> c t = c 0).
  { apply stays_C. intros s Hs. destruct (M s Hs k Hk) as [V D]. eapply velocity_eq; [exact (eq18 w0 (r k) (th k) s w0 V D)|].
    apply injective_projections; cbn; field; lra. }
  assert (P : exists phi, forall t, 0 <= t -> r k t = (c 0%R + RtoC (/ Rabs w0) * expi (phi + w0 * t))%C).
  { assert (X : forall t, 0 <= t -> r k t = (c 0%R + spoke w0 (th k t))%C).
    { intros t Ht. rewrite <- (CC t Ht). pose proof (radius_is w0 (at_time r t) (at_time th t) k) as E. cbv beta in E. rewrite <- E. unfold c. ring. }
    destruct (Rtotal_order w0 0) as [L|[L|L]]; [|contradiction|].
    - exists (th k 0 + PI / 2). intros t Ht. rewrite X, (T t) by exact Ht. rewrite Rabs_left by assumption. f_equal. unfold spoke.
      replace (th k 0 + PI / 2 + w0 * t) with (PI / 2 + (th k 0 + w0 * t)) by ring. apply injective_projections; cbn.
      + rewrite cos_plus, cos_PI2, sin_PI2. field. lra.
      + rewrite sin_plus, cos_PI2, sin_PI2. field. lra.
    - exists (th k 0 - PI / 2). intros t Ht. rewrite X, (T t) by exact Ht. rewrite Rabs_right by lra. f_equal. unfold spoke.
      replace (th k 0 - PI / 2 + w0 * t) with ((th k 0 + w0 * t) - PI / 2) by ring. apply injective_projections; cbn.
      + rewrite cos_minus, cos_PI2, sin_PI2. field. lra.
      + rewrite sin_minus, cos_PI2, sin_PI2. field. lra. }
  split; [|exact P]. intros t Ht. split; [now apply CC|]. destruct P as [phi P]. rewrite (P t Ht).
  replace (c 0%R + RtoC (/ Rabs w0) * expi (phi + w0 * t) - c 0%R)%C with (RtoC (/ Rabs w0) * expi (phi + w0 * t))%C by ring.
  rewrite Cmod_mult, Cmod_expi, Cmod_R, Rabs_pos_eq; [ring|]. left. now apply Rinv_0_lt_compat.
Qed.
Lemma eq3_3_proved : eq3_3.
Proof.
  intros n r th w0 W M k t Hk Ht radius.
  assert (E : inner (Ci * radius)%C (expi (th k t)) = / w0).
  { unfold radius. pose proof (radius_is w0 (at_time r t) (at_time th t) k) as X. cbv beta in X. rewrite X, inner_xy. unfold spoke.
    transitivity (/ w0 * (sin (th k t) ^ 2 + cos (th k t) ^ 2)); [cbn; ring|]. rewrite sc2. ring. }
  rewrite E. split; intros H; [now apply Rinv_0_lt_compat|now apply Rinv_lt_0_compat].
Qed.

Lemma ext_1_proved : ext_1.
Proof. intros n th a Hn. exact (U1_rotation n th a Hn). Qed.
Lemma ext_2_proved : ext_2.
Proof. intros n th Hn. symmetry. exact (proj1 (U1_extremes n th Hn)). Qed.
Lemma ext_3_proved : ext_3.
Proof.
  intros n Hn. split; [intros th; symmetry; exact (U1_minimizers n th Hn)|]. exists (wave n 1). now apply splay_balanced.
Qed.
Lemma eq10_proved : eq10.
Proof.
  intros n w0 K1 th t Hn u9.
  assert (E : forall k, w0 + u9 k = w0 + K1 / INR n * Sum n (fun j => sin (th k t - th j t))) by (intros k; exact (control9_sines n (at_time th t) k w0 K1)).
  split; intros H k Hk; [rewrite <- E|rewrite E]; now apply H.
Qed.

Lemma fig2_1_proved : fig2_1.
Proof.
  intros n m Hn Hm. pose proof (INR_pos n ltac:(lia)) as P. split.
  - exists 0%nat. split; [lia|]. unfold fourier. apply Cmult_neq_0; [|apply expi_neq0]. intros Z. apply (f_equal fst) in Z. cbn in Z.
    assert (0 < / sqrt (INR n)) by (apply Rinv_0_lt_compat, sqrt_lt_R0, P). lra.
  - intros k Hk. rewrite (fourier_is n m k) by lia. rewrite <- (ring_eigenvalue n m Hn).
    rewrite <- (dft_diagonalizes n (ring_graph n) (ring_offset n) m ltac:(lia) (ring_circulant n) k Hk).
    rewrite (agree_row n _ (CN n) k _ (CN_ring n Hn) Hk). unfold row. apply Csum_ext. intros j _. now rewrite (fourier_is n m j) by lia.
Qed.
Lemma caption_1_proved : caption_1.
Proof. intros th lam E. apply (eigvec_1_proved 12%nat (CN 12) th lam); [lia|apply CN_undirected|exact E]. Qed.

(* the phasors of column m in lowest terms d/p *)
Lemma same_rest p d a b q : Nat.gcd p d = 1%nat -> (a < p)%nat -> (b <= a)%nat -> (Z.of_nat d * (Z.of_nat a - Z.of_nat b) = q * Z.of_nat p)%Z -> a = b.
Proof.
  intros G Ha L E. assert (D : Nat.divide p (a - b)).
  { apply (Nat.gauss p d); [|exact G]. exists (Z.to_nat q). assert (0 <= q)%Z by nia. apply Nat2Z.inj.
    rewrite !Nat2Z.inj_mul, Z2Nat.id, Nat2Z.inj_sub by assumption. exact E. }
  destruct D as [[|y] Y]; [lia|]. cbn in Y. lia.
Qed.
Lemma fig2_2_proved : fig2_2.
Proof.
  intros n m Hn Hm z. pose proof (INR_pos n ltac:(lia)) as Pn. set (g := Nat.gcd n m).
  assert (Hg : g <> 0%nat) by (unfold g; intros E; apply Nat.gcd_eq_0_l in E; lia).
  destruct (Nat.gcd_divide_l n m) as [p Ep]. destruct (Nat.gcd_divide_r n m) as [d Ed]. fold g in Ep, Ed.
  pose proof (Nat.gcd_div_gcd n m g Hg eq_refl) as CP. rewrite Ep, Ed, !Nat.div_mul in CP by assumption. clearbody g.
  assert (Hp : (1 <= p)%nat) by (destruct p; lia). pose proof (INR_pos p Hp) as Pp.
  assert (Pg : 0 < INR g) by (apply lt_0_INR; lia).
  assert (Z : forall k, z k = expi (2 * PI * INR d * INR k / INR p)).
  { intros k. unfold z. f_equal. rewrite Ep, Ed, !mult_INR. field. split; lra. }
  assert (Zm : forall k, z (k mod p) = z k) by (intros k; rewrite !Z; now apply expi_mod).
  assert (Pol : polygon p d z).
  { split; [exact Hp|]. split; [exact CP|]. split.
    - intros k. rewrite !Z, <- expi_plus. f_equal. rewrite S_INR. field. lra.
    - intros j k. split.
      + rewrite <- (Zm j), <- (Zm k), !Z. pose proof (Nat.mod_upper_bound j p ltac:(lia)). pose proof (Nat.mod_upper_bound k p ltac:(lia)).
        generalize dependent (k mod p)%nat. generalize dependent (j mod p)%nat. intros a Ha b Hb E. apply expi_inj_minus, expi_one in E.
        destruct E as [q E]. assert (F : IZR (Z.of_nat d * (Z.of_nat a - Z.of_nat b)) = IZR (q * Z.of_nat p)).
        { rewrite !mult_IZR, minus_IZR, <- !INR_IZR_INZ. pose proof PI_RGT_0 as PP. apply (Rmult_eq_reg_l (2 * PI / INR p)).
          - replace (2 * PI / INR p * (IZR q * INR p)) with (2 * PI * IZR q) by (field; lra). rewrite <- E. field. lra.
          - apply Rgt_not_eq, Rdiv_lt_0_compat; lra. }
        apply eq_IZR in F. destruct (Nat.le_ge_cases b a) as [Le|Le]; [apply (same_rest p d a b q)|symmetry; apply (same_rest p d b a (- q)%Z)]; try assumption.
        lia.
      + intros E. now rewrite <- (Zm j), <- (Zm k), E. }
  exists p, d. split; [exists g; lia|]. split; [exact Pol|]. destruct Pol as (_ & _ & _ & Per).
  assert (Zn : forall k, z (k mod n) = z k).
  { intros k. apply Per. rewrite (Nat.div_mod k n) at 2 by lia. rewrite Ep at 2. rewrite Nat.add_comm.
    replace (g * p)%nat with (p * g)%nat by lia. replace (p * g * (k / n))%nat with (g * (k / n) * p)%nat by lia. now rewrite Nat.mod_add by lia. }
  assert (Sp : forall k, z (S (k mod p)) = z (S k)).
  { intros k. apply Per. rewrite <- (Nat.add_1_r (k mod p)), Nat.add_mod_idemp_l, Nat.add_1_r by lia. reflexivity. }
  intros a b. split.
  - intros (k & j & Hk & Hj & A & -> & ->). unfold CN in A. apply Bool.orb_true_iff in A as [A|A]; apply Nat.eqb_eq in A.
    + exists (k mod p)%nat. split; [apply Nat.mod_upper_bound; lia|]. left. rewrite Zm, Sp, A, Zn. split; reflexivity.
    + exists (j mod p)%nat. split; [apply Nat.mod_upper_bound; lia|]. right. rewrite Zm, Sp, A, Zn. split; reflexivity.
  - intros (i & Hi & H). assert (Hin : (i < n)%nat) by nia. assert (Sn : (S i mod n < n)%nat) by (apply Nat.mod_upper_bound; lia).
    destruct H as [[-> ->]|[-> ->]].
    + exists i, (S i mod n)%nat. repeat split; try assumption; [|now rewrite Zn]. unfold CN. now rewrite Nat.eqb_refl.
    + exists (S i mod n)%nat, i. repeat split; try assumption; [|now rewrite Zn]. unfold CN. now rewrite Nat.eqb_refl, Bool.orb_true_r.
Qed.

(* alternating phases: each step turns by half a turn *)
Lemma half_turn a : expi (a + PI) = (- expi a)%C.
Proof. unfold expi, Copp; cbn. now rewrite neg_cos, neg_sin. Qed.
Lemma alternate a k : expi (a + PI * INR k) = if Nat.even k then expi a else (- expi a)%C.
Proof.
  induction k as [|k IH]; [cbn; f_equal; ring|]. rewrite Nat.even_succ, <- Nat.negb_even, S_INR.
  replace (a + PI * (INR k + 1)) with (a + PI * INR k + PI) by ring. rewrite half_turn, IH. destruct (Nat.even k); cbn [negb]; [reflexivity|]. ring.
Qed.
Lemma flip_cos s t : expi t = (- expi s)%C -> cos (t - s) = -1.
Proof. intros E. rewrite <- inner_expi, E, inner_xy. cbn. pose proof (sc2 s). lra. Qed.
Lemma alternating_flips q th : (2 <= q)%nat -> alternating (2 * q) th ->
  forall k, (k < 2 * q)%nat -> expi (th (S k mod (2 * q))) = (- expi (th k))%C.
Proof.
  intros Hq [a A] k Hk. rewrite !A; [|assumption|apply Nat.mod_upper_bound; lia]. rewrite !alternate, step_mod by assumption.
  destruct (Nat.eqb_spec (S k) (2 * q)) as [E|E].
  - assert (O : Nat.even k = false). { rewrite <- Nat.negb_odd, <- Nat.even_succ, E, Nat.even_mul. reflexivity. }
    rewrite O. cbn [Nat.even]. ring.
  - rewrite Nat.even_succ, <- Nat.negb_even. destruct (Nat.even k); cbn [negb]; [reflexivity|ring].
Qed.
Lemma alternating_two q th : (2 <= q)%nat -> alternating (2 * q) th -> W1 (2 * q) (ring_graph (2 * q)) th = 2.
Proof.
  intros Hq A. apply (proj2 (paley_fish.ring_max (2 * q) th ltac:(lia))). intros j k [Hj [Hk E]].
  rewrite (CN_ring (2 * q) ltac:(lia) k j Hk Hj) in E. apply Bool.orb_true_iff in E as [E|E]; apply Nat.eqb_eq in E.
  - rewrite E. apply flip_cos. now apply alternating_flips.
  - rewrite E. replace (th j - th (S j mod (2 * q))) with (- (th (S j mod (2 * q)) - th j)) by ring. rewrite cos_neg. apply flip_cos. now apply alternating_flips.
Qed.
Lemma fig3_1_proved : fig3_1.
Proof.
  intros q th Hq A. pose proof (alternating_two q th Hq A) as E. destruct (paley_fish.ring_maximizer_pattern (2 * q) th ltac:(lia) E) as [P B].
  split; [exact B|]. split; [exact P|]. intros th'. rewrite <- !(agree_W1 _ _ _ _ (CN_ring (2 * q) ltac:(lia))), E.
  apply (paley_fish.ring_max (2 * q) th' ltac:(lia)).
Qed.
Lemma fig3_2_proved : fig3_2.
Proof.
  intros q th Hq H. set (al := fun k => PI * INR k).
  assert (A : alternating (2 * q) al) by (exists 0; intros k _; f_equal; unfold al; ring).
  specialize (H al). rewrite <- !(agree_W1 _ _ _ _ (CN_ring (2 * q) ltac:(lia))), (alternating_two q al Hq A) in H.
  destruct (paley_fish.ring_max (2 * q) th ltac:(lia)) as [L X]. assert (E : W1 (2 * q) (ring_graph (2 * q)) th = 2) by lra.
  pose proof (proj1 X E) as F. exists (th 0%nat). induction k as [|k IH]; intros Hk; [f_equal; cbn; ring|].
  assert (Y : arc (2 * q) (ring_graph (2 * q)) (S k) k).
  { repeat split; [lia|lia|]. rewrite (CN_ring (2 * q) ltac:(lia)) by lia. unfold CN. rewrite (Nat.mod_small (S k)) by lia. now rewrite Nat.eqb_refl. }
  rewrite (paley_fish.opposite _ _ (F _ _ Y)), IH, S_INR by lia. replace (th 0%nat + PI * (INR k + 1)) with (th 0%nat + PI * INR k + PI) by ring.
  now rewrite half_turn.
Qed.

(* the columns that join i and j *)
Definition joins (tl hd : nat -> nat) (i j f : nat) : R := delta (tl f) i * delta (hd f) j.
Lemma joins_one tl hd i j f : tl f = i -> hd f = j -> joins tl hd i j f = 1.
Proof. intros <- <-. unfold joins. rewrite !delta_eq. ring. Qed.
Lemma joins_zero tl hd i j f : ~ (tl f = i /\ hd f = j) -> joins tl hd i j f = 0.
Proof. intros H. unfold joins, delta. destruct (Nat.eqb_spec (tl f) i), (Nat.eqb_spec (hd f) j); try ring. tauto. Qed.
Lemma one_of e (x : nat -> R) f0 : (f0 < e)%nat -> x f0 = 1 -> (forall f, (f < e)%nat -> f <> f0 -> x f = 0) -> Sum e x = 1.
Proof.
  intros H0 H1 H. rewrite (Sum_ext e x (fun f => delta f f0 * 1)); [now apply (Sum_delta e f0 (fun _ => 1))|].
  intros f Hf. destruct (Nat.eq_dec f f0) as [->|N]; [rewrite delta_eq, H1; ring|rewrite delta_neq, H by assumption; ring].
Qed.
(* B B^T through the numbers c i j of the columns between i and j *)
Lemma BBT_count n e tl hd B (c : nat -> nat -> R) i j : (forall f, (f < e)%nat -> (tl f < n)%nat /\ (hd f < n)%nat /\ tl f <> hd f) ->
  incidence n e tl hd B -> (forall i j, (i < n)%nat -> (j < n)%nat -> Sum e (fun f => joins tl hd i j f + joins tl hd j i f) = c i j) ->
  (i < n)%nat -> (j < n)%nat -> Sum e (fun f => B i f * B j f) = delta i j * Sum n (c i) - c i j.
Proof.
  intros HE HB HC Hi Hj. assert (V : forall l f, (l < n)%nat -> (f < e)%nat -> B l f = delta (hd f) l - delta (tl f) l).
  { intros l f Hl Hf. destruct (HB f Hf) as (B1 & B2 & B3). destruct (HE f Hf) as (_ & _ & N).
    destruct (Nat.eq_dec l (hd f)) as [->|N1]; [rewrite delta_eq, delta_neq by assumption; lra|].
    destruct (Nat.eq_dec l (tl f)) as [->|N2]; [rewrite delta_eq, delta_neq by congruence; lra|].
    rewrite B3, !delta_neq by congruence. ring. }
  rewrite <- (HC i j Hi Hj).
  rewrite (Sum_ext n (c i) (fun l => Sum e (fun f => joins tl hd i l f + joins tl hd l i f))) by (intros l Hl; now rewrite HC).
  rewrite Sum_swap, <- Sum_scal, <- Sum_minus. apply Sum_ext. intros f Hf. rewrite !V by assumption. destruct (HE f Hf) as (H1 & H2 & N).
  assert (S1 : Sum n (fun l => joins tl hd i l f) = delta (tl f) i).
  { rewrite <- (Sum_delta_l n (hd f) (fun _ => delta (tl f) i) H2). apply Sum_ext. intros; unfold joins; ring. }
  assert (S2 : Sum n (fun l => joins tl hd l i f) = delta (hd f) i) by exact (Sum_delta_l n (tl f) (fun _ => delta (hd f) i) H1).
  rewrite Sum_plus, S1, S2. unfold joins.
  destruct (Nat.eq_dec i j) as [->|Nij]; [rewrite delta_eq|rewrite (delta_neq i j) by assumption].
  - destruct (Nat.eq_dec (tl f) j) as [E1|E1]; [rewrite E1 in *; rewrite delta_eq, (delta_neq (hd f) j) by congruence; ring|rewrite (delta_neq (tl f) j) by assumption].
    unfold delta. destruct (Nat.eqb (hd f) j); ring.
  - unfold delta. destruct (Nat.eqb_spec (hd f) i), (Nat.eqb_spec (hd f) j), (Nat.eqb_spec (tl f) i), (Nat.eqb_spec (tl f) j); subst; try congruence; ring.
Qed.
Lemma ends_apart n adj e (tl hd : nat -> nat) : no_loops adj -> (forall f, (f < e)%nat -> arc n adj (tl f) (hd f)) ->
  forall f, (f < e)%nat -> (tl f < n)%nat /\ (hd f < n)%nat /\ tl f <> hd f.
Proof. intros NL A f Hf. destruct (A f Hf) as (H1 & H2 & H3). repeat split; try assumption. intros E. rewrite E, NL in H3. discriminate. Qed.
Lemma incid_2_proved : incid_2.
Proof.
  intros n adj e tl hd B U NL [A X] HB i j Hi Hj. rewrite (BBT_count n e tl hd B (w adj) i j (ends_apart n adj e tl hd NL A) HB); [reflexivity| |assumption..].
  clear i j Hi Hj. intros i j Hi Hj. unfold w. destruct (adj i j) eqn:E.
  - assert (Nij : i <> j) by (intros ->; rewrite NL in E; discriminate).
    destruct (X j i (conj Hj (conj Hi E))) as [f0 [[F0 F1] F2]]. apply (one_of e _ f0 F0).
    + destruct F1 as [[T H]|[T H]]; [rewrite (joins_zero tl hd i j), (joins_one tl hd j i)|rewrite (joins_one tl hd i j), (joins_zero tl hd j i)];
      try assumption; try ring; intros [? ?]; congruence.
    + intros f Hf N. rewrite !joins_zero; [ring| |]; intros [? ?]; apply N; symmetry; apply F2; tauto.
  - apply Sum_zero. intros f Hf. pose proof (proj2 (proj2 (A f Hf))) as T. rewrite !joins_zero; [ring| |]; intros [E1 E2]; rewrite E1, E2 in T.
    + congruence.
    + rewrite U in T. congruence.
Qed.
Lemma twice n adj e tl hd B : undirected adj -> no_loops adj -> directed_edges n adj e tl hd -> incidence n e tl hd B ->
  forall i j, (i < n)%nat -> (j < n)%nat -> Sum e (fun f => B i f * B j f) = 2 * lap n adj i j.
Proof.
  intros U NL [A X] HB i j Hi Hj. rewrite (BBT_count n e tl hd B (fun i j => 2 * w adj i j) i j (ends_apart n adj e tl hd NL A) HB).
  - rewrite Sum_scal. unfold lap, deg. ring.
  - clear i j Hi Hj. assert (O : forall i j, (i < n)%nat -> (j < n)%nat -> Sum e (joins tl hd i j) = w adj j i).
    { intros i j Hi Hj. unfold w. destruct (adj j i) eqn:E.
      - destruct (X i j (conj Hi (conj Hj E))) as [f0 [(F0 & T & H) F2]]. apply (one_of e _ f0 F0); [now apply joins_one|].
        intros f Hf N. apply joins_zero. intros [? ?]. apply N. symmetry. now apply F2.
      - apply Sum_zero. intros f Hf. apply joins_zero. intros [E1 E2]. pose proof (proj2 (proj2 (A f Hf))) as T. rewrite E1, E2 in T. congruence. }
    intros i j Hi Hj. rewrite Sum_plus, !O by assumption. unfold w. rewrite (U j i). ring.
  - assumption.
  - assumption.
Qed.
Lemma incid_1_proved : incid_1.
Proof.
  assert (N : forall n adj e tl hd B, undirected adj -> no_loops adj -> directed_edges n adj e tl hd ->
    incidence n e tl hd B -> (exists j k, arc n adj j k) -> ~ is_BBT n e adj B).
  { intros n adj e tl hd B U NL D HB [j [k (Hj & Hk & E)]] H. specialize (H k j Hk Hj). rewrite (twice n adj e tl hd B U NL D HB k j Hk Hj) in H.
    unfold lap, w in H. rewrite E in H. rewrite (delta_neq k j) in H by (intros ->; rewrite NL in E; discriminate). lra. }
  split; [|exact N]. intros H. set (tl := fun f : nat => f). set (hd := fun f => (1 - f)%nat).
  set (B := fun i f : nat => if Nat.eqb i f then -1 else 1).
  assert (D : directed_edges 2 complete 2 tl hd).
  { split.
    - intros f Hf. unfold tl, hd. destruct f as [|[|f]]; [| |lia]; repeat split; lia.
    - intros j k (Hj & Hk & E). exists j. unfold tl, hd. assert (j <> k) by (intros ->; rewrite complete_no_loops in E; discriminate).
      split; [lia|]. intros f (Hf & T & _). now symmetry. }
  assert (I : incidence 2 2 tl hd B).
  { intros f Hf. unfold tl, hd, B. destruct f as [|[|f]]; [| |lia]; (split; [reflexivity|]; split; [reflexivity|]; intros; lia). }
  apply (N 2%nat complete 2%nat tl hd B complete_undirected complete_no_loops D I).
  - exists 0%nat, 1%nat. repeat split; lia.
  - exact (H 2%nat complete 2%nat tl hd B complete_undirected complete_no_loops D I).
Qed.

Lemma two_1_proved : two_1.
Proof.
  intros n Hn. destruct (two_patterns n ltac:(lia)) as [P1 Pn]. pose proof (INR_pos n ltac:(lia)) as N0.
  split; [now exists (pattern_phases 1)|]. split; [|split; [now exists (pattern_phases n)|]].
  - intros th. split; intros H.
    + destruct H as [_ [a [cl [H _]]]]. intros j k Hj Hk. destruct (H j Hj) as [Cj ->]. destruct (H k Hk) as [Ck ->].
      now replace (cl j) with (cl k) by lia.
    + split; [lia|]. exists (th 0%nat), (fun _ => 0%nat). split.
      * intros k Hk. split; [lia|]. replace (th 0%nat + 2 * PI * INR 0 / INR 1) with (th 0%nat) by (cbn; field). apply H; lia.
      * intros l Hl. replace l with 0%nat by lia. rewrite delta_eq, Sum_const. cbn. ring.
  - intros th. split.
    + intros [_ [a [cl [H C]]]]. exists a, cl. split; [intros k Hk; apply (H k Hk)|]. split; [|intros k Hk; apply (H k Hk)].
      intros j k Hj Hk E. destruct (Nat.eq_dec j k) as [|N]; [assumption|]. exfalso. specialize (C (cl k) (proj1 (H k Hk))).
      assert (L : Sum n (fun i => delta i j * 1) + Sum n (fun i => delta i k * 1) <= Sum n (fun i => delta (cl i) (cl k))).
      { rewrite <- Sum_plus. apply Sum_le. intros i _. unfold delta.
        destruct (Nat.eqb_spec i j), (Nat.eqb_spec i k), (Nat.eqb_spec (cl i) (cl k)); subst; try congruence; lra. }
      rewrite (Sum_delta n j (fun _ => 1) Hj), (Sum_delta n k (fun _ => 1) Hk) in L. nra.
    + intros (a & pl & B & I & E). split; [lia|]. exists a, pl. split; [intros k Hk; split; [now apply B|now apply E]|]. intros l Hl.
      destruct (proj1 (FinFun.bInjective_bSurjective B) I l Hl) as [k [Hk K]].
      rewrite (one_of n _ k Hk); [ring|rewrite K; apply delta_eq|]. intros i Hi N. apply delta_neq. intros F. apply N, I; congruence.
Qed.
Lemma two_2_proved : two_2.
Proof.
  intros n Hn. split; [apply Nat.divide_1_l|]. split; [apply Nat.divide_refl|]. split.
  - intros th [P|P]; [exists 1%nat; split; [apply Nat.divide_1_l|exact P]|exists n; split; [apply Nat.divide_refl|exact P]].
  - intros th [P Q]. exact (two_patterns_differ n th Hn P Q).
Qed.
Lemma zero_1_proved : zero_1.
Proof.
  intros H. apply zero_dir_printed_fails. intros n adj th Hn NL NS. rewrite (H n adj th Hn NL NS). split; intros F j k Hj Hk.
  - intros [A B]. now apply F.
  - intros A B. apply F; [assumption..|]. now split.
Qed.
