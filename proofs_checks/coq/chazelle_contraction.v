(* Chazelle, proof of Lemma 3.1, (3.6): every stabiliser takes the same factor off tau.
     chazelle.eq3.6.
   The factors of (3.5) are row-stochastic blocks: after T_k nothing outside V_k is heard inside, so the block
   product over V_k is the whole product there, its rows add up to 1 and its positive entries are at least
   alpha^(n-1) (Lemma 2.2).  The column of the first bird is positive, so tau_1 <= 1 - alpha^(n-1).
   A block with rows V and columns W is the matrix of its entries in the order of the birds.  No axioms. *)
Set Warnings "-notation-overridden,-ambiguous-paths".
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import ring zify.
From Flockproof Require Import chazelle_model chazelle_ergodicity chazelle_products chazelle_stabilisers.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Import GRing.Theory Num.Theory Order.Theory.
Local Open Scope ring_scope.

(* the entries with rows in V and columns in W *)
Definition restrict (R : realFieldType) n (V W : {set 'I_n}) (A : 'I_n -> 'I_n -> R) : 'M[R]_(#|V|, #|W|) :=
  \matrix_(i, j) A (enum_val i) (enum_val j).

Section Restrict.
Variables (R : realFieldType) (n : nat).
Implicit Types V W X : {set 'I_n}.

Lemma sum_enum V (F : 'I_n -> R) : \sum_(l in V) F l = \sum_(l < #|V|) F (enum_val l).
Proof. by rewrite big_enum_val. Qed.
Lemma restrict_mul V W X (A B C : 'I_n -> 'I_n -> R) :
  (forall i j, i \in V -> j \in X -> C i j = \sum_(l in W) A i l * B l j) ->
  restrict V X C = restrict V W A *m restrict W X B.
Proof.
move=> H; apply/matrixP=> i j; rewrite !mxE H ?enum_valP // sum_enum.
by apply: eq_bigr => l _; rewrite !mxE.
Qed.
Lemma restrict_stochastic V W (A : 'I_n -> 'I_n -> R) : (forall i j, 0 <= A i j) ->
  (forall i, i \in V -> \sum_(l in W) A i l = 1) -> stochastic (restrict V W A).
Proof.
move=> A0 A1; split=> [i j|i]; first by rewrite mxE.
by rewrite -[RHS](A1 _ (enum_valP i)) sum_enum; apply: eq_bigr => l _; rewrite mxE.
Qed.
End Restrict.

Section Contraction.
Variables (R : realFieldType) (n : nat) (P : nat -> 'M[R]_n).
Hypothesis SP : forall t, stochastic (P t).
Hypothesis diag : forall t i, 0 < P t i i.
Hypothesis sym : forall t i j, (P t i j != 0) = (P t j i != 0).
Variables (b : 'I_n) (T : nat -> nat) (V : nat -> {set 'I_n}).
Hypothesis V0 : V 0 = setT.
Hypothesis T_incr : forall k, (T k < T k.+1)%N.
Hypothesis V_next : forall k i, (i \in V k.+1) = (i \in V k) && (block P (V k) (T k).+1 (T k.+1 - T k) i b != 0).
Hypothesis V_stable : forall k t i, (T k.+1 <= t)%N -> i \in V k ->
  block P (V k) (T k).+1 (t - T k) i b != 0 -> i \in V k.+1.

Let stab k := stabilisers SP diag sym V0 T_incr V_next V_stable k.

(* after T_k the block product over V_k is the whole product, and nothing outside is heard *)
Lemma block_whole k s u i j : (T k < s)%N -> i \in V k ->
  span P s u i j = if j \in V k then block P (V k) s u i j else 0.
Proof.
elim: k s i j => [|k IH] s i j Ts iV; first by rewrite V0 inE block_all.
have [sub _ _ _] := stab k; have iVk := subsetP sub i iV.
rewrite IH ?(ltn_trans (T_incr k)) //; case jV: (j \in V k).
  exact: (block_restrict SP diag sym V0 T_incr V_next V_stable u Ts iV jV).
by case jV': (j \in V k.+1) => //; rewrite (subsetP sub) in jV.
Qed.
Lemma block_row k u i : i \in V k -> \sum_(l in V k) block P (V k) (T k).+1 u i l = 1.
Proof.
move=> iV; have [_ s1] := stochastic_span (T k).+1 u SP; rewrite -[RHS](s1 i) [RHS](bigID (fun l => l \in V k)) /=.
rewrite [X in _ = _ + X]big1 ?addr0 => [|l /negbTE lN]; last by rewrite (block_whole (k := k)) // lN.
by apply: eq_bigr => l lV; rewrite (block_whole (k := k)) // lV.
Qed.

(* the last factor, with rows and columns V_k, and the factor of T_(k+1), with rows V_(k+1) and columns V_k *)
Definition last_factor k u := restrict (V k) (V k) (block P (V k) (T k).+1 u).
Definition factor k := restrict (V k.+1) (V k) (block P (V k) (T k).+1 (T k.+1 - T k)).

Lemma last_stochastic k u : stochastic (last_factor k u).
Proof. by apply: restrict_stochastic => [i j|i]; [exact: block_ge0 | exact: block_row]. Qed.
Lemma factor_stochastic k : stochastic (factor k).
Proof.
have [sub _ _ _] := stab k; apply: restrict_stochastic => [i j|i iV]; first exact: block_ge0.
by apply: block_row; exact: subsetP sub i iV.
Qed.
Lemma tower_ge0 k i j : 0 <= tower P T V k i j.
Proof.
elim: k i => [|k IH] i /=; first exact: ler0n.
by apply: sumr_ge0 => l _; rewrite mulr_ge0 // block_ge0.
Qed.
Lemma towerS k : restrict (V k.+1) setT (tower P T V k.+1) = factor k *m restrict (V k) setT (tower P T V k).
Proof. by apply: restrict_mul. Qed.
Lemma tower_stochastic k : stochastic (restrict (V k) setT (tower P T V k)).
Proof.
elim: k => [|k IH]; last by rewrite towerS; apply: stochastic_mul IH; exact: factor_stochastic.
apply: restrict_stochastic => [i j|i _]; first exact: tower_ge0.
rewrite (bigD1 i) ?inE //= eqxx big1 ?addr0 // => l /andP[_ li]; by rewrite eq_sym (negbTE li).
Qed.
Lemma tower_tau1 k : tau1 (restrict (V k) setT (tower P T V k)) <= \prod_(i < k) tau1 (factor i).
Proof.
elim: k => [|k IH]; first by rewrite big_ord0; apply: tau1_le1; exact: tower_stochastic.
rewrite towerS big_ord_recr /= mulrC; apply: le_trans (tau1_mul _ (factor_stochastic k)) _.
by apply: ler_wpmul2l; rewrite ?tau1_ge0.
Qed.

(* the product up to T_k + u, as in (3.5) *)
Definition whole k u := restrict (V k) setT (fun i j => span P (T 0).+1 (T k - T 0 + u)%N i j).
Lemma whole_split k u : whole k u = last_factor k u *m restrict (V k) setT (tower P T V k).
Proof.
by apply: restrict_mul => i j iV _; exact: (eq_3_5 SP diag sym V0 T_incr V_next V_stable u j iV).
Qed.

(* entries: Lemma 2.2 *)
Variable alpha : R.
Hypothesis alpha0 : 0 < alpha.
Hypothesis alpha_le : forall t i j, P t i j != 0 -> alpha <= P t i j.

Lemma factor_tau1 k : tau1 (factor k) <= 1 - alpha ^+ n.-1.
Proof.
have [sub bV _ pos] := stab k.
have a1 : alpha <= 1 := alpha_le1 SP diag alpha_le b.
apply: (tau1_column (k := enum_rank_in bV b) (factor_stochastic k)).
  by rewrite exprn_ge0 ?(ltW alpha0) // exprn_ile1 ?(ltW alpha0).
move=> i; rewrite mxE enum_rankK_in //; have iV := enum_valP i; have iVk := subsetP sub _ iV.
have nz := lt0r_neq0 (pos _ iV); have := @block_whole k (T k).+1 (T k.+1 - T k) (enum_val i) b (ltnSn _) iVk.
rewrite bV => E; rewrite -E; apply: (entries_bound SP diag sym alpha0 alpha_le).
by rewrite E.
Qed.

Theorem contraction_product k u :
  tau1 (last_factor k u) * \prod_(i < k) tau1 (factor i) <= (1 - alpha ^+ n.-1) ^+ k.
Proof.
rewrite -[X in _ <= X]mul1r; apply: ler_pmul; rewrite ?tau1_ge0 //.
- by apply: prodr_ge0 => i _; exact: tau1_ge0.
- exact: tau1_le1 (last_stochastic k u).
rewrite -[X in _ <= _ ^+ X]card_ord -prodr_const; apply: ler_prod => i _.
by rewrite tau1_ge0 factor_tau1.
Qed.
End Contraction.

(* chazelle.eq3.6: both inequalities; (1 - n^-(a(n-1)))^k is at most e^(-k n^-(a(n-1))) *)
Theorem eq_3_6 (R : rcfType) n a (G : nat -> rel 'I_n) (c : nat -> 'I_n -> R) (b : 'I_n)
  (T : nat -> nat) (V : nat -> {set 'I_n}) :
  (forall t, network (G t)) -> (forall t, model_D (G t) (c t)) ->
  let P t := transition (G t) (c t) in
  (forall t i j, P t i j != 0 -> (n%:R ^+ a)^-1 <= P t i j) ->
  V 0%N = setT -> (forall k, (T k < T k.+1)%N) ->
  (forall k i, (i \in V k.+1) = (i \in V k) && (block P (V k) (T k).+1 (T k.+1 - T k) i b != 0)) ->
  (forall k t i, (T k.+1 <= t)%N -> i \in V k -> block P (V k) (T k).+1 (t - T k) i b != 0 -> i \in V k.+1) ->
  forall k t, (T k < t)%N ->
  tau2 (restrict (V k) (V 0%N) (fun i j => pprod P t (T 0%N).+1 i j)) <=
    Num.sqrt 2%:R * (tau1 (restrict (V k) (V k) (fun i j => pprod P t (T k).+1 i j)) *
      \prod_(i < k) tau1 (restrict (V i.+1) (V i) (block P (V i) (T i).+1 (T i.+1 - T i)))) /\
  Num.sqrt 2%:R * (tau1 (restrict (V k) (V k) (fun i j => pprod P t (T k).+1 i j)) *
      \prod_(i < k) tau1 (restrict (V i.+1) (V i) (block P (V i) (T i).+1 (T i.+1 - T i)))) <=
    Num.sqrt 2%:R * (1 - (n%:R ^+ (a * n.-1))^-1) ^+ k.
Proof.
move=> net MD P ale V0 Ti Vn Vs k t Tt.
have SP u : stochastic (P u) by exact: (proj1 (model_D_stochastic (net u) (@MD u))).
have diag u i : 0 < P u i i by exact: (proj2 (model_D_stochastic (net u) (@MD u)) i).
have sym u i j : (P u i j != 0) = (P u j i != 0).
  by rewrite !transition_edge // eq_sym; have [-> _] := net u.
have n0 : (0 < n)%N by exact: leq_ltn_trans (leq0n _) (ltn_ord b).
have T0 : (T 0%N <= T k)%N by elim: (k) => // m h; apply: leq_trans h (ltnW (Ti m)).
have a0 : 0 < (n%:R ^+ a)^-1 :> R by rewrite invr_gt0 exprn_gt0 // ltr0n.
pose L := last_factor P T V k (t - T k).
have -> : restrict (V k) (V k) (fun i j => pprod P t (T k).+1 i j) = L.
  apply/matrixP=> i j; rewrite mxE [RHS]mxE /pprod subnSK //.
  by rewrite (block_whole SP diag sym V0 Ti Vn Vs (k := k)) ?enum_valP.
have -> : tau2 (restrict (V k) (V 0%N) (fun i j => pprod P t (T 0%N).+1 i j)) = tau2 (whole P T V k (t - T k)).
  rewrite V0; congr tau2; apply/matrixP=> i j; rewrite mxE [RHS]mxE /pprod subnSK ?(leq_ltn_trans T0) //.
  by congr (span P _ _ _ _); move: T0 Tt; lia.
have s2 : 0 <= Num.sqrt 2%:R :> R by exact: sqrtr_ge0.
have SL : stochastic L by exact: (last_stochastic SP diag sym V0 Ti Vn Vs).
have ST := tower_stochastic SP diag sym V0 Ti Vn Vs k.
split; last first.
  apply: ler_wpmul2l => //; rewrite exprM -exprVn.
  exact: (contraction_product SP diag sym V0 Ti Vn Vs a0 ale k (t - T k)).
rewrite (whole_split SP diag sym V0 Ti Vn Vs).
apply: le_trans (lemma_2_4 SL ST) _; rewrite [X in _ <= X]mulrCA; apply: ler_wpmul2l; first exact: tau1_ge0.
have [h1 h2] := tau2_le_tau1 ST; apply: le_trans (le_trans h1 h2) _; apply: ler_wpmul2l => //.
exact: (tower_tau1 SP diag sym V0 Ti Vn Vs).
Qed.
