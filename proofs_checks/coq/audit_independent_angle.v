(* Clauses of the claims about Chazelle's paper that speak of functions of the real numbers: beyond.chazelle.angle clause 1, chazelle.epsineq, chazelle.eq3.15 clause 1,
   chazelle.fiedler.rate clause 2, formalised from their words before the theorems were looked at; the theorems prove them. *)
From Coq Require Import Reals Lra Lia Psatz.
From Coquelicot Require Import Coquelicot.
From Flockproof Require chazelle_worked chazelle_angle.
Open Scope R_scope.
(* the angle of (x, t) and (v, 1) in R^(d+1), own definitions *)
Fixpoint inner_of (d : nat) (x y : nat -> R) : R := match d with O => 0 | S d => inner_of d x y + x d * y d end.
Definition length_of d x := sqrt (inner_of d x x).
Definition lift (d : nat) (x : nat -> R) (h : R) (k : nat) : R := if Nat.eqb k d then h else x k.
Definition angle_of d x y := acos (inner_of d x y / (length_of d x * length_of d y)).
Definition angle_1 : Prop := forall (d : nat) (x v : nat -> R) (t : nat), (1 <= t)%nat ->
  angle_of (S d) (lift d x (INR t)) (lift d v 1) <= length_of d (fun k => v k - x k / INR t) /\
  length_of d (fun k => v k - x k / INR t) = length_of d (fun k => x k - INR t * v k) / INR t.

(* ---- the theorems prove them ---- *)
Lemma inner_ext d x y x' y' : (forall k, (k < d)%nat -> x k = x' k /\ y k = y' k) -> inner_of d x y = inner_of d x' y'.
Proof.
  induction d as [|d IH]; intros H; [reflexivity|]. cbn. rewrite IH by (intros; apply H; lia). destruct (H d ltac:(lia)) as [-> ->]. reflexivity.
Qed.
Lemma inner_dotp d x y : inner_of d x y = chazelle_worked.dotp d x y.
Proof. induction d as [|d IH]; [reflexivity|]. cbn. now rewrite IH. Qed.
Lemma inner_scal d a b x y : inner_of d (fun k => a * x k) (fun k => b * y k) = a * b * inner_of d x y.
Proof. induction d as [|d IH]; cbn; [ring|rewrite IH; ring]. Qed.
Lemma inner_ge0 d x : 0 <= inner_of d x x.
Proof. induction d as [|d IH]; cbn; [lra|nra]. Qed.
Lemma inner_lift d x y h g : inner_of (S d) (lift d x h) (lift d y g) = inner_of d x y + h * g.
Proof.
  cbn. unfold lift at 3 4. rewrite Nat.eqb_refl. f_equal. apply inner_ext. intros k Hk. unfold lift.
  destruct (Nat.eqb_spec k d); [lia|split; reflexivity].
Qed.
Lemma angle_1_proved : angle_1.
Proof.
  intros d x v t Ht. assert (T : 0 < INR t) by (apply lt_0_INR; lia). pose proof (chazelle_angle.lifted_birds d x v (INR t) T) as H.
  unfold chazelle_worked.norm in H. rewrite <- !inner_dotp in H. exact H.
Qed.

(* ==== more clauses about real functions, formalised from their words alike, before the theorems were looked at ==== *)
(* chazelle.epsineq; eps_h = nu^(-nu^4), for any difference of distances *)
Definition eps_of (nu : nat) := / INR nu ^ (nu ^ 4).
Definition epsineq : Prop := forall nu : nat, (1 <= nu)%nat ->
  exp (- INR nu ^ (nu ^ 2)) < Rpower (INR nu) (- INR (nu ^ 4)) /\ Rpower (INR nu) (- INR (nu ^ 4)) = eps_of nu /\
  forall Delta, Delta < exp (- INR nu ^ (nu ^ 2)) -> Delta < eps_of nu.
(* chazelle.eq3.15 clause 1; all vectors lifted *)
Definition eq3_15_1 : Prop := exists K, forall (d : nat) (x v : nat -> R) (t : nat), (1 <= t)%nat ->
  let X := lift d x (INR t) in let V := lift d v 1 in let W := fun k => X k / INR t in
  (exists k, (k <= d)%nat /\ V k <> W k) ->
  angle_of (S d) X V / length_of (S d) (fun k => V k - W k) <= K.
(* chazelle.fiedler.rate clause 2, refuted: no bound n^O(1) 2^(t/n^c) with c > 0 tends to 0; all tend to infinity *)
Definition fiedler_2 : Prop := forall c K (n : nat), 0 < c -> (1 <= n)%nat ->
  let bound := fun t : nat => INR n ^ K * Rpower 2 (INR t / Rpower (INR n) c) in
  is_lim_seq bound p_infty /\ ~ is_lim_seq bound 0.

