(* Tanner, Jadbabaie, Pappas, links by distance: from every start in which no two agents coincide (10), with K of the whole vector field, has a solution for all
   time, potentials of Definition 3 with a continuous derivative.
   The inclusion: the law with any network that occurs near the state, cut off beyond bounds of distances and speeds that the start gives.  Its solution
   (inclusions.v) has derivatives almost everywhere (lipschitz.v), which are in the convex hull of finitely many values; the energy keeps it within the bounds.
     tanner2.eq10_exist (corrected, clause 1). *)
From Coq Require Import Reals Lra Lia Psatz Classical.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums inclusions paley_model paley_phase paley_laplacian paley_gradient tanner_energy tanner_flock tanner2_filippov tanner2_limits tanner2_lasting lipschitz.
From Flockproof Require tanner2_appendix tanner2_existence.
Open Scope R_scope.

(* ---- the networks of n agents, by numbers ---- *)
Definition network_of n c : graph := fun i j => andb (negb (Nat.eqb i j)) (Nat.testbit c (i * n + j)).
Lemma bits m : forall f : nat -> bool, exists c, (c < 2 ^ m)%nat /\ forall k, (k < m)%nat -> Nat.testbit c k = f k.
Proof.
  induction m as [|m IH]; intros f; [exists 0%nat; split; [cbn; lia|intros; lia]|]. destruct (IH (fun k => f (S k))) as (c & Hc & E). exists (Nat.b2n (f 0%nat) + 2 * c)%nat. split.
  - destruct (f 0%nat); cbn [Nat.b2n Nat.pow]; lia.
  - intros [|k] Hk; [apply Nat.add_b2n_double_bit0|]. rewrite Nat.add_comm, Nat.testbit_succ_r. apply E. lia.
Qed.
Lemma numbered n (g : graph) : (forall i, (i < n)%nat -> g i i = false) -> exists c, (c < 2 ^ (n * n))%nat /\ same_pairs n (network_of n c) g.
Proof.
  intros NL. destruct (bits (n * n) (fun k => g (k / n)%nat (k mod n)%nat)) as (c & Hc & E). exists c. split; [exact Hc|]. intros i j Hi Hj. unfold network_of.
  destruct (Nat.eqb_spec i j) as [->|Ne]; [cbn; symmetry; now apply NL|]. cbn [negb andb]. rewrite E by nia. rewrite Nat.div_add_l, Nat.div_small, Nat.add_0_r by lia.
  rewrite Nat.add_comm, Nat.mod_add, Nat.mod_small by lia. reflexivity.
Qed.
Lemma occurs_pairs n R0 r g h : same_pairs n g h -> occurs n R0 r g -> occurs n R0 r h.
Proof. intros E O e He. destruct (O e He) as (q & Q1 & Q2 & Q3). exists q. split; [exact Q1|]. split; [exact Q2|]. intros i j Hi Hj. rewrite <- (E i j Hi Hj). now apply Q3. Qed.
Lemma numbered_occurs n R0 r g : occurs n R0 r g -> exists c, (c < 2 ^ (n * n))%nat /\ same_pairs n (network_of n c) g /\ occurs n R0 r (network_of n c).
Proof.
  intros O. destruct (O 1 Rlt_0_1) as (q & _ & _ & E). destruct (numbered n g) as (c & Hc & S).
  { intros i Hi. rewrite (E i i Hi Hi). apply by_distance_simple. }
  exists c. split; [exact Hc|]. split; [exact S|]. apply (occurs_pairs n R0 r g); [|exact O]. intros i j Hi Hj. symmetry. now apply S.
Qed.

(* ---- convex hulls of finitely many values are closed ---- *)
Definition weights N (good : nat -> Prop) (w : nat -> R) := (forall c, (c < N)%nat -> 0 <= w c) /\ (forall c, (c < N)%nat -> ~ good c -> w c = 0) /\ Sum N w = 1.
Lemma gather n N good (Y : nat -> nat -> R) m (c : nat -> R) (y : nat -> nat -> R) :
  (forall k, (k < m)%nat -> 0 <= c k /\ exists l, (l < N)%nat /\ good l /\ forall i, (i < n)%nat -> y k i = Y l i) ->
  exists w, (forall l, 0 <= w l) /\ (forall l, ~ good l -> w l = 0) /\ Sum N w = Sum m c /\ forall i, (i < n)%nat -> Sum m (fun k => c k * y k i) = Sum N (fun l => w l * Y l i).
Proof.
  induction m as [|m IH]; intros H.
  - exists (fun _ => 0). split; [intros; lra|]. split; [reflexivity|]. split; [cbn; apply Sum_0|]. intros i _. cbn. rewrite Sum_zero; [reflexivity|]. intros; ring.
  - destruct IH as (w & W1 & W2 & W3 & W4); [intros; apply H; lia|]. destruct (H m ltac:(lia)) as (C0 & l & Hl & Gl & El). exists (fun k => w k + delta k l * c m). split; [|split; [|split]].
    + intros k. specialize (W1 k). unfold delta. destruct (Nat.eqb k l); nra.
    + intros k Nk. rewrite (W2 k Nk). unfold delta. destruct (Nat.eqb_spec k l) as [->|]; [contradiction|ring].
    + cbn [Sum]. rewrite Sum_plus, W3. f_equal. now apply (Sum_delta N l (fun _ => c m)).
    + intros i Hi. cbn [Sum]. rewrite (W4 i Hi), (El i Hi). rewrite (Sum_ext N (fun k => (w k + delta k l * c m) * Y k i) (fun k => w k * Y k i + delta k l * (c m * Y k i))) by (intros; ring).
      rewrite Sum_plus. f_equal. symmetry. now apply (Sum_delta N l (fun k => c m * Y k i)).
Qed.
Lemma finite_hull n N good (Y : nat -> nat -> R) z : (forall e, 0 < e -> exists w, weights N good w /\ forall i, (i < n)%nat -> Rabs (z i - Sum N (fun l => w l * Y l i)) < e) ->
  exists w, weights N good w /\ forall i, (i < n)%nat -> z i = Sum N (fun l => w l * Y l i).
