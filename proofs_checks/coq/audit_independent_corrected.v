(* Clauses of the claims about four papers, most of them in the list of what is proved beyond the papers, formalised from their words
   before the theorems were looked at; the theorems prove them. *)
From Coq Require Import Reals Lra Lia List Relations Psatz.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums paley_model paley_phase paley_laplacian paley_gradient paley_particles tanner_energy tanner_flock.
From Flockproof Require paley_fourier paley_patterns paley_behaviours paley_fish tanner1_heading tanner1_motion tanner_graph tanner_rates tanner_components.
From Flockproof Require tanner2_facts veerman_stability veerman_lemma1 veerman_numbers veerman_rest.
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
(* stated after the theorems had been seen: clauses 1, 2 of beyond.paley.sync.par without phase locking as a hypothesis: under (6) with (9) or
   (14) phases that agree once agree from then on, and turn at the rate w0 *)
Definition sync_kept : Prop := forall n w0 (ori : (nat -> R) -> nat -> R), (exists K1, ori = ori9 n K1 \/ exists adj, ori = ori14 n adj K1) ->
  forall (th : nat -> R -> R), (forall t k, 0 <= t -> (k < n)%nat -> is_derive (th k) t (w0 + ori (fun j => th j t) k)) ->
  synchronized n (fun k => th k 0) -> forall t k, 0 <= t -> (k < n)%nat -> synchronized n (fun k => th k t) /\ is_derive (th k) t w0.
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

(* ---- the theorems prove them ---- *)
Lemma Cmod_sq z : Cmod z ^ 2 = fst z ^ 2 + snd z ^ 2.
Proof. unfold Cmod. apply pow2_sqrt. nra. Qed.
Lemma near (f : R -> R) t e : continuous f t -> 0 < e -> locally t (fun s => Rabs (f s - f t) < e).
Proof. intros H He. apply (H (fun y => Rabs (y - f t) < e)). exists (mkposreal e He). intros y Hy. exact Hy. Qed.
(* a continuous heading of an agent that moves has a rate: the theorems of tanner_rates ask for differentiable headings *)
Lemma heading_rate (v : nat -> R -> C) th i t a : is_velocity (v i) t a -> heading v th i t ->
  is_derive (th i) t (cross (v i t) a / Cmod (v i t) ^ 2).
