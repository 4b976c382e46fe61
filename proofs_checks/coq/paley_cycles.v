(* Paley et al., evenly turned circular formations on a cycle under (22): exponentially stable up to rotation and translation iff K_1 cos(2 pi m/N) < 0,
   unstable where K_1 cos(2 pi m/N) > 0.
   V = K_0 S - K_1 w0^-2 W_1 does not increase, and at the formation it is no minimum unless K_1 cos < 0: two neighbours that turn apart by +-b make it
   less where K_1 cos >= 0 and K_1 is not 0, to the third order in b if the cosine is 0.  A motion that starts so keeps away from the formation.  Where
   K_1 cos > 0 and it stays near, the gradient of W_1 tends to 0 along it, and is so only at the formation, where V is larger than at the start.
   Motions under (22) last: the control that is cut off where |L_k r| is large has V as well.
     beyond.paley.cyclic_patterns. *)
From Coq Require Import Reals Lra Lia Psatz ZArith Classical.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums inclusions paley_model paley_phase paley_laplacian paley_gradient paley_particles paley_fourier paley_convergence paley_settling paley_formations.
From Flockproof Require tanner2_lasting.
Open Scope R_scope.

(* ---- from every start there is a motion under (22) for all t >= 0 ---- *)
Definition begins n (r : nat -> R -> C) (th : nat -> R -> R) (r0 : nat -> C) (th0 : nat -> R) := forall k, (k < n)%nat -> r k 0 = r0 k /\ th k 0 = th0 k.
Definition lasts n adj w0 K0 K1 := forall r0 th0, exists r th, begins n r th r0 th0 /\ shaped n adj w0 K0 K1 r th.
Lemma gW_le n adj th k : (k < n)%nat -> Rabs (gW n adj th k) <= INR n.
Proof.
  intros Hk. rewrite gW_sines by exact Hk. eapply Rle_trans; [apply Sum_Rabs|]. rewrite <- (Rmult_1_r (INR n)), <- Sum_const. apply Sum_le. intros j _.
  pose proof (SIN_bound (th k - th j)). unfold w. destruct (adj k j); apply Rabs_le; lra.
Qed.
Lemma aS_sum n adj w0 r th k : aS n adj w0 r th k =
  Sum n (fun j => lap n adj k j * (cos (th k) * (fst (r j) - / w0 * sin (th j)) + sin (th k) * (snd (r j) + / w0 * cos (th j)))).
Proof.
  unfold aS. rewrite inner_row. apply Sum_ext. intros j _. f_equal. rewrite inner_xy. unfold centres, circle_centre, expi. cbn. ring.
Qed.
Lemma cut_sign K0 B a X : 0 < K0 -> 0 <= B -> Rabs X <= K0 * B -> 0 <= (K0 * a + X) * (K0 * tanner2_lasting.cut B a + X).
Proof.
  intros HK HB HX. apply Rabs_le_between in HX. destruct (Rle_or_lt (Rabs a) B) as [L|L].
  - rewrite tanner2_lasting.cut_id by exact L. pose proof (pow2_ge_0 (K0 * a + X)). nra.
  - unfold tanner2_lasting.cut. destruct (Rle_or_lt 0 a) as [G|G].
    + rewrite Rabs_pos_eq in L by exact G. rewrite Rmin_left, Rmax_right by lra. apply Rmult_le_pos; nra.
    + rewrite Rabs_left in L by exact G. rewrite Rmin_right, Rmax_left by lra. assert (Q : 0 <= - (K0 * a + X) * - (K0 * - B + X)) by (apply Rmult_le_pos; nra). nra.
Qed.
Section Starts.
Variables (n : nat) (adj : graph) (w0 K0 K1 : R).
Hypotheses (Hn : (1 <= n)%nat) (HS : undirected adj) (Hw : w0 <> 0) (HK : 0 < K0).
Let nn : 0 < INR n. Proof. exact (INR_pos n Hn). Qed.
Definition spot (y : nat -> R) (k : nat) : C := (y k, y (n + k)%nat).
Definition head (y : nat -> R) (k : nat) : R := y (2 * n + k)%nat.
Definition limited (B : R) (y : nat -> R) (k : nat) : R :=
  w0 + K1 / INR n * gW n adj (head y) k + w0 * (K0 / INR n * tanner2_lasting.cut B (aS n adj w0 (spot y) (head y) k)).
Definition limited_field (B : R) (y : nat -> R) (k : nat) : R :=
  if Nat.ltb k n then cos (head y k) else if Nat.ltb k (2 * n) then sin (head y (k - n)) else limited B y (k - 2 * n).
Lemma limited_bounded B : 0 <= B -> exists M, forall y k, (k < 3 * n)%nat -> Rabs (limited_field B y k) <= M.
Proof.
  intros HB. exists (1 + (Rabs w0 + Rabs (K1 / INR n) * INR n + Rabs w0 * (Rabs (K0 / INR n) * B))). intros y k Hk.
  pose proof (Rabs_pos w0) as A1. pose proof (Rabs_pos (K1 / INR n)) as A2. pose proof (Rabs_pos (K0 / INR n)) as A3.
  assert (P1 : 0 <= Rabs (K1 / INR n) * INR n) by (apply Rmult_le_pos; lra). assert (P2 : 0 <= Rabs w0 * (Rabs (K0 / INR n) * B)) by (repeat apply Rmult_le_pos; lra).
  unfold limited_field. destruct (Nat.ltb_spec k n).
  { pose proof (COS_bound (head y k)). apply Rabs_le. lra. }
  destruct (Nat.ltb_spec k (2 * n)).
  { pose proof (SIN_bound (head y (k - n))). apply Rabs_le. lra. }
  unfold limited. eapply Rle_trans; [apply Rabs_triang|]. rewrite !Rabs_mult.
  assert (Q1 : Rabs (w0 + K1 / INR n * gW n adj (head y) (k - 2 * n)) <= Rabs w0 + Rabs (K1 / INR n) * INR n).
  { eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_mult. apply Rplus_le_compat_l, Rmult_le_compat_l; [exact A2|]. apply gW_le. lia. }
  assert (Q2 : Rabs w0 * (Rabs (K0 / INR n) * Rabs (tanner2_lasting.cut B (aS n adj w0 (spot y) (head y) (k - 2 * n)))) <= Rabs w0 * (Rabs (K0 / INR n) * B)).
  { apply Rmult_le_compat_l; [exact A1|]. apply Rmult_le_compat_l; [exact A3|]. now apply tanner2_lasting.cut_in. }
  lra.
Qed.
Lemma limited_continuous B y : continuous_at (3 * n) (limited_field B) y.
Proof.
  assert (Cc : forall k, (2 * n + k < 3 * n)%nat -> tanner2_lasting.cont (3 * n) (fun y => cos (head y k)) y).
  { intros k Hk. apply (tanner2_lasting.cont_comp _ cos (fun y => head y k)); [apply continuity_cos|now apply tanner2_lasting.cont_coord]. }
  assert (Cs : forall k, (2 * n + k < 3 * n)%nat -> tanner2_lasting.cont (3 * n) (fun y => sin (head y k)) y).
  { intros k Hk. apply (tanner2_lasting.cont_comp _ sin (fun y => head y k)); [apply continuity_sin|now apply tanner2_lasting.cont_coord]. }
  apply tanner2_lasting.cont_at. intros k Hk. unfold limited_field. destruct (Nat.ltb_spec k n); [apply Cc; lia|]. destruct (Nat.ltb_spec k (2 * n)); [apply Cs; lia|].
  set (i := (k - 2 * n)%nat). assert (Hi : (i < n)%nat) by (unfold i; lia). unfold limited. apply tanner2_lasting.cont_plus; [apply tanner2_lasting.cont_plus; [apply tanner2_lasting.cont_const|]|].
  - apply tanner2_lasting.cont_scal. apply (tanner2_lasting.cont_ext _ (fun y => Sum n (fun j => w adj i j * sin (head y i - head y j)))); [intros z; symmetry; now apply gW_sines|].
    apply (tanner2_lasting.cont_Sum _ n (fun j y => w adj i j * sin (head y i - head y j))). intros j Hj. apply tanner2_lasting.cont_scal.
    apply (tanner2_lasting.cont_comp _ sin (fun y => head y i - head y j)); [apply continuity_sin|]. apply tanner2_lasting.cont_minus; apply tanner2_lasting.cont_coord; lia.
  - apply tanner2_lasting.cont_scal, tanner2_lasting.cont_scal. apply (tanner2_lasting.cont_comp _ (tanner2_lasting.cut B) (fun y => aS n adj w0 (spot y) (head y) i)).
    { apply tanner2_lasting.lipschitz_continuous, tanner2_lasting.cut_gap. }
    apply (tanner2_lasting.cont_ext _ (fun y => Sum n (fun j => lap n adj i j * (cos (head y i) * (y j - / w0 * sin (head y j)) + sin (head y i) * (y (n + j)%nat + / w0 * cos (head y j)))))).
    { intros z. symmetry. apply aS_sum. }
    apply (tanner2_lasting.cont_Sum _ n (fun j y => lap n adj i j * (cos (head y i) * (y j - / w0 * sin (head y j)) + sin (head y i) * (y (n + j)%nat + / w0 * cos (head y j))))).
    intros j Hj. apply tanner2_lasting.cont_scal, tanner2_lasting.cont_plus; apply tanner2_lasting.cont_mult.
    + apply Cc. lia.
    + apply tanner2_lasting.cont_minus; [apply tanner2_lasting.cont_coord; lia|apply tanner2_lasting.cont_scal, Cs; lia].
    + apply Cs. lia.
    + apply tanner2_lasting.cont_plus; [apply tanner2_lasting.cont_coord; lia|apply tanner2_lasting.cont_scal, Cc; lia].
