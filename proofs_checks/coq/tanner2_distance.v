(* Tanner, Jadbabaie, Pappas, links by distance: for motions whose velocities have a derivative to the right at every time, (4) with
   the weights that the ties have just after it, velocities come to agree while the graph is connected.
     tanner2.thm2_vel, beyond.tanner2.arbswitch (clause 1): all but solutions in the sense of Filippov that have no such derivatives. *)
From Coq Require Import Reals Lra Lia Psatz Classical.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums paley_model paley_phase paley_laplacian paley_gradient paley_particles tanner_energy tanner_flock tanner_nonsmooth tanner_paths tanner_trees tanner2_facts tanner2_switching.
Open Scope R_scope.

(* ---- derivatives to the right ---- *)
Definition right_derive (f : R -> R) (t l : R) : Prop :=
  forall e, 0 < e -> exists d, 0 < d /\ forall h, 0 < h < d -> Rabs ((f (t + h) - f t) / h - l) < e.

Lemma right_of_derive f t l : is_derive f t l -> right_derive f t l.
Proof.
  intros D e He. apply is_derive_Reals in D. destruct (D e He) as [d Hd]. exists d. split; [apply cond_pos|].
  intros h Hh. apply Hd; [lra|]. rewrite Rabs_pos_eq; lra.
