(* Tanner, Jadbabaie, Pappas, Part I: two agents whose heading difference is wrapped.  The length of the total velocity never
   decreases.
     beyond.tanner1.two_agents. *)
From Coq Require Import Reals Lra Lia Psatz List.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums paley_model paley_phase paley_laplacian paley_gradient paley_particles tanner_energy tanner_flock tanner1_heading tanner1_motion.
Open Scope R_scope.

(* d stands for the angle x: in [-pi, pi] and equal to it up to whole turns; any number where the directions are opposite or the same *)
Definition wrapped (d x : R) : Prop := sin x = 0 \/ - PI <= d <= PI /\ exists k : Z, d = x + 2 * IZR k * PI.

Lemma wrapped_sign d x : wrapped d x -> 0 <= d * sin x.
Proof.
  intros [Z|[B [k E]]]; [rewrite Z; lra|].
  assert (T : sin x = sin d).
  { rewrite E. destruct (Z_le_dec 0 k) as [K|K].
    - rewrite <- (Z2Nat.id k K), <- INR_IZR_INZ. symmetry. apply sin_period.
    - rewrite <- (sin_period (x + 2 * IZR k * PI) (Z.to_nat (- k))). f_equal. rewrite INR_IZR_INZ, Z2Nat.id, opp_IZR by lia. ring. }
  rewrite T. destruct (Rle_or_lt 0 d) as [L|L].
  - apply Rmult_le_pos; [exact L|]. apply sin_ge_0; lra.
  - replace (d * sin d) with (- d * sin (- d)) by (rewrite sin_neg; ring). apply Rmult_le_pos; [lra|]. apply sin_ge_0; lra.
Qed.

