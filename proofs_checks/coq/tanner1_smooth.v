(* Tanner, Jadbabaie, Pappas I, the abstract and section I, corrected: the control laws (4), (5) with the headings (2) are smooth where no velocity is zero or points along
   the negative x axis and no linked agents coincide.
     beyond.tanner1.smooth, tanner1.smooth (corrected).
   States are vectors of 4n numbers, of agent i the place and the velocity at 4i, .., 4i + 3.  The laws are expressions of coordinates, sums, products, inverses, roots, arctangents
   and derivatives of potentials; such expressions have partial derivatives that are such expressions again, with the same domain, and all are continuous. *)
From Coq Require Import Reals Lra Lia Psatz.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums paley_model tanner_energy tanner1_heading tanner_angle.
Open Scope R_scope.

Definition state := nat -> R.
Definition put (s : state) (m : nat) (x : R) : state := fun j => if Nat.eqb j m then x else s j.
Definition near (d : nat) (s q : state) (e : R) : Prop := forall m, (m < d)%nat -> Rabs (q m - s m) < e.
Definition open_set (d : nat) (U : state -> Prop) : Prop := forall s, U s -> exists e, 0 < e /\ forall q, near d s q e -> U q.
Definition continuous_on (d : nat) (U : state -> Prop) (F : state -> R) : Prop := forall s, U s -> forall e, 0 < e -> exists r, 0 < r /\ forall q, near d s q r -> Rabs (F q - F s) < e.
(* continuous with continuous partial derivatives of all orders up to k *)
Fixpoint differentiable (k d : nat) (U : state -> Prop) (F : state -> R) : Prop := match k with
  | O => continuous_on d U F
  | S k => continuous_on d U F /\ forall m, (m < d)%nat -> exists G, (forall s, U s -> is_derive (fun x => F (put s m x)) (s m) (G s)) /\ differentiable k d U G end.
Definition smooth_on (d : nat) (U : state -> Prop) (F : state -> R) : Prop := forall k, differentiable k d U F.

(* ---- expressions ---- *)
Section Expressions.
Variable W : nat -> nat -> nat -> R -> R.
Hypothesis HW : forall i j k x, 0 < x -> is_derive (W i j k) x (W i j (S k) x).
Inductive expr : Type := Coord (m : nat) | Const (c : R) | Plus (a b : expr) | Times (a b : expr) | Inverse (a : expr) | Root (a : expr) | Atan (a : expr) | Pot (i j k : nat) (a : expr).
Fixpoint eval (a : expr) (s : state) : R := match a with
  | Coord m => s m | Const c => c | Plus a b => eval a s + eval b s | Times a b => eval a s * eval b s
  | Inverse a => / eval a s | Root a => sqrt (eval a s) | Atan a => atan (eval a s) | Pot i j k a => W i j k (eval a s) end.
Fixpoint domain (d : nat) (a : expr) (s : state) : Prop := match a with
  | Coord m => (m < d)%nat | Const _ => True | Plus a b | Times a b => domain d a s /\ domain d b s
  | Inverse a => domain d a s /\ eval a s <> 0 | Root a => domain d a s /\ 0 < eval a s | Atan a => domain d a s | Pot _ _ _ a => domain d a s /\ 0 < eval a s end.
Fixpoint partial (m : nat) (a : expr) : expr := match a with
  | Coord j => Const (if Nat.eqb j m then 1 else 0) | Const _ => Const 0 | Plus a b => Plus (partial m a) (partial m b)
  | Times a b => Plus (Times (partial m a) b) (Times a (partial m b))
  | Inverse a => Times (Const (-1)) (Times (partial m a) (Times (Inverse a) (Inverse a)))
  | Root a => Times (partial m a) (Times (Const (/ 2)) (Inverse (Root a)))
  | Atan a => Times (partial m a) (Inverse (Plus (Const 1) (Times a a)))
  | Pot i j k a => Times (partial m a) (Pot i j (S k) a) end.
Lemma partial_domain d m a s : domain d a s -> domain d (partial m a) s.
Proof.
  induction a; cbn; try tauto.
  - intros [A P]. specialize (IHa A). repeat split; try tauto. apply Rgt_not_eq. now apply sqrt_lt_R0.
  - intros A. specialize (IHa A). repeat split; try tauto. pose proof (Rle_0_sqr (eval a s)) as Q. unfold Rsqr in Q. lra.
