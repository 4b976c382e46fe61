(* Paley et al., Laplacian quadratic forms and the potential W_1: the display after (11) and its factor, the kernel
   of Q_L, the incidence matrix, the zero sets of W_1 on directed graphs, the gradient of W_1 and the model (15),
   eq (16), the properness of the spacing potential (17).  All forms are sums over arcs of |x_k - x_j|^2. *)
From Coq Require Import Reals Lra Lia Psatz Relations List.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums paley_model paley_phase.
Open Scope R_scope.

Definition dist2 (x y : C) : R := inner (x - y)%C (x - y)%C.
Lemma dist2_xy x y : dist2 x y = (fst x - fst y) ^ 2 + (snd x - snd y) ^ 2.
Proof. unfold dist2. rewrite inner_xy. cbn. ring. Qed.
Lemma dist2_ge0 x y : 0 <= dist2 x y.
Proof. apply inner_self_ge0. Qed.
Lemma dist2_0 x y : dist2 x y = 0 <-> x = y.
Proof.
  split; intros H.
  - rewrite dist2_xy in H. destruct x as [a b], y as [c d]; cbn [fst snd] in *.
    pose proof (pow2_ge_0 (a - c)). pose proof (pow2_ge_0 (b - d)). f_equal; nra.
  - rewrite H, dist2_xy. ring.
Qed.
Lemma dist2_Cmod x y : dist2 x y = Cmod (x - y)%C ^ 2.
Proof. apply inner_self. Qed.

(* ---- the quadratic form of an undirected graph ---- *)
Definition total (n : nat) (adj : graph) (x : nat -> C) : R :=
  Sum n (fun k => Sum n (fun j => w adj k j * dist2 (x k) (x j))).
Lemma lap_form n adj (x : nat -> C) : undirected adj ->
  Sum n (fun k => inner (x k) (row n (lap n adj) k x)) = / 2 * total n adj x.
Proof.
  intros S. unfold total.
  pose proof (half_swap n (fun k j => w adj k j * (fst (x k) - fst (x j))) (fun k => fst (x k))) as H1.
  pose proof (half_swap n (fun k j => w adj k j * (snd (x k) - snd (x j))) (fun k => snd (x k))) as H2.
  cbv beta in H1, H2.
  rewrite (Sum_ext n _ (fun k => fst (x k) * Sum n (fun j => w adj k j * (fst (x k) - fst (x j)))
                              + snd (x k) * Sum n (fun j => w adj k j * (snd (x k) - snd (x j))))).
  - rewrite Sum_plus.
    rewrite (Sum_ext n (fun k => Sum n (fun j => w adj k j * dist2 (x k) (x j)))
      (fun k => Sum n (fun j => w adj k j * (fst (x k) - fst (x j)) * (fst (x k) - fst (x j)))
              + Sum n (fun j => w adj k j * (snd (x k) - snd (x j)) * (snd (x k) - snd (x j))))).
    + rewrite Sum_plus, H1, H2; [field|intros i j _ _; unfold w; rewrite (S j i); ring..].
    + intros k _. rewrite <- Sum_plus. apply Sum_ext; intros j _. rewrite dist2_xy. ring.
  - intros k Hk. rewrite inner_xy, row_lap by assumption. unfold Csum; cbn. f_equal; f_equal; apply Sum_ext; intros; ring.
Qed.
Theorem Q_total n adj x : (1 <= n)%nat -> undirected adj -> Q n (lap n adj) x = / (4 * INR n) * total n adj x.
Proof. intros Hn S. pose proof (INR_pos n Hn). unfold Q. rewrite lap_form by assumption. field. lra. Qed.

(* E as a list of directed edges (j, k), as in the tutorial: both (j, k) and (k, j) when G is undirected *)
Definition lsum (E : list (nat * nat)) (f : nat * nat -> R) : R := fold_right (fun e s => f e + s) 0 E.
Definition lists_edges (n : nat) (adj : graph) (E : list (nat * nat)) :=
  NoDup E /\ forall j k, In (j, k) E <-> arc n adj j k.
Lemma pair_dec (e f : nat * nat) : {e = f} + {e <> f}.
Proof. repeat decide equality. Defined.
Definition member (E : list (nat * nat)) (e : nat * nat) : R := if in_dec pair_dec e E then 1 else 0.
Lemma lsum_double n E f : NoDup E -> (forall j k, In (j, k) E -> (j < n)%nat /\ (k < n)%nat) ->
  lsum E f = Sum n (fun k => Sum n (fun j => member E (j, k) * f (j, k))).
