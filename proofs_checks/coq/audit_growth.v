(* Audit of how responses grow with the graph and of worst cases behind a leader of bounded acceleration: each theorem of theorems.tsv with its statement written out; the
   objects of the statements are restated first. *)
From Coq Require Import Reals.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums veerman_complex veerman_front veerman_settling.
From Flockproof Require paley_model veerman_growth veerman_worst.
Open Scope R_scope.

Check (den_printed : forall f g w : R, den f g w = (RtoC f + Ci * w * g)%C).
Check (num_printed : forall f g w : R, num f g w = (RtoC f + Ci * w * g + RtoC (w ^ 2))%C).
Check (fun f g w : R => eq_refl : gamma f g w = (num f g w / den f g w)%C).
Check (eq_refl : cis = fun t => (cos t, sin t)).
Check (fun z t d => eq_refl : Cderive z t d = (is_derive (fun s : R => fst (z s)) t (fst d) /\ is_derive (fun s : R => snd (z s)) t (snd d))).
Check (fun (f g : R) N h x u => eq_refl : system_1 f g N h x u = forall k t, (1 <= k <= S N)%nat -> 0 <= t -> is_derive (x k) t (u k t) /\
  is_derive (u k) t (f * ((x k t - h k) - (x (k - 1)%nat t - h (k - 1)%nat)) + g * (u k t - u (k - 1)%nat t))).
Check (fun (f g : R) N h x u => eq_refl : system_2 f g N h x u = forall k t, (1 <= k <= S N)%nat -> 0 <= t -> is_derive (x k) t (u k t) /\
  is_derive (u k) t (if Nat.eqb k (S N)
    then f * ((x k t - h k) - (x (k - 1)%nat t - h (k - 1)%nat)) + g * (u k t - u (k - 1)%nat t)
    else f * ((x k t - h k) - / 2 * ((x (k - 1)%nat t - h (k - 1)%nat) + (x (k + 1)%nat t - h (k + 1)%nat))) +
         g * (u k t - / 2 * (u (k - 1)%nat t + u (k + 1)%nat t)))).

(* ---- beyond.veerman.growth ---- *)
Check (eq_refl : veerman_growth.number = fun M sees k => Sum (S M) (fun j => if sees k j then 1 else 0)).
Check (eq_refl : veerman_growth.mean = fun M sees z k => (RtoC (/ veerman_growth.number M sees k) * paley_model.Csum (S M) (fun j => if sees k j then z j else RtoC 0))%C).
Check (eq_refl : veerman_growth.follows = fun f g M sees z u => forall k t, (1 <= k <= M)%nat -> Cderive (z k) t (u k t) /\
  Cderive (u k) t (f * (z k t - veerman_growth.mean M sees (fun j => z j t) k) + g * (u k t - veerman_growth.mean M sees (fun j => u j t) k))%C).
Check (eq_refl : veerman_growth.oscillation = fun f g M sees w a => a 0%nat = RtoC 1 /\
  veerman_growth.follows f g M sees (fun k t => (a k * cis (w * t))%C) (fun k t => ((0, w) * (a k * cis (w * t)))%C)).
Check (eq_refl : veerman_growth.peak = fun f g M sees A =>
  (forall w a, 0 < w -> veerman_growth.oscillation f g M sees w a -> Cmod (a M) <= A) /\ exists w a, 0 < w /\ veerman_growth.oscillation f g M sees w a /\ Cmod (a M) = A).
Check (eq_refl : veerman_growth.reached = fun M sees k =>
  Relation_Operators.clos_refl_trans nat (fun i j => (i <= M)%nat /\ (1 <= j <= M)%nat /\ sees j i = true) 0%nat k).
Check (eq_refl : veerman_growth.tree = fun parent k j => Nat.eqb j (parent k)).
Check (veerman_growth.one_sided_growth : forall f g, f < 0 -> g < 0 -> exists G, 1 < G /\ forall M, veerman_growth.peak f g M (veerman_growth.tree pred) (G ^ M)).
Check (veerman_growth.every_degree : forall f g p, f < 0 -> g < 0 -> 0 <= p -> exists c1 c2, 0 < c1 /\ 0 < c2 /\ forall M, (1 <= M)%nat -> exists sees,
  (forall k, (1 <= k <= M)%nat -> sees k k = false /\ exists j, (j <= M)%nat /\ sees k j = true) /\ (forall k, (k <= M)%nat -> veerman_growth.reached M sees k) /\
  exists A, veerman_growth.peak f g M sees A /\ c1 * Rpower (INR M) p <= A <= c2 * Rpower (INR M) p).

(* ---- beyond.veerman.worst_cases: N + 1 followers ---- *)
Check (eq_refl : veerman_worst.admissible = fun a => (forall t, continuity_pt a t) /\ forall t, -1 <= a t <= 1).
Check (eq_refl : veerman_worst.driven = fun N h a x u => (forall t, 0 <= t -> is_derive (x 0%nat) t (u 0%nat t) /\ is_derive (u 0%nat) t (a t)) /\
  forall k, (1 <= k <= S N)%nat -> x k 0 - h k = x 0%nat 0 - h 0%nat /\ u k 0 = u 0%nat 0).
Check (eq_refl : veerman_worst.supremum_at_least = fun N h motion q B => forall e, 0 < e -> exists a x u t,
  veerman_worst.admissible a /\ veerman_worst.driven N h a x u /\ motion x u /\ 0 <= t /\ B - e < Rabs (q x t)).
Check (eq_refl : deviation = fun h x k t => (x k t - h k) - (x 0%nat t - h 0%nat)).
Check (veerman_worst.two_sided_worst : forall f g N h k, f < 0 -> g < 0 -> (1 <= k <= S N)%nat ->
  veerman_worst.supremum_at_least N h (system_2 f g N h) (fun x t => deviation h x k t) (INR k * (2 * INR (S N) - INR k) / Rabs f) /\
  veerman_worst.supremum_at_least N h (system_2 f g N h) (fun x t => deviation h x (S N) t) (INR (S N) ^ 2 / Rabs f) /\
  veerman_worst.supremum_at_least N h (system_2 f g N h) (fun x t => deviation h x k t - deviation h x (k - 1) t) ((2 * (INR (S N) - INR k) + 1) / Rabs f)).
Check (veerman_worst.one_sided_worst : forall f g N h k, f < 0 -> g < 0 -> (1 <= k <= S N)%nat ->
  veerman_worst.supremum_at_least N h (system_1 f g N h) (fun x t => deviation h x k t) (INR k / Rabs f)).
Check (veerman_worst.one_sided_gap : forall f g N h k w, f < 0 -> g < 0 -> (1 <= k <= S N)%nat -> 0 < w ->
  veerman_worst.supremum_at_least N h (system_1 f g N h) (fun x t => deviation h x k t - deviation h x (k - 1) t) (Cmod (/ gamma f g w)%C ^ (k - 1) / Cmod (num f g w)) /\
  (w ^ 2 < 2 * Rabs f -> 1 < Cmod (/ gamma f g w)%C)).
