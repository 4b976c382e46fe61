(* Tanner, Jadbabaie, Pappas, links by distance: (10) as a vector field on R^(4n), and K of it by the words of Definition 4, the intersection over all d > 0 and all
   sets of measure zero of the closed convex hulls of what the field is on the rest of the cube of half side d.  Where no two agents coincide it is the convex hull of
   the limits of the law from states without a pair at the distance R: the value at a state with such pairs is also the value at states nearby, with the configuration
   a little larger, and near a state only finitely many networks occur.  The same for the gradients of all agents together, as functions of the configuration. *)
From Coq Require Import Reals Lra Lia Psatz Classical.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums inclusions paley_model paley_phase paley_laplacian paley_gradient tanner_energy tanner_flock tanner2_filippov tanner2_limits.
From Flockproof Require tanner2_appendix tanner2_existence tanner2_solutions tanner2_approach tanner2_lasting paley_convergence.
Open Scope R_scope.

(* ---- (10) as a vector field: agent i at 4i, 4i + 1, with the velocity at 4i + 2, 4i + 3 ---- *)
Definition place_of (x : nat -> R) i : C := (x (4 * i)%nat, x (4 * i + 1)%nat).
Definition speed_of (x : nat -> R) i : C := (x (4 * i + 2)%nat, x (4 * i + 3)%nat).
Definition state (q u : nat -> C) (j : nat) : R := let i := Nat.div j 4 in
  match Nat.modulo j 4 with 0 => fst (q i) | 1 => snd (q i) | 2 => fst (u i) | _ => snd (u i) end%nat.
Definition field10 n V' R0 (x : nat -> R) : nat -> R := state (speed_of x) (law4 n (by_distance (place_of x) R0) V' (place_of x) (speed_of x)).
Notation K4 n V' R0 := (tanner2_appendix.K (4 * n) (field10 n V' R0)).

(* ---- states ---- *)
Lemma parts z : Rabs (fst z) <= Cmod z /\ Rabs (snd z) <= Cmod z.
Proof. pose proof (Rmax_Cmod z) as H. split; eapply Rle_trans; [apply Rmax_l|exact H|apply Rmax_r|exact H]. Qed.
Lemma at_agent (q u : nat -> C) i : state q u (4 * i) = fst (q i) /\ state q u (4 * i + 1) = snd (q i) /\ state q u (4 * i + 2) = fst (u i) /\ state q u (4 * i + 3) = snd (u i).
Proof.
  unfold state. assert (H : forall k, (k < 4)%nat -> ((4 * i + k) mod 4 = k /\ (4 * i + k) / 4 = i)%nat).
  { intros k Hk. replace (4 * i + k)%nat with (k + i * 4)%nat by lia. rewrite Nat.mod_add, Nat.div_add by lia. split; [now apply Nat.mod_small|].
    rewrite Nat.div_small by exact Hk. lia. }
  pose proof (H 0%nat ltac:(lia)) as [A0 B0]. rewrite Nat.add_0_r in A0, B0. pose proof (H 1%nat ltac:(lia)) as [A1 B1]. pose proof (H 2%nat ltac:(lia)) as [A2 B2].
  pose proof (H 3%nat ltac:(lia)) as [A3 B3]. rewrite A0, B0, A1, B1, A2, B2, A3, B3. now repeat split.
Qed.
Lemma agents_of (q u : nat -> C) i : place_of (state q u) i = q i /\ speed_of (state q u) i = u i.
Proof. destruct (at_agent q u i) as (A & B & C0 & D). unfold place_of, speed_of. rewrite A, B, C0, D, <- !surjective_pairing. now split. Qed.
Lemma state_of x j : state (place_of x) (speed_of x) j = x j.
Proof.
  unfold state, place_of, speed_of. pose proof (Nat.div_mod_eq j 4) as E. pose proof (Nat.mod_upper_bound j 4 ltac:(lia)) as U.
  destruct (j mod 4)%nat as [|[|[|[|]]]] eqn:M; cbn [fst snd]; try lia; f_equal; lia.
Qed.
Lemma state_ext n (q u q' u' : nat -> C) : (forall i, (i < n)%nat -> q i = q' i /\ u i = u' i) -> forall j, (j < 4 * n)%nat -> state q u j = state q' u' j.
Proof. intros E j Hj. assert (Hi : (j / 4 < n)%nat) by (apply Nat.div_lt_upper_bound; lia). unfold state. destruct (E _ Hi) as [-> ->]. reflexivity. Qed.
Lemma state_close n (q u q' u' : nat -> C) e : (forall i, (i < n)%nat -> Cmod (q i - q' i)%C < e /\ Cmod (u i - u' i)%C < e) ->
  forall j, (j < 4 * n)%nat -> Rabs (state q u j - state q' u' j) < e.
Proof.
  intros H j Hj. assert (Hi : (j / 4 < n)%nat) by (apply Nat.div_lt_upper_bound; lia). destruct (H _ Hi) as [H1 H2]. unfold state.
  pose proof (parts (q (j / 4)%nat - q' (j / 4)%nat)%C) as [P1 P2]. pose proof (parts (u (j / 4)%nat - u' (j / 4)%nat)%C) as [P3 P4]. cbn [fst snd Cminus Cplus Copp] in *.
  unfold Rminus. destruct (j mod 4)%nat as [|[|[|]]]; lra.
