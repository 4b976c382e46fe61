(* Tanner, Jadbabaie, Pappas, links by distance: along every solution of (10) whose graph is connected at all times the configuration approaches those with 0
   in the convex hull of the limits of the gradients of all agents together.
   Late in the motion velocities nearly agree and keep nearly constant. If the configuration came back to near one that is not critical, a direction in which
   all gradients of networks that occur there are negative would speed agents up at a rate bounded below, for a fixed time.
     tanner2.thm2_pot (corrected). *)
From Coq Require Import Reals Lra Lia Psatz Classical Relations.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums inclusions paley_model paley_phase paley_laplacian paley_gradient tanner_energy tanner_flock tanner2_filippov tanner2_limits tanner2_solutions lipschitz.
From Flockproof Require tanner2_appendix tanner2_existence tanner2_unique tanner2_onward tanner_trees.
Open Scope R_scope.

Definition limit_of_gradients n V' R0 (r y : nat -> C) := forall e, 0 < e -> exists q : nat -> C, (forall i, (i < n)%nat -> Cmod (q i - r i)%C < e) /\ generic n R0 q /\
  forall i, (i < n)%nat -> Cmod (gradV n (by_distance q R0) V' q i - y i)%C < e.
Definition K_gradients n V' R0 (r z : nat -> C) := exists m (c : nat -> R) (y : nat -> nat -> C), (forall k, (k < m)%nat -> 0 <= c k /\ limit_of_gradients n V' R0 r (y k)) /\ Sum m c = 1 /\
  forall i, (i < n)%nat -> z i = Csum m (fun k => RtoC (c k) * y k i)%C.
Definition critical n V' R0 (r : nat -> C) := apart_at n complete r /\ K_gradients n V' R0 r (fun _ => RtoC 0).
Definition rest : nat -> C := fun _ => RtoC 0.

