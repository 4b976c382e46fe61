(* Clauses about solutions that exist, are unique or go to a limit, formalised from their words before the theorems were looked at; the
   theorems prove them. *)
From Coq Require Import Reals Lra Lia Relations Psatz Classical.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums paley_model paley_phase paley_laplacian tanner_energy.
From Flockproof Require tanner2_filippov tanner2_appendix tanner2_existence tanner2_unique tanner2_solutions tanner2_onward tanner2_approach.
From Flockproof Require paley_convergence paley_settling paley_formations paley_cycles audit_independent_paley audit_independent_tanner2.
Module P := audit_independent_paley.
Module T := audit_independent_tanner2.
Open Scope R_scope.

(* ---- Definition 4: R^n as the first n numbers of a sequence ---- *)
Fixpoint volume (n : nat) (a b : nat -> R) : R := match n with O => 1 | S m => volume m a b * (b m - a m) end.
Definition null (n : nat) (Z : (nat -> R) -> Prop) := forall e, 0 < e -> exists a b : nat -> nat -> R,
  (forall k i, (i < n)%nat -> a k i <= b k i) /\ (forall x, Z x -> exists k, forall i, (i < n)%nat -> a k i < x i < b k i) /\
  forall m, Sum m (fun k => volume n (a k) (b k)) <= e.
(* K[f](x): for every null set Z and every d > 0 in the closed convex hull of the values of f within d of x, off Z *)
Definition K (n : nat) (f : (nat -> R) -> nat -> R) (x z : nat -> R) := forall Z d e, null n Z -> 0 < d -> 0 < e ->
  exists m (c : nat -> R) (y : nat -> nat -> R), (forall k, (k < m)%nat -> 0 <= c k) /\ Sum m c = 1 /\
  (forall k, (k < m)%nat -> ~ Z (y k) /\ forall i, (i < n)%nat -> Rabs (y k i - x i) < d) /\
  forall i, (i < n)%nat -> Rabs (Sum m (fun k => c k * f (y k) i) - z i) < e.
Definition continuous_absolutely (b : R) (x : R -> R) := forall e, 0 < e -> exists d, 0 < d /\ forall m (p q : nat -> R),
  (forall k, (k < m)%nat -> 0 <= p k <= q k /\ q k <= b) -> (forall k, (S k < m)%nat -> q k <= p (S k)) ->
  Sum m (fun k => q k - p k) < d -> Sum m (fun k => Rabs (x (q k) - x (p k))) < e.
(* on every [0, b] *)
Definition solution4 (n : nat) (f : (nat -> R) -> nat -> R) (x : R -> nat -> R) :=
  forall b, 0 < b -> (forall i, (i < n)%nat -> continuous_absolutely b (fun t => x t i)) /\
  exists N, T.negligible N /\ forall t, 0 <= t <= b -> ~ N t -> exists z, K n f (x t) z /\ forall i, (i < n)%nat -> is_derive (fun s => x s i) t (z i).
(* tanner2.appA.def4 clause 2, the existence; measurable or not *)
Definition def4_2 : Prop := forall n (f : (nat -> R) -> nat -> R) M x0,
  (forall x y, (forall i, (i < n)%nat -> x i = y i) -> forall i, (i < n)%nat -> f x i = f y i) ->
  (forall x i, (i < n)%nat -> Rabs (f x i) <= M) -> exists x, (forall i, (i < n)%nat -> x 0 i = x0 i) /\ solution4 n f x.

(* ---- (10), solutions on [0, T) or for all t >= 0; at t = 0 the rates are those to the right ---- *)
Definition rate (z : R -> C) (t : R) (w : C) := forall e, 0 < e -> exists d, 0 < d /\ forall s, 0 <= s -> Rabs (s - t) < d ->
  Cmod (z s - z t - RtoC (s - t) * w)%C <= e * Rabs (s - t).
