(* Chazelle, Lemma 3.7 sharpened: the virtual origins x_i(t) - t v_i(t) on a stretch of one network, for chazelle_losses.v, which
   bounds them by the number of switches.  No axioms. *)
Set Warnings "-notation-overridden,-ambiguous-paths".
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import ring zify.
From Flockproof Require Import chazelle_model chazelle_ergodicity chazelle_fixed chazelle_network chazelle_sharp.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Import GRing.Theory Num.Theory Order.Theory.
Local Open Scope ring_scope.

Section Sums.
Variable R : realFieldType.
(* a sequence with values up to 2 that is below 2 mu^(r - h) from h on *)
Lemma geometric (mu : R) s : 0 <= mu < 1 -> \sum_(r < s) mu ^+ r <= (1 - mu)^-1.
Proof.
case/andP=> m0 m1; have p : 0 < 1 - mu by rewrite subr_gt0.
rewrite -(ler_pmul2r p) mulVf ?gt_eqF //.
have -> : (\sum_(r < s) mu ^+ r) * (1 - mu) = 1 - mu ^+ s.
  elim: s => [|s IH]; first by rewrite big_ord0 mul0r expr0 subrr.
  by rewrite big_ord_recr /= mulrDl IH exprS; ring.
by rewrite ler_subl_addr ler_addl exprn_ge0.
Qed.
Lemma tail_sum (B : nat -> R) (mu : R) h s : 0 <= mu < 1 -> (forall r, B r <= 2%:R) -> (forall r, B (h + r)%N <= 2%:R * mu ^+ r) ->
  (forall r, 0 <= B r) -> \sum_(r < s) B r <= (2 * h)%:R + 2%:R / (1 - mu).
Proof.
move=> m01 B2 Bm B0.
have m1 : 0 < 1 - mu by case/andP: m01 => _; rewrite subr_gt0.
have first k : \sum_(r < k) B r <= (2 * k)%:R.
  apply: (@le_trans _ _ (\sum_(r < k) 2%:R)); first by apply: ler_sum => r _.
  by rewrite sumr_const card_ord -mulrnA.
case: (leqP s h) => [sh|hs].
  apply: (le_trans (first s)); apply: (@le_trans _ _ (2 * h)%:R); first by rewrite ler_nat leq_mul2l.
  by rewrite ler_addl divr_ge0 ?ler0n // ltW.
have -> : s = (h + (s - h))%N by rewrite subnKC // ltnW.
rewrite -(big_mkord xpredT B) (@big_cat_nat _ _ _ h) ?leq_addr //= big_mkord.
apply: ler_add; first exact: first.
rewrite -{1}[h]add0n big_addn addKn big_mkord.
apply: (@le_trans _ _ (\sum_(r < s - h) 2%:R * mu ^+ r)); first by apply: ler_sum => r _; rewrite addnC.
by rewrite -mulr_sumr; apply: ler_wpmul2l; rewrite ?ler0n // geometric.
Qed.
End Sums.

(* ---- one fixed network ---- *)
Section Fixed.
Variables (R : realFieldType) (n a : nat) (G : rel 'I_n) (c : 'I_n -> R).
Hypothesis net : network G.
Hypothesis MD : model_D G c.
Hypothesis a1 : (0 < a)%N.
Notation P := (transition G c).
Notation N := (n%:R : R).
(* positive entries of P are at least n^-a *)
Hypothesis floor : forall i j, 0 < P i j -> (N ^+ a)^-1 <= P i j.
Let SP : stochastic P. Proof. by case: (model_D_stochastic net MD). Qed.
Let diag i : 0 < P i i. Proof. by case: (model_D_stochastic net MD). Qed.

Implicit Types u : 'I_n -> R.

