From Coq Require Import Reals.
From Coquelicot Require Import Coquelicot.
Open Scope R_scope.
(* beyond.chazelle.angle clause 1: the angle of (x, t) and (v, 1) in R^(d+1), own definitions *)
Fixpoint inner_of (d : nat) (x y : nat -> R) : R := match d with O => 0 | S d => inner_of d x y + x d * y d end.
Definition length_of d x := sqrt (inner_of d x x).
Definition lift (d : nat) (x : nat -> R) (h : R) (k : nat) : R := if Nat.eqb k d then h else x k.
Definition angle_of d x y := acos (inner_of d x y / (length_of d x * length_of d y)).
Definition angle_1 : Prop := forall (d : nat) (x v : nat -> R) (t : nat), (1 <= t)%nat ->
  angle_of (S d) (lift d x (INR t)) (lift d v 1) <= length_of d (fun k => v k - x k / INR t) /\
  length_of d (fun k => v k - x k / INR t) = length_of d (fun k => x k - INR t * v k) / INR t.
