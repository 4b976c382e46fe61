(* More clauses of the claims about Paley's paper, on the particles, their circles, graphs and fish: formalised from their words
   before the theorems were looked at; the theorems prove them. Fish, particles and nodes are 0..n-1; adj k j: j is a neighbour of k. *)
From Coq Require Import Reals Lra Lia List Relations.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums paley_model paley_phase audit_independent_paley.
Open Scope R_scope.

(* p_theta of (7), the centre of mass R of (4), and W_1(theta) of (12), written out *)
Definition p7 (n : nat) (th : nat -> R) : C := (RtoC (/ INR n) * Csum n (fun j => expi (th j)))%C.
Definition mass (n : nat) (r : nat -> C) : C := (RtoC (/ INR n) * Csum n r)%C.
Definition W12 (n : nat) (adj : graph) (th : nat -> R) : R :=
  / (2 * INR n) * Sum n (fun k => inner (expi (th k)) (Csum n (fun j => RtoC (lap n adj k j) * expi (th j)))%C).

(* paley.Rball clause 1: u_k = w0; the circles may be different *)
Definition Rball_1 : Prop := forall n w0 r th, (1 <= n)%nat -> w0 <> 0 -> (forall t, 0 <= t -> particles n r th (fun _ => w0) t) ->
  exists b : C, forall t, 0 <= t -> Cmod (mass n (at_time r t) - b)%C <= / Rabs w0.

(* paley.beacon.form clause 1 *)
Definition beacon (n : nat) (c0 : C) (c : nat -> C) : R := / (2 * INR n) * Sum n (fun k => Cmod (c k - c0)%C ^ 2).
Definition beacon_1 : Prop := forall n c0 c, (1 <= n)%nat -> (beacon n c0 c = 0 <-> forall k, (k < n)%nat -> c k = c0).
(* paley.beacon.form clause 2: it never rises, and it falls in every interval at whose start it is not zero *)
Definition beacon_2 : Prop := forall n w0 K c0 r th, (1 <= n)%nat -> w0 <> 0 -> 0 < K ->
  (forall t, 0 <= t -> particles n r th (fun k => w0 + w0 * K * inner (expi (th k t)) (ck w0 (at_time r t) (at_time th t) k - c0)%C) t) ->
  let P t := beacon n c0 (ck w0 (at_time r t) (at_time th t)) in
  forall s t, 0 <= s < t -> P t <= P s /\ (P s <> 0 -> P t < P s).

(* paley.chord clause 1: every M; clusters that are neighbours on the circle are rho apart, and no two are nearer *)
Definition chord_1 : Prop := forall M a, (1 <= M)%nat -> let rho := 2 * sin (PI / INR M) in
  let cluster l := expi (a + 2 * PI * INR l / INR M) in
  (forall l, Cmod (cluster (S l) - cluster l)%C = rho) /\
  forall l l', (l < M)%nat -> (l' < M)%nat -> l <> l' -> rho <= Cmod (cluster l - cluster l')%C.

(* paley.energy clause 1: v is the velocity; in any interval of time, whatever the steering *)
Definition energy_1 : Prop := forall n r th (u : R -> nat -> R) a b, (forall t, a < t < b -> particles n r th (u t) t) ->
  forall k (v : R -> C), (k < n)%nat -> (forall t, a < t < b -> is_velocity (r k) t (v t)) ->
  forall t, a < t < b -> is_velocity v t (RtoC (u t k) * (Ci * v t))%C.
(* paley.energy clause 2 *)
Definition energy_2 : Prop := forall n r th (u : R -> nat -> R) a b, (forall t, a < t < b -> particles n r th (u t) t) ->
  forall (v : nat -> R -> C), (forall k t, (k < n)%nat -> a < t < b -> is_velocity (r k) t (v k t)) ->
  (forall k t, (k < n)%nat -> a < t < b -> exists acc, is_velocity (v k) t acc /\
     is_derive (fun s => 1 / 2 * Cmod (v k s) ^ 2) t (inner (v k t) acc) /\ inner (v k t) acc = 0) /\
  forall s t, a < s < b -> a < t < b -> Sum n (fun k => 1 / 2 * Cmod (v k s) ^ 2) = Sum n (fun k => 1 / 2 * Cmod (v k t) ^ 2).

(* paley.eq18 clause 1 *)
Definition eq18_1 : Prop := forall n w0 r th u t, w0 <> 0 -> particles n r th u t -> forall k, (k < n)%nat ->
  is_velocity (fun s => ck w0 (at_time r s) (at_time th s) k) t (expi (th k t) * RtoC (1 - / w0 * u k))%C.

(* paley.eq22 clause 1: (5), (14), (20) on any graph, directed ones included *)
Definition ori14 n adj K1 th k := K1 / INR n * Lth n adj th k.
Definition spac20 n adj w0 K0 r th k := w0 * (K0 / INR n) * Lc n adj w0 r th k.
Definition eq22_1 : Prop := forall n adj w0 K0 K1 r th k, (1 <= n)%nat -> (k < n)%nat -> w0 <> 0 ->
  w0 + spac20 n adj w0 K0 r th k + ori14 n adj K1 th k = u22 n adj w0 K0 K1 r th k.

(* paley.eq29 clause 1, refuted: for any two networks that differ the printed control is another one at some phases, wherever the
   particles are *)
Definition printed29 n (ori att : graph) w0 K0 K1 (r : nat -> C) th k :=
  w0 + (K1 - K0) / INR n * Lth n ori th k + w0 * (K0 / INR n) * inner (expi (th k)) (Csum n (fun j => RtoC (lap n att k j) * r j))%C.
Definition eq29_1 : Prop := forall n ori att w0 K0 K1, w0 <> 0 -> K0 <> 0 ->
  (exists k j, (k < n)%nat /\ (j < n)%nat /\ k <> j /\ ori k j <> att k j) ->
  exists th k, (k < n)%nat /\ forall r, printed29 n ori att w0 K0 K1 r th k <> w0 + spac20 n att w0 K0 r th k + ori14 n ori K1 th k.

(* paley.eq7 clauses 1, 2 *)
Definition eq7_1 : Prop := forall n th, (1 <= n)%nat -> 0 <= Cmod (p7 n th) <= 1.
Definition eq7_2 : Prop := forall n th, (1 <= n)%nat -> synchronized n th -> Cmod (p7 n th) = 1.
(* paley.eq7 clause 3: whatever the steering *)
Definition eq7_3 : Prop := forall n r th u t, (1 <= n)%nat -> particles n r th u t ->
  is_velocity (fun s => mass n (at_time r s)) t (p7 n (at_time th t)).
(* paley.eq7 clause 4: at one time, and in an interval *)
Definition eq7_4 : Prop := forall n r th (u : R -> nat -> R) a b, (1 <= n)%nat -> (forall t, a < t < b -> particles n r th (u t) t) ->
  (forall t, a < t < b -> (p7 n (at_time th t) = 0%C <-> is_velocity (fun s => mass n (at_time r s)) t 0%C)) /\
  ((forall t, a < t < b -> p7 n (at_time th t) = 0%C) <->
   forall s t, a < s < b -> a < t < b -> mass n (at_time r s) = mass n (at_time r t)).

(* paley.fish.zero clauses 1, 2 *)
Definition fish_zero_1 : Prop := forall n adj th, (1 <= n)%nat -> 0 <= W12 n adj th.
Definition fish_zero_2 : Prop := forall n adj th, (1 <= n)%nat -> synchronized n th -> W12 n adj th = 0.
(* paley.fish.zero clause 3: a connected subgraph is a set of nodes joined by arcs within it, whichever way they point *)
Definition fish_zero_3 : Prop := forall n adj th (S : nat -> Prop), (1 <= n)%nat -> W12 n adj th = 0 ->
  (forall j k, S j -> S k -> clos_refl_sym_trans nat (fun x y => S x /\ S y /\ arc n adj x y) j k) ->
  forall j k, S j -> S k -> expi (th j) = expi (th k).

(* paley.fish28ori clause 1 *)
Definition fish28_1 : Prop := forall n adj K0 K1 Kori th k, (1 <= n)%nat -> (k < n)%nat -> K1 - K0 = - Kori * INR n ->
  (K1 - K0) / INR n * Lth n adj th k = - Kori * Lth n adj th k.

(* the network of the nearest q neighbours of each fish; ties broken anyhow *)
Definition nearest (n q : nat) (r : nat -> C) (adj : graph) : Prop := forall k, (k < n)%nat -> adj k k = false /\ deg n adj k = INR q /\
  forall j l, (j < n)%nat -> (l < n)%nat -> l <> k -> adj k j = true -> adj k l = false -> Cmod (r j - r k)%C <= Cmod (r l - r k)%C.
(* paley.fishpeak clause 1: fish m against the three others *)
Definition fishpeak_1 : Prop := forall r adj th m a, nearest 4 3 r adj -> (m < 4)%nat ->
  (forall k, (k < 4)%nat -> expi (th k) = expi (if Nat.eqb k m then a + PI else a)) -> 2 / (INR 3 + 1) * W12 4 adj th = 0.75.
(* paley.scale clause 1, refuted for the factor of the labels and for that of the text: n neighbours, N fish *)
Definition scale_1 : Prop :=
  ~ (forall N n r adj th, (1 <= n < N)%nat -> nearest N n r adj -> 0 <= 2 / (INR n + 1) * W12 N adj th <= 1) /\
  ~ (forall N n r adj th, (1 <= n < N)%nat -> nearest N n r adj -> 0 <= (2 / INR n + 1) * W12 N adj th <= 1).
(* paley.scale clause 2 *)
Definition scale_2 : Prop := forall N r adj th, (2 <= N)%nat -> nearest N 1 r adj -> 0 <= 2 / (INR 1 + 1) * W12 N adj th <= 1.
(* paley.scale clause 4: any square with corners z + s i^k; there are such networks and phases *)
Definition scale_4 : Prop := forall z s, s <> 0%C -> let corner k := (z + s * expi (INR k * (PI / 2)))%C in
  let opposed adj th := forall k j, (k < 4)%nat -> (j < 4)%nat -> adj k j = true -> expi (th j) = Copp (expi (th k)) in
  (exists adj th, nearest 4 2 corner adj /\ opposed adj th) /\
  forall adj th, nearest 4 2 corner adj -> opposed adj th -> 2 / (INR 2 + 1) * W12 4 adj th = 4 / 3.
(* paley.scale.complete clause 1: the network is the complete graph, and the printed equation, refuted, fails wherever the phases
   are not synchronised *)
Definition complete_1 : Prop := forall N r adj, (2 <= N)%nat -> nearest N (N - 1) r adj ->
  (forall j k, (j < N)%nat -> (k < N)%nat -> adj k j = negb (Nat.eqb k j)) /\
  forall th, ~ synchronized N th -> (2 / INR (N - 1) + 1) * W12 N adj th <> 1 - Cmod (p7 N th) ^ 2.