Lemma law4_rest n g V' q i : law4 n g V' q rest i = (- gradV n g V' q i)%C.
Proof.
  unfold law4, rest. replace (Csum n (fun j => if g i j then 0 - 0 else 0)%C) with (RtoC 0); [ring|]. unfold Csum. apply injective_projections; cbn [fst snd RtoC]; symmetry; apply Sum_zero; intros j _; destruct (g i j); cbn; ring.
Qed.
(* a critical configuration without a pair at R is one where the gradients vanish *)
Lemma critical_generic n V V' R0 r : potentials n complete V V' -> critical n V' R0 r -> generic n R0 r -> forall i, (i < n)%nat -> gradV n (by_distance r R0) V' r i = RtoC 0.
Proof.
  intros P [A (m & c & y & H & S1 & Z)] G i Hi.
  assert (K : K10 n V' R0 r rest rest).
  { exists m, c, (fun k i => (- y k i)%C). split; [|split; [exact S1|]].
    - intros k Hk. destruct (H k Hk) as [C0 L]. split; [exact C0|]. intros e He. destruct (L e He) as (q & Q1 & Q2 & Q3). exists q, rest. split; [|split; [exact Q2|]].
      + intros j Hj. split; [now apply Q1|]. replace (rest j - rest j)%C with (RtoC 0) by ring. now rewrite Cmod_0.
      + intros j Hj. rewrite law4_rest. replace (- gradV n (by_distance q R0) V' q j - - y k j)%C with (- (gradV n (by_distance q R0) V' q j - y k j))%C by ring. rewrite Cmod_opp. now apply Q3.
    - intros j Hj. specialize (Z j Hj). unfold rest. transitivity (- Csum m (fun k => RtoC (c k) * y k j))%C; [rewrite <- Z; ring|]. unfold Csum. apply injective_projections; cbn [fst snd Copp]; rewrite <- Sum_opp; apply Sum_ext; intros k _; cbn; ring. }
  pose proof (tanner2_unique.off_ties n V V' R0 r rest rest P A G K i Hi) as E. rewrite law4_rest in E. unfold rest in E. transitivity (- - gradV n (by_distance r R0) V' r i)%C; [ring|]. rewrite <- E. ring.
Qed.
Lemma gradient_limit n V V' R0 r g : potentials n complete V V' -> apart_at n complete r -> occurs n R0 r g -> limit_of_gradients n V' R0 r (gradV n g V' r).
Proof.
  intros P A O e He. destruct (O 1 Rlt_0_1) as (q0 & _ & _ & E0). pose proof (pos_INR n) as Pn.
  destruct (law4_near n V V' r rest P A (by_distance q0 R0) e ltac:(intros i _; apply by_distance_simple) He) as (d & Hd & L).
  destruct (O (Rmin d e) ltac:(now apply Rmin_glb_lt)) as (q & Q1 & Q2 & Q3). pose proof (Rmin_l d e). pose proof (Rmin_r d e). exists q. split; [intros i Hi; specialize (Q1 i Hi); lra|]. split; [exact Q2|]. intros i Hi.
  assert (S1 : same_pairs n (by_distance q0 R0) (by_distance q R0)) by (intros a b Ha Hb; rewrite <- (E0 a b Ha Hb); now apply Q3).
  specialize (L q rest ltac:(intros k Hk; split; [specialize (Q1 k Hk); lra|]; replace (rest k - rest k)%C with (RtoC 0) by ring; rewrite Cmod_0; exact Hd) i Hi).
  rewrite (law4_pairs n _ _ V' q rest i S1 Hi) in L. rewrite (law4_pairs n _ g V' r rest i) in L by (try exact Hi; intros a b Ha Hb; symmetry; now apply E0). rewrite !law4_rest in L.
  replace (gradV n (by_distance q R0) V' q i - gradV n g V' r i)%C with (- (- gradV n (by_distance q R0) V' q i - - gradV n g V' r i))%C by ring. now rewrite Cmod_opp.
Qed.

(* ---- 2n real coordinates ---- *)
Definition flat n (y : nat -> C) (k : nat) : R := if Nat.ltb k n then fst (y k) else snd (y (k - n)%nat).
Lemma flat_le n y k b : (forall i, (i < n)%nat -> Cmod (y i) <= b) -> (k < 2 * n)%nat -> Rabs (flat n y k) <= b.
Proof.
  intros H Hk. unfold flat. destruct (Nat.ltb_spec k n) as [L|L].
  - specialize (H k L). pose proof (Rmax_Cmod (y k)). pose proof (Rmax_l (Rabs (fst (y k))) (Rabs (snd (y k)))). lra.
  - specialize (H (k - n)%nat ltac:(lia)). pose proof (Rmax_Cmod (y (k - n)%nat)). pose proof (Rmax_r (Rabs (fst (y (k - n)%nat))) (Rabs (snd (y (k - n)%nat)))). lra.
Qed.
Lemma dot_le m l y b : (forall k, (k < m)%nat -> Rabs (y k) <= b) -> Rabs (dot m l y) <= b * Sum m (fun k => Rabs (l k)).
Proof.
  intros H. unfold dot. eapply Rle_trans; [apply Sum_Rabs|]. rewrite <- Sum_scal. apply Sum_le. intros k Hk. rewrite Rabs_mult, Rmult_comm. apply Rmult_le_compat_r; [apply Rabs_pos|now apply H].
Qed.
Lemma grad_moved n g V' r a i : gradV n g V' (fun k => (r k - a)%C) i = gradV n g V' r i.
Proof.
  unfold gradV, Csum. apply injective_projections; cbn [fst snd]; apply Sum_ext; intros j _; unfold pull; replace (r i - a - (r j - a))%C with (r i - r j)%C by ring; reflexivity.
Qed.
Lemma occurs_moved n R0 r g a : occurs n R0 r g -> occurs n R0 (fun k => (r k - a)%C) g.
Proof.
  intros O e He. destruct (O e He) as (q & Q1 & Q2 & Q3). exists (fun k => (q k - a)%C). split; [|split].
  - intros i Hi. replace (q i - a - (r i - a))%C with (q i - r i)%C by ring. now apply Q1.
  - intros i j Hi Hj Ne. replace (q i - a - (q j - a))%C with (q i - q j)%C by ring. now apply Q2.
  - intros i j Hi Hj. rewrite (Q3 i j Hi Hj). unfold by_distance. replace (q i - a - (q j - a))%C with (q i - q j)%C by ring. reflexivity.
Qed.
Lemma critical_moved n V' R0 r a : critical n V' R0 r -> critical n V' R0 (fun k => (r k - a)%C).
Proof.
  intros [A (m & c & y & H & S1 & Z)]. split.
  - intros i j Hi Hj L E. apply (A i j Hi Hj L). transitivity (r i - a + a)%C; [ring|]. rewrite E. ring.
  - exists m, c, y. split; [|now split]. intros k Hk. destruct (H k Hk) as [C0 L]. split; [exact C0|]. intros e He. destruct (L e He) as (q & Q1 & Q2 & Q3). exists (fun k => (q k - a)%C). split; [|split].
    + intros i Hi. replace (q i - a - (r i - a))%C with (q i - r i)%C by ring. now apply Q1.
    + intros i j Hi Hj Ne. replace (q i - a - (q j - a))%C with (q i - q j)%C by ring. now apply Q2.
    + intros i Hi. specialize (Q3 i Hi). rewrite <- (grad_moved n (by_distance q R0) V' q a i) in Q3. replace (gradV n (by_distance (fun k0 => (q k0 - a)%C) R0) V' (fun k0 => (q k0 - a)%C) i) with (gradV n (by_distance q R0) V' (fun k0 => (q k0 - a)%C) i); [exact Q3|].
      unfold gradV, Csum. apply injective_projections; cbn [fst snd]; apply Sum_ext; intros j _; unfold pull, by_distance; replace (q i - a - (q j - a))%C with (q i - q j)%C by ring; reflexivity.
Qed.
(* near a configuration that is not critical all gradients point away from one direction *)
Lemma pushes n V V' R0 s : (1 <= n)%nat -> 0 < R0 -> potentials n complete V V' -> apart_at n complete s -> ~ critical n V' R0 s -> exists l del d, 0 < del /\ 0 < d /\
  forall x g, (forall i, (i < n)%nat -> Cmod (x i - s i)%C < d) -> occurs n R0 x g -> dot (2 * n) l (flat n (gradV n g V' x)) <= - del.
