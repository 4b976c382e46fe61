(* lambda_2 in the words of the clauses of Tanner's second paper: the second smallest eigenvalue of the Laplacian counted with multiplicity,
   so the second entry of an ordered list of all of them: tanner2.L clause 5, tanner2.cor2_sub clause 2, tanner2.cor2_rate clauses 3, 4; and
   tanner2.S_config clause 2, tanner2.vdotB clause 2, tanner2.L clause 4, tanner1.L.ones clause 2 with rates and gradients as derivatives.
   Stated after the theorems had been seen; the theorems prove them. *)
From Coq Require Import Reals Lra Lia List Relations Psatz Classical.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums paley_model paley_phase tanner_energy.
From Flockproof Require tanner_graph tanner2_filippov tanner2_facts tanner2_connectivity audit_independent_tanner2.
Import tanner2_filippov(both, both_sym).
Module T := audit_independent_tanner2.
Open Scope R_scope.

(* x is an eigenvector of L = D - A for lam *)
Definition belongs n (adj : graph) (lam : R) (x : nat -> R) := (exists i, (i < n)%nat /\ x i <> 0) /\
  forall i, (i < n)%nat -> Sum n (fun j => if adj i j then x i - x j else 0) = lam * x i.
(* l 0 <= l 1 <= .. are all eigenvalues, each as often as it counts: their eigenvectors are an orthonormal basis *)
Definition spectrum n (adj : graph) (l : nat -> R) (b : nat -> nat -> R) :=
  (forall k, (k < n)%nat -> belongs n adj (l k) (b k)) /\ (forall k m, (k <= m)%nat -> (m < n)%nat -> l k <= l m) /\
  (forall k m, (k < n)%nat -> (m < n)%nat -> Sum n (fun i => b k i * b m i) = if Nat.eqb k m then 1 else 0) /\
  (forall x, exists a, forall i, (i < n)%nat -> x i = Sum n (fun k => a k * b k i)).
Definition lambda2 n adj lam := exists l b, spectrum n adj l b /\ lam = l 1%nat.
Definition connectivity_positive : Prop := forall n adj lam, (2 <= n)%nat -> T.simple_graph adj -> strongly_connected n adj -> lambda2 n adj lam -> 0 < lam.
Definition rate_of_W : Prop := forall n adj V V' r v t lam xp xn yp yn d, (2 <= n)%nat -> T.simple_graph adj -> strongly_connected n adj ->
  T.potentials n adj V V' -> T.motion n adj V' r v -> 0 <= t -> lambda2 n adj lam -> T.parts n (fun i => v i t) xp xn yp yn -> T.Wdot n adj V r v t d ->
  d <= - lam * (Sum n (fun i => xn i ^ 2) + Sum n (fun i => yn i ^ 2)).
Definition alignment : Prop := forall n adj lam (v : nat -> R -> C), (2 <= n)%nat -> T.simple_graph adj -> strongly_connected n adj -> lambda2 n adj lam ->
  (forall t i, 0 <= t -> (i < n)%nat -> is_velocity (v i) t (- Csum n (fun j => if adj i j then v i t - v j t else 0))%C) ->
  let mean t := (RtoC (/ INR n) * Csum n (fun j => v j t))%C in let dev t := sqrt (Sum n (fun i => Cmod (v i t - mean t)%C ^ 2)) in
  forall t, 0 <= t -> dev t <= exp (- lam * t) * dev 0 /\
    ((forall i, (i < n)%nat -> Csum n (fun j => if adj i j then (v i 0 - mean 0) - (v j 0 - mean 0) else 0)%C = (RtoC lam * (v i 0 - mean 0))%C) ->
     dev t = exp (- lam * t) * dev 0).
Definition edges_raise : Prop := forall n adj more lam mu, (2 <= n)%nat -> T.simple_graph adj -> T.simple_graph more ->
  (forall i j, adj i j = true -> more i j = true) -> lambda2 n adj lam -> lambda2 n more mu -> lam <= mu.
Definition rest_of_W : Prop := forall n adj V V' r v t, T.simple_graph adj -> strongly_connected n adj -> T.potentials n adj V V' ->
  T.motion n adj V' r v -> 0 <= t -> T.Wdot n adj V r v t 0 -> forall i j, (i < n)%nat -> (j < n)%nat ->
  v i t = v j t /\ is_velocity (fun s => r i s - r j s)%C t 0%C.
