(* A flock of model D on the line, run over Q by the rule itself, and the same run on integers over one denominator.
   x(t) = x(t-1) + v(t); G_t joins birds at distance at most 1, and keeps an edge of G_(t-1) whose length changes by less
   than the threshold; v_i(t+1) = v_i(t) + c sum over the neighbours of (v_j(t) - v_i(t)), where c depends on the number of
   neighbours. Threshold 0 is no hysteresis. *)
From Coq Require Import ZArith QArith Qabs List Lia Lqa Bool.
From Flockproof Require Import certificate_matrices.
Import ListNotations.
Open Scope Q_scope.

(* x(t), v(t+1) and G_t *)
Record flock := Flock { place : nat -> Q; speed : nat -> Q; edge : nat -> nat -> bool }.
Definition is_near (x : nat -> Q) i j : bool := Qle_bool (Qabs (x i - x j)) 1.
Definition is_held (threshold : Q) (x y : nat -> Q) i j : bool :=
  negb (Qle_bool threshold (Qabs (Qabs (y i - y j) - Qabs (x i - x j)))).
Definition neighbour (e : nat -> nat -> bool) i j : bool := negb (Nat.eqb i j) && e i j.
Definition degree n (e : nat -> nat -> bool) i : nat := length (filter (neighbour e i) (seq 0 n)).
Definition step n (weight : nat -> Q) (threshold : Q) (s : flock) : flock :=
  let y i := place s i + speed s i in
  let e i j := is_near y i j || (edge s i j && is_held threshold (place s) y i j) in
  Flock y (fun i => speed s i + weight (degree n e i) *
                    sumQ n (fun j => if neighbour e i j then speed s j - speed s i else 0)) e.
Definition start (x v : nat -> Q) : flock := Flock x v (is_near x).
Fixpoint run n weight threshold (s : flock) (t : nat) : flock :=
  match t with O => s | S u => step n weight threshold (run n weight threshold s u) end.
(* c_i = 2/(3 d_i) *)
Definition lazy_weight (d : nat) : Q := 2 # (3 * Pos.of_nat d).
Definition vicsek_weight (d : nat) : Q := 1 # Pos.of_nat (d + 1).

(* ---- on integers ---- *)
Record zflock := ZFlock { places : list Z; speeds : list Z; unit : positive; edges : list (list bool) }.
Definition get (l : list Z) i : Z := nth i l 0%Z.
Definition joined (e : list (list bool)) i j : bool := nth j (nth i e []) false.
Definition nearz (x : list Z) (u : positive) i j : bool := Z.leb (Z.abs (get x i - get x j)) (Zpos u).
Definition heldz (threshold : Q) (x y : list Z) (u : positive) i j : bool :=
  Z.ltb (Z.abs (Z.abs (get y i - get y j) - Z.abs (get x i - get x j)) * Zpos (Qden threshold)) (Qnum threshold * Zpos u).
Definition edges_of n (e : nat -> nat -> bool) : list (list bool) := tabulate n (fun i => tabulate n (e i)).
(* Multiplying the unit by m makes every weight an integer: factor d = weight d * m. *)
Definition stepz n (m : positive) (factor : list Z) (threshold : Q) (s : zflock) : zflock :=
  let y := tabulate n (fun i => get (places s) i + get (speeds s) i)%Z in
  (* not orb and andb, which would evaluate all three *)
  let e := edges_of n (fun i j => if nearz y (unit s) i j then true
    else if joined (edges s) i j then heldz threshold (places s) y (unit s) i j else false) in
  ZFlock (tabulate n (fun i => get y i * Zpos m)%Z)
    (tabulate n (fun i => get (speeds s) i * Zpos m + nth (degree n (joined e) i) factor 0 *
       sumZ n (fun j => if neighbour (joined e) i j then get (speeds s) j - get (speeds s) i else 0))%Z)
    (unit s * m)%positive e.
Definition startz n (x v : list Z) (u : positive) : zflock := ZFlock x v u (edges_of n (nearz x u)).

