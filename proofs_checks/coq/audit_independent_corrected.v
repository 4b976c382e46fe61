(* Clauses of the claims about four papers, most of them in the list of what is proved beyond the papers, formalised from their words
   before the theorems were looked at; the theorems prove them. *)
From Coq Require Import Reals Lra Lia List Relations Psatz.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums paley_model paley_phase paley_laplacian paley_gradient paley_particles tanner_energy tanner_flock.
From Flockproof Require paley_fourier paley_patterns tanner_graph.
From Flockproof Require audit_independent_paley audit_independent_tanner1 audit_independent_tanner2 audit_independent_veerman.
Module P := audit_independent_paley.
Module T1 := audit_independent_tanner1.
Module T2 := audit_independent_tanner2.
Module V := audit_independent_veerman.
Open Scope R_scope.

(* ======== Paley ======== *)
(* (12): <e^{i theta}, L e^{i theta}>/(2N), and the same graph's arcs k <- j *)
Definition WL (n : nat) (adj : graph) (th : nat -> R) : R :=
  / (2 * INR n) * Sum n (fun k => inner (expi (th k)) (Csum n (fun j => RtoC (lap n adj k j) * expi (th j)))%C).
(* paley.eq12.pos clause 4 *)
Definition eq12_pos_4 : Prop := forall n adj th, strongly_connected n adj -> ~ synchronized n th -> 0 < WL n adj th.
(* beyond.paley.zero.dir clause 2: every directed graph; j, k of one component are joined by arcs in either direction *)
Definition zero_dir_2 : Prop := forall n adj th,
  ~ (forall j k, (j < n)%nat -> (k < n)%nat -> clos_refl_sym_trans nat (arc n adj) j k -> expi (th j) = expi (th k)) -> 0 < WL n adj th.
(* beyond.paley.eq28: (27) for fish k with neighbours in three zones, v_k^att given *)
Definition hat (z : C) : C := (z / RtoC (Cmod z))%C.
Definition among (n : nat) (adj : graph) (k : nat) (f : nat -> C) : C := Csum n (fun j => if adj k j then f j else 0%C).
Definition u27 n (rep ori : graph) (w : nat -> R) (Krep Kori Katt : R) (r : nat -> C) (th : nat -> R) (vatt : C) (k : nat) : R :=
  w k + inner (Ci * expi (th k))%C (RtoC Krep * (- among n rep k (fun j => hat (r k - r j)%C))
    + RtoC Kori * (expi (th k) + among n ori k (fun j => expi (th j))) + RtoC Katt * vatt)%C.
Definition ori_term n (ori : graph) Kori (th : nat -> R) k : R :=
  - Kori * inner (Ci * expi (th k))%C (Csum n (fun j => RtoC (lap n ori k j) * expi (th j)))%C.
Definition att_term n (att : graph) Katt (r : nat -> C) (th : nat -> R) k : R :=
  - Katt * inner (Ci * expi (th k))%C (Csum n (fun j => RtoC (lap n att k j) * r j))%C.
Definition u28 n ori att w Kori Katt r th k : R := w k + ori_term n ori Kori th k + att_term n att Katt r th k.
(* clause 1 *)
Definition eq28_1 : Prop := forall n rep ori att w Krep Kori Katt r th k, (k < n)%nat -> (forall j, (j < n)%nat -> rep k j = false) ->
  u27 n rep ori w Krep Kori Katt r th (- among n att k (fun j => r k - r j))%C k = u28 n ori att w Kori Katt r th k.
(* clauses 2, 3: u turns th to the side on which the direction psi of d is; where d has none, it does not turn *)
Definition steers_towards (u th : R) (d : C) := (d = 0%C -> u = 0) /\ forall rho psi, 0 < rho -> d = (RtoC rho * expi psi)%C ->
  (0 < sin (psi - th) -> 0 < u) /\ (sin (psi - th) < 0 -> u < 0) /\ (sin (psi - th) = 0 -> u = 0).
Definition eq28_2 : Prop := forall n att Katt r th k, (k < n)%nat -> 0 < Katt ->
  steers_towards (att_term n att Katt r th k) (th k) (among n att k (fun j => r j - r k)%C).
Definition eq28_3 : Prop := forall n ori Kori th k, (k < n)%nat -> 0 < Kori ->
  steers_towards (ori_term n ori Kori th k) (th k) (among n ori k (fun j => expi (th j))).
(* clause 4; in general: whatever the gains are, except K_att = 0, where there is no such term *)
Definition eq28_4 : Prop :=
  (forall n rep ori att w Krep Kori Katt r th k, (k < n)%nat -> (forall j, (j < n)%nat -> rep k j = false) ->
     (forall j, (j < n)%nat -> att k j = true -> Cmod (r k - r j)%C = 1) ->
     u27 n rep ori w Krep Kori Katt r th (- among n att k (fun j => hat (r k - r j)))%C k = u28 n ori att w Kori Katt r th k) /\
  forall Krep Kori Katt, Katt <> 0 -> exists n rep ori att w r th k, (k < n)%nat /\ (forall j, (j < n)%nat -> rep k j = false) /\
     (forall j, (j < n)%nat -> att k j = true -> r k <> r j) /\
     u27 n rep ori w Krep Kori Katt r th (- among n att k (fun j => hat (r k - r j)))%C k <> u28 n ori att w Kori Katt r th k.
(* beyond.paley.figS3.difference clause 1: each fish is joined to m others, and to nobody farther than one to whom it is not *)
Definition nearest_graph (n m : nat) (r : nat -> C) (adj : graph) := forall k, (k < n)%nat -> adj k k = false /\ deg n adj k = INR m /\
  forall j l, (j < n)%nat -> (l < n)%nat -> l <> k -> adj k j = true -> adj k l = false -> Cmod (r k - r j)%C <= Cmod (r k - r l)%C.
Definition mean_over_arcs (n : nat) (adj : graph) (f : nat -> nat -> R) : R :=
  Sum n (fun k => Sum n (fun j => if adj k j then f k j else 0)) / Sum n (fun k => Sum n (fun j => if adj k j then 1 else 0)).
Definition figS3_1 : Prop := forall n r th one all, (2 <= n)%nat -> nearest_graph n 1 r one -> nearest_graph n (n - 1) r all ->
  (0 < WL n all th / INR (n - 1) - WL n one th / 1 <->
   mean_over_arcs n one (fun k j => 1 - cos (th k - th j)) < mean_over_arcs n all (fun k j => 1 - cos (th k - th j))).
(* beyond.paley.sync.par: particles (1), (2) at all times, phase locked, and synchronised at one time *)
Definition sync_arrangement (n : nat) (r : nat -> R -> C) (th u : nat -> R -> R) (t0 : R) :=
  (forall t k, (k < n)%nat -> is_velocity (r k) t (expi (th k t)) /\ is_derive (th k) t (u k t)) /\
  (forall t j k, (j < n)%nat -> (k < n)%nat -> is_derive (fun s => th k s - th j s) t 0) /\ synchronized n (fun k => th k t0).
(* clause 1: d is the common direction *)
Definition sync_par_1 : Prop := forall n r th u t0, (1 <= n)%nat -> sync_arrangement n r th u t0 ->
  exists (d : R -> C) (rate : R -> R), forall t, Cmod (d t) = 1 /\
    (forall k, (k < n)%nat -> is_velocity (r k) t (d t) /\ expi (th k t) = d t /\ u k t = rate t) /\ is_velocity d t (RtoC (rate t) * (Ci * d t))%C.
(* clause 2: (14) with every directed graph *)
Definition ori9 n K1 (th : nat -> R) k : R := - K1 * inner (Ci * expi (th k))%C (RtoC (/ INR n) * Csum n (fun j => expi (th j)))%C.
Definition ori14 n (adj : graph) K1 (th : nat -> R) k : R :=
  K1 / INR n * inner (Ci * expi (th k))%C (Csum n (fun j => RtoC (lap n adj k j) * expi (th j)))%C.
Definition sync_par_2 : Prop := forall n w0 (ori : (nat -> R) -> nat -> R), (exists K1, ori = ori9 n K1 \/ exists adj, ori = ori14 n adj K1) ->
  forall (th : nat -> R -> R) t, (forall k, (k < n)%nat -> is_derive (th k) t (w0 + ori (fun j => th j t) k)) ->
  synchronized n (fun k => th k t) -> forall k, (k < n)%nat -> is_derive (th k) t w0.
(* clause 3: parallel: one velocity, of all and at all times; also in the case of clause 2 *)
Definition parallel n (r : nat -> R -> C) := exists d : C, forall t k, (k < n)%nat -> is_velocity (r k) t d.
Definition sync_par_3 : Prop :=
  (forall n r th u t0, (1 <= n)%nat -> sync_arrangement n r th u t0 -> (parallel n r <-> forall t k, (k < n)%nat -> u k t = 0)) /\
  forall n w0 ori r th t0, (1 <= n)%nat -> (exists K1, ori = ori9 n K1 \/ exists adj, ori = ori14 n adj K1) ->
    sync_arrangement n r th (fun k t => w0 + ori (fun j => th j t) k) t0 -> (parallel n r <-> w0 = 0).
(* paley.unbal clause 1 and paley.thm1.saddle clause 3: equilibria modulo rotation: from there all phases turn at the rate w0 for ever *)
Definition equilibrium9 n (th : nat -> R) := forall w0 K1 t k, (k < n)%nat ->
  is_derive (fun s => th k + w0 * s) t (w0 + ori9 n K1 (fun j => th j + w0 * t) k) /\ w0 + ori9 n K1 th k = w0.
Definition unbal_1 : Prop := forall n M th0 th (first : nat -> bool), (1 <= M < n)%nat -> (2 * M <> n)%nat ->
  Sum n (fun k => if first k then 1 else 0) = INR M ->
  (forall k, (k < n)%nat -> expi (th k) = expi (if first k then th0 else th0 + PI)) -> equilibrium9 n th /\ stationary n (U1 n) th.
Definition saddle_3 : Prop := forall n th, stationary n (U1 n) th -> ~ synchronized n th -> ~ balanced n th -> equilibrium9 n th.
(* beyond.paley.cyclic_eigenvectors: C_N; columns are counted from 1 *)
Definition cyclic n (adj : graph) := forall k j, (k < n)%nat -> (j < n)%nat ->
  (adj k j = true <-> j = ((k + 1) mod n)%nat \/ k = ((j + 1) mod n)%nat).
Definition eigenvector n (adj : graph) (lam : C) (x : nat -> C) := (exists k, (k < n)%nat /\ x k <> 0%C) /\
  forall k, (k < n)%nat -> Csum n (fun j => RtoC (lap n adj k j) * x j)%C = (lam * x k)%C.
Definition column n m k : C := (RtoC (/ sqrt (INR n)) * expi (2 * PI / INR n * (INR (m - 1) * INR k)))%C.
Definition in_phase n (x : nat -> C) (th : nat -> R) := exists c, 0 < c /\ forall k, (k < n)%nat -> x k = (RtoC c * expi (th k))%C.
(* clause 2 *)
Definition cyclic_2 : Prop := forall n adj m, (3 <= n)%nat -> cyclic n adj -> (1 <= m <= n)%nat ->
  (exists lam, eigenvector n adj lam (column n m)) /\
  forall th, in_phase n (column n m) th -> paley_patterns.pattern (n / Nat.gcd n (m - 1)) n th.
(* clause 3 *)
Definition uvuv (u v : C) (k : nat) : C :=
  match (k mod 4)%nat with 0%nat => u | 1%nat => v | 2%nat => (- u)%C | _ => (- v)%C end.
Definition cyclic_3 : Prop := forall q adj u v, (1 <= q)%nat -> cyclic (4 * q) adj -> Cmod u = 1 -> Cmod v = 1 ->
  eigenvector (4 * q) adj 2 (uvuv u v).
(* beyond.paley.fig2.caption clauses 3, 4 *)
Definition fig2_3 : Prop := forall m th, (1 <= m <= 12)%nat -> in_phase 12 (column 12 m) th -> exists M, (exists q, (M * q = 12)%nat) /\ paley_patterns.pattern M 12 th.
Definition fig2_4 : Prop := forall adj u v, cyclic 12 adj -> Cmod u = 1 -> Cmod v = 1 -> eigenvector 12 adj 2 (uvuv u v).

(* ======== Tanner ======== *)
(* beyond.tanner1.Lw clause 4, tanner1.L clause 4, tanner2.L clause 3: the kernel of every power has as many dimensions as there are
   components; and there is a number of components *)
Definition dimension (n : nat) (K : (nat -> R) -> Prop) (c : nat) := exists b : nat -> nat -> R, (forall l, (l < c)%nat -> K (b l)) /\
  (forall a, (forall i, (i < n)%nat -> Sum c (fun l => a l * b l i) = 0) -> forall l, (l < c)%nat -> a l = 0) /\
  forall x, K x -> exists a, forall i, (i < n)%nat -> x i = Sum c (fun l => a l * b l i).
Definition times (n : nat) (L : nat -> nat -> R) (x : nat -> R) (i : nat) : R := Sum n (fun j => L i j * x j).
Definition multiplicity_of_zero n L c := forall m, (1 <= m)%nat -> dimension n (fun x => forall i, (i < n)%nat -> Nat.iter m (times n L) x i = 0) c.
Definition components n (adj : graph) (c : nat) := exists comp : nat -> nat, (forall i, (i < n)%nat -> (comp i < c)%nat) /\
  (forall l, (l < c)%nat -> exists i, (i < n)%nat /\ comp i = l) /\
  forall i j, (i < n)%nat -> (j < n)%nat -> (comp i = comp j <-> clos_refl_trans nat (arc n adj) i j).
Definition lapw n (adj : graph) (wt : nat -> nat -> R) (i j : nat) : R :=
  delta i j * Sum n (fun k => if adj i k then wt i k else 0) - (if adj i j then wt i j else 0).
Definition Lw_4 : Prop := forall n adj (wt : nat -> nat -> R), undirected adj -> no_loops adj ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> 0 < wt i j /\ wt i j = wt j i) ->
  (exists c, components n adj c) /\ forall c, components n adj c -> multiplicity_of_zero n (lapw n adj wt) c.
