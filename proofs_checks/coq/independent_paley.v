(* Clauses of the claims about Paley's paper, formalised from their words before the theorems were looked at. *)
From Coq Require Import Reals Lia List Relations.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums paley_model paley_phase paley_laplacian paley_gradient paley_fourier paley_particles paley_patterns.
From Flockproof Require paley_fish paley_centre.
Open Scope R_scope.

(* particles (1), (2) with steering u at time t *)
Definition particles (n : nat) (r : nat -> R -> C) (th : nat -> R -> R) (u : nat -> R) (t : R) :=
  forall k, (k < n)%nat -> is_velocity (r k) t (expi (th k t)) /\ is_derive (th k) t (u k).
Notation at_time f t := (fun k => f k t) (only parsing).
(* circle centres c_k = r_k + i e^{i th_k}/w0, and <e^{i th_k}, L_k c> *)
Definition ck (w0 : R) (r : nat -> C) (th : nat -> R) (k : nat) : C := (r k + RtoC (/ w0) * (Ci * expi (th k)))%C.
Definition Lc (n : nat) (adj : graph) (w0 : R) (r : nat -> C) (th : nat -> R) (k : nat) : R :=
  inner (expi (th k)) (Csum n (fun j => RtoC (lap n adj k j) * ck w0 r th j))%C.
Definition Lth (n : nat) (adj : graph) (th : nat -> R) (k : nat) : R :=
  inner (Ci * expi (th k))%C (Csum n (fun j => RtoC (lap n adj k j) * expi (th j)))%C.
Definition S17 (n : nat) (adj : graph) (w0 : R) (r : nat -> C) (th : nat -> R) : R :=
  / (2 * INR n) * Sum n (fun k => inner (ck w0 r th k) (Csum n (fun j => RtoC (lap n adj k j) * ck w0 r th j))%C).
Definition u20 n adj w0 K0 r th k := w0 + w0 * (K0 / INR n) * Lc n adj w0 r th k.

(* paley.thm2.center clause 1: under (20) thdot tends to w0 and the centres to one point; undirected connected graph *)
Definition thm2_1 : Prop := forall n adj w0 K0 r th, (1 <= n)%nat -> undirected adj -> no_loops adj -> strongly_connected n adj ->
  w0 <> 0 -> 0 < K0 -> (forall t, 0 <= t -> particles n r th (u20 n adj w0 K0 (at_time r t) (at_time th t)) t) ->
  exists c0 : C, forall k, (k < n)%nat -> forall e, 0 < e -> exists T, forall t, T <= t ->
    Cmod (ck w0 (at_time r t) (at_time th t) k - c0)%C < e /\ Rabs (u20 n adj w0 K0 (at_time r t) (at_time th t) k - w0) < e.
(* clause 2: of two motions from one initial state the centres are the same *)
Definition ends_at n w0 (r : nat -> R -> C) (th : nat -> R -> R) (c0 : C) := forall k, (k < n)%nat -> forall e, 0 < e ->
  exists T, forall t, T <= t -> Cmod (ck w0 (at_time r t) (at_time th t) k - c0)%C < e.
Definition thm2_2 : Prop := forall n adj w0 K0 r th r' th' c0 c0', (1 <= n)%nat -> undirected adj -> no_loops adj ->
  strongly_connected n adj -> w0 <> 0 -> 0 < K0 ->
  (forall t, 0 <= t -> particles n r th (u20 n adj w0 K0 (at_time r t) (at_time th t)) t) ->
  (forall t, 0 <= t -> particles n r' th' (u20 n adj w0 K0 (at_time r' t) (at_time th' t)) t) ->
  (forall k, (k < n)%nat -> r k 0 = r' k 0 /\ expi (th k 0) = expi (th' k 0)) ->
  ends_at n w0 r th c0 -> ends_at n w0 r' th' c0' -> c0 = c0'.