(* the gradient of V_ij(|z|) at z = r_ij: along every straight line through r_ij it gives the derivative; B has -1 where an arc leaves *)
Definition incidence : Prop := forall n adj V V' r v O t, T.simple_graph adj -> T.potentials n adj V V' -> T.motion n adj V' r v -> 0 <= t ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> v i t = v j t) -> tanner_graph.oriented n adj O -> exists g : nat * nat -> C,
  (forall i j, In (i, j) O -> forall u : C, is_derive (fun h => V i j (Cmod (r i t - r j t + RtoC h * u)%C)) 0 (fst (g (i, j)) * fst u + snd (g (i, j)) * snd u)) /\
  forall k, (k < n)%nat -> let b (f : nat * nat) := (if Nat.eqb k (snd f) then 1 else 0) - (if Nat.eqb k (fst f) then 1 else 0) in
    is_velocity (v k) t (fold_right (fun f s => b f * fst (g f) + s) 0 O, fold_right (fun f s => b f * snd (g f) + s) 0 O).
Definition zero_vectors : Prop := forall n adj (x : nat -> R), (1 <= n)%nat -> T.simple_graph adj -> strongly_connected n adj ->
  ((forall i, (i < n)%nat -> Sum n (fun j => if adj i j then x i - x j else 0) = 0) <-> exists c, forall i, (i < n)%nat -> x i = c).

(* ---- the theorems prove them ---- *)
Lemma drops n (adj : graph) (x : nat -> R) i : (i < n)%nat -> Sum n (fun j => if adj i j then x i - x j else 0) = Sum n (fun j => lap n adj i j * x j).
Proof. intros Hi. rewrite tanner2_facts.lap_apply by exact Hi. apply Sum_ext. intros j _. unfold w. destruct (adj i j); ring. Qed.
Lemma belongs_eigen n adj lam x : belongs n adj lam x -> tanner2_connectivity.eigen n adj lam x.
Proof. intros [_ E] i Hi. rewrite <- drops by exact Hi. now apply E. Qed.
Lemma ones_eigen n adj c : tanner2_connectivity.eigen n adj 0 (fun _ => c).
Proof. intros i Hi. rewrite <- drops by exact Hi. rewrite Rmult_0_l. apply Sum_zero. intros j _. destruct (adj i j); ring. Qed.
Lemma apart n adj lam mu x y : undirected adj -> tanner2_connectivity.eigen n adj lam x -> tanner2_connectivity.eigen n adj mu y -> lam <> mu ->
  Sum n (fun i => x i * y i) = 0.
Proof.
  intros S X Y N. assert (E : lam * Sum n (fun i => x i * y i) = mu * Sum n (fun i => x i * y i)); [|].
  - rewrite <- !Sum_scal. transitivity (Sum n (fun i => Sum n (fun j => lap n adj i j * x j * y i))).
    + apply Sum_ext. intros i Hi. rewrite (Sum_scal_r n (y i) (fun j => lap n adj i j * x j)), (X i Hi). ring.
    + rewrite Sum_swap. apply Sum_ext. intros j Hj.
      rewrite (Sum_ext n _ (fun i => x j * (lap n adj j i * y i))) by (intros i _; rewrite (lap_sym n adj S i j); ring). rewrite Sum_scal, (Y j Hj). ring.
  - assert ((lam - mu) * Sum n (fun i => x i * y i) = 0) by lra. apply Rmult_integral in H. destruct H; [lra|assumption].
Qed.
Lemma not_below n adj lam x : undirected adj -> tanner2_connectivity.eigen n adj lam x -> 0 < Sum n (fun i => x i * x i) -> 0 <= lam.
Proof.
  intros S E P. pose proof (tanner2_connectivity.q_ge0 n adj S x) as Q. rewrite (tanner2_connectivity.qform_eigen n adj lam x E) in Q.
  apply Rnot_lt_le. intros L. nra.
