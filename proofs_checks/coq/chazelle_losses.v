(* Chazelle, Lemmas 3.6 (ii), 3.7 (but for the angle) and 3.8, the last sharpened: edges of a flock stay shorter than 1 + n^(-n^3), the
   virtual origins within n^O(n^2), and after time n^(n^4 + a(n-1)^2 + (c+9)(n-1) + 2a + 13) the network loses no edge.
     chazelle.lem3.6.ii (lemma_3_6_ii), chazelle.lem3.7 (lemma_3_7_origins), chazelle.lem3.8 (lemma_3_8), chazelle.lem3.6.i (within_unit);
     chazelle.hyst.remark (smaller_threshold: what Lemma 3.1's count, 3.6 (ii), 3.7 and 3.8 say, with a threshold up to 2^100 times smaller);
     beyond.chazelle.losses (losses, with a = 2 and c = 1); beyond.chazelle.angle, clause 2, for weights that change only when the network
     does (origins_stay).
   Hypotheses: n >= 4 birds in R^d, n > a + c, a >= 1; the hysteresis rule with the threshold n^(-n^4), or 2^-h n^(-n^4) with h <= 100; from t = 1 on positive entries of
   P(t) at least n^-a, which fractions with denominators up to n^a give (short_floor), and G_(t+1) = G_t gives c(t+1) = c(t); |v_i(1)| <= n^c;
   but for edges also d <= n^2 and coordinates of x(0) at most n^c.  The weights of time 0 do not matter.
   On a stretch of one network the velocities of neighbours agree after 2 n^(a+7) + n^(2a+3) steps up to less than the threshold, so that it adds
   at most n^(2a + 8 - n^4) to an edge; chazelle_switches.v bounds the number of stretches.  So no edge is longer than 2, the virtual origins
   stay within n^O(n^2), and t (v_i - v_j) does so with them.  Any real closed field, no axioms. *)
Set Warnings "-notation-overridden,-ambiguous-paths".
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import ring zify.
From Flockproof Require Import chazelle_model chazelle_ergodicity chazelle_fixed chazelle_network chazelle_sharp chazelle_origins
  chazelle_stabilisers chazelle_count chazelle_switches.
From Flockproof Require chazelle_products.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Import GRing.Theory Num.Theory Order.Theory.
Local Open Scope ring_scope.

(* ---- one fixed network: neighbours come to move alike ---- *)
Section Apart.
Variables (R : realFieldType) (n a : nat) (G : rel 'I_n) (c : 'I_n -> R).
Hypothesis net : network G.
Hypothesis MD : model_D G c.
Hypothesis a1 : (0 < a)%N.
Notation P := (transition G c).
Hypothesis floor : forall i j, 0 < P i j -> (n%:R ^+ a)^-1 <= P i j.

Lemma neighbours_agree (y : 'I_n -> R) r i j : (forall k, `|y k| <= 1) -> G i j ->
  `|after G c r y i - after G c r y j| <= 2%:R * bound R n a r.
Proof.
move=> y1 Gij; have [sym irr] := net; have di := edge_degree Gij.
pose K : pred 'I_n := connect G i.
have Ki : K i by exact: connect0.
have Kj : K j by exact: connect1.
have Cl k l : G k l -> K k = K l by exact: part_closed.
have Cp k : K k -> 0 < c k by exact: part_weight di.
have w0 k : 0 <= weigh c K k by exact: weigh_ge0.
have T0 : 0 < total c K.
  rewrite /total (bigD1 i) //=; apply: ltr_paddr; first by apply: sumr_ge0 => k _.
  by rewrite /weigh Ki invr_gt0 Cp.
pose m := (\sum_k weigh c K k * y k) / total c K.
have m1 : `|m| <= 1.
  rewrite normrM normfV [ `|total c K|]gtr0_norm // ler_pdivr_mulr // mul1r.
  apply: le_trans (ler_norm_sum _ _ _) _; apply: ler_sum => k _.
  by rewrite normrM ger0_norm // -[X in _ <= X]mulr1; apply: ler_wpmul2l.
pose f k := if K k then y k - m else 0.
have f2 k : `|f k| <= 2%:R.
  rewrite /f; case: ifP => _; last by rewrite normr0 ler0n.
  by apply: le_trans (ler_norm_sub _ _) _; rewrite -[2%:R]/(1 + 1); apply: ler_add.
have fc i0 : (0 < degree G i0)%N -> centred c (connect G i0) f.
  move=> d0; have [ii0|ii0] := boolP (connect G i i0); last first.
    rewrite /centred big1 // => k _; rewrite /weigh; case: ifP => c0k; last by rewrite mul0r.
    rewrite /f; case Kk: (K k); last by rewrite mulr0.
    case/negP: ii0; apply: connect_trans Kk _; by rewrite (@sym_connect_sym _ _ sym).
  have same k : connect G i0 k = K k by rewrite /K (@same_connect _ _ (@sym_connect_sym _ _ sym) _ _ ii0).
  rewrite /centred (eq_bigr (fun k => weigh c K k * y k - weigh c K k * m)) => [|k _]; last first.
    by rewrite /weigh same /f; case: ifP => _; [rewrite mulrBr | rewrite !mul0r subrr].
  by rewrite sumrB -mulr_suml -/(total c K) /m mulrCA mulfV ?mulr1 ?subrr // gt_eqF.
have E k : K k -> after G c r f k = after G c r y k - m.
  elim: r k => [|r IH] k Kk; first by rewrite !after0 /f Kk.
  have one : \sum_l P k l = 1 by exact: transition_row_sum.
  rewrite !afterS /drive -[X in _ = _ - X]mul1r -one mulr_suml -sumrB; apply: eq_bigr => l _.
  rewrite -mulrBr; case Kl: (K l); first by rewrite IH.
  rewrite transitionE //; case: (k =P l) => [kl|_]; first by rewrite -kl Kk in Kl.
  case Gkl: (G k l); last by rewrite !mul0r.
  by rewrite -(Cl _ _ Gkl) Kk in Kl.
have -> : after G c r y i - after G c r y j = after G c r f i - after G c r f j by rewrite !E //; ring.
have dj : (0 < degree G j)%N by apply: (@edge_degree _ _ _ i); rewrite sym.
apply: le_trans (ler_norm_sub _ _) _; rewrite mulr_natl mulr2n; apply: ler_add; exact: (after_bound net MD a1 floor f2 fc).
Qed.
End Apart.

(* ---- what a stretch of one network adds to the length of an edge, entries at least n^-a, speeds up to n^c ---- *)
Section Pace.
Variables (R : realFieldType) (n a c : nat).
Hypothesis n4 : (3 < n)%N.
Hypothesis a1 : (0 < a)%N.
Hypothesis cn : (c < n)%N.
(* the threshold, 2^hh times smaller than n^(-n^4) *)
Variable hh : nat.
Hypothesis h100 : (hh <= 100)%N.
Notation N := (n%:R : R).
Notation T := (2 ^ hh * n ^ (n ^ 4))%N.
Notation eps := (T%:R^-1 : R).
Definition pace (r : nat) : R := Num.min eps (N ^+ c * (2%:R * bound R n a r)).

Let n0 : (0 < n)%N. Proof. exact: leq_trans n4. Qed.
Let N0 k : 0 < N ^+ k. Proof. by rewrite exprn_gt0 // ltr0n. Qed.
Let mu : R := 1 - 4%:R / N ^+ (a + 2).
Let h := (n ^ (a + 2) * n ^ a.+1)%N.
Let k := (n * (n ^ 4 + c.+1) + 100)%N.
Let boundE r : bound R n a r = if (r < h)%N then 2%:R else 2%:R * mu ^+ (r - h). Proof. by []. Qed.
Let mu_range : 0 <= mu < 1.
Proof.
rewrite /mu subr_ge0 ltr_subl_addr ltr_addl divr_gt0 ?ltr0n // andbT ler_pdivr_mulr // mul1r -natrX ler_nat.
apply: (leq_trans n4); rewrite -{1}[n]expn1; apply: leq_pexp2l; [exact: leq_trans n4 | by rewrite addn2].
Qed.
Lemma pace_ge0 r : 0 <= pace r.
Proof.
have [m0 _] := andP mu_range; rewrite /pace le_minr invr_ge0 ler0n /=; apply: mulr_ge0; first exact: ltW.
by apply: mulr_ge0; rewrite ?ler0n // boundE; case: ifP => _; rewrite ?ler0n // mulr_ge0 ?ler0n ?exprn_ge0.
Qed.
Lemma pace_sum s : \sum_(r < s) pace r <= eps * N ^+ (2 * a + 8).
Proof.
have [m0 m1] := andP mu_range; have T0 : (0 < T)%N by rewrite muln_gt0 !expn_gt0 n0.
have e0 : 0 < eps by rewrite invr_gt0 ltr0n.
have M0 : (0 < n ^ (a + 2))%N by rewrite expn_gt0 n0.
have half : mu ^+ (n ^ (a + 2)) <= 2%:R^-1.
  have := @halving R (n ^ (a + 2)) (n ^ (a + 2)) M0; rewrite divnn M0 expr1; apply: le_trans.
  apply: ler_expn2r; rewrite ?nnegrE // ?subr_ge0 ?invf_le1 ?ltr0n ?ler1n // ler_add2l ler_opp2 natrX -[X in X <= _]mul1r.
  by apply: ler_wpmul2r; [rewrite invr_ge0 ltW | rewrite ler1n].
have tail : N ^+ c * 4%:R * mu ^+ (n ^ (a + 2) * k) <= eps.
  rewrite exprM; apply: (@le_trans _ _ (N ^+ c.+1 * 2%:R^-1 ^+ k)).
    apply: ler_pmul; rewrite ?mulr_ge0 ?exprn_ge0 ?ler0n //.
      by rewrite exprSr; apply: ler_wpmul2l; rewrite ?exprn_ge0 ?ler0n // ler_nat.
    by apply: ler_expn2r; rewrite ?nnegrE ?exprn_ge0 ?invr_ge0 ?ler0n.
  rewrite exprVn ler_pdivr_mulr ?exprn_gt0 ?ltr0n // ler_pdivl_mull ?ltr0n // -!natrX -natrM ler_nat -mulnA -expnD /k.
  rewrite [(2 ^ (_ + 100))%N]expnD mulnC; apply: leq_mul; last by rewrite leq_exp2l.
  by rewrite expnM leq_exp2r ?addnS //; apply: ltnW; exact: ltn_expl.
pose C r := 2%:R / eps * pace r.
have ce : 0 <= 2%:R / eps by rewrite divr_ge0 ?ler0n // ltW.
have C0 r : 0 <= C r by rewrite mulr_ge0 ?pace_ge0.
have C2 r : C r <= 2%:R.
  rewrite /C mulrAC ler_pdivr_mulr //; apply: ler_wpmul2l; rewrite ?ler0n //; by rewrite /pace le_minl lexx.
have Cm r : C (h + n ^ (a + 2) * k + r)%N <= 2%:R * mu ^+ r.
  rewrite /C mulrAC ler_pdivr_mulr // -mulrA; apply: ler_wpmul2l; rewrite ?ler0n //.
  apply: (@le_trans _ _ (N ^+ c * (2%:R * bound R n a (h + n ^ (a + 2) * k + r)))); first by rewrite /pace le_minl lexx orbT.
  rewrite boundE -addnA ltnNge leq_addr /= addKn exprD.
  have -> : N ^+ c * (2%:R * (2%:R * (mu ^+ (n ^ (a + 2) * k) * mu ^+ r))) = mu ^+ r * (N ^+ c * 4%:R * mu ^+ (n ^ (a + 2) * k)).
    by move: (mu ^+ r) (mu ^+ (n ^ (a + 2) * k)) (N ^+ c) => y z u; ring.
  by apply: ler_wpmul2l => //; rewrite exprn_ge0.
have := tail_sum s mu_range C2 Cm C0; rewrite /C -mulr_sumr mulrAC ler_pdivr_mulr // => H.
have -> : \sum_(r < s) pace r = 2%:R^-1 * (2%:R * \sum_(r < s) pace r) by rewrite mulKf ?pnatr_eq0.
apply: le_trans (ler_wpmul2l _ H) _; first by rewrite invr_ge0 ler0n.
rewrite mulrA [2%:R^-1 * _ * _]mulrC; apply: ler_wpmul2l; first exact: ltW.
have -> : 2%:R / (1 - mu) = (n ^ (a + 2))%:R / 2%:R :> R.
  rewrite /mu subKr invf_div natrX mulrCA; congr (_ * _).
  by rewrite -[4%:R]/(2 * 2)%:R natrM invfM mulrA mulfV ?mul1r ?pnatr_eq0.
rewrite ler_pdivr_mull ?ltr0n //; apply: (@le_trans _ _ ((2 * (h + n ^ (a + 2) * k))%:R + (n ^ (a + 2))%:R)).
  by rewrite ler_add2l ler_pdivr_mulr ?ltr0n // ler_pemulr ?ler0n // ler1n.
rewrite -natrD -natrX -natrM ler_nat /h /k.
have four m : (4 * n ^ m <= n ^ m.+1)%N by rewrite expnS leq_mul2r n4 orbT.
have up e f : (e <= f)%N -> (n ^ e <= n ^ f)%N by apply: leq_pexp2l; exact: leq_trans n4.
have c4 : (c.+1 <= n ^ 4)%N by apply: leq_trans cn _; rewrite -{1}[n]expn1 up.
have b1 : (n ^ (a + 2) * n ^ a.+1 <= n ^ (2 * a + 3))%N by rewrite -expnD up //; lia.
have b2 : (n ^ (a + 2) * (n * (n ^ 4 + c.+1) + 100) <= 3 * n ^ (a + 7))%N.
  have more : (n ^ (a + 2) * 100 <= n ^ (a + 7))%N.
    have -> : (a + 7 = a + 2 + 5)%N by lia.
    by rewrite (expnD n (a + 2) 5) leq_mul2l; apply/orP; right; apply: (@leq_trans (4 ^ 5)); rewrite // leq_exp2r.
  have main : (n ^ (a + 2) * (n * (n ^ 4 + c.+1)) <= 2 * n ^ (a + 7))%N.
    rewrite mulnA -expnSr; apply: (@leq_trans (n ^ (a + 2).+1 * (2 * n ^ 4))); first by rewrite leq_mul2l mul2n -addnn leq_add2l c4 orbT.
    by rewrite mulnCA -expnD leq_mul2l; apply/orP; right; apply: up; lia.
  move: more main; set y := (n * _)%N; set z := (n ^ (a + 7))%N; rewrite mulnDr; move: (_ * y)%N => q; lia.
have b3 : (n ^ (a + 7) <= n ^ (2 * a + 6))%N by apply: up; move: a1; lia.
have b4 : (n ^ (a + 2) <= n ^ (2 * a + 6))%N by apply: up; lia.
have b5 : (n ^ (2 * a + 3) <= n ^ (2 * a + 6))%N by apply: up; lia.
have b6 : (16 * n ^ (2 * a + 6) <= n ^ (2 * a + 8))%N.
  have -> : (2 * a + 8 = 2 * a + 6 + 2)%N by lia.
  by rewrite (expnD n (2 * a + 6) 2) [(n ^ (2 * a + 6) * _)%N]mulnC leq_mul2r; apply/orP; right; rewrite (@leq_trans (4 ^ 2)) // leq_exp2r.
move: b1 b2 b3 b4 b5 b6; clear; lia.
Qed.
End Pace.

Lemma transition_same (R : realFieldType) n (G H : rel 'I_n) (c e : 'I_n -> R) : irreflexive G -> irreflexive H ->
  (forall i j, H i j = G i j) -> (forall i, e i = c i) -> transition H e = transition G c.
Proof.
move=> iG iH E Ec; apply/matrixP=> i j; rewrite !transitionE // E Ec; congr (if _ then 1 - _ * _%:R else _).
by apply: eq_card => k; rewrite !inE E.
Qed.

(* ---- weights that change only when the network does ---- *)
Definition steady (R : realFieldType) n (G : nat -> rel 'I_n) (w : nat -> 'I_n -> R) :=
  forall t, (0 < t)%N -> (forall i j, G t.+1 i j = G t i j) -> forall i, w t.+1 i = w t i.
Lemma steady_run (R : realFieldType) n (G : nat -> rel 'I_n) (w : nat -> 'I_n -> R) t0 s : steady G w -> (0 < t0)%N ->
  (forall r, (r < s)%N -> forall i j, G (t0 + r)%N i j = G t0 i j) -> forall r, (r < s)%N -> forall i, w (t0 + r)%N i = w t0 i.
Proof.
move=> S p H; elim=> [|r IH] rs i; first by rewrite addn0.
rewrite addnS S ?addn_gt0 ?p //; first exact: IH (ltnW rs) i.
by move=> k l; rewrite -addnS !H // ltnW.
Qed.

(* ---- no edge is longer than 2 ---- *)
Section Short.
Variables (R : rcfType) (n d a c : nat) (x v : nat -> 'M[R]_(n, d)) (G : nat -> rel 'I_n) (w : nat -> 'I_n -> R).
Variable hh : nat.
Notation N := (n%:R : R).
Notation eps := ((2 ^ hh * n ^ (n ^ 4))%:R^-1 : R).
Notation P t := (transition (G t) (w t)).
Hypothesis n4 : (3 < n)%N.
Hypothesis a1 : (0 < a)%N.
Hypothesis cn : (c < n)%N.
Hypothesis h100 : (hh <= 100)%N.
Hypothesis F : flock eps x v G w.
Hypothesis floor : forall t i j, (0 < t)%N -> 0 < P t i j -> (N ^+ a)^-1 <= P t i j.
Hypothesis st : steady G w.
Hypothesis speed : forall i, norm2 (row i (v 1%N)) <= N ^+ c.

Let net t : network (G t). Proof. exact: (flock_network F). Qed.
Let MD t : model_D (G t) (w t). Proof. by case: F. Qed.
Let SP t : stochastic (P t). Proof. by case: (model_D_stochastic (net t) (@MD t)). Qed.
Let Hx t : x t.+1 = x t + v t.+1. Proof. by case: F => _ _ _ h _. Qed.
Let Hv t : (0 < t)%N -> v t.+1 = P t *m v t. Proof. by case: F => _ _ _ _ h; exact: h. Qed.
Let N0 : 0 < N. Proof. by rewrite ltr0n (leq_trans _ n4). Qed.
Let Nc : 0 < N ^+ c. Proof. exact: exprn_gt0. Qed.
Notation len t i j := (norm2 (row i (x t) - row j (x t))).

Lemma speed_le t i : (0 < t)%N -> norm2 (row i (v t)) <= N ^+ c.
Proof.
move=> t0; apply: (@le_trans _ _ (fastest (v t))); first exact: (max_ub (fun i => norm2 (row i (v t))) i).
case: t t0 => // t _; elim: t => [|t IH]; first by apply: max_le; rewrite // ltW.
by rewrite Hv //; apply: le_trans (fastest_mul _ (SP _)) IH.
Qed.
(* s steps on one network *)
Lemma velocity_run t0 s i q : (0 < t0)%N -> (forall r, (r < s)%N -> P (t0 + r) = P t0) ->
  v (t0 + s)%N i q = after (G t0) (w t0) s (fun k => v t0 k q) i.
Proof.
move=> p; elim: s i => [|s IH] i H; first by rewrite addn0 after0.
rewrite addnS Hv ?addn_gt0 ?p // H // afterS mxE; apply: eq_bigr => j _; rewrite IH // => r rs; exact: H (ltnW rs).
Qed.
(* the parts of the velocities in the direction D of the difference *)
Lemma run_pace t0 s i j : (0 < t0)%N -> (forall r, (r < s)%N -> P (t0 + r) = P t0) -> G t0 i j ->
  norm2 (row i (v (t0 + s)%N) - row j (v (t0 + s)%N)) <= N ^+ c * (2%:R * bound R n a s).
Proof.
move=> p H Gij; set D := row i _ - row j _.
have agree y : (forall k, `|y k| <= 1) -> `|after (G t0) (w t0) s y i - after (G t0) (w t0) s y j| <= 2%:R * bound R n a s.
  by move=> y1; exact: (neighbours_agree (net t0) (@MD t0) a1 (fun k l => floor p) s y1 Gij).
have [D0|Dn] := eqVneq (norm2 D) 0.
  rewrite D0; apply: mulr_ge0; [exact: ltW | apply: le_trans (normr_ge0 _) (agree (fun=> 0) _)] => k; by rewrite normr0 ler01.
have Dp : 0 < norm2 D by rewrite lt_def Dn norm2_ge0.
have ND : 0 < N ^+ c * norm2 D by exact: mulr_gt0.
pose y k := dot (row k (v t0)) D / (N ^+ c * norm2 D).
have y1 k : `|y k| <= 1.
  rewrite /y normrM normfV [ `|N ^+ c * _|]gtr0_norm // ler_pdivr_mulr // mul1r; apply: (@le_trans _ _ (norm2 (row k (v t0)) * norm2 D)).
    rewrite ler_norml cauchy_schwarz andbT ler_oppl -[norm2 (row k _)]norm2N; apply: le_trans (cauchy_schwarz _ _).
    by rewrite /dot -sumrN; apply: ler_sum => q _; rewrite !mxE mulNr.
  by apply: ler_wpmul2r; [exact: ltW | exact: speed_le].
have E k : after (G t0) (w t0) s y k = dot (row k (v (t0 + s)%N)) D / (N ^+ c * norm2 D).
  rewrite /after /dot (eq_bigr (fun l => (\sum_q mpow (P t0) s k l * (v t0 l q * D 0 q)) / (N ^+ c * norm2 D))) => [|l _]; last first.
    by rewrite /y mulrA /dot mulr_sumr; congr (_ / _); apply: eq_bigr => q _; rewrite mxE.
  rewrite -mulr_suml exchange_big /=; congr (_ / _); apply: eq_bigr => q _.
  by rewrite [row k _ 0 q]mxE (velocity_run _ _ p H) /after mulr_suml; apply: eq_bigr => l _; rewrite mulrA.
have := agree y y1; rewrite !E -mulrBl.
have -> : dot (row i (v (t0 + s)%N)) D - dot (row j (v (t0 + s)%N)) D = norm2 D * norm2 D.
  by rewrite -expr2 norm2_sqr /dot -sumrB; apply: eq_bigr => q _; rewrite -mulrBl expr2 !mxE.
by rewrite invfM mulrACA mulfV // mulr1 normrM normfV !gtr0_norm // ler_pdivr_mulr // mulrC.
Qed.

Lemma changes_next t : (0 < t)%N -> (chazelle_stabilisers.N (changes G) t.+1 1 = chazelle_stabilisers.N (changes G) t 1 + changes G t.+1)%N.
Proof. by move=> t0; rewrite (N_split _ t0 (leqnSn t)); congr (_ + _)%N; rewrite /chazelle_stabilisers.N subSn // subnn /= addn0. Qed.
Lemma still t i j : changes G t.+1 = false -> G t.+1 i j = G t i j.
Proof. by move=> ch; apply/eqP; apply: contraFT ch => ne; apply/existsP; exists i; apply/existsP; exists j. Qed.
Lemma step_le t i j : G t.+1 i j -> len t.+1 i j <= 1 \/
  G t i j /\ len t.+1 i j <= len t i j + Num.min eps (norm2 (row i (v t.+1) - row j (v t.+1))).
Proof.
have [_ GS _ _ _] := F; rewrite GS => /andP[_ /orP[|/andP[Gij e]]]; [by left | right; split=> //].
rewrite -ler_subl_addl le_minr; apply/andP; split; first by apply: le_trans (ler_norm _) _; exact: ltW e.
apply: le_trans (ler_norm _) _; apply: (@lemma_2_1 R n d x v t.+1 i j) => // -[|u] // _; exact: Hx.
Qed.
Lemma edges_grow t : (0 < t)%N -> exists t0, [/\ (0 < t0 <= t)%N, forall r, (t0 <= r <= t)%N -> forall i j, G r i j = G t0 i j &
  forall i j, G t i j -> len t i j <= 1 + eps + (eps * N ^+ (2 * a + 8)) *+ chazelle_stabilisers.N (changes G) t 1 + \sum_(r < t - t0) pace R n a c hh r.+1].
Proof.
have e0 : 0 < eps by rewrite invr_gt0 ltr0n muln_gt0 !expn_gt0 (leq_trans _ n4).
have D0 : 0 <= eps * N ^+ (2 * a + 8) by rewrite mulr_ge0 ?exprn_ge0 // ltW.
have S0 s : 0 <= \sum_(r < s) pace R n a c hh r.+1 by apply: sumr_ge0 => r _; exact: pace_ge0.
have SD s : \sum_(r < s) pace R n a c hh r.+1 <= eps * N ^+ (2 * a + 8).
  by apply: le_trans (pace_sum R n4 a1 cn h100 s.+1); rewrite big_ord_recl /= ler_addr pace_ge0.
elim: t => // t IH _; case: (posnP t) => [->|t0p].
  exists 1%N; split=> // [r|i j /step_le[h|[Gij h]]].
    by rewrite -eqn_leq => /eqP <-.
  - by rewrite N_empty // mulr0n big_ord0 !addr0; apply: le_trans h _; rewrite ler_addl ltW.
  have [G0 _ _ _ _] := F; move: Gij; rewrite G0 => /andP[_ l0].
  rewrite N_empty // mulr0n big_ord0 !addr0; apply: le_trans h _; apply: ler_add => //; by rewrite le_minl lexx.
have [t0 [/andP[p le] run H]] := IH t0p; rewrite changes_next //; set m := chazelle_stabilisers.N _ t 1 in H *.
have one i j : 1 <= 1 + eps + (eps * N ^+ (2 * a + 8)) *+ (m + changes G t.+1) + \sum_(r < j - i) pace R n a c hh r.+1.
  by rewrite -!addrA ler_addl !addr_ge0 // ?mulrn_wge0 // ltW.
have same r : (r < (t - t0).+1)%N -> P (t0 + r) = P t0.
  have all u : (u < (t - t0).+1)%N -> forall i j, G (t0 + u)%N i j = G t0 i j.
    by rewrite ltnS => h; apply: run; rewrite leq_addr /= -leq_subRL.
  move=> rs; have [_ i1] := net t0; have [_ i2] := net (t0 + r).
  by apply: transition_same => //; [exact: all | exact: (steady_run st p all rs)].
have grow i j : G t i j -> Num.min eps (norm2 (row i (v t.+1) - row j (v t.+1))) <= pace R n a c hh (t - t0).+1.
  move=> Gij; have G0ij : G t0 i j by rewrite -(run t) // le leqnn.
  have := run_pace p same G0ij; rewrite addnS subnKC // => h.
  by rewrite /pace le_minr !le_minl lexx h orbT.
case ch: (changes G t.+1); last first.
  exists t0; split; first by rewrite p leqW.
    move=> r /andP[h1]; rewrite leq_eqVlt => /orP[/eqP -> i j|rt i j]; last by apply: run; rewrite h1.
    by rewrite (still _ _ ch) run // le leqnn.
  move=> i j /step_le[h|[Gij h]]; first by apply: (le_trans h); have := one t0 t.+1; rewrite ch.
  apply: (le_trans h); rewrite addn0 subSn // big_ord_recr /= addrA; apply: ler_add; [exact: H | exact: grow].
exists t.+1; split; first by rewrite leqnn.
  by move=> r; rewrite -eqn_leq => /eqP <-.
move=> i j /step_le[h|[Gij h]]; first by apply: (le_trans h); have := one t.+1 t.+1; rewrite ch.
rewrite subnn big_ord0 addr0 addn1 mulrSr addrA; apply: (le_trans h); apply: le_trans (ler_add (H i j Gij) (grow i j Gij)) _.
rewrite -[X in X <= _]addrA ler_add2l; have := SD (t - t0).+1; by rewrite big_ord_recr.
Qed.
End Short.

(* ---- virtual origins, for weights that may be others when a network comes back ---- *)
Section Origins.
Variables (R : rcfType) (n d a : nat) (G : nat -> rel 'I_n) (c : nat -> 'I_n -> R) (x v : nat -> 'M[R]_(n, d)).
Notation P t := (transition (G t) (c t)).
Hypothesis net : forall t, (0 < t)%N -> network (G t).
Hypothesis MD : forall t, (0 < t)%N -> model_D (G t) (c t).
Hypothesis a1 : (0 < a)%N.
Hypothesis floor : forall t i j, (0 < t)%N -> 0 < P t i j -> (n%:R ^+ a)^-1 <= P t i j.
Hypothesis st : steady G c.
Hypothesis Hx : forall t, x t.+1 = x t + v t.+1.
Hypothesis Hv : forall t, (0 < t)%N -> v t.+1 = P t *m v t.
Variable T : nat.
Hypothesis short : forall t i j, (0 < t < T)%N -> G t i j -> norm2 (row i (x t) - row j (x t)) <= 2%:R.
Variable q : 'I_d.
Notation origin := (origin x v q).
Notation taken := (taken G c x q).

Lemma stretch_bound t0 s M : (0 < t0)%N -> (t0 + s <= T)%N -> (forall r, (r < s)%N -> forall i j, G (t0 + r)%N i j = G t0 i j) ->
  0 <= M -> (forall i, `|origin t0 i| <= M) -> forall i, `|origin (t0 + s) i| <= M + span_bound R n a.
Proof.
move=> p sT H M0 HM i; have Hc := steady_run st p H.
have dgr r : (r < s)%N -> forall j, degree (G (t0 + r)%N) j = degree (G t0) j.
  by move=> h j; apply: eq_card => k; rewrite !inE H.
have cnn r : (r < s)%N -> forall k l, connect (G (t0 + r)%N) k l = connect (G t0) k l.
  by move=> h k l; apply: eq_connect => y z; exact: H.
have HP r : (r < s)%N -> P (t0 + r) = P t0.
  move=> h; have [_ i1] := net p; have [_ i2] : network (G (t0 + r)%N) by apply: net; rewrite addn_gt0 p.
  by apply: transition_same => //; [exact: H | exact: Hc].
rewrite (run_sum Hx Hv q i p HP); apply: le_trans (ler_norm_add _ _) _; apply: ler_add.
  have SP : stochastic (P t0) by case: (model_D_stochastic (net p) (MD p)).
  have [A0 A1] := stochastic_mpow s SP; rewrite /after; apply: le_trans (ler_norm_sum _ _ _) _.
  rewrite -[X in _ <= X]mul1r -{1}(A1 i) mulr_suml; apply: ler_sum => j _; by rewrite normrM ger0_norm ?A0 //; apply: ler_wpmul2l.
have ok r : (r < s)%N -> [/\ forall k, `|taken (t0 + r) k| <= 2%:R,
   forall i0, (0 < degree (G t0) i0)%N -> centred (c t0) (connect (G t0) i0) (taken (t0 + r)) &
   forall k, degree (G t0) k = 0%N -> taken (t0 + r) k = 0].
  move=> h; have pr : (0 < t0 + r)%N by rewrite addn_gt0 p.
  split=> [k|i0 d0|k d0]; first by apply: (taken_le net MD short); rewrite pr; apply: leq_trans sT; rewrite ltn_add2l.
    have := @taken_centred _ _ _ _ _ x net MD q (t0 + r)%N i0 pr; rewrite dgr // => /(_ d0); rewrite /centred => Z; rewrite -[RHS]Z.
    by apply: eq_bigr => k _; rewrite /weigh cnn // Hc.
  by apply: (taken_alone c x net); rewrite // dgr.
case: (posnP (degree (G t0) i)) => [d0|di].
  rewrite big1 ?normr0 ?mulr_ge0 ?exprn_ge0 ?ler0n // => r _; have [_ _ al] := ok r (ltn_ord r).
  by apply: after_alone => //; exact: net.
apply: le_trans (ler_norm_sum _ _ _) _.
have b r : (r < s)%N -> `|after (G t0) (c t0) (s.-1 - r) (taken (t0 + r)) i| <= bound R n a (s.-1 - r).
  move=> h; have [le ce al] := ok r h.
  by apply: (after_bound (net p) (MD p) a1) => // k l; exact: floor.
apply: (@le_trans _ _ (\sum_(r < s) bound R n a (s.-1 - r))); first by apply: ler_sum => r _; exact: b.
rewrite (reindex_inj rev_ord_inj) /= (eq_bigr (fun r : 'I_s => bound R n a r)) => [|r _]; last by rewrite (rev_index (ltn_ord r)).
case: s b ok {H Hc dgr cnn HP sT} => [|s] b ok; first by rewrite big_ord0 mulr_ge0 ?exprn_ge0 ?ler0n.
have [le ce al] := ok 0%N (ltn0Sn s).
by apply: (bound_sum (net p) (MD p) a1 _ le ce s.+1 di) => k l; exact: floor.
Qed.
(* beyond.chazelle.angle: the coordinates of the virtual origins *)
Theorem origins_stay t i M : (0 < t <= T)%N -> (forall j, `|x 0%N j q| <= M) ->
  `|x t i q - t%:R * v t i q| <= M + 4%:R * (N (changes G) t.-1 1).+1%:R * n%:R ^+ (2 * a + 3).
Proof.
move=> /andP[tp tT] HM; have M0 : 0 <= M by exact: le_trans (normr_ge0 _) (HM i).
set S := span_bound R n a; have B0 : 0 <= S by rewrite mulr_ge0 ?exprn_ge0 ?ler0n.
(* the start of the stretch that holds t - 1 *)
suff [t0 [/andP[p le] run H]] : exists t0, [/\ (0 < t0 <= t)%N, (forall r, (t0 <= r < t)%N -> forall i j, G r i j = G t0 i j) &
    forall i, `|origin t0 i| <= M + S *+ N (changes G) t.-1 1].
  have := @stretch_bound t0 (t - t0) (M + S *+ N (changes G) t.-1 1) p; rewrite subnKC // => /(_ tT) h.
  apply: (le_trans (h _ _ H i)).
  - by move=> r hr; apply: run; rewrite leq_addr /= -ltn_subRL.
  - by rewrite addr_ge0 ?mulrn_wge0.
  by rewrite -addrA -mulrSr ler_add2l -[_ *+ _]mulr_natr /S /span_bound mulrAC lexx.
elim: t tp tT => // -[|t] IH _ tT.
  exists 1%N; split=> //; first by move=> r /andP[h1 h2]; move: (leq_trans h2 h1); rewrite ltnn.
  by move=> k; rewrite (origin_first Hx) N_empty // mulr0n addr0.
have {IH} [t0 [/andP[p le] run H]] := IH isT (ltnW tT); rewrite [t.+2.-1]/= [t.+1.-1]/= in H *.
have next : (N (changes G) t.+1 1 = N (changes G) t 1 + ((0 < t) && changes G t.+1))%N.
  by case: (posnP t) => [->|t0p]; [rewrite !N_empty | rewrite changes_next].
case ch: ((0 < t)%N && changes G t.+1); last first.
  exists t0; split; [by rewrite p leqW | | by rewrite next ch addn0].
  move=> r /andP[h1]; rewrite ltnS leq_eqVlt => /orP[/eqP -> k l|rt k l]; last by apply: run; rewrite h1.
  move: le; rewrite leq_eqVlt => /orP[/eqP -> //|le].
  have t0p : (0 < t)%N by exact: leq_trans p le.
  by rewrite (still _ _ (_ : changes G t.+1 = false)) ?run ?leqnn ?andbT //; move: ch; rewrite t0p.
exists t.+1; split; [by rewrite leqnSn | | move=> k].
  by move=> r; rewrite ltnS -eqn_leq => /eqP <-.
have := @stretch_bound t0 (t.+1 - t0) (M + S *+ N (changes G) t 1) p; rewrite subnKC // => /(_ (ltnW tT)) h.
rewrite next ch addn1 mulrSr addrA; apply: (h _ _ H k).
- by move=> r hr; apply: run; rewrite leq_addr /= -ltn_subRL.
by rewrite addr_ge0 ?mulrn_wge0.
Qed.
End Origins.

(* ---- the network of time 0 is followed by no step of its own, so that its weights do not matter ---- *)
Section First.
Variables (R : rcfType) (n d : nat) (eps : R) (x v : nat -> 'M[R]_(n, d)) (G : nat -> rel 'I_n) (w : nat -> 'I_n -> R).
Hypothesis F : flock eps x v G w.
Definition from_one (t : nat) : 'I_n -> R := if t is 0%N then vicsek R (G 0%N) else w t.
Lemma flock_from_one : flock eps x v G from_one.
Proof.
have [G0 GS MD Hx Hv] := F; split=> //; first by case=> [|t]; [exact: vicsek_model_D | exact: MD].
by case=> // t t0; exact: Hv.
Qed.
Lemma from_one_floor a : (0 < a)%N -> (forall t i j, (0 < t)%N -> 0 < transition (G t) (w t) i j -> (n%:R ^+ a)^-1 <= transition (G t) (w t) i j) ->
  forall t i j, transition (G t) (from_one t) i j != 0 -> (n%:R ^+ a)^-1 <= transition (G t) (from_one t) i j.
Proof.
move=> a0 floor t i j nz; case: t nz => [|t] nz; last first.
  apply: floor => //; have [_ _ MD _ _] := F; have [[P0 _] _] := model_D_stochastic (flock_network F t.+1) (MD t.+1).
  by rewrite lt_def nz P0.
have n0 : (0 < n)%N by exact: leq_ltn_trans (leq0n _) (ltn_ord i).
have net := flock_network F 0; have [_ E] := model_K_matrix (0 : 'cV[R]_n) i net; have [_ irr] := net.
move: nz; rewrite /= !E; case: ifP => [_ _|_]; last by rewrite eqxx.
have dn : (degree (G 0%N) i < n)%N.
  rewrite -[X in (_ < X)%N]card_ord; apply: proper_card; apply/properP; split; first by apply/subsetP.
  by exists i; rewrite // inE irr.
rewrite lef_pinv ?posrE ?ltr0n ?exprn_gt0 ?ltr0n // -natrX ler_nat (leq_trans dn) // -{1}[n]expn1.
by apply: leq_pexp2l.
Qed.
End First.

(* ---- the estimates ---- *)
(* n^(few a c n) bounds the number of switches *)
Definition few a c n := (a * (n - 1) ^ 2 + (c + 9) * (n - 1) + 1)%N.
Lemma two_power n m h : (3 < n)%N -> (h <= 2 * m)%N -> (2 ^ h <= n ^ m)%N.
Proof.
move=> n4 hm; apply: (@leq_trans (2 ^ (2 * m))); first by rewrite leq_exp2l.
by rewrite expnM; case: m {hm} => [|m] //; rewrite leq_exp2r.
Qed.
Section Estimates.
Variables n a c : nat.
Hypothesis n4 : (3 < n)%N.
Hypothesis acn : (a + c < n)%N.
Let p e : (0 < n ^ e)%N. Proof. by rewrite expn_gt0 (leq_trans _ n4). Qed.
Let four e : (4 * n ^ e <= n ^ e.+1)%N. Proof. by rewrite expnS leq_mul2r n4 orbT. Qed.
Lemma few_room : (few a c n + n ^ 3 + (2 * a + 10) <= n ^ 4)%N.
Proof.
rewrite /few; case: n n4 acn => // m m3; rewrite ltnS subn1 /= => am.
have h : (a * m ^ 2 + c * m <= m ^ 3)%N.
  apply: (@leq_trans ((a + c) * m ^ 2)); last by rewrite (expnS m 2) leq_mul2r am orbT.
  by rewrite mulnDl leq_add2l leq_mul2l -mulnn leq_pmulr ?orbT // -ltnS (leq_trans _ m3).
have f : (a <= m)%N by apply: leq_trans am; rewrite leq_addr.
have [u E] : exists u, m = (u + 3)%N by exists (m - 3)%N; rewrite subnK.
have key : (m ^ 3 + 9 * m + 1 + m.+1 ^ 3 + (2 * m + 10) <= m.+1 ^ 4)%N.
  by rewrite E !expnS !expn0; move: (leq0n (u * u)) (leq0n (u * u * u)) (leq0n (u * u * u * u)); clear; lia.
by move: h f key; rewrite mulnDl; clear; lia.
Qed.
Lemma few_room' : (few a c n + 2 * a + 12 <= n ^ 4)%N.
Proof. by move: few_room (four 2%N) (four 1%N) n4; rewrite expn1; lia. Qed.
(* the time *)
Lemma time_estimate : (n ^ (n ^ 4) * (2 + 2 * n ^ (few a c n + 2 * a + 9)) + 2 <= n ^ (n ^ 4 + few a c n + 2 * a + 12))%N.
Proof.
have -> : (n ^ 4 + few a c n + 2 * a + 12 = n ^ 4 + (few a c n + 2 * a + 9).+3)%N by lia.
set e := (few a c n + 2 * a + 9)%N; rewrite [(n ^ (n ^ 4 + _))%N]expnD; set T := (n ^ (n ^ 4))%N; have T0 : (0 < T)%N by exact: p.
apply: (@leq_trans (T * (2 + 2 * n ^ e + 2))).
  by rewrite [(T * (_ + 2))%N]mulnDr leq_add2l leq_pmull.
rewrite leq_mul2l; apply/orP; right; move: (four e.+2) (four e.+1) (four e) (p e); lia.
Qed.
(* with a threshold up to 2^100 times smaller *)
Lemma time_room h : (h <= 100)%N -> (2 ^ h * n ^ (n ^ 4) * (2 + 2 * n ^ (few a c n + 2 * a + 9)) + 2 <= n ^ (2 * n ^ 4))%N.
Proof.
move=> h100; have h2 : (2 ^ h <= n ^ 50)%N by apply: two_power.
have room : (few a c n + 2 * a + 10 + 50 + n ^ 4 <= 2 * n ^ 4)%N.
  have cube : (50 <= n ^ 3)%N by apply: (@leq_trans (4 ^ 3)); rewrite // leq_exp2r.
  by move: few_room cube; move: (n ^ 3)%N (n ^ 4)%N (few a c n) => y z f; lia.
apply: (@leq_trans (n ^ (few a c n + 2 * a + 10 + 50 + n ^ 4))); last by apply: leq_pexp2l; [exact: leq_trans n4 | exact: room].
have -> : (few a c n + 2 * a + 10 + 50 + n ^ 4 = 50 + n ^ 4 + (few a c n + 2 * a + 9).+1)%N by lia.
rewrite [X in (_ <= X)%N]expnD [(n ^ (50 + _))%N]expnD; set e := (few a c n + 2 * a + 9)%N; set T := (n ^ (n ^ 4))%N; have T0 : (0 < T)%N by exact: p.
have S0 : (0 < 2 ^ h * T)%N by rewrite muln_gt0 expn_gt0.
apply: (@leq_trans (2 ^ h * T * (2 + 2 * n ^ e + 2))); first by rewrite [X in (_ <= X)%N]mulnDr leq_add2l leq_pmull.
apply: (@leq_trans (n ^ 50 * T * (2 + 2 * n ^ e + 2))); first by rewrite leq_mul2r leq_mul2r h2 !orbT.
have ne : (4 <= n ^ e)%N by apply: leq_trans n4 _; rewrite -{1}[n]expn1 leq_pexp2l ?(leq_trans _ n4) // /e !addnS.
rewrite leq_mul2l; apply/orP; right; move: (four e) ne; move: (n ^ e)%N (n ^ e.+1)%N => y z; lia.
Qed.
(* with m switches *)
Variable m : nat.
Hypothesis mf : (m <= n ^ few a c n)%N.
(* the length of an edge *)
Lemma edge_estimate (R : realFieldType) :
  (n%:R ^+ (n ^ 4))^-1 + ((n%:R ^+ (n ^ 4))^-1 * n%:R ^+ (2 * a + 8)) *+ m + (n%:R ^+ (n ^ 4))^-1 * n%:R ^+ (2 * a + 8)
    <= (n%:R ^+ (n ^ 3))^-1 :> R.
Proof.
set e := (_ ^+ (n ^ 4))^-1; set b := (2 * a + 8)%N; have N0 k : 0 < n%:R ^+ k :> R by rewrite -natrX ltr0n.
rewrite -addrA -mulrSr.
have -> : e + (e * n%:R ^+ b) *+ m.+1 = e * (1 + n ^ b * m.+1)%:R.
  by rewrite natrD natrM natrX mulrDr mulr1 mulrA mulr_natr.
rewrite mulrC ler_pdivr_mulr // ler_pdivl_mull // -!natrX -natrM ler_nat.
have low : (n ^ (n ^ 3) * (n ^ (b + 2) * n ^ few a c n) <= n ^ (n ^ 4))%N.
  by rewrite -!expnD; apply: leq_pexp2l; [exact: leq_trans n4 | move: few_room; rewrite /b; lia].
apply: leq_trans low; rewrite leq_mul2l; apply/orP; right; rewrite expnD -mulnA.
have two : (3 <= n ^ 2)%N by apply: (@leq_trans (4 ^ 2)); rewrite // leq_exp2r.
apply: (@leq_trans (n ^ b * (3 * n ^ few a c n))); last by rewrite leq_mul2l leq_mul2r two !orbT.
apply: (@leq_trans (n ^ b * (m.+1 + 1))); first by rewrite mulnDr addnC leq_add2l muln1.
by rewrite leq_mul2l; apply/orP; right; move: mf (p (few a c n)); lia.
Qed.
(* the virtual origins *)
Lemma origin_estimate : (n * (n ^ c + 4 * m.+1 * n ^ (2 * a + 3)) <= n ^ (few a c n + 2 * a + 9))%N.
Proof.
set y := (n ^ few a c n)%N; set z := (n ^ (2 * a + 4))%N; have my : (m <= y)%N by [].
have -> : (n ^ (few a c n + 2 * a + 9) = y * z * n ^ 5)%N by rewrite -!expnD; congr (_ ^ _)%N; lia.
have z9 : (9 <= n ^ 5)%N by apply: (@leq_trans (4 ^ 5)); rewrite // leq_exp2r.
have nz : (n * n ^ (2 * a + 3) = z)%N by rewrite -expnS -addnS.
have ny : (n * n ^ c <= y)%N.
  rewrite -expnS; apply: leq_pexp2l; first exact: leq_trans n4.
  rewrite /few; have : (1 <= n - 1)%N by rewrite subn_gt0 (leq_trans _ n4).
  move: (n - 1)%N => q q1; have : (c + 9 <= (c + 9) * q)%N by rewrite leq_pmulr.
  lia.
have yz : (y <= y * z)%N by rewrite leq_pmulr ?p.
have zy : (z <= y * z)%N by rewrite leq_pmull ?p.
have mz : (m.+1 * z <= 2 * (y * z))%N by rewrite mulnA leq_mul2r; apply/orP; right; move: my (p (few a c n)); rewrite -/y; lia.
have -> : (n * (n ^ c + 4 * m.+1 * n ^ (2 * a + 3)) = n * n ^ c + 4 * (m.+1 * z))%N by rewrite mulnDr -nz; lia.
apply: (@leq_trans (y * z * 9)); last by rewrite leq_mul2l z9 orbT.
move: ny yz mz; move: (n * n ^ c)%N (y * z)%N (m.+1 * z)%N => a' b c'; lia.
Qed.
End Estimates.
Lemma norm2_le (R : rcfType) n d (y : 'rV[R]_d) b : (d <= n ^ 2)%N -> 0 <= b -> (forall q, `|y 0 q| <= b) -> norm2 y <= n%:R * b.
Proof.
move=> dn b0 H; rewrite -(@ler_pexpn2r _ 2) ?nnegrE ?norm2_ge0 ?mulr_ge0 ?ler0n // norm2_sqr.
apply: (@le_trans _ _ (\sum_(q < d) b ^+ 2)).
  by apply: ler_sum => q _; rewrite -[y 0 q ^+ 2]real_normK ?num_real // ler_pexpn2r ?nnegrE.
rewrite sumr_const card_ord exprMn -[X in X <= _]mulr_natl; apply: ler_wpmul2r; first exact: sqr_ge0.
by rewrite -natrX ler_nat.
Qed.

(* ---- the claims ---- *)
Lemma below_power (R : rcfType) n h : (0 < n)%N -> (2 ^ h * n ^ (n ^ 4))%:R^-1 <= (n%:R ^+ (n ^ 4))^-1 :> R.
Proof. by move=> n0; rewrite -natrX lef_pinv ?posrE ?ltr0n ?muln_gt0 ?expn_gt0 ?n0 // ler_nat leq_pmull // expn_gt0. Qed.
Section Claims.
Variables (R : rcfType) (n d a c : nat) (x v : nat -> 'M[R]_(n, d)) (G : nat -> rel 'I_n) (w : nat -> 'I_n -> R).
Notation P t := (transition (G t) (w t)).
Hypothesis n4 : (4 <= n)%N.
Hypothesis a1 : (0 < a)%N.
Hypothesis acn : (a + c < n)%N.
(* the threshold, 2^hh times smaller than n^(-n^4) *)
Variable hh : nat.
Hypothesis h100 : (hh <= 100)%N.
Notation T := (2 ^ hh * n ^ (n ^ 4))%N.
Notation eps := (T%:R^-1 : R).
Hypothesis F : flock eps x v G w.
Hypothesis floor : forall t i j, (0 < t)%N -> 0 < P t i j -> (n%:R ^+ a)^-1 <= P t i j.
Hypothesis st : steady G w.
Hypothesis speed : forall i, norm2 (row i (v 1%N)) <= n%:R ^+ c.

Let n0 : (0 < n)%N. Proof. exact: leq_trans n4. Qed.
Let cn : (c < n)%N. Proof. by apply: leq_ltn_trans acn; rewrite leq_addl. Qed.
Lemma few_switches t : (N (changes G) t 1 <= n ^ few a c n)%N.
Proof.
apply: (@chazelle_switches.switches_at R n d a c eps x v G (from_one G w) _ (flock_from_one F)) => //; first by exact: leq_trans n4.
  exact: chazelle_estimates.below_smaller.
exact: (from_one_floor F a1 floor).
Qed.
(* chazelle.lem3.6.ii *)
Lemma edges_short t i j : G t i j -> norm2 (row i (x t) - row j (x t)) <= 1 + (n%:R ^+ (n ^ 3))^-1.
Proof.
move=> Gij; case: t Gij => [|t] Gij.
  have [G0 _ _ _ _] := F; move: Gij; rewrite G0 => /andP[_ h]; apply: (le_trans h); by rewrite ler_addl invr_ge0 exprn_ge0 ?ler0n.
have [t1 [_ _ H]] := edges_grow n4 a1 cn h100 F floor st speed (ltn0Sn t).
apply: le_trans (H _ _ Gij) _; rewrite -!addrA ler_add2l !addrA.
apply: le_trans (edge_estimate n4 acn (few_switches t.+1) R).
have below : eps <= (n%:R ^+ (n ^ 4))^-1.
  exact: below_power.
have pN : 0 <= n%:R ^+ (2 * a + 8) :> R by rewrite exprn_ge0 ?ler0n.
have up := ler_wpmul2r pN below.
apply: ler_add; first by apply: ler_add => //; exact: ler_wmuln2r.
apply: le_trans up; apply: le_trans (pace_sum R n4 a1 cn h100 (t.+1 - t1).+1); by rewrite big_ord_recl /= ler_addr pace_ge0.
Qed.
Lemma edges_short2 t i j : (0 < t)%N -> G t i j -> norm2 (row i (x t) - row j (x t)) <= 2%:R.
Proof.
move=> _ Gij; apply: le_trans (edges_short Gij) _; rewrite -[2%:R]/(1 + 1) ler_add2l invf_le1 ?exprn_gt0 ?ltr0n //.
by apply: exprn_ege1; rewrite ler1n.
Qed.

Hypothesis dn : (d <= n ^ 2)%N.
Hypothesis first : forall i q, `|x 0%N i q| <= n%:R ^+ c.
(* chazelle.lem3.7 *)
Lemma origin_le t i : (0 < t)%N -> norm2 (row i (x t) - t%:R *: row i (v t)) <= n%:R ^+ (few a c n + 2 * a + 9).
Proof.
have [_ _ MD Hx Hv] := F; move=> t0; set m := N (changes G) t.-1 1.
apply: le_trans (_ : _ <= n%:R * (n ^ c + 4 * m.+1 * n ^ (2 * a + 3))%:R) _; last first.
  by rewrite -natrM -natrX ler_nat; apply: origin_estimate => //; exact: few_switches.
apply: norm2_le => // q; rewrite !mxE natrD natrM !natrX natrM; have tt : (0 < t <= t)%N by rewrite t0 leqnn.
exact: (@origins_stay R n d a G w x v (fun u _ => flock_network F u) (fun u _ => @MD u) a1 floor st Hx Hv t (fun u i j h => @edges_short2 u i j (proj1 (andP h))) q t i (n%:R ^+ c) tt (fun k => first k q)).
Qed.
Lemma no_loss t i j : (T * (2 + 2 * n ^ (few a c n + 2 * a + 9)) + 2 <= t.+1)%N -> G t i j -> G t.+1 i j.
Proof.
have [_ _ _ Hx _] := F; move=> long Gij; apply: (flock_lasts F) => //.
have T0 : (0 < T)%N by rewrite muln_gt0 !expn_gt0 n0.
move: long; set M := (n ^ (few a c n + 2 * a + 9))%N => long.
have t0 : (0 < t)%N by move: long; rewrite addn2 ltnS; exact: leq_ltn_trans.
have tR : 0 < t%:R :> R by rewrite ltr0n.
pose E k : 'rV[R]_d := row k (x t.+1) - t.+1%:R *: row k (v t.+1).
have El k : norm2 (E k) <= M%:R by rewrite natrX; exact: origin_le.
have Ev : t%:R *: (row i (v t.+1) - row j (v t.+1)) = (row i (x t) - row j (x t)) + (E j - E i).
  apply/rowP=> q; rewrite /E !mxE Hx !mxE -addn1 natrD.
  by move: (x t i q) (x t j q) (v _ i q) (v _ j q) (t%:R : R) => y1 y2 v1 v2 s; ring.
have : t%:R * norm2 (row i (v t.+1) - row j (v t.+1)) <= (2 + 2 * M)%:R.
  rewrite -[t%:R]gtr0_norm // -norm2Z Ev; apply: le_trans (norm2D _ _) _; rewrite natrD; apply: ler_add; first exact: edges_short2.
  apply: le_trans (norm2D _ _) _; rewrite norm2N mul2n -addnn natrD; exact: ler_add.
rewrite mulrC -ler_pdivl_mulr // => /le_lt_trans; apply.
rewrite ltr_pdivr_mulr // ltr_pdivl_mull ?ltr0n // -natrM ltr_nat.
by move: long; rewrite addn2 ltnS.
Qed.
End Claims.

(* the threshold n^(-n^4) itself is the one with hh = 0 *)
Lemma threshold_zero (R : rcfType) n : (n%:R ^+ (n ^ 4))^-1 = (2 ^ 0 * n ^ (n ^ 4))%:R^-1 :> R.
Proof. by rewrite expn0 mul1n natrX. Qed.
(* beyond.chazelle.losses: an edge of time t is one of time t + 1, if t + 1 is at least that late *)
Theorem losses (R : rcfType) n d a (x v : nat -> 'M[R]_(n, d)) (G : nat -> rel 'I_n) (w : nat -> 'I_n -> R) :
  (4 <= n)%N -> (d <= n ^ 2)%N -> (1 <= a <= 2)%N ->
  flock (n%:R ^+ (n ^ 4))^-1 x v G w ->
  (forall t i j, (0 < t)%N -> 0 < transition (G t) (w t) i j -> (n%:R ^+ a)^-1 <= transition (G t) (w t) i j) ->
  (forall t, (0 < t)%N -> (forall i j, G t.+1 i j = G t i j) -> forall i, w t.+1 i = w t i) ->
  (forall i, norm2 (row i (v 1%N)) <= n%:R) -> (forall i q, `|x 0%N i q| <= n%:R) ->
  forall t i j, (n ^ (n ^ 4 + 2 * (n - 1) ^ 2 + 10 * (n - 1) + 17) <= t.+1)%N -> G t i j -> G t.+1 i j.
Proof.
move=> n4 dn /andP[a1 a2] F floor st speed first t i j late.
have floor2 u k l : (0 < u)%N -> 0 < transition (G u) (w u) k l -> (n%:R ^+ 2)^-1 <= transition (G u) (w u) k l.
  move=> u0 p; apply: le_trans (floor u k l u0 p); rewrite lef_pinv ?posrE ?exprn_gt0 ?ltr0n ?(leq_trans _ n4) //.
  by apply: ler_weexpn2l => //; rewrite ler1n (leq_trans _ n4).
rewrite threshold_zero in F; apply: (@no_loss R n d 2 1 x v G w n4 _ _ 0 _ F) => //; rewrite expn0 mul1n; apply: leq_trans (time_estimate n4 _) _ => //; apply: leq_trans late.
by rewrite /few eq_leq //; congr (_ ^ _)%N; lia.
Qed.

(* weights of a log2 n bits: fractions with denominators up to n^a *)
Lemma short_floor (R : realFieldType) n a (G : rel 'I_n) (c : 'I_n -> R) : network G -> model_D G c -> chazelle_products.short_weights a c ->
  forall i j, 0 < transition G c i j -> (n%:R ^+ a)^-1 <= transition G c i j.
Proof.
move=> net MD [p [q W]] i j; have [_ irr] := net; rewrite transitionE //.
have [E q0 qa] := W i; have qR : 0 < (q i)%:R :> R by rewrite ltr0n.
have na : (0 < n ^ a)%N by exact: leq_trans q0 qa.
have fl (k : nat) : (0 < k)%N -> (n%:R ^+ a)^-1 <= k%:R / (q i)%:R :> R.
  move=> k0; apply: (@le_trans _ _ (q i)%:R^-1); first by rewrite -natrX lef_pinv ?posrE ?ltr0n // ler_nat.
  by rewrite ler_pmull ?invr_gt0 // ler1n.
case: (i =P j) => _; last case: (G i j); rewrite ?ltxx // E; last first.
  by move=> h; apply: fl; move: h; rewrite pmulr_lgt0 ?invr_gt0 // ltr0n.
set d := degree G i => h.
have D : 1 - (p i)%:R / (q i)%:R * d%:R = ((q i)%:R - (p i * d)%:R) / (q i)%:R :> R.
  by rewrite natrM mulrBl mulfV ?gt_eqF // mulrAC.
move: h; rewrite D pmulr_lgt0 ?invr_gt0 // subr_gt0 ltr_nat => h.
by rewrite -natrB ?(ltnW h) //; apply: fl; rewrite subn_gt0.
Qed.

(* chazelle.lem3.6.ii, lem3.7 (the virtual origins) and lem3.8: weights of O(log n) bits, that is fractions with denominators up to n^a,
   which change only when the network does, and lengths up to n^c: for all n >= 4 with n > a + c *)
Section Printed.
Variables (R : rcfType) (n d a c : nat) (x v : nat -> 'M[R]_(n, d)) (G : nat -> rel 'I_n) (w : nat -> 'I_n -> R).
Hypothesis n4 : (4 <= n)%N.
Hypothesis a1 : (0 < a)%N.
Hypothesis acn : (a + c < n)%N.
Variable hh : nat.
Hypothesis h100 : (hh <= 100)%N.
Hypothesis F : flock (2 ^ hh * n ^ (n ^ 4))%:R^-1 x v G w.
Hypothesis bits : forall t, (0 < t)%N -> chazelle_products.short_weights a (w t).
Hypothesis st : forall t, (0 < t)%N -> (forall i j, G t.+1 i j = G t i j) -> forall i, w t.+1 i = w t i.
Hypothesis speed : forall i, norm2 (row i (v 1%N)) <= n%:R ^+ c.
Let floor t i j : (0 < t)%N -> 0 < transition (G t) (w t) i j -> (n%:R ^+ a)^-1 <= transition (G t) (w t) i j.
Proof. by move=> t0; have [_ _ MD _ _] := F; exact: (short_floor (flock_network F t) (MD t) (bits t0)). Qed.
Lemma short_at t i j : 1 + (n%:R ^+ (n ^ 3))^-1 < norm2 (row i (x t) - row j (x t)) -> ~~ G t i j.
Proof.
by move=> far; apply: contraTN far => Gij; rewrite -leNgt; exact: (edges_short n4 a1 acn h100 F floor st speed).
Qed.
Lemma lasting_at : (d <= n ^ 2)%N -> (forall i q, `|x 0%N i q| <= n%:R ^+ c) ->
  forall t i j, (n ^ (2 * n ^ 4) <= t.+1)%N -> G t i j -> G t.+1 i j.
Proof.
move=> dn first t i j late; apply: (no_loss n4 a1 acn h100 F floor st speed dn first); apply: leq_trans late; exact: time_room.
Qed.
Lemma origins_at : (d <= n ^ 2)%N -> (forall i q, `|x 0%N i q| <= n%:R ^+ c) ->
  forall t i, (0 < t)%N -> norm2 (row i (x t) - t%:R *: row i (v t)) <= n%:R ^+ (a * (n - 1) ^ 2 + (c + 9) * (n - 1) + 2 * a + 10).
Proof.
move=> dn first t i t0; have -> : (a * (n - 1) ^ 2 + (c + 9) * (n - 1) + 2 * a + 10 = few a c n + 2 * a + 9)%N by rewrite /few; lia.
exact: (origin_le n4 a1 acn h100 F floor st speed dn first).
Qed.
End Printed.
(* the three with the threshold n^(-n^4), and with one up to 2^100 times smaller (chazelle.hyst.remark) *)
Section Thresholds.
Variables (R : rcfType) (n d a c : nat) (x v : nat -> 'M[R]_(n, d)) (G : nat -> rel 'I_n) (w : nat -> 'I_n -> R).
Hypothesis n4 : (4 <= n)%N.
Hypothesis a1 : (0 < a)%N.
Hypothesis acn : (a + c < n)%N.
Hypothesis F : flock (n%:R ^+ (n ^ 4))^-1 x v G w.
Let F0 : flock (2 ^ 0 * n ^ (n ^ 4))%:R^-1 x v G w. Proof. by rewrite -threshold_zero. Qed.
Hypothesis bits : forall t, (0 < t)%N -> chazelle_products.short_weights a (w t).
Hypothesis st : forall t, (0 < t)%N -> (forall i j, G t.+1 i j = G t i j) -> forall i, w t.+1 i = w t i.
Hypothesis speed : forall i, norm2 (row i (v 1%N)) <= n%:R ^+ c.
Theorem smaller_threshold : forall h, (h <= 100)%N -> flock ((2%:R ^+ h)^-1 * (n%:R ^+ (n ^ 4))^-1) x v G w ->
  [/\ forall t, (N (changes G) t 1 <= n ^ (a * (n - 1) ^ 2 + (c + 9) * (n - 1) + 1))%N,
      forall t i j, 1 + (n%:R ^+ (n ^ 3))^-1 < norm2 (row i (x t) - row j (x t)) -> ~~ G t i j &
      (d <= n ^ 2)%N -> (forall i q, `|x 0%N i q| <= n%:R ^+ c) ->
        (forall t i, (0 < t)%N -> norm2 (row i (x t) - t%:R *: row i (v t)) <= n%:R ^+ (a * (n - 1) ^ 2 + (c + 9) * (n - 1) + 2 * a + 10)) /\
        forall t i j, (n ^ (2 * n ^ 4) <= t.+1)%N -> G t i j -> G t.+1 i j].
Proof.
move=> h h100; have -> : (2%:R ^+ h)^-1 * (n%:R ^+ (n ^ 4))^-1 = (2 ^ h * n ^ (n ^ 4))%:R^-1 :> R by rewrite natrM !natrX invfM.
move=> K; split.
- move=> t; apply: (few_switches n4 a1 h100 K) => //.
  move=> u i j u0; have [_ _ MD _ _] := K; exact: (short_floor (flock_network K u) (MD u) (bits u0)).
- exact: (short_at n4 a1 acn h100 K bits st speed).
move=> dn first; split; first exact: (origins_at n4 a1 acn h100 K bits st speed dn first).
exact: (lasting_at n4 a1 acn h100 K bits st speed dn first).
Qed.
Theorem lemma_3_6_ii t i j : 1 + (n%:R ^+ (n ^ 3))^-1 < norm2 (row i (x t) - row j (x t)) -> ~~ G t i j.
Proof. exact: (short_at n4 a1 acn (leq0n 100) F0 bits st speed). Qed.
Theorem lemma_3_8 : (d <= n ^ 2)%N -> (forall i q, `|x 0%N i q| <= n%:R ^+ c) ->
  forall t i j, (n ^ (2 * n ^ 4) <= t.+1)%N -> G t i j -> G t.+1 i j.
Proof. exact: (lasting_at n4 a1 acn (leq0n 100) F0 bits st speed). Qed.
Theorem lemma_3_7_origins : (d <= n ^ 2)%N -> (forall i q, `|x 0%N i q| <= n%:R ^+ c) ->
  forall t i, (0 < t)%N -> norm2 (row i (x t) - t%:R *: row i (v t)) <= n%:R ^+ (a * (n - 1) ^ 2 + (c + 9) * (n - 1) + 2 * a + 10).
Proof. exact: (origins_at n4 a1 acn (leq0n 100) F0 bits st speed). Qed.
End Thresholds.
(* chazelle.lem3.6.i: for every threshold, in every dimension *)
Theorem within_unit (R : rcfType) n d (eps : R) (x v : nat -> 'M[R]_(n, d)) (G : nat -> rel 'I_n) (w : nat -> 'I_n -> R) :
  flock eps x v G w -> forall t i j, i != j -> norm2 (row i (x t) - row j (x t)) <= 1 -> G t i j.
Proof. by move=> [G0 GS _ _ _] [|t] i j ij near; rewrite ?G0 ?GS ij near. Qed.