(* paley.thm3.min *)
Definition UMN (n M : nat) (K : nat -> R) (th : nat -> R) : R :=
  Sum M (fun i => K (S i) * (INR n / 2 * Cmod (RtoC (/ (INR (S i) * INR n)) * Csum n (fun k => expi (INR (S i) * th k)))%C ^ 2)).
Definition thm3 : Prop := forall n M K th, (1 <= n)%nat -> (1 <= M)%nat -> (exists q, n = (M * q)%nat) ->
  (forall m, (1 <= m < M)%nat -> 0 < K m) -> K M < 0 ->
  (pattern M n th <-> forall th', UMN n M K th <= UMN n M K th').
(* paley.eq21 clause 2 *)
Definition u22 n adj w0 K0 K1 r th k :=
  w0 + (K1 - K0) / INR n * Lth n adj th k + w0 * (K0 / INR n) * inner (expi (th k)) (Csum n (fun j => RtoC (lap n adj k j) * r j))%C.
Definition eq21_2 : Prop := forall n adj w0 K0 K1 r th t, (1 <= n)%nat -> undirected adj -> w0 <> 0 ->
  particles n r th (u22 n adj w0 K0 K1 (at_time r t) (at_time th t)) t ->
  is_derive (fun s => K0 * S17 n adj w0 (at_time r s) (at_time th s) - K1 * / w0 ^ 2 * W1 n adj (at_time th s)) t
    (- / INR n ^ 2 * Sum n (fun k => (K0 * Lc n adj w0 (at_time r t) (at_time th t) k + K1 * / w0 * Lth n adj (at_time th t) k) ^ 2)).
(* paley.VMN clause 2; (25): the partial derivatives of U^{M,N} are g *)
Definition VMN_2 : Prop := forall n adj w0 K0 M K r th t (g : nat -> R), (1 <= n)%nat -> (1 <= M)%nat -> undirected adj -> w0 <> 0 ->
  (forall k, (k < n)%nat -> partial (UMN n M K) (at_time th t) k (g k)) ->
  let u k := w0 - g k + w0 * (K0 / INR n) * Lc n adj w0 (at_time r t) (at_time th t) k in
  particles n r th u t ->
  is_derive (fun s => K0 * S17 n adj w0 (at_time r s) (at_time th s) + / w0 ^ 2 * UMN n M K (at_time th s)) t
    (- / w0 ^ 2 * Sum n (fun k => (u k - w0) ^ 2)).
(* paley.eq19_20 clauses 1, 2, 3 *)
Definition eq19 : Prop := forall n adj w0 r th u t, (1 <= n)%nat -> undirected adj -> w0 <> 0 -> particles n r th u t ->
  is_derive (fun s => S17 n adj w0 (at_time r s) (at_time th s)) t
    (/ INR n * Sum n (fun k => Lc n adj w0 (at_time r t) (at_time th t) k * (1 - / w0 * u k))).
Definition eq20 : Prop := forall n adj w0 K0 r th t, (1 <= n)%nat -> undirected adj -> w0 <> 0 ->
  particles n r th (u20 n adj w0 K0 (at_time r t) (at_time th t)) t ->
  let rate := - (K0 / INR n ^ 2) * Sum n (fun k => Lc n adj w0 (at_time r t) (at_time th t) k ^ 2) in
  is_derive (fun s => S17 n adj w0 (at_time r s) (at_time th s)) t rate /\ (0 < K0 -> rate <= 0).
(* paley.eq14_15 *)
Definition eq14_1 : Prop := forall n adj w0 K1 th t, (1 <= n)%nat -> undirected adj ->
  (forall k, (k < n)%nat -> is_derive (th k) t (w0 + K1 / INR n * Lth n adj (at_time th t) k)) ->
  is_derive (fun s => W1 n adj (at_time th s)) t (K1 / INR n ^ 2 * Sum n (fun k => Lth n adj (at_time th t) k ^ 2)).
Definition eq14_2 : Prop := forall n adj w0 K1 th k, (1 <= n)%nat -> (k < n)%nat ->
  w0 + K1 / INR n * Lth n adj th k = w0 + K1 / INR n * Sum n (fun j => (if adj k j then 1 else 0) * sin (th k - th j)).
