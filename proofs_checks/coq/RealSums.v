(* Finite sums of reals over 0..n-1, derivatives in the form that the papers' chain rules need, and three
   facts about functions of time: monotonicity from the sign of the derivative, Gronwall, Barbalat. *)
From Coq Require Import Reals Lra Lia Psatz.
From Coquelicot Require Import Coquelicot.
Open Scope R_scope.

Fixpoint Sum (n : nat) (f : nat -> R) : R := match n with O => 0 | Datatypes.S m => Sum m f + f m end.

Lemma Sum_ext n f g : (forall i, (i < n)%nat -> f i = g i) -> Sum n f = Sum n g.
Proof. intros H. induction n; cbn; [reflexivity|]. rewrite IHn by (intros; apply H; lia). now rewrite H by lia. Qed.
Lemma Sum_plus n f g : Sum n (fun i => f i + g i) = Sum n f + Sum n g.
Proof. induction n; cbn; [ring|]. rewrite IHn. ring. Qed.
Lemma Sum_minus n f g : Sum n (fun i => f i - g i) = Sum n f - Sum n g.
Proof. induction n; cbn; [ring|]. rewrite IHn. ring. Qed.
Lemma Sum_opp n f : Sum n (fun i => - f i) = - Sum n f.
Proof. induction n; cbn; [ring|]. rewrite IHn. ring. Qed.
Lemma Sum_scal n c f : Sum n (fun i => c * f i) = c * Sum n f.
Proof. induction n; cbn; [ring|]. rewrite IHn. ring. Qed.
Lemma Sum_scal_r n c f : Sum n (fun i => f i * c) = Sum n f * c.
Proof. induction n; cbn; [ring|]. rewrite IHn. ring. Qed.
Lemma Sum_const n c : Sum n (fun _ => c) = INR n * c.
Proof. induction n; [cbn; ring|]. rewrite S_INR. cbn [Sum]. rewrite IHn. ring. Qed.
Lemma Sum_0 n : Sum n (fun _ => 0) = 0.
Proof. rewrite Sum_const. ring. Qed.
Lemma Sum_zero n f : (forall i, (i < n)%nat -> f i = 0) -> Sum n f = 0.
Proof. intros H. rewrite (Sum_ext n f (fun _ => 0)) by assumption. apply Sum_0. Qed.
Lemma Sum_swap n m f : Sum n (fun i => Sum m (fun j => f i j)) = Sum m (fun j => Sum n (fun i => f i j)).
Proof.
  induction n; cbn; [now rewrite Sum_0|]. rewrite IHn, <- Sum_plus. now apply Sum_ext.
Qed.
Lemma Sum_le n f g : (forall i, (i < n)%nat -> f i <= g i) -> Sum n f <= Sum n g.
Proof.
  intros H. induction n; cbn; [lra|]. assert (f n <= g n) by (apply H; lia).
  assert (Sum n f <= Sum n g) by (apply IHn; intros; apply H; lia). lra.
Qed.
Lemma Sum_ge0 n f : (forall i, (i < n)%nat -> 0 <= f i) -> 0 <= Sum n f.
Proof. intros H. rewrite <- (Sum_0 n). now apply Sum_le. Qed.
Lemma Sum_term_le n f i : (forall j, (j < n)%nat -> 0 <= f j) -> (i < n)%nat -> f i <= Sum n f.
Proof.
  intros H. induction n; intros Hi; [lia|]. cbn.
  assert (P : 0 <= Sum n f) by (apply Sum_ge0; intros; apply H; lia).
  assert (Q : 0 <= f n) by (apply H; lia).
  destruct (Nat.eq_dec i n) as [->|]; [lra|]. assert (f i <= Sum n f) by (apply IHn; [intros; apply H|]; lia). lra.
Qed.
Lemma Sum_eq0 n f : (forall j, (j < n)%nat -> 0 <= f j) -> Sum n f = 0 -> forall i, (i < n)%nat -> f i = 0.
Proof.
  intros H E i Hi. pose proof (Sum_term_le n f i H Hi). pose proof (H i Hi). lra.
Qed.
Definition delta (i j : nat) : R := if Nat.eqb i j then 1 else 0.
Lemma delta_eq i : delta i i = 1.
Proof. unfold delta. now rewrite Nat.eqb_refl. Qed.
Lemma delta_neq i j : i <> j -> delta i j = 0.
Proof. intros H. unfold delta. apply Nat.eqb_neq in H. now rewrite H. Qed.
Lemma delta_sym i j : delta i j = delta j i.
Proof. unfold delta. now rewrite Nat.eqb_sym. Qed.
Lemma Sum_delta n k f : (k < n)%nat -> Sum n (fun i => delta i k * f i) = f k.
Proof.
  intros Hk. induction n; [lia|]. cbn. destruct (Nat.eq_dec k n) as [->|Hn].
  - rewrite delta_eq, Sum_zero; [ring|]. intros i Hi. rewrite delta_neq by lia. ring.
  - rewrite IHn by lia. rewrite (delta_neq n k) by lia. ring.