Qed.
Lemma put_same (s : state) m : forall j, put s m (s m) j = s j.
Proof. intros j. unfold put. now destruct (Nat.eqb_spec j m) as [->|]. Qed.
Lemma eval_ext a s q : (forall j, s j = q j) -> eval a s = eval a q.
Proof. intros H. induction a; cbn; rewrite ?IHa, ?IHa1, ?IHa2; auto. Qed.
Lemma partial_correct d m a s : domain d a s -> is_derive (fun x => eval a (put s m x)) (s m) (eval (partial m a) s).
Proof.
  assert (V : forall b, eval b (put s m (s m)) = eval b s) by (intros b; apply eval_ext, put_same).
  induction a as [j|c|a IHa b IHb|a IHa b IHb|a IHa|a IHa|a IHa|i j k a IHa]; cbn [domain eval partial].
  - intros _. unfold put. destruct (Nat.eqb j m); [apply (is_derive_id (K := R_AbsRing))|apply (is_derive_const (V := R_NormedModule))].
  - intros _. apply (is_derive_const (V := R_NormedModule)).
  - intros [A B]. apply (is_derive_plus (V := R_NormedModule)); [now apply IHa|now apply IHb].
  - intros [A B]. evar_last; [apply (is_derive_mult (fun x => eval a (put s m x)) (fun x => eval b (put s m x))); [apply IHa, A|apply IHb, B|intros; apply Rmult_comm]|].
    unfold plus, mult; cbn. now rewrite !V.
  - intros [A N]. evar_last; [apply (is_derive_inv (fun x => eval a (put s m x))); [apply IHa, A|rewrite V; exact N]|]. rewrite V. field. exact N.
  - intros [A P]. evar_last; [apply (is_derive_comp sqrt (fun x => eval a (put s m x))); [|apply IHa, A]|].
    + rewrite V. apply is_derive_Reals. now apply derivable_pt_lim_sqrt.
    + unfold scal; cbn; unfold mult; cbn. pose proof (sqrt_lt_R0 _ P). field. lra.
  - intros A. evar_last; [apply (is_derive_comp atan (fun x => eval a (put s m x))); [|apply IHa, A]|].
    + rewrite V. apply is_derive_Reals. apply derivable_pt_lim_atan.
    + unfold scal; cbn; unfold mult; cbn. pose proof (pow2_ge_0 (eval a s)). unfold Rsqr. field. nra.
  - intros [A P]. evar_last; [apply (is_derive_comp (W i j k) (fun x => eval a (put s m x))); [rewrite V; apply HW, P|apply IHa, A]|].
    unfold scal; cbn; unfold mult; cbn. reflexivity.
Qed.
(* one variable at a point: epsilon and delta *)
Lemma through (h : R -> R) x : continuity_pt h x -> forall e, 0 < e -> exists r, 0 < r /\ forall y, Rabs (y - x) < r -> Rabs (h y - h x) < e.
Proof.
  intros C e He. destruct (C e He) as (r & Hr & H). exists r. split; [exact Hr|]. intros y Hy. destruct (Req_dec x y) as [<-|N]; [rewrite Rminus_eq_0, Rabs_R0; exact He|].
  apply H. split; [split; [exact I|exact N]|exact Hy].
Qed.
Lemma compose d (F : state -> R) (h : R -> R) s : (forall e, 0 < e -> exists r, 0 < r /\ forall q, near d s q r -> Rabs (F q - F s) < e) -> continuity_pt h (F s) ->
  forall e, 0 < e -> exists r, 0 < r /\ forall q, near d s q r -> Rabs (h (F q) - h (F s)) < e.
