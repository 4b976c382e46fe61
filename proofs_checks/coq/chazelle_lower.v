(* Chazelle, the lower bound: groups of four birds on the line, each starting as two pairs that fly towards each other with the speed n^-c.
   Before ceil(n^c/3) the network is made of the pairs, from then on of paths of four; with and without hysteresis.
     beyond.chazelle.lower_bound, chazelle.lower_bound (corrected), chazelle.lower_paths. *)
From Coq Require Import Reals Lra Lia Psatz Bool.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums.
Open Scope R_scope.

(* model D on the line for n birds: x t from t = 0 on, v t from t = 1 on, networks with the hysteresis threshold eps (none for eps <= 0);
   a bird that has neighbours gives the weight 1/3 to itself and equal weights to them *)
Definition joined (G : nat -> nat -> bool) n i := Sum n (fun j => if G i j then 1 else 0).
Definition heard (G : nat -> nat -> bool) n (v : nat -> R) i := Sum n (fun j => if G i j then v j else 0).
Definition flock_line n (eps : R) (x v : nat -> nat -> R) (G : nat -> nat -> nat -> bool) :=
  (forall i j, (i < n)%nat -> (j < n)%nat -> (G 0%nat i j = true <-> i <> j /\ Rabs (x 0%nat i - x 0%nat j) <= 1)) /\
  (forall t i j, (i < n)%nat -> (j < n)%nat -> (G (S t) i j = true <-> i <> j /\ (Rabs (x (S t) i - x (S t) j) <= 1 \/
    (G t i j = true /\ Rabs (Rabs (x (S t) i - x (S t) j) - Rabs (x t i - x t j)) < eps)))) /\
  (forall t i, (i < n)%nat -> x (S t) i = x t i + v (S t) i) /\
  (forall t i, (1 <= t)%nat -> (i < n)%nat -> joined (G t) n i = 0 -> v (S t) i = v t i) /\
  (forall t i, (1 <= t)%nat -> (i < n)%nat -> joined (G t) n i <> 0 -> v (S t) i = v t i / 3 + 2 / (3 * joined (G t) n i) * heard (G t) n (v t) i).
(* the start: 0, 2/3, 2, 8/3, 4, ..; velocities u, 0, -u, 0, u, .. *)
Definition place0 (i : nat) : R := INR (2 * (i / 2)) + (if Nat.even i then 0 else 2 / 3).
Definition speed0 (u : R) (i : nat) : R := if Nat.even i then (if Nat.even (i / 2) then u else - u) else 0.
(* neighbours in the row that are in one pair, or in one group of four *)
Definition row_net (four : bool) (i j : nat) : bool := Nat.eqb (i / 4) (j / 4) && (Nat.eqb (S i) j || Nat.eqb (S j) i) && (four || Nat.eqb (i / 2) (j / 2)).

Lemma row_net_group b g k l : (k < 4)%nat -> (l < 4)%nat -> row_net b (4 * g + k) (4 * g + l) = row_net b k l.
Proof.
  intros Hk Hl. unfold row_net. rewrite !(Nat.mul_comm 4 g), !Nat.div_add_l, !Nat.div_small, !Nat.add_0_r by lia.
  replace ((g * 4 + k) / 2)%nat with (g * 2 + k / 2)%nat by (replace (g * 4 + k)%nat with ((g * 2) * 2 + k)%nat by lia; now rewrite Nat.div_add_l by lia).
  replace ((g * 4 + l) / 2)%nat with (g * 2 + l / 2)%nat by (replace (g * 4 + l)%nat with ((g * 2) * 2 + l)%nat by lia; now rewrite Nat.div_add_l by lia).
  assert (E : forall a b c, Nat.eqb (c + a) (c + b) = Nat.eqb a b) by (intros x y c; destruct (Nat.eqb_spec x y), (Nat.eqb_spec (c + x) (c + y)); lia).
  rewrite Nat.eqb_refl, (E (k / 2)%nat). replace (S (g * 4 + k)) with (g * 4 + S k)%nat by lia. replace (S (g * 4 + l)) with (g * 4 + S l)%nat by lia. now rewrite !E.
Qed.
Lemma row_net_apart b g h k l : (k < 4)%nat -> (l < 4)%nat -> g <> h -> row_net b (4 * g + k) (4 * h + l) = false.
Proof.
  intros Hk Hl N. unfold row_net. rewrite !(Nat.mul_comm 4), !Nat.div_add_l, !Nat.div_small, !Nat.add_0_r by lia. now destruct (Nat.eqb_spec g h).