Qed.
Lemma second_entry n adj lam : (2 <= n)%nat -> undirected adj -> lambda2 n adj lam -> tanner2_connectivity.second_eigenvalue n adj lam.
Proof.
  intros Hn S (l & b & (B & Or & On & Sp) & ->). assert (Pn : 0 < INR n) by (apply lt_0_INR; lia).
  assert (Eb : forall k, (k < n)%nat -> tanner2_connectivity.eigen n adj (l k) (b k)) by (intros k Hk; apply belongs_eigen; now apply B).
  assert (U : forall k, (k < n)%nat -> Sum n (fun i => b k i * b k i) = 1) by (intros k Hk; rewrite (On k k Hk Hk), Nat.eqb_refl; reflexivity).
  assert (C0 : forall k c, (k < n)%nat -> (forall i, (i < n)%nat -> b k i = c) -> c <> 0 /\ l k = 0).
  { intros k c Hk E. assert (Nc : c <> 0).
    { intros Z. specialize (U k Hk). rewrite (Sum_zero n) in U; [lra|]. intros i Hi. rewrite (E i Hi), Z. ring. }
    split; [exact Nc|]. pose proof (ones_eigen n adj c 0%nat ltac:(lia)) as O. pose proof (Eb k Hk 0%nat ltac:(lia)) as E0.
    rewrite (Sum_ext n _ (fun j => lap n adj 0 j * c)) in E0 by (intros j Hj; now rewrite (E j Hj)). rewrite O, (E 0%nat ltac:(lia)) in E0.
    assert (l k * c = 0) by lra. apply Rmult_integral in H. destruct H; [assumption|contradiction]. }
  assert (V : forall x, ~ tanner2_connectivity.varies n x -> forall i, (i < n)%nat -> x i = x 0%nat).
  { intros x N i Hi. apply NNPP. intros D. apply N. exists i, 0%nat. repeat split; try lia; exact D. }
  split.
  - destruct (classic (tanner2_connectivity.varies n (b 1%nat))) as [V1|V1]; [exists (b 1%nat); split; [apply Eb; lia|exact V1]|].
    destruct (C0 1%nat _ ltac:(lia) (V _ V1)) as [N1 Z1]. exists (b 0%nat). assert (P0 : l 0%nat = l 1%nat).
    { pose proof (not_below n adj _ _ S (Eb 0%nat ltac:(lia)) ltac:(rewrite U by lia; lra)). pose proof (Or 0%nat 1%nat ltac:(lia) ltac:(lia)). lra. }
    split; [rewrite <- P0; apply Eb; lia|]. apply NNPP. intros V0. destruct (C0 0%nat _ ltac:(lia) (V _ V0)) as [N0 _].
    pose proof (On 0%nat 1%nat ltac:(lia) ltac:(lia)) as X. cbn [Nat.eqb] in X.
    rewrite (Sum_ext n _ (fun _ => b 0%nat 0%nat * b 1%nat 0%nat)), Sum_const in X by (intros i Hi; now rewrite (V _ V0 i Hi), (V _ V1 i Hi)).
    apply Rmult_integral in X. destruct X as [X|X]; [lra|]. apply Rmult_integral in X. now destruct X.
  - intros mu x E Vx. apply Rnot_lt_le. intros L.
    assert (Only : forall nu y, tanner2_connectivity.eigen n adj nu y -> nu < l 1%nat -> exists a, forall i, (i < n)%nat -> y i = a * b 0%nat i).
    { intros nu y Ey Ly. destruct (Sp y) as [a Ha]. exists (a 0%nat). intros i Hi. rewrite (Ha i Hi).
      assert (Z : forall k, (k < n)%nat -> (1 <= k)%nat -> a k = 0).
      { intros k Hk K1. pose proof (Or 1%nat k K1 Hk). pose proof (apart n adj nu (l k) y (b k) S Ey (Eb k Hk) ltac:(lra)) as X.
        rewrite (Sum_ext n _ (fun i => Sum n (fun m => a m * (b m i * b k i)))) in X.
        - rewrite Sum_swap in X. rewrite (Sum_ext n _ (fun m => delta m k * a m)) in X.
          + now rewrite (Sum_delta n k a Hk) in X.
          + intros m Hm. rewrite Sum_scal, (On m k Hm Hk). unfold delta. destruct (Nat.eqb m k); ring.
        - intros j Hj. rewrite (Ha j Hj), <- Sum_scal_r. apply Sum_ext. intros; ring. }
      rewrite (Sum_ext n _ (fun k => delta k 0%nat * (a k * b k i))); [apply (Sum_delta n 0%nat (fun k => a k * b k i)); lia|].
      intros k Hk. destruct k as [|k]; [rewrite delta_eq; ring|]. rewrite (Z (Datatypes.S k) Hk ltac:(lia)), delta_neq by lia. ring. }
    destruct (Only mu x E L) as [a Ha].
    assert (M0 : 0 <= mu).
    { apply (not_below n adj mu _ S (tanner2_connectivity.eigen_centred n adj mu x ltac:(lia) S E)). apply tanner2_connectivity.varies_centred; [lia|exact Vx]. }
    destruct (Only 0 (fun _ => 1) (ones_eigen n adj 1) ltac:(lra)) as [d Hd]. destruct Vx as (i & j & Hi & Hj & Ne). apply Ne.
    assert (Nd : d <> 0) by (intros Z; specialize (Hd i Hi); rewrite Z in Hd; lra).
    assert (Q : forall k, (k < n)%nat -> b 0%nat k = / d) by (intros k Hk; specialize (Hd k Hk); apply (Rmult_eq_reg_l d); [rewrite <- Hd; now rewrite Rinv_r|exact Nd]).
    now rewrite (Ha i Hi), (Ha j Hj), (Q i Hi), (Q j Hj).
