(* Chazelle, Lemma 3.1 completed: the two estimates in its proof, for all nu, a, c.
     beyond.chazelle.switches, steps 1 and 3 (notes/chazelle_switches.md, The number of switches): k stabilisers bring
     velocities below the threshold, and the recursion for the number of switches ends below the bound.
   Natural numbers and any ordered field, no axioms. *)
Set Warnings "-notation-overridden,-ambiguous-paths".
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import ring zify.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.

Lemma one_step k nu m N : 3 <= k -> 2 <= m <= nu -> nu <= k ->
  k * (2 * m - 1) + 1 + m * (m - 1) %/ 2 + (2 * k * (m - 1) + 1) * N + 2 <= 3 * k * nu * (N + 2).
Proof.
move=> k3 /andP[m2 mn] nk.
have half : m * (m - 1) %/ 2 <= k * nu.
  apply: leq_trans (leq_div _ _) _; apply: leq_mul; [exact: leq_trans mn nk | lia].
have rest : (2 * k * (m - 1) + 1) * N <= 3 * k * nu * N by apply: leq_mul => //; nia.
rewrite mulnDr; move: half rest; set h := _ %/ 2; set x := _ * N; set y := _ * N => half rest; nia.
Qed.

Theorem switches_recursion nu a c (N : nat -> nat) : 2 <= nu -> N 1 = 0 ->
  let k := nu ^ (a * (nu - 1) + c + 6) in
  (forall m, 2 <= m <= nu ->
     N m <= k * (2 * m - 1) + 1 + m * (m - 1) %/ 2 + (2 * k * (m - 1) + 1) * N (m - 1)) ->
  N nu <= nu ^ (a * (nu - 1) ^ 2 + (c + 9) * (nu - 1) + 1).
Proof.
move=> nu2 N1 k H.
have e6 : 6 <= a * (nu - 1) + c + 6 by exact: leq_addl.
have nu0 : 0 < nu by exact: leq_trans nu2.
have nk : nu <= k by rewrite -{1}[nu]expn1 leq_pexp2l // (leq_trans _ e6).
have k3 : 3 <= k.
  apply: (@leq_trans (2 ^ 6)) => //; apply: (@leq_trans (nu ^ 6)); first by rewrite leq_exp2r.
  by rewrite leq_pexp2l.
have chain m : m < nu -> N m.+1 + 2 <= 2 * (3 * k * nu) ^ m.
  elim: m => [|m IH] mn; first by rewrite N1 expn0.
  have m2 : 2 <= m.+2 <= nu by rewrite mn.
  have := leq_trans (leq_add (H _ m2) (leqnn 2)) (one_step (N (m.+2 - 1)) k3 m2 nk).
  have -> : m.+2 - 1 = m.+1 by rewrite subn1.
  move=> le; apply: leq_trans le _.
  by rewrite expnS mulnCA leq_mul2l IH ?orbT // ltnW.
have {chain} := chain (nu - 1) _; rewrite subn1 prednK; last by lia.
move=> /(_ _) le; apply: (@leq_trans (2 * (3 * k * nu) ^ nu.-1)).
  by apply: leq_trans (le _); [exact: leq_addr | lia].
apply: (@leq_trans (nu * (nu ^ 2 * k * nu) ^ nu.-1)).
  apply: leq_mul => //; case: nu.-1 => [|m] //; rewrite leq_exp2r //.
  rewrite leq_mul2r; apply/orP; right; rewrite leq_mul2r; apply/orP; right.
  by apply: (@leq_trans (2 ^ 2)) => //; rewrite leq_exp2r.
have -> : nu * (nu ^ 2 * k * nu) ^ nu.-1 = nu ^ (1 + (2 + (a * (nu - 1) + c + 6) + 1) * nu.-1).
  by rewrite /k [RHS]expnD expn1 [in RHS]expnM; congr (_ * _ ^ _); rewrite [RHS]expnD expn1 [in RHS]expnD.
apply: leq_pexp2l => //; rewrite subn1; move: nu.-1 => m.
by rewrite -mulnn; nia.
Qed.