(* paley.length clause 1, refuted: wherever the sum is not zero; E as pairs (j, k), each edge in both directions *)
Definition QL (n : nat) (adj : graph) (x : nat -> C) : R := / (2 * INR n) * Sum n (fun k => inner (x k) (apply_L n adj x k)).
Definition edges (n : nat) (adj : graph) (x : nat -> C) : R :=
  Sum n (fun k => Sum n (fun j => if adj k j then Cmod (x j - x k)%C ^ 2 else 0)).
Definition length_1 : Prop := forall n adj x, undirected adj -> (exists j k, arc n adj j k /\ x j <> x k) ->
  QL n adj x <> / (2 * INR n) * edges n adj x.
(* paley.length clause 2 *)
Definition length_2 : Prop := forall n adj x, (1 <= n)%nat -> undirected adj -> QL n adj x = / (4 * INR n) * edges n adj x.

(* paley.ref clause 1: particle N is n - 1; on every graph these phases are a minimum, on strongly connected ones the only one *)
Definition ref_1 : Prop := forall n adj th0 th, (1 <= n)%nat ->
  let F ph := W12 n adj ph + 1 - cos (th0 - ph (n - 1)%nat) in let led := forall k, (k < n)%nat -> expi (th k) = expi th0 in
  (led -> forall th', F th <= F th') /\ (strongly_connected n adj -> (forall th', F th <= F th') -> led).

(* paley.thm2.center clause 1: the set in which S does not change along motions, the limit set of the invariance principle *)
Definition center_1 : Prop := forall n adj w0 K0 r th, (1 <= n)%nat -> undirected adj -> no_loops adj -> strongly_connected n adj ->
  w0 <> 0 -> 0 < K0 -> (forall t, 0 <= t -> particles n r th (u20 n adj w0 K0 (at_time r t) (at_time th t)) t) ->
  (forall t, 0 <= t -> is_derive (fun s => S17 n adj w0 (at_time r s) (at_time th s)) t 0) ->
  exists c0, forall k t, (k < n)%nat -> 0 <= t -> is_derive (th k) t w0 /\ ck w0 (at_time r t) (at_time th t) k = c0.
(* paley.thm2.center clause 2: motions from one initial state have one centre at the end; phases are angles *)
Definition center_2 : Prop := forall n adj w0 K0 r th r' th', (1 <= n)%nat -> undirected adj -> no_loops adj ->
  strongly_connected n adj -> w0 <> 0 -> 0 < K0 ->
  (forall t, 0 <= t -> particles n r th (u20 n adj w0 K0 (at_time r t) (at_time th t)) t) ->
  (forall t, 0 <= t -> particles n r' th' (u20 n adj w0 K0 (at_time r' t) (at_time th' t)) t) ->
  (forall k, (k < n)%nat -> r k 0 = r' k 0 /\ expi (th k 0) = expi (th' k 0)) ->
  exists c0, ends_at n w0 r th c0 /\ ends_at n w0 r' th' c0.
(* paley.thm2.center clause 3: the centres tend to a point that does not move, and their speeds to 0 *)
Definition center_3 : Prop := forall n adj w0 K0 r th, (1 <= n)%nat -> undirected adj -> no_loops adj -> strongly_connected n adj ->
  w0 <> 0 -> 0 < K0 -> (forall t, 0 <= t -> particles n r th (u20 n adj w0 K0 (at_time r t) (at_time th t)) t) ->
  (exists c0, ends_at n w0 r th c0) /\ forall k e, (k < n)%nat -> 0 < e -> exists T, forall t, T <= t ->
    exists v, is_velocity (fun s => ck w0 (at_time r s) (at_time th s) k) t v /\ Cmod v < e.

(* fields of the fish: the sum of the unit vectors r_kj/|r_kj|, r_kj = r_k - r_j, over the neighbours; the sum of the distances to
   them from z; no neighbour is where fish k is *)
Definition hats (n : nat) (adj : graph) (r : nat -> C) (k : nat) : C :=
  Csum n (fun j => if adj k j then (r k - r j) / RtoC (Cmod (r k - r j)) else 0)%C.
Definition distances (n : nat) (adj : graph) (r : nat -> C) (k : nat) (z : C) : R := Sum n (fun j => if adj k j then Cmod (z - r j)%C else 0).
Definition clear (n : nat) (adj : graph) (r : nat -> C) (k : nat) := forall j, (j < n)%nat -> adj k j = true -> r j <> r k.
Definition rate_along n adj r k (v : C) (d : R) := is_derive (fun s => distances n adj r k (r k + RtoC s * v)%C) 0 d.
(* paley.vatt clause 1, refuted: the printed field points from a neighbour, and along it the distances grow wherever it is not zero *)
Definition vatt_1 : Prop := forall n adj r k, (k < n)%nat -> clear n adj r k -> let v := hats n adj r k in
  (forall j, (j < n)%nat -> (forall l, (l < n)%nat -> (adj k l = true <-> l = j)) -> inner v (r j - r k)%C = - Cmod (r j - r k)%C) /\
  (v <> 0%C -> exists d, 0 < d /\ rate_along n adj r k v d).
(* paley.vatt clause 2, refuted: K_att > 0 turns the heading towards the printed field: the component along the unit vectors to the
   neighbours does not rise, and falls unless the steering is zero *)
Definition turns_from (away : bool) n adj r k (v : C) (K : R) := forall (th : R -> R) t,
  let u := K * inner (Ci * expi (th t))%C v in let side := RtoC (if away then -1 else 1) in
  is_derive th t u -> exists d, is_derive (fun s => inner (expi (th s)) (side * hats n adj r k)%C) t d /\ d <= 0 /\ (u <> 0 -> d < 0).
Definition vatt_2 : Prop := forall n adj r k Katt, (k < n)%nat -> clear n adj r k -> 0 < Katt ->
  turns_from true n adj r k (hats n adj r k) Katt.
(* paley.vrep clause 1, refuted: the printed field - hats points to a neighbour, and along it the distances shrink *)
Definition vrep_1 : Prop := forall n adj r k, (k < n)%nat -> clear n adj r k -> let v := Copp (hats n adj r k) in
  (forall j, (j < n)%nat -> (forall l, (l < n)%nat -> (adj k l = true <-> l = j)) -> inner v (r j - r k)%C = Cmod (r j - r k)%C) /\
  (v <> 0%C -> exists d, d < 0 /\ rate_along n adj r k v d).
(* paley.vrep clause 2, refuted: the component along the unit vectors from the neighbours does not rise, and falls unless the
   steering is zero *)
Definition vrep_2 : Prop := forall n adj r k Krep, (k < n)%nat -> clear n adj r k -> 0 < Krep ->
  turns_from false n adj r k (Copp (hats n adj r k)) Krep.

(* ---- the theorems prove them ---- *)
From Flockproof Require Import paley_laplacian paley_gradient paley_fourier paley_particles.
From Flockproof Require paley_fish paley_behaviours.
(* velocities in an interval: unique, of equal motions equal, zero of what stays *)
Lemma velocity_unique (r : R -> C) t v v' : is_velocity r t v -> is_velocity r t v' -> v = v'.
Proof.
  intros [A B] [A' B']. apply injective_projections; [rewrite <- (is_derive_unique _ _ _ A)|rewrite <- (is_derive_unique _ _ _ B)];
  symmetry; apply is_derive_unique || (symmetry; apply is_derive_unique); assumption.
Qed.
Lemma derive_within (f g : R -> R) a b t d : a < t < b -> (forall s, a < s < b -> f s = g s) -> is_derive f t d -> is_derive g t d.
Proof.
  intros Ht E. apply is_derive_ext_loc. apply (locally_interval _ t a b); [exact (proj1 Ht)|exact (proj2 Ht)|].
  intros y A B. cbn in A, B. apply E. lra.
Qed.
Lemma velocity_within (f g : R -> C) a b t v : a < t < b -> (forall s, a < s < b -> f s = g s) -> is_velocity f t v -> is_velocity g t v.
Proof.
  intros Ht E [A B]. split; [apply (derive_within (fun s => fst (f s)) _ a b)|apply (derive_within (fun s => snd (f s)) _ a b)]; try assumption;
  intros s Hs; now rewrite (E s Hs).
Qed.
Lemma stays (f : R -> R) a b : a <= b -> (forall t, a <= t <= b -> is_derive f t 0) -> f a = f b.
Proof. intros H D. destruct (MVT_le f (fun _ => 0) a b H D) as [c [_ E]]. lra. Qed.
Lemma rests (c : R -> C) a b : a <= b -> (forall t, a <= t <= b -> is_velocity c t 0%C) -> c a = c b.
Proof.
  intros H D. apply injective_projections; [apply (stays (fun t => fst (c t)))|apply (stays (fun t => snd (c t)))]; try exact H;
  intros t Ht; apply (D t Ht).
Qed.
Lemma W12_is n adj th : W12 n adj th = W1 n adj th.
Proof. symmetry. apply W1_formula. Qed.

Lemma eq18_1_holds : eq18_1.
Proof. intros n w0 r th u t _ P k Hk. destruct (P k Hk) as [V D]. exact (paley_particles.eq18 w0 (r k) (th k) t (u k) V D). Qed.
Lemma Rball_1_holds : Rball_1.
Proof.
  intros n w0 r th Hn Hw M. set (c t := ck w0 (at_time r t) (at_time th t)). exists (mass n (c 0)). intros t Ht.
  assert (E : mass n (c 0) = mass n (c t)).
  { unfold mass. f_equal. apply Csum_ext. intros k Hk. apply (rests (fun s => c s k)); [exact Ht|]. intros s Hs.
    pose proof (eq18_1_holds n w0 r th _ s Hw (M s (proj1 Hs)) k Hk) as V. eapply velocity_eq; [exact V|]. cbv beta.
    replace (1 - / w0 * w0) with 0 by (field; exact Hw). apply Cmult_0_r. }
  replace (mass n (at_time r t) - mass n (c 0%R))%C with ((RtoC (/ w0) * - Ci) * p7 n (at_time th t))%C.
  - assert (I : Cmod Ci = 1) by (unfold Cmod; cbn; replace (0 * (0 * 1) + 1 * (1 * 1)) with 1 by ring; apply sqrt_1).
    rewrite !Cmod_mult, Cmod_opp, I, Cmod_R, Rabs_inv. pose proof (proj2 (order_bounds n (at_time th t) Hn)) as B. change (order n (at_time th t)) with (p7 n (at_time th t)) in B.
    assert (A : 0 < / Rabs w0) by (apply Rinv_0_lt_compat; now apply Rabs_pos_lt). nra.
  - rewrite E. unfold mass, c, ck, p7. rewrite Csum_plus, !Csum_scal. ring.
Qed.
Lemma beacon_is n c0 c : beacon n c0 c = paley_fish.beacon n c c0.
Proof. unfold beacon, paley_fish.beacon. f_equal. apply Sum_ext. intros k _. symmetry. apply dist2_Cmod. Qed.
Lemma beacon_1_holds : beacon_1.
Proof. intros n c0 c Hn. rewrite beacon_is. exact (paley_fish.beacon_zero n c c0 Hn). Qed.
(* at right angles to a turning direction over an interval: zero *)
Lemma turning_zero (w0 : R) (ph : R -> R) z a b : a < b -> w0 <> 0 -> (forall t, a < t < b -> is_derive ph t w0) ->
  (forall t, a < t < b -> inner (expi (ph t)) z = 0) -> z = 0%C.