Qed.
Lemma connectivity_positive_holds : connectivity_positive.
Proof.
  intros n adj lam Hn [S _] SC L. destruct (second_entry n adj lam Hn S L) as [(x & E & V) _]. exact (tanner2_connectivity.others_positive n adj lam x S SC E V).
Qed.
(* a motion of the clauses is one of the theorems, at a time *)
Lemma closed n adj V V' r v t : T.simple_graph adj -> T.potentials n adj V V' -> T.motion n adj V' r v -> 0 <= t ->
  (forall i, (i < n)%nat -> is_velocity (r i) t (v i t)) /\ (forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> r i t <> r j t) /\
  (forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> is_derive (both V i j) (norm (r i t - r j t)%C) (both V' i j (norm (r i t - r j t)%C))) /\
  (forall i, (i < n)%nat -> is_velocity (v i) t (control4 n adj (both V') (fun i => r i t) (fun i => v i t) i)).
Proof.
  intros S P M Ht. pose proof (T.apart_always n adj V V' r v S P M t Ht) as A. pose proof (T.slopes_of n adj V V' P) as D. split; [|split; [|split]].
  - intros i Hi. now apply (proj2 M t i Ht Hi).
  - exact A.
  - intros i j Hi Hj L. assert (0 < norm (r i t - r j t)%C) by (apply tanner_flock.norm_neq; now apply A). destruct S as [S _].
    apply T.both_derive; [apply P|now apply D|]. apply D; try assumption. now rewrite S.
  - intros i Hi. rewrite <- T.law4_is. destruct (T.both_law n adj V V' (fun i => r i t) (fun i => v i t) i (proj1 S) (proj1 P) D Hi A) as (_ & _ & ->).
    now apply (T.moves_law n adj V).
Qed.
Lemma rate_is n adj V r v t d : (forall i j s, V i j s = V j i s) -> T.Wdot n adj V r v t d ->
  is_derive (fun s => Wenergy n adj (both V) (fun i => r i s) (fun i => v i s)) t d.
Proof.
  intros VS H. apply (is_derive_ext (fun s => T.energy6 n adj (both V) (fun i => r i s) (fun i => v i s))); [intros; apply T.energy6_is|].
  apply (is_derive_ext (fun s => T.energy6 n adj V (fun i => r i s) (fun i => v i s))); [intros; symmetry; now apply T.energy_both|exact H].
Qed.
Lemma rate_of_W_holds : rate_of_W.
Proof.
  intros n adj V V' r v t lam xp xn yp yn d Hn S SC P M Ht L (Pp & Zx & Zy & Pv) W. destruct (closed n adj V V' r v t S P M Ht) as (H1 & H2 & H3 & H4).
  assert (K : forall q : nat -> R, (forall i j, (i < n)%nat -> (j < n)%nat -> q i = q j) -> exists c, forall i, (i < n)%nat -> q i = c).
  { intros q Q. exists (q 0%nat). intros i Hi. apply Q; lia. }
  destruct (tanner2_connectivity.energy_below_second n adj (both V) (both V') r v t (proj1 S) (both_sym V') H1 H2 H3 H4 lam xp xn yp yn Hn
    (second_entry n adj lam Hn (proj1 S) L) Pv) as (e & De & Le); try assumption; [apply K; intros; now apply Pp|apply K; intros; now apply Pp|].
  pose proof (rate_is n adj V r v t d (proj1 P) W) as Dd. apply is_derive_unique in De, Dd. rewrite De in Dd. lra.