Proof. intros H C e He. destruct (through h _ C e He) as (r1 & P1 & H1). destruct (H r1 P1) as (r & Pr & Hr). exists r. split; [exact Pr|]. intros q Q. apply H1, Hr, Q. Qed.
Lemma eval_continuous d a s : domain d a s -> forall e, 0 < e -> exists r, 0 < r /\ forall q, near d s q r -> Rabs (eval a q - eval a s) < e.
Proof.
  induction a as [j|c|a IHa b IHb|a IHa b IHb|a IHa|a IHa|a IHa|i j k a IHa]; cbn [domain eval].
  - intros Hj e He. exists e. split; [exact He|]. intros q Q. now apply Q.
  - intros _ e He. exists 1. split; [lra|]. intros q _. now rewrite Rminus_eq_0, Rabs_R0.
  - intros [A B] e He. destruct (IHa A (e / 2) ltac:(lra)) as (r1 & P1 & H1). destruct (IHb B (e / 2) ltac:(lra)) as (r2 & P2 & H2). exists (Rmin r1 r2). split; [now apply Rmin_glb_lt|].
    intros q Q. assert (Q1 : near d s q r1) by (intros m Hm; eapply Rlt_le_trans; [apply Q, Hm|apply Rmin_l]). assert (Q2 : near d s q r2) by (intros m Hm; eapply Rlt_le_trans; [apply Q, Hm|apply Rmin_r]).
    specialize (H1 q Q1). specialize (H2 q Q2). apply Rabs_lt_between in H1. apply Rabs_lt_between in H2. apply Rabs_lt_between. lra.
  - intros [A B] e He. set (x := eval a s). set (y := eval b s). set (c := Rmin 1 (e / (Rabs x + Rabs y + 1))). pose proof (Rabs_pos x). pose proof (Rabs_pos y).
    assert (E0 : 0 < e / (Rabs x + Rabs y + 1)) by (apply Rdiv_lt_0_compat; lra). assert (C0 : 0 < c) by (unfold c; apply Rmin_glb_lt; lra).
    assert (C1 : c <= 1) by apply Rmin_l. assert (C2 : c * (Rabs x + Rabs y + 1) <= e).
    { apply Rle_trans with (e / (Rabs x + Rabs y + 1) * (Rabs x + Rabs y + 1)); [apply Rmult_le_compat_r; [lra|apply Rmin_r]|right; field; lra]. }
    destruct (IHa A c C0) as (r1 & P1 & H1). destruct (IHb B c C0) as (r2 & P2 & H2). exists (Rmin r1 r2). split; [now apply Rmin_glb_lt|].
    intros q Q. assert (Q1 : near d s q r1) by (intros m Hm; eapply Rlt_le_trans; [apply Q, Hm|apply Rmin_l]). assert (Q2 : near d s q r2) by (intros m Hm; eapply Rlt_le_trans; [apply Q, Hm|apply Rmin_r]).
    specialize (H1 q Q1). specialize (H2 q Q2). fold x in H1. fold y in H2. set (p := eval a q - x) in *. set (z := eval b q - y) in *.
    replace (eval a q * eval b q - x * y) with (p * z + (p * y + x * z)) by (unfold p, z; ring).
    eapply Rle_lt_trans; [apply Rabs_triang|]. eapply Rle_lt_trans; [apply Rplus_le_compat_l, Rabs_triang|]. rewrite !Rabs_mult. pose proof (Rabs_pos p). pose proof (Rabs_pos z).
    apply Rlt_le_trans with (c * (Rabs x + Rabs y + 1)); [|exact C2].
    assert (Rabs p * Rabs z <= Rabs p * 1) by (apply Rmult_le_compat_l; lra). assert (Rabs p * Rabs y <= c * Rabs y) by (apply Rmult_le_compat_r; lra). assert (Rabs x * Rabs z <= Rabs x * c) by (apply Rmult_le_compat_l; lra). lra.
  - intros [A N]. apply (compose d (eval a) Rinv s (IHa A)). apply continuity_pt_inv; [apply derivable_continuous_pt, derivable_pt_id|exact N].
  - intros [A P]. apply (compose d (eval a) sqrt s (IHa A)). now apply continuity_pt_sqrt, Rlt_le.
  - intros A. apply (compose d (eval a) atan s (IHa A)). apply derivable_continuous_pt, derivable_pt_atan.
  - intros [A P]. apply (compose d (eval a) (W i j k) s (IHa A)). apply continuity_pt_filterlim. apply (ex_derive_continuous (V := R_NormedModule)). eexists. now apply HW.
Qed.
Lemma eval_smooth d (U : state -> Prop) a : (forall s, U s -> domain d a s) -> smooth_on d U (eval a).
Proof.
  intros H k. revert a H. induction k as [|k IH]; intros a H; cbn [differentiable].
  - intros s Us. apply eval_continuous, H, Us.
  - split; [intros s Us; apply eval_continuous, H, Us|]. intros m Hm. exists (eval (partial m a)). split.
    + intros s Us. apply (partial_correct d), H, Us.
    + apply IH. intros s Us. apply partial_domain, H, Us.
