(* Paley et al., symmetric patterns: the moments (23), U_m and W_m, Theorem 3 (global minimisers of (25) are exactly
   the (M,N)-patterns; the converse recovers the cluster sizes by inverting a discrete Fourier transform), and the
   rhombus: an eigenvector e^{i theta} of K_4 or C_12 that is no symmetric pattern. *)
From Coq Require Import Reals Lra Lia Psatz ZArith.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums paley_model paley_phase paley_laplacian paley_gradient paley_fourier.
Open Scope R_scope.

(* M clusters at th0 + 2 pi l / M, each with N/M of the phases *)
Definition pattern (M n : nat) (th : nat -> R) : Prop := (1 <= M)%nat /\ exists (th0 : R) (cl : nat -> nat),
  (forall k, (k < n)%nat -> (cl k < M)%nat /\ expi (th k) = expi (th0 + 2 * PI * INR (cl k) / INR M)) /\
  (forall l, (l < M)%nat -> INR M * Sum n (fun k => delta (cl k) l) = INR n).
Definition moment (n m : nat) (th : nat -> R) : C := (RtoC (/ (INR m * INR n)) * Csum n (fun k => expi (INR m * th k)))%C.  (* (23) *)
Definition Um (n m : nat) (th : nat -> R) : R := INR n / 2 * Cmod (moment n m th) ^ 2.            (* (24) *)
Definition Wm (n : nat) (adj : graph) (m : nat) (th : nat -> R) : R :=
  Q n (lap n adj) (fun k => RtoC (/ INR m) * expi (INR m * th k))%C.
Definition multiple (m : nat) (th : nat -> R) (k : nat) : R := INR m * th k.

Lemma moment_order n m th : (1 <= n)%nat -> (1 <= m)%nat -> moment n m th = (RtoC (/ INR m) * order n (multiple m th))%C.
Proof.
  intros Hn Hm. pose proof (INR_pos n Hn). pose proof (INR_pos m Hm). unfold moment, order.
  change (Csum n (phasors (multiple m th))) with (Csum n (fun k => expi (INR m * th k))).
  rewrite Rinv_mult, Cmult_assoc. f_equal. apply injective_projections; cbn; ring.
Qed.
Lemma Um_U1 n m th : (1 <= n)%nat -> (1 <= m)%nat -> Um n m th = / INR m ^ 2 * U1 n (multiple m th).
Proof.
  intros Hn Hm. pose proof (INR_pos m Hm). unfold Um, U1. rewrite moment_order, Cmod_mult, Cmod_R by assumption.
  rewrite Rabs_pos_eq; [field; lra|]. left. now apply Rinv_0_lt_compat.
Qed.
Lemma moment_0 n m th : (1 <= n)%nat -> (1 <= m)%nat -> (moment n m th = RtoC 0 <-> balanced n (multiple m th)).
Proof.
  intros Hn Hm. pose proof (INR_pos m Hm). rewrite moment_order by assumption. unfold balanced. split; intros E.
  - destruct (Ceq_dec (order n (multiple m th)) (RtoC 0)) as [Z|Z]; [exact Z|exfalso]. revert E. apply Cmult_neq_0; [|exact Z].
    intros F. injection F as F. apply (Rinv_neq_0_compat (INR m)); lra.
  - rewrite E. apply Cmult_0_r.
Qed.

(* ---- W_m and U_m ---- *)
Theorem Wm_corrected n m th : (1 <= n)%nat -> (1 <= m)%nat -> Wm n complete m th = INR n / (2 * INR m ^ 2) - Um n m th.
Proof.
  intros Hn Hm. pose proof (INR_pos m Hm). rewrite Um_U1 by assumption.
  pose proof (eq13 n (multiple m th) Hn) as E. unfold W1 in E. unfold Wm.
  transitivity (/ INR m ^ 2 * Q n (lap n complete) (phasors (multiple m th))); [|rewrite E; field; lra].
  unfold Q. rewrite <- Rmult_assoc, (Rmult_comm (/ INR m ^ 2)), Rmult_assoc. f_equal.
  rewrite <- (Sum_scal n (/ INR m ^ 2)). apply Sum_ext; intros k _.
  rewrite !inner_row, <- Sum_scal. apply Sum_ext; intros j _. rewrite inner_scal, inner_sym, inner_scal, inner_sym.
  unfold phasors, multiple. field. lra.
