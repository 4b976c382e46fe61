(* Paley et al., circular formations on circulant graphs: the spectrum of the law (22) at theta_k = 2 pi m k/N.
     beyond.paley.circulant_spectrum (clause 1).
   The law (22), u_k = w0 + (k_1 - k_0) <i z_k, L_k z> + w0 k_0 <z_k, L_k r> with k_j = K_j/N, is a polynomial in the coordinates x, y of
   the particles and the cosines and sines c, s of their headings, `rate` its rates in the frame that turns at w0 about the centre.  A
   displacement along x, y or theta moves (x, y, c, s) to first order to (x + X dx, y + X dy, c - s X dtheta, s + c X dtheta); the matrix
   `jacobian` is made of the coefficients of X of the rates.  e^(i theta_k) = w^(m k) for a primitive n-th root w of 1, over any field with
   such a root, a root im of -1 and 2 and n other than 0 (the complex numbers, w0, k_0, k_1 real or not); lambda_q belongs to the column
   w^(q k) of the Laplacian (`eigenvector`).  Hypotheses: an undirected circulant graph, connected or not, w0 <> 0.  The modes w^(q k) of
   the displacement a_k + i b_k of the centre along e^(i theta_k) and of the phase separate the matrix into 3 x 3 blocks.  No axioms. *)
Set Warnings "-notation-overridden,-ambiguous-paths".
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import ring zify.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Import GRing.Theory.
Local Open Scope ring_scope.