Proof.
  intros H. set (cl := fun e w => weights N good w /\ forall i, (i < n)%nat -> Rabs (z i - Sum N (fun l => w l * Y l i)) < e).
  set (big := fun P : (nat -> R) -> Prop => forall e, 0 < e -> exists w, cl e w /\ P (fun l => if Nat.ltb l N then w l else 0)).
  assert (Cl : forall e e' w, e <= e' -> cl e w -> cl e' w) by (intros e e' w L [W C]; split; [exact W|]; intros i Hi; specialize (C i Hi); lra).
  assert (B : forall e, 0 < e -> big (close N (cluster big) e)).
  { intros e He. apply cluster_point; [| | | |exact He].
    - intros P Q PQ Bp d Hd. destruct (Bp d Hd) as (w & W1 & W2). exists w. split; [exact W1|now apply PQ].
    - intros P Q Bp. destruct (classic (big P)) as [X|X]; [now left|right]. intros d Hd. apply not_all_ex_not in X. destruct X as [d' X]. apply imply_to_and in X. destruct X as [Hd' X].
      destruct (Bp (Rmin d d') ltac:(now apply Rmin_glb_lt)) as (w & W1 & [W2|W2]).
      + exfalso. apply X. exists w. split; [|exact W2]. apply (Cl (Rmin d d')); [apply Rmin_r|exact W1].
      + exists w. split; [|exact W2]. apply (Cl (Rmin d d')); [apply Rmin_l|exact W1].
    - intros d Hd. destruct (H d Hd) as (w & W1 & W2). exists w. split; [now split|exact I].
    - intros k. exists 1. intros Bk. destruct (Bk 1 Rlt_0_1) as (w & [[W1 [_ W3]] _] & L). destruct (Nat.ltb_spec k N) as [G|G]; [|rewrite Rabs_R0 in L; lra].
      pose proof (Sum_term_le N w k W1 G) as T. rewrite W3 in T. specialize (W1 k G). rewrite Rabs_pos_eq in L by exact W1. lra. }
  set (u := cluster big).
  assert (Near : forall e, 0 < e -> exists w, cl e w /\ forall l, (l < N)%nat -> Rabs (w l - u l) < e).
  { intros e He. destruct (B e He e He) as (w & W1 & W2). exists w. split; [exact W1|]. intros l Hl. specialize (W2 l Hl). cbv beta in W2. apply Nat.ltb_lt in Hl. now rewrite Hl in W2. }
  exists u. split; [split; [|split]|].
  - intros l Hl. apply Rnot_lt_le. intros L. destruct (Near (- u l) ltac:(lra)) as (w & [[W1 _] _] & W2). specialize (W1 l Hl). specialize (W2 l Hl). apply Rabs_def2 in W2. lra.
  - intros l Hl Ng. apply cond_eq. intros e He. destruct (Near e He) as (w & [[_ [W1 _]] _] & W2). specialize (W2 l Hl). rewrite (W1 l Hl Ng) in W2. rewrite Rabs_minus_sym. exact W2.
  - apply cond_eq. intros e He. pose proof (pos_INR N) as Pn. destruct (Near (e / (INR N + 1)) ltac:(apply Rdiv_lt_0_compat; lra)) as (w & [[_ [_ W1]] _] & W2). rewrite <- W1, <- Sum_minus. eapply Rle_lt_trans; [apply Sum_Rabs|].
    apply Rle_lt_trans with (INR N * (e / (INR N + 1))).
    + rewrite <- Sum_const. apply Sum_le. intros l Hl. rewrite Rabs_minus_sym. left. now apply W2.
    + apply Rmult_lt_reg_r with (INR N + 1); [lra|]. replace (INR N * (e / (INR N + 1)) * (INR N + 1)) with (INR N * e) by (field; lra). nra.
  - intros i Hi. apply cond_eq. intros e He. set (K := Sum N (fun l => Rabs (Y l i))). assert (K0 : 0 <= K) by (apply Sum_ge0; intros; apply Rabs_pos).
    destruct (Near (e / (K + 2)) ltac:(apply Rdiv_lt_0_compat; lra)) as (w & [_ W1] & W2). specialize (W1 i Hi).
    assert (G : Rabs (Sum N (fun l => w l * Y l i) - Sum N (fun l => u l * Y l i)) <= e / (K + 2) * K).
    { rewrite <- Sum_minus. eapply Rle_trans; [apply Sum_Rabs|]. unfold K. rewrite <- Sum_scal. apply Sum_le. intros l Hl. replace (w l * Y l i - u l * Y l i) with ((w l - u l) * Y l i) by ring. rewrite Rabs_mult. apply Rmult_le_compat_r; [apply Rabs_pos|]. left. now apply W2. }
    replace (z i - Sum N (fun l => u l * Y l i)) with (z i - Sum N (fun l => w l * Y l i) + (Sum N (fun l => w l * Y l i) - Sum N (fun l => u l * Y l i))) by ring. eapply Rle_lt_trans; [apply Rabs_triang|].
    assert (X : e / (K + 2) + e / (K + 2) * K < e); [|lra]. apply Rmult_lt_reg_r with (K + 2); [lra|]. replace ((e / (K + 2) + e / (K + 2) * K) * (K + 2)) with (e * (1 + K)) by (field; lra). nra.
Qed.

(* ---- the inclusion ---- *)
Section Inclusion.
Variables (n : nat) (V V' : nat -> nat -> R -> R) (R0 lo S : R).
Hypothesis HR : 0 < R0.
Hypothesis P : potentials n complete V V'.
Hypothesis Hlo : 0 < lo < R0.
Hypothesis HS : 0 <= S.
Notation N := (2 ^ (n * n))%nat.
Notation law c := (field n (network_of n c) V' lo R0 S).
Definition possible (y : nat -> R) c := apart_at n complete (place n y) -> occurs n R0 (place n y) (network_of n c).
Definition incl (y w : nat -> R) := exists c, (c < N)%nat /\ possible y c /\ forall k, (k < 4 * n)%nat -> w k = law c y k.
Lemma slopes_continuous c i j s : (i < n)%nat -> (j < n)%nat -> network_of n c i j = true -> 0 < s -> continuity_pt (V' i j) s.
Proof.
  intros Hi Hj L Hs. assert (C : complete i j = true) by (unfold network_of in L; apply andb_prop in L as [L _]; exact L). now apply (proj2 P i j Hi Hj C).
Qed.
Lemma law_continuous c y : continuous_at (4 * n) (law c) y.
Proof. apply field_continuous; [exact Hlo|]. intros i j s. apply slopes_continuous. Qed.
Lemma law_bounded : exists M, 0 <= M /\ forall c y k, (c < N)%nat -> (k < 4 * n)%nat -> Rabs (law c y k) <= M.
Proof.
  destruct (small N (fun c d => forall y k, (k < 4 * n)%nat -> Rabs (law c y k) <= / d)) as (d & Hd & Q).
  - intros c d d' H L y k Hk. eapply Rle_trans; [now apply H|]. apply Rinv_le_contravar; lra.
  - intros c Hc. destruct (field_bounded n (network_of n c) V' lo R0 S Hlo HS (slopes_continuous c)) as [M HM]. exists (/ (Rabs M + 1)). pose proof (Rabs_pos M). split; [apply Rinv_0_lt_compat; lra|].
    intros y k Hk. rewrite Rinv_inv. eapply Rle_trans; [now apply HM|]. pose proof (Rle_abs M). lra.
  - exists (/ d). split; [left; now apply Rinv_0_lt_compat|]. intros c y k Hc Hk. now apply Q.
Qed.
Lemma place_ext y y' i : (forall k, (k < 4 * n)%nat -> y k = y' k) -> (i < n)%nat -> place n y i = place n y' i /\ speed n y i = speed n y' i.
Proof. intros E Hi. unfold place, speed. rewrite !E by lia. split; reflexivity. Qed.
Lemma occurs_ext r r' g : (forall i, (i < n)%nat -> r i = r' i) -> occurs n R0 r g -> occurs n R0 r' g.
Proof. intros E O e He. destruct (O e He) as (q & Q1 & Q2). exists q. split; [|exact Q2]. intros i Hi. rewrite <- (E i Hi). now apply Q1. Qed.
Lemma incl_ext y y' w : (forall k, (k < 4 * n)%nat -> y k = y' k) -> incl y w -> incl y' w.
Proof.
  intros E (c & Hc & O & W). exists c. split; [exact Hc|]. split.
  - intros A. apply (occurs_ext (place n y)); [intros i Hi; now apply place_ext|]. apply O. intros i j Hi Hj L. destruct (place_ext y y' i E Hi) as [-> _], (place_ext y y' j E Hj) as [-> _]. now apply A.
  - intros k Hk. rewrite (W k Hk). apply cond_eq. intros e He. destruct (law_continuous c y' e He) as (d & Hd & Q). apply Q; [|exact Hk]. intros i Hi. rewrite (E i Hi), Rminus_eq_0, Rabs_R0. exact Hd.
Qed.
Lemma apart_occurs r : apart_at n complete r -> exists c, (c < N)%nat /\ occurs n R0 r (network_of n c).
Proof.
  intros A. destruct (numbered_occurs n R0 r (by_distance r R0)) as (c & Hc & _ & O); [|now exists c].
  intros e He. apply (spread_generic n r R0 HR); [|exact He]. intros i j Hi Hj Ne. apply A; try assumption. unfold complete. destruct (Nat.eqb_spec i j); [contradiction|reflexivity].
Qed.
Lemma incl_some y : exists w, incl y w.
Proof.
  destruct (classic (apart_at n complete (place n y))) as [A|A].
  - destruct (apart_occurs _ A) as (c & Hc & O). exists (law c y), c. split; [exact Hc|]. split; [intros _; exact O|reflexivity].
  - assert (H : (0 < N)%nat) by (apply Nat.neq_0_lt_0, Nat.pow_nonzero; lia). exists (law 0%nat y), 0%nat. split; [exact H|]. split; [intros A'; contradiction|reflexivity].
Qed.
Lemma place_near y y' d i : near (4 * n) d y y' -> (i < n)%nat -> Cmod (place n y i - place n y' i)%C < 2 * d.
Proof.
  intros Ny Hi. eapply Rle_lt_trans; [apply axes_Cmod|]. unfold place. cbn [fst snd Cminus Cplus Copp]. pose proof (Ny i ltac:(lia)) as A. pose proof (Ny (n + i)%nat ltac:(lia)) as B. unfold Rminus in A, B. lra.
Qed.
(* what is in every half-space with the values near a state is in the convex hull of those with networks that occur there *)
Lemma incl_hull y z : apart_at n complete (place n y) -> hull (4 * n) incl y z ->
  exists w, weights N (fun c => occurs n R0 (place n y) (network_of n c)) w /\ forall k, (k < 4 * n)%nat -> z k = Sum N (fun c => w c * law c y k).
Proof.
  intros Ay H. set (good := fun c => occurs n R0 (place n y) (network_of n c)). apply finite_hull. intros e He. destruct law_bounded as (M & M0 & Bd).
  set (A := fun p : nat -> R => exists c, (c < N)%nat /\ good c /\ forall k, (k < 4 * n)%nat -> p k = law c y k).
  assert (Cl : tanner2_appendix.closed_hull (4 * n) A z).
  { apply NNPP. intros Nc. destruct (tanner2_existence.separate (4 * n) A z M) as (l & c0 & S1 & S2); [| |exact Nc|].
    - destruct (apart_occurs _ Ay) as (c & Hc & O). exists (law c y), c. now repeat split.
    - intros p i (c & Hc & _ & E) Hi. rewrite E by exact Hi. now apply Bd.
    - set (del := (dot (4 * n) l z - c0) / 2). set (W := Sum (4 * n) (fun i => Rabs (l i))). assert (W0 : 0 <= W) by (apply Sum_ge0; intros; apply Rabs_pos). assert (Hdel : 0 < del) by (unfold del; lra).
      destruct (small N (fun c d => (forall x, near (4 * n) d x y -> occurs n R0 (place n x) (network_of n c) -> good c) /\ forall x, near (4 * n) d x y -> forall k, (k < 4 * n)%nat -> Rabs (law c x k - law c y k) < del / (W + 1))) as (d & Hd & Q).
      { intros c d d' [H1 H2] L. split; [intros x Nx; apply H1|intros x Nx; apply H2]; intros i Hi; specialize (Nx i Hi); lra. }
      { intros c Hc. assert (X : exists d, 0 < d /\ forall x, near (4 * n) d x y -> occurs n R0 (place n x) (network_of n c) -> good c).
        { destruct (classic (good c)) as [G|G]; [exists 1; split; [lra|]; intros; exact G|]. apply not_all_ex_not in G. destruct G as [r G]. apply imply_to_and in G. destruct G as [Hr G]. exists (r / 4). split; [lra|].
          intros x Nx O. exfalso. apply G. destruct (O (r / 2) ltac:(lra)) as (q & Q1 & Q2). exists q. split; [|exact Q2]. intros i Hi. specialize (Q1 i Hi). pose proof (place_near x y (r / 4) i Nx Hi).
          replace (q i - place n y i)%C with ((q i - place n x i) + (place n x i - place n y i))%C by ring. eapply Rle_lt_trans; [apply Cmod_triangle|]. lra. }
        destruct X as (d1 & H1 & X1). destruct (law_continuous c y (del / (W + 1)) ltac:(apply Rdiv_lt_0_compat; lra)) as (d2 & H2 & X2). exists (Rmin d1 d2). pose proof (Rmin_l d1 d2). pose proof (Rmin_r d1 d2).
        split; [now apply Rmin_glb_lt|]. split; [intros x Nx; apply X1|intros x Nx; apply X2]; intros i Hi; specialize (Nx i Hi); lra. }
      destruct (small2 n (fun i j d => i <> j -> forall x, near (4 * n) d x y -> place n x i <> place n x j)) as (d' & Hd' & Q').
      { intros i j b b' Hb L Ne x Nx. apply (Hb Ne). intros k Hk. specialize (Nx k Hk). lra. }
      { intros i j Hi Hj. destruct (Nat.eq_dec i j) as [->|Ne]; [exists 1; split; [lra|congruence]|]. assert (C : complete i j = true) by (unfold complete; destruct (Nat.eqb_spec i j); [contradiction|reflexivity]).
        pose proof (norm_neq _ _ (Ay i j Hi Hj C)) as G. unfold norm in G. set (s := Cmod (place n y i - place n y j)%C) in *. exists (s / 4). split; [lra|]. intros _ x Nx E.
        pose proof (place_near x y (s / 4) i Nx Hi) as A1. pose proof (place_near x y (s / 4) j Nx Hj) as A2. assert (s < s); [|lra]. unfold s at 1.
        replace (place n y i - place n y j)%C with (- (place n x i - place n y i) + (place n x j - place n y j))%C by (rewrite E; ring). eapply Rle_lt_trans; [apply Cmod_triangle|]. rewrite Cmod_opp. lra. }
      assert (G : dot (4 * n) l z <= c0 + del); [|unfold del in G; lra].
      apply (H l (c0 + del) (Rmin d d')); [now apply Rmin_glb_lt|]. intros x p Nx (c & Hc & O & E). pose proof (Rmin_l d d'). pose proof (Rmin_r d d').
      assert (N1 : near (4 * n) d x y) by (intros i Hi; specialize (Nx i Hi); lra). assert (N2 : near (4 * n) d' x y) by (intros i Hi; specialize (Nx i Hi); lra).
      destruct (Q c Hc) as [Q1 Q2]. assert (Gc : good c).
      { apply (Q1 x N1), O. intros i j Hi Hj L. assert (Ne : i <> j) by (intros ->; unfold complete in L; rewrite Nat.eqb_refl in L; discriminate). now apply (Q' i j Hi Hj Ne). }
      pose proof (dot_gap (4 * n) l p (law c y) (del / (W + 1))) as D. fold W in D. assert (D' : dot (4 * n) l p <= dot (4 * n) l (law c y) + del / (W + 1) * W).
      { apply D. intros i Hi. rewrite (E i Hi). left. now apply Q2. }
      assert (del / (W + 1) * W <= del). { apply Rmult_le_reg_r with (W + 1); [lra|]. replace (del / (W + 1) * W * (W + 1)) with (del * W) by (field; lra). nra. }
      assert (dot (4 * n) l (law c y) <= c0) by (apply S1; exists c; now repeat split). lra. }
  destruct (Cl e He) as (m & c & p & Hp & S1 & E).
  destruct (gather (4 * n) N good (fun c k => law c y k) m c p) as (w & W1 & W2 & W3 & W4).
  { intros k Hk. destruct (Hp k Hk) as [C0 (l & Hl & Gl & El)]. split; [exact C0|]. now exists l. }
  exists w. split; [split; [intros; apply W1|split; [intros; now apply W2|now rewrite W3]]|]. intros i Hi. rewrite <- (W4 i Hi). now apply E.
Qed.
(* within the bounds it is an element of K *)
Lemma control_law g r v i : control4 n g V' r v i = law4 n g V' r v i.
Proof.
  assert (A : Csum n (fun j => RtoC (w g i j) * (v i - v j))%C = Csum n (fun j => if g i j then v i - v j else 0)%C).
  { unfold Csum. apply injective_projections; cbn [fst snd]; apply Sum_ext; intros j _; unfold w; destruct (g i j); cbn; ring. }
  assert (B : Csum n (pair_grad g V' r i) = Csum n (pull g V' r i)).
  { unfold Csum. apply injective_projections; cbn [fst snd]; apply Sum_ext; intros j _; unfold pair_grad, grad, pull, w, norm; destruct (g i j); cbn; ring. }
  unfold control4, law4, grad_i, gradV. now rewrite A, B.
Qed.
Lemma incl_K y z : (forall i, (i < n)%nat -> norm (speed n y i) <= S) -> (forall i j, (i < n)%nat -> (j < n)%nat -> i <> j -> lo <= norm (place n y i - place n y j)%C) ->
  hull (4 * n) incl y z -> K10 n V' R0 (place n y) (speed n y) (fun i => (z (2 * n + i)%nat, z (3 * n + i)%nat)).
Proof.
  intros Sp Di H. assert (Ay : apart_at n complete (place n y)).
  { intros i j Hi Hj L E. assert (Ne : i <> j) by (intros ->; unfold complete in L; rewrite Nat.eqb_refl in L; discriminate). specialize (Di i j Hi Hj Ne). rewrite E in Di. replace (place n y j - place n y j)%C with (RtoC 0) in Di by ring. unfold norm in Di. rewrite Cmod_0 in Di. lra. }
  destruct (incl_hull y z Ay H) as (w & (W1 & W2 & W3) & E). destruct (apart_occurs _ Ay) as (c0 & Hc0 & O0).
  set (ok := fun c => occurs n R0 (place n y) (network_of n c)). set (pick := fun c => if decide (ok c) then c else c0).
  assert (Pk : forall c, ok (pick c)) by (intros c; unfold pick; destruct (decide (ok c)); assumption).
  exists N, w, (fun c => law4 n (network_of n (pick c)) V' (place n y) (speed n y)). split; [|split; [exact W3|]].
  - intros c Hc. split; [now apply W1|]. intros e He. destruct (Pk c 1 Rlt_0_1) as (q & _ & _ & Sq).
    destruct (law_is_limit n V V' (place n y) (speed n y) P Ay R0 q (occurs_pairs n R0 _ _ _ Sq (Pk c)) e He) as (q' & u & L1 & L2 & L3). exists q', u. split; [exact L1|]. split; [exact L2|].
    intros i Hi. rewrite (law4_pairs n _ _ V' (place n y) (speed n y) i Sq Hi). now apply L3.
  - intros i Hi.
    assert (Fl : forall c, ok c -> law c y (2 * n + i)%nat = fst (law4 n (network_of n c) V' (place n y) (speed n y) i) /\ law c y (3 * n + i)%nat = snd (law4 n (network_of n c) V' (place n y) (speed n y) i)).
    { intros c Oc. destruct (field_law n (network_of n c) V' lo R0 S y) with (i := i) as [_ F]; [exact Sp| |exact Hi|].
      - intros k j Hk Hj L. assert (Ne : k <> j) by (intros ->; unfold network_of in L; rewrite Nat.eqb_refl in L; discriminate). split; [now apply Di|].
        apply le_epsilon. intros e He. destruct (Oc (e / 2) ltac:(lra)) as (q & Q1 & _ & Q3). rewrite (Q3 k j Hk Hj) in L. unfold by_distance in L. apply andb_prop in L as [_ L]. destruct (Rlt_dec (Cmod (q k - q j)%C) R0) as [G|]; [|discriminate].
        pose proof (Q1 k Hk) as A1. pose proof (Q1 j Hj) as A2. unfold norm. replace (place n y k - place n y j)%C with ((q k - q j) + (- (q k - place n y k) + (q j - place n y j)))%C by ring.
        eapply Rle_trans; [apply Cmod_triangle|]. pose proof (Cmod_triangle (- (q k - place n y k))%C (q j - place n y j)%C) as T. rewrite Cmod_opp in T. lra.
      - rewrite control_law in F. apply (f_equal fst) in F as F1. apply (f_equal snd) in F as F2. cbn [fst snd] in F1, F2. now split. }
    apply injective_projections; unfold Csum; cbn [fst snd].
    + rewrite (E (2 * n + i)%nat ltac:(lia)). apply Sum_ext. intros c Hc. destruct (classic (ok c)) as [Oc|Oc].
      * unfold pick. destruct (decide (ok c)); [|contradiction]. rewrite (proj1 (Fl c Oc)). cbn. ring.
      * rewrite (W2 c Hc Oc). cbn. ring.
    + rewrite (E (3 * n + i)%nat ltac:(lia)). apply Sum_ext. intros c Hc. destruct (classic (ok c)) as [Oc|Oc].
      * unfold pick. destruct (decide (ok c)); [|contradiction]. rewrite (proj2 (Fl c Oc)). cbn. ring.
      * rewrite (W2 c Hc Oc). cbn. ring.
Qed.
End Inclusion.

(* ---- the motion ---- *)
Lemma K10_ext n V' R0 r v v' z : (forall i, (i < n)%nat -> v i = v' i) -> K10 n V' R0 r v z -> K10 n V' R0 r v' z.
Proof.
  intros E (m & c & y & H & S1 & Z). exists m, c, y. split; [|split; [exact S1|exact Z]]. intros k Hk. destruct (H k Hk) as [C0 L]. split; [exact C0|]. intros e He. destruct (L e He) as (q & u & Q1 & Q2 & Q3).
  exists q, u. split; [|split; [exact Q2|exact Q3]]. intros i Hi. rewrite <- (E i Hi). now apply Q1.
Qed.
Lemma start_power_ext n V R0 q u q' u' : (forall i, (i < n)%nat -> q i = q' i /\ u i = u' i) -> start_power n V R0 q u = start_power n V R0 q' u'.
Proof.
  intros E. unfold start_power. f_equal. apply Sum_ext. intros i Hi. destruct (E i Hi) as [-> ->]. f_equal. apply Sum_ext. intros j Hj. now destruct (E j Hj) as [-> _].
Qed.
Lemma D_cut (f : R -> R) K S t l : 0 <= K -> (forall s, Rabs (f s - f t) <= K * Rabs (s - t)) -> Rabs (f t) < S -> is_derive f t l -> is_derive (fun s => cut S (f s)) t l.
Proof.
  intros HK L B D. apply (is_derive_ext_loc f); [|exact D]. exists (mkposreal ((S - Rabs (f t)) / (K + 1)) ltac:(apply Rdiv_lt_0_compat; lra)). intros s Hs. change (Rabs (s - t) < (S - Rabs (f t)) / (K + 1)) in Hs.
  symmetry. apply cut_id. replace (f s) with (f t + (f s - f t)) by ring. eapply Rle_trans; [apply Rabs_triang|]. specialize (L s).
  assert (K * Rabs (s - t) <= S - Rabs (f t)); [|lra]. pose proof (Rabs_pos (s - t)). apply Rle_trans with ((K + 1) * Rabs (s - t)); [nra|]. apply Rle_trans with ((K + 1) * ((S - Rabs (f t)) / (K + 1))); [apply Rmult_le_compat_l; lra|right; field; lra].
Qed.
Theorem solution_from : forall n V V' R0 (q0 u0 : nat -> C), 0 < R0 -> potentials n complete V V' -> apart_at n complete q0 ->
  exists r v, (forall i, (i < n)%nat -> r i 0 = q0 i /\ v i 0 = u0 i) /\ motion10 n V' R0 r v.
Proof.
  intros n V V' R0 q0 u0 HR P A0. destruct (start_allows n V V' R0 q0 u0 HR P A0) as (d1 & Hd1 & Al). set (E := start_power n V R0 q0 u0) in *. set (S := sqrt (2 * E) + 1 + Sum n (fun i => Cmod (u0 i))). set (lo := d1 / 2).
  assert (U0 : 0 <= Sum n (fun i => Cmod (u0 i))) by (apply Sum_ge0; intros; apply Cmod_ge_0). pose proof (sqrt_pos (2 * E)) as E0. assert (HS : 0 <= S) by (unfold S; lra). assert (Hlo : 0 < lo < R0) by (unfold lo; lra).
  destruct (law_bounded n V V' R0 lo S P Hlo HS) as (M & M0 & Bd). set (F := incl n V' R0 lo S).
  assert (Fe : forall x x' w, (forall k, (k < 4 * n)%nat -> x k = x' k) -> F x w -> F x' w) by (intros x x' w; now apply (incl_ext n V V' R0 lo S P Hlo)).
  assert (Fs : forall x, exists w, F x w) by (intros x; now apply (incl_some n V' R0 lo S HR)).
  assert (Fb : forall x w k, F x w -> (k < 4 * n)%nat -> Rabs (w k) <= M) by (intros x w k (c & Hc & _ & W) Hk; rewrite (W k Hk); now apply Bd).
  set (y0 := fun k => if Nat.ltb k n then fst (q0 k) else if Nat.ltb k (2 * n) then snd (q0 (k - n)%nat) else if Nat.ltb k (3 * n) then fst (u0 (k - 2 * n)%nat) else snd (u0 (k - 3 * n)%nat)).
  set (y := solution (4 * n) F M y0).
  assert (Lip : forall k, (k < 4 * n)%nat -> forall s t, Rabs (y t k - y s k) <= M * Rabs (t - s)) by (intros k Hk s t; now apply solution_lipschitz).
  set (r := fun i t => place n (y t) i). set (v := fun i t => (cut S (y t (2 * n + i)%nat), cut S (y t (3 * n + i)%nat)) : C).
  assert (St : forall i, (i < n)%nat -> place n (y 0) i = q0 i /\ speed n (y 0) i = u0 i).
  { intros i Hi. unfold place, speed, y. rewrite !solution_start by (assumption || lia). unfold y0.
    destruct (Nat.ltb_spec i n); [|lia]. destruct (Nat.ltb_spec (n + i) n); [lia|]. destruct (Nat.ltb_spec (n + i) (2 * n)); [|lia].
    destruct (Nat.ltb_spec (2 * n + i) n); [lia|]. destruct (Nat.ltb_spec (2 * n + i) (2 * n)); [lia|]. destruct (Nat.ltb_spec (2 * n + i) (3 * n)); [|lia].
    destruct (Nat.ltb_spec (3 * n + i) n); [lia|]. destruct (Nat.ltb_spec (3 * n + i) (2 * n)); [lia|]. destruct (Nat.ltb_spec (3 * n + i) (3 * n)); [lia|].
    replace (n + i - n)%nat with i by lia. replace (2 * n + i - 2 * n)%nat with i by lia. replace (3 * n + i - 3 * n)%nat with i by lia. split; [now destruct (q0 i)|now destruct (u0 i)]. }
  (* positions *)
  assert (Pos : forall t k, 0 <= t -> (k < 2 * n)%nat -> is_derive (fun s => y s k) t (cut S (y t (2 * n + k)%nat))).
  { intros t k Ht Hk. set (c := cut S (y t (2 * n + k)%nat)).
    assert (Val : forall x w, F x w -> w k = cut S (x (2 * n + k)%nat)).
    { intros x w (l & _ & _ & W). rewrite (W k ltac:(lia)). unfold field, speed. destruct (Nat.ltb_spec k n); [reflexivity|]. destruct (Nat.ltb_spec k (2 * n)); [|lia]. cbn [snd]. now replace (3 * n + (k - n))%nat with (2 * n + k)%nat by lia. }
    assert (Sl : forall s u d, s <= u -> s = t \/ u = t -> 0 < d -> Rabs (y u k - y s k - c * (u - s)) <= (M * (u - s) + d) * (u - s)).
    { intros s u d Hsu Es Hd. set (b := M * (u - s) + d).
      assert (Up : y u k - y s k <= (c + b) * (u - s)).
      { pose proof (solution_slope (4 * n) F M y0 M0 Fe Fs Fb t s u d (delta k) (c + b) Ht Hsu Es Hd) as Q. rewrite dot_delta in Q by lia. apply Q. intros x w Nx Fx. rewrite dot_delta by lia. rewrite (Val x w Fx).
        pose proof (cut_gap S (x (2 * n + k)%nat) (y t (2 * n + k)%nat)) as G. pose proof (Nx (2 * n + k)%nat ltac:(lia)) as G'. apply Rabs_le_between in G. fold y in G'. fold c in G. fold b in G'. lra. }
      assert (Dn : - (y u k - y s k) <= (- c + b) * (u - s)).
      { pose proof (solution_slope (4 * n) F M y0 M0 Fe Fs Fb t s u d (fun i => - delta k i) (- c + b) Ht Hsu Es Hd) as Q. rewrite dot_delta_opp in Q by lia. apply Q. intros x w Nx Fx. rewrite dot_delta_opp by lia. rewrite (Val x w Fx).
        pose proof (cut_gap S (x (2 * n + k)%nat) (y t (2 * n + k)%nat)) as G. pose proof (Nx (2 * n + k)%nat ltac:(lia)) as G'. apply Rabs_le_between in G. fold y in G'. fold c in G. fold b in G'. lra. }
      apply Rabs_le. split; nra. }
    apply is_derive_Reals. intros e He. assert (Hdel : 0 < e / (4 * (M + 1))) by (apply Rdiv_lt_0_compat; lra). exists (mkposreal _ Hdel). cbn. intros h Nh Hh.
    assert (Ph : 0 < Rabs h) by now apply Rabs_pos_lt.
    assert (Mh : M * Rabs h <= e / 4).
    { apply Rle_trans with ((M + 1) * Rabs h); [nra|]. apply Rle_trans with ((M + 1) * (e / (4 * (M + 1)))); [apply Rmult_le_compat_l; lra|right; field; lra]. }
    assert (W : Rabs (y (t + h) k - y t k - c * h) <= e / 2 * Rabs h).
    { destruct (Rle_or_lt 0 h) as [G|G].
      - pose proof (Sl t (t + h) (e / 4) ltac:(lra) (or_introl eq_refl) ltac:(lra)) as Q. replace (t + h - t) with h in Q by ring. rewrite (Rabs_pos_eq h) in * by lra. eapply Rle_trans; [exact Q|]. apply Rmult_le_compat_r; lra.
      - pose proof (Sl (t + h) t (e / 4) ltac:(lra) (or_intror eq_refl) ltac:(lra)) as Q. replace (t - (t + h)) with (- h) in Q by ring. rewrite (Rabs_left h) in * by lra.
        replace (y (t + h) k - y t k - c * h) with (- (y t k - y (t + h) k - c * - h)) by ring. rewrite Rabs_Ropp. eapply Rle_trans; [exact Q|]. apply Rmult_le_compat_r; lra. }
    replace ((y (t + h) k - y t k) / h - c) with ((y (t + h) k - y t k - c * h) / h) by (now field). unfold Rdiv at 1. rewrite Rabs_mult, Rabs_inv. apply Rle_lt_trans with (e / 2 * Rabs h * / Rabs h).
    - apply Rmult_le_compat_r; [left; now apply Rinv_0_lt_compat|exact W].
    - rewrite Rmult_assoc, Rinv_r; lra. }
  assert (Vel : forall t i, 0 <= t -> (i < n)%nat -> is_velocity (r i) t (v i t)).
  { intros t i Ht Hi. split; cbn [fst snd v].
    - exact (Pos t i Ht ltac:(lia)).
    - pose proof (Pos t (n + i)%nat Ht ltac:(lia)) as Q. replace (2 * n + (n + i))%nat with (3 * n + i)%nat in Q by lia. exact Q. }
  assert (Ac : forall i, (i < n)%nat -> absolutely_continuous (v i)).
  { intros i Hi T e HT He. exists (e / (2 * M + 1)). split; [apply Rdiv_lt_0_compat; lra|]. intros m a b I O Q.
    apply Rle_lt_trans with (2 * M * Sum m (fun k => b k - a k)).
    - rewrite <- Sum_scal. apply Sum_le. intros k Hk. destruct (I k Hk) as [[_ I1] _]. eapply Rle_trans; [apply axes_Cmod|]. unfold v. cbn [fst snd Cminus Cplus Copp].
      pose proof (cut_gap S (y (b k) (2 * n + i)%nat) (y (a k) (2 * n + i)%nat)) as G1. pose proof (cut_gap S (y (b k) (3 * n + i)%nat) (y (a k) (3 * n + i)%nat)) as G2.
      pose proof (Lip (2 * n + i)%nat ltac:(lia) (a k) (b k)) as L1. pose proof (Lip (3 * n + i)%nat ltac:(lia) (a k) (b k)) as L2. rewrite (Rabs_pos_eq (b k - a k)) in L1, L2 by lra. unfold Rminus in *. lra.
    - assert (0 <= Sum m (fun k => b k - a k)) by (apply Sum_ge0; intros k Hk; destruct (I k Hk); lra). apply Rle_lt_trans with ((2 * M + 1) * Sum m (fun k => b k - a k) - Sum m (fun k => b k - a k)); [lra|].
      destruct (Req_dec (Sum m (fun k => b k - a k)) 0) as [Z|Z]; [rewrite Z; lra|]. apply (Rmult_lt_compat_l (2 * M + 1)) in Q; [|lra]. replace ((2 * M + 1) * (e / (2 * M + 1))) with e in Q by (field; lra). lra. }
  (* within the bounds *)
  set (inside := fun t => (forall i j, (i < n)%nat -> (j < n)%nat -> i <> j -> lo < norm (place n (y t) i - place n (y t) j)%C) /\ forall i, (i < n)%nat -> norm (speed n (y t) i) < S).
  set (during := fun t => forall s, 0 <= s <= t -> inside s).
  assert (Vin : forall t i, inside t -> (i < n)%nat -> v i t = speed n (y t) i).
  { intros t i [_ I] Hi. specialize (I i Hi). pose proof (Rmax_Cmod (speed n (y t) i)) as Q. unfold norm in I. pose proof (Rmax_l (Rabs (fst (speed n (y t) i))) (Rabs (snd (speed n (y t) i)))) as Q1. pose proof (Rmax_r (Rabs (fst (speed n (y t) i))) (Rabs (snd (speed n (y t) i)))) as Q2.
    unfold v. unfold speed in *. cbn [fst snd] in *. rewrite !cut_id by lra. reflexivity. }
  assert (MW : moves_while n V' R0 r v during).
  { split; [|split; [exact Vel|split; [exact Ac|]]].
    - intros i j Hi Hj L Eq. unfold r in Eq. rewrite (proj1 (St i Hi)), (proj1 (St j Hj)) in Eq. now apply (A0 i j).
    - exists (fun t => exists k, (k < 4 * n)%nat /\ ~ exists l, is_derive (fun s => y s k) t l). split.
      + apply (negligible_some (4 * n) (fun k t => ~ exists l, is_derive (fun s => y s k) t l)). intros k Hk. apply (lipschitz_derivatives (fun s => y s k) M). now apply Lip.
      + intros t Ht Du Nt _. set (z := fun k => Derive (fun s => y s k) t).
        assert (D : forall k, (k < 4 * n)%nat -> is_derive (fun s => y s k) t (z k)).
        { intros k Hk. apply Derive_correct. apply NNPP. intros X. apply Nt. exists k. split; [exact Hk|]. intros [l Dl]. apply X. now exists l. }
        pose proof (Du t ltac:(lra)) as In. exists (fun i => (z (2 * n + i)%nat, z (3 * n + i)%nat)). split.
        * apply (K10_ext n V' R0 (fun i => r i t) (speed n (y t))); [intros i Hi; symmetry; now apply Vin|]. apply (incl_K n V V' R0 lo S HR P Hlo HS (y t) z).
          -- intros i Hi. left. now apply In.
          -- intros i j Hi Hj Ne. left. now apply In.
          -- now apply (solution_derivative (4 * n) F M y0 M0 Fe Fs Fb t z Ht).
        * intros i Hi. pose proof (proj2 In i Hi) as I. pose proof (Rmax_Cmod (speed n (y t) i)) as Q. unfold norm in I. pose proof (Rmax_l (Rabs (fst (speed n (y t) i))) (Rabs (snd (speed n (y t) i)))) as Q1. pose proof (Rmax_r (Rabs (fst (speed n (y t) i))) (Rabs (snd (speed n (y t) i)))) as Q2.
          unfold speed in I, Q, Q1, Q2. cbn [fst snd] in I, Q, Q1, Q2. split; cbn [fst snd v].
          -- apply (D_cut (fun s => y s (2 * n + i)%nat) M S); [exact M0|intros s; apply Lip; lia|lra|apply D; lia].
          -- apply (D_cut (fun s => y s (3 * n + i)%nat) M S); [exact M0|intros s; apply Lip; lia|lra|apply D; lia]. }
  assert (Al0 : allows n V R0 (fun i => r i 0) (fun i => v i 0) d1 /\ (forall i, (i < n)%nat -> v i 0 = u0 i)).
  { assert (Sm : forall i, (i < n)%nat -> v i 0 = u0 i).
    { intros i Hi. rewrite <- (proj2 (St i Hi)). pose proof (Rmax_Cmod (speed n (y 0) i)) as Q. pose proof (Rmax_l (Rabs (fst (speed n (y 0) i))) (Rabs (snd (speed n (y 0) i)))) as Q1. pose proof (Rmax_r (Rabs (fst (speed n (y 0) i))) (Rabs (snd (speed n (y 0) i)))) as Q2.
      assert (Q3 : Cmod (speed n (y 0) i) <= S). { rewrite (proj2 (St i Hi)). pose proof (Sum_term_le n (fun i => Cmod (u0 i)) i (fun k _ => Cmod_ge_0 _) Hi) as T. cbv beta in T. unfold S. lra. }
      unfold v, speed in *. cbn [fst snd] in *. rewrite !cut_id by lra. reflexivity. }
    split; [|exact Sm]. split; [exact Hd1|]. intros i j Hi Hj Ne. unfold r at 1 2. rewrite (proj1 (St i Hi)), (proj1 (St j Hj)).
    rewrite (start_power_ext n V R0 (fun i => r i 0) (fun i => v i 0) q0 u0) by (intros k Hk; split; [exact (proj1 (St k Hk))|now apply Sm]). now apply Al. }
  destruct Al0 as [Al0 V0].
  assert (Sharp : forall t, 0 <= t -> during t -> (forall i j, (i < n)%nat -> (j < n)%nat -> i <> j -> d1 < norm (place n (y t) i - place n (y t) j)%C) /\ forall i, (i < n)%nat -> norm (speed n (y t) i) <= sqrt (2 * E)).
  { intros t Ht Du. assert (Du' : forall u, 0 <= u <= t -> during u) by (intros u Hu s Hs; apply Du; lra). split.
    - intros i j Hi Hj Ne. exact (kept_apart_while n V V' R0 r v HR P during MW d1 Al0 t Ht Du' i j Hi Hj Ne).
    - intros i Hi. rewrite <- (Vin t i (Du t ltac:(lra)) Hi).
      pose proof (power_falls n V V' R0 r v P during MW lo Hlo 0 t 0 ltac:(lra) Du' (fun u k j Hu Hk Hj Ne => proj1 (Du u Hu) k j Hk Hj Ne)) as Fl.
      assert (Fl' : power n V R0 r v lo t <= power n V R0 r v lo 0 - 0 * (t - 0)) by (apply Fl; intros u _; rewrite Rmult_0_r; apply Sum_ge0; intros k _; apply Sum_ge0; intros j _; destruct (by_distance _ R0 k j); [apply dist2_ge0|lra]).
      assert (Pe : power n V R0 r v lo 0 = E).
      { transitivity (start_power n V R0 (fun i => r i 0) (fun i => v i 0)); [|apply start_power_ext; intros k Hk; split; [exact (proj1 (St k Hk))|now apply V0]].
        unfold power, start_power. f_equal. apply Sum_ext. intros k Hk. f_equal. apply Sum_ext. intros l Hl. unfold store. destruct (Nat.eqb_spec k l) as [_|Nkl]; [reflexivity|].
        pose proof (proj1 (proj2 Al0 k l Hk Hl Nkl)). rewrite clamp_mid by (unfold lo; lra). reflexivity. }
      pose proof (speed_le n V V' R0 r v P lo Hlo i t Hi) as Q. unfold norm. rewrite <- (sqrt_pow2 (Cmod (v i t))) by apply Cmod_ge_0. apply sqrt_le_1_alt. lra. }
  assert (Mv : forall s t i, (i < n)%nat -> Cmod (place n (y t) i - place n (y s) i)%C <= 2 * M * Rabs (t - s) /\ Cmod (speed n (y t) i - speed n (y s) i)%C <= 2 * M * Rabs (t - s)).
  { intros s t i Hi. pose proof (Lip i ltac:(lia) s t). pose proof (Lip (n + i)%nat ltac:(lia) s t). pose proof (Lip (2 * n + i)%nat ltac:(lia) s t). pose proof (Lip (3 * n + i)%nat ltac:(lia) s t).
    split; (eapply Rle_trans; [apply axes_Cmod|]); unfold place, speed; cbn [fst snd Cminus Cplus Copp]; unfold Rminus in *; lra. }
  set (eta := Rmin (d1 / (16 * (M + 1))) (/ (4 * (M + 1)))). assert (Heta : 0 < eta) by (apply Rmin_glb_lt; [apply Rdiv_lt_0_compat; lra|apply Rinv_0_lt_compat; lra]).
  assert (Me1 : 4 * M * eta <= d1 / 4).
  { apply Rle_trans with (4 * (M + 1) * eta); [apply Rmult_le_compat_r; lra|]. apply Rle_trans with (4 * (M + 1) * (d1 / (16 * (M + 1)))); [apply Rmult_le_compat_l; [lra|apply Rmin_l]|right; field; lra]. }
  assert (Me2 : 2 * M * eta <= 1 / 2).
  { apply Rle_trans with (2 * (M + 1) * eta); [apply Rmult_le_compat_r; lra|]. apply Rle_trans with (2 * (M + 1) * / (4 * (M + 1))); [apply Rmult_le_compat_l; [lra|apply Rmin_r]|right; field; lra]. }
  (* what is sharp at a time is within the bounds for a time around *)
  assert (Around : forall s t, 0 <= s -> during s -> Rabs (t - s) <= eta -> inside t).
  { intros s t Hs Du Hst. destruct (Sharp s Hs Du) as [S1 S2]. pose proof (Rabs_pos (t - s)). assert (Ms : M * Rabs (t - s) <= M * eta) by (apply Rmult_le_compat_l; lra). split.
    - intros i j Hi Hj Ne. specialize (S1 i j Hi Hj Ne). destruct (Mv s t i Hi) as [X _], (Mv s t j Hj) as [Y _]. unfold norm in *.
      assert (T : Cmod (place n (y s) i - place n (y s) j)%C <= Cmod (place n (y t) i - place n (y t) j)%C + (2 * M * Rabs (t - s) + 2 * M * Rabs (t - s))).
      { replace (place n (y s) i - place n (y s) j)%C with ((place n (y t) i - place n (y t) j) + (- (place n (y t) i - place n (y s) i) + (place n (y t) j - place n (y s) j)))%C by ring.
        eapply Rle_trans; [apply Cmod_triangle|]. apply Rplus_le_compat_l. eapply Rle_trans; [apply Cmod_triangle|]. rewrite Cmod_opp. lra. }
      unfold lo. lra.
    - intros i Hi. specialize (S2 i Hi). destruct (Mv s t i Hi) as [_ X]. unfold norm in *.
      assert (T : Cmod (speed n (y t) i) <= Cmod (speed n (y s) i) + 2 * M * Rabs (t - s)).
      { replace (speed n (y t) i) with (speed n (y s) i + (speed n (y t) i - speed n (y s) i))%C at 1 by ring. eapply Rle_trans; [apply Cmod_triangle|]. lra. }
      unfold S. lra. }
  assert (All : forall t, 0 <= t -> during t).
  { apply (real_induction during).
    - intros t Ht H s Hs. destruct (Req_dec t 0) as [->|Nt].
      + replace s with 0 by lra. split.
        * intros i j Hi Hj Ne. rewrite (proj1 (St i Hi)), (proj1 (St j Hj)). pose proof (proj1 (Al i j Hi Hj Ne)). unfold norm, lo. lra.
        * intros i Hi. rewrite (proj2 (St i Hi)). pose proof (Sum_term_le n (fun i => Cmod (u0 i)) i (fun k _ => Cmod_ge_0 _) Hi) as T. cbv beta in T. unfold norm, S. lra.
      + destruct (Rlt_or_le s t) as [L|L]; [apply (H s ltac:(lra)); lra|]. replace s with t by lra. pose proof (Rmin_l eta t). pose proof (Rmin_r eta t). assert (0 < Rmin eta t) by (apply Rmin_glb_lt; lra).
        apply (Around (t - Rmin eta t) t ltac:(lra)); [apply H; lra|]. rewrite Rabs_pos_eq; lra.
    - intros t Ht Du. exists eta. split; [exact Heta|]. intros u Hu s Hs. destruct (Rle_or_lt s t) as [L|L]; [apply Du; lra|]. apply (Around t s Ht Du). rewrite Rabs_pos_eq; lra. }
  exists r, v. split; [intros i Hi; split; [exact (proj1 (St i Hi))|now apply V0]|]. destruct MW as (B1 & B2 & B3 & Z & HZ & B4). split; [exact B1|]. split; [exact B2|]. split; [exact B3|].
  exists Z. split; [exact HZ|]. intros t Ht Nt At. now apply B4; [|apply All| |].
Qed.