Qed.
End Expressions.
Lemma along d U s m : open_set d U -> U s -> locally (s m) (fun x => U (put s m x)).
Proof.
  intros O Us. destruct (O s Us) as (e & He & H). exists (mkposreal e He). intros x Hx. apply H. intros j _. unfold put. destruct (Nat.eqb_spec j m) as [->|]; [exact Hx|]. rewrite Rminus_eq_0, Rabs_R0. exact He.
Qed.
Lemma differentiable_ext k d U F G : open_set d U -> (forall s, U s -> F s = G s) -> differentiable k d U F -> differentiable k d U G.
Proof.
  intros O E. assert (C : continuous_on d U F -> continuous_on d U G).
  { intros H s Us e He. destruct (O s Us) as (e1 & P1 & H1). destruct (H s Us e He) as (r & Pr & Hr). exists (Rmin r e1). split; [now apply Rmin_glb_lt|]. intros q Q.
    assert (Q1 : near d s q r) by (intros m Hm; eapply Rlt_le_trans; [apply Q, Hm|apply Rmin_l]). assert (Q2 : near d s q e1) by (intros m Hm; eapply Rlt_le_trans; [apply Q, Hm|apply Rmin_r]).
    rewrite <- !E by (try exact Us; now apply H1). now apply Hr. }
  destruct k as [|k]; cbn [differentiable]; [exact C|]. intros [A B]. split; [now apply C|]. intros m Hm. destruct (B m Hm) as (D & D1 & D2). exists D. split; [|exact D2].
  intros s Us. apply (is_derive_ext_loc (fun x => F (put s m x))); [|now apply D1]. generalize (along d U s m O Us). apply filter_imp. intros x Ux. now apply E.
Qed.

(* ---- the laws ---- *)
Definition place (s : state) (i : nat) : C := (s (4 * i)%nat, s (4 * i + 1)%nat).
Definition velocity (s : state) (i : nat) : C := (s (4 * i + 2)%nat, s (4 * i + 3)%nat).
(* (2) *)
Definition heading (s : state) (i : nat) : R := arctan2 (snd (velocity s i)) (fst (velocity s i)).
Definition regular n (adj : graph) (s : state) : Prop := (forall i, (i < n)%nat -> ~ (snd (velocity s i) = 0 /\ fst (velocity s i) <= 0)) /\
  forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> place s i <> place s j.
Lemma squares_pos a b : a <> 0 \/ b <> 0 -> 0 < a * a + b * b.
Proof. pose proof (Rle_0_sqr a) as A. pose proof (Rle_0_sqr b) as B. intros [H|H]; apply Rsqr_pos_lt in H; unfold Rsqr in *; lra. Qed.
Lemma half_angle x y : ~ (y = 0 /\ x <= 0) -> 0 < sqrt (x * x + y * y) + x /\ 2 * atan (y * / (sqrt (x * x + y * y) + x)) = arctan2 y x.
Proof.
  intros N. set (r := sqrt (x * x + y * y)). assert (Q : 0 <= x * x + y * y) by nra. assert (R2 : r * r = x * x + y * y) by (apply sqrt_sqrt; exact Q). assert (R0 : 0 <= r) by apply sqrt_pos.
  assert (P : 0 < r + x).
  { destruct (Rle_or_lt (r + x) 0) as [L|L]; [|exact L]. exfalso. apply N. assert (x <= 0) by lra. assert (r * r <= x * x) by nra. split; [nra|assumption]. }
  split; [exact P|]. set (t := y * / (r + x)). assert (Nz : ((x, y) : C) <> RtoC 0) by (intros E; injection E as E1 E2; apply N; lra).
  apply (angle_unique (x, y) _ _ Nz); [|exact (proj1 (arctan2_angle (x, y) Nz))].
  assert (M : Cmod (x, y) = r) by (unfold Cmod, r; cbn [fst snd]; f_equal; ring).
  assert (Rp : 0 < r) by (rewrite <- M; now apply Cmod_gt_0).
  pose proof (atan_bound t) as B. split; [lra|]. rewrite M. cbn [fst snd]. rewrite cos_2a, sin_2a, cos_atan, sin_atan.
  assert (T : 1 + t² = 2 * r / (r + x)) by (unfold t, Rsqr; apply (Rmult_eq_reg_r ((r + x) * (r + x))); [field_simplify; [nra|lra|lra]|nra]).
  assert (S0 : 0 < 1 + t²) by (pose proof (Rle_0_sqr t); lra). pose proof (sqrt_sqrt (1 + t²) (Rlt_le _ _ S0)) as S1. pose proof (sqrt_lt_R0 _ S0) as S2. set (q := sqrt (1 + t²)) in *.
  assert (E1 : 1 / q * (1 / q) = (r + x) / (2 * r)) by (replace (1 / q * (1 / q)) with (/ (q * q)) by (field; lra); rewrite S1, T; field; lra).
  assert (Y : t * (r + x) = y) by (unfold t; field; lra).
  split.
  - replace (t / q * (t / q)) with (t * t * (1 / q * (1 / q))) by (field; lra). rewrite E1. assert (T2 : t * t = 2 * r / (r + x) - 1) by (rewrite <- T; unfold Rsqr; ring). rewrite T2. field. lra.
  - replace (2 * (t / q) * (1 / q)) with (2 * t * (1 / q * (1 / q))) by (field; lra). rewrite E1. rewrite <- Y. field. lra.
