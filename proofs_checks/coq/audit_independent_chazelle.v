(* Clauses of the claims about Chazelle's paper, formalised from their words before the theorems were looked at; the theorems
   prove them. *)
Set Warnings "-notation-overridden,-ambiguous-paths".
From mathcomp Require Import all_ssreflect all_algebra zify.
From Flockproof Require Import chazelle_model chazelle_ergodicity chazelle_fixed chazelle_limits chazelle_products chazelle_entries.
From Flockproof Require chazelle_recurrent chazelle_agreement chazelle_switches chazelle_count chazelle_origins
  chazelle_stabilisers chazelle_sharp chazelle_network chazelle_bits.
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
(* chazelle.fiedler.rate clause 5, to the power n^3: after t steps at most n 2^(-t/n^3) times the largest of the first differences *)
Definition fiedler_5 : Prop := forall (R : rcfType) n d (G : rel 'I_n) (v : nat -> 'M[R]_(n, d)), (1 < n)%N -> network G ->
  (forall i j, connect G i j) ->
  (forall t, (0 < t)%N -> v t.+1 = transition G (lazy R G) *m v t) \/
  (forall t, (0 < t)%N -> v t.+1 = transition G (vicsek R G) *m v t) ->
  forall t, 2%:R ^+ t * diameter (@norm2 R d) (v t.+1) ^+ (n ^ 3) <= (n%:R * diameter (@norm2 R d) (v 1%N)) ^+ (n ^ 3).

(* chazelle.foot.mono clause 1 *)
Definition foot_1 : Prop := forall (R : realFieldType) n (G : nat -> rel 'I_n) (c : nat -> 'I_n -> R),
  (forall t, network (G t)) -> (forall t, model_D (G t) (c t)) ->
  forall s t t' i j, (s <= t)%N -> (t <= t')%N -> pprod (fun u => transition (G u) (c u)) t s i j != 0 ->
  pprod (fun u => transition (G u) (c u)) t' s i j != 0.
(* chazelle.modelD.stoch *)
Definition modelD_12 : Prop := forall (R : realFieldType) n (G : rel 'I_n) (c : 'I_n -> R), network G -> model_D G c ->
  stochastic (transition G c) /\ forall i, 0 < transition G c i i.

(* ---- the theorems prove them ---- *)
Lemma angle_2_proved : angle_2.
Proof.
move=> R n d a G c x v X a0 net MD fl same Hx Hv sh X0 t i q t0.
pose G' u := G u.-1.+1; pose c' u := c u.-1.+1.
have E u : (0 < u)%N -> G' u = G u /\ c' u = c u by case: u.
have := @chazelle_origins.origins_stay R n d a G' c' x v _ _ a0 _ _ Hx _ _ q t i X t0 (fun j => X0 j q).
move=> H; apply: (le_trans (H _ _ _ _ _ _)).
- by move=> u u0; case: (E u u0) => -> _; apply: net.
- by move=> u u0; case: (E u u0) => -> ->; apply: MD.
- by move=> u i' j' u0; case: (E u u0) => -> ->; apply: fl.
- by move=> s u e; apply: same.
- by move=> u u0; case: (E u u0) => -> ->; apply: Hv.
- by move=> u i' j' u0; case: (E u u0) => -> _; apply: sh.
suff -> : chazelle_origins.switches G' t = switches_up_to G t.-1 by [].
rewrite /chazelle_origins.switches /switches_up_to -sum1_count [RHS]big_mkcond /=.
rewrite (_ : iota 2 t.-1.-1 = [seq u.+1 | u <- index_iota 1 t.-1]); last first.
  by rewrite /index_iota subn1 -(iotaDl 1).
rewrite big_map; apply: eq_big_nat => k /andP[k0 _].
rewrite /chazelle_origins.changes /differs /G' /= prednK //.
rewrite (_ : [exists i', exists j', G k i' j' != G k.+1 i' j'] = [exists i', exists j', G k.+1 i' j' != G k i' j']).
  by case: ifP.
by apply: eq_existsb => i'; apply: eq_existsb => j'; rewrite eq_sym.
Qed.
Lemma entries_1_proved : entries_1.
Proof.
move=> R n G n1 net s t i j st.
have [A B] := @chazelle_entries.smallest_entries R n G s t i j net st.
by split; [exact: A | exact: (B n1)].
Qed.
Lemma entries_2_proved : entries_2.
Proof.
move=> R n n1; have [G [net [[i [j A]] [k [l B]]]]] := @chazelle_entries.smallest_entries_occur R n n1.
by split; [exists G, 0%N, (n - 2)%N, i, j | exists G, 0%N, (n - 2)%N, k, l].
Qed.