Qed.
Lemma group_of i m : (i < 4 * m)%nat -> exists g k, (g < m)%nat /\ (k < 4)%nat /\ i = (4 * g + k)%nat.
Proof.
  intros H. exists (i / 4)%nat, (i mod 4)%nat. pose proof (Nat.div_mod i 4 ltac:(lia)). pose proof (Nat.mod_upper_bound i 4 ltac:(lia)).
  split; [apply Nat.div_lt_upper_bound; lia|]. split; assumption.
Qed.
Lemma Sum_groups m f : Sum (4 * m) f = Sum m (fun g => f (4 * g)%nat + f (4 * g + 1)%nat + f (4 * g + 2)%nat + f (4 * g + 3)%nat).
Proof.
  induction m as [|m IH]; [reflexivity|]. replace (4 * S m)%nat with (S (S (S (S (4 * m))))) by lia. cbn [Sum]. rewrite IH.
  replace (4 * m + 1)%nat with (S (4 * m)) by lia. replace (4 * m + 2)%nat with (S (S (4 * m))) by lia. replace (4 * m + 3)%nat with (S (S (S (4 * m)))) by lia. ring.
Qed.
Lemma Sum_net b m g k f : (g < m)%nat -> (k < 4)%nat -> Sum (4 * m) (fun j => if row_net b (4 * g + k) j then f j else 0) =
  (if row_net b k 0 then f (4 * g)%nat else 0) + (if row_net b k 1 then f (4 * g + 1)%nat else 0) + (if row_net b k 2 then f (4 * g + 2)%nat else 0) + (if row_net b k 3 then f (4 * g + 3)%nat else 0).
Proof.
  intros Hg Hk. rewrite Sum_groups.
  transitivity (Sum m (fun h => delta h g * ((if row_net b k 0 then f (4 * h)%nat else 0) + (if row_net b k 1 then f (4 * h + 1)%nat else 0) + (if row_net b k 2 then f (4 * h + 2)%nat else 0) + (if row_net b k 3 then f (4 * h + 3)%nat else 0)))).
  - apply Sum_ext. intros h Hh. unfold delta. destruct (Nat.eqb_spec h g) as [->|N].
    + rewrite <- (row_net_group b g k 0), <- (row_net_group b g k 1), <- (row_net_group b g k 2), <- (row_net_group b g k 3) by lia. rewrite Nat.add_0_r. ring.
    + replace (4 * h)%nat with (4 * h + 0)%nat by lia. replace (4 * h + 0 + 1)%nat with (4 * h + 1)%nat by lia. replace (4 * h + 0 + 2)%nat with (4 * h + 2)%nat by lia. replace (4 * h + 0 + 3)%nat with (4 * h + 3)%nat by lia.
      rewrite !row_net_apart by (try lia; congruence). ring.
  - apply (Sum_delta m g (fun h => (if row_net b k 0 then f (4 * h)%nat else 0) + (if row_net b k 1 then f (4 * h + 1)%nat else 0) + (if row_net b k 2 then f (4 * h + 2)%nat else 0) + (if row_net b k 3 then f (4 * h + 3)%nat else 0)) Hg).
Qed.
(* who is near whom, from the three gaps of a group *)
Lemma near_is m (x : nat -> R) (b : bool) : (forall g k, (g < m)%nat -> (k < 4)%nat -> x (4 * g + k)%nat = 4 * INR g + x k) ->
  0 < x 1%nat - x 0%nat <= 1 -> 0 < x 3%nat - x 2%nat <= 1 -> 0 < x 2%nat - x 1%nat -> 1 < x 2%nat - x 0%nat -> 1 < x 3%nat - x 1%nat -> x 3%nat - x 0%nat < 3 ->
  (if b then x 2%nat - x 1%nat <= 1 else 1 < x 2%nat - x 1%nat) ->
  forall i j, (i < 4 * m)%nat -> (j < 4 * m)%nat -> (i <> j /\ Rabs (x i - x j) <= 1 <-> row_net b i j = true).