Qed.
Section Laws.
Variables (n : nat) (adj : graph).
Fixpoint ESum (p : nat) (f : nat -> expr) : expr := match p with O => Const 0 | S p => Plus (ESum p f) (f p) end.
Definition Minus (a b : expr) : expr := Plus a (Times (Const (-1)) b).
Definition dx i j := Minus (Coord (4 * i)) (Coord (4 * j)).
Definition dy i j := Minus (Coord (4 * i + 1)) (Coord (4 * j + 1)).
Definition square i j := Plus (Times (dx i j) (dx i j)) (Times (dy i j) (dy i j)).
Definition angle i := let x := Coord (4 * i + 2) in let y := Coord (4 * i + 3) in
  Times (Const 2) (Atan (Times y (Inverse (Plus (Root (Plus (Times x x) (Times y y))) x)))).
Definition turning i := ESum n (fun j => if adj i j then Times (Minus (angle i) (angle j)) (Inverse (square i j)) else Const 0).
Definition push (c : nat -> nat -> expr) i := ESum n (fun j => if adj i j then Times (Times (Pot i j 0 (Root (square i j))) (Inverse (Root (square i j)))) (c i j) else Const 0).
Definition law_x i := Plus (Times (Const (-1)) (push dx i)) (Times (turning i) (Coord (4 * i + 3))).
Definition law_y i := Plus (Times (Const (-1)) (push dy i)) (Times (Times (Const (-1)) (turning i)) (Coord (4 * i + 2))).
Variable W : nat -> nat -> nat -> R -> R.
Notation eval := (eval W).
Notation domain := (domain W).
Notation d := (4 * n)%nat.
Lemma ESum_eval p f s : eval (ESum p f) s = Sum p (fun j => eval (f j) s).
Proof. induction p as [|p IH]; [reflexivity|]. cbn. now rewrite IH. Qed.
Lemma ESum_domain p f s : (forall j, (j < p)%nat -> domain d (f j) s) -> domain d (ESum p f) s.
Proof. induction p as [|p IH]; intros H; cbn; [exact I|]. split; [apply IH; intros; apply H; lia|apply H; lia]. Qed.
Lemma square_eval i j s : eval (square i j) s = (s (4 * i)%nat - s (4 * j)%nat) * (s (4 * i)%nat - s (4 * j)%nat) + (s (4 * i + 1)%nat - s (4 * j + 1)%nat) * (s (4 * i + 1)%nat - s (4 * j + 1)%nat).
Proof. cbn [square eval dx dy Minus tanner1_smooth.eval]. ring. Qed.
Lemma norm_is i j s : norm (place s i - place s j)%C = sqrt (eval (square i j) s).
Proof. rewrite square_eval. unfold norm, Cmod, place. cbn [fst snd Cminus Cplus Copp]. f_equal. ring. Qed.
Section At.
Variable s : state.
Hypothesis G : regular n adj s.
Lemma square_pos i j : (i < n)%nat -> (j < n)%nat -> adj i j = true -> 0 < eval (square i j) s.
Proof.
  intros Hi Hj A. rewrite square_eval. destruct G as [_ P]. specialize (P i j Hi Hj A). apply squares_pos. destruct (Req_dec (s (4 * i)%nat - s (4 * j)%nat) 0) as [E|E]; [right|now left].
  intros F. apply P. unfold place. f_equal; lra.