Qed.
Definition energy (r : nat -> C) (th : nat -> R) : R := K0 * spacing n adj w0 r th - K1 / w0 ^ 2 * W1 n adj th.
Lemma limited_rate B (r : nat -> R -> C) (th : nat -> R -> R) t : 0 <= B -> Rabs (K1 * / w0) * INR n <= K0 * B ->
  (forall k, (k < n)%nat -> is_velocity (r k) t (expi (th k t))) ->
  (forall k, (k < n)%nat -> is_derive (th k) t (w0 + K1 / INR n * gW n adj (fun k => th k t) k + w0 * (K0 / INR n * tanner2_lasting.cut B (aS n adj w0 (fun k => r k t) (fun k => th k t) k)))) ->
  exists l, is_derive (fun s => energy (fun k => r k s) (fun k => th k s)) t l /\ l <= 0.
Proof.
  intros HB Big R1 R2. set (a := aS n adj w0 (fun k => r k t) (fun k => th k t)) in *. set (b := gW n adj (fun k => th k t)) in *.
  set (u := fun k => w0 + K1 / INR n * b k + w0 * (K0 / INR n * tanner2_lasting.cut B (a k))).
  exists (- / INR n ^ 2 * Sum n (fun k => (K0 * a k + K1 * / w0 * b k) * (K0 * tanner2_lasting.cut B (a k) + K1 * / w0 * b k))). split.
  - eapply D_eq; [apply D_minus; apply D_scal; [apply (eq19 n adj w0 Hn HS r th u t R1 R2)|apply (W1_along n adj th u t Hn HS R2)]|].
    pose proof (gW_sum n adj (fun k => th k t) HS) as G. fold a. fold b. fold b in G.
    transitivity (/ INR n * Sum n (fun k => K0 * (a k * (1 - / w0 * u k)) - K1 / w0 ^ 2 * (u k * b k)) + K1 / w0 / INR n * Sum n b).
    + rewrite Sum_minus, !Sum_scal, G. ring.
    + rewrite <- !Sum_scal, <- Sum_plus. apply Sum_ext; intros k Hk. unfold u. field. split; lra.
  - assert (0 <= Sum n (fun k => (K0 * a k + K1 * / w0 * b k) * (K0 * tanner2_lasting.cut B (a k) + K1 * / w0 * b k))).
    { apply Sum_ge0. intros k Hk. apply cut_sign; [exact HK|exact HB|]. rewrite Rabs_mult. eapply Rle_trans; [|exact Big]. apply Rmult_le_compat_l; [apply Rabs_pos|]. now apply gW_le. }
    assert (0 < / INR n ^ 2) by (apply Rinv_0_lt_compat, pow_lt, nn). nra.
Qed.
Lemma aS_small r th k : (k < n)%nat -> aS n adj w0 r th k ^ 2 <= 4 * INR n ^ 2 * spacing n adj w0 r th.
Proof.
  intros Hk. pose proof (lap2_le n adj (centres w0 r th) Hn HS) as L. unfold spacing. eapply Rle_trans; [|exact L].
  assert (Q : inner (row n (lap n adj) k (centres w0 r th)) (row n (lap n adj) k (centres w0 r th)) <= lap2 n adj (centres w0 r th)).
  { apply (Sum_term_le n (fun k => inner (row n (lap n adj) k (centres w0 r th)) (row n (lap n adj) k (centres w0 r th))) k); [|exact Hk]. intros j _. rewrite inner_xy. nra. }
  eapply Rle_trans; [|exact Q]. rewrite <- (along_across (th k)). unfold aS. pose proof (pow2_ge_0 (inner (Ci * expi (th k))%C (row n (lap n adj) k (centres w0 r th)))). lra.
Qed.
Lemma W1_range th : Rabs (K1 / w0 ^ 2 * W1 n adj th) <= Rabs (K1 / w0 ^ 2) * INR n.
Proof.
  pose proof (W1_bound n adj (fun k _ => th k) Hn HS 0) as [A B]. cbv beta in A, B. change (fun k => th k) with th in A, B. rewrite Rabs_mult. apply Rmult_le_compat_l; [apply Rabs_pos|]. now rewrite Rabs_pos_eq.
