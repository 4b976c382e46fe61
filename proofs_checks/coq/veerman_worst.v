(* Veerman, Stosic, Olvera, behind a leader of bounded acceleration: how far cars come at least from the leader and from each other.
     beyond.veerman.worst_cases.
   A motion is a steady one, s'' + a = f P s + g P s', plus a motion behind a leader at rest that settles; it exists because the system is linear. *)
From Coq Require Import Reals Lra Lia Bool.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums linear_motions veerman_complex veerman_front veerman_settling veerman_rates.
Open Scope R_scope.

Ltac eqR := match goal with |- ?a = ?b => change (@eq R a b) end.
(* ---- motions behind a leader at rest exist, for every linear coupling ---- *)
Definition active N k : bool := (1 <=? k)%nat && (k <=? S N)%nat.
Lemma active_iff N k : active N k = true <-> (1 <= k <= S N)%nat.
Proof. unfold active. rewrite andb_true_iff, !Nat.leb_le. tauto. Qed.
Lemma Sum_two a b F : Sum (a + b) F = Sum a F + Sum b (fun i => F (a + i)%nat).
Proof. induction b as [|b IH]; [rewrite Nat.add_0_r; cbn; ring|]. rewrite Nat.add_succ_r. cbn [Sum]. rewrite IH. ring. Qed.
Lemma behind_rest f g N (P : (nat -> R) -> nat -> R) (F : nat -> nat -> R) : (forall c k, (1 <= k <= S N)%nat -> P c k = Sum (S (S N)) (fun j => F k j * c j)) ->
  forall e0 d0, exists e d : nat -> R -> R, (forall t, e 0%nat t = 0 /\ d 0%nat t = 0) /\ (forall k, (1 <= k <= S N)%nat -> e k 0 = e0 k /\ d k 0 = d0 k) /\
    forall k t, (1 <= k <= S N)%nat -> is_derive (e k) t (d k t) /\ is_derive (d k) t (f * P (fun j => e j t) k + g * P (fun j => d j t) k).
Proof.
  intros HP e0 d0. set (p := S (S N)).
  set (A := fun i j => if (i <? p)%nat then (if Nat.eqb j (p + i) then 1 else 0)
    else (if (j <? p)%nat then (if active N j then f * F (i - p)%nat j else 0) else (if active N (j - p) then g * F (i - p)%nat (j - p)%nat else 0))).
  set (y0 := fun i => if (i <? p)%nat then e0 i else d0 (i - p)%nat).
  destruct (linear_motion (p + p) A y0) as (y & Y0 & Dy).
  exists (fun k t => if active N k then y k t else 0), (fun k t => if active N k then y (p + k)%nat t else 0).
  assert (In : forall k, (1 <= k <= S N)%nat -> (k < p)%nat) by (unfold p; intros; lia).
  split; [intros t; split; reflexivity|]. split.
  - intros k Hk. pose proof (proj2 (active_iff N k) Hk) as Ak. specialize (In k Hk). rewrite Ak, !Y0 by lia. unfold y0. split.
    + now rewrite (proj2 (Nat.ltb_lt k p) In).
    + rewrite (proj2 (Nat.ltb_ge (p + k) p)) by lia. f_equal. lia.
  - intros k t Hk. pose proof (proj2 (active_iff N k) Hk) as Ak. pose proof (In k Hk) as Kp. rewrite Ak. split.
    + evar_last; [apply Dy; lia|]. rewrite (Sum_ext (p + p) _ (fun j => delta j (p + k) * y j t)); [apply Sum_delta; lia|].
      intros j _. unfold A, delta. rewrite (proj2 (Nat.ltb_lt k p) Kp). reflexivity.
    + evar_last; [apply Dy; lia|]. rewrite Sum_two, !HP by exact Hk. fold p. rewrite <- !Sum_scal. f_equal; apply Sum_ext; intros j Hj; unfold A; rewrite (proj2 (Nat.ltb_ge (p + k) p)) by lia.
      * rewrite (proj2 (Nat.ltb_lt j p) Hj). replace (p + k - p)%nat with k by lia. destruct (active N j); ring.
      * rewrite (proj2 (Nat.ltb_ge (p + j) p)) by lia. replace (p + k - p)%nat with k by lia. replace (p + j - p)%nat with j by lia. destruct (active N j); ring.
Qed.
Definition F1 k j : R := delta j k - delta j (k - 1).
Definition F2 N k j : R := if Nat.eqb k (S N) then delta j k - delta j (k - 1) else delta j k - / 2 * (delta j (k - 1) + delta j (k + 1)).
Lemma back1_F N c k : (1 <= k <= S N)%nat -> back1 c k = Sum (S (S N)) (fun j => F1 k j * c j).
Proof.
  intros Hk. unfold back1, F1. rewrite (Sum_ext (S (S N)) _ (fun j => delta j k * c j + (-1) * (delta j (k - 1) * c j))) by (intros; ring).
  rewrite Sum_plus, Sum_scal, !Sum_delta by lia. ring.
Qed.
Lemma back2_F N c k : (1 <= k <= S N)%nat -> back2 N c k = Sum (S (S N)) (fun j => F2 N k j * c j).
Proof.
  intros Hk. unfold back2, F2. destruct (Nat.eqb_spec k (S N)) as [E|E].
  - rewrite (Sum_ext (S (S N)) _ (fun j => delta j k * c j + (-1) * (delta j (k - 1) * c j))) by (intros; ring). rewrite Sum_plus, Sum_scal, !Sum_delta by lia. ring.
  - rewrite (Sum_ext (S (S N)) _ (fun j => delta j k * c j + ((- / 2) * (delta j (k - 1) * c j) + (- / 2) * (delta j (k + 1) * c j)))) by (intros; ring).
    rewrite !Sum_plus, !Sum_scal, !Sum_delta by lia. ring.
Qed.
Lemma zero_places f g N e d : errors N (force f g back1) e d -> system_1 f g N (fun _ => 0) e d /\ leader_cruises e d.
Proof.
  intros [Z D]. split.
  - intros k t Hk Ht. destruct (D k t Hk Ht) as [A B]. split; [exact A|]. unfold force, back1 in B. now rewrite !Rminus_0_r.
  - exists 0. intros t _. destruct (Z t) as [-> ->]. destruct (Z 0) as [-> _]. split; ring.
Qed.
Lemma zero_places_2 f g N e d : errors N (force f g (back2 N)) e d -> system_2 f g N (fun _ => 0) e d /\ leader_cruises e d.
Proof.
  intros [Z D]. split.
  - intros k t Hk Ht. destruct (D k t Hk Ht) as [A B]. split; [exact A|]. unfold force, back2 in B. rewrite !Rminus_0_r. destruct (Nat.eqb k (S N)); exact B.
  - exists 0. intros t _. destruct (Z t) as [-> ->]. destruct (Z 0) as [-> _]. split; ring.
Qed.

(* ---- the setting ---- *)
(* the leader accelerates by a, which is continuous with values in [-1, 1]; all cars start in their places at the leader's velocity *)
Definition admissible (a : R -> R) := (forall t, continuity_pt a t) /\ forall t, -1 <= a t <= 1.
Definition driven N (h : nat -> R) (a : R -> R) (x u : nat -> R -> R) : Prop :=
  (forall t, 0 <= t -> is_derive (x 0%nat) t (u 0%nat t) /\ is_derive (u 0%nat) t (a t)) /\
  forall k, (1 <= k <= S N)%nat -> x k 0 - h k = x 0%nat 0 - h 0%nat /\ u k 0 = u 0%nat 0.
(* over all leaders and all t >= 0 the supremum of |q| is at least B *)
Definition supremum_at_least N (h : nat -> R) (motion : (nat -> R -> R) -> (nat -> R -> R) -> Prop) (q : (nat -> R -> R) -> R -> R) (B : R) : Prop :=
  forall e, 0 < e -> exists a x u t, admissible a /\ driven N h a x u /\ motion x u /\ 0 <= t /\ B - e < Rabs (q x t).
(* steady motions s of the deviations, and A of the leader *)
Section Steady.
Variables (f g : R) (N : nat) (h : nat -> R) (P : (nat -> R) -> nat -> R) (F : nat -> nat -> R) (a A A' : R -> R) (s s' : nat -> R -> R).
Hypothesis HP : forall c k, (1 <= k <= S N)%nat -> P c k = Sum (S (S N)) (fun j => F k j * c j).
Hypothesis HA : A 0 = 0 /\ A' 0 = 0 /\ forall t, is_derive A t (A' t) /\ is_derive A' t (a t).
Hypothesis Hs : (forall t, s 0%nat t = 0 /\ s' 0%nat t = 0) /\ forall k t, (1 <= k <= S N)%nat -> is_derive (s k) t (s' k t) /\
  is_derive (s' k) t (f * P (fun j => s j t) k + g * P (fun j => s' j t) k - a t).