Qed.
Lemma angle_good i : (i < n)%nat -> domain d (angle i) s /\ eval (angle i) s = heading s i.
Proof.
  intros Hi. destruct G as [P _]. specialize (P i Hi). unfold velocity in P. cbn [fst snd] in P. destruct (half_angle (s (4 * i + 2)%nat) (s (4 * i + 3)%nat) P) as [A B].
  split; [|exact B]. cbn [angle tanner1_smooth.domain tanner1_smooth.eval]. repeat split; try lia; [|lra].
  set (x := s (4 * i + 2)%nat) in *. set (y := s (4 * i + 3)%nat) in *. apply squares_pos. destruct (Req_dec y 0) as [E|E]; [left|now right]. intros F. apply P. lra.
Qed.
Lemma turning_good i : (i < n)%nat -> domain d (turning i) s /\ eval (turning i) s = align n adj (place s) (heading s) i.
Proof.
  intros Hi. split.
  - apply ESum_domain. intros j Hj. destruct (adj i j) eqn:A; [|exact I]. destruct (angle_good i Hi) as [D1 _]. destruct (angle_good j Hj) as [D2 _]. pose proof (square_pos i j Hi Hj A) as P.
    cbn [Minus tanner1_smooth.domain]. split; [split; [exact D1|split; [exact I|exact D2]]|]. split; [|lra]. cbn. repeat split; lia.
  - unfold turning, align. rewrite ESum_eval. apply Sum_ext. intros j Hj. unfold w. destruct (adj i j) eqn:A; [|cbn; ring]. pose proof (square_pos i j Hi Hj A) as P.
    cbn [Minus tanner1_smooth.eval]. destruct (angle_good i Hi) as [_ ->]. destruct (angle_good j Hj) as [_ ->]. rewrite norm_is, pow2_sqrt by lra. unfold Rdiv. ring.
Qed.
Variables V' : nat -> nat -> R -> R.
Hypothesis HV : forall i j x, (i < n)%nat -> (j < n)%nat -> adj i j = true -> 0 < x -> V' i j x = W i j 0 x.
Lemma push_good c i : (i < n)%nat -> (forall j, (j < n)%nat -> domain d (c i j) s) -> domain d (push c i) s /\
  eval (push c i) s = Sum n (fun j => w adj i j * (V' i j (norm (place s i - place s j)%C) / norm (place s i - place s j)%C * eval (c i j) s)).
Proof.
  intros Hi Hc. split.
  - apply ESum_domain. intros j Hj. destruct (adj i j) eqn:A; [|exact I]. pose proof (square_pos i j Hi Hj A) as P. pose proof (sqrt_lt_R0 _ P) as P2.
    assert (D : domain d (square i j) s) by (cbn; repeat split; lia). cbn [tanner1_smooth.domain]. change (tanner1_smooth.domain W d (square i j) s) with (domain d (square i j) s). fold (domain d (square i j) s).
    assert (Q : eval (Root (square i j)) s <> 0) by (cbn [tanner1_smooth.eval]; lra). exact (conj (conj (conj (conj D P) P2) (conj (conj D P) Q)) (Hc j Hj)).
  - unfold push. rewrite ESum_eval. apply Sum_ext. intros j Hj. unfold w. destruct (adj i j) eqn:A; [|cbn; ring]. pose proof (square_pos i j Hi Hj A) as P. pose proof (sqrt_lt_R0 _ P) as P2.
    rewrite norm_is, (HV i j _ Hi Hj A P2). cbn [tanner1_smooth.eval]. unfold Rdiv. ring.
Qed.
Lemma law_good i : (i < n)%nat -> (domain d (law_x i) s /\ domain d (law_y i) s) /\
  eval (law_x i) s = fst (accel n adj V' (place s) (velocity s) (heading s) i) /\ eval (law_y i) s = snd (accel n adj V' (place s) (velocity s) (heading s) i).
Proof.
  intros Hi. destruct (turning_good i Hi) as [T1 T2]. assert (Dx : forall j, (j < n)%nat -> domain d (dx i j) s) by (intros; cbn; repeat split; lia). assert (Dy : forall j, (j < n)%nat -> domain d (dy i j) s) by (intros; cbn; repeat split; lia).
  destruct (push_good dx i Hi Dx) as [X1 X2]. destruct (push_good dy i Hi Dy) as [Y1 Y2]. split.
  - cbn [law_x law_y tanner1_smooth.domain]. repeat split; try assumption; lia.
  - cbn [law_x law_y tanner1_smooth.eval]. rewrite X2, Y2, T2. unfold accel, gyro, grad_i, pair_grad, grad, Csum, velocity. cbn [fst snd Cmult Cplus Copp RtoC Ci].
    split.
    + match goal with |- -1 * Sum n ?F + _ = - Sum n ?F' + _ => rewrite (Sum_ext n F F') end; [ring|]. intros j _. cbn. ring.
    + match goal with |- -1 * Sum n ?F + _ = - Sum n ?F' + _ => rewrite (Sum_ext n F F') end; [ring|]. intros j _. cbn. ring.
