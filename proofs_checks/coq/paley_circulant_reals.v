(* Paley et al., circular formations on circulant graphs: the spectrum of paley_circulant.v for the real law of paley_turning.v.
     beyond.paley.circulant_spectrum (clause 1).
   The 3N x 3N matrix of the derivatives of (22) in the turning frame at theta_k = 2 pi m k/N has at every complex z the determinant
   det(z - A) = prod_q p_q(z), lambda_q the eigenvalues of the Laplacian on the Fourier columns (`circulant_eigenvector`).  w0, K_0, K_1, z
   and e^(2 pi i/N) lie in a subfield (paley_subfield.v) over which the theorem about any field holds.  Hypotheses: N >= 1, an undirected
   circulant graph, connected or not, 0 <= m <= N, w0 <> 0. *)
Set Warnings "-notation-overridden,-ambiguous-paths".
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import ring zify.
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums paley_model paley_phase paley_laplacian paley_gradient paley_fourier paley_particles.
From Flockproof Require Import paley_turning paley_subfield paley_circulant.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Import GRing.Theory.
Delimit Scope nat_scope with N.
Delimit Scope ring_scope with F.

Section Values.
Variable p : nat -> C.
Notation F := (subfield_fieldType p).
Implicit Types x y : F.
Notation phi := (@phi p).
Lemma phiD x y : phi (x + y)%F = (phi x + phi y)%C. Proof. exact: phi_add. Qed.
Lemma phiM x y : phi (x * y)%F = (phi x * phi y)%C. Proof. exact: phi_mul. Qed.
Lemma phiN x : phi (- x)%F = (- phi x)%C. Proof. exact: phi_opp. Qed.
Lemma phiB x y : phi (x - y)%F = (phi x - phi y)%C. Proof. by rewrite phiD phiN. Qed.
Lemma phiV x : phi (x^-1)%F = (/ phi x)%C. Proof. exact: phi_inv. Qed.
Lemma phi0 : phi 0%F = RtoC 0. Proof. exact: phi_0. Qed.
Lemma phi1 : phi 1%F = RtoC 1. Proof. exact: phi_1. Qed.
Lemma phi_nat k : phi (k%:R)%F = RtoC (INR k).
Proof. elim: k => [|k IH]; first by rewrite phi0. by rewrite mulrS phiD phi1 IH S_INR /RtoC /Cplus /=; congr pair; ring. Qed.
Lemma phi_sum n (P : pred nat) (f : 'I_n -> F) (g : nat -> C) : (forall j : 'I_n, phi (f j) = g j) ->
  phi (\sum_(j < n | P j) f j)%F = Csum n (fun j => RtoC (if P j then 1 else 0) * g j)%C.
Proof.
elim: n f => [|n IH] f H; first by rewrite big_ord0 phi0.
rewrite Csum_S big_mkcond big_ord_recr -big_mkcond /= phiD IH => [|j]; last exact: (H (widen_ord (leqnSn n) j)).
congr Cplus; case: (P n); first by rewrite (H ord_max) Cmult_1_l.
by rewrite phi0 Cmult_0_l.
Qed.
Lemma phi_prod n (f : nat -> F) : phi (\prod_(q < n) f q)%F = Cprod n (fun q => phi (f q)).
Proof. by elim: n => [|n IH]; rewrite ?big_ord0 ?phi1 // big_ord_recr /= phiM IH. Qed.
Lemma phi_sign j : phi ((-1) ^+ j)%F = RtoC ((-1) ^ j).
Proof.
elim: j => [|j IH]; first by rewrite expr0 phi1.
by rewrite exprS phiM IH phiN phi1 /RtoC /Cmult /=; congr pair; ring.
Qed.
Lemma phi_det n (M : 'M[F]_n) (A : nat -> nat -> C) : (forall i j : 'I_n, phi (M i j) = A i j) -> phi (\det M)%F = Cdet n A.
Proof.
elim: n M A => [|n IH] M A H; first by rewrite det_mx00 phi1.
rewrite (expand_det_row M 0%F) -[Cdet _ _]/(Csum n.+1 _).
pose g j := (RtoC ((-1) ^ j) * (A 0%N j * Cdet n (fun a b => A a.+1 (if Nat.leb j b then b.+1 else b))))%C.
apply: etrans (phi_sum xpredT (g := g) _) _; last by apply: Csum_ext => j _; rewrite Cmult_1_l.
move=> j; rewrite phiM /cofactor phiM phi_sign add0n (IH _ (fun a b => A a.+1 (if Nat.leb j b then b.+1 else b))).
  by rewrite H Cmult_assoc [X in (X * _)%C]Cmult_comm -Cmult_assoc.
