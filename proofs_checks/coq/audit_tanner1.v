(* Audit of tanner1: each theorem of theorems.tsv with its statement written out, and the axioms it rests on.
   The objects of the statements are restated first. *)
From Coq Require Import Reals Lra Lia ZArith Relations List.
From Coquelicot Require Import Coquelicot.
From Flockproof Require tanner2_connectivity.
From Flockproof Require Import RealSums tanner_rates tanner_components tanner1_pair paley_model paley_phase paley_laplacian paley_gradient paley_particles paley_fourier paley_patterns paley_fish tanner_energy tanner_flock tanner_nonsmooth tanner1_heading tanner1_examples tanner1_motion tanner2_examples tanner2_facts tanner_graph paley_stability.
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

(* tanner1.L *)
Check (paley_gradient.lap_psd :
  forall (n : nat) (adj : graph) (x : nat -> C),
       undirected adj ->
       (forall k j : nat, lap n adj k j = lap n adj j k) /\
       0 <= Sum n (fun k : nat => inner (x k) (row n (lap n adj) k x))).

(* tanner1.L *)
Check (tanner_graph.L_incidence :
  forall (n : nat) (adj : graph) (O : list (nat * nat)) (k m : nat),
       undirected adj ->
       oriented n adj O ->
       (k < n)%nat -> (m < n)%nat -> lsum O (fun f : nat * nat => inc k f * inc m f) = lap n adj k m).

