(* Paley et al., circular formations under (22) on a connected undirected graph: exponentially stable up to rotation and translation where their phases
   phi are stationary for W_1 and K_1 cos(phi_k - phi_j) < 0 along every edge; so the synchronized one for K_1 < 0, and evenly turned ones on cycles.
   V = K_0 S - K_1 w0^-2 (W_1 - W_1(phi)) is the square of a distance to these formations near them.  Its rate - sum f_k^2/N^2 vanishes at instants;
   V - d sum w0 f_k h_k + d' sum w0 h_k g_k, g_k and h_k the components of (L c)_k along and across the heading, decreases at a rate that is as large as itself.
     paley.sync.exp, paley.fig6.gain (corrected), paley.fig3.gain (corrected, clauses 1, 2). *)
From Coq Require Import Reals Lra Lia Psatz Relations Bool.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums inclusions paley_model paley_phase paley_laplacian paley_gradient paley_particles paley_fourier paley_convergence paley_settling.
From Flockproof Require tanner2_filippov.
Open Scope R_scope.

(* ---- sums ---- *)
Lemma lap_abs n adj k j : (1 <= n)%nat -> (k < n)%nat -> Rabs (lap n adj k j) <= INR n.
Proof.
  intros Hn Hk. assert (D : 0 <= deg n adj k <= INR n).
  { unfold deg. split; [apply Sum_ge0; intros; unfold w; destruct (adj k i); lra|]. apply Rle_trans with (Sum n (fun _ => 1)); [apply Sum_le; intros; unfold w; destruct (adj k i); lra|rewrite Sum_const; lra]. }
  assert (N1 : 1 <= INR n) by (apply (le_INR 1) in Hn; exact Hn). unfold lap, delta, w.
  destruct (Nat.eqb_spec k j) as [<-|Ne].
  - assert (W : (if adj k k then 1 else 0) <= deg n adj k).
    { apply (Sum_term_le n (w adj k) k); [|exact Hk]. intros i _. unfold w. destruct (adj k i); lra. }
    destruct (adj k k); apply Rabs_le; lra.
  - destruct (adj k j); apply Rabs_le; lra.
Qed.
Lemma Sum_trig n f c : (forall j, (j < n)%nat -> Rabs (c j) <= 1) -> Sum n (fun j => f j * c j) ^ 2 <= INR n * Sum n (fun j => f j ^ 2).
Proof.
  intros H. eapply Rle_trans; [apply Sum_sqr_le|]. apply Rmult_le_compat_l; [apply pos_INR|]. apply Sum_le. intros j Hj. specialize (H j Hj). apply Rabs_le_between in H.
  replace ((f j * c j) ^ 2) with (f j ^ 2 * c j ^ 2) by ring. pose proof (pow2_ge_0 (f j)). assert (c j ^ 2 <= 1) by nra. nra.
Qed.
(* a sum of products at most a multiple of squares *)
Lemma mixed a b e : 0 < e -> - (e * a ^ 2 + / (4 * e) * b ^ 2) <= a * b <= e * a ^ 2 + / (4 * e) * b ^ 2.
Proof.
  intros He.  assert (P : 0 <= e * (a - / (2 * e) * b) ^ 2) by (apply Rmult_le_pos; [lra|apply pow2_ge_0]). assert (M : 0 <= e * (a + / (2 * e) * b) ^ 2) by (apply Rmult_le_pos; [lra|apply pow2_ge_0]).
  replace (e * (a - / (2 * e) * b) ^ 2) with (e * a ^ 2 + / (4 * e) * b ^ 2 - a * b) in P by (field; lra).
  replace (e * (a + / (2 * e) * b) ^ 2) with (e * a ^ 2 + / (4 * e) * b ^ 2 + a * b) in M by (field; lra). lra.
Qed.

(* ---- near phases phi that are stationary for W_1, K_1 cos(phi_k - phi_j) < 0 along edges ---- *)
Definition steady n adj K1 (phi : nat -> R) := (forall k, (k < n)%nat -> gW n adj phi k = 0) /\
  forall k j, (k < n)%nat -> (j < n)%nat -> adj k j = true -> K1 * cos (phi k - phi j) < 0.
(* what the phases differ by, and its W_1 *)
Definition off (phi th : nat -> R) (k : nat) := th k - phi k.
Lemma chord_phases n adj : (1 <= n)%nat -> undirected adj -> strongly_connected n adj ->
  exists B, 0 < B /\ forall al k j, (k < n)%nat -> (j < n)%nat -> 2 * (1 - cos (al k - al j)) <= B * W1 n adj al.
Proof.
  intros Hn HS SC. destruct (spacing_proper n adj Hn HS SC) as [B [HB P]]. exists (B + 1). split; [lra|]. intros al k j Hk Hj.
  pose proof (W1_ge0 n adj al Hn). eapply Rle_trans with (B * W1 n adj al); [|nra]. eapply Rle_trans; [|apply (P (phasors al) k j Hk Hj)]. right.
  rewrite dist2_xy, cos_minus. unfold phasors, expi. cbn [fst snd]. pose proof (sc2 (al k)). pose proof (sc2 (al j)). nra.
Qed.
Lemma twice_W1 n adj al : (1 <= n)%nat -> undirected adj -> Sum n (fun k => Sum n (fun j => w adj k j * (1 - cos (al k - al j)))) = 2 * INR n * W1 n adj al.
Proof.
  intros Hn HS. pose proof (INR_pos n Hn). rewrite W1_arcs. rewrite (Sum_ext n _ (fun k => Sum n (fun j => w adj k j * (1 - cos (al j - al k))))).
  - field. lra.
  - intros k _. apply Sum_ext. intros j _. replace (al k - al j) with (- (al j - al k)) by ring. now rewrite cos_neg.
Qed.
(* sums over pairs *)
Lemma pairs_le n adj (x z : nat -> nat -> R) : (forall k j, (k < n)%nat -> (j < n)%nat -> adj k j = true -> x k j <= z k j) ->
  Sum n (fun k => Sum n (fun j => w adj k j * x k j)) <= Sum n (fun k => Sum n (fun j => w adj k j * z k j)).
Proof.
  intros H. apply Sum_le. intros k Hk. apply Sum_le. intros j Hj. unfold w. destruct (adj k j) eqn:E; [|lra]. specialize (H k j Hk Hj E). lra.
Qed.
Lemma pairs_scal n adj c (x : nat -> nat -> R) : Sum n (fun k => Sum n (fun j => w adj k j * (c * x k j))) = c * Sum n (fun k => Sum n (fun j => w adj k j * x k j)).
Proof. rewrite <- Sum_scal. apply Sum_ext. intros k _. rewrite <- Sum_scal. apply Sum_ext. intros j _. ring. Qed.
Lemma pairs_plus n adj (x z : nat -> nat -> R) : Sum n (fun k => Sum n (fun j => w adj k j * (x k j + z k j))) =
  Sum n (fun k => Sum n (fun j => w adj k j * x k j)) + Sum n (fun k => Sum n (fun j => w adj k j * z k j)).
Proof. rewrite <- Sum_plus. apply Sum_ext. intros k _. rewrite <- Sum_plus. apply Sum_ext. intros j _. ring. Qed.
Lemma pairs_row n adj phi (s : nat -> R) : undirected adj -> (forall k, (k < n)%nat -> gW n adj phi k = 0) ->
  Sum n (fun k => Sum n (fun j => w adj k j * (sin (phi k - phi j) * (s k - s j)))) = 0.
Proof.
  intros HS St. rewrite (Sum_ext n _ (fun k => Sum n (fun j => w adj k j * (sin (phi k - phi j) * s k)) + - Sum n (fun j => w adj k j * (sin (phi k - phi j) * s j)))).
  2:{ intros k _. rewrite <- Sum_opp, <- Sum_plus. apply Sum_ext. intros; ring. }
  rewrite Sum_plus, Sum_opp.
  assert (Z : Sum n (fun k => Sum n (fun j => w adj k j * (sin (phi k - phi j) * s k))) = 0).
  { apply Sum_zero. intros k Hk. rewrite (Sum_ext n _ (fun j => s k * (w adj k j * sin (phi k - phi j)))) by (intros; ring). rewrite Sum_scal, <- gW_sines, St by exact Hk. ring. }
  rewrite Z. rewrite Sum_swap. rewrite (Sum_ext n _ (fun k => - Sum n (fun j => w adj k j * (sin (phi k - phi j) * s k)))).
  - rewrite Sum_opp, Z. ring.
  - intros k _. rewrite <- Sum_opp. apply Sum_ext. intros j _. replace (w adj j k) with (w adj k j) by (unfold w; now rewrite HS). replace (phi j - phi k) with (- (phi k - phi j)) by ring. rewrite sin_neg. ring.
Qed.
Lemma near_steady n adj K1 phi : (1 <= n)%nat -> undirected adj -> strongly_connected n adj -> K1 <> 0 -> steady n adj K1 phi ->
  exists y0 c C, 0 < y0 /\ 0 < c /\ 0 < C /\ forall th, W1 n adj (off phi th) <= y0 ->
    c * W1 n adj (off phi th) <= - K1 * (W1 n adj th - W1 n adj phi) <= C * W1 n adj (off phi th) /\
    W1 n adj (off phi th) <= C * Sum n (fun k => gW n adj th k ^ 2).
