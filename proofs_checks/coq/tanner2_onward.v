(* Tanner, Jadbabaie, Pappas, links by distance: every solution of (10) until a time, K of the whole vector field, goes on for all time; so all of them have
   velocities that agree in the limit where the graph is connected at all times.
   Until the time, speeds and accelerations have bounds, so positions and velocities have limits there; no two agents meet, and a solution starts from the limits.
     tanner2.thm2_vel, tanner2.arbswitch (corrected, clause 1). *)
From Coq Require Import Reals Lra Lia Psatz Classical.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums inclusions paley_model paley_phase paley_laplacian paley_gradient tanner_energy tanner_flock tanner2_filippov tanner2_solutions.
From Flockproof Require tanner2_appendix.
Open Scope R_scope.

Lemma bounds_while n V V' R0 (q p : nat -> R -> C) c d1 b : 0 < R0 -> potentials n complete V V' -> moves_while n V' R0 q p (fun u => u < c) -> allows n V R0 (fun i => q i 0) (fun i => p i 0) d1 -> 0 <= b ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> i <> j -> forall x, d1 / 2 <= x <= R0 -> Rabs (V' i j x) <= b) ->
  let S := sqrt (2 * start_power n V R0 (fun i => q i 0) (fun i => p i 0)) in let B := INR n * (2 * S + b) in
  (forall t i j, 0 <= t < c -> (i < n)%nat -> (j < n)%nat -> i <> j -> d1 < Cmod (q i t - q j t)%C) /\
  (forall t i, 0 <= t < c -> (i < n)%nat -> Cmod (p i t) <= S) /\
  forall i s u, (i < n)%nat -> 0 <= s <= u -> u < c -> Rabs (fst (p i u) - fst (p i s)) <= B * (u - s) /\ Rabs (snd (p i u) - snd (p i s)) <= B * (u - s).
