(* Tanner, Jadbabaie, Pappas, Part II, fixed graph: from every start in which no linked agents coincide there is a motion under (4) for all t >= 0,
   and every motion until a time T goes on for all t >= 0 (potentials of Definition 3 with a continuous derivative).
     tanner2.thm1a, beyond.tanner2.thm1c, beyond.tanner2.cor1. *)
From Coq Require Import Reals Lra Lia Psatz Classical.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums inclusions paley_model paley_phase paley_laplacian paley_gradient paley_particles tanner_energy tanner_flock tanner2_motion tanner_trees.
From Flockproof Require tanner2_filippov.
Open Scope R_scope.

(* ---- continuous functions of a state of m numbers ---- *)
Definition cont m (g : (nat -> R) -> R) (x : nat -> R) := forall e, 0 < e -> exists d, 0 < d /\ forall y, near m d y x -> Rabs (g y - g x) < e.
Lemma cont_at m f x : (forall k, (k < m)%nat -> cont m (fun y => f y k) x) -> continuous_at m f x.
Proof.
  intros H e He. destruct (tanner2_filippov.small m (fun k d => forall y, near m d y x -> Rabs (f y k - f x k) < e)) as (d & Hd & K).
  - intros k d d' Q L y Ny. apply Q. intros i Hi. specialize (Ny i Hi). lra.
  - intros k Hk. exact (H k Hk e He).
  - exists d. split; [exact Hd|]. intros y Ny i Hi. now apply (K i Hi).