Proof.
  intros Hn HR P As Nc. set (N := (2 ^ (n * n))%nat). set (good := fun c => occurs n R0 s (network_of n c)). set (Y := fun c => flat n (gradV n (network_of n c) V' s)).
  set (A := fun p : nat -> R => exists c, (c < N)%nat /\ good c /\ forall k, (k < 2 * n)%nat -> p k = Y c k).
  assert (Nh : ~ tanner2_appendix.closed_hull (2 * n) A (fun _ => 0)).
  { intros Cl. apply Nc. split; [exact As|]. destruct (finite_hull (2 * n) N good Y (fun _ => 0)) as (w & (W1 & W2 & W3) & E).
    { intros e He. destruct (Cl e He) as (m & c & p & Hp & S1 & E). destruct (gather (2 * n) N good Y m c p) as (w & W1 & W2 & W3 & W4).
      { intros k Hk. destruct (Hp k Hk) as [C0 (l & Hl & Gl & El)]. split; [exact C0|]. now exists l. }
      exists w. split; [split; [intros; apply W1|split; [intros; now apply W2|now rewrite W3]]|]. intros i Hi. rewrite <- (W4 i Hi). now apply E. }
    destruct (apart_occurs n R0 (R0 / 2) HR ltac:(lra) s As) as (c0 & Hc0 & O0). set (pick := fun c => if decide (good c) then c else c0). assert (Pk : forall c, good (pick c)) by (intros c; unfold pick; destruct (decide (good c)); assumption).
    exists N, w, (fun c => gradV n (network_of n (pick c)) V' s). split; [|split; [exact W3|]].
    - intros c Hc. split; [now apply W1|]. exact (gradient_limit n V V' R0 s _ P As (Pk c)).
    - intros i Hi. unfold Csum. apply injective_projections; cbn [fst snd RtoC].
      + rewrite (E i ltac:(lia)). apply Sum_ext. intros c Hc. destruct (classic (good c)) as [Gc|Gc]; [|rewrite (W2 c Hc Gc); cbn; ring]. unfold pick. destruct (decide (good c)); [|contradiction]. unfold Y, flat. destruct (Nat.ltb_spec i n); [|lia]. cbn. ring.
      + rewrite (E (n + i)%nat ltac:(lia)). apply Sum_ext. intros c Hc. destruct (classic (good c)) as [Gc|Gc]; [|rewrite (W2 c Hc Gc); cbn; ring]. unfold pick. destruct (decide (good c)); [|contradiction]. unfold Y, flat. destruct (Nat.ltb_spec (n + i) n); [lia|]. replace (n + i - n)%nat with i by lia. cbn. ring. }
  set (M := Sum N (fun c => Sum (2 * n) (fun k => Rabs (Y c k)))).
  destruct (tanner2_existence.separate (2 * n) A (fun _ => 0) M) as (l & c0 & S1 & S2); [| |exact Nh|].
  { destruct (apart_occurs n R0 (R0 / 2) HR ltac:(lra) s As) as (c & Hc & O). exists (Y c), c. now repeat split. }
  { intros y i (c & Hc & _ & E) Hi. rewrite (E i Hi). eapply Rle_trans; [apply (Sum_term_le (2 * n) (fun k => Rabs (Y c k)) i); [intros; apply Rabs_pos|exact Hi]|].
    apply (Sum_term_le N (fun c => Sum (2 * n) (fun k => Rabs (Y c k))) c); [intros; apply Sum_ge0; intros; apply Rabs_pos|exact Hc]. }
  assert (Z : dot (2 * n) l (fun _ => 0) = 0) by (unfold dot; apply Sum_zero; intros; ring). rewrite Z in S2. set (W := Sum (2 * n) (fun k => Rabs (l k))). assert (W0 : 0 <= W) by (apply Sum_ge0; intros; apply Rabs_pos).
  set (del := - c0 / 2). assert (Hdel : 0 < del) by (unfold del; lra).
  destruct (small N (fun c d => forall x, (forall i, (i < n)%nat -> Cmod (x i - s i)%C < d) -> occurs n R0 x (network_of n c) -> good c /\ forall i, (i < n)%nat -> Cmod (gradV n (network_of n c) V' x i - gradV n (network_of n c) V' s i)%C < del / (W + 1))) as (d & Hd & Q).
  { intros c d d' H L x Nx. apply H. intros i Hi. specialize (Nx i Hi). lra. }
  { intros c Hc. assert (X : exists d, 0 < d /\ forall x, (forall i, (i < n)%nat -> Cmod (x i - s i)%C < d) -> occurs n R0 x (network_of n c) -> good c).
    { destruct (classic (good c)) as [G|G]; [exists 1; split; [lra|]; intros; exact G|]. apply not_all_ex_not in G. destruct G as [e G]. apply imply_to_and in G. destruct G as [He G]. exists (e / 2). split; [lra|]. intros x Nx O. exfalso. apply G.
      destruct (O (e / 2) ltac:(lra)) as (q & Q1 & Q2). exists q. split; [|exact Q2]. intros i Hi. specialize (Q1 i Hi). specialize (Nx i Hi). replace (q i - s i)%C with ((q i - x i) + (x i - s i))%C by ring. eapply Rle_lt_trans; [apply Cmod_triangle|]. lra. }
    destruct X as (d1 & H1 & X1). destruct (law4_near n V V' s rest P As (network_of n c) (del / (W + 1))) as (d2 & H2 & X2); [intros i _; unfold network_of; now rewrite Nat.eqb_refl|apply Rdiv_lt_0_compat; lra|].
    exists (Rmin d1 d2). pose proof (Rmin_l d1 d2). pose proof (Rmin_r d1 d2). split; [now apply Rmin_glb_lt|]. intros x Nx O. split; [apply (X1 x); [intros i Hi; specialize (Nx i Hi); lra|exact O]|]. intros i Hi.
    specialize (X2 x rest ltac:(intros k Hk; split; [specialize (Nx k Hk); lra|]; replace (rest k - rest k)%C with (RtoC 0) by ring; rewrite Cmod_0; exact H2) i Hi). rewrite !law4_rest in X2.
    replace (gradV n (network_of n c) V' x i - gradV n (network_of n c) V' s i)%C with (- (- gradV n (network_of n c) V' x i - - gradV n (network_of n c) V' s i))%C by ring. now rewrite Cmod_opp. }
  exists l, del, d. split; [exact Hdel|]. split; [exact Hd|]. intros x g Nx O. destruct (numbered_occurs n R0 x g O) as (c & Hc & Sm & Oc). destruct (Q c Hc x Nx Oc) as [Gc Gn].
  assert (E : forall k, (k < 2 * n)%nat -> Rabs (flat n (gradV n g V' x) k - Y c k) <= del / (W + 1)).
  { intros k Hk. assert (Eg : forall i, (i < n)%nat -> gradV n g V' x i = gradV n (network_of n c) V' x i) by (intros i Hi; apply Csum_ext; intros j Hj; unfold pull; now rewrite (Sm i j Hi Hj)).
    pose proof (flat_le n (fun i => (gradV n g V' x i - gradV n (network_of n c) V' s i)%C) k (del / (W + 1))) as F. assert (Ef : flat n (fun i => (gradV n g V' x i - gradV n (network_of n c) V' s i)%C) k = flat n (gradV n g V' x) k - Y c k) by (unfold Y, flat; destruct (Nat.ltb k n); reflexivity).
    rewrite <- Ef. apply F; [|exact Hk]. intros i Hi. rewrite (Eg i Hi). left. now apply Gn. }
  pose proof (dot_gap (2 * n) l (flat n (gradV n g V' x)) (Y c) (del / (W + 1)) E) as G. fold W in G. assert (dot (2 * n) l (Y c) <= c0) by (apply S1; exists c; now repeat split).
  assert (del / (W + 1) * W <= del). { apply Rmult_le_reg_r with (W + 1); [lra|]. replace (del / (W + 1) * W * (W + 1)) with (del * W) by (field; lra). nra. } unfold del in *. lra.
Qed.

(* ---- along a solution ---- *)
Section Along.
Variables (n : nat) (V V' : nat -> nat -> R -> R) (R0 : R) (r v : nat -> R -> C).
Hypothesis Hn : (1 <= n)%nat.
Hypothesis HR : 0 < R0.
Hypothesis P : potentials n complete V V'.
Hypothesis M : motion10 n V' R0 r v.
Hypothesis SC : forall t, 0 <= t -> strongly_connected n (by_distance (fun i => r i t) R0).
Lemma agree_late e : 0 < e -> exists T, 0 <= T /\ forall t, T <= t -> forall i j, (i < n)%nat -> (j < n)%nat -> Cmod (v i t - v j t)%C < e.
Proof.
  intros He. destruct (small2 n (fun i j d => forall t, / d <= t -> Cmod (v i t - v j t)%C < e)) as (d & Hd & Q).
  - intros i j d d' H L t Ht. apply H. eapply Rle_trans; [|exact Ht]. apply Rinv_le_contravar; lra.
  - intros i j Hi Hj. destruct (velocities_agree n V V' R0 r v HR P M SC i j Hi Hj e He) as [T HT]. exists (/ (Rabs T + 1)). pose proof (Rabs_pos T). split; [apply Rinv_0_lt_compat; lra|]. intros t Ht. rewrite Rinv_inv in Ht. apply HT. pose proof (Rle_abs T). lra.
  - exists (/ d). split; [left; now apply Rinv_0_lt_compat|]. intros t Ht i j Hi Hj. now apply (Q i j Hi Hj).
Qed.
Lemma momentum : forall a b, 0 <= a <= b -> Sum n (fun i => fst (v i b)) = Sum n (fun i => fst (v i a)) /\ Sum n (fun i => snd (v i b)) = Sum n (fun i => snd (v i a)).
Proof.
  intros a b Hab. destruct (kept_apart n V V' R0 r v HR P M) as (d & Hd & Far). destruct (rates_bounded n V V' R0 r v P M d Hd Far) as (N & B & HN & _ & Q).
  assert (Ax : forall i, (i < n)%nat -> ac (fun t => fst (v i t)) /\ ac (fun t => snd (v i t))) by (intros i Hi; apply ac_axes; now apply M).
  assert (K : forall F : R -> R, ac F -> (forall t, 0 <= t -> ~ N t -> is_derive F t 0) -> F b = F a).
  { intros F AF D. apply Rle_antisym.
    - apply (ac_falls F N a b AF HN Hab). intros t Ht Nt. exists 0. split; [apply D; [lra|exact Nt]|lra].
    - assert (X : -1 * F b <= -1 * F a); [|lra]. apply (ac_falls (fun t => -1 * F t) N a b (ac_scal (-1) F AF) HN Hab). intros t Ht Nt. exists (-1 * 0). split; [apply D_scal, D; [lra|exact Nt]|lra]. }
  split.
  - apply (K (fun t => Sum n (fun i => fst (v i t)))); [apply (ac_Sum n (fun i t => fst (v i t))); intros; now apply Ax|]. intros t Ht Nt. destruct (Q t Ht Nt) as (z & Z & D). apply (f_equal fst) in Z. cbn in Z. eapply D_eq; [apply (D_Sum n (fun i t => fst (v i t)) (fun i => fst (z i))); intros i Hi; now apply D|exact Z].
  - apply (K (fun t => Sum n (fun i => snd (v i t)))); [apply (ac_Sum n (fun i t => snd (v i t))); intros; now apply Ax|]. intros t Ht Nt. destruct (Q t Ht Nt) as (z & Z & D). apply (f_equal snd) in Z. cbn in Z. eapply D_eq; [apply (D_Sum n (fun i t => snd (v i t)) (fun i => snd (z i))); intros i Hi; now apply D|exact Z].
Qed.
(* late velocities hardly change in a unit of time *)
Lemma nearly_constant T e a b : (forall t, T <= t -> forall i j, (i < n)%nat -> (j < n)%nat -> Cmod (v i t - v j t)%C < e) -> 0 <= T -> T <= a <= b ->
  forall i, (i < n)%nat -> Rabs (fst (v i b) - fst (v i a)) <= 2 * e /\ Rabs (snd (v i b) - snd (v i a)) <= 2 * e.
Proof.
  intros H HT Hab i Hi. pose proof (INR_pos n Hn) as nn. destruct (momentum a b ltac:(lra)) as [M1 M2].
  assert (K : forall p : C -> R, (forall x, Rabs (p x) <= Cmod x) -> (forall x y, p (x - y)%C = p x - p y) -> Sum n (fun j => p (v j b)) = Sum n (fun j => p (v j a)) -> Rabs (p (v i b) - p (v i a)) <= 2 * e).
  { intros p Pb Pm Pe. apply Rmult_le_reg_l with (INR n); [exact nn|]. rewrite <- (Rabs_pos_eq (INR n)) at 1 by lra. rewrite <- Rabs_mult.
    replace (INR n * (p (v i b) - p (v i a))) with (Sum n (fun j => p (v i b - v j b)%C - p (v i a - v j a)%C)).
    - eapply Rle_trans; [apply Sum_Rabs|]. rewrite <- Sum_const. apply Sum_le. intros j Hj. pose proof (H b ltac:(lra) i j Hi Hj) as X. pose proof (H a ltac:(lra) i j Hi Hj) as X'. pose proof (Pb (v i b - v j b)%C). pose proof (Pb (v i a - v j a)%C).
      unfold Rminus. eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_Ropp. lra.
    - rewrite (Sum_ext n _ (fun j => (p (v i b) - p (v i a)) - (p (v j b) - p (v j a)))) by (intros; rewrite !Pm; ring). rewrite Sum_minus, Sum_const, Sum_minus, Pe. ring. }
  split; [apply (K fst)|apply (K snd)]; try assumption; try (intros; reflexivity); intros x; pose proof (Rmax_Cmod x); pose proof (Rmax_l (Rabs (fst x)) (Rabs (snd x))); pose proof (Rmax_r (Rabs (fst x)) (Rabs (snd x))); lra.
Qed.
Definition shape t i := (r i t - r 0%nat t)%C.
Lemma shape_slow T e a b : (forall t, T <= t -> forall i j, (i < n)%nat -> (j < n)%nat -> Cmod (v i t - v j t)%C < e) -> 0 <= T -> T <= a <= b -> forall i, (i < n)%nat -> Cmod (shape b i - shape a i)%C <= 2 * (e * (b - a)).
Proof.
  intros H HT Hab i Hi. destruct M as (_ & Mr & _). eapply Rle_trans; [apply axes_Cmod|]. unfold shape. cbn [fst snd Cminus Cplus Copp].
  assert (Mx : forall x : C, Rabs (fst x) <= Cmod x /\ Rabs (snd x) <= Cmod x) by (intros x; pose proof (Rmax_Cmod x); pose proof (Rmax_l (Rabs (fst x)) (Rabs (snd x))); pose proof (Rmax_r (Rabs (fst x)) (Rabs (snd x))); lra).
  assert (F1 : Rabs (fst (r i b) - fst (r 0%nat b) - (fst (r i a) - fst (r 0%nat a))) <= e * (b - a)).
  { apply (slope_le (fun t => fst (r i t) - fst (r 0%nat t)) (fun t => fst (v i t) - fst (v 0%nat t))); [lra|]. intros t Ht. split; [apply D_minus; apply Mr; (lra || lia)|]. left. eapply Rle_lt_trans; [apply (Mx (v i t - v 0%nat t)%C)|]. apply H; (lra || lia). }
  assert (F2 : Rabs (snd (r i b) - snd (r 0%nat b) - (snd (r i a) - snd (r 0%nat a))) <= e * (b - a)).
  { apply (slope_le (fun t => snd (r i t) - snd (r 0%nat t)) (fun t => snd (v i t) - snd (v 0%nat t))); [lra|]. intros t Ht. split; [apply D_minus; apply Mr; (lra || lia)|]. left. eapply Rle_lt_trans; [apply (Mx (v i t - v 0%nat t)%C)|]. apply H; (lra || lia). }
  unfold Rminus in *. lra.
Qed.
(* a configuration that it comes near to again and again is critical *)
Lemma returns_critical s : (forall T e, 0 < e -> exists t, T <= t /\ forall i, (i < n)%nat -> Cmod (shape t i - s i)%C < e) -> critical n V' R0 s.
Proof.
  intros Rt. destruct (kept_apart n V V' R0 r v HR P M) as (d0 & Hd0 & Far).
  assert (As : apart_at n complete s).
  { intros i j Hi Hj L E. assert (Ne : i <> j) by (intros ->; unfold complete in L; rewrite Nat.eqb_refl in L; discriminate). destruct (Rt 0 (d0 / 2) ltac:(lra)) as (t & Ht & Q).
    pose proof (Far t i j Ht Hi Hj Ne) as F. pose proof (Q i Hi) as X. pose proof (Q j Hj) as X'. rewrite E in X. replace (r i t - r j t)%C with ((shape t i - s j) + - (shape t j - s j))%C in F by (unfold shape; ring).
    pose proof (Cmod_triangle (shape t i - s j)%C (- (shape t j - s j))%C) as T1. rewrite Cmod_opp in T1. lra. }
  apply NNPP. intros Nc. destruct (pushes n V V' R0 s Hn HR P As Nc) as (l & del & d & Hdel & Hd & Push). set (W := Sum (2 * n) (fun k => Rabs (l k))). assert (W0 : 0 <= W) by (apply Sum_ge0; intros; apply Rabs_pos). pose proof (INR_pos n Hn) as nn.
  set (e := Rmin (d / 8) (del / (8 * (W + 1) * (INR n + 1)))). assert (He : 0 < e) by (apply Rmin_glb_lt; [lra|apply Rdiv_lt_0_compat; [lra|repeat apply Rmult_lt_0_compat; lra]]). assert (e1 : e <= d / 8) by apply Rmin_l.
  assert (e2 : (W + 1) * (INR n + 1) * e <= del / 8).
  { apply Rle_trans with ((W + 1) * (INR n + 1) * (del / (8 * (W + 1) * (INR n + 1)))); [apply Rmult_le_compat_l; [apply Rmult_le_pos; lra|apply Rmin_r]|right; field; lra]. }
  destruct (agree_late e He) as (T & HT & Ag). destruct (Rt T (d / 2) ltac:(lra)) as (t & Ht & Near). destruct M as (_ & _ & Mc & N & HN & Mz).
  assert (Ax : forall i, (i < n)%nat -> ac (fun t => fst (v i t)) /\ ac (fun t => snd (v i t))) by (intros i Hi; apply ac_axes; now apply Mc).
  set (F := fun u => dot (2 * n) l (flat n (fun i => v i u))).
  assert (AF : ac F).
  { apply (ac_Sum (2 * n) (fun k u => l k * flat n (fun i => v i u) k)). intros k Hk. apply ac_scal. unfold flat. destruct (Nat.ltb_spec k n); apply Ax; lia. }
  assert (Up : -1 * F (t + 1) <= -1 * F t + - (del / 2) * (t + 1 - t)).
  { apply (ac_le (fun u => -1 * F u) N t (t + 1) (- (del / 2)) (ac_scal (-1) F AF) HN ltac:(lra)). intros u Hu Nu.
    assert (Au : apart_at n complete (fun i => r i u)).
    { intros i j Hi Hj L E. assert (Ne : i <> j) by (intros ->; unfold complete in L; rewrite Nat.eqb_refl in L; discriminate). pose proof (Far u i j ltac:(lra) Hi Hj Ne) as X. rewrite E in X. replace (r j u - r j u)%C with (RtoC 0) in X by ring. rewrite Cmod_0 in X. lra. }
    destruct (Mz u ltac:(lra) Nu Au) as (z & (m & c & y & Hy & S1 & Ez) & Vz). exists (-1 * dot (2 * n) l (flat n z)). split.
    - apply D_scal. unfold F, dot. apply (D_Sum (2 * n) (fun k u => l k * flat n (fun i => v i u) k) (fun k => l k * flat n z k)). intros k Hk. apply D_scal. unfold flat. destruct (Nat.ltb_spec k n); apply Vz; lia.
    - assert (G : del / 2 <= dot (2 * n) l (flat n z)); [|lra].
      assert (One : forall k, (k < m)%nat -> del / 2 <= dot (2 * n) l (flat n (y k))).
      { intros k Hk. destruct (Hy k Hk) as [_ L]. destruct (limit_is_law n V V' (fun i => r i u) (fun i => v i u) P Au R0 (y k) L) as (q & O & E). set (g := by_distance q R0) in *.
        pose proof (Push (shape u) g) as Pu. assert (Pu' : dot (2 * n) l (flat n (gradV n g V' (shape u))) <= - del).
        { apply Pu; [|exact (occurs_moved n R0 (fun i => r i u) g (r 0%nat u) O)]. intros i Hi. pose proof (shape_slow T e t u Ag HT ltac:(lra) i Hi) as Sl. specialize (Near i Hi).
          replace (shape u i - s i)%C with ((shape u i - shape t i) + (shape t i - s i))%C by ring. eapply Rle_lt_trans; [apply Cmod_triangle|]. assert (e * (u - t) <= e * 1) by (apply Rmult_le_compat_l; lra). lra. }
        set (al := fun i => (y k i + gradV n g V' (shape u) i)%C).
        assert (Eal : dot (2 * n) l (flat n (y k)) = dot (2 * n) l (flat n al) - dot (2 * n) l (flat n (gradV n g V' (shape u)))).
        { unfold dot. rewrite <- Sum_minus. apply Sum_ext. intros k' _. unfold al, flat. destruct (Nat.ltb k' n); cbn; ring. }
        assert (Bal : Rabs (dot (2 * n) l (flat n al)) <= INR n * e * W).
        { apply dot_le. intros k' Hk'. apply flat_le; [|exact Hk']. intros i Hi. unfold al. rewrite (E i Hi). assert (Gm : gradV n g V' (shape u) i = gradV n g V' (fun i => r i u) i) by exact (grad_moved n g V' (fun i => r i u) (r 0%nat u) i). rewrite Gm. unfold law4.
          replace (- Csum n (fun j => if g i j then v i u - v j u else 0) - gradV n g V' (fun i0 => r i0 u) i + gradV n g V' (fun i0 => r i0 u) i)%C with (- Csum n (fun j => if g i j then v i u - v j u else 0))%C by ring.
          rewrite Cmod_opp. apply tanner2_unique.Csum_le. intros j Hj. destruct (g i j); [left; apply Ag; (assumption || lra)|rewrite Cmod_0; lra]. }
        apply Rabs_le_between in Bal. assert (INR n * e * W <= del / 8) by nra. lra. }
      assert (Ed : dot (2 * n) l (flat n z) = Sum m (fun k => c k * dot (2 * n) l (flat n (y k)))).
      { unfold dot. rewrite (Sum_ext m _ (fun k => Sum (2 * n) (fun k' => c k * (l k' * flat n (y k) k')))) by (intros; symmetry; apply Sum_scal). rewrite Sum_swap. apply Sum_ext. intros k' Hk'. rewrite (Sum_ext m _ (fun k => l k' * (c k * flat n (y k) k'))) by (intros; ring). rewrite Sum_scal. f_equal.
        unfold flat. destruct (Nat.ltb_spec k' n).
        - rewrite (Ez k' ltac:(lia)). cbn. apply Sum_ext. intros k _. cbn. ring.
        - rewrite (Ez (k' - n)%nat ltac:(lia)). cbn. apply Sum_ext. intros k _. cbn. ring. }
      rewrite Ed. replace (del / 2) with (Sum m (fun k => c k * (del / 2))) by (rewrite Sum_scal_r, S1; ring). apply Sum_le. intros k Hk. apply Rmult_le_compat_l; [now apply Hy|now apply One]. }
  assert (Dn : Rabs (F (t + 1) - F t) <= 2 * e * W).
  { assert (Ef : F (t + 1) - F t = dot (2 * n) l (fun k => flat n (fun i => v i (t + 1)) k - flat n (fun i => v i t) k)) by (unfold F, dot; rewrite <- Sum_minus; apply Sum_ext; intros; ring).
    rewrite Ef. apply dot_le. intros k Hk. unfold flat. destruct (Nat.ltb_spec k n); apply (nearly_constant T e t (t + 1) Ag HT); (lra || lia). }
  apply Rabs_le_between in Dn. assert (2 * e * W <= del / 4) by nra. lra.
Qed.
End Along.
Lemma same_connected n g h : same_pairs n g h -> strongly_connected n h -> strongly_connected n g.
Proof.
  intros E C a c Ha Hc. specialize (C a c Ha Hc). clear Ha Hc. induction C as [a c (A1 & A2 & A3)|a|a c d _ I1 _ I2]; [|apply rt_refl|now apply rt_trans with c].
  apply rt_step. split; [exact A1|]. split; [exact A2|]. now rewrite (E c a A2 A1).
Qed.
(* on connected networks of links shorter than R0 configurations have bounded size *)
Lemma bounded_size n R0 : exists b, 0 < b /\ forall g (x : nat -> C), strongly_connected n g -> (forall i j, (i < n)%nat -> (j < n)%nat -> g i j = true -> Cmod (x i - x j)%C <= R0) ->
  forall i j, (i < n)%nat -> (j < n)%nat -> Cmod (x i - x j)%C <= b.
Proof.
  set (short := fun (g : graph) (x : nat -> C) => forall i j, (i < n)%nat -> (j < n)%nat -> g i j = true -> Cmod (x i - x j)%C <= R0).
  assert (Path : forall g j k, clos_refl_trans nat (arc n g) j k -> exists b, forall x, short g x -> Cmod (x k - x j)%C <= b).
  { intros g j k C. induction C as [a c (Ha & Hc & A)|a|a c d _ [b1 H1] _ [b2 H2]].
    - exists R0. intros x H. now apply H.
    - exists 0. intros x _. replace (x a - x a)%C with (RtoC 0) by ring. rewrite Cmod_0. lra.
    - exists (b1 + b2). intros x H. replace (x d - x a)%C with ((x d - x c) + (x c - x a))%C by ring. eapply Rle_trans; [apply Cmod_triangle|]. specialize (H1 x H). specialize (H2 x H). lra. }
  destruct (finite_graphs n (fun g e => strongly_connected n g -> forall x, short g x -> forall i j, (i < n)%nat -> (j < n)%nat -> Cmod (x i - x j)%C <= / e)) as (e & He & Q).
  - intros g e e' H L C x Sx i j Hi Hj. eapply Rle_trans; [now apply (H C x Sx)|]. apply Rinv_le_contravar; lra.
  - intros g h e E H C x Sx i j Hi Hj. apply (H (same_connected n g h E C) x); try assumption. intros a c Ha Hc A. apply Sx; try assumption. now rewrite <- (E a c Ha Hc).
  - intros g. destruct (classic (strongly_connected n g)) as [C|C]; [|exists 1; split; [lra|]; intros; contradiction].
    destruct (small2 n (fun i j d => forall x, short g x -> Cmod (x i - x j)%C <= / d)) as (d & Hd & Q).
    + intros i j d d' H L x Sx. eapply Rle_trans; [now apply H|]. apply Rinv_le_contravar; lra.
    + intros i j Hi Hj. destruct (Path g j i (C j i Hj Hi)) as [b Hb]. exists (/ (Rabs b + 1)). pose proof (Rabs_pos b). split; [apply Rinv_0_lt_compat; lra|]. intros x Sx. rewrite Rinv_inv. specialize (Hb x Sx). pose proof (Rle_abs b). lra.
    + exists d. split; [exact Hd|]. intros _ x Sx i j Hi Hj. now apply Q.
  - exists (/ e). split; [now apply Rinv_0_lt_compat|]. intros g x C Sx i j Hi Hj. now apply (Q g C x Sx).
Qed.
(* times of a kind that come again and again: there is a configuration that is near at such times again and again *)
Lemma returns n R0 (r : nat -> R -> C) (bad : R -> Prop) : (1 <= n)%nat -> (forall t, 0 <= t -> strongly_connected n (by_distance (fun i => r i t) R0)) ->
  (forall T, exists t, T <= t /\ 0 <= t /\ bad t) ->
  exists s : nat -> C, forall T e, 0 < e -> exists t, T <= t /\ 0 <= t /\ bad t /\ forall i, (i < n)%nat -> Cmod (shape r t i - s i)%C < e.
Proof.
  intros Hn SC Bad. destruct (bounded_size n R0) as (b0 & Hb0 & Sz).
  set (big := fun Q : (nat -> R) -> Prop => forall T, exists t, T <= t /\ (0 <= t /\ bad t) /\ Q (fun k => if Nat.ltb k (2 * n) then flat n (shape r t) k else 0)).
  set (s0 := cluster big). set (s := fun i => (s0 i, s0 (n + i)%nat) : C).
  assert (Cl : forall a, 0 < a -> big (close (2 * n) s0 a)).
  { intros a Ha. apply cluster_point; [| | | |exact Ha].
    - intros X Y XY H T. destruct (H T) as (t & H1 & H2 & H3). exists t. split; [exact H1|]. split; [exact H2|now apply XY].
    - intros X Y H. destruct (classic (big X)) as [B|B]; [now left|right]. intros T. apply not_all_ex_not in B. destruct B as [T' B]. destruct (H (Rmax T T')) as (t & H1 & H2 & [H3|H3]); pose proof (Rmax_l T T'); pose proof (Rmax_r T T').
      + exfalso. apply B. exists t. split; [lra|]. now split.
      + exists t. split; [lra|]. now split.
    - intros T. destruct (Bad T) as (t & H1 & H2). exists t. split; [exact H1|]. split; [exact H2|exact I].
    - intros k. exists b0. intros H. destruct (H 0) as (t & H1 & [H2 _] & H3). destruct (Nat.ltb_spec k (2 * n)) as [L|L]; [|rewrite Rabs_R0 in H3; lra].
      assert (Sp : forall i, (i < n)%nat -> Cmod (shape r t i) <= b0).
      { intros i Hi. apply (Sz (by_distance (fun i => r i t) R0) (fun i => r i t) (SC t H2)); [|exact Hi|lia]. intros k1 k2 _ _ A. unfold by_distance in A. apply andb_prop in A as [_ A]. destruct (Rlt_dec (Cmod (r k1 t - r k2 t)%C) R0); [lra|discriminate]. }
      pose proof (flat_le n (shape r t) k b0 Sp L). lra. }
  exists s. intros T a Ha. destruct (Cl (a / 4) ltac:(lra) T) as (t & H1 & [H2 H2'] & H3). exists t. split; [exact H1|]. split; [exact H2|]. split; [exact H2'|]. intros i Hi. eapply Rle_lt_trans; [apply axes_Cmod|]. unfold s. cbn [fst snd Cminus Cplus Copp].
    pose proof (H3 i ltac:(lia)) as A1. pose proof (H3 (n + i)%nat ltac:(lia)) as A2. cbv beta in A1, A2. unfold flat in A1, A2. destruct (Nat.ltb_spec i (2 * n)); [|lia]. destruct (Nat.ltb_spec (n + i) (2 * n)); [|lia]. destruct (Nat.ltb_spec i n); [|lia]. destruct (Nat.ltb_spec (n + i) n); [lia|]. replace (n + i - n)%nat with i in A2 by lia. unfold Rminus in *. fold s0 in A1, A2. lra.
Qed.
Theorem approaches_critical : forall n V V' R0 r v, 0 < R0 -> potentials n complete V V' -> motion10 n V' R0 r v -> (forall t, 0 <= t -> strongly_connected n (by_distance (fun i => r i t) R0)) ->
  (forall e, 0 < e -> exists T, forall t, T <= t -> exists q, critical n V' R0 q /\ forall i, (i < n)%nat -> Cmod (r i t - q i)%C < e) /\
  forall q, critical n V' R0 q -> generic n R0 q -> forall i, (i < n)%nat -> gradV n (by_distance q R0) V' q i = RtoC 0.
Proof.
  intros n V V' R0 r v HR P M SC. split; [|intros q; now apply (critical_generic n V V' R0 q)]. intros e He. destruct (Nat.eq_dec n 0) as [Z|Nz].
  { exists 0. intros t _. exists rest. split; [|intros i Hi; lia]. split; [intros i j Hi; lia|]. exists 1%nat, (fun _ => 1), (fun _ => rest). split; [|split; [cbn; ring|intros; lia]].
    intros k _. split; [lra|]. intros e' He'. exists rest. split; [intros; lia|]. split; [intros i j Hi; lia|intros; lia]. }
  assert (Hn : (1 <= n)%nat) by lia. apply NNPP. intros No.
  set (bad := fun t => ~ exists q, critical n V' R0 q /\ forall i, (i < n)%nat -> Cmod (r i t - q i)%C < e).
  assert (Bad : forall T, exists t, T <= t /\ 0 <= t /\ bad t).
  { intros T. apply NNPP. intros K. apply No. exists (Rmax T 0). intros t Ht. pose proof (Rmax_l T 0). pose proof (Rmax_r T 0). apply NNPP. intros X. apply K. exists t. split; [lra|]. split; [lra|exact X]. }
  destruct (returns n R0 r bad Hn SC Bad) as [s Rt].
  assert (Cr : critical n V' R0 s) by (apply (returns_critical n V V' R0 r v Hn HR P M SC); intros T a Ha; destruct (Rt T a Ha) as (t & H1 & _ & _ & H3); now exists t).
  destruct (Rt 0 e He) as (t & _ & _ & H2 & H3). apply H2. exists (fun i => (s i - - r 0%nat t)%C). split; [now apply critical_moved|]. intros i Hi.
  replace (r i t - (s i - - r 0%nat t))%C with (shape r t i - s i)%C by (unfold shape; ring). now apply H3.
Qed.
(* solutions start and last, and all of them approach critical configurations *)
Theorem all_solutions_approach : forall n V V' R0, 0 < R0 -> potentials n complete V V' -> tanner2_onward.solutions_last n V' R0 /\
  (forall r v, motion10 n V' R0 r v -> (forall t, 0 <= t -> strongly_connected n (by_distance (fun i => r i t) R0)) ->
    forall e, 0 < e -> exists T, forall t, T <= t -> exists q, critical n V' R0 q /\ forall i, (i < n)%nat -> Cmod (r i t - q i)%C < e) /\
  forall q, critical n V' R0 q -> generic n R0 q -> forall i, (i < n)%nat -> gradV n (by_distance q R0) V' q i = RtoC 0.
Proof.
  intros n V V' R0 HR P. split; [exact (proj1 (tanner2_onward.all_solutions_agree n V V' R0 HR P))|]. split.
  - intros r v M SC. exact (proj1 (approaches_critical n V V' R0 r v HR P M SC)).
  - intros q. exact (critical_generic n V V' R0 q P).
Qed.
