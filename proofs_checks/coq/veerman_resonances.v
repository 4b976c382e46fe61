(* Veerman, Stosic, Olvera, Corollary 3: lesser resonances near the odd multiples of the main one.
     veerman.cor3.
   For fixed k put phi0 = (2k-1) pi/(2M), M = N + 1.  Where mu has the angle phi0 the response grows like M; where it has the angle
   phi0 (1 - d) or phi0 (1 + d) it is at most 1/sin((k-1/2) pi d), whatever M is.  The frequency of an angle phi is
   phi sqrt(|f|/2) up to the factor 1 + O(phi^2), so for large M the three are in order, and the largest response between the outer
   two is a local maximum at (2k-1) times the main frequency up to a factor 1 + delta. *)
From Coq Require Import Reals Lra Lia Psatz.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import veerman_complex veerman_front veerman_chain veerman_peak.
Open Scope R_scope.
Ltac real_ring := match goal with |- @eq _ ?a ?b => change (@eq R a b); ring end.

(* ---- the response is a continuous function of the frequency ---- *)
Lemma gamma_continuous f g : f < 0 -> g < 0 -> (forall w, continuous (fun w => fst (gamma f g w)) w) /\ (forall w, continuous (fun w => snd (gamma f g w)) w).
Proof.
  intros Hf Hg. split; intros w.
  - apply (continuous_ext (re f g)); [intros x; symmetry; now apply gamma_re|]. apply (ex_derive_continuous (re f g)). unfold re. auto_derive.
    pose proof (den_pos f g Hf w). simpl in *. lra.
  - apply (continuous_ext (im f g)); [intros x; symmetry; now apply gamma_im|]. apply (ex_derive_continuous (im f g)). unfold im. auto_derive.
    pose proof (den_pos f g Hf w). simpl in *. lra.
Qed.
Lemma trace_continuous f g n : f < 0 -> g < 0 ->
  (forall w, continuous (fun w => fst (trace2 (mat2_pow (Cmat (gamma f g w)) n))) w) /\
  (forall w, continuous (fun w => snd (trace2 (mat2_pow (Cmat (gamma f g w)) n))) w).
