(* Paley et al., the fish model: what moving along the corrected behaviour fields does, and what (27) steers towards.
     beyond.paley.vrep, beyond.paley.vatt, beyond.paley.eq28 (all clauses, any number of neighbours). *)
From Coq Require Import Reals Lra Lia Psatz.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums paley_model paley_phase paley_laplacian paley_gradient paley_particles paley_fish tanner_energy.
Open Scope R_scope.

(* the sum of rhat_kj over the neighbours, and the sum of the distances to them after a way s in the direction e *)
Definition outward (n : nat) (nbr : nat -> bool) (r : nat -> C) (k : nat) : C :=
  Csum n (fun j => RtoC (if nbr j then 1 else 0) * unit_from (r k) (r j))%C.
Definition distances (n : nat) (nbr : nat -> bool) (r : nat -> C) (k : nat) (e : C) (s : R) : R :=
  Sum n (fun j => (if nbr j then 1 else 0) * Cmod (r k + RtoC s * e - r j)%C).

Lemma distances_rate n nbr r k e : (forall j, (j < n)%nat -> nbr j = true -> r j <> r k) ->
  is_derive (distances n nbr r k e) 0 (inner e (outward n nbr r k)).
Proof.
  intros N. unfold outward. rewrite inner_Csum.
  apply (D_Sum n (fun j s => (if nbr j then 1 else 0) * Cmod (r k + RtoC s * e - r j)%C)). intros j Hj.
  destruct (nbr j) eqn:B.
  - assert (K : r k <> r j) by (intros E; now apply (N j Hj B)).
    pose proof (proj1 (tanner1_eq8_gradients (fun s => s) (fun _ => 1) (r k) (r j) e K (D_id _))) as D.
    apply (is_derive_ext (fun s => norm (r k + RtoC s * e - r j)%C)); [intros s; symmetry; apply Rmult_1_l|].
    eapply D_eq; [exact D|]. unfold grad, unit_from, norm. rewrite (inner_sym _ e).
    f_equal. unfold Rdiv. rewrite Rmult_1_l, Cmult_1_l. reflexivity.
  - apply (is_derive_ext (fun _ => 0)); [intros s; symmetry; apply Rmult_0_l|]. eapply D_eq; [apply D_const|].
    rewrite Cmult_0_l. rewrite inner_xy. cbn. ring.
Qed.

(* (27) turns the heading towards a fixed field v *)
Lemma turning v K (th : R -> R) t : is_derive th t (K * inner (Ci * expi (th t))%C v) ->
  is_derive (fun s => inner (expi (th s)) v) t (K * inner (Ci * expi (th t))%C v ^ 2).
Proof.
  intros D. apply (is_derive_ext (fun s => fst v * cos (th s) + snd v * sin (th s))).
  { intros s. rewrite inner_xy. cbn. ring. }
  eapply D_eq; [apply D_plus; apply D_scal; [apply D_cos|apply D_sin]; exact D|]. rewrite inner_xy. cbn. ring.
Qed.
Lemma turns_towards v K (th : R -> R) a b : 0 < K -> a <= b ->
  (forall t, a <= t <= b -> is_derive th t (K * inner (Ci * expi (th t))%C v)) -> inner (expi (th a)) v <= inner (expi (th b)) v.
Proof.
  intros HK Hab H. destruct (Req_dec a b) as [->|N]; [lra|].
  destruct (MVT_gen (fun s => inner (expi (th s)) v) a b (fun t => K * inner (Ci * expi (th t))%C v ^ 2)) as [c [_ E]].
  - intros x Hx. rewrite Rmin_left, Rmax_right in Hx by lra. apply turning, H. lra.
  - intros x Hx. rewrite Rmin_left, Rmax_right in Hx by lra. apply continuity_pt_filterlim, (ex_derive_continuous (fun s => inner (expi (th s)) v)).
    eexists. apply turning, H. lra.
  - cbv beta in E. assert (0 <= K * inner (Ci * expi (th c))%C v ^ 2 * (b - a)); [|lra].
    apply Rmult_le_pos; [apply Rmult_le_pos; [lra|apply pow2_ge_0]|lra].
Qed.

Theorem repulsion n nbr r k : (forall j, (j < n)%nat -> nbr j = true -> r j <> r k) ->
  let v := Csum n (fun j => RtoC (if nbr j then 1 else 0) * unit_from (r k) (r j))%C in
  is_derive (fun s => Sum n (fun j => (if nbr j then 1 else 0) * Cmod (r k + RtoC s * v - r j)%C)) 0 (Cmod v ^ 2) /\
  forall K th a b, 0 < K -> a <= b -> (forall t, a <= t <= b -> is_derive th t (K * inner (Ci * expi (th t))%C v)) ->
    inner (expi (th a)) v <= inner (expi (th b)) v.