Proof.
  intros Hn HS SC HK1 [St Ed]. pose proof (INR_pos n Hn) as Pn. assert (N1 : 1 <= INR n) by (apply (le_INR 1) in Hn; exact Hn).
  destruct (chord_phases n adj Hn HS SC) as (B & HB & Ch).
  destruct (tanner2_filippov.small2 n (fun k j d => adj k j = true -> d <= - K1 * cos (phi k - phi j))) as (c0 & Hc0 & Least).
  { intros k j d d' H Hd A. specialize (H A). lra. }
  { intros k j Hk Hj. destruct (adj k j) eqn:A; [|exists 1; split; [lra|discriminate]]. exists (- K1 * cos (phi k - phi j)). specialize (Ed k j Hk Hj A). split; [lra|intros _; lra]. }
  set (K := Rabs K1). assert (HKp : 0 < K) by (unfold K; now apply Rabs_pos_lt).
  set (rho := Rmin 1 (Rmin (c0 / (4 * K)) (c0 / (K * INR n * B)))).
  assert (KnB : 0 < K * INR n * B) by (apply Rmult_lt_0_compat; [now apply Rmult_lt_0_compat|exact HB]).
  assert (Hrho : 0 < rho) by (unfold rho; repeat apply Rmin_glb_lt; try lra; apply Rdiv_lt_0_compat; lra).
  assert (R1 : rho <= 1) by apply Rmin_l. assert (R2 : 4 * K * rho <= c0).
  { apply Rle_trans with (4 * K * (c0 / (4 * K))); [apply Rmult_le_compat_l; [lra|]; unfold rho; eapply Rle_trans; [apply Rmin_r|apply Rmin_l]|right; field; lra]. }
  assert (R3 : K * INR n * B * rho <= c0).
  { apply Rle_trans with (K * INR n * B * (c0 / (K * INR n * B))); [apply Rmult_le_compat_l; [lra|]; unfold rho; eapply Rle_trans; [apply Rmin_r|apply Rmin_r]|right; field; repeat split; lra]. }
  set (y0 := rho ^ 2 / B). set (CG := 4 * K ^ 2 * B / c0 ^ 2).
  exists y0, (c0 / 2), (K + c0 + CG). assert (HCG : 0 < CG) by (unfold CG; apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat; nra|nra]).
  split; [unfold y0; apply Rdiv_lt_0_compat; nra|]. split; [lra|]. split; [lra|]. intros th Near. set (al := off phi th) in *. set (Y := W1 n adj al) in *.
  assert (Y0 : 0 <= Y) by now apply W1_ge0.
  assert (BY : B * Y <= rho ^ 2). { apply Rle_trans with (B * (rho ^ 2 / B)); [apply Rmult_le_compat_l; [lra|exact Near]|right; field; lra]. }
  set (a := fun k => al k - al 0%nat). set (s := fun k => sin (a k)).
  assert (Ca : forall k, (k < n)%nat -> 0 <= 2 * (1 - cos (a k)) <= B * Y).
  { intros k Hk. split; [pose proof (COS_bound (a k)); lra|]. apply (Ch al k 0%nat Hk). lia. }
  assert (Sa : forall k, (k < n)%nat -> Rabs (s k) <= rho /\ s k ^ 2 <= B * Y).
  { intros k Hk. specialize (Ca k Hk). assert (Q : s k ^ 2 <= 2 * (1 - cos (a k))) by (unfold s; pose proof (sc2 (a k)); pose proof (COS_bound (a k)); nra). split; [apply sqr_Rabs; lra|lra]. }
  assert (Wk : forall k j, 0 <= w adj k j <= 1) by (intros; unfold w; destruct (adj k j); lra).
  assert (Dl : forall k j, th k - th j = (phi k - phi j) + (al k - al j)) by (intros; unfold al, off; ring).
  assert (Ab : forall k j, al k - al j = a k - a j) by (intros; unfold a; ring).
  assert (Kc : forall k j, - K1 * cos (phi k - phi j) <= K).
  { intros k j. pose proof (COS_bound (phi k - phi j)). unfold K. pose proof (Rle_abs K1). pose proof (Rle_abs (- K1)). rewrite Rabs_Ropp in *. destruct (Rle_or_lt 0 K1); nra. }
  assert (D0 : forall k j, 0 <= 1 - cos (al k - al j)) by (intros; pose proof (COS_bound (al k - al j)); lra).
  pose proof (twice_W1 n adj al Hn HS) as TY. fold Y in TY.
  split.
  - assert (E : 2 * INR n * (- K1 * (W1 n adj th - W1 n adj phi)) = Sum n (fun k => Sum n (fun j => w adj k j * (- K1 * cos (phi k - phi j) * (1 - cos (al k - al j))))) +
      - K1 * Sum n (fun k => Sum n (fun j => w adj k j * (sin (phi k - phi j) * (sin (al k - al j) - (s k - s j)))))).
    { transitivity (- K1 * (2 * INR n * W1 n adj th - 2 * INR n * W1 n adj phi)); [ring|]. rewrite <- !twice_W1 by assumption.
      rewrite <- pairs_scal, <- pairs_plus. pose proof (pairs_row n adj phi s HS St) as Z.
      transitivity (- K1 * (Sum n (fun k => Sum n (fun j => w adj k j * (cos (phi k - phi j) * (1 - cos (al k - al j)) + sin (phi k - phi j) * sin (al k - al j)))))).
      - f_equal. rewrite <- Sum_minus. apply Sum_ext. intros k _. rewrite <- Sum_minus. apply Sum_ext. intros j _. rewrite Dl, cos_plus. ring.
      - replace (Sum n (fun k => Sum n (fun j => w adj k j * (cos (phi k - phi j) * (1 - cos (al k - al j)) + sin (phi k - phi j) * sin (al k - al j))))) with
          (Sum n (fun k => Sum n (fun j => w adj k j * (cos (phi k - phi j) * (1 - cos (al k - al j)) + sin (phi k - phi j) * (sin (al k - al j) - (s k - s j))))) +
           Sum n (fun k => Sum n (fun j => w adj k j * (sin (phi k - phi j) * (s k - s j))))).
        + rewrite Z, Rplus_0_r, <- pairs_scal. apply Sum_ext. intros k _. apply Sum_ext. intros j _. ring.
        + rewrite <- pairs_plus. apply Sum_ext. intros k _. apply Sum_ext. intros j _. ring. }
    set (T1 := Sum n (fun k => Sum n (fun j => w adj k j * (- K1 * cos (phi k - phi j) * (1 - cos (al k - al j)))))) in *.
    set (T2 := Sum n (fun k => Sum n (fun j => w adj k j * (sin (phi k - phi j) * (sin (al k - al j) - (s k - s j)))))) in *.
    assert (A1 : c0 * (2 * INR n * Y) <= T1).
    { rewrite <- TY, <- pairs_scal. apply pairs_le. intros k j Hk Hj A. apply Rmult_le_compat_r; [apply D0|now apply Least]. }
    assert (A2 : T1 <= K * (2 * INR n * Y)).
    { rewrite <- TY, <- pairs_scal. apply pairs_le. intros k j Hk Hj A. apply Rmult_le_compat_r; [apply D0|apply Kc]. }
    assert (A3 : Rabs T2 <= INR n * (INR n * (rho * (B * Y)))).
    { unfold T2. eapply Rle_trans; [apply Sum_Rabs|]. rewrite <- Sum_const. apply Sum_le. intros k Hk. eapply Rle_trans; [apply Sum_Rabs|]. rewrite <- Sum_const. apply Sum_le. intros j Hj.
      rewrite Rabs_mult, (Rabs_pos_eq (w adj k j)) by apply Wk. rewrite Rabs_mult. specialize (Wk k j).
      assert (Q1 : Rabs (sin (phi k - phi j)) <= 1) by (apply Rabs_le, SIN_bound).
      assert (Q2 : Rabs (sin (al k - al j) - (s k - s j)) <= rho * (B * Y)).
      { rewrite Ab, sin_minus. fold (s k) (s j). replace (s k * cos (a j) - cos (a k) * s j - (s k - s j)) with (- (s k * (1 - cos (a j))) + s j * (1 - cos (a k))) by ring.
        destruct (Sa k Hk) as [S1 _]. destruct (Sa j Hj) as [S2 _]. destruct (Ca k Hk) as [C1 C2]. destruct (Ca j Hj) as [C3 C4].
        eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_Ropp, !Rabs_mult, (Rabs_pos_eq (1 - cos (a j))), (Rabs_pos_eq (1 - cos (a k))) by lra.
        assert (Rabs (s k) * (1 - cos (a j)) <= rho * (B * Y / 2)) by (apply Rmult_le_compat; try apply Rabs_pos; lra). assert (Rabs (s j) * (1 - cos (a k)) <= rho * (B * Y / 2)) by (apply Rmult_le_compat; try apply Rabs_pos; lra). lra. }
      pose proof (Rabs_pos (sin (phi k - phi j))). pose proof (Rabs_pos (sin (al k - al j) - (s k - s j))). assert (0 <= rho * (B * Y)) by (apply Rmult_le_pos; [lra|apply Rmult_le_pos; lra]).
      apply Rle_trans with (1 * (1 * (rho * (B * Y)))); [|lra]. apply Rmult_le_compat; try lra; [now apply Rmult_le_pos|]. apply Rmult_le_compat; lra. }
    assert (A4 : Rabs (- K1 * T2) <= c0 * (INR n * Y)).
    { rewrite Rabs_mult, Rabs_Ropp. fold K. apply Rle_trans with (K * (INR n * (INR n * (rho * (B * Y))))); [apply Rmult_le_compat_l; lra|].
      replace (K * (INR n * (INR n * (rho * (B * Y))))) with (K * INR n * B * rho * (INR n * Y)) by ring. apply Rmult_le_compat_r; [apply Rmult_le_pos; lra|exact R3]. }
    apply Rabs_le_between in A4. assert (0 <= INR n * Y) by (apply Rmult_le_pos; lra).
    assert (0 <= CG * (INR n * Y)) by (apply Rmult_le_pos; lra). assert (0 <= c0 * (INR n * Y)) by (apply Rmult_le_pos; lra).
    split; apply (Rmult_le_reg_l (2 * INR n)); [lra|rewrite E; lra|lra|rewrite E; lra].
  - set (Z := Sum n (fun k => gW n adj th k ^ 2)). assert (Z0 : 0 <= Z) by (apply Sum_ge0; intros; apply pow2_ge_0).
    assert (E : Sum n (fun k => s k * gW n adj th k) = / 2 * Sum n (fun k => Sum n (fun j => w adj k j * (sin (th k - th j) * (s k - s j))))).
    { set (T := Sum n (fun k => Sum n (fun j => w adj k j * (sin (th k - th j) * s k)))).
      assert (T1 : Sum n (fun k => s k * gW n adj th k) = T).
      { apply Sum_ext. intros k Hk. rewrite gW_sines by exact Hk. rewrite <- Sum_scal. apply Sum_ext. intros j _. ring. }
      assert (T2 : T = Sum n (fun k => Sum n (fun j => w adj k j * (sin (th k - th j) * - s j)))).
      { unfold T. rewrite Sum_swap. apply Sum_ext. intros k _. apply Sum_ext. intros j _. replace (w adj j k) with (w adj k j) by (unfold w; now rewrite HS).
        replace (th j - th k) with (- (th k - th j)) by ring. rewrite sin_neg. ring. }
      rewrite T1. replace T with (/ 2 * (T + T)) by field. f_equal. rewrite T2 at 2. unfold T. rewrite <- pairs_plus. apply Sum_ext. intros k _. apply Sum_ext. intros j _. ring. }
    assert (E2 : Sum n (fun k => Sum n (fun j => w adj k j * (- K1 * (sin (th k - th j) * (s k - s j))))) =
      Sum n (fun k => Sum n (fun j => w adj k j * (- K1 * cos (phi k - phi j) * (sin (al k - al j) * (s k - s j)) + - K1 * (sin (phi k - phi j) * (cos (al k - al j) - 1) * (s k - s j)))))).
    { transitivity (Sum n (fun k => Sum n (fun j => w adj k j * (- K1 * cos (phi k - phi j) * (sin (al k - al j) * (s k - s j)) + - K1 * (sin (phi k - phi j) * (cos (al k - al j) - 1) * (s k - s j))))) +
        - K1 * Sum n (fun k => Sum n (fun j => w adj k j * (sin (phi k - phi j) * (s k - s j))))).
      - rewrite <- pairs_scal, <- pairs_plus. apply Sum_ext. intros k _. apply Sum_ext. intros j _. rewrite Dl, sin_plus. ring.
      - rewrite (pairs_row n adj phi s HS St). ring. }
    assert (Lo : c0 * (INR n * Y) <= - K1 * (2 * Sum n (fun k => s k * gW n adj th k))).
    { rewrite E. replace (- K1 * (2 * (/ 2 * Sum n (fun k => Sum n (fun j => w adj k j * (sin (th k - th j) * (s k - s j))))))) with (- K1 * Sum n (fun k => Sum n (fun j => w adj k j * (sin (th k - th j) * (s k - s j))))) by field.
      rewrite <- pairs_scal, E2. replace (c0 * (INR n * Y)) with (c0 / 2 * (2 * INR n * Y)) by field. rewrite <- TY, <- pairs_scal. apply pairs_le. intros k j Hk Hj A.
      pose proof (Least k j Hk Hj A) as Lc. destruct (Ca k Hk) as [C1 C2]. destruct (Ca j Hj) as [C3 C4]. destruct (Sa k Hk) as [S1 _]. destruct (Sa j Hj) as [S2 _]. specialize (D0 k j). rewrite Ab in *.
      assert (X1 : sin (a k - a j) * (s k - s j) = (cos (a k) + cos (a j)) * (1 - cos (a k - a j))).
      { unfold s. rewrite sin_minus, cos_minus. pose proof (sc2 (a k)). pose proof (sc2 (a j)). set (ca := cos (a k)) in *. set (cb := cos (a j)) in *. set (sa := sin (a k)) in *. set (sb := sin (a j)) in *.
        replace ((sa * cb - ca * sb) * (sa - sb)) with (sa * sa * cb - sa * sb * (ca + cb) + sb * sb * ca) by ring.
        replace (sa * sa) with (1 - ca * ca) by lra. replace (sb * sb) with (1 - cb * cb) by lra. ring. }
      rewrite X1. assert (X2 : 1 <= cos (a k) + cos (a j)) by nra. set (D := 1 - cos (a k - a j)) in *. set (kc := - K1 * cos (phi k - phi j)) in *.
      assert (X3 : c0 * D <= kc * ((cos (a k) + cos (a j)) * D)).
      { replace (kc * ((cos (a k) + cos (a j)) * D)) with (kc * (cos (a k) + cos (a j)) * D) by ring. apply Rmult_le_compat_r; [lra|]. nra. }
      assert (X4 : Rabs (- K1 * (sin (phi k - phi j) * (cos (a k - a j) - 1) * (s k - s j))) <= K * (D * (2 * rho))).
      { rewrite Rabs_mult, Rabs_Ropp. fold K. apply Rmult_le_compat_l; [lra|]. rewrite !Rabs_mult. replace (Rabs (cos (a k - a j) - 1)) with D by (rewrite Rabs_left1; [unfold D; lra|pose proof (COS_bound (a k - a j)); lra]).
        assert (Rabs (sin (phi k - phi j)) <= 1) by (apply Rabs_le, SIN_bound). assert (Rabs (s k - s j) <= 2 * rho) by (unfold Rminus; eapply Rle_trans; [apply Rabs_triang|]; rewrite Rabs_Ropp; lra).
        pose proof (Rabs_pos (sin (phi k - phi j))). pose proof (Rabs_pos (s k - s j)). apply Rmult_le_compat; try lra; [apply Rmult_le_pos; lra|]. nra. }
      apply Rabs_le_between in X4. assert (K * (D * (2 * rho)) <= c0 / 2 * D) by nra. lra. }
    set (e := c0 / (4 * B)). assert (He : 0 < e) by (unfold e; apply Rdiv_lt_0_compat; lra).
    assert (Up : - K1 * Sum n (fun k => s k * gW n adj th k) <= INR n * (e * (B * Y)) + / (4 * e) * (K ^ 2 * Z)).
    { rewrite <- Sum_scal. unfold Z. rewrite <- !Sum_scal, <- Sum_const, <- Sum_plus. apply Sum_le. intros k Hk. destruct (Sa k Hk) as [_ S2].
      destruct (mixed (s k) (- K1 * gW n adj th k) e He) as [_ X]. replace (- K1 * (s k * gW n adj th k)) with (s k * (- K1 * gW n adj th k)) by ring. eapply Rle_trans; [exact X|].
      replace ((- K1 * gW n adj th k) ^ 2) with (K ^ 2 * gW n adj th k ^ 2) by (unfold K; rewrite pow2_abs; ring). apply Rplus_le_compat_r, Rmult_le_compat_l; lra. }
    assert (F1 : INR n * (e * (B * Y)) = c0 / 4 * (INR n * Y)) by (unfold e; field; lra). assert (F2 : / (4 * e) * (K ^ 2 * Z) = K ^ 2 * B / c0 * Z) by (unfold e; field; lra). rewrite F1, F2 in Up.
    assert (F3 : c0 / 4 * (INR n * Y) <= K ^ 2 * B / c0 * Z) by lra.
    assert (F4 : Y <= INR n * Y) by nra. assert (F5 : Y <= CG * Z).
    { apply Rmult_le_reg_l with (c0 / 4); [lra|]. replace (c0 / 4 * (CG * Z)) with (K ^ 2 * B / c0 * Z) by (unfold CG; field; lra). nra. }
    assert (0 <= (K + c0) * Z) by (apply Rmult_le_pos; lra). lra.
