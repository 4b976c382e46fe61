(* Tanner, Jadbabaie, Pappas, graph theory of both papers: L = D D^T and L_w = D W D^T for every orientation, their
   kernels, the range of the incidence matrix, the sign in front of (B x I_2) and eq (14).  An orientation is a list of
   arcs (i, j) from i to j with exactly one of (i, j), (j, i) for each edge; column (i, j) has 1 in row j, -1 in row i. *)
From Coq Require Import Reals Lra Lia Psatz Relations List.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums paley_model paley_phase paley_laplacian paley_gradient paley_particles tanner_energy tanner_flock.
From Flockproof Require tanner_trees.
Open Scope R_scope.

Definition oriented (n : nat) (adj : graph) (O : list (nat * nat)) : Prop := NoDup O /\
  (forall i j, In (i, j) O -> (i < n)%nat /\ (j < n)%nat) /\
  (forall i j, (i < n)%nat -> (j < n)%nat -> member O (i, j) + member O (j, i) = w adj i j).
Definition lapw (n : nat) (a : nat -> nat -> R) (k m : nat) : R := delta k m * Sum n (a k) - a k m.

(* a sum over the arcs of an orientation is half the sum over both directions *)
Lemma lsum_oriented n adj O (h : nat * nat -> R) : oriented n adj O -> (forall i j, h (i, j) = h (j, i)) ->
  lsum O h = / 2 * Sum n (fun k => Sum n (fun j => w adj k j * h (j, k))).
Proof.
  intros [ND [B M]] Hs. rewrite (lsum_double n) by assumption.
  set (X := Sum n (fun k => Sum n (fun j => member O (j, k) * h (j, k)))).
  assert (E : Sum n (fun k => Sum n (fun j => w adj k j * h (j, k))) = X + X).
  { assert (E2 : X = Sum n (fun k => Sum n (fun j => member O (k, j) * h (k, j)))) by (unfold X; rewrite Sum_swap; reflexivity).
    rewrite E2 at 2. unfold X. rewrite <- Sum_plus. apply Sum_ext; intros k Hk. rewrite <- Sum_plus. apply Sum_ext; intros j Hj.
    rewrite <- (M k j Hk Hj), (Hs k j). ring. }
  rewrite E. field.
Qed.
Lemma inc_double n (a : nat -> nat -> R) k m : (forall i j, a i j = a j i) -> (k < n)%nat -> (m < n)%nat ->
  Sum n (fun b => Sum n (fun c => a b c * (inc k (c, b) * inc m (c, b)))) = 2 * lapw n a k m.
Proof.
  intros S Hk Hm. unfold inc; cbn [fst snd].
  transitivity (Sum n (fun b => delta k b * (delta m b * Sum n (a b))) - Sum n (fun b => delta k b * a b m)
    - Sum n (fun b => delta m b * a b k) + Sum n (fun c => delta k c * (delta m c * Sum n (a c)))).
  - rewrite (Sum_ext n (fun b => delta k b * a b m) (fun b => Sum n (fun c => delta m c * (delta k b * a b c))))
      by (intros b _; now rewrite (Sum_delta_l n m (fun c => delta k b * a b c) Hm)).
    rewrite (Sum_ext n (fun b => delta m b * a b k) (fun b => Sum n (fun c => delta k c * (delta m b * a b c))))
      by (intros b _; now rewrite (Sum_delta_l n k (fun c => delta m b * a b c) Hk)).
    assert (T : Sum n (fun c => delta k c * (delta m c * Sum n (a c))) = Sum n (fun b => Sum n (fun c => delta k c * delta m c * a b c))).
    { rewrite Sum_swap. apply Sum_ext; intros c _. rewrite Sum_scal, Rmult_assoc. do 2 f_equal. apply Sum_ext; intros. apply S. }
    rewrite T at 2. rewrite <- !Sum_minus, <- Sum_plus. apply Sum_ext; intros b _.
    rewrite <- !Rmult_assoc, <- Sum_scal, <- !Sum_minus, <- Sum_plus. apply Sum_ext; intros c _. ring.
  - rewrite (Sum_delta_l n k (fun b => delta m b * Sum n (a b)) Hk), (Sum_delta_l n k (fun b => a b m) Hk), (Sum_delta_l n m (fun b => a b k) Hm).
    unfold lapw. rewrite (delta_sym m k), (S m k). ring.