Proof.
  intros Hf Hg. destruct (gamma_continuous f g Hf Hg) as [G1 G2].
  set (T := fun n w => trace2 (mat2_pow (Cmat (gamma f g w)) n)).
  assert (H : ((forall w, continuous (fun w => fst (T n w)) w) /\ (forall w, continuous (fun w => snd (T n w)) w)) /\
    ((forall w, continuous (fun w => fst (T (S n) w)) w) /\ (forall w, continuous (fun w => snd (T (S n) w)) w))); [|apply H].
  induction n as [|n [[A1 A2] [B1 B2]]].
  - split; split; intros w.
    + apply (continuous_ext (fun _ => 2)); [intros x; unfold T, trace2; cbn; ring|apply continuous_const].
    + apply (continuous_ext (fun _ => 0)); [intros x; unfold T, trace2; cbn; ring|apply continuous_const].
    + apply (continuous_ext (fun x => 2 * fst (gamma f g x))); [intros x; unfold T, trace2, mat2_mul, Cmat; cbn; ring|].
      apply (continuous_mult (fun _ => 2) (fun x => fst (gamma f g x))); [apply continuous_const|apply G1].
    + apply (continuous_ext (fun x => 2 * snd (gamma f g x))); [intros x; unfold T, trace2, mat2_mul, Cmat; cbn; ring|].
      apply (continuous_mult (fun _ => 2) (fun x => snd (gamma f g x))); [apply continuous_const|apply G2].
  - split; [split; assumption|]. split; intros w.
    + apply (continuous_ext (fun x => 2 * (fst (gamma f g x) * fst (T (S n) x)) - 2 * (snd (gamma f g x) * snd (T (S n) x)) - fst (T n x))).
      { intros x. unfold T at 4. rewrite trace_recurrence. fold (T (S n) x). fold (T n x). cbn [Cmult Cminus Cplus Copp fst snd RtoC]. real_ring. }
      apply (continuous_minus (fun x => 2 * (fst (gamma f g x) * fst (T (S n) x)) - 2 * (snd (gamma f g x) * snd (T (S n) x))) (fun x => fst (T n x))); [|apply A1].
      apply (continuous_minus (fun x => 2 * (fst (gamma f g x) * fst (T (S n) x))) (fun x => 2 * (snd (gamma f g x) * snd (T (S n) x)))).
      * apply (continuous_mult (fun _ => 2) (fun x => fst (gamma f g x) * fst (T (S n) x))); [apply continuous_const|].
        apply (continuous_mult (fun x => fst (gamma f g x)) (fun x => fst (T (S n) x))); [apply G1|apply B1].
      * apply (continuous_mult (fun _ => 2) (fun x => snd (gamma f g x) * snd (T (S n) x))); [apply continuous_const|].
        apply (continuous_mult (fun x => snd (gamma f g x)) (fun x => snd (T (S n) x))); [apply G2|apply B2].
    + apply (continuous_ext (fun x => 2 * (fst (gamma f g x) * snd (T (S n) x)) + 2 * (snd (gamma f g x) * fst (T (S n) x)) - snd (T n x))).
      { intros x. unfold T at 4. rewrite trace_recurrence. fold (T (S n) x). fold (T n x). cbn [Cmult Cminus Cplus Copp fst snd RtoC]. real_ring. }
      apply (continuous_minus (fun x => 2 * (fst (gamma f g x) * snd (T (S n) x)) + 2 * (snd (gamma f g x) * fst (T (S n) x))) (fun x => snd (T n x))); [|apply A2].
      apply (continuous_plus (fun x => 2 * (fst (gamma f g x) * snd (T (S n) x))) (fun x => 2 * (snd (gamma f g x) * fst (T (S n) x)))).
      * apply (continuous_mult (fun _ => 2) (fun x => fst (gamma f g x) * snd (T (S n) x))); [apply continuous_const|].
        apply (continuous_mult (fun x => fst (gamma f g x)) (fun x => snd (T (S n) x))); [apply G1|apply B2].
      * apply (continuous_mult (fun _ => 2) (fun x => snd (gamma f g x) * fst (T (S n) x))); [apply continuous_const|].
        apply (continuous_mult (fun x => snd (gamma f g x)) (fun x => fst (T (S n) x))); [apply G2|apply B1].
Qed.
Lemma response_continuous f g N w : f < 0 -> g < 0 -> continuity_pt (response f g N) w.
Proof.
  intros Hf Hg. apply continuity_pt_filterlim. destruct (trace_continuous f g (S N) Hf Hg) as [A B].
  set (T := fun w => trace2 (mat2_pow (Cmat (gamma f g w)) (S N))) in *.
  apply (continuous_ext (fun x => 2 * / Cmod (T x))); [intros x; symmetry; apply (response_modulus f g N x); now apply trace_neq0|].
  apply (continuous_mult (fun _ => 2) (fun x => / Cmod (T x))); [apply continuous_const|].
  apply (continuous_comp (fun x => Cmod (T x)) Rinv).
  - apply (continuous_comp (fun x => fst (T x) ^ 2 + snd (T x) ^ 2) sqrt); [|apply continuous_sqrt].
    apply (continuous_plus (fun x => fst (T x) ^ 2) (fun x => snd (T x) ^ 2)).
    + apply (continuous_ext (fun x => fst (T x) * fst (T x))); [intros; cbn; real_ring|]. apply (continuous_mult (fun x => fst (T x)) (fun x => fst (T x))); apply A.
    + apply (continuous_ext (fun x => snd (T x) * snd (T x))); [intros; cbn; real_ring|]. apply (continuous_mult (fun x => snd (T x)) (fun x => snd (T x))); apply B.
  - apply continuous_Rinv. apply Rgt_not_eq, Cmod_gt_0. now apply trace_neq0.
Qed.