Qed.
(* the printed N/2 - U_m is wrong for every m >= 2, every N and every theta *)
Theorem Wm_printed_fails n m th : (1 <= n)%nat -> (2 <= m)%nat -> Wm n complete m th <> INR n / 2 - Um n m th.
Proof.
  intros Hn Hm E. rewrite Wm_corrected in E by lia. pose proof (INR_pos n Hn). apply le_INR in Hm. cbn in Hm.
  assert (F : INR n / (2 * INR m ^ 2) = INR n / 2) by lra. apply (Rmult_eq_compat_l (2 / INR n)) in F.
  assert (G : / INR m ^ 2 = 1) by (transitivity (2 / INR n * (INR n / (2 * INR m ^ 2))); [field; lra|rewrite F; field; lra]).
  assert (INR m ^ 2 = 1); [|nra]. rewrite <- (Rinv_inv (INR m ^ 2)), G. apply Rinv_1.
Qed.
Theorem Um_extremes n m th : (1 <= n)%nat -> (1 <= m)%nat ->
  0 <= Um n m th <= INR n / (2 * INR m ^ 2) /\ (Um n m th = 0 <-> moment n m th = RtoC 0) /\
  (Um n m th = INR n / (2 * INR m ^ 2) <-> forall j k, (j < n)%nat -> (k < n)%nat -> exists z : Z, INR m * (th j - th k) = 2 * PI * IZR z).
Proof.
  intros Hn Hm. pose proof (INR_pos m Hm) as P. rewrite Um_U1, moment_0 by assumption.
  destruct (U1_max n (multiple m th) Hn) as [B E]. destruct (U1_min n (multiple m th) Hn) as [B0 E0].
  assert (F : 0 < / INR m ^ 2) by (apply Rinv_0_lt_compat; nra).
  replace (INR n / (2 * INR m ^ 2)) with (/ INR m ^ 2 * (INR n / 2)) by (field; lra).
  split; [split; [apply Rmult_le_pos; lra|apply Rmult_le_compat_l; lra]|]. split.
  - rewrite <- E0. split; intros H; [|rewrite H; ring]. apply Rmult_integral in H as [H|H]; [lra|exact H].
  - assert (T : / INR m ^ 2 * U1 n (multiple m th) = / INR m ^ 2 * (INR n / 2) <-> U1 n (multiple m th) = INR n / 2).
    { split; intros H; [apply (Rmult_eq_reg_l (/ INR m ^ 2)); lra|now rewrite H]. }
    rewrite T, E. split; intros H j k Hj Hk.
    + apply expi_one. rewrite Rmult_minus_distr_l. apply expi_inj_minus. now apply H.
    + destruct (H j k Hj Hk) as [z Hz]. unfold multiple. replace (INR m * th j) with (INR m * (th j - th k) + INR m * th k) by ring.
      rewrite expi_plus, Hz, expi_2PI. apply Cmult_1_l.
Qed.
(* a stationary point of U_m is never isolated: it can be turned as a whole *)
Lemma partial_rotation n th k a d : (1 <= n)%nat -> partial (U1 n) th k d -> partial (U1 n) (fun j => th j + a) k d.
Proof.
  intros Hn H. unfold partial in *.
  apply (is_derive_ext (fun s => U1 n (upd th k (s - a)))).
  - intros s. rewrite <- (U1_rotation n (upd th k (s - a)) a Hn). unfold upd.
    rewrite !U1_pairs by assumption. f_equal. unfold cos_pairs. apply Sum_ext; intros i _; apply Sum_ext; intros j _.
    destruct (Nat.eqb i k), (Nat.eqb j k); do 2 f_equal; ring.
  - eapply D_eq; [apply (D_comp (fun s => U1 n (upd th k s)) (fun s => s - a) (th k + a) d 1)|ring].
    + replace (th k + a - a) with (th k) by ring. exact H.
    + eapply D_eq; [apply D_minus; [apply D_id|apply D_const]|ring].
Qed.

(* ---- the moments of a pattern ---- *)
Lemma fibres n M (cl : nat -> nat) (f : nat -> R) : (forall k, (k < n)%nat -> (cl k < M)%nat) ->
  Sum n (fun k => f (cl k)) = Sum M (fun l => Sum n (fun k => delta (cl k) l) * f l).
Proof.
  intros H. rewrite (Sum_ext M _ (fun l => Sum n (fun k => delta (cl k) l * f l))) by (intros; now rewrite Sum_scal_r).
  rewrite Sum_swap. apply Sum_ext; intros k Hk. symmetry. apply (Sum_delta_l M (cl k) f). now apply H.
