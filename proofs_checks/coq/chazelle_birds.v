(* Chazelle, section 3 (Soundness of Hysteresis Rule): the four birds.
     chazelle.ex4birds.eig, ex4birds.eq3.14, ex4birds.alt, and with the hysteresis rule chazelle.hyst,
     chazelle.lem3.6.i.
   x(t) = x(t-1) + v(t),  v(t+1) = P(G_t) v(t).  A pair is joined at t when its distance is at most 1, or (with
   hysteresis) when it was joined at t-1 and the distance changed by less than eps.  The matrix of a network:
   1/3 on the diagonal, 2/3 shared among the neighbours.  Over Q; the rules compute; no axioms. *)
From Coq Require Import QArith Qabs List Arith Lia ZArith Lqa.
Import ListNotations.
Open Scope Q_scope.

Definition birds : list nat := [0;1;2;3]%nat.
Definition vec := nat -> Q.
Definition network := nat -> nat -> bool.

(* the two rules, on positions before (y) and now (x) and on the network before (G) *)
Definition near (x : vec) (i j : nat) : bool := negb (Nat.eqb i j) && Qle_bool (Qabs (x i - x j)) 1.
Definition Qlt_bool (a b : Q) : bool := negb (Qle_bool b a).
Definition kept (eps : Q) (G : network) (y x : vec) (i j : nat) : bool :=
  G i j && Qlt_bool (Qabs (Qabs (x i - x j) - Qabs (y i - y j))) eps.
Definition distance_rule (_ : network) (_ x : vec) : network := near x.
Definition hysteresis (eps : Q) (G : network) (y x : vec) : network := fun i j => near x i j || kept eps G y x i j.

