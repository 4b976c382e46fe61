(* Audit of tanner1: each theorem of theorems.tsv with its statement written out, and the axioms it rests on.
   The objects of the statements are defined in paley_model.v (phasors, inner product, graphs, Laplacian, W_1),
   paley_phase.v and paley_particles.v (velocities, centres), tanner_energy.v (gradients, control, energy), tanner_flock.v (Definition 3). *)
From Coq Require Import Reals Lra Lia ZArith Relations List.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums paley_model paley_phase paley_laplacian paley_gradient paley_particles paley_fourier paley_patterns paley_fish tanner_energy tanner_flock tanner_nonsmooth tanner1_heading tanner1_examples tanner2_examples tanner2_facts.
Open Scope R_scope.

(* tanner1.L *)
Check (paley_gradient.lap_psd :
  forall (n : nat) (adj : graph) (x : nat -> C),
       undirected adj ->
       (forall k j : nat, lap n adj k j = lap n adj j k) /\
       0 <= Sum n (fun k : nat => inner (x k) (row n (lap n adj) k x))).
Print Assumptions paley_gradient.lap_psd.

(* tanner1.L.ones *)
Check (paley_gradient.lap_ones :
  forall (n : nat) (adj : graph) (c : R) (k : nat), (k < n)%nat -> lmul n adj (fun _ : nat => c) k = 0).
Print Assumptions paley_gradient.lap_ones.

(* tanner1.L.ones *)
Check (paley_gradient.lap_kernel :
  forall (n : nat) (adj : graph) (y : nat -> R),
       (1 <= n)%nat ->
       strongly_connected n adj ->
       (forall k : nat, (k < n)%nat -> lmul n adj y k = 0) -> exists c : R, forall k : nat, (k < n)%nat -> y k = c).
Print Assumptions paley_gradient.lap_kernel.

(* tanner1.Vmono *)
Check (tanner1_heading.Vmono_fails :
  ~ (forall s t : R, 0 < s < t -> V2 s <= V2 t)).
Print Assumptions tanner1_heading.Vmono_fails.

(* tanner1.Vt *)
Check (tanner1_heading.Vt_ge0 :
  forall (n : nat) (adj : nat -> nat -> bool) (V : nat -> nat -> R -> R) (r v : nat -> C) (th : nat -> R),
       (forall (i j : nat) (s : R), (i < n)%nat -> (j < n)%nat -> 0 < s -> 0 <= V i j s) ->
       (forall i j : nat, (i < n)%nat -> (j < n)%nat -> adj i j = true -> r i <> r j) -> 0 <= Vt n adj V r v th).
Print Assumptions tanner1_heading.Vt_ge0.

(* tanner1.Vt_inv *)
Check (tanner1_examples.Vt_grows :
  exists d : R,
         0 < d /\
         is_derive
           (fun x : R_AbsRing =>
            Vt 2 complete (fun _ _ : nat => V2) (fun i : nat => rct i x) (fun i : nat => (sc i x * expi (thc i x))%C)
              (fun i : nat => thc i x)) 0 d).
Print Assumptions tanner1_examples.Vt_grows.

(* tanner1.anyV *)
Check (tanner1_examples.anyV_fails :
  (forall t : R,
        t <> 1 ->
        closed_loop 2 complete (fun (_ _ : nat) (_ : R) => 0)
          (fun (i : nat) (t0 : R) => match i with
                                     | 0%nat => 0 + 2 * t0
                                     | S _ => 1 + 1 * t0
                                     end) (fun (i : nat) (_ : R) => match i with
                                                                    | 0%nat => 2
                                                                    | S _ => 1
                                                                    end) (fun (_ : nat) (_ : R) => 0) t) /\
       (forall s : R, is_derive (fun _ : R => 0) s 0) /\ 0 + 2 * 1 = 1 + 1 * 1).
Print Assumptions tanner1_examples.anyV_fails.

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
Print Assumptions tanner1_examples.collision_fails.