Qed.
Theorem Lw_incidence n adj O (W : nat -> nat -> R) k m : undirected adj -> oriented n adj O -> (forall i j, W i j = W j i) ->
  (k < n)%nat -> (m < n)%nat ->
  lsum O (fun f => inc k f * W (fst f) (snd f) * inc m f) = lapw n (fun i j => w adj i j * W i j) k m.
Proof.
  intros S HO WS Hk Hm. rewrite (lsum_oriented n adj) by (try assumption; intros i j; cbn [fst snd]; rewrite (WS i j); unfold inc; cbn [fst snd]; ring).
  cbn [fst snd].
  rewrite (Sum_ext n _ (fun b => Sum n (fun c => (w adj b c * W b c) * (inc k (c, b) * inc m (c, b))))).
  - rewrite (inc_double n (fun i j => w adj i j * W i j)) by (try assumption; intros i j; unfold w; rewrite (S i j), (WS i j); reflexivity). field.
  - intros b _. apply Sum_ext; intros c _. rewrite (WS c b). ring.
Qed.
(* L = D D^T, for every orientation *)
Theorem L_incidence n adj O k m : undirected adj -> oriented n adj O -> (k < n)%nat -> (m < n)%nat ->
  lsum O (fun f => inc k f * inc m f) = lap n adj k m.
Proof.
  intros S HO Hk Hm. pose proof (Lw_incidence n adj O (fun _ _ => 1) k m S HO (fun _ _ => eq_refl) Hk Hm) as E. cbv beta in E.
  assert (A : lsum O (fun f => inc k f * inc m f) = lsum O (fun f => inc k f * 1 * inc m f)).
  { clear. unfold lsum. induction O as [|f O IH]; cbn; [reflexivity|]. rewrite IH. ring. }
  rewrite A, E. unfold lapw, lap, deg. rewrite Rmult_1_r. f_equal. f_equal. apply Sum_ext; intros; ring.
Qed.
Corollary L_orientation n adj O O' k m : undirected adj -> oriented n adj O -> oriented n adj O' -> (k < n)%nat -> (m < n)%nat ->
  lsum O (fun f => inc k f * inc m f) = lsum O' (fun f => inc k f * inc m f).
Proof. intros. rewrite !(L_incidence n adj) by assumption. reflexivity. Qed.

(* the weighted form, and the kernel: constant on every connected component *)
Lemma lapw_mul n a k (x : nat -> R) : (k < n)%nat -> Sum n (fun j => lapw n a k j * x j) = Sum n (fun j => a k j * (x k - x j)).
Proof.
  intros Hk. unfold lapw. transitivity (Sum n (fun j => delta k j * (Sum n (a k) * x j)) - Sum n (fun j => a k j * x j)).
  - rewrite <- Sum_minus. apply Sum_ext; intros; ring.
  - rewrite (Sum_delta_l n k (fun j => Sum n (a k) * x j) Hk), <- Sum_scal_r, <- Sum_minus. apply Sum_ext; intros; ring.
Qed.
Theorem Lw_form n a x : (forall i j, a i j = a j i) ->
  Sum n (fun k => x k * Sum n (fun j => lapw n a k j * x j)) = / 2 * Sum n (fun k => Sum n (fun j => a k j * (x k - x j) ^ 2)).
Proof.
  intros S. rewrite (Sum_ext n _ (fun k => x k * Sum n (fun j => a k j * (x k - x j)))) by (intros k Hk; now rewrite lapw_mul).
  pose proof (half_swap n (fun k j => a k j * (x k - x j)) x) as H. cbv beta in H.
  rewrite (Sum_ext n (fun k => Sum n (fun j => a k j * (x k - x j) ^ 2)) (fun k => Sum n (fun j => a k j * (x k - x j) * (x k - x j))))
    by (intros; apply Sum_ext; intros; ring).
  rewrite H; [field|]. intros i j _ _. rewrite (S j i). ring.
Qed.
Theorem Lw_kernel n adj (W : nat -> nat -> R) x : undirected adj -> (forall i j, W i j = W j i) -> (forall i j, 0 < W i j) ->
  let a := fun i j => w adj i j * W i j in
  (forall k m, lapw n a k m = lapw n a m k) /\ 0 <= Sum n (fun k => x k * Sum n (fun j => lapw n a k j * x j)) /\
  ((forall k, (k < n)%nat -> Sum n (fun j => lapw n a k j * x j) = 0) <->
   forall j k, clos_refl_trans nat (arc n adj) j k -> x j = x k).