(* tanner1.L *)
Check (tanner_graph.L_orientation :
  forall (n : nat) (adj : graph) (O O' : list (nat * nat)) (k m : nat),
       undirected adj ->
       oriented n adj O ->
       oriented n adj O' ->
       (k < n)%nat ->
       (m < n)%nat ->
       lsum O (fun f : nat * nat => inc k f * inc m f) = lsum O' (fun f : nat * nat => inc k f * inc m f)).

(* tanner1.L, tanner1.Lw *)
Check (tanner_graph.Lw_kernel :
  forall (n : nat) (adj : graph) (W : nat -> nat -> R) (x : nat -> R),
       undirected adj ->
       (forall i j : nat, W i j = W j i) ->
       (forall i j : nat, 0 < W i j) ->
       let a := fun i j : nat => w adj i j * W i j in
       (forall k m : nat, lapw n a k m = lapw n a m k) /\
       0 <= Sum n (fun k : nat => x k * Sum n (fun j : nat => lapw n a k j * x j)) /\
       ((forall k : nat, (k < n)%nat -> Sum n (fun j : nat => lapw n a k j * x j) = 0) <->
        (forall j k : nat, clos_refl_trans nat (arc n adj) j k -> x j = x k))).

(* tanner1.L.ones *)
Check (paley_gradient.lap_ones :
  forall (n : nat) (adj : graph) (c : R) (k : nat), (k < n)%nat -> lmul n adj (fun _ : nat => c) k = 0).

(* tanner1.L.ones *)
Check (tanner2_connectivity.null_vectors :
  forall (n : nat) (adj : graph) (x : nat -> R), (1 <= n)%nat -> strongly_connected n adj ->
       ((forall k, (k < n)%nat -> Sum n (fun j => lap n adj k j * x j) = 0) <-> exists c, forall k, (k < n)%nat -> x k = c)).

(* tanner1.L.ones *)
Check (tanner_graph.L_ones_fails :
  ~
       (forall (n : nat) (adj : graph) (x : nat -> R),
        (1 <= n)%nat ->
        undirected adj ->
        no_loops adj ->
        (forall k : nat, (k < n)%nat -> lmul n adj x k = 0) -> exists c : R, forall k : nat, (k < n)%nat -> x k = c)).

(* tanner1.Lw *)
Check (tanner_graph.Lw_incidence :
  forall (n : nat) (adj : graph) (O : list (nat * nat)) (W : nat -> nat -> R) (k m : nat),
       undirected adj ->
       oriented n adj O ->
       (forall i j : nat, W i j = W j i) ->
       (k < n)%nat ->
       (m < n)%nat ->
       lsum O (fun f : nat * nat => inc k f * W (fst f) (snd f) * inc m f) =
       lapw n (fun i j : nat => w adj i j * W i j) k m).

(* tanner1.Vmono *)
Check (tanner1_heading.Vmono_fails :
  ~ (forall s t : R, 0 < s < t -> V2 s <= V2 t)).

(* tanner1.Vt *)
Check (tanner1_heading.Vt_ge0 :
  forall (n : nat) (adj : nat -> nat -> bool) (V : nat -> nat -> R -> R) (r v : nat -> C) (th : nat -> R),
       (forall (i j : nat) (s : R), (i < n)%nat -> (j < n)%nat -> 0 < s -> 0 <= V i j s) ->
       (forall i j : nat, (i < n)%nat -> (j < n)%nat -> adj i j = true -> r i <> r j) -> 0 <= Vt n adj V r v th).

(* tanner1.Vt_inv *)
Check (tanner1_examples.Vt_grows :
  exists d : R,
         0 < d /\
         is_derive
           (fun x : R_AbsRing =>
            Vt 2 complete (fun _ _ : nat => V2) (fun i : nat => rct i x) (fun i : nat => (sc i x * expi (thc i x))%C)
              (fun i : nat => thc i x)) 0 d).

(* tanner1.anyV *)
Check (tanner1_examples.anyV_fails :
  (forall t : R,
        t <> 1 ->
        closed_loop 2 complete (fun (_ _ : nat) (_ : R) => 0) (fun (i : nat) (t0 : R) => place i t0) speed
          (fun (_ : nat) (_ : R) => 0) t) /\ (forall s : R, is_derive (fun _ : R => 0) s 0) /\ place 0 1 = place 1 1).

(* tanner1.collision *)
Check (tanner1_examples.collision_fails :
  ~
       (forall (n : nat) (adj : graph) (v : nat -> C) (th : nat -> R),
        undirected adj ->
        strongly_connected n adj ->
        forall i j : nat,
        (i < n)%nat ->
        (j < n)%nat ->
        i <> j ->
        forall c : R,
        exists d : R,
          0 < d /\
          (forall r : nat -> C,
           (forall a b : nat, (a < n)%nat -> (b < n)%nat -> adj a b = true -> r a <> r b) ->
           norm (r i - r j)%C < d -> c < Vt n adj (fun _ _ : nat => V2) r v th))).

(* tanner1.eq6 *)
Check (tanner_energy.tanner1_eq6 :
  forall (n : nat) (adj : graph) (V' : nat -> nat -> R -> R) (r a : nat -> C),
       undirected adj ->
       (forall i j : nat, V' i j = V' j i) ->
       Sum n (fun i : nat => cross (r i) (- grad_i n adj V' r i + a i)%C) = Sum n (fun i : nat => cross (r i) (a i)) /\
       Sum n (fun i : nat => Sum n (fun j : nat => w adj i j * cross (r i - r j)%C (grad (V' i j) (r i) (r j)))) = 0).

(* tanner1.eq6b *)
Check (tanner1_examples.eq6b_printed_fails :
  ~
       (forall (n : nat) (adj : graph) (V : nat -> nat -> R_AbsRing -> R_NormedModule)
          (V' : nat -> nat -> R -> R_NormedModule) (r : nat -> R -> C) (s th : nat -> R -> R)
          (dth : nat -> R_NormedModule) (t : R),
        undirected adj ->
        (forall (i j : nat) (x : R), 0 < x -> is_derive (V i j) x (V' i j x)) ->
        (forall i j : nat, V i j = V j i) ->
        closed_loop n adj V' r s th t ->
        (forall i : nat, (i < n)%nat -> is_derive (th i) t (dth i)) ->
        Sum n
          (fun i : nat =>
           inner (r i t) (s i t * expi (th i t))%C *
           (dth i + align n adj (fun j : nat => r j t) (fun j : nat => th j t) i)) = 0)).

(* tanner1.eq7, tanner1.decoupled *)
Check (tanner1_examples.eq7_printed_fails :
  ~
       (forall (n : nat) (adj : graph) (V : nat -> nat -> R_AbsRing -> R_NormedModule)
          (V' : nat -> nat -> R -> R_NormedModule) (r : nat -> R -> C) (s th : nat -> R -> R)
          (dth : nat -> R_NormedModule) (t : R),
        undirected adj ->
        strongly_connected n adj ->
        (forall (i j : nat) (x : R), 0 < x -> is_derive (V i j) x (V' i j x)) ->
        (forall i j : nat, V i j = V j i) ->
        closed_loop n adj V' r s th t ->
        (forall i : nat, (i < n)%nat -> is_derive (th i) t (dth i)) ->
        forall i : nat, (i < n)%nat -> dth i = - align n adj (fun j : nat => r j t) (fun j : nat => th j t) i)).

(* tanner1.eq7 *)
Check (tanner1_heading.eq7_corrected :
  forall (n : nat) (adj : graph) (V' : nat -> nat -> R -> R) (r : nat -> C) (s th : nat -> R -> R)
         (ds dth : nat -> R) (t : R) (i : nat),
       0 < s i t ->
       is_derive (s i) t (ds i) ->
       is_derive (th i) t (dth i) ->
       is_velocity (fun x : R => (s i x * expi (th i x))%C) t
         (accel n adj V' r (fun j : nat => (s j t * expi (th j t))%C) (fun j : nat => th j t) i) ->
       dth i =
       - align n adj r (fun j : nat => th j t) i -
       cross (s i t * expi (th i t))%C (grad_i n adj V' r i) / norm (s i t * expi (th i t))%C ^ 2).

(* tanner1.eq8 *)
Check (tanner_energy.tanner1_eq8_gradients :
  forall (V V' : R -> R) (ri rj e : C),
       ri <> rj ->
       is_derive V (norm (ri - rj)%C) (V' (norm (ri - rj)%C)) ->
       is_derive (fun s : R_AbsRing => V (norm (ri + s * e - rj)%C)) 0 (inner (grad V' ri rj) e) /\
       is_derive (fun s : R_AbsRing => V (norm (ri - (rj + s * e))%C)) 0 (- inner (grad V' ri rj) e) /\
       is_derive (fun s : R_AbsRing => V (norm (ri - rj + s * e)%C)) 0 (inner (grad V' ri rj) e)).

(* tanner1.eq8 *)
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

(* tanner1.eq9 *)
Check (tanner1_examples.eq9_printed_fails :
  ~
       (forall (n : nat) (adj : graph) (V : nat -> nat -> R_AbsRing -> R_NormedModule)
          (V' : nat -> nat -> R -> R_NormedModule) (r : nat -> R -> C) (s th : nat -> R -> R) 
          (t : R) (d : R_NormedModule),
        undirected adj ->
        (forall (i j : nat) (x : R), 0 < x -> is_derive (V i j) x (V' i j x)) ->
        (forall i j : nat, V i j = V j i) ->
        closed_loop n adj V' r s th t ->
        (forall i : nat, (i < n)%nat -> ex_derive (th i) t) ->
        is_derive
          (fun x : R_AbsRing =>
           Vt n adj V (fun i : nat => r i x) (fun i : nat => (s i x * expi (th i x))%C) (fun i : nat => th i x)) t d ->
        d = - tanner1_examples.Lw_form n adj (fun i : nat => r i t) (fun i : nat => th i t) /\ d <= 0)).

(* tanner1.eq9.chain *)
Check (tanner1_heading.eq9_chain :
  forall (n : nat) (adj : graph) (V V' : nat -> nat -> R -> R) (r v : nat -> R -> C) 
         (th : nat -> R -> R) (dth : nat -> R) (t : R),
       undirected adj ->
       (forall i j : nat, V' i j = V' j i) ->
       (forall i : nat, (i < n)%nat -> is_velocity (r i) t (v i t)) ->
       (forall i j : nat, (i < n)%nat -> (j < n)%nat -> adj i j = true -> r i t <> r j t) ->
       (forall i j : nat,
        (i < n)%nat ->
        (j < n)%nat -> adj i j = true -> is_derive (V i j) (norm (r i t - r j t)%C) (V' i j (norm (r i t - r j t)%C))) ->
       (forall i : nat,
        (i < n)%nat ->
        is_velocity (v i) t (accel n adj V' (fun j : nat => r j t) (fun j : nat => v j t) (fun j : nat => th j t) i)) ->
       (forall i : nat, (i < n)%nat -> is_derive (th i) t (dth i)) ->
       is_derive
         (fun s : R_AbsRing => Vt n adj V (fun i : nat => r i s) (fun i : nat => v i s) (fun i : nat => th i s)) t
         (Sum n (fun i : nat => th i t * dth i))).

(* tanner1.fig2 *)
Check (tanner1_heading.fig2_shape :
  (forall s t : R, 0 < s < t -> t <= 1 -> V2 t < V2 s) /\
       (forall s t : R, 1 <= s < t -> V2 s < V2 t) /\ V2 1 = 1 /\ (forall s : R, 0 < s -> s <> 1 -> 1 < V2 s)).

(* tanner1.gyro *)
Check (tanner1_heading.gyro_no_work :
  forall (n : nat) (adj : graph) (r v : nat -> C) (th : nat -> R) (i : nat),
       inner (v i) (gyro n adj r v th i) = 0).

(* tanner1.gyro *)
Check (tanner1_heading.gyro_kinetic :
  forall (n : nat) (adj : graph) (r : nat -> C) (th : nat -> R) (v : nat -> R -> C) (f : C) (t : R) (i : nat),
       is_velocity (v i) t (f + gyro n adj r (fun i0 : nat => v i0 t) th i)%C ->
       is_derive (fun s : R_AbsRing => / 2 * inner (v i s) (v i s)) t (inner (v i t) f)).

(* tanner1.propIV3b, tanner1.proof_cases *)
Check (tanner1_examples.propIV3b_fails :
  (forall t : R, closed_loop 2 complete (fun _ _ : nat => Vh') r_osc s_osc (fun (_ : nat) (_ : R) => 0) t) /\
       (forall s : R, 0 < s -> 0 <= Vh s /\ (Vh s = 0 <-> s = 2)) /\
       (forall s : R, 1 < s -> is_derive Vh s (Vh' s)) /\
       (forall m : nat,
        norm (r_osc 0 (INR m * PI) - r_osc 1 (INR m * PI))%C = 5 / 2 /\
        Vh (norm (r_osc 0 (INR m * PI) - r_osc 1 (INR m * PI))%C) = 1 / 4)).

(* the motions of propIV3b_fails and propIV3a_ends; the law for given headings *)
Check (eq_refl : closed_loop = fun n adj V' r s th t => forall i, (i < n)%nat -> 0 < s i t /\ ex_derive (s i) t /\
  is_velocity (r i) t (RtoC (s i t) * expi (th i t))%C /\ is_velocity (fun x => RtoC (s i x) * expi (th i x))%C t
    (accel n adj V' (fun j => r j t) (fun j => RtoC (s j t) * expi (th j t))%C (fun j => th j t) i)).
Check (eq_refl : gap = fun t => 2 + / 2 * cos (2 * t)).
Check (eq_refl : swing = fun c i t => match i with 0%nat => RtoC (c * t + / 2 * gap t) | _ => RtoC (c * t - / 2 * gap t) end).
Check (eq_refl : swing_speed = fun c i t => match i with 0%nat => c - / 2 * sin (2 * t) | _ => c + / 2 * sin (2 * t) end).
Check (eq_refl : r_osc = swing 3).
Check (eq_refl : s_osc = swing_speed 3).
Check (eq_refl : Vh = fun s => (s - 2) ^ 2 + Rmax 0 (/ s - 1) ^ 2).
Check (eq_refl : Vh' = fun s => 2 * (s - 2) - (if Rlt_dec s 1 then 2 * (/ s - 1) / s ^ 2 else 0)).
Check (eq_refl : steered = fun n adj V V' r v th t =>
  (forall i, (i < n)%nat -> is_velocity (r i) t (v i t)) /\
  (forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> r i t <> r j t) /\
  (forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true ->
     is_derive (V i j) (norm (r i t - r j t)%C) (V' i j (norm (r i t - r j t)%C))) /\
  (forall i, (i < n)%nat -> is_velocity (v i) t (accel n adj V' (fun j => r j t) (fun j => v j t) (fun j => th j t) i))).
Check (eq_refl : mechanical = fun n adj V r v =>
  / 2 * Sum n (fun i => Sum n (fun j => w adj i j * V i j (norm (r i - r j)%C)) + inner (v i) (v i))).

(* tanner1.Vt_inv, tanner1.propIV3b, tanner1.decoupled *)
Check (tanner1_motion.mechanical_constant :
  forall (n : nat) (adj : graph) (V V' : nat -> nat -> R -> R) (r v : nat -> R -> C) (th : nat -> R -> R),
       undirected adj ->
       (forall i j : nat, V' i j = V' j i) ->
       forall T : R,
       (forall t : R, 0 <= t < T -> steered n adj V V' r v th t) ->
       forall t : R, 0 <= t < T ->
       mechanical n adj V (fun i => r i t) (fun i => v i t) = mechanical n adj V (fun i => r i 0) (fun i => v i 0)).

(* the velocity is turned at any rates q; the law is demanded only where no linked agents are in one place, and not at the times in J, at
   which headings may jump and velocities are continuous *)
Check (eq_refl : turned = fun n adj V' r v q i => (- grad_i n adj V' r i + RtoC (q i) * (Ci * v i))%C).
Check (eq_refl : turning = fun n adj V' r v q J t =>
  (forall i, (i < n)%nat -> is_velocity (r i) t (v i t)) /\
  ((forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> r i t <> r j t) ->
   forall i, (i < n)%nat -> continuity_pt (fun s => fst (v i s)) t /\ continuity_pt (fun s => snd (v i s)) t /\
     (~ In t J -> is_velocity (v i) t (turned n adj V' (fun i => r i t) (fun i => v i t) (fun i => q i t) i)))).
(* beyond.tanner1.two_agents, tanner1.Vt_inv, tanner1.propIV3b *)
Check (tanner1_motion.turning_constant :
  forall (n : nat) (adj : graph) (V V' : nat -> nat -> R -> R) (r v : nat -> R -> C) (q : nat -> R -> R),
       undirected adj -> (forall i j, V' i j = V' j i) ->
       forall (J : list R) t, 0 <= t ->
       (forall s, 0 <= s <= t -> turning n adj V' r v q J s /\
          (forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> r i s <> r j s) /\
          (forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true ->
             is_derive (V i j) (norm (r i s - r j s)%C) (V' i j (norm (r i s - r j s)%C)))) ->
       mechanical n adj V (fun i => r i t) (fun i => v i t) = mechanical n adj V (fun i => r i 0) (fun i => v i 0)).
(* tanner1.anyV, tanner1.collision *)
Check (tanner1_motion.turning_apart :
  forall (n : nat) (adj : graph) (V V' : nat -> nat -> R -> R) (r v : nat -> R -> C) (q : nat -> R -> R),
       undirected adj -> (forall i j, V' i j = V' j i) ->
       (forall i j s, (i < n)%nat -> (j < n)%nat -> adj i j = true -> 0 < s -> is_derive (V i j) s (V' i j s) /\ 0 <= V i j s) ->
       (forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> r i 0 <> r j 0) ->
       (forall i j M, (i < n)%nat -> (j < n)%nat -> adj i j = true -> exists d, 0 < d /\ forall s, 0 < s < d -> M < V i j s) ->
       exists d, 0 < d /\ forall T J, (forall t, 0 <= t <= T -> turning n adj V' r v q J t) ->
         forall t i j, 0 <= t <= T -> (i < n)%nat -> (j < n)%nat -> adj i j = true -> d <= norm (r i t - r j t)%C).
(* tanner1.anyV *)
Check (tanner1_motion.turning_cohesion :
  forall (n : nat) (adj : graph) (V V' : nat -> nat -> R -> R) (r v : nat -> R -> C) (q : nat -> R -> R),
       undirected adj -> (forall i j, V' i j = V' j i) ->
       (forall i j s, (i < n)%nat -> (j < n)%nat -> adj i j = true -> 0 < s -> is_derive (V i j) s (V' i j s) /\ 0 <= V i j s) ->
       (forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> r i 0 <> r j 0) ->
       (forall i j M, (i < n)%nat -> (j < n)%nat -> adj i j = true -> exists d, 0 < d /\ forall s, 0 < s < d -> M < V i j s) ->
       strongly_connected n adj ->
       (forall i j M, (i < n)%nat -> (j < n)%nat -> adj i j = true -> exists D, forall s, D < s -> M < V i j s) ->
       exists B, forall T J, (forall t, 0 <= t <= T -> turning n adj V' r v q J t) ->
         forall t i j, 0 <= t <= T -> (i < n)%nat -> (j < n)%nat -> norm (r i t - r j t)%C <= B).

(* tanner1.collision, corrected, first clause *)
Check (tanner1_motion.Vt_linked :
  forall (n : nat) (adj : graph) (V : nat -> nat -> R -> R) (v : nat -> C) (th : nat -> R) (i j : nat) (M : R),
       (forall (i j : nat) (s : R), (i < n)%nat -> (j < n)%nat -> 0 < s -> 0 <= V i j s) ->
       (forall (i j : nat) (M : R), (i < n)%nat -> (j < n)%nat -> exists d, 0 < d /\ forall s : R, 0 < s < d -> M < V i j s) ->
       (i < n)%nat -> (j < n)%nat -> adj i j = true ->
       exists d : R, 0 < d /\ forall r : nat -> C,
         (forall a b : nat, (a < n)%nat -> (b < n)%nat -> adj a b = true -> r a <> r b) ->
         norm (r i - r j)%C < d -> M < Vt n adj V r v th).

(* no row of theorems.tsv: refutes tanner1.propIV3a only if it is read as including that the motion, with its headings (2), exists
   for all t >= 0; uniqueness of the motion is not proved *)
Check (tanner1_motion.propIV3a_ends :
  (forall t : R, 0 <= t < PI / 12 ->
     closed_loop 2 complete (fun _ _ : nat => Vh') (swing (/ 4)) (swing_speed (/ 4)) (fun (_ : nat) (_ : R) => 0) t) /\
       (forall (r : nat -> R -> C) (s th : nat -> R -> R),
        (forall (t : R) (i : nat), 0 <= t < PI / 12 -> (i < 2)%nat -> r i t = swing (/ 4) i t) ->
        ~ closed_loop 2 complete (fun _ _ : nat => Vh') r s th (PI / 12))).

(* two linked agents with a wrapped heading difference *)
Check (eq_refl : tanner1_pair.wrapped = fun d x => sin x = 0 \/ - PI <= d <= PI /\ exists k : Z, d = x + 2 * IZR k * PI).

(* beyond.tanner1.two_agents, clause 2: velocities are continuous, the law holds but for finitely many instants of [a, b] *)
Check (tanner1_pair.two_agents_gather :
  forall (adj : graph) (V V' : nat -> nat -> R -> R) (r v : nat -> R -> C) (th phi s : nat -> R -> R),
       undirected adj -> (forall i j, V' i j = V' j i) -> adj 0%nat 1%nat = true ->
       forall (L : list R) (a b : R), a <= b ->
       (forall t i, a <= t <= b -> (i < 2)%nat ->
          continuity_pt (fun x => fst (v i x)) t /\ continuity_pt (fun x => snd (v i x)) t) ->
       (forall t i, a <= t <= b -> (i < 2)%nat -> 0 <= s i t /\ v i t = (RtoC (s i t) * expi (phi i t))%C) ->
       (forall t, a < t < b -> ~ In t L ->
          steered 2 adj V V' r v th t /\ tanner1_pair.wrapped (th 0%nat t - th 1%nat t) (phi 0%nat t - phi 1%nat t)) ->
       norm (v 0%nat a + v 1%nat a)%C <= norm (v 0%nat b + v 1%nat b)%C).

(* headings of moving agents, rates of V_t; components (tanner1.eq6b, eq9, eq9.chain, proof_cases, proof_ratio, Vt_inv, Omega.bounded, L, Lw) *)
Check (eq_refl : align = fun n adj r th i => Sum n (fun j => w adj i j * ((th i - th j) / Cmod (r i - r j)%C ^ 2))).
Check (eq_refl : accel = fun n adj V' r v th i => (- grad_i n adj V' r i + RtoC (- align n adj r th i) * (Ci * v i))%C).
Check (eq_refl : Vt = fun n adj V r v th => / 2 * Sum n (fun i => V_i n adj V r i + inner (v i) (v i) + th i ^ 2)).
Check (tanner_rates.eq6b_corrected :
  forall (n : nat) (adj : graph) (V' : nat -> nat -> R -> R) (r : nat -> C) (s th : nat -> R -> R) (ds dth : nat -> R) (t : R),
       (forall i, (i < n)%nat -> 0 < s i t) -> (forall i, (i < n)%nat -> is_derive (s i) t (ds i)) -> (forall i, (i < n)%nat -> is_derive (th i) t (dth i)) ->
       let v := fun i => (RtoC (s i t) * expi (th i t))%C in
       (forall i, (i < n)%nat -> is_velocity (fun x => RtoC (s i x) * expi (th i x))%C t (accel n adj V' r v (fun j => th j t) i)) ->
       Sum n (fun i => inner (r i) (v i) * (dth i + align n adj r (fun j => th j t) i + cross (v i) (grad_i n adj V' r i) / norm (v i) ^ 2)) = 0).
Check (tanner_rates.eq9_corrected :
  forall (n : nat) (adj : graph) (V V' : nat -> nat -> R -> R) (r : nat -> R -> C) (s th : nat -> R -> R) (ds dth : nat -> R) (t : R),
       let v := fun i x => (RtoC (s i x) * expi (th i x))%C in undirected adj -> (forall i j, V' i j = V' j i) ->
       (forall i, (i < n)%nat -> is_velocity (r i) t (v i t)) -> (forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> r i t <> r j t) ->
       (forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> is_derive (V i j) (norm (r i t - r j t)%C) (V' i j (norm (r i t - r j t)%C))) ->
       (forall i, (i < n)%nat -> 0 < s i t /\ is_derive (s i) t (ds i) /\ is_derive (th i) t (dth i)) ->
       (forall i, (i < n)%nat -> is_velocity (v i) t (accel n adj V' (fun j => r j t) (fun j => v j t) (fun j => th j t) i)) ->
       let Lw := lapw n (fun i j => w adj i j * / norm (r i t - r j t)%C ^ 2) in
       is_derive (fun x => Vt n adj V (fun i => r i x) (fun i => v i x) (fun i => th i x)) t
         (- Sum n (fun i => th i t * Sum n (fun j => Lw i j * th j t))
          - Sum n (fun i => th i t * (cross (v i t) (grad_i n adj V' (fun j => r j t) i) / norm (v i t) ^ 2)))).
Check (tanner1_heading.Vt_rate :
  forall (n : nat) (adj : graph) (V V' : nat -> nat -> R -> R) (r v : nat -> R -> C) (th : nat -> R -> R) (dth : nat -> R) (t : R) (u : nat -> C),
       undirected adj -> (forall i j, V' i j = V' j i) -> (forall i, (i < n)%nat -> is_velocity (r i) t (v i t)) ->
       (forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> r i t <> r j t) ->
       (forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> is_derive (V i j) (norm (r i t - r j t)%C) (V' i j (norm (r i t - r j t)%C))) ->
       (forall i, (i < n)%nat -> is_velocity (v i) t (u i)) -> (forall i, (i < n)%nat -> is_derive (th i) t (dth i)) ->
       is_derive (fun s => Vt n adj V (fun i => r i s) (fun i => v i s) (fun i => th i s)) t
         (Sum n (fun i => inner (grad_i n adj V' (fun i => r i t) i) (v i t)) + Sum n (fun i => inner (v i t) (u i)) + Sum n (fun i => th i t * dth i))).
Check (tanner_rates.equal_headings_forces :
  forall (n : nat) (adj : graph) (V' : nat -> nat -> R -> R) (r : nat -> C) (s th : nat -> R -> R) (ds dth : nat -> R) (t : R),
       (forall i, (i < n)%nat -> 0 < s i t) -> (forall i, (i < n)%nat -> is_derive (s i) t (ds i)) -> (forall i, (i < n)%nat -> is_derive (th i) t (dth i)) ->
       let v := fun i => (RtoC (s i t) * expi (th i t))%C in
       (forall i, (i < n)%nat -> is_velocity (fun x => RtoC (s i x) * expi (th i x))%C t (accel n adj V' r v (fun j => th j t) i)) ->
       (forall i j, (i < n)%nat -> (j < n)%nat -> th i t = th j t) -> (forall i, (i < n)%nat -> dth i = 0) ->
       forall i, (i < n)%nat -> cross (v i) (grad_i n adj V' r i) = 0 /\ exists c : R, grad_i n adj V' r i = (RtoC c * v i)%C).
Check (tanner_rates.equal_headings_ratios :
  forall (n : nat) (adj : graph) (V' : nat -> nat -> R -> R) (r : nat -> C) (s th : nat -> R -> R) (ds dth : nat -> R) (t : R),
       (forall i, (i < n)%nat -> 0 < s i t) -> (forall i, (i < n)%nat -> is_derive (s i) t (ds i)) -> (forall i, (i < n)%nat -> is_derive (th i) t (dth i)) ->
       let v := fun i => (RtoC (s i t) * expi (th i t))%C in
       (forall i, (i < n)%nat -> is_velocity (fun x => RtoC (s i x) * expi (th i x))%C t (accel n adj V' r v (fun j => th j t) i)) ->
       (forall i j, (i < n)%nat -> (j < n)%nat -> th i t = th j t) -> (forall i, (i < n)%nat -> dth i = 0) ->
       forall i, (i < n)%nat -> let a := accel n adj V' r v (fun j => th j t) i in let g := grad_i n adj V' r i in
       fst (v i) <> 0 -> fst a <> 0 -> fst g <> 0 -> snd a / fst a = snd (v i) / fst (v i) /\ snd g / fst g = snd (v i) / fst (v i)).
Check (tanner_rates.sublevel_invariant :
  forall (n : nat) (adj : graph) (V V' : nat -> nat -> R -> R) (r v : nat -> R -> C) (q : nat -> R -> R) (J : list R) (c t : R),
       undirected adj -> (forall i j, V' i j = V' j i) -> 0 <= t ->
       (forall x, 0 <= x <= t -> turning n adj V' r v q J x /\ distinct n adj (fun i => r i x) /\
         forall i j, (i < n)%nat -> (j < n)%nat -> adj i j = true -> is_derive (V i j) (norm (r i x - r j x)%C) (V' i j (norm (r i x - r j x)%C))) ->
       (mechanical n adj V (fun i => r i 0) (fun i => v i 0) <= c <-> mechanical n adj V (fun i => r i t) (fun i => v i t) <= c)).
Check (tanner_rates.Omega_bounded :
  forall (n : nat) (adj : graph) (c : R), (1 <= n)%nat -> undirected adj -> no_loops adj -> strongly_connected n adj ->
       exists B, forall (r v : nat -> C) (th : nat -> R), distinct n adj r -> Vt n adj (fun _ _ s => / s ^ 2 + ln (s ^ 2)) r v th <= c ->
         (forall i j, (i < n)%nat -> (j < n)%nat -> norm (r i - r j)%C <= B) /\ forall i, (i < n)%nat -> norm (v i) <= sqrt (2 * c)).
(* a list with one node of each component *)
Check (eq_refl : tanner_components.one_of_each = fun n adj l => NoDup l /\ (forall a, In a l -> (a < n)%nat) /\
  (forall a b, In a l -> In b l -> clos_refl_trans nat (arc n adj) a b -> a = b) /\ forall k, (k < n)%nat -> exists a, In a l /\ clos_refl_trans nat (arc n adj) a k).
Check (tanner_components.components_exist : forall (n : nat) (adj : graph), undirected adj -> exists l, tanner_components.one_of_each n adj l).
Check (tanner_components.zero_multiplicity :
  forall (n : nat) (adj : graph) (W : nat -> nat -> R) (l : list nat),
       undirected adj -> (forall i j, W i j = W j i) -> (forall i j, 0 < W i j) -> tanner_components.one_of_each n adj l ->
       let L := fun x k => Sum n (fun j => lapw n (fun i j => w adj i j * W i j) k j * x j) in let null := fun x => forall k, (k < n)%nat -> L x k = 0 in
       (forall y, exists x, null x /\ forall a, In a l -> x a = y a) /\
       (forall x x', null x -> null x' -> (forall a, In a l -> x a = x' a) -> forall k, (k < n)%nat -> x k = x' k) /\
       (forall x, null (L x) -> null x)).
Check (tanner_components.zero_multiplicity_L :
  forall (n : nat) (adj : graph) (l : list nat), undirected adj -> tanner_components.one_of_each n adj l ->
       let null := fun x => forall k, (k < n)%nat -> Sum n (fun j => lap n adj k j * x j) = 0 in
       (forall y, exists x, null x /\ forall a, In a l -> x a = y a) /\
       (forall x x', null x -> null x' -> (forall a, In a l -> x a = x' a) -> forall k, (k < n)%nat -> x k = x' k) /\
       (forall x, null (fun k => Sum n (fun j => lap n adj k j * x j)) -> null x)).
