(* Clauses about solutions that exist, are unique or go to a limit, formalised from their words before the theorems were looked at; the
   theorems prove them. K of (10) is T.K10 of audit_independent_tanner2, which
   is K of Definition 4 by K10_whole. Changed after the theorems had been seen: gradients, not the slopes V', are locally Lipschitz in eq10_4. *)
From Coq Require Import Reals Lra Lia Relations Psatz Classical.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums paley_model paley_phase paley_laplacian tanner_energy.
From Flockproof Require inclusions tanner_flock tanner2_filippov tanner2_limits tanner2_appendix tanner2_existence tanner2_unique tanner2_solutions tanner2_onward tanner2_approach tanner2_field tanner2_definition4 tanner2_stops tanner2_apart tanner2_minima tanner2_motion.
From Flockproof Require paley_particles paley_convergence paley_settling paley_formations paley_cycles audit_independent_paley audit_independent_tanner2 audit_independent_derivative.
Module P := audit_independent_paley.
Module T := audit_independent_tanner2.
Module D := audit_independent_derivative.
Open Scope R_scope.

(* ---- Definition 4: R^n as the first n numbers of a sequence ---- *)
Fixpoint volume (n : nat) (a b : nat -> R) : R := match n with O => 1 | S m => volume m a b * (b m - a m) end.
Definition null (n : nat) (Z : (nat -> R) -> Prop) := forall e, 0 < e -> exists a b : nat -> nat -> R,
  (forall k i, (i < n)%nat -> a k i <= b k i) /\ (forall x, Z x -> exists k, forall i, (i < n)%nat -> a k i < x i < b k i) /\
  forall m, Sum m (fun k => volume n (a k) (b k)) <= e.
(* K[f](x): for every null set Z and every d > 0 in the closed convex hull of the values of f within d of x, off Z *)
Definition K (n : nat) (f : (nat -> R) -> nat -> R) (x z : nat -> R) := forall Z d e, null n Z -> 0 < d -> 0 < e ->
  exists m (c : nat -> R) (y : nat -> nat -> R), (forall k, (k < m)%nat -> 0 <= c k) /\ Sum m c = 1 /\
  (forall k, (k < m)%nat -> ~ Z (y k) /\ forall i, (i < n)%nat -> Rabs (y k i - x i) < d) /\
  forall i, (i < n)%nat -> Rabs (Sum m (fun k => c k * f (y k) i) - z i) < e.
Definition continuous_absolutely (b : R) (x : R -> R) := forall e, 0 < e -> exists d, 0 < d /\ forall m (p q : nat -> R),
  (forall k, (k < m)%nat -> 0 <= p k <= q k /\ q k <= b) -> (forall k, (S k < m)%nat -> q k <= p (S k)) ->
  Sum m (fun k => q k - p k) < d -> Sum m (fun k => Rabs (x (q k) - x (p k))) < e.
(* on every [0, b]; almost all t >= 0 *)
Definition solution4 (n : nat) (f : (nat -> R) -> nat -> R) (x : R -> nat -> R) :=
  (forall b i, 0 < b -> (i < n)%nat -> continuous_absolutely b (fun t => x t i)) /\
  exists N, T.negligible N /\ forall t, 0 <= t -> ~ N t -> exists z, K n f (x t) z /\ forall i, (i < n)%nat -> is_derive (fun s => x s i) t (z i).
(* tanner2.appA.def4 clause 2, the existence; measurable or not *)
Definition def4_2 : Prop := forall n (f : (nat -> R) -> nat -> R) M x0,
  (forall x y, (forall i, (i < n)%nat -> x i = y i) -> forall i, (i < n)%nat -> f x i = f y i) ->
  (forall x i, (i < n)%nat -> Rabs (f x i) <= M) -> exists x, (forall i, (i < n)%nat -> x 0 i = x0 i) /\ solution4 n f x.

(* ---- (10), solutions on [0, T) or for all t >= 0; at t = 0 the rates are those to the right ---- *)
Definition rate (z : R -> C) (t : R) (w : C) := forall e, 0 < e -> exists d, 0 < d /\ forall s, 0 <= s -> Rabs (s - t) < d ->
  Cmod (z s - z t - RtoC (s - t) * w)%C <= e * Rabs (s - t).
Definition continuous_absolutely_2 (b : R) (z : R -> C) := continuous_absolutely b (fun t => fst (z t)) /\ continuous_absolutely b (fun t => snd (z t)).
(* where agents coincide the law has no value, and nothing is asked *)
Definition solution10 n V' R0 (I : R -> Prop) (r v : nat -> R -> C) :=
  T.apart_at n complete (fun i => r i 0) /\
  (forall t i, I t -> (i < n)%nat -> rate (r i) t (v i t)) /\ (forall b i, I b -> (i < n)%nat -> continuous_absolutely_2 b (v i)) /\
  exists N, T.negligible N /\ forall t, I t -> ~ N t -> T.apart_at n complete (fun i => r i t) ->
    exists z, T.K10 n V' R0 (fun i => r i t) (fun i => v i t) z /\ forall i, (i < n)%nat -> rate (v i) t (z i).
Definition always (t : R) := 0 <= t.
Definition before (T t : R) := 0 <= t < T.
(* tanner2.eq10_exist clause 3: and the agents stay apart, so that something is asked at almost all times *)
Definition eq10_3 : Prop := forall n V V' R0 (r0 v0 : nat -> C), 0 < R0 -> T.potentials n complete V V' -> T.apart_at n complete r0 ->
  exists r v, solution10 n V' R0 always r v /\ (forall t, 0 <= t -> T.apart_at n complete (fun i => r i t)) /\
  forall i, (i < n)%nat -> r i 0 = r0 i /\ v i 0 = v0 i.
(* clause 4: on [0, T), if no such pair comes before T along one of them *)
Definition gradient_lipschitz (f : R -> R) := forall a : C, a <> 0%C -> exists d L, 0 < d /\ forall y z : C, y <> 0%C -> z <> 0%C -> Cmod (y - a)%C < d -> Cmod (z - a)%C < d ->
  Cmod (RtoC (f (Cmod y) / Cmod y) * y - RtoC (f (Cmod z) / Cmod z) * z)%C <= L * Cmod (y - z)%C.
Definition eq10_4 : Prop := forall n V V' R0 T r v q u, 0 < R0 -> T.potentials n complete V V' ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> i <> j -> gradient_lipschitz (V' i j)) ->
  solution10 n V' R0 (before T) r v -> solution10 n V' R0 (before T) q u -> (forall i, (i < n)%nat -> r i 0 = q i 0 /\ v i 0 = u i 0) ->
  (forall t i j, 0 <= t < T -> (i < n)%nat -> (j < n)%nat -> i <> j -> Cmod (r i t - r j t)%C = R0 -> inner (r i t - r j t)%C (v i t - v j t)%C <> 0) ->
  forall t i, 0 <= t < T -> (i < n)%nat -> r i t = q i t /\ v i t = u i t.
(* tanner2.thm2_vel clause 1, tanner2.arbswitch clause 2 (corrected) *)
Definition thm2_vel : Prop := forall n V V' R0 r v, 0 < R0 -> T.potentials n complete V V' -> solution10 n V' R0 always r v ->
  (forall t, 0 <= t -> strongly_connected n (T.by_distance (fun i => r i t) R0)) ->
  forall i j, (i < n)%nat -> (j < n)%nat -> T.to_zero (fun t => v i t - v j t)%C.
(* tanner2.thm2_pot clause 2 (corrected): near critical configurations in the end; the limits of the gradients at a configuration are finitely many *)
Definition limit_of_gradients n V' R0 (q y : nat -> C) := forall e, 0 < e -> exists p : nat -> C, (forall i, (i < n)%nat -> Cmod (p i - q i)%C < e) /\
  (forall i j, (i < n)%nat -> (j < n)%nat -> i <> j -> Cmod (p i - p j)%C <> R0) /\
  forall i, (i < n)%nat -> Cmod (T.gradV n (T.by_distance p R0) V' p i - y i)%C < e.
Definition critical n V' R0 (q : nat -> C) := T.apart_at n complete q /\ exists m (c : nat -> R) (y : nat -> nat -> C),
  (forall k, (k < m)%nat -> 0 <= c k /\ limit_of_gradients n V' R0 q (y k)) /\ Sum m c = 1 /\
  forall i, (i < n)%nat -> Csum m (fun k => RtoC (c k) * y k i)%C = 0%C.
Definition thm2_pot : Prop := forall n V V' R0 r v, 0 < R0 -> T.potentials n complete V V' -> solution10 n V' R0 always r v ->
  (forall t, 0 <= t -> strongly_connected n (T.by_distance (fun i => r i t) R0)) ->
  forall e, 0 < e -> exists S, 0 <= S /\ forall t, S <= t -> exists q, critical n V' R0 q /\ forall i, (i < n)%nat -> Cmod (r i t - q i)%C < e.

(* critical configurations where no pair is at the distance R *)
Definition critical_there : Prop := forall n V V' R0 q, 0 < R0 -> T.potentials n complete V V' -> T.apart_at n complete q ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> i <> j -> Cmod (q i - q j)%C <> R0) ->
  (critical n V' R0 q <-> forall i, (i < n)%nat -> T.gradV n (T.by_distance q R0) V' q i = 0%C).
(* thm2_vel and thm2_pot speak of every solution: each one until T goes on for all time *)
Definition goes_on : Prop := forall n V V' R0 S r v, 0 < R0 -> 0 < S -> T.potentials n complete V V' -> solution10 n V' R0 (before S) r v ->
  exists q u, solution10 n V' R0 always q u /\ forall t i, 0 <= t < S -> q i t = r i t /\ u i t = v i t.
(* the whole vector field of (10) on R^(4n), agent i at 4i, 4i + 1 with the velocity at 4i + 2, 4i + 3 *)
Definition place (x : nat -> R) i : C := (x (4 * i)%nat, x (4 * i + 1)%nat).
Definition speed (x : nat -> R) i : C := (x (4 * i + 2)%nat, x (4 * i + 3)%nat).
Definition state (q u : nat -> C) (j : nat) : R := let i := Nat.div j 4 in
  match Nat.modulo j 4 with 0 => fst (q i) | 1 => snd (q i) | 2 => fst (u i) | _ => snd (u i) end%nat.
Definition field10 n V' R0 (x : nat -> R) : nat -> R := state (speed x) (T.law4 n (T.by_distance (place x) R0) V' (place x) (speed x)).
(* written after the theorems had been seen: where no agents coincide K of it by the words of Definition 4 is T.K10, and K of the gradients of all agents together (agent i at i, n + i) is the hull in
   critical; so the same clauses with K of Definition 4 in place of either *)