Qed.
Lemma agents_close n x q u d : near (4 * n) d x (state q u) -> forall i, (i < n)%nat -> Cmod (place_of x i - q i)%C < 2 * d /\ Cmod (speed_of x i - u i)%C < 2 * d.
Proof.
  intros H i Hi. destruct (at_agent q u i) as (E0 & E1 & E2 & E3).
  pose proof (H (4 * i)%nat ltac:(lia)) as H0. pose proof (H (4 * i + 1)%nat ltac:(lia)) as H1. pose proof (H (4 * i + 2)%nat ltac:(lia)) as H2. pose proof (H (4 * i + 3)%nat ltac:(lia)) as H3.
  rewrite E0 in H0. rewrite E1 in H1. rewrite E2 in H2. rewrite E3 in H3.
  split; (eapply Rle_lt_trans; [apply paley_convergence.Cmod_le|]); unfold place_of, speed_of, Rminus in *; cbn [fst snd Cminus Cplus Copp]; lra.
Qed.
Lemma stay_apart n (r : nat -> C) : apart_at n complete r -> exists d, 0 < d /\ forall q : nat -> C, (forall i, (i < n)%nat -> Cmod (q i - r i)%C < d) -> apart_at n complete q.
Proof.
  intros A. destruct (small2 n (fun i j d => complete i j = true -> forall q : nat -> C, Cmod (q i - r i)%C < d -> Cmod (q j - r j)%C < d -> q i <> q j)) as (d & Hd & Q).
  - intros i j d d' H L Cm q H1 H2. apply (H Cm); lra.
  - intros i j Hi Hj. destruct (complete i j) eqn:Cm; [|exists 1; split; [lra|discriminate]]. pose proof (A i j Hi Hj Cm) as N.
    assert (P : 0 < Cmod (r i - r j)%C) by (apply norm_neq; exact N). exists (Cmod (r i - r j)%C / 2). split; [lra|]. intros _ q H1 H2 E.
    assert (L : Cmod (r i - r j)%C <= Cmod (q j - r j)%C + Cmod (q i - r i)%C); [|lra].
    replace (r i - r j)%C with ((q j - r j) + - (q i - r i))%C by (rewrite E; ring). eapply Rle_trans; [apply Cmod_triangle|]. rewrite Cmod_opp. lra.
  - exists d. split; [exact Hd|]. intros q H i j Hi Hj Cm. apply (Q i j Hi Hj Cm q); now apply H.
Qed.
Lemma distance_near (a b c d : C) e : Cmod (a - c)%C < e -> Cmod (b - d)%C < e -> Rabs (Cmod (a - b)%C - Cmod (c - d)%C) < 2 * e.
Proof.
  intros A B. assert (T : forall x y : C, Cmod x <= Cmod y + Cmod (x - y)%C) by (intros x y; eapply Rle_trans; [|apply Cmod_triangle]; right; f_equal; ring).
  assert (D : Cmod (a - b - (c - d))%C < 2 * e) by (replace (a - b - (c - d))%C with ((a - c) + - (b - d))%C by ring; eapply Rle_lt_trans; [apply Cmod_triangle|]; rewrite Cmod_opp; lra).
  pose proof (T (a - b)%C (c - d)%C) as T1. pose proof (T (c - d)%C (a - b)%C) as T2. rewrite <- (Cmod_opp (c - d - (a - b))%C) in T2.
  replace (- (c - d - (a - b)))%C with (a - b - (c - d))%C in T2 by ring. apply Rabs_def1; lra.
Qed.
Lemma stay_linked n (q : nat -> C) R0 : generic n R0 q -> exists d, 0 < d /\
  forall p : nat -> C, (forall i, (i < n)%nat -> Cmod (p i - q i)%C < d) -> same_pairs n (by_distance p R0) (by_distance q R0).
Proof.
  intros Gn. destruct (small2 n (fun i j d => i <> j -> forall p : nat -> C, Cmod (p i - q i)%C < d -> Cmod (p j - q j)%C < d -> (Cmod (p i - p j)%C < R0 <-> Cmod (q i - q j)%C < R0)))
    as (d & Hd & Q).
  - intros i j d d' H L Ne p H1 H2. apply (H Ne); lra.
  - intros i j Hi Hj. destruct (Nat.eq_dec i j) as [->|Ne]; [exists 1; split; [lra|congruence]|]. pose proof (Gn i j Hi Hj Ne) as N.
    exists (Rabs (Cmod (q i - q j)%C - R0) / 2). split; [apply Rdiv_lt_0_compat; [apply Rabs_pos_lt|]; lra|]. intros _ p H1 H2.
    pose proof (distance_near (p i) (p j) (q i) (q j) _ H1 H2) as L1. apply Rabs_def2 in L1.
    unfold Rabs in *. destruct (Rcase_abs (Cmod (q i - q j)%C - R0)); split; lra.
  - exists d. split; [exact Hd|]. intros p H i j Hi Hj. unfold by_distance. destruct (Nat.eqb_spec i j) as [E|Ne]; [reflexivity|]. pose proof (Q i j Hi Hj Ne p (H i Hi) (H j Hj)) as I.
    cbn [negb andb]. destruct (Rlt_dec (Cmod (p i - p j)%C) R0); destruct (Rlt_dec (Cmod (q i - q j)%C) R0); tauto || reflexivity.
Qed.
Lemma Csum_parts m (c : nat -> R) (y : nat -> C) : fst (Csum m (fun k => RtoC (c k) * y k)%C) = Sum m (fun k => c k * fst (y k)) /\
  snd (Csum m (fun k => RtoC (c k) * y k)%C) = Sum m (fun k => c k * snd (y k)).
Proof. induction m as [|m [I1 I2]]; [split; reflexivity|]. cbn [Csum Sum]. rewrite <- I1, <- I2. split; cbn; ring. Qed.
Lemma state_mean n m (c : nat -> R) (v z : nat -> C) (y : nat -> nat -> C) : Sum m c = 1 -> (forall i, (i < n)%nat -> z i = Csum m (fun k => RtoC (c k) * y k i)%C) ->
  forall j, (j < 4 * n)%nat -> state v z j = Sum m (fun k => c k * state v (y k) j).
