(* Audit of the energies of the second paper of Tanner, Jadbabaie and Pappas: (6) is differentiable, Q of (11) is continuous and not differentiable at ties, (13).
   Each theorem of theorems.tsv with its statement written out; the objects of the statements are restated first. *)
From Coq Require Import Reals Lra Lia Relations List.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums paley_model paley_phase paley_laplacian tanner_energy tanner_flock tanner2_motion.
From Flockproof Require tanner_nonsmooth tanner2_facts tanner2_filippov tanner2_limits tanner2_energies.
Open Scope R_scope.

Check (eq_refl : norm = Cmod).
Check (eq_refl : inner = fun x y => Re (Cconj x * y)%C).
Check (eq_refl : distinct = fun n adj r => forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> r i <> r j).
Check (eq_refl : grad_i = fun n adj V' r i => Csum n (fun j => (RtoC (w adj i j) * (RtoC (V' i j (Cmod (r i - r j)%C) / Cmod (r i - r j)%C) * (r i - r j)))%C)).
Check (eq_refl : control4 = fun n adj V' r v i => (- Csum n (fun j => RtoC (w adj i j) * (v i - v j)) - grad_i n adj V' r i)%C).
Check (eq_refl : Wenergy = fun n adj V r v => / 2 * Sum n (fun i => Sum n (fun j => w adj i j * V i j (norm (r i - r j)%C)) + inner (v i) (v i))).
Check (eq_refl : tanner2_facts.Qsat = fun n V R0 r v => / 2 * Sum n (fun i => Sum n (fun j => if Nat.eqb i j then 0 else
  tanner_nonsmooth.saturated (V i j) R0 (norm (r i - r j)%C)) + inner (v i) (v i))).
Check (eq_refl : tanner_nonsmooth.saturated = fun V R0 s => if Rlt_dec s R0 then V s else V R0).
(* E is differentiable at (r, v), with the gradients a i in r_i and b i in v_i *)
Check (eq_refl : tanner2_energies.total_derivative = fun n E r v a b => forall e, 0 < e -> exists d, 0 < d /\ forall p u : nat -> C,
  (forall i, (i < n)%nat -> norm (p i) < d /\ norm (u i) < d) ->
  Rabs (E (fun i => r i + p i)%C (fun i => v i + u i)%C - E r v - Sum n (fun i => inner (a i) (p i) + inner (b i) (u i))) <= e * Sum n (fun i => norm (p i) + norm (u i))).