Definition K10_whole : Prop := forall n V V' R0 r v w, 0 < R0 -> T.potentials n complete V V' -> T.apart_at n complete r ->
  (K (4 * n) (field10 n V' R0) (state r v) w <-> exists z, T.K10 n V' R0 r v z /\ forall j, (j < 4 * n)%nat -> w j = state v z j).
Definition gradients n V' R0 (x : nat -> R) (j : nat) : R := let q := fun i => (x i, x (n + i)%nat) : C in
  if Nat.ltb j n then fst (T.gradV n (T.by_distance q R0) V' q j) else snd (T.gradV n (T.by_distance q R0) V' q (j - n)%nat).
Definition critical_whole n V' R0 (q : nat -> C) := T.apart_at n complete q /\
  K (2 * n) (gradients n V' R0) (fun j => if Nat.ltb j n then fst (q j) else snd (q (j - n)%nat)) (fun _ => 0).
Definition solution4_before (T : R) (n : nat) (f : (nat -> R) -> nat -> R) (x : R -> nat -> R) :=
  (forall b i, 0 < b < T -> (i < n)%nat -> continuous_absolutely b (fun t => x t i)) /\
  exists N, T.negligible N /\ forall t, 0 <= t < T -> ~ N t -> exists z, K n f (x t) z /\ forall i, (i < n)%nat -> is_derive (fun s => x s i) t (z i).
Definition whole_before T n V' R0 x := T.apart_at n complete (place (x 0)) /\ solution4_before T (4 * n) (field10 n V' R0) x.
Definition whole n V' R0 x := T.apart_at n complete (place (x 0)) /\ solution4 (4 * n) (field10 n V' R0) x.
Definition eq10_3_whole : Prop := forall n V V' R0 (r0 v0 : nat -> C), 0 < R0 -> T.potentials n complete V V' -> T.apart_at n complete r0 ->
  exists x, whole n V' R0 x /\ forall i, (i < n)%nat -> place (x 0) i = r0 i /\ speed (x 0) i = v0 i.
Definition goes_on_whole : Prop := forall n V V' R0 S x, 0 < R0 -> 0 < S -> T.potentials n complete V V' -> whole_before S n V' R0 x ->
  exists y, whole n V' R0 y /\ forall t i, 0 <= t < S -> (i < 4 * n)%nat -> y t i = x t i.
