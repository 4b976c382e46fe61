(* Tanner, Jadbabaie, Pappas, both papers: the multiplicity of the eigenvalue 0 of a (weighted) Laplacian is the number of
   components, given by a list with one node of each of them; and a tree has n - 1 edges.
     tanner1.L, tanner1.Lw, tanner2.L (multiplicity), tanner2.rangeB (edges). *)
From Coq Require Import Reals Lra Lia Psatz Relations List Classical Bool.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums paley_model paley_phase paley_laplacian paley_gradient paley_particles tanner_energy tanner_flock tanner_trees tanner_graph tanner2_facts.
Open Scope R_scope.

Definition joined (n : nat) (adj : graph) : nat -> nat -> Prop := clos_refl_trans nat (arc n adj).
Definition one_of_each (n : nat) (adj : graph) (l : list nat) : Prop := NoDup l /\ (forall a, In a l -> (a < n)%nat) /\
  (forall a b, In a l -> In b l -> joined n adj a b -> a = b) /\ forall k, (k < n)%nat -> exists a, In a l /\ joined n adj a k.
Lemma joined_sym n adj a b : undirected adj -> joined n adj a b -> joined n adj b a.
Proof.
  intros S H. induction H as [a b [Ha [Hb A]]|a|a b c _ H1 _ H2]; [|apply rt_refl|now apply rt_trans with b].
  apply rt_step. repeat split; try assumption. now rewrite S.
Qed.
Theorem components_exist n adj : undirected adj -> exists l, one_of_each n adj l.
Proof.
  intros S. assert (H : forall m, (m <= n)%nat -> exists l, NoDup l /\ (forall a, In a l -> (a < n)%nat) /\
    (forall a b, In a l -> In b l -> joined n adj a b -> a = b) /\ forall k, (k < m)%nat -> exists a, In a l /\ joined n adj a k).
  { induction m as [|m IH]; intros Hm; [exists nil; repeat split; [constructor|intros a []|intros a b []|intros; lia]|].
    destruct IH as (l & ND & B & U & C); [lia|]. destruct (classic (exists a, In a l /\ joined n adj a m)) as [E|E].
    - exists l. repeat split; try assumption. intros k Hk. destruct (Nat.eq_dec k m) as [->|]; [exact E|apply C; lia].
    - exists (m :: l). repeat split.
      + constructor; [|exact ND]. intros I. apply E. exists m. split; [exact I|apply rt_refl].
      + intros a [<-|I]; [lia|now apply B].
      + intros a b [<-|Ia] [<-|Ib] J; [reflexivity|exfalso; apply E; exists b; split; [exact Ib|now apply joined_sym]|exfalso; apply E; now exists a|now apply U].
      + intros k Hk. destruct (Nat.eq_dec k m) as [->|]; [exists m; split; [now left|apply rt_refl]|].
        destruct (C k ltac:(lia)) as (a & Ia & J). exists a. split; [now right|exact J]. }
  now apply (H n).
Qed.

(* functions on the nodes that are constant on components, with any values on the list *)
Lemma spread n adj l (y : nat -> R) : undirected adj -> NoDup l -> (forall a b, In a l -> In b l -> joined n adj a b -> a = b) -> (forall a, In a l -> (a < n)%nat) ->
  exists x : nat -> R, (forall j k, joined n adj j k -> x j = x k) /\ forall a, In a l -> x a = y a.