(* tanner1.eq6 *)
Check (tanner_energy.tanner1_eq6 :
  forall (n : nat) (adj : graph) (V' : nat -> nat -> R -> R) (r a : nat -> C),
       undirected adj ->
       (forall i j : nat, V' i j = V' j i) ->
       Sum n (fun i : nat => cross (r i) (- grad_i n adj V' r i + a i)%C) = Sum n (fun i : nat => cross (r i) (a i)) /\
       Sum n (fun i : nat => Sum n (fun j : nat => w adj i j * cross (r i - r j)%C (grad (V' i j) (r i) (r j)))) = 0).
Print Assumptions tanner_energy.tanner1_eq6.

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
Print Assumptions tanner1_examples.eq6b_printed_fails.

(* tanner1.eq7 *)
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
Print Assumptions tanner1_examples.eq7_printed_fails.

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
Print Assumptions tanner1_heading.eq7_corrected.

(* tanner1.eq8 *)
Check (tanner_energy.tanner1_eq8_gradients :
  forall (V V' : R -> R) (ri rj e : C),
       ri <> rj ->
       is_derive V (norm (ri - rj)%C) (V' (norm (ri - rj)%C)) ->
       is_derive (fun s : R_AbsRing => V (norm (ri + s * e - rj)%C)) 0 (inner (grad V' ri rj) e) /\
       is_derive (fun s : R_AbsRing => V (norm (ri - (rj + s * e))%C)) 0 (- inner (grad V' ri rj) e) /\
       is_derive (fun s : R_AbsRing => V (norm (ri - rj + s * e)%C)) 0 (inner (grad V' ri rj) e)).
Print Assumptions tanner_energy.tanner1_eq8_gradients.

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
Print Assumptions tanner_energy.eq8_potential.

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
        d = - Lw_form n adj (fun i : nat => r i t) (fun i : nat => th i t) /\ d <= 0)).
Print Assumptions tanner1_examples.eq9_printed_fails.

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
Print Assumptions tanner1_heading.eq9_chain.

(* tanner1.fig2 *)
Check (tanner1_heading.fig2_shape :
  (forall s t : R, 0 < s < t -> t <= 1 -> V2 t < V2 s) /\
       (forall s t : R, 1 <= s < t -> V2 s < V2 t) /\ V2 1 = 1 /\ (forall s : R, 0 < s -> s <> 1 -> 1 < V2 s)).
Print Assumptions tanner1_heading.fig2_shape.

(* tanner1.gyro *)
Check (tanner1_heading.gyro_no_work :
  forall (n : nat) (adj : graph) (r v : nat -> C) (th : nat -> R) (i : nat),
       inner (v i) (gyro n adj r v th i) = 0).
Print Assumptions tanner1_heading.gyro_no_work.

(* tanner1.gyro *)
Check (tanner1_heading.gyro_kinetic :
  forall (n : nat) (adj : graph) (r : nat -> C) (th : nat -> R) (v : nat -> R -> C) (f : C) (t : R) (i : nat),
       is_velocity (v i) t (f + gyro n adj r (fun i0 : nat => v i0 t) th i)%C ->
       is_derive (fun s : R_AbsRing => / 2 * inner (v i s) (v i s)) t (inner (v i t) f)).
Print Assumptions tanner1_heading.gyro_kinetic.

(* tanner1.propIV3b *)
Check (tanner1_examples.propIV3b_fails :
  (forall t : R, closed_loop 2 complete (fun _ _ : nat => Vh') r_osc s_osc (fun (_ : nat) (_ : R) => 0) t) /\
       (forall s : R, 0 < s -> 0 <= Vh s /\ (Vh s = 0 <-> s = 2)) /\
       (forall m : nat,
        norm (r_osc 0 (INR m * PI) - r_osc 1 (INR m * PI))%C = 5 / 2 /\
        Vh (norm (r_osc 0 (INR m * PI) - r_osc 1 (INR m * PI))%C) = 1 / 4)).
Print Assumptions tanner1_examples.propIV3b_fails.