move=> a b; rewrite !mxE H /= /bump /=; congr A.
by case: (Nat.leb_spec j b) => h; [rewrite (_ : (j <= b)%N) | rewrite (_ : (j <= b)%N = false)] => //; lia.
Qed.

(* real values *)
Lemma rD x y a b : phi x = RtoC a -> phi y = RtoC b -> phi (x + y)%F = RtoC (a + b).
Proof. by move=> h1 h2; rewrite phiD h1 h2 /RtoC /Cplus /=; congr pair; ring. Qed.
Lemma rM x y a b : phi x = RtoC a -> phi y = RtoC b -> phi (x * y)%F = RtoC (a * b).
Proof. by move=> h1 h2; rewrite phiM h1 h2 /RtoC /Cmult /=; congr pair; ring. Qed.
Lemma rN x a : phi x = RtoC a -> phi (- x)%F = RtoC (- a).
Proof. by move=> h1; rewrite phiN h1 /RtoC /Copp /=; congr pair; ring. Qed.
Lemma rB x y a b : phi x = RtoC a -> phi y = RtoC b -> phi (x - y)%F = RtoC (a - b).
Proof. by move=> h1 h2; apply: rD => //; apply: rN. Qed.
Lemma rV x a : phi x = RtoC a -> phi (x^-1)%F = RtoC (/ a).
Proof. 
move=> h1; rewrite phiV h1 /RtoC /Cinv /=; have [->|a0] := Req_dec a 0; first by rewrite Rinv_0; congr pair; rewrite /Rdiv; ring.
by congr pair; field.
Qed.
Lemma rS n (P : pred nat) (f : 'I_n -> F) (g : nat -> R) : (forall j : 'I_n, phi (f j) = RtoC (g j)) ->
  phi (\sum_(j < n | P j) f j)%F = RtoC (Sum n (fun j => (if P j then 1 else 0) * g j)%R).
Proof.
move=> H; rewrite (phi_sum P (g := fun j => RtoC (g j)) H); rewrite /Csum /RtoC; congr pair.
  by apply: Sum_ext => j _ /=; ring.
by apply: Sum_zero => j _ /=; ring.
Qed.
End Values.

Lemma modE a b : (0 < b)%N -> Nat.modulo a b = (a %% b)%N.
Proof. by move=> b0; symmetry; apply: (Nat.mod_unique a b (a %/ b)); [have := ltn_pmod a b0 | have := divn_eq a b]; lia. Qed.
Lemma divE a b : (0 < b)%N -> Nat.div a b = (a %/ b)%N.
Proof. by move=> b0; symmetry; apply: (Nat.div_unique a b _ (a %% b)); [have := ltn_pmod a b0 | have := divn_eq a b]; lia. Qed.

Lemma Cprod_ext l f g : (forall q, f q = g q) -> Cprod l f = Cprod l g.
Proof. by move=> E; elim: l => //= l ->; rewrite E. Qed.

Section Spectrum.
Variables (n : nat) (adj : graph) (s : nat -> bool) (m : nat) (w0 K0 K1 : R).
Hypotheses (Hn : (0 < n)%N) (Hc : paley_fourier.circulant n adj s) (Hu : paley_model.undirected adj) (Hm : (m <= n)%N) (Hw : w0 <> 0%R).
Variable z : C.
Let p (i : nat) : C := match i with 0 => expi (2 * PI / INR n) | 1 => Ci | 2 => RtoC w0 | 3 => RtoC (K0 / INR n) | 4 => RtoC (K1 / INR n) | _ => z end.
Notation F := (subfield_fieldType p).
Notation phi := (@phi p).
Let w : F := given p 0. Let im : F := given p 1. Let fw0 : F := given p 2. Let k0 : F := given p 3. Let k1 : F := given p 4. Let fz : F := given p 5.
Let adjF : rel 'I_n := fun k j => adj k j.
Let n_pos : (0 < INR n)%R. Proof. by apply: INR_pos; lia. Qed.