Qed.
Theorem motions_last : lasts n adj w0 K0 K1.
Proof.
  intros r0 th0. set (a := Rabs (K1 / w0 ^ 2) * INR n). set (e0 := energy r0 th0). set (x := 4 * INR n ^ 2 * ((e0 + a) / K0)). set (B := Rabs x + 1 + Rabs (K1 * / w0) * INR n / K0).
  pose proof (Rabs_pos x) as X0. assert (Y0 : 0 <= Rabs (K1 * / w0) * INR n / K0) by (apply Rdiv_le_0_compat; [apply Rmult_le_pos; [apply Rabs_pos|lra]|exact HK]).
  assert (HB : 1 <= B) by (unfold B; lra).
  assert (Big : Rabs (K1 * / w0) * INR n <= K0 * B).
  { replace (Rabs (K1 * / w0) * INR n) with (K0 * (Rabs (K1 * / w0) * INR n / K0)) by (field; lra). apply Rmult_le_compat_l; [lra|]. unfold B. lra. }
  destruct (limited_bounded B ltac:(lra)) as [M HM].
  set (y0 := fun k => if Nat.ltb k n then fst (r0 k) else if Nat.ltb k (2 * n) then snd (r0 (k - n)%nat) else th0 (k - 2 * n)%nat).
  destruct (peano (3 * n) (limited_field B) M y0 HM (limited_continuous B)) as (y & Y1 & Y2).
  set (r := fun k t => spot (y t) k). set (th := fun k t => head (y t) k). exists r, th.
  assert (St : begins n r th r0 th0).
  { intros k Hk. unfold r, th, spot, head. rewrite !Y1 by lia. unfold y0.
    destruct (Nat.ltb_spec k n); [|lia]. destruct (Nat.ltb_spec (n + k) n); [lia|]. destruct (Nat.ltb_spec (n + k) (2 * n)); [|lia].
    destruct (Nat.ltb_spec (2 * n + k) n); [lia|]. destruct (Nat.ltb_spec (2 * n + k) (2 * n)); [lia|]. replace (n + k - n)%nat with k by lia. replace (2 * n + k - 2 * n)%nat with k by lia.
    split; [now destruct (r0 k)|reflexivity]. }
  assert (V1 : forall k t, (k < n)%nat -> 0 <= t -> is_velocity (r k) t (expi (th k t))).
  { intros k t Hk Ht. split; cbn [fst snd expi].
    - apply (is_derive_ext (fun s => y s k)); [reflexivity|]. eapply D_eq; [apply Y2; [exact Ht|lia]|]. unfold limited_field. destruct (Nat.ltb_spec k n); [reflexivity|lia].
    - apply (is_derive_ext (fun s => y s (n + k)%nat)); [reflexivity|]. eapply D_eq; [apply Y2; [exact Ht|lia]|]. unfold limited_field. destruct (Nat.ltb_spec (n + k) n); [lia|].
      destruct (Nat.ltb_spec (n + k) (2 * n)); [|lia]. replace (n + k - n)%nat with k by lia. reflexivity. }
  assert (V2 : forall k t, (k < n)%nat -> 0 <= t -> is_derive (th k) t (limited B (y t) k)).
  { intros k t Hk Ht. apply (is_derive_ext (fun s => y s (2 * n + k)%nat)); [reflexivity|]. eapply D_eq; [apply Y2; [exact Ht|lia]|]. unfold limited_field.
    destruct (Nat.ltb_spec (2 * n + k) n); [lia|]. destruct (Nat.ltb_spec (2 * n + k) (2 * n)); [lia|]. now replace (2 * n + k - 2 * n)%nat with k by lia. }
  assert (En : forall t, 0 <= t -> energy (fun k => r k t) (fun k => th k t) <= e0).
  { intros t Ht. assert (E0 : energy (fun k => r k 0) (fun k => th k 0) = e0).
    { unfold e0, energy, spacing. f_equal.
      - f_equal. unfold Q. f_equal. apply Sum_ext. intros k Hk. unfold row, Csum, centres. destruct (St k Hk) as [-> ->]. f_equal.
        f_equal; apply Sum_ext; intros j Hj; destruct (St j Hj) as [-> ->]; reflexivity.
      - f_equal. rewrite !W1_arcs. f_equal. apply Sum_ext. intros k Hk. apply Sum_ext. intros j Hj. destruct (St k Hk) as [_ ->]. destruct (St j Hj) as [_ ->]. reflexivity. }
    rewrite <- E0. set (F := fun s => energy (fun k => r k s) (fun k => th k s)). change (F t <= F 0).
    assert (Dr : forall s, 0 <= s <= t -> is_derive F s (Derive F s) /\ Derive F s <= 0).
    { intros s Hs. destruct (limited_rate B r th s ltac:(lra) Big) as (l & Dl & Hl).
      - intros k Hk. apply V1; [exact Hk|lra].
      - intros k Hk. apply V2; [exact Hk|lra].
      - fold F in Dl. rewrite (is_derive_unique F s l Dl). now split. }
    apply (decreasing F (Derive F) 0 t Ht); intros s Hs; now apply Dr. }
  assert (As : forall k t, (k < n)%nat -> 0 <= t -> Rabs (aS n adj w0 (fun k => r k t) (fun k => th k t) k) <= B).
  { intros k t Hk Ht. apply sqr_Rabs; [lra|]. eapply Rle_trans; [now apply aS_small|]. specialize (En t Ht). unfold energy in En. pose proof (W1_range (fun k => th k t)) as Wr. fold a in Wr. apply Rabs_le_between in Wr.
    set (S := spacing n adj w0 (fun k => r k t) (fun k => th k t)) in *. assert (S1 : S <= (e0 + a) / K0).
    { apply Rmult_le_reg_l with K0; [exact HK|]. replace (K0 * ((e0 + a) / K0)) with (e0 + a) by (field; lra). lra. }
    apply Rle_trans with x; [unfold x; apply Rmult_le_compat_l; [nra|exact S1]|]. pose proof (Rle_abs x). assert (Rabs x + 1 <= B) by (unfold B; lra). nra. }
  split; [exact St|]. intros k t Hk Ht. split; [now apply V1|]. eapply D_eq; [now apply V2|]. unfold limited, control5. change (spot (y t)) with (fun k => r k t). change (head (y t)) with (fun k => th k t).
  now rewrite (tanner2_lasting.cut_id B _ (As k t Hk Ht)).
Qed.
End Starts.

(* ---- stability up to rotation and translation ---- *)
Definition exponentially_stable n adj w0 K0 K1 (phi : nat -> R) := exists e A q, 0 < e /\ 0 < A /\ 0 < q /\
  forall r th, shaped n adj w0 K0 K1 r th -> spread n w0 phi (fun k => r k 0) (fun k => th k 0) < e ->
    forall t, 0 <= t -> spread n w0 phi (fun k => r k t) (fun k => th k t) <= A * spread n w0 phi (fun k => r k 0) (fun k => th k 0) * exp (- q * t).
(* starts as near as one likes from which every motion goes away by e *)
Definition unstable n adj w0 K0 K1 (phi : nat -> R) := exists e, 0 < e /\ forall d, 0 < d -> exists r0 th0, spread n w0 phi r0 th0 < d /\
  forall r th, shaped n adj w0 K0 K1 r th -> begins n r th r0 th0 -> exists t, 0 <= t /\ e <= spread n w0 phi (fun k => r k t) (fun k => th k t).

Lemma dist2_expi a b : dist2 (expi a) (expi b) = 2 * (1 - cos (a - b)).
Proof. rewrite dist2_xy, cos_minus. unfold expi. cbn [fst snd]. pose proof (sc2 a). pose proof (sc2 b). nra. Qed.
Lemma spread_pair n w0 phi r th k j : (k < n)%nat -> (j < n)%nat -> 2 * (1 - cos (off phi th k - off phi th j)) <= spread n w0 phi r th.
Proof.
  intros Hk Hj. unfold off. rewrite <- dist2_expi. set (g := fun k j => dist2 (circle_centre w0 (r k) (th k)) (circle_centre w0 (r j) (th j)) + dist2 (expi (th k - phi k)) (expi (th j - phi j))).
  assert (G : forall k j, 0 <= g k j) by (intros a b; unfold g; pose proof (dist2_ge0 (circle_centre w0 (r a) (th a)) (circle_centre w0 (r b) (th b))); pose proof (dist2_ge0 (expi (th a - phi a)) (expi (th b - phi b))); lra).
  apply Rle_trans with (g k j); [unfold g; pose proof (dist2_ge0 (circle_centre w0 (r k) (th k)) (circle_centre w0 (r j) (th j))); lra|].
  apply Rle_trans with (Sum n (g k)); [apply (Sum_term_le n (g k) j); [intros; apply G|exact Hj]|].
  apply (Sum_term_le n (fun k => Sum n (g k)) k); [intros; apply Sum_ge0; intros; apply G|exact Hk].
Qed.
Lemma spread_ge0 n w0 phi r th : 0 <= spread n w0 phi r th.
Proof.
  apply Sum_ge0. intros k _. apply Sum_ge0. intros j _. pose proof (dist2_ge0 (circle_centre w0 (r k) (th k)) (circle_centre w0 (r j) (th j))).
  pose proof (dist2_ge0 (expi (th k - phi k)) (expi (th j - phi j))). lra.
Qed.
Lemma W1_gap n adj th phi : (1 <= n)%nat -> 2 * INR n * (W1 n adj th - W1 n adj phi) =
  Sum n (fun k => Sum n (fun j => w adj k j * (cos (phi j - phi k) - cos (th j - th k)))).
Proof.
  intros Hn. pose proof (INR_pos n Hn). rewrite !W1_arcs.
  replace (2 * INR n * (/ (2 * INR n) * Sum n (fun k => Sum n (fun j => w adj k j * (1 - cos (th j - th k)))) - / (2 * INR n) * Sum n (fun k => Sum n (fun j => w adj k j * (1 - cos (phi j - phi k))))))
    with (Sum n (fun k => Sum n (fun j => w adj k j * (1 - cos (th j - th k)))) - Sum n (fun k => Sum n (fun j => w adj k j * (1 - cos (phi j - phi k))))) by (field; lra).
  rewrite <- Sum_minus. apply Sum_ext. intros k _. rewrite <- Sum_minus. apply Sum_ext. intros j _. ring.
Qed.
Lemma W1_near n adj w0 phi r th : (1 <= n)%nat ->
  Rabs (W1 n adj th - W1 n adj phi) <= INR n * (spread n w0 phi r th + sqrt (spread n w0 phi r th)).