Proof.
  intros HR P M Al Hb Fb S B. set (d := d1 / 2). assert (Hd1 : 0 < d1 < R0) by apply Al. assert (Hd : 0 < d < R0) by (unfold d; lra). set (E := start_power n V R0 (fun i => q i 0) (fun i => p i 0)) in *. assert (S0 : 0 <= S) by apply sqrt_pos.
  assert (Far : forall t i j, 0 <= t < c -> (i < n)%nat -> (j < n)%nat -> i <> j -> d1 < Cmod (q i t - q j t)%C).
  { intros t i j Ht Hi Hj Ne. apply (kept_apart_while n V V' R0 q p HR P _ M d1 Al t ltac:(lra)); try assumption. intros; lra. }
  assert (Sp : forall t i, 0 <= t < c -> (i < n)%nat -> Cmod (p i t) <= S).
  { intros t i Ht Hi.
    assert (Fl : power n V R0 q p d t <= power n V R0 q p d 0 - 0 * (t - 0)).
    { apply (power_falls n V V' R0 q p P _ M d Hd); [lra|intros; lra| |].
      - intros u k j Hu Hk Hj Ne. pose proof (Far u k j ltac:(lra) Hk Hj Ne). unfold d. lra.
      - intros u _. rewrite Rmult_0_r. apply Sum_ge0. intros k _. apply Sum_ge0. intros j _. destruct (by_distance _ R0 k j); [apply dist2_ge0|lra]. }
    assert (Pe : power n V R0 q p d 0 = E).
    { unfold power, E, start_power. f_equal. apply Sum_ext. intros k Hk. f_equal. apply Sum_ext. intros l Hl. unfold store. destruct (Nat.eqb_spec k l) as [_|Nkl]; [reflexivity|].
      pose proof (proj1 (proj2 Al k l Hk Hl Nkl)). rewrite clamp_mid by (unfold d; lra). reflexivity. }
    pose proof (speed_le n V V' R0 q p P d Hd i t Hi) as Q. rewrite <- (sqrt_pow2 (Cmod (p i t))) by apply Cmod_ge_0. apply sqrt_le_1_alt. fold E. lra. }
  split; [exact Far|]. split; [exact Sp|]. intros i s u Hi Hs Hu. destruct (v_axes n V' R0 q p _ M i Hi) as [A1 A2]. destruct M as (_ & _ & _ & N & HN & Mz).
  assert (Z : forall t, s <= t <= u -> ~ N t -> exists z : C, is_velocity (p i) t z /\ Cmod z <= B).
  { intros t Ht Nt. assert (A : apart_at n complete (fun i => q i t)).
    { intros k l Hk Hl L X. assert (Ne : k <> l) by (intros ->; unfold complete in L; rewrite Nat.eqb_refl in L; discriminate).
      pose proof (Far t k l ltac:(lra) Hk Hl Ne) as F. rewrite X in F. replace (q l t - q l t)%C with (RtoC 0) in F by ring. rewrite Cmod_0 in F. lra. }
    destruct (Mz t ltac:(lra) ltac:(lra) Nt A) as (z & Kz & Vz). exists (z i). split; [now apply Vz|].
    apply (hull_bounded n V V' R0 (fun i => q i t) (fun i => p i t) P A z S b Kz); [intros k Hk; apply Sp; [lra|exact Hk]| |exact S0|exact Hb|exact Hi].
    intros k l Hk Hl Ne Le. unfold pull. rewrite (linked_pair k l Ne), Cmod_mult, Cmod_R. pose proof (Far t k l ltac:(lra) Hk Hl Ne).
    unfold Rdiv. rewrite Rabs_mult, (Rabs_pos_eq (/ _)) by (left; apply Rinv_0_lt_compat; lra). rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra. apply Fb; try assumption. lra. }
  assert (G : forall f : R -> R, ac f -> (forall t, s <= t <= u -> ~ N t -> exists l, is_derive f t l /\ Rabs l <= B) -> Rabs (f u - f s) <= B * (u - s)).
  { intros f Af D. assert (U1 : f u <= f s + B * (u - s)).
    { apply (ac_le f N s u B Af HN ltac:(lra)). intros t Ht Nt. destruct (D t Ht Nt) as (l & Dl & Hl). exists l. split; [exact Dl|]. apply Rabs_le_between in Hl. lra. }
    assert (U2 : -1 * f u <= -1 * f s + B * (u - s)).
    { apply (ac_le (fun t => -1 * f t) N s u B (ac_scal (-1) f Af) HN ltac:(lra)). intros t Ht Nt. destruct (D t Ht Nt) as (l & Dl & Hl). exists (-1 * l). split; [now apply D_scal|]. apply Rabs_le_between in Hl. lra. }
    apply Rabs_le. lra. }
  assert (Mx : forall z : C, Cmod z <= B -> Rabs (fst z) <= B /\ Rabs (snd z) <= B).
  { intros z Hz. pose proof (Rmax_Cmod z). pose proof (Rmax_l (Rabs (fst z)) (Rabs (snd z))). pose proof (Rmax_r (Rabs (fst z)) (Rabs (snd z))). lra. }
  split.
  - apply (G (fun t => fst (p i t)) A1). intros t Ht Nt. destruct (Z t Ht Nt) as (z & [V1 V2] & Bz). destruct (Mx z Bz). exists (fst z). now split.
  - apply (G (fun t => snd (p i t)) A2). intros t Ht Nt. destruct (Z t Ht Nt) as (z & [V1 V2] & Bz). destruct (Mx z Bz). exists (snd z). now split.
Qed.

(* ---- functions put together at T ---- *)
Definition put (T : R) {A : Type} (f g : R -> A) (t : R) : A := if Rlt_dec t T then f t else g (t - T).
Lemma put_before T (f g : R -> R) t l : t < T -> is_derive f t l -> is_derive (put T f g) t l.
Proof.
  intros Ht. apply is_derive_ext_loc. exists (mkposreal (T - t) ltac:(lra)). intros x Hx. change (Rabs (x - t) < T - t) in Hx. apply Rabs_def2 in Hx. unfold put. destruct (Rlt_dec x T); [reflexivity|lra].
Qed.
Lemma put_after T (f g : R -> R) t l : T < t -> is_derive g (t - T) l -> is_derive (put T f g) t l.
Proof.
  intros Ht D. apply (is_derive_ext_loc (fun x => g (x - T))).
  - exists (mkposreal (t - T) ltac:(lra)). intros x Hx. change (Rabs (x - t) < t - T) in Hx. apply Rabs_def2 in Hx. unfold put. destruct (Rlt_dec x T); [lra|reflexivity].
  - eapply D_eq; [apply (D_comp g (fun x => x - T)); [exact D|apply D_minus; [apply D_id|apply D_const]]|]. ring.
Qed.
Lemma put_at T (f f' g : R -> R) K B l : 0 < T -> 0 <= K -> 0 <= B -> (forall u, 0 <= u < T -> is_derive f u (f' u) /\ Rabs (f' u - l) <= B * (T - u)) -> (forall u, 0 <= u < T -> Rabs (f u - g 0) <= K * (T - u)) ->
  is_derive g 0 l -> is_derive (put T f g) T l.
Proof.
  intros HT HK HB D L Dg. assert (FT : put T f g T = g 0) by (unfold put; destruct (Rlt_dec T T); [lra|f_equal; ring]). apply tanner2_appendix.rates_derivative.
  - intros e He. apply is_derive_Reals in Dg. destruct (Dg e He) as [d Hd]. exists d. split; [apply cond_pos|]. intros h Hh. rewrite FT. unfold put. destruct (Rlt_dec (T + 1 * h) T); [lra|]. replace (T + 1 * h - T) with (0 + h) by ring. apply Hd; [lra|]. rewrite Rabs_pos_eq; lra.
  - intros e He. exists (Rmin T (e / (B + 1))). pose proof (Rmin_l T (e / (B + 1))). pose proof (Rmin_r T (e / (B + 1))). split; [apply Rmin_glb_lt; [lra|apply Rdiv_lt_0_compat; lra]|]. intros h Hh. rewrite FT. unfold put. destruct (Rlt_dec (T + -1 * h) T); [|lra].
    replace (T + -1 * h) with (T - h) by ring.
    assert (W : Rabs (f (T - h) - g 0 + l * h) <= B * h * h).
    { apply le_epsilon. intros w Hw. set (k := Rmin (h / 2) (w / (K + Rabs l + 1))). pose proof (Rabs_pos l). assert (Hk : 0 < k) by (apply Rmin_glb_lt; [lra|apply Rdiv_lt_0_compat; lra]). assert (k <= h / 2) by apply Rmin_l.
      assert (Kk : (K + Rabs l) * k <= w).
      { apply Rle_trans with ((K + Rabs l + 1) * k); [nra|]. apply Rle_trans with ((K + Rabs l + 1) * (w / (K + Rabs l + 1))); [apply Rmult_le_compat_l; [lra|apply Rmin_r]|right; field; lra]. }
      pose proof (slope_le (fun u => f u - l * u) (fun u => f' u - l * 1) (B * h) (T - h) (T - k) ltac:(lra)) as Q.
      assert (Q' : Rabs (f (T - k) - l * (T - k) - (f (T - h) - l * (T - h))) <= B * h * (T - k - (T - h))).
      { apply Q. intros u Hu. destruct (D u ltac:(lra)) as [D1 D2]. split; [apply D_minus; [exact D1|apply D_scal, D_id]|]. rewrite Rmult_1_r. eapply Rle_trans; [exact D2|]. apply Rmult_le_compat_l; lra. }
      pose proof (L (T - k) ltac:(lra)) as L1. replace (T - (T - k)) with k in L1 by ring.
      replace (f (T - h) - g 0 + l * h) with (- (f (T - k) - l * (T - k) - (f (T - h) - l * (T - h))) + ((f (T - k) - g 0) + l * k)) by ring.
      eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_Ropp. pose proof (Rabs_triang (f (T - k) - g 0) (l * k)) as T1. rewrite Rabs_mult, (Rabs_pos_eq k) in T1 by lra.
      assert (B * h * (T - k - (T - h)) <= B * h * h) by (apply Rmult_le_compat_l; [apply Rmult_le_pos; lra|lra]). lra. }
    replace ((f (T - h) - g 0) / h - - l) with ((f (T - h) - g 0 + l * h) / h) by (field; lra). unfold Rdiv. rewrite Rabs_mult, (Rabs_pos_eq (/ h)) by (left; apply Rinv_0_lt_compat; lra).
    apply Rle_lt_trans with (B * h * h * / h); [apply Rmult_le_compat_r; [left; apply Rinv_0_lt_compat; lra|exact W]|]. rewrite Rmult_assoc, Rinv_r, Rmult_1_r by lra.
    apply Rle_lt_trans with (B * (e / (B + 1))); [apply Rmult_le_compat_l; lra|]. apply Rmult_lt_reg_r with (B + 1); [lra|]. replace (B * (e / (B + 1)) * (B + 1)) with (B * e) by (field; lra). lra.
Qed.
Lemma ac_later F T : 0 <= T -> ac F -> ac (fun t => F (Rmax (t - T) 0)).
Proof.
  intros HT A T' e HT' He. destruct (A T' e HT' He) as (d & Hd & P). exists d. split; [exact Hd|]. intros m a b I O Q.
  assert (X : forall x y, x <= y -> Rmax (x - T) 0 <= Rmax (y - T) 0 /\ Rmax (y - T) 0 - Rmax (x - T) 0 <= y - x) by (intros x y H; unfold Rmax; destruct (Rle_dec (x - T) 0), (Rle_dec (y - T) 0); lra).
  apply (P m (fun k => Rmax (a k - T) 0) (fun k => Rmax (b k - T) 0)).
  - intros k Hk. destruct (I k Hk) as [[I1 I2] I3]. split; [split; [apply Rmax_r|now apply X]|apply Rmax_lub; lra].
  - intros k Hk. apply X. now apply O.
  - apply Rle_lt_trans with (2 := Q). apply Sum_le. intros k Hk. destruct (I k Hk) as [[I1 I2] I3]. now apply X.
Qed.
Lemma put_ac T (f g : R -> R) B : 0 < T -> 0 <= B -> (forall s u, 0 <= s <= u -> u < T -> Rabs (f u - f s) <= B * (u - s)) -> (forall u, 0 <= u < T -> Rabs (f u - g 0) <= B * (T - u)) -> ac g -> ac (put T f g).
Proof.
  intros HT HB L1 L2 Ag. set (h := fun t => put T f (fun _ => g 0) (Rmin t T)).
  assert (Ah : ac h).
  { apply ac_lipschitz. intros T' _. exists (B + 1). split; [lra|]. intros x y Hx _. apply Rle_trans with (B * (y - x)); [|apply Rmult_le_compat_r; lra]. unfold h, put, Rmin.
    destruct (Rle_dec x T), (Rle_dec y T); repeat destruct (Rlt_dec _ T); try lra; try (rewrite Rminus_eq_0, Rabs_R0; apply Rmult_le_pos; lra).
    - apply L1; lra.
    - rewrite Rabs_minus_sym. eapply Rle_trans; [apply L2; lra|]. apply Rmult_le_compat_l; lra.
    - rewrite Rabs_minus_sym. eapply Rle_trans; [apply L2; lra|]. apply Rmult_le_compat_l; lra. }
  apply (ac_of _ (fun t => h t + g (Rmax (t - T) 0)) (ac_plus _ _ Ah (ac_later g T ltac:(lra) Ag))). intros T' _. exists 1. split; [lra|]. intros x y Hx _. rewrite Rmult_1_l. right. f_equal.
  assert (Eq : forall t, h t + g (Rmax (t - T) 0) = put T f g t + g 0).
  { intros t. unfold h, put. destruct (Rlt_or_le t T) as [G|G].
    - rewrite Rmin_left, Rmax_right by lra. destruct (Rlt_dec t T); [reflexivity|lra].
    - rewrite Rmin_right, Rmax_left by lra. destruct (Rlt_dec T T), (Rlt_dec t T); try lra. }
  rewrite !Eq. ring.
Qed.
Lemma axes_ac (z : R -> C) : ac (fun t => fst (z t)) -> ac (fun t => snd (z t)) -> absolutely_continuous z.
Proof.
  intros A B T e HT He. destruct (A T (e / 2) HT ltac:(lra)) as (d & Hd & P). destruct (B T (e / 2) HT ltac:(lra)) as (d' & Hd' & Q). exists (Rmin d d'). pose proof (Rmin_l d d'). pose proof (Rmin_r d d').
  split; [now apply Rmin_glb_lt|]. intros m a b I O S. specialize (P m a b I O ltac:(lra)). specialize (Q m a b I O ltac:(lra)).
  apply Rle_lt_trans with (Sum m (fun k => Rabs (fst (z (b k)) - fst (z (a k))) + Rabs (snd (z (b k)) - snd (z (a k))))); [|rewrite Sum_plus; lra].
  apply Sum_le. intros k _. eapply Rle_trans; [apply axes_Cmod|]. cbn. right. reflexivity.
Qed.
Lemma negligible_later (P : R -> Prop) T : negligible P -> negligible (fun t => P (t - T)).
Proof.
  intros H e He. destruct (H e He) as (a & b & A1 & A2 & A3). exists (fun k => a k + T), (fun k => b k + T). split; [intros k; specialize (A1 k); lra|]. split.
  - intros t Pt. destruct (A2 _ Pt) as [k Hk]. exists k. lra.
  - intros m. rewrite (Sum_ext m _ (fun k => b k - a k)) by (intros; ring). apply A3.
Qed.

Theorem goes_on : forall n V V' R0 T (r v : nat -> R -> C), 0 < R0 -> potentials n complete V V' -> 0 < T -> motion10_until T n V' R0 r v ->
  exists r' v', (forall t i, t < T -> r' i t = r i t /\ v' i t = v i t) /\ motion10 n V' R0 r' v'.
Proof.
  intros n V V' R0 T r v HR P HT M. pose proof M as (A0 & Mr & _ & N & HN & Mz). destruct (start_allows n V V' R0 (fun i => r i 0) (fun i => v i 0) HR P A0) as (d1 & Al). assert (Hd1 : 0 < d1 < R0) by apply Al.
  assert (Fb : exists b, 0 < b /\ forall i j, (i < n)%nat -> (j < n)%nat -> i <> j -> forall x, d1 / 2 <= x <= R0 -> Rabs (V' i j x) <= b).
  { apply (uniform_pairs n (fun i j b => i <> j -> forall x, d1 / 2 <= x <= R0 -> Rabs (V' i j x) <= b)).
    - intros i j b b' H L Ne x Hx. specialize (H Ne x Hx). lra.
    - intros i j Hi Hj. destruct (Nat.eq_dec i j) as [->|Ne]; [exists 1; congruence|].
      destruct (slope_bound (V i j) (V' i j) (d1 / 2) R0 ltac:(lra)) as (L & HL & B & _).
      { intros x Hx. destruct (pair_slopes n V V' P i j Hi Hj Ne x Hx) as (A1 & A2 & _). now split. }
      exists L. intros _. exact B. }
  destruct Fb as (b & Hb & Fb). set (S := sqrt (2 * start_power n V R0 (fun i => r i 0) (fun i => v i 0))). set (B := INR n * (2 * S + b)). pose proof (pos_INR n) as Pn. assert (S0 : 0 <= S) by apply sqrt_pos. assert (B0 : 0 <= B) by (apply Rmult_le_pos; lra).
  assert (Bd : forall u, 0 <= u < T -> (forall i j, (i < n)%nat -> (j < n)%nat -> i <> j -> d1 < Cmod (r i u - r j u)%C) /\ (forall i, (i < n)%nat -> Cmod (v i u) <= S) /\
    forall i s, (i < n)%nat -> 0 <= s <= u -> Rabs (fst (v i u) - fst (v i s)) <= B * (u - s) /\ Rabs (snd (v i u) - snd (v i s)) <= B * (u - s)).
  { intros u Hu. set (c := (u + T) / 2). assert (Hc : u < c < T) by (unfold c; lra). destruct (straightened n V' R0 r v T c M ltac:(lra)) as (q & p & Eq & W).
    assert (E1 : (fun k => q k 0) = (fun k => r k 0)) by (apply FunctionalExtensionality.functional_extensionality; intros k; apply Eq; lra).
    assert (E2 : (fun k => p k 0) = (fun k => v k 0)) by (apply FunctionalExtensionality.functional_extensionality; intros k; apply Eq; lra).
    destruct (bounds_while n V V' R0 q p c d1 b HR P W ltac:(rewrite E1, E2; exact Al) ltac:(lra) Fb) as (Q1 & Q2 & Q3). rewrite E1, E2 in *. fold S in Q2, Q3. fold B in Q3. split; [|split].
    - intros i j Hi Hj Ne. rewrite <- (proj1 (Eq i u ltac:(lra))), <- (proj1 (Eq j u ltac:(lra))). apply Q1; try assumption. lra.
    - intros i Hi. rewrite <- (proj2 (Eq i u ltac:(lra))). apply Q2; [lra|exact Hi].
    - intros i s Hi Hs. rewrite <- (proj2 (Eq i u ltac:(lra))), <- (proj2 (Eq i s ltac:(lra))). apply Q3; try assumption; lra. }
  assert (Ax : forall i u, (i < n)%nat -> 0 <= u < T -> Rabs (fst (v i u)) <= S /\ Rabs (snd (v i u)) <= S).
  { intros i u Hi Hu. pose proof (proj1 (proj2 (Bd u Hu)) i Hi). pose proof (Rmax_Cmod (v i u)). pose proof (Rmax_l (Rabs (fst (v i u))) (Rabs (snd (v i u)))). pose proof (Rmax_r (Rabs (fst (v i u))) (Rabs (snd (v i u)))). lra. }
  assert (Lr : forall i s u, (i < n)%nat -> 0 <= s <= u -> u < T -> Rabs (fst (r i u) - fst (r i s)) <= S * (u - s) /\ Rabs (snd (r i u) - snd (r i s)) <= S * (u - s)).
  { intros i s u Hi Hs Hu. split.
    - apply (slope_le (fun t => fst (r i t)) (fun t => fst (v i t))); [lra|]. intros t Ht. split; [apply (Mr t i); [lra|exact Hi]|apply Ax; [exact Hi|lra]].
    - apply (slope_le (fun t => snd (r i t)) (fun t => snd (v i t))); [lra|]. intros t Ht. split; [apply (Mr t i); [lra|exact Hi]|apply Ax; [exact Hi|lra]]. }
  assert (Lv : forall i s u, (i < n)%nat -> 0 <= s <= u -> u < T -> Rabs (fst (v i u) - fst (v i s)) <= B * (u - s) /\ Rabs (snd (v i u) - snd (v i s)) <= B * (u - s)).
  { intros i s u Hi Hs Hu. apply (Bd u ltac:(lra)); assumption. }
  (* the limits *)
  set (rT := fun i => (end_limit (fun t => fst (r i t)) S T, end_limit (fun t => snd (r i t)) S T) : C). set (vT := fun i => (end_limit (fun t => fst (v i t)) B T, end_limit (fun t => snd (v i t)) B T) : C).
  assert (Nr : forall i u, (i < n)%nat -> 0 <= u < T -> Rabs (fst (r i u) - fst (rT i)) <= S * (T - u) /\ Rabs (snd (r i u) - snd (rT i)) <= S * (T - u)).
  { intros i u Hi Hu. split; cbn [fst snd rT].
    - apply (end_limit_near (fun t => fst (r i t)) S T u HT S0); [|exact Hu]. intros s x Hs Hx. now apply Lr.
    - apply (end_limit_near (fun t => snd (r i t)) S T u HT S0); [|exact Hu]. intros s x Hs Hx. now apply Lr. }
  assert (Nv : forall i u, (i < n)%nat -> 0 <= u < T -> Rabs (fst (v i u) - fst (vT i)) <= B * (T - u) /\ Rabs (snd (v i u) - snd (vT i)) <= B * (T - u)).
  { intros i u Hi Hu. split; cbn [fst snd vT].
    - apply (end_limit_near (fun t => fst (v i t)) B T u HT B0); [|exact Hu]. intros s x Hs Hx. now apply Lv.
    - apply (end_limit_near (fun t => snd (v i t)) B T u HT B0); [|exact Hu]. intros s x Hs Hx. now apply Lv. }
  assert (AT : apart_at n complete rT).
  { intros i j Hi Hj L Eq. assert (Ne : i <> j) by (intros ->; unfold complete in L; rewrite Nat.eqb_refl in L; discriminate).
    set (h := Rmin (T / 2) (d1 / (8 * (S + 1)))). assert (Hh : 0 < h) by (apply Rmin_glb_lt; [lra|apply Rdiv_lt_0_compat; lra]). assert (h <= T / 2) by apply Rmin_l.
    assert (Sh : S * h <= d1 / 8). { apply Rle_trans with ((S + 1) * h); [nra|]. apply Rle_trans with ((S + 1) * (d1 / (8 * (S + 1)))); [apply Rmult_le_compat_l; [lra|apply Rmin_r]|right; field; lra]. }
    pose proof (proj1 (Bd (T - h) ltac:(lra)) i j Hi Hj Ne) as F. destruct (Nr i (T - h) Hi ltac:(lra)) as [X1 X2], (Nr j (T - h) Hj ltac:(lra)) as [Y1 Y2]. rewrite Eq in X1, X2. replace (T - (T - h)) with h in * by ring.
    pose proof (axes_Cmod (r i (T - h)%R - r j (T - h)%R)%C) as Q. cbn [fst snd Cminus Cplus Copp] in Q.
    pose proof (Rabs_triang (fst (r i (T - h)) - fst (rT j)) (- (fst (r j (T - h)) - fst (rT j)))) as T1. pose proof (Rabs_triang (snd (r i (T - h)) - snd (rT j)) (- (snd (r j (T - h)) - snd (rT j)))) as T2. rewrite Rabs_Ropp in T1, T2.
    replace (fst (r i (T - h)) - fst (rT j) + - (fst (r j (T - h)) - fst (rT j))) with (fst (r i (T - h)) + - fst (r j (T - h))) in T1 by ring. replace (snd (r i (T - h)) - snd (rT j) + - (snd (r j (T - h)) - snd (rT j))) with (snd (r i (T - h)) + - snd (r j (T - h))) in T2 by ring. lra. }
  destruct (solution_from n V V' R0 rT vT HR P AT) as (q & p & St & (_ & Mq & Aq & N2 & HN2 & Mz2)).
  exists (fun i => put T (r i) (q i)), (fun i => put T (v i) (p i)).
  assert (Bf : forall t i, t < T -> put T (r i) (q i) t = r i t /\ put T (v i) (p i) t = v i t) by (intros t i Ht; unfold put; destruct (Rlt_dec t T); [split; reflexivity|lra]).
  split; [exact Bf|].
  assert (Cp : forall f g : R -> C, (forall t, fst (put T f g t) = put T (fun s => fst (f s)) (fun s => fst (g s)) t) /\ forall t, snd (put T f g t) = put T (fun s => snd (f s)) (fun s => snd (g s)) t) by (intros f g; split; intros t; unfold put; destruct (Rlt_dec t T); reflexivity).
  split; [|split; [|split]].
  - intros i j Hi Hj L Eq. rewrite (proj1 (Bf 0 i HT)), (proj1 (Bf 0 j HT)) in Eq. now apply (A0 i j).
  - intros t i Ht Hi. destruct (Cp (r i) (q i)) as [C1 C2]. destruct (Rtotal_order t T) as [G|[G|G]].
    + rewrite (proj2 (Bf t i G)). destruct (Mr t i ltac:(lra) Hi) as [V1 V2]. split; [apply (is_derive_ext (put T (fun s => fst (r i s)) (fun s => fst (q i s)))); [intros; symmetry; apply C1|now apply put_before]|apply (is_derive_ext (put T (fun s => snd (r i s)) (fun s => snd (q i s)))); [intros; symmetry; apply C2|now apply put_before]].
    + subst t. assert (Ev : put T (v i) (p i) T = vT i) by (unfold put; destruct (Rlt_dec T T); [lra|]; rewrite Rminus_eq_0; now apply St). rewrite Ev. destruct (Mq 0 i ltac:(lra) Hi) as [V1 V2]. rewrite (proj2 (St i Hi)) in V1, V2. split.
      * apply (is_derive_ext (put T (fun s => fst (r i s)) (fun s => fst (q i s)))); [intros; symmetry; apply C1|]. apply (put_at T _ (fun s => fst (v i s)) _ S B); try assumption.
        -- intros u Hu. split; [now apply Mr|now apply Nv].
        -- intros u Hu. rewrite (proj1 (St i Hi)). now apply Nr.
      * apply (is_derive_ext (put T (fun s => snd (r i s)) (fun s => snd (q i s)))); [intros; symmetry; apply C2|]. apply (put_at T _ (fun s => snd (v i s)) _ S B); try assumption.
        -- intros u Hu. split; [now apply Mr|now apply Nv].
        -- intros u Hu. rewrite (proj1 (St i Hi)). now apply Nr.
    + assert (Ev : put T (v i) (p i) t = p i (t - T)) by (unfold put; destruct (Rlt_dec t T); [lra|reflexivity]). rewrite Ev. destruct (Mq (t - T) i ltac:(lra) Hi) as [V1 V2].
      split; [apply (is_derive_ext (put T (fun s => fst (r i s)) (fun s => fst (q i s)))); [intros; symmetry; apply C1|now apply put_after]|apply (is_derive_ext (put T (fun s => snd (r i s)) (fun s => snd (q i s)))); [intros; symmetry; apply C2|now apply put_after]].
  - intros i Hi. destruct (Cp (v i) (p i)) as [C1 C2]. destruct (ac_axes (p i) (Aq i Hi)) as [P1 P2]. assert (Ext : forall f g : R -> R, (forall t, f t = g t) -> ac g -> ac f).
    { intros f g E Ag. apply (ac_of f g Ag). intros T' _. exists 1. split; [lra|]. intros x y _ _. rewrite !E. lra. }
    apply axes_ac; [apply (Ext _ _ C1)|apply (Ext _ _ C2)]; apply (put_ac T _ _ B); try assumption.
    + intros s u Hs Hu. now apply Lv.
    + intros u Hu. rewrite (proj2 (St i Hi)). now apply Nv.
    + intros s u Hs Hu. now apply Lv.
    + intros u Hu. rewrite (proj2 (St i Hi)). now apply Nv.
  - exists (fun t => (N t \/ t = T) \/ N2 (t - T)). split.
    { apply negligible_or; [apply negligible_or; [exact HN|apply tanner2_appendix.negligible_at; lra]|now apply negligible_later]. }
    intros t Ht Nt. destruct (Rtotal_order t T) as [G|[G|G]]; [|tauto|].
    + intros At. assert (K : forall z, K10 n V' R0 (fun i => r i t) (fun i => v i t) z -> K10 n V' R0 (fun i => put T (r i) (q i) t) (fun i => put T (v i) (p i) t) z) by (intros z; unfold put; destruct (Rlt_dec t T); [exact (fun h => h)|lra]).
      destruct (Mz t ltac:(lra) ltac:(tauto)) as (z & Kz & Vz); [intros i j Hi Hj L Eq; apply (At i j Hi Hj L); now rewrite (proj1 (Bf t i G)), (proj1 (Bf t j G))|]. exists z. split; [now apply K|]. intros i Hi. destruct (Cp (v i) (p i)) as [C1 C2]. destruct (Vz i Hi) as [V1 V2].
      split; [apply (is_derive_ext (put T (fun s => fst (v i s)) (fun s => fst (p i s)))); [intros; symmetry; apply C1|now apply put_before]|apply (is_derive_ext (put T (fun s => snd (v i s)) (fun s => snd (p i s)))); [intros; symmetry; apply C2|now apply put_before]].
    + intros At. assert (K : forall z, K10 n V' R0 (fun i => q i (t - T)) (fun i => p i (t - T)) z -> K10 n V' R0 (fun i => put T (r i) (q i) t) (fun i => put T (v i) (p i) t) z) by (intros z; unfold put; destruct (Rlt_dec t T); [lra|exact (fun h => h)]).
      destruct (Mz2 (t - T) ltac:(lra) ltac:(tauto)) as (z & Kz & Vz); [intros i j Hi Hj L Eq; apply (At i j Hi Hj L); unfold put; destruct (Rlt_dec t T); [lra|exact Eq]|]. exists z. split; [now apply K|]. intros i Hi. destruct (Cp (v i) (p i)) as [C1 C2]. destruct (Vz i Hi) as [V1 V2].
      split; [apply (is_derive_ext (put T (fun s => fst (v i s)) (fun s => fst (p i s)))); [intros; symmetry; apply C1|now apply put_after]|apply (is_derive_ext (put T (fun s => snd (v i s)) (fun s => snd (p i s)))); [intros; symmetry; apply C2|now apply put_after]].
Qed.

(* solutions start from every state without coincident agents, and last; while the graph is connected, the velocities of all of them come to agree *)
Definition solutions_last n V' R0 := (forall q0 u0, apart_at n complete q0 -> exists r v, (forall i, (i < n)%nat -> r i 0 = q0 i /\ v i 0 = u0 i) /\ motion10 n V' R0 r v) /\
  forall T (r v : nat -> R -> C), 0 < T -> motion10_until T n V' R0 r v -> exists r' v', (forall t i, t < T -> r' i t = r i t /\ v' i t = v i t) /\ motion10 n V' R0 r' v'.
Theorem all_solutions_agree : forall n V V' R0, 0 < R0 -> potentials n complete V V' -> solutions_last n V' R0 /\
  forall r v, motion10 n V' R0 r v -> (forall t, 0 <= t -> strongly_connected n (by_distance (fun i => r i t) R0)) ->
    forall i j, (i < n)%nat -> (j < n)%nat -> forall e, 0 < e -> exists T, forall t, T <= t -> Cmod (v i t - v j t)%C < e.
Proof.
  intros n V V' R0 HR P. split; [split|].
  - intros q0 u0. now apply (solution_from n V V' R0).
  - intros T r v. now apply (goes_on n V V' R0 T r v).
  - intros r v. now apply (velocities_agree n V V' R0).
Qed.