Section Pair.
Variables (adj : graph) (V V' : nat -> nat -> R -> R) (r v : nat -> R -> C) (th phi s : nat -> R -> R).
Hypothesis S : undirected adj.
Hypothesis VS : forall i j, V' i j = V' j i.
Hypothesis A : adj 0%nat 1%nat = true.

(* the potential forces cancel *)
Lemma total_rate t : steered 2 adj V V' r v th t ->
  is_derive (fun x => / 2 * inner (v 0%nat x + v 1%nat x)%C (v 0%nat x + v 1%nat x)%C) t
    (2 * (th 0%nat t - th 1%nat t) * cross (v 1%nat t) (v 0%nat t) / norm (r 0%nat t - r 1%nat t)%C ^ 2).
Proof.
  intros (_ & HN & _ & HU). pose proof (norm_neq _ _ (HN 0%nat 1%nat ltac:(lia) ltac:(lia) A)) as P.
  assert (W : is_velocity (fun x => v 0%nat x + v 1%nat x)%C t
    (accel 2 adj V' (fun j => r j t) (fun j => v j t) (fun j => th j t) 0 + accel 2 adj V' (fun j => r j t) (fun j => v j t) (fun j => th j t) 1)%C).
  { destruct (HU 0%nat ltac:(lia)) as [A1 A2]. destruct (HU 1%nat ltac:(lia)) as [B1 B2]. split.
    - apply (is_derive_ext (fun x => fst (v 0%nat x) + fst (v 1%nat x))); [reflexivity|]. now apply D_plus.
    - apply (is_derive_ext (fun x => snd (v 0%nat x) + snd (v 1%nat x))); [reflexivity|]. now apply D_plus. }
  eapply D_eq; [apply D_scal, (D_inner _ _ t _ _ W W)|]. cbv beta.
  assert (G : (grad_i 2 adj V' (fun j => r j t) 0 + grad_i 2 adj V' (fun j => r j t) 1)%C = RtoC 0).
  { assert (P0 : forall i j, pair_grad adj V' (fun j => r j t) j i = (- pair_grad adj V' (fun j => r j t) i j)%C) by (intros; now apply pair_grad_antisym).
    assert (Q : forall i, pair_grad adj V' (fun j => r j t) i i = RtoC 0).
    { intros i. specialize (P0 i i). set (g := pair_grad _ _ _ _ _) in *. apply injective_projections; cbn.
      - apply (f_equal fst) in P0. cbn in P0. lra.
      - apply (f_equal snd) in P0. cbn in P0. lra. }
    unfold grad_i, Csum. cbn [Sum]. rewrite !Q, (P0 0%nat 1%nat). apply injective_projections; cbn; ring. }
  assert (E : (accel 2 adj V' (fun j => r j t) (fun j => v j t) (fun j => th j t) 0 + accel 2 adj V' (fun j => r j t) (fun j => v j t) (fun j => th j t) 1)%C
    = (RtoC ((th 0%nat t - th 1%nat t) / norm (r 0%nat t - r 1%nat t)%C ^ 2) * (Ci * (v 1%nat t - v 0%nat t)))%C).
  { unfold accel, gyro.
    assert (A0 : align 2 adj (fun j => r j t) (fun j => th j t) 0 = (th 0%nat t - th 1%nat t) / norm (r 0%nat t - r 1%nat t)%C ^ 2).
    { unfold align. cbn [Sum]. unfold w. rewrite A. unfold Rdiv. ring. }
    assert (A1 : align 2 adj (fun j => r j t) (fun j => th j t) 1 = - ((th 0%nat t - th 1%nat t) / norm (r 0%nat t - r 1%nat t)%C ^ 2)).
    { unfold align. cbn [Sum]. unfold w. rewrite (S 1%nat 0%nat), A, (norm_sym (r 1%nat t)). unfold Rdiv. ring. }
    rewrite A0, A1. set (k := _ / _). set (g0 := grad_i 2 adj V' (fun j => r j t) 0) in *. set (g1 := grad_i 2 adj V' (fun j => r j t) 1) in *.
    replace (- g0 + RtoC (- k) * (Ci * v 0%nat t) + (- g1 + RtoC (- - k) * (Ci * v 1%nat t)))%C
      with (- (g0 + g1) + RtoC (- k) * (Ci * v 0%nat t) + RtoC (- - k) * (Ci * v 1%nat t))%C by ring.
    rewrite G. apply injective_projections; cbn; ring. }
  rewrite E, !inner_xy. unfold cross. cbn. field. lra.
Qed.

(* on [a, b], where the law holds but for finitely many instants (the wrapped difference may jump) *)
Theorem two_agents_gather L a b : a <= b -> (forall t i, a <= t <= b -> (i < 2)%nat -> continuity_pt (fun x => fst (v i x)) t /\ continuity_pt (fun x => snd (v i x)) t) ->
  (forall t i, a <= t <= b -> (i < 2)%nat -> 0 <= s i t /\ v i t = (RtoC (s i t) * expi (phi i t))%C) ->
  (forall t, a < t < b -> ~ In t L -> steered 2 adj V V' r v th t /\ wrapped (th 0%nat t - th 1%nat t) (phi 0%nat t - phi 1%nat t)) ->
  norm (v 0%nat a + v 1%nat a)%C <= norm (v 0%nat b + v 1%nat b)%C.
Proof.
  intros Hab C P M. rewrite !norm_inner. apply sqrt_le_1_alt. apply (Rmult_le_reg_l (/ 2)); [lra|].
  apply (increasing_but (fun x => / 2 * inner (v 0%nat x + v 1%nat x)%C (v 0%nat x + v 1%nat x)%C) L a b Hab).
  - intros x Hx. destruct (C x 0%nat Hx ltac:(lia)) as [C1 C2]. destruct (C x 1%nat Hx ltac:(lia)) as [C3 C4].
    apply (continuity_pt_ext (fun x => / 2 * ((fst (v 0%nat x) + fst (v 1%nat x)) * (fst (v 0%nat x) + fst (v 1%nat x))
      + (snd (v 0%nat x) + snd (v 1%nat x)) * (snd (v 0%nat x) + snd (v 1%nat x))))); [intros; now rewrite inner_xy|].
    assert (K1 : continuity_pt (fun x => fst (v 0%nat x) + fst (v 1%nat x)) x) by now apply (continuity_pt_plus (fun x => fst (v 0%nat x)) (fun x => fst (v 1%nat x))).
    assert (K2 : continuity_pt (fun x => snd (v 0%nat x) + snd (v 1%nat x)) x) by now apply (continuity_pt_plus (fun x => snd (v 0%nat x)) (fun x => snd (v 1%nat x))).
    apply (continuity_pt_mult (fun _ => / 2)); [apply continuity_pt_const; intros ? ?; reflexivity|].
    apply continuity_pt_plus; now apply continuity_pt_mult.
  - intros x Hx N. destruct (M x Hx N) as [St Wr]. eexists. split; [apply total_rate, St|].
    destruct (P x 0%nat ltac:(lra) ltac:(lia)) as [S0 E0]. destruct (P x 1%nat ltac:(lra) ltac:(lia)) as [S1 E1].
    assert (Cr : cross (v 1%nat x) (v 0%nat x) = s 0%nat x * s 1%nat x * sin (phi 0%nat x - phi 1%nat x)).
    { rewrite E0, E1, sin_minus. unfold cross, expi. cbn. ring. }
    rewrite Cr. pose proof (wrapped_sign _ _ Wr) as Q. destruct St as (_ & HN & _). pose proof (norm_neq _ _ (HN 0%nat 1%nat ltac:(lia) ltac:(lia) A)) as Pn.
    unfold Rdiv. apply Rmult_le_pos; [|left; apply Rinv_0_lt_compat, pow_lt; exact Pn].
    replace (2 * (th 0%nat x - th 1%nat x) * (s 0%nat x * s 1%nat x * sin (phi 0%nat x - phi 1%nat x)))
      with (2 * (s 0%nat x * s 1%nat x) * ((th 0%nat x - th 1%nat x) * sin (phi 0%nat x - phi 1%nat x))) by ring.
    apply Rmult_le_pos; [|exact Q]. apply Rmult_le_pos; [lra|]. now apply Rmult_le_pos.
Qed.
End Pair.
