(* beyond.paley.inertia clauses 1, 2, 3, 5 in their words: phases as points (c_k, s_k) of the circle over any ordered field, with the second
   derivatives of U_1 = |sum e^(i theta)|^2/(2N) written out (that they are these is audit_independent_hessian), and the inertia by
   independent vectors. Stated with definitions of their own after the theorems had been seen; the theorems prove them. *)
Set Warnings "-notation-overridden,-ambiguous-paths".
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import ring.
From Flockproof Require paley_inertia.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Import GRing.Theory Num.Theory Order.Theory.
Local Open Scope ring_scope.

Section Words.
Variables (R : realFieldType) (n : nat).
Implicit Types (c s : 'I_n -> R) (H : 'M[R]_n).
Definition phases c s := forall k, c k ^+ 2 + s k ^+ 2 = 1.
(* cos and sin of theta_k - theta_j *)
Definition cosd c s k j := c k * c j + s k * s j.
Definition sind c s k j := s k * c j - c k * s j.
Definition second_derivatives c s : 'M[R]_n := \matrix_(k, l) (n%:R^-1 * (if k == l then - \sum_(j | j != k) cosd c s j k else cosd c s k l)).
Definition critical c s := forall k : 'I_n, - (n%:R^-1 * \sum_j sind c s k j) = 0 :> R.
(* the form is positive on the combinations of the rows of P, but for the trivial one *)
Definition positive H m (P : 'M[R]_(m, n)) := forall x : 'rV_m, x != 0 -> 0 < ((x *m P) *m H *m (x *m P)^T) 0 0.
(* p, but not p + 1 such vectors; the same for the negative; the null vectors have z dimensions *)
Definition has_inertia H (p q z : nat) :=
  [/\ exists P : 'M_(p, n), positive H P, forall P : 'M_(p.+1, n), ~ positive H P,
      exists P : 'M_(q, n), positive (- H) P, forall P : 'M_(q.+1, n), ~ positive (- H) P & (\rank H + z)%N = n].
(* b of the phases are opposite to the others *)
Definition opposite c s (b : nat) := exists (B : {set 'I_n}) (ce se : R), [/\ #|B| = b, ce ^+ 2 + se ^+ 2 = 1 &
  forall k, c k = (if k \in B then - ce else ce) /\ s k = (if k \in B then - se else se)].
Definition balanced c s := \sum_k c k = 0 /\ \sum_k s k = 0.
Definition on_line c s := forall k j, sind c s k j = 0.
Definition inertia_1 := forall c s b, (1 < n)%N -> opposite c s b -> (b < n - b)%N -> has_inertia (second_derivatives c s) b (n - b - 1) 1.
Definition inertia_2 := forall c s, (1 < n)%N -> phases c s -> balanced c s -> ~ on_line c s -> has_inertia (second_derivatives c s) 2 0 (n - 2).
Definition inertia_3 := forall c s, (1 < n)%N -> phases c s -> balanced c s -> on_line c s -> has_inertia (second_derivatives c s) 1 0 (n - 1).
Definition inertia_5 := forall c s, (1 < n)%N -> phases c s -> (critical c s <-> balanced c s \/ exists b, (b < n - b)%N /\ opposite c s b).

(* ---- the theorems prove them ---- *)
Lemma second_is c s : (0 < n)%N -> phases c s -> second_derivatives c s = paley_inertia.hessian c s.
Proof.
move=> n0 u; apply/matrixP=> k l; rewrite mxE paley_inertia.hessianE //; congr (_ * _); case: eqP => [<-|_]; last by rewrite /cosd mul0r subr0.
rewrite mul1r !mulr_sumr -big_split /= [in RHS](bigD1 k) //= opprD addrA subrr sub0r.
by congr (- _); apply: eq_bigr => j _; rewrite /cosd mulrC [s j * _]mulrC.
Qed.
Lemma free_of H m (P : 'M[R]_(m, n)) : positive H P -> row_free P.
Proof.
move=> HP; rewrite -kermx_eq0; apply/eqP/row_matrixP => i; rewrite row0; apply/eqP/negP => /negP ne.
have := HP (row i (kermx P)) ne; have -> : row i (kermx P) *m P = 0 by rewrite -row_mul mulmx_ker row0.
by rewrite !mul0mx mxE ltxx.
Qed.
Lemma space_of H m (P : 'M[R]_(m, n)) : positive H P -> paley_inertia.positive_on H (<<P>>%MS : 'M_n) /\ \rank (<<P>>%MS : 'M_n) = m.
Proof.
move=> HP; split; last by rewrite genmxE; apply/eqP; exact: free_of HP.
move=> v; rewrite genmxE => /submxP[x ->] ne; apply: HP; by apply: contraNneq ne => ->; rewrite mul0mx.
Qed.
Lemma vectors_of H (W : 'M[R]_n) : paley_inertia.positive_on H W -> positive H (row_base W).
Proof.
move=> HW x x0; apply: HW; first by rewrite (submx_trans (submxMl _ _)) // eq_row_base.
by apply: contraNneq x0 => Z; apply/eqP; have F := row_base_free W; rewrite -(mulmxKp F x) Z mul0mx.
Qed.
Lemma negated H m (W : 'M[R]_(m, n)) : paley_inertia.negative_on H W <-> paley_inertia.positive_on (- H) W.
Proof.
have F v : paley_inertia.form (- H) v = - paley_inertia.form H v by rewrite /paley_inertia.form mulmxN mulNmx mxE.
by split=> h v vW v0; have := h v vW v0; rewrite F oppr_gt0.
Qed.
Lemma half H p : paley_inertia.largest (@paley_inertia.positive_on R n H n) p ->
  (exists P : 'M_(p, n), positive H P) /\ forall P : 'M_(p.+1, n), ~ positive H P.
Proof.
move=> [[W HW <-] most]; split; first by exists (row_base W); exact: vectors_of.
by move=> P /space_of[/most h r]; move: h; rewrite r ltnn.
Qed.
Lemma inertia_is H p q z : paley_inertia.inertia H p q z -> has_inertia H p q z.
Proof.
move=> [P [[W HW r] most] K]; have [P1 P2] := half P.
have [|Q1 Q2] := @half (- H) q; first by split=> [|V /negated]; [exists W => //; apply/negated | exact: most].
by split=> //; rewrite -K mxrank_ker subnKC // rank_leq_row.
Qed.
Lemma clusters_is c s b : opposite c s b -> exists2 B : {set 'I_n}, #|B| = b & phases c s /\ exists ce se : R, ce ^+ 2 + se ^+ 2 = 1 /\
  forall k, c k = (if k \in B then -1 else 1) * ce /\ s k = (if k \in B then -1 else 1) * se.
Proof.
move=> [B [ce [se [Bb u E]]]]; exists B => //; split; first by move=> k; have [-> ->] := E k; case: ifP => _; rewrite ?sqrrN.
by exists ce, se; split=> // k; have [-> ->] := E k; case: ifP => _; rewrite ?mulN1r ?mul1r.
Qed.
Theorem inertia_1_holds : inertia_1.
Proof.
move=> c s b n1 /clusters_is[B <- [u E]] lt; rewrite second_is ?(ltnW n1) //; apply: inertia_is.
exact: (paley_inertia.inertia_two_clusters (ltnW n1)).
Qed.
Theorem inertia_2_holds : inertia_2.
Proof.
move=> c s n1 u bal off; rewrite second_is ?(ltnW n1) //; apply: inertia_is; apply: (paley_inertia.inertia_balanced (ltnW n1)) => // L.
by apply: off => k j; rewrite /sind -opprB L oppr0.
Qed.
Theorem inertia_3_holds : inertia_3.
Proof.
move=> c s n1 u bal on; rewrite second_is ?(ltnW n1) //; apply: inertia_is; apply: (paley_inertia.inertia_balanced_line (ltnW n1)) => // k j.
by have := on k j; rewrite /sind -opprB => /eqP; rewrite oppr_eq0 => /eqP.
Qed.
Theorem inertia_5_holds : inertia_5.
Proof.
move=> c s n1 u; have n0 := ltnW n1; have N0 : (n%:R : R) != 0 by rewrite pnatr_eq0 -lt0n.
have E : critical c s <-> forall k, paley_inertia.gradient (2%:R * n%:R)^-1 c s k = 0.
  have F k : - (n%:R^-1 * \sum_j sind c s k j) = paley_inertia.gradient (2%:R * n%:R)^-1 c s k.
    rewrite paley_inertia.gradientE -mulrN sumrB -!mulr_sumr opprB; congr (_ * _).
    by rewrite -[RHS]mulr_natl invfM mulVKf ?pnatr_eq0.
  by split=> h k; have := h k; rewrite F.
have T := paley_inertia.critical_points n0 u; split=> [/E /(proj1 T)|h].
  case=> [[b1 b2]|[B [lt [ce [se [e k]]]]]]; [by left|right].
  exists #|B|; split=> //; exists B, ce, se; split=> // l; have [-> ->] := k l; rewrite /paley_inertia.sg; by case: ifP => _; rewrite ?mulN1r ?mul1r.
apply/E/(proj2 T); case: h => [[b1 b2]|[b [lt /clusters_is[B Bb [_ cl]]]]]; [by left|right].
by exists B; split=> //; rewrite Bb.
Qed.
End Words.