Qed.
Lemma Cfibres n M (cl : nat -> nat) (f : nat -> C) : (forall k, (k < n)%nat -> (cl k < M)%nat) ->
  Csum n (fun k => f (cl k)) = Csum M (fun l => RtoC (Sum n (fun k => delta (cl k) l)) * f l)%C.
Proof.
  intros H. unfold Csum. f_equal.
  - rewrite (fibres n M cl (fun l => fst (f l)) H). apply Sum_ext; intros; cbn; ring.
  - rewrite (fibres n M cl (fun l => snd (f l)) H). apply Sum_ext; intros; cbn; ring.
Qed.
Lemma cluster_moments n M th th0 cl m : (1 <= M)%nat ->
  (forall k, (k < n)%nat -> (cl k < M)%nat /\ expi (th k) = expi (th0 + 2 * PI * INR (cl k) / INR M)) ->
  Csum n (fun k => expi (INR m * th k)) = (expi (INR m * th0) *
    Csum M (fun l => RtoC (Sum n (fun k => delta (cl k) l)) * expi (INR l * (2 * PI * IZR (Z.of_nat m) / INR M))))%C.
Proof.
  intros HM H. pose proof (INR_pos M HM). rewrite <- Csum_scal.
  rewrite (Csum_ext n _ (fun k => expi (INR m * th0 + INR (cl k) * (2 * PI * IZR (Z.of_nat m) / INR M)))).
  - rewrite (Cfibres n M cl (fun l => expi (INR m * th0 + INR l * (2 * PI * IZR (Z.of_nat m) / INR M)))) by (intros; now apply H).
    apply Csum_ext; intros l _. rewrite expi_plus. ring.
  - intros k Hk. rewrite (expi_mult_nat m _ _ (proj2 (H k Hk))), <- INR_IZR_INZ. f_equal. field. lra.
Qed.
Theorem eq23 M n th : (1 <= n)%nat -> pattern M n th ->
  (forall m, (1 <= m < M)%nat -> moment n m th = RtoC 0) /\ INR M * Cmod (moment n M th) = 1.
Proof.
  intros Hn [HM [th0 [cl [H1 H2]]]]. pose proof (INR_pos n Hn). pose proof (INR_pos M HM). split.
  - intros m Hm. unfold moment. rewrite (cluster_moments n M th th0 cl m HM H1).
    rewrite (Csum_ext M _ (fun l => RtoC (INR n / INR M) * expi (INR l * (2 * PI * IZR (Z.of_nat m) / INR M)))%C).
    + rewrite Csum_scal, roots_sum; [rewrite !Cmult_0_r; reflexivity|assumption|]. intros [q Hq].
      destruct (Z_le_dec q 0); [|assert (1 <= q)%Z by lia]; nia.
    + intros l Hl. f_equal. f_equal. apply (Rmult_eq_reg_l (INR M)); [|lra]. rewrite (H2 l Hl). field. lra.
  - assert (E : moment n M th = (RtoC (/ INR M) * expi (INR M * th0))%C).
    { unfold moment. rewrite (Csum_ext n _ (fun _ => expi (INR M * th0))).
      - rewrite Csum_const. apply injective_projections; cbn; field; lra.
      - intros k Hk. rewrite (expi_mult_nat M _ _ (proj2 (H1 k Hk))).
        replace (INR M * (th0 + 2 * PI * INR (cl k) / INR M)) with (2 * PI * IZR (Z.of_nat (cl k)) + INR M * th0) by (rewrite <- INR_IZR_INZ; field; lra).
        rewrite expi_plus, expi_2PI. apply Cmult_1_l. }
    rewrite E, Cmod_mult, Cmod_expi, Cmod_R, Rabs_pos_eq by (left; now apply Rinv_0_lt_compat). field. lra.
Qed.
Theorem pattern_balanced M n th : (1 <= n)%nat -> (2 <= M)%nat -> pattern M n th -> balanced n th.
Proof.
  intros Hn HM P. destruct (eq23 M n th Hn P) as [Z _]. specialize (Z 1%nat ltac:(lia)). apply moment_0 in Z; try lia.
  unfold balanced, order in *. rewrite <- Z. f_equal. apply Csum_ext; intros k _. unfold phasors, multiple. cbn [INR]. now rewrite Rmult_1_l.
Qed.

