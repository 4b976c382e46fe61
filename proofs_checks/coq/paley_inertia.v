(* Paley et al., critical points of U_1: the inertia of the Hessian, and that there are no others.
     beyond.paley.inertia (clauses 1, 2, 3, 5; of clause 4 the linearisation), C1-C6 of notes/paley_phases.md.
   U_1 = (N/2)|p|^2 is a polynomial in the cosines and sines c, s of the phases; a phase that moves by X moves its (c, s) to first order
   to (c - s X, s + c X), and `gradient` and `hessian` are made of coefficients of X.  The inertia is what it is by definition: the largest
   dimensions of row spaces on which the form is positive and negative definite, and the dimension of the kernel; Sylvester's law is not
   needed.  Three spaces that add up to everything prove it (`inertia_from`).  Hypotheses: c^2 + s^2 = 1, N >= 1.  Any ordered field,
   no axioms. *)
Set Warnings "-notation-overridden,-ambiguous-paths".
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import ring zify.
From Flockproof Require Import paley_circulant.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Import GRing.Theory Num.Theory Order.Theory.
Local Open Scope ring_scope.

(* ---- inertia ---- *)
Section Inertia.
Variables (R : realFieldType) (n : nat).
Implicit Types (H : 'M[R]_n) (v : 'rV[R]_n).
Definition form H v : R := (v *m H *m v^T) 0 0.
Definition positive_on H m (W : 'M[R]_(m, n)) := forall v, (v <= W)%MS -> v != 0 -> 0 < form H v.
Definition negative_on H m (W : 'M[R]_(m, n)) := forall v, (v <= W)%MS -> v != 0 -> form H v < 0.
(* d is the largest dimension of the row spaces with the property Q *)
Definition largest (Q : 'M[R]_n -> Prop) (d : nat) := (exists2 W, Q W & \rank W = d) /\ (forall W, Q W -> (\rank W <= d)%N).
Definition inertia H p q z := [/\ largest (@positive_on H n) p, largest (@negative_on H n) q & \rank (kermx H) = z].

Lemma formD H v u : u *m H = 0 -> H^T = H -> form H (v + u) = form H v.
Proof.
move=> uH HT; have Hu : H *m u^T = 0 by rewrite -[LHS]trmxK trmx_mul trmxK HT uH trmx0.
by rewrite /form mulmxDl uH addr0 linearD /= mulmxDr -[v *m H *m u^T]mulmxA Hu mulmx0 addr0.
Qed.
(* spaces that meet in 0 only *)
Lemma rank_apart m1 m2 (A : 'M[R]_(m1, n)) (B : 'M[R]_(m2, n)) :
  (forall v, (v <= A)%MS -> (v <= B)%MS -> v = 0) -> \rank (A + B)%MS = (\rank A + \rank B)%N.
Proof.
move=> AB; rewrite -(mxrank_sum_cap A B) -[LHS]addn0; congr (_ + _)%N; apply/esym/eqP; rewrite mxrank_eq0.
by apply/eqP/row_matrixP=> i; rewrite row0; apply: AB; apply: submx_trans (row_sub i _) _; rewrite ?capmxSl ?capmxSr.
Qed.
Lemma rank_bound H m1 m2 m3 (P : 'M[R]_(m1, n)) (N : 'M[R]_(m2, n)) (Z : 'M[R]_(m3, n)) :
  H^T = H -> positive_on H P -> negative_on H N -> Z *m H = 0 -> (\rank P + \rank N + \rank Z <= n)%N.
Proof.
move=> HT HP HN HZ; have ZH v : (v <= Z)%MS -> v *m H = 0 by case/submxP=> D ->; rewrite -mulmxA HZ mulmx0.
have NZ : \rank (N + Z)%MS = (\rank N + \rank Z)%N.
  apply: rank_apart => v vN /ZH vH; apply/eqP/negP=> /negP v0.
  by have := HN v vN v0; rewrite /form vH mul0mx mxE ltxx.
rewrite -addnA -NZ -rank_apart ?rank_leq_col // => v vP /sub_addsmxP[[D E] /= vE].
apply/eqP/negP=> /negP v0; have := HP v vP v0.
rewrite vE formD ?ZH ?submxMl //; have [->|a0] := eqVneq (D *m N) 0; first by rewrite /form !mul0mx mxE ltxx.
by rewrite ltNge ltW // HN ?submxMl.
Qed.
Theorem inertia_from H m1 m2 m3 (P : 'M[R]_(m1, n)) (N : 'M[R]_(m2, n)) (Z : 'M[R]_(m3, n)) p q z :
  H^T = H -> positive_on H P -> negative_on H N -> Z *m H = 0 ->
  (p <= \rank P)%N -> (q <= \rank N)%N -> (z <= \rank Z)%N -> (p + q + z)%N = n -> inertia H p q z.
Proof.
move=> HT HP HN HZ p_le q_le z_le pqz.
have B m (W : 'M[R]_(m, n)) : positive_on H W -> (\rank W <= p)%N.
  by move=> HW; have := rank_bound HT HW HN HZ; lia.
have C m (W : 'M[R]_(m, n)) : negative_on H W -> (\rank W <= q)%N.
  by move=> HW; have := rank_bound HT HP HW HZ; lia.
split; [split=> [|W]; last exact: B|split=> [|W]; last exact: C|].
- exists <<P>>%MS; first by move=> v; rewrite genmxE; apply: HP.
  by apply/eqP; rewrite genmxE eqn_leq p_le B.
- exists <<N>>%MS; first by move=> v; rewrite genmxE; apply: HN.
  by apply/eqP; rewrite genmxE eqn_leq q_le C.
have := rank_bound HT HP HN (mulmx_ker H).
have : (\rank Z <= \rank (kermx H))%N by apply: mxrankS; apply/sub_kermxP.
lia.
Qed.
Theorem inertia_scale H a p q z : inertia H p q z -> a != 0 -> if 0 < a then inertia (a *: H) p q z else inertia (a *: H) q p z.
Proof.
move=> [[[P HP rP] mP] [[N HN rN] mN] rK] a0; have F v : form (a *: H) v = a * form H v by rewrite /form -scalemxAr -scalemxAl mxE.
have K : \rank (kermx (a *: H)) = z by rewrite -rK !mxrank_ker (eqmx_scale H a0).
case: ltP => [a_gt0|a_le0]; last have a_lt0 : a < 0 by rewrite lt_neqAle a0.
  split=> //; split.
  - by exists P => // v vP v0; rewrite F pmulr_rgt0 // HP.
  - by move=> W HW; apply: mP => v vW v0; have := HW v vW v0; rewrite F pmulr_rgt0.
  - by exists N => // v vN v0; rewrite F pmulr_rlt0 // HN.
  - by move=> W HW; apply: mN => v vW v0; have := HW v vW v0; rewrite F pmulr_rlt0.
split=> //; split.
- by exists N => // v vN v0; rewrite F nmulr_rgt0 // HN.
- by move=> W HW; apply: mN => v vW v0; have := HW v vW v0; rewrite F nmulr_rgt0.
- by exists P => // v vP v0; rewrite F nmulr_rlt0 // HP.
- by move=> W HW; apply: mP => v vW v0; have := HW v vW v0; rewrite F nmulr_rlt0.
Qed.
End Inertia.

(* the rows e_k, k in B *)
Section Rows.
Variables (R : realFieldType) (n : nat).
Definition rows (B : {set 'I_n}) : 'M[R]_(#|B|, n) := \matrix_(i, j) (j == enum_val i)%:R.
Lemma rank_rows (B : {set 'I_n}) : (#|B| <= \rank (rows B))%N.
Proof.
apply: (@mulmx1_min_rank _ _ _ _ (rows B) 1%:M (rows B)^T); rewrite mul1mx; apply/matrixP=> i j; rewrite !mxE.
rewrite (bigD1 (enum_val i)) //= !mxE eqxx mul1r (inj_eq enum_val_inj) big1 ?addr0 // => k /negPf ki.
by rewrite !mxE ki mul0r.
Qed.
Lemma rows_support (B : {set 'I_n}) (v : 'rV[R]_n) k : (v <= rows B)%MS -> k \notin B -> v 0 k = 0.
Proof.
case/submxP=> D -> kB; rewrite mxE big1 // => i _; rewrite mxE; case: eqP => [kE|]; last by rewrite mulr0.
by rewrite kE enum_valP in kB.
Qed.
Lemma rank_ones : (0 < n)%N -> (1 <= \rank (const_mx 1%R : 'rV[R]_n))%N.
Proof.
move=> n0; rewrite lt0n mxrank_eq0; apply/eqP=> /matrixP/(_ 0 (Ordinal n0)).
by rewrite !mxE => /eqP; rewrite oner_eq0.
Qed.
Lemma rank_ker m (f : 'M[R]_(n, m)) : (n - m <= \rank (kermx f))%N.
Proof. by rewrite mxrank_ker leq_sub2l // rank_leq_col. Qed.
Lemma row_neq0 (v : 'rV[R]_n) : v != 0 -> exists k, v 0 k != 0.
Proof.
move=> v0; case: (pickP (fun k => v 0 k != 0)) => [k vk|E]; first by exists k.
by case/eqP: v0; apply/rowP=> k; rewrite mxE; apply/eqP/negbFE/E.
Qed.
Lemma sum_sqr_gt0 (I : finType) (P : pred I) (f : I -> R) k : P k -> f k != 0 -> 0 < \sum_(i | P i) f i ^+ 2.
Proof.
move=> Pk fk; rewrite (bigD1 k) //= ltr_paddr //; first by rewrite sumr_ge0 // => i _; rewrite sqr_ge0.
by rewrite lt_def sqrf_eq0 fk sqr_ge0.
Qed.
End Rows.

(* ---- U_1 = h ((sum c)^2 + (sum s)^2), h = 1/(2N), its gradient and its Hessian ---- *)
Definition turn_c (A : ringType) n (c s : 'I_n -> A) k j : {poly A} := lin (c j) (- s j * (j == k)%:R).
Definition turn_s (A : ringType) n (c s : 'I_n -> A) k j : {poly A} := lin (s j) (c j * (j == k)%:R).
Definition potential (A : comRingType) n (h : A) (c s : 'I_n -> A) : A := h * ((\sum_j c j) ^+ 2 + (\sum_j s j) ^+ 2).
Definition gradient (A : comRingType) n (h : A) (c s : 'I_n -> A) k : A := (potential h%:P (turn_c c s k) (turn_s c s k))`_1.
Definition hessian (R : realFieldType) n (c s : 'I_n -> R) : 'M[R]_n :=
  \matrix_(k, l) (gradient ((2%:R * n%:R)^-1)%:P (turn_c c s l) (turn_s c s l) k)`_1.
Section Turn.
Variables (A : comRingType) (n : nat) (c s : 'I_n -> A) (k : 'I_n).
Lemma turn_c0 : (\sum_j turn_c c s k j)`_0 = \sum_j c j.
Proof. by rewrite coef_sum; apply: eq_bigr => j _; rewrite lin0. Qed.
Lemma turn_s0 : (\sum_j turn_s c s k j)`_0 = \sum_j s j.
Proof. by rewrite coef_sum; apply: eq_bigr => j _; rewrite lin0. Qed.
Lemma turn_c1 : (\sum_j turn_c c s k j)`_1 = - s k.
Proof.
rewrite coef_sum (bigD1 k) //= lin1 eqxx mulr1 big1 ?addr0 // => j /negPf jk.
by rewrite lin1 jk mulr0.
Qed.
Lemma turn_s1 : (\sum_j turn_s c s k j)`_1 = c k.
Proof.
rewrite coef_sum (bigD1 k) //= lin1 eqxx mulr1 big1 ?addr0 // => j /negPf jk.
by rewrite lin1 jk mulr0.
Qed.
End Turn.
Lemma gradientE (A : comRingType) n (h : A) (c s : 'I_n -> A) k :
  gradient h c s k = h *+ 2 * (c k * (\sum_j s j) - s k * (\sum_j c j)).
Proof.
rewrite /gradient /potential !expr2 mul1 coefC0 coefC1 mul0r addr0 coefD !mul1 turn_c0 turn_c1 turn_s0 turn_s1.
by move: (\sum_j c j) (\sum_j s j) => C S; ring.
Qed.

Section Critical.
Variables (R : realFieldType) (n : nat) (c s : 'I_n -> R).
Hypothesis n0 : (0 < n)%N.
Hypothesis circle : forall k, c k ^+ 2 + s k ^+ 2 = 1.
Notation C := (\sum_j c j).
Notation S := (\sum_j s j).
Let nR : n%:R != 0 :> R. Proof. by rewrite pnatr_eq0 -lt0n. Qed.
Lemma hessianE k l : hessian c s k l = n%:R^-1 * (c k * c l + s k * s l - (k == l)%:R * (c k * C + s k * S)).
Proof.
rewrite mxE gradientE -polyCMn mul1 coefC0 coefC1 mul0r addr0 coefB !mul1 turn_c0 turn_c1 turn_s0 turn_s1 !lin0 !lin1.
move: (\sum_j c j) (\sum_j s j) => c' s'; have two : 2%:R != 0 :> R by rewrite pnatr_eq0.
by rewrite invfM mulrnAl -mulrnAr; have [->|kl] := eqVneq k l; rewrite ?mulr1n ?mulr0n; field; rewrite ?nR ?two.
Qed.
Lemma hessian_sym : (hessian c s)^T = hessian c s.
Proof.
apply/matrixP=> k l; rewrite mxE !hessianE (eq_sym l); have [->//|kl] := eqVneq k l.
by rewrite !mul0r; congr (_ * _); ring.
Qed.
Lemma hessian_mul (v : 'rV[R]_n) l :
  (v *m hessian c s) 0 l = n%:R^-1 * (c l * (\sum_k v 0 k * c k) + s l * (\sum_k v 0 k * s k) - v 0 l * (c l * C + s l * S)).
Proof.
rewrite mxE; under eq_bigr do rewrite hessianE mulrCA.
rewrite -mulr_sumr; congr (_ * _); move: C S => C' S'.
rewrite [X in _ - X](_ : _ = \sum_k v 0 k * ((k == l)%:R * (c k * C' + s k * S'))); last first.
  by rewrite [RHS](bigD1 l) //= eqxx mul1r big1 ?addr0 // => k /negPf->; rewrite mul0r mulr0.
rewrite !mulr_sumr -big_split -sumrB; apply: eq_bigr => k _ /=; move: (_%:R) => x; ring.
Qed.
Lemma formE (v : 'rV[R]_n) : form (hessian c s) v =
  n%:R^-1 * ((\sum_k v 0 k * c k) ^+ 2 + (\sum_k v 0 k * s k) ^+ 2 - \sum_k (c k * C + s k * S) * v 0 k ^+ 2).
Proof.
rewrite /form mxE; under eq_bigr do rewrite hessian_mul mxE.
set p := \sum_k v 0 k * c k; set q := \sum_k v 0 k * s k.
transitivity (n%:R^-1 * (p * (\sum_k v 0 k * c k) + q * (\sum_k v 0 k * s k) - \sum_k (c k * C + s k * S) * v 0 k ^+ 2)); last by rewrite !expr2.
by rewrite !mulr_sumr -big_split -sumrB mulr_sumr; apply: eq_bigr => k _ /=; ring.
Qed.
Let n1_gt0 : 0 < n%:R^-1 :> R. Proof. by rewrite invr_gt0 ltr0n. Qed.

(* ---- balanced arrangements ---- *)
Definition balanced := C = 0 /\ S = 0.
Definition on_a_line := forall k j, c k * s j - s k * c j = 0.
Lemma form_balanced (v : 'rV[R]_n) : balanced ->
  form (hessian c s) v = n%:R^-1 * ((\sum_k v 0 k * c k) ^+ 2 + (\sum_k v 0 k * s k) ^+ 2).
Proof. by case=> C0 S0; rewrite formE C0 S0 [X in _ - X]big1 ?subr0 // => k _; rewrite !mulr0 addr0 mul0r. Qed.
Theorem inertia_balanced : balanced -> ~ on_a_line -> inertia (hessian c s) 2 0 (n - 2).
Proof.
move=> bal nl; have [k [j kj]] : exists k, exists j, c k * s j - s k * c j != 0.
  case: (pickP (fun p : 'I_n * 'I_n => c p.1 * s p.2 - s p.1 * c p.2 != 0)) => [[k j] kj|E]; first by exists k, j.
  by case: nl => k j; apply/eqP/negbFE/(E (k, j)).
have nkj : k != j by apply: contraNneq kj => ->; rewrite mulrC subrr.
pose M : 'M[R]_(n, 2) := \matrix_(k, i) (if i == 0 then c k else s k).
have n2 : (2 <= n)%N by have := max_card (mem [set k; j]); rewrite cards2 nkj card_ord.
apply: (@inertia_from _ _ _ _ _ _ (rows R [set k; j]) (0 : 'M_n) (kermx M)) => //.
- exact: hessian_sym.
- move=> v vP v0; rewrite form_balanced // pmulr_rgt0 //.
  have E f : \sum_i v 0 i * f i = v 0 k * f k + v 0 j * f j.
    rewrite (bigD1 k) //= (bigD1 j) 1?eq_sym //= big1 ?addr0 // => i /andP[ik ij].
    by rewrite (rows_support vP) ?mul0r // !inE negb_or ik.
  rewrite !E lt_def addr_ge0 ?sqr_ge0 // andbT; apply/eqP=> /eqP.
  rewrite paddr_eq0 ?sqr_ge0 // !sqrf_eq0 => /andP[/eqP a /eqP b]; case/eqP: v0; apply/rowP=> i; rewrite mxE.
  have vk : v 0 k = 0.
    apply: (mulIf kj); rewrite mul0r.
    transitivity ((v 0 k * c k + v 0 j * c j) * s j - (v 0 k * s k + v 0 j * s j) * c j); first by ring.
    by rewrite a b !mul0r subrr.
  have vj : v 0 j = 0.
    apply: (mulIf kj); rewrite mul0r.
    transitivity ((v 0 k * s k + v 0 j * s j) * c k - (v 0 k * c k + v 0 j * c j) * s k); first by ring.
    by rewrite a b !mul0r subrr.
  have [->//|ik] := eqVneq i k; have [->//|ij] := eqVneq i j.
  by rewrite (rows_support vP) // !inE negb_or ik.
- by move=> v; rewrite submx0 => /eqP-> /eqP.
- apply/row_matrixP=> i; rewrite row_mul row0; apply/rowP=> l; rewrite hessian_mul mxE.
  have vM : row i (kermx M) *m M = 0 by apply/sub_kermxP; exact: row_sub.
  have a := congr1 (fun X : 'rV[R]_2 => X 0 0) vM; have b := congr1 (fun X : 'rV[R]_2 => X 0 1) vM.
  move: a b; rewrite /= !mxE; under eq_bigr do rewrite [M _ _]mxE /=; move=> a.
  under eq_bigr do rewrite [M _ _]mxE /=; move=> b.
  by case: bal => C0 S0; rewrite a b C0 S0 !(mulr0, addr0, subr0).
- by apply: leq_trans (rank_rows R [set k; j]); rewrite cards2 nkj.
- exact: rank_ker.
- by rewrite addn0 subnKC.
Qed.
Let o := Ordinal n0.
Let f k := c o * c k + s o * s k.
Lemma line_c k : on_a_line -> c k = f k * c o.
Proof.
move=> line; transitivity ((c o ^+ 2 + s o ^+ 2) * c k + s o * (c k * s o - s k * c o) * -1); last by rewrite /f; ring.
by rewrite line circle mulr0 mul0r addr0 mul1r.
Qed.
Lemma line_s k : on_a_line -> s k = f k * s o.
Proof.
move=> line; transitivity ((c o ^+ 2 + s o ^+ 2) * s k + c o * (c k * s o - s k * c o)); last by rewrite /f; ring.
by rewrite line circle mulr0 addr0 mul1r.
Qed.
Theorem inertia_balanced_line : balanced -> on_a_line -> inertia (hessian c s) 1 0 (n - 1).
Proof.
move=> bal line; have cE k := line_c k line; have sE k := line_s k line.
pose M : 'cV[R]_n := \col_k f k.
apply: (@inertia_from _ _ _ _ _ _ (rows R [set o]) (0 : 'M_n) (kermx M)) => //.
- exact: hessian_sym.
- move=> v vP v0; rewrite form_balanced // pmulr_rgt0 //.
  have E g : \sum_i v 0 i * g i = v 0 o * g o.
    rewrite (bigD1 o) //= big1 ?addr0 // => i io.
    by rewrite (rows_support vP) ?mul0r // !inE.
  rewrite !E !exprMn -mulrDr circle mulr1 lt_def sqr_ge0 andbT sqrf_eq0.
  apply: contraNneq v0 => vo; apply/eqP/rowP=> i; rewrite mxE.
  have [->//|io] := eqVneq i o; by rewrite (rows_support vP) // !inE.
- by move=> v; rewrite submx0 => /eqP-> /eqP.
- apply/row_matrixP=> i; rewrite row_mul row0; apply/rowP=> l; rewrite hessian_mul mxE.
  have vM : row i (kermx M) *m M = 0 by apply/sub_kermxP; exact: row_sub.
  have := congr1 (fun X : 'M[R]_1 => X 0 0) vM; rewrite /= !mxE; under eq_bigr do rewrite [M _ _]mxE; move=> a.
  have E (x : R) : \sum_k row i (kermx M) 0 k * (f k * x) = 0.
    by under eq_bigr do rewrite mulrA; rewrite -mulr_suml a mul0r.
  under eq_bigr do rewrite cE; under [X in _ + _ * X]eq_bigr do rewrite sE.
  by case: bal => C0 S0; rewrite !E C0 S0 !(mulr0, addr0, subr0).
- by apply: leq_trans (rank_rows R [set o]); rewrite cards1.
- exact: rank_ker.
- by rewrite addn0 subnKC.
Qed.

(* ---- two opposite clusters: the phases in B are opposite to e^(i psi) = (ce, se), all others equal to it ---- *)
Definition sg (B : {set 'I_n}) k : R := if k \in B then -1 else 1.
Definition two_clusters (B : {set 'I_n}) := (#|B| < n - #|B|)%N /\
  exists ce se : R, ce ^+ 2 + se ^+ 2 = 1 /\ forall k, c k = sg B k * ce /\ s k = sg B k * se.
Lemma sum_sg B : \sum_k sg B k = n%:R - #|B|%:R *+ 2.
Proof.
rewrite (eq_bigr (fun k => 1 - (if k \in B then 1 else 0) *+ 2)) => [|k _].
  by rewrite sumrB sumr_const card_ord sumrMnl -big_mkcond sumr_const.
by rewrite /sg; case: ifP => _; rewrite ?mul0rn ?subr0 // mulr2n opprD addrA subrr add0r.
Qed.
Theorem inertia_two_clusters B : two_clusters B -> inertia (hessian c s) #|B| (n - #|B| - 1) 1.
Proof.
case=> Bn [ce [se [e1 ze]]]; have cE k : c k = sg B k * ce by case: (ze k).
have sE k : s k = sg B k * se by case: (ze k).
pose D := \sum_k sg B k; have D0 : 0 < D.
  by rewrite /D sum_sg subr_gt0 -mulr_natl -natrM ltr_nat; lia.
have CE : C = D * ce by rewrite mulr_suml; apply: eq_bigr.
have SE : S = D * se by rewrite mulr_suml; apply: eq_bigr.
have F (v : 'rV[R]_n) : form (hessian c s) v = n%:R^-1 * ((\sum_k v 0 k * sg B k) ^+ 2 - D * \sum_k sg B k * v 0 k ^+ 2).
  rewrite formE CE SE; congr (_ * _).
  under eq_bigr do rewrite cE mulrA; under [X in _ + X ^+ 2 - _]eq_bigr do rewrite sE mulrA.
  rewrite -!mulr_suml !exprMn -mulrDr e1 mulr1; congr (_ - _); rewrite mulr_sumr; apply: eq_bigr => k _.
  rewrite cE sE; transitivity (sg B k * D * (ce ^+ 2 + se ^+ 2) * v 0 k ^+ 2); first by ring.
  by rewrite e1; ring.
pose one : 'cV[R]_n := const_mx 1.
apply: (@inertia_from _ _ _ _ _ _ (rows R B) (rows R (~: B) :&: kermx one)%MS (const_mx 1 : 'rV[R]_n)).
- exact: hessian_sym.
- move=> v vP v0; have [k vk] := row_neq0 v0.
  rewrite F pmulr_rgt0 // [X in _ - D * X](eq_bigr (fun k => - v 0 k ^+ 2)) => [|i _].
    rewrite sumrN mulrN opprK ltr_paddl ?sqr_ge0 // pmulr_rgt0 //; exact: (@sum_sqr_gt0 _ _ _ _ k).
  rewrite /sg; case: ifP => [_|/negbT iB]; first by rewrite mulN1r.
  by rewrite (rows_support vP iB) expr0n /= mulr0 oppr0.
- move=> v; rewrite sub_capmx => /andP[vP /sub_kermxP vK] v0; have [k vk] := row_neq0 v0.
  have := congr1 (fun X : 'M[R]_1 => X 0 0) vK; rewrite /= !mxE; under eq_bigr do rewrite mxE mulr1; move=> v1.
  have vB i : i \in B -> v 0 i = 0 by move=> iB; apply: (rows_support vP); rewrite inE iB.
  rewrite F pmulr_rlt0 // (eq_bigr (fun k => v 0 k)) => [|i _]; last first.
    by rewrite /sg; case: ifP => [/vB->|_]; rewrite ?mul0r ?mulr1.
  rewrite v1 expr0n /= sub0r oppr_lt0 pmulr_rgt0 // (eq_bigr (fun k => v 0 k ^+ 2)) => [|i _].
    exact: (@sum_sqr_gt0 _ _ _ _ k).
  by rewrite /sg; case: ifP => [/vB->|_]; rewrite ?expr0n /= ?mulr0 ?mul1r.
- apply/rowP=> l; rewrite hessian_mul [RHS]mxE !mxE.
  under eq_bigr do rewrite mxE mul1r; under [X in _ + _ * X]eq_bigr do rewrite mxE mul1r.
  by rewrite mul1r subrr mulr0.
- exact: rank_rows.
- have := mxrank_sum_cap (rows R (~: B)) (kermx one).
  have := rank_rows R (~: B); have := rank_ker one; have := rank_leq_col (rows R (~: B) + kermx one)%MS.
  by have := cardsC B; rewrite card_ord; lia.
- exact: rank_ones.
by lia.
Qed.

(* the linearisation - K_1 H of (6) with (9) there: as many positive directions as the unstable manifold has dimensions (C6) *)
Corollary linearisation_two_clusters B K1 : two_clusters B -> K1 != 0 ->
  if K1 < 0 then inertia (- K1 *: hessian c s) #|B| (n - #|B| - 1) 1 else inertia (- K1 *: hessian c s) (n - #|B| - 1) #|B| 1.
Proof. by move=> H K0; have := inertia_scale (inertia_two_clusters H) (_ : - K1 != 0); rewrite oppr_eq0 oppr_gt0; apply. Qed.

(* ---- no other critical points ---- *)
Definition critical := forall k, gradient (2%:R * n%:R)^-1 c s k = 0.
Lemma criticalE : critical <-> forall k, c k * S - s k * C = 0.
Proof.
have h0 : (2%:R * n%:R)^-1 *+ 2 != 0 :> R by rewrite mulrn_eq0 /= invr_eq0 mulf_neq0 // pnatr_eq0.
split=> H k; have := H k; rewrite gradientE; last by move=> ->; rewrite mulr0.
by move/eqP; rewrite mulf_eq0 (negPf h0) => /eqP.
Qed.
Theorem critical_points : critical <-> balanced \/ exists B, two_clusters B.
Proof.
rewrite criticalE; split=> [H|[[C0 S0] k|[B [_ [ce [se [_ ze]]]]] k]]; last first.
- have cE i : c i = sg B i * ce by case: (ze i).
  have sE i : s i = sg B i * se by case: (ze i).
  under eq_bigr do rewrite sE; under [X in _ - _ * X]eq_bigr do rewrite cE.
  by rewrite -!mulr_suml cE sE; ring.
- by rewrite C0 S0 !mulr0 subrr.
case: (boolP ((C == 0) && (S == 0))) => [/andP[/eqP C0 /eqP S0]|N0]; [by left|right].
have line : on_a_line.
  move=> k j; move: N0; rewrite negb_and => /orP[N0|N0]; apply: (mulIf N0); rewrite mul0r.
    by transitivity (c j * (c k * S - s k * C) - c k * (c j * S - s j * C)); [ring | rewrite !H !mulr0 subrr].
  by transitivity (s j * (c k * S - s k * C) - s k * (c j * S - s j * C)); [ring | rewrite !H !mulr0 subrr].
have cE k := line_c k line; have sE k := line_s k line.
have f1 k : (f k == 1) || (f k == -1).
  rewrite -eqf_sqr expr1n; apply/eqP; rewrite -(circle k) (cE k) (sE k) !exprMn -mulrDr circle mulr1 //.
pose B := [set k | f k == -1].
have fE k : f k = sg B k by rewrite /sg inE; case: eqP => // N; case/orP: (f1 k) => /eqP.
have CE : C = (\sum_k sg B k) * c o by rewrite mulr_suml; apply: eq_bigr => k _; rewrite -fE.
have SE : S = (\sum_k sg B k) * s o by rewrite mulr_suml; apply: eq_bigr => k _; rewrite -fE.
have Bn : (#|B| + #|B|)%N != n.
  apply: contraNneq N0 => E; have Z : \sum_k sg B k = 0 by rewrite sum_sg mulr2n -natrD E subrr.
  by rewrite CE SE Z !mul0r eqxx.
have [lt|ge] := ltnP #|B| (n - #|B|).
  by exists B; split=> //; exists (c o), (s o); split=> // k; rewrite -fE -cE -sE.
exists (~: B); split; first by have := cardsC B; rewrite card_ord; lia.
exists (- c o), (- s o); split=> [|k]; first by rewrite !sqrrN.
have -> : sg (~: B) k = - f k by rewrite fE /sg inE; case: (k \in B); rewrite ?opprK.
by rewrite !mulrNN -cE -sE.
Qed.
End Critical.
