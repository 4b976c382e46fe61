(* Paley et al., limits of the particle model on a connected undirected graph: under (22) all u_k tend to w0 and the components of L_k r along
   the headings to 0; with a common drift the collective travels with it; a beacon fixes the centres.
   Barbalat's lemma gives a rate that tends to 0; that what it is made of tends to 0 too follows from products of functions of which one tends to 0 and the
   other turns.
     paley.fish28ori (clause 3), paley.drift, paley.beacon.form (clause 3). *)
From Coq Require Import Reals Lra Lia Psatz.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums inclusions paley_model paley_phase paley_laplacian paley_gradient paley_particles paley_convergence.
Open Scope R_scope.

(* ---- functions of t >= 0 that are bounded, or tend to 0 ---- *)
Definition bounded_after (f : R -> R) := exists B, 0 < B /\ forall t, 0 <= t -> Rabs (f t) <= B.
Definition dies_out (f : R -> R) := forall e, 0 < e -> exists T, 0 <= T /\ forall t, T <= t -> Rabs (f t) < e.
Lemma ba_ext f g : (forall t, 0 <= t -> f t = g t) -> bounded_after g -> bounded_after f.
Proof. intros E (B & HB & H). exists B. split; [exact HB|]. intros t Ht. rewrite E by exact Ht. now apply H. Qed.
Lemma ba_const c : bounded_after (fun _ => c).
Proof. exists (Rabs c + 1). pose proof (Rabs_pos c). split; [lra|]. intros t _. lra. Qed.
Lemma ba_plus f g : bounded_after f -> bounded_after g -> bounded_after (fun t => f t + g t).
Proof. intros (A & HA & H) (B & HB & G). exists (A + B). split; [lra|]. intros t Ht. eapply Rle_trans; [apply Rabs_triang|]. specialize (H t Ht). specialize (G t Ht). lra. Qed.
Lemma ba_mult f g : bounded_after f -> bounded_after g -> bounded_after (fun t => f t * g t).
Proof. intros (A & HA & H) (B & HB & G). exists (A * B). split; [nra|]. intros t Ht. rewrite Rabs_mult. apply Rmult_le_compat; try apply Rabs_pos; auto. Qed.
Lemma ba_Sum n (f : nat -> R -> R) : (forall k, (k < n)%nat -> bounded_after (f k)) -> bounded_after (fun t => Sum n (fun k => f k t)).
Proof. induction n as [|n IH]; intros H; [exact (ba_const 0)|]. cbn [Sum]. apply ba_plus; [apply IH; intros; apply H; lia|apply H; lia]. Qed.
Lemma do_ext f g : (forall t, 0 <= t -> f t = g t) -> dies_out g -> dies_out f.
Proof. intros E H e He. destruct (H e He) as (T & HT & P). exists T. split; [exact HT|]. intros t Ht. rewrite E by lra. now apply P. Qed.
Lemma do_zero : dies_out (fun _ => 0).
Proof. intros e He. exists 0. split; [lra|]. intros t _. now rewrite Rabs_R0. Qed.
Lemma do_plus f g : dies_out f -> dies_out g -> dies_out (fun t => f t + g t).
Proof.
  intros H G e He. destruct (H (e / 2) ltac:(lra)) as (T & HT & P). destruct (G (e / 2) ltac:(lra)) as (S & HS & Q). exists (Rmax T S). pose proof (Rmax_l T S). pose proof (Rmax_r T S).
  split; [lra|]. intros t Ht. eapply Rle_lt_trans; [apply Rabs_triang|]. specialize (P t ltac:(lra)). specialize (Q t ltac:(lra)). lra.
Qed.
Lemma do_mult f g : dies_out f -> bounded_after g -> dies_out (fun t => f t * g t).
Proof.
  intros H (B & HB & G) e He. destruct (H (e / B)) as (T & HT & P); [now apply Rdiv_lt_0_compat|]. exists T. split; [exact HT|]. intros t Ht. rewrite Rabs_mult.
  specialize (P t Ht). specialize (G t ltac:(lra)). pose proof (Rabs_pos (f t)). pose proof (Rabs_pos (g t)). apply Rle_lt_trans with (Rabs (f t) * B); [nra|].
  apply (Rmult_lt_compat_r B) in P; [|exact HB]. replace (e / B * B) with e in P by (field; lra). exact P.
Qed.
Lemma do_scal c f : dies_out f -> dies_out (fun t => c * f t).
Proof. intros H. apply (do_ext _ (fun t => f t * c)); [intros; ring|]. apply do_mult; [exact H|apply ba_const]. Qed.
Lemma do_Sum n (f : nat -> R -> R) : (forall k, (k < n)%nat -> dies_out (f k)) -> dies_out (fun t => Sum n (fun k => f k t)).
Proof. induction n as [|n IH]; intros H; [exact do_zero|]. cbn [Sum]. apply do_plus; [apply IH; intros; apply H; lia|apply H; lia]. Qed.
Lemma do_sqrt f : dies_out (fun t => f t ^ 2) -> dies_out f.
Proof.
  intros H e He. destruct (H (e ^ 2) ltac:(nra)) as (T & HT & P). exists T. split; [exact HT|]. intros t Ht. specialize (P t Ht).
  rewrite Rabs_pos_eq in P by apply pow2_ge_0. rewrite <- pow2_abs in P. pose proof (Rabs_pos (f t)). nra.
Qed.
Lemma do_ba f : dies_out f -> (forall T, bounded_after (fun t => f (Rmin t T))) -> bounded_after f.
Proof.
  intros H K. destruct (H 1 ltac:(lra)) as (T & HT & P). destruct (K T) as (B & HB & Q). exists (B + 1). split; [lra|]. intros t Ht. destruct (Rle_or_lt t T) as [L|L].
  - specialize (Q t Ht). rewrite Rmin_left in Q by lra. lra.
  - specialize (P t ltac:(lra)). lra.
