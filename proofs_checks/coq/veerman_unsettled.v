(* Veerman, Stosic, Olvera, section 2: f, g < 0 is what makes a platoon settle, and how slowly the second one does.
     veerman.lem1 (in time), beyond.veerman.decay_rate.
   Otherwise one car (front only), or all cars in the shape of the lowest eigenvector (front and back), move in a mode
   exp(nu t) or exp(p t) cos(w t) that does not decay. *)
From Coq Require Import Reals Lra Lia Psatz.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums veerman_complex veerman_stability veerman_lemma1 veerman_settling veerman_rates.
Open Scope R_scope.

Lemma D_exp k t : is_derive (fun s => exp (k * s)) t (k * exp (k * t)).
Proof.
  eapply D_eq; [apply (D_comp exp (fun s => k * s) t (exp (k * t)) k); [apply is_derive_exp|]|ring].
  eapply D_eq; [apply D_scal, D_id|ring].
Qed.
Lemma exp_ge1 x : 0 <= x -> 1 <= exp x.
Proof. intros [H|H]; [rewrite <- exp_0; left; now apply exp_increasing|rewrite <- H, exp_0; right; reflexivity]. Qed.
Lemma unsettled_mode f g lam : 0 < lam -> ~ (f < 0 /\ g < 0) -> exists z z' : R -> R,
  (forall t, is_derive z t (z' t) /\ is_derive z' t (lam * (f * z t + g * z' t))) /\ forall T, exists t, T < t /\ 1 <= z t.
Proof.
  intros L NS. set (D := (lam * g) ^ 2 + 4 * lam * f). destruct (Rle_lt_dec 0 D) as [P|P].
  - set (w := sqrt D). assert (W2 : w * w = D) by now apply sqrt_sqrt. assert (W0 : 0 <= w) by apply sqrt_pos.
    set (nu := (lam * g + w) / 2). assert (N2 : nu ^ 2 = lam * (f + g * nu)).
    { transitivity ((w * w + 2 * lam * g * w + (lam * g) ^ 2) / 4); [unfold nu; field|]. rewrite W2. unfold D, nu. field. }
    assert (NP : 0 <= nu).
    { destruct (Rle_lt_dec 0 g) as [G|G].
      - assert (0 <= lam * g) by (apply Rmult_le_pos; lra). unfold nu. lra.
      - assert (F : 0 <= f) by (apply Rnot_lt_le; intros F; apply NS; now split).
        assert (0 <= lam * f) by (apply Rmult_le_pos; lra). assert (0 < lam * - g) by (apply Rmult_lt_0_compat; lra).
        assert (- (lam * g) <= w); [|unfold nu; lra]. apply Rsqr_incr_0_var; [|exact W0]. unfold Rsqr. rewrite W2. unfold D. nra. }
    exists (fun t => exp (nu * t)), (fun t => nu * exp (nu * t)). split.
    + intros t. split; [apply D_exp|]. eapply D_eq; [apply (D_scal nu (fun s => exp (nu * s))), D_exp|].
      replace (lam * (f * exp (nu * t) + g * (nu * exp (nu * t)))) with (lam * (f + g * nu) * exp (nu * t)) by ring. rewrite <- N2. ring.
    + intros T. exists (Rmax 0 (T + 1)). split; [pose proof (Rmax_r 0 (T + 1)); lra|].
      apply exp_ge1, Rmult_le_pos; [exact NP|apply Rmax_l].
  - assert (F : f < 0). { apply Rnot_le_lt. intros F. assert (0 <= lam * f) by (apply Rmult_le_pos; lra). pose proof (pow2_ge_0 (lam * g)). unfold D in P. lra. }
    assert (G : 0 <= g) by (apply Rnot_lt_le; intros G; apply NS; now split).
    set (w := sqrt (- D) / 2). set (p := lam * g / 2).
    assert (W0 : 0 < w) by (apply Rdiv_lt_0_compat; [apply sqrt_lt_R0|]; lra).
    assert (W2 : w ^ 2 = - lam * f - p ^ 2).
    { unfold w. replace ((sqrt (- D) / 2) ^ 2) with (sqrt (- D) * sqrt (- D) / 4) by field. rewrite sqrt_sqrt by lra. unfold D, p. field. }
    exists (fun t => exp (p * t) * cos (w * t)), (fun t => exp (p * t) * (p * cos (w * t) - w * sin (w * t))). split.
    + assert (DW : forall t, is_derive (fun s => w * s) t w) by (intros; eapply D_eq; [apply D_scal, D_id|ring]).
      assert (DC : forall t, is_derive (fun s => cos (w * s)) t (- w * sin (w * t))).
      { intros. eapply D_eq; [apply (D_cos (fun s => w * s)), DW|ring]. }
      assert (DS : forall t, is_derive (fun s => sin (w * s)) t (w * cos (w * t))).
      { intros. eapply D_eq; [apply (D_sin (fun s => w * s)), DW|ring]. }
      intros t. split.
      * eapply D_eq; [apply (D_mult (fun s => exp (p * s)) (fun s => cos (w * s))); [apply D_exp|apply DC]|ring].
      * eapply D_eq.
        -- apply (D_mult (fun s => exp (p * s)) (fun s => p * cos (w * s) - w * sin (w * s))); [apply D_exp|].
           apply D_minus; [apply (D_scal p (fun s => cos (w * s))), DC|apply (D_scal w (fun s => sin (w * s))), DS].
        -- replace (p * exp (p * t) * (p * cos (w * t) - w * sin (w * t)) + exp (p * t) * (p * (- w * sin (w * t)) - w * (w * cos (w * t))))
             with (exp (p * t) * ((p ^ 2 - w ^ 2) * cos (w * t) - 2 * p * w * sin (w * t))) by ring.
           rewrite W2. unfold p. field.
    + intros T. pose proof PI_RGT_0 as PP. set (per := 2 * PI / w). assert (P0 : 0 < per) by (apply Rdiv_lt_0_compat; lra).
      destruct (nfloor_ex (Rabs (T / per))) as [n [_ Hn]]; [apply Rabs_pos|].
      exists (INR (S n) * per). assert (TP : T < INR (S n) * per).
      { rewrite S_INR. apply (Rmult_lt_reg_r (/ per)); [now apply Rinv_0_lt_compat|]. rewrite Rmult_assoc, Rinv_r, Rmult_1_r by lra.
        pose proof (Rle_abs (T / per)). unfold Rdiv in *. lra. }
      split; [exact TP|]. replace (w * (INR (S n) * per)) with (0 + 2 * INR (S n) * PI) by (unfold per; field; lra).
      rewrite cos_period, cos_0, Rmult_1_r. apply exp_ge1.
      apply Rmult_le_pos; [unfold p|apply Rmult_le_pos; [apply pos_INR|lra]]. assert (0 <= lam * g) by (apply Rmult_le_pos; lra). lra.
Qed.
Lemma not_settled N h x u : (forall T, exists t, T < t /\ 1 <= deviation h x (S N) t) -> ~ settles N h x u.
Proof.
  intros H S. destruct (S (Datatypes.S N) ltac:(lia)) as [L _]. apply is_lim_spec in L.
  destruct (L (mkposreal 1 Rlt_0_1)) as [T HT]. destruct (H T) as (t & Ht & P). specialize (HT t Ht). cbn in HT.
  rewrite Rminus_0_r in HT. pose proof (Rle_abs (deviation h x (Datatypes.S N) t)). lra.
Qed.

(* all motions of the first, of the second system, behind every leader of constant velocity *)
Definition stable_1 (f g : R) (N : nat) : Prop := forall h x u, system_1 f g N h x u -> leader_cruises x u -> settles N h x u.
Definition stable_2 (f g : R) (N : nat) : Prop := forall h x u, system_2 f g N h x u -> leader_cruises x u -> settles N h x u.

Lemma at_rest x u : (forall t : R, x 0%nat t = 0 /\ u 0%nat t = 0) -> leader_cruises x u.
Proof. intros H. exists 0. intros t _. destruct (H t) as [-> ->]. destruct (H 0) as [-> _]. split; ring. Qed.
Lemma unsettled_1 f g N : ~ (f < 0 /\ g < 0) -> ~ stable_1 f g N.
Proof.
  intros NS S. destruct (unsettled_mode f g 1 Rlt_0_1 NS) as (z & z' & D & L).
  set (one := fun (y : R -> R) k t => if Nat.eqb k (Datatypes.S N) then y t else 0).
  apply (not_settled N (fun _ => 0) (one z) (one z')).
  - intros T. destruct (L T) as (t & Ht & P). exists t. split; [exact Ht|]. unfold deviation, one. rewrite Nat.eqb_refl. cbn [Nat.eqb]. lra.
  - apply S; [|apply at_rest; intros t; unfold one; cbn [Nat.eqb]; split; reflexivity].
    intros k t Hk _. unfold one. replace (Nat.eqb (k - 1) (Datatypes.S N)) with false by (symmetry; apply Nat.eqb_neq; lia).
    destruct (D t) as [D1 D2]. destruct (Nat.eqb k (Datatypes.S N)).
    + split; [exact D1|]. eapply D_eq; [exact D2|ring].
    + split; [apply D_const|]. eapply D_eq; [apply D_const|ring].
Qed.
Lemma unsettled_2 f g N : ~ (f < 0 /\ g < 0) -> ~ stable_2 f g N.
Proof.
  intros NS S. destruct (unsettled_mode f g (lowest N) (proj1 (lowest_range N)) NS) as (z & z' & D & L).
  set (phi := PI / (2 * (INR N + 1))). set (s := fun k => sin (INR k * phi)).
  assert (NP := pos_INR N). assert (MP : (INR N + 1) * phi = PI / 2) by (unfold phi; field; lra).
  assert (S0 : s 0%nat = 0) by (unfold s; cbn [INR]; rewrite Rmult_0_l; apply sin_0).
  assert (SN : s (Datatypes.S N) = 1) by (unfold s; rewrite S_INR, MP; apply sin_PI2).
  assert (SE : forall k, (1 <= k <= Datatypes.S N)%nat -> back2 N s k = lowest N * s k).
  { intros k Hk. unfold back2. destruct (Nat.eqb_spec k (Datatypes.S N)) as [E|E].
    - rewrite E, SN. replace (Datatypes.S N - 1)%nat with N by lia. unfold s, lowest. fold phi.
      replace (INR N * phi) with (PI / 2 - phi) by (rewrite <- MP; ring). rewrite sin_shift. ring.
    - unfold s, lowest. fold phi. rewrite plus_INR, minus_INR by lia. cbn [INR].
      rewrite Rmult_minus_distr_r, Rmult_plus_distr_r, Rmult_1_l, sin_plus, sin_minus. field. }
  apply (not_settled N (fun _ => 0) (fun k t => s k * z t) (fun k t => s k * z' t)).
  - intros T. destruct (L T) as (t & Ht & P). exists t. split; [exact Ht|]. unfold deviation. rewrite SN, S0. lra.
  - apply S; [|apply at_rest; intros t; rewrite S0; split; ring].
    intros k t Hk _. destruct (D t) as [D1 D2]. split; [now apply (D_scal (s k) z)|].
    eapply D_eq; [apply (D_scal (s k) z'), D2|]. specialize (SE k Hk). unfold back2 in SE. destruct (Nat.eqb k (Datatypes.S N)).
    + transitivity ((lowest N * s k) * (f * z t + g * z' t)); [ring|]. rewrite <- SE. ring.
    + transitivity ((lowest N * s k) * (f * z t + g * z' t)); [ring|]. rewrite <- SE. field.
Qed.

(* veerman.lem1 for the motions themselves *)
Theorem lemma_1_in_time f g :
  (forall N, stable_1 f g N <-> f < 0 /\ g < 0) /\ (forall N, stable_2 f g N <-> f < 0 /\ g < 0).
Proof.
  split; intros N; split.
  - intros S. destruct (Rlt_dec f 0) as [F|F], (Rlt_dec g 0) as [G|G]; try (now split); exfalso; apply (unsettled_1 f g N); tauto.
  - intros [F G] h x u HS HL. set (s := Rmin (- g / 4) (- f / (2 * - g))).
    assert (S0 : 0 < - f / (2 * - g)) by (apply Rdiv_lt_0_compat; lra). assert (S1 : 0 < s) by (apply Rmin_glb_lt; lra).
    assert (S2 : s <= - g / 4) by apply Rmin_l.
    assert (S3 : - g * s <= - f / 2).
    { apply Rle_trans with (- g * (- f / (2 * - g))); [apply Rmult_le_compat_l; [lra|apply Rmin_r]|]. right. field. lra. }
    apply (settles_in_time s); [exact S1|]. apply (one_sided_settles f g s); try assumption; try lra. pose proof (pow2_ge_0 s). lra.
  - intros S. destruct (Rlt_dec f 0) as [F|F], (Rlt_dec g 0) as [G|G]; try (now split); exfalso; apply (unsettled_2 f g N); tauto.
  - intros [F G] h x u HS HL. destruct (lowest_range N) as [L0 _]. set (r := Rmin (- g * lowest N / 2) (- f / - g)).
    assert (P0 : 0 < - g * lowest N) by (apply Rmult_lt_0_compat; lra).
    assert (R0 : 0 < - f / - g) by (apply Rdiv_lt_0_compat; lra). assert (R1 : 0 < r) by (apply Rmin_glb_lt; lra).
    assert (R2 : r <= - g * lowest N / 2) by apply Rmin_l.
    assert (R3 : - g * r <= - f).
    { apply Rle_trans with (- g * (- f / - g)); [apply Rmult_le_compat_l; [lra|apply Rmin_r]|]. right. field. lra. }
    apply (settles_in_time r); [exact R1|]. apply (two_sided_settles f g r); try assumption. lra.
Qed.

(* ---- beyond.veerman.decay_rate ---- *)
Lemma lowest_angle N : lowest N = 1 - cos (PI / (2 * INR (S N))).
Proof. unfold lowest. now rewrite S_INR. Qed.
Lemma lowest_small N : lowest N < PI ^ 2 / (8 * INR (S N) ^ 2).
Proof.
  rewrite lowest_angle. pose proof (lt_0_INR (S N) ltac:(lia)) as M. pose proof PI_RGT_0 as PP. set (m := INR (S N)) in *.
  replace (PI / (2 * m)) with (2 * (PI / (4 * m))) by (field; lra). rewrite cos_2a_sin.
  assert (X0 : 0 < PI / (4 * m)) by (apply Rdiv_lt_0_compat; lra). set (y := PI / (4 * m)) in *.
  assert (Y : sin y < y) by now apply sin_lt_x.
  assert (Y0 : 0 <= sin y).
  { apply sin_ge_0; [lra|]. unfold y. pose proof (le_INR 1 (S N) ltac:(lia)) as M1. fold m in M1. cbn [INR] in M1.
    apply (Rmult_le_reg_r (4 * m)); [lra|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. nra. }
  replace (PI ^ 2 / (8 * m ^ 2)) with (2 * y * y) by (unfold y; field; lra).
  assert (sin y * sin y < y * y) by (apply Rmult_le_0_lt_compat; lra). lra.
Qed.

Lemma decay_conditions f g N : f < 0 -> g < 0 -> Rabs g / sqrt (Rabs f) <= INR (S N) ->
  g ^ 2 <= - f * INR (S N) ^ 2 /\ g ^ 2 * lowest N < - 2 * f.
Proof.
  intros F G HM. rewrite !Rabs_left in HM by assumption. pose proof (lt_0_INR (S N) ltac:(lia)) as M. pose proof (lowest_small N) as L.
  set (m := INR (S N)) in *. assert (S0 : 0 < sqrt (- f)) by (apply sqrt_lt_R0; lra).
  assert (S2 : sqrt (- f) * sqrt (- f) = - f) by (apply sqrt_sqrt; lra). set (s := sqrt (- f)) in *.
  assert (A : - g <= m * s).
  { apply (Rmult_le_compat_r s) in HM; [|lra]. unfold Rdiv in HM. rewrite Rmult_assoc, Rinv_l in HM by lra. lra. }
  assert (B : g ^ 2 <= - f * m ^ 2).
  { rewrite <- S2. replace (g ^ 2) with (- g * - g) by ring. replace (s * s * m ^ 2) with ((m * s) * (m * s)) by ring. apply Rmult_le_compat; lra. }
  split; [exact B|]. pose proof (lowest_range N) as [L0 _].
  assert (m2 : 0 < m ^ 2) by now apply pow_lt.
  apply Rle_lt_trans with (- f * m ^ 2 * lowest N); [apply Rmult_le_compat_r; lra|].
  apply Rlt_le_trans with (- f * m ^ 2 * (PI ^ 2 / (8 * m ^ 2))); [apply Rmult_lt_compat_l; [apply Rmult_lt_0_compat; lra|exact L]|].
  replace (- f * m ^ 2 * (PI ^ 2 / (8 * m ^ 2))) with (- f * (PI ^ 2 / 8)) by (field; lra).
  pose proof PI_4. pose proof PI_RGT_0. assert (PI ^ 2 <= 16) by nra. nra.
Qed.
(* Of the two roots of a mode the one nearer to 0, for the lowest eigenvalue. *)
Theorem slowest_rate f g N : f < 0 -> g < 0 -> Rabs g / sqrt (Rabs f) <= INR (S N) ->
  let rate := Rabs g * (1 - cos (PI / (2 * INR (S N)))) / 2 in
  (forall nu, eigenvalue_M N (P2 N) f g nu -> fst nu <= - rate) /\
  (exists nu, eigenvalue_M N (P2 N) f g nu /\ fst nu = - rate) /\
  rate < PI ^ 2 * Rabs g / (16 * INR (S N) ^ 2).
Proof.
  intros F G HM rate. destruct (decay_conditions f g N F G HM) as [_ K]. unfold rate. rewrite <- lowest_angle, !(Rabs_left g) by exact G.
  destruct (lowest_range N) as [L0 _]. pose proof (lowest_small N) as LS. set (l := lowest N) in *.
  assert (EV : forall lam, eigenvalue N (P2 N) lam -> exists q, l <= q /\ lam = RtoC q).
  { intros lam H. apply spectrum_P2 in H as (k & Hk & E). fold (angle N k) in E. exists (1 - cos (angle N k)). split; [|exact E].
    unfold l, lowest. destruct (Nat.eq_dec k 1) as [->|D].
    - unfold angle. cbn [INR]. replace ((2 * 1 - 1) * PI / (2 * (INR N + 1))) with (PI / (2 * (INR N + 1))); [lra|].
      pose proof (pos_INR N). field. lra.
    - pose proof (angle_range N k Hk) as [A1 A2]. pose proof (pos_INR N) as NP. pose proof PI_RGT_0 as PP.
      assert (A0 : 0 < PI / (2 * (INR N + 1))) by (apply Rdiv_lt_0_compat; lra).
      assert (A3 : PI / (2 * (INR N + 1)) <= angle N k).
      { unfold angle, Rdiv. apply Rmult_le_compat_r; [left; apply Rinv_0_lt_compat; lra|].
        pose proof (le_INR 1 k ltac:(lia)) as K1. cbn [INR] in K1. nra. }
      assert (cos (angle N k) <= cos (PI / (2 * (INR N + 1)))); [|lra]. apply cos_decr_1; lra. }
  split; [|split].
  - intros nu H. apply spectrum_M in H as (lam & Hl & HA); [|apply local2|exists (RtoC l); apply spectrum_P2; exists 1%nat; split; [lia|]].
    + destruct (EV lam Hl) as (q & Q & ->). apply eigenvalue_AK_iff in HA. destruct nu as [p w].
      assert (H1 := f_equal fst HA). assert (H2 := f_equal snd HA). cbn in H1, H2 |- *.
      destruct (Req_dec w 0) as [W|W].
      * subst w. apply Rnot_lt_le. intros P. set (y := - p). assert (Y : y < - g * l / 2) by (unfold y; lra).
        assert (E : y ^ 2 = q * (- g * y + f)) by (unfold y; lra).
        (* - g y + f > 0 is impossible below |f|/|g| *)
        assert (Z : - g * y < - f). { apply Rlt_le_trans with (- g * (- g * l / 2)); [apply Rmult_lt_compat_l; lra|]. nra. }
        assert (q * (- g * y + f) < 0) by nra. pose proof (pow2_ge_0 y). lra.
      * assert (w * (2 * p - q * g) = 0) by lra. apply Rmult_integral in H as [E|E]; [contradiction|]. nra.
    + unfold l, lowest. cbn [INR]. f_equal. f_equal. f_equal. f_equal. ring.
  - set (w := sqrt (- ((l * g) ^ 2 + 4 * l * f)) / 2).
    assert (D : 0 <= - ((l * g) ^ 2 + 4 * l * f)).
    { replace (- ((l * g) ^ 2 + 4 * l * f)) with (l * (- 4 * f - g ^ 2 * l)) by ring. apply Rmult_le_pos; lra. }
    exists (l * g / 2, w). split; [|cbn; field].
    apply spectrum_M; [apply local2|exists (RtoC l); apply spectrum_P2; exists 1%nat; split; [lia|]|].
    + unfold l, lowest. cbn [INR]. f_equal. f_equal. f_equal. f_equal. ring.
    + exists (RtoC l). split.
      * apply spectrum_P2. exists 1%nat. split; [lia|]. unfold l, lowest. cbn [INR]. f_equal. f_equal. f_equal. f_equal. ring.
      * apply eigenvalue_AK_iff. assert (W2 : w * w = - ((l * g) ^ 2 + 4 * l * f) / 4).
        { unfold w. transitivity (sqrt (- ((l * g) ^ 2 + 4 * l * f)) * sqrt (- ((l * g) ^ 2 + 4 * l * f)) / 4); [field|]. rewrite sqrt_sqrt by exact D. reflexivity. }
        apply injective_projections; cbn; [|field].
        transitivity ((l * g / 2) ^ 2 - w * w - l * g * (l * g / 2) - l * f); [ring|]. rewrite W2. field.
  - pose proof (lt_0_INR (S N) ltac:(lia)) as M. replace (PI ^ 2 * - g / (16 * INR (S N) ^ 2)) with (- g * (PI ^ 2 / (8 * INR (S N) ^ 2)) / 2) by (field; lra).
    assert (- g * l < - g * (PI ^ 2 / (8 * INR (S N) ^ 2))) by (apply Rmult_lt_compat_l; lra). lra.
Qed.
(* beyond.veerman.decay_rate, whole: stable for every N, at no common rate; and every motion settles at that very rate *)
Theorem decay_rate f g : f < 0 -> g < 0 ->
  (forall N, Rabs g / sqrt (Rabs f) <= INR (S N) ->
     let rate := Rabs g * (1 - cos (PI / (2 * INR (S N)))) / 2 in
     (forall nu, eigenvalue_M N (P2 N) f g nu -> fst nu <= - rate) /\
     (exists nu, eigenvalue_M N (P2 N) f g nu /\ fst nu = - rate) /\
     rate < PI ^ 2 * Rabs g / (16 * INR (S N) ^ 2) /\
     forall h x u, system_2 f g N h x u -> leader_cruises x u -> settles_at_rate rate N h x u) /\
  (forall N, stable N (P2 N) f g) /\
  (forall common, 0 < common -> exists N nu, eigenvalue_M N (P2 N) f g nu /\ - common < fst nu).
Proof.
  intros F G. split; [|split].
  - intros N HM rate. destruct (slowest_rate f g N F G HM) as (A & B & C). split; [exact A|]. split; [exact B|]. split; [exact C|].
    destruct (decay_conditions f g N F G HM) as [_ K]. destruct (lowest_range N) as [L0 _].
    assert (R : rate = - g * lowest N / 2) by (unfold rate; now rewrite <- lowest_angle, Rabs_left).
    assert (0 < - g * lowest N) by (apply Rmult_lt_0_compat; lra).
    intros h x u HS HL. apply (two_sided_settles f g rate); try assumption; rewrite R; nra.
  - intros N. now apply lemma_1.
  - intros c Hc. assert (X : 0 <= Rmax (Rabs g / sqrt (Rabs f)) (PI ^ 2 * Rabs g / (16 * c))).
    { apply Rle_trans with (PI ^ 2 * Rabs g / (16 * c)); [|apply Rmax_r].
      apply Rmult_le_pos; [apply Rmult_le_pos; [apply pow2_ge_0|apply Rabs_pos]|left; apply Rinv_0_lt_compat; lra]. }
    destruct (nfloor_ex _ X) as [N [_ HN]]. rewrite <- S_INR in HN.
    pose proof (Rmax_l (Rabs g / sqrt (Rabs f)) (PI ^ 2 * Rabs g / (16 * c))) as M1.
    pose proof (Rmax_r (Rabs g / sqrt (Rabs f)) (PI ^ 2 * Rabs g / (16 * c))) as M2.
    destruct (slowest_rate f g N F G ltac:(lra)) as (_ & (nu & E & V) & S). exists N, nu. split; [exact E|]. rewrite V.
    set (m := INR (Datatypes.S N)) in *. assert (M3 : 1 <= m) by (unfold m; apply (le_INR 1); lia).
    apply Ropp_lt_contravar. eapply Rlt_le_trans; [exact S|].
    apply (Rmult_le_reg_r (16 * m ^ 2)); [assert (0 < m ^ 2) by (apply pow_lt; lra); lra|].
    replace (PI ^ 2 * Rabs g / (16 * m ^ 2) * (16 * m ^ 2)) with (PI ^ 2 * Rabs g) by (field; lra).
    assert (Q : PI ^ 2 * Rabs g <= m * (16 * c)).
    { apply (Rmult_le_reg_r (/ (16 * c))); [apply Rinv_0_lt_compat; lra|].
      replace (m * (16 * c) * / (16 * c)) with m by (field; lra). unfold Rdiv in *. lra. }
    assert (m * (16 * c) * 1 <= m * (16 * c) * m) by (apply Rmult_le_compat_l; [apply Rmult_le_pos|]; lra). lra.
Qed.