Proof.
  intros X A C B AB BC ABC Hb i j Hi Hj. destruct (group_of i m Hi) as (g & k & Hg & Hk & ->). destruct (group_of j m Hj) as (h & l & Hh & Hl & ->). rewrite !X by assumption.
  destruct (Nat.eq_dec g h) as [->|N].
  - rewrite row_net_group by assumption. replace (4 * INR h + x k - (4 * INR h + x l)) with (x k - x l) by ring.
    assert (Q : forall s, s <= 1 -> - 1 <= s -> Rabs s <= 1) by (intros; apply Rabs_le; lra).
    assert (P : forall s, Rabs s <= 1 -> - 1 <= s <= 1) by (intros s Hs; now apply Rabs_le_between in Hs).
    destruct k as [|[|[|[|k]]]]; [| | | |lia]; (destruct l as [|[|[|[|l]]]]; [| | | |lia]); cbn [row_net]; unfold row_net; cbn; destruct b; cbn; split; intros H; try reflexivity; try discriminate;
      try (exfalso; destruct H as [H1 H2]; try lia; apply P in H2; lra); split; try lia; apply Q; lra.
  - rewrite row_net_apart by assumption. split; [|discriminate]. intros [_ H]. exfalso. apply Rabs_le_between in H.
    assert (D : forall a c, (a < 4)%nat -> (c < 4)%nat -> - 3 < x a - x c < 3).
    { intros a c Ha Hc. destruct a as [|[|[|[|a]]]]; [| | | |lia]; (destruct c as [|[|[|[|c]]]]; [| | | |lia]); lra. }
    specialize (D k l Hk Hl). destruct (Nat.lt_total g h) as [L|[L|L]]; [|lia|]; apply (le_INR (S _)) in L; rewrite S_INR in L; lra.
Qed.
Definition step (b : bool) (w : nat -> R) (k : nat) : R := match k with
  | 0%nat => w 0%nat / 3 + 2 / 3 * w 1%nat
  | 1%nat => if b then w 1%nat / 3 + (w 0%nat + w 2%nat) / 3 else w 1%nat / 3 + 2 / 3 * w 0%nat
  | 2%nat => if b then w 2%nat / 3 + (w 1%nat + w 3%nat) / 3 else w 2%nat / 3 + 2 / 3 * w 3%nat
  | _ => w 3%nat / 3 + 2 / 3 * w 2%nat end.
Lemma minus_third_pow t : - / 3 <= (- / 3) ^ t <= 1.
Proof. induction t as [|t IH]; cbn [pow]; lra. Qed.
Lemma two_thirds_pow t : 0 < (2 / 3) ^ t <= 1 /\ 1 - (- / 3) ^ t <= 16 * (1 - (2 / 3) ^ t).
Proof.
  assert (A : forall t, 0 < (2 / 3) ^ t <= 1) by (induction t0 as [|t0 IH]; cbn [pow]; lra). split; [apply A|].
  destruct t as [|t]; [cbn; lra|]. pose proof (A t). pose proof (minus_third_pow (S t)). cbn [pow] in *. lra.