(* ---- the frequency of an angle: w^2 = (|f| phi^2/2)(1 + O(phi^2)) ---- *)
Definition sway (f g : R) : R := 4 * height f g.
Definition error (f g : R) : R := 1 + 2 * stiffness_term f g + sway f g ^ 2.
Lemma sway_pos f g : f < 0 -> g < 0 -> 0 < sway f g.
Proof. intros Hf Hg. unfold sway. pose proof (height_pos f g Hf Hg). lra. Qed.
Lemma error_ge f g : f < 0 -> g < 0 -> 1 <= error f g.
Proof. intros Hf Hg. unfold error. pose proof (k_pos f g Hf Hg). pose proof (pow2_ge_0 (sway f g)). lra. Qed.
Lemma angle_estimate f g phi : f < 0 -> g < 0 -> 0 < phi -> error f g * phi ^ 2 <= / 2 ->
  exists w c s, 0 < w /\ 0 < s /\ 1 < c /\ c ^ 2 - s ^ 2 = 1 /\
    fst (gamma f g w) = c * cos phi /\ snd (gamma f g w) = s * sin phi /\ s <= sway f g * phi ^ 2 /\
    - f * phi ^ 2 / 2 * (1 - error f g * phi ^ 2) <= w ^ 2 <= - f * phi ^ 2 / 2 * (1 + error f g * phi ^ 2).