Proof.
  intros S WS WP a. assert (Sa : forall i j, a i j = a j i) by (intros; unfold a, w; rewrite (S i j), (WS i j); reflexivity).
  assert (P : forall k j, 0 <= a k j * (x k - x j) ^ 2).
  { intros k j. apply Rmult_le_pos; [|apply pow2_ge_0]. unfold a. apply Rmult_le_pos; [apply w_ge0|left; apply WP]. }
  split; [|split; [|split]].
  - intros k m. unfold lapw. destruct (Nat.eq_dec k m) as [->|N]; [reflexivity|]. rewrite (delta_neq k m N), (delta_neq m k) by congruence. rewrite (Sa k m). ring.
  - rewrite Lw_form by exact Sa. apply Rmult_le_pos; [lra|]. apply Sum_ge0; intros; apply Sum_ge0; intros; apply P.
  - intros Z. assert (E : Sum n (fun k => Sum n (fun j => a k j * (x k - x j) ^ 2)) = 0).
    { pose proof (Lw_form n a x Sa) as F. rewrite Sum_zero in F; [lra|]. intros k Hk. rewrite Z by assumption. ring. }
    intros j k Pth. induction Pth as [j k A|j|j i k _ H1 _ H2]; [|reflexivity|congruence]. destruct A as [Hj [Hk A]].
    assert (T : a k j * (x k - x j) ^ 2 = 0).
    { apply (Sum_eq0 n (fun j => a k j * (x k - x j) ^ 2)); try assumption; [intros; apply P|].
      apply (Sum_eq0 n (fun k => Sum n (fun j => a k j * (x k - x j) ^ 2))); try assumption. intros; apply Sum_ge0; intros; apply P. }
    unfold a, w in T. rewrite A in T. pose proof (WP k j). assert ((x k - x j) ^ 2 = 0) by nra. nra.
  - intros H k Hk. rewrite lapw_mul by assumption. apply Sum_zero; intros j Hj. unfold a, w. destruct (adj k j) eqn:A; [|ring].
    rewrite (H j k); [ring|]. apply rt_step. now repeat split.
Qed.
(* "the eigenvector of zero is 1": without connectedness there are others *)
Theorem L_ones_fails : ~ forall n adj x, (1 <= n)%nat -> undirected adj -> no_loops adj ->
  (forall k, (k < n)%nat -> lmul n adj x k = 0) -> exists c, forall k, (k < n)%nat -> x k = c.
Proof.
  intros H. destruct (H 2%nat (fun _ _ => false) (fun k => INR k)) as [c Hc]; try lia; try (intros ? ?; reflexivity); try (intros ?; reflexivity).
  - intros k Hk. unfold lmul, lap, deg, w. cbn. ring.
  - pose proof (Hc 0%nat ltac:(lia)). pose proof (Hc 1%nat ltac:(lia)). cbn in *. lra.
Qed.

