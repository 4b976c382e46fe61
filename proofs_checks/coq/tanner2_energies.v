(* Tanner, Jadbabaie, Pappas, Part II: the energy (6) is differentiable, and the force of the potentials in (4) is minus its gradient; the energy Q of (11)
   is continuous, differentiable where no pair is at the distance R, and not differentiable where one is; the generalised time derivative (13) of Q.
     tanner2.eq6 (clause 2), tanner2.Qjump, tanner2.eq13. *)
From Coq Require Import Reals Lra Lia Psatz Classical.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums inclusions paley_model paley_phase paley_laplacian paley_gradient tanner_energy tanner_flock tanner2_motion tanner_trees.
From Flockproof Require Import tanner2_lasting.
From Flockproof Require tanner_nonsmooth tanner_saturated tanner2_facts tanner2_filippov tanner2_limits.
Open Scope R_scope.

(* ---- a function of the distance, to first order ---- *)
Lemma norm_first (z h : C) : z <> RtoC 0 -> Rabs (norm (z + h)%C - norm z - inner z h / norm z) <= norm h ^ 2 / norm z.
Proof.
  intros N. pose proof (norm_pos z N) as P. set (a := norm z) in *. set (b := norm (z + h)%C). set (q := norm h ^ 2).
  assert (E : b ^ 2 = a ^ 2 + 2 * inner z h + q).
  { unfold a, b, q. rewrite <- !Rsqr_pow2. unfold Rsqr. rewrite !norm_sqr, !inner_xy. cbn. ring. }
  assert (D : (b - a) ^ 2 <= q).
  { unfold q. rewrite <- (pow2_abs (b - a)), <- (pow2_abs (norm h)). apply pow_incr. split; [apply Rabs_pos|]. rewrite (Rabs_pos_eq (norm h)) by apply norm_ge0.
    unfold a, b. pose proof (norm_near (z + h)%C z) as T. replace (z + h - z)%C with h in T by ring. exact T. }
  replace (b - a - inner z h / a) with ((q - (b - a) ^ 2) / (2 * a)) by (replace (inner z h) with ((b ^ 2 - a ^ 2 - q) / 2) by lra; field; lra).
  pose proof (pow2_ge_0 (b - a)). assert (0 < / (2 * a)) by (apply Rinv_0_lt_compat; lra). unfold Rdiv. rewrite Rabs_mult, (Rabs_pos_eq (/ (2 * a))) by lra.
  rewrite Rabs_pos_eq by lra. apply Rle_trans with (q * / (2 * a)); [apply Rmult_le_compat_r; lra|]. apply Rmult_le_compat_l; [unfold q; apply pow2_ge_0|].
  apply Rinv_le_contravar; lra.
Qed.
Lemma first_order (f : R -> R) x l e : is_derive f x l -> 0 < e -> exists d, 0 < d /\ forall h, Rabs h < d -> Rabs (f (x + h) - f x - l * h) <= e * Rabs h.
Proof.
  intros D He. apply is_derive_Reals in D. destruct (D e He) as [d Hd]. exists d. split; [apply cond_pos|]. intros h Hh.
  destruct (Req_dec h 0) as [->|N]; [rewrite Rplus_0_r, Rmult_0_r, Rminus_eq_0, Rminus_0_r, Rabs_R0; lra|]. specialize (Hd h N Hh).
  replace (f (x + h) - f x - l * h) with (((f (x + h) - f x) / h - l) * h) by (field; exact N). rewrite Rabs_mult. apply Rmult_le_compat_r; [apply Rabs_pos|lra].
Qed.
Lemma pair_first (V : R -> R) (l : R) (z : C) e : z <> RtoC 0 -> is_derive V (norm z) l -> 0 < e ->
  exists d, 0 < d /\ forall h : C, norm h < d -> Rabs (V (norm (z + h)%C) - V (norm z) - inner (RtoC (l / norm z) * z)%C h) <= e * norm h.
Proof.
  intros N D He. pose proof (norm_pos z N) as P. destruct (first_order V (norm z) l (e / 2) D ltac:(lra)) as (d & Hd & F). pose proof (Rabs_pos l) as L0.
  set (d2 := e * norm z / (2 * (Rabs l + 1))). assert (H2 : 0 < d2) by (apply Rdiv_lt_0_compat; [now apply Rmult_lt_0_compat|lra]).
  exists (Rmin d d2). split; [now apply Rmin_glb_lt|]. intros h Hh. pose proof (Rmin_l d d2). pose proof (Rmin_r d d2). pose proof (norm_ge0 h) as Hn.
  set (k := norm (z + h)%C - norm z). assert (Hk : Rabs k <= norm h). { unfold k. pose proof (norm_near (z + h)%C z) as T. replace (z + h - z)%C with h in T by ring. exact T. }
  specialize (F k ltac:(lra)). replace (norm z + k) with (norm (z + h)%C) in F by (unfold k; ring).
  pose proof (norm_first z h N) as G. fold k in G.
  assert (I : inner (RtoC (l / norm z) * z)%C h = l * (inner z h / norm z)) by (rewrite inner_sym, inner_scal, (inner_sym h); field; lra).
  rewrite I. replace (V (norm (z + h)%C) - V (norm z) - l * (inner z h / norm z)) with ((V (norm (z + h)%C) - V (norm z) - l * k) + l * (k - inner z h / norm z)) by ring.
  eapply Rle_trans; [apply Rabs_triang|]. rewrite (Rabs_mult l).
  assert (T1 : e / 2 * Rabs k <= e / 2 * norm h) by (apply Rmult_le_compat_l; lra).
  assert (T2 : Rabs l * Rabs (k - inner z h / norm z) <= Rabs l * (norm h ^ 2 / norm z)) by (apply Rmult_le_compat_l; [lra|exact G]).
  assert (T3 : Rabs l * (norm h ^ 2 / norm z) <= e / 2 * norm h).
  { apply Rmult_le_reg_r with (norm z); [exact P|]. replace (Rabs l * (norm h ^ 2 / norm z) * norm z) with (Rabs l * norm h * norm h) by (field; lra).
    replace (e / 2 * norm h * norm z) with (e * norm z / 2 * norm h) by field. apply Rmult_le_compat_r; [exact Hn|].
    apply Rle_trans with ((Rabs l + 1) * norm h); [apply Rmult_le_compat_r; lra|]. apply Rle_trans with ((Rabs l + 1) * d2); [apply Rmult_le_compat_l; lra|]. right. unfold d2. field. lra. }
  lra.
Qed.
Lemma neq_minus (x y : C) : x <> y -> (x - y)%C <> RtoC 0.
Proof. intros N E. apply N. replace x with ((x - y) + y)%C by ring. rewrite E. ring. Qed.
Lemma norm_sub (x y : C) : norm (x - y)%C <= norm x + norm y.
Proof. eapply Rle_trans; [apply norm_triangle|]. rewrite norm_opp. lra. Qed.

(* ---- the total derivative of a function of positions and velocities: a i and b i are its gradients in r_i and v_i ---- *)
Definition total_derivative n (E : (nat -> C) -> (nat -> C) -> R) (r v a b : nat -> C) := forall e, 0 < e -> exists d, 0 < d /\ forall p u : nat -> C,
  (forall i, (i < n)%nat -> norm (p i) < d /\ norm (u i) < d) ->
  Rabs (E (fun i => r i + p i)%C (fun i => v i + u i)%C - E r v - Sum n (fun i => inner (a i) (p i) + inner (b i) (u i))) <= e * Sum n (fun i => norm (p i) + norm (u i)).