Proof.
  intros Hn. pose proof (INR_pos n Hn) as nn. set (D := spread n w0 phi r th). assert (D0 : 0 <= D) by apply spread_ge0. pose proof (sqrt_pos D) as S0.
  assert (X : Rabs (2 * INR n * (W1 n adj th - W1 n adj phi)) <= INR n * (INR n * (D + sqrt D))).
  { rewrite W1_gap by exact Hn. eapply Rle_trans; [apply Sum_Rabs|]. rewrite <- Sum_const. apply Sum_le. intros k Hk. eapply Rle_trans; [apply Sum_Rabs|]. rewrite <- Sum_const. apply Sum_le. intros j Hj.
    pose proof (spread_pair n w0 phi r th j k Hj Hk) as P. fold D in P. set (d := off phi th j - off phi th k) in *.
    replace (th j - th k) with ((phi j - phi k) + d) by (unfold d, off; ring). set (f := phi j - phi k). rewrite cos_plus.
    pose proof (COS_bound f) as C1. pose proof (SIN_bound f) as S1. pose proof (COS_bound d) as C2. pose proof (sc2 d) as Q.
    assert (Sd : Rabs (sin d) <= sqrt D) by (apply sqr_Rabs; [exact S0|]; rewrite pow2_sqrt by exact D0; nra). apply Rabs_le_between in Sd.
    assert (Y : Rabs (cos f - (cos f * cos d - sin f * sin d)) <= D + sqrt D).
    { replace (cos f - (cos f * cos d - sin f * sin d)) with (cos f * (1 - cos d) + sin f * sin d) by ring. apply Rabs_le. split; nra. }
    unfold w. destruct (adj k j); [now rewrite Rmult_1_l|]. rewrite Rmult_0_l, Rabs_R0. lra. }
  rewrite Rabs_mult, (Rabs_pos_eq (2 * INR n)) in X by lra. apply Rmult_le_reg_l with (2 * INR n); [lra|]. assert (0 <= INR n * (INR n * (D + sqrt D))) by (repeat apply Rmult_le_pos; lra). lra.
Qed.

(* ---- a motion that starts with less of V than the formation has keeps away from it ---- *)
Section Lower.
Variables (n : nat) (adj : graph) (w0 K0 K1 : R) (phi : nat -> R) (r : nat -> R -> C) (th : nat -> R -> R) (g : R).
Hypotheses (Hn : (1 <= n)%nat) (HS : undirected adj) (SC : strongly_connected n adj) (Hw : w0 <> 0) (HK : 0 < K0).
Hypothesis M : shaped n adj w0 K0 K1 r th.
Hypothesis Hg : 0 < g.
Hypothesis Low : VV n adj w0 K0 K1 r th 0 <= - K1 / w0 ^ 2 * W1 n adj phi - g.
Lemma stays_low t : 0 <= t -> g <= K1 / w0 ^ 2 * (W1 n adj (fun k => th k t) - W1 n adj phi).
Proof.
  intros Ht. pose proof (INR_pos n Hn) as nn.
  assert (D : VV n adj w0 K0 K1 r th t <= VV n adj w0 K0 K1 r th 0).
  { apply (decreasing (VV n adj w0 K0 K1 r th) (fun t => - (/ INR n ^ 2 * Sum n (fun k => ff n adj w0 K0 K1 r th k t ^ 2))) 0 t Ht); [intros; apply d_VV; try assumption; lra|]. intros s _.
    assert (0 <= Sum n (fun k => ff n adj w0 K0 K1 r th k s ^ 2)) by (apply Sum_ge0; intros; apply pow2_ge_0). assert (0 < / INR n ^ 2) by (apply Rinv_0_lt_compat, pow_lt, nn). nra. }
  unfold VV in D at 1. assert (Q0 : 0 <= Q n (lap n adj) (fun k => cc w0 r th k t)) by now apply Q_kernel.
  assert (0 <= K0 * Q n (lap n adj) (fun k => cc w0 r th k t)) by (apply Rmult_le_pos; lra).
  assert (E : - K1 / w0 ^ 2 * W1 n adj phi = - (K1 / w0 ^ 2 * W1 n adj phi)) by (field; exact Hw). lra.
Qed.
Lemma stays_off t : 0 <= t -> g <= Rabs (K1 / w0 ^ 2) * (INR n * (spread n w0 phi (fun k => r k t) (fun k => th k t) + sqrt (spread n w0 phi (fun k => r k t) (fun k => th k t)))).
Proof.
  intros Ht. pose proof (stays_low t Ht) as L. pose proof (W1_near n adj w0 phi (fun k => r k t) (fun k => th k t) Hn) as Nr.
  eapply Rle_trans; [exact L|]. eapply Rle_trans; [apply Rle_abs|]. rewrite Rabs_mult. apply Rmult_le_compat_l; [apply Rabs_pos|exact Nr].
Qed.
Lemma not_near : exists e, 0 < e /\ forall t, 0 <= t -> e <= spread n w0 phi (fun k => r k t) (fun k => th k t).
Proof.
  pose proof (INR_pos n Hn) as nn. set (kap := Rabs (K1 / w0 ^ 2) * INR n). assert (k0 : 0 <= kap) by (apply Rmult_le_pos; [apply Rabs_pos|lra]).
  set (s := Rmin 1 (g / (4 * (kap + 1)))). assert (Hs : 0 < s) by (apply Rmin_glb_lt; [lra|apply Rdiv_lt_0_compat; lra]). assert (s1 : s <= 1) by apply Rmin_l.
  assert (s2 : 2 * (kap + 1) * s <= g / 2).
  { apply Rle_trans with (2 * (kap + 1) * (g / (4 * (kap + 1)))); [apply Rmult_le_compat_l; [lra|apply Rmin_r]|right; field; lra]. }
  exists (s ^ 2). split; [nra|]. intros t Ht. apply Rnot_lt_le. intros L. pose proof (stays_off t Ht) as O. set (D := spread n w0 phi (fun k => r k t) (fun k => th k t)) in *.
  assert (D0 : 0 <= D) by apply spread_ge0. assert (R1 : sqrt D <= s) by (rewrite <- (sqrt_pow2 s) by lra; apply sqrt_le_1_alt; lra). pose proof (sqrt_pos D).
  assert (X : Rabs (K1 / w0 ^ 2) * (INR n * (D + sqrt D)) <= kap * (2 * s)).
  { rewrite <- Rmult_assoc. fold kap. apply Rmult_le_compat_l; [exact k0|]. nra. }
  nra.
Qed.
(* where W_1 is, near the formation, at least (at most, for K_1 < 0) as at the formation, and its gradient is 0 there only *)
Lemma goes_away : K1 <> 0 -> forall y0 c CC, 0 < CC -> (forall th, W1 n adj (off phi th) <= y0 ->
    c * W1 n adj (off phi th) <= - - K1 * (W1 n adj th - W1 n adj phi) <= CC * W1 n adj (off phi th) /\
    W1 n adj (off phi th) <= CC * Sum n (fun k => gW n adj th k ^ 2)) ->
  exists t, 0 <= t /\ y0 / INR n <= spread n w0 phi (fun k => r k t) (fun k => th k t).