Proof.
  intros Hf Hg P C. pose proof (k_pos f g Hf Hg) as K0. pose proof (sway_pos f g Hf Hg) as B0. pose proof (error_ge f g Hf Hg) as E1.
  set (h := phi ^ 2) in *. assert (h0 : 0 < h) by (apply pow_lt; lra).
  assert (KE : 2 * stiffness_term f g + / 2 <= error f g /\ / 4 + sway f g ^ 2 <= error f g) by (unfold error; pose proof (pow2_ge_0 (sway f g)); lra).
  destruct KE as [KE BE]. assert (small : (/ 2 + 2 * stiffness_term f g) * h < 1) by nra.
  assert (h1 : h <= / 2) by nra. assert (kh : stiffness_term f g * h <= / 4) by nra.
  destruct (angle_frequency f g phi Hf Hg P small) as (w & c & s & W & WU & s0 & c1 & E & G1 & G2 & L). exists w, c, s. fold h in WU, L.
  assert (S4 : s <= sway f g * h).
  { apply Rle_trans with (1 := L). unfold sway. pose proof (height_pos f g Hf Hg). set (q := quotient f g phi).
    assert (Q34 : 3 / 4 <= q) by (unfold q, quotient; fold h; lra). assert (V : / 4 <= q ^ 2 * (1 - h / 2)) by nra.
    apply (Rmult_le_reg_r (q ^ 2 * (1 - h / 2))); [lra|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra.
    assert (0 < height f g * h) by (apply Rmult_lt_0_compat; lra). nra. }
  repeat split; try assumption.
  - (* below *)
    rewrite gamma_re in G1 by assumption. unfold re in G1. pose proof (den_pos f g Hf w) as DP.
    assert (F2 : 0 < f ^ 2) by (apply pow2_gt_0; lra). pose proof (pow2_ge_0 (w * g)) as WG. pose proof (pow2_ge_0 w) as WW.
    assert (X : w ^ 2 * - f / (f ^ 2 + (w * g) ^ 2) <= w ^ 2 / - f).
    { apply Rle_trans with (w ^ 2 * - f / f ^ 2); [|right; field; lra]. unfold Rdiv. apply Rmult_le_compat_l; [apply Rmult_le_pos; lra|]. apply Rinv_le_contravar; lra. }
    assert (Y : - f * (1 - c * cos phi) <= w ^ 2).
    { apply (Rmult_le_reg_r (/ - f)); [apply Rinv_0_lt_compat; lra|]. replace (- f * (1 - c * cos phi) * / - f) with (1 - c * cos phi) by (field; lra).
      replace (w ^ 2 * / - f) with (w ^ 2 / - f) by reflexivity. lra. }
    apply Rle_trans with (2 := Y).
    assert (CU : c <= 1 + s ^ 2 / 2) by nra.
    assert (C1 : 0 < cos phi < 1) by (apply (phi_range f g phi Hf Hg P small)).
    assert (HS : (/ 2 + 2 * stiffness_term f g) * (phi / 2) ^ 2 < 1).
    { replace ((phi / 2) ^ 2) with (h / 4) by (unfold h; field). nra. }
    destruct (phi_range f g (phi / 2) Hf Hg ltac:(lra) HS) as (_ & SL & SP).
    replace ((phi / 2) ^ 2 / 2) with (h / 8) in SL by (unfold h; field).
    assert (CE : cos phi = 1 - 2 * sin (phi / 2) * sin (phi / 2)) by (replace phi with (2 * (phi / 2)) at 1 by field; apply cos_2a_sin).
    assert (SQ : h / 4 * (1 - h / 4) <= sin (phi / 2) * sin (phi / 2)).
    { apply Rle_trans with (phi / 2 * (1 - h / 8) * (phi / 2 * (1 - h / 8))).
      - replace (phi / 2 * (1 - h / 8) * (phi / 2 * (1 - h / 8))) with (h / 4 * ((1 - h / 8) * (1 - h / 8))) by (unfold h; field).
        apply Rmult_le_compat_l; [lra|]. nra.
      - apply Rmult_le_compat; try exact SL; apply Rmult_le_pos; lra. }
    assert (CC : c * cos phi <= cos phi + s ^ 2 / 2).
    { pose proof (pow2_ge_0 s). assert (c * cos phi <= (1 + s ^ 2 / 2) * cos phi) by (apply Rmult_le_compat_r; lra). nra. }
    assert (S2 : s ^ 2 <= sway f g ^ 2 * h * h).
    { replace (sway f g ^ 2 * h * h) with ((sway f g * h) ^ 2) by ring. apply pow_incr. lra. }
    assert (Z : h / 2 * (1 - error f g * h) <= 1 - c * cos phi).
    { assert (h / 2 * (1 - (/ 4 + sway f g ^ 2) * h) <= 1 - c * cos phi) by nra.
      assert ((/ 4 + sway f g ^ 2) * h <= error f g * h) by (apply Rmult_le_compat_r; lra). nra. }
    replace (- f * h / 2 * (1 - error f g * h)) with (- f * (h / 2 * (1 - error f g * h))) by field. apply Rmult_le_compat_l; lra.
  - (* above *)
    apply Rle_trans with (1 := WU). set (q := quotient f g phi). assert (Q34 : 3 / 4 <= q) by (unfold q, quotient; fold h; lra).
    apply (Rmult_le_reg_r (2 * q)); [lra|]. replace (h * - f / (2 * q) * (2 * q)) with (- f * h) by (field; lra).
    assert (V : 1 <= (1 + error f g * h) * q).
    { apply Rle_trans with ((1 + 2 * stiffness_term f g * h) * q).
      - unfold q, quotient. fold h. assert (0 <= stiffness_term f g * h) by (apply Rmult_le_pos; lra). nra.
      - apply Rmult_le_compat_r; [lra|]. assert (2 * stiffness_term f g * h <= error f g * h) by (apply Rmult_le_compat_r; lra). lra. }
    replace (- f * h / 2 * (1 + error f g * h) * (2 * q)) with (- f * h * ((1 + error f g * h) * q)) by field.
    assert (0 < - f * h) by (apply Rmult_lt_0_compat; lra). nra.
Qed.

(* ---- Corollary 3 ---- *)
Definition odd_angle (k : nat) : R := (2 * INR k - 1) * PI / 2.
Lemma odd_angle_cos k x : Rabs (cos (odd_angle k + x)) = Rabs (sin x) /\ cos (odd_angle k) = 0.
Proof.
  assert (S0 : sin (INR k * PI) = 0) by (apply sin_eq_0_1; exists (Z.of_nat k); now rewrite <- INR_IZR_INZ).
  assert (Q : odd_angle k = INR k * PI - PI / 2) by (unfold odd_angle; field).
  assert (C : cos (odd_angle k) = 0) by (rewrite Q, cos_minus, cos_PI2, sin_PI2, S0; ring). split; [|exact C].
  rewrite cos_plus, C, Rmult_0_l, Rminus_0_l, Rabs_Ropp, Rabs_mult.
  pose proof (sin2_cos2 (odd_angle k)) as T. rewrite C in T. unfold Rsqr in T.
  assert (A : Rabs (sin (odd_angle k)) = 1).
  { pose proof (Rabs_pos (sin (odd_angle k))). assert (Rabs (sin (odd_angle k)) * Rabs (sin (odd_angle k)) = 1).
    { rewrite <- Rabs_mult, Rabs_pos_eq; [lra|nra]. } nra. }
  rewrite A. ring.
Qed.
Theorem corollary_3 f g : f < 0 -> g < 0 -> forall k, (1 <= k)%nat -> forall delta, 0 < delta ->
  exists N0, forall N, (N0 <= N)%nat -> exists w,
    (exists e, 0 < e /\ forall x, Rabs (x - w) < e -> response f g N x <= response f g N w) /\ 1 < response f g N w /\
    Rabs (w - (2 * INR k - 1) * (sqrt (Rabs f) * PI / (INR (N + 1) * 2 * sqrt 2))) <=
      delta * ((2 * INR k - 1) * (sqrt (Rabs f) * PI / (INR (N + 1) * 2 * sqrt 2))).
Proof.
  intros Hf Hg k Hk delta Hdelta. pose proof (le_INR 1 k Hk) as K1. cbn [INR] in K1. pose proof PI_RGT_0 as PI0.
  pose proof (sway_pos f g Hf Hg) as B0. pose proof (error_ge f g Hf Hg) as C1. set (B := sway f g) in *. set (C := error f g) in *.
  set (Q := odd_angle k). assert (Q0 : 0 < Q) by (unfold Q, odd_angle; nra). assert (QK : Q < INR k * PI) by (unfold Q, odd_angle; nra).
  set (d := Rmin (delta / 4) (/ (4 * INR k))). assert (Ik : 0 < / (4 * INR k)) by (apply Rinv_0_lt_compat; lra).
  assert (d0 : 0 < d) by (unfold d; apply Rmin_glb_lt; lra). assert (dd : d <= delta / 4) by apply Rmin_l.
  assert (dk : d <= / (4 * INR k)) by apply Rmin_r.
  assert (d4 : d <= / 4) by (apply Rle_trans with (1 := dk); apply Rinv_le_contravar; lra).
  assert (Qd : Q * d < PI / 2).
  { apply Rle_lt_trans with (Q * / (4 * INR k)); [apply Rmult_le_compat_l; lra|]. apply (Rmult_lt_reg_r (4 * INR k)); [lra|].
    rewrite Rmult_assoc, Rinv_l by lra. lra. }
  assert (Qd0 : 0 < Q * d) by (apply Rmult_lt_0_compat; lra).
  set (sg := sin (Q * d)). assert (sg0 : 0 < sg) by (apply sin_gt_0; lra). assert (sg1 : sg <= 1) by apply SIN_bound.
  assert (T0 : 0 < 16 * C * Q ^ 2 / d) by (apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat; [lra|apply pow_lt; lra]|lra]).
  assert (Isg : 1 <= / sg) by (rewrite <- Rinv_1 at 1; apply Rinv_le_contravar; lra).
  assert (Q2 : 0 < Q ^ 2) by (apply pow_lt; lra).
  assert (T1 : 0 < B * Q ^ 2 * (1 + / sg)) by (apply Rmult_lt_0_compat; [apply Rmult_lt_0_compat; lra|lra]).
  destruct (unbounded (16 * C * Q ^ 2 / d + B * Q ^ 2 * (1 + / sg))) as (N0 & HN0). exists N0. intros N HN. rewrite Nat.add_1_r.
  pose proof (M_pos N) as M1. set (M := INR (S N)) in *.
  assert (MB : 16 * C * Q ^ 2 / d + B * Q ^ 2 * (1 + / sg) < M) by (apply Rlt_le_trans with (1 := HN0); apply le_INR; lia).
  (* the three angles *)
  assert (HC : forall r, 0 <= r <= 2 -> C * (Q / M * r) ^ 2 <= d / 4).
  { intros r Hr. apply Rle_trans with (4 * C * Q ^ 2 / M).
    - replace (C * (Q / M * r) ^ 2) with (C * Q ^ 2 * (r * r / M) / M) by (field; lra). replace (4 * C * Q ^ 2 / M) with (C * Q ^ 2 * 4 / M) by (field; lra).
      unfold Rdiv. apply Rmult_le_compat_r; [left; apply Rinv_0_lt_compat; lra|]. apply Rmult_le_compat_l; [apply Rmult_le_pos; lra|].
      assert (/ M <= 1) by (rewrite <- Rinv_1; apply Rinv_le_contravar; lra). assert (0 < / M) by (apply Rinv_0_lt_compat; lra). nra.
    - apply (Rmult_le_reg_r (M * 4 / d)); [apply Rdiv_lt_0_compat; lra|].
      replace (4 * C * Q ^ 2 / M * (M * 4 / d)) with (16 * C * Q ^ 2 / d) by (field; split; lra). replace (d / 4 * (M * 4 / d)) with M by (field; lra). lra. }
  assert (QM : 0 < Q / M) by (apply Rdiv_lt_0_compat; lra).
  set (U := - f * (Q / M) ^ 2 / 2). assert (U0 : 0 < U) by (unfold U; assert (0 < (Q / M) ^ 2) by (apply pow_lt; lra); nra).
  assert (AT : forall r, 0 < r <= 2 -> exists w c s, 0 < w /\ 0 < s /\ 1 < c /\ c ^ 2 - s ^ 2 = 1 /\
    fst (gamma f g w) = c * cos (Q / M * r) /\ snd (gamma f g w) = s * sin (Q / M * r) /\ s <= B * (Q / M * r) ^ 2 /\
    U * r ^ 2 * (1 - d / 4) <= w ^ 2 <= U * r ^ 2 * (1 + d / 4)).
  { intros r Hr. specialize (HC r ltac:(lra)). destruct (angle_estimate f g (Q / M * r) Hf Hg ltac:(apply Rmult_lt_0_compat; lra) ltac:(fold C; lra))
      as (w & c & s & W & s0 & c1 & E & G1 & G2 & L & LO & UP). exists w, c, s. fold B in L. fold C in LO, UP.
    replace (- f * (Q / M * r) ^ 2 / 2) with (U * r ^ 2) in LO, UP by (unfold U; field; lra).
    assert (0 < U * r ^ 2) by (apply Rmult_lt_0_compat; [lra|apply pow_lt; lra]). repeat split; try assumption.
    - apply Rle_trans with (2 := LO). apply Rmult_le_compat_l; lra.
    - apply Rle_trans with (1 := UP). apply Rmult_le_compat_l; lra. }
  destruct (AT 1 ltac:(lra)) as (wo & co & so & Wo & so0 & co1 & Eo & Go1 & Go2 & Lo & LOo & UPo).
  destruct (AT (1 - d) ltac:(lra)) as (wm & cm & sm & Wm & sm0 & cm1 & Em & Gm1 & Gm2 & _ & LOm & UPm).
  destruct (AT (1 + d) ltac:(lra)) as (wp & cp & sp & Wp & sp0 & cp1 & Ep & Gp1 & Gp2 & _ & LOp & UPp).
  (* their responses *)
  destruct (odd_angle_cos k 0) as [_ CQ].
  assert (Ro : / sg < response f g N wo).
  { destruct (hyperbolic_pair co so so0 co1 Eo) as (R1 & I & A & A').
    rewrite (polar_response f g N wo (co + so) (Q / M * 1) Hf Hg R1);
      [|fold M; replace (M * (Q / M * 1)) with Q by (field; lra); exact CQ|now rewrite A|now rewrite A'].
    assert (D0 : 0 < M * so) by (apply Rmult_lt_0_compat; lra).
    assert (DU : M * so <= B * Q ^ 2 / M).
    { replace (B * Q ^ 2 / M) with (M * (B * (Q / M * 1) ^ 2)) by (field; lra). apply Rmult_le_compat_l; lra. }
    assert (BQ : 0 < B * Q ^ 2) by (apply Rmult_lt_0_compat; lra).
    assert (X : 1 + / sg < / (M * so)).
    { apply Rlt_le_trans with (M / (B * Q ^ 2)).
      - apply (Rmult_lt_reg_r (B * Q ^ 2)); [exact BQ|]. replace (M / (B * Q ^ 2) * (B * Q ^ 2)) with M by (field; lra). lra.
      - replace (M / (B * Q ^ 2)) with (/ (B * Q ^ 2 / M)) by (field; split; lra). now apply Rinv_le_contravar. }
    assert (D1 : M * so < 1) by (rewrite <- (Rinv_inv (M * so)), <- Rinv_1; apply Rinv_lt_contravar; lra).
    apply Rlt_le_trans with (/ (M * so) - 1); [lra|]. apply hyperbolic_lower; try assumption; [lra|lia]. }
  assert (OUT : forall w c s r x, 0 < s -> 1 < c -> c ^ 2 - s ^ 2 = 1 -> fst (gamma f g w) = c * cos (Q / M * r) -> snd (gamma f g w) = s * sin (Q / M * r) ->
    Q * r = Q + x -> Rabs (sin x) = sg -> response f g N w <= / sg).
  { intros w c s r x s0 c1 E G1 G2 X SX. destruct (hyperbolic_pair c s s0 c1 E) as (R1 & I & A & A').
    assert (CA : Rabs (cos (M * (Q / M * r))) = sg).
    { replace (M * (Q / M * r)) with (Q + x) by (rewrite <- X; field; lra). rewrite <- SX. apply odd_angle_cos. }
    rewrite <- CA. apply (polar_bounded f g N w (c + s) (Q / M * r) Hf Hg R1); [|now rewrite A|now rewrite A'].
    intros Z. fold M in Z. rewrite Z, Rabs_R0 in CA. lra. }
  assert (Rm : response f g N wm <= / sg).
  { apply (OUT wm cm sm (1 - d) (- (Q * d))); try assumption; [ring|]. rewrite sin_neg, Rabs_Ropp. now apply Rabs_pos_eq, Rlt_le. }
  assert (Rp : response f g N wp <= / sg).
  { apply (OUT wp cp sp (1 + d) (Q * d)); try assumption; [ring|]. now apply Rabs_pos_eq, Rlt_le. }
  clear OUT AT.
  (* their order *)
  assert (D2 : 0 < d ^ 2 <= d / 4) by (split; [apply pow_lt; lra|replace (d ^ 2) with (d * d) by ring; replace (d / 4) with (d * / 4) by field; apply Rmult_le_compat_l; lra]).
  assert (D3 : 0 < d ^ 3 <= d / 16).
  { split; [apply pow_lt; lra|]. replace (d ^ 3) with (d * d ^ 2) by ring. replace (d / 16) with (d * / 16) by field. apply Rmult_le_compat_l; lra. }
  assert (MO : wm < wo).
  { apply Rsqr_incrst_0; [|lra|lra]. rewrite !Rsqr_pow2. apply Rle_lt_trans with (1 := UPm). apply Rlt_le_trans with (2 := LOo).
    rewrite !Rmult_assoc. apply Rmult_lt_compat_l; [exact U0|].
    replace ((1 - d) ^ 2 * (1 + d / 4)) with (1 - 7 / 4 * d + d ^ 2 / 2 + d ^ 3 / 4) by field. lra. }
  assert (OP : wo < wp).
  { apply Rsqr_incrst_0; [|lra|lra]. rewrite !Rsqr_pow2. apply Rle_lt_trans with (1 := UPo). apply Rlt_le_trans with (2 := LOp).
    rewrite !Rmult_assoc. apply Rmult_lt_compat_l; [exact U0|].
    replace ((1 + d) ^ 2 * (1 - d / 4)) with (1 + 7 / 4 * d + d ^ 2 / 2 - d ^ 3 / 4) by field. lra. }
  destruct (continuity_ab_maj (response f g N) wm wp ltac:(lra) (fun x _ => response_continuous f g N x Hf Hg)) as (w & Hmax & Hin).
  pose proof (Hmax wo ltac:(lra)) as Lw.
  assert (Nm : w <> wm) by (intros ->; lra). assert (Np : w <> wp) by (intros ->; lra).
  exists w. split; [|split; [lra|]].
  - exists (Rmin (w - wm) (wp - w)). split; [apply Rmin_glb_lt; lra|]. intros x Hx. apply Hmax.
    pose proof (Rmin_l (w - wm) (wp - w)). pose proof (Rmin_r (w - wm) (wp - w)). apply Rabs_lt_between in Hx. lra.
  - (* the place *)
    rewrite (Rabs_left f) by lra. set (rf := (2 * INR k - 1) * (sqrt (- f) * PI / (M * 2 * sqrt 2))).
    assert (t0 : 0 < sqrt 2) by (apply sqrt_lt_R0; lra). assert (t2 : sqrt 2 * sqrt 2 = 2) by (apply sqrt_sqrt; lra).
    assert (r0 : 0 < sqrt (- f)) by (apply sqrt_lt_R0; lra). assert (r2 : sqrt (- f) * sqrt (- f) = - f) by (apply sqrt_sqrt; lra).
    assert (RF : rf ^ 2 = U).
    { unfold rf, U, Q, odd_angle. replace (((2 * INR k - 1) * (sqrt (- f) * PI / (M * 2 * sqrt 2))) ^ 2)
        with ((2 * INR k - 1) ^ 2 * (sqrt (- f) * sqrt (- f)) * PI ^ 2 / (M ^ 2 * 4 * (sqrt 2 * sqrt 2))) by (field; split; lra).
      rewrite r2, t2. field. lra. }
    assert (rf0 : 0 < rf). { unfold rf. apply Rmult_lt_0_compat; [lra|]. apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat; lra|]. apply Rmult_lt_0_compat; lra. }
    assert (LOW : rf * (1 - 4 * d) <= w).
    { apply Rle_trans with wm; [|lra]. apply Rsqr_incr_0; [|apply Rmult_le_pos; lra|lra]. rewrite !Rsqr_pow2, Rpow_mult_distr, RF.
      apply Rle_trans with (2 := LOm). rewrite Rmult_assoc. apply Rmult_le_compat_l; [lra|].
      replace ((1 - d) ^ 2 * (1 - d / 4)) with (1 - 9 / 4 * d + 3 / 2 * d ^ 2 - d ^ 3 / 4) by field.
      replace ((1 - 4 * d) ^ 2) with (1 - 8 * d + 16 * d ^ 2) by ring. lra. }
    assert (UPP : w <= rf * (1 + 4 * d)).
    { apply Rle_trans with wp; [lra|]. apply Rsqr_incr_0; [|lra|apply Rmult_le_pos; lra]. rewrite !Rsqr_pow2, Rpow_mult_distr, RF.
      apply Rle_trans with (1 := UPp). rewrite Rmult_assoc. apply Rmult_le_compat_l; [lra|].
      replace ((1 + d) ^ 2 * (1 + d / 4)) with (1 + 9 / 4 * d + 3 / 2 * d ^ 2 + d ^ 3 / 4) by field.
      replace ((1 + 4 * d) ^ 2) with (1 + 8 * d + 16 * d ^ 2) by ring. lra. }
    apply Rabs_le. assert (rf * (4 * d) <= delta * rf) by (rewrite (Rmult_comm delta); apply Rmult_le_compat_l; lra). lra.
Qed.