Import GRing.Theory Num.Theory Order.Theory.
Local Open Scope ring_scope.

(* (1 - 1/M)^M <= 1/2 *)
Lemma half_life (R : realFieldType) (M : nat) : (0 < M)%N -> (1 - M%:R^-1) ^+ M <= 2%:R^-1 :> R.
Proof.
move=> M0; set b : R := M%:R^-1; have b0 : 0 < b by rewrite invr_gt0 ltr0n.
have b1 : b <= 1 by rewrite invf_le1 ?ltr0n // ler1n.
have bernoulli m : 1 + m%:R * b <= (1 + b) ^+ m.
  elim: m => [|m IH]; first by rewrite mul0r addr0 expr0.
  rewrite exprS; apply: (@le_trans _ _ ((1 + b) * (1 + m%:R * b))); last first.
    by apply: ler_wpmul2l IH; rewrite addr_ge0 ?ler01 // ltW.
  have -> : (1 + b) * (1 + m%:R * b) = 1 + m.+1%:R * b + m%:R * (b * b) by rewrite mulrSr; ring.
  by rewrite ler_addl mulr_ge0 ?ler0n // mulr_ge0 // ltW.
have := bernoulli M; rewrite divff ?pnatr_eq0 -?lt0n // => two.
have c0 : 0 <= 1 - b by rewrite subr_ge0.
have small : (1 - b) ^+ M * (1 + b) ^+ M <= 1.
  rewrite -exprMn; apply: exprn_ile1; first by rewrite mulr_ge0 // addr_ge0 ?ler01 // ltW.
  have -> : (1 - b) * (1 + b) = 1 - b * b by ring.
  by rewrite ler_subl_addr ler_addl mulr_ge0 // ltW.
rewrite -[X in _ <= X]div1r ler_pdivl_mulr ?ltr0n //; apply: le_trans small.
by apply: ler_wpmul2l; rewrite ?exprn_ge0.
Qed.

(* step 1: 2 nu^c (1 - beta)^k < 1/T with beta = nu^(-a(nu-1)), k = nu^(a(nu-1)+c+6) where 2 nu^c T < 2^(nu^(c+6)) *)
Lemma below_time (R : realFieldType) nu a c T : (1 < nu)%N -> (0 < T)%N -> (2 * nu ^ c * T < 2 ^ (nu ^ (c + 6)))%N ->
  2%:R * nu%:R ^+ c * (1 - (nu%:R ^+ (a * (nu - 1)))^-1) ^+ (nu ^ (a * (nu - 1) + c + 6)) < T%:R^-1 :> R.
Proof.
move=> nu1 T0 small; have nu0 : (0 < nu)%N by exact: ltnW.
set M := (nu ^ (a * (nu - 1)))%N; have M0 : (0 < M)%N by rewrite expn_gt0 nu0.
have -> : (nu ^ (a * (nu - 1) + c + 6) = M * nu ^ (c + 6))%N by rewrite -addnA expnD.
have -> : nu%:R ^+ (a * (nu - 1)) = M%:R :> R by rewrite natrX.
rewrite exprM; have n0 m : 0 < nu%:R ^+ m :> R by rewrite exprn_gt0 // ltr0n.
have half : ((1 - M%:R^-1) ^+ M) ^+ (nu ^ (c + 6)) <= (2%:R ^+ (nu ^ (c + 6)))^-1 :> R.
  rewrite -exprVn; apply: ler_expn2r; rewrite ?nnegrE ?invr_ge0 ?ler0n ?half_life //.
  by rewrite exprn_ge0 // subr_ge0 invf_le1 ?ltr0n // ler1n.
apply: (@le_lt_trans _ _ (2%:R * nu%:R ^+ c * (2%:R ^+ (nu ^ (c + 6)))^-1)).
  by apply: ler_wpmul2l half; rewrite mulr_ge0 ?ler0n // ltW.