Definition deg (G : network) (i : nat) : nat := length (filter (G i) birds).
Definition P (G : network) (i j : nat) : Q :=
  if Nat.eqb i j then (if Nat.eqb (deg G i) 0 then 1 else 1#3)
  else if G i j then (2#3) / inject_Z (Z.of_nat (deg G i)) else 0.
Definition mulv (A : nat -> nat -> Q) (v : vec) : vec := fun i => fold_right (fun j s => A i j * v j + s) 0 birds.

Definition vec4 (a b c d : Q) : vec :=
  fun i => match i with 0%nat => a | 1%nat => b | 2%nat => c | _ => d end.
Definition x0 : vec := vec4 (0#16) (8#16) (21#16) (29#16).
Definition v1 : vec := vec4 (1#8) (-1#8) (1#8) (-1#8).

(* the state: x(t), G_t, v(t+1) *)
Section Flight.
Variable rule : network -> vec -> vec -> network.
Definition state : Type := vec * network * vec.
Definition fly (s : state) : state :=
  match s with (x, G, v) => let x' := fun i => x i + v i in let G' := rule G x x' in (x', G', mulv (P G') v) end.
Fixpoint flight (t : nat) : state := match t with O => (x0, near x0, v1) | S t => fly (flight t) end.
Definition x (t : nat) : vec := fst (fst (flight t)).
Definition G (t : nat) : network := snd (fst (flight t)).
Definition v (t : nat) : vec := snd (flight (pred t)).          (* for t >= 1 *)

Lemma motion_x t i : x (S t) i = x t i + v (S t) i.
Proof. unfold x, v. cbn [flight pred]. unfold fly. destruct (flight t) as [[? ?] ?]. reflexivity. Qed.
Lemma motion_v t i : v (S (S t)) i = mulv (P (G (S t))) (v (S t)) i.
Proof. unfold G, v. cbn [flight pred]. unfold fly. destruct (flight t) as [[? ?] ?]. reflexivity. Qed.
Lemma motion_G t : G (S t) = rule (G t) (x t) (x (S t)).
Proof. unfold G, x. cbn [flight]. unfold fly. destruct (flight t) as [[? ?] ?]. reflexivity. Qed.
End Flight.

(* ---- the two networks ---- *)
Definition path4 : network := fun i j => Nat.eqb (S i) j || Nat.eqb (S j) i.
Definition pairs4 : network := fun i j =>
  path4 i j && negb (Nat.eqb i 1 && Nat.eqb j 2) && negb (Nat.eqb i 2 && Nat.eqb j 1).
Definition M2 : nat -> nat -> Q := fun i => match i with
  0%nat => vec4 (1#3) (2#3) 0 0 | 1%nat => vec4 (2#3) (1#3) 0 0
| 2%nat => vec4 0 0 (1#3) (2#3) | _ => vec4 0 0 (2#3) (1#3) end.
Definition M4 : nat -> nat -> Q := fun i => match i with
  0%nat => vec4 (1#3) (2#3) 0 0 | 1%nat => vec4 (1#3) (1#3) (1#3) 0
| 2%nat => vec4 0 (1#3) (1#3) (1#3) | _ => vec4 0 0 (2#3) (1#3) end.
Ltac cases4 i H := destruct i as [|[|[|[|i]]]]; [| | | |exfalso; lia].

Lemma P_pairs i j : (i < 4)%nat -> (j < 4)%nat -> P pairs4 i j == M2 i j.
Proof. intros Hi Hj. cases4 i Hi; cases4 j Hj; vm_compute; reflexivity. Qed.
Lemma P_path i j : (i < 4)%nat -> (j < 4)%nat -> P path4 i j == M4 i j.
Proof. intros Hi Hj. cases4 i Hi; cases4 j Hj; vm_compute; reflexivity. Qed.
(* chazelle.ex4birds.eig *)
Theorem eigenvector i : (i < 4)%nat -> mulv M2 v1 i == - (1#3) * v1 i /\ mulv M4 v1 i == - (1#3) * v1 i.
Proof. intros Hi. cases4 i Hi; split; vm_compute; reflexivity. Qed.

(* ---- edges from differences ---- *)
Lemma near_true (y : vec) i j : i <> j -> -1 <= y i - y j -> y i - y j <= 1 -> near y i j = true.
Proof.
  intros Hij H1 H2. unfold near. apply Nat.eqb_neq in Hij. rewrite Hij.
  change (Qle_bool (Qabs (y i - y j)) 1 = true). apply Qle_bool_iff, Qabs_Qle_condition. split; lra.
Qed.
Lemma near_false (y : vec) i j : y i - y j < -1 \/ 1 < y i - y j -> near y i j = false.
Proof.
  intros H. unfold near. destruct (Qle_bool (Qabs (y i - y j)) 1) eqn:E; [|now rewrite andb_false_r].
  apply Qle_bool_iff, Qabs_Qle_condition in E. lra.
Qed.
Lemma near_self (y : vec) i : near y i i = false.
Proof. unfold near. now rewrite Nat.eqb_refl. Qed.
Lemma Qlt_bool_iff a b : Qlt_bool a b = true <-> a < b.
Proof.
  unfold Qlt_bool. destruct (Qle_bool b a) eqn:E.
  - apply Qle_bool_iff in E. split; [discriminate|intros; exfalso; lra].
  - split; [intros _|reflexivity]. apply Qnot_le_lt. intros H. apply Qle_bool_iff in H. congruence.
Qed.
Lemma mulv_P_ext (H K : network) (w : vec) i :
  (i < 4)%nat -> (forall i j, (i < 4)%nat -> (j < 4)%nat -> H i j = K i j) ->
  mulv (P H) w i = mulv (P K) w i.
Proof.
  intros Hi E. assert (D : deg H i = deg K i) by (unfold deg, birds; cbn [filter]; now rewrite !E by lia).
  unfold mulv, birds, P. cbn [fold_right]. rewrite D, !E by lia. reflexivity.
Qed.

(* ---- r(t) = (-1/3)^t ---- *)
Fixpoint r (t : nat) : Q := match t with O => 1 | S t => - (1#3) * r t end.
Lemma r_sign t : if Nat.even t then 0 < r t /\ r t <= 1 else - (1#3) <= r t /\ r t < 0.
Proof.
  induction t as [|t IH]; [cbn; lra|].
  rewrite Nat.even_succ, <- Nat.negb_even. destruct (Nat.even t); cbn [negb r]; lra.
Qed.

Definition shape (t : nat) (x w : vec) : Prop :=
  forall i, (i < 4)%nat -> x i == x0 i + (3#4) * (1 - r t) * v1 i /\ w i == r t * v1 i.
Lemma shape_gaps t x w : shape t x w ->
  x 1%nat - x 0%nat == (5#16) + (3#16) * r t /\ x 2%nat - x 1%nat == 1 - (3#16) * r t /\
  x 3%nat - x 2%nat == (5#16) + (3#16) * r t.
Proof.
  intros H. destruct (H 0%nat ltac:(lia)) as [A _], (H 1%nat ltac:(lia)) as [B _], (H 2%nat ltac:(lia)) as [C _],
    (H 3%nat ltac:(lia)) as [D _]. cbn [x0 v1 vec4] in A, B, C, D. repeat split; lra.
Qed.
Lemma near_of_gaps (y : vec) t :
  y 1%nat - y 0%nat == (5#16) + (3#16) * r t -> y 2%nat - y 1%nat == 1 - (3#16) * r t ->
  y 3%nat - y 2%nat == (5#16) + (3#16) * r t ->
  forall i j, (i < 4)%nat -> (j < 4)%nat -> near y i j = if Nat.even t then path4 i j else pairs4 i j.
Proof.
  intros A B C i j Hi Hj. pose proof (r_sign t) as S.
  destruct (Nat.even t);
  (cases4 i Hi; cases4 j Hj; cbn -[near Qle]; first
    [ apply near_self | apply near_true; [discriminate | lra | lra] | apply near_false; first [left; lra | right; lra] ]).
Qed.
Lemma shape_step t x w H : shape t x w ->
  (forall i j, (i < 4)%nat -> (j < 4)%nat -> H i j = path4 i j) \/
  (forall i j, (i < 4)%nat -> (j < 4)%nat -> H i j = pairs4 i j) ->
  shape (S t) (fun i => x i + w i) (mulv (P H) w).
Proof.
  intros Sh HH i Hi. destruct (Sh i Hi) as [X W]. split; [cbn [r]; rewrite X, W; ring|].
  pose proof (Sh 0%nat ltac:(lia)) as [_ W0]. pose proof (Sh 1%nat ltac:(lia)) as [_ W1].
  pose proof (Sh 2%nat ltac:(lia)) as [_ W2]. pose proof (Sh 3%nat ltac:(lia)) as [_ W3].
  destruct HH as [E|E]; rewrite (mulv_P_ext H _ w i Hi E); unfold mulv, birds; cbn [fold_right];
    rewrite ?P_path, ?P_pairs, W0, W1, W2, W3 by lia; cases4 i Hi; cbn [M2 M4 vec4 r v1]; ring.
Qed.

(* ---- without hysteresis ---- *)
Notation xd := (x distance_rule). Notation vd := (v distance_rule). Notation Gd := (G distance_rule).
Lemma free_shape t : shape t (xd t) (vd (S t)).
Proof.
  induction t as [|t IH]; [intros i Hi; cases4 i Hi; split; vm_compute; reflexivity|].
  assert (E : forall i, xd (S t) i = xd t i + vd (S t) i) by (intros; apply motion_x).
  intros i Hi. rewrite E, motion_v, motion_G. unfold distance_rule at 1.
  assert (Sh : shape (S t) (fun i => xd t i + vd (S t) i) (mulv (P (near (xd (S t)))) (vd (S t)))); [|apply Sh; exact Hi].
  apply shape_step; [exact IH|].
  destruct (shape_gaps t _ _ IH) as (A & B & C).
  assert (V : forall i, (i < 4)%nat -> vd (S t) i == r t * v1 i) by (intros k Hk; apply IH; exact Hk).
  pose proof (V 0%nat ltac:(lia)) as V0. pose proof (V 1%nat ltac:(lia)) as V1. pose proof (V 2%nat ltac:(lia)) as V2.
  pose proof (V 3%nat ltac:(lia)) as V3. cbn [v1 vec4] in V0, V1, V2, V3.
  assert (N : forall i j, (i < 4)%nat -> (j < 4)%nat -> near (xd (S t)) i j = if Nat.even (S t) then path4 i j else pairs4 i j).
  { apply near_of_gaps; rewrite !E; cbn [r]; lra. }
  destruct (Nat.even (S t)); [left|right]; exact N.
Qed.
(* chazelle.ex4birds.eq3.14 *)
Theorem positions t i : (i < 4)%nat -> xd t i == x0 i + (3#4) * (1 - r t) * v1 i.
Proof. intros Hi. now apply free_shape. Qed.
Theorem gaps t : 
  (xd (S t) 1%nat - xd (S t) 0%nat == (1#16) * (5 - r t) /\ xd (S t) 3%nat - xd (S t) 2%nat == (1#16) * (5 - r t)) /\
  xd (S t) 2%nat - xd (S t) 1%nat == 1 + (1#16) * r t /\ (1#4) <= (1#16) * (5 - r t) /\ (1#16) * (5 - r t) <= (1#2).
Proof.
  destruct (shape_gaps _ _ _ (free_shape (S t))) as (A & B & C). cbn [r] in A, B, C. pose proof (r_sign t).
  destruct (Nat.even t); repeat split; lra.
Qed.
(* chazelle.ex4birds.alt: which network it is, at every time; never steady *)
Theorem networks t i j : (i < 4)%nat -> (j < 4)%nat -> Gd t i j = if Nat.even t then path4 i j else pairs4 i j.
Proof.
  assert (E : Gd t = near (xd t)) by (destruct t; [reflexivity|apply motion_G]). rewrite E.
  destruct (shape_gaps _ _ _ (free_shape t)) as (A & B & C). now apply near_of_gaps.
Qed.
Theorem never_steady : ~ exists T, forall t i j, (T <= t)%nat -> (i < 4)%nat -> (j < 4)%nat -> Gd t i j = Gd T i j.
Proof.
  intros [T H]. specialize (H (S T) 1%nat 2%nat ltac:(lia) ltac:(lia) ltac:(lia)).
  rewrite !networks, Nat.even_succ, <- Nat.negb_even in H by lia. now destruct (Nat.even T).
Qed.

(* ---- with hysteresis, eps = 4^(-4^4) ---- *)
Definition eps : Q := / inject_Z (4 ^ 256).
Notation xh := (x (hysteresis eps)). Notation vh := (v (hysteresis eps)). Notation Gh := (G (hysteresis eps)).
(* chazelle.hyst and chazelle.lem3.6.i for this rule, whatever the motion *)
Theorem existing_edge_stays e H y z i j : H i j = true -> Qabs (Qabs (z i - z j) - Qabs (y i - y j)) < e ->
  hysteresis e H y z i j = true.
Proof. intros E L. unfold hysteresis, kept. apply Qlt_bool_iff in L. rewrite E, L. apply orb_true_r. Qed.
Theorem within_distance_joined e H y z i j : i <> j -> Qabs (z i - z j) <= 1 -> hysteresis e H y z i j = true.
Proof.
  intros D L. unfold hysteresis, near. apply Nat.eqb_neq in D. rewrite D.
  apply Qle_bool_iff in L. now rewrite L.
Qed.
Theorem only_these e H y z i j : hysteresis e H y z i j = true ->
  (i <> j /\ Qabs (z i - z j) <= 1) \/ (H i j = true /\ Qabs (Qabs (z i - z j) - Qabs (y i - y j)) < e).
Proof.
  unfold hysteresis, near, kept. intros E. apply orb_true_iff in E as [E|E]; apply andb_true_iff in E as [A B].
  - left. split; [apply Nat.eqb_neq; now apply negb_true_iff|now apply Qle_bool_iff].
  - right. split; [exact A|now apply Qlt_bool_iff].
Qed.

(* the middle edge: at even t by distance; at odd t the change of its length is (1/4)|r(t-1)| = (3/4)|r(t)| *)
Definition middle (t : nat) : bool := Nat.even t || Nat.leb 323 t.
Lemma pow3 n : Qabs (r n) == / inject_Z (3 ^ Z.of_nat n).
Proof.
  induction n as [|n IH]; [reflexivity|]. cbn [r]. rewrite Qabs_Qmult, IH.
  rewrite Nat2Z.inj_succ, Z.pow_succ_r, inject_Z_mult by lia. rewrite Qinv_mult_distr. reflexivity.
Qed.
(* 3^321 < 2^510 < 3^322 *)
Lemma threshold n : Qlt_bool ((1#4) * Qabs (r n)) eps = Nat.leb 322 n.
Proof.
  assert (P3 : forall m, 0 < inject_Z (3 ^ Z.of_nat m)).
  { intros m. change 0 with (inject_Z 0). rewrite <- Zlt_Qlt. apply Z.pow_pos_nonneg; lia. }
  assert (E : (1#4) * Qabs (r n) == / inject_Z (4 * 3 ^ Z.of_nat n)).
  { rewrite pow3, inject_Z_mult, Qinv_mult_distr. reflexivity. }
  assert (K : forall a b, (0 < a)%Z -> (0 < b)%Z -> (/ inject_Z a < / inject_Z b <-> (b < a)%Z)).
  { intros a b A B. rewrite Zlt_Qlt. assert (0 < inject_Z a) by (change 0 with (inject_Z 0); now rewrite <- Zlt_Qlt).
    assert (0 < inject_Z b) by (change 0 with (inject_Z 0); now rewrite <- Zlt_Qlt). symmetry. now apply Qinv_lt_contravar. }
  assert (A4 : (0 < 4 * 3 ^ Z.of_nat n)%Z) by (pose proof (Z.pow_pos_nonneg 3 (Z.of_nat n)); lia).
  assert (L : (1#4) * Qabs (r n) < eps <-> (4 ^ 256 < 4 * 3 ^ Z.of_nat n)%Z).
  { rewrite E. unfold eps. apply K; [exact A4|reflexivity]. }
  destruct (Nat.leb_spec 322 n) as [H|H].
  - apply Qlt_bool_iff, L.
    assert (3 ^ 322 <= 3 ^ Z.of_nat n)%Z by (apply Z.pow_le_mono_r; lia).
    assert (4 ^ 256 < 4 * 3 ^ 322)%Z by reflexivity. lia.
  - destruct (Qlt_bool ((1#4) * Qabs (r n)) eps) eqn:B; [|reflexivity]. apply Qlt_bool_iff, L in B.
    assert (3 ^ Z.of_nat n <= 3 ^ 321)%Z by (apply Z.pow_le_mono_r; lia).
    assert (4 * 3 ^ 321 < 4 ^ 256)%Z by reflexivity. lia.
Qed.

Definition graph (m : bool) : network := if m then path4 else pairs4.
(* one step of the rule: positions of shape t, then t + 1 *)
Lemma rule_step t (x y w : vec) H : shape t x w -> (forall i, (i < 4)%nat -> y i == x i + w i) ->
  (forall i j, (i < 4)%nat -> (j < 4)%nat -> H i j = graph (middle t) i j) ->
  forall i j, (i < 4)%nat -> (j < 4)%nat -> hysteresis eps H x y i j = graph (middle (S t)) i j.
Proof.
  intros Sh Hy HH i j Hi Hj. destruct (shape_gaps t x w Sh) as (A & B & C).
  pose proof (Sh 0%nat ltac:(lia)) as [_ V0]. pose proof (Sh 1%nat ltac:(lia)) as [_ V1].
  pose proof (Sh 2%nat ltac:(lia)) as [_ V2]. pose proof (Sh 3%nat ltac:(lia)) as [_ V3]. cbn [v1 vec4] in V0, V1, V2, V3.
  pose proof (Hy 0%nat ltac:(lia)) as Y0. pose proof (Hy 1%nat ltac:(lia)) as Y1.
  pose proof (Hy 2%nat ltac:(lia)) as Y2. pose proof (Hy 3%nat ltac:(lia)) as Y3.
  assert (N : forall i j, (i < 4)%nat -> (j < 4)%nat -> near y i j = if Nat.even (S t) then path4 i j else pairs4 i j).
  { apply near_of_gaps; rewrite ?Y0, ?Y1, ?Y2, ?Y3; cbn [r]; lra. }
  (* the middle pair: lengths 1 - (3/16) r(t) and 1 + (1/16) r(t) *)
  assert (D : Qabs (Qabs (y 1%nat - y 2%nat) - Qabs (x 1%nat - x 2%nat)) == (1#4) * Qabs (r t)).
  { pose proof (r_sign t) as RS.
    assert (X : Qabs (x 1%nat - x 2%nat) == 1 - (3#16) * r t).
    { rewrite Qabs_neg by (destruct (Nat.even t); lra). lra. }
    assert (Y : Qabs (y 1%nat - y 2%nat) == 1 + (1#16) * r t).
    { rewrite Qabs_neg; rewrite Y1, Y2; [lra | destruct (Nat.even t); lra]. }
    rewrite X, Y. setoid_replace (1 + (1#16) * r t - (1 - (3#16) * r t)) with ((1#4) * r t) by ring.
    rewrite Qabs_Qmult. reflexivity. }
  assert (D' : Qabs (Qabs (y 2%nat - y 1%nat) - Qabs (x 2%nat - x 1%nat)) == (1#4) * Qabs (r t)).
  { rewrite (Qabs_Qminus (y 2%nat)), (Qabs_Qminus (x 2%nat)). exact D. }
  assert (LB : forall a b, a == b -> Qlt_bool a eps = Qlt_bool b eps).
  { intros a b E. unfold Qlt_bool. f_equal. destruct (Qle_bool eps a) eqn:U, (Qle_bool eps b) eqn:W; try reflexivity.
    - apply Qle_bool_iff in U. rewrite E in U. apply Qle_bool_iff in U. congruence.
    - apply Qle_bool_iff in W. rewrite <- E in W. apply Qle_bool_iff in W. congruence. }
  unfold hysteresis. rewrite N by assumption. unfold kept. rewrite HH by assumption.
  unfold middle, graph. rewrite Nat.even_succ, <- Nat.negb_even.
  assert (LE : Nat.leb 323 (S t) = Nat.leb 322 t) by reflexivity.
  cases4 i Hi; cases4 j Hj; rewrite ?(LB _ _ D), ?(LB _ _ D'), ?threshold, LE;
    destruct (Nat.even t), (Nat.leb_spec 322 t), (Nat.leb_spec 323 t); try lia; try reflexivity;
    cbn -[Qlt_bool Qabs]; reflexivity.
Qed.
Lemma held_shape t : shape t (xh t) (vh (S t)) /\
  forall i j, (i < 4)%nat -> (j < 4)%nat -> Gh t i j = graph (middle t) i j.
Proof.
  induction t as [|t [IH IG]].
  - split; [intros i Hi; cases4 i Hi; split; vm_compute; reflexivity|].
    intros i j Hi Hj. cases4 i Hi; cases4 j Hj; vm_compute; reflexivity.
  - assert (E : forall i, xh (S t) i = xh t i + vh (S t) i) by (intros; apply motion_x).
    assert (K : forall i j, (i < 4)%nat -> (j < 4)%nat -> Gh (S t) i j = graph (middle (S t)) i j).
    { intros i j Hi Hj. rewrite motion_G. apply (rule_step t _ _ (vh (S t))); try assumption.
      intros k Hk. now rewrite E. }
    split; [|exact K]. intros i Hi. rewrite E, motion_v.
    assert (Sh : shape (S t) (fun i => xh t i + vh (S t) i) (mulv (P (Gh (S t))) (vh (S t)))); [|apply Sh; exact Hi].
    apply shape_step; [exact IH|]. unfold graph in K. destruct (middle (S t)); [left|right]; exact K.
Qed.
(* with hysteresis: the network switches at every t up to 322, the last time at t = 322, and never again *)
Theorem last_switch :
  (forall t, (t < 322)%nat -> Gh t 1%nat 2%nat <> Gh (S t) 1%nat 2%nat) /\
  (forall t i j, (322 <= t)%nat -> (i < 4)%nat -> (j < 4)%nat -> Gh t i j = path4 i j).
Proof.
  split.
  - intros t Ht. rewrite !(proj2 (held_shape _)) by lia. unfold middle.
    replace (Nat.leb 323 t) with false by (symmetry; apply Nat.leb_gt; lia).
    replace (Nat.leb 323 (S t)) with false by (symmetry; apply Nat.leb_gt; lia).
    rewrite !orb_false_r, Nat.even_succ, <- Nat.negb_even. destruct (Nat.even t); discriminate.
  - intros t i j Ht Hi Hj. rewrite (proj2 (held_shape t)) by assumption. unfold middle.
    destruct (Nat.leb_spec 323 t) as [L|L]; [now rewrite orb_true_r|].
    replace t with 322%nat by lia. reflexivity.
Qed.


(* chazelle.ex4birds.eq3.14 and .alt, whole *)
Theorem eq_3_14 t :
  (forall i, (i < 4)%nat -> xd t i == x0 i + (3#4) * (1 - r t) * v1 i) /\
  (xd (S t) 1%nat - xd (S t) 0%nat == (1#16) * (5 - r t) /\ xd (S t) 3%nat - xd (S t) 2%nat == (1#16) * (5 - r t)) /\
  xd (S t) 2%nat - xd (S t) 1%nat == 1 + (1#16) * r t /\ (1#4) <= (1#16) * (5 - r t) /\ (1#16) * (5 - r t) <= (1#2).
Proof. split; [intros i; apply positions|apply gaps]. Qed.
Theorem alternates :
  (forall t i j, (i < 4)%nat -> (j < 4)%nat -> Gd t i j = if Nat.even t then path4 i j else pairs4 i j) /\
  ~ exists T, forall t i j, (T <= t)%nat -> (i < 4)%nat -> (j < 4)%nat -> Gd t i j = Gd T i j.
Proof. split; [exact networks|exact never_steady]. Qed.