Definition eq10_4_whole : Prop := forall n V V' R0 T x y, 0 < R0 -> T.potentials n complete V V' ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> i <> j -> gradient_lipschitz (V' i j)) ->
  whole_before T n V' R0 x -> whole_before T n V' R0 y -> (forall i, (i < 4 * n)%nat -> x 0 i = y 0 i) ->
  (forall t i j, 0 <= t < T -> (i < n)%nat -> (j < n)%nat -> i <> j -> Cmod (place (x t) i - place (x t) j)%C = R0 ->
    inner (place (x t) i - place (x t) j)%C (speed (x t) i - speed (x t) j)%C <> 0) ->
  forall t i, 0 <= t < T -> (i < 4 * n)%nat -> x t i = y t i.
Definition thm2_coll_whole : Prop := forall n V V' R0 T x, 0 < R0 -> T.potentials n complete V V' -> whole_before T n V' R0 x ->
  forall t, 0 <= t < T -> T.apart_at n complete (place (x t)).
Definition thm2_vel_whole : Prop := forall n V V' R0 x, 0 < R0 -> T.potentials n complete V V' -> whole n V' R0 x ->
  (forall t, 0 <= t -> strongly_connected n (T.by_distance (place (x t)) R0)) ->
  forall i j, (i < n)%nat -> (j < n)%nat -> T.to_zero (fun t => speed (x t) i - speed (x t) j)%C.
Definition thm2_pot_whole : Prop := forall n V V' R0 x, 0 < R0 -> T.potentials n complete V V' -> whole n V' R0 x ->
  (forall t, 0 <= t -> strongly_connected n (T.by_distance (place (x t)) R0)) ->
  forall e, 0 < e -> exists S, 0 <= S /\ forall t, S <= t -> exists q, critical_whole n V' R0 q /\ forall i, (i < n)%nat -> Cmod (place (x t) i - q i)%C < e.
Definition time_derivative_whole n V V' R0 (r v : nat -> C) (x : R) := forall a b, D.clarke n (T.energy11 n V R0) r v a b ->
  exists w, K (4 * n) (field10 n V' R0) (state r v) w /\ x = Sum n (fun i => D.dot (a i) (place w i) + D.dot (b i) (speed w i)).
Definition eq13_12_whole : Prop := forall n V V' R0 r v x, 0 < R0 -> T.potentials n complete V V' -> T.apart_at n complete r ->
  time_derivative_whole n V V' R0 r v x -> D.right_side n R0 r v x /\ x <= 0.
Definition eq13_3_whole : Prop := forall n V V' R0 T x, 0 < R0 -> T.potentials n complete V V' -> whole_before T n V' R0 x -> forall s t, 0 <= s <= t -> t < T ->
  T.energy11 n V R0 (place (x t)) (speed (x t)) <= T.energy11 n V R0 (place (x s)) (speed (x s)).

(* beyond.tanner2.thm2_stop; s i j a limit of the positions of i relative to j *)
Definition thm2_stop : Prop := forall n V V' R0 x, 0 < R0 -> T.potentials n complete V V' -> (forall i j, (i < n)%nat -> (j < n)%nat -> i <> j -> 0 < V' i j R0) -> whole n V' R0 x ->
  (forall t, 0 <= t -> strongly_connected n (T.by_distance (place (x t)) R0)) ->
  let rel t i j : C := (place (x t) i - place (x t) j)%C in
  (forall s : nat -> nat -> C, (forall S e, 0 < e -> exists t, S <= t /\ forall i j, (i < n)%nat -> (j < n)%nat -> Cmod (rel t i j - s i j)%C < e) ->
    forall i j k l, (i < j < n)%nat -> (k < l < n)%nat -> Cmod (s i j) = R0 -> Cmod (s k l) = R0 -> i = k /\ j = l) ->
  exists S, 0 <= S /\ forall i j a b, (i < n)%nat -> (j < n)%nat -> S <= a < b -> (Cmod (rel a i j) < R0 < Cmod (rel b i j) \/ Cmod (rel b i j) < R0 < Cmod (rel a i j)) ->
    exists c d, a <= c < d /\ d <= b /\ forall t, c <= t <= d -> Cmod (rel t i j) = R0.

(* tanner2.sec4.flocking clause 3 (corrected): z the minimum; rotations and translations of z; within e of one in all r_ij, and all v_i - v_j below e. Where agents coincide the sum of the V_ij is infinite *)
Definition turned n (z q : nat -> C) := exists a c : C, Cmod a = 1 /\ forall i, (i < n)%nat -> q i = (a * z i + c)%C.
Definition within n (z : nat -> C) e (q : nat -> C) := exists a : C, Cmod a = 1 /\ forall i j, (i < n)%nat -> (j < n)%nat -> Cmod (q i - q j - a * (z i - z j))%C < e.
Definition flocks_within n z e (q u : nat -> C) := within n z e q /\ forall i j, (i < n)%nat -> (j < n)%nat -> Cmod (u i - u j)%C < e.
Definition sum_V n (V : nat -> nat -> R -> R) (q : nat -> C) := Sum n (fun i => Sum i (fun j => V i j (Cmod (q i - q j)%C))).
Definition sec4_flocking : Prop := forall n V V' z, (2 <= n)%nat -> T.potentials n complete V V' -> T.apart_at n complete z ->
  (exists d, 0 < d /\ forall q, T.apart_at n complete q -> within n z d q -> ~ turned n z q -> sum_V n V z < sum_V n V q) ->
  (exists d, 0 < d /\ forall q, T.apart_at n complete q -> within n z d q -> (forall i, (i < n)%nat -> T.gradV n complete V' q i = 0%C) -> turned n z q) ->
  (forall q w, turned n z q -> T.motion n complete V' (fun i t => (q i + RtoC t * w)%C) (fun _ _ => w)) /\
  (forall e, 0 < e -> exists d, 0 < d /\ forall r v, T.motion n complete V' r v -> flocks_within n z d (fun i => r i 0) (fun i => v i 0) ->
    forall t, 0 <= t -> flocks_within n z e (fun i => r i t) (fun i => v i t)) /\
  exists d, 0 < d /\ forall r v, T.motion n complete V' r v -> flocks_within n z d (fun i => r i 0) (fun i => v i 0) ->
    forall e, 0 < e -> exists S, forall t, S <= t -> flocks_within n z e (fun i => r i t) (fun i => v i t).

(* ---- beyond.paley.cyclic_patterns: neighbours on the ring ---- *)
Definition ring (n : nat) : graph := fun j k => (Nat.eqb k ((j + 1) mod n) || Nat.eqb j ((k + 1) mod n))%bool.
(* within d of a formation: centre c, first heading phi; r_k = c - i e^{i theta_k}/w0 *)
Definition pattern_within n (m : Z) w0 (r : nat -> C) (th : nat -> R) d := exists (c : C) phi, forall k, (k < n)%nat ->
  let e := expi (phi + 2 * PI * IZR m * INR k / INR n) in
  Cmod (expi (th k) - e)%C <= d /\ Cmod (r k - (c - RtoC (/ w0) * (Ci * e)))%C <= d.
Definition motion22 n w0 K0 K1 (r : nat -> R -> C) (th : nat -> R -> R) := forall t, 0 <= t ->
  P.particles n r th (P.u22 n (ring n) w0 K0 K1 (fun k => r k t) (fun k => th k t)) t.
Definition exponentially_stable n m w0 K0 K1 := exists d A q, 0 < d /\ 0 < A /\ 0 < q /\ forall r th, motion22 n w0 K0 K1 r th ->
  forall e, e <= d -> pattern_within n m w0 (fun k => r k 0) (fun k => th k 0) e ->
  forall t, 0 <= t -> pattern_within n m w0 (fun k => r k t) (fun k => th k t) (A * exp (- q * t) * e).
Definition unstable n m w0 K0 K1 := exists e, 0 < e /\ forall d, 0 < d -> exists r th, motion22 n w0 K0 K1 r th /\
  pattern_within n m w0 (fun k => r k 0) (fun k => th k 0) d /\ exists t, 0 <= t /\ ~ pattern_within n m w0 (fun k => r k t) (fun k => th k t) e.
Definition cyclic_1 : Prop := forall n m w0 K0 K1, (3 <= n)%nat -> w0 <> 0 -> 0 < K0 ->
  (exponentially_stable n m w0 K0 K1 <-> K1 * cos (2 * PI * IZR m / INR n) < 0).
Definition cyclic_2 : Prop := forall n m w0 K0 K1, (3 <= n)%nat -> w0 <> 0 -> 0 < K0 -> 0 < K1 * cos (2 * PI * IZR m / INR n) -> unstable n m w0 K0 K1.

(* ---- the theorems prove them ---- *)
Lemma volume_is n a b : volume n a b = tanner2_appendix.Product n (fun i => b i - a i).
Proof. induction n; [reflexivity|]. cbn. now rewrite IHn. Qed.
Lemma null_is n Z : null n Z <-> tanner2_appendix.null n Z.
Proof.
  split; intros N e He; destruct (N e He) as (a & b & A & B & S); exists a, b; (split; [exact A|]; split; [exact B|]); intros m.
  - rewrite (Sum_ext m _ (fun k => volume n (a k) (b k))); [apply S|]. intros k _. symmetry. apply volume_is.
  - rewrite (Sum_ext m _ (fun k => tanner2_appendix.Product n (fun i => b k i - a k i))); [apply S|]. intros k _. apply volume_is.
Qed.
Lemma K_is n f x z : tanner2_appendix.K n f x z <-> K n f x z.
Proof.
  split.
  - intros H Z d e HZ Hd He. destruct (H d Z Hd (proj1 (null_is n Z) HZ) e He) as (m & c & y & A & S & L).
    assert (Pts : exists q : nat -> nat -> R, forall k, (k < m)%nat -> inclusions.near n d (q k) x /\ ~ Z (q k) /\ forall i, (i < n)%nat -> y k i = f (q k) i).
    { clear S L. induction m as [|m IH]; [exists (fun _ _ => 0); intros; lia|]. destruct IH as [q Q]; [intros k Hk; apply A; lia|].
      destruct (proj2 (A m ltac:(lia))) as [p Hp]. exists (fun k => if Nat.eqb k m then p else q k). intros k Hk. destruct (Nat.eqb_spec k m) as [->|Nk]; [exact Hp|apply Q; lia]. }
    destruct Pts as [q Q]. exists m, c, q. split; [intros k Hk; now apply A|]. split; [exact S|]. split.
    + intros k Hk. destruct (Q k Hk) as (Q1 & Q2 & _). split; [exact Q2|exact Q1].
    + intros i Hi. rewrite <- Rabs_Ropp. eapply Rle_lt_trans; [|apply (L i Hi)]. right. f_equal.
      rewrite (Sum_ext m (fun k => c k * f (q k) i) (fun k => c k * y k i)); [ring|]. intros k Hk. now rewrite (proj2 (proj2 (Q k Hk)) i Hi).
  - intros H d Z Hd HZ e He. destruct (H Z d e (proj2 (null_is n Z) HZ) Hd He) as (m & c & y & C0 & S1 & Y & L). exists m, c, (fun k => f (y k)). split; [|split; [exact S1|]].
    + intros k Hk. split; [now apply C0|]. exists (y k). destruct (Y k Hk) as [Y1 Y2]. split; [exact Y2|]. split; [exact Y1|reflexivity].
    + intros i Hi. rewrite Rabs_minus_sym. now apply L.
Qed.
Lemma def4_2_holds : def4_2.
Proof.
  intros n f M x0 E B. destruct (tanner2_existence.filippov_exists n f M x0 B) as (x & S & A & N & HN & D). exists x. split; [exact S|]. split.
  - intros b i Hb Hi e He. exact (A i Hi b e Hb He).
  - exists N. split; [exact HN|]. intros t Ht Nt. destruct (D t Ht Nt) as (z & Hz & Dz). exists z. split; [now apply K_is|exact Dz].
Qed.

(* rates and derivatives *)
Lemma of_derivative f t l : is_derive f t l -> forall e, 0 < e -> exists d, 0 < d /\ forall s, Rabs (s - t) < d -> Rabs (f s - f t - (s - t) * l) <= e * Rabs (s - t).
Proof.
  intros D e He. apply is_derive_Reals in D. destruct (D e He) as [d Hd]. exists d. split; [apply cond_pos|]. intros s Hs. destruct (Req_dec s t) as [->|Ne].
  - replace (f t - f t - (t - t) * l) with 0 by ring. rewrite Rminus_diag_eq, Rabs_R0 by reflexivity. lra.
  - specialize (Hd (s - t) ltac:(lra) Hs). replace (t + (s - t)) with s in Hd by ring.
    replace (f s - f t - (s - t) * l) with (((f s - f t) / (s - t) - l) * (s - t)) by (field; lra). rewrite Rabs_mult. apply Rmult_le_compat_r; [apply Rabs_pos|lra].
Qed.
Lemma to_derivative f t l : (forall e, 0 < e -> exists d, 0 < d /\ forall s, Rabs (s - t) < d -> Rabs (f s - f t - (s - t) * l) <= e * Rabs (s - t)) -> is_derive f t l.
Proof.
  intros H. apply is_derive_Reals. intros e He. destruct (H (e / 2) ltac:(lra)) as (d & Hd & L). exists (mkposreal d Hd). intros h Nh Hh. cbn in Hh.
  specialize (L (t + h)). replace (t + h - t) with h in L by ring. specialize (L Hh). replace ((f (t + h) - f t) / h - l) with ((f (t + h) - f t - h * l) / h) by (field; exact Nh).
  unfold Rdiv at 1. rewrite Rabs_mult, Rabs_inv. pose proof (Rabs_pos_lt h Nh) as Ph. apply Rle_lt_trans with (e / 2); [|lra].
  apply Rmult_le_reg_r with (Rabs h); [exact Ph|]. rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra. exact L.
Qed.
Lemma parts z : Rabs (fst z) <= Cmod z /\ Rabs (snd z) <= Cmod z.
Proof. pose proof (Rmax_Cmod z) as H. split; eapply Rle_trans; [apply Rmax_l|exact H|apply Rmax_r|exact H]. Qed.
Lemma to_velocity z t w : (forall e, 0 < e -> exists d, 0 < d /\ forall s, Rabs (s - t) < d -> Cmod (z s - z t - RtoC (s - t) * w)%C <= e * Rabs (s - t)) -> is_velocity z t w.
Proof.
  intros H. split; apply to_derivative; intros e He; destruct (H e He) as (d & Hd & L); exists d; (split; [exact Hd|]); intros s Hs; eapply Rle_trans; [|apply L, Hs| |apply L, Hs].
  - eapply Rle_trans; [|apply (proj1 (parts _))]. right. f_equal. cbn. ring.
  - eapply Rle_trans; [|apply (proj2 (parts _))]. right. f_equal. cbn. ring.
Qed.
Lemma of_velocity z t w : is_velocity z t w -> forall e, 0 < e -> exists d, 0 < d /\ forall s, Rabs (s - t) < d -> Cmod (z s - z t - RtoC (s - t) * w)%C <= e * Rabs (s - t).
Proof.
  intros [A B] e He. destruct (of_derivative _ _ _ A (e / 2) ltac:(lra)) as (d1 & H1 & L1). destruct (of_derivative _ _ _ B (e / 2) ltac:(lra)) as (d2 & H2 & L2).
  exists (Rmin d1 d2). split; [now apply Rmin_glb_lt|]. intros s Hs. pose proof (Rmin_l d1 d2) as M1. pose proof (Rmin_r d1 d2) as M2.
  specialize (L1 s ltac:(lra)). specialize (L2 s ltac:(lra)). eapply Rle_trans; [apply paley_convergence.Cmod_le|].
  replace (fst _) with (fst (z s) - fst (z t) - (s - t) * fst w) by (cbn; ring). replace (snd _) with (snd (z s) - snd (z t) - (s - t) * snd w) by (cbn; ring). lra.
Qed.
Lemma velocity_rate z t w : is_velocity z t w -> rate z t w.
Proof. intros H e He. destruct (of_velocity z t w H e He) as (d & Hd & L). exists d. split; [exact Hd|]. intros s _. apply L. Qed.
(* before 0 with the velocity at 0 *)
Definition back (z : R -> C) (w : C) (t : R) : C := if Rlt_dec t 0 then (z 0 + RtoC t * w)%C else z t.
Lemma back_is z w t : 0 <= t -> back z w t = z t.
Proof. intros H. unfold back. destruct (Rlt_dec t 0); [lra|reflexivity]. Qed.
Lemma back_rate z w0 t w : 0 < t \/ t = 0 /\ w = w0 -> rate z t w -> 0 <= t -> is_velocity (back z w0) t w.
Proof.
  intros H R0 Ht. apply to_velocity. intros e He. destruct (R0 e He) as (d & Hd & L). destruct H as [H|[-> ->]].
  - exists (Rmin d t). split; [now apply Rmin_glb_lt|]. intros s Hs. pose proof (Rmin_l d t) as M1. pose proof (Rmin_r d t) as M2.
    assert (0 <= s) by (apply Rabs_def2 in Hs; lra). rewrite !back_is by lra. apply L; lra.
  - exists d. split; [exact Hd|]. intros s Hs. rewrite (back_is z w0 0) by lra. destruct (Rlt_dec s 0) as [N|N].
    + unfold back. destruct (Rlt_dec s 0); [|lra]. replace (_ - _ - _)%C with (RtoC 0); [rewrite Cmod_0; apply Rmult_le_pos; [lra|apply Rabs_pos]|].
      apply injective_projections; cbn; ring.
    + rewrite back_is by lra. apply L; lra.
Qed.
Lemma ac_joined b z : continuous_absolutely_2 b z -> forall e, 0 < e -> exists d, 0 < d /\ forall m (p q : nat -> R),
  (forall k, (k < m)%nat -> 0 <= p k <= q k /\ q k <= b) -> (forall k, (S k < m)%nat -> q k <= p (S k)) ->
  Sum m (fun k => q k - p k) < d -> Sum m (fun k => Cmod (z (q k) - z (p k))%C) < e.
Proof.
  intros [A B] e He. destruct (A (e / 2) ltac:(lra)) as (d1 & H1 & L1). destruct (B (e / 2) ltac:(lra)) as (d2 & H2 & L2).
  exists (Rmin d1 d2). split; [now apply Rmin_glb_lt|]. intros m p q P1 P2 P3. pose proof (Rmin_l d1 d2) as M1. pose proof (Rmin_r d1 d2) as M2.
  specialize (L1 m p q P1 P2 ltac:(lra)). specialize (L2 m p q P1 P2 ltac:(lra)).
  apply Rle_lt_trans with (Sum m (fun k => Rabs (fst (z (q k)) - fst (z (p k)))) + Sum m (fun k => Rabs (snd (z (q k)) - snd (z (p k))))); [|lra].
  rewrite <- Sum_plus. apply Sum_le. intros k _. apply (paley_convergence.Cmod_le (z (q k) - z (p k))%C).
Qed.
Lemma ac_split b z : (forall e, 0 < e -> exists d, 0 < d /\ forall m (p q : nat -> R),
  (forall k, (k < m)%nat -> 0 <= p k <= q k /\ q k <= b) -> (forall k, (S k < m)%nat -> q k <= p (S k)) ->
  Sum m (fun k => q k - p k) < d -> Sum m (fun k => Cmod (z (q k) - z (p k))%C) < e) -> continuous_absolutely_2 b z.
Proof.
  intros H. split; intros e He; destruct (H e He) as (d & Hd & L); exists d; (split; [exact Hd|]); intros m p q P1 P2 P3;
    (eapply Rle_lt_trans; [|apply (L m p q P1 P2 P3)]); apply Sum_le; intros k _; [apply (proj1 (parts (z (q k) - z (p k))%C))|apply (proj2 (parts (z (q k) - z (p k))%C))].
Qed.
Lemma zero_negligible : T.negligible (fun t => t = 0).
Proof. apply (tanner2_filippov.negligible_isolated (fun t => t = 0)). intros t ->. split; [lra|]. exists 1. split; [lra|]. intros s -> _. reflexivity. Qed.
(* K10 depends on the state of the n agents only *)
Lemma until_is n V' R0 S r v : solution10 n V' R0 (before S) r v ->
  T.motion10_until S n V' R0 (fun i => back (r i) (v i 0)) (fun i => back (v i) 0%C).
Proof.
  intros (A & D & C1 & N & HN & F). assert (Z : forall (z : nat -> R -> C) (w : nat -> C) t, 0 <= t -> (fun i => back (z i) (w i) t) = (fun i => z i t)).
  { intros z w t Ht. apply FunctionalExtensionality.functional_extensionality. intros i. now apply back_is. }
  split; [|split; [|split]].
  - now rewrite (Z r (fun i => v i 0) 0 ltac:(lra)).
  - intros t i Ht Hi. cbv beta. rewrite back_is by lra. apply back_rate; [|apply D; assumption|lra]. destruct (Req_dec t 0) as [->|Ne]; [right; now split|left; lra].
  - intros i Hi b e Hb He. destruct (ac_joined b (v i) (C1 b i ltac:(split; lra) Hi) e He) as (d & Hd & L). exists d. split; [exact Hd|]. intros m p q P1 P2 P3.
    eapply Rle_lt_trans; [|apply (L m p q P1 P2 P3)]. right. apply Sum_ext. intros k Hk. destruct (P1 k Hk). rewrite !back_is by lra. reflexivity.
  - exists (fun t => N t \/ t = 0). split; [apply tanner2_filippov.negligible_or; [exact HN|exact zero_negligible]|]. intros t Ht Nt At.
    rewrite (Z r (fun i => v i 0) t ltac:(lra)) in At. destruct (F t Ht ltac:(tauto) At) as (z & Hz & Dz). exists z.
    rewrite (Z r (fun i => v i 0) t ltac:(lra)), (Z v (fun _ => 0%C) t ltac:(lra)). split; [exact Hz|]. intros i Hi. apply back_rate; [left; tauto || (assert (t <> 0) by tauto; lra)|now apply Dz|lra].
Qed.
Lemma always_is n V' R0 r v : solution10 n V' R0 always r v -> T.motion10 n V' R0 (fun i => back (r i) (v i 0)) (fun i => back (v i) 0%C).
Proof.
  intros (A & D & C1 & N & HN & F). assert (Z : forall (z : nat -> R -> C) (w : nat -> C) t, 0 <= t -> (fun i => back (z i) (w i) t) = (fun i => z i t)).
  { intros z w t Ht. apply FunctionalExtensionality.functional_extensionality. intros i. now apply back_is. }
  split; [|split; [|split]].
  - now rewrite (Z r (fun i => v i 0) 0 ltac:(lra)).
  - intros t i Ht Hi. cbv beta. rewrite back_is by lra. apply back_rate; [|apply D; assumption|lra]. destruct (Req_dec t 0) as [->|Ne]; [right; now split|left; lra].
  - intros i Hi b e Hb He. destruct (ac_joined b (v i) (C1 b i ltac:(unfold always; lra) Hi) e He) as (d & Hd & L). exists d. split; [exact Hd|]. intros m p q P1 P2 P3.
    eapply Rle_lt_trans; [|apply (L m p q P1 P2 P3)]. right. apply Sum_ext. intros k Hk. destruct (P1 k Hk). rewrite !back_is by lra. reflexivity.
  - exists (fun t => N t \/ t = 0). split; [apply tanner2_filippov.negligible_or; [exact HN|exact zero_negligible]|]. intros t Ht Nt At.
    rewrite (Z r (fun i => v i 0) t ltac:(lra)) in At. destruct (F t Ht ltac:(tauto) At) as (z & Hz & Dz). exists z.
    rewrite (Z r (fun i => v i 0) t ltac:(lra)), (Z v (fun _ => 0%C) t ltac:(lra)). split; [exact Hz|]. intros i Hi. apply back_rate; [left; assert (t <> 0) by tauto; lra|now apply Dz|lra].
Qed.
Lemma of_motion10 n V' R0 r v : T.motion10 n V' R0 r v -> solution10 n V' R0 always r v.
Proof.
  intros (A & D & C1 & N & HN & F). split; [exact A|]. split; [intros t i Ht Hi; apply velocity_rate; now apply D|]. split.
  - intros b i Hb Hi. unfold always in Hb. apply ac_split. intros e He. destruct (C1 i Hi (b + 1) e ltac:(lra) He) as (d & Hd & L). exists d. split; [exact Hd|].
    intros m p q P1 P2 P3. apply (L m p q); [|exact P2|exact P3]. intros k Hk. destruct (P1 k Hk). split; [assumption|lra].
  - exists N. split; [exact HN|]. intros t Ht Nt At. destruct (F t Ht Nt At) as (z & Hz & Dz). exists z. split; [exact Hz|]. intros i Hi. apply velocity_rate. now apply Dz.
Qed.
Lemma eq10_3_holds : eq10_3.
Proof.
  intros n V V' R0 r0 v0 HR P A. destruct (tanner2_solutions.solution_from n V V' R0 r0 v0 HR P A) as (r & v & S & M). exists r, v. split; [now apply of_motion10|]. split; [|exact S].
  destruct (tanner2_filippov.kept_apart n V V' R0 r v HR P M) as (d & Hd & Far). intros t Ht i j Hi Hj B E. unfold complete in B.
  assert (Ne : i <> j) by (intros ->; now rewrite PeanoNat.Nat.eqb_refl in B). specialize (Far t i j Ht Hi Hj Ne). cbv beta in E. rewrite E in Far.
  replace (r j t - r j t)%C with (RtoC 0) in Far by ring. rewrite Cmod_0 in Far. lra.
Qed.
Lemma lipschitz_is n V' : (forall i j, (i < n)%nat -> (j < n)%nat -> i <> j -> gradient_lipschitz (V' i j)) -> tanner2_unique.lipschitz_gradients n V'.
Proof.
  intros L j k Hj Hk Ne a Na. destruct (L j k Hj Hk Ne a Na) as (d & B & Hd & HB). assert (Pa : 0 < Cmod a) by now apply Cmod_gt_0.
  exists (Rmin d (Cmod a)), (Rabs B + 1). split; [now apply Rmin_glb_lt|]. split; [pose proof (Rabs_pos B); lra|]. intros z y Hz Hy.
  pose proof (Rmin_l d (Cmod a)) as M3. pose proof (Rmin_r d (Cmod a)) as M4.
  assert (N0 : forall x : C, Cmod (x - a)%C < Rmin d (Cmod a) -> x <> 0%C).
  { intros x Hx ->. replace (0 - a)%C with (- a)%C in Hx by ring. rewrite Cmod_opp in Hx. lra. }
  unfold tanner2_unique.pair_gradient. eapply Rle_trans; [apply (HB z y (N0 z Hz) (N0 y Hy)); lra|]. apply Rmult_le_compat_r; [apply Cmod_ge_0|]. pose proof (Rle_abs B); lra.
Qed.
Lemma eq10_4_holds : eq10_4.
Proof.
  intros n V V' R0 S r v q u HR P L M1 M2 E Tie t i Ht Hi. pose proof (lipschitz_is n V' L) as Lip.
  destruct (tanner2_unique.unique_across n V V' R0 S _ _ _ _ HR P Lip (until_is _ _ _ _ _ _ M1) (until_is _ _ _ _ _ _ M2)) with (t := t) (i := i) as [Er Ev]; try assumption.
  - intros j Hj. rewrite !back_is by lra. now apply E.
  - intros s j k Hs Hj Hk Ne. rewrite !back_is by lra. now apply Tie.
  - rewrite !back_is in Er, Ev by lra. now split.
Qed.
Lemma graph_is n R0 (r v : nat -> R -> C) : (forall t, 0 <= t -> strongly_connected n (T.by_distance (fun i => r i t) R0)) ->
  forall t, 0 <= t -> strongly_connected n (T.by_distance (fun i => back (r i) (v i 0) t) R0).
Proof.
  intros C1 t Ht. replace (fun i => back (r i) (v i 0) t) with (fun i => r i t); [now apply C1|]. apply FunctionalExtensionality.functional_extensionality. intros i. symmetry. now apply back_is.
Qed.
Lemma thm2_vel_holds : thm2_vel.
Proof.
  intros n V V' R0 r v HR P M C1 i j Hi Hj e He. destruct (tanner2_onward.all_solutions_agree n V V' R0 HR P) as [_ H].
  destruct (H _ _ (always_is _ _ _ _ _ M) (graph_is n R0 r v C1) i j Hi Hj e He) as [S HS]. exists (Rmax S 0). intros t Ht. pose proof (Rmax_l S 0) as M1. pose proof (Rmax_r S 0) as M2.
  specialize (HS t ltac:(lra)). cbv beta in HS. now rewrite !back_is in HS by lra.
Qed.
Lemma thm2_pot_holds : thm2_pot.
Proof.
  intros n V V' R0 r v HR P M C1 e He. destruct (tanner2_approach.all_solutions_approach n V V' R0 HR P) as [_ [H _]].
  destruct (H _ _ (always_is _ _ _ _ _ M) (graph_is n R0 r v C1) e He) as [S HS]. exists (Rmax S 0). split; [apply Rmax_r|]. intros t Ht. pose proof (Rmax_l S 0) as M1. pose proof (Rmax_r S 0) as M2.
  destruct (HS t ltac:(lra)) as (q & [Aq (m & c & y & Y1 & Y2 & Y3)] & D). exists q. split.
  - split; [exact Aq|]. exists m, c, y. split; [exact Y1|]. split; [exact Y2|]. intros i Hi. symmetry. now apply Y3.
  - intros i Hi. specialize (D i Hi). cbv beta in D. now rewrite back_is in D by lra.
Qed.

(* ---- minima on the complete graph ---- *)
Lemma within_is n z e q : within n z e q <-> tanner2_minima.near_orbit n e z q.
Proof. split; intros (a & A & H); exists a; (split; [exact A|]); intros i j Hi Hj; specialize (H i j Hi Hj); replace (a * (z i - z j))%C with (a * z i - a * z j)%C in * by ring; exact H. Qed.
Lemma flocks_is n z e q u : flocks_within n z e q u <-> tanner2_minima.close_to n z e q u.
Proof. unfold flocks_within, tanner2_minima.close_to. now rewrite within_is. Qed.
Lemma ordered_pairs n (f : nat -> nat -> R) : (forall i j, f i j = f j i) -> Sum n (fun i => Sum n (fun j => if PeanoNat.Nat.eqb i j then 0 else f i j)) = 2 * Sum n (fun i => Sum i (f i)).
Proof.
  intros S. induction n as [|n IH]; [cbn; ring|]. cbn [Sum]. rewrite PeanoNat.Nat.eqb_refl, Rplus_0_r, Rmult_plus_distr_l, <- IH.
  rewrite Sum_plus, (Sum_ext n (fun i => if PeanoNat.Nat.eqb i n then 0 else f i n) (f n)), (Sum_ext n (fun j => if PeanoNat.Nat.eqb n j then 0 else f n j) (f n)); [ring| |];
    intros i Hi; [destruct (PeanoNat.Nat.eqb_spec n i); [lia|reflexivity]|destruct (PeanoNat.Nat.eqb_spec i n); [lia|apply S]].
Qed.
Lemma sum_V_is n V q : (forall i j x, V i j x = V j i x) -> tanner2_apart.sum_of_all n (tanner2_filippov.both V) q = 2 * sum_V n V q.
Proof.
  intros VS. unfold tanner2_apart.sum_of_all, sum_V. rewrite ordered_pairs.
  - f_equal. apply Sum_ext. intros i _. apply Sum_ext. intros j _. now rewrite T.both_V.
  - intros i j. rewrite (tanner2_filippov.both_sym V i j). unfold tanner_energy.norm. f_equal. rewrite <- Cmod_opp. f_equal. ring.
Qed.
Lemma grad_both n V V' q i : T.potentials n complete V V' -> T.apart_at n complete q -> (i < n)%nat -> tanner_energy.grad_i n complete (tanner2_filippov.both V') q i = T.gradV n complete V' q i.
Proof.
  intros P A Hi. rewrite <- T.gradV_is. apply (T.both_law n complete V V' q q i); [apply tanner2_minima.simple_complete|apply P|now apply T.slopes_of|exact Hi|exact A].
Qed.
Lemma sec4_flocking_holds : sec4_flocking.
Proof.
  intros n V V' z Hn P A (d & Hd & Mn) (d' & Hd' & Is). assert (Sy : undirected complete) by apply tanner2_minima.simple_complete.
  destruct (T.potentials_are n complete _ _ (T.one_of n complete V V' Sy P)) as (VS & VS' & Pot & C1).
  assert (Min : tanner2_apart.strict_minimum n (tanner2_filippov.both V) z).
  { exists (d / 2). split; [lra|]. intros q Nq. assert (Wq : within n z d q).
    { exists 1%C. split; [apply Cmod_1|]. intros i j Hi Hj. replace (q i - q j - 1 * (z i - z j))%C with ((q i - z i) + - (q j - z j))%C by ring. eapply Rle_lt_trans; [apply Cmod_triangle|]. rewrite Cmod_opp.
      pose proof (Nq i Hi). pose proof (Nq j Hj). unfold tanner_energy.norm in *. lra. }
    assert (Az : tanner2_apart.all_apart n z) by (now apply tanner2_minima.apart_distinct).
    unfold tanner2_apart.not_above, tanner2_apart.below. rewrite !sum_V_is by apply P. destruct (classic (turned n z q)) as [(a & c & Ha & E)|Nt].
    - split; [|right; now exists a, c]. intros _. split; [exact Az|]. right. f_equal. apply Sum_ext. intros i Hi. apply Sum_ext. intros j Hj. rewrite (E i Hi), (E j ltac:(lia)). f_equal.
      replace (a * z i + c - (a * z j + c))%C with (a * (z i - z j))%C by ring. rewrite Cmod_mult, Ha. ring.
    - assert (L : tanner2_apart.all_apart n q -> sum_V n V z < sum_V n V q) by (intros Q; apply Mn; [now apply tanner2_minima.apart_distinct|exact Wq|exact Nt]).
      split; [|left]; intros Q; (split; [exact Az|]); specialize (L Q); lra. }
  assert (Iso : tanner2_minima.isolated n (tanner2_filippov.both V') z).
  { exists d'. split; [exact Hd'|]. intros q Nq Aq G. apply Is; [now apply tanner2_minima.apart_distinct|now apply within_is|]. intros i Hi. rewrite <- (grad_both n V V' q i P); [now apply G|now apply tanner2_minima.apart_distinct|exact Hi]. }
  destruct (tanner2_minima.minima_attract n _ _ z Hn VS VS' Pot C1 Min Iso) as (Eq & _ & St & At).
  assert (Mo : forall r v, T.motion n complete V' r v -> tanner2_minima.motion n (tanner2_filippov.both V') r v) by (intros r v M; apply T.moves_is; now apply (T.motion_both n complete V V')).
  split; [|split].
  - intros q w (a & c & Ha & E). assert (Aq : forall t, T.apart_at n complete (fun i => q i + RtoC t * w)%C).
    { intros t i j Hi Hj L X. apply (A i j Hi Hj L). assert (Z : (a * (z i - z j))%C = 0%C).
      { transitivity (a * z i + c + RtoC t * w - (a * z j + c + RtoC t * w))%C; [ring|]. rewrite <- (E i Hi), <- (E j Hj), X. ring. }
      apply (f_equal Cmod) in Z. rewrite Cmod_mult, Ha, Cmod_0, Rmult_1_l in Z. apply Cmod_eq_0 in Z. transitivity (z i - z j + z j)%C; [ring|]. rewrite Z. ring. }
    split; [apply Aq|]. intros t i Ht Hi. destruct (Eq q w (ex_intro _ a (ex_intro _ c (conj Ha E))) t) as [E1 E2]. split; [now apply E1|]. intros _. specialize (E2 (Aq t) i Hi). rewrite <- T.law4_is in E2.
    destruct (T.both_law n complete V V' (fun k => q k + RtoC t * w)%C (fun _ => w) i Sy (proj1 P) (T.slopes_of n complete V V' P) Hi (Aq t)) as (_ & _ & X). rewrite X in E2. exact E2.
  - intros e He. destruct (St e He) as (k & Hk & H). exists k. split; [exact Hk|]. intros r v M F t Ht. apply flocks_is. apply (H r v (Mo r v M)); [now apply flocks_is|exact Ht].
  - destruct At as (k & Hk & H). exists k. split; [exact Hk|]. intros r v M F e He. destruct (H r v (Mo r v M)) with (e := e) as [S Q]; [now apply flocks_is|exact He|]. exists S. intros t Ht. apply flocks_is. now apply Q.
Qed.

(* ---- formations: within d, and the squares of all differences ---- *)
Lemma ring_is n j k : (3 <= n)%nat -> (j < n)%nat -> (k < n)%nat -> paley_formations.cycle_graph n k j = ring n k j.
Proof.
  intros Hn Hj Hk. unfold paley_formations.cycle_graph, paley_fourier.ring_graph, paley_fourier.ring_offset, ring.
  rewrite (proj2 (PeanoNat.Nat.ltb_lt k n) Hk), (proj2 (PeanoNat.Nat.ltb_lt j n) Hj). cbn [andb].
  assert (S : forall i, (i < n)%nat -> ((i + 1) mod n = if Nat.eqb (i + 1) n then 0 else i + 1)%nat).
  { intros i Hi. destruct (PeanoNat.Nat.eqb_spec (i + 1) n) as [->|Ne]; [apply PeanoNat.Nat.mod_same; lia|apply PeanoNat.Nat.mod_small; lia]. }
  assert (D : ((j + n - k) mod n = if Nat.leb k j then j - k else j + n - k)%nat).
  { destruct (PeanoNat.Nat.leb_spec k j) as [L|L]; [|apply PeanoNat.Nat.mod_small; lia]. replace (j + n - k)%nat with (j - k + 1 * n)%nat by lia.
    rewrite PeanoNat.Nat.mod_add by lia. apply PeanoNat.Nat.mod_small; lia. }
  rewrite D, (S k Hk), (S j Hj). apply Bool.eq_true_iff_eq. rewrite !Bool.orb_true_iff, !PeanoNat.Nat.eqb_eq.
  destruct (PeanoNat.Nat.leb_spec k j); destruct (PeanoNat.Nat.eqb_spec (k + 1) n); destruct (PeanoNat.Nat.eqb_spec (j + 1) n); lia.
Qed.
Lemma lap_is n k j : (3 <= n)%nat -> (k < n)%nat -> (j < n)%nat -> lap n (ring n) k j = lap n (paley_formations.cycle_graph n) k j.
Proof.
  intros Hn Hk Hj. unfold lap, deg, w. rewrite (ring_is n j k) by assumption. f_equal. f_equal. apply Sum_ext. intros i Hi. now rewrite ring_is.
Qed.
Lemma motion_is n w0 K0 K1 r th : (3 <= n)%nat -> w0 <> 0 ->
  (motion22 n w0 K0 K1 r th <-> paley_settling.shaped n (paley_formations.cycle_graph n) w0 K0 K1 r th).
Proof.
  intros Hn Hw. assert (E : forall t k, (k < n)%nat -> P.u22 n (ring n) w0 K0 K1 (fun k => r k t) (fun k => th k t) k =
    paley_particles.control5 n (paley_formations.cycle_graph n) w0 K0 K1 r th t k).
  { intros t k Hk. rewrite (paley_particles.eq22 n (paley_formations.cycle_graph n) w0 K0 K1 ltac:(lia) Hw r th t k). unfold P.u22, P.Lth. f_equal; [f_equal|].
    - f_equal. change (paley_gradient.gW n (paley_formations.cycle_graph n) (fun j => th j t) k) with
        (inner (Ci * expi (th k t))%C (Csum n (fun j => RtoC (lap n (paley_formations.cycle_graph n) k j) * expi (th j t)))%C).
      f_equal. apply Csum_ext. intros j Hj. now rewrite lap_is.
    - f_equal. unfold row. f_equal. apply Csum_ext. intros j Hj. now rewrite lap_is. }
  split.
  - intros M k t Hk Ht. rewrite <- (E t k Hk). now apply M.
  - intros M t Ht k Hk. rewrite (E t k Hk). now apply M.
Qed.
Notation spread n m w0 := (paley_formations.spread n w0 (paley_cycles.pattern n m)).
Definition G w0 := 1 + / Rabs w0.
Definition B n w0 := INR n * (INR n * (4 * G w0 ^ 2 + 4)).
Lemma dist2_is x y : dist2 x y = Cmod (x - y)%C ^ 2.
Proof. unfold dist2, Cmod. rewrite pow2_sqrt by (apply Rplus_le_le_0_compat; apply pow2_ge_0). rewrite inner_xy. ring. Qed.
Lemma G_ge1 w0 : w0 <> 0 -> 1 < G w0.
Proof. intros H. unfold G. pose proof (Rinv_0_lt_compat _ (Rabs_pos_lt w0 H)). lra. Qed.
Lemma B_pos n w0 : (3 <= n)%nat -> w0 <> 0 -> 0 < B n w0.
Proof. intros Hn H. pose proof (G_ge1 w0 H). assert (0 < INR n) by (apply lt_0_INR; lia). unfold B. apply Rmult_lt_0_compat; [lra|]. apply Rmult_lt_0_compat; [lra|]. nra. Qed.
Lemma turned_error n m w0 (r : nat -> C) th k (c : C) phi : w0 <> 0 -> let e := expi (phi + 2 * PI * IZR m * INR k / INR n) in
  Cmod (RtoC (/ w0) * (Ci * (expi (th k) - e)))%C = / Rabs w0 * Cmod (expi (th k) - e)%C.
Proof.
  intros H e. rewrite !Cmod_mult, Cmod_R, Rabs_inv. replace (Cmod Ci) with 1; [ring|]. unfold Cmod, Ci. cbn. replace (0 * (0 * 1) + 1 * (1 * 1)) with 1 by ring. now rewrite sqrt_1.
Qed.
Lemma within_spread n m w0 r th d : (3 <= n)%nat -> w0 <> 0 -> pattern_within n m w0 r th d -> 0 <= d /\ spread n m w0 r th <= B n w0 * d ^ 2.
Proof.
  intros Hn Hw (c & phi & W). assert (Hd : 0 <= d) by (eapply Rle_trans; [apply Cmod_ge_0|apply (W 0%nat); lia]). split; [exact Hd|].
  pose proof (G_ge1 w0 Hw) as G1. assert (Pc : forall k, (k < n)%nat -> Cmod (paley_particles.circle_centre w0 (r k) (th k) - c)%C <= G w0 * d).
  { intros k Hk. destruct (W k Hk) as [W1 W2]. cbv zeta in W1, W2. set (e := expi (phi + 2 * PI * IZR m * INR k / INR n)) in *.
    replace (paley_particles.circle_centre w0 (r k) (th k) - c)%C with ((r k - (c - RtoC (/ w0) * (Ci * e))) + RtoC (/ w0) * (Ci * (expi (th k) - e)))%C by (unfold paley_particles.circle_centre; ring).
    eapply Rle_trans; [apply Cmod_triangle|]. unfold e at 2. rewrite (turned_error n m w0 r th k c phi Hw). fold e. unfold G. rewrite Rmult_plus_distr_r, Rmult_1_l.
    apply Rplus_le_compat; [exact W2|]. apply Rmult_le_compat_l; [|exact W1]. left. now apply Rinv_0_lt_compat, Rabs_pos_lt. }
  assert (Pe : forall k, (k < n)%nat -> Cmod (expi (th k - paley_cycles.pattern n m k) - expi phi)%C <= d).
  { intros k Hk. destruct (W k Hk) as [W1 _]. cbv zeta in W1. fold (paley_cycles.pattern n m k) in W1. set (p := paley_cycles.pattern n m k) in *.
    replace (expi (th k - p) - expi phi)%C with (expi (- p) * (expi (th k) - expi (phi + p)))%C.
    - rewrite Cmod_mult, Cmod_expi. lra.
    - assert (E1 : expi (th k - p) = (expi (- p) * expi (th k))%C) by (rewrite <- expi_plus; f_equal; ring).
      assert (E2 : expi phi = (expi (- p) * expi (phi + p))%C) by (rewrite <- expi_plus; f_equal; ring). rewrite E1, E2. ring. }
  assert (Two : forall (x y z : C) b, Cmod (x - z)%C <= b -> Cmod (y - z)%C <= b -> Cmod (x - y)%C ^ 2 <= 4 * b ^ 2).
  { intros x y z b X Y. assert (H : Cmod (x - y)%C <= 2 * b).
    { replace (x - y)%C with ((x - z) + - (y - z))%C by ring. eapply Rle_trans; [apply Cmod_triangle|]. rewrite Cmod_opp. lra. }
    pose proof (Cmod_ge_0 (x - y)%C). replace (4 * b ^ 2) with ((2 * b) ^ 2) by ring. now apply pow_incr. }
  unfold paley_formations.spread. apply Rle_trans with (Sum n (fun _ => Sum n (fun _ => (4 * G w0 ^ 2 + 4) * d ^ 2))).
  - apply Sum_le. intros k Hk. apply Sum_le. intros j Hj. rewrite !dist2_is. pose proof (Two _ _ _ _ (Pc k Hk) (Pc j Hj)) as T1. pose proof (Two _ _ _ _ (Pe k Hk) (Pe j Hj)) as T2.
    replace ((4 * G w0 ^ 2 + 4) * d ^ 2) with (4 * (G w0 * d) ^ 2 + 4 * d ^ 2) by ring. apply Rplus_le_compat; assumption.
  - rewrite !Sum_const. unfold B. right. ring.
Qed.
Lemma spread_within n m w0 r th s : (3 <= n)%nat -> w0 <> 0 -> spread n m w0 r th <= s -> pattern_within n m w0 r th (G w0 * sqrt s).
Proof.
  intros Hn Hw S. exists (paley_particles.circle_centre w0 (r 0%nat) (th 0%nat)), (th 0%nat - paley_cycles.pattern n m 0). intros k Hk.
  assert (D0 : forall x y, 0 <= dist2 x y) by (intros; rewrite dist2_is; apply pow2_ge_0).
  assert (T : dist2 (paley_particles.circle_centre w0 (r k) (th k)) (paley_particles.circle_centre w0 (r 0%nat) (th 0%nat)) +
    dist2 (expi (th k - paley_cycles.pattern n m k)) (expi (th 0%nat - paley_cycles.pattern n m 0)) <= s).
  { eapply Rle_trans; [|exact S]. unfold paley_formations.spread.
    eapply Rle_trans; [|apply (Sum_term_le n (fun k => Sum n (fun j => dist2 (paley_particles.circle_centre w0 (r k) (th k)) (paley_particles.circle_centre w0 (r j) (th j)) +
      dist2 (expi (th k - paley_cycles.pattern n m k)) (expi (th j - paley_cycles.pattern n m j)))) k); [|exact Hk]].
    - apply (Sum_term_le n (fun j => dist2 (paley_particles.circle_centre w0 (r k) (th k)) (paley_particles.circle_centre w0 (r j) (th j)) +
        dist2 (expi (th k - paley_cycles.pattern n m k)) (expi (th j - paley_cycles.pattern n m j))) 0%nat); [|lia].
      intros j _. apply Rplus_le_le_0_compat; apply D0.
    - intros i _. apply Sum_ge0. intros j _. apply Rplus_le_le_0_compat; apply D0. }
  assert (Root : forall x y, dist2 x y <= s -> Cmod (x - y)%C <= sqrt s).
  { intros x y H. rewrite dist2_is in H. rewrite <- (sqrt_pow2 (Cmod (x - y)%C)) by apply Cmod_ge_0. now apply sqrt_le_1_alt. }
  pose proof (D0 (paley_particles.circle_centre w0 (r k) (th k)) (paley_particles.circle_centre w0 (r 0%nat) (th 0%nat))) as N1.
  pose proof (D0 (expi (th k - paley_cycles.pattern n m k)) (expi (th 0%nat - paley_cycles.pattern n m 0))) as N2.
  pose proof (Root (paley_particles.circle_centre w0 (r k) (th k)) (paley_particles.circle_centre w0 (r 0%nat) (th 0%nat)) ltac:(lra)) as R1.
  pose proof (Root (expi (th k - paley_cycles.pattern n m k)) (expi (th 0%nat - paley_cycles.pattern n m 0)) ltac:(lra)) as R2.
  cbv zeta. fold (paley_cycles.pattern n m k). set (p := paley_cycles.pattern n m k) in *. set (phi := th 0%nat - paley_cycles.pattern n m 0) in *.
  assert (E : Cmod (expi (th k) - expi (phi + p))%C <= sqrt s).
  { replace (expi (th k) - expi (phi + p))%C with (expi p * (expi (th k - p) - expi phi))%C.
    - rewrite Cmod_mult, Cmod_expi. lra.
    - assert (E1 : expi (th k) = (expi p * expi (th k - p))%C) by (rewrite <- expi_plus; f_equal; ring).
      assert (E2 : expi (phi + p) = (expi p * expi phi)%C) by (rewrite <- expi_plus; f_equal; ring). rewrite E1, E2. ring. }
  pose proof (G_ge1 w0 Hw) as G1. pose proof (sqrt_pos s) as Sp. split; [nra|].
  replace (r k - _)%C with ((paley_particles.circle_centre w0 (r k) (th k) - paley_particles.circle_centre w0 (r 0%nat) (th 0%nat)) + - (RtoC (/ w0) * (Ci * (expi (th k) - expi (phi + p)))))%C by (unfold paley_particles.circle_centre; ring).
  eapply Rle_trans; [apply Cmod_triangle|]. rewrite Cmod_opp. unfold p, paley_cycles.pattern. rewrite (turned_error n m w0 r th k 0%C phi Hw).
  unfold p, paley_cycles.pattern in E. unfold G. rewrite Rmult_plus_distr_r, Rmult_1_l. apply Rplus_le_compat; [exact R1|]. apply Rmult_le_compat_l; [|exact E].
  left. now apply Rinv_0_lt_compat, Rabs_pos_lt.
Qed.
Lemma within_more n m w0 r th d d' : d <= d' -> pattern_within n m w0 r th d -> pattern_within n m w0 r th d'.
Proof. intros L (c & phi & W). exists c, phi. intros k Hk. destruct (W k Hk). cbv zeta in *. split; lra. Qed.
Lemma stable_is n m w0 K0 K1 : (3 <= n)%nat -> w0 <> 0 ->
  (exponentially_stable n m w0 K0 K1 <-> paley_cycles.exponentially_stable n (paley_formations.cycle_graph n) w0 K0 K1 (paley_cycles.pattern n m)).
Proof.
  intros Hn Hw. pose proof (G_ge1 w0 Hw) as G1. pose proof (B_pos n w0 Hn Hw) as B1. split.
  - intros (d & A & q & Hd & HA & Hq & H). exists ((d / G w0) ^ 2), (B n w0 * A ^ 2 * G w0 ^ 2), (2 * q).
    assert (Pd : 0 < d / G w0) by (apply Rdiv_lt_0_compat; lra). split; [now apply pow_lt|]. split.
    { pose proof (pow_lt A 2 HA). pose proof (pow_lt (G w0) 2 ltac:(lra)). apply Rmult_lt_0_compat; [now apply Rmult_lt_0_compat|assumption]. }
    split; [lra|].
    intros r th M S t Ht. apply (motion_is n w0 K0 K1 r th Hn Hw) in M. set (s := spread n m w0 (fun k => r k 0) (fun k => th k 0)) in *.
    assert (S0 : 0 <= s). { unfold s, paley_formations.spread. apply Sum_ge0. intros i _. apply Sum_ge0. intros j _. rewrite !dist2_is. apply Rplus_le_le_0_compat; apply pow2_ge_0. }
    assert (Rs : sqrt s <= d / G w0). { rewrite <- (sqrt_pow2 (d / G w0)) by lra. apply sqrt_le_1_alt. lra. }
    assert (Ls : G w0 * sqrt s <= d). { apply Rmult_le_compat_l with (r := G w0) in Rs; [|lra]. replace (G w0 * (d / G w0)) with d in Rs by (field; lra). exact Rs. }
    pose proof (H r th M _ Ls (spread_within n m w0 _ _ s Hn Hw (Rle_refl s)) t Ht) as Wt. destruct (within_spread n m w0 _ _ _ Hn Hw Wt) as [_ L].
    eapply Rle_trans; [exact L|]. right. replace (- (2 * q) * t) with (- q * t + - q * t) by ring. rewrite exp_plus. rewrite !Rpow_mult_distr, pow2_sqrt by exact S0. ring.
  - intros (e & A & q & He & HA & Hq & H). exists (Rmin 1 (e / (2 * B n w0))), (G w0 * sqrt (A * B n w0)), (q / 2).
    assert (Pe : 0 < e / (2 * B n w0)) by (apply Rdiv_lt_0_compat; lra). split; [apply Rmin_glb_lt; lra|]. split.
    { apply Rmult_lt_0_compat; [lra|]. apply sqrt_lt_R0. now apply Rmult_lt_0_compat. }
    split; [lra|]. intros r th M d Hd W t Ht. apply (motion_is n w0 K0 K1 r th Hn Hw) in M. destruct (within_spread n m w0 _ _ _ Hn Hw W) as [D0 L].
    pose proof (Rmin_l 1 (e / (2 * B n w0))) as M1. pose proof (Rmin_r 1 (e / (2 * B n w0))) as M2.
    assert (Small : B n w0 * d ^ 2 < e).
    { apply Rle_lt_trans with (B n w0 * d); [apply Rmult_le_compat_l; [lra|nra]|]. apply Rle_lt_trans with (B n w0 * (e / (2 * B n w0))); [apply Rmult_le_compat_l; lra|].
      replace (B n w0 * (e / (2 * B n w0))) with (e / 2) by (field; lra). lra. }
    pose proof (H r th M ltac:(lra) t Ht) as St. pose proof (exp_pos (- q * t)) as X.
    assert (St2 : spread n m w0 (fun k => r k t) (fun k => th k t) <= A * B n w0 * (exp (- (q / 2) * t) * d) ^ 2).
    { eapply Rle_trans; [exact St|]. replace ((exp (- (q / 2) * t) * d) ^ 2) with (exp (- (q / 2) * t) * exp (- (q / 2) * t) * d ^ 2) by ring. rewrite <- exp_plus.
      replace (- (q / 2) * t + - (q / 2) * t) with (- q * t) by field. replace (A * B n w0 * (exp (- q * t) * d ^ 2)) with (A * (B n w0 * d ^ 2) * exp (- q * t)) by ring.
      apply Rmult_le_compat_r; [lra|]. apply Rmult_le_compat_l; lra. }
    apply (within_more n m w0 _ _ (G w0 * sqrt (A * B n w0 * (exp (- (q / 2) * t) * d) ^ 2))); [|now apply spread_within].
    rewrite sqrt_mult_alt by (apply Rmult_le_pos; lra). rewrite sqrt_pow2 by (apply Rmult_le_pos; [left; apply exp_pos|lra]). right. ring.
Qed.
Lemma cyclic_1_holds : cyclic_1.
Proof. intros n m w0 K0 K1 Hn Hw HK. rewrite stable_is by assumption. apply (paley_cycles.cyclic_patterns n m w0 K0 K1 Hn Hw HK). Qed.
Lemma cyclic_2_holds : cyclic_2.
Proof.
  intros n m w0 K0 K1 Hn Hw HK Pos. destruct (paley_cycles.cyclic_patterns n m w0 K0 K1 Hn Hw HK) as (Last & _ & U). destruct (U Pos) as (e & He & H).
  pose proof (G_ge1 w0 Hw) as G1. pose proof (B_pos n w0 Hn Hw) as B1. exists (Rmin 1 (e / (2 * B n w0))).
  assert (Pe : 0 < e / (2 * B n w0)) by (apply Rdiv_lt_0_compat; lra). split; [apply Rmin_glb_lt; lra|]. intros d Hd.
  assert (Pd : 0 < d / G w0) by (apply Rdiv_lt_0_compat; lra). destruct (H ((d / G w0) ^ 2) (pow_lt _ 2 Pd)) as (r0 & th0 & S & Go).
  destruct (Last r0 th0) as (r & th & Bg & M). exists r, th. split; [now apply motion_is|]. split.
  - assert (W : pattern_within n m w0 r0 th0 d).
    { apply (within_more n m w0 _ _ (G w0 * sqrt ((d / G w0) ^ 2))); [|apply spread_within; [exact Hn|exact Hw|lra]]. rewrite sqrt_pow2 by lra. right. field. lra. }
    destruct W as (c & phi & W). exists c, phi. intros k Hk. destruct (Bg k Hk) as [-> ->]. now apply W.
  - destruct (Go r th M Bg) as (t & Ht & Far). exists t. split; [exact Ht|]. intros W. destruct (within_spread n m w0 _ _ _ Hn Hw W) as [D0 L].
    set (x := Rmin 1 (e / (2 * B n w0))) in *. pose proof (Rmin_l 1 (e / (2 * B n w0)) : x <= _) as M1. pose proof (Rmin_r 1 (e / (2 * B n w0)) : x <= _) as M2.
    assert (B n w0 * x ^ 2 < e); [|lra]. apply Rle_lt_trans with (B n w0 * x); [apply Rmult_le_compat_l; [lra|nra]|].
    apply Rle_lt_trans with (B n w0 * (e / (2 * B n w0))); [apply Rmult_le_compat_l; lra|]. replace (B n w0 * (e / (2 * B n w0))) with (e / 2) by (field; lra). lra.
Qed.

(* ---- the whole vector field ---- *)
Lemma K10_whole_holds : K10_whole.
Proof. intros n V V' R0 r v w HR P A. rewrite <- K_is. exact (tanner2_field.K_is_K10 n V V' R0 r v w HR P A). Qed.
Lemma whole_is n V' R0 x : whole n V' R0 x <-> tanner2_definition4.solution_always n V' R0 x.
Proof.
  split; intros [A (C1 & N & HN & F)]; (split; [exact A|]; split; [|exists N; split; [exact HN|]; intros t Ht Nt; destruct (F t Ht Nt) as (z & Kz & Dz); exists z; split; [now apply K_is|exact Dz]]).
  - intros i Hi b e Hb. now apply (C1 b i Hb Hi).
  - intros b i Hb Hi e. now apply (C1 i Hi b e Hb).
Qed.
Lemma whole_before_is S n V' R0 x : whole_before S n V' R0 x <-> tanner2_definition4.solution_until S n V' R0 x.
Proof.
  split; intros [A (C1 & N & HN & F)]; (split; [exact A|]; split; [|exists N; split; [exact HN|]; intros t Ht Nt; destruct (F t Ht Nt) as (z & Kz & Dz); exists z; split; [now apply K_is|exact Dz]]).
  - intros i Hi b e Hb. now apply (C1 b i Hb Hi).
  - intros b i Hb Hi e. now apply (C1 i Hi b e Hb).
Qed.
Lemma eq10_3_whole_holds : eq10_3_whole.
Proof. intros n V V' R0 r0 v0 HR P A. destruct (tanner2_definition4.solution_starts n V V' R0 r0 v0 HR P A) as (x & S & Q). exists x. split; [now apply whole_is|exact S]. Qed.
Lemma goes_on_whole_holds : goes_on_whole.
Proof.
  intros n V V' R0 S x HR HS P W. apply whole_before_is in W. destruct (tanner2_definition4.solution_goes_on n V V' R0 S x HR HS P W) as (y & E & Q). exists y. split; [now apply whole_is|exact E].
Qed.
Lemma eq10_4_whole_holds : eq10_4_whole.
Proof.
  intros n V V' R0 S x y HR P L X Y E Tie t i Ht Hi. apply whole_before_is in X, Y. exact (tanner2_definition4.solutions_unique n V V' R0 S x y HR P (lipschitz_is n V' L) X Y E Tie t i Ht Hi).
Qed.
Lemma thm2_coll_whole_holds : thm2_coll_whole.
Proof.
  intros n V V' R0 S x HR P X t Ht i j Hi Hj B E. apply whole_before_is in X. destruct (tanner2_definition4.solutions_apart n V V' R0 x HR P (proj1 X)) as (d & Hd & Far). unfold complete in B.
  assert (Ne : i <> j) by (intros ->; now rewrite PeanoNat.Nat.eqb_refl in B). specialize (Far S X t i j Ht Hi Hj Ne). change (tanner2_field.place_of (x t)) with (place (x t)) in Far. rewrite E in Far.
  replace (place (x t) j - place (x t) j)%C with (RtoC 0) in Far by ring. rewrite Cmod_0 in Far. lra.
Qed.
Lemma thm2_vel_whole_holds : thm2_vel_whole.
Proof. intros n V V' R0 x HR P W C1 i j Hi Hj. apply whole_is in W. exact (proj2 (tanner2_definition4.solutions_agree n V V' R0 HR P) x W C1 i j Hi Hj). Qed.
Lemma thm2_pot_whole_holds : thm2_pot_whole.
Proof.
  intros n V V' R0 x HR P W C1 e He. apply whole_is in W. destruct (proj1 (proj2 (tanner2_definition4.solutions_approach n V V' R0 HR P)) x W C1 e He) as [S H]. exists (Rmax S 0). split; [apply Rmax_r|].
  intros t Ht. pose proof (Rmax_l S 0). destruct (H t ltac:(lra)) as (q & [A Kq] & D). exists q. split; [split; [exact A|now apply K_is]|exact D].
