(* Tanner, Jadbabaie, Pappas, Part I: two linked agents on a line, V = 1/s + log s, s the squared distance.  From (0, 0) and (2, 0) with
   the velocity (2, 0) there is one motion, it lasts for ever, headings stay 0 and the distance is periodic: a swing.
     tanner1.propIV3b, tanner1.proof_cases (corrected). *)
From Coq Require Import Reals Lra Lia Psatz Classical.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums inclusions paley_model paley_phase paley_laplacian paley_gradient tanner_energy tanner_flock tanner1_heading tanner_angle.
From Flockproof Require Import IntervalStdZ.
Open Scope R_scope.

(* ---- the potential ---- *)
Lemma V2_numbers : V2 2 < 1.64 /\ V2 2 < V2 (1 / 2) /\ V2 2 < V2 3 /\ 1 < V2 2.
Proof. unfold V2. repeat split; interval with (i_prec 60). Qed.
Lemma V2'_slope s : 0 < s -> is_derive V2' s (- 2 / s ^ 2 + 6 / s ^ 4).
Proof.
  intros Hs. unfold V2'. auto_derive; [repeat split; try lra; apply Rgt_not_eq; repeat apply Rmult_lt_0_compat; lra|field; lra].
Qed.
Lemma V2'_lip a b : 1 / 4 <= a -> 1 / 4 <= b -> Rabs (V2' a - V2' b) <= 1568 * Rabs (a - b).
Proof.
  assert (Q : forall a b, 1 / 4 <= a -> a <= b -> Rabs (V2' b - V2' a) <= 1568 * Rabs (b - a)).
  { clear. intros a b Ha Hab. destruct (MVT_le V2' (fun s => - 2 / s ^ 2 + 6 / s ^ 4) a b Hab) as (c & Hc & E); [intros t Ht; apply V2'_slope; lra|].
    rewrite E, Rabs_mult. apply Rmult_le_compat_r; [apply Rabs_pos|]. set (x := / c). assert (X : 0 < x <= 4).
    { unfold x. split; [apply Rinv_0_lt_compat; lra|]. replace 4 with (/ (1 / 4)) by field. apply Rinv_le_contravar; lra. }
    replace (- 2 / c ^ 2 + 6 / c ^ 4) with (-2 * x ^ 2 + 6 * (x ^ 2) ^ 2) by (unfold x; field; lra). assert (0 <= x ^ 2 <= 16) by nra. set (y := x ^ 2) in *. apply Rabs_le. nra. }
  intros Ha Hb. destruct (Rle_or_lt a b) as [L|L]; [rewrite Rabs_minus_sym, (Rabs_minus_sym a); now apply Q|apply Q; lra].
Qed.
Lemma V2'_above s : 1 < s -> 0 < V2' s.
Proof. intros Hs. rewrite V2'_sign by lra. apply Rdiv_lt_0_compat; [nra|apply pow_lt; lra]. Qed.
Lemma V2'_below s d : 0 < s -> s <= d -> d < 1 -> V2' s <= - 2 * (1 - d).
Proof.
  intros H0 H1 Hd. rewrite V2'_sign by exact H0. assert (P : 0 < s ^ 3) by (apply pow_lt; lra). apply Rmult_le_reg_r with (s ^ 3); [exact P|].
  unfold Rdiv. rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra. assert (s ^ 3 <= 1) by nra. nra.
