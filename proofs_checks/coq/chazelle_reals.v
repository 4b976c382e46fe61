(* Chazelle: the flocks of the paper have rational input, so their velocities are rational at all times; their limit
   need not be.  Here it is a real number: rational Cauchy sequences with their values in R converge.
     chazelle.fiedler.rate (changing networks, chazelle_agreement.v). *)
Set Warnings "-notation-overridden,-ambiguous-paths".
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import zify ssrZ.
From Coq Require Import ZArith Reals Lra.
From Flockproof Require Import chazelle_model chazelle_ergodicity chazelle_recurrent chazelle_agreement.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Import GRing.Theory Num.Theory Order.Theory.
Delimit Scope nat_scope with N.
Local Open Scope ring_scope.

(* the value of an integer and of a fraction *)
Definition int_value (z : int) : R := IZR (Z_of_int z).
Definition value (x : rat) : R := (int_value (numq x) / int_value (denq x))%R.

Lemma int_valueD a b : int_value (a + b) = (int_value a + int_value b)%R.
Proof. by rewrite /int_value -plus_IZR; congr IZR; lia. Qed.
Lemma int_valueM a b : int_value (a * b) = (int_value a * int_value b)%R.
Proof. by rewrite /int_value -mult_IZR; congr IZR; lia. Qed.
Lemma int_value_ge0 a : 0 <= a -> (0 <= int_value a)%R.
Proof. by move=> a0; apply: IZR_le; lia. Qed.
Lemma int_value_gt0 a : 0 < a -> (0 < int_value a)%R.
Proof. by move=> a0; apply: IZR_lt; lia. Qed.

Lemma value_frac (a b : int) : 0 < b -> value (a%:~R / b%:~R) = (int_value a / int_value b)%R.
Proof.
move=> b0; rewrite /value; set x := _ / _.
have d0 := denq_gt0 x; have D := int_value_gt0 d0; have B := int_value_gt0 b0.
have E : numq x * b = a * denq x.
  have dz : (denq x)%:~R != 0 :> rat by rewrite intr_eq0 gt_eqF.
  have bz : b%:~R != 0 :> rat by rewrite intr_eq0 gt_eqF.
  have : (numq x)%:~R = a%:~R / b%:~R * (denq x)%:~R :> rat by rewrite -/x -[X in X * _]divq_num_den divfK.
  move/(congr1 (fun y => y * b%:~R)); rewrite mulrAC divfK // -!intrM => /intr_inj; exact.
apply: (Rmult_eq_reg_r (int_value (denq x) * int_value b)%R); last by apply: Rgt_not_eq; apply: Rmult_lt_0_compat.
have -> : (int_value (numq x) / int_value (denq x) * (int_value (denq x) * int_value b) = int_value (numq x) * int_value b)%R.
  by field; lra.
have -> : (int_value a / int_value b * (int_value (denq x) * int_value b) = int_value a * int_value (denq x))%R by field; lra.
by rewrite -!int_valueM E.
Qed.
Lemma valueD x y : value (x + y) = (value x + value y)%R.
Proof.
have dx := denq_gt0 x; have dy := denq_gt0 y.
rewrite -{1}(divq_num_den x) -{1}(divq_num_den y) addf_div ?intr_eq0 ?gt_eqF // -!intrM -intrD value_frac ?mulr_gt0 //.
rewrite int_valueD !int_valueM /value; field; split; apply: Rgt_not_eq; exact: int_value_gt0.
Qed.
Lemma value_ge0 x : 0 <= x -> (0 <= value x)%R.
Proof.
move=> x0; apply: Rmult_le_pos; first by apply: int_value_ge0; rewrite numq_ge0.
by apply: Rlt_le; apply: Rinv_0_lt_compat; apply: int_value_gt0; exact: denq_gt0.
Qed.
Lemma value0 : value 0 = 0%R.
Proof. have := valueD 0 0; rewrite addr0; lra. Qed.
Lemma valueB x y : value (x - y) = (value x - value y)%R.
Proof. have := valueD (x - y) y; rewrite subrK; lra. Qed.
Lemma value_le x y : x <= y -> (value x <= value y)%R.
Proof. by move=> xy; have := @value_ge0 (y - x); rewrite subr_ge0 valueB => /(_ xy); lra. Qed.
Lemma valueN x : value (- x) = (- value x)%R.
Proof. have := valueB 0 x; rewrite sub0r value0 => ->; ring. Qed.
Lemma value_norm (x e : rat) : `|x| <= e -> (Rabs (value x) <= value e)%R.
Proof.
rewrite ler_norml => /andP[h1 h2]; have A := value_le h1; have B := value_le h2.
by rewrite (valueN e) in A; apply: Rabs_le.
Qed.
(* a rational number below a real one *)
Lemma value_small (e : R) : (0 < e)%R -> exists x : rat, 0 < x /\ (value x < e)%R.
Proof.
move=> e0; have [n [ne n0]] := archimed_cor1 e e0.
exists (1%:~R / (n%:Z)%:~R); have nz : 0 < n%:Z by lia.
split; first by rewrite divr_gt0 // ltr0z.
rewrite value_frac // /int_value (_ : Z_of_int 1 = 1%Z) // (_ : Z_of_int n = Z.of_nat n); last by lia.
rewrite -INR_IZR_INZ; lra.
Qed.

Section Limit.
Variables (n d : nat) (v : nat -> 'M[rat]_(n, d)).
Hypothesis n0 : (0 < n)%N.
Hypothesis close : forall eps : rat, 0 < eps ->
  exists T, forall t u i j l, (T < t)%N -> (T < u)%N -> `|v t i l - v u j l| <= eps.

