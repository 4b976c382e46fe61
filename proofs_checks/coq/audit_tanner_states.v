(* Audit of the minima of the sum of all potentials and of the smoothness of the control laws: each theorem of theorems.tsv with its statement written out; the objects of the
   statements are restated first. *)
From Coq Require Import Reals.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums paley_model tanner_energy tanner1_heading.
From Flockproof Require tanner_angle tanner2_apart tanner1_smooth.
Open Scope R_scope.

Check (eq_refl : norm = Cmod).
Check (eq_refl : grad = fun V' ri rj => (RtoC (V' (Cmod (ri - rj)%C) / Cmod (ri - rj)%C) * (ri - rj))%C).
Check (eq_refl : grad_i = fun n adj V' r i => Csum n (fun j => RtoC (w adj i j) * grad (V' i j) (r i) (r j))%C).
Check (eq_refl : align = fun n adj r th i => Sum n (fun j => w adj i j * ((th i - th j) / norm (r i - r j)%C ^ 2))).
Check (eq_refl : accel = fun n adj V' r v th i => (- grad_i n adj V' r i + RtoC (- align n adj r th i) * (Ci * v i))%C).
Check (eq_refl : tanner_angle.arctan2 = fun y x => if Rlt_dec 0 x then atan (y / x) else if Rlt_dec 0 y then PI / 2 - atan (x / y)
  else if Rlt_dec y 0 then - (PI / 2) - atan (x / y) else PI).

(* ---- tanner2.sec4.flocking (corrected), clause 2 ---- *)
Check (eq_refl : tanner2_apart.all_apart = fun n r => forall i j, (i < n)%nat -> (j < n)%nat -> i <> j -> r i <> r j).
Check (eq_refl : tanner2_apart.sum_of_all = fun n V r => Sum n (fun i => Sum n (fun j => if Nat.eqb i j then 0 else V i j (norm (r i - r j)%C)))).
Check (eq_refl : tanner2_apart.not_above = fun n V r q => tanner2_apart.all_apart n q -> tanner2_apart.all_apart n r /\ tanner2_apart.sum_of_all n V r <= tanner2_apart.sum_of_all n V q).
Check (eq_refl : tanner2_apart.below = fun n V r q => tanner2_apart.all_apart n q -> tanner2_apart.all_apart n r /\ tanner2_apart.sum_of_all n V r < tanner2_apart.sum_of_all n V q).
Check (eq_refl : tanner2_apart.moved_by = fun n a b r q => Cmod a = 1 /\ forall i, (i < n)%nat -> q i = (a * r i + b)%C).
Check (eq_refl : tanner2_apart.strict_minimum = fun n V r => exists d, 0 < d /\ forall q, (forall i, (i < n)%nat -> norm (q i - r i)%C < d) ->
  tanner2_apart.not_above n V r q /\ (tanner2_apart.below n V r q \/ exists a b, tanner2_apart.moved_by n a b r q)).
Check (tanner2_apart.minimum_apart : forall n V r, tanner2_apart.strict_minimum n V r -> forall a b q, tanner2_apart.moved_by n a b r q -> tanner2_apart.all_apart n q).

(* ---- tanner1.smooth (corrected): of agent i the place and the velocity are the coordinates 4i, .., 4i + 3 of the state ---- *)
Check (eq_refl : tanner1_smooth.put = fun s m x j => if Nat.eqb j m then x else s j).
Check (eq_refl : tanner1_smooth.near = fun d s q e => forall m, (m < d)%nat -> Rabs (q m - s m) < e).
Check (eq_refl : tanner1_smooth.open_set = fun d U => forall s, U s -> exists e, 0 < e /\ forall q, tanner1_smooth.near d s q e -> U q).
Check (eq_refl : tanner1_smooth.continuous_on = fun d U F => forall s, U s -> forall e, 0 < e -> exists r, 0 < r /\ forall q, tanner1_smooth.near d s q r -> Rabs (F q - F s) < e).
Check (fun d U F => eq_refl : tanner1_smooth.differentiable 0 d U F = tanner1_smooth.continuous_on d U F).
Check (fun k d U F => eq_refl : tanner1_smooth.differentiable (S k) d U F = (tanner1_smooth.continuous_on d U F /\ forall m, (m < d)%nat ->
  exists G, (forall s, U s -> is_derive (fun x => F (tanner1_smooth.put s m x)) (s m) (G s)) /\ tanner1_smooth.differentiable k d U G)).
Check (eq_refl : tanner1_smooth.smooth_on = fun d U F => forall k, tanner1_smooth.differentiable k d U F).
Check (eq_refl : tanner1_smooth.place = fun s i => ((s (4 * i)%nat, s (4 * i + 1)%nat) : C)).
Check (eq_refl : tanner1_smooth.velocity = fun s i => ((s (4 * i + 2)%nat, s (4 * i + 3)%nat) : C)).
Check (eq_refl : tanner1_smooth.heading = fun s i => tanner_angle.arctan2 (snd (tanner1_smooth.velocity s i)) (fst (tanner1_smooth.velocity s i))).
Check (eq_refl : tanner1_smooth.regular = fun n adj s => (forall i, (i < n)%nat -> ~ (snd (tanner1_smooth.velocity s i) = 0 /\ fst (tanner1_smooth.velocity s i) <= 0)) /\
  forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> tanner1_smooth.place s i <> tanner1_smooth.place s j).
Check (tanner1_smooth.laws_smooth : forall n adj V V' (W : nat -> nat -> nat -> R -> R),
  (forall i j x, (i < n)%nat -> (j < n)%nat -> adj i j = true -> 0 < x -> W i j 0%nat x = V i j x /\ is_derive (V i j) x (V' i j x) /\ forall k, is_derive (W i j k) x (W i j (S k) x)) ->
  tanner1_smooth.open_set (4 * n) (tanner1_smooth.regular n adj) /\ forall i, (i < n)%nat ->
    tanner1_smooth.smooth_on (4 * n) (tanner1_smooth.regular n adj) (fun s => fst (accel n adj V' (tanner1_smooth.place s) (tanner1_smooth.velocity s) (tanner1_smooth.heading s) i)) /\
    tanner1_smooth.smooth_on (4 * n) (tanner1_smooth.regular n adj) (fun s => snd (accel n adj V' (tanner1_smooth.place s) (tanner1_smooth.velocity s) (tanner1_smooth.heading s) i))).
