(* Chazelle, section 3: mixing on the connected parts of a fixed network with the constants of the notes.  The steps of a simple
   path together (Cauchy and Schwarz), not the steepest one, bound the differences; a symmetric step contracts by the larger of its
   two extreme quotients (polarisation; no eigenvectors are needed).
     beyond.chazelle.fiedler.rate; beyond.chazelle.angle rests on it (chazelle_origins.v).  No axioms. *)
Set Warnings "-notation-overridden,-ambiguous-paths".
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import ring zify.
From Flockproof Require Import chazelle_model chazelle_ergodicity chazelle_fixed chazelle_network.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Import GRing.Theory Num.Theory Order.Theory.
Local Open Scope ring_scope.

(* ---- a simple path ---- *)
Section Paths.
Variables (R : realFieldType) (n : nat) (G : rel 'I_n).
Hypothesis net : network G.
Implicit Types (f : 'I_n -> R) (A : seq 'I_n).

(* the sum over the ordered pairs of neighbours in A *)
Definition tension A f : R := \sum_i \sum_j ([&& i \in A, j \in A & G i j])%:R * (f i - f j) ^+ 2.
Lemma tension_ge0 A f : 0 <= tension A f.
Proof. by apply: sumr_ge0 => i _; apply: sumr_ge0 => j _; rewrite mulr_ge0 ?ler0n ?sqr_ge0. Qed.
Lemma pair_sum f x y : \sum_i \sum_j ((i == x) && (j == y))%:R * (f i - f j) ^+ 2 = (f x - f y) ^+ 2.
Proof.
rewrite (bigD1 x) //= [X in _ + X]big1 ?addr0; last first.
  by move=> i /negbTE ix; rewrite big1 // => j _; rewrite ix mul0r.
rewrite (bigD1 y) //= !eqxx mul1r big1 ?addr0 // => j /negbTE jy; by rewrite jy mul0r.
Qed.
Lemma tension_cons x y A f : x \notin A -> y \in A -> G x y -> tension A f + (f x - f y) ^+ 2 *+ 2 <= tension (x :: A) f.
Proof.
have [sym irr] := net; move=> xA yA Gxy.
rewrite mulr2n -{2}(opprB (f y) (f x)) sqrrN -(pair_sum f x y) -(pair_sum f y x) /tension -!big_split /=.
apply: ler_sum => i _; rewrite -!big_split /=; apply: ler_sum => j _; rewrite -!mulrDl.
apply: ler_wpmul2r; first exact: sqr_ge0.
rewrite -!natrD ler_nat !in_cons.
have xy : x == y = false by apply: contraNF xA => /eqP->.
case: (eqVneq i x) => [->|ix]; case: (eqVneq j x) => [->|jx];
  rewrite ?eqxx ?(negbTE xA) ?xy /= ?andbF ?andbT ?addn0 ?add0n ?orbT //.
- by case: (eqVneq j y) => [->|//]; rewrite yA Gxy.
- by case: (eqVneq i y) => [->|//]; rewrite yA sym Gxy.
Qed.
Lemma path_tension f x p : path G x p -> uniq (x :: p) -> (f x - f (last x p)) ^+ 2 *+ 2 <= (size p)%:R * tension (x :: p) f.
Proof.
elim: p x => [|y q IH] x /=; first by rewrite subrr expr0n mul0rn mul0r.
case/andP=> Gxy pth /andP[xn uq]; have := IH y pth uq; set z := f (last y q).
have := @tension_cons x y (y :: q) f xn (mem_head _ _) Gxy.
set S := tension (y :: q) f; set S' := tension (x :: y :: q) f; have S0 : 0 <= S by exact: tension_ge0.
case: (posnP (size q)) => [->|k0] St Sz.
  rewrite mul0r in Sz; have : (f y - z) ^+ 2 <= 0 by rewrite -(@ler_pmuln2r _ 2) // mul0rn.
  move=> h; have /eqP : (f y - z) ^+ 2 == 0 by rewrite eq_le h sqr_ge0.
  move/eqP; rewrite sqrf_eq0 subr_eq0 => /eqP <-; rewrite mul1r; apply: le_trans St; by rewrite ler_addr.
set k : R := (size q)%:R in Sz *; have kp : 0 < k by rewrite ltr0n.
have -> : (size q).+1%:R = k + 1 :> R by rewrite -addn1 natrD.
have C : k * (f x - z) ^+ 2 <= (k + 1) * (k * (f x - f y) ^+ 2 + (f y - z) ^+ 2).
  rewrite -subr_ge0; have -> : (k + 1) * (k * (f x - f y) ^+ 2 + (f y - z) ^+ 2) - k * (f x - z) ^+ 2 = (k * (f x - f y) - (f y - z)) ^+ 2 by ring.
  exact: sqr_ge0.
rewrite -(ler_pmul2l kp).
have -> : k * ((f x - z) ^+ 2 *+ 2) = k * (f x - z) ^+ 2 *+ 2 by rewrite mulrnAr.
apply: (@le_trans _ _ ((k + 1) * (k * (f x - f y) ^+ 2 + (f y - z) ^+ 2) *+ 2)); first by rewrite ler_muln2r.
have -> : (k + 1) * (k * (f x - f y) ^+ 2 + (f y - z) ^+ 2) *+ 2 = (k + 1) * (k * ((f x - f y) ^+ 2 *+ 2) + (f y - z) ^+ 2 *+ 2) by ring.
have -> : k * ((k + 1) * S') = (k + 1) * (k * S') by ring.
apply: ler_wpmul2l; first by rewrite addr_ge0 ?ler01 ?ltW.
apply: (@le_trans _ _ (k * ((f x - f y) ^+ 2 *+ 2) + k * S)); first by rewrite ler_add2l.
by rewrite -mulrDr; apply: ler_wpmul2l; [exact: ltW | rewrite addrC].
Qed.
End Paths.

(* ---- one connected part K ---- *)
Section Part.
Variables (R : realFieldType) (n : nat) (G : rel 'I_n) (c : 'I_n -> R) (K : pred 'I_n).
Hypothesis net : network G.
Hypothesis closed : forall i j, G i j -> K i = K j.
Hypothesis connK : forall i j, K i -> K j -> connect G i j.
Hypothesis cK : forall i, K i -> 0 < c i.
Notation P := (transition G c).
Implicit Types f g : 'I_n -> R.

Definition weigh (i : 'I_n) : R := if K i then (c i)^-1 else 0.
Definition total : R := \sum_i weigh i.
Definition form f g : R := \sum_i weigh i * (f i * g i).
Definition drive f : 'I_n -> R := fun i => \sum_j P i j * f j.
Definition pull f : R := \sum_i \sum_j ((K i) && (G i j))%:R * (f i - f j) ^+ 2.

Lemma weigh_ge0 i : 0 <= weigh i.
Proof. by rewrite /weigh; case: ifP => // Ki; rewrite invr_ge0 ltW ?cK. Qed.
Lemma form_ge0 f : 0 <= form f f.
Proof. by apply: sumr_ge0 => i _; rewrite mulr_ge0 ?weigh_ge0 // -expr2 sqr_ge0. Qed.
Lemma drive_drop f i : f i - drive f i = c i * \sum_j (G i j)%:R * (f i - f j).
Proof.
have [sym irr] := net; rewrite /drive.
have E j : P i j * f j = (i == j)%:R * f i - c i * ((i == j)%:R * (degree G i)%:R * f i - (G i j)%:R * f j).
  rewrite transitionE //; have [->|ij] := eqVneq i j; first by rewrite irr /= mulr0n mulr1n; ring.
  by case: (G i j); rewrite /= ?mulr0n ?mulr1n; ring.
rewrite (eq_bigr _ (fun j _ => E j)) sumrB -mulr_suml -mulr_sumr sumrB.
have D : \sum_j (i == j)%:R = 1 :> R by rewrite (bigD1 i) //= eqxx big1 ?addr0 // => j ji; rewrite eq_sym (negbTE ji).
have -> : \sum_j (i == j)%:R * (degree G i)%:R * f i = (degree G i)%:R * f i.
  by rewrite (eq_bigr (fun j => (i == j)%:R * ((degree G i)%:R * f i))) ?(fun h => h) -?mulr_suml ?D ?mul1r // => j _; rewrite mulrA.
rewrite D mul1r subKr; congr (_ * _).
rewrite [RHS](eq_bigr (fun j => (G i j)%:R * f i - (G i j)%:R * f j)) => [|j _]; last by rewrite mulrBr.
by rewrite sumrB -mulr_suml -degree_sum.
Qed.
Lemma weigh_c i x : weigh i * (c i * x) = (K i)%:R * x.
Proof. by rewrite /weigh; case: ifP => Ki; rewrite ?mul0r // mulKf ?mul1r // gt_eqF ?cK. Qed.
(* the Dirichlet form of f and g *)
Lemma drop_form f g : (form g f - form g (drive f)) *+ 2 = \sum_i \sum_j ((K i) && (G i j))%:R * ((g i - g j) * (f i - f j)).
Proof.
have [sym irr] := net.
have -> : form g f - form g (drive f) = \sum_i \sum_j ((K i) && (G i j))%:R * (g i * (f i - f j)).
  rewrite /form -sumrB; apply: eq_bigr => i _.
  have -> : weigh i * (g i * f i) - weigh i * (g i * drive f i) = g i * (weigh i * (f i - drive f i)) by ring.
  rewrite drive_drop weigh_c mulrCA !mulr_sumr; apply: eq_bigr => j _; case: (K i); case: (G i j); rewrite /= ?mulr0n ?mulr1n; ring.
rewrite mulr2n {2}exchange_big /= -big_split /=; apply: eq_bigr => i _; rewrite -big_split /=; apply: eq_bigr => j _.
have -> : (K j && G j i) = (K i && G i j) by rewrite sym; case Gij: (G i j); rewrite ?andbF // (closed Gij).
by ring.
Qed.
Lemma pull_drop f : (form f f - form f (drive f)) *+ 2 = pull f.
Proof. by rewrite drop_form; apply: eq_bigr => i _; apply: eq_bigr => j _; rewrite -expr2. Qed.
Lemma form_sym f g : form f g = form g f.
Proof. by apply: eq_bigr => i _; rewrite [f i * _]mulrC. Qed.
Lemma self_adjoint f g : form g (drive f) = form f (drive g).
Proof.
have A := drop_form f g; have B := drop_form g f.
have E : \sum_i \sum_j ((K i) && (G i j))%:R * ((g i - g j) * (f i - f j)) = \sum_i \sum_j ((K i) && (G i j))%:R * ((f i - f j) * (g i - g j)).
  by apply: eq_bigr => i _; apply: eq_bigr => j _; rewrite [(g i - g j) * _]mulrC.
rewrite E -B form_sym in A; move/eqP: A; rewrite -subr_eq0 -mulrnBl mulrn_eq0 /= subr_eq0 => /eqP A.
by apply/oppr_inj/(addrI (form f g)).
Qed.
Definition centred f := \sum_i weigh i * f i = 0.
Lemma drive_mean f : \sum_i weigh i * drive f i = \sum_i weigh i * f i.
Proof.
have one : forall i, drive (fun=> 1) i = 1.
  move=> i; rewrite /drive (eq_bigr (fun j => P i j)) => [|j _]; rewrite ?mulr1 //; exact: transition_row_sum.
have := self_adjoint f (fun=> 1); rewrite /form (eq_bigr (fun i => weigh i * drive f i)) => [|i _]; last by rewrite mul1r.
by rewrite [X in _ = X](eq_bigr (fun i => weigh i * f i)) => [|i _]; last by rewrite one mulr1.
Qed.
Lemma drive_centred f : centred f -> centred (drive f).
Proof. by rewrite /centred drive_mean. Qed.
Lemma drop_centred f : centred (fun i => f i - drive f i).
Proof.
rewrite /centred (eq_bigr (fun i => weigh i * f i - weigh i * drive f i)) => [|i _]; last by rewrite mulrBr.
by rewrite sumrB drive_mean subrr.
Qed.

(* differences inside K *)
Lemma spread f i j : K i -> K j -> (f i - f j) ^+ 2 *+ 2 <= n.-1%:R * pull f.
Proof.
move=> Ki Kj; have /connectP[p pth ->] := connK Ki Kj; case/shortenP: pth => q qth uq _.
apply: le_trans (path_tension net f qth uq) _.
have inK : forall p x, K x -> path G x p -> forall y, y \in x :: p -> K y.
  elim=> [|b s IH] x Kx /=; first by move=> _ y; rewrite inE => /eqP->.
  case/andP=> Gxb ps y; rewrite inE => /orP[/eqP->//|]; apply: IH => //; by rewrite -(closed Gxb).
apply: ler_pmul; rewrite ?ler0n ?tension_ge0 //.
  rewrite ler_nat; have := max_card (mem (i :: q)); rewrite (card_uniqP uq) card_ord /=.
  by move=> h; rewrite -ltnS (leq_trans h) // leqSpred.
apply: ler_sum => a _; apply: ler_sum => b _; apply: ler_wpmul2r; first exact: sqr_ge0.
rewrite ler_nat; case Ha: (a \in i :: q) => //=; rewrite (inK q i Ki qth a Ha) /=; by case: (b \in _); case: (G a b).
Qed.
(* the square norm of a centred function (Popoviciu) *)
Lemma popoviciu f (i0 : 'I_n) : K i0 -> centred f -> exists i j, [/\ K i, K j & form f f *+ 4 <= total * (f i - f j) ^+ 2].
Proof.
move=> Ki0 Z; case: (@arg_maxP _ _ _ i0 K f Ki0) => i Ki Mi; case: (@arg_minP _ _ _ i0 K f Ki0) => j Kj Mj.
exists i, j; split=> //.
have A : 0 <= \sum_k weigh k * ((f i - f k) * (f k - f j)).
  apply: sumr_ge0 => k _; rewrite /weigh; case: ifP => Kk; last by rewrite mul0r.
  by rewrite mulr_ge0 ?invr_ge0 ?(ltW (cK Kk)) // mulr_ge0 ?subr_ge0; [ | exact: Mi | exact: Mj].
have B : \sum_k weigh k * ((f i - f k) * (f k - f j)) = - (total * (f i * f j)) - form f f.
  rewrite (eq_bigr (fun k => (f i + f j) * (weigh k * f k) - weigh k * (f i * f j) - weigh k * (f k * f k))) => [|k _]; last by ring.
  by rewrite !sumrB -mulr_sumr Z mulr0 sub0r -mulr_suml.
rewrite B subr_ge0 in A; apply: (@le_trans _ _ (- (total * (f i * f j)) *+ 4)); first by rewrite ler_muln2r.
have T0 : 0 <= total by apply: sumr_ge0 => k _; exact: weigh_ge0.
rewrite -mulrN -mulrnAr; apply: ler_wpmul2l => //.
rewrite -subr_ge0; have -> : (f i - f j) ^+ 2 - - (f i * f j) *+ 4 = (f i + f j) ^+ 2 by ring.
exact: sqr_ge0.
Qed.
Lemma gap f : centred f -> form f f *+ 4 <= total * n.-1%:R * (form f f - form f (drive f)).
Proof.
move=> Z; have T0 : 0 <= total by apply: sumr_ge0 => k _; exact: weigh_ge0.
have D0 : 0 <= pull f by apply: sumr_ge0 => i _; apply: sumr_ge0 => j _; rewrite mulr_ge0 ?ler0n ?sqr_ge0.
case: (pickP K) => [i0 Ki0|no]; last first.
  have -> : form f f = 0 by rewrite /form big1 // => i _; rewrite /weigh no mul0r.
  rewrite mul0rn; have -> : form f (drive f) = 0 by rewrite /form big1 // => i _; rewrite /weigh no mul0r.
  by rewrite subrr mulr0.
have [i [j [Ki Kj h]]] := popoviciu Ki0 Z; rewrite -(@ler_pmuln2r _ 2) //.
have -> : total * n.-1%:R * (form f f - form f (drive f)) *+ 2 = total * (n.-1%:R * pull f).
  by rewrite -pull_drop; set d := form f f - _; ring.
apply: le_trans (ler_wpmul2l T0 (spread f Ki Kj)); by rewrite mulrnAr ler_muln2r.
Qed.

(* the two extreme quotients *)
Variable mu : R.
Hypothesis mu0 : 0 < mu.
Hypothesis mu_gap : total * n.-1%:R * (1 - mu) <= 4%:R.
Hypothesis mu_diag : forall i, K i -> 1 - mu <= (1 - c i * (degree G i)%:R) *+ 2.
Lemma upper f : centred f -> form f (drive f) <= mu * form f f.
Proof.
move=> Z; have h := gap Z; have F0 := form_ge0 f; have T0 : 0 <= total by apply: sumr_ge0 => k _; exact: weigh_ge0.
case: (ltrP 0 (total * n.-1%:R)) => [t0|]; last first.
  move=> t0; have tz : total * n.-1%:R = 0 by apply/le_anti; rewrite t0 mulr_ge0 ?ler0n.
  rewrite tz mul0r in h; have fz : form f f = 0 by apply/le_anti; rewrite F0 andbT -(@ler_pmuln2r _ 4) // mul0rn.
  have w0 i : weigh i * (f i * f i) = 0.
    by move/eqP: fz; rewrite psumr_eq0 => [/allP/(_ i (mem_index_enum _))/eqP//|k _]; rewrite mulr_ge0 ?weigh_ge0 // -expr2 sqr_ge0.
  rewrite fz mulr0 /form big1 // => i _; move/eqP: (w0 i); rewrite mulf_eq0 mulf_eq0 orbb => /orP[/eqP->|/eqP->]; by rewrite ?mul0r ?mulr0.
have : (1 - mu) * form f f <= form f f - form f (drive f).
  rewrite -(ler_pmul2l t0) mulrA; apply: le_trans h; rewrite -[X in _ <= X]mulr_natl; by apply: ler_wpmul2r.
by rewrite mulrBl mul1r ler_add2l ler_opp2.
Qed.
Lemma lower f : - form f (drive f) <= mu * form f f.
Proof.
have [sym irr] := net.
have B : pull f <= \sum_i ((K i)%:R * (degree G i)%:R * f i ^+ 2) *+ 4.
  apply: (@le_trans _ _ (\sum_i \sum_j (((K i) && (G i j))%:R * (f i ^+ 2 + f j ^+ 2)) *+ 2)).
    apply: ler_sum => i _; apply: ler_sum => j _; rewrite -mulrnAr; apply: ler_wpmul2l; first exact: ler0n.
    rewrite -subr_ge0; have -> : (f i ^+ 2 + f j ^+ 2) *+ 2 - (f i - f j) ^+ 2 = (f i + f j) ^+ 2 by ring.
    exact: sqr_ge0.
  have E : \sum_i \sum_j ((K i) && (G i j))%:R * f j ^+ 2 = \sum_i \sum_j ((K i) && (G i j))%:R * f i ^+ 2.
    rewrite exchange_big /=; apply: eq_bigr => i _; apply: eq_bigr => j _; congr (_%:R * _).
    by rewrite sym; case Gij: (G i j); rewrite ?andbF // (closed Gij).
  rewrite (eq_bigr (fun i => (\sum_j ((K i) && (G i j))%:R * f i ^+ 2) *+ 2 + (\sum_j ((K i) && (G i j))%:R * f j ^+ 2) *+ 2)); last first.
    by move=> i _; rewrite -!sumrMnl -big_split /=; apply: eq_bigr => j _; ring.
  rewrite big_split /= !sumrMnl E -mulrnDr -[(2 + 2)%N]/4%N ler_muln2r /=; apply: ler_sum => i _.
  rewrite -mulr_suml; apply: ler_wpmul2r; first exact: sqr_ge0.
  rewrite degree_sum mulr_sumr; apply: ler_sum => j _; by case: (K i); case: (G i j); rewrite /= ?mulr1 ?mulr0 ?mul0r ?mul1r.
have D := pull_drop f; rewrite -(@ler_pmuln2r _ 2) //.
have -> : - form f (drive f) *+ 2 = pull f - form f f *+ 2 by rewrite -D mulrnBl addrAC subrr sub0r mulNrn.
rewrite ler_subl_addr; apply: le_trans B _; rewrite -mulrnDl /form mulr_sumr -big_split /= -sumrMnl; apply: ler_sum => i _.
have -> : (mu * (weigh i * (f i * f i)) + weigh i * (f i * f i)) *+ 2 = (mu + 1) * weigh i *+ 2 * f i ^+ 2 by ring.
rewrite -mulrnAl; apply: ler_wpmul2r; first exact: sqr_ge0.
rewrite /weigh; case Ki: (K i); last by rewrite mulr0 mul0rn mul0r mul0rn.
have := mu_diag Ki; rewrite mul1r -[4%N]/(2 + 2)%N mulrnDr => h.
have ci := cK Ki; rewrite -(ler_pmul2l ci).
have -> : c i * ((mu + 1) * (c i)^-1 *+ 2) = (mu + 1) *+ 2 by rewrite mulrnAr mulrCA mulfV ?mulr1 // gt_eqF.
have -> : c i * ((degree G i)%:R *+ 2 + (degree G i)%:R *+ 2) = (c i * (degree G i)%:R) *+ 2 *+ 2 by ring.
rewrite ler_muln2r /=; move: h; set y := c i * _ => h.
have : y *+ 2 <= 1 + mu by rewrite -subr_ge0 (_ : 1 + mu - y *+ 2 = (1 - y) *+ 2 - (1 - mu)) ?subr_ge0 //; ring.
by rewrite addrC.
Qed.
Lemma shrink f : centred f -> form (drive f) (drive f) <= mu ^+ 2 * form f f.
Proof.
move=> Z; pose u i := mu * f i + drive f i; pose v i := mu * f i - drive f i.
have Zd := drive_centred Z.
have Zu : centred u.
  by rewrite /centred (eq_bigr (fun i => mu * (weigh i * f i) + weigh i * drive f i)) => [|i _]; [rewrite big_split /= -mulr_sumr Z Zd mulr0 addr0 | rewrite /u; ring].
have du i : drive u i = mu * drive f i + drive (drive f) i.
  rewrite {1}/drive (eq_bigr (fun j => mu * (P i j * f j) + P i j * drive f j)) => [|j _]; last by rewrite /u; ring.
  by rewrite big_split /= -mulr_sumr.
have dv i : drive v i = mu * drive f i - drive (drive f) i.
  rewrite {1}/drive (eq_bigr (fun j => mu * (P i j * f j) - P i j * drive f j)) => [|j _]; last by rewrite /v; ring.
  by rewrite sumrB -mulr_sumr.
have Q : form u (drive u) - form v (drive v) = mu * (form f (drive (drive f)) + form (drive f) (drive f)) *+ 2.
  rewrite /form -sumrB -big_split /= mulr_sumr -sumrMnl; apply: eq_bigr => i _; rewrite du dv /u /v; ring.
have S : form u u + form v v = (mu ^+ 2 * form f f + form (drive f) (drive f)) *+ 2.
  rewrite /form -big_split /= mulr_sumr -big_split /= -sumrMnl; apply: eq_bigr => i _; rewrite /u /v; ring.
have A : form f (drive (drive f)) = form (drive f) (drive f) by rewrite self_adjoint.
have := ler_add (upper Zu) (lower v); rewrite Q A -mulrDr S => h.
move: h; set q := form (drive f) (drive f); set p := form f f => h.
have h2 : (q + q) *+ 2 <= (mu ^+ 2 * p + q) *+ 2 by rewrite -(ler_pmul2l mu0) mulrnAr.
by move: h2; rewrite ler_muln2r /= ler_add2r.
Qed.
End Part.

(* ---- powers ---- *)
Section Powers.
Variables (R : realFieldType) (n : nat) (G : rel 'I_n) (c : 'I_n -> R) (K : pred 'I_n).
Hypothesis net : network G.
Hypothesis closed : forall i j, G i j -> K i = K j.
Hypothesis connK : forall i j, K i -> K j -> connect G i j.
Hypothesis cK : forall i, K i -> 0 < c i.
Notation P := (transition G c).
Variable mu : R.
Hypothesis mu0 : 0 < mu.
Hypothesis mu_gap : total c K * n.-1%:R * (1 - mu) <= 4%:R.
Hypothesis mu_diag : forall i, K i -> 1 - mu <= (1 - c i * (degree G i)%:R) *+ 2.
Implicit Types f : 'I_n -> R.

Definition after s f : 'I_n -> R := fun i => \sum_j mpow P s i j * f j.
Lemma after0 f i : after 0 f i = f i.
Proof. by rewrite /after (bigD1 i) //= mxE eqxx mul1r big1 ?addr0 // => j ji; rewrite mxE eq_sym (negbTE ji) mul0r. Qed.
Lemma afterS s f i : after s.+1 f i = drive G c (after s f) i.
Proof.
rewrite /after /drive /= (eq_bigr (fun j => \sum_k P i k * (mpow P s k j * f j))); last first.
  by move=> j _; rewrite mxE mulr_suml; apply: eq_bigr => k _; rewrite mulrA.
by rewrite exchange_big /=; apply: eq_bigr => k _; rewrite mulr_sumr.
Qed.
Lemma eq_form f g : f =1 g -> form c K f f = form c K g g.
Proof. by move=> E; apply: eq_bigr => i _; rewrite E. Qed.
Lemma eq_centred f g : f =1 g -> centred c K f -> centred c K g.
Proof. by move=> E Z; rewrite /centred -[RHS]Z; apply: eq_bigr => i _; rewrite E. Qed.
Lemma after_centred s f : centred c K f -> centred c K (after s f).
Proof.
move=> Z; elim: s => [|s IH]; first by apply: eq_centred Z => i; rewrite after0.
apply: (@eq_centred (drive G c (after s f))); first by move=> i; rewrite afterS.
exact: drive_centred.
Qed.
Lemma after_shrinks s f : centred c K f -> form c K (after s f) (after s f) <= mu ^+ (2 * s) * form c K f f.
Proof.
move=> Z; elim: s => [|s IH]; first by rewrite (eq_form (after0 f)) muln0 expr0 mul1r.
rewrite (eq_form (afterS s f)); apply: le_trans (shrink net closed connK cK mu0 mu_gap mu_diag (after_centred s Z)) _.
by rewrite mulnS exprD -mulrA; apply: ler_wpmul2l; [rewrite exprn_ge0 // ltW | exact: IH].
Qed.

(* the smallest weight in K *)
Variable k0 : R.
Hypothesis k0_gt0 : 0 < k0.
Hypothesis k0_le : forall i, K i -> k0 <= (c i)^-1.
Lemma one_place f i : K i -> k0 * f i ^+ 2 <= form c K f f.
Proof.
move=> Ki; rewrite /form (bigD1 i) //= -[X in X <= _]addr0; apply: ler_add.
  by rewrite /weigh Ki -expr2; apply: ler_wpmul2r; [exact: sqr_ge0 | exact: k0_le].
by apply: sumr_ge0 => j _; rewrite mulr_ge0 ?weigh_ge0 // -expr2 sqr_ge0.
Qed.
Lemma two_places f i j : K i -> K j -> k0 * (f i - f j) ^+ 2 <= form c K f f *+ 2.
Proof.
move=> Ki Kj; have [->|ij] := eqVneq i j; first by rewrite subrr expr0n mulr0 mulrn_wge0 // form_ge0.
apply: (@le_trans _ _ (k0 * (f i ^+ 2 + f j ^+ 2) *+ 2)).
  rewrite -mulrnAr; apply: ler_wpmul2l; first exact: ltW.
  rewrite -subr_ge0; have -> : (f i ^+ 2 + f j ^+ 2) *+ 2 - (f i - f j) ^+ 2 = (f i + f j) ^+ 2 by ring.
  exact: sqr_ge0.
rewrite ler_muln2r /= /form (bigD1 i) //= (bigD1 j) /=; last by rewrite eq_sym.
rewrite mulrDr addrA -[X in X <= _]addr0; apply: ler_add.
  by apply: ler_add; rewrite /weigh ?Ki ?Kj -expr2; apply: ler_wpmul2r; rewrite ?sqr_ge0 ?k0_le.
by apply: sumr_ge0 => k _; rewrite mulr_ge0 ?weigh_ge0 // -expr2 sqr_ge0.
Qed.
(* a centred start with values up to b *)
Lemma decays s f b i : centred c K f -> (forall j, K j -> `|f j| <= b) -> K i ->
  k0 * after s f i ^+ 2 <= total c K * b ^+ 2 * mu ^+ (2 * s).
Proof.
move=> Z B Ki; apply: le_trans (one_place (after s f) Ki) _; apply: le_trans (after_shrinks s Z) _.
rewrite mulrC; apply: ler_wpmul2r; first by rewrite exprn_ge0 // ltW.
rewrite /form /total mulr_suml; apply: ler_sum => j _; rewrite -expr2 /weigh; case: ifP => Kj; last by rewrite !mul0r.
apply: ler_wpmul2l; first by rewrite invr_ge0 ltW ?cK.
rewrite -[f j ^+ 2]real_normK ?num_real // ler_pexpn2r ?nnegrE ?normr_ge0 ?B //.
exact: le_trans (normr_ge0 _) (B j Kj).
Qed.
End Powers.

(* ---- a connected network ---- *)
Section Connected.
Variables (R : realFieldType) (n : nat) (G : rel 'I_n) (c : 'I_n -> R).
Hypothesis net : network G.
Hypothesis MD : model_D G c.
Hypothesis conn : forall i j, connect G i j.
Hypothesis c0 : forall i, 0 < c i.
Notation P := (transition G c).
Variable mu : R.
Hypothesis mu0 : 0 < mu.
Hypothesis mu_gap : trace c * n.-1%:R * (1 - mu) <= 4%:R.
Hypothesis mu_diag : forall i, 1 - mu <= (1 - c i * (degree G i)%:R) *+ 2.
Variable k0 : R.
Hypothesis k0_gt0 : 0 < k0.
Hypothesis k0_le : forall i, k0 <= (c i)^-1.

Lemma total_trace : total c predT = trace c.
Proof. by []. Qed.
(* tau_1(P^s)^2 <= mu^(2s)/(2 min pi), min pi >= k0/tr C^-1 *)
Lemma tau1_sharp s : k0 * tau1 (mpow P s) ^+ 2 *+ 2 <= trace c * mu ^+ (2 * s).
Proof.
have SP : stochastic P by case: (model_D_stochastic net MD).
have T0 : 0 <= trace c by apply: sumr_ge0 => i _; rewrite invr_ge0 ltW.
have B0 : 0 <= trace c * mu ^+ (2 * s) by rewrite mulr_ge0 ?exprn_ge0 ?(ltW mu0).
have key i j : k0 * dist1 (mpow P s) i j ^+ 2 *+ 2 <= trace c * mu ^+ (2 * s).
  pose A := mpow P s; pose g k : R := if A j k <= A i k then 2%:R^-1 else - 2%:R^-1.
  have D : dist1 A i j = after G c s g i - after G c s g j.
    rewrite /dist1 /after -sumrB mulr_sumr; apply: eq_bigr => k _; rewrite -/A /g; case: (leP (A j k) (A i k)) => h.
      by rewrite ger0_norm ?subr_ge0 // mulrBr ![2%:R^-1 * _]mulrC.
    by rewrite ltr0_norm ?subr_lt0 // mulrN -mulNr mulrBr ![- _ * _]mulrC.
  pose m := (trace c)^-1 * \sum_k (c k)^-1 * g k; pose f k := g k - m.
  have Tp : 0 < trace c by rewrite (trace_gt0 c0 i).
  have Zf : centred c predT f.
    rewrite /centred /weigh /f (eq_bigr (fun k => (c k)^-1 * g k - (c k)^-1 * m)) => [|k _]; last by rewrite mulrBr.
    by rewrite sumrB -mulr_suml -/(trace c) /m mulVKf ?subrr // gt_eqF.
  have Df : dist1 A i j = after G c s f i - after G c s f j.
    rewrite D /after /f; have one k : \sum_l A k l * (g l - m) = \sum_l A k l * g l - m.
      rewrite (eq_bigr (fun l => A k l * g l - A k l * m)) => [|l _]; last by rewrite mulrBr.
      by rewrite sumrB -mulr_suml; have [_ ->] := stochastic_mpow s SP; rewrite mul1r.
    by rewrite !one opprB addrA addrNK.
  have Cl : forall i j, G i j -> predT i = predT j by [].
  have sq : form c predT f f <= trace c / 4%:R.
    have E : form c predT f f = \sum_k (c k)^-1 * g k ^+ 2 - trace c * m ^+ 2.
      have Em : \sum_k (c k)^-1 * g k = trace c * m by rewrite /m mulVKf // gt_eqF.
      rewrite /form /weigh /f (eq_bigr (fun k => (c k)^-1 * g k ^+ 2 - m *+ 2 * ((c k)^-1 * g k) + m ^+ 2 * (c k)^-1)) => [|k _]; last by rewrite /=; move: ((c k)^-1) (g k) => x y; ring.
      rewrite big_split sumrB /= -!mulr_sumr Em -/(trace c); ring.
    rewrite E ler_subl_addr; apply: (@le_trans _ _ (trace c / 4%:R)); last by rewrite ler_addl mulr_ge0 ?sqr_ge0.
    rewrite /trace mulr_suml; apply: ler_sum => k _; apply: ler_wpmul2l; first by rewrite invr_ge0 ltW.
    by rewrite /g; case: ifP => _; rewrite ?sqrrN expr2 -invfM -natrM.
  have h1 := two_places (fun i _ => c0 i) k0_gt0 (fun i _ => k0_le i) (after G c s f) (isT : predT i) (isT : predT j).
  rewrite -/A Df; apply: le_trans (_ : _ <= form c predT (after G c s f) (after G c s f) *+ 2 *+ 2) _; first by rewrite ler_muln2r.
  have h2 := after_shrinks net Cl (fun i j _ _ => conn i j) (fun i _ => c0 i) mu0 mu_gap (fun i _ => mu_diag i) s Zf.
  rewrite -mulrnA; apply: le_trans (_ : _ <= (mu ^+ (2 * s) * (trace c / 4%:R)) *+ 4) _.
    by rewrite ler_muln2r /=; apply: le_trans h2 _; apply: ler_wpmul2l; rewrite // exprn_ge0 // ltW.
  by rewrite -mulrnAr -[_ *+ 4]mulr_natr mulfVK ?pnatr_eq0 // mulrC.
apply: (big_ind (fun x => k0 * x ^+ 2 *+ 2 <= trace c * mu ^+ (2 * s))) => [|x y hx hy|[i j] _].
- by rewrite expr0n mulr0 mul0rn.
- by rewrite /Num.max; case: ifP.
exact: key.
Qed.
End Connected.

(* ---- chazelle.fiedler.rate, corrected ---- *)
(* an eigenvalue of the Laplacian other than 0 is at least 4/(n (n-1)) *)
Lemma fiedler_nonzero (R : realFieldType) n (G : rel 'I_n) lam (f : 'I_n -> R) : network G -> (forall i j, connect G i j) ->
  (forall i, \sum_j laplacian R G i j * f j = lam * f i) -> (exists i, f i != 0) -> lam != 0 -> 4%:R <= lam * (n * n.-1)%:R.
Proof.
move=> net conn E [i0 fi] l0; have [sym irr] := net; pose c (_ : 'I_n) : R := 1.
have cK i : predT i -> 0 < c i by move=> _; exact: ltr01.
have Cl : forall i j, G i j -> predT i = predT j by [].
have D i : f i - drive G c f i = lam * f i.
  rewrite -E /drive (eq_bigr (fun j => (i == j)%:R * f j - laplacian R G i j * f j)) => [|j _]; last first.
    have -> : transition G c i j = (i == j)%:R - laplacian R G i j.
      rewrite transitionE // !mxE /c mul1r; case: (i == j); first by [].
      by case: (G i j); rewrite ?sub0r ?opprK ?oppr0.
    by rewrite mulrBl.
  rewrite sumrB (bigD1 i) //= eqxx mul1r big1 ?addr0 ?subKr // => j ji; by rewrite eq_sym (negbTE ji) mul0r.
have Z : centred c predT f.
  have S : \sum_i lam * f i = 0.
    rewrite -[RHS](drop_centred net Cl cK f); apply: eq_bigr => i _; by rewrite D /weigh /= /c invr1 mul1r.
  rewrite /centred /weigh (eq_bigr (fun i => f i)) => [|i _]; last by rewrite /= /c invr1 mul1r.
  by move/eqP: S; rewrite -mulr_sumr mulf_eq0 (negbTE l0) /= => /eqP.
have F0 : 0 < form c predT f f.
  rewrite /form (bigD1 i0) //=; apply: ltr_paddr.
    by apply: sumr_ge0 => i _; rewrite /weigh /= /c invr1 mul1r -expr2 sqr_ge0.
  by rewrite /weigh /= /c invr1 mul1r -expr2 exprn_even_gt0.
have := gap net Cl (fun i j _ _ => conn i j) cK Z.
have -> : form c predT f f - form c predT f (drive G c f) = lam * form c predT f f.
  rewrite /form mulr_sumr -sumrB; apply: eq_bigr => i _.
  by rewrite -mulrBr -mulrBr D; ring.
have -> : total c predT = n%:R.
  by rewrite /total /weigh /= (eq_bigr (fun=> 1)) => [|i _]; rewrite ?invr1 // sumr_const card_ord.
rewrite mulrA -[_ *+ 4]mulr_natl ler_pmul2r // => h; by rewrite natrM mulrC.
Qed.
(* clause 1: 0 is simple, only the constant vectors belong to it; so the Fiedler number, the second smallest eigenvalue counted with
   multiplicity, is the least one that has an eigenvector other than the constant ones *)
Theorem fiedler_sharp (R : realFieldType) n (G : rel 'I_n) : network G -> (forall i j, connect G i j) ->
  (forall f : 'I_n -> R, (forall i, \sum_j laplacian R G i j * f j = 0) <-> exists c, forall i, f i = c) /\
  forall lam (f : 'I_n -> R), (forall i, \sum_j laplacian R G i j * f j = lam * f i) -> (exists i j, f i != f j) -> 4%:R <= lam * (n * n.-1)%:R.
Proof.
move=> net conn; have [sym irr] := net; pose c (_ : 'I_n) : R := (n%:R)^-1.
have [n0|n0] := posnP n.
  move: G net conn sym irr c; rewrite n0 => G _ _ _ _ _; split; first by move=> f; split=> [_|_ []//]; exists 0; case.
  by move=> lam f _ [[]].
have drop (f : 'I_n -> R) i : f i - drive G c f i = (n%:R)^-1 * \sum_j laplacian R G i j * f j.
  rewrite /drive mulr_sumr (eq_bigr (fun j => (i == j)%:R * f j - (n%:R)^-1 * (laplacian R G i j * f j))) => [|j _]; last first.
    have -> : transition G c i j = (i == j)%:R - (n%:R)^-1 * laplacian R G i j.
      rewrite transitionE // !mxE /c; case: (i == j); first by [].
      by case: (G i j); rewrite ?mulrN1 ?mulr0 ?sub0r ?opprK ?oppr0.
    by rewrite mulrBl mulrA.
  rewrite sumrB (bigD1 i) //= eqxx mul1r big1 ?addr0 ?subKr // => j ji; by rewrite eq_sym (negbTE ji) mul0r.
have c0 i : 0 < c i by rewrite invr_gt0 ltr0n.
have MD : model_D G c.
  move=> i di; rewrite mulr_gt0 ?c0 ?ltr0n //= /c mulrC ltr_pdivr_mulr ?ltr0n // mul1r ltr_nat.
  by rewrite -[X in (_ < X)%N]card_ord; apply: (leq_trans (n := #|predC1 i|.+1)); rewrite ?ltnS; [apply: subset_leq_card; apply/subsetP => j; rewrite !inE; apply: contraTneq => ->; rewrite irr | rewrite cardC1 card_ord prednK].
have simple (f : 'I_n -> R) : (forall i, \sum_j laplacian R G i j * f j = 0) -> forall i j, f i = f j.
  move=> Z i j; have [_ _ [K _] _ _] := stationary net MD conn c0 i; apply: K => k.
  by have /eqP := drop f k; rewrite Z mulr0 subr_eq0 => /eqP.
split=> [f|lam f E [i [j ne]]].
  split=> [Z|[b fb] i]; first by exists (f (Ordinal n0)) => i; exact: simple.
  rewrite (eq_bigr (fun j => b * laplacian R G i j)) => [|j _]; last by rewrite fb mulrC.
  have := drop (fun _ => 1) i; rewrite (_ : drive G c _ i = 1) ?subrr => [/esym/eqP|].
    rewrite mulf_eq0 invr_eq0 pnatr_eq0 (gtn_eqF n0) /= => /eqP Z; rewrite -mulr_sumr.
    by rewrite -(eq_bigr _ (fun j _ => mulr1 (laplacian R G i j))) Z mulr0.
  by rewrite /drive; have [[_ A1] _] := model_D_stochastic net MD; rewrite (eq_bigr _ (fun j _ => mulr1 (transition G c i j))) A1.
apply: (fiedler_nonzero net conn E).
  by case: (eqVneq (f i) 0) => [z|]; [exists j; rewrite -z eq_sym | exists i].
by apply: contraNneq ne => l0; apply/eqP/simple => k; rewrite E l0 mul0r.
Qed.

(* clause 3: weights with 1 <= 1/c_i <= 2n and 1 - c_i d_i >= n^-3 *)
Section Cubic.
Variables (R : realFieldType) (n : nat) (G : rel 'I_n) (c : 'I_n -> R).
Hypothesis net : network G.
Hypothesis MD : model_D G c.
Hypothesis conn : forall i j, connect G i j.
Hypothesis n2 : (1 < n)%N.
Hypothesis c0 : forall i, 0 < c i.
Hypothesis c_inv : forall i, 1 <= (c i)^-1 <= (2 * n)%:R.
Hypothesis c_diag : forall i, ((n ^ 3)%:R)^-1 <= 1 - c i * (degree G i)%:R.
Let mu : R := 1 - ((n ^ 3)%:R)^-1.
Let N3 : (1 < n ^ 3)%N. Proof. by rewrite -(exp1n 3) ltn_exp2r. Qed.
Lemma tau1_cubic s : tau1 (mpow (transition G c) s) <= n%:R * mu ^+ s.
Proof.
have N0 : (0 : R) < (n ^ 3)%:R by rewrite ltr0n (ltnW N3).
have m0 : 0 < mu by rewrite subr_gt0 invf_lt1 // ltr1n.
have T : trace c <= (2 * n ^ 2)%:R.
  apply: (@le_trans _ _ (\sum_(i < n) (2 * n)%:R)); first by apply: ler_sum => i _; have /andP[] := c_inv i.
  by rewrite sumr_const card_ord -mulrnA ler_nat; lia.
have g : trace c * n.-1%:R * (1 - mu) <= 4%:R.
  rewrite subKr ler_pdivr_mulr //; apply: (@le_trans _ _ ((2 * n ^ 2)%:R * n.-1%:R)); first by apply: ler_wpmul2r; rewrite ?ler0n.
  by rewrite -!natrM ler_nat; case: (n) n2 => [|m] _ //=; lia.
have dg i : 1 - mu <= (1 - c i * (degree G i)%:R) *+ 2.
  rewrite subKr mulr2n; apply: (le_trans (c_diag i)); rewrite ler_addl; apply: le_trans (c_diag i); by rewrite invr_ge0 ltW.
have := tau1_sharp net MD conn c0 m0 g dg ltr01 (fun i => proj1 (andP (c_inv i))) s; rewrite mul1r => h.
have B : 0 <= n%:R * mu ^+ s by rewrite mulr_ge0 ?ler0n // exprn_ge0 // ltW.
rewrite -(@ler_pexpn2r _ 2) ?nnegrE ?tau1_ge0 // -(@ler_pmuln2r _ 2) //; apply: le_trans h _.
rewrite exprMn -[(mu ^+ s) ^+ 2]exprM [(s * 2)%N]mulnC -mulrnAl; apply: ler_wpmul2r; first by rewrite exprn_ge0 // ltW.
by apply: le_trans T _; rewrite -natrX -mulrnA ler_nat mulnC.
Qed.
Lemma half_cubic s : (mu ^+ s) ^+ (n ^ 3) * 2%:R ^+ s <= 1.
Proof.
have h : mu ^+ (n ^ 3) <= 2%:R^-1 by have := @halving R (n ^ 3) (n ^ 3) (ltnW N3); rewrite divnn (ltnW N3) expr1.
have m0 : 0 <= mu by rewrite subr_ge0 invf_le1 ?ler1n ?ltr0n ltnW.
rewrite -exprM mulnC exprM -exprMn exprn_ile1 ?mulr_ge0 ?exprn_ge0 ?ler0n //.
by rewrite -ler_pdivl_mulr ?ltr0n // mul1r.
Qed.
End Cubic.
(* both kinds of weights, any norm *)
Theorem lazy_vicsek_rate (R : rcfType) n d (G : rel 'I_n) (c : 'I_n -> R) (v : nat -> 'M[R]_(n, d)) (N : 'rV[R]_d -> R) t i j :
  N 0 = 0 -> (forall b y, N (b *: y) = `|b| * N y) -> (forall y z, N (y + z) <= N y + N z) -> network G -> (forall i j, connect G i j) -> (1 < n)%N ->
  (forall i, c i = 2%:R / (3 * degree G i)%:R) \/ (forall i, c i = (degree G i).+1%:R^-1) ->
  (forall t, (0 < t)%N -> v t.+1 = transition G c *m v t) ->
  N (row i (v t.+1) - row j (v t.+1)) ^+ (n ^ 3) * 2%:R ^+ t <= (n%:R * diameter N (v 1%N)) ^+ (n ^ 3).
Proof.
move=> N_0 N_Z N_D net conn n2 W Hv; have [sym irr] := net.
have d0 k : (0 < degree G k)%N.
  have [l kl] : exists l : 'I_n, k != l.
    pose a : 'I_n := Ordinal (ltnW n2); pose b : 'I_n := Ordinal n2; have [->|?] := eqVneq k a; last by exists a.
    by exists b.
  have /connectP[[|m p] /=] := conn k l; first by move=> _ e; rewrite e eqxx in kl.
  by case/andP=> Gkm _ _; exact: edge_degree Gkm.
have dn k : (degree G k < n)%N.
  rewrite -[X in (_ < X)%N]card_ord; apply: proper_card; apply/properP; split; first by apply/subsetP.
  by exists k; rewrite // inE irr.
have dR k : (0 : R) < (degree G k)%:R by rewrite ltr0n.
have n3 : (n <= n ^ 3)%N by rewrite -{1}[n]expn1 leq_exp2l.
have big3 : (3 <= n ^ 3)%N by apply: (@leq_trans (2 ^ 3)); rewrite // leq_exp2r.
have facts : [/\ forall k, 0 < c k, forall k, c k * (degree G k)%:R < 1, forall k, 1 <= (c k)^-1 <= (2 * n)%:R &
    forall k, ((n ^ 3)%:R)^-1 <= 1 - c k * (degree G k)%:R].
  case: W => W.
    have cd k : c k * (degree G k)%:R = 2%:R / 3%:R.
      by rewrite W natrM invfM -!mulrA mulVf ?mulr1 // gt_eqF.
    split=> k; rewrite ?cd ?W.
    - by rewrite divr_gt0 ?ltr0n // muln_gt0 d0.
    - by rewrite ltr_pdivr_mulr ?ltr0n // mul1r ltr_nat.
    - rewrite invf_div ler_pdivl_mulr ?ltr0n // ler_pdivr_mulr ?ltr0n // mul1r -natrM !ler_nat; move: (d0 k) (dn k); lia.
    have -> : 1 - 2%:R / 3%:R = 3%:R^-1 :> R by apply: (mulIf (_ : 3%:R != 0)); rewrite ?pnatr_eq0 // mulrBl mul1r divfK ?pnatr_eq0 // mulVf ?pnatr_eq0 // -natrB.
    by rewrite lef_pinv ?posrE ?ltr0n ?ler_nat // (leq_trans _ big3).
  have cd k : c k * (degree G k)%:R = 1 - (degree G k).+1%:R^-1.
    apply: (mulIf (_ : (degree G k).+1%:R != 0)); rewrite ?pnatr_eq0 // W mulrAC mulVf ?pnatr_eq0 // mul1r mulrBl mul1r mulVf ?pnatr_eq0 //.
    by rewrite -addn1 natrD addrK.
  split=> k; rewrite ?cd ?W.
  - by rewrite invr_gt0 ltr0n.
  - by rewrite ltr_subl_addr ltr_addl invr_gt0 ltr0n.
  - rewrite invrK ler1n /= ler_nat; move: (dn k); lia.
  have p3 : (0 < n ^ 3)%N by exact: leq_trans big3.
  rewrite subKr lef_pinv ?posrE ?ltr0n // ler_nat; exact: leq_trans (dn k) n3.
have [c0 cd1 ci cg] := facts.
have MD : model_D G c by move=> k _; rewrite mulr_gt0 ?cd1.
have SP : stochastic (transition G c) by case: (model_D_stochastic net MD).
have E : v t.+1 = mpow (transition G c) t *m v 1%N.
  elim: t => [|t IH]; first by rewrite mul1mx.
  by rewrite Hv // IH mulmxA.
have T0 : 0 <= diameter N (v 1%N) by exact: max_ge0.
have Nge y : 0 <= N y by move: (N_D y (- y)); rewrite subrr N_0 -[- y]scaleN1r N_Z normrN1 mul1r -mulr2n pmulrn_lge0.
set mu : R := 1 - ((n ^ 3)%:R)^-1; have m0 : 0 <= mu by rewrite subr_ge0 invf_le1 ?ler1n ?ltr0n (leq_trans _ big3).
have h : N (row i (v t.+1) - row j (v t.+1)) <= n%:R * mu ^+ t * diameter N (v 1%N).
  rewrite E; apply: le_trans (diameter_ub _ _ _ _) _.
  apply: le_trans (diameter_mul N_0 N_Z N_D _ (stochastic_mpow t SP)) _.
  apply: ler_wpmul2r => //; exact: tau1_cubic.
have h2 : N (row i (v t.+1) - row j (v t.+1)) ^+ (n ^ 3) <= (n%:R * diameter N (v 1%N)) ^+ (n ^ 3) * (mu ^+ t) ^+ (n ^ 3).
  rewrite -exprMn [n%:R * diameter N _ * _]mulrAC; apply: ler_expn2r => //; rewrite nnegrE ?Nge //.
  by rewrite mulr_ge0 // mulr_ge0 ?ler0n ?exprn_ge0.
apply: (@le_trans _ _ ((n%:R * diameter N (v 1%N)) ^+ (n ^ 3) * (mu ^+ t) ^+ (n ^ 3) * 2%:R ^+ t)); first by apply: ler_wpmul2r; rewrite ?exprn_ge0 ?ler0n.
rewrite -mulrA -[X in _ <= X]mulr1; apply: ler_wpmul2l; first by rewrite exprn_ge0 // mulr_ge0 ?ler0n.
exact: half_cubic.
Qed.