Qed.
Lemma zero_by_growth (Q Q' : R -> R) k a b : a <= b -> (forall t, a <= t <= b -> is_derive Q t (Q' t)) -> (forall t, a <= t <= b -> Q' t <= k * Q t) ->
  Q a = 0 -> 0 <= Q b -> Q b = 0.
Proof.
  intros Hab D G Z N. assert (M : Q b * exp (- k * b) <= Q a * exp (- k * a)).
  { apply (decreasing (fun s => Q s * exp (- k * s)) (fun s => Q' s * exp (- k * s) + Q s * (exp (- k * s) * (- k))) a b Hab).
    - intros s Hs. apply (D_mult Q (fun x => exp (- k * x))); [now apply D|].
      apply (D_comp exp (fun x => - k * x) s (exp (- k * s)) (- k)); [apply is_derive_exp|]. eapply D_eq; [apply D_scal, D_id|]. ring.
    - intros s Hs. specialize (G s Hs). pose proof (exp_pos (- k * s)). nra. }
  rewrite Z, Rmult_0_l in M. pose proof (exp_pos (- k * b)). nra.
Qed.

(* ---- distance and its rate ---- *)
Definition swinging (d w : R -> R) (t : R) := is_derive d t (w t) /\ is_derive w t (- 2 * V2' (d t)).
Lemma same_swing b d w e u : 0 <= b -> (forall t, 0 <= t <= b -> swinging d w t /\ 1 / 4 <= d t) -> (forall t, 0 <= t <= b -> swinging e u t /\ 1 / 4 <= e t) ->
  d 0 = e 0 -> w 0 = u 0 -> d b = e b /\ w b = u b.
Proof.
  intros Hb S1 S2 E1 E2. set (Q := fun t => (d t - e t) ^ 2 + (w t - u t) ^ 2).
  assert (Z : Q b = 0).
  { apply (zero_by_growth Q (fun t => 2 * (d t - e t) * (w t - u t) + 2 * (w t - u t) * (- 2 * V2' (d t) - - 2 * V2' (e t))) 3137 0 b Hb).
    - intros t Ht. destruct (S1 t Ht) as [[A1 A2] _]. destruct (S2 t Ht) as [[B1 B2] _]. unfold Q.
      apply D_plus; [apply (D_sqr (fun s => d s - e s)); now apply D_minus|apply (D_sqr (fun s => w s - u s)); now apply D_minus].
    - intros t Ht. destruct (S1 t Ht) as [_ A]. destruct (S2 t Ht) as [_ B]. pose proof (V2'_lip (d t) (e t) A B) as L. unfold Q.
      set (x := d t - e t) in *. set (y := w t - u t) in *. set (z := V2' (d t) - V2' (e t)) in *.
      replace (2 * x * y + 2 * y * (- 2 * V2' (d t) - - 2 * V2' (e t))) with (2 * x * y - 4 * (y * z)) by (unfold z; ring).
      assert (Y : - (y * z) <= 1568 * (Rabs y * Rabs x)).
      { eapply Rle_trans; [apply Rle_abs|]. rewrite Rabs_Ropp, Rabs_mult. pose proof (Rabs_pos y). nra. }
      assert (2 * (Rabs y * Rabs x) <= x ^ 2 + y ^ 2).
      { rewrite <- (pow2_abs x), <- (pow2_abs y). pose proof (pow2_ge_0 (Rabs x - Rabs y)). nra. }
      pose proof (pow2_ge_0 (x - y)). nra.
    - unfold Q. rewrite E1, E2. ring.
    - unfold Q. pose proof (pow2_ge_0 (d b - e b)). pose proof (pow2_ge_0 (w b - u b)). lra. }
  unfold Q in Z. pose proof (pow2_ge_0 (d b - e b)). pose proof (pow2_ge_0 (w b - u b)). split; apply Rminus_diag_uniq; apply Rsqr_0_uniq; unfold Rsqr; nra.
Qed.

Definition held (a b s : R) := Rmax a (Rmin s b).
Lemma held_in a b s : a <= b -> a <= held a b s <= b.
Proof. intros H. unfold held, Rmax, Rmin. destruct (Rle_dec s b); destruct (Rle_dec a _); lra. Qed.
Lemma held_is a b s : a <= s <= b -> held a b s = s.
Proof. intros H. unfold held. rewrite Rmin_left, Rmax_right by lra. reflexivity. Qed.
Lemma held_near a b s t : Rabs (held a b s - held a b t) <= Rabs (s - t).
Proof. unfold held, Rmax, Rmin. destruct (Rle_dec s b), (Rle_dec t b); repeat destruct (Rle_dec a _); unfold Rabs; repeat destruct (Rcase_abs _); lra. Qed.
Lemma lipschitz_continuous (f : R -> R) L x : 0 < L -> (forall s t, Rabs (f s - f t) <= L * Rabs (s - t)) -> continuity_pt f x.
Proof.
  intros HL H e He. exists (e / L). split; [apply Rdiv_lt_0_compat; lra|]. intros y [_ Hy]. cbn in *. unfold R_dist in *. eapply Rle_lt_trans; [apply H|].
  apply Rlt_le_trans with (L * (e / L)); [now apply Rmult_lt_compat_l|right; field; lra].
Qed.
Lemma antiderivative (f : R -> R) a c : (forall x, continuity_pt f x) -> exists U : R -> R, U a = c /\ forall x, is_derive U x (f x).
Proof.
  intros H. exists (fun x => RInt f a x + c). split; [rewrite RInt_point; unfold zero; cbn; ring|]. intros x.
  replace (f x) with (f x + 0) by ring. apply D_plus; [|apply D_const]. apply (is_derive_RInt f (fun x => RInt f a x) a x).
  - apply filter_forall. intros y. apply (RInt_correct f). apply (ex_RInt_continuous f). intros z _. apply continuity_pt_filterlim, H.
  - apply continuity_pt_filterlim, H.
Qed.
Lemma same_derivative (f g h : R -> R) a b x y : a <= b -> (forall t, a <= t <= b -> is_derive f t (h t)) -> (forall t, a <= t <= b -> is_derive g t (h t)) ->
  a <= x <= b -> a <= y <= b -> f x = g x -> f y = g y.
Proof.
  intros Hab F G Hx Hy E.
  assert (M : forall p q, a <= p -> p <= q -> q <= b -> f q - g q = f p - g p).
  { intros p q Hp Hpq Hq. destruct (MVT_le (fun s => f s - g s) (fun s => h s - h s) p q Hpq) as (c & _ & Q); [intros t Ht; apply D_minus; [apply F|apply G]; lra|]. cbv beta in Q. lra. }
  destruct (Rle_or_lt x y) as [L|L]; [specialize (M x y ltac:(lra) L ltac:(lra))|specialize (M y x ltac:(lra) ltac:(lra) ltac:(lra))]; lra.
Qed.

Lemma swing_exists : exists d w : R -> R, d 0 = 2 /\ w 0 = 0 /\ forall t, 0 <= t -> swinging d w t /\ 1 / 2 < d t <= 2 /\ Rabs (w t) < 1.6.
Proof.
  set (F := fun x => V2' (held (1 / 2) 3 x)). set (G := fun x => / 2 * held (-2) 2 x).
  assert (LF : forall s t, Rabs (F s - F t) <= 1568 * Rabs (s - t)).
  { intros s t. pose proof (held_in (1 / 2) 3 s ltac:(lra)). pose proof (held_in (1 / 2) 3 t ltac:(lra)). unfold F.
    eapply Rle_trans; [apply V2'_lip; lra|]. apply Rmult_le_compat_l; [lra|apply held_near]. }
  assert (LG : forall s t, Rabs (G s - G t) <= / 2 * Rabs (s - t)).
  { intros s t. unfold G. rewrite <- Rmult_minus_distr_l, Rabs_mult, (Rabs_pos_eq (/ 2)) by lra. apply Rmult_le_compat_l; [lra|apply held_near]. }
  assert (CF : forall x, continuity_pt F x) by (intros; apply (lipschitz_continuous F 1568); [lra|exact LF]).
  assert (CG : forall x, continuity_pt G x) by (intros; apply (lipschitz_continuous G (/ 2)); [lra|exact LG]).
  destruct (antiderivative F 1 1 CF) as (U & U1 & DU). destruct (antiderivative G 0 0 CG) as (K & K0 & DK).
  destruct fig2_shape as (Sh1 & Sh2 & Sh3 & Sh4). destruct V2_numbers as (N1 & N2 & N3 & N4).
  assert (UV : forall x, 1 / 2 <= x <= 3 -> U x = V2 x).
  { intros x Hx. apply (same_derivative U V2 F (1 / 2) 3 1 x); try lra; [intros; apply DU|]. intros t Ht. unfold F. rewrite held_is by lra. apply V2_derive. lra. }
  assert (KV : forall x, -2 <= x <= 2 -> K x = / 4 * x ^ 2).
  { intros x Hx. apply (same_derivative K (fun x => / 4 * x ^ 2) G (-2) 2 0 x); try lra; [intros; apply DK|]. intros t Ht. unfold G. rewrite held_is by lra.
    eapply D_eq; [apply (D_scal (/ 4) (fun x => x ^ 2)), (D_sqr (fun x => x)), D_id|]. field. }
  assert (UL : forall x, V2 2 >= U x -> 1 / 2 < x < 3).
  { intros x Hx. split; apply Rnot_le_lt; intros L.
    - destruct (MVT_le U F x (1 / 2) L) as (c & Hc & E); [intros; apply DU|]. rewrite (UV (1 / 2)) in E by lra.
      assert (F c <= 0). { unfold F. replace (held (1 / 2) 3 c) with (1 / 2); [unfold V2'; lra|]. unfold held. rewrite Rmin_left, Rmax_left; lra. } nra.
    - destruct (MVT_le U F 3 x L) as (c & Hc & E); [intros; apply DU|]. rewrite (UV 3) in E by lra.
      assert (0 <= F c). { unfold F. replace (held (1 / 2) 3 c) with 3; [unfold V2'; lra|]. unfold held. rewrite Rmin_right, Rmax_right; lra. } nra. }
  assert (KL : forall x, K x < 1 -> -2 < x < 2).
  { intros x Hx. split; apply Rnot_le_lt; intros L.
    - destruct (MVT_le K G x (-2) L) as (c & Hc & E); [intros; apply DK|]. rewrite (KV (-2)) in E by lra.
      assert (G c <= 0). { unfold G. replace (held (-2) 2 c) with (-2); [lra|]. unfold held. rewrite Rmin_left, Rmax_left; lra. } nra.
    - destruct (MVT_le K G 2 x L) as (c & Hc & E); [intros; apply DK|]. rewrite (KV 2) in E by lra.
      assert (0 <= G c). { unfold G. replace (held (-2) 2 c) with 2; [lra|]. unfold held. rewrite Rmin_right, Rmax_right; lra. } nra. }
  assert (U0 : forall x, 1 <= U x).
  { intros x. destruct (Rle_or_lt (U x) (V2 2)) as [L|L]; [|lra]. pose proof (UL x ltac:(lra)) as Hx. rewrite UV by lra.
    destruct (Req_dec x 1) as [->|Ne]; [rewrite Sh3; lra|left; apply Sh4; lra]. }
  assert (KN : forall x, 0 <= K x).
  { intros x. destruct (Rlt_or_le (K x) 1) as [L|L]; [|lra]. rewrite KV by (pose proof (KL x L); lra). pose proof (pow2_ge_0 x). lra. }
  set (f := fun (y : nat -> R) (i : nat) => match i with O => 2 * G (y 1%nat) | _ => - 2 * F (y 0%nat) end).
  destruct (peano 2 f 6280 (fun i => match i with O => 2 | _ => 0 end)) as (y & Y0 & DY).
  { intros x i Hi. destruct i as [|i]; cbn [f].
    - unfold f, G. pose proof (held_in (-2) 2 (x 1%nat) ltac:(lra)). apply Rabs_le. lra.
    - unfold f. assert (B : Rabs (F (x 0%nat)) <= 3136); [|rewrite Rabs_mult, (Rabs_left (-2)) by lra; lra].
      unfold F. pose proof (held_in (1 / 2) 3 (x 0%nat) ltac:(lra)) as H. pose proof (V2'_lip (held (1 / 2) 3 (x 0%nat)) 1 ltac:(lra) ltac:(lra)) as Q.
      replace (V2' 1) with 0 in Q by (unfold V2'; field). rewrite Rminus_0_r in Q. eapply Rle_trans; [exact Q|].
      assert (Rabs (held (1 / 2) 3 (x 0%nat) - 1) <= 2); [apply Rabs_le; lra|lra]. }
  { intros x e He. exists (e / 3137). split; [apply Rdiv_lt_0_compat; lra|]. intros z Hz i Hi. pose proof (Hz 0%nat ltac:(lia)) as Z0. pose proof (Hz 1%nat ltac:(lia)) as Z1.
    assert (E : 3137 * (e / 3137) = e) by field. destruct i as [|i]; cbn [f].
    - replace (2 * G (z 1%nat) - 2 * G (x 1%nat)) with (2 * (G (z 1%nat) - G (x 1%nat))) by ring. rewrite Rabs_mult, (Rabs_pos_eq 2) by lra. specialize (LG (z 1%nat) (x 1%nat)). lra.
    - replace (-2 * F (z 0%nat) - -2 * F (x 0%nat)) with (- (2 * (F (z 0%nat) - F (x 0%nat)))) by ring. rewrite Rabs_Ropp, Rabs_mult, (Rabs_pos_eq 2) by lra. specialize (LF (z 0%nat) (x 0%nat)). lra. }
  exists (fun t => y t 0%nat), (fun t => y t 1%nat). split; [apply Y0; lia|]. split; [apply Y0; lia|]. intros t Ht.
  assert (E : K (y t 1%nat) + U (y t 0%nat) = V2 2).
  { transitivity (K (y 0 1%nat) + U (y 0 0%nat)).
    - destruct (MVT_le (fun s => K (y s 1%nat) + U (y s 0%nat)) (fun _ => 0) 0 t Ht) as (c & _ & E); [|lra]. intros s Hs.
      pose proof (D_comp K (fun s => y s 1%nat) s _ _ (DK _) (DY s 1%nat ltac:(lra) ltac:(lia))) as A1. pose proof (D_comp U (fun s => y s 0%nat) s _ _ (DU _) (DY s 0%nat ltac:(lra) ltac:(lia))) as A2.
      eapply D_eq; [exact (D_plus _ _ _ _ _ A1 A2)|]. unfold f. ring.
    - rewrite (Y0 0%nat), (Y0 1%nat), K0, UV by (lia || lra). ring. }
  pose proof (KN (y t 1%nat)) as Kn. pose proof (U0 (y t 0%nat)) as Un. pose proof (UL (y t 0%nat) ltac:(lra)) as D. pose proof (KL (y t 1%nat) ltac:(lra)) as W.
  pose proof (DY t 0%nat Ht ltac:(lia)) as D0. pose proof (DY t 1%nat Ht ltac:(lia)) as D1. unfold f, F, G in D0, D1. rewrite held_is in D0, D1 by lra.
  split; [split; [eapply D_eq; [exact D0|field]|exact D1]|]. rewrite UV in E, Un by lra. rewrite KV in E by lra. split.
  - split; [lra|]. apply Rnot_lt_le. intros L. specialize (Sh2 2 (y t 0%nat) ltac:(lra)). pose proof (pow2_ge_0 (y t 1%nat)). lra.
  - apply Rabs_def1; nra.
Qed.

Lemma D_near (f : R -> R) t l e : is_derive f t l -> 0 < e -> exists h, 0 < h /\ forall s, Rabs (s - t) < h -> Rabs (f s - f t) < e.
Proof.
  intros D He. assert (C : continuity_pt f t) by (apply continuity_pt_filterlim, (ex_derive_continuous f); now exists l). destruct (C e He) as (h & Hh & P).
  exists h. split; [exact Hh|]. intros s Hs. destruct (Req_dec s t) as [->|Ne]; [rewrite Rminus_eq_0, Rabs_R0; exact He|]. apply (P s). split; [split; [exact I|congruence]|exact Hs].
Qed.
Lemma no_slope (f : R -> R) t l a b : is_derive f t l -> a < t < b -> (forall s, a <= s <= b -> f t <= f s) -> l = 0.
Proof.
  intros D Ht M. apply is_derive_Reals in D. apply NNPP. intros Ne. destruct (D (Rabs l) ltac:(now apply Rabs_pos_lt)) as [h Hh]. pose proof (cond_pos h) as Ph.
  set (k := Rmin (h / 2) (Rmin (t - a) (b - t))). assert (Hk : 0 < k) by (unfold k; repeat apply Rmin_glb_lt; lra).
  assert (K1 : k <= h / 2) by apply Rmin_l. assert (K2 : k <= t - a) by (unfold k; eapply Rle_trans; [apply Rmin_r|apply Rmin_l]). assert (K3 : k <= b - t) by (unfold k; eapply Rle_trans; [apply Rmin_r|apply Rmin_r]).
  destruct (Rtotal_order l 0) as [L|[L|L]]; [|contradiction|].
  - specialize (Hh k ltac:(lra) ltac:(rewrite Rabs_pos_eq; lra)). specialize (M (t + k) ltac:(lra)). rewrite (Rabs_left l) in Hh by lra. apply Rabs_lt_between in Hh.
    assert (0 <= (f (t + k) - f t) / k) by (apply Rdiv_le_0_compat; lra). lra.
  - specialize (Hh (- k) ltac:(lra) ltac:(rewrite Rabs_left; lra)). specialize (M (t + - k) ltac:(lra)). rewrite (Rabs_pos_eq l) in Hh by lra. apply Rabs_lt_between in Hh.
    assert (0 <= (f (t + - k) - f t) / k) by (apply Rdiv_le_0_compat; lra).
    replace ((f (t + - k) - f t) / - k) with (- ((f (t + - k) - f t) / k)) in Hh by (field; lra). lra.
Qed.

(* ---- the turn and the period ---- *)
Section Swing.
Variables d w : R -> R.
Hypothesis D0 : d 0 = 2.
Hypothesis W0 : w 0 = 0.
Hypothesis S : forall t, 0 <= t -> swinging d w t /\ 1 / 2 < d t <= 2 /\ Rabs (w t) < 1.6.
Lemma rate_d t : 0 <= t -> is_derive d t (w t). Proof. intros Ht. now apply S. Qed.
Lemma rate_w t : 0 <= t -> is_derive w t (- 2 * V2' (d t)). Proof. intros Ht. now apply S. Qed.
Lemma inside_one : exists t, 0 <= t /\ d t < 1.
Proof.
  apply NNPP. intros No. assert (G : forall t, 0 <= t -> 1 <= d t) by (intros t Ht; apply Rnot_lt_le; intros L; apply No; now exists t).
  assert (F : forall t, 0 <= t -> 0 <= V2' (d t)).
  { intros t Ht. specialize (G t Ht). destruct (Req_dec (d t) 1) as [E|E]; [rewrite E; unfold V2'; lra|left; apply V2'_above; lra]. }
  assert (M : forall s t, 0 <= s <= t -> w t <= w s).
  { intros s t H. apply (decreasing w (fun t => - 2 * V2' (d t)) s t); [lra|intros; apply rate_w; lra|]. intros x Hx. cbv beta. specialize (F x ltac:(lra)). lra. }
  destruct (Rle_or_lt 0 (w 1)) as [L|L].
  - assert (Z : forall t, 0 <= t <= 1 -> w t = 0) by (intros t Ht; pose proof (M 0 t ltac:(lra)); pose proof (M t 1 ltac:(lra)); lra).
    assert (D2 : forall t, 0 <= t <= 1 -> d t = 2).
    { intros t Ht. destruct (MVT_le d w 0 t) as (c & Hc & E); [lra|intros; apply rate_d; lra|]. rewrite (Z c) in E by lra. lra. }
    destruct (MVT_le w (fun t => - 2 * V2' (d t)) 0 1) as (c & Hc & E); [lra|intros; apply rate_w; lra|]. cbv beta in E. rewrite (D2 c), (Z 1), (Z 0) in E by lra.
    pose proof (V2'_above 2 ltac:(lra)). lra.
  - set (t := 1 + 2 / - w 1). assert (Ht : 1 < t) by (unfold t; assert (0 < 2 / - w 1) by (apply Rdiv_lt_0_compat; lra); lra).
    destruct (MVT_le d w 1 t) as (c & Hc & E); [lra|intros; apply rate_d; lra|]. pose proof (M 1 c ltac:(lra)) as Mc. pose proof (G t ltac:(lra)). pose proof (S 1 ltac:(lra)) as (_ & S1 & _).
    assert (w c * (t - 1) <= -2). { apply Rle_trans with (w 1 * (t - 1)); [apply Rmult_le_compat_r; lra|]. unfold t. right. field. lra. } lra.
Qed.
Lemma turns : exists t, 0 < t /\ w t = 0 /\ d t < 1.
Proof.
  destruct inside_one as (a & Ha & La).
  assert (Back : exists b, a < b /\ d a < d b).
  { apply NNPP. intros No. assert (G : forall t, a < t -> d t <= d a) by (intros t Ht; apply Rnot_lt_le; intros L; apply No; now exists t).
    set (k := 4 * (1 - d a)). assert (Hk : 0 < k) by (unfold k; lra). set (b := a + 4 / k). assert (Hb : 0 < 4 / k) by (apply Rdiv_lt_0_compat; lra).
    destruct (MVT_le w (fun t => - 2 * V2' (d t)) a b) as (c & Hc & E); [unfold b; lra|intros; apply rate_w; lra|]. cbv beta in E.
    pose proof (S c ltac:(lra)) as (_ & Dc & _). assert (Gc : d c <= d a) by (destruct (Req_dec c a) as [->|Ne]; [lra|apply G; lra]).
    pose proof (V2'_below (d c) (d a) ltac:(lra) Gc La) as Q. assert (k <= - 2 * V2' (d c)) by (unfold k; lra).
    assert (4 <= w b - w a). { rewrite E. apply Rle_trans with (k * (b - a)); [unfold b; right; field; lra|apply Rmult_le_compat_r; [unfold b; lra|assumption]]. }
    pose proof (S a ltac:(lra)) as (_ & _ & Wa). pose proof (S b ltac:(unfold b; lra)) as (_ & _ & Wb). apply Rabs_lt_between in Wa, Wb. lra. }
  destruct Back as (b & Hb & Lb).
  destruct (continuity_ab_min d 0 b ltac:(lra)) as (m & Mn & Hm).
  { intros c Hc. apply continuity_pt_filterlim, (ex_derive_continuous d). eexists. apply rate_d. lra. }
  pose proof (Mn a ltac:(lra)) as Ma. assert (m <> 0) by (intros ->; lra). assert (m <> b) by (intros ->; lra).
  exists m. split; [lra|]. split; [|lra]. apply (no_slope d m (w m) 0 b); [apply rate_d; lra|lra|exact Mn].
Qed.
Lemma period : exists P s, 0 < s < P /\ (forall t, 0 <= t -> d (t + P) = d t) /\ d s < 1.
Proof.
  destruct turns as (m & Hm & Wm & Dm). exists (2 * m), m. split; [lra|]. split; [|exact Dm].
  assert (Sh : forall (f : R -> R) c t l, is_derive f (t + c) l -> is_derive (fun s => f (s + c)) t l).
  { intros f c t l D. eapply D_eq; [apply (D_comp f (fun s => s + c) t l (1 + 0)); [exact D|apply (D_plus (fun s => s) (fun _ => c)); [apply D_id|apply D_const]]|ring]. }
  assert (Bk : forall (f : R -> R) t l, is_derive f (m - t) l -> is_derive (fun s => f (m - s)) t (- l)).
  { intros f t l D. eapply D_eq; [apply (D_comp f (fun s => m - s) t l (0 - 1)); [exact D|apply (D_minus (fun _ => m) (fun s => s)); [apply D_const|apply D_id]]|ring]. }
  assert (E : d (m + m) = d (m - m) /\ w (m + m) = - w (m - m)).
  { apply (same_swing m (fun t => d (t + m)) (fun t => w (t + m)) (fun t => d (m - t)) (fun t => - w (m - t))); [lra| | |f_equal; ring|].
    - intros t Ht. pose proof (S (t + m) ltac:(lra)) as ([A1 A2] & B & _). split; [split; now apply Sh|lra].
    - intros t Ht. pose proof (S (m - t) ltac:(lra)) as ([A1 A2] & B & _). split; [split|lra]; [now apply Bk|].
      eapply D_eq; [apply D_opp, Bk, A2|ring].
    - rewrite Rplus_0_l, Rminus_0_r, Wm. ring. }
  rewrite Rminus_eq_0, D0, W0 in E. destruct E as [E1 E2]. intros t Ht.
  apply (same_swing t (fun s => d (s + 2 * m)) (fun s => w (s + 2 * m)) d w Ht).
  - intros s Hs. pose proof (S (s + 2 * m) ltac:(lra)) as ([A1 A2] & B & _). split; [split; now apply Sh|lra].
  - intros s Hs. pose proof (S s ltac:(lra)) as (A & B & _). split; [exact A|lra].
  - rewrite Rplus_0_l, D0. replace (2 * m) with (m + m) by ring. exact E1.
  - rewrite Rplus_0_l, W0. replace (2 * m) with (m + m) by ring. rewrite E2. ring.
Qed.
End Swing.

(* ---- two linked agents under (1), (2), (4), (5) ---- *)
Definition heading (z : C) : R := arctan2 (snd z) (fst z).
Definition steers (r v : nat -> R -> C) (t : R) := r 0%nat t <> r 1%nat t /\ forall i, (i < 2)%nat -> v i t <> 0%C /\ is_velocity (r i) t (v i t) /\
  is_velocity (v i) t (accel 2 complete (fun _ _ => V2') (fun j => r j t) (fun j => v j t) (fun j => heading (v j t)) i).
Definition set_off (r v : nat -> R -> C) := r 0%nat 0 = (0, 0) /\ r 1%nat 0 = (2, 0) /\ v 0%nat 0 = (2, 0) /\ v 1%nat 0 = (2, 0).
Definition pull_rate (r : nat -> C) := V2' (norm (r 0%nat - r 1%nat)%C) / norm (r 0%nat - r 1%nat)%C.
Definition turn_rate (r v : nat -> C) := (heading (v 0%nat) - heading (v 1%nat)) / norm (r 0%nat - r 1%nat)%C ^ 2.
Lemma accel_first r v : accel 2 complete (fun _ _ => V2') r v (fun j => heading (v j)) 0 =
  (- (pull_rate r * (fst (r 0%nat) - fst (r 1%nat))) + turn_rate r v * snd (v 0%nat), - (pull_rate r * (snd (r 0%nat) - snd (r 1%nat))) - turn_rate r v * fst (v 0%nat)).
Proof.
  unfold accel, gyro, align, grad_i, pair_grad, grad, pull_rate, turn_rate, Csum. cbn [Sum]. unfold w, complete. cbn [Nat.eqb negb].
  set (N := norm (r 0%nat - r 1%nat)%C). set (k := V2' N / N). set (q := (heading (v 0%nat) - heading (v 1%nat)) / N ^ 2). apply injective_projections; cbn; ring.
Qed.
Lemma accel_second r v : accel 2 complete (fun _ _ => V2') r v (fun j => heading (v j)) 1 =
  (- (pull_rate r * (fst (r 1%nat) - fst (r 0%nat))) - turn_rate r v * snd (v 1%nat), - (pull_rate r * (snd (r 1%nat) - snd (r 0%nat))) + turn_rate r v * fst (v 1%nat)).
Proof.
  unfold accel, gyro, align, grad_i, pair_grad, grad, pull_rate, turn_rate, Csum. cbn [Sum]. unfold w, complete. cbn [Nat.eqb negb].
  rewrite !(norm_sym (r 1%nat) (r 0%nat)). set (N := norm (r 0%nat - r 1%nat)%C). set (k := V2' N / N).
  replace ((heading (v 1%nat) - heading (v 0%nat)) / N ^ 2) with (- ((heading (v 0%nat) - heading (v 1%nat)) / N ^ 2)) by (unfold Rdiv; ring).
  set (q := (heading (v 0%nat) - heading (v 1%nat)) / N ^ 2). apply injective_projections; cbn; ring.
Qed.
Lemma heading_forward z : 0 < fst z -> heading z = atan (snd z / fst z).
Proof. intros H. now apply arctan2_formulas. Qed.
Lemma atan_le x : Rabs (atan x) <= Rabs x.
Proof.
  assert (Q : forall x, 0 <= x -> 0 <= atan x <= x).
  { intros y Hy. destruct (MVT_le atan (fun s => / (1 + s ^ 2)) 0 y Hy) as (c & Hc & E); [intros t _; eapply D_eq; [apply is_derive_atan|unfold Rsqr; f_equal; ring]|]. rewrite atan_0 in E.
    assert (P : 0 < / (1 + c ^ 2) <= 1); [|nra]. pose proof (pow2_ge_0 c). split; [apply Rinv_0_lt_compat; lra|]. rewrite <- Rinv_1. apply Rinv_le_contravar; lra. }
  destruct (Rle_or_lt 0 x) as [L|L]; [specialize (Q x L); rewrite !Rabs_pos_eq; lra|]. specialize (Q (- x) ltac:(lra)). rewrite atan_opp in Q. rewrite !Rabs_left1 by lra. lra.
Qed.
Lemma apart_bounds x y : / 4 <= x -> Rabs (V2' x / x) <= 544 /\ Rabs (y / x ^ 2) <= 16 * Rabs y.
Proof.
  intros Hx. set (u := / x). assert (U : 0 < u <= 4). { unfold u. split; [apply Rinv_0_lt_compat; lra|]. replace 4 with (/ (/ 4)) by field. apply Rinv_le_contravar; lra. }
  assert (U2 : 0 < u ^ 2 <= 16) by nra. split.
  - replace (V2' x / x) with (2 * u ^ 2 - 2 * (u ^ 2) ^ 2) by (unfold u, V2'; field; lra). apply Rabs_le. nra.
  - replace (y / x ^ 2) with (u ^ 2 * y) by (unfold u; field; lra). rewrite Rabs_mult, (Rabs_pos_eq (u ^ 2)) by lra. apply Rmult_le_compat_r; [apply Rabs_pos|lra].
Qed.
Lemma four_squares a b c e : (Rabs a + Rabs b + Rabs c + Rabs e) ^ 2 <= 4 * (a ^ 2 + b ^ 2 + c ^ 2 + e ^ 2).
Proof.
  rewrite <- (pow2_abs a), <- (pow2_abs b), <- (pow2_abs c), <- (pow2_abs e). set (p := Rabs a). set (q := Rabs b). set (r := Rabs c). set (s := Rabs e).
  pose proof (pow2_ge_0 (p - q)). pose proof (pow2_ge_0 (p - r)). pose proof (pow2_ge_0 (p - s)). pose proof (pow2_ge_0 (q - r)). pose proof (pow2_ge_0 (q - s)). pose proof (pow2_ge_0 (r - s)). nra.
Qed.

(* the swing as a motion of the two agents *)
Definition swing_place (d : R -> R) (i : nat) (t : R) : C := match i with O => (2 * t + 1 - / 2 * d t, 0) | _ => (2 * t + 1 + / 2 * d t, 0) end.
Definition swing_speed (w : R -> R) (i : nat) (t : R) : C := match i with O => (2 - / 2 * w t, 0) | _ => (2 + / 2 * w t, 0) end.
Section Motion.
Variables d w : R -> R.
Hypothesis D0 : d 0 = 2.
Hypothesis W0 : w 0 = 0.
Hypothesis S : forall t, 0 <= t -> swinging d w t /\ 1 / 2 < d t <= 2 /\ Rabs (w t) < 1.6.
Notation X := (swing_place d).
Notation W := (swing_speed w).
Lemma swing_norm t : 0 <= t -> norm (X 0%nat t - X 1%nat t)%C = d t.
Proof.
  intros Ht. pose proof (S t Ht) as (_ & B & _). replace (X 0%nat t - X 1%nat t)%C with (RtoC (- d t)) by (apply injective_projections; cbn; field).
  unfold norm. rewrite Cmod_R, Rabs_left; lra.
Qed.
Lemma swing_forward t i : 0 <= t -> 1.2 < fst (W i t) < 2.8 /\ snd (W i t) = 0.
Proof. intros Ht. pose proof (S t Ht) as (_ & _ & B). apply Rabs_lt_between in B. destruct i; cbn; lra. Qed.
Lemma swing_heading t i : 0 <= t -> heading (W i t) = 0.
Proof. intros Ht. destruct (swing_forward t i Ht) as [A B]. rewrite heading_forward by lra. rewrite B. unfold Rdiv. rewrite Rmult_0_l. apply atan_0. Qed.
Lemma swing_starts : set_off X W.
Proof. repeat split; apply injective_projections; cbn; rewrite ?D0, ?W0; try field; ring. Qed.
Lemma swing_rates t : 0 <= t -> is_derive (fun s => fst (X 0%nat s)) t (fst (W 0%nat t)) /\ is_derive (fun s => fst (X 1%nat s)) t (fst (W 1%nat t)) /\
  is_derive (fun s => fst (W 0%nat s)) t (V2' (d t)) /\ is_derive (fun s => fst (W 1%nat s)) t (- V2' (d t)).
Proof.
  intros Ht. pose proof (S t Ht) as ([A B] & _). cbn. split; [|split; [|split]].
  - eapply D_eq; [apply (D_minus (fun s => 2 * s + 1) (fun s => / 2 * d s)); [apply (D_plus (fun s => 2 * s) (fun _ => 1)); [apply (D_scal 2 (fun s => s)), D_id|apply D_const]|apply (D_scal (/ 2) d), A]|field].
  - eapply D_eq; [apply (D_plus (fun s => 2 * s + 1) (fun s => / 2 * d s)); [apply (D_plus (fun s => 2 * s) (fun _ => 1)); [apply (D_scal 2 (fun s => s)), D_id|apply D_const]|apply (D_scal (/ 2) d), A]|field].
  - eapply D_eq; [apply (D_minus (fun _ => 2) (fun s => / 2 * w s)); [apply D_const|apply (D_scal (/ 2) w), B]|field].
  - eapply D_eq; [apply (D_plus (fun _ => 2) (fun s => / 2 * w s)); [apply D_const|apply (D_scal (/ 2) w), B]|field].
Qed.
Lemma swing_pull t : 0 <= t -> pull_rate (fun j => X j t) = V2' (d t) / d t.
Proof. intros Ht. unfold pull_rate. now rewrite swing_norm. Qed.
Lemma swing_steers t : 0 <= t -> steers X W t.
Proof.
  intros Ht. pose proof (S t Ht) as (_ & Bd & _). destruct (swing_rates t Ht) as (R0 & R1 & R2 & R3). split.
  - intros E. apply (f_equal fst) in E. cbn in E. lra.
  - assert (T : turn_rate (fun j => X j t) (fun j => W j t) = 0) by (unfold turn_rate; rewrite !swing_heading by exact Ht; unfold Rdiv; ring).
    assert (Zx : forall i, is_derive (fun s => snd (X i s)) t 0) by (intros [|i]; cbn; apply D_const). assert (Zw : forall i, is_derive (fun s => snd (W i s)) t 0) by (intros [|i]; cbn; apply D_const).
    intros i Hi. split; [intros E; destruct (swing_forward t i Ht); rewrite E in *; cbn in *; lra|]. split.
    + split; [destruct i as [|[|i]]; [exact R0|exact R1|lia]|]. eapply D_eq; [apply Zx|]. symmetry. now apply swing_forward.
    + destruct i as [|[|i]]; [| |lia].
      * rewrite (accel_first (fun j => X j t) (fun j => W j t)), T, (swing_pull t Ht). split; cbn [fst snd]; (eapply D_eq; [first [exact R2|apply Zw]|]); cbn; field; lra.
      * rewrite (accel_second (fun j => X j t) (fun j => W j t)), T, (swing_pull t Ht). split; cbn [fst snd]; (eapply D_eq; [first [exact R3|apply Zw]|]); cbn; field; lra.
Qed.

(* there is no other motion: on the line first, then the same places and velocities *)
Section Other.
Variables (T : R) (r v : nat -> R -> C).
Hypothesis Off : set_off r v.
Hypothesis St : forall t, 0 <= t < T -> steers r v t.
Definition agree t := r 0%nat t = X 0%nat t /\ r 1%nat t = X 1%nat t /\ v 0%nat t = W 0%nat t /\ v 1%nat t = W 1%nat t.
Definition close_by t := 1 / 4 < fst (r 1%nat t) - fst (r 0%nat t) /\ 1 < fst (v 0%nat t) < 3 /\ 1 < fst (v 1%nat t) < 3.
Lemma stays_close m : 0 <= m < T -> agree m -> exists h, 0 < h /\ m + h < T /\ forall t, m <= t <= m + h -> close_by t.
Proof.
  intros Hm (E0 & E1 & E2 & E3). destruct (St m Hm) as [_ Q]. destruct (Q 0%nat ltac:(lia)) as (_ & [R0 _] & [V0 _]). destruct (Q 1%nat ltac:(lia)) as (_ & [R1 _] & [V1 _]).
  pose proof (S m ltac:(lra)) as (_ & B & _). pose proof (swing_forward m 0%nat ltac:(lra)) as [F0 _]. pose proof (swing_forward m 1%nat ltac:(lra)) as [F1 _].
  destruct (D_near (fun s => fst (r 0%nat s)) m _ (1 / 8) R0 ltac:(lra)) as (h0 & H0 & P0). destruct (D_near (fun s => fst (r 1%nat s)) m _ (1 / 8) R1 ltac:(lra)) as (h1 & H1 & P1).
  destruct (D_near (fun s => fst (v 0%nat s)) m _ (1 / 8) V0 ltac:(lra)) as (h2 & H2 & P2). destruct (D_near (fun s => fst (v 1%nat s)) m _ (1 / 8) V1 ltac:(lra)) as (h3 & H3 & P3).
  set (h := Rmin (Rmin h0 h1) (Rmin (Rmin h2 h3) (T - m))). assert (Hh : 0 < h) by (unfold h; repeat apply Rmin_glb_lt; lra).
  assert (L : h <= h0 /\ h <= h1 /\ h <= h2 /\ h <= h3 /\ h <= T - m).
  { unfold h. pose proof (Rmin_l (Rmin h0 h1) (Rmin (Rmin h2 h3) (T - m))). pose proof (Rmin_r (Rmin h0 h1) (Rmin (Rmin h2 h3) (T - m))). pose proof (Rmin_l h0 h1). pose proof (Rmin_r h0 h1).
    pose proof (Rmin_l (Rmin h2 h3) (T - m)). pose proof (Rmin_r (Rmin h2 h3) (T - m)). pose proof (Rmin_l h2 h3). pose proof (Rmin_r h2 h3). lra. }
  exists (h / 2). split; [lra|]. split; [lra|]. intros t Ht. assert (A : Rabs (t - m) < h) by (rewrite Rabs_pos_eq; lra).
  specialize (P0 t ltac:(lra)). specialize (P1 t ltac:(lra)). specialize (P2 t ltac:(lra)). specialize (P3 t ltac:(lra)). rewrite E0 in P0. rewrite E1 in P1. rewrite E2 in P2. rewrite E3 in P3.
  apply Rabs_lt_between in P0, P1, P2, P3. unfold close_by. cbn in *. lra.
Qed.
Lemma wide t : close_by t -> / 4 <= norm (r 0%nat t - r 1%nat t)%C.
Proof.
  intros (A & _). unfold norm. eapply Rle_trans; [|apply (Rmax_Cmod (r 0%nat t - r 1%nat t)%C)]. eapply Rle_trans; [|apply Rmax_l]. cbn.
  rewrite Rabs_left by lra. lra.
Qed.
Lemma heading_small z : 1 < fst z -> Rabs (heading z) <= Rabs (snd z).
Proof.
  intros H. rewrite heading_forward by lra. eapply Rle_trans; [apply atan_le|]. unfold Rdiv. rewrite Rabs_mult, (Rabs_pos_eq (/ _)) by (left; apply Rinv_0_lt_compat; lra).
  rewrite <- (Rmult_1_r (Rabs (snd z))) at 2. apply Rmult_le_compat_l; [apply Rabs_pos|]. rewrite <- Rinv_1. apply Rinv_le_contravar; lra.
Qed.
Lemma on_line m h : 0 <= m -> 0 < h -> m + h < T -> agree m -> (forall t, m <= t <= m + h -> close_by t) ->
  forall t i, m <= t <= m + h -> (i < 2)%nat -> snd (r i t) = 0 /\ snd (v i t) = 0.
Proof.
  intros Hm Hh HT (E0 & E1 & E2 & E3) C t i Ht Hi.
  set (Q := fun s => (snd (r 0%nat s) ^ 2 + snd (r 1%nat s) ^ 2) + (snd (v 0%nat s) ^ 2 + snd (v 1%nat s) ^ 2)).
  set (a0 := fun s => snd (accel 2 complete (fun _ _ => V2') (fun j => r j s) (fun j => v j s) (fun j => heading (v j s)) 0)).
  set (a1 := fun s => snd (accel 2 complete (fun _ _ => V2') (fun j => r j s) (fun j => v j s) (fun j => heading (v j s)) 1)).
  assert (Z : Q t = 0).
  { apply (zero_by_growth Q (fun s => (2 * snd (r 0%nat s) * snd (v 0%nat s) + 2 * snd (r 1%nat s) * snd (v 1%nat s)) + (2 * snd (v 0%nat s) * a0 s + 2 * snd (v 1%nat s) * a1 s)) 9616 m t); [lra| | | |].
    - intros s Hs. destruct (St s ltac:(lra)) as [_ G]. destruct (G 0%nat ltac:(lia)) as (_ & [_ R0] & [_ V0]). destruct (G 1%nat ltac:(lia)) as (_ & [_ R1] & [_ V1]). unfold Q.
      apply (D_plus (fun s => snd (r 0%nat s) ^ 2 + snd (r 1%nat s) ^ 2) (fun s => snd (v 0%nat s) ^ 2 + snd (v 1%nat s) ^ 2)).
      + apply (D_plus (fun s => snd (r 0%nat s) ^ 2) (fun s => snd (r 1%nat s) ^ 2)); [now apply (D_sqr (fun s => snd (r 0%nat s)))|now apply (D_sqr (fun s => snd (r 1%nat s)))].
      + apply (D_plus (fun s => snd (v 0%nat s) ^ 2) (fun s => snd (v 1%nat s) ^ 2)); [now apply (D_sqr (fun s => snd (v 0%nat s)))|now apply (D_sqr (fun s => snd (v 1%nat s)))].
    - intros s Hs. specialize (C s ltac:(lra)). pose proof (wide s C) as Wd. destruct C as (C1 & C2 & C3).
      destruct (apart_bounds (norm (r 0%nat s - r 1%nat s)%C) (heading (v 0%nat s) - heading (v 1%nat s)) Wd) as [B1 B2].
      fold (pull_rate (fun j => r j s)) in B1. fold (turn_rate (fun j => r j s) (fun j => v j s)) in B2. set (p := pull_rate (fun j => r j s)) in *. set (q := turn_rate (fun j => r j s) (fun j => v j s)) in *.
      pose proof (heading_small (v 0%nat s) ltac:(lra)) as H0. pose proof (heading_small (v 1%nat s) ltac:(lra)) as H1.
      set (x := snd (r 0%nat s)). set (y := snd (r 1%nat s)). set (a := snd (v 0%nat s)) in *. set (b := snd (v 1%nat s)) in *. set (M := Rabs x + Rabs y + Rabs a + Rabs b).
      assert (Bq : Rabs q <= 16 * (Rabs a + Rabs b)).
      { eapply Rle_trans; [exact B2|]. apply Rmult_le_compat_l; [lra|]. unfold Rminus. eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_Ropp. lra. }
      pose proof (Rabs_pos x) as X0. pose proof (Rabs_pos y) as Y0. pose proof (Rabs_pos a) as A0. pose proof (Rabs_pos b) as B0.
      assert (Bp : forall u, Rabs u <= Rabs x + Rabs y -> Rabs (p * u) <= 544 * (Rabs x + Rabs y)).
      { intros u Hu. rewrite Rabs_mult. apply Rmult_le_compat; try apply Rabs_pos; assumption. }
      assert (Bv : forall u, 1 < u < 3 -> Rabs (q * u) <= 48 * (Rabs a + Rabs b)).
      { intros u Hu. rewrite Rabs_mult, (Rabs_pos_eq u) by lra. apply Rle_trans with (16 * (Rabs a + Rabs b) * 3); [apply Rmult_le_compat; try apply Rabs_pos; lra|lra]. }
      assert (Bxy : Rabs (x - y) <= Rabs x + Rabs y /\ Rabs (y - x) <= Rabs x + Rabs y).
      { unfold Rminus. split; (eapply Rle_trans; [apply Rabs_triang|]); rewrite Rabs_Ropp; lra. }
      assert (G0 : Rabs (a0 s) <= 600 * M).
      { unfold a0. rewrite (accel_first (fun j => r j s) (fun j => v j s)). cbn [snd]. fold p q x y. pose proof (Bp (x - y) ltac:(lra)). pose proof (Bv (fst (v 0%nat s)) ltac:(lra)).
        unfold Rminus at 1. eapply Rle_trans; [apply Rabs_triang|]. rewrite !Rabs_Ropp. unfold M. lra. }
      assert (G1 : Rabs (a1 s) <= 600 * M).
      { unfold a1. rewrite (accel_second (fun j => r j s) (fun j => v j s)). cbn [snd]. fold p q x y. pose proof (Bp (y - x) ltac:(lra)). pose proof (Bv (fst (v 1%nat s)) ltac:(lra)).
        eapply Rle_trans; [apply Rabs_triang|]. rewrite !Rabs_Ropp. unfold M. lra. }
      assert (M0 : 0 <= M) by (unfold M; lra).
      assert (Pr : forall u z k, Rabs u <= M -> Rabs z <= k * M -> 0 <= k -> 2 * u * z <= 2 * k * M ^ 2).
      { intros u z k Hu Hz Hk. assert (u * z <= M * (k * M)); [|nra]. eapply Rle_trans; [apply Rle_abs|]. rewrite Rabs_mult. apply Rmult_le_compat; try apply Rabs_pos; assumption. }
      pose proof (Pr x a 1 ltac:(unfold M; lra) ltac:(unfold M; lra) ltac:(lra)). pose proof (Pr y b 1 ltac:(unfold M; lra) ltac:(unfold M; lra) ltac:(lra)).
      pose proof (Pr a (a0 s) 600 ltac:(unfold M; lra) G0 ltac:(lra)). pose proof (Pr b (a1 s) 600 ltac:(unfold M; lra) G1 ltac:(lra)).
      pose proof (four_squares x y a b) as F4. fold M in F4. unfold Q. fold x y a b. lra.
    - unfold Q. rewrite E0, E1, E2, E3. cbn. ring.
    - unfold Q. repeat apply Rplus_le_le_0_compat; apply pow2_ge_0. }
  unfold Q in Z. pose proof (pow2_ge_0 (snd (r 0%nat t))). pose proof (pow2_ge_0 (snd (r 1%nat t))). pose proof (pow2_ge_0 (snd (v 0%nat t))). pose proof (pow2_ge_0 (snd (v 1%nat t))).
  destruct i as [|[|i]]; [| |lia]; split; apply Rsqr_0_uniq; unfold Rsqr; nra.
Qed.
Lemma agree_on m h : 0 <= m -> 0 < h -> m + h < T -> agree m -> (forall t, m <= t <= m + h -> close_by t) -> forall t, m <= t <= m + h -> agree t.
Proof.
  intros Hm Hh HT A C t Ht. pose proof (on_line m h Hm Hh HT A C) as Line. destruct A as (E0 & E1 & E2 & E3).
  set (x := fun (i : nat) s => fst (r i s) - fst (X i s)). set (u := fun (i : nat) s => fst (v i s) - fst (W i s)).
  set (Q := fun s => (x 0%nat s ^ 2 + x 1%nat s ^ 2) + (u 0%nat s ^ 2 + u 1%nat s ^ 2)). set (k := fun s => V2' (fst (r 1%nat s) - fst (r 0%nat s)) - V2' (d s)).
  assert (Z : Q t = 0).
  { apply (zero_by_growth Q (fun s => (2 * x 0%nat s * u 0%nat s + 2 * x 1%nat s * u 1%nat s) + (2 * u 0%nat s * k s + 2 * u 1%nat s * - k s)) 25616 m t); [lra| | | |].
    - intros s Hs. destruct (St s ltac:(lra)) as [_ G]. destruct (G 0%nat ltac:(lia)) as (_ & [R0 _] & [V0 _]). destruct (G 1%nat ltac:(lia)) as (_ & [R1 _] & [V1 _]).
      destruct (swing_rates s ltac:(lra)) as (X0 & X1 & W0' & W1). specialize (C s ltac:(lra)). destruct C as (C1 & C2 & C3).
      pose proof (Line s 0%nat ltac:(lra) ltac:(lia)) as [L0 L2]. pose proof (Line s 1%nat ltac:(lra) ltac:(lia)) as [L1 L3].
      assert (Nm : norm (r 0%nat s - r 1%nat s)%C = fst (r 1%nat s) - fst (r 0%nat s)).
      { replace (r 0%nat s - r 1%nat s)%C with (RtoC (fst (r 0%nat s) - fst (r 1%nat s))) by (apply injective_projections; cbn; rewrite ?L0, ?L1; ring). unfold norm. rewrite Cmod_R, Rabs_left; lra. }
      rewrite (accel_first (fun j => r j s) (fun j => v j s)) in V0. rewrite (accel_second (fun j => r j s) (fun j => v j s)) in V1. cbn [fst] in V0, V1. rewrite L2 in V0. rewrite L3 in V1. unfold pull_rate in V0, V1. rewrite Nm in V0, V1.
      set (q := turn_rate _ _) in *. set (z := fst (r 1%nat s) - fst (r 0%nat s)) in *.
      assert (F0 : is_derive (fun s => fst (v 0%nat s)) s (V2' z)) by (eapply D_eq; [exact V0|]; replace (fst (r 0%nat s) - fst (r 1%nat s)) with (- z) by (unfold z; ring); field; lra).
      assert (F1 : is_derive (fun s => fst (v 1%nat s)) s (- V2' z)) by (eapply D_eq; [exact V1|]; fold z; field; lra).
      assert (U0 : is_derive (u 0%nat) s (k s)) by (unfold u, k; fold z; now apply D_minus).
      assert (U1 : is_derive (u 1%nat) s (- k s)) by (unfold u, k; fold z; eapply D_eq; [apply D_minus; [exact F1|exact W1]|ring]).
      unfold Q. apply (D_plus (fun s => x 0%nat s ^ 2 + x 1%nat s ^ 2) (fun s => u 0%nat s ^ 2 + u 1%nat s ^ 2)).
      + apply (D_plus (fun s => x 0%nat s ^ 2) (fun s => x 1%nat s ^ 2)); apply D_sqr; unfold x, u; now apply D_minus.
      + apply (D_plus (fun s => u 0%nat s ^ 2) (fun s => u 1%nat s ^ 2)); now apply D_sqr.
    - intros s Hs. specialize (C s ltac:(lra)). destruct C as (C1 & _). pose proof (S s ltac:(lra)) as (_ & Bd & _).
      pose proof (V2'_lip (fst (r 1%nat s) - fst (r 0%nat s)) (d s) ltac:(lra) ltac:(lra)) as L. fold (k s) in L.
      set (M := Rabs (x 0%nat s) + Rabs (x 1%nat s) + Rabs (u 0%nat s) + Rabs (u 1%nat s)). pose proof (Rabs_pos (x 0%nat s)). pose proof (Rabs_pos (x 1%nat s)). pose proof (Rabs_pos (u 0%nat s)). pose proof (Rabs_pos (u 1%nat s)).
      assert (Kb : Rabs (k s) <= 1600 * M).
      { eapply Rle_trans; [exact L|]. assert (Rabs (fst (r 1%nat s) - fst (r 0%nat s) - d s) <= M); [|unfold M in *; lra].
        replace (fst (r 1%nat s) - fst (r 0%nat s) - d s) with (x 1%nat s + - x 0%nat s) by (unfold x; cbn; field). eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_Ropp. unfold M. lra. }
      assert (M0 : 0 <= M) by (unfold M; lra).
      assert (Pr : forall u z k, Rabs u <= M -> Rabs z <= k * M -> 0 <= k -> 2 * u * z <= 2 * k * M ^ 2).
      { intros u' z k' Hu Hz Hk. assert (u' * z <= M * (k' * M)); [|nra]. eapply Rle_trans; [apply Rle_abs|]. rewrite Rabs_mult. apply Rmult_le_compat; try apply Rabs_pos; assumption. }
      pose proof (Pr (x 0%nat s) (u 0%nat s) 1 ltac:(unfold M; lra) ltac:(unfold M; lra) ltac:(lra)). pose proof (Pr (x 1%nat s) (u 1%nat s) 1 ltac:(unfold M; lra) ltac:(unfold M; lra) ltac:(lra)).
      pose proof (Pr (u 0%nat s) (k s) 1600 ltac:(unfold M; lra) Kb ltac:(lra)). pose proof (Pr (u 1%nat s) (- k s) 1600 ltac:(unfold M; lra) ltac:(rewrite Rabs_Ropp; exact Kb) ltac:(lra)).
      pose proof (four_squares (x 0%nat s) (x 1%nat s) (u 0%nat s) (u 1%nat s)) as F4. fold M in F4. unfold Q. lra.
    - unfold Q, x, u. rewrite E0, E1, E2, E3. ring.
    - unfold Q. repeat apply Rplus_le_le_0_compat; apply pow2_ge_0. }
  unfold Q in Z. pose proof (pow2_ge_0 (x 0%nat t)) as P0. pose proof (pow2_ge_0 (x 1%nat t)) as P1. pose proof (pow2_ge_0 (u 0%nat t)) as P2. pose proof (pow2_ge_0 (u 1%nat t)) as P3.
  pose proof (Line t 0%nat Ht ltac:(lia)) as [L0 L2]. pose proof (Line t 1%nat Ht ltac:(lia)) as [L1 L3].
  assert (Zr : forall z, z ^ 2 <= 0 -> z = 0) by (intros z Hz; apply Rsqr_0_uniq; unfold Rsqr; pose proof (pow2_ge_0 z); nra).
  pose proof (Zr (x 0%nat t) ltac:(lra)) as Q0. pose proof (Zr (x 1%nat t) ltac:(lra)) as Q1. pose proof (Zr (u 0%nat t) ltac:(lra)) as Q2. pose proof (Zr (u 1%nat t) ltac:(lra)) as Q3. unfold x, u in Q0, Q1, Q2, Q3.
  repeat split; apply injective_projections; try lra; cbn; assumption.
Qed.
Lemma no_other t : 0 <= t < T -> agree t.
Proof.
  intros Ht. set (Good := fun s => 0 <= s <= t /\ forall q, 0 <= q <= s -> agree q).
  assert (A0 : agree 0). { destruct Off as (A & B & C & D). destruct swing_starts as (A' & B' & C' & D'). unfold agree. now rewrite A, B, C, D, A', B', C', D'. }
  assert (G0 : Good 0) by (split; [lra|]; intros q Hq; now replace q with 0 by lra).
  destruct (completeness Good) as (m & Ub & Lub); [exists t; intros s [Hs _]; lra|now exists 0|].
  assert (Mt : m <= t) by (apply Lub; intros s [Hs _]; lra). assert (M0 : 0 <= m) by now apply Ub.
  assert (Before : forall s, 0 <= s < m -> agree s).
  { intros s Hs. apply NNPP. intros No. assert (m <= s); [|lra]. apply Lub. intros q [Hq Gq]. apply Rnot_lt_le. intros L. apply No, Gq. lra. }
  assert (Am : agree m).
  { destruct (Req_dec m 0) as [->|Ne]; [exact A0|].
    assert (Same : forall (f g : R -> R) l l', is_derive f m l -> is_derive g m l' -> (forall s, 0 <= s < m -> f s = g s) -> f m = g m).
    { intros f g l l' Df Dg E. apply NNPP. intros No. assert (P : 0 < Rabs (f m - g m)) by (apply Rabs_pos_lt; lra).
      destruct (D_near (fun s => f s - g s) m (l - l') _ (D_minus f g m l l' Df Dg) P) as (h & Hh & Q). set (s := Rmax 0 (m - h / 2)).
      assert (Hs : 0 <= s < m) by (unfold s; split; [apply Rmax_l|apply Rmax_lub_lt; lra]). assert (Hs' : m - h / 2 <= s) by apply Rmax_r.
      specialize (Q s ltac:(rewrite Rabs_left; lra)). cbv beta in Q. rewrite (E s Hs), Rminus_eq_0, Rminus_0_l, Rabs_Ropp in Q. lra. }
    destruct (St m ltac:(lra)) as [_ G]. destruct (swing_steers m M0) as [_ H].
    assert (Both : forall (f g : R -> C) a b, is_velocity f m a -> is_velocity g m b -> (forall s, 0 <= s < m -> f s = g s) -> f m = g m).
    { intros f g a b [F1 F2] [G1 G2] E. apply injective_projections; [apply (Same (fun s => fst (f s)) (fun s => fst (g s)) _ _ F1 G1)|apply (Same (fun s => snd (f s)) (fun s => snd (g s)) _ _ F2 G2)]; intros s Hs; now rewrite (E s Hs). }
    destruct (G 0%nat ltac:(lia)) as (_ & R0 & V0). destruct (G 1%nat ltac:(lia)) as (_ & R1 & V1). destruct (H 0%nat ltac:(lia)) as (_ & R0' & V0'). destruct (H 1%nat ltac:(lia)) as (_ & R1' & V1').
    split; [apply (Both _ _ _ _ R0 R0')|split; [apply (Both _ _ _ _ R1 R1')|split; [apply (Both _ _ _ _ V0 V0')|apply (Both _ _ _ _ V1 V1')]]]; intros s Hs; now apply Before. }
  assert (Gm : Good m).
  { split; [lra|]. intros s Hs. destruct (Req_dec s m) as [->|Ne]; [exact Am|apply Before; lra]. }
  destruct (Req_dec m t) as [E|Ne]; [now rewrite <- E|exfalso].
  destruct (stays_close m ltac:(lra) Am) as (h & Hh & HT & C). set (h' := Rmin h (t - m)). assert (Hh' : 0 < h') by (unfold h'; apply Rmin_glb_lt; lra).
  pose proof (Rmin_l h (t - m)) as L1. pose proof (Rmin_r h (t - m)) as L2. fold h' in L1, L2.
  assert (Good (m + h')); [|pose proof (Ub _ H); lra]. split; [lra|]. intros q Hq. destruct (Rle_or_lt q m) as [A|A]; [now apply Gm|].
  apply (agree_on m h); try assumption; lra.
Qed.
End Other.
End Motion.

(* the work of the potential on an agent, - grad_{r_i} V_i . v_i *)
Definition work_rate (r v : nat -> C) (i : nat) : R := - inner (grad_i 2 complete (fun _ _ => V2') r i) (v i).
Lemma work_first r v : work_rate r v 0 = - (pull_rate r * ((fst (r 0%nat) - fst (r 1%nat)) * fst (v 0%nat) + (snd (r 0%nat) - snd (r 1%nat)) * snd (v 0%nat))).
Proof. unfold work_rate. rewrite inner_xy. unfold grad_i, pair_grad, grad, pull_rate, Csum. cbn [Sum]. unfold w, complete. cbn [Nat.eqb negb]. set (N := norm _). set (k := V2' N / N). cbn. ring. Qed.
Lemma work_second r v : work_rate r v 1 = pull_rate r * ((fst (r 0%nat) - fst (r 1%nat)) * fst (v 1%nat) + (snd (r 0%nat) - snd (r 1%nat)) * snd (v 1%nat)).
Proof.
  unfold work_rate. rewrite inner_xy. unfold grad_i, pair_grad, grad, pull_rate, Csum. cbn [Sum]. unfold w, complete. cbn [Nat.eqb negb]. rewrite !(norm_sym (r 1%nat) (r 0%nat)).
  set (N := norm _). set (k := V2' N / N). cbn. ring.
Qed.

Definition distance (r : nat -> R -> C) (t : R) : R := norm (r 0%nat t - r 1%nat t)%C.

Theorem swings_for_ever : exists r v : nat -> R -> C, set_off r v /\ (forall t, 0 <= t -> steers r v t) /\
  (forall T r' v', set_off r' v' -> (forall t, 0 <= t < T -> steers r' v' t) -> forall t i, 0 <= t < T -> (i < 2)%nat -> r' i t = r i t /\ v' i t = v i t) /\
  (forall t i, 0 <= t -> (i < 2)%nat -> heading (v i t) = 0) /\
  (exists P, 0 < P /\ (forall t, 0 <= t -> distance r (t + P) = distance r t) /\
    forall t, 0 <= t -> exists a b, t <= a < t + P /\ t <= b < t + P /\ distance r a = 2 /\ distance r b < 1 /\
      0 < work_rate (fun j => r j a) (fun j => v j a) 0 /\ work_rate (fun j => r j b) (fun j => v j b) 0 < 0 /\
      work_rate (fun j => r j a) (fun j => v j a) 1 < 0 /\ 0 < work_rate (fun j => r j b) (fun j => v j b) 1) /\
  ~ exists l, forall e, 0 < e -> exists T, forall t, T <= t -> Rabs (distance r t - l) < e.
Proof.
  destruct swing_exists as (d & w & D0 & W0 & S). exists (swing_place d), (swing_speed w).
  destruct (period d w D0 W0 S) as (P & s & Hs & Per & Ds). assert (HP : 0 < P) by lra.
  assert (Rep : forall k t, 0 <= t -> d (t + INR k * P) = d t).
  { induction k as [|k IH]; intros t Ht; [cbn; f_equal; ring|]. rewrite S_INR. replace (t + (INR k + 1) * P) with (t + P + INR k * P) by ring. rewrite IH by lra. now apply Per. }
  assert (Every : forall t q, 0 <= t -> 0 <= q < P -> exists a, t <= a < t + P /\ 0 <= a /\ d a = d q).
  { intros t q Ht Hq. destruct (nfloor_ex (t / P)) as [k Hk]; [apply Rdiv_le_0_compat; lra|].
    assert (K : INR k * P <= t < (INR k + 1) * P). { split; [apply Rmult_le_reg_r with (/ P)|apply Rmult_lt_reg_r with (/ P)]; try (now apply Rinv_0_lt_compat); rewrite Rmult_assoc, Rinv_r by lra; unfold Rdiv in Hk; lra. }
    pose proof (pos_INR k) as K0. destruct (Rle_or_lt t (q + INR k * P)) as [L|L].
    - exists (q + INR k * P). split; [lra|]. split; [lra|]. apply Rep. lra.
    - exists (q + INR (Datatypes.S k) * P). assert (INR (Datatypes.S k) * P = INR k * P + P) by (rewrite S_INR; ring). split; [lra|]. split; [lra|]. apply Rep. lra. }
  assert (Wk : forall t, 0 <= t -> exists p q, 0 < p /\ 0 < q /\ work_rate (fun j => swing_place d j t) (fun j => swing_speed w j t) 0 = V2' (d t) * p /\
    work_rate (fun j => swing_place d j t) (fun j => swing_speed w j t) 1 = - (V2' (d t) * q)).
  { intros t Ht. exists (fst (swing_speed w 0%nat t)), (fst (swing_speed w 1%nat t)). pose proof (swing_forward d w S t 0%nat Ht) as [F0 _]. pose proof (swing_forward d w S t 1%nat Ht) as [F1 _].
    pose proof (S t Ht) as (_ & B & _). split; [lra|]. split; [lra|]. rewrite work_first, work_second, (swing_pull d w S t Ht). cbn. split; field; lra. }
  split; [exact (swing_starts d w D0 W0)|]. split; [intros t Ht; exact (swing_steers d w S t Ht)|]. split; [|split; [|split]].
  - intros T r' v' Off St t i Ht Hi. destruct (no_other d w D0 W0 S T r' v' Off St t Ht) as (A & B & C & D). destruct i as [|[|i]]; [now split|now split|lia].
  - intros t i Ht _. exact (swing_heading d w S t i Ht).
  - exists P. split; [exact HP|]. split; [intros t Ht; unfold distance; rewrite !(swing_norm d w S) by lra; now apply Per|]. intros t Ht.
    destruct (Every t 0 Ht ltac:(lra)) as (a & Ha & A0 & Da). destruct (Every t s Ht ltac:(lra)) as (b & Hb & B0 & Db). exists a, b. split; [exact Ha|]. split; [exact Hb|].
    unfold distance; rewrite !(swing_norm d w S) by lra. rewrite D0 in Da. split; [exact Da|]. split; [lra|].
    destruct (Wk a A0) as (p & q & Hp & Hq & -> & ->). destruct (Wk b B0) as (p' & q' & Hp' & Hq' & -> & ->). rewrite Da, Db.
    pose proof (V2'_above 2 ltac:(lra)). pose proof (S s ltac:(lra)) as (_ & Bs & _). pose proof (V2'_below (d s) (d s) ltac:(lra) ltac:(lra) Ds). nra.
  - intros [l H]. destruct (H ((1 - d s) / 4) ltac:(lra)) as [T HT]. pose proof (Rmax_l T 0) as T1. pose proof (Rmax_r T 0) as T2. set (t := Rmax T 0) in *.
    destruct (Every t 0 T2 ltac:(lra)) as (a & Ha & A0 & Da). destruct (Every t s T2 ltac:(lra)) as (b & Hb & B0 & Db).
    pose proof (HT a ltac:(lra)) as Ea. pose proof (HT b ltac:(lra)) as Eb. unfold distance in Ea, Eb; rewrite (swing_norm d w S) in Ea, Eb by lra. rewrite Da, D0 in Ea. rewrite Db in Eb. apply Rabs_lt_between in Ea, Eb. lra.
Qed.