Lemma part_degree i0 i : (0 < degree G i0)%N -> connect G i0 i -> (0 < degree G i)%N.
Proof.
have [sym irr] := net; move=> d0 /connectP[p pth ->]; elim: p i0 d0 pth => [|j p IH] i0 d0 //= /andP[Gij pth].
by apply: (IH j) => //; apply: (@edge_degree _ _ _ i0); rewrite sym.
Qed.
Lemma part_closed i0 i j : G i j -> connect G i0 i = connect G i0 j.
Proof.
have [sym irr] := net; move=> Gij; apply/idP/idP => h; apply: (connect_trans h); apply: connect1 => //; by rewrite sym.
Qed.
Lemma part_connected i0 i j : connect G i0 i -> connect G i0 j -> connect G i j.
Proof. by have [sym irr] := net; move=> h1 h2; apply: connect_trans h2; rewrite (@sym_connect_sym _ _ sym). Qed.
Lemma part_weight i0 i : (0 < degree G i0)%N -> connect G i0 i -> 0 < c i.
Proof.
move=> d0 h; have di := part_degree d0 h; have /andP[+ _] := MD di.
by rewrite pmulr_lgt0 ?ltr0n.
Qed.

(* what one step takes from a position: bounded, centred on every part, zero for a bird alone *)
Variable u : 'I_n -> R.
Hypothesis u_le : forall i, `|u i| <= 2%:R.
Hypothesis u_centred : forall i0 : 'I_n, (0 < degree G i0)%N -> centred c (connect G i0) u.
Hypothesis u_alone : forall i : 'I_n, degree G i = 0%N -> u i = 0.

Lemma after_le r i : `|after G c r u i| <= 2%:R.
Proof.
rewrite /after; apply: le_trans (ler_norm_sum _ _ _) _; have [A0 A1] := stochastic_mpow r SP.
rewrite -[X in _ <= X]mul1r -{1}(A1 i) mulr_suml; apply: ler_sum => j _.
by rewrite normrM ger0_norm ?A0 //; apply: ler_wpmul2l.
Qed.
Lemma after_alone r i : degree G i = 0%N -> after G c r u i = 0.
Proof.
move=> d0; elim: r => [|r IH]; first by rewrite after0 u_alone.
have no j : G i j = false by apply: contraTF (eqxx (0 : R)) => h; have := edge_degree h; rewrite d0.
rewrite afterS; have := drive_drop c net (after G c r u) i; rewrite big1 ?mulr0 => [|j _]; last by rewrite no mul0r.
by move/eqP; rewrite subr_eq0 => /eqP <-.
Qed.
Let mu : R := 1 - 4%:R / N ^+ (a + 2).
Lemma after_small r i : (0 < degree G i)%N -> 0 < mu < 1 /\ after G c r u i ^+ 2 <= 4%:R * N ^+ a.+1 * mu ^+ (2 * r).
Proof.
move=> di; have n2 : (1 < n)%N.
  have /card_gt0P[j] := di; rewrite inE => Gij; have [_ irr] := net.
  have ij : i != j by apply: contraTneq Gij => ->; rewrite irr.
  by case: (n) i j ij {di Gij} => [[]//|[|//]] i j; rewrite (ord1 i) (ord1 j) eqxx.
have N0 k : 0 < N ^+ k by rewrite exprn_gt0 // ltr0n ltnW.
have M8 : (8 <= n ^ (a + 2))%N by apply: (@leq_trans (2 ^ 3)); rewrite // (@leq_trans (2 ^ (a + 2))) ?leq_exp2l ?leq_exp2r //; move: a1; lia.
have M4 : 4%:R < N ^+ (a + 2) by rewrite -natrX ltr_nat (leq_trans _ M8).
have m0 : 0 < mu by rewrite subr_gt0 ltr_pdivr_mulr // mul1r.
have m1 : mu < 1 by rewrite ltr_subl_addr ltr_addl divr_gt0 ?ltr0n.
split; first by rewrite m0.
pose K : pred 'I_n := connect G i; have Cl : forall k l, G k l -> K k = K l by move=> k l; exact: part_closed.
have Cn k l : K k -> K l -> connect G k l by exact: part_connected.
have Cp j : K j -> 0 < c j by exact: part_weight di.
have inv j : K j -> 1 <= (c j)^-1 <= N ^+ a.
  move=> Kj; have cj := Cp j Kj; have dj := part_degree di Kj; have /andP[_ cd] := MD dj.
  have /card_gt0P[k] := dj; rewrite inE => Gjk; have [_ irr] := net.
  have jk : j != k by apply: contraTneq Gjk => ->; rewrite irr.
  have Pjk : P j k = c j by rewrite transitionE // (negbTE jk) Gjk.
  have := @floor j k; rewrite Pjk => /(_ cj) fl; apply/andP; split.
    rewrite invr_ge1 ?unitfE ?gt_eqF //; apply: ltW; apply: le_lt_trans cd; by rewrite ler_pmulr // ler1n.
  by rewrite -[N ^+ a]invrK lef_pinv ?posrE ?invr_gt0.
have tot : total c K <= N ^+ a.+1.
  rewrite exprS; apply: (@le_trans _ _ (\sum_(j < n) N ^+ a)); last by rewrite sumr_const card_ord mulr_natl.
  by apply: ler_sum => j _; rewrite /weigh; case: ifP => Kj; [have /andP[] := inv j Kj | rewrite ltW].
have gp : total c K * n.-1%:R * (1 - mu) <= 4%:R.
  rewrite subKr mulrCA -[X in _ <= X]mulr1; apply: ler_wpmul2l; rewrite ?ler0n //.
  rewrite ler_pdivr_mulr // mul1r addn2 -[X in _ <= N ^+ X]addn1 exprD expr1.
  apply: ler_pmul; rewrite ?ler0n //; last by rewrite ler_nat leq_pred.
  by apply: sumr_ge0 => j _; exact: weigh_ge0.
have dg j : K j -> 1 - mu <= (1 - c j * (degree G j)%:R) *+ 2.
  move=> Kj; have [_ irr] := net; have Pjj : P j j = 1 - c j * (degree G j)%:R by rewrite transitionE // eqxx.
  rewrite -Pjj subKr; have fl := floor (diag j).
  apply: (@le_trans _ _ (P j j)); last by rewrite mulr2n ler_addl ltW.
  apply: le_trans fl; rewrite exprD invfM mulrA -[X in _ <= X]mul1r mulrAC; apply: ler_wpmul2r; first by rewrite invr_ge0 ltW.
  by rewrite ler_pdivr_mulr // mul1r -natrX ler_nat (@leq_trans (2 ^ 2)) // leq_exp2r.
have := decays net Cl Cn Cp m0 gp dg (fun j Kj => proj1 (andP (inv j Kj))) r (u_centred di) (fun j _ => u_le j) (connect0 G i : K i).
rewrite mul1r => h; apply: le_trans h _; apply: ler_wpmul2r; first by rewrite exprn_ge0 // ltW.
rewrite mulrC; have -> : 2%:R ^+ 2 = 4%:R :> R by rewrite -natrX.
by apply: ler_wpmul2l; rewrite ?ler0n.
Qed.
(* all that a run of one network adds *)
Definition span_bound : R := 4%:R * N ^+ (2 * a + 3).
Definition bound (r : nat) : R := let h := (n ^ (a + 2) * n ^ a.+1)%N in if (r < h)%N then 2%:R else 2%:R * mu ^+ (r - h).
Lemma after_bound r i : (0 < degree G i)%N -> `|after G c r u i| <= bound r.
Proof.
move=> di; rewrite /bound; set h := (_ * _)%N; case: ltnP => hr; first exact: after_le.
have [/andP[m0 m1] sm] := after_small r di.
have n0 : (0 < n)%N by exact: leq_ltn_trans (leq0n _) (ltn_ord i).
have Mp : (0 < n ^ (a + 2))%N by rewrite expn_gt0 n0.
have half : mu ^+ (n ^ (a + 2)) <= 2%:R^-1.
  have := @halving R (n ^ (a + 2)) (n ^ (a + 2)) Mp; rewrite divnn Mp expr1 => hv; apply: le_trans hv.
  have y : mu <= 1 - (n ^ (a + 2))%:R^-1.
    rewrite ler_add2l ler_opp2 natrX -[X in X <= _]mul1r; apply: ler_wpmul2r; first by rewrite invr_ge0 exprn_ge0 ?ler0n.
    by rewrite ler1n.
  by apply: ler_expn2r; rewrite ?nnegrE ?(ltW m0) // (le_trans (ltW m0)).
have one : N ^+ a.+1 * mu ^+ (2 * h) <= 1.
  set q := (n ^ a.+1)%N; have -> : (2 * h = n ^ (a + 2) * (2 * q))%N by rewrite /h mulnCA.
  rewrite exprM; apply: (@le_trans _ _ (q%:R * 2%:R^-1 ^+ (2 * q))).
    rewrite /q natrX; apply: ler_wpmul2l; first by rewrite exprn_ge0 ?ler0n.
    by apply: ler_expn2r; rewrite ?nnegrE ?exprn_ge0 ?invr_ge0 ?ler0n // ltW.
  rewrite exprVn ler_pdivr_mulr ?exprn_gt0 ?ltr0n // mul1r -natrX ler_nat.
  apply: (leq_trans (ltnW (ltn_expl q (ltnSn 1)))); by rewrite leq_exp2l // leq_pmull.
rewrite -(@ler_pexpn2r _ 2) ?nnegrE ?normr_ge0 ?mulr_ge0 ?exprn_ge0 ?ler0n ?(ltW m0) // real_normK ?num_real //.
apply: le_trans sm _; set k := (r - h)%N; have -> : (2 * r = 2 * h + 2 * k)%N by rewrite -mulnDr /k subnKC.
have -> : 4%:R * N ^+ a.+1 * mu ^+ (2 * h + 2 * k) = (N ^+ a.+1 * mu ^+ (2 * h)) * (4%:R * mu ^+ (2 * k)).
  by rewrite exprD; move: (N ^+ a.+1) (mu ^+ (2 * h)) (mu ^+ (2 * k)) => x y z; ring.
have -> : (2%:R * mu ^+ k) ^+ 2 = 4%:R * mu ^+ (2 * k) by rewrite exprMn -exprM [(k * 2)%N]mulnC -[2%:R ^+ 2]natrX.
rewrite -[X in _ <= X]mul1r; apply: ler_wpmul2r => //; by rewrite mulr_ge0 ?ler0n // exprn_ge0 // ltW.
Qed.
Lemma bound_ge0 r i : (0 < degree G i)%N -> 0 <= bound r.
Proof. move=> di; exact: le_trans (normr_ge0 _) (after_bound r di). Qed.
Lemma bound_sum s i : (0 < degree G i)%N -> \sum_(r < s) bound r <= span_bound.
Proof.
move=> di; have [/andP[m0 m1] _] := after_small 0 di; set h := (n ^ (a + 2) * n ^ a.+1)%N.
have n0 : (0 < n)%N by exact: leq_ltn_trans (leq0n _) (ltn_ord i).
have m01 : 0 <= mu < 1 by rewrite ltW.
apply: le_trans (_ : _ <= (2 * h)%:R + 2%:R / (1 - mu)) _.
  apply: (@tail_sum R bound mu h s m01) => r.
  - rewrite /bound -/h; case: ifP => // _; rewrite -[X in _ <= X]mulr1; apply: ler_wpmul2l; rewrite ?ler0n //.
    by apply: exprn_ile1; apply: ltW.
  - by rewrite /bound -/h ltnNge leq_addr /= addKn.
  exact: bound_ge0 di.
have -> : 2%:R / (1 - mu) = (n ^ (a + 2))%:R / 2%:R.
  rewrite subKr invf_div natrX mulrCA; congr (_ * _); apply: (mulfI (_ : 4%:R != 0)); rewrite ?pnatr_eq0 // mulrCA mulfV ?pnatr_eq0 // mulr1.
  by rewrite -[4%:R]/(2 * 2)%:R natrM mulfK ?pnatr_eq0.
have hM : (n ^ (2 * a + 3) = h)%N by rewrite /h -expnD; congr (_ ^ _)%N; lia.
rewrite /span_bound -natrX hM; apply: (@le_trans _ _ ((2 * h)%:R + (n ^ (a + 2))%:R)).
  rewrite ler_add2l ler_pdivr_mulr ?ltr0n // ler_pemulr ?ler0n // ler1n //.
rewrite -natrD -natrM ler_nat.
have : (n ^ (a + 2) <= h)%N by rewrite /h leq_pmulr // expn_gt0 n0.
lia.
Qed.
End Fixed.

(* ---- the flock ---- *)
Lemma pred_sub s k : (k < s)%N -> (s - k = (s.-1 - k).+1)%N.
Proof. by case: s => // s h; rewrite subSn. Qed.
Lemma rev_index s k : (k < s)%N -> (s.-1 - (s - k.+1) = k)%N.
Proof. by case: s => // s; rewrite ltnS => h; rewrite subSS subKn. Qed.
Lemma one_step (R : comRingType) (y z A B : R) : y + B - (z + 1%:R) * B = A - z * B + (y - A).
Proof. ring. Qed.
Section Flock.
Variables (R : rcfType) (n d a : nat) (G : nat -> rel 'I_n) (c : nat -> 'I_n -> R) (x v : nat -> 'M[R]_(n, d)).
Notation P t := (transition (G t) (c t)).
Hypothesis net : forall t, (0 < t)%N -> network (G t).
Hypothesis MD : forall t, (0 < t)%N -> model_D (G t) (c t).
Hypothesis a1 : (0 < a)%N.
Hypothesis floor : forall t i j, (0 < t)%N -> 0 < P t i j -> (n%:R ^+ a)^-1 <= P t i j.
Hypothesis Hx : forall t, x t.+1 = x t + v t.+1.
Hypothesis Hv : forall t, (0 < t)%N -> v t.+1 = P t *m v t.
Variable T : nat.
Hypothesis short : forall t i j, (0 < t < T)%N -> G t i j -> norm2 (row i (x t) - row j (x t)) <= 2%:R.
Variable q : 'I_d.

(* the virtual origins: E_i(t) = x_i(t) - t v_i(t) *)
Definition origin (t : nat) (i : 'I_n) : R := x t i q - t%:R * v t i q.
Definition taken (t : nat) (i : 'I_n) : R := x t i q - drive (G t) (c t) (fun j => x t j q) i.

Lemma coordinate (y : 'rV[R]_d) : `|y 0 q| <= norm2 y.
Proof.
rewrite -(@ler_pexpn2r _ 2) ?nnegrE ?normr_ge0 ?norm2_ge0 // real_normK ?num_real // norm2_sqr (bigD1 q) //= ler_addl.
by apply: sumr_ge0 => k _; exact: sqr_ge0.
Qed.
Lemma taken_sum t i : (0 < t)%N -> taken t i = c t i * \sum_j (G t i j)%:R * (x t i q - x t j q).
Proof. by move=> t0; exact: (drive_drop (c t) (net t0) (fun j => x t j q) i). Qed.
Lemma taken_alone t i : (0 < t)%N -> degree (G t) i = 0%N -> taken t i = 0.
Proof.
move=> t0 d0; rewrite taken_sum // big1 ?mulr0 // => j _; case h: (G t i j); last by rewrite mul0r.
by have := edge_degree h; rewrite d0.
Qed.
Lemma taken_le t i : (0 < t < T)%N -> `|taken t i| <= 2%:R.
Proof.
move=> tT; have /andP[t0 _] := tT; case: (posnP (degree (G t) i)) => [d0|dp]; first by rewrite taken_alone // normr0 ler0n.
have /andP[cd0 cd1] := MD t0 dp; have ci : 0 < c t i by rewrite pmulr_lgt0 ?ltr0n in cd0.
rewrite taken_sum // normrM gtr0_norm //.
apply: (@le_trans _ _ (c t i * ((degree (G t) i)%:R * 2%:R))).
  apply: ler_wpmul2l; first exact: ltW.
  rewrite degree_sum mulr_suml; apply: le_trans (ler_norm_sum _ _ _) _; apply: ler_sum => j _.
  case h: (G t i j); last by rewrite !mul0r normr0.
  rewrite !mul1r; apply: le_trans (short tT h); have := coordinate (row i (x t) - row j (x t)); by rewrite !mxE.
by rewrite mulrA -[X in _ <= X]mul1r; apply: ler_wpmul2r; [rewrite ler0n | exact: ltW].
Qed.
Lemma taken_centred t i0 : (0 < t)%N -> (0 < degree (G t) i0)%N -> centred (c t) (connect (G t) i0) (taken t).
Proof.
move=> t0 d0; apply: (drop_centred (net t0)) => [i j h|i h]; first exact: (part_closed (net t0) i0 h).
exact: (part_weight (net t0) (MD t0) d0 h).
Qed.
Lemma origin_first i : origin 1 i = x 0%N i q.
Proof. by rewrite /origin Hx mxE mul1r addrK. Qed.
Lemma origin_next t i : (0 < t)%N -> origin t.+1 i = drive (G t) (c t) (origin t) i + taken t i.
Proof.
move=> t0; rewrite /origin /taken Hx Hv // mxE /drive.
have -> : (P t *m v t) i q = \sum_j P t i j * v t j q by rewrite mxE.
have -> : \sum_j P t i j * (x t j q - t%:R * v t j q) = \sum_j P t i j * x t j q - t%:R * \sum_j P t i j * v t j q.
  by rewrite mulr_sumr -sumrB; apply: eq_bigr => j _; move: (P t i j) => y; ring.
rewrite -addn1 natrD; set A := \sum_j P t i j * x t j q; set B := \sum_j P t i j * v t j q; exact: one_step.
Qed.
(* s steps on one network *)
Lemma run_sum t0 s i : (0 < t0)%N -> (forall r, (r < s)%N -> P (t0 + r) = P t0) ->
  origin (t0 + s) i = after (G t0) (c t0) s (origin t0) i + \sum_(r < s) after (G t0) (c t0) (s.-1 - r) (taken (t0 + r)) i.
Proof.
move=> p; elim: s i => [|s IH] i H; first by rewrite addn0 after0 big_ord0 addr0.
have IH' j := IH j (fun r h => H r (leq_trans h (leqnSn s))).
rewrite addnS origin_next ?addn_gt0 ?p // /drive (H s (ltnSn s)) afterS big_ord_recr /= subnn after0 addrA; congr (_ + _).
rewrite (eq_bigr (fun j => P t0 i j * after (G t0) (c t0) s (origin t0) j
   + \sum_(r < s) P t0 i j * after (G t0) (c t0) (s.-1 - r) (taken (t0 + r)) j)) => [|j _]; last by rewrite IH' mulrDr; congr (_ + _); exact: mulr_sumr.
rewrite big_split /=; congr (_ + _); rewrite exchange_big /=; apply: eq_bigr => r _.
rewrite (pred_sub (ltn_ord r)).
by rewrite afterS.
Qed.
End Flock.