(* paley.eq12.pos *)
Definition eq12 : Prop := forall n adj th, (1 <= n)%nat ->
  W1 n adj th = / (2 * INR n) * Sum n (fun k => deg n adj k - Sum n (fun j => (if adj k j then 1 else 0) * inner (expi (th k)) (expi (th j)))) /\
  0 <= W1 n adj th /\
  (strongly_connected n adj -> (W1 n adj th = 0 <-> synchronized n th) /\ (~ synchronized n th -> 0 < W1 n adj th)).
(* paley.zero.dir clauses 3, 4: for every directed graph *)
Definition zero_dir : Prop := forall n adj th, (1 <= n)%nat ->
  let same := forall j k, clos_refl_sym_trans nat (arc n adj) j k -> expi (th j) = expi (th k) in
  (W1 n adj th = 0 <-> same) /\ (~ same -> 0 < W1 n adj th).
(* paley.graph clauses 1 to 5 *)
Definition eigenpair n adj (lam : C) (x : nat -> C) := (exists k, (k < n)%nat /\ x k <> 0%C) /\
  forall k, (k < n)%nat -> Csum n (fun j => RtoC (lap n adj k j) * x j)%C = (lam * x k)%C.
Definition graph_1 : Prop := forall n adj lam x, eigenpair n adj lam x -> 0 <= fst lam.
Definition graph_2 : Prop := forall n adj k, (k < n)%nat -> Sum n (fun j => lap n adj k j) = 0.
(* the kernel of no power of L is larger than the constant vectors, complex ones included *)
Definition apply_L n adj (x : nat -> C) (k : nat) : C := Csum n (fun j => RtoC (lap n adj k j) * x j)%C.
Definition graph_3 : Prop := forall n adj m (x : nat -> C), (1 <= n)%nat -> strongly_connected n adj ->
  (forall k, (k < n)%nat -> Nat.iter m (apply_L n adj) x k = 0%C) -> forall j k, (j < n)%nat -> (k < n)%nat -> x j = x k.
Definition graph_4 : Prop := forall n adj, undirected adj -> (forall j k, lap n adj j k = lap n adj k j) /\
  forall x : nat -> R, 0 <= Sum n (fun k => x k * Sum n (fun j => lap n adj k j * x j)).
