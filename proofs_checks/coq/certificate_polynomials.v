(* Polynomials with integer coefficients, for certificates over the reals: values, derivatives, and positivity on (0, 1].
   A polynomial is positive there if the coefficients of (1 + u)^n p(1/(1 + u)) are; if they are not, the interval is halved. *)
From Coq Require Import Reals ZArith List Bool Lia Lra.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums.
Import ListNotations.
Open Scope R_scope.

(* the constant coefficient first *)
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

(* positive on (0, 1]; no eager && or ||, so that nothing is computed in vain *)
Definition no_sign (p : list Z) : bool := match p with [] => false | c :: p => if Z.ltb 0 c then forallb (Z.leb 0) p else false end.
Fixpoint pos (fuel : nat) (p : list Z) : bool :=
  if no_sign (shift 1 (rev p)) then true
  else match fuel with
    | O => false
    | S k => let half := shrink 2 p in if pos k half then pos k (shift 1 half) else false
    end.
Lemma no_sign_true p y : no_sign p = true -> 0 <= y -> 0 < ev p y.
Proof.
  destruct p as [|c p]; cbn [no_sign ev]; [discriminate|]. destruct (Z.ltb 0 c) eqn:C; [|discriminate]. apply Z.ltb_lt, IZR_lt in C.
  intros H Y. assert (E : 0 <= ev p y).
  { induction p as [|b p IH]; cbn [ev]; [lra|]. cbn [forallb] in H. apply andb_prop in H as [B H].
    apply Z.leb_le, IZR_le in B. specialize (IH H). assert (0 <= y * ev p y) by now apply Rmult_le_pos. lra. }
  assert (0 <= y * ev p y) by now apply Rmult_le_pos. lra.
Qed.
Lemma pos_true fuel : forall p, pos fuel p = true -> forall x, 0 < x <= 1 -> 0 < ev p x.
Proof.
  induction fuel as [|k IH]; intros p H x X; cbn [pos] in H; destruct (no_sign (shift 1 (rev p))) eqn:A; try discriminate.
  1, 2: apply rev_pos; [lra|]; assert (I : 1 <= / x) by (rewrite <- Rinv_1; apply Rinv_le_contravar; lra);
    pose proof (no_sign_true _ (/ x - 1) A ltac:(lra)) as P; rewrite ev_shift in P; now replace (IZR 1 + (/ x - 1)) with (/ x) in P by ring.
  cbv zeta in H. destruct (pos k (shrink 2 p)) eqn:S; [|discriminate].
  assert (C : 0 < IZR 2) by lra. destruct (shrink_ev 2 p (2 * x) C ltac:(lra)) as (c & K & E).
  replace (2 * x / IZR 2) with x in E by field. apply (Rmult_lt_reg_l c); [exact K|]. rewrite Rmult_0_r, <- E.
  destruct (Rle_lt_dec (2 * x) 1) as [L|L]; [apply (IH _ S); lra|].
  pose proof (IH _ H (2 * x - 1) ltac:(lra)) as P. rewrite ev_shift in P. now replace (IZR 1 + (2 * x - 1)) with (2 * x) in P by ring.
Qed.
Lemma pos_above fuel p : pos fuel (rev p) = true -> forall x, 1 <= x -> 0 < ev p x.
Proof.
  intros H x X. apply rev_pos; [lra|]. apply (pos_true _ _ H). split; [apply Rinv_0_lt_compat; lra|].
  rewrite <- Rinv_1. apply Rinv_le_contravar; lra.
Qed.

(* c^(length p - 1) p(n/c), and c^(length p), by Horner's rule *)
Fixpoint horner (n c : Z) (p : list Z) : Z * Z :=
  match p with [] => (0%Z, 1%Z) | a :: p => let r := horner n c p in ((snd r * a + n * fst r)%Z, (c * snd r)%Z) end.
Lemma horner_spec n c p : 0 < IZR c -> 0 < IZR (snd (horner n c p)) /\
  IZR c * IZR (fst (horner n c p)) = IZR (snd (horner n c p)) * ev p (IZR n / IZR c).
Proof.
  intros C. induction p as [|a p [P E]]; cbn [horner ev]; [cbn; lra|]. cbv zeta. cbn [fst snd]. set (r := horner n c p) in *.
  rewrite !plus_IZR, !mult_IZR. split; [now apply Rmult_lt_0_compat|].
  rewrite Rmult_plus_distr_l. replace (IZR c * (IZR n * IZR (fst r))) with (IZR n * (IZR c * IZR (fst r))) by ring. rewrite E. field. lra.
Qed.

(* p' *)
Fixpoint slope (p : list Z) : list Z := match p with [] => [] | _ :: p => padd p (0%Z :: slope p) end.
Lemma D_ev p x : is_derive (ev p) x (ev (slope p) x).
Proof.
  revert x. induction p as [|c p IH]; intros x; [apply D_const|]. cbn [slope]. rewrite ev_add. cbn [ev].
  eapply D_eq; [apply (D_plus (fun _ => IZR c) (fun x => x * ev p x)); [apply D_const|apply (D_mult (fun x => x) (ev p)); [apply D_id|apply IH]]|].
  cbv beta. ring.
Qed.