Proof.
  intros S1 Z j Hj. assert (Hi : (j / 4 < n)%nat) by (apply Nat.div_lt_upper_bound; lia). unfold state. rewrite (Z _ Hi).
  destruct (Csum_parts m c (fun k => y k (j / 4)%nat)) as [F1 F2]. cbv beta in F1, F2. rewrite F1, F2.
  destruct (j mod 4)%nat as [|[|[|]]]; [| |reflexivity|reflexivity]; rewrite Sum_scal_r, S1; ring.
Qed.

(* ---- where a field has finitely many limits at a state, K there is within their convex hull ---- *)
Lemma finite_K n f x0 M (good : nat -> Prop) (Y : nat -> nat -> R) c0 w : (c0 < M)%nat -> good c0 ->
  (forall e, 0 < e -> exists d, 0 < d /\ forall x, near n d x x0 -> exists c, (c < M)%nat /\ good c /\ forall j, (j < n)%nat -> Rabs (f x j - Y c j) < e) ->
  tanner2_appendix.K n f x0 w -> exists u, tanner2_solutions.weights M good u /\ forall j, (j < n)%nat -> w j = Sum M (fun l => u l * Y l j).
Proof.
  intros Hc0 G0 F H. apply tanner2_solutions.finite_hull. intros e He. destruct (Nat.eq_dec n 0) as [->|Nz].
  { exists (fun k => delta k c0 * 1). split; [|intros i Hi; lia]. split; [|split].
    - intros c _. unfold delta. destruct (Nat.eqb c c0); lra.
    - intros c _ Ng. unfold delta. destruct (Nat.eqb_spec c c0) as [->|]; [contradiction|ring].
    - now apply (Sum_delta M c0 (fun _ => 1)). }
  destruct (F (e / 2) ltac:(lra)) as (d & Hd & Fd). destruct (H d (fun _ => False) Hd (tanner2_existence.null_none n ltac:(lia)) (e / 2) ltac:(lra)) as (m & c & y & C1 & C2 & C3).
  assert (Pts : exists b : nat -> nat, forall k, (k < m)%nat -> (b k < M)%nat /\ good (b k) /\ forall j, (j < n)%nat -> Rabs (y k j - Y (b k) j) < e / 2).
  { clear C2 C3. induction m as [|m IH]; [exists (fun _ => 0%nat); intros; lia|]. destruct IH as [b B]; [intros k Hk; apply C1; lia|].
    destruct (C1 m ltac:(lia)) as [_ (x & Nx & _ & Ex)]. destruct (Fd x Nx) as (l & Hl & Gl & L).
    exists (fun k => if Nat.eqb k m then l else b k). intros k Hk. destruct (Nat.eqb_spec k m) as [->|Nk]; [|apply B; lia]. split; [exact Hl|]. split; [exact Gl|].
    intros j Hj. rewrite (Ex j Hj). now apply L. }
  destruct Pts as [b B]. destruct (tanner2_solutions.gather n M good Y m c (fun k => Y (b k))) as (u & U1 & U2 & U3 & U4).
  { intros k Hk. split; [now apply C1|]. exists (b k). destruct (B k Hk) as (B1 & B2 & _). now repeat split. }
  exists u. split; [split; [intros; apply U1|split; [intros; now apply U2|now rewrite U3]]|]. intros j Hj. rewrite <- (U4 j Hj).
  replace (w j - Sum m (fun k => c k * Y (b k) j)) with ((w j - Sum m (fun k => c k * y k j)) + Sum m (fun k => c k * (y k j - Y (b k) j))).
  2: { rewrite (Sum_ext m (fun k => c k * (y k j - Y (b k) j)) (fun k => c k * y k j - c k * Y (b k) j)) by (intros; ring). rewrite Sum_minus. ring. }
  eapply Rle_lt_trans; [apply Rabs_triang|]. specialize (C3 j Hj). assert (Q : Rabs (Sum m (fun k => c k * (y k j - Y (b k) j))) <= e / 2); [|lra].
  eapply Rle_trans; [apply Sum_Rabs|]. apply Rle_trans with (Sum m (fun k => c k * (e / 2))); [|rewrite Sum_scal_r, C2; lra]. apply Sum_le. intros k Hk. destruct (C1 k Hk) as [C0 _].
  rewrite Rabs_mult, (Rabs_pos_eq (c k)) by exact C0. apply Rmult_le_compat_l; [exact C0|]. left. now apply B.
Qed.
(* and what a field comes near to off every null set is in K *)
Lemma hull_K n f x0 m (c : nat -> R) (y : nat -> nat -> R) w : (forall k, (k < m)%nat -> 0 <= c k) -> Sum m c = 1 -> (forall j, (j < n)%nat -> w j = Sum m (fun k => c k * y k j)) ->
  (forall k Z d e, (k < m)%nat -> tanner2_appendix.null n Z -> 0 < d -> 0 < e -> exists x, near n d x x0 /\ ~ Z x /\ forall j, (j < n)%nat -> Rabs (f x j - y k j) < e) -> tanner2_appendix.K n f x0 w.
