(* Tanner, Jadbabaie, Pappas, Part II: lambda_2 as the second smallest eigenvalue of L, counted with multiplicity; that it is the least
   value of the form on unit vectors normal to 1 (Courant and Fischer) is proved here by compactness. With it, and with rates as
   derivatives along (4), what the clauses say that speak of them:
     tanner2.cor2_sub, cor2_rate, S_config, vdotB (corrected), tanner2.L, tanner1.L.ones. *)
From Coq Require Import Reals Lra Lia Psatz Classical List.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums paley_model paley_phase paley_laplacian paley_gradient paley_particles tanner_energy tanner_flock tanner_graph tanner2_facts.
Open Scope R_scope.

(* L x = lam x *)
Definition eigen (n : nat) (adj : graph) (lam : R) (x : nat -> R) :=
  forall i, (i < n)%nat -> Sum n (fun j => lap n adj i j * x j) = lam * x i.
Definition varies (n : nat) (x : nat -> R) := exists i j, (i < n)%nat /\ (j < n)%nat /\ x i <> x j.
(* L 1 = 0: the second smallest eigenvalue is the least one that has an eigenvector off span 1 *)
Definition second_eigenvalue (n : nat) (adj : graph) (lam : R) :=
  (exists x, eigen n adj lam x /\ varies n x) /\ forall mu x, eigen n adj mu x -> varies n x -> lam <= mu.

Theorem null_vectors n adj (x : nat -> R) : (1 <= n)%nat -> strongly_connected n adj ->
  ((forall k, (k < n)%nat -> Sum n (fun j => lap n adj k j * x j) = 0) <-> exists c, forall k, (k < n)%nat -> x k = c).
Proof.
  intros Hn SC. split; [exact (lap_kernel n adj x Hn SC)|]. intros [c E] k Hk.
  rewrite <- (lap_ones n adj c k Hk). apply Sum_ext. intros j Hj. now rewrite (E j Hj).
Qed.