(* time counted from s on *)
Lemma shifted n (G : nat -> rel 'I_n) s r ks : windows_connected G (s + r)%N ks ->
  chazelle_agreement.connected_windows (fun t => G (s + t.-1)%N) r.+1 ks.
Proof.
elim: ks r => [//|k ks IH] r /= [A B]; split; last by rewrite addSn; apply: IH; rewrite addnA.
move=> i j; have := A i j; rewrite (eq_connect (e' := chazelle_agreement.union (fun t => G (s + t.-1)%N) r.+1 k)) //.
by move=> p q; apply: eq_existsb => u; rewrite addSn addnA.
Qed.
Lemma nonneg_entries (R : realFieldType) m n (A : 'M[R]_(m, n)) i j : stochastic A -> A i j != 0 -> 0 < A i j.
Proof. by case=> A0 _ e; rewrite lt_neqAle eq_sym e A0. Qed.
Lemma recurrent_1_proved : recurrent_1.
Proof.
move=> R n d G c alpha v s ks n1 net MD a0 fl Hv s0 W.
have pos t : (0 < s + t)%N by rewrite addn_gt0 s0.
have W' : chazelle_agreement.connected_windows (fun t => G (s + t.-1)%N) 1 ks by apply: shifted; rewrite addn0.
have := @chazelle_agreement.recurrent_velocities R n (fun t => G (s + t.-1)%N) (fun t => c (s + t.-1)%N) alpha
  (fun t => net _ (pos _)) (fun t => MD _ (pos _)) a0.
move=> /(_ (fun t i j h => fl _ i j (pos _) (nonneg_entries (proj1 (model_D_stochastic (net _ (pos _)) (MD _ (pos _)))) h))).
move=> /(_ d (fun t => v (s + t.-1)%N) (@norm2 R d)) D.
rewrite /diameter; apply: max_le => [|[i j] /=].
  rewrite mulr_ge0 ?max_ge0 // exprn_ge0 // subr_ge0; apply: exprn_ile1; first exact: ltW.
  have i0 : 'I_n by exists 0%N; apply: ltnW.
  have [St dg] := model_D_stochastic (net 1%N isT) (MD 1%N isT).
  apply: (le_trans (fl 1%N i0 i0 isT (dg i0))); rewrite -(proj2 St i0) (bigD1 i0) //= ler_addl.
  by apply: sumr_ge0 => k _; apply: (proj1 St).
have := D _ (@norm2_0 R d) (@norm2Z R d) (@norm2D R d) ks (sumn ks).+1 (sumn ks).+1 i j W' (ltnSn _) (ltnSn _).
rewrite /= addn0; apply => t t0; rewrite -Hv //; congr v; by rewrite -addnS prednK.
Qed.
Lemma recurrent_2_proved : recurrent_2.
Proof.
move=> R n P alpha B n1 SP dg a0 fl rt s t s0.
have pos u : (0 < s + u)%N by rewrite addn_gt0 s0.
have := @chazelle_recurrent.tau1_repeatedly R n (fun u => P (s + u)%N) alpha B (fun u => SP _ (pos _)) (fun u i => dg _ i (pos _)) a0.
move=> /(_ (fun u i j h => fl _ i j (pos _) (nonneg_entries (SP _ (pos _)) h))) H.
have {H} := H _ 0%N t; rewrite (_ : span (fun u => P (s + u)%N) 0 t = span P s t); last by elim: t => //= t ->.
apply=> u; have [r h] := rt (s + u)%N (pos _); exists r => i; have := h i.
rewrite (eq_connect (e' := chazelle_recurrent.window (fun u => P (s + u)%N) u B)) // => p q.
by apply: eq_existsb => k; rewrite addnA.
Qed.
Lemma complete_proved (R : realFieldType) : cauchy_complete R -> chazelle_agreement.complete R.
Proof.
move=> H a C; have [|l L] := H a.
  move=> e e0; have [|T h] := C (e / 2%:R); first by rewrite divr_gt0 ?ltr0n.
  exists T.+1 => t u t1 u1; apply: (le_lt_trans (h t u t1 u1)).
  by rewrite ltr_pdivr_mulr ?ltr0n // ltr_pmulr // ltr1n.
by exists l => e e0; have [T h] := L e e0; exists T => t tT; apply/ltW/h/ltnW.
Qed.
Lemma recurrent_3_proved : recurrent_3.
Proof.
move=> R n d G c alpha v C n1 net MD a0 fl Hv con.
have := @chazelle_agreement.recurrent_limit R n d (fun t => G t.+1) (fun t => c t.+1) (fun t => v t.+1) alpha
  (complete_proved C) (ltnW n1) (fun t => net t.+1 isT) (fun t => MD t.+1 isT) a0.
move=> /(_ (fun t i j h => fl t.+1 i j isT (nonneg_entries (proj1 (model_D_stochastic (net t.+1 isT) (MD t.+1 isT))) h))).
case=> [s||y Y].
- have [k h] := con s.+1 isT; exists k => i j; have := h i j.
  rewrite (eq_connect (e' := chazelle_agreement.union (fun t => G t.+1) s k)) //.
- by move=> t _; apply: Hv.
exists (fun q => y 0 q) => e e0; have [T h] := Y e e0; exists T.+2 => t i q tT.
have := h t.-2 _ i q; rewrite mxE; case: t tT => [//|[//|t]] /=; rewrite !ltnS => tT; exact.
Qed.
Lemma recurrent_4_proved : recurrent_4.
Proof.
move=> R n d P alpha B v C n1 SP dg a0 fl rt Hv.
have B0 : (0 < B)%N.
  case: B rt => // /(_ 1%N isT)[r h].
  have E i : connect (heard_in P 1 0) i r = (i == r).
    apply/idP/eqP => [/connectP[[|k p] /= ]|->]; last exact: connect0; first by move=> _ ->.
    by case/andP => /existsP[[]].
  have := h (Ordinal (ltnW n1)); have := h (Ordinal n1); rewrite !E => /eqP <- /eqP.
  by move/(congr1 val).
pose P' t := if t is 0%N then P B else P t.
have E t : exists2 u, (0 < u)%N & P' t = P u by case: t => [|t]; [exists B | exists t.+1].
have := @chazelle_agreement.velocities_repeatedly_limit R n d P' v alpha B (complete_proved C).
case=> [t|t i||t i j|s|t t0|y [_ Y]] //.
- by case: (E t) => u u0 ->; apply: SP.
- by case: (E t) => u u0 ->; apply: dg.
- by case: (E t) => u u0 -> h; apply: fl => //; apply: nonneg_entries h; apply: SP.
- case: s => [|s]; last first.
    have [r h] := rt s.+1 isT; exists r => i; have := h i.
    rewrite (eq_connect (e' := chazelle_recurrent.window P' s.+1 B)) // => p q.
  have [r h] := rt 1%N isT; exists r => i; have := h i.
  rewrite (eq_connect (e' := chazelle_recurrent.window P' 0 B)) // => p q.
  apply/existsP/existsP => -[[u uB] /= h'].
    move: h'; rewrite add1n; case: (ltngtP u.+1 B) uB => // uB _ h'.
      by exists (Ordinal uB).
    by exists (Ordinal B0) => /=; rewrite -uB.
  case: u uB h' => [|u] uB h'; last by exists (Ordinal (ltnW uB)).
  by exists (Ordinal (etrans (ltn_predL B) B0)) => /=; rewrite add1n prednK.
- by case: t t0 => // t _; apply: Hv.
by exists (fun q => y 0 q) => t i q; have := Y t t.+1 i q (ltnSn t); rewrite /chazelle_agreement.extent.
Qed.

(* weights at t = 0, where no velocity depends on them *)
Definition from_0 (R : rcfType) n (G : nat -> rel 'I_n) (w : nat -> 'I_n -> R) t := if t is 0%N then vicsek R (G 0%N) else w t.
Lemma flock_network (R : rcfType) n d a c (x v : nat -> 'M[R]_(n, d)) G w : flock_D a c x v G w -> forall t, network (G t).
Proof.
move=> [G0 Gn _ _]; have S (y z : 'rV[R]_d) : norm2 (y - z) = norm2 (z - y) by rewrite -norm2N opprB.
elim=> [|t [sy ir]]; split=> [i j|i]; rewrite ?G0 ?Gn ?eqxx //; first by rewrite eq_sym S.
by rewrite eq_sym sy !(S (row j _)).
Qed.
Lemma flock_is (R : rcfType) n d a c (x v : nat -> 'M[R]_(n, d)) G w : flock_D a c x v G w ->
  chazelle_switches.flock (n%:R ^- (n ^ 4)) x v G (from_0 G w).
Proof.
move=> F; have net := flock_network F; case: F => G0 Gn Hx W; split=> // [[|t]|[//|t] _]; first exact: vicsek_model_D.
  by case: (W t.+1 isT).
by case: (W t.+1 isT).
Qed.
Lemma flock_speed (R : rcfType) n d a c (x v : nat -> 'M[R]_(n, d)) G w : flock_D a c x v G w -> forall i, norm2 (row i (v 1%N)) <= n%:R ^+ c.
Proof. by move=> [_ _ _ W]; case: (W 1%N isT). Qed.
Lemma flock_floor (R : rcfType) n d a c (x v : nat -> 'M[R]_(n, d)) G w : (1 < n)%N -> (0 < a)%N -> flock_D a c x v G w ->
  forall t i j, transition (G t) (from_0 G w t) i j != 0 -> n%:R ^- a <= transition (G t) (from_0 G w t) i j.
Proof.
move=> n1 a0 F; have net := flock_network F; have [_ _ MD _ _] := flock_is F; case: F => _ _ _ W t i j h.
have P0 := nonneg_entries (proj1 (model_D_stochastic (net t) (MD t))) h; case: t h P0 => [|t] h P0; last first.
  by case: (W t.+1 isT) => _ _ fl _; apply: fl.
have N1 : 1 <= (n%:R : R) by rewrite ler1n ltnW.
have L : n%:R ^- a <= ((degree (G 0%N) i).+1%:R^-1 : R).
  rewrite lef_pinv ?posrE ?exprn_gt0 ?ltr0n ?(ltnW n1) //.
  apply: (@le_trans _ _ n%:R); last by rewrite -{1}[n%:R]expr1; apply: ler_weexpn2l.
  rewrite ler_nat -[X in (_ <= X)%N](prednK (ltnW n1)) ltnS -[X in (_ <= X.-1)%N](card_ord n) -(cardC1 i).
  by apply: subset_leq_card; apply/subsetP => k; rewrite !inE; apply: contraTneq => ->; rewrite (proj2 (net 0%N)).
move: h; rewrite /from_0 (transitionE _ _ _ (proj2 (net 0%N))) /vicsek; case: (i == j).
  move=> _; apply: le_trans L _; have d0 : ((degree (G 0%N) i).+1%:R : R) != 0 by rewrite pnatr_eq0.
  have -> : (degree (G 0%N) i)%:R = (degree (G 0%N) i).+1%:R - 1 :> R by rewrite [X in _ = X - 1]mulrSr addrK.
  by rewrite mulrBr mulVf // mulr1 opprB addrCA subrr addr0.
by case: (G 0%N i j) => [_|]; [apply: L | rewrite eqxx].
Qed.
(* with a = 0 no network has an edge *)
Lemma flock_empty (R : rcfType) n d c (x v : nat -> 'M[R]_(n, d)) G w : flock_D 0 c x v G w -> forall t i j, (0 < t)%N -> G t i j = false.
Proof.
move=> F t i j t0; have net := flock_network F; case: F => _ _ _ /(_ t t0)[MD _ fl _]; apply/negP => Gij.
have [[P0 P1] dg] := model_D_stochastic (net t) MD; have ij : i != j by apply: contraTneq Gij => ->; rewrite (proj2 (net t)).
have Pij : 0 < transition (G t) (w t) i j.
  by rewrite (transitionE _ _ _ (proj2 (net t))) (negPf ij) Gij; apply: weight_gt0 MD Gij.
have Pi := P1 i; rewrite (bigD1 i) //= (bigD1 j) 1?eq_sym //= in Pi.
have A := fl i i (dg i); have B := fl i j Pij; rewrite expr0 invr1 in A B.
have C : 0 <= \sum_(k | (k != i) && (k != j)) transition (G t) (w t) i k by apply: sumr_ge0 => k _.
have : (1 : R) + (1 + 0) <= 1 by rewrite -{3}Pi; apply: ler_add => //; apply: ler_add.
by rewrite addr0 ger_addl ler10.
Qed.
Lemma count_is n (G : nat -> rel 'I_n) T : switches_up_to G T = chazelle_stabilisers.N (chazelle_count.changes G) T 1.
Proof. by rewrite /switches_up_to /chazelle_stabilisers.N subn1. Qed.
Lemma no_switches (R : rcfType) n d c (x v : nat -> 'M[R]_(n, d)) G w T : flock_D 0 c x v G w -> switches_up_to G T = 0%N.
Proof.
move=> F; have e := flock_empty F; rewrite /switches_up_to; apply/eqP; rewrite -leqn0 leqNgt -has_count -all_predC.
apply/allP => u; rewrite mem_iota => /andP[u2 _] /=; apply/existsP => -[i /existsP[j]].
by rewrite !e ?eqxx //; [case: u u2 => [|[]]|apply: leq_trans u2].
Qed.
Lemma switches_1_proved : switches_1.
Proof.
move=> R n d a c x v G w n1 F T; case: (posnP a) F => [->|a0] F; first by rewrite (no_switches T F).
rewrite count_is -!subn1; exact: (chazelle_switches.switches n1 (flock_is F) (flock_floor n1 a0 F) (flock_speed F)).
Qed.
Lemma lem3_1_proved : lem3_1.
Proof.
move=> a c; exists (a + c + 9)%N => R n d x v G w n1 F T; case: (posnP a) F => [->|a0] F; first by rewrite (no_switches T F).
rewrite count_is; exact: (chazelle_switches.lemma_3_1 n1 (flock_is F) (flock_floor n1 a0 F) (flock_speed F)).
Qed.
Lemma lem2_1_proved : lem2_1.
Proof.
move=> R n d x v Hx t i j t0; apply: lemma_2_1 => // u u0; by rewrite -{1}(prednK u0) Hx prednK.
Qed.
Lemma modelD_12_proved : modelD_12.
Proof. by move=> R n G c; apply: model_D_stochastic. Qed.
Lemma lem2_2_entries_proved : lem2_2_entries.
Proof.
move=> R n a G c net MD fl s t i j st h.
have F u p q : transition (G u) (c u) p q != 0 -> n%:R ^- a <= transition (G u) (c u) p q.
  by move=> e; apply: fl; apply: nonneg_entries e; case: (model_D_stochastic (net u) (MD u)).
exact: (proj2 (lemma_2_2_entries net MD F st h)).
Qed.
Lemma lem2_4_proved : lem2_4.
Proof. by move=> R l m p A B SA SB; apply: lemma_2_4. Qed.
Lemma tau2_sqrt2_proved : tau2_sqrt2.
Proof. by move=> R m p A SA; apply: tau2_le_tau1. Qed.
Lemma lem2_2_bits_proved : lem2_2_bits.
Proof.
move=> a; exists a => R n G c n1 net MD sw s t /andP[_ st].
have [E [E0 EL H]] := lemma_2_2_bits net MD sw st; rewrite addn1 in EL.
have L : (E <= n ^ (a * (t - s).+1 * n))%N by rewrite mulnAC.
exists E; rewrite E0 L; split=> // i j; have [k [kE ->]] := H i j.
by exists k%:Z; split=> //=; apply: leq_trans L.
Qed.
Lemma fiedler_3_proved : fiedler_3.
Proof.
move=> R n G n1 net con lam u [i [j ne]] E.
have N0 : 0 < (n%:R * n.-1%:R : R) by rewrite mulr_gt0 ?ltr0n ?(ltnW n1) //; case: n n1 {G net con u i j ne E} => [|[]].
have F k : \sum_l laplacian R G k l * u l 0 = lam * u k 0 by have := congr1 (fun A : 'cV_n => A k 0) E; rewrite !mxE.
rewrite ler_pdivr_mulr // -natrM.
apply: (@chazelle_sharp.fiedler_sharp R n G lam (fun k => u k 0)) => //.
- case: (eqVneq (u i 0) 0) => [z|]; last by exists i.
  by exists j; apply/eqP => z'; move: ne; rewrite z z' eqxx.
apply/eqP => l0; case/eqP: ne.
pose c := vicsek R G; have MD := @vicsek_model_D R n G.
have c0 k : 0 < c k by rewrite invr_gt0 ltr0n.
have [_ _ [K _] _ _] := chazelle_network.stationary net MD con c0 i.
apply: (K (fun k => u k 0)) => k; rewrite /step.
have := congr1 (fun A : 'cV_n => A k 0) (erefl (transition G c *m u)); rewrite {1}mxE => ->.
by rewrite mulmxBl mul1mx -mulmxA E l0 scale0r mulmx0 subr0.
Qed.
Lemma fiedler_5_proved : fiedler_5.
Proof.
move=> R n d G v n1 net con Hv t.
have H (c0 : 'I_n -> R) : ((forall i, c0 i = 2%:R / (3 * degree G i)%:R) \/ (forall i, c0 i = (degree G i).+1%:R^-1)) ->
  (forall t0, (0 < t0)%N -> v t0.+1 = transition G c0 *m v t0) ->
  2%:R ^+ t * diameter (@norm2 R d) (v t.+1) ^+ (n ^ 3) <= (n%:R * diameter (@norm2 R d) (v 1%N)) ^+ (n ^ 3).
  move=> C V; pose K := diameter (@norm2 R d) (v t.+1).
  have [p|] := boolP (0 < K); last first.
    rewrite -leNgt => K0; have -> : diameter (@norm2 R d) (v t.+1) = 0 by apply/eqP; rewrite eq_le K0 /= max_ge0.
    by rewrite expr0n expn_eq0 (negPf (lt0n_neq0 (ltnW n1))) mulr0 exprn_ge0 // mulr_ge0 ?ler0n ?max_ge0.
  have [ij e] : exists ij : 'I_n * 'I_n, K = norm2 (row ij.1 (v t.+1) - row ij.2 (v t.+1)).
    case: (pickP (fun ij : 'I_n * 'I_n => K == norm2 (row ij.1 (v t.+1) - row ij.2 (v t.+1)))) => [ij /eqP|no]; first by exists ij.
    have : K < K; last by rewrite ltxx.
    rewrite {1}/K /diameter; elim/big_rec: _ => // ij y _ yK.
    rewrite maxElt; case: ifP => // _; by rewrite lt_neqAle diameter_ub andbT eq_sym; apply/negP; rewrite no.
  rewrite -/K e [2%:R ^+ t * _]mulrC.
  exact: (@chazelle_sharp.lazy_vicsek_rate R n d G c0 v t ij.1 ij.2 net con n1 C V).
case: Hv => V; [apply: (H (lazy R G)) V|apply: (H (vicsek R G)) V]; [left|right] => i //.
by rewrite /lazy natrM.
Qed.
Lemma one_pi_is (R : realFieldType) m (c : 'I_m.+1 -> R) : one_pi c = rank1 c.
Proof. by apply/matrixP => i j; rewrite rank1E !mxE. Qed.
Lemma Gamma_is (R : realFieldType) m G (c : 'I_m.+1 -> R) : Gamma_of G c = Gamma G c.
Proof.
rewrite /Gamma_of /Gamma one_pi_is (_ : const_mx 1 = ones R m) //; apply/matrixP => i j; by rewrite !mxE.
Qed.
Lemma converges_tends (R : realFieldType) m p (A : nat -> 'M[R]_(m, p)) B : converges A B -> tends_to A B.
Proof. by move=> H e e0; have [T h] := H e e0; exists T => t i j tT; apply: h. Qed.
Lemma lem3_3_proved : lem3_3.
Proof.
move=> R m G c [net MD con c0]; split.
  have := bordered_unit net MD con c0; rewrite (_ : const_mx 1 = ones R m) //; apply/matrixP => i j; by rewrite !mxE.
apply: converges_tends => e e0; have [T h] := lemma_3_3 net MD con c0 e0; exists T => t tT i j.
by rewrite Gamma_is one_pi_is scaler_nat; apply: h.
Qed.
Lemma eq3_12_13_proved : eq3_12_13.
Proof.
move=> R m d G c x v _ Hx Hv t; have [A B] := eq_3_12_13 t Hx Hv; split=> //.
by rewrite {1}B one_pi_is !scaler_nat.
Qed.
Lemma lem3_4_proved : lem3_4.
Proof.
move=> R m d G c x v [net MD con c0] Hx Hv; have [A B] := lemma_3_4 net MD con c0 Hx Hv; split.
  apply: converges_tends => e e0; have [T h] := A e e0; exists T => t tT i j.
  by rewrite one_pi_is Gamma_is; have := h t tT i j; rewrite /relative /rank1 mulmxA.
exists (v 1%N); elim=> [|t IH]; first by rewrite scale0r addr0.
rewrite one_pi_is in IH *; have := congr1 (fun z => ones R m *m z) (B t); rewrite mulmxBr !mulmxA -/(rank1 c).
move/eqP; rewrite subr_eq => /eqP ->; rewrite IH addrCA; congr (_ + _); by rewrite -[t.+1]add1n natrD scalerDl scale1r.
Qed.
Lemma foot_1_proved : foot_1.
Proof.
move=> R n G c net MD s t t' i j st tt; rewrite /pprod; rewrite -(subnK tt) => h.
elim: (t' - t)%N => [//|k IH]; rewrite addSn subSn ?(leq_trans st) ?leq_addl //.
exact: (proj1 (footprint_monotone s _ net MD) i j IH).
Qed.
Lemma least_attained (R : realFieldType) (I : finType) (F : I -> R) :
  \big[Num.min/1]_i F i = 1 \/ exists i, \big[Num.min/1]_i F i = F i.
Proof.
elim/big_rec: _ => [|i y _ IH]; first by left.
by rewrite minElt; case: ifP => _ //; right; exists i.
Qed.
Lemma tau1_1_proved : tau1_1.
Proof.
move=> R m p A SA; have [T0 [T T1]] := tau1_overlap SA; split; first by rewrite T0.
have E : 1 - tau1 A = \big[Num.min/1]_(ij : 'I_m.+1 * 'I_m.+1) \sum_k Num.min (A ij.1 k) (A ij.2 k) by rewrite T opprB addrCA subrr addr0.
rewrite E; split=> [i j|]; first exact: (min_lb (fun ij : 'I_m.+1 * 'I_m.+1 => \sum_k Num.min (A ij.1 k) (A ij.2 k)) (i, j)).
have [->|[[i j] ->]] := least_attained (fun ij : 'I_m.+1 * 'I_m.+1 => \sum_k Num.min (A ij.1 k) (A ij.2 k)); last by exists i, j.
exists ord0, ord0; case: SA => _ sA; rewrite -(sA ord0); apply: eq_bigr => k _; by rewrite minxx.
Qed.
(* a number of coordinates is at most a power of the number of birds *)
Lemma small_power n d : (1 < n)%N -> (d <= n ^ d)%N.
Proof. by move=> n1; apply/ltnW/(ltn_expl d n1). Qed.
Lemma eq2_3_proved : eq2_3.
Proof.
move=> b d; exists (1 + d + b)%N => R n G c v n1 net MD Hv v1 t t0.
pose P t := if t is 0%N then 1%:M else transition (G t) (c t).
have SP u : stochastic (P u).
  case: u => [|u]; first exact: stochastic1.
  by case: (model_D_stochastic (net u.+1 isT) (MD u.+1 isT)).
have H : forall u, (0 < u)%N -> v u.+1 = P u *m v u by case=> // u _; apply: Hv.
apply: le_trans (velocity_polynomial SP H t0 v1) _; rewrite exprD; apply: ler_wpmul2r; first by rewrite exprn_ge0 ?ler0n.
have N : (n%:R : R) * d%:R <= (n%:R ^+ (1 + d)) ^+ 2.
  rewrite -natrM -!natrX ler_nat -expnM mulnDl mul1n expnD muln2 -addnn.
  apply: leq_mul; first by rewrite expnS expn1 leq_pmulr // (ltnW n1).
  by apply: (leq_trans (small_power d n1)); rewrite leq_pexp2l ?(ltnW n1) // leq_addr.
apply: (le_trans (ler_wsqrtr N)); by rewrite sqrtr_sqr ger0_norm ?exprn_ge0 ?ler0n.
Qed.
Lemma over_le (R : realFieldType) m p (A : 'M[R]_(m, p)) E B size : (0 < E)%N -> (E * B <= size)%N -> (0 < B)%N ->
  (forall i j, exists z : int, A i j = z%:~R / E%:R /\ (`|z| <= E * B)%N) -> over A size.
Proof.
move=> E0 L B0 H; exists E; split; first by rewrite E0; apply: leq_trans L; rewrite leq_pmulr.
by move=> i j; have [z [Az zL]] := H i j; exists z; split=> //; apply: leq_trans L.
Qed.
Lemma lem2_3_proved : lem2_3.
Proof.
move=> a b d; exists (2 * b * d + a + b + 1)%N => R n G c x v n1 net MD sw Hx Hv Hx0 Hv1 t t0.
have [E [E0 EL H]] := lemma_2_3 net MD sw Hv Hx Hx0 Hv1 t0 n1.
have n0 : (0 < n)%N by apply: ltnW.
have L : (E * (n ^ b * t.+1) <= n ^ ((2 * b * d + a + b + 1) * t * n))%N.
  have -> : ((2 * b * d + a + b + 1) * t * n = (2 * b * d + a) * (t * n) + (b * (t * n) + t * n))%N by lia.
  rewrite !expnD; apply: leq_mul => //; apply: leq_mul.
    by rewrite leq_pexp2l // leq_pmulr // muln_gt0 t0.
  apply: leq_trans (ltn_expl t n1) _; by rewrite leq_pexp2l // leq_pmulr.
split.
- apply: (over_le (B := n ^ b) E0); rewrite ?expn_gt0 ?n0 //.
    by apply: leq_trans L; rewrite mulnA leq_pmulr.
  by move=> i j; have [z [w [A _ B _]]] := H i j; exists z.
- apply: (over_le (B := n ^ b * t.+1) E0) => //; first by rewrite muln_gt0 expn_gt0 n0.
  by move=> i j; have [z [w [_ A _ B]]] := H i j; exists w.
Qed.
Lemma lem3_5_proved : lem3_5.
Proof.
move=> a d; exists (5 * a + 2 * a * d + 7)%N => R m G c x0 v1 m0 [net MD con c0] sw Hx Hv.
have [[E [E0 EL H]] /(_ Hx Hv)[F [F0 FL K]]] := chazelle_bits.lemma_3_5 a x0 v1 net MD con c0 sw.
rewrite one_pi_is Gamma_is; have n0 : (0 < m.+1)%N by [].
split.
- apply: (over_le (B := m.+1 ^ (a.+1 * m.+1 + a + a + 3)) F0) => //; last by rewrite expn_gt0.
  apply: leq_trans (leq_mul FL (leqnn _)) _; rewrite -expnD leq_pexp2l //; nia.
- apply: (over_le (B := m.+1 ^ (a.+1 * m.+1 + a + 1)) E0) => //; last by rewrite expn_gt0.
  apply: leq_trans (leq_mul EL (leqnn _)) _; rewrite -expnD leq_pexp2l //; nia.
Qed.
(* entries of a column *)
Lemma column_step (R : realFieldType) n (G : rel 'I_n) (c : 'I_n -> R) (u : 'cV[R]_n) i :
  (transition G c *m u) i 0 = step G c (fun i => u i 0) i.
Proof. by rewrite mxE. Qed.
Lemma column_nonzero (R : realFieldType) n (u : 'cV[R]_n) : u != 0 -> exists i, u i 0 != 0.
Proof.
move=> u0; case: (pickP (fun i => u i 0 != 0)) => [i h|no]; first by exists i.
case/eqP: u0; apply/matrixP => i j; rewrite ord1 mxE; by have /negbT := no i; rewrite negbK => /eqP.
Qed.
Lemma pi_123_proved : pi_123.
Proof.
move=> R n G c n0 [net MD con c0] P pi.
have [[A1 A2] _ [K _] Kg [Eg _]] := chazelle_network.stationary net MD con c0 (Ordinal n0).
split.
- apply/matrixP => i j; rewrite !mxE -[RHS](A1 i); apply: eq_bigr => k _; by rewrite !mxE mulr1.
- apply/matrixP => i j; rewrite !mxE -[RHS](A2 j); apply: eq_bigr => k _; by rewrite !mxE.
- move=> u Pu; exists (u (Ordinal n0) 0); apply/matrixP => i j; rewrite ord1 !mxE mulr1.
  apply: (K (fun i => u i 0)) => k; by rewrite -column_step Pu.
- move=> u Pu; pose f i := u i 0.
  have D (w : 'cV[R]_n) i : ((P - 1%:M) *m w) i 0 = step G c (fun i => w i 0) i - w i 0.
    by rewrite mulmxBl mul1mx mxE column_step [in LHS]mxE.
  have C : forall i j, f i = f j.
    apply: Kg => i; have := congr1 (fun w : 'cV_n => w i 0) Pu; rewrite D [RHS]mxE => E.
    have N k : ((P - 1%:M) *m u) k 0 = - (f k - step G c f k) by rewrite D opprB.
    move: E; rewrite N opprK /step (eq_bigr (fun j => - (transition G c i j * (f j - step G c f j)))) => [|j _]; last by rewrite N mulrN.
    by rewrite sumrN => /eqP; rewrite addrC subr_eq0 => /eqP ->; rewrite subrr.
  apply/matrixP => i j; rewrite ord1 D mxE /step (eq_bigr (fun k => transition G c i k * f i)) => [|k _]; last by rewrite -/(f k) (C k i).
  by rewrite -mulr_suml A1 mul1r subrr.
- move=> lam u /column_nonzero[i ui] Pu l1.
  case: (Eg lam (fun i => u i 0)) => // [k||e]; last by rewrite e eqxx in l1.
    by rewrite -column_step Pu mxE.
  by exists i.
Qed.
(* bounds below from short weights *)
Lemma short_bounds (R : realFieldType) a n (G : rel 'I_n) (c : 'I_n -> R) : (1 < n)%N -> fixed G c -> short_weights a c ->
  (forall i, (n%:R ^+ a)^-1 <= c i) /\ forall i, (n%:R ^+ a)^-1 <= transition G c i i.
Proof.
move=> n1 [net MD con c0] [p [q pq]].
have [_ irr] := net.
have step1 i (k : int) : 0 < (k%:~R / (q i)%:R : R) -> (n%:R ^+ a)^-1 <= (k%:~R / (q i)%:R : R).
  have [_ q0 qL] := pq i; have qR : 0 < (q i)%:R :> R by rewrite ltr0n.
  rewrite pmulr_lgt0 ?invr_gt0 // ltr0z => k0.
  rewrite ler_pdivl_mulr // mulrC ler_pdivr_mulr ?exprn_gt0 ?ltr0n ?(ltnW n1) //.
  apply: (@le_trans _ _ ((n ^ a)%:R)); first by rewrite ler_nat.
  rewrite natrX ler_pmull ?exprn_gt0 ?ltr0n ?(ltnW n1) //; by rewrite (ler_int R 1).
split=> i; have [ci q0 qL] := pq i.
  have E : c i = (p i)%:Z%:~R / (q i)%:R by rewrite ci.
  by rewrite E; apply: step1; rewrite -E.
have [_ dg] := model_D_stochastic net MD.
have qn : (q i)%:R != 0 :> R by rewrite pnatr_eq0 -lt0n.
have E : transition G c i i = ((q i)%:Z - (p i * degree G i)%:Z)%:~R / (q i)%:R.
  by rewrite transitionE // eqxx ci rmorphB /= mulrBl -!pmulrn mulfV // natrM mulrAC.
by rewrite E; apply: step1; rewrite -E.
Qed.
Lemma lem3_2_proved : lem3_2.
Proof.
move=> a; exists (2 * a + 4)%N => R n G c n1 F sw lam u /column_nonzero[i ui] Pu l1.
have [B1 B2] := short_bounds n1 F sw; case: F => net MD con c0.
have E k : step G c (fun i => u i 0) k = lam * u k 0 by rewrite -column_step Pu mxE.
exact: (chazelle_network.lemma_3_2 net MD con c0 n1 B1 B2 E (ex_intro _ i ui) l1).
Qed.
Lemma eq3_9_proved : eq3_9.
Proof.
move=> a; exists (2 * a + 4)%N => R n G c n1 F sw s i j.
have [B1 B2] := short_bounds n1 F sw; case: F => net MD con c0.
have N1 : 1 <= (n%:R : R) by rewrite ler1n ltnW.
rewrite [one_pi c i j]mxE; apply: (le_trans (chazelle_network.eq_3_9 net MD con c0 n1 B1 B2 s i j)).
apply: ler_wpmul2r; last by rewrite ler_weexpn2l //; lia.
by rewrite exprn_ge0 // subr_ge0 invf_le1 ?exprn_ege1 // exprn_gt0 // (lt_le_trans ltr01 N1).
Qed.