Proof.
  intros [D1 D2] (NZ & Ct & Lc). set (w := v i t) in *.
  assert (W : 0 < Cmod w) by now apply Cmod_gt_0.
  set (x := fun s => fst w * snd (v i s) - snd w * fst (v i s)). set (y := fun s => fst w * fst (v i s) + snd w * snd (v i s)).
  assert (Yt : y t = Cmod w ^ 2) by (unfold y; rewrite Cmod_sq; fold w; ring).
  assert (Dx : is_derive x t (fst w * snd a - snd w * fst a)) by (apply D_minus; now apply D_scal).
  assert (Dy : is_derive y t (fst w * fst a + snd w * snd a)) by (apply D_plus; now apply D_scal).
  assert (P0 : 0 < y t) by (rewrite Yt; apply pow_lt; exact W).
  assert (Ly : locally t (fun s => 0 < y s)).
  { apply (filter_imp (fun s => Rabs (y s - y t) < y t)); [|apply near; [apply (ex_derive_continuous y); eexists; exact Dy|exact P0]].
    intros s Hs. apply Rabs_def2 in Hs. lra. }
  assert (Lt : locally t (fun s => Rabs (th i s - th i t) < 1)) by (apply near; [exact Ct|lra]).
  assert (Et : w = (RtoC (Cmod w) * expi (th i t))%C) by exact (locally_singleton _ _ Lc).
  apply (is_derive_ext_loc (fun s => th i t + atan (x s / y s))).
  - apply (filter_imp (fun s => (0 < y s /\ Rabs (th i s - th i t) < 1) /\ v i s = (RtoC (Cmod (v i s)) * expi (th i s))%C));
      [|apply filter_and; [apply filter_and|]; assumption].
    intros s [[Y B] E]. apply Rabs_def2 in B. pose proof PI_4. pose proof PI2_1. 
    assert (W12 : fst w = Cmod w * cos (th i t) /\ snd w = Cmod w * sin (th i t)) by (rewrite Et at 1 3; cbn; split; ring).
    assert (V12 : fst (v i s) = Cmod (v i s) * cos (th i s) /\ snd (v i s) = Cmod (v i s) * sin (th i s)) by (rewrite E at 1 3; cbn; split; ring).
    destruct W12 as [W1' W2'], V12 as [V1' V2'].
    assert (X' : x s = Cmod w * Cmod (v i s) * sin (th i s - th i t)).
    { unfold x. rewrite W1', W2', V1', V2'. rewrite sin_minus. ring. }
    assert (Y' : y s = Cmod w * Cmod (v i s) * cos (th i s - th i t)).
    { unfold y. rewrite W1', W2', V1', V2'. rewrite cos_minus. ring. }
    assert (Q : x s / y s = tan (th i s - th i t)).
    { unfold tan. rewrite X', Y'. rewrite Y' in Y. field. repeat split; intros Z; rewrite Z in Y; rewrite ?Rmult_0_r, ?Rmult_0_l in Y; lra. }
    rewrite Q, atan_tan by lra. lra.
  - eapply D_eq; [apply D_plus; [apply D_const|apply (D_comp atan (fun s => x s / y s)); [apply is_derive_atan|apply is_derive_div; [exact Dx|exact Dy|lra]]]|].
    assert (X0 : x t = 0) by (unfold x; fold w; ring). rewrite X0, Yt. unfold cross, Rsqr. field. lra.
Qed.
Lemma inner_C x y : inner x y = fst x * fst y + snd x * snd y.
Proof. unfold inner, Cconj, Re. cbn. ring. Qed.
Lemma dist_rate (r1 r2 : R -> C) t v1 v2 : is_velocity r1 t v1 -> is_velocity r2 t v2 -> r1 t <> r2 t ->
  is_derive (fun s => Cmod (r1 s - r2 s)%C) t (inner (r1 t - r2 t)%C (v1 - v2)%C / Cmod (r1 t - r2 t)%C).
Proof.
  intros [A1 A2] [B1 B2] N. set (q := fun s => (fst (r1 s) - fst (r2 s)) ^ 2 + (snd (r1 s) - snd (r2 s)) ^ 2).
  assert (P : 0 < Cmod (r1 t - r2 t)%C). { apply Cmod_gt_0. intros Z. apply N. replace (r1 t) with ((r1 t - r2 t) + r2 t)%C by ring. rewrite Z. ring. }
  assert (E : forall s, Cmod (r1 s - r2 s)%C = sqrt (q s)) by (intros; reflexivity).
  apply (is_derive_ext (fun s => sqrt (q s))); [intros; now rewrite E|].
  assert (Q0 : 0 < q t). { rewrite E in P. destruct (Rle_lt_dec (q t) 0) as [L|L]; [|exact L]. rewrite sqrt_neg_0 in P by exact L. lra. }
  assert (Dq : is_derive q t (2 * (fst (r1 t) - fst (r2 t)) * (fst v1 - fst v2) + 2 * (snd (r1 t) - snd (r2 t)) * (snd v1 - snd v2))).
  { apply D_plus; apply (D_sqr (fun s => _ (r1 s) - _ (r2 s))); now apply D_minus. }
  eapply D_eq; [apply (is_derive_sqrt q); [exact Dq|exact Q0]|]. rewrite E, inner_C. rewrite E in P. cbn. field. lra.
Qed.
Lemma Csum_inner n f z : inner (Csum n f) z = Sum n (fun j => inner (f j) z).
Proof.
  rewrite inner_C. unfold Csum. cbn [fst snd]. rewrite <- !Sum_scal_r, <- Sum_plus. apply Sum_ext. intros. now rewrite inner_C.
Qed.
(* the rate of V_i *)
Lemma V_i_rate n (adj : graph) V V' (r v : nat -> R -> C) t i : (i < n)%nat ->
  (forall j, (j < n)%nat -> is_velocity (r j) t (v j t)) ->
  (forall j, (j < n)%nat -> adj i j = true -> r i t <> r j t /\ is_derive (V i j) (Cmod (r i t - r j t)%C) (V' i j (Cmod (r i t - r j t)%C))) ->
  is_derive (fun s => Sum n (fun j => if adj i j then V i j (Cmod (r i s - r j s)%C) else 0)) t
    (Sum n (fun j => if adj i j then V' i j (Cmod (r i t - r j t)%C) / Cmod (r i t - r j t)%C * inner (r i t - r j t)%C (v i t - v j t)%C else 0)).
Proof.
  intros Hi D H. apply (D_Sum n (fun j s => if adj i j then V i j (Cmod (r i s - r j s)%C) else 0)). intros j Hj.
  destruct (adj i j) eqn:A; [|apply D_const]. destruct (H j Hj A) as [N S].
  eapply D_eq; [apply (D_comp (V i j) (fun s => Cmod (r i s - r j s)%C)); [exact S|apply dist_rate; [now apply D|now apply D|exact N]]|].
  unfold Rdiv. ring.
Qed.
Lemma Cmod_swap x y : Cmod (x - y)%C = Cmod (y - x)%C.
Proof. replace (x - y)%C with (- (y - x))%C by ring. now rewrite Cmod_opp. Qed.
Lemma half_V_rate n (adj : graph) V V' (r v : nat -> R -> C) t : undirected adj -> (forall i j s, V i j s = V j i s) ->
  (forall i, (i < n)%nat -> is_velocity (r i) t (v i t)) ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true ->
     r i t <> r j t /\ is_derive (V i j) (Cmod (r i t - r j t)%C) (V' i j (Cmod (r i t - r j t)%C))) ->
  is_derive (fun s => / 2 * Sum n (fun i => Sum n (fun j => if adj i j then V i j (Cmod (r i s - r j s)%C) else 0))) t
    (Sum n (fun i => inner (gradV n adj V' (fun j => r j t) i) (v i t))).
Proof.
  intros S VS D H.
  eapply D_eq; [apply D_scal; apply (D_Sum n (fun i s => Sum n (fun j => if adj i j then V i j (Cmod (r i s - r j s)%C) else 0))); intros i Hi;
    apply (V_i_rate n adj V V' r v t i Hi D); intros; now apply H|].
  set (c := fun i j => if adj i j then V' i j (Cmod (r i t - r j t)%C) / Cmod (r i t - r j t)%C else 0).
  assert (Cs : forall i j, (i < n)%nat -> (j < n)%nat -> c i j = c j i).
  { intros i j Hi Hj. unfold c. rewrite (S j i). destruct (adj i j) eqn:A; [|reflexivity]. destruct (H i j Hi Hj A) as [_ P].
    destruct (H j i Hj Hi ltac:(now rewrite S)) as [_ Q]. rewrite (Cmod_swap (r j t)) in *. f_equal.
    apply is_derive_unique in P. rewrite <- P. apply is_derive_unique. apply (is_derive_ext (V j i)); [intros; apply VS|exact Q]. }
  assert (E : forall i, (i < n)%nat -> inner (gradV n adj V' (fun j => r j t) i) (v i t) = Sum n (fun j => c i j * inner (r i t - r j t)%C (v i t))).
  { intros i Hi. unfold gradV. rewrite Csum_inner. apply Sum_ext. intros j _. unfold c. destruct (adj i j); rewrite !inner_C; cbn; ring. }
  rewrite (Sum_ext n _ _ E).
  rewrite (Sum_ext n _ (fun i => Sum n (fun j => c i j * inner (r i t - r j t)%C (v i t)) + Sum n (fun j => c j i * inner (r j t - r i t)%C (v j t)))).
  - rewrite Sum_plus, (Sum_swap n n (fun i j => c j i * inner (r j t - r i t)%C (v j t))). field.
  - intros i Hi. rewrite <- Sum_plus. apply Sum_ext. intros j Hj. rewrite (Cs j i Hj Hi). unfold c. destruct (adj i j); [|ring].
    rewrite !inner_C. cbn. ring.
Qed.
Lemma kinetic_rate n (v : nat -> R -> C) a t : (forall i, (i < n)%nat -> is_velocity (v i) t (a i)) ->
  is_derive (fun s => / 2 * Sum n (fun i => Cmod (v i s) ^ 2)) t (Sum n (fun i => inner (v i t) (a i))).
Proof.
  intros D. apply (is_derive_ext (fun s => / 2 * Sum n (fun i => fst (v i s) ^ 2 + snd (v i s) ^ 2))).
  - intros s. f_equal. apply Sum_ext. intros. now rewrite Cmod_sq.
  - eapply D_eq; [apply D_scal; apply (D_Sum n (fun i s => fst (v i s) ^ 2 + snd (v i s) ^ 2)); intros i Hi; destruct (D i Hi) as [D1 D2];
      apply D_plus; (apply (D_sqr (fun s => _ (v i s))); eassumption)|].
    cbn beta. rewrite <- Sum_scal. apply Sum_ext. intros i _. rewrite inner_C. field.
Qed.
Lemma energy_split n adj V r v : T1.kinetic_plus_V n adj V r v =
  / 2 * Sum n (fun i => Sum n (fun j => if adj i j then V i j (Cmod (r i - r j)%C) else 0)) + / 2 * Sum n (fun i => Cmod (v i) ^ 2).
Proof. unfold T1.kinetic_plus_V. rewrite Sum_plus. ring. Qed.
Lemma law_work n adj V' a r v i : inner (v i) (T1.law n adj V' a r v i) = - inner (gradV n adj V' r i) (v i).
Proof. unfold T1.law, gradV. rewrite !inner_C. cbn. ring. Qed.
Lemma lapw_pulls n adj r th i : (i < n)%nat -> times n (lapw n adj (fun i j => / Cmod (r i - r j)%C ^ 2)) th i = pulls n adj r th i.
Proof.
  intros Hi. unfold times, lapw, pulls. set (c := fun j => if adj i j then / Cmod (r i - r j)%C ^ 2 else 0).
  rewrite (Sum_ext n _ (fun j => delta i j * (Sum n c * th j) - c j * th j)) by (intros; unfold c; ring).
  rewrite Sum_minus, (Sum_delta_l n i (fun j => Sum n c * th j) Hi), <- Sum_scal_r, <- Sum_minus. apply Sum_ext. intros j _. unfold c, Rdiv.
  destruct (adj i j); ring.
Qed.
Lemma one_heading_law n adj V' (r v : nat -> R -> C) th thbar t i : one_heading n v th thbar t -> (i < n)%nat ->
  T1.law n adj V' (fun i j => dth th i j t) (fun i => r i t) (fun i => v i t) i = (- gradV n adj V' (fun j => r j t) i)%C.
Proof.
  intros H Hi. unfold T1.law. fold (gradV n adj V' (fun j => r j t) i).
  rewrite (Sum_zero n _); [ring|]. intros j Hj. unfold dth. pose proof (locally_singleton _ _ H) as E.
  destruct (E i Hi) as (_ & -> & _), (E j Hj) as (_ & -> & _). destruct (adj i j); [unfold Rdiv; ring|reflexivity].
Qed.
(* a proof of its own: tanner_rates.sublevel_invariant asks for the law at all times, and so excludes jumps of the headings *)
(* no rate but at the times in ex *)
Lemma constant_but (ex : list R) (f : R -> R) : forall A B, (forall t, A <= t <= B -> continuous f t) ->
  (forall t, A < t < B -> ~ In t ex -> is_derive f t 0) -> A <= B -> f A = f B.
Proof.
  induction ex as [|x ex IH]; intros A B Ct D AB.
  - destruct (MVT_gen f A B (fun _ => 0)) as [c [_ E]]; [| |lra].
    + intros t Ht. rewrite Rmin_left, Rmax_right in Ht by lra. apply D; [lra|]. intros [].
    + intros t Ht. rewrite Rmin_left, Rmax_right in Ht by lra. apply continuity_pt_filterlim, Ct. lra.
  - destruct (Rlt_dec A x) as [Ax|Ax]; [destruct (Rlt_dec x B) as [xB|xB]|].
    + rewrite (IH A x); [apply (IH x B)| | |lra]; try lra; try (intros; apply Ct; lra);
        intros t Ht N; apply D; [lra| |lra|]; intros [Z|Z]; (now apply N) || lra.
    + apply IH; [exact Ct| |exact AB]. intros t Ht N. apply D; [exact Ht|]. intros [Z|Z]; [lra|now apply N].
    + apply IH; [exact Ct| |exact AB]. intros t Ht N. apply D; [exact Ht|]. intros [Z|Z]; [lra|now apply N].
Qed.
Lemma cont_Sum n (f : nat -> R -> R) t : (forall i, (i < n)%nat -> continuous (f i) t) -> continuous (fun s => Sum n (fun i => f i s)) t.
Proof.
  induction n; intros H; cbn; [apply continuous_const|].
  apply (continuous_plus (fun s => Sum n (fun i => f i s)) (f n)); [apply IHn; intros; apply H; lia|apply H; lia].
Qed.
Lemma Vt_inv_2_holds : Vt_inv_2.
Proof.
  intros n adj V V' r v a A B ex c S VS C0 L.
  set (K := fun s => T1.kinetic_plus_V n adj V (fun i => r i s) (fun i => v i s)).
  set (U := fun s => / 2 * Sum n (fun i => Sum n (fun j => if adj i j then V i j (Cmod (r i s - r j s)%C) else 0))).
  set (M := fun s => / 2 * Sum n (fun i => Cmod (v i s) ^ 2)).
  assert (E : forall s, U s + M s = K s) by (intros s; unfold K; now rewrite energy_split).
  assert (DU : forall t, A <= t <= B -> is_derive U t (Sum n (fun i => inner (gradV n adj V' (fun j => r j t) i) (v i t)))).
  { intros t Ht. apply half_V_rate; [exact S|exact VS|intros i Hi; now apply (C0 t Ht i Hi)|intros i j Hi Hj Q; now apply (C0 t Ht i Hi)]. }
  assert (CM : forall t, A <= t <= B -> continuous M t).
  { intros t Ht. apply (continuous_ext (fun s => / 2 * Sum n (fun i => fst (v i s) * fst (v i s) + snd (v i s) * snd (v i s)))).
    - intros s. unfold M. f_equal. apply Sum_ext. intros. rewrite Cmod_sq. ring.
    - apply (continuous_mult (fun _ : R => / 2)); [apply continuous_const|]. apply (cont_Sum n (fun i s => fst (v i s) * fst (v i s) + snd (v i s) * snd (v i s))). intros i Hi.
      destruct (C0 t Ht i Hi) as (_ & C1 & C2 & _).
      apply (continuous_plus (fun s => fst (v i s) * fst (v i s)) (fun s => snd (v i s) * snd (v i s)));
        [apply (continuous_mult (fun s => fst (v i s)) (fun s => fst (v i s)))|apply (continuous_mult (fun s => snd (v i s)) (fun s => snd (v i s)))]; assumption. }
  assert (CK : forall t, A <= t <= B -> continuous K t).
  { intros t Ht. apply (continuous_ext (fun s => U s + M s)); [exact E|].
    apply (continuous_plus U M); [apply (ex_derive_continuous U); eexists; now apply DU|now apply CM]. }
  assert (DK : forall t, A <= t <= B -> ~ In t ex -> is_derive K t 0).
  { intros t Ht N. apply (is_derive_ext (fun s => U s + M s)); [exact E|]. specialize (L t Ht N).
    eapply D_eq; [apply D_plus; [now apply DU|apply kinetic_rate; intros i Hi; now apply (L i Hi)]|]. rewrite <- Sum_plus. apply Sum_zero. intros i Hi.
    rewrite (law_work n adj V' (fun i j => a i j t) (fun i => r i t) (fun i => v i t) i). ring. }
  assert (Q : forall s t, A <= s <= B -> A <= t <= B -> s <= t -> K s = K t).
  { intros s t Hs Ht st. apply (constant_but ex); [intros x Hx; apply CK; lra|intros x Hx; apply DK; lra|exact st]. }
  intros s t Hs Ht H. fold (K s) in H. fold (K t). destruct (Rle_or_lt s t) as [st|ts]; [rewrite <- (Q s t)|rewrite (Q t s)]; try assumption. lra.
Qed.
Lemma fig2_potentials n adj : T2.potentials n adj T1.fig2 T1.fig2'.
Proof.
  split; [reflexivity|]. intros i j _ _ _. destruct T1.fig2_repels as [R1 R2]. split; [|split; [exact R2|]].
  - intros s Hs. destruct (R1 s Hs) as [D P]. split; [exact D|]. split; [|exact P].
    apply derivable_continuous_pt. unfold T1.fig2'. apply ex_derive_Reals_0. auto_derive. repeat split; try lra; repeat apply Rmult_integral_contrapositive_currified; lra.
  - intros c. exists (exp c + 1). intros s Hs. pose proof (exp_pos c). unfold T1.fig2.
    assert (P : 0 < / s ^ 2) by (apply Rinv_0_lt_compat, pow_lt; lra).
    assert (L : c < ln (s ^ 2)); [|lra]. rewrite <- (ln_exp c) at 1. apply ln_increasing; [exact H|]. nra.
Qed.
Lemma energy_of_Vt n adj V r v th c : Vt n adj V r v th <= c -> T2.energy6 n adj V r v <= c.
Proof.
  unfold Vt. intros H. assert (0 <= Sum n (fun i => th i ^ 2)) by (apply Sum_ge0; intros; apply pow2_ge_0).
  change (T2.energy6 n adj V r v) with (T1.kinetic_plus_V n adj V r v). lra.
Qed.
(* as tanner_rates.Omega_bounded, without connectedness *)
Lemma Omega_2_holds : Omega_2.
Proof.
  intros n adj c S NL. exists (sqrt (2 * c)). intros r v th A H i Hi. apply energy_of_Vt in H.
  exact (proj2 (T2.bound_v_proved n adj T1.fig2 T1.fig2' r v c (conj S NL) (fig2_potentials n adj) A H i Hi)).
Qed.
Lemma rangeB_3_holds : rangeB_3.
Proof. intros n adj O y S T HO Z. exact (proj1 (T2.cor1_5_proved n adj (fun _ _ _ => 0) (fun _ _ _ => 0) (fun _ _ => RtoC 0) (fun _ _ => RtoC 0) S T) O y HO Z). Qed.
(* the followers that are not joined: k mod n <> 0 *)
Lemma joined_mod N n k j : joined N n k j -> (k mod n = j mod n)%nat.
Proof.
  intros H. induction H as [x y (_ & _ & E)|x|x y _ IH|x y z _ IH1 _ IH2]; [|reflexivity|now symmetry|now rewrite IH1].
  subst x. destruct n as [|n]; [now rewrite Nat.add_0_r|]. rewrite <- (Nat.mul_1_l (S n)) at 1. now rewrite Nat.mod_add by lia.
Qed.
Lemma joined_is N n k : (2 <= n)%nat -> (k <= S N)%nat -> (joined N n 0%nat k <-> (k mod n = 0)%nat).
Proof.
  intros Hn Hk. split.
  - intros H. apply joined_mod in H. rewrite Nat.mod_0_l in H by lia. now symmetry.
  - intros E. apply Nat.mod_divides in E as [q ->]; [|lia]. induction q as [|q IH].
    + rewrite Nat.mul_0_r. apply rst_refl.
    + apply rst_trans with (n * q)%nat; [apply IH; lia|]. apply rst_sym, rst_step. repeat split; lia.
Qed.
(* ---- cycles ---- *)
Lemma uvuv_next u v k : uvuv u v (k + 2) = (- uvuv u v k)%C.
Proof.
  unfold uvuv. rewrite (Nat.div_mod k 4) at 1 by lia. set (q := (k / 4)%nat). set (m := (k mod 4)%nat).
  assert (m < 4)%nat by (apply Nat.mod_upper_bound; lia). rewrite <- Nat.add_assoc, Nat.add_comm, Nat.mul_comm, Nat.mod_add by lia.
  destruct m as [|[|[|[|m]]]]; [reflexivity|reflexivity| | |lia]; cbn; ring.
Qed.
Lemma cycle_row n adj (x : nat -> C) k : (3 <= n)%nat -> cyclic n adj -> (k < n)%nat ->
  Csum n (fun j => RtoC (lap n adj k j) * x j)%C = (2 * x k - x ((k + 1) mod n)%nat - x ((k + (n - 1)) mod n)%nat)%C.
Proof.
  intros Hn Cy Hk. set (a := ((k + 1) mod n)%nat). set (b := ((k + (n - 1)) mod n)%nat).
  assert (La : (a < n)%nat) by (apply Nat.mod_upper_bound; lia). assert (Lb : (b < n)%nat) by (apply Nat.mod_upper_bound; lia).
  assert (Ea : a = if Nat.eqb (k + 1) n then 0%nat else (k + 1)%nat).
  { unfold a. destruct (Nat.eqb_spec (k + 1) n) as [E|E]; [rewrite E; apply Nat.mod_same; lia|apply Nat.mod_small; lia]. }
  assert (Eb : b = if Nat.eqb k 0 then (n - 1)%nat else (k - 1)%nat).
  { unfold b. destruct (Nat.eqb_spec k 0) as [E|E]; [rewrite E; apply Nat.mod_small; lia|].
    replace (k + (n - 1))%nat with (k - 1 + 1 * n)%nat by lia. rewrite Nat.mod_add by lia. apply Nat.mod_small; lia. }
  assert (W : forall j, (j < n)%nat -> w adj k j = delta j a + delta j b).
  { intros j Hj. unfold w. specialize (Cy k j Hk Hj). fold a in Cy.
    assert (Q : k = ((j + 1) mod n)%nat <-> j = b).
    { destruct (Nat.eq_dec (j + 1) n) as [E|E].
      - rewrite E, Nat.mod_same by lia. rewrite Eb. destruct (Nat.eqb_spec k 0); lia.
      - rewrite Nat.mod_small by lia. rewrite Eb. destruct (Nat.eqb_spec k 0); lia. }
    rewrite Q in Cy. destruct (Nat.eq_dec j a) as [->|Na].
    - rewrite (proj2 Cy) by now left. rewrite delta_eq, delta_neq; [ring|]. rewrite Ea, Eb.
      destruct (Nat.eqb_spec (k + 1) n), (Nat.eqb_spec k 0); lia.
    - destruct (Nat.eq_dec j b) as [->|Nb].
      + rewrite (proj2 Cy) by now right. rewrite delta_eq, delta_neq; [ring|exact Na].
      + rewrite !delta_neq by assumption. destruct (adj k j); [|ring]. exfalso. destruct (proj1 Cy eq_refl); contradiction. }
  assert (D : deg n adj k = 2).
  { unfold deg. rewrite (Sum_ext n _ (fun j => delta j a * 1 + delta j b * 1)) by (intros j Hj; rewrite (W j Hj); ring).
    rewrite Sum_plus, (Sum_delta n a (fun _ => 1)), (Sum_delta n b (fun _ => 1)) by assumption. ring. }
  assert (G : forall f : nat -> R, Sum n (fun j => lap n adj k j * f j) = 2 * f k - f a - f b).
  { intros f. unfold lap. rewrite D. rewrite (Sum_ext n _ (fun j => delta k j * (2 * f j) - (delta j a * f j + delta j b * f j)))
      by (intros j Hj; rewrite (W j Hj); ring).
    rewrite Sum_minus, Sum_plus, (Sum_delta_l n k (fun j => 2 * f j)), !Sum_delta by assumption. ring. }
  unfold Csum. apply injective_projections; cbn.
  - rewrite (Sum_ext n _ (fun j => lap n adj k j * fst (x j))) by (intros; ring). rewrite (G (fun j => fst (x j))). ring.
  - rewrite (Sum_ext n _ (fun j => lap n adj k j * snd (x j))) by (intros; ring). rewrite (G (fun j => snd (x j))). ring.
Qed.
(* ---- Paley: rows of Laplacians, synchronised arrangements ---- *)
Lemma row_among n adj x k : (k < n)%nat -> Csum n (fun j => RtoC (lap n adj k j) * x j)%C = among n adj k (fun j => x k - x j)%C.
Proof.
  intros Hk. assert (G : forall f : nat -> R, Sum n (fun j => lap n adj k j * f j) = Sum n (fun j => if adj k j then f k - f j else 0)).
  { intros f. unfold lap. rewrite (Sum_ext n _ (fun j => delta k j * (deg n adj k * f j) - w adj k j * f j)) by (intros; ring).
    rewrite Sum_minus, (Sum_delta_l n k (fun j => deg n adj k * f j) Hk). unfold deg. rewrite <- Sum_scal_r, <- Sum_minus. apply Sum_ext. intros j _. unfold w.
    destruct (adj k j); ring. }
  unfold among, Csum. apply injective_projections; cbn [fst snd].
  - rewrite (Sum_ext n _ (fun j => lap n adj k j * fst (x j))) by (intros; cbn; ring). rewrite (G (fun j => fst (x j))).
    apply Sum_ext. intros j _. destruct (adj k j); cbn; ring.
  - rewrite (Sum_ext n _ (fun j => lap n adj k j * snd (x j))) by (intros; cbn; ring). rewrite (G (fun j => snd (x j))).
    apply Sum_ext. intros j _. destruct (adj k j); cbn; ring.
Qed.
Lemma among_inner n adj k f z : inner z (among n adj k f) = Sum n (fun j => if adj k j then inner z (f j) else 0).
Proof.
  unfold among. rewrite inner_C. unfold Csum. cbn [fst snd]. rewrite <- !Sum_scal, <- Sum_plus. apply Sum_ext. intros j _.
  destruct (adj k j); rewrite ?inner_C; cbn; ring.
Qed.
Lemma inner_e a b : inner (Ci * expi a)%C (expi b) = sin (b - a).
Proof. rewrite inner_C, sin_minus. cbn. ring. Qed.
Lemma steers K th d : 0 < K -> steers_towards (K * inner (Ci * expi th)%C d) th d.
Proof.
  intros HK. split.
  - intros ->. rewrite inner_C. cbn. ring.
  - intros rho psi Hr ->. replace (inner (Ci * expi th)%C (RtoC rho * expi psi)%C) with (rho * sin (psi - th)) by (rewrite inner_C, sin_minus; cbn; ring).
    assert (0 < K * rho) by now apply Rmult_lt_0_compat. split; [|split]; intros Hs.
    + rewrite <- Rmult_assoc. now apply Rmult_lt_0_compat.
    + rewrite <- Rmult_assoc. replace 0 with (K * rho * 0) by ring. now apply Rmult_lt_compat_l.
    + rewrite Hs. ring.
Qed.
Lemma velocity_one r t v v' : is_velocity r t v -> is_velocity r t v' -> v = v'.
Proof.
  intros [A1 A2] [B1 B2]. apply injective_projections.
  - apply is_derive_unique in A1. apply is_derive_unique in B1. now rewrite <- A1, <- B1.
  - apply is_derive_unique in A2. apply is_derive_unique in B2. now rewrite <- A2, <- B2.
Qed.
Lemma expi_shift a b c : expi a = expi b -> expi (a + c) = expi (b + c).
Proof.
  intros E. assert (A := f_equal fst E). assert (B := f_equal snd E). cbn in A, B. unfold expi. rewrite !cos_plus, !sin_plus, A, B. reflexivity.
Qed.
Lemma sync_always n r th u t0 : sync_arrangement n r th u t0 -> (forall t, synchronized n (fun k => th k t)) /\
  forall t j k, (j < n)%nat -> (k < n)%nat -> u j t = u k t.
Proof.
  intros (M & L & S). split.
  - intros t j k Hj Hk. pose proof (constant (fun s => th k s - th j s) (fun s => L s j k Hj Hk) t t0) as E. cbv beta in E.
    replace (th j t) with (th j t0 + (th j t - th j t0)) by ring. replace (th k t) with (th k t0 + (th j t - th j t0)) by lra.
    apply expi_shift. now apply S.
  - intros t j k Hj Hk. pose proof (L t j k Hj Hk) as E. pose proof (D_minus _ _ _ _ _ (proj2 (M t k Hk)) (proj2 (M t j Hj))) as F.
    apply is_derive_unique in E. apply is_derive_unique in F. rewrite E in F. lra.
Qed.
Lemma Cmod_expi a : Cmod (expi a) = 1.
Proof. unfold Cmod, expi. cbn [fst snd]. pose proof (sin2_cos2 a) as E. unfold Rsqr in E. replace (_ + _) with 1 by (rewrite <- E; ring). apply sqrt_1. Qed.
Lemma ori9_sines n K1 th k : ori9 n K1 th k = - K1 * (/ INR n * Sum n (fun j => sin (th j - th k))).
Proof.
  unfold ori9. f_equal. rewrite (Sum_ext n _ (fun j => fst (Ci * expi (th k))%C * fst (expi (th j)) + snd (Ci * expi (th k))%C * snd (expi (th j))))
    by (intros; now rewrite <- inner_e, inner_C).
  rewrite inner_C. unfold Csum. rewrite Sum_plus, !Sum_scal. cbn [fst snd Cmult RtoC]. ring.
Qed.
Lemma WL_is n adj th : WL n adj th = W1 n adj th.
Proof.
  destruct (W1_formula n adj th) as [_ F]. rewrite F. unfold WL. f_equal. apply Sum_ext. intros k Hk.
  rewrite (row_among n adj (fun j => expi (th j)) k Hk), among_inner. unfold deg. fold (w adj k). rewrite <- Sum_minus. apply Sum_ext. intros j _. unfold w.
  destruct (adj k j); [|ring]. rewrite !inner_C. cbn. pose proof (sin2_cos2 (th k)) as T. unfold Rsqr in T. lra.
Qed.
(* ---- multiplicities ---- *)
Lemma finite_choice (A : Type) (d : A) (P : nat -> A -> Prop) n : (forall i, (i < n)%nat -> exists a, P i a) -> exists f, forall i, (i < n)%nat -> P i (f i).
Proof.
  induction n as [|n IH]; intros H; [exists (fun _ => d); intros; lia|]. destruct IH as [f F]; [intros; apply H; lia|]. destruct (H n ltac:(lia)) as [a Ha].
  exists (fun i => if Nat.eqb i n then a else f i). intros i Hi. destruct (Nat.eqb_spec i n) as [->|]; [exact Ha|apply F; lia].
Qed.
Lemma components_of n adj : undirected adj -> exists c, components n adj c.
Proof.
  intros S. destruct (tanner_components.components_exist n adj S) as (l & ND & B & U & C).
  destruct (finite_choice nat 0%nat (fun i p => (p < length l)%nat /\ tanner_components.joined n adj (nth p l 0%nat) i) n) as [comp Q].
  { intros i Hi. destruct (C i Hi) as (a & Ia & J). apply (In_nth l a 0%nat) in Ia as (p & Hp & E). exists p. rewrite E. now split. }
  exists (length l), comp. split; [intros; now apply Q|]. split.
  - intros p Hp. assert (I : In (nth p l 0%nat) l) by now apply nth_In. exists (nth p l 0%nat). split; [now apply B|].
    destruct (Q (nth p l 0%nat) (B _ I)) as [Hq J]. apply (proj1 (NoDup_nth l 0%nat) ND); [exact Hq|exact Hp|]. apply U; [now apply nth_In|exact I|exact J].
  - intros i j Hi Hj. destruct (Q i Hi) as [Pi Ji], (Q j Hj) as [Pj Jj]. split; intros E.
    + rewrite E in Ji. apply rt_trans with (nth (comp j) l 0%nat); [now apply tanner_components.joined_sym|exact Jj].
    + apply (proj1 (NoDup_nth l 0%nat) ND); [exact Pi|exact Pj|]. apply U; [now apply nth_In..|]. apply rt_trans with i; [exact Ji|].
      apply rt_trans with j; [exact E|now apply tanner_components.joined_sym].
Qed.
Lemma times_ext n L x y i : (forall j, (j < n)%nat -> x j = y j) -> times n L x i = times n L y i.
Proof. intros H. apply Sum_ext. intros j Hj. now rewrite (H j Hj). Qed.
Lemma iter_first (A : Type) (f : A -> A) q x : Nat.iter q f (f x) = Nat.iter (Datatypes.S q) f x.
Proof. induction q as [|q IH]; [reflexivity|]. change (f (Nat.iter q f (f x)) = f (Nat.iter (Datatypes.S q) f x)). now rewrite IH. Qed.
Lemma Lw_4_holds : Lw_4.
Proof.
  intros n adj wt S NL P. split; [now apply components_of|]. intros c (comp & C1 & C2 & C3) m Hm.
  set (W := fun i j => if (Nat.ltb i n && Nat.ltb j n && adj i j)%bool then wt i j else 1).
  assert (Wr : forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> W i j = wt i j).
  { intros i j Hi Hj A. unfold W. apply Nat.ltb_lt in Hi as ->. apply Nat.ltb_lt in Hj as ->. now rewrite A. }
  assert (WC : forall i j, W i j = 1 \/ (i < n)%nat /\ (j < n)%nat /\ adj i j = true).
  { intros i j. unfold W. destruct (Nat.ltb_spec i n), (Nat.ltb_spec j n), (adj i j) eqn:A; cbn; auto. }
  assert (WS : forall i j, W i j = W j i).
  { intros i j. unfold W. rewrite (S j i), (Bool.andb_comm (Nat.ltb j n)). destruct (Nat.ltb i n && Nat.ltb j n && adj i j)%bool eqn:E; [|reflexivity].
    apply andb_prop in E as [E A]. apply andb_prop in E as [E1 E2]. apply Nat.ltb_lt in E1, E2. now apply P. }
  assert (WP : forall i j, 0 < W i j). { intros i j. destruct (WC i j) as [->|(Hi & Hj & A)]; [lra|]. rewrite (Wr i j Hi Hj A). now apply P. }
  destruct (finite_choice nat 0%nat (fun l i => (i < n)%nat /\ comp i = l) c C2) as [rep Rp].
  set (l := map rep (seq 0 c)).
  assert (Il : forall a, In a l <-> exists p, (p < c)%nat /\ a = rep p).
  { intros a. unfold l. rewrite in_map_iff. split; intros (p & H1 & H2); exists p; rewrite ?in_seq in *; split; (lia || now symmetry). }
  assert (O : tanner_components.one_of_each n adj l).
  { split; [|split; [|split]].
    - apply (NoDup_map_inv comp). unfold l. rewrite map_map. rewrite (map_ext_in (fun x => comp (rep x)) (fun x => x)); [rewrite map_id; apply seq_NoDup|].
      intros p I. apply in_seq in I. apply Rp. lia.
    - intros a I. apply Il in I as (p & Hp & ->). now apply Rp.
    - intros a b Ia Ib J. apply Il in Ia as (p & Hp & ->). apply Il in Ib as (q & Hq & ->). destruct (Rp p Hp) as [R1 R2], (Rp q Hq) as [R3 R4].
      apply (C3 _ _ R1 R3) in J. congruence.
    - intros k Hk. exists (rep (comp k)). pose proof (C1 k Hk) as Hc. destruct (Rp _ Hc) as [R1 R2]. split; [apply Il; now exists (comp k)|]. now apply C3. }
  destruct (tanner_components.zero_multiplicity n adj W l S WS WP O) as (Z1 & Z2 & Z3). cbv zeta in Z1, Z2, Z3.
  set (L := tanner_graph.lapw n (fun i j => w adj i j * W i j)) in *.
  assert (LL : forall x k, (k < n)%nat -> times n (lapw n adj wt) x k = Sum n (fun j => L k j * x j)).
  { intros x k Hk. assert (E : forall j, (j < n)%nat -> (if adj k j then wt k j else 0) = w adj k j * W k j).
    { intros j Hj. unfold w. destruct (adj k j) eqn:A; [rewrite (Wr k j Hk Hj A)|]; ring. }
    apply Sum_ext. intros j Hj. f_equal. unfold lapw, L, tanner_graph.lapw. rewrite (E j Hj). f_equal. f_equal. now apply Sum_ext. }
  set (null := fun x => forall k, (k < n)%nat -> Sum n (fun j => L k j * x j) = 0).
  assert (Up : forall x q, null x -> (1 <= q)%nat -> forall k, (k < n)%nat -> Nat.iter q (times n (lapw n adj wt)) x k = 0).
  { intros x q N Hq. induction q as [|[|q] IH]; [lia|intros k Hk; cbn; rewrite LL by exact Hk; now apply N|]. intros k Hk.
    change (times n (lapw n adj wt) (Nat.iter (Datatypes.S q) (times n (lapw n adj wt)) x) k = 0).
    rewrite (times_ext n _ _ (fun _ => 0)) by (intros j Hj; apply IH; [lia|exact Hj]). apply Sum_zero. intros; ring. }
  assert (Down : forall q x, (forall k, (k < n)%nat -> Nat.iter (Datatypes.S q) (times n (lapw n adj wt)) x k = 0) -> null x).
  { induction q as [|q IH]; intros x N; [intros k Hk; rewrite <- LL by exact Hk; now apply N|]. unfold null. apply (Z3 x).
    assert (E : null (times n (lapw n adj wt) x)) by (apply IH; intros k Hk; rewrite iter_first; now apply N).
    intros k Hk. rewrite <- (E k Hk). apply Sum_ext. intros j Hj. now rewrite <- LL by exact Hj. }
  destruct (finite_choice (nat -> R) (fun _ => 0) (fun p x => null x /\ forall a, In a l -> x a = delta (comp a) p) c) as [b B].
  { intros p _. destruct (Z1 (fun a => delta (comp a) p)) as (x & N & E). now exists x. }
  assert (Br : forall p q, (p < c)%nat -> (q < c)%nat -> b p (rep q) = delta q p).
  { intros p q Hp Hq. destruct (B p Hp) as [_ E]. rewrite E by (apply Il; now exists q). now rewrite (proj2 (Rp q Hq)). }
  exists b. split; [intros p Hp; apply Up; [now apply B|exact Hm]|]. split.
  - intros a E p Hp. destruct (Rp p Hp) as [R1 _]. rewrite <- (E _ R1). rewrite (Sum_ext c _ (fun q => delta p q * a q)).
    + now rewrite Sum_delta_l.
    + intros q Hq. rewrite (Br q p Hq Hp). ring.
  - intros x N. destruct m as [|m]; [lia|]. apply Down in N. exists (fun p => x (rep p)). apply Z2; [exact N| |].
    + intros k Hk. rewrite (Sum_ext n _ (fun j => Sum c (fun p => x (rep p) * (L k j * b p j)))) by (intros; rewrite <- Sum_scal; apply Sum_ext; intros; ring).
      rewrite Sum_swap. apply Sum_zero. intros p Hp. rewrite Sum_scal, (proj1 (B p Hp) k Hk). ring.
    + intros a I. apply Il in I as (q & Hq & ->). rewrite (Sum_ext c _ (fun p => delta q p * x (rep p))).
      * now rewrite (Sum_delta_l c q (fun p => x (rep p))).
      * intros p Hp. rewrite (Br p q Hp Hq). ring.
Qed.
Lemma L_4_holds : L_4.
Proof.
  intros n adj S NL. destruct (Lw_4_holds n adj (fun _ _ => 1) S NL ltac:(intros; lra)) as [A B]. split; [exact A|]. intros c H m Hm.
  assert (E : forall x i, times n (lap n adj) x i = times n (lapw n adj (fun _ _ => 1)) x i) by reflexivity.
  exact (B c H m Hm).
Qed.
Lemma rangeB_2_holds : rangeB_2.
Proof.
  intros n adj O Hn S T HO. pose proof (tanner_components.tree_edges n adj O Hn (proj1 S) (T2.tree_is n adj S T) HO). lia.
Qed.
(* ---- (13) ---- *)
Lemma dissipation_is n adj v : dissipation n adj v = - qform (2 * n) (kron2 (lap n adj)) (stack v).
Proof. rewrite kron_split. unfold dissipation, qform, times. ring. Qed.
Lemma dissipation_ext n (g h : graph) v : (forall i j, (i < n)%nat -> (j < n)%nat -> g i j = h i j) -> dissipation n g v = dissipation n h v.
Proof.
  intros E. assert (L : forall i j, (i < n)%nat -> (j < n)%nat -> lap n g i j = lap n h i j).
  { intros i j Hi Hj. unfold lap, deg, w. rewrite (E i j Hi Hj). do 2 f_equal. apply Sum_ext. intros m Hm. now rewrite (E i m Hi Hm). }
  unfold dissipation, times. f_equal; [f_equal|]; apply Sum_ext; intros i Hi; f_equal; apply Sum_ext; intros j Hj; now rewrite (L i j Hi Hj).
Qed.
Lemma gap n (r : nat -> C) R0 : exists d, 0 < d /\ forall i j, (i < n)%nat -> (j < n)%nat -> Cmod (r i - r j)%C <> R0 -> d <= Rabs (Cmod (r i - r j)%C - R0).
Proof.
  assert (F : forall m (a : nat -> R), exists d, 0 < d /\ forall i, (i < m)%nat -> a i <> 0 -> d <= Rabs (a i)).
  { induction m as [|m IH]; intros a; [exists 1; split; [lra|intros; lia]|]. destruct (IH a) as (d & Hd & H). destruct (Req_dec (a m) 0) as [Z|Z].
    - exists d. split; [exact Hd|]. intros i Hi N. destruct (Nat.eq_dec i m) as [->|]; [contradiction|apply H; [lia|exact N]].
    - exists (Rmin d (Rabs (a m))). split; [apply Rmin_pos; [exact Hd|now apply Rabs_pos_lt]|]. intros i Hi N.
      destruct (Nat.eq_dec i m) as [->|]; [apply Rmin_r|]. eapply Rle_trans; [apply Rmin_l|]. apply H; [lia|exact N]. }
  destruct (F (n * n)%nat (fun p => Cmod (r (p / n)%nat - r (p mod n)%nat)%C - R0)) as (d & Hd & H). exists d. split; [exact Hd|]. intros i j Hi Hj N.
  specialize (H (n * i + j)%nat ltac:(nia)). replace ((n * i + j) / n)%nat with i in H by (apply (Nat.div_unique _ n i j); lia).
  replace ((n * i + j) mod n)%nat with j in H by (apply (Nat.mod_unique _ n i j); lia). apply H. lra.
Qed.
Lemma bounded n (r : nat -> C) : exists M, 0 < M /\ forall i, (i < n)%nat -> Cmod (r i) <= M.
Proof.
  exists (1 + Sum n (fun i => Cmod (r i))). assert (P : 0 <= Sum n (fun i => Cmod (r i))) by (apply Sum_ge0; intros; apply Cmod_ge_0).
  split; [lra|]. intros i Hi. pose proof (Sum_term_le n (fun i => Cmod (r i)) i ltac:(intros; apply Cmod_ge_0) Hi). cbv beta in H. lra.
Qed.
(* all lengths 1 + h times as large, h small *)
Lemma scaled n (r v : nat -> C) R0 e (up : bool) : 0 < R0 -> 0 < e -> exists r', (forall i, (i < n)%nat -> Cmod (r' i - r i)%C < e) /\ no_ties n r' R0 /\
  dissipation n (T2.by_distance r' R0) v = dissipation n (if up then tanner2_facts.linked_below r R0 else tanner2_facts.linked_upto r R0) v.
Proof.
  intros HR He. destruct (gap n r R0) as (d & Hd & G). destruct (bounded n r) as (M & HM & B).
  set (q := Rmin (/ 2) (Rmin (e / (2 * M)) (d / (4 * M)))).
  assert (Q0 : 0 < q) by (unfold q; repeat apply Rmin_pos; try lra; apply Rdiv_lt_0_compat; lra).
  assert (Q1 : q <= / 2) by apply Rmin_l. assert (Q2 : q <= e / (2 * M)) by (eapply Rle_trans; [apply Rmin_r|apply Rmin_l]).
  assert (Q3 : q <= d / (4 * M)) by (eapply Rle_trans; [apply Rmin_r|apply Rmin_r]).
  assert (Q2' : q * M <= e / 2). { apply (Rmult_le_compat_r M) in Q2; [|lra]. replace (e / (2 * M) * M) with (e / 2) in Q2 by (field; lra). exact Q2. }
  assert (Q3' : q * (2 * M) <= d / 2). { apply (Rmult_le_compat_r (2 * M)) in Q3; [|lra]. replace (d / (4 * M) * (2 * M)) with (d / 2) in Q3 by (field; lra). exact Q3. }
  set (h := if up then q else - q). assert (Ha : Rabs h = q) by (unfold h; destruct up; [apply Rabs_right|rewrite Rabs_Ropp; apply Rabs_right]; lra).
  assert (Hb : - q <= h <= q) by (unfold h; destruct up; lra).
  exists (fun i => (RtoC (1 + h) * r i)%C).
  assert (D : forall i j, Cmod (RtoC (1 + h) * r i - RtoC (1 + h) * r j)%C = Cmod (r i - r j)%C + h * Cmod (r i - r j)%C).
  { intros i j. replace (RtoC (1 + h) * r i - RtoC (1 + h) * r j)%C with (RtoC (1 + h) * (r i - r j))%C by ring. rewrite Cmod_mult, Cmod_R, Rabs_right by lra. ring. }
  assert (Dm : forall i j, (i < n)%nat -> (j < n)%nat -> - (d / 2) <= h * Cmod (r i - r j)%C <= d / 2).
  { intros i j Hi Hj. apply Rabs_le_between. rewrite Rabs_mult, Ha. rewrite (Rabs_right (Cmod _)) by (apply Rle_ge, Cmod_ge_0).
    eapply Rle_trans; [|exact Q3']. apply Rmult_le_compat_l; [lra|]. unfold Cminus. eapply Rle_trans; [apply Cmod_triangle|]. rewrite Cmod_opp.
    pose proof (B i Hi). pose proof (B j Hj). lra. }
  assert (T : forall i j, (i < n)%nat -> (j < n)%nat -> let c := Cmod (r i - r j)%C in
    c < R0 /\ c + h * c < R0 \/ R0 < c /\ R0 < c + h * c \/ c = R0 /\ (if up then R0 < c + h * c else c + h * c < R0)).
  { intros i j Hi Hj c. pose proof (Dm i j Hi Hj) as E. fold c in E. specialize (G i j Hi Hj). fold c in G. destruct (Rtotal_order c R0) as [L|[L|L]].
    - left. specialize (G ltac:(lra)). rewrite Rabs_left in G by lra. lra.
    - right; right. split; [exact L|]. rewrite L. unfold h. assert (0 < q * R0) by now apply Rmult_lt_0_compat. destruct up; lra.
    - right; left. specialize (G ltac:(lra)). rewrite Rabs_right in G by lra. lra. }
  split; [|split].
  - intros i Hi. replace (RtoC (1 + h) * r i - r i)%C with (RtoC h * r i)%C by (rewrite RtoC_plus; ring). rewrite Cmod_mult, Cmod_R, Ha.
    eapply Rle_lt_trans; [apply Rmult_le_compat_l; [lra|now apply B]|]. lra.
  - intros i j Hi Hj. rewrite D. destruct (T i j Hi Hj) as [X|[X|X]]; destruct up; lra.
  - apply dissipation_ext. intros i j Hi Hj. unfold T2.by_distance. rewrite D. pose proof (T i j Hi Hj) as X. cbv zeta in X.
    destruct up; unfold tanner2_facts.linked_below, tanner2_facts.linked_upto, tanner2_facts.linked_where, norm; f_equal.
    + destruct (Rlt_dec _ R0), (Rlt_dec _ R0); try reflexivity; exfalso; lra.
    + destruct (Rlt_dec _ R0), (Rle_dec _ R0); try reflexivity; exfalso; lra.
Qed.
Lemma Cmod_gap (a b : C) : Cmod a <= Cmod b + Cmod (a - b)%C.
Proof. replace a with (b + (a - b))%C at 1 by ring. apply Cmod_triangle. Qed.
(* tanner2_facts.rhs13 lets every pair at the distance R0 be linked or not; no other positions need be near where that is so *)
Lemma right_of_13_is n R0 r v q : 0 < R0 -> (right_of_13 n R0 r v q <-> tanner2_facts.rhs13 n r v R0 q).
Proof.
  intros HR. set (lo := dissipation n (tanner2_facts.linked_upto r R0) v). set (hi := dissipation n (tanner2_facts.linked_below r R0) v).
  assert (Bd : forall adj, tanner2_facts.allowed n r R0 adj -> lo <= dissipation n adj v <= hi).
  { intros adj A. pose proof (tanner2_facts.allowed_between n r v R0 adj A) as K. unfold lo, hi. rewrite !dissipation_is. lra. }
  assert (Near : near_value n R0 r v lo /\ near_value n R0 r v hi).
  { split; intros e He.
    - destruct (scaled n r v R0 e false HR He) as (r' & A & B & E). exists r'. split; [exact A|]. split; [exact B|now symmetry].
    - destruct (scaled n r v R0 e true HR He) as (r' & A & B & E). exists r'. split; [exact A|]. split; [exact B|now symmetry]. }
  split.
  - intros H. assert (K : lo <= q <= hi).
    { apply H. intros s N. destruct (gap n r R0) as (d & Hd & G). destruct (N (d / 4) ltac:(lra)) as (r' & A & _ & ->). apply Bd.
      split; [|split].
      - intros i j. unfold T2.by_distance. rewrite (Nat.eqb_sym i j), (Cmod_swap (r' i)). reflexivity.
      - intros i. unfold T2.by_distance. now rewrite Nat.eqb_refl.
      - intros i j Hi Hj Nij. unfold T2.by_distance. apply Nat.eqb_neq in Nij. rewrite Nij. unfold norm. specialize (G i j Hi Hj).
        assert (X : Rabs (Cmod (r' i - r' j)%C - Cmod (r i - r j)%C) <= d / 2).
        { apply Rabs_le. pose proof (A i Hi) as Ai. pose proof (A j Hj) as Aj.
          pose proof (Cmod_gap (r' i - r' j)%C (r i - r j)%C) as G1. pose proof (Cmod_gap (r i - r j)%C (r' i - r' j)%C) as G2.
          rewrite (Cmod_swap (r i - r j)%C) in G2.
          assert (G3 : Cmod (r' i - r' j - (r i - r j))%C <= Cmod (r' i - r i)%C + Cmod (r' j - r j)%C).
          { replace (r' i - r' j - (r i - r j))%C with ((r' i - r i) + - (r' j - r j))%C by ring.
            eapply Rle_trans; [apply Cmod_triangle|]. rewrite Cmod_opp. lra. }
          lra. }
        apply Rabs_le_between in X. cbn [negb andb]. split; intros L; destruct (Rlt_dec _ R0) as [Q|Q]; try reflexivity; exfalso.
        + apply Q. specialize (G ltac:(lra)). rewrite Rabs_left in G by lra. lra.
        + specialize (G ltac:(lra)). rewrite Rabs_right in G by lra. lra. }
    exists (tanner2_facts.linked_upto r R0), (tanner2_facts.linked_below r R0). split; [apply tanner2_facts.upto_allowed|]. split; [apply tanner2_facts.below_allowed|].
    rewrite <- !dissipation_is. exact K.
  - intros (a & b & Aa & Ab & K) x y H. rewrite <- !dissipation_is in K. pose proof (Bd a Aa). pose proof (Bd b Ab). pose proof (H lo (proj1 Near)). pose proof (H hi (proj2 Near)). lra.
Qed.
Lemma eq13_1_holds : eq13_1.
Proof.
  intros n R0 r v HR. destruct (tanner2_facts.eq13_interval n r v R0) as (e & f & H & Q). exists e, f. split; [exact H|]. intros q.
  rewrite (right_of_13_is n R0 r v q HR). apply Q.
Qed.
Lemma eq13_2_holds : eq13_2.
Proof.
  intros n R0 r v HR NT q. rewrite (right_of_13_is n R0 r v q HR), dissipation_is.
  apply tanner2_facts.eq13_no_tie; [intros i j Hi Hj _; now apply NT|]. exact (tanner2_facts.below_allowed n r R0).
Qed.
(* ---- Veerman: the n-th neighbours ---- *)
Lemma joined_same N n k : (2 <= n)%nat -> (k <= S N)%nat -> (joined N n 0%nat k <-> veerman_numbers.joined n N 0 k).
Proof.
  intros Hn Hk. split.
  - intros H. apply (joined_is N n k Hn Hk) in H. apply Nat.mod_divides in H as [q ->]; [|lia]. induction q as [|q IH].
    + rewrite Nat.mul_0_r. constructor.
    + apply (veerman_rest.joined_end n N 0 (n * q)%nat); [apply IH; lia|]. repeat split; lia.
  - assert (G : forall i j, veerman_numbers.joined n N i j -> joined N n i j); [|apply G]. intros i j H.
    induction H as [i|i j m (A & B & T) _ IH]; [apply rst_refl|]. apply rst_trans with j; [|exact IH].
    destruct T as [E|E]; [apply rst_sym|]; apply rst_step; repeat split; lia.
Qed.
Definition weight (N n k j : nat) : R := if Nat.leb k (S N) then
  (if Nat.leb n k then if Nat.leb (k + n) (S N) then / 2 * delta j (k - n) + / 2 * delta j (k + n) else delta j (k - n)
   else if Nat.leb (k + n) (S N) then delta j (k + n) else 0) else 0.
Lemma weight_sum N n k (y : nat -> R) : (k <= S N)%nat ->
  Sum (S (S N)) (fun j => weight N n k j * (y k - y j)) = listens N n y k.
Proof.
  intros Hk. assert (D : forall a, (a < S (S N))%nat -> Sum (S (S N)) (fun j => delta j a * (y k - y j)) = y k - y a) by (intros a Ha; now rewrite (Sum_delta _ a (fun j => y k - y j))).
  unfold weight, listens. apply Nat.leb_le in Hk as E. rewrite E. destruct (Nat.leb_spec n k) as [A|A], (Nat.leb_spec (k + n) (S N)) as [B|B].
  - rewrite (Sum_ext _ _ (fun j => / 2 * (delta j (k - n) * (y k - y j)) + / 2 * (delta j (k + n) * (y k - y j)))) by (intros; ring).
    rewrite Sum_plus, !Sum_scal, !D by lia. field.
  - apply D. lia.
  - apply D. lia.
  - rewrite (Sum_ext _ _ (fun _ => 0)) by (intros; ring). apply Sum_0.
Qed.
Lemma nth_2_holds : nth_2.
Proof.
  intros N n f g h x u Hn M Z. split; [intros H; apply (joined_same N n 1 Hn ltac:(lia)) in H; exact (veerman_numbers.nth_neighbour n N Hn H)|].
  assert (F : veerman_rest.follows n N f g (weight N n) (fun k t => x k t - h k) u).
  { split.
    - intros k j NZ. unfold weight in NZ. destruct (Nat.leb_spec k (S N)) as [Hk|Hk]; [|now destruct NZ].
      assert (Dz : forall a b, delta a b <> 0 -> a = b) by (intros a b H; destruct (Nat.eq_dec a b) as [E|E]; [exact E|exfalso; apply H; now apply delta_neq]).
      destruct (Nat.leb_spec n k) as [A|A], (Nat.leb_spec (k + n) (S N)) as [B|B]; [| | |now destruct NZ].
      + destruct (Nat.eq_dec j (k - n)) as [E|E]; [repeat split; lia|]. destruct (Nat.eq_dec j (k + n)) as [E'|E']; [repeat split; lia|].
        exfalso. apply NZ. rewrite !delta_neq by assumption. ring.
      + apply Dz in NZ. repeat split; lia.
      + apply Dz in NZ. repeat split; lia.
    - intros k t Hk Ht. destruct (M t Ht k Hk) as [D1 D2]. split.
      + eapply D_eq; [apply D_minus; [exact D1|apply D_const]|]. ring.
      + eapply D_eq; [exact D2|]. rewrite <- (weight_sum N n k (fun j => x j t - h j)), <- (weight_sum N n k (fun j => u j t)) by lia.
        rewrite <- !Sum_scal, <- Sum_plus. apply Sum_ext. intros; ring. }
  intros k Hk NJ.
  assert (Q : forall t, 0 <= t -> x k t = h k).
  { intros t Ht. assert (E : x k t - h k = 0); [|lra].
    refine (proj1 (veerman_rest.unjoined_rest n N f g (weight N n) _ u F _ k t Hk _ Ht)).
    - intros i Hi J. destruct (Z i Hi) as [Z1 Z2]; [intros J'; apply J, (joined_same N n i Hn ltac:(lia)), J'|]. cbv beta. split; [lra|exact Z2].
    - intros J. apply NJ, (joined_same N n k Hn ltac:(lia)), J. }
  split; [exact Q|]. intros L b. destruct (L (b + h k)) as [T HT]. exists (Rmax 0 T). intros t Ht. pose proof (Rmax_l 0 T). pose proof (Rmax_r 0 T).
  rewrite Q by lra. specialize (HT t ltac:(lra)). lra.
Qed.
(* ---- columns of the Fourier matrix ---- *)
Lemma ring_cyclic n : (3 <= n)%nat -> cyclic n (paley_fourier.ring_graph n).
Proof.
  intros Hn k j Hk Hj. unfold paley_fourier.ring_graph, paley_fourier.ring_offset. rewrite Bool.orb_true_iff, !Nat.eqb_eq.
  assert (A : ((k + 1) mod n = if Nat.eqb (k + 1) n then 0 else k + 1)%nat) by (destruct (Nat.eqb_spec (k + 1) n) as [E|E]; [rewrite E; apply Nat.mod_same|apply Nat.mod_small]; lia).
  assert (B : ((j + 1) mod n = if Nat.eqb (j + 1) n then 0 else j + 1)%nat) by (destruct (Nat.eqb_spec (j + 1) n) as [E|E]; [rewrite E; apply Nat.mod_same|apply Nat.mod_small]; lia).
  assert (D : ((j + n - k) mod n = if Nat.leb k j then j - k else j + n - k)%nat).
  { destruct (Nat.leb_spec k j); [replace (j + n - k)%nat with (j - k + 1 * n)%nat by lia; rewrite Nat.mod_add by lia|]; apply Nat.mod_small; lia. }
  rewrite A, B, D. destruct (Nat.eqb_spec (k + 1) n), (Nat.eqb_spec (j + 1) n), (Nat.leb_spec k j); lia.
Qed.
Lemma column_is n m k : (1 <= n)%nat -> (1 <= m)%nat -> column n m k = (RtoC (/ sqrt (INR n)) * expi (paley_fourier.wave n (m - 1) k))%C.
Proof. intros Hn Hm. unfold column, paley_fourier.wave. do 2 f_equal. field. apply not_0_INR. lia. Qed.
Lemma column_pattern n m th : (1 <= n)%nat -> (1 <= m)%nat -> in_phase n (column n m) th -> paley_patterns.pattern (n / Nat.gcd n (m - 1)) n th.
Proof.
  intros Hn Hm (c & Hc & E). assert (P : 0 < / sqrt (INR n)) by (apply Rinv_0_lt_compat, sqrt_lt_R0, lt_0_INR; lia).
  destruct (paley_fish.wave_pattern n (m - 1) Hn) as [H1 (th0 & cl & Q & R)]. split; [exact H1|]. exists th0, cl. split; [|exact R].
  intros k Hk. destruct (Q k Hk) as [Q1 Q2]. split; [exact Q1|]. rewrite <- Q2. specialize (E k Hk). rewrite (column_is n m k Hn Hm) in E.
  assert (Ec : / sqrt (INR n) = c).
  { apply (f_equal Cmod) in E. rewrite !Cmod_mult, !Cmod_expi, !Cmod_R, !Rabs_right in E by lra. lra. }
  rewrite <- Ec in E. assert (E1 := f_equal fst E). assert (E2 := f_equal snd E). cbn in E1, E2. symmetry. unfold expi.
  f_equal; apply (Rmult_eq_reg_l (/ sqrt (INR n))); lra.
Qed.
Lemma cyclic_2_holds : cyclic_2.
Proof.
  intros n adj m Hn Cy Hm. split; [|intros th; apply column_pattern; lia].
  destruct (paley_fish.fourier_column n (m - 1) Hn) as [E _]. exists (RtoC (2 - 2 * cos (2 * PI * INR (m - 1) / INR n))). split.
  - exists 0%nat. split; [lia|]. rewrite column_is by lia. intros Z. apply (f_equal Cmod) in Z. rewrite Cmod_mult, Cmod_expi, Cmod_R, Cmod_0 in Z.
    assert (0 < / sqrt (INR n)) by (apply Rinv_0_lt_compat, sqrt_lt_R0, lt_0_INR; lia). rewrite Rabs_right in Z; lra.
  - intros k Hk. specialize (E k Hk). pose proof (cycle_row n _ (phasors (paley_fourier.wave n (m - 1))) k Hn (ring_cyclic n Hn) Hk) as R.
    change (Csum n _) with (row n (lap n (paley_fourier.ring_graph n)) k (phasors (paley_fourier.wave n (m - 1)))) in R. rewrite E in R.
    rewrite (cycle_row n adj _ k Hn Cy Hk), !column_is by lia.
    transitivity (RtoC (/ sqrt (INR n)) * (2 * phasors (paley_fourier.wave n (m - 1)) k - phasors (paley_fourier.wave n (m - 1)) ((k + 1) mod n)%nat
      - phasors (paley_fourier.wave n (m - 1)) ((k + (n - 1)) mod n)%nat))%C; [unfold phasors|rewrite <- R; unfold phasors; ring].
    set (c := / sqrt (INR n)). generalize (expi (paley_fourier.wave n (m - 1) k)) (expi (paley_fourier.wave n (m - 1) ((k + 1) mod n)))
      (expi (paley_fourier.wave n (m - 1) ((k + (n - 1)) mod n))). intros. apply injective_projections; cbn; ring.
Qed.
Lemma fig2_3_holds : fig2_3.
Proof.
  intros m th Hm H. exists (12 / Nat.gcd 12 (m - 1))%nat. split; [|apply column_pattern; lia || exact H].
  destruct (Nat.gcd_divide_l 12 (m - 1)) as [q Hq]. exists (Nat.gcd 12 (m - 1)). set (g := Nat.gcd 12 (m - 1)) in *.
  assert (g <> 0)%nat by (intros Z; rewrite Z in Hq; lia). replace (12 / g)%nat with q; [lia|]. rewrite Hq. now rewrite Nat.div_mul.
Qed.
Lemma eq12_pos_4_holds : eq12_pos_4.
Proof.
  intros n adj th SC N. rewrite WL_is. destruct n as [|n]; [exfalso; apply N; intros j k Hj; lia|].
  apply (W1_positive (S n) adj th ltac:(lia)). intros A. apply N. intros j k Hj Hk. apply A. apply clos_rt_clos_rst. now apply SC.
Qed.
Lemma zero_dir_2_holds : zero_dir_2.
Proof.
  intros n adj th N. rewrite WL_is. destruct n as [|n]; [exfalso; apply N; intros j k Hj; lia|].
  apply (W1_positive (S n) adj th ltac:(lia)). intros A. apply N. intros j k _ _. apply A.
Qed.
Lemma among_w n adj k f : among n adj k f = Csum n (fun j => RtoC (if adj k j then 1 else 0) * f j)%C.
Proof. apply Csum_ext. intros j _. destruct (adj k j); ring. Qed.
Lemma hat_is a b : hat (a - b)%C = paley_fish.unit_from a b.
Proof.
  unfold hat, paley_fish.unit_from. destruct (Ceq_dec (a - b)%C 0%C) as [->|N].
  - unfold Cdiv. ring.
  - rewrite RtoC_inv; [unfold Cdiv; ring|]. intros Z. now apply Cmod_eq_0 in Z.
Qed.
Lemma u27_behaviour n rep ori w0 Krep Kori Katt r th vatt k : u27 n rep ori w0 Krep Kori Katt r th vatt k =
  paley_behaviours.behaviour (w0 k) Krep Kori Katt (expi (th k)) (paley_fish.v_rep n (rep k) r k) (paley_behaviours.v_ori n (ori k) th k) vatt.
Proof.
  unfold u27, paley_behaviours.behaviour, paley_fish.v_rep, paley_behaviours.v_ori. rewrite !among_w.
  rewrite (Csum_ext n _ (fun j => RtoC (if rep k j then 1 else 0) * paley_fish.unit_from (r k) (r j))%C) by (intros; now rewrite hat_is). reflexivity.
Qed.
Lemma eq28_1_holds : eq28_1.
Proof.
  intros n rep ori att w0 Krep Kori Katt r th k Hk Hr. rewrite u27_behaviour, among_w.
  pose proof (paley_behaviours.eq28_corrected n (rep k) ori att r th (w0 k) Krep Kori Katt k Hk Hr) as E. unfold paley_behaviours.v_att_plain in E. rewrite E.
  unfold u28, ori_term, att_term, row, phasors. ring.
Qed.
Lemma eq28_2_holds : eq28_2.
Proof.
  intros n att Katt r th k Hk HK. destruct (paley_behaviours.eq28_steers n (fun _ _ => false) att r th Katt k Hk) as [E _].
  change (att_term n att Katt r th k) with (- Katt * inner (Ci * expi (th k))%C (row n (lap n att) k r)). rewrite E. unfold w. rewrite <- among_w. now apply steers.
Qed.
Lemma eq28_3_holds : eq28_3.
Proof.
  intros n ori Kori th k Hk HK. destruct (paley_behaviours.eq28_steers n ori (fun _ _ => false) (fun _ => RtoC 0) th Kori k Hk) as (_ & E & _).
  change (ori_term n ori Kori th k) with (- Kori * inner (Ci * expi (th k))%C (row n (lap n ori) k (phasors th))). rewrite E. unfold w. rewrite <- among_w. now apply steers.
Qed.
Lemma eq28_4_holds : eq28_4.
Proof.
  split.
  - intros n rep ori att w0 Krep Kori Katt r th k Hk Hr H1. rewrite <- (eq28_1_holds n rep ori att w0 Krep Kori Katt r th k Hk Hr), !u27_behaviour.
    pose proof (proj1 paley_behaviours.eq28_distances n (att k) r th (w0 k) Krep Kori Katt (paley_fish.v_rep n (rep k) r k) (paley_behaviours.v_ori n (ori k) th k) k H1) as E.
    unfold paley_behaviours.v_att_plain, paley_fish.v_att in E. rewrite !among_w. rewrite <- E. do 2 f_equal. apply Csum_ext. intros j _. now rewrite hat_is.
  - destruct paley_behaviours.eq28_distances as [_ (r & att & th & N & D)]. intros Krep Kori Katt HK.
    exists 2%nat, (fun _ _ => false), (fun _ _ => false), (fun _ j => (att j && negb (Nat.eqb j 0))%bool), (fun _ => 0), r, th, 0%nat.
    split; [lia|]. split; [reflexivity|]. split.
    + intros [|[|j]] Hj A; [rewrite Bool.andb_false_r in A; discriminate|exact N|lia].
    + rewrite <- (eq28_1_holds 2%nat (fun _ _ => false) (fun _ _ => false) (fun _ j => (att j && negb (Nat.eqb j 0))%bool) (fun _ => 0) Krep Kori Katt r th 0%nat)
        by (lia || reflexivity).
      rewrite !u27_behaviour. intros E. apply D.
      unfold paley_behaviours.behaviour in *. clear D. unfold paley_behaviours.v_att_plain, paley_fish.v_att. rewrite !among_w in E. unfold Csum in *. cbn [Sum] in *.
      rewrite !hat_is in E. cbn [Nat.eqb negb andb] in E. rewrite !Bool.andb_true_r, !Bool.andb_false_r in E.
      assert (Z0 : paley_fish.unit_from (r 0%nat) (r 0%nat) = RtoC 0) by (unfold paley_fish.unit_from; ring). rewrite !Z0.
      apply (Rmult_eq_reg_l Katt); [|exact HK]. rewrite !inner_C in *. cbn [fst snd Cmult Cplus Copp RtoC Ci Cminus] in *. 
      set (c := expi (th 0%nat)) in *. destruct (att 1%nat), (att 0%nat); lra.
Qed.
Lemma figS3_1_holds : figS3_1.
Proof.
  intros n r th one all Hn H1 HN.
  assert (M : forall adj, mean_over_arcs n adj (fun k j => 1 - cos (th k - th j)) = paley_fish.arcs_mean n adj th).
  { intros adj. unfold mean_over_arcs, paley_fish.arcs_mean. f_equal. apply Sum_ext. intros k _. apply Sum_ext. intros j _. unfold w.
    rewrite <- (cos_neg (th k - th j)). replace (- (th k - th j)) with (th j - th k) by ring. destruct (adj k j); ring. }
  pose proof (paley_fish.figS3_difference n one all 1 (n - 1) th ltac:(lia) ltac:(lia) ltac:(lia)
    (fun k Hk => proj1 (proj2 (H1 k Hk))) (fun k Hk => proj1 (proj2 (HN k Hk)))) as Q. rewrite !WL_is, !M. exact Q.
Qed.
Lemma sync_par_1_holds : sync_par_1.
Proof.
  intros n r th u t0 Hn H. destruct (sync_always n r th u t0 H) as [S _]. destruct H as (M & _ & _).
  destruct (paley_fish.sync_par n th u (fun k t Hk => proj2 (M t k Hk)) S) as (U & D & _).
  exists (fun t => expi (th 0%nat t)), (u 0%nat). intros t. split; [apply Cmod_expi|]. split; [|apply D; lia].
  intros k Hk. rewrite (S t 0%nat k) by lia. split; [now apply M|]. split; [reflexivity|]. now apply U.
Qed.
Lemma ori_sync n ori th : (exists K1, ori = ori9 n K1 \/ exists adj, ori = ori14 n adj K1) -> synchronized n th ->
  forall k, (k < n)%nat -> ori th k = 0.
Proof.
  intros (K1 & [->|[adj ->]]) S k Hk.
  - pose proof (proj1 (paley_fish.sync_rate n (fun _ _ => false) th 0 K1 k Hk S)) as E. rewrite Rplus_0_l in E. exact E.
  - pose proof (proj2 (paley_fish.sync_rate n adj th 0 K1 k Hk S)) as E. rewrite Rplus_0_l in E. exact E.
Qed.
Lemma sync_par_2_holds : sync_par_2.
Proof.
  intros n w0 ori Ho th t D S k Hk. eapply D_eq; [exact (D k Hk)|]. rewrite (ori_sync n ori _ Ho S k Hk). ring.
Qed.
Lemma sync_par_3_holds : sync_par_3.
Proof.
  assert (A : forall n r th u t0, (1 <= n)%nat -> sync_arrangement n r th u t0 -> (parallel n r <-> forall t k, (k < n)%nat -> u k t = 0)).
  { intros n r th u t0 Hn H. destruct (sync_always n r th u t0 H) as [S _]. destruct H as (M & _ & _).
    destruct (paley_fish.sync_par n th u (fun k t Hk => proj2 (M t k Hk)) S) as (_ & _ & Z). split.
    - intros [d0 P] t k Hk. apply (Z k t Hk). assert (E : forall s, d0 = expi (th k s)) by (intros s; exact (velocity_one _ _ _ _ (P s k Hk) (proj1 (M s k Hk)))).
      split; [apply (is_derive_ext (fun _ => fst d0))|apply (is_derive_ext (fun _ => snd d0))]; try (intros s; now rewrite <- (E s)); apply D_const.
    - intros U. exists (expi (th 0%nat 0)). intros t k Hk. replace (expi (th 0%nat 0)) with (expi (th k t)); [now apply (M t)|].
      rewrite (S t k 0%nat) by lia. assert (V0 : forall s, is_velocity (fun x => expi (th 0%nat x)) s (RtoC 0)) by (intros s; apply Z; [lia|apply U; lia]).
      apply injective_projections; [apply (constant (fun x => fst (expi (th 0%nat x))))|apply (constant (fun x => snd (expi (th 0%nat x))))]; intros s; apply (V0 s). }
  split; [exact A|]. intros n w0 ori r th t0 Hn Ho H. rewrite (A n r th _ t0 Hn H). destruct (sync_always _ _ _ _ _ H) as [S _]. split.
  - intros U. specialize (U 0 0%nat ltac:(lia)). cbv beta in U. rewrite (ori_sync n ori (fun j => th j 0) Ho (S 0)) in U by lia. lra.
  - intros -> t k Hk. cbv beta. rewrite (ori_sync n ori (fun j => th j t) Ho (S t) k Hk). ring.
Qed.
Lemma sines_equilibrium n th : (forall j k, (j < n)%nat -> (k < n)%nat -> sin (th k - th j) = 0) -> equilibrium9 n th.
Proof.
  intros Z w0 K1 t k Hk. split; [|exact (paley_fish.sines_rest n th w0 K1 k (fun j Hj => Z j k Hj Hk))].
  assert (E : w0 + ori9 n K1 (fun j => th j + w0 * t) k = w0).
  { apply (paley_fish.sines_rest n (fun j => th j + w0 * t) w0 K1 k). intros j Hj. replace (th k + w0 * t - (th j + w0 * t)) with (th k - th j) by ring. now apply Z. }
  rewrite E. eapply D_eq; [apply D_plus; [apply D_const|apply D_scal, D_id]|]. ring.
Qed.
Lemma ori_sines n ori : (exists K1, ori = ori9 n K1 \/ exists adj, ori = ori14 n adj K1) -> exists c (a : nat -> nat -> R), (forall i k, Rabs (a k i) <= 1) /\
  forall th k, (k < n)%nat -> ori th k = c * Sum n (fun i => a k i * sin (th i - th k)).
Proof.
  intros (K1 & [->|[adj ->]]).
  - exists (- K1 * / INR n), (fun _ _ => 1). split; [intros; rewrite Rabs_R1; lra|]. intros th k Hk. rewrite ori9_sines, Rmult_assoc. do 2 f_equal. apply Sum_ext. intros; ring.
  - exists (- K1 / INR n), (fun k i => if adj k i then 1 else 0). split; [intros i k; destruct (adj k i); rewrite ?Rabs_R1, ?Rabs_R0; lra|].
    intros th k Hk. unfold ori14. rewrite (row_among n adj (fun j => expi (th j)) k Hk), among_inner.
    replace (- K1 / INR n * _) with (K1 / INR n * - Sum n (fun i => (if adj k i then 1 else 0) * sin (th i - th k))) by (unfold Rdiv; ring).
    rewrite <- Sum_opp. f_equal. apply Sum_ext. intros j _. destruct (adj k j); [|ring].
    rewrite Rmult_1_l, <- inner_e, !inner_C. cbn. ring.
Qed.
Lemma sync_kept_holds : sync_kept.
Proof.
  intros n w0 ori Ho th D S0. destruct (ori_sines n ori Ho) as (c & a & A1 & Eo).
  set (e := fun t k j => 2 * (1 - cos (th k t - th j t))). set (E := fun t => Sum n (fun k => Sum n (fun j => e t k j))).
  set (g := fun t k => ori (fun j => th j t) k).
  set (E' := fun t => Sum n (fun k => Sum n (fun j => 2 * sin (th k t - th j t) * (g t k - g t j)))).
  assert (e0 : forall t k j, 0 <= e t k j) by (intros t k j; unfold e; pose proof (COS_bound (th k t - th j t)); lra).
  assert (eE : forall t k j, (k < n)%nat -> (j < n)%nat -> e t k j <= E t).
  { intros t k j Hk Hj. unfold E. eapply Rle_trans; [apply (Sum_term_le n (fun j => e t k j)); [intros; apply e0|exact Hj]|].
    apply (Sum_term_le n (fun k => Sum n (fun j => e t k j))); [intros; apply Sum_ge0; intros; apply e0|exact Hk]. }
  assert (s2 : forall t k j, sin (th k t - th j t) ^ 2 <= e t k j).
  { intros t k j. unfold e. pose proof (sin2_cos2 (th k t - th j t)) as T. unfold Rsqr in T. pose proof (COS_bound (th k t - th j t)). nra. }
  assert (DE : forall t, 0 <= t -> is_derive E t (E' t)).
  { intros t Ht. apply (D_Sum n (fun k t => Sum n (fun j => e t k j))). intros k Hk. apply (D_Sum n (fun j t => e t k j)). intros j Hj. unfold e.
    eapply D_eq; [apply D_scal, D_minus; [apply D_const|apply (D_cos (fun s => th k s - th j s)), D_minus; apply D; assumption]|]. unfold g. ring. }
  assert (tri : forall t k j i, (k < n)%nat -> (j < n)%nat -> (i < n)%nat -> forall l, (l < n)%nat ->
    2 * sin (th k t - th j t) * (c * (a l i * sin (th i t - th l t))) <= 2 * Rabs c * E t).
  { intros t k j i Hk Hj Hi l Hl. eapply Rle_trans; [apply Rle_abs|].
    replace (2 * sin (th k t - th j t) * (c * (a l i * sin (th i t - th l t)))) with (c * a l i * (2 * sin (th k t - th j t) * sin (th i t - th l t))) by ring.
    rewrite !(Rabs_mult (c * a l i)), (Rabs_mult c). pose proof (Rabs_pos c) as Pc. pose proof (A1 i l) as Pa. pose proof (Rabs_pos (a l i)) as Pa'.
    assert (X : Rabs (2 * sin (th k t - th j t) * sin (th i t - th l t)) <= 2 * E t).
    { pose proof (s2 t k j). pose proof (s2 t i l). pose proof (eE t k j Hk Hj). pose proof (eE t i l Hi Hl).
      set (x := sin (th k t - th j t)) in *. set (y := sin (th i t - th l t)) in *. pose proof (pow2_ge_0 (x - y)). pose proof (pow2_ge_0 (x + y)). apply Rabs_le. nra. }
    pose proof (Rabs_pos (2 * sin (th k t - th j t) * sin (th i t - th l t))) as PX.
    replace (2 * Rabs c * E t) with (Rabs c * 1 * (2 * E t)) by ring. apply Rmult_le_compat; [|exact PX| |exact X]; [|apply Rmult_le_compat_l; assumption].
    apply Rmult_le_pos; assumption. }
  set (C := 4 * INR n ^ 3 * Rabs c).
  assert (B : forall t, 0 <= t -> E' t <= C * E t).
  { intros t Ht. replace (C * E t) with (Sum n (fun k => Sum n (fun j => Sum n (fun i => 2 * (2 * Rabs c * E t))))) by (rewrite !Sum_const; unfold C; ring).
    apply Sum_le. intros k Hk. apply Sum_le. intros j Hj. unfold g. rewrite (Eo _ k Hk), (Eo _ j Hj), <- !Sum_scal, <- Sum_minus, <- Sum_scal. apply Sum_le. intros i Hi.
    pose proof (tri t k j i Hk Hj Hi k Hk) as Q1. pose proof (tri t j k i Hj Hk Hi j Hj) as Q2.
    replace (th j t - th k t) with (- (th k t - th j t)) in Q2 by ring. rewrite sin_neg in Q2. lra. }
  assert (Z : E 0 = 0).
  { unfold E. apply Sum_zero. intros k Hk. apply Sum_zero. intros j Hj. pose proof (S0 k j Hk Hj) as Q. unfold e. rewrite cos_minus.
    assert (Q1 := f_equal fst Q). assert (Q2 := f_equal snd Q). cbn in Q1, Q2. rewrite Q1, Q2. pose proof (sin2_cos2 (th j 0)) as T. unfold Rsqr in T. lra. }
  assert (S : forall t, 0 <= t -> synchronized n (fun k => th k t)).
  { intros t Ht j k Hj Hk. assert (G : E t <= E 0 * exp (- - C * t)) by (apply (gronwall E E' (- C) DE); [intros x Hx; rewrite Ropp_involutive; now apply B|exact Ht]).
    rewrite Z, Rmult_0_l in G. pose proof (eE t j k Hj Hk) as Q. unfold e in Q. pose proof (COS_bound (th j t - th k t)) as Cb.
    assert (C1 : cos (th j t - th k t) = 1) by lra. pose proof (sin2_cos2 (th j t - th k t)) as T. unfold Rsqr in T. rewrite C1 in T.
    assert (S1 : sin (th j t - th k t) = 0) by nra. replace (th j t) with (th j t - th k t + th k t) by ring. unfold expi. rewrite cos_plus, sin_plus, C1, S1. f_equal; ring. }
  intros t k Ht Hk. split; [now apply S|]. exact (sync_par_2_holds n w0 ori Ho th t (fun k Hk => D t k Ht Hk) (S t Ht) k Hk).
Qed.
Lemma saddle_3_holds : saddle_3.
Proof.
  intros n th S N B. apply sines_equilibrium. destruct n as [|n]; [intros j k Hj; lia|].
  exact (proj2 (P.saddle_12_proved (Datatypes.S n) th ltac:(lia) S N B)).
Qed.
Lemma unbal_1_holds : unbal_1.
Proof.
  intros n M th0 th first HM N2 E H.
  assert (Z : forall j k, (j < n)%nat -> (k < n)%nat -> sin (th k - th j) = 0).
  { intros j k Hj Hk. assert (G : forall i, (i < n)%nat -> exists s, expi (th i) = (s * cos th0, s * sin th0)).
    { intros i Hi. rewrite (H i Hi). destruct (first i); [exists 1|exists (-1)]; unfold expi; rewrite ?neg_cos, ?neg_sin; f_equal; ring. }
    destruct (G j Hj) as [a Ea], (G k Hk) as [b Eb]. rewrite sin_minus.
    replace (sin (th k)) with (snd (expi (th k))) by reflexivity. replace (cos (th k)) with (fst (expi (th k))) by reflexivity.
    replace (sin (th j)) with (snd (expi (th j))) by reflexivity. replace (cos (th j)) with (fst (expi (th j))) by reflexivity.
    rewrite Ea, Eb. cbn. ring. }
  split; [now apply sines_equilibrium|]. intros k Hk. destruct (P.eq8_124_proved n th ltac:(lia)) as (G & _).
  pose proof (G k Hk) as D. cbv beta in D. replace (inner (Ci * expi (th k))%C (order n th)) with 0 in D; [exact D|].
  pose proof (ori9_sines n 1 th k) as Q. rewrite Sum_zero in Q by (intros j Hj; now apply Z). unfold ori9 in Q. unfold order, phasors.
  change (fun j => expi (th j)) with (fun j => expi (th j)) in Q. lra.
Qed.
Lemma cyclic_same n adj : (3 <= n)%nat -> cyclic n adj -> forall x k, (k < n)%nat ->
  Csum n (fun j => RtoC (lap n adj k j) * x j)%C = row n (lap n (paley_fourier.ring_graph n)) k x.
Proof. intros Hn Cy x k Hk. rewrite (cycle_row n adj x k Hn Cy Hk). symmetry. exact (cycle_row n _ x k Hn (ring_cyclic n Hn) Hk). Qed.
Lemma cyclic_3_holds : cyclic_3.
Proof.
  intros q adj u v Hq Cy Hu Hv. split.
  - exists 0%nat. split; [lia|]. cbn. intros Z. rewrite Z, Cmod_0 in Hu. lra.
  - intros k Hk. rewrite (cyclic_same (4 * q) adj ltac:(lia) Cy _ k Hk). exact (paley_fourier.ring_antipodal q (uvuv u v) Hq (uvuv_next u v) k Hk).
Qed.
Lemma fig2_4_holds : fig2_4.
Proof. intros adj u v Cy Hu Hv. exact (cyclic_3_holds 3%nat adj u v ltac:(lia) Cy Hu Hv). Qed.
(* ---- Veerman: spectra ---- *)
Lemma specM_3_holds : specM_3.
Proof.
  intros N p Hp lam. rewrite (V.eig_is N p lam Hp). destruct (veerman_lemma1.spectrum_L_systems N lam) as [A B].
  assert (E : eig_L N p lam <-> veerman_stability.L_eigenvalue N p lam).
  { split; intros (x & NZ & Z & Q); exists x; (split; [exact NZ|split; [now symmetry|exact Q]]). }
  rewrite E. destruct Hp; subst p; [exact A|exact B].
Qed.
Lemma specM_2_holds : specM_2.
Proof.
  intros N p f g Hp Hf. assert (B : ~ V.eig_M N p f g 0%C).
  { rewrite (V.eig_M_is N p f g 0%C Hp). destruct (veerman_lemma1.spectrum_M_nonzero N f g Hf) as [A B]. destruct Hp; subst p; assumption. }
  split; [exact B|]. intros nu.
  assert (Q : V.eig_M N p f g nu <-> exists lam, (eig_L N p lam /\ lam <> 0%C) /\ eig_AK f g lam nu).
  { rewrite (proj1 (V.specM_proved N p f g Hp)). split; intros (lam & E1 & E2); exists lam; (split; [now apply (specM_3_holds N p Hp lam)|]); now apply (proj1 (V.eigAK_proved f g lam nu)). }
  rewrite <- Q. split; [now intros [H _]|]. intros H. split; [exact H|]. intros Z. subst nu. now apply B.
Qed.
(* ---- Tanner: the clauses' words in those of the theorems ---- *)
Lemma gradV_is n adj V' r i : gradV n adj V' r i = grad_i n adj V' r i.
Proof. apply Csum_ext. intros j _. unfold pair_grad, w, grad, norm. destruct (adj i j); apply injective_projections; cbn; ring. Qed.
Lemma pulls_is n adj r th i : pulls n adj r th i = tanner1_heading.align n adj r th i.
Proof. apply Sum_ext. intros j _. unfold w, norm. destruct (adj i j); ring. Qed.
Lemma Vt_is n adj V r v th : Vt n adj V r v th = tanner1_heading.Vt n adj V r v th.
Proof. unfold Vt. rewrite T1.energy_is. unfold tanner1_motion.mechanical, tanner1_heading.Vt. rewrite (Sum_plus n (fun i => V_i n adj V r i + inner (v i) (v i))). ring. Qed.
Lemma V_i_is n (adj : graph) (V : nat -> nat -> R -> R) (r : nat -> C) i : Sum n (fun j => if adj i j then V i j (Cmod (r i - r j)%C) else 0) = V_i n adj V r i.
Proof. apply Sum_ext. intros j _. unfold w, norm. destruct (adj i j); ring. Qed.
(* one slope for V_ij and V_ji *)
Lemma gradV_both n adj V V' (r : nat -> R -> C) t i : (i < n)%nat -> undirected adj -> T1.symmetric_V V ->
  (forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> is_derive (V i j) (Cmod (r i t - r j t)%C) (V' i j (Cmod (r i t - r j t)%C))) ->
  (forall j, (j < n)%nat -> adj i j = true -> is_derive (V i j) (Cmod (r i t - r j t)%C) (T1.both V' i j (Cmod (r i t - r j t)%C))) /\
  grad_i n adj (T1.both V') (fun j => r j t) i = gradV n adj V' (fun j => r j t) i.
Proof.
  intros Hi S VS D. assert (Q : forall j, (j < n)%nat -> adj i j = true -> is_derive (V i j) (Cmod (r i t - r j t)%C) (T1.both V' i j (Cmod (r i t - r j t)%C)) /\
    T1.both V' i j (Cmod (r i t - r j t)%C) = V' i j (Cmod (r i t - r j t)%C)).
  { intros j Hj A. apply T1.both_slope; [exact VS|now apply D|]. rewrite Cmod_swap. apply D; [assumption..|]. now rewrite S. }
  split; [intros; now apply Q|]. rewrite <- gradV_is. apply Csum_ext. intros j Hj. destruct (adj i j) eqn:A; [|reflexivity]. now rewrite (proj2 (Q j Hj A)).
Qed.
(* v_i = s_i e^{i theta_i} near t, with rates *)
Lemma polar (v : nat -> R -> C) th i t a : is_velocity (v i) t a -> heading v th i t ->
  0 < Cmod (v i t) /\ (exists ds, is_derive (fun s => Cmod (v i s)) t ds) /\ (RtoC (Cmod (v i t)) * expi (th i t))%C = v i t /\
  is_velocity (fun s => RtoC (Cmod (v i s)) * expi (th i s))%C t a.
Proof.
  intros D (N & _ & L). split; [now apply Cmod_gt_0|]. split; [|split].
  - eexists. apply (is_derive_ext (fun s => Cmod (v i s - RtoC 0)%C)); [intros s; f_equal; ring|].
    apply (dist_rate (v i) (fun _ => RtoC 0) t a (RtoC 0) D); [split; apply D_const|exact N].
  - symmetry. exact (locally_singleton _ _ L).
  - destruct D as [D1 D2]. split; (eapply is_derive_ext_loc; [|eassumption]); apply (filter_imp (fun s => v i s = (RtoC (Cmod (v i s)) * expi (th i s))%C)); try exact L;
      intros s E; now rewrite <- E.
Qed.
Lemma chain_1_holds : chain_1.
Proof.
  intros n adj V V' r v acc th t S VS L H. exists (fun i => cross (v i t) (acc i) / Cmod (v i t) ^ 2).
  assert (O : forall i, (i < n)%nat -> is_derive (th i) t (cross (v i t) (acc i) / Cmod (v i t) ^ 2)).
  { intros i Hi. apply heading_rate; [now apply L|now apply H]. }
  split; [exact O|].
  assert (G : forall i, (i < n)%nat -> (forall j, (j < n)%nat -> adj i j = true -> is_derive (V i j) (Cmod (r i t - r j t)%C) (T1.both V' i j (Cmod (r i t - r j t)%C))) /\
    grad_i n adj (T1.both V') (fun j => r j t) i = gradV n adj V' (fun j => r j t) i).
  { intros i Hi. apply (gradV_both n adj V V' r t i Hi S VS). intros a b Ha Hb A. now apply (L a Ha). }
  apply (is_derive_ext (fun s => tanner1_heading.Vt n adj V (fun i => r i s) (fun i => v i s) (fun i => th i s))); [intros s; symmetry; apply Vt_is|].
  rewrite (Sum_ext n (fun i => inner (gradV n adj V' (fun j => r j t) i) (v i t)) (fun i => inner (grad_i n adj (T1.both V') (fun j => r j t) i) (v i t)))
    by (intros i Hi; now rewrite (proj2 (G i Hi))).
  apply (tanner1_heading.Vt_rate n adj V (T1.both V') r v th _ t _ S (T1.both_sym V')); [intros; now apply L|intros i j Hi Hj A; now apply (L i Hi)| |intros; now apply L|exact O].
  intros i j Hi Hj A. now apply (proj1 (G i Hi)).
Qed.
Lemma pick (P : nat -> R -> Prop) n : (forall i, (i < n)%nat -> exists a, P i a) -> exists f, forall i, (i < n)%nat -> P i (f i).
Proof. exact (finite_choice R 0 P n). Qed.
(* the corrected laws of the headings, for the motion of the clauses *)
Lemma loop_polar n adj V V' r v th t : T1.loop n adj V V' r v (dth th) t -> (forall i, (i < n)%nat -> heading v th i t) ->
  forall i, (i < n)%nat -> is_velocity (fun s => RtoC (Cmod (v i s)) * expi (th i s))%C t
    (tanner1_heading.accel n adj V' (fun j => r j t) (fun j => RtoC (Cmod (v j t)) * expi (th j t))%C (fun j => th j t) i).
Proof.
  intros L H i Hi. destruct (L i Hi) as (_ & A & _). destruct (polar v th i t _ A (H i Hi)) as (_ & _ & E & D).
  unfold dth in D. rewrite (T1.law_is n adj V' (fun j => th j t)) in D. unfold tanner1_heading.accel, tanner1_heading.gyro in *. rewrite E. exact D.
Qed.
Lemma eq6b_holds : eq6b.
Proof.
  intros n adj V V' r v th t L H.
  assert (A : forall i, (i < n)%nat -> is_velocity (v i) t (T1.law n adj V' (fun i j => dth th i j t) (fun i => r i t) (fun i => v i t) i)) by (intros i Hi; now apply (L i Hi)).
  destruct (pick (fun i d => is_derive (fun s => Cmod (v i s)) t d) n) as [ds Ds]; [intros i Hi; exact (proj1 (proj2 (polar v th i t _ (A i Hi) (H i Hi))))|].
  assert (O : forall i, (i < n)%nat -> is_derive (th i) t (cross (v i t) (T1.law n adj V' (fun i j => dth th i j t) (fun i => r i t) (fun i => v i t) i) / Cmod (v i t) ^ 2))
    by (intros i Hi; apply heading_rate; [now apply A|now apply H]).
  eexists. split; [exact O|].
  pose proof (tanner_rates.eq6b_corrected n adj V' (fun i => r i t) (fun i s => Cmod (v i s)) th ds _ t
    (fun i Hi => proj1 (polar v th i t _ (A i Hi) (H i Hi))) Ds O (loop_polar n adj V V' r v th t L H)) as E.
  rewrite <- E at 1. apply Sum_ext. intros i Hi. rewrite pulls_is, gradV_is. unfold norm.
  pose proof (proj1 (proj2 (proj2 (polar v th i t _ (A i Hi) (H i Hi))))) as P. cbv beta. rewrite !P. reflexivity.
Qed.
Lemma eq9_1_holds : eq9_1.
Proof.
  intros n adj V V' r v th t S VS L H. pose proof (T1.loop_both n adj V V' r v (dth th) t S VS L) as LB.
  assert (G : forall i, (i < n)%nat -> (forall j, (j < n)%nat -> adj i j = true -> is_derive (V i j) (Cmod (r i t - r j t)%C) (T1.both V' i j (Cmod (r i t - r j t)%C))) /\
    grad_i n adj (T1.both V') (fun j => r j t) i = gradV n adj V' (fun j => r j t) i).
  { intros i Hi. apply (gradV_both n adj V V' r t i Hi S VS). intros a b Ha Hb A. now apply (L a Ha). }
  set (a := fun i => T1.law n adj (T1.both V') (fun i j => dth th i j t) (fun i => r i t) (fun i => v i t) i).
  assert (A : forall i, (i < n)%nat -> is_velocity (v i) t (a i)) by (intros i Hi; now apply (LB i Hi)).
  assert (P : forall i, (i < n)%nat -> (RtoC (Cmod (v i t)) * expi (th i t))%C = v i t) by (intros i Hi; exact (proj1 (proj2 (proj2 (polar v th i t _ (A i Hi) (H i Hi)))))).
  destruct (pick (fun i d => is_derive (fun s => Cmod (v i s)) t d) n) as [ds Ds]; [intros i Hi; exact (proj1 (proj2 (polar v th i t _ (A i Hi) (H i Hi))))|].
  assert (R1 : forall i, (i < n)%nat -> is_velocity (r i) t (RtoC (Cmod (v i t)) * expi (th i t))%C) by (intros i Hi; rewrite (P i Hi); now apply (L i Hi)).
  assert (R2 : forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> r i t <> r j t) by (intros i j Hi Hj Q; now apply (L i Hi)).
  assert (R3 : forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> is_derive (V i j) (norm (r i t - r j t)%C) (T1.both V' i j (norm (r i t - r j t)%C)))
    by (intros i j Hi Hj Q; now apply (proj1 (G i Hi))).
  assert (R4 : forall i, (i < n)%nat -> 0 < Cmod (v i t) /\ is_derive (fun s => Cmod (v i s)) t (ds i) /\ is_derive (th i) t (cross (v i t) (a i) / Cmod (v i t) ^ 2)).
  { intros i Hi. split; [now apply (polar v th i t _ (A i Hi) (H i Hi))|]. split; [now apply Ds|]. apply heading_rate; [now apply A|now apply H]. }
  pose proof (tanner_rates.eq9_corrected n adj V (T1.both V') r (fun i s => Cmod (v i s)) th ds _ t S (T1.both_sym V') R1 R2 R3 R4 (loop_polar n adj V (T1.both V') r v th t LB H)) as D.
  cbv zeta beta in D. eapply D_eq.
  - eapply is_derive_ext_loc; [|exact D].
    assert (Lo : locally t (fun s => forall i, (i < n)%nat -> v i s = (RtoC (Cmod (v i s)) * expi (th i s))%C)).
    { assert (K : forall m, (m <= n)%nat -> locally t (fun s => forall i, (i < m)%nat -> v i s = (RtoC (Cmod (v i s)) * expi (th i s))%C)).
      { induction m as [|m IH]; intros Hm; [exists (mkposreal 1 Rlt_0_1); intros; lia|].
        apply (filter_imp (fun s => (forall i, (i < m)%nat -> v i s = (RtoC (Cmod (v i s)) * expi (th i s))%C) /\ v m s = (RtoC (Cmod (v m s)) * expi (th m s))%C)).
        - intros s [B1 B2] i Hi. destruct (Nat.eq_dec i m) as [->|]; [exact B2|apply B1; lia].
        - apply filter_and; [apply IH; lia|]. now apply (H m). }
      now apply K. }
    apply (filter_imp (fun s => forall i, (i < n)%nat -> v i s = (RtoC (Cmod (v i s)) * expi (th i s))%C)); [|exact Lo]. intros s E. rewrite Vt_is.
    unfold tanner1_heading.Vt. f_equal. apply Sum_ext. intros i Hi. now rewrite <- (E i Hi).
  - f_equal.
    + f_equal. apply Sum_ext. intros i Hi. f_equal. rewrite lapw_pulls, pulls_is by exact Hi. rewrite (tanner_graph.lapw_mul n _ i (fun j => th j t) Hi).
      unfold tanner1_heading.align. apply Sum_ext. intros; unfold Rdiv; ring.
    + apply Sum_ext. intros i Hi. rewrite (proj2 (G i Hi)), (P i Hi). reflexivity.
Qed.
Lemma heading_of_one n v th thbar t : one_heading n v th thbar t -> forall i, (i < n)%nat -> heading v th i t /\ is_derive (th i) t 0 /\ th i t = thbar.
Proof.
  intros H i Hi. pose proof (locally_singleton _ _ H i Hi) as (N & E1 & E2).
  assert (D : is_derive (th i) t 0).
  { apply (is_derive_ext_loc (fun _ => thbar)); [|apply D_const]. apply (filter_imp (fun s => forall i, (i < n)%nat ->
      v i s <> 0%C /\ th i s = thbar /\ v i s = (RtoC (Cmod (v i s)) * expi thbar)%C)); [|exact H]. intros s Hs. symmetry. now apply (Hs i Hi). }
  split; [|now split]. split; [exact N|]. split; [apply (ex_derive_continuous (th i)); now exists 0|].
  apply (filter_imp (fun s => forall i, (i < n)%nat -> v i s <> 0%C /\ th i s = thbar /\ v i s = (RtoC (Cmod (v i s)) * expi thbar)%C)); [|exact H].
  intros s Hs. destruct (Hs i Hi) as (_ & -> & E). exact E.
Qed.
Lemma one_heading_facts n adj V V' r v th thbar t : T1.loop n adj V V' r v (dth th) t -> one_heading n v th thbar t -> forall i, (i < n)%nat ->
  (exists c, gradV n adj V' (fun j => r j t) i = (RtoC c * v i t)%C) /\
  let a := T1.law n adj V' (fun i j => dth th i j t) (fun i => r i t) (fun i => v i t) i in let g := gradV n adj V' (fun j => r j t) i in
  fst (v i t) <> 0 -> fst a <> 0 -> fst g <> 0 -> snd a / fst a = snd (v i t) / fst (v i t) /\ snd g / fst g = snd (v i t) / fst (v i t).
Proof.
  intros L O. pose proof (heading_of_one n v th thbar t O) as Q. assert (H : forall i, (i < n)%nat -> heading v th i t) by (intros; now apply Q).
  assert (A : forall i, (i < n)%nat -> is_velocity (v i) t (T1.law n adj V' (fun i j => dth th i j t) (fun i => r i t) (fun i => v i t) i)) by (intros i Hi; now apply (L i Hi)).
  assert (P : forall i, (i < n)%nat -> (RtoC (Cmod (v i t)) * expi (th i t))%C = v i t) by (intros i Hi; exact (proj1 (proj2 (proj2 (polar v th i t _ (A i Hi) (H i Hi)))))).
  destruct (pick (fun i d => is_derive (fun s => Cmod (v i s)) t d) n) as [ds Ds]; [intros i Hi; exact (proj1 (proj2 (polar v th i t _ (A i Hi) (H i Hi))))|].
  assert (M : forall i, (i < n)%nat -> 0 < Cmod (v i t)) by (intros i Hi; apply (polar v th i t _ (A i Hi) (H i Hi))).
  assert (E : forall i j, (i < n)%nat -> (j < n)%nat -> th i t = th j t) by (intros i j Hi Hj; now rewrite (proj2 (proj2 (Q i Hi))), (proj2 (proj2 (Q j Hj)))).
  intros i Hi. split.
  - destruct (tanner_rates.equal_headings_forces n adj V' (fun i => r i t) (fun i s => Cmod (v i s)) th ds (fun _ => 0) t M Ds (fun i Hi => proj1 (proj2 (Q i Hi)))
      (loop_polar n adj V V' r v th t L H) E (fun _ _ => eq_refl) i Hi) as [_ [c F]]. exists c. rewrite gradV_is, F. cbv beta. now rewrite (P i Hi).
  - pose proof (tanner_rates.equal_headings_ratios n adj V' (fun i => r i t) (fun i s => Cmod (v i s)) th ds (fun _ => 0) t M Ds (fun i Hi => proj1 (proj2 (Q i Hi)))
      (loop_polar n adj V V' r v th t L H) E (fun _ _ => eq_refl) i Hi) as F. cbv zeta beta in F |- *.
    unfold dth. rewrite (T1.law_is n adj V' (fun j => th j t)), gradV_is. unfold tanner1_heading.accel, tanner1_heading.gyro in *. rewrite (P i Hi) in F. exact F.
Qed.
Lemma proof_cases_1_holds : proof_cases_1.
Proof. intros n adj V V' r v th thbar t L O i Hi. now apply (one_heading_facts n adj V V' r v th thbar t L O i Hi). Qed.
Lemma eq8_1_holds : eq8_1.
Proof.
  intros n adj V V' r v t [S NL] VS DV A L. 
  assert (K : forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> r i t <> r j t /\ is_derive (V i j) (Cmod (r i t - r j t)%C) (V' i j (Cmod (r i t - r j t)%C))).
  { intros i j Hi Hj E. split; [now apply A|]. apply DV; try assumption.
    apply Cmod_gt_0. intros Z. apply (A i j Hi Hj E). replace (r i t) with ((r i t - r j t) + r j t)%C by ring. rewrite Z. ring. }
  eexists. split.
  - intros i Hi. apply (V_i_rate n adj V V' r v t i Hi); [intros j Hj; now apply L|]. intros j Hj E. now apply K.
  - match goal with |- context [/ 2 * Sum n ?d] => set (dV := d) end.
    assert (Q : is_derive (fun x => Wenergy n adj V (fun i => r i x) (fun i => v i x)) t (/ 2 * Sum n dV -
      Sum n (fun i => inner (v i t) (Csum n (fun j => RtoC (w adj i j) * (v i t - v j t)) + grad_i n adj V' (fun j => r j t) i)%C))).
    { apply (tanner_rates.eq8_product n adj V V' r v dV t).
      - intros i Hi. apply (is_derive_ext (fun s => Sum n (fun j => if adj i j then V i j (Cmod (r i s - r j s)%C) else 0))); [intros s; exact (V_i_is n adj V (fun j => r j s) i)|].
        apply (V_i_rate n adj V V' r v t i Hi); [intros j Hj; now apply L|]. intros j Hj E. now apply K.
      - intros i Hi. replace (control4 n adj V' (fun j => r j t) (fun j => v j t) i) with (T2.law4 n adj V' (fun j => r j t) (fun j => v j t) i); [now apply L|].
        unfold T2.law4, control4. rewrite <- gradV_is. unfold T2.gradV, T2.pull, gradV. f_equal. f_equal. apply Csum_ext. intros j _. unfold w. destruct (adj i j); ring. }
    eapply D_eq.
    + eapply is_derive_ext; [|exact Q]. intros s. symmetry. exact (T1.energy_is n adj V (fun i => r i s) (fun i => v i s)).
    + f_equal. apply Sum_ext. intros i _. f_equal. rewrite gradV_is. f_equal. apply Csum_ext. intros j _. unfold w. destruct (adj i j); ring.
Qed.
Lemma Omega_both n adj c : undirected adj -> no_loops adj -> strongly_connected n adj -> exists B, forall r v th,
  apart_now n adj r -> Vt n adj T1.fig2 r v th <= c -> (forall i j, (i < n)%nat -> (j < n)%nat -> Cmod (r i - r j)%C <= B) /\ forall i, (i < n)%nat -> Cmod (v i) <= sqrt (2 * c).
Proof.
  intros S NL SC. destruct n as [|n]; [exists 0; intros; split; intros; lia|].
  destruct (tanner_rates.Omega_bounded (Datatypes.S n) adj c ltac:(lia) S NL SC) as [B H]. exists B. intros r v th A Q. apply (H r v th A). rewrite <- Vt_is. exact Q.
Qed.
Lemma Omega_1_holds : Omega_1.
Proof. intros n adj c S NL SC. destruct (Omega_both n adj c S NL SC) as [B H]. exists B. intros r v th A Q. now apply (H r v th A Q). Qed.
Lemma proof_ratio_2_holds : proof_ratio_2.
Proof.
  intros n adj V V' r v th thbar t L O i ai Hi Da g k N. destruct (one_heading_facts n adj V V' r v th thbar t L O i Hi) as [_ F]. cbv zeta in F.
  assert (E : ai = T1.law n adj V' (fun i j => dth th i j t) (fun i => r i t) (fun i => v i t) i) by exact (velocity_one _ _ _ _ Da (proj1 (proj2 (L i Hi)))).
  pose proof (one_heading_law n adj V' r v th thbar t i O Hi) as G. fold g in G, F. rewrite <- E in F, G. unfold k.
  assert (Z : fst ai = - fst g) by (rewrite G; reflexivity). split; intros N'; destruct (F N ltac:(lra) ltac:(lra)) as [F1 F2]; now symmetry.
Qed.
