(* Chazelle, section 2 (Ergodicity) and section 3: products P(t) ... P(s) of different matrices whose networks
   need not be connected at any single time, but are connected together over consecutive windows of time.
     chazelle.eq3.6, chazelle.fiedler.rate (what the same contraction of tau_1 gives for changing networks).
   Idea: follow the birds that two birds i and j have listened to, backwards in time.  As long as the two sets are
   disjoint, in every window at least one of them grows: else both were closed and both held a root of the window.
   After n-1 windows they meet, so the rows i and j overlap by a smallest positive entry beta, and
   tau_1 <= 1 - beta.  For symmetric footprints beta = alpha^(n-1), however long the windows are.
   Any ordered field, no axioms. *)
Set Warnings "-notation-overridden,-ambiguous-paths".
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import ring zify.
From Flockproof Require Import chazelle_model chazelle_ergodicity chazelle_products chazelle_limits.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Import GRing.Theory Num.Theory Order.Theory.
Local Open Scope ring_scope.

Section Windows.
Variables (R : realFieldType) (n : nat) (P : nat -> 'M[R]_n).

(* i listens to j at some time from s to s + k - 1 *)
Definition window s k : rel 'I_n := fun i j => [exists u : 'I_k, P (s + u)%N i j != 0].
(* some bird is heard, through others, by all of them *)
Definition rooted (G : rel 'I_n) : Prop := exists r, forall i, connect G i r.
(* consecutive windows of the lengths ks from time s on *)
Fixpoint rooted_windows s (ks : seq nat) : Prop :=
  if ks is k :: ks' then rooted (window s k) /\ rooted_windows (s + k)%N ks' else True.

Lemma span_add s k l : span P s (k + l)%N = span P (s + k)%N l *m span P s k.
Proof.
elim: l => [|l IH]; first by rewrite addn0 mul1mx.
by rewrite addnS /= IH mulmxA addnA.
Qed.

Lemma rooted_windows_cat s ks ls :
  rooted_windows s (ks ++ ls) <-> rooted_windows s ks /\ rooted_windows (s + sumn ks)%N ls.
Proof.
elim: ks s => [|k ks IH] s /=; first by rewrite addn0; split=> // -[].
by rewrite IH addnA; split=> [[? []]|[[? ?] ?]].
Qed.

Lemma strong_rooted (G : rel 'I_n) (i : 'I_n) : (forall i j, connect G i j) -> rooted G.
Proof. by move=> H; exists i. Qed.

Hypothesis SP : forall t, stochastic (P t).
Hypothesis diag : forall t i, 0 < P t i i.
Let P0 t i j : 0 <= P t i j. Proof. by have [] := SP t. Qed.

Lemma span_diag s k i : 0 < span P s k i i.
Proof.
elim: k => [|k IH]; first by rewrite /= mxE eqxx ltr01.
apply: lt_le_trans (mul_ge_term i i i (P0 _) (span_ge0 s k P0)).
by rewrite mulr_gt0.
Qed.
Lemma span_edge s k u i j : (u < k)%N -> P (s + u)%N i j != 0 -> 0 < span P s k i j.
Proof.
move=> uk nz; rewrite -(subnKC uk) span_add.
apply: lt_le_trans (mul_ge_term i i j (span_ge0 _ _ P0) (span_ge0 _ _ P0)).
rewrite mulr_gt0 ?span_diag //.
apply: lt_le_trans (mul_ge_term i j j (P0 _) (span_ge0 _ _ P0)).
by rewrite mulr_gt0 ?span_diag // lt_def nz P0.
Qed.

(* whom bird i has listened to, directly or not *)
Definition heard s k (i : 'I_n) : {set 'I_n} := [set l | 0 < span P s k i l].

Lemma heard_self s k i : i \in heard s k i. Proof. by rewrite inE span_diag. Qed.
Lemma heard_before s k l i : heard (s + k)%N l i \subset heard s (k + l)%N i.
Proof.
apply/subsetP=> j; rewrite !inE span_add => h.
apply: lt_le_trans (mul_ge_term i j j (span_ge0 _ _ P0) (span_ge0 _ _ P0)).
by rewrite mulr_gt0 ?span_diag.
Qed.
(* a set that does not grow in a window is closed in it *)
Lemma heard_closed s k l i : heard (s + k)%N l i = heard s (k + l)%N i ->
  forall a b, a \in heard s (k + l)%N i -> connect (window s k) a b -> b \in heard s (k + l)%N i.
Proof.
move=> E a b aS /connectP[p pth ->] {b}; elim: p a aS pth => [|b p IH] a aS //= /andP[ab].
apply: IH; case/existsP: ab => u nz; move: aS; rewrite -{1}E !inE span_add => h.
apply: lt_le_trans (mul_ge_term i a b (span_ge0 _ _ P0) (span_ge0 _ _ P0)).
by rewrite mulr_gt0 // (span_edge (ltn_ord u)).
Qed.

Lemma heard_meet s ks i j : rooted_windows s ks ->
  [disjoint heard s (sumn ks) i & heard s (sumn ks) j] ->
  (size ks + 2 <= #|heard s (sumn ks) i| + #|heard s (sumn ks) j|)%N.
Proof.
elim: ks s => [|k ks IH] s /=.
  have pos a : (0 < #|heard s 0 a|)%N by apply/card_gt0P; exists a; exact: heard_self.
  by move=> _ _; rewrite add0n (leq_add (pos i) (pos j)).
case=> [[r root] rest] dis.
have sub a := heard_before s k (sumn ks) a.
have dis' : [disjoint heard (s + k)%N (sumn ks) i & heard (s + k)%N (sumn ks) j].
  apply: disjointWl (sub i) _; exact: disjointWr (sub j) dis.
have {}IH := IH (s + k)%N rest dis'.
have [Ei|ni] := eqVneq (heard (s + k)%N (sumn ks) i) (heard s (k + sumn ks)%N i); last first.
  have lt : (#|heard (s + k)%N (sumn ks) i| < #|heard s (k + sumn ks)%N i|)%N.
    by apply: proper_card; rewrite properEneq ni sub.
  by apply: leq_trans (leq_add lt (subset_leq_card (sub j))); rewrite !addSn ltnS.
have [Ej|nj] := eqVneq (heard (s + k)%N (sumn ks) j) (heard s (k + sumn ks)%N j); last first.
  have lt : (#|heard (s + k)%N (sumn ks) j| < #|heard s (k + sumn ks)%N j|)%N.
    by apply: proper_card; rewrite properEneq nj sub.
  by apply: leq_trans (leq_add (subset_leq_card (sub i)) lt); rewrite addSn [X in (_ <= X)%N]addnS ltnS.
have inr a : heard (s + k)%N (sumn ks) a = heard s (k + sumn ks)%N a -> r \in heard s (k + sumn ks)%N a.
  by move=> E; apply: (heard_closed E) (root a); exact: heard_self.
by move: (disjointFr dis (inr i Ei)); rewrite (inr j Ej).
Qed.

(* n-1 windows: every two birds have listened to a common one *)
Theorem scrambling s ks i j : rooted_windows s ks -> (n.-1 <= size ks)%N ->
  exists l, 0 < span P s (sumn ks) i l /\ 0 < span P s (sumn ks) j l.
Proof.
move=> W len; case D: [disjoint heard s (sumn ks) i & heard s (sumn ks) j]; last first.
  by move/negbT: D => /pred0Pn[l /andP[]] /=; rewrite !inE => li lj; exists l.
have := heard_meet W D; rewrite -cardsUI (_ : _ :&: _ = set0); last by apply/eqP; rewrite setI_eq0.
have le : (#|heard s (sumn ks) i :|: heard s (sumn ks) j| <= n)%N by rewrite -[X in (_ <= X)%N](card_ord n) max_card.
have n0 := leq_ltn_trans (leq0n _) (ltn_ord i); rewrite cards0 addn0 => h.
by have := leq_trans h le; move: len n0; lia.
Qed.

Lemma tau1_scrambling s ks beta : 0 <= beta <= 1 ->
  (forall i j, 0 < span P s (sumn ks) i j -> beta <= span P s (sumn ks) i j) ->
  rooted_windows s ks -> (n.-1 <= size ks)%N -> tau1 (span P s (sumn ks)) <= 1 - beta.
Proof.
case/andP=> b0 b1 H W len; apply: tau1_le; rewrite ?subr_ge0 // => i j.
have SS := stochastic_span s (sumn ks) SP; have [A0 _] := SS.
rewrite dist1_overlap // ler_add2l ler_opp2 /overlap; have [l [il jl]] := scrambling i j W len.
rewrite (bigD1 l) //= -[beta]addr0 ler_add //; first by rewrite le_minr !H.
by apply: sumr_ge0 => m _; rewrite le_minr !A0.
Qed.

(* tau_1 never grows *)
Lemma tau1_span_mono s k l : (k <= l)%N -> tau1 (span P s l) <= tau1 (span P s k).
Proof.
move=> kl; rewrite -(subnKC kl) span_add.
apply: le_trans (tau1_mul _ (stochastic_span _ _ SP)) _; rewrite -[X in _ <= X]mul1r.
by apply: ler_wpmul2r; [exact: tau1_ge0 | exact: tau1_le1 (stochastic_span _ _ SP)].
Qed.

Lemma rooted_inhabited s k ks : rooted_windows s (k :: ks) -> exists i : 'I_n, True.
Proof. by case=> -[r _] _; exists r. Qed.

(* any number of windows: one factor 1 - beta for every n-1 of them *)
Lemma tau1_windows beta : 0 <= beta <= 1 ->
  (forall s k i j, 0 < span P s k i j -> beta <= span P s k i j) ->
  forall s ks, rooted_windows s ks -> tau1 (span P s (sumn ks)) <= (1 - beta) ^+ (size ks %/ n.-1).
Proof.
move=> b01 H s ks; have [b0 b1] := andP b01; have [m] := ubnP (size ks).
elim: m ks s => // m IH ks s szm W.
have [m0|mn] := posnP n.-1.
  by rewrite m0 divn0 expr0; exact: tau1_le1 (stochastic_span _ _ SP).
have [lt|ge] := ltnP (size ks) n.-1.
  by rewrite divn_small // expr0; exact: tau1_le1 (stochastic_span _ _ SP).
move: W; rewrite -{1}[ks](cat_take_drop n.-1) rooted_windows_cat => -[W1 W2].
have sz1 : size (take n.-1 ks) = n.-1 by rewrite size_takel.
have -> : (size ks %/ n.-1 = (size (drop n.-1 ks) %/ n.-1).+1)%N.
  by rewrite size_drop -[in LHS](subnKC ge) divnDl // divnn mn.
rewrite -[in span _ _ _](cat_take_drop n.-1 ks) sumn_cat span_add exprSr.
apply: le_trans (tau1_mul _ (stochastic_span _ _ SP)) _.
apply: ler_pmul; rewrite ?tau1_ge0 //.
  by apply: IH => //; rewrite size_drop; move: szm ge mn; lia.
by apply: tau1_scrambling => [//|i j| |]; [exact: H | exact: W1 | rewrite sz1].
Qed.
End Windows.

(* ---- uniformly bounded windows, directed networks ---- *)
Section Uniform.
Variables (R : realFieldType) (n : nat) (P : nat -> 'M[R]_n) (gamma : R) (B : nat).
Hypothesis SP : forall t, stochastic (P t).
Hypothesis diag : forall t i, 0 < P t i i.
Hypothesis gamma0 : 0 < gamma.
Hypothesis gamma_le : forall t i j, P t i j != 0 -> gamma <= P t i j.
Hypothesis repeatedly : forall s, rooted (window P s B).

Let P0 t i j : 0 <= P t i j. Proof. by have [] := SP t. Qed.

Lemma gamma_le1 : gamma <= 1.
Proof.
have [r _] := repeatedly 0; have [_ s1] := SP 0.
apply: le_trans (gamma_le (lt0r_neq0 (diag 0 r))) _.
by rewrite -(s1 r) (bigD1 r) //= ler_addl sumr_ge0 // => j _; exact: P0.
Qed.
(* a positive entry of a product of k factors is at least gamma^k *)
Lemma span_entries s k i j : 0 < span P s k i j -> gamma ^+ k <= span P s k i j.
Proof.
elim: k i => [|k IH] i.
  by rewrite /= mxE expr0; case: (i == j); rewrite ?ltxx.
move=> pos; have [l] : exists l, 0 < P (s + k)%N i l * span P s k l j.
  case: (pickP (fun l => 0 < P (s + k)%N i l * span P s k l j)) => [l h|none]; first by exists l.
  move: pos; rewrite /= mxE big1 ?ltxx // => l _; apply/le_anti.
  by rewrite mulr_ge0 ?(span_ge0 _ _ P0) // andbT leNgt none.
move=> h; have lj : 0 < span P s k l j.
  by rewrite lt_def (span_ge0 _ _ P0) andbT; apply: contraTneq h => ->; rewrite mulr0 ltxx.
have il : P (s + k)%N i l != 0 by apply: contraTneq h => ->; rewrite mul0r ltxx.
apply: le_trans (mul_ge_term i l j (P0 _) (span_ge0 _ _ P0)).
by rewrite exprS ler_pmul ?exprn_ge0 ?(ltW gamma0) ?gamma_le ?IH.
Qed.

Lemma repeated_windows s w : rooted_windows P s (nseq w B).
Proof. by elim: w s => //= w IH s. Qed.

(* every window of B consecutive times is rooted: a factor 1 - gamma^((n-1)B) for every (n-1)B steps *)
Theorem tau1_repeatedly s t :
  tau1 (span P s t) <= (1 - gamma ^+ (n.-1 * B)) ^+ (t %/ (n.-1 * B)).
Proof.
set m := (n.-1 * B)%N; have b01 : 0 <= gamma ^+ m <= 1.
  by rewrite exprn_ge0 ?(ltW gamma0) // exprn_ile1 ?(ltW gamma0) ?gamma_le1.
have step u : tau1 (span P u m) <= 1 - gamma ^+ m.
  have E : m = sumn (nseq n.-1 B) by rewrite sumn_nseq mulnC.
  rewrite {1}E; apply: (tau1_scrambling SP diag b01); rewrite ?size_nseq //; last exact: repeated_windows.
  by move=> i j; rewrite -E; exact: span_entries.
have main q u : tau1 (span P u (q * m)) <= (1 - gamma ^+ m) ^+ q.
  elim: q => [|q IH]; first by rewrite mul0n expr0; exact: tau1_le1 (stochastic_span _ _ SP).
  rewrite mulSn addnC span_add exprS; apply: le_trans (tau1_mul _ (stochastic_span _ _ SP)) _.
  by apply: ler_pmul; rewrite ?tau1_ge0.
exact: le_trans (tau1_span_mono SP s (leq_trunc_div t m)) (main _ _).
Qed.
End Uniform.

(* ---- symmetric footprints, windows of any lengths ---- *)
Section Symmetric.
Variables (R : realFieldType) (n : nat) (P : nat -> 'M[R]_n) (alpha : R).
Hypothesis SP : forall t, stochastic (P t).
Hypothesis diag : forall t i, 0 < P t i i.
Hypothesis sym : forall t i j, (P t i j != 0) = (P t j i != 0).
Hypothesis alpha0 : 0 < alpha.
Hypothesis alpha_le : forall t i j, P t i j != 0 -> alpha <= P t i j.

Lemma connected_windows_bound (i : 'I_n) : 0 <= alpha ^+ n.-1 <= 1.
Proof.
by rewrite exprn_ge0 ?(ltW alpha0) // exprn_ile1 ?(ltW alpha0) ?(alpha_le1 SP diag alpha_le i).
Qed.

(* a factor 1 - alpha^(n-1) for every n-1 connected windows, whatever their lengths ks *)
Theorem tau1_connected_windows s ks : rooted_windows P s ks ->
  tau1 (span P s (sumn ks)) <= (1 - alpha ^+ n.-1) ^+ (size ks %/ n.-1).
Proof.
case: ks => [|k ks] W; first by rewrite div0n expr0; exact: tau1_le1 (stochastic_span _ _ SP).
have [i _] := rooted_inhabited W.
apply: (tau1_windows SP diag (connected_windows_bound i)) W => u l a b ab.
by apply: (entries_bound SP diag sym alpha0 alpha_le); rewrite lt0r_neq0.
Qed.

(* connected again and again, without a bound on the windows *)
Hypothesis recurrent : forall s, exists k, rooted (window P s k).

Lemma recurrent_windows w s : exists ks, size ks = w /\ rooted_windows P s ks.
Proof.
elim: w s => [|w IH] s; first by exists [::].
have [k rk] := recurrent s; have [ks [sz W]] := IH (s + k)%N.
by exists (k :: ks); rewrite /= sz.
Qed.
Theorem tau1_recurrent s q : exists k, forall l, (k <= l)%N ->
  tau1 (span P s l) <= (1 - alpha ^+ n.-1) ^+ q.
Proof.
have [k0 [i _]] := recurrent 0; have [ks [sz W]] := recurrent_windows (q * n.-1) s.
exists (sumn ks) => l kl; apply: le_trans (tau1_span_mono SP s kl) _.
have := tau1_connected_windows W; rewrite sz; case: (posnP n.-1) => [m0|m0]; last by rewrite mulnK.
(* one bird *)
have one : tau1 (span P s (sumn ks)) = 0.
  apply/le_anti; rewrite tau1_ge0 andbT; apply: tau1_le => // a b.
  have n1 : (n <= 1)%N by move: m0; case: (n) => [|[]].
  have -> : a = b.
    by apply/ord_inj; move: (leq_trans (ltn_ord a) n1) (leq_trans (ltn_ord b) n1); rewrite !ltnS !leqn0 => /eqP-> /eqP->.
  by rewrite /dist1 big1 ?mulr0 // => c _; rewrite subrr normr0.
rewrite one => _; apply: exprn_ge0; rewrite subr_ge0; by have /andP[] := connected_windows_bound i.
Qed.
End Symmetric.