Lemma phi_w k : phi (w ^+ k)%F = expi (INR k * (2 * PI / INR n)).
Proof.
elim: k => [|k IH]; first by rewrite expr0 phi1 Rmult_0_l expi_0.
by rewrite S_INR Rmult_plus_distr_r Rmult_1_l expi_plus exprS phiM IH phi_given Cmult_comm.
Qed.
Lemma phi_wave q k : phi (w ^+ (q * k))%F = expi (wave n q k).
Proof. rewrite phi_w mult_INR; congr expi; rewrite /wave; field; lra. Qed.
Lemma real_prim : (n.-primitive_root w)%F.
Proof.
apply/andP; split=> //; apply/forallP=> i; rewrite unity_rootE; apply/eqP; apply/eqP/eqP => [E|->].
- have := congr1 phi E; rewrite phi_w phi1 => /expi_one[q Hq].
  have h : IZR (Z.of_nat i.+1) = IZR (q * Z.of_nat n).
    rewrite mult_IZR -!INR_IZR_INZ; apply: (Rmult_eq_reg_l (2 * PI / INR n)).
      by rewrite Rmult_comm Hq; field; lra.
    by apply: Rgt_not_eq; apply: Rdiv_lt_0_compat => //; have := PI_RGT_0; lra.
  have E2 := eq_IZR _ _ h; move: (ltn_ord i) => li.
  have : (q = 1)%Z by nia.
  by move=> q1; rewrite q1 in E2; lia.
