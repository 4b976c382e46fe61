(* Audit of solutions of (10) after Definition 4, links by distance: each theorem of theorems.tsv with its statement written out; the objects of the statements
  are restated first. *)
From Coq Require Import Reals.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums paley_model paley_phase.
From Flockproof Require tanner_nonsmooth inclusions tanner2_filippov tanner2_limits tanner2_lasting tanner2_facts tanner2_unique tanner2_energies tanner2_appendix tanner2_existence tanner2_approach tanner2_field tanner2_definition4 tanner2_stops.
Open Scope R_scope.

(* The law: links join agents nearer than R0. *)
Check (eq_refl : complete = fun k j => negb (Nat.eqb k j)).
Check (eq_refl : tanner2_filippov.pull = fun adj V' r i j =>
  (if adj i j then RtoC (V' i j (Cmod (r i - r j)) / Cmod (r i - r j)) * (r i - r j) else 0)%C).
Check (eq_refl : tanner2_filippov.gradV = fun n adj V' r i => Csum n (tanner2_filippov.pull adj V' r i)).
Check (eq_refl : tanner2_filippov.law4 = fun n adj V' r v i =>
  (- Csum n (fun j => if adj i j then v i - v j else 0) - Csum n (tanner2_filippov.pull adj V' r i))%C).
Check (eq_refl : tanner2_filippov.by_distance = fun r R0 i j =>
  (negb (Nat.eqb i j) && if Rlt_dec (Cmod (r i - r j)%C) R0 then true else false)%bool).
Check (eq_refl : tanner2_filippov.apart_at = fun n adj r => forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> r i <> r j).
Check (eq_refl : tanner2_filippov.potentials = fun n adj V V' => (forall i j s, V i j s = V j i s) /\
  forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true ->
    (forall s, 0 < s -> is_derive (V i j) s (V' i j s) /\ continuity_pt (V' i j) s /\ 0 <= V i j s) /\
    (forall c, exists d, 0 < d /\ forall s, 0 < s < d -> c < V i j s) /\ (forall c, exists D, forall s, D < s -> c < V i j s)).
(* As a field on R^(4n): agent i at 4i, 4i + 1, its velocity at 4i + 2, 4i + 3. The gradients, on R^(2n). *)
Check (eq_refl : tanner2_field.place_of = fun x i => (x (4 * i)%nat, x (4 * i + 1)%nat)).
Check (eq_refl : tanner2_field.speed_of = fun x i => (x (4 * i + 2)%nat, x (4 * i + 3)%nat)).
Check (eq_refl : tanner2_field.state = fun q u j => let i := Nat.div j 4 in
  match Nat.modulo j 4 with 0%nat => fst (q i) | 1%nat => snd (q i) | 2%nat => fst (u i) | _ => snd (u i) end).
Check (eq_refl : tanner2_field.field10 = fun n V' R0 x => tanner2_field.state (tanner2_field.speed_of x)
  (tanner2_filippov.law4 n (tanner2_filippov.by_distance (tanner2_field.place_of x) R0) V' (tanner2_field.place_of x) (tanner2_field.speed_of x))).
Check (eq_refl : tanner2_lasting.place = fun n y i => (y i, y (n + i)%nat)).
Check (eq_refl : tanner2_approach.flat = fun n y k => if Nat.ltb k n then fst (y k) else snd (y (k - n)%nat)).
Check (eq_refl : tanner2_field.gradient_field = fun n V' R0 x =>
  tanner2_approach.flat n (tanner2_filippov.gradV n (tanner2_filippov.by_distance (tanner2_lasting.place n x) R0) V' (tanner2_lasting.place n x))).
(* K of Definition 4: for every d > 0 and every set of measure zero the closed convex hull of what f is on the rest of the cube. *)
Check (eq_refl : inclusions.near = fun n d x y => forall i, (i < n)%nat -> Rabs (x i - y i) < d).
Check (eq_refl : tanner2_appendix.null = fun n Z => forall e, 0 < e -> exists a b : nat -> nat -> R, (forall k i, (i < n)%nat -> a k i <= b k i) /\
  (forall x, Z x -> exists k, forall i, (i < n)%nat -> a k i < x i < b k i) /\ forall m, Sum m (fun k => tanner2_appendix.Product n (fun i => b k i - a k i)) <= e).
Check (eq_refl : tanner2_appendix.closed_hull = fun n A z => forall e, 0 < e -> exists m (c : nat -> R) (y : nat -> nat -> R),
  (forall k, (k < m)%nat -> 0 <= c k /\ A (y k)) /\ Sum m c = 1 /\ forall i, (i < n)%nat -> Rabs (z i - Sum m (fun k => c k * y k i)) < e).
Check (eq_refl : tanner2_appendix.values = fun n f x d Z y => exists q, inclusions.near n d q x /\ ~ Z q /\ forall i, (i < n)%nat -> y i = f q i).
Check (eq_refl : tanner2_appendix.K = fun n f x z => forall d Z, 0 < d -> tanner2_appendix.null n Z -> tanner2_appendix.closed_hull n (tanner2_appendix.values n f x d Z) z).
(* Solutions until T, and for all t >= 0. *)
Check (eq_refl : tanner2_filippov.negligible = fun N => forall e, 0 < e -> exists a b : nat -> R, (forall k, a k <= b k) /\
  (forall t, N t -> exists k, a k < t < b k) /\ forall m, Sum m (fun k => b k - a k) <= e).
Check (eq_refl : tanner2_filippov.ac = fun F => forall T e, 0 < T -> 0 < e -> exists d, 0 < d /\ forall m (a b : nat -> R),
  (forall k, (k < m)%nat -> 0 <= a k <= b k /\ b k <= T) -> (forall k, (S k < m)%nat -> b k <= a (S k)) ->
  Sum m (fun k => b k - a k) < d -> Sum m (fun k => Rabs (F (b k) - F (a k))) < e).
Check (eq_refl : tanner2_appendix.ac_until = fun T F => forall b e, 0 < b < T -> 0 < e -> exists d, 0 < d /\ forall m (p q : nat -> R),
  (forall k, (k < m)%nat -> 0 <= p k <= q k /\ q k <= b) -> (forall k, (S k < m)%nat -> q k <= p (S k)) ->
  Sum m (fun k => q k - p k) < d -> Sum m (fun k => Rabs (F (q k) - F (p k))) < e).
Check (eq_refl : tanner2_appendix.filippov = fun n f T x => (forall i, (i < n)%nat -> tanner2_appendix.ac_until T (fun t => x t i)) /\
  exists N, tanner2_filippov.negligible N /\ forall t, 0 <= t < T -> ~ N t ->
    exists z, tanner2_appendix.K n (f t) (x t) z /\ forall i, (i < n)%nat -> is_derive (fun s => x s i) t (z i)).
Check (eq_refl : tanner2_existence.filippov_always = fun n f x => (forall i, (i < n)%nat -> tanner2_filippov.ac (fun t => x t i)) /\
  exists N, tanner2_filippov.negligible N /\ forall t, 0 <= t -> ~ N t ->
    exists z, tanner2_appendix.K n f (x t) z /\ forall i, (i < n)%nat -> is_derive (fun s => x s i) t (z i)).
Check (eq_refl : tanner2_definition4.solution_until = fun T n V' R0 x => tanner2_filippov.apart_at n complete (tanner2_field.place_of (x 0)) /\
  tanner2_appendix.filippov (4 * n) (fun _ => tanner2_field.field10 n V' R0) T x).
Check (eq_refl : tanner2_definition4.solution_always = fun n V' R0 x => tanner2_filippov.apart_at n complete (tanner2_field.place_of (x 0)) /\
  tanner2_existence.filippov_always (4 * n) (tanner2_field.field10 n V' R0) x).
Check (eq_refl : tanner2_definition4.connected_always = fun n R0 x => forall t, 0 <= t -> strongly_connected n (tanner2_filippov.by_distance (tanner2_field.place_of (x t)) R0)).

(* ---- K is the convex hull of the limits of the law from states without a pair at the distance R0 ---- *)
Check (eq_refl : tanner2_filippov.limit_of_law = fun n V' R0 r v y => forall e, 0 < e -> exists q u : nat -> C,
  (forall i, (i < n)%nat -> Cmod (q i - r i)%C < e /\ Cmod (u i - v i)%C < e) /\
  (forall i j, (i < n)%nat -> (j < n)%nat -> i <> j -> Cmod (q i - q j)%C <> R0) /\
  forall i, (i < n)%nat -> Cmod (tanner2_filippov.law4 n (tanner2_filippov.by_distance q R0) V' q u i - y i)%C < e).
Check (eq_refl : tanner2_filippov.K10 = fun n V' R0 r v z => exists m (c : nat -> R) (y : nat -> nat -> C),
  (forall k, (k < m)%nat -> 0 <= c k /\ tanner2_filippov.limit_of_law n V' R0 r v (y k)) /\ Sum m c = 1 /\
  forall i, (i < n)%nat -> z i = Csum m (fun k => RtoC (c k) * y k i)%C).
Check (tanner2_field.K_is_K10 :
  forall (n : nat) (V V' : nat -> nat -> R -> R) (R0 : R) (r v : nat -> C) (w : nat -> R), 0 < R0 -> tanner2_filippov.potentials n complete V V' -> tanner2_filippov.apart_at n complete r ->
  tanner2_appendix.K (4 * n) (tanner2_field.field10 n V' R0) (tanner2_field.state r v) w <->
  exists z, tanner2_filippov.K10 n V' R0 r v z /\ forall j, (j < 4 * n)%nat -> w j = tanner2_field.state v z j).

(* ---- tanner2.eq10_exist (corrected): 1 ---- *)
Check (tanner2_definition4.solution_starts :
  forall (n : nat) (V V' : nat -> nat -> R -> R) (R0 : R) (q0 u0 : nat -> C), 0 < R0 -> tanner2_filippov.potentials n complete V V' -> tanner2_filippov.apart_at n complete q0 ->
  exists x, (forall i, (i < n)%nat -> tanner2_field.place_of (x 0) i = q0 i /\ tanner2_field.speed_of (x 0) i = u0 i) /\ tanner2_definition4.solution_always n V' R0 x).
(* ---- 2 ---- *)
Check (eq_refl : tanner2_unique.pair_gradient = fun V' i j z => (RtoC (V' i j (Cmod z) / Cmod z) * z)%C).
Check (eq_refl : tanner2_unique.lipschitz_gradients = fun n V' => forall i j, (i < n)%nat -> (j < n)%nat -> i <> j -> forall z0 : C, z0 <> RtoC 0 ->
  exists d L, 0 < d /\ 0 < L /\ forall z y, Cmod (z - z0)%C < d -> Cmod (y - z0)%C < d ->
    Cmod (tanner2_unique.pair_gradient V' i j z - tanner2_unique.pair_gradient V' i j y)%C <= L * Cmod (z - y)%C).
Check (tanner2_definition4.solutions_unique :
  forall (n : nat) (V V' : nat -> nat -> R -> R) (R0 T : R) (x y : R -> nat -> R), 0 < R0 -> tanner2_filippov.potentials n complete V V' -> tanner2_unique.lipschitz_gradients n V' ->
  tanner2_definition4.solution_until T n V' R0 x -> tanner2_definition4.solution_until T n V' R0 y -> (forall j, (j < 4 * n)%nat -> x 0 j = y 0 j) ->
  (forall t i j, 0 <= t < T -> (i < n)%nat -> (j < n)%nat -> i <> j -> Cmod (tanner2_field.place_of (x t) i - tanner2_field.place_of (x t) j)%C = R0 ->
    inner (tanner2_field.place_of (x t) i - tanner2_field.place_of (x t) j)%C (tanner2_field.speed_of (x t) i - tanner2_field.speed_of (x t) j)%C <> 0) ->
  forall t j, 0 <= t < T -> (j < 4 * n)%nat -> x t j = y t j).

(* ---- tanner2.thm2_coll ---- *)
Check (tanner2_definition4.solutions_apart :
  forall (n : nat) (V V' : nat -> nat -> R -> R) (R0 : R) (x : R -> nat -> R), 0 < R0 -> tanner2_filippov.potentials n complete V V' -> tanner2_filippov.apart_at n complete (tanner2_field.place_of (x 0)) ->
  exists d, 0 < d /\ forall T, tanner2_definition4.solution_until T n V' R0 x -> forall t i j, 0 <= t < T -> (i < n)%nat -> (j < n)%nat -> i <> j ->
    d < Cmod (tanner2_field.place_of (x t) i - tanner2_field.place_of (x t) j)%C).

(* ---- tanner2.thm2_vel; tanner2.arbswitch (corrected, clause 1) ---- *)
Check (eq_refl : tanner2_definition4.solutions_last = fun n V' R0 =>
  (forall q0 u0, tanner2_filippov.apart_at n complete q0 ->
    exists x, (forall i, (i < n)%nat -> tanner2_field.place_of (x 0) i = q0 i /\ tanner2_field.speed_of (x 0) i = u0 i) /\ tanner2_definition4.solution_always n V' R0 x) /\
  forall T x, 0 < T -> tanner2_definition4.solution_until T n V' R0 x ->
    exists y, (forall t j, 0 <= t < T -> (j < 4 * n)%nat -> y t j = x t j) /\ tanner2_definition4.solution_always n V' R0 y).
Check (tanner2_definition4.solutions_agree :
  forall (n : nat) (V V' : nat -> nat -> R -> R) (R0 : R), 0 < R0 -> tanner2_filippov.potentials n complete V V' -> tanner2_definition4.solutions_last n V' R0 /\
  forall x, tanner2_definition4.solution_always n V' R0 x -> tanner2_definition4.connected_always n R0 x -> forall i j, (i < n)%nat -> (j < n)%nat ->
    forall e, 0 < e -> exists T, forall t, T <= t -> Cmod (tanner2_field.speed_of (x t) i - tanner2_field.speed_of (x t) j)%C < e).

(* ---- tanner2.thm2_pot (corrected) ---- *)
Check (eq_refl : tanner2_limits.generic = fun n R0 q => forall i j, (i < n)%nat -> (j < n)%nat -> i <> j -> Cmod (q i - q j)%C <> R0).
Check (eq_refl : tanner2_definition4.critical4 = fun n V' R0 q => tanner2_filippov.apart_at n complete q /\
  tanner2_appendix.K (2 * n) (tanner2_field.gradient_field n V' R0) (tanner2_approach.flat n q) (fun _ => 0)).
Check (tanner2_definition4.solutions_approach :
  forall (n : nat) (V V' : nat -> nat -> R -> R) (R0 : R), 0 < R0 -> tanner2_filippov.potentials n complete V V' -> tanner2_definition4.solutions_last n V' R0 /\
  (forall x, tanner2_definition4.solution_always n V' R0 x -> tanner2_definition4.connected_always n R0 x ->
    forall e, 0 < e -> exists T, forall t, T <= t -> exists q, tanner2_definition4.critical4 n V' R0 q /\ forall i, (i < n)%nat -> Cmod (tanner2_field.place_of (x t) i - q i)%C < e) /\
  forall q, tanner2_definition4.critical4 n V' R0 q -> tanner2_limits.generic n R0 q -> forall i, (i < n)%nat ->
    tanner2_filippov.gradV n (tanner2_filippov.by_distance q R0) V' q i = RtoC 0).

(* ---- tanner2.eq13: Q of (11); (A.2) with K of the whole vector field; co of the forms of the networks that occur arbitrarily near ---- *)
Check (eq_refl : tanner2_facts.Qsat = fun n V R0 r v => / 2 * Sum n (fun i => Sum n (fun j => if Nat.eqb i j then 0 else
  tanner_nonsmooth.saturated (V i j) R0 (norm (r i - r j)%C)) + inner (v i) (v i))).
Check (eq_refl : tanner_nonsmooth.saturated = fun V R0 s => if Rlt_dec s R0 then V s else V R0).
Check (eq_refl : tanner2_limits.same_pairs = fun n g h => forall i j, (i < n)%nat -> (j < n)%nat -> g i j = h i j).
Check (eq_refl : tanner2_limits.occurs = fun n R0 r g => forall e, 0 < e -> exists q : nat -> C, (forall i, (i < n)%nat -> Cmod (q i - r i)%C < e) /\
  tanner2_limits.generic n R0 q /\ tanner2_limits.same_pairs n g (tanner2_filippov.by_distance q R0)).
Check (eq_refl : tanner2_energies.limit_of_gradient = fun n V' R0 r v y z => forall e, 0 < e -> exists q u : nat -> C,
  (forall i, (i < n)%nat -> Cmod (q i - r i)%C < e /\ Cmod (u i - v i)%C < e) /\ tanner2_limits.generic n R0 q /\
  forall i, (i < n)%nat -> Cmod (tanner2_filippov.gradV n (tanner2_filippov.by_distance q R0) V' q i - y i)%C < e /\ Cmod (u i - z i)%C < e).
Check (eq_refl : tanner2_energies.gradient_Q = fun n V' R0 r v a b => exists m (c : nat -> R) (y z : nat -> nat -> C),
  (forall k, (k < m)%nat -> 0 <= c k /\ tanner2_energies.limit_of_gradient n V' R0 r v (y k) (z k)) /\ Sum m c = 1 /\
  forall i, (i < n)%nat -> a i = Csum m (fun k => RtoC (c k) * y k i)%C /\ b i = Csum m (fun k => RtoC (c k) * z k i)%C).
Check (eq_refl : tanner2_definition4.derivative13 = fun n V' R0 r v x => forall a b, tanner2_energies.gradient_Q n V' R0 r v a b ->
  exists w, tanner2_appendix.K (4 * n) (tanner2_field.field10 n V' R0) (tanner2_field.state r v) w /\
    x = Sum n (fun i => inner (a i) (tanner2_field.place_of w i) + inner (b i) (tanner2_field.speed_of w i))).
Check (eq_refl : tanner2_energies.hull13 = fun n R0 r v y => exists m (c : nat -> R) (g : nat -> graph), (forall k, (k < m)%nat -> 0 <= c k /\ tanner2_limits.occurs n R0 r (g k)) /\
  Sum m c = 1 /\ y = Sum m (fun k => c k * Sum n (fun i => inner (v i) (Csum n (fun j => if g k i j then v i - v j else 0)%C)))).
Check (tanner2_definition4.derivative_within :
  forall (n : nat) (V V' : nat -> nat -> R -> R) (R0 : R) (r v : nat -> C), 0 < R0 -> tanner2_filippov.potentials n complete V V' -> tanner2_filippov.apart_at n complete r ->
  forall x, tanner2_definition4.derivative13 n V' R0 r v x -> tanner2_energies.hull13 n R0 r v (- x) /\ x <= 0).
Check (tanner2_definition4.solutions_lose_Q :
  forall (n : nat) (V V' : nat -> nat -> R -> R) (R0 T : R) (x : R -> nat -> R), 0 < R0 -> tanner2_filippov.potentials n complete V V' ->
  tanner2_definition4.solution_until T n V' R0 x -> forall a b, 0 <= a <= b -> b < T ->
  tanner2_facts.Qsat n V R0 (tanner2_field.place_of (x b)) (tanner2_field.speed_of (x b)) <= tanner2_facts.Qsat n V R0 (tanner2_field.place_of (x a)) (tanner2_field.speed_of (x a))).

(* ---- beyond.tanner2.thm2_stop: r i t the position of agent i at t ---- *)
Check (eq_refl : tanner2_stops.limit_point = fun n r s => forall T e, 0 < e -> exists t, T <= t /\
  forall i j, (i < n)%nat -> (j < n)%nat -> Cmod (r i t - r j t - (s i - s j))%C < e).
Check (eq_refl : tanner2_stops.one_pair_at = fun n R0 s => forall i j k l, (i < n)%nat -> (j < n)%nat -> (k < n)%nat -> (l < n)%nat -> i <> j -> k <> l ->
  Cmod (s i - s j)%C = R0 -> Cmod (s k - s l)%C = R0 -> (k = i /\ l = j) \/ (k = j /\ l = i)).
Check (eq_refl : tanner2_stops.passes = fun R0 f a b => (f a < R0 /\ R0 < f b) \/ (R0 < f a /\ f b < R0)).
Check (eq_refl : tanner2_stops.stays = fun R0 f a b => exists c d, a <= c < d /\ d <= b /\ forall t, c <= t <= d -> f t = R0).
Check (eq_refl : tanner2_stops.switching_ends = fun n R0 r => exists T, 0 <= T /\ forall i j a b, (i < n)%nat -> (j < n)%nat -> i <> j -> T <= a < b ->
  tanner2_stops.passes R0 (fun t => Cmod (r i t - r j t)%C) a b -> tanner2_stops.stays R0 (fun t => Cmod (r i t - r j t)%C) a b).
Check (tanner2_stops.switching_stops :
  forall (n : nat) (V V' : nat -> nat -> R -> R) (R0 : R) (x : R -> nat -> R), 0 < R0 -> tanner2_filippov.potentials n complete V V' ->
  (forall k l, (k < n)%nat -> (l < n)%nat -> k <> l -> 0 < V' k l R0) ->
  tanner2_definition4.solution_always n V' R0 x -> tanner2_definition4.connected_always n R0 x ->
  (forall s, tanner2_stops.limit_point n (fun i t => tanner2_field.place_of (x t) i) s -> tanner2_stops.one_pair_at n R0 s) ->
  tanner2_stops.switching_ends n R0 (fun i t => tanner2_field.place_of (x t) i)).