Definition continuous_absolutely_2 (b : R) (z : R -> C) := continuous_absolutely b (fun t => fst (z t)) /\ continuous_absolutely b (fun t => snd (z t)).
(* where agents coincide the law has no value, and nothing is asked *)
Definition solution10 n V' R0 (I : R -> Prop) (r v : nat -> R -> C) :=
  T.apart_at n complete (fun i => r i 0) /\
  (forall t i, I t -> (i < n)%nat -> rate (r i) t (v i t)) /\ (forall b i, I b -> (i < n)%nat -> continuous_absolutely_2 b (v i)) /\
  exists N, T.negligible N /\ forall t, I t -> ~ N t -> T.apart_at n complete (fun i => r i t) ->
    exists z, T.K10 n V' R0 (fun i => r i t) (fun i => v i t) z /\ forall i, (i < n)%nat -> rate (v i) t (z i).
Definition always (t : R) := 0 <= t.
Definition before (T t : R) := 0 <= t < T.
(* tanner2.eq10_exist clause 3: and the agents stay apart, so that something is asked at almost all times *)
Definition eq10_3 : Prop := forall n V V' R0 (r0 v0 : nat -> C), 0 < R0 -> T.potentials n complete V V' -> T.apart_at n complete r0 ->
  exists r v, solution10 n V' R0 always r v /\ (forall t, 0 <= t -> T.apart_at n complete (fun i => r i t)) /\
  forall i, (i < n)%nat -> r i 0 = r0 i /\ v i 0 = v0 i.
(* clause 4: on [0, T), if no such pair comes before T along one of them *)
Definition gradient_lipschitz (f : R -> R) := forall a : C, a <> 0%C -> exists d L, 0 < d /\ forall y z : C, y <> 0%C -> z <> 0%C -> Cmod (y - a)%C < d -> Cmod (z - a)%C < d ->
  Cmod (RtoC (f (Cmod y) / Cmod y) * y - RtoC (f (Cmod z) / Cmod z) * z)%C <= L * Cmod (y - z)%C.
Definition eq10_4 : Prop := forall n V V' R0 T r v q u, 0 < R0 -> T.potentials n complete V V' ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> i <> j -> gradient_lipschitz (V' i j)) ->
  solution10 n V' R0 (before T) r v -> solution10 n V' R0 (before T) q u -> (forall i, (i < n)%nat -> r i 0 = q i 0 /\ v i 0 = u i 0) ->
  (forall t i j, 0 <= t < T -> (i < n)%nat -> (j < n)%nat -> i <> j -> Cmod (r i t - r j t)%C = R0 -> inner (r i t - r j t)%C (v i t - v j t)%C <> 0) ->
  forall t i, 0 <= t < T -> (i < n)%nat -> r i t = q i t /\ v i t = u i t.
(* tanner2.thm2_vel clause 1, tanner2.arbswitch clause 2 (corrected) *)
Definition thm2_vel : Prop := forall n V V' R0 r v, 0 < R0 -> T.potentials n complete V V' -> solution10 n V' R0 always r v ->
  (forall t, 0 <= t -> strongly_connected n (T.by_distance (fun i => r i t) R0)) ->
  forall i j, (i < n)%nat -> (j < n)%nat -> T.to_zero (fun t => v i t - v j t)%C.
(* tanner2.thm2_pot clause 2 (corrected): near critical configurations in the end; the limits of the gradients at a configuration are finitely many *)
Definition limit_of_gradients n V' R0 (q y : nat -> C) := forall e, 0 < e -> exists p : nat -> C, (forall i, (i < n)%nat -> Cmod (p i - q i)%C < e) /\
  (forall i j, (i < n)%nat -> (j < n)%nat -> i <> j -> Cmod (p i - p j)%C <> R0) /\
  forall i, (i < n)%nat -> Cmod (T.gradV n (T.by_distance p R0) V' p i - y i)%C < e.