apply: phi_inj; rewrite phi_w phi1 -(expi_2PI 1); congr expi; field; lra.
Qed.
Lemma real_im : (im ^+ 2 = -1)%F.
Proof. by apply: phi_inj; rewrite expr2 phiM phiN phi1 phi_given /= /Ci /RtoC /Cmult /Copp /=; congr pair; ring. Qed.
Lemma real_nat k : (0 < k)%N -> (k%:R != 0 :> F)%F.
Proof. by move=> k_gt; apply/eqP=> /(congr1 phi); rewrite phi_nat phi0 => - []; apply: not_0_INR; lia. Qed.
Lemma real_w0 : (fw0 != 0)%F.
Proof. by apply/eqP=> /(congr1 phi); rewrite phi0 phi_given /= => - []. Qed.
Lemma real_circulant (k j : 'I_n) : adjF k j = s ((j + n - k) %% n)%N.
Proof.
have := ltn_ord k; have := ltn_ord j => hj hk; rewrite /adjF Hc -?modE //; by [apply/ltP | lia].
Qed.
Lemma real_symmetric : symmetric adjF. Proof. by move=> k j; apply: Hu. Qed.

Lemma real_eigenvalue q : phi (eigenvalue n s w q) = paley_fourier.circulant_eigenvalue n s q.
Proof.
apply: etrans (phi_sum s (g := fun d => (RtoC 1 - expi (wave n q d))%C) _) _ => // d.
by rewrite phiB phi1 phi_wave.
Qed.
Lemma expi_inv a : (/ expi a)%C = expi (- a).
Proof.
rewrite /expi /Cinv /= cos_neg sin_neg !Rmult_1_r; have := sc2 a => E.
have -> : (cos a * cos a + sin a * sin a = 1)%R by rewrite -E; ring.
by congr pair; field.
Qed.
Lemma real_cosine (k : 'I_n) : phi (cosine w m k) = RtoC (cos (wave n m k)).
Proof.
rewrite /cosine phiM phiV phi_nat phiD phiV phi_wave expi_inv /expi /RtoC /Cmult /Cplus /Cinv /= cos_neg sin_neg.
by congr pair; field.
Qed.
Lemma real_sine (k : 'I_n) : phi (sine w im m k) = RtoC (sin (wave n m k)).
Proof.
rewrite /sine phiM phiV phiM phi_nat phiB phiV phi_wave expi_inv phi_given /expi /RtoC /Ci /Cmult /Cminus /Cplus /Copp /Cinv /= cos_neg sin_neg.
by congr pair; field.
Qed.
Lemma real_place_x (k : 'I_n) : phi (place_x w im m fw0 k) = RtoC (fst (rest_place w0 (wave n m) k)).
Proof.
rewrite /place_x /= Rmult_comm; apply: rM; first exact: real_sine.
by apply: rV; rewrite phi_given.
Qed.
Lemma real_place_y (k : 'I_n) : phi (place_y w m fw0 k) = RtoC (snd (rest_place w0 (wave n m) k)).
Proof.
rewrite /place_y /= (_ : (- / w0 * cos (wave n m k) = - cos (wave n m k) * / w0)%R); last by ring.
apply: rM; first by apply: rN; exact: real_cosine.
by apply: rV; rewrite phi_given.
Qed.
Lemma real_entry (i j : 'I_(n * 3)) : phi (jacobian adjF w im m fw0 k0 k1 i j) = RtoC (turning_matrix n adj w0 K0 K1 m i j).
Proof.
rewrite mxE first_orderE /turning_matrix divE // modE // -[(i %/ 3)%N]/(val (part i)).
have hu (k : 'I_n) a : (a < 3)%N -> phi (unit_at F (part j) (j %% 3)%N k a) = RtoC (along j k a).
  move=> a3; rewrite /unit_at /along phi_nat; congr RtoC.
  have := divn_eq j 3; have := ltn_pmod j (isT : (0 < 3)%N) => h1 h2.
  case: (Nat.eqb_spec (3 * k + a) j) => E; case: eqP => [kE|kE] /=.
  - by rewrite (_ : a == (j %% 3)%N) //; apply/eqP; move: E; rewrite kE /=; lia.
  - by case: kE; apply: val_inj => /=; lia.
  - by rewrite (_ : (a == (j %% 3)%N) = false) //; apply/eqP => aE; apply: E; rewrite kE aE /=; lia.
  by [].
have hk0 : phi k0 = RtoC (K0 / INR n) by rewrite phi_given.
have hk1 : phi k1 = RtoC (K1 / INR n) by rewrite phi_given.
have hw0 : phi fw0 = RtoC w0 by rewrite phi_given.
have hc := real_cosine; have hs := real_sine; have hx := real_place_x; have hy := real_place_y.
move: (part i) => k; case: (i %% 3)%N => [|[|a]]; rewrite /explicit /turning_derivative.
- apply: rD; apply: rM; [by apply: rN; exact: hs | exact: hu | exact: hw0 | exact: hu].
- apply: rB; apply: rM; [exact: hc | exact: hu | exact: hw0 | exact: hu].
have hu0 l : phi (unit_at F (part j) (j %% 3)%N l 0%N) = RtoC (along j l 0) by exact: hu.
have hu1 l : phi (unit_at F (part j) (j %% 3)%N l 1%N) = RtoC (along j l 1) by exact: hu.
have hu2 l : phi (unit_at F (part j) (j %% 3)%N l 2%N) = RtoC (along j l 2) by exact: hu.
apply: rD; apply: rM; [exact: rB | | exact: rM | ]; apply: (rS (adj k)) => l.
  apply: rB.
    apply: rB; first by apply: rM; [exact: hc | apply: rB; apply: rM; first [exact: hc | exact: hu2]].
    by apply: rM; [apply: rM; [exact: hs | exact: hu2] | apply: rB; exact: hs].
  apply: rD; last by apply: rM; [apply: rM; [exact: hc | exact: hu2] | apply: rB; exact: hc].
  apply: rM; first exact: hs.
  by apply: rD; apply: rM; first [exact: hs | exact: hu2 | apply: rN; exact: hs].
apply: rD.
  apply: rB; first by apply: rM; [exact: hc | apply: rB; exact: hu0].
  by apply: rM; [apply: rM; [exact: hs | exact: hu2] | apply: rB; exact: hx].
apply: rD; first by apply: rM; [exact: hs | apply: rB; exact: hu1].
by apply: rM; [apply: rM; [exact: hc | exact: hu2] | apply: rB; exact: hy].
Qed.
Lemma char_poly_at N (M : 'M[F]_N) x : ((char_poly M).[x] = \det (\matrix_(i, j) ((i == j)%:R * x - M i j)))%F.
Proof.
rewrite /char_poly -horner_evalE -det_map_mx; congr (\det _)%F; apply/matrixP=> i j; rewrite !mxE /= horner_evalE.
by rewrite hornerD hornerN hornerC hornerMn hornerX mulr_natl.
Qed.
Theorem circulant_spectrum_at :
  Cdet (3 * n) (fun i j => RtoC (delta i j) * z - RtoC (turning_matrix n adj w0 K0 K1 m i j))%C = Cprod n (cubic_value n s m w0 K0 K1 z).
Proof.
have T := circulant_spectrum real_circulant real_symmetric real_prim real_im (real_nat (isT : (0 < 2)%N)) (real_nat Hn) k0 k1 Hm real_w0.
have := congr1 (fun P => phi P.[fz]%F) T; rewrite /= char_poly_at horner_prod.
rewrite (phi_det (A := fun i j => (RtoC (delta i j) * z - RtoC (turning_matrix n adj w0 K0 K1 m i j))%C)) => [E|i j]; last first.
  rewrite mxE phiB phiM real_entry phi_nat phi_given /=; congr (_ * _ - _)%C; rewrite /delta -val_eqE /=.
  by case: (Nat.eqb_spec i j) => h; case: eqP.
rewrite mulnC E (phi_prod n (fun q => (cubic n s w im m fw0 k0 k1 q).[fz]%F)).
have C2 : phi (2%:R)%F = RtoC 2 by rewrite phi_nat.
have cubicE q : phi (cubic n s w im m fw0 k0 k1 q).[fz]%F = cubic_value n s m w0 K0 K1 z q.
  rewrite /cubic /tq /Cq /Dq !(hornerD, hornerN, hornerM, hornerC, hornerX, hornerXn).
  rewrite !(exprS, expr0, mulr1) !(phiD, phiB, phiM, phiN, phiV, real_eigenvalue, phi_given, C2).
  rewrite /cubic_value !plusE !minusE (RtoC_mult w0 w0) phi1 (_ : (RtoC 1 + RtoC 1)%C = RtoC 2) -?RtoC_plus //.
  rewrite -[p 1]/Ci -[p 2]/(RtoC w0) -[p 3]/(RtoC (K0 / INR n)) -[p 4]/(RtoC (K1 / INR n)) -[p 5]/z /Cdiv /Cminus.
  move: (paley_fourier.circulant_eigenvalue n s (m + q)) (paley_fourier.circulant_eigenvalue n s (m + (n - q))) => a b.
  by move: (paley_fourier.circulant_eigenvalue n s m) (/ RtoC 2)%C (RtoC (K0 / INR n)) (RtoC (K1 / INR n)) (RtoC w0) Ci => c h f0 f1 v i; ring.
exact: Cprod_ext cubicE.
Qed.
End Spectrum.

(* the entries are the derivatives of the rates in the turning frame at the formation; the characteristic polynomial at every complex z *)
Theorem circulant_spectrum_reals (n : nat) (adj : graph) (s : nat -> bool) (m : nat) (w0 K0 K1 : R) :
  (0 < n)%N -> paley_fourier.circulant n adj s -> paley_model.undirected adj -> (m <= n)%N -> w0 <> 0%R ->
  (forall i j, (i < 3 * n)%N -> is_derive (fun h => turning_rate n adj w0 K0 K1 (r_along w0 (wave n m) (along j)) (th_along (wave n m) (along j)) h i)
     0%R (turning_matrix n adj w0 K0 K1 m i j)) /\
  (forall z, Cdet (3 * n) (fun i j => RtoC (delta i j) * z - RtoC (turning_matrix n adj w0 K0 K1 m i j))%C
     = Cprod n (cubic_value n s m w0 K0 K1 z)).
Proof.
move=> Hn Hc Hu Hm Hw; split=> [i j Hi|z]; last exact: circulant_spectrum_at.
by apply: D_turning_rate => //; apply/ltP.
Qed.
