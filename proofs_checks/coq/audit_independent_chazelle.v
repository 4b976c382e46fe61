(* Clauses of the claims about Chazelle's paper, formalised from their words before the theorems were looked at; the theorems
   prove them. *)
Set Warnings "-notation-overridden,-ambiguous-paths".
From mathcomp Require Import all_ssreflect all_algebra.
From Flockproof Require Import chazelle_model chazelle_ergodicity chazelle_fixed chazelle_limits chazelle_products chazelle_entries.
From Flockproof Require chazelle_recurrent chazelle_agreement chazelle_switches chazelle_count chazelle_origins
  chazelle_stabilisers chazelle_sharp chazelle_network.
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

(* a flock of model D with the printed hysteresis rule; positive entries of P(t) at least n^-a, speeds of v(1) at most n^c *)
Definition flock_D (R : rcfType) n d a c (x v : nat -> 'M[R]_(n, d)) (G : nat -> rel 'I_n) (w : nat -> 'I_n -> R) :=
  let dist t i j := norm2 (row i (x t) - row j (x t)) in
  [/\ forall i j, G 0%N i j = (i != j) && (dist 0%N i j <= 1),
      forall t i j, G t.+1 i j = (i != j) && ((dist t.+1 i j <= 1) ||
        (G t i j && (`|dist t.+1 i j - dist t i j| < (n%:R ^+ (n ^ 4))^-1))),
      forall t, x t.+1 = x t + v t.+1,
      forall t, model_D (G t) (w t) /\
        forall i j, 0 < transition (G t) (w t) i j -> (n%:R ^+ a)^-1 <= transition (G t) (w t) i j &
      (forall t, (0 < t)%N -> v t.+1 = transition (G t) (w t) *m v t) /\
      forall i, norm2 (row i (v 1%N)) <= n%:R ^+ c].
(* beyond.chazelle.switches clause 1 *)
Definition switches_1 : Prop := forall (R : rcfType) n d a c (x v : nat -> 'M[R]_(n, d)) G w, (1 < n)%N -> flock_D a c x v G w ->
  forall T, (switches_up_to G T <= n ^ (a * n.-1 ^ 2 + (c + 9) * n.-1 + 1))%N.
(* chazelle.lem3.1 clause 1, chazelle.thm1.1.switches clause 1 *)
Definition lem3_1 : Prop := forall a c, exists K, forall (R : rcfType) n d (x v : nat -> 'M[R]_(n, d)) G w, (1 < n)%N ->
  flock_D a c x v G w -> forall T, (switches_up_to G T <= n ^ (K * n ^ 3))%N.

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
(* chazelle.lem2.4 *)
Definition lem2_4 : Prop := forall (R : rcfType) l m p (A : 'M[R]_(l, m)) (B : 'M[R]_(m, p)),
  stochastic A -> stochastic B -> tau2 (A *m B) <= tau1 A * tau2 B.
(* chazelle.tau2sqrt2 *)
Definition tau2_sqrt2 : Prop := forall (R : rcfType) m p (A : 'M[R]_(m, p)), stochastic A ->
  tau2 A <= tau1 A * tau2 (1%:M : 'M[R]_p) /\ tau1 A * tau2 (1%:M : 'M[R]_p) <= Num.sqrt 2%:R * tau1 A.

(* ---- a fixed connected network; P = I - C L ---- *)
Definition fixed (R : realFieldType) n (G : rel 'I_n) (c : 'I_n -> R) :=
  [/\ network G, model_D G c, forall i j, connect G i j & forall i, 0 < c i].
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

Lemma flock_is (R : rcfType) n d a c (x v : nat -> 'M[R]_(n, d)) G w : flock_D a c x v G w ->
  [/\ chazelle_switches.flock (n%:R ^- (n ^ 4)) x v G w,
      forall t i j, transition (G t) (w t) i j != 0 -> n%:R ^- a <= transition (G t) (w t) i j &
      forall i, norm2 (row i (v 1%N)) <= n%:R ^+ c].
Proof.
move=> [G0 Gn Hx W [Hv sp]].
have F : chazelle_switches.flock (n%:R ^- (n ^ 4)) x v G w by split=> // t; case: (W t).
split=> //.
have net := @chazelle_switches.flock_network _ _ _ _ _ _ _ _ F.
move=> t i j h; apply: (proj2 (W t)); apply: nonneg_entries h.
by case: (model_D_stochastic (net t) (proj1 (W t))).
Qed.
Lemma count_is n (G : nat -> rel 'I_n) T : switches_up_to G T = chazelle_stabilisers.N (chazelle_count.changes G) T 1.
Proof. by rewrite /switches_up_to /chazelle_stabilisers.N subn1. Qed.
Lemma switches_1_proved : switches_1.
Proof.
move=> R n d a c x v G w n1 /flock_is[F fl sp] T; rewrite count_is -!subn1.
exact: (chazelle_switches.switches n1 F fl sp).
Qed.
Lemma lem3_1_proved : lem3_1.
Proof.
move=> a c; exists (a + c + 9)%N => R n d x v G w n1 /flock_is[F fl sp] T; rewrite count_is.
exact: (chazelle_switches.lemma_3_1 n1 F fl sp).
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