Definition critical n V' R0 (q : nat -> C) := T.apart_at n complete q /\ exists m (c : nat -> R) (y : nat -> nat -> C),
  (forall k, (k < m)%nat -> 0 <= c k /\ limit_of_gradients n V' R0 q (y k)) /\ Sum m c = 1 /\
  forall i, (i < n)%nat -> Csum m (fun k => RtoC (c k) * y k i)%C = 0%C.
Definition thm2_pot : Prop := forall n V V' R0 r v, 0 < R0 -> T.potentials n complete V V' -> solution10 n V' R0 always r v ->
  (forall t, 0 <= t -> strongly_connected n (T.by_distance (fun i => r i t) R0)) ->
  forall e, 0 < e -> exists S, 0 <= S /\ forall t, S <= t -> exists q, critical n V' R0 q /\ forall i, (i < n)%nat -> Cmod (r i t - q i)%C < e.

(* ---- beyond.paley.cyclic_patterns: neighbours on the ring ---- *)
Definition ring (n : nat) : graph := fun j k => (Nat.eqb k ((j + 1) mod n) || Nat.eqb j ((k + 1) mod n))%bool.
(* within d of a formation: centre c, first heading phi; r_k = c - i e^{i theta_k}/w0 *)
Definition pattern_within n (m : Z) w0 (r : nat -> C) (th : nat -> R) d := exists (c : C) phi, forall k, (k < n)%nat ->
  let e := expi (phi + 2 * PI * IZR m * INR k / INR n) in
  Cmod (expi (th k) - e)%C <= d /\ Cmod (r k - (c - RtoC (/ w0) * (Ci * e)))%C <= d.
Definition motion22 n w0 K0 K1 (r : nat -> R -> C) (th : nat -> R -> R) := forall t, 0 <= t ->
  P.particles n r th (P.u22 n (ring n) w0 K0 K1 (fun k => r k t) (fun k => th k t)) t.
Definition exponentially_stable n m w0 K0 K1 := exists d A q, 0 < d /\ 0 < A /\ 0 < q /\ forall r th, motion22 n w0 K0 K1 r th ->
  forall e, e <= d -> pattern_within n m w0 (fun k => r k 0) (fun k => th k 0) e ->
  forall t, 0 <= t -> pattern_within n m w0 (fun k => r k t) (fun k => th k t) (A * exp (- q * t) * e).
Definition unstable n m w0 K0 K1 := exists e, 0 < e /\ forall d, 0 < d -> exists r th, motion22 n w0 K0 K1 r th /\
  pattern_within n m w0 (fun k => r k 0) (fun k => th k 0) d /\ exists t, 0 <= t /\ ~ pattern_within n m w0 (fun k => r k t) (fun k => th k t) e.
Definition cyclic_1 : Prop := forall n m w0 K0 K1, (3 <= n)%nat -> w0 <> 0 -> 0 < K0 ->
  (exponentially_stable n m w0 K0 K1 <-> K1 * cos (2 * PI * IZR m / INR n) < 0).
Definition cyclic_2 : Prop := forall n m w0 K0 K1, (3 <= n)%nat -> w0 <> 0 -> 0 < K0 -> 0 < K1 * cos (2 * PI * IZR m / INR n) -> unstable n m w0 K0 K1.

(* ---- the theorems prove them ---- *)
Lemma volume_is n a b : volume n a b = tanner2_appendix.Product n (fun i => b i - a i).
Proof. induction n; [reflexivity|]. cbn. now rewrite IHn. Qed.
Lemma null_is n Z : null n Z -> tanner2_appendix.null n Z.
Proof.
  intros N e He. destruct (N e He) as (a & b & A & B & S). exists a, b. split; [exact A|]. split; [exact B|]. intros m.
  rewrite (Sum_ext m _ (fun k => volume n (a k) (b k))); [apply S|]. intros k _. symmetry. apply volume_is.
Qed.
Lemma K_is n f x z : (forall x y, (forall i, (i < n)%nat -> x i = y i) -> forall i, (i < n)%nat -> f x i = f y i) -> tanner2_appendix.K n f x z -> K n f x z.
Proof.
  intros _ H Z d e HZ Hd He. destruct (H d Z Hd (null_is n Z HZ) e He) as (m & c & y & A & S & L).
  assert (Pts : exists q : nat -> nat -> R, forall k, (k < m)%nat -> inclusions.near n d (q k) x /\ ~ Z (q k) /\ forall i, (i < n)%nat -> y k i = f (q k) i).
  { clear S L. induction m as [|m IH]; [exists (fun _ _ => 0); intros; lia|]. destruct IH as [q Q]; [intros k Hk; apply A; lia|].
    destruct (proj2 (A m ltac:(lia))) as [p Hp]. exists (fun k => if Nat.eqb k m then p else q k). intros k Hk. destruct (Nat.eqb_spec k m) as [->|Nk]; [exact Hp|apply Q; lia]. }
  destruct Pts as [q Q]. exists m, c, q. split; [intros k Hk; now apply A|]. split; [exact S|]. split.
  - intros k Hk. destruct (Q k Hk) as (Q1 & Q2 & _). split; [exact Q2|exact Q1].
  - intros i Hi. rewrite <- Rabs_Ropp. eapply Rle_lt_trans; [|apply (L i Hi)]. right. f_equal.
    rewrite (Sum_ext m (fun k => c k * f (q k) i) (fun k => c k * y k i)); [ring|]. intros k Hk. now rewrite (proj2 (proj2 (Q k Hk)) i Hi).
Qed.
Lemma def4_2_holds : def4_2.
Proof.
  intros n f M x0 E B. destruct (tanner2_existence.filippov_exists n f M x0 B) as (x & S & F). exists x. split; [exact S|]. intros b Hb.
  destruct (F (b + 1)) as (A & N & HN & D). split.
  - intros i Hi e He. now apply (A i Hi b e ltac:(lra)).
  - exists N. split; [exact HN|]. intros t Ht Nt. destruct (D t ltac:(lra) Nt) as (z & Hz & Dz). exists z. split; [now apply K_is|exact Dz].
Qed.

(* rates and derivatives *)
Lemma of_derivative f t l : is_derive f t l -> forall e, 0 < e -> exists d, 0 < d /\ forall s, Rabs (s - t) < d -> Rabs (f s - f t - (s - t) * l) <= e * Rabs (s - t).
Proof.
  intros D e He. apply is_derive_Reals in D. destruct (D e He) as [d Hd]. exists d. split; [apply cond_pos|]. intros s Hs. destruct (Req_dec s t) as [->|Ne].
  - replace (f t - f t - (t - t) * l) with 0 by ring. rewrite Rminus_diag_eq, Rabs_R0 by reflexivity. lra.
  - specialize (Hd (s - t) ltac:(lra) Hs). replace (t + (s - t)) with s in Hd by ring.
    replace (f s - f t - (s - t) * l) with (((f s - f t) / (s - t) - l) * (s - t)) by (field; lra). rewrite Rabs_mult. apply Rmult_le_compat_r; [apply Rabs_pos|lra].
Qed.
Lemma to_derivative f t l : (forall e, 0 < e -> exists d, 0 < d /\ forall s, Rabs (s - t) < d -> Rabs (f s - f t - (s - t) * l) <= e * Rabs (s - t)) -> is_derive f t l.
Proof.
  intros H. apply is_derive_Reals. intros e He. destruct (H (e / 2) ltac:(lra)) as (d & Hd & L). exists (mkposreal d Hd). intros h Nh Hh. cbn in Hh.
  specialize (L (t + h)). replace (t + h - t) with h in L by ring. specialize (L Hh). replace ((f (t + h) - f t) / h - l) with ((f (t + h) - f t - h * l) / h) by (field; exact Nh).
  unfold Rdiv at 1. rewrite Rabs_mult, Rabs_inv. pose proof (Rabs_pos_lt h Nh) as Ph. apply Rle_lt_trans with (e / 2); [|lra].
  apply Rmult_le_reg_r with (Rabs h); [exact Ph|]. rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra. exact L.
Qed.
Lemma parts z : Rabs (fst z) <= Cmod z /\ Rabs (snd z) <= Cmod z.
Proof. pose proof (Rmax_Cmod z) as H. split; eapply Rle_trans; [apply Rmax_l|exact H|apply Rmax_r|exact H]. Qed.
Lemma to_velocity z t w : (forall e, 0 < e -> exists d, 0 < d /\ forall s, Rabs (s - t) < d -> Cmod (z s - z t - RtoC (s - t) * w)%C <= e * Rabs (s - t)) -> is_velocity z t w.
Proof.
  intros H. split; apply to_derivative; intros e He; destruct (H e He) as (d & Hd & L); exists d; (split; [exact Hd|]); intros s Hs; eapply Rle_trans; [|apply L, Hs| |apply L, Hs].
  - eapply Rle_trans; [|apply (proj1 (parts _))]. right. f_equal. cbn. ring.
  - eapply Rle_trans; [|apply (proj2 (parts _))]. right. f_equal. cbn. ring.
Qed.
Lemma of_velocity z t w : is_velocity z t w -> forall e, 0 < e -> exists d, 0 < d /\ forall s, Rabs (s - t) < d -> Cmod (z s - z t - RtoC (s - t) * w)%C <= e * Rabs (s - t).
Proof.
  intros [A B] e He. destruct (of_derivative _ _ _ A (e / 2) ltac:(lra)) as (d1 & H1 & L1). destruct (of_derivative _ _ _ B (e / 2) ltac:(lra)) as (d2 & H2 & L2).
  exists (Rmin d1 d2). split; [now apply Rmin_glb_lt|]. intros s Hs. pose proof (Rmin_l d1 d2) as M1. pose proof (Rmin_r d1 d2) as M2.
  specialize (L1 s ltac:(lra)). specialize (L2 s ltac:(lra)). eapply Rle_trans; [apply paley_convergence.Cmod_le|].
  replace (fst _) with (fst (z s) - fst (z t) - (s - t) * fst w) by (cbn; ring). replace (snd _) with (snd (z s) - snd (z t) - (s - t) * snd w) by (cbn; ring). lra.
Qed.
Lemma velocity_rate z t w : is_velocity z t w -> rate z t w.
Proof. intros H e He. destruct (of_velocity z t w H e He) as (d & Hd & L). exists d. split; [exact Hd|]. intros s _. apply L. Qed.
(* before 0 with the velocity at 0 *)
Definition back (z : R -> C) (w : C) (t : R) : C := if Rlt_dec t 0 then (z 0 + RtoC t * w)%C else z t.
Lemma back_is z w t : 0 <= t -> back z w t = z t.
Proof. intros H. unfold back. destruct (Rlt_dec t 0); [lra|reflexivity]. Qed.
Lemma back_rate z w0 t w : 0 < t \/ t = 0 /\ w = w0 -> rate z t w -> 0 <= t -> is_velocity (back z w0) t w.
Proof.
  intros H R0 Ht. apply to_velocity. intros e He. destruct (R0 e He) as (d & Hd & L). destruct H as [H|[-> ->]].
  - exists (Rmin d t). split; [now apply Rmin_glb_lt|]. intros s Hs. pose proof (Rmin_l d t) as M1. pose proof (Rmin_r d t) as M2.
    assert (0 <= s) by (apply Rabs_def2 in Hs; lra). rewrite !back_is by lra. apply L; lra.
  - exists d. split; [exact Hd|]. intros s Hs. rewrite (back_is z w0 0) by lra. destruct (Rlt_dec s 0) as [N|N].
    + unfold back. destruct (Rlt_dec s 0); [|lra]. replace (_ - _ - _)%C with (RtoC 0); [rewrite Cmod_0; apply Rmult_le_pos; [lra|apply Rabs_pos]|].
      apply injective_projections; cbn; ring.
    + rewrite back_is by lra. apply L; lra.
Qed.
Lemma ac_joined b z : continuous_absolutely_2 b z -> forall e, 0 < e -> exists d, 0 < d /\ forall m (p q : nat -> R),
  (forall k, (k < m)%nat -> 0 <= p k <= q k /\ q k <= b) -> (forall k, (S k < m)%nat -> q k <= p (S k)) ->
  Sum m (fun k => q k - p k) < d -> Sum m (fun k => Cmod (z (q k) - z (p k))%C) < e.
Proof.
  intros [A B] e He. destruct (A (e / 2) ltac:(lra)) as (d1 & H1 & L1). destruct (B (e / 2) ltac:(lra)) as (d2 & H2 & L2).
  exists (Rmin d1 d2). split; [now apply Rmin_glb_lt|]. intros m p q P1 P2 P3. pose proof (Rmin_l d1 d2) as M1. pose proof (Rmin_r d1 d2) as M2.
  specialize (L1 m p q P1 P2 ltac:(lra)). specialize (L2 m p q P1 P2 ltac:(lra)).
  apply Rle_lt_trans with (Sum m (fun k => Rabs (fst (z (q k)) - fst (z (p k)))) + Sum m (fun k => Rabs (snd (z (q k)) - snd (z (p k))))); [|lra].
  rewrite <- Sum_plus. apply Sum_le. intros k _. apply (paley_convergence.Cmod_le (z (q k) - z (p k))%C).
Qed.
Lemma ac_split b z : (forall e, 0 < e -> exists d, 0 < d /\ forall m (p q : nat -> R),
  (forall k, (k < m)%nat -> 0 <= p k <= q k /\ q k <= b) -> (forall k, (S k < m)%nat -> q k <= p (S k)) ->
  Sum m (fun k => q k - p k) < d -> Sum m (fun k => Cmod (z (q k) - z (p k))%C) < e) -> continuous_absolutely_2 b z.
Proof.
  intros H. split; intros e He; destruct (H e He) as (d & Hd & L); exists d; (split; [exact Hd|]); intros m p q P1 P2 P3;
    (eapply Rle_lt_trans; [|apply (L m p q P1 P2 P3)]); apply Sum_le; intros k _; [apply (proj1 (parts (z (q k) - z (p k))%C))|apply (proj2 (parts (z (q k) - z (p k))%C))].
Qed.
Lemma zero_negligible : T.negligible (fun t => t = 0).
Proof. apply (tanner2_filippov.negligible_isolated (fun t => t = 0)). intros t ->. split; [lra|]. exists 1. split; [lra|]. intros s -> _. reflexivity. Qed.
(* K10 depends on the state of the n agents only *)
Lemma until_is n V' R0 S r v : solution10 n V' R0 (before S) r v ->
  T.motion10_until S n V' R0 (fun i => back (r i) (v i 0)) (fun i => back (v i) 0%C).
Proof.
  intros (A & D & C1 & N & HN & F). assert (Z : forall (z : nat -> R -> C) (w : nat -> C) t, 0 <= t -> (fun i => back (z i) (w i) t) = (fun i => z i t)).
  { intros z w t Ht. apply FunctionalExtensionality.functional_extensionality. intros i. now apply back_is. }
  split; [|split; [|split]].
  - now rewrite (Z r (fun i => v i 0) 0 ltac:(lra)).
  - intros t i Ht Hi. cbv beta. rewrite back_is by lra. apply back_rate; [|apply D; assumption|lra]. destruct (Req_dec t 0) as [->|Ne]; [right; now split|left; lra].
  - intros i Hi b e Hb He. destruct (ac_joined b (v i) (C1 b i ltac:(split; lra) Hi) e He) as (d & Hd & L). exists d. split; [exact Hd|]. intros m p q P1 P2 P3.
    eapply Rle_lt_trans; [|apply (L m p q P1 P2 P3)]. right. apply Sum_ext. intros k Hk. destruct (P1 k Hk). rewrite !back_is by lra. reflexivity.
  - exists (fun t => N t \/ t = 0). split; [apply tanner2_filippov.negligible_or; [exact HN|exact zero_negligible]|]. intros t Ht Nt At.
    rewrite (Z r (fun i => v i 0) t ltac:(lra)) in At. destruct (F t Ht ltac:(tauto) At) as (z & Hz & Dz). exists z.
    rewrite (Z r (fun i => v i 0) t ltac:(lra)), (Z v (fun _ => 0%C) t ltac:(lra)). split; [exact Hz|]. intros i Hi. apply back_rate; [left; tauto || (assert (t <> 0) by tauto; lra)|now apply Dz|lra].
Qed.
Lemma always_is n V' R0 r v : solution10 n V' R0 always r v -> T.motion10 n V' R0 (fun i => back (r i) (v i 0)) (fun i => back (v i) 0%C).
Proof.
  intros (A & D & C1 & N & HN & F). assert (Z : forall (z : nat -> R -> C) (w : nat -> C) t, 0 <= t -> (fun i => back (z i) (w i) t) = (fun i => z i t)).
  { intros z w t Ht. apply FunctionalExtensionality.functional_extensionality. intros i. now apply back_is. }
  split; [|split; [|split]].
  - now rewrite (Z r (fun i => v i 0) 0 ltac:(lra)).
  - intros t i Ht Hi. cbv beta. rewrite back_is by lra. apply back_rate; [|apply D; assumption|lra]. destruct (Req_dec t 0) as [->|Ne]; [right; now split|left; lra].
  - intros i Hi b e Hb He. destruct (ac_joined b (v i) (C1 b i ltac:(unfold always; lra) Hi) e He) as (d & Hd & L). exists d. split; [exact Hd|]. intros m p q P1 P2 P3.
    eapply Rle_lt_trans; [|apply (L m p q P1 P2 P3)]. right. apply Sum_ext. intros k Hk. destruct (P1 k Hk). rewrite !back_is by lra. reflexivity.
  - exists (fun t => N t \/ t = 0). split; [apply tanner2_filippov.negligible_or; [exact HN|exact zero_negligible]|]. intros t Ht Nt At.
    rewrite (Z r (fun i => v i 0) t ltac:(lra)) in At. destruct (F t Ht ltac:(tauto) At) as (z & Hz & Dz). exists z.
    rewrite (Z r (fun i => v i 0) t ltac:(lra)), (Z v (fun _ => 0%C) t ltac:(lra)). split; [exact Hz|]. intros i Hi. apply back_rate; [left; assert (t <> 0) by tauto; lra|now apply Dz|lra].
Qed.
Lemma of_motion10 n V' R0 r v : T.motion10 n V' R0 r v -> solution10 n V' R0 always r v.
Proof.
  intros (A & D & C1 & N & HN & F). split; [exact A|]. split; [intros t i Ht Hi; apply velocity_rate; now apply D|]. split.
  - intros b i Hb Hi. unfold always in Hb. apply ac_split. intros e He. destruct (C1 i Hi (b + 1) e ltac:(lra) He) as (d & Hd & L). exists d. split; [exact Hd|].
    intros m p q P1 P2 P3. apply (L m p q); [|exact P2|exact P3]. intros k Hk. destruct (P1 k Hk). split; [assumption|lra].
  - exists N. split; [exact HN|]. intros t Ht Nt At. destruct (F t Ht Nt At) as (z & Hz & Dz). exists z. split; [exact Hz|]. intros i Hi. apply velocity_rate. now apply Dz.
Qed.
Lemma eq10_3_holds : eq10_3.
Proof.
  intros n V V' R0 r0 v0 HR P A. destruct (tanner2_solutions.solution_from n V V' R0 r0 v0 HR P A) as (r & v & S & M). exists r, v. split; [now apply of_motion10|]. split; [|exact S].
  destruct (tanner2_filippov.kept_apart n V V' R0 r v HR P M) as (d & Hd & Far). intros t Ht i j Hi Hj B E. unfold complete in B.
  assert (Ne : i <> j) by (intros ->; now rewrite PeanoNat.Nat.eqb_refl in B). specialize (Far t i j Ht Hi Hj Ne). cbv beta in E. rewrite E in Far.
  replace (r j t - r j t)%C with (RtoC 0) in Far by ring. rewrite Cmod_0 in Far. lra.
Qed.
Lemma eq10_4_holds : eq10_4.
Proof.
  intros n V V' R0 S r v q u HR P L M1 M2 E Tie t i Ht Hi. assert (Lip : tanner2_unique.lipschitz_gradients n V').
  { intros j k Hj Hk Ne a Na. destruct (L j k Hj Hk Ne a Na) as (d & B & Hd & HB). assert (Pa : 0 < Cmod a) by now apply Cmod_gt_0.
    exists (Rmin d (Cmod a)), (Rabs B + 1). split; [now apply Rmin_glb_lt|]. split; [pose proof (Rabs_pos B); lra|]. intros z y Hz Hy.
    pose proof (Rmin_l d (Cmod a)) as M3. pose proof (Rmin_r d (Cmod a)) as M4.
    assert (N0 : forall x : C, Cmod (x - a)%C < Rmin d (Cmod a) -> x <> 0%C).
    { intros x Hx ->. replace (0 - a)%C with (- a)%C in Hx by ring. rewrite Cmod_opp in Hx. lra. }
    unfold tanner2_unique.pair_gradient. eapply Rle_trans; [apply (HB z y (N0 z Hz) (N0 y Hy)); lra|]. apply Rmult_le_compat_r; [apply Cmod_ge_0|]. pose proof (Rle_abs B); lra. }
  destruct (tanner2_unique.unique_across n V V' R0 S _ _ _ _ HR P Lip (until_is _ _ _ _ _ _ M1) (until_is _ _ _ _ _ _ M2)) with (t := t) (i := i) as [Er Ev]; try assumption.
  - intros j Hj. rewrite !back_is by lra. now apply E.
  - intros s j k Hs Hj Hk Ne. rewrite !back_is by lra. now apply Tie.
  - rewrite !back_is in Er, Ev by lra. now split.
Qed.
Lemma graph_is n R0 (r v : nat -> R -> C) : (forall t, 0 <= t -> strongly_connected n (T.by_distance (fun i => r i t) R0)) ->
  forall t, 0 <= t -> strongly_connected n (T.by_distance (fun i => back (r i) (v i 0) t) R0).
Proof.
  intros C1 t Ht. replace (fun i => back (r i) (v i 0) t) with (fun i => r i t); [now apply C1|]. apply FunctionalExtensionality.functional_extensionality. intros i. symmetry. now apply back_is.
Qed.
Lemma thm2_vel_holds : thm2_vel.
Proof.
  intros n V V' R0 r v HR P M C1 i j Hi Hj e He. destruct (tanner2_onward.all_solutions_agree n V V' R0 HR P) as [_ H].
  destruct (H _ _ (always_is _ _ _ _ _ M) (graph_is n R0 r v C1) i j Hi Hj e He) as [S HS]. exists (Rmax S 0). intros t Ht. pose proof (Rmax_l S 0) as M1. pose proof (Rmax_r S 0) as M2.
  specialize (HS t ltac:(lra)). cbv beta in HS. now rewrite !back_is in HS by lra.
Qed.
Lemma thm2_pot_holds : thm2_pot.
Proof.
  intros n V V' R0 r v HR P M C1 e He. destruct (tanner2_approach.all_solutions_approach n V V' R0 HR P) as [_ [H _]].
  destruct (H _ _ (always_is _ _ _ _ _ M) (graph_is n R0 r v C1) e He) as [S HS]. exists (Rmax S 0). split; [apply Rmax_r|]. intros t Ht. pose proof (Rmax_l S 0) as M1. pose proof (Rmax_r S 0) as M2.
  destruct (HS t ltac:(lra)) as (q & [Aq (m & c & y & Y1 & Y2 & Y3)] & D). exists q. split.
  - split; [exact Aq|]. exists m, c, y. split; [exact Y1|]. split; [exact Y2|]. intros i Hi. symmetry. now apply Y3.
  - intros i Hi. specialize (D i Hi). cbv beta in D. now rewrite back_is in D by lra.
Qed.