Qed.
End At.
End Laws.
Lemma all_near p (P : nat -> R -> Prop) : (forall i e e', P i e -> e' <= e -> P i e') -> (forall i, (i < p)%nat -> exists e, 0 < e /\ P i e) -> exists e, 0 < e /\ forall i, (i < p)%nat -> P i e.
Proof.
  intros M. induction p as [|p IH]; intros H; [exists 1; split; [lra|intros; lia]|]. destruct (IH (fun i Hi => H i ltac:(lia))) as (e & He & Q). destruct (H p ltac:(lia)) as (r & Hr & B).
  exists (Rmin e r). split; [now apply Rmin_glb_lt|]. intros i Hi. destruct (Nat.eq_dec i p) as [->|N]; [apply (M p r _ B), Rmin_r|apply (M i e _ (Q i ltac:(lia))), Rmin_l].
Qed.
Lemma regular_open n adj : open_set (4 * n) (regular n adj).
Proof.
  intros s G. pose (W := fun (_ _ _ : nat) (_ : R) => 0). assert (HW : forall i j k x, 0 < x -> is_derive (W i j k) x (W i j (S k) x)) by (intros; apply (is_derive_const (V := R_NormedModule))).
  assert (Shrink : forall (F : state -> Prop) e e', (forall q, near (4 * n) s q e -> F q) -> e' <= e -> forall q, near (4 * n) s q e' -> F q).
  { intros F e e' H L q Q. apply H. intros m Hm. eapply Rlt_le_trans; [apply Q, Hm|exact L]. }
  assert (Keep : forall a, domain W (4 * n) a s -> 0 < eval W a s -> exists e, 0 < e /\ forall q, near (4 * n) s q e -> 0 < eval W a q).
  { intros a D P. destruct (eval_continuous W HW (4 * n) a s D _ P) as (r & Pr & H). exists r. split; [exact Pr|]. intros q Q. specialize (H q Q). apply Rabs_lt_between in H. lra. }
  destruct (all_near n (fun i e => forall q, near (4 * n) s q e -> ~ (snd (velocity q i) = 0 /\ fst (velocity q i) <= 0))) as (e1 & P1 & H1).
  - intros i e e' H. exact (Shrink _ e e' H).
  - intros i Hi. set (x := Coord (4 * i + 2)). set (y := Coord (4 * i + 3)). destruct G as [A _]. specialize (A i Hi). unfold velocity in A. cbn [fst snd] in A. destruct (half_angle _ _ A) as [B _].
    destruct (Keep (Plus (Root (Plus (Times x x) (Times y y))) x)) as (e & He & H).
    + unfold x, y. cbn [domain eval]. repeat split; try lia. apply squares_pos. destruct (Req_dec (s (4 * i + 3)%nat) 0) as [E|E]; [left|now right]. intros F. apply A. lra.
    + exact B.
    + exists e. split; [exact He|]. intros q Q [Z L]. specialize (H q Q). unfold x, y in H. cbn [eval] in H. unfold velocity in Z, L. cbn [fst snd] in Z, L. rewrite Z in H.
      replace (q (4 * i + 2)%nat * q (4 * i + 2)%nat + 0 * 0) with ((- q (4 * i + 2)%nat) ^ 2) in H by ring. rewrite sqrt_pow2 in H by lra. lra.
  - destruct (all_near n (fun i e => forall q, near (4 * n) s q e -> forall j, (j < n)%nat -> adj i j = true -> place q i <> place q j)) as (e2 & P2 & H2).
    + intros i e e' H. exact (Shrink _ e e' H).
    + intros i Hi. destruct (all_near n (fun j e => forall q, near (4 * n) s q e -> adj i j = true -> place q i <> place q j)) as (e & He & H).
      * intros j e e' H. exact (Shrink _ e e' H).
      * intros j Hj. destruct (adj i j) eqn:A; [|exists 1; split; [lra|discriminate]]. pose proof (square_pos n adj W s G i j Hi Hj A) as P.
        destruct (Keep (square i j)) as (e & He & H); [cbn; repeat split; lia|exact P|]. exists e. split; [exact He|]. intros q Q _ E. specialize (H q Q). rewrite square_eval in H.
        pose proof (f_equal fst E) as E1. pose proof (f_equal snd E) as E2. unfold place in E1, E2. cbn [fst snd] in E1, E2. rewrite E1, E2 in H. lra.
      * exists e. split; [exact He|]. intros q Q j Hj. now apply H.
    + exists (Rmin e1 e2). split; [now apply Rmin_glb_lt|]. intros q Q. split.
      * intros i Hi. apply (H1 i Hi). intros m Hm. eapply Rlt_le_trans; [apply Q, Hm|apply Rmin_l].
      * intros i j Hi Hj. apply (H2 i Hi); [intros m Hm; eapply Rlt_le_trans; [apply Q, Hm|apply Rmin_r]|exact Hj].
