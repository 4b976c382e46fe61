(* Tanner, Jadbabaie, Pappas II, section 4, corrected: under (4) on the complete graph the translates and rotations of a strict minimum (up to motions) of the sum of the V_ij, near
   which there are no critical configurations but these, with a common velocity, are equilibria, and an asymptotically stable set in relative positions and velocities.
   Away from the set, within a bounded distance, the sum is larger than at the minimum by a constant (compactness), and the energy in a moving frame does not increase; so
   motions stay near, and as forces vanish and velocities agree in the limit they tend to critical configurations nearby.
     tanner2.sec4.flocking (corrected, clause 1), beyond.tanner2.sec4.flocking. *)
From Coq Require Import Reals Lra Lia Psatz Classical Relations.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums inclusions paley_model paley_phase paley_laplacian paley_gradient tanner_energy tanner_flock tanner2_motion tanner2_apart.
From Flockproof Require lipschitz tanner2_filippov tanner2_limits tanner2_lasting tanner2_solutions tanner2_approach tanner2_unique tanner2_stops paley_convergence.
Open Scope R_scope.

(* ---- distances in relative positions; near the translates and rotations of s ---- *)
Definition rel_near n e (q p : nat -> C) := forall i j, (i < n)%nat -> (j < n)%nat -> Cmod (q i - q j - (p i - p j))%C < e.
Definition near_orbit n e (s q : nat -> C) := exists a, Cmod a = 1 /\ rel_near n e q (fun i => (a * s i)%C).
Definition on_orbit n (s q : nat -> C) := exists a b, moved_by n a b s q.
(* the only critical configurations near them *)
Definition isolated n V' (s : nat -> C) := exists d, 0 < d /\ forall q, near_orbit n d s q -> all_apart n q -> (forall i, (i < n)%nat -> grad_i n complete V' q i = 0%C) -> on_orbit n s q.
(* motions for all t >= 0; near the set, with velocities that nearly agree *)
Definition motion n V' (r v : nat -> R -> C) := distinct n complete (fun i => r i 0) /\ forall t, 0 <= t -> moves n complete V' r v t.
Definition close_to n (s : nat -> C) e (q u : nat -> C) := near_orbit n e s q /\ forall i j, (i < n)%nat -> (j < n)%nat -> Cmod (u i - u j)%C < e.
Definition stable n V' s := forall e, 0 < e -> exists d, 0 < d /\ forall r v, motion n V' r v -> close_to n s d (fun i => r i 0) (fun i => v i 0) ->
  forall t, 0 <= t -> close_to n s e (fun i => r i t) (fun i => v i t).
Definition attractive n V' s := exists d, 0 < d /\ forall r v, motion n V' r v -> close_to n s d (fun i => r i 0) (fun i => v i 0) ->
  forall e, 0 < e -> exists T, forall t, T <= t -> close_to n s e (fun i => r i t) (fun i => v i t).

Lemma rel_sym n e q p : rel_near n e q p -> rel_near n e p q.
Proof. intros H i j Hi Hj. specialize (H i j Hi Hj). rewrite <- Cmod_opp. replace (- (p i - p j - (q i - q j)))%C with (q i - q j - (p i - p j))%C by ring. exact H. Qed.
Lemma rel_trans n e d q p x : rel_near n e q p -> rel_near n d p x -> rel_near n (e + d) q x.
Proof.
  intros H K i j Hi Hj. specialize (H i j Hi Hj). specialize (K i j Hi Hj). replace (q i - q j - (x i - x j))%C with ((q i - q j - (p i - p j)) + (p i - p j - (x i - x j)))%C by ring.
  eapply Rle_lt_trans; [apply Cmod_triangle|]. lra.
Qed.
Lemma orbit_more n e d s q : e <= d -> near_orbit n e s q -> near_orbit n d s q.
Proof. intros L (a & A & H). exists a. split; [exact A|]. intros i j Hi Hj. specialize (H i j Hi Hj). lra. Qed.
Lemma orbit_rel n e d s q p : near_orbit n e s q -> rel_near n d p q -> near_orbit n (d + e) s p.
Proof. intros (a & A & H) K. exists a. split; [exact A|]. now apply (rel_trans n d e p q). Qed.
Lemma on_near n s q p e : on_orbit n s q -> rel_near n e p q -> near_orbit n e s p.
Proof.
  intros (a & b & A & E) H. exists a. split; [exact A|]. intros i j Hi Hj. specialize (H i j Hi Hj). rewrite (E i Hi), (E j Hj) in H.
  replace (a * s i - a * s j)%C with (a * s i + b - (a * s j + b))%C by ring. exact H.
Qed.
Lemma apart_distinct n q : all_apart n q <-> distinct n complete q.
Proof.
  split; intros H i j Hi Hj K; apply H; try assumption.
  - intros ->. unfold complete in K. now rewrite Nat.eqb_refl in K.
  - unfold complete. destruct (Nat.eqb_spec i j); [contradiction|reflexivity].
Qed.
Lemma near_apart n s : all_apart n s -> exists d, 0 < d /\ forall q, near_orbit n d s q -> all_apart n q.
Proof.
  intros A. destruct (tanner2_filippov.small2 n (fun i j d => i <> j -> d <= Cmod (s i - s j)%C)) as (d & Hd & Q).
  - intros i j d d' H L Ne. specialize (H Ne). lra.
  - intros i j Hi Hj. destruct (Nat.eq_dec i j) as [->|Ne]; [exists 1; split; [lra|congruence]|]. exists (Cmod (s i - s j)%C). split; [apply (norm_neq (s i) (s j)); now apply A|intros; lra].
  - exists d. split; [exact Hd|]. intros q (a & Ha & H) i j Hi Hj Ne E. specialize (H i j Hi Hj). specialize (Q i j Hi Hj Ne). rewrite E in H.
    replace (q j - q j - (a * s i - a * s j))%C with (- (a * (s i - s j)))%C in H by ring. rewrite Cmod_opp, Cmod_mult, Ha in H. lra.
