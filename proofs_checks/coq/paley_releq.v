(* Paley et al., shape space and relative equilibria of r_k' = e^{i theta_k}, theta_k' = u_k.
     paley.releq, paley.thm3.stab (clause 1).
   The shape of a state are the numbers theta_kj = theta_k - theta_j (as e^{i theta_kj}) and s_kj = (r_k - r_j) e^{-i theta_k}. *)
From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums paley_model paley_phase paley_laplacian paley_gradient paley_fourier paley_particles paley_patterns paley_composite.
Open Scope R_scope.

Definition turn (th : nat -> R) (k j : nat) : C := expi (th k - th j).
Definition place (r : nat -> C) (th : nat -> R) (k j : nat) : C := ((r k - r j) * expi (- th k))%C.
(* two states of n particles have the same shape *)
Definition same_shape n (r : nat -> C) (th : nat -> R) (r' : nat -> C) (th' : nat -> R) : Prop :=
  forall k j, (k < n)%nat -> (j < n)%nat -> turn th k j = turn th' k j /\ place r th k j = place r' th' k j.
(* a rotation by a and a translation by b take the first state to the second; phases are angles *)
Definition moved n (a : R) (b : C) (r : nat -> C) (th : nat -> R) (r' : nat -> C) (th' : nat -> R) : Prop :=
  forall k, (k < n)%nat -> expi (th' k) = expi (th k + a) /\ r' k = (expi a * r k + b)%C.
(* controls that depend on the shape only *)
Definition shape_control n (u : (nat -> C) -> (nat -> R) -> nat -> R) : Prop :=
  forall r th r' th', same_shape n r th r' th' -> forall k, (k < n)%nat -> u r th k = u r' th' k.
(* the closed loop (1), (2) for all t >= 0 *)
Definition closed_loop n (u : (nat -> C) -> (nat -> R) -> nat -> R) (r : nat -> R -> C) (th : nat -> R -> R) : Prop :=
  forall k t, (k < n)%nat -> 0 <= t -> is_velocity (r k) t (expi (th k t)) /\ is_derive (th k) t (u (fun j => r j t) (fun j => th j t) k).
(* a relative equilibrium: the shape stays what it is *)
Definition shape_rests n (r : nat -> R -> C) (th : nat -> R -> R) : Prop :=
  forall t, 0 <= t -> same_shape n (fun k => r k 0) (fun k => th k 0) (fun k => r k t) (fun k => th k t).
(* parallel: nobody turns and all phases agree; circular: all turn at one rate u <> 0, and the centres of the circles agree *)
Definition parallel_formation n (v : nat -> R) (th : nat -> R) : Prop := forall k j, (k < n)%nat -> (j < n)%nat -> v k = 0 /\ expi (th k) = expi (th j).
Definition circular_formation n (v : nat -> R) (r : nat -> C) (th : nat -> R) : Prop := exists u, u <> 0 /\ forall k j, (k < n)%nat -> (j < n)%nat ->
  v k = u /\ circle_centre u (r k) (th k) = circle_centre u (r j) (th j).

(* ---- the rates of the shape depend on the shape alone ---- *)
Definition place_rate (v : nat -> R) (r : nat -> C) (th : nat -> R) (k j : nat) : C :=
  (RtoC 1 - turn th j k - Ci * RtoC (v k) * place r th k j)%C.
Lemma turn_derive n u r th k j t : closed_loop n u r th -> (k < n)%nat -> (j < n)%nat -> 0 <= t ->
  is_derive (fun s => th k s - th j s) t (u (fun i => r i t) (fun i => th i t) k - u (fun i => r i t) (fun i => th i t) j).
Proof. intros H Hk Hj Ht. apply (is_derive_minus (V := R_NormedModule)); now apply H. Qed.
Lemma product_derives (x y p q h : R -> R) t a b c d e : is_derive x t a -> is_derive y t b -> is_derive p t c -> is_derive q t d -> is_derive h t e ->
  is_derive (fun s => (x s - p s) * cos (- h s) - (y s - q s) * sin (- h s)) t
    ((a - c) * cos (h t) + (b - d) * sin (h t) + e * ((y t - q t) * cos (h t) - (x t - p t) * sin (h t))) /\
  is_derive (fun s => (x s - p s) * sin (- h s) + (y s - q s) * cos (- h s)) t
    ((b - d) * cos (h t) - (a - c) * sin (h t) - e * ((x t - p t) * cos (h t) + (y t - q t) * sin (h t))).
Proof.
  intros A B P Q H.
  assert (U : forall (f : R -> R) l, is_derive f t l -> Derive (fun s : R => f s) t = l) by (intros f l Hf; now apply is_derive_unique).
  pose proof (U _ _ A) as A'. pose proof (U _ _ B) as B'. pose proof (U _ _ P) as P'. pose proof (U _ _ Q) as Q'. pose proof (U _ _ H) as H'.
  split; (evar_last; [auto_derive; [repeat split; eexists; eassumption|reflexivity]|]); rewrite ?A', ?B', ?P', ?Q', ?H', ?sin_neg, ?cos_neg; ring.
Qed.
Lemma place_derive n u r th k j t : closed_loop n u r th -> (k < n)%nat -> (j < n)%nat -> 0 <= t ->
  is_velocity (fun s => place (fun i => r i s) (fun i => th i s) k j) t (place_rate (u (fun i => r i t) (fun i => th i t)) (fun i => r i t) (fun i => th i t) k j).
Proof.
  intros H Hk Hj Ht. destruct (H k t Hk Ht) as [[Ax Ay] At]. destruct (H j t Hj Ht) as [[Bx By] _].
  set (v := u (fun i => r i t) (fun i => th i t)) in *. destruct (product_derives _ _ _ _ _ t _ _ _ _ _ Ax Ay Bx By At) as [D1 D2].
  unfold place_rate, turn, place. pose proof (sin2_cos2 (th k t)) as S. unfold Rsqr in S.
  split; [evar_last; [eapply is_derive_ext; [|exact D1]|]|evar_last; [eapply is_derive_ext; [|exact D2]|]];
    try (intros s; unfold expi, Cmult, Cminus, Cplus, Copp; cbn [fst snd]; match goal with |- ?a = ?b => change (@eq R a b) end; ring);
    unfold expi, Cmult, Cminus, Cplus, Copp, RtoC, Ci; cbn [fst snd]; rewrite ?cos_minus, ?sin_minus, ?cos_neg, ?sin_neg.
  - transitivity (cos (th k t) * cos (th k t) + sin (th k t) * sin (th k t) - (cos (th j t) * cos (th k t) + sin (th j t) * sin (th k t)) +
      v k * ((snd (r k t) - snd (r j t)) * cos (th k t) - (fst (r k t) - fst (r j t)) * sin (th k t))); [ring|].
    replace (cos (th k t) * cos (th k t) + sin (th k t) * sin (th k t)) with 1 by lra. ring.
  - ring.
Qed.
(* the shape variables and their rates at one instant are those of any other closed loop under the same controls in the same shape *)
Theorem evolves_on_shapes n u : shape_control n u -> forall r th r' th' t t', closed_loop n u r th -> closed_loop n u r' th' -> 0 <= t -> 0 <= t' ->
  same_shape n (fun k => r k t) (fun k => th k t) (fun k => r' k t') (fun k => th' k t') -> forall k j, (k < n)%nat -> (j < n)%nat -> exists (d : R) (e : C),
  is_derive (fun s => th k s - th j s) t d /\ is_derive (fun s => th' k s - th' j s) t' d /\
  is_velocity (fun s => place (fun i => r i s) (fun i => th i s) k j) t e /\ is_velocity (fun s => place (fun i => r' i s) (fun i => th' i s) k j) t' e.
Proof.
  intros U r th r' th' t t' H H' Ht Ht' S k j Hk Hj. pose proof (U _ _ _ _ S) as E.
  exists (u (fun i => r i t) (fun i => th i t) k - u (fun i => r i t) (fun i => th i t) j), (place_rate (u (fun i => r i t) (fun i => th i t)) (fun i => r i t) (fun i => th i t) k j).
  split; [now apply (turn_derive n u r th)|]. split; [rewrite (E k Hk), (E j Hj); now apply (turn_derive n u r' th')|]. split; [now apply (place_derive n u)|].
  replace (place_rate (u (fun i => r i t) (fun i => th i t)) (fun i => r i t) (fun i => th i t) k j) with (place_rate (u (fun i => r' i t') (fun i => th' i t')) (fun i => r' i t') (fun i => th' i t') k j);
    [now apply (place_derive n u)|].
  unfold place_rate. destruct (S j k Hj Hk) as [-> _]. destruct (S k j Hk Hj) as [_ ->]. now rewrite (E k Hk).
Qed.
(* ---- three dimensions fewer: the orbits of rotations and translations, which act freely, are the sets of one shape, and 3 (n - 1) numbers that can be anything, the
   places of the others as the first one sees them, fix the shape ---- *)
Lemma expi_eq a b c d : expi a = expi b -> expi c = expi d -> expi (a + c) = expi (b + d) /\ expi (a - c) = expi (b - d).
Proof.
  intros E F. split; [now rewrite !expi_plus, E, F|]. unfold expi in *. rewrite !cos_minus, !sin_minus. injection E as -> ->. injection F as -> ->. reflexivity.
Qed.
Theorem orbits n (r r' : nat -> C) (th th' : nat -> R) : (1 <= n)%nat -> (same_shape n r th r' th' <-> exists a b, moved n a b r th r' th').
Proof.
  intros Hn. split.
  - intros S. exists (th' 0%nat - th 0%nat), (r' 0%nat - expi (th' 0%nat - th 0%nat) * r 0%nat)%C. intros k Hk. destruct (S k 0%nat Hk Hn) as [T P]. unfold turn in T.
    assert (E : expi (th' k) = expi (th k + (th' 0%nat - th 0%nat))).
    { replace (th' k) with ((th' k - th' 0%nat) + th' 0%nat) by ring. replace (th k + (th' 0%nat - th 0%nat)) with ((th k - th 0%nat) + th' 0%nat) by ring. now rewrite !expi_plus, T. }
    split; [exact E|]. unfold place in P.
    assert (Q : (expi (th' k) * ((r' k - r' 0%nat) * expi (- th' k)))%C = (r' k - r' 0%nat)%C).
    { replace (expi (th' k) * ((r' k - r' 0%nat) * expi (- th' k)))%C with ((expi (th' k) * expi (- th' k)) * (r' k - r' 0%nat))%C by ring. rewrite <- expi_plus, Rplus_opp_r, expi_0. ring. }
    assert (Q2 : (expi (th' k) * ((r k - r 0%nat) * expi (- th k)))%C = (expi (th' 0%nat - th 0%nat) * (r k - r 0%nat))%C).
    { rewrite E. rewrite expi_plus. replace (expi (th k) * expi (th' 0%nat - th 0%nat) * ((r k - r 0%nat) * expi (- th k)))%C with ((expi (th k) * expi (- th k)) * (expi (th' 0%nat - th 0%nat) * (r k - r 0%nat)))%C by ring.
      rewrite <- expi_plus, Rplus_opp_r, expi_0. ring. }
    rewrite <- P in Q. rewrite Q2 in Q. replace (r' k) with ((r' k - r' 0%nat) + r' 0%nat)%C by ring. rewrite <- Q. ring.
  - intros (a & b & M) k j Hk Hj. destruct (M k Hk) as [Tk Rk]. destruct (M j Hj) as [Tj Rj]. split.
    + unfold turn. destruct (expi_eq _ _ _ _ Tk Tj) as [_ ->]. f_equal. ring.
    + unfold place. rewrite Rk, Rj. assert (E : expi (- th' k) = (expi (- th k) * expi (- a))%C).
      { rewrite <- expi_plus. pose proof (proj2 (expi_eq 0 0 _ _ eq_refl Tk)) as Q. rewrite !Rminus_0_l in Q. rewrite Q. f_equal. ring. }
      rewrite E. replace ((expi a * r k + b - (expi a * r j + b)) * (expi (- th k) * expi (- a)))%C with ((expi a * expi (- a)) * ((r k - r j) * expi (- th k)))%C by ring.
      rewrite <- expi_plus, Rplus_opp_r, expi_0. ring.
Qed.
Theorem free_action n a b r th : (1 <= n)%nat -> moved n a b r th r th -> expi a = RtoC 1 /\ b = RtoC 0.
Proof.
  intros Hn M. destruct (M 0%nat Hn) as [T P].
  assert (E : expi a = RtoC 1).
  { replace a with ((th 0%nat + a) - th 0%nat) by ring. rewrite (proj2 (expi_eq (th 0%nat + a) (th 0%nat) (th 0%nat) (th 0%nat) (eq_sym T) eq_refl)). now rewrite Rminus_eq_0, expi_0. }
  split; [exact E|]. rewrite E in P. replace b with (r 0%nat - r 0%nat)%C; [ring|]. rewrite P at 1. ring.
Qed.
Theorem shape_coordinates n : (1 <= n)%nat ->
  (forall (s : nat -> C) (a : nat -> R), exists r th, r 0%nat = RtoC 0 /\ th 0%nat = 0 /\ forall k, (1 <= k < n)%nat -> place r th 0 k = s k /\ turn th k 0 = expi (a k)) /\
  (forall r th r' th', (forall k, (1 <= k < n)%nat -> place r th 0 k = place r' th' 0 k /\ turn th k 0 = turn th' k 0) <-> same_shape n r th r' th').
Proof.
  intros Hn. split.
  - intros s a. exists (fun k => if Nat.eqb k 0 then RtoC 0 else (- s k)%C), (fun k => if Nat.eqb k 0 then 0 else a k). split; [reflexivity|]. split; [reflexivity|].
    intros k Hk. destruct k as [|k]; [lia|]. unfold place, turn. cbn [Nat.eqb]. rewrite Ropp_0, expi_0, Rminus_0_r. split; [ring|reflexivity].
  - intros r th r' th'. split; [|intros S k Hk; split; apply S; lia]. intros H.
    assert (T : forall k, (k < n)%nat -> turn th k 0 = turn th' k 0).
    { intros k Hk. destruct k as [|k]; [unfold turn; now rewrite !Rminus_eq_0|apply H; lia]. }
    assert (P : forall k, (k < n)%nat -> place r th 0 k = place r' th' 0 k).
    { intros k Hk. destruct k as [|k]; [unfold place; ring|apply H; lia]. }
    intros k j Hk Hj. unfold turn in T. split.
    + unfold turn. replace (th k - th j) with ((th k - th 0%nat) - (th j - th 0%nat)) by ring. replace (th' k - th' j) with ((th' k - th' 0%nat) - (th' j - th' 0%nat)) by ring.
      now apply expi_eq; apply T.
    + assert (E : forall (x : nat -> C) (h : nat -> R), place x h k j = ((place x h 0 j - place x h 0 k) * expi (0 - (h k - h 0%nat)))%C).
      { intros x h. unfold place. replace (- h k) with (- h 0%nat + (0 - (h k - h 0%nat))) by ring. rewrite expi_plus. ring. }
      rewrite !E, (P j Hj), (P k Hk). f_equal. now apply expi_eq; [|apply T].
Qed.
Theorem three_fewer n : (1 <= n)%nat ->
  (forall r th r' th', same_shape n r th r' th' <-> exists a b, moved n a b r th r' th') /\
  (forall a b r th, moved n a b r th r th -> expi a = RtoC 1 /\ b = RtoC 0) /\
  (forall (s : nat -> C) (a : nat -> R), exists r th, forall k, (1 <= k < n)%nat -> place r th 0 k = s k /\ turn th k 0 = expi (a k)) /\
  (forall r th r' th', (forall k, (1 <= k < n)%nat -> place r th 0 k = place r' th' 0 k /\ turn th k 0 = turn th' k 0) <-> same_shape n r th r' th').
Proof.
  intros Hn. destruct (shape_coordinates n Hn) as [A B]. split; [intros; now apply orbits|]. split; [intros a b r th; now apply free_action|]. split; [|exact B].
  intros s a. destruct (A s a) as (r & th & _ & _ & H). now exists r, th.
Qed.
(* ---- relative equilibria ---- *)
Lemma constant_velocity (f : R -> C) (d : R -> C) : (forall t, 0 <= t -> is_velocity f t (d t)) -> (forall t, 0 <= t -> f t = f 0) -> forall t, 0 < t -> d t = RtoC 0.
Proof.
  intros D F t Ht. destruct (D t (Rlt_le _ _ Ht)) as [D1 D2].
  assert (K : forall g : R -> R, (forall s, 0 <= s -> g s = g 0) -> forall e, is_derive g t e -> e = 0).
  { intros g G e De. apply is_derive_unique in De. rewrite <- De. transitivity (Derive (fun _ => g 0) t); [|apply Derive_const].
    apply Derive_ext_loc. exists (mkposreal t Ht). intros s Hs. apply G. unfold ball in Hs. cbn in Hs. unfold AbsRing_ball, abs, minus, plus, opp in Hs. cbn in Hs. apply Rabs_lt_between in Hs. lra. }
  apply injective_projections; cbn; [apply (K (fun s => fst (f s)))|apply (K (fun s => snd (f s)))]; try assumption; intros s Hs; now rewrite (F s Hs).
Qed.
(* a state is a relative equilibrium if a motion from it keeps its shape *)
Definition relative_equilibrium n u (r0 : nat -> C) (th0 : nat -> R) : Prop := exists (r : nat -> R -> C) (th : nat -> R -> R),
  closed_loop n u r th /\ (forall k, (k < n)%nat -> r k 0 = r0 k /\ th k 0 = th0 k) /\ shape_rests n r th.
Lemma same_shape_refl n r th r' th' : (forall k, (k < n)%nat -> r k = r' k /\ th k = th' k) -> same_shape n r th r' th'.
Proof. intros H k j Hk Hj. destruct (H k Hk) as [A B]. destruct (H j Hj) as [C D]. unfold turn, place. now rewrite A, B, C, D. Qed.
Lemma same_shape_trans n r th r' th' r'' th'' : same_shape n r th r' th' -> same_shape n r' th' r'' th'' -> same_shape n r th r'' th''.
Proof. intros A B k j Hk Hj. destruct (A k j Hk Hj) as [-> ->]. now apply B. Qed.
Lemma same_shape_sym n r th r' th' : same_shape n r th r' th' -> same_shape n r' th' r th.
Proof. intros A k j Hk Hj. destruct (A k j Hk Hj) as [-> ->]. now split. Qed.
(* what the vanishing of the rates says *)
Lemma centres_from_rates v r th k j : v <> 0 -> (RtoC 1 - turn th j k - Ci * RtoC v * place r th k j)%C = RtoC 0 -> circle_centre v (r k) (th k) = circle_centre v (r j) (th j).
Proof.
  intros Hv Z. assert (E : (circle_centre v (r k) (th k) - circle_centre v (r j) (th j))%C = (RtoC (/ v) * Ci * (expi (th k) * (RtoC 1 - turn th j k - Ci * RtoC v * place r th k j)))%C).
  { unfold circle_centre, turn, place. replace (th j - th k) with (th j + - th k) by ring. rewrite expi_plus.
    assert (O : (expi (th k) * expi (- th k))%C = RtoC 1) by (rewrite <- expi_plus, Rplus_opp_r; apply expi_0).
    assert (V : (RtoC (/ v) * RtoC v)%C = RtoC 1) by (rewrite <- RtoC_mult, Rinv_l by exact Hv; reflexivity).
    assert (I : (Ci * Ci)%C = (- RtoC 1)%C) by (apply injective_projections; cbn; ring).
    replace (RtoC (/ v) * Ci * (expi (th k) * (RtoC 1 - expi (th j) * expi (- th k) - Ci * RtoC v * ((r k - r j) * expi (- th k)))))%C
      with (RtoC (/ v) * Ci * (expi (th k) - (expi (th k) * expi (- th k)) * expi (th j)) - (RtoC (/ v) * RtoC v) * (Ci * Ci) * ((r k - r j) * (expi (th k) * expi (- th k))))%C by ring.
    rewrite O, V, I. ring. }
  rewrite Z in E. replace (circle_centre v (r k) (th k)) with ((circle_centre v (r k) (th k) - circle_centre v (r j) (th j)) + circle_centre v (r j) (th j))%C by ring. rewrite E. ring.
Qed.
Lemma turn_velocity (p q : R -> R) t a b : is_derive p t a -> is_derive q t b -> is_velocity (fun s => expi (p s - q s)) t (RtoC (a - b) * (Ci * expi (p t - q t)))%C.
Proof.
  intros A B. assert (D : is_derive (fun s => p s - q s) t (a - b)) by (now apply (is_derive_minus (V := R_NormedModule))).
  set (h := fun s => p s - q s). change (is_derive h t (a - b)) in D. change (is_velocity (fun s => expi (h s)) t (RtoC (a - b) * (Ci * expi (h t)))%C). clearbody h.
  split; unfold expi; cbn [fst snd]; (evar_last; [auto_derive; [repeat split; exists (a - b); exact D|reflexivity]|]);
    replace (Derive (fun s : R => h s) t) with (a - b) by (symmetry; now apply is_derive_unique); cbn; ring.
Qed.
Theorem relative_equilibria n u r0 th0 : shape_control n u ->
  (relative_equilibrium n u r0 th0 <-> parallel_formation n (u r0 th0) th0 \/ circular_formation n (u r0 th0) r0 th0).
Proof.
  intros U. split.
  - intros (r & th & L & I & S).
    assert (S0 : forall t, 0 <= t -> same_shape n r0 th0 (fun k => r k t) (fun k => th k t)).
    { intros t Ht. apply same_shape_trans with (2 := S t Ht). apply same_shape_refl. intros k Hk. destruct (I k Hk) as [-> ->]. now split. }
    assert (V : forall k t, (k < n)%nat -> 0 <= t -> u (fun j => r j t) (fun j => th j t) k = u r0 th0 k) by (intros k t Hk Ht; symmetry; apply (U _ _ _ _ (S0 t Ht)); exact Hk).
    assert (Eq : forall k j, (k < n)%nat -> (j < n)%nat -> u r0 th0 k = u r0 th0 j).
    { intros k j Hk Hj. pose proof (constant_velocity (fun s => expi (th k s - th j s)) (fun s => (RtoC (u r0 th0 k - u r0 th0 j) * (Ci * expi (th k s - th j s)))%C)) as K.
      specialize (K (fun t Ht => turn_velocity (th k) (th j) t _ _ (eq_ind _ (is_derive (th k) t) (proj2 (L k t Hk Ht)) _ (V k t Hk Ht)) (eq_ind _ (is_derive (th j) t) (proj2 (L j t Hj Ht)) _ (V j t Hj Ht)))).
      specialize (K (fun t Ht => eq_trans (eq_sym (proj1 (S0 t Ht k j Hk Hj))) (proj1 (S0 0 (Rle_refl 0) k j Hk Hj))) 1 Rlt_0_1).
      assert (M : (u r0 th0 k - u r0 th0 j) ^ 2 = 0).
      { injection K as K1 K2. cbn in K1, K2. set (x := u r0 th0 k - u r0 th0 j) in *. set (h := th k 1 - th j 1) in *. pose proof (sin2_cos2 h) as SC. unfold Rsqr in SC.
        assert (K1' : x * sin h = 0) by lra. assert (K2' : x * cos h = 0) by lra. replace (x ^ 2) with (x * sin h * (x * sin h) + x * cos h * (x * cos h)); [rewrite K1', K2'; ring|].
        replace (x * sin h * (x * sin h) + x * cos h * (x * cos h)) with (x ^ 2 * (sin h * sin h + cos h * cos h)) by ring. rewrite SC. ring. }
      apply Rminus_diag_uniq, Rsqr_0_uniq. rewrite Rsqr_pow2. exact M. }
    assert (Z : forall k j, (k < n)%nat -> (j < n)%nat -> (RtoC 1 - turn th0 j k - Ci * RtoC (u r0 th0 k) * place r0 th0 k j)%C = RtoC 0).
    { intros k j Hk Hj. pose proof (constant_velocity _ _ (fun t Ht => place_derive n u r th k j t L Hk Hj Ht)) as K.
      specialize (K (fun t Ht => eq_trans (eq_sym (proj2 (S0 t Ht k j Hk Hj))) (proj2 (S0 0 (Rle_refl 0) k j Hk Hj))) 1 Rlt_0_1). unfold place_rate in K.
      destruct (S0 1 ltac:(lra) j k Hj Hk) as [T _]. destruct (S0 1 ltac:(lra) k j Hk Hj) as [_ P]. rewrite T, P. rewrite (V k 1 Hk ltac:(lra)) in K. exact K. }
    destruct n as [|m]; [left; intros k j Hk; lia|]. destruct (Req_dec (u r0 th0 0%nat) 0) as [E|E].
    + left. intros k j Hk Hj. specialize (Z k j Hk Hj). rewrite (Eq k 0%nat Hk ltac:(lia)), E in Z. rewrite (Eq k 0%nat Hk ltac:(lia)). split; [exact E|].
      assert (T : turn th0 j k = RtoC 1). { replace (turn th0 j k) with (RtoC 1 - (RtoC 1 - turn th0 j k - Ci * RtoC 0 * place r0 th0 k j))%C by (unfold place; ring). rewrite Z. ring. }
      unfold turn in T. replace (th0 j) with ((th0 j - th0 k) + th0 k) by ring. rewrite expi_plus, T. ring.
    + right. exists (u r0 th0 0%nat). split; [exact E|]. intros k j Hk Hj. split; [apply Eq; [exact Hk|lia]|]. apply centres_from_rates; [exact E|]. rewrite <- (Eq k 0%nat Hk ltac:(lia)). now apply Z.
  - assert (Stay : forall (r : nat -> R -> C) (th : nat -> R -> R), (forall k, (k < n)%nat -> r k 0 = r0 k /\ th k 0 = th0 k) -> shape_rests n r th ->
      (forall k t, (k < n)%nat -> 0 <= t -> is_velocity (r k) t (expi (th k t)) /\ is_derive (th k) t (u r0 th0 k)) -> relative_equilibrium n u r0 th0).
    { intros r th I S D. exists r, th. split; [|now split]. intros k t Hk Ht. destruct (D k t Hk Ht) as [A B]. split; [exact A|].
      replace (u (fun j => r j t) (fun j => th j t) k) with (u r0 th0 k); [exact B|]. apply U; [|exact Hk]. apply same_shape_trans with (2 := S t Ht).
      apply same_shape_refl. intros j Hj. destruct (I j Hj) as [-> ->]. now split. }
    intros [P|(w & Hw & Cc)].
    + apply (Stay (fun k t => (r0 k + RtoC t * expi (th0 k))%C) (fun k _ => th0 k)).
      * intros k _. split; [|reflexivity]. apply injective_projections; cbn; ring.
      * intros t _ k j Hk Hj. split; [reflexivity|]. unfold place. destruct (P k j Hk Hj) as [_ ->]. ring.
      * intros k t Hk _. destruct (P k k Hk Hk) as [-> _]. split; [|apply (is_derive_const (V := R_NormedModule))].
        split; cbn; (evar_last; [auto_derive; [easy|reflexivity]|cbn; ring]).
    + destruct n as [|m]; [apply (Stay (fun k _ => r0 k) (fun k _ => th0 k)); [intros; lia|intros t _ k j Hk; lia|intros; lia]|].
      set (c := circle_centre w (r0 0%nat) (th0 0%nat)).
      assert (R0 : forall k, (k < S m)%nat -> r0 k = (c - RtoC (/ w) * (Ci * expi (th0 k)))%C).
      { intros k Hk. destruct (Cc k 0%nat Hk ltac:(lia)) as [_ E]. fold c in E. unfold circle_centre in E. rewrite <- E. ring. }
      apply (Stay (fun k t => (c - RtoC (/ w) * (Ci * expi (th0 k + w * t)))%C) (fun k t => th0 k + w * t)).
      * intros k Hk. rewrite (R0 k Hk). rewrite Rmult_0_r, Rplus_0_r. now split.
      * intros t _. apply orbits; [lia|]. exists (w * t), (c - expi (w * t) * c)%C. intros k Hk. rewrite Rmult_0_r, Rplus_0_r. split; [reflexivity|]. rewrite expi_plus. ring.
      * intros k t Hk _. destruct (Cc k k Hk Hk) as [-> _]. split; [|auto_derive; [easy|ring]].
        split; cbn; (evar_last; [auto_derive; [easy|reflexivity]|cbn; field; exact Hw]).
Qed.
(* ---- patterns: paley.thm3.stab, clause 1 ---- *)
(* the control (5) with the negative gradient of (25) and (20), as a function of the state *)
Definition pattern_law n adj w0 K0 M K (r : nat -> C) (th : nat -> R) (k : nat) : R := w0 - gUMN n M K th k + w0 * (K0 / INR n * aS n adj w0 r th k).
Lemma pattern_turned M n th a : pattern M n th -> pattern M n (fun k => th k + a).
Proof.
  intros (HM & th0 & cl & A & B). split; [exact HM|]. exists (th0 + a), cl. split; [|exact B]. intros k Hk. destruct (A k Hk) as [A1 A2]. split; [exact A1|].
  replace (th0 + a + 2 * PI * INR (cl k) / INR M) with ((th0 + 2 * PI * INR (cl k) / INR M) + a) by ring. rewrite (expi_plus (th k)), A2. symmetry. apply expi_plus.
Qed.
Lemma pattern_gradient M n K th k : (1 <= n)%nat -> pattern M n th -> (k < n)%nat -> gUMN n M K th k = 0.
Proof.
  intros Hn P Hk. destruct (eq23 M n th Hn P) as [Z _]. unfold gUMN. apply Sum_zero. intros i Hi. assert (G : g1 n (multiple (S i) th) k = 0); [|rewrite G; ring].
  destruct (Nat.eq_dec (S i) M) as [E|E].
  - destruct P as (HM & th0 & cl & A & _). pose proof (INR_pos M HM) as PM. rewrite g1_sines. assert (Q : Sum n (fun j => sin (multiple (S i) th j - multiple (S i) th k)) = 0); [|rewrite Q; ring].
    apply Sum_zero. intros j Hj. rewrite E. unfold multiple.
    assert (Same : forall m, (m < n)%nat -> expi (INR M * th m) = expi (INR M * th0)).
    { intros m Hm. rewrite (expi_mult_nat M _ _ (proj2 (A m Hm))). replace (INR M * (th0 + 2 * PI * INR (cl m) / INR M)) with (2 * PI * IZR (Z.of_nat (cl m)) + INR M * th0) by (rewrite <- INR_IZR_INZ; field; lra).
      rewrite expi_plus, expi_2PI. apply Cmult_1_l. }
    pose proof (f_equal snd (expi_inj_minus _ _ (eq_trans (Same j Hj) (eq_sym (Same k Hk))))) as F. exact F.
  - assert (B : balanced n (multiple (S i) th)) by (apply moment_0; [exact Hn|lia|apply Z; lia]). unfold g1. unfold balanced in B. rewrite B, inner_xy. cbn. ring.
Qed.
Lemma one_centre n adj w0 r th k c : (forall j, (j < n)%nat -> circle_centre w0 (r j) (th j) = c) -> (k < n)%nat -> aS n adj w0 r th k = 0.
Proof.
  intros H Hk. unfold aS. rewrite row_lap by exact Hk. rewrite Csum_0; [rewrite inner_xy; cbn; ring|]. intros j Hj. unfold centres. rewrite (H k Hk), (H j Hj). ring.
Qed.
(* every circular formation of radius 1/|w0| whose phases are an (M,N)-pattern *)
Theorem pattern_equilibrium n adj w0 K0 M K r0 th0 : (1 <= n)%nat -> w0 <> 0 -> pattern M n th0 ->
  (forall k j, (k < n)%nat -> (j < n)%nat -> circle_centre w0 (r0 k) (th0 k) = circle_centre w0 (r0 j) (th0 j)) ->
  relative_equilibrium n (pattern_law n adj w0 K0 M K) r0 th0 /\ forall k, (k < n)%nat -> pattern_law n adj w0 K0 M K r0 th0 k = w0.
Proof.
  intros Hn Hw P Cc. set (c := circle_centre w0 (r0 0%nat) (th0 0%nat)).
  assert (R0 : forall k, (k < n)%nat -> r0 k = (c - RtoC (/ w0) * (Ci * expi (th0 k)))%C).
  { intros k Hk. pose proof (Cc k 0%nat Hk ltac:(lia)) as E. fold c in E. unfold circle_centre in E. rewrite <- E. ring. }
  assert (Law : forall r th, pattern M n th -> (forall k, (k < n)%nat -> circle_centre w0 (r k) (th k) = c) -> forall k, (k < n)%nat -> pattern_law n adj w0 K0 M K r th k = w0).
  { intros r th Pt Ct k Hk. unfold pattern_law. rewrite (pattern_gradient M n K th k Hn Pt Hk), (one_centre n adj w0 r th k c Ct Hk). ring. }
  split; [|apply Law; [exact P|intros k Hk; apply Cc; [exact Hk|lia]]].
  exists (fun k t => (c - RtoC (/ w0) * (Ci * expi (th0 k + w0 * t)))%C), (fun k t => th0 k + w0 * t). split; [|split].
  - intros k t Hk _. rewrite Law; [|apply (pattern_turned M n th0 (w0 * t) P)|intros j _; unfold circle_centre; ring|exact Hk]. split; [|auto_derive; [easy|ring]].
    split; cbn; (evar_last; [auto_derive; [easy|reflexivity]|cbn; field; exact Hw]).
  - intros k Hk. rewrite (R0 k Hk). rewrite Rmult_0_r, Rplus_0_r. now split.
  - intros t _. apply orbits; [exact Hn|]. exists (w0 * t), (c - expi (w0 * t) * c)%C. intros k Hk. rewrite Rmult_0_r, Rplus_0_r. split; [reflexivity|]. rewrite expi_plus. ring.
Qed.
