(* Clauses of the claims about Chazelle's paper, formalised from their words before the theorems were looked at; the theorems
   prove them. *)
Set Warnings "-notation-overridden,-ambiguous-paths".
From mathcomp Require Import all_ssreflect all_algebra zify ring.
From Flockproof Require Import chazelle_model chazelle_ergodicity chazelle_fixed chazelle_limits chazelle_products chazelle_entries.
From Flockproof Require chazelle_recurrent chazelle_agreement chazelle_switches chazelle_count chazelle_losses
  chazelle_stabilisers chazelle_sharp chazelle_network chazelle_bits chazelle_spectral chazelle_contraction symmetric_spectra.
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
  (forall t, (0 < t)%N -> (forall i j, G t.+1 i j = G t i j) -> forall i, c t.+1 i = c t i) ->
  (forall t, x t.+1 = x t + v t.+1) -> (forall t, (0 < t)%N -> v t.+1 = transition (G t) (c t) *m v t) ->
  (forall i q, `|x 0%N i q| <= X) ->
  forall t i q, (0 < t)%N -> (forall u i j, (0 < u < t)%N -> G u i j -> norm2 (row i (x u) - row j (x u)) <= 2%:R) ->
  `|x t i q - t%:R * v t i q| <= X + 4%:R * (switches_up_to G t.-1).+1%:R * n%:R ^+ (2 * a + 3).

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
Definition is_norm (R : realFieldType) d (N : 'rV[R]_d -> R) :=
  (forall y, N y = 0 -> y = 0) /\ [/\ N 0 = 0, forall b y, N (b *: y) = `|b| * N y & forall y z, N (y + z) <= N y + N z].
Definition fiedler_5 : Prop := forall (R : rcfType) n d (G : rel 'I_n) (v : nat -> 'M[R]_(n, d)) (N : 'rV[R]_d -> R), (1 < n)%N -> is_norm N -> network G ->
  (forall i j, connect G i j) ->
  (forall t, (0 < t)%N -> v t.+1 = transition G (lazy R G) *m v t) \/
  (forall t, (0 < t)%N -> v t.+1 = transition G (vicsek R G) *m v t) ->
  forall t, 2%:R ^+ t * diameter N (v t.+1) ^+ (n ^ 3) <= (n%:R * diameter N (v 1%N)) ^+ (n ^ 3).

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
move=> R n d a G c x v X a0 net MD fl same Hx Hv X0 t i q t0 sh.
apply: (le_trans (@chazelle_losses.origins_stay R n d a G c x v net MD a0 fl same Hx Hv t sh q t i X _ (fun j => X0 j q))); first by rewrite t0 leqnn.
by rewrite /switches_up_to /chazelle_stabilisers.N subn1.
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
by apply: (proj2 (@chazelle_sharp.fiedler_sharp R n G net con) lam (fun k => u k 0) F); exists i, j.
Qed.
Lemma fiedler_5_proved : fiedler_5.
Proof.
move=> R n d G v N n1 [_ [N0 NZ ND]] net con Hv t.
have H (c0 : 'I_n -> R) : ((forall i, c0 i = 2%:R / (3 * degree G i)%:R) \/ (forall i, c0 i = (degree G i).+1%:R^-1)) ->
  (forall t0, (0 < t0)%N -> v t0.+1 = transition G c0 *m v t0) ->
  2%:R ^+ t * diameter N (v t.+1) ^+ (n ^ 3) <= (n%:R * diameter N (v 1%N)) ^+ (n ^ 3).
  move=> C V; pose K := diameter N (v t.+1).
  have [p|] := boolP (0 < K); last first.
    rewrite -leNgt => K0; have -> : diameter N (v t.+1) = 0 by apply/eqP; rewrite eq_le K0 /= max_ge0.
    by rewrite expr0n expn_eq0 (negPf (lt0n_neq0 (ltnW n1))) mulr0 exprn_ge0 // mulr_ge0 ?ler0n ?max_ge0.
  have [ij e] : exists ij : 'I_n * 'I_n, K = N (row ij.1 (v t.+1) - row ij.2 (v t.+1)).
    case: (pickP (fun ij : 'I_n * 'I_n => K == N (row ij.1 (v t.+1) - row ij.2 (v t.+1)))) => [ij /eqP|no]; first by exists ij.
    have : K < K; last by rewrite ltxx.
    rewrite {1}/K /diameter; elim/big_rec: _ => // ij y _ yK.
    rewrite maxElt; case: ifP => // _; by rewrite lt_neqAle diameter_ub andbT eq_sym; apply/negP; rewrite no.
  rewrite -/K e [2%:R ^+ t * _]mulrC.
  exact: (@chazelle_sharp.lazy_vicsek_rate R n d G c0 v N t ij.1 ij.2 N0 NZ ND net con n1 C V).
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

(* ==== the second part: formalised from the words alike, before the theorems were looked at ==== *)

(* a flock whose inputs and weights are rationals with numerators and denominators at most n^b, n^a; weights change only when the network does *)
Definition rational_flock (R : rcfType) n d a b c (x v : nat -> 'M[R]_(n, d)) (G : nat -> rel 'I_n) (w : nat -> 'I_n -> R) :=
  [/\ flock_D a c x v G w, short_input b (x 0%N), short_input b (v 1%N),
      forall t, (0 < t)%N -> short_weights a (w t) &
      forall s t, (0 < s)%N -> (0 < t)%N -> (forall i j, G s i j = G t i j) -> forall i, w s i = w t i].
(* the transition matrix of each time *)
Definition P_of (R : realFieldType) n (G : nat -> rel 'I_n) (w : nat -> 'I_n -> R) u := transition (G u) (w u).
(* N(t,s) as printed: the u with s < u < t; the weight of the first column of P(t,s); the times t_1 < ... < t_l after s at which it grows *)
Definition N_open (R : realFieldType) n (P : nat -> 'M[R]_n) t s :=
  count (fun u => [exists i, exists j, (P u i j != 0) != (P u.-1 i j != 0)]) (iota s.+1 (t - s).-1).
Definition column_weight (R : realFieldType) m (P : nat -> 'M[R]_m.+1) s t := #|[set i | pprod P t s i ord0 != 0]|.
Definition growth_times (R : realFieldType) m (P : nat -> 'M[R]_m.+1) s (ts : seq nat) := sorted ltn ts /\
  forall t, (t \in ts) = (s < t)%N && (column_weight P s t.-1 < column_weight P s t)%N.
(* chazelle.Nts clause 1, refuted: N(t + 1, t) = 0 always, and in some flock the column does grow at two times running *)
Definition Nts_1 : Prop :=
  (forall (R : realFieldType) n (P : nat -> 'M[R]_n) t, N_open P t.+1 t = 0%N) /\
  forall R : rcfType, exists m d a b c (x v : nat -> 'M[R]_(m.+1, d)) G w s ts k,
    [/\ rational_flock a b c x v G w, (0 < s)%N, growth_times (P_of G w) s ts, (k.+1 < size ts)%N &
        nth 0%N ts k.+1 = (nth 0%N ts k).+1].
(* chazelle.Nts clause 2, refuted: in some flock N(t_l, s) is not the sum, with t_0 = s *)
Definition Nts_2 : Prop := forall R : rcfType, exists m d a b c (x v : nat -> 'M[R]_(m.+1, d)) G w s ts,
  [/\ rational_flock a b c x v G w, (0 < s)%N, growth_times (P_of G w) s ts &
      N_open (P_of G w) (last s ts) s <> (\sum_(k < size ts) N_open (P_of G w) (nth 0 (s :: ts) k.+1) (nth 0 (s :: ts) k))%N].
(* chazelle.chi clause 1, refuted: no vector is so, and neither of the two that obey one of the two equations fits the formula in all flocks *)
Definition chi_1 : Prop :=
  (forall (R : realFieldType) n (i : 'I_n) (chi : 'rV[R]_n), ~ (chi 0 i = 1 /\ chi 0 i = -1)) /\
  forall (R : rcfType) (e : R), e = 1 \/ e = -1 -> exists n d a b c (x v : nat -> 'M[R]_(n, d)) G w (i j : 'I_n) t,
    [/\ rational_flock a b c x v G w, i != j, (1 < t)%N &
        row i (v t) - row j (v t) <> (e *: delta_mx 0 i : 'rV_n) *m pprod (P_of G w) t.-1 1 *m v 1%N].

(* stabilisers: T_0 = s - 1, V_0 = all birds; T_(k+1) is least so that the footprint of P(t, T_k + 1) on V_k x V_k is that of P(T_(k+1), T_k + 1)
   for all t after it, V_(k+1) are the ones of its column of bird r *)
Definition stable_from (R : realFieldType) n (P : nat -> 'M[R]_n) (V : {set 'I_n}) s T := (s <= T)%N /\
  forall t i j, (T < t)%N -> i \in V -> j \in V -> (pprod P t s i j != 0) = (pprod P T s i j != 0).
Definition stabilisers (R : realFieldType) n (P : nat -> 'M[R]_n) s r (T : nat -> nat) (V : nat -> {set 'I_n}) :=
  [/\ (T 0%N).+1 = s, V 0%N = setT &
    forall k, [/\ stable_from P (V k) (T k).+1 (T k.+1), forall T', stable_from P (V k) (T k).+1 T' -> (T k.+1 <= T')%N &
      V k.+1 = [set i in V k | pprod P (T k.+1) (T k).+1 i r != 0]]].
(* networks and weights of model D at the times 1, 2, ... *)
Definition in_model_D (R : realFieldType) n (G : nat -> rel 'I_n) (w : nat -> 'I_n -> R) :=
  forall t, (0 < t)%N -> network (G t) /\ model_D (G t) (w t).
(* chazelle.stab clauses 1, 2, 3 *)
Definition stab_123 : Prop := forall (R : realFieldType) n (G : nat -> rel 'I_n) (w : nat -> 'I_n -> R) s r T V,
  (0 < s)%N -> in_model_D G w -> stabilisers (P_of G w) s r T V ->
  [/\ forall k, V k.+1 \subset V k,
      forall t i j, (T 1%N < t)%N -> i \in V 1%N -> j \notin V 1%N ->
        [/\ ~~ G t i j, ~~ G t j i, P_of G w t i j = 0 & P_of G w t j i = 0] &
      forall k i, i \in V k.+1 -> r \in V k /\ 0 < pprod (P_of G w) (T k.+1) (T k).+1 i r].
(* chazelle.eq3.5 clause 1, refuted; the submatrix A_{|V x W} with zeros around it, so that products of submatrices are products of these.
   The factors P_{|V_i x V_(i-1)}(T_i, T_(i-1) + 1) for i = k, ..., 3, k = j + 2, and the printed product *)
Definition block (R : realFieldType) n (V W : {set 'I_n}) (A : 'M[R]_n) : 'M[R]_n :=
  \matrix_(i, j) if (i \in V) && (j \in W) then A i j else 0.
Fixpoint middle_factors (R : realFieldType) n (P : nat -> 'M[R]_n) (T : nat -> nat) (V : nat -> {set 'I_n}) j : 'M[R]_n :=
  if j is j'.+1 then block (V j'.+3) (V j'.+2) (pprod P (T j'.+3) (T j'.+2).+1) *m middle_factors P T V j' else 1%:M.
Definition printed_product (R : realFieldType) n (P : nat -> 'M[R]_n) T V j t := let k := j.+2 in
  block (V k) (V k) (pprod P t (T k).+1) *m middle_factors P T V j *m block (V 2%N) (V k) (pprod P (T 2%N) (T 1%N).+1)
    *m block (V k) (V 0%N) (pprod P (T 1%N) (T 0%N).+1).
Definition eq3_5 : Prop := forall R : rcfType, exists n d a b c (x v : nat -> 'M[R]_(n, d)) G w s r T V j t,
  [/\ rational_flock a b c x v G w, (0 < s)%N, stabilisers (P_of G w) s r T V, (T j.+2 < t)%N &
      block (V j.+2) (V 0%N) (pprod (P_of G w) t s) <> printed_product (P_of G w) T V j t].
(* chazelle.eq3.6 clauses 1, 2; the ergodicity coefficients of the submatrix A_{|V x W}; the one function with these two properties is e^x *)
Definition tau1_on (R : rcfType) n (V W : {set 'I_n}) (A : 'M[R]_n) : R :=
  \big[Num.max/0]_(ij : 'I_n * 'I_n | (ij.1 \in V) && (ij.2 \in V)) (2%:R^-1 * \sum_(k in W) `|A ij.1 k - A ij.2 k|).
Definition tau2_on (R : rcfType) n (V W : {set 'I_n}) (A : 'M[R]_n) : R :=
  \big[Num.max/0]_(ij : 'I_n * 'I_n | (ij.1 \in V) && (ij.2 \in V)) Num.sqrt (\sum_(k in W) (A ij.1 k - A ij.2 k) ^+ 2).
Definition exponential (R : realFieldType) (E : R -> R) := (forall x y, E (x + y) = E x * E y) /\ forall x, 1 + x <= E x.
Definition right_side (R : rcfType) n (P : nat -> 'M[R]_n) T V k t : R :=
  Num.sqrt 2%:R * tau1_on (V k) (V k) (pprod P t (T k).+1) * \prod_(i < k) tau1_on (V i.+1) (V i) (pprod P (T i.+1) (T i).+1).
Definition eq3_6_1 : Prop := forall (R : rcfType) n (G : nat -> rel 'I_n) (w : nat -> 'I_n -> R) s r T V k t,
  (0 < s)%N -> in_model_D G w -> stabilisers (P_of G w) s r T V -> (T k < t)%N ->
  tau2_on (V k) (V 0%N) (pprod (P_of G w) t s) <= right_side (P_of G w) T V k t.
Definition eq3_6_2 : Prop := forall a, exists K, forall (R : rcfType) (E : R -> R) n nu (G : nat -> rel 'I_n) (w : nat -> 'I_n -> R) s r T V k t,
  exponential E -> (1 < n)%N -> (n <= nu)%N -> (0 < s)%N -> in_model_D G w ->
  (forall t i j, (0 < t)%N -> 0 < P_of G w t i j -> (nu%:R ^+ a)^-1 <= P_of G w t i j) ->
  stabilisers (P_of G w) s r T V -> (T k < t)%N ->
  right_side (P_of G w) T V k t <= Num.sqrt 2%:R * E (- (k%:R * (nu%:R ^+ (K * nu ^ 2))^-1)).
(* chazelle.lem3.1.count clause 1, refuted: birds of V_k that are joined later than T_k always remain so, yet more network changes follow *)
Definition count_1 : Prop := forall R : rcfType, exists n d a b c (x v : nat -> 'M[R]_(n, d)) G w s r T V k U,
  [/\ rational_flock a b c x v G w, (0 < k)%N, s = 1%N /\ stabilisers (P_of G w) s r T V,
      forall i j t t', i \in V k -> j \in V k -> (T k < t)%N -> (t <= t')%N -> G t i j -> G t' i j &
      ('C(#|V k|, 2) < count (differs G) (iota (T k).+1 U))%N].

(* ---- a fixed connected network, continued ---- *)
Definition half (R : rcfType) n (c : 'I_n -> R) : 'M[R]_n := diag_mx (\row_i Num.sqrt (c i)).
Definition half_inv (R : rcfType) n (c : 'I_n -> R) : 'M[R]_n := diag_mx (\row_i (Num.sqrt (c i))^-1).
Definition M_of (R : rcfType) n (G : rel 'I_n) (c : 'I_n -> R) := half_inv c *m transition G c *m half c.
Definition pi_of (R : realFieldType) n (c : 'I_n -> R) : 'rV[R]_n := \row_j ((\sum_i (c i)^-1)^-1 * (c j)^-1).
Definition is_eigenvalue (R : realFieldType) n (A : 'M[R]_n) lam := exists u : 'cV[R]_n, u != 0 /\ A *m u = lam *: u.
(* chazelle.eq3.7 clauses 1, 3, 4; the unit eigenvector is unique up to its sign, the eigenvalues are the same also with multiplicities *)
Definition eq3_7_1 : Prop := forall (R : rcfType) n (G : rel 'I_n) (c : 'I_n -> R), fixed G c ->
  M_of G c = 1%:M - half c *m laplacian R G *m half c /\ (M_of G c)^T = M_of G c.
Definition eq3_7_3 : Prop := forall (R : rcfType) n (G : rel 'I_n) (c : 'I_n -> R), (0 < n)%N -> fixed G c ->
  let u1 : 'cV[R]_n := \col_i Num.sqrt (pi_of c 0 i) in
  [/\ M_of G c *m u1 = u1, \sum_i u1 i 0 ^+ 2 = 1 &
      forall u : 'cV[R]_n, M_of G c *m u = u -> \sum_i u i 0 ^+ 2 = 1 -> u = u1 \/ u = - u1].
Definition eq3_7_4 : Prop := forall (R : rcfType) n (G : rel 'I_n) (c : 'I_n -> R), fixed G c ->
  (forall lam, is_eigenvalue (transition G c) lam <-> is_eigenvalue (M_of G c) lam) /\ char_poly (transition G c) = char_poly (M_of G c).
(* orthonormal eigenvectors u_1, ..., u_n of M with eigenvalues lambda_1 = 1, lambda_2, ..., lambda_n, here counted from 0 *)
Definition eigenbasis (R : rcfType) m (G : rel 'I_m.+1) (c : 'I_m.+1 -> R) (lam : 'I_m.+1 -> R) (u : 'I_m.+1 -> 'cV[R]_m.+1) :=
  [/\ forall k l, ((u k)^T *m u l) 0 0 = (k == l)%:R, forall k, M_of G c *m u k = lam k *: u k & lam ord0 = 1].
(* chazelle.eq3.8 clauses 1, 2; and that there are such eigenvectors *)
Definition eq3_8_1 : Prop := forall (R : rcfType) m (G : rel 'I_m.+1) (c : 'I_m.+1 -> R) lam u, fixed G c -> eigenbasis G c lam u ->
  forall s, mpow (transition G c) s = const_mx 1 *m pi_of c + \sum_(k | k != ord0) lam k ^+ s *: (half c *m u k *m (u k)^T *m half_inv c).
Definition eq3_8_2 : Prop := forall (R : rcfType) m (G : rel 'I_m.+1) (c : 'I_m.+1 -> R) lam u, fixed G c -> eigenbasis G c lam u ->
  forall k, [/\ half_inv c *m u k != 0, half c *m u k != 0,
    (half_inv c *m u k)^T *m transition G c = lam k *: (half_inv c *m u k)^T &
    transition G c *m (half c *m u k) = lam k *: (half c *m u k)].
Definition eq3_8_basis : Prop := forall (R : rcfType) m (G : rel 'I_m.+1) (c : 'I_m.+1 -> R), fixed G c -> exists lam u, eigenbasis G c lam u.
(* chazelle.eq3.10 clauses 1, 2, with one n^O(1) and one constant c_0 for both *)
Definition eq3_10 : Prop := forall a, exists K c0, forall (R : rcfType) (E : R -> R) n (G : rel 'I_n) (c : 'I_n -> R),
  exponential E -> (1 < n)%N -> fixed G c -> short_weights a c -> forall s, (n ^ c0 < s)%N ->
  let bound := 1 - \sum_k (pi_of c 0 k - n%:R ^+ K * E (- (s%:R / n%:R ^+ K))) in
  tau1 (mpow (transition G c) s) <= bound /\ bound < 2%:R^-1.
(* a flock of network G: the birds f 0, ..., f m, connected, with no edge to any other; its network, its weights, its velocities *)
Definition own_network n m (f : 'I_m -> 'I_n) (G : rel 'I_n) : rel 'I_m := fun k l => G (f k) (f l).
Definition is_flock n m (f : 'I_m.+1 -> 'I_n) (G : rel 'I_n) :=
  [/\ injective f, forall k l, connect (own_network f G) k l & forall k j, G (f k) j -> exists l, f l = j].
Definition own_rows (R : realFieldType) n m d (f : 'I_m -> 'I_n) (y : 'M[R]_(n, d)) : 'M[R]_(m, d) := \matrix_(k, q) y (f k) q.
Definition unchanged (R : realFieldType) n (G : nat -> rel 'I_n) (w : nat -> 'I_n -> R) t1 t :=
  forall u, (t1 <= u < t)%N -> (forall i j, G u i j = G t1 i j) /\ forall i, w u i = w t1 i.
Definition motion_D (R : realFieldType) n d (x v : nat -> 'M[R]_(n, d)) G w := [/\ in_model_D G w, forall t, x t.+1 = x t + v t.+1 &
  forall t, (0 < t)%N -> v t.+1 = P_of G w t *m v t].
Definition y_of (R : realFieldType) m d (c : 'I_m.+1 -> R) (v1 : 'M[R]_(m.+1, d)) : 'rV[R]_d := pi_of c *m v1.
Definition Phi (R : rcfType) m d (c : 'I_m.+1 -> R) (u : 'I_m.+1 -> 'cV[R]_m.+1) (v1 : 'M[R]_(m.+1, d)) i k : 'rV[R]_d :=
  (delta_mx 0 i : 'rV_m.+1) *m (half c *m u k *m (u k)^T *m half_inv c) *m v1.
(* chazelle.xi.closed *)
Definition xi_closed : Prop := forall (R : rcfType) n d m (x v : nat -> 'M[R]_(n, d)) G w t1 t (f : 'I_m.+1 -> 'I_n) lam u i,
  motion_D x v G w -> (0 < t1 <= t)%N -> unchanged G w t1 t -> is_flock f (G t1) -> (forall k, 0 < w t1 (f k)) ->
  let c := fun k => w t1 (f k) in let v1 := own_rows f (v t1.+1) in eigenbasis (own_network f (G t1)) c lam u ->
  row (f i) (x t) = row (f i) (x t1) + (t - t1)%:R *: y_of c v1
    + \sum_(k | k != ord0) ((1 - lam k ^+ (t - t1)) / (1 - lam k)) *: Phi c u v1 i k.
(* chazelle.eq3.16 clause 1, refuted: there are no u_0, ..., u_m; the summand of k = 1 is Phi_1/(1 - 1), no vector unless Phi_1 = y = 0 *)
Definition eq3_16 : Prop :=
  (forall (R : realFieldType) m (u : nat -> 'cV[R]_m),
    ~ forall k l, (k <= m)%N -> (l <= m)%N -> ((u k)^T *m u l) 0 0 = (k == l)%:R) /\
  forall (R : rcfType) m d (G : rel 'I_m.+1) (c : 'I_m.+1 -> R) lam u (v1 : 'M[R]_(m.+1, d)) i, fixed G c -> eigenbasis G c lam u ->
    Phi c u v1 i ord0 = y_of c v1 /\ (y_of c v1 != 0 -> forall q : 'rV[R]_d, (1 - lam ord0) *: q <> Phi c u v1 i ord0).
(* chazelle.eq3.17; birds i and j of flocks f and g, which may be one; the summands in the order of falling mu, each mu an eigenvalue
   of one of the two flocks; A as the text gives it *)
Definition eq3_17 : Prop := forall (R : rcfType) n d m m' (x v : nat -> 'M[R]_(n, d)) G w t1
  (f : 'I_m.+1 -> 'I_n) (g : 'I_m'.+1 -> 'I_n) lam u lam' u' i j,
  motion_D x v G w -> (0 < t1)%N -> is_flock f (G t1) -> is_flock g (G t1) ->
  (forall k, 0 < w t1 (f k)) -> (forall k, 0 < w t1 (g k)) ->
  let c := fun k => w t1 (f k) in let c' := fun k => w t1 (g k) in
  let Gf := own_network f (G t1) in let Gg := own_network g (G t1) in
  let v1 := own_rows f (v t1.+1) in let v1' := own_rows g (v t1.+1) in
  let B := y_of c v1 - y_of c' v1' in
  let A := row (f i) (x t1) - row (g j) (x t1) + (row i (Gamma_of Gf c *m v1) - row j (Gamma_of Gg c' *m v1')) in
  eigenbasis Gf c lam u -> eigenbasis Gg c' lam' u' ->
  exists terms : seq (R * 'rV[R]_d), [/\ sorted (fun p q : R * 'rV[R]_d => q.1 <= p.1) terms,
    forall p, p \in terms -> `|p.1| < 1 /\ (is_eigenvalue (transition Gf c) p.1 \/ is_eigenvalue (transition Gg c') p.1) &
    forall t, (t1 <= t)%N -> unchanged G w t1 t ->
      row (f i) (x t) - row (g j) (x t) = A + (t - t1)%:R *: B - \sum_(p <- terms) p.1 ^+ (t - t1) *: p.2].

(* ---- examples and matrices ---- *)
Definition rows_of (R : realFieldType) n (rows : seq (seq R)) : 'M[R]_n := \matrix_(i, j) nth 0 (nth [::] rows i) j.
Definition col_of (R : realFieldType) n (r : seq R) : 'cV[R]_n := \col_i nth 0 r i.
(* chazelle.ex15 clauses 2, 3, 4, 5; decimals to half a unit of their last place *)
Definition ex15_P (R : realFieldType) : 'M[R]_2 := 15%:R^-1 *: rows_of 2 [:: [:: 12%:R; 3%:R]; [:: 10%:R; 5%:R]].
Definition ex15_2 : Prop := forall R : realFieldType, exists mu : R,
  `|mu - 133%:R / 1000%:R| <= 2000%:R^-1 /\ forall lam, is_eigenvalue (ex15_P R) lam <-> lam = 1 \/ lam = mu.
Definition ex15_3 : Prop := forall R : rcfType,
  `|norm2 ((ex15_P R *m col_of 2 [:: 1; 0])^T) - 1041%:R / 1000%:R| <= 2000%:R^-1.
Definition ex15_4 : Prop := forall (R : realFieldType) lam (u : 'cV[R]_2), lam != 1 -> u != 0 -> ex15_P R *m u = lam *: u -> \sum_i u i 0 != 0.
Definition ex15_5 : Prop := forall R : realFieldType, exists u : 'cV[R]_2, \sum_i u i 0 = 0 /\ \sum_i (ex15_P R *m u) i 0 != 0.
(* chazelle.ex4birds.eig *)
Definition ex4_two (R : realFieldType) : 'M[R]_4 := 3%:R^-1 *: rows_of 4 [:: [:: 1; 2%:R; 0; 0]; [:: 2%:R; 1; 0; 0]; [:: 0; 0; 1; 2%:R]; [:: 0; 0; 2%:R; 1]].
Definition ex4_path (R : realFieldType) : 'M[R]_4 := 3%:R^-1 *: rows_of 4 [:: [:: 1; 2%:R; 0; 0]; [:: 1; 1; 1; 0]; [:: 0; 1; 1; 1]; [:: 0; 0; 2%:R; 1]].
Definition ex4_v1 (R : realFieldType) : 'cV[R]_4 := 8%:R^-1 *: col_of 4 [:: 1; -1; 1; -1].
Definition ex4_x0 (R : realFieldType) : 'cV[R]_4 := 16%:R^-1 *: col_of 4 [:: 0; 8%:R; 21%:R; 29%:R].
Definition ex4_eig : Prop := forall R : realFieldType, [/\ ex4_v1 R != 0,
  ex4_two R *m ex4_v1 R = (- 3%:R^-1) *: ex4_v1 R & ex4_path R *m ex4_v1 R = (- 3%:R^-1) *: ex4_v1 R].
(* the example flies without hysteresis, and with the weights 2/(3 d_i) of the two printed matrices *)
Definition ex4 (R : realFieldType) (x v : nat -> 'cV[R]_4) (G : nat -> rel 'I_4) := [/\ x 0%N = ex4_x0 R, v 1%N = ex4_v1 R,
  forall t i j, G t i j = (i != j) && (`|x t i 0 - x t j 0| <= 1), forall t, x t.+1 = x t + v t.+1 &
  forall t, (0 < t)%N -> v t.+1 = transition (G t) (lazy R (G t)) *m v t].
(* chazelle.ex4birds.alt; also that the transition matrices are the two printed ones *)
Definition ex4_alt : Prop := forall R : realFieldType, (exists x v G, @ex4 R x v G) /\
  forall (x v : nat -> 'cV[R]_4) G, ex4 x v G -> forall t,
    ((n_comp (G t) predT = 1%N /\ n_comp (G t.+1) predT = 2%N) \/ (n_comp (G t) predT = 2%N /\ n_comp (G t.+1) predT = 1%N)) /\
    transition (G t) (lazy R (G t)) = if n_comp (G t) predT == 1%N then ex4_path R else ex4_two R.
(* chazelle.ex4birds.eq3.14 clauses 1, 2, 3, 4 *)
Definition ex4_motion : Prop := forall (R : realFieldType) (x v : nat -> 'cV[R]_4) G, ex4 x v G ->
  (forall t, x t = ex4_x0 R + (3%:R / 4%:R * (1 - (- 3%:R^-1) ^+ t)) *: ex4_v1 R) /\
  forall t, (0 < t)%N -> let gap i := x t (inord i.+1) 0 - x t (inord i) 0 in
    [/\ gap 0%N = 16%:R^-1 * (5%:R - (- 3%:R^-1) ^+ t.-1), gap 2%N = 16%:R^-1 * (5%:R - (- 3%:R^-1) ^+ t.-1),
        4%:R^-1 <= gap 0%N <= 2%:R^-1 /\ 4%:R^-1 <= gap 2%N <= 2%:R^-1 & gap 1%N = 1 + 16%:R^-1 * (- 3%:R^-1) ^+ t.-1].
(* chazelle.exAB, t = 2 k; A and B are I - C L of networks with c_i d_i = 1 *)
Definition exAB_A (R : realFieldType) : 'M[R]_3 := rows_of 3 [:: [:: 0; 1; 0]; [:: 1; 0; 0]; [:: 0; 0; 1]].
Definition exAB_B (R : realFieldType) : 'M[R]_3 := 2%:R^-1 *: rows_of 3 [:: [:: 0; 2%:R; 0]; [:: 1; 0; 1]; [:: 0; 2%:R; 0]].
Definition exAB : Prop := forall R : realFieldType,
  (forall A, A = exAB_A R \/ A = exAB_B R -> exists (G : rel 'I_3) (c : 'I_3 -> R),
    [/\ network G, forall i, (0 < degree G i)%N -> c i * (degree G i)%:R = 1 & A = transition G c]) /\
  forall k, (0 < k)%N -> let P t := if odd t then exAB_B R else exAB_A R in
    pprod P (2 * k)%N 1 = mpow (exAB_A R *m exAB_B R) k /\
    pprod P (2 * k)%N 1 = rows_of 3 [:: [:: (2%:R ^+ k)^-1; 1 - 2%:R / 2%:R ^+ k; (2%:R ^+ k)^-1]; [:: 0; 1; 0]; [:: 0; 1; 0]].
(* chazelle.fiedler.rate clause 1; every eigenvalue of the Laplacian but the 0 of the constant vectors *)
Definition fiedler_1 : Prop := exists K, forall (R : realFieldType) n (G : rel 'I_n), (1 < n)%N -> network G -> (forall i j, connect G i j) ->
  forall (lam : R) (u : 'cV[R]_n), (exists i j, u i 0 != u j 0) -> laplacian R G *m u = lam *: u -> (n%:R ^+ K)^-1 <= lam.
(* chazelle.foot.mono clauses 2, 3 *)
Definition foot_2 : Prop := forall R : rcfType, exists n d a b c (x v : nat -> 'M[R]_(n, d)) G w s t i j,
  [/\ rational_flock a b c x v G w, (0 < s <= t)%N, pprod (P_of G w) t s i j != 0 & pprod (P_of G w) t s j i = 0].
Definition foot_3 : Prop := forall (R : realFieldType) n (G : rel 'I_n) (c : 'I_n -> R), network G -> model_D G c ->
  (forall i j, (transition G c i j != 0) = (transition G c j i != 0)) /\ forall i, transition G c i i != 0.
(* chazelle.kron clauses 1, 2; the rule gives exactly one matrix *)
Definition is_kron (R : comRingType) m n p q (A : 'M[R]_(m, n)) (B : 'M[R]_(p, q)) (K : 'M[R]_(m * p, n * q)) :=
  forall (i : 'I_m) (j : 'I_p) (k : 'I_n) (l : 'I_q) (r : 'I_(m * p)) (c : 'I_(n * q)),
    r = (i * p + j)%N :> nat -> c = (k * q + l)%N :> nat -> K r c = A i k * B j l.
Definition kron_1 : Prop := forall (R : comRingType) m n p q (A : 'M[R]_(m, n)) (B : 'M[R]_(p, q)), exists! K, is_kron A B K.
Definition kron_2 : Prop := forall (R : comRingType) m n p q l h (A : 'M[R]_(m, n)) (B : 'M[R]_(p, q)) (C : 'M[R]_(n, l)) (D : 'M[R]_(q, h)) K1 K2,
  is_kron A B K1 -> is_kron C D K2 -> is_kron (A *m C) (B *m D) (K1 *m K2).
(* chazelle.modelK.matrix clauses 1, 2; it is the only matrix of the update *)
Definition modelK_12 : Prop := forall (R : realFieldType) n (G : rel 'I_n), network G ->
  let c := fun i => (degree G i).+1%:R^-1 : R in let P := 1%:M - diag_mx (\row_i c i) *m laplacian R G in
  (forall Q : 'M[R]_n, (forall (theta : 'cV[R]_n) i, (Q *m theta) i 0 = (theta i 0 + \sum_(j | G i j) theta j 0) / (degree G i).+1%:R) <-> Q = P) /\
  forall i j, P i j = if (i == j) || G i j then (degree G i).+1%:R^-1 else 0.

(* ---- the theorems prove the second part ---- *)
Lemma foot_3_proved : foot_3.
Proof.
move=> R n G c net MD; split=> [i j|i]; rewrite !transition_edge ?eqxx //; by rewrite eq_sym (proj1 net).
Qed.
Lemma modelK_12_proved : modelK_12.
Proof.
move=> R n G net c P.
have PE : P = transition G (vicsek R G) by [].
split=> [Q|i j]; last by rewrite PE (proj2 (model_K_matrix 0 i net)).
split=> [H|-> theta i]; last by rewrite PE (proj1 (model_K_matrix theta i net)).
apply/matrixP => i j; have := H (delta_mx j 0) i; rewrite -(proj1 (model_K_matrix _ i net)) -PE.
by rewrite -!colE !mxE.
Qed.
Lemma fiedler_1_proved : fiedler_1.
Proof.
exists 2%N => R n G n1 net con lam u ne E; apply: le_trans (fiedler_3_proved n1 net con ne E).
have n0 : 0 < (n%:R : R) by rewrite ltr0n ltnW.
have m0 : 0 < (n.-1%:R : R) by rewrite ltr0n; case: n n1 {G net con u ne E n0} => [|[]].
apply: (@le_trans _ _ (1 / (n%:R * n.-1%:R))); last by rewrite ler_pmul2r ?invr_gt0 ?mulr_gt0 // ler1n.
rewrite div1r lef_pinv ?posrE ?exprn_gt0 ?mulr_gt0 // expr2 ler_pmul2l // ler_nat; exact: leq_pred.
Qed.
(* a 2 x 2 or larger matrix entry by entry *)
Ltac entries := apply/matrixP => -[[|[|[|[|?]]]] ?] // [[|[|[|[|?]]]] ?] //.
Ltac sums := rewrite ?mxE ?big_ord_recl ?big_ord0 ?mxE /=.
Lemma ex4_eig_proved : ex4_eig.
Proof.
move=> R; split.
- apply/eqP => /matrixP/(_ (@Ordinal 4 0 isT) 0); rewrite !mxE /= mulr1 => /eqP; by rewrite invr_eq0 pnatr_eq0.
- by apply/matrixP => -[[|[|[|[|?]]]] ?] // j; rewrite !mxE !big_ord_recl big_ord0 !mxE /=; field.
- by apply/matrixP => -[[|[|[|[|?]]]] ?] // j; rewrite !mxE !big_ord_recl big_ord0 !mxE /=; field.
Qed.

Local Notation second := (lift ord0 ord0).
Lemma ex15_apply (R : realFieldType) (u : 'cV[R]_2) :
  (ex15_P R *m u) ord0 ord0 = (12%:R * u ord0 ord0 + 3%:R * u second ord0) / 15%:R /\
  (ex15_P R *m u) second ord0 = (10%:R * u ord0 ord0 + 5%:R * u second ord0) / 15%:R.
Proof. by split; rewrite mxE !big_ord_recl big_ord0 !mxE /=; field. Qed.
Lemma ex15_eigen (R : realFieldType) (u : 'cV[R]_2) lam : ex15_P R *m u = lam *: u <->
  (12%:R * u ord0 ord0 + 3%:R * u second ord0) / 15%:R = lam * u ord0 ord0 /\
  (10%:R * u ord0 ord0 + 5%:R * u second ord0) / 15%:R = lam * u second ord0.
Proof.
have [A B] := ex15_apply u; split=> [E|[E F]].
  by rewrite -A -B E !mxE.
apply/matrixP => i j; rewrite ord1 [RHS]mxE; case: (unliftP ord0 i) => [k|] ->; last by rewrite A E.
by rewrite (ord1 k) B F.
Qed.
Lemma ex15_cases (R : realFieldType) (u : 'cV[R]_2) lam : u != 0 -> ex15_P R *m u = lam *: u ->
  (lam = 1 \/ lam = 2%:R / 15%:R) /\ (lam != 1 -> u ord0 ord0 != 0 /\ u second ord0 = - (10%:R / 3%:R) * u ord0 ord0).
Proof.
move=> u0 /ex15_eigen[]; set x := u ord0 ord0; set y := u second ord0 => E F.
have nz : ~~ ((x == 0) && (y == 0)).
  apply/negP => /andP[/eqP x0 /eqP y0]; case/eqP: u0; apply/matrixP => i j; rewrite ord1 mxE.
  by case: (unliftP ord0 i) => [k|] ->; rewrite ?(ord1 k).
have E' : (15%:R * lam - 12%:R) * x = 3%:R * y by rewrite mulrBl -mulrA -E; field.
have F' : (15%:R * lam - 5%:R) * y = 10%:R * x by rewrite mulrBl -mulrA -F; field.
have x0 : x != 0.
  by apply: contra nz => /eqP z; rewrite z eqxx /=; move: E'; rewrite z mulr0 => /esym/eqP; rewrite mulf_eq0 pnatr_eq0.
have Y : y = (15%:R * lam - 12%:R) * x / 3%:R by rewrite E'; field.
have : (15%:R * (lam - 1)) * (15%:R * lam - 2%:R) = 0.
  apply: (mulIf x0); rewrite mul0r.
  transitivity (3%:R * ((15%:R * lam - 5%:R) * y - 10%:R * x)); first by rewrite Y; field.
  by rewrite F' subrr mulr0.
move/eqP; rewrite !mulf_eq0 pnatr_eq0 /= => C.
have C' : lam = 1 \/ lam = 2%:R / 15%:R.
  case/orP: C => [|]; rewrite subr_eq0 => /eqP h; [by left|right].
  by rewrite -h; field.
split=> // l1; split=> //; case: C' => [h|h]; first by rewrite h eqxx in l1.
by rewrite Y h; field.
Qed.
Lemma ex15_2_proved : ex15_2.
Proof.
move=> R; exists (2%:R / 15%:R); split.
  rewrite (_ : _ - _ = 3000%:R^-1); last by field.
  by rewrite ger0_norm ?invr_ge0 ?ler0n // lef_pinv ?posrE ?ltr0n // ler_nat.
move=> lam; split=> [[u [u0 E]]|]; first by case: (ex15_cases u0 E).
have nz (a b : R) : a != 0 -> (\col_(i < 2) (if i == ord0 then a else b)) != 0.
  by move=> a0; apply: contraNneq a0 => /matrixP/(_ ord0 ord0); rewrite !mxE /= => ->.
case=> ->; [exists (\col_i (if i == ord0 then 1 else 1))|exists (\col_i (if i == ord0 then 3%:R else - 10%:R))].
  by split; [apply: nz; rewrite oner_neq0|apply/ex15_eigen; rewrite !mxE /=; split; field].
by split; [apply: nz; rewrite pnatr_eq0|apply/ex15_eigen; rewrite !mxE /=; split; field].
Qed.
Lemma sum2 (R : realFieldType) (u : 'cV[R]_2) : \sum_i u i 0 = u ord0 ord0 + u second ord0.
Proof. by rewrite !big_ord_recl big_ord0 addr0. Qed.
Lemma ex15_4_proved : ex15_4.
Proof.
move=> R lam u l1 u0 E; have [_ /(_ l1)[x0 Y]] := ex15_cases u0 E; rewrite sum2 Y.
rewrite (_ : _ + _ = - (7%:R / 3%:R) * u ord0 ord0); last by field.
by rewrite mulf_neq0 // oppr_eq0 mulf_neq0 ?invr_eq0 ?pnatr_eq0.
Qed.
Lemma ex15_5_proved : ex15_5.
Proof.
move=> R; exists (\col_i (if i == ord0 then 1 else -1)); split; first by rewrite sum2 !mxE /=; ring.
rewrite sum2; set u := \col_i _; have [-> ->] := ex15_apply u; rewrite !mxE /=.
rewrite (_ : _ + _ = 14%:R / 15%:R); last by field.
by rewrite mulf_neq0 ?invr_eq0 ?pnatr_eq0.
Qed.
Lemma ex15_3_proved : ex15_3.
Proof.
move=> R; rewrite /norm2 !big_ord_recl big_ord0.
have [A B] := ex15_apply (col_of 2 [:: 1; 0] : 'cV[R]_2); rewrite !(mxE trmx_key) A B !mxE /=.
set S := Num.sqrt _; have -> : S = Num.sqrt (244%:R / 225%:R) by rewrite /S; congr Num.sqrt; field.
have pos (p q r s : nat) : 0 <= (p%:R / (q%:R * r%:R * s%:R) : R) by rewrite divr_ge0 ?mulr_ge0 ?ler0n.
have below : 51%:R / 49%:R <= Num.sqrt (244%:R / 225%:R) :> R.
  rewrite -[X in X <= _]ger0_norm ?divr_ge0 ?ler0n // -sqrtr_sqr; apply: ler_wsqrtr; rewrite -subr_ge0.
  rewrite (_ : _ - _ = 619%:R / (225%:R * 49%:R * 49%:R)); [exact: pos|by field].
have above : Num.sqrt (244%:R / 225%:R) <= 151%:R / 145%:R :> R.
  rewrite -[X in _ <= X]ger0_norm ?divr_ge0 ?ler0n // -sqrtr_sqr; apply: ler_wsqrtr; rewrite -subr_ge0.
  rewrite (_ : _ - _ = 125%:R / (225%:R * 145%:R * 145%:R)); [exact: pos|by field].
rewrite ler_distl; apply/andP; split.
  apply: le_trans below; rewrite -subr_ge0 (_ : _ - _ = 31%:R / (49%:R * 2000%:R * 1%:R)); [exact: pos|by field].
apply: (le_trans above); rewrite -subr_ge0 (_ : _ - _ = 35%:R / (145%:R * 2000%:R * 1%:R)); [exact: pos|by field].
Qed.
(* ---- kron ---- *)
Lemma kron_bound (m p : nat) (i : 'I_m) (j : 'I_p) : (i * p + j < m * p)%N.
Proof.
by apply: (@leq_trans (i.+1 * p)); [rewrite mulSn addnC ltn_add2r | rewrite leq_mul2r ltn_ord orbT].
Qed.
Definition kron_at m p (i : 'I_m) (j : 'I_p) := Ordinal (kron_bound i j).
Lemma kron_reach m p (r : 'I_(m * p)) : exists i j, r = @kron_at m p i j.
Proof.
case: (posnP p) => [p0|p0]; first by have := ltn_ord r; rewrite {2}p0 muln0.
have rm : (r %/ p < m)%N by rewrite ltn_divLR.
exists (Ordinal rm), (Ordinal (ltn_pmod r p0)); apply: val_inj; exact: divn_eq.
Qed.
Lemma kron_at_inj m p i j i' j' : @kron_at m p i j = kron_at i' j' -> i = i' /\ j = j'.
Proof.
move/(congr1 val) => /= E; have p0 : (0 < p)%N by apply: leq_ltn_trans (leq0n _) (ltn_ord j).
split; apply: val_inj.
  by have := congr1 (divn^~ p) E; rewrite !divnMDl // !(divn_small (ltn_ord _)) !addn0.
by have := congr1 (modn^~ p) E; rewrite !modnMDl !(modn_small (ltn_ord _)).
Qed.
Lemma is_kron_at (R : comRingType) m n p q (A : 'M[R]_(m, n)) (B : 'M[R]_(p, q)) K :
  is_kron A B K <-> forall i j k l, K (kron_at i j) (kron_at k l) = A i k * B j l.
Proof.
split=> H i j k l; first exact: H.
move=> r c re ce; have -> : r = kron_at i j by apply: val_inj.
have -> : c = kron_at k l by apply: val_inj.
exact: H.
Qed.
Lemma kron_1_proved : kron_1.
Proof.
move=> R m n p q A B.
have [p0|p0] := posnP p.
  exists 0; split=> [i j|K _]; first by have := ltn_ord j; rewrite {2}p0.
  by apply/matrixP => r; have := ltn_ord r; rewrite {2}p0 muln0.
have [q0|q0] := posnP q.
  exists 0; split=> [i j k l|K _]; first by have := ltn_ord l; rewrite {2}q0.
  by apply/matrixP => r c; have := ltn_ord c; rewrite {2}q0 muln0.
pose lo a b (b0 : (0 < b)%N) (r : 'I_(a * b)) : 'I_b := Ordinal (ltn_pmod r b0).
have hi a b (b0 : (0 < b)%N) (r : 'I_(a * b)) : (r %/ b < a)%N by rewrite ltn_divLR.
exists (\matrix_(r, c) (A (Ordinal (hi _ _ p0 r)) (Ordinal (hi _ _ q0 c)) * B (lo _ _ p0 r) (lo _ _ q0 c))); split.
  apply/is_kron_at => i j k l; rewrite mxE; congr (A _ _ * B _ _); apply: val_inj => /=;
    by rewrite ?divnMDl ?modnMDl // ?(divn_small (ltn_ord _)) ?(modn_small (ltn_ord _)) ?addn0.
move=> K /is_kron_at H; apply/matrixP => r c; have [i [j ->]] := kron_reach r; have [k [l ->]] := kron_reach c.
rewrite H mxE; congr (A _ _ * B _ _); apply: val_inj => /=;
  by rewrite ?divnMDl ?modnMDl // ?(divn_small (ltn_ord _)) ?(modn_small (ltn_ord _)) ?addn0.
Qed.
Lemma kron_2_proved : kron_2.
Proof.
move=> R m n p q l h A B C D K1 K2 /is_kron_at H1 /is_kron_at H2; apply/is_kron_at => i j k e; rewrite !mxE.
have S (F : 'I_(n * q) -> R) : \sum_c F c = \sum_i0 \sum_j0 F (kron_at i0 j0).
  rewrite pair_big /= (reindex (fun ij : 'I_n * 'I_q => kron_at ij.1 ij.2)) //=.
  apply/onW_bij/inj_card_bij; last by rewrite card_prod !card_ord.
  by move=> [a b] [a' b'] /= /kron_at_inj[-> ->].
rewrite S mulr_suml; apply: eq_bigr => a _; rewrite mulr_sumr; apply: eq_bigr => b _.
by rewrite H1 H2 mulrACA.
Qed.
(* ---- the misprinted chi ---- *)
Lemma no_chi_proved (R : realFieldType) n (i : 'I_n) (chi : 'rV[R]_n) : ~ (chi 0 i = 1 /\ chi 0 i = -1).
Proof. by case; apply: chi_printed_impossible. Qed.
(* ---- the exponential ---- *)
Section Exponential.
Variables (R : realFieldType) (E : R -> R).
Hypothesis HE : exponential E.
Lemma E0 : E 0 = 1.
Proof.
have [A B] := HE; have e0 : E 0 != 0 by apply: lt0r_neq0; apply: lt_le_trans (B 0); rewrite addr0 ltr01.
by apply: (mulfI e0); rewrite -A addr0 mulr1.
Qed.
Lemma EN x : E (- x) * E x = 1. Proof. by have [A _] := HE; rewrite -A addNr E0. Qed.
Lemma E_gt0 x : 0 < E x.
Proof.
have [A B] := HE; have Q : E x = E (x / 2%:R) ^+ 2 by rewrite expr2 -A -splitr.
rewrite Q lt_def sqr_ge0 andbT -Q; apply/eqP => z; have := EN x; rewrite z mulr0 => /esym/eqP; by rewrite oner_eq0.
Qed.
Lemma E_power x k : E (k%:R * x) = E x ^+ k.
Proof.
elim: k => [|k IH]; first by rewrite mul0r E0.
have [A _] := HE; by rewrite mulrSr mulrDl mul1r A IH exprSr.
Qed.
(* (1 - x)^k <= e^(-k x) *)
Lemma power_E x k : x <= 1 -> (1 - x) ^+ k <= E (- (k%:R * x)).
Proof.
move=> x1; rewrite -mulrN E_power; have [_ B] := HE.
by apply: ler_expn2r; rewrite ?nnegrE ?subr_ge0 // ltW ?E_gt0.
Qed.
Lemma E_small x : 0 < x -> E (- x) < x^-1.
Proof.
move=> x0; have [_ B] := HE; have X : x < E x by apply: lt_le_trans (B x); rewrite ltr_addr ltr01.
have Ex := E_gt0 x; rewrite -[E (- x)](mulfK (lt0r_neq0 Ex)) EN mul1r ltf_pinv //.
Qed.
End Exponential.
Lemma pi_is (R : realFieldType) n (c : 'I_n -> R) i : pi_of c 0 i = stat c i.
Proof. by rewrite mxE. Qed.
Lemma eq3_10_proved : eq3_10.
Proof.
move=> a; exists (2 * a + 4)%N, (4 * a + 10)%N => R E n G c HE n1 F sw s ss bound.
have [B1 B2] := short_bounds n1 F sw; case: F => net MD con c0.
have n0 : (0 < n)%N := ltnW n1; pose i0 := Ordinal n0.
have N0 : 0 < (n%:R : R) by rewrite ltr0n.
have N1 : 1 <= (n%:R : R) by rewrite ler1n.
pose K := (2 * a + 4)%N; have NK : 0 < (n%:R : R) ^+ K by rewrite exprn_gt0.
have sums x : 1 - \sum_k (stat c k - x) = n%:R * x.
  by rewrite sumrB (stat_sum c0 i0) sumr_const card_ord -[x *+ n]mulr_natl subKr.
have bE : bound = n%:R * (n%:R ^+ K * E (- (s%:R / n%:R ^+ K))).
  by rewrite /bound (eq_bigr (fun k => stat c k - n%:R ^+ K * E (- (s%:R / n%:R ^+ K)))) => [|k _]; rewrite ?pi_is ?sums.
have [|A _] := @chazelle_network.eq_3_10 R n G c net MD con c0 a n1 B1 B2 s; first by apply: leq_trans ss; rewrite ltnS leq_pexp2l //; lia.
split.
  apply: (le_trans A); rewrite sums bE; apply: ler_wpmul2l; first exact: ltW.
  have Ki : (n%:R ^+ K)^-1 <= 1 :> R by rewrite invf_le1 ?exprn_ege1.
  apply: ler_pmul; first by rewrite exprn_ge0 // ltW.
  - by rewrite exprn_ge0 // subr_ge0.
  - by rewrite ler_weexpn2l // /K; lia.
  - exact: (power_E HE).
have s0 : 0 < (s%:R : R) by rewrite ltr0n; apply: leq_ltn_trans ss.
have x0 : 0 < s%:R / n%:R ^+ K :> R by rewrite divr_gt0.
rewrite bE mulrA -exprS; apply: (@lt_le_trans _ _ (n%:R ^+ K.+1 * (s%:R / n%:R ^+ K)^-1)).
  by rewrite ltr_pmul2l ?exprn_gt0 // E_small.
rewrite invf_div mulrA -exprD ler_pdivr_mulr // mulrC ler_pdivl_mulr ?ltr0n //.
apply: (@le_trans _ _ (n%:R ^+ (4 * a + 10))); last by rewrite -natrX ler_nat ltnW.
apply: (@le_trans _ _ (n%:R ^+ (K.+1 + K).+1)).
  by rewrite exprSr; apply: ler_wpmul2l; rewrite ?exprn_ge0 ?ler_nat ?ler0n.
by rewrite ler_weexpn2l //; rewrite /K; lia.
Qed.
(* ---- the spectral form ---- *)
Section Halves.
Variables (R : rcfType) (n : nat) (G : rel 'I_n) (c : 'I_n -> R).
Hypothesis F : fixed G c.
Lemma half_neq0 i : Num.sqrt (c i) != 0. Proof. by case: F => _ _ _ c0; rewrite gt_eqF ?sqrtr_gt0. Qed.
Lemma halfK : half c *m half_inv c = 1%:M.
Proof.
rewrite mul_diag_mx; apply/matrixP => i j; rewrite !mxE; case: eqP => [->|_]; rewrite ?mulr1n ?mulfV ?half_neq0 //.
by rewrite !mulr0n mulr0.
Qed.
Lemma half_invK : half_inv c *m half c = 1%:M.
Proof. exact: mulmx1C halfK. Qed.
Lemma M_half : half c *m M_of G c = transition G c *m half c.
Proof. by rewrite /M_of !mulmxA halfK mul1mx. Qed.
Lemma M_half_inv : M_of G c *m half_inv c = half_inv c *m transition G c.
Proof. by rewrite /M_of -!mulmxA halfK mulmx1. Qed.
Lemma MofE i j : M_of G c i j = (Num.sqrt (c i))^-1 * transition G c i j * Num.sqrt (c j).
Proof. by rewrite /M_of mul_mx_diag mxE mul_diag_mx !mxE. Qed.
End Halves.
Lemma M_is (R : rcfType) m (G : rel 'I_m.+1) (c : 'I_m.+1 -> R) : M_of G c = chazelle_spectral.M G c.
Proof. by apply/matrixP => i j; rewrite MofE !mxE. Qed.
Lemma eq3_7_1_proved : eq3_7_1.
Proof.
move=> R [|m] G c F; first by split; apply/matrixP => -[].
case: F => net MD con c0; have [A B _ _ _] := chazelle_spectral.eq_3_7 net MD con c0.
rewrite M_is; split; apply/matrixP => i j; last by rewrite mxE B.
by rewrite A [RHS]mxE [X in _ = _ + X]mxE mul_mx_diag mxE mul_diag_mx !mxE.
Qed.
Lemma eq3_7_3_proved : eq3_7_3.
Proof.
move=> R [//|m] G c _ F; have [net MD con c0] := F; move=> u1.
have [_ _ [A B] S _] := chazelle_spectral.eq_3_7 net MD con c0.
have u1E i : u1 i 0 = chazelle_spectral.u1 c i by rewrite mxE pi_is.
split.
- apply/matrixP => i j; rewrite ord1 u1E -[RHS]A mxE; by apply: eq_bigr => k _; rewrite M_is u1E.
- by rewrite -[RHS]B; apply: eq_bigr => i _; rewrite u1E.
move=> u Mu uu.
have E i : step G c (fun j => Num.sqrt (c j) * u j 0) i = Num.sqrt (c i) * u i 0.
  rewrite -[RHS]mul1r; apply: (proj1 (S 1 (fun j => u j 0))) => k; rewrite mul1r.
  by have := congr1 (fun z : 'cV_m.+1 => z k 0) Mu; rewrite mxE M_is.
have C := chazelle_network.fixed_constant net MD con c0 E.
pose w := Num.sqrt (trace c)^-1; pose k := Num.sqrt (c ord0) * u ord0 0 / w.
have w0 : w != 0 by rewrite gt_eqF // sqrtr_gt0 invr_gt0 (trace_gt0 c0 ord0).
have uk : u = k *: u1.
  apply/matrixP => i j; rewrite ord1 mxE u1E; apply: (mulfI (half_neq0 F i)); rewrite (C i ord0) mulrCA.
  by rewrite [Num.sqrt (c i) * _]mulrC (chazelle_spectral.u1_root c0) -/w /k divfK.
clearbody k; have : k ^+ 2 = 1.
  rewrite -[RHS]uu uk -[LHS]mulr1 -B mulr_sumr; apply: eq_bigr => i _; by rewrite [in RHS]mxE u1E exprMn.
by rewrite uk => /eqP; rewrite sqrf_eq1 => /orP[]/eqP ->; [left; rewrite scale1r|right; rewrite scaleN1r].
Qed.
Lemma eq3_7_4_proved : eq3_7_4.
Proof.
move=> R n G c F; split=> [lam|].
  split=> -[u [u0 E]].
    exists (half_inv c *m u); split.
      by apply: contraNneq u0 => z; rewrite -[u]mul1mx -(halfK F) -mulmxA z mulmx0.
    by rewrite mulmxA (M_half_inv F) -mulmxA E -scalemxAr.
  exists (half c *m u); split.
    by apply: contraNneq u0 => z; rewrite -[u]mul1mx -(half_invK F) -mulmxA z mulmx0.
  by rewrite mulmxA -(M_half F) -mulmxA E -scalemxAr.
rewrite /char_poly; set X := char_poly_mx _.
have -> : char_poly_mx (M_of G c) = map_mx polyC (half_inv c) *m X *m map_mx polyC (half c).
  rewrite /X /char_poly_mx mulmxBr mulmxBl /M_of !map_mxM; congr (_ - _).
  by rewrite mul_mx_scalar -scalemxAl -map_mxM (half_invK F) map_mx1 scalemx1.
rewrite !det_mulmx mulrAC -det_mulmx -map_mxM (half_invK F) map_mx1 det1 mul1r //.
Qed.
Lemma eq3_8_2_proved : eq3_8_2.
Proof.
move=> R m G c lam u F [O E _] k.
have u0 : u k != 0 by apply/eqP => z; have /eqP := O k k; rewrite z mulmx0 mxE eqxx eq_sym oner_eq0.
have [_ sym] := eq3_7_1_proved F; split.
- by apply: contraNneq u0 => z; rewrite -[u k]mul1mx -(halfK F) -mulmxA z mulmx0.
- by apply: contraNneq u0 => z; rewrite -[u k]mul1mx -(half_invK F) -mulmxA z mulmx0.
- rewrite trmx_mul tr_diag_mx -/(half_inv c) -mulmxA -(M_half_inv F) mulmxA -[M_of G c]sym -trmx_mul E.
  by rewrite linearZ /= -scalemxAl.
- by rewrite mulmxA -(M_half F) -mulmxA E -scalemxAr.
Qed.
(* the first eigenvector may be taken as sqrt pi *)
Definition signed (R : rcfType) m (c : 'I_m.+1 -> R) (u : 'I_m.+1 -> 'cV[R]_m.+1) : 'M[R]_m.+1 :=
  \matrix_(i, k) if k == ord0 then chazelle_spectral.u1 c i else u k i 0.
Section Basis.
Variables (R : rcfType) (m : nat) (G : rel 'I_m.+1) (c lam : 'I_m.+1 -> R) (u : 'I_m.+1 -> 'cV[R]_m.+1).
Hypothesis F : fixed G c.
Hypothesis EB : eigenbasis G c lam u.
Let U := signed c u.
Lemma signedE : exists e : R, e ^+ 2 = 1 /\ forall i k, U i k = (if k == ord0 then e else 1) * u k i 0.
Proof.
have [O E L] := EB; have [] := eq3_7_3_proved (ltn0Sn m) F; set u1 := \col_i _ => _ _ uniq.
have [|//||h] := uniq (u ord0).
- by rewrite E L scale1r.
- transitivity (((u ord0)^T *m u ord0) 0 0); last by rewrite O eqxx.
  by rewrite mxE; apply: eq_bigr => i _; rewrite !mxE expr2.
- move=> h; exists 1; split=> [|i k]; first by rewrite expr1n.
  by rewrite mxE; case: eqP => [->|_]; rewrite mul1r // h mxE pi_is.
- exists (-1); split=> [|i k]; first by rewrite sqrrN expr1n.
  rewrite mxE; case: eqP => [->|_]; rewrite ?mul1r //.
  by rewrite h [in RHS]mxE mulN1r opprK mxE pi_is.
Qed.
Lemma signed_orth : U^T *m U = 1%:M.
Proof.
have [e [e2 UE]] := signedE; have [O _ _] := EB; apply/matrixP => k l.
transitivity ((if k == ord0 then e else 1) * (if l == ord0 then e else 1) * ((u k)^T *m u l) 0 0).
  by rewrite !mxE mulr_sumr; apply: eq_bigr => i _; rewrite [U^T _ _]mxE !UE [(u k)^T _ _]mxE mulrACA.
rewrite O !mxE; case: (eqVneq k l) => [->|_]; last by rewrite mulr0.
by rewrite mulr1; case: eqP => _; rewrite ?mulr1 // -expr2.
Qed.
Lemma signed_eig i k : \sum_j chazelle_spectral.M G c i j * U j k = lam k * U i k.
Proof.
have [e [e2 UE]] := signedE; have [_ E _] := EB.
have H := congr1 (fun z : 'cV_m.+1 => z i 0) (E k); rewrite !mxE in H.
rewrite UE mulrCA -H mulr_sumr; apply: eq_bigr => j _; by rewrite UE M_is mulrCA.
Qed.
Lemma signed_first i : U i 0 = chazelle_spectral.u1 c i. Proof. by rewrite mxE. Qed.
Lemma signed_lam : lam 0 = 1. Proof. by case: EB. Qed.
Lemma projection k i j : k != ord0 ->
  (half c *m u k *m (u k)^T *m half_inv c) i j = Num.sqrt (c i) * (U i k * U j k) / Num.sqrt (c j).
Proof.
move=> k0; have [e [e2 UE]] := signedE.
by rewrite mul_mx_diag mxE -mulmxA mul_diag_mx !mxE big_ord1 !mxE (negPf k0).
Qed.
Lemma small_lam k : k != ord0 -> `|lam k| < 1 /\ lam k != 1.
Proof.
move=> k0; have [net MD con c0] := F.
have l1 := chazelle_spectral.lam_neq1 net MD con c0 signed_orth signed_eig (signed_first) k0; split=> //.
have [_ _ _ _ D] := chazelle_spectral.eq_3_7 net MD con c0.
have [O E _] := EB; have [||h|] := D (lam k) (fun i => u k i 0).
- by move=> i; have := congr1 (fun z : 'cV_m.+1 => z i 0) (E k); rewrite M_is !mxE.
- apply: column_nonzero; apply/eqP => z; have /eqP := O k k; by rewrite z mulmx0 mxE eqxx eq_sym oner_eq0.
- by rewrite h eqxx in l1.
- by rewrite ltr_norml.
Qed.
End Basis.
Lemma eq3_8_1_proved : eq3_8_1.
Proof.
move=> R m G c lam u F EB s; have [net MD con c0] := F; apply/matrixP => i j.
rewrite (chazelle_spectral.eq_3_8 c0 (signed_orth F EB) (signed_eig F EB) (signed_first c u) (signed_lam EB)).
rewrite [RHS]mxE mxE big_ord1 mxE mul1r pi_is summxE; congr (_ + _); apply: eq_bigr => k k0.
by rewrite [RHS]mxE (projection F EB _ _ k0).
Qed.
Lemma first_projection (R : rcfType) m (G : rel 'I_m.+1) (c lam : 'I_m.+1 -> R) u : fixed G c -> eigenbasis G c lam u ->
  half c *m u ord0 *m (u ord0)^T *m half_inv c = const_mx 1 *m pi_of c.
Proof.
move=> F EB; have [e [e2 UE]] := signedE F EB; have [_ _ _ c0] := F; apply/matrixP => i j.
transitivity (stat c j); last by rewrite [RHS]mxE big_ord1 [const_mx _ _ _]mxE mul1r pi_is.
rewrite -(chazelle_spectral.first_term c0 (signed_first c u) i j) !UE eqxx.
by rewrite mulrACA -expr2 e2 mul1r mul_mx_diag mxE -mulmxA mul_diag_mx !mxE big_ord1 !mxE.
Qed.
Lemma eq3_16_proved : eq3_16.
Proof.
split=> [R m u O|R m d G c lam u v1 i F EB].
  pose U : 'M[R]_(m, m.+1) := \matrix_(i, k) u k i 0.
  have E : U^T *m U = 1%:M.
    apply/matrixP => k l; rewrite [RHS]mxE -(O k l) -1?ltnS ?ltn_ord // !mxE; apply: eq_bigr => i _; by rewrite !mxE.
  have : (\rank (U^T *m U) <= m)%N by apply: leq_trans (mxrankM_maxr _ _) (rank_leq_row _).
  by rewrite E mxrank1 ltnn.
have E : Phi c u v1 i ord0 = y_of c v1.
  rewrite /Phi (first_projection F EB) !mulmxA (_ : _ *m const_mx 1 = 1%:M) ?mul1mx //.
  by rewrite -rowE; apply/matrixP => a b; rewrite !ord1 !mxE.
split=> // y0 q; have [_ _ ->] := EB; rewrite subrr scale0r E => z; by rewrite -z eqxx in y0.
Qed.
(* ---- a flock among others ---- *)
Section Flock.
Variables (R : rcfType) (n m : nat) (f : 'I_m.+1 -> 'I_n) (G : rel 'I_n) (w : 'I_n -> R).
Hypothesis FL : is_flock f G.
Hypothesis net : network G.
Hypothesis MD : model_D G w.
Hypothesis w0 : forall k, 0 < w (f k).
Let H := own_network f G.
Let c k := w (f k).
Lemma own_degree k : degree H k = degree G (f k).
Proof.
have [fi _ cl] := FL; rewrite /degree -(card_image fi); apply: eq_card => j; rewrite inE; apply/imageP/idP.
  by case=> l; rewrite inE => h ->.
by move=> h; have [l fl] := cl _ _ h; exists l; rewrite // inE /H /own_network fl.
Qed.
Lemma own_fixed : fixed H c.
Proof.
have [sy ir] := net; have [_ con _] := FL; split=> //.
- by split=> [k l|k]; [apply: sy|apply: ir].
- by move=> k; rewrite own_degree; apply: MD.
Qed.
Lemma own_transition d (y : 'M[R]_(n, d)) : own_rows f (transition G w *m y) = transition H c *m own_rows f y.
Proof.
have [fi _ cl] := FL; have [_ ir] := net; apply/matrixP => k q; rewrite !mxE.
rewrite (bigID (fun j => j \in f @: setT)) /= [X in _ + X]big1 ?addr0; last first.
  move=> j jf; rewrite transitionE //; have fkj : (f k == j) = false.
    by apply: contraNF jf => /eqP <-; apply: imset_f; rewrite inE.
  rewrite fkj; case: ifP => Gj; last by rewrite mul0r.
  by have [l fl] := cl _ _ Gj; move: jf; rewrite -fl imset_f ?inE.
rewrite big_imset /=; last by move=> a b _ _; apply: fi.
apply: eq_big => [l|l _]; first by rewrite inE.
rewrite [own_rows f y l q]mxE !transitionE //; last by move=> a; apply: ir.
by rewrite (inj_eq fi) own_degree.
Qed.
End Flock.
Section Closed.
Variables (R : rcfType) (n d m : nat) (x v : nat -> 'M[R]_(n, d)) (G : nat -> rel 'I_n) (w : nat -> 'I_n -> R) (t1 : nat).
Variables (f : 'I_m.+1 -> 'I_n) (lam : 'I_m.+1 -> R) (u : 'I_m.+1 -> 'cV[R]_m.+1).
Hypothesis net1 : network (G t1).
Hypothesis MD1 : model_D (G t1) (w t1).
Hypothesis Hx : forall t, x t.+1 = x t + v t.+1.
Hypothesis Hv : forall t, (0 < t)%N -> v t.+1 = P_of G w t *m v t.
Hypothesis FL : is_flock f (G t1).
Hypothesis w0 : forall k, 0 < w t1 (f k).
Let c k := w t1 (f k).
Let H := own_network f (G t1).
Let v1 := own_rows f (v t1.+1).
Hypothesis EB : eigenbasis H c lam u.
Let P := transition H c.
Let vv s := mpow P (s - t1.+1) *m v1.
Let xx s := own_rows f (x t1) + (\sum_(r < s - t1) mpow P r) *m v1.
Let F : fixed H c.
Proof. exact: own_fixed. Qed.
Lemma xx_step t : (t1 <= t)%N -> xx t.+1 = xx t + vv t.+1.
Proof. by move=> tt; rewrite /xx /vv subSn // big_ord_recr /= mulmxDl addrA subSS. Qed.
Lemma vv_step t : (t1 < t)%N -> vv t.+1 = P *m vv t.
Proof. by move=> tt; rewrite /vv subSn // mulmxA. Qed.
Lemma xx_is t : (t1 <= t)%N -> unchanged G w t1 t -> own_rows f (x t) = xx t.
Proof.
have OD (a b : 'M[R]_(n, d)) : own_rows f (a + b) = own_rows f a + own_rows f b by apply/matrixP => i j; rewrite !mxE.
have W s : (forall r, (t1 <= r <= t1 + s)%N -> (forall i j, G r i j = G t1 i j) /\ forall i, w r i = w t1 i) ->
    own_rows f (v (t1 + s).+1) = mpow P s *m v1.
  elim: s => [|s IH] un; first by rewrite addn0 mul1mx.
  have pos : (0 < t1 + s.+1)%N by rewrite addnS.
  rewrite addnS Hv ?addnS // /P_of -addnS.
  have [eG ew] := un (t1 + s.+1)%N ltac:(by rewrite leq_addr leqnn).
  have -> : transition (G (t1 + s.+1)) (w (t1 + s.+1)%N) = transition (G t1) (w t1).
    apply/matrixP => i j; have [_ ir1] := net1; have ir : irreflexive (G (t1 + s.+1)%N) by move=> k; rewrite eG ir1.
    rewrite !transitionE // eG ew; congr (if _ then _ - _ * _%:R else _).
    by apply: eq_card => k; rewrite !inE eG.
  rewrite own_transition // addnS IH /= ?mulmxA // => r /andP[r1 r2]; apply: un.
  by rewrite r1 addnS (leq_trans r2).
move=> tt un; rewrite -(subnKC tt) in un *; elim: (t - t1)%N un => [|s IH] un.
  by rewrite addn0 /xx subnn big_ord0 mul0mx addr0.
rewrite addnS Hx OD xx_step ?leq_addr // IH; last by move=> r /andP[r1 r2]; apply: un; rewrite r1 addnS (ltn_trans r2).
congr (_ + _); rewrite /vv subSS addKn; apply: W => r /andP[r1 r2]; apply: un; by rewrite r1 addnS ltnS.
Qed.
Lemma drift_is q : chazelle_spectral.drift c vv t1 q = y_of c v1 0 q.
Proof.
rewrite /chazelle_spectral.drift [RHS]mxE; apply: eq_bigr => k _; by rewrite pi_is /vv subnn mul1mx.
Qed.
Lemma Phi_is i k q : k != ord0 -> chazelle_spectral.Phi c (signed c u) vv t1 i k q = Phi c u v1 i k 0 q.
Proof.
move=> k0; rewrite /Phi -rowE [RHS]mxE; apply: eq_bigr => j _; rewrite [row _ _ _ _]mxE (projection F EB) //.
by rewrite /vv subnn mul1mx.
Qed.
Lemma xi_row t i : (t1 <= t)%N -> unchanged G w t1 t -> row (f i) (x t) = row (f i) (x t1) + (t - t1)%:R *: y_of c v1
    + \sum_(k | k != ord0) ((1 - lam k ^+ (t - t1)) / (1 - lam k)) *: Phi c u v1 i k.
Proof.
move=> tt un; have [net MD con c0] := F; apply/matrixP => z q; rewrite (ord1 z).
have -> : row (f i) (x t) 0 q = xx t i q by rewrite -xx_is // !mxE.
rewrite -{1}(subnKC tt).
rewrite (chazelle_spectral.xi_closed net MD con c0 (signed_orth F EB) (signed_eig F EB) (signed_first c u) (signed_lam EB) xx_step vv_step).
rewrite drift_is [RHS]mxE [X in _ = X + _]mxE [X in _ = X + _ + _]mxE [X in _ = _ + X + _]mxE summxE; congr (_ + _ + _).
- by rewrite /xx subnn big_ord0 mul0mx addr0 mxE.
- by rewrite mulr_natl.
by apply: eq_bigr => k k0; rewrite [RHS]mxE Phi_is.
Qed.
Lemma Gamma_row t i : (t1 <= t)%N -> unchanged G w t1 t -> row (f i) (x t) = row (f i) (x t1) + row i (Gamma_of H c *m v1)
    + (t - t1)%:R *: y_of c v1 - \sum_(k | k != ord0) lam k ^+ (t - t1) *: ((1 - lam k)^-1 *: Phi c u v1 i k).
Proof.
move=> tt un; have [net MD con c0] := F; apply/matrixP => z q; rewrite (ord1 z).
have -> : row (f i) (x t) 0 q = xx t i q by rewrite -xx_is // !mxE.
rewrite -{1}(subnKC tt).
rewrite (chazelle_spectral.eq_3_16 net MD con c0 (signed_orth F EB) (signed_eig F EB) (signed_first c u) (signed_lam EB) xx_step vv_step).
rewrite drift_is Gamma_is (_ : vv t1.+1 = v1); last by rewrite /vv subnn mul1mx.
rewrite [RHS]mxE [X in _ = X + _]mxE [X in _ = X + _ + _]mxE [X in _ = _ + X + _]mxE [X in _ = X + _ + _ + _]mxE [X in _ = _ + _ + _ + X]mxE.
rewrite [X in _ = _ + X + _ + _]mxE summxE; congr (_ + _ + _ - _).
- by rewrite /xx subnn big_ord0 mul0mx addr0 mxE.
- by rewrite mulr_natl.
by apply: eq_bigr => k k0; rewrite [RHS]mxE [X in _ = _ * X]mxE Phi_is // [(1 - lam k)^-1 * _]mulrC.
Qed.
End Closed.
Lemma xi_closed_proved : xi_closed.
Proof.
move=> R n d m x v G w t1 t f lam u i [MD Hx Hv] /andP[t10 tt] un FL w0 c v1 EB; have [net1 MD1] := MD t1 t10.
exact: (xi_row net1 MD1 Hx Hv FL w0 EB).
Qed.
Lemma eigen_of_P (R : rcfType) m (G : rel 'I_m.+1) (c lam : 'I_m.+1 -> R) u k : fixed G c -> eigenbasis G c lam u ->
  is_eigenvalue (transition G c) (lam k).
Proof. by move=> F EB; have [_ A _ B] := eq3_8_2_proved F EB k; exists (half c *m u k). Qed.
Lemma eq3_17_proved : eq3_17.
Proof.
move=> R n d m m' x v G w t1 f g lam u lam' u' i j MO t10 FL FL' w0 w0' c c' Gf Gg v1 v1' B A EB EB'.
have [/(_ t1 t10)[net MD] Hx Hv] := MO.
have F : fixed Gf c by apply: own_fixed.
have F' : fixed Gg c' by apply: own_fixed.
pose T1 := [seq (lam k, (1 - lam k)^-1 *: Phi c u v1 i k) | k <- enum [pred k : 'I_m.+1 | k != ord0]].
pose T2 := [seq (lam' k, - ((1 - lam' k)^-1 *: Phi c' u' v1' j k)) | k <- enum [pred k : 'I_m'.+1 | k != ord0]].
pose falling := fun p q : R * 'rV[R]_d => q.1 <= p.1.
have tot : total falling by move=> p q; rewrite /falling; apply: le_total.
exists (sort falling (T1 ++ T2)); split; first exact: sort_sorted.
- move=> p; rewrite mem_sort mem_cat => /orP[]/mapP[k]; rewrite mem_enum inE => k0 -> /=.
    by split; [case: (small_lam F EB k0)|left; apply: eigen_of_P EB].
  by split; [case: (small_lam F' EB' k0)|right; apply: eigen_of_P EB'].
move=> t tt un; rewrite (Gamma_row net MD Hx Hv FL w0 EB i tt un) (Gamma_row net MD Hx Hv FL' w0' EB' j tt un).
have E1 : \sum_(p <- T1) p.1 ^+ (t - t1) *: p.2 = \sum_(k | k != ord0) lam k ^+ (t - t1) *: ((1 - lam k)^-1 *: Phi c u v1 i k).
  by rewrite big_map big_enum /=; apply: eq_bigl => k; rewrite inE.
have E2 : \sum_(p <- T2) p.1 ^+ (t - t1) *: p.2 = - \sum_(k | k != ord0) lam' k ^+ (t - t1) *: ((1 - lam' k)^-1 *: Phi c' u' v1' j k).
  rewrite big_map big_enum /= -sumrN; apply: eq_big => [k|k _]; [by rewrite inE|by rewrite scalerN].
rewrite (perm_big (T1 ++ T2)) ?perm_sort //= big_cat /= E1 E2 /A /B scalerBr -/c -/c' -/v1 -/v1' -/Gf -/Gg.
have Z (S S' a a' b b' r r' : 'rV[R]_d) : r + a + b - S - (r' + a' + b' - S') = r - r' + (a - a') + (b - b') - (S - S').
  by apply/matrixP => p q; rewrite !mxE; ring.
exact: Z.
Qed.
(* ---- stabilisers ---- *)
Section Stabilisers.
Variables (R : realFieldType) (n : nat) (P : nat -> 'M[R]_n).
Hypothesis SP : forall t, (0 < t)%N -> stochastic (P t).
Hypothesis dg : forall t i, (0 < t)%N -> 0 < P t i i.
Hypothesis sy : forall t i j, (0 < t)%N -> (P t i j != 0) = (P t j i != 0).
Variables (s : nat) (r : 'I_n) (T : nat -> nat) (V : nat -> {set 'I_n}).
Hypothesis s0 : (0 < s)%N.
Hypothesis ST : stabilisers P s r T V.
Let P' t := P t.-1.+1.
Lemma span_later a k : (0 < a)%N -> span P a k = span P' a k.
Proof. by move=> a0; apply: span_ext => t at_; rewrite /P' prednK // (leq_trans a0). Qed.
Lemma later_ge0 a k i j : (0 < a)%N -> 0 <= span P a k i j.
Proof. by move=> a0; rewrite span_later //; apply: span_ge0 => t p q; case: (SP (ltn0Sn t.-1)). Qed.
Lemma T_later k : (T k < T k.+1)%N. Proof. by case: ST => _ _ /(_ k)[[]]. Qed.
Lemma T_mono k l : (k <= l)%N -> (T k <= T l)%N.
Proof. by move=> kl; rewrite -(subnKC kl); elim: (l - k)%N => [|m IH]; rewrite ?addn0 // addnS (leq_trans IH) // ltnW // T_later. Qed.
Lemma diag_later a k i : (0 < a)%N -> 0 < span P a k i i.
Proof.
move=> a0; elim: k => [|k IH] /=; first by rewrite mxE eqxx ltr01.
have [P0 _] := SP (ltn_addr k a0).
apply: lt_le_trans (@mul_ge_term R n (P (a + k)%N) (span P a k) i i i P0 _); last by move=> p q; apply: later_ge0.
by rewrite mulr_gt0 // dg // ltn_addr.
Qed.
Lemma r_in k : r \in V k.
Proof.
have [_ V0 N] := ST; elim: k => [|k IH]; first by rewrite V0 inE.
by have [_ _ ->] := N k; rewrite inE IH /= lt0r_neq0 // diag_later.
Qed.
Lemma V_nested k : V k.+1 \subset V k.
Proof. by have [_ _ /(_ k)[_ _ ->]] := ST; apply/subsetP => i; rewrite inE => /andP[]. Qed.
(* a one of the column stays, and no other comes *)
Lemma column_is k t i : (T k.+1 <= t)%N -> i \in V k -> (pprod P t (T k).+1 i r != 0) = (i \in V k.+1).
Proof.
have [_ _ /(_ k)[[_ st] _ ->]] := ST; rewrite inE leq_eqVlt => /orP[/eqP <- ->//|tt iV].
by rewrite iV (st t i r tt iV) // r_in.
Qed.
Lemma cut_off k t i j : (T k < t)%N -> i \in V k -> j \notin V k -> P t i j = 0.
Proof.
elim: k i j => [|k IH] i j tt; first by have [_ -> _] := ST; rewrite !inE.
have t0 : (0 < t)%N by apply: leq_ltn_trans tt.
move=> iV jV; have iVk := subsetP (V_nested k) i iV; have tk := ltn_trans (T_later k) tt.
have [jVk|] := boolP (j \in V k); last exact: IH.
apply/eqP; rewrite -[_ == _]negbK sy //; apply: contra jV => pz.
have col u l : (T k.+1 <= u)%N -> l \in V k -> (pprod P u (T k).+1 l r != 0) = (l \in V k.+1) by apply: column_is.
rewrite -(col t j (ltnW tt) jVk); apply: lt0r_neq0.
have tE : t = t.-1.+1 by rewrite prednK.
have t1 : (T k.+1 <= t.-1)%N by rewrite -ltnS -tE.
have pos : 0 < pprod P t.-1 (T k).+1 i r.
  by rewrite lt_def later_ge0 // andbT (col _ _ t1 iVk).
have E : pprod P t (T k).+1 = P t *m pprod P t.-1 (T k).+1.
  by rewrite [in LHS]tE pprod_next ?prednK //; apply: leq_trans (T_later k) t1.
rewrite E.
have [P0 _] := SP t0.
apply: lt_le_trans (@mul_ge_term R n (P t) (pprod P t.-1 (T k).+1) j i r P0 _); last by move=> p q; apply: later_ge0.
by rewrite mulr_gt0 // lt_def pz P0.
Qed.
Lemma block_is k a u i j : (T k < a)%N -> i \in V k -> chazelle_stabilisers.block P' (V k) a u i j = span P a u i j.
Proof.
move=> ta; elim: u i => [|u IH] i iV /=; first by rewrite mxE.
have ta' : (T k < a + u)%N by rewrite ltn_addr.
rewrite mxE [RHS](bigID (fun l => l \in V k)) /= [X in _ = _ + X]big1 ?addr0 => [|l lV]; last by rewrite (cut_off ta') ?mul0r.
by apply: eq_bigr => l lV; rewrite IH // /P' prednK // (leq_ltn_trans _ ta').
Qed.
Lemma pprod_span k t : (T k < t)%N -> pprod P t (T k).+1 = span P (T k).+1 (t - T k).
Proof. by move=> tt; rewrite /pprod subnSK. Qed.
Lemma V_next k i : (i \in V k.+1) = (i \in V k) && (chazelle_stabilisers.block P' (V k) (T k).+1 (T k.+1 - T k) i r != 0).
Proof.
have [_ _ /(_ k)[_ _ ->]] := ST; rewrite inE; case iV: (i \in V k) => //=.
by rewrite block_is // -pprod_span // T_later.
Qed.
Lemma V_stable k t i : (T k.+1 <= t)%N -> i \in V k ->
  chazelle_stabilisers.block P' (V k) (T k).+1 (t - T k) i r != 0 -> i \in V k.+1.
Proof.
move=> tt iV; rewrite block_is // -pprod_span ?column_is //; exact: leq_trans (T_later k) tt.
Qed.
Lemma SP' t : stochastic (P' t). Proof. exact: SP. Qed.
Lemma dg' t i : 0 < P' t i i. Proof. exact: dg. Qed.
Lemma sy' t i j : (P' t i j != 0) = (P' t j i != 0). Proof. exact: sy. Qed.
Lemma V0' : V 0%N = setT. Proof. by case: ST. Qed.
Lemma T0' : (T 0%N).+1 = s. Proof. by case: ST. Qed.
End Stabilisers.
Section FromModel.
Variables (R : realFieldType) (n : nat) (G : nat -> rel 'I_n) (w : nat -> 'I_n -> R).
Hypothesis MD : in_model_D G w.
Lemma of_stochastic t : (0 < t)%N -> stochastic (P_of G w t).
Proof. by move=> t0; have [net D] := MD t0; case: (model_D_stochastic net D). Qed.
Lemma of_diag t i : (0 < t)%N -> 0 < P_of G w t i i.
Proof. by move=> t0; have [net D] := MD t0; case: (model_D_stochastic net D). Qed.
Lemma of_edge t i j : (0 < t)%N -> (P_of G w t i j != 0) = (i == j) || G t i j.
Proof. by move=> t0; have [net D] := MD t0; apply: transition_edge. Qed.
Lemma of_sym t i j : (0 < t)%N -> (P_of G w t i j != 0) = (P_of G w t j i != 0).
Proof. by move=> t0; rewrite !of_edge // eq_sym; have [[-> _] _] := MD t0. Qed.
End FromModel.
Lemma stab_123_proved : stab_123.
Proof.
move=> R n G w s r T V s0 MD ST; have SP := of_stochastic MD; have dg := of_diag MD; have sy := of_sym MD.
split=> [k|t i j tt iV jV|k i iV].
- exact: (V_nested ST).
- have t0 : (0 < t)%N by apply: leq_ltn_trans tt.
  have z : P_of G w t i j = 0 := cut_off SP dg sy ST tt iV jV.
  have z' : P_of G w t j i = 0 by apply/eqP; rewrite -[_ == _]negbK sy // z eqxx.
  have := of_edge MD i j t0; have := of_edge MD j i t0; rewrite z z' !eqxx /= => /esym/norP[_ a] /esym/norP[_ b].
  by split.
split; first exact: (r_in SP dg ST).
rewrite lt_def (later_ge0 SP) // andbT (column_is SP dg ST) //; exact: subsetP (V_nested ST k) _ iV.
Qed.
Lemma max_on_le (R : realFieldType) (I : finType) (Q : pred I) (F : I -> R) c : 0 <= c -> (forall i, Q i -> F i <= c) ->
  \big[Num.max/0]_(i | Q i) F i <= c.
Proof. by move=> c0 H; elim/big_rec: _ => // i y Qi yc; rewrite le_maxl H. Qed.
Lemma max_on_ub (R : realFieldType) (I : finType) (Q : pred I) (F : I -> R) i : Q i -> F i <= \big[Num.max/0]_(j | Q j) F j.
Proof.
move=> Qi; have : i \in index_enum I by rewrite mem_index_enum.
elim: (index_enum I) => [//|j l IH]; rewrite inE big_cons => /orP[/eqP <-|/IH h]; first by rewrite Qi le_maxr lexx.
by case: ifP => _ //; rewrite le_maxr h orbT.
Qed.
Lemma max_on_ge0 (R : realFieldType) (I : finType) (Q : pred I) (F : I -> R) : 0 <= \big[Num.max/0]_(j | Q j) F j.
Proof. by elim/big_rec: _ => // i y _ y0; rewrite le_maxr y0 orbT. Qed.
Lemma max_restrict (R : realFieldType) n (V : {set 'I_n}) (F : 'I_n -> 'I_n -> R) (H : 'I_#|V| -> 'I_#|V| -> R) :
  (forall i j, H i j = F (enum_val i) (enum_val j)) ->
  \big[Num.max/0]_(ij : 'I_n * 'I_n | (ij.1 \in V) && (ij.2 \in V)) F ij.1 ij.2 = \big[Num.max/0]_(ij : 'I_#|V| * 'I_#|V|) H ij.1 ij.2.
Proof.
move=> E; apply/eqP; rewrite eq_le; apply/andP; split.
  apply: max_on_le => [|[i j] /= /andP[iV jV]]; first exact: max_ge0.
  have := max_ub (fun ij : 'I_#|V| * 'I_#|V| => H ij.1 ij.2) (enum_rank_in iV i, enum_rank_in jV j).
  by rewrite /= E !enum_rankK_in.
apply: max_le => [|[i j] /=]; first exact: max_on_ge0.
rewrite E; apply: (max_on_ub (fun ij : 'I_n * 'I_n => F ij.1 ij.2) (i := (enum_val i, enum_val j))).
by rewrite /= !enum_valP.
Qed.
Lemma tau1_on_is (R : rcfType) n (V W : {set 'I_n}) (A : 'M[R]_n) (B : 'I_n -> 'I_n -> R) :
  (forall i j, i \in V -> j \in W -> A i j = B i j) -> tau1_on V W A = tau1 (chazelle_contraction.restrict V W B).
Proof.
move=> AB; apply: (@max_restrict R n V (fun i j => 2%:R^-1 * \sum_(k in W) `|A i k - A j k|) (dist1 (chazelle_contraction.restrict V W B))) => i j.
rewrite /dist1 chazelle_contraction.sum_enum; congr (_ * _); apply: eq_bigr => k _; by rewrite !mxE !AB ?enum_valP.
Qed.
Lemma tau2_on_is (R : rcfType) n (V W : {set 'I_n}) (A : 'M[R]_n) (B : 'I_n -> 'I_n -> R) :
  (forall i j, i \in V -> j \in W -> A i j = B i j) -> tau2_on V W A = tau2 (chazelle_contraction.restrict V W B).
Proof.
move=> AB; pose X := chazelle_contraction.restrict V W B.
apply: (@max_restrict R n V (fun i j => Num.sqrt (\sum_(k in W) (A i k - A j k) ^+ 2)) (fun i j => norm2 (row i X - row j X))) => i j.
rewrite /norm2 chazelle_contraction.sum_enum; congr Num.sqrt; apply: eq_bigr => k _; by rewrite !mxE !AB ?enum_valP.
Qed.
Section Contraction.
Variables (R : rcfType) (n : nat) (G : nat -> rel 'I_n) (w : nat -> 'I_n -> R) (s : nat) (r : 'I_n).
Variables (T : nat -> nat) (V : nat -> {set 'I_n}) (k t : nat).
Hypothesis s0 : (0 < s)%N.
Hypothesis MD : in_model_D G w.
Hypothesis ST : stabilisers (P_of G w) s r T V.
Hypothesis tt : (T k < t)%N.
Let P := P_of G w.
Let P' u := P u.-1.+1.
Let SP := of_stochastic MD.
Let dg := of_diag MD.
Let sy := of_sym MD.
Let a1 : forall u, stochastic (P' u) := SP' SP.
Let a2 : forall u i, 0 < P' u i i := dg' dg.
Let a3 : forall u i j, (P' u i j != 0) = (P' u j i != 0) := sy' sy.
Let a4 := V0' ST.
Let a5 := T_later ST.
Let a6 := V_next SP dg sy ST.
Let a7 := V_stable SP dg sy ST.
Lemma right_is : right_side P T V k t = Num.sqrt 2%:R * (tau1 (chazelle_contraction.last_factor P' T V k (t - T k)) *
  \prod_(i < k) tau1 (chazelle_contraction.factor P' T V i)).
Proof.
rewrite /right_side -mulrA; congr (_ * (_ * _)).
  apply: tau1_on_is => i j iV _; by rewrite (block_is SP dg sy ST) // (pprod_span P tt).
apply: eq_bigr => i _; apply: tau1_on_is => p q pV _.
by rewrite (block_is SP dg sy ST) // ?(pprod_span P (a5 i)) // (subsetP (V_nested ST i)).
Qed.
Lemma left_is : tau2_on (V k) (V 0%N) (pprod P t s) = tau2 (chazelle_contraction.whole P' T V k (t - T k)).
Proof.
rewrite a4; apply: tau2_on_is => i j _ _; have T0 : (T 0%N <= T k)%N by apply: (T_mono ST).
rewrite -(T0' ST) (pprod_span P (leq_ltn_trans T0 tt)) (span_later P) //; congr (span _ _ _ _ _); lia.
Qed.
Lemma contraction_1 : tau2_on (V k) (V 0%N) (pprod P t s) <= right_side P T V k t.
Proof.
rewrite left_is right_is (chazelle_contraction.whole_split a1 a2 a3 a4 a5 a6 a7).
have SL := chazelle_contraction.last_stochastic a1 a2 a3 a4 a5 a6 a7 k (t - T k).
have S := chazelle_contraction.tower_stochastic a1 a2 a3 a4 a5 a6 a7 k.
apply: le_trans (lemma_2_4 SL S) _; rewrite [X in _ <= X]mulrCA; apply: ler_wpmul2l; first exact: tau1_ge0.
have [h1 h2] := tau2_le_tau1 S; apply: le_trans (le_trans h1 h2) _; apply: ler_wpmul2l; first exact: sqrtr_ge0.
exact: (chazelle_contraction.tower_tau1 a1 a2 a3 a4 a5 a6 a7).
Qed.
Lemma contraction_2 (alpha : R) : 0 < alpha -> (forall u i j, (0 < u)%N -> 0 < P u i j -> alpha <= P u i j) ->
  right_side P T V k t <= Num.sqrt 2%:R * (1 - alpha ^+ n.-1) ^+ k.
Proof.
move=> al fl; rewrite right_is; apply: ler_wpmul2l; first exact: sqrtr_ge0.
apply: (chazelle_contraction.contraction_product a1 a2 a3 a4 a5 a6 a7 al) => u i j h.
by apply: fl => //; apply: nonneg_entries h; apply: SP.
Qed.
End Contraction.
Lemma eq3_6_1_proved : eq3_6_1.
Proof. move=> R n G w s r T V k t s0 MD ST tt; exact: (contraction_1 s0 MD ST tt). Qed.
Lemma eq3_6_2_proved : eq3_6_2.
Proof.
move=> a; exists a => R E n nu G w s r T V k t HE n1 nnu s0 MD fl ST tt.
have N1 : 1 <= (nu%:R : R) by rewrite ler1n; apply: leq_trans nnu; apply: ltnW.
have N0 : 0 < (nu%:R : R) by apply: lt_le_trans N1.
have al : 0 < (nu%:R ^+ a)^-1 :> R by rewrite invr_gt0 exprn_gt0.
apply: (le_trans (contraction_2 MD ST tt al fl)); apply: ler_wpmul2l; first exact: sqrtr_ge0.
have a1 : (nu%:R ^+ a)^-1 <= 1 :> R by rewrite invf_le1 ?exprn_ege1 // exprn_gt0.
have x1 : (nu%:R ^+ (a * nu ^ 2))^-1 <= 1 :> R by rewrite invf_le1 ?exprn_ege1 // exprn_gt0.
apply: le_trans (power_E HE k x1); apply: ler_expn2r; rewrite ?nnegrE ?subr_ge0 ?exprn_ile1 // ?(ltW al) //.
rewrite ler_add2l ler_opp2 exprVn -exprM lef_pinv ?posrE ?exprn_gt0 // ler_weexpn2l // leq_mul2l; apply/orP; right.
apply: leq_trans (leq_pred n) _; apply: (leq_trans nnu); rewrite expnS expn1 leq_pmulr //; apply: leq_trans nnu; exact: ltnW.
Qed.
(* ---- small matrices, entry by entry ---- *)
Lemma degree_count n (G : rel 'I_n) i : degree G i = (\sum_j G i j)%N.
Proof. by rewrite /degree -sum1_card big_mkcond; apply: eq_bigr => j _; rewrite inE; case: (G i j). Qed.
Definition near3 : rel 'I_3 := fun i j => (i + j == 1)%N.
Definition path3 : rel 'I_3 := fun i j => (i.+1 == j)%N || (j.+1 == i)%N.
Lemma path_network n : network (fun i j : 'I_n => (i.+1 == j)%N || (j.+1 == i)%N).
Proof. by split=> [i j|i]; [rewrite orbC|rewrite orbb; apply/eqP => e; have := ltnSn i; rewrite {2}e ltnn]. Qed.
Lemma near3_network : network near3.
Proof. by split=> [i j|i]; rewrite /near3 1?addnC //; case: i => [[|[|[|?]]] ?]. Qed.
Section AB.
Variable R : realFieldType.
Lemma AB_A : exists (G : rel 'I_3) (c : 'I_3 -> R),
  [/\ network G, forall i, (0 < degree G i)%N -> c i * (degree G i)%:R = 1 & exAB_A R = transition G c].
Proof.
exists near3, (fun=> 1); split; first exact: near3_network.
  by move=> i; rewrite degree_count !big_ord_recl big_ord0; case: i => [[|[|[|?]]] ?] //=; rewrite mulr1.
have [_ ir] := near3_network; apply/matrixP => i j; rewrite transitionE // degree_count !big_ord_recl big_ord0 mxE.
by case: i => [[|[|[|?]]] ?] //; case: j => [[|[|[|?]]] ?] //=; rewrite ?mulr1 ?mulr0 ?subrr ?subr0.
Qed.
Lemma AB_B : exists (G : rel 'I_3) (c : 'I_3 -> R),
  [/\ network G, forall i, (0 < degree G i)%N -> c i * (degree G i)%:R = 1 & exAB_B R = transition G c].
Proof.
exists path3, (fun i => if i == 1%N :> nat then 2%:R^-1 else 1); split; first exact: path_network.
  move=> i; rewrite degree_count !big_ord_recl big_ord0; case: i => [[|[|[|?]]] ?] //= _; rewrite ?mulr1 //.
  by rewrite mulVf ?pnatr_eq0.
have [_ ir] := path_network 3; apply/matrixP => i j; rewrite transitionE // degree_count !big_ord_recl big_ord0 !mxE.
by case: i => [[|[|[|?]]] ?] //; case: j => [[|[|[|?]]] ?] //=; field.
Qed.
Lemma AB_product k : let P t := if odd t then exAB_B R else exAB_A R in span P 1 (2 * k) = mpow (exAB_A R *m exAB_B R) k.
Proof.
move=> P; elim: k => [//|k IH]; rewrite mulnS /= IH mulmxA; congr (_ *m _ *m _).
  by rewrite /P /= mul2n odd_double.
by rewrite /P /= mul2n odd_double.
Qed.
Definition AB_table (q : R) := rows_of 3 [:: [:: q; 1 - 2%:R * q; q]; [:: 0; 1; 0]; [:: 0; 1; 0]] : 'M[R]_3.
Lemma AB_step q : exAB_A R *m exAB_B R *m AB_table q = AB_table (2%:R^-1 * q).
Proof.
rewrite -mulmxA; apply/matrixP => i j; rewrite mxE !big_ord_recl big_ord0 !mxE !big_ord_recl !big_ord0 !mxE.
by case: i => [[|[|[|?]]] ?] //; case: j => [[|[|[|?]]] ?] //=; field.
Qed.
Lemma AB_closed k : mpow (exAB_A R *m exAB_B R) k.+1 = AB_table (2%:R ^+ k.+1)^-1.
Proof.
elim: k => [|k IH]; last first.
  have -> : forall A : 'M[R]_3, mpow A k.+2 = A *m mpow A k.+1 by [].
  by rewrite IH AB_step [in RHS]exprS invfM.
rewrite /= mulmx1; apply/matrixP => i j; rewrite mxE !big_ord_recl big_ord0 !mxE expr1.
by case: i => [[|[|[|?]]] ?] //; case: j => [[|[|[|?]]] ?] //=; field.
Qed.
End AB.
Lemma exAB_proved : exAB.
Proof.
move=> R; split=> [A [->|->]|k k0 P]; [exact: AB_A|exact: AB_B|].
have E : pprod P (2 * k) 1 = mpow (exAB_A R *m exAB_B R) k.
  by rewrite /pprod subn1 prednK ?muln_gt0 // AB_product.
rewrite E; split=> //; case: k k0 {E} => // k _; exact: AB_closed.
Qed.
(* ---- the four birds ---- *)
Definition path4 : rel 'I_4 := fun i j => (i.+1 == j)%N || (j.+1 == i)%N.
Lemma path4_network : network path4.
Proof. by split=> [i j|i]; rewrite /path4 1?orbC // orbb; apply/eqP => e; have := ltnSn i; rewrite {2}e ltnn. Qed.
Definition pairs4 : rel 'I_4 := fun i j => path4 i j && ((i < 2) == (j < 2))%N.
Lemma pairs4_network : network pairs4.
Proof. by have [sy ir] : network path4 := path4_network; split=> [i j|i]; rewrite /pairs4 ?ir // sy eq_sym. Qed.
Section Four.
Variable R : realFieldType.
Lemma path4_matrix : transition path4 (lazy R path4) = ex4_path R.
Proof.
have [_ ir] : network path4 := path4_network; apply/matrixP => i j; rewrite transitionE // /lazy degree_count !big_ord_recl big_ord0 !mxE.
by case: i => [[|[|[|[|?]]]] ?] //; case: j => [[|[|[|[|?]]]] ?] //=; field.
Qed.
Lemma pairs4_matrix : transition pairs4 (lazy R pairs4) = ex4_two R.
Proof.
have [_ ir] := pairs4_network; apply/matrixP => i j; rewrite transitionE // /lazy degree_count !big_ord_recl big_ord0 !mxE.
by case: i => [[|[|[|[|?]]]] ?] //; case: j => [[|[|[|[|?]]]] ?] //=; field.
Qed.
Definition four t := if odd t then pairs4 else path4.
Lemma four_matrix t : transition (four t) (lazy R (four t)) = if odd t then ex4_two R else ex4_path R.
Proof. by rewrite /four; case: (odd t); [apply: pairs4_matrix|apply: path4_matrix]. Qed.
Let g t : R := (- 3%:R^-1) ^+ t.
Let X t : 'cV[R]_4 := ex4_x0 R + (3%:R / 4%:R * (1 - g t)) *: ex4_v1 R.
Lemma g_sign t : if odd t then (-1 <= 3%:R * g t) && (g t < 0) else (0 < g t) && (g t <= 1).
Proof.
have i3 : 0 < (3%:R^-1 : R) by rewrite invr_gt0 ltr0n.
have i31 : (3%:R^-1 : R) <= 1 by rewrite invf_le1 ?ltr0n ?ler1n.
elim: t => [|t] /=; first by rewrite /g expr0 ltr01 lexx.
have -> : g t.+1 = - (3%:R^-1 * g t) by rewrite /g exprS mulNr.
case: (odd t) => /= /andP[a b].
  rewrite oppr_gt0 pmulr_rlt0 // b /= ler_oppl -(ler_pmul2l (ltr0Sn R 2)) mulrA mulfV ?pnatr_eq0 // mul1r.
  apply: (@le_trans _ _ (-1)); first by rewrite mulrN1 ler_opp2 ler1n.
  apply: (le_trans a); rewrite -subr_le0 (_ : _ - _ = 2%:R * g t); last by ring.
  by rewrite pmulr_rle0 ?ltr0n // ltW.
by rewrite oppr_lt0 mulr_gt0 // andbT mulrN mulrA mulfV ?pnatr_eq0 // mul1r ler_opp2.
Qed.
Let a4 : 'cV[R]_4 := col_of 4 [:: 0; 8%:R; 21%:R; 29%:R].
Let s4 : 'cV[R]_4 := col_of 4 [:: 1; -1; 1; -1].
Lemma X_gap t i j : X t i 0 - X t j 0 = (a4 i 0 - a4 j 0 + 3%:R / 2%:R * (1 - g t) * (s4 i 0 - s4 j 0)) / 16%:R.
Proof.
have E k : X t k 0 = 16%:R^-1 * a4 k 0 + 3%:R / 4%:R * (1 - g t) * (8%:R^-1 * s4 k 0) by rewrite !mxE.
by rewrite !E; field.
Qed.
Lemma near_16 (z y : R) : y = z -> (`|y / 16%:R| <= 1) = (- 16%:R <= z <= 16%:R).
Proof. by move=> ->; rewrite normrM [ `|16%:R^-1|]gtr0_norm ?invr_gt0 ?ltr0n // ler_pdivr_mulr ?ltr0n // mul1r ler_norml. Qed.
Lemma X_near t i j : (i != j) && (`|X t i 0 - X t j 0| <= 1) = four t i j.
Proof.
have S : forall a b : 'I_4, (a < b)%N -> (`|X t a 0 - X t b 0| <= 1) = four t a b.
  have H := g_sign t; rewrite /four; have Q : -1 <= 3%:R * g t <= 3%:R.
    case: (odd t) H => /andP[a b]; first by rewrite a /= (@le_trans _ _ 0) ?ler0n // pmulr_rle0 ?ltr0n // ltW.
    by rewrite -[X in _ && (_ <= X)]mulr1 ler_pmul2l ?ltr0n // b andbT (@le_trans _ _ 0) ?lerN10 // mulr_ge0 ?ler0n // ltW.
  have sub a b : (a <= b :> R) = (0 <= b - a) by rewrite subr_ge0.
  have /andP[q1 q2] := Q; rewrite sub in q1; rewrite sub in q2.
  move=> a b; rewrite X_gap !mxE; case: a => [[|[|[|[|?]]]] ?] //; case: b => [[|[|[|[|?]]]] ?] //= _.
  - rewrite (@near_16 (- (5%:R + 3%:R * g t))); last by field.
    transitivity true; last by case: (odd t).
    rewrite ler_opp2; apply/andP; split; rewrite sub.
      rewrite (_ : _ - _ = 3%:R - 3%:R * g t + 8%:R); [by apply: addr_ge0; rewrite ?ler0n|by ring].
    rewrite (_ : _ - _ = 3%:R * g t - -1 + 20%:R); [by apply: addr_ge0; rewrite ?ler0n|by ring].
  - rewrite (@near_16 (- 21%:R)); last by field.
    transitivity false; last by case: (odd t).
    by rewrite ler_opp2 ler_nat.
  - rewrite (@near_16 (- (26%:R + 3%:R * g t))); last by field.
    transitivity false; last by case: (odd t).
    rewrite ler_opp2; apply/negbTE; rewrite negb_and -!ltNge; apply/orP; left.
    rewrite -subr_gt0 (_ : _ - _ = 3%:R * g t - -1 + 9%:R); [by apply: ltr_paddl; rewrite ?ltr0n|by ring].
  - rewrite (@near_16 (- (16%:R - 3%:R * g t))); last by field.
    rewrite ler_opp2; have -> : - (16%:R - 3%:R * g t) <= 16%:R.
      rewrite sub [X in 0 <= X](_ : _ = 3%:R - 3%:R * g t + 29%:R); [by apply: addr_ge0; rewrite ?ler0n|by ring].
    rewrite andbT ger_addl oppr_le0 pmulr_rge0 ?ltr0n //.
    case: (odd t) H => /andP[u v]; [by rewrite leNgt v|by rewrite ltW].
  - rewrite (@near_16 (- 21%:R)); last by field.
    transitivity false; last by case: (odd t).
    by rewrite ler_opp2 ler_nat.
  - rewrite (@near_16 (- (5%:R + 3%:R * g t))); last by field.
    transitivity true; last by case: (odd t).
    rewrite ler_opp2; apply/andP; split; rewrite sub.
      rewrite (_ : _ - _ = 3%:R - 3%:R * g t + 8%:R); [by apply: addr_ge0; rewrite ?ler0n|by ring].
    rewrite (_ : _ - _ = 3%:R * g t - -1 + 20%:R); [by apply: addr_ge0; rewrite ?ler0n|by ring].
have [sy ir] : network (four t) by rewrite /four; case: (odd t); [apply: pairs4_network|apply: path4_network].
case: (ltngtP i j) => [h|h|/val_inj ->]; last by rewrite eqxx ir.
  by rewrite -val_eqE ltn_eqF //= S.
by rewrite -val_eqE gtn_eqF //= distrC S // sy.
Qed.
Lemma transition_ext (G H : rel 'I_4) : (forall i j, G i j = H i j) -> transition G (lazy R G) = transition H (lazy R H).
Proof.
move=> E; have D i : degree G i = degree H i by apply: eq_card => j; rewrite !inE E.
have L : laplacian R G = laplacian R H by apply/matrixP => i j; rewrite !mxE D E.
have C : \row_i lazy R G i = \row_i lazy R H i by apply/matrixP => i j; rewrite !mxE /lazy D.
by rewrite /transition L C.
Qed.
Lemma X_step t : X t.+1 = X t + g t *: ex4_v1 R.
Proof.
rewrite /X -addrA -scalerDl (_ : g t.+1 = - 3%:R^-1 * g t) /g ?exprS //.
by rewrite (_ : 3%:R / 4%:R * (1 - - 3%:R^-1 * _) = 3%:R / 4%:R * (1 - (- 3%:R^-1) ^+ t) + (- 3%:R^-1) ^+ t) //; field.
Qed.
Lemma four_eigen t : transition (four t) (lazy R (four t)) *m ex4_v1 R = (- 3%:R^-1) *: ex4_v1 R.
Proof. by rewrite four_matrix; have [_ a b] := ex4_eig_proved R; case: (odd t). Qed.
Lemma four_flight (x v : nat -> 'cV[R]_4) G : ex4 x v G -> forall t,
  [/\ x t = X t, v t.+1 = g t *: ex4_v1 R & forall i j, G t i j = four t i j].
Proof.
move=> [x0 v1 HG Hx Hv] t; elim: t => [|t [IHx IHv _]].
  have E : x 0%N = X 0%N by rewrite x0 /X /g expr0 subrr mulr0 scale0r addr0.
  by split; rewrite ?v1 /g ?expr0 ?scale1r // => i j; rewrite HG E X_near.
have E : x t.+1 = X t.+1 by rewrite Hx IHx IHv X_step.
have N i j : G t.+1 i j = four t.+1 i j by rewrite HG E X_near.
split=> //; rewrite Hv // (transition_ext N) IHv -scalemxAr four_eigen scalerA; congr (_ *: _).
by rewrite /g exprSr.
Qed.
Lemma four_exists : exists (x v : nat -> 'cV[R]_4) G, ex4 x v G.
Proof.
exists X, (fun t => g t.-1 *: ex4_v1 R), four; split.
- by rewrite /X /g expr0 subrr mulr0 scale0r addr0.
- by rewrite /g expr0 scale1r.
- by move=> t i j; rewrite X_near.
- exact: X_step.
- by move=> [//|t] _ /=; rewrite -scalemxAr four_eigen [RHS]scalerA /g exprSr.
Qed.
End Four.
Lemma ex4_motion_proved : ex4_motion.
Proof.
move=> R x v G H; have F := four_flight H; split=> [t|t t0 gap]; first by case: (F t).
have [xt _ _] := F t; pose g : R := (- 3%:R^-1) ^+ t.-1; rewrite -/g.
have gt : (- 3%:R^-1 : R) ^+ t = - 3%:R^-1 * g by rewrite -[in LHS](prednK t0) exprS.
have e (k : nat) (k4 : (k < 4)%N) : inord k = Ordinal k4 by apply: val_inj; rewrite /= inordK.
have g0 : gap 0%N = 16%:R^-1 * (5%:R - g) by rewrite /gap (e 1%N isT) (e 0%N isT) xt gt !mxE /=; field.
have g1 : gap 1%N = 1 + 16%:R^-1 * g by rewrite /gap (e 2%N isT) (e 1%N isT) xt gt !mxE /=; field.
have g2 : gap 2%N = 16%:R^-1 * (5%:R - g) by rewrite /gap (e 3%N isT) (e 2%N isT) xt gt !mxE /=; field.
have B : 4%:R^-1 <= 16%:R^-1 * (5%:R - g) <= 2%:R^-1.
  have S := g_sign R t.-1; have [a b] : g <= 1 /\ -1 <= 3%:R * g.
    case: (odd _) S => /andP[p q]; [split=> //; apply/ltW/(lt_trans q); exact: ltr01|split=> //].
    by rewrite (@le_trans _ _ 0) ?lerN10 // mulr_ge0 ?ler0n // ltW.
  apply/andP; split; rewrite -subr_ge0.
    rewrite [X in 0 <= X](_ : _ = (1 - g) / 16%:R); [by rewrite divr_ge0 ?ler0n ?subr_ge0|by field].
  rewrite [X in 0 <= X](_ : _ = (3%:R * g - -1 + 8%:R) / 48%:R); last by field.
  by rewrite divr_ge0 ?ler0n // addr_ge0 ?ler0n // subr_ge0.
by rewrite g0 g1 g2.
Qed.
Lemma path4_components : n_comp path4 predT = 1%N.
Proof.
have [sy _] : network path4 := path4_network; have cs : connect_sym path4 := sym_connect_sym sy.
transitivity (n_comp path4 (connect path4 (ord0 : 'I_4))); last exact: n_comp_connect.
apply: eq_n_comp_r => i; rewrite inE; apply/esym.
have step (a b : 'I_4) : path4 a b -> connect path4 a b by apply: connect1.
pose o k (h : (k < 4)%N) := Ordinal h.
have a : connect path4 ord0 (o 1%N isT) by apply: step.
have b : connect path4 ord0 (o 2%N isT) by apply: connect_trans a (step _ _ _).
have c : connect path4 ord0 (o 3%N isT) by apply: connect_trans b (step _ _ _).
have K (j : 'I_4) : connect path4 ord0 j; last exact: K.
case: j => [[|[|[|[|//]]]] h].
- by rewrite (_ : Ordinal h = ord0) ?connect0 //; apply: val_inj.
- by rewrite (_ : Ordinal h = o 1%N isT) //; apply: val_inj.
- by rewrite (_ : Ordinal h = o 2%N isT) //; apply: val_inj.
by rewrite (_ : Ordinal h = o 3%N isT) //; apply: val_inj.
Qed.
Lemma pairs4_components : n_comp pairs4 predT = 2%N.
Proof.
have [sy _] := pairs4_network; have cs : connect_sym pairs4 := sym_connect_sym sy.
have cl : closed pairs4 [pred i : 'I_4 | (i < 2)%N] by move=> a b /andP[_ /eqP h]; rewrite !inE.
pose o k (h : (k < 4)%N) := Ordinal h.
have C0 i : connect pairs4 ord0 i = (i < 2)%N.
  apply/idP/idP => [/(closed_connect cl)|]; first by rewrite !inE => <-.
  case: i => [[|[|//]] h] _.
    by rewrite (_ : Ordinal h = ord0) ?connect0 //; apply: val_inj.
  by rewrite (_ : Ordinal h = o 1%N isT); [apply: connect1|apply: val_inj].
have C2 i : connect pairs4 (o 2%N isT) i = ~~ (i < 2)%N.
  apply/idP/idP => [/(closed_connect cl)|]; first by rewrite !inE => <-.
  case: i => [[|[|[|[|//]]]] h] // _.
    by rewrite (_ : Ordinal h = o 2%N isT) ?connect0 //; apply: val_inj.
  by rewrite (_ : Ordinal h = o 3%N isT); [apply: connect1|apply: val_inj].
rewrite (n_compC (connect pairs4 ord0)) n_comp_connect // (_ : n_comp _ [predC _] = n_comp pairs4 (connect pairs4 (o 2%N isT))).
  by rewrite n_comp_connect.
by apply: eq_n_comp_r => i; rewrite !inE C0 C2.
Qed.
Lemma ex4_alt_proved : ex4_alt.
Proof.
move=> R; split; first exact: four_exists.
move=> x v G H t; have F := four_flight H.
have N u : n_comp (G u) predT = if odd u then 2%N else 1%N.
  have [_ _ E] := F u; rewrite (eq_n_comp (e' := four u)); last by apply: eq_connect.
  by rewrite /four; case: (odd u); [apply: pairs4_components|apply: path4_components].
have [_ _ E] := F t; rewrite !N (transition_ext R E) four_matrix /=; case: (odd t) => /=; split=> //; by [right|left].
Qed.
(* ---- flocks on the line ---- *)
Lemma norm2_line (R : rcfType) n (y : 'cV[R]_n) i j : norm2 (row i y - row j y) = `|y i 0 - y j 0|.
Proof. by rewrite /norm2 big_ord_recl big_ord0 addr0 !mxE sqrtr_sqr; congr `|y i _ - y j _|; apply: ord1. Qed.
Lemma norm2_speed (R : rcfType) n (y : 'cV[R]_n) i : norm2 (row i y) = `|y i 0|.
Proof. by rewrite /norm2 big_ord_recl big_ord0 addr0 !mxE sqrtr_sqr; congr `|y i _|; apply: ord1. Qed.
(* the three birds of chazelle_count: the second and the third part at t = 2 *)
Section Parting.
Variable R : rcfType.
Let x := @chazelle_count.xs R.
Let v := @chazelle_count.vs R.
Let G := chazelle_count.Gs.
Let w := @chazelle_count.cs R.
Let P := P_of G w.
Lemma parting_entries t i j : 0 < transition (G t) (w t) i j -> (3%:R ^+ 2)^-1 <= transition (G t) (w t) i j.
Proof.
have [_ ir] := chazelle_count.Gs_network t; rewrite transitionE //.
have L : (3%:R ^+ 2)^-1 <= 4%:R^-1 :> R by rewrite lef_pinv ?posrE ?exprn_gt0 ?ltr0n // -natrX ler_nat.
have q1 : (4%:R^-1 : R) <= 1 by rewrite invf_le1 ?ltr0n ?ler1n.
case: (i == j); last by case: ifP => [_ _|_]; rewrite ?ltxx // /w /chazelle_count.cs.
move=> _; rewrite chazelle_count.degreeE /w /chazelle_count.cs; case: (_ && _); last by rewrite mulr0 subr0 (le_trans L).
rewrite mulr1 (_ : 1 - 4%:R^-1 = 3%:R / 4%:R); last by field.
by apply: (le_trans L); rewrite ler_pmull ?invr_gt0 ?ltr0n // ler1n.
Qed.
Lemma parting_flock : flock_D 2 2 x v G w.
Proof.
have e1 : 0 < ((3%:R ^+ (3 ^ 4))^-1 : R) <= 1 by rewrite invr_gt0 exprn_gt0 ?ltr0n // invf_le1 ?exprn_ege1 ?exprn_gt0 ?ltr0n ?ler1n.
have [A B C D E] := chazelle_count.is_flock e1; split=> [i j|t i j|//|t t0].
- rewrite norm2_line; exact: A.
- rewrite !norm2_line; exact: B.
split=> //; [exact: E|exact: parting_entries|].
move=> i; rewrite norm2_speed mxE normrM normr_nat [ `|2%:R^-1|]ger0_norm ?invr_ge0 ?ler0n // ler_pdivr_mulr ?ltr0n //.
rewrite -natrX -natrM ler_nat; case: t t0 => [//|[|t]] _; by case: i => [[|[|[|?]]] ?].
Qed.
Lemma parting_rational : rational_flock 2 3 2 x v G w.
Proof.
split; first exact: parting_flock.
- exists (fun (i : 'I_3) (_ : 'I_1) => (nth 0%N [:: 0; 22; 20]%N (i : nat))%:Z), (fun _ _ => 2%N) => i k; rewrite mxE; split=> //.
  by case: i => [[|[|[|?]]] ?].
- exists (fun (i : 'I_3) (_ : 'I_1) => (nth 0%N [:: 0; 6; 10]%N (i : nat))%:Z), (fun _ _ => 2%N) => i k; rewrite mxE; split=> //.
  by case: i => [[|[|[|?]]] ?].
- by move=> t _; exists (fun _ => 1%N), (fun _ => 4%N) => i; split=> //; rewrite /w /chazelle_count.cs div1r.
by [].
Qed.
Lemma parting_still t : (1 < t)%N -> P t = 1%:M.
Proof.
move=> t1; have [_ ir] := chazelle_count.Gs_network t; apply/matrixP=> i j; rewrite /P /P_of transitionE //.
by rewrite chazelle_count.degreeE /G chazelle_count.GsE ltnNge t1 /= mulr0 subr0 mxE; case: eqP.
Qed.
Lemma parting_product a k : (1 < a)%N -> span P a k = 1%:M.
Proof. by move=> a1; elim: k => [//|k IH] /=; rewrite IH parting_still ?mul1mx // ltn_addr. Qed.
Let V k : {set 'I_3} := if k is 0%N then setT else [set ord0].
Lemma parting_stabilisers : stabilisers P 1 ord0 id V.
Proof.
split=> // k; split.
- split=> // t i j kt iV jV; congr (_ != 0); case: k kt iV jV => [|k] kt iV jV.
    rewrite pprod_self /pprod subn1 prednK ?(ltn_trans _ kt) //; case: t kt => [//|t] _.
    by rewrite chazelle_count.span_still /= mulmx1.
  by rewrite /pprod !parting_product.
- by move=> T' [].
apply/setP => i; rewrite !inE pprod_self /P /P_of chazelle_count.column_b pnatr_eq0 eqb0 negbK.
by case: k => [|k] /=; rewrite !inE ?andbb.
Qed.
End Parting.
Lemma count_1_proved : count_1.
Proof.
move=> R; exists 3%N, 1%N, 2%N, 3%N, 2%N, (@chazelle_count.xs R), (@chazelle_count.vs R), chazelle_count.Gs, (@chazelle_count.cs R), 1%N, ord0, id.
exists (fun k => if k is 0%N then setT else [set ord0]), 1%N, 1%N; split=> //.
- exact: parting_rational.
- by split=> //; apply: parting_stabilisers.
- by move=> i j t t'; rewrite !inE => /eqP-> /eqP-> _ _; rewrite chazelle_count.GsE eqxx !andbF.
rewrite cards1 /= addn0 lt0b; apply/existsP; exists (@Ordinal 3 1 isT); by apply/existsP; exists (@Ordinal 3 2 isT).
Qed.
Lemma chi_1_proved : chi_1.
Proof.
split=> [R n i chi|R e He]; first exact: no_chi_proved.
exists 3%N, 1%N, 2%N, 3%N, 2%N, (@chazelle_count.xs R), (@chazelle_count.vs R), chazelle_count.Gs, (@chazelle_count.cs R).
exists (@Ordinal 3 1 isT), (@Ordinal 3 2 isT), 2%N; split=> //; first exact: parting_rational.
have E : pprod (P_of chazelle_count.Gs (@chazelle_count.cs R)) 2.-1 1 *m (@chazelle_count.vs R) 1%N = (@chazelle_count.vs R) 2%N.
  by rewrite pprod_self; have [_ _ _ /(_ 1%N isT)[_ -> _ _]] := parting_flock R.
rewrite -mulmxA E -scalemxAl -rowE => /matrixP/(_ 0 0); rewrite !mxE /= => /eqP; rewrite -subr_eq0; apply/negP.
case: He => ->.
  by rewrite [X in X != _](_ : _ = - (9%:R / 2%:R)); [rewrite oppr_eq0 mulf_neq0 ?invr_eq0 ?pnatr_eq0|field].
by rewrite [X in X != _](_ : _ = 5%:R / 2%:R); [rewrite mulf_neq0 ?invr_eq0 ?pnatr_eq0|field].
Qed.
(* three birds in units of 1/36: the first comes near the second at t = 2, near the third at t = 3; from t = 4 on they fly together *)
Section Meeting.
Variable R : rcfType.
Definition meet_place (t i : nat) : nat := (if t is u.+3 then nth 0 [:: 45 + 5 * u; 69 + 5 * u; 81 + 5 * u] i
  else nth 0 (nth [::] [:: [:: 0; 63; 81]; [:: 18; 63; 81]; [:: 36; 63; 81]] t) i)%N.
Definition meet_speed (t i : nat) : nat := 
  (if t is u.+4 then 5 else nth 0 (nth [::] [:: [:: 18; 0; 0]; [:: 18; 0; 0]; [:: 18; 0; 0]; [:: 9; 6; 0]] t) i)%N.
Definition meet_G t : rel 'I_3 := fun i j => (i != j) && (nth 0%N [:: 0; 2; 3; 0]%N (i + j)%N <= t)%N.
Let x t : 'cV[R]_3 := \col_i ((meet_place t i)%:R / 36%:R).
Let v t : 'cV[R]_3 := \col_i ((meet_speed t i)%:R / 36%:R).
Let w t := vicsek R (meet_G t).
Let P := P_of meet_G w.
Lemma meet_network t : network (meet_G t).
Proof. by split=> [i j|i]; rewrite /meet_G ?eqxx // eq_sym addnC. Qed.
Lemma meet_near t i j : (i != j) && (`|x t i 0 - x t j 0| <= 1) = meet_G t i j.
Proof.
have N (p q : nat) : (`|p%:R / 36%:R - q%:R / 36%:R| <= 1 :> R) = (p <= q + 36)%N && (q <= p + 36)%N.
  rewrite -mulrBl normrM [ `|36%:R^-1| ]gtr0_norm ?invr_gt0 ?ltr0n // ler_pdivr_mulr ?ltr0n // mul1r.
  by rewrite ler_distl ler_subl_addr -!natrD !ler_nat andbC.
rewrite /meet_G; case: (eqVneq i j) => //= ij; rewrite !mxE N.
by case: t => [|[|[|u]]]; case: i ij => [[|[|[|?]]] ?] //; case: j => [[|[|[|?]]] ?] //= _; apply/idP/idP; lia.
Qed.
Lemma meet_degree t i : (degree (meet_G t) i <= 2)%N.
Proof.
by rewrite degree_count !big_ord_recl big_ord0 /meet_G; case: t => [|[|[|t]]]; case: i => [[|[|[|?]]] ?].
Qed.
Lemma meet_flock : flock_D 1 0 x v meet_G w.
Proof.
split=> [i j|t i j|t|t t0].
- by rewrite norm2_line meet_near.
- rewrite !norm2_line andb_orr meet_near; case E: (meet_G t.+1 i j) => //=; apply/esym/negbTE.
  rewrite negb_and -implybE; apply/implyP => ij; rewrite negb_and; apply/orP; left; apply: contraFN E.
  by rewrite /meet_G => /andP[-> h] /=; apply: leqW.
- apply/colP => i; rewrite !mxE -mulrDl -natrD; congr (_%:R / _).
  by case: t => [|[|[|[|u]]]]; case: i => [[|[|[|?]]] ?] //=; lia.
have net := meet_network t; split.
- exact: vicsek_model_D.
- apply/colP => i; rewrite (proj1 (model_K_matrix _ i net)) big_mkcond degree_count !big_ord_recl !big_ord0 !mxE.
  by case: t t0 {net} => [//|[|[|[|u]]]] _; case: i => [[|[|[|?]]] ?] //=; field.
- move=> i j; rewrite (proj2 (model_K_matrix (0 : 'cV_3) i net)); case: ifP => [_ _|_]; last by rewrite ltxx.
  by rewrite expr1 lef_pinv ?posrE ?ltr0n // ler_nat ltnS meet_degree.
move=> i; rewrite norm2_speed mxE normrM normr_nat [ `|36%:R^-1|]ger0_norm ?invr_ge0 ?ler0n // ler_pdivr_mulr ?ltr0n //.
rewrite expr0 mul1r ler_nat; by case: t t0 {net} => [//|[|[|[|t]]]] _; case: i => [[|[|[|?]]] ?].
Qed.
Lemma meet_rational : rational_flock 1 4 0 x v meet_G w.
Proof.
split; first exact: meet_flock.
- exists (fun (i : 'I_3) (_ : 'I_1) => (meet_place 0 i)%:Z), (fun _ _ => 36%N) => i k; rewrite mxE; split=> //.
  by case: i => [[|[|[|?]]] ?].
- exists (fun (i : 'I_3) (_ : 'I_1) => (meet_speed 1 i)%:Z), (fun _ _ => 36%N) => i k; rewrite mxE; split=> //.
  by case: i => [[|[|[|?]]] ?].
- move=> t _; exists (fun _ => 1%N), (fun i => (degree (meet_G t) i).+1) => i; split=> //; first by rewrite div1r.
  by rewrite expn1 ltnS meet_degree.
move=> s t _ _ E i; rewrite /w /vicsek; congr (_.+1%:R^-1); apply: eq_card => j; by rewrite !inE E.
Qed.
Lemma meet_edge t i j : (P t i j != 0) = (i == j) || meet_G t i j.
Proof. by apply: transition_edge; [apply: meet_network|apply: vicsek_model_D]. Qed.
Lemma meet_ge0 t i j : 0 <= P t i j.
Proof. by have [[]] := model_D_stochastic (meet_network t) (@vicsek_model_D R 3 (meet_G t)). Qed.
Lemma meet_product s t i j : (s <= t)%N -> (pprod P t.+1 s i j != 0) = [exists l, (P t.+1 i l != 0) && (pprod P t s l j != 0)].
Proof.
move=> st; rewrite pprod_next //; have Q0 : forall k l, 0 <= pprod P t s k l by apply: span_ge0; apply: meet_ge0.
apply/idP/existsP => [nz|[l /andP[a b]]].
  apply/existsP; apply: contraNT nz => /existsPn H; rewrite mxE big1 // => l _; have := H l.
  by rewrite negb_and !negbK => /orP[]/eqP ->; rewrite ?mul0r ?mulr0.
apply: lt0r_neq0; apply: lt_le_trans (mul_ge_term i l j (meet_ge0 t.+1) Q0).
by rewrite mulr_gt0 // lt_def ?a ?b ?meet_ge0 ?Q0.
Qed.
Lemma meet_column t i : (0 < t)%N -> (pprod P t 1 i ord0 != 0) = (i < t)%N.
Proof.
case: t => // t _; elim: t i => [|t IH] i.
  by rewrite pprod_self meet_edge; case: i => [[|[|[|?]]] ?].
rewrite meet_product //; apply/existsP/idP => [[l]|].
  rewrite meet_edge IH /meet_G; case: t {IH} => [|[|t]]; case: i => [[|[|[|?]]] ?] //; by case: l => [[|[|[|?]]] ?].
move=> it; have [i0|i0] := boolP (i < t.+1)%N; first by exists i; rewrite meet_edge eqxx IH.
exists ord0; rewrite meet_edge IH /meet_G; case: t it i0 {IH} => [|[|t]]; by case: i => [[|[|[|?]]] ?].
Qed.
Lemma meet_weight t : (0 < t)%N -> column_weight P 1 t = ((0 < t) + ((1 < t) + ((2 < t) + 0)))%N.
Proof.
by move=> t0; rewrite /column_weight -sum1_card big_mkcond !big_ord_recl big_ord0 /= !inE !meet_column.
Qed.
Lemma meet_growth : growth_times P 1 [:: 2; 3]%N.
Proof.
split=> // t; rewrite !inE; case: t => [|[|[|[|t]]]] //=; rewrite !meet_weight //.
Qed.
End Meeting.
Lemma Nts_1_proved : Nts_1.
Proof.
split=> [R n P t|R]; first by rewrite /N_open subSnn.
exists 2%N, 1%N, 1%N, 4%N, 0%N; do 2 eexists; exists meet_G; eexists; exists 1%N, [:: 2; 3]%N, 0%N.
by split=> //; [apply: meet_rational|apply: meet_growth].
Qed.
Lemma Nts_2_proved : Nts_2.
Proof.
move=> R; exists 2%N, 1%N, 1%N, 4%N, 0%N; do 2 eexists; exists meet_G; eexists; exists 1%N, [:: 2; 3]%N.
split=> //; [exact: meet_rational|exact: meet_growth|].
rewrite !big_ord_recl big_ord0 /N_open /=; case: existsP => // -[]; exists ord0; apply/existsP; exists (@Ordinal 3 1 isT).
by rewrite !meet_edge.
Qed.
Lemma foot_2_proved : foot_2.
Proof.
move=> R; exists 3%N, 1%N, 1%N, 4%N, 0%N; do 2 eexists; exists meet_G; eexists; exists 1%N, 2%N, ord0, (@Ordinal 3 2 isT).
split=> //; [exact: meet_rational| |].
  rewrite meet_product //; apply/existsP; exists (@Ordinal 3 1 isT); by rewrite pprod_self !meet_edge.
by apply/eqP; rewrite -[_ == _]negbK meet_column.
Qed.
(* two birds in units of 1/16, c_i = 1/4: joined up to t = 2, ever farther apart from t = 3 on *)
Section Leaving.
Variable R : rcfType.
Definition leave_place (t i : nat) : nat := (if t is u.+3 then nth 0 [:: 5 + 3 * u; 23 + 5 * u] i
  else nth 0 (nth [::] [:: [:: 0; 4]; [:: 0; 12]; [:: 2; 18]] t) i)%N.
Definition leave_speed (t i : nat) : nat := (if t is u.+3 then nth 0 [:: 3; 5] i
  else nth 0 (nth [::] [:: [:: 0; 8]; [:: 0; 8]; [:: 2; 6]] t) i)%N.
Definition leave_G t : rel 'I_2 := fun i j => (i != j) && (t <= 2)%N.
Let x t : 'cV[R]_2 := \col_i ((leave_place t i)%:R / 16%:R).
Let v t : 'cV[R]_2 := \col_i ((leave_speed t i)%:R / 16%:R).
Let w (t : nat) (i : 'I_2) : R := 4%:R^-1.
Let P := P_of leave_G w.
Lemma leave_network t : network (leave_G t).
Proof. by split=> [i j|i]; rewrite /leave_G ?eqxx // eq_sym. Qed.
Lemma leave_near t i j : (i != j) && (`|x t i 0 - x t j 0| <= 1) = leave_G t i j.
Proof.
have N (p q : nat) : (`|p%:R / 16%:R - q%:R / 16%:R| <= 1 :> R) = (p <= q + 16)%N && (q <= p + 16)%N.
  rewrite -mulrBl normrM [ `|16%:R^-1| ]gtr0_norm ?invr_gt0 ?ltr0n // ler_pdivr_mulr ?ltr0n // mul1r.
  by rewrite ler_distl ler_subl_addr -!natrD !ler_nat andbC.
rewrite /leave_G; case: (eqVneq i j) => //= ij; rewrite !mxE N.
by case: t => [|[|[|u]]]; case: i ij => [[|[|?]] ?] //; case: j => [[|[|?]] ?] //= _; apply/idP/idP; lia.
Qed.
Lemma leave_degree t i : degree (leave_G t) i = (t <= 2)%N.
Proof. by rewrite degree_count !big_ord_recl big_ord0 /leave_G; case: (t <= 2)%N; case: i => [[|[|?]] ?]. Qed.
Lemma leave_entries t i j : P t i j = if (t <= 2)%N then (if i == j then 3%:R / 4%:R else 4%:R^-1) else (i == j)%:R.
Proof.
have [_ ir] := leave_network t; rewrite /P /P_of transitionE // leave_degree /leave_G /w; case: (t <= 2)%N => /=.
  by case: (i == j) => //; field.
by rewrite mulr0 subr0 andbF; case: (i == j).
Qed.
Lemma leave_flock : flock_D 2 0 x v leave_G w.
Proof.
have e1 : (2%:R ^+ (2 ^ 4))^-1 <= 8%:R^-1 :> R.
  by rewrite lef_pinv ?posrE ?exprn_gt0 ?ltr0n // (_ : 8%:R = 2%:R ^+ 3) ?ler_weexpn2l ?ler1n // -natrX.
split=> [i j|t i j|t|t t0].
- by rewrite norm2_line leave_near.
- rewrite !norm2_line andb_orr leave_near; case E: (leave_G t.+1 i j) => //=; apply/esym/negbTE.
  move: E; rewrite /leave_G; case: (eqVneq i j) => //= ij; case: t => [|[|[|t]]] //= _; rewrite ?andbF //.
  rewrite -leNgt; apply: (le_trans e1).
  have D : `|x 3 i 0 - x 3 j 0| = 18%:R / 16%:R :> R.
    by rewrite !mxE -mulrBl normrM [ `|16%:R^-1|]gtr0_norm ?invr_gt0 ?ltr0n //; case: i ij => [[|[|?]] ?] //; case: j => [[|[|?]] ?] //= _;
      [rewrite distrC|]; rewrite -natrB // normr_nat.
  have D' : `|x 2 i 0 - x 2 j 0| = 1 :> R.
    rewrite !mxE -mulrBl normrM [ `|16%:R^-1|]gtr0_norm ?invr_gt0 ?ltr0n //; case: i ij {D} => [[|[|?]] ?] //; case: j => [[|[|?]] ?] //= _;
      [rewrite distrC|]; by rewrite -natrB // normr_nat mulfV ?pnatr_eq0.
  by rewrite D D' (_ : _ - 1 = 8%:R^-1) ?ger0_norm ?invr_ge0 ?ler0n //; field.
- apply/colP => i; rewrite !mxE -mulrDl -natrD; congr (_%:R / _).
  by case: t => [|[|[|u]]]; case: i => [[|[|?]] ?] //=; lia.
have i4 : (4%:R^-1 : R) <= 1 by rewrite invf_le1 ?ltr0n ?ler1n.
split.
- move=> i; rewrite leave_degree; case: (t <= 2)%N => // _; by rewrite mulr1 invr_gt0 ltr0n invf_lt1 ?ltr0n // ltr1n.
- apply/colP => i; rewrite [RHS]mxE !big_ord_recl big_ord0 -/(P_of leave_G w t) -/P !leave_entries !mxE.
  by case: t t0 => [//|[|[|u]]] _; case: i => [[|[|?]] ?] //=; field.
- move=> i j; rewrite -/(P_of leave_G w t) -/P leave_entries -natrX; case: (t <= 2)%N; case: (i == j); rewrite ?ltxx // => _.
  by rewrite ler_pmull ?invr_gt0 ?ltr0n // ler1n.
move=> i; rewrite norm2_speed mxE normrM normr_nat [ `|16%:R^-1|]ger0_norm ?invr_ge0 ?ler0n // ler_pdivr_mulr ?ltr0n //.
rewrite expr0 mul1r ler_nat; by case: t t0 => [//|[|[|t]]] _; case: i => [[|[|?]] ?].
Qed.
Lemma leave_rational : rational_flock 2 4 0 x v leave_G w.
Proof.
split; first exact: leave_flock.
- exists (fun (i : 'I_2) (_ : 'I_1) => (leave_place 0 i)%:Z), (fun _ _ => 16%N) => i k; rewrite mxE; split=> //.
  by case: i => [[|[|?]] ?].
- exists (fun (i : 'I_2) (_ : 'I_1) => (leave_speed 1 i)%:Z), (fun _ _ => 16%N) => i k; rewrite mxE; split=> //.
  by case: i => [[|[|?]] ?].
- by move=> t _; exists (fun _ => 1%N), (fun _ => 4%N) => i; split=> //; rewrite /w div1r.
by [].
Qed.
Lemma leave_still a k : (2 < a)%N -> span P a k = 1%:M.
Proof.
move=> a2; elim: k => [//|k IH] /=; rewrite IH mulmx1; apply/matrixP => i j; rewrite leave_entries !mxE.
by rewrite leqNgt (leq_trans a2 (leq_addr k a)).
Qed.
Lemma leave_positive a k i j : (0 < a <= 2)%N -> 0 < span P a k.+1 i j.
Proof.
have P0 t p q : 0 <= P t p q by rewrite leave_entries; case: (t <= 2)%N; case: (p == q); rewrite ?divr_ge0 ?invr_ge0 ?ler0n.
have Pd t p : 0 < P t p p by rewrite leave_entries eqxx; case: (t <= 2)%N; rewrite ?divr_gt0 ?ltr0n ?ltr01.
case/andP=> a0 a2; elim: k => [|k IH]; first by rewrite /= mulmx1 addn0 leave_entries a2; case: eqP => _; rewrite ?divr_gt0 ?invr_gt0 ?ltr0n.
apply: lt_le_trans (@mul_ge_term R 2 (P (a + k.+1)%N) (span P a k.+1) i i j (P0 _) _); first by rewrite mulr_gt0.
exact: span_ge0.
Qed.
Let V k : {set 'I_2} := if (k <= 2)%N then setT else [set ord0].
Lemma leave_stabilisers : stabilisers P 1 ord0 id V.
Proof.
split=> // k; split.
- split=> // t i j kt _ _; have [k1|k1] := leqP k.+1 2.
    by rewrite /pprod !lt0r_neq0 ?leave_positive.
  by rewrite /pprod !leave_still.
- by move=> T' [].
apply/setP => i; rewrite !inE pprod_self leave_entries /V.
case: k => [|[|[|k]]] /=; rewrite !inE ?pnatr_eq0 ?eqb0 ?negbK ?andbb //=; case: (i == ord0);
  by rewrite ?mulf_eq0 ?invr_eq0 ?pnatr_eq0.
Qed.
Lemma leave_printed : block (V 3) (V 0%N) (pprod P 4 1) <> printed_product P id V 1 4.
Proof.
pose Q : 'M[R]_2 := \matrix_(i, j) if i == j then 3%:R / 4%:R else 4%:R^-1.
have P1 t : (t <= 2)%N -> P t = Q by move=> h; apply/matrixP => i j; rewrite leave_entries h mxE.
have P3 t : (2 < t)%N -> P t = 1%:M by move=> h; have := leave_still 1 h; rewrite /= mulmx1 addn0.
have E : pprod P 4 1 = Q *m Q by rewrite /pprod /= (P3 (1 + 3)%N) // (P3 (1 + 2)%N) // (P1 (1 + 1)%N) // (P1 (1 + 0)%N) // !mul1mx mulmx1.
rewrite /printed_product /= E !pprod_self (P3 4%N) // (P3 3%N) // (P1 2%N) // (P1 1%N) // mulmx1 => /matrixP/(_ ord0 ord0).
have b33 : block (V 3) (V 3) (1%:M : 'M[R]_2) = delta_mx ord0 ord0.
  by apply/matrixP => i j; rewrite !mxE !inE; case: i => [[|[|?]] ?] //; case: j => [[|[|?]] ?].
have b32 : (delta_mx ord0 ord0 : 'M[R]_2) *m block (V 3) (V 2) (1%:M : 'M[R]_2) = delta_mx ord0 ord0.
  apply/matrixP => i j; rewrite mxE !big_ord_recl big_ord0 !mxE !inE.
  by case: i => [[|[|?]] ?] //; case: j => [[|[|?]] ?] //=; rewrite ?mulr1 ?mulr0 ?mul0r ?addr0.
rewrite b33 b32 !mxE !big_ord_recl !big_ord0 !mxE !big_ord_recl !big_ord0 !mxE !inE /= => /eqP; rewrite -subr_eq0; apply/negP.
by rewrite [X in X != _](_ : _ = 16%:R^-1); [rewrite invr_eq0 pnatr_eq0|field].
Qed.
End Leaving.
Lemma eq3_5_proved : eq3_5.
Proof.
move=> R; exists 2%N, 1%N, 2%N, 4%N, 0%N; do 2 eexists; exists leave_G; eexists; exists 1%N, ord0, id; eexists; exists 1%N, 4%N.
split; [exact: leave_rational|by []|exact: leave_stabilisers|by []|exact: leave_printed].
Qed.
(* ---- the eigenvectors of (3.8) exist ---- *)
From mathcomp Require Import perm.
Lemma eq3_8_basis_proved : eq3_8_basis.
Proof.
move=> R m G c F; have [_ sym] := eq3_7_1_proved F; have [U [D [UU MU]]] := symmetric_spectra.spectral_theorem sym.
have [] := eq3_7_3_proved (ltn0Sn m) F; set u1 := \col_i _ => Mu1 u1u1 _.
have UM : U^T *m M_of G c = diag_mx D *m U^T by rewrite -[LHS]trmxK trmx_mul trmxK sym MU trmx_mul tr_diag_mx.
pose g := U^T *m u1; have Dg : diag_mx D *m g = g by rewrite /g mulmxA -UM -mulmxA Mu1.
have g0 : g != 0.
  apply: contraPneq u1u1 => z; have -> : u1 = 0 by rewrite -[u1]mul1mx -(mulmx1C UU) -mulmxA -/g z mulmx0.
  by rewrite big1 => [/eqP|i _]; rewrite ?mxE ?expr0n // eq_sym oner_eq0.
have [k gk] := column_nonzero g0.
have Dk : D 0 k = 1.
  by apply: (mulIf gk); rewrite mul1r -[RHS](congr1 (fun z : 'cV_m.+1 => z k 0) Dg) mul_diag_mx mxE.
exists (fun l => D 0 (tperm ord0 k l)), (fun l => col (tperm ord0 k l) U); split.
- move=> p q; rewrite tr_col -row_mul; have := congr1 (fun z : 'M_m.+1 => z (tperm ord0 k p) (tperm ord0 k q)) UU.
  rewrite !mxE (inj_eq perm_inj) => <-; apply: eq_bigr => i _; by rewrite !mxE.
- move=> l; apply/colP => i; pose p := tperm ord0 k l; rewrite -/p.
  have h : (M_of G c *m U) i p = U i p * D 0 p by rewrite MU mul_mx_diag mxE.
  rewrite [RHS]mxE [X in _ = _ * X]mxE [RHS]mulrC -h !mxE; apply: eq_bigr => j _; by rewrite [col _ _ _ _]mxE.
by rewrite tpermL.
Qed.