Qed.
Lemma slow (f f' : R -> R) : (forall t, 0 <= t -> is_derive f t (f' t)) -> bounded_after f' -> exists C, 0 < C /\ forall s t, 0 <= s <= t -> Rabs (f t - f s) <= C * (t - s).
Proof. intros D (B & HB & H). exists B. split; [exact HB|]. intros s t Hst. apply (slope_le f f' B s t); [lra|]. intros u Hu. split; [apply D|apply H]; lra. Qed.
(* P tends to 0 and its rate is G >= 0 up to what tends to 0: G, if it changes at a bounded rate, tends to 0 *)
Lemma rate_dies (P P' G G' E : R -> R) : dies_out P -> (forall t, 0 <= t -> is_derive P t (P' t)) -> (forall t, 0 <= t -> P' t = G t + E t) -> dies_out E ->
  (forall t, 0 <= t -> 0 <= G t) -> (forall t, 0 <= t -> is_derive G t (G' t)) -> bounded_after G' -> dies_out G.
Proof.
  intros HP DP R1 HE G0 DG BG e He. destruct (slow G G' DG BG) as (C & HC & Lip). set (h := e / (4 * C)). assert (Hh : 0 < h) by (unfold h; apply Rdiv_lt_0_compat; lra).
  assert (Ch : C * h = e / 4) by (unfold h; field; lra).
  destruct (HP (e * h / 8)) as (T1 & HT1 & P1); [nra|]. destruct (HE (e / 8) ltac:(lra)) as (T2 & HT2 & P2). exists (Rmax T1 T2). pose proof (Rmax_l T1 T2). pose proof (Rmax_r T1 T2). split; [lra|].
  intros t Ht. rewrite Rabs_pos_eq by (apply G0; lra). apply Rnot_le_lt. intros L.
  destruct (MVT_le P P' t (t + h) ltac:(lra)) as (c & Hc & Eq); [intros; apply DP; lra|].
  rewrite R1 in Eq by lra. pose proof (Lip t c ltac:(lra)) as Lc. specialize (P2 c ltac:(lra)). pose proof (P1 t ltac:(lra)) as A1. pose proof (P1 (t + h) ltac:(lra)) as A2.
  apply Rabs_lt_between in P2, A1, A2. apply Rabs_le_between in Lc. assert (C * (c - t) <= C * h) by (apply Rmult_le_compat_l; lra). nra.
Qed.

(* ---- the beacon ---- *)
Definition beaconed n w0 K0 (c0 : C) (r : nat -> R -> C) (th : nat -> R -> R) := forall k t, (k < n)%nat -> 0 <= t ->
  is_velocity (r k) t (expi (th k t)) /\
  is_derive (th k) t (w0 + w0 * (K0 / INR n * inner (expi (th k t)) (circle_centre w0 (r k t) (th k t) - c0)%C)).
Theorem beacon_fixes : forall n w0 K0 c0 r th, (1 <= n)%nat -> w0 <> 0 -> 0 < K0 -> beaconed n w0 K0 c0 r th ->
  forall k, (k < n)%nat -> forall e, 0 < e -> exists T, 0 <= T /\ forall t, T <= t -> Cmod (circle_centre w0 (r k t) (th k t) - c0)%C < e.
Proof.
  intros n w0 K0 c0 r th Hn Hw HK M k Hk. pose proof (INR_pos n Hn) as Pn. set (a := K0 / INR n). assert (Ha : 0 < a) by (unfold a; now apply Rdiv_lt_0_compat).
  set (x := fun t => (circle_centre w0 (r k t) (th k t) - c0)%C). set (g := fun t => inner (expi (th k t)) (x t)). set (h := fun t => inner (Ci * expi (th k t))%C (x t)).
  set (u := fun t => w0 + w0 * (a * g t)).
  assert (Dth : forall t, 0 <= t -> is_derive (th k) t (u t)) by (intros t Ht; exact (proj2 (M k t Hk Ht))).
  assert (Dx : forall t, 0 <= t -> is_velocity x t (RtoC (- a * g t) * expi (th k t))%C).
  { intros t Ht. destruct (eq18 w0 (r k) (th k) t _ (proj1 (M k t Hk Ht)) (Dth t Ht)) as [V1 V2]. split.
    - apply (is_derive_ext (fun s => fst (circle_centre w0 (r k s) (th k s)) - fst c0)); [reflexivity|]. eapply D_eq; [apply D_minus; [exact V1|apply D_const]|]. unfold u. cbn. field. exact Hw.
    - apply (is_derive_ext (fun s => snd (circle_centre w0 (r k s) (th k s)) - snd c0)); [reflexivity|]. eapply D_eq; [apply D_minus; [exact V2|apply D_const]|]. unfold u. cbn. field. exact Hw. }
  assert (Dg : forall t, 0 <= t -> is_derive g t (u t * h t + - a * g t)).
  { intros t Ht. eapply D_eq; [apply (D_inner _ _ t _ _ (velocity_expi (th k) t (u t) (Dth t Ht)) (Dx t Ht))|]. rewrite inner_scal_l, inner_scal. fold (h t).
    replace (inner (expi (th k t)) (expi (th k t))) with 1; [ring|]. rewrite inner_xy. cbn. pose proof (sc2 (th k t)). lra. }
  assert (Dh : forall t, 0 <= t -> is_derive h t (- u t * g t)).
  { intros t Ht. eapply D_eq; [apply (D_inner _ _ t _ _ (velocity_across (th k) t (u t) (Dth t Ht)) (Dx t Ht))|]. rewrite inner_scal_l, inner_scal. fold (g t).
    replace (inner (Ci * expi (th k t))%C (expi (th k t))) with 0; [ring|]. rewrite inner_xy. cbn. ring. }
  assert (Sq : forall t, g t ^ 2 + h t ^ 2 = Cmod (x t) ^ 2) by (intros t; unfold g, h; rewrite along_across; apply inner_self).
  set (V := fun t => g t ^ 2 + h t ^ 2).
  assert (DV : forall t, 0 <= t -> is_derive V t (- (2 * a * g t ^ 2))).
  { intros t Ht. eapply D_eq; [apply (D_plus (fun s => g s ^ 2) (fun s => h s ^ 2)); [apply D_sqr, (Dg t Ht)|apply D_sqr, (Dh t Ht)]|]. ring. }
  assert (VB : forall t, 0 <= t -> V t <= V 0).
  { intros t Ht. apply (decreasing V (fun t => - (2 * a * g t ^ 2)) 0 t Ht); [intros; apply DV; lra|]. intros s _. pose proof (pow2_ge_0 (g s)). nra. }
  set (B := V 0 + 1). assert (V0 : 0 <= V 0) by (unfold V; pose proof (pow2_ge_0 (g 0)); pose proof (pow2_ge_0 (h 0)); lra).
  assert (Bg : bounded_after g).
  { exists B. split; [unfold B; lra|]. intros t Ht. apply sqr_Rabs; [unfold B; lra|]. specialize (VB t Ht). unfold V in VB at 1. pose proof (pow2_ge_0 (h t)). unfold B. nra. }
  assert (Bh : bounded_after h).
  { exists B. split; [unfold B; lra|]. intros t Ht. apply sqr_Rabs; [unfold B; lra|]. specialize (VB t Ht). unfold V in VB at 1. pose proof (pow2_ge_0 (g t)). unfold B. nra. }
  assert (Bu : bounded_after u) by (unfold u; apply ba_plus; [apply ba_const|]; apply ba_mult; [apply ba_const|]; apply ba_mult; [apply ba_const|exact Bg]).
  assert (Bg' : bounded_after (fun t => u t * h t + - a * g t)) by (apply ba_plus; apply ba_mult; try assumption; apply ba_const).
  assert (Bh' : bounded_after (fun t => - u t * g t)).
  { apply (ba_ext _ (fun t => -1 * (u t * g t))); [intros; ring|]. apply ba_mult; [apply ba_const|now apply ba_mult]. }
  assert (G0 : dies_out g).
  { destruct (slow (fun t => 2 * a * g t ^ 2) (fun t => 2 * a * (2 * g t * (u t * h t + - a * g t)))) as (C0 & HC0 & Lip).
    - intros t Ht. apply D_scal, D_sqr, (Dg t Ht).
    - apply ba_mult; [apply ba_const|]. apply (ba_ext _ (fun t => 2 * (g t * (u t * h t + - a * g t)))); [intros; ring|]. apply ba_mult; [apply ba_const|now apply ba_mult].
    - apply do_sqrt. intros e He. destruct (barbalat (fun t => - V t) (fun t => 2 * a * g t ^ 2) 0 C0 HC0) with (e := 2 * a * e) as (T & HT & Q).
      + intros t Ht. eapply D_eq; [apply D_opp, (DV t Ht)|ring].
      + intros t _. pose proof (pow2_ge_0 (g t)). nra.
      + intros t _. unfold V. pose proof (pow2_ge_0 (g t)). pose proof (pow2_ge_0 (h t)). lra.
      + exact Lip.
      + nra.
      + exists T. split; [exact HT|]. intros t Ht. specialize (Q t Ht). rewrite Rabs_pos_eq by apply pow2_ge_0. apply (Rmult_lt_reg_l (2 * a)); lra. }
  assert (H0 : dies_out h).
  { apply do_sqrt. apply (do_ext _ (fun t => / w0 ^ 2 * (w0 ^ 2 * h t ^ 2))); [intros; field; exact Hw|]. apply do_scal.
    apply (rate_dies (fun t => w0 * (g t * h t)) (fun t => w0 * ((u t * h t + - a * g t) * h t + g t * (- u t * g t))) (fun t => w0 ^ 2 * h t ^ 2) (fun t => w0 ^ 2 * (2 * h t * (- u t * g t)))
      (fun t => g t * (w0 ^ 2 * (a * h t ^ 2) + - w0 * (a * h t) + - w0 * (u t * g t)))).
    - apply do_scal. now apply do_mult.
    - intros t Ht. apply D_scal, D_mult; [apply (Dg t Ht)|apply (Dh t Ht)].
    - intros t _. unfold u. ring.
    - apply do_mult; [exact G0|]. apply ba_plus; [apply ba_plus|].
      + apply ba_mult; [apply ba_const|]. apply ba_mult; [apply ba_const|]. apply (ba_ext _ (fun t => h t * h t)); [intros; ring|]. now apply ba_mult.
      + apply ba_mult; [apply ba_const|]. apply ba_mult; [apply ba_const|exact Bh].
      + apply ba_mult; [apply ba_const|]. now apply ba_mult.
    - intros t _. pose proof (pow2_ge_0 (h t)). pose proof (pow2_ge_0 w0). nra.
    - intros t Ht. apply D_scal, D_sqr, (Dh t Ht).
    - apply ba_mult; [apply ba_const|]. apply (ba_ext _ (fun t => 2 * (h t * (- u t * g t)))); [intros; ring|]. apply ba_mult; [apply ba_const|now apply ba_mult]. }
  assert (X0 : dies_out (fun t => Cmod (x t))).
  { apply do_sqrt. apply (do_ext _ (fun t => g t * g t + h t * h t)); [intros t _; rewrite <- Sq; ring|]. apply do_plus; now apply do_mult. }
  intros e He. destruct (X0 e He) as (T & HT & Q). exists T. split; [exact HT|]. intros t Ht. specialize (Q t Ht). rewrite Rabs_pos_eq in Q by apply Cmod_ge_0. exact Q.
Qed.

(* ---- the control (22) ---- *)
Definition shaped n adj w0 K0 K1 (r : nat -> R -> C) (th : nat -> R -> R) := forall k t, (k < n)%nat -> 0 <= t ->
  is_velocity (r k) t (expi (th k t)) /\ is_derive (th k) t (control5 n adj w0 K0 K1 r th t k).
Section Shaped.
Variables (n : nat) (adj : graph) (w0 K0 K1 : R) (r : nat -> R -> C) (th : nat -> R -> R).
Hypotheses (Hn : (1 <= n)%nat) (HS : undirected adj) (SC : strongly_connected n adj) (Hw : w0 <> 0) (HK : 0 < K0).
Hypothesis M : shaped n adj w0 K0 K1 r th.
Definition cc (k : nat) (t : R) : C := circle_centre w0 (r k t) (th k t).
Definition ll (k : nat) (t : R) : C := row n (lap n adj) k (fun j => cc j t).
Definition gg (k : nat) (t : R) : R := inner (expi (th k t)) (ll k t).
Definition hh (k : nat) (t : R) : R := inner (Ci * expi (th k t))%C (ll k t).
Definition ww (k : nat) (t : R) : R := gW n adj (fun j => th j t) k.
Definition ff (k : nat) (t : R) : R := K0 * gg k t + K1 * / w0 * ww k t.
Definition uu (k : nat) (t : R) : R := w0 + w0 / INR n * ff k t.
Definition vv (j : nat) (t : R) : C := (RtoC (- / INR n * ff j t) * expi (th j t))%C.
Definition pp (k : nat) (t : R) : R := inner (expi (th k t)) (row n (lap n adj) k (fun j => vv j t)).
Definition qq (k : nat) (t : R) : R := inner (Ci * expi (th k t))%C (row n (lap n adj) k (fun j => vv j t)).
Definition ww' (k : nat) (t : R) : R := Sum n (fun j => w adj k j * (cos (th k t - th j t) * (uu k t + -1 * uu j t))).
Definition VV (t : R) : R := K0 * Q n (lap n adj) (fun k => cc k t) - K1 / w0 ^ 2 * W1 n adj (fun k => th k t).
Let nn : 0 < INR n. Proof. exact (INR_pos n Hn). Qed.
Lemma control_uu k t : control5 n adj w0 K0 K1 r th t k = uu k t.
Proof. unfold control5, uu, ff, gg, ww, aS. change (fun j => cc j t) with (centres w0 (fun j => r j t) (fun j => th j t)). unfold ll. change (fun j => cc j t) with (centres w0 (fun j => r j t) (fun j => th j t)). field; repeat split; (exact Hw || lra). Qed.
Lemma d_th k t : (k < n)%nat -> 0 <= t -> is_derive (th k) t (uu k t).
Proof. intros Hk Ht. rewrite <- control_uu. exact (proj2 (M k t Hk Ht)). Qed.
Lemma d_cc k t : (k < n)%nat -> 0 <= t -> is_velocity (cc k) t (vv k t).
Proof.
  intros Hk Ht. eapply velocity_eq; [apply eq18; [exact (proj1 (M k t Hk Ht))|exact (d_th k t Hk Ht)]|]. unfold vv, uu. rewrite Cmult_comm. do 2 f_equal. field; repeat split; (exact Hw || lra).
Qed.
Lemma d_ll k t : 0 <= t -> is_velocity (ll k) t (row n (lap n adj) k (fun j => vv j t)).
Proof. intros Ht. apply (velocity_row n (lap n adj) cc (fun j => vv j t)). intros j Hj. now apply d_cc. Qed.
Lemma d_gg k t : (k < n)%nat -> 0 <= t -> is_derive (gg k) t (uu k t * hh k t + pp k t).
Proof. intros Hk Ht. eapply D_eq; [apply D_inner; [apply velocity_expi, (d_th k t Hk Ht)|apply (d_ll k t Ht)]|]. rewrite inner_scal_l. reflexivity. Qed.
Lemma d_hh k t : (k < n)%nat -> 0 <= t -> is_derive (hh k) t (- uu k t * gg k t + qq k t).
Proof. intros Hk Ht. eapply D_eq; [apply D_inner; [apply velocity_across, (d_th k t Hk Ht)|apply (d_ll k t Ht)]|]. rewrite inner_scal_l. reflexivity. Qed.
Lemma d_ww k t : (k < n)%nat -> 0 <= t -> is_derive (ww k) t (ww' k t).
Proof.
  intros Hk Ht. unfold ww, ww'. apply (is_derive_ext (fun s => Sum n (fun j => w adj k j * sin (th k s - th j s)))).
  { intros s. symmetry. now apply (gW_sines n adj (fun j => th j s)). }
  apply (D_Sum n (fun j s => w adj k j * sin (th k s - th j s))). intros j Hj. eapply D_eq; [apply (D_scal (w adj k j) (fun s => sin (th k s - th j s))), (D_sin (fun s => th k s - th j s)), (D_minus (th k) (th j)); [exact (d_th k t Hk Ht)|exact (d_th j t Hj Ht)]|]. cbv beta. ring.
Qed.
Lemma d_VV t : 0 <= t -> is_derive VV t (- (/ INR n ^ 2 * Sum n (fun k => ff k t ^ 2))).
Proof.
  intros Ht. eapply D_eq; [apply (eq21_corrected n adj w0 K0 K1 Hn Hw HS r th (fun k => uu k t) t (fun k Hk => proj1 (M k t Hk Ht)) (fun k Hk => d_th k t Hk Ht))|].
  - intros k Hk. symmetry. apply control_uu.
  - rewrite Ropp_mult_distr_l. reflexivity.
Qed.
Lemma W1_bound t : 0 <= W1 n adj (fun k => th k t) <= INR n.
Proof.
  split; [now apply W1_ge0|]. unfold W1. rewrite Q_total by assumption. unfold total.
  apply Rle_trans with (/ (4 * INR n) * (INR n * (INR n * 4))); [|right; field; lra]. apply Rmult_le_compat_l; [left; apply Rinv_0_lt_compat; lra|].
  rewrite <- (Sum_const n 4), <- Sum_const. apply Sum_le. intros k _. apply Sum_le. intros j _.
  assert (D : 0 <= dist2 (phasors (fun k => th k t) k) (phasors (fun k => th k t) j) <= 4).
  { rewrite dist2_xy. unfold phasors, expi. cbn [fst snd]. pose proof (sc2 (th k t)). pose proof (sc2 (th j t)).
    pose proof (pow2_ge_0 (cos (th k t) + cos (th j t))). pose proof (pow2_ge_0 (sin (th k t) + sin (th j t))). pose proof (pow2_ge_0 (cos (th k t) - cos (th j t))). pose proof (pow2_ge_0 (sin (th k t) - sin (th j t))). nra. }
  unfold w. destruct (adj k j); lra.
Qed.
Lemma spacing_bounded : exists B, 0 < B /\ forall t, 0 <= t -> Q n (lap n adj) (fun k => cc k t) <= B.
Proof.
  set (a := Rabs (K1 / w0 ^ 2) * INR n). exists ((VV 0 + a) / K0 + 1 + a / K0). pose proof (Rabs_pos (K1 / w0 ^ 2)) as A0. assert (Ha : 0 <= a) by (unfold a; nra).
  assert (Wb : forall t, Rabs (K1 / w0 ^ 2 * W1 n adj (fun k => th k t)) <= a).
  { intros t. unfold a. pose proof (W1_bound t) as [W1a W1b]. rewrite Rabs_mult, (Rabs_pos_eq (W1 _ _ _)) by exact W1a. now apply Rmult_le_compat_l. }
  assert (Q0 : forall t, 0 <= Q n (lap n adj) (fun k => cc k t)) by (intros; now apply Q_kernel).
  assert (V0 : 0 <= VV 0 + a). { unfold VV. specialize (Wb 0). apply Rabs_le_between in Wb. specialize (Q0 0). nra. }
  assert (0 <= (VV 0 + a) / K0) by (apply Rdiv_le_0_compat; lra). assert (0 <= a / K0) by (apply Rdiv_le_0_compat; lra). split; [lra|]. intros t Ht.
  assert (D : VV t <= VV 0).
  { apply (decreasing VV (fun t => - (/ INR n ^ 2 * Sum n (fun k => ff k t ^ 2))) 0 t Ht); [intros; apply d_VV; lra|]. intros s _.
    assert (0 <= Sum n (fun k => ff k s ^ 2)) by (apply Sum_ge0; intros; apply pow2_ge_0). assert (0 < / INR n ^ 2) by (apply Rinv_0_lt_compat, pow_lt, nn). nra. }
  unfold VV in D at 1. specialize (Wb t). apply Rabs_le_between in Wb. apply Rmult_le_reg_l with K0; [exact HK|].
  replace (K0 * ((VV 0 + a) / K0 + 1 + a / K0)) with (VV 0 + 2 * a + K0) by (field; lra). lra.
Qed.
Lemma b_gg k : (k < n)%nat -> bounded_after (gg k) /\ bounded_after (hh k).
Proof.
  intros Hk. destruct spacing_bounded as (B & HB & Sb). set (b := 4 * INR n ^ 2 * B + 1). assert (Hb : 1 <= b) by (unfold b; assert (0 <= 4 * INR n ^ 2 * B); [apply Rmult_le_pos; [nra|lra]|lra]).
  assert (Sq : forall t, 0 <= t -> gg k t ^ 2 + hh k t ^ 2 <= b).
  { intros t Ht. unfold gg, hh. rewrite along_across. pose proof (lap2_le n adj (fun k => cc k t) Hn HS) as L. specialize (Sb t Ht).
    assert (inner (ll k t) (ll k t) <= lap2 n adj (fun k => cc k t)).
    { apply (Sum_term_le n (fun k => inner (row n (lap n adj) k (fun j => cc j t)) (row n (lap n adj) k (fun j => cc j t))) k); [|exact Hk].
      intros j _. rewrite inner_xy. nra. }
    assert (4 * INR n ^ 2 * Q n (lap n adj) (fun k => cc k t) <= 4 * INR n ^ 2 * B) by (apply Rmult_le_compat_l; nra). unfold b. lra. }
  split; exists b; (split; [lra|]); intros t Ht; specialize (Sq t Ht); apply sqr_Rabs; try lra; pose proof (pow2_ge_0 (gg k t)); pose proof (pow2_ge_0 (hh k t)); nra.
Qed.
Lemma b_trig (f : R -> R) : (forall t, -1 <= f t <= 1) -> bounded_after f.
Proof. intros H. exists 1. split; [lra|]. intros t _. apply Rabs_le. apply H. Qed.
Lemma b_ww k : (k < n)%nat -> bounded_after (ww k).
Proof.
  intros Hk. apply (ba_ext _ (fun t => Sum n (fun j => w adj k j * sin (th k t - th j t)))); [intros; now apply (gW_sines n adj (fun j => th j t))|].
  apply (ba_Sum n (fun j t => w adj k j * sin (th k t - th j t))). intros j _. apply ba_mult; [apply ba_const|]. apply b_trig. intros; apply SIN_bound.
Qed.
Lemma b_ff k : (k < n)%nat -> bounded_after (ff k).
Proof. intros Hk. unfold ff. apply ba_plus; apply ba_mult; try apply ba_const; [now apply b_gg|now apply b_ww]. Qed.
Lemma b_uu k : (k < n)%nat -> bounded_after (uu k).
Proof. intros Hk. unfold uu. apply ba_plus; [apply ba_const|]. apply ba_mult; [apply ba_const|now apply b_ff]. Qed.
(* p and q are sums of the f_j with bounded factors *)
Lemma pp_is k t : pp k t = Sum n (fun j => ff j t * (lap n adj k j * - / INR n * cos (th j t - th k t))).
Proof.
  unfold pp. rewrite inner_row. apply Sum_ext. intros j _. unfold vv. rewrite inner_scal. replace (inner (expi (th k t)) (expi (th j t))) with (cos (th j t - th k t)); [ring|].
  rewrite cos_minus, inner_xy. cbn. ring.
Qed.
Lemma qq_is k t : qq k t = Sum n (fun j => ff j t * (lap n adj k j * - / INR n * sin (th j t - th k t))).
Proof. unfold qq. rewrite inner_row. apply Sum_ext. intros j _. unfold vv. rewrite inner_scal, inner_iexpi. ring. Qed.
Lemma b_pq k : bounded_after (pp k) /\ bounded_after (qq k).
Proof.
  split; [apply (ba_ext _ _ (fun t _ => pp_is k t))|apply (ba_ext _ _ (fun t _ => qq_is k t))]; apply (ba_Sum n (fun j t => ff j t * (lap n adj k j * - / INR n * _ (th j t - th k t))));
    intros j Hj; apply ba_mult; try (now apply b_ff); apply ba_mult; try apply ba_const; apply b_trig; intros; [apply COS_bound|apply SIN_bound].
Qed.
Lemma b_ww' k : (k < n)%nat -> bounded_after (ww' k).
Proof.
  intros Hk. unfold ww'. apply (ba_Sum n (fun j t => w adj k j * (cos (th k t - th j t) * (uu k t + -1 * uu j t)))). intros j Hj. apply ba_mult; [apply ba_const|].
  apply ba_mult; [apply b_trig; intros; apply COS_bound|]. apply ba_plus; [now apply b_uu|]. apply ba_mult; [apply ba_const|now apply b_uu].
Qed.
Lemma b_gg' k : (k < n)%nat -> bounded_after (fun t => uu k t * hh k t + pp k t).
Proof. intros Hk. apply ba_plus; [apply ba_mult; [now apply b_uu|now apply b_gg]|apply b_pq]. Qed.
Lemma b_hh' k : (k < n)%nat -> bounded_after (fun t => - uu k t * gg k t + qq k t).
Proof.
  intros Hk. apply ba_plus; [|apply b_pq]. apply (ba_ext _ (fun t => -1 * (uu k t * gg k t))); [intros; ring|]. apply ba_mult; [apply ba_const|]. apply ba_mult; [now apply b_uu|now apply b_gg].
Qed.
Definition ff' (k : nat) (t : R) := K0 * (uu k t * hh k t + pp k t) + K1 * / w0 * ww' k t.
Lemma d_ff k t : (k < n)%nat -> 0 <= t -> is_derive (ff k) t (ff' k t).
Proof. intros Hk Ht. unfold ff, ff'. apply (D_plus (fun t => K0 * gg k t) (fun t => K1 * / w0 * ww k t)); apply D_scal; [now apply d_gg|now apply d_ww]. Qed.
Lemma b_ff' k : (k < n)%nat -> bounded_after (ff' k).
Proof. intros Hk. unfold ff'. apply ba_plus; apply ba_mult; try apply ba_const; [now apply b_gg'|now apply b_ww']. Qed.
Lemma f_dies k : (k < n)%nat -> dies_out (ff k).
Proof.
  intros Hk. set (G := fun t => / INR n ^ 2 * Sum n (fun k => ff k t ^ 2)). assert (Pi : 0 < / INR n ^ 2) by (apply Rinv_0_lt_compat, pow_lt, nn).
  destruct (slow G (fun t => / INR n ^ 2 * Sum n (fun k => 2 * ff k t * ff' k t))) as (C0 & HC0 & Lip).
  - intros t Ht. apply D_scal, (D_Sum n (fun k t => ff k t ^ 2)). intros j Hj. now apply D_sqr, d_ff.
  - apply ba_mult; [apply ba_const|]. apply (ba_Sum n (fun k t => 2 * ff k t * ff' k t)). intros j Hj. apply ba_mult; [apply ba_mult; [apply ba_const|now apply b_ff]|now apply b_ff'].
  - apply do_sqrt. intros e He. set (a := Rabs (K1 / w0 ^ 2) * INR n).
    destruct (barbalat (fun t => - VV t) G a C0 HC0) with (e := / INR n ^ 2 * e) as (T & HT & Q1).
    + intros t Ht. eapply D_eq; [apply D_opp, (d_VV t Ht)|]. unfold G. ring.
    + intros t _. unfold G. apply Rmult_le_pos; [lra|]. apply Sum_ge0. intros; apply pow2_ge_0.
    + intros t _. unfold VV, a. pose proof (W1_bound t) as [W1a W1b]. assert (0 <= Q n (lap n adj) (fun k => cc k t)) by now apply Q_kernel.
      pose proof (Rle_abs (K1 / w0 ^ 2)). pose proof (Rabs_pos (K1 / w0 ^ 2)). assert (0 <= K0 * Q n (lap n adj) (fun k => cc k t)) by nra.
      assert (K1 / w0 ^ 2 * W1 n adj (fun k => th k t) <= Rabs (K1 / w0 ^ 2) * INR n); [|lra].
      apply Rle_trans with (Rabs (K1 / w0 ^ 2) * W1 n adj (fun k => th k t)); [now apply Rmult_le_compat_r|now apply Rmult_le_compat_l].
    + exact Lip.
    + now apply Rmult_lt_0_compat.
    + exists T. split; [exact HT|]. intros t Ht. specialize (Q1 t Ht). unfold G in Q1. apply Rmult_lt_reg_l in Q1; [|exact Pi].
      rewrite Rabs_pos_eq by apply pow2_ge_0. eapply Rle_lt_trans; [|exact Q1]. apply (Sum_term_le n (fun k => ff k t ^ 2) k); [intros; apply pow2_ge_0|exact Hk].
Qed.
Lemma pq_die k : dies_out (pp k) /\ dies_out (qq k).
Proof.
  split; [apply (do_ext _ _ (fun t _ => pp_is k t))|apply (do_ext _ _ (fun t _ => qq_is k t))]; apply (do_Sum n (fun j t => ff j t * (lap n adj k j * - / INR n * _ (th j t - th k t))));
    intros j Hj; (apply do_mult; [now apply f_dies|]); apply ba_mult; try apply ba_const; apply b_trig; intros; [apply COS_bound|apply SIN_bound].
Qed.
Lemma w_dies' k : (k < n)%nat -> dies_out (ww' k).
Proof.
  intros Hk. unfold ww'. apply (do_Sum n (fun j t => w adj k j * (cos (th k t - th j t) * (uu k t + -1 * uu j t)))). intros j Hj. apply do_scal.
  apply (do_ext _ (fun t => (w0 / INR n * ff k t + - (w0 / INR n) * ff j t) * cos (th k t - th j t))); [intros t _; unfold uu; ring|].
  apply do_mult; [|apply b_trig; intros; apply COS_bound]. apply do_plus; apply do_scal; now apply f_dies.
Qed.
Lemma h_dies k : (k < n)%nat -> dies_out (hh k).
Proof.
  intros Hk. destruct (b_gg k Hk) as [Bg Bh]. assert (Pw : 0 < w0 ^ 2) by (apply pow2_gt_0; exact Hw).
  apply do_sqrt. apply (do_ext _ (fun t => / (K0 * w0 ^ 2) * (K0 * w0 ^ 2 * hh k t ^ 2))); [intros; field; repeat split; (exact Hw || lra)|]. apply do_scal.
  apply (rate_dies (fun t => w0 * (ff k t * hh k t)) (fun t => w0 * (ff' k t * hh k t + ff k t * (- uu k t * gg k t + qq k t))) (fun t => K0 * w0 ^ 2 * hh k t ^ 2)
    (fun t => K0 * w0 ^ 2 * (2 * hh k t * (- uu k t * gg k t + qq k t)))
    (fun t => ff k t * (w0 * (K0 * (w0 / INR n) * hh k t ^ 2 + (- uu k t * gg k t + qq k t))) + (pp k t * (w0 * K0 * hh k t) + ww' k t * (K1 * hh k t)))).
  - apply do_scal, do_mult; [now apply f_dies|exact Bh].
  - intros t Ht. apply D_scal, D_mult; [now apply d_ff|now apply d_hh].
  - intros t _. unfold ff' , uu. field; repeat split; (exact Hw || lra).
  - apply do_plus; [apply do_mult; [now apply f_dies|]|apply do_plus; apply do_mult].
    + apply ba_mult; [apply ba_const|]. apply ba_plus; [|now apply b_hh']. apply ba_mult; [apply ba_const|]. apply (ba_ext _ (fun t => hh k t * hh k t)); [intros; ring|]. now apply ba_mult.
    + apply pq_die.
    + apply ba_mult; [apply ba_const|exact Bh].
    + now apply w_dies'.
    + apply ba_mult; [apply ba_const|exact Bh].
  - intros t _. apply Rmult_le_pos; [nra|apply pow2_ge_0].
  - intros t Ht. apply D_scal, D_sqr. now apply d_hh.
  - apply ba_mult; [apply ba_const|]. apply (ba_ext _ (fun t => 2 * (hh k t * (- uu k t * gg k t + qq k t)))); [intros; ring|]. apply ba_mult; [apply ba_const|]. apply ba_mult; [exact Bh|now apply b_hh'].
Qed.
Lemma g_dies k : (k < n)%nat -> dies_out (gg k).
Proof.
  intros Hk. destruct (b_gg k Hk) as [Bg Bh]. assert (Pw : 0 < w0 ^ 2) by (apply pow2_gt_0; exact Hw).
  apply do_sqrt. apply (do_ext _ (fun t => / w0 ^ 2 * (w0 ^ 2 * gg k t ^ 2))); [intros; field; exact Hw|]. apply do_scal.
  apply (rate_dies (fun t => - w0 * (hh k t * gg k t)) (fun t => - w0 * ((- uu k t * gg k t + qq k t) * gg k t + hh k t * (uu k t * hh k t + pp k t))) (fun t => w0 ^ 2 * gg k t ^ 2)
    (fun t => w0 ^ 2 * (2 * gg k t * (uu k t * hh k t + pp k t)))
    (fun t => ff k t * (w0 ^ 2 / INR n * gg k t ^ 2) + (qq k t * (- w0 * gg k t) + hh k t * (- w0 * (uu k t * hh k t + pp k t))))).
  - apply do_scal, do_mult; [now apply h_dies|exact Bg].
  - intros t Ht. apply D_scal, D_mult; [now apply d_hh|now apply d_gg].
  - intros t _. unfold uu. field. lra.
  - apply do_plus; [apply do_mult; [now apply f_dies|]|apply do_plus; apply do_mult].
    + apply ba_mult; [apply ba_const|]. apply (ba_ext _ (fun t => gg k t * gg k t)); [intros; ring|]. now apply ba_mult.
    + apply pq_die.
    + apply ba_mult; [apply ba_const|exact Bg].
    + now apply h_dies.
    + apply ba_mult; [apply ba_const|now apply b_gg'].
  - intros t _. apply Rmult_le_pos; [lra|apply pow2_ge_0].
  - intros t Ht. apply D_scal, D_sqr. now apply d_gg.
  - apply ba_mult; [apply ba_const|]. apply (ba_ext _ (fun t => 2 * (gg k t * (uu k t * hh k t + pp k t)))); [intros; ring|]. apply ba_mult; [apply ba_const|]. apply ba_mult; [exact Bg|now apply b_gg'].
Qed.
(* <z_k, L_k r> *)
Lemma along_r k t : inner (expi (th k t)) (row n (lap n adj) k (fun j => r j t)) = gg k t + / w0 * ww k t.
Proof.
  pose proof (eq22 n adj w0 K0 K1 Hn Hw r th t k) as E. rewrite control_uu in E. unfold uu, ff in E. fold (ww k t) in E.
  set (y := inner (expi (th k t)) (row n (lap n adj) k (fun j => r j t))) in *.
  apply (Rmult_eq_reg_l (w0 * (K0 / INR n))); [|apply Rmult_integral_contrapositive_currified; [exact Hw|apply Rgt_not_eq; now apply Rdiv_lt_0_compat]].
  transitivity (w0 + w0 / INR n * (K0 * gg k t + K1 * / w0 * ww k t) - (w0 + (K1 - K0) / INR n * ww k t)); [rewrite E; ring|]. field; repeat split; (exact Hw || lra).
Qed.
Lemma perpendicular k : K1 <> 0 -> (k < n)%nat -> dies_out (fun t => inner (expi (th k t)) (row n (lap n adj) k (fun j => r j t))).
Proof.
  intros HK1 Hk. apply (do_ext _ (fun t => (1 + - (K0 / K1)) * gg k t + / K1 * ff k t)).
  - intros t _. rewrite along_r. unfold ff. field; repeat split; (exact HK1 || exact Hw).
  - apply do_plus; apply do_scal; [now apply g_dies|now apply f_dies].
Qed.
End Shaped.

Theorem perpendicular_motion : forall n adj w0 K0 K1 r th, (2 <= n)%nat -> undirected adj -> strongly_connected n adj -> 0 < w0 -> 0 < K0 -> K1 <> 0 ->
  shaped n adj w0 K0 K1 r th -> forall k, (k < n)%nat -> forall e, 0 < e -> exists T, 0 <= T /\ forall t, T <= t ->
  Rabs (inner (expi (th k t)) (RtoC (/ deg n adj k) * row n (lap n adj) k (fun j => r j t))%C) < e.
Proof.
  intros n adj w0 K0 K1 r th Hn HS SC Hw HK HK1 M k Hk.
  apply (do_ext _ (fun t => / deg n adj k * inner (expi (th k t)) (row n (lap n adj) k (fun j => r j t)))); [intros; apply inner_scal|].
  apply do_scal, (perpendicular n adj w0 K0 K1 r th); try assumption; [lia|lra].
Qed.

(* ---- a common drift ---- *)
Lemma mean_dies (F F' : R -> R) : (forall t, 0 <= t -> is_derive F t (F' t)) -> dies_out F' -> dies_out (fun t => F t / t).
Proof.
  intros D H e He. destruct (H (e / 2) ltac:(lra)) as (T & HT & P). pose proof (Rabs_pos (F T)) as A. exists (T + 2 * Rabs (F T) / e + 1).
  assert (Q0 : 0 <= 2 * Rabs (F T) / e) by (apply Rdiv_le_0_compat; lra). split; [lra|]. intros t Ht.
  pose proof (slope_le F F' (e / 2) T t ltac:(lra) ltac:(intros u Hu; split; [apply D; lra|left; apply P; lra])) as L.
  unfold Rdiv. rewrite Rabs_mult, (Rabs_pos_eq (/ t)) by (left; apply Rinv_0_lt_compat; lra). apply Rmult_lt_reg_r with t; [lra|]. rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra.
  assert (X : Rabs (F t) <= Rabs (F T) + e / 2 * (t - T)).
  { replace (F t) with (F T + (F t - F T)) by ring. eapply Rle_trans; [apply Rabs_triang|]. lra. }
  assert (Y : Rabs (F T) < e / 2 * (t - T)).
  { apply Rle_lt_trans with (e / 2 * (2 * Rabs (F T) / e)); [right; field; lra|]. apply Rmult_lt_compat_l; lra. }
  assert (e * t = e / 2 * (t - T) + e / 2 * (t - T) + e * T) by field. nra.
Qed.
Lemma row_moved n adj k (x y : nat -> C) a : (k < n)%nat -> (forall j, y j = (x j + a)%C) -> row n (lap n adj) k y = row n (lap n adj) k x.
Proof. intros Hk E. rewrite !row_lap by exact Hk. apply Csum_ext. intros j _. rewrite !E. ring. Qed.
Definition drifting n adj w0 K0 K1 (f : C) (r : nat -> R -> C) (th : nat -> R -> R) := forall k t, (k < n)%nat -> 0 <= t ->
  is_velocity (r k) t (expi (th k t) + f)%C /\ is_derive (th k) t (control5 n adj w0 K0 K1 r th t k).
Lemma undrifted n adj w0 K0 K1 f r th : drifting n adj w0 K0 K1 f r th -> shaped n adj w0 K0 K1 (fun k t => (r k t - RtoC t * f)%C) th.
Proof.
  intros M k t Hk Ht. destruct (M k t Hk Ht) as [[V1 V2] U]. split.
  - split.
    + apply (is_derive_ext (fun s => fst (r k s) - fst f * s)); [intros; cbn; ring|]. eapply D_eq; [apply D_minus; [exact V1|apply D_scal, D_id]|]. cbn. ring.
    + apply (is_derive_ext (fun s => snd (r k s) - snd f * s)); [intros; cbn; ring|]. eapply D_eq; [apply D_minus; [exact V2|apply D_scal, D_id]|]. cbn. ring.
  - eapply D_eq; [exact U|]. unfold control5, aS. do 4 f_equal. apply (row_moved n adj k _ _ (RtoC t * f)%C Hk). intros j. unfold centres, circle_centre. ring.
Qed.
Theorem drift_travels : forall n adj w0 K0 K1 f r th, (1 <= n)%nat -> undirected adj -> strongly_connected n adj -> w0 <> 0 -> 0 < K0 ->
  drifting n adj w0 K0 K1 f r th ->
  (exists B, forall t j k, 0 <= t -> (j < n)%nat -> (k < n)%nat -> Cmod (r k t - r j t)%C <= B) /\
  forall k, (k < n)%nat ->
    (forall e, 0 < e -> exists T, 0 <= T /\ forall t, T <= t -> Cmod (RtoC (/ t) * (r k t - r k 0%R) - f)%C < e) /\
    exists v, (forall t, 0 <= t -> is_velocity (fun s => circle_centre w0 (r k s) (th k s)) t (v t)) /\
      forall e, 0 < e -> exists T, 0 <= T /\ forall t, T <= t -> Cmod (v t - f)%C < e.
Proof.
  intros n adj w0 K0 K1 f r th Hn HS SC Hw HK Dr. pose proof (INR_pos n Hn) as Pn. set (q := fun k t => (r k t - RtoC t * f)%C). pose proof (undrifted n adj w0 K0 K1 f r th Dr) as M. fold q in M.
  set (c := cc w0 q th). assert (Ec : forall k t, c k t = (circle_centre w0 (r k t) (th k t) - RtoC t * f)%C) by (intros; unfold c, cc, q, circle_centre; ring).
  assert (Rad : forall k t, Cmod (circle_centre w0 (r k t) (th k t) - r k t)%C <= / Rabs w0).
  { intros k t. unfold circle_centre. replace (r k t + RtoC (/ w0) * (Ci * expi (th k t)) - r k t)%C with (RtoC (/ w0) * (Ci * expi (th k t)))%C by ring.
    rewrite !Cmod_mult, Cmod_expi, Cmod_R, Rabs_inv. replace (Cmod Ci) with 1; [lra|]. unfold Cmod, Ci. cbn. replace (0 * (0 * 1) + 1 * (1 * 1)) with 1 by ring. symmetry. apply sqrt_1. }
  split.
  - destruct (spacing_proper n adj Hn HS SC) as [B1 [HB1 P]]. destruct (spacing_bounded n adj w0 K0 K1 q th Hn HS SC Hw HK M) as (B2 & HB2 & Sb).
    set (b := B1 * B2 + 1). exists (2 * b + 2 * / Rabs w0). intros t j k Ht Hj Hk.
    assert (Far : forall i, (i < n)%nat -> Cmod (c i t - c 0%nat t)%C <= b).
    { intros i Hi. rewrite <- (Rabs_pos_eq (Cmod _)) by apply Cmod_ge_0. assert (0 <= B1 * B2) by nra. apply sqr_Rabs; [unfold b; lra|].
      rewrite <- dist2_Cmod. specialize (P (fun i => c i t)). eapply Rle_trans; [apply P; lia|]. specialize (Sb t Ht). fold c in Sb.
      apply Rle_trans with (B1 * B2); [apply Rmult_le_compat_l; lra|]. unfold b. nra. }
    pose proof (Far j Hj) as F1. pose proof (Far k Hk) as F2. pose proof (Rad j t) as R1. pose proof (Rad k t) as R2.
    replace (r k t - r j t)%C with ((c k t - c 0%nat t) + - (c j t - c 0%nat t) + - (circle_centre w0 (r k t) (th k t) - r k t) + (circle_centre w0 (r j t) (th j t) - r j t))%C by (rewrite !Ec; ring).
    eapply Rle_trans; [apply Cmod_triangle|]. eapply Rle_trans; [apply Rplus_le_compat_r, Cmod_triangle|]. eapply Rle_trans; [apply Rplus_le_compat_r, Rplus_le_compat_r, Cmod_triangle|]. rewrite !Cmod_opp. lra.
  - intros k Hk. set (vel := vv n adj w0 K0 K1 q th k).
    assert (Dc : forall t, 0 <= t -> is_velocity (c k) t (vel t)) by (intros t Ht; exact (d_cc n adj w0 K0 K1 q th Hn Hw M k t Hk Ht)).
    pose proof (f_dies n adj w0 K0 K1 q th Hn HS SC Hw HK M k Hk) as Fd.
    assert (Vd : dies_out (fun t => fst (vel t)) /\ dies_out (fun t => snd (vel t))).
    { split; [apply (do_ext _ (fun t => (- / INR n * ff n adj w0 K0 K1 q th k t) * cos (th k t)))|apply (do_ext _ (fun t => (- / INR n * ff n adj w0 K0 K1 q th k t) * sin (th k t)))];
        try (intros t _; unfold vel, vv; cbn; ring); (apply do_mult; [now apply do_scal|]); apply b_trig; intros; [apply COS_bound|apply SIN_bound]. }
    assert (Small : forall g : R -> C, dies_out (fun t => fst (g t)) -> dies_out (fun t => snd (g t)) -> forall e, 0 < e -> exists T, 0 <= T /\ forall t, T <= t -> Cmod (g t) < e).
    { intros g G1 G2 e He. destruct (G1 (e / 2) ltac:(lra)) as (T1 & HT1 & P1). destruct (G2 (e / 2) ltac:(lra)) as (T2 & HT2 & P2). exists (Rmax T1 T2). pose proof (Rmax_l T1 T2). pose proof (Rmax_r T1 T2).
      split; [lra|]. intros t Ht. eapply Rle_lt_trans; [apply Cmod_le|]. specialize (P1 t ltac:(lra)). specialize (P2 t ltac:(lra)). lra. }
    split.
    + set (z := fun t => (r k t - r k 0%R - RtoC t * f)%C). assert (Z : forall t, z t = (c k t - c k 0%R - (circle_centre w0 (r k t) (th k t) - r k t) + (circle_centre w0 (r k 0%R) (th k 0%R) - r k 0%R))%C).
      { intros t. rewrite !Ec. unfold z. apply injective_projections; cbn; ring. }
      assert (Inv : dies_out (fun t => / t)).
      { intros e He. exists (/ e + 1). assert (0 < / e) by now apply Rinv_0_lt_compat. split; [lra|]. intros t Ht. rewrite Rabs_pos_eq by (left; apply Rinv_0_lt_compat; lra).
        rewrite <- (Rinv_inv e). apply Rinv_lt_contravar; [apply Rmult_lt_0_compat; lra|lra]. }
      assert (One : forall p : C -> R, (forall a b, p (a - b)%C = p a - p b) -> (forall a b, p (a + b)%C = p a + p b) -> (forall a, Rabs (p a) <= Cmod a) ->
        (forall t, 0 <= t -> is_derive (fun s => p (c k s)) t (p (vel t))) -> dies_out (fun t => p (vel t)) -> dies_out (fun t => / t * p (z t))).
      { intros p Pm Pp Pb Dp Vp. apply (do_ext _ (fun t => p (c k t) / t + / t * (- p (c k 0%R) + - p (circle_centre w0 (r k t) (th k t) - r k t)%C + p (circle_centre w0 (r k 0%R) (th k 0%R) - r k 0%R)%C))).
        - intros t _. rewrite Z, Pp, !Pm. unfold Rdiv. ring.
        - apply do_plus; [now apply (mean_dies _ (fun t => p (vel t)))|]. apply do_mult; [exact Inv|]. apply ba_plus; [apply ba_plus; [apply ba_const|]|apply ba_const].
          exists (/ Rabs w0). split; [apply Rinv_0_lt_compat; now apply Rabs_pos_lt|]. intros t _. rewrite Rabs_Ropp. eapply Rle_trans; [apply Pb|apply Rad]. }
      destruct Vd as [V1 V2].
      assert (Cf : forall a : C, Rabs (fst a) <= Cmod a /\ Rabs (snd a) <= Cmod a).
      { intros a. split; (eapply Rle_trans; [|apply Rmax_Cmod]); [apply Rmax_l|apply Rmax_r]. }
      pose proof (One fst (fun _ _ => eq_refl) (fun _ _ => eq_refl) (fun a => proj1 (Cf a)) (fun t Ht => proj1 (Dc t Ht)) V1) as O1.
      pose proof (One snd (fun _ _ => eq_refl) (fun _ _ => eq_refl) (fun a => proj2 (Cf a)) (fun t Ht => proj2 (Dc t Ht)) V2) as O2.
      intros e He. destruct (Small (fun t => RtoC (/ t) * z t)%C) with (e := e) as (T & HT & Q1); [|  |exact He|].
      * apply (do_ext _ (fun t => / t * fst (z t))); [intros; cbn; ring|exact O1].
      * apply (do_ext _ (fun t => / t * snd (z t))); [intros; cbn; ring|exact O2].
      * exists (T + 1). split; [lra|]. intros t Ht. specialize (Q1 t ltac:(lra)). replace (RtoC (/ t) * (r k t - r k 0%R) - f)%C with (RtoC (/ t) * z t)%C; [exact Q1|].
        unfold z. apply injective_projections; cbn; field; lra.
    + exists (fun t => (vel t + f)%C). split.
      * intros t Ht. destruct (Dc t Ht) as [C1 C2]. split.
        -- apply (is_derive_ext (fun s => fst (c k s) + fst f * s)); [intros s; rewrite Ec; cbn; ring|]. eapply D_eq; [apply (D_plus (fun s => fst (c k s)) (fun s => fst f * s)); [exact C1|apply (D_scal (fst f) (fun s => s)), D_id]|]. cbn. ring.
        -- apply (is_derive_ext (fun s => snd (c k s) + snd f * s)); [intros s; rewrite Ec; cbn; ring|]. eapply D_eq; [apply (D_plus (fun s => snd (c k s)) (fun s => snd f * s)); [exact C2|apply (D_scal (snd f) (fun s => s)), D_id]|]. cbn. ring.
      * intros e He. destruct (Small vel (proj1 Vd) (proj2 Vd) e He) as (T & HT & Q1). exists T. split; [exact HT|]. intros t Ht. replace (vel t + f - f)%C with (vel t) by ring. now apply Q1.
Qed.