Qed.
Lemma Sum_delta_l n k f : (k < n)%nat -> Sum n (fun i => delta k i * f i) = f k.
Proof.
  intros Hk. rewrite <- (Sum_delta n k f Hk). apply Sum_ext; intros. now rewrite delta_sym.
Qed.
Lemma Sum_Rabs n f : Rabs (Sum n f) <= Sum n (fun i => Rabs (f i)).
Proof.
  induction n; cbn; [rewrite Rabs_R0; lra|]. eapply Rle_trans; [apply Rabs_triang|]. lra.
Qed.

(* the square of a sum, and the sum of the squares of the differences *)
Lemma Sum_sqr n f g : Sum n f * Sum n g = Sum n (fun i => Sum n (fun j => f i * g j)).
Proof.
  rewrite <- Sum_scal_r. apply Sum_ext; intros i Hi. now rewrite Sum_scal.
Qed.
Lemma Sum_sqr_le n f : Sum n f ^ 2 <= INR n * Sum n (fun i => f i ^ 2).
Proof.
  assert (H : 0 <= Sum n (fun i => Sum n (fun j => (f i - f j) ^ 2))).
  { apply Sum_ge0; intros; apply Sum_ge0; intros; apply pow2_ge_0. }
  assert (E : Sum n (fun i => Sum n (fun j => (f i - f j) ^ 2))
     = 2 * (INR n * Sum n (fun i => f i ^ 2)) - 2 * Sum n f ^ 2).
  { replace (Sum n f ^ 2) with (Sum n f * Sum n f) by ring. rewrite Sum_sqr.
    transitivity (Sum n (fun i => INR n * f i ^ 2) + Sum n (fun i => Sum n (fun j => f j ^ 2))
      - 2 * Sum n (fun i => Sum n (fun j => f i * f j))).
    - rewrite <- Sum_scal, <- Sum_plus, <- Sum_minus. apply Sum_ext; intros i _.
      rewrite <- Sum_const, <- Sum_scal, <- Sum_plus, <- Sum_minus. apply Sum_ext; intros j _. ring.
    - rewrite Sum_const, Sum_scal. ring. }
  lra.
Qed.

(* swapping the two ends of a pair *)
Lemma half_swap n (g : nat -> nat -> R) (v : nat -> R) :
  (forall i j, (i < n)%nat -> (j < n)%nat -> g j i = - g i j) ->
  Sum n (fun i => Sum n (fun j => g i j * (v i - v j))) = 2 * Sum n (fun i => v i * Sum n (fun j => g i j)).
Proof.
  intros G.
  assert (A : Sum n (fun i => Sum n (fun j => g i j * (v i - v j)))
            = Sum n (fun i => Sum n (fun j => v i * g i j)) + Sum n (fun i => Sum n (fun j => v j * g j i))).
  { rewrite <- Sum_plus. apply Sum_ext; intros i Hi. rewrite <- Sum_plus. apply Sum_ext; intros j Hj.
    rewrite (G i j Hi Hj). ring. }
  rewrite A, (Sum_swap n n (fun i j => v j * g j i)).
  assert (B : forall i, (i < n)%nat -> Sum n (fun j => v i * g i j) = v i * Sum n (fun j => g i j))
    by (intros; apply Sum_scal).
  rewrite (Sum_ext n _ _ B). ring.
Qed.
Lemma Sum_antisym n (g : nat -> nat -> R) :
  (forall i j, (i < n)%nat -> (j < n)%nat -> g j i = - g i j) -> Sum n (fun i => Sum n (fun j => g i j)) = 0.
Proof.
  intros G. assert (E : Sum n (fun i => Sum n (fun j => g i j)) = - Sum n (fun i => Sum n (fun j => g i j))).
  { rewrite (Sum_swap n n g) at 1. rewrite <- Sum_opp. apply Sum_ext; intros i Hi. rewrite <- Sum_opp.
    apply Sum_ext; intros j Hj. now apply G. }
  lra.
Qed.

(* Coquelicot states some equations in the carrier of a structure, which ring does not recognise as R *)
Ltac Rring := match goal with |- @eq _ ?a ?b => change (@eq R a b); ring end.

