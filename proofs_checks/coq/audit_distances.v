(* Audit of the square of the distance of two birds, (3.18), and of the lengths of lifted birds, (3.15): each theorem of theorems.tsv with its statement written out; the objects of the statements are restated first. *)
Set Warnings "-notation-overridden,-ambiguous-paths".
From mathcomp Require Import all_ssreflect all_algebra.
From Flockproof Require Import chazelle_model chazelle_ergodicity chazelle_fixed chazelle_limits chazelle_spectral.
From Flockproof Require chazelle_distances chazelle_lifted.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Import GRing.Theory Num.Theory Order.Theory.
Local Open Scope ring_scope.

Check (fun n (G : rel 'I_n) => erefl : network G = (symmetric G /\ irreflexive G)).
Check (fun n (G : rel 'I_n) i => erefl : degree G i = #|[pred j | G i j]|).
Check (fun (R : realFieldType) n (G : rel 'I_n) i j => mxE _ _ i j : laplacian R G i j =
  if i == j then (degree G i)%:R else if G i j then -1 else 0).
Check (fun (R : realFieldType) n (G : rel 'I_n) (c : 'I_n -> R) => erefl : transition G c = 1%:M - diag_mx (\row_i c i) *m laplacian R G).
Check (fun (R : realFieldType) n (G : rel 'I_n) (c : 'I_n -> R) => erefl : model_D G c = forall i, (0 < degree G i)%N -> 0 < c i * (degree G i)%:R < 1).
Check (fun (R : realFieldType) n (c : 'I_n -> R) i => erefl : stat c i = (\sum_k (c k)^-1)^-1 * (c i)^-1).
Check (fun (R : realFieldType) m (G : rel 'I_m.+1) (c : 'I_m.+1 -> R) =>
  erefl : Gamma G c = last_col (1%:M - rank1 c) 0 *m invmx (last_col (1%:M - transition G c) (ones R m))).
Check (fun (R : rcfType) p (x : 'rV[R]_p) => erefl : norm2 x = Num.sqrt (\sum_k x 0 k ^+ 2)).
(* the eigenvalues lam k, k > 0; the moduli of some numbers and of their products, but for 0, each once and in order *)
Check (fun (R : rcfType) m (lam : 'I_m.+1 -> R) => erefl : chazelle_distances.other lam = [seq lam k | k <- enum [pred k : 'I_m.+1 | k != ord0]]).
Check (fun (R : realFieldType) (mu : seq R) => erefl : chazelle_distances.moduli mu =
  sort (fun r r' => r' <= r) (undup [seq `|y| | y <- mu ++ [seq y * z | y <- mu, z <- mu] & y != 0])).
Check (@chazelle_distances.in_moduli : forall (R : realFieldType) (mu : seq R) (r : R), (r \in chazelle_distances.moduli mu) =
  (r != 0) && ((r \in [seq `|y| | y <- mu]) || (r \in [seq `|y * z| | y <- mu, z <- mu]))).
Check (fun (R : rcfType) m (c : 'I_m.+1 -> R) i => erefl : u1 c i = Num.sqrt (stat c i)).
Check (fun (R : rcfType) m (G : rel 'I_m.+1) (c : 'I_m.+1 -> R) i j => ME G c i j : M G c i j = (Num.sqrt (c i))^-1 * transition G c i j * Num.sqrt (c j)).
Check (fun (R : rcfType) m (c : 'I_m.+1 -> R) d (v : nat -> 'M[R]_(m.+1, d)) t1 q => erefl : drift c v t1 q = \sum_j stat c j * v t1.+1 j q).

(* chazelle.eq3.18: birds of two flocks *)
Check (@chazelle_distances.eq_3_18 :
  forall (R : rcfType) n d t1
  m (G : rel 'I_m.+1) (c : 'I_m.+1 -> R) (U : 'M[R]_m.+1) (lam : 'I_m.+1 -> R) (x v : nat -> 'M[R]_(m.+1, d)) (i : 'I_m.+1)
  m' (G' : rel 'I_m'.+1) (c' : 'I_m'.+1 -> R) (U' : 'M[R]_m'.+1) (lam' : 'I_m'.+1 -> R)
  (x' v' : nat -> 'M[R]_(m'.+1, d)) (i' : 'I_m'.+1),
  network G -> model_D G c -> (forall a b, connect G a b) -> (forall a, 0 < c a) ->
  U^T *m U = 1%:M -> (forall a k, \sum_b M G c a b * U b k = lam k * U a k) -> (forall a, U a 0 = u1 c a) -> lam 0 = 1 ->
  (forall t, (t1 <= t)%N -> x t.+1 = x t + v t.+1) -> (forall t, (t1 < t)%N -> v t.+1 = transition G c *m v t) ->
  network G' -> model_D G' c' -> (forall a b, connect G' a b) -> (forall a, 0 < c' a) ->
  U'^T *m U' = 1%:M -> (forall a k, \sum_b M G' c' a b * U' b k = lam' k * U' a k) -> (forall a, U' a 0 = u1 c' a) -> lam' 0 = 1 ->
  (forall t, (t1 <= t)%N -> x' t.+1 = x' t + v' t.+1) -> (forall t, (t1 < t)%N -> v' t.+1 = transition G' c' *m v' t) ->
  let A := row i (x t1) - row i' (x' t1) + (row i (Gamma G c *m v t1.+1) - row i' (Gamma G' c' *m v' t1.+1)) in
  (forall q, drift c v t1 q = drift c' v' t1 q) -> norm2 A = 1 ->
  (m.+1 + m'.+1 <= n)%N ->
  let rho := chazelle_distances.moduli (chazelle_distances.other lam ++ chazelle_distances.other lam') in
  [/\ sorted (fun r r' => r' < r) rho, forall r, r \in rho -> 0 < r < 1, (size rho < n ^ 2)%N &
    exists up um : R -> R, forall t, (t1 < t)%N ->
      norm2 (row i (x t) - row i' (x' t)) ^+ 2 - 1 = \sum_(r <- rho) (up r + (-1) ^+ t * um r) * r ^+ (t - t1)]).
(* chazelle.eq3.18: two birds of one flock *)
Check (@chazelle_distances.eq_3_18_one :
  forall (R : rcfType) n d t1
  m (G : rel 'I_m.+1) (c : 'I_m.+1 -> R) (U : 'M[R]_m.+1) (lam : 'I_m.+1 -> R) (x v : nat -> 'M[R]_(m.+1, d)) (i j : 'I_m.+1),
  network G -> model_D G c -> (forall a b, connect G a b) -> (forall a, 0 < c a) ->
  U^T *m U = 1%:M -> (forall a k, \sum_b M G c a b * U b k = lam k * U a k) -> (forall a, U a 0 = u1 c a) -> lam 0 = 1 ->
  (forall t, (t1 <= t)%N -> x t.+1 = x t + v t.+1) -> (forall t, (t1 < t)%N -> v t.+1 = transition G c *m v t) ->
  norm2 (row i (x t1) - row j (x t1) + (row i (Gamma G c *m v t1.+1) - row j (Gamma G c *m v t1.+1))) = 1 ->
  (m < n)%N ->
  let rho := chazelle_distances.moduli (chazelle_distances.other lam) in
  [/\ sorted (fun r r' => r' < r) rho, forall r, r \in rho -> 0 < r < 1, (size rho < n ^ 2)%N &
    exists up um : R -> R, forall t, (t1 < t)%N ->
      norm2 (row i (x t) - row j (x t)) ^+ 2 - 1 = \sum_(r <- rho) (up r + (-1) ^+ t * um r) * r ^+ (t - t1)]).

(* chazelle.eq3.15, clause 2: the lengths of v_i(t) and x_i(t)/t *)
Check (fun (R : realFieldType) n p (A : 'M[R]_(n, p)) => erefl : stochastic A = ((forall i k, 0 <= A i k) /\ forall i, \sum_k A i k = 1)).
Check (@chazelle_lifted.lifted_lengths :
  forall (R : rcfType) (n d b : nat) (P : nat -> 'M[R]_n) (x v : nat -> 'M[R]_(n, d)),
  (2 <= n)%N -> (d <= n ^ 2)%N -> (forall t, (0 < t)%N -> stochastic (P t)) ->
  (forall t, (0 < t)%N -> v t.+1 = P t *m v t) -> (forall t, x t.+1 = x t + v t.+1) ->
  (forall i q, `|v 1%N i q| <= n%:R ^+ b) -> (forall i q, `|x 0%N i q| <= n%:R ^+ b) ->
  forall (t : nat) (i : 'I_n), (0 < t)%N ->
  1 + norm2 (row i (v t)) ^+ 2 <= n%:R ^+ (2 * b + 5) /\ 1 + norm2 (t%:R^-1 *: row i (x t)) ^+ 2 <= n%:R ^+ (2 * b + 5)).
