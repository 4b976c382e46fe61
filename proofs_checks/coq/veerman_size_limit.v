(* Veerman, Stosic, Olvera, Proposition 2: which two-sided flocks stay within D when the leader moves at their main resonance.
     veerman.prop2.  The last car oscillates with a_0 |a_M|, and Theorem 1 gives |a_M| = M/X + O(1/M). *)
From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import veerman_amplitude veerman_theorem1.
From Flockproof Require veerman_numbers.
Open Scope R_scope.

Definition size_factor (f g : R) : R := PI ^ 2 * Rabs g / (8 * sqrt 2 * sqrt (Rabs f)).
Lemma amplitude_factor f g M : f < 0 -> g < 0 -> 0 < size_factor f g /\ size_factor f g * veerman_numbers.amplitude f g M = M.
Proof.
  intros Hf Hg. unfold size_factor, veerman_numbers.amplitude. rewrite !Rabs_left by assumption. rewrite sqrt_mult by lra.
  assert (0 < sqrt 2) by (apply sqrt_lt_R0; lra). assert (0 < sqrt (- f)) by (apply sqrt_lt_R0; lra). pose proof PI_RGT_0.
  split; [|field; lra]. apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat; [apply pow_lt|]; lra|]. apply Rmult_lt_0_compat; lra.
Qed.
(* the tie to the order 1/M, in both directions; for large flocks the printed N <= X D/a_0 without any correction *)
Theorem proposition_2 f g : f < 0 -> g < 0 -> let X := PI ^ 2 * Rabs g / (8 * sqrt 2 * sqrt (Rabs f)) in
  exists C M0, forall N a0 D w, M0 <= INR (S N) -> 0 < a0 -> main_resonance f g N w ->
    (a0 * amplitude f g N w <= D -> INR (S N) <= X * (D / a0) + C / INR (S N)) /\
    (INR (S N) + C / INR (S N) <= X * (D / a0) -> a0 * amplitude f g N w <= D) /\
    (a0 * amplitude f g N w <= D -> INR N <= X * (D / a0)).
Proof.
  intros Hf Hg X. destruct (theorem_1 f g Hf Hg) as (C & M0 & T). exists (X * C), (Rmax M0 (X * C)).
  intros N a0 D w HM A0 W. pose proof (Rmax_l M0 (X * C)) as L1. pose proof (Rmax_r M0 (X * C)) as L2.
  destruct (T N ltac:(lra)) as [_ U]. destruct (U w W) as [_ A]. destruct (amplitude_factor f g (INR (S N)) Hf Hg) as [X0 XM].
  change (size_factor f g) with X in X0, XM. pose proof (lt_0_INR (S N) ltac:(lia)) as M1. set (M := INR (S N)) in *.
  set (P := veerman_numbers.amplitude f g M) in *. apply Rabs_le_between in A. set (a := amplitude f g N w) in *.
  assert (E : X * (C / M) = X * C / M) by (field; lra).
  assert (H1 : a0 * a <= D -> M <= X * (D / a0) + X * C / M).
  { intros H. assert (a <= D / a0) by (apply (Rmult_le_reg_l a0); [exact A0|]; replace (a0 * (D / a0)) with D by (field; lra); exact H).
    assert (X * a <= X * (D / a0)) by (apply Rmult_le_compat_l; lra). assert (X * (P - C / M) <= X * a) by (apply Rmult_le_compat_l; lra). lra. }
  split; [exact H1|]. split.
  - intros H. assert (X * a <= X * (P + C / M)) by (apply Rmult_le_compat_l; lra).
    assert (a <= D / a0) by (apply (Rmult_le_reg_l X); lra).
    apply (Rmult_le_compat_l a0) in H2; [|lra]. replace (a0 * (D / a0)) with D in H2 by (field; lra). exact H2.
  - intros H. specialize (H1 H). assert (X * C / M <= 1).
    { apply (Rmult_le_reg_r M); [exact M1|]. replace (X * C / M * M) with (X * C) by (field; lra). lra. }
    unfold M in *. rewrite S_INR in *. lra.
Qed.