Proof.
  intros S. induction l as [|a l IH]; intros ND U B; [exists (fun _ => 0); split; [reflexivity|intros a []]|].
  inversion ND as [|? ? NI ND']; subst. destruct IH as (x & X & Y); [assumption|intros; apply U; [now right..|assumption]|intros; apply B; now right|].
  destruct (decided (Datatypes.S n) (fun k => joined n adj a k)) as [s Hs].
  assert (Ha : (a < n)%nat) by (apply B; now left).
  exists (fun k => if andb (Nat.ltb k n) (s k) then y a else x k). split.
  - intros j k J. assert (In_n : j = k \/ (j < n)%nat /\ (k < n)%nat).
    { clear - J. induction J as [j k [Hj [Hk _]]|j|i j k _ [->|[]] _ [<-|[]]]; auto. }
    destruct In_n as [->|[Hj Hk]]; [reflexivity|]. apply Nat.ltb_lt in Hj as Lj. apply Nat.ltb_lt in Hk as Lk. rewrite Lj, Lk. cbn [andb].
    assert (E : s j = s k).
    { destruct (s j) eqn:Sj, (s k) eqn:Sk; try reflexivity; exfalso.
      - apply Hs in Sj; [|lia]. assert (s k = true); [|congruence]. apply Hs; [lia|]. now apply rt_trans with j.
      - apply Hs in Sk; [|lia]. assert (s j = true); [|congruence]. apply Hs; [lia|]. apply rt_trans with k; [exact Sk|now apply joined_sym]. }
    rewrite E. destruct (s k); [reflexivity|now apply X].
  - intros b [<-|Ib].
    + apply Nat.ltb_lt in Ha as La. rewrite La. replace (s a) with true; [reflexivity|]. symmetry. apply Hs; [lia|apply rt_refl].
    + assert (Hb : (b < n)%nat) by (apply B; now right). apply Nat.ltb_lt in Hb as Lb. rewrite Lb. destruct (s b) eqn:Sb; [|now apply Y].
      exfalso. apply Hs in Sb; [|lia]. apply NI. rewrite (U a b); [exact Ib|now left|now right|exact Sb].
Qed.
(* The null vectors of L_w are determined by their values on the list, which can be any numbers, so their space has as many dimensions as
   there are components; and L_w^2 x = 0 only where L_w x = 0, so this is the algebraic multiplicity too. *)
Theorem zero_multiplicity n adj (W : nat -> nat -> R) l : undirected adj -> (forall i j, W i j = W j i) -> (forall i j, 0 < W i j) -> one_of_each n adj l ->
  let L x k := Sum n (fun j => lapw n (fun i j => w adj i j * W i j) k j * x j) in let null x := forall k, (k < n)%nat -> L x k = 0 in
  (forall y, exists x, null x /\ forall a, In a l -> x a = y a) /\
  (forall x x', null x -> null x' -> (forall a, In a l -> x a = x' a) -> forall k, (k < n)%nat -> x k = x' k) /\
  (forall x, null (L x) -> null x).
Proof.
  intros S WS WP (ND & B & U & C) L null. set (a := fun i j => w adj i j * W i j) in *.
  assert (K : forall x, null x <-> forall j k, joined n adj j k -> x j = x k) by (intros x; apply (Lw_kernel n adj W x S WS WP)).
  split; [|split].
  - intros y. destruct (spread n adj l y S ND U B) as (x & X & Y). exists x. split; [now apply K|exact Y].
  - intros x x' N N' E k Hk. destruct (C k Hk) as (b & Ib & J). rewrite <- (proj1 (K x) N b k J), <- (proj1 (K x') N' b k J). now apply E.
  - intros x N. assert (Sy : forall k j, lapw n a k j = lapw n a j k) by (apply (Lw_kernel n adj W x S WS WP)).
    assert (T : Sum n (fun k => L x k * L x k) = 0).
    { assert (M : forall u z, Sum n (fun k => u k * L z k) = Sum n (fun j => z j * L u j)).
      { intros u z. unfold L. rewrite (Sum_ext n (fun k => u k * _) (fun k => Sum n (fun j => u k * (lapw n a k j * z j)))) by (intros; now rewrite Sum_scal).
        rewrite Sum_swap. apply Sum_ext. intros j _. rewrite <- Sum_scal. apply Sum_ext. intros k _.
        rewrite (Sy k j). ring. }
      rewrite (M (L x) x). apply Sum_zero. intros k Hk. rewrite (N k Hk). ring. }
    intros k Hk. assert (P : L x k * L x k = 0) by (apply (Sum_eq0 n (fun k => L x k * L x k)); [intros; apply Rle_0_sqr|exact T|exact Hk]). now apply Rmult_integral in P as [|].
Qed.
(* the same of L *)
Corollary zero_multiplicity_L n adj l : undirected adj -> one_of_each n adj l -> let null x := forall k, (k < n)%nat -> lmul n adj x k = 0 in
  (forall y, exists x, null x /\ forall a, In a l -> x a = y a) /\
  (forall x x', null x -> null x' -> (forall a, In a l -> x a = x' a) -> forall k, (k < n)%nat -> x k = x' k) /\
  (forall x, null (lmul n adj x) -> null x).
Proof.
  intros S O null. destruct (zero_multiplicity n adj (fun _ _ => 1) l S (fun _ _ => eq_refl) (fun _ _ => Rlt_0_1) O) as (A & B & C).
  assert (E : forall x k, Sum n (fun j => lapw n (fun i j => w adj i j * 1) k j * x j) = lmul n adj x k).
  { intros x k. unfold lmul. apply Sum_ext. intros j _. f_equal. unfold lapw, lap, deg. rewrite Rmult_1_r. do 2 f_equal. apply Sum_ext; intros; ring. }
  assert (F : forall x, null x <-> forall k, (k < n)%nat -> Sum n (fun j => lapw n (fun i j => w adj i j * 1) k j * x j) = 0).
  { intros x. split; intros H k Hk; [rewrite E|rewrite <- E]; now apply H. }
  split; [|split].
  - intros y. destruct (A y) as (x & X & Y). exists x. split; [now apply F|exact Y].
  - intros x x' N N'. apply B; now apply F.
  - intros x N. apply F, C. intros k Hk. rewrite <- (N k Hk), <- E. apply Sum_ext. intros j _. now rewrite E.
Qed.

(* ---- a tree has n - 1 edges: each of them joins two components of those before it ---- *)
Definition drawn (P : list (nat * nat)) : graph := fun i j => existsb (fun e => (fst e =? i) && (snd e =? j) || (fst e =? j) && (snd e =? i))%nat%bool P.
Lemma drawn_iff P i j : drawn P i j = true <-> In (i, j) P \/ In (j, i) P.
Proof.
  unfold drawn. rewrite existsb_exists. split.
  - intros ([x y] & I & E). cbn [fst snd] in E. apply orb_true_iff in E as [E|E]; apply andb_true_iff in E as [A B]; apply Nat.eqb_eq in A, B; subst; [now left|now right].
  - intros [I|I]; [exists (i, j)|exists (j, i)]; (split; [exact I|]); cbn [fst snd]; rewrite !Nat.eqb_refl; [reflexivity|apply orb_true_r].
Qed.
Lemma drawn_undirected P : undirected (drawn P).
Proof. intros i j. apply eq_true_iff_eq. pose proof (drawn_iff P i j). pose proof (drawn_iff P j i). tauto. Qed.
Lemma joined_mono n (g h : graph) a b : (forall i j, arc n g i j -> joined n h i j) -> joined n g a b -> joined n h a b.
Proof. intros M H. induction H as [a b A|a|a b c _ H1 _ H2]; [now apply M|apply rt_refl|now apply rt_trans with b]. Qed.
Lemma drawn_one_more n a b P x y : joined n (drawn ((a, b) :: P)) x y ->
  joined n (drawn P) x y \/ joined n (drawn P) x a /\ joined n (drawn P) b y \/ joined n (drawn P) x b /\ joined n (drawn P) a y.
Proof.
  intros H. apply clos_rt_rt1n in H. induction H as [x|x z y [Hx [Hz A]] _ IH]; [left; apply rt_refl|].
  apply drawn_iff in A. cbn [In] in A.
  assert (St : In (x, z) P \/ In (z, x) P -> joined n (drawn P) x z) by (intros I; apply rt_step; repeat split; try assumption; apply drawn_iff; tauto).
  assert (Cases : joined n (drawn P) x z \/ x = a /\ z = b \/ x = b /\ z = a).
  { destruct A as [[E|I]|[E|I]]; [injection E as E1 E2; subst; tauto|left; apply St; tauto|injection E as E1 E2; subst; tauto|left; apply St; tauto]. }
  destruct Cases as [J|[[-> ->]|[-> ->]]].
  - destruct IH as [K|[[K L]|[K L]]]; [left|right; left; split; [|exact L]|right; right; split; [|exact L]]; now apply rt_trans with z.
  - destruct IH as [K|[[K L]|[K L]]]; [right; left; split; [apply rt_refl|exact K]|right; left; split; [apply rt_refl|exact L]|left; exact L].
  - destruct IH as [K|[[K L]|[K L]]]; [right; right; split; [apply rt_refl|exact K]|left; exact L|right; right; split; [apply rt_refl|exact L]].
Qed.
Lemma bridge n adj a b : undirected adj -> tree n adj -> arc n adj a b -> ~ joined n (without adj a b) a b.
Proof.
  intros S [SC T] A J. apply (T a b A). intros x y Hx Hy. apply (joined_mono n adj); [|now apply SC].
  assert (Su : undirected (without adj a b)).
  { intros i j. unfold without. rewrite (S i j). f_equal. f_equal. destruct (i =? a)%nat, (j =? b)%nat, (i =? b)%nat, (j =? a)%nat; reflexivity. }
  intros i j [Hi [Hj E]]. destruct (without adj a b j i) eqn:F; [apply rt_step; now repeat split|].
  unfold without in F. rewrite E in F. cbn [andb] in F. apply negb_false_iff, orb_true_iff in F as [F|F]; apply andb_true_iff in F as [F1 F2]; apply Nat.eqb_eq in F1, F2; subst;
    [now apply joined_sym|exact J].
Qed.
Lemma length_remove (l : list nat) x : NoDup l -> In x l -> length l = Datatypes.S (length (remove Nat.eq_dec x l)).
Proof.
  induction l as [|y l IH]; intros ND I; [destruct I|]. inversion ND as [|? ? NI ND']; subst. cbn [remove]. destruct (Nat.eq_dec x y) as [->|N].
  - cbn [length]. f_equal. symmetry. now rewrite notin_remove.
  - destruct I as [->|I]; [contradiction|]. cbn [length]. f_equal. now apply IH.
Qed.
Lemma NoDup_remove_all (l : list nat) x : NoDup l -> NoDup (remove Nat.eq_dec x l).
Proof.
  induction l as [|y l IH]; intros ND; [constructor|]. inversion ND as [|? ? NI ND']; subst. cbn [remove]. destruct (Nat.eq_dec x y); [now apply IH|].
  constructor; [|now apply IH]. intros I. apply NI. now apply in_remove in I.
Qed.
Theorem tree_edges n adj O : (1 <= n)%nat -> undirected adj -> tree n adj -> oriented n adj O -> (length O + 1 = n)%nat.
Proof.
  intros Hn S Tr (ND & B & M).
  assert (pos : forall e, 0 <= member O e <= 1) by (intros e; unfold member; destruct (in_dec pair_dec e O); lra).
  assert (one : forall e, In e O -> member O e = 1) by (intros e He; unfold member; destruct (in_dec pair_dec e O); [reflexivity|contradiction]).
  assert (edge : forall i j, In (i, j) O -> arc n adj i j /\ ~ In (j, i) O).
  { intros i j I. destruct (B i j I) as [Hi Hj]. pose proof (M i j Hi Hj) as E. rewrite (one _ I) in E. pose proof (pos (j, i)) as P. unfold w in E.
    destruct (adj i j) eqn:A; [|lra]. split; [repeat split; try assumption; now rewrite S|]. intros I'. rewrite (one _ I') in E. lra. }
  assert (H : forall P Q, O = Q ++ P -> exists l, one_of_each n (drawn P) l /\ (length l + length P = n)%nat).
  { induction P as [|[a b] P IH]; intros Q E.
    - exists (seq 0 n). split; [|rewrite seq_length; cbn; lia]. repeat split.
      + apply seq_NoDup.
      + intros a I. apply in_seq in I. lia.
      + intros a b _ _ J. induction J as [a b [_ [_ A]]|a|a b c _ -> _ ->]; [discriminate|reflexivity|reflexivity].
      + intros k Hk. exists k. split; [apply in_seq; lia|apply rt_refl].
    - destruct (IH (Q ++ (a, b) :: nil)) as (l & (NDl & Bl & U & C) & Len); [rewrite E, <- app_assoc; reflexivity|].
      assert (I0 : In (a, b) O) by (rewrite E; apply in_or_app; right; now left). destruct (B a b I0) as [Ha Hb]. destruct (edge a b I0) as [A NI].
      assert (NP : ~ In (a, b) P) by (rewrite E in ND; apply NoDup_remove_2 in ND; intros I; apply ND, in_or_app; now right).
      assert (PO : forall e, In e P -> In e O) by (intros e I; rewrite E; apply in_or_app; right; now right).
      assert (NJ : ~ joined n (drawn P) a b).
      { intros J. apply (bridge n adj a b S Tr A). revert J. apply joined_mono. intros i j [Hi [Hj D]]. apply rt_step. repeat split; try assumption.
        apply drawn_iff in D. unfold without. assert (Aji : adj j i = true).
        { destruct D as [D|D]; apply PO, edge in D as [[_ [_ D]] _]; [now rewrite S|exact D]. }
        rewrite Aji. cbn [andb]. apply negb_true_iff, orb_false_iff.
        split; apply andb_false_iff; [destruct (Nat.eqb_spec j a) as [->|]; [|now left]; destruct (Nat.eqb_spec i b) as [->|]; [|now right]
          |destruct (Nat.eqb_spec j b) as [->|]; [|now left]; destruct (Nat.eqb_spec i a) as [->|]; [|now right]];
          exfalso; destruct D as [D|D]; solve [now apply NP|now apply NI, PO]. }
      destruct (C a Ha) as (ra & Ia & Ja). destruct (C b Hb) as (rb & Ib & Jb). pose proof (drawn_undirected P) as SP.
      assert (More : forall x y, joined n (drawn P) x y -> joined n (drawn ((a, b) :: P)) x y).
      { intros x y. apply joined_mono. intros i j [Hi [Hj D]]. apply rt_step. repeat split; try assumption. apply drawn_iff. apply drawn_iff in D. cbn [In]. tauto. }
      exists (remove Nat.eq_dec rb l). split; [|pose proof (length_remove l rb NDl Ib); cbn [length] in *; lia]. repeat split.
      + now apply NoDup_remove_all.
      + intros x I. apply in_remove in I as [I _]. now apply Bl.
      + intros x y Ix Iy J. apply in_remove in Ix as [Ix Nx]. apply in_remove in Iy as [Iy Ny].
        apply drawn_one_more in J as [J|[[_ J]|[J _]]]; [now apply U| |].
        * exfalso. apply Ny. symmetry. apply U; [exact Ib|exact Iy|now apply rt_trans with b].
        * exfalso. apply Nx. apply U; [exact Ix|exact Ib|]. apply rt_trans with b; [exact J|now apply joined_sym].
      + intros k Hk. destruct (C k Hk) as (x & Ix & Jx). destruct (Nat.eq_dec x rb) as [->|N].
        * exists ra. split; [apply in_in_remove; [intros ->; apply NJ; apply rt_trans with rb; [now apply joined_sym|exact Jb]|exact Ia]|].
          apply rt_trans with a; [now apply More|]. apply rt_trans with b; [apply rt_step; repeat split; try assumption; apply drawn_iff; cbn [In]; tauto|].
          apply More. apply rt_trans with rb; [now apply joined_sym|exact Jx].
        * exists x. split; [now apply in_in_remove|now apply More]. }
  destruct (H O nil eq_refl) as (l & (NDl & Bl & U & C) & Len).
  assert (L1 : length l = 1%nat); [|lia]. destruct (C 0%nat Hn) as (a & Ia & Ja). destruct l as [|x [|y l]]; [destruct Ia|reflexivity|exfalso].
  clear Len. inversion NDl as [|? ? NI _]; subst. apply NI. left. symmetry. apply U; [now left|right; now left|].
  assert (All : joined n adj x y) by (apply Tr; apply Bl; [now left|right; now left]). revert All. apply joined_mono. intros i j [Hi [Hj A]].
  apply rt_step. repeat split; try assumption. apply drawn_iff. rewrite S in A. pose proof (M i j Hi Hj) as E. unfold w in E. rewrite A in E. unfold member in E.
  destruct (in_dec pair_dec (i, j) O) as [I|I]; [tauto|]. destruct (in_dec pair_dec (j, i) O); [tauto|lra].
Qed.
