(* Paley et al., the fish model: what moving along the corrected behaviour fields does, and what (27) steers towards.
     beyond.paley.vrep, beyond.paley.vatt (all clauses, any number of neighbours). *)
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