(* tanner2.eq6, clause 2: the gradient in r_i is the force in (4), that in v_i is v_i *)
Check (tanner2_energies.energy_differentiable : forall (n : nat) (adj : graph) (V V' : nat -> nat -> R -> R) (r v : nat -> C), undirected adj -> (forall i j, V' i j = V' j i) ->
  (forall i j s, (i < n)%nat -> (j < n)%nat -> adj i j = true -> 0 < s -> is_derive (V i j) s (V' i j s)) -> distinct n adj r ->
  tanner2_energies.total_derivative n (Wenergy n adj V) r v (grad_i n adj V' r) v).
(* tanner2.Qjump *)
Check (tanner2_energies.Q_continuous : forall (n : nat) (V V' : nat -> nat -> R -> R) (R0 : R), 0 < R0 ->
  (forall i j s, (i < n)%nat -> (j < n)%nat -> i <> j -> 0 < s -> is_derive (V i j) s (V' i j s)) ->
  forall r v : nat -> C, distinct n complete r -> forall e, 0 < e -> exists d, 0 < d /\ forall q u : nat -> C,
  (forall i, (i < n)%nat -> norm (q i - r i)%C < d /\ norm (u i - v i)%C < d) -> Rabs (tanner2_facts.Qsat n V R0 q u - tanner2_facts.Qsat n V R0 r v) < e).
Check (tanner2_energies.Q_nonsmooth : forall (n : nat) (V V' : nat -> nat -> R -> R) (R0 : R) (r v : nat -> C), 0 < R0 -> (forall i j, V i j = V j i) ->
  (forall i j s, (i < n)%nat -> (j < n)%nat -> i <> j -> 0 < s -> is_derive (V i j) s (V' i j s)) ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> i <> j -> 0 < V' i j R0) -> distinct n complete r ->
  forall i j, (i < n)%nat -> (j < n)%nat -> i <> j -> norm (r i - r j)%C = R0 -> ~ exists a b, tanner2_energies.total_derivative n (tanner2_facts.Qsat n V R0) r v a b).
(* where no pair is at R, Q is differentiable: what the generalised gradient is made of *)
Check (tanner2_energies.Q_gradient : forall (n : nat) (V V' : nat -> nat -> R -> R) (R0 : R) (r v : nat -> C), (forall i j, V i j = V j i) -> (forall i j, V' i j = V' j i) ->
  (forall i j s, (i < n)%nat -> (j < n)%nat -> i <> j -> 0 < s -> is_derive (V i j) s (V' i j s)) -> distinct n complete r -> tanner2_limits.generic n R0 r ->
  tanner2_energies.total_derivative n (tanner2_facts.Qsat n V R0) r v (grad_i n (tanner2_facts.near r R0) V' r) v).
(* tanner2.eq13 *)
Check (eq_refl : tanner2_limits.generic = fun n R0 q => forall i j, (i < n)%nat -> (j < n)%nat -> i <> j -> Cmod (q i - q j)%C <> R0).
Check (eq_refl : tanner2_limits.same_pairs = fun n g h => forall i j, (i < n)%nat -> (j < n)%nat -> g i j = h i j).
Check (eq_refl : tanner2_limits.occurs = fun n R0 r g => forall e, 0 < e -> exists q : nat -> C, (forall i, (i < n)%nat -> Cmod (q i - r i)%C < e) /\
  tanner2_limits.generic n R0 q /\ tanner2_limits.same_pairs n g (tanner2_filippov.by_distance q R0)).
Check (eq_refl : tanner2_energies.limit_of_gradient = fun n V' R0 r v y z => forall e, 0 < e -> exists q u : nat -> C,
  (forall i, (i < n)%nat -> Cmod (q i - r i)%C < e /\ Cmod (u i - v i)%C < e) /\ tanner2_limits.generic n R0 q /\
  forall i, (i < n)%nat -> Cmod (tanner2_filippov.gradV n (tanner2_filippov.by_distance q R0) V' q i - y i)%C < e /\ Cmod (u i - z i)%C < e).
Check (eq_refl : tanner2_energies.gradient_Q = fun n V' R0 r v a b => exists m (c : nat -> R) (y z : nat -> nat -> C),
  (forall k, (k < m)%nat -> 0 <= c k /\ tanner2_energies.limit_of_gradient n V' R0 r v (y k) (z k)) /\ Sum m c = 1 /\
  forall i, (i < n)%nat -> a i = Csum m (fun k => RtoC (c k) * y k i)%C /\ b i = Csum m (fun k => RtoC (c k) * z k i)%C).
Check (eq_refl : tanner2_energies.derivative_Q = fun n V' R0 r v x => forall a b, tanner2_energies.gradient_Q n V' R0 r v a b ->
  exists z, tanner2_filippov.K10 n V' R0 r v z /\ x = Sum n (fun i => inner (a i) (v i) + inner (b i) (z i))).
Check (eq_refl : tanner2_energies.hull13 = fun n R0 r v y => exists m (c : nat -> R) (g : nat -> graph), (forall k, (k < m)%nat -> 0 <= c k /\ tanner2_limits.occurs n R0 r (g k)) /\
  Sum m c = 1 /\ y = Sum m (fun k => c k * Sum n (fun i => inner (v i) (Csum n (fun j => if g k i j then v i - v j else 0)%C)))).
Check (tanner2_energies.eq13 : forall (n : nat) (V V' : nat -> nat -> R -> R) (R0 : R) (r v : nat -> C), 0 < R0 -> tanner2_filippov.potentials n complete V V' ->
  tanner2_filippov.apart_at n complete r -> forall x, tanner2_energies.derivative_Q n V' R0 r v x -> tanner2_energies.hull13 n R0 r v (- x)).
Check (tanner2_energies.eq13_negative : forall (n : nat) (V V' : nat -> nat -> R -> R) (R0 : R) (r v : nat -> C), 0 < R0 -> tanner2_filippov.potentials n complete V V' ->
  tanner2_filippov.apart_at n complete r -> forall x, tanner2_energies.derivative_Q n V' R0 r v x -> x <= 0).
Check (tanner2_energies.Q_falls : forall (n : nat) (V V' : nat -> nat -> R -> R) (R0 : R) (r v : nat -> R -> C) (T : R), 0 < R0 -> tanner2_filippov.potentials n complete V V' ->
  tanner2_filippov.motion10_until T n V' R0 r v -> forall a b, 0 <= a <= b -> b < T ->
  tanner2_facts.Qsat n V R0 (fun i => r i b) (fun i => v i b) <= tanner2_facts.Qsat n V R0 (fun i => r i a) (fun i => v i a)).
