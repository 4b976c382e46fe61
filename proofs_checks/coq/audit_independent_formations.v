(* paley.releq (clauses 3 and 4) and paley.bal.circ (corrected, clauses 2 and 3), formalised from their words with own definitions, after the theorems had been proved; the theorems prove them. *)
From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums paley_model paley_phase.
From Flockproof Require paley_gradient paley_fourier paley_particles paley_releq paley_bal.
Open Scope R_scope.

(* ---- steered particles; a motion of the plane takes the places r to a r + b with |a| = 1, and turns the headings e^{i theta} by a ---- *)
Definition carried n (a b : C) (r : nat -> C) (th : nat -> R) (r' : nat -> C) (th' : nat -> R) := forall k, (k < n)%nat -> r' k = (a * r k + b)%C /\ expi (th' k) = (a * expi (th k))%C.
(* shape controls do not notice such motions *)
Definition of_shape n (u : (nat -> C) -> (nat -> R) -> nat -> R) := forall a b r th r' th', Cmod a = 1 -> carried n a b r th r' th' -> forall k, (k < n)%nat -> u r' th' k = u r th k.
Record steered n (u : (nat -> C) -> (nat -> R) -> nat -> R) (r : nat -> R -> C) (th : nat -> R -> R) : Prop := {
  forward : forall k t, (k < n)%nat -> 0 <= t -> is_derive (fun s => fst (r k s)) t (cos (th k t)) /\ is_derive (fun s => snd (r k s)) t (sin (th k t));
  turned : forall k t, (k < n)%nat -> 0 <= t -> is_derive (th k) t (u (fun j => r j t) (fun j => th j t) k) }.
(* a relative equilibrium: some motion from it is carried along by motions of the plane *)
Definition equilibrium n u (r0 : nat -> C) (th0 : nat -> R) := exists r th, steered n u r th /\ (forall k, (k < n)%nat -> r k 0 = r0 k /\ th k 0 = th0 k) /\
  forall t, 0 <= t -> exists a b, Cmod a = 1 /\ carried n a b r0 th0 (fun k => r k t) (fun k => th k t).
Definition parallel n (u : nat -> R) (th : nat -> R) := (forall k, (k < n)%nat -> u k = 0) /\ forall k j, (k < n)%nat -> (j < n)%nat -> expi (th k) = expi (th j).
Definition circles n (u : nat -> R) (r : nat -> C) (th : nat -> R) := exists rate c, rate <> 0 /\ forall k, (k < n)%nat -> u k = rate /\ (r k + Ci * expi (th k) / RtoC rate)%C = c.
Definition releq_3_4 : Prop := forall n u r th, (1 <= n)%nat -> of_shape n u -> (equilibrium n u r th <-> parallel n (u r th) th \/ circles n (u r th) r th).
(* ---- phases that maximise W_1 on an undirected connected circulant graph ---- *)
Definition applied n (adj : graph) (x : nat -> C) (k : nat) : C := Csum n (fun j => if adj k j then x k - x j else RtoC 0)%C.
Definition potential n adj (th : nat -> R) : R := / (2 * INR n) * Sum n (fun k => fst (Cconj (expi (th k)) * applied n adj (fun j => expi (th j)) k)%C).
Definition own_value n adj (l : R) := exists x, (exists k, (k < n)%nat /\ x k <> RtoC 0) /\ forall k, (k < n)%nat -> applied n adj x k = (RtoC l * x k)%C.
Definition top_value n adj (l : R) := own_value n adj l /\ forall m, own_value n adj m -> m <= l.
Definition circular_graph n (adj : graph) := exists s : nat -> bool, forall k j, (k < n)%nat -> (j < n)%nat -> adj k j = s ((j + n - k) mod n)%nat.
Definition bal_3 : Prop := forall n adj l th, (2 <= n)%nat -> undirected adj -> circular_graph n adj -> strongly_connected n adj -> top_value n adj l ->
  (forall q, potential n adj q <= potential n adj th) -> (forall k, (k < n)%nat -> applied n adj (fun j => expi (th j)) k = (RtoC l * expi (th k))%C) /\ Csum n (fun k => expi (th k)) = RtoC 0.
