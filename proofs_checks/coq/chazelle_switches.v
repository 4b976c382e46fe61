(* Chazelle, Lemma 3.1 and Theorem 1.1 for model D, sharpened: the number of network switches of a flock.
     beyond.chazelle.switches, chazelle.lem3.1, chazelle.thm1.1.switches (clause 1); beyond.chazelle.lem3.1.count.
   Cut time into windows that end as soon as the union of the networks in them is connected.  Inside a window a
   set of birds meets no others, so that it and the rest are smaller groups: induction.  After k (m-1) windows the
   velocities of m birds are so near each other that the hysteresis rule keeps every edge.  (The paper follows
   stabilisers instead of windows; the recursion is the same or smaller.)  Any real closed field, no axioms. *)
Set Warnings "-notation-overridden,-ambiguous-paths".
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import ring zify.
From Flockproof Require Import chazelle_model chazelle_ergodicity chazelle_products chazelle_recurrent chazelle_agreement
  chazelle_stabilisers chazelle_contraction chazelle_count chazelle_estimates.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Import GRing.Theory Num.Theory Order.Theory.
Local Open Scope ring_scope.

(* ---- counting: N c t s is the number of u with s < u <= t and c u ---- *)
Lemma N_next c t s : (N c t.+1 s <= N c t s + 1)%N.
Proof.
case: (leqP s t) => st; last by rewrite /N (_ : t.+1 - s = 0)%N //; move: st; lia.
by rewrite (N_split c st (leqnSn t)) leq_add2l N_step.
Qed.
Lemma N_empty c t s : (t <= s)%N -> N c t s = 0%N.
Proof. by move=> ts; rewrite /N (_ : t - s = 0)%N //; move: ts; lia. Qed.

Lemma count_in (a b : pred nat) r : (forall u, u \in r -> a u -> b u) -> (count a r <= count b r)%N.
Proof.
elim: r => //= u r IH h; apply: leq_add; last by apply: IH => q qr; apply: h; rewrite in_cons qr orbT.
by case au: (a u) => //; rewrite h ?mem_head.
Qed.

