(* Chazelle, section 2, sharpened: exactly how small the nonzero entries of a product P(t,s) are.
     beyond.chazelle.entries (both clauses).
   When the support S of a column grows, a bird that has any weight on S has at least a share of it that
   depends on #|S| only; the products of these shares are 1/n! for c_i = 1/(d_i+1) and
   2^(n-2)/(3^(n-1) (n-1)!) for c_i = 2/(3 d_i).  They are attained by n-1 networks.
   Any ordered field, no axioms. *)
Set Warnings "-notation-overridden,-ambiguous-paths".
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import ring zify.
From Flockproof Require Import chazelle_model chazelle_ergodicity chazelle_products.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Import GRing.Theory Num.Theory Order.Theory.
Local Open Scope ring_scope.

Section Floor.
Variables (R : realFieldType) (n : nat) (P : nat -> 'M[R]_n) (f : nat -> R).
Hypothesis SP : forall t, stochastic (P t).
Hypothesis diag : forall t i, 0 < P t i i.
Hypothesis sym : forall t i j, (P t i j != 0) = (P t j i != 0).
Hypothesis f1 : f 1%N <= 1.
Hypothesis f_anti : forall k, (0 < k < n)%N -> f k.+1 <= f k.
(* a bird with any weight on S keeps enough of it *)
Hypothesis share : forall t (S : {set 'I_n}) i, (0 < #|S| < n)%N -> (exists2 l, P t i l != 0 & l \in S) ->
  f #|S|.+1 <= (\sum_(l in S) P t i l) * f #|S|.

Let P0 t i j : 0 <= P t i j. Proof. by have [] := SP t. Qed.

Lemma f_le k l : (0 < k)%N -> (k <= l <= n)%N -> f l <= f k.
Proof.
move=> k0; elim: l => [|l IH]; first by case: k k0.
case/andP; rewrite leq_eqVlt => /orP[/eqP-> //|kl ln].
apply: le_trans (f_anti _) (IH _); first by rewrite ln (leq_trans k0).
by rewrite -ltnS kl ltnW.
Qed.

Variables (s : nat) (j : 'I_n).
Local Notation supp k := (supp P s j k).
Local Notation Y k i := (span P s k i j).
Let Y0 k i : 0 <= Y k i. Proof. exact: span_ge0. Qed.
Let Ypos k i : i \in supp k -> 0 < Y k i.
Proof. by rewrite inE => h; rewrite lt_def h Y0. Qed.
Let YS k i : Y k.+1 i = \sum_l P (s + k)%N i l * Y k l. Proof. by rewrite /= mxE. Qed.

Lemma floor_support k i : i \in supp k -> f #|supp k| <= Y k i.
Proof.
elim: k i => [|k IH] i ik.
  have S0 : supp 0 = [set j].
    by apply/setP=> l; rewrite !inE /= mxE; case: (l == j); rewrite ?oner_eq0 ?eqxx.
  by move: ik; rewrite S0 inE cards1 /= mxE => ->.
have sub : supp k \subset supp k.+1 by exact: supp_mono.
case: (eqVneq (supp k.+1) (supp k)) => [E|nE].
  rewrite E in ik *; rewrite YS.
  have inside l : P (s + k)%N i l != 0 -> l \in supp k.
    move=> nz; rewrite -E inE lt0r_neq0 // YS (bigD1 i) //=.
    apply: ltr_paddr; first by apply: sumr_ge0 => m _; rewrite mulr_ge0.
    by apply: mulr_gt0; [rewrite lt_def P0 sym nz | exact: Ypos].
  have [_ sum1] := SP (s + k)%N; rewrite -[X in X <= _]mul1r -(sum1 i) mulr_suml.
  apply: ler_sum => l _; have [->|nz] := eqVneq (P (s + k)%N i l) 0; first by rewrite !mul0r.
  by apply: ler_wpmul2l => //; apply: IH; exact: inside.
have lt : (#|supp k| < #|supp k.+1|)%N.
  by apply: proper_card; rewrite properEneq eq_sym nE sub.
have le_n : (#|supp k.+1| <= n)%N by rewrite -[X in (_ <= X)%N]card_ord max_card.
have k0 : (0 < #|supp k|)%N by exact: supp_card_gt0.
have [l nz lk] : exists2 l, P (s + k)%N i l != 0 & l \in supp k.
  apply/exists_inP; apply: contraLR ik => /exists_inPn H; rewrite inE negbK YS big1 // => l _.
  have [-> | /H lk] := eqVneq (P (s + k)%N i l) 0; first by rewrite mul0r.
  by move: lk; rewrite inE negbK => /eqP->; rewrite mulr0.
apply: (@le_trans _ _ (f #|supp k|.+1)); first by apply: f_le => //; rewrite lt.
apply: le_trans (@share (s + k)%N (supp k) i _ _) _; first by rewrite k0 (leq_trans lt).
  by exists l.
rewrite YS; apply: (@le_trans _ _ (\sum_(m in supp k) P (s + k)%N i m * Y k m)).
  by rewrite mulr_suml; apply: ler_sum => m mS; apply: ler_wpmul2l; [exact: P0 | exact: IH].
by rewrite [X in _ <= X](bigID (mem (supp k))) /= ler_addl sumr_ge0 // => m _; rewrite mulr_ge0.
Qed.

Theorem floor_bound k i : Y k i != 0 -> f n <= Y k i.
Proof.
move=> nz; have ik : i \in supp k by rewrite inE.
apply: le_trans (floor_support ik); apply: f_le; first exact: supp_card_gt0.
by rewrite leqnn andbT -[X in (_ <= X)%N]card_ord max_card.
Qed.
End Floor.

(* ---- the two models ---- *)
Section Shares.
Variables (R : realFieldType) (n : nat).
Implicit Types (G : rel 'I_n) (S : {set 'I_n}).

Definition lazy G (i : 'I_n) : R := 2%:R / (3%:R * (degree G i)%:R).

(* neighbours in S and outside *)
Definition inside G S i := #|[set l in S | G i l]|.
Lemma degree_parts G S i : network G ->
  (degree G i <= inside G S i + (n - #|S| - (i \notin S)))%N /\ (degree G i <= inside G S i + (n - #|S|))%N.
Proof.
move=> [_ irr]; have -> : degree G i = #|[set l | G i l]| by rewrite cardsE.
have part : #|[set l | G i l]| = (inside G S i + #|[set l | G i l] :\: S|)%N.
  by rewrite -(cardsID S) /inside; congr (#|pred_of_set _| + _)%N; apply/setP=> l; rewrite !inE andbC.
have cS : #|~: S| = (n - #|S|)%N by rewrite cardsCs setCK card_ord.
have sub : [set l | G i l] :\: S \subset ~: S :\ i.
  apply/subsetP=> l; rewrite !inE => /andP[lS Gl]; rewrite lS andbT.
  by apply: contraTneq Gl => ->; rewrite irr.
have le := subset_leq_card sub; have := cardsD1 i (~: S); rewrite cS inE => E.
rewrite part; split; rewrite leq_add2l; apply: leq_trans le _; lia.
Qed.

Lemma vicsek_share G S i : network G ->
  \sum_(l in S) transition G (vicsek R G) i l = ((i \in S) + inside G S i)%:R / (degree G i).+1%:R.
Proof.
move=> net; have [sym irr] := net.
have E := proj2 (@model_K_matrix R n G 0 i net).
rewrite (eq_bigr (fun l => if (i == l) || G i l then (degree G i).+1%:R^-1 else 0)); last by move=> l _; exact: E.
rewrite -big_mkcondr /= (eq_bigl (mem [set l in S | (i == l) || G i l])); last by move=> l; rewrite !inE.
rewrite sumr_const -[LHS]mulr_natl; congr (_%:R / _).
rewrite (cardsD1 i) !inE eqxx andbT; congr (_ + _)%N; rewrite /inside; apply: eq_card => l.
by rewrite !inE; have [->|li] := eqVneq l i; first by rewrite irr andbF.
Qed.

Lemma lazy_share G S i : network G ->
  ((i \in S) -> 1 / 3%:R <= \sum_(l in S) transition G (lazy G) i l) /\
  ((i \notin S) -> \sum_(l in S) transition G (lazy G) i l = (inside G S i)%:R * lazy G i).
Proof.
move=> [sym irr]; have three : 0 < 3%:R :> R by rewrite ltr0n.
have off l : l != i -> transition G (lazy G) i l = (G i l)%:R * lazy G i.
  by move=> li; rewrite transitionE // eq_sym (negbTE li); case: (G i l); rewrite ?mul1r ?mul0r.
have lazy0 : 0 <= lazy G i by rewrite divr_ge0 // ?mulr_ge0 ?ler0n.
split=> iS.
  rewrite (bigD1 i) //= transitionE // eqxx -[X in X <= _]addr0 ler_add //; last first.
    by apply: sumr_ge0 => l /andP[_ li]; rewrite off // mulr_ge0 ?ler0n.
  rewrite /lazy; case: (degree G i) => [|d].
    by rewrite mulr0 subr0 ler_pdivr_mulr // mul1r ler1n.
  have d0 : d.+1%:R != 0 :> R by rewrite pnatr_eq0.
  have -> : 2%:R / (3%:R * d.+1%:R) * d.+1%:R = 1 - 1 / 3%:R :> R.
    by move: d.+1%:R d0 => x x0; field; rewrite x0.
  by rewrite opprB addrCA subrr addr0.
rewrite (eq_bigr (fun l => (G i l)%:R * lazy G i)); last first.
  by move=> l lS; apply: off; apply: contraNneq iS => <-.
rewrite -mulr_suml; congr (_ * _); rewrite /inside -sum1_card natr_sum big_mkcond [RHS]big_mkcond /=.
by apply: eq_bigr => l _; rewrite !inE; case: (l \in S); case: (G i l).
Qed.

(* the floors: the product of the shares for supports of 1, .., k - 1 birds *)
Definition vicsek_floor k : R := (n - k).+1`!%:R / n`!%:R.
Definition lazy_floor k : R :=
  if (k < n)%N then (2%:R / 3%:R) ^+ k.-1 * (n - k)`!%:R / n.-1`!%:R
  else (2%:R / 3%:R) ^+ n.-1 / (2%:R * n.-1`!%:R).

Lemma neighbour_inside G S i : network G -> forall (c : 'I_n -> R) l, transition G c i l != 0 -> l \in S ->
  (0 < (i \in S) + inside G S i)%N.
Proof.
move=> [sym irr] c l nz lS; rewrite transitionE // in nz.
case: (eqVneq i l) nz => [-> _|_]; first by rewrite lS.
case Gl: (G i l); last by rewrite eqxx.
by move=> _; rewrite addn_gt0; apply/orP; right; apply/card_gt0P; exists l; rewrite inE lS Gl.
Qed.

Lemma vicsek_grows G S i : network G -> (0 < #|S| < n)%N ->
  (exists2 l, transition G (vicsek R G) i l != 0 & l \in S) ->
  vicsek_floor #|S|.+1 <= (\sum_(l in S) transition G (vicsek R G) i l) * vicsek_floor #|S|.
Proof.
move=> net /andP[S0 Sn] [l nz lS]; rewrite vicsek_share //; set a := (_ + _)%N.
have a0 : (0 < a)%N by exact: neighbour_inside nz lS.
have [d1 d2] := degree_parts S i net.
rewrite /vicsek_floor; have -> : (n - #|S|.+1).+1 = (n - #|S|)%N by lia.
set m := (n - #|S|)%N in d1 d2 *.
have key : (m`! * (degree G i).+1 <= a * m.+1`!)%N.
  rewrite factS (mulnC m.+1) mulnA (mulnC a) -mulnA leq_mul2l; apply/orP; right.
  have le : ((degree G i).+1 <= a + m)%N.
    by rewrite /a; move: d1 d2; case: (i \in S) => /=; lia.
  by apply: leq_trans le _; rewrite mulnS leq_add2l leq_pmull.
have N0 : 0 < n`!%:R^-1 :> R by rewrite invr_gt0 ltr0n fact_gt0.
by rewrite mulrA ler_pmul2r // mulrAC ler_pdivl_mulr ?ltr0n // -!natrM ler_nat.
Qed.

Lemma lazy_step k x : (0 < k < n)%N -> (1 / 3%:R <= x) \/ (2%:R / 3%:R <= x * (n - k)%:R) ->
  lazy_floor k.+1 <= x * lazy_floor k.
Proof.
case: k => // k /andP[_ kn] H; rewrite /lazy_floor kn /=.
have three : 0 < 3%:R :> R by rewrite ltr0n.
have N0 : 0 < n.-1`!%:R^-1 :> R by rewrite invr_gt0 ltr0n fact_gt0.
have q0 : 0 <= 2%:R / 3%:R :> R by rewrite divr_ge0 ?ler0n.
case: ltnP => k2.
  have E : (n - k.+1)%N = (n - k.+2).+1 by lia.
  have key : 2%:R / 3%:R <= x * (n - k.+1)%:R.
    case: H => [x3|//]; have x0 : 0 <= x by apply: le_trans x3; rewrite divr_ge0 ?ler01 ?ler0n.
    apply: (@le_trans _ _ (x * 2%:R)); last by apply: ler_wpmul2l => //; rewrite ler_nat; lia.
    by rewrite ler_pdivr_mulr // mulrAC -ler_pdivr_mulr ?ltr0n // divff ?pnatr_eq0 // -ler_pdivr_mulr.
  rewrite E in key *; rewrite factS natrM exprS.
  set y := (_ ^+ k); set m := ((n - k.+2).+1%:R : R) in key *; set a := ((n - k.+2)`!%:R : R).
  have -> : 2%:R / 3%:R * y * a / n.-1`!%:R = (2%:R / 3%:R) * (y * a / n.-1`!%:R) by rewrite !mulrA.
  have -> : x * (y * (m * a) / n.-1`!%:R) = (x * m) * (y * a / n.-1`!%:R) by ring.
  apply: ler_wpmul2r key; rewrite mulr_ge0 ?(ltW N0) // mulr_ge0 ?ler0n // exprn_ge0 //.
have E : n = k.+2 by lia.
have key : 1 / 3%:R <= x.
  case: H => [//|]; rewrite E subSS subSnn mulr1; apply: le_trans.
  by rewrite ler_pmul2r ?invr_gt0 // ler1n.
rewrite E subSnn (factS 0) fact0 muln1 mulr1 /= exprS; set y := (_ ^+ k); set N := _`!%:R.
have N1 : N != 0 by rewrite pnatr_eq0 -lt0n fact_gt0.
have -> : 2%:R / 3%:R * y / (2%:R * N) = (1 / 3%:R) * (y / N) by field; rewrite N1.
by apply: ler_wpmul2r key; rewrite divr_ge0 ?exprn_ge0 ?ler0n.
Qed.

Lemma lazy_grows G S i : network G -> (0 < #|S| < n)%N ->
  (exists2 l, transition G (lazy G) i l != 0 & l \in S) ->
  lazy_floor #|S|.+1 <= (\sum_(l in S) transition G (lazy G) i l) * lazy_floor #|S|.
Proof.
move=> net Sn [l nz lS]; have three : 0 < 3%:R :> R by rewrite ltr0n.
apply: lazy_step => //; have [inS outS] := lazy_share S i net.
case iS: (i \in S); [left; exact: inS | right; rewrite outS ?iS //].
have e0 := neighbour_inside net nz lS; rewrite iS add0n in e0.
have [d1 _] := degree_parts S i net; rewrite iS /= in d1.
set e := inside G S i in e0 d1 *; rewrite /lazy.
have d0 : (0 < degree G i)%N.
  apply: leq_trans e0 _; apply: subset_leq_card; apply/subsetP=> m; rewrite !inE => /andP[_ ->]; by [].
have le : (degree G i <= e * (n - #|S|))%N.
  have [m E] : exists m, (n - #|S|)%N = m.+1 by exists (n - #|S|).-1; lia.
  rewrite E subn1 /= in d1 *; apply: leq_trans d1 _.
  by rewrite mulnS leq_add2l leq_pmull.
have dR : 0 < (degree G i)%:R :> R by rewrite ltr0n.
have -> : e%:R * (2%:R / (3%:R * (degree G i)%:R)) * (n - #|S|)%:R
  = (2%:R / 3%:R) * ((e * (n - #|S|))%:R / (degree G i)%:R) :> R.
  by rewrite natrM; move: (degree G i)%:R dR => d /lt0r_neq0 dn; field; rewrite dn.
apply: ler_pemulr; first by rewrite divr_ge0 ?ler0n.
by rewrite ler_pdivl_mulr // mul1r ler_nat.
Qed.

Lemma vicsek_model G : model_D G (vicsek R G).
Proof.
move=> i d0; rewrite /vicsek -[X in X * _]div1r mulrAC mul1r; apply/andP; split.
  by rewrite divr_gt0 ?ltr0n.
by rewrite ltr_pdivr_mulr ?ltr0n // mul1r ltr_nat.
Qed.
Lemma lazy_cd G i : (0 < degree G i)%N -> lazy G i * (degree G i)%:R = 2%:R / 3%:R.
Proof.
move=> d0; have dR : (degree G i)%:R != 0 :> R by rewrite pnatr_eq0 -lt0n.
by rewrite /lazy; move: (degree G i)%:R dR => d dn; field; rewrite dn.
Qed.
Lemma lazy_model G : model_D G (lazy G).
Proof.
move=> i d0; rewrite lazy_cd // divr_gt0 ?ltr0n //=.
by rewrite ltr_pdivr_mulr ?ltr0n // mul1r ltr_nat.
Qed.
End Shares.

(* beyond.chazelle.entries, the bound: for every sequence of networks and all t >= s *)
Theorem smallest_entries (R : realFieldType) n (G : nat -> rel 'I_n) s t (i j : 'I_n) :
  (forall u, network (G u)) -> (s <= t)%N ->
  (let P u := transition (G u) (vicsek R (G u)) in
   pprod P t s i j != 0 -> n`!%:R^-1 <= pprod P t s i j) /\
  ((1 < n)%N -> let P u := transition (G u) (fun i => 2%:R / (3%:R * (degree (G u) i)%:R) : R) in
   pprod P t s i j != 0 -> 2%:R ^+ (n - 2) / (3%:R ^+ n.-1 * n.-1`!%:R) <= pprod P t s i j).
Proof.
move=> net _; have n0 : (0 < n)%N by exact: leq_ltn_trans (leq0n _) (ltn_ord i).
have fact0 m : 0 < m`!%:R :> R by rewrite ltr0n fact_gt0.
have symm (c : nat -> 'I_n -> R) : (forall u, model_D (G u) (c u)) ->
  forall u x y, (transition (G u) (c u) x y != 0) = (transition (G u) (c u) y x != 0).
  by move=> D u x y; rewrite !transition_edge //; have [-> _] := net u; rewrite eq_sym.
split=> [P nz | n1 P nz].
  have D u : model_D (G u) (vicsek R (G u)) by exact: vicsek_model.
  have S u := model_D_stochastic (net u) (D u).
  have <- : vicsek_floor R n n = n`!%:R^-1 by rewrite /vicsek_floor subnn mul1r.
  apply: (@floor_bound R n P (vicsek_floor R n) (fun u => proj1 (S u)) (fun u => proj2 (S u)) _ _ _ _ s j _ i nz).
  - exact: symm.
  - by rewrite /vicsek_floor subn1 prednK // divff // lt0r_neq0.
  - move=> k /andP[_ kn]; rewrite /vicsek_floor (_ : (n - k.+1).+1 = n - k)%N; last by lia.
    by rewrite ler_pmul2r ?invr_gt0 // ler_nat factS leq_pmull.
  - by move=> u A x; exact: vicsek_grows.
have D u : model_D (G u) (lazy R (G u)) by exact: lazy_model.
have S u := model_D_stochastic (net u) (D u).
have <- : lazy_floor R n n = 2%:R ^+ (n - 2) / (3%:R ^+ n.-1 * n.-1`!%:R).
  rewrite /lazy_floor ltnn; case: n n1 {i j G net fact0 symm P nz D S} n0 => // [[|m]] // _ _.
  rewrite /= subSS subSS subn0 expr_div_n exprS.
  have N1 : m.+1`!%:R != 0 :> R by rewrite pnatr_eq0 -lt0n fact_gt0.
  have T1 : 3%:R ^+ m.+1 != 0 :> R by rewrite expf_neq0 // pnatr_eq0.
  by move: (m.+1`!%:R) (3%:R ^+ m.+1) (2%:R ^+ m) N1 T1 => a b c a0 b0; field; rewrite a0 b0.
apply: (@floor_bound R n P (lazy_floor R n) (fun u => proj1 (S u)) (fun u => proj2 (S u)) _ _ _ _ s j _ i nz).
- exact: symm.
- rewrite /lazy_floor n1 expr0 mul1r subn1 divff // lt0r_neq0 //.
- move=> k kn; rewrite -[X in _ <= X]mul1r; apply: lazy_step => //; left.
  by rewrite ler_pdivr_mulr ?ltr0n // mul1r ler1n.
- by move=> u A x; exact: lazy_grows.
Qed.

(* ---- the bound is attained ---- *)
Section Attained.
Variables (R : realFieldType) (n : nat).
(* at time k bird k+1 (birds from 0) sees bird k and all birds beyond k+1, and is seen by them; nothing else *)
Definition star k : rel 'I_n := fun i l =>
  ((i == k.+1 :> nat) && (k <= l)%N && (l != i)) || ((l == k.+1 :> nat) && (k <= i)%N && (l != i)).
Lemma star_network k : network (star k).
Proof.
split=> [i l|i]; last by rewrite /star eqxx !andbF.
by rewrite /star orbC (eq_sym i l).
Qed.

Lemma count_from m k : (\sum_(l < m) (k <= l) = m - k)%N.
Proof. by elim: m => [|m IH]; rewrite ?big_ord0 // big_ord_recr /= IH; case: (leqP k m) => /= h; lia. Qed.

Lemma star_degree k (i : 'I_n) : i = k.+1 :> nat -> degree (star k) i = (n - k.+1)%N.
Proof.
move=> ik; rewrite /degree -sum1_card big_mkcond /=.
have E : (1 + \sum_(l < n | l != i) (k <= l) = n - k)%N.
  by rewrite -(count_from n k) [in RHS](bigD1 i) //= ik leqnSn.
rewrite (bigD1 i) //= inE /star eqxx !andbF /= add0n.

transitivity (\sum_(l < n | l != i) (k <= l))%N; last by rewrite subnS -E.
apply: eq_bigr => l li; rewrite inE /star ik eqxx li !andbT /=.
have -> : (l == k.+1 :> nat) = false by apply/negbTE; rewrite -ik; apply: contraNneq li => h; apply/eqP/val_inj.
by rewrite /= orbF; case: (k <= l)%N.
Qed.

Variable c : nat -> 'I_n -> R.
Variable w : nat -> R.
Hypothesis cw : forall k (i : 'I_n), i = k.+1 :> nat -> c k i = w k.
Let P k := transition (star k) (c k).
Variable j : 'I_n.
Hypothesis j0 : j = 0%N :> nat.

Lemma chain k : (k < n)%N -> (forall i : 'I_n, (k < i)%N -> span P 0 k i j = 0) /\
  (forall i : 'I_n, i = k :> nat -> span P 0 k i j = \prod_(u < k) w u).
Proof.
elim: k => [|k IH] kn.
  split=> i ik /=; rewrite mxE; last first.
    have -> : i = j by apply/val_inj; rewrite /= ik j0.
    by rewrite eqxx big_ord0.
  by have -> : (i == j) = false by apply/negbTE/eqP => h; rewrite h j0 in ik.
have [far near] := IH (ltnW kn); have [sym irr] := star_network k.
have E i : span P 0 k.+1 i j = \sum_l P k i l * span P 0 k l j by rewrite /= mxE add0n.
split=> i ik; rewrite E.
  rewrite big1 // => l _; case: (ltnP k l) => kl; first by rewrite far ?mulr0.
  have il : i != l by apply: contraTneq ik => ->; rewrite -leqNgt; lia.
  rewrite /P transitionE // (negbTE il) /star ifF ?mul0r //; apply/negbTE.
  by rewrite negb_or; apply/andP; split; apply/nandP; left; apply/nandP; left; apply/eqP; lia.
pose b := Ordinal (ltnW kn); have bi : b != i by apply/eqP => h; have := congr1 val h; rewrite /= ik; lia.
rewrite (bigD1 b) //= big1 ?addr0 => [|l lb].
  rewrite near // /P transitionE // eq_sym (negbTE bi) /star /= ik eqxx leqnn /= ifT; last first.
    by rewrite bi.
  by rewrite cw // big_ord_recr /= mulrC.
case: (ltnP k l) => kl; first by rewrite far ?mulr0.
have lk : (l < k)%N by rewrite ltn_neqAle kl andbT; apply: contraNneq lb => h; apply/eqP/val_inj.
have il : i != l by apply: contraTneq lk => <-; rewrite ik; lia.
rewrite /P transitionE // (negbTE il) /star ifF ?mul0r //; apply/negbTE.
rewrite negb_or; apply/andP; split; apply/nandP; left; apply/nandP; [right | left; apply/eqP]; lia.
Qed.
End Attained.

(* beyond.chazelle.entries: both values occur, in products of n - 1 factors *)
Theorem smallest_entries_occur (R : realFieldType) n : (1 < n)%N ->
  exists G : nat -> rel 'I_n, (forall u, network (G u)) /\
  (exists i j, pprod (fun u => transition (G u) (vicsek R (G u))) (n - 2) 0 i j = n`!%:R^-1) /\
  (exists i j, pprod (fun u => transition (G u) (fun i => 2%:R / (3%:R * (degree (G u) i)%:R) : R)) (n - 2) 0 i j
     = 2%:R ^+ (n - 2) / (3%:R ^+ n.-1 * n.-1`!%:R)).
Proof.
move=> n1; have n0 : (0 < n)%N by exact: ltnW.
pose j : 'I_n := Ordinal n0; exists (@star n); split; first exact: star_network.
have steps : (n - 2 - 0).+1 = n.-1 by lia.
split.
  have last : (n.-1 < n)%N by rewrite prednK.
  exists (Ordinal last), j; rewrite /pprod steps.
  pose w k : R := (n - k)%:R^-1.
  have cw k (i : 'I_n) : i = k.+1 :> nat -> vicsek R (star k) i = w k.
    by move=> ik; rewrite /vicsek /w (star_degree ik) subnSK // -ik ltnW // ltn_ord.
  have [_ near] := @chain R n (fun k => vicsek R (@star n k)) w cw j erefl n.-1 last.
  rewrite near // /w prodfV -natr_prod; congr (_%:R^-1).
  rewrite -ffact_prod -(ffact_fact (leq_pred n)) (_ : n - n.-1 = 1)%N; last by lia.
  by rewrite (factS 0) fact0 !muln1.
have last : (n - 2 < n)%N by lia.
pose i0 : 'I_n := Ordinal last; exists i0, j; rewrite /pprod steps.
have -> : n.-1 = (n - 2).+1 by lia.
set m := (n - 2)%N in i0 *; pose w k : R := 2%:R / (3%:R * (n - k.+1)%:R).
have cw k (i : 'I_n) : i = k.+1 :> nat -> lazy R (star k) i = w k.
  by move=> ik; rewrite /lazy /w (star_degree ik).
have [far near] := @chain R n (fun k => lazy R (@star n k)) w cw j erefl m last.
rewrite /= mxE add0n (bigD1 i0) //= big1 ?addr0 => [|l li]; last first.
  case: (ltnP m l) => lm; first by rewrite far ?mulr0.
  have [sym irr] := star_network n m.
  rewrite transitionE // eq_sym (negbTE li) /star /= ifF ?mul0r //; apply/negbTE.
  rewrite negb_or; apply/andP; split; apply/nandP; left; apply/nandP; left; apply/eqP; lia.
rewrite near //.
have [sym irr] := star_network n m.
have mn : (m.+1 < n)%N by rewrite /m; lia.
have d0 : (0 < degree (@star n m) i0)%N.
  apply/card_gt0P; exists (Ordinal mn); rewrite inE /star; apply/orP; right.
  by rewrite /= eqxx leqnn /=; apply/eqP => /(congr1 val) /=; lia.
rewrite transitionE // eqxx -/(lazy R (star m) i0) lazy_cd //.
have -> : \prod_(u < m) w u = (2%:R / 3%:R) ^+ m / m.+1`!%:R.
  rewrite /w (eq_bigr (fun u : 'I_m => 2%:R / 3%:R * (m.+1 - u)%:R^-1)); last first.
    move=> u _; rewrite invfM mulrA (_ : n - u.+1 = m.+1 - u)%N //.
    by rewrite /m; have := ltn_ord u; rewrite {1}/m; lia.
  rewrite big_split /= prodr_const card_ord prodfV -natr_prod -ffact_prod.
  by rewrite -(ffact_fact (leqnSn m)) subSnn (factS 0) fact0 !muln1.
have N1 : m.+1`!%:R != 0 :> R by rewrite pnatr_eq0 -lt0n fact_gt0.
have T1 : 3%:R ^+ m != 0 :> R by rewrite expf_neq0 // pnatr_eq0.
rewrite expr_div_n exprS.
by move: (m.+1`!%:R) (3%:R ^+ m) (2%:R ^+ m) N1 T1 => a b x a0 b0; field; rewrite a0 b0.
Qed.
