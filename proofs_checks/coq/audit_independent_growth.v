(* beyond.veerman.growth and beyond.veerman.worst_cases, formalised from their words with own definitions, after the theorems had been proved; the theorems prove them. *)
From Coq Require Import Reals Lra Lia List Relations.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums paley_model.
From Flockproof Require veerman_complex veerman_front veerman_settling veerman_growth veerman_worst.
Module G := veerman_growth.
Open Scope R_scope.

(* ---- whom each car tracks: a list without repetitions; the mean over it; amplitudes a_k of z_k = a_k e^{i w t} ---- *)
Definition total (l : list nat) (z : nat -> C) : C := fold_right (fun j s => (z j + s)%C) (RtoC 0) l.
Definition mean_of (l : list nat) (z : nat -> C) : C := (/ RtoC (INR (length l)) * total l z)%C.
Definition amplitudes (f g w : R) (M : nat) (tracked : nat -> list nat) (a : nat -> C) : Prop := a 0%nat = RtoC 1 /\ forall k, (1 <= k <= M)%nat ->
  let lag := (a k - mean_of (tracked k) a)%C in (- RtoC (w ^ 2) * a k = RtoC f * lag + RtoC g * (Ci * RtoC w * lag))%C.
Definition peak_response f g M tracked (A : R) : Prop := (forall w a, 0 < w -> amplitudes f g w M tracked a -> Cmod (a M) <= A) /\
  exists w a, 0 < w /\ amplitudes f g w M tracked a /\ Cmod (a M) = A.
Inductive led (tracked : nat -> list nat) : nat -> Prop := led_0 : led tracked 0 | led_S : forall j k, led tracked j -> In j (tracked k) -> led tracked k.
Definition growth_1 : Prop := forall f g, f < 0 -> g < 0 -> exists B, 1 < B /\ forall M, (1 <= M)%nat -> exists A, peak_response f g M (fun k => (k - 1)%nat :: nil) A /\ B ^ M <= A.
Definition growth_2 : Prop := forall f g p, f < 0 -> g < 0 -> 0 <= p -> exists c1 c2, 0 < c1 /\ 0 < c2 /\ forall M, (1 <= M)%nat -> exists tracked,
  (forall k, (1 <= k <= M)%nat -> NoDup (tracked k) /\ tracked k <> nil /\ (forall j, In j (tracked k) -> (j <= M)%nat /\ j <> k) /\ led tracked k) /\
  exists A, peak_response f g M tracked A /\ c1 * Rpower (INR M) p <= A /\ A <= c2 * Rpower (INR M) p.
(* ---- behind a leader whose acceleration stays in [-1, 1]: y k is how far car k is from its place, of M cars ---- *)
Definition coupling (two_sided : bool) (M : nat) (y : nat -> R) (k : nat) : R :=
  if two_sided then (if Nat.eqb k M then y k - y (k - 1)%nat else y k - (y (k - 1)%nat + y (k + 1)%nat) / 2) else y k - y (k - 1)%nat.
Record flight (two_sided : bool) (f g : R) (M : nat) (a : R -> R) (y z : nat -> R -> R) : Prop := {
  bounded : forall t, 0 <= t -> -1 <= a t <= 1;
  measurable : forall t, continuity_pt a t;
  leader : forall t, 0 <= t -> is_derive (y 0%nat) t (z 0%nat t) /\ is_derive (z 0%nat) t (a t);
  cars : forall k t, (1 <= k <= M)%nat -> 0 <= t -> is_derive (y k) t (z k t) /\
    is_derive (z k) t (f * coupling two_sided M (fun j => y j t) k + g * coupling two_sided M (fun j => z j t) k);
  places : forall k, (1 <= k <= M)%nat -> y k 0 = y 0%nat 0 /\ z k 0 = z 0%nat 0 }.