(* F^* L F is diagonal and F is unitary: the columns of F are eigenvectors, orthonormal *)
Definition fourier (n m k : nat) : C := (RtoC (/ sqrt (INR n)) * expi (2 * PI / INR n * (INR m * INR k)))%C.
Definition graph_5 : Prop := forall n adj, (1 <= n)%nat ->
  (forall k j k' j', (k < n)%nat -> (j < n)%nat -> (k' < n)%nat -> (j' < n)%nat ->
     ((j + n - k) mod n = (j' + n - k') mod n)%nat -> adj k j = adj k' j') ->
  (forall m, (m < n)%nat -> exists lam, forall k, (k < n)%nat -> apply_L n adj (fourier n m) k = (lam * fourier n m k)%C) /\
  forall m m', (m < n)%nat -> (m' < n)%nat ->
    Csum n (fun k => Cconj (fourier n m k) * fourier n m' k)%C = if Nat.eqb m m' then 1%C else 0%C.
(* paley.thm1.saddle clauses 1, 2 *)
Definition saddle_12 : Prop := forall n th, (1 <= n)%nat -> stationary n (U1 n) th -> ~ synchronized n th -> ~ balanced n th ->
  (forall e, 0 < e -> (exists a, (forall k, (k < n)%nat -> Rabs (a k - th k) < e) /\ U1 n th < U1 n a) /\
                      exists b, (forall k, (k < n)%nat -> Rabs (b k - th k) < e) /\ U1 n b < U1 n th) /\
  forall j k, (j < n)%nat -> (k < n)%nat -> sin (th k - th j) = 0.
(* paley.thm1.sync clause 1: the set of synchronised arrangements is stable and attracts its neighbours *)
Definition apart n (th : nat -> R) (d : R) := forall j k, (j < n)%nat -> (k < n)%nat -> Cmod (expi (th j) - expi (th k))%C < d.
Definition sync_1 : Prop := forall n w0 K1, (1 <= n)%nat -> K1 < 0 ->
  let moves th := forall t, 0 <= t -> forall k, (k < n)%nat ->
    is_derive (th k) t (w0 - K1 * inner (Ci * expi (th k t))%C (RtoC (/ INR n) * Csum n (fun j => expi (th j t)))%C) in
  (forall e, 0 < e -> exists d, 0 < d /\ forall th, moves th -> apart n (at_time th 0) d -> forall t, 0 <= t -> apart n (at_time th t) e) /\
  exists d, 0 < d /\ forall th, moves th -> apart n (at_time th 0) d -> forall e, 0 < e -> exists T, forall t, T <= t -> apart n (at_time th t) e.
(* paley.eq17 clauses 1, 2, 3: proper: bounded S bounds the relative centres *)
Definition S_of n adj (c : nat -> C) := / (2 * INR n) * Sum n (fun k => inner (c k) (apply_L n adj c k)).
Definition eq17 : Prop := forall n adj, (1 <= n)%nat -> undirected adj -> strongly_connected n adj ->
  (forall c, (S_of n adj c = 0 <-> exists c0, forall k, (k < n)%nat -> c k = c0) /\ 0 <= S_of n adj c) /\
  forall b, exists B, forall c, S_of n adj c <= b -> forall j k, (j < n)%nat -> (k < n)%nat -> Cmod (c k - c j)%C <= B.
(* paley.eq16, paley.gradW, paley.eq8_10 clauses 1, 2, 4 *)
Definition eq16 : Prop := forall n adj th, (1 <= n)%nat -> undirected adj ->
  ((forall k, (k < n)%nat -> Lth n adj th k = 0) <-> stationary n (W1 n adj) th).
Definition gradW : Prop := forall n adj th k, (1 <= n)%nat -> undirected adj -> (k < n)%nat ->
  partial (W1 n adj) th k (/ (2 * INR n) * inner (Ci * expi (th k))%C (Csum n (fun j => RtoC (lap n adj k j + lap n adj j k) * expi (th j)))%C) /\
  partial (W1 n adj) th k (/ INR n * Lth n adj th k).
Definition eq8_124 : Prop := forall n th, (1 <= n)%nat ->
  let g th k := inner (Ci * expi (th k))%C (order n th) in
  (forall k, (k < n)%nat -> partial (U1 n) th k (g th k)) /\ Sum n (g th) = 0 /\
  forall w0 K1 (ph : nat -> R -> R) t, (forall k, (k < n)%nat -> is_derive (ph k) t (w0 - K1 * g (at_time ph t) k)) ->
    is_derive (fun s => U1 n (at_time ph s)) t (- K1 * Sum n (fun k => g (at_time ph t) k ^ 2)).
(* paley.eig.sym clause 2; columns counted from 1 *)
Definition eig_sym_2 : Prop := forall n m th, (1 <= n)%nat -> (2 <= m <= n)%nat ->
  (exists rot, forall k, (k < n)%nat -> expi (th k) = expi (rot + 2 * PI / INR n * (INR (m - 1) * INR k))) ->
  pattern (n / Nat.gcd n (m - 1)) n th.
(* paley.eq23 clauses 1, 2, 3 *)
Definition eq23 : Prop := forall M n th, (1 <= n)%nat -> pattern M n th ->
  (forall m, (1 <= m < M)%nat -> Csum n (fun k => expi (INR m * th k)) = 0%C) /\
  INR M * Cmod (RtoC (/ (INR M * INR n)) * Csum n (fun k => expi (INR M * th k)))%C = 1 /\
  (~ synchronized n th -> balanced n th).