Qed.
Lemma gradient_small n adj K1 phi th : (1 <= n)%nat -> undirected adj -> steady n adj K1 phi -> Sum n (fun k => gW n adj th k ^ 2) <= 16 * INR n ^ 2 * W1 n adj (off phi th).
Proof.
  intros Hn HS [St _]. pose proof (INR_pos n Hn) as Pn. set (al := off phi th). replace (16 * INR n ^ 2 * W1 n adj al) with (8 * INR n * (2 * INR n * W1 n adj al)) by ring.
  rewrite <- (twice_W1 n adj al Hn HS), <- Sum_scal. apply Sum_le. intros k Hk.
  assert (E : gW n adj th k = Sum n (fun j => w adj k j * (sin (phi k - phi j) * (cos (al k - al j) - 1) + cos (phi k - phi j) * sin (al k - al j)))).
  { rewrite gW_sines by exact Hk. replace (Sum n (fun j => w adj k j * sin (th k - th j))) with (Sum n (fun j => w adj k j * sin (th k - th j)) - gW n adj phi k) by (rewrite (St k Hk); ring).
    rewrite gW_sines by exact Hk. rewrite <- Sum_minus. apply Sum_ext. intros j _. replace (th k - th j) with ((phi k - phi j) + (al k - al j)) by (unfold al, off; ring). rewrite sin_plus. ring. }
  rewrite E. eapply Rle_trans; [apply Sum_sqr_le|]. rewrite (Rmult_comm 8), Rmult_assoc. apply Rmult_le_compat_l; [lra|]. rewrite <- Sum_scal. apply Sum_le. intros j _.
  pose proof (sc2 (al k - al j)) as Q1. pose proof (COS_bound (al k - al j)) as Q2. pose proof (COS_bound (phi k - phi j)) as Q3. pose proof (SIN_bound (phi k - phi j)) as Q4.
  set (c := cos (al k - al j)) in *. set (s := sin (al k - al j)) in *. set (p := sin (phi k - phi j)) in *. set (q := cos (phi k - phi j)) in *.
  assert (X : (p * (c - 1) + q * s) ^ 2 <= 8 * (1 - c)).
  { assert (X1 : (p * (c - 1) + q * s) ^ 2 <= 2 * (p * (c - 1)) ^ 2 + 2 * (q * s) ^ 2) by (pose proof (pow2_ge_0 (p * (c - 1) - q * s)); nra).
    assert (X2 : (p * (c - 1)) ^ 2 <= (c - 1) ^ 2) by (rewrite Rpow_mult_distr; assert (p ^ 2 <= 1) by nra; pose proof (pow2_ge_0 (c - 1)); nra).
    assert (X3 : (q * s) ^ 2 <= s ^ 2) by (rewrite Rpow_mult_distr; assert (q ^ 2 <= 1) by nra; pose proof (pow2_ge_0 s); nra). nra. }
  unfold w. destruct (adj k j); nra.
Qed.

Section Decay.
Variables (n : nat) (adj : graph) (w0 K0 K1 B' : R) (phi : nat -> R) (y0 c CC : R).
Hypotheses (Hn : (1 <= n)%nat) (HS : undirected adj) (SC : strongly_connected n adj) (Hw : w0 <> 0) (HK : 0 < K0) (HK1 : K1 <> 0) (Sd : steady n adj K1 phi).
(* those of near_steady and le_lap2 *)
Hypotheses (Hy0 : 0 < y0) (Hc0 : 0 < c) (HCC : 0 < CC) (P : forall th, W1 n adj (off phi th) <= y0 ->
    c * W1 n adj (off phi th) <= - K1 * (W1 n adj th - W1 n adj phi) <= CC * W1 n adj (off phi th) /\
    W1 n adj (off phi th) <= CC * Sum n (fun k => gW n adj th k ^ 2)).
Hypotheses (HB' : 0 < B') (P' : forall c, Q n (lap n adj) c <= B' * lap2 n adj c).
Definition C_below := (2 * K0 ^ 2 + 1) * (4 * INR n ^ 2 / K0) + 2 * (K1 * / w0) ^ 2 * (16 * INR n ^ 2 * w0 ^ 2 / c).
Definition C_above := K0 * B' + CC ^ 2 / w0 ^ 2 * (2 * (w0 / K1) ^ 2) * (1 + K0 ^ 2).
Definition C_FH e := (w0 * K0) ^ 2 * / (4 * (K0 * w0 ^ 2 / 8)) * INR n ^ 2 + K1 ^ 2 * / (4 * (K0 * w0 ^ 2 / 8)) * (4 * w0 ^ 2) + ((3 / 2 * w0 ^ 2) ^ 2 * / (4 * e) + 1) + w0 ^ 2 * INR n ^ 2.
Section Motion.
Variables (r : nat -> R -> C) (th : nat -> R -> R).
Hypothesis M : shaped n adj w0 K0 K1 r th.
Notation f := (ff n adj w0 K0 K1 r th).
Notation g := (gg n adj w0 r th).
Notation h := (hh n adj w0 r th).
Notation u := (uu n adj w0 K0 K1 r th).
Notation p := (pp n adj w0 K0 K1 r th).
Notation q := (qq n adj w0 K0 K1 r th).
Notation y := (ww n adj th).
Notation y' := (ww' n adj w0 K0 K1 r th).
Definition V (t : R) := K0 * Q n (lap n adj) (fun k => cc w0 r th k t) + - K1 * (W1 n adj (fun k => th k t) - W1 n adj phi) / w0 ^ 2.
Definition Y (t : R) := W1 n adj (off phi (fun k => th k t)).
Definition sq (x : nat -> R -> R) (t : R) := Sum n (fun k => x k t ^ 2).
Let nn : 0 < INR n. Proof. exact (INR_pos n Hn). Qed.
Let n1 : 1 <= INR n. Proof. apply (le_INR 1). exact Hn. Qed.
Let w2 : 0 < w0 ^ 2. Proof. apply pow2_gt_0. exact Hw. Qed.
Lemma sq_ge0 x t : 0 <= sq x t. Proof. apply Sum_ge0. intros; apply pow2_ge_0. Qed.
Lemma sq_term x t k : (k < n)%nat -> x k t ^ 2 <= sq x t. Proof. intros Hk. apply (Sum_term_le n (fun k => x k t ^ 2) k); [intros; apply pow2_ge_0|exact Hk]. Qed.
Lemma p_small t : sq p t <= INR n ^ 2 * sq f t.
Proof.
  replace (INR n ^ 2 * sq f t) with (Sum n (fun _ => INR n * sq f t)) by (rewrite Sum_const; ring). apply Sum_le. intros k Hk. rewrite pp_is by assumption. apply Sum_trig. intros j Hj.
  pose proof (lap_abs n adj k j Hn Hk). pose proof (COS_bound (th j t - th k t)). rewrite !Rabs_mult, Rabs_Ropp, Rabs_inv, (Rabs_pos_eq (INR n)) by lra.
  assert (Rabs (lap n adj k j) * / INR n <= 1) by (apply Rmult_le_reg_r with (INR n); [lra|]; rewrite Rmult_assoc, Rinv_l by lra; lra).
  assert (Rabs (cos (th j t - th k t)) <= 1) by (apply Rabs_le; lra). pose proof (Rabs_pos (cos (th j t - th k t))).
  assert (0 <= Rabs (lap n adj k j) * / INR n) by (apply Rmult_le_pos; [apply Rabs_pos|left; apply Rinv_0_lt_compat; lra]). nra.