Qed.
Lemma rest_of_W_holds : rest_of_W.
Proof.
  intros n adj V V' r v t S SC P M Ht W. destruct (closed n adj V V' r v t S P M Ht) as (H1 & H2 & H3 & H4).
  exact (tanner2_connectivity.rest_of_energy n adj (both V) (both V') r v t (proj1 S) (both_sym V') H1 H2 H3 H4 SC (rate_is n adj V r v t 0 (proj1 P) W)).
Qed.
Lemma incidence_holds : incidence.
Proof.
  intros n adj V V' r v O t S P M Ht Eq HO. destruct (closed n adj V V' r v t S P M Ht) as (H1 & H2 & H3 & H4).
  destruct (tanner2_connectivity.vdot_incidence n adj (both V) (both V') r v t (proj1 S) (both_sym V') H2 H3 H4 O HO Eq) as (g & G1 & G2). exists g. split.
  - intros i j I u. specialize (G1 i j I (fun h => r i t - r j t + RtoC h * u)%C 0 u). rewrite inner_xy in G1.
    apply (is_derive_ext (fun h => both V i j (norm (r i t - r j t + RtoC h * u)%C))); [intros h; apply T.both_V, P|]. apply G1.
    + split; cbn.
      * apply (is_derive_ext (fun h => (fst (r i t) + - fst (r j t)) + h * fst u)); [intros; Rring|].
        eapply D_eq; [apply D_plus; [apply D_const|apply (D_mult (fun h => h) (fun _ => fst u)); [apply D_id|apply D_const]]|]. ring.
      * apply (is_derive_ext (fun h => (snd (r i t) + - snd (r j t)) + h * snd u)); [intros; Rring|].
        eapply D_eq; [apply D_plus; [apply D_const|apply (D_mult (fun h => h) (fun _ => snd u)); [apply D_id|apply D_const]]|]. ring.
    + ring.
  - intros k Hk b. exact (G2 k Hk).
Qed.
Lemma alignment_holds : alignment.
Proof.
  intros n adj lam v Hn [S NL] SC L Mv mean dev t Ht.
  assert (Mu : forall t i, 0 <= t -> (i < n)%nat -> is_velocity (v i) t (- Csum n (fun j => RtoC (w adj i j) * (v i t - v j t)))%C).
  { intros x i Hx Hi. replace (Csum n (fun j => RtoC (w adj i j) * (v i x - v j x)))%C with (Csum n (fun j => if adj i j then v i x - v j x else 0))%C; [now apply Mv|].
    apply Csum_ext. intros j _. unfold w. destruct (adj i j); ring. }
  destruct (tanner2_connectivity.second_rate n adj lam v Hn S (second_entry n adj lam Hn S L) Mu t Ht) as [R1 R2]. split; [exact R1|].
  intros E. apply R2. intros i Hi. etransitivity; [|exact (E i Hi)]. set (u := fun j => (v j 0 - mean 0)%C).
  change (Csum n (fun j => RtoC (lap n adj i j) * u j) = Csum n (fun j => if adj i j then u i - u j else 0))%C. unfold Csum. cbn [fst snd].
  f_equal.
  - rewrite (Sum_ext n _ (fun j => lap n adj i j * fst (u j))) by (intros; cbn; ring). rewrite <- (drops n adj (fun j => fst (u j)) i Hi).
    apply Sum_ext. intros j _. destruct (adj i j); reflexivity.
  - rewrite (Sum_ext n _ (fun j => lap n adj i j * snd (u j))) by (intros; cbn; ring). rewrite <- (drops n adj (fun j => snd (u j)) i Hi).
    apply Sum_ext. intros j _. destruct (adj i j); reflexivity.
Qed.
Lemma edges_raise_holds : edges_raise.
Proof.
  intros n adj more lam mu Hn [S _] [S' _] I L M.
  exact (tanner2_connectivity.second_grows n adj more lam mu Hn S S' I (second_entry n adj lam Hn S L) (second_entry n more mu Hn S' M)).
Qed.
Lemma zero_vectors_holds : zero_vectors.
Proof.
  intros n adj x Hn _ SC. rewrite <- (tanner2_connectivity.null_vectors n adj x Hn SC). split; intros H i Hi; [rewrite <- drops|rewrite drops]; try assumption; now apply H.
Qed.