(* the moments determine the pattern *)
Lemma finite_choice (n : nat) (P : nat -> nat -> Prop) : (forall k, (k < n)%nat -> exists x, P k x) ->
  exists f, forall k, (k < n)%nat -> P k (f k).
Proof.
  induction n as [|n IH]; intros H; [exists (fun _ => 0%nat); intros; lia|]. destruct IH as [f Hf]; [intros; apply H; lia|].
  destruct (H n ltac:(lia)) as [x Hx]. exists (fun k => if Nat.eqb k n then x else f k). intros k Hk.
  destruct (Nat.eqb_spec k n) as [->|]; [exact Hx|apply Hf; lia].
Qed.
Theorem moments_pattern M n th : (1 <= n)%nat -> (1 <= M)%nat -> (forall m, (1 <= m < M)%nat -> moment n m th = RtoC 0) ->
  synchronized n (multiple M th) -> pattern M n th.
Proof.
  intros Hn HM Z S. pose proof (INR_pos n Hn) as Pn. pose proof (INR_pos M HM) as PM. split; [assumption|]. exists (th 0%nat).
  destruct (finite_choice n (fun k x => (x < M)%nat /\ expi (th k) = expi (th 0%nat + 2 * PI * INR x / INR M))) as [cl Hcl].
  { intros k Hk. pose proof (S k 0%nat Hk ltac:(lia)) as E. unfold multiple in E. apply expi_inj_minus, expi_one in E as [z Hz].
    exists (Z.to_nat (z mod Z.of_nat M)). pose proof (Z.mod_pos_bound z (Z.of_nat M) ltac:(lia)) as B.
    split; [lia|]. rewrite INR_IZR_INZ, Z2Nat.id by lia.
    assert (T : th k = 2 * PI * IZR (z / Z.of_nat M) + (th 0%nat + 2 * PI * IZR (z mod Z.of_nat M) / INR M)).
    { apply (Rmult_eq_reg_l (INR M)); [|lra]. pose proof (Z.div_mod z (Z.of_nat M) ltac:(lia)) as DM.
      apply (f_equal IZR) in DM. rewrite plus_IZR, mult_IZR, <- INR_IZR_INZ in DM.
      transitivity (INR M * th 0%nat + 2 * PI * IZR z); [lra|]. rewrite DM. field. lra. }
    rewrite T, expi_plus, expi_2PI. apply Cmult_1_l. }
  exists cl. split; [exact Hcl|]. set (c := fun l => Sum n (fun k => delta (cl k) l)).
  (* the transform of the cluster sizes vanishes but at 0 *)
  assert (F : forall m, (1 <= m < M)%nat -> Csum M (fun l => RtoC (c l) * expi (INR l * (2 * PI * IZR (Z.of_nat m) / INR M)))%C = RtoC 0).
  { intros m Hm. pose proof (Z m Hm) as E. unfold moment in E. rewrite (cluster_moments n M th (th 0%nat) cl m HM Hcl) in E.
    set (X := Csum M _) in *. destruct (Ceq_dec X (RtoC 0)) as [G|G]; [exact G|exfalso]. revert E.
    apply Cmult_neq_0; [|apply Cmult_neq_0; [apply expi_neq0|exact G]].
    pose proof (INR_pos m ltac:(lia)). intros E. injection E as E. apply (Rinv_neq_0_compat (INR m * INR n)); [nra|exact E]. }
  assert (F0 : Csum M (fun l => RtoC (c l) * expi (INR l * (2 * PI * IZR (Z.of_nat 0) / INR M)))%C = RtoC (INR n)).
  { rewrite (Csum_ext M _ (fun l => RtoC (c l) * RtoC 1)%C).
    - assert (E : Csum n (fun _ => RtoC 1) = Csum M (fun l => RtoC (c l) * RtoC 1)%C)
        by exact (Cfibres n M cl (fun _ => RtoC 1) (fun k Hk => proj1 (Hcl k Hk))). rewrite <- E.
      rewrite Csum_const. apply Cmult_1_r.
    - intros l _. f_equal. rewrite <- expi_0. f_equal. cbn [Z.of_nat]. field. lra. }
  intros l0 Hl0. change (INR M * c l0 = INR n).
  assert (I : Csum M (fun m => expi (INR m * (2 * PI * IZR (- Z.of_nat l0) / INR M)) *
      Csum M (fun l => RtoC (c l) * expi (INR l * (2 * PI * IZR (Z.of_nat m) / INR M))))%C = RtoC (INR n)).
  { destruct M as [|M']; [lia|]. clear - F F0 HM.
    assert (G : forall q, (q <= M')%nat -> Csum (Datatypes.S q) (fun m => expi (INR m * (2 * PI * IZR (- Z.of_nat l0) / INR (Datatypes.S M'))) *
      Csum (Datatypes.S M') (fun l => RtoC (c l) * expi (INR l * (2 * PI * IZR (Z.of_nat m) / INR (Datatypes.S M')))))%C = RtoC (INR n)).
    { induction q as [|q IH]; intros Hq.
      - rewrite Csum_S, F0. change (INR 0) with 0. rewrite Rmult_0_l, expi_0. apply injective_projections; cbn; ring.
      - rewrite Csum_S, IH, F by lia. rewrite Cmult_0_r. apply Cplus_0_r. }
    apply G; lia. }
  rewrite (Csum_ext M _ (fun m => Csum M (fun l => RtoC (c l) * expi (INR m * (2 * PI * IZR (Z.of_nat l - Z.of_nat l0) / INR M))))%C) in I.
  - rewrite Csum_swap in I. rewrite (Csum_ext M _ (fun l => RtoC (delta l l0 * (INR M * c l0)))) in I.
    + injection I as I. rewrite (Sum_delta M l0 (fun _ => INR M * c l0) Hl0) in I. exact I.
    + intros l Hl. rewrite Csum_scal. unfold delta. destruct (Nat.eqb_spec l l0) as [->|D].
      * rewrite (Csum_ext M _ (fun _ => RtoC 1)).
        -- rewrite Csum_const. apply injective_projections; cbn; ring.
        -- intros m _. rewrite Z.sub_diag. rewrite <- expi_0. f_equal. field. lra.
      * rewrite roots_sum; [|assumption|].
        -- rewrite Cmult_0_r. unfold RtoC. f_equal. ring.
        -- intros [q Hq]. assert (q = 0)%Z by nia. lia.
  - intros m _. rewrite <- Csum_scal. apply Csum_ext; intros l _. rewrite (Cmult_comm (RtoC (c l))), Cmult_assoc, <- expi_plus.
    rewrite Cmult_comm. f_equal. f_equal. rewrite minus_IZR, opp_IZR, <- !INR_IZR_INZ. field. lra.