(* no number below B is an upper bound of |y_k - y_l| *)
Definition supremum_from (two_sided : bool) f g M k l (B : R) : Prop := forall b, b < B -> exists a y z t, flight two_sided f g M a y z /\ 0 <= t /\ b < Rabs (y k t - y l t).
Definition worst_1 : Prop := forall f g M k, f < 0 -> g < 0 -> (1 <= k <= M)%nat -> supremum_from true f g M k 0 (INR k * (2 * INR M - INR k) / Rabs f) /\ supremum_from true f g M M 0 (INR M ^ 2 / Rabs f).
Definition worst_2 : Prop := forall f g M k, f < 0 -> g < 0 -> (1 <= k <= M)%nat -> supremum_from true f g M k (k - 1) ((2 * (INR M - INR k) + 1) / Rabs f).
Definition worst_3 : Prop := forall f g M k, f < 0 -> g < 0 -> (1 <= k <= M)%nat -> supremum_from false f g M k 0 (INR k / Rabs f).
Definition worst_4 : Prop := forall f g M k w (gam : C), f < 0 -> g < 0 -> (1 <= k <= M)%nat -> 0 < w ->
  (gam * (RtoC f + Ci * RtoC w * RtoC g) = RtoC f + RtoC (w ^ 2) + Ci * RtoC w * RtoC g)%C ->
  supremum_from false f g M k (k - 1) (Cmod (/ gam)%C ^ (k - 1) / Cmod (RtoC f + Ci * RtoC w * RtoC g + RtoC (w ^ 2))%C) /\ (0 < w ^ 2 < 2 * Rabs f -> 1 < Cmod (/ gam)%C).

(* ---- the theorems prove them ---- *)
Lemma total_app l m z : total (l ++ m) z = (total l z + total m z)%C.
Proof. induction l as [|j l IH]; [change (total m z = (RtoC 0 + total m z)%C); ring|]. cbn [app]. change (total (j :: l ++ m) z) with (z j + total (l ++ m) z)%C. change (total (j :: l) z) with (z j + total l z)%C. rewrite IH. ring. Qed.
Lemma filtered n (p : nat -> bool) z : total (filter p (seq 0 n)) z = Csum n (fun j => if p j then z j else RtoC 0) /\ INR (length (filter p (seq 0 n))) = Sum n (fun j => if p j then 1 else 0).
Proof.
  induction n as [|n [IH1 IH2]]; [split; [apply injective_projections; reflexivity|reflexivity]|]. rewrite seq_S, filter_app, total_app, app_length, plus_INR, IH1, IH2, Csum_S. cbn [filter Nat.add Sum].
  destruct (p n); cbn [total fold_right length INR]; split; ring.
Qed.
Lemma mean_is M sees z k : G.mean M sees z k = mean_of (filter (sees k) (seq 0 (S M))) z.
Proof.
  unfold G.mean, mean_of, G.number. destruct (filtered (S M) (sees k) z) as [-> ->]. destruct (Req_dec (Sum (S M) (fun j => if sees k j then 1 else 0)) 0) as [E|E]; [|now rewrite RtoC_inv].
  rewrite E. assert (Z : paley_model.Csum (S M) (fun j => if sees k j then z j else RtoC 0) = RtoC 0); [|rewrite Z; ring].
  apply Csum_0. intros j Hj. assert (Ge : forall j, (j < S M)%nat -> 0 <= if sees k j then 1 else 0) by (intros i _; destruct (sees k i); lra). pose proof (Sum_eq0 (S M) (fun j => if sees k j then 1 else 0) Ge E j Hj) as Q. cbv beta in Q. destruct (sees k j); [lra|reflexivity].
Qed.
Lemma mean_scal M sees z k (c : C) : G.mean M sees (fun j => (c * z j)%C) k = (c * G.mean M sees z k)%C.
Proof.
  unfold G.mean. rewrite (Csum_ext (S M) _ (fun j => (c * (if sees k j then z j else RtoC 0))%C)) by (intros j _; destruct (sees k j); ring). rewrite Csum_scal. ring.