rewrite ltr_pdivr_mulr; last by rewrite exprn_gt0 // ltr0n.
by rewrite ltr_pdivl_mull ?ltr0n // -!natrX -!natrM ltr_nat mulnC.
Qed.
(* up to 2^100 times smaller than nu^(-nu^4), for nu > 3; nu^(-nu^4) itself for nu > 1 *)
Lemma double_power nu m : (nu ^ m <= 2 ^ (nu * m))%N.
Proof. by rewrite expnM; case: m => [|m] //; rewrite leq_exp2r // ltnW // ltn_expl. Qed.
Lemma threshold_room nu c h : (1 < nu)%N -> (h + nu ^ 5 + 1 + nu * c < c.+1 * (2 * nu ^ 5))%N -> (2 * nu ^ c * (2 ^ h * nu ^ (nu ^ 4)) < 2 ^ (nu ^ (c + 6)))%N.
Proof.
move=> nu1 room; apply: (@leq_ltn_trans (2 ^ (h + nu ^ 5 + 1 + nu * c))).
  have -> : (2 ^ (h + nu ^ 5 + 1 + nu * c) = 2 * 2 ^ (nu * c) * (2 ^ h * 2 ^ (nu ^ 5)))%N by rewrite -expnS -!expnD; congr (2 ^ _)%N; lia.
  by apply: leq_mul; apply: leq_mul => //; [exact: double_power | rewrite (expnS nu 4); exact: double_power].
rewrite ltn_exp2l //; have cl : (c < nu ^ c)%N by exact: ltn_expl.
by rewrite expnD (expnS nu 5); apply: leq_trans room _; rewrite !leq_mul.
Qed.
Theorem below_threshold (R : realFieldType) nu a c : (1 < nu)%N ->
  2%:R * nu%:R ^+ c * (1 - (nu%:R ^+ (a * (nu - 1)))^-1) ^+ (nu ^ (a * (nu - 1) + c + 6))
  < (nu%:R ^+ (nu ^ 4))^-1 :> R.
Proof.
move=> nu1; have -> : nu%:R ^+ (nu ^ 4) = (nu ^ (nu ^ 4))%:R :> R by rewrite natrX.
apply: below_time => //; first by rewrite expn_gt0 ltnW.
have -> : (nu ^ (nu ^ 4) = 2 ^ 0 * nu ^ (nu ^ 4))%N by rewrite expn0 mul1n.
apply: threshold_room => //.
have big : (nu <= nu ^ 5)%N by rewrite -{1}[nu]expn1 leq_pexp2l // ltnW.
have h : (nu * c <= c * nu ^ 5)%N by rewrite mulnC leq_mul2l big orbT.
move: (nu ^ 5)%N h (leq_trans nu1 big) => x h x2; have -> : (c.+1 * (2 * x) = 2 * x + 2 * (c * x))%N by rewrite mulSn [(c * (2 * x))%N]mulnCA.
move: (c * x)%N (nu * c)%N h => y z h; lia.
Qed.
Theorem below_smaller (R : realFieldType) nu a c h : (3 < nu)%N -> (h <= 100)%N ->
  2%:R * nu%:R ^+ c * (1 - (nu%:R ^+ (a * (nu - 1)))^-1) ^+ (nu ^ (a * (nu - 1) + c + 6))
  < (2 ^ h * nu ^ (nu ^ 4))%:R^-1 :> R.
Proof.
move=> nu3 h100; have nu1 : (1 < nu)%N by exact: leq_trans nu3.
apply: below_time => //; first by rewrite muln_gt0 !expn_gt0 (ltnW nu1).
apply: threshold_room => //; have big : (nu <= nu ^ 5)%N by rewrite -{1}[nu]expn1 leq_pexp2l // ltnW.
have large : (4 ^ 5 <= nu ^ 5)%N by rewrite leq_exp2r.
have h5 : (nu * c <= c * nu ^ 5)%N by rewrite mulnC leq_mul2l big orbT.
have x2 : (200 <= nu ^ 5)%N by apply: leq_trans large.
move: (nu ^ 5)%N h5 x2 => x h5 x2; clear -h100 h5 x2; have -> : (c.+1 * (2 * x) = 2 * x + 2 * (c * x))%N by rewrite mulSn [(c * (2 * x))%N]mulnCA.
move: (c * x)%N (nu * c)%N h5 => y z h5; lia.
Qed.