Proof.
  intros C0 S1 E F d Z Hd HZ e He.
  assert (Pts : exists x : nat -> nat -> R, forall k, (k < m)%nat -> near n d (x k) x0 /\ ~ Z (x k) /\ forall j, (j < n)%nat -> Rabs (f (x k) j - y k j) < e / 2).
  { clear C0 S1 E. induction m as [|m IH]; [exists (fun _ _ => 0); intros; lia|]. destruct IH as [x X]; [intros k Z' d' e' Hk; apply F; lia|].
    destruct (F m Z d (e / 2) ltac:(lia) HZ Hd ltac:(lra)) as [p Hp]. exists (fun k => if Nat.eqb k m then p else x k). intros k Hk. destruct (Nat.eqb_spec k m) as [->|Nk]; [exact Hp|apply X; lia]. }
  destruct Pts as [x X]. exists m, c, (fun k => f (x k)). split; [intros k Hk; split; [now apply C0|]; exists (x k); destruct (X k Hk) as (X1 & X2 & _); now repeat split|].
  split; [exact S1|]. intros j Hj. rewrite (E j Hj), <- Sum_minus. apply Rle_lt_trans with (Sum m (fun k => c k * (e / 2))); [|rewrite Sum_scal_r, S1; lra].
  eapply Rle_trans; [apply Sum_Rabs|]. apply Sum_le. intros k Hk. rewrite <- Rmult_minus_distr_l, Rabs_mult, (Rabs_pos_eq (c k)) by now apply C0.
  apply Rmult_le_compat_l; [now apply C0|]. rewrite Rabs_minus_sym. left. now apply X.
Qed.

(* ---- limits of the law are in K: off a null set the field comes near each of them ---- *)
Section Within.
Variables (n : nat) (V V' : nat -> nat -> R -> R) (R0 : R) (r v : nat -> C).
Hypothesis P : potentials n complete V V'.
Hypothesis A : apart_at n complete r.
Lemma one_value y Z d e : limit_of_law n V' R0 r v y -> tanner2_appendix.null (4 * n) Z -> 0 < d -> 0 < e ->
  exists x, near (4 * n) d x (state r v) /\ ~ Z x /\ forall j, (j < 4 * n)%nat -> Rabs (field10 n V' R0 x j - state v y j) < e.
Proof.
  intros L HZ Hd He. destruct (stay_apart n r A) as (d0 & H0 & S0). set (h := Rmin d0 (Rmin d e) / 4).
  pose proof (Rmin_l d0 (Rmin d e)) as M1. pose proof (Rmin_r d0 (Rmin d e)) as M2. pose proof (Rmin_l d e) as M3. pose proof (Rmin_r d e) as M4.
  assert (Hh : 0 < h) by (unfold h; apply Rdiv_lt_0_compat; [repeat apply Rmin_glb_lt; assumption|lra]). destruct (L h Hh) as (q & u & Q1 & Q2 & Q3).
  assert (Aq : apart_at n complete q) by (apply S0; intros i Hi; destruct (Q1 i Hi); unfold h in *; lra). set (g := by_distance q R0).
  destruct (law4_near n V V' q u P Aq g h (fun i _ => proj2 (by_distance_simple q R0) i) Hh) as (d2 & H2 & S2).
  destruct (stay_linked n q R0 Q2) as (d3 & H3 & S3). set (w := Rmin (Rmin d2 d3) h / 2).
  pose proof (Rmin_l (Rmin d2 d3) h) as M5. pose proof (Rmin_r (Rmin d2 d3) h) as M6. pose proof (Rmin_l d2 d3) as M7. pose proof (Rmin_r d2 d3) as M8.
  assert (Hw : 0 < w) by (unfold w; apply Rdiv_lt_0_compat; [repeat apply Rmin_glb_lt; assumption|lra]).
  destruct (classic (exists x, ~ Z x /\ near (4 * n) w x (state q u))) as [(x & Nx & Bx)|No].
  2: { exfalso. apply (tanner2_existence.box_not_null (4 * n) (state q u) w Hw). apply (tanner2_existence.null_sub (4 * n) _ Z); [|exact HZ].
    intros x Bx. apply NNPP. intros Nx. apply No. now exists x. }
  pose proof (agents_close n x q u w Bx) as Cl. exists x. split; [|split; [exact Nx|]].
  - intros j Hj. pose proof (Bx j Hj) as B1. pose proof (state_close n q u r v h Q1 j Hj) as B2.
    replace (x j - state r v j) with ((x j - state q u j) + (state q u j - state r v j)) by ring. eapply Rle_lt_trans; [apply Rabs_triang|]. unfold w, h in *. lra.
  - unfold field10. apply state_close. intros i Hi. destruct (Cl i Hi) as [C1 C2]. destruct (Q1 i Hi) as [_ U1]. split.
    + replace (speed_of x i - v i)%C with ((speed_of x i - u i) + (u i - v i))%C by ring. eapply Rle_lt_trans; [apply Cmod_triangle|]. unfold w, h in *. lra.
    + assert (Same : law4 n (by_distance (place_of x) R0) V' (place_of x) (speed_of x) i = law4 n g V' (place_of x) (speed_of x) i).
      { apply law4_pairs; [|exact Hi]. apply S3. intros k Hk. destruct (Cl k Hk). unfold w in *. lra. }
      rewrite Same. assert (Nr : Cmod (law4 n g V' (place_of x) (speed_of x) i - law4 n g V' q u i)%C < h).
      { apply (S2 (place_of x) (speed_of x)); [|exact Hi]. intros k Hk. destruct (Cl k Hk). unfold w in *. split; lra. }
      replace (_ - y i)%C with ((law4 n g V' (place_of x) (speed_of x) i - law4 n g V' q u i) + (law4 n g V' q u i - y i))%C by ring.
      eapply Rle_lt_trans; [apply Cmod_triangle|]. pose proof (Q3 i Hi) as Q4. fold g in Q4. unfold h in *. lra.
Qed.
Lemma K10_within z : K10 n V' R0 r v z -> K4 n V' R0 (state r v) (state v z).
Proof.
  intros (m & c & y & Y1 & Y2 & Y3). apply (hull_K _ _ _ m c (fun k => state v (y k))); [intros k Hk; now apply Y1|exact Y2|now apply state_mean|].
  intros k Z d e Hk HZ Hd He. apply one_value; try assumption. now apply Y1.
Qed.

(* ---- and nothing else is: whatever a state nearby is, its value is near one of the finitely many limits ---- *)
Hypothesis HR : 0 < R0.
Lemma values_near e : 0 < e -> exists d, 0 < d /\ forall x, near (4 * n) d x (state r v) ->
  exists q, occurs n R0 r (by_distance q R0) /\ forall j, (j < 4 * n)%nat -> Rabs (field10 n V' R0 x j - state v (law4 n (by_distance q R0) V' r v) j) < e.
Proof.
  intros He. destruct (stay_apart n r A) as (d0 & H0 & S0). destruct (occurring_near n r R0) as (d1 & H1 & O1).
  destruct (finite_graphs n (fun g d => loopless n g -> forall q u : nat -> C, (forall i, (i < n)%nat -> Cmod (q i - r i)%C < d /\ Cmod (u i - v i)%C < d) ->
    forall i, (i < n)%nat -> Cmod (law4 n g V' q u i - law4 n g V' r v i)%C < e)) as (d2 & H2 & F2).
  - intros g d d' H L NL q u B. apply (H NL). intros i Hi. destruct (B i Hi). lra.
  - intros g h d E H NL q u B i Hi. rewrite <- !(law4_pairs n g h V' _ _ i E Hi). apply H; try assumption. intros k Hk. rewrite (E k k Hk Hk). now apply NL.
  - intros g. destruct (classic (loopless n g)) as [NL|NL]; [|exists 1; split; [lra|]; intros; contradiction]. destruct (law4_near n V V' r v P A g e NL He) as (d & Hd & L). exists d. split; [exact Hd|]. intros _. exact L.
  - set (d := Rmin (Rmin d0 d1) (Rmin d2 e) / 4). pose proof (Rmin_l (Rmin d0 d1) (Rmin d2 e)). pose proof (Rmin_r (Rmin d0 d1) (Rmin d2 e)). pose proof (Rmin_l d0 d1). pose proof (Rmin_r d0 d1).
    pose proof (Rmin_l d2 e). pose proof (Rmin_r d2 e). assert (Hd : 0 < d) by (unfold d; apply Rdiv_lt_0_compat; [repeat apply Rmin_glb_lt; assumption|lra]). exists d. split; [exact Hd|]. intros x Nx.
    pose proof (agents_close n x r v d Nx) as Cl.
    assert (Ax : apart_at n complete (place_of x)) by (apply S0; intros i Hi; destruct (Cl i Hi); unfold d in *; lra).
    destruct (spread_generic n (place_of x) R0 HR) with (e := d1 / 2) as (q & Q1 & Q2 & Q3); [|lra|].
    { intros i j Hi Hj Ne. apply Ax; try assumption. unfold complete. destruct (Nat.eqb_spec i j); [contradiction|reflexivity]. }
    exists q. split.
    + apply O1; [|exact Q2]. intros i Hi. destruct (Cl i Hi) as [C1 _]. specialize (Q1 i Hi). replace (q i - r i)%C with ((q i - place_of x i) + (place_of x i - r i))%C by ring.
      eapply Rle_lt_trans; [apply Cmod_triangle|]. unfold d in *. lra.
    + unfold field10. apply state_close. intros i Hi. destruct (Cl i Hi) as [C1 C2]. split; [unfold d in *; lra|]. rewrite (law4_pairs n _ _ V' _ _ i Q3 Hi).
      apply F2; [intros k _; apply by_distance_simple| |exact Hi]. intros k Hk. destruct (Cl k Hk). unfold d in *. lra.
Qed.
(* a network that occurs at the state, the one with the number c where that one does *)
Lemma numbered_limit c0 c : occurs n R0 r (tanner2_solutions.network_of n c0) -> exists g, limit_of_law n V' R0 r v (law4 n g V' r v) /\ (occurs n R0 r (tanner2_solutions.network_of n c) -> g = tanner2_solutions.network_of n c).
Proof.
  assert (Lim : forall c, occurs n R0 r (tanner2_solutions.network_of n c) -> limit_of_law n V' R0 r v (law4 n (tanner2_solutions.network_of n c) V' r v)).
  { intros c' O. destruct (O 1 Rlt_0_1) as (q & _ & _ & Sq). intros e He.
    destruct (law_is_limit n V V' r v P A R0 q (tanner2_solutions.occurs_pairs n R0 r _ _ Sq O) e He) as (q' & u & L1 & L2 & L3). exists q', u. split; [exact L1|]. split; [exact L2|].
    intros i Hi. rewrite (law4_pairs n _ _ V' r v i Sq Hi). now apply L3. }
  intros O0. destruct (classic (occurs n R0 r (tanner2_solutions.network_of n c))) as [O|N]; [exists (tanner2_solutions.network_of n c)|exists (tanner2_solutions.network_of n c0)]; split;
    [now apply Lim|reflexivity|now apply Lim|contradiction].
Qed.
Lemma apart_pairs i j : (i < n)%nat -> (j < n)%nat -> i <> j -> r i <> r j.
Proof. intros Hi Hj Ne. apply A; try assumption. unfold complete. destruct (Nat.eqb_spec i j); [contradiction|reflexivity]. Qed.
Lemma K_within w : K4 n V' R0 (state r v) w -> exists z, K10 n V' R0 r v z /\ forall j, (j < 4 * n)%nat -> w j = state v z j.
Proof.
  intros H. set (N := (2 ^ (n * n))%nat). set (net := tanner2_solutions.network_of n). set (good := fun c => occurs n R0 r (net c)). set (Y := fun c j => state v (law4 n (net c) V' r v) j).
  destruct (tanner2_solutions.numbered_occurs n R0 r (by_distance r R0)) as (c0 & Hc0 & _ & G0); [intros e He; apply (spread_generic n r R0 HR apart_pairs e He)|].
  destruct (finite_K (4 * n) (field10 n V' R0) (state r v) N good Y c0 w Hc0 G0) as (u & (U1 & U2 & U3) & E); [|exact H|].
  { intros e He. destruct (values_near e He) as (d & Hd & F). exists d. split; [exact Hd|]. intros x Nx. destruct (F x Nx) as (q & O & L). destruct (tanner2_solutions.numbered_occurs n R0 r _ O) as (l & Hl & Sl & Ol).
    exists l. split; [exact Hl|]. split; [exact Ol|]. intros j Hj. unfold Y. rewrite (state_ext n v _ v (law4 n (by_distance q R0) V' r v)); [now apply L| |exact Hj]. intros i Hi. split; [reflexivity|]. now apply law4_pairs. }
  assert (Ys : exists g : nat -> graph, forall c, (c < N)%nat -> limit_of_law n V' R0 r v (law4 n (g c) V' r v) /\ (good c -> g c = net c)).
  { clear E U1 U2 U3 Hc0. induction N as [|N IH]; [exists (fun _ => net 0%nat); intros; lia|]. destruct IH as [g G]. destruct (numbered_limit c0 N G0) as (h & Hh). exists (fun c => if Nat.eqb c N then h else g c).
    intros c Hc. destruct (Nat.eqb_spec c N) as [->|Nc]; [exact Hh|apply G; lia]. }
  destruct Ys as [g G]. exists (fun i => Csum N (fun c => RtoC (u c) * law4 n (g c) V' r v i)%C). split.
  - exists N, u, (fun c => law4 n (g c) V' r v). split; [intros c Hc; split; [now apply U1|now apply G]|]. split; [exact U3|reflexivity].
  - intros j Hj. rewrite (E j Hj), (state_mean n N u v _ (fun c => law4 n (g c) V' r v) U3 (fun _ _ => eq_refl) j Hj). apply Sum_ext. intros c Hc. destruct (classic (good c)) as [Gc|Gc].
    + unfold Y. now rewrite (proj2 (G c Hc) Gc).
    + rewrite (U2 c Hc Gc). ring.
Qed.
End Within.
Lemma K_ext n V' R0 x w w' : (forall j, (j < 4 * n)%nat -> w j = w' j) -> K4 n V' R0 x w -> K4 n V' R0 x w'.
Proof. intros E H d Z Hd HZ e He. destruct (H d Z Hd HZ e He) as (m & c & y & A & S1 & L). exists m, c, y. split; [exact A|]. split; [exact S1|]. intros j Hj. rewrite <- E by exact Hj. now apply L. Qed.
Theorem K_is_K10 : forall n V V' R0 r v w, 0 < R0 -> potentials n complete V V' -> apart_at n complete r ->
  tanner2_appendix.K (4 * n) (field10 n V' R0) (state r v) w <-> exists z, K10 n V' R0 r v z /\ forall j, (j < 4 * n)%nat -> w j = state v z j.
Proof.
  intros n V V' R0 r v w HR P A. split; [now apply (K_within n V V' R0 r v P A HR)|]. intros (z & Kz & E). apply (K_ext n V' R0 _ (state v z)); [intros j Hj; symmetry; now apply E|].
  now apply (K10_within n V V' R0 r v P A).
Qed.


(* ---- the gradients of all agents, as a field on R^(2n): agent i at i, n + i ---- *)
Notation spot := tanner2_lasting.place.
Definition gradient_field n V' R0 (x : nat -> R) : nat -> R := tanner2_approach.flat n (gradV n (by_distance (spot n x) R0) V' (spot n x)).
Notation flat := tanner2_approach.flat.
Lemma flat_close n (q p : nat -> C) e : (forall i, (i < n)%nat -> Cmod (q i - p i)%C < e) -> forall j, (j < 2 * n)%nat -> Rabs (flat n q j - flat n p j) < e.
Proof.
  intros H j Hj. unfold flat. destruct (Nat.ltb_spec j n) as [L|L]; (eapply Rle_lt_trans; [|apply H]).
  - apply (proj1 (parts (q j - p j)%C)).
  - exact L.
  - apply (proj2 (parts (q (j - n)%nat - p (j - n)%nat)%C)).
  - lia.
Qed.
Lemma spots_close n x q d : near (2 * n) d x (flat n q) -> forall i, (i < n)%nat -> Cmod (spot n x i - q i)%C < 2 * d.
Proof.
  intros H i Hi. pose proof (H i ltac:(lia)) as H0. pose proof (H (n + i)%nat ltac:(lia)) as H1. unfold flat in H0, H1.
  destruct (Nat.ltb_spec i n); [|lia]. destruct (Nat.ltb_spec (n + i) n); [lia|]. replace (n + i - n)%nat with i in H1 by lia.
  eapply Rle_lt_trans; [apply paley_convergence.Cmod_le|]. unfold tanner2_lasting.place, Rminus in *. cbn [fst snd Cminus Cplus Copp]. lra.
Qed.
Lemma flat_mean n m (c : nat -> R) (z : nat -> C) (y : nat -> nat -> C) : (forall i, (i < n)%nat -> z i = Csum m (fun k => RtoC (c k) * y k i)%C) ->
  forall j, (j < 2 * n)%nat -> flat n z j = Sum m (fun k => c k * flat n (y k) j).
Proof.
  intros Z j Hj. unfold flat. destruct (Nat.ltb_spec j n) as [L|L].
  - rewrite (Z j L). apply (proj1 (Csum_parts m c (fun k => y k j))).
  - rewrite (Z (j - n)%nat ltac:(lia)). apply (proj2 (Csum_parts m c (fun k => y k (j - n)%nat))).
Qed.
Section Gradients.
Variables (n : nat) (V V' : nat -> nat -> R -> R) (R0 : R) (r : nat -> C).
Hypothesis P : potentials n complete V V'.
Hypothesis A : apart_at n complete r.
Hypothesis HR : 0 < R0.
Notation rest := tanner2_approach.rest.
Lemma rests e : 0 < e -> forall i, Cmod (rest i - rest i)%C < e.
Proof. intros He i. replace (rest i - rest i)%C with (RtoC 0) by ring. now rewrite Cmod_0. Qed.
Lemma at_rest g q h p i : Cmod (gradV n g V' q i - gradV n h V' p i)%C = Cmod (law4 n g V' q rest i - law4 n h V' p rest i)%C.
Proof. rewrite !tanner2_approach.law4_rest, <- Cmod_opp. f_equal. ring. Qed.
Lemma gradient_value y Z d e : tanner2_approach.limit_of_gradients n V' R0 r y -> tanner2_appendix.null (2 * n) Z -> 0 < d -> 0 < e ->
  exists x, near (2 * n) d x (flat n r) /\ ~ Z x /\ forall j, (j < 2 * n)%nat -> Rabs (gradient_field n V' R0 x j - flat n y j) < e.
Proof.
  intros L HZ Hd He. destruct (stay_apart n r A) as (d0 & H0 & S0). set (h := Rmin d0 (Rmin d e) / 4).
  pose proof (Rmin_l d0 (Rmin d e)) as M1. pose proof (Rmin_r d0 (Rmin d e)) as M2. pose proof (Rmin_l d e) as M3. pose proof (Rmin_r d e) as M4.
  assert (Hh : 0 < h) by (unfold h; apply Rdiv_lt_0_compat; [repeat apply Rmin_glb_lt; assumption|lra]). destruct (L h Hh) as (q & Q1 & Q2 & Q3).
  assert (Aq : apart_at n complete q) by (apply S0; intros i Hi; specialize (Q1 i Hi); unfold h in *; lra). set (g := by_distance q R0).
  destruct (law4_near n V V' q rest P Aq g h (fun i _ => proj2 (by_distance_simple q R0) i) Hh) as (d2 & H2 & S2).
  destruct (stay_linked n q R0 Q2) as (d3 & H3 & S3). set (w := Rmin (Rmin d2 d3) h / 2).
  pose proof (Rmin_l (Rmin d2 d3) h) as M5. pose proof (Rmin_r (Rmin d2 d3) h) as M6. pose proof (Rmin_l d2 d3) as M7. pose proof (Rmin_r d2 d3) as M8.
  assert (Hw : 0 < w) by (unfold w; apply Rdiv_lt_0_compat; [repeat apply Rmin_glb_lt; assumption|lra]).
  destruct (classic (exists x, ~ Z x /\ near (2 * n) w x (flat n q))) as [(x & Nx & Bx)|No].
  2: { exfalso. apply (tanner2_existence.box_not_null (2 * n) (flat n q) w Hw). apply (tanner2_existence.null_sub (2 * n) _ Z); [|exact HZ]. intros x Bx. apply NNPP. intros Nx. apply No. now exists x. }
  pose proof (spots_close n x q w Bx) as Cl. exists x. split; [|split; [exact Nx|]].
  - intros j Hj. pose proof (Bx j Hj) as B1. pose proof (flat_close n q r h Q1 j Hj) as B2.
    replace (x j - flat n r j) with ((x j - flat n q j) + (flat n q j - flat n r j)) by ring. eapply Rle_lt_trans; [apply Rabs_triang|]. unfold w, h in *. lra.
  - unfold gradient_field. apply flat_close. intros i Hi.
    assert (Nr : Cmod (gradV n (by_distance (spot n x) R0) V' (spot n x) i - gradV n g V' q i)%C < h).
    { rewrite at_rest, (law4_pairs n (by_distance (spot n x) R0) g V' (spot n x) rest i); [|apply S3; intros k Hk; specialize (Cl k Hk); unfold w in *; lra|exact Hi].
      apply S2; [|exact Hi]. intros k Hk. specialize (Cl k Hk). split; [unfold w in *; lra|now apply rests]. }
    replace (_ - y i)%C with ((gradV n (by_distance (spot n x) R0) V' (spot n x) i - gradV n g V' q i) + (gradV n g V' q i - y i))%C by ring.
    eapply Rle_lt_trans; [apply Cmod_triangle|]. specialize (Q3 i Hi). fold g in Q3. unfold h in *. lra.
Qed.
Lemma gradients_near e : 0 < e -> exists d, 0 < d /\ forall x, near (2 * n) d x (flat n r) ->
  exists q, occurs n R0 r (by_distance q R0) /\ forall j, (j < 2 * n)%nat -> Rabs (gradient_field n V' R0 x j - flat n (gradV n (by_distance q R0) V' r) j) < e.
Proof.
  intros He. destruct (values_near n V V' R0 r rest P A HR e He) as (d & Hd & F). exists (d / 2). split; [lra|]. intros x Nx. pose proof (spots_close n x r (d / 2) Nx) as Cl.
  destruct (F (state (spot n x) rest)) as (q & O & L).
  { unfold near. apply state_close. intros i Hi. specialize (Cl i Hi). split; [lra|now apply rests]. }
  exists q. split; [exact O|]. assert (G : forall i, (i < n)%nat -> Rabs (fst (gradV n (by_distance (spot n x) R0) V' (spot n x) i) - fst (gradV n (by_distance q R0) V' r i)) < e /\
    Rabs (snd (gradV n (by_distance (spot n x) R0) V' (spot n x) i) - snd (gradV n (by_distance q R0) V' r i)) < e).
  { intros i Hi. pose proof (L (4 * i + 2)%nat ltac:(lia)) as L2. pose proof (L (4 * i + 3)%nat ltac:(lia)) as L3. unfold field10 in L2, L3.
    rewrite !(proj1 (proj2 (proj2 (at_agent _ _ i)))) in L2. rewrite !(proj2 (proj2 (proj2 (at_agent _ _ i)))) in L3.
    assert (E : law4 n (by_distance (place_of (state (spot n x) rest)) R0) V' (place_of (state (spot n x) rest)) (speed_of (state (spot n x) rest)) i = law4 n (by_distance (spot n x) R0) V' (spot n x) rest i).
    { replace (place_of (state (spot n x) rest)) with (spot n x) by (apply FunctionalExtensionality.functional_extensionality; intros k; symmetry; apply agents_of).
      replace (speed_of (state (spot n x) rest)) with rest by (apply FunctionalExtensionality.functional_extensionality; intros k; symmetry; apply agents_of). reflexivity. }
    rewrite E, !tanner2_approach.law4_rest in L2, L3. cbn [fst snd Copp] in L2, L3. rewrite <- Rabs_Ropp in L2, L3.
    split; [eapply Rle_lt_trans; [|exact L2]|eapply Rle_lt_trans; [|exact L3]]; right; f_equal; ring. }
  intros j Hj. unfold gradient_field, flat. destruct (Nat.ltb_spec j n) as [B|B]; apply G; lia.
Qed.
Lemma numbered_gradient c0 c : occurs n R0 r (tanner2_solutions.network_of n c0) -> exists g, tanner2_approach.limit_of_gradients n V' R0 r (gradV n g V' r) /\
  (occurs n R0 r (tanner2_solutions.network_of n c) -> g = tanner2_solutions.network_of n c).
Proof.
  intros O0. destruct (classic (occurs n R0 r (tanner2_solutions.network_of n c))) as [O|N]; [exists (tanner2_solutions.network_of n c)|exists (tanner2_solutions.network_of n c0)]; split;
    [now apply (tanner2_approach.gradient_limit n V)|reflexivity|now apply (tanner2_approach.gradient_limit n V)|contradiction].
Qed.
Lemma gradients_within w : tanner2_appendix.K (2 * n) (gradient_field n V' R0) (flat n r) w -> exists z, tanner2_approach.K_gradients n V' R0 r z /\ forall j, (j < 2 * n)%nat -> w j = flat n z j.
Proof.
  intros H. set (N := (2 ^ (n * n))%nat). set (net := tanner2_solutions.network_of n). set (good := fun c => occurs n R0 r (net c)). set (Y := fun c j => flat n (gradV n (net c) V' r) j).
  destruct (tanner2_solutions.numbered_occurs n R0 r (by_distance r R0)) as (c0 & Hc0 & _ & G0); [intros e He; apply (spread_generic n r R0 HR (apart_pairs n r A) e He)|].
  destruct (finite_K (2 * n) (gradient_field n V' R0) (flat n r) N good Y c0 w Hc0 G0) as (u & (U1 & U2 & U3) & E); [|exact H|].
  { intros e He. destruct (gradients_near e He) as (d & Hd & F). exists d. split; [exact Hd|]. intros x Nx. destruct (F x Nx) as (q & O & L). destruct (tanner2_solutions.numbered_occurs n R0 r _ O) as (l & Hl & Sl & Ol).
    exists l. split; [exact Hl|]. split; [exact Ol|]. intros j Hj. specialize (L j Hj). unfold Y, flat in *.
    assert (Sg : forall i, (i < n)%nat -> gradV n (net l) V' r i = gradV n (by_distance q R0) V' r i).
    { intros i Hi. unfold gradV. apply Csum_ext. intros k Hk. unfold pull, net. now rewrite (Sl i k Hi Hk). }
    destruct (Nat.ltb_spec j n) as [B|B]; rewrite Sg by lia; exact L. }
  assert (Ys : exists g : nat -> graph, forall c, (c < N)%nat -> tanner2_approach.limit_of_gradients n V' R0 r (gradV n (g c) V' r) /\ (good c -> g c = net c)).
  { clear E U1 U2 U3 Hc0. induction N as [|N IH]; [exists (fun _ => net 0%nat); intros; lia|]. destruct IH as [g G]. destruct (numbered_gradient c0 N G0) as (h & Hh). exists (fun c => if Nat.eqb c N then h else g c).
    intros c Hc. destruct (Nat.eqb_spec c N) as [->|Nc]; [exact Hh|apply G; lia]. }
  destruct Ys as [g G]. exists (fun i => Csum N (fun c => RtoC (u c) * gradV n (g c) V' r i)%C). split.
  - exists N, u, (fun c => gradV n (g c) V' r). split; [intros c Hc; split; [now apply U1|now apply G]|]. split; [exact U3|reflexivity].
  - intros j Hj. rewrite (E j Hj), (flat_mean n N u _ (fun c => gradV n (g c) V' r) (fun _ _ => eq_refl) j Hj). apply Sum_ext. intros c Hc. destruct (classic (good c)) as [Gc|Gc].
    + unfold Y. now rewrite (proj2 (G c Hc) Gc).
    + rewrite (U2 c Hc Gc). ring.
Qed.
End Gradients.
Theorem K_is_K_gradients : forall n V V' R0 r w, 0 < R0 -> potentials n complete V V' -> apart_at n complete r ->
  tanner2_appendix.K (2 * n) (gradient_field n V' R0) (flat n r) w <-> exists z, tanner2_approach.K_gradients n V' R0 r z /\ forall j, (j < 2 * n)%nat -> w j = flat n z j.
Proof.
  intros n V V' R0 r w HR P A. split; [now apply (gradients_within n V)|]. intros (z & (m & c & y & Y1 & Y2 & Y3) & E).
  apply (hull_K _ _ _ m c (fun k => flat n (y k))); [intros k Hk; now apply Y1|exact Y2| |].
  - intros j Hj. rewrite (E j Hj). now apply flat_mean.
  - intros k Z d e Hk HZ Hd He. apply (gradient_value n V V' R0 r P A); try assumption. now apply Y1.
Qed.