Qed.
Definition pos4 (k : nat) : R := match k with 0%nat => 0 | 1%nat => 2 / 3 | 2%nat => 2 | _ => 8 / 3 end.
Definition vel4 (u : R) (k : nat) : R := match k with 0%nat => u | 2%nat => - u | _ => 0 end.
Section Lower.
Variables (m : nat) (u eps : R) (x v : nat -> nat -> R) (G : nat -> nat -> nat -> bool) (T : nat).
Notation n := (4 * m)%nat.
Hypothesis Hm : (1 <= m)%nat.
Hypothesis Hu : 0 < u <= / 8.
Hypothesis F : flock_line n eps x v G.
Hypothesis X0 : forall i, (i < n)%nat -> x 0%nat i = place0 i.
Hypothesis V1 : forall i, (i < n)%nat -> v 1%nat i = speed0 u i.
Hypothesis HT : / 3 <= INR T * u.
Hypothesis HT' : forall t, (t < T)%nat -> INR t * u < / 3.
Notation net b t := (forall i j, (i < n)%nat -> (j < n)%nat -> G t i j = row_net b i j).
Definition grouped (w : nat -> R) (d : R) := forall g k, (g < m)%nat -> (k < 4)%nat -> w (4 * g + k)%nat = d * INR g + w k.
Lemma first_group k : (k < 4)%nat -> (k < n)%nat.
Proof. lia. Qed.
Lemma velocity_step b t : (1 <= t)%nat -> net b t -> grouped (v t) 0 -> grouped (v (S t)) 0 /\ forall k, (k < 4)%nat -> v (S t) k = step b (v t) k.
Proof.
  intros Ht N Gv. destruct F as (_ & _ & _ & _ & Fv).
  assert (K : forall g k, (g < m)%nat -> (k < 4)%nat -> v (S t) (4 * g + k)%nat = step b (v t) k).
  { intros g k Hg Hk. assert (Hi : (4 * g + k < n)%nat) by lia.
    assert (J : forall f, Sum n (fun j => if G t (4 * g + k)%nat j then f j else 0) = Sum n (fun j => if row_net b (4 * g + k) j then f j else 0)).
    { intros f. apply Sum_ext. intros j Hj. now rewrite N. }
    pose proof (J (fun _ => 1)) as J1. pose proof (J (v t)) as J2. rewrite Sum_net in J1, J2 by assumption. fold (joined (G t) n (4 * g + k)) in J1. fold (heard (G t) n (v t) (4 * g + k)) in J2.
    replace (v t (4 * g)%nat) with (v t (4 * g + 0)%nat) in J2 by (f_equal; lia).
    rewrite !Gv in J2 by lia. rewrite !Rmult_0_l, !Rplus_0_l in J2.
    assert (Nz : joined (G t) n (4 * g + k) <> 0).
    { rewrite J1. destruct k as [|[|[|[|k]]]]; [| | | |lia]; destruct b; cbn; lra. }
    rewrite (Fv t _ Ht Hi Nz), J1, J2, (Gv g k Hg Hk). destruct k as [|[|[|[|k]]]]; [| | | |lia]; destruct b; cbn; field. }
  split.
  - intros g k Hg Hk. rewrite (K g k Hg Hk). rewrite <- (K 0%nat k ltac:(lia) Hk). cbn. ring.
  - intros k Hk. rewrite <- (K 0%nat k ltac:(lia) Hk). reflexivity.
Qed.
Lemma position_step t : grouped (x t) 4 -> grouped (v (S t)) 0 -> grouped (x (S t)) 4 /\ forall k, (k < 4)%nat -> x (S t) k = x t k + v (S t) k.
Proof.
  intros Gx Gv. destruct F as (_ & _ & Fx & _). split; [|intros; apply Fx; lia]. intros g k Hg Hk. rewrite !Fx by lia. rewrite (Gx g k Hg Hk), (Gv g k Hg Hk). ring.
Qed.
Lemma net_step b0 b t : net b0 t -> (b0 = true -> b = true) -> (forall i j, (i < n)%nat -> (j < n)%nat -> (i <> j /\ Rabs (x (S t) i - x (S t) j) <= 1 <-> row_net b i j = true)) -> net b (S t).
Proof.
  intros N B H i j Hi Hj. destruct F as (_ & FG & _). specialize (FG t i j Hi Hj). specialize (H i j Hi Hj).
  destruct (row_net b i j) eqn:E.
  - apply FG. destruct H as [_ H]. destruct (H eq_refl). tauto.
  - destruct (G (S t) i j) eqn:E2; [|reflexivity]. destruct FG as [FG _]. destruct (FG eq_refl) as [Ne [Q|[Q _]]].
    + destruct H as [H _]. symmetry. apply H. now split.
    + exfalso. rewrite N in Q by assumption. assert (row_net b i j = true); [|congruence]. unfold row_net in *. destruct b0; [rewrite (B eq_refl); exact Q|].
      apply andb_true_iff in Q. destruct Q as [Q1 Q2]. rewrite Q1. cbn in *. rewrite Q2. now destruct b.
Qed.
(* until the contact *)
Definition before_x t := grouped (x t) 4 /\ x t 1%nat - x t 0%nat = 2 / 3 - u * (3 / 4) * (1 - (- / 3) ^ t) /\ x t 2%nat - x t 1%nat = 4 / 3 - INR t * u /\
  x t 3%nat - x t 2%nat = 2 / 3 + u * (3 / 4) * (1 - (- / 3) ^ t).
Definition before_v t := grouped (v (S t)) 0 /\ v (S t) 0%nat = u / 2 * (1 + (- / 3) ^ t) /\ v (S t) 1%nat = u / 2 * (1 - (- / 3) ^ t) /\
  v (S t) 2%nat = u / 2 * (- 1 - (- / 3) ^ t) /\ v (S t) 3%nat = u / 2 * (- 1 + (- / 3) ^ t).