Qed.
Lemma q_small t : sq q t <= INR n ^ 2 * sq f t.
Proof.
  replace (INR n ^ 2 * sq f t) with (Sum n (fun _ => INR n * sq f t)) by (rewrite Sum_const; ring). apply Sum_le. intros k Hk. rewrite qq_is by assumption. apply Sum_trig. intros j Hj.
  pose proof (lap_abs n adj k j Hn Hk). pose proof (SIN_bound (th j t - th k t)). rewrite !Rabs_mult, Rabs_Ropp, Rabs_inv, (Rabs_pos_eq (INR n)) by lra.
  assert (Rabs (lap n adj k j) * / INR n <= 1) by (apply Rmult_le_reg_r with (INR n); [lra|]; rewrite Rmult_assoc, Rinv_l by lra; lra).
  assert (Rabs (sin (th j t - th k t)) <= 1) by (apply Rabs_le; lra). pose proof (Rabs_pos (sin (th j t - th k t))).
  assert (0 <= Rabs (lap n adj k j) * / INR n) by (apply Rmult_le_pos; [apply Rabs_pos|left; apply Rinv_0_lt_compat; lra]). nra.
Qed.
Lemma y'_small t : sq y' t <= 4 * w0 ^ 2 * sq f t.
Proof.
  set (A := sq f t). apply Rle_trans with (Sum n (fun k => 2 * w0 ^ 2 * f k t ^ 2 + 2 * w0 ^ 2 / INR n * A)).
  - apply Sum_le. intros k Hk. unfold ww'. eapply Rle_trans; [apply Sum_sqr_le|].
    replace (2 * w0 ^ 2 * f k t ^ 2 + 2 * w0 ^ 2 / INR n * A) with (INR n * Sum n (fun j => w0 ^ 2 / INR n ^ 2 * (2 * (f k t ^ 2 + f j t ^ 2)))).
    + apply Rmult_le_compat_l; [lra|]. apply Sum_le. intros j _. unfold uu.
      replace (w0 + w0 / INR n * f k t + -1 * (w0 + w0 / INR n * f j t)) with (w0 / INR n * (f k t - f j t)) by ring.
      replace ((w adj k j * (cos (th k t - th j t) * (w0 / INR n * (f k t - f j t)))) ^ 2) with (w adj k j ^ 2 * cos (th k t - th j t) ^ 2 * (w0 ^ 2 / INR n ^ 2 * (f k t - f j t) ^ 2)) by (field; lra).
      assert (C1 : 0 <= w adj k j ^ 2 * cos (th k t - th j t) ^ 2 <= 1).
      { pose proof (COS_bound (th k t - th j t)). pose proof (pow2_ge_0 (cos (th k t - th j t))). unfold w. destruct (adj k j); nra. }
      assert (C2 : 0 <= w0 ^ 2 / INR n ^ 2) by (apply Rdiv_le_0_compat; [lra|apply pow_lt; lra]).
      assert (C3 : (f k t - f j t) ^ 2 <= 2 * (f k t ^ 2 + f j t ^ 2)) by (pose proof (pow2_ge_0 (f k t + f j t)); nra).
      pose proof (pow2_ge_0 (f k t - f j t)). apply Rle_trans with (1 * (w0 ^ 2 / INR n ^ 2 * (f k t - f j t) ^ 2)); [apply Rmult_le_compat_r; [nra|lra]|]. rewrite Rmult_1_l. now apply Rmult_le_compat_l.
    + rewrite Sum_scal, (Sum_ext n _ (fun j => 2 * f k t ^ 2 + 2 * f j t ^ 2)) by (intros; ring). rewrite Sum_plus, Sum_const, Sum_scal. fold (sq f t). fold A. field. lra.
  - rewrite Sum_plus, Sum_const, Sum_scal. fold (sq f t). fold A. right. field. lra.
