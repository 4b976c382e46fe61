(* Audit of tanner2: each theorem of theorems.tsv with its statement written out, and the axioms it rests on.
   The objects of the statements are restated first. *)
From Coq Require Import Reals Lra Lia ZArith Relations List.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums tanner_rates tanner_components tanner_saturated tanner_trees tanner2_switching tanner2_distance paley_model paley_phase paley_laplacian paley_gradient paley_particles paley_fourier paley_patterns paley_fish tanner_energy tanner_flock tanner_nonsmooth tanner1_heading tanner1_examples tanner2_examples tanner2_path tanner2_facts tanner2_motion tanner_paths tanner_graph paley_stability.
From Flockproof Require tanner2_filippov tanner2_connectivity.
Open Scope R_scope.

(* the objects: phasors, inner product, graph Laplacian, quadratic form, order parameter, potentials *)
Check (eq_refl : expi = fun t => (cos t, sin t)).
Check (eq_refl : inner = fun x y => Re (Cconj x * y)%C).
Check (inner_xy : forall x y, inner x y = fst x * fst y + snd x * snd y).
Check (eq_refl : w = fun adj k j => if adj k j then 1 else 0).
Check (eq_refl : lap = fun n adj k j => delta k j * Sum n (w adj k) - w adj k j).
Check (eq_refl : arc = fun n adj j k => (j < n)%nat /\ (k < n)%nat /\ adj k j = true).
Check (eq_refl : Q = fun n A x => / (2 * INR n) * Sum n (fun k => inner (x k) (Csum n (fun j => RtoC (A k j) * x j)%C))).
Check (eq_refl : order = fun n th => (RtoC (/ INR n) * Csum n (fun k => expi (th k)))%C).
Check (eq_refl : U1 = fun n th => INR n / 2 * Cmod (order n th) ^ 2).
Check (eq_refl : W1 = fun n adj th => Q n (lap n adj) (fun k => expi (th k))).
Check (eq_refl : partial = fun f th k d => is_derive (fun s : R => f (upd th k s)) (th k) d).
Check (eq_refl : is_velocity = fun r t v => is_derive (fun s => fst (r s)) t (fst v) /\ is_derive (fun s => snd (r s)) t (snd v)).
Check (eq_refl : gW = fun n adj th k => inner (Ci * expi (th k))%C (row n (lap n adj) k (phasors th))).
Check (eq_refl : circle_centre = fun w0 r th => (r + RtoC (/ w0) * (Ci * expi th))%C).
(* the pair force, the control (4), the energy (6), V_t *)
Check (eq_refl : grad = fun V' ri rj => (RtoC (V' (Cmod (ri - rj)%C) / Cmod (ri - rj)%C) * (ri - rj))%C).
Check (eq_refl : control4 = fun n adj V' r v i => (- Csum n (fun j => RtoC (w adj i j) * (v i - v j)) - grad_i n adj V' r i)%C).
Check (eq_refl : Wenergy = fun n adj V r v => / 2 * Sum n (fun i => Sum n (fun j => w adj i j * V i j (norm (r i - r j)%C)) + inner (v i) (v i))).
Check (eq_refl : accel = fun n adj V' r v th i => (- grad_i n adj V' r i + RtoC (- align n adj r th i) * (Ci * v i))%C).

(* tanner2.L *)
Check (paley_gradient.lap_psd :
  forall (n : nat) (adj : graph) (x : nat -> C),
       undirected adj ->
       (forall k j : nat, lap n adj k j = lap n adj j k) /\
       0 <= Sum n (fun k : nat => inner (x k) (row n (lap n adj) k x))).

(* tanner2.L *)
Check (tanner2_connectivity.null_vectors :
  forall (n : nat) (adj : graph) (x : nat -> R), (1 <= n)%nat -> strongly_connected n adj ->
       ((forall k, (k < n)%nat -> Sum n (fun j => lap n adj k j * x j) = 0) <-> exists c, forall k, (k < n)%nat -> x k = c)).

(* tanner2.L *)
Check (tanner2_facts.second_positive :
  forall (n : nat) (adj : graph),
       (1 <= n)%nat ->
       undirected adj -> strongly_connected n adj -> exists lam : R, 0 < lam /\ below_second n adj lam).

(* tanner2.L *)
Check (tanner_graph.L_incidence :
  forall (n : nat) (adj : graph) (O : list (nat * nat)) (k m : nat),
       undirected adj ->
       oriented n adj O ->
       (k < n)%nat -> (m < n)%nat -> lsum O (fun f : nat * nat => inc k f * inc m f) = lap n adj k m).