Qed.
(* ---- compactness ---- *)
Lemma conf_cluster n (S : R -> (nat -> C) -> Prop) B : (1 <= n)%nat -> (forall d d' q, 0 < d <= d' -> S d q -> S d' q) -> (forall d q i, (i < n)%nat -> S d q -> Cmod (q i - q 0%nat)%C <= B) ->
  (forall d, 0 < d -> exists q, S d q) -> exists p, forall d e, 0 < d -> 0 < e -> exists q, S d q /\ rel_near n e q p.
Proof.
  intros Hn Mono Bd Ex. set (sh := fun (q : nat -> C) i => (q i - q 0%nat)%C).
  set (big := fun Q : (nat -> R) -> Prop => forall d, 0 < d -> exists q, S d q /\ Q (fun k => if Nat.ltb k (2 * n) then tanner2_approach.flat n (sh q) k else 0)).
  assert (Cl : forall a, 0 < a -> big (close (2 * n) (cluster big) a)).
  { intros a Ha. apply cluster_point; [| | | |exact Ha].
    - intros X Y XY H d Hd. destruct (H d Hd) as (q & H1 & H2). exists q. split; [exact H1|now apply XY].
    - intros X Y H. destruct (classic (big X)) as [K|K]; [now left|right]. intros d Hd. apply not_all_ex_not in K. destruct K as [d' K]. apply imply_to_and in K. destruct K as [Hd' K].
      pose proof (Rmin_l d d'). pose proof (Rmin_r d d'). assert (0 < Rmin d d') by now apply Rmin_glb_lt. destruct (H (Rmin d d')) as (q & X1 & [X2|X2]); [assumption| |].
      + exfalso. apply K. exists q. split; [apply (Mono (Rmin d d')); [lra|exact X1]|exact X2].
      + exists q. split; [apply (Mono (Rmin d d')); [lra|exact X1]|exact X2].
    - intros d Hd. destruct (Ex d Hd) as [q Hq]. now exists q.
    - intros k. exists (Rabs B). intros H. destruct (H 1 Rlt_0_1) as (q & H1 & H2). pose proof (Rabs_pos B). destruct (Nat.ltb_spec k (2 * n)) as [L|L]; [|rewrite Rabs_R0 in H2; lra].
      pose proof (tanner2_approach.flat_le n (sh q) k B (fun i Hi => Bd 1 q i Hi H1) L). pose proof (Rle_abs B). lra. }
  exists (fun i => (cluster big i, cluster big (n + i)%nat)). intros d e Hd He. destruct (Cl (e / 4) ltac:(lra) d Hd) as (q & H1 & H3). exists q. split; [exact H1|]. intros i j Hi Hj.
  assert (K : forall m, (m < n)%nat -> Rabs (fst (sh q m) - cluster big m) < e / 4 /\ Rabs (snd (sh q m) - cluster big (n + m)%nat) < e / 4).
  { intros m Hm. pose proof (H3 m ltac:(lia)) as A1. pose proof (H3 (n + m)%nat ltac:(lia)) as A2. cbv beta in A1, A2. unfold tanner2_approach.flat in A1, A2.
    destruct (Nat.ltb_spec m (2 * n)); [|lia]. destruct (Nat.ltb_spec (n + m) (2 * n)); [|lia]. destruct (Nat.ltb_spec m n); [|lia]. destruct (Nat.ltb_spec (n + m) n); [lia|]. replace (n + m - n)%nat with m in A2 by lia. now split. }
  destruct (K i Hi) as [K1 K2], (K j Hj) as [K3 K4]. eapply Rle_lt_trans; [apply paley_convergence.Cmod_le|]. unfold sh in *. cbn [fst snd Cminus Cplus Copp] in *.
  apply Rabs_def2 in K1, K2, K3, K4. assert (Z : forall a b, - (e / 2) < a < e / 2 -> - (e / 2) < b < e / 2 -> Rabs a + Rabs b < e) by (intros a b Ha Hb; unfold Rabs; destruct (Rcase_abs a), (Rcase_abs b); lra). apply Z; lra.
Qed.
(* configurations near the set, not too near, of a kind that is kept in the limit *)
Lemma shell n s d rho (S : R -> (nat -> C) -> Prop) : (1 <= n)%nat -> 0 < d -> 0 < rho -> (forall e e' q, 0 < e <= e' -> S e q -> S e' q) ->
  (forall e, 0 < e -> exists q, near_orbit n d s q /\ ~ near_orbit n rho s q /\ S e q) ->
  exists p, near_orbit n (2 * d) s p /\ ~ on_orbit n s p /\ forall e h, 0 < e -> 0 < h -> exists q, S e q /\ rel_near n h q p.
Proof.
  intros Hn Hd Hr Mono Ex. set (B := Sum n (fun i => Cmod (s i - s 0%nat)%C) + d).
  destruct (conf_cluster n (fun e q => near_orbit n d s q /\ ~ near_orbit n rho s q /\ S e q) B Hn) as [p Hp]; [| |exact Ex|].
  - intros e e' q L (A1 & A2 & A3). split; [exact A1|]. split; [exact A2|]. now apply (Mono e).
  - intros e q i Hi ((a & Ha & H) & _). specialize (H i 0%nat Hi ltac:(lia)).
    replace (q i - q 0%nat)%C with (a * (s i - s 0%nat) + (q i - q 0%nat - (a * s i - a * s 0%nat)))%C by ring. eapply Rle_trans; [apply Cmod_triangle|]. rewrite Cmod_mult, Ha, Rmult_1_l. unfold B.
    pose proof (Sum_term_le n (fun i => Cmod (s i - s 0%nat)%C) i (fun j _ => Cmod_ge_0 _) Hi) as T. cbv beta in T. lra.
  - exists p. split; [|split].
    + destruct (Hp 1 d Rlt_0_1 Hd) as (q & (A1 & _) & H). replace (2 * d) with (d + d) by ring. apply (orbit_rel n d d s q p A1). now apply rel_sym.
    + intros On. destruct (Hp 1 rho Rlt_0_1 Hr) as (q & (_ & A2 & _) & H). apply A2. now apply (on_near n s p q).
    + intros e h He Hh. destruct (Hp e h He Hh) as (q & (_ & _ & A3) & H). now exists q.
Qed.

Section Minimum.
Variables (n : nat) (V V' : nat -> nat -> R -> R) (s : nat -> C).
Hypothesis Hn : (2 <= n)%nat.
Hypothesis VS : forall i j, V i j = V j i.
Hypothesis VS' : forall i j, V' i j = V' j i.
Hypothesis Pot : forall i j, (i < n)%nat -> (j < n)%nat -> complete i j = true -> potential (V i j) (V' i j).
Hypothesis C1 : forall i j x, (i < n)%nat -> (j < n)%nat -> complete i j = true -> 0 < x -> continuity_pt (V' i j) x.
Notation U := (sum_of_all n V).
Lemma complete_is i j : complete i j = negb (Nat.eqb i j). Proof. reflexivity. Qed.
Lemma potentials_of : tanner2_filippov.potentials n complete V V'.
Proof.
  split; [intros i j x; now rewrite VS|]. intros i j Hi Hj L. destruct (Pot i j Hi Hj L) as (A & B & C). split; [|now split]. intros x Hx. destruct (A x Hx). split; [assumption|]. split; [now apply C1|assumption].
Qed.
Lemma simple_complete : undirected complete /\ no_loops complete.
Proof. split; [intros i j|intros i]; unfold complete; [now rewrite Nat.eqb_sym|now rewrite Nat.eqb_refl]. Qed.
Lemma energy_is q u : Wenergy n complete V q u = / 2 * U q + / 2 * Sum n (fun i => inner (u i) (u i)).
Proof.
  unfold Wenergy, sum_of_all. rewrite <- Rmult_plus_distr_l, <- Sum_plus. f_equal. apply Sum_ext. intros i _. f_equal. unfold V_i. apply Sum_ext. intros j _. unfold w, complete. destruct (Nat.eqb i j); cbn [negb]; ring.
Qed.
Lemma U_same q p : (forall i j, (i < n)%nat -> (j < n)%nat -> Cmod (q i - q j)%C = Cmod (p i - p j)%C) -> U q = U p.
Proof. intros E. apply Sum_ext. intros i Hi. apply Sum_ext. intros j Hj. destruct (Nat.eqb i j); [reflexivity|]. unfold norm. now rewrite (E i j Hi Hj). Qed.
Lemma U_orbit q : on_orbit n s q -> U q = U s.
Proof.
  intros (a & b & A & E). apply U_same. intros i j Hi Hj. rewrite (E i Hi), (E j Hj). replace (a * s i + b - (a * s j + b))%C with (a * (s i - s j))%C by ring. rewrite Cmod_mult, A. ring.
Qed.
(* the sum and the gradients are continuous where agents are apart *)
Lemma U_near p e : all_apart n p -> 0 < e -> exists h, 0 < h /\ forall q, rel_near n h q p -> Rabs (U q - U p) < e.
Proof.
  intros A He. set (c := e / (INR n * INR n + 1)). pose proof (pos_INR n) as Pn. assert (Hc : 0 < c) by (apply Rdiv_lt_0_compat; nra).
  destruct (tanner2_filippov.small2 n (fun i j h => i <> j -> forall z : C, Cmod (z - (p i - p j))%C < h -> Rabs (V i j (norm z) - V i j (norm (p i - p j)%C)) < c)) as (h & Hh & Q).
  - intros i j d d' H L Ne z Hz. apply (H Ne). lra.
  - intros i j Hi Hj. destruct (Nat.eq_dec i j) as [->|Ne]; [exists 1; split; [lra|congruence]|].
    assert (L : complete i j = true) by (unfold complete; destruct (Nat.eqb_spec i j); [contradiction|reflexivity]). pose proof (norm_neq _ _ (A i j Hi Hj Ne)) as G.
    assert (Cn : continuity_pt (V i j) (norm (p i - p j)%C)).
    { apply derivable_continuous_pt. exists (V' i j (norm (p i - p j)%C)). apply is_derive_Reals. now apply (Pot i j Hi Hj L). }
    destruct (lipschitz.near_value (V i j) _ c Cn Hc) as (h & Hh & Q). exists h. split; [exact Hh|]. intros _ z Hz. apply Q. eapply Rle_lt_trans; [|exact Hz]. unfold norm.
    pose proof (Cmod_triangle (z - (p i - p j))%C (p i - p j)%C) as T1. replace (z - (p i - p j) + (p i - p j))%C with z in T1 by ring.
    pose proof (Cmod_triangle (- (z - (p i - p j)))%C z) as T2. rewrite Cmod_opp in T2. replace (- (z - (p i - p j)) + z)%C with (p i - p j)%C in T2 by ring. apply Rabs_le. lra.
  - exists h. split; [exact Hh|]. intros q H. unfold sum_of_all. rewrite <- Sum_minus. eapply Rle_lt_trans; [apply Sum_Rabs|].
    apply Rle_lt_trans with (Sum n (fun _ => INR n * c)).
    + apply Sum_le. intros i Hi. rewrite <- Sum_minus. eapply Rle_trans; [apply Sum_Rabs|]. rewrite <- Sum_const. apply Sum_le. intros j Hj. destruct (Nat.eqb_spec i j) as [->|Ne]; [rewrite Rminus_eq_0, Rabs_R0; lra|].
      left. apply (Q i j Hi Hj Ne). now apply H.
    + rewrite Sum_const. apply Rlt_le_trans with ((INR n * INR n + 1) * c); [nra|]. unfold c. right. field. nra.
Qed.
Lemma grad_is q i : grad_i n complete V' q i = (- tanner2_filippov.law4 n complete V' q tanner2_approach.rest i)%C.
Proof.
  rewrite <- tanner2_solutions.control_law. unfold control4. replace (Csum n (fun j => RtoC (w complete i j) * (tanner2_approach.rest i - tanner2_approach.rest j))%C) with (RtoC 0); [ring|].
  unfold tanner2_approach.rest, Csum. apply injective_projections; cbn [fst snd RtoC]; symmetry; apply Sum_zero; intros j _; cbn; ring.
Qed.
Lemma grad_near p e : all_apart n p -> 0 < e -> exists h, 0 < h /\ forall q i, rel_near n h q p -> (i < n)%nat -> Cmod (grad_i n complete V' q i - grad_i n complete V' p i)%C < e.
Proof.
  intros A He. destruct (tanner2_limits.law4_near n V V' p tanner2_approach.rest potentials_of (proj1 (apart_distinct n p) A) complete e) as (h & Hh & Q); [intros i _; apply simple_complete|exact He|].
  exists h. split; [exact Hh|]. intros q i H Hi. rewrite !grad_is. set (b := (q 0%nat - p 0%nat)%C).
  rewrite <- (tanner2_stops.law4_moved n complete V' q tanner2_approach.rest b 0%C i). replace (fun k => (tanner2_approach.rest k - 0)%C) with tanner2_approach.rest
    by (apply FunctionalExtensionality.functional_extensionality; intros k; unfold tanner2_approach.rest; ring).
  set (x := tanner2_filippov.law4 n complete V' (fun k => (q k - b)%C) tanner2_approach.rest i). set (y := tanner2_filippov.law4 n complete V' p tanner2_approach.rest i).
  replace (- x - - y)%C with (- (x - y))%C by ring. rewrite Cmod_opp. unfold x, y. apply Q; [|exact Hi]. intros k Hk. split.
  - replace (q k - b - p k)%C with (q k - q 0%nat - (p k - p 0%nat))%C by (unfold b; ring). apply H; [exact Hk|lia].
  - replace (tanner2_approach.rest k - tanner2_approach.rest k)%C with (RtoC 0) by ring. now rewrite Cmod_0.
Qed.

Hypothesis Min : strict_minimum n V s.
Lemma s_apart : all_apart n s.
Proof. apply (minimum_apart n V s Min 1%C 0%C s). split; [apply Cmod_1|]. intros; ring. Qed.
(* turned back by the rotation that is near *)
Lemma turn_back d q : near_orbit n d s q -> exists p, rel_near n d p s /\ (forall i j, Cmod (p i - p j)%C = Cmod (q i - q j)%C) /\ (on_orbit n s p -> on_orbit n s q).
Proof.
  intros (a & Ha & H). assert (Na : (Cconj a * a = 1)%C).
  { apply injective_projections; cbn; [|ring]. assert (Q : fst a ^ 2 + snd a ^ 2 = 1) by (pose proof (inner_self a) as I; rewrite inner_xy, Ha in I; lra). lra. }
  assert (Ca : Cmod (Cconj a) = 1) by (rewrite <- Ha; unfold Cmod, Cconj; cbn; f_equal; ring). exists (fun i => Cconj a * q i)%C. split.
  - intros i j Hi Hj. specialize (H i j Hi Hj). replace (Cconj a * q i - Cconj a * q j - (s i - s j))%C with (Cconj a * (q i - q j - (a * s i - a * s j)) + (Cconj a * a - 1) * (s i - s j))%C by ring. rewrite Na.
    replace (_ + (1 - 1) * (s i - s j))%C with (Cconj a * (q i - q j - (a * s i - a * s j)))%C by ring. rewrite Cmod_mult, Ca. lra.
  - split; [|intros (b & c & Hb & E); exists (a * b)%C, (a * c)%C; split; [rewrite Cmod_mult, Ha, Hb; ring|]; intros i Hi; specialize (E i Hi); cbv beta in E;
      replace (a * b * s i + a * c)%C with (a * (b * s i + c))%C by ring; rewrite <- E; replace (a * (Cconj a * q i))%C with (Cconj a * a * q i)%C by ring; rewrite Na; ring].
    intros i j. replace (Cconj a * q i - Cconj a * q j)%C with (Cconj a * (q i - q j))%C by ring. rewrite Cmod_mult, Ca. ring.
Qed.
Lemma min_orbit : exists d, 0 < d /\ forall q, near_orbit n d s q -> all_apart n q -> U s < U q \/ on_orbit n s q.
Proof.
  destruct Min as (d & Hd & M). exists d. split; [exact Hd|]. intros q N Aq. destruct (turn_back d q N) as (p & Np & E & Back). set (b := (s 0%nat - p 0%nat)%C). set (x := fun i => (p i + b)%C).
  assert (Sx : forall i j, Cmod (x i - x j)%C = Cmod (q i - q j)%C) by (intros i j; rewrite <- E; f_equal; unfold x; ring).
  assert (Ax : all_apart n x).
  { intros i j Hi Hj Ne X. apply (Aq i j Hi Hj Ne). specialize (Sx i j). rewrite X in Sx. replace (x j - x j)%C with (RtoC 0) in Sx by ring. rewrite Cmod_0 in Sx. symmetry in Sx. apply Cmod_eq_0 in Sx.
    transitivity (q i - q j + q j)%C; [ring|]. rewrite Sx. ring. }
  destruct (M x) as [_ [L|(a & c & Ha & X)]].
  - intros i Hi. specialize (Np i 0%nat Hi ltac:(lia)). unfold norm, x, b. replace (p i + (s 0%nat - p 0%nat) - s i)%C with (p i - p 0%nat - (s i - s 0%nat))%C by ring. exact Np.
  - left. destruct (L Ax) as [_ L']. rewrite (U_same q x); [exact L'|]. intros; symmetry; apply Sx.
  - right. apply Back. exists a, (c - b)%C. split; [exact Ha|]. intros i Hi. specialize (X i Hi). unfold x in X. transitivity (p i + b - b)%C; [ring|]. rewrite X. ring.
Qed.
(* away from the set the sum is larger, by a constant *)
Lemma larger : exists d, 0 < d /\ (forall q, near_orbit n d s q -> all_apart n q /\ U s <= U q) /\ forall rho, 0 < rho -> exists g, 0 < g /\ forall q, near_orbit n d s q -> ~ near_orbit n rho s q -> U s + g <= U q.
Proof.
  destruct min_orbit as (d1 & H1 & M). destruct (near_apart n s s_apart) as (d2 & H2 & A). set (d := Rmin d1 d2 / 2). pose proof (Rmin_l d1 d2) as L1. pose proof (Rmin_r d1 d2) as L2.
  assert (Hd : 0 < d) by (unfold d; apply Rdiv_lt_0_compat; [now apply Rmin_glb_lt|lra]). exists d. split; [exact Hd|]. split.
  - intros q N. assert (Aq : all_apart n q) by (apply A, (orbit_more n d d2); [unfold d; lra|exact N]). split; [exact Aq|]. destruct (M q) as [G|G]; [apply (orbit_more n d d1); [unfold d; lra|exact N]|exact Aq|lra|]. rewrite (U_orbit q G). lra.
  - intros rho Hr. apply NNPP. intros No.
    destruct (shell n s d rho (fun e q => U q < U s + e) ltac:(lia) Hd Hr) as (p & P1 & P2 & P3).
    + intros e e' q L H. lra.
    + intros e He. apply NNPP. intros K. apply No. exists e. split; [exact He|]. intros q Q1 Q2. apply Rnot_lt_le. intros L. apply K. now exists q.
    + assert (Ap : all_apart n p) by (apply A, (orbit_more n (2 * d) d2); [unfold d; lra|exact P1]). destruct (M p) as [G|G]; [apply (orbit_more n (2 * d) d1); [unfold d; lra|exact P1]|exact Ap| |contradiction].
      destruct (U_near p ((U p - U s) / 2) Ap ltac:(lra)) as (h & Hh & Q). destruct (P3 ((U p - U s) / 2) h ltac:(lra) Hh) as (q & B1 & B2). specialize (Q q B2). apply Rabs_def2 in Q. lra.
Qed.
(* near the set the sum is nearly the least one *)
Lemma nearly_least g : 0 < g -> exists d, 0 < d /\ forall q, near_orbit n d s q -> U q < U s + g.
Proof.
  intros Hg. destruct (U_near s g s_apart Hg) as (h & Hh & Q). exists h. split; [exact Hh|]. intros q N. destruct (turn_back h q N) as (p & Np & E & _). specialize (Q p Np). rewrite <- (U_same p q) by (intros; apply E). apply Rabs_def2 in Q. lra.
Qed.

(* ---- the set consists of equilibria ---- *)
Lemma critical_orbit q i : on_orbit n s q -> (i < n)%nat -> grad_i n complete V' q i = 0%C.
Proof.
  intros On Hi. destruct larger as (d & Hd & Least & _). set (g := grad_i n complete V' q). set (x := fun i (t : R) => (q i - RtoC t * g i)%C).
  assert (X0 : (fun i => x i 0) = q) by (apply FunctionalExtensionality.functional_extensionality; intros k; unfold x; ring).
  assert (Nq : forall e, 0 < e -> near_orbit n e s q) by (intros e He; apply (on_near n s q q e On); intros a b _ _; replace (q a - q b - (q a - q b))%C with (RtoC 0) by ring; now rewrite Cmod_0).
  pose proof (proj1 (Least q (Nq d Hd))) as Aq. destruct simple_complete as [Sym NL].
  set (f := fun t => / 2 * Sum n (fun i => V_i n complete V (fun i => x i t) i)).
  assert (Ef : forall t, f t = / 2 * U (fun i => x i t)).
  { intros t. pose proof (energy_is (fun i => x i t) (fun _ => 0%C)) as E. unfold Wenergy in E. assert (Z : inner 0%C 0%C = 0) by (rewrite inner_xy; cbn; ring).
    rewrite (Sum_ext n (fun i => V_i n complete V (fun i0 => x i0 t) i + inner 0%C 0%C) (fun i => V_i n complete V (fun i0 => x i0 t) i)) in E by (intros; rewrite Z; ring). unfold f. rewrite E, (Sum_zero n (fun _ => inner 0%C 0%C)) by (intros; exact Z). ring. }
  assert (D : is_derive f 0 (Sum n (fun i => inner (- g i)%C (g i)))).
  { pose proof (eq8_potential n complete V V' x (fun i _ => (- g i)%C) 0 Sym VS') as E8. rewrite X0 in E8. apply E8.
    - intros k _. unfold x. split; cbn [fst snd Cminus Cplus Copp Cmult RtoC].
      + eapply D_eq; [apply D_plus; [apply D_const|apply D_opp, D_minus; apply D_mult; [apply D_id|apply D_const|apply D_const|apply D_const]]|]. cbn. ring.
      + eapply D_eq; [apply D_plus; [apply D_const|apply D_opp, D_plus; apply D_mult; [apply D_id|apply D_const|apply D_const|apply D_const]]|]. cbn. ring.
    - intros a b Ha Hb L. unfold x. replace (q a - RtoC 0 * g a)%C with (q a) by ring. replace (q b - RtoC 0 * g b)%C with (q b) by ring. apply Aq; try assumption. intros ->. unfold complete in L. now rewrite Nat.eqb_refl in L.
    - intros a b Ha Hb L. apply (Pot a b Ha Hb L). apply norm_neq. unfold x. replace (q a - RtoC 0 * g a)%C with (q a) by ring. replace (q b - RtoC 0 * g b)%C with (q b) by ring. apply Aq; try assumption. intros ->. unfold complete in L. now rewrite Nat.eqb_refl in L. }
  assert (Neg : forall k, inner (- g k)%C (g k) = - Cmod (g k) ^ 2) by (intros k; rewrite <- inner_self, !inner_xy; cbn; ring).
  apply NNPP. intros Nz. assert (Gi : 0 < Cmod (g i)) by (apply Cmod_gt_0; exact Nz).
  assert (Lt : Sum n (fun i => inner (- g i)%C (g i)) < 0).
  { rewrite (Sum_ext n _ (fun k => - (Cmod (g k) ^ 2))) by (intros; apply Neg). rewrite Sum_opp. pose proof (Sum_term_le n (fun k => Cmod (g k) ^ 2) i (fun j _ => pow2_ge_0 _) Hi) as T. cbv beta in T. nra. }
  destruct (tanner2_unique.side_below f 0 _ (f 0) D (or_intror (conj eq_refl Lt))) as (h & Hh & Below).
  set (G := Sum n (fun k => Cmod (g k))). assert (G0 : 0 <= G) by (apply Sum_ge0; intros; apply Cmod_ge_0). set (t := Rmin (h / 2) (d / (4 * (G + 1)))).
  assert (Ht : 0 < t) by (apply Rmin_glb_lt; [lra|apply Rdiv_lt_0_compat; lra]). pose proof (Rmin_l (h / 2) (d / (4 * (G + 1)))) as T1. pose proof (Rmin_r (h / 2) (d / (4 * (G + 1)))) as T2. fold t in T1, T2.
  assert (T3 : t * (G + 1) <= d / 4) by (apply Rle_trans with (d / (4 * (G + 1)) * (G + 1)); [apply Rmult_le_compat_r; lra|right; field; lra]).
  specialize (Below t ltac:(lra)). rewrite !Ef, X0, (U_orbit q On) in Below. destruct (Least (fun i => x i t)) as [_ Le]; [|lra].
  apply (on_near n s q _ d On). intros a b Ha Hb. unfold x. replace (q a - RtoC t * g a - (q b - RtoC t * g b) - (q a - q b))%C with (RtoC t * (g b - g a))%C by ring. rewrite Cmod_mult, Cmod_R, (Rabs_pos_eq t) by lra.
  assert (Ga : forall k, (k < n)%nat -> Cmod (g k) <= G) by (intros k Hk; apply (Sum_term_le n (fun k => Cmod (g k)) k (fun j _ => Cmod_ge_0 _) Hk)). pose proof (Ga a Ha). pose proof (Ga b Hb).
  pose proof (Cmod_triangle (g b) (- g a)%C) as Tr. rewrite Cmod_opp in Tr. change (g b + - g a)%C with (g b - g a)%C in Tr. assert (t * Cmod (g b - g a)%C <= t * (2 * (G + 1))) by (apply Rmult_le_compat_l; lra). lra.
Qed.
Lemma equilibria q c : on_orbit n s q -> forall t, moves n complete V' (fun i t => (q i + RtoC t * c)%C) (fun _ _ => c) t.
Proof.
  intros On t. split.
  - intros i _. split; cbn [fst snd Cplus Cmult RtoC].
    + eapply D_eq; [apply D_plus; [apply D_const|apply D_minus; apply D_mult; [apply D_id|apply D_const|apply D_const|apply D_const]]|]. cbn. ring.
    + eapply D_eq; [apply D_plus; [apply D_const|apply D_plus; apply D_mult; [apply D_id|apply D_const|apply D_const|apply D_const]]|]. cbn. ring.
  - intros _ i Hi. assert (Z : control4 n complete V' (fun k => (q k + RtoC t * c)%C) (fun _ => c) i = 0%C).
    { rewrite tanner2_solutions.control_law, <- (tanner2_stops.law4_moved n complete V' _ _ (RtoC t * c)%C c i).
      replace (fun k => (q k + RtoC t * c - RtoC t * c)%C) with q by (apply FunctionalExtensionality.functional_extensionality; intros k; ring).
      replace (fun _ : nat => (c - c)%C) with tanner2_approach.rest by (apply FunctionalExtensionality.functional_extensionality; intros k; unfold tanner2_approach.rest; ring).
      pose proof (critical_orbit q i On Hi) as G. rewrite grad_is in G. set (y := tanner2_filippov.law4 n complete V' q tanner2_approach.rest i) in *. replace y with (- - y)%C by ring. rewrite G. ring. }
    rewrite Z. split; cbn; apply D_const.
Qed.

(* ---- motions ---- *)
Lemma apart_always r v t : motion n V' r v -> 0 <= t -> distinct n complete (fun i => r i t).
Proof.
  intros [A M] Ht i j Hi Hj L. destruct simple_complete as [Sym NL]. now apply (never_meet n complete V V' r v Sym NL VS VS' Pot A M t i j Ht Hi Hj).
Qed.
Lemma frame r v m : motion n V' r v -> motion n V' (fun i t => (r i t - RtoC t * m)%C) (fun i t => (v i t - m)%C).
Proof.
  intros [A M]. split.
  - intros i j Hi Hj L E. apply (A i j Hi Hj L). transitivity (r i 0 - RtoC 0 * m + RtoC 0 * m)%C; [ring|]. rewrite E. ring.
  - intros t Ht. destruct (M t Ht) as [Mr Mv]. split.
    + intros i Hi. destruct (Mr i Hi) as [R1 R2]. split; cbn [fst snd Cminus Cplus Copp Cmult RtoC].
      * eapply D_eq; [apply D_plus; [exact R1|apply D_opp, D_minus; apply D_mult; [apply D_id|apply D_const|apply D_const|apply D_const]]|]. cbn. ring.
      * eapply D_eq; [apply D_plus; [exact R2|apply D_opp, D_plus; apply D_mult; [apply D_id|apply D_const|apply D_const|apply D_const]]|]. cbn. ring.
    + intros _ i Hi. destruct (Mv (apart_always r v t (conj A M) Ht) i Hi) as [V1 V2]. rewrite tanner2_solutions.control_law, (tanner2_stops.law4_moved n complete V' (fun k => r k t) (fun k => v k t)), <- tanner2_solutions.control_law.
      split; cbn [fst snd Cminus Cplus Copp]; (eapply D_eq; [apply D_plus; [eassumption|apply D_const]|ring]).
Qed.
Lemma energy_frame r v m t : motion n V' r v -> 0 <= t -> U (fun i => r i t) + Sum n (fun i => Cmod (v i t - m)%C ^ 2) <= U (fun i => r i 0) + Sum n (fun i => Cmod (v i 0 - m)%C ^ 2).
Proof.
  intros M Ht. pose proof (frame r v m M) as F. destruct simple_complete as [Sym NL].
  pose proof (energy_before n complete V V' _ _ Sym VS' Pot t Ht (fun s0 Hs => conj (proj2 F s0 (proj1 Hs)) (apart_always _ _ s0 F (proj1 Hs)))) as E. rewrite !energy_is in E.
  assert (Un : forall t, U (fun i => r i t - RtoC t * m)%C = U (fun i => r i t)) by (intros x; apply U_same; intros i j _ _; f_equal; ring). rewrite !Un in E.
  rewrite !(Sum_ext n (fun i => inner _ _) (fun i => Cmod _ ^ 2) (fun i _ => inner_self _)) in E. lra.
Qed.
Lemma r_close r v t h : motion n V' r v -> 0 <= t -> 0 < h -> exists d, 0 < d /\ forall u, Rabs (u - t) < d -> rel_near n h (fun i => r i u) (fun i => r i t).
Proof.
  intros [A M] Ht Hh. destruct (tanner2_filippov.small n (fun i d => forall u, Rabs (u - t) < d -> Cmod (r i u - r i t)%C < h / 2)) as (d & Hd & Q).
  - intros i d d' H L u Hu. apply H. lra.
  - intros i Hi. destruct (proj1 (M t Ht) i Hi) as [R1 R2]. assert (K : forall f l, is_derive f t l -> continuity_pt f t) by (intros f l D; apply derivable_continuous_pt; exists l; now apply is_derive_Reals).
    destruct (lipschitz.near_value _ t (h / 4) (K _ _ R1) ltac:(lra)) as (d1 & H1 & Q1). destruct (lipschitz.near_value _ t (h / 4) (K _ _ R2) ltac:(lra)) as (d2 & H2 & Q2). exists (Rmin d1 d2). split; [now apply Rmin_glb_lt|].
    intros u Hu. pose proof (Rmin_l d1 d2). pose proof (Rmin_r d1 d2). specialize (Q1 u ltac:(lra)). specialize (Q2 u ltac:(lra)). eapply Rle_lt_trans; [apply paley_convergence.Cmod_le|]. cbn [fst snd Cminus Cplus Copp]. unfold Rminus in *. lra.
  - exists d. split; [exact Hd|]. intros u Hu i j Hi Hj. replace (r i u - r j u - (r i t - r j t))%C with ((r i u - r i t) + - (r j u - r j t))%C by ring. eapply Rle_lt_trans; [apply Cmod_triangle|]. rewrite Cmod_opp.
    pose proof (Q i Hi u Hu). pose proof (Q j Hj u Hu). lra.
Qed.
Lemma stays_near r v d rho : motion n V' r v -> 0 < rho -> 2 * rho <= d -> near_orbit n rho s (fun i => r i 0) ->
  (forall t, 0 <= t -> near_orbit n d s (fun i => r i t) -> near_orbit n rho s (fun i => r i t)) -> forall t, 0 <= t -> near_orbit n rho s (fun i => r i t).
Proof.
  intros M Hr Hd S0 Back. apply (real_induction (fun t => near_orbit n rho s (fun i => r i t))).
  - intros t Ht H. destruct (Req_dec t 0) as [->|Nt]; [exact S0|]. destruct (r_close r v t rho M Ht Hr) as (w & Hw & Q). pose proof (Rmin_l t (w / 2)). pose proof (Rmin_r t (w / 2)). assert (0 < Rmin t (w / 2)) by (apply Rmin_glb_lt; lra).
    set (u := t - Rmin t (w / 2)) in *. assert (Hu : 0 <= u < t) by (unfold u; lra). apply Back; [exact Ht|]. apply (orbit_more n (rho + rho) d); [lra|]. apply (orbit_rel n rho rho s (fun i => r i u)); [now apply H|]. apply rel_sym. apply Q. unfold u. apply Rabs_def1; lra.
  - intros t Ht (a & Ha & H). destruct (tanner2_filippov.small2 n (fun i j k => Cmod (r i t - r j t - (a * s i - a * s j))%C < rho - k)) as (k & Hk & Q).
    + intros i j k k' L Lk. lra.
    + intros i j Hi Hj. specialize (H i j Hi Hj). exists ((rho - Cmod (r i t - r j t - (a * s i - a * s j))%C) / 2). split; lra.
    + destruct (r_close r v t k M Ht Hk) as (w & Hw & Cl). exists w. split; [exact Hw|]. intros u Hu. apply (orbit_more n (k + (rho - k)) rho); [lra|]. apply (orbit_rel n (rho - k) k s (fun i => r i t)).
      * exists a. split; [exact Ha|]. intros i j Hi Hj. now apply Q.
      * apply Cl. apply Rabs_def1; lra.
Qed.
Lemma is_stable : stable n V' s.
Proof.
  intros e He. destruct larger as (d & Hd & Least & Lar). set (rho := Rmin e d / 2). pose proof (Rmin_l e d) as R1. pose proof (Rmin_r e d) as R2. assert (Hr : 0 < rho) by (unfold rho; apply Rdiv_lt_0_compat; [now apply Rmin_glb_lt|lra]).
  destruct (Lar rho Hr) as (g & Hg & Far). set (c := Rmin (g / 4) (e ^ 2 / 16)). assert (e2 : 0 < e ^ 2) by nra. assert (Hc : 0 < c) by (apply Rmin_glb_lt; lra). pose proof (Rmin_l (g / 4) (e ^ 2 / 16)) as C2. pose proof (Rmin_r (g / 4) (e ^ 2 / 16)) as C3. fold c in C2, C3.
  destruct (nearly_least c Hc) as (d1 & H1 & Nl). pose proof (INR_pos n ltac:(lia)) as Pn. set (del := Rmin (Rmin d1 rho) (Rmin 1 (c / INR n))).
  pose proof (Rmin_l (Rmin d1 rho) (Rmin 1 (c / INR n))) as D1. pose proof (Rmin_r (Rmin d1 rho) (Rmin 1 (c / INR n))) as D2. fold del in D1, D2. pose proof (Rmin_l d1 rho). pose proof (Rmin_r d1 rho). pose proof (Rmin_l 1 (c / INR n)). pose proof (Rmin_r 1 (c / INR n)).
  assert (Hdel : 0 < del) by (unfold del; repeat apply Rmin_glb_lt; try lra; now apply Rdiv_lt_0_compat). assert (Nd : INR n * del <= c) by (apply Rle_trans with (INR n * (c / INR n)); [apply Rmult_le_compat_l; lra|right; field; lra]).
  exists del. split; [exact Hdel|]. intros r v M [S0 V0]. set (m := v 0%nat 0).
  assert (E0 : U (fun i => r i 0) + Sum n (fun i => Cmod (v i 0 - m)%C ^ 2) < U s + 2 * c).
  { pose proof (Nl _ (orbit_more n del d1 s _ ltac:(lra) S0)) as N1. assert (Sv : Sum n (fun i => Cmod (v i 0 - m)%C ^ 2) <= c); [|lra]. apply Rle_trans with (Sum n (fun _ => del)); [|rewrite Sum_const; exact Nd].
    apply Sum_le. intros i Hi. specialize (V0 i 0%nat Hi ltac:(lia)). fold m in V0. pose proof (Cmod_ge_0 (v i 0 - m)%C). nra. }
  assert (Ge0 : forall t, 0 <= Sum n (fun i => Cmod (v i t - m)%C ^ 2)) by (intros t; apply Sum_ge0; intros; apply pow2_ge_0).
  assert (Near : forall t, 0 <= t -> near_orbit n rho s (fun i => r i t)).
  { apply (stays_near r v d rho M Hr ltac:(unfold rho; lra)); [apply (orbit_more n del rho); [lra|exact S0]|]. intros t Ht N. apply NNPP. intros K. pose proof (Far _ N K) as F. pose proof (energy_frame r v m t M Ht). specialize (Ge0 t). lra. }
  intros t Ht. specialize (Near t Ht). split; [apply (orbit_more n rho e); [unfold rho; lra|exact Near]|].
  assert (Vm : forall i, (i < n)%nat -> Cmod (v i t - m)%C < e / 2).
  { intros i Hi. pose proof (energy_frame r v m t M Ht) as E. destruct (Least (fun i => r i t)) as [_ L]; [apply (orbit_more n rho d); [unfold rho; lra|exact Near]|].
    pose proof (Sum_term_le n (fun i => Cmod (v i t - m)%C ^ 2) i (fun j _ => pow2_ge_0 _) Hi) as T. cbv beta in T. pose proof (Cmod_ge_0 (v i t - m)%C). nra. }
  intros i j Hi Hj. replace (v i t - v j t)%C with ((v i t - m) + - (v j t - m))%C by ring. eapply Rle_lt_trans; [apply Cmod_triangle|]. rewrite Cmod_opp. pose proof (Vm i Hi). pose proof (Vm j Hj). lra.
Qed.
Hypothesis Iso : isolated n V' s.
Lemma forces_away : exists d, 0 < d /\ forall rho, 0 < rho -> exists g, 0 < g /\ forall q, near_orbit n d s q -> ~ near_orbit n rho s q -> exists i, (i < n)%nat /\ g <= Cmod (grad_i n complete V' q i).
Proof.
  destruct Iso as (d1 & H1 & I). destruct (near_apart n s s_apart) as (d2 & H2 & A). set (d := Rmin d1 d2 / 2). pose proof (Rmin_l d1 d2) as L1. pose proof (Rmin_r d1 d2) as L2.
  assert (Hd : 0 < d) by (unfold d; apply Rdiv_lt_0_compat; [now apply Rmin_glb_lt|lra]). exists d. split; [exact Hd|]. intros rho Hr. apply NNPP. intros No.
  destruct (shell n s d rho (fun e q => forall i, (i < n)%nat -> Cmod (grad_i n complete V' q i) < e) ltac:(lia) Hd Hr) as (p & P1 & P2 & P3).
  - intros e e' q L H i Hi. specialize (H i Hi). lra.
  - intros e He. apply NNPP. intros K. apply No. exists e. split; [exact He|]. intros q Q1 Q2. apply NNPP. intros L. apply K. exists q. split; [exact Q1|]. split; [exact Q2|]. intros i Hi. apply Rnot_le_lt. intros G. apply L. now exists i.
  - assert (Ap : all_apart n p) by (apply A, (orbit_more n (2 * d) d2); [unfold d; lra|exact P1]). apply P2, I; [apply (orbit_more n (2 * d) d1); [unfold d; lra|exact P1]|exact Ap|].
    intros i Hi. apply Cmod_eq_0. apply cond_eq. intros e He. rewrite Rminus_0_r, Rabs_pos_eq by apply Cmod_ge_0. destruct (grad_near p (e / 2) Ap ltac:(lra)) as (h & Hh & Q). destruct (P3 (e / 2) h ltac:(lra) Hh) as (q & B1 & B2).
    specialize (Q q i B2 Hi). specialize (B1 i Hi). replace (grad_i n complete V' p i) with (grad_i n complete V' q i + - (grad_i n complete V' q i - grad_i n complete V' p i))%C by ring.
    eapply Rle_lt_trans; [apply Cmod_triangle|]. rewrite Cmod_opp. lra.
Qed.
Lemma connected_complete : strongly_connected n complete.
Proof.
  intros a b Ha Hb. destruct (Nat.eq_dec a b) as [->|Ne]; [apply rt_refl|]. apply rt_step. split; [exact Ha|]. split; [exact Hb|]. unfold complete. destruct (Nat.eqb_spec b a); [congruence|reflexivity].
Qed.
Lemma is_attractive : attractive n V' s.
Proof.
  destruct forces_away as (d & Hd & Fa). destruct (is_stable d Hd) as (del & Hdel & St). exists del. split; [exact Hdel|]. intros r v M S0 e He. destruct (Fa e He) as (g & Hg & Away). destruct simple_complete as [Sym NL].
  destruct (proj2 (tanner2_lasting.all_forces_vanish n complete V V' Sym NL VS VS' Pot C1 ltac:(lia) connected_complete) r v (proj1 M) (proj2 M) g Hg) as (T1 & HT1 & F1).
  destruct (tanner2_filippov.small2 n (fun i j k => forall t, / k <= t -> Cmod (v i t - v j t)%C < e)) as (k & Hk & Q).
  - intros i j k k' H L t Ht. apply H. eapply Rle_trans; [|exact Ht]. apply Rinv_le_contravar; lra.
  - intros i j Hi Hj. destruct (proj2 (tanner2_lasting.all_agree n complete V V' Sym NL VS VS' Pot C1 ltac:(lia) connected_complete) r v (proj1 M) (proj2 M) i j Hi Hj e He) as (T & HT & F).
    exists (/ (T + 1)). split; [apply Rinv_0_lt_compat; lra|]. intros t Ht. rewrite Rinv_inv in Ht. apply F. lra.
  - exists (Rmax T1 (/ k)). intros t Ht. pose proof (Rmax_l T1 (/ k)). pose proof (Rmax_r T1 (/ k)). split.
    + apply NNPP. intros N. destruct (St r v M S0 t ltac:(lra)) as [Nd _]. destruct (Away _ Nd N) as (i & Hi & G). specialize (F1 t i ltac:(lra) Hi). unfold norm in F1. lra.
    + intros i j Hi Hj. apply (Q i j Hi Hj). lra.
Qed.
End Minimum.
(* and a motion goes on from every start near the set, for all time *)
Theorem minima_attract : forall n V V' s, (2 <= n)%nat -> (forall i j, V i j = V j i) -> (forall i j, V' i j = V' j i) ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> complete i j = true -> potential (V i j) (V' i j)) ->
  (forall i j x, (i < n)%nat -> (j < n)%nat -> complete i j = true -> 0 < x -> continuity_pt (V' i j) x) -> strict_minimum n V s -> isolated n V' s ->
  (forall q c, on_orbit n s q -> forall t, moves n complete V' (fun i t => (q i + RtoC t * c)%C) (fun _ _ => c) t) /\ tanner2_lasting.lasting n complete V' /\ stable n V' s /\ attractive n V' s.
Proof.
  intros n V V' s Hn VS VS' Pot C1 Min Iso. split; [intros q c On; now apply (equilibria n V V' s)|]. split.
  - apply (tanner2_lasting.all_agree n complete V V'); try assumption; try apply simple_complete; [lia|now apply connected_complete].
  - split; [now apply (is_stable n V V' s)|now apply (is_attractive n V V' s)].
Qed.
