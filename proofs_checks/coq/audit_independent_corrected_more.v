(* More clauses, most of them corrected ones, formalised from their words before the theorems were looked at. *)
From Coq Require Import Reals Lra Lia List Relations Psatz.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums paley_model paley_phase paley_laplacian paley_gradient paley_particles tanner_energy tanner_flock.
From Flockproof Require tanner_graph audit_independent_angle audit_independent_tanner1 audit_independent_veerman.
Module A := audit_independent_angle.
Module T1 := audit_independent_tanner1.
Module V := audit_independent_veerman.
Open Scope R_scope.

(* ======== Chazelle, in real numbers ======== *)
(* chazelle.epsineq clause 1 *)
Definition epsineq_1 : Prop := forall nu : nat, (1 <= nu)%nat -> exp (- (INR nu ^ (nu ^ 2))) < / INR nu ^ (nu ^ 4).
(* chazelle.eq3.15 clause 1; the lifted x_i(t), v_i(t) and w, and one constant for all flocks and times *)
Definition eq3_15_1 : Prop := exists B, forall (d : nat) (x v : nat -> R) (t : nat), (1 <= t)%nat ->
  let x' := A.lift d x (INR t) in let v' := A.lift d v 1 in let w k := x' k / INR t in
  (exists k, (k < S d)%nat /\ v' k <> w k) ->
  Rabs (A.angle_of (S d) x' v' / A.length_of (S d) (fun k => v' k - w k)) <= B.

(* ======== Tanner ======== *)
(* tanner1.L.ones clause 2 *)
Definition L_ones_2 : Prop := forall n adj, undirected adj -> no_loops adj -> strongly_connected n adj -> forall x : nat -> R,
  (exists i, (i < n)%nat /\ x i <> 0) ->
  ((forall i, (i < n)%nat -> Sum n (fun j => lap n adj i j * x j) = 0 * x i) <-> exists c, forall i, (i < n)%nat -> x i = c * 1).
(* tanner1.Lw clause 4; the incidence matrix D of an orientation O, and weights W of its edges *)
Definition inc_of (i : nat) (e : nat * nat) : R := if Nat.eqb i (fst e) then 1 else if Nat.eqb i (snd e) then - 1 else 0.
Definition DWD (O : list (nat * nat)) (W : nat * nat -> R) (i j : nat) : R := lsum O (fun e => inc_of i e * W e * inc_of j e).
Definition Lw_4 : Prop := forall n adj O W, undirected adj -> no_loops adj -> tanner_graph.oriented n adj O -> (forall e, In e O -> 0 < W e) ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> DWD O W i j = DWD O W j i) /\
  forall x : nat -> R, 0 <= Sum n (fun i => x i * Sum n (fun j => DWD O W i j * x j)).
(* tanner1.Vmono clause 2 *)
Definition Vmono_2 : Prop := forall i j r s, 0 < r < s ->
  (s <= 1 -> T1.fig2 i j s < T1.fig2 i j r) /\ (1 <= r -> T1.fig2 i j r < T1.fig2 i j s).
(* tanner1.collision clause 3; V_t of (8), with headings th: V_t exceeds every c where two linked agents are near enough, wherever the others are *)
Definition collision_3 : Prop := forall n adj, undirected adj -> no_loops adj -> forall c, exists e, 0 < e /\
  forall (r v : nat -> C) (th : nat -> R), (forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> r i <> r j) ->
  (exists i j, (i < n)%nat /\ (j < n)%nat /\ adj i j = true /\ Cmod (r i - r j)%C < e) -> c < T1.kinetic_plus_V n adj T1.fig2 r v + / 2 * Sum n (fun i => th i ^ 2).

(* ======== Veerman ======== *)
(* veerman.cor1.proof clause 2; h are the places of the cars *)
Definition cor1_proof_2 : Prop := forall (f g w : R) (h : nat -> R) (a : nat -> C) k t, (1 <= k)%nat ->
  let x j s := (RtoC (h j) + a j * expi (w * s))%C in let u j s := (Ci * RtoC w * a j * expi (w * s))%C in
  (is_velocity (x k) t (u k t) /\
   is_velocity (u k) t (RtoC f * ((x k t - RtoC (h k)) - (x (k - 1)%nat t - RtoC (h (k - 1)%nat))) + RtoC g * (u k t - u (k - 1)%nat t))%C) <->
  (- RtoC (w ^ 2) * a k = RtoC f * (a k - a (k - 1)%nat) + Ci * RtoC w * RtoC g * (a k - a (k - 1)%nat))%C.
(* veerman.nth_neighbour clause 3; the agents are 0, .., N + 1 *)
Definition joined (N n : nat) : nat -> nat -> Prop := clos_refl_sym_trans nat (fun k j => (k <= S N)%nat /\ (j <= S N)%nat /\ (k = j + n)%nat).
Definition nth_3 : Prop := forall N n, (2 <= n)%nat -> ~ forall i j, (i <= S N)%nat -> (j <= S N)%nat -> joined N n i j.
(* veerman.sep_remark clause 2; the cars of system (1) at the response to the leader h_0 + a_0 cos(w t) *)
Definition sep_remark_2 : Prop := forall (f g w a0 : R) (h : nat -> R) (a : nat -> C) (x : nat -> R -> R),
  V.z f g w <> 0%C -> V.gam f g w <> 0%C -> V.response1 f g w a -> (forall k t, x k t = h k + a0 * Re (a k * expi (w * t))%C) ->
  forall k, h (S k) - h k = 1 -> forall t,
  x (S k) t - x k t = a0 * Re (/ V.power (V.gam f g w) (k + 1) * expi (w * t))%C - a0 * Re (/ V.power (V.gam f g w) k * expi (w * t))%C + 1.
(* veerman.table1_theory clause 3; the numbers of column NFREQ, N = 4, 8, .., 128 *)
Definition table1_3 : Prop := forall N p, In (N, p) ((4, 0.2776801836) :: (8, 0.1388400918) :: (16, 0.0694200459) :: (32, 0.0347100229) ::
    (64, 0.0173550115) :: (128, 0.0086775057) :: nil) ->
  Rabs (sqrt (Rabs (- 1)) * PI / (N * 2 * sqrt 2) - p) <= / 10 ^ 10.
(* veerman.table1_theory clause 4; the numbers of column NAMP *)
Definition table1_4 : Prop := forall N p, In (N, p) ((4, 4.58527335) :: (8, 9.17054669) :: (16, 18.34109338) :: (32, 36.68218677) ::
    (64, 73.36437354) :: (128, 146.72874707) :: nil) ->
  Rabs (8 * sqrt (2 * Rabs (- 1)) / (PI ^ 2 * Rabs (- 1)) * N - p) <= / 10 ^ 8.
(* veerman.thm1_x clauses 3, 4: stated in audit_independent_veerman.v *)
Definition thm1_x_34 : Prop := V.thm1_x.