Qed.
Lemma amplitudes_are f g M sees w a : amplitudes f g w M (fun k => filter (sees k) (seq 0 (S M))) a <-> G.oscillation f g M sees w a.
Proof.
  unfold amplitudes, G.oscillation, G.follows. split; intros [A0 H]; (split; [exact A0|]); intros k.
  - intros t Hk. split; [apply veerman_complex.Cderive_wave|]. specialize (H k Hk). cbv zeta in H. rewrite <- mean_is in H. pose proof (veerman_front.Cderive_wave2 (a k) w t) as D.
    rewrite (mean_scal M sees (fun j => (a j * veerman_complex.cis (w * t))%C) k (0, w)).
    assert (E : G.mean M sees (fun j => (a j * veerman_complex.cis (w * t))%C) k = (veerman_complex.cis (w * t) * G.mean M sees a k)%C).
    { rewrite <- mean_scal. unfold G.mean. f_equal. apply Csum_ext. intros j _. destruct (sees k j); [ring|reflexivity]. }
    rewrite E. match goal with |- veerman_complex.Cderive _ _ ?d => replace d with ((- w ^ 2)%R * (a k * veerman_complex.cis (w * t)))%C end; [exact D|].
    replace ((- w ^ 2)%R * (a k * veerman_complex.cis (w * t)))%C with ((- RtoC (w ^ 2) * a k) * veerman_complex.cis (w * t))%C by (rewrite RtoC_opp; ring). rewrite H.
    assert (I : (Ci * RtoC w)%C = ((0, w) : C)) by (apply injective_projections; cbn; ring). rewrite <- I. ring.
  - intros Hk. cbv zeta. rewrite <- mean_is. destruct (H k 0 Hk) as [_ D]. pose proof (veerman_complex.Cderive_unique _ _ _ _ D (veerman_front.Cderive_wave2 (a k) w 0)) as U.
    rewrite (mean_scal M sees (fun j => (a j * veerman_complex.cis (w * 0))%C) k (0, w)) in U.
    assert (E : G.mean M sees (fun j => (a j * veerman_complex.cis (w * 0))%C) k = (veerman_complex.cis (w * 0) * G.mean M sees a k)%C).
    { rewrite <- mean_scal. unfold G.mean. f_equal. apply Csum_ext. intros j _. destruct (sees k j); [ring|reflexivity]. }
    rewrite E in U. assert (One : veerman_complex.cis (w * 0) = RtoC 1) by (unfold veerman_complex.cis; rewrite Rmult_0_r, cos_0, sin_0; reflexivity). rewrite One in U.
    assert (I : (Ci * RtoC w)%C = ((0, w) : C)) by (apply injective_projections; cbn; ring). rewrite I. rewrite !Cmult_1_r, !Cmult_1_l in U. rewrite RtoC_opp in U. rewrite <- U. ring.
Qed.
Lemma peaks_are f g M sees A : G.peak f g M sees A -> peak_response f g M (fun k => filter (sees k) (seq 0 (S M))) A.
Proof.
  intros [U (w & a & Hw & O & E)]. split.
  - intros w' a' Hw' H. apply (U w' a' Hw'). now apply amplitudes_are.
  - exists w, a. split; [exact Hw|]. split; [now apply amplitudes_are|exact E].
Qed.
Lemma growth_2_proved : growth_2.
Proof.
  intros f g p Hf Hg Hp. destruct (G.every_degree f g p Hf Hg Hp) as (c1 & c2 & P1 & P2 & H). exists c1, c2. split; [exact P1|]. split; [exact P2|]. intros M HM.
  destruct (H M HM) as (sees & S1 & S2 & A & Pk & B1 & B2). exists (fun k => filter (sees k) (seq 0 (S M))). split; [|exists A; split; [now apply peaks_are|now split]].
  intros k Hk. destruct (S1 k Hk) as [N (j & Hj & Sj)]. split; [apply NoDup_filter, seq_NoDup|]. split.
  - intros E. assert (I : In j (filter (sees k) (seq 0 (S M)))) by (apply filter_In; split; [apply in_seq; lia|exact Sj]). rewrite E in I. exact I.
  - split; [intros i Hi; apply filter_In in Hi; destruct Hi as [I Si]; apply in_seq in I; split; [lia|intros ->; congruence]|].
    specialize (S2 k ltac:(lia)). clear - S2. unfold G.reached in S2. apply clos_rt_rtn1 in S2. induction S2 as [|y z (Hy & Hz & Sy) _ IH]; [apply led_0|]. apply led_S with y; [exact IH|]. apply filter_In. split; [apply in_seq; lia|exact Sy].
