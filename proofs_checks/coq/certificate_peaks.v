(* The main resonance of a two-sided platoon by integers (Veerman, Stosic, Olvera, section 4).
   With z = f + i w g = z'/d the numbers t_k = z'^k a_(M-k)/a_M obey t_0 = 1, t_1 = z' + d w^2,
   t_(k+1) = 2 (z' + d w^2) t_k - z'^2 t_(k-1): polynomials in s = w^2, apart from a factor i w of the imaginary part. So
   |a_M|^2 = |z'|^(2 M)/|t_M|^2; the signs of its slope and of A^2 - |a_M|^2 are those of polynomials with integer coefficients. *)
From Coq Require Import Reals Qreals ZArith QArith List Bool Lia Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums veerman_complex veerman_front veerman_chain veerman_stability veerman_amplitude certificate_polynomials.
Import ListNotations.
Open Scope R_scope.

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

(* ---- the amplitude ---- *)
Lemma amplitude_poly F G d f g N w : f < 0 -> g < 0 -> 0 < IZR d -> IZR F = IZR d * f -> IZR G = IZR d * g ->
  0 < ev (below F G d (S N)) (w ^ 2) /\
  amplitude f g N w ^ 2 * ev (below F G d (S N)) (w ^ 2) = ev (above F G (S N)) (w ^ 2).
Proof.
  intros Hf Hg Hd HF HG. destruct (amplitude_spec f g N w Hf Hg) as [(a & A0 & HE) U]. rewrite <- (U a A0 HE).
  destruct (amplitudes F G d f g w N a HF HG HE N (le_n N)) as [_ A]. rewrite Nat.sub_diag, A0, Cmult_1_r in A.
  change (snd (two_terms F G d N)) with (fst (two_terms F G d (S N))) in A.
  rewrite below_spec, above_spec, A, Cmod_mult, Rpow_mult_distr. split; [|ring].
  assert (Z : Cpw (zc F G w) (S N) <> 0%C).
  { apply Cpw_neq0, Cneq0_re. unfold zc. cbn [fst]. rewrite HF. assert (0 < IZR d * - f) by (apply Rmult_lt_0_compat; lra). lra. }
  apply pow_lt, Cmod_gt_0. intros T. apply Z. rewrite A, T. ring.
Qed.

(* ---- the certificate ---- *)
(* A positive multiple of a^2 - amplitude^2 *)
Definition excess (F G d : Z) (M : nat) (a : Q) : list Z :=
  padd (pscal (Qnum a * Qnum a) (below F G d M)) (pscal (- (Zpos (Qden a) * Zpos (Qden a))) (above F G M)).
Lemma excess_spec F G d f g N w a : f < 0 -> g < 0 -> 0 < IZR d -> IZR F = IZR d * f -> IZR G = IZR d * g -> 0 < Q2R a ->
  (0 < ev (excess F G d (S N) a) (w ^ 2) -> amplitude f g N w < Q2R a) /\
  (ev (excess F G d (S N) a) (w ^ 2) <= 0 -> Q2R a <= amplitude f g N w).
Proof.
  intros Hf Hg Hd HF HG Ha. destruct (amplitude_poly F G d f g N w Hf Hg Hd HF HG) as [P E].
  assert (A0 : 0 <= amplitude f g N w) by apply Cmod_ge_0. set (m := amplitude f g N w) in *.
  assert (D : 0 < IZR (Zpos (Qden a))) by (apply IZR_lt; reflexivity).
  assert (X : ev (excess F G d (S N) a) (w ^ 2) = (Q2R a - m) * ((Q2R a + m) * (IZR (Zpos (Qden a)) ^ 2 * ev (below F G d (S N)) (w ^ 2)))).
  { unfold excess. rewrite ev_add, !ev_scal, <- E, opp_IZR, !mult_IZR. unfold Q2R. field. lra. }
  assert (Y : 0 < (Q2R a + m) * (IZR (Zpos (Qden a)) ^ 2 * ev (below F G d (S N)) (w ^ 2))).
  { apply Rmult_lt_0_compat; [lra|]. apply Rmult_lt_0_compat; [now apply pow_lt|exact P]. }
  rewrite X. set (y := (Q2R a + m) * _) in *. split; intros H.
  - apply Rnot_le_lt. intros L. assert (0 <= (m - Q2R a) * y) by (apply Rmult_le_pos; lra). lra.
  - apply Rnot_lt_le. intros L. assert (0 < (Q2R a - m) * y) by (apply Rmult_lt_0_compat; lra). lra.
Qed.

(* d|a_M|^2/ds times |t_M|^4, where s = w^2 *)
Definition steepness (F G d : Z) (M : nat) : list Z :=
  padd (pmul (slope (above F G M)) (below F G d M)) (pscal (-1) (pmul (above F G M) (slope (below F G d M)))).
Lemma amplitude_derive F G d f g N w : f < 0 -> g < 0 -> 0 < w -> 0 < IZR d -> IZR F = IZR d * f -> IZR G = IZR d * g ->
  exists k, 0 < k /\ is_derive (fun w => amplitude f g N w ^ 2) w (k * ev (steepness F G d (S N)) (w ^ 2)).
Proof.
  intros Hf Hg Hw Hd HF HG. set (b := ev (below F G d (S N)) (w ^ 2)).
  assert (P : 0 < b) by apply (amplitude_poly F G d f g N w Hf Hg Hd HF HG).
  exists (2 * w / b ^ 2). split; [apply Rdiv_lt_0_compat; [lra|now apply pow_lt]|].
  assert (EQ : forall v : R, ev (above F G (S N)) (v ^ 2) / ev (below F G d (S N)) (v ^ 2) = amplitude f g N v ^ 2).
  { intros v. destruct (amplitude_poly F G d f g N v Hf Hg Hd HF HG) as [Q E]. rewrite <- E. field. lra. }
  apply (is_derive_ext _ _ _ _ EQ).
  assert (D : forall p, is_derive (fun w => ev p (w ^ 2)) w (ev (slope p) (w ^ 2) * (2 * w))).
  { intros p. apply (D_comp (ev p) (fun w => w ^ 2) w _ (2 * w)); [apply D_ev|]. eapply D_eq; [apply (D_sqr (fun w => w)), D_id|ring]. }
  eapply D_eq; [apply is_derive_div; [apply D|apply D|fold b; lra]|]. fold b. unfold steepness.
  rewrite ev_add, ev_scal, !ev_mul. fold b. field. lra.
Qed.

(* a multiple of p(w^2 x) *)
Definition at_square (w : Q) (p : list Z) : list Z := grow (Qnum w * Qnum w) (shrink (Zpos (Qden w) * Zpos (Qden w)) p).
Lemma at_square_ev w p x : 0 < x -> 0 < Q2R w -> exists k, 0 < k /\ ev (at_square w p) x = k * ev p (Q2R w ^ 2 * x).
Proof.
  intros X W. unfold at_square. rewrite ev_grow. assert (D : 0 < IZR (Zpos (Qden w))) by (apply IZR_lt; reflexivity).
  assert (N : 0 < IZR (Qnum w)).
  { unfold Q2R in W. apply (Rmult_lt_reg_r (/ IZR (Zpos (Qden w)))); [now apply Rinv_0_lt_compat|]. now rewrite Rmult_0_l. }
  rewrite mult_IZR. set (n := IZR (Qnum w)) in *.
  assert (P : 0 < n * n * x) by (repeat apply Rmult_lt_0_compat; assumption).
  assert (C : 0 < IZR (Zpos (Qden w) * Zpos (Qden w))) by (rewrite mult_IZR; now apply Rmult_lt_0_compat).
  destruct (shrink_ev (Zpos (Qden w) * Zpos (Qden w)) p (n * n * x) C P) as (k & K & E).
  exists k. split; [exact K|]. rewrite E. f_equal. f_equal. unfold Q2R. fold n. rewrite mult_IZR. field. lra.
Qed.

(* the sign of p(w^2) *)
Definition value (w : Q) (p : list Z) : Z := fst (horner (Qnum w * Qnum w) (Zpos (Qden w) * Zpos (Qden w)) p).
Lemma value_spec w p : exists k, 0 < k /\ IZR (value w p) = k * ev p (Q2R w ^ 2).
Proof.
  unfold value. set (c := (Zpos (Qden w) * Zpos (Qden w))%Z). assert (D : 0 < IZR (Zpos (Qden w))) by (apply IZR_lt; reflexivity).
  assert (C : 0 < IZR c) by (unfold c; rewrite mult_IZR; now apply Rmult_lt_0_compat).
  destruct (horner_spec (Qnum w * Qnum w) c p C) as [K E]. set (r := horner _ _ _) in *.
  replace (Q2R w ^ 2) with (IZR (Qnum w * Qnum w) / IZR c) by (unfold c, Q2R; rewrite !mult_IZR; field; lra).
  exists (IZR (snd r) / IZR c). split; [now apply Rdiv_lt_0_compat|]. apply (Rmult_eq_reg_l (IZR c)); [|lra]. rewrite E. field. lra.
Qed.

Definition positive (q : Q) : bool := Z.ltb 0 (Qnum q).
Definition less (p q : Q) : bool := Z.ltb (Qnum p * Zpos (Qden q)) (Qnum q * Zpos (Qden p)).
(* lo and hi over one denominator *)
Definition peak_check (f g : Q) (N : nat) (lo hi at_w least most : Q) (fuel : nat) : bool :=
  let d := (Zpos (Qden f) * Zpos (Qden g))%Z in
  let F := (Qnum f * Zpos (Qden g))%Z in let G := (Qnum g * Zpos (Qden f))%Z in
  let low := excess F G d (S N) least in
  let c := Zpos (Qden lo) in
  Z.ltb (Qnum f) 0 && Z.ltb (Qnum g) 0 && positive lo && positive least && positive most && less lo at_w && less at_w hi &&
  Pos.eqb (Qden lo) (Qden hi) &&
  Z.ltb 0 (value lo (steepness F G d (S N))) && Z.ltb (value hi (steepness F G d (S N))) 0 && Z.leb (value at_w low) 0 &&
  pos fuel (at_square lo low) && pos fuel (rev (at_square hi low)) &&
  pos fuel (grow (Qnum hi * Qnum hi - Qnum lo * Qnum lo) (shift (Qnum lo * Qnum lo) (shrink (c * c) (excess F G d (S N) most)))).
Definition has_peak (f g : R) (N : nat) (lo hi least most : R) : Prop :=
  (exists s, is_derive (fun w => amplitude f g N w ^ 2) lo s /\ 0 < s) /\
  (exists s, is_derive (fun w => amplitude f g N w ^ 2) hi s /\ s < 0) /\
  (exists w, lo < w < hi /\ least <= amplitude f g N w < most /\ forall w', 0 < w' -> amplitude f g N w' <= amplitude f g N w) /\
  forall w, 0 < w -> ~ (lo < w < hi) -> amplitude f g N w < least.

Lemma Q2R_less p q : less p q = true -> Q2R p < Q2R q.
Proof. intros H. apply Qlt_Rlt. unfold less in H. apply Z.ltb_lt in H. exact H. Qed.
Lemma Q2R_positive q : positive q = true -> 0 < Q2R q.
Proof.
  intros H. apply Z.ltb_lt in H. unfold Q2R. apply Rmult_lt_0_compat; [now apply IZR_lt|]. apply Rinv_0_lt_compat, IZR_lt. reflexivity.
Qed.
Theorem peak_certificate f g N lo hi at_w least most fuel : peak_check f g N lo hi at_w least most fuel = true ->
  has_peak (Q2R f) (Q2R g) N (Q2R lo) (Q2R hi) (Q2R least) (Q2R most).
Proof.
  unfold peak_check. cbv zeta. set (d := (Zpos (Qden f) * Zpos (Qden g))%Z).
  set (F := (Qnum f * Zpos (Qden g))%Z). set (G := (Qnum g * Zpos (Qden f))%Z).
  intros H. do 13 (apply andb_prop in H as [H ?]).
  rename H0 into Kmid, H1 into Khi, H2 into Klo, H3 into Kat, H4 into Khs, H5 into Kls, H6 into Kden, H7 into Lh, H8 into Ll, H9 into Pm, H10 into Pl, H11 into Plo, H12 into Ng.
  apply Z.ltb_lt in H, Ng.
  assert (Df : 0 < IZR (Zpos (Qden f))) by (apply IZR_lt; reflexivity). assert (Dg : 0 < IZR (Zpos (Qden g))) by (apply IZR_lt; reflexivity).
  assert (Hf : Q2R f < 0).
  { unfold Q2R. apply IZR_lt in H. assert (0 < - IZR (Qnum f) * / IZR (Zpos (Qden f))) by (apply Rmult_lt_0_compat; [lra|now apply Rinv_0_lt_compat]). lra. }
  assert (Hg : Q2R g < 0).
  { unfold Q2R. apply IZR_lt in Ng. assert (0 < - IZR (Qnum g) * / IZR (Zpos (Qden g))) by (apply Rmult_lt_0_compat; [lra|now apply Rinv_0_lt_compat]). lra. }
  assert (Hd : 0 < IZR d) by (unfold d; rewrite mult_IZR; now apply Rmult_lt_0_compat).
  assert (HF : IZR F = IZR d * Q2R f) by (unfold F, d, Q2R; rewrite !mult_IZR; field; lra).
  assert (HG : IZR G = IZR d * Q2R g) by (unfold G, d, Q2R; rewrite !mult_IZR; field; lra).
  apply Q2R_less in Lh, Ll. apply Q2R_positive in Pm, Pl, Plo.
  pose proof (fun w a => excess_spec F G d (Q2R f) (Q2R g) N w a Hf Hg Hd HF HG) as X.
  set (A := amplitude (Q2R f) (Q2R g) N) in *. set (l := Q2R lo) in *. set (h := Q2R hi) in *.
  assert (Out : forall w, 0 < w -> ~ (l < w < h) -> A w < Q2R least).
  { intros w W O. apply (X w least Pl). destruct (Rle_lt_dec w l) as [L|L].
    - assert (U : 0 < w ^ 2 / l ^ 2 <= 1).
      { assert (0 < l ^ 2) by now apply pow_lt. split; [apply Rdiv_lt_0_compat; [now apply pow_lt|assumption]|].
        apply (Rmult_le_reg_r (l ^ 2)); [assumption|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. rewrite Rmult_1_r, Rmult_1_l. apply pow_incr. lra. }
      destruct (at_square_ev lo (excess F G d (S N) least) _ (proj1 U) Plo) as (k & K & E). pose proof (pos_true _ _ Klo _ U) as P. rewrite E in P.
      fold l in P. replace (l ^ 2 * (w ^ 2 / l ^ 2)) with (w ^ 2) in P by (field; lra).
      apply (Rmult_lt_reg_l k); [exact K|]. now rewrite Rmult_0_r.
    - assert (Hh : 0 < h) by lra. assert (W2 : h <= w) by (apply Rnot_lt_le; intros C; apply O; now split).
      assert (U : 1 <= w ^ 2 / h ^ 2).
      { assert (0 < h ^ 2) by now apply pow_lt. apply (Rmult_le_reg_r (h ^ 2)); [assumption|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra.
        rewrite Rmult_1_r, Rmult_1_l. apply pow_incr. lra. }
      destruct (at_square_ev hi (excess F G d (S N) least) (w ^ 2 / h ^ 2) ltac:(lra) Hh) as (k & K & E). pose proof (pos_above _ _ Khi _ U) as P. rewrite E in P.
      fold h in P. replace (h ^ 2 * (w ^ 2 / h ^ 2)) with (w ^ 2) in P by (field; lra).
      apply (Rmult_lt_reg_l k); [exact K|]. now rewrite Rmult_0_r. }
  assert (In : forall w, l < w < h -> A w < Q2R most).
  { intros w W. apply (X w most Pm). apply Pos.eqb_eq in Kden. set (c := IZR (Zpos (Qden lo))).
    assert (C : 0 < c) by (apply IZR_lt; reflexivity).
    assert (El : IZR (Qnum lo) = l * c) by (unfold l, Q2R; fold c; field; lra).
    assert (Eh : IZR (Qnum hi) = h * c) by (unfold h, Q2R, c; rewrite Kden; field; apply IZR_neq; discriminate).
    assert (B : l ^ 2 < w ^ 2 < h ^ 2) by (split; rewrite <- !Rsqr_pow2; apply Rsqr_incrst_1; lra).
    assert (U : 0 < (w ^ 2 - l ^ 2) / (h ^ 2 - l ^ 2) <= 1).
    { split; [apply Rdiv_lt_0_compat; lra|]. apply (Rmult_le_reg_r (h ^ 2 - l ^ 2)); [lra|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. lra. }
    pose proof (pos_true _ _ Kmid _ U) as P. rewrite ev_grow, ev_shift, minus_IZR, !mult_IZR, El, Eh in P.
    replace (l * c * (l * c) + (h * c * (h * c) - l * c * (l * c)) * ((w ^ 2 - l ^ 2) / (h ^ 2 - l ^ 2))) with (w ^ 2 * c ^ 2) in P by (field; lra).
    assert (CC : 0 < IZR (Zpos (Qden lo) * Zpos (Qden lo))) by (rewrite mult_IZR; now apply Rmult_lt_0_compat).
    destruct (shrink_ev _ (excess F G d (S N) most) (w ^ 2 * c ^ 2) CC) as (k & K & E).
    { apply Rmult_lt_0_compat; apply pow_lt; lra. }
    rewrite E, mult_IZR in P. fold c in P. replace (w ^ 2 * c ^ 2 / (c * c)) with (w ^ 2) in P by (field; lra).
    apply (Rmult_lt_reg_l k); [exact K|]. now rewrite Rmult_0_r. }
  assert (At : Q2R least <= A (Q2R at_w)).
  { apply (X _ least Pl). apply Z.leb_le, IZR_le in Kat. destruct (value_spec at_w (excess F G d (S N) least)) as (k & K & E).
    rewrite E in Kat. apply (Rmult_le_reg_l k); [exact K|]. now rewrite Rmult_0_r. }
  assert (Slope : forall q, 0 < Q2R q -> exists k, 0 < k /\
    is_derive (fun w => amplitude (Q2R f) (Q2R g) N w ^ 2) (Q2R q) (k * IZR (value q (steepness F G d (S N))))).
  { intros q P. destruct (amplitude_derive F G d (Q2R f) (Q2R g) N (Q2R q) Hf Hg P Hd HF HG) as (k & K & D).
    destruct (value_spec q (steepness F G d (S N))) as (c & C & E). exists (k / c). split; [now apply Rdiv_lt_0_compat|].
    eapply D_eq; [exact D|]. rewrite E. field. lra. }
  split; [|split].
  1: { destruct (Slope lo Plo) as (k & K & D). eexists. split; [exact D|]. apply Rmult_lt_0_compat; [exact K|]. now apply IZR_lt, Z.ltb_lt. }
  1: { destruct (Slope hi ltac:(fold h; lra)) as (k & K & D). eexists. split; [exact D|]. apply Z.ltb_lt, IZR_lt in Khs. set (v := IZR (value hi _)) in *.
       assert (0 < k * - v) by (apply Rmult_lt_0_compat; lra). lra. }
  split; [|exact Out].
  destruct (continuity_ab_maj A l h ltac:(lra)) as (w & M & W).
  { intros c _. now apply amplitude_continuous. }
  pose proof (M (Q2R at_w) ltac:(lra)) as Ma.
  assert (Wi : l < w < h).
  { destruct (Rlt_dec l w) as [L1|L1], (Rlt_dec w h) as [L2|L2]; try (now split); exfalso;
      pose proof (Out w ltac:(lra) ltac:(tauto)); lra. }
  exists w. split; [exact Wi|]. split; [split; [exact (Rle_trans _ _ _ At Ma)|now apply In]|].
  intros w' W'. change (A w' <= A w). destruct (Rlt_dec l w') as [L1|L1], (Rlt_dec w' h) as [L2|L2]; [apply M; lra| | |];
    pose proof (Out w' W' ltac:(tauto)); lra.
Qed.