Proof.
  intros N v. split; [|intros K th a b; apply turns_towards].
  eapply D_eq; [apply (distances_rate n nbr r k v N)|]. apply inner_self.
Qed.
Theorem attraction n nbr r k : (forall j, (j < n)%nat -> nbr j = true -> r j <> r k) ->
  let v := (- Csum n (fun j => RtoC (if nbr j then 1 else 0) * unit_from (r k) (r j)))%C in
  is_derive (fun s => Sum n (fun j => (if nbr j then 1 else 0) * Cmod (r k + RtoC s * v - r j)%C)) 0 (- Cmod v ^ 2) /\
  forall K th a b, 0 < K -> a <= b -> (forall t, a <= t <= b -> is_derive th t (K * inner (Ci * expi (th t))%C v)) ->
    inner (expi (th a)) v <= inner (expi (th b)) v.
Proof.
  intros N v. split; [|intros K th a b; apply turns_towards].
  eapply D_eq; [apply (distances_rate n nbr r k v N)|]. unfold v, outward. set (u := Csum n _).
  rewrite Cmod_opp, <- inner_self, !inner_xy. cbn. ring.
Qed.

(* ---- (28) with the right sign ---- *)
Definition v_ori (n : nat) (nbr : nat -> bool) (th : nat -> R) (k : nat) : C :=
  (expi (th k) + Csum n (fun j => RtoC (if nbr j then 1 else 0) * expi (th j)))%C.
Definition behaviour (wk Krep Kori Katt : R) (z rep ori att : C) : R :=
  wk + inner (Ci * z)%C (RtoC Krep * rep + RtoC Kori * ori + RtoC Katt * att)%C.                     (* (27) *)
(* the field of attraction with r_kj in the place of rhat_kj *)
Definition v_att_plain (n : nat) (nbr : nat -> bool) (r : nat -> C) (k : nat) : C :=
  (- Csum n (fun j => RtoC (if nbr j then 1 else 0) * (r k - r j)))%C.
Lemma orientation_term n ori th k : (k < n)%nat ->
  inner (Ci * expi (th k))%C (v_ori n (ori k) th k) = - inner (Ci * expi (th k))%C (row n (lap n ori) k (phasors th)) /\
  inner (Ci * expi (th k))%C (v_ori n (ori k) th k) = inner (Ci * expi (th k))%C (Csum n (fun j => RtoC (w ori k j) * expi (th j))%C).
Proof.
  intros Hk. assert (Z : inner (Ci * expi (th k))%C (expi (th k)) = 0) by (rewrite inner_xy; cbn; ring).
  unfold v_ori. rewrite inner_plus, Z, Rplus_0_l. split; [|reflexivity].
  rewrite row_lap, !inner_Csum, <- Sum_opp by assumption. apply Sum_ext; intros j _. unfold w, phasors. rewrite !inner_scal, inner_minus, Z. ring.
Qed.
Theorem eq28_corrected n (rep : nat -> bool) (ori att : graph) r th wk Krep Kori Katt k : (k < n)%nat -> (forall j, (j < n)%nat -> rep j = false) ->
  behaviour wk Krep Kori Katt (expi (th k)) (v_rep n rep r k) (v_ori n (ori k) th k) (v_att_plain n (att k) r k) =
  wk - Kori * inner (Ci * expi (th k))%C (row n (lap n ori) k (phasors th)) - Katt * inner (Ci * expi (th k))%C (row n (lap n att) k r).
Proof.
  intros Hk E. assert (R0 : v_rep n rep r k = RtoC 0).
  { unfold v_rep, Csum. apply injective_projections; cbn [fst snd Copp RtoC]; rewrite Sum_zero; try ring; intros j Hj; rewrite (E j Hj); cbn; ring. }
  unfold behaviour. rewrite R0, !inner_plus, !inner_scal, (proj1 (orientation_term n ori th k Hk)).
  assert (A : v_att_plain n (att k) r k = (- row n (lap n att) k r)%C) by (rewrite row_lap by exact Hk; reflexivity).
  rewrite A. generalize (row n (lap n att) k r). intros x. rewrite !inner_xy. cbn. ring.