Lemma T_pos : (1 <= T)%nat.
Proof. destruct T as [|t]; [cbn in HT; lra|lia]. Qed.
Lemma start_x : before_x 0.
Proof.
  assert (E : forall g k, (g < m)%nat -> (k < 4)%nat -> x 0%nat (4 * g + k)%nat = 4 * INR g + pos4 k).
  { intros g k Hg Hk. rewrite X0 by lia. unfold place0. replace ((4 * g + k) / 2)%nat with (2 * g + k / 2)%nat by (replace (4 * g + k)%nat with ((2 * g) * 2 + k)%nat by lia; now rewrite Nat.div_add_l by lia).
    replace (4 * g + k)%nat with (2 * (2 * g) + k)%nat by lia. rewrite Nat.even_add, Nat.even_mul. cbn [Nat.even orb]. rewrite mult_INR, plus_INR, mult_INR.
    destruct k as [|[|[|[|k]]]]; [| | | |lia]; cbn; field. }
  assert (E0 : forall k, (k < 4)%nat -> x 0%nat k = pos4 k).
  { intros k Hk. pose proof (E 0%nat k ltac:(lia) Hk) as Q. cbn [Nat.mul Nat.add INR] in Q. rewrite Q. ring. }
  split; [intros g k Hg Hk; rewrite (E g k Hg Hk), (E0 k Hk); reflexivity|]. rewrite !E0 by lia. cbn. lra.
Qed.
Lemma start_v : before_v 0.
Proof.
  assert (E : forall g k, (g < m)%nat -> (k < 4)%nat -> v 1%nat (4 * g + k)%nat = vel4 u k).
  { intros g k Hg Hk. rewrite V1 by lia. unfold speed0. replace ((4 * g + k) / 2)%nat with (2 * g + k / 2)%nat by (replace (4 * g + k)%nat with ((2 * g) * 2 + k)%nat by lia; now rewrite Nat.div_add_l by lia).
    replace (4 * g + k)%nat with (2 * (2 * g) + k)%nat by lia. rewrite !Nat.even_add, !Nat.even_mul. cbn [Nat.even orb]. destruct k as [|[|[|[|k]]]]; [| | | |lia]; reflexivity. }
  split; [intros g k Hg Hk; rewrite (E g k Hg Hk); pose proof (E 0%nat k ltac:(lia) Hk) as Q; cbn [Nat.mul Nat.add] in Q; rewrite Q; ring|].
  pose proof (E 0%nat 0%nat ltac:(lia) ltac:(lia)) as Q0. pose proof (E 0%nat 1%nat ltac:(lia) ltac:(lia)) as Q1. pose proof (E 0%nat 2%nat ltac:(lia) ltac:(lia)) as Q2. pose proof (E 0%nat 3%nat ltac:(lia) ltac:(lia)) as Q3.
  cbn [Nat.mul Nat.add] in *. rewrite Q0, Q1, Q2, Q3. cbn. lra.