(* ---- a least value is attained ---- *)
(* of sets of points of a cube, one in the other, none empty, some point is near to all *)
Lemma cluster n (S : R -> (nat -> R) -> Prop) : (forall e, 0 < e -> exists x, S e x) -> (forall e e' x, e <= e' -> S e x -> S e' x) ->
  (forall e x i, S e x -> (i < n)%nat -> -1 <= x i <= 1) ->
  exists a, forall e, 0 < e -> exists x, S e x /\ forall i, (i < n)%nat -> Rabs (x i - a i) < e.
Proof.
  intros Ne Mo. induction n as [|n IH]; intros Bd.
  - exists (fun _ => 0). intros e He. destruct (Ne e He) as [x Hx]. exists x. split; [exact Hx|intros; lia].
  - destruct IH as [a Ha]; [intros e x i Sx Hi; apply (Bd e x i Sx); lia|].
    set (T := fun e x => S e x /\ forall i, (i < n)%nat -> Rabs (x i - a i) < e).
    assert (MT : forall e e' x, e <= e' -> T e x -> T e' x) by (intros e e' x L [A B]; split; [now apply (Mo e)|intros i Hi; specialize (B i Hi); lra]).
    set (E := fun y => exists e, 0 < e /\ forall x, T e x -> y <= x n).
    destruct (completeness E) as [l [Up Lo]].
    + exists 1. intros y (e & He & Q). destruct (Ha e He) as [x Tx]. apply Rle_trans with (x n); [now apply Q|]. apply (Bd e x n); [apply Tx|lia].
    + exists (-1). exists 1. split; [lra|]. intros x [Sx _]. apply (Bd 1 x n Sx). lia.
    + exists (fun i => if Nat.eqb i n then l else a i). intros e He.
      assert (Y : exists y, E y /\ l - e < y).
      { apply NNPP. intros N. assert (l <= l - e); [|lra]. apply Lo. intros y Ey. apply Rnot_lt_le. intros L. apply N. now exists y. }
      destruct Y as (y & (e1 & He1 & Q) & Ly). set (d := Rmin e e1). assert (Hd : 0 < d) by (now apply Rmin_glb_lt).
      assert (X : exists x, T d x /\ x n < l + e).
      { apply NNPP. intros N. assert (l + e <= l); [|lra]. apply Up. exists d. split; [exact Hd|]. intros x Tx. apply Rnot_lt_le. intros L. apply N. now exists x. }
      destruct X as (x & Tx & Lx). pose proof (Rmin_l e e1). pose proof (Rmin_r e e1). fold d in H, H0.
      assert (y <= x n) by (apply Q; apply (MT d); [lra|exact Tx]). exists x. split; [apply (Mo d); [lra|apply Tx]|].
      intros i Hi. destruct (Nat.eqb_spec i n) as [->|Ni]; [apply Rabs_def1; lra|]. destruct (MT d e x ltac:(lra) Tx) as [_ B]. apply B. lia.
Qed.
(* functions of x_0, .., x_(n-1) that are continuous at a *)
Definition near_to (n : nat) (a : nat -> R) (P : (nat -> R) -> Prop) := exists d, 0 < d /\ forall x, (forall i, (i < n)%nat -> Rabs (x i - a i) < d) -> P x.
Global Instance near_filter n a : Filter (near_to n a).
Proof.
  constructor.
  - exists 1. split; [lra|]. intros; exact I.
  - intros P Q (d & Hd & A) (e & He & B). exists (Rmin d e). split; [now apply Rmin_glb_lt|]. pose proof (Rmin_l d e). pose proof (Rmin_r d e).
    intros x Hx. split; [apply A|apply B]; intros i Hi; specialize (Hx i Hi); lra.
  - intros P Q H (d & Hd & A). exists d. split; [exact Hd|]. intros x Hx. now apply H, A.
Qed.
Definition cont n a (f : (nat -> R) -> R) := filterlim f (near_to n a) (locally (f a)).
Lemma cont_coordinate n a i : (i < n)%nat -> cont n a (fun x => x i).
Proof. intros Hi P [d Hd]. exists d. split; [apply cond_pos|]. intros x Hx. apply Hd. exact (Hx i Hi). Qed.
Lemma cont_const n a c : cont n a (fun _ => c).
Proof. apply filterlim_const. Qed.
Lemma cont_plus n a f g : cont n a f -> cont n a g -> cont n a (fun x => f x + g x).
Proof. intros F G. exact (filterlim_comp_2 f g Rplus F G (filterlim_plus (f a) (g a))). Qed.
Lemma cont_mult n a f g : cont n a f -> cont n a g -> cont n a (fun x => f x * g x).
Proof. intros F G. exact (filterlim_comp_2 f g Rmult F G (filterlim_mult (f a) (g a))). Qed.
Lemma cont_Sum n a m (f : nat -> (nat -> R) -> R) : (forall i, (i < m)%nat -> cont n a (f i)) -> cont n a (fun x => Sum m (fun i => f i x)).
Proof.
  induction m as [|m IH]; intros H; [apply cont_const|]. apply (cont_plus n a (fun x => Sum m (fun i => f i x)) (f m)); [apply IH; intros; apply H; lia|apply H; lia].
Qed.
Lemma cont_close n a f e : 0 < e -> cont n a f -> near_to n a (fun x => Rabs (f x - f a) < e).
Proof. intros He F. apply (F (fun y => Rabs (y - f a) < e)). exists (mkposreal e He). intros y Hy. exact Hy. Qed.
Lemma cont_form n adj a : cont n a (fun x => qform n (lap n adj) x).
Proof.
  apply (cont_Sum n a n (fun i x => x i * Sum n (fun j => lap n adj i j * x j))). intros i Hi.
  apply (cont_mult n a (fun x => x i)); [now apply cont_coordinate|]. apply (cont_Sum n a n (fun j x => lap n adj i j * x j)). intros j Hj.
  apply (cont_mult n a (fun _ => lap n adj i j)); [apply cont_const|now apply cont_coordinate].
Qed.
Lemma cont_square n a : cont n a (fun x => Sum n (fun i => x i * x i)).
Proof. apply (cont_Sum n a n (fun i x => x i * x i)). intros i Hi. now apply cont_mult; apply cont_coordinate. Qed.
Lemma cont_total n a : cont n a (fun x => Sum n x).
Proof. apply (cont_Sum n a n (fun i x => x i)). intros i Hi. now apply cont_coordinate. Qed.
Lemma same a b : (forall e, 0 < e -> Rabs (a - b) < e) -> a = b.
Proof. intros H. destruct (Req_dec a b) as [|N]; [assumption|]. specialize (H (Rabs (a - b)) ltac:(apply Rabs_pos_lt; lra)). lra. Qed.

Section Least.
Variables (n : nat) (adj : graph).
Hypothesis Hn : (2 <= n)%nat.
Hypothesis S : undirected adj.
Notation q := (qform n (lap n adj)).
Notation sq x := (Sum n (fun i => x i * x i)).
Lemma q_ge0 x : 0 <= q x.
Proof.
  rewrite qform_edges by exact S. apply Rmult_le_pos; [lra|]. apply Sum_ge0; intros; apply Sum_ge0; intros. apply Rmult_le_pos; [apply w_ge0|apply pow2_ge_0].
Qed.
Lemma q_scal c x : q (fun i => c * x i) = c * c * q x.
Proof.
  unfold qform. rewrite <- Sum_scal. apply Sum_ext. intros i _. rewrite (Sum_ext n _ (fun j => c * (lap n adj i j * x j))) by (intros; ring). rewrite Sum_scal. ring.
Qed.
Definition unit_normal (x : nat -> R) := Sum n x = 0 /\ sq x = 1.
Lemma some_unit : exists x, unit_normal x.
Proof.
  assert (P : 0 < / sqrt 2) by (apply Rinv_0_lt_compat, sqrt_lt_R0; lra). assert (E : / sqrt 2 * / sqrt 2 = / 2) by (rewrite <- Rinv_mult, sqrt_sqrt; lra).
  exists (fun i => delta i 0%nat * / sqrt 2 - delta i 1%nat * / sqrt 2). split.
  - rewrite Sum_minus, (Sum_delta n 0 (fun _ => / sqrt 2)), (Sum_delta n 1 (fun _ => / sqrt 2)) by lia. ring.
  - rewrite (Sum_ext n _ (fun i => delta i 0%nat * / 2 + delta i 1%nat * / 2)).
    + rewrite Sum_plus, (Sum_delta n 0 (fun _ => / 2)), (Sum_delta n 1 (fun _ => / 2)) by lia. lra.
    + intros i _. rewrite <- E. destruct i as [|[|i]]; [rewrite delta_eq, delta_neq by lia|rewrite delta_eq, delta_neq by lia|rewrite !delta_neq by lia]; ring.
Qed.
Lemma entries x i : unit_normal x -> (i < n)%nat -> -1 <= x i <= 1.
Proof.
  intros [_ U] Hi. pose proof (Sum_term_le n (fun i => x i * x i) i (fun j _ => Rle_0_sqr (x j)) Hi) as L. cbv beta in L. rewrite U in L. split; nra.
Qed.
Lemma attained : exists mu a, unit_normal a /\ q a = mu /\ forall x, unit_normal x -> mu <= q x.
Proof.
  destruct some_unit as [x0 U0].
  destruct (completeness (fun y => forall x, unit_normal x -> y <= q x)) as [mu [Up Lo]].
  { exists (q x0). intros y Hy. now apply Hy. }
  { exists 0. intros x _. apply q_ge0. }
  assert (G : forall x, unit_normal x -> mu <= q x) by (intros x U; apply Lo; intros y Hy; now apply Hy).
  destruct (cluster n (fun e x => unit_normal x /\ q x < mu + e)) as [a Ha].
  { intros e He. apply NNPP. intros N. assert (mu + e <= mu); [|lra]. apply Up. intros x U. apply Rnot_lt_le. intros L. apply N. now exists x. }
  { intros e e' x L [U Q]. split; [exact U|lra]. }
  { intros e x i [U _]. now apply entries. }
  assert (App : forall e, 0 < e -> exists x, unit_normal x /\ q x < mu + e /\ Rabs (q x - q a) < e /\ Rabs (Sum n x - Sum n a) < e /\ Rabs (sq x - sq a) < e).
  { intros e He. destruct (filter_and _ _ (cont_close n a _ e He (cont_form n adj a)) (filter_and _ _ (cont_close n a _ e He (cont_total n a)) (cont_close n a _ e He (cont_square n a)))) as (d & Hd & Q).
    destruct (Ha (Rmin d e)) as (x & [U L] & Near); [now apply Rmin_glb_lt|]. pose proof (Rmin_l d e). pose proof (Rmin_r d e).
    destruct (Q x) as (Q1 & Q2 & Q3); [intros i Hi; specialize (Near i Hi); lra|]. exists x. split; [exact U|]. split; [lra|]. now split. }
  assert (Ua : unit_normal a).
  { split; apply same; intros e He; destruct (App e He) as (x & [U1 U2] & _ & _ & B & C).
    - rewrite U1 in B. rewrite Rabs_minus_sym. exact B.
    - rewrite U2 in C. rewrite Rabs_minus_sym. exact C. }
  exists mu, a. split; [exact Ua|]. split; [|exact G]. apply Rle_antisym; [|now apply G]. apply Rnot_lt_le. intros L.
  destruct (App ((q a - mu) / 2) ltac:(lra)) as (x & _ & A & B & _). apply Rabs_def2 in B. lra.
Qed.
(* the least value is an eigenvalue *)
Lemma lap_column x : Sum n (fun i => Sum n (fun j => lap n adj i j * x j)) = 0.
Proof.
  rewrite Sum_swap. apply Sum_zero. intros j Hj. rewrite (Sum_ext n _ (fun i => x j * (lap n adj j i * 1))) by (intros i _; rewrite (lap_sym n adj S i j); ring).
  rewrite Sum_scal. pose proof (lap_ones n adj 1 j Hj) as Z. unfold lmul in Z. rewrite Z. ring.
Qed.
Lemma q_along a y t : q (fun i => a i + t * y i) = q a + 2 * t * Sum n (fun i => y i * Sum n (fun j => lap n adj i j * a j)) + t * t * q y.
Proof.
  assert (X : Sum n (fun i => a i * Sum n (fun j => lap n adj i j * y j)) = Sum n (fun i => y i * Sum n (fun j => lap n adj i j * a j))).
  { rewrite (Sum_ext n _ (fun i => Sum n (fun j => a i * (lap n adj i j * y j)))) by (intros; now rewrite Sum_scal).
    rewrite Sum_swap. apply Sum_ext. intros j _. rewrite <- Sum_scal. apply Sum_ext. intros i _. rewrite (lap_sym n adj S i j). ring. }
  unfold qform. rewrite (Sum_ext n _ (fun i => a i * Sum n (fun j => lap n adj i j * a j) + t * (a i * Sum n (fun j => lap n adj i j * y j))
    + t * (y i * Sum n (fun j => lap n adj i j * a j)) + t * t * (y i * Sum n (fun j => lap n adj i j * y j)))).
  - rewrite !Sum_plus, !Sum_scal, X. ring.
  - intros i _. rewrite (Sum_ext n (fun j => lap n adj i j * (a j + t * y j)) (fun j => lap n adj i j * a j + t * (lap n adj i j * y j))) by (intros; ring).
    rewrite Sum_plus, Sum_scal. ring.
Qed.
Lemma sq_ge0 (x : nat -> R) : 0 <= sq x.
Proof. apply Sum_ge0. intros. apply Rle_0_sqr. Qed.
Lemma bound_all mu : (forall x, unit_normal x -> mu <= q x) -> forall x, Sum n x = 0 -> mu * sq x <= q x.
Proof.
  intros G x Z. destruct (sq_ge0 x) as [P|P]; [|rewrite <- P, Rmult_0_r; apply q_ge0].
  set (c := / sqrt (sq x)). assert (Pc : 0 < sqrt (sq x)) by now apply sqrt_lt_R0.
  assert (C : c * c = / sq x) by (unfold c; rewrite <- Rinv_mult, sqrt_sqrt; lra).
  assert (U : unit_normal (fun i => c * x i)).
  { split; [rewrite Sum_scal, Z; ring|]. rewrite (Sum_ext n _ (fun i => c * c * (x i * x i))) by (intros; ring). rewrite Sum_scal, C. field. lra. }
  pose proof (G _ U) as L. rewrite q_scal, C in L. apply (Rmult_le_reg_l (/ sq x)); [now apply Rinv_0_lt_compat|].
  replace (/ sq x * (mu * sq x)) with mu by (field; lra). exact L.
Qed.
Lemma least_eigen mu a : unit_normal a -> q a = mu -> (forall x, unit_normal x -> mu <= q x) -> eigen n adj mu a.
Proof.
  intros [Z U] Qa G. set (y := fun i => Sum n (fun j => lap n adj i j * a j) - mu * a i).
  assert (Zy : Sum n y = 0) by (unfold y; rewrite Sum_minus, Sum_scal, lap_column, Z; ring).
  set (B := sq y). set (K := q y - mu * sq y).
  assert (Main : forall t, 0 <= 2 * t * B + t * t * K).
  { intros t. pose proof (bound_all mu G (fun i => a i + t * y i) ltac:(rewrite Sum_plus, Sum_scal, Z, Zy; ring)) as L. rewrite q_along, Qa in L.
    rewrite (Sum_ext n (fun i => (a i + t * y i) * (a i + t * y i)) (fun i => a i * a i + (2 * t * (y i * a i) + t * t * (y i * y i)))) in L by (intros; ring).
    rewrite !Sum_plus, !Sum_scal, U in L.
    assert (E : B = Sum n (fun i => y i * Sum n (fun j => lap n adj i j * a j)) - mu * Sum n (fun i => y i * a i)).
    { unfold B. rewrite <- Sum_scal, <- Sum_minus. apply Sum_ext. intros i _. unfold y at 2. ring. }
    unfold K. rewrite E. lra. }
  assert (K0 : 0 <= K). { pose proof (bound_all mu G y Zy). unfold K. lra. }
  assert (B0 : B = 0).
  { pose proof (sq_ge0 y) as P. fold B in P. specialize (Main (- B / (K + 1))).
    replace (2 * (- B / (K + 1)) * B + - B / (K + 1) * (- B / (K + 1)) * K) with (- (B * B) * ((K + 2) / ((K + 1) * (K + 1)))) in Main by (field; lra).
    assert (0 < (K + 2) / ((K + 1) * (K + 1))) by (apply Rdiv_lt_0_compat; [lra|apply Rmult_lt_0_compat; lra]). set (k := _ / _) in *.
    assert (X : 0 <= B * B * k) by (apply Rmult_le_pos; [apply Rle_0_sqr|lra]). assert (Y : B * B * k = 0) by lra.
    apply Rmult_integral in Y. destruct Y as [Y|Y]; [now apply Rsqr_0_uniq|lra]. }
  intros i Hi. pose proof (Sum_eq0 n (fun i => y i * y i) (fun j _ => Rle_0_sqr (y j)) B0 i Hi) as E. cbv beta in E. apply Rsqr_0_uniq in E. unfold y in E. lra.
Qed.
End Least.
Lemma varies_centred n x : (1 <= n)%nat -> varies n x -> 0 < Sum n (fun i => (x i - mean n x) * (x i - mean n x)).
Proof.
  intros Hn (i & j & Hi & Hj & N). destruct (Sum_ge0 n (fun i => (x i - mean n x) * (x i - mean n x)) (fun k _ => Rle_0_sqr _)) as [P|E]; [exact P|exfalso].
  assert (Z : forall k, (k < n)%nat -> x k = mean n x).
  { intros k Hk. pose proof (Sum_eq0 n _ (fun k _ => Rle_0_sqr (x k - mean n x)) (eq_sym E) k Hk) as Q. cbv beta in Q. apply Rsqr_0_uniq in Q. lra. }
  apply N. now rewrite (Z i Hi), (Z j Hj).
Qed.
Lemma unit_varies n a : (1 <= n)%nat -> unit_normal n a -> varies n a.
Proof.
  intros Hn [Z U]. apply NNPP. intros N.
  assert (C : forall i, (i < n)%nat -> a i = a 0%nat). { intros i Hi. apply NNPP. intros D. apply N. exists i, 0%nat. repeat split; try lia; exact D. }
  rewrite (Sum_ext n a (fun _ => a 0%nat) C), Sum_const in Z. pose proof (INR_pos n Hn). apply Rmult_integral in Z. destruct Z as [Z|Z]; [lra|].
  rewrite (Sum_zero n) in U; [lra|]. intros i Hi. rewrite (C i Hi), Z. ring.
Qed.
(* the part of an eigenvector that is normal to 1 is one for the same eigenvalue *)
Lemma eigen_centred n adj mu x : (1 <= n)%nat -> undirected adj -> eigen n adj mu x -> eigen n adj mu (fun i => x i - mean n x).
Proof.
  intros Hn S E. assert (Z : mu * Sum n x = 0) by (rewrite <- Sum_scal, <- (lap_column n adj S x); apply Sum_ext; intros; symmetry; now apply E).
  intros i Hi. rewrite (Sum_ext n _ (fun j => lap n adj i j * x j - lap n adj i j * mean n x)) by (intros; ring). rewrite Sum_minus, (E i Hi).
  pose proof (lap_ones n adj (mean n x) i Hi) as O. unfold lmul in O. rewrite O.
  assert (mu * mean n x = 0); [|lra]. unfold mean. replace (mu * (/ INR n * Sum n x)) with (/ INR n * (mu * Sum n x)) by ring. rewrite Z. ring.
Qed.
Lemma qform_eigen n adj mu x : eigen n adj mu x -> qform n (lap n adj) x = mu * Sum n (fun i => x i * x i).
Proof. intros E. unfold qform. rewrite <- Sum_scal. apply Sum_ext. intros i Hi. rewrite (E i Hi). ring. Qed.

(* Courant and Fischer for lambda_2: it exists, and it is the largest lower bound of the form on the vectors normal to 1 *)
Theorem second_exists n adj : (2 <= n)%nat -> undirected adj -> exists lam, second_eigenvalue n adj lam.
Proof.
  intros Hn S. destruct (attained n adj Hn S) as (mu & a & Ua & Qa & G). exists mu. split.
  - exists a. split; [exact (least_eigen n adj S mu a Ua Qa G)|]. apply unit_varies; [lia|exact Ua].
  - intros nu x E V. pose proof (varies_centred n x ltac:(lia) V) as P. pose proof (eigen_centred n adj nu x ltac:(lia) S E) as E'.
    pose proof (bound_all n adj S mu G _ (centred_sum n x ltac:(lia))) as L. rewrite (qform_eigen n adj nu _ E') in L. cbv beta in L. apply (Rmult_le_reg_r _ _ _ P L).
Qed.
Theorem second_variational n adj lam : (2 <= n)%nat -> undirected adj -> second_eigenvalue n adj lam ->
  below_second n adj lam /\ forall mu, below_second n adj mu -> mu <= lam.
Proof.
  intros Hn S [(x & E & V) M]. assert (Hn1 : (1 <= n)%nat) by lia. split.
  - destruct (attained n adj Hn S) as (mu & a & Ua & Qa & G). pose proof (least_eigen n adj S mu a Ua Qa G) as Ea.
    pose proof (M mu a Ea (unit_varies n a Hn1 Ua)) as L.
    intros y Z. pose proof (bound_all n adj S mu G y Z) as B. pose proof (sq_ge0 n y) as P.
    rewrite (Sum_ext n (fun i => y i ^ 2) (fun i => y i * y i)) by (intros; ring). nra.
  - intros mu B. pose proof (varies_centred n x Hn1 V) as P. pose proof (B _ (centred_sum n x Hn1)) as L.
    rewrite (qform_eigen n adj lam _ (eigen_centred n adj lam x Hn1 S E)) in L.
    rewrite (Sum_ext n (fun i => (x i - mean n x) ^ 2) (fun i => (x i - mean n x) * (x i - mean n x))) in L by (intros; ring). apply (Rmult_le_reg_r _ _ _ P L).
Qed.
(* tanner2.cor2_rate, corrected, clause 2: more edges do not lower lambda_2 *)
Theorem second_grows n adj adj' lam mu : (2 <= n)%nat -> undirected adj -> undirected adj' -> (forall i j, adj i j = true -> adj' i j = true) ->
  second_eigenvalue n adj lam -> second_eigenvalue n adj' mu -> lam <= mu.
Proof.
  intros Hn S S' I L M. apply (second_variational n adj' mu Hn S' M). apply (proj2 (more_edges n adj adj' S S' I)), (second_variational n adj lam Hn S L).
Qed.

(* ---- with the rate of W along (4) ---- *)
Section Rates.
Variables (n : nat) (adj : graph) (V V' : nat -> nat -> R -> R) (r v : nat -> R -> C) (t : R).
Hypothesis S : undirected adj.
Hypothesis VS : forall i j, V' i j = V' j i.
Hypothesis HR : forall i, (i < n)%nat -> is_velocity (r i) t (v i t).
Hypothesis HN : forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> r i t <> r j t.
Hypothesis HV : forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> is_derive (V i j) (norm (r i t - r j t)%C) (V' i j (norm (r i t - r j t)%C)).
Hypothesis HU : forall i, (i < n)%nat -> is_velocity (v i) t (control4 n adj V' (fun i => r i t) (fun i => v i t) i).
Notation W := (fun s => Wenergy n adj V (fun i => r i s) (fun i => v i s)).
(* tanner2.S_config, corrected *)
Theorem rest_of_energy : strongly_connected n adj -> is_derive W t 0 ->
  forall i j, (i < n)%nat -> (j < n)%nat -> v i t = v j t /\ is_velocity (fun s => r i s - r j s)%C t (RtoC 0).
Proof.
  intros SC D i j Hi Hj. destruct (eq9 n adj V V' r v t S VS HR HN HV HU) as [E _]. apply is_derive_unique in E. rewrite (is_derive_unique _ _ _ D) in E.
  assert (Q : v i t = v j t).
  { apply (S_config_corrected n adj (fun i => v i t)); try assumption; [lia|]. cbv beta in *. lra. }
  split; [exact Q|]. replace (RtoC 0) with (v i t - v j t)%C by (rewrite Q; ring). apply velocity_minus; now apply HR.
Qed.
(* tanner2.cor2_sub, corrected *)
Theorem energy_below_second (lam : R) (xp xn yp yn : nat -> R) : (2 <= n)%nat -> second_eigenvalue n adj lam ->
  (forall i, (i < n)%nat -> fst (v i t) = xp i + xn i /\ snd (v i t) = yp i + yn i) ->
  (exists c, forall i, (i < n)%nat -> xp i = c) -> (exists c, forall i, (i < n)%nat -> yp i = c) -> Sum n xn = 0 -> Sum n yn = 0 ->
  exists d, is_derive W t d /\ d <= - lam * (Sum n (fun i => xn i ^ 2) + Sum n (fun i => yn i ^ 2)).
Proof.
  intros Hn L Sp Xp Yp Xn Yn. eexists. split; [exact (cor2_decomp n adj V V' r v t xp xn yp yn S VS HR HN HV HU Sp Xp Yp Xn Yn)|].
  destruct (second_variational n adj lam Hn S L) as [B _]. pose proof (B xn Xn). pose proof (B yn Yn). lra.
Qed.
(* tanner2.vdotB, corrected: g is grad_{r_ij} V_ij, the derivative of V_ij(|z|) at z = r_ij *)
Theorem vdot_incidence O : oriented n adj O -> (forall i j, (i < n)%nat -> (j < n)%nat -> v i t = v j t) ->
  exists g : nat * nat -> C,
    (forall i j, In (i, j) O -> forall (z : R -> C) s u, is_velocity z s u -> z s = (r i t - r j t)%C ->
       is_derive (fun x => V i j (norm (z x))) s (inner (g (i, j)) u)) /\
    forall k, (k < n)%nat -> is_velocity (v k) t (applyB O (fun f => fst (g f)) k, applyB O (fun f => snd (g f)) k).
Proof.
  intros HO Eq. exists (fun f => grad (V' (fst f) (snd f)) (r (fst f) t) (r (snd f) t)). split.
  - intros i j I z s u Hz Ez. cbn [fst snd]. destruct HO as (_ & Bd & Mem). destruct (Bd i j I) as [Hi Hj].
    assert (A : adj i j = true).
    { specialize (Mem i j Hi Hj). unfold w in Mem. destruct (adj i j); [reflexivity|exfalso]. unfold member in Mem.
      destruct (in_dec pair_dec (i, j) O) as [_|N]; [|contradiction]. destruct (in_dec pair_dec (j, i) O); lra. }
    assert (N : z s <> RtoC 0). { rewrite Ez. intros Z. apply (HN i j Hi Hj A). replace (r i t) with ((r i t - r j t) + r j t)%C by ring. rewrite Z. ring. }
    eapply D_eq; [apply (D_comp (V i j) (fun x => norm (z x)) s (V' i j (norm (z s)))); [rewrite Ez; now apply HV|apply (D_norm z s u Hz N)]|].
    rewrite Ez. unfold grad. set (y := (r i t - r j t)%C). generalize (norm y) (V' i j (norm y)). intros m d. rewrite !inner_xy. cbn. unfold Rdiv. ring.
  - intros k Hk. destruct (B_gradients n adj O V' (fun i => r i t) k S VS HO Hk) as [B1 B2]. rewrite B1, B2.
    replace (- fst (grad_i n adj V' (fun i => r i t) k), - snd (grad_i n adj V' (fun i => r i t) k)) with (control4 n adj V' (fun i => r i t) (fun i => v i t) k); [now apply HU|].
    unfold control4. rewrite (Csum_ext n _ (fun _ => RtoC 0)) by (intros j Hj; rewrite (Eq k j Hk Hj); ring).
    rewrite Csum_const. apply injective_projections; cbn; ring.
Qed.
End Rates.

(* tanner2.cor2_rate, corrected, clause 1 *)
Theorem second_rate n adj lam (v : nat -> R -> C) : (2 <= n)%nat -> undirected adj -> second_eigenvalue n adj lam ->
  (forall t i, 0 <= t -> (i < n)%nat -> is_velocity (v i) t (- Csum n (fun j => RtoC (w adj i j) * (v i t - v j t)))%C) ->
  forall t, 0 <= t -> deviation n (fun i => v i t) <= exp (- lam * t) * deviation n (fun i => v i 0) /\
    ((forall i, (i < n)%nat -> Csum n (fun j => RtoC (lap n adj i j) * (v j 0%R - centre n (fun k => v k 0%R)))%C = (RtoC lam * (v i 0%R - centre n (fun k => v k 0%R)))%C) ->
     deviation n (fun i => v i t) = exp (- lam * t) * deviation n (fun i => v i 0)).
Proof.
  intros Hn S L M t Ht. assert (Hn1 : (1 <= n)%nat) by lia. pose proof (INR_pos n Hn1) as Pn. split.
  - apply (proj1 (alignment_rate n adj lam v Hn1 S M)); [apply (second_variational n adj lam Hn S L)|exact Ht].
  - intros E. set (m := centre n (fun k => v k 0%R)) in *. set (u := fun (i : nat) (t : R) => (v i t - m)%C).
    assert (Mu : forall t i, 0 <= t -> (i < n)%nat -> is_velocity (u i) t (- Csum n (fun j => RtoC (w adj i j) * (u i t - u j t)))%C).
    { intros x i Hx Hi. destruct (M x i Hx Hi) as [M1 M2].
      replace (- Csum n (fun j => RtoC (w adj i j) * (u i x - u j x)))%C with (- Csum n (fun j => RtoC (w adj i j) * (v i x - v j x)))%C.
      - split.
        + apply (is_derive_ext (fun s => fst (v i s) - fst m)); [reflexivity|]. eapply D_eq; [apply D_minus; [exact M1|apply D_const]|]. ring.
        + apply (is_derive_ext (fun s => snd (v i s) - snd m)); [reflexivity|]. eapply D_eq; [apply D_minus; [exact M2|apply D_const]|]. ring.
      - f_equal. apply Csum_ext. intros j _. unfold u. ring. }
    assert (Dv : forall x, deviation n (fun i => u i x) = deviation n (fun i => v i x)).
    { intros x. unfold deviation. f_equal. apply Sum_ext. intros i _. f_equal. f_equal. unfold centre, u.
      replace (Csum n (fun i => v i x - m)%C) with (Csum n (fun i => v i x) - RtoC (INR n) * m)%C.
      - apply injective_projections; cbn; field; lra.
      - apply injective_projections; cbn; unfold Cminus, Cplus, Copp; cbn; rewrite Sum_plus, Sum_const; ring. }
    rewrite <- !Dv. exact (proj2 (alignment_rate n adj lam u Hn1 S Mu) E t Ht).
Qed.
(* tanner2.L, clause 5: 0 is simple, and every other eigenvalue is positive *)
Theorem others_positive n adj mu x : undirected adj -> strongly_connected n adj -> eigen n adj mu x -> varies n x -> 0 < mu.
Proof.
  intros S SC E V. assert (Hn : (1 <= n)%nat) by (destruct V as (i & _ & Hi & _); lia). pose proof (varies_centred n x Hn V) as P.
  destruct (second_positive n adj Hn S SC) as (lam & Pl & B). pose proof (B _ (centred_sum n x Hn)) as L.
  rewrite (qform_eigen n adj mu _ (eigen_centred n adj mu x Hn S E)) in L.
  rewrite (Sum_ext n (fun i => (x i - mean n x) ^ 2) (fun i => (x i - mean n x) * (x i - mean n x))) in L by (intros; ring).
  apply Rlt_le_trans with lam; [exact Pl|]. apply (Rmult_le_reg_r _ _ _ P L).
Qed.