Proof.
  induction E as [|[a b] E IH]; intros ND B.
  - cbn. symmetry. apply Sum_zero; intros; apply Sum_zero; intros. unfold member; cbn. ring.
  - inversion ND as [|? ? NI ND']; subst. destruct (B a b) as [Ha Hb]; [now left|].
    change (lsum ((a, b) :: E) f) with (f (a, b) + lsum E f).
    rewrite IH; [|assumption|intros; apply B; now right].
    transitivity (Sum n (fun k => delta k b * Sum n (fun j => delta j a * f (j, k)))
      + Sum n (fun k => Sum n (fun j => member E (j, k) * f (j, k)))).
    + rewrite (Sum_delta n b (fun k => Sum n (fun j => delta j a * f (j, k))) Hb), (Sum_delta n a (fun j => f (j, b)) Ha). ring.
    + rewrite <- Sum_plus. apply Sum_ext; intros k _. rewrite <- Sum_scal, <- Sum_plus. apply Sum_ext; intros j _.
      unfold member, delta. destruct (in_dec pair_dec (j, k) ((a, b) :: E)) as [I|I];
        destruct (in_dec pair_dec (j, k) E) as [J|J]; destruct (Nat.eqb_spec k b); destruct (Nat.eqb_spec j a); subst; try ring.
      all: exfalso; cbn in I; try tauto.
      all: destruct I as [I|I]; [injection I; intros; subst; congruence|tauto].
Qed.
Lemma lsum_edges n adj E f : lists_edges n adj E ->
  lsum E f = Sum n (fun k => Sum n (fun j => w adj k j * f (j, k))).
Proof.
  intros [ND I]. rewrite (lsum_double n) by (try assumption; intros j k H; apply I in H; now destruct H as [? [? _]]).
  apply Sum_ext; intros k Hk; apply Sum_ext; intros j Hj. f_equal. unfold member, w.
  destruct (in_dec pair_dec (j, k) E) as [H|H].
  - apply I in H. now destruct H as [_ [_ ->]].
  - destruct (adj k j) eqn:A; [|reflexivity]. exfalso. apply H, I. now repeat split.
Qed.

(* the display after (11): with E the directed edges the factor is 1/(4N), not 1/(2N) *)
Theorem length_corrected n adj E x : (1 <= n)%nat -> undirected adj -> lists_edges n adj E ->
  Q n (lap n adj) x = / (4 * INR n) * lsum E (fun e => dist2 (x (fst e)) (x (snd e))).
Proof.
  intros Hn S HE. rewrite Q_total, (lsum_edges n adj E) by assumption. f_equal. unfold total.
  apply Sum_ext; intros k _; apply Sum_ext; intros j _. cbn [fst snd]. rewrite !dist2_xy. ring.
Qed.
(* each undirected edge counted once *)
Theorem length_once n adj x : (1 <= n)%nat -> undirected adj -> no_loops adj ->
  Q n (lap n adj) x = / (2 * INR n) * Sum n (fun k => Sum k (fun j => w adj k j * dist2 (x j) (x k))).
Proof.
  intros Hn S NL. rewrite Q_total by assumption. unfold total.
  assert (H : forall m, Sum m (fun k => Sum m (fun j => w adj k j * dist2 (x k) (x j))) =
     2 * Sum m (fun k => Sum k (fun j => w adj k j * dist2 (x j) (x k)))).
  { induction m as [|m IH]; [cbn; ring|]. cbn [Sum]. rewrite Sum_plus, IH.
    replace (w adj m m) with 0 by (unfold w; now rewrite (NL m)).
    rewrite (Sum_ext m (fun i => w adj i m * dist2 (x i) (x m)) (fun j => w adj m j * dist2 (x j) (x m))).
    - rewrite (Sum_ext m (fun j => w adj m j * dist2 (x m) (x j)) (fun j => w adj m j * dist2 (x j) (x m))); [ring|].
      intros; rewrite !dist2_xy; ring.
    - intros i _. unfold w. now rewrite (S i m). }
  rewrite H. pose proof (INR_pos n Hn). field. lra.
Qed.
Definition K2_edges : list (nat * nat) := (0, 1)%nat :: (1, 0)%nat :: nil.
Lemma K2_lists : lists_edges 2 complete K2_edges.
Proof.
  split.
  - repeat constructor; cbn; intuition discriminate.
  - intros j k. unfold arc, complete. cbn. split.
    + intros [H|[H|[]]]; injection H; intros; subst; cbn; repeat split; lia.
    + intros [Hj [Hk H]]. destruct j as [|[|]], k as [|[|]]; try lia; cbn in H; try discriminate; auto.
Qed.
Lemma complete_undirected : undirected complete.
Proof. intros k j. unfold complete. now rewrite Nat.eqb_sym. Qed.
Lemma complete_no_loops : no_loops complete.
Proof. intros k. unfold complete. now rewrite Nat.eqb_refl. Qed.
Theorem length_printed_fails : ~ forall n adj E x, (1 <= n)%nat -> undirected adj -> no_loops adj -> lists_edges n adj E ->
  Q n (lap n adj) x = / (2 * INR n) * lsum E (fun e => dist2 (x (fst e)) (x (snd e))).
Proof.
  intros H. pose (x := fun k : nat => RtoC (INR k)).
  pose proof (H 2%nat complete K2_edges x ltac:(lia) complete_undirected complete_no_loops K2_lists) as P.
  rewrite (length_corrected 2 complete K2_edges x ltac:(lia) complete_undirected K2_lists) in P.
  unfold lsum, K2_edges, x in P. cbn [fold_right fst snd INR] in P. rewrite !dist2_xy in P. cbn in P. lra.
Qed.

(* the incidence matrix of the tutorial: column f = (j, k) has b_kf = 1 = - b_jf *)
Definition inc (k : nat) (f : nat * nat) : R := delta k (snd f) - delta k (fst f).
Theorem incidence_directed n adj E k m : undirected adj -> no_loops adj -> lists_edges n adj E -> (k < n)%nat -> (m < n)%nat ->
  lsum E (fun f => inc k f * inc m f) = 2 * lap n adj k m.
Proof.
  intros S NL HE Hk Hm. rewrite (lsum_edges n adj) by assumption. unfold inc; cbn [fst snd].
  transitivity (Sum n (fun b => delta k b * (delta m b * deg n adj b)) - Sum n (fun b => delta k b * w adj b m)
    - Sum n (fun b => delta m b * w adj b k) + Sum n (fun a => delta k a * (delta m a * deg n adj a))).
  - unfold deg.
    rewrite (Sum_ext n (fun b => delta k b * w adj b m) (fun b => Sum n (fun a => delta m a * (delta k b * w adj b a))))
      by (intros b _; now rewrite (Sum_delta_l n m (fun a => delta k b * w adj b a) Hm)).
    rewrite (Sum_ext n (fun b => delta m b * w adj b k) (fun b => Sum n (fun a => delta k a * (delta m b * w adj b a))))
      by (intros b _; now rewrite (Sum_delta_l n k (fun a => delta m b * w adj b a) Hk)).
    assert (T : Sum n (fun a => delta k a * (delta m a * Sum n (w adj a))) =
       Sum n (fun b => Sum n (fun a => delta k a * delta m a * w adj b a))).
    { rewrite Sum_swap. apply Sum_ext; intros a _. rewrite Sum_scal, Rmult_assoc. do 2 f_equal. apply Sum_ext; intros.
      unfold w. now rewrite (S a i). }
    rewrite T at 2. rewrite <- !Sum_minus, <- Sum_plus. apply Sum_ext; intros b _.
    rewrite <- !Rmult_assoc, <- Sum_scal, <- !Sum_minus, <- Sum_plus. apply Sum_ext; intros a _. ring.
  - rewrite (Sum_delta_l n k (fun b => delta m b * deg n adj b) Hk), (Sum_delta_l n k (fun b => w adj b m) Hk),
      (Sum_delta_l n m (fun b => w adj b k) Hm). unfold lap. rewrite (delta_sym m k).
    replace (w adj m k) with (w adj k m) by (unfold w; now rewrite (S k m)). ring.
Qed.
Theorem incidence_printed_fails : ~ forall n adj E k m, undirected adj -> no_loops adj -> lists_edges n adj E ->
  (k < n)%nat -> (m < n)%nat -> lap n adj k m = lsum E (fun f => inc k f * inc m f).
Proof.
  intros H. specialize (H 2%nat complete K2_edges 0%nat 0%nat complete_undirected complete_no_loops K2_lists ltac:(lia) ltac:(lia)).
  rewrite (incidence_directed 2 complete) in H by (first [apply complete_undirected|apply complete_no_loops|apply K2_lists|lia]).
  unfold lap, deg, w, complete, delta in H. cbn in H. lra.
Qed.

(* ---- the kernel of Q_L ---- *)
Lemma equal_along n (adj : graph) (x : nat -> C) : (forall j k, arc n adj j k -> x j = x k) ->
  (forall j k, clos_refl_trans nat (arc n adj) j k -> x j = x k).
Proof. intros H j k P. induction P; [now apply H|reflexivity|congruence]. Qed.
Lemma total_ge0 n adj x : 0 <= total n adj x.
Proof. apply Sum_ge0; intros; apply Sum_ge0; intros. apply Rmult_le_pos; [apply w_ge0|apply dist2_ge0]. Qed.
Lemma total_0 n adj x : total n adj x = 0 <-> forall j k, arc n adj j k -> x j = x k.
Proof.
  assert (P : forall k j, 0 <= w adj k j * dist2 (x k) (x j)) by (intros; apply Rmult_le_pos; [apply w_ge0|apply dist2_ge0]).
  split.
  - intros T j k [Hj [Hk A]]. symmetry. apply dist2_0.
    assert (E : w adj k j * dist2 (x k) (x j) = 0).
    { apply (Sum_eq0 n (fun j => w adj k j * dist2 (x k) (x j))); try assumption; [intros; apply P|].
      apply (Sum_eq0 n (fun k => Sum n (fun j => w adj k j * dist2 (x k) (x j)))); try assumption.
      intros; apply Sum_ge0; intros; apply P. }
    unfold w in E. rewrite A in E. lra.
  - intros H. apply Sum_zero; intros k Hk; apply Sum_zero; intros j Hj. unfold w. destruct (adj k j) eqn:A; [|ring].
    rewrite (H j k), (proj2 (dist2_0 _ _) eq_refl); [ring|now repeat split].
Qed.
Theorem Q_kernel n adj x : (1 <= n)%nat -> undirected adj -> strongly_connected n adj ->
  0 <= Q n (lap n adj) x /\ (Q n (lap n adj) x = 0 <-> exists c : C, forall k, (k < n)%nat -> x k = c).
Proof.
  intros Hn S CN. pose proof (INR_pos n Hn). rewrite Q_total by assumption.
  assert (F : 0 < / (4 * INR n)) by (apply Rinv_0_lt_compat; lra). pose proof (total_ge0 n adj x) as T.
  split; [nra|]. split.
  - intros E. exists (x 0%nat). intros k Hk. symmetry. apply (equal_along n adj x); [|apply CN; lia].
    apply total_0. nra.
  - intros [c Hc]. rewrite (proj2 (total_0 n adj x)); [ring|]. intros j k [Hj [Hk _]]. now rewrite !Hc.
Qed.

(* ---- the zeros of W_1 on directed graphs ---- *)
Theorem W1_formula n adj th : W1 n adj th = / (2 * INR n) * Sum n (fun k => inner (phasors th k) (row n (lap n adj) k (phasors th)))
  /\ W1 n adj th = / (2 * INR n) * Sum n (fun k => deg n adj k - Sum n (fun j => w adj k j * inner (expi (th k)) (expi (th j)))).
Proof.
  split; [reflexivity|]. rewrite W1_arcs. f_equal. apply Sum_ext; intros k _. unfold deg. rewrite <- Sum_minus.
  apply Sum_ext; intros j _. rewrite inner_expi. ring.
Qed.
Theorem W1_ge0 n adj th : (1 <= n)%nat -> 0 <= W1 n adj th.
Proof.
  intros Hn. pose proof (INR_pos n Hn). rewrite W1_arcs. apply Rmult_le_pos; [left; apply Rinv_0_lt_compat; lra|].
  apply Sum_ge0; intros; apply Sum_ge0; intros. pose proof (COS_bound (th i0 - th i)). apply Rmult_le_pos; [apply w_ge0|lra].
Qed.
Theorem W1_zero n adj th : (1 <= n)%nat -> (W1 n adj th = 0 <-> forall j k, arc n adj j k -> expi (th j) = expi (th k)).
Proof.
  intros Hn. pose proof (INR_pos n Hn) as P. rewrite W1_arcs.
  assert (F : 0 < / (2 * INR n)) by (apply Rinv_0_lt_compat; lra).
  assert (T : forall k j, 0 <= w adj k j * (1 - cos (th j - th k)))
    by (intros k j; pose proof (COS_bound (th j - th k)); apply Rmult_le_pos; [apply w_ge0|lra]).
  split.
  - intros E j k [Hj [Hk A]]. apply expi_eq_cos.
    assert (Z : w adj k j * (1 - cos (th j - th k)) = 0).
    { apply (Sum_eq0 n (fun j => w adj k j * (1 - cos (th j - th k)))); try assumption; [intros; apply T|].
      apply (Sum_eq0 n (fun k => Sum n (fun j => w adj k j * (1 - cos (th j - th k))))); try assumption.
      - intros; apply Sum_ge0; intros; apply T.
      - apply Rmult_integral in E as [E|E]; [lra|exact E]. }
    unfold w in Z. rewrite A in Z. lra.
  - intros H. rewrite Sum_zero; [ring|]. intros k Hk. apply Sum_zero; intros j Hj. unfold w. destruct (adj k j) eqn:A; [|ring].
    rewrite (proj1 (expi_eq_cos _ _) (H j k (conj Hj (conj Hk A)))). ring.
Qed.
Theorem W1_strongly n adj th : (1 <= n)%nat -> strongly_connected n adj -> (W1 n adj th = 0 <-> synchronized n th).
Proof.
  intros Hn SC. rewrite W1_zero by assumption. split.
  - intros H j k Hj Hk. apply (equal_along n adj (phasors th)); [exact H|now apply SC].
  - intros H j k [Hj [Hk _]]. now apply H.
Qed.
(* weakly connected: joined by arcs in either direction *)
Definition weakly_joined (n : nat) (adj : graph) := clos_refl_sym_trans nat (arc n adj).
Theorem W1_weakly n adj th : (1 <= n)%nat ->
  (W1 n adj th = 0 <-> forall j k, weakly_joined n adj j k -> expi (th j) = expi (th k)).
Proof.
  intros Hn. rewrite W1_zero by assumption. split.
  - intros H j k P. induction P; [now apply H|reflexivity|now symmetry|congruence].
  - intros H j k A. apply H. now apply rst_step.
Qed.
Corollary W1_positive n adj th : (1 <= n)%nat -> ~ (forall j k, weakly_joined n adj j k -> expi (th j) = expi (th k)) -> 0 < W1 n adj th.
Proof.
  intros Hn H. destruct (W1_ge0 n adj th Hn) as [P|Z]; [exact P|]. exfalso. apply H, (W1_weakly n adj th Hn). now symmetry.
Qed.
Theorem fish_zero n adj th : (1 <= n)%nat -> 0 <= W1 n adj th /\ (synchronized n th -> W1 n adj th = 0) /\
  (W1 n adj th = 0 -> forall j k, weakly_joined n adj j k -> expi (th j) = expi (th k)).
Proof.
  intros Hn. split; [now apply W1_ge0|]. split; [|now apply W1_weakly].
  intros S. apply W1_zero; [assumption|]. intros j k [Hj [Hk _]]. now apply S.
Qed.
(* the printed condition: phases equal within every strongly connected subgraph *)
Definition same_strong (n : nat) (adj : graph) (j k : nat) :=
  clos_refl_trans nat (arc n adj) j k /\ clos_refl_trans nat (arc n adj) k j.
Definition one_arc (k j : nat) : bool := Nat.eqb k 1 && Nat.eqb j 0.      (* the single arc from 0 to 1 *)
Lemma one_arc_path j k : clos_refl_trans nat (arc 2 one_arc) j k -> j = k \/ j = 0%nat.
Proof.
  intros P. apply clos_rt_rt1n in P. destruct P as [|y z [_ [_ A]] _]; [now left|]. right.
  unfold one_arc in A. destruct (Nat.eqb_spec y 1), (Nat.eqb_spec j 0); cbn in A; congruence.
Qed.
Theorem zero_dir_printed_fails : ~ forall n adj th, (1 <= n)%nat -> no_loops adj -> ~ strongly_connected n adj ->
  (W1 n adj th = 0 <-> forall j k, (j < n)%nat -> (k < n)%nat -> same_strong n adj j k -> expi (th j) = expi (th k)).
Proof.
  intros H. pose (th := fun k : nat => if Nat.eqb k 0 then 0 else PI).
  assert (NL : no_loops one_arc) by (intros [|[|k]]; reflexivity).
  assert (NS : ~ strongly_connected 2 one_arc).
  { intros SC. destruct (one_arc_path 1 0) as [E|E]; [apply SC; lia|discriminate..]. }
  assert (A : W1 2 one_arc th = 0).
  { apply (H 2%nat one_arc th); try assumption; [lia|]. intros j k Hj Hk [P1 P2].
    apply one_arc_path in P1, P2. replace j with k; [reflexivity|]. destruct P1, P2; congruence. }
  pose proof (proj1 (W1_zero 2 one_arc th ltac:(lia)) A 0%nat 1%nat) as B. unfold th in B; cbn [Nat.eqb] in B.
  assert (E : expi 0 = expi PI) by (apply B; repeat split; lia). injection E as E _. rewrite cos_0, cos_PI in E. lra.
Qed.