(* derivatives, with the operations of R written out *)
Lemma D_eq (f : R -> R) (t a b : R) : is_derive f t a -> a = b -> is_derive f t b.
Proof. now intros H <-. Qed.
Lemma D_const (c t : R) : is_derive (fun _ : R => c) t 0.
Proof. apply @is_derive_const. Qed.
Lemma D_id (t : R) : is_derive (fun s : R => s) t 1.
Proof. apply @is_derive_id. Qed.
Lemma D_plus (f g : R -> R) (t a b : R) : is_derive f t a -> is_derive g t b -> is_derive (fun s => f s + g s) t (a + b).
Proof. intros; now apply (is_derive_plus f g). Qed.
Lemma D_minus (f g : R -> R) (t a b : R) : is_derive f t a -> is_derive g t b -> is_derive (fun s => f s - g s) t (a - b).
Proof. intros; now apply (is_derive_minus f g). Qed.
Lemma D_opp (f : R -> R) (t a : R) : is_derive f t a -> is_derive (fun s => - f s) t (- a).
Proof. intros; now apply (is_derive_opp f). Qed.
Lemma D_scal (c : R) (f : R -> R) (t a : R) : is_derive f t a -> is_derive (fun s => c * f s) t (c * a).
Proof. intros; now apply (is_derive_scal f). Qed.
Lemma D_mult (f g : R -> R) (t a b : R) :
  is_derive f t a -> is_derive g t b -> is_derive (fun s => f s * g s) t (a * g t + f t * b).
Proof. intros; apply (is_derive_mult f g); [assumption..|]. intros; apply Rmult_comm. Qed.
Lemma D_comp (f g : R -> R) (t a b : R) :
  is_derive f (g t) a -> is_derive g t b -> is_derive (fun s => f (g s)) t (a * b).
Proof. intros. rewrite (Rmult_comm a b). now apply (is_derive_comp f g). Qed.
Lemma D_sqr (f : R -> R) (t a : R) : is_derive f t a -> is_derive (fun s => f s ^ 2) t (2 * f t * a).
Proof.
  intros H. apply (is_derive_ext (fun s => f s * f s)); [intros s;
    replace (f s ^ 2) with (f s * f s) by ring; reflexivity|].
  eapply D_eq; [apply D_mult; eassumption|]. ring.
Qed.
Lemma D_cos (f : R -> R) (t a : R) : is_derive f t a -> is_derive (fun s => cos (f s)) t (- sin (f t) * a).
Proof. intros H. apply (D_comp cos f); [apply is_derive_cos|assumption]. Qed.
Lemma D_sin (f : R -> R) (t a : R) : is_derive f t a -> is_derive (fun s => sin (f s)) t (cos (f t) * a).
Proof. intros H. apply (D_comp sin f); [apply is_derive_sin|assumption]. Qed.
Lemma D_Sum n (f : nat -> R -> R) (d : nat -> R) (t : R) :
  (forall i, (i < n)%nat -> is_derive (f i) t (d i)) -> is_derive (fun s => Sum n (fun i => f i s)) t (Sum n d).
Proof.
  intros H. induction n; cbn; [apply D_const|]. apply D_plus; [apply IHn; intros; apply H; lia|apply H; lia].
Qed.

(* functions of time *)
Lemma MVT_le (f f' : R -> R) a b : a <= b -> (forall t, a <= t <= b -> is_derive f t (f' t)) ->
  exists c, a <= c <= b /\ f b - f a = f' c * (b - a).