Section Energy.
Variables (n : nat) (adj : graph) (V V' : nat -> nat -> R -> R) (r v : nat -> C).
Hypothesis S : undirected adj.
Hypothesis VS' : forall i j, V' i j = V' j i.
Hypothesis D : forall i j s, (i < n)%nat -> (j < n)%nat -> adj i j = true -> 0 < s -> is_derive (V i j) s (V' i j s).
Hypothesis A : distinct n adj r.
Theorem energy_differentiable : total_derivative n (Wenergy n adj V) r v (grad_i n adj V' r) v.
Proof.
  intros e He. pose proof (pos_INR n) as Pn. set (e1 := e / (2 * (INR n + 1))). assert (H1 : 0 < e1) by (apply Rdiv_lt_0_compat; lra).
  destruct (tanner2_filippov.small2 n (fun i j d => adj i j = true -> forall h : C, norm h < 2 * d ->
    Rabs (V i j (norm (r i - r j + h)%C) - V i j (norm (r i - r j)%C) - inner (grad (V' i j) (r i) (r j)) h) <= e1 * norm h)) as (d & Hd & Q).
  { intros i j d d' H L Ad h Hh. apply H; [exact Ad|lra]. }
  { intros i j Hi Hj. destruct (adj i j) eqn:Ad; [|exists 1; split; [lra|discriminate]]. pose proof (neq_minus _ _ (A i j Hi Hj Ad)) as N.
    destruct (pair_first (V i j) (V' i j (norm (r i - r j)%C)) (r i - r j)%C e1 N (D i j _ Hi Hj Ad (norm_pos _ N)) H1) as (d & Hd & F).
    exists (d / 2). split; [lra|]. intros _ h Hh. apply F. lra. }
  exists (Rmin d e). split; [now apply Rmin_glb_lt|]. intros p u B. pose proof (Rmin_l d e). pose proof (Rmin_r d e).
  assert (Lin : Sum n (fun i => inner (grad_i n adj V' r i) (p i)) = / 2 * Sum n (fun i => Sum n (fun j => inner (pair_grad adj V' r i j) (p i - p j)%C))).
  { rewrite (pair_sum_swap n (pair_grad adj V' r) (fun i _ => p i) 0); [apply Sum_ext; intros; unfold grad_i; apply inner_sym|].
    intros i j _ _. unfold pair_grad, w. rewrite (S j i), (VS' j i), grad_antisym. destruct (adj i j); ring. }
  rewrite Sum_plus, Lin.
  set (g := fun i j => w adj i j * (V i j (norm (r i + p i - (r j + p j))%C) - V i j (norm (r i - r j)%C)) - inner (pair_grad adj V' r i j) (p i - p j)%C).
  assert (E : Wenergy n adj V (fun i => r i + p i)%C (fun i => v i + u i)%C - Wenergy n adj V r v -
      (/ 2 * Sum n (fun i => Sum n (fun j => inner (pair_grad adj V' r i j) (p i - p j)%C)) + Sum n (fun i => inner (v i) (u i))) =
    / 2 * Sum n (fun i => Sum n (g i) + norm (u i) ^ 2)).
  { unfold Wenergy, V_i. rewrite <- Rmult_minus_distr_l. replace (Sum n (fun i => inner (v i) (u i))) with (/ 2 * Sum n (fun i => 2 * inner (v i) (u i))) by (rewrite Sum_scal; field).
    rewrite <- Rmult_plus_distr_l, <- Rmult_minus_distr_l. f_equal. rewrite <- Sum_minus, <- Sum_plus, <- Sum_minus. apply Sum_ext. intros i _. unfold g.
    rewrite Sum_minus. rewrite (Sum_ext n (fun j => w adj i j * (_ - _)) (fun j => w adj i j * V i j (norm (r i + p i - (r j + p j))%C) - w adj i j * V i j (norm (r i - r j)%C))) by (intros; ring).
    rewrite Sum_minus, <- Rsqr_pow2. unfold Rsqr. rewrite norm_sqr, !inner_xy. cbn. ring. }
  rewrite E. clear E Lin. rewrite Rabs_mult, Rabs_pos_eq by lra.
  assert (G : forall i j, (i < n)%nat -> (j < n)%nat -> Rabs (g i j) <= e1 * (norm (p i) + norm (p j))).
  { intros i j Hi Hj. pose proof (norm_ge0 (p i)). pose proof (norm_ge0 (p j)). unfold g, pair_grad, w. destruct (adj i j) eqn:Ad.
    - destruct (B i Hi), (B j Hj). pose proof (norm_sub (p i) (p j)) as T. rewrite inner_sym, inner_scal, inner_sym, !Rmult_1_l.
      replace (r i + p i - (r j + p j))%C with (r i - r j + (p i - p j))%C by ring. eapply Rle_trans; [apply (Q i j Hi Hj Ad); lra|]. apply Rmult_le_compat_l; lra.
    - rewrite inner_sym, inner_scal, !Rmult_0_l, Rminus_0_r, Rabs_R0. apply Rmult_le_pos; lra. }
  set (X := Sum n (fun i => norm (p i))). set (Y := Sum n (fun i => norm (u i))).
  assert (X0 : 0 <= X) by (apply Sum_ge0; intros; apply norm_ge0). assert (Y0 : 0 <= Y) by (apply Sum_ge0; intros; apply norm_ge0).
  assert (T : Rabs (Sum n (fun i => Sum n (g i) + norm (u i) ^ 2)) <= e1 * (2 * (INR n * X)) + e * Y).
  { eapply Rle_trans; [apply Sum_Rabs|]. apply Rle_trans with (Sum n (fun i => Sum n (fun j => e1 * (norm (p i) + norm (p j))) + e * norm (u i))).
    - apply Sum_le. intros i Hi. eapply Rle_trans; [apply Rabs_triang|]. apply Rplus_le_compat.
      + eapply Rle_trans; [apply Sum_Rabs|]. apply Sum_le. intros j Hj. now apply G.
      + rewrite Rabs_pos_eq by apply pow2_ge_0. destruct (B i Hi) as [_ Bu]. replace (norm (u i) ^ 2) with (norm (u i) * norm (u i)) by ring.
        apply Rmult_le_compat_r; [apply norm_ge0|lra].
    - rewrite Sum_plus, Sum_scal. fold Y. apply Rplus_le_compat_r. right.
      rewrite (Sum_ext n _ (fun i => e1 * (INR n * norm (p i) + X))); [|intros i _; rewrite Sum_scal, Sum_plus, Sum_const; reflexivity].
      rewrite Sum_scal, Sum_plus, Sum_scal, Sum_const. fold X. ring. }
  replace (Sum n (fun i => norm (p i) + norm (u i))) with (X + Y) by (unfold X, Y; now rewrite Sum_plus). assert (K : e1 * (2 * (INR n * X)) <= e * X).
  { unfold e1. replace (e / (2 * (INR n + 1)) * (2 * (INR n * X))) with (e * X * (INR n / (INR n + 1))) by (field; lra). rewrite <- (Rmult_1_r (e * X)) at 2.
    apply Rmult_le_compat_l; [apply Rmult_le_pos; lra|]. apply Rmult_le_reg_r with (INR n + 1); [lra|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l; lra. }
  assert (0 <= e * X) by (apply Rmult_le_pos; lra). assert (0 <= e * Y) by (apply Rmult_le_pos; lra). rewrite Rmult_plus_distr_l. lra.
Qed.
End Energy.

(* ---- Q of (11) ---- *)
Notation Qs := tanner2_facts.Qsat.
Section Saturated.
Variables (n : nat) (V V' : nat -> nat -> R -> R) (R0 : R).
Hypothesis HR : 0 < R0.
Hypothesis VS : forall i j, V i j = V j i.
Hypothesis D : forall i j s, (i < n)%nat -> (j < n)%nat -> i <> j -> 0 < s -> is_derive (V i j) s (V' i j s).
Theorem Q_continuous (r v : nat -> C) : distinct n complete r -> forall e, 0 < e -> exists d, 0 < d /\ forall q u : nat -> C,
  (forall i, (i < n)%nat -> norm (q i - r i)%C < d /\ norm (u i - v i)%C < d) -> Rabs (Qs n V R0 q u - Qs n V R0 r v) < e.
Proof.
  intros A. set (x := joined n (fun i _ => r i) (fun i _ => v i) 0).
  assert (J : forall q u i, (i < n)%nat -> place n (joined n (fun i _ => q i) (fun i _ => u i) 0) i = q i /\ speed n (joined n (fun i _ => q i) (fun i _ => u i) 0) i = u i).
  { intros q u i Hi. exact (joined_parts n (fun i _ => q i) (fun i _ => u i) 0 i Hi). }
  assert (Ex : forall q u, Qs n V R0 (place n (joined n (fun i _ => q i) (fun i _ => u i) 0)) (speed n (joined n (fun i _ => q i) (fun i _ => u i) 0)) = Qs n V R0 q u).
  { intros q u. unfold Qs. f_equal. apply Sum_ext. intros i Hi. destruct (J q u i Hi) as [_ ->]. f_equal. apply Sum_ext. intros j Hj. unfold tanner2_facts.sat_pair.
    destruct (J q u i Hi) as [-> _]. destruct (J q u j Hj) as [-> _]. reflexivity. }
  assert (Ct : cont (4 * n) (fun y => Qs n V R0 (place n y) (speed n y)) x).
  { unfold Qs. apply cont_scal. apply (cont_Sum _ n (fun i y => Sum n (fun j => tanner2_facts.sat_pair V R0 (place n y) i j) + inner (speed n y i) (speed n y i))). intros i Hi.
    apply cont_plus.
    - apply (cont_Sum _ n (fun j y => tanner2_facts.sat_pair V R0 (place n y) i j)). intros j Hj. unfold tanner2_facts.sat_pair. destruct (Nat.eqb_spec i j) as [_|Ne]; [apply cont_const|].
      apply (cont_ext _ (fun y => V i j (Rmin (norm (place n y i - place n y j)%C) R0))); [intros y; symmetry; apply tanner_nonsmooth.saturated_min|].
      apply (cont_comp _ (fun s => V i j (Rmin s R0)) (fun y => norm (place n y i - place n y j)%C)); [|now apply cont_norm].
      assert (Pn : 0 < norm (place n x i - place n x j)%C).
      { unfold x. rewrite (proj1 (J r v i Hi)), (proj1 (J r v j Hj)). apply norm_neq, A; try assumption. unfold complete. destruct (Nat.eqb_spec i j); [contradiction|reflexivity]. }
      apply (continuity_pt_comp (fun s => Rmin s R0) (V i j)).
      + apply lipschitz_continuous. intros a b. unfold Rmin, Rabs. destruct (Rle_dec a R0), (Rle_dec b R0); repeat destruct (Rcase_abs _); lra.
      + apply derivable_continuous_pt. exists (V' i j (Rmin (norm (place n x i - place n x j)%C) R0)). apply is_derive_Reals. apply D; try assumption. now apply Rmin_glb_lt.
    - apply (cont_ext _ (fun y => y (2 * n + i)%nat * y (2 * n + i)%nat + y (3 * n + i)%nat * y (3 * n + i)%nat)); [intros y; rewrite inner_xy; reflexivity|].
      apply cont_plus; apply cont_mult; apply cont_coord; lia. }
  intros e He. destruct (Ct e He) as (d & Hd & K). exists d. split; [exact Hd|]. intros q u B. rewrite <- (Ex q u), <- (Ex r v). apply K. intros k Hk.
  assert (Y : exists i c, (i < n)%nat /\ (c < 4)%nat /\ k = (c * n + i)%nat).
  { exists (k mod n)%nat, (k / n)%nat. assert (n <> 0)%nat by lia. pose proof (Nat.div_mod k n H). pose proof (Nat.mod_upper_bound k n H). split; [lia|]. split; [apply Nat.div_lt_upper_bound; lia|lia]. }
  destruct Y as (i & c & Hi & Hc & ->). destruct (J q u i Hi) as [Jq Ju]. destruct (J r v i Hi) as [Jr Jv]. destruct (B i Hi) as [B1 B2]. unfold x. unfold place, speed in *.
  set (jq := joined n (fun i _ => q i) (fun i _ => u i) 0) in *. set (jr := joined n (fun i _ => r i) (fun i _ => v i) 0) in *.
  rewrite <- Jq, <- Jr in B1. rewrite <- Ju, <- Jv in B2. pose proof (fst_le (jq i - jr i, jq (n + i)%nat - jr (n + i)%nat)%R) as F1. pose proof (snd_le (jq i - jr i, jq (n + i)%nat - jr (n + i)%nat)%R) as F2.
  pose proof (fst_le (jq (2 * n + i)%nat - jr (2 * n + i)%nat, jq (3 * n + i)%nat - jr (3 * n + i)%nat)%R) as F3. pose proof (snd_le (jq (2 * n + i)%nat - jr (2 * n + i)%nat, jq (3 * n + i)%nat - jr (3 * n + i)%nat)%R) as F4.
  cbn [fst snd] in *. destruct c as [|[|[|[|c]]]]; [| | | |lia].
  - replace (0 * n + i)%nat with i by lia. eapply Rle_lt_trans; [exact F1|exact B1].
  - replace (1 * n + i)%nat with (n + i)%nat by lia. eapply Rle_lt_trans; [exact F2|exact B1].
  - eapply Rle_lt_trans; [exact F3|exact B2].
  - eapply Rle_lt_trans; [exact F4|exact B2].
Qed.
End Saturated.

(* ---- where no pair is at the distance R ---- *)
Section Gradient.
Variables (n : nat) (V V' : nat -> nat -> R -> R) (R0 : R) (r v : nat -> C).
Hypothesis VS : forall i j, V i j = V j i.
Hypothesis VS' : forall i j, V' i j = V' j i.
Hypothesis D : forall i j s, (i < n)%nat -> (j < n)%nat -> i <> j -> 0 < s -> is_derive (V i j) s (V' i j s).
Hypothesis A : distinct n complete r.
Hypothesis G : tanner2_limits.generic n R0 r.
Notation near0 := (tanner2_facts.near).
Lemma near_stable : exists d, 0 < d /\ forall q : nat -> C, (forall i, (i < n)%nat -> norm (q i - r i)%C < d) -> forall i j, (i < n)%nat -> (j < n)%nat -> near0 q R0 i j = near0 r R0 i j.
Proof.
  destruct (tanner2_filippov.small2 n (fun i j d => forall q : nat -> C, norm (q i - r i)%C < d -> norm (q j - r j)%C < d -> near0 q R0 i j = near0 r R0 i j)) as (d & Hd & K).
  - intros i j d d' H L q H1 H2. apply H; lra.
  - intros i j Hi Hj. unfold near0. destruct (Nat.eqb_spec i j) as [|Ne]; [exists 1; split; [lra|reflexivity]|]. specialize (G i j Hi Hj Ne). change (norm (r i - r j)%C <> R0) in G.
    set (g := Rabs (norm (r i - r j)%C - R0)). assert (Hg : 0 < g) by (apply Rabs_pos_lt; lra). exists (g / 2). split; [lra|]. intros q H1 H2.
    pose proof (norm_near (q i - q j)%C (r i - r j)%C) as T. replace (q i - q j - (r i - r j))%C with ((q i - r i) - (q j - r j))%C in T by ring.
    pose proof (norm_sub (q i - r i)%C (q j - r j)%C) as T2. apply Rabs_le_between in T. unfold g, Rabs in *.
    destruct (Rcase_abs _), (Rlt_dec (norm (q i - q j)%C) R0), (Rlt_dec (norm (r i - r j)%C) R0); try reflexivity; lra.
  - exists d. split; [exact Hd|]. intros q H i j Hi Hj. apply (K i j Hi Hj q); now apply H.
Qed.
Theorem Q_gradient : total_derivative n (Qs n V R0) r v (grad_i n (near0 r R0) V' r) v.
Proof.
  intros e He. assert (Nl : forall i j, near0 r R0 i j = true -> i <> j) by (intros i j H ->; unfold near0 in H; now rewrite Nat.eqb_refl in H).
  destruct near_stable as (d1 & H1 & St).
  destruct (energy_differentiable n (near0 r R0) V V' r v (tanner2_facts.near_undirected r R0) VS') with (e := e) as (d & Hd & K).
  - intros i j s Hi Hj Ad Hs. apply D; try assumption. now apply Nl.
  - intros i j Hi Hj Ad. apply A; try assumption. unfold complete. destruct (Nat.eqb_spec i j) as [E|]; [exfalso; now apply (Nl i j)|reflexivity].
  - exact He.
  - exists (Rmin d d1). split; [now apply Rmin_glb_lt|]. intros p u B. pose proof (Rmin_l d d1). pose proof (Rmin_r d d1).
    rewrite <- (tanner2_facts.Q_two_forms n V R0 (fun i => r i + p i)%C (fun i => v i + u i)%C VS), <- (tanner2_facts.Q_two_forms n V R0 r v VS).
    assert (Sp : forall i j, (i < n)%nat -> (j < n)%nat -> near0 (fun i => r i + p i)%C R0 i j = near0 r R0 i j).
    { apply St. intros i Hi. replace (r i + p i - r i)%C with (p i) by ring. destruct (B i Hi). lra. }
    assert (E1 : forall x y, Wenergy n (near0 (fun i => r i + p i)%C R0) V x y = Wenergy n (near0 r R0) V x y).
    { intros x y. unfold Wenergy, V_i. f_equal. apply Sum_ext. intros i Hi. f_equal. apply Sum_ext. intros j Hj. unfold w. now rewrite Sp. }
    assert (E2 : Sum n (fun i => Sum i (fun j => (1 - w (near0 (fun i => r i + p i)%C R0) i j) * V i j R0)) = Sum n (fun i => Sum i (fun j => (1 - w (near0 r R0) i j) * V i j R0))).
    { apply Sum_ext. intros i Hi. apply Sum_ext. intros j Hj. unfold w. rewrite Sp by lia. reflexivity. }
    rewrite E1, E2. set (c := Sum n (fun i => Sum i (fun j => _))). specialize (K p u ltac:(intros i Hi; specialize (B i Hi); lra)).
    match goal with |- Rabs (?a + c - (?b + c) - ?s) <= _ => replace (a + c - (b + c) - s) with (a - b - s) by ring end. exact K.
Qed.
End Gradient.

(* ---- where a pair is at the distance R and V' is positive there: moved apart and together, Q falls on one side and stays on the other ---- *)
Section Tie.
Variables (n : nat) (V V' : nat -> nat -> R -> R) (R0 : R) (r v : nat -> C).
Hypothesis HR : 0 < R0.
Hypothesis VS : forall i j, V i j = V j i.
Hypothesis D : forall i j s, (i < n)%nat -> (j < n)%nat -> i <> j -> 0 < s -> is_derive (V i j) s (V' i j s).
Hypothesis Up : forall i j, (i < n)%nat -> (j < n)%nat -> i <> j -> 0 < V' i j R0.
Hypothesis A : distinct n complete r.
Lemma apart_pair i j : (i < n)%nat -> (j < n)%nat -> i <> j -> r i <> r j.
Proof. intros Hi Hj Ne. apply A; try assumption. unfold complete. destruct (Nat.eqb_spec i j); [contradiction|reflexivity]. Qed.
(* what a pair gains in all if one of its agents is moved by h, and by -h: little, at most; less than nothing at the distance R along the line *)
Definition U i j (z : C) := V i j (Rmin (norm z) R0).
Lemma U_gains i j e : (i < n)%nat -> (j < n)%nat -> i <> j -> 0 < e -> exists d, 0 < d /\ forall h : C, norm h < d ->
  U i j (r i - r j + h)%C + U i j (r i - r j - h)%C - 2 * U i j (r i - r j)%C <= e * norm h.
Proof.
  intros Hi Hj Ne He. pose proof (neq_minus _ _ (apart_pair i j Hi Hj Ne)) as N. pose proof (norm_pos _ N) as P. set (z := (r i - r j)%C) in *.
  assert (Nr : forall h : C, Rabs (norm (z + h)%C - norm z) <= norm h). { intros h. pose proof (norm_near (z + h)%C z) as T. replace (z + h - z)%C with h in T by ring. exact T. }
  assert (Nm : forall h : C, norm (- h)%C = norm h) by exact norm_opp.
  destruct (Rtotal_order (norm z) R0) as [L|[E|L]].
  - destruct (pair_first (V i j) (V' i j (norm z)) z (e / 2) N (D i j _ Hi Hj Ne P) ltac:(lra)) as (d & Hd & F).
    exists (Rmin d (R0 - norm z)). split; [apply Rmin_glb_lt; lra|]. intros h Hh. pose proof (Rmin_l d (R0 - norm z)). pose proof (Rmin_r d (R0 - norm z)).
    pose proof (F h ltac:(lra)) as F1. pose proof (F (- h)%C ltac:(rewrite Nm; lra)) as F2. pose proof (Nr h) as N1. pose proof (Nr (- h)%C) as N2. rewrite Nm in N2, F2.
    change (z + - h)%C with (z - h)%C in *. apply Rabs_le_between in F1, F2, N1, N2. unfold U. rewrite !Rmin_left by lra.
    assert (I : inner (RtoC (V' i j (norm z) / norm z) * z)%C (- h)%C = - inner (RtoC (V' i j (norm z) / norm z) * z)%C h) by (rewrite !inner_xy; cbn; ring).
    rewrite I in F2. lra.
  - destruct (first_order (V i j) R0 (V' i j R0) (e / 2) (D i j R0 Hi Hj Ne HR) ltac:(lra)) as (d & Hd & F). pose proof (Up i j Hi Hj Ne) as Pu.
    assert (B : forall h : C, norm h < d -> U i j (z + h)%C - V i j R0 <= e / 2 * norm h).
    { intros h Hh. pose proof (norm_ge0 h) as H0. assert (0 <= e / 2 * norm h) by (apply Rmult_le_pos; lra). unfold U.
      destruct (Rle_or_lt R0 (norm (z + h)%C)) as [G|G]; [rewrite Rmin_right by lra; lra|]. rewrite Rmin_left by lra.
      pose proof (Nr h) as N1. rewrite E in N1. apply Rabs_le_between in N1. specialize (F (norm (z + h)%C - R0) ltac:(apply Rabs_def1; lra)).
      replace (R0 + (norm (z + h)%C - R0)) with (norm (z + h)%C) in F by ring. rewrite (Rabs_left (norm (z + h)%C - R0)) in F by lra. apply Rabs_le_between in F.
      assert (V' i j R0 * (norm (z + h)%C - R0) <= 0) by (rewrite <- (Rmult_0_r (V' i j R0)); apply Rmult_le_compat_l; lra).
      assert (e / 2 * - (norm (z + h)%C - R0) <= e / 2 * norm h) by (apply Rmult_le_compat_l; lra). lra. }
    exists d. split; [exact Hd|]. intros h Hh. pose proof (B h Hh) as B1. pose proof (B (- h)%C ltac:(rewrite Nm; exact Hh)) as B2. rewrite Nm in B2. change (z + - h)%C with (z - h)%C in B2.
    assert (Z : U i j z = V i j R0) by (unfold U; now rewrite E, Rmin_left by lra). rewrite Z. lra.
  - exists (norm z - R0). split; [lra|]. intros h Hh. pose proof (Nr h) as N1. pose proof (Nr (- h)%C) as N2. rewrite Nm in N2. change (z + - h)%C with (z - h)%C in *.
    apply Rabs_le_between in N1, N2. unfold U. rewrite !Rmin_right by lra. pose proof (norm_ge0 h). assert (0 <= e * norm h) by (apply Rmult_le_pos; lra). lra.
Qed.
Lemma U_falls i j : (i < n)%nat -> (j < n)%nat -> i <> j -> norm (r i - r j)%C = R0 -> exists d, 0 < d /\ forall t, 0 < t < d -> forall h, h = (RtoC (t / R0) * (r i - r j))%C ->
  U i j (r i - r j + h)%C + U i j (r i - r j - h)%C - 2 * U i j (r i - r j)%C <= - (V' i j R0 / 2) * t.
Proof.
  intros Hi Hj Ne E. pose proof (Up i j Hi Hj Ne) as Pu. set (z := (r i - r j)%C) in *.
  destruct (first_order (V i j) R0 (V' i j R0) (V' i j R0 / 2) (D i j R0 Hi Hj Ne HR) ltac:(lra)) as (d & Hd & F).
  exists (Rmin d R0). split; [now apply Rmin_glb_lt|]. intros t Ht h ->. pose proof (Rmin_l d R0). pose proof (Rmin_r d R0).
  assert (Q : 0 < t / R0 < 1). { split; [apply Rdiv_lt_0_compat; lra|]. apply Rmult_lt_reg_r with R0; [exact HR|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l; lra. }
  assert (N1 : norm (z + RtoC (t / R0) * z)%C = R0 + t).
  { replace (z + RtoC (t / R0) * z)%C with (RtoC (1 + t / R0) * z)%C by (rewrite RtoC_plus; ring). rewrite norm_scal, E, Rabs_pos_eq by lra. field. lra. }
  assert (N2 : norm (z - RtoC (t / R0) * z)%C = R0 - t).
  { replace (z - RtoC (t / R0) * z)%C with (RtoC (1 + - (t / R0)) * z)%C by (rewrite RtoC_plus, RtoC_opp; ring). rewrite norm_scal, E, Rabs_pos_eq by lra. field. lra. }
  unfold U. rewrite N1, N2, E. rewrite (Rmin_right (R0 + t)), (Rmin_left (R0 - t)), (Rmin_left R0 R0) by lra.
  specialize (F (- t) ltac:(rewrite Rabs_Ropp, Rabs_pos_eq by lra; lra)). rewrite Rabs_Ropp, (Rabs_pos_eq t) in F by lra. apply Rabs_le_between in F.
  replace (R0 + - t) with (R0 - t) in F by ring. lra.
Qed.
Lemma Q_is (q : nat -> C) : Qs n V R0 q v = / 2 * Sum n (fun i => Sum n (fun j => if Nat.eqb i j then 0 else U i j (q i - q j)%C) + inner (v i) (v i)).
Proof.
  unfold Qs. f_equal. apply Sum_ext. intros i _. f_equal. apply Sum_ext. intros j _. unfold tanner2_facts.sat_pair. destruct (Nat.eqb i j); [reflexivity|].
  apply tanner_nonsmooth.saturated_min.
Qed.
Theorem Q_nonsmooth i0 j0 : (i0 < n)%nat -> (j0 < n)%nat -> i0 <> j0 -> norm (r i0 - r j0)%C = R0 -> ~ exists a b, total_derivative n (Qs n V R0) r v a b.
Proof.
  intros Hi0 Hj0 Ne0 E (a & b & T). pose proof (Up i0 j0 Hi0 Hj0 Ne0) as Pc. set (c := V' i0 j0 R0) in *. pose proof (pos_INR n) as Pn.
  set (e := c / (8 * (INR n + 1))). assert (He : 0 < e) by (apply Rdiv_lt_0_compat; lra).
  destruct (tanner2_filippov.small2 n (fun i j d => i <> j -> forall h : C, norm h < d -> U i j (r i - r j + h)%C + U i j (r i - r j - h)%C - 2 * U i j (r i - r j)%C <= e * norm h)) as (d & Hd & K).
  { intros i j x y H L Ne h Hh. apply H; [exact Ne|lra]. }
  { intros i j Hi Hj. destruct (Nat.eq_dec i j) as [->|Ne]; [exists 1; split; [lra|congruence]|]. destruct (U_gains i j e Hi Hj Ne He) as (d & Hd & K). exists d. split; [exact Hd|]. intros _. exact K. }
  destruct (U_falls i0 j0 Hi0 Hj0 Ne0 E) as (d2 & Hd2 & K2). destruct (T (c / 16) ltac:(lra)) as (d3 & Hd3 & K3).
  set (t := Rmin d (Rmin d2 d3) / 2). assert (Ht : 0 < t) by (unfold t; assert (0 < Rmin d (Rmin d2 d3)) by (repeat apply Rmin_glb_lt; assumption); lra).
  assert (t < d /\ t < d2 /\ t < d3) as (L1 & L2 & L3). { pose proof (Rmin_l d (Rmin d2 d3)). pose proof (Rmin_r d (Rmin d2 d3)). pose proof (Rmin_l d2 d3). pose proof (Rmin_r d2 d3). unfold t in *. lra. }
  set (h := (RtoC (t / R0) * (r i0 - r j0))%C). assert (Nh : norm h = t).
  { unfold h. rewrite norm_scal, E, Rabs_pos_eq by (apply Rlt_le, Rdiv_lt_0_compat; lra). field. lra. }
  set (p := fun (s : R) k => if Nat.eqb k i0 then (RtoC s * h)%C else RtoC 0).
  assert (Sp : forall s, Rabs s = 1 -> Sum n (fun k => norm (p s k) + norm ((fun _ => RtoC 0) k)) = t).
  { intros s Hs. rewrite (Sum_ext n _ (fun k => delta k i0 * t)); [apply (Sum_delta n i0 (fun _ => t) Hi0)|]. intros k _. unfold p, delta. unfold norm at 2. rewrite Cmod_0.
    destruct (Nat.eqb k i0); [rewrite norm_scal, Hs, Nh; ring|unfold norm; rewrite Cmod_0; ring]. }
  assert (Ip : forall s, Sum n (fun k => inner (a k) (p s k) + inner (b k) ((fun _ => RtoC 0) k)) = s * inner (a i0) h).
  { intros s. rewrite (Sum_ext n _ (fun k => delta k i0 * (s * inner (a k) h))); [apply (Sum_delta n i0 (fun k => s * inner (a k) h) Hi0)|]. intros k _. unfold p, delta.
    destruct (Nat.eqb k i0); rewrite !inner_xy; cbn; ring. }
  assert (Q1 : forall s, Rabs s = 1 -> Rabs (Qs n V R0 (fun k => r k + p s k)%C v - Qs n V R0 r v - s * inner (a i0) h) <= c / 16 * t).
  { intros s Hs. specialize (K3 (p s) (fun _ => RtoC 0)). cbv beta in K3. rewrite (Sp s Hs), Ip in K3.
    replace (Qs n V R0 (fun k => r k + p s k)%C v) with (Qs n V R0 (fun i => r i + p s i)%C (fun i => v i + RtoC 0)%C); [apply K3|].
    - intros k Hk. unfold p. unfold norm at 2. rewrite Cmod_0. split; [|exact Hd3]. destruct (Nat.eqb k i0); [rewrite norm_scal, Hs, Nh; lra|unfold norm; rewrite Cmod_0; exact Hd3].
    - unfold Qs. f_equal. apply Sum_ext. intros k _. f_equal. replace (v k + RtoC 0)%C with (v k) by ring. reflexivity. }
  pose proof (Q1 1 Rabs_R1) as P1. pose proof (Q1 (-1) Rabs_m1) as P2. apply Rabs_le_between in P1, P2.
  set (s := fun i j => if Nat.eqb i j then 0 else U i j (r i + p 1 i - (r j + p 1 j))%C + U i j (r i + p (-1) i - (r j + p (-1) j))%C - 2 * U i j (r i - r j)%C).
  assert (Eq : Qs n V R0 (fun k => r k + p 1 k)%C v + Qs n V R0 (fun k => r k + p (-1) k)%C v - 2 * Qs n V R0 r v = / 2 * Sum n (fun i => Sum n (s i))).
  { rewrite !Q_is. replace (/ 2 * _ + / 2 * _ - 2 * (/ 2 * _)) with (/ 2 * (Sum n (fun i => Sum n (fun j => if Nat.eqb i j then 0 else U i j (r i + p 1 i - (r j + p 1 j))%C) + inner (v i) (v i)) +
      Sum n (fun i => Sum n (fun j => if Nat.eqb i j then 0 else U i j (r i + p (-1) i - (r j + p (-1) j))%C) + inner (v i) (v i)) -
      2 * Sum n (fun i => Sum n (fun j => if Nat.eqb i j then 0 else U i j (r i - r j)%C) + inner (v i) (v i)))) by ring.
    f_equal. rewrite <- Sum_scal, <- Sum_plus, <- Sum_minus. apply Sum_ext. intros i _.
    transitivity (Sum n (fun j => if Nat.eqb i j then 0 else U i j (r i + p 1 i - (r j + p 1 j))%C) + Sum n (fun j => if Nat.eqb i j then 0 else U i j (r i + p (-1) i - (r j + p (-1) j))%C) -
      2 * Sum n (fun j => if Nat.eqb i j then 0 else U i j (r i - r j)%C)); [ring|]. rewrite <- Sum_scal, <- Sum_plus, <- Sum_minus. apply Sum_ext. intros j _. unfold s. destruct (Nat.eqb i j); ring. }
  assert (Uo : forall i j (z : C), U i j z = U j i (- z)%C) by (intros; unfold U; now rewrite norm_opp, VS).
  assert (Bd : forall i j, (i < n)%nat -> (j < n)%nat -> s i j <= e * t * (delta i i0 + delta j i0) - c / 2 * t * (delta i i0 * delta j j0 + delta j i0 * delta i j0)).
  { intros i j Hi Hj. assert (0 < e * t) by now apply Rmult_lt_0_compat. assert (0 < c / 2 * t) by (apply Rmult_lt_0_compat; lra). unfold s, p, delta.
    destruct (Nat.eqb_spec i j) as [->|Ne].
    - destruct (Nat.eqb_spec j i0) as [->|]; [|lra]. destruct (Nat.eqb_spec i0 j0); [contradiction|]. lra.
    - assert (Hneg : forall x y : C, (x + RtoC (-1) * h - (y + 0))%C = (x - y - h)%C) by (intros; apply injective_projections; cbn; ring).
      assert (Hpos : forall x y : C, (x + RtoC 1 * h - (y + 0))%C = (x - y + h)%C) by (intros; apply injective_projections; cbn; ring).
      assert (Hneg' : forall x y : C, (x + 0 - (y + RtoC (-1) * h))%C = (x - y + h)%C) by (intros; apply injective_projections; cbn; ring).
      assert (Hpos' : forall x y : C, (x + 0 - (y + RtoC 1 * h))%C = (x - y - h)%C) by (intros; apply injective_projections; cbn; ring).
      destruct (Nat.eqb_spec i i0) as [->|Ni].
      + destruct (Nat.eqb_spec j i0) as [|Nj]; [congruence|]. rewrite Hneg, Hpos. destruct (Nat.eqb_spec j j0) as [->|Nj0].
        * pose proof (K2 t ltac:(lra) h eq_refl) as B. fold c in B. lra.
        * pose proof (K i0 j Hi0 Hj Ne h ltac:(lra)) as B. rewrite Nh in B. lra.
      + destruct (Nat.eqb_spec j i0) as [->|Nj].
        * rewrite Hneg', Hpos'. destruct (Nat.eqb_spec i j0) as [->|Nj0].
          -- pose proof (K2 t ltac:(lra) h eq_refl) as B. fold c in B. rewrite (Uo j0 i0 (r j0 - r i0 - h)%C), (Uo j0 i0 (r j0 - r i0 + h)%C), (Uo j0 i0 (r j0 - r i0)%C).
             replace (- (r j0 - r i0 - h))%C with (r i0 - r j0 + h)%C by ring. replace (- (r j0 - r i0 + h))%C with (r i0 - r j0 - h)%C by ring. replace (- (r j0 - r i0))%C with (r i0 - r j0)%C by ring. lra.
          -- pose proof (K i i0 Hi Hi0 Ne h ltac:(lra)) as B. rewrite Nh in B. lra.
        * replace (r i + 0 - (r j + 0))%C with (r i - r j)%C by ring. lra. }
  assert (Tot : Sum n (fun i => Sum n (s i)) <= e * t * (2 * INR n) - c * t).
  { apply Rle_trans with (Sum n (fun i => Sum n (fun j => e * t * (delta i i0 + delta j i0) - c / 2 * t * (delta i i0 * delta j j0 + delta j i0 * delta i j0)))).
    - apply Sum_le. intros i Hi. apply Sum_le. intros j Hj. now apply Bd.
    - right. rewrite (Sum_ext n _ (fun i => delta i i0 * (e * t * INR n - c / 2 * t) + e * t + - (delta i j0 * (c / 2 * t)))).
      + rewrite !Sum_plus, Sum_opp, (Sum_delta n i0 (fun _ => e * t * INR n - c / 2 * t) Hi0), (Sum_delta n j0 (fun _ => c / 2 * t) Hj0), Sum_const. field.
      + intros i _. rewrite (Sum_ext n _ (fun j => (e * t * delta i i0 + delta j i0 * (e * t)) - (delta j j0 * (c / 2 * t * delta i i0) + delta j i0 * (c / 2 * t * delta i j0)))) by (intros; ring).
        rewrite Sum_minus, !Sum_plus, Sum_const, (Sum_delta n i0 (fun _ => e * t) Hi0), (Sum_delta n j0 (fun _ => c / 2 * t * delta i i0) Hj0), (Sum_delta n i0 (fun _ => c / 2 * t * delta i j0) Hi0). ring. }
  assert (Ke : e * t * (2 * INR n) <= c / 4 * t).
  { unfold e. replace (c / (8 * (INR n + 1)) * t * (2 * INR n)) with (c / 4 * t * (INR n / (INR n + 1))) by (field; lra). rewrite <- (Rmult_1_r (c / 4 * t)) at 2.
    apply Rmult_le_compat_l; [apply Rmult_le_pos; lra|]. apply Rmult_le_reg_r with (INR n + 1); [lra|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l; lra. }
  assert (0 < c * t) by now apply Rmult_lt_0_compat. lra.
Qed.
End Tie.

(* ---- (13): the generalised time derivative of Q along (10), with the generalised gradient of Q (limits of gradients from states without a pair at R, and
   their convex hull) and K of the whole vector field. For x in it one vertex of the generalised gradient is enough on either side. ---- *)
Section Derivative13.
Import tanner2_filippov tanner2_limits.
Variables (n : nat) (V V' : nat -> nat -> R -> R) (R0 : R) (r v : nat -> C).
Hypothesis HR : 0 < R0.
Hypothesis P : potentials n complete V V'.
Hypothesis A : apart_at n complete r.
Definition limit_of_gradient (y z : nat -> C) := forall e, 0 < e -> exists q u : nat -> C,
  (forall i, (i < n)%nat -> Cmod (q i - r i)%C < e /\ Cmod (u i - v i)%C < e) /\ generic n R0 q /\
  forall i, (i < n)%nat -> Cmod (gradV n (by_distance q R0) V' q i - y i)%C < e /\ Cmod (u i - z i)%C < e.
Definition gradient_Q (a b : nat -> C) := exists m (c : nat -> R) (y z : nat -> nat -> C), (forall k, (k < m)%nat -> 0 <= c k /\ limit_of_gradient (y k) (z k)) /\ Sum m c = 1 /\
  forall i, (i < n)%nat -> a i = Csum m (fun k => RtoC (c k) * y k i)%C /\ b i = Csum m (fun k => RtoC (c k) * z k i)%C.
Definition derivative_Q (x : R) := forall a b, gradient_Q a b -> exists z, K10 n V' R0 r v z /\ x = Sum n (fun i => inner (a i) (v i) + inner (b i) (z i)).
(* v_x^T L v_x + v_y^T L v_y of a network, and the convex hull of these over the networks that occur arbitrarily near *)
Definition disagreement (g : graph) := Sum n (fun i => inner (v i) (Csum n (fun j => if g i j then v i - v j else 0)%C)).
Definition hull13 (y : R) := exists m (c : nat -> R) (g : nat -> graph), (forall k, (k < m)%nat -> 0 <= c k /\ occurs n R0 r (g k)) /\ Sum m c = 1 /\
  y = Sum m (fun k => c k * disagreement (g k)).
Definition pull_power (g : graph) := Sum n (fun i => inner (gradV n g V' r i) (v i)).
Lemma Sum_after a b f : Sum (a + b) f = Sum a f + Sum b (fun k => f (a + k)%nat).
Proof. induction b as [|b IH]; [rewrite Nat.add_0_r; cbn; ring|]. rewrite Nat.add_succ_r. cbn [Sum]. rewrite IH. ring. Qed.
Lemma hull13_between x y1 y2 : hull13 y1 -> hull13 y2 -> y1 <= x <= y2 -> hull13 x.
Proof.
  intros (m1 & c1 & g1 & H1 & S1 & E1) (m2 & c2 & g2 & H2 & S2 & E2) B.
  assert (L : exists l, 0 <= l <= 1 /\ x = l * y1 + (1 - l) * y2).
  { destruct (Req_dec y1 y2) as [E|N]; [exists 1; split; lra|]. exists ((y2 - x) / (y2 - y1)). assert (0 < y2 - y1) by lra. split; [split|field; lra].
    - apply Rmult_le_pos; [lra|left; now apply Rinv_0_lt_compat].
    - apply Rmult_le_reg_r with (y2 - y1); [assumption|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l; lra. }
  destruct L as (l & Hl & ->). exists (m1 + m2)%nat, (fun k => if Nat.ltb k m1 then l * c1 k else (1 - l) * c2 (k - m1)%nat), (fun k => if Nat.ltb k m1 then g1 k else g2 (k - m1)%nat).
  split; [|split].
  - intros k Hk. destruct (Nat.ltb_spec k m1) as [Q|Q]; [destruct (H1 k Q) as [Q1 Q2]; split; [apply Rmult_le_pos; lra|exact Q2]|].
    destruct (H2 (k - m1)%nat ltac:(lia)) as [Q1 Q2]. split; [apply Rmult_le_pos; lra|exact Q2].
  - rewrite Sum_after. rewrite (Sum_ext m1 _ (fun k => l * c1 k)); [|intros k Hk; destruct (Nat.ltb_spec k m1); [reflexivity|lia]].
    rewrite (Sum_ext m2 _ (fun k => (1 - l) * c2 k)); [|intros k Hk; destruct (Nat.ltb_spec (m1 + k) m1); [lia|]; now replace (m1 + k - m1)%nat with k by lia].
    rewrite !Sum_scal, S1, S2. ring.
  - rewrite Sum_after. rewrite (Sum_ext m1 _ (fun k => l * (c1 k * disagreement (g1 k)))); [|intros k Hk; destruct (Nat.ltb_spec k m1); [ring|lia]].
    rewrite (Sum_ext m2 _ (fun k => (1 - l) * (c2 k * disagreement (g2 k)))); [|intros k Hk; destruct (Nat.ltb_spec (m1 + k) m1); [lia|]; replace (m1 + k - m1)%nat with k by lia; ring].
    rewrite !Sum_scal, <- E1, <- E2. reflexivity.
Qed.
Lemma law_power g : Sum n (fun i => inner (v i) (law4 n g V' r v i)) = - disagreement g - pull_power g.
Proof.
  unfold disagreement, pull_power. rewrite <- Sum_opp, <- Sum_minus. apply Sum_ext. intros i _. unfold law4. rewrite (inner_sym (gradV n g V' r i)), !inner_xy. cbn. ring.
Qed.
Lemma law4_rest g q i : law4 n g V' q (fun _ => RtoC 0) i = (- gradV n g V' q i)%C.
Proof.
  unfold law4. replace (Csum n (fun j => if g i j then RtoC 0 - RtoC 0 else 0)%C) with (RtoC 0); [ring|].
  symmetry. apply injective_projections; cbn; apply Sum_zero; intros j _; destruct (g i j); cbn; ring.
Qed.
Lemma gradient_occurs g : occurs n R0 r g -> gradient_Q (gradV n g V' r) v.
Proof.
  intros O. exists 1%nat, (fun _ => 1), (fun _ => gradV n g V' r), (fun _ => v). split; [|split].
  - intros k _. split; [lra|]. intros e He.
    assert (NL : loopless n g) by (intros i Hi; destruct (O 1 Rlt_0_1) as (q & _ & _ & Sq); rewrite (Sq i i Hi Hi); apply by_distance_simple).
    destruct (law4_near n V V' r (fun _ => RtoC 0) P A g e NL He) as (d & Hd & K). destruct (O (Rmin d e) ltac:(now apply Rmin_glb_lt)) as (q & Q1 & Q2 & Q3).
    pose proof (Rmin_l d e). pose proof (Rmin_r d e). assert (Z : forall z : C, Cmod (z - z)%C = 0) by (intros z; replace (z - z)%C with (RtoC 0) by ring; apply Cmod_0).
    exists q, v. split; [intros i Hi; specialize (Q1 i Hi); rewrite Z; lra|]. split; [exact Q2|]. intros i Hi. split; [|rewrite Z; exact He].
    specialize (K q (fun _ => RtoC 0)). assert (K' : Cmod (law4 n g V' q (fun _ => RtoC 0) i - law4 n g V' r (fun _ => RtoC 0) i)%C < e).
    { apply K; [|exact Hi]. intros k0 Hk. specialize (Q1 k0 Hk). rewrite Z. lra. }
    rewrite !law4_rest in K'. replace (gradV n (by_distance q R0) V' q i) with (gradV n g V' q i).
    + rewrite <- Cmod_opp. replace (- (gradV n g V' q i - gradV n g V' r i))%C with (- gradV n g V' q i - - gradV n g V' r i)%C by ring. exact K'.
    + apply Csum_ext. intros j Hj. unfold pull. now rewrite (Q3 i j Hi Hj).
  - cbn. ring.
  - intros i _. split; apply injective_projections; cbn; ring.
Qed.
Lemma some_occurs : exists g, occurs n R0 r g.
Proof.
  assert (Ap : forall i j, (i < n)%nat -> (j < n)%nat -> i <> j -> r i <> r j).
  { intros i j Hi Hj Ne. apply A; try assumption. unfold complete. destruct (Nat.eqb_spec i j); [contradiction|reflexivity]. }
  exists (by_distance r R0). intros e He. destruct (spread_generic n r R0 HR Ap e He) as (q & Q1 & Q2 & Q3). exists q. split; [exact Q1|]. split; [exact Q2|exact Q3].
Qed.
(* among the networks that occur there is one with the least value of a function of the pairs *)
Lemma least (F : graph -> R) : (forall g h, same_pairs n g h -> F g = F h) -> exists g, occurs n R0 r g /\ forall h, occurs n R0 r h -> F g <= F h.
Proof.
  intros Ext. assert (OE : forall g h, same_pairs n g h -> occurs n R0 r g -> occurs n R0 r h).
  { intros g h E O e He. destruct (O e He) as (q & Q1 & Q2 & Q3). exists q. split; [exact Q1|]. split; [exact Q2|]. intros i j Hi Hj. rewrite <- (E i j Hi Hj). now apply Q3. }
  destruct (finite_graphs n (fun g e => - / e <= F g)) as (b & Hb & B).
  - intros g e e' H L. apply Rle_trans with (2 := H). apply Ropp_le_contravar, Rinv_le_contravar; lra.
  - intros g h e E H. now rewrite <- (Ext g h E).
  - intros g. pose proof (Rabs_pos (F g)). exists (/ (Rabs (F g) + 1)). split; [apply Rinv_0_lt_compat; lra|]. rewrite Rinv_inv. pose proof (Rle_abs (- F g)) as T. rewrite Rabs_Ropp in T. lra.
  - apply NNPP. intros N.
    destruct (finite_graphs n (fun g e => occurs n R0 r g -> exists h, occurs n R0 r h /\ F h <= F g - e)) as (e & He & Q).
    + intros g e e' H L O. destruct (H O) as (h & H1 & H2). exists h. split; [exact H1|lra].
    + intros g h e E H O. destruct (H (OE h g (fun i j Hi Hj => eq_sym (E i j Hi Hj)) O)) as (k & K1 & K2). exists k. split; [exact K1|]. now rewrite <- (Ext g h E).
    + intros g. destruct (classic (occurs n R0 r g)) as [O|No]; [|exists 1; split; [lra|]; intros; contradiction].
      assert (X : exists h, occurs n R0 r h /\ F h < F g).
      { apply NNPP. intros X. apply N. exists g. split; [exact O|]. intros h Oh. apply Rnot_lt_le. intros L. apply X. now exists h. }
      destruct X as (h & H1 & H2). exists (F g - F h). split; [lra|]. intros _. exists h. split; [exact H1|lra].
    + destruct some_occurs as [g0 O0]. assert (Down : forall k, exists g, occurs n R0 r g /\ F g <= F g0 - INR k * e).
      { induction k as [|k (g & G1 & G2)]; [exists g0; split; [exact O0|cbn; lra]|]. destruct (Q g G1) as (h & H1 & H2). exists h. split; [exact H1|]. rewrite S_INR. lra. }
      destruct (above ((F g0 + / b) / e)) as [k Hk]. destruct (Down k) as (g & _ & G2). specialize (B g). apply (Rmult_lt_compat_r e) in Hk; [|exact He].
      unfold Rdiv in Hk. rewrite Rmult_assoc, Rinv_l in Hk by lra. lra.
Qed.
Lemma choose (T : Type) (t0 : T) (Rel : nat -> T -> Prop) m : (forall k, (k < m)%nat -> exists t, Rel k t) -> exists f, forall k, (k < m)%nat -> Rel k (f k).
Proof.
  induction m as [|m IH]; intros H; [exists (fun _ => t0); intros; lia|]. destruct IH as [f Hf]; [intros; apply H; lia|]. destruct (H m ltac:(lia)) as [t Ht].
  exists (fun k => if Nat.eqb k m then t else f k). intros k Hk. destruct (Nat.eqb_spec k m) as [->|]; [exact Ht|apply Hf; lia].
Qed.
(* what a network's gradient of Q makes of a value of K *)
Lemma product13 g z : K10 n V' R0 r v z -> exists m (c : nat -> R) (h : nat -> graph), (forall k, (k < m)%nat -> 0 <= c k /\ occurs n R0 r (h k)) /\ Sum m c = 1 /\
  Sum n (fun i => inner (gradV n g V' r i) (v i) + inner (v i) (z i)) = Sum m (fun k => c k * (pull_power g - pull_power (h k) - disagreement (h k))).
Proof.
  intros (m & c & y & Y & S1 & E).
  destruct (choose graph (fun _ _ => false) (fun k h => occurs n R0 r h /\ forall i, (i < n)%nat -> y k i = law4 n h V' r v i) m) as (h & Hh).
  { intros k Hk. destruct (Y k Hk) as [_ L]. destruct (limit_is_law n V V' r v P A R0 (y k) L) as (q & O & Q). exists (by_distance q R0). now split. }
  exists m, c, h. split; [intros k Hk; split; [now apply Y|now apply Hh]|]. split; [exact S1|]. rewrite Sum_plus. fold (pull_power g).
  rewrite (Sum_ext n (fun i => inner (v i) (z i)) (fun i => Sum m (fun k => c k * inner (v i) (y k i)))); [|intros i Hi; rewrite (E i Hi), inner_Csum; apply Sum_ext; intros; apply inner_scal].
  rewrite Sum_swap. rewrite (Sum_ext m _ (fun k => c k * (- disagreement (h k) - pull_power (h k)))).
  - rewrite (Sum_ext m (fun k => c k * (pull_power g - _ - _)) (fun k => c k * pull_power g + c k * (- disagreement (h k) - pull_power (h k)))) by (intros; ring).
    rewrite Sum_plus, Sum_scal_r, S1. ring.
  - intros k Hk. rewrite Sum_scal, <- law_power. f_equal. apply Sum_ext. intros i Hi. now rewrite (proj2 (Hh k Hk) i Hi).
Qed.
Lemma disagreement_pairs g h : same_pairs n g h -> disagreement g = disagreement h.
Proof. intros E. apply Sum_ext. intros i Hi. f_equal. apply Csum_ext. intros j Hj. now rewrite (E i j Hi Hj). Qed.
Lemma power_pairs g h : same_pairs n g h -> pull_power g = pull_power h.
Proof. intros E. apply Sum_ext. intros i Hi. f_equal. apply Csum_ext. intros j Hj. unfold pull. now rewrite (E i j Hi Hj). Qed.
Theorem eq13 x : derivative_Q x -> hull13 (- x).
Proof.
  intros H. destruct (least pull_power power_pairs) as (g & Og & Lg).
  destruct (least (fun g => - pull_power g)) as (h & Oh & Lh); [intros a b E; now rewrite (power_pairs a b E)|].
  destruct (H _ _ (gradient_occurs g Og)) as (z & Kz & Ez). destruct (product13 g z Kz) as (m & c & k & Hk & S1 & Ek). rewrite Ek in Ez.
  destruct (H _ _ (gradient_occurs h Oh)) as (z' & Kz' & Ez'). destruct (product13 h z' Kz') as (m' & c' & k' & Hk' & S1' & Ek'). rewrite Ek' in Ez'.
  apply (hull13_between (- x) (Sum m (fun i => c i * disagreement (k i))) (Sum m' (fun i => c' i * disagreement (k' i)))).
  - exists m, c, k. now repeat split; try apply Hk.
  - exists m', c', k'. now repeat split; try apply Hk'.
  - split.
    + rewrite Ez, <- Sum_opp. apply Sum_le. intros i Hi. destruct (Hk i Hi) as [Ci Oi]. specialize (Lg _ Oi).
      replace (- (c i * (pull_power g - pull_power (k i) - disagreement (k i)))) with (c i * (pull_power (k i) - pull_power g + disagreement (k i))) by ring. apply Rmult_le_compat_l; lra.
    + rewrite Ez', <- Sum_opp. apply Sum_le. intros i Hi. destruct (Hk' i Hi) as [Ci Oi]. specialize (Lh _ Oi). cbv beta in Lh.
      replace (- (c' i * (pull_power h - pull_power (k' i) - disagreement (k' i)))) with (c' i * (pull_power (k' i) - pull_power h + disagreement (k' i))) by ring. apply Rmult_le_compat_l; lra.
Qed.
Lemma disagreement_ge0 g : undirected g -> 0 <= disagreement g.
Proof.
  intros S. set (f := fun i j => (if g i j then v i - v j else 0)%C).
  assert (E : disagreement g = / 2 * Sum n (fun i => Sum n (fun j => inner (f i j) (v i - v j)%C))).
  { symmetry. apply (pair_sum_swap n f (fun i _ => v i) 0). intros i j _ _. unfold f. rewrite (S j i). destruct (g i j); ring. }
  rewrite E. apply Rmult_le_pos; [lra|]. apply Sum_ge0. intros i _. apply Sum_ge0. intros j _. unfold f. destruct (g i j); [apply inner_self_ge0|rewrite inner_xy; cbn; lra].
Qed.
Theorem eq13_negative x : derivative_Q x -> x <= 0.
Proof.
  intros H. destruct (eq13 x H) as (m & c & g & Hg & _ & E). assert (0 <= - x); [|lra]. rewrite E. apply Sum_ge0. intros k Hk. destruct (Hg k Hk) as [Ck O]. apply Rmult_le_pos; [exact Ck|].
  destruct (O 1 Rlt_0_1) as (q & _ & _ & Sq). rewrite (disagreement_pairs (g k) (by_distance q R0) Sq). apply disagreement_ge0. apply by_distance_simple.
Qed.
End Derivative13.
(* Q falls along every solution of (10), as long as it lasts *)
Theorem Q_falls n V V' R0 (r v : nat -> R -> C) T : 0 < R0 -> tanner2_filippov.potentials n complete V V' -> tanner2_filippov.motion10_until T n V' R0 r v ->
  forall a b, 0 <= a <= b -> b < T -> Qs n V R0 (fun i => r i b) (fun i => v i b) <= Qs n V R0 (fun i => r i a) (fun i => v i a).
Proof.
  intros HR P M a b Hab Hb. set (c := (b + T) / 2). destruct (tanner2_filippov.straightened n V' R0 r v T c M ltac:(unfold c; lra)) as (q & p & Eq & W).
  assert (Hc : b < c < T) by (unfold c; lra).
  destruct (tanner2_filippov.start_allows n V V' R0 (fun i => q i 0) (fun i => p i 0) HR P (proj1 W)) as (d & Al).
  assert (Far : forall t i j, 0 <= t <= b -> (i < n)%nat -> (j < n)%nat -> i <> j -> d < Cmod (q i t - q j t)%C).
  { intros t i j Ht. apply (tanner2_filippov.kept_apart_while n V V' R0 q p HR P _ W d Al t ltac:(lra)). intros; lra. }
  assert (E : forall t, 0 <= t <= b -> Qs n V R0 (fun i => r i t) (fun i => v i t) = tanner2_filippov.power n V R0 q p d t).
  { intros t Ht. unfold Qs, tanner2_filippov.power. f_equal. apply Sum_ext. intros i Hi. rewrite (proj2 (Eq i t ltac:(lra))), inner_xy. f_equal; [|ring]. apply Sum_ext. intros j Hj.
    unfold tanner2_facts.sat_pair, tanner2_filippov.store. destruct (Nat.eqb_spec i j) as [|Ne]; [reflexivity|]. rewrite tanner_nonsmooth.saturated_min.
    specialize (Far t i j Ht Hi Hj Ne). rewrite (proj1 (Eq i t ltac:(lra))), (proj1 (Eq j t ltac:(lra))) in *.
    unfold tanner2_filippov.clamp. rewrite (Rmax_left (Cmod (r i t - r j t)%C) d); [reflexivity|lra]. }
  rewrite !E by lra. replace (tanner2_filippov.power n V R0 q p d a) with (tanner2_filippov.power n V R0 q p d a - 0 * (b - a)) by ring.
  apply (tanner2_filippov.power_falls n V V' R0 q p P _ W d (proj1 Al) a b 0 Hab); [intros; lra|intros t i j Ht; apply Far; lra|].
  intros t _. pose proof (tanner2_filippov.near_total_ge0 n R0 q p t). lra.
Qed.
