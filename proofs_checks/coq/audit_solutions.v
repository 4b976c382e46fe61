(* Audit of solutions in the sense of Filippov in R^n, of the swing of two agents and of jumps of headings: each theorem of theorems.tsv with its
  statement written out; the objects of the statements are restated first. *)
From Coq Require Import Reals.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums inclusions paley_model paley_phase tanner_energy tanner1_heading tanner1_motion.
From Flockproof Require tanner_angle tanner1_pair tanner2_filippov tanner1_jumps tanner1_swing tanner2_appendix tanner2_unique tanner2_existence.
Open Scope R_scope.

Check (eq_refl : norm = Cmod).
Check (eq_refl : grad = fun V' ri rj => (RtoC (V' (Cmod (ri - rj)%C) / Cmod (ri - rj)%C) * (ri - rj))%C).
Check (eq_refl : grad_i = fun n adj V' r i => Csum n (fun j => RtoC (w adj i j) * grad (V' i j) (r i) (r j))%C).
Check (eq_refl : align = fun n adj r th i => Sum n (fun j => w adj i j * ((th i - th j) / norm (r i - r j)%C ^ 2))).
Check (eq_refl : accel = fun n adj V' r v th i => (- grad_i n adj V' r i + RtoC (- align n adj r th i) * (Ci * v i))%C).
Check (eq_refl : is_velocity = fun r t v => is_derive (fun s => fst (r s)) t (fst v) /\ is_derive (fun s => snd (r s)) t (snd v)).
Check (eq_refl : steered = fun n adj V V' r v th t =>
  (forall i, (i < n)%nat -> is_velocity (r i) t (v i t)) /\
  (forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> r i t <> r j t) /\
  (forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> is_derive (V i j) (norm (r i t - r j t)%C) (V' i j (norm (r i t - r j t)%C))) /\
  (forall i, (i < n)%nat -> is_velocity (v i) t (accel n adj V' (fun j => r j t) (fun j => v j t) (fun j => th j t) i))).
Check (eq_refl : tanner2_filippov.negligible = fun N => forall e, 0 < e -> exists a b : nat -> R, (forall k, a k <= b k) /\
  (forall t, N t -> exists k, a k < t < b k) /\ forall m, Sum m (fun k => b k - a k) <= e).

(* ---- beyond.tanner1.two_agents, clause 2: absolutely continuous velocities, the law at almost all times ---- *)
Check (eq_refl : tanner1_pair.wrapped = fun d x => sin x = 0 \/ - PI <= d <= PI /\ exists k : Z, d = x + 2 * IZR k * PI).
Check (eq_refl : tanner1_jumps.continuous_until = fun T z => forall b e, 0 < b < T -> 0 < e -> exists d, 0 < d /\ forall m (p q : nat -> R),
  (forall k, (k < m)%nat -> 0 <= p k <= q k /\ q k <= b) -> (forall k, (S k < m)%nat -> q k <= p (S k)) ->
  Sum m (fun k => q k - p k) < d -> Sum m (fun k => Cmod (z (q k) - z (p k))%C) < e).