(* ---- the theorems prove them ---- *)
Lemma epsineq_proved : epsineq.
Proof.
  intros nu Hn. assert (N : 0 < INR nu) by (apply lt_0_INR; lia).
  assert (E : Rpower (INR nu) (- INR (nu ^ 4)) = eps_of nu).
  { unfold eps_of. rewrite Rpower_Ropp, Rpower_pow by exact N. reflexivity. }
  assert (I : exp (- INR nu ^ (nu ^ 2)) < Rpower (INR nu) (- INR (nu ^ 4))).
  { rewrite E, <- pow_INR. exact (chazelle_worked.eps_inequality nu Hn). }
  split; [exact I|]. split; [exact E|]. intros Delta HD. rewrite <- E. lra.
Qed.
Lemma eq3_15_1_proved : eq3_15_1.
Proof.
  exists 1. intros d x v t Ht X V W [k [Hk Hne]]. assert (T : 0 < INR t) by (apply lt_0_INR; lia).
  destruct (angle_1_proved d x v t Ht) as [H _].
  assert (E : inner_of (S d) (fun k => V k - W k) (fun k => V k - W k) = inner_of d (fun k => v k - x k / INR t) (fun k => v k - x k / INR t)).
  { cbn. replace (V d - W d) with 0.
    2: { unfold V, W, X, lift. rewrite Nat.eqb_refl. field. lra. }
    rewrite Rmult_0_r, Rplus_0_r. apply inner_ext. intros l Hl.
    unfold V, W, X, lift. destruct (Nat.eqb_spec l d); [lia|split; reflexivity]. }
  assert (L : length_of (S d) (fun k => V k - W k) = length_of d (fun k => v k - x k / INR t)) by (unfold length_of; now rewrite E).
  rewrite L. assert (P : 0 < length_of d (fun k => v k - x k / INR t)).
  { apply sqrt_lt_R0. destruct (Rle_lt_or_eq_dec _ _ (inner_ge0 d (fun k => v k - x k / INR t))) as [|Z]; [assumption|exfalso].
    assert (A : forall e y, 0 = inner_of e y y -> forall l, (l < e)%nat -> y l = 0).
    { induction e as [|e IH]; intros y Hy l Hl; [lia|]. cbn in Hy. pose proof (inner_ge0 e y). pose proof (Rle_0_sqr (y e)) as Q. unfold Rsqr in Q.
      destruct (Nat.eq_dec l e) as [->|]; [apply Rsqr_0_uniq; unfold Rsqr; lra|apply IH; [lra|lia]]. }
    pose proof (A d _ Z) as B. apply Hne. unfold V, W, X, lift. destruct (Nat.eqb_spec k d) as [->|]; [field; lra|].
    specialize (B k ltac:(lia)). cbn in B. lra. }
  apply Rcomplements.Rle_div_l; [exact P|]. rewrite Rmult_1_l. exact H.
Qed.
Lemma fiedler_2_proved : fiedler_2.
Proof.
  intros c K n Hc Hn bound. assert (N : 1 <= INR n) by (apply (le_INR 1); lia).
  assert (Y : 0 < / Rpower (INR n) c) by (apply Rinv_0_lt_compat, exp_pos). set (y := / Rpower (INR n) c) in *.
  assert (L2 : 0 < ln 2) by (rewrite <- ln_1; apply ln_increasing; lra).
  assert (Q : 0 < y * ln 2) by (apply Rmult_lt_0_compat; assumption).
  assert (I : is_lim_seq bound p_infty).
  { apply (is_lim_seq_le_p_loc (fun t => INR t * (y * ln 2))).
    - exists O. intros t _. unfold bound. assert (A : 1 <= INR n ^ K) by (apply pow_R1_Rle; exact N).
      assert (B : INR t * (y * ln 2) < Rpower 2 (INR t / Rpower (INR n) c)).
      { unfold Rpower at 1. replace (INR t / Rpower (INR n) c * ln 2) with (INR t * (y * ln 2)) by (unfold y, Rdiv; ring).
        assert (Z : 0 <= INR t * (y * ln 2)) by (apply Rmult_le_pos; [apply pos_INR|lra]).
        pose proof (exp_ineq1_le (INR t * (y * ln 2))). lra. }
      pose proof (exp_pos (INR t / Rpower (INR n) c * ln 2)) as P. fold (Rpower 2 (INR t / Rpower (INR n) c)) in P. nra.
    - apply (is_lim_seq_ext (fun t => (y * ln 2) * INR t)); [intros; ring|].
      pose proof (is_lim_seq_scal_l INR (y * ln 2) p_infty is_lim_seq_INR) as S.
      replace (Rbar_mult (y * ln 2) p_infty) with p_infty in S; [exact S|].
      symmetry. apply is_Rbar_mult_unique. apply (is_Rbar_mult_p_infty_pos (y * ln 2) Q) || (cbn; destruct (Rle_dec 0 (y * ln 2)) as [H|]; [|lra]; destruct (Rle_lt_or_eq_dec 0 (y * ln 2) H); [reflexivity|lra]). }
  split; [exact I|]. intros Z. apply is_lim_seq_unique in I, Z. rewrite I in Z. discriminate.
Qed.
