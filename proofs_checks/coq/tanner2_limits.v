(* Tanner, Jadbabaie, Pappas, links by distance: near a state only finitely many networks occur, and the limits of the law (10) at the state are
   its values with the networks that occur arbitrarily near.  K of Definition 4 is their convex hull. *)
From Coq Require Import Reals Lra Lia Psatz Classical FunctionalExtensionality.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums inclusions paley_model paley_phase paley_laplacian paley_gradient tanner_energy tanner_flock.
From Flockproof Require Import tanner2_filippov.
From Flockproof Require tanner_trees tanner_saturated.
Open Scope R_scope.

(* ---- finitely many networks ---- *)
Definition setbit (k : nat) (b : bool) (f : nat -> bool) (i : nat) := if Nat.eqb i k then b else f i.
Definition trunc (k : nat) (f : nat -> bool) (i : nat) := if Nat.ltb i k then f i else false.
Lemma finite_bits k : forall P : (nat -> bool) -> R -> Prop, (forall f e e', P f e -> 0 < e' <= e -> P f e') -> (forall f, exists e, 0 < e /\ P f e) ->
  exists e, 0 < e /\ forall f, P (trunc k f) e.
Proof.
  induction k as [|k IH]; intros P Mono H.
  - destruct (H (fun _ => false)) as (e & He & Q). exists e. split; [exact He|]. intros f. replace (trunc 0 f) with (fun _ : nat => false); [exact Q|].
    apply functional_extensionality. intros i. reflexivity.
  - destruct (IH (fun f e => forall b, P (setbit k b f) e)) as (e & He & Q).
    + intros f e e' Q L b. now apply (Mono _ e).
    + intros f. destruct (H (setbit k true f)) as (e1 & H1 & Q1). destruct (H (setbit k false f)) as (e2 & H2 & Q2).
      assert (H3 : 0 < Rmin e1 e2) by now apply Rmin_glb_lt. exists (Rmin e1 e2). split; [exact H3|].
      intros [|]; [apply (Mono _ e1)|apply (Mono _ e2)]; try assumption; split; try assumption; [apply Rmin_l|apply Rmin_r].
    + exists e. split; [exact He|]. intros f. replace (trunc (S k) f) with (setbit k (f k) (trunc k f)); [apply Q|].
      apply functional_extensionality. intros i. unfold setbit, trunc. destruct (Nat.eqb_spec i k) as [->|N].
      * destruct (Nat.ltb_spec k (S k)); [reflexivity|lia].
      * destruct (Nat.ltb_spec i k), (Nat.ltb_spec i (S k)); try reflexivity; lia.
Qed.
Definition same_pairs n (g h : graph) := forall i j, (i < n)%nat -> (j < n)%nat -> g i j = h i j.
Lemma finite_graphs n (P : graph -> R -> Prop) : (forall g e e', P g e -> 0 < e' <= e -> P g e') -> (forall g h e, same_pairs n g h -> P g e -> P h e) ->
  (forall g, exists e, 0 < e /\ P g e) -> exists e, 0 < e /\ forall g, P g e.
Proof.
  intros Mono Ext H. set (gr := fun (f : nat -> bool) i j => f (i * n + j)%nat).
  destruct (finite_bits (n * n) (fun f e => P (gr f) e)) as (e & He & Q); [intros f e e'; apply Mono|intros f; apply H|].
  exists e. split; [exact He|]. intros g. specialize (Q (fun m => g (m / n)%nat (m mod n)%nat)). revert Q. apply Ext. intros i j Hi Hj. unfold gr, trunc.
  destruct (Nat.ltb_spec (i * n + j) (n * n)) as [L|L]; [|nia]. rewrite Nat.div_add_l, Nat.div_small, Nat.add_0_r by lia.
  rewrite Nat.add_comm, Nat.mod_add, Nat.mod_small by lia. reflexivity.
Qed.

(* ---- networks that occur arbitrarily near a state, at states without a pair at the distance R ---- *)
Definition generic n R0 (q : nat -> C) := forall i j, (i < n)%nat -> (j < n)%nat -> i <> j -> Cmod (q i - q j)%C <> R0.
Definition occurs n R0 (r : nat -> C) (g : graph) := forall e, 0 < e -> exists q : nat -> C, (forall i, (i < n)%nat -> Cmod (q i - r i)%C < e) /\ generic n R0 q /\
  same_pairs n g (by_distance q R0).
Lemma law4_pairs n g h V' r v i : same_pairs n g h -> (i < n)%nat -> law4 n g V' r v i = law4 n h V' r v i.
Proof. intros E Hi. rewrite !law4_one. apply Csum_ext. intros j Hj. unfold pull. now rewrite (E i j Hi Hj). Qed.
Section Near.
Variables (n : nat) (V V' : nat -> nat -> R -> R) (r v : nat -> C).
Hypothesis P : potentials n complete V V'.
Hypothesis A : apart_at n complete r.
(* the law with one network is continuous where no agents coincide *)
Definition loopless (g : graph) := forall i, (i < n)%nat -> g i i = false.
Lemma law4_near g e : loopless g -> 0 < e -> exists d, 0 < d /\ forall q u : nat -> C, (forall i, (i < n)%nat -> Cmod (q i - r i)%C < d /\ Cmod (u i - v i)%C < d) ->
  forall i, (i < n)%nat -> Cmod (law4 n g V' q u i - law4 n g V' r v i)%C < e.
Proof.
  intros NL He. set (h := e / (4 * (INR n + 1))). pose proof (pos_INR n) as Pn. assert (Hh : 0 < h) by (apply Rdiv_lt_0_compat; lra).
  destruct (small2 n (fun i j d => i <> j -> forall q : nat -> C, Cmod (q i - r i)%C < d -> Cmod (q j - r j)%C < d ->
    Cmod (pull complete V' q i j - pull complete V' r i j)%C < h)) as (d & Hd & Q).
  { intros i j d d' H L Ne q H1 H2. apply (H Ne); lra. }
  { intros i j Hi Hj. destruct (Nat.eq_dec i j) as [->|Ne]; [exists 1; split; [lra|congruence]|].
    assert (L : complete i j = true) by (unfold complete; destruct (Nat.eqb_spec i j); [contradiction|reflexivity]).
    pose proof (norm_neq _ _ (A i j Hi Hj L)) as N. change (0 < Cmod (r i - r j)%C) in N.
    destruct P as [_ P']. destruct (P' i j Hi Hj L) as (P1 & _). destruct (P1 _ N) as (_ & Cn & _).
    destruct (force_near (V' i j) (r i - r j)%C h N Cn Hh) as (d1 & Hd1 & F). exists (d1 / 2). split; [lra|]. intros _ q H1 H2. unfold pull. rewrite L. apply F.
    replace (q i - q j - (r i - r j))%C with ((q i - r i) + - (q j - r j))%C by ring. eapply Rle_lt_trans; [apply Cmod_triangle|]. rewrite Cmod_opp. lra. }
  exists (Rmin d h). split; [now apply Rmin_glb_lt|]. intros q u Q1 i Hi. pose proof (Rmin_l d h). pose proof (Rmin_r d h).
  assert (E : Cmod (law4 n g V' q u i - law4 n g V' r v i)%C <= INR n * (3 * h)).
  { rewrite !law4_one, Csum_gap. eapply Rle_trans; [apply tanner_trees.norm_Csum|]. rewrite <- Sum_const. apply Sum_le. intros j Hj. unfold norm, pull.
    destruct (g i j) eqn:Gij; [|replace (- 0 - 0 - (- 0 - 0))%C with (RtoC 0) by ring; rewrite Cmod_0; lra].
    assert (Ne : i <> j) by (intros ->; rewrite (NL j Hj) in Gij; discriminate).
    assert (L : complete i j = true) by (unfold complete; destruct (Nat.eqb_spec i j); [contradiction|reflexivity]).
    destruct (Q1 i Hi) as [I1 I2], (Q1 j Hj) as [J1 J2]. pose proof (Q i j Hi Hj Ne q ltac:(lra) ltac:(lra)) as F. unfold pull in F. rewrite L in F.
    set (a := (RtoC (V' i j (Cmod (q i - q j)) / Cmod (q i - q j)) * (q i - q j))%C) in *. set (b := (RtoC (V' i j (Cmod (r i - r j)) / Cmod (r i - r j)) * (r i - r j))%C) in *.
    replace (- (u i - u j) - a - (- (v i - v j) - b))%C with (- (u i - v i) + ((u j - v j) + - (a - b)))%C by ring.
    eapply Rle_trans; [apply Cmod_triangle|]. rewrite Cmod_opp. pose proof (Cmod_triangle (u j - v j)%C (- (a - b))%C) as T. rewrite Cmod_opp in T. lra. }
  assert (h * (4 * (INR n + 1)) = e) by (unfold h; field; lra). nra.
Qed.
Variable R0 : R.
(* near a state only networks occur that occur arbitrarily near *)
Lemma occurring_near : exists d, 0 < d /\ forall q : nat -> C, (forall i, (i < n)%nat -> Cmod (q i - r i)%C < d) -> generic n R0 q -> occurs n R0 r (by_distance q R0).
Proof.
  destruct (finite_graphs n (fun g d => forall q : nat -> C, (forall i, (i < n)%nat -> Cmod (q i - r i)%C < d) -> generic n R0 q -> same_pairs n g (by_distance q R0) -> occurs n R0 r g)) as (d & Hd & K).
  - intros g e e' H L q N G S. apply (H q); try assumption. intros i Hi. specialize (N i Hi). lra.
  - intros g h e E H q N G S e' He'. destruct (H q N G (fun i j Hi Hj => eq_trans (E i j Hi Hj) (S i j Hi Hj)) e' He') as (q' & N' & G' & S').
    exists q'. split; [exact N'|]. split; [exact G'|]. intros i j Hi Hj. rewrite <- (E i j Hi Hj). now apply S'.
  - intros g. destruct (classic (occurs n R0 r g)) as [Y|N]; [exists 1; split; [lra|]; intros; exact Y|].
    apply not_all_ex_not in N. destruct N as [e N]. apply imply_to_and in N. destruct N as [He N]. exists e. split; [exact He|]. intros q Nq G S. exfalso. apply N. now exists q.
  - exists d. split; [exact Hd|]. intros q N G. apply (K _ q N G). intros i j _ _. reflexivity.
Qed.
(* a limit of the law is its value with such a network *)
Theorem limit_is_law y : limit_of_law n V' R0 r v y -> exists q, occurs n R0 r (by_distance q R0) /\ forall i, (i < n)%nat -> y i = law4 n (by_distance q R0) V' r v i.
Proof.
  intros Ly. destruct occurring_near as (d & Hd & K).
  destruct (classic (exists q, occurs n R0 r (by_distance q R0) /\ forall i, (i < n)%nat -> y i = law4 n (by_distance q R0) V' r v i)) as [Y|N]; [exact Y|exfalso].
  destruct (finite_graphs n (fun g e => loopless g -> occurs n R0 r g -> (exists q, same_pairs n g (by_distance q R0)) -> forall q u : nat -> C,
    (forall i, (i < n)%nat -> Cmod (q i - r i)%C < e /\ Cmod (u i - v i)%C < e) -> exists i, (i < n)%nat /\ e <= Cmod (law4 n g V' q u i - y i)%C)) as (e & He & Q).
  - intros g e e' H L NL O X q u B. destruct (H NL O X q u) as (i & Hi & G); [intros i Hi; specialize (B i Hi); lra|]. exists i. split; [exact Hi|lra].
  - intros g h e E H NL O (q0 & X) q u B. destruct (H) with (q := q) (u := u) as (i & Hi & G).
    + intros i Hi. rewrite (E i i Hi Hi). now apply NL.
    + intros e0 He0. destruct (O e0 He0) as (q1 & O1 & O2 & O3). exists q1. split; [exact O1|]. split; [exact O2|]. intros i j Hi Hj. rewrite (E i j Hi Hj). now apply O3.
    + exists q0. intros i j Hi Hj. rewrite (E i j Hi Hj). now apply X.
    + exact B.
    + exists i. split; [exact Hi|]. now rewrite <- (law4_pairs n g h V' q u i E Hi).
  - intros g. destruct (classic (loopless g /\ occurs n R0 r g /\ exists q, same_pairs n g (by_distance q R0))) as [(NL & O & q0 & X)|No]; [|exists 1; split; [lra|]; intros; exfalso; now apply No].
    assert (Z : exists i, (i < n)%nat /\ y i <> law4 n g V' r v i).
    { apply NNPP. intros Z. apply N. exists q0. split.
      - intros e He. destruct (O e He) as (q1 & O1 & O2 & O3). exists q1. split; [exact O1|]. split; [exact O2|]. intros i j Hi Hj. rewrite <- (X i j Hi Hj). now apply O3.
      - intros i Hi. apply NNPP. intros W. apply Z. exists i. split; [exact Hi|]. now rewrite (law4_pairs n g _ V' r v i X Hi). }
    destruct Z as (i & Hi & Z). set (gap := Cmod (law4 n g V' r v i - y i)%C).
    assert (Hg : 0 < gap). { apply (norm_neq (law4 n g V' r v i) (y i)). congruence. }
    destruct (law4_near g (gap / 2) NL ltac:(lra)) as (d' & Hd' & L). exists (Rmin d' (gap / 2)). split; [apply Rmin_glb_lt; lra|].
    intros _ _ _ q u B. pose proof (Rmin_l d' (gap / 2)). pose proof (Rmin_r d' (gap / 2)). exists i. split; [exact Hi|].
    assert (L' : Cmod (law4 n g V' q u i - law4 n g V' r v i)%C < gap / 2) by (apply L; [intros k Hk; specialize (B k Hk); lra|exact Hi]).
    pose proof (Cmod_triangle (law4 n g V' q u i - y i)%C (- (law4 n g V' q u i - law4 n g V' r v i))%C) as T. rewrite Cmod_opp in T.
    replace (law4 n g V' q u i - y i + - (law4 n g V' q u i - law4 n g V' r v i))%C with (law4 n g V' r v i - y i)%C in T by ring. fold gap in T. lra.
  - destruct (Ly (Rmin d e) ltac:(now apply Rmin_glb_lt)) as (q & u & Q1 & Q2 & Q3). pose proof (Rmin_l d e). pose proof (Rmin_r d e).
    destruct (Q (by_distance q R0)) with (q := q) (u := u) as (i & Hi & G).
    + intros i _. apply by_distance_simple.
    + apply K; [|exact Q2]. intros i Hi. specialize (Q1 i Hi). lra.
    + exists q. intros i j _ _. reflexivity.
    + intros i Hi. specialize (Q1 i Hi). lra.
    + specialize (Q3 i Hi). lra.
Qed.
(* and the other way round *)
Theorem law_is_limit q : occurs n R0 r (by_distance q R0) -> limit_of_law n V' R0 r v (law4 n (by_distance q R0) V' r v).
Proof.
  intros O e He. destruct (law4_near (by_distance q R0) e ltac:(intros i _; apply by_distance_simple) He) as (d & Hd & L).
  destruct (O (Rmin d e) ltac:(now apply Rmin_glb_lt)) as (p & P1 & P2 & P3). pose proof (Rmin_l d e). pose proof (Rmin_r d e). exists p, v.
  assert (Zv : forall i, Cmod (v i - v i)%C = 0) by (intros i; replace (v i - v i)%C with (RtoC 0) by ring; apply Cmod_0).
  split; [intros i Hi; specialize (P1 i Hi); rewrite Zv; lra|]. split; [exact P2|]. intros i Hi.
  rewrite <- (law4_pairs n (by_distance q R0) (by_distance p R0) V' p v i P3 Hi). apply L; [|exact Hi]. intros k Hk. specialize (P1 k Hk). rewrite Zv. lra.
Qed.
End Near.

(* ---- states without a pair at R are everywhere: spreading a state a little leaves R, and links the pairs that are nearer than R and no others ---- *)
Lemma spread_generic n (r : nat -> C) R0 : 0 < R0 -> (forall i j, (i < n)%nat -> (j < n)%nat -> i <> j -> r i <> r j) -> forall e, 0 < e ->
  exists q : nat -> C, (forall i, (i < n)%nat -> Cmod (q i - r i)%C < e) /\ generic n R0 q /\ same_pairs n (by_distance r R0) (by_distance q R0).
Proof.
  intros HR A e He.
  destruct (small2 n (fun i j h => i <> j -> forall k, 0 < k < h -> (Cmod (r i - r j)%C < R0 -> (1 + k) * Cmod (r i - r j)%C < R0))) as (h1 & Hh1 & K).
  - intros i j d d' Q L Ne k Hk. apply Q; [exact Ne|lra].
  - intros i j Hi Hj. destruct (Nat.eq_dec i j) as [->|Ne]; [exists 1; split; [lra|congruence]|].
    assert (Pm : 0 < Cmod (r i - r j)%C) by (apply (norm_neq (r i) (r j)); now apply A). destruct (Rlt_or_le (Cmod (r i - r j)%C) R0) as [L|L].
    + set (h := (R0 - Cmod (r i - r j)%C) / Cmod (r i - r j)%C). assert (H1 : 0 < h) by (apply Rdiv_lt_0_compat; lra).
      exists h. split; [exact H1|]. intros _ k Hk _.
      assert (k * Cmod (r i - r j)%C < h * Cmod (r i - r j)%C) by (apply Rmult_lt_compat_r; lra). assert (h * Cmod (r i - r j)%C = R0 - Cmod (r i - r j)%C) by (unfold h; field; lra). lra.
    + exists 1. split; [lra|]. intros _ k Hk. lra.
  - destruct (small n (fun i h => forall k, 0 < k < h -> k * Cmod (r i) < e)) as (h2 & Hh2 & K2).
    { intros i d d' Q L k Hk. apply Q. lra. }
    { intros i Hi. pose proof (Cmod_ge_0 (r i)) as P0. exists (e / (Cmod (r i) + 1)). split; [apply Rdiv_lt_0_compat; lra|]. intros k Hk.
      apply Rle_lt_trans with (k * (Cmod (r i) + 1)); [apply Rmult_le_compat_l; lra|]. apply Rlt_le_trans with (e / (Cmod (r i) + 1) * (Cmod (r i) + 1)); [apply Rmult_lt_compat_r; lra|].
      right. field. lra. }
    set (h := Rmin h1 h2). assert (Hh : 0 < h) by now apply Rmin_glb_lt. assert (h <= h1) by apply Rmin_l. assert (h <= h2) by apply Rmin_r.
    set (k := h / 2). assert (Hk : 0 < k < h) by (unfold k; lra). exists (fun i => RtoC (1 + k) * r i)%C.
    assert (Dist : forall i j, Cmod (RtoC (1 + k) * r i - RtoC (1 + k) * r j)%C = (1 + k) * Cmod (r i - r j)%C).
    { intros i j. replace (RtoC (1 + k) * r i - RtoC (1 + k) * r j)%C with (RtoC (1 + k) * (r i - r j))%C by ring. rewrite Cmod_mult, Cmod_R, Rabs_pos_eq by lra. reflexivity. }
    split; [|split].
    + intros i Hi. replace (RtoC (1 + k) * r i - r i)%C with (RtoC k * r i)%C by (rewrite RtoC_plus; ring). rewrite Cmod_mult, Cmod_R, Rabs_pos_eq by lra. apply K2; [exact Hi|lra].
    + intros i j Hi Hj Ne. rewrite Dist. pose proof (K i j Hi Hj Ne k ltac:(lra)) as B. assert (Pm : 0 < Cmod (r i - r j)%C) by (apply (norm_neq (r i) (r j)); now apply A).
      destruct (Rlt_or_le (Cmod (r i - r j)%C) R0) as [L|L]; [specialize (B L); lra|]. assert (0 < k * Cmod (r i - r j)%C) by (apply Rmult_lt_0_compat; lra). lra.
    + intros i j Hi Hj. unfold by_distance. destruct (Nat.eqb_spec i j) as [|Ne]; [reflexivity|]. cbn [negb andb]. rewrite Dist. pose proof (K i j Hi Hj Ne k ltac:(lra)) as B.
      assert (Pm : 0 < Cmod (r i - r j)%C) by (apply (norm_neq (r i) (r j)); now apply A). assert (0 < k * Cmod (r i - r j)%C) by (apply Rmult_lt_0_compat; lra).
      destruct (Rlt_dec (Cmod (r i - r j)%C) R0) as [L|L], (Rlt_dec ((1 + k) * Cmod (r i - r j)%C) R0) as [G|G]; try reflexivity; [specialize (B L); lra|lra].
Qed.