Check (tanner1_jumps.two_agents_always :
  forall (adj : graph) (V V' : nat -> nat -> R -> R) (r v : nat -> R -> C) (th phi s : nat -> R -> R) (T : R) (N : R -> Prop),
  undirected adj -> (forall i j, V' i j = V' j i) -> adj 0%nat 1%nat = true ->
  (forall i, (i < 2)%nat -> tanner1_jumps.continuous_until T (v i)) -> tanner2_filippov.negligible N ->
  (forall t, 0 <= t < T -> ~ N t -> steered 2 adj V V' r v th t /\ tanner1_pair.wrapped (th 0%nat t - th 1%nat t) (phi 0%nat t - phi 1%nat t) /\
    forall i, (i < 2)%nat -> 0 <= s i t /\ v i t = (RtoC (s i t) * expi (phi i t))%C) ->
  forall a b, 0 <= a <= b -> b < T -> norm (v 0%nat a + v 1%nat a)%C <= norm (v 0%nat b + v 1%nat b)%C).

(* ---- solutions of xdot = f(x, t) in R^n ---- *)
Check (eq_refl : near = fun n d x y => forall i, (i < n)%nat -> Rabs (x i - y i) < d).
Check (eq_refl : dot = fun n l y => Sum n (fun i => l i * y i)).
Check (fun n f => eq_refl : tanner2_appendix.Product (S n) f = tanner2_appendix.Product n f * f n).
Check (fun f => eq_refl : tanner2_appendix.Product 0 f = 1).
Check (eq_refl : tanner2_appendix.null = fun n Z => forall e, 0 < e -> exists a b : nat -> nat -> R, (forall k i, (i < n)%nat -> a k i <= b k i) /\
  (forall x, Z x -> exists k, forall i, (i < n)%nat -> a k i < x i < b k i) /\ forall m, Sum m (fun k => tanner2_appendix.Product n (fun i => b k i - a k i)) <= e).
Check (eq_refl : tanner2_appendix.closed_hull = fun n A z => forall e, 0 < e -> exists m (c : nat -> R) (y : nat -> nat -> R),
  (forall k, (k < m)%nat -> 0 <= c k /\ A (y k)) /\ Sum m c = 1 /\ forall i, (i < n)%nat -> Rabs (z i - Sum m (fun k => c k * y k i)) < e).
Check (eq_refl : tanner2_appendix.values = fun n f x d Z y => exists q, near n d q x /\ ~ Z q /\ forall i, (i < n)%nat -> y i = f q i).
Check (eq_refl : tanner2_appendix.K = fun n f x z => forall d Z, 0 < d -> tanner2_appendix.null n Z -> tanner2_appendix.closed_hull n (tanner2_appendix.values n f x d Z) z).
Check (eq_refl : tanner2_appendix.ac_until = fun T F => forall b e, 0 < b < T -> 0 < e -> exists d, 0 < d /\ forall m (p q : nat -> R),
  (forall k, (k < m)%nat -> 0 <= p k <= q k /\ q k <= b) -> (forall k, (S k < m)%nat -> q k <= p (S k)) ->
  Sum m (fun k => q k - p k) < d -> Sum m (fun k => Rabs (F (q k) - F (p k))) < e).
Check (eq_refl : tanner2_appendix.filippov = fun n f T x => (forall i, (i < n)%nat -> tanner2_appendix.ac_until T (fun t => x t i)) /\
  exists N, tanner2_filippov.negligible N /\ forall t, 0 <= t < T -> ~ N t -> exists z, tanner2_appendix.K n (f t) (x t) z /\ forall i, (i < n)%nat -> is_derive (fun s => x s i) t (z i)).

(* tanner2.appA_uniq (corrected): the bound for almost all x and, for each of them, for almost all y near p *)
Check (eq_refl : tanner2_appendix.gap2 = fun n x y => Sum n (fun i => (x i - y i) ^ 2)).
Check (eq_refl : tanner2_appendix.bound_fails = fun n f p d l x y => near n d y p /\
  ~ dot n (fun i => f x i - f y i) (fun i => x i - y i) <= l * tanner2_appendix.gap2 n x y).
Check (eq_refl : tanner2_appendix.one_sided_near = fun n f p d l =>
  tanner2_appendix.null n (fun x => near n d x p /\ ~ tanner2_appendix.null n (tanner2_appendix.bound_fails n f p d l x))).
Check (tanner2_appendix.unique_forwards :
  forall (n : nat) (f : (nat -> R) -> nat -> R),
  (forall p, exists d M, 0 < d /\ forall x, near n d x p -> forall i, (i < n)%nat -> Rabs (f x i) <= M) ->
  (forall p, exists d l, 0 < d /\ tanner2_appendix.one_sided_near n f p d l) ->
  forall T x y, tanner2_appendix.filippov n (fun _ => f) T x -> tanner2_appendix.filippov n (fun _ => f) T y ->
  (forall i, (i < n)%nat -> x 0 i = y 0 i) -> forall t, 0 <= t < T -> forall i, (i < n)%nat -> x t i = y t i).

(* tanner2.appA.thm4 (corrected) *)
Check (eq_refl : tanner2_appendix.moved = fun p w h i => p i + h * w i).
Check (eq_refl : tanner2_appendix.slope_along = fun V p w l => forall e, 0 < e -> exists d, 0 < d /\ forall h, 0 < h < d ->
  Rabs ((V (tanner2_appendix.moved p w h) - V p) / h - l) < e).
Check (eq_refl : tanner2_appendix.clarke_slope = fun n V p w l =>
  (forall e, 0 < e -> exists d, 0 < d /\ forall q h, near n d q p -> 0 < h < d -> (V (tanner2_appendix.moved q w h) - V q) / h < l + e) /\
  (forall e d, 0 < e -> 0 < d -> exists q h, near n d q p /\ 0 < h < d /\ l - e < (V (tanner2_appendix.moved q w h) - V q) / h)).
Check (eq_refl : tanner2_appendix.regular_at = fun n V p => forall w, exists l, tanner2_appendix.slope_along V p w l /\ tanner2_appendix.clarke_slope n V p w l).
Check (eq_refl : tanner2_appendix.generalised_gradient = fun n V p xi => forall w l, tanner2_appendix.clarke_slope n V p w l -> dot n xi w <= l).
Check (eq_refl : tanner2_appendix.lipschitz_at = fun n V p => exists d L, 0 < d /\ forall q s, near n d q p -> near n d s p ->
  Rabs (V q - V s) <= L * Sum n (fun i => Rabs (q i - s i))).
Check (eq_refl : tanner2_appendix.with_time = fun n x t i => if Nat.ltb i n then x i else t).
Check (tanner2_appendix.chain_rule :
  forall (n : nat) (f : R -> (nat -> R) -> nat -> R) (V : (nat -> R) -> R) (T : R) (x : R -> nat -> R), tanner2_appendix.filippov n f T x ->
  (forall p, tanner2_appendix.lipschitz_at (S n) V p) -> (forall p, tanner2_appendix.regular_at (S n) V p) ->
  tanner2_appendix.ac_until T (fun t => V (tanner2_appendix.with_time n (x t) t)) /\
  exists N, tanner2_filippov.negligible N /\ forall t, 0 <= t < T -> ~ N t ->
    exists l, is_derive (fun s => V (tanner2_appendix.with_time n (x s) s)) t l /\
      forall xi, tanner2_appendix.generalised_gradient (S n) V (tanner2_appendix.with_time n (x t) t) xi ->
        exists k, tanner2_appendix.K n (f t) (x t) k /\ l = dot (S n) xi (tanner2_appendix.with_time n k 1)).

(* ---- tanner1.propIV3b, tanner1.proof_cases (corrected), clause 2; V2 is 1/s + log s for s the squared distance ---- *)
Check (eq_refl : V2 = fun s => / s ^ 2 + ln (s ^ 2)).
Check (V2_derive : forall s, 0 < s -> is_derive V2 s (V2' s)).
Check (eq_refl : tanner_angle.arctan2 = fun y x => if Rlt_dec 0 x then atan (y / x) else if Rlt_dec 0 y then PI / 2 - atan (x / y)
  else if Rlt_dec y 0 then - (PI / 2) - atan (x / y) else PI).
Check (eq_refl : tanner1_swing.heading = fun z => tanner_angle.arctan2 (snd z) (fst z)).
Check (eq_refl : tanner1_swing.steers = fun r v t => r 0%nat t <> r 1%nat t /\ forall i, (i < 2)%nat -> v i t <> 0%C /\ is_velocity (r i) t (v i t) /\
  is_velocity (v i) t (accel 2 complete (fun _ _ => V2') (fun j => r j t) (fun j => v j t) (fun j => tanner1_swing.heading (v j t)) i)).
Check (eq_refl : tanner1_swing.set_off = fun r v => r 0%nat 0 = (0, 0) /\ r 1%nat 0 = (2, 0) /\ v 0%nat 0 = (2, 0) /\ v 1%nat 0 = (2, 0)).
Check (eq_refl : tanner1_swing.distance = fun r t => norm (r 0%nat t - r 1%nat t)%C).
Check (eq_refl : tanner1_swing.work_rate = fun r v i => - inner (grad_i 2 complete (fun _ _ => V2') r i) (v i)).
Check (tanner1_swing.swings_for_ever :
  exists r v : nat -> R -> C, tanner1_swing.set_off r v /\ (forall t, 0 <= t -> tanner1_swing.steers r v t) /\
  (forall T r' v', tanner1_swing.set_off r' v' -> (forall t, 0 <= t < T -> tanner1_swing.steers r' v' t) ->
    forall t i, 0 <= t < T -> (i < 2)%nat -> r' i t = r i t /\ v' i t = v i t) /\
  (forall t i, 0 <= t -> (i < 2)%nat -> tanner1_swing.heading (v i t) = 0) /\
  (exists P, 0 < P /\ (forall t, 0 <= t -> tanner1_swing.distance r (t + P) = tanner1_swing.distance r t) /\
    forall t, 0 <= t -> exists a b, t <= a < t + P /\ t <= b < t + P /\ tanner1_swing.distance r a = 2 /\ tanner1_swing.distance r b < 1 /\
      0 < tanner1_swing.work_rate (fun j => r j a) (fun j => v j a) 0 /\ tanner1_swing.work_rate (fun j => r j b) (fun j => v j b) 0 < 0 /\
      tanner1_swing.work_rate (fun j => r j a) (fun j => v j a) 1 < 0 /\ 0 < tanner1_swing.work_rate (fun j => r j b) (fun j => v j b) 1) /\
  ~ exists l, forall e, 0 < e -> exists T, forall t, T <= t -> Rabs (tanner1_swing.distance r t - l) < e).

(* ---- tanner2.eq10_exist (corrected, clause 2): solutions of (10) until T. Links join agents nearer than R0; K at a state is the convex hull of the limits of the whole
   law from states without a pair at the distance R0 ---- *)
Check (eq_refl : complete = fun k j => negb (Nat.eqb k j)).
Check (eq_refl : tanner2_filippov.pull = fun adj V' r i j =>
  (if adj i j then RtoC (V' i j (Cmod (r i - r j)) / Cmod (r i - r j)) * (r i - r j) else 0)%C).
Check (eq_refl : tanner2_filippov.law4 = fun n adj V' r v i =>
  (- Csum n (fun j => if adj i j then v i - v j else 0) - Csum n (tanner2_filippov.pull adj V' r i))%C).
Check (eq_refl : tanner2_filippov.by_distance = fun r R0 i j =>
  (negb (Nat.eqb i j) && if Rlt_dec (Cmod (r i - r j)%C) R0 then true else false)%bool).
Check (eq_refl : tanner2_filippov.apart_at = fun n adj r => forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> r i <> r j).
Check (eq_refl : tanner2_filippov.potentials = fun n adj V V' => (forall i j s, V i j s = V j i s) /\
  forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true ->
    (forall s, 0 < s -> is_derive (V i j) s (V' i j s) /\ continuity_pt (V' i j) s /\ 0 <= V i j s) /\
    (forall c, exists d, 0 < d /\ forall s, 0 < s < d -> c < V i j s) /\ (forall c, exists D, forall s, D < s -> c < V i j s)).
Check (eq_refl : tanner2_filippov.limit_of_law = fun n V' R0 r v y => forall e, 0 < e -> exists q u : nat -> C,
  (forall i, (i < n)%nat -> Cmod (q i - r i)%C < e /\ Cmod (u i - v i)%C < e) /\
  (forall i j, (i < n)%nat -> (j < n)%nat -> i <> j -> Cmod (q i - q j)%C <> R0) /\
  forall i, (i < n)%nat -> Cmod (tanner2_filippov.law4 n (tanner2_filippov.by_distance q R0) V' q u i - y i)%C < e).
Check (eq_refl : tanner2_filippov.K10 = fun n V' R0 r v z => exists m (c : nat -> R) (y : nat -> nat -> C),
  (forall k, (k < m)%nat -> 0 <= c k /\ tanner2_filippov.limit_of_law n V' R0 r v (y k)) /\ Sum m c = 1 /\
  forall i, (i < n)%nat -> z i = Csum m (fun k => RtoC (c k) * y k i)%C).
Check (eq_refl : tanner2_filippov.motion10_until = fun T n V' R0 r v => tanner2_filippov.apart_at n complete (fun i => r i 0) /\
  (forall t i, 0 <= t < T -> (i < n)%nat -> is_velocity (r i) t (v i t)) /\
  (forall i, (i < n)%nat -> forall T' e, 0 < T' < T -> 0 < e -> exists d, 0 < d /\ forall m (a b : nat -> R),
    (forall k, (k < m)%nat -> 0 <= a k <= b k /\ b k <= T') -> (forall k, (S k < m)%nat -> b k <= a (S k)) ->
    Sum m (fun k => b k - a k) < d -> Sum m (fun k => Cmod (v i (b k) - v i (a k))%C) < e) /\
  exists N, tanner2_filippov.negligible N /\ forall t, 0 <= t < T -> ~ N t -> tanner2_filippov.apart_at n complete (fun i => r i t) ->
    exists z, tanner2_filippov.K10 n V' R0 (fun i => r i t) (fun i => v i t) z /\ forall i, (i < n)%nat -> is_velocity (v i) t (z i)).
Check (eq_refl : tanner2_unique.pair_gradient = fun V' i j z => (RtoC (V' i j (Cmod z) / Cmod z) * z)%C).
Check (eq_refl : tanner2_unique.lipschitz_gradients = fun n V' => forall i j, (i < n)%nat -> (j < n)%nat -> i <> j -> forall z0 : C, z0 <> RtoC 0 ->
  exists d L, 0 < d /\ 0 < L /\ forall z y, Cmod (z - z0)%C < d -> Cmod (y - z0)%C < d ->
    Cmod (tanner2_unique.pair_gradient V' i j z - tanner2_unique.pair_gradient V' i j y)%C <= L * Cmod (z - y)%C).
Check (tanner2_unique.unique_across :
  forall (n : nat) (V V' : nat -> nat -> R -> R) (R0 T : R) (r v r' v' : nat -> R -> C), 0 < R0 -> tanner2_filippov.potentials n complete V V' -> tanner2_unique.lipschitz_gradients n V' ->
  tanner2_filippov.motion10_until T n V' R0 r v -> tanner2_filippov.motion10_until T n V' R0 r' v' -> (forall i, (i < n)%nat -> r i 0 = r' i 0 /\ v i 0 = v' i 0) ->
  (forall t i j, 0 <= t < T -> (i < n)%nat -> (j < n)%nat -> i <> j -> Cmod (r i t - r j t)%C = R0 -> inner (r i t - r j t)%C (v i t - v j t)%C <> 0) ->
  forall t i, 0 <= t < T -> (i < n)%nat -> r i t = r' i t /\ v i t = v' i t).

(* ---- tanner2.appA.def4 (corrected): f is any bounded function ---- *)
Check (eq_refl : tanner2_filippov.ac = fun F => forall T e, 0 < T -> 0 < e -> exists d, 0 < d /\ forall m (a b : nat -> R),
  (forall k, (k < m)%nat -> 0 <= a k <= b k /\ b k <= T) -> (forall k, (S k < m)%nat -> b k <= a (S k)) ->
  Sum m (fun k => b k - a k) < d -> Sum m (fun k => Rabs (F (b k) - F (a k))) < e).
Check (eq_refl : tanner2_existence.filippov_always = fun n f x => (forall i, (i < n)%nat -> tanner2_filippov.ac (fun t => x t i)) /\
  exists N, tanner2_filippov.negligible N /\ forall t, 0 <= t -> ~ N t ->
    exists z, tanner2_appendix.K n f (x t) z /\ forall i, (i < n)%nat -> is_derive (fun s => x s i) t (z i)).
Check (tanner2_existence.filippov_exists :
  forall (n : nat) (f : (nat -> R) -> nat -> R) (M : R) (x0 : nat -> R), (forall x i, (i < n)%nat -> Rabs (f x i) <= M) ->
  exists x : R -> nat -> R, (forall i, (i < n)%nat -> x 0 i = x0 i) /\ tanner2_existence.filippov_always n f x).