Qed.
(* potentials with derivatives of all orders at distances above 0: W i j k is the k-th one *)
Theorem laws_smooth n adj V V' (W : nat -> nat -> nat -> R -> R) :
  (forall i j x, (i < n)%nat -> (j < n)%nat -> adj i j = true -> 0 < x -> W i j 0%nat x = V i j x /\ is_derive (V i j) x (V' i j x) /\ forall k, is_derive (W i j k) x (W i j (S k) x)) ->
  open_set (4 * n) (regular n adj) /\ forall i, (i < n)%nat ->
    smooth_on (4 * n) (regular n adj) (fun s => fst (accel n adj V' (place s) (velocity s) (heading s) i)) /\
    smooth_on (4 * n) (regular n adj) (fun s => snd (accel n adj V' (place s) (velocity s) (heading s) i)).
Proof.
  intros H. split; [apply regular_open|].
  set (D := fun i j k => if (Nat.ltb i n && Nat.ltb j n && adj i j)%bool then W i j (S k) else fun _ => 0).
  assert (On : forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> (Nat.ltb i n && Nat.ltb j n && adj i j)%bool = true).
  { intros i j Hi Hj A. apply Nat.ltb_lt in Hi. apply Nat.ltb_lt in Hj. now rewrite Hi, Hj, A. }
  assert (HD : forall i j k x, 0 < x -> is_derive (D i j k) x (D i j (S k) x)).
  { intros i j k x Hx. unfold D. destruct (Nat.ltb i n && Nat.ltb j n && adj i j)%bool eqn:E; [|apply (is_derive_const (V := R_NormedModule))].
    apply andb_prop in E. destruct E as [E A]. apply andb_prop in E. destruct E as [Ei Ej]. apply Nat.ltb_lt in Ei. apply Nat.ltb_lt in Ej. now apply (H i j x Ei Ej A Hx). }
  assert (HV : forall i j x, (i < n)%nat -> (j < n)%nat -> adj i j = true -> 0 < x -> V' i j x = D i j 0%nat x).
  { intros i j x Hi Hj A Hx. unfold D. rewrite (On i j Hi Hj A). destruct (H i j x Hi Hj A Hx) as (_ & DV & DW).
    transitivity (Derive (V i j) x); [symmetry; now apply is_derive_unique|]. rewrite <- (is_derive_unique _ _ _ (DW 0%nat)). apply Derive_ext_loc.
    exists (mkposreal x Hx). intros y Hy. symmetry. apply (H i j y Hi Hj A). unfold ball in Hy. cbn in Hy. unfold AbsRing_ball, abs, minus, plus, opp in Hy. cbn in Hy. apply Rabs_lt_between in Hy. lra. }
  intros i Hi. pose proof (fun s G => law_good n adj D s G V' HV i Hi) as L.
  split; intros k.
  - apply (differentiable_ext k _ _ (eval D (law_x n adj i))); [apply regular_open|intros s G; apply (L s G)|]. apply eval_smooth; [exact HD|]. intros s G. apply (L s G).
  - apply (differentiable_ext k _ _ (eval D (law_y n adj i))); [apply regular_open|intros s G; apply (L s G)|]. apply eval_smooth; [exact HD|]. intros s G. apply (L s G).
Qed.
