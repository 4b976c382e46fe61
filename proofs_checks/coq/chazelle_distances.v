(* Chazelle, (3.18): the square of the distance of two birds whose limits are at distance 1, as a sum of powers.
     chazelle.eq3.18 (eq_3_18 for birds of two flocks, eq_3_18_one for two birds of one).
   (3.17) is squared, and terms with equal moduli are collected: a negative base r gives |r|^s (-1)^s, and the constant sign (-1)^t_1 belongs to
   Upsilon^-.  Products of q eigenvalues have at most q (q + 1)/2 values.  Any real closed field, no axioms. *)
Set Warnings "-notation-overridden,-ambiguous-paths".
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import ring zify.
From Flockproof Require Import chazelle_model chazelle_ergodicity chazelle_fixed chazelle_limits chazelle_spectral.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Import GRing.Theory Num.Theory Order.Theory.
Local Open Scope ring_scope.

(* ---- sums of powers by their moduli ---- *)
Section Moduli.
Variables (R : realFieldType) (T : seq (R * R)).
(* sum over T of b r^s, s > 0: the positive parts of the coefficients, and the alternating ones *)
Definition plus (r : R) := \sum_(b <- T | b.2 == r) b.1.
Definition minus (r : R) := \sum_(b <- T | b.2 == - r) b.1.
Lemma by_moduli (rho : seq R) s : uniq rho -> (forall r, r \in rho -> 0 < r) -> (forall b, b \in T -> b.2 != 0 -> `|b.2| \in rho) -> (0 < s)%N ->
  \sum_(b <- T) b.1 * b.2 ^+ s = \sum_(r <- rho) (plus r + (-1) ^+ s * minus r) * r ^+ s.
Proof.
move=> un pos all s0.
have E r : r \in rho -> (plus r + (-1) ^+ s * minus r) * r ^+ s = \sum_(b <- T) (if `|b.2| == r then b.1 * b.2 ^+ s else 0).
  move=> /pos r0; rewrite mulrDl [(-1) ^+ s * _]mulrC -mulrA -exprMn mulN1r /plus /minus !mulr_suml big_mkcond [X in _ + X]big_mkcond -big_split /=.
  apply: eq_bigr => b _; have rN : (r == - r) = false by apply/negbTE; rewrite -subr_eq0 opprK gt_eqF // addr_gt0.
  case: (b.2 =P r) => [->|/eqP br]; first by rewrite rN addr0 gtr0_norm // eqxx.
  case: (b.2 =P - r) => [->|/eqP bN]; first by rewrite normrN gtr0_norm // eqxx add0r.
  by rewrite addr0 eqr_norml (negbTE br) (negbTE bN).
rewrite (eq_big_seq _ E) exchange_big /=; apply: eq_big_seq => b bT.
have [z|nz] := eqVneq b.2 0.
  by rewrite z expr0n gtn_eqF // mulr0 big1_seq // => r _; case: ifP.
by rewrite (bigD1_seq `|b.2|) ?all //= eqxx big1 ?addr0 // => r; rewrite eq_sym => /negbTE ->.
Qed.
End Moduli.

(* ---- the moduli of some numbers and of their products ---- *)
Section Values.
Variable R : realFieldType.
(* the distinct nonzero values among |y| and |y z|, from the largest to the smallest *)
Definition moduli (mu : seq R) : seq R :=
  sort (fun r r' => r' <= r) (undup [seq `|y| | y <- mu ++ [seq y * z | y <- mu, z <- mu] & y != 0]).
Lemma in_moduli mu r : (r \in moduli mu) =
  (r != 0) && ((r \in [seq `|y| | y <- mu]) || (r \in [seq `|y * z| | y <- mu, z <- mu])).
Proof.
rewrite mem_sort mem_undup; apply/mapP/andP => [[y]|[r0 /orP[/mapP[y ym e]|/allpairsP[[y z] /= [ym zm e]]]]].
- rewrite mem_filter mem_cat => /andP[y0 H] ->; rewrite normr_eq0 y0; split=> //; case/orP: H => [ym|/allpairsP[[a b] /= [am bm ->]]].
    by rewrite map_f.
  by apply/orP; right; apply/allpairsP; exists (a, b).