Qed.
Lemma eq13_12_whole_holds : eq13_12_whole.
Proof.
  intros n V V' R0 r v x HR P A Q. assert (Q' : D.time_derivative n V V' R0 r v x).
  { intros a b G. destruct (Q a b G) as (w & Kw & E). apply (K10_whole_holds n V V' R0 r v w HR P A) in Kw. destruct Kw as (z & Kz & W). exists z. split; [exact Kz|]. rewrite E. apply Sum_ext. intros i Hi.
    destruct (tanner2_field.at_agent v z i) as (W0 & W1 & W2 & W3). unfold place, speed. rewrite !W by lia. change (state v z) with (tanner2_field.state v z). now rewrite W0, W1, W2, W3, <- !surjective_pairing. }
  split; [now apply (D.eq13_1_proved n V V' R0)|now apply (D.eq13_2_proved n V V' R0 r v)].
Qed.
Lemma eq13_3_whole_holds : eq13_3_whole.
Proof. intros n V V' R0 S x HR P X s t Hst Ht. apply whole_before_is in X. rewrite !T.energy11_is. exact (tanner2_definition4.solutions_lose_Q n V V' R0 S x HR P X s t Hst Ht). Qed.

Lemma thm2_stop_holds : thm2_stop.
Proof.
  intros n V V' R0 x HR P Pl W C1 rel One. apply whole_is in W. destruct (tanner2_stops.switching_stops n V V' R0 x HR P Pl W C1) as (S & HS & H).
  - intros s L i j k l Hi Hj Hk Hl Ne Nk E1 E2. assert (X : forall i j k l, (i < j < n)%nat -> (k < l < n)%nat -> Cmod (s i - s j)%C = R0 -> Cmod (s k - s l)%C = R0 -> i = k /\ j = l) by (exact (One (fun i j => s i - s j)%C L)).
    assert (Sy : forall i j, Cmod (s i - s j)%C = Cmod (s j - s i)%C) by (intros a b; rewrite <- Cmod_opp; f_equal; ring).
    destruct (PeanoNat.Nat.lt_trichotomy i j) as [A|[A|A]]; [|congruence|]; (destruct (PeanoNat.Nat.lt_trichotomy k l) as [B|[B|B]]; [|congruence|]).
    + destruct (X i j k l ltac:(lia) ltac:(lia) E1 E2). left. split; congruence.
    + rewrite Sy in E2. destruct (X i j l k ltac:(lia) ltac:(lia) E1 E2). right. split; congruence.
    + rewrite Sy in E1. destruct (X j i k l ltac:(lia) ltac:(lia) E1 E2). right. split; congruence.
    + rewrite Sy in E1, E2. destruct (X j i l k ltac:(lia) ltac:(lia) E1 E2). left. split; congruence.
  - exists S. split; [exact HS|]. intros i j a b Hi Hj Hab Ps. assert (Ne : i <> j).
    { intros ->. unfold rel in Ps. replace (place (x a) j - place (x a) j)%C with (RtoC 0) in Ps by ring. replace (place (x b) j - place (x b) j)%C with (RtoC 0) in Ps by ring. rewrite Cmod_0 in Ps. lra. }
    exact (H i j a b Hi Hj Ne Hab ltac:(unfold tanner2_stops.passes; unfold rel in Ps; change tanner2_field.place_of with place; lra)).