Lemma coordinate_cauchy i l : Cauchy_crit (fun t => value (v t i l)).
Proof.
move=> e e0; have [x [x0 xe]] := value_small e0; have [T HT] := close x0.
exists T.+1 => t u Tt Tu; rewrite /R_dist -valueB; apply: Rle_lt_trans xe; apply: value_norm; apply: HT; lia.
Qed.
(* one real vector is the limit of all of them *)
Theorem real_limit : exists y : 'I_d -> R, forall i l, Un_cv (fun t => value (v t i l)) (y l).
Proof.
pose i0 := Ordinal n0; exists (fun l => proj1_sig (R_complete _ (coordinate_cauchy i0 l))) => i l.
case: (R_complete _ _) => y Hy /= e e0; have h0 : (0 < e / 2)%R by lra.
have [x [x0 xe]] := value_small h0; have [T HT] := close x0; have [T' HT'] := Hy _ h0.
exists (T.+1 + T')%N => t tT; have B := HT' t ltac:(lia).
have A : (Rabs (value (v t i l) - value (v t i0 l)) <= value x)%R by rewrite -valueB; apply: value_norm; apply: HT; lia.
rewrite /R_dist in B *; have -> : (value (v t i l) - y = (value (v t i l) - value (v t i0 l)) + (value (v t i0 l) - y))%R by lra.
apply: Rle_lt_trans (Rabs_triang _ _) _; lra.
Qed.
(* a bound of all differences after time k bounds the distances to the limit *)
Lemma limit_rate (y : 'I_d -> R) k l x : (forall i l, Un_cv (fun t => value (v t i l)) (y l)) ->
  (forall t u i j, (k < t)%N -> (k < u)%N -> `|v t i l - v u j l| <= x) ->
  forall t i, (k < t)%N -> (Rabs (value (v t i l) - y l) <= value x)%R.
Proof.
move=> Hy H t i kt; apply: Rnot_lt_le => gt.
have e0 : (0 < Rabs (value (v t i l) - y l) - value x)%R by lra.
have [T HT] := Hy i l _ e0; have B := HT (T + k.+1)%N ltac:(lia).
have A : (Rabs (value (v t i l) - value (v (T + k.+1)%N i l)) <= value x)%R.
  by rewrite -valueB; apply: value_norm; apply: H => //; lia.
have C := Rabs_triang (value (v t i l) - value (v (T + k.+1)%N i l)) (value (v (T + k.+1)%N i l) - y l).
rewrite /R_dist in B; move: (value (v t i l)) (value (v (T + k.+1)%N i l)) A B C gt => p q A B C gt.
have E : (p - q + (q - y l) = p - y l)%R by ring.
rewrite E in C; lra.
Qed.
End Limit.

(* flocks of model D with rational weights and velocities, connected again and again *)
Theorem recurrent_real_limit n d (G : nat -> rel 'I_n) (c : nat -> 'I_n -> rat) (v : nat -> 'M[rat]_(n, d)) (alpha : rat) :
  (0 < n)%N -> (forall t, network (G t)) -> (forall t, model_D (G t) (c t)) -> 0 < alpha ->
  (forall t i j, transition (G t) (c t) i j != 0 -> alpha <= transition (G t) (c t) i j) ->
  (forall s, exists k, forall i j, connect (union G s k) i j) ->
  (forall t, (0 < t)%N -> v t.+1 = transition (G t) (c t) *m v t) ->
  exists y : 'I_d -> R, forall i l, Un_cv (fun t => value (v t i l)) (y l).
Proof.
move=> n0 net MD a0 ale rec Hv; apply: real_limit => //; exact: (recurrent_cauchy net MD a0 ale rec Hv).
Qed.

(* directed networks with rational entries, every B consecutive times rooted: the limit with its rate *)
Theorem repeatedly_real_limit n d (P : nat -> 'M[rat]_n) (v : nat -> 'M[rat]_(n, d)) (gamma : rat) B :
  (forall t, stochastic (P t)) -> (forall t i, 0 < P t i i) -> 0 < gamma ->
  (forall t i j, P t i j != 0 -> gamma <= P t i j) ->
  (forall s, rooted (window P s B)) -> (forall t, (0 < t)%N -> v t.+1 = P t *m v t) ->
  exists y : 'I_d -> R, (forall i l, Un_cv (fun t => value (v t i l)) (y l)) /\
    forall k t i l, (k < t)%N ->
      (Rabs (value (v t i l) - y l) <= value ((1 - gamma ^+ (n.-1 * B)) ^+ (k %/ (n.-1 * B)) * extent v l))%R.
Proof.
move=> SP diag g0 gle W Hv; have [r _] := W 0%N.
have n0 : (0 < n)%N by exact: leq_ltn_trans (leq0n _) (ltn_ord r).
have [close cau] := repeatedly_cauchy SP diag g0 gle W Hv.
have [y Hy] := real_limit n0 cau; exists y; split=> // k t i l kt.
set x := _ * _; have H t' u i' j : (k < t')%N -> (k < u)%N -> `|v t' i' l - v u j l| <= x by exact: close.
exact: (limit_rate n0 Hy H).
Qed.