- by exists y => //; rewrite mem_filter mem_cat ym -normr_eq0 -e r0.
by exists (y * z) => //; rewrite mem_filter mem_cat -normr_eq0 -e r0 /=; apply/orP; right; apply/allpairsP; exists (y, z).
Qed.
Lemma moduli_uniq mu : uniq (moduli mu). Proof. by rewrite sort_uniq undup_uniq. Qed.
Lemma moduli_sorted mu : sorted (fun r r' => r' < r) (moduli mu).
Proof.
have := moduli_uniq mu; have : sorted (fun r r' : R => r' <= r) (moduli mu) by apply: sort_sorted => r r'; exact: le_total.
move: (moduli mu); elim=> // r [|r' s] IH // /andP[le so] /andP[ni un]; apply/andP; split; last exact: IH.
by rewrite lt_def le andbT; move: ni; rewrite inE negb_or => /andP[].
Qed.
Lemma moduli_range mu : (forall y, y \in mu -> `|y| < 1) -> forall r, r \in moduli mu -> 0 < r < 1.
Proof.
move=> small r; rewrite in_moduli => /andP[r0 /orP[/mapP[y ym e]|/allpairsP[[y z] /= [ym zm e]]]]; move: r0; rewrite e normr_eq0 => r0.
  by rewrite normr_gt0 r0 small.
by rewrite normr_gt0 r0 normrM mulr_ilt1 // small.
Qed.
Fixpoint half (mu : seq R) : seq R := if mu is y :: s then [seq y * z | z <- mu] ++ half s else [::].
Lemma size_half mu : (2 * size (half mu) = size mu * (size mu).+1)%N.
Proof. by elim: mu => //= y s IH; rewrite size_cat size_map mulnS mulnDr IH; move: (size s) => k; lia. Qed.
Lemma in_half mu y z : y \in mu -> z \in mu -> y * z \in half mu.
Proof.
elim: mu => // x s IH; rewrite ![_ \in x :: s]in_cons => ym zm; rewrite -[half (x :: s)]/([seq x * u | u <- x :: s] ++ half s) mem_cat.
case/orP: ym => [/eqP ->|ys]; first by rewrite map_f // in_cons.
case/orP: zm => [/eqP ->|zs]; first by rewrite mulrC map_f // in_cons ys orbT.
by rewrite IH ?orbT.
Qed.
Lemma moduli_few (mu : seq R) q : (size (undup mu) <= q)%N -> (2 * size (moduli mu) <= q * q.+3)%N.
Proof.
set u := undup mu => uq; pose a : seq R := [seq `|y| | y <- u ++ half u]; have le : (size (moduli mu) <= size a)%N.
  apply: uniq_leq_size (moduli_uniq mu) _ => r; rewrite in_moduli => /andP[_ /orP[/mapP[y ym ->]|/allpairsP[[y z] /= [ym zm ->]]]].
    by rewrite map_f // mem_cat mem_undup ym.
  by rewrite map_f // mem_cat in_half ?orbT // mem_undup.
move: le; rewrite /a size_map size_cat => le; have := size_half u; move: (size (half u)) (size (moduli mu)) le => h k le E.
apply: (@leq_trans (2 * (size u + h))); first by rewrite leq_mul2l le orbT.
rewrite mulnDr E; apply: (@leq_trans (size u * (size u).+3)); first by move: (size u) => w; rewrite mulnS !mulnS; lia.
by apply: leq_mul.
Qed.
End Values.