(* tanner2.L *)
Check (tanner_graph.L_orientation :
  forall (n : nat) (adj : graph) (O O' : list (nat * nat)) (k m : nat),
       undirected adj ->
       oriented n adj O ->
       oriented n adj O' ->
       (k < n)%nat ->
       (m < n)%nat ->
       lsum O (fun f : nat * nat => inc k f * inc m f) = lsum O' (fun f : nat * nat => inc k f * inc m f)).

(* tanner2.Q *)
Check (tanner2_facts.Q_two_forms :
  forall (n : nat) (V : nat -> nat -> R -> R) (R0 : R) (r v : nat -> C),
       (forall i j : nat, V i j = V j i) ->
       Wenergy n (near r R0) V r v + Sum n (fun i : nat => Sum i (fun j : nat => (1 - w (near r R0) i j) * V i j R0)) =
       Qsat n V R0 r v).

(* tanner2.Qdot *)
Check (tanner2_facts.Q_rate :
  forall (n : nat) (V V' : nat -> nat -> R -> R) (R0 : R) (r v : nat -> R -> C) (t : R),
       0 < R0 ->
       (forall i j : nat, V' i j = V' j i) ->
       (forall (i j : nat) (s : R), 0 < s -> is_derive (V i j) s (V' i j s)) ->
       (forall i j : nat, (i < n)%nat -> (j < n)%nat -> i <> j -> r i t <> r j t /\ norm (r i t - r j t)%C <> R0) ->
       (forall i : nat, (i < n)%nat -> is_velocity (r i) t (v i t)) ->
       (forall i : nat,
        (i < n)%nat ->
        is_velocity (v i) t
          (control4 n (near (fun i0 : nat => r i0 t) R0) V' (fun i0 : nat => r i0 t) (fun i0 : nat => v i0 t) i)) ->
       is_derive (fun s : R_AbsRing => Qsat n V R0 (fun i : nat => r i s) (fun i : nat => v i s)) t
         (- qform (2 * n) (kron2 (lap n (near (fun i : nat => r i t) R0))) (stack (fun i : nat => v i t)))).



(* tanner2.S_config *)
Check (tanner2_facts.S_config_fails :
  ~
       (forall (n : nat) (adj : graph) (r v : nat -> C),
        undirected adj ->
        strongly_connected n adj ->
        qform (2 * n) (kron2 (lap n adj)) (stack v) = 0 ->
        forall i j : nat, (i < n)%nat -> (j < n)%nat -> (r i - r j)%C = 0)).

(* tanner2.S_config: the rate of W is 0 *)
Check (tanner2_connectivity.rest_of_energy :
  forall (n : nat) (adj : graph) (V V' : nat -> nat -> R -> R) (r v : nat -> R -> C) (t : R),
       undirected adj -> (forall i j, V' i j = V' j i) ->
       (forall i, (i < n)%nat -> is_velocity (r i) t (v i t)) ->
       (forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> r i t <> r j t) ->
       (forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true ->
          is_derive (V i j) (norm (r i t - r j t)%C) (V' i j (norm (r i t - r j t)%C))) ->
       (forall i, (i < n)%nat -> is_velocity (v i) t (control4 n adj V' (fun i => r i t) (fun i => v i t) i)) ->
       strongly_connected n adj ->
       is_derive (fun s => Wenergy n adj V (fun i => r i s) (fun i => v i s)) t 0 ->
       forall i j, (i < n)%nat -> (j < n)%nat -> v i t = v j t /\ is_velocity (fun s => r i s - r j s)%C t (RtoC 0)).

(* tanner2.appA_uniq *)
Check (tanner_nonsmooth.two_solutions :
  (forall t : R_AbsRing, is_derive (fun _ : R => 0) t (2 * sqrt (Rabs 0))) /\
       (forall t : R_AbsRing, is_derive late t (2 * sqrt (Rabs (late t)))) /\ late 0 = 0 /\ late 1 = 1).

(* tanner2.bound_r *)
Check (tanner2_facts.bound_r_fails :
  ~
       (forall (n : nat) (adj : graph) (V V' : R -> R) (r v : nat -> C) (c : R),
        undirected adj ->
        no_loops adj ->
        strongly_connected n adj ->
        potential V V' ->
        (forall i j : nat, (i < n)%nat -> (j < n)%nat -> adj i j = true -> r i <> r j) ->
        Wenergy n adj (fun _ _ : nat => V) r v <= c ->
        forall (i j : nat) (b : R),
        (i < n)%nat ->
        (j < n)%nat -> (forall s : R, 0 < s -> V s <= c * (INR n - 1) -> s <= b) -> norm (r i - r j)%C <= b)).

(* tanner2.bound_r, tanner2.eq7 *)
Check (tanner_flock.all_distances :
  forall (n : nat) (adj : graph) (V V' : nat -> nat -> R -> R) (c : R),
       (1 <= n)%nat ->
       undirected adj ->
       no_loops adj ->
       strongly_connected n adj ->
       (forall i j : nat, V i j = V j i) ->
       (forall i j : nat, (i < n)%nat -> (j < n)%nat -> adj i j = true -> potential (V i j) (V' i j)) ->
       exists B : R,
         forall r v : nat -> C,
         (forall i j : nat, (i < n)%nat -> (j < n)%nat -> adj i j = true -> r i <> r j) ->
         Wenergy n adj V r v <= c -> forall i j : nat, (i < n)%nat -> (j < n)%nat -> norm (r i - r j)%C <= B).

(* tanner2.bound_v *)
Check (tanner2_facts.bound_v_fails :
  ~
       (forall (n : nat) (adj : graph) (V V' : nat -> nat -> R -> R) (r v : nat -> C) (c : R),
        undirected adj ->
        no_loops adj ->
        strongly_connected n adj ->
        (forall i j : nat, V i j = V j i) ->
        (forall i j : nat, (i < n)%nat -> (j < n)%nat -> adj i j = true -> potential (V i j) (V' i j)) ->
        (forall i j : nat, (i < n)%nat -> (j < n)%nat -> adj i j = true -> r i <> r j) ->
        Wenergy n adj V r v <= c -> forall i : nat, (i < n)%nat -> norm (v i) <= sqrt c)).

(* tanner2.bound_v *)
Check (tanner_flock.speed_bound_norm :
  forall (n : nat) (adj : graph) (V V' : nat -> nat -> R -> R),
       (forall i j : nat, (i < n)%nat -> (j < n)%nat -> adj i j = true -> potential (V i j) (V' i j)) ->
       forall r v : nat -> C,
       (forall i j : nat, (i < n)%nat -> (j < n)%nat -> adj i j = true -> r i <> r j) ->
       forall (i : nat) (c : R), (i < n)%nat -> Wenergy n adj V r v <= c -> norm (v i) <= sqrt (2 * c)).

Check (tanner_rates.speeds_bounded : forall n adj V (r v : nat -> C) c,
  (forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> 0 <= V i j (norm (r i - r j)%C)) ->
  Wenergy n adj V r v <= c -> forall i, (i < n)%nat -> inner (v i) (v i) <= 2 * c /\ norm (v i) <= sqrt (2 * c)).

(* tanner2.cor1 *)
Check (tanner2_examples.cor1_step_fails :
  ~
       (forall (V V' : R -> R) (rd : R),
        potential V V' -> (forall s : R, 0 < s -> s <> rd -> V rd < V s) -> forall s : R, 0 < s -> V' s = 0 -> s = rd)).

(* tanner2.cor1 *)
Check (tanner2_examples.cor1_stuck :
  solution 2 complete (fun _ _ : nat => VB) (fun _ _ : nat => VB') (fun (i : nat) (_ : R) => pair2 i)
         (fun (_ : nat) (_ : R) => 0) /\
       (forall s : R, 0 < s -> s <> 1 -> VB 1 < VB s) /\ norm (pair2 0 - pair2 1)%C = 2).

(* tanner2.cor2_decomp *)
Check (tanner2_facts.cor2_decomp :
  forall (n : nat) (adj : graph) (V V' : nat -> nat -> R -> R) (r v : nat -> R -> C) (t : R)
         (vxp vxn vyp vyn : nat -> R),
       undirected adj ->
       (forall i j : nat, V' i j = V' j i) ->
       (forall i : nat, (i < n)%nat -> is_velocity (r i) t (v i t)) ->
       (forall i j : nat, (i < n)%nat -> (j < n)%nat -> adj i j = true -> r i t <> r j t) ->
       (forall i j : nat, (i < n)%nat -> (j < n)%nat -> adj i j = true ->
          is_derive (V i j) (norm (r i t - r j t)%C) (V' i j (norm (r i t - r j t)%C))) ->
       (forall i : nat, (i < n)%nat ->
          is_velocity (v i) t (control4 n adj V' (fun k : nat => r k t) (fun k : nat => v k t) i)) ->
       (forall i : nat, (i < n)%nat -> fst (v i t) = vxp i + vxn i /\ snd (v i t) = vyp i + vyn i) ->
       (exists c : R, forall i : nat, (i < n)%nat -> vxp i = c) ->
       (exists c : R, forall i : nat, (i < n)%nat -> vyp i = c) ->
       Sum n vxn = 0 -> Sum n vyn = 0 ->
       is_derive (fun s : R => Wenergy n adj V (fun i : nat => r i s) (fun i : nat => v i s)) t
         (- qform n (lap n adj) vxn - qform n (lap n adj) vyn)).

(* tanner2.cor2_merris *)
Check (eq_refl : deviation = fun n v => sqrt (Sum n (fun i => norm (v i - centre n v)%C ^ 2))).
Check (tanner2_facts.alignment_rate :
  forall (n : nat) (adj : graph) (lam : R) (v : nat -> R -> C), (1 <= n)%nat -> undirected adj ->
       (forall t i, 0 <= t -> (i < n)%nat -> is_velocity (v i) t (- Csum n (fun j => RtoC (w adj i j) * (v i t - v j t)))%C) ->
       (below_second n adj lam -> forall t, 0 <= t -> deviation n (fun i => v i t) <= exp (- lam * t) * deviation n (fun i => v i 0)) /\
       ((forall i, (i < n)%nat -> Csum n (fun j => RtoC (lap n adj i j) * v j 0%R)%C = (RtoC lam * v i 0%R)%C) ->
        forall t, 0 <= t -> deviation n (fun i => v i t) = exp (- lam * t) * deviation n (fun i => v i 0))).
Check (tanner2_facts.more_edges :
  forall (n : nat) (adj adj' : graph),
       undirected adj ->
       undirected adj' ->
       (forall i j : nat, adj i j = true -> adj' i j = true) ->
       (forall x : nat -> R, qform n (lap n adj) x <= qform n (lap n adj') x) /\
       (forall lam : R, below_second n adj lam -> below_second n adj' lam)).

(* lambda_2: the second smallest eigenvalue counted with multiplicity, that is the least one with an eigenvector off span 1 *)
Check (eq_refl : tanner2_connectivity.eigen = fun n adj lam x =>
  forall i, (i < n)%nat -> Sum n (fun j => lap n adj i j * x j) = lam * x i).
Check (eq_refl : tanner2_connectivity.second_eigenvalue = fun n adj lam =>
  (exists x, tanner2_connectivity.eigen n adj lam x /\ exists i j, (i < n)%nat /\ (j < n)%nat /\ x i <> x j) /\
  forall mu x, tanner2_connectivity.eigen n adj mu x -> (exists i j, (i < n)%nat /\ (j < n)%nat /\ x i <> x j) -> lam <= mu).
Check (tanner2_connectivity.second_exists :
  forall (n : nat) (adj : graph), (2 <= n)%nat -> undirected adj -> exists lam, tanner2_connectivity.second_eigenvalue n adj lam).
(* tanner2.L *)
Check (tanner2_connectivity.others_positive :
  forall (n : nat) (adj : graph) (mu : R) (x : nat -> R), undirected adj -> strongly_connected n adj -> tanner2_connectivity.eigen n adj mu x ->
       (exists i j, (i < n)%nat /\ (j < n)%nat /\ x i <> x j) -> 0 < mu).
(* tanner2.cor2_rate *)
Check (tanner2_connectivity.second_rate :
  forall (n : nat) (adj : graph) (lam : R) (v : nat -> R -> C), (2 <= n)%nat -> undirected adj -> tanner2_connectivity.second_eigenvalue n adj lam ->
       (forall t i, 0 <= t -> (i < n)%nat -> is_velocity (v i) t (- Csum n (fun j => RtoC (w adj i j) * (v i t - v j t)))%C) ->
       forall t, 0 <= t -> deviation n (fun i => v i t) <= exp (- lam * t) * deviation n (fun i => v i 0) /\
         ((forall i, (i < n)%nat -> Csum n (fun j => RtoC (lap n adj i j) * (v j 0%R - centre n (fun k => v k 0%R)))%C =
             (RtoC lam * (v i 0%R - centre n (fun k => v k 0%R)))%C) ->
          deviation n (fun i => v i t) = exp (- lam * t) * deviation n (fun i => v i 0))).
Check (tanner2_connectivity.second_grows :
  forall (n : nat) (adj adj' : graph) (lam mu : R), (2 <= n)%nat -> undirected adj -> undirected adj' ->
       (forall i j, adj i j = true -> adj' i j = true) ->
       tanner2_connectivity.second_eigenvalue n adj lam -> tanner2_connectivity.second_eigenvalue n adj' mu -> lam <= mu).

(* tanner2.cor2_sub *)
Check (tanner2_facts.cor2_sub_fails :
  forall (n : nat) (adj : graph) (lam : R),
       (1 <= n)%nat ->
       undirected adj ->
       0 < lam ->
       ~
       (forall v : nat -> C,
        - qform (2 * n) (kron2 (lap n adj)) (stack v) <=
        - lam * (INR n * mean n (fun j : nat => fst (v j)) ^ 2 + INR n * mean n (fun j : nat => snd (v j)) ^ 2))).

(* tanner2.cor2_sub *)
Check (tanner2_connectivity.energy_below_second :
  forall (n : nat) (adj : graph) (V V' : nat -> nat -> R -> R) (r v : nat -> R -> C) (t : R),
       undirected adj -> (forall i j, V' i j = V' j i) ->
       (forall i, (i < n)%nat -> is_velocity (r i) t (v i t)) ->
       (forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> r i t <> r j t) ->
       (forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true ->
          is_derive (V i j) (norm (r i t - r j t)%C) (V' i j (norm (r i t - r j t)%C))) ->
       (forall i, (i < n)%nat -> is_velocity (v i) t (control4 n adj V' (fun i => r i t) (fun i => v i t) i)) ->
       forall (lam : R) (xp xn yp yn : nat -> R), (2 <= n)%nat -> tanner2_connectivity.second_eigenvalue n adj lam ->
       (forall i, (i < n)%nat -> fst (v i t) = xp i + xn i /\ snd (v i t) = yp i + yn i) ->
       (exists c, forall i, (i < n)%nat -> xp i = c) -> (exists c, forall i, (i < n)%nat -> yp i = c) ->
       Sum n xn = 0 -> Sum n yn = 0 ->
       exists d, is_derive (fun s => Wenergy n adj V (fun i => r i s) (fun i => v i s)) t d /\
         d <= - lam * (Sum n (fun i => xn i ^ 2) + Sum n (fun i => yn i ^ 2))).

(* tanner2.cor3, tanner2.thm1b: a motion of (1) with (4) from a start without coincident linked agents; (4) is demanded where it has a value *)
Check (eq_refl : distinct = fun n adj r => forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> r i <> r j).
Check (eq_refl : moves = fun n adj V' r v t =>
  (forall i, (i < n)%nat -> is_velocity (r i) t (v i t)) /\
  (distinct n adj (fun i => r i t) ->
   forall i, (i < n)%nat -> is_velocity (v i) t (control4 n adj V' (fun i => r i t) (fun i => v i t) i))).
Check (tanner2_motion.linked_apart :
  forall (n : nat) (adj : graph) (V V' : nat -> nat -> R -> R) (r v : nat -> R -> C),
       undirected adj -> no_loops adj ->
       (forall i j, V i j = V j i) -> (forall i j, V' i j = V' j i) ->
       (forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> potential (V i j) (V' i j)) ->
       distinct n adj (fun i => r i 0) ->
       exists d, 0 < d /\
         forall T, (forall t, 0 <= t < T -> moves n adj V' r v t) ->
         forall t i j, 0 <= t < T -> (i < n)%nat -> (j < n)%nat -> adj i j = true -> d <= norm (r i t - r j t)%C).

(* tanner2.eq13.interval *)
Check (tanner2_facts.eq13_interval_fails :
  ~
       (forall (n : nat) (r v : nat -> C) (R0 : R),
        exists e : R, e < 0 /\ (forall x : R, rhs13 n r v R0 x <-> e <= x <= 0))).

(* tanner2.eq14 *)
Check (tanner_graph.eq14_sum :
  forall (n : nat) (adj : graph) (V' : nat -> nat -> R -> R) (r v : nat -> R -> C) (t : R),
       undirected adj ->
       (forall i j : nat, V' i j = V' j i) ->
       (forall i : nat, (i < n)%nat -> is_velocity (v i) t (control4 n adj V' (fun k => r k t) (fun k => v k t) i)) ->
       Sum n (fun i => fst (control4 n adj V' (fun k => r k t) (fun k => v k t) i)) = 0 /\
       Sum n (fun i => snd (control4 n adj V' (fun k => r k t) (fun k => v k t) i)) = 0).

(* tanner2.eq14 *)
Check (tanner_graph.eq14_common :
  forall (n : nat) (v : nat -> R -> C) (a : nat -> C) (t : R),
       (forall i j (s : R), (i < n)%nat -> (j < n)%nat -> v i s = v j s) ->
       (forall i : nat, (i < n)%nat -> is_velocity (v i) t (a i)) -> exists c : C, forall i : nat, (i < n)%nat -> a i = c).

(* tanner2.eq14 *)
Check (tanner_graph.eq14 :
  forall (n : nat) (adj : graph) (V' : nat -> nat -> R -> R) (r v : nat -> R -> C) (t : R),
       (1 <= n)%nat ->
       undirected adj ->
       (forall i j : nat, V' i j = V' j i) ->
       (forall i : nat,
        (i < n)%nat -> is_velocity (v i) t (control4 n adj V' (fun i0 : nat => r i0 t) (fun i0 : nat => v i0 t) i)) ->
       (forall i j : nat,
        (i < n)%nat ->
        (j < n)%nat ->
        control4 n adj V' (fun i0 : nat => r i0 t) (fun i0 : nat => v i0 t) i =
        control4 n adj V' (fun i0 : nat => r i0 t) (fun i0 : nat => v i0 t) j) ->
       forall i : nat, (i < n)%nat -> control4 n adj V' (fun i0 : nat => r i0 t) (fun i0 : nat => v i0 t) i = 0).

(* tanner2.eq2 *)
Check (tanner2_facts.eq2_fails :
  ~ (forall v : C, fst v <> 0 -> v = (norm v * expi (atan (snd v / fst v)))%C)).

(* tanner2.eq6 *)
Check (tanner_flock.energy_ge0 :
  forall (n : nat) (adj : graph) (V V' : nat -> nat -> R -> R),
       (forall i j : nat, (i < n)%nat -> (j < n)%nat -> adj i j = true -> potential (V i j) (V' i j)) ->
       forall r v : nat -> C,
       (forall i j : nat, (i < n)%nat -> (j < n)%nat -> adj i j = true -> r i <> r j) -> 0 <= Wenergy n adj V r v).

(* tanner2.eq7 *)
Check (tanner_flock.linked_distances :
  forall (n : nat) (adj : graph) (V V' : nat -> nat -> R -> R) (c : R),
       undirected adj ->
       no_loops adj ->
       (forall i j : nat, V i j = V j i) ->
       (forall i j : nat, (i < n)%nat -> (j < n)%nat -> adj i j = true -> potential (V i j) (V' i j)) ->
       exists d D : R,
         0 < d /\
         (forall r v : nat -> C,
          (forall i j : nat, (i < n)%nat -> (j < n)%nat -> adj i j = true -> r i <> r j) ->
          Wenergy n adj V r v <= c ->
          forall i j : nat, (i < n)%nat -> (j < n)%nat -> adj i j = true -> d <= norm (r i - r j)%C <= D)).

(* tanner2.eq8 *)
Check (tanner_energy.eq8_potential :
  forall (n : nat) (adj : graph) (V V' : nat -> nat -> R -> R) (r v : nat -> R -> C) (t : R),
       undirected adj ->
       (forall i j : nat, V' i j = V' j i) ->
       (forall i : nat, (i < n)%nat -> is_velocity (r i) t (v i t)) ->
       (forall i j : nat, (i < n)%nat -> (j < n)%nat -> adj i j = true -> r i t <> r j t) ->
       (forall i j : nat,
        (i < n)%nat ->
        (j < n)%nat -> adj i j = true -> is_derive (V i j) (norm (r i t - r j t)%C) (V' i j (norm (r i t - r j t)%C))) ->
       is_derive (fun s : R_AbsRing => / 2 * Sum n (fun i : nat => V_i n adj V (fun i0 : nat => r i0 s) i)) t
         (Sum n (fun i : nat => inner (v i t) (grad_i n adj V' (fun i0 : nat => r i0 t) i)))).

(* tanner2.eq8 *)
Check (tanner_energy.eq8_edges :
  forall (n : nat) (adj : graph) (V' : nat -> nat -> R -> R) (r v : nat -> R -> C) (t : R),
       undirected adj ->
       (forall i j : nat, V' i j = V' j i) ->
       no_loops adj ->
       Sum n (fun i : nat => inner (v i t) (grad_i n adj V' (fun i0 : nat => r i0 t) i)) =
       Sum n
         (fun i : nat => Sum i (fun j : nat => w adj i j * inner (v i t - v j t)%C (grad (V' i j) (r i t) (r j t)))) /\
       Sum n (fun i : nat => inner (v i t) (grad_i n adj V' (fun i0 : nat => r i0 t) i)) =
       Sum n
         (fun i : nat =>
          Sum i
            (fun j : nat =>
             w adj i j *
             (inner (v i t) (grad (V' i j) (r i t) (r j t)) + inner (v j t) (grad (V' i j) (r j t) (r i t)))))).

(* tanner2.eq9 *)
Check (tanner_energy.eq9 :
  forall (n : nat) (adj : graph) (V V' : nat -> nat -> R -> R) (r v : nat -> R -> C) (t : R),
       undirected adj ->
       (forall i j : nat, V' i j = V' j i) ->
       (forall i : nat, (i < n)%nat -> is_velocity (r i) t (v i t)) ->
       (forall i j : nat, (i < n)%nat -> (j < n)%nat -> adj i j = true -> r i t <> r j t) ->
       (forall i j : nat,
        (i < n)%nat ->
        (j < n)%nat -> adj i j = true -> is_derive (V i j) (norm (r i t - r j t)%C) (V' i j (norm (r i t - r j t)%C))) ->
       (forall i : nat,
        (i < n)%nat -> is_velocity (v i) t (control4 n adj V' (fun i0 : nat => r i0 t) (fun i0 : nat => v i0 t) i)) ->
       is_derive (fun s : R_AbsRing => Wenergy n adj V (fun i : nat => r i s) (fun i : nat => v i s)) t
         (- qform (2 * n) (kron2 (lap n adj)) (stack (fun i : nat => v i t))) /\
       qform (2 * n) (kron2 (lap n adj)) (stack (fun i : nat => v i t)) =
       qform n (lap n adj) (fun i : nat => fst (v i t)) + qform n (lap n adj) (fun i : nat => snd (v i t)) /\
       0 <= qform (2 * n) (kron2 (lap n adj)) (stack (fun i : nat => v i t))).

(* tanner2.lem1 *)
Check (tanner_nonsmooth.lemma1_fails :
  forall (V V' : R -> R) (R0 c : R),
       0 < R0 ->
       (forall s : R, 0 < s -> is_derive V s (V' s)) ->
       continuity_pt V' R0 -> V' R0 = c -> 0 < c -> ~ regular (saturated V R0) R0).

(* tanner2.lem2 *)
Check (tanner_nonsmooth.lemma2_fails :
  forall (V V' : R -> R) (R0 c : R),
       0 < R0 ->
       (forall s : R, 0 < s -> is_derive V s (V' s)) ->
       continuity_pt V' R0 -> V' R0 = c -> 0 < c -> forall z : R, gen_gradient (saturated V R0) R0 z <-> 0 <= z <= c).

Check (eq_refl : tanner_saturated.clarke2 = fun f x w l =>
  (forall e, 0 < e -> exists d, 0 < d /\ forall y h, Cmod (y - x)%C < d -> 0 < h < d -> (f (y + RtoC h * w)%C - f y) / h < l + e) /\
  (forall e d, 0 < e -> 0 < d -> exists y h, Cmod (y - x)%C < d /\ 0 < h < d /\ l - e < (f (y + RtoC h * w)%C - f y) / h)).
Check (eq_refl : tanner_saturated.gen_gradient2 = fun f x z => forall w l, tanner_saturated.clarke2 f x w l -> inner z w <= l).
Check (tanner_saturated.plane_gradient :
  forall (V V' : R -> R) (R0 c : R) (ri rj : C), 0 < R0 ->
       (forall s, 0 < s -> is_derive V s (V' s)) -> continuity_pt V' R0 -> V' R0 = c -> 0 < c -> Cmod (ri - rj)%C = R0 ->
       forall z : C, tanner_saturated.gen_gradient2 (fun y => saturated V R0 (Cmod (y - rj)%C)) ri z <->
         exists s, 0 <= s <= 1 /\ z = (RtoC s * (RtoC (c / R0) * (ri - rj)))%C).

(* tanner2.rangeB *)
Check (tanner_graph.range_B :
  forall (n : nat) (adj : graph) (O0 : list (nat * nat)) (x : nat -> R),
       (1 <= n)%nat ->
       undirected adj ->
       no_loops adj ->
       oriented n adj O0 ->
       strongly_connected n adj ->
       (exists y : nat * nat -> R, forall k : nat, (k < n)%nat -> applyB O0 y k = x k) <-> Sum n x = 0).


(* tanner2.thm1a *)
Check (tanner2_motion.motions_to_mean :
  forall (n : nat) (adj : graph) (V V' : nat -> nat -> R -> R) (r v : nat -> R -> C),
       undirected adj -> no_loops adj ->
       (forall i j, V i j = V j i) -> (forall i j, V' i j = V' j i) ->
       (forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> potential (V i j) (V' i j)) ->
       distinct n adj (fun i => r i 0) ->
       (1 <= n)%nat -> strongly_connected n adj ->
       (forall i j s, (i < n)%nat -> (j < n)%nat -> adj i j = true -> 0 < s -> continuity_pt (V' i j) s) ->
       (forall t, 0 <= t -> moves n adj V' r v t) ->
       forall i, (i < n)%nat ->
       forall e, 0 < e -> exists T, 0 <= T /\ forall t, T <= t -> norm (v i t - centre n (fun j => v j 0))%C < e).

(* tanner2.thm1c *)
Check (tanner2_examples.thm1c_fails :
  ~
       (forall (n : nat) (adj : graph) (V V' : nat -> nat -> R -> R) (r v : nat -> R -> C),
        solution n adj V V' r v ->
        forall i : nat,
        (i < n)%nat ->
        forall e : R,
        0 < e ->
        exists T : R,
          forall t : R,
          T <= t ->
          forall q : nat -> C,
          (forall a b : nat, (a < n)%nat -> (b < n)%nat -> adj a b = true -> q a <> q b) ->
          V_i n adj V (fun j : nat => r j t) i <= V_i n adj V q i + e)).

(* tanner2.thm1c *)
Check (tanner2_examples.thm1c_not_local :
  forall e : R,
       0 < e ->
       exists q : nat -> C,
         (forall j : nat, j <> 0%nat -> q j = line3 j) /\
         norm (q 0%nat - line3 0)%C < e /\
         V_i 3 complete (fun _ _ : nat => VA) q 0 < V_i 3 complete (fun _ _ : nat => VA) line3 0).

(* tanner2.vdotB: g is the gradient of V_ij in r_ij *)
Check (tanner2_connectivity.vdot_incidence :
  forall (n : nat) (adj : graph) (V V' : nat -> nat -> R -> R) (r v : nat -> R -> C) (t : R),
       undirected adj -> (forall i j, V' i j = V' j i) ->
       (forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> r i t <> r j t) ->
       (forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true ->
          is_derive (V i j) (norm (r i t - r j t)%C) (V' i j (norm (r i t - r j t)%C))) ->
       (forall i, (i < n)%nat -> is_velocity (v i) t (control4 n adj V' (fun i => r i t) (fun i => v i t) i)) ->
       forall O : list (nat * nat), oriented n adj O -> (forall i j, (i < n)%nat -> (j < n)%nat -> v i t = v j t) ->
       exists g : nat * nat -> C,
         (forall i j, In (i, j) O -> forall (z : R -> C) s u, is_velocity z s u -> z s = (r i t - r j t)%C ->
            is_derive (fun x => V i j (norm (z x))) s (inner (g (i, j)) u)) /\
         forall k, (k < n)%nat -> is_velocity (v k) t (applyB O (fun f => fst (g f)) k, applyB O (fun f => snd (g f)) k)).

(* tanner2.bound_r, corrected: D is at least V_e^{-1}(c) for every edge e *)
Check (tanner_paths.bound_r_corrected :
  forall (n : nat) (adj : graph) (V V' : nat -> nat -> R -> R) (r v : nat -> C) (c D : R),
       (1 <= n)%nat -> undirected adj -> no_loops adj -> strongly_connected n adj ->
       (forall i j, V i j = V j i) ->
       (forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> potential (V i j) (V' i j)) ->
       (forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> r i <> r j) ->
       Wenergy n adj V r v <= c -> 0 <= D ->
       (forall i j s, (i < n)%nat -> (j < n)%nat -> adj i j = true -> 0 < s -> V i j s <= c -> s <= D) ->
       forall i j, (i < n)%nat -> (j < n)%nat -> norm (r i - r j)%C <= (INR n - 1) * D).

(* the links 1-2-3-4 and 2-4-1-3 in turn, agents counted from 0; V = s + 1/s - 2 with s = d^2, as a function of the distance d *)
Check (eq_refl : tanner2_switching.spring = fun d => d ^ 2 + / d ^ 2 - 2).
Check (eq_refl : tanner2_switching.spring' = fun d => 2 * d - 2 / d ^ 3).
Check (tanner2_switching.spring_potential : potential tanner2_switching.spring tanner2_switching.spring').
Definition of_path (a b c d i j : nat) : bool :=
  existsb (fun e => (Nat.eqb i (fst e) && Nat.eqb j (snd e) || Nat.eqb j (fst e) && Nat.eqb i (snd e))%bool) ((a, b) :: (b, c) :: (c, d) :: nil).
Check (eq_refl : tanner2_switching.turn = fun k => if Nat.even k then of_path 0 1 2 3 else of_path 1 3 0 2).

(* beyond.tanner2.alternating_trees; tanner2.arbswitch, corrected, clause 2. For every start and every length P of the periods: positions
   have the velocities as derivatives and these are continuous; inside period k linked agents are apart and the control is (4). *)
Check (tanner2_switching.paths_never_agree :
  forall (P : R) (r v : nat -> R -> C), 0 < P ->
       (forall t i, 0 < t -> (i < 4)%nat -> is_velocity (r i) t (v i t) /\
          continuity_pt (fun s => fst (v i s)) t /\ continuity_pt (fun s => snd (v i s)) t) ->
       (forall k t, INR k * P < t < (INR k + 1) * P ->
          (forall i j, (i < 4)%nat -> (j < 4)%nat -> tanner2_switching.turn k i j = true -> r i t <> r j t) /\
          (forall i, (i < 4)%nat -> is_velocity (v i) t
             (control4 4 (tanner2_switching.turn k) (fun _ _ => tanner2_switching.spring') (fun i => r i t) (fun i => v i t) i))) ->
       ~ (forall i j, (i < 4)%nat -> (j < 4)%nat -> forall e, 0 < e -> exists T, 0 <= T /\ forall t, T <= t -> norm (v i t - v j t)%C < e)).

(* tanner2.thm2_vel; tanner2.arbswitch, corrected, clause 1: links by distance. At every time t >= 0 agents are apart; positions have the
   velocities as derivatives; velocities are continuous and have derivatives to the right, which are (4) with one weight m in [0, 1] for each
   pair: 1 nearer than R0, 0 farther, at R0 that of the side to which the pair goes, any if its distance has rate 0; the graph of the pairs
   nearer than R0 is connected. *)
Check (eq_refl : near = fun r R0 i j => if Nat.eqb i j then false else if Rlt_dec (norm (r i - r j)%C) R0 then true else false).
Definition to_the_right (f : R -> R) (t l : R) : Prop :=
  forall e, 0 < e -> exists d, 0 < d /\ forall h, 0 < h < d -> Rabs ((f (t + h) - f t) / h - l) < e.
Check (tanner2_distance.distance_velocities_agree :
  forall (n : nat) (V V' : nat -> nat -> R -> R) (R0 : R) (r v : nat -> R -> C) (m : R -> nat -> nat -> R),
       (1 <= n)%nat -> 0 < R0 ->
       (forall i j, V' i j = V' j i) ->
       (forall i j, (i < n)%nat -> (j < n)%nat -> i <> j -> potential (V i j) (V' i j)) ->
       (forall i j s, (i < n)%nat -> (j < n)%nat -> i <> j -> 0 < s -> continuity_pt (V' i j) s) ->
       (forall t i j, 0 <= t -> (i < n)%nat -> (j < n)%nat -> i <> j -> r i t <> r j t) ->
       (forall t i, 0 <= t -> (i < n)%nat -> is_velocity (r i) t (v i t) /\
          continuity_pt (fun s => fst (v i s)) t /\ continuity_pt (fun s => snd (v i s)) t) ->
       (forall t i j, 0 <= t -> (i < n)%nat -> (j < n)%nat -> m t i j = m t j i /\ (i <> j ->
          0 <= m t i j <= 1 /\
          (norm (r i t - r j t)%C < R0 -> m t i j = 1) /\
          (R0 < norm (r i t - r j t)%C -> m t i j = 0) /\
          (norm (r i t - r j t)%C = R0 ->
             (0 < inner (r i t - r j t)%C (v i t - v j t)%C -> m t i j = 0) /\
             (inner (r i t - r j t)%C (v i t - v j t)%C < 0 -> m t i j = 1)))) ->
       (forall t i, 0 <= t -> (i < n)%nat ->
          let u := (- Csum n (fun j => RtoC (m t i j) * (v i t - v j t)) -
                    Csum n (fun j => RtoC (m t i j) * grad (V' i j) (r i t) (r j t)))%C in
          to_the_right (fun s => fst (v i s)) t (fst u) /\ to_the_right (fun s => snd (v i s)) t (snd u)) ->
       (forall t, 0 <= t -> strongly_connected n (near (fun i => r i t) R0)) ->
       forall i j, (i < n)%nat -> (j < n)%nat ->
       forall e, 0 < e -> exists T, 0 <= T /\ forall t, T <= t -> norm (v i t - v j t)%C < e).

(* tanner2.thm2_vel; tanner2.arbswitch, corrected, clause 1; tanner2.thm2_coll: solutions of (10) after Definition 4. Links join agents nearer
   than R0. K at a state is the convex hull of the limits of the whole law from states without a pair at the distance R0. Velocities are
   absolutely continuous, with derivatives in K but on a set of measure zero; positions have the velocities as derivatives. *)
Check (eq_refl : complete = fun k j => negb (Nat.eqb k j)).
Check (eq_refl : tanner2_filippov.pull = fun adj V' r i j =>
  (if adj i j then RtoC (V' i j (Cmod (r i - r j)) / Cmod (r i - r j)) * (r i - r j) else 0)%C).
Check (eq_refl : tanner2_filippov.law4 = fun n adj V' r v i =>
  (- Csum n (fun j => if adj i j then v i - v j else 0) - Csum n (tanner2_filippov.pull adj V' r i))%C).
Check (eq_refl : tanner2_filippov.by_distance = fun r R0 i j =>
  (negb (Nat.eqb i j) && if Rlt_dec (Cmod (r i - r j)%C) R0 then true else false)%bool).
Check (eq_refl : tanner2_filippov.apart_at = fun n adj r => forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> r i <> r j).
Check (eq_refl : tanner2_filippov.potentials = fun n adj V V' => (forall i j s, V i j s = V j i s) /\
  forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true ->
    (forall s, 0 < s -> is_derive (V i j) s (V' i j s) /\ continuity_pt (V' i j) s /\ 0 <= V i j s) /\
    (forall c, exists d, 0 < d /\ forall s, 0 < s < d -> c < V i j s) /\ (forall c, exists D, forall s, D < s -> c < V i j s)).
Check (eq_refl : tanner2_filippov.limit_of_law = fun n V' R0 r v y => forall e, 0 < e -> exists q u : nat -> C,
  (forall i, (i < n)%nat -> Cmod (q i - r i)%C < e /\ Cmod (u i - v i)%C < e) /\
  (forall i j, (i < n)%nat -> (j < n)%nat -> i <> j -> Cmod (q i - q j)%C <> R0) /\
  forall i, (i < n)%nat -> Cmod (tanner2_filippov.law4 n (tanner2_filippov.by_distance q R0) V' q u i - y i)%C < e).
Check (eq_refl : tanner2_filippov.K10 = fun n V' R0 r v z => exists m (c : nat -> R) (y : nat -> nat -> C),
  (forall k, (k < m)%nat -> 0 <= c k /\ tanner2_filippov.limit_of_law n V' R0 r v (y k)) /\ Sum m c = 1 /\
  forall i, (i < n)%nat -> z i = Csum m (fun k => RtoC (c k) * y k i)%C).
Check (eq_refl : tanner2_filippov.absolutely_continuous = fun z => forall T e, 0 < T -> 0 < e -> exists d, 0 < d /\ forall m (a b : nat -> R),
  (forall k, (k < m)%nat -> 0 <= a k <= b k /\ b k <= T) -> (forall k, (S k < m)%nat -> b k <= a (S k)) ->
  Sum m (fun k => b k - a k) < d -> Sum m (fun k => Cmod (z (b k) - z (a k))%C) < e).
Check (eq_refl : tanner2_filippov.negligible = fun N => forall e, 0 < e -> exists a b : nat -> R, (forall k, a k <= b k) /\
  (forall t, N t -> exists k, a k < t < b k) /\ forall m, Sum m (fun k => b k - a k) <= e).
Check (eq_refl : tanner2_filippov.motion10 = fun n V' R0 r v => tanner2_filippov.apart_at n complete (fun i => r i 0) /\
  (forall t i, 0 <= t -> (i < n)%nat -> is_velocity (r i) t (v i t)) /\
  (forall i, (i < n)%nat -> tanner2_filippov.absolutely_continuous (v i)) /\
  exists N, tanner2_filippov.negligible N /\ forall t, 0 <= t -> ~ N t -> tanner2_filippov.apart_at n complete (fun i => r i t) ->
    exists z, tanner2_filippov.K10 n V' R0 (fun i => r i t) (fun i => v i t) z /\ forall i, (i < n)%nat -> is_velocity (v i) t (z i)).
Check (tanner2_filippov.velocities_agree :
  forall (n : nat) (V V' : nat -> nat -> R -> R) (R0 : R) (r v : nat -> R -> C),
       0 < R0 -> tanner2_filippov.potentials n complete V V' -> tanner2_filippov.motion10 n V' R0 r v ->
       (forall t, 0 <= t -> strongly_connected n (tanner2_filippov.by_distance (fun i => r i t) R0)) ->
       forall i j, (i < n)%nat -> (j < n)%nat ->
       forall e, 0 < e -> exists T, forall t, T <= t -> Cmod (v i t - v j t)%C < e).

(* tanner2.thm2_coll: the same until a time T *)
Check (eq_refl : tanner2_filippov.motion10_until = fun T n V' R0 r v => tanner2_filippov.apart_at n complete (fun i => r i 0) /\
  (forall t i, 0 <= t < T -> (i < n)%nat -> is_velocity (r i) t (v i t)) /\
  (forall i, (i < n)%nat -> forall T' e, 0 < T' < T -> 0 < e -> exists d, 0 < d /\ forall m (a b : nat -> R),
    (forall k, (k < m)%nat -> 0 <= a k <= b k /\ b k <= T') -> (forall k, (S k < m)%nat -> b k <= a (S k)) ->
    Sum m (fun k => b k - a k) < d -> Sum m (fun k => Cmod (v i (b k) - v i (a k))%C) < e) /\
  exists N, tanner2_filippov.negligible N /\ forall t, 0 <= t < T -> ~ N t -> tanner2_filippov.apart_at n complete (fun i => r i t) ->
    exists z, tanner2_filippov.K10 n V' R0 (fun i => r i t) (fun i => v i t) z /\ forall i, (i < n)%nat -> is_velocity (v i) t (z i)).
Check (tanner2_filippov.pairs_apart :
  forall (n : nat) (V V' : nat -> nat -> R -> R) (R0 : R) (r v : nat -> R -> C),
       0 < R0 -> tanner2_filippov.potentials n complete V V' -> tanner2_filippov.apart_at n complete (fun i => r i 0) ->
       exists d, 0 < d /\ forall T, tanner2_filippov.motion10_until T n V' R0 r v ->
         forall t i j, 0 <= t < T -> (i < n)%nat -> (j < n)%nat -> i <> j -> d < Cmod (r i t - r j t)%C).

(* the path 0 - 1 - 2 *)
Check (eq_refl : path3 = fun k j => (Nat.eqb k 1 && negb (Nat.eqb j 1) || Nat.eqb j 1 && negb (Nat.eqb k 1))%bool).
Check (eq_refl : VP = fun s => (s - 2) ^ 2 / 4 + Rmax 0 (/ s - 1) ^ 2).
Check (eq_refl : place2 = fun d i => match i with 0%nat => RtoC (2 + d / 2) | 1%nat => RtoC 0 | _ => RtoC (2 - d / 2) end).
Check (eq_refl : speed2 = fun e i => match i with 0%nat => RtoC (e / 2) | 1%nat => RtoC 0 | _ => RtoC (- e / 2) end).
Check (eq_refl : apart = fun t => exp (- t / 2) * cos (t / 2)).


(* tanner2.sec4.flocking *)
Check (tanner2_path.unlinked_together :
  solution 3 path3 (fun _ _ : nat => VP) (fun _ _ : nat => VP') (fun (i : nat) (_ : R) => place2 0 i)
         (fun (i : nat) (_ : R) => speed2 0 i) /\
       (forall s : R, 0 < s -> s <> 2 -> VP 2 < VP s) /\
       (forall i : nat, speed2 0 i = RtoC 0) /\ place2 0 0 = place2 0 2).

(* trees: connected, and not so without any one of the edges; limits of points of the plane *)
Check (eq_refl : tanner_trees.tree = fun n adj => strongly_connected n adj /\
  forall a b, arc n adj a b -> ~ strongly_connected n (fun i j =>
    (adj i j && negb (Nat.eqb i a && Nat.eqb j b || Nat.eqb i b && Nat.eqb j a))%bool)).
Check (eq_refl : tanner_trees.tends = fun z l => is_lim_seq (fun k => fst (z k)) (fst l) /\ is_lim_seq (fun k => snd (z k)) (snd l)).
Check (eq_refl : saturated = fun V R0 s => if Rlt_dec s R0 then V s else V R0).


(* tanner2.cor1, corrected, clause 2 *)
Check (tanner_graph.tree_columns :
  forall (n : nat) (adj : graph) (O : list (nat * nat)) (y : nat * nat -> R), undirected adj -> tanner_trees.tree n adj -> oriented n adj O ->
       (forall k, (k < n)%nat -> lsum O (fun f => inc k f * y f) = 0) -> forall f, In f O -> y f = 0).

(* tanner2.cor1, corrected, clause 3 *)
Check (tanner_trees.tree_equilibrium :
  forall (n : nat) (adj : graph) (V' : nat -> nat -> R -> R) (m : nat -> nat -> R) (r : nat -> C) (u : C),
       undirected adj -> (forall i j, V' i j = V' j i) -> tanner_trees.tree n adj ->
       (forall i j s, (i < n)%nat -> (j < n)%nat -> adj i j = true -> 0 < s -> V' i j s = 0 -> s = m i j) ->
       distinct n adj r -> (forall i, (i < n)%nat -> control4 n adj V' r (fun _ => u) i = RtoC 0) ->
       forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> norm (r i - r j)%C = m i j).

(* tanner2.eq7, clause 3: limits of states of Omega, in relative positions and velocities, are states of Omega *)
Check (tanner_trees.Omega_closed :
  forall (n : nat) (adj : graph) (V V' : nat -> nat -> R -> R) (c : R) (r v : nat -> nat -> C) (x : nat -> nat -> C) (y : nat -> C),
       undirected adj -> no_loops adj -> (forall i j, V i j = V j i) ->
       (forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> potential (V i j) (V' i j)) ->
       (forall k, distinct n adj (r k) /\ Wenergy n adj V (r k) (v k) <= c) ->
       (forall i j, (i < n)%nat -> (j < n)%nat -> tanner_trees.tends (fun k => r k i - r k j)%C (x i j)) ->
       (forall i, (i < n)%nat -> tanner_trees.tends (fun k => v k i) (y i)) ->
       exists q : nat -> C, (forall i j, (i < n)%nat -> (j < n)%nat -> x i j = (q i - q j)%C) /\
         distinct n adj q /\ Wenergy n adj V q y <= c).

(* tanner2.lem1, corrected, clause 1 *)
Check (tanner_saturated.saturated_regular :
  forall (V V' : R -> R) (R0 : R), (forall s, 0 < s -> is_derive V s (V' s)) -> (forall s, 0 < s -> continuity_pt V' s) ->
       forall s, 0 < s -> s <> R0 -> regular (saturated V R0) s).

(* tanner2.lem1, corrected, clause 2 *)
Check (tanner_saturated.negative_regular :
  forall (V V' : R -> R) (R0 : R), 0 < R0 -> (forall s, 0 < s -> is_derive V s (V' s)) -> (forall s, 0 < s -> continuity_pt V' s) ->
       0 < V' R0 -> regular (fun s => - saturated V R0 s) R0).

(* tanner2.lem1, corrected, clause 3 *)
Check (tanner_saturated.derivatives_at_R :
  forall (V V' : R -> R) (R0 : R), 0 < R0 -> (forall s, 0 < s -> is_derive V s (V' s)) -> (forall s, 0 < s -> continuity_pt V' s) ->
       0 < V' R0 -> forall w, one_sided (saturated V R0) R0 w (Rmin 0 (V' R0 * w)) /\ clarke (saturated V R0) R0 w (Rmax 0 (V' R0 * w))).


(* tanner2.eq8, the product rule; dV i is whatever the rate of V_i is *)
Check (tanner_rates.eq8_product :
  forall (n : nat) (adj : graph) (V V' : nat -> nat -> R -> R) (r v : nat -> R -> C) (dV : nat -> R) (t : R),
       (forall i, (i < n)%nat -> is_derive (fun x => V_i n adj V (fun j => r j x) i) t (dV i)) ->
       (forall i, (i < n)%nat -> is_velocity (v i) t (control4 n adj V' (fun j => r j t) (fun j => v j t) i)) ->
       is_derive (fun x => Wenergy n adj V (fun i => r i x) (fun i => v i x)) t (/ 2 * Sum n dV -
         Sum n (fun i => inner (v i t) (Csum n (fun j => RtoC (w adj i j) * (v i t - v j t)) + grad_i n adj V' (fun j => r j t) i)%C))).
(* tanner2.rangeB: a tree is connected, and no longer so without any one of its edges *)
Check (eq_refl : tree = fun n adj => strongly_connected n adj /\ forall a b, arc n adj a b -> ~ strongly_connected n (without adj a b)).
Check (tanner_components.tree_edges : forall (n : nat) (adj : graph) (O : list (nat * nat)), (1 <= n)%nat -> undirected adj -> tree n adj ->
       oriented n adj O -> (length O + 1 = n)%nat).
(* tanner2.eq13.interval: the links of pairs at the distance R are free *)
Check (eq_refl : rhs13 = fun n r v R0 x => exists a b, allowed n r R0 a /\ allowed n r R0 b /\
  - qform (2 * n) (kron2 (lap n a)) (stack v) <= x <= - qform (2 * n) (kron2 (lap n b)) (stack v)).
Check (tanner2_facts.eq13_interval :
  forall (n : nat) (r v : nat -> C) (R0 : R), exists e f, e <= f <= 0 /\ forall x, rhs13 n r v R0 x <-> e <= x <= f).
Check (tanner2_facts.eq13_no_tie :
  forall (n : nat) (r v : nat -> C) (R0 : R) (adj : graph), (forall i j, (i < n)%nat -> (j < n)%nat -> i <> j -> norm (r i - r j)%C <> R0) ->
       allowed n r R0 adj -> forall x, rhs13 n r v R0 x <-> x = - qform (2 * n) (kron2 (lap n adj)) (stack v)).