(* pairs of birds *)
Lemma card_pairs n : #|[set p : 'I_n * 'I_n | (p.1 < p.2)%N]| = 'C(n, 2).
Proof.
rewrite cardsE -sum1_card big_mkcond /= -(pair_bigA _ (fun i j : 'I_n => if (i < j)%N then 1%N else 0%N)) /=.
rewrite exchange_big /= -triangular_sum [RHS]big_mkord; apply: eq_bigr => j _.
by rewrite -big_mkcond /= -(big_ord_widen n (fun _ => 1%N) (ltnW (ltn_ord j))) sum1_card card_ord.
Qed.

(* a network that loses no edge changes at most once for every pair *)
Lemma growing n (G : nat -> rel 'I_n) e T : (forall t, network (G t)) ->
  (forall t i j, (e <= t)%N -> G t i j -> G t.+1 i j) -> (N (changes G) T e <= 'C(n, 2))%N.
Proof.
move=> net up; pose E t := [set p : 'I_n * 'I_n | (p.1 < p.2)%N && G t p.1 p.2].
have below t : (#|E t| <= 'C(n, 2))%N.
  by rewrite -card_pairs; apply: subset_leq_card; apply/subsetP=> p; rewrite !inE => /andP[].
have key q : (N (changes G) (e + q) e + #|E e| <= #|E (e + q)%N|)%N.
  elim: q => [|q IH]; first by rewrite addn0 N_empty.
  rewrite addnS (N_split _ (leq_addr q e) (leqnSn _)).
  have sub : E (e + q)%N \subset E (e + q).+1.
    by apply/subsetP=> p; rewrite !inE => /andP[-> /=]; apply: up; exact: leq_addr.
  have -> : N (changes G) (e + q).+1 (e + q) = changes G (e + q).+1.
    by rewrite /N subSn // subnn /= addn0.
  case ch: (changes G (e + q).+1); last by rewrite addn0; apply: leq_trans IH (subset_leq_card sub).
  rewrite addnAC addn1; apply: leq_ltn_trans IH _; apply: proper_card.
  rewrite properEneq sub andbT; apply/eqP=> same.
  case/existsP: ch => i /existsP[j]; apply/negP; rewrite negbK /=; apply/eqP.
  have lt (a b : 'I_n) : (a < b)%N -> G (e + q).+1 a b = G (e + q)%N a b.
    by move=> ab; have := congr1 (fun X : {set 'I_n * 'I_n} => (a, b) \in X) same; rewrite !inE /= ab.
  case: (ltngtP i j) => [/lt //|/lt|/val_inj ->].
    by have [s1 _] := net (e + q).+1; have [s2 _] := net (e + q)%N; rewrite s1 => ->; rewrite s2.
  by have [_ i1] := net (e + q).+1; have [_ i2] := net (e + q)%N; rewrite i1 i2.
have [Te|/ltnW eT] := leqP T e; first by rewrite N_empty.
rewrite -(subnKC eT); apply: leq_trans (leq_addr _ _) (leq_trans (key _) (below _)).
Qed.

(* ---- groups of birds ---- *)
Section Groups.
Variables (R : realFieldType) (d : nat) (len : 'rV[R]_d -> R) (alpha eps D : R).
Hypothesis len0 : len 0 = 0.
Hypothesis lenZ : forall a x, len (a *: x) = `|a| * len x.
Hypothesis lenD : forall x y, len (x + y) <= len x + len y.
Hypothesis alpha0 : 0 < alpha.

(* what is needed of m birds from time 1 on: an edge lasts where the difference of velocities is below eps *)
Record group m (P : nat -> 'M[R]_m) (v : nat -> 'M[R]_(m, d)) (G : nat -> rel 'I_m) : Prop := Group {
  g_net : forall t, network (G t);
  g_stoch : forall t, stochastic (P t);
  g_foot : forall t i j, (P t i j != 0) = (i == j) || G t i j;
  g_alpha : forall t i j, P t i j != 0 -> alpha <= P t i j;
  g_vel : forall t, (0 < t)%N -> v t.+1 = P t *m v t;
  g_lasts : forall t i j, (0 < t)%N -> G t i j -> len (row i (v t.+1) - row j (v t.+1)) < eps -> G t.+1 i j;
  g_speed : diameter len (v 1%N) <= D }.

Section OneGroup.
Variables (m : nat) (P : nat -> 'M[R]_m) (v : nat -> 'M[R]_(m, d)) (G : nat -> rel 'I_m).
Hypothesis H : group P v G.

Let P0 t i j : 0 <= P t i j. Proof. by have [] := g_stoch H t. Qed.
Let diag t i : 0 < P t i i. Proof. by rewrite lt_def P0 (g_foot H) eqxx. Qed.
Let sym t i j : (P t i j != 0) = (P t j i != 0).
Proof. by rewrite !(g_foot H) eq_sym; have [-> _] := g_net H t. Qed.

Lemma differences t i j : (0 < t)%N -> len (row i (v t) - row j (v t)) <= D.
Proof.
move=> t0; have := after_close (g_stoch H) (g_vel H) len0 lenZ lenD i j t0 t0 => /le_trans; apply.
rewrite /= -[X in _ <= X]mul1r; apply: ler_pmul (g_speed H); [exact: tau1_ge0 | exact: max_ge0 |].
exact: tau1_le1 (stochastic1 _ _).
Qed.

(* a set S that meets no others from s to e - 1, looked at alone, and frozen from e - 1 on *)
Section Alone.
Variables (S : {set 'I_m}) (s e : nat).
Hypothesis s0 : (0 < s)%N.
Hypothesis se : (s < e)%N.
Hypothesis alone : forall t i j, (s <= t < e)%N -> i \in S -> j \notin S -> ~~ G t i j.

Definition clock u := minn (s + u.-1) e.-1.
Definition subnet u : rel 'I_#|S| := fun i j => G (clock u) (enum_val i) (enum_val j).
Definition submat u : 'M[R]_#|S| := restrict S S (fun i j => P (clock u) i j).
Fixpoint subvel_from q : 'M[R]_(#|S|, d) :=
  if q is q'.+1 then submat q *m subvel_from q' else \matrix_(i, l) v s (enum_val i) l.
Definition subvel u := subvel_from u.-1.

Lemma clock_range u : (s <= clock u < e)%N.
Proof. by move: se; rewrite /clock; lia. Qed.
Lemma unheard u i j : i \in S -> j \notin S -> P (clock u) i j = 0.
Proof.
move=> iS jN; have := g_foot H (clock u) i j; rewrite (negbTE (alone (clock_range u) iS jN)) orbF.
case: (i =P j) => [E _|_ Z]; first by rewrite -E iS in jN.
by apply/eqP; exact: negbFE Z.
Qed.
Lemma subvel_row q i : (s + q <= e)%N -> row i (subvel_from q) = row (enum_val i) (v (s + q)%N).
Proof.
elim: q i => [|q IH] i sq; first by apply/rowP=> l; rewrite addn0 !mxE.
have C : clock q.+1 = (s + q)%N by move: sq; rewrite /clock /=; lia.
apply/rowP=> l; rewrite addnS (g_vel H) ?addn_gt0 ?s0 // !mxE [RHS](bigID (fun k => k \in S)) /=.
rewrite [X in _ = _ + X]big1 ?addr0 => [|k kN]; last by rewrite -C (unheard _ (enum_valP i) kN) mul0r.
rewrite [RHS]sum_enum; apply: eq_bigr => k _; rewrite mxE C; congr (_ * _).
by have := IH k (ltnW (leq_trans _ sq)); rewrite addnS => /(_ (leqnn _)) /rowP/(_ l); rewrite !mxE.
Qed.

Lemma subgroup : group submat subvel subnet.
Proof.
split.
- move=> t; have [sy ir] := g_net H (clock t); split=> [i j|i]; [exact: sy | exact: ir].
- move=> t; apply: restrict_stochastic => [i j|i iS]; first exact: P0.
  have [_ s1] := g_stoch H (clock t); rewrite -[RHS](s1 i) [RHS](bigID (fun l => l \in S)) /=.
  by rewrite [X in _ = _ + X]big1 ?addr0 // => l lN; exact: unheard.
- by move=> t i j; rewrite mxE (g_foot H) (inj_eq enum_val_inj).
- by move=> t i j; rewrite mxE; exact: (g_alpha H).
- by case.
- move=> t i j t0 Gij close; rewrite /subnet.
  have [late|early] := leqP e (s + t)%N.
    suff -> : clock t.+1 = clock t by [].
    by move: late t0; rewrite /clock /=; lia.
  have C : clock t = (s + t).-1 by move: early t0; rewrite /clock; lia.
  have C' : clock t.+1 = (s + t)%N by move: early; rewrite /clock /=; lia.
  have st : (0 < (s + t).-1)%N by move: s0 t0; lia.
  move: Gij; rewrite /subnet C C' => Gij; have := g_lasts H st Gij.
  rewrite prednK; last by move: s0; lia.
  by apply; move: close; rewrite /subvel /= !subvel_row // ltnW.
apply: max_le => [|[i j] /=]; first exact: le_trans (max_ge0 _) (g_speed H).
have first k : row k (subvel 1) = row (enum_val k) (v s).
  by have := @subvel_row 0 k; rewrite addn0; apply; exact: ltnW.
by rewrite !first; exact: differences.
Qed.

(* its switches, in the time of all *)
Definition changes_in u := [exists i in S, exists j in S, G u i j != G u.-1 i j].
Lemma subnet_count : (N changes_in e.-1 s <= N (changes subnet) (e - s) 1)%N.
Proof.
rewrite /N (_ : e.-1 - s = e - s - 1)%N; last by move: se; lia.
rewrite (_ : s.+1 = s.-1 + 2)%N; last by move: s0; lia.
rewrite iotaDl count_map; apply: count_in => u; rewrite mem_iota /= => /andP[u2 ue].
case/exists_inP=> i iS /exists_inP[j jS ne].
apply/existsP; exists (enum_rank_in iS i); apply/existsP; exists (enum_rank_in jS j).
rewrite /subnet !enum_rankK_in // (_ : clock u = s.-1 + u)%N; last first.
  by move: s0 u2 ue; rewrite /clock; lia.
rewrite (_ : clock u.-1 = (s.-1 + u).-1)%N //.
by move: s0 u2 ue; rewrite /clock; lia.
Qed.
End Alone.

Variable B : nat.
Hypothesis smaller : forall m' (P' : nat -> 'M[R]_m') v' G', (m' < m)%N -> group P' v' G' ->
  forall T, (N (changes G') T 1 <= B)%N.

(* while the union of the networks is not connected *)
Lemma parted s l : (0 < s)%N -> ~~ [forall i, forall j, connect (window P s l) i j] ->
  (N (changes G) (s + l).-1 s <= 2 * B)%N.
Proof.
move=> s0 /forallPn[i /forallPn[j nij]].
have [->|l0] := posnP l; first by rewrite addn0 N_empty // leq_pred.
pose S : {set 'I_m} := [set x | connect (window P s l) i x].
have iS : i \in S by rewrite inE connect0.
have jS : j \notin S by rewrite inE.
have se : (s < s + l)%N by rewrite -{1}[s]addn0 ltn_add2l.
have alone t x y : (s <= t < s + l)%N -> x \in S -> y \notin S -> ~~ G t x y.
  case/andP=> st tl xS; apply: contra => Gxy; rewrite inE; move: xS; rewrite inE => /connect_trans; apply.
  have tl' : (t - s < l)%N by move: st tl; lia.
  by apply: connect1; apply/existsP; exists (Ordinal tl'); rewrite /= subnKC // (g_foot H) Gxy orbT.
have alone' t x y : (s <= t < s + l)%N -> x \in ~: S -> y \notin ~: S -> ~~ G t x y.
  move=> tr; rewrite !inE negbK => xS yS; have [-> _] := g_net H t.
  by apply: (alone t y x tr); rewrite inE.
have card1 : (#|S| < m)%N.
  rewrite -[X in (_ < X)%N]card_ord -cardsT; apply: proper_card; rewrite properT.
  by apply: contraNneq jS => ->; rewrite inE.
have card2 : (#|~: S| < m)%N.
  rewrite -[X in (_ < X)%N]card_ord -cardsT; apply: proper_card; rewrite properT.
  by apply/eqP=> E; have := in_setT i; rewrite -E inE iS.
have b1 := smaller card1 (subgroup s0 se alone) (s + l - s).
have b2 := smaller card2 (subgroup s0 se alone') (s + l - s).
have {}b1 := leq_trans (subnet_count S s0 se) b1; have {}b2 := leq_trans (subnet_count (~: S) s0 se) b2.
rewrite mul2n -addnn; apply: leq_trans (leq_add b1 b2).
rewrite /N -count_predUI; apply: leq_trans (leq_addr _ _); apply: count_in => u.
rewrite mem_iota => /andP[su ue] /existsP[x /existsP[y ne]] /=.
have r1 : (s <= u < s + l)%N by move: su ue l0; clear; lia.
have r2 : (s <= u.-1 < s + l)%N by move: su ue l0; clear; lia.
have cut a b : a \in S -> b \notin S -> G u a b = G u.-1 a b.
  by move=> aS bS; rewrite (negbTE (alone _ _ _ r1 aS bS)) (negbTE (alone _ _ _ r2 aS bS)).
case xS: (x \in S); case yS: (y \in S).
- by apply/orP; left; apply/exists_inP; exists x => //; apply/exists_inP; exists y.
- by rewrite cut ?yS ?eqxx in ne.
- have [s1 _] := g_net H u; have [s2 _] := g_net H u.-1.
  by move: ne; rewrite s1 [G u.-1 x y]s2 cut ?xS ?eqxx.
apply/orP; right; apply/exists_inP; exists x; first by rewrite inE xS.
by apply/exists_inP; exists y; first by rewrite inE yS.
Qed.

(* w windows, or the end before *)
Lemma windows w T : (1 < m)%N -> (0 < T)%N -> (N (changes G) T 1 <= w * (2 * B + 2))%N \/
  exists ks, [/\ size ks = w, rooted_windows P 1 ks, (1 + sumn ks <= T)%N &
    (N (changes G) (1 + sumn ks) 1 <= w * (2 * B + 2))%N].
Proof.
move=> m1 T0; elim: w => [|w [IH|[ks [sz W le IH]]]].
- by right; exists [::].
- by left; apply: leq_trans IH _; rewrite leq_mul2r leqnSn orbT.
pose e := (1 + sumn ks)%N; rewrite -/e in le IH.
pose joined l := [forall i, forall j, connect (window P e l) i j].
have e0 : (0 < e)%N by [].
have [/existsP[l /andP[lT J]]|none] := boolP [exists l : 'I_T, (e + l <= T)%N && joined l].
  have ex : exists l, joined l by exists l.
  pose q := ex_minn ex; have [Jq q_min] : joined q /\ forall l, joined l -> (q <= l)%N.
    by rewrite /q; case: ex_minnP.
  have q0 : (0 < q)%N.
    rewrite lt0n; apply/eqP=> qz; have := forallP (forallP Jq (Ordinal (ltnW m1))) (Ordinal m1).
    rewrite qz => /connectP[[|b p] /=]; first by move=> _ /(congr1 val).
    by case/andP=> /existsP[[]].
  have nJ : ~~ joined q.-1 by apply/negP => /q_min; move: q0; lia.
  right; exists (ks ++ [:: q]); rewrite size_cat sz addn1 sumn_cat /= addn0 addnA -/e; split=> //.
  - rewrite rooted_windows_cat; split=> //; split=> //; exists (Ordinal m1) => i.
    by have := forallP (forallP Jq i) (Ordinal m1).
  - by apply: leq_trans lT; rewrite leq_add2l; exact: q_min.
  rewrite (N_split _ e0 (leq_addr q e)) mulSn addnC; apply: leq_add => //.
  have {nJ} := parted e0 nJ; case: q q0 {q_min Jq} => // -[|q] _ b.
    by rewrite addn1; apply: leq_trans (N_step _ _) _; rewrite addnC.
  rewrite !addnS; apply: leq_trans (N_next _ _ _) _; rewrite addn1 addn0 ltnS.
  by apply: leq_trans (N_next _ _ _) _; rewrite addn1 ltnS; move: b; rewrite [q.+2.-1]/= addnS.
left; rewrite (N_split _ e0 le) mulSn addnC; apply: leq_add => //.
have [Te|eT] := leqP T e; first by rewrite N_empty.
have TE : T = (e + (T - e))%N by rewrite subnKC // ltnW.
have nJ : ~~ joined (T - e)%N.
  apply/negP => J; have lt : (T - e < T)%N by move: e0 eT; lia.
  by case/negP: none; apply/existsP; exists (Ordinal lt); rewrite /= -TE leqnn.
have := parted e0 nJ; rewrite -TE => b; rewrite -(prednK T0).
by apply: leq_trans (N_next _ _ _) _; apply: leq_add.
Qed.

(* enough windows: from then on edges last *)
Theorem switches_of k T : (1 - alpha ^+ m.-1) ^+ k * D < eps ->
  (N (changes G) T 1 <= k * m.-1 * (2 * B + 2) + 'C(m, 2))%N.
Proof.
move=> small; have [T0|T0] := posnP T; first by rewrite T0 N_empty.
have [m1|m1] := leqP m 1.
  rewrite (_ : N _ _ _ = 0%N) //; apply/eqP; rewrite -leqn0 leqNgt -has_count; apply/hasPn => u _.
  apply/existsPn => i; apply/existsPn => j; rewrite negbK.
  have -> : i = j by apply/ord_inj; move: (ltn_ord i) (ltn_ord j) m1; lia.
  by have [_ i1] := g_net H u; have [_ i2] := g_net H u.-1; rewrite i1 i2.
have [b|[ks [sz W le b]]] := windows (k * m.-1) m1 T0; first exact: leq_trans b (leq_addr _ _).
rewrite (N_split _ (_ : 1 <= 1 + sumn ks)%N le) //; apply: leq_add b _; apply: growing (g_net H) _ => t i j et Gij.
have t0 : (0 < t)%N by exact: leq_trans et.
apply: (g_lasts H t0 Gij); apply: le_lt_trans small.
have kt : (sumn ks < t.+1)%N by exact: leqW.
apply: le_trans (after_close (g_stoch H) (g_vel H) len0 lenZ lenD i j kt kt) _.
apply: ler_pmul (g_speed H); [exact: tau1_ge0 | exact: max_ge0 |].
have := tau1_connected_windows (g_stoch H) diag sym alpha0 (g_alpha H) W.
by rewrite sz mulnK //; move: m1; lia.
Qed.
End OneGroup.

(* the recursion *)
Fixpoint most k m : nat := if m is m'.+1 then k * m' * (2 * most k m' + 2) + 'C(m, 2) else 0.
Lemma most_mono k m m' : (m <= m')%N -> (most k m <= most k m')%N.
Proof.
elim: m' m => [|m' IH] [|m] //; rewrite ltnS => mm /=.
apply: leq_add; last exact: leq_bin2l.
by apply: leq_mul; [rewrite leq_mul2l mm orbT | rewrite leq_add2r leq_mul2l /= IH].
Qed.

Theorem group_switches k nu : alpha <= 1 -> 0 <= D -> (1 - alpha ^+ nu.-1) ^+ k * D < eps ->
  forall m (P : nat -> 'M[R]_m) v G, (m <= nu)%N -> group P v G -> forall T, (N (changes G) T 1 <= most k m)%N.
Proof.
move=> a1 D0 small m; have [q] := ubnP m; elim: q m => // q IH m mq P v G mn H T.
have a0 := ltW alpha0.
have fast : (1 - alpha ^+ m.-1) ^+ k * D < eps.
  apply: le_lt_trans small; apply: ler_wpmul2r => //; apply: ler_expn2r; rewrite ?nnegrE ?subr_ge0 ?exprn_ile1 //.
  rewrite ler_add2l ler_opp2; apply: ler_wiexpn2l => //; move: mn; lia.
case: m mq P v G mn H fast => [|m] mq P v G mn H fast.
  by apply: leq_trans (switches_of H (B := 0) _ T fast) _ => //; rewrite /= muln0 mul0n.
apply: (switches_of H (B := most k m) _ T fast) => m' P' v' G' mm H' T'.
have m'm : (m' <= m)%N by [].
have m'q : (m' < q)%N by exact: leq_ltn_trans m'm _.
have m'nu : (m' <= nu)%N by exact: leq_trans m'm (ltnW mn).
exact: leq_trans (IH m' m'q P' v' G' m'nu H' T') (most_mono k m'm).
Qed.
End Groups.

Lemma most_bound nu a c : (1 < nu)%N ->
  (most (nu ^ (a * (nu - 1) + c + 6)) nu <= nu ^ (a * (nu - 1) ^ 2 + (c + 9) * (nu - 1) + 1))%N.
Proof.
move=> nu1; set k := (nu ^ (_ + 6))%N; apply: (@switches_recursion nu a c (most k)) => //=.
  by rewrite muln0.
move=> [|m] // /andP[_ _]; rewrite [most k m.+1]/= bin2 -divn2 subSS subn0 [m.+1.-1]/=.
have -> : (2 * m.+1 - 1 = 2 * m + 1)%N by lia.
by move: (most k m) (_ %/ 2)%N => y h; nia.
Qed.

(* ---- the flock ---- *)
(* birds are rows; networks by distance, and an edge of the network before stays while its length changes by less than eps *)
Definition flock (R : rcfType) n d (eps : R) (x v : nat -> 'M[R]_(n, d)) (G : nat -> rel 'I_n) (w : nat -> 'I_n -> R) :=
  let dist t i j := norm2 (row i (x t) - row j (x t)) in
  [/\ forall i j, G 0%N i j = (i != j) && (dist 0%N i j <= 1),
      forall t i j, G t.+1 i j = (i != j) && ((dist t.+1 i j <= 1) ||
        (G t i j && (`|dist t.+1 i j - dist t i j| < eps))),
      forall t, model_D (G t) (w t),
      forall t, x t.+1 = x t + v t.+1 &
      forall t, (0 < t)%N -> v t.+1 = transition (G t) (w t) *m v t].

Section Flock.
Variables (R : rcfType) (n d : nat) (eps : R) (x v : nat -> 'M[R]_(n, d)) (G : nat -> rel 'I_n) (w : nat -> 'I_n -> R).
Hypothesis F : flock eps x v G w.

Lemma flock_network t : network (G t).
Proof.
have [G0 GS _ _ _] := F; have sw (y : 'M[R]_(n, d)) i j : norm2 (row i y - row j y) = norm2 (row j y - row i y).
  by rewrite -opprB norm2N.
elim: t => [|t [IH _]]; split=> [i j|i]; rewrite ?G0 ?GS ?eqxx //.
  by rewrite eq_sym sw.
by rewrite eq_sym !(sw _ i j) IH.
Qed.
(* Lemma 2.1 and the rule *)
Lemma flock_lasts t i j : G t i j -> norm2 (row i (v t.+1) - row j (v t.+1)) < eps -> G t.+1 i j.
Proof.
have [_ GS _ X _] := F; move=> Gij close; rewrite GS Gij /=.
have -> /= : i != j by apply: contraTneq Gij => ->; have [_ ->] := flock_network t.
apply/orP; right; apply: le_lt_trans close; apply: (@lemma_2_1 R n d x v t.+1 i j) => // -[|u] // _.
Qed.
End Flock.

(* for any threshold that k = n^(a(n-1)+c+6) stabilisers reach *)
Theorem switches_at (R : rcfType) n d a c eps (x v : nat -> 'M[R]_(n, d)) (G : nat -> rel 'I_n) (w : nat -> 'I_n -> R) :
  (1 < n)%N -> flock eps x v G w -> 2%:R * n%:R ^+ c * (1 - (n%:R ^+ (a * (n - 1)))^-1) ^+ (n ^ (a * (n - 1) + c + 6)) < eps ->
  (forall t i j, transition (G t) (w t) i j != 0 -> (n%:R ^+ a)^-1 <= transition (G t) (w t) i j) ->
  (forall i, norm2 (row i (v 1%N)) <= n%:R ^+ c) ->
  forall t, (N (changes G) t 1 <= n ^ (a * (n - 1) ^ 2 + (c + 9) * (n - 1) + 1))%N.
Proof.
move=> n1 F small al sp t; have [_ _ MD _ V] := F; have net := flock_network F.
have nR : 1 <= n%:R :> R by rewrite ler1n ltnW.
have n0 : 0 < n%:R :> R by exact: lt_le_trans ltr01 nR.
have S u := model_D_stochastic (net u) (@MD u).
apply: leq_trans (most_bound a c n1).
apply: (@group_switches R d (@norm2 R d) (n%:R ^+ a)^-1 eps (2%:R * n%:R ^+ c)
  (norm2_0 _ _) (@norm2Z _ _) (@norm2D _ _) _ _ n _ _ _ n (fun u => transition (G u) (w u)) v) => //.
- by rewrite invr_gt0 exprn_gt0.
- by rewrite invf_le1 ?exprn_gt0 // exprn_ege1.
- by rewrite mulr_ge0 ?ler0n // exprn_ge0 // ltW.
- by rewrite mulrC -subn1 exprVn -exprM.
split=> //.
- by move=> u; have [] := S u.
- by move=> u i j; exact: transition_edge.
- by move=> u i j _; exact: (flock_lasts F).
apply: max_le => [|[i j] /=]; first by rewrite mulr_ge0 ?ler0n // exprn_ge0 // ltW.
apply: le_trans (norm2D _ _) _; rewrite norm2N mulr_natl mulr2n; exact: ler_add.
Qed.
(* beyond.chazelle.switches: a and c are any natural numbers *)
Theorem switches (R : rcfType) n d a c (x v : nat -> 'M[R]_(n, d)) (G : nat -> rel 'I_n) (w : nat -> 'I_n -> R) :
  (1 < n)%N -> flock (n%:R ^+ (n ^ 4))^-1 x v G w ->
  (forall t i j, transition (G t) (w t) i j != 0 -> (n%:R ^+ a)^-1 <= transition (G t) (w t) i j) ->
  (forall i, norm2 (row i (v 1%N)) <= n%:R ^+ c) ->
  forall t, (N (changes G) t 1 <= n ^ (a * (n - 1) ^ 2 + (c + 9) * (n - 1) + 1))%N.
Proof. by move=> n1 F; exact: (switches_at n1 F (@below_threshold R n a c n1)). Qed.

(* chazelle.lem3.1: the printed size, n^O(n^3) *)
Theorem lemma_3_1 (R : rcfType) n d a c (x v : nat -> 'M[R]_(n, d)) (G : nat -> rel 'I_n) (w : nat -> 'I_n -> R) :
  (1 < n)%N -> flock (n%:R ^+ (n ^ 4))^-1 x v G w ->
  (forall t i j, transition (G t) (w t) i j != 0 -> (n%:R ^+ a)^-1 <= transition (G t) (w t) i j) ->
  (forall i, norm2 (row i (v 1%N)) <= n%:R ^+ c) ->
  forall t, (N (changes G) t 1 <= n ^ ((a + c + 9) * n ^ 3))%N.
Proof.
move=> n1 F al sp t; apply: leq_trans (switches n1 F al sp t) _.
apply: leq_pexp2l; first exact: ltnW.
have h : (1 <= (n - 1) <= n)%N by move: n1; lia.
have h2 : ((n - 1) ^ 2 <= n ^ 3)%N.
  by apply: (@leq_trans (n ^ 2)); [rewrite leq_exp2r //; case/andP: h | apply: leq_pexp2l; [exact: ltnW|]].
have h3 : (n - 1 + 1 <= n ^ 3)%N.
  rewrite subnK ?(ltnW n1) // -{1}[n]expn1; apply: leq_pexp2l => //; exact: ltnW.
by move: h h2 h3; move: (n - 1)%N (_ ^ 2)%N (n ^ 3)%N => p q r; nia.
Qed.

(* ---- chazelle.lem3.1.count, corrected ---- *)
(* the network on the birds of S is another one than before *)
Lemma changes_inP n (G : nat -> rel 'I_n) (S : {set 'I_n}) u :
  changes_in G S u = changes (fun t (i j : 'I_#|S|) => G t (enum_val i) (enum_val j)) u.
Proof.
apply/exists_inP/existsP => [[i iS /exists_inP[j jS ne]]|[i /existsP[j ne]]].
  by exists (enum_rank_in iS i); apply/existsP; exists (enum_rank_in jS j); rewrite !enum_rankK_in.
exists (enum_val i); first exact: enum_valP.
by apply/exists_inP; exists (enum_val j); first exact: enum_valP.
Qed.

Section Count.
Variables (R : realFieldType) (n : nat) (G : nat -> rel 'I_n) (P : nat -> 'M[R]_n) (b : 'I_n).
Variables (T : nat -> nat) (V : nat -> {set 'I_n}).
Hypothesis net : forall t, network (G t).
Hypothesis SP : forall t, stochastic (P t).
(* with a positive diagonal and, off it, positive entries exactly at the edges *)
Hypothesis foot : forall t i j, (P t i j != 0) = (i == j) || G t i j.
Hypothesis T0 : T 0%N = 0%N.
Hypothesis V0 : V 0%N = setT.
Hypothesis T_incr : forall k, (T k < T k.+1)%N.
Hypothesis V_next : forall k i, (i \in V k.+1) = (i \in V k) && (block P (V k) (T k).+1 (T k.+1 - T k) i b != 0).
Hypothesis V_stable : forall k t i, (T k.+1 <= t)%N -> i \in V k ->
  block P (V k) (T k).+1 (t - T k) i b != 0 -> i \in V k.+1.

Let diag t i : 0 < P t i i. Proof. by rewrite lt_def foot eqxx; have [-> _] := SP t. Qed.
Let sym t i j : (P t i j != 0) = (P t j i != 0).
Proof. by rewrite !foot eq_sym; have [-> _] := net t. Qed.

(* after T_k birds of V_k meet no others *)
Lemma unmet k t i j : (T k < t)%N -> i \in V k -> j \notin V k -> ~~ G t i j.
Proof.
elim: k => [|k IH] Tt iV jN; first by rewrite V0 inE in jN.
have [sub _ cut _] := stabilisers SP diag sym V0 T_incr V_next V_stable k.
have [jV|jV] := boolP (j \in V k); last by apply: IH jV; [exact: ltn_trans (T_incr k) Tt | exact: subsetP sub i iV].
have [/eqP z _] := cut t i j Tt iV jV jN; move: z; rewrite -[_ == 0]negbK foot.
by rewrite negb_or => /andP[].
Qed.

Theorem count_corrected k t : (0 < k)%N ->
  (forall u i j, (T k < u)%N -> i \in V k -> j \in V k -> G u i j -> G u.+1 i j) ->
  (N (changes G) t 1 <= N (changes G) (T 1%N) 1 + \sum_(2 <= l < k.+1) N (changes G) (T l) (T l.-1) + 1
     + 'C(#|V k|, 2) + N (changes_in G (~: V k)) t (T k).+1)%N.
Proof.
move=> k0 last.
have mono l m : (l <= m)%N -> (T l <= T m)%N.
  by elim: m => [|m IH]; [rewrite leqn0 => /eqP-> | rewrite leq_eqVlt => /orP[/eqP-> //|/IH h]; exact: leq_trans h (ltnW (T_incr m))].
have T1 : (0 < T 1)%N by rewrite -[X in (X < _)%N]T0.
(* up to T_k *)
have upto : (N (changes G) (T k) 1 = N (changes G) (T 1) 1 + \sum_(2 <= l < k.+1) N (changes G) (T l) (T l.-1))%N.
  elim: (k) k0 => // -[|m] IH _; first by rewrite big_geq ?addn0.
  by rewrite big_nat_recr //= addnA -IH // (N_split _ (leq_trans T1 (mono _ _ _)) (mono m.+1 m.+2 _)).
have [tk|kt] := leqP t (T k).+1.
  apply: leq_trans (leq_addr _ _); apply: leq_trans (leq_addr _ _); rewrite -upto.
  apply: leq_trans (N_next _ _ _).
  have [t1|t1] := leqP t 1; first by rewrite N_empty.
  by rewrite (N_split _ (ltnW t1) tk) leq_addr.
have s1 : (1 <= (T k).+1)%N by [].
rewrite (N_split _ s1 (ltnW kt)) -upto -addnA; apply: leq_add; first exact: N_next.
pose G' u (i j : 'I_#|V k|) := G u (enum_val i) (enum_val j).
have grow : (N (changes_in G (V k)) t (T k).+1 <= 'C(#|V k|, 2))%N.
  have -> : N (changes_in G (V k)) t (T k).+1 = N (changes G') t (T k).+1.
    by apply: eq_count => u; exact: changes_inP.
  apply: growing => [u|u i j uT]; first by have [sy ir] := net u; split=> [i j|i]; [exact: sy | exact: ir].
  by apply: last; rewrite ?enum_valP.
apply: leq_trans (leq_add grow (leqnn _)); rewrite /N -count_predUI; apply: leq_trans (leq_addr _ _).
apply: count_in => u; rewrite mem_iota => /andP[uT _] /existsP[x /existsP[y ne]] /=.
have uk : (T k < u)%N by exact: ltn_trans uT.
have uk' : (T k < u.-1)%N by move: uT; clear; lia.
have cut i j : i \in V k -> j \notin V k -> G u i j = G u.-1 i j.
  by move=> iV jV; rewrite (negbTE (unmet uk iV jV)) (negbTE (unmet uk' iV jV)).
case xS: (x \in V k); case yS: (y \in V k).
- by apply/orP; left; apply/exists_inP; exists x => //; apply/exists_inP; exists y.
- by rewrite cut ?yS ?eqxx in ne.
- have [s1' _] := net u; have [s2' _] := net u.-1.
  by move: ne; rewrite s1' [G u.-1 x y]s2' cut ?xS ?eqxx.
apply/orP; right; apply/exists_inP; exists x; first by rewrite inE xS.
by apply/exists_inP; exists y; first by rewrite inE yS.
Qed.
End Count.
