(* Chazelle, end of the proof of Lemma 3.1: the count of network changes that are left forgets the birds outside V_k.
     chazelle.lem3.1.count.
   Three birds on the line, x(0) = (0, 11, 10), v(1) = (0, 3, 5), c_i = 1/4.  The first bird is alone for ever, so its column
   is stable from T_1 = 1 on and V_1 = {first bird}, which leaves binom(1, 2) = 0 changes.  But the other two are joined up to
   t = 1 and part at t = 2.  Positions are counted in halves.  Any ordered field, no axioms. *)
Set Warnings "-notation-overridden,-ambiguous-paths".
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import ring zify.
From Flockproof Require Import chazelle_model chazelle_ergodicity chazelle_stabilisers.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Import GRing.Theory Num.Theory Order.Theory.
Local Open Scope ring_scope.

(* a flock on the line with the hysteresis rule: positions, velocities, networks, weights *)
Definition line_flock (R : realFieldType) n (eps : R) (x v : nat -> 'cV[R]_n) (G : nat -> rel 'I_n) (c : nat -> 'I_n -> R) :=
  [/\ forall i j, G 0%N i j = (i != j) && (`|x 0%N i 0 - x 0%N j 0| <= 1),
      forall t i j, G t.+1 i j = (i != j) && ((`|x t.+1 i 0 - x t.+1 j 0| <= 1) ||
        (G t i j && (`| `|x t.+1 i 0 - x t.+1 j 0| - `|x t i 0 - x t j 0| | < eps))),
      forall t, model_D (G t) (c t),
      forall t, x t.+1 = x t + v t.+1 &
      forall t, (0 < t)%N -> v t.+1 = transition (G t) (c t) *m v t].
(* the network of time u is another one than before *)
Definition changes n (G : nat -> rel 'I_n) (u : nat) : bool := [exists i, exists j, G u i j != G u.-1 i j].

Section Counterexample.
Variables (R : realFieldType) (eps : R).
Hypothesis eps_range : 0 < eps <= 1.

Definition place (t i : nat) : nat :=
  if t is u.+1 then nth 0%N [:: 0; 28 + 7 * u; 30 + 9 * u]%N i else nth 0%N [:: 0; 22; 20]%N i.
Definition speed (t i : nat) : nat :=
  if t is u.+2 then nth 0%N [:: 0; 7; 9]%N i else nth 0%N [:: 0; 6; 10]%N i.
Definition xs t : 'cV[R]_3 := \col_i ((place t i)%:R / 2%:R).
Definition vs t : 'cV[R]_3 := \col_i ((speed t i)%:R / 2%:R).
(* the second and third bird are joined at t = 0 and t = 1 *)
Definition Gs t : rel 'I_3 := fun i j => [&& (t < 2)%N, (0 < i)%N, (0 < j)%N & i != j].
Definition cs (t : nat) (i : 'I_3) : R := 4%:R^-1.
Let b : 'I_3 := ord0.

Lemma half_near (p q : nat) : (`|p%:R / 2%:R - q%:R / 2%:R| <= 1 :> R) = (p <= q + 2)%N && (q <= p + 2)%N.
Proof.
rewrite -mulrBl normrM [ `|2%:R^-1| ]gtr0_norm ?invr_gt0 ?ltr0n // ler_pdivr_mulr ?ltr0n // mul1r.
by rewrite ler_distl ler_subl_addr -!natrD !ler_nat andbC.
Qed.

Lemma GsE t i j : Gs t i j = [&& (t < 2)%N, (0 < i)%N, (0 < j)%N & i != j]. Proof. by []. Qed.
Lemma Gs_network t : network (Gs t).
Proof.
split=> [i j|i]; first by rewrite !GsE eq_sym; case: (t < 2)%N; rewrite //= andbCA.
by rewrite GsE eqxx !andbF.
Qed.
Lemma places t i j : i != j -> (`|xs t i 0 - xs t j 0| <= 1) = Gs t i j.
Proof.
rewrite !mxE half_near GsE => ij.
case: t => [|t]; case: i j ij => [[|[|[|?]]] ?] // [[|[|[|?]]] ?] //= _; rewrite ?addn0 ?muln0 //; apply/idP/idP; lia.
Qed.

Lemma Gs_rule0 i j : Gs 0 i j = (i != j) && (`|xs 0 i 0 - xs 0 j 0| <= 1).
Proof. by case ij: (i == j); [rewrite GsE ij !andbF | rewrite places ?ij]. Qed.
(* when the two part their distance grows by 1, which no threshold up to 1 forgives *)
Lemma Gs_rule t i j : Gs t.+1 i j = (i != j) && ((`|xs t.+1 i 0 - xs t.+1 j 0| <= 1) ||
  (Gs t i j && (`| `|xs t.+1 i 0 - xs t.+1 j 0| - `|xs t i 0 - xs t j 0| | < eps))).
Proof.
case ij: (i == j); first by rewrite GsE ij !andbF.
rewrite places ?ij //=; case G1: (Gs t.+1 i j) => //=.
case G0: (Gs t i j) => //=; apply/esym/negbTE; rewrite -leNgt.
case: t G1 G0 => [|[|t]]; rewrite !GsE ?ij //=; first by move=> ->.
case/andP: eps_range => _ e1 _ /and3P[i0 j0 _]; apply: le_trans e1 _.
have E t k l : `|xs t k 0 - xs t l 0| = `|(place t k)%:R - (place t l)%:R| / 2%:R.
  by rewrite !mxE -mulrBl normrM [ `|2%:R^-1| ]gtr0_norm // invr_gt0 ltr0n.
have D (p q : nat) : (p <= q)%N -> `|p%:R - q%:R| = (q - p)%:R :> R.
  by move=> pq; rewrite distrC -natrB // normr_nat.
have last : 1 <= `|(4%:R - 2%:R) / 2%:R| :> R.
  by rewrite -natrB // mulfV ?pnatr_eq0 // normr1.
rewrite !E -mulrBl.
case: i j ij i0 j0 => [[|[|[|?]]] ?] // [[|[|[|?]]] ?] //= _ _ _.
  by rewrite !D.
by rewrite ![`|39%:R - _|]distrC ![`|(30 + 9 * 0)%:R - _|]distrC !D.
Qed.

Lemma degreeE t i : degree (Gs t) i = ((t < 2) && (0 < i))%N :> nat.
Proof.
case t2: (t < 2)%N; last by apply: eq_card0 => j; rewrite inE GsE t2.
case: i => [[|[|[|?]]] ?] //=.
- by apply: eq_card0 => j; rewrite inE GsE /= andbF.
- rewrite -[RHS](card1 (@Ordinal 3 2 isT)); apply: eq_card => -[[|[|[|?]]] ?] //; by rewrite !inE GsE t2.
by rewrite -[RHS](card1 (@Ordinal 3 1 isT)); apply: eq_card => -[[|[|[|?]]] ?] //; rewrite !inE GsE t2.
Qed.
Lemma Gs_model t : @model_D R 3 (Gs t) (cs t).
Proof.
move=> i; rewrite degreeE; case: (_ && _) => // _.
by rewrite mulr1 invr_gt0 ltr0n invf_lt1 ?ltr0n // ltr1n.
Qed.
Lemma Gs_moves t : xs t.+1 = xs t + vs t.+1.
Proof.
apply/colP=> i; rewrite !mxE -mulrDl -natrD; congr (_%:R / _).
case: t => [|t]; case: i => [[|[|[|?]]] ?] //=; lia.
Qed.
Lemma Gs_steers t : (0 < t)%N -> vs t.+1 = transition (Gs t) (cs t) *m vs t.
Proof.
move=> t0; have [_ irr] := Gs_network t; apply/colP=> i.
rewrite mxE [RHS]mxE !big_ord_recl big_ord0 !transitionE // !degreeE !GsE !mxE /cs.
case: t t0 {irr} => [|[|t]] // _; case: i => [[|[|[|?]]] ?] //=; by field.
Qed.

Theorem is_flock : line_flock eps xs vs Gs cs.
Proof.
split; [exact: Gs_rule0 | exact: Gs_rule | exact: Gs_model | exact: Gs_moves | exact: Gs_steers].
Qed.
Let P t := transition (Gs t) (cs t) : 'M[R]_3.
Lemma column_b t i : P t i b = (i == b)%:R.
Proof.
have [_ irr] := Gs_network t; rewrite /P transitionE //.
by case: eqP => [->|_]; rewrite ?degreeE ?GsE ?andbF ?mulr0 ?subr0 //= andbF.
Qed.
Lemma block_b (V : {set 'I_3}) s k i : b \in V -> block P V s k i b = (i == b)%:R.
Proof.
move=> bV; elim: k i => [|k IH] i //=; rewrite (bigD1 b) //= IH eqxx mulr1 column_b big1 ?addr0 //.
by move=> l /andP[_ /negbTE lb]; rewrite IH lb mulr0.
Qed.
End Counterexample.

(* every P(t) with t > 1 is the identity, so the footprint of P(t,1) stays that of P(1,1) *)
Lemma span_still (R : realFieldType) t :
  span (fun t => transition (Gs t) (cs R t)) 1 t.+1 = span (fun t => transition (Gs t) (cs R t)) 1 1.
Proof.
elim: t => [//|t IH]; rewrite [LHS]/= -/(span _ 1 t.+1) IH.
suff -> : transition (Gs (1 + t.+1)) (cs R (1 + t.+1)) = 1%:M by rewrite mul1mx.
have [_ irr] := Gs_network (1 + t.+1); apply/matrixP=> i j.
by rewrite transitionE // degreeE GsE /= mulr0 subr0 mxE; case: eqP.
Qed.

(* chazelle.lem3.1.count, negation only for k = 1: T_0 = 0, T_1 = 1, and b is the first bird; the proof of the lemma takes
   k = nu^(b nu^2) *)
Theorem count_fails (R : realFieldType) (eps : R) : 0 < eps <= 1 ->
  exists (x v : nat -> 'cV[R]_3) (G : nat -> rel 'I_3) (c : nat -> 'I_3 -> R) (b : 'I_3) (T : nat -> nat)
    (V : nat -> {set 'I_3}),
  let P t := transition (G t) (c t) in
  [/\ line_flock eps x v G c,
      [/\ T 0%N = 0%N, V 0%N = setT, (forall k, (T k < T k.+1)%N),
        (forall k i, (i \in V k.+1) = (i \in V k) && (block P (V k) (T k).+1 (T k.+1 - T k) i b != 0)) &
        forall k t i, (T k.+1 <= t)%N -> i \in V k -> block P (V k) (T k).+1 (t - T k) i b != 0 -> i \in V k.+1],
      (* the footprint of P(t,1) no longer changes from T_1 = 1 on *)
      T 1%N = 1%N /\ forall t i j, (0 < t)%N -> footprint (span P 1 t) i j = footprint (span P 1 1) i j,
      (* birds of V_1 that are joined after T_1 + 1 remain so *)
      (forall t i j, (T 1%N + 1 < t)%N -> i \in V 1%N -> j \in V 1%N -> G t i j -> G t.+1 i j) &
      (* there are more changes than counted *)
      exists t, (N (changes G) (T 1%N) 1 + 'C(#|V 1%N|, 2) < N (changes G) t 1)%N].
Proof.
move=> er; pose U (k : nat) : {set 'I_3} := if k is 0%N then setT else [set ord0].
have bU k : ord0 \in U k by case: k => [|k]; rewrite inE.
exists (xs R), (vs R), Gs, (cs R), ord0, id, U; split.
- exact: is_flock.
- split=> //.
    move=> k i; rewrite block_b ?bU // pnatr_eq0 eqb0 negbK [in LHS]inE.
    by case: k => [|k]; rewrite inE ?andbb.
  by move=> k t i _ iV; rewrite block_b ?bU // pnatr_eq0 eqb0 negbK inE.
- by split=> // -[//|t] i j _; rewrite span_still.
- by move=> t i j _; rewrite !inE => /eqP-> /eqP->; rewrite GsE eqxx !andbF.
exists 2%N; rewrite cards1 /N /=.
have -> : changes Gs 2 = true; last by [].
by apply/existsP; exists (@Ordinal 3 1 isT); apply/existsP; exists (@Ordinal 3 2 isT).
Qed.