Proof.
  intros Hab D. destruct (MVT_gen f a b f') as [c [Hc E]].
  - intros x Hx. apply D. rewrite Rmin_left, Rmax_right in Hx by lra. lra.
  - intros x Hx. rewrite Rmin_left, Rmax_right in Hx by lra. apply continuity_pt_filterlim.
    apply (ex_derive_continuous f). eexists. apply D. lra.
  - rewrite Rmin_left, Rmax_right in Hc by lra. exists c. split; assumption.
Qed.
Lemma decreasing (f f' : R -> R) a b : a <= b -> (forall t, a <= t <= b -> is_derive f t (f' t)) ->
  (forall t, a <= t <= b -> f' t <= 0) -> f b <= f a.
Proof.
  intros Hab D N. destruct (MVT_le f f' a b Hab D) as [c [Hc E]]. pose proof (N c Hc). nra.
Qed.
Lemma constant (f : R -> R) : (forall t, is_derive f t 0) -> forall a b, f a = f b.
Proof.
  assert (H : (forall t, is_derive f t 0) -> forall a b, a <= b -> f a = f b).
  { intros D a b Hab. destruct (MVT_le f (fun _ => 0) a b Hab) as [c [_ E]]; [intros; apply D|]. lra. }
  intros D a b. destruct (Rle_or_lt a b); [now apply H|]. symmetry. apply H; [assumption|lra].
Qed.

(* y' <= - k y  gives  y(t) <= y(0) exp(- k t) *)
Lemma gronwall (y y' : R -> R) k : (forall t, 0 <= t -> is_derive y t (y' t)) ->
  (forall t, 0 <= t -> y' t <= - k * y t) -> forall t, 0 <= t -> y t <= y 0 * exp (- k * t).
Proof.
  intros D N t Ht.
  assert (M : y t * exp (k * t) <= y 0 * exp (k * 0)).
  { apply (decreasing (fun s => y s * exp (k * s))
      (fun s => y' s * exp (k * s) + y s * (exp (k * s) * k)) 0 t Ht).
    - intros s Hs. apply (D_mult y (fun x => exp (k * x))); [apply D; lra|].
      apply (D_comp exp (fun x => k * x) s (exp (k * s)) k); [apply is_derive_exp|].
      eapply D_eq; [apply D_scal, D_id|]. ring.
    - intros s Hs. pose proof (N s ltac:(lra)). pose proof (exp_pos (k * s)). nra. }
  rewrite Rmult_0_r, exp_0 in M.
  assert (E : exp (k * t) * exp (- k * t) = 1).
  { rewrite <- exp_plus. replace (k * t + - k * t) with 0 by ring. apply exp_0. }
  rewrite Rmult_1_r in M. apply (Rmult_le_compat_r (exp (- k * t))) in M; [|left; apply exp_pos].
  rewrite Rmult_assoc, E in M. lra.
Qed.

(* Barbalat in the form used here: F has a nonnegative rate G, F is bounded above and G has a bounded slope;
   then G tends to 0. *)
Lemma barbalat (F G : R -> R) (B C : R) : 0 < C ->
  (forall t, 0 <= t -> is_derive F t (G t)) -> (forall t, 0 <= t -> 0 <= G t) -> (forall t, 0 <= t -> F t <= B) ->
  (forall s t, 0 <= s <= t -> Rabs (G t - G s) <= C * (t - s)) ->
  forall e, 0 < e -> exists T, 0 <= T /\ forall t, T <= t -> G t < e.
Proof.
  intros HC D P Bd Lip e He.
  assert (Up : forall s t, 0 <= s <= t -> F s <= F t).
  { intros s t Hst. apply Ropp_le_cancel. apply (decreasing (fun x => - F x) (fun x => - G x)); [lra|..].
    - intros x Hx. apply D_opp, D. lra.
    - intros x Hx. pose proof (P x ltac:(lra)). lra. }
  set (h := e / (2 * C)). assert (Hh : 0 < h) by (unfold h; apply Rdiv_lt_0_compat; lra).
  assert (Jump : forall t, 0 <= t -> e <= G t -> F t + e / 2 * h <= F (t + h)).
  { intros t Ht Hg. destruct (MVT_le F G t (t + h)) as [c [Hc E]]; [lra|intros; apply D; lra|].
    pose proof (Lip t c ltac:(lra)) as L. apply Rabs_le_between in L.
    assert (C * (c - t) <= e / 2). { apply Rle_trans with (C * h); [nra|]. unfold h. right. field. lra. }
    nra. }
  set (q := e / 2 * h). assert (Hq : 0 < q) by (unfold q; apply Rmult_lt_0_compat; lra).
  destruct (nfloor_ex (Rabs ((B - F 0) / q) + 1)) as [m [_ Hm]]; [pose proof (Rabs_pos ((B - F 0) / q)); lra|].
  assert (K : forall k, (forall T, 0 <= T -> exists t, T <= t /\ e <= G t) -> exists t, 0 <= t /\ F 0 + INR k * q <= F t).
  { intros k A. induction k as [|k [t [Ht Hk]]].
    - exists 0. cbn. split; lra.
    - destruct (A t Ht) as [u [Hu Gu]]. exists (u + h). split; [lra|]. rewrite S_INR.
      pose proof (Jump u ltac:(lra) Gu). pose proof (Up t u ltac:(lra)). fold q in H. lra. }
  destruct (Classical_Prop.classic (exists T, 0 <= T /\ forall t, T <= t -> G t < e)) as [Y|N]; [exact Y|exfalso].
  destruct (K (Datatypes.S m)) as [t [Ht Hk]].
  - intros T HT. apply Classical_Prop.NNPP. intros N2. apply N. exists T. split; [assumption|].
    intros t Htt. apply Rnot_le_lt. intros Hg. apply N2. now exists t.
  - pose proof (Bd t Ht). rewrite S_INR in Hk.
    assert ((B - F 0) / q < INR m + 1) by (pose proof (Rle_abs ((B - F 0) / q)); lra).
    apply (Rmult_lt_compat_r q) in H0; [|assumption]. unfold Rdiv in H0. rewrite Rmult_assoc, Rinv_l in H0 by lra. lra.
Qed.