Qed.
Lemma growth_1_proved : growth_1.
Proof.
  intros f g Hf Hg. destruct (G.one_sided_growth f g Hf Hg) as (B & B1 & H). exists B. split; [exact B1|]. intros M HM. exists (B ^ M). split; [|lra]. specialize (H M). apply peaks_are in H.
  assert (E : forall k, (1 <= k <= M)%nat -> filter (G.tree pred k) (seq 0 (S M)) = (k - 1)%nat :: nil).
  { intros k Hk. unfold G.tree. assert (F : forall n, filter (fun j => Nat.eqb j (pred k)) (seq 0 n) = if Nat.ltb (pred k) n then pred k :: nil else nil).
    { induction n as [|n IH]; [reflexivity|]. rewrite seq_S, filter_app, IH. cbn [filter Nat.add]. destruct (Nat.ltb_spec (pred k) n), (Nat.ltb_spec (pred k) (S n)), (Nat.eqb_spec n (pred k)); try lia; cbn; try reflexivity. now subst. }
    rewrite F. destruct (Nat.ltb_spec (pred k) (S M)); [|lia]. f_equal. lia. }
  assert (Q : forall w a, amplitudes f g w M (fun k => filter (G.tree pred k) (seq 0 (S M))) a <-> amplitudes f g w M (fun k => (k - 1)%nat :: nil) a).
  { intros w a. unfold amplitudes. split; intros [A0 K]; (split; [exact A0|]); intros k Hk; specialize (K k Hk); cbv zeta in *; rewrite (E k Hk) in *; exact K. }
  destruct H as [U (w & a & Hw & O & V)]. split; [intros w' a' Hw' O'; apply (U w' a' Hw'), Q, O'|]. exists w, a. split; [exact Hw|]. split; [apply Q, O|exact V].
Qed.
Lemma flights_2 f g N q B k l : veerman_worst.supremum_at_least N (fun _ => 0) (veerman_settling.system_2 f g N (fun _ => 0)) q B -> (forall x t, q x t = x k t - x l t) -> supremum_from true f g (S N) k l B.
Proof.
  intros H E b Hb. destruct (H (B - b) ltac:(lra)) as (a & x & u & t & [A1 A2] & [D1 D2] & Sy & Ht & Q). exists a, x, u, t. split; [|split; [exact Ht|rewrite <- E; lra]].
  split; [intros; apply A2|exact A1|exact D1| |].
  - intros j s Hj Hs. destruct (Sy j s Hj Hs) as [X1 X2]. split; [exact X1|]. unfold coupling. destruct (Nat.eqb j (S N)); (eapply D_eq; [exact X2|]); field.
  - intros j Hj. destruct (D2 j Hj) as [X1 X2]. split; lra.
Qed.
Lemma flights_1 f g N q B k l : veerman_worst.supremum_at_least N (fun _ => 0) (veerman_settling.system_1 f g N (fun _ => 0)) q B -> (forall x t, q x t = x k t - x l t) -> supremum_from false f g (S N) k l B.
Proof.
  intros H E b Hb. destruct (H (B - b) ltac:(lra)) as (a & x & u & t & [A1 A2] & [D1 D2] & Sy & Ht & Q). exists a, x, u, t. split; [|split; [exact Ht|rewrite <- E; lra]].
  split; [intros; apply A2|exact A1|exact D1| |].
  - intros j s Hj Hs. destruct (Sy j s Hj Hs) as [X1 X2]. split; [exact X1|]. unfold coupling. eapply D_eq; [exact X2|]. ring.
  - intros j Hj. destruct (D2 j Hj) as [X1 X2]. split; lra.
Qed.
Lemma worst_1_proved : worst_1.
Proof.
  intros f g [|N] k Hf Hg Hk; [lia|]. destruct (veerman_worst.two_sided_worst f g N (fun _ => 0) k Hf Hg Hk) as (A & B & _).
  split; [apply (flights_2 f g N _ _ _ _ A)|apply (flights_2 f g N _ _ _ _ B)]; intros; unfold veerman_settling.deviation; ring.
Qed.
Lemma worst_2_proved : worst_2.
Proof.
  intros f g [|N] k Hf Hg Hk; [lia|]. destruct (veerman_worst.two_sided_worst f g N (fun _ => 0) k Hf Hg Hk) as (_ & _ & A).
  apply (flights_2 f g N _ _ _ _ A); intros; unfold veerman_settling.deviation; ring.
Qed.
Lemma worst_3_proved : worst_3.
Proof.
  intros f g [|N] k Hf Hg Hk; [lia|]. apply (flights_1 f g N _ _ _ _ (veerman_worst.one_sided_worst f g N (fun _ => 0) k Hf Hg Hk)). intros; unfold veerman_settling.deviation; ring.
Qed.
Lemma worst_4_proved : worst_4.
Proof.
  intros f g [|N] k w gam Hf Hg Hk Hw E; [lia|]. assert (Gm : gam = veerman_front.gamma f g w).
  { pose proof (veerman_front.den_neq0 f g w Hf) as NZ. apply (veerman_complex.Cmult_cancel_r _ _ _ NZ).
    assert (F : (veerman_front.gamma f g w * veerman_front.den f g w)%C = veerman_front.num f g w).
    { unfold veerman_front.gamma, Cdiv. rewrite <- Cmult_assoc, (Cinv_l _ NZ). ring. }
    rewrite F, veerman_front.den_printed, veerman_front.num_printed, E. ring. }
  subst gam. destruct (veerman_worst.one_sided_gap f g N (fun _ => 0) k w Hf Hg Hk Hw) as [A B]. rewrite veerman_front.num_printed in A. split; [|intros [_ W]; now apply B].
  apply (flights_1 f g N _ _ _ _ A). intros; unfold veerman_settling.deviation; ring.
Qed.