Definition L_4 : Prop := forall n adj, undirected adj -> no_loops adj ->
  (exists c, components n adj c) /\ forall c, components n adj c -> multiplicity_of_zero n (lap n adj) c.
(* beyond.tanner1.Vt_inv clause 2: in both directions of time, and through jumps of the headings: at the times in ex the control (5)
   jumps, the velocities do not *)
Definition Vt_inv_2 : Prop := forall n adj V V' (r v : nat -> R -> C) a A B (ex : list R) c, undirected adj -> T1.symmetric_V V ->
  (forall t, A <= t <= B -> forall i, (i < n)%nat -> is_velocity (r i) t (v i t) /\
     continuous (fun s => fst (v i s)) t /\ continuous (fun s => snd (v i s)) t /\
     forall j, (j < n)%nat -> adj i j = true -> r i t <> r j t /\ is_derive (V i j) (Cmod (r i t - r j t)%C) (V' i j (Cmod (r i t - r j t)%C))) ->
  (forall t, A <= t <= B -> ~ In t ex -> T1.loop n adj V V' r v a t) ->
  forall s t, A <= s <= B -> A <= t <= B ->
    T1.kinetic_plus_V n adj V (fun i => r i s) (fun i => v i s) <= c -> T1.kinetic_plus_V n adj V (fun i => r i t) (fun i => v i t) <= c.
(* headings of agents that move; no jump: continuous *)
Definition heading (v : nat -> R -> C) (th : nat -> R -> R) i t := v i t <> 0%C /\ continuous (th i) t /\
  locally t (fun s => v i s = (RtoC (Cmod (v i s)) * expi (th i s))%C).
Definition dth (th : nat -> R -> R) := fun (i j : nat) (s : R) => th i s - th j s.
Definition gradV n (adj : graph) (V' : nat -> nat -> R -> R) (r : nat -> C) i : C :=
  Csum n (fun j => if adj i j then RtoC (V' i j (Cmod (r i - r j)) / Cmod (r i - r j)) * (r i - r j) else 0)%C.
Definition pulls n (adj : graph) (r : nat -> C) (th : nat -> R) i : R :=
  Sum n (fun j => if adj i j then (th i - th j) / Cmod (r i - r j)%C ^ 2 else 0).
(* beyond.tanner1.eq6b clause 1; the headings have rates om *)
Definition eq6b : Prop := forall n adj V V' r v th t, T1.loop n adj V V' r v (dth th) t -> (forall i, (i < n)%nat -> heading v th i t) ->
  exists om, (forall i, (i < n)%nat -> is_derive (th i) t (om i)) /\
    Sum n (fun i => inner (r i t) (v i t) * (om i + pulls n adj (fun j => r j t) (fun j => th j t) i
      + cross (v i t) (gradV n adj V' (fun j => r j t) i) / Cmod (v i t) ^ 2)) = 0.
(* beyond.tanner1.eq9 clause 1 *)
Definition Vt n adj V (r v : nat -> C) (th : nat -> R) : R := T1.kinetic_plus_V n adj V r v + / 2 * Sum n (fun i => th i ^ 2).
Definition eq9_1 : Prop := forall n adj V V' r v th t, undirected adj -> T1.symmetric_V V -> T1.loop n adj V V' r v (dth th) t ->
  (forall i, (i < n)%nat -> heading v th i t) ->
  is_derive (fun s => Vt n adj V (fun i => r i s) (fun i => v i s) (fun i => th i s)) t
    (- Sum n (fun i => th i t * times n (lapw n adj (fun i j => / Cmod (r i t - r j t)%C ^ 2)) (fun j => th j t) i)
     - Sum n (fun i => th i t * (cross (v i t) (gradV n adj V' (fun j => r j t) i) / Cmod (v i t) ^ 2))).
(* tanner1.eq9.chain clause 1: whatever the accelerations are, those of (4), (5) among them *)
Definition chain_1 : Prop := forall n adj V V' (r v : nat -> R -> C) (acc : nat -> C) th t, undirected adj -> T1.symmetric_V V ->
  (forall i, (i < n)%nat -> is_velocity (r i) t (v i t) /\ is_velocity (v i) t (acc i) /\ forall j, (j < n)%nat -> adj i j = true ->
     r i t <> r j t /\ is_derive (V i j) (Cmod (r i t - r j t)%C) (V' i j (Cmod (r i t - r j t)%C))) ->
  (forall i, (i < n)%nat -> heading v th i t) -> exists om, (forall i, (i < n)%nat -> is_derive (th i) t (om i)) /\
  is_derive (fun s => Vt n adj V (fun i => r i s) (fun i => v i s) (fun i => th i s)) t
    (Sum n (fun i => inner (gradV n adj V' (fun j => r j t) i) (v i t)) + Sum n (fun i => inner (v i t) (acc i)) + Sum n (fun i => th i t * om i)).
(* beyond.tanner1.proof_cases clause 1, beyond.tanner1.proof_ratio clause 2: near t all agents move with the heading thbar *)
Definition one_heading n (v : nat -> R -> C) (th : nat -> R -> R) (thbar t : R) := locally t (fun s => forall i, (i < n)%nat ->
  v i s <> 0%C /\ th i s = thbar /\ v i s = (RtoC (Cmod (v i s)) * expi thbar)%C).
Definition proof_cases_1 : Prop := forall n adj V V' r v th thbar t, T1.loop n adj V V' r v (dth th) t -> one_heading n v th thbar t ->
  forall i, (i < n)%nat -> exists c, gradV n adj V' (fun j => r j t) i = (RtoC c * v i t)%C.
Definition proof_ratio_2 : Prop := forall n adj V V' r v th thbar t, T1.loop n adj V V' r v (dth th) t -> one_heading n v th thbar t ->
  forall i ai, (i < n)%nat -> is_velocity (v i) t ai -> let g := gradV n adj V' (fun j => r j t) i in let k := snd (v i t) / fst (v i t) in
  fst (v i t) <> 0 -> (fst ai <> 0 -> k = snd ai / fst ai) /\ (fst g <> 0 -> k = snd g / fst g).
(* beyond.tanner1.proof_cases clause 2: s the squared distance (Figure 2); the distance has a period, is 2 and below 1 in each, has no limit,
   and the work on the agent that started at (0, 0) has both signs in each *)
Definition pair_motion (adj : graph) (r v : nat -> R -> C) (th : nat -> R -> R) := undirected adj /\ no_loops adj /\ adj 0%nat 1%nat = true /\
  r 0%nat 0 = (0, 0) /\ r 1%nat 0 = (2, 0) /\ v 0%nat 0 = (2, 0) /\ v 1%nat 0 = (2, 0) /\
  forall t, 0 <= t -> T1.loop 2 adj T1.fig2 T1.fig2' r v (dth th) t /\
    forall i, (i < 2)%nat -> - PI < th i t <= PI /\ v i t = (RtoC (Cmod (v i t)) * expi (th i t))%C.
Definition swings (adj : graph) (r v : nat -> R -> C) := let d t := Cmod (r 0%nat t - r 1%nat t)%C in
  let p t := - inner (gradV 2 adj T1.fig2' (fun j => r j t) 0) (v 0%nat t) in
  (forall l, ~ is_lim d p_infty l) /\
  exists T, 0 < T /\ (forall t, 0 <= t -> d (t + T) = d t) /\ forall t0, 0 <= t0 ->
    (exists t, t0 <= t <= t0 + T /\ d t = 2) /\ (exists t, t0 <= t <= t0 + T /\ d t < 1) /\
    (exists t, t0 <= t <= t0 + T /\ 0 < p t) /\ exists t, t0 <= t <= t0 + T /\ p t < 0.
Definition proof_cases_2 : Prop := exists adj r v th, pair_motion adj r v th /\ swings adj r v.
Definition proof_cases_2_every : Prop := forall adj r v th, pair_motion adj r v th -> swings adj r v.
(* tanner1.Omega.bounded clauses 1, 2; for the velocities the graph need not be connected *)
Definition apart_now n (adj : graph) (r : nat -> C) := forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> r i <> r j.
Definition Omega_1 : Prop := forall n adj c, undirected adj -> no_loops adj -> strongly_connected n adj -> exists B, forall r v th,
  apart_now n adj r -> Vt n adj T1.fig2 r v th <= c -> forall i j, (i < n)%nat -> (j < n)%nat -> Cmod (r i - r j)%C <= B.
Definition Omega_2 : Prop := forall n adj c, undirected adj -> no_loops adj -> exists B, forall r v th,
  apart_now n adj r -> Vt n adj T1.fig2 r v th <= c -> forall i, (i < n)%nat -> Cmod (v i) <= B.
(* tanner2.eq8 clause 1; the V_i have rates d *)
Definition eq8_1 : Prop := forall n adj V V' (r v : nat -> R -> C) t, T2.simple_graph adj -> (forall i j s, V i j s = V j i s) ->
  (forall i j s, (i < n)%nat -> (j < n)%nat -> adj i j = true -> 0 < s -> is_derive (V i j) s (V' i j s)) ->
  T2.apart_at n adj (fun i => r i t) ->
  (forall i, (i < n)%nat -> is_velocity (r i) t (v i t) /\ is_velocity (v i) t (T2.law4 n adj V' (fun i => r i t) (fun i => v i t) i)) ->
  exists d : nat -> R, (forall i, (i < n)%nat -> is_derive (fun s => Sum n (fun j => if adj i j then V i j (Cmod (r i s - r j s)%C) else 0)) t (d i)) /\
  is_derive (fun s => T2.energy6 n adj V (fun i => r i s) (fun i => v i s)) t
    (/ 2 * Sum n d - Sum n (fun i => inner (v i t)
       (Csum n (fun j => if adj i j then v i t - v j t else 0)%C + gradV n adj V' (fun j => r j t) i)%C)).
(* beyond.tanner2.eq13.interval: the right side of (13) at positions r: the closed convex hull of what -v^T (L kron I_2) v is at positions
   without ties that are as near as one wants (K of the appendix) *)
Definition no_ties n (r : nat -> C) R0 := forall i j, (i < n)%nat -> (j < n)%nat -> Cmod (r i - r j)%C <> R0.
Definition dissipation n (adj : graph) (v : nat -> C) : R :=
  - Sum n (fun i => fst (v i) * times n (lap n adj) (fun j => fst (v j)) i) - Sum n (fun i => snd (v i) * times n (lap n adj) (fun j => snd (v j)) i).
Definition near_value n R0 (r v : nat -> C) (q : R) := forall e, 0 < e -> exists r', (forall i, (i < n)%nat -> Cmod (r' i - r i)%C < e) /\
  no_ties n r' R0 /\ q = dissipation n (T2.by_distance r' R0) v.
Definition right_of_13 n R0 r v (q : R) := forall a b, (forall s, near_value n R0 r v s -> a <= s <= b) -> a <= q <= b.
(* clauses 1, 2 *)
Definition eq13_1 : Prop := forall n R0 r v, 0 < R0 -> exists e f, e <= f <= 0 /\ forall q, right_of_13 n R0 r v q <-> e <= q <= f.
Definition eq13_2 : Prop := forall n R0 r v, 0 < R0 -> no_ties n r R0 -> forall q, right_of_13 n R0 r v q <-> q = dissipation n (T2.by_distance r R0) v.
(* tanner2.rangeB clauses 2, 3: a tree: connected, without closed paths; O lists its edges once each, with directions *)
Definition rangeB_2 : Prop := forall n adj O, (1 <= n)%nat -> T2.simple_graph adj -> T2.is_tree n adj -> tanner_graph.oriented n adj O -> length O = (n - 1)%nat.
Definition rangeB_3 : Prop := forall n adj O y, T2.simple_graph adj -> T2.is_tree n adj -> tanner_graph.oriented n adj O ->
  (forall k, (k < n)%nat -> lsum O (fun f => inc k f * y f) = 0) -> forall f, In f O -> y f = 0.

(* ======== Veerman ======== *)
(* the Laplacians L_1, L_2 of the agents 0, .., N + 1: row 0 is zero *)
Definition eig_L N (p : (nat -> C) -> nat -> C) (lam : C) := exists x : nat -> C, (exists k, (k <= S N)%nat /\ x k <> 0%C) /\
  (lam * x 0%nat)%C = 0%C /\ forall k, (1 <= k <= S N)%nat -> p x k = (lam * x k)%C.
Definition eig_AK (f g : R) (lam nu : C) := exists a b : C, (a <> 0 \/ b <> 0)%C /\ b = (nu * a)%C /\ (lam * RtoC f * a + lam * RtoC g * b)%C = (nu * b)%C.
(* beyond.veerman.specM clauses 2, 3 *)
Definition specM_2 : Prop := forall N p (f g : R), p = V.p1 \/ p = V.p2 N -> f <> 0 -> ~ V.eig_M N p f g 0%C /\
  forall nu, (V.eig_M N p f g nu /\ nu <> 0%C) <-> exists lam, (eig_L N p lam /\ lam <> 0%C) /\ eig_AK f g lam nu.
Definition specM_3 : Prop := forall N p, p = V.p1 \/ p = V.p2 N -> forall lam, (eig_L N p lam /\ lam <> 0%C) <-> V.eig N p lam.
(* beyond.veerman.nth_neighbour clause 2: deviations x, velocities u; agent k listens to k - n and k + n where they are *)
Definition listens (N n : nat) (x : nat -> R) (k : nat) : R :=
  if Nat.leb n k then if Nat.leb (k + n) (S N) then x k - / 2 * (x (k - n)%nat + x (k + n)%nat) else x k - x (k - n)%nat
  else if Nat.leb (k + n) (S N) then x k - x (k + n)%nat else 0.
Definition joined (N n : nat) : nat -> nat -> Prop := clos_refl_sym_trans nat (fun k j => (k <= S N)%nat /\ (j <= S N)%nat /\ (k = j + n)%nat).
Definition nth_2 : Prop := forall N n f g (h : nat -> R) (x u : nat -> R -> R), (2 <= n)%nat ->
  (forall t, 0 <= t -> forall k, (1 <= k <= S N)%nat -> is_derive (x k) t (u k t) /\
     is_derive (u k) t (f * listens N n (fun j => x j t - h j) k + g * listens N n (fun j => u j t) k)) ->
  (forall k, (1 <= k <= S N)%nat -> ~ joined N n 0%nat k -> x k 0 = h k /\ u k 0 = 0) ->
  ~ joined N n 0%nat 1%nat /\ forall k, (1 <= k <= S N)%nat -> ~ joined N n 0%nat k -> (forall t, 0 <= t -> x k t = h k) /\
    ((forall b, exists T, forall t, T <= t -> b < x 0%nat t) -> forall b, exists T, forall t, T <= t -> b < x 0%nat t - x k t).