Definition represents n (z : zflock) (s : flock) : Prop :=
  (forall i, (i < n)%nat -> place s i == get (places z) i # unit z) /\
  (forall i, (i < n)%nat -> speed s i == get (speeds z) i # unit z) /\
  (forall i j, (i < n)%nat -> (j < n)%nat -> edge s i j = joined (edges z) i j).

Lemma joined_edges n e i j : (i < n)%nat -> (j < n)%nat -> joined (edges_of n e) i j = e i j.
Proof. intros Hi Hj. unfold joined, edges_of. now rewrite !nth_tabulate. Qed.
Lemma difference a b u : (a # u) - (b # u) == (a - b)%Z # u.
Proof. unfold Qeq, Qminus, Qplus, Qopp; cbn [Qnum Qden]. rewrite Pos2Z.inj_mul. ring. Qed.
Lemma near_val x z u i j : x i == get z i # u -> x j == get z j # u -> is_near x i j = nearz z u i j.
Proof.
  intros Hi Hj. unfold is_near, nearz. apply eq_true_iff_eq. rewrite Qle_bool_iff, Z.leb_le, Hi, Hj, difference.
  unfold Qle, Qabs; cbn [Qnum Qden]. lia.
Qed.
Lemma held_val h x y zx zy u i j : x i == get zx i # u -> x j == get zx j # u -> y i == get zy i # u -> y j == get zy j # u ->
  is_held h x y i j = heldz h zx zy u i j.
Proof.
  intros Xi Xj Yi Yj. unfold is_held, heldz. apply eq_true_iff_eq. rewrite negb_true_iff, Z.ltb_lt.
  rewrite <- not_true_iff_false, Qle_bool_iff, Xi, Xj, Yi, Yj, !difference. cbn [Qabs]. rewrite difference.
  unfold Qle; cbn [Qabs Qnum Qden]. lia.
Qed.
Lemma filter_ext_seq f g n : (forall j, (j < n)%nat -> f j = g j) -> filter f (seq 0 n) = filter g (seq 0 n).
Proof. intros H. apply filter_ext_in. intros j I. apply in_seq in I. apply H. lia. Qed.
Lemma filter_shorter {T} (f : T -> bool) l a : In a l -> f a = false -> (length (filter f l) < length l)%nat.
Proof.
  assert (L : forall l, (length (filter f l) <= length l)%nat).
  { induction l0 as [|b l0 IH]; cbn; [lia|]. destruct (f b); cbn; lia. }
  induction l as [|b l IH]; [easy|]. intros [->|I] F; cbn.
  - rewrite F. specialize (L l). lia.
  - specialize (IH I F). destruct (f b); cbn; lia.
Qed.
Lemma degree_bound n e i : (i < n)%nat -> (degree n e i < n)%nat.
Proof.
  intros Hi. unfold degree. rewrite <- (seq_length n 0) at 2. apply (filter_shorter _ _ i); [apply in_seq; lia|].
  unfold neighbour. now rewrite Nat.eqb_refl.
Qed.

(* Every weight that can occur. *)
Definition factors_fit n (weight : nat -> Q) (m : positive) (factor : list Z) : bool :=
  all n (fun d => Z.eqb (nth d factor 0%Z * Zpos (Qden (weight d))) (Qnum (weight d) * Zpos m)).

Lemma step_val n weight m factor h z s : factors_fit n weight m factor = true -> represents n z s ->
  represents n (stepz n m factor h z) (step n weight h s).
Proof.
  intros W (X & V & E). set (y := tabulate n (fun i => get (places z) i + get (speeds z) i)%Z).
  assert (Y : forall i, (i < n)%nat -> place s i + speed s i == get y i # unit z).
  { intros i Hi. unfold get, y. rewrite nth_tabulate by exact Hi. rewrite (X i Hi), (V i Hi).
    unfold Qeq, Qplus; cbn [Qnum Qden]. rewrite Pos2Z.inj_mul. unfold get. ring. }
  set (ez := fun i j => if nearz y (unit z) i j then true
    else if joined (edges z) i j then heldz h (places z) y (unit z) i j else false).
  set (e := fun i j => is_near (fun i => place s i + speed s i) i j ||
    (edge s i j && is_held h (place s) (fun i => place s i + speed s i) i j)).
  assert (EE : forall i j, (i < n)%nat -> (j < n)%nat -> e i j = joined (edges_of n ez) i j).
  { intros i j Hi Hj. rewrite joined_edges by assumption. unfold e, ez.
    rewrite (near_val _ y (unit z) i j (Y i Hi) (Y j Hj)), (E i j Hi Hj).
    now rewrite (held_val h _ _ (places z) y (unit z) i j (X i Hi) (X j Hj) (Y i Hi) (Y j Hj)). }
  assert (NN : forall i j, (i < n)%nat -> (j < n)%nat -> neighbour e i j = neighbour (joined (edges_of n ez)) i j).
  { intros i j Hi Hj. unfold neighbour. now rewrite EE. }
  assert (DD : forall i, (i < n)%nat -> degree n e i = degree n (joined (edges_of n ez)) i).
  { intros i Hi. unfold degree. f_equal. apply filter_ext_seq. intros j Hj. now apply NN. }
  split; [|split].
  - intros i Hi. unfold step, stepz; cbn [place places unit]. unfold get at 1. rewrite nth_tabulate by exact Hi.
    fold y. rewrite (Y i Hi). unfold Qeq; cbn [Qnum Qden]. rewrite Pos2Z.inj_mul. ring.
  - intros i Hi. unfold step, stepz; cbn [speed speeds unit]. fold y. fold ez. fold e. unfold get at 1.
    rewrite nth_tabulate by exact Hi. rewrite (DD i Hi). set (d := degree n (joined (edges_of n ez)) i).
    assert (F : weight d == nth d factor 0%Z # m).
    { pose proof (all_true _ _ W d) as F. cbv beta in F. assert (d < n)%nat by (unfold d; now apply degree_bound).
      specialize (F H). apply Z.eqb_eq in F. unfold Qeq; cbn [Qnum Qden]. lia. }
    rewrite (sum_ext n _ (fun j => (if neighbour (joined (edges_of n ez)) i j then get (speeds z) j - get (speeds z) i else 0)%Z # unit z)).
    + rewrite sum_val, F, (V i Hi). unfold Qeq, Qplus, Qmult; cbn [Qnum Qden]. rewrite !Pos2Z.inj_mul. ring.
    + intros j Hj. rewrite (NN i j Hi Hj). destruct (neighbour (joined (edges_of n ez)) i j); [|reflexivity].
      rewrite (V i Hi), (V j Hj). apply difference.
  - intros i j Hi Hj. unfold step, stepz; cbn [edge edges]. fold y. fold ez. fold e. now apply EE.
Qed.

(* ---- the certificate: the network at t = 0 and each later one with its first time, edges i < j counted from 0 ---- *)
Definition networks := list (nat * list (nat * nat)).
Definition listed (l : list (nat * nat)) i j : bool := existsb (fun p => Nat.eqb (fst p) i && Nat.eqb (snd p) j) l.
Definition agrees n (e : list (list bool)) (l : list (nat * nat)) : bool :=
  all n (fun i => all n (fun j => negb (Nat.ltb i j) || eqb (joined e i j) (listed l i j))).
(* The network in force: the last one whose time has come. *)
Fixpoint network_at (now : list (nat * nat)) (later : networks) (t : nat) : list (nat * nat) :=
  match later with
  | (time, l) :: rest => if Nat.leb time t then network_at l rest t else now
  | [] => now
  end.
Fixpoint follows n m factor h (s : zflock) (t left : nat) (now : list (nat * nat)) (later : networks) : bool :=
  let '(current, rest) := match later with
    | (time, l) :: rest => if Nat.leb time t then (l, rest) else (now, later)
    | [] => (now, later) end in
  agrees n (edges s) current &&
  match left with O => true | S u => follows n m factor h (stepz n m factor h s) (S t) u current rest end.
Fixpoint increasing (from : nat) (later : networks) : bool :=
  match later with (time, _) :: rest => Nat.ltb from time && increasing time rest | [] => true end.
Definition switches_check n weight m factor h x v u (first : list (nat * nat)) later until : bool :=
  factors_fit n weight m factor && increasing 0 later && follows n m factor h (startz n x v u) 0 until first later.

Lemma network_before now later t : increasing t later = true -> network_at now later t = now.
Proof.
  destruct later as [|(time, l) rest]; [reflexivity|]. cbn. intros H. apply andb_prop in H as [H _].
  apply Nat.ltb_lt in H. destruct (Nat.leb_spec time t); [lia|reflexivity].
Qed.
Lemma increasing_weaken a b later : (a <= b)%nat -> increasing b later = true -> increasing a later = true.
Proof.
  destruct later as [|(time, l) rest]; [reflexivity|]. cbn. intros L H. apply andb_prop in H as [H K].
  apply Nat.ltb_lt in H. rewrite K, andb_true_r. apply Nat.ltb_lt. lia.
Qed.
Lemma follows_true n weight m factor h : factors_fit n weight m factor = true ->
  forall left z s t now later, represents n z s -> (t = 0%nat /\ increasing 0 later = true \/ exists p, t = S p /\ increasing p later = true) ->
  follows n m factor h z t left now later = true ->
  forall k, (k <= left)%nat -> forall i j, (i < n)%nat -> (j < n)%nat -> (i < j)%nat ->
  edge (run n weight h s k) i j = listed (network_at now later (t + k)) i j.
Proof.
  intros W. assert (Shift : forall s k, run n weight h s (S k) = run n weight h (step n weight h s) k).
  { intros s k. induction k as [|k IH]; [reflexivity|]. cbn [run] in *. now rewrite IH. }
  induction left as [|left IH]; intros z s t now later R T F k Hk i j Hi Hj L.
  all: cbn [follows] in F.
  all: set (c := match later with (time, l) :: rest => if Nat.leb time t then (l, rest) else (now, later) | [] => (now, later) end) in F.
  all: assert (C : network_at now later t = fst c /\ increasing t (snd c) = true /\ (forall u, (t <= u)%nat -> network_at now later u = network_at (fst c) (snd c) u)).
  1,3: unfold c; destruct later as [|(time, l) rest]; cbn [network_at];
    [repeat split; reflexivity|]; destruct (Nat.leb_spec time t) as [Q|Q]; cbn [fst snd].
  1,3: destruct T as [[T0 T1]|(p & T0 & T1)]; cbn [increasing] in T1; apply andb_prop in T1 as [T1 T2]; apply Nat.ltb_lt in T1; [lia|];
    assert (time = t) by lia; subst time; split; [now apply network_before|split; [exact T2|]];
    intros u Hu; destruct (Nat.leb_spec t u); [reflexivity|lia].
  1,2: split; [reflexivity|split; [|reflexivity]]; destruct T as [[T0 T1]|(p & T0 & T1)]; cbn [increasing] in *;
    apply andb_prop in T1 as [T1 T2]; rewrite T2, andb_true_r; now apply Nat.ltb_lt.
  all: destruct C as (C1 & C2 & C3); destruct c as [current rest]; cbn [fst snd] in *; apply andb_prop in F as [A F].
  all: assert (Now : edge s i j = listed current i j) by
    (destruct R as (_ & _ & E); rewrite (E i j Hi Hj); pose proof (all_true _ _ (all_true _ _ A i Hi) j Hj) as B; cbv beta in B;
     destruct (Nat.ltb_spec i j); [|lia]; cbn in B; now apply eqb_prop in B).
  - replace k with 0%nat by lia. rewrite Nat.add_0_r, C1. exact Now.
  - destruct k as [|k].
    + rewrite Nat.add_0_r, C1. exact Now.
    + rewrite Shift, C3 by lia. replace (t + S k)%nat with (S t + k)%nat by lia.
      apply (IH (stepz n m factor h z)); try assumption; [now apply step_val|right; now exists t|lia].
Qed.

Theorem switches_certificate n weight m factor h x v u first later until :
  switches_check n weight m factor h x v u first later until = true ->
  forall t, (t <= until)%nat -> forall i j, (i < j < n)%nat ->
  edge (run n weight h (start (fun i => get x i # u) (fun i => get v i # u)) t) i j = listed (network_at first later t) i j.
Proof.
  unfold switches_check. intros H t Ht i j [Hij Hj]. apply andb_prop in H as [H F]. apply andb_prop in H as [W I].
  apply (follows_true n weight m factor h W until (startz n x v u) _ 0 first later); try assumption; try lia.
  - unfold startz, start. split; [|split]; cbn [place speed edge places speeds unit edges]; try reflexivity. intros a b Ha Hb. rewrite joined_edges by assumption.
    apply near_val; reflexivity.
  - left. now split.
Qed.