Qed.
Lemma cont_const m c x : cont m (fun _ => c) x.
Proof. intros e He. exists 1. split; [lra|]. intros y _. rewrite Rminus_eq_0, Rabs_R0. exact He. Qed.
Lemma cont_coord m k x : (k < m)%nat -> cont m (fun y => y k) x.
Proof. intros Hk e He. exists e. split; [exact He|]. intros y Ny. now apply Ny. Qed.
Lemma near_less m d d' x y : d <= d' -> near m d x y -> near m d' x y.
Proof. intros L N i Hi. specialize (N i Hi). lra. Qed.
Lemma cont_plus m f g x : cont m f x -> cont m g x -> cont m (fun y => f y + g y) x.
Proof.
  intros A B e He. destruct (A (e / 2) ltac:(lra)) as (d & Hd & P). destruct (B (e / 2) ltac:(lra)) as (d' & Hd' & Q).
  exists (Rmin d d'). split; [now apply Rmin_glb_lt|]. intros y Ny. specialize (P y (near_less m _ _ _ _ (Rmin_l d d') Ny)). specialize (Q y (near_less m _ _ _ _ (Rmin_r d d') Ny)).
  replace (f y + g y - (f x + g x)) with (f y - f x + (g y - g x)) by ring. eapply Rle_lt_trans; [apply Rabs_triang|]. lra.
Qed.
Lemma cont_comp m (h : R -> R) g x : continuity_pt h (g x) -> cont m g x -> cont m (fun y => h (g y)) x.
Proof.
  intros A B e He. destruct (A e He) as (d & Hd & P). destruct (B d Hd) as (d' & Hd' & Q). exists d'. split; [exact Hd'|]. intros y Ny.
  destruct (Req_dec (g y) (g x)) as [->|N]; [rewrite Rminus_eq_0, Rabs_R0; exact He|]. apply P. split; [split; [exact I|congruence]|]. now apply Q.
Qed.
Lemma cont_scal m c g x : cont m g x -> cont m (fun y => c * g y) x.
Proof. intros A. apply (cont_comp m (fun s => c * s) g x); [|exact A]. apply continuity_pt_scal, derivable_continuous_pt, derivable_pt_id. Qed.
Lemma cont_ext m f g x : (forall y, f y = g y) -> cont m f x -> cont m g x.
Proof. intros E A e He. destruct (A e He) as (d & Hd & P). exists d. split; [exact Hd|]. intros y Ny. rewrite <- !E. now apply P. Qed.
Lemma cont_minus m f g x : cont m f x -> cont m g x -> cont m (fun y => f y - g y) x.
Proof. intros A B. apply (cont_ext m (fun y => f y + (-1) * g y)); [intros; ring|]. apply cont_plus; [exact A|now apply cont_scal]. Qed.
Lemma cont_sqr m g x : cont m g x -> cont m (fun y => g y ^ 2) x.
Proof. intros A. apply (cont_comp m (fun s => s ^ 2) g x); [|exact A]. apply derivable_continuous_pt, derivable_pt_pow. Qed.
Lemma cont_mult m f g x : cont m f x -> cont m g x -> cont m (fun y => f y * g y) x.
Proof.
  intros A B. apply (cont_ext m (fun y => / 4 * ((f y + g y) ^ 2 - (f y - g y) ^ 2))); [intros; field|].
  apply cont_scal, cont_minus; apply cont_sqr; [now apply cont_plus|now apply cont_minus].
Qed.
Lemma cont_Sum m n (f : nat -> (nat -> R) -> R) x : (forall j, (j < n)%nat -> cont m (f j) x) -> cont m (fun y => Sum n (fun j => f j y)) x.
Proof.
  intros H. induction n as [|n IH]; cbn [Sum]; [apply cont_const|]. apply cont_plus; [apply IH; intros; apply H; lia|apply H; lia].
Qed.
Lemma lipschitz_continuous (h : R -> R) s : (forall a b, Rabs (h a - h b) <= Rabs (a - b)) -> continuity_pt h s.
Proof. intros H e He. exists e. split; [exact He|]. intros t [_ Ht]. cbn in *. unfold R_dist in *. specialize (H t s). lra. Qed.

(* ---- cut off ---- *)
Definition cut S a := Rmax (- S) (Rmin S a).
Lemma cut_in S a : 0 <= S -> Rabs (cut S a) <= S.
Proof. intros H. unfold cut, Rmax, Rmin. destruct (Rle_dec S a); destruct (Rle_dec _ _); apply Rabs_le; lra. Qed.
Lemma cut_gap S a b : Rabs (cut S a - cut S b) <= Rabs (a - b).
Proof. unfold cut, Rmax, Rmin, Rabs. destruct (Rle_dec S a), (Rle_dec S b); repeat destruct (Rle_dec _ _); repeat destruct (Rcase_abs _); lra. Qed.
Lemma cut_id S a : Rabs a <= S -> cut S a = a.
Proof. intros H. apply Rabs_le_between in H. unfold cut, Rmax, Rmin. destruct (Rle_dec S a); destruct (Rle_dec _ _); lra. Qed.
Lemma cut_bound S a b : Rabs (cut S a - cut S b) <= 2 * Rabs S.
Proof. unfold cut, Rmax, Rmin, Rabs. destruct (Rle_dec S a), (Rle_dec S b); repeat destruct (Rle_dec _ _); repeat destruct (Rcase_abs _); lra. Qed.
Definition between d D s := Rmax d (Rmin s D).
Lemma between_in d D s : d <= D -> d <= between d D s <= D.
Proof. intros H. unfold between, Rmax, Rmin. destruct (Rle_dec s D); destruct (Rle_dec _ _); lra. Qed.
Lemma between_gap d D s t : Rabs (between d D s - between d D t) <= Rabs (s - t).
Proof. unfold between, Rmax, Rmin, Rabs. destruct (Rle_dec s D), (Rle_dec t D); repeat destruct (Rle_dec _ _); repeat destruct (Rcase_abs _); lra. Qed.
Lemma between_id d D s : d <= s <= D -> between d D s = s.
Proof. intros H. unfold between, Rmax, Rmin. destruct (Rle_dec s D); destruct (Rle_dec _ _); lra. Qed.
Lemma max_gap d s t : Rabs (Rmax s d - Rmax t d) <= Rabs (s - t).
Proof. unfold Rmax, Rabs. destruct (Rle_dec s d), (Rle_dec t d); repeat destruct (Rcase_abs _); lra. Qed.

Section Field.
Variables (n : nat) (adj : graph) (V' : nat -> nat -> R -> R) (d D S : R).
Hypothesis Hd : 0 < d < D.
Hypothesis HS : 0 <= S.
Hypothesis C1 : forall i j s, (i < n)%nat -> (j < n)%nat -> adj i j = true -> 0 < s -> continuity_pt (V' i j) s.
(* the state: positions, then velocities, each coordinate after the other *)
Definition place (y : nat -> R) (i : nat) : C := (y i, y (n + i)%nat).
Definition speed (y : nat -> R) (i : nat) : C := (y (2 * n + i)%nat, y (3 * n + i)%nat).
Definition strength i j s := if adj i j then V' i j (between d D s) / Rmax s d else 0.
Definition acc_fst y i := - Sum n (fun j => w adj i j * (cut S (fst (speed y i)) - cut S (fst (speed y j)))) -
  Sum n (fun j => strength i j (norm (place y i - place y j)%C) * (fst (place y i) - fst (place y j))).
Definition acc_snd y i := - Sum n (fun j => w adj i j * (cut S (snd (speed y i)) - cut S (snd (speed y j)))) -
  Sum n (fun j => strength i j (norm (place y i - place y j)%C) * (snd (place y i) - snd (place y j))).
Definition field (y : nat -> R) (k : nat) : R :=
  if Nat.ltb k n then cut S (fst (speed y k)) else if Nat.ltb k (2 * n) then cut S (snd (speed y (k - n)))
  else if Nat.ltb k (3 * n) then acc_fst y (k - 2 * n) else acc_snd y (k - 3 * n).
Lemma strength_continuous i j s : (i < n)%nat -> (j < n)%nat -> continuity_pt (strength i j) s.
Proof.
  intros Hi Hj. unfold strength. destruct (adj i j) eqn:A; [|apply derivable_continuous_pt, derivable_pt_const].
  pose proof (between_in d D s ltac:(lra)) as B. apply (continuity_pt_div (fun s => V' i j (between d D s)) (fun s => Rmax s d)).
  - apply (continuity_pt_comp (between d D) (V' i j)); [apply lipschitz_continuous, between_gap|]. apply C1; try assumption; lra.
  - apply lipschitz_continuous. intros. apply max_gap.
  - pose proof (Rmax_r s d). lra.
Qed.
Lemma strength_bounded i j : (i < n)%nat -> (j < n)%nat -> exists b, forall z : C, Rabs (strength i j (norm z) * fst z) <= b /\ Rabs (strength i j (norm z) * snd z) <= b.
Proof.
  intros Hi Hj. destruct (adj i j) eqn:A.
  2:{ exists 0. intros z. unfold strength. rewrite A, !Rmult_0_l, Rabs_R0. lra. }
  destruct (continuity_ab_maj (fun s => Rabs (V' i j s)) d D ltac:(lra)) as (m & Hm & _).
  { intros s Hs. apply (continuity_pt_comp (V' i j) Rabs); [apply C1; try assumption; lra|apply Rcontinuity_abs]. }
  exists (Rabs (V' i j m)). intros z. unfold strength. rewrite A. pose proof (Hm _ (between_in d D (norm z) ltac:(lra))) as B. cbv beta in B.
  pose proof (Rmax_l (norm z) d) as M1. pose proof (Rmax_r (norm z) d) as M2. pose proof (Rabs_pos (V' i j m)).
  assert (Q : forall a, Rabs a <= norm z -> Rabs (V' i j (between d D (norm z)) / Rmax (norm z) d * a) <= Rabs (V' i j m)).
  { intros a Ha. unfold Rdiv. rewrite Rmult_assoc, Rabs_mult. rewrite <- (Rmult_1_r (Rabs (V' i j m))). apply Rmult_le_compat; [apply Rabs_pos|apply Rabs_pos|exact B|].
    rewrite Rabs_mult, (Rabs_pos_eq (/ _)) by (left; apply Rinv_0_lt_compat; lra). apply Rmult_le_reg_l with (Rmax (norm z) d); [lra|].
    rewrite <- Rmult_assoc, Rinv_r by lra. lra. }
  split; apply Q; [apply fst_le|apply snd_le].
Qed.
Lemma cont_norm y i j : (i < n)%nat -> (j < n)%nat -> cont (4 * n) (fun y => norm (place y i - place y j)%C) y.
Proof.
  intros Hi Hj. apply (cont_ext _ (fun y => sqrt ((y i - y j) ^ 2 + (y (n + i)%nat - y (n + j)%nat) ^ 2))); [reflexivity|].
  apply (cont_comp _ sqrt (fun y => (y i - y j) ^ 2 + (y (n + i)%nat - y (n + j)%nat) ^ 2)).
  - apply continuity_pt_sqrt. pose proof (pow2_ge_0 (y i - y j)). pose proof (pow2_ge_0 (y (n + i)%nat - y (n + j)%nat)). lra.
  - apply cont_plus; apply cont_sqr, cont_minus; apply cont_coord; lia.
Qed.
Lemma field_continuous y : continuous_at (4 * n) field y.
Proof.
  assert (K : forall k, (k < 4 * n)%nat -> cont (4 * n) (fun y => cut S (y k)) y).
  { intros k Hk. apply (cont_comp _ (cut S) (fun y => y k)); [apply lipschitz_continuous, cut_gap|now apply cont_coord]. }
  assert (G : forall i c, (i < n)%nat -> (forall j, (j < n)%nat -> (c + j < 4 * n)%nat) -> cont (4 * n) (fun y => Sum n (fun j => w adj i j * (cut S (y (c + i)%nat) - cut S (y (c + j)%nat)))) y).
  { intros i c Hi Hc. apply (cont_Sum _ n (fun j y => w adj i j * (cut S (y (c + i)%nat) - cut S (y (c + j)%nat)))). intros j Hj. apply cont_scal, cont_minus; apply K; now apply Hc. }
  assert (P : forall i c, (i < n)%nat -> (forall j, (j < n)%nat -> (c + j < 4 * n)%nat) ->
    cont (4 * n) (fun y => Sum n (fun j => strength i j (norm (place y i - place y j)%C) * (y (c + i)%nat - y (c + j)%nat))) y).
  { intros i c Hi Hc. apply (cont_Sum _ n (fun j y => strength i j (norm (place y i - place y j)%C) * (y (c + i)%nat - y (c + j)%nat))). intros j Hj. apply cont_mult.
    - apply (cont_comp _ (strength i j) (fun y => norm (place y i - place y j)%C)); [now apply strength_continuous|now apply cont_norm].
    - apply cont_minus; apply cont_coord; now apply Hc. }
  apply cont_at. intros k Hk. unfold field. destruct (Nat.ltb_spec k n); [apply K; lia|]. destruct (Nat.ltb_spec k (2 * n)); [apply K; lia|].
  destruct (Nat.ltb_spec k (3 * n)).
  - apply (cont_ext _ (fun y => -1 * Sum n (fun j => w adj (k - 2 * n) j * (cut S (y (2 * n + (k - 2 * n))%nat) - cut S (y (2 * n + j)%nat))) -
      Sum n (fun j => strength (k - 2 * n) j (norm (place y (k - 2 * n) - place y j)%C) * (y (0 + (k - 2 * n))%nat - y (0 + j)%nat)))); [intros; unfold acc_fst, place, speed; cbn [fst snd Nat.add]; ring|].
    apply cont_minus; [apply cont_scal, G; [lia|intros; lia]|apply P; [lia|intros; lia]].
  - apply (cont_ext _ (fun y => -1 * Sum n (fun j => w adj (k - 3 * n) j * (cut S (y (3 * n + (k - 3 * n))%nat) - cut S (y (3 * n + j)%nat))) -
      Sum n (fun j => strength (k - 3 * n) j (norm (place y (k - 3 * n) - place y j)%C) * (y (n + (k - 3 * n))%nat - y (n + j)%nat)))); [intros; unfold acc_snd, place, speed; cbn [fst snd]; ring|].
    apply cont_minus; [apply cont_scal, G; [lia|intros; lia]|apply P; [lia|intros; lia]].
Qed.
Lemma field_bounded : exists M, forall y k, (k < 4 * n)%nat -> Rabs (field y k) <= M.
Proof.
  destruct (uniform_pairs n (fun i j b => forall z : C, Rabs (strength i j (norm z) * fst z) <= b /\ Rabs (strength i j (norm z) * snd z) <= b)) as (b & Hb & U).
  - intros i j b b' Q L z. specialize (Q z). lra.
  - intros i j Hi Hj. now apply strength_bounded.
  - assert (G : forall i (f : nat -> R), (i < n)%nat -> Rabs (Sum n (fun j => w adj i j * (cut S (f i) - cut S (f j)))) <= INR n * (2 * Rabs S)).
    { intros i f Hi. eapply Rle_trans; [apply Sum_Rabs|]. rewrite <- Sum_const. apply Sum_le. intros j Hj. unfold w. pose proof (cut_bound S (f i) (f j)).
      destruct (adj i j); [now rewrite Rmult_1_l|]. rewrite Rmult_0_l, Rabs_R0. pose proof (Rabs_pos S). lra. }
    exists (INR n * (2 * Rabs S) + INR n * b + S). intros y k Hk. pose proof (pos_INR n). pose proof (Rabs_pos S).
    assert (0 <= INR n * (2 * Rabs S)) by (apply Rmult_le_pos; lra). assert (0 <= INR n * b) by (apply Rmult_le_pos; lra). unfold field.
    destruct (Nat.ltb_spec k n); [pose proof (cut_in S (fst (speed y k)) HS); lra|]. destruct (Nat.ltb_spec k (2 * n)); [pose proof (cut_in S (snd (speed y (k - n))) HS); lra|].
    assert (T : forall a c, Rabs a <= INR n * (2 * Rabs S) -> Rabs c <= INR n * b -> Rabs (- a - c) <= INR n * (2 * Rabs S) + INR n * b + S).
    { intros a c Ha Hc. unfold Rminus. eapply Rle_trans; [apply Rabs_triang|]. rewrite !Rabs_Ropp. lra. }
    destruct (Nat.ltb_spec k (3 * n)); apply T.
    + apply (G (k - 2 * n)%nat (fun j => fst (speed y j))). lia.
    + eapply Rle_trans; [apply Sum_Rabs|]. rewrite <- Sum_const. apply Sum_le. intros j Hj. apply (U (k - 2 * n)%nat j ltac:(lia) Hj (place y (k - 2 * n) - place y j)%C).
    + apply (G (k - 3 * n)%nat (fun j => snd (speed y j))). lia.
    + eapply Rle_trans; [apply Sum_Rabs|]. rewrite <- Sum_const. apply Sum_le. intros j Hj. apply (U (k - 3 * n)%nat j ltac:(lia) Hj (place y (k - 3 * n) - place y j)%C).
Qed.
(* where speeds and distances of linked agents are within the bounds it is the law *)
Lemma field_law y : (forall i, (i < n)%nat -> norm (speed y i) <= S) ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> d <= norm (place y i - place y j)%C <= D) ->
  forall i, (i < n)%nat -> (field y i, field y (n + i)%nat) = speed y i /\ (field y (2 * n + i)%nat, field y (3 * n + i)%nat) = control4 n adj V' (place y) (speed y) i.
Proof.
  intros B1 B2 i Hi. assert (F : forall j, (j < n)%nat -> cut S (fst (speed y j)) = fst (speed y j) /\ cut S (snd (speed y j)) = snd (speed y j)).
  { intros j Hj. specialize (B1 j Hj). pose proof (fst_le (speed y j)). pose proof (snd_le (speed y j)). split; apply cut_id; lra. }
  unfold field. destruct (Nat.ltb_spec i n); [|lia]. destruct (Nat.ltb_spec (n + i) n); [lia|]. destruct (Nat.ltb_spec (n + i) (2 * n)); [|lia].
  destruct (Nat.ltb_spec (2 * n + i) n); [lia|]. destruct (Nat.ltb_spec (2 * n + i) (2 * n)); [lia|]. destruct (Nat.ltb_spec (2 * n + i) (3 * n)); [|lia].
  destruct (Nat.ltb_spec (3 * n + i) n); [lia|]. destruct (Nat.ltb_spec (3 * n + i) (2 * n)); [lia|]. destruct (Nat.ltb_spec (3 * n + i) (3 * n)); [lia|].
  replace (n + i - n)%nat with i by lia. replace (2 * n + i - 2 * n)%nat with i by lia. replace (3 * n + i - 3 * n)%nat with i by lia.
  destruct (F i Hi) as [F1 F2]. split; [rewrite F1, F2; now destruct (speed y i)|].
  assert (T : forall j, (j < n)%nat -> pair_grad adj V' (place y) i j = (strength i j (norm (place y i - place y j)%C) * (fst (place y i) - fst (place y j)),
    strength i j (norm (place y i - place y j)%C) * (snd (place y i) - snd (place y j)))).
  { intros j Hj. unfold pair_grad, grad, strength, w. destruct (adj i j) eqn:A.
    - destruct (B2 i j Hi Hj A) as [B3 B4]. rewrite between_id by lra. rewrite Rmax_left by lra. apply injective_projections; cbn; ring.
    - apply injective_projections; cbn; ring. }
  unfold control4, grad_i, acc_fst, acc_snd, Csum. apply injective_projections; cbn [fst snd Cminus Cplus Copp]; unfold Rminus; f_equal; f_equal; apply Sum_ext; intros j Hj;
    rewrite ?(proj1 (F i Hi)), ?(proj2 (F i Hi)), ?(proj1 (F j Hj)), ?(proj2 (F j Hj)), ?(T j Hj); cbn; ring.
Qed.
End Field.

Lemma control4_ext n adj V' r r' v v' i : (i < n)%nat -> (forall j, (j < n)%nat -> r j = r' j) -> (forall j, (j < n)%nat -> v j = v' j) ->
  control4 n adj V' r v i = control4 n adj V' r' v' i.
Proof.
  intros Hi R1 V1. unfold control4, grad_i, pair_grad. f_equal; [f_equal|]; apply Csum_ext; intros j Hj; now rewrite ?(R1 i Hi), ?(R1 j Hj), ?(V1 i Hi), ?(V1 j Hj).
Qed.
Lemma Wenergy_ext n adj V r r' v v' : (forall j, (j < n)%nat -> r j = r' j) -> (forall j, (j < n)%nat -> v j = v' j) -> Wenergy n adj V r v = Wenergy n adj V r' v'.
Proof.
  intros R1 V1. unfold Wenergy, V_i. f_equal. apply Sum_ext. intros i Hi. rewrite (V1 i Hi). f_equal. apply Sum_ext. intros j Hj. now rewrite (R1 i Hi), (R1 j Hj).
Qed.

Section Lasting.
Variables (n : nat) (adj : graph) (V V' : nat -> nat -> R -> R).
Hypothesis S : undirected adj.
Hypothesis NL : no_loops adj.
Hypothesis VS : forall i j, V i j = V j i.
Hypothesis VS' : forall i j, V' i j = V' j i.
Hypothesis Pot : forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> potential (V i j) (V' i j).
Hypothesis C1 : forall i j s, (i < n)%nat -> (j < n)%nat -> adj i j = true -> 0 < s -> continuity_pt (V' i j) s.
Definition joined (r v : nat -> R -> C) (t : R) (k : nat) : R := if Nat.ltb k n then fst (r k t) else if Nat.ltb k (2 * n) then snd (r (k - n)%nat t)
  else if Nat.ltb k (3 * n) then fst (v (k - 2 * n)%nat t) else snd (v (k - 3 * n)%nat t).
Lemma joined_parts r v t i : (i < n)%nat -> place n (joined r v t) i = r i t /\ speed n (joined r v t) i = v i t.
Proof.
  intros Hi. unfold place, speed, joined. destruct (Nat.ltb_spec i n); [|lia]. destruct (Nat.ltb_spec (n + i) n); [lia|]. destruct (Nat.ltb_spec (n + i) (2 * n)); [|lia].
  destruct (Nat.ltb_spec (2 * n + i) n); [lia|]. destruct (Nat.ltb_spec (2 * n + i) (2 * n)); [lia|]. destruct (Nat.ltb_spec (2 * n + i) (3 * n)); [|lia].
  destruct (Nat.ltb_spec (3 * n + i) n); [lia|]. destruct (Nat.ltb_spec (3 * n + i) (2 * n)); [lia|]. destruct (Nat.ltb_spec (3 * n + i) (3 * n)); [lia|].
  replace (n + i - n)%nat with i by lia. replace (2 * n + i - 2 * n)%nat with i by lia. replace (3 * n + i - 3 * n)%nat with i by lia.
  destruct (r i t), (v i t). now split.
Qed.
Lemma velocity_near (r : R -> C) t a e : is_velocity r t a -> 0 < e -> exists h, 0 < h /\ forall u, Rabs (u - t) < h -> norm (r u - r t)%C < e.
Proof.
  intros [A B] He. apply is_derive_Reals in A, B.
  assert (CA : continuity_pt (fun s => fst (r s)) t) by (apply derivable_continuous_pt; eexists; exact A).
  assert (CB : continuity_pt (fun s => snd (r s)) t) by (apply derivable_continuous_pt; eexists; exact B).
  destruct (CA (e / 2) ltac:(lra)) as (h & Hh & P). destruct (CB (e / 2) ltac:(lra)) as (k & Hk & Q).
  exists (Rmin h k). split; [now apply Rmin_glb_lt|]. intros u Hu. pose proof (Rmin_l h k). pose proof (Rmin_r h k).
  destruct (Req_dec u t) as [->|N]; [replace (r t - r t)%C with (RtoC 0) by ring; unfold norm; rewrite Cmod_0; exact He|].
  assert (P' : Rabs (fst (r u) - fst (r t)) < e / 2) by (apply P; split; [split; [exact I|congruence]|cbn; unfold R_dist; lra]).
  assert (Q' : Rabs (snd (r u) - snd (r t)) < e / 2) by (apply Q; split; [split; [exact I|congruence]|cbn; unfold R_dist; lra]).
  pose proof (norm_le_sum (r u - r t)%C) as T. cbn in T. unfold Rminus in *. lra.
Qed.
(* bounds that the energy of a start allows *)
Lemma bounds_of c : exists d D, 0 < d < D /\ forall r v, distinct n adj r -> Wenergy n adj V r v <= c ->
  (forall i, (i < n)%nat -> norm (v i) <= sqrt (2 * c)) /\ forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> d <= norm (r i - r j)%C <= D.
Proof.
  destruct (linked_distances n adj V V' c S NL VS Pot) as (d & D & Hd & L). exists d, (Rmax D (d + 1)). pose proof (Rmax_l D (d + 1)). pose proof (Rmax_r D (d + 1)).
  split; [lra|]. intros r v A E. split.
  - intros i Hi. exact (speed_bound_norm n adj V V' Pot r v A i c Hi E).
  - intros i j Hi Hj Lk. destruct (L r v A E i j Hi Hj Lk). lra.
Qed.
(* a solution for the field that is cut off beyond the bounds never meets them *)
Lemma field_moves d D c (y : R -> nat -> R) : 0 < d < D -> (forall r v, distinct n adj r -> Wenergy n adj V r v <= c ->
    (forall i, (i < n)%nat -> norm (v i) <= sqrt (2 * c)) /\ forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> d <= norm (r i - r j)%C <= D) ->
  distinct n adj (place n (y 0)) -> Wenergy n adj V (place n (y 0)) (speed n (y 0)) <= c ->
  (forall t k, 0 <= t -> (k < 4 * n)%nat -> is_derive (fun s => y s k) t (field n adj V' (d / 2) (D + d) (sqrt (2 * c) + 1) (y t) k)) ->
  forall t, 0 <= t -> moves n adj V' (fun i s => place n (y s) i) (fun i s => speed n (y s) i) t.
Proof.
  intros Hd Bd A0 E0 Sol. set (r := fun i s => place n (y s) i). set (v := fun i s => speed n (y s) i).
  set (inside := fun t => (forall i, (i < n)%nat -> norm (v i t) <= sqrt (2 * c) + 1) /\
    forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> d / 2 <= norm (r i t - r j t)%C <= D + d).
  set (sharp := fun t => (forall i, (i < n)%nat -> norm (v i t) <= sqrt (2 * c)) /\
    forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> d <= norm (r i t - r j t)%C <= D).
  assert (Vel : forall t i, 0 <= t -> (i < n)%nat -> exists a b, is_velocity (r i) t a /\ is_velocity (v i) t b).
  { intros t i Ht Hi. set (f := field n adj V' (d / 2) (D + d) (sqrt (2 * c) + 1) (y t)). exists (f i, f (n + i)%nat), (f (2 * n + i)%nat, f (3 * n + i)%nat).
    split; split; cbn [fst snd r v place speed]; apply Sol; try assumption; lia. }
  assert (Mv : forall t, 0 <= t -> inside t -> moves n adj V' r v t).
  { intros t Ht [I1 I2].
    assert (FL := field_law n adj V' (d / 2) (D + d) (sqrt (2 * c) + 1) (y t) I1 I2). split.
    - intros i Hi. destruct (FL i Hi) as [Q _]. change (v i t) with (speed n (y t) i). rewrite <- Q. split; cbn [fst snd r place]; apply Sol; try assumption; lia.
    - intros _ i Hi. destruct (FL i Hi) as [_ Q]. change (is_velocity (v i) t (control4 n adj V' (place n (y t)) (speed n (y t)) i)). rewrite <- Q.
      split; cbn [fst snd v speed]; apply Sol; try assumption; lia. }
  assert (Ds : forall t, inside t -> distinct n adj (fun i => r i t)).
  { intros t [_ I2] i j Hi Hj A E. destruct (I2 i j Hi Hj A) as [Q _]. rewrite E in Q. replace (r j t - r j t)%C with (RtoC 0) in Q by ring. unfold norm in Q. rewrite Cmod_0 in Q. lra. }
  (* near a time everything is near *)
  assert (Near : forall t e, 0 <= t -> 0 < e -> exists h, 0 < h /\ forall u, Rabs (u - t) < h -> forall i, (i < n)%nat -> norm (r i u - r i t)%C < e /\ norm (v i u - v i t)%C < e).
  { intros t e Ht He. destruct (tanner2_filippov.small n (fun i h => forall u, Rabs (u - t) < h -> norm (r i u - r i t)%C < e /\ norm (v i u - v i t)%C < e)) as (h & Hh & K).
    - intros i h h' Q L u Hu. apply Q. lra.
    - intros i Hi. destruct (Vel t i Ht Hi) as (a & b & Va & Vb). destruct (velocity_near (r i) t a e Va He) as (h & Hh & P). destruct (velocity_near (v i) t b e Vb He) as (k & Hk & Q).
      exists (Rmin h k). split; [now apply Rmin_glb_lt|]. intros u Hu. pose proof (Rmin_l h k). pose proof (Rmin_r h k). split; [apply P|apply Q]; lra.
    - exists h. split; [exact Hh|]. intros u Hu i Hi. now apply K. }
  assert (Tri : forall (a b x y : C), norm (a - b)%C <= norm (x - y)%C + norm (a - x)%C + norm (b - y)%C).
  { intros a b x z. replace (a - b)%C with ((x - z) + (a - x) + (z - b))%C by ring. eapply Rle_trans; [apply norm_triangle|]. rewrite (norm_sym b z).
    apply Rplus_le_compat_r, norm_triangle. }
  assert (Tri1 : forall a x : C, norm a <= norm x + norm (a - x)%C) by (intros a x; replace a with (x + (a - x))%C at 1 by ring; apply norm_triangle).
  assert (Open : forall t, 0 <= t -> sharp t -> exists h, 0 < h /\ forall u, Rabs (u - t) < h -> inside u).
  { intros t Ht [P1 P2]. destruct (Near t (Rmin 1 (d / 4)) Ht ltac:(apply Rmin_glb_lt; lra)) as (h & Hh & K). pose proof (Rmin_l 1 (d / 4)). pose proof (Rmin_r 1 (d / 4)).
    exists h. split; [exact Hh|]. intros u Hu. specialize (K u Hu). split.
    - intros i Hi. specialize (P1 i Hi). destruct (K i Hi). pose proof (Tri1 (v i u) (v i t)). lra.
    - intros i j Hi Hj A. specialize (P2 i j Hi Hj A). destruct (K i Hi), (K j Hj). pose proof (Tri (r i u) (r j u) (r i t) (r j t)) as T1. pose proof (Tri (r i t) (r j t) (r i u) (r j u)) as T2.
      rewrite (norm_sym (r i t) (r i u)), (norm_sym (r j t) (r j u)) in T2. lra. }
  assert (En : forall t, 0 <= t -> (forall u, 0 <= u <= t -> inside u) -> sharp t).
  { intros t Ht H. apply (Bd (fun i => r i t) (fun i => v i t)); [apply Ds, H; lra|]. apply Rle_trans with (2 := E0).
    apply (energy_before n adj V V' r v S VS' Pot t Ht). intros s Hs. split; [apply Mv; [lra|now apply H]|now apply Ds, H]. }
  assert (All : forall t, 0 <= t -> forall u, 0 <= u <= t -> sharp u).
  { apply (real_induction (fun t => forall u, 0 <= u <= t -> sharp u)).
    - intros t Ht H u Hu. destruct (Rle_lt_or_eq_dec u t (proj2 Hu)) as [L| ->]; [apply (H u); lra|].
      destruct (Req_dec t 0) as [->|Nt]; [apply (Bd (fun i => r i 0) (fun i => v i 0)); assumption|].
      assert (Before : forall e, 0 < e -> exists s, 0 <= s < t /\ sharp s /\ forall i, (i < n)%nat -> norm (r i s - r i t)%C < e /\ norm (v i s - v i t)%C < e).
      { intros e He. destruct (Near t e Ht He) as (h & Hh & K). pose proof (Rmin_l (h / 2) (t / 2)). pose proof (Rmin_r (h / 2) (t / 2)).
        assert (0 < Rmin (h / 2) (t / 2)) by (apply Rmin_glb_lt; lra). exists (t - Rmin (h / 2) (t / 2)). split; [lra|]. split.
        - apply (H (t - Rmin (h / 2) (t / 2))); lra.
        - apply K, Rabs_def1; lra. }
      split.
      + intros i Hi. apply le_epsilon. intros e He. destruct (Before e He) as (s & Hs & [P _] & K). specialize (P i Hi). destruct (K i Hi) as [_ Q].
        pose proof (Tri1 (v i t) (v i s)) as T. rewrite (norm_sym (v i t) (v i s)) in T. lra.
      + intros i j Hi Hj A. assert (G : forall e, 0 < e -> d - e <= norm (r i t - r j t)%C <= D + e).
        { intros e He. destruct (Before (e / 2) ltac:(lra)) as (s & Hs & [_ P] & K). specialize (P i j Hi Hj A). destruct (K i Hi) as [Q1 _]. destruct (K j Hj) as [Q2 _].
          pose proof (Tri (r i s) (r j s) (r i t) (r j t)) as T1. pose proof (Tri (r i t) (r j t) (r i s) (r j s)) as T2.
          rewrite (norm_sym (r i t) (r i s)), (norm_sym (r j t) (r j s)) in T2. lra. }
        split; apply le_epsilon; intros e He; specialize (G e He); lra.
    - intros t Ht H. destruct (Open t Ht (H t ltac:(lra))) as (h & Hh & K). exists h. split; [exact Hh|]. intros u Hu s Hs.
      apply En; [lra|]. intros x Hx. destruct (Rle_or_lt x t) as [L|L]; [|apply K, Rabs_def1; lra].
      destruct (Open x ltac:(lra) (H x ltac:(lra))) as (k & Hk & K'). apply K'. rewrite Rminus_eq_0, Rabs_R0. exact Hk. }
  intros t Ht. apply Mv; [exact Ht|]. destruct (Open t Ht (All t Ht t ltac:(lra))) as (h & Hh & K). apply K. rewrite Rminus_eq_0, Rabs_R0. exact Hh.
Qed.
Theorem starts (r0 v0 : nat -> C) : distinct n adj r0 -> exists r v, (forall i, (i < n)%nat -> r i 0 = r0 i /\ v i 0 = v0 i) /\
  forall t, 0 <= t -> moves n adj V' r v t.
Proof.
  intros A0. set (c := Wenergy n adj V r0 v0). destruct (bounds_of c) as (d & D & Hd & Bd).
  destruct (field_bounded n adj V' (d / 2) (D + d) (sqrt (2 * c) + 1)) as [M HM]; [lra|pose proof (sqrt_pos (2 * c)); lra|exact C1|].
  destruct (peano (4 * n) (field n adj V' (d / 2) (D + d) (sqrt (2 * c) + 1)) M (joined (fun i _ => r0 i) (fun i _ => v0 i) 0)) as (y & Y0 & Y1).
  - intros x k Hk. now apply HM.
  - intros x. apply field_continuous; [lra|exact C1].
  - assert (P : forall i, (i < n)%nat -> place n (y 0) i = r0 i /\ speed n (y 0) i = v0 i).
    { intros i Hi. destruct (joined_parts (fun i _ => r0 i) (fun i _ => v0 i) 0 i Hi) as [J1 J2]. rewrite <- J1, <- J2. unfold place, speed. now rewrite !Y0 by lia. }
    exists (fun i s => place n (y s) i), (fun i s => speed n (y s) i). split; [exact P|].
    apply (field_moves d D c y Hd Bd); [| |intros; now apply Y1].
    + intros i j Hi Hj A. rewrite (proj1 (P i Hi)), (proj1 (P j Hj)). now apply A0.
    + right. unfold c. apply Wenergy_ext; intros i Hi; now apply P.
Qed.
(* a motion until T is the beginning of one for all t >= 0 *)
Theorem goes_on T (r v : nat -> R -> C) : 0 < T -> distinct n adj (fun i => r i 0) -> (forall t, 0 <= t < T -> moves n adj V' r v t) ->
  exists r' v', (forall t i, t < T -> (i < n)%nat -> r' i t = r i t /\ v' i t = v i t) /\ forall t, 0 <= t -> moves n adj V' r' v' t.
Proof.
  intros HT A0 Mv. set (c := Wenergy n adj V (fun i => r i 0) (fun i => v i 0)). destruct (bounds_of c) as (d & D & Hd & Bd).
  destruct (linked_apart n adj V V' r v S NL VS VS' Pot A0) as (d1 & Hd1 & Ap). specialize (Ap T Mv).
  assert (Ds : forall t, 0 <= t < T -> distinct n adj (fun i => r i t)).
  { intros t Ht i j Hi Hj A E. specialize (Ap t i j Ht Hi Hj A). rewrite E in Ap. replace (r j t - r j t)%C with (RtoC 0) in Ap by ring. unfold norm in Ap. rewrite Cmod_0 in Ap. lra. }
  assert (Bt : forall t, 0 <= t < T -> (forall i, (i < n)%nat -> norm (v i t) <= sqrt (2 * c)) /\ forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> d <= norm (r i t - r j t)%C <= D).
  { intros t Ht. apply (Bd (fun i => r i t) (fun i => v i t)); [now apply Ds|]. apply (energy_before n adj V V' r v S VS' Pot t); [lra|].
    intros s Hs. split; [apply Mv; lra|apply Ds; lra]. }
  destruct (field_bounded n adj V' (d / 2) (D + d) (sqrt (2 * c) + 1)) as [M HM]; [lra|pose proof (sqrt_pos (2 * c)); lra|exact C1|].
  destruct (peano_on (4 * n) (field n adj V' (d / 2) (D + d) (sqrt (2 * c) + 1)) M T (joined r v)) as (y & Y0 & Y1).
  - intros x k Hk. now apply HM.
  - intros x. apply field_continuous; [lra|exact C1].
  - exact HT.
  - intros t k Ht Hk. destruct (Mv t Ht) as [VR VV]. specialize (VV (Ds t Ht)). destruct (Bt t Ht) as [B1 B2].
    assert (J : forall i, (i < n)%nat -> place n (joined r v t) i = r i t /\ speed n (joined r v t) i = v i t) by (intros; now apply joined_parts).
    assert (FL := field_law n adj V' (d / 2) (D + d) (sqrt (2 * c) + 1) (joined r v t)).
    assert (X1 : forall i, (i < n)%nat -> norm (speed n (joined r v t) i) <= sqrt (2 * c) + 1) by (intros i Hi; rewrite (proj2 (J i Hi)); specialize (B1 i Hi); lra).
    assert (X2 : forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> d / 2 <= norm (place n (joined r v t) i - place n (joined r v t) j)%C <= D + d).
    { intros i j Hi Hj A. rewrite (proj1 (J i Hi)), (proj1 (J j Hj)). specialize (B2 i j Hi Hj A). lra. }
    specialize (FL X1 X2).
    assert (CE : forall i, (i < n)%nat -> control4 n adj V' (place n (joined r v t)) (speed n (joined r v t)) i = control4 n adj V' (fun i => r i t) (fun i => v i t) i).
    { intros i Hi. apply control4_ext; [exact Hi|intros; now apply J..]. }
    assert (K : exists i q, (i < n)%nat /\ (q < 4)%nat /\ k = (q * n + i)%nat).
    { exists (k mod n)%nat, (k / n)%nat. assert (n <> 0)%nat by lia. pose proof (Nat.div_mod k n H). pose proof (Nat.mod_upper_bound k n H). split; [lia|]. split; [|lia].
      apply Nat.div_lt_upper_bound; lia. }
    destruct K as (i & q & Hi & Hq & ->). destruct (FL i Hi) as [F1 F2]. rewrite (CE i Hi) in F2. rewrite (proj2 (J i Hi)) in F1. specialize (VR i Hi). specialize (VV i Hi).
    destruct VR as [R1 R2], VV as [V1 V2]. rewrite <- F1 in R1, R2. rewrite <- F2 in V1, V2. cbn [fst snd] in *.
    assert (Parts : forall s, joined r v s i = fst (r i s) /\ joined r v s (n + i)%nat = snd (r i s) /\ joined r v s (2 * n + i)%nat = fst (v i s) /\ joined r v s (3 * n + i)%nat = snd (v i s)).
    { intros s. destruct (joined_parts r v s i Hi) as [J1 J2]. rewrite <- J1, <- J2. unfold place, speed. now cbn [fst snd]. }
    destruct q as [|[|[|[|q]]]]; [| | | |lia].
    + replace (0 * n + i)%nat with i by lia. apply (is_derive_ext (fun s => fst (r i s))); [intros s; symmetry; apply Parts|exact R1].
    + replace (1 * n + i)%nat with (n + i)%nat by lia. apply (is_derive_ext (fun s => snd (r i s))); [intros s; symmetry; apply Parts|exact R2].
    + apply (is_derive_ext (fun s => fst (v i s))); [intros s; symmetry; apply Parts|exact V1].
    + apply (is_derive_ext (fun s => snd (v i s))); [intros s; symmetry; apply Parts|exact V2].
  - exists (fun i s => place n (y s) i), (fun i s => speed n (y s) i).
    assert (P : forall t i, t < T -> (i < n)%nat -> place n (y t) i = r i t /\ speed n (y t) i = v i t).
    { intros t i Ht Hi. rewrite (Y0 t Ht). now apply joined_parts. }
    split; [exact P|]. apply (field_moves d D c y Hd Bd); [| |intros; now apply Y1].
    + intros i j Hi Hj A. rewrite (proj1 (P 0 i HT Hi)), (proj1 (P 0 j HT Hj)). now apply A0.
    + right. unfold c. apply Wenergy_ext; intros i Hi; now apply P.
Qed.
(* what lasting means: a motion for all t >= 0 from every start, and every motion until T is the beginning of one *)
Definition lasting := (forall r0 v0, distinct n adj r0 -> exists r v, (forall i, (i < n)%nat -> r i 0 = r0 i /\ v i 0 = v0 i) /\ forall t, 0 <= t -> moves n adj V' r v t) /\
  forall T r v, 0 < T -> distinct n adj (fun i => r i 0) -> (forall t, 0 <= t < T -> moves n adj V' r v t) ->
    exists r' v', (forall t i, t < T -> (i < n)%nat -> r' i t = r i t /\ v' i t = v i t) /\ forall t, 0 <= t -> moves n adj V' r' v' t.
Hypothesis Hn : (1 <= n)%nat.
Hypothesis SC : strongly_connected n adj.
Theorem all_agree : lasting /\ forall r v, distinct n adj (fun i => r i 0) -> (forall t, 0 <= t -> moves n adj V' r v t) ->
  forall i j, (i < n)%nat -> (j < n)%nat -> forall e, 0 < e -> exists T, 0 <= T /\ forall t, T <= t -> norm (v i t - v j t)%C < e.
Proof. split; [split; [exact starts|exact goes_on]|]. intros r v A M. now apply (motions_agree n adj V V' r v). Qed.
Theorem all_forces_vanish : lasting /\ forall r v, distinct n adj (fun i => r i 0) -> (forall t, 0 <= t -> moves n adj V' r v t) ->
  forall e, 0 < e -> exists T, 0 <= T /\ forall t i, T <= t -> (i < n)%nat -> norm (grad_i n adj V' (fun j => r j t) i) < e.
Proof. split; [split; [exact starts|exact goes_on]|]. intros r v A M. now apply (forces_vanish n adj V V' r v). Qed.
Theorem all_tree_distances : tree n adj -> lasting /\ forall r v, distinct n adj (fun i => r i 0) -> (forall t, 0 <= t -> moves n adj V' r v t) ->
  forall m : nat -> nat -> R, (forall i j s, (i < n)%nat -> (j < n)%nat -> adj i j = true -> 0 < s -> V' i j s = 0 -> s = m i j) ->
  forall a b, (a < n)%nat -> (b < n)%nat -> adj a b = true ->
  forall e, 0 < e -> exists T, 0 <= T /\ forall t, T <= t -> Rabs (norm (r a t - r b t)%C - m a b) < e.
Proof. intros Tr. split; [split; [exact starts|exact goes_on]|]. intros r v A M. now apply (tree_distances n adj V V' r v). Qed.
Theorem all_tree_forces_vanish : tree n adj -> lasting /\ forall r v, distinct n adj (fun i => r i 0) -> (forall t, 0 <= t -> moves n adj V' r v t) ->
  forall a b, (a < n)%nat -> (b < n)%nat -> adj a b = true ->
  forall e, 0 < e -> exists T, 0 <= T /\ forall t, T <= t -> norm (grad (V' a b) (r a t) (r b t)) < e.
Proof. intros Tr. split; [split; [exact starts|exact goes_on]|]. intros r v A M. now apply (tree_forces_vanish n adj V V' r v). Qed.
End Lasting.
