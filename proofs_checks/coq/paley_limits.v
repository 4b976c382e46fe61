(* Paley and others, Theorem 1 and the phase model (6) with the gradient control (9): motions last, all converge to the critical set of U_1;
   the balanced set is asymptotically stable for K_1 > 0; all other critical points than the extreme ones are unstable, and so are the extreme ones of the wrong kind.
     paley.thm1.conv, paley.thm1.bal, paley.thm1.sync (clause 2), paley.unbal (clauses 2, 3). *)
From Coq Require Import Reals Lra Lia Psatz Classical.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums inclusions paley_model paley_phase paley_stability.
Open Scope R_scope.

(* ---- functions on the torus: near their zeros where they are small ---- *)
Definition steady_function n (F : (nat -> R) -> R) := (forall e, 0 < e -> exists d, 0 < d /\ forall a b, near n d a b -> Rabs (F a - F b) < e) /\
  forall a (z : nat -> Z), F (fun k => a k + 2 * PI * IZR (z k)) = F a.
Lemma whole_turns x : exists z, 0 <= x + 2 * PI * IZR z <= 2 * PI.
Proof.
  pose proof PI_RGT_0 as P. set (y := x / (2 * PI)). destruct (archimed y) as [A1 A2]. exists (1 - up y)%Z. rewrite minus_IZR. replace x with (2 * PI * y) by (unfold y; field; lra).
  split; [apply Rle_trans with (2 * PI * (y + (1 - IZR (up y)))); [apply Rmult_le_pos; lra|right; ring]|].
  apply Rle_trans with (2 * PI * (y + (1 - IZR (up y)))); [right; ring|]. rewrite <- (Rmult_1_r (2 * PI)) at 2. apply Rmult_le_compat_l; lra.
Qed.
Lemma turn_all n (a : nat -> R) : exists z : nat -> Z, forall k, (k < n)%nat -> 0 <= a k + 2 * PI * IZR (z k) <= 2 * PI.
Proof.
  induction n as [|n [z H]]; [exists (fun _ => 0%Z); intros; lia|]. destruct (whole_turns (a n)) as [y Hy]. exists (fun k => if Nat.eqb k n then y else z k).
  intros k Hk. destruct (Nat.eqb_spec k n) as [->|]; [exact Hy|apply H; lia].
