(* Tanner, Jadbabaie, Pappas, Part II, fixed graph: for every graph and every pair that is not linked there is a start, the two apart, from which they collide.
   A motion through a state in which the two are in one place with different velocities, followed backwards.
     tanner2.noninter. *)
From Coq Require Import Reals Lra Lia Psatz Classical.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums inclusions paley_model paley_phase paley_laplacian paley_gradient paley_particles tanner_energy tanner_flock tanner2_motion tanner_trees tanner2_lasting.
From Flockproof Require tanner2_filippov.
Open Scope R_scope.

(* all agents in a row, but j where i is; only i moves *)
Definition crossing_place (i j k : nat) : C := RtoC (INR (if Nat.eqb k j then i else k)).
Definition crossing_speed (i k : nat) : C := if Nat.eqb k i then Ci else RtoC 0.
Lemma INR_apart a b : a <> b -> 1 <= Rabs (INR a - INR b).
Proof.
  intros N. destruct (Nat.lt_total a b) as [L|[L|L]]; [|contradiction|]; apply (le_INR (S _)) in L; rewrite S_INR in L; [rewrite Rabs_left by lra; lra|rewrite Rabs_pos_eq by lra; lra].
Qed.
Lemma INR_within n a b : (a < n)%nat -> (b < n)%nat -> Rabs (INR a - INR b) <= INR n.
Proof. intros Ha Hb. apply lt_INR in Ha, Hb. pose proof (pos_INR a). pose proof (pos_INR b). apply Rabs_le. lra. Qed.
Section Collision.
Variables (n : nat) (adj : graph) (V V' : nat -> nat -> R -> R) (i j : nat).
Hypothesis S : undirected adj.
Hypothesis NL : no_loops adj.
Hypothesis VS : forall a b, V a b = V b a.
Hypothesis VS' : forall a b, V' a b = V' b a.
Hypothesis Pot : forall a b, (a < n)%nat -> (b < n)%nat -> adj a b = true -> potential (V a b) (V' a b).
Hypothesis C1 : forall a b s, (a < n)%nat -> (b < n)%nat -> adj a b = true -> 0 < s -> continuity_pt (V' a b) s.
Hypothesis Hi : (i < n)%nat.
Hypothesis Hj : (j < n)%nat.
Hypothesis Ne : i <> j.
Hypothesis Un : adj i j = false.
Notation D := (INR n + 1).
Notation f := (field n adj V' (1 / 2) D 2).
Lemma linked_row a b : (a < n)%nat -> (b < n)%nat -> adj a b = true -> 1 <= norm (crossing_place i j a - crossing_place i j b)%C <= INR n.
Proof.
  intros Ha Hb L. unfold crossing_place. rewrite <- RtoC_minus. unfold norm. rewrite Cmod_R.
  assert (N : (if Nat.eqb a j then i else a) <> (if Nat.eqb b j then i else b)).
  { destruct (Nat.eqb_spec a j) as [->|Na], (Nat.eqb_spec b j) as [->|Nb]; intros E; subst; try (rewrite NL in L; discriminate); try (rewrite S, Un in L; discriminate); rewrite ?Un in L; try discriminate. }
  split; [now apply INR_apart|]. apply INR_within; [destruct (Nat.eqb a j)|destruct (Nat.eqb b j)]; assumption.
Qed.
Theorem unlinked_collide : exists r v : nat -> R -> C, distinct n adj (fun k => r k 0) /\ (forall t, 0 <= t -> moves n adj V' r v t) /\ r i 0 <> r j 0 /\ exists T, 0 < T /\ r i T = r j T.
Proof.
  pose proof (pos_INR n) as Pn. destruct (field_bounded n adj V' (1 / 2) D 2) as [M HM]; [lra|lra|exact C1|].
  set (y0 := joined n (fun k _ => crossing_place i j k) (fun k _ => crossing_speed i k) 0).
  destruct (peano (4 * n) (fun y k => - f y k) M y0) as (y & Y0 & Y1).
  { intros x k Hk. rewrite Rabs_Ropp. now apply HM. }
  { intros x e He. destruct (field_continuous n adj V' (1 / 2) D 2 ltac:(lra) C1 x e He) as (d & Hd & K). exists d. split; [exact Hd|]. intros z Nz k Hk.
    replace (- f z k - - f x k) with (- (f z k - f x k)) by ring. rewrite Rabs_Ropp. now apply K. }
  assert (P0 : forall k, (k < n)%nat -> place n (y 0) k = crossing_place i j k /\ speed n (y 0) k = crossing_speed i k).
  { intros k Hk. destruct (joined_parts n (fun k _ => crossing_place i j k) (fun k _ => crossing_speed i k) 0 k Hk) as [J1 J2]. rewrite <- J1, <- J2. fold y0. unfold place, speed. now rewrite !Y0 by lia. }
  (* for a while the state stays within the bounds, and backwards the two part *)
  set (p := fun k s => place n (y s) k). set (q := fun k s => speed n (y s) k).
  assert (Vp : forall s k, 0 <= s -> (k < n)%nat -> is_velocity (p k) s (- f (y s) k, - f (y s) (n + k)%nat)) by (intros s k Hs Hk; split; cbn [fst snd p place]; apply Y1; try assumption; lia).
  assert (Vq : forall s k, 0 <= s -> (k < n)%nat -> is_velocity (q k) s (- f (y s) (2 * n + k)%nat, - f (y s) (3 * n + k)%nat)) by (intros s k Hs Hk; split; cbn [fst snd q speed]; apply Y1; try assumption; lia).
  destruct (tanner2_filippov.small n (fun k h => forall s, Rabs (s - 0) < h -> norm (p k s - p k 0)%C < 1 / 8 /\ norm (q k s - q k 0)%C < 1 / 2)) as (h & Hh & Near).
  { intros k h h' Q L s Hs. apply Q. lra. }
  { intros k Hk. destruct (velocity_near (p k) 0 _ (1 / 8) (Vp 0 k (Rle_refl 0) Hk) ltac:(lra)) as (h1 & H1 & Q1). destruct (velocity_near (q k) 0 _ (1 / 2) (Vq 0 k (Rle_refl 0) Hk) ltac:(lra)) as (h2 & H2 & Q2).
    exists (Rmin h1 h2). split; [now apply Rmin_glb_lt|]. intros s Hs. pose proof (Rmin_l h1 h2). pose proof (Rmin_r h1 h2). split; [apply Q1|apply Q2]; lra. }
  assert (In : forall s, 0 <= s < h -> (forall k, (k < n)%nat -> norm (speed n (y s) k) <= 2) /\ forall a b, (a < n)%nat -> (b < n)%nat -> adj a b = true -> 1 / 2 <= norm (place n (y s) a - place n (y s) b)%C <= D).
  { intros s Hs. assert (Hs' : Rabs (s - 0) < h) by (rewrite Rminus_0_r, Rabs_pos_eq; lra). split.
    - intros k Hk. destruct (Near k Hk s Hs') as [_ Q]. unfold q in Q. rewrite (proj2 (P0 k Hk)) in Q. replace (speed n (y s) k) with ((speed n (y s) k - crossing_speed i k) + crossing_speed i k)%C by ring.
      eapply Rle_trans; [apply norm_triangle|]. assert (norm (crossing_speed i k) <= 1); [|lra]. unfold crossing_speed. destruct (Nat.eqb k i); unfold norm; [|rewrite Cmod_0; lra].
      unfold Cmod, Ci; cbn. replace (0 * (0 * 1) + 1 * (1 * 1)) with 1 by ring. rewrite sqrt_1. lra.
    - intros a b Ha Hb L. pose proof (linked_row a b Ha Hb L) as B. destruct (Near a Ha s Hs') as [Qa _]. destruct (Near b Hb s Hs') as [Qb _]. unfold p in Qa, Qb. rewrite (proj1 (P0 a Ha)) in Qa. rewrite (proj1 (P0 b Hb)) in Qb.
      pose proof (norm_near (place n (y s) a - place n (y s) b)%C (crossing_place i j a - crossing_place i j b)%C) as T. apply Rabs_le_between in T.
      replace (place n (y s) a - place n (y s) b - (crossing_place i j a - crossing_place i j b))%C with ((place n (y s) a - crossing_place i j a) + - (place n (y s) b - crossing_place i j b))%C in T by ring.
      pose proof (norm_triangle (place n (y s) a - crossing_place i j a)%C (- (place n (y s) b - crossing_place i j b))%C) as T2. rewrite norm_opp in T2. lra. }
  assert (Law : forall s k, 0 <= s < h -> (k < n)%nat -> (f (y s) k, f (y s) (n + k)%nat) = q k s /\ (f (y s) (2 * n + k)%nat, f (y s) (3 * n + k)%nat) = control4 n adj V' (place n (y s)) (speed n (y s)) k).
  { intros s k Hs Hk. destruct (In s Hs) as [I1 I2]. exact (field_law n adj V' (1 / 2) D 2 (y s) I1 I2 k Hk). }
  (* the second coordinate of r_i - r_j falls backwards at the rate 1 *)
  assert (Part : exists T, 0 < T < h /\ p i T <> p j T).
  { destruct (Law 0 i ltac:(lra) Hi) as [L1 _]. destruct (Law 0 j ltac:(lra) Hj) as [L2 _]. unfold q in L1, L2. rewrite (proj2 (P0 i Hi)) in L1. rewrite (proj2 (P0 j Hj)) in L2. unfold crossing_speed in L1, L2.
    rewrite Nat.eqb_refl in L1. destruct (Nat.eqb_spec j i) as [E|_]; [congruence|]. injection L1 as _ L1. injection L2 as _ L2.
    pose proof (proj2 (Vp 0 i (Rle_refl 0) Hi)) as Di. pose proof (proj2 (Vp 0 j (Rle_refl 0) Hj)) as Dj. cbn [snd] in Di, Dj. rewrite L1 in Di. rewrite L2 in Dj.
    pose proof (D_minus _ _ _ _ _ Di Dj) as Dd. apply is_derive_Reals in Dd. destruct (Dd (1 / 2) ltac:(lra)) as [d Hd]. pose proof (cond_pos d). set (T := Rmin (d / 2) (h / 2)).
    assert (HT : 0 < T) by (apply Rmin_glb_lt; lra). pose proof (Rmin_l (d / 2) (h / 2)). pose proof (Rmin_r (d / 2) (h / 2)). fold T in H0, H1. exists T. split; [lra|]. intros E.
    specialize (Hd T ltac:(lra) ltac:(rewrite Rabs_pos_eq; lra)). rewrite Rplus_0_l in Hd. rewrite E in Hd. rewrite (proj1 (P0 i Hi) : p i 0 = _), (proj1 (P0 j Hj) : p j 0 = _) in Hd.
    unfold crossing_place in Hd. cbn [snd RtoC] in Hd. match type of Hd with Rabs ?X < _ => replace X with 1 in Hd by (cbn; field; lra) end. rewrite Rabs_R1 in Hd. lra. }
  destruct Part as (T & HT & Ap).
  set (r := fun k t => p k (T - t)). set (v := fun k t => q k (T - t)).
  assert (Back : forall (x : R -> C) s a, is_velocity x (T - s) a -> is_velocity (fun t => x (T - t)) s (- a)%C).
  { intros x s a [A B]. split.
    - eapply D_eq; [apply (D_comp (fun u => fst (x u)) (fun t => T - t)); [exact A|apply D_minus; [apply D_const|apply D_id]]|]. cbn. ring.
    - eapply D_eq; [apply (D_comp (fun u => snd (x u)) (fun t => T - t)); [exact B|apply D_minus; [apply D_const|apply D_id]]|]. cbn. ring. }
  assert (Ng : forall a b : R, (- ((- a)%R, (- b)%R))%C = (a, b)) by (intros; apply injective_projections; cbn; ring).
  assert (Mv : forall t, 0 <= t < T -> moves n adj V' r v t).
  { intros t Ht. split.
    - intros k Hk. pose proof (Back (p k) t _ (Vp (T - t) k ltac:(lra) Hk)) as B. destruct (Law (T - t) k ltac:(lra) Hk) as [L _]. rewrite Ng, L in B. exact B.
    - intros _ k Hk. pose proof (Back (q k) t _ (Vq (T - t) k ltac:(lra) Hk)) as B. destruct (Law (T - t) k ltac:(lra) Hk) as [_ L]. rewrite Ng, L in B. exact B. }
  assert (A0 : distinct n adj (fun k => r k 0)).
  { intros a b Ha Hb L E. destruct (In T ltac:(lra)) as [_ I2]. specialize (I2 a b Ha Hb L). unfold r, p in E. rewrite Rminus_0_r in E. rewrite E in I2. replace (place n (y T) b - place n (y T) b)%C with (RtoC 0) in I2 by ring.
    unfold norm in I2. rewrite Cmod_0 in I2. lra. }
  destruct (goes_on n adj V V' S NL VS VS' Pot C1 T r v ltac:(lra) A0 Mv) as (r' & v' & Eq & Mv'). exists r', v'.
  assert (E0 : forall k, (k < n)%nat -> r' k 0 = p k T) by (intros k Hk; rewrite (proj1 (Eq 0 k ltac:(lra) Hk)); unfold r; now rewrite Rminus_0_r).
  split; [intros a b Ha Hb L E; rewrite (E0 a Ha), (E0 b Hb) in E; apply (A0 a b Ha Hb L); unfold r; now rewrite Rminus_0_r|]. split; [exact Mv'|]. split; [now rewrite (E0 i Hi), (E0 j Hj)|].
  exists T. split; [lra|].
  (* at T, by continuity *)
  assert (Lim : forall k, (k < n)%nat -> r' k T = crossing_place i j k).
  { intros k Hk. assert (Z : norm (r' k T - crossing_place i j k)%C <= 0).
    { apply le_epsilon. intros e He. destruct (velocity_near (r' k) T _ (e / 2) (proj1 (Mv' T ltac:(lra)) k Hk) ltac:(lra)) as (h1 & H1 & Q1). destruct (velocity_near (p k) 0 _ (e / 2) (Vp 0 k (Rle_refl 0) Hk) ltac:(lra)) as (h2 & H2 & Q2).
      set (d := Rmin (Rmin h1 h2) T / 2). assert (Hd : 0 < d) by (unfold d; assert (0 < Rmin (Rmin h1 h2) T) by (repeat apply Rmin_glb_lt; lra); lra).
      assert (d < h1 /\ d < h2 /\ d < T) as (D1 & D2 & D3). { pose proof (Rmin_l (Rmin h1 h2) T). pose proof (Rmin_r (Rmin h1 h2) T). pose proof (Rmin_l h1 h2). pose proof (Rmin_r h1 h2). unfold d in *. lra. }
      pose proof (Q1 (T - d) ltac:(apply Rabs_def1; lra)) as N1. pose proof (Q2 d ltac:(rewrite Rminus_0_r, Rabs_pos_eq; lra)) as N2. rewrite (proj1 (Eq (T - d) k ltac:(lra) Hk)) in N1. unfold r in N1. replace (T - (T - d)) with d in N1 by ring.
      rewrite (proj1 (P0 k Hk) : p k 0 = _) in N2. replace (r' k T - crossing_place i j k)%C with (- (p k d - r' k T) + (p k d - crossing_place i j k))%C by ring. eapply Rle_trans; [apply norm_triangle|]. rewrite norm_opp. lra. }
    pose proof (norm_ge0 (r' k T - crossing_place i j k)%C) as Z0. assert (Z1 : (r' k T - crossing_place i j k)%C = RtoC 0) by (apply norm_0; lra).
    replace (r' k T) with ((r' k T - crossing_place i j k) + crossing_place i j k)%C by ring. rewrite Z1. ring. }
  rewrite (Lim i Hi), (Lim j Hj). unfold crossing_place. rewrite Nat.eqb_refl. destruct (Nat.eqb_spec i j) as [E|_]; [contradiction|reflexivity].
Qed.
End Collision.