(* ---- the square of a distance ---- *)
Section Square.
Variables (R : rcfType) (d : nat) (A : 'rV[R]_d) (modes : seq (R * 'rV[R]_d)) (mu : seq R).
Hypothesis inmu : forall p, p \in modes -> p.1 \in mu.
Hypothesis unit : norm2 A = 1.
Let T : seq (R * R) := [seq (- (2%:R * dot A p.2), p.1) | p <- modes] ++ [seq (dot p.2 r.2, p.1 * r.1) | p <- modes, r <- modes].
Lemma squared s : norm2 (A - \sum_(p <- modes) p.1 ^+ s *: p.2) ^+ 2 - 1 = \sum_(b <- T) b.1 * b.2 ^+ s.
Proof.
pose S q := \sum_(p <- modes) p.1 ^+ s * p.2 0 q.
have SE q : (\sum_(p <- modes) p.1 ^+ s *: p.2) 0 q = S q by rewrite summxE; apply: eq_bigr => p _; rewrite mxE.
have one : 1 = \sum_q A 0 q ^+ 2 :> R by rewrite -norm2_sqr unit expr1n.
rewrite norm2_sqr one -sumrB (eq_bigr (fun q => - (2%:R * (A 0 q * S q)) + S q * S q)) => [|q _]; last first.
  by rewrite !mxE SE; move: (A 0 q) (S q) => y z; ring.
rewrite big_split /= /T big_cat big_map big_allpairs_dep /=; congr (_ + _).
  rewrite sumrN -mulr_sumr (eq_bigr (fun q => \sum_(p <- modes) A 0 q * p.2 0 q * p.1 ^+ s)) => [|q _]; last first.
    by rewrite /S mulr_sumr; apply: eq_bigr => p _; rewrite mulrAC mulrA.
  by rewrite exchange_big /= mulr_sumr -sumrN; apply: eq_bigr => p _; rewrite -mulr_suml mulrA mulNr.
rewrite (eq_bigr (fun q => \sum_(p <- modes) \sum_(r <- modes) p.2 0 q * r.2 0 q * (p.1 * r.1) ^+ s)) => [|q _]; last first.
  rewrite /S mulr_suml; apply: eq_bigr => p _; rewrite mulr_sumr; apply: eq_bigr => r _.
  by rewrite exprMn; move: (p.1 ^+ s) (r.1 ^+ s) (p.2 0 q) (r.2 0 q) => y z a b; ring.
rewrite exchange_big; apply: eq_bigr => p _; rewrite exchange_big; apply: eq_bigr => r _.
by rewrite -mulr_suml.
Qed.
Lemma expansion (t1 : nat) : exists up um : R -> R, forall s, (0 < s)%N ->
  norm2 (A - \sum_(p <- modes) p.1 ^+ s *: p.2) ^+ 2 - 1 = \sum_(r <- moduli mu) (up r + (-1) ^+ (t1 + s) * um r) * r ^+ s.
Proof.
exists (plus T), (fun r => (-1) ^+ t1 * minus T r) => s s0.
rewrite squared (@by_moduli R T (moduli mu) s) ?moduli_uniq // => [|r|b]; first last.
- rewrite mem_cat in_moduli normr_eq0 => /orP[/mapP[p pm ->]|/allpairsP[[p r] /= [pm rm ->]]] /= -> /=.
    by rewrite map_f // inmu.
  by apply/orP; right; apply/allpairsP; exists (p.1, r.1); rewrite !inmu.
- by rewrite in_moduli => /andP[r0 /orP[/mapP[y _ e]|/allpairsP[[y z] /= [_ _ e]]]]; rewrite lt_def r0 e normr_ge0.
apply: eq_bigr => r _; rewrite mulrA -exprD addnAC addnn -mul2n exprD exprM sqrrN expr1n expr1n mul1r.
by [].
Qed.
End Square.