Qed.
Lemma near_zeros n F : (forall a, 0 <= F a) -> steady_function n F -> forall e, 0 < e -> exists d, 0 < d /\ forall a, F a < d -> exists b, F b = 0 /\ near n e a b.
Proof.
  intros F0 [C Per] e He. apply NNPP. intros N.
  assert (Bad : forall m, exists a, F a < / (INR m + 1) /\ ~ exists b, F b = 0 /\ near n e a b).
  { intros m. apply NNPP. intros M. apply N. exists (/ (INR m + 1)). split; [apply Rinv_0_lt_compat; pose proof (pos_INR m); lra|]. intros a Ha. apply NNPP. intros X. apply M. now exists a. }
  set (bad := fun m a => F a < / (INR m + 1) /\ (~ exists b, F b = 0 /\ near n e a b) /\ forall k, (k < n)%nat -> 0 <= a k <= 2 * PI).
  assert (Bad' : forall m, exists a, bad m a).
  { intros m. destruct (Bad m) as (a & A1 & A2). destruct (turn_all n a) as [z Hz]. exists (fun k => a k + 2 * PI * IZR (z k)). split; [now rewrite Per|]. split; [|exact Hz].
    intros (b & B1 & B2). apply A2. exists (fun k => b k + 2 * PI * IZR (- z k)). split; [now rewrite (Per b (fun k => (- z k)%Z))|]. intros k Hk. specialize (B2 k Hk). rewrite opp_IZR.
    replace (a k - (b k + 2 * PI * - IZR (z k))) with (a k + 2 * PI * IZR (z k) - b k) by ring. exact B2. }
  assert (Weak : forall m m' a, (m <= m')%nat -> bad m' a -> bad m a).
  { intros m m' a L (A1 & A2). split; [|exact A2]. apply Rlt_le_trans with (1 := A1). apply le_INR in L. pose proof (pos_INR m). apply Rinv_le_contravar; lra. }
  set (big := fun P : (nat -> R) -> Prop => forall m, exists a, bad m a /\ P (fun k => if Nat.ltb k n then a k else 0)).
  assert (CP : forall k d, 0 < d -> big (close k (cluster big) d)).
  { apply cluster_point.
    - intros A B H S m. destruct (S m) as (a & Ha & Pa). exists a. split; [exact Ha|now apply H].
    - intros A B H. destruct (classic (big A)) as [Y|Y]; [now left|right]. intros m. apply not_all_ex_not in Y. destruct Y as [m1 Y].
      destruct (H (max m m1)) as (a & Ha & [Q|Q]); [exfalso; apply Y; exists a; split; [apply (Weak m1 (max m m1) a ltac:(lia) Ha)|exact Q]|exists a; split; [apply (Weak m (max m m1) a ltac:(lia) Ha)|exact Q]].
    - intros m. destruct (Bad' m) as [a Ha]. now exists a.
    - intros k. exists (2 * PI). intros H. destruct (H 0%nat) as (a & (_ & _ & Ha) & Q). revert Q. pose proof PI_RGT_0. destruct (Nat.ltb_spec k n) as [L|L]; [specialize (Ha k L); rewrite Rabs_pos_eq; lra|rewrite Rabs_R0; lra]. }
  set (b := cluster big) in *.
  assert (Zb : F b = 0).
  { apply Rle_antisym; [|apply F0]. apply le_epsilon. intros h Hh. destruct (C (h / 2) ltac:(lra)) as (d & Hd & K). destruct (above (2 / h)) as [m Hm].
    destruct (CP n d Hd m) as (a & (A1 & _) & A2). assert (Nr : near n d a b) by (intros k Hk; specialize (A2 k Hk); cbv beta in A2; apply Nat.ltb_lt in Hk; rewrite Hk in A2; exact A2).
    specialize (K a b Nr). apply Rabs_def2 in K. assert (/ (INR m + 1) <= h / 2); [|lra]. rewrite <- (Rinv_inv (h / 2)). pose proof (pos_INR m).
    assert (E : / (h / 2) = 2 / h) by (field; lra). rewrite E. apply Rinv_le_contravar; [apply Rdiv_lt_0_compat; lra|lra]. }
  destruct (CP n e He 0%nat) as (a & (_ & A2 & _) & A3). apply A2. exists b. split; [exact Zb|]. intros k Hk. specialize (A3 k Hk). cbv beta in A3. apply Nat.ltb_lt in Hk. rewrite Hk in A3. exact A3.
Qed.

Section Phase.
Variable n : nat.
Hypothesis Hn : (1 <= n)%nat.
Definition grad2 (th : nat -> R) := Sum n (fun k => g1 n th k ^ 2).
Lemma sin_gap x y : Rabs (sin x - sin y) <= Rabs (x - y).
Proof.
  assert (S : forall a b, a <= b -> Rabs (sin b - sin a) <= 1 * (b - a)).
  { intros a b L. apply (slope_le sin cos 1 a b L). intros u _. split; [apply is_derive_Reals, derivable_pt_lim_sin|]. pose proof (COS_bound u). apply Rabs_le. lra. }
  destruct (Rle_or_lt y x) as [L|L]; [specialize (S y x L); rewrite (Rabs_pos_eq (x - y)); lra|]. specialize (S x y ltac:(lra)). rewrite Rabs_minus_sym, (Rabs_left (x - y)); lra.
Qed.
Lemma cos_gap x y : Rabs (cos x - cos y) <= Rabs (x - y).
Proof. rewrite <- !sin_shift. eapply Rle_trans; [apply sin_gap|]. right. replace (PI / 2 - x - (PI / 2 - y)) with (- (x - y)) by ring. apply Rabs_Ropp. Qed.
Lemma g1_near a b d k : near n d a b -> (k < n)%nat -> Rabs (g1 n a k - g1 n b k) <= 2 * d.
Proof.
  intros N Hk. pose proof (INR_pos n Hn) as P. rewrite !g1_sines, <- Rmult_minus_distr_l, <- Sum_minus, Rabs_mult, (Rabs_pos_eq (/ INR n)) by (left; now apply Rinv_0_lt_compat).
  apply Rle_trans with (/ INR n * (INR n * (2 * d))); [|right; field; lra]. apply Rmult_le_compat_l; [left; now apply Rinv_0_lt_compat|]. rewrite <- Sum_const.
  eapply Rle_trans; [apply Sum_Rabs|]. apply Sum_le. intros j Hj. eapply Rle_trans; [apply sin_gap|]. pose proof (N j Hj). pose proof (N k Hk).
  replace (a j - a k - (b j - b k)) with ((a j - b j) + - (a k - b k)) by ring. eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_Ropp. lra.
Qed.
Lemma grad2_ge0 a : 0 <= grad2 a.
Proof. apply Sum_ge0. intros. apply pow2_ge_0. Qed.
Lemma turns (a : nat -> R) (z : nat -> Z) k : expi (a k + 2 * PI * IZR (z k)) = expi (a k).
Proof.
  assert (Q : forall x m, cos (x + 2 * PI * IZR m) = cos x /\ sin (x + 2 * PI * IZR m) = sin x).
  { intros x m. destruct (Z_le_gt_dec 0 m) as [L|L].
    - replace (IZR m) with (INR (Z.to_nat m)) by (rewrite INR_IZR_INZ; f_equal; lia). replace (2 * PI * INR (Z.to_nat m)) with (2 * INR (Z.to_nat m) * PI) by ring. split; [apply cos_period|apply sin_period].
    - set (y := x + 2 * PI * IZR m). replace x with (y + 2 * INR (Z.to_nat (- m)) * PI); [now rewrite cos_period, sin_period|]. unfold y. rewrite INR_IZR_INZ, Z2Nat.id by lia. rewrite opp_IZR. ring. }
  unfold expi. destruct (Q (a k) (z k)) as [-> ->]. reflexivity.
Qed.
Lemma grad2_steady : steady_function n grad2.
Proof.
  split.
  - intros e He. pose proof (INR_pos n Hn) as P. exists (e / (8 * INR n)). split; [apply Rdiv_lt_0_compat; lra|]. intros a b N. unfold grad2. rewrite <- Sum_minus.
    eapply Rle_lt_trans; [apply Sum_Rabs|]. apply Rle_lt_trans with (INR n * (4 * (e / (8 * INR n)))); [|replace (INR n * (4 * (e / (8 * INR n)))) with (e / 2) by (field; lra); lra].
    rewrite <- Sum_const. apply Sum_le. intros k Hk. replace (g1 n a k ^ 2 - g1 n b k ^ 2) with ((g1 n a k + g1 n b k) * (g1 n a k - g1 n b k)) by ring. rewrite Rabs_mult.
    pose proof (g1_near a b _ k N Hk). pose proof (g1_bound n a k Hn). pose proof (g1_bound n b k Hn).
    assert (Rabs (g1 n a k + g1 n b k) <= 2) by (apply Rabs_le; lra). replace (4 * (e / (8 * INR n))) with (2 * (2 * (e / (8 * INR n)))) by ring. apply Rmult_le_compat; try apply Rabs_pos; assumption.
  - intros a z. apply Sum_ext. intros k _. f_equal. unfold g1. rewrite turns. f_equal. unfold order. f_equal. apply Csum_ext. intros j _. apply turns.
Qed.
Lemma critical_iff a : grad2 a = 0 <-> stationary n (U1 n) a.
Proof.
  split; intros H.
  - intros k Hk. pose proof (Sum_eq0 n (fun k => g1 n a k ^ 2) (fun j _ => pow2_ge_0 _) H k Hk) as Z. cbv beta in Z. replace 0 with (g1 n a k) by nra. now apply U1_gradient.
  - apply Sum_zero. intros k Hk. pose proof (U1_gradient n a k Hn Hk) as D. specialize (H k Hk). unfold partial in *. apply is_derive_unique in D, H. rewrite D in H. rewrite H. ring.
Qed.
Lemma U1_steady : steady_function n (U1 n).
Proof.
  assert (E : forall a, U1 n a = / (2 * INR n) * ((Sum n (fun k => cos (a k))) ^ 2 + (Sum n (fun k => sin (a k))) ^ 2)).
  { intros a. rewrite U1_sum by exact Hn. f_equal. rewrite inner_xy. unfold phasors, expi, Csum. cbn [fst snd]. ring. }
  split.
  - intros e He. pose proof (INR_pos n Hn) as P. exists (e / (4 * INR n)). split; [apply Rdiv_lt_0_compat; lra|]. intros a b N. set (d := e / (4 * INR n)) in *.
    assert (K : forall f : R -> R, (forall x y, Rabs (f x - f y) <= Rabs (x - y)) -> (forall x, -1 <= f x <= 1) -> Rabs ((Sum n (fun k => f (a k))) ^ 2 - (Sum n (fun k => f (b k))) ^ 2) <= 2 * INR n * (INR n * d)).
    { intros f L B. replace (_ ^ 2 - _ ^ 2) with ((Sum n (fun k => f (a k)) + Sum n (fun k => f (b k))) * (Sum n (fun k => f (a k)) - Sum n (fun k => f (b k)))) by ring. rewrite Rabs_mult, <- Sum_plus, <- Sum_minus.
      apply Rmult_le_compat; try apply Rabs_pos; (eapply Rle_trans; [apply Sum_Rabs|]).
      - replace (2 * INR n) with (INR n * 2) by ring. rewrite <- Sum_const. apply Sum_le. intros k _. pose proof (B (a k)). pose proof (B (b k)). apply Rabs_le. lra.
      - rewrite <- Sum_const. apply Sum_le. intros k Hk. eapply Rle_trans; [apply L|]. left. now apply N. }
    pose proof (K cos cos_gap COS_bound) as K1. pose proof (K sin sin_gap SIN_bound) as K2. rewrite !E, <- Rmult_minus_distr_l, Rabs_mult, (Rabs_pos_eq (/ (2 * INR n))) by (left; apply Rinv_0_lt_compat; lra).
    set (Ca := Sum n (fun k => cos (a k))) in *. set (Sa := Sum n (fun k => sin (a k))) in *. set (Cb := Sum n (fun k => cos (b k))) in *. set (Sb := Sum n (fun k => sin (b k))) in *.
    assert (T : Rabs (Ca ^ 2 + Sa ^ 2 - (Cb ^ 2 + Sb ^ 2)) <= 4 * INR n * (INR n * d)).
    { replace (Ca ^ 2 + Sa ^ 2 - (Cb ^ 2 + Sb ^ 2)) with ((Ca ^ 2 - Cb ^ 2) + (Sa ^ 2 - Sb ^ 2)) by ring. eapply Rle_trans; [apply Rabs_triang|]. lra. }
    apply Rle_lt_trans with (/ (2 * INR n) * (4 * INR n * (INR n * d))); [apply Rmult_le_compat_l; [left; apply Rinv_0_lt_compat; lra|exact T]|].
    unfold d. replace (/ (2 * INR n) * (4 * INR n * (INR n * (e / (4 * INR n))))) with (e / 2) by (field; lra). lra.
  - intros a z. rewrite !U1_sum by exact Hn. assert (Q : Csum n (phasors (fun k => a k + 2 * PI * IZR (z k))) = Csum n (phasors a)) by (apply Csum_ext; intros j _; apply turns). now rewrite Q.
Qed.
(* critical values are squares over 2n *)
Lemma critical_value a : stationary n (U1 n) a -> exists m : nat, U1 n a = INR m ^ 2 / (2 * INR n).
Proof.
  intros S. pose proof (INR_pos n Hn) as P. destruct (classic (balanced n a)) as [B|B].
  - exists 0%nat. destruct (U1_min n a Hn) as [_ M]. rewrite (proj2 M B). cbn. field. lra.
  - destruct (critical_signs n a Hn S B) as (z & c & Iz & E & CS & _). assert (W : exists y : Z, Sum n c = IZR y).
    { clear - E. induction n as [|k IH]; [now exists 0%Z|]. destruct IH as [y Hy]; [intros; apply E; lia|]. cbn [Sum]. rewrite Hy. destruct (E k ltac:(lia)) as [[H|H] _]; rewrite H; [exists (y + 1)%Z|exists (y - 1)%Z]; [rewrite plus_IZR|rewrite minus_IZR]; ring. }
    destruct W as [y Hy]. exists (Z.abs_nat y). assert (Ey : INR (Z.abs_nat y) ^ 2 = IZR y ^ 2) by (rewrite INR_IZR_INZ, Zabs2Nat.id_abs, abs_IZR; apply pow2_abs).
    rewrite Ey, U1_sum, CS by exact Hn. rewrite inner_scal, inner_sym, inner_scal, Iz, Hy. field. lra.
Qed.
Lemma critical_gap a b : stationary n (U1 n) a -> stationary n (U1 n) b -> U1 n a < U1 n b -> U1 n a + / (2 * INR n) <= U1 n b.
Proof.
  intros A B L. pose proof (INR_pos n Hn) as P. destruct (critical_value a A) as [x Hx]. destruct (critical_value b B) as [y Hy]. rewrite Hx, Hy in *. unfold Rdiv in *.
  assert (I : 0 < / (2 * INR n)) by (apply Rinv_0_lt_compat; lra). apply Rmult_lt_reg_r in L; [|exact I]. assert (X : (x < y)%nat).
  { apply INR_lt. apply Rnot_le_lt. intros H. pose proof (pos_INR x). pose proof (pos_INR y). nra. }
  apply le_INR in X. rewrite S_INR in X. pose proof (pos_INR x). rewrite <- (Rmult_1_l (/ (2 * INR n))) at 2. rewrite <- Rmult_plus_distr_r. apply Rmult_le_compat_r; nra.
Qed.

(* ---- motions ---- *)
Definition phases (w0 K1 : R) (th : nat -> R -> R) := forall t k, 0 <= t -> (k < n)%nat -> is_derive (th k) t (w0 + - K1 * g1 n (fun j => th j t) k).
Lemma field_ok w0 K1 : (forall x i, (i < n)%nat -> Rabs (w0 + - K1 * g1 n x i) <= Rabs w0 + Rabs K1) /\ forall x, continuous_at n (fun x i => w0 + - K1 * g1 n x i) x.
Proof.
  split.
  - intros x i Hi. eapply Rle_trans; [apply Rabs_triang|]. apply Rplus_le_compat_l. rewrite Rabs_mult, Rabs_Ropp. pose proof (g1_bound n x i Hn). assert (Rabs (g1 n x i) <= 1) by (apply Rabs_le; lra).
    rewrite <- (Rmult_1_r (Rabs K1)) at 2. apply Rmult_le_compat_l; [apply Rabs_pos|assumption].
  - intros x e He. pose proof (Rabs_pos K1) as P. exists (e / (4 * (Rabs K1 + 1))). assert (D : 0 < e / (4 * (Rabs K1 + 1))) by (apply Rdiv_lt_0_compat; lra). split; [exact D|]. intros y N i Hi.
    replace (w0 + - K1 * g1 n y i - (w0 + - K1 * g1 n x i)) with (- K1 * (g1 n y i - g1 n x i)) by ring. rewrite Rabs_mult, Rabs_Ropp. pose proof (g1_near y x _ i N Hi) as G.
    apply Rle_lt_trans with ((Rabs K1 + 1) * (2 * (e / (4 * (Rabs K1 + 1))))); [|replace ((Rabs K1 + 1) * (2 * (e / (4 * (Rabs K1 + 1))))) with (e / 2) by (field; lra); lra].
    apply Rmult_le_compat; try apply Rabs_pos; lra.
Qed.
(* from every start, and beyond every time *)
Definition lasting w0 K1 := (forall a : nat -> R, exists th, (forall k, (k < n)%nat -> th k 0 = a k) /\ phases w0 K1 th) /\
  forall T th, 0 < T -> (forall t k, 0 <= t < T -> (k < n)%nat -> is_derive (th k) t (w0 + - K1 * g1 n (fun j => th j t) k)) ->
    exists th', (forall t k, t < T -> (k < n)%nat -> th' k t = th k t) /\ phases w0 K1 th'.
Theorem phases_last w0 K1 : lasting w0 K1.
Proof.
  destruct (field_ok w0 K1) as [B C]. split.
  - intros a. destruct (peano n (fun x i => w0 + - K1 * g1 n x i) _ a B C) as (x & X0 & X1). exists (fun k t => x t k). split; [exact X0|]. intros t k Ht Hk. exact (X1 t k Ht Hk).
  - intros T th HT D. destruct (peano_on n (fun x i => w0 + - K1 * g1 n x i) _ T (fun t k => th k t) B C HT D) as (x & X0 & X1). exists (fun k t => x t k). split; [intros t k Ht Hk; now rewrite (X0 t Ht)|].
    intros t k Ht Hk. exact (X1 t k Ht Hk).
Qed.
Definition within (th : nat -> R -> R) t e (a : nat -> R) := near n e (fun k => th k t) a.
(* Theorem 1: every motion comes to the critical set of U_1 *)
Theorem converges w0 K1 : K1 <> 0 -> lasting w0 K1 /\ forall th, phases w0 K1 th -> forall e, 0 < e -> exists T, 0 <= T /\ forall t, T <= t ->
  exists a, stationary n (U1 n) a /\ within th t e a.
Proof.
  intros HK. split; [apply phases_last|]. intros th HT e He. destruct (near_zeros n grad2 grad2_ge0 grad2_steady e He) as (d & Hd & Z).
  destruct (thm1_gradient_to_0 n w0 K1 th Hn HK HT d Hd) as (T & T0 & G). exists T. split; [exact T0|]. intros t Ht. destruct (Z _ (G t Ht)) as (a & A1 & A2). exists a. split; [now apply critical_iff|exact A2].
Qed.
Lemma U_moves w0 K1 th : phases w0 K1 th -> forall s t, 0 <= s <= t -> (0 < K1 -> U1 n (fun k => th k t) <= U1 n (fun k => th k s)) /\ (K1 < 0 -> U1 n (fun k => th k s) <= U1 n (fun k => th k t)).
Proof.
  intros HT s t Hst. pose proof (fun u Hu => U_rate n w0 K1 th Hn HT u Hu) as D. split; intros HK.
  - apply (decreasing (fun u => U1 n (fun k => th k u)) (fun u => - K1 * G n th u) s t); [lra|intros u Hu; apply D; lra|]. intros u Hu. pose proof (G_ge0 n th u). nra.
  - assert (Q : - U1 n (fun k => th k t) <= - U1 n (fun k => th k s)); [|lra].
    apply (decreasing (fun u => - U1 n (fun k => th k u)) (fun u => - (- K1 * G n th u)) s t); [lra|intros u Hu; apply D_opp, D; lra|]. intros u Hu. pose proof (G_ge0 n th u). nra.
Qed.
(* the balanced set is asymptotically stable for K_1 > 0: stable, and it attracts what starts near it *)
Theorem balanced_stable w0 K1 : 0 < K1 ->
  (forall e, 0 < e -> exists d, 0 < d /\ forall th a, phases w0 K1 th -> balanced n a -> within th 0 d a -> forall t, 0 <= t -> exists b, balanced n b /\ within th t e b) /\
  exists d, 0 < d /\ forall th a, phases w0 K1 th -> balanced n a -> within th 0 d a -> forall e, 0 < e -> exists T, 0 <= T /\ forall t, T <= t -> exists b, balanced n b /\ within th t e b.
Proof.
  intros HK. pose proof (INR_pos n Hn) as P. assert (Z : forall e, 0 < e -> exists d, 0 < d /\ forall a, U1 n a < d -> exists b, balanced n b /\ near n e a b).
  { intros e He. destruct (near_zeros n (U1 n) (fun a => proj1 (U1_min n a Hn)) U1_steady e He) as (d & Hd & K). exists d. split; [exact Hd|]. intros a Ha. destruct (K a Ha) as (b & B1 & B2). exists b. split; [now apply (U1_min n b Hn)|exact B2]. }
  assert (S : forall h, 0 < h -> exists d, 0 < d /\ forall th a, balanced n a -> within th 0 d a -> U1 n (fun k => th k 0) < h).
  { intros h Hh. destruct (proj1 U1_steady h Hh) as (d & Hd & K). exists d. split; [exact Hd|]. intros th a B N. specialize (K _ _ N). rewrite (proj2 (proj2 (U1_min n a Hn)) B) in K. apply Rabs_def2 in K. lra. }
  split.
  - intros e He. destruct (Z e He) as (h & Hh & K). destruct (S h Hh) as (d & Hd & Q). exists d. split; [exact Hd|]. intros th a HT B N t Ht. apply K.
    apply Rle_lt_trans with (2 := Q th a B N). now apply (U_moves w0 K1 th HT 0 t ltac:(lra)).
  - destruct (S (/ (2 * INR n)) ltac:(apply Rinv_0_lt_compat; lra)) as (d & Hd & Q). exists d. split; [exact Hd|]. intros th a HT B N e He. destruct (Z e He) as (h & Hh & K). specialize (Q th a B N).
    assert (P0 : INR n * Cmod (order n (fun j => th j 0)) < 1).
    { unfold U1 in Q. pose proof (Cmod_ge_0 (order n (fun j => th j 0))). set (p := Cmod (order n (fun j => th j 0))) in *. apply (Rmult_lt_compat_l (2 * INR n)) in Q; [|lra]. rewrite Rinv_r in Q by lra.
      apply Rnot_le_lt. intros L. assert (0 <= INR n * p) by (apply Rmult_le_pos; lra). nra. }
    destruct (thm1_balance n w0 K1 th Hn ltac:(lra) HT HK P0 (Rmin 1 (h / INR n))) as (T & T0 & G); [apply Rmin_glb_lt; [lra|apply Rdiv_lt_0_compat; lra]|]. exists T. split; [exact T0|]. intros t Ht. apply K. specialize (G t Ht).
    pose proof (Rmin_l 1 (h / INR n)). pose proof (Rmin_r 1 (h / INR n)). unfold U1. set (p := Cmod (order n (fun j => th j t))) in *. pose proof (Cmod_ge_0 (order n (fun j => th j t))) as P1. fold p in P1.
    apply Rle_lt_trans with (INR n * p); [|apply Rlt_le_trans with (INR n * (h / INR n)); [apply Rmult_lt_compat_l; lra|right; field; lra]]. assert (p ^ 2 <= p) by nra. assert (0 <= p ^ 2) by nra. nra.
Qed.
(* an arrangement a is stable, up to rotation, if what starts near it stays near its rotations *)
Definition stable w0 K1 (a : nat -> R) := forall e, 0 < e -> exists d, 0 < d /\ forall th, phases w0 K1 th -> within th 0 d a -> forall t, 0 <= t -> exists c, within th t e (fun k => a k + c).
Lemma turned_value a c : U1 n (fun k => a k + c) = U1 n a.
Proof. now apply U1_rotation. Qed.
(* a critical point with lower values nearby is unstable for K_1 > 0, one with higher values nearby for K_1 < 0 *)
Lemma unstable w0 K1 a : stationary n (U1 n) a -> (0 < K1 /\ forall e, 0 < e -> exists b, near n e b a /\ U1 n b < U1 n a) \/ (K1 < 0 /\ forall e, 0 < e -> exists b, near n e b a /\ U1 n a < U1 n b) -> ~ stable w0 K1 a.
Proof.
  intros Sa H St. pose proof (INR_pos n Hn) as P. set (gap := / (2 * INR n)). assert (Hg : 0 < gap) by (apply Rinv_0_lt_compat; lra).
  destruct (proj1 U1_steady (gap / 4) ltac:(lra)) as (e & He & K). destruct (St e He) as (d & Hd & L).
  assert (B : exists b, near n d b a /\ (0 < K1 /\ U1 n b < U1 n a \/ K1 < 0 /\ U1 n a < U1 n b)).
  { destruct H as [[HK H]|[HK H]]; destruct (H d Hd) as (b & B1 & B2); exists b; (split; [exact B1|]); [left|right]; now split. }
  destruct B as (b & Nb & Vb). destruct (proj1 (phases_last w0 K1) b) as (th & T0 & HT).
  assert (W0 : within th 0 d a) by (intros k Hk; cbv beta; rewrite (T0 k Hk); now apply Nb). specialize (L th HT W0).
  assert (U0 : U1 n (fun k => th k 0) = U1 n b).
  { unfold U1. f_equal. f_equal. f_equal. unfold order. f_equal. apply Csum_ext. intros k Hk. unfold phasors. now rewrite T0. }
  set (diff := Rabs (U1 n b - U1 n a)). assert (Hdf : 0 < diff) by (apply Rabs_pos_lt; destruct Vb as [[_ V]|[_ V]]; lra).
  destruct (proj1 U1_steady (Rmin (gap / 4) diff) ltac:(apply Rmin_glb_lt; lra)) as (e' & He' & K'). assert (HK : K1 <> 0) by (destruct Vb as [[V _]|[V _]]; lra).
  destruct (proj2 (converges w0 K1 HK) th HT e' He') as (T & HT0 & Cv). destruct (Cv T (Rle_refl T)) as (a' & Sa' & Na'). destruct (L T HT0) as (c & Nc).
  pose proof (K _ _ Nc) as V1. rewrite turned_value in V1. pose proof (K' _ _ Na') as V2. pose proof (Rmin_l (gap / 4) diff). pose proof (Rmin_r (gap / 4) diff). destruct (U_moves w0 K1 th HT 0 T ltac:(lra)) as [M1 M2]. rewrite U0 in M1, M2.
  apply Rabs_def2 in V1, V2. destruct Vb as [[Kp V]|[Kn V]].
  - assert (diff = U1 n a - U1 n b) by (unfold diff; rewrite Rabs_left; lra). specialize (M1 Kp). pose proof (critical_gap a' a Sa' Sa ltac:(lra)) as Q. fold gap in Q. lra.
  - assert (diff = U1 n b - U1 n a) by (unfold diff; rewrite Rabs_pos_eq; lra). specialize (M2 Kn). pose proof (critical_gap a a' Sa Sa' ltac:(lra)) as Q. fold gap in Q. lra.
Qed.
Lemma move_one a e : (2 <= n)%nat -> 0 < e -> exists d, 0 < d < e /\ cos d <> 1 /\ near n e (upd a 0 (a 0%nat + d)) a.
Proof.
  intros _ He. destruct (cos_small e He) as (d & Hd & C1). exists d. split; [exact Hd|]. split; [lra|]. intros k Hk. unfold upd. destruct (Nat.eqb_spec k 0) as [->|]; [replace (a 0%nat + d - a 0%nat) with d by ring; rewrite Rabs_pos_eq; lra|rewrite Rminus_eq_0, Rabs_R0; lra].
Qed.
Lemma same_phasor x d : expi (x + d) = expi x -> cos d = 1.
Proof.
  intros E. injection E as E1 E2. replace d with (x + d - x) by ring. rewrite cos_minus, E1, E2. pose proof (sin2_cos2 x) as Q. unfold Rsqr in Q. lra.
Qed.
Lemma balanced_sum a : balanced n a -> Csum n (phasors a) = RtoC 0.
Proof.
  intros B. pose proof (INR_pos n Hn) as P. unfold balanced, order in B. replace (Csum n (phasors a)) with (RtoC (INR n) * (RtoC (/ INR n) * Csum n (phasors a)))%C; [rewrite B; ring|].
  rewrite Cmult_assoc, <- RtoC_mult, Rinv_r by lra. ring.
Qed.
(* for K_1 > 0 all critical points but the balanced ones are unstable, for K_1 < 0 all but the synchronised ones *)
Theorem rest_unstable w0 K1 a : (2 <= n)%nat -> stationary n (U1 n) a -> (0 < K1 -> ~ balanced n a -> ~ stable w0 K1 a) /\ (K1 < 0 -> ~ synchronized n a -> ~ stable w0 K1 a).
Proof.
  intros N2 Sa. split; intros HK Nb.
  - apply (unstable w0 K1 a Sa). left. split; [exact HK|]. intros e He. destruct (classic (synchronized n a)) as [Y|Y].
    + destruct (move_one a e N2 He) as (d & Hd & Cd & Nr). exists (upd a 0 (a 0%nat + d)). split; [exact Nr|].
      destruct (U1_max n a Hn) as [_ M]. rewrite (proj2 M Y). destruct (U1_max n (upd a 0 (a 0%nat + d)) Hn) as [L M']. destruct (Rle_lt_or_eq_dec _ _ L) as [|E]; [assumption|]. exfalso. apply Cd. apply M' in E.
      pose proof (E 0%nat 1%nat ltac:(lia) ltac:(lia)) as Q. pose proof (Y 0%nat 1%nat ltac:(lia) ltac:(lia)) as Q'. cbv [upd Nat.eqb] in Q. apply (same_phasor (a 0%nat)). now rewrite Q, Q'.
    + destruct (thm1_saddle n a Hn Sa Y Nb) as [_ [_ Sd]]. destruct (Sd e He) as [_ (b & B1 & B2)]. exists b. split; [exact B1|lra].
  - apply (unstable w0 K1 a Sa). right. split; [exact HK|]. intros e He. destruct (classic (balanced n a)) as [Y|Y].
    + destruct (move_one a e N2 He) as (d & Hd & Cd & Nr). exists (upd a 0 (a 0%nat + d)). split; [exact Nr|]. destruct (U1_min n a Hn) as [_ M]. rewrite (proj2 M Y).
      destruct (U1_min n (upd a 0 (a 0%nat + d)) Hn) as [L M']. destruct (Rle_lt_or_eq_dec _ _ L) as [|E]; [assumption|]. exfalso. apply Cd. symmetry in E. apply M' in E. apply balanced_sum in E, Y. rewrite Csum_upd, Y in E by lia. apply (same_phasor (a 0%nat)).
      replace (expi (a 0%nat + d)) with (RtoC 0 + (expi (a 0%nat + d) - expi (a 0%nat)) + expi (a 0%nat))%C by ring. rewrite E. ring.
    + destruct (thm1_saddle n a Hn Sa Nb Y) as [_ [_ Sd]]. destruct (Sd e He) as [(b & B1 & B2) _]. exists b. split; [exact B1|lra].
Qed.
(* the other critical points look like two clusters of different sizes on opposite sides: m phases at one place, m' at the other one *)
Theorem rest_clusters a : stationary n (U1 n) a -> ~ synchronized n a -> ~ balanced n a -> exists (x : R) (s : nat -> bool),
  (forall k, (k < n)%nat -> expi (a k) = if s k then expi x else expi (x + PI)) /\
  (exists j, (j < n)%nat /\ s j = true) /\ (exists j, (j < n)%nat /\ s j = false) /\ Sum n (fun k => if s k then 1 else 0) <> Sum n (fun k => if s k then 0 else 1).
Proof.
  intros Sa NS NB. destruct (critical_signs n a Hn Sa NB) as (z & c & Iz & E & _ & Pc).
  assert (Ex : exists j, (j < n)%nat /\ c j = 1).
  { apply NNPP. intros N. assert (Sum n c <= Sum n (fun _ => 0)); [|rewrite Sum_0 in *; lra]. apply Sum_le. intros j Hj. destruct (proj1 (E j Hj)) as [H|H]; [exfalso; apply N; now exists j|lra]. }
  destruct Ex as (j0 & Hj0 & Ej0). assert (Z0 : z = expi (a j0)) by (rewrite (proj2 (E j0 Hj0)), Ej0; ring).
  exists (a j0), (fun k => if Req_EM_T (c k) 1 then true else false). assert (Op : expi (a j0 + PI) = (RtoC (-1) * expi (a j0))%C) by (unfold expi; rewrite neg_cos, neg_sin; apply injective_projections; cbn; ring).
  split; [|split; [|split]].
  - intros k Hk. destruct (E k Hk) as [[H|H] Q]; rewrite Q, Z0; destruct (Req_EM_T (c k) 1) as [Y|Y]; try lra; [rewrite H; ring|rewrite H, Op; reflexivity].
  - exists j0. split; [exact Hj0|]. destruct (Req_EM_T (c j0) 1); [reflexivity|contradiction].
  - apply NNPP. intros N. apply NS. assert (All : forall k, (k < n)%nat -> expi (a k) = z).
    { intros k Hk. destruct (E k Hk) as [[H|H] Q]; rewrite Q, H; [ring|]. exfalso. apply N. exists k. split; [exact Hk|]. destruct (Req_EM_T (c k) 1); [lra|reflexivity]. }
    intros j k Hj Hk. now rewrite !All.
  - intros Q. assert (Sum n c = Sum n (fun k => if (if Req_EM_T (c k) 1 then true else false) then 1 else 0) - Sum n (fun k => if (if Req_EM_T (c k) 1 then true else false) then 0 else 1)); [|lra].
    rewrite <- Sum_minus. apply Sum_ext. intros k Hk. destruct (proj1 (E k Hk)) as [H|H], (Req_EM_T (c k) 1); lra.
Qed.
(* two clusters at x and x + pi, neither empty, of different sizes: equilibria that are unstable for every gain *)
Theorem clusters_unstable w0 K1 (x : R) (s : nat -> bool) (a : nat -> R) : K1 <> 0 -> (forall k, (k < n)%nat -> a k = if s k then x else x + PI) ->
  (exists j, (j < n)%nat /\ s j = true) -> (exists j, (j < n)%nat /\ s j = false) -> Sum n (fun k => if s k then 1 else 0) <> Sum n (fun k => if s k then 0 else 1) ->
  (stationary n (U1 n) a /\ ~ stable w0 K1 a) /\ (expi (x + PI) = - expi x)%C /\ forall k, (k < n)%nat -> expi (a k) = if s k then expi x else expi (x + PI).
Proof.
  intros HK A (j1 & Hj1 & E1) (j2 & Hj2 & E2) Ne. pose proof PI_RGT_0 as PP. pose proof (INR_pos n Hn) as P.
  assert (Op : expi (x + PI) = (- expi x)%C) by (unfold expi; rewrite neg_cos, neg_sin; reflexivity).
  assert (Ea : forall k, (k < n)%nat -> expi (a k) = if s k then expi x else expi (x + PI)) by (intros k Hk; rewrite (A k Hk); now destruct (s k)).
  assert (St : stationary n (U1 n) a).
  { apply critical_iff. apply Sum_zero. intros k Hk. rewrite g1_sines. replace (Sum n (fun j => sin (a j - a k))) with 0; [ring|]. symmetry. apply Sum_zero. intros j Hj. rewrite (A j Hj), (A k Hk).
    destruct (s j), (s k).
    - rewrite Rminus_eq_0. apply sin_0.
    - replace (x - (x + PI)) with (- PI) by ring. rewrite sin_neg, sin_PI. ring.
    - replace (x + PI - x) with PI by ring. apply sin_PI.
    - rewrite Rminus_eq_0. apply sin_0. }
  assert (NS : ~ synchronized n a).
  { intros Y. pose proof (Y j1 j2 Hj1 Hj2) as Q. rewrite (Ea j1 Hj1), (Ea j2 Hj2), E1, E2, Op in Q. pose proof (sin2_cos2 x) as U. unfold Rsqr in U. injection Q as Q1 Q2. nra. }
  assert (NB : ~ balanced n a).
  { intros Y. apply balanced_sum in Y. set (d := Sum n (fun k => if s k then 1 else 0) - Sum n (fun k => if s k then 0 else 1)).
    assert (Cs : Csum n (phasors a) = (RtoC d * expi x)%C).
    { unfold d. rewrite <- Sum_minus. apply injective_projections; cbn.
      - rewrite Rmult_0_l, Rminus_0_r. rewrite <- Sum_scal_r. apply Sum_ext. intros k Hk. change (cos (a k)) with (fst (expi (a k))). rewrite (Ea k Hk), Op. destruct (s k); cbn; ring.
      - rewrite Rmult_0_l, Rplus_0_r. rewrite <- Sum_scal_r. apply Sum_ext. intros k Hk. change (sin (a k)) with (snd (expi (a k))). rewrite (Ea k Hk), Op. destruct (s k); cbn; ring. }
    rewrite Cs in Y. injection Y as Y1 Y2. pose proof (sin2_cos2 x) as U. unfold Rsqr in U. rewrite Rmult_0_l, Rminus_0_r in Y1. rewrite Rmult_0_l, Rplus_0_r in Y2.
    assert (d = 0) by (replace d with (d * (sin x * sin x + cos x * cos x)) by (rewrite U; ring); replace (d * (sin x * sin x + cos x * cos x)) with ((d * sin x) * sin x + (d * cos x) * cos x) by ring; rewrite Y1, Y2; ring).
    apply Ne. unfold d in H. lra. }
  assert (N2 : (2 <= n)%nat) by (assert (j1 <> j2) by (intros ->; congruence); lia).
  split; [split; [exact St|]|split; [exact Op|exact Ea]]. destruct (rest_unstable w0 K1 a N2 St) as [R1 R2]. destruct (Rdichotomy K1 0 HK) as [L|L]; [now apply R2|now apply R1].
Qed.
End Phase.