Qed.
(* V against the squares of g, h and f *)
Lemma V_is t : Y t <= y0 -> exists S X, 0 <= S /\ V t = K0 * S + X / w0 ^ 2 /\ c * Y t <= X <= CC * Y t /\ Y t <= CC * sq y t /\ sq g t + sq h t <= 4 * INR n ^ 2 * S /\ S <= B' * (sq g t + sq h t) /\ 0 <= Y t /\ sq y t <= 16 * INR n ^ 2 * Y t.
Proof.
  intros Near. destruct (P (fun k => th k t) Near) as [P1 P2]. exists (Q n (lap n adj) (fun k => cc w0 r th k t)), (- K1 * (W1 n adj (fun k => th k t) - W1 n adj phi)).
  assert (L2 : lap2 n adj (fun k => cc w0 r th k t) = sq g t + sq h t).
  { unfold sq, lap2. rewrite <- Sum_plus. apply Sum_ext. intros k _. symmetry. apply along_across. }
  split; [now apply Q_kernel|]. split; [reflexivity|]. split; [exact P1|]. split; [exact P2|]. split; [rewrite <- L2; now apply lap2_le|]. split; [rewrite <- L2; apply P'|].
  split; [now apply W1_ge0|]. exact (gradient_small n adj K1 phi (fun k => th k t) Hn HS Sd).
Qed.
Lemma V_below t : Y t <= y0 -> sq f t + sq g t + sq h t <= C_below * V t /\ Y t <= w0 ^ 2 / c * V t /\ 0 <= V t.
Proof.
  intros Near. destruct (V_is t Near) as (S & X & S0 & EV & [X1 X2] & Y1 & G1 & _ & Y0 & G2).
  assert (N2 : 1 <= INR n ^ 2) by nra. set (a := 4 * INR n ^ 2 / K0). set (b := 16 * INR n ^ 2 * w0 ^ 2 / c). assert (Ha : 0 < a) by (unfold a; apply Rdiv_lt_0_compat; nra). assert (Hb : 0 < b) by (unfold b; apply Rdiv_lt_0_compat; nra).
  set (k1 := 2 * K0 ^ 2 + 1). set (e := 2 * (K1 * / w0) ^ 2). assert (He : 0 <= e) by (unfold e; pose proof (pow2_ge_0 (K1 * / w0)); lra). assert (Hk1 : 1 <= k1) by (unfold k1; nra).
  assert (G3 : sq f t <= 2 * K0 ^ 2 * sq g t + e * sq y t).
  { unfold sq. rewrite <- !Sum_scal, <- Sum_plus. apply Sum_le. intros k _. unfold ff, e. set (z := K1 * / w0). pose proof (pow2_ge_0 (K0 * g k t - z * y k t)). nra. }
  assert (cY : 0 <= c * Y t) by (apply Rmult_le_pos; lra). assert (X0 : 0 <= X / w0 ^ 2) by (apply Rdiv_le_0_compat; lra). assert (KS : 0 <= K0 * S) by (apply Rmult_le_pos; lra).
  assert (aV : 4 * INR n ^ 2 * S <= a * V t).
  { rewrite EV. replace (a * (K0 * S + X / w0 ^ 2)) with (4 * INR n ^ 2 * S + a * (X / w0 ^ 2)) by (unfold a; field; repeat split; (exact Hw || lra)). assert (0 <= a * (X / w0 ^ 2)) by (apply Rmult_le_pos; lra). lra. }
  assert (yV : Y t <= w0 ^ 2 / c * V t).
  { rewrite EV. replace (w0 ^ 2 / c * (K0 * S + X / w0 ^ 2)) with (w0 ^ 2 / c * (K0 * S) + / c * X) by (field; repeat split; (exact Hw || lra)).
    assert (0 <= w0 ^ 2 / c * (K0 * S)) by (apply Rmult_le_pos; [left; apply Rdiv_lt_0_compat; lra|exact KS]). assert (Y t <= / c * X); [|lra].
    apply Rmult_le_reg_l with c; [exact Hc0|]. rewrite <- Rmult_assoc, Rinv_r by lra. lra. }
  assert (bV : 16 * INR n ^ 2 * Y t <= b * V t).
  { replace (b * V t) with (16 * INR n ^ 2 * (w0 ^ 2 / c * V t)) by (unfold b; field; lra). apply Rmult_le_compat_l; [lra|exact yV]. }
  pose proof (sq_ge0 h t) as H0. pose proof (sq_ge0 g t) as H1. assert (k1 * (sq g t + sq h t) <= k1 * (a * V t)) by (apply Rmult_le_compat_l; lra). assert (e * sq y t <= e * (b * V t)) by (apply Rmult_le_compat_l; lra).
  split; [unfold C_below; fold a b k1 e; unfold k1 in *; nra|]. split; [exact yV|]. rewrite EV. lra.
Qed.
Lemma C_positive : 0 < C_below /\ 0 < C_above.
Proof.
  assert (N2 : 1 <= INR n ^ 2) by nra. assert (0 < 4 * INR n ^ 2 / K0) by (apply Rdiv_lt_0_compat; lra). assert (0 < 16 * INR n ^ 2 * w0 ^ 2 / c) by (apply Rdiv_lt_0_compat; nra).
  pose proof (pow2_ge_0 (K1 * / w0)). pose proof (pow2_ge_0 (w0 / K1)). pose proof (pow2_ge_0 K0). assert (0 < CC ^ 2 / w0 ^ 2) by (apply Rdiv_lt_0_compat; nra). unfold C_below, C_above. split.
  - assert (0 <= 2 * (K1 * / w0) ^ 2 * (16 * INR n ^ 2 * w0 ^ 2 / c)) by (apply Rmult_le_pos; lra). assert (0 < (2 * K0 ^ 2 + 1) * (4 * INR n ^ 2 / K0)) by (apply Rmult_lt_0_compat; lra). lra.
  - assert (0 <= CC ^ 2 / w0 ^ 2 * (2 * (w0 / K1) ^ 2) * (1 + K0 ^ 2)) by (apply Rmult_le_pos; [apply Rmult_le_pos; lra|lra]). assert (0 < K0 * B') by now apply Rmult_lt_0_compat. lra.
Qed.
Lemma V_above t : Y t <= y0 -> V t <= C_above * (sq f t + sq g t + sq h t).
Proof.
  intros Near. destruct (V_is t Near) as (S & X & S0 & EV & [X1 X2] & Y1 & _ & G1 & Y0 & _).
  set (e := 2 * (w0 / K1) ^ 2). set (k1 := CC ^ 2 / w0 ^ 2). assert (He : 0 <= e) by (unfold e; pose proof (pow2_ge_0 (w0 / K1)); lra). assert (Hk1 : 0 < k1) by (unfold k1; apply Rdiv_lt_0_compat; nra).
  assert (G3 : sq y t <= e * (sq f t + K0 ^ 2 * sq g t)).
  { unfold sq. rewrite <- (Sum_scal n (K0 ^ 2)), <- Sum_plus, <- Sum_scal. apply Sum_le. intros k _. unfold e. replace (y k t) with (w0 / K1 * (f k t - K0 * g k t)) by (unfold ff; field; split; (exact Hw || exact HK1)).
    rewrite Rpow_mult_distr. pose proof (pow2_ge_0 (w0 / K1)). pose proof (pow2_ge_0 (f k t + K0 * g k t)). nra. }
  pose proof (sq_ge0 f t) as F0. pose proof (sq_ge0 g t) as F1. pose proof (sq_ge0 h t) as F2. pose proof (sq_ge0 y t) as F3.
  assert (Z1 : K0 * S <= K0 * (B' * (sq g t + sq h t))) by (apply Rmult_le_compat_l; lra).
  assert (Z2 : X / w0 ^ 2 <= k1 * sq y t).
  { unfold k1. replace (CC ^ 2 / w0 ^ 2 * sq y t) with (CC * (CC * sq y t) / w0 ^ 2) by (field; exact Hw). apply Rmult_le_compat_r; [left; now apply Rinv_0_lt_compat|]. assert (CC * Y t <= CC * (CC * sq y t)) by (apply Rmult_le_compat_l; lra). lra. }
  assert (Z3 : k1 * sq y t <= k1 * (e * (sq f t + K0 ^ 2 * sq g t))) by (apply Rmult_le_compat_l; lra).
  assert (Z4 : k1 * (e * (sq f t + K0 ^ 2 * sq g t)) <= k1 * e * ((1 + K0 ^ 2) * (sq f t + sq g t + sq h t))).
  { rewrite <- Rmult_assoc. apply Rmult_le_compat_l; [apply Rmult_le_pos; lra|]. pose proof (pow2_ge_0 K0). nra. }
  assert (Z5 : K0 * (B' * (sq g t + sq h t)) <= K0 * B' * (sq f t + sq g t + sq h t)) by (rewrite <- Rmult_assoc; apply Rmult_le_compat_l; [nra|lra]).
  rewrite EV. unfold C_above. fold e k1. lra.
Qed.

(* ---- the products ---- *)
Definition FH (t : R) := Sum n (fun k => w0 * (f k t * h k t)).
Definition HG (t : R) := Sum n (fun k => w0 * (h k t * g k t)).
Definition FH' (t : R) := Sum n (fun k => w0 * (ff' n adj w0 K0 K1 r th k t * h k t + f k t * (- u k t * g k t + q k t))).
Definition HG' (t : R) := Sum n (fun k => w0 * ((- u k t * g k t + q k t) * g k t + h k t * (u k t * h k t + p k t))).
Lemma d_FH t : 0 <= t -> is_derive FH t (FH' t).
Proof. intros Ht. apply (D_Sum n (fun k t => w0 * (f k t * h k t))). intros k Hk. apply (D_scal w0 (fun t => f k t * h k t)), D_mult; [now apply d_ff|now apply d_hh]. Qed.
Lemma d_HG t : 0 <= t -> is_derive HG t (HG' t).
Proof. intros Ht. apply (D_Sum n (fun k t => w0 * (h k t * g k t))). intros k Hk. apply (D_scal w0 (fun t => h k t * g k t)), D_mult; [now apply d_hh|now apply d_gg]. Qed.
Lemma turning_near t k : Rabs (f k t) <= INR n / 2 -> w0 ^ 2 / 2 <= w0 * u k t <= 3 / 2 * w0 ^ 2.
Proof.
  intros H. apply Rabs_le_between in H. unfold uu. replace (w0 * (w0 + w0 / INR n * f k t)) with (w0 ^ 2 * (1 + f k t / INR n)) by (field; lra).
  assert (X : - / 2 <= f k t / INR n <= / 2). { split; apply Rmult_le_reg_r with (INR n); try lra; unfold Rdiv; rewrite Rmult_assoc, Rinv_l by lra; lra. }
  set (z := f k t / INR n) in *. split.
  - replace (w0 ^ 2 / 2) with (w0 ^ 2 * / 2) by field. apply Rmult_le_compat_l; lra.
  - replace (3 / 2 * w0 ^ 2) with (w0 ^ 2 * (3 / 2)) by field. apply Rmult_le_compat_l; lra.
Qed.
Lemma FH_grows e : 0 < e -> 0 < C_FH e /\ forall t, (forall k, (k < n)%nat -> Rabs (f k t) <= INR n / 2) ->
  K0 * w0 ^ 2 / 4 * sq h t - e * sq g t - C_FH e * sq f t <= FH' t.
Proof.
  intros He. unfold C_FH. set (a := K0 * w0 ^ 2 / 8). assert (Ha : 0 < a) by (unfold a; nra).
  set (c1 := (w0 * K0) ^ 2 * / (4 * a)). set (c2 := K1 ^ 2 * / (4 * a)). set (c3 := (3 / 2 * w0 ^ 2) ^ 2 * / (4 * e)).
  assert (i1 : 0 < / (4 * a)) by (apply Rinv_0_lt_compat; lra). assert (i2 : 0 < / (4 * e)) by (apply Rinv_0_lt_compat; lra).
  assert (H1 : 0 <= c1) by (unfold c1; apply Rmult_le_pos; [apply pow2_ge_0|lra]). assert (H2 : 0 <= c2) by (unfold c2; apply Rmult_le_pos; [apply pow2_ge_0|lra]). assert (H3 : 0 <= c3) by (unfold c3; apply Rmult_le_pos; [apply pow2_ge_0|lra]).
  assert (N2 : 1 <= INR n ^ 2) by nra. split; [nra|]. intros t Small.
  apply Rle_trans with (Sum n (fun k => K0 * w0 ^ 2 / 4 * h k t ^ 2 - e * g k t ^ 2 - c1 * p k t ^ 2 - c2 * y' k t ^ 2 - (c3 + 1) * f k t ^ 2 - w0 ^ 2 * q k t ^ 2)).
  - rewrite !Sum_minus, !Sum_scal. fold (sq h t) (sq g t) (sq p t) (sq y' t) (sq f t) (sq q t). pose proof (p_small t) as P1. pose proof (q_small t) as P2. pose proof (y'_small t) as P3.
    apply (Rmult_le_compat_l c1) in P1; [|exact H1]. apply (Rmult_le_compat_l (w0 ^ 2)) in P2; [|lra]. apply (Rmult_le_compat_l c2) in P3; [|exact H2]. lra.
  - apply Sum_le. intros k Hk. pose proof (turning_near t k (Small k Hk)) as Tn. unfold ff'.
    set (U := w0 * u k t) in *. set (F := f k t). set (g0 := g k t). set (h0 := h k t). set (p0 := p k t). set (q0 := q k t). set (z0 := y' k t).
    replace (w0 * ((K0 * (u k t * h0 + p0) + K1 * / w0 * z0) * h0 + F * (- u k t * g0 + q0))) with (K0 * U * h0 ^ 2 + h0 * (w0 * K0 * p0) + h0 * (K1 * z0) - g0 * (U * F) + F * (w0 * q0)) by (unfold U; field; exact Hw).
    destruct (mixed h0 (w0 * K0 * p0) a Ha) as [M1 _]. destruct (mixed h0 (K1 * z0) a Ha) as [M2 _]. destruct (mixed g0 (U * F) e He) as [_ M3]. destruct (mixed F (w0 * q0) (/ 4) ltac:(lra)) as [M4 _].
    replace (/ (4 * a) * (w0 * K0 * p0) ^ 2) with (c1 * p0 ^ 2) in M1 by (unfold c1; ring). replace (/ (4 * a) * (K1 * z0) ^ 2) with (c2 * z0 ^ 2) in M2 by (unfold c2; ring).
    assert (M3' : / (4 * e) * (U * F) ^ 2 <= c3 * F ^ 2).
    { unfold c3. replace (/ (4 * e) * (U * F) ^ 2) with (U ^ 2 * / (4 * e) * F ^ 2) by ring. apply Rmult_le_compat_r; [apply pow2_ge_0|]. apply Rmult_le_compat_r; [lra|]. apply pow_incr. lra. }
    replace (/ (4 * / 4) * (w0 * q0) ^ 2) with (w0 ^ 2 * q0 ^ 2) in M4 by field.
    assert (M5 : K0 * w0 ^ 2 / 2 * h0 ^ 2 <= K0 * U * h0 ^ 2) by (apply Rmult_le_compat_r; [apply pow2_ge_0|]; nra). pose proof (pow2_ge_0 F).
    assert (a * h0 ^ 2 = K0 * w0 ^ 2 / 8 * h0 ^ 2) by reflexivity. lra.
Qed.
Lemma HG_falls t : (forall k, (k < n)%nat -> Rabs (f k t) <= INR n / 2) -> HG' t <= - (w0 ^ 2 / 4) * sq g t + 2 * w0 ^ 2 * sq h t + 2 * INR n ^ 2 * sq f t.
Proof.
  intros Small. apply Rle_trans with (Sum n (fun k => - (w0 ^ 2 / 4) * g k t ^ 2 + 2 * w0 ^ 2 * h k t ^ 2 + q k t ^ 2 + p k t ^ 2)).
  - apply Sum_le. intros k Hk. pose proof (turning_near t k (Small k Hk)) as Tn. set (U := w0 * u k t) in *. set (g0 := g k t). set (h0 := h k t). set (p0 := p k t). set (q0 := q k t).
    replace (w0 * ((- u k t * g0 + q0) * g0 + h0 * (u k t * h0 + p0))) with (- (U * g0 ^ 2) + w0 * g0 * q0 + U * h0 ^ 2 + w0 * h0 * p0) by (unfold U; ring).
    destruct (mixed (w0 * g0) q0 (/ 4) ltac:(lra)) as [_ M1]. destruct (mixed (w0 * h0) p0 (/ 4) ltac:(lra)) as [_ M2].
    replace (/ (4 * / 4)) with 1 in M1, M2 by field. rewrite !Rpow_mult_distr in M1, M2. pose proof (pow2_ge_0 g0). pose proof (pow2_ge_0 h0).
    assert (w0 ^ 2 / 2 * g0 ^ 2 <= U * g0 ^ 2) by (apply Rmult_le_compat_r; lra). assert (U * h0 ^ 2 <= 3 / 2 * w0 ^ 2 * h0 ^ 2) by (apply Rmult_le_compat_r; lra). nra.
  - rewrite !Sum_plus, !Sum_scal. fold (sq h t) (sq g t) (sq p t) (sq q t). pose proof (p_small t). pose proof (q_small t). lra.
Qed.
Lemma products_small t : Rabs (FH t) <= Rabs w0 * (sq f t + sq g t + sq h t) /\ Rabs (HG t) <= Rabs w0 * (sq f t + sq g t + sq h t).
Proof.
  assert (Pr : forall x z : nat -> R -> R, Rabs (Sum n (fun k => w0 * (x k t * z k t))) <= Rabs w0 * (sq x t + sq z t)).
  { intros x z. eapply Rle_trans; [apply Sum_Rabs|]. unfold sq. rewrite <- Sum_plus, <- Sum_scal. apply Sum_le. intros k _. rewrite Rabs_mult. apply Rmult_le_compat_l; [apply Rabs_pos|].
    set (b := x k t). set (d := z k t). pose proof (pow2_ge_0 (b - d)). pose proof (pow2_ge_0 (b + d)). apply Rabs_le. split; nra. }
  pose proof (sq_ge0 f t). pose proof (sq_ge0 g t). pose proof (sq_ge0 h t). pose proof (Rabs_pos w0). split; (eapply Rle_trans; [apply Pr|]); apply Rmult_le_compat_l; lra.
Qed.
(* along a motion that starts near enough *)
Lemma d_V t : 0 <= t -> is_derive V t (- (/ INR n ^ 2 * Sum n (fun k => f k t ^ 2))).
Proof.
  intros Ht. apply (is_derive_ext (fun s => VV n adj w0 K0 K1 r th s + K1 * W1 n adj phi / w0 ^ 2)).
  - intros x. unfold V, VV. match goal with |- @eq _ ?a ?b => change (@eq R a b) end. field. exact Hw.
  - eapply D_eq; [apply (D_plus (VV n adj w0 K0 K1 r th) (fun _ => K1 * W1 n adj phi / w0 ^ 2)); [apply (d_VV n adj w0 K0 K1 r th); assumption|apply D_const]|apply Rplus_0_r].
Qed.
Lemma V_falls t : 0 <= t -> V t <= V 0.
Proof.
  intros Ht. apply (decreasing V (fun t => - (/ INR n ^ 2 * Sum n (fun k => f k t ^ 2))) 0 t Ht).
  - intros s Hs. apply d_V. lra.
  - intros s _. assert (0 <= Sum n (fun k => f k s ^ 2)) by (apply Sum_ge0; intros; apply pow2_ge_0). assert (0 < / INR n ^ 2) by (apply Rinv_0_lt_compat, pow_lt, nn). nra.
Qed.
Lemma Y_near t e : 0 <= t -> 0 < e -> exists d, 0 < d /\ forall s, Rabs (s - t) < d -> Rabs (Y s - Y t) < e.
Proof.
  intros Ht He. assert (D : ex_derive Y t).
  { eexists. apply (W1_along n adj (fun k s => th k s - phi k) (fun k => u k t) t Hn HS). intros k Hk. eapply D_eq; [apply (D_minus (th k) (fun _ => phi k)); [apply (d_th n adj w0 K0 K1 r th); assumption|apply D_const]|apply Rminus_0_r]. }
  assert (C : continuity_pt Y t) by (apply continuity_pt_filterlim, (ex_derive_continuous Y), D). destruct (C e He) as (d & Hd & Pd).
  exists d. split; [exact Hd|]. intros s Hs. destruct (Req_dec s t) as [->|Ne]; [rewrite Rminus_eq_0, Rabs_R0; exact He|]. apply (Pd s). split; [split; [exact I|congruence]|exact Hs].
Qed.
Lemma Y_stays : Y 0 <= y0 -> V 0 <= c * y0 / (2 * w0 ^ 2) -> forall t, 0 <= t -> Y t <= y0.
Proof.
  intros Y0 V0. apply (real_induction (fun t => Y t <= y0)).
  - intros t Ht H. destruct (Req_dec t 0) as [->|Ne]; [exact Y0|]. apply Rnot_lt_le. intros L. destruct (Y_near t (Y t - y0) Ht ltac:(lra)) as (d & Hd & N).
    set (s := Rmax 0 (t - d / 2)). assert (Hs : 0 <= s < t) by (unfold s; split; [apply Rmax_l|apply Rmax_lub_lt; lra]). assert (Hs' : t - d / 2 <= s) by apply Rmax_r.
    specialize (H s Hs). cbv beta in H. specialize (N s ltac:(rewrite Rabs_left; lra)). apply Rabs_lt_between in N. lra.
  - intros t Ht H. cbv beta in H. destruct (V_below t H) as (_ & YV & _). pose proof (V_falls t Ht) as Vf.
    assert (Yh : Y t <= y0 / 2).
    { eapply Rle_trans; [exact YV|]. apply Rle_trans with (w0 ^ 2 / c * (c * y0 / (2 * w0 ^ 2))); [apply Rmult_le_compat_l; [left; apply Rdiv_lt_0_compat; lra|lra]|right; field; split; (exact Hw || lra)]. }
    destruct (Y_near t (y0 / 2) Ht ltac:(lra)) as (d & Hd & N). exists d. split; [exact Hd|]. intros s Hs. specialize (N s ltac:(rewrite Rabs_pos_eq; lra)). apply Rabs_lt_between in N. lra.
Qed.
Definition d_eps := K0 * w0 ^ 2 / 128.
Definition d_one := Rmin (/ (2 * INR n ^ 2 * (C_FH d_eps + K0 * INR n ^ 2 / 8))) (/ (2 * (1 + K0 / 16) * Rabs w0 * C_below)).
Definition d_mu := Rmin (/ (2 * INR n ^ 2)) (d_one * (K0 * w0 ^ 2 / 128)).
Definition d_rate := 2 * d_mu / (3 * C_above).
Definition d_start := Rmin (c * y0 / (2 * w0 ^ 2)) (/ (4 * C_below)).
Lemma d_positive : 0 < d_one /\ 0 < d_mu /\ 0 < d_rate /\ 0 < d_start.
Proof.
  destruct C_positive as [C1 C2]. assert (He : 0 < d_eps) by (unfold d_eps; nra). destruct (FH_grows d_eps He) as [C4 _]. pose proof (Rabs_pos_lt w0 Hw) as Aw. assert (N2 : 1 <= INR n ^ 2) by nra.
  assert (A1 : 0 < d_one).
  { unfold d_one. assert (0 < C_FH d_eps + K0 * INR n ^ 2 / 8) by nra. apply Rmin_glb_lt; apply Rinv_0_lt_compat; repeat apply Rmult_lt_0_compat; lra. }
  assert (A2 : 0 < d_mu) by (unfold d_mu; apply Rmin_glb_lt; [apply Rinv_0_lt_compat; lra|apply Rmult_lt_0_compat; [exact A1|apply Rdiv_lt_0_compat; [now apply Rmult_lt_0_compat|lra]]]).
  split; [exact A1|]. split; [exact A2|]. split; [unfold d_rate; apply Rdiv_lt_0_compat; lra|]. unfold d_start. apply Rmin_glb_lt; [apply Rdiv_lt_0_compat; [now apply Rmult_lt_0_compat|lra]|apply Rinv_0_lt_compat; lra].
Qed.
Lemma V_decays : Y 0 <= y0 -> V 0 <= d_start -> forall t, 0 <= t -> Y t <= y0 /\ V t <= 3 * V 0 * exp (- d_rate * t).
Proof.
  intros Start0 Start. assert (Stay : forall t, 0 <= t -> Y t <= y0) by (apply Y_stays; [exact Start0|eapply Rle_trans; [exact Start|apply Rmin_l]]).
  destruct d_positive as (P1 & P2 & P3 & P4). destruct C_positive as [C1 C2]. assert (He : 0 < d_eps) by (unfold d_eps; nra). destruct (FH_grows d_eps He) as [C4 Fg].
  pose proof (Rabs_pos_lt w0 Hw) as Aw. assert (N2 : 1 <= INR n ^ 2) by nra. set (d2 := d_one * (K0 / 16)). assert (Hd2 : 0 < d2) by (unfold d2; nra).
  assert (L1 : d_one * (C_FH d_eps + K0 * INR n ^ 2 / 8) <= / (2 * INR n ^ 2)).
  { assert (Y : 0 < C_FH d_eps + K0 * INR n ^ 2 / 8) by nra. set (z := C_FH d_eps + K0 * INR n ^ 2 / 8) in *. assert (d_one <= / (2 * INR n ^ 2 * z)) by apply Rmin_l.
    apply Rle_trans with (/ (2 * INR n ^ 2 * z) * z); [apply Rmult_le_compat_r; lra|right; field; split; lra]. }
  assert (L2 : (d_one + d2) * Rabs w0 * C_below <= / 2).
  { assert (Y : 0 < (1 + K0 / 16) * Rabs w0 * C_below) by (repeat apply Rmult_lt_0_compat; lra). assert (d_one <= / (2 * (1 + K0 / 16) * Rabs w0 * C_below)) by apply Rmin_r.
    replace ((d_one + d2) * Rabs w0 * C_below) with (d_one * ((1 + K0 / 16) * Rabs w0 * C_below)) by (unfold d2; ring).
    apply Rle_trans with (/ (2 * (1 + K0 / 16) * Rabs w0 * C_below) * ((1 + K0 / 16) * Rabs w0 * C_below)); [apply Rmult_le_compat_r; lra|right; field; repeat split; lra]. }
  set (L := fun t => V t - d_one * FH t + d2 * HG t).
  assert (Near : forall t, 0 <= t -> V t / 2 <= L t <= 3 / 2 * V t).
  { intros t Ht. destruct (V_below t (Stay t Ht)) as (Vb & _ & V0). destruct (products_small t) as [S1 S2]. set (E := sq f t + sq g t + sq h t) in *. apply Rabs_le_between in S1, S2. unfold L.
    assert (X : (d_one + d2) * (Rabs w0 * E) <= V t / 2).
    { apply Rle_trans with ((d_one + d2) * (Rabs w0 * (C_below * V t))); [repeat apply Rmult_le_compat_l; lra|]. replace ((d_one + d2) * (Rabs w0 * (C_below * V t))) with ((d_one + d2) * Rabs w0 * C_below * V t) by ring. nra. }
    assert (d_one * FH t <= d_one * (Rabs w0 * E)) by (apply Rmult_le_compat_l; lra). assert (d_one * - (Rabs w0 * E) <= d_one * FH t) by (apply Rmult_le_compat_l; lra).
    assert (d2 * HG t <= d2 * (Rabs w0 * E)) by (apply Rmult_le_compat_l; lra). assert (d2 * - (Rabs w0 * E) <= d2 * HG t) by (apply Rmult_le_compat_l; lra). lra. }
  assert (Small : forall t, 0 <= t -> forall k, (k < n)%nat -> Rabs (f k t) <= INR n / 2).
  { intros t Ht k Hk. pose proof (V_falls t Ht) as V1. destruct (V_below t (Stay t Ht)) as (Vb & _ & V0). apply sqr_Rabs; [lra|]. pose proof (sq_term f t k Hk). pose proof (sq_ge0 g t). pose proof (sq_ge0 h t).
    assert (C_below * V t <= / 4).
    { assert (V t <= / (4 * C_below)) by (eapply Rle_trans; [exact V1|]; eapply Rle_trans; [exact Start|apply Rmin_r]).
      apply Rle_trans with (C_below * / (4 * C_below)); [apply Rmult_le_compat_l; lra|right; field; lra]. } nra. }
  assert (Rate : forall t, 0 <= t -> L t <= L 0 * exp (- d_rate * t)).
  { apply (gronwall L (fun t => - (/ INR n ^ 2 * Sum n (fun k => f k t ^ 2)) - d_one * FH' t + d2 * HG' t) d_rate).
    - intros t Ht. apply (D_plus (fun t => V t - d_one * FH t) (fun t => d2 * HG t)); [apply (D_minus V (fun t => d_one * FH t)); [exact (d_V t Ht)|apply D_scal, (d_FH t Ht)]|apply D_scal, (d_HG t Ht)].
    - intros t Ht. change (Sum n (fun k => f k t ^ 2)) with (sq f t). specialize (Fg t (Small t Ht)). pose proof (HG_falls t (Small t Ht)) as Hg. destruct (V_below t (Stay t Ht)) as (_ & _ & V0).
      pose proof (V_above t (Stay t Ht)) as Va. destruct (Near t Ht) as [_ Lv]. pose proof (sq_ge0 f t) as F0. pose proof (sq_ge0 g t) as G0. pose proof (sq_ge0 h t) as H0.
      apply (Rmult_le_compat_l d_one) in Fg; [|lra]. apply (Rmult_le_compat_l d2) in Hg; [|lra].
      assert (M1 : d_mu <= / (2 * INR n ^ 2)) by apply Rmin_l. assert (M2 : d_mu <= d_one * (K0 * w0 ^ 2 / 128)) by apply Rmin_r.
      assert (X1 : d_one * (C_FH d_eps + K0 * INR n ^ 2 / 8) * sq f t <= / (2 * INR n ^ 2) * sq f t) by (apply Rmult_le_compat_r; lra).
      assert (X2 : d_mu * sq f t <= / (2 * INR n ^ 2) * sq f t) by (apply Rmult_le_compat_r; lra). assert (X3 : d_mu * sq g t <= d_one * (K0 * w0 ^ 2 / 128) * sq g t) by (apply Rmult_le_compat_r; lra).
      assert (X4 : d_mu * sq h t <= d_one * (K0 * w0 ^ 2 / 128) * sq h t) by (apply Rmult_le_compat_r; lra).
      assert (X5 : / INR n ^ 2 * sq f t = / (2 * INR n ^ 2) * sq f t + / (2 * INR n ^ 2) * sq f t) by (field; lra).
      assert (X6 : 0 <= d_one * (K0 * w0 ^ 2) * sq h t) by (apply Rmult_le_pos; [apply Rmult_le_pos; [lra|apply Rmult_le_pos; lra]|lra]).
      assert (Y : - (/ INR n ^ 2 * sq f t) - d_one * FH' t + d2 * HG' t <= - (d_mu * (sq f t + sq g t + sq h t))) by (unfold d2, d_eps in *; lra).
      eapply Rle_trans; [exact Y|]. unfold d_rate. assert (Z : 2 * d_mu / (3 * C_above) * L t <= d_mu * (sq f t + sq g t + sq h t)).
      { assert (Q1 : 0 < 2 * d_mu / (3 * C_above)) by (apply Rdiv_lt_0_compat; lra). apply Rle_trans with (2 * d_mu / (3 * C_above) * (3 / 2 * (C_above * (sq f t + sq g t + sq h t)))); [apply Rmult_le_compat_l; lra|right; field; lra]. }
      lra. }
  intros t Ht. split; [now apply Stay|]. specialize (Rate t Ht). destruct (Near t Ht) as [A1 _]. destruct (Near 0 ltac:(lra)) as [_ A2]. pose proof (exp_pos (- d_rate * t)) as Ep.
  assert (L 0 * exp (- d_rate * t) <= 3 / 2 * V 0 * exp (- d_rate * t)) by (apply Rmult_le_compat_r; lra). lra.
Qed.
End Motion.
End Decay.

(* the sum of the squares of all differences of centres, and of phasors turned back by phi *)
Definition spread n w0 (phi : nat -> R) (r : nat -> C) (th : nat -> R) : R :=
  Sum n (fun k => Sum n (fun j => dist2 (circle_centre w0 (r k) (th k)) (circle_centre w0 (r j) (th j)) + dist2 (expi (th k - phi k)) (expi (th j - phi j)))).
Theorem formation_stable : forall n adj w0 K0 K1 phi, (1 <= n)%nat -> undirected adj -> strongly_connected n adj -> w0 <> 0 -> 0 < K0 -> K1 <> 0 -> steady n adj K1 phi ->
  exists e A m, 0 < e /\ 0 < A /\ 0 < m /\ forall r th, shaped n adj w0 K0 K1 r th -> spread n w0 phi (fun k => r k 0) (fun k => th k 0) < e ->
    forall t, 0 <= t -> spread n w0 phi (fun k => r k t) (fun k => th k t) <= A * spread n w0 phi (fun k => r k 0) (fun k => th k 0) * exp (- m * t).
Proof.
  intros n adj w0 K0 K1 phi Hn HS SC Hw HK HK1 Sd. pose proof (INR_pos n Hn) as Pn.
  destruct (near_steady n adj K1 phi Hn HS SC HK1 Sd) as (y0 & c & CC & Hy0 & Hc & HCC & P). destruct (le_lap2 n adj Hn HS SC) as (B' & HB' & P'). destruct (spacing_proper n adj Hn HS SC) as [B1 [HB1 Pr]].
  assert (w2 : 0 < w0 ^ 2) by (apply pow2_gt_0; exact Hw). set (k1 := CC / w0 ^ 2). assert (Hk1 : 0 < k1) by (unfold k1; now apply Rdiv_lt_0_compat). set (k2 := c / w0 ^ 2). assert (Hk2 : 0 < k2) by (unfold k2; now apply Rdiv_lt_0_compat).
  set (up := (K0 + k1) / (4 * INR n)). assert (Hup : 0 < up) by (unfold up; apply Rdiv_lt_0_compat; lra).
  set (dn := INR n ^ 2 * (B1 + 1) * (/ K0 + / k2)). assert (Hdn : 0 < dn).
  { unfold dn. assert (0 < / K0) by now apply Rinv_0_lt_compat. assert (0 < / k2) by now apply Rinv_0_lt_compat. apply Rmult_lt_0_compat; [apply Rmult_lt_0_compat; nra|lra]. }
  set (st := d_start n w0 K0 K1 y0 c). set (ra := d_rate n w0 K0 K1 B' c CC).
  assert (Pos : 0 < ra /\ 0 < st).
  { destruct (d_positive n adj w0 K0 K1 B' y0 c CC Hn Hw HK Hy0 Hc HCC HB' (fun _ _ => RtoC 0) (fun _ _ => 0)) as (_ & _ & X & Y). now split. }
  set (e := Rmin (st / up) (4 * INR n * y0)). exists e, (3 * up * dn), ra. split; [unfold e; apply Rmin_glb_lt; [apply Rdiv_lt_0_compat; lra|nra]|]. split; [apply Rmult_lt_0_compat; lra|]. split; [tauto|]. intros r th M Start t Ht.
  set (D := fun s => spread n w0 phi (fun k => r k s) (fun k => th k s)). set (Ys := fun s => W1 n adj (off phi (fun k => th k s))). set (Ss := fun s => Q n (lap n adj) (fun k => cc w0 r th k s)).
  assert (Parts : forall s, 4 * INR n * (Ss s) + 4 * INR n * Ys s <= D s /\ D s <= INR n ^ 2 * (B1 * (Ss s + Ys s)) /\ 0 <= Ss s /\ 0 <= Ys s).
  { intros s. assert (S0 : 0 <= Ss s) by now apply Q_kernel. assert (Y0 : 0 <= Ys s) by now apply W1_ge0. split; [|split; [|now split]].
    - unfold Ss, Ys, W1. rewrite !Q_total by assumption. set (a := total n adj (fun k => cc w0 r th k s)). set (b := total n adj (phasors (off phi (fun k => th k s)))).
      replace (4 * INR n * (/ (4 * INR n) * a) + 4 * INR n * (/ (4 * INR n) * b)) with (a + b) by (field; lra). unfold a, b, total, D, spread. rewrite <- Sum_plus. apply Sum_le. intros k _. rewrite <- Sum_plus. apply Sum_le. intros j _.
      pose proof (dist2_ge0 (cc w0 r th k s) (cc w0 r th j s)). pose proof (dist2_ge0 (phasors (off phi (fun k => th k s)) k) (phasors (off phi (fun k => th k s)) j)).
      change (circle_centre w0 (r k s) (th k s)) with (cc w0 r th k s). change (circle_centre w0 (r j s) (th j s)) with (cc w0 r th j s).
      change (expi (th k s - phi k)) with (phasors (off phi (fun k => th k s)) k). change (expi (th j s - phi j)) with (phasors (off phi (fun k => th k s)) j). unfold w. destruct (adj k j); lra.
    - replace (INR n ^ 2 * (B1 * (Ss s + Ys s))) with (Sum n (fun _ => Sum n (fun _ => B1 * Ss s + B1 * Ys s))) by (rewrite !Sum_const; ring). unfold D, spread. apply Sum_le. intros k Hk. apply Sum_le. intros j Hj.
      apply Rplus_le_compat; [exact (Pr (fun k => cc w0 r th k s) k j Hk Hj)|exact (Pr (phasors (off phi (fun k => th k s))) k j Hk Hj)]. }
  set (Vs := fun s => V n adj w0 K0 K1 phi r th s).
  assert (Up : forall s, Ys s <= y0 -> Vs s <= up * D s).
  { intros s Near. destruct (P (fun k => th k s) Near) as [[_ P1] _]. fold (Ys s) in P1. destruct (Parts s) as (D1 & _ & S0 & Y0). unfold Vs, V. fold (Ss s).
    assert (X : - K1 * (W1 n adj (fun k => th k s) - W1 n adj phi) / w0 ^ 2 <= k1 * Ys s) by (unfold k1; replace (CC / w0 ^ 2 * Ys s) with (CC * Ys s / w0 ^ 2) by (field; exact Hw); apply Rmult_le_compat_r; [left; now apply Rinv_0_lt_compat|exact P1]).
    assert (Z : (K0 + k1) * (Ss s + Ys s) <= up * D s).
    { unfold up. replace ((K0 + k1) / (4 * INR n) * D s) with ((K0 + k1) * (D s / (4 * INR n))) by (field; lra). apply Rmult_le_compat_l; [lra|]. apply Rmult_le_reg_r with (4 * INR n); [lra|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. lra. }
    assert (0 <= K0 * Ys s) by (apply Rmult_le_pos; lra). assert (0 <= k1 * Ss s) by (apply Rmult_le_pos; lra). lra. }
  assert (Dn : forall s, Ys s <= y0 -> D s <= dn * Vs s).
  { intros s Near. destruct (P (fun k => th k s) Near) as [[P1 _] _]. fold (Ys s) in P1. destruct (Parts s) as (_ & D1 & S0 & Y0). unfold Vs, V. fold (Ss s).
    assert (X : k2 * Ys s <= - K1 * (W1 n adj (fun k => th k s) - W1 n adj phi) / w0 ^ 2) by (unfold k2; replace (c / w0 ^ 2 * Ys s) with (c * Ys s / w0 ^ 2) by (field; exact Hw); apply Rmult_le_compat_r; [left; now apply Rinv_0_lt_compat|exact P1]).
    set (x := - K1 * (W1 n adj (fun k => th k s) - W1 n adj phi) / w0 ^ 2) in *. assert (i0 : 0 < / K0) by now apply Rinv_0_lt_compat. assert (i1 : 0 < / k2) by now apply Rinv_0_lt_compat.
    eapply Rle_trans; [exact D1|]. unfold dn. rewrite !Rmult_assoc. apply Rmult_le_compat_l; [nra|].
    assert (E1 : (/ K0 + / k2) * (K0 * Ss s + x) = Ss s + / K0 * x + / k2 * (K0 * Ss s) + / k2 * x) by (field; lra). rewrite E1.
    assert (k2Y : 0 <= k2 * Ys s) by (apply Rmult_le_pos; lra). assert (Y1 : Ys s <= / k2 * x) by (apply Rmult_le_reg_l with k2; [exact Hk2|]; rewrite <- Rmult_assoc, Rinv_r by lra; lra).
    assert (0 <= / K0 * x) by (apply Rmult_le_pos; lra). assert (KS : 0 <= K0 * Ss s) by (apply Rmult_le_pos; lra). assert (0 <= / k2 * (K0 * Ss s)) by (apply Rmult_le_pos; lra). apply Rmult_le_compat; lra. }
  assert (Y0 : Ys 0 <= y0).
  { destruct (Parts 0) as (D1 & _ & S0 & Y0). assert (D 0 <= 4 * INR n * y0) by (left; eapply Rlt_le_trans; [exact Start|apply Rmin_r]). assert (0 <= 4 * INR n * Ss 0) by (apply Rmult_le_pos; lra). apply Rmult_le_reg_l with (4 * INR n); lra. }
  assert (V0 : Vs 0 <= st).
  { eapply Rle_trans; [apply (Up 0 Y0)|]. apply Rle_trans with (up * (st / up)); [apply Rmult_le_compat_l; [lra|]; left; eapply Rlt_le_trans; [exact Start|apply Rmin_l]|right; field; lra]. }
  destruct (V_decays n adj w0 K0 K1 B' phi y0 c CC Hn HS SC Hw HK HK1 Sd Hy0 Hc HCC P HB' P' r th M Y0 V0 t Ht) as [Yt Dec]. fold ra in Dec. fold (Vs t) (Vs 0) in Dec. pose proof (exp_pos (- ra * t)) as Ep.
  change (D t <= 3 * up * dn * D 0 * exp (- ra * t)). eapply Rle_trans; [apply (Dn t Yt)|]. apply Rle_trans with (dn * (3 * Vs 0 * exp (- ra * t))); [apply Rmult_le_compat_l; lra|].
  replace (3 * up * dn * D 0 * exp (- ra * t)) with (dn * (3 * (up * D 0) * exp (- ra * t))) by ring.
  apply Rmult_le_compat_l; [lra|]. apply Rmult_le_compat_r; [lra|]. apply Rmult_le_compat_l; [lra|apply (Up 0 Y0)].
Qed.
(* the synchronized formation, also with a common drift *)
Lemma synchronized_steady n adj K1 : K1 < 0 -> steady n adj K1 (fun _ => 0).
Proof.
  intros HK1. split.
  - intros k Hk. rewrite gW_sines by exact Hk. apply Sum_zero. intros j _. rewrite Rminus_0_r, sin_0. ring.
  - intros k j _ _ _. rewrite Rminus_0_r, cos_0. lra.
Qed.
Theorem synchronized_stable : forall n adj w0 K0 K1 f, (1 <= n)%nat -> undirected adj -> strongly_connected n adj -> w0 <> 0 -> 0 < K0 -> K1 < 0 ->
  exists e A m, 0 < e /\ 0 < A /\ 0 < m /\ forall r th, drifting n adj w0 K0 K1 f r th -> spread n w0 (fun _ => 0) (fun k => r k 0) (fun k => th k 0) < e ->
    forall t, 0 <= t -> spread n w0 (fun _ => 0) (fun k => r k t) (fun k => th k t) <= A * spread n w0 (fun _ => 0) (fun k => r k 0) (fun k => th k 0) * exp (- m * t).
Proof.
  intros n adj w0 K0 K1 f Hn HS SC Hw HK HK1. destruct (formation_stable n adj w0 K0 K1 (fun _ => 0) Hn HS SC Hw HK ltac:(lra) (synchronized_steady n adj K1 HK1)) as (e & A & m & He & HA & Hm & H).
  exists e, A, m. split; [exact He|]. split; [exact HA|]. split; [exact Hm|]. intros r th Dr.
  assert (E : forall s, spread n w0 (fun _ => 0) (fun k => (r k s - RtoC s * f)%C) (fun k => th k s) = spread n w0 (fun _ => 0) (fun k => r k s) (fun k => th k s)).
  { intros s. apply Sum_ext. intros k _. apply Sum_ext. intros j _. f_equal. rewrite !dist2_xy. unfold circle_centre. cbn. ring. }
  specialize (H _ th (undrifted n adj w0 K0 K1 f r th Dr)). cbv beta in H. rewrite !E in H. intros Start t Ht. specialize (H Start t Ht). now rewrite E in H.
Qed.

(* ---- cycles: phases that grow by the same share m/n of a turn from node to node ---- *)
Definition cycle_graph (n k j : nat) : bool := (Nat.ltb k n && Nat.ltb j n && ring_graph n k j)%bool.
Definition turned_by (n m k : nat) : R := 2 * PI * INR m * INR k / INR n.
Lemma ring_sym n k j : (k < n)%nat -> (j < n)%nat -> ring_graph n k j = ring_graph n j k.
Proof.
  assert (L : forall a b, (a < b)%nat -> (b < n)%nat -> ring_graph n a b = ring_graph n b a).
  { intros a b Hab Hb. unfold ring_graph. replace (b + n - a)%nat with ((b - a) + 1 * n)%nat by lia. rewrite Nat.mod_add, (Nat.mod_small (b - a)), (Nat.mod_small (a + n - b)) by lia.
    unfold ring_offset. destruct (Nat.eqb_spec (b - a) 1), (Nat.eqb_spec (b - a) (n - 1)), (Nat.eqb_spec (a + n - b) 1), (Nat.eqb_spec (a + n - b) (n - 1)); try reflexivity; lia. }
  intros Hk Hj. destruct (Nat.lt_total k j) as [H|[->|H]]; [now apply L|reflexivity|symmetry; now apply L].
Qed.
Lemma cycle_undirected n : undirected (cycle_graph n).
Proof.
  intros k j. unfold cycle_graph. destruct (Nat.ltb_spec k n), (Nat.ltb_spec j n); try reflexivity. cbn [andb]. now apply ring_sym.
Qed.
Lemma cycle_connected n : (1 <= n)%nat -> strongly_connected n (cycle_graph n).
Proof.
  intros Hn j k Hj Hk. pose proof (ring_connected n Hn j k Hj Hk) as C. clear Hj Hk. induction C as [a b (Ha & Hb & A)|a|a b c _ IH1 _ IH2].
  - apply rt_step. split; [exact Ha|]. split; [exact Hb|]. unfold cycle_graph. rewrite A. apply Nat.ltb_lt in Ha, Hb. now rewrite Ha, Hb.
  - apply rt_refl.
  - now apply rt_trans with b.
Qed.
Lemma turned_step n m k d : (1 <= n)%nat -> (k < n)%nat -> (d < n)%nat ->
  sin (turned_by n m k - turned_by n m ((k + d) mod n)) = - sin (turned_by n m d) /\ cos (turned_by n m k - turned_by n m ((k + d) mod n)) = cos (turned_by n m d).
Proof.
  intros Hn Hk Hd. pose proof (INR_pos n Hn) as P.
  assert (E : turned_by n m k - turned_by n m ((k + d) mod n) = - turned_by n m d \/ turned_by n m k - turned_by n m ((k + d) mod n) = - turned_by n m d + 2 * INR m * PI).
  { unfold turned_by. destruct (Nat.lt_ge_cases (k + d) n) as [L|L].
    - left. rewrite Nat.mod_small, plus_INR by exact L. field. lra.
    - right. replace (k + d)%nat with ((k + d - n) + 1 * n)%nat by lia. rewrite Nat.mod_add, Nat.mod_small, minus_INR, plus_INR by lia. field. lra. }
  destruct E as [-> | ->]; rewrite ?sin_period, ?cos_period, sin_neg, cos_neg; now split.
Qed.
Lemma turned_back n m : (1 <= n)%nat -> sin (turned_by n m (n - 1)) = - sin (turned_by n m 1) /\ cos (turned_by n m (n - 1)) = cos (turned_by n m 1).
Proof.
  intros Hn. pose proof (INR_pos n Hn) as P. assert (E : turned_by n m (n - 1) = - turned_by n m 1 + 2 * INR m * PI) by (unfold turned_by; rewrite minus_INR by exact Hn; cbn [INR]; field; lra).
  rewrite E, sin_period, cos_period, sin_neg, cos_neg. now split.
Qed.
Lemma cycle_steady n m K1 : (3 <= n)%nat -> K1 * cos (2 * PI * INR m / INR n) < 0 -> steady n (cycle_graph n) K1 (turned_by n m).
Proof.
  intros Hn HK. assert (T1 : turned_by n m 1 = 2 * PI * INR m / INR n) by (unfold turned_by; cbn [INR]; f_equal; ring). destruct (turned_back n m ltac:(lia)) as [B1 B2]. split.
  - intros k Hk. rewrite gW_sines by exact Hk.
    rewrite (Sum_ext n _ (fun j => w (ring_graph n) k j * sin (turned_by n m k - turned_by n m j))).
    + rewrite (ring_neighbours n k (fun j => sin (turned_by n m k - turned_by n m j)) Hn Hk). rewrite (proj1 (turned_step n m k 1 ltac:(lia) Hk ltac:(lia))), (proj1 (turned_step n m k (n - 1) ltac:(lia) Hk ltac:(lia))), B1. ring.
    + intros j Hj. f_equal. unfold w, cycle_graph. apply Nat.ltb_lt in Hk, Hj. now rewrite Hk, Hj.
  - intros k j Hk Hj A. unfold cycle_graph in A. apply andb_prop in A as [_ A]. unfold ring_graph in A. set (d := ((j + n - k) mod n)%nat) in *. assert (Hd : (d < n)%nat) by (apply Nat.mod_upper_bound; lia).
    assert (Ej : j = ((k + d) mod n)%nat).
    { unfold d. rewrite Nat.add_mod_idemp_r by lia. replace (k + (j + n - k))%nat with (j + 1 * n)%nat by lia. rewrite Nat.mod_add, Nat.mod_small; lia. }
    rewrite Ej, (proj2 (turned_step n m k d ltac:(lia) Hk Hd)). unfold ring_offset in A. apply orb_prop in A as [A|A]; apply Nat.eqb_eq in A; rewrite A, ?B2, T1; exact HK.
Qed.
(* stable: the evenly turned formation on a cycle whose neighbours are K_1 cos < 0 apart *)
Theorem cyclic_stable : forall n m w0 K0 K1, (3 <= n)%nat -> w0 <> 0 -> 0 < K0 -> K1 * cos (2 * PI * INR m / INR n) < 0 ->
  exists e A q, 0 < e /\ 0 < A /\ 0 < q /\ forall r th, shaped n (cycle_graph n) w0 K0 K1 r th -> spread n w0 (turned_by n m) (fun k => r k 0) (fun k => th k 0) < e ->
    forall t, 0 <= t -> spread n w0 (turned_by n m) (fun k => r k t) (fun k => th k t) <= A * spread n w0 (turned_by n m) (fun k => r k 0) (fun k => th k 0) * exp (- q * t).
Proof.
  intros n m w0 K0 K1 Hn Hw HK HK1. apply formation_stable; try assumption; [lia|apply cycle_undirected|apply cycle_connected; lia| |now apply cycle_steady].
  intros ->. rewrite Rmult_0_l in HK1. lra.
Qed.
(* Figure 3(c): neighbours on C_12 five twelfths of a turn apart, or opposite *)
Theorem fig3_stable : forall m w0 K0 K1, m = 5%nat \/ m = 6%nat -> w0 <> 0 -> 0 < K0 -> 0 < K1 ->
  exists e A q, 0 < e /\ 0 < A /\ 0 < q /\ forall r th, shaped 12 (cycle_graph 12) w0 K0 K1 r th -> spread 12 w0 (turned_by 12 m) (fun k => r k 0) (fun k => th k 0) < e ->
    forall t, 0 <= t -> spread 12 w0 (turned_by 12 m) (fun k => r k t) (fun k => th k t) <= A * spread 12 w0 (turned_by 12 m) (fun k => r k 0) (fun k => th k 0) * exp (- q * t).
Proof.
  intros m w0 K0 K1 Hm Hw HK HK1. apply cyclic_stable; try assumption; [lia|]. assert (C : cos (2 * PI * INR m / INR 12) < 0); [|nra].
  pose proof PI_RGT_0. destruct Hm as [-> | ->].
  - replace (2 * PI * INR 5 / INR 12) with (PI - PI / 6) by (cbn; field). rewrite Rtrigo_facts.cos_pi_minus, cos_PI6. assert (0 < sqrt 3) by (apply sqrt_lt_R0; lra). lra.
  - replace (2 * PI * INR 6 / INR 12) with PI by (cbn; field). rewrite cos_PI. lra.
Qed.
