(* Clauses of the claims about Chazelle's paper, formalised from their words before the theorems were looked at. *)
From mathcomp Require Import all_ssreflect all_algebra.
From Flockproof Require Import chazelle_model chazelle_ergodicity chazelle_fixed chazelle_limits chazelle_products chazelle_entries.
From Flockproof Require chazelle_recurrent chazelle_agreement chazelle_switches chazelle_origins chazelle_stabilisers.
Set Implicit Arguments.
Unset Strict Implicit.
Import GRing.Theory Num.Theory Order.TTheory.
Local Open Scope ring_scope.

(* the times 2, ..., T at which the network is not the one before: the switches up to T *)
Definition differs n (G : nat -> rel 'I_n) u := [exists i, exists j, G u i j != G u.-1 i j].
Definition switches_up_to n (G : nat -> rel 'I_n) T := count (differs G) (iota 2 T.-1).

(* beyond.chazelle.angle clause 2; max|x(0)| over all birds and coordinates, as any number that is not exceeded *)
Definition angle_2 : Prop := forall (R : rcfType) (n d a : nat) (G : nat -> rel 'I_n) (c : nat -> 'I_n -> R)
  (x v : nat -> 'M[R]_(n, d)) (X : R),
  (0 < a)%N -> (forall t, (0 < t)%N -> network (G t)) -> (forall t, (0 < t)%N -> model_D (G t) (c t)) ->
  (forall t i j, (0 < t)%N -> 0 < transition (G t) (c t) i j -> (n%:R ^+ a)^-1 <= transition (G t) (c t) i j) ->
  (forall s t, (0 < s)%N -> (0 < t)%N -> (forall i j, G s i j = G t i j) -> forall i, c s i = c t i) ->
  (forall t, x t.+1 = x t + v t.+1) -> (forall t, (0 < t)%N -> v t.+1 = transition (G t) (c t) *m v t) ->
  (forall t i j, (0 < t)%N -> G t i j -> norm2 (row i (x t) - row j (x t)) <= 2%:R) ->
  (forall i q, `|x 0%N i q| <= X) ->
  forall t i q, (0 < t)%N -> `|x t i q - t%:R * v t i q| <= X + 4%:R * (switches_up_to G t.-1).+1%:R * n%:R ^+ (2 * a + 3).

(* beyond.chazelle.entries clauses 1 and 2 *)
Definition entries_1 : Prop := forall (R : realFieldType) n (G : nat -> rel 'I_n), (1 < n)%N -> (forall t, network (G t)) ->
  forall s t i j, (s <= t)%N ->
  (pprod (fun u => transition (G u) (vicsek R (G u))) t s i j != 0 ->
     n`!%:R^-1 <= pprod (fun u => transition (G u) (vicsek R (G u))) t s i j) /\
  (pprod (fun u => transition (G u) (lazy R (G u))) t s i j != 0 ->
     2%:R ^+ (n - 2) / (3%:R ^+ n.-1 * n.-1`!%:R) <= pprod (fun u => transition (G u) (lazy R (G u))) t s i j).
Definition entries_2 : Prop := forall (R : realFieldType) n, (1 < n)%N ->
  (exists (G : nat -> rel 'I_n) s t i j, [/\ forall u, network (G u), (s <= t)%N &
     pprod (fun u => transition (G u) (vicsek R (G u))) t s i j = n`!%:R^-1]) /\
  (exists (G : nat -> rel 'I_n) s t i j, [/\ forall u, network (G u), (s <= t)%N &
     pprod (fun u => transition (G u) (lazy R (G u))) t s i j = 2%:R ^+ (n - 2) / (3%:R ^+ n.-1 * n.-1`!%:R)]).

(* beyond.chazelle.recurrent; the union of networks from time s to s + k - 1 *)
Definition unions n (G : nat -> rel 'I_n) s k : rel 'I_n := fun i j => [exists u : 'I_k, G (s + u)%N i j].
Fixpoint windows_connected n (G : nat -> rel 'I_n) s (ks : seq nat) : Prop :=
  if ks is k :: r then (forall i j, connect (unions G s k) i j) /\ windows_connected G (s + k)%N r else True.
Definition recurrent_1 : Prop := forall (R : rcfType) n d (G : nat -> rel 'I_n) (c : nat -> 'I_n -> R) (alpha : R)
  (v : nat -> 'M[R]_(n, d)) s ks,
  (1 < n)%N -> (forall t, (0 < t)%N -> network (G t)) -> (forall t, (0 < t)%N -> model_D (G t) (c t)) -> 0 < alpha ->
  (forall t i j, (0 < t)%N -> 0 < transition (G t) (c t) i j -> alpha <= transition (G t) (c t) i j) ->
  (forall t, (0 < t)%N -> v t.+1 = transition (G t) (c t) *m v t) ->
  (0 < s)%N -> windows_connected G s ks ->
  diameter (@norm2 R d) (v (s + sumn ks)%N) <= (1 - alpha ^+ n.-1) ^+ (size ks %/ n.-1) * diameter (@norm2 R d) (v s).
(* i listens to j at some time from s to s + B - 1; from every bird a path leads to r *)
Definition heard_in (R : realFieldType) n (P : nat -> 'M[R]_n) s B : rel 'I_n := fun i j => [exists u : 'I_B, P (s + u)%N i j != 0].
Definition leads_to_one n (G : rel 'I_n) := exists r, forall i, connect G i r.
Definition recurrent_2 : Prop := forall (R : realFieldType) n (P : nat -> 'M[R]_n) (alpha : R) B,
  (1 < n)%N -> (forall t, (0 < t)%N -> stochastic (P t)) -> (forall t i, (0 < t)%N -> 0 < P t i i) -> 0 < alpha ->
  (forall t i j, (0 < t)%N -> 0 < P t i j -> alpha <= P t i j) ->
  (forall s, (0 < s)%N -> leads_to_one (heard_in P s B)) ->
  forall s t, (0 < s)%N -> tau1 (span P s t) <= (1 - alpha ^+ (n.-1 * B)) ^+ (t %/ (n.-1 * B)).
(* the real numbers: an Archimedean field in which Cauchy sequences converge *)
Definition cauchy_complete (R : realFieldType) := forall a : nat -> R,
  (forall eps, 0 < eps -> exists T, forall t u, (T <= t)%N -> (T <= u)%N -> `|a t - a u| < eps) ->
  exists l, forall eps, 0 < eps -> exists T, forall t, (T <= t)%N -> `|a t - l| < eps.
Definition one_limit (R : realFieldType) n d (v : nat -> 'M[R]_(n, d)) := exists l : 'I_d -> R,
  forall eps, 0 < eps -> exists T, forall t i q, (T <= t)%N -> `|v t i q - l q| < eps.
Definition recurrent_3 : Prop := forall (R : archiFieldType) n d (G : nat -> rel 'I_n) (c : nat -> 'I_n -> R) (alpha : R)
  (v : nat -> 'M[R]_(n, d)),
  cauchy_complete R ->
  (1 < n)%N -> (forall t, (0 < t)%N -> network (G t)) -> (forall t, (0 < t)%N -> model_D (G t) (c t)) -> 0 < alpha ->
  (forall t i j, (0 < t)%N -> 0 < transition (G t) (c t) i j -> alpha <= transition (G t) (c t) i j) ->
  (forall t, (0 < t)%N -> v t.+1 = transition (G t) (c t) *m v t) ->
  (forall s, (0 < s)%N -> exists k, forall i j, connect (unions G s k) i j) -> one_limit v.
Definition recurrent_4 : Prop := forall (R : archiFieldType) n d (P : nat -> 'M[R]_n) (alpha : R) B (v : nat -> 'M[R]_(n, d)),
  cauchy_complete R ->
  (1 < n)%N -> (forall t, (0 < t)%N -> stochastic (P t)) -> (forall t i, (0 < t)%N -> 0 < P t i i) -> 0 < alpha ->
  (forall t i j, (0 < t)%N -> 0 < P t i j -> alpha <= P t i j) -> (forall s, (0 < s)%N -> leads_to_one (heard_in P s B)) ->
  (forall t, (0 < t)%N -> v t.+1 = P t *m v t) ->
  exists l : 'I_d -> R, forall t i q,
    `|v t.+1 i q - l q| <= (1 - alpha ^+ (n.-1 * B)) ^+ (t %/ (n.-1 * B)) * diameter (fun y : 'rV[R]_d => `|y 0 q|) (v 1%N).

(* a flock of model D with the printed hysteresis rule; positive entries of P(t) at least n^-a, speeds at most n^c *)
Definition flock_D (R : rcfType) n d a c (x v : nat -> 'M[R]_(n, d)) (G : nat -> rel 'I_n) (w : nat -> 'I_n -> R) :=
  let dist t i j := norm2 (row i (x t) - row j (x t)) in
  [/\ forall i j, G 0%N i j = (i != j) && (dist 0%N i j <= 1),
      forall t i j, G t.+1 i j = (i != j) && ((dist t.+1 i j <= 1) ||
        (G t i j && (`|dist t.+1 i j - dist t i j| < (n%:R ^+ (n ^ 4))^-1))),
      forall t, x t.+1 = x t + v t.+1 &
      forall t, (0 < t)%N -> [/\ model_D (G t) (w t), v t.+1 = transition (G t) (w t) *m v t,
        forall i j, 0 < transition (G t) (w t) i j -> (n%:R ^+ a)^-1 <= transition (G t) (w t) i j &
        forall i, norm2 (row i (v t)) <= n%:R ^+ c]].
(* beyond.chazelle.switches clause 1 *)
Definition switches_1 : Prop := forall (R : rcfType) n d a c (x v : nat -> 'M[R]_(n, d)) G w, (1 < n)%N -> flock_D a c x v G w ->
  forall T, (switches_up_to G T <= n ^ (a * n.-1 ^ 2 + (c + 9) * n.-1 + 1))%N.
(* chazelle.lem3.1 clause 1, chazelle.thm1.1.switches clause 1 *)
Definition lem3_1 : Prop := forall a c, exists K, forall (R : rcfType) n d (x v : nat -> 'M[R]_(n, d)) G w, (1 < n)%N ->
  flock_D a c x v G w -> forall T, (switches_up_to G T <= n ^ (K * n ^ 3))%N.

(* chazelle.eq2.3, in a fixed dimension, with coordinates at time 1 of absolute value at most n^b *)
Definition eq2_3 : Prop := forall b d, exists K, forall (R : rcfType) n (G : nat -> rel 'I_n) (c : nat -> 'I_n -> R)
  (v : nat -> 'M[R]_(n, d)), (1 < n)%N ->
  (forall t, (0 < t)%N -> network (G t)) -> (forall t, (0 < t)%N -> model_D (G t) (c t)) ->
  (forall t, (0 < t)%N -> v t.+1 = transition (G t) (c t) *m v t) -> (forall i q, `|v 1%N i q| <= n%:R ^+ b) ->
  forall t, (0 < t)%N -> Num.sqrt (\sum_i \sum_q v t i q ^+ 2) <= n%:R ^+ K.

(* chazelle.lem2.1 *)
Definition lem2_1 : Prop := forall (R : rcfType) n d (x v : nat -> 'M[R]_(n, d)), (forall t, x t.+1 = x t + v t.+1) ->
  forall t i j, (0 < t)%N ->
  `| norm2 (row i (x t) - row j (x t)) - norm2 (row i (x t.-1) - row j (x t.-1)) | <= norm2 (row i (v t) - row j (v t)).
(* chazelle.lem2.2.entries *)
Definition lem2_2_entries : Prop := forall (R : realFieldType) n a (G : nat -> rel 'I_n) (c : nat -> 'I_n -> R),
  (forall t, network (G t)) -> (forall t, model_D (G t) (c t)) ->
  (forall t i j, 0 < transition (G t) (c t) i j -> (n%:R ^+ a)^-1 <= transition (G t) (c t) i j) ->
  forall s t i j, (s <= t)%N -> pprod (fun u => transition (G u) (c u)) t s i j != 0 ->
  (n%:R ^+ (a * n ^ 2))^-1 <= pprod (fun u => transition (G u) (c u)) t s i j.
(* chazelle.lem2.2.bits: numerators and denominator of size n^(K (t - s + 1) n) *)
Definition over (R : realFieldType) m p (A : 'M[R]_(m, p)) (size : nat) := exists D : nat, (0 < D <= size)%N /\
  forall i j, exists z : int, A i j = z%:~R / D%:R /\ (`|z| <= size)%N.
Definition lem2_2_bits : Prop := forall a, exists K, forall (R : realFieldType) n (G : nat -> rel 'I_n) (c : nat -> 'I_n -> R),
  (1 < n)%N -> (forall t, network (G t)) -> (forall t, model_D (G t) (c t)) -> (forall t, short_weights a (c t)) ->
  forall s t, (1 <= s <= t)%N -> over (pprod (fun u => transition (G u) (c u)) t s) (n ^ (K * (t - s).+1 * n)).
(* chazelle.lem2.3 *)
Definition lem2_3 : Prop := forall a b d, exists K, forall (R : realFieldType) n (G : nat -> rel 'I_n) (c : nat -> 'I_n -> R)
  (x v : nat -> 'M[R]_(n, d)),
  (1 < n)%N -> (forall t, network (G t)) -> (forall t, model_D (G t) (c t)) -> (forall t, short_weights a (c t)) ->
  (forall t, x t.+1 = x t + v t.+1) -> (forall t, (0 < t)%N -> v t.+1 = transition (G t) (c t) *m v t) ->
  short_input b (x 0%N) -> short_input b (v 1%N) ->
  forall t, (0 < t)%N -> over (v t) (n ^ (K * t * n)) /\ over (x t) (n ^ (K * t * n)).
(* chazelle.lem2.4 *)
Definition lem2_4 : Prop := forall (R : rcfType) l m p (A : 'M[R]_(l, m)) (B : 'M[R]_(m, p)),
  stochastic A -> stochastic B -> tau2 (A *m B) <= tau1 A * tau2 B.
(* chazelle.tau1 *)
Definition tau1_1 : Prop := forall (R : realFieldType) m p (A : 'M[R]_(m.+1, p)), stochastic A ->
  0 <= tau1 A <= 1 /\
  (forall i j, 1 - tau1 A <= \sum_k Num.min (A i k) (A j k)) /\ exists i j, 1 - tau1 A = \sum_k Num.min (A i k) (A j k).
(* chazelle.tau2sqrt2 *)
Definition tau2_sqrt2 : Prop := forall (R : rcfType) m p (A : 'M[R]_(m, p)), stochastic A ->
  tau2 A <= tau1 A * tau2 (1%:M : 'M[R]_p) /\ tau1 A * tau2 (1%:M : 'M[R]_p) <= Num.sqrt 2%:R * tau1 A.

(* ---- a fixed connected network; P = I - C L ---- *)
Definition fixed (R : realFieldType) n (G : rel 'I_n) (c : 'I_n -> R) :=
  [/\ network G, model_D G c, forall i j, connect G i j & forall i, 0 < c i].
(* chazelle.pi; the eigenvalues of P are real, as P is similar to a symmetric matrix; simple: also no generalised eigenvector *)
Definition pi_123 : Prop := forall (R : realFieldType) n (G : rel 'I_n) (c : 'I_n -> R), (0 < n)%N -> fixed G c ->
  let P := transition G c in let pi := \row_j ((\sum_i (c i)^-1)^-1 * (c j)^-1) in
  [/\ P *m const_mx 1 = (const_mx 1 : 'cV_n), pi *m P = pi,
    forall u : 'cV[R]_n, P *m u = u -> exists k, u = k *: const_mx 1,
    forall u : 'cV[R]_n, (P - 1%:M) *m ((P - 1%:M) *m u) = 0 -> (P - 1%:M) *m u = 0 &
    forall (lam : R) (u : 'cV[R]_n), u != 0 -> P *m u = lam *: u -> lam != 1 -> `|lam| < 1].
(* chazelle.lem3.2 *)
Definition lem3_2 : Prop := forall a, exists K, forall (R : realFieldType) n (G : rel 'I_n) (c : 'I_n -> R), (1 < n)%N ->
  fixed G c -> short_weights a c ->
  forall (lam : R) (u : 'cV[R]_n), u != 0 -> transition G c *m u = lam *: u -> lam != 1 -> `|lam| <= 1 - (n%:R ^+ K)^-1.
(* chazelle.lem3.3: converges entry by entry; (Y | y) replaces the last column *)
Definition with_last (R : realFieldType) m (Y : 'M[R]_m.+1) (y : 'cV[R]_m.+1) : 'M[R]_m.+1 := \matrix_(i, j) if j == ord_max then y i 0 else Y i j.
Definition one_pi (R : realFieldType) n (c : 'I_n -> R) : 'M[R]_n := \matrix_(i, j) ((\sum_i (c i)^-1)^-1 * (c j)^-1).
Definition Gamma_of (R : realFieldType) m (G : rel 'I_m.+1) (c : 'I_m.+1 -> R) :=
  with_last (1%:M - one_pi c) 0 *m invmx (with_last (1%:M - transition G c) (const_mx 1)).
Definition tends_to (R : realFieldType) m p (A : nat -> 'M[R]_(m, p)) B :=
  forall eps, 0 < eps -> exists T, forall t i j, (T <= t)%N -> `|A t i j - B i j| < eps.
Definition lem3_3 : Prop := forall (R : archiFieldType) m (G : rel 'I_m.+1) (c : 'I_m.+1 -> R), fixed G c ->
  with_last (1%:M - transition G c) (const_mx 1) \in unitmx /\
  tends_to (fun t => \sum_(s < t) mpow (transition G c) s - t%:R *: one_pi c) (Gamma_of G c).
(* chazelle.lem3.4 *)
Definition lem3_4 : Prop := forall (R : archiFieldType) m d (G : rel 'I_m.+1) (c : 'I_m.+1 -> R) (x v : nat -> 'M[R]_(m.+1, d)),
  fixed G c -> (forall t, x t.+1 = x t + v t.+1) -> (forall t, (0 < t)%N -> v t.+1 = transition G c *m v t) ->
  tends_to (fun t => x t - one_pi c *m x t) ((1%:M - one_pi c) *m x 0%N + Gamma_of G c *m v 1%N) /\
  exists w, forall t, one_pi c *m x t = one_pi c *m x 0%N + t%:R *: (one_pi c *m w).
(* chazelle.lem3.5 *)
Definition lem3_5 : Prop := forall a d, exists K, forall (R : realFieldType) m (G : rel 'I_m.+1) (c : 'I_m.+1 -> R)
  (x0 v1 : 'M[R]_(m.+1, d)), (0 < m)%N -> fixed G c -> short_weights a c -> short_input a x0 -> short_input a v1 ->
  over ((1%:M - one_pi c) *m x0 + Gamma_of G c *m v1) (m.+1 ^ (K * m.+1)) /\ over (Gamma_of G c) (m.+1 ^ (K * m.+1)).
(* chazelle.eq3.9; (1 - n^-K)^s <= e^(-s n^-K) *)
Definition eq3_9 : Prop := forall a, exists K, forall (R : realFieldType) n (G : rel 'I_n) (c : 'I_n -> R), (1 < n)%N ->
  fixed G c -> short_weights a c ->
  forall s i j, `|mpow (transition G c) s i j - one_pi c i j| <= n%:R ^+ K * (1 - (n%:R ^+ K)^-1) ^+ s.
(* chazelle.eq3.12-13 *)
Definition eq3_12_13 : Prop := forall (R : realFieldType) m d (G : rel 'I_m.+1) (c : 'I_m.+1 -> R) (x v : nat -> 'M[R]_(m.+1, d)),
  fixed G c -> (forall t, x t.+1 = x t + v t.+1) -> (forall t, (0 < t)%N -> v t.+1 = transition G c *m v t) ->
  forall t, x t = x 0%N + (\sum_(s < t) mpow (transition G c) s) *m v 1%N /\
    x t = x 0%N + t%:R *: (one_pi c *m v 1%N) + (\sum_(s < t) mpow (transition G c) s - t%:R *: one_pi c) *m v 1%N.
(* chazelle.fiedler.rate clause 3: every eigenvalue of the Laplacian but the 0 of the constant vectors *)
Definition fiedler_3 : Prop := forall (R : realFieldType) n (G : rel 'I_n), (1 < n)%N -> network G -> (forall i j, connect G i j) ->
  forall (lam : R) (u : 'cV[R]_n), (exists i j, u i 0 != u j 0) -> laplacian R G *m u = lam *: u ->
  4%:R / (n%:R * n.-1%:R) <= lam.
(* chazelle.fiedler.rate clause 5, to the power n^3: at most n 2^(-t/n^3) times the largest of the first differences *)
Definition fiedler_5 : Prop := forall (R : rcfType) n d (G : rel 'I_n) (v : nat -> 'M[R]_(n, d)), (1 < n)%N -> network G ->
  (forall i j, connect G i j) ->
  (forall t, (0 < t)%N -> v t.+1 = transition G (lazy R G) *m v t) \/
  (forall t, (0 < t)%N -> v t.+1 = transition G (vicsek R G) *m v t) ->
  forall t, (0 < t)%N ->
  2%:R ^+ t * diameter (@norm2 R d) (v t) ^+ (n ^ 3) <= (n%:R * diameter (@norm2 R d) (v 1%N)) ^+ (n ^ 3).

(* chazelle.foot.mono clause 1; chazelle.modelD.stoch *)
Definition foot_1 : Prop := forall (R : realFieldType) n (G : nat -> rel 'I_n) (c : nat -> 'I_n -> R),
  (forall t, network (G t)) -> (forall t, model_D (G t) (c t)) ->
  forall s t t' i j, (s <= t)%N -> (t <= t')%N -> pprod (fun u => transition (G u) (c u)) t s i j != 0 ->
  pprod (fun u => transition (G u) (c u)) t' s i j != 0.
Definition modelD_12 : Prop := forall (R : realFieldType) n (G : rel 'I_n) (c : 'I_n -> R), network G -> model_D G c ->
  stochastic (transition G c) /\ forall i, 0 < transition G c i i.