Qed.
Lemma right_ext f g t l d : 0 < d -> (forall h, 0 <= h < d -> f (t + h) = g (t + h)) -> right_derive f t l -> right_derive g t l.
Proof.
  intros Hd E D e He. destruct (D e He) as [d' [Hd' B]]. exists (Rmin d d'). split; [now apply Rmin_glb_lt|].
  intros h Hh. pose proof (Rmin_l d d'). pose proof (Rmin_r d d'). rewrite <- (E h) by lra.
  replace (g t) with (f t) by (pose proof (E 0 ltac:(lra)) as Z; rewrite Rplus_0_r in Z; exact Z). apply B. lra.
Qed.
Lemma right_eq f t a b : right_derive f t a -> a = b -> right_derive f t b.
Proof. now intros D <-. Qed.
Lemma right_const c t : right_derive (fun _ => c) t 0.
Proof. apply right_of_derive, D_const. Qed.
Lemma right_plus f g t a b : right_derive f t a -> right_derive g t b -> right_derive (fun s => f s + g s) t (a + b).
Proof.
  intros F G e He. destruct (F (e / 2) ltac:(lra)) as [d [Hd A]]. destruct (G (e / 2) ltac:(lra)) as [d' [Hd' B]].
  exists (Rmin d d'). split; [now apply Rmin_glb_lt|]. intros h Hh. pose proof (Rmin_l d d'). pose proof (Rmin_r d d').
  specialize (A h ltac:(lra)). specialize (B h ltac:(lra)).
  replace ((f (t + h) + g (t + h) - (f t + g t)) / h - (a + b)) with (((f (t + h) - f t) / h - a) + ((g (t + h) - g t) / h - b)) by (field; lra).
  eapply Rle_lt_trans; [apply Rabs_triang|]. lra.
Qed.
Lemma right_near f t l : right_derive f t l -> forall e, 0 < e -> exists d, 0 < d /\ forall h, 0 < h < d -> Rabs (f (t + h) - f t) <= (Rabs l + 1) * h /\ Rabs (f (t + h) - f t) < e.
Proof.
  intros F e He. destruct (F 1 Rlt_0_1) as [d [Hd A]]. pose proof (Rabs_pos l) as L. assert (P : 0 < e / (Rabs l + 1)) by (apply Rdiv_lt_0_compat; lra).
  exists (Rmin d (e / (Rabs l + 1))). split; [now apply Rmin_glb_lt|]. intros h Hh. pose proof (Rmin_l d (e / (Rabs l + 1))). pose proof (Rmin_r d (e / (Rabs l + 1))).
  specialize (A h ltac:(lra)). assert (B : Rabs (f (t + h) - f t) <= (Rabs l + 1) * h).
  { replace (f (t + h) - f t) with (((f (t + h) - f t) / h - l + l) * h) by (field; lra). rewrite Rabs_mult, (Rabs_pos_eq h) by lra.
    apply Rmult_le_compat_r; [lra|]. eapply Rle_trans; [apply Rabs_triang|]. lra. }
  split; [exact B|]. apply Rle_lt_trans with (1 := B). apply Rlt_le_trans with ((Rabs l + 1) * (e / (Rabs l + 1))); [apply Rmult_lt_compat_l; lra|right; field; lra].
Qed.
(* the outer function has a derivative *)
Lemma right_comp (g f : R -> R) t a b : is_derive g (f t) a -> right_derive f t b -> right_derive (fun s => g (f s)) t (a * b).
Proof.
  intros G F e He. apply is_derive_Reals in G. pose proof (Rabs_pos a) as Pa. pose proof (Rabs_pos b) as Pb.
  set (k := e / (2 * (Rabs b + 1))). assert (Hk : 0 < k) by (apply Rdiv_lt_0_compat; lra). destruct (G k Hk) as [d Gd].
  set (k' := e / (2 * (Rabs a + 1))). assert (Hk' : 0 < k') by (apply Rdiv_lt_0_compat; lra).
  destruct (F k' Hk') as [d1 [H1 A]]. destruct (right_near f t b F d (cond_pos d)) as [d2 [H2 B]].
  exists (Rmin d1 d2). split; [now apply Rmin_glb_lt|]. intros h Hh. pose proof (Rmin_l d1 d2). pose proof (Rmin_r d1 d2).
  specialize (A h ltac:(lra)). destruct (B h ltac:(lra)) as [B1 B2]. set (x := f (t + h) - f t) in *.
  assert (Q : Rabs (g (f (t + h)) - g (f t) - a * x) <= k * ((Rabs b + 1) * h)).
  { destruct (Req_dec x 0) as [Z|N].
    - replace (f (t + h)) with (f t) by (unfold x in Z; lra). rewrite Z. replace (g (f t) - g (f t) - a * 0) with 0 by ring. rewrite Rabs_R0.
      apply Rmult_le_pos; [lra|apply Rmult_le_pos; lra].
    - specialize (Gd x N B2). replace (f t + x) with (f (t + h)) in Gd by (unfold x; ring).
      replace (g (f (t + h)) - g (f t) - a * x) with (((g (f (t + h)) - g (f t)) / x - a) * x) by (field; exact N).
      rewrite Rabs_mult. apply Rmult_le_compat; [apply Rabs_pos|apply Rabs_pos|lra|exact B1]. }
  replace ((g (f (t + h)) - g (f t)) / h - a * b) with ((g (f (t + h)) - g (f t) - a * x) / h + a * (x / h - b)) by (field; lra).
  eapply Rle_lt_trans; [apply Rabs_triang|]. unfold Rdiv at 1. rewrite !Rabs_mult, (Rabs_pos_eq (/ h)) by (left; apply Rinv_0_lt_compat; lra).
  assert (T1 : Rabs (g (f (t + h)) - g (f t) - a * x) * / h <= e / 2).
  { apply Rle_trans with (k * ((Rabs b + 1) * h) * / h); [apply Rmult_le_compat_r; [left; apply Rinv_0_lt_compat; lra|exact Q]|]. unfold k. right. field. lra. }
  assert (T2 : Rabs a * Rabs (x / h - b) < e / 2).
  { apply Rle_lt_trans with (Rabs a * k'); [apply Rmult_le_compat_l; [exact Pa|left; exact A]|].
    assert (E : (Rabs a + 1) * k' = e / 2) by (unfold k'; field; lra). lra. }
  lra.
Qed.
Lemma right_scal c f t l : right_derive f t l -> right_derive (fun s => c * f s) t (c * l).
Proof. intros F. apply (right_comp (fun x => c * x) f t c l); [|exact F]. eapply D_eq; [apply D_scal, D_id|]. ring. Qed.
Lemma right_mult f g t a b : right_derive f t a -> right_derive g t b -> right_derive (fun s => f s * g s) t (a * g t + f t * b).
Proof.
  intros F G. assert (Sq : forall u c, right_derive u t c -> right_derive (fun s => u s * u s) t (2 * u t * c)).
  { intros u c U. apply (right_comp (fun x => x * x) u t (2 * u t) c); [|exact U]. eapply D_eq; [apply (D_mult (fun x => x) (fun x => x)); apply D_id|]. ring. }
  pose proof (Sq _ _ (right_plus f g t a b F G)) as P. cbv beta in P.
  pose proof (right_scal (-1) _ _ _ (Sq f a F)) as P1. pose proof (right_scal (-1) _ _ _ (Sq g b G)) as P2.
  pose proof (right_scal (/ 2) _ _ _ (right_plus _ _ _ _ _ P (right_plus _ _ _ _ _ P1 P2))) as P3. cbv beta in P3.
  apply (right_ext _ (fun s => f s * g s) t _ 1 Rlt_0_1) in P3; [|intros; cbv beta; field]. apply (right_eq _ _ _ _ P3). field.
Qed.
Lemma right_Sum n (f : nat -> R -> R) (d : nat -> R) t : (forall i, (i < n)%nat -> right_derive (f i) t (d i)) -> right_derive (fun s => Sum n (fun i => f i s)) t (Sum n d).
Proof.
  intros H. induction n as [|n IH]; cbn [Sum]; [apply right_const|]. apply right_plus; [apply IH; intros; apply H; lia|apply H; lia].
Qed.
Lemma right_min c f t l : f t = c -> right_derive f t l -> right_derive (fun s => Rmin (f s) c) t (Rmin l 0).
Proof.
  intros E F e He. destruct (F e He) as [d [Hd A]]. exists d. split; [exact Hd|]. intros h Hh. specialize (A h Hh).
  rewrite E in *. rewrite (Rmin_left c c) by lra. assert (Ih : 0 < / h) by (apply Rinv_0_lt_compat; lra). unfold Rdiv in *.
  apply Rabs_lt_between in A. apply Rabs_def1.
  - unfold Rmin. destruct (Rle_dec (f (t + h)) c), (Rle_dec l 0); nra.
  - unfold Rmin. destruct (Rle_dec (f (t + h)) c), (Rle_dec l 0); nra.
Qed.

(* a continuous function with no positive derivative to the right does not grow *)
Lemma right_decreasing (f f' : R -> R) a b : a <= b -> (forall t, a <= t <= b -> continuity_pt f t) ->
  (forall t, a <= t < b -> right_derive f t (f' t)) -> (forall t, a <= t < b -> f' t <= 0) -> f b <= f a.
Proof.
  intros Hab Ct D N. apply Rnot_lt_le. intros L.
  set (k := (f b - f a) / (2 * (b - a + 1))). assert (Hk : 0 < k) by (apply Rdiv_lt_0_compat; lra).
  assert (Kb : k * (b - a) < f b - f a).
  { apply Rle_lt_trans with ((f b - f a) / 2); [|lra]. unfold k. apply (Rmult_le_reg_r (2 * (b - a + 1))); [lra|].
    replace ((f b - f a) / (2 * (b - a + 1)) * (b - a) * (2 * (b - a + 1))) with ((f b - f a) * (b - a)) by (field; lra). nra. }
  destruct (completeness (fun x => a <= x <= b /\ forall y, a <= y <= x -> f y <= f a + k * (y - a))) as [m [Ub Lub]].
  { exists b. intros x [Hx _]. lra. }
  { exists a. split; [lra|]. intros y Hy. replace y with a by lra. lra. }
  assert (Ma : a <= m) by (apply Ub; split; [lra|]; intros y Hy; replace y with a by lra; lra).
  assert (Mb : m <= b) by (apply Lub; intros x [Hx _]; lra).
  assert (Before : forall y, a <= y < m -> f y <= f a + k * (y - a)).
  { intros y Hy. apply Rnot_lt_le. intros G. assert (m <= y); [|lra]. apply Lub. intros x [Hx Q]. apply Rnot_lt_le. intros Z. specialize (Q y ltac:(lra)). lra. }
  assert (At : f m <= f a + k * (m - a)).
  { destruct (Req_dec m a) as [->|Ne]; [lra|]. apply Rnot_lt_le. intros G. set (e := f m - (f a + k * (m - a))) in *. assert (He : 0 < e) by (unfold e; lra).
    destruct (Ct m ltac:(lra) e He) as [d [Hd B]]. set (y := Rmax a (m - d / 2)).
    assert (Y : a <= y < m /\ m - y <= d / 2) by (unfold y, Rmax; destruct (Rle_dec a (m - d / 2)); lra).
    assert (Rabs (f y - f m) < e).
    { apply (B y). split; [split; [exact I|lra]|]. cbn. unfold R_dist. rewrite Rabs_left; lra. }
    apply Rabs_lt_between in H. pose proof (Before y ltac:(lra)). assert (k * (y - a) <= k * (m - a)) by (apply Rmult_le_compat_l; lra). unfold e in H. lra. }
  destruct (Rle_lt_or_eq_dec m b Mb) as [Lt|Eq]; [|rewrite Eq in At; lra].
  destruct (D m ltac:(lra) k Hk) as [d [Hd B]]. pose proof (N m ltac:(lra)) as Nm.
  set (x := Rmin b (m + d / 2)). assert (X : m < x <= b /\ x - m < d) by (unfold x, Rmin; destruct (Rle_dec b (m + d / 2)); lra).
  assert (x <= m); [|lra]. apply Ub. split; [lra|]. intros y Hy. destruct (Rle_lt_dec y m) as [Z|Z].
  - destruct (Req_dec y m) as [->|Ne]; [exact At|]. apply Before. lra.
  - specialize (B (y - m) ltac:(lra)). replace (m + (y - m)) with y in B by ring. apply Rabs_lt_between in B.
    assert ((f y - f m) / (y - m) < k) by lra. apply (Rmult_lt_compat_r (y - m)) in H; [|lra]. unfold Rdiv in H. rewrite Rmult_assoc, Rinv_l, Rmult_1_r in H by lra. lra.
Qed.

(* ---- links by distance ---- *)
Definition right_velocity (x : R -> C) (t : R) (u : C) : Prop :=
  right_derive (fun s => fst (x s)) t (fst u) /\ right_derive (fun s => snd (x s)) t (snd u).
(* the weight of the pair i, j just after t: 1 below R, 0 beyond, at R that of the side to which the pair goes, any where it grazes *)
Definition weighs (R0 : R) (ri rj vi vj : C) (m : R) : Prop :=
  0 <= m <= 1 /\ (norm (ri - rj)%C < R0 -> m = 1) /\ (R0 < norm (ri - rj)%C -> m = 0) /\
  (norm (ri - rj)%C = R0 -> (0 < inner (ri - rj)%C (vi - vj)%C -> m = 0) /\ (inner (ri - rj)%C (vi - vj)%C < 0 -> m = 1)).
Definition weighted_control (n : nat) (m : nat -> nat -> R) (V' : nat -> nat -> R -> R) (r v : nat -> C) (i : nat) : C :=
  (- Csum n (fun j => RtoC (m i j) * (v i - v j)) - Csum n (fun j => RtoC (m i j) * grad (V' i j) (r i) (r j)))%C.

Lemma right_inner (x y : R -> C) t a b : right_velocity x t a -> right_velocity y t b ->
  right_derive (fun s => inner (x s) (y s)) t (inner a (y t) + inner (x t) b).
Proof.
  intros [A1 A2] [B1 B2]. apply (right_ext (fun s => fst (x s) * fst (y s) + snd (x s) * snd (y s)) _ t _ 1 Rlt_0_1); [intros; now rewrite inner_xy|].
  eapply right_eq; [apply right_plus; apply right_mult; eassumption|]. rewrite !inner_xy. ring.
Qed.
Lemma right_velocity_minus x y t a b : right_velocity x t a -> right_velocity y t b -> right_velocity (fun s => x s - y s)%C t (a - b)%C.
Proof.
  assert (K : forall f g a b, right_derive f t a -> right_derive g t b -> right_derive (fun s => f s - g s) t (a - b)).
  { intros f g c d F G. eapply right_eq; [apply (right_ext _ (fun s => f s - g s) t _ 1 Rlt_0_1) with (2 := right_plus _ _ _ _ _ F (right_scal (-1) _ _ _ G)); intros; cbv beta; ring|ring]. }
  intros [A1 A2] [B1 B2]. split; [apply (K (fun s => fst (x s)) (fun s => fst (y s)))|apply (K (fun s => snd (x s)) (fun s => snd (y s)))]; assumption.
Qed.

(* the saturated potential of a pair along a motion *)
Lemma pair_right (V V' : R -> R) R0 (ri rj : R -> C) vi vj m t : 0 < R0 -> (forall s, 0 < s -> is_derive V s (V' s)) ->
  is_velocity ri t vi -> is_velocity rj t vj -> ri t <> rj t -> weighs R0 (ri t) (rj t) vi vj m ->
  right_derive (fun s => saturated V R0 (norm (ri s - rj s)%C)) t (inner (RtoC m * grad V' (ri t) (rj t))%C (vi - vj)%C).
Proof.
  intros HR D Vi Vj N (M & M1 & M2 & M3). pose proof (norm_neq _ _ N) as P.
  assert (N0 : (ri t - rj t)%C <> RtoC 0) by (intros E; rewrite E in P; unfold norm in P; rewrite Cmod_0 in P; lra).
  set (s := fun x => norm (ri x - rj x)%C).
  assert (S : right_derive s t (inner (ri t - rj t)%C (vi - vj)%C / s t)) by exact (right_of_derive _ _ _ (D_norm _ t _ (velocity_minus ri rj t vi vj Vi Vj) N0)).
  change (right_derive (fun x => saturated V R0 (s x)) t (inner (RtoC m * grad V' (ri t) (rj t))%C (vi - vj)%C)). set (q := inner (ri t - rj t)%C (vi - vj)%C) in *. change (norm (ri t - rj t)%C) with (s t) in *.
  assert (G : inner (RtoC m * grad V' (ri t) (rj t))%C (vi - vj)%C = m * (V' (s t) * (q / s t))).
  { rewrite inner_sym, inner_scal. unfold grad. rewrite inner_scal, (inner_sym (vi - vj)%C). fold (s t). unfold q. field. lra. }
  rewrite G. apply (right_ext (fun x => V (Rmin (s x) R0)) _ t _ 1 Rlt_0_1); [intros; symmetry; apply saturated_min|].
  assert (K : right_derive (fun x => Rmin (s x) R0) t (m * (q / s t))).
  { destruct (Rtotal_order (s t) R0) as [L|[E|L]].
    - destruct (right_near _ _ _ S (R0 - s t) ltac:(lra)) as [d [Hd B]]. apply (right_ext s _ t _ d Hd).
      + intros h Hh. destruct (Req_dec h 0) as [->|Nh]; [rewrite Rplus_0_r, Rmin_left by lra; reflexivity|].
        destruct (B h ltac:(lra)) as [_ B2]. apply Rabs_lt_between in B2. rewrite Rmin_left by lra. reflexivity.
      + rewrite (M1 L). apply (right_eq _ _ _ _ S). ring.
    - destruct (M3 E) as [M4 M5]. apply (right_eq _ _ _ _ (right_min R0 s t _ E S)). assert (Is : 0 < / s t) by now apply Rinv_0_lt_compat.
      destruct (Rtotal_order q 0) as [Q|[Q|Q]].
      + rewrite (M5 Q), Rmin_left; [ring|]. unfold Rdiv. nra.
      + rewrite Q. unfold Rdiv. rewrite Rmult_0_l, Rmult_0_r. apply Rmin_left. lra.
      + rewrite (M4 Q), Rmin_right; [ring|]. unfold Rdiv. nra.
    - destruct (right_near _ _ _ S (s t - R0) ltac:(lra)) as [d [Hd B]]. apply (right_ext (fun _ => R0) _ t _ d Hd).
      + intros h Hh. destruct (Req_dec h 0) as [->|Nh]; [rewrite Rplus_0_r; symmetry; apply Rmin_right; lra|].
        destruct (B h ltac:(lra)) as [_ B2]. apply Rabs_lt_between in B2. rewrite Rmin_right by lra. reflexivity.
      + rewrite (M2 L), Rmult_0_l. apply right_const. }
  destruct (Rle_or_lt (s t) R0) as [L|L].
  - assert (E : Rmin (s t) R0 = s t) by now apply Rmin_left. eapply right_eq; [apply (right_comp V (fun x => Rmin (s x) R0) t (V' (s t)) (m * (q / s t)))|]; [rewrite E; now apply D|exact K|ring].
  - assert (E : Rmin (s t) R0 = R0) by (apply Rmin_right; lra). eapply right_eq; [apply (right_comp V (fun x => Rmin (s x) R0) t (V' R0) (m * (q / s t)))|]; [rewrite E; now apply D|exact K|].
    rewrite (M2 L). ring.
Qed.

Lemma connected_le n adj (x : nat -> C) i j : strongly_connected n adj -> (i < n)%nat -> (j < n)%nat ->
  dist2 (x i) (x j) <= INR n * INR n * total n adj x.
Proof.
  intros SC Hi Hj. destruct (joined n adj i j SC Hi Hj) as [l [W L]]. pose proof (total_ge0 n adj x) as T0. set (T := total n adj x) in *.
  assert (B : norm (x i - x j)%C <= INR (length l) * sqrt T).
  { apply (walk_length n adj x (sqrt T) j l); [|exact W]. intros a b (Ha & Hb & A).
    assert (G : forall p q, (p < n)%nat -> (q < n)%nat -> adj p q = true -> dist2 (x p) (x q) <= T).
    { intros p q Hp Hq E. assert (Z : forall k l, 0 <= w adj k l * dist2 (x k) (x l)).
      { intros k l'. unfold w. pose proof (dist2_ge0 (x k) (x l')). destruct (adj k l'); lra. }
      unfold T, total. apply Rle_trans with (Sum n (fun l => w adj p l * dist2 (x p) (x l))).
      - apply Rle_trans with (w adj p q * dist2 (x p) (x q)); [unfold w; rewrite E; lra|].
        apply (Sum_term_le n (fun l => w adj p l * dist2 (x p) (x l))); [intros; apply Z|exact Hq].
      - apply (Sum_term_le n (fun k => Sum n (fun l => w adj k l * dist2 (x k) (x l)))); [intros; apply Sum_ge0; intros; apply Z|exact Hp]. }
    assert (F : dist2 (x a) (x b) <= T) by (first [now apply G|replace (dist2 (x a) (x b)) with (dist2 (x b) (x a)) by (rewrite !dist2_xy; ring); now apply G]).
    rewrite dist2_norm in F. rewrite <- (sqrt_pow2 (norm (x a - x b)%C)) by apply norm_ge0. now apply sqrt_le_1_alt. }
  rewrite dist2_norm. apply Rle_trans with ((INR n * sqrt T) ^ 2).
  - apply pow_incr. split; [apply norm_ge0|]. apply Rle_trans with (1 := B). apply Rmult_le_compat_r; [apply sqrt_pos|]. apply le_INR. lia.
  - replace ((INR n * sqrt T) ^ 2) with (INR n * INR n * (sqrt T * sqrt T)) by ring. rewrite sqrt_sqrt by exact T0. lra.
Qed.

(* F falls by a fixed amount each time that G is not small *)
Lemma settles (F G : R -> R) : (forall s t, 0 <= s <= t -> F t <= F s) -> (forall t, 0 <= t -> 0 <= F t) ->
  (forall e, 0 < e -> exists q h, 0 < q /\ 0 < h /\ forall t, 0 <= t -> e <= G t -> F (t + h) <= F t - q) ->
  forall e, 0 < e -> exists T, 0 <= T /\ forall t, T <= t -> G t < e.
Proof.
  intros Down Pos Drop e He. destruct (Drop e He) as [q [h [Hq [Hh J]]]].
  destruct (classic (exists T, 0 <= T /\ forall t, T <= t -> G t < e)) as [Y|N]; [exact Y|exfalso].
  assert (A : forall T, 0 <= T -> exists t, T <= t /\ e <= G t).
  { intros T HT. apply NNPP. intros N2. apply N. exists T. split; [assumption|]. intros t Ht. apply Rnot_le_lt. intros Hg. apply N2. now exists t. }
  assert (K : forall k, exists t, 0 <= t /\ F t <= F 0 - INR k * q).
  { induction k as [|k [t [Ht Hk]]]; [exists 0; cbn; lra|]. destruct (A t Ht) as [u [Hu Gu]]. exists (u + h). split; [lra|].
    rewrite S_INR. pose proof (J u ltac:(lra) Gu). pose proof (Down t u ltac:(lra)). lra. }
  destruct (nfloor_ex (F 0 / q)) as [k [_ Hk]]; [apply Rmult_le_pos; [apply Pos; lra|left; now apply Rinv_0_lt_compat]|].
  destruct (K (Datatypes.S k)) as [t [Ht B]]. pose proof (Pos t Ht). rewrite S_INR in B.
  apply (Rmult_lt_compat_r q) in Hk; [|exact Hq]. unfold Rdiv in Hk. rewrite Rmult_assoc, Rinv_l in Hk by lra. lra.
Qed.

Lemma Sum_opp k f : - Sum k f = Sum k (fun i => - f i).
Proof. induction k as [|k IH]; cbn [Sum]; lra. Qed.
Section Distance.
Variables (n : nat) (V V' : nat -> nat -> R -> R) (R0 : R) (r v : nat -> R -> C) (m : R -> nat -> nat -> R).
Hypothesis Hn : (1 <= n)%nat.
Hypothesis HR : 0 < R0.
Hypothesis VS' : forall i j, V' i j = V' j i.
Hypothesis Pot : forall i j, (i < n)%nat -> (j < n)%nat -> i <> j -> potential (V i j) (V' i j).
Hypothesis C1 : forall i j s, (i < n)%nat -> (j < n)%nat -> i <> j -> 0 < s -> continuity_pt (V' i j) s.
Hypothesis Apart : forall t i j, 0 <= t -> (i < n)%nat -> (j < n)%nat -> i <> j -> r i t <> r j t.
Hypothesis HV : forall t i, 0 <= t -> (i < n)%nat -> is_velocity (r i) t (v i t) /\ continuous_at (v i) t.
Hypothesis Wt : forall t i j, 0 <= t -> (i < n)%nat -> (j < n)%nat -> m t i j = m t j i /\
  (i <> j -> weighs R0 (r i t) (r j t) (v i t) (v j t) (m t i j)).
Hypothesis HA : forall t i, 0 <= t -> (i < n)%nat -> right_velocity (v i) t (weighted_control n (m t) V' (fun i => r i t) (fun i => v i t) i).
Hypothesis Co : forall t, 0 <= t -> strongly_connected n (near (fun i => r i t) R0).
Notation energy t := (Qsat n V R0 (fun i => r i t) (fun i => v i t)).
Notation u i t := (weighted_control n (m t) V' (fun i => r i t) (fun i => v i t) i).
Notation spread t := (Sum n (fun i => Sum n (fun j => dist2 (v i t) (v j t)))).

Lemma sat_ge0 t i j : 0 <= t -> (i < n)%nat -> (j < n)%nat -> 0 <= sat_pair V R0 (fun i => r i t) i j.
Proof.
  intros Ht Hi Hj. unfold sat_pair. destruct (Nat.eqb_spec i j); [lra|]. destruct (Pot i j Hi Hj n0) as [P _].
  unfold saturated. destruct (Rlt_dec _ R0); apply P; [|exact HR]. now apply norm_neq, Apart.
Qed.
Lemma energy_ge0 t : 0 <= t -> 0 <= energy t.
Proof.
  intros Ht. unfold Qsat. apply Rmult_le_pos; [lra|]. apply Sum_ge0; intros i Hi. pose proof (inner_self_ge0 (v i t)).
  assert (0 <= Sum n (fun j => sat_pair V R0 (fun i => r i t) i j)) by (apply Sum_ge0; intros; now apply sat_ge0). lra.
Qed.
Lemma pair_le t i j : 0 <= t -> (i < n)%nat -> (j < n)%nat -> sat_pair V R0 (fun i => r i t) i j <= 2 * energy t.
Proof.
  intros Ht Hi Hj. unfold Qsat. replace (2 * (/ 2 * Sum n (fun i => Sum n (fun j => sat_pair V R0 (fun i => r i t) i j) + inner (v i t) (v i t))))
    with (Sum n (fun i => Sum n (fun j => sat_pair V R0 (fun i => r i t) i j) + inner (v i t) (v i t))) by field.
  assert (G : forall k, (k < n)%nat -> 0 <= Sum n (fun j => sat_pair V R0 (fun i => r i t) k j)) by (intros; apply Sum_ge0; intros; now apply sat_ge0).
  apply Rle_trans with (Sum n (fun j => sat_pair V R0 (fun i => r i t) i j) + inner (v i t) (v i t)).
  - pose proof (Sum_term_le n (fun j => sat_pair V R0 (fun i => r i t) i j) j (fun k Hk => sat_ge0 t i k Ht Hi Hk) Hj). pose proof (inner_self_ge0 (v i t)). cbv beta in *. lra.
  - apply (Sum_term_le n (fun i => Sum n (fun j => sat_pair V R0 (fun i => r i t) i j) + inner (v i t) (v i t))); [|exact Hi].
    intros k Hk. pose proof (G k Hk). pose proof (inner_self_ge0 (v k t)). lra.
Qed.
Lemma speed_le t i : 0 <= t -> (i < n)%nat -> inner (v i t) (v i t) <= 2 * energy t.
Proof.
  intros Ht Hi. unfold Qsat. replace (2 * (/ 2 * Sum n (fun i => Sum n (fun j => sat_pair V R0 (fun i => r i t) i j) + inner (v i t) (v i t))))
    with (Sum n (fun i => Sum n (fun j => sat_pair V R0 (fun i => r i t) i j) + inner (v i t) (v i t))) by field.
  assert (G : forall k, (k < n)%nat -> 0 <= Sum n (fun j => sat_pair V R0 (fun i => r i t) k j)) by (intros; apply Sum_ge0; intros; now apply sat_ge0).
  apply Rle_trans with (Sum n (fun j => sat_pair V R0 (fun i => r i t) i j) + inner (v i t) (v i t)); [pose proof (G i Hi); lra|].
  apply (Sum_term_le n (fun i => Sum n (fun j => sat_pair V R0 (fun i => r i t) i j) + inner (v i t) (v i t))); [|exact Hi].
  intros k Hk. pose proof (G k Hk). pose proof (inner_self_ge0 (v k t)). lra.
Qed.

(* Q falls by the damping *)
Definition damping (t : R) : R := / 2 * Sum n (fun i => Sum n (fun j => m t i j * dist2 (v i t) (v j t))).
Lemma pair_rate_right t i j : 0 <= t -> (i < n)%nat -> (j < n)%nat ->
  right_derive (fun s => sat_pair V R0 (fun i => r i s) i j) t (inner (RtoC (m t i j) * grad (V' i j) (r i t) (r j t))%C (v i t - v j t)%C).
Proof.
  intros Ht Hi Hj. unfold sat_pair. destruct (Nat.eqb_spec i j) as [->|N].
  - apply (right_eq _ _ _ _ (right_const 0 t)). rewrite inner_xy. cbn. ring.
  - apply pair_right; [exact HR|intros; now apply (Pot i j Hi Hj N)|now apply HV|now apply HV|now apply Apart|now apply Wt].
Qed.
Lemma energy_right t : 0 <= t -> right_derive (fun s => energy s) t (- damping t).
Proof.
  intros Ht.
  pose proof (pair_sum_swap n (fun i j => RtoC (m t i j) * grad (V' i j) (r i t) (r j t))%C v t) as S1.
  pose proof (pair_sum_swap n (fun i j => RtoC (m t i j) * (v i t - v j t))%C v t) as S2. cbv beta in S1, S2.
  specialize (S1 ltac:(intros i j Hi Hj; rewrite (grad_antisym (V' j i) (r i t) (r j t)), VS', (proj1 (Wt t i j Ht Hi Hj)); ring)).
  specialize (S2 ltac:(intros i j Hi Hj; rewrite (proj1 (Wt t i j Ht Hi Hj)); ring)).
  assert (E1 : damping t = Sum n (fun i => inner (v i t) (Csum n (fun j => RtoC (m t i j) * (v i t - v j t))%C))).
  { rewrite <- S2. unfold damping. f_equal. apply Sum_ext; intros i _. apply Sum_ext; intros j _. unfold dist2. rewrite (inner_sym (RtoC (m t i j) * _)%C), inner_scal. reflexivity. }
  eapply right_eq.
  - unfold Qsat. apply right_scal. apply (right_Sum n (fun i s => Sum n (fun j => sat_pair V R0 (fun i => r i s) i j) + inner (v i s) (v i s))
      (fun i => Sum n (fun j => inner (RtoC (m t i j) * grad (V' i j) (r i t) (r j t))%C (v i t - v j t)%C) + (inner (u i t) (v i t) + inner (v i t) (u i t)))).
    intros i Hi. apply right_plus; [|apply right_inner; now apply HA].
    apply (right_Sum n (fun j s => sat_pair V R0 (fun i => r i s) i j) (fun j => inner (RtoC (m t i j) * grad (V' i j) (r i t) (r j t))%C (v i t - v j t)%C)).
    intros j Hj. now apply pair_rate_right.
  - rewrite Sum_plus, Rmult_plus_distr_l, S1, E1, <- Sum_scal, <- Sum_plus.
    rewrite Sum_opp.
    apply Sum_ext; intros i _. rewrite (inner_sym (u i t)). unfold weighted_control.
    set (a := Csum n _). set (b := Csum n _). rewrite !inner_xy. cbn. field.
Qed.
Lemma energy_continuous t : 0 <= t -> continuity_pt (fun s => energy s) t.
Proof.
  intros Ht. unfold Qsat. apply continuity_pt_mult; [apply continuity_pt_const; intros ? ?; reflexivity|].
  apply (continuity_Sum n (fun i s => Sum n (fun j => sat_pair V R0 (fun i => r i s) i j) + inner (v i s) (v i s))). intros i Hi. apply continuity_pt_plus.
  - apply (continuity_Sum n (fun j s => sat_pair V R0 (fun i => r i s) i j)). intros j Hj. unfold sat_pair.
    destruct (Nat.eqb_spec i j) as [->|N]; [apply continuity_pt_const; intros ? ?; reflexivity|].
    pose proof (Apart t i j Ht Hi Hj N) as A. pose proof (norm_neq _ _ A) as P.
    apply continuity_pt_comp with (f1 := fun s => norm (r i s - r j s)%C) (f2 := saturated (V i j) R0).
    + assert (N0 : (r i t - r j t)%C <> RtoC 0) by (intros E; rewrite E in P; unfold norm in P; rewrite Cmod_0 in P; lra).
      pose proof (D_norm _ t _ (velocity_minus (r i) (r j) t _ _ (proj1 (HV t i Ht Hi)) (proj1 (HV t j Ht Hj))) N0) as D.
      apply continuity_pt_filterlim. apply (ex_derive_continuous (fun s => norm (r i s - r j s)%C)). eexists. exact D.
    + apply (saturated_continuous (V i j) (V' i j) R0); [exact HR|intros; now apply (Pot i j Hi Hj N)|exact P].
  - destruct (HV t i Ht Hi) as [_ [A B]]. apply (continuity_pt_ext (fun s => fst (v i s) * fst (v i s) + snd (v i s) * snd (v i s))); [intros; now rewrite inner_xy|].
    apply continuity_pt_plus; now apply continuity_pt_mult.
Qed.
Lemma damping_le t : 0 <= t -> spread t <= 2 * INR n ^ 4 * damping t.
Proof.
  intros Ht. pose proof (pos_INR n) as Pn.
  assert (T : total n (near (fun i => r i t) R0) (fun i => v i t) <= 2 * damping t).
  { unfold damping, total. replace (2 * (/ 2 * Sum n (fun i => Sum n (fun j => m t i j * dist2 (v i t) (v j t))))) with (Sum n (fun i => Sum n (fun j => m t i j * dist2 (v i t) (v j t)))) by field.
    apply Sum_le; intros i Hi. apply Sum_le; intros j Hj. pose proof (dist2_ge0 (v i t) (v j t)) as D. unfold w, near.
    destruct (Nat.eqb_spec i j) as [->|N]; [replace (dist2 (v j t) (v j t)) with 0; [lra|symmetry; now apply dist2_0]|].
    destruct (Wt t i j Ht Hi Hj) as [_ W]. destruct (W N) as (W0 & W1 & _). destruct (Rlt_dec _ R0) as [L|L]; [rewrite (W1 L)|]; nra. }
  set (T0 := total n (near (fun i => r i t) R0) (fun i => v i t)) in *.
  apply Rle_trans with (INR n * (INR n * (INR n * INR n * T0))).
  - rewrite <- Sum_const. apply Sum_le; intros i Hi. rewrite <- Sum_const. apply Sum_le; intros j Hj.
    apply (connected_le n (near (fun i => r i t) R0) (fun i => v i t)); [now apply Co|exact Hi|exact Hj].
  - replace (INR n * (INR n * (INR n * INR n * T0))) with (INR n ^ 4 * T0) by ring. replace (2 * INR n ^ 4 * damping t) with (INR n ^ 4 * (2 * damping t)) by ring.
    apply Rmult_le_compat_l; [now apply pow_le|exact T].
Qed.
Lemma spread_ge0 t : 0 <= spread t.
Proof. apply Sum_ge0; intros i _. apply Sum_ge0; intros j _. apply dist2_ge0. Qed.
Lemma damping_ge0 t : 0 <= t -> 0 <= damping t.
Proof.
  intros Ht. unfold damping. apply Rmult_le_pos; [lra|]. apply Sum_ge0; intros i Hi. apply Sum_ge0; intros j Hj. pose proof (dist2_ge0 (v i t) (v j t)).
  destruct (Nat.eq_dec i j) as [->|N]; [replace (dist2 (v j t) (v j t)) with 0; [lra|symmetry; now apply dist2_0]|].
  destruct (Wt t i j Ht Hi Hj) as [_ W]. destruct (W N) as (W0 & _). apply Rmult_le_pos; lra.
Qed.
Lemma energy_falls s t : 0 <= s <= t -> energy t <= energy s.
Proof.
  intros H. apply (right_decreasing (fun t => energy t) (fun t => - damping t)); [lra|intros; apply energy_continuous; lra|intros; apply energy_right; lra|].
  intros x Hx. pose proof (damping_ge0 x ltac:(lra)). lra.
Qed.
Lemma speed_norm t i : 0 <= t -> (i < n)%nat -> norm (v i t) <= 2 * energy 0 + 1.
Proof.
  intros Ht Hi. pose proof (speed_le t i Ht Hi) as S. pose proof (energy_falls 0 t ltac:(lra)) as F. pose proof (energy_ge0 0 ltac:(lra)) as P.
  rewrite <- norm_sqr in S. pose proof (norm_ge0 (v i t)) as N. apply Rnot_lt_le. intros L.
  assert (1 * norm (v i t) <= norm (v i t) * norm (v i t)) by (apply Rmult_le_compat_r; lra). lra.
Qed.
Lemma control_norm : exists B, 0 < B /\ forall t i, 0 <= t -> (i < n)%nat -> norm (u i t) <= B.
Proof.
  destruct (uniform_pairs n (fun i j b => i <> j -> forall s, 0 < s <= R0 -> V i j s <= 2 * energy 0 -> Rabs (V' i j s) <= b)) as [b [Hb U]].
  { intros i j b b' Q L N s Hs H. specialize (Q N s Hs H). lra. }
  { intros i j Hi Hj. destruct (Nat.eq_dec i j) as [->|N]; [exists 0; congruence|]. destruct (Pot i j Hi Hj N) as (_ & Z & _).
    destruct (Z (2 * energy 0)) as [d [Hd Zd]]. destruct (Rle_or_lt d R0) as [L|L].
    - destruct (continuity_ab_maj (fun s => Rabs (V' i j s)) d R0 L) as [x [M _]].
      + intros s Hs. apply continuity_pt_comp with (f1 := V' i j) (f2 := Rabs); [apply C1; try assumption; lra|apply Rcontinuity_abs].
      + exists (Rabs (V' i j x)). intros _ s Hs H. apply M. split; [|lra]. apply Rnot_lt_le. intros G. specialize (Zd s ltac:(lra)). lra.
    - exists 0. intros _ s Hs H. specialize (Zd s ltac:(lra)). lra. }
  set (S := 2 * energy 0 + 1). assert (PS : 0 < S) by (pose proof (energy_ge0 0 ltac:(lra)); unfold S; lra). pose proof (pos_INR n) as Pn.
  exists (INR n * (2 * S) + INR n * b + 1).
  assert (A1 : 0 <= INR n * (2 * S)) by (apply Rmult_le_pos; lra). assert (A2 : 0 <= INR n * b) by (apply Rmult_le_pos; lra). split; [lra|]. intros t i Ht Hi.
  assert (M : forall j, (j < n)%nat -> i <> j -> 0 <= m t i j <= 1) by (intros j Hj N; now apply (proj2 (Wt t i j Ht Hi Hj) N)).
  unfold weighted_control. unfold Cminus at 1. eapply Rle_trans; [apply norm_triangle|]. rewrite !norm_opp.
  assert (B1 : norm (Csum n (fun j => RtoC (m t i j) * (v i t - v j t)))%C <= INR n * (2 * S)).
  { eapply Rle_trans; [apply norm_Csum|]. rewrite <- Sum_const. apply Sum_le; intros j Hj. rewrite norm_scal.
    destruct (Nat.eq_dec i j) as [->|N]; [replace (v j t - v j t)%C with (RtoC 0) by ring; unfold norm; rewrite Cmod_0; lra|].
    pose proof (M j Hj N). rewrite Rabs_pos_eq by lra. apply Rle_trans with (1 * norm (v i t - v j t)%C); [apply Rmult_le_compat_r; [apply norm_ge0|lra]|].
    unfold Cminus. pose proof (norm_triangle (v i t) (- v j t)%C) as T. rewrite norm_opp in T. pose proof (speed_norm t i Ht Hi). pose proof (speed_norm t j Ht Hj). unfold S. lra. }
  assert (B2 : norm (Csum n (fun j => RtoC (m t i j) * grad (V' i j) (r i t) (r j t)))%C <= INR n * b).
  { eapply Rle_trans; [apply norm_Csum|]. rewrite <- Sum_const. apply Sum_le; intros j Hj. rewrite norm_scal.
    destruct (Nat.eq_dec i j) as [->|N]; [unfold grad; replace (r j t - r j t)%C with (RtoC 0) by ring; rewrite norm_scal; unfold norm at 3; rewrite Cmod_0; lra|].
    pose proof (M j Hj N) as Mj. pose proof (Apart t i j Ht Hi Hj N) as A. rewrite (norm_grad _ _ _ A), Rabs_pos_eq by lra.
    pose proof (norm_neq _ _ A) as P. destruct (Rle_or_lt (norm (r i t - r j t)%C) R0) as [L|L].
    - assert (Q : Rabs (V' i j (norm (r i t - r j t)%C)) <= b).
      { apply (U i j Hi Hj N); [lra|]. pose proof (pair_le t i j Ht Hi Hj) as PL. pose proof (energy_falls 0 t ltac:(lra)).
        unfold sat_pair in PL. destruct (Nat.eqb_spec i j); [contradiction|]. rewrite saturated_min, Rmin_left in PL by exact L. lra. }
      pose proof (Rabs_pos (V' i j (norm (r i t - r j t)%C))). apply Rle_trans with (1 * Rabs (V' i j (norm (r i t - r j t)%C))); [apply Rmult_le_compat_r; lra|lra].
    - destruct (proj2 (Wt t i j Ht Hi Hj) N) as (_ & _ & W & _). rewrite (W L). lra. }
  lra.
Qed.
Lemma inner_ge x y a b : norm x <= a -> norm y <= b -> - (a * b) <= inner x y.
Proof.
  intros X Y. pose proof (inner_norms x y) as I. apply Rabs_le_between in I. pose proof (norm_ge0 x). pose proof (norm_ge0 y).
  assert (norm x * norm y <= a * b) by (apply Rmult_le_compat; assumption). lra.
Qed.
Lemma spread_slow : exists K, 0 < K /\ forall s t, 0 <= s <= t -> spread s - K * (t - s) <= spread t.
Proof.
  destruct control_norm as [B [HB U]]. set (S := 2 * energy 0 + 1). assert (PS : 0 < S) by (pose proof (energy_ge0 0 ltac:(lra)); unfold S; lra). pose proof (pos_INR n) as Pn.
  set (c := 2 * (2 * B * (2 * S))). assert (Pc : 0 < c) by (unfold c; repeat apply Rmult_lt_0_compat; lra).
  exists (INR n * (INR n * c) + 1). assert (Pk : 0 <= INR n * (INR n * c)) by (apply Rmult_le_pos; [lra|apply Rmult_le_pos; lra]). split; [lra|]. intros s t Hst.
  set (d := fun x => Sum n (fun i => Sum n (fun j => inner (u i x - u j x)%C (v i x - v j x)%C + inner (v i x - v j x)%C (u i x - u j x)%C))).
  assert (Dif : forall x y a, norm x <= a -> norm y <= a -> norm (x - y)%C <= 2 * a).
  { intros x y a X Y. unfold Cminus. pose proof (norm_triangle x (- y)%C) as T. rewrite norm_opp in T. lra. }
  assert (Dr : forall x, 0 <= x -> right_derive (fun s => spread s) x (d x)).
  { intros x Hx. unfold d. apply (right_Sum n (fun i s => Sum n (fun j => dist2 (v i s) (v j s))) (fun i => Sum n (fun j => inner (u i x - u j x)%C (v i x - v j x)%C + inner (v i x - v j x)%C (u i x - u j x)%C))). intros i Hi.
    apply (right_Sum n (fun j s => dist2 (v i s) (v j s)) (fun j => inner (u i x - u j x)%C (v i x - v j x)%C + inner (v i x - v j x)%C (u i x - u j x)%C)). intros j Hj.
    pose proof (right_velocity_minus (v i) (v j) x _ _ (HA x i Hx Hi) (HA x j Hx Hj)) as VM. exact (right_inner _ _ x _ _ VM VM). }
  assert (Ge : forall x, 0 <= x -> - (INR n * (INR n * c)) <= d x).
  { intros x Hx. unfold d. replace (- (INR n * (INR n * c))) with (INR n * (INR n * - c)) by ring. rewrite <- Sum_const. apply Sum_le; intros i Hi. rewrite <- Sum_const. apply Sum_le; intros j Hj.
    assert (Va : norm (v i x - v j x)%C <= 2 * S) by (apply Dif; now apply speed_norm).
    assert (Ua : norm (u i x - u j x)%C <= 2 * B) by (apply Dif; now apply U).
    pose proof (inner_ge _ _ _ _ Ua Va) as I. rewrite (inner_sym (v i x - v j x)%C). unfold c. lra. }
  set (K := INR n * (INR n * c) + 1) in *.
  assert (F : - spread t + - K * t <= - spread s + - K * s); [|lra].
  apply (right_decreasing (fun x => - spread x + - K * x) (fun x => -1 * d x + - K)); [lra| | |].
  - intros x Hx. apply continuity_pt_plus.
    + apply continuity_pt_opp. apply (continuity_Sum n (fun i s => Sum n (fun j => dist2 (v i s) (v j s)))). intros i Hi. apply (continuity_Sum n (fun j s => dist2 (v i s) (v j s))). intros j Hj.
      destruct (HV x i ltac:(lra) Hi) as [_ [A1 A2]]. destruct (HV x j ltac:(lra) Hj) as [_ [B1 B2]].
      apply (continuity_pt_ext (fun s => (fst (v i s) - fst (v j s)) * (fst (v i s) - fst (v j s)) + (snd (v i s) - snd (v j s)) * (snd (v i s) - snd (v j s)))); [intros; rewrite dist2_xy; ring|].
      apply continuity_pt_plus; apply continuity_pt_mult; now apply continuity_pt_minus.
    + apply continuity_pt_mult; [apply continuity_pt_const; intros ? ?; reflexivity|apply derivable_continuous_pt, derivable_pt_id].
  - intros x Hx. apply (right_plus (fun x => - spread x) (fun x => - K * x)).
    + apply (right_ext _ (fun x => - spread x) x _ 1 Rlt_0_1) with (2 := right_scal (-1) _ _ _ (Dr x ltac:(lra))). intros; cbv beta; ring.
    + apply right_of_derive. eapply D_eq; [apply D_scal, D_id|]. ring.
  - intros x Hx. pose proof (Ge x ltac:(lra)). unfold K. lra.
Qed.
Theorem distance_velocities_agree i j : (i < n)%nat -> (j < n)%nat -> forall e, 0 < e -> exists T, 0 <= T /\ forall t, T <= t -> norm (v i t - v j t)%C < e.
Proof.
  intros Hi Hj e He. destruct spread_slow as [K [HK Slow]]. pose proof (INR_pos n Hn) as Pn. assert (P4 : 0 < INR n ^ 4) by now apply pow_lt.
  destruct (settles (fun t => energy t) (fun t => spread t)) with (e := e ^ 2) as [T [HT S]].
  - intros s t Hst. now apply energy_falls.
  - apply energy_ge0.
  - intros y Hy. set (h := y / (2 * K)). set (c := y / (4 * INR n ^ 4)).
    assert (Ph : 0 < h) by (apply Rdiv_lt_0_compat; lra). assert (Pc : 0 < c) by (apply Rdiv_lt_0_compat; lra).
    exists (c * h), h. split; [now apply Rmult_lt_0_compat|]. split; [exact Ph|]. intros t Ht G.
    assert (F : energy (t + h) + c * (t + h) <= energy t + c * t); [|lra].
    apply (right_decreasing (fun x => energy x + c * x) (fun x => - damping x + c)); [lra| | |].
    + intros x Hx. apply continuity_pt_plus; [apply energy_continuous; lra|].
      apply continuity_pt_mult; [apply continuity_pt_const; intros ? ?; reflexivity|apply derivable_continuous_pt, derivable_pt_id].
    + intros x Hx. apply (right_plus (fun x => energy x) (fun x => c * x)); [apply energy_right; lra|].
      apply right_of_derive. eapply D_eq; [apply D_scal, D_id|]. ring.
    + intros x Hx. pose proof (Slow t x ltac:(lra)) as Sx. pose proof (damping_le x ltac:(lra)) as Dx.
      assert (K * (x - t) <= y / 2). { apply Rle_trans with (K * h); [apply Rmult_le_compat_l; lra|]. unfold h. right. field. lra. }
      assert (Y : y / 2 <= 2 * INR n ^ 4 * damping x) by lra.
      apply (Rmult_le_compat_r (/ (2 * INR n ^ 4))) in Y; [|left; apply Rinv_0_lt_compat; lra].
      replace (y / 2 * / (2 * INR n ^ 4)) with c in Y by (unfold c; field; lra). replace (2 * INR n ^ 4 * damping x * / (2 * INR n ^ 4)) with (damping x) in Y by (field; lra). lra.
  - cbn. nra.
  - exists T. split; [exact HT|]. intros t Ht. specialize (S t Ht). apply Rnot_le_lt. intros G.
    assert (D : dist2 (v i t) (v j t) <= spread t).
    { apply Rle_trans with (Sum n (fun j => dist2 (v i t) (v j t))).
      - apply (Sum_term_le n (fun j => dist2 (v i t) (v j t))); [intros; apply dist2_ge0|exact Hj].
      - apply (Sum_term_le n (fun i => Sum n (fun j => dist2 (v i t) (v j t)))); [intros; apply Sum_ge0; intros; apply dist2_ge0|exact Hi]. }
    rewrite dist2_norm in D. assert (e ^ 2 <= norm (v i t - v j t)%C ^ 2) by (apply pow_incr; lra). lra.
Qed.
End Distance.