Lemma P_plus c c' k : (1 <= k <= S N)%nat -> P (fun j => c j + c' j) k = P c k + P c' k.
Proof. intros Hk. rewrite !HP, <- Sum_plus by exact Hk. apply Sum_ext. intros; ring. Qed.
Lemma steady_motion : exists e d : nat -> R -> R, errors N (force f g P) e d /\
  let x := fun k t => h k + A t + s k t + e k t in let u := fun k t => A' t + s' k t + d k t in
  driven N h a x u /\ (forall k t, deviation h x k t = s k t + e k t) /\
  forall k t, (1 <= k <= S N)%nat -> is_derive (x k) t (u k t) /\ is_derive (u k) t (f * P (fun j => deviation h x j t) k + g * P (fun j => excess u j t) k).
Proof.
  destruct (behind_rest f g N P F HP (fun k => - s k 0) (fun k => - s' k 0)) as (e & d & Z & I & D). exists e, d. destruct HA as (A0 & A'0 & DA). destruct Hs as [Z' Ds].
  split; [split; [exact Z|]; intros k t Hk _; exact (D k t Hk)|]. cbv zeta.
  assert (Dev : forall k t, (h k + A t + s k t + e k t - h k) - (h 0%nat + A t + s 0%nat t + e 0%nat t - h 0%nat) = s k t + e k t).
  { intros k t. destruct (Z t) as [-> _]. destruct (Z' t) as [-> _]. ring. }
  split; [|split; [exact Dev|]].
  - split.
    + intros t _. destruct (DA t) as [B C]. split.
      * apply (is_derive_ext (fun t => h 0%nat + A t)); [intros r; eqR; destruct (Z r) as [-> _]; destruct (Z' r) as [-> _]; ring|].
        destruct (Z t) as [_ ->]. destruct (Z' t) as [_ ->]. eapply D_eq; [apply D_plus; [apply D_const|exact B]|ring].
      * apply (is_derive_ext A'); [intros r; eqR; destruct (Z r) as [_ ->]; destruct (Z' r) as [_ ->]; ring|exact C].
    + intros k Hk. destruct (I k Hk) as [-> ->]. destruct (Z 0) as [-> ->]. destruct (Z' 0) as [-> ->]. rewrite A0, A'0. split; ring.
  - intros k t Hk. destruct (DA t) as [B C]. destruct (D k t Hk) as [De Dd]. destruct (Ds k t Hk) as [E G]. split.
    + eapply D_eq; [apply D_plus; [apply D_plus; [apply D_plus; [apply D_const|exact B]|exact E]|exact De]|ring].
    + eapply D_eq; [apply D_plus; [apply D_plus; [exact C|exact G]|exact Dd]|].
      assert (X1 : P (fun j => deviation h (fun k t => h k + A t + s k t + e k t) j t) k = P (fun j => s j t) k + P (fun j => e j t) k).
      { rewrite <- P_plus by exact Hk. rewrite !HP by exact Hk. apply Sum_ext. intros j _. unfold deviation. rewrite Dev. reflexivity. }
      assert (X2 : P (fun j => excess (fun k t => A' t + s' k t + d k t) j t) k = P (fun j => s' j t) k + P (fun j => d j t) k).
      { rewrite <- P_plus by exact Hk. rewrite !HP by exact Hk. apply Sum_ext. intros j _. unfold excess. destruct (Z t) as [_ ->]. destruct (Z' t) as [_ ->]. f_equal. ring. }
      rewrite X1, X2. ring.
Qed.
End Steady.
Lemma two_sided_zero f g N e d : f < 0 -> g < 0 -> errors N (force f g (back2 N)) e d -> forall k, (1 <= k <= S N)%nat -> is_lim (e k) p_infty 0.
Proof.
  intros Hf Hg E k Hk. destruct (zero_places_2 f g N e d E) as [Sy Le]. pose proof (lowest_range N) as [L0 _].
  set (r := Rmin (f / g) (- g * lowest N / 2)). assert (Q : 0 < f / g) by (replace (f / g) with (- f / - g) by (field; lra); apply Rdiv_lt_0_compat; lra).
  assert (Q2 : 0 < - g * lowest N / 2) by (assert (0 < - g * lowest N) by (apply Rmult_lt_0_compat; lra); lra).
  assert (R0 : 0 < r) by (unfold r; now apply Rmin_glb_lt). assert (R1 : r <= f / g) by apply Rmin_l. assert (R2 : r <= - g * lowest N / 2) by apply Rmin_r.
  apply (Rmult_le_compat_l (- g)) in R1; [|lra]. replace (- g * (f / g)) with (- f) in R1 by (field; lra).
  destruct (settles_in_time r N _ e d R0 (two_sided_settles f g r N _ e d R0 R1 ltac:(lra) Sy Le) k Hk) as [L _].
  apply (is_lim_ext (deviation (fun _ => 0) e k)); [|exact L]. intros t. unfold deviation. destruct E as [Z _]. destruct (Z t) as [-> _]. ring.
Qed.
Lemma one_sided_zero f g N e d : f < 0 -> g < 0 -> errors N (force f g back1) e d -> forall k, (1 <= k <= S N)%nat -> is_lim (e k) p_infty 0.
Proof.
  intros Hf Hg E k Hk. destruct (zero_places f g N e d E) as [Sy Le].
  set (r := Rmin (f / g / 2) (- g / 4)). assert (Q : 0 < f / g) by (replace (f / g) with (- f / - g) by (field; lra); apply Rdiv_lt_0_compat; lra).
  assert (R0 : 0 < r) by (unfold r; apply Rmin_glb_lt; lra). assert (R1 : r <= f / g / 2) by apply Rmin_l. assert (R2 : r <= - g / 4) by apply Rmin_r.
  apply (Rmult_le_compat_l (- g)) in R1; [|lra]. replace (- g * (f / g / 2)) with (- f / 2) in R1 by (field; lra). pose proof (pow2_ge_0 r).
  destruct (settles_in_time r N _ e d R0 (one_sided_settles f g r N _ e d Hg ltac:(lra) ltac:(lra) ltac:(lra) Sy Le) k Hk) as [L _].
  apply (is_lim_ext (deviation (fun _ => 0) e k)); [|exact L]. intros t. unfold deviation. destruct E as [Z _]. destruct (Z t) as [-> _]. ring.
Qed.
(* the leader accelerates by 1 for ever: deviations tend to the steady ones *)
Lemma ramp : (fun t : R => t ^ 2 / 2) 0 = 0 /\ (fun t : R => t) 0 = 0 /\ forall t, is_derive (fun t : R => t ^ 2 / 2) t ((fun t => t) t) /\ is_derive (fun t : R => t) t ((fun _ : R => 1) t).
Proof. split; [field|]. split; [reflexivity|]. intros t. split; [auto_derive; [easy|field]|apply (is_derive_id (K := R_AbsRing))]. Qed.
Lemma one_admissible : admissible (fun _ => 1).
Proof. split; [intros t; apply continuity_pt_const; now intros x y|intros t; lra]. Qed.
Lemma far_out (z : R -> R) (l : R) : is_lim z p_infty l -> forall e, 0 < e -> exists T, 0 <= T /\ forall t, T <= t -> Rabs (z t - l) < e.
Proof.
  intros L e He. apply is_lim_spec in L. destruct (L (mkposreal e He)) as [M HM]. exists (Rabs M + 1). pose proof (Rabs_pos M). pose proof (Rle_abs M). split; [lra|]. intros t Ht. apply HM. lra.
Qed.
Lemma limits_reach N h (motion : (nat -> R -> R) -> (nat -> R -> R) -> Prop) q (l : R) a x u : admissible a -> driven N h a x u -> motion x u -> is_lim (q x) p_infty l -> supremum_at_least N h motion q (Rabs l).
Proof.
  intros Ha Hd Hm L e He. destruct (far_out (q x) l L e He) as (T & T0 & HT). exists a, x, u, T. repeat (split; [assumption|]). specialize (HT T (Rle_refl T)).
  pose proof (Rabs_triang (l - q x T) (q x T)) as Tr. replace (l - q x T + q x T) with l in Tr by ring. rewrite Rabs_minus_sym in HT. lra.
Qed.
Definition steady2 f N (k : nat) : R := INR k * (2 * INR (S N) - INR k) / f.
Lemma steady2_spec f g N k : f < 0 -> (1 <= k <= S N)%nat -> f * back2 N (steady2 f N) k + g * back2 N (fun _ => 0) k - 1 = 0.
Proof.
  intros Hf Hk. unfold back2, steady2. destruct (Nat.eqb_spec k (S N)) as [->|E].
  - replace (S N - 1)%nat with N by lia. rewrite S_INR. field. lra.
  - rewrite plus_INR, minus_INR by lia. change (INR 1) with 1. field. lra.
Qed.
Lemma lim_sum (z : R -> R) (s : R) : is_lim z p_infty 0 -> is_lim (fun t => s + z t) p_infty s.
Proof. intros L. evar_last; [apply is_lim_plus'; [apply is_lim_const|exact L]|]. cbn. f_equal. ring. Qed.
Lemma constant_steady (s : nat -> R) : s 0%nat = 0 -> forall f g N P, (forall k, (1 <= k <= S N)%nat -> f * P s k + g * P (fun _ => 0) k - 1 = 0) ->
  (forall t : R, (fun k (_ : R) => s k) 0%nat t = 0 /\ (fun (_ : nat) (_ : R) => 0) 0%nat t = 0) /\ forall k t, (1 <= k <= S N)%nat -> is_derive ((fun k (_ : R) => s k) k) t ((fun _ _ => 0) k t) /\
  is_derive ((fun (_ : nat) (_ : R) => 0) k) t (f * P (fun j => (fun k (_ : R) => s k) j t) k + g * P (fun j => (fun _ _ => 0) j t) k - (fun _ => 1) t).
Proof.
  intros S0 f g N P H. split; [intros t; now split|]. intros k t Hk. split; [apply (is_derive_const (V := R_NormedModule))|].
  cbv beta. change (fun j => s j) with s. rewrite (H k Hk). apply (is_derive_const (V := R_NormedModule)).
Qed.
Lemma steady_gap (h : nat -> R) (x e : nat -> R -> R) (s : nat -> R) N : (forall k t, deviation h x k t = s k + e k t) -> (forall t, e 0%nat t = 0) -> (forall k, (1 <= k <= S N)%nat -> is_lim (e k) p_infty 0) ->
  forall k, (1 <= k <= S N)%nat -> is_lim (fun t => deviation h x k t) p_infty (s k) /\ is_lim (fun t => deviation h x k t - deviation h x (k - 1) t) p_infty (s k - s (k - 1)%nat).
Proof.
  intros Dv Z L k Hk. split.
  - apply (is_lim_ext (fun t => s k + e k t)); [intros; now rewrite Dv|]. apply lim_sum, L, Hk.
  - apply (is_lim_ext (fun t => (s k - s (k - 1)%nat) + (e k t - e (k - 1)%nat t))); [intros; rewrite !Dv; ring|]. apply lim_sum.
    assert (M : is_lim (e (k - 1)%nat) p_infty 0).
    { destruct (Nat.eq_dec k 1) as [->|N1]; [|apply L; lia]. apply (is_lim_ext (fun _ => 0)); [intros; now rewrite Z|apply is_lim_const]. }
    evar_last; [apply is_lim_minus'; [apply L, Hk|exact M]|]. cbn. f_equal. ring.
Qed.
Theorem two_sided_worst f g N h k : f < 0 -> g < 0 -> (1 <= k <= S N)%nat ->
  supremum_at_least N h (system_2 f g N h) (fun x t => deviation h x k t) (INR k * (2 * INR (S N) - INR k) / Rabs f) /\
  supremum_at_least N h (system_2 f g N h) (fun x t => deviation h x (S N) t) (INR (S N) ^ 2 / Rabs f) /\
  supremum_at_least N h (system_2 f g N h) (fun x t => deviation h x k t - deviation h x (k - 1) t) ((2 * (INR (S N) - INR k) + 1) / Rabs f).
Proof.
  intros Hf Hg Hk.
  destruct (steady_motion f g N h (back2 N) (F2 N) (fun _ => 1) (fun t => t ^ 2 / 2) (fun t => t) (fun k _ => steady2 f N k) (fun _ _ => 0) (back2_F N) ramp) as (e & d & E & Dr & Dv & Mo).
  { apply (constant_steady (steady2 f N)); [unfold steady2; cbn; field; lra|]. intros j Hj. now apply steady2_spec. }
  cbv zeta in Dr, Dv, Mo. set (x := fun k t => h k + t ^ 2 / 2 + steady2 f N k + e k t) in *. set (u := fun k t => t + 0 + d k t) in *.
  assert (M : system_2 f g N h x u).
  { intros j t Hj _. destruct (Mo j t Hj) as [A B]. split; [exact A|]. unfold back2 in B. destruct (Nat.eqb_spec j (S N)) as [Q|Q]; (eapply D_eq; [exact B|]); unfold deviation, excess; cbv beta; match goal with |- ?a = ?b => change (@eq R a b) end; field. }
  pose proof (fun j Hj => steady_gap h x e (steady2 f N) N Dv (fun t => proj1 (proj1 E t)) (two_sided_zero f g N e d Hf Hg E) j Hj) as L.
  assert (Fp : Rabs f = - f) by (now apply Rabs_left). pose proof (le_INR k (S N) ltac:(lia)) as I1. pose proof (le_INR 1 k ltac:(lia)) as I2. change (INR 1) with 1 in I2.
  assert (Ab : forall y, 0 <= y -> Rabs (y / f) = y / Rabs f) by (intros y Hy; unfold Rdiv; rewrite Rabs_mult, Rabs_inv, (Rabs_pos_eq y Hy); reflexivity).
  split; [|split].
  - rewrite <- Ab by (apply Rmult_le_pos; lra). apply (limits_reach N h (system_2 f g N h) (fun x t => deviation h x k t) _ (fun _ => 1) x u one_admissible Dr M). apply (L k Hk).
  - rewrite <- Ab by apply pow2_ge_0. apply (limits_reach N h (system_2 f g N h) (fun x t => deviation h x (S N) t) _ (fun _ => 1) x u one_admissible Dr M).
    replace (INR (S N) ^ 2 / f) with (steady2 f N (S N)) by (unfold steady2; field; lra). apply L. lia.
  - rewrite <- Ab by lra. apply (limits_reach N h (system_2 f g N h) (fun x t => deviation h x k t - deviation h x (k - 1) t) _ (fun _ => 1) x u one_admissible Dr M).
    replace ((2 * (INR (S N) - INR k) + 1) / f) with (steady2 f N k - steady2 f N (k - 1)); [apply (L k Hk)|]. unfold steady2. rewrite minus_INR by lia. change (INR 1) with 1. field. lra.
Qed.
Lemma system_1_of f g N h x u : (forall k t, (1 <= k <= S N)%nat -> is_derive (x k) t (u k t) /\ is_derive (u k) t (f * back1 (fun j => deviation h x j t) k + g * back1 (fun j => excess u j t) k)) -> system_1 f g N h x u.
Proof. intros H j t Hj _. destruct (H j t Hj) as [A B]. split; [exact A|]. eapply D_eq; [exact B|]. unfold back1, deviation, excess. ring. Qed.
Theorem one_sided_worst f g N h k : f < 0 -> g < 0 -> (1 <= k <= S N)%nat -> supremum_at_least N h (system_1 f g N h) (fun x t => deviation h x k t) (INR k / Rabs f).
Proof.
  intros Hf Hg Hk.
  destruct (steady_motion f g N h back1 F1 (fun _ => 1) (fun t => t ^ 2 / 2) (fun t => t) (fun k _ => INR k / f) (fun _ _ => 0) (back1_F N) ramp) as (e & d & E & Dr & Dv & Mo).
  { apply (constant_steady (fun k => INR k / f)); [cbn; field; lra|]. intros j Hj. unfold back1. rewrite minus_INR by lia. change (INR 1) with 1. field. lra. }
  cbv zeta in Dr, Dv, Mo. set (x := fun k t => h k + t ^ 2 / 2 + INR k / f + e k t) in *. set (u := fun k t => t + 0 + d k t) in *.
  pose proof (steady_gap h x e (fun k => INR k / f) N Dv (fun t => proj1 (proj1 E t)) (one_sided_zero f g N e d Hf Hg E) k Hk) as [L _].
  replace (INR k / Rabs f) with (Rabs (INR k / f)) by (unfold Rdiv; rewrite Rabs_mult, Rabs_inv, (Rabs_pos_eq _ (pos_INR k)); reflexivity).
  exact (limits_reach N h (system_1 f g N h) (fun x t => deviation h x k t) _ (fun _ => 1) x u one_admissible Dr (system_1_of f g N h x u Mo) L).
Qed.
(* ---- a leader whose acceleration swings: cos w t ---- *)
(* the real part of z e^{i w t} and its derivative *)
Definition swing (w : R) (z : C) (t : R) : R := fst z * cos (w * t) - snd z * sin (w * t).
Lemma swing_derive w z t : is_derive (swing w z) t (swing w ((0, w) * z)%C t).
Proof. unfold swing. evar_last; [auto_derive; [easy|reflexivity]|]. cbn. ring. Qed.
Lemma swing_peak w z t : 0 < w -> exists T, t <= T /\ swing w z T = Cmod z.
Proof.
  intros Hw. destruct (Req_dec (Cmod z) 0) as [Z|Z].
  - exists t. split; [lra|]. rewrite Z. apply Cmod_eq_0 in Z. rewrite Z. unfold swing. cbn. ring.
  - pose proof (Cmod_ge_0 z) as P. destruct z as [a b]. set (m := Cmod (a, b)) in *. assert (M : m ^ 2 = a ^ 2 + b ^ 2) by (unfold m; rewrite Cmod_sqr; reflexivity).
    assert (Hm : 0 < m) by lra.
    (* an angle p with cos p = a / m, sin p = - b / m *)
    assert (A : exists p, m * cos p = a /\ m * sin p = - b).
    { assert (B : -1 <= a / m <= 1) by (split; [apply (Rmult_le_reg_r m); [exact Hm|]; unfold Rdiv; rewrite Rmult_assoc, Rinv_l by lra; nra|apply (Rmult_le_reg_r m); [exact Hm|]; unfold Rdiv; rewrite Rmult_assoc, Rinv_l by lra; nra]).
      assert (C1 : m * cos (acos (a / m)) = a) by (rewrite cos_acos by exact B; field; lra).
      pose proof (sin2_cos2 (acos (a / m))) as S2. unfold Rsqr in S2.
      assert (S3 : (m * sin (acos (a / m))) ^ 2 = b ^ 2).
      { set (c := cos (acos (a / m))) in *. set (s := sin (acos (a / m))) in *. replace ((m * s) ^ 2) with (m ^ 2 * (s * s + c * c) - (m * c) ^ 2) by ring. rewrite S2, C1, M. ring. }
      assert (F : (m * sin (acos (a / m)) - b) * (m * sin (acos (a / m)) + b) = 0) by nra.
      apply Rmult_integral in F. destruct F as [F|F]; [exists (- acos (a / m)); rewrite cos_neg, sin_neg; lra|exists (acos (a / m)); lra]. }
    destruct A as (p & A1 & A2). destruct (archimed ((w * Rabs t + Rabs p) / (2 * PI))) as [U _]. pose proof PI_RGT_0. set (n := up ((w * Rabs t + Rabs p) / (2 * PI))) in *.
    apply (Rmult_lt_compat_r (2 * PI)) in U; [|lra]. unfold Rdiv in U. rewrite Rmult_assoc, Rinv_l, Rmult_1_r in U by lra.
    assert (N0 : (0 <= n)%Z). { apply le_IZR. pose proof (Rabs_pos t). pose proof (Rabs_pos p). assert (0 <= w * Rabs t) by (apply Rmult_le_pos; lra). assert (0 < IZR n * (2 * PI)) by lra. apply Rlt_le. apply (Rmult_lt_reg_r (2 * PI)); lra. }
    exists ((p + 2 * IZR n * PI) / w). split.
    + apply (Rmult_le_reg_l w); [exact Hw|]. replace (w * ((p + 2 * IZR n * PI) / w)) with (p + 2 * IZR n * PI) by (field; lra).
      pose proof (Rle_abs t). pose proof (Rle_abs (- p)). rewrite Rabs_Ropp in *. assert (w * t <= w * Rabs t) by (apply Rmult_le_compat_l; lra). lra.
    + unfold swing. cbn [fst snd]. replace (w * ((p + 2 * IZR n * PI) / w)) with (p + 2 * INR (Z.to_nat n) * PI) by (rewrite INR_IZR_INZ, Z2Nat.id by exact N0; field; lra).
      rewrite cos_period, sin_period. rewrite <- A1. replace b with (- (m * sin p)) by lra. pose proof (sin2_cos2 p) as S2. unfold Rsqr in S2.
      replace (m * cos p * cos p - - (m * sin p) * sin p) with (m * (sin p * sin p + cos p * cos p)) by ring. rewrite S2. ring.
Qed.
Lemma swing_plus w y z t : swing w (y + z)%C t = swing w y t + swing w z t.
Proof. unfold swing. cbn. ring. Qed.
Lemma swing_minus w y z t : swing w (y - z)%C t = swing w y t - swing w z t.
Proof. unfold swing. cbn. ring. Qed.
Lemma swing_scal w (a : R) z t : swing w (RtoC a * z)%C t = a * swing w z t.
Proof. unfold swing. cbn. ring. Qed.
(* |1/gamma|^(k-1)/|f + i w g + w^2| *)
Theorem one_sided_gap f g N h k w : f < 0 -> g < 0 -> (1 <= k <= S N)%nat -> 0 < w ->
  supremum_at_least N h (system_1 f g N h) (fun x t => deviation h x k t - deviation h x (k - 1) t) (Cmod (/ gamma f g w)%C ^ (k - 1) / Cmod (num f g w)) /\
  (w ^ 2 < 2 * Rabs f -> 1 < Cmod (/ gamma f g w)%C).
Proof.
  intros Hf Hg Hk Hw. split; [|intros W; apply gain_above_one; try assumption; split; [now apply pow_lt|exact W]].
  pose proof (num_neq0 f g w Hf Hg) as NZ. pose proof (pow_lt w 2 Hw) as W2.
  set (q := (/ gamma f g w)%C). set (c := fun k => (RtoC (/ w ^ 2) * (1 - Cpw q k))%C).
  assert (Q : forall z, (q * z)%C = (den f g w / num f g w * z)%C) by (intros z; unfold q; now rewrite inv_gamma).
  assert (Gap : forall j, (1 <= j)%nat -> (c j - c (j - 1)%nat)%C = (Cpw q (j - 1) / num f g w)%C).
  { intros j Hj. destruct j as [|j]; [lia|]. replace (S j - 1)%nat with j by lia. unfold c. cbn [Cpw]. rewrite Q.
    assert (E : (num f g w - den f g w)%C = RtoC (w ^ 2)) by (apply injective_projections; cbn; ring).
    replace (RtoC (/ w ^ 2) * (1 - den f g w / num f g w * Cpw q j) - RtoC (/ w ^ 2) * (1 - Cpw q j))%C with (RtoC (/ w ^ 2) * (num f g w - den f g w) * (Cpw q j / num f g w))%C by (field; exact NZ).
    rewrite E, <- RtoC_mult, Rinv_l by lra. ring. }
  destruct (steady_motion f g N h back1 F1 (fun t => cos (w * t)) (fun t => (1 - cos (w * t)) / w ^ 2) (fun t => sin (w * t) / w) (fun k t => swing w (c k) t) (fun k t => swing w ((0, w) * c k)%C t) (back1_F N)) as (e & d & E & Dr & Dv & Mo).
  - rewrite Rmult_0_r, cos_0, sin_0. split; [field; lra|]. split; [field; lra|]. intros t. split; (evar_last; [auto_derive; [easy|reflexivity]|field; lra]).
  - split; [intros t; unfold c, swing; cbn; split; ring|]. intros j t Hj. split; [apply swing_derive|]. evar_last; [apply swing_derive|]. cbv beta. unfold back1.
    rewrite <- !swing_minus, <- !swing_scal, <- swing_plus.
    assert (Z : swing w (RtoC 1) t = cos (w * t)) by (unfold swing; cbn; ring). rewrite <- Z, <- swing_minus. f_equal.
    replace (RtoC f * (c j - c (j - 1)%nat) + RtoC g * ((0, w) * c j - (0, w) * c (j - 1)%nat) - RtoC 1)%C with (den f g w * (c j - c (j - 1)%nat) - RtoC 1)%C by (apply injective_projections; cbn; ring).
    rewrite Gap by lia. destruct j as [|j]; [lia|]. replace (S j - 1)%nat with j by lia. unfold c. cbn [Cpw]. rewrite Q.
    replace ((0, w) * ((0, w) * (RtoC (/ w ^ 2) * (1 - den f g w / num f g w * Cpw q j))))%C with (((0, w) * (0, w) * RtoC (/ w ^ 2)) * (1 - den f g w / num f g w * Cpw q j))%C by ring.
    replace ((0, w) * (0, w) * RtoC (/ w ^ 2))%C with (- RtoC 1)%C by (apply injective_projections; unfold RtoC, Cmult, Copp; cbn [fst snd]; field; lra). field. exact NZ.
  - cbv zeta in Dr, Dv, Mo. set (x := fun k t => h k + (1 - cos (w * t)) / w ^ 2 + swing w (c k) t + e k t) in *. set (u := fun k t => sin (w * t) / w + swing w ((0, w) * c k)%C t + d k t) in *.
    assert (L : forall j, (j <= S N)%nat -> is_lim (e j) p_infty 0).
    { intros j Hj. destruct (Nat.eq_dec j 0) as [->|N0]; [|apply (one_sided_zero f g N e d Hf Hg E); lia]. apply (is_lim_ext (fun _ => 0)); [intros; now rewrite (proj1 (proj1 E y))|apply is_lim_const]. }
    intros eps He. assert (Le : is_lim (fun t => e k t - e (k - 1)%nat t) p_infty 0).
    { evar_last; [apply is_lim_minus'; [apply L; lia|apply L; lia]|]. cbn. f_equal. ring. }
    destruct (far_out _ 0 Le eps He) as (T & T0 & HT). destruct (swing_peak w (Cpw q (k - 1) / num f g w)%C T Hw) as (t & Ht & Pk).
    exists (fun t => cos (w * t)), x, u, t. split; [|split; [exact Dr|split; [exact (system_1_of f g N h x u Mo)|split; [lra|]]]].
    + split; [|intros s; apply COS_bound]. intros s. apply derivable_continuous_pt. reg.
    + rewrite !Dv. replace (swing w (c k) t + e k t - (swing w (c (k - 1)%nat) t + e (k - 1)%nat t)) with (swing w (c k - c (k - 1)%nat)%C t + (e k t - e (k - 1)%nat t)) by (rewrite swing_minus; ring).
      rewrite Gap, Pk by lia. rewrite Cmod_div, Cmod_Cpw by exact NZ. fold q. specialize (HT t Ht). rewrite Rminus_0_r in HT. apply Rabs_lt_between in HT.
      eapply Rlt_le_trans; [|apply Rle_abs]. lra.
Qed.