(* ---- the range of the incidence matrix of a connected graph is the orthogonal complement of 1 ---- *)
Definition applyB (O : list (nat * nat)) (y : nat * nat -> R) (k : nat) : R := lsum O (fun f => inc k f * y f).
Lemma lsum_plus O f g : lsum O (fun e => f e + g e) = lsum O f + lsum O g.
Proof. unfold lsum. induction O; cbn; [ring|]. rewrite IHO. ring. Qed.
Lemma lsum_scal O c f : lsum O (fun e => c * f e) = c * lsum O f.
Proof. unfold lsum. induction O; cbn; [ring|]. rewrite IHO. ring. Qed.
Lemma lsum_ext O f g : (forall e, f e = g e) -> lsum O f = lsum O g.
Proof. intros H. unfold lsum. induction O; cbn; [ring|]. now rewrite IHO, H. Qed.
Lemma applyB_plus O y z k : applyB O (fun e => y e + z e) k = applyB O y k + applyB O z k.
Proof. unfold applyB. rewrite <- lsum_plus. apply lsum_ext; intros; ring. Qed.
Lemma applyB_scal O c y k : applyB O (fun e => c * y e) k = c * applyB O y k.
Proof. unfold applyB. rewrite <- lsum_scal. apply lsum_ext; intros; ring. Qed.
Lemma applyB_single O e k : NoDup O -> In e O -> applyB O (fun f => if pair_dec f e then 1 else 0) k = inc k e.
Proof.
  intros ND I. unfold applyB, lsum. induction O as [|a O IH]; [contradiction|]. inversion ND as [|? ? NI ND']; subst. cbn.
  destruct (pair_dec a e) as [->|N].
  - assert (Z : fold_right (fun f s => inc k f * (if pair_dec f e then 1 else 0) + s) 0 O = 0); [|rewrite Z; ring].
    clear - NI. induction O as [|b O IH]; cbn; [reflexivity|]. destruct (pair_dec b e) as [->|]; [exfalso; apply NI; now left|].
    rewrite IH; [ring|]. intros H. apply NI. now right.
  - destruct I as [->|I]; [contradiction|]. rewrite (IH ND' I). ring.
Qed.
Lemma arc_listed n adj O i j : no_loops adj -> oriented n adj O -> arc n adj i j -> In (i, j) O \/ In (j, i) O.
Proof.
  intros NL [_ [_ M]] [Hi [Hj A]]. specialize (M j i Hj Hi). unfold member, w in M. rewrite A in M.
  destruct (in_dec pair_dec (i, j) O) as [I|I]; [now left|]. destruct (in_dec pair_dec (j, i) O) as [I'|I']; [now right|]. lra.
Qed.
Lemma path_flow n adj O a b : no_loops adj -> oriented n adj O -> clos_refl_trans nat (arc n adj) a b ->
  exists y, forall k, applyB O y k = delta k b - delta k a.
Proof.
  intros NL HO P. induction P as [a b A|a|a c b _ [y Hy] _ [z Hz]].
  - destruct (arc_listed n adj O a b NL HO A) as [I|I].
    + exists (fun f => if pair_dec f (a, b) then 1 else 0). intros k. now rewrite (applyB_single O (a, b) k (proj1 HO) I).
    + exists (fun f => -1 * (if pair_dec f (b, a) then 1 else 0)). intros k. rewrite applyB_scal, (applyB_single O (b, a) k (proj1 HO) I). unfold inc; cbn. ring.
  - exists (fun _ => 0). intros k. unfold applyB. rewrite (lsum_ext O _ (fun e => 0 * inc k e)) by (intros; ring). rewrite lsum_scal. ring.
  - exists (fun e => y e + z e). intros k. rewrite applyB_plus, Hy, Hz. ring.
Qed.
Theorem range_B n adj O x : (1 <= n)%nat -> undirected adj -> no_loops adj -> oriented n adj O -> strongly_connected n adj ->
  ((exists y, forall k, (k < n)%nat -> applyB O y k = x k) <-> Sum n x = 0).
Proof.
  intros Hn S NL HO SC. split.
  - intros [y Hy]. rewrite <- (Sum_ext n _ _ Hy). destruct HO as [_ [B _]]. unfold applyB.
    assert (G : forall l, (forall i j, In (i, j) l -> (i < n)%nat /\ (j < n)%nat) -> Sum n (fun k => lsum l (fun f => inc k f * y f)) = 0).
    { induction l as [|[i j] l IH]; intros Bl; [apply Sum_0|].
      change (Sum n (fun k => inc k (i, j) * y (i, j) + lsum l (fun f => inc k f * y f)) = 0). rewrite Sum_plus, IH by (intros; apply Bl; now right).
      destruct (Bl i j ltac:(now left)) as [Hi Hj]. unfold inc; cbn [fst snd].
      rewrite (Sum_ext n _ (fun k => delta k j * y (i, j) - delta k i * y (i, j))) by (intros; ring).
      rewrite Sum_minus, (Sum_delta n j (fun _ => y (i, j)) Hj), (Sum_delta n i (fun _ => y (i, j)) Hi). ring. }
    now apply G.
  - intros Z. assert (F : forall m, (m <= n)%nat -> exists y, forall k, applyB O y k = Sum m (fun i => x i * (delta k i - delta k 0%nat))).
    { induction m as [|m IH]; intros Hm.
      - exists (fun _ => 0). intros k. unfold applyB. rewrite (lsum_ext O _ (fun e => 0 * inc k e)) by (intros; ring). rewrite lsum_scal. cbn. ring.
      - destruct IH as [y Hy]; [lia|]. destruct (path_flow n adj O 0 m NL HO (SC 0%nat m ltac:(lia) ltac:(lia))) as [z Hz].
        exists (fun e => y e + x m * z e). intros k. rewrite applyB_plus, applyB_scal, Hy, Hz. reflexivity. }
    destruct (F n (le_n n)) as [y Hy]. exists y. intros k Hk. rewrite Hy.
    rewrite (Sum_ext n _ (fun i => delta k i * x i - delta k 0%nat * x i)) by (intros; ring).
    rewrite Sum_minus, (Sum_delta_l n k x Hk), Sum_scal, Z. ring.
Qed.

(* ---- the sign of (B x I_2): with arcs from i to j and grad_{r_ij} the gradient in r_i, (B x I_2)[grad] = - (grad_{r_k} V_k)_k ---- *)
Theorem B_gradients n adj O V' r k : undirected adj -> (forall i j, V' i j = V' j i) -> oriented n adj O -> (k < n)%nat ->
  applyB O (fun f => fst (grad (V' (fst f) (snd f)) (r (fst f)) (r (snd f)))) k = - fst (grad_i n adj V' r k) /\
  applyB O (fun f => snd (grad (V' (fst f) (snd f)) (r (fst f)) (r (snd f)))) k = - snd (grad_i n adj V' r k).
Proof.
  intros S VS HO Hk.
  assert (G : forall (p : C -> R), (forall z, p (- z)%C = - p z) -> (forall c z, p (RtoC c * z)%C = c * p z) ->
    applyB O (fun f => p (grad (V' (fst f) (snd f)) (r (fst f)) (r (snd f)))) k = - Sum n (fun j => p (pair_grad adj V' r k j))).
  { intros p Po Ps. unfold applyB.
    rewrite (lsum_oriented n adj) by (try assumption; intros i j; cbn [fst snd]; rewrite (grad_antisym (V' i j) (r j) (r i)), Po, (VS i j); unfold inc; cbn [fst snd]; ring).
    cbn [fst snd]. unfold inc; cbn [fst snd].
    rewrite (Sum_ext n _ (fun b => delta k b * Sum n (fun j => w adj b j * p (grad (V' j b) (r j) (r b))) - Sum n (fun j => delta k j * (w adj b j * p (grad (V' j b) (r j) (r b)))))).
    - rewrite Sum_minus, (Sum_delta_l n k (fun b => Sum n (fun j => w adj b j * p (grad (V' j b) (r j) (r b)))) Hk).
      rewrite (Sum_ext n (fun b => Sum n (fun j => delta k j * (w adj b j * p (grad (V' j b) (r j) (r b))))) (fun b => w adj b k * p (grad (V' k b) (r k) (r b))))
        by (intros b _; now rewrite (Sum_delta_l n k (fun j => w adj b j * p (grad (V' j b) (r j) (r b))) Hk)).
      rewrite (Sum_ext n (fun j => w adj k j * p (grad (V' j k) (r j) (r k))) (fun j => - p (pair_grad adj V' r k j))).
      + rewrite (Sum_ext n (fun b => w adj b k * p (grad (V' k b) (r k) (r b))) (fun j => p (pair_grad adj V' r k j))).
        * rewrite Sum_opp. field.
        * intros b _. unfold pair_grad. rewrite Ps. unfold w. now rewrite (S b k).
      + intros j _. unfold pair_grad. rewrite (grad_antisym (V' j k) (r k) (r j)), Po, Ps, (VS j k). ring.
    - intros b _. rewrite <- Sum_scal, <- Sum_minus. apply Sum_ext; intros j _. ring. }
  split.
  - apply (G fst); intros; cbn; ring.
  - apply (G snd); intros; cbn; ring.
Qed.
(* the accelerations add up to 0 in each axis: they are orthogonal to 1 *)
Theorem eq14_sum n adj V' (r v : nat -> R -> C) (t : R) : undirected adj -> (forall i j, V' i j = V' j i) ->
  (forall i, (i < n)%nat -> is_velocity (v i) t (control4 n adj V' (fun i => r i t) (fun i => v i t) i)) ->
  Sum n (fun i => fst (control4 n adj V' (fun i => r i t) (fun i => v i t) i)) = 0 /\
  Sum n (fun i => snd (control4 n adj V' (fun i => r i t) (fun i => v i t) i)) = 0.
Proof.
  intros S VS HU. set (u := control4 n adj V' (fun i => r i t) (fun i => v i t)) in *.
  pose proof (momentum n adj V' r v t S VS HU) as [M1 M2].
  assert (T1 : is_derive (fun s => fst (Csum n (fun i => v i s))) t (Sum n (fun i => fst (u i)))).
  { apply (D_Sum n (fun i s => fst (v i s)) (fun i => fst (u i))). intros; now apply HU. }
  assert (T2 : is_derive (fun s => snd (Csum n (fun i => v i s))) t (Sum n (fun i => snd (u i)))).
  { apply (D_Sum n (fun i s => snd (v i s)) (fun i => snd (u i))). intros; now apply HU. }
  apply is_derive_unique in M1, M2, T1, T2. rewrite M1 in T1. rewrite M2 in T2. cbn [fst snd RtoC] in T1, T2.
  split; symmetry; assumption.
Qed.
(* where the velocities are equal at all times their derivatives are equal: multiples of 1 in each axis *)
Theorem eq14_common n (v : nat -> R -> C) (a : nat -> C) (t : R) :
  (forall i j s, (i < n)%nat -> (j < n)%nat -> v i s = v j s) -> (forall i, (i < n)%nat -> is_velocity (v i) t (a i)) ->
  exists c : C, forall i, (i < n)%nat -> a i = c.
Proof.
  intros E D. exists (a 0%nat). intros i Hi. destruct (D i Hi) as [X Y], (D 0%nat ltac:(lia)) as [X0 Y0].
  apply is_derive_unique in X, Y, X0, Y0. apply injective_projections.
  - rewrite <- X, <- X0. apply Derive_ext; intros s. now rewrite (E i 0%nat s Hi ltac:(lia)).
  - rewrite <- Y, <- Y0. apply Derive_ext; intros s. now rewrite (E i 0%nat s Hi ltac:(lia)).
Qed.
(* eq (14): where all accelerations are equal they are 0, and so are all potential forces if the velocities are equal too *)
Theorem eq14 n adj V' (r v : nat -> R -> C) (t : R) : (1 <= n)%nat -> undirected adj -> (forall i j, V' i j = V' j i) ->
  (forall i, (i < n)%nat -> is_velocity (v i) t (control4 n adj V' (fun i => r i t) (fun i => v i t) i)) ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> control4 n adj V' (fun i => r i t) (fun i => v i t) i = control4 n adj V' (fun i => r i t) (fun i => v i t) j) ->
  forall i, (i < n)%nat -> control4 n adj V' (fun i => r i t) (fun i => v i t) i = RtoC 0.
Proof.
  intros Hn S VS HU E i Hi. pose proof (INR_pos n Hn) as P. destruct (eq14_sum n adj V' r v t S VS HU) as [T1 T2].
  set (u := control4 n adj V' (fun i => r i t) (fun i => v i t)) in *.
  rewrite (Sum_ext n _ (fun _ => fst (u i))) in T1 by (intros j Hj; now rewrite (E j i Hj Hi)).
  rewrite (Sum_ext n _ (fun _ => snd (u i))) in T2 by (intros j Hj; now rewrite (E j i Hj Hi)).
  rewrite Sum_const in T1, T2. apply injective_projections; apply (Rmult_eq_reg_l (INR n)); try lra.
  - rewrite T1. cbn [fst RtoC]. ring.
  - rewrite T2. cbn [snd RtoC]. ring.
Qed.

(* the columns of the incidence matrix of a tree are independent: an edge is the only one between two sides *)
Lemma lsum_single O f h : NoDup O -> In f O -> (forall e, In e O -> e <> f -> h e = 0) -> lsum O h = h f.
Proof.
  induction O as [|e O IH]; intros ND Hf Z; [destruct Hf|]. inversion ND as [|? ? NI ND']; subst. change (lsum (e :: O) h) with (h e + lsum O h).
  destruct Hf as [->|Hf].
  - replace (lsum O h) with 0; [ring|]. symmetry. assert (Z' : forall e, In e O -> h e = 0).
    { intros e He. apply Z; [now right|]. intros ->. contradiction. }
    clear - Z'. induction O as [|e O IH]; [reflexivity|]. change (lsum (e :: O) h) with (h e + lsum O h).
    rewrite (Z' e (or_introl eq_refl)), IH; [ring|]. intros; apply Z'; now right.
  - rewrite (Z e (or_introl eq_refl)) by (intros ->; contradiction). rewrite IH; [ring|assumption..|]. intros; apply Z; [now right|assumption].
Qed.
Lemma lsum_Sum n O (g : nat -> nat * nat -> R) : Sum n (fun k => lsum O (g k)) = lsum O (fun f => Sum n (fun k => g k f)).
Proof.
  induction O as [|f O IH]; [apply Sum_0|]. change (lsum (f :: O) (fun f => Sum n (fun k => g k f))) with (Sum n (fun k => g k f) + lsum O (fun f => Sum n (fun k => g k f))).
  rewrite <- IH, <- Sum_plus. reflexivity.
Qed.
Lemma lsum_times O c h : c * lsum O h = lsum O (fun f => c * h f).
Proof. induction O as [|f O IH]; cbn; [ring|]. unfold lsum in IH. rewrite <- IH. ring. Qed.
Theorem tree_columns n adj O y : undirected adj -> tanner_trees.tree n adj -> oriented n adj O ->
  (forall k, (k < n)%nat -> lsum O (fun f => inc k f * y f) = 0) -> forall f, In f O -> y f = 0.
Proof.
  intros S Tr (ND & B & M) Z [a b] Hf. destruct (B a b Hf) as [Ha Hb].
  assert (one : forall e, In e O -> member O e = 1) by (intros e He; unfold member; destruct (in_dec pair_dec e O); [reflexivity|contradiction]).
  assert (pos : forall e, 0 <= member O e) by (intros e; unfold member; destruct (in_dec pair_dec e O); lra).
  assert (link : forall i j, In (i, j) O -> adj i j = true).
  { intros i j H. destruct (B i j H) as [Hi Hj]. pose proof (M i j Hi Hj) as E. rewrite (one _ H) in E. pose proof (pos (j, i)).
    unfold w in E. destruct (adj i j); [reflexivity|lra]. }
  destruct (tanner_trees.sides n adj a b S Tr Ha Hb (link a b Hf)) as [s [Sa [Sb U]]].
  set (side := fun k : nat => if s k then 1 else 0).
  assert (E : Sum n (fun k => side k * lsum O (fun f => inc k f * y f)) = 0) by (apply Sum_zero; intros k Hk; rewrite (Z k Hk); ring).
  rewrite (Sum_ext n _ (fun k => lsum O (fun f => side k * (inc k f * y f)))) in E by (intros; apply lsum_times).
  rewrite lsum_Sum in E. rewrite (lsum_single O (a, b)) in E; [|assumption..|].
  - rewrite (Sum_ext n _ (fun k => delta k b * (side k * y (a, b)) - delta k a * (side k * y (a, b)))) in E by (intros; unfold inc; cbn [fst snd]; ring).
    rewrite Sum_minus, (Sum_delta n b (fun k => side k * y (a, b)) Hb), (Sum_delta n a (fun k => side k * y (a, b)) Ha) in E.
    unfold side in E. rewrite Sa, Sb in E. lra.
  - intros [i j] He N. destruct (B i j He) as [Hi Hj].
    rewrite (Sum_ext n _ (fun k => delta k j * (side k * y (i, j)) - delta k i * (side k * y (i, j)))) by (intros; unfold inc; cbn [fst snd]; ring).
    rewrite Sum_minus, (Sum_delta n j (fun k => side k * y (i, j)) Hj), (Sum_delta n i (fun k => side k * y (i, j)) Hi). unfold side.
    destruct (s i) eqn:Si, (s j) eqn:Sj; try ring; exfalso.
    + destruct (U i j Hi Hj (link i j He) Si Sj) as [-> ->]. now apply N.
    + destruct (U j i Hj Hi ltac:(rewrite S; now apply link) Sj Si) as [-> ->].
      pose proof (M a b Ha Hb) as E2. rewrite (one _ Hf), (one _ He) in E2. unfold w in E2. destruct (adj a b); lra.
Qed.
