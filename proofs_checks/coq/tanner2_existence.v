(* Tanner, Jadbabaie, Pappas, switching paper, Appendix, Definition 4: from every start there is a Filippov solution of xdot = f(x) for all time, for every
   bounded f on R^n (measurable or not).
   Values that f comes near to on sets that are not null, near a state, are a differential inclusion with values everywhere, as a box is not null; its
   solution in inclusions.v is Lipschitz, so it has derivatives at almost all times (lipschitz.v), and these are in every half-space that contains the values
   near the state off a null set, so in their closed convex hull.
     tanner2.appA.def4 (corrected). *)
From Coq Require Import Reals Lra Lia Psatz Classical.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums inclusions tanner2_filippov tanner2_appendix lipschitz.
Open Scope R_scope.

(* ---- products ---- *)
Lemma Product_ext n f g : (forall i, (i < n)%nat -> f i = g i) -> Product n f = Product n g.
Proof. induction n as [|n IH]; intros H; cbn; [reflexivity|]. rewrite IH by (intros; apply H; lia). now rewrite H by lia. Qed.
Lemma Product_ge0 n f : (forall i, (i < n)%nat -> 0 <= f i) -> 0 <= Product n f.
Proof. induction n as [|n IH]; intros H; cbn; [lra|]. apply Rmult_le_pos; [apply IH; intros; apply H; lia|apply H; lia]. Qed.
Lemma Product_pos n f : (forall i, (i < n)%nat -> 0 < f i) -> 0 < Product n f.
Proof. induction n as [|n IH]; intros H; cbn; [lra|]. apply Rmult_lt_0_compat; [apply IH; intros; apply H; lia|apply H; lia]. Qed.
Lemma Product_le n f g : (forall i, (i < n)%nat -> 0 <= f i <= g i) -> Product n f <= Product n g.
Proof.
  induction n as [|n IH]; intros H; cbn; [lra|]. apply Rmult_le_compat; [apply Product_ge0; intros; apply H; lia|apply H; lia|apply IH; intros; apply H; lia|apply H; lia].
Qed.
Lemma Product_split n i f g h : (i < n)%nat -> (forall j, (j < n)%nat -> j <> i -> f j = g j /\ f j = h j) -> f i = g i + h i -> Product n f = Product n g + Product n h.
Proof.
  induction n as [|n IH]; intros Hi E S; [lia|]. cbn. destruct (Nat.eq_dec i n) as [->|N].
  - rewrite S. rewrite <- (Product_ext n f g), <- (Product_ext n f h) by (intros j Hj; apply E; lia). ring.
  - rewrite (IH ltac:(lia)) by (try exact S; intros; apply E; lia). destruct (E n ltac:(lia) ltac:(lia)) as [E1 E2]. rewrite Rmult_plus_distr_r. rewrite E1 at 1. now rewrite E2.
Qed.

(* ---- a box is not null: of two halves one is covered no better, and so on down to a point ---- *)
Definition over (l h a b : R) := Rmax 0 (Rmin h b - Rmax l a).
Lemma over_ge0 l h a b : 0 <= over l h a b. Proof. apply Rmax_l. Qed.
Lemma over_le l h a b : a <= b -> over l h a b <= b - a.
Proof. intros H. unfold over. apply Rmax_lub; [lra|]. pose proof (Rmin_r h b). pose proof (Rmax_r l a). lra. Qed.
Lemma over_split l m h a b : l <= m <= h -> a <= b -> over l h a b = over l m a b + over m h a b.
Proof. intros H Hab. unfold over, Rmax, Rmin. repeat destruct (Rle_dec _ _); lra. Qed.
Lemma over_all l h a b : l <= h -> a <= l -> h <= b -> over l h a b = h - l.
Proof. intros. unfold over. rewrite Rmin_left, (Rmax_left l), Rmax_right by lra. reflexivity. Qed.
Definition set_at i (v : R) (f : nat -> R) j := if Nat.eqb j i then v else f j.
Section Box.
Variables (n : nat) (A B : nat -> nat -> R) (rho : R).
Hypothesis AB : forall k i, (i < n)%nat -> A k i <= B k i.
Hypothesis Hrho : 0 <= rho < 1.
Definition share (lo hi : nat -> R) k := Product n (fun i => over (lo i) (hi i) (A k i) (B k i)).
Definition volume (lo hi : nat -> R) := Product n (fun i => hi i - lo i).
Definition thin (Q : (nat -> R) * (nat -> R)) := forall m, Sum m (share (fst Q) (snd Q)) <= rho * volume (fst Q) (snd Q).
Definition halve i (Q : (nat -> R) * (nat -> R)) := let mid := (fst Q i + snd Q i) / 2 in
  if decide (thin (fst Q, set_at i mid (snd Q))) then (fst Q, set_at i mid (snd Q)) else (set_at i mid (fst Q), snd Q).