Proof.
  intros HK1 y0 c CC HCC P. pose proof (INR_pos n Hn) as nn. apply NNPP. intros N.
  assert (Near : forall t, 0 <= t -> W1 n adj (off phi (fun k => th k t)) <= y0).
  { intros t Ht. set (D := spread n w0 phi (fun k => r k t) (fun k => th k t)). assert (L : D < y0 / INR n) by (apply Rnot_le_lt; intros L; apply N; now exists t).
    assert (D0 : 0 <= D) by apply spread_ge0. assert (nD : INR n * D < y0) by (apply (Rmult_lt_compat_l (INR n)) in L; [|exact nn]; replace (INR n * (y0 / INR n)) with y0 in L by (field; lra); exact L).
    rewrite W1_arcs. apply Rle_trans with (/ (2 * INR n) * (INR n * (INR n * D))); [|apply Rle_trans with (INR n * D); [|lra]].
    - apply Rmult_le_compat_l; [left; apply Rinv_0_lt_compat; lra|]. rewrite <- !Sum_const. apply Sum_le. intros k Hk. apply Sum_le. intros j Hj.
      pose proof (spread_pair n w0 phi (fun k => r k t) (fun k => th k t) j k Hj Hk) as Q. fold D in Q. pose proof (COS_bound (off phi (fun k => th k t) j - off phi (fun k => th k t) k)).
      unfold w. destruct (adj k j); lra.
    - replace (/ (2 * INR n) * (INR n * (INR n * D))) with (INR n * D / 2) by (field; lra). assert (0 <= INR n * D) by (apply Rmult_le_pos; lra). lra. }
  assert (Die : dies_out (fun t => Sum n (fun k => gW n adj (fun j => th j t) k ^ 2))).
  { apply (do_Sum n (fun k t => gW n adj (fun j => th j t) k ^ 2)). intros k Hk.
    assert (W : dies_out (ww n adj th k)).
    { apply (do_ext _ (fun t => w0 / K1 * (ff n adj w0 K0 K1 r th k t + (- K0) * gg n adj w0 r th k t))).
      - intros t _. unfold ff. field. now split.
      - apply do_scal, do_plus; [apply (f_dies n adj w0 K0 K1 r th); assumption|apply do_scal, (g_dies n adj w0 K0 K1 r th); assumption]. }
    apply (do_ext _ (fun t => ww n adj th k t * ww n adj th k t)); [intros t _; unfold ww; ring|]. apply do_mult; [exact W|apply (b_ww n adj th); assumption]. }
  assert (w2 : 0 < w0 ^ 2) by (apply pow2_gt_0; exact Hw).
  destruct (Die (g * w0 ^ 2 / (CC * CC)) ltac:(apply Rdiv_lt_0_compat; nra)) as (T & HT & Sm). specialize (Sm T ltac:(lra)).
  set (G := Sum n (fun k => gW n adj (fun j => th j T) k ^ 2)) in *. assert (G0 : 0 <= G) by (apply Sum_ge0; intros; apply pow2_ge_0). rewrite Rabs_pos_eq in Sm by exact G0.
  destruct (P (fun k => th k T) (Near T HT)) as [[_ P1] P2]. fold G in P2. pose proof (stays_low T HT) as L. set (Y := W1 n adj (off phi (fun k => th k T))) in *. set (X := W1 n adj (fun k => th k T) - W1 n adj phi) in *.
  assert (L' : g * w0 ^ 2 <= K1 * X).
  { apply (Rmult_le_compat_r (w0 ^ 2)) in L; [|lra]. replace (K1 / w0 ^ 2 * X * w0 ^ 2) with (K1 * X) in L by (field; exact Hw). exact L. }
  apply (Rmult_lt_compat_l (CC * CC)) in Sm; [|nra]. replace (CC * CC * (g * w0 ^ 2 / (CC * CC))) with (g * w0 ^ 2) in Sm by (field; lra).
  apply (Rmult_le_compat_l CC) in P2; [|lra]. lra.
Qed.
End Lower.

(* ---- on the cycle: two neighbours that turn apart ---- *)
Definition apart_by (b : R) (j : nat) : R := if Nat.eqb j 0 then - b else if Nat.eqb j 1 then b else 0.
Lemma Sum_three n i f : (2 <= i)%nat -> (i < n)%nat -> (forall k, (k < n)%nat -> k <> 0%nat -> k <> 1%nat -> k <> i -> f k = 0) -> Sum n f = f 0%nat + f 1%nat + f i.
Proof.
  intros Hi Hn Z. rewrite <- (Sum_delta_l n 0 f), <- (Sum_delta_l n 1 f), <- (Sum_delta_l n i f) by lia. rewrite <- !Sum_plus. apply Sum_ext. intros k Hk. unfold delta.
  destruct (Nat.eqb_spec 0 k) as [<-|N0]; [destruct (Nat.eqb_spec 1 0), (Nat.eqb_spec i 0); try lia; ring|].
  destruct (Nat.eqb_spec 1 k) as [<-|N1]; [destruct (Nat.eqb_spec i 1); try lia; ring|].
  destruct (Nat.eqb_spec i k) as [<-|N2]; [ring|]. rewrite Z by lia. ring.
Qed.
Lemma next_mod n k : (2 <= n)%nat -> (k < n)%nat -> ((k + 1) mod n = if Nat.eqb k (n - 1) then 0 else k + 1)%nat.
Proof.
  intros Hn Hk. destruct (Nat.eqb_spec k (n - 1)) as [->|N]; [replace (n - 1 + 1)%nat with n by lia; apply Nat.mod_same; lia|apply Nat.mod_small; lia].
Qed.
Lemma back_mod n k : (2 <= n)%nat -> (k < n)%nat -> ((k + (n - 1)) mod n = if Nat.eqb k 0 then n - 1 else k - 1)%nat.
Proof.
  intros Hn Hk. destruct (Nat.eqb_spec k 0) as [->|N]; [apply Nat.mod_small; lia|]. replace (k + (n - 1))%nat with ((k - 1) + 1 * n)%nat by lia. rewrite Nat.mod_add, Nat.mod_small; lia.
Qed.
Lemma cycle_gap n m b : (3 <= n)%nat -> let c := cos (turned_by n m 1) in let s := sin (turned_by n m 1) in
  INR n * (W1 n (cycle_graph n) (fun k => turned_by n m k + apart_by b k) - W1 n (cycle_graph n) (turned_by n m)) =
    c * (3 - 2 * cos b - cos (2 * b)) - 2 * s * sin b * (1 - cos b).
Proof.
  intros Hn c s. apply Rmult_eq_reg_l with 2; [|lra]. rewrite <- Rmult_assoc, W1_gap by lia. set (phi := turned_by n m). set (al := apart_by b).
  set (F := fun x => c * (1 - cos x) + s * sin x).
  destruct (turned_back n m ltac:(lia)) as [B1 B2].
  rewrite (Sum_ext n _ (fun k => F (al ((k + 1) mod n)%nat - al k) + F (al k - al ((k + (n - 1)) mod n)%nat))).
  2:{ intros k Hk. rewrite (Sum_ext n _ (fun j => w (ring_graph n) k j * (cos (phi j - phi k) - cos (phi j + al j - (phi k + al k))))).
      2:{ intros j Hj. f_equal. unfold w, cycle_graph. apply Nat.ltb_lt in Hk, Hj. now rewrite Hk, Hj. }
      rewrite (ring_neighbours n k (fun j => cos (phi j - phi k) - cos (phi j + al j - (phi k + al k))) Hn Hk).
      destruct (turned_step n m k 1 ltac:(lia) Hk ltac:(lia)) as [S1 C1]. destruct (turned_step n m k (n - 1) ltac:(lia) Hk ltac:(lia)) as [S2 C2]. rewrite B1 in S2. rewrite B2 in C2.
      fold s in S1, S2. fold c in C1, C2. fold phi in S1, C1, S2, C2. set (p := ((k + 1) mod n)%nat) in *. set (q := ((k + (n - 1)) mod n)%nat) in *. f_equal.
      - replace (phi p - phi k) with (- (phi k - phi p)) by ring. replace (phi p + al p - (phi k + al k)) with (al p - al k - (phi k - phi p)) by ring. rewrite cos_neg, (cos_minus (al p - al k) (phi k - phi p)), C1, S1. unfold F. ring.
      - replace (phi q - phi k) with (- (phi k - phi q)) by ring. replace (phi q + al q - (phi k + al k)) with (- (al k - al q) - (phi k - phi q)) by ring. rewrite cos_neg, (cos_minus (- (al k - al q)) (phi k - phi q)), cos_neg, sin_neg, C2, S2. unfold F. ring. }
  rewrite Sum_plus. assert (F0 : F 0 = 0) by (unfold F; rewrite cos_0, sin_0; ring).
  rewrite (Sum_three n (n - 1) (fun k => F (al ((k + 1) mod n)%nat - al k))); [|lia|lia|].
  2:{ intros k Hk N0 N1 N2. rewrite next_mod by lia. destruct (Nat.eqb_spec k (n - 1)); [lia|]. unfold al, apart_by.
      destruct (Nat.eqb_spec (k + 1) 0), (Nat.eqb_spec (k + 1) 1), (Nat.eqb_spec k 0), (Nat.eqb_spec k 1); try lia. now rewrite Rminus_eq_0. }
  rewrite (Sum_three n 2 (fun k => F (al k - al ((k + (n - 1)) mod n)%nat))); [|lia|lia|].
  2:{ intros k Hk N0 N1 N2. rewrite back_mod by lia. destruct (Nat.eqb_spec k 0); [lia|]. unfold al, apart_by.
      destruct (Nat.eqb_spec (k - 1) 0), (Nat.eqb_spec (k - 1) 1), (Nat.eqb_spec k 0), (Nat.eqb_spec k 1); try lia. now rewrite Rminus_eq_0. }
  rewrite !next_mod, !back_mod by lia. destruct (Nat.eqb_spec 0 (n - 1)), (Nat.eqb_spec 1 (n - 1)), (Nat.eqb_spec (n - 1) (n - 1)); try lia. cbn [Nat.eqb Nat.add Nat.sub].
  assert (A0 : al 0%nat = - b) by reflexivity. assert (A1 : al 1%nat = b) by reflexivity. assert (A2 : al 2%nat = 0) by reflexivity.
  assert (An : al (n - 1)%nat = 0) by (unfold al, apart_by; destruct (Nat.eqb_spec (n - 1) 0), (Nat.eqb_spec (n - 1) 1); try lia; reflexivity).
  rewrite ?A0, ?A1, ?A2, ?An. unfold F. replace (b - - b) with (2 * b) by ring. rewrite !Rminus_0_r, !Rminus_0_l. rewrite !cos_neg, !sin_neg, sin_2a. ring.
Qed.
(* starts with all centres in 0 *)
Definition placed (w0 : R) (th : nat -> R) (k : nat) : C := (RtoC (- / w0) * (Ci * expi (th k)))%C.
Lemma placed_centre w0 th k : circle_centre w0 (placed w0 th k) (th k) = RtoC 0.
Proof. unfold circle_centre, placed. apply injective_projections; cbn; ring. Qed.
Lemma placed_spread n w0 phi b : spread n w0 phi (placed w0 (fun k => phi k + apart_by b k)) (fun k => phi k + apart_by b k) <= INR n ^ 2 * (4 * b ^ 2) /\
  ((2 <= n)%nat -> cos (2 * b) < 1 -> 0 < spread n w0 phi (placed w0 (fun k => phi k + apart_by b k)) (fun k => phi k + apart_by b k)).
Proof.
  set (th := fun k => phi k + apart_by b k). split.
  - replace (INR n ^ 2 * (4 * b ^ 2)) with (Sum n (fun _ => Sum n (fun _ => 4 * b ^ 2))) by (rewrite !Sum_const; ring). unfold spread. apply Sum_le. intros k _. apply Sum_le. intros j _.
    change (placed w0 th k) with (placed w0 th k). rewrite !placed_centre. rewrite dist2_expi. unfold dist2. rewrite inner_xy. cbn [fst snd Cminus Cplus Copp RtoC].
    replace (th k - phi k - (th j - phi j)) with (apart_by b k - apart_by b j) by (unfold th; ring). set (x := apart_by b k - apart_by b j).
    assert (X : x ^ 2 <= 4 * b ^ 2) by (unfold x, apart_by; pose proof (pow2_ge_0 b); destruct (Nat.eqb k 0), (Nat.eqb j 0), (Nat.eqb k 1), (Nat.eqb j 1); nra).
    assert (Y : 2 * (1 - cos x) <= x ^ 2).
    { replace x with (2 * (x / 2)) at 1 by field. rewrite cos_2a_sin. assert (Z : Rabs (sin (x / 2)) <= Rabs (x / 2)).
      { assert (Mn : forall y, 0 <= y -> sin y <= y) by (intros y [Hy| <-]; [left; now apply sin_lt_x|rewrite sin_0; lra]).
        assert (Mp : forall y, 0 <= y -> Rabs (sin y) <= y).
        { intros y Hy. apply Rabs_le. split; [|now apply Mn]. destruct (Rle_or_lt y PI) as [L|L]; [pose proof (sin_ge_0 y Hy L); lra|]. pose proof (SIN_bound y). pose proof PI_RGT_0. pose proof PI2_1. lra. }
        destruct (Rle_or_lt 0 (x / 2)) as [G|G]; [rewrite (Rabs_pos_eq (x / 2)) by exact G; now apply Mp|].
        rewrite (Rabs_left (x / 2)) by exact G. rewrite <- Rabs_Ropp, <- sin_neg. apply Mp. lra. }
      assert (Z2 : sin (x / 2) ^ 2 <= (x / 2) ^ 2) by (rewrite <- (pow2_abs (sin (x / 2))), <- (pow2_abs (x / 2)); pose proof (Rabs_pos (sin (x / 2))); nra). nra. }
    lra.
  - intros Hn Hb. eapply Rlt_le_trans; [|apply (spread_pair n w0 phi _ _ 1 0); lia]. unfold off, th, apart_by. cbn [Nat.eqb].
    replace (phi 1%nat + b - phi 1%nat - (phi 0%nat + - b - phi 0%nat)) with (2 * b) by ring. lra.
Qed.
Lemma placed_energy n adj w0 K0 K1 r th th0 : (1 <= n)%nat -> begins n r th (placed w0 th0) th0 -> VV n adj w0 K0 K1 r th 0 = - (K1 / w0 ^ 2 * W1 n adj th0).
Proof.
  intros Hn St. unfold VV. assert (Z : forall k, (k < n)%nat -> cc w0 r th k 0 = RtoC 0) by (intros k Hk; unfold cc; destruct (St k Hk) as [-> ->]; apply placed_centre).
  assert (Q0 : Q n (lap n adj) (fun k => cc w0 r th k 0) = 0).
  { unfold Q. rewrite (Sum_ext n _ (fun _ => 0)); [rewrite Sum_0; ring|]. intros k Hk. rewrite (Z k Hk), inner_xy. cbn. ring. }
  assert (E : W1 n adj (fun k => th k 0) = W1 n adj th0).
  { rewrite !W1_arcs. f_equal. apply Sum_ext. intros k Hk. apply Sum_ext. intros j Hj. destruct (St k Hk) as [_ ->]. destruct (St j Hj) as [_ ->]. reflexivity. }
  rewrite Q0, E. ring.
Qed.
Lemma begins_spread n w0 phi r th r0 th0 : begins n r th r0 th0 -> spread n w0 phi (fun k => r k 0) (fun k => th k 0) = spread n w0 phi r0 th0.
Proof. intros St. apply Sum_ext. intros k Hk. apply Sum_ext. intros j Hj. destruct (St k Hk) as [-> ->]. destruct (St j Hj) as [-> ->]. reflexivity. Qed.
(* as near as one likes there are starts with less of V *)
Lemma low_starts n m w0 K1 d : (3 <= n)%nat -> w0 <> 0 -> K1 <> 0 -> 0 <= K1 * cos (turned_by n m 1) -> 0 < d ->
  exists b, let th0 := fun k => turned_by n m k + apart_by b k in spread n w0 (turned_by n m) (placed w0 th0) th0 < d /\
    0 < K1 / w0 ^ 2 * (W1 n (cycle_graph n) th0 - W1 n (cycle_graph n) (turned_by n m)).
Proof.
  intros Hn Hw HK1 Hc Hd. pose proof (INR_pos n ltac:(lia)) as nn. assert (w2 : 0 < w0 ^ 2) by (apply pow2_gt_0; exact Hw). pose proof PI2_1 as HP.
  set (c := cos (turned_by n m 1)) in *. set (s := sin (turned_by n m 1)). pose proof (sc2 (turned_by n m 1)) as CS. fold c s in CS.
  set (b0 := Rmin 1 (sqrt (d / (8 * INR n ^ 2)))). assert (X0 : 0 < d / (8 * INR n ^ 2)) by (apply Rdiv_lt_0_compat; nra). assert (X1 : 0 < sqrt (d / (8 * INR n ^ 2))) by now apply sqrt_lt_R0.
  assert (Hb0 : 0 < b0 <= 1) by (split; [apply Rmin_glb_lt; lra|apply Rmin_l]). assert (Sb : INR n ^ 2 * (4 * b0 ^ 2) < d).
  { assert (b0 ^ 2 <= d / (8 * INR n ^ 2)) by (rewrite <- (pow2_sqrt (d / (8 * INR n ^ 2))) by lra; assert (b0 <= sqrt (d / (8 * INR n ^ 2))) by apply Rmin_r; nra).
    apply Rle_lt_trans with (INR n ^ 2 * (4 * (d / (8 * INR n ^ 2)))); [apply Rmult_le_compat_l; [nra|lra]|]. replace (INR n ^ 2 * (4 * (d / (8 * INR n ^ 2)))) with (d / 2) by (field; lra). lra. }
  assert (Cb : cos b0 < 1). { rewrite <- cos_0. apply cos_decreasing_1; lra. } assert (Cb0 : 0 < cos b0) by (apply cos_gt_0; lra). assert (Sp : 0 < sin b0) by (apply sin_gt_0; lra).
  assert (C2b : cos (2 * b0) <= cos b0) by (rewrite cos_2a_cos; nra).
  set (b := if Rle_dec (K1 * s) 0 then b0 else - b0). exists b. cbv zeta.
  assert (Eb : b ^ 2 = b0 ^ 2 /\ cos b = cos b0 /\ cos (2 * b) = cos (2 * b0) /\ K1 * s * sin b <= 0 /\ (K1 * s <> 0 -> K1 * s * sin b < 0)).
  { unfold b. destruct (Rle_dec (K1 * s) 0) as [L|L].
    - repeat split; try reflexivity; nra.
    - replace (2 * - b0) with (- (2 * b0)) by ring. rewrite !cos_neg, sin_neg. repeat split; try reflexivity; nra. }
  destruct Eb as (E1 & E2 & E3 & E4 & E5). split.
  - eapply Rle_lt_trans; [apply placed_spread|]. now rewrite E1.
  - set (X := W1 n (cycle_graph n) (fun k => turned_by n m k + apart_by b k) - W1 n (cycle_graph n) (turned_by n m)).
    assert (G : INR n * X = c * (3 - 2 * cos b - cos (2 * b)) - 2 * s * sin b * (1 - cos b)) by (apply (cycle_gap n m b Hn)). rewrite E2, E3 in G.
    assert (KX : 0 < INR n * (K1 * X)).
    { replace (INR n * (K1 * X)) with (K1 * (INR n * X)) by ring. rewrite G. replace (K1 * (c * (3 - 2 * cos b0 - cos (2 * b0)) - 2 * s * sin b * (1 - cos b0))) with (K1 * c * (3 - 2 * cos b0 - cos (2 * b0)) + 2 * (- (K1 * s * sin b)) * (1 - cos b0)) by ring.
      assert (P1 : 0 <= K1 * c * (3 - 2 * cos b0 - cos (2 * b0))) by (apply Rmult_le_pos; lra). assert (P2 : 0 <= 2 * (- (K1 * s * sin b)) * (1 - cos b0)) by (apply Rmult_le_pos; lra).
      destruct (Req_dec c 0) as [Z|N].
      - assert (P3 : 0 < 2 * (- (K1 * s * sin b)) * (1 - cos b0)); [|lra]. apply Rmult_lt_0_compat; [|lra]. assert (s <> 0) by (intros Q; rewrite Z, Q in CS; lra). specialize (E5 ltac:(now apply Rmult_integral_contrapositive_currified)). lra.
      - assert (P3 : 0 < K1 * c * (3 - 2 * cos b0 - cos (2 * b0))); [|lra]. apply Rmult_lt_0_compat; [|lra]. assert (K1 * c <> 0) by now apply Rmult_integral_contrapositive_currified. lra. }
    replace (K1 / w0 ^ 2 * X) with (INR n * (K1 * X) / (INR n * w0 ^ 2)) by (field; lra). apply Rdiv_lt_0_compat; [exact KX|nra].
Qed.

(* ---- K_1 = 0: phases that keep their differences ---- *)
Lemma uncoupled n adj w0 K0 (th0 : nat -> R) : (1 <= n)%nat -> w0 <> 0 -> shaped n adj w0 K0 0 (fun k t => placed w0 (fun k => th0 k + w0 * t) k) (fun k t => th0 k + w0 * t).
Proof.
  intros Hn Hw k t Hk Ht. assert (D : is_derive (fun s => th0 k + w0 * s) t w0) by (eapply D_eq; [apply D_plus; [apply D_const|apply (D_scal w0 (fun s => s)), D_id]|ring]). split.
  - destruct (velocity_across _ t _ D) as [A B]. split; cbn [fst snd].
    + apply (is_derive_ext (fun s => - / w0 * fst (Ci * expi (th0 k + w0 * s))%C)); [intros s; unfold placed; cbn; ring|]. eapply D_eq; [apply D_scal, A|]. cbn. field. exact Hw.
    + apply (is_derive_ext (fun s => - / w0 * snd (Ci * expi (th0 k + w0 * s))%C)); [intros s; unfold placed; cbn; ring|]. eapply D_eq; [apply D_scal, B|]. cbn. field. exact Hw.
  - eapply D_eq; [exact D|]. unfold control5, aS. rewrite inner_row. rewrite Sum_zero; [unfold Rdiv; ring|]. intros j Hj. unfold centres. rewrite (placed_centre w0 (fun k => th0 k + w0 * t) j). rewrite inner_xy. cbn. ring.
Qed.

(* ---- the claim ---- *)
Lemma decay_dies (f : R -> R) A B q : 0 < q -> (forall t, 0 <= t -> f t <= A * B * exp (- q * t)) -> forall e, 0 < e -> exists t, 0 <= t /\ f t < e.
Proof. intros Hq H e He. destruct (exp_small q e (A * B) Hq He) as (T & HT & S). exists T. split; [exact HT|]. eapply Rle_lt_trans; [now apply H|]. apply S. lra. Qed.
Theorem patterns n m w0 K0 K1 : (3 <= n)%nat -> w0 <> 0 -> 0 < K0 ->
  (exponentially_stable n (cycle_graph n) w0 K0 K1 (turned_by n m) <-> K1 * cos (turned_by n m 1) < 0) /\
  (0 < K1 * cos (turned_by n m 1) -> unstable n (cycle_graph n) w0 K0 K1 (turned_by n m)).
Proof.
  intros Hn Hw HK. assert (H1 : (1 <= n)%nat) by lia. pose proof (cycle_undirected n) as HS. pose proof (cycle_connected n H1) as SC. pose proof (INR_pos n H1) as nn.
  assert (T1 : turned_by n m 1 = 2 * PI * INR m / INR n) by (unfold turned_by; cbn [INR]; f_equal; ring).
  (* what a start with less of V gives *)
  assert (Lw : forall b r th, let th0 := fun k => turned_by n m k + apart_by b k in let g := K1 / w0 ^ 2 * (W1 n (cycle_graph n) th0 - W1 n (cycle_graph n) (turned_by n m)) in
    begins n r th (placed w0 th0) th0 -> VV n (cycle_graph n) w0 K0 K1 r th 0 <= - K1 / w0 ^ 2 * W1 n (cycle_graph n) (turned_by n m) - g).
  { intros b r th th0 g St. rewrite (placed_energy n (cycle_graph n) w0 K0 K1 r th th0 H1 St). unfold g. right. field. exact Hw. }
  split; [split|].
  - intros (e & A & q & He & HA & Hq & St). apply Rnot_le_lt. intros Hc. destruct (Req_dec K1 0) as [Z|HK1].
    + subst K1. set (b := Rmin (1 / 2) (sqrt (e / (8 * INR n ^ 2)))). assert (X0 : 0 < e / (8 * INR n ^ 2)) by (apply Rdiv_lt_0_compat; nra). assert (X1 : 0 < sqrt (e / (8 * INR n ^ 2))) by now apply sqrt_lt_R0.
      assert (Hb : 0 < b <= 1 / 2) by (split; [apply Rmin_glb_lt; lra|apply Rmin_l]). pose proof PI2_1.
      destruct (placed_spread n w0 (turned_by n m) b) as [S1 S2]. set (th0 := fun k => turned_by n m k + apart_by b k) in *.
      specialize (S2 ltac:(lia)). assert (Cb : cos (2 * b) < 1) by (rewrite <- cos_0; apply cos_decreasing_1; lra). specialize (S2 Cb).
      assert (Sb : INR n ^ 2 * (4 * b ^ 2) < e).
      { assert (b ^ 2 <= e / (8 * INR n ^ 2)) by (rewrite <- (pow2_sqrt (e / (8 * INR n ^ 2))) by lra; assert (b <= sqrt (e / (8 * INR n ^ 2))) by apply Rmin_r; nra).
        apply Rle_lt_trans with (INR n ^ 2 * (4 * (e / (8 * INR n ^ 2)))); [apply Rmult_le_compat_l; [nra|lra]|]. replace (INR n ^ 2 * (4 * (e / (8 * INR n ^ 2)))) with (e / 2) by (field; lra). lra. }
      set (th := fun k t => th0 k + w0 * t). set (r := fun k t => placed w0 (fun k => th0 k + w0 * t) k).
      assert (Sp : forall t, spread n w0 (turned_by n m) (fun k => r k t) (fun k => th k t) = spread n w0 (turned_by n m) (placed w0 th0) th0).
      { intros t. apply Sum_ext. intros k _. apply Sum_ext. intros j _. unfold r, th. rewrite (placed_centre w0 (fun k => th0 k + w0 * t) k), (placed_centre w0 (fun k => th0 k + w0 * t) j), !placed_centre, !dist2_expi. do 4 f_equal. ring. }
      specialize (St r th (uncoupled n (cycle_graph n) w0 K0 th0 H1 Hw)). rewrite Sp in St. specialize (St ltac:(lra)).
      destruct (decay_dies (fun t => spread n w0 (turned_by n m) (fun k => r k t) (fun k => th k t)) _ _ q Hq St _ S2) as (t & Ht & L). cbv beta in L. rewrite Sp in L. lra.
    + destruct (low_starts n m w0 K1 e Hn Hw HK1 Hc He) as (b & S1 & S2). set (th0 := fun k => turned_by n m k + apart_by b k) in *.
      destruct (motions_last n (cycle_graph n) w0 K0 K1 H1 HS Hw HK (placed w0 th0) th0) as (r & th & Bg & Sh).
      destruct (not_near n (cycle_graph n) w0 K0 K1 (turned_by n m) r th _ H1 HS SC Hw HK Sh S2 (Lw b r th Bg)) as (e' & He' & Far).
      specialize (St r th Sh). rewrite (begins_spread n w0 _ r th _ _ Bg) in St. specialize (St S1). rewrite <- (begins_spread n w0 (turned_by n m) r th _ _ Bg) in St.
      destruct (decay_dies _ _ _ q Hq St e' He') as (t & Ht & L). specialize (Far t Ht). lra.
  - intros Hc. rewrite T1 in Hc. now apply cyclic_stable.
  - intros Hc. assert (HK1 : K1 <> 0) by (intros ->; rewrite Rmult_0_l in Hc; lra).
    assert (Sd : steady n (cycle_graph n) (- K1) (turned_by n m)) by (apply cycle_steady; [exact Hn|]; rewrite <- T1; lra).
    destruct (near_steady n (cycle_graph n) (- K1) (turned_by n m) H1 HS SC ltac:(lra) Sd) as (y0 & c & CC & Hy0 & Hcc & HCC & P).
    exists (y0 / INR n). split; [now apply Rdiv_lt_0_compat|]. intros d Hd. destruct (low_starts n m w0 K1 d Hn Hw HK1 ltac:(lra) Hd) as (b & S1 & S2). set (th0 := fun k => turned_by n m k + apart_by b k) in *.
    exists (placed w0 th0), th0. split; [exact S1|]. intros r th Sh Bg.
    exact (goes_away n (cycle_graph n) w0 K0 K1 (turned_by n m) r th _ H1 HS SC Hw HK Sh S2 (Lw b r th Bg) HK1 y0 c CC HCC P).
Qed.
(* m any integer *)
Definition pattern n (m : Z) (k : nat) : R := 2 * PI * IZR m * INR k / INR n.
Lemma expi_turns a z : expi (a + 2 * PI * IZR z) = expi a.
Proof.
  assert (P : forall a k, expi (a + 2 * INR k * PI) = expi a) by (intros x k; unfold expi; now rewrite cos_period, sin_period).
  destruct (Z.le_gt_cases 0 z) as [H|H].
  - rewrite <- (P a (Z.to_nat z)), INR_IZR_INZ, Z2Nat.id by exact H. f_equal. ring.
  - rewrite <- (P (a + 2 * PI * IZR z) (Z.to_nat (- z))), INR_IZR_INZ, Z2Nat.id, opp_IZR by lia. f_equal. ring.
Qed.
Lemma spread_turned n w0 phi psi r th : (forall k, (k < n)%nat -> exists z, phi k = psi k + 2 * PI * IZR z) -> spread n w0 phi r th = spread n w0 psi r th.
Proof.
  intros H. assert (E : forall k, (k < n)%nat -> expi (th k - phi k) = expi (th k - psi k)).
  { intros k Hk. destruct (H k Hk) as [z ->]. rewrite <- (expi_turns (th k - psi k) (- z)), opp_IZR. f_equal. ring. }
  apply Sum_ext. intros k Hk. apply Sum_ext. intros j Hj. now rewrite (E k Hk), (E j Hj).
Qed.
Lemma pattern_turned n m k : (1 <= n)%nat -> exists z, pattern n m k = turned_by n (Z.to_nat (m mod Z.of_nat n)) k + 2 * PI * IZR z.
Proof.
  intros Hn. pose proof (INR_pos n Hn) as nn. pose proof (Z.mod_pos_bound m (Z.of_nat n) ltac:(lia)) as Mb. exists (m / Z.of_nat n * Z.of_nat k)%Z. unfold pattern, turned_by.
  rewrite (INR_IZR_INZ (Z.to_nat _)), Z2Nat.id by lia. rewrite (Z.div_mod m (Z.of_nat n)) at 1 by lia. rewrite plus_IZR, !mult_IZR, <- !INR_IZR_INZ. field. lra.
Qed.
Lemma same_stable n adj w0 K0 K1 phi psi : (forall r th, spread n w0 phi r th = spread n w0 psi r th) -> exponentially_stable n adj w0 K0 K1 phi -> exponentially_stable n adj w0 K0 K1 psi.
Proof.
  intros E (e & A & q & He & HA & Hq & St). exists e, A, q. split; [exact He|]. split; [exact HA|]. split; [exact Hq|]. intros r th Sh S0 t Ht. rewrite <- E in S0. rewrite <- !E. now apply St.
Qed.
Theorem cyclic_patterns : forall n (m : Z) w0 K0 K1, (3 <= n)%nat -> w0 <> 0 -> 0 < K0 ->
  lasts n (cycle_graph n) w0 K0 K1 /\
  (exponentially_stable n (cycle_graph n) w0 K0 K1 (pattern n m) <-> K1 * cos (2 * PI * IZR m / INR n) < 0) /\
  (0 < K1 * cos (2 * PI * IZR m / INR n) -> unstable n (cycle_graph n) w0 K0 K1 (pattern n m)).
Proof.
  intros n m w0 K0 K1 Hn Hw HK. assert (H1 : (1 <= n)%nat) by lia. pose proof (INR_pos n H1) as nn. split; [apply motions_last; try assumption; apply cycle_undirected|].
  set (m' := Z.to_nat (m mod Z.of_nat n)). destruct (patterns n m' w0 K0 K1 Hn Hw HK) as [P1 P2].
  assert (E : forall r th, spread n w0 (pattern n m) r th = spread n w0 (turned_by n m') r th) by (intros; apply spread_turned; intros k _; now apply pattern_turned).
  assert (C : cos (2 * PI * IZR m / INR n) = cos (turned_by n m' 1)).
  { destruct (pattern_turned n m 1 H1) as [z Ez]. fold m' in Ez. replace (2 * PI * IZR m / INR n) with (pattern n m 1) by (unfold pattern; cbn [INR]; f_equal; ring). rewrite Ez.
    pose proof (f_equal fst (expi_turns (turned_by n m' 1) z)) as F. exact F. }
  rewrite C. split.
  - rewrite <- P1. split; apply same_stable; intros r th; [exact (E r th)|symmetry; exact (E r th)].
  - intros Hc. destruct (P2 Hc) as (e & He & U). exists e. split; [exact He|]. intros d Hd. destruct (U d Hd) as (r0 & th0 & S0 & F). exists r0, th0. split; [now rewrite E|].
    intros r th Sh Bg. destruct (F r th Sh Bg) as (t & Ht & L). exists t. split; [exact Ht|]. now rewrite E.
Qed.