Qed.

(* ---- the patterns that exist ---- *)
Lemma count_mod q M l : (l < M)%nat -> Sum (q * M) (fun k => delta (k mod M) l) = INR q.
Proof.
  intros Hl. induction q as [|q IH]; [reflexivity|]. replace (Datatypes.S q * M)%nat with (q * M + M)%nat by lia.
  rewrite Sum_split, IH, S_INR. f_equal. rewrite (Sum_ext M _ (fun i => delta i l * 1)).
  - apply (Sum_delta M l (fun _ => 1) Hl).
  - intros i Hi. rewrite Nat.add_comm, Nat.mod_add, Nat.mod_small by lia. ring.
Qed.
Definition pattern_phases (M k : nat) : R := 2 * PI * INR (k mod M) / INR M.
Theorem pattern_exists M q : (1 <= M)%nat -> pattern M (q * M) (pattern_phases M).
Proof.
  intros HM. split; [assumption|]. exists 0, (fun k => k mod M)%nat. split.
  - intros k _. split; [apply Nat.mod_upper_bound; lia|]. unfold pattern_phases. f_equal. ring.
  - intros l Hl. rewrite count_mod, mult_INR by assumption. ring.
Qed.
Theorem two_patterns n : (1 <= n)%nat -> pattern 1 n (pattern_phases 1) /\ pattern n n (pattern_phases n).
Proof.
  intros Hn. split.
  - replace n with (n * 1)%nat by lia. apply pattern_exists. lia.
  - replace n with (1 * n)%nat at 2 by lia. now apply pattern_exists.
Qed.
(* no arrangement is both a (1,N)- and an (N,N)-pattern when N >= 2; for N = 1 they are the same pattern *)
Theorem two_patterns_differ n th : (2 <= n)%nat -> pattern 1 n th -> ~ pattern n n th.
Proof.
  intros Hn P1 P2. destruct (eq23 1 n th ltac:(lia) P1) as [_ A]. destruct (eq23 n n th ltac:(lia) P2) as [B _].
  rewrite (B 1%nat ltac:(lia)), Cmod_0 in A. lra.