Definition proper (Q : (nat -> R) * (nat -> R)) := forall j, (j < n)%nat -> fst Q j <= snd Q j.
Lemma share_ge0 lo hi k : 0 <= share lo hi k.
Proof. apply Product_ge0. intros. apply over_ge0. Qed.
Lemma halve_thin i Q : (i < n)%nat -> proper Q -> thin Q -> thin (halve i Q).
Proof.
  intros Hi Pr T. unfold halve. set (mid := (fst Q i + snd Q i) / 2). destruct (decide (thin (fst Q, set_at i mid (snd Q)))) as [D|D]; [exact D|].
  intros m. apply Rnot_lt_le. intros L. apply not_all_ex_not in D. destruct D as [m' D]. apply Rnot_le_lt in D. cbn [fst snd] in *. set (lo := fst Q) in *. set (hi := snd Q) in *. pose proof (Pr i Hi) as Pi. fold lo hi in Pi.
  assert (V : forall j, set_at i mid hi j - lo j = if Nat.eqb j i then (hi i - lo i) / 2 else hi j - lo j).
  { intros j. unfold set_at. destruct (Nat.eqb_spec j i) as [->|]; [unfold mid; field|reflexivity]. }
  assert (V' : forall j, hi j - set_at i mid lo j = if Nat.eqb j i then (hi i - lo i) / 2 else hi j - lo j).
  { intros j. unfold set_at. destruct (Nat.eqb_spec j i) as [->|]; [unfold mid; field|reflexivity]. }
  assert (Vol : volume lo hi = volume lo (set_at i mid hi) + volume (set_at i mid lo) hi).
  { apply (Product_split n i); [exact Hi| |rewrite V, V', Nat.eqb_refl; field]. intros j Hj Ne. rewrite V, V'. destruct (Nat.eqb_spec j i); [contradiction|]. now split. }
  assert (Eq : volume lo (set_at i mid hi) = volume (set_at i mid lo) hi) by (apply Product_ext; intros j _; now rewrite V, V').
  assert (Sh : forall k, share lo hi k = share lo (set_at i mid hi) k + share (set_at i mid lo) hi k).
  { intros k. apply (Product_split n i); [exact Hi| |].
    - intros j Hj Ne. unfold set_at. destruct (Nat.eqb_spec j i); [contradiction|]. now split.
    - unfold set_at. rewrite Nat.eqb_refl. apply over_split; [unfold mid; lra|now apply AB]. }
  pose proof (T (max m m')) as TT. rewrite (Sum_ext _ (share (fst Q) (snd Q)) (fun k => share lo (set_at i mid hi) k + share (set_at i mid lo) hi k)) in TT by (intros; apply Sh). rewrite Sum_plus in TT. fold lo hi in TT.
  pose proof (Sum_part m (max m m') (share (set_at i mid lo) hi) (share_ge0 _ _) ltac:(lia)). pose proof (Sum_part m' (max m m') (share lo (set_at i mid hi)) (share_ge0 _ _) ltac:(lia)).
  rewrite Vol in TT. rewrite Eq in *. lra.
Qed.
Lemma halve_is i Q : proper Q -> proper (halve i Q) /\ (forall j, (j < n)%nat -> fst Q j <= fst (halve i Q) j /\ snd (halve i Q) j <= snd Q j /\
  snd (halve i Q) j - fst (halve i Q) j = if Nat.eqb j i then (snd Q j - fst Q j) / 2 else snd Q j - fst Q j).
Proof.
  intros Pr. assert (K : forall j, (j < n)%nat -> fst Q j <= fst (halve i Q) j /\ snd (halve i Q) j <= snd Q j /\
    snd (halve i Q) j - fst (halve i Q) j = if Nat.eqb j i then (snd Q j - fst Q j) / 2 else snd Q j - fst Q j).
  { intros j Hj. specialize (Pr j Hj). unfold halve, set_at. destruct (decide _); cbn [fst snd]; destruct (Nat.eqb_spec j i) as [->|]; repeat split; try lra; field. }
  split; [|exact K]. intros j Hj. destruct (K j Hj) as (_ & _ & E). specialize (Pr j Hj). destruct (Nat.eqb j i); lra.
Qed.
Fixpoint halve_first k Q := match k with O => Q | S k => halve k (halve_first k Q) end.
Lemma halve_first_is k : forall Q, (k <= n)%nat -> proper Q -> thin Q -> thin (halve_first k Q) /\ proper (halve_first k Q) /\ forall j, (j < n)%nat ->
  fst Q j <= fst (halve_first k Q) j /\ snd (halve_first k Q) j <= snd Q j /\
  snd (halve_first k Q) j - fst (halve_first k Q) j = if Nat.ltb j k then (snd Q j - fst Q j) / 2 else snd Q j - fst Q j.
Proof.
  induction k as [|k IH]; intros Q Hk Pr T; cbn [halve_first]; [split; [exact T|]; split; [exact Pr|]; intros j Hj; destruct (Nat.ltb_spec j 0); [lia|]; repeat split; lra|].
  destruct (IH Q ltac:(lia) Pr T) as (T1 & P1 & Q1). destruct (halve_is k _ P1) as [P2 Q2]. split; [apply halve_thin; [lia|exact P1|exact T1]|]. split; [exact P2|]. intros j Hj.
  destruct (Q1 j Hj) as (A1 & A2 & A3). destruct (Q2 j Hj) as (B1 & B2 & B3). split; [lra|]. split; [lra|]. rewrite B3, A3.
  destruct (Nat.eqb_spec j k) as [->|N]; [rewrite Nat.ltb_irrefl; destruct (Nat.ltb_spec k (S k)); [reflexivity|lia]|].
  destruct (Nat.ltb_spec j k), (Nat.ltb_spec j (S k)); try lia; reflexivity.
Qed.
Fixpoint shrunk Q j := match j with O => Q | S j => halve_first n (shrunk Q j) end.
Lemma shrunk_is Q : proper Q -> thin Q -> forall j, thin (shrunk Q j) /\ proper (shrunk Q j) /\ forall i, (i < n)%nat -> snd (shrunk Q j) i - fst (shrunk Q j) i = (snd Q i - fst Q i) * (/ 2) ^ j.
Proof.
  intros Pr T. induction j as [|j (T1 & P1 & S1)]; cbn [shrunk]; [split; [exact T|]; split; [exact Pr|]; intros; cbn; ring|].
  destruct (halve_first_is n _ (Nat.le_refl n) P1 T1) as (T2 & P2 & S2). split; [exact T2|]. split; [exact P2|]. intros i Hi. destruct (S2 i Hi) as (_ & _ & ->). destruct (Nat.ltb_spec i n); [|lia]. rewrite S1 by exact Hi. cbn [pow]. field.
Qed.
Lemma shrunk_mono Q : proper Q -> thin Q -> forall i, (i < n)%nat -> forall j k, (j <= k)%nat -> fst (shrunk Q j) i <= fst (shrunk Q k) i /\ snd (shrunk Q k) i <= snd (shrunk Q j) i.
Proof.
  intros Pr T i Hi j k H. induction H as [|k _ IH]; [lra|]. destruct (shrunk_is Q Pr T k) as (T1 & P1 & _). destruct (halve_first_is n _ (Nat.le_refl n) P1 T1) as (_ & _ & S2). destruct (S2 i Hi) as (U1 & U2 & _). cbn [shrunk]. lra.
Qed.
Lemma thin_misses Q : (forall j, (j < n)%nat -> fst Q j < snd Q j) -> thin Q -> exists x, (forall i, (i < n)%nat -> fst Q i <= x i <= snd Q i) /\ forall k, ~ forall i, (i < n)%nat -> A k i < x i < B k i.
Proof.
  intros St T. assert (Pr : proper Q) by (intros j Hj; left; now apply St). pose proof (shrunk_mono Q Pr T) as Mono.
  set (x := fun i => real (Lub_Rbar (fun y => exists j, y = fst (shrunk Q j) i))).
  assert (X : forall i j, (i < n)%nat -> fst (shrunk Q j) i <= x i <= snd (shrunk Q j) i).
  { intros i j Hi. assert (U : forall k l, fst (shrunk Q k) i <= snd (shrunk Q l) i).
    { intros k l. destruct (shrunk_is Q Pr T (max k l)) as (_ & P1 & _). specialize (P1 i Hi). destruct (Mono i Hi k (max k l) ltac:(lia)), (Mono i Hi l (max k l) ltac:(lia)). lra. }
    destruct (lub_is (fun y => exists j, y = fst (shrunk Q j) i) (fst (shrunk Q j) i) (snd (shrunk Q j) i)) as [L1 L2]; [now exists j|intros y [k ->]; apply U|].
    change (real (Lub_Rbar (fun y => exists j, y = fst (shrunk Q j) i))) with (x i) in *. split; [apply L1; now exists j|]. apply L2. intros y [k ->]. apply U. }
  exists x. split; [intros i Hi; exact (X i 0%nat Hi)|]. intros k In.
  destruct (small n (fun i d => A k i + d <= x i <= B k i - d)) as (d & Hd & Gap).
  { intros i d d' H L. lra. }
  { intros i Hi. specialize (In i Hi). exists (Rmin (x i - A k i) (B k i - x i)). pose proof (Rmin_l (x i - A k i) (B k i - x i)). pose proof (Rmin_r (x i - A k i) (B k i - x i)). split; [apply Rmin_glb_lt; lra|lra]. }
  destruct (small n (fun i w => w * (snd Q i - fst Q i) <= d)) as (w & Hw & Side).
  { intros i d1 d2 H L. destruct (Rle_or_lt 0 (snd Q i - fst Q i)) as [G|G]; nra. }
  { intros i Hi. specialize (St i Hi). exists (d / (snd Q i - fst Q i)). split; [apply Rdiv_lt_0_compat; lra|]. right. field. lra. }
  destruct (pow_lt_1_zero (/ 2) ltac:(rewrite Rabs_pos_eq; lra) w Hw) as [j Hj]. specialize (Hj j (Nat.le_refl j)). rewrite Rabs_pos_eq in Hj by (apply pow_le; lra).
  destruct (shrunk_is Q Pr T j) as (T1 & P1 & S1). set (lo := fst (shrunk Q j)) in *. set (hi := snd (shrunk Q j)) in *.
  assert (Pw : 0 < (/ 2) ^ j) by (apply pow_lt; lra).
  assert (Sd : forall i, (i < n)%nat -> 0 < hi i - lo i <= d).
  { intros i Hi. rewrite (S1 i Hi). specialize (Side i Hi). specialize (St i Hi). split; [apply Rmult_lt_0_compat; lra|]. assert ((snd Q i - fst Q i) * (/ 2) ^ j <= (snd Q i - fst Q i) * w) by (apply Rmult_le_compat_l; lra). lra. }
  assert (Full : share lo hi k = volume lo hi).
  { apply Product_ext. intros i Hi. specialize (X i j Hi). specialize (Gap i Hi). specialize (Sd i Hi). fold lo hi in X. apply over_all; lra. }
  assert (Vp : 0 < volume lo hi) by (apply Product_pos; intros i Hi; now apply Sd).
  pose proof (T1 (S k)) as TT. pose proof (Sum_term_le (S k) (share lo hi) k (fun l _ => share_ge0 lo hi l) ltac:(lia)) as Tm. fold lo hi in TT. rewrite Full in Tm. nra.
Qed.
End Box.
Theorem box_not_null n x d : 0 < d -> ~ null n (fun q => near n d q x).
Proof.
  intros Hd N. set (Q := (fun i => x i - d / 2, fun i : nat => x i + d / 2)). set (v := volume n (fst Q) (snd Q)).
  assert (Hv : 0 < v) by (apply Product_pos; intros; unfold Q; cbn; lra). destruct (N (/ 2 * v) ltac:(lra)) as (A & B & AB & Cov & Sm).
  destruct (thin_misses n A B (/ 2) AB ltac:(lra) Q) as (y & Y1 & Y2); [intros; unfold Q; cbn; lra| |].
  - intros m. fold v. eapply Rle_trans; [|apply (Sm m)]. apply Sum_le. intros k _. apply Product_le. intros i Hi. split; [apply over_ge0|]. apply over_le. now apply AB.
  - destruct (Cov y) as [k Hk]; [|exact (Y2 k Hk)]. intros i Hi. specialize (Y1 i Hi). unfold Q in Y1. cbn in Y1. apply Rabs_def1; lra.
Qed.
Lemma null_sub n (P Q : (nat -> R) -> Prop) : (forall x, P x -> Q x) -> null n Q -> null n P.
Proof. intros H N e He. destruct (N e He) as (a & b & A1 & A2 & A3). exists a, b. split; [exact A1|]. split; [|exact A3]. intros x Px. now apply A2, H. Qed.
Lemma null_or n P Q : null n P -> null n Q -> null n (fun x => P x \/ Q x).
Proof.
  intros A B e He. destruct (A (e / 2) ltac:(lra)) as (a & b & A1 & A2 & A3). destruct (B (e / 2) ltac:(lra)) as (a' & b' & B1 & B2 & B3).
  set (mix := fun (f g : nat -> nat -> R) k => if Nat.even k then f (Nat.div2 k) else g (Nat.div2 k)).
  exists (mix a a'), (mix b b'). split; [|split].
  - intros k i Hi. unfold mix. destruct (Nat.even k); [now apply A1|now apply B1].
  - intros t [H|H].
    + destruct (A2 t H) as [k Hk]. exists (2 * k)%nat. unfold mix. rewrite Nat.even_mul. cbn [Nat.even orb]. now rewrite Nat.div2_double.
    + destruct (B2 t H) as [k Hk]. exists (S (2 * k)). unfold mix. rewrite Nat.even_succ, <- Nat.negb_even, Nat.even_mul. cbn [Nat.even orb negb]. now rewrite Nat.div2_succ_double.
  - intros m. set (f := fun k => Product n (fun i => b k i - a k i)). set (f' := fun k => Product n (fun i => b' k i - a' k i)).
    assert (F0 : forall k, 0 <= f k /\ 0 <= f' k) by (intros k; split; apply Product_ge0; intros i Hi; [specialize (A1 k i Hi)|specialize (B1 k i Hi)]; lra).
    assert (K : forall N, Sum (2 * N) (fun k => Product n (fun i => mix b b' k i - mix a a' k i)) = Sum N f + Sum N f').
    { induction N as [|N IH]; [cbn; ring|]. replace (2 * S N)%nat with (S (S (2 * N))) by lia. cbn [Sum]. rewrite IH. unfold mix.
      rewrite Nat.even_succ, <- Nat.negb_even, Nat.even_mul. cbn [Nat.even orb negb]. rewrite Nat.div2_double, Nat.div2_succ_double. fold (f N) (f' N). ring. }
    apply Rle_trans with (Sum (2 * m) (fun k => Product n (fun i => mix b b' k i - mix a a' k i))).
    + apply Sum_part; [|lia]. intros k. unfold mix. destruct (F0 (Nat.div2 k)). destruct (Nat.even k); assumption.
    + rewrite K. specialize (A3 m). specialize (B3 m). fold f in A3. fold f' in B3. lra.
Qed.
Lemma null_none n : (1 <= n)%nat -> null n (fun _ => False).
Proof.
  intros Hn e He. exists (fun _ _ => 0), (fun _ _ => 0). split; [intros; lra|]. split; [intros x []|]. intros m. rewrite Sum_zero; [lra|]. intros k _. destruct n as [|n]; [lia|]. cbn. ring.
Qed.

(* ---- what is in every half-space that contains A is in its closed convex hull ---- *)
Definition convex_of n (A : (nat -> R) -> Prop) (p : nat -> R) := exists m (c : nat -> R) (y : nat -> nat -> R),
  (forall k, (k < m)%nat -> 0 <= c k /\ A (y k)) /\ Sum m c = 1 /\ forall i, (i < n)%nat -> p i = Sum m (fun k => c k * y k i).
Lemma convex_mix n A p y w : convex_of n A p -> A y -> 0 <= w <= 1 -> convex_of n A (fun i => p i + w * (y i - p i)).
Proof.
  intros (m & c & q & H & S1 & E) Ay Hw. exists (S m), (fun k => if Nat.eqb k m then w else (1 - w) * c k), (fun k => if Nat.eqb k m then y else q k). split; [|split].
  - intros k Hk. destruct (Nat.eqb_spec k m) as [->|N]; [split; [lra|exact Ay]|]. destruct (H k ltac:(lia)) as [C1 C2]. split; [apply Rmult_le_pos; lra|exact C2].
  - cbn [Sum]. rewrite Nat.eqb_refl. rewrite (Sum_ext m _ (fun k => (1 - w) * c k)); [rewrite Sum_scal, S1; ring|]. intros k Hk. destruct (Nat.eqb_spec k m); [lia|reflexivity].
  - intros i Hi. cbn [Sum]. rewrite Nat.eqb_refl. rewrite (Sum_ext m _ (fun k => (1 - w) * (c k * q k i))); [rewrite Sum_scal, <- E by exact Hi; ring|]. intros k Hk. destruct (Nat.eqb_spec k m); [lia|ring].
Qed.
Lemma separate n A z M : (exists y, A y) -> (forall y i, A y -> (i < n)%nat -> Rabs (y i) <= M) -> ~ closed_hull n A z -> exists l c, (forall y, A y -> dot n l y <= c) /\ c < dot n l z.
Proof.
  intros [a Aa] Bd Nh. apply not_all_ex_not in Nh. destruct Nh as [e Nh]. apply imply_to_and in Nh. destruct Nh as [He Nh].
  assert (Far : forall p, convex_of n A p -> e ^ 2 <= gap2 n z p).
  { intros p (m & c & y & H & S1 & E). apply Rnot_lt_le. intros L. apply Nh. exists m, c, y. split; [exact H|]. split; [exact S1|]. intros i Hi. rewrite <- E by exact Hi.
    assert (Q : (z i - p i) ^ 2 <= gap2 n z p) by (apply (Sum_term_le n (fun i => (z i - p i) ^ 2) i); [intros; apply pow2_ge_0|exact Hi]).
    rewrite <- (pow2_abs (z i - p i)) in Q. pose proof (Rabs_pos (z i - p i)). nra. }
  assert (C0 : convex_of n A a) by (exists 1%nat, (fun _ => 1), (fun _ => a); split; [intros; split; [lra|exact Aa]|]; split; [cbn; ring|intros; cbn; ring]).
  assert (M0 : (1 <= n)%nat -> 0 <= M) by (intros Hn; eapply Rle_trans; [apply Rabs_pos|apply (Bd a 0%nat Aa); lia]).
  assert (Bp : forall p i, convex_of n A p -> (i < n)%nat -> Rabs (p i) <= M).
  { intros p i (m & c & y & H & S1 & E) Hi. rewrite E by exact Hi. eapply Rle_trans; [apply Sum_Rabs|]. apply Rle_trans with (Sum m (fun k => c k * M)); [|rewrite Sum_scal_r, S1; lra].
    apply Sum_le. intros k Hk. destruct (H k Hk) as [C1 C2]. rewrite Rabs_mult, (Rabs_pos_eq (c k)) by exact C1. apply Rmult_le_compat_l; [exact C1|]. now apply Bd. }
  set (W := INR n * (2 * M) ^ 2). assert (W0 : 0 <= W) by (apply Rmult_le_pos; [apply pos_INR|apply pow2_ge_0]).
  set (lam := Rmin 1 (e ^ 2 / (2 * (W + 1)))). assert (He2 : 0 < e ^ 2) by nra. assert (Hl : 0 < lam <= 1) by (split; [apply Rmin_glb_lt; [lra|apply Rdiv_lt_0_compat; lra]|apply Rmin_l]).
  assert (lW : lam * W <= e ^ 2 / 2).
  { apply Rle_trans with (e ^ 2 / (2 * (W + 1)) * W); [apply Rmult_le_compat_r; [exact W0|apply Rmin_r]|]. apply Rmult_le_reg_r with (2 * (W + 1)); [lra|]. replace (e ^ 2 / (2 * (W + 1)) * W * (2 * (W + 1))) with (e ^ 2 * W) by (field; lra). nra. }
  (* nearly the nearest point *)
  destruct (completeness (fun v => exists p, convex_of n A p /\ v = - gap2 n z p)) as [s [U L]].
  { exists (- e ^ 2). intros v (p & Cp & ->). specialize (Far p Cp). lra. }
  { exists (- gap2 n z a). now exists a. }
  assert (X : exists p0, convex_of n A p0 /\ s - lam * e ^ 2 / 2 < - gap2 n z p0).
  { apply NNPP. intros N. assert (s <= s - lam * e ^ 2 / 2); [|nra]. apply L. intros v (p & Cp & ->). apply Rnot_lt_le. intros G. apply N. now exists p. }
  destruct X as (p0 & Cp & Near0). exists (fun i => z i - p0 i), (dot n (fun i => z i - p0 i) p0 + e ^ 2 / 2). split.
  - intros y Ay. pose proof (convex_mix n A p0 y lam Cp Ay ltac:(lra)) as Cm. pose proof (U _ (ex_intro _ _ (conj Cm eq_refl))) as Um.
    assert (E : gap2 n z (fun i => p0 i + lam * (y i - p0 i)) = gap2 n z p0 - 2 * lam * (dot n (fun i => z i - p0 i) y - dot n (fun i => z i - p0 i) p0) + lam ^ 2 * gap2 n y p0).
    { unfold gap2, dot. rewrite <- Sum_minus, <- !Sum_scal, <- Sum_minus, <- Sum_plus. apply Sum_ext. intros; ring. }
    assert (G : gap2 n y p0 <= W).
    { unfold gap2, W. rewrite <- Sum_const. apply Sum_le. intros i Hi. pose proof (Bd y i Ay Hi) as B1. pose proof (Bp p0 i Cp Hi) as B2. apply Rabs_le_between in B1, B2. nra. }
    rewrite E in Um. set (D := dot n (fun i => z i - p0 i) y - dot n (fun i => z i - p0 i) p0) in *.
    assert (Q : 2 * lam * D <= lam * e ^ 2 / 2 + lam ^ 2 * W) by (assert (lam ^ 2 * gap2 n y p0 <= lam ^ 2 * W) by (apply Rmult_le_compat_l; [apply pow2_ge_0|exact G]); lra).
    assert (D <= e ^ 2 / 2); [|unfold D in *; lra]. apply Rmult_le_reg_l with (2 * lam); [lra|]. replace (2 * lam * (e ^ 2 / 2)) with (lam * e ^ 2 / 2 + lam * (e ^ 2 / 2)) by field. replace (lam ^ 2 * W) with (lam * (lam * W)) in Q by ring.
    assert (lam * (lam * W) <= lam * (e ^ 2 / 2)) by (apply Rmult_le_compat_l; lra). lra.
  - specialize (Far p0 Cp). assert (E : dot n (fun i => z i - p0 i) z = dot n (fun i => z i - p0 i) p0 + gap2 n z p0).
    { unfold dot, gap2. rewrite <- Sum_plus. apply Sum_ext. intros; ring. } rewrite E. lra.
Qed.

(* ---- bounded fields ---- *)
Section Field.
Variables (n : nat) (f : (nat -> R) -> nat -> R) (M : R).
Hypothesis Hn : (1 <= n)%nat.
Hypothesis Bd : forall x i, (i < n)%nat -> Rabs (f x i) <= M.
(* what f comes near to on sets that are not null *)
Definition essential (x y : nat -> R) := forall d Z e, 0 < d -> null n Z -> 0 < e -> exists q, near n d q x /\ ~ Z q /\ forall i, (i < n)%nat -> Rabs (f q i - y i) < e.
Lemma essential_some x : exists y, essential x y.
Proof.
  set (ff := fun q i => if Nat.ltb i n then f q i else 0). set (big := fun P : (nat -> R) -> Prop => forall d, 0 < d -> ~ null n (fun q => near n d q x /\ P (ff q))).
  assert (C : forall k e, 0 < e -> big (close k (cluster big) e)).
  { intros k e He. apply cluster_point; [| | | |exact He].
    - intros P Q H B d Hd N. apply (B d Hd). revert N. apply null_sub. intros q [H1 H2]. split; [exact H1|now apply H].
    - intros P Q H. destruct (classic (big P)) as [Y|Y]; [now left|right]. intros d Hd N. apply not_all_ex_not in Y. destruct Y as [d' Y]. apply imply_to_and in Y. destruct Y as [Hd' Y]. apply NNPP in Y.
      pose proof (Rmin_l d d'). pose proof (Rmin_r d d'). apply (H (Rmin d d') ltac:(now apply Rmin_glb_lt)). eapply null_sub; [|exact (null_or n _ _ Y N)]. intros q [G1 [G2|G2]]; [left|right]; (split; [|exact G2]); intros i Hi; specialize (G1 i Hi); lra.
    - intros d Hd N. apply (box_not_null n x d Hd). revert N. apply null_sub. intros q H. now split.
    - intros k'. exists (Rabs M). intros H. apply (H 1 Rlt_0_1). eapply null_sub; [|exact (null_none n Hn)]. intros q [_ L]. unfold ff in L. pose proof (Rabs_pos M). destruct (Nat.ltb_spec k' n) as [G|G].
      + specialize (Bd q k' G). pose proof (Rle_abs M). lra.
      + rewrite Rabs_R0 in L. lra. }
  exists (cluster big). intros d Z e Hd HZ He. apply NNPP. intros N. apply (C n e He d Hd). revert HZ. apply null_sub. intros q [H1 H2]. apply NNPP. intros K. apply N. exists q. split; [exact H1|]. split; [exact K|].
  intros i Hi. specialize (H2 i Hi). unfold ff in H2. apply Nat.ltb_lt in Hi. now rewrite Hi in H2.
Qed.
Lemma essential_ext x x' y : (forall i, (i < n)%nat -> x i = x' i) -> essential x y -> essential x' y.
Proof. intros E H d Z e Hd HZ He. destruct (H d Z e Hd HZ He) as (q & Q1 & Q2). exists q. split; [|exact Q2]. intros i Hi. rewrite <- E by exact Hi. now apply Q1. Qed.
Lemma essential_bounded x y i : essential x y -> (i < n)%nat -> Rabs (y i) <= M.
Proof.
  intros H Hi. apply le_epsilon. intros e He. destruct (H 1 (fun _ => False) e Rlt_0_1 (null_none n Hn) He) as (q & _ & _ & Q). specialize (Q i Hi). specialize (Bd q i Hi).
  replace (y i) with (f q i + - (f q i - y i)) by ring. eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_Ropp. lra.
Qed.
Lemma essential_K x z : hull n essential x z -> K n f x z.
Proof.
  intros H d Z Hd HZ. apply NNPP. intros N. destruct (separate n (values n f x d Z) z M) as (l & c & S1 & S2); [| |exact N|].
  - destruct (essential_some x) as [y Ey]. destruct (Ey d Z 1 Hd HZ Rlt_0_1) as (q & Q1 & Q2 & _). exists (f q), q. now repeat split.
  - intros y i (q & _ & _ & E) Hi. rewrite E by exact Hi. now apply Bd.
  - assert (dot n l z <= c); [|lra]. apply (H l c (d / 2) ltac:(lra)). intros x' y Nx Ey. apply le_epsilon. intros e He. set (w := Sum n (fun i => Rabs (l i))). assert (w0 : 0 <= w) by (apply Sum_ge0; intros; apply Rabs_pos).
    destruct (Ey (d / 2) Z (e / (w + 1)) ltac:(lra) HZ ltac:(apply Rdiv_lt_0_compat; lra)) as (q & Q1 & Q2 & Q3).
    assert (V : dot n l (f q) <= c). { apply S1. exists q. split; [|now split]. intros i Hi. specialize (Q1 i Hi). specialize (Nx i Hi). replace (q i - x i) with (q i - x' i + (x' i - x i)) by ring. eapply Rle_lt_trans; [apply Rabs_triang|]. lra. }
    pose proof (dot_gap n l y (f q) (e / (w + 1))) as G. fold w in G. assert (G' : dot n l y <= dot n l (f q) + e / (w + 1) * w) by (apply G; intros i Hi; rewrite Rabs_minus_sym; left; now apply Q3).
    assert (e / (w + 1) * w <= e). { apply Rmult_le_reg_r with (w + 1); [lra|]. replace (e / (w + 1) * w * (w + 1)) with (e * w) by (field; lra). nra. } lra.
Qed.
End Field.
(* a Filippov solution for all t >= 0, with one set of measure zero for all times *)
Definition filippov_always n (f : (nat -> R) -> nat -> R) (x : R -> nat -> R) := (forall i, (i < n)%nat -> ac (fun t => x t i)) /\
  exists N, negligible N /\ forall t, 0 <= t -> ~ N t -> exists z, K n f (x t) z /\ forall i, (i < n)%nat -> is_derive (fun s => x s i) t (z i).
Theorem filippov_exists : forall n f M x0, (forall x i, (i < n)%nat -> Rabs (f x i) <= M) ->
  exists x : R -> nat -> R, (forall i, (i < n)%nat -> x 0 i = x0 i) /\ filippov_always n f x.
Proof.
  intros n f M x0 Bd. destruct (Nat.eq_dec n 0) as [->|Nz].
  { exists (fun _ _ => 0). split; [intros; lia|]. split; [intros; lia|]. exists (fun _ => False). split; [apply negligible_none|]. intros t _ _. exists (fun _ => 0). split; [|intros; lia].
    intros d Z Hd HZ. exfalso. destruct (HZ (1 / 2) ltac:(lra)) as (a & b & _ & _ & S). specialize (S 1%nat). cbn in S. lra. }
  assert (Hn : (1 <= n)%nat) by lia. assert (M0 : 0 <= M) by (eapply Rle_trans; [apply Rabs_pos|apply (Bd x0 0%nat); lia]).
  set (F := essential n f). assert (Fe : forall x x' y, (forall i, (i < n)%nat -> x i = x' i) -> F x y -> F x' y) by (intros x x' y; apply essential_ext).
  assert (Fs : forall x, exists y, F x y) by (intros x; now apply (essential_some n f M)). assert (Fb : forall x y i, F x y -> (i < n)%nat -> Rabs (y i) <= M) by (intros x y i; now apply (essential_bounded n f M)).
  set (x := solution n F M x0). exists x. split; [intros i Hi; now apply solution_start|].
  assert (Lp : forall i, (i < n)%nat -> forall s t, Rabs (x t i - x s i) <= M * Rabs (t - s)) by (intros i Hi s t; now apply solution_lipschitz).
  split.
  - intros i Hi. apply ac_lipschitz. intros T' _. exists (M + 1). split; [lra|]. intros s t Hs _. eapply Rle_trans; [apply Lp; exact Hi|]. rewrite Rabs_pos_eq by lra. apply Rmult_le_compat_r; lra.
  - exists (fun t => exists i, (i < n)%nat /\ ~ exists l, is_derive (fun s => x s i) t l). split.
    + apply (negligible_some n (fun i t => ~ exists l, is_derive (fun s => x s i) t l)). intros i Hi. apply (lipschitz_derivatives (fun s => x s i) M). now apply Lp.
    + intros t Ht Nt. exists (fun i => Derive (fun s => x s i) t).
      assert (D : forall i, (i < n)%nat -> is_derive (fun s => x s i) t (Derive (fun s => x s i) t)).
      { intros i Hi. apply Derive_correct. apply NNPP. intros N. apply Nt. exists i. split; [exact Hi|]. intros [l Dl]. apply N. now exists l. }
      split; [|exact D]. apply (essential_K n f M Hn Bd). now apply (solution_derivative n F M x0 M0 Fe Fs Fb t _ Ht).
Qed.
