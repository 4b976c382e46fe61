(* The main resonance of a two-sided platoon by integers (Veerman, Stosic, Olvera, section 4).
   With z = f + i w g = z'/d the numbers t_k = z'^k a_(M-k)/a_M obey t_0 = 1, t_1 = z' + d w^2,
   t_(k+1) = 2 (z' + d w^2) t_k - z'^2 t_(k-1): polynomials in s = w^2, apart from a factor i w of the imaginary part. So
   |a_M|^2 = |z'|^(2 M)/|t_M|^2, and A^2 - |a_M|^2 has the sign of a polynomial in s with integer coefficients.
   A polynomial is positive on y >= 0 if its coefficients are; if not, y >= 1 and y <= 1 are looked at apart (y = 1 + u, 1/y = 1 + u). *)
From Coq Require Import Reals Qreals ZArith QArith List Bool Lia Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import veerman_complex veerman_front veerman_chain veerman_stability.
Import ListNotations.
Open Scope R_scope.

(* ---- integer polynomials, the constant coefficient first ---- *)
Fixpoint ev (p : list Z) (x : R) : R := match p with [] => 0 | c :: p => IZR c + x * ev p x end.
Fixpoint padd (p q : list Z) : list Z :=
  match p, q with [], _ => q | _, [] => p | a :: p, b :: q => (a + b)%Z :: padd p q end.
Definition pscal (c : Z) (p : list Z) : list Z := map (Z.mul c) p.
Fixpoint pmul (p q : list Z) : list Z := match p with [] => [] | a :: p => padd (pscal a q) (0%Z :: pmul p q) end.
(* (a + b x) p(x) *)
Definition lin (a b : Z) (p : list Z) : list Z := padd (pscal a p) (0%Z :: pscal b p).
(* p(x + a), p(a x) *)
Fixpoint shift (a : Z) (p : list Z) : list Z := match p with [] => [] | c :: p => padd [c] (lin a 1 (shift a p)) end.
Fixpoint grow (a : Z) (p : list Z) : list Z := match p with [] => [] | c :: p => c :: pscal a (grow a p) end.
(* c^(length p - 1) p(x/c) *)
Definition shrink (c : Z) (p : list Z) : list Z := rev (grow c (rev p)).

Lemma ev_add p : forall q x, ev (padd p q) x = ev p x + ev q x.
Proof. induction p as [|a p IH]; intros [|b q] x; cbn [padd ev]; try ring. rewrite plus_IZR, IH. ring. Qed.
Lemma ev_scal c p x : ev (pscal c p) x = IZR c * ev p x.
Proof. induction p as [|a p IH]; cbn [pscal map ev]; [ring|]. change (map (Z.mul c) p) with (pscal c p). rewrite mult_IZR, IH. ring. Qed.
Lemma ev_mul p q x : ev (pmul p q) x = ev p x * ev q x.
Proof. induction p as [|a p IH]; cbn [pmul ev]; [ring|]. rewrite ev_add, ev_scal. cbn [ev]. rewrite IH. ring. Qed.
Lemma ev_lin a b p x : ev (lin a b p) x = (IZR a + IZR b * x) * ev p x.
Proof. unfold lin. rewrite ev_add. cbn [ev]. rewrite !ev_scal. ring. Qed.
Lemma ev_shift a p x : ev (shift a p) x = ev p (IZR a + x).
Proof. induction p as [|c p IH]; cbn [shift ev]; [reflexivity|]. rewrite ev_add, ev_lin. cbn [ev]. rewrite IH. ring. Qed.
Lemma ev_grow a p x : ev (grow a p) x = ev p (IZR a * x).
Proof.
  revert x. induction p as [|c p IH]; intros x; cbn [grow ev]; [reflexivity|]. rewrite ev_scal, IH. ring.
Qed.
Lemma ev_app p q x : ev (p ++ q) x = ev p x + x ^ length p * ev q x.
Proof. induction p as [|a p IH]; cbn [app ev length pow]; [ring|]. rewrite IH. ring. Qed.
Lemma ev_rev p x : x <> 0 -> x * ev (rev p) x = x ^ length p * ev p (/ x).
Proof.
  intros H. induction p as [|c p IH]; cbn [rev ev length pow]; [ring|].
  rewrite ev_app, rev_length, Rmult_plus_distr_l, IH. cbn [ev]. field. exact H.
Qed.
Lemma grow_length a p : length (grow a p) = length p.
Proof. induction p as [|c p IH]; cbn [grow length]; [reflexivity|]. unfold pscal. now rewrite map_length, IH. Qed.
(* the signs are kept *)
Lemma rev_pos p x : 0 < x -> 0 < ev (rev p) (/ x) -> 0 < ev p x.
Proof.
  intros H P. pose proof (Rinv_0_lt_compat x H) as I. pose proof (ev_rev p (/ x) ltac:(lra)) as E. rewrite Rinv_inv in E.
  assert (0 < (/ x) ^ length p * ev p x) by (rewrite <- E; now apply Rmult_lt_0_compat).
  assert (Q : 0 < (/ x) ^ length p) by now apply pow_lt. apply (Rmult_lt_reg_l _ _ _ Q). now rewrite Rmult_0_r.
Qed.
Lemma shrink_ev c p x : 0 < IZR c -> 0 < x -> exists k, 0 < k /\ ev (shrink c p) x = k * ev p (x / IZR c).
Proof.
  intros C H. unfold shrink. pose proof (Rinv_0_lt_compat x H) as I.
  pose proof (ev_rev (grow c (rev p)) x ltac:(lra)) as E. rewrite ev_grow, grow_length, rev_length in E.
  assert (J : 0 < IZR c * / x) by now apply Rmult_lt_0_compat.
  pose proof (ev_rev p (IZR c * / x) ltac:(lra)) as E2. replace (/ (IZR c * / x)) with (x / IZR c) in E2 by (field; lra).
  exists (x ^ length p * (IZR c * / x) ^ length p / (IZR c * / x) / x). split.
  - repeat apply Rdiv_lt_0_compat; try assumption. apply Rmult_lt_0_compat; now apply pow_lt.
  - apply (Rmult_eq_reg_l x); [|lra]. rewrite E. apply (Rmult_eq_reg_l (IZR c * / x)); [|lra].
    replace (IZR c * / x * (x ^ length p * ev (rev p) (IZR c * / x))) with (x ^ length p * ((IZR c * / x) * ev (rev p) (IZR c * / x))) by ring.
    rewrite E2. field. lra.
Qed.

(* positive for all y >= 0; no eager && or ||, so that nothing is computed in vain *)
Fixpoint pos (fuel : nat) (p : list Z) : bool :=
  match p with
  | [] => false
  | c :: _ => if Z.ltb 0 c then
      if forallb (Z.leb 0) p then true
      else match fuel with
        | O => false
        | S k => if pos k (shift 1 p) then pos k (shift 1 (rev p)) else false
        end
      else false
  end.
Lemma ev_nonneg p x : forallb (Z.leb 0) p = true -> 0 <= x -> 0 <= ev p x.
Proof.
  intros H X. induction p as [|c p IH]; cbn [ev]; [lra|]. cbn [forallb] in H. apply andb_prop in H as [C H].
  apply Z.leb_le in C. apply IZR_le in C. specialize (IH H). assert (0 <= x * ev p x) by now apply Rmult_le_pos. lra.
Qed.
Lemma pos_true fuel : forall p, pos fuel p = true -> forall y, 0 <= y -> 0 < ev p y.
Proof.
  induction fuel as [|k IH]; intros [|c p] H y Y; cbn [pos] in H; try discriminate;
    destruct (Z.ltb 0 c) eqn:C; try discriminate; apply Z.ltb_lt in C; pose proof (IZR_lt _ _ C) as C1;
    destruct (forallb (Z.leb 0) (c :: p)) eqn:A; try discriminate.
  1, 2: cbn [forallb] in A; apply andb_prop in A as [_ A]; pose proof (ev_nonneg p y A Y); cbn [ev];
    assert (0 <= y * ev p y) by (now apply Rmult_le_pos); lra.
  destruct (pos k (shift 1 (c :: p))) eqn:S; [|discriminate].
  destruct (Rle_lt_dec 1 y) as [L|L].
  - pose proof (IH _ S (y - 1) ltac:(lra)) as P. rewrite ev_shift in P. replace (IZR 1 + (y - 1)) with y in P by ring. exact P.
  - destruct Y as [Y|Y]; [|rewrite <- Y; cbn [ev]; lra]. apply rev_pos; [exact Y|].
    assert (I : 1 <= / y) by (rewrite <- Rinv_1; apply Rinv_le_contravar; lra).
    pose proof (IH _ H (/ y - 1) ltac:(lra)) as P. rewrite ev_shift in P. replace (IZR 1 + (/ y - 1)) with (/ y) in P by ring. exact P.
Qed.
(* for all x in (0, 1], for all x >= 1 *)
Lemma pos_below fuel p : pos fuel (shift 1 (rev p)) = true -> forall x, 0 < x <= 1 -> 0 < ev p x.
Proof.
  intros H x X. apply rev_pos; [lra|]. assert (I : 1 <= / x) by (rewrite <- Rinv_1; apply Rinv_le_contravar; lra).
  pose proof (pos_true _ _ H (/ x - 1) ltac:(lra)) as P. rewrite ev_shift in P. now replace (IZR 1 + (/ x - 1)) with (/ x) in P by ring.
Qed.
Lemma pos_above fuel p : pos fuel (shift 1 p) = true -> forall x, 1 <= x -> 0 < ev p x.
Proof.
  intros H x X. pose proof (pos_true _ _ H (x - 1) ltac:(lra)) as P. rewrite ev_shift in P. now replace (IZR 1 + (x - 1)) with x in P by ring.
Qed.

(* ---- the response ---- *)
Definition pair_poly : Type := list Z * list Z.
Definition next (F G d : Z) (p q : pair_poly) : pair_poly :=
  (padd (padd (lin (2 * F) (2 * d) (fst p)) (0%Z :: pscal (- 2 * G) (snd p)))
        (padd (lin (- (F * F)) (G * G) (fst q)) (0%Z :: pscal (2 * F * G) (snd q))),
   padd (padd (lin (2 * F) (2 * d) (snd p)) (pscal (2 * G) (fst p)))
        (padd (lin (- (F * F)) (G * G) (snd q)) (pscal (- 2 * F * G) (fst q)))).
(* t_n and t_(n+1) *)
Fixpoint two_terms (F G d : Z) (n : nat) : pair_poly * pair_poly :=
  match n with
  | O => (([1%Z], []), ([F; d], [G]))
  | S n => let t := two_terms F G d n in (snd t, next F G d (snd t) (fst t))
  end.
Definition cev (p : pair_poly) (w : R) : C := (ev (fst p) (w ^ 2), w * ev (snd p) (w ^ 2)).
Definition zc (F G : Z) (w : R) : C := (IZR F, w * IZR G).
Definition nc (F G d : Z) (w : R) : C := (IZR F + IZR d * w ^ 2, w * IZR G).
Lemma cev_next F G d p q w : cev (next F G d p q) w = (2 * nc F G d w * cev p w - zc F G w * zc F G w * cev q w)%C.
Proof.
  unfold cev, next, zc, nc. cbn [fst snd]. rewrite !ev_add, !ev_lin, !ev_scal. cbn [ev]. rewrite !ev_scal.
  rewrite ?opp_IZR, ?mult_IZR, ?opp_IZR, ?mult_IZR.
  apply injective_projections; cbn; ring.
Qed.
(* |t_M|^2, |z'|^(2M) *)
Definition below (F G d : Z) (M : nat) : list Z :=
  let t := fst (two_terms F G d M) in padd (pmul (fst t) (fst t)) (0%Z :: pmul (snd t) (snd t)).
Fixpoint above (F G : Z) (M : nat) : list Z := match M with O => [1%Z] | S M => lin (F * F) (G * G) (above F G M) end.
Lemma below_spec F G d M w : ev (below F G d M) (w ^ 2) = Cmod (cev (fst (two_terms F G d M)) w) ^ 2.
Proof. rewrite Cmod_sqr. unfold below, cev. cbn [fst snd]. rewrite ev_add. cbn [ev]. rewrite !ev_mul. ring. Qed.
Lemma above_spec F G M w : ev (above F G M) (w ^ 2) = Cmod (Cpw (zc F G w) M) ^ 2.
Proof.
  rewrite Cmod_Cpw, <- pow_mult, Nat.mul_comm, pow_mult, Cmod_sqr. unfold zc. cbn [fst snd]. rewrite Rpow_mult_distr.
  set (s := w ^ 2). set (b := IZR F ^ 2 + s * IZR G ^ 2). induction M as [|M IH]; cbn [above ev pow]; [ring|].
  rewrite ev_lin, IH, !mult_IZR. f_equal. unfold b. ring.
Qed.

(* the amplitudes of equation (2), backwards from the last car *)
Lemma amplitudes F G d f g w N a : IZR F = IZR d * f -> IZR G = IZR d * g -> equation_2 f g w N a ->
  forall j, (j <= N)%nat ->
  (Cpw (zc F G w) j * a (S N - j)%nat = cev (fst (two_terms F G d j)) w * a (S N) /\
   Cpw (zc F G w) (S j) * a (N - j)%nat = cev (snd (two_terms F G d j)) w * a (S N))%C.
Proof.
  intros HF HG [E L]. set (z := zc F G w). assert (Z : z = (RtoC (IZR d) * den f g w)%C).
  { unfold z, zc, den. rewrite HF, HG. apply injective_projections; cbn; ring. }
  assert (NC : nc F G d w = (z + RtoC (IZR d * w ^ 2))%C) by (apply injective_projections; cbn; ring).
  induction j as [|j IH]; intros Hj.
  - rewrite !Nat.sub_0_r. cbn [Cpw two_terms fst snd]. split.
    + unfold cev. cbn [fst snd ev]. apply injective_projections; cbn; ring.
    + apply (f_equal (fun y => RtoC (IZR d) * y)%C) in L.
      replace (RtoC (IZR d) * (den f g w * (a (S N) - a N)))%C with (z * a (S N) - z * a N)%C in L by (rewrite Z; ring).
      assert (C : cev ([F; d], [G]) w = nc F G d w) by (unfold cev, nc; cbn [fst snd ev]; apply injective_projections; cbn; ring).
      rewrite C, NC, Cmult_1_r.
      replace (z * a N)%C with (z * a (S N) - (z * a (S N) - z * a N))%C by ring. rewrite <- L.
      apply injective_projections; cbn; ring.
  - destruct (IH ltac:(lia)) as [A B]. cbn [two_terms]. cbv zeta. cbn [fst snd]. split.
    + replace (S N - S j)%nat with (N - j)%nat by lia. exact B.
    + rewrite cev_next. fold z. specialize (E (N - j)%nat ltac:(lia)).
      replace (N - j - 1)%nat with (N - S j)%nat in E by lia. replace (N - j + 1)%nat with (S N - j)%nat in E by lia.
      apply (f_equal (fun y => 2 * RtoC (IZR d) * y)%C) in E.
      replace (2 * RtoC (IZR d) * (den f g w * (a (N - j)%nat - / 2 * (a (N - S j)%nat + a (S N - j)%nat))))%C
        with (2 * (z * a (N - j)%nat) - (2 * / 2) * (z * (a (N - S j)%nat + a (S N - j)%nat)))%C in E by (rewrite Z; ring).
      rewrite Cinv_r in E by exact C2_neq0.
      assert (Q : (z * a (N - S j)%nat = 2 * nc F G d w * a (N - j)%nat - z * a (S N - j)%nat)%C).
      { rewrite NC. replace (z * a (N - S j)%nat)%C
          with (2 * (z * a (N - j)%nat) - z * a (S N - j)%nat - (2 * (z * a (N - j)%nat) - 1 * (z * (a (N - S j)%nat + a (S N - j)%nat))))%C by ring.
        rewrite <- E. apply injective_projections; cbn; ring. }
      cbn [Cpw]. fold z in A, B. cbn [Cpw] in B.
      replace (z * (z * Cpw z j) * a (N - S j)%nat)%C with (z * Cpw z j * (z * a (N - S j)%nat))%C by ring. rewrite Q.
      replace (z * Cpw z j * (2 * nc F G d w * a (N - j)%nat - z * a (S N - j)%nat))%C
        with (2 * nc F G d w * (z * Cpw z j * a (N - j)%nat) - z * z * (Cpw z j * a (S N - j)%nat))%C by ring.
      rewrite A, B. ring.
Qed.