Qed.
Theorem one_pattern_only M th : (pattern M 1 th -> M = 1%nat) /\ pattern 1 1 th.
Proof.
  split.
  - intros [HM [th0 [cl [H1 H2]]]]. destruct (H1 0%nat ltac:(lia)) as [L _]. specialize (H2 (cl 0%nat) L). cbn [Sum INR] in H2.
    rewrite delta_eq in H2. apply INR_eq. cbn. lra.
  - split; [lia|]. exists (th 0%nat), (fun _ => 0%nat). split.
    + intros k Hk. split; [lia|]. replace k with 0%nat by lia. f_equal. cbn. field.
    + intros l Hl. replace l with 0%nat by lia. cbn. ring.
Qed.

(* ---- Theorem 3 ---- *)
Definition UMN (n M : nat) (K : nat -> R) (th : nat -> R) : R := Sum M (fun i => K (Datatypes.S i) * Um n (Datatypes.S i) th).   (* (25) *)
Theorem thm3_minimizers n M q K th : (1 <= q)%nat -> (1 <= M)%nat -> n = (q * M)%nat ->
  (forall m, (1 <= m < M)%nat -> 0 < K m) -> K M < 0 ->
  (pattern M n th <-> forall th', UMN n M K th <= UMN n M K th').
Proof.
  intros Hq HM En KP KM. assert (Hn : (1 <= n)%nat) by nia. pose proof (INR_pos n Hn) as Pn. pose proof (INR_pos M HM) as PM.
  set (lo := K M * (INR n / (2 * INR M ^ 2))). destruct M as [|p]; [lia|].
  assert (T : forall th', (forall i, (i < p)%nat -> 0 <= K (Datatypes.S i) * Um n (Datatypes.S i) th') /\ lo <= K (Datatypes.S p) * Um n (Datatypes.S p) th').
  { intros th'. split.
    - intros i Hi. apply Rmult_le_pos; [left; apply KP; lia|]. apply Um_extremes; lia.
    - unfold lo. pose proof (proj2 (proj1 (Um_extremes n (Datatypes.S p) th' Hn HM))) as B. nra. }
  assert (Low : forall th', lo <= UMN n (Datatypes.S p) K th').
  { intros th'. unfold UMN. cbn [Sum]. destruct (T th') as [A B]. pose proof (Sum_ge0 p _ A). lra. }
  assert (Eq : forall th', UMN n (Datatypes.S p) K th' = lo <-> pattern (Datatypes.S p) n th').
  { intros th'. destruct (T th') as [A B]. pose proof (Sum_ge0 p _ A) as SA. split.
    - unfold UMN. cbn [Sum]. intros E.
      assert (Z : forall i, (i < p)%nat -> K (Datatypes.S i) * Um n (Datatypes.S i) th' = 0) by (apply Sum_eq0; [exact A|lra]).
      apply moments_pattern; try assumption.
      + intros m Hm. destruct m as [|i]; [lia|]. specialize (Z i ltac:(lia)). pose proof (KP (Datatypes.S i) Hm).
        apply (Um_extremes n (Datatypes.S i) th' Hn ltac:(lia)). apply Rmult_integral in Z as [Z|Z]; [lra|exact Z].
      + assert (UE : Um n (Datatypes.S p) th' = INR n / (2 * INR (Datatypes.S p) ^ 2)) by (apply (Rmult_eq_reg_l (K (Datatypes.S p))); [fold lo; lra|lra]).
        rewrite Um_U1 in UE by assumption. apply (U1_max n _ Hn). apply (Rmult_eq_reg_l (/ INR (Datatypes.S p) ^ 2)).
        * rewrite UE. field. lra.
        * apply Rgt_not_eq, Rinv_0_lt_compat. nra.
    - intros P. destruct (eq23 _ n th' Hn P) as [Z1 Z2]. unfold UMN. cbn [Sum]. rewrite Sum_zero.
      + unfold lo, Um. assert (E : Cmod (moment n (Datatypes.S p) th') = / INR (Datatypes.S p)) by (apply (Rmult_eq_reg_l (INR (Datatypes.S p))); [rewrite Z2; field; lra|lra]).
        rewrite E. field. lra.
      + intros i Hi. rewrite (proj2 (proj1 (proj2 (Um_extremes n (Datatypes.S i) th' Hn ltac:(lia)))) (Z1 (Datatypes.S i) ltac:(lia))). ring. }
  split.
  - intros P th'. apply Eq in P. rewrite P. apply Low.
  - intros H. apply Eq. apply Rle_antisym; [|apply Low]. rewrite En in *. rewrite <- (proj2 (Eq _) (pattern_exists _ q HM)). apply H.
Qed.

(* ---- the rhombus ---- *)
Definition rhombus (k : nat) : R := match (k mod 4)%nat with 0 => 0 | 1 => PI / 3 | 2 => PI | _ => PI / 3 + PI end.
Lemma rhombus_phasors : expi 0 = (1, 0) /\ expi (PI / 3) = (1 / 2, sqrt 3 / 2) /\ expi PI = (-1, 0) /\
  expi (PI / 3 + PI) = (- (1 / 2), - (sqrt 3 / 2)).
Proof.
  unfold expi. rewrite neg_cos, neg_sin, cos_0, sin_0, cos_PI3, sin_PI3, cos_PI, sin_PI. repeat split; reflexivity.
Qed.
Lemma rhombus_twice : expi (2 * 0) = (1, 0) /\ expi (2 * (PI / 3)) = (- (1 / 2), sqrt 3 / 2) /\ expi (2 * PI) = (1, 0) /\
  expi (2 * (PI / 3 + PI)) = (- (1 / 2), sqrt 3 / 2).
Proof.
  destruct rhombus_phasors as [A [B [C0 D]]]. assert (S3 : sqrt 3 * sqrt 3 = 3) by (apply sqrt_sqrt; lra).
  assert (H : forall a, expi (2 * a) = (expi a * expi a)%C) by (intros; rewrite <- expi_plus; f_equal; ring).
  rewrite !H, A, B, C0, D. unfold Cmult; cbn. repeat split; f_equal; nra.
Qed.
Lemma rhombus_no_pattern n M : (exists p, (1 <= p)%nat /\ n = (4 * p)%nat) -> ~ pattern M n rhombus.
Proof.
  intros (p & Hp & Hn) P. assert (N1 : (4 <= n)%nat) by lia. pose proof (proj1 P) as HM. pose proof (INR_pos n ltac:(lia)) as Pn.
  destruct rhombus_twice as [A [B [C0 D]]]. destruct rhombus_phasors as [A1 [B1 _]].
  destruct (Nat.eq_dec M 1) as [->|M1]; [|destruct (Nat.eq_dec M 2) as [->|M2]].
  - destruct P as [_ [th0 [cl [H _]]]]. pose proof (H 0%nat ltac:(lia)) as [L0 E0]. pose proof (H 1%nat ltac:(lia)) as [L1 E1].
    replace (cl 0%nat) with 0%nat in E0 by lia. replace (cl 1%nat) with 0%nat in E1 by lia. rewrite <- E1 in E0.
    unfold rhombus in E0; cbn [Nat.modulo] in E0. cbn in E0. rewrite A1, B1 in E0. injection E0 as E _. lra.
  - destruct P as [_ [th0 [cl [H _]]]]. pose proof (H 0%nat ltac:(lia)) as [L0 E0]. pose proof (H 1%nat ltac:(lia)) as [L1 E1].
    apply (expi_mult_nat 2) in E0, E1.
    assert (W : forall x : nat, expi (INR 2 * (th0 + 2 * PI * INR x / INR 2)) = expi (2 * th0)).
    { intros x. replace (INR 2 * (th0 + 2 * PI * INR x / INR 2)) with (2 * PI * IZR (Z.of_nat x) + 2 * th0) by (rewrite <- INR_IZR_INZ; cbn; field).
      rewrite expi_plus, expi_2PI. apply Cmult_1_l. }
    rewrite W in E0, E1. rewrite <- E1 in E0. unfold rhombus in E0; cbn in E0.
    replace ((1 + 1) * 0) with (2 * 0) in E0 by ring. replace ((1 + 1) * (PI / 3)) with (2 * (PI / 3)) in E0 by ring.
    rewrite A, B in E0. injection E0 as E _. lra.
  - destruct (eq23 M n rhombus ltac:(lia) P) as [Z _]. specialize (Z 2%nat ltac:(lia)). unfold moment in Z.
    assert (E : forall k, expi (INR 2 * rhombus k) = if Nat.even k then (1, 0) else (- (1 / 2), sqrt 3 / 2)).
    { intros k. unfold rhombus. replace (INR 2) with 2 by (cbn; ring).
      assert (EV : Nat.even k = Nat.even (k mod 4)).
      { rewrite (Nat.div_mod k 4) at 1 by lia. rewrite Nat.even_add, Nat.even_mul. now destruct (Nat.even (k mod 4)). }
      rewrite EV. pose proof (Nat.mod_upper_bound k 4 ltac:(lia)). destruct (k mod 4)%nat as [|[|[|[|]]]]; cbn; try assumption. lia. }
    set (g := (fun k => if Nat.even k then (1, 0) else (- (1 / 2), sqrt 3 / 2)) : nat -> C).
    rewrite (Csum_ext n _ g) in Z by (intros; apply E). injection Z as _ Z. assert (S3 : 0 < sqrt 3) by (apply sqrt_lt_R0; lra).
    set (f := fun k => snd (g k)).
    assert (F0 : forall k, 0 <= f k) by (intros k; unfold f, g; destruct (Nat.even k); cbn; lra).
    pose proof (Sum_term_le n f 1 (fun k _ => F0 k) ltac:(lia)) as T. unfold f at 1, g at 1 in T. cbn [Nat.even snd] in T.
    assert (Y : / ((1 + 1) * INR n) * Sum n f = 0) by (etransitivity; [|exact Z]; unfold f; ring).
    apply Rmult_integral in Y as [Y|Y]; [|lra].
    assert (0 < / ((1 + 1) * INR n)) by (apply Rinv_0_lt_compat, Rmult_lt_0_compat; [lra|exact Pn]). lra.
Qed.
Lemma rhombus_eigen_K4 : eigenvector 4 (lap 4 complete) (RtoC 4) (phasors rhombus).
Proof.
  destruct rhombus_phasors as [A [B [C0 D]]]. intros k Hk.
  assert (E : forall j, phasors rhombus j = match (j mod 4)%nat with 0 => (1, 0) | 1 => (1 / 2, sqrt 3 / 2) | 2 => (-1, 0) | _ => (- (1 / 2), - (sqrt 3 / 2)) end).
  { intros j. unfold phasors, rhombus. destruct (j mod 4)%nat as [|[|[|]]]; assumption. }
  rewrite row_lap by assumption. unfold Csum. cbn [Sum]. rewrite !E. unfold w, complete.
  destruct k as [|[|[|[|]]]]; [..|lia]; cbn; apply injective_projections; cbn; field.
Qed.
Lemma rhombus_eigen_C12 : eigenvector 12 (lap 12 (ring_graph 12)) (RtoC 2) (phasors rhombus).
Proof.
  destruct rhombus_phasors as [A [B [C0 D]]]. intros k Hk.
  assert (E : forall j, phasors rhombus j = match (j mod 4)%nat with 0 => (1, 0) | 1 => (1 / 2, sqrt 3 / 2) | 2 => (-1, 0) | _ => (- (1 / 2), - (sqrt 3 / 2)) end).
  { intros j. unfold phasors, rhombus. destruct (j mod 4)%nat as [|[|[|]]]; assumption. }
  rewrite row_lap by assumption. unfold Csum. cbn [Sum]. rewrite !E. unfold w, ring_graph, ring_offset.
  do 12 (destruct k as [|k]; [cbn; apply injective_projections; cbn; field|]). lia.
Qed.
Theorem eig_sym_printed_fails : ~ forall n adj s lam th, (2 <= n)%nat -> undirected adj -> circulant n adj s -> ~ synchronized n th ->
  eigenvector n (lap n adj) lam (phasors th) -> exists M, pattern M n th.
Proof.
  intros H. destruct (H 4%nat complete _ (RtoC 4) rhombus ltac:(lia) complete_undirected (complete_circulant 4)) as [M P].
  - intros S. destruct rhombus_phasors as [A [B _]]. specialize (S 0%nat 1%nat ltac:(lia) ltac:(lia)). unfold rhombus in S; cbn in S.
    rewrite A, B in S. injection S as E _. lra.
  - exact rhombus_eigen_K4.
  - now apply (rhombus_no_pattern 4 M) in P; [|exists 1%nat; lia].
Qed.
Theorem fig2_caption_printed_fails : ~ forall lam th, eigenvector 12 (lap 12 (ring_graph 12)) lam (phasors th) -> exists M, pattern M 12 th.
Proof.
  intros H. destruct (H (RtoC 2) rhombus rhombus_eigen_C12) as [M P]. now apply (rhombus_no_pattern 12 M) in P; [|exists 3%nat; lia].
Qed.