Qed.
Lemma before_near t : (t < T)%nat -> before_x t -> forall i j, (i < n)%nat -> (j < n)%nat -> (i <> j /\ Rabs (x t i - x t j) <= 1 <-> row_net false i j = true).
Proof.
  intros Ht (Gx & A & B & C). pose proof (minus_third_pow t) as P. pose proof (HT' t Ht) as U. pose proof (pos_INR t) as Pt.
  assert (0 <= INR t * u) by (apply Rmult_le_pos; lra). assert (0 <= u * (3 / 4) * (1 - (- / 3) ^ t) <= u) by nra.
  apply (near_is m (x t) false Gx); lra.
Qed.
Lemma first_net : net false 0%nat.
Proof.
  intros i j Hi Hj. destruct F as (F0 & _). specialize (F0 i j Hi Hj). pose proof (before_near 0 T_pos start_x i j Hi Hj) as H.
  destruct (row_net false i j), (G 0%nat i j); try reflexivity; [apply F0, H; reflexivity|exfalso; assert (false = true) by (apply H, F0; reflexivity); discriminate].
Qed.
Lemma before t : (t < T)%nat -> before_x t /\ before_v t /\ net false t.
Proof.
  induction t as [|t IH]; intros Ht; [split; [exact start_x|split; [exact start_v|exact first_net]]|]. destruct (IH ltac:(lia)) as ((Gx & A & B & C) & (Gv & W0 & W1 & W2 & W3) & N).
  destruct (position_step t Gx Gv) as [Gx' Ex].
  assert (BX : before_x (S t)).
  { split; [exact Gx'|]. rewrite !Ex by lia. rewrite W0, W1, W2, W3, S_INR. cbn [pow]. set (r := (- / 3) ^ t) in *. lra. }
  assert (N' : net false (S t)) by (apply (net_step false false t N (fun e => e)); now apply before_near).
  split; [exact BX|]. split; [|exact N']. destruct (velocity_step false (S t) ltac:(lia) N' Gv) as [Gv' Ev]. split; [exact Gv'|]. rewrite !Ev by lia. cbn [step]. rewrite W0, W1, W2, W3. cbn [pow].
  set (r := (- / 3) ^ t) in *. lra.
Qed.
(* at the contact and after it *)
Notation last := (T - 1)%nat.
Definition after_x s := grouped (x (T + s)%nat) 4 /\
  x (T + s)%nat 1%nat - x (T + s)%nat 0%nat = 2 / 3 - u * (3 / 4) * (1 - (- / 3) ^ T) - u * (2 / 3 * (1 - (2 / 3) ^ s) + (1 - (- / 3) ^ s) / 12) /\
  x (T + s)%nat 2%nat - x (T + s)%nat 1%nat = 4 / 3 - INR T * u - u * (4 / 3 * (1 - (2 / 3) ^ s) - (1 - (- / 3) ^ s) / 12) /\
  x (T + s)%nat 3%nat - x (T + s)%nat 2%nat = 2 / 3 + u * (3 / 4) * (1 - (- / 3) ^ T) - u * (2 / 3 * (1 - (2 / 3) ^ s) + (1 - (- / 3) ^ s) / 12).
(* velocities from the contact on: v(T + s + 1) *)
Definition after_v s := grouped (v (S (T + s))) 0 /\
  v (S (T + s)) 0%nat = u / 2 * (4 / 3 * (2 / 3) ^ S s - (- / 3) ^ S s / 3 - (- / 3) ^ last / 3) /\
  v (S (T + s)) 1%nat = u / 2 * (2 / 3 * (2 / 3) ^ S s + (- / 3) ^ S s / 3 - (- / 3) ^ last / 3) /\
  v (S (T + s)) 2%nat = u / 2 * (- (2 / 3) * (2 / 3) ^ S s - (- / 3) ^ S s / 3 - (- / 3) ^ last / 3) /\
  v (S (T + s)) 3%nat = u / 2 * (- (4 / 3) * (2 / 3) ^ S s + (- / 3) ^ S s / 3 - (- / 3) ^ last / 3).
Lemma after_near s : after_x s -> forall i j, (i < n)%nat -> (j < n)%nat -> (i <> j /\ Rabs (x (T + s)%nat i - x (T + s)%nat j) <= 1 <-> row_net true i j = true).
Proof.
  intros (Gx & A & B & C). pose proof (minus_third_pow T) as P. pose proof (minus_third_pow s) as P2. destruct (two_thirds_pow s) as [P3 P4]. pose proof T_pos as Tp.
  assert (U : INR T * u < / 3 + u). { replace T with (S last) by lia. rewrite S_INR. pose proof (HT' last ltac:(lia)). lra. }
  assert (D1 : 0 <= u * (3 / 4) * (1 - (- / 3) ^ T) <= u) by nra.
  set (b1 := 2 / 3 * (1 - (2 / 3) ^ s) + (1 - (- / 3) ^ s) / 12) in *. set (b2 := 4 / 3 * (1 - (2 / 3) ^ s) - (1 - (- / 3) ^ s) / 12) in *.
  assert (B1 : 0 <= b1 <= 7 / 9) by (unfold b1; lra). assert (B2 : 0 <= b2 <= 4 / 3) by (unfold b2; lra).
  assert (D2 : 0 <= u * b1 <= u * (7 / 9)) by (split; [apply Rmult_le_pos; lra|apply Rmult_le_compat_l; lra]).
  assert (D3 : 0 <= u * b2 <= u * (4 / 3)) by (split; [apply Rmult_le_pos; lra|apply Rmult_le_compat_l; lra]).
  apply (near_is m (x (T + s)%nat) true Gx); lra.
Qed.
Lemma contact : after_x 0 /\ net true (T + 0)%nat /\ after_v 0.
Proof.
  pose proof T_pos as Tp. destruct (before last ltac:(lia)) as ((Gx & A & B & C) & (Gv & W0 & W1 & W2 & W3) & N). replace (S last) with T in * by lia.
  assert (ST : S last = T) by lia. destruct (position_step last Gx) as [Gx' Ex]; [rewrite ST; exact Gv|]. rewrite ST in *.
  assert (PT : (- / 3) ^ T = - / 3 * (- / 3) ^ last) by (rewrite <- ST at 1; reflexivity). assert (IT : INR T = INR last + 1) by (rewrite <- ST at 1; apply S_INR).
  assert (BX : after_x 0).
  { unfold after_x. rewrite Nat.add_0_r. split; [exact Gx'|]. rewrite !Ex by lia. rewrite W0, W1, W2, W3, PT, IT. cbn [pow]. set (r := (- / 3) ^ last) in *. lra. }
  assert (N' : net true (T + 0)%nat).
  { pose proof (after_near 0 BX) as H. rewrite Nat.add_0_r in *. rewrite <- ST. apply (net_step false true last N); [reflexivity|]. rewrite ST. exact H. }
  split; [exact BX|]. split; [exact N'|]. unfold after_v. rewrite Nat.add_0_r in *. destruct (velocity_step true T Tp N' Gv) as [Gv' Ev]. split; [exact Gv'|].
  rewrite !Ev by lia. cbn [step]. rewrite W0, W1, W2, W3. cbn [pow]. set (r := (- / 3) ^ last) in *. lra.
Qed.
Lemma after s : after_x s /\ net true (T + s)%nat /\ after_v s.
Proof.
  induction s as [|s ((Gx & A & B & C) & N & (Gv & W0 & W1 & W2 & W3))]; [exact contact|]. destruct (position_step (T + s) Gx Gv) as [Gx' Ex]. rewrite <- Nat.add_succ_r in *.
  assert (BX : after_x (S s)).
  { split; [exact Gx'|]. rewrite !Ex by lia. rewrite W0, W1, W2, W3. cbn [pow]. set (p := (2 / 3) ^ s) in *. set (q := (- / 3) ^ s) in *. lra. }
  assert (N' : net true (T + S s)%nat).
  { pose proof (after_near (S s) BX) as H. rewrite Nat.add_succ_r in *. apply (net_step true true (T + s) N (fun e => e)). exact H. }
  split; [exact BX|]. split; [exact N'|]. destruct (velocity_step true (T + S s) ltac:(lia) N' Gv) as [Gv' Ev]. split; [exact Gv'|]. rewrite !Ev by lia. cbn [step]. rewrite W0, W1, W2, W3. cbn [pow].
  set (p := (2 / 3) ^ s) in *. set (q := (- / 3) ^ s) in *. lra.
Qed.
Lemma networks : (forall t, (t < T)%nat -> net false t) /\ forall t, (T <= t)%nat -> net true t.
Proof. split; [intros t Ht; now apply before|]. intros t Ht. replace t with (T + (t - T))%nat by lia. apply after. Qed.
End Lower.
(* n = 4m, speed n^-c <= 1/8 for any real c, T = ceil(n^c / 3): pairs before T, paths of four from T on; so the network changes at T and at no other time *)
Theorem lower_bound m c eps (x v : nat -> nat -> R) (G : nat -> nat -> nat -> bool) T : (1 <= m)%nat -> 8 <= Rpower (INR (4 * m)) c -> flock_line (4 * m) eps x v G ->
  (forall i, (i < 4 * m)%nat -> x 0%nat i = place0 i) -> (forall i, (i < 4 * m)%nat -> v 1%nat i = speed0 (Rpower (INR (4 * m)) (- c)) i) ->
  Rpower (INR (4 * m)) c / 3 <= INR T < Rpower (INR (4 * m)) c / 3 + 1 ->
  (forall t i j, (i < 4 * m)%nat -> (j < 4 * m)%nat -> (t < T)%nat -> G t i j = row_net false i j) /\
  (forall t i j, (i < 4 * m)%nat -> (j < 4 * m)%nat -> (T <= t)%nat -> G t i j = row_net true i j) /\
  (1 <= T)%nat /\ (exists i j, (i < 4 * m)%nat /\ (j < 4 * m)%nat /\ G T i j <> G (T - 1)%nat i j) /\
  forall t, (S t <> T)%nat -> forall i j, (i < 4 * m)%nat -> (j < 4 * m)%nat -> G (S t) i j = G t i j.
Proof.
  rewrite Rpower_Ropp. set (N := Rpower (INR (4 * m)) c). intros Hm N8 F X0 V1 [T1 T2].
  assert (Hu : 0 < / N <= / 8) by (split; [apply Rinv_0_lt_compat; lra|apply Rinv_le_contravar; lra]).
  assert (HT : / 3 <= INR T * / N) by (apply Rmult_le_reg_r with N; [lra|]; rewrite Rmult_assoc, Rinv_l by lra; lra).
  assert (HT' : forall t, (t < T)%nat -> INR t * / N < / 3).
  { intros t Ht. apply (le_INR (S t)) in Ht. rewrite S_INR in Ht. apply Rmult_lt_reg_r with N; [lra|]. rewrite Rmult_assoc, Rinv_l by lra. lra. }
  destruct (networks m (/ N) eps x v G T Hm Hu F X0 V1 HT HT') as [B A]. assert (Tp : (1 <= T)%nat) by (destruct T; [change (INR 0) with 0 in T1; lra|lia]).
  split; [intros; now apply B|]. split; [intros; now apply A|]. split; [exact Tp|]. split.
  - exists 1%nat, 2%nat. split; [lia|]. split; [lia|]. rewrite (A T), (B (T - 1)%nat) by lia. cbn. discriminate.
  - intros t Ne i j Hi Hj. destruct (Nat.lt_ge_cases (S t) T) as [L|L]; [now rewrite (B (S t)), (B t) by lia|]. now rewrite (A (S t)), (A t) by lia.
Qed.
Lemma ceiling_exists a : 0 < a -> exists T, a <= INR T < a + 1.
Proof.
  intros Ha. destruct (archimed a) as [H1 H2]. assert (0 < up a)%Z by (apply lt_IZR; cbn; lra).
  destruct (Rle_or_lt (a + 1) (IZR (up a))) as [L|L]; [exists (Z.to_nat (up a - 1))|exists (Z.to_nat (up a))];
    rewrite INR_IZR_INZ, Z2Nat.id by lia; rewrite ?minus_IZR; lra.
Qed.
(* flocks are single paths: before T of two birds in a row, from then on of four *)
Theorem lower_paths m c eps (x v : nat -> nat -> R) (G : nat -> nat -> nat -> bool) : (1 <= m)%nat -> 8 <= Rpower (INR (4 * m)) c -> flock_line (4 * m) eps x v G ->
  (forall i, (i < 4 * m)%nat -> x 0%nat i = place0 i) -> (forall i, (i < 4 * m)%nat -> v 1%nat i = speed0 (Rpower (INR (4 * m)) (- c)) i) ->
  forall t, exists w, (w = 2 \/ w = 4)%nat /\ forall i j, (i < 4 * m)%nat -> (j < 4 * m)%nat -> (G t i j = true <-> (i / w = j / w)%nat /\ (S i = j \/ S j = i)).
Proof.
  intros Hm H8 F X0 V1 t. destruct (ceiling_exists (Rpower (INR (4 * m)) c / 3)) as [T HT]; [lra|]. destruct (lower_bound m c eps x v G T Hm H8 F X0 V1 HT) as (B & A & _).
  assert (Q : forall i j, (i / 2 = j / 2 -> i / 4 = j / 4)%nat) by (intros i j E; change 4%nat with (2 * 2)%nat; rewrite <- !Nat.div_div by lia; now rewrite E).
  destruct (Nat.lt_ge_cases t T) as [L|L].
  - exists 2%nat. split; [now left|]. intros i j Hi Hj. rewrite (B t i j Hi Hj L). unfold row_net. rewrite !andb_true_iff, !orb_true_iff, !Nat.eqb_eq. cbn. intuition (try discriminate; now apply Q).
  - exists 4%nat. split; [now right|]. intros i j Hi Hj. rewrite (A t i j Hi Hj L). unfold row_net. rewrite !andb_true_iff, !orb_true_iff, !Nat.eqb_eq. cbn. intuition.
Qed.