Definition bal_4 : Prop := forall n th, (2 <= n)%nat -> ((forall q, potential n complete q <= potential n complete th) <-> Csum n (fun k => expi (th k)) = RtoC 0).

(* ---- the theorems prove them ---- *)
Lemma unit_angle (a : C) : Cmod a = 1 -> exists t, a = expi t.
Proof.
  intros H. destruct a as [x y]. assert (S : x ^ 2 + y ^ 2 = 1). { pose proof (f_equal (fun z => z ^ 2) H) as E. cbv beta in E. unfold Cmod in E. cbn [fst snd] in E. rewrite pow2_sqrt in E by nra. lra. }
  assert (B : -1 <= x <= 1) by nra. pose proof (cos_acos x B) as C1. pose proof (sin2_cos2 (acos x)) as C2. unfold Rsqr in C2. rewrite C1 in C2.
  assert (F : (sin (acos x) - y) * (sin (acos x) + y) = 0) by nra. apply Rmult_integral in F. unfold expi. destruct F as [F|F].
  - exists (acos x). rewrite C1. f_equal. lra.
  - exists (- acos x). rewrite cos_neg, sin_neg, C1. f_equal. lra.
Qed.
Lemma carried_moved n r th r' th' : (exists a b, Cmod a = 1 /\ carried n a b r th r' th') <-> exists a b, paley_releq.moved n a b r th r' th'.
Proof.
  split.
  - intros (a & b & Ha & H). destruct (unit_angle a Ha) as [t ->]. exists t, b. intros k Hk. destruct (H k Hk) as [H1 H2]. split; [|exact H1]. rewrite H2, <- expi_plus. f_equal. ring.
  - intros (t & b & H). exists (expi t), b. split; [apply Cmod_expi|]. intros k Hk. destruct (H k Hk) as [H1 H2]. split; [exact H2|]. rewrite H1, <- expi_plus. f_equal. ring.
Qed.
Lemma releq_3_4_proved : releq_3_4.
Proof.
  intros n u r0 th0 Hn U.
  assert (SC : paley_releq.shape_control n u).
  { intros r th r' th' S k Hk. apply (paley_releq.orbits n r r' th th' Hn) in S. apply carried_moved in S. destruct S as (a & b & Ha & H). symmetry. now apply (U a b r th r' th'). }
  assert (A : equilibrium n u r0 th0 <-> paley_releq.relative_equilibrium n u r0 th0).
  { assert (Same : forall r th t, (forall k, (k < n)%nat -> r k 0 = r0 k /\ th k 0 = th0 k) ->
      (paley_releq.same_shape n (fun k => r k 0) (fun k => th k 0) (fun k => r k t) (fun k => th k t) <-> exists a b, Cmod a = 1 /\ carried n a b r0 th0 (fun k => r k t) (fun k => th k t))).
    { intros r th t I. rewrite (paley_releq.orbits n _ _ _ _ Hn), carried_moved. split; intros (a & b & H); exists a, b; intros k Hk; destruct (I k Hk) as [E F]; specialize (H k Hk); cbv beta in *; rewrite ?E, ?F in *; exact H. }
    split.
    - intros (r & th & [F T] & I & S). exists r, th. split; [|split; [exact I|intros t Ht; apply (Same r th t I), (S t Ht)]].
      intros k t Hk Ht. split; [destruct (F k t Hk Ht); now split|now apply T].
    - intros (r & th & L & I & S). exists r, th. split; [|split; [exact I|intros t Ht; apply (Same r th t I), (S t Ht)]].
      split; intros k t Hk Ht; destruct (L k t Hk Ht) as [[L1 L2] L3]; [now split|exact L3]. }
  rewrite A, (paley_releq.relative_equilibria n u r0 th0 SC). split; (intros [P|Q]; [left|right]).
  - split; [intros k Hk; now apply (P k k)|intros k j Hk Hj; now apply P].
  - destruct Q as (w & Hw & Q). exists w, (paley_particles.circle_centre w (r0 0%nat) (th0 0%nat)). split; [exact Hw|]. intros k Hk. destruct (Q k 0%nat Hk Hn) as [Q1 Q2]. split; [exact Q1|]. rewrite <- Q2.
    unfold paley_particles.circle_centre. rewrite RtoC_inv by exact Hw. unfold Cdiv. ring.
  - destruct P as [P1 P2]. intros k j Hk Hj. split; [now apply P1|now apply P2].
  - destruct Q as (w & c & Hw & Q). exists w. split; [exact Hw|]. intros k j Hk Hj. destruct (Q k Hk) as [Q1 Q2]. destruct (Q j Hj) as [_ Q4]. split; [exact Q1|].
    unfold paley_particles.circle_centre. rewrite RtoC_inv by exact Hw. unfold Cdiv in *. rewrite (Cmult_comm (/ RtoC w)%C), Q2, (Cmult_comm (/ RtoC w)%C), Q4. reflexivity.