(* ---- birds i and i' of two flocks ---- *)
Section Flock.
Variables (R : rcfType) (m : nat) (G : rel 'I_m.+1) (c : 'I_m.+1 -> R) (U : 'M[R]_m.+1) (lam : 'I_m.+1 -> R).
Definition other : seq R := [seq lam k | k <- enum [pred k : 'I_m.+1 | k != ord0]].
Lemma other_size : size other = m.
Proof. by rewrite size_map -cardE cardC1 card_ord. Qed.
Hypothesis n1 : network G.
Hypothesis D1 : model_D G c.
Hypothesis k1 : forall a b, connect G a b.
Hypothesis p1 : forall a, 0 < c a.
Hypothesis o1 : U^T *m U = 1%:M.
Hypothesis e1 : forall a k, \sum_b M G c a b * U b k = lam k * U a k.
Hypothesis f1 : forall a, U a 0 = u1 c a.
Hypothesis l1 : lam 0 = 1.
Lemma other_small y : y \in other -> `|y| < 1.
Proof.
case/mapP => k; rewrite mem_enum inE => k0 ->.
have [_ _ _ _ range] := eq_3_7 n1 D1 k1 p1; have ne := lam_neq1 n1 D1 k1 p1 o1 e1 f1 k0.
have nz : exists a, U a k != 0.
  apply/existsP; apply: contraT; rewrite negb_exists => /forallP z.
  have /matrixP/(_ k k) := o1; rewrite !mxE eqxx big1 => [/eqP|a _]; first by rewrite eq_sym oner_eq0.
  by have := z a; rewrite negbK mxE => /eqP ->; rewrite mul0r.
by case: (range (lam k) (fun a => U a k) (fun a => e1 a k) nz) => [l|]; [rewrite l eqxx in ne | rewrite ltr_norml].
Qed.
End Flock.

(* N < n^2 for q <= n - 1 eigenvalues *)
Lemma fewer n q : (q < n)%N -> (q * q.+3 < 2 * n ^ 2)%N.
Proof. by move=> qn; apply: (@leq_ltn_trans (n.-1 * n.-1.+3)); [apply: leq_mul; lia | rewrite -mulnn; nia]. Qed.

(* both cases; mu are the eigenvalues but for the 1 of either flock *)
Lemma distances (R : rcfType) n d t1
  m (G : rel 'I_m.+1) (c : 'I_m.+1 -> R) (U : 'M[R]_m.+1) (lam : 'I_m.+1 -> R) (x v : nat -> 'M[R]_(m.+1, d)) (i : 'I_m.+1)
  m' (G' : rel 'I_m'.+1) (c' : 'I_m'.+1 -> R) (U' : 'M[R]_m'.+1) (lam' : 'I_m'.+1 -> R)
  (x' v' : nat -> 'M[R]_(m'.+1, d)) (i' : 'I_m'.+1) :
  network G -> model_D G c -> (forall a b, connect G a b) -> (forall a, 0 < c a) ->
  U^T *m U = 1%:M -> (forall a k, \sum_b M G c a b * U b k = lam k * U a k) -> (forall a, U a 0 = u1 c a) -> lam 0 = 1 ->
  (forall t, (t1 <= t)%N -> x t.+1 = x t + v t.+1) -> (forall t, (t1 < t)%N -> v t.+1 = transition G c *m v t) ->
  network G' -> model_D G' c' -> (forall a b, connect G' a b) -> (forall a, 0 < c' a) ->
  U'^T *m U' = 1%:M -> (forall a k, \sum_b M G' c' a b * U' b k = lam' k * U' a k) -> (forall a, U' a 0 = u1 c' a) -> lam' 0 = 1 ->
  (forall t, (t1 <= t)%N -> x' t.+1 = x' t + v' t.+1) -> (forall t, (t1 < t)%N -> v' t.+1 = transition G' c' *m v' t) ->
  let A := row i (x t1) - row i' (x' t1) + (row i (Gamma G c *m v t1.+1) - row i' (Gamma G' c' *m v' t1.+1)) in
  (forall q, drift c v t1 q = drift c' v' t1 q) -> norm2 A = 1 ->
  forall mu, {subset other lam ++ other lam' <= mu} -> (size (undup mu) < n)%N ->
  (forall y, y \in mu -> (y \in other lam) || (y \in other lam')) ->
  let rho := moduli mu in
  [/\ sorted (fun r r' => r' < r) rho, forall r, r \in rho -> 0 < r < 1, (size rho < n ^ 2)%N &
    exists up um : R -> R, forall t, (t1 < t)%N ->
      norm2 (row i (x t) - row i' (x' t)) ^+ 2 - 1 = \sum_(r <- rho) (up r + (-1) ^+ t * um r) * r ^+ (t - t1)].
Proof.
move=> n1 D1 k1 p1 o1 e1 f1 l1 X1 V1 n2 D2 k2 p2 o2 e2 f2 l2 X2 V2 A B0 A1 mu sub few back rho.
pose modes := [seq (lam k, \row_q (Phi c U v t1 i k q / (1 - lam k))) | k <- enum [pred k : 'I_m.+1 | k != ord0]]
  ++ [seq (lam' k, \row_q - (Phi c' U' v' t1 i' k q / (1 - lam' k))) | k <- enum [pred k : 'I_m'.+1 | k != ord0]].
have inmu p : p \in modes -> p.1 \in mu.
  by rewrite mem_cat => /orP[]/mapP[k km ->]; apply: sub; rewrite mem_cat; apply/orP; [left | right]; exact: map_f.
split; first exact: moduli_sorted.
- apply: moduli_range => y /back/orP[]; [exact: (other_small n1 D1 k1 p1 o1 e1 f1) | exact: (other_small n2 D2 k2 p2 o2 e2 f2)].
- have := moduli_few (leqnn (size (undup mu))); have := fewer few; rewrite -/rho; lia.
have [up [um E]] := expansion inmu A1 t1; exists up, um => t t1t.
have tE : (t1 + (t - t1) = t)%N by rewrite subnKC // ltnW.
have := E (t - t1)%N; rewrite subn_gt0 tE => /(_ t1t) <-; congr (norm2 _ ^+ 2 - 1); apply/rowP => q.
have := @eq_3_17 R d t1 (t - t1) q m G c U lam x v i m' G' c' U' lam' x' v' i' n1 D1 k1 p1 o1 e1 f1 l1 X1 V1 n2 D2 k2 p2 o2 e2 f2 l2 X2 V2; rewrite /= tE B0 subrr mul0rn addr0 => H.
have L : (row i (x t) - row i' (x' t)) 0 q = x t i q - x' t i' q by rewrite !mxE.
have AE : A 0 q = x t1 i q - x' t1 i' q + ((Gamma G c *m v t1.+1) i q - (Gamma G' c' *m v' t1.+1) i' q) by rewrite /A !mxE.
rewrite L H [RHS]mxE AE [X in _ = _ + X]mxE; congr (_ - _); rewrite summxE big_cat /= !big_map !big_enum /=.
by congr (_ + _); apply: eq_bigr => k _; rewrite !mxE mulrC.
Qed.

(* chazelle.eq3.18: the two flocks have m + 1 and m' + 1 of the n birds; the mu_k are the lam k and lam' k, k <> 0 *)
Theorem eq_3_18 (R : rcfType) n d t1
  m (G : rel 'I_m.+1) (c : 'I_m.+1 -> R) (U : 'M[R]_m.+1) (lam : 'I_m.+1 -> R) (x v : nat -> 'M[R]_(m.+1, d)) (i : 'I_m.+1)
  m' (G' : rel 'I_m'.+1) (c' : 'I_m'.+1 -> R) (U' : 'M[R]_m'.+1) (lam' : 'I_m'.+1 -> R)
  (x' v' : nat -> 'M[R]_(m'.+1, d)) (i' : 'I_m'.+1) :
  network G -> model_D G c -> (forall a b, connect G a b) -> (forall a, 0 < c a) ->
  U^T *m U = 1%:M -> (forall a k, \sum_b M G c a b * U b k = lam k * U a k) -> (forall a, U a 0 = u1 c a) -> lam 0 = 1 ->
  (forall t, (t1 <= t)%N -> x t.+1 = x t + v t.+1) -> (forall t, (t1 < t)%N -> v t.+1 = transition G c *m v t) ->
  network G' -> model_D G' c' -> (forall a b, connect G' a b) -> (forall a, 0 < c' a) ->
  U'^T *m U' = 1%:M -> (forall a k, \sum_b M G' c' a b * U' b k = lam' k * U' a k) -> (forall a, U' a 0 = u1 c' a) -> lam' 0 = 1 ->
  (forall t, (t1 <= t)%N -> x' t.+1 = x' t + v' t.+1) -> (forall t, (t1 < t)%N -> v' t.+1 = transition G' c' *m v' t) ->
  let A := row i (x t1) - row i' (x' t1) + (row i (Gamma G c *m v t1.+1) - row i' (Gamma G' c' *m v' t1.+1)) in
  (forall q, drift c v t1 q = drift c' v' t1 q) -> norm2 A = 1 ->
  (m.+1 + m'.+1 <= n)%N ->
  let rho := moduli (other lam ++ other lam') in
  [/\ sorted (fun r r' => r' < r) rho, forall r, r \in rho -> 0 < r < 1, (size rho < n ^ 2)%N &
    exists up um : R -> R, forall t, (t1 < t)%N ->
      norm2 (row i (x t) - row i' (x' t)) ^+ 2 - 1 = \sum_(r <- rho) (up r + (-1) ^+ t * um r) * r ^+ (t - t1)].
Proof.
move=> n1 D1 k1 p1 o1 e1 f1 l1 X1 V1 n2 D2 k2 p2 o2 e2 f2 l2 X2 V2 A B0 A1 mn.
apply: (distances n1 D1 k1 p1 o1 e1 f1 l1 X1 V1 n2 D2 k2 p2 o2 e2 f2 l2 X2 V2 B0 A1) => // [|y]; last by rewrite mem_cat.
by apply: (leq_ltn_trans (size_undup _)); rewrite size_cat !other_size; lia.
Qed.
(* two birds of one flock, which has m + 1 of the n birds *)
Theorem eq_3_18_one (R : rcfType) n d t1
  m (G : rel 'I_m.+1) (c : 'I_m.+1 -> R) (U : 'M[R]_m.+1) (lam : 'I_m.+1 -> R) (x v : nat -> 'M[R]_(m.+1, d)) (i j : 'I_m.+1) :
  network G -> model_D G c -> (forall a b, connect G a b) -> (forall a, 0 < c a) ->
  U^T *m U = 1%:M -> (forall a k, \sum_b M G c a b * U b k = lam k * U a k) -> (forall a, U a 0 = u1 c a) -> lam 0 = 1 ->
  (forall t, (t1 <= t)%N -> x t.+1 = x t + v t.+1) -> (forall t, (t1 < t)%N -> v t.+1 = transition G c *m v t) ->
  norm2 (row i (x t1) - row j (x t1) + (row i (Gamma G c *m v t1.+1) - row j (Gamma G c *m v t1.+1))) = 1 ->
  (m < n)%N ->
  let rho := moduli (other lam) in
  [/\ sorted (fun r r' => r' < r) rho, forall r, r \in rho -> 0 < r < 1, (size rho < n ^ 2)%N &
    exists up um : R -> R, forall t, (t1 < t)%N ->
      norm2 (row i (x t) - row j (x t)) ^+ 2 - 1 = \sum_(r <- rho) (up r + (-1) ^+ t * um r) * r ^+ (t - t1)].
Proof.
move=> n1 D1 k1 p1 o1 e1 f1 l1 X1 V1 A1 mn.
apply: (distances n1 D1 k1 p1 o1 e1 f1 l1 X1 V1 n1 D1 k1 p1 o1 e1 f1 l1 X1 V1 _ A1) => // [y||y]; last by move=> ->.
  by rewrite mem_cat orbb.
by apply: (leq_ltn_trans (size_undup _)); rewrite other_size.
Qed.