Proof.
  intros L W D Z. set (t := (a + b) / 2). assert (Ht : a < t < b) by (unfold t; lra).
  assert (V : is_derive (fun s => inner (expi (ph s)) z) t (inner (RtoC w0 * (Ci * expi (ph t)))%C z + inner (expi (ph t)) 0%C)).
  { apply (D_inner (fun s => expi (ph s)) (fun _ => z)); [now apply velocity_expi, D|]. split; apply D_const. }
  assert (O : is_derive (fun s => inner (expi (ph s)) z) t 0).
  { apply (derive_within (fun _ => 0) _ a b t); [exact Ht| |apply D_const]. intros s Hs. symmetry. now apply Z. }
  apply is_derive_unique in V, O. rewrite O in V. specialize (Z t Ht). apply inner_self_0. rewrite inner_xy in *. rewrite inner_xy in V. cbn in *.
  pose proof (sc2 (ph t)) as U. destruct z as [x y]. cbn in *.
  assert (J : cos (ph t) * y - sin (ph t) * x = 0).
  { apply (Rmult_eq_reg_l w0); [|exact W]. lra. }
  set (p := cos (ph t)) in *. set (q := sin (ph t)) in *.
  transitivity ((p * x + q * y) * (p * x + q * y) + (p * y - q * x) * (p * y - q * x)); [|rewrite Z, J; ring].
  transitivity ((q * (q * 1) + p * (p * 1)) * (x * x + y * y)); [rewrite U; ring|ring].