Qed.
(* both terms turn the heading towards the field that they name, as long as it is fixed *)
Theorem eq28_steers n (ori att : graph) r th K k : (k < n)%nat ->
  let s := Csum n (fun j => RtoC (w att k j) * (r j - r k))%C in let m := Csum n (fun j => RtoC (w ori k j) * expi (th j))%C in
  - K * inner (Ci * expi (th k))%C (row n (lap n att) k r) = K * inner (Ci * expi (th k))%C s /\
  - K * inner (Ci * expi (th k))%C (row n (lap n ori) k (phasors th)) = K * inner (Ci * expi (th k))%C m /\
  forall (v : C) (ph : R -> R) t, v = s \/ v = m -> 0 < K -> is_derive ph t (K * inner (Ci * expi (ph t))%C v) ->
    exists d, is_derive (fun x => inner (expi (ph x)) v) t d /\ 0 <= d /\ (inner (Ci * expi (ph t))%C v <> 0 -> 0 < d).
Proof.
  intros Hk s m. split; [|split].
  - rewrite (eq28_attraction_sign n att r (th k) k Hk). fold s. ring.
  - destruct (orientation_term n ori th k Hk) as [A B]. rewrite A in B. fold m in B. rewrite <- B. ring.
  - intros v ph t _ HK D. exists (K * inner (Ci * expi (ph t))%C v ^ 2). split; [now apply turning|]. pose proof (pow2_ge_0 (inner (Ci * expi (ph t))%C v)) as Q.
    split; [nra|]. intros N. apply Rmult_lt_0_compat; [exact HK|]. destruct Q as [Q|Q]; [exact Q|]. exfalso. apply N. symmetry in Q. cbn in Q. rewrite Rmult_1_r in Q. now apply Rmult_integral in Q as [|].
Qed.
(* the field with rhat_kj is the one with r_kj if the neighbours are at the distance 1, and in general it is not *)
Lemma eq28_unit_distance n (att : nat -> bool) r k : (forall j, (j < n)%nat -> att j = true -> Cmod (r k - r j)%C = 1) ->
  (- v_att n att r k)%C = v_att_plain n att r k.
Proof.
  intros H. unfold v_att, v_att_plain. f_equal. unfold Csum, unit_from. f_equal; apply Sum_ext; intros j Hj; destruct (att j) eqn:A; cbn -[Cmod]; try ring; rewrite (H j Hj A); field.
Qed.
Lemma eq28_other_distance : exists (r : nat -> C) (att : nat -> bool) (th : nat -> R), r 0%nat <> r 1%nat /\
  behaviour 0 0 0 1 (expi (th 0%nat)) (RtoC 0) (RtoC 0) (- v_att 2 att r 0)%C = 1 /\ behaviour 0 0 0 1 (expi (th 0%nat)) (RtoC 0) (RtoC 0) (v_att_plain 2 att r 0) = 2.
Proof.
  exists (fun j => match j with O => RtoC 0 | _ => (0, 2) end), (fun j => Nat.eqb j 1), (fun _ => 0).
  assert (N : Cmod (RtoC 0 - (0, 2))%C = 2).
  { unfold Cmod; cbn. replace ((0 + - 0) * ((0 + - 0) * 1) + (0 + - (2)) * ((0 + - (2)) * 1)) with (2 * 2) by ring. apply sqrt_square. lra. }
  split; [intros E; injection E as E; lra|]. unfold behaviour, v_att, v_att_plain, Csum, unit_from. cbn [Sum Nat.eqb]. rewrite N, !inner_xy. cbn -[Cmod]. rewrite cos_0, sin_0. generalize (/ Cmod (0 - 0)%C). intros c. split; [field|ring].
Qed.
Theorem eq28_distances :
  (forall n (att : nat -> bool) r th wk Krep Kori Katt rep ori k, (forall j, (j < n)%nat -> att j = true -> Cmod (r k - r j)%C = 1) ->
    behaviour wk Krep Kori Katt (expi (th k)) rep ori (- v_att n att r k)%C = behaviour wk Krep Kori Katt (expi (th k)) rep ori (v_att_plain n att r k)) /\
  exists (r : nat -> C) (att : nat -> bool) (th : nat -> R), r 0%nat <> r 1%nat /\
    behaviour 0 0 0 1 (expi (th 0%nat)) (RtoC 0) (RtoC 0) (- v_att 2 att r 0)%C <> behaviour 0 0 0 1 (expi (th 0%nat)) (RtoC 0) (RtoC 0) (v_att_plain 2 att r 0).
Proof.
  split; [intros; f_equal; now apply eq28_unit_distance|]. destruct eq28_other_distance as (r & att & th & N & A & B). exists r, att, th. split; [exact N|].
  rewrite A, B. lra.
Qed.