(* ---- the law (22) in the turning frame: sums over the neighbours j of k ---- *)
Section Law.
Variables (A : comRingType) (n : nat) (adj : rel 'I_n) (w0 k0 k1 : A).
Implicit Types x y c s : 'I_n -> A.
Definition steering x y c s k : A :=
  w0 + (k1 - k0) * (\sum_(j | adj k j) (c k * (s k - s j) - s k * (c k - c j)))
     + w0 * k0 * \sum_(j | adj k j) (c k * (x k - x j) + s k * (y k - y j)).
Definition rate x y c s k (i : nat) : A :=
  match i with 0 => c k + w0 * y k | 1 => s k - w0 * x k | _ => steering x y c s k - w0 end.
End Law.

(* ---- its first-order coefficients: lin u v is u + v X ---- *)
Definition lin (K : ringType) (u v : K) : {poly K} := u%:P + v%:P * 'X.
Section Dual.
Variable K : comRingType.
Implicit Types p q : {poly K}.
Lemma lin0 (u v : K) : (lin u v)`_0 = u.
Proof. by rewrite /lin coefD coefC coefMX addr0. Qed.
Lemma lin1 (u v : K) : (lin u v)`_1 = v.
Proof. by rewrite /lin coefD coefC coefMX coefC add0r. Qed.
Lemma mul1 p q : (p * q)`_1 = p`_0 * q`_1 + p`_1 * q`_0.
Proof. by rewrite coefM big_ord_recl big_ord_recl big_ord0 addr0. Qed.
Lemma mul0 p q : (p * q)`_0 = p`_0 * q`_0.
Proof. by rewrite coefM big_ord_recl big_ord0 addr0. Qed.
Lemma coefC1 (u : K) : (u%:P : {poly K})`_1 = 0. Proof. by rewrite coefC. Qed.
Lemma coefC0 (u : K) : (u%:P : {poly K})`_0 = u. Proof. by rewrite coefC. Qed.
End Dual.

Section Linearisation.
Variables (K : comRingType) (n : nat) (adj : rel 'I_n) (w0 k0 k1 : K).
Variables x y c s : 'I_n -> K.
Implicit Types d : 'I_n -> nat -> K.
Definition first_order d k i : K :=
  (rate adj w0%:P k0%:P k1%:P (fun k => lin (x k) (d k 0%N)) (fun k => lin (y k) (d k 1%N))
     (fun k => lin (c k) (- s k * d k 2%N)) (fun k => lin (s k) (c k * d k 2%N)) k i)`_1.
Definition unit_at l j : 'I_n -> nat -> K := fun k i => ((k == l) && (i == j))%:R.

Definition explicit d k i : K :=
  match i with
  | 0 => - s k * d k 2%N + w0 * d k 1%N
  | 1 => c k * d k 2%N - w0 * d k 0%N
  | _ => (k1 - k0) * (\sum_(j | adj k j) (c k * (c k * d k 2%N - c j * d j 2%N) - s k * d k 2%N * (s k - s j)
                       - (s k * (- s k * d k 2%N + s j * d j 2%N) + c k * d k 2%N * (c k - c j))))
    + w0 * k0 * \sum_(j | adj k j) (c k * (d k 0%N - d j 0%N) - s k * d k 2%N * (x k - x j)
                       + (s k * (d k 1%N - d j 1%N) + c k * d k 2%N * (y k - y j)))
  end.
Lemma first_orderE d k i : first_order d k i = explicit d k i.
Proof.
have E := (coefD, coefB, coefN, mul1, lin0, lin1, coefC0, coefC1, mul0, coef_sum).
case: i => [|[|i]]; rewrite /first_order /explicit /rate.
- by rewrite !E mul0r addr0.
- by rewrite !E mul0r addr0.
rewrite /steering !E !(subr0, mulr0, mul0r, addr0, add0r); congr (_ * _ + _ * _).
  by apply: eq_bigr => j _; rewrite !E; ring.
by apply: eq_bigr => j _; rewrite !E; ring.
Qed.
Lemma explicit_sum (I : finType) (u : I -> K) (e : I -> 'I_n -> nat -> K) d k i :
  (forall l j, (j < 3)%N -> d l j = \sum_q u q * e q l j) -> explicit d k i = \sum_q u q * explicit (e q) k i.
Proof.
move=> H; case: i => [|[|i]] /=.
- by rewrite !H // !mulr_sumr -big_split; apply: eq_bigr => q _ /=; ring.
- by rewrite !H // !mulr_sumr -sumrB; apply: eq_bigr => q _ /=; ring.
have pull (P : pred 'I_n) (G : 'I_n -> K) (G' : I -> 'I_n -> K) a : (forall j, G j = \sum_q u q * G' q j) ->
    a * (\sum_(j | P j) G j) = \sum_q u q * (a * \sum_(j | P j) G' q j).
  move=> HG; rewrite (eq_bigr _ (fun j _ => HG j)) exchange_big mulr_sumr; apply: eq_bigr => q _.
  by rewrite -mulr_sumr mulrCA.
under [RHS]eq_bigr do rewrite mulrDr.
rewrite [RHS]big_split /=; congr (_ + _); apply: pull => j.
  transitivity ((c k * c k - s k * (s k - s j) + s k * s k - c k * (c k - c j)) * d k 2%N - (c k * c j + s k * s j) * d j 2%N); first by ring.
  by rewrite !H // !mulr_sumr -sumrB; apply: eq_bigr => q _; ring.
transitivity (c k * d k 0%N + s k * d k 1%N + (c k * (y k - y j) - s k * (x k - x j)) * d k 2%N - (c k * d j 0%N + s k * d j 1%N)); first by ring.
by rewrite !H // !mulr_sumr -!big_split -sumrB /=; apply: eq_bigr => q _; ring.
Qed.
End Linearisation.
(* ---- three numbers for each of n particles ---- *)
Section Triples.
Lemma part_lt n (i : 'I_(n * 3)) : (i %/ 3 < n)%N. Proof. by rewrite ltn_divLR. Qed.
Definition part n (i : 'I_(n * 3)) : 'I_n := Ordinal (part_lt i).

Lemma sum_triples_nat (V : zmodType) n (f : nat -> nat -> V) :
  \sum_(i < n * 3) f (i %/ 3)%N (i %% 3)%N = \sum_(k < n) (f k 0%N + f k 1%N + f k 2%N).
Proof.
elim: n f => [|n IH] f; first by rewrite !big_ord0.
rewrite [RHS]big_ord_recl -[(n.+1 * 3)%N]/(3 + n * 3)%N big_split_ord /=; congr (_ + _).
  by rewrite !big_ord_recl big_ord0 addr0 /= addrA.
rewrite -(IH (fun k => f k.+1)); apply: eq_bigr => i _.
by rewrite divnDl // modnDl.
Qed.
Lemma sum_triples (V : zmodType) n (f : 'I_n -> nat -> V) :
  \sum_(i < n * 3) f (part i) (i %% 3)%N = \sum_k (f k 0%N + f k 1%N + f k 2%N).
Proof.
pose g k j := if insub k is Some k' then f k' j else 0.
have gE (k : 'I_n) j : g k j = f k j by rewrite /g; case: insubP => [u _ /val_inj->|]; rewrite ?ltn_ord.
transitivity (\sum_(i < n * 3) g (i %/ 3)%N (i %% 3)%N); first by apply: eq_bigr => i _; rewrite -(gE (part i)).
by rewrite sum_triples_nat; apply: eq_bigr => k _; rewrite !gE.
Qed.
(* the determinant of a matrix with 3 x 3 blocks along the diagonal *)
Lemma det_triples (R : comRingType) n (f : nat -> nat -> nat -> R) :
  \det (\matrix_(i < n * 3, j < n * 3) if (i %/ 3 == j %/ 3)%N then f (i %/ 3)%N (i %% 3)%N (j %% 3)%N else 0)
  = \prod_(k < n) \det (\matrix_(i < 3, j < 3) f k i j).
Proof.
elim: n f => [|n IH] f; first by rewrite big_ord0 det_mx00.
rewrite [RHS]big_ord_recl -(IH (fun k => f k.+1)).
set M := (X in \det X = _); have -> : M = block_mx (\matrix_(i < 3, j < 3) f 0%N i j) 0 0
  (\matrix_(i < n * 3, j < n * 3) if (i %/ 3 == j %/ 3)%N then f (i %/ 3).+1 (i %% 3)%N (j %% 3)%N else 0) :> 'M_(3 + n * 3).
  rewrite -[LHS](@submxK _ 3 (n * 3) 3 (n * 3)); congr block_mx; apply/matrixP=> i j; rewrite !mxE /=.
  - by rewrite !divn_small // eqxx !modn_small.
  - by rewrite divn_small // divnDl // ifN.
  - by rewrite (divn_small (ltn_ord j)) divnDl // ifN.
  by rewrite !divnDl // !modnDl eqSS.
exact: (@det_ublock _ 3 (n * 3)).
Qed.
Lemma char_triples (R : comRingType) n (f : nat -> nat -> nat -> R) :
  char_poly (\matrix_(i < n * 3, j < n * 3) if (i %/ 3 == j %/ 3)%N then f (i %/ 3)%N (i %% 3)%N (j %% 3)%N else 0)
  = \prod_(k < n) char_poly (\matrix_(i < 3, j < 3) f k i j).
Proof.
transitivity (\prod_(k < n) \det (\matrix_(i < 3, j < 3) ('X *+ (i == j :> nat) - (f k i j)%:P)));
  last by apply: eq_bigr => k _; congr (\det _); apply/matrixP=> i j; rewrite !mxE.
rewrite -(det_triples n (fun k i j => 'X *+ (i == j :> nat) - (f k i j)%:P)); congr (\det _); apply/matrixP=> i j; rewrite !mxE.
have E : (i == j) = (i %/ 3 == j %/ 3)%N && (i %% 3 == j %% 3)%N.
  apply/eqP/andP=> [->//|[/eqP A /eqP B]]; apply: val_inj; by rewrite /= (divn_eq i 3) (divn_eq j 3) A B.
by rewrite E; case: eqP => _ //=; rewrite mulr0n subr0.
Qed.
Lemma det3 (R : comRingType) (f : nat -> nat -> R) : \det (\matrix_(i < 3, j < 3) f i j) =
  f 0%N 0%N * (f 1%N 1%N * f 2%N 2%N - f 1%N 2%N * f 2%N 1%N) - f 0%N 1%N * (f 1%N 0%N * f 2%N 2%N - f 1%N 2%N * f 2%N 0%N)
  + f 0%N 2%N * (f 1%N 0%N * f 2%N 1%N - f 1%N 1%N * f 2%N 0%N).
Proof.
rewrite (expand_det_row _ 0) !big_ord_recl big_ord0 /cofactor !(expand_det_row _ 0) !big_ord_recl !big_ord0 /cofactor !det_mx11 !mxE /=.
rewrite /bump /= !(addr0, expr0, expr1, expr2, addn0, add0n, addn1) /=; ring.
Qed.
(* similar matrices *)
Lemma char_similar (K : fieldType) n (J V B W : 'M[K]_n) : W *m V = 1%:M -> J *m V = V *m B -> char_poly J = char_poly B.
Proof.
move=> WV JV; have dV : \det (map_mx polyC V) != 0.
  have := congr1 (fun X => \det (map_mx polyC X)) WV; rewrite map_mxM det_mulmx map_mx1 det1 => E.
  by apply: contra_eq_neq E => ->; rewrite mulr0 eq_sym oner_neq0.
apply: (mulIf dV); rewrite /char_poly -det_mulmx mulrC -det_mulmx; congr (\det _).
by rewrite /char_poly_mx mulmxBl mulmxBr -!map_mxM JV scalar_mxC.
Qed.
End Triples.

(* ---- circulant graphs ---- *)
Section Circulant.
Variables (K : fieldType) (n : nat) (adj : rel 'I_n) (S : pred nat) (w : K).
Hypothesis circulant : forall k j : 'I_n, adj k j = S ((j + n - k) %% n)%N.
Hypothesis undirected : symmetric adj.
Hypothesis prim : n.-primitive_root w.
Let n0 : (0 < n)%N := prim_order_gt0 prim.
Let wn : w ^+ n = 1 := prim_expr_order prim.
Let wu : w \is a GRing.unit. Proof. by rewrite -(unitrX_pos _ n0) wn unitr1. Qed.

(* the eigenvalue of the Laplacian on w^(q k) *)
Definition eigenvalue (q : nat) : K := \sum_(d < n | S d) (1 - w ^+ (q * d)).
Lemma w_mod q d : w ^+ (q * (d %% n)) = w ^+ (q * d).
Proof. by rewrite !(mulnC q) !exprM -(expr_mod d wn). Qed.
Lemma rotate (k : 'I_n) (P : pred nat) (F : nat -> K) :
  \sum_(j < n | P ((j + n - k) %% n)%N) F ((j + n - k) %% n)%N = \sum_(d < n | P d) F d.
Proof.
pose h (j : 'I_n) := Ordinal (ltn_pmod (j + n - k) n0).
have hI : injective h.
  move=> i j [E]; apply: val_inj; have ki := ltn_ord k.
  have : (i + n - k + k = j + n - k + k %[mod n])%N by apply/eqP; rewrite eqn_modDr; apply/eqP.
  by rewrite !subnK ?(leq_trans (ltnW ki)) ?leq_addl // !modnDr !modn_small.
by rewrite [RHS](reindex_inj hI).
Qed.
Lemma eigenvector q (k : 'I_n) : \sum_(j | adj k j) (w ^+ (q * k) - w ^+ (q * j)) = eigenvalue q * w ^+ (q * k).
Proof.
rewrite /eigenvalue -(rotate k S (fun d => 1 - w ^+ (q * d))) mulr_suml; apply: eq_big => [j|j _]; first exact: circulant.
rewrite mulrBl mul1r w_mod -exprD -mulnDr subnK ?(leq_trans (ltnW (ltn_ord k))) ?leq_addl //.
by rewrite mulnDr exprD (mulnC q n) [w ^+ (n * q)]exprM wn expr1n mulr1.
Qed.
Lemma S_opposite d : (d < n)%N -> S ((n - d) %% n)%N = S d.
Proof.
move=> dn; have := undirected (Ordinal n0) (Ordinal dn); rewrite !circulant /= add0n subn0 modnDr (modn_small dn).
by move=> ->.
Qed.
Lemma eigenvalue_opposite p q : (n %| p + q)%N -> eigenvalue p = eigenvalue q.
Proof.
case/dvdnP=> r pq; pose h (j : 'I_n) := Ordinal (ltn_pmod (n - j) n0).
have hK : involutive h.
  case=> [[|j] jn]; apply: val_inj => /=; first by rewrite subn0 modnn subn0 modnn.
  by rewrite (@modn_small (n - j.+1)) ?subKn ?modn_small // ?(ltnW jn) // ltn_subrL n0.
rewrite /eigenvalue [RHS](reindex_inj (inv_inj hK)); apply: eq_big => [j|j _] /=; first by rewrite S_opposite.
congr (1 - _); rewrite w_mod; apply: (mulIr (unitrX (q * j) wu)).
rewrite -!exprD -mulnDl -mulnDr subnK ?(ltnW (ltn_ord j)) // pq.
by rewrite mulnAC !(mulnC _ n) !exprM wn !expr1n.
Qed.
End Circulant.

(* ---- the spectrum ---- *)
Section Spectrum.
Variables (K : fieldType) (n : nat) (adj : rel 'I_n) (S : pred nat) (w im : K).
Hypothesis circulant : forall k j : 'I_n, adj k j = S ((j + n - k) %% n)%N.
Hypothesis undirected : symmetric adj.
Hypothesis prim : n.-primitive_root w.
Hypothesis im2 : im ^+ 2 = -1.
Hypothesis two : 2%:R != 0 :> K.
Hypothesis nK : n%:R != 0 :> K.
Variables (m : nat) (w0 k0 k1 : K).
Hypothesis mn : (m <= n)%N.
Hypothesis w0_neq0 : w0 != 0.
Let n0 : (0 < n)%N := prim_order_gt0 prim.
Let wn : w ^+ n = 1 := prim_expr_order prim.

(* e^(i theta_k) = w^(m k), w a primitive n-th root of unity *)
Definition cosine (k : 'I_n) : K := (w ^+ (m * k) + (w ^+ (m * k))^-1) / 2%:R.
Definition sine (k : 'I_n) : K := (w ^+ (m * k) - (w ^+ (m * k))^-1) / (2%:R * im).
(* r_k = - (i / w0) e^(i theta_k) *)
Definition place_x k : K := sine k / w0.
Definition place_y k : K := - cosine k / w0.

Notation lam := (eigenvalue n S w).
Definition Cq q : K := (lam (m + q) + lam (m + (n - q))) / 2%:R.
Definition Dq q : K := (lam (m + q) - lam (m + (n - q))) / 2%:R.
Definition tq q : K := Cq q - lam m.
Definition cubic q : {poly K} :=
  'X^3 + (k0 * Cq q - k1 * tq q)%:P * 'X^2 + (w0 ^+ 2 - im * w0 * k0 * Dq q)%:P * 'X - (k1 * tq q * w0 ^+ 2)%:P.

Notation z k := (w ^+ (m * k)).
Lemma w_neq0 : w != 0. Proof. by apply: contra_eq_neq wn => ->; rewrite expr0n gtn_eqF // eq_sym oner_neq0. Qed.
Lemma im_neq0 : im != 0.
Proof. by apply: contra_eq_neq im2 => ->; rewrite expr0n /= eq_sym oppr_eq0 oner_neq0. Qed.
Lemma z_neq0 k : w ^+ k != 0. Proof. by rewrite expf_neq0 // w_neq0. Qed.
Lemma four : 4%:R != 0 :> K. Proof. by rewrite (natrM K 2 2) mulf_neq0. Qed.
Lemma circle k : cosine k ^+ 2 + sine k ^+ 2 = 1.
Proof.
rewrite /cosine /sine !expr_div_n exprMn im2; have := z_neq0 (m * k); set u := w ^+ _ => u0.
by field; rewrite oppr_eq0 u0 four.
Qed.
(* sums over the neighbours on w^(q k) *)
Lemma sum_plus q (k : 'I_n) : \sum_(j | adj k j) (w ^+ (q * k) - w ^+ (q * j) * (z j / z k)) = lam (m + q) * w ^+ (q * k).
Proof.
transitivity ((\sum_(j | adj k j) (w ^+ ((m + q) * k) - w ^+ ((m + q) * j))) / z k).
  rewrite mulr_suml; apply: eq_bigr => j _; rewrite !mulnDl !exprD; have := z_neq0 (m * k); set u := w ^+ (m * k) => u0; by field.
by rewrite (eigenvector circulant prim) mulnDl exprD; have := z_neq0 (m * k); set u := w ^+ (m * k) => u0; field.
Qed.
Lemma w_opposite p q k : (p + q = n + n)%N -> w ^+ (p * k) = (w ^+ (q * k))^-1.
Proof.
move=> E; apply: (mulIf (z_neq0 (q * k))); rewrite mulVf ?z_neq0 // -exprD -mulnDl E addnn -muln2 -mulnA exprM wn expr1n //.
Qed.
Lemma sum_minus q (k : 'I_n) : (q <= n)%N ->
  \sum_(j | adj k j) (w ^+ (q * k) - w ^+ (q * j) * (z k / z j)) = lam (m + (n - q)) * w ^+ (q * k).
Proof.
move=> qn; have -> : lam (m + (n - q)) = lam (n - m + q).
  by apply: (eigenvalue_opposite circulant undirected prim); rewrite addnACA subnKC // subnK // addnn -muln2 dvdn_mulr.
have zE (j : 'I_n) : w ^+ ((n - m) * j) = (z j)^-1.
  apply: (mulIf (z_neq0 (m * j))); rewrite mulVf ?z_neq0 // -exprD -mulnDl subnK // exprM wn expr1n //.
transitivity ((\sum_(j | adj k j) (w ^+ ((n - m + q) * k) - w ^+ ((n - m + q) * j))) * z k).
  rewrite mulr_suml; apply: eq_bigr => j _; rewrite !mulnDl !exprD !zE; have := z_neq0 (m * k); set u := w ^+ (m * k) => u0.
  by have := z_neq0 (m * j); set v := w ^+ (m * j) => v0; field; rewrite u0 v0.
rewrite (eigenvector circulant prim) mulnDl exprD zE; have := z_neq0 (m * k); set u := w ^+ (m * k) => u0; by field.
Qed.
Notation cosine2 k j := (cosine k * cosine j + sine k * sine j).
Notation sine2 k j := (cosine k * sine j - sine k * cosine j).
Lemma cosine2E (k j : 'I_n) : cosine2 k j = (z j / z k + z k / z j) / 2%:R.
Proof.
have -> : cosine2 k j = (z k + (z k)^-1) * (z j + (z j)^-1) / 2%:R ^+ 2 + (z k - (z k)^-1) * (z j - (z j)^-1) / (2%:R ^+ 2 * im ^+ 2).
  by rewrite /cosine /sine; have := z_neq0 (m * k); set u := w ^+ (m * k) => u0; have := z_neq0 (m * j); set v := w ^+ (m * j) => v0;
     field; rewrite ?u0 ?v0 ?im_neq0 ?four ?two.
rewrite im2; have := z_neq0 (m * k); set u := w ^+ (m * k) => u0; have := z_neq0 (m * j); set v := w ^+ (m * j) => v0.
by field; rewrite ?oppr_eq0 ?u0 ?v0 ?four ?two.
Qed.
Lemma sine2E (k j : 'I_n) : sine2 k j = (z j / z k - z k / z j) / (2%:R * im).
Proof.
rewrite /cosine /sine; have := z_neq0 (m * k); set u := w ^+ (m * k) => u0; have := z_neq0 (m * j); set v := w ^+ (m * j) => v0.
by field; rewrite ?u0 ?v0 ?im_neq0 ?four ?two.
Qed.
Lemma sum_C q (k : 'I_n) : (q <= n)%N ->
  \sum_(j | adj k j) (w ^+ (q * k) - w ^+ (q * j) * cosine2 k j) = Cq q * w ^+ (q * k).
Proof.
move=> qn; rewrite /Cq mulrAC mulrDl -(sum_plus q k) -(sum_minus k qn) -big_split mulr_suml; apply: eq_bigr => j _ /=.
by rewrite cosine2E; move: (z j / z k) (z k / z j) => p r; field.
Qed.
Lemma sum_D q (k : 'I_n) : (q <= n)%N -> \sum_(j | adj k j) w ^+ (q * j) * sine2 k j = im * Dq q * w ^+ (q * k).
Proof.
move=> qn; transitivity (im / 2%:R * (lam (m + q) * w ^+ (q * k) - lam (m + (n - q)) * w ^+ (q * k))); last by rewrite /Dq; field.
rewrite -(sum_plus q k) -(sum_minus k qn) -sumrB mulr_sumr; apply: eq_bigr => j _ /=.
have -> : im / 2%:R = - (2%:R * im)^-1.
  by apply: (mulIf im_neq0); rewrite mulNr invfM -[X in - X]mulrA (mulVf im_neq0) mulrAC -expr2 im2 mulr1 mulN1r.
rewrite sine2E; move: (z j / z k) (z k / z j) => p r; move: ((2%:R * im)^-1) => h; ring.
Qed.
Lemma lam_mn : lam (m + n) = lam m.
Proof. by apply: eq_bigr => d _; rewrite mulnDl exprD [w ^+ (n * d)]exprM wn expr1n mulr1. Qed.
Lemma sum_1 (k : 'I_n) : \sum_(j | adj k j) (1 - cosine2 k j) = lam m.
Proof.
have := sum_C k (leq0n n); rewrite mul0n expr0 mulr1 /Cq addn0 subn0 => E.
have -> : lam m = (lam m + lam (m + n)) / 2%:R by rewrite lam_mn; field.
by rewrite -E; apply: eq_bigr => j _; rewrite mul1r.
Qed.

(* the Fourier mode q of the displacement a_k + i b_k of the centre c_k along e^(i theta_k), and of the phase, in x, y, theta *)
Definition frame k (i b : nat) : K :=
  match i, b with
  | 0, 0 => cosine k | 0, 1 => - sine k | 0, _ => cosine k / w0
  | 1, 0 => sine k | 1, 1 => cosine k | 1, _ => sine k / w0
  | _, 0 => 0 | _, 1 => 0 | _, _ => 1
  end.
Definition mode q b (k : 'I_n) i : K := w ^+ (q * k) * frame k i b.
Definition block q (i b : nat) : K :=
  match i, b with
  | 0, 0 => - (k0 * Cq q) | 0, 1 => w0 - im * k0 * Dq q | 0, _ => - (k1 * tq q) / w0
  | 1, 0 => - w0 | 1, _ => 0
  | _, 0 => w0 * k0 * Cq q | _, 1 => im * w0 * k0 * Dq q | _, _ => k1 * tq q
  end.
Notation derivative := (explicit adj w0 k0 k1 place_x place_y cosine sine).
Lemma mode_step q b (k : 'I_n) i : (q <= n)%N -> derivative (mode q b) k i =
  mode q 0 k i * block q 0 b + mode q 1 k i * block q 1 b + mode q 2%N k i * block q 2%N b.
Proof.
move=> qn; case: i => [|[|i]]; rewrite /explicit /mode /=.
- by case: b => [|[|b]] /=; field.
- by case: b => [|[|b]] /=; field.
set u := fun k : 'I_n => w ^+ (q * k).
have T1 : \sum_(j | adj k j) (u k - u j * cosine2 k j) = Cq q * u k by exact: sum_C.
have T2 : \sum_(j | adj k j) u j * sine2 k j = im * Dq q * u k by exact: sum_D.
have T3 : \sum_(j | adj k j) (1 - cosine2 k j) = lam m by exact: sum_1.
have cs : sine k ^+ 2 = 1 - cosine k ^+ 2 by rewrite -(circle k) addrC addKr.
rewrite -/(u k); under eq_bigr do rewrite -/(u _); under [X in _ + _ * X]eq_bigr do rewrite -/(u _).
case: b => [|[|b]] /=.
- rewrite big1 => [|j _]; last by ring.
  under eq_bigr => j _.
    have -> : cosine k * (u k * cosine k - u j * cosine j) - sine k * (u k * 0) * (place_x k - place_x j) +
      (sine k * (u k * sine k - u j * sine j) + cosine k * (u k * 0) * (place_y k - place_y j)) =
      u k * (cosine k ^+ 2 + sine k ^+ 2) - u j * cosine2 k j by ring.
    rewrite circle mulr1; over.
  by rewrite T1; ring.
- rewrite big1 => [|j _]; last by ring.
  under eq_bigr => j _.
    have -> : cosine k * (u k * - sine k - u j * - sine j) - sine k * (u k * 0) * (place_x k - place_x j) +
      (sine k * (u k * cosine k - u j * cosine j) + cosine k * (u k * 0) * (place_y k - place_y j)) =
      u j * sine2 k j by ring.
    over.
  by rewrite T2; ring.
under eq_bigr => j _.
  have -> : cosine k * (cosine k * (u k * 1) - cosine j * (u j * 1)) - sine k * (u k * 1) * (sine k - sine j) -
     (sine k * (- sine k * (u k * 1) + sine j * (u j * 1)) + cosine k * (u k * 1) * (cosine k - cosine j)) =
     (u k - u j * cosine2 k j) - u k * (1 - cosine2 k j) by ring.
  over.
rewrite sumrB T1 -mulr_sumr T3.
under eq_bigr => j _.
  have -> : cosine k * (u k * (cosine k / w0) - u j * (cosine j / w0)) - sine k * (u k * 1) * (place_x k - place_x j) +
      (sine k * (u k * (sine k / w0) - u j * (sine j / w0)) + cosine k * (u k * 1) * (place_y k - place_y j)) =
      ((u k - u j * cosine2 k j) - u k * (1 - cosine2 k j)) / w0.
    by rewrite /place_x /place_y; field: cs.
  over.
rewrite -mulr_suml sumrB T1 -mulr_sumr T3 /tq.
by field.
Qed.

Definition frame_inv (k : 'I_n) (b i : nat) : K :=
  match b, i with
  | 0, 0 => cosine k | 0, 1 => sine k | 0, _ => - w0^-1
  | 1, 0 => - sine k | 1, 1 => cosine k | 1, _ => 0
  | _, 0 => 0 | _, 1 => 0 | _, _ => 1
  end.
Lemma frameK k a b : (a < 3)%N -> (b < 3)%N ->
  frame_inv k a 0 * frame k 0 b + frame_inv k a 1 * frame k 1 b + frame_inv k a 2%N * frame k 2%N b = (a == b)%:R.
Proof.
have cs : sine k ^+ 2 = 1 - cosine k ^+ 2 by rewrite -(circle k) addrC addKr.
by case: a => [|[|[|a]]] //; case: b => [|[|[|b]]] //= _ _; field: cs.
Qed.
Lemma roots_sum (p q : 'I_n) : \sum_(k < n) (w ^+ (p * k))^-1 * w ^+ (q * k) = n%:R * (p == q)%:R.
Proof.
case: eqP => [->|pq]; first by rewrite mulr1 (eq_bigr (fun _ => 1)) ?sumr_const ?card_ord // => k _; rewrite mulVf // z_neq0.
rewrite mulr0; pose x := (w ^+ p)^-1 * w ^+ q.
have x1 : x != 1.
  apply/negP=> /eqP E; apply: pq; apply: val_inj; apply/eqP.
  have : w ^+ q == w ^+ p by rewrite -[X in _ == X]mulr1 -E /x mulrA mulfV ?mul1r ?z_neq0.
  by rewrite (eq_prim_root_expr prim) eq_sym /= !modn_small.
have xn : x ^+ n = 1 by rewrite /x exprMn exprVn -!exprM !(mulnC _ n) !exprM wn !expr1n invr1 mulr1.
apply: (mulfI (_ : x - 1 != 0)); first by rewrite subr_eq0.
have := subrX1 x n; rewrite xn subrr mulr0 => E; rewrite [RHS]E; congr (_ * _); apply: eq_bigr => k _.
by rewrite /x exprMn exprVn -!exprM.
Qed.

Definition Fourier : 'M[K]_(n * 3) := \matrix_(i, j) mode (part j) (j %% 3)%N (part i) (i %% 3)%N.
Definition Fourier_inv : 'M[K]_(n * 3) :=
  \matrix_(i, j) (n%:R^-1 * (w ^+ (part i * part j))^-1 * frame_inv (part j) (i %% 3)%N (j %% 3)%N).
Definition blocks : 'M[K]_(n * 3) :=
  \matrix_(i, j) if (i %/ 3 == j %/ 3)%N then block (i %/ 3) (i %% 3)%N (j %% 3)%N else 0.
Lemma same_triple (i j : 'I_(n * 3)) : (i == j) = (part i == part j) && (i %% 3 == j %% 3)%N.
Proof.
apply/eqP/andP=> [->//|[/eqP A /eqP B]]; apply: val_inj; rewrite /= (divn_eq i 3) (divn_eq j 3) B.
by move/(congr1 val): A => /= ->.
Qed.
Lemma FourierK : Fourier_inv *m Fourier = 1%:M.
Proof.
apply/matrixP=> i j; rewrite !mxE.
transitivity (\sum_(l < n * 3) (fun (k : 'I_n) a => n%:R^-1 * ((w ^+ (part i * k))^-1 * w ^+ (part j * k)) *
  (frame_inv k (i %% 3)%N a * frame k a (j %% 3)%N)) (part l) (l %% 3)%N).
  by apply: eq_bigr => l _; rewrite !mxE /mode; ring.
rewrite (sum_triples (fun (k : 'I_n) a => n%:R^-1 * ((w ^+ (part i * k))^-1 * w ^+ (part j * k)) * (frame_inv k (i %% 3)%N a * frame k a (j %% 3)%N))).
under eq_bigr do rewrite -!mulrDr frameK ?ltn_pmod //.
rewrite -mulr_suml -mulr_sumr roots_sum mulrA mulVf // mul1r same_triple.
by case: (part i == part j); rewrite ?mul1r ?mul0r.
Qed.

(* the matrix of first-order coefficients at the formation *)
Definition jacobian : 'M[K]_(n * 3) :=
  \matrix_(i, j) first_order adj w0 k0 k1 place_x place_y cosine sine (@unit_at K n (part j) (j %% 3)%N) (part i) (i %% 3)%N.
Lemma jacobian_mul (d : 'I_n -> nat -> K) (i : 'I_(n * 3)) :
  \sum_j jacobian i j * d (part j) (j %% 3)%N = first_order adj w0 k0 k1 place_x place_y cosine sine d (part i) (i %% 3)%N.
Proof.
rewrite first_orderE (@explicit_sum _ _ _ _ _ _ _ _ _ _ _ (fun j : 'I_(n * 3) => d (part j) (j %% 3)%N)
  (fun j : 'I_(n * 3) => @unit_at K n (part j) (j %% 3)%N)).
  by apply: eq_bigr => j _; rewrite mxE first_orderE mulrC.
move=> l b b3; rewrite /unit_at (sum_triples (fun k a => d k a * ((l == k) && (b == a))%:R)) (bigD1 l) //= eqxx /=.
rewrite big1 => [|k /negPf kl]; last by rewrite eq_sym kl !mulr0 !addr0.
by move: b b3 => [|[|[|b]]] //= _; rewrite ?mulr0 ?mulr1 ?addr0 ?add0r.
Qed.
Lemma jacobian_Fourier : jacobian *m Fourier = Fourier *m blocks.
Proof.
apply/matrixP=> i j; rewrite !mxE.
under eq_bigr do rewrite [Fourier _ _]mxE.
rewrite (jacobian_mul (mode (part j) (j %% 3)%N)) first_orderE mode_step ?(ltnW (ltn_ord _)) //.
transitivity (\sum_(l < n * 3) (fun (k : 'I_n) a => mode k a (part i) (i %% 3)%N * (if k == part j then block k a (j %% 3)%N else 0)) (part l) (l %% 3)%N).
  rewrite (sum_triples (fun (k : 'I_n) a => mode k a (part i) (i %% 3)%N * (if k == part j then block k a (j %% 3)%N else 0))).
  rewrite (bigD1 (part j)) //= eqxx big1 ?addr0 // => k /negPf ->.
  by rewrite !mulr0 !addr0.
by apply: eq_bigr => l _; rewrite !mxE.
Qed.
Lemma char_block q : char_poly (\matrix_(i < 3, j < 3) block q i j) = cubic q.
Proof.
transitivity (\det (\matrix_(i < 3, j < 3) ('X *+ (i == j :> nat) - (block q i j)%:P))).
  by congr (\det _); apply/matrixP=> i j; rewrite !mxE.
rewrite (det3 (fun i j => 'X *+ (i == j) - (block q i j)%:P)) /= mulr0n mulr1n !sub0r /cubic.
rewrite !(polyCB, polyCD, polyCN, polyCM, polyC_exp).
have E : (w0^-1)%:P * w0%:P = 1 :> {poly K} by rewrite -polyCM mulVf.
have I : im%:P ^+ 2 = -1 :> {poly K} by rewrite -polyC_exp im2 polyCN.
ring: E I.
Qed.
(* the formation is at rest in the turning frame *)
Theorem formation_rests (k : 'I_n) i : rate adj w0 k0 k1 place_x place_y cosine sine k i = 0.
Proof.
case: i => [|[|i]]; rewrite /rate /place_x /place_y; [by field|by field|rewrite /steering].
have T : \sum_(j | adj k j) sine2 k j = 0.
  have := sum_D k (leq0n n); rewrite /Dq addn0 subn0 lam_mn subrr mul0r mulr0 mul0r => E.
  by rewrite -[RHS]E; apply: eq_bigr => j _; rewrite mul0n expr0 mul1r.
transitivity (w0 + (k1 - k0) * 0 + w0 * k0 * 0 - w0); last by ring.
congr (_ + _ * _ + _ * _ - _).
  by transitivity (\sum_(j | adj k j) -1 * sine2 k j); [apply: eq_bigr => j _; ring | rewrite -mulr_sumr T mulr0].
transitivity (\sum_(j | adj k j) - w0^-1 * sine2 k j); last by rewrite -mulr_sumr T mulr0.
by apply: eq_bigr => j _; ring.
Qed.
Theorem circulant_spectrum : char_poly jacobian = \prod_(q < n) cubic q.
Proof.
rewrite (char_similar FourierK jacobian_Fourier) char_triples; apply: eq_bigr => q _; exact: char_block.
Qed.
End Spectrum.