Qed.
Lemma beacon_2_holds : beacon_2.
Proof.
  intros n w0 K c0 r th Hn Hw HK M P s t Hst. pose proof (INR_pos n Hn) as Np.
  set (a k x := inner (expi (th k x)) (ck w0 (at_time r x) (at_time th x) k - c0)%C).
  set (rate x := - (K / INR n) * Sum n (fun k => a k x ^ 2)).
  assert (D : forall x, 0 <= x -> is_derive P x (rate x)).
  { intros x Hx. eapply D_eq.
    - apply (is_derive_ext (fun x => paley_fish.beacon n (fun k => circle_centre w0 (r k x) (th k x)) c0)); [intros y; symmetry; apply beacon_is|].
      apply (paley_fish.beacon_rate n w0 (K * INR n) c0 r th x Hn Hw); [intros k Hk; apply (M x Hx k Hk)|].
      intros k Hk. eapply D_eq; [apply (M x Hx k Hk)|]. unfold ck, circle_centre. field. lra.
    - unfold rate. match goal with |- ?p * ?q = ?p' * ?q' => change q with q' end. field. lra. }
  assert (N : forall x, rate x <= 0).
  { intros x. unfold rate. pose proof (Sum_ge0 n (fun k => a k x ^ 2) ltac:(intros; apply pow2_ge_0)).
    assert (0 < K / INR n) by now apply Rdiv_lt_0_compat. nra. }
  assert (Mono : forall x y, 0 <= x <= y -> P y <= P x) by (intros x y H; apply (decreasing P rate); [lra| |]; intros; [apply D; lra|apply N]).
  assert (L : P t <= P s) by (apply Mono; lra). split; [exact L|]. intros NZ. apply Rnot_le_lt. intros G. apply NZ.
  (* P is constant from s to t *)
  assert (Z : forall x k, s < x < t -> (k < n)%nat -> a k x = 0).
  { intros x k Hx Hk. assert (D0 : is_derive P x 0).
    { apply (derive_within (fun _ => P s) _ s t x 0 Hx); [|apply D_const]. intros y Hy. pose proof (Mono s y ltac:(lra)). pose proof (Mono y t ltac:(lra)). lra. }
    apply is_derive_unique in D0. pose proof (is_derive_unique _ _ _ (D x ltac:(lra))) as E. rewrite E in D0. unfold rate in D0.
    assert (F : 0 < K / INR n) by now apply Rdiv_lt_0_compat.
    assert (S0 : Sum n (fun k => a k x ^ 2) = 0) by nra.
    pose proof (Sum_eq0 n (fun k => a k x ^ 2) (fun _ _ => pow2_ge_0 _) S0 k Hk) as Q. cbv beta in Q. nra. }
  assert (W : forall x k, s < x < t -> (k < n)%nat -> is_derive (th k) x w0).
  { intros x k Hx Hk. eapply D_eq; [apply (M x ltac:(lra) k Hk)|]. cbv beta. fold (a k x). rewrite (Z x k Hx Hk). ring. }
  set (m := (s + t) / 2). assert (Hm : s < m < t) by (unfold m; lra).
  assert (Eq : P s = P m) by (pose proof (Mono s m ltac:(lra)); pose proof (Mono m t ltac:(lra)); lra).
  rewrite Eq. unfold P. apply beacon_1_holds; [exact Hn|]. intros k Hk.
  assert (Rest : forall x y, s < x < t -> s < y < t -> ck w0 (at_time r x) (at_time th x) k = ck w0 (at_time r y) (at_time th y) k).
  { assert (O : forall x y, s < x -> x <= y -> y < t -> ck w0 (at_time r x) (at_time th x) k = ck w0 (at_time r y) (at_time th y) k).
    { intros x y H1 H2 H3. apply (rests (fun x => ck w0 (at_time r x) (at_time th x) k)); [exact H2|]. intros z Hz.
      eapply velocity_eq; [apply (eq18 w0 (r k) (th k) z w0); [apply (M z ltac:(lra) k Hk)|apply W; [lra|exact Hk]]|].
      replace (1 - / w0 * w0) with 0 by (field; exact Hw). apply Cmult_0_r. }
    intros x y Hx Hy. destruct (Rle_lt_dec x y); [apply O|symmetry; apply O]; lra. }
  assert (X : (ck w0 (at_time r m) (at_time th m) k - c0)%C = 0%C).
  { apply (turning_zero w0 (th k) _ s t ltac:(lra) Hw); [intros x Hx; now apply W|]. intros x Hx.
    rewrite <- (Z x k Hx Hk). unfold a. rewrite (Rest x m Hx Hm). reflexivity. }
  rewrite <- (Cplus_0_r c0), <- X. ring.
Qed.
Lemma cos_ring M d : (1 <= d < M)%nat -> cos (INR d * (2 * PI / INR M)) <= cos (2 * PI / INR M).
Proof.
  intros Hd. pose proof PI_RGT_0 as P. assert (M2 : 2 <= INR M) by (apply (le_INR 2); lia).
  assert (D1 : 1 <= INR d) by (apply (le_INR 1); lia). assert (D2 : INR d + 1 <= INR M) by (rewrite <- S_INR; apply le_INR; lia).
  set (q := 2 * PI / INR M). assert (E : INR M * q = 2 * PI) by (unfold q; field; lra).
  assert (q0 : 0 < q) by (unfold q; apply Rdiv_lt_0_compat; lra).
  assert (A : q <= PI). { apply (Rmult_le_compat_r q) in M2; lra. }
  assert (B1 : 1 * q <= INR d * q) by (apply Rmult_le_compat_r; lra). assert (B2 : (INR d + 1) * q <= INR M * q) by (apply Rmult_le_compat_r; lra).
  destruct (Rle_lt_dec (INR d * q) PI) as [L|L]; [apply cos_decr_1; lra|].
  rewrite <- (cos_neg (INR d * q)). replace (- (INR d * q)) with (2 * PI - INR d * q - 2 * INR 1 * PI) by (cbn; ring).
  rewrite <- (cos_period (2 * PI - INR d * q - 2 * INR 1 * PI) 1). replace (2 * PI - INR d * q - 2 * INR 1 * PI + 2 * INR 1 * PI) with (2 * PI - INR d * q) by ring.
  apply cos_decr_1; lra.
Qed.
Lemma chord_1_holds : chord_1.
Proof.
  intros M a HM rho cluster. pose proof (INR_pos M HM) as P.
  assert (F : forall l, Cmod (cluster (S l) - cluster l)%C = rho).
  { intros l. unfold rho. rewrite <- (paley_fish.chord M HM). unfold cluster.
    replace (a + 2 * PI * INR (S l) / INR M) with (a + 2 * PI * INR l / INR M + 2 * PI / INR M) by (rewrite S_INR; field; lra).
    set (b := a + 2 * PI * INR l / INR M). rewrite expi_plus.
    replace (expi b * expi (2 * PI / INR M) - expi b)%C with (expi b * (expi (2 * PI / INR M) - expi 0))%C by (rewrite expi_0; ring).
    rewrite Cmod_mult, Cmod_expi. ring. }
  split; [exact F|]. intros l l' Hl Hl' N.
  assert (R : rho ^ 2 = 2 * (1 - cos (2 * PI / INR M))).
  { rewrite <- (F 0%nat). unfold cluster. rewrite chord. do 3 f_equal. rewrite S_INR. cbn [INR]. field. lra. }
  assert (C : Cmod (cluster l - cluster l')%C ^ 2 = 2 * (1 - cos (INR (Nat.max l l' - Nat.min l l') * (2 * PI / INR M)))).
  { unfold cluster. rewrite chord. f_equal. f_equal. destruct (Nat.le_gt_cases l l').
    - rewrite Nat.max_r, Nat.min_l by lia. rewrite minus_INR by lia. rewrite <- (cos_neg (_ * _)). f_equal. field. lra.
    - rewrite Nat.max_l, Nat.min_r by lia. rewrite minus_INR by lia. f_equal. field. lra. }
  pose proof (cos_ring M (Nat.max l l' - Nat.min l l') ltac:(lia)) as L. pose proof (Cmod_ge_0 (cluster l - cluster l')%C) as G.
  apply Rnot_lt_le. intros H. assert (Cmod (cluster l - cluster l')%C ^ 2 < rho ^ 2) by nra. lra.
Qed.
Lemma energy_1_holds : energy_1.
Proof.
  intros n r th u a b M k v Hk V t Ht. assert (E : forall s, a < s < b -> v s = expi (th k s)).
  { intros s Hs. exact (velocity_unique _ _ _ _ (V s Hs) (proj1 (M s Hs k Hk))). }
  rewrite (E t Ht). apply (velocity_within (fun s => expi (th k s)) v a b t); [exact Ht|intros s Hs; symmetry; now apply E|].
  apply (energy (th k) t (u t k)), (M t Ht k Hk).
Qed.
Lemma energy_2_holds : energy_2.
Proof.
  intros n r th u a b M v V. assert (E : forall k s, (k < n)%nat -> a < s < b -> v k s = expi (th k s)).
  { intros k s Hk Hs. exact (velocity_unique _ _ _ _ (V k s Hk Hs) (proj1 (M s Hs k Hk))). }
  split.
  - intros k t Hk Ht. exists (RtoC (u t k) * (Ci * v k t))%C. split; [apply (energy_1_holds n r th u a b M k (v k) Hk (fun s => V k s Hk) t Ht)|].
    rewrite (E k t Hk Ht). destruct (energy (th k) t (u t k) (proj2 (M t Ht k Hk))) as [_ [A B]]. split; [|exact B].
    apply (derive_within (fun s => / 2 * Cmod (expi (th k s)) ^ 2) _ a b t); [exact Ht| |exact A].
    intros s Hs. rewrite (E k s Hk Hs). field.
  - intros s t Hs Ht. apply Sum_ext. intros k Hk. now rewrite (E k s Hk Hs), (E k t Hk Ht), !Cmod_expi.
Qed.
Lemma eq22_1_holds : eq22_1.
Proof.
  intros n adj w0 K0 K1 r th k Hn _ Hw. unfold spac20, ori14, u22.
  pose proof (paley_particles.eq22 n adj w0 K0 K1 Hn Hw (fun k _ => r k) (fun k _ => th k) 0 k) as E.
  etransitivity; [|exact E]. unfold control5. change (gW n adj (fun i => th i) k) with (Lth n adj th k).
  change (aS n adj w0 (fun i => r i) (fun l => th l) k) with (Lc n adj w0 r th k). ring.
Qed.
Lemma eq29_1_holds : eq29_1.
Proof.
  intros n ori att w0 K0 K1 Hw HK [k [j [Hk [Hj [N A]]]]]. assert (Hn : (1 <= n)%nat) by lia. pose proof (INR_pos n Hn) as P.
  set (th := fun i => if Nat.eqb i j then PI / 2 else 0). exists th, k. split; [exact Hk|]. intros r E. apply A.
  pose proof (eq29_corrected n ori att w0 K0 K1 r th k Hn Hw) as C. unfold control5_two in C.
  change (gW n ori th k) with (Lth n ori th k) in C. change (gW n att th k) with (Lth n att th k) in C.
  change (aS n att w0 r th k) with (Lc n att w0 r th k) in C. change (row n (lap n att) k r) with (Csum n (fun i => RtoC (lap n att k i) * r i))%C in C.
  assert (L : forall adj, Lth n adj th k = - w adj k j).
  { intros adj. change (Lth n adj th k) with (gW n adj th k). rewrite (gW_sines n adj th k Hk).
    rewrite (Sum_ext n _ (fun i => delta i j * - w adj k i)); [apply (Sum_delta n j (fun i => - w adj k i) Hj)|]. intros i _.
    unfold th, delta. destruct (Nat.eqb_spec k j) as [->|_]; [now contradict N|]. destruct (Nat.eqb i j).
    - rewrite Rminus_0_l, sin_neg, sin_PI2. ring.
    - rewrite Rminus_0_r, sin_0. ring. }
  unfold printed29, spac20, ori14 in E. rewrite !L in *.
  assert (X : K0 / INR n * (w ori k j - w att k j) = 0) by lra.
  apply Rmult_integral in X as [X|X].
  - exfalso. assert (0 < / INR n) by now apply Rinv_0_lt_compat. unfold Rdiv in X. apply Rmult_integral in X as [X|X]; lra.
  - unfold w in X. destruct (ori k j), (att k j); trivial; lra.
Qed.
Lemma eq7_1_holds : eq7_1.
Proof. intros n th Hn. apply (eq7 n th Hn). Qed.
Lemma eq7_2_holds : eq7_2.
Proof. intros n th Hn S. exact (proj2 (proj2 (proj1 (eq7 n th Hn))) S). Qed.
Lemma eq7_3_holds : eq7_3.
Proof. intros n r th u t Hn M. apply (eq7 n (at_time th t) Hn). intros k Hk. apply (M k Hk). Qed.
Lemma eq7_4_holds : eq7_4.
Proof.
  intros n r th u a b Hn M. assert (V : forall t, a < t < b -> is_velocity (fun s => mass n (at_time r s)) t (p7 n (at_time th t))).
  { intros t Ht. exact (eq7_3_holds n r th (u t) t Hn (M t Ht)). }
  split; [|split].
  - intros t Ht. apply (eq7 n (at_time th t) Hn). intros k Hk. apply (M t Ht k Hk).
  - intros Z. assert (O : forall s t, a < s -> s <= t -> t < b -> mass n (at_time r s) = mass n (at_time r t)).
    { intros s t H1 H2 H3. apply (rests (fun s => mass n (at_time r s)) s t H2). intros x Hx. eapply velocity_eq; [apply V; lra|]. apply Z. lra. }
    intros s t Hs Ht. destruct (Rle_lt_dec s t); [apply O|symmetry; apply O]; lra.
  - intros E t Ht. apply (velocity_unique (fun s => mass n (at_time r s)) t); [now apply V|].
    apply (velocity_within (fun _ => mass n (at_time r t)) _ a b t); [exact Ht|intros s Hs; now apply E|]. split; apply D_const.
Qed.
Lemma fish_zero_1_holds : fish_zero_1.
Proof. intros n adj th Hn. rewrite W12_is. apply (fish_zero n adj th Hn). Qed.
Lemma fish_zero_2_holds : fish_zero_2.
Proof. intros n adj th Hn S. rewrite W12_is. now apply (fish_zero n adj th Hn). Qed.
Lemma fish_zero_3_holds : fish_zero_3.
Proof.
  intros n adj th S Hn Z Con j k Hj Hk. rewrite W12_is in Z. apply (fish_zero n adj th Hn); [exact Z|]. specialize (Con j k Hj Hk). clear Hj Hk.
  induction Con as [x y [_ [_ A]]|x|x y _ IH|x y z _ IH1 _ IH2]; [now apply rst_step|apply rst_refl|now apply rst_sym|exact (rst_trans _ _ _ y _ IH1 IH2)].
Qed.
Lemma fish28_1_holds : fish28_1.
Proof. intros n adj K0 K1 Kori th k Hn _ E. exact (paley_fish.fish28_alignment n adj K0 K1 Kori th k Hn E). Qed.
(* networks of the nearest neighbours *)
Lemma nearest_is n q r adj : paley_fish.nearest n q adj r -> nearest n q r adj.
Proof. intros H k Hk. destruct (H k Hk) as [A [B D]]. split; [exact A|]. split; [exact B|]. intros j l Hj Hl. now apply D. Qed.
Lemma nearest_all N r adj : (1 <= N)%nat -> nearest N (N - 1) r adj -> forall j k, (j < N)%nat -> (k < N)%nat -> adj k j = negb (Nat.eqb k j).
Proof.
  intros HN H j k Hj Hk. destruct (H k Hk) as [A [B _]]. destruct (Nat.eqb_spec k j) as [<-|E]; [exact A|]. cbn [negb].
  assert (P : forall i, (i < N)%nat -> 0 <= 1 - w adj k i - delta k i * 1).
  { intros i _. unfold w, delta. destruct (Nat.eqb_spec k i) as [<-|_]; [rewrite A|destruct (adj k i)]; lra. }
  assert (Z : Sum N (fun i => 1 - w adj k i - delta k i * 1) = 0).
  { rewrite (Sum_minus N (fun i => 1 - w adj k i)), (Sum_minus N (fun _ => 1)), Sum_const, (Sum_delta_l N k (fun _ => 1) Hk).
    change (Sum N (w adj k)) with (deg N adj k). rewrite B, minus_INR by lia. cbn. ring. }
  pose proof (Sum_eq0 N _ P Z j Hj) as Q. cbv beta in Q. unfold w in Q. rewrite (delta_neq k j E) in Q. destruct (adj k j); [reflexivity|lra].
Qed.
Lemma W1_same n adj adj' th : (forall j k, (j < n)%nat -> (k < n)%nat -> adj k j = adj' k j) -> W1 n adj th = W1 n adj' th.
Proof.
  intros E. rewrite !W1_arcs. f_equal. apply Sum_ext. intros k Hk. apply Sum_ext. intros j Hj. unfold w. now rewrite (E j k Hj Hk).
Qed.
Lemma fishpeak_1_holds : fishpeak_1.
Proof.
  intros r adj th m a H Hm E. rewrite W12_is, (W1_same 4 adj complete th (nearest_all 4 r adj ltac:(lia) H)).
  pose proof (paley_fish.scale_complete_corrected 4 th ltac:(lia)) as Q. change (INR (4 - 1)) with (INR 3) in Q. rewrite Q.
  assert (O : order 4 th = (RtoC (1 / 2) * expi a)%C).
  { assert (Op : expi (a + PI) = (- expi a)%C) by (unfold expi; rewrite neg_cos, neg_sin; reflexivity).
    unfold order, phasors. rewrite !Csum_S. rewrite (E 0%nat), (E 1%nat), (E 2%nat), (E 3%nat) by lia.
    assert (I : INR 4 = 4) by (cbn; ring). rewrite I.
    destruct m as [|[|[|[|m]]]]; [..|lia]; cbn [Nat.eqb]; rewrite Op; unfold Csum; apply injective_projections; cbn; field. }
  rewrite O, Cmod_mult, Cmod_expi, Cmod_R, Rabs_pos_eq by lra. lra.
Qed.
Lemma scale_1_holds : scale_1.
Proof.
  destruct paley_fish.scale_printed_fails as [A B]. split; intros H; [apply B|apply A]; intros N n adj r th Hn Q; rewrite <- W12_is;
  exact (proj2 (H N n r adj th Hn (nearest_is _ _ _ _ Q))).
Qed.
Lemma scale_2_holds : scale_2.
Proof.
  intros N r adj th HN H. rewrite W12_is. assert (D : forall k, (k < N)%nat -> deg N adj k = 1) by (intros k Hk; apply (H k Hk)).
  pose proof (paley_fish.W1_le_degree N adj th 1 ltac:(lia) D). cbn. lra.
Qed.
Lemma scale_4_holds : scale_4.
Proof.
  intros z s Hs corner opposed. split.
  - exists (ring_graph 4), paley_fish.alternating. split.
    + intros k Hk. destruct (paley_fish.square_nearest k Hk) as [A [B _]]. split; [exact A|]. split; [exact B|]. intros j l Hj Hl N T F.
      assert (E : forall i, (i < 4)%nat -> expi (INR i * (PI / 2)) = match i with 0%nat => (1, 0) | 1%nat => (0, 1) | 2%nat => (-1, 0) | _ => (0, -1) end).
      { intros [|[|[|[|i]]]] Hi; [..|lia]; unfold expi; cbn [INR].
        - now rewrite Rmult_0_l, cos_0, sin_0.
        - now rewrite Rmult_1_l, cos_PI2, sin_PI2.
        - replace ((1 + 1) * (PI / 2)) with PI by field. now rewrite cos_PI, sin_PI.
        - replace ((1 + 1 + 1) * (PI / 2)) with (3 * (PI / 2)) by ring. now rewrite cos_3PI2, sin_3PI2. }
      assert (D : forall i, (corner i - corner k)%C = (s * (expi (INR i * (PI / 2)) - expi (INR k * (PI / 2))))%C) by (intros i; unfold corner; ring).
      rewrite !D, !Cmod_mult. apply Rmult_le_compat_l; [apply Cmod_ge_0|]. apply Rsqr_incr_0; try apply Cmod_ge_0.
      rewrite !Rsqr_pow2, <- !dist2_Cmod, !dist2_xy, (E j Hj), (E k Hk), (E l Hl).
      destruct k as [|[|[|[|]]]]; try lia; destruct j as [|[|[|[|]]]]; try lia; try discriminate T;
      destruct l as [|[|[|[|]]]]; try lia; try discriminate F; cbn; lra.
    + assert (Op : forall a b, a - b = PI \/ b - a = PI -> expi a = Copp (expi b)).
      { intros a b [X|X]; [replace a with (b + PI) by lra|replace b with (a + PI) by lra]; unfold expi; rewrite neg_cos, neg_sin; apply injective_projections; cbn; ring. }
      intros k j Hk Hj A. apply Op. unfold paley_fish.alternating.
      destruct k as [|[|[|[|]]]]; try lia; destruct j as [|[|[|[|]]]]; try lia; try discriminate A; cbn [Nat.even]; lra.
  - intros adj th Nr Op. rewrite W12_is, W1_arcs.
    rewrite (Sum_ext 4 _ (fun _ => 2 * 2)); [rewrite Sum_const; cbn; field|]. intros k Hk. destruct (Nr k Hk) as [_ [D _]].
    rewrite (Sum_ext 4 _ (fun j => 2 * w adj k j)); [rewrite Sum_scal; change (Sum 4 (w adj k)) with (deg 4 adj k); rewrite D; cbn; ring|].
    intros j Hj. unfold w. destruct (adj k j) eqn:A; [|ring]. rewrite <- inner_expi, (Op k j Hk Hj A).
    rewrite inner_xy. cbn. pose proof (sc2 (th k)). cbn in *. lra.
Qed.
Lemma complete_1_holds : complete_1.
Proof.
  intros N r adj HN H. pose proof (nearest_all N r adj ltac:(lia) H) as E. split; [exact E|]. intros th NS. rewrite W12_is, (W1_same N adj complete th E).
  apply (paley_fish.scale_complete_printed_fails N th HN). intros O. now apply NS, (order_one N th ltac:(lia)).
Qed.
Lemma edges_is n adj x : edges n adj x = total n adj x.
Proof.
  apply Sum_ext. intros k _. apply Sum_ext. intros j _. unfold w. destruct (adj k j); [|ring]. rewrite <- dist2_Cmod, !dist2_xy. ring.
Qed.
Lemma length_2_holds : length_2.
Proof. intros n adj x Hn S. rewrite edges_is. exact (Q_total n adj x Hn S). Qed.
Lemma length_1_holds : length_1.
Proof.
  intros n adj x S [j [k [A N]]] E. assert (Hn : (1 <= n)%nat) by (destruct A; lia). pose proof (INR_pos n Hn) as P.
  rewrite (length_2_holds n adj x Hn S), edges_is in E. apply N, (proj1 (total_0 n adj x)); [|exact A].
  assert (U : 0 < / (4 * INR n)) by (apply Rinv_0_lt_compat; lra).
  replace (/ (2 * INR n)) with (2 * / (4 * INR n)) in E by (field; lra). nra.
Qed.
Lemma ref_1_holds : ref_1.
Proof.
  intros n adj th0 th Hn F led. assert (P : forall ph, 0 <= F ph).
  { intros ph. unfold F. rewrite W12_is. exact (proj1 (paley_fish.reference n adj th0 ph Hn)). } split.
  - intros L th'. apply Rle_trans with 0; [|apply P]. right. unfold F. rewrite fish_zero_2_holds; [|exact Hn|intros j k Hj Hk; now rewrite (L j Hj), (L k Hk)].
    rewrite (proj1 (expi_eq_cos th0 (th (n - 1)%nat))); [ring|]. symmetry. apply L. lia.
  - intros SC M k Hk. specialize (M (fun _ => th0)). pose proof (proj2 (paley_fish.reference n adj th0 th Hn)) as Z. unfold F in M. rewrite (W12_is n adj th), (W12_is n adj (fun _ => th0)) in M.
    pose proof (W1_ge0 n adj th Hn). pose proof (COS_bound (th0 - th (n - 1)%nat)).
    transitivity (expi (th (n - 1)%nat)); [apply (W1_strongly n adj th Hn SC); [lra|exact Hk|lia]|]. symmetry. apply expi_eq_cos. lra.
Qed.
Lemma center_1_holds : center_1.
Proof.
  intros n adj w0 K0 r th Hn S _ SC Hw HK M Z. pose proof (INR_pos n Hn) as P.
  set (c t := ck w0 (at_time r t) (at_time th t)).
  assert (A : forall k t, (k < n)%nat -> 0 <= t -> Lc n adj w0 (at_time r t) (at_time th t) k = 0).
  { intros k t Hk Ht. destruct (eq20_proved n adj w0 K0 r th t Hn S Hw (M t Ht)) as [D _]. pose proof (is_derive_unique _ _ _ (Z t Ht)) as E.
    rewrite (is_derive_unique _ _ _ D) in E. assert (F : 0 < K0 / INR n ^ 2) by (apply Rdiv_lt_0_compat; [lra|nra]).
    assert (T : Sum n (fun k => Lc n adj w0 (at_time r t) (at_time th t) k ^ 2) = 0) by nra.
    pose proof (Sum_eq0 n _ (fun _ _ => pow2_ge_0 _) T k Hk) as Q. cbv beta in Q. nra. }
  assert (W : forall k t, (k < n)%nat -> 0 <= t -> is_derive (th k) t w0).
  { intros k t Hk Ht. eapply D_eq; [apply (M t Ht k Hk)|]. unfold u20. rewrite (A k t Hk Ht). ring. }
  assert (C : forall k t, (k < n)%nat -> 0 <= t -> c 0 k = c t k).
  { intros k t Hk Ht. apply (rests (fun s => c s k)); [exact Ht|]. intros s Hs.
    eapply velocity_eq; [apply (eq18 w0 (r k) (th k) s w0); [apply (M s ltac:(lra) k Hk)|apply W; [exact Hk|lra]]|].
    replace (1 - / w0 * w0) with 0 by (field; exact Hw). apply Cmult_0_r. }
  assert (K : forall k, (k < n)%nat -> apply_L n adj (c 0) k = 0%C).
  { intros k Hk. apply (turning_zero w0 (th k) _ 0 1 ltac:(lra) Hw); [intros t Ht; apply W; [exact Hk|lra]|]. intros t Ht.
    etransitivity; [|exact (A k t Hk (Rlt_le _ _ (proj1 Ht)))]. unfold Lc, apply_L. f_equal. apply Csum_ext. intros j Hj.
    exact (f_equal (Cmult (RtoC (lap n adj k j))) (C j t Hj (Rlt_le _ _ (proj1 Ht)))). }
  assert (Q0 : Q n (lap n adj) (c 0) = 0).
  { unfold Q. rewrite Sum_zero; [ring|]. intros k Hk. change (row n (lap n adj) k (c 0)) with (apply_L n adj (c 0) k). rewrite (K k Hk), inner_xy. cbn. ring. }
  apply (Q_kernel n adj (c 0) Hn S SC) in Q0. destruct Q0 as [c0 H]. exists c0. intros k t Hk Ht. split; [now apply W|].
  change (c t k = c0). rewrite <- (C k t Hk Ht). now apply H.
Qed.
Lemma center_2_holds : center_2.
Proof.
  intros n adj w0 K0 r th r' th' Hn S NL SC Hw HK M M' E.
  destruct (thm2_1_proved n adj w0 K0 r th Hn S NL SC Hw HK M) as [c0 H]. destruct (thm2_1_proved n adj w0 K0 r' th' Hn S NL SC Hw HK M') as [c0' H'].
  assert (T : ends_at n w0 r th c0). { intros k Hk e He. destruct (H k Hk e He) as [X Y]. exists X. intros t Ht. apply (Y t Ht). }
  assert (T' : ends_at n w0 r' th' c0'). { intros k Hk e He. destruct (H' k Hk e He) as [X Y]. exists X. intros t Ht. apply (Y t Ht). }
  exists c0. split; [exact T|]. rewrite (thm2_2_proved n adj w0 K0 r th r' th' c0 c0' Hn S NL SC Hw HK M M' E T T'). exact T'.
Qed.
Lemma center_3_holds : center_3.
Proof.
  intros n adj w0 K0 r th Hn S NL SC Hw HK M. destruct (thm2_1_proved n adj w0 K0 r th Hn S NL SC Hw HK M) as [c0 H]. split.
  - exists c0. intros k Hk e He. destruct (H k Hk e He) as [X Y]. exists X. intros t Ht. apply (Y t Ht).
  - intros k e Hk He. assert (W : 0 < Rabs w0) by now apply Rabs_pos_lt. destruct (H k Hk (e * Rabs w0) ltac:(nra)) as [X Y].
    exists (Rmax 0 X). intros t Ht. pose proof (Rmax_l 0 X). pose proof (Rmax_r 0 X). destruct (Y t ltac:(lra)) as [_ L].
    eexists. split; [exact (eq18_1_holds n w0 r th _ t Hw (M t ltac:(lra)) k Hk)|]. set (u := u20 _ _ _ _ _ _ k) in *.
    rewrite Cmod_mult, Cmod_expi, Cmod_R, Rmult_1_l. replace (1 - / w0 * u) with (- (/ w0 * (u - w0))) by (field; exact Hw).
    rewrite Rabs_Ropp, Rabs_mult, Rabs_inv. apply Rmult_lt_reg_l with (Rabs w0); [exact W|]. rewrite <- Rmult_assoc, Rinv_r by lra. lra.
Qed.
(* the fields of the fish *)
Lemma hats_is n adj r k : clear n adj r k -> hats n adj r k = paley_behaviours.outward n (adj k) r k.
Proof.
  intros Cl. apply Csum_ext. intros j Hj. destruct (adj k j) eqn:A; [|ring]. unfold paley_fish.unit_from, Cdiv.
  rewrite RtoC_inv; [ring|]. intros Z. apply Cmod_eq_0 in Z. apply (Cl j Hj A). rewrite <- (Cplus_0_r (r j)), <- Z. ring.
Qed.
Lemma rate_is n adj r k v : clear n adj r k -> rate_along n adj r k v (inner v (hats n adj r k)).
Proof.
  intros Cl. rewrite (hats_is n adj r k Cl).
  apply (is_derive_ext (paley_behaviours.distances n (adj k) r k v)); [|exact (paley_behaviours.distances_rate n (adj k) r k v Cl)].
  intros s. apply Sum_ext. intros j _. destruct (adj k j); ring.
Qed.
Lemma hats_one n adj r k j : clear n adj r k -> (j < n)%nat -> (forall l, (l < n)%nat -> (adj k l = true <-> l = j)) ->
  inner (hats n adj r k) (r j - r k)%C = - Cmod (r j - r k)%C.
Proof.
  intros Cl Hj One. rewrite (hats_is n adj r k Cl), inner_sym. unfold paley_behaviours.outward. rewrite inner_Csum.
  assert (N : r k <> r j) by (intros E; now apply (Cl j Hj (proj2 (One j Hj) eq_refl))).
  rewrite (Sum_ext n _ (fun l => delta l j * inner (r j - r k)%C (paley_fish.unit_from (r k) (r l)))).
  - rewrite (Sum_delta n j _ Hj), inner_sym. pose proof (paley_fish.unit_from_inner (r k) (r j) N) as U.
    replace (r j - r k)%C with (- (r k - r j))%C by ring. rewrite Cmod_opp, <- U, !inner_xy. cbn. ring.
  - intros l Hl. rewrite inner_scal. f_equal. unfold delta. specialize (One l Hl).
    destruct (Nat.eqb_spec l j) as [E|E]; destruct (adj k l); try reflexivity; exfalso; [|apply E, One; reflexivity].
    apply One in E. discriminate.
Qed.
Lemma inner_opp v x : inner (Copp v) x = - inner v x.
Proof. rewrite !inner_xy. cbn. ring. Qed.
Lemma inner_pos (v : C) : v <> 0%C -> 0 < inner v v.
Proof. intros N. destruct (Rle_lt_or_eq_dec _ _ (inner_self_ge0 v)) as [L|E]; [exact L|]. exfalso. now apply N, inner_self_0. Qed.
Lemma vatt_1_holds : vatt_1.
Proof.
  intros n adj r k _ Cl v. split; [intros j Hj One; exact (hats_one n adj r k j Cl Hj One)|].
  intros N. exists (inner v v). split; [now apply inner_pos|]. exact (rate_is n adj r k v Cl).
Qed.
Lemma vrep_1_holds : vrep_1.
Proof.
  intros n adj r k _ Cl v. split.
  - intros j Hj One. unfold v. rewrite inner_opp, (hats_one n adj r k j Cl Hj One). ring.
  - intros N. exists (- inner v v). split; [pose proof (inner_pos v N); lra|]. pose proof (rate_is n adj r k v Cl) as D.
    replace (- inner v v) with (inner v (hats n adj r k)); [exact D|]. unfold v. rewrite !inner_xy. cbn. ring.
Qed.
Lemma turns_down n adj r k K away : 0 < K -> turns_from away n adj r k (RtoC (if away then 1 else -1) * hats n adj r k)%C K.
Proof.
  intros HK th t u side D. set (v := (RtoC (if away then 1 else -1) * hats n adj r k)%C) in *. exists (- (K * inner (Ci * expi (th t))%C v ^ 2)). split; [|split].
  - apply (is_derive_ext (fun s => - inner (expi (th s)) v)); [|apply D_opp, paley_behaviours.turning; exact D].
    intros s. unfold v, side. rewrite !inner_scal. destruct away; Rring.
  - pose proof (pow2_ge_0 (inner (Ci * expi (th t))%C v)). nra.
  - intros N. assert (X : inner (Ci * expi (th t))%C v <> 0) by (intros X; apply N; unfold u; rewrite X; ring).
    pose proof (pow2_gt_0 _ X). nra.
Qed.
Lemma vatt_2_holds : vatt_2.
Proof. intros n adj r k K _ _ HK. pose proof (turns_down n adj r k K true HK) as T. cbv iota in T. rewrite Cmult_1_l in T. exact T. Qed.
Lemma vrep_2_holds : vrep_2.
Proof.
  intros n adj r k K _ _ HK. pose proof (turns_down n adj r k K false HK) as T. cbv iota in T.
  replace (RtoC (-1) * hats n adj r k)%C with (Copp (hats n adj r k)) in T by (apply injective_projections; cbn; ring). exact T.
Qed.

(* ---- corrected clauses, and Theorem 2: formalised from their words ---- *)
(* paley.Wm clause 2; W_m is Q_L of e^{i m th}/m, U_m is (N/2)|p_m|^2 with p_m of (23) *)
Definition Wm_2 : Prop := forall n adj m th, (1 <= n)%nat -> (1 <= m)%nat ->
  (forall k j, (k < n)%nat -> (j < n)%nat -> adj k j = negb (Nat.eqb k j)) ->
  QL n adj (fun k => RtoC (/ INR m) * expi (INR m * th k))%C =
  INR n / (2 * INR m ^ 2) - INR n / 2 * Cmod (RtoC (/ (INR m * INR n)) * Csum n (fun k => expi (INR m * th k)))%C ^ 2.
(* paley.eq29 clause 2; on any two graphs, directed ones included *)
Definition right29 n (ori att : graph) w0 K0 K1 (r : nat -> C) th k :=
  w0 + K1 / INR n * inner (Ci * expi (th k))%C (Csum n (fun j => RtoC (lap n ori k j) * expi (th j)))%C
  - K0 / INR n * inner (Ci * expi (th k))%C (Csum n (fun j => RtoC (lap n att k j) * expi (th j)))%C
  + w0 * (K0 / INR n) * inner (expi (th k)) (Csum n (fun j => RtoC (lap n att k j) * r j))%C.
Definition eq29_2 : Prop := forall n ori att w0 K0 K1 r th k, (1 <= n)%nat -> (k < n)%nat -> w0 <> 0 ->
  right29 n ori att w0 K0 K1 r th k = w0 + spac20 n att w0 K0 r th k + ori14 n ori K1 th k.
(* paley.fig2.caption clause 3 *)
Definition C12 : graph := fun k j => orb (Nat.eqb j (S k mod 12)) (Nat.eqb k (S j mod 12)).
Definition caption_3 : Prop := forall th lam, eigenpair 12 C12 lam (fun k => expi (th k)) -> stationary 12 (W12 12 C12) th.
(* paley.fig2.caption clause 4; the columns of F are normalized, the phasors are not *)
Definition caption_4 : Prop := forall th lam, eigenpair 12 C12 lam (fun k => expi (th k)) ->
  (exists m rot, (m < 12)%nat /\ forall k, (k < 12)%nat -> expi (th k) = (expi rot * (RtoC (sqrt 12) * fourier 12 m k))%C) \/
  exists u v, Cmod u = 1 /\ Cmod v = 1 /\ forall k, (k < 12)%nat ->
    expi (th k) = match (k mod 4)%nat with 0%nat => u | 1%nat => v | 2%nat => Copp u | _ => Copp v end.
(* paley.length clause 3; one direction of each edge, chosen anyhow *)
Definition length_3 : Prop := forall n adj once x, (1 <= n)%nat -> undirected adj ->
  (forall j k, (j < n)%nat -> (k < n)%nat -> j <> k ->
     (adj k j = true <-> once k j = true \/ once j k = true) /\ ~ (once k j = true /\ once j k = true)) ->
  QL n adj x = / (2 * INR n) * edges n once x.
(* paley.scale clauses 3, 5 *)
Definition scale_3 : Prop := forall N r adj th, (2 <= N)%nat -> nearest N (N - 1) r adj -> 0 <= 2 / (INR (N - 1) + 1) * W12 N adj th <= 1.
Definition scale_5 : Prop := forall N n r adj th, (1 <= n < N)%nat -> nearest N n r adj -> 0 <= W12 N adj th / INR n <= 1.
(* paley.scale.complete clause 2 *)
Definition complete_2 : Prop := forall N r adj, (2 <= N)%nat -> nearest N (N - 1) r adj ->
  (forall j k, (j < N)%nat -> (k < N)%nat -> adj k j = negb (Nat.eqb k j)) /\
  forall th, 2 / (INR (N - 1) + 1) * W12 N adj th = 1 - Cmod (p7 N th) ^ 2.
(* circular formations: on the circle of radius rho round c0 with headings along it, counterclockwise for s = 1, clockwise for s = -1 *)
Definition circular (n : nat) (c0 : C) (rho s : R) (r : nat -> C) (th : nat -> R) := forall k, (k < n)%nat ->
  Cmod (r k - c0)%C = rho /\ (Ci * (r k - c0))%C = (RtoC (s * rho) * expi (th k))%C.
Definition solution20 n adj w0 K0 r th := (1 <= n)%nat /\ undirected adj /\ no_loops adj /\ strongly_connected n adj /\ w0 <> 0 /\ 0 < K0 /\
  forall t, 0 <= t -> particles n r th (u20 n adj w0 K0 (at_time r t) (at_time th t)) t.
(* paley.thm2 clause 1: states near to formations, and all turn at one rate in the end *)
Definition thm2_circles : Prop := forall n adj w0 K0 r th, solution20 n adj w0 K0 r th ->
  exists c0 s, (s = 1 \/ s = -1) /\ forall e, 0 < e -> exists T, forall t, T <= t ->
    (exists r', circular n c0 (/ Rabs w0) s r' (at_time th t) /\ forall k, (k < n)%nat -> Cmod (r k t - r' k)%C < e) /\
    forall j k, (j < n)%nat -> (k < n)%nat ->
      Rabs (u20 n adj w0 K0 (at_time r t) (at_time th t) k - u20 n adj w0 K0 (at_time r t) (at_time th t) j) < e.
(* paley.thm2 clause 2: in the end all turn, and go round the centre, in the sense of w0; so do the formations they tend to *)
Definition thm2_sense : Prop := forall n adj w0 K0 r th, solution20 n adj w0 K0 r th ->
  exists c0, ends_at n w0 r th c0 /\ (exists T, forall t k, T <= t -> (k < n)%nat ->
    0 < w0 * u20 n adj w0 K0 (at_time r t) (at_time th t) k /\ 0 < w0 * inner (Ci * (r k t - c0))%C (expi (th k t))) /\
  forall e, 0 < e -> exists T, forall t, T <= t -> exists r', circular n c0 (/ Rabs w0) (w0 / Rabs w0) r' (at_time th t) /\
    forall k, (k < n)%nat -> Cmod (r k t - r' k)%C < e.
(* paley.vatt clause 3 *)
Definition vatt_3 : Prop := forall n adj r k, (k < n)%nat -> clear n adj r k -> let v := Copp (hats n adj r k) in
  rate_along n adj r k v (- Cmod v ^ 2).
(* the steering K <i e^{i th}, v> at a fixed v: <e^{i th}, v> does not decrease, and grows where the steering is not zero *)
Definition turns_to (v : C) (K : R) := forall th : R -> R, let u t := K * inner (Ci * expi (th t))%C v in
  (forall t, is_derive th t (u t) -> exists d, is_derive (fun s => inner (expi (th s)) v) t d /\ 0 <= d /\ (u t <> 0 -> 0 < d)) /\
  forall a b, a <= b -> (forall t, a <= t <= b -> is_derive th t (u t)) -> inner (expi (th a)) v <= inner (expi (th b)) v.
(* paley.vatt clause 4 *)
Definition vatt_4 : Prop := forall n adj r k Katt, (k < n)%nat -> clear n adj r k -> 0 < Katt -> turns_to (Copp (hats n adj r k)) Katt.
(* paley.vrep clause 3 *)
Definition vrep_3 : Prop := forall n adj r k, (k < n)%nat -> clear n adj r k -> let v := hats n adj r k in rate_along n adj r k v (Cmod v ^ 2).
(* paley.vrep clause 4 *)
Definition vrep_4 : Prop := forall n adj r k Krep, (k < n)%nat -> clear n adj r k -> 0 < Krep -> turns_to (hats n adj r k) Krep.

(* ---- the theorems prove them ---- *)
From Flockproof Require paley_patterns paley_convergence.
Lemma QL_same n adj adj' x : (forall k j, (k < n)%nat -> (j < n)%nat -> adj k j = adj' k j) -> QL n adj x = QL n adj' x.
Proof.
  intros E. unfold QL, apply_L. f_equal. apply Sum_ext. intros k Hk. f_equal. apply Csum_ext. intros j Hj. unfold lap, deg.
  rewrite (Sum_ext n (w adj k) (w adj' k)); [unfold w; now rewrite (E k j Hk Hj)|]. intros i Hi. unfold w. now rewrite (E k i Hk Hi).
Qed.
Lemma Wm_2_holds : Wm_2.
Proof.
  intros n adj m th Hn Hm E. rewrite (QL_same n adj complete) by exact E. exact (paley_patterns.Wm_corrected n m th Hn Hm).
Qed.
Lemma eq29_2_holds : eq29_2.
Proof.
  intros n ori att w0 K0 K1 r th k Hn _ Hw. pose proof (eq29_corrected n ori att w0 K0 K1 r th k Hn Hw) as C. unfold control5_two in C.
  change (gW n ori th k) with (Lth n ori th k) in C. change (gW n att th k) with (Lth n att th k) in C.
  change (aS n att w0 r th k) with (Lc n att w0 r th k) in C. change (row n (lap n att) k r) with (Csum n (fun i => RtoC (lap n att k i) * r i))%C in C.
  unfold right29. fold (Lth n ori th k). fold (Lth n att th k). unfold spac20, ori14. rewrite <- C. ring.
Qed.
Lemma C12_undirected : undirected C12.
Proof. intros k j. unfold C12. apply Bool.orb_comm. Qed.
Lemma caption_3_holds : caption_3.
Proof.
  intros th lam [_ E] k Hk. unfold partial. apply (is_derive_ext (fun s => W1 12 C12 (upd th k s))); [intros s; symmetry; apply W12_is|].
  exact (proj1 (eigenvector_stationary 12 C12 th lam ltac:(lia) C12_undirected E) k Hk).
Qed.
Lemma C12_ring k j : (k < 12)%nat -> (j < 12)%nat -> C12 k j = ring_graph 12 k j.
Proof.
  intros Hk Hj. do 12 (destruct k as [|k]; [do 12 (destruct j as [|j]; [reflexivity|]); lia|]). lia.
Qed.
Lemma caption_4_holds : caption_4.
Proof.
  intros th lam [_ E]. destruct (ring_unit_eigenvectors 12 th lam ltac:(lia)) as [[m [Hm H]]|[_ H]].
  - intros k Hk. etransitivity; [|exact (E k Hk)]. apply Csum_ext. intros j Hj. unfold phasors. do 2 f_equal. unfold lap, deg.
    rewrite (Sum_ext 12 (w (ring_graph 12) k) (w C12 k)); [unfold w; now rewrite C12_ring|]. intros i Hi. unfold w. now rewrite C12_ring.
  - left. exists m, (th 0%nat). split; [exact Hm|]. intros k Hk. rewrite (H k Hk). f_equal. unfold fourier, wave.
    assert (I : INR 12 = 12) by (cbn; ring). rewrite I. rewrite Cmult_assoc, <- RtoC_mult, Rinv_r by (apply Rgt_not_eq, sqrt_lt_R0; lra).
    rewrite Cmult_1_l. f_equal. field.
  - right. exists (expi (th 0%nat)), (expi (th 1%nat)). rewrite !Cmod_expi. split; [reflexivity|]. split; [reflexivity|].
    assert (F : forall k, (k + 2 < 12)%nat -> expi (th (k + 2)%nat) = Copp (expi (th k))).
    { intros k Hk. rewrite <- (H k) by lia. now rewrite Nat.mod_small. }
    assert (G : forall k, (k + 4 < 12)%nat -> expi (th (k + 4)%nat) = expi (th k)).
    { intros k Hk. replace (k + 4)%nat with (k + 2 + 2)%nat by lia. rewrite (F (k + 2)%nat), (F k) by lia. ring. }
    intros k Hk. pose proof (F 0%nat ltac:(lia)) as F0. pose proof (F 1%nat ltac:(lia)) as F1. cbn [Nat.add] in F0, F1.
    pose proof (fun k H => G k H) as G'. do 4 (destruct k as [|k]; [cbn; first [reflexivity|exact F0|exact F1]|]).
    assert (X : forall i, (i < 4)%nat -> expi (th (i + 4)%nat) = expi (th i) /\ expi (th (i + 4 + 4)%nat) = expi (th i)).
    { intros i Hi. rewrite (G (i + 4)%nat) by lia. rewrite (G i) by lia. split; reflexivity. }
    pose proof (X 0%nat ltac:(lia)) as [X0 Y0]. pose proof (X 1%nat ltac:(lia)) as [X1 Y1]. pose proof (X 2%nat ltac:(lia)) as [X2 Y2].
    pose proof (X 3%nat ltac:(lia)) as [X3 Y3]. cbn [Nat.add] in X0, X1, X2, X3, Y0, Y1, Y2, Y3.
    do 8 (destruct k as [|k]; [cbn; congruence|]). lia.
Qed.
Lemma length_3_holds : length_3.
Proof.
  intros n adj once x Hn S O. rewrite (length_2_holds n adj x Hn S). pose proof (INR_pos n Hn) as P.
  assert (E : edges n adj x = edges n once x + edges n once x).
  { assert (T : edges n once x = Sum n (fun k => Sum n (fun j => if once j k then Cmod (x k - x j)%C ^ 2 else 0))) by (unfold edges; apply Sum_swap).
    rewrite T at 2. unfold edges. rewrite <- Sum_plus. apply Sum_ext. intros k Hk. rewrite <- Sum_plus. apply Sum_ext. intros j Hj.
    replace (Cmod (x k - x j)%C) with (Cmod (x j - x k)%C) by (rewrite <- Cmod_opp; f_equal; ring).
    destruct (Nat.eq_dec j k) as [->|N].
    - replace (x k - x k)%C with (RtoC 0) by ring. rewrite Cmod_0. destruct (adj k k), (once k k); ring.
    - destruct (O j k Hj Hk N) as [A B]. destruct (adj k j), (once k j), (once j k); try ring; exfalso;
      [apply B; split; reflexivity|destruct (proj1 A eq_refl); discriminate|apply B; split; reflexivity| |];
      (discriminate (proj2 A (or_introl eq_refl)) || discriminate (proj2 A (or_intror eq_refl))). }
  rewrite E. field. lra.
Qed.
Lemma complete_2_holds : complete_2.
Proof.
  intros N r adj HN H. pose proof (nearest_all N r adj ltac:(lia) H) as E. split; [exact E|]. intros th.
  rewrite W12_is, (W1_same N adj complete th E). exact (paley_fish.scale_complete_corrected N th HN).
Qed.
Lemma scale_3_holds : scale_3.
Proof.
  intros N r adj th HN H. rewrite (proj2 (complete_2_holds N r adj HN H) th). pose proof (eq7_1_holds N th ltac:(lia)). nra.
Qed.
Lemma scale_5_holds : scale_5.
Proof.
  intros N n r adj th Hn H. rewrite W12_is. assert (D : forall k, (k < N)%nat -> deg N adj k = INR n) by (intros k Hk; apply (H k Hk)).
  destruct (paley_fish.W1_le_degree N adj th (INR n) ltac:(lia) D) as [A B]. pose proof (INR_pos n ltac:(lia)) as P.
  assert (I : 0 < / INR n) by now apply Rinv_0_lt_compat. unfold Rdiv. split; [nra|].
  rewrite <- (Rinv_r (INR n)) by lra. apply Rmult_le_compat_r; lra.
Qed.
(* the fields *)
Lemma turns_to_field v K : 0 < K -> turns_to v K.
Proof.
  intros HK th u. split.
  - intros t D. exists (K * inner (Ci * expi (th t))%C v ^ 2). split; [exact (paley_behaviours.turning v K th t D)|].
    pose proof (pow2_ge_0 (inner (Ci * expi (th t))%C v)). split; [nra|]. intros N.
    assert (X : inner (Ci * expi (th t))%C v <> 0) by (intros X; apply N; unfold u; rewrite X; ring). pose proof (pow2_gt_0 _ X). nra.
  - intros a b. exact (paley_behaviours.turns_towards v K th a b HK).
Qed.
Lemma vatt_3_holds : vatt_3.
Proof.
  intros n adj r k _ Cl v. pose proof (rate_is n adj r k v Cl) as D. replace (- Cmod v ^ 2) with (inner v (hats n adj r k)); [exact D|].
  unfold v. rewrite inner_opp, inner_self, Cmod_opp. reflexivity.
Qed.
Lemma vatt_4_holds : vatt_4.
Proof. intros n adj r k K _ _ HK. now apply turns_to_field. Qed.
Lemma vrep_3_holds : vrep_3.
Proof. intros n adj r k _ Cl v. pose proof (rate_is n adj r k v Cl) as D. fold v in D. now rewrite inner_self in D. Qed.
Lemma vrep_4_holds : vrep_4.
Proof. intros n adj r k K _ _ HK. now apply turns_to_field. Qed.

(* Theorem 2: the particles tend to a formation, so the centres to one point; the rates follow, by (20) *)
Lemma in_time (n : nat) (P : nat -> R -> Prop) : (forall k, (k < n)%nat -> exists T, forall t, T <= t -> P k t) ->
  exists T, forall k t, (k < n)%nat -> T <= t -> P k t.
Proof.
  induction n as [|n IH]; intros H; [exists 0; intros k t Hk; lia|]. destruct IH as [T A]; [intros k Hk; apply H; lia|].
  destruct (H n ltac:(lia)) as [T' B]. exists (Rmax T T'). intros k t Hk Ht. pose proof (Rmax_l T T'). pose proof (Rmax_r T T').
  destruct (Nat.eq_dec k n) as [->|N]; [apply B; lra|apply A; [lia|lra]].
Qed.
Lemma inner_small x t : Rabs (inner x (expi t)) <= Cmod x.
Proof.
  rewrite <- (Rabs_pos_eq (Cmod x)) by apply Cmod_ge_0. apply Rsqr_le_abs_0.
  rewrite !Rsqr_pow2, <- inner_self, !inner_xy. pose proof (sc2 t) as U. cbn in *. set (p := cos t) in *. set (q := sin t) in *.
  destruct x as [a b]. cbn. pose proof (pow2_ge_0 (a * q - b * p)) as Z. cbn in Z.
  replace (a * a + b * b) with ((q * (q * 1) + p * (p * 1)) * (a * a + b * b)) by (rewrite U; ring). lra.
Qed.
Lemma inner_sums n (a : nat -> R) (f : nat -> C) t d : (forall j, (j < n)%nat -> Cmod (f j) <= d) ->
  Rabs (inner (expi t) (Csum n (fun j => RtoC (a j) * f j)%C)) <= d * Sum n (fun j => Rabs (a j)).
Proof.
  intros H. rewrite inner_Csum. eapply Rle_trans; [apply Sum_Rabs|]. rewrite <- Sum_scal. apply Sum_le. intros j Hj.
  rewrite inner_scal, Rabs_mult, inner_sym, (Rmult_comm d). apply Rmult_le_compat_l; [apply Rabs_pos|].
  exact (Rle_trans _ _ _ (inner_small (f j) t) (H j Hj)).
Qed.
Lemma ending n adj w0 K0 r th : solution20 n adj w0 K0 r th -> exists c0, ends_at n w0 r th c0 /\ forall e, 0 < e -> exists T, forall k t, (k < n)%nat -> T <= t ->
  Cmod (ck w0 (at_time r t) (at_time th t) k - c0)%C < e /\ Rabs (u20 n adj w0 K0 (at_time r t) (at_time th t) k - w0) < e.
Proof.
  intros (Hn & S & _ & SC & Hw & HK & M). destruct (paley_convergence.thm2 n adj w0 K0 r th Hn S SC Hw HK) as (c0 & T & A & m & Hm & H).
  { intros k t Hk Ht. destruct (M t Ht k Hk) as [V D]. split; [exact V|]. unfold u20 in D. rewrite Rmult_assoc in D. exact D. }
  pose proof (Rinv_0_lt_compat _ (Rabs_pos_lt w0 Hw)) as B.
  assert (E : ends_at n w0 r th c0).
  { intros k Hk e He. destruct (H k Hk) as (psi & phi & F). destruct (paley_convergence.exp_small m e (A + / Rabs w0 * (2 * A)) Hm He) as [T' [_ L]].
    exists (Rmax T T'). intros t Ht. pose proof (Rmax_l T T'). pose proof (Rmax_r T T'). specialize (L t ltac:(lra)). destruct (F t ltac:(lra)) as (X & Y & Z).
    set (z := (c0 + RtoC (/ Rabs w0) * expi (phi + w0 * t))%C) in *. apply Rle_lt_trans with (2 := L).
    replace (ck w0 (at_time r t) (at_time th t) k - c0)%C with ((r k t - z) + RtoC (/ w0) * (Ci * (expi (th k t) - expi (psi + w0 * t))))%C
      by (rewrite <- Z; unfold ck, circle_centre; ring).
    eapply Rle_trans; [apply Cmod_triangle|]. assert (I : Cmod Ci = 1) by (unfold Cmod; cbn; replace (0 * (0 * 1) + 1 * (1 * 1)) with 1 by ring; apply sqrt_1).
    rewrite !Cmod_mult, I, Cmod_R, Rabs_inv, Rmult_1_l. pose proof (paley_convergence.expi_near (th k t) (psi + w0 * t)) as N.
    assert (/ Rabs w0 * Cmod (expi (th k t) - expi (psi + w0 * t))%C <= / Rabs w0 * (2 * (A * exp (- m * t)))) by (apply Rmult_le_compat_l; lra). lra. }
  exists c0. split; [exact E|]. intros e He. apply (in_time n (fun k t => _ /\ _)). intros k Hk.
  (* the rate is w0 but for the differences of the centres *)
  set (G := Rabs (w0 * (K0 / INR n)) * Sum n (fun j => Rabs (lap n adj k j))).
  assert (G0 : 0 <= G) by (apply Rmult_le_pos; [apply Rabs_pos|apply Sum_ge0; intros; apply Rabs_pos]).
  assert (e1 : 0 < e / (1 + G)) by (apply Rdiv_lt_0_compat; lra).
  destruct (in_time n (fun j t => Cmod (ck w0 (at_time r t) (at_time th t) j - c0)%C < e / (1 + G))) as [T' F]; [intros j Hj; exact (E j Hj _ e1)|].
  exists T'. intros t Ht. assert (e2 : e / (1 + G) * (1 + G) = e) by (field; lra). split; [pose proof (F k t Hk Ht); nra|].
  replace (u20 n adj w0 K0 (at_time r t) (at_time th t) k - w0) with (w0 * (K0 / INR n) *
    inner (expi (th k t)) (Csum n (fun j => RtoC (lap n adj k j) * (ck w0 (at_time r t) (at_time th t) j - c0))%C)).
  - rewrite Rabs_mult. pose proof (inner_sums n (lap n adj k) (fun j => ck w0 (at_time r t) (at_time th t) j - c0)%C (th k t) (e / (1 + G))) as Q.
    specialize (Q (fun j Hj => Rlt_le _ _ (F j t Hj Ht))). cbv beta in Q.
    apply (Rmult_le_compat_l _ _ _ (Rabs_pos (w0 * (K0 / INR n)))) in Q. apply Rle_lt_trans with (1 := Q). unfold G in *. nra.
  - unfold u20, Lc. rewrite (Csum_ext n _ (fun j => RtoC (lap n adj k j) * ck w0 (at_time r t) (at_time th t) j - c0 * RtoC (lap n adj k j))%C) by (intros; ring).
    rewrite Csum_minus, Csum_scal. replace (Csum n (fun j => RtoC (lap n adj k j))) with (RtoC 0).
    + rewrite Cmult_0_r. unfold Cminus. rewrite Copp_0, Cplus_0_r. ring.
    + apply injective_projections; cbn; [symmetry; now apply graph_2_proved|rewrite Sum_zero; [reflexivity|intros; reflexivity]].
Qed.
(* the formation that has the headings of the particles and the centre c0 *)
Lemma formation n w0 c0 th : w0 <> 0 -> circular n c0 (/ Rabs w0) (w0 / Rabs w0) (fun k => c0 - RtoC (/ w0) * (Ci * expi (th k)))%C th.
Proof.
  intros Hw k _. pose proof (Rabs_pos_lt w0 Hw) as A. split.
  - replace (c0 - RtoC (/ w0) * (Ci * expi (th k)) - c0)%C with (- (RtoC (/ w0) * (Ci * expi (th k))))%C by ring.
    assert (I : Cmod Ci = 1) by (unfold Cmod; cbn; replace (0 * (0 * 1) + 1 * (1 * 1)) with 1 by ring; apply sqrt_1).
    rewrite Cmod_opp, !Cmod_mult, Cmod_expi, I, Cmod_R, Rabs_inv. ring.
  - replace (w0 / Rabs w0 * / Rabs w0) with (/ w0).
    + apply injective_projections; cbn; ring.
    + assert (Q : Rabs w0 * Rabs w0 = w0 * w0) by (rewrite <- Rabs_mult; apply Rabs_pos_eq; nra).
      transitivity (w0 * / (Rabs w0 * Rabs w0)); [rewrite Q; field; exact Hw|field; lra].
Qed.
Lemma from_formation n adj w0 K0 r th c0 e : solution20 n adj w0 K0 r th ->
  (exists T, forall k t, (k < n)%nat -> T <= t -> Cmod (ck w0 (at_time r t) (at_time th t) k - c0)%C < e) ->
  exists T, forall t, T <= t -> exists r', circular n c0 (/ Rabs w0) (w0 / Rabs w0) r' (at_time th t) /\
    forall k, (k < n)%nat -> Cmod (r k t - r' k)%C < e.
Proof.
  intros (_ & _ & _ & _ & Hw & _) [T H]. exists T. intros t Ht. exists (fun k => c0 - RtoC (/ w0) * (Ci * expi (th k t)))%C.
  split; [exact (formation n w0 c0 (at_time th t) Hw)|]. intros k Hk. specialize (H k t Hk Ht). unfold ck in H.
  replace (r k t - (c0 - RtoC (/ w0) * (Ci * expi (th k t))))%C with (r k t + RtoC (/ w0) * (Ci * expi (th k t)) - c0)%C by ring. exact H.
Qed.
Lemma thm2_circles_holds : thm2_circles.
Proof.
  intros n adj w0 K0 r th So. assert (Hw : w0 <> 0) by apply So. destruct (ending n adj w0 K0 r th So) as [c0 [_ H]]. exists c0, (w0 / Rabs w0). split.
  - destruct (Rdichotomy w0 0 Hw); [right; rewrite Rabs_left by lra|left; rewrite Rabs_right by lra]; field; lra.
  - intros e He. destruct (H (e / 2) ltac:(lra)) as [T A]. destruct (from_formation n adj w0 K0 r th c0 e So) as [T' B].
    + exists T. intros k t Hk Ht. destruct (A k t Hk Ht). lra.
    + exists (Rmax T T'). intros t Ht. pose proof (Rmax_l T T'). pose proof (Rmax_r T T'). split; [apply B; lra|]. intros j k Hj Hk.
      destruct (A j t Hj ltac:(lra)) as [_ X]. destruct (A k t Hk ltac:(lra)) as [_ Y]. apply Rabs_def2 in X, Y. apply Rabs_def1; lra.
Qed.
Lemma thm2_sense_holds : thm2_sense.
Proof.
  intros n adj w0 K0 r th So. assert (Hw : w0 <> 0) by apply So. destruct (ending n adj w0 K0 r th So) as [c0 [E H]]. exists c0.
  pose proof (Rabs_pos_lt w0 Hw) as A. pose proof (Rinv_0_lt_compat _ A) as B. split; [exact E|]. split.
  - destruct (H (Rmin (Rabs w0) (/ Rabs w0)) ltac:(now apply Rmin_pos)) as [T F]. exists T. intros t k Ht Hk. destruct (F k t Hk Ht) as [X Y].
    pose proof (Rmin_l (Rabs w0) (/ Rabs w0)). pose proof (Rmin_r (Rabs w0) (/ Rabs w0)). split.
    + set (u := u20 _ _ _ _ _ _ k) in *. assert (D : Rabs (w0 * (u - w0)) < Rabs w0 * Rabs w0) by (rewrite Rabs_mult; apply Rmult_lt_compat_l; lra).
      rewrite <- Rabs_mult, (Rabs_pos_eq (w0 * w0)) in D by nra. apply Rabs_def2 in D. lra.
    + set (d := (ck w0 (at_time r t) (at_time th t) k - c0)%C) in *.
      assert (I : Cmod Ci = 1) by (unfold Cmod; cbn; replace (0 * (0 * 1) + 1 * (1 * 1)) with 1 by ring; apply sqrt_1).
      pose proof (inner_small (Ci * d)%C (th k t)) as S. rewrite Cmod_mult, I, Rmult_1_l in S.
      assert (J : inner (Ci * (r k t - c0))%C (expi (th k t)) = inner (Ci * d)%C (expi (th k t)) + / w0).
      { replace (Ci * (r k t - c0))%C with (Ci * d + RtoC (/ w0) * expi (th k t))%C by (unfold d, ck; apply injective_projections; cbn; ring).
        rewrite inner_sym, inner_plus, inner_scal, inner_expi_self, (inner_sym (Ci * d)%C). ring. }
      rewrite J, Rmult_plus_distr_l, Rinv_r by exact Hw.
      assert (D : Rabs (w0 * inner (Ci * d)%C (expi (th k t))) < 1).
      { rewrite Rabs_mult. apply Rle_lt_trans with (Rabs w0 * Cmod d); [apply Rmult_le_compat_l; lra|].
        rewrite <- (Rinv_r (Rabs w0)) by lra. apply Rmult_lt_compat_l; lra. }
      apply Rabs_def2 in D. lra.
  - intros e He. apply (from_formation n adj w0 K0 r th c0 e So). destruct (H e He) as [T F]. exists T. intros k t Hk Ht. apply (F k t Hk Ht).
Qed.