Qed.
Lemma applied_is n adj x k : (k < n)%nat -> applied n adj x k = row n (lap n adj) k x.
Proof. intros Hk. rewrite paley_model.row_lap by exact Hk. unfold applied. apply Csum_ext. intros j _. unfold w. destruct (adj k j); ring. Qed.
Lemma potential_is n adj th : potential n adj th = W1 n adj th.
Proof. unfold potential, W1, Q. f_equal. apply Sum_ext. intros k Hk. rewrite applied_is by exact Hk. reflexivity. Qed.
Lemma own_is n adj l : own_value n adj l <-> exists x, (exists k, (k < n)%nat /\ x k <> RtoC 0) /\ paley_gradient.eigenvector n (lap n adj) (RtoC l) x.
Proof. split; intros (x & Nz & H); exists x; (split; [exact Nz|]); intros k Hk; specialize (H k Hk); rewrite ?applied_is in * by exact Hk; exact H. Qed.
Lemma mean_zero n th : (2 <= n)%nat -> (balanced n th <-> Csum n (fun k => expi (th k)) = RtoC 0).
Proof.
  intros Hn. pose proof (INR_pos n ltac:(lia)) as P. unfold balanced, order. change (phasors th) with (fun k => expi (th k)). split; intros H; [|rewrite H; ring].
  destruct (Ceq_dec (Csum n (fun k => expi (th k))) (RtoC 0)) as [E|E]; [exact E|]. exfalso. refine (Cmult_neq_0 _ _ _ E H). intros Z. injection Z as Z. pose proof (Rinv_0_lt_compat _ P). lra.
Qed.
Lemma bal_3_proved : bal_3.
Proof.
  intros n adj l th Hn S [s HC] CN [L1 L2] M. destruct (paley_bal.maximisers_balanced n adj s Hn S HC CN) as (l' & [[x [Nx Ex]] Lm] & Lp & _ & Mx).
  assert (E : l = l').
  { apply Rle_antisym; [|apply L2, own_is; now exists x]. apply own_is in L1. destruct L1 as (y & Ny & Ey). apply (Lm (RtoC l) y Ny Ey). }
  subst l'. destruct (Mx th) as [A B]; [intros q; rewrite <- !potential_is; apply M|]. split; [|apply mean_zero; assumption]. intros k Hk. rewrite applied_is by exact Hk. exact (A k Hk).
Qed.
Lemma bal_4_proved : bal_4.
Proof. intros n th Hn. rewrite <- (mean_zero n th Hn), <- (paley_bal.complete_maximisers n th Hn). unfold paley_bal.maximises. split; intros H q; specialize (H q); rewrite ?potential_is in *; rewrite <- ?potential_is; rewrite ?potential_is; exact H. Qed.
