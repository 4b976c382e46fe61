(* Tanner, Jadbabaie, Pappas, Part I: two agents whose heading difference is wrapped, however many jumps it has.  The law holds at
   almost all times and velocities are the integrals of their rates (absolutely continuous); the length of the total velocity never
   decreases as long as the motion lasts.
     beyond.tanner1.two_agents, clause 2. *)
From Coq Require Import Reals Lra Lia Psatz.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums paley_model paley_phase paley_laplacian paley_gradient paley_particles tanner_energy tanner_flock tanner1_heading tanner1_motion tanner1_pair tanner2_filippov.
Open Scope R_scope.

(* absolutely continuous on every [0, b], b < T *)
Definition continuous_until (T : R) (z : R -> C) := forall b e, 0 < b < T -> 0 < e -> exists d, 0 < d /\ forall m (p q : nat -> R),
  (forall k, (k < m)%nat -> 0 <= p k <= q k /\ q k <= b) -> (forall k, (Datatypes.S k < m)%nat -> q k <= p (Datatypes.S k)) ->
  Sum m (fun k => q k - p k) < d -> Sum m (fun k => Cmod (z (q k) - z (p k))%C) < e.

(* stopped at b it is absolutely continuous on every [0, T] *)
Lemma stopped T (z : R -> C) b : continuous_until T z -> 0 < b < T -> absolutely_continuous (fun t => z (Rmin t b)).
Proof.
  intros A Hb T' e _ He. destruct (A b e Hb He) as (d & Hd & P). exists d. split; [exact Hd|]. intros m p q I O Q.
  apply (P m (fun k => Rmin (p k) b) (fun k => Rmin (q k) b)).
  - intros k Hk. destruct (I k Hk) as [[I1 I2] I3]. split; [split; [apply Rmin_glb; lra|apply Rle_min_compat_r; lra]|apply Rmin_r].
  - intros k Hk. apply Rle_min_compat_r. now apply O.
  - apply Rle_lt_trans with (2 := Q). apply Sum_le. intros k Hk. destruct (I k Hk) as [[I1 I2] I3]. unfold Rmin.
    destruct (Rle_dec (q k) b), (Rle_dec (p k) b); lra.
Qed.
Lemma negligible_point x : 0 <= x -> negligible (fun t => t = x).
Proof. intros Hx. apply negligible_isolated. intros t ->. split; [exact Hx|]. exists 1. split; [lra|]. intros s -> _. reflexivity. Qed.

Theorem two_agents_always : forall (adj : graph) (V V' : nat -> nat -> R -> R) (r v : nat -> R -> C) (th phi s : nat -> R -> R) (T : R) (N : R -> Prop),
  undirected adj -> (forall i j, V' i j = V' j i) -> adj 0%nat 1%nat = true ->
  (forall i, (i < 2)%nat -> continuous_until T (v i)) -> negligible N ->
  (forall t, 0 <= t < T -> ~ N t -> steered 2 adj V V' r v th t /\ wrapped (th 0%nat t - th 1%nat t) (phi 0%nat t - phi 1%nat t) /\
    forall i, (i < 2)%nat -> 0 <= s i t /\ v i t = (RtoC (s i t) * expi (phi i t))%C) ->
  forall a b, 0 <= a <= b -> b < T -> norm (v 0%nat a + v 1%nat a)%C <= norm (v 0%nat b + v 1%nat b)%C.
Proof.
  intros adj V V' r v th phi s T N S VS A AC HN M a b Hab HbT.
  destruct (Req_dec a b) as [->|Ne]; [lra|]. rewrite !norm_inner. apply sqrt_le_1_alt. apply (Rmult_le_reg_l (/ 2)); [lra|].
  set (F := fun x => / 2 * inner (v 0%nat x + v 1%nat x)%C (v 0%nat x + v 1%nat x)%C). change (F a <= F b).
  set (G := fun x => -1 * F (Rmin x b)).
  assert (Q : G b <= G a). 2: { unfold G in Q. rewrite (Rmin_left b b), (Rmin_left a b) in Q by lra. lra. }
  apply (ac_falls G (fun t => N t \/ t = b) a b).
  - unfold G. apply ac_scal. destruct (ac_axes _ (stopped T (v 0%nat) b (AC 0%nat ltac:(lia)) ltac:(lra))) as [X0 Y0].
    destruct (ac_axes _ (stopped T (v 1%nat) b (AC 1%nat ltac:(lia)) ltac:(lra))) as [X1 Y1].
    refine (ac_of _ _ (ac_scal (/ 2) _ (ac_plus _ _ (ac_sqr _ (ac_plus _ _ X0 X1)) (ac_sqr _ (ac_plus _ _ Y0 Y1)))) _).
    intros T' _. exists 1. split; [lra|]. intros x y _ _. rewrite Rmult_1_l. right. unfold F. rewrite !inner_xy. cbn. f_equal. ring.
  - apply negligible_or; [exact HN|apply negligible_point; lra].
  - lra.
  - intros t Ht Nt. assert (Lt : t < b) by (destruct (Req_dec t b) as [E|E]; [exfalso; apply Nt; now right|lra]).
    destruct (M t ltac:(lra) ltac:(tauto)) as (St & Wr & P). eexists. split.
    + apply D_scal. apply (is_derive_ext_loc F); [|apply (total_rate adj V V' r v th S VS A t St)].
      exists (mkposreal (b - t) ltac:(lra)). intros x Hx. cbn in Hx. unfold ball in Hx. cbn in Hx. unfold AbsRing_ball, abs, minus, plus, opp in Hx. cbn in Hx.
      apply Rabs_lt_between in Hx. now rewrite Rmin_left by lra.
    + destruct (P 0%nat ltac:(lia)) as [S0 E0]. destruct (P 1%nat ltac:(lia)) as [S1 E1].
      assert (Cr : cross (v 1%nat t) (v 0%nat t) = s 0%nat t * s 1%nat t * sin (phi 0%nat t - phi 1%nat t)).
      { rewrite E0, E1, sin_minus. unfold cross, expi. cbn. ring. }
      rewrite Cr. pose proof (wrapped_sign _ _ Wr) as W. destruct St as (_ & HN' & _). pose proof (norm_neq _ _ (HN' 0%nat 1%nat ltac:(lia) ltac:(lia) A)) as Pn.
      assert (Z : 0 <= 2 * (th 0%nat t - th 1%nat t) * (s 0%nat t * s 1%nat t * sin (phi 0%nat t - phi 1%nat t)) / norm (r 0%nat t - r 1%nat t)%C ^ 2); [|lra].
      unfold Rdiv. apply Rmult_le_pos; [|left; apply Rinv_0_lt_compat, pow_lt; exact Pn].
      replace (2 * (th 0%nat t - th 1%nat t) * (s 0%nat t * s 1%nat t * sin (phi 0%nat t - phi 1%nat t)))
        with (2 * (s 0%nat t * s 1%nat t) * ((th 0%nat t - th 1%nat t) * sin (phi 0%nat t - phi 1%nat t))) by ring.
      apply Rmult_le_pos; [|exact W]. apply Rmult_le_pos; [lra|]. now apply Rmult_le_pos.
Qed.