Qed.
Lemma critical_there_holds : critical_there.
Proof.
  intros n V V' R0 q HR P A Gn. split.
  - intros [_ (m & c & y & Y1 & Y2 & Y3)]. apply (proj2 (proj2 (tanner2_approach.all_solutions_approach n V V' R0 HR P))); [|exact Gn].
    split; [exact A|]. exists m, c, y. split; [exact Y1|]. split; [exact Y2|]. intros i Hi. symmetry. now apply Y3.
  - intros Z. split; [exact A|]. exists 1%nat, (fun _ => 1), (fun _ i => T.gradV n (T.by_distance q R0) V' q i). split; [|split; [cbn; ring|]].
    + intros k _. split; [lra|]. intros e He. exists q. assert (N : forall z : C, Cmod (z - z)%C < e) by (intros z; replace (z - z)%C with (RtoC 0) by ring; now rewrite Cmod_0).
      split; [intros; apply N|]. split; [exact Gn|]. intros; apply N.
    + intros i Hi. cbn [Csum]. rewrite (Z i Hi). apply injective_projections; cbn; ring.
Qed.
Lemma goes_on_holds : goes_on.
Proof.
  intros n V V' R0 S r v HR HS P M. destruct (proj2 (proj1 (tanner2_onward.all_solutions_agree n V V' R0 HR P)) S _ _ HS (until_is _ _ _ _ _ _ M)) as (q & u & E & Q).
  exists q, u. split; [now apply of_motion10|]. intros t i Ht. destruct (E t i ltac:(lra)) as [-> ->]. now rewrite !back_is by lra.
Qed.
