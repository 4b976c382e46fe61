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
  intros d x v t Ht. assert (T : 0 < INR t) by (apply lt_0_INR; lia). split.
  - pose proof (chazelle_angle.angle_le d v (fun k => x k / INR t)) as H. unfold chazelle_worked.angle, chazelle_worked.ldot, chazelle_worked.norm, chazelle_worked.diff in H. rewrite <- !inner_dotp in H.
    unfold angle_of, length_of. rewrite !inner_lift.
    set (y := fun k => x k / INR t) in *.
    assert (E : forall z, inner_of d x z = INR t * inner_of d y z).
    { intros z. rewrite (inner_ext d x z (fun k => INR t * y k) (fun k => 1 * z k)); [rewrite inner_scal; ring|].
      intros k _. unfold y. split; [field; lra|ring]. }
    assert (Y : inner_of d x x = INR t * INR t * inner_of d y y).
    { rewrite (inner_ext d x x (fun k => INR t * y k) (fun k => INR t * y k)); [apply inner_scal|]. intros k _. unfold y. split; field; lra. }
    assert (C : forall p q, inner_of d p q = inner_of d q p) by (intros; induction d as [|d' IH] in |- *; cbn; [reflexivity|rewrite IH; ring]).
    rewrite (E v), Y, (C y v).
    replace (INR t * INR t * inner_of d y y + INR t * INR t) with (INR t * INR t * (inner_of d y y + 1)) by ring.
    pose proof (inner_ge0 d y). pose proof (inner_ge0 d v).
    rewrite sqrt_mult by nra. rewrite sqrt_square by lra.
    assert (P1 : 0 < sqrt (inner_of d y y + 1)) by (apply sqrt_lt_R0; lra). assert (P2 : 0 < sqrt (inner_of d v v + 1)) by (apply sqrt_lt_R0; lra).
    replace (1 * 1) with 1 by ring.
    replace ((INR t * inner_of d v y + INR t * 1) / (INR t * sqrt (inner_of d y y + 1) * sqrt (inner_of d v v + 1)))
      with ((inner_of d v y + 1) / (sqrt (inner_of d v v + 1) * sqrt (inner_of d y y + 1))) by (field; lra).
    rewrite (inner_ext d (fun k => v k - x k / INR t) (fun k => v k - x k / INR t) (fun k => 1 * v k + -1 * y k) (fun k => 1 * v k + -1 * y k)); [exact H|].
    intros k _. unfold y. split; unfold Rdiv; ring.
  - unfold length_of.
    rewrite (inner_ext d (fun k => v k - x k / INR t) _ (fun k => (- / INR t) * (x k - INR t * v k)) (fun k => (- / INR t) * (x k - INR t * v k))).
    + rewrite inner_scal. replace (- / INR t * - / INR t) with (/ INR t * / INR t) by ring.
      pose proof (Rinv_0_lt_compat _ T). rewrite sqrt_mult by (try apply inner_ge0; nra). rewrite sqrt_square by lra. unfold Rdiv. ring.
    + intros k _. split; field; lra.
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
