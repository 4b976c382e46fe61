(* Tanner, Jadbabaie, Pappas, links by distance: two solutions of (10), with K of the whole vector field, from one start agree as long as no pair is at the
   distance R without its distance changing, where the gradients are locally Lipschitz.
   Where every tied pair is on its way across R one graph holds for a time after, the same for both; the law on it is locally Lipschitz, and the sum of the
   squares of all differences, which is absolutely continuous, grows at a rate at most a multiple of itself.
     tanner2.eq10_exist (corrected, clause 2). *)
From Coq Require Import Reals Lra Lia Psatz Classical.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums inclusions paley_model paley_phase paley_laplacian paley_gradient tanner_energy tanner_flock tanner2_filippov.
From Flockproof Require tanner_trees.
Open Scope R_scope.

(* the gradient of V_ij by the difference of the positions, locally Lipschitz but where that is 0 *)
Definition pair_gradient (V' : nat -> nat -> R -> R) i j (z : C) : C := (RtoC (V' i j (Cmod z) / Cmod z) * z)%C.
Definition lipschitz_gradients n (V' : nat -> nat -> R -> R) := forall i j, (i < n)%nat -> (j < n)%nat -> i <> j -> forall z0 : C, z0 <> RtoC 0 ->
  exists d L, 0 < d /\ 0 < L /\ forall z y, Cmod (z - z0)%C < d -> Cmod (y - z0)%C < d -> Cmod (pair_gradient V' i j z - pair_gradient V' i j y)%C <= L * Cmod (z - y)%C.

(* ---- where no pair is at R, K is the law ---- *)
Lemma law4_graph n adj adj' V' r v i : (forall j, (j < n)%nat -> adj i j = adj' i j) -> law4 n adj V' r v i = law4 n adj' V' r v i.
Proof.
  intros E. rewrite !law4_one. unfold Csum. f_equal; apply Sum_ext; intros j Hj; unfold pull; now rewrite (E j Hj).
Qed.
Lemma off_ties n V V' R0 (r v : nat -> C) z : potentials n complete V V' -> apart_at n complete r -> (forall i j, (i < n)%nat -> (j < n)%nat -> i <> j -> Cmod (r i - r j)%C <> R0) ->
  K10 n V' R0 r v z -> forall i, (i < n)%nat -> z i = law4 n (by_distance r R0) V' r v i.
Proof.
  intros P A Nt (m & c & y & Hy & S1 & Hz) i Hi. rewrite (Hz i Hi).
  assert (Y : forall k, (k < m)%nat -> y k i = law4 n (by_distance r R0) V' r v i).
  { intros k Hk. destruct (Hy k Hk) as [_ L]. assert (Z : Cmod (y k i - law4 n (by_distance r R0) V' r v i)%C = 0).
    { apply cond_eq. intros e He. rewrite Rminus_0_r, Rabs_pos_eq by apply Cmod_ge_0. destruct (limit_weights n V V' R0 r v P A (y k) e L He) as (adj & Sim & W & Q).
      rewrite (law4_graph n (by_distance r R0) adj V' r v i); [now apply Q|]. intros j Hj. unfold by_distance. destruct (Nat.eqb_spec i j) as [<-|Ne]; [symmetry; apply Sim|]. cbn [negb andb].
      destruct (W i j Hi Hj Ne) as [W1 W2]. specialize (Nt i j Hi Hj Ne). destruct (Rlt_dec (Cmod (r i - r j)%C) R0) as [G|G]; symmetry; [now apply W1|apply W2; lra]. }
    apply Cmod_eq_0 in Z. transitivity (y k i - law4 n (by_distance r R0) V' r v i + law4 n (by_distance r R0) V' r v i)%C; [ring|]. rewrite Z. ring. }
  set (l := law4 n (by_distance r R0) V' r v i) in *. unfold Csum. apply injective_projections; cbn [fst snd].
  - rewrite (Sum_ext m _ (fun k => c k * fst l)); [rewrite Sum_scal_r, S1; ring|]. intros k Hk. rewrite (Y k Hk). cbn. ring.
  - rewrite (Sum_ext m _ (fun k => c k * snd l)); [rewrite Sum_scal_r, S1; ring|]. intros k Hk. rewrite (Y k Hk). cbn. ring.
Qed.

(* ---- on which side of R a pair is just after a time ---- *)
Lemma side_below (s : R -> R) t l R0 : is_derive s t l -> s t < R0 \/ (s t = R0 /\ l < 0) -> exists h, 0 < h /\ forall u, t < u < t + h -> s u < R0.
Proof.
  intros D [L|[E L]].
  - assert (Cn : continuity_pt s t) by (apply derivable_continuous_pt; exists l; now apply is_derive_Reals).
    destruct (Cn (R0 - s t) ltac:(lra)) as (d & Hd & Q). exists d. split; [exact Hd|]. intros u Hu. specialize (Q u). cbn in Q. unfold R_dist, D_x, no_cond in Q.
    assert (X : Rabs (s u - s t) < R0 - s t) by (apply Q; split; [split; [exact I|lra]|apply Rabs_def1; lra]). apply Rabs_def2 in X. lra.
  - apply is_derive_Reals in D. destruct (D (- l) ltac:(lra)) as [d Q]. exists d. split; [apply cond_pos|]. intros u Hu. specialize (Q (u - t) ltac:(lra)).
    rewrite Rabs_pos_eq in Q by lra. specialize (Q ltac:(lra)). replace (t + (u - t)) with u in Q by ring. apply Rabs_def2 in Q.
    assert (X : (s u - s t) / (u - t) < 0) by lra. apply (Rmult_lt_compat_r (u - t)) in X; [|lra]. replace ((s u - s t) / (u - t) * (u - t)) with (s u - s t) in X by (field; lra). lra.
Qed.
Lemma side_above (s : R -> R) t l R0 : is_derive s t l -> R0 < s t \/ (s t = R0 /\ 0 < l) -> exists h, 0 < h /\ forall u, t < u < t + h -> R0 < s u.
Proof.
  intros D H. destruct (side_below (fun u => - s u) t (- l) (- R0)) as (h & Hh & Q); [now apply D_opp|lra|]. exists h. split; [exact Hh|]. intros u Hu. specialize (Q u Hu). lra.
Qed.

(* ---- what grows at a rate at most a multiple of itself from 0 stays 0 ---- *)
Lemma stays_zero F N a b k : ac F -> negligible N -> 0 <= a <= b -> 0 <= k -> k * (b - a) < 1 -> F a = 0 -> (forall t, a <= t <= b -> 0 <= F t) ->
  (forall t, a < t < b -> ~ N t -> exists l, is_derive F t l /\ l <= k * F t) -> forall t, a <= t <= b -> F t = 0.
Proof.
  intros A HN Hab Hk Hs Fa F0 D. destruct (continuity_ab_maj (fun s => F (Rmax s 0)) a b (proj2 Hab)) as (x & M & Hx).
  { intros s _. now apply ac_continuous. }
  assert (Mx : forall t, a <= t <= b -> F t <= F x).
  { intros t Ht. specialize (M t Ht). cbv beta in M. rewrite !Rmax_left in M by lra. exact M. }
  destruct (Req_dec x b) as [->|Nb].
  - assert (Q : F b <= F a + k * F b * (b - a)).
    { apply (ac_le F (fun t => N t \/ (t = a \/ t = b)) a b (k * F b) A); [|exact Hab|].
      - apply negligible_or; [exact HN|]. apply negligible_or; apply negligible_isolated; intros t ->; (split; [lra|]); exists 1; (split; [lra|]); intros s -> _; reflexivity.
      - intros t Ht Nt. destruct (D t) as (l & Dl & Hl); [split; apply Rnot_le_lt; intros G; apply Nt; right; [left|right]; lra|tauto|]. exists l. split; [exact Dl|].
        specialize (Mx t Ht). nra. }
    assert (Fb : 0 <= F b) by (apply F0; lra). assert (Z : F b = 0) by nra. intros t Ht. specialize (Mx t Ht). specialize (F0 t Ht). lra.
  - assert (Q : F x <= F a + k * F x * (x - a)).
    { apply (ac_le F (fun t => N t \/ t = a) a x (k * F x) A); [|lra|].
      - apply negligible_or; [exact HN|]. apply negligible_isolated; intros t ->; (split; [lra|]); exists 1; (split; [lra|]); intros s -> _; reflexivity.
      - intros t Ht Nt. destruct (D t) as (l & Dl & Hl); [split; [apply Rnot_le_lt; intros G; apply Nt; right; lra|lra]|tauto|]. exists l. split; [exact Dl|].
        specialize (Mx t ltac:(lra)). nra. }
    assert (Fx : 0 <= F x) by (apply F0; lra). assert (k * (x - a) <= k * (b - a)) by (apply Rmult_le_compat_l; lra). assert (Z : F x = 0) by nra. intros t Ht. specialize (Mx t Ht). specialize (F0 t Ht). lra.
Qed.
Lemma Csum_le n f b : (forall j, (j < n)%nat -> Cmod (f j) <= b) -> Cmod (Csum n f) <= INR n * b.
Proof. intros H. eapply Rle_trans; [apply tanner_trees.norm_Csum|]. rewrite <- Sum_const. apply Sum_le. exact H. Qed.

Lemma D_gap (f g : R -> R) x a b : is_derive f x a -> is_derive g x b -> is_derive (fun t => (f t + -1 * g t) ^ 2) x (2 * (f x + -1 * g x) * (a + -1 * b)).
Proof. intros F G. apply (D_sqr (fun t => f t + -1 * g t)). apply D_plus; [exact F|now apply D_scal]. Qed.

Section Two.
Variables (n : nat) (V V' : nat -> nat -> R -> R) (R0 c : R) (r v r' v' : nat -> R -> C).
Hypothesis P : potentials n complete V V'.
Hypothesis Lg : lipschitz_gradients n V'.
Hypothesis M : moves_while n V' R0 r v (fun u => u < c).
Hypothesis M' : moves_while n V' R0 r' v' (fun u => u < c).
Hypothesis Start : forall i, (i < n)%nat -> r i 0 = r' i 0 /\ v i 0 = v' i 0.
Hypothesis Ap : forall t i j, 0 <= t < c -> (i < n)%nat -> (j < n)%nat -> i <> j -> 0 < Cmod (r i t - r j t)%C /\ 0 < Cmod (r' i t - r' j t)%C.
Hypothesis Across : forall t i j, 0 <= t < c -> (i < n)%nat -> (j < n)%nat -> i <> j -> Cmod (r i t - r j t)%C = R0 -> inner (r i t - r j t)%C (v i t - v j t)%C <> 0.
Definition coincide_at t := forall i, (i < n)%nat -> r i t = r' i t /\ v i t = v' i t.
Definition state_gap t := Sum n (fun i => ((fst (r i t) + -1 * fst (r' i t)) ^ 2 + (snd (r i t) + -1 * snd (r' i t)) ^ 2) + ((fst (v i t) + -1 * fst (v' i t)) ^ 2 + (snd (v i t) + -1 * snd (v' i t)) ^ 2)).
Lemma place_axes q p during i : moves_while n V' R0 q p during -> (i < n)%nat -> ac (fun t => fst (q i t)) /\ ac (fun t => snd (q i t)).
Proof.
  intros W Hi. pose proof (v_axes n V' R0 q p during W i Hi) as [A1 A2]. destruct W as (_ & Mv & _). split; apply ac_lipschitz.
  - exact (travelled (fun t => fst (q i t)) (fun t => fst (p i t)) A1 (fun t Ht => proj1 (Mv t i Ht Hi))).
  - exact (travelled (fun t => snd (q i t)) (fun t => snd (p i t)) A2 (fun t Ht => proj2 (Mv t i Ht Hi))).
Qed.
Lemma apart2_ac : ac state_gap.
Proof.
  apply (ac_Sum n (fun i t => ((fst (r i t) + -1 * fst (r' i t)) ^ 2 + (snd (r i t) + -1 * snd (r' i t)) ^ 2) + ((fst (v i t) + -1 * fst (v' i t)) ^ 2 + (snd (v i t) + -1 * snd (v' i t)) ^ 2))).
  intros i Hi. destruct (place_axes r v _ i M Hi), (place_axes r' v' _ i M' Hi), (v_axes n V' R0 r v _ M i Hi), (v_axes n V' R0 r' v' _ M' i Hi).
  repeat apply ac_plus; apply ac_sqr, ac_plus; try assumption; now apply ac_scal.
Qed.
Lemma apart2_term i t : (i < n)%nat -> Cmod (r i t - r' i t)%C ^ 2 + Cmod (v i t - v' i t)%C ^ 2 <= state_gap t.
Proof.
  intros Hi. rewrite <- !inner_self, !inner_xy. cbn [fst snd Cminus Cplus Copp].
  pose proof (Sum_term_le n (fun i => ((fst (r i t) + -1 * fst (r' i t)) ^ 2 + (snd (r i t) + -1 * snd (r' i t)) ^ 2) + ((fst (v i t) + -1 * fst (v' i t)) ^ 2 + (snd (v i t) + -1 * snd (v' i t)) ^ 2)) i) as Q.
  cbv beta in Q. unfold state_gap. eapply Rle_trans; [|apply Q; [|exact Hi]].
  - right. ring.
  - intros j _. assert (B : forall x, 0 <= x ^ 2) by (intros; apply pow2_ge_0). pose proof (B (fst (r j t) + -1 * fst (r' j t))). pose proof (B (snd (r j t) + -1 * snd (r' j t))). pose proof (B (fst (v j t) + -1 * fst (v' j t))). pose proof (B (snd (v j t) + -1 * snd (v' j t))). lra.
Qed.
Lemma apart2_ge0 t : 0 <= state_gap t.
Proof. apply Sum_ge0. intros j _. assert (B : forall x, 0 <= x ^ 2) by (intros; apply pow2_ge_0). pose proof (B (fst (r j t) + -1 * fst (r' j t))). pose proof (B (snd (r j t) + -1 * snd (r' j t))). pose proof (B (fst (v j t) + -1 * fst (v' j t))). pose proof (B (snd (v j t) + -1 * snd (v' j t))). lra. Qed.
Lemma apart2_zero t : state_gap t = 0 <-> coincide_at t.
Proof.
  split.
  - intros Z i Hi. pose proof (apart2_term i t Hi) as Q. rewrite Z in Q. pose proof (pow2_ge_0 (Cmod (r i t - r' i t)%C)). pose proof (pow2_ge_0 (Cmod (v i t - v' i t)%C)).
    assert (E : forall a b : C, Cmod (a - b)%C ^ 2 = 0 -> a = b).
    { intros a b H1. assert (H2 : Cmod (a - b)%C = 0) by nra. apply Cmod_eq_0 in H2. transitivity (a - b + b)%C; [ring|]. rewrite H2. ring. }
    split; apply E; lra.
  - intros S. apply Sum_zero. intros i Hi. destruct (S i Hi) as [-> ->]. ring.
Qed.
(* before a time, so at it *)
Lemma coincide_limit t : 0 <= t -> (forall u, 0 <= u < t -> coincide_at u) -> coincide_at t.
Proof.
  intros Ht H. destruct (Req_dec t 0) as [->|N]; [exact Start|]. apply apart2_zero. apply cond_eq. intros e He.
  destruct (ac_near state_gap t e apart2_ac ltac:(lra) He) as (d & Hd & Q). pose proof (Rmin_l (d / 2) (t / 2)). pose proof (Rmin_r (d / 2) (t / 2)). assert (0 < Rmin (d / 2) (t / 2)) by (apply Rmin_glb_lt; lra).
  set (u := t - Rmin (d / 2) (t / 2)) in *. specialize (Q u t ltac:(unfold u; lra) ltac:(lra) ltac:(unfold u; lra)). rewrite (proj2 (apart2_zero u)) in Q; [exact Q|]. apply H. unfold u. lra.
Qed.
(* at a time, so for a time after *)
Lemma coincide_after t : 0 <= t -> t < c -> coincide_at t -> exists e, 0 < e /\ forall u, t <= u < t + e -> coincide_at u.
Proof.
  intros Ht Hc St.
  (* sides and Lipschitz constants of all pairs *)
  destruct (small2 n (fun i j h => i <> j -> (forall u, t < u < t + h -> (Cmod (r i u - r j u)%C < R0 /\ Cmod (r' i u - r' j u)%C < R0)) \/ (forall u, t < u < t + h -> (R0 < Cmod (r i u - r j u)%C /\ R0 < Cmod (r' i u - r' j u)%C)))) as (h & Hh & Sd).
  { intros i j d d' H L Ne. destruct (H Ne) as [H1|H1]; [left|right]; intros u Hu; apply H1; lra. }
  { intros i j Hi Hj. destruct (Nat.eq_dec i j) as [->|Ne]; [exists 1; split; [lra|congruence]|]. destruct (Ap t i j ltac:(lra) Hi Hj Ne) as [A1 A2].
    pose proof (distance_rate n V' R0 r v _ M i j t Hi Hj Ht A1) as D1. pose proof (distance_rate n V' R0 r' v' _ M' i j t Hi Hj Ht A2) as D2.
    assert (E : Cmod (r' i t - r' j t)%C = Cmod (r i t - r j t)%C /\ opening r' v' i j t = opening r v i j t).
    { unfold opening. destruct (St i Hi) as [-> ->], (St j Hj) as [-> ->]. split; reflexivity. } destruct E as [E1 E2]. rewrite E2 in D2.
    assert (Cs : (Cmod (r i t - r j t)%C < R0 \/ (Cmod (r i t - r j t)%C = R0 /\ opening r v i j t < 0)) \/ (R0 < Cmod (r i t - r j t)%C \/ (Cmod (r i t - r j t)%C = R0 /\ 0 < opening r v i j t))).
    { destruct (Rtotal_order (Cmod (r i t - r j t)%C) R0) as [G|[G|G]]; [tauto| |tauto]. pose proof (Across t i j ltac:(lra) Hi Hj Ne G) as X.
      assert (O : opening r v i j t <> 0) by (unfold opening; intros Z; apply X; apply (Rmult_eq_reg_r (/ Cmod (r i t - r j t)%C)); [rewrite Rmult_0_l; exact Z|apply Rinv_neq_0_compat; lra]).
      destruct (Rtotal_order (opening r v i j t) 0) as [K|[K|K]]; [tauto|contradiction|tauto]. }
    destruct Cs as [Cs|Cs].
    - destruct (side_below _ t _ R0 D1 Cs) as (h1 & H1 & Q1). destruct (side_below _ t _ R0 D2 ltac:(cbv beta; rewrite E1; exact Cs)) as (h2 & H2 & Q2). exists (Rmin h1 h2). pose proof (Rmin_l h1 h2). pose proof (Rmin_r h1 h2).
      split; [now apply Rmin_glb_lt|]. intros _. left. intros u Hu. split; [apply Q1|apply Q2]; lra.
    - destruct (side_above _ t _ R0 D1 Cs) as (h1 & H1 & Q1). destruct (side_above _ t _ R0 D2 ltac:(cbv beta; rewrite E1; exact Cs)) as (h2 & H2 & Q2). exists (Rmin h1 h2). pose proof (Rmin_l h1 h2). pose proof (Rmin_r h1 h2).
      split; [now apply Rmin_glb_lt|]. intros _. right. intros u Hu. split; [apply Q1|apply Q2]; lra. }
  destruct (small2 n (fun i j h => i <> j -> forall u, t <= u < t + h -> Cmod (pair_gradient V' i j (r i u - r j u) - pair_gradient V' i j (r' i u - r' j u))%C <= / h * Cmod (r i u - r j u - (r' i u - r' j u))%C)) as (g & Hg & Lp).
  { intros i j d d' H L Ne u Hu. eapply Rle_trans; [apply (H Ne); lra|]. apply Rmult_le_compat_r; [apply Cmod_ge_0|]. apply Rinv_le_contravar; lra. }
  { intros i j Hi Hj. destruct (Nat.eq_dec i j) as [->|Ne]; [exists 1; split; [lra|congruence]|]. destruct (Ap t i j ltac:(lra) Hi Hj Ne) as [A1 A2].
    assert (Nz : (r i t - r j t)%C <> RtoC 0) by (intros Z; rewrite Z, Cmod_0 in A1; lra). destruct (Lg i j Hi Hj Ne _ Nz) as (d & L & Hd & HL & Q).
    assert (Near : forall q p, moves_while n V' R0 q p (fun u => u < c) -> exists k, 0 < k /\ forall u, t <= u < t + k -> Cmod (q i u - q j u - (q i t - q j t))%C < d).
    { intros q p W. destruct (place_axes q p _ i W Hi) as [X1 X2]. destruct (place_axes q p _ j W Hj) as [X3 X4].
      destruct (ac_near _ (t + 1) (d / 4) X1 ltac:(lra) ltac:(lra)) as (k1 & K1 & Y1). destruct (ac_near _ (t + 1) (d / 4) X2 ltac:(lra) ltac:(lra)) as (k2 & K2 & Y2).
      destruct (ac_near _ (t + 1) (d / 4) X3 ltac:(lra) ltac:(lra)) as (k3 & K3 & Y3). destruct (ac_near _ (t + 1) (d / 4) X4 ltac:(lra) ltac:(lra)) as (k4 & K4 & Y4).
      exists (Rmin 1 (Rmin (Rmin k1 k2) (Rmin k3 k4))). pose proof (Rmin_l 1 (Rmin (Rmin k1 k2) (Rmin k3 k4))). pose proof (Rmin_r 1 (Rmin (Rmin k1 k2) (Rmin k3 k4))).
      pose proof (Rmin_l (Rmin k1 k2) (Rmin k3 k4)). pose proof (Rmin_r (Rmin k1 k2) (Rmin k3 k4)). pose proof (Rmin_l k1 k2). pose proof (Rmin_r k1 k2). pose proof (Rmin_l k3 k4). pose proof (Rmin_r k3 k4).
      split; [repeat apply Rmin_glb_lt; lra|]. intros u Hu. eapply Rle_lt_trans; [apply axes_Cmod|]. cbn [fst snd Cminus Cplus Copp].
      specialize (Y1 t u ltac:(lra) ltac:(lra) ltac:(lra)). specialize (Y2 t u ltac:(lra) ltac:(lra) ltac:(lra)). specialize (Y3 t u ltac:(lra) ltac:(lra) ltac:(lra)). specialize (Y4 t u ltac:(lra) ltac:(lra) ltac:(lra)). cbv beta in *.
      apply Rabs_def2 in Y1, Y2, Y3, Y4. assert (Z : forall a b, - (d / 2) < a < d / 2 -> - (d / 2) < b < d / 2 -> Rabs a + Rabs b < d) by (intros a b Ha Hb; unfold Rabs; destruct (Rcase_abs a), (Rcase_abs b); lra). apply Z; lra. }
    destruct (Near r v M) as (k1 & K1 & N1). destruct (Near r' v' M') as (k2 & K2 & N2). pose proof (Rinv_0_lt_compat L HL) as IL.
    exists (Rmin (/ L) (Rmin k1 k2)). pose proof (Rmin_l (/ L) (Rmin k1 k2)). pose proof (Rmin_r (/ L) (Rmin k1 k2)). pose proof (Rmin_l k1 k2). pose proof (Rmin_r k1 k2).
    assert (Pm : 0 < Rmin (/ L) (Rmin k1 k2)) by (repeat apply Rmin_glb_lt; lra). split; [exact Pm|]. intros _ u Hu. eapply Rle_trans; [apply Q|].
    - apply N1. lra.
    - replace (r i t - r j t)%C with (r' i t - r' j t)%C by (destruct (St i Hi) as [-> _], (St j Hj) as [-> _]; reflexivity). apply N2. lra.
    - apply Rmult_le_compat_r; [apply Cmod_ge_0|]. apply Rle_trans with (/ / L); [rewrite Rinv_inv; lra|]. apply Rinv_le_contravar; assumption. }
  (* one graph *)
  set (kap := INR n * (2 + 2 * / g)). pose proof (pos_INR n) as Pn. assert (ig : 0 < / g) by now apply Rinv_0_lt_compat. assert (Hk : 0 <= kap) by (apply Rmult_le_pos; lra).
  set (rate := INR n * (2 + kap ^ 2)). assert (Hrate : 0 <= rate) by (apply Rmult_le_pos; [lra|nra]).
  set (e := Rmin (Rmin h g) (Rmin (c - t) (/ (rate + 1)))). pose proof (Rmin_l (Rmin h g) (Rmin (c - t) (/ (rate + 1)))) as E1. pose proof (Rmin_r (Rmin h g) (Rmin (c - t) (/ (rate + 1)))) as E2. fold e in E1, E2.
  pose proof (Rmin_l h g). pose proof (Rmin_r h g). pose proof (Rmin_l (c - t) (/ (rate + 1))). pose proof (Rmin_r (c - t) (/ (rate + 1))).
  assert (ir : 0 < / (rate + 1)) by (apply Rinv_0_lt_compat; lra). assert (He : 0 < e) by (unfold e; repeat apply Rmin_glb_lt; lra).
  assert (Small : rate * e < 1). { apply Rle_lt_trans with (rate * / (rate + 1)); [apply Rmult_le_compat_l; lra|]. apply Rmult_lt_reg_r with (rate + 1); [lra|]. rewrite Rmult_assoc, Rinv_l; lra. }
  exists e. split; [exact He|]. destruct M as (_ & Mv & _ & N & HN & Mz). destruct M' as (_ & Mv' & _ & N' & HN' & Mz').
  intros u Hu. apply apart2_zero. apply (stays_zero state_gap (fun t => N t \/ N' t) t u rate apart2_ac); [now apply negligible_or|lra|exact Hrate| |now apply apart2_zero|intros; apply apart2_ge0| |lra].
  { apply Rle_lt_trans with (2 := Small). apply Rmult_le_compat_l; lra. }
  intros x Hx Nx.
  assert (Ax : apart_at n complete (fun i => r i x) /\ apart_at n complete (fun i => r' i x)).
  { split; intros i j Hi Hj Cij Eq; (assert (Ne : i <> j) by (intros ->; unfold complete in Cij; rewrite Nat.eqb_refl in Cij; discriminate)); destruct (Ap x i j ltac:(lra) Hi Hj Ne) as [A1 A2]; rewrite Eq in *.
    - replace (r j x - r j x)%C with (RtoC 0) in A1 by ring. rewrite Cmod_0 in A1. lra.
    - replace (r' j x - r' j x)%C with (RtoC 0) in A2 by ring. rewrite Cmod_0 in A2. lra. }
  destruct (Mz x ltac:(lra) ltac:(lra) ltac:(tauto) (proj1 Ax)) as (z & Kz & Vz). destruct (Mz' x ltac:(lra) ltac:(lra) ltac:(tauto) (proj2 Ax)) as (z' & Kz' & Vz').
  assert (Zl : forall i, (i < n)%nat -> z i = law4 n (by_distance (fun i => r i x) R0) V' (fun i => r i x) (fun i => v i x) i).
  { apply (off_ties n V V' R0 (fun i => r i x) (fun i => v i x) z P (proj1 Ax)); [|exact Kz]. intros i j Hi Hj Ne Q. destruct (Sd i j Hi Hj Ne) as [S1|S1]; destruct (S1 x ltac:(lra)); lra. }
  assert (Zl' : forall i, (i < n)%nat -> z' i = law4 n (by_distance (fun i => r i x) R0) V' (fun i => r' i x) (fun i => v' i x) i).
  { intros i Hi. rewrite (off_ties n V V' R0 (fun i => r' i x) (fun i => v' i x) z' P (proj2 Ax)); [|intros k j Lk Lj Ne Q; destruct (Sd k j Lk Lj Ne) as [S1|S1]; destruct (S1 x ltac:(lra)); lra|exact Kz'|exact Hi].
    apply law4_graph. intros j Hj. unfold by_distance. destruct (Nat.eqb_spec i j) as [->|Ne]; [reflexivity|]. cbn [negb andb].
    destruct (Sd i j Hi Hj Ne) as [S1|S1]; destruct (S1 x ltac:(lra)); destruct (Rlt_dec (Cmod (r i x - r j x)%C) R0), (Rlt_dec (Cmod (r' i x - r' j x)%C) R0); try reflexivity; lra. }
  set (zeta := sqrt (state_gap x)). pose proof (apart2_ge0 x) as A0. assert (Z2 : zeta ^ 2 = state_gap x) by (unfold zeta; now apply pow2_sqrt). assert (Z0 : 0 <= zeta) by apply sqrt_pos.
  assert (Gap : forall i, (i < n)%nat -> Cmod (r i x - r' i x)%C <= zeta /\ Cmod (v i x - v' i x)%C <= zeta).
  { intros i Hi. pose proof (apart2_term i x Hi) as Q. pose proof (Cmod_ge_0 (r i x - r' i x)%C). pose proof (Cmod_ge_0 (v i x - v' i x)%C).
    pose proof (pow2_ge_0 (Cmod (r i x - r' i x)%C)). pose proof (pow2_ge_0 (Cmod (v i x - v' i x)%C)). split; nra. }
  assert (Zg : forall i, (i < n)%nat -> Cmod (z i - z' i)%C ^ 2 <= kap ^ 2 * state_gap x).
  { intros i Hi. rewrite <- Z2. assert (Q : Cmod (z i - z' i)%C <= kap * zeta).
    { rewrite (Zl i Hi), (Zl' i Hi), !law4_one, Csum_gap. replace (kap * zeta) with (INR n * ((2 + 2 * / g) * zeta)) by (unfold kap; ring). apply Csum_le. intros j Hj.
      unfold pull. destruct (by_distance (fun i => r i x) R0 i j) eqn:B.
      - assert (Ne : i <> j) by (intros ->; rewrite (proj2 (by_distance_simple (fun i => r i x) R0)) in B; discriminate).
        change (RtoC (V' i j (Cmod (r i x - r j x)) / Cmod (r i x - r j x)) * (r i x - r j x))%C with (pair_gradient V' i j (r i x - r j x)%C).
        change (RtoC (V' i j (Cmod (r' i x - r' j x)) / Cmod (r' i x - r' j x)) * (r' i x - r' j x))%C with (pair_gradient V' i j (r' i x - r' j x)%C).
        pose proof (Lp i j Hi Hj Ne x ltac:(lra)) as Lx. set (G := (pair_gradient V' i j (r i x - r j x) - pair_gradient V' i j (r' i x - r' j x))%C) in *.
        replace (- (v i x - v j x) - pair_gradient V' i j (r i x - r j x) - (- (v' i x - v' j x) - pair_gradient V' i j (r' i x - r' j x)))%C with (- (v i x - v' i x) + ((v j x - v' j x) + - G))%C by (unfold G; ring).
        eapply Rle_trans; [apply Cmod_triangle|]. rewrite Cmod_opp. pose proof (Cmod_triangle (v j x - v' j x)%C (- G)%C) as T1. rewrite Cmod_opp in T1.
        assert (T2 : Cmod (r i x - r j x - (r' i x - r' j x))%C <= 2 * zeta).
        { replace (r i x - r j x - (r' i x - r' j x))%C with ((r i x - r' i x) + - (r j x - r' j x))%C by ring. eapply Rle_trans; [apply Cmod_triangle|]. rewrite Cmod_opp. destruct (Gap i Hi), (Gap j Hj). lra. }
        assert (T3 : Cmod G <= / g * (2 * zeta)) by (eapply Rle_trans; [exact Lx|]; apply Rmult_le_compat_l; lra). destruct (Gap i Hi), (Gap j Hj). lra.
      - replace (- 0 - 0 - (- 0 - 0))%C with (RtoC 0) by ring. rewrite Cmod_0. apply Rmult_le_pos; lra. }
    pose proof (Cmod_ge_0 (z i - z' i)%C). assert (0 <= kap * zeta) by (apply Rmult_le_pos; lra). replace (kap ^ 2 * zeta ^ 2) with ((kap * zeta) ^ 2) by ring. nra. }
  eexists. split.
  - apply (D_Sum n (fun i t => ((fst (r i t) + -1 * fst (r' i t)) ^ 2 + (snd (r i t) + -1 * snd (r' i t)) ^ 2) + ((fst (v i t) + -1 * fst (v' i t)) ^ 2 + (snd (v i t) + -1 * snd (v' i t)) ^ 2))
      (fun i => (2 * (fst (r i x) + -1 * fst (r' i x)) * (fst (v i x) + -1 * fst (v' i x)) + 2 * (snd (r i x) + -1 * snd (r' i x)) * (snd (v i x) + -1 * snd (v' i x))) +
        (2 * (fst (v i x) + -1 * fst (v' i x)) * (fst (z i) + -1 * fst (z' i)) + 2 * (snd (v i x) + -1 * snd (v' i x)) * (snd (z i) + -1 * snd (z' i))))).
    intros i Hi. destruct (Mv x i ltac:(lra) Hi) as [R1 R2]. destruct (Mv' x i ltac:(lra) Hi) as [R1' R2']. destruct (Vz i Hi) as [V1 V2]. destruct (Vz' i Hi) as [V1' V2'].
    apply D_plus; apply D_plus.
    + exact (D_gap (fun t => fst (r i t)) (fun t => fst (r' i t)) x _ _ R1 R1').
    + exact (D_gap (fun t => snd (r i t)) (fun t => snd (r' i t)) x _ _ R2 R2').
    + exact (D_gap (fun t => fst (v i t)) (fun t => fst (v' i t)) x _ _ V1 V1').
    + exact (D_gap (fun t => snd (v i t)) (fun t => snd (v' i t)) x _ _ V2 V2').
  - unfold rate. rewrite Rmult_assoc, <- Sum_const. apply Sum_le. intros i Hi. pose proof (apart2_term i x Hi) as Q. specialize (Zg i Hi). rewrite <- !inner_self, !inner_xy in *. cbn [fst snd Cminus Cplus Copp] in *.
    set (a := fst (r i x) + -1 * fst (r' i x)). set (b := snd (r i x) + -1 * snd (r' i x)). set (a1 := fst (v i x) + -1 * fst (v' i x)). set (b1 := snd (v i x) + -1 * snd (v' i x)). set (a2 := fst (z i) + -1 * fst (z' i)). set (b2 := snd (z i) + -1 * snd (z' i)).
    assert (Q' : a ^ 2 + b ^ 2 + (a1 ^ 2 + b1 ^ 2) <= state_gap x) by (eapply Rle_trans; [|exact Q]; right; unfold a, b, a1, b1; ring).
    assert (Zg' : a2 ^ 2 + b2 ^ 2 <= kap ^ 2 * state_gap x) by (eapply Rle_trans; [|exact Zg]; right; unfold a2, b2; ring).
    pose proof (pow2_ge_0 (a - a1)). pose proof (pow2_ge_0 (b - b1)). pose proof (pow2_ge_0 (a1 - a2)). pose proof (pow2_ge_0 (b1 - b2)). pose proof (pow2_ge_0 a). pose proof (pow2_ge_0 b). nra.
Qed.
Lemma coincide_while : forall t, 0 <= t -> t < c -> coincide_at t.
Proof.
  apply (real_induction (fun t => t < c -> coincide_at t)).
  - intros t Ht H Hc. apply coincide_limit; [exact Ht|]. intros u Hu. apply H; lra.
  - intros t Ht H. destruct (Rlt_or_le t c) as [L|L]; [|exists 1; split; [lra|]; intros; lra].
    destruct (coincide_after t Ht L (H L)) as (e & He & Q). exists e. split; [exact He|]. intros u Hu _. now apply Q.
Qed.
End Two.

Theorem unique_across : forall n V V' R0 T (r v r' v' : nat -> R -> C), 0 < R0 -> potentials n complete V V' -> lipschitz_gradients n V' ->
  motion10_until T n V' R0 r v -> motion10_until T n V' R0 r' v' -> (forall i, (i < n)%nat -> r i 0 = r' i 0 /\ v i 0 = v' i 0) ->
  (forall t i j, 0 <= t < T -> (i < n)%nat -> (j < n)%nat -> i <> j -> Cmod (r i t - r j t)%C = R0 -> inner (r i t - r j t)%C (v i t - v j t)%C <> 0) ->
  forall t i, 0 <= t < T -> (i < n)%nat -> r i t = r' i t /\ v i t = v' i t.
Proof.
  intros n V V' R0 T r v r' v' HR P Lg M M' St Ac t i Ht Hi. set (c := (t + T) / 2). assert (Hc : t < c < T) by (unfold c; lra).
  destruct (straightened n V' R0 r v T c M ltac:(lra)) as (q & p & E & W). destruct (straightened n V' R0 r' v' T c M' ltac:(lra)) as (q' & p' & E' & W').
  destruct (pairs_apart n V V' R0 r v HR P (proj1 M)) as (d & Hd & Ap). destruct (pairs_apart n V V' R0 r' v' HR P (proj1 M')) as (d' & Hd' & Ap').
  assert (S : coincide_at n q p q' p' t).
  { apply (coincide_while n V V' R0 c q p q' p' P Lg W W'); [| | |lra|lra].
    - intros k Hk. destruct (E k 0 ltac:(lra)) as [-> ->], (E' k 0 ltac:(lra)) as [-> ->]. now apply St.
    - intros s k j Hs Hk Hj Ne. destruct (E k s ltac:(lra)) as [-> _], (E j s ltac:(lra)) as [-> _], (E' k s ltac:(lra)) as [-> _], (E' j s ltac:(lra)) as [-> _].
      specialize (Ap T M s k j ltac:(lra) Hk Hj Ne). specialize (Ap' T M' s k j ltac:(lra) Hk Hj Ne). lra.
    - intros s k j Hs Hk Hj Ne. destruct (E k s ltac:(lra)) as [-> ->], (E j s ltac:(lra)) as [-> ->]. apply Ac; try assumption. lra. }
  destruct (S i Hi) as [S1 S2]. destruct (E i t ltac:(lra)) as [E1 E2], (E' i t ltac:(lra)) as [E3 E4]. rewrite E1, E3 in S1. rewrite E2, E4 in S2. now split.
Qed.
