(* What is proved for Chazelle's paper, written out again, with the axioms of each theorem.
   The definitions the statements use are restated first. *)
From mathcomp Require all_ssreflect all_algebra.
From Coq Require Reals QArith Qabs.
From Coquelicot Require Coquelicot.
From Flockproof Require RealSums chazelle_model chazelle_ergodicity chazelle_products chazelle_fixed chazelle_network chazelle_sharp
  chazelle_limits chazelle_spectral chazelle_eigenvalues chazelle_stabilisers chazelle_birds chazelle_worked chazelle_angle
  chazelle_recurrent chazelle_agreement chazelle_contraction chazelle_count chazelle_bits chazelle_reals
  chazelle_entries chazelle_switches chazelle_losses chazelle_lower.

Module NumbersAndBirds.
Import Coq.QArith.QArith Coq.QArith.Qabs Coq.Reals.Reals Coquelicot.Coquelicot.

(* the four birds: the distance rule, the hysteresis rule, the matrix of a network, the motion *)
Section Birds.
Import chazelle_birds.
Check (fun x i j => eq_refl : near x i j = (negb (Nat.eqb i j) && Qle_bool (Qabs (x i - x j)) 1)%bool).
Check (fun e H y x i j => eq_refl : hysteresis e H y x i j
  = (near x i j || H i j && negb (Qle_bool e (Qabs (Qabs (x i - x j) - Qabs (y i - y j)))))%bool).
Check (fun H i j => eq_refl : P H i j =
  if Nat.eqb i j then (if Nat.eqb (deg H i) 0 then 1 else 1#3)
  else if H i j then (2#3) / inject_Z (Z.of_nat (deg H i)) else 0).
Check (motion_x : forall rule t i, (x rule (S t) i = x rule t i + v rule (S t) i)%Q).
Check (motion_v : forall rule t i, v rule (S (S t)) i = mulv (P (G rule (S t))) (v rule (S t)) i).
Check (motion_G : forall rule t, G rule (S t) = rule (G rule t) (x rule t) (x rule (S t))).
Check (eq_refl : x0 = vec4 (0#16) (8#16) (21#16) (29#16)).
Check (eq_refl : v1 = vec4 (1#8) (-1#8) (1#8) (-1#8)).
Check (eq_refl : eps = (/ inject_Z (4 ^ (4 ^ 4)))%Q).
Check (fun t => eq_refl : r (S t) = (- (1#3) * r t)%Q).
End Birds.
(* chazelle.epsineq (claim) *)
Check (@chazelle_worked.eps_inequality :
  forall nu : nat, (1 <= nu)%nat -> exp (- INR (nu ^ nu ^ 2)) < / INR nu ^ nu ^ 4).
(* chazelle.eq3.15 (part) *)
Check (@chazelle_worked.angle_bounds :
  forall (d : nat) (v w : nat -> R) (B : R),
  0 < chazelle_worked.norm d (chazelle_worked.diff v w) ->
  chazelle_worked.norm d v <= B ->
  chazelle_worked.norm d w <= B ->
  / (1 + B ^ 2) <= chazelle_worked.angle d v w / chazelle_worked.norm d (chazelle_worked.diff v w) <= 5 / 2).
(* beyond.chazelle.angle, clause 1: the angle of (x, t) and (v, 1) in R^(d+1) *)
Check (eq_refl : chazelle_angle.lifted = fun d x h k => if Nat.eqb k d then h else x k).
Check (@chazelle_angle.lifted_birds :
  forall (d : nat) (x v : nat -> R) (t : R), 0 < t ->
  acos (chazelle_worked.dotp (S d) (chazelle_angle.lifted d x t) (chazelle_angle.lifted d v 1) /
    (chazelle_worked.norm (S d) (chazelle_angle.lifted d x t) * chazelle_worked.norm (S d) (chazelle_angle.lifted d v 1))) <=
    chazelle_worked.norm d (fun k => v k - x k / t) /\
  chazelle_worked.norm d (fun k => v k - x k / t) = chazelle_worked.norm d (fun k => x k - t * v k) / t).
(* chazelle.eq3.15 from above, with the best constant *)
Check (@chazelle_angle.angle_le :
  forall (d : nat) (v w : nat -> R),
  acos ((chazelle_worked.dotp d v w + 1) / (sqrt (chazelle_worked.dotp d v v + 1) * sqrt (chazelle_worked.dotp d w w + 1))) <=
  sqrt (chazelle_worked.dotp d (fun k => 1 * v k + (-1) * w k) (fun k => 1 * v k + (-1) * w k))).
(* chazelle.ex15 (claim) *)
Check (@chazelle_worked.ex15 :
  (forall lam : R,
   (exists x y : R, (x <> 0 \/ y <> 0) /\ chazelle_worked.P15 x y = (lam * x, lam * y)) <->
   lam = 1 \/ lam = 2 / 15) /\
  Rabs (2 / 15 - 0.133) < 0.0005 /\
  Rabs (sqrt (fst (chazelle_worked.P15 1 0) ^ 2 + snd (chazelle_worked.P15 1 0) ^ 2) - 1.041) < 0.0005 /\
  fst (chazelle_worked.P15 1 (-1)) + snd (chazelle_worked.P15 1 (-1)) <> 0 /\
  (forall x y : R, x <> 0 \/ y <> 0 -> chazelle_worked.P15 x y = (2 / 15 * x, 2 / 15 * y) -> x + y <> 0)).
(* chazelle.ex4birds.alt (claim) *)
Check (@chazelle_birds.alternates :
  (forall t i j : nat,
   (i < 4)%nat ->
   (j < 4)%nat ->
   chazelle_birds.G chazelle_birds.distance_rule t i j =
   (if Nat.even t then chazelle_birds.path4 i j else chazelle_birds.pairs4 i j)) /\
  ~
  (exists T : nat,
     forall t i j : nat,
     (T <= t)%nat ->
     (i < 4)%nat ->
     (j < 4)%nat ->
     chazelle_birds.G chazelle_birds.distance_rule t i j = chazelle_birds.G chazelle_birds.distance_rule T i j)).
(* chazelle.ex4birds.eig (claim) *)
Check (@chazelle_birds.eigenvector :
  forall i : nat,
  (i < 4)%nat ->
  chazelle_birds.mulv chazelle_birds.M2 chazelle_birds.v1 i == - (1 # 3) * chazelle_birds.v1 i /\
  chazelle_birds.mulv chazelle_birds.M4 chazelle_birds.v1 i == - (1 # 3) * chazelle_birds.v1 i).
(* chazelle.ex4birds.eq3.14 (claim) *)
Check (@chazelle_birds.eq_3_14 :
  forall t : nat,
  (forall i : nat,
   (i < 4)%nat ->
   chazelle_birds.x chazelle_birds.distance_rule t i ==
   chazelle_birds.x0 i + (3 # 4) * (1 - chazelle_birds.r t) * chazelle_birds.v1 i) /\
  (chazelle_birds.x chazelle_birds.distance_rule (S t) 1%nat -
   chazelle_birds.x chazelle_birds.distance_rule (S t) 0%nat == 0x0.1%xQ * (5 - chazelle_birds.r t) /\
   chazelle_birds.x chazelle_birds.distance_rule (S t) 3%nat -
   chazelle_birds.x chazelle_birds.distance_rule (S t) 2%nat == 0x0.1%xQ * (5 - chazelle_birds.r t)) /\
  chazelle_birds.x chazelle_birds.distance_rule (S t) 2%nat -
  chazelle_birds.x chazelle_birds.distance_rule (S t) 1%nat == 1 + 0x0.1%xQ * chazelle_birds.r t /\
  (1 # 4 <= 0x0.1%xQ * (5 - chazelle_birds.r t) <= 1 # 2)%Q).
(* chazelle.exAB (claim) *)
Check (@chazelle_worked.exAB :
  forall m i j : nat,
  (1 <= m)%nat ->
  (i < 3)%nat ->
  (j < 3)%nat ->
  chazelle_worked.product (2 * m) i j =
  chazelle_worked.mat3 ((1 / 2) ^ m) (1 - 2 * (1 / 2) ^ m) ((1 / 2) ^ m) 0 1 0 0 1 0 i j).
(* chazelle.hyst (part) *)
Check (@chazelle_birds.existing_edge_stays :
  forall (e : Q) (H : nat -> nat -> bool) (y z : nat -> Q) (i j : nat),
  H i j = true ->
  (Qabs (Qabs (z i - z j) - Qabs (y i - y j)) < e)%Q -> chazelle_birds.hysteresis e H y z i j = true).
(* chazelle.hyst (part) *)
Check (@chazelle_birds.only_these :
  forall (e : Q) (H : chazelle_birds.network) (y z : chazelle_birds.vec) (i j : nat),
  chazelle_birds.hysteresis e H y z i j = true ->
  i <> j /\ (Qabs (z i - z j) <= 1)%Q \/ H i j = true /\ (Qabs (Qabs (z i - z j) - Qabs (y i - y j)) < e)%Q).
(* chazelle.hyst (part) *)
Check (@chazelle_birds.last_switch :
  (forall t : nat,
   (t < 322)%nat ->
   chazelle_birds.G (chazelle_birds.hysteresis chazelle_birds.eps) t 1%nat 2%nat <>
   chazelle_birds.G (chazelle_birds.hysteresis chazelle_birds.eps) (S t) 1%nat 2%nat) /\
  (forall t i j : nat,
   (322 <= t)%nat ->
   (i < 4)%nat ->
   (j < 4)%nat ->
   chazelle_birds.G (chazelle_birds.hysteresis chazelle_birds.eps) t i j = chazelle_birds.path4 i j)).
End NumbersAndBirds.

Module Matrices.
Import all_ssreflect all_algebra.
Import chazelle_model chazelle_ergodicity chazelle_products chazelle_fixed chazelle_network chazelle_sharp chazelle_limits chazelle_spectral
  chazelle_stabilisers chazelle_recurrent chazelle_agreement chazelle_contraction chazelle_count chazelle_bits.
Import GRing.Theory Num.Theory Order.Theory.
Local Open Scope ring_scope.

(* the model: L, P = I - C L, the condition of model D, products, footprints, tau_1, tau_2, pi, Gamma *)
Section Definitions.
Variables (R : realFieldType) (n : nat) (G : rel 'I_n) (c : 'I_n -> R).
Check (erefl : network G = (symmetric G /\ irreflexive G)).
Check (erefl : transition G c = 1%:M - diag_mx (\row_i c i) *m laplacian R G).
Check ((fun i j => mxE _ _ _ _) : forall i j, laplacian R G i j = if i == j then (degree G i)%:R else if G i j then -1 else 0).
Check (erefl : model_D G c = forall i, (0 < degree G i)%N -> 0 < c i * (degree G i)%:R < 1).
Check (erefl : stochastic (transition G c)
  = ((forall i k, 0 <= transition G c i k) /\ (forall i, \sum_k transition G c i k = 1))).
Check (fun (P : nat -> 'M[R]_n) s k => erefl : span P s k.+1 = P (s + k)%N *m span P s k).
Check (fun (A : 'M[R]_n) i j => erefl : footprint A i j = (A i j != 0)).
Check (fun (A : 'M[R]_n) => erefl : tau1 A
  = \big[Num.max/0]_(ij : 'I_n * 'I_n) (2%:R^-1 * \sum_k `|A ij.1 k - A ij.2 k|)).
Check (fun i => erefl : stat c i = (\sum_k (c k)^-1)^-1 * (c i)^-1).
Check (fun f i => erefl : step G c f i = \sum_j transition G c i j * f j).
Check (fun (A : 'M[R]_n) s => erefl : mpow A s.+1 = A *m mpow A s).
End Definitions.
(* windows of time; blocks of a matrix; products of blocks; completeness *)
Section Windows.
Variables (R : realFieldType) (n : nat) (P : nat -> 'M[R]_n) (G : nat -> rel 'I_n).
Check (fun s k i j => erefl : window P s k i j = [exists u : 'I_k, P (s + u)%N i j != 0]).
Check (fun H => erefl : rooted H = exists r : 'I_n, forall i, connect H i r).
Check (fun s k i j => erefl : union G s k i j = [exists u : 'I_k, G (s + u)%N i j]).
Check (fun s => erefl : connected_windows G s [::] = True).
Check (fun s k ks => erefl : connected_windows G s (k :: ks) =
  ((forall i j, connect (union G s k) i j) /\ connected_windows G (s + k)%N ks)).
Check ((fun V W A i j => mxE _ _ _ _) : forall (V W : {set 'I_n}) (A : 'I_n -> 'I_n -> R) i j,
  restrict V W A i j = A (enum_val i) (enum_val j)).
Check (fun V s k i j => erefl : block P V s k.+1 i j = \sum_(l in V) P (s + k)%N i l * block P V s k l j).
Check (fun t s => erefl : pprod P t s = span P s (t - s).+1).
Check (fun d (N : 'rV[R]_d -> R) m (A : 'M[R]_(m, d)) => erefl : diameter N A
  = \big[Num.max/0]_(ij : 'I_m * 'I_m) N (row ij.1 A - row ij.2 A)).
Check (fun (K : archiFieldType) d (v : nat -> 'M[K]_(n, d)) l => erefl : extent v l
  = \big[Num.max/0]_(ij : 'I_n * 'I_n) `|(row ij.1 (v 1%N) - row ij.2 (v 1%N)) 0 l|).
Check (erefl : complete R = forall a : nat -> R,
  (forall eps, 0 < eps -> exists T, forall t u, (T < t)%N -> (T < u)%N -> `|a t - a u| <= eps) ->
  exists l, forall eps, 0 < eps -> exists T, forall t, (T < t)%N -> `|a t - l| <= eps).
End Windows.
(* a flock on the line with hysteresis; the changes of its network *)
Section Switches.
Variables (R : realFieldType) (n : nat) (G : nat -> rel 'I_n).
Check (fun (eps : R) x v c => erefl : line_flock eps x v G c =
  [/\ forall i j, G 0%N i j = (i != j) && (`|x 0%N i 0 - x 0%N j 0| <= 1),
      forall t i j, G t.+1 i j = (i != j) && ((`|x t.+1 i 0 - x t.+1 j 0| <= 1) ||
        (G t i j && (`| `|x t.+1 i 0 - x t.+1 j 0| - `|x t i 0 - x t j 0| | < eps))),
      forall t, model_D (G t) (c t),
      forall t, x t.+1 = x t + v t.+1 &
      forall t, (0 < t)%N -> v t.+1 = transition (G t) (c t) *m v t]).
Check (fun u => erefl : changes G u = [exists i, exists j, G u i j != G u.-1 i j]).
Check (fun c t s => erefl : chazelle_stabilisers.N c t s = count c (iota s.+1 (t - s))).
End Switches.
Section Limits.
Variables (R : realFieldType) (m : nat) (G : rel 'I_m.+1) (c : 'I_m.+1 -> R).
Check (fun t => erefl : Gamma_t G c t = \sum_(s < t) mpow (transition G c) s - rank1 c *+ t).
Check (erefl : Gamma G c = last_col (1%:M - rank1 c) 0 *m invmx (last_col (1%:M - transition G c) (ones R m))).
Check (rank1E : forall (R : realFieldType) m (c : 'I_m.+1 -> R) i j, rank1 c i j = stat c j).
Check (fun (Y : 'M[R]_m.+1) y i j => mxE _ _ _ _ : last_col Y y i j = if j == ord_max then y i 0 else Y i j).
Check (fun (A : nat -> 'M[R]_m.+1) B => erefl : converges A B =
  forall eps : R, 0 < eps -> exists T, forall t, (T <= t)%N -> forall i j, `|A t i j - B i j| < eps).
Check bordered_unit.
End Limits.
Section Lengths.
Variables (R : realFieldType) (n d : nat).
Check (fun a (c : 'I_n -> R) => erefl : short_weights a c = exists p q : 'I_n -> nat,
  forall i, [/\ c i = (p i)%:R / (q i)%:R, (0 < q i)%N & (q i <= n ^ a)%N]).
Check (fun b (y : 'M[R]_(n, d)) => erefl : short_input b y = exists (z : 'I_n -> 'I_d -> int) (q : 'I_n -> 'I_d -> nat),
  forall i k, [/\ y i k = (z i k)%:~R / (q i k)%:R, (0 < q i k)%N, (q i k <= n ^ b)%N & (`|z i k| <= n ^ b)%N]).
End Lengths.
Section Euclid.
Variables (R : rcfType) (p : nat).
Check (fun x : 'rV[R]_p => erefl : norm2 x = Num.sqrt (\sum_k x 0 k ^+ 2)).
Check (fun m (A : 'M[R]_(m, p)) => erefl : tau2 A
  = \big[Num.max/0]_(ij : 'I_m * 'I_m) norm2 (row ij.1 A - row ij.2 A)).
End Euclid.

(* chazelle.Nts (corrected) *)
Check (@chazelle_stabilisers.N_corrected :
  forall (c : nat -> bool) (t : nat -> nat) (l : nat),
  (forall k : nat, (t k <= t k.+1)%N) ->
  (forall k : nat, t k.+1 = (t k).+1 -> (N c (t k.+1) (t k) <= 1)%N) /\
  N c (t l) (t 0%N) = (\sum_(1 <= k < l.+1) N c (t k) (t k.-1))%N).
(* chazelle.Nts (negation) *)
Check (@chazelle_stabilisers.N_printed_step :
  forall (c : nat -> bool) (t : nat), N_printed c t.+1 t = 0%N).
(* chazelle.chi (corrected) *)
Check (@chazelle_model.chi_difference :
  forall (R : realFieldType) (n : nat) (P : nat -> 'M_n) (d : nat) (v : nat -> 'M_(n, d)) (i j : 'I_n) (k : nat),
  (forall t : nat, (0 < t)%N -> v t.+1 = P t *m v t) ->
  row i (v k.+1) - row j (v k.+1) = chi R i j *m span P 1 k *m v 1%N).
(* chazelle.chi (negation) *)
Check (@chazelle_model.chi_printed_impossible :
  forall (R : realFieldType) (n : nat) (i : 'I_n) (chi : 'rV_n), chi 0 i = 1 -> chi 0 i = -1 -> False).
(* chazelle.eq2.3 (claim) *)
Check (@chazelle_ergodicity.velocity_polynomial :
  forall (R : rcfType) (n d b : nat) (P : nat -> 'M_n) (v : nat -> 'M_(n, d)) (t : nat),
  (forall t0 : nat, stochastic (P t0)) ->
  (forall t0 : nat, (0 < t0)%N -> v t0.+1 = P t0 *m v t0) ->
  (0 < t)%N ->
  (forall (i : 'I_n) (k : 'I_d), `|v 1%N i k| <= n%:R ^+ b) ->
  length (v t) <= Num.sqrt (n%:R * d%:R) * n%:R ^+ b).
(* chazelle.eq3.10 (part) *)
Check (@chazelle_network.eq_3_10 :
  forall (R : realFieldType) (n : nat) (G : rel 'I_n) (c : 'I_n -> R),
  network G ->
  model_D G c ->
  (forall i j : 'I_n, connect G i j) ->
  (forall i : 'I_n, 0 < c i) ->
  forall a : nat,
  (1 < n)%N ->
  (forall i : 'I_n, n%:R ^- a <= c i) ->
  (forall i : 'I_n, n%:R ^- a <= transition G c i i) ->
  forall s : nat,
  (n ^ (3 * a + 6) < s)%N ->
  tau1 (mpow (transition G c) s) <= 1 - \sum_k (stat c k - n%:R ^+ a * (1 - n%:R ^- (2 * a + 4)) ^+ s) /\
  1 - \sum_k (stat c k - n%:R ^+ a * (1 - n%:R ^- (2 * a + 4)) ^+ s) < 2^-1).
(* chazelle.eq3.12-13 (claim) *)
Check (@chazelle_limits.eq_3_12_13 :
  forall (R : realFieldType) (m : nat) (G : rel 'I_m.+1) (c : 'I_m.+1 -> R) (d : nat)
    (x v : nat -> 'M_(m.+1, d)) (t : nat),
  (forall t0 : nat, x t0.+1 = x t0 + v t0.+1) ->
  (forall t0 : nat, (0 < t0)%N -> v t0.+1 = transition G c *m v t0) ->
  x t = x 0%N + (\sum_(s < t) mpow (transition G c) s) *m v 1%N /\
  x t = x 0%N + rank1 c *m v 1%N *+ t + Gamma_t G c t *m v 1%N).
(* chazelle.eq3.16 (corrected) *)
Check (@chazelle_spectral.eq_3_16 :
  forall (R : rcfType) (m : nat) (G : rel 'I_m.+1) (c : 'I_m.+1 -> R),
  network G ->
  model_D G c ->
  (forall i j : 'I_m.+1, connect G i j) ->
  (forall i : 'I_m.+1, 0 < c i) ->
  forall (U : 'M_m.+1) (lam : 'I_m.+1 -> R),
  U^T *m U = 1%:M ->
  (forall i k : 'I_m.+1, \sum_j M G c i j * U j k = lam k * U i k) ->
  (forall i : 'I_m.+1, U i 0 = u1 c i) ->
  lam 0 = 1 ->
  forall (d : nat) (x v : nat -> 'M_(m.+1, d)) (t1 : nat),
  (forall t : nat, (t1 <= t)%N -> x t.+1 = x t + v t.+1) ->
  (forall t : nat, (t1 < t)%N -> v t.+1 = transition G c *m v t) ->
  forall (tau : nat) (i : 'I_m.+1) (q : 'I_d),
  x (t1 + tau)%N i q =
  x t1 i q + (Gamma G c *m v t1.+1) i q + drift c v t1 q *+ tau -
  \sum_(k | k != 0) lam k ^+ tau * (Phi c U v t1 i k q / (1 - lam k))).
(* chazelle.eq3.17 (part) *)
Check (@chazelle_spectral.eq_3_17 :
  forall (R : rcfType) (d t1 tau : nat) (q : 'I_d) (m : nat) (G : rel 'I_m.+1) (c : 'I_m.+1 -> R)
    (U : 'M_m.+1) (lam : 'I_m.+1 -> R) (x v : nat -> 'M_(m.+1, d)) (i : 'I_m.+1) (m' : nat) 
    (G' : rel 'I_m'.+1) (c' : 'I_m'.+1 -> R) (U' : 'M_m'.+1) (lam' : 'I_m'.+1 -> R)
    (x' v' : nat -> 'M_(m'.+1, d)) (i' : 'I_m'.+1),
  network G ->
  model_D G c ->
  (forall a b : 'I_m.+1, connect G a b) ->
  (forall a : 'I_m.+1, 0 < c a) ->
  U^T *m U = 1%:M ->
  (forall a k : 'I_m.+1, \sum_b M G c a b * U b k = lam k * U a k) ->
  (forall a : 'I_m.+1, U a 0 = u1 c a) ->
  lam 0 = 1 ->
  (forall t : nat, (t1 <= t)%N -> x t.+1 = x t + v t.+1) ->
  (forall t : nat, (t1 < t)%N -> v t.+1 = transition G c *m v t) ->
  network G' ->
  model_D G' c' ->
  (forall a b : ordinal_finType m'.+1, connect G' a b) ->
  (forall a : 'I_m'.+1, 0 < c' a) ->
  U'^T *m U' = 1%:M ->
  (forall a k : 'I_m'.+1, \sum_b M G' c' a b * U' b k = lam' k * U' a k) ->
  (forall a : 'I_m'.+1, U' a 0 = u1 c' a) ->
  lam' 0 = 1 ->
  (forall t : nat, (t1 <= t)%N -> x' t.+1 = x' t + v' t.+1) ->
  (forall t : nat, (t1 < t)%N -> v' t.+1 = transition G' c' *m v' t) ->
  let A := x t1 i q - x' t1 i' q + ((Gamma G c *m v t1.+1) i q - (Gamma G' c' *m v' t1.+1) i' q) in
  let B := drift c v t1 q - drift c' v' t1 q in
  x (t1 + tau)%N i q - x' (t1 + tau)%N i' q =
  A + B *+ tau -
  (\sum_(k | k != 0) Phi c U v t1 i k q / (1 - lam k) * lam k ^+ tau +
   \sum_(k | k != 0) - (Phi c' U' v' t1 i' k q / (1 - lam' k)) * lam' k ^+ tau)).
(* chazelle.eq3.5 (corrected) *)
Check (@chazelle_stabilisers.eq_3_5 :
  forall (R : realFieldType) (n : nat) (P : nat -> 'M_n),
  (forall t : nat, stochastic (P t)) ->
  (forall (t : nat) (i : 'I_n), 0 < P t i i) ->
  (forall (t : nat) (i j : 'I_n), (P t i j != 0) = (P t j i != 0)) ->
  forall (b : 'I_n) (T : nat -> nat) (V : nat -> {set 'I_n}),
  V 0%N = [set: 'I_n] ->
  (forall k : nat, (T k < T k.+1)%N) ->
  (forall (k : nat) (i : 'I_n),
   (i \in V k.+1) = (i \in V k) && (block P (V k) (T k).+1 (T k.+1 - T k) i b != 0)) ->
  (forall (k t : nat) (i : 'I_n),
   (T k.+1 <= t)%N -> i \in V k -> block P (V k) (T k).+1 (t - T k) i b != 0 -> i \in V k.+1) ->
  forall (k u : nat) (i : 'I_n) (j : 'I_n),
  i \in V k ->
  span P (T 0%N).+1 (T k - T 0%N + u) i j = \sum_(l in V k) block P (V k) (T k).+1 u i l * tower P T V k l j).
(* chazelle.eq3.6 (part) *)
Check (@chazelle_contraction.eq_3_6 :
  forall (R : rcfType) (n a : nat) (G : nat -> rel 'I_n) (c : nat -> 'I_n -> R) (b : 'I_n)
    (T : nat -> nat) (V : nat -> {set 'I_n}),
  (forall t, network (G t)) ->
  (forall t, model_D (G t) (c t)) ->
  let P := fun t => transition (G t) (c t) in
  (forall t i j, P t i j != 0 -> n%:R ^- a <= P t i j) ->
  V 0%N = [set: 'I_n] ->
  (forall k, (T k < T k.+1)%N) ->
  (forall k i, (i \in V k.+1) = (i \in V k) && (block P (V k) (T k).+1 (T k.+1 - T k) i b != 0)) ->
  (forall k t i, (T k.+1 <= t)%N -> i \in V k -> block P (V k) (T k).+1 (t - T k) i b != 0 -> i \in V k.+1) ->
  forall k t, (T k < t)%N ->
  tau2 (restrict (V k) (V 0%N) (fun i j => pprod P t (T 0%N).+1 i j)) <=
    Num.sqrt 2%:R * (tau1 (restrict (V k) (V k) (fun i j => pprod P t (T k).+1 i j)) *
      \prod_(i < k) tau1 (restrict (V i.+1) (V i) (block P (V i) (T i).+1 (T i.+1 - T i)))) /\
  Num.sqrt 2%:R * (tau1 (restrict (V k) (V k) (fun i j => pprod P t (T k).+1 i j)) *
      \prod_(i < k) tau1 (restrict (V i.+1) (V i) (block P (V i) (T i).+1 (T i.+1 - T i)))) <=
    Num.sqrt 2%:R * (1 - n%:R ^- (a * n.-1)) ^+ k).
(* chazelle.eq3.7 (part) *)
Check (@chazelle_spectral.eq_3_7 :
  forall (R : rcfType) (m : nat) (G : rel 'I_m.+1) (c : 'I_m.+1 -> R),
  network G ->
  model_D G c ->
  (forall i j : 'I_m.+1, connect G i j) ->
  (forall i : 'I_m.+1, 0 < c i) ->
  [/\ forall i j : 'I_m.+1, M G c i j = (i == j)%:R - Num.sqrt (c i) * laplacian R G i j * Num.sqrt (c j),
      forall i j : 'I_m.+1, M G c i j = M G c j i,
      (forall i : 'I_m.+1, \sum_j M G c i j * u1 c j = u1 c i) /\ \sum_i u1 c i ^+ 2 = 1,
      forall (lam : R) (f : 'I_m.+1 -> R),
      (forall i : 'I_m.+1, \sum_j M G c i j * f j = lam * f i) <->
      (forall i : 'I_m.+1, step G c (fun j : 'I_m.+1 => Num.sqrt (c j) * f j) i = lam * (Num.sqrt (c i) * f i))
    & forall (lam : R) (f : 'I_m.+1 -> R),
      (forall i : 'I_m.+1, \sum_j M G c i j * f j = lam * f i) ->
      (exists i : 'I_m.+1, f i != 0) -> lam = 1 \/ -1 < lam < 1]).
(* chazelle.eq3.7, clause 2 *)
Check (@chazelle_eigenvalues.eigenvalues_in_order :
  forall (R : rcfType) (m : nat) (G : rel 'I_m.+1) (c : 'I_m.+1 -> R),
  network G ->
  model_D G c ->
  (forall i j : 'I_m.+1, connect G i j) ->
  (forall i : 'I_m.+1, 0 < c i) ->
  exists lam : 'I_m.+1 -> R,
  [/\ char_poly (M G c) = \prod_k ('X - (lam k)%:P),
      lam ord0 = 1,
      forall k : 'I_m.+1, k != ord0 -> lam k < 1,
      forall j k : 'I_m.+1, (j <= k)%N -> lam k <= lam j
    & forall k : 'I_m.+1, - 1 <= lam k]).
(* chazelle.eq3.8 (part) *)
Check (@chazelle_spectral.eq_3_8 :
  forall (R : rcfType) (m : nat) (G : rel 'I_m.+1) (c : 'I_m.+1 -> R),
  (forall i : 'I_m.+1, 0 < c i) ->
  forall (U : 'M_m.+1) (lam : 'I_m.+1 -> R),
  U^T *m U = 1%:M ->
  (forall i k : 'I_m.+1, \sum_j M G c i j * U j k = lam k * U i k) ->
  (forall i : 'I_m.+1, U i 0 = u1 c i) ->
  lam 0 = 1 ->
  forall (s : nat) (i j : 'I_m.+1),
  mpow (transition G c) s i j =
  stat c j + \sum_(k | k != 0) lam k ^+ s * (Num.sqrt (c i) * (U i k * U j k) / Num.sqrt (c j))).
(* chazelle.eq3.8 (part) *)
Check (@chazelle_spectral.eq_3_8_vectors :
  forall (R : rcfType) (m : nat) (G : rel 'I_m.+1) (c : 'I_m.+1 -> R),
  network G ->
  model_D G c ->
  (forall i j : 'I_m.+1, connect G i j) ->
  (forall i : 'I_m.+1, 0 < c i) ->
  forall (U : 'M_m.+1) (lam : 'I_m.+1 -> R),
  U^T *m U = 1%:M ->
  (forall i k : 'I_m.+1, \sum_j M G c i j * U j k = lam k * U i k) ->
  (forall k i : 'I_m.+1, \sum_j transition G c i j * (Num.sqrt (c j) * U j k) = lam k * (Num.sqrt (c i) * U i k)) /\
  (forall k j : 'I_m.+1,
   \sum_i (Num.sqrt (c i))^-1 * U i k * transition G c i j = lam k * ((Num.sqrt (c j))^-1 * U j k)) /\
  (forall k l : 'I_m.+1, \sum_i (Num.sqrt (c i))^-1 * U i k * (Num.sqrt (c i) * U i l) = (k == l)%:R)).
(* chazelle.eq3.9 (part) *)
Check (@chazelle_network.eq_3_9 :
  forall (R : realFieldType) (n : nat) (G : rel 'I_n) (c : 'I_n -> R),
  network G ->
  model_D G c ->
  (forall i j : 'I_n, connect G i j) ->
  (forall i : 'I_n, 0 < c i) ->
  forall a : nat,
  (1 < n)%N ->
  (forall i : 'I_n, n%:R ^- a <= c i) ->
  (forall i : 'I_n, n%:R ^- a <= transition G c i i) ->
  forall (s : nat) (i j : 'I_n),
  `|mpow (transition G c) s i j - stat c j| <= n%:R ^+ a * (1 - n%:R ^- (2 * a + 4)) ^+ s).
(* beyond.chazelle.recurrent (part) *)
Check (@chazelle_agreement.recurrent_limit :
  forall (R : archiFieldType) (n d : nat) (G : nat -> rel 'I_n) (c : nat -> 'I_n -> R)
    (v : nat -> 'M_(n, d)) (alpha : R),
  complete R ->
  (0 < n)%N ->
  (forall t, network (G t)) ->
  (forall t, model_D (G t) (c t)) ->
  0 < alpha ->
  (forall t i j, transition (G t) (c t) i j != 0 -> alpha <= transition (G t) (c t) i j) ->
  (forall s, exists k, forall i j, connect (union G s k) i j) ->
  (forall t, (0 < t)%N -> v t.+1 = transition (G t) (c t) *m v t) ->
  exists y : 'rV_d, converges (fun t => v t.+1) (\matrix_(i, l) y 0 l)).
(* beyond.chazelle.recurrent (part) *)
Check (@chazelle_agreement.recurrent_velocities :
  forall (R : realFieldType) (n : nat) (G : nat -> rel 'I_n) (c : nat -> 'I_n -> R) (alpha : R),
  (forall t, network (G t)) ->
  (forall t, model_D (G t) (c t)) ->
  let P := fun t => transition (G t) (c t) in
  0 < alpha ->
  (forall t i j, P t i j != 0 -> alpha <= P t i j) ->
  forall (d : nat) (v : nat -> 'M_(n, d)) (N : 'rV_d -> R),
  (forall t, (0 < t)%N -> v t.+1 = P t *m v t) ->
  N 0 = 0 ->
  (forall a x, N (a *: x) = `|a| * N x) ->
  (forall x y, N (x + y) <= N x + N y) ->
  forall (ks : seq nat) (t u : nat) (i j : 'I_n),
  connected_windows G 1 ks ->
  (sumn ks < t)%N ->
  (sumn ks < u)%N ->
  N (row i (v t) - row j (v u)) <= (1 - alpha ^+ n.-1) ^+ (size ks %/ n.-1) * diameter N (v 1%N)).
(* beyond.chazelle.recurrent (part) *)
Check (@chazelle_agreement.velocities_repeatedly_limit :
  forall (R : archiFieldType) (n d : nat) (P : nat -> 'M_n) (v : nat -> 'M_(n, d)) (gamma : R) (B : nat),
  complete R ->
  (forall t, stochastic (P t)) ->
  (forall t i, 0 < P t i i) ->
  0 < gamma ->
  (forall t i j, P t i j != 0 -> gamma <= P t i j) ->
  (forall s, rooted (window P s B)) ->
  (forall t, (0 < t)%N -> v t.+1 = P t *m v t) ->
  exists y : 'rV_d,
    converges (fun t => v t.+1) (\matrix_(i, l) y 0 l) /\
    (forall k t i l, (k < t)%N ->
     `|v t i l - y 0 l| <= (1 - gamma ^+ (n.-1 * B)) ^+ (k %/ (n.-1 * B)) * extent v l)).
(* chazelle.fiedler.rate (corrected) *)
Check (@chazelle_network.fiedler_rate :
  forall (R : rcfType) (n : nat) (G : rel 'I_n),
  network G ->
  (forall i j : 'I_n, connect G i j) ->
  (forall (lam : R) (f : 'I_n -> R),
   (forall i : 'I_n, \sum_j laplacian R G i j * f j = lam * f i) ->
   (exists i : 'I_n, f i != 0) -> lam != 0 -> 1 <= lam * (n * n.-1 ^ 2)%:R) /\
  (forall (d a : nat) (c : 'I_n -> R) (v : nat -> 'M_(n, d)) (N : 'rV[R]_d -> R) (t : nat) (i j : 'I_n),
   N 0 = 0 -> (forall b y, N (b *: y) = `|b| * N y) -> (forall y z, N (y + z) <= N y + N z) ->
   model_D G c ->
   (forall i0 : 'I_n, 0 < c i0) ->
   (1 < n)%N ->
   (forall i0 : 'I_n, n%:R ^- a <= c i0) ->
   (forall i0 : 'I_n, n%:R ^- a <= transition G c i0 i0) ->
   (forall t0 : nat, (0 < t0)%N -> v t0.+1 = transition G c *m v t0) ->
   N (row i (v t.+1) - row j (v t.+1)) <= n%:R ^+ a.+1 * 2^-1 ^+ (t %/ n ^ (2 * a + 4)) * diameter N (v 1%N))).
(* chazelle.fiedler.rate, corrected, clause 1: 0 is simple, and every other eigenvalue of the Laplacian is at least 4/(n (n-1)) *)
Check (@chazelle_sharp.fiedler_sharp :
  forall (R : realFieldType) (n : nat) (G : rel 'I_n),
  network G -> (forall i j, connect G i j) ->
  (forall f : 'I_n -> R, (forall i, \sum_j laplacian R G i j * f j = 0) <-> exists c, forall i, f i = c) /\
  forall (lam : R) (f : 'I_n -> R), (forall i, \sum_j laplacian R G i j * f j = lam * f i) -> (exists i j, f i != f j) ->
  4%:R <= lam * (n * n.-1)%:R).

(* chazelle.fiedler.rate, corrected, clause 3: differences are at most n 2^(-t/n^3) times the largest of the first ones, both sides
   to the power n^3 *)
Check (@chazelle_sharp.lazy_vicsek_rate :
  forall (R : rcfType) (n d : nat) (G : rel 'I_n) (c : 'I_n -> R) (v : nat -> 'M[R]_(n, d)) (N : 'rV[R]_d -> R) (t : nat) (i j : 'I_n),
  N 0 = 0 -> (forall b y, N (b *: y) = `|b| * N y) -> (forall y z, N (y + z) <= N y + N z) ->
  network G -> (forall i j, connect G i j) -> (1 < n)%N ->
  (forall i, c i = 2%:R / (3 * degree G i)%:R) \/ (forall i, c i = (degree G i).+1%:R^-1) ->
  (forall t, (0 < t)%N -> v t.+1 = transition G c *m v t) ->
  N (row i (v t.+1) - row j (v t.+1)) ^+ (n ^ 3) * 2%:R ^+ t <= (n%:R * diameter N (v 1%N)) ^+ (n ^ 3)).
(* beyond.chazelle.angle, clause 2: coordinate q of x_i(t) - t v_i(t), M at least every |x_j(0)| in that coordinate; the switches
   counted are those at the times 2, .., t - 1 *)
Check (@chazelle_losses.origins_stay :
  forall (R : rcfType) (n d a : nat) (G : nat -> rel 'I_n) (c : nat -> 'I_n -> R) (x v : nat -> 'M[R]_(n, d)),
  (forall t, (0 < t)%N -> network (G t)) -> (forall t, (0 < t)%N -> model_D (G t) (c t)) -> (0 < a)%N ->
  (forall t i j, (0 < t)%N -> 0 < transition (G t) (c t) i j -> (n%:R ^+ a)^-1 <= transition (G t) (c t) i j) ->
  (forall t, (0 < t)%N -> (forall i j, G t.+1 i j = G t i j) -> forall i, c t.+1 i = c t i) ->
  (forall t, x t.+1 = x t + v t.+1) -> (forall t, (0 < t)%N -> v t.+1 = transition (G t) (c t) *m v t) ->
  forall T : nat,
  (forall t i j, (0 < t < T)%N -> G t i j -> norm2 (row i (x t) - row j (x t)) <= 2%:R) ->
  forall (q : 'I_d) (t : nat) (i : 'I_n) (M : R), (0 < t <= T)%N -> (forall j, `|x 0%N j q| <= M) ->
  `|x t i q - t%:R * v t i q| <=
    M + 4%:R * (chazelle_stabilisers.N (changes G) t.-1 1).+1%:R * n%:R ^+ (2 * a + 3)).
(* beyond.chazelle.entries (part) *)
Check (@chazelle_entries.smallest_entries :
  forall (R : realFieldType) (n : nat) (G : nat -> rel 'I_n) (s t : nat) (i j : 'I_n),
  (forall u, network (G u)) ->
  (s <= t)%N ->
  (let P u := transition (G u) (fun k => (degree (G u) k).+1%:R^-1 : R) in
   pprod P t s i j != 0 -> (n`!)%:R^-1 <= pprod P t s i j) /\
  ((1 < n)%N ->
   let P u := transition (G u) (fun k => 2%:R / (3%:R * (degree (G u) k)%:R) : R) in
   pprod P t s i j != 0 -> 2%:R ^+ (n - 2) / (3%:R ^+ n.-1 * (n.-1)`!%:R) <= pprod P t s i j)).
(* beyond.chazelle.entries (part) *)
Check (@chazelle_entries.smallest_entries_occur :
  forall (R : realFieldType) (n : nat),
  (1 < n)%N ->
  exists G : nat -> rel 'I_n,
  (forall u, network (G u)) /\
  (exists i j : 'I_n, pprod (fun u => transition (G u) (fun k => (degree (G u) k).+1%:R^-1 : R)) (n - 2) 0 i j = (n`!)%:R^-1) /\
  (exists i j : 'I_n, pprod (fun u => transition (G u) (fun k => 2%:R / (3%:R * (degree (G u) k)%:R) : R)) (n - 2) 0 i j =
     2%:R ^+ (n - 2) / (3%:R ^+ n.-1 * (n.-1)`!%:R))).
(* beyond.chazelle.switches, chazelle.lem3.1, chazelle.thm1.1.switches: birds are rows of x(t) and v(t); the networks are determined by the
   rule; `N (changes G) t 1` is the number of u with 1 < u <= t and G_u other than G_(u-1) *)
Section Switches.
Variables (R : rcfType) (n d : nat).
Check (fun (eps : R) (x v : nat -> 'M[R]_(n, d)) (G : nat -> rel 'I_n) (w : nat -> 'I_n -> R) => erefl :
  chazelle_switches.flock eps x v G w =
  [/\ forall i j, G 0%N i j = (i != j) && (norm2 (row i (x 0%N) - row j (x 0%N)) <= 1),
      forall t i j, G t.+1 i j = (i != j) && ((norm2 (row i (x t.+1) - row j (x t.+1)) <= 1) ||
        (G t i j && (`|norm2 (row i (x t.+1) - row j (x t.+1)) - norm2 (row i (x t) - row j (x t))| < eps))),
      forall t, model_D (G t) (w t),
      forall t, x t.+1 = x t + v t.+1 &
      forall t, (0 < t)%N -> v t.+1 = transition (G t) (w t) *m v t]).
Check (fun (G : nat -> rel 'I_n) u => erefl : changes G u = [exists i, exists j, G u i j != G u.-1 i j]).
Check (fun (G : nat -> rel 'I_n) (S : {set 'I_n}) u => erefl :
  chazelle_switches.changes_in G S u = [exists i in S, exists j in S, G u i j != G u.-1 i j]).
End Switches.
Check (fun c t s => erefl : chazelle_stabilisers.N c t s = count c (iota s.+1 (t - s))).
Check (@chazelle_switches.switches :
  forall (R : rcfType) (n d a c : nat) (x v : nat -> 'M[R]_(n, d)) (G : nat -> rel 'I_n) (w : nat -> 'I_n -> R),
  (2 <= n)%N ->
  chazelle_switches.flock (n%:R ^- (n ^ 4)) x v G w ->
  (forall t i j, transition (G t) (w t) i j != 0 -> n%:R ^- a <= transition (G t) (w t) i j) ->
  (forall i, norm2 (row i (v 1%N)) <= n%:R ^+ c) ->
  forall t, (chazelle_stabilisers.N (changes G) t 1 <= n ^ (a * (n - 1) ^ 2 + (c + 9) * (n - 1) + 1))%N).
Check (@chazelle_switches.lemma_3_1 :
  forall (R : rcfType) (n d a c : nat) (x v : nat -> 'M[R]_(n, d)) (G : nat -> rel 'I_n) (w : nat -> 'I_n -> R),
  (2 <= n)%N ->
  chazelle_switches.flock (n%:R ^- (n ^ 4)) x v G w ->
  (forall t i j, transition (G t) (w t) i j != 0 -> n%:R ^- a <= transition (G t) (w t) i j) ->
  (forall i, norm2 (row i (v 1%N)) <= n%:R ^+ c) ->
  forall t, (chazelle_stabilisers.N (changes G) t 1 <= n ^ ((a + c + 9) * n ^ 3))%N).
(* beyond.chazelle.losses *)
Check (@chazelle_losses.losses :
  forall (R : rcfType) (n d a : nat) (x v : nat -> 'M[R]_(n, d)) (G : nat -> rel 'I_n) (w : nat -> 'I_n -> R),
  (4 <= n)%N -> (d <= n ^ 2)%N -> (1 <= a <= 2)%N ->
  chazelle_switches.flock (n%:R ^- (n ^ 4)) x v G w ->
  (forall t i j, (0 < t)%N -> 0 < transition (G t) (w t) i j -> n%:R ^- a <= transition (G t) (w t) i j) ->
  (forall t, (0 < t)%N -> (forall i j, G t.+1 i j = G t i j) -> forall i, w t.+1 i = w t i) ->
  (forall i, norm2 (row i (v 1%N)) <= n%:R) -> (forall i q, `|x 0%N i q| <= n%:R) ->
  forall t i j, (n ^ (n ^ 4 + 2 * (n - 1) ^ 2 + 10 * (n - 1) + 17) <= t.+1)%N -> G t i j -> G t.+1 i j).
(* chazelle.lem3.8, lem3.6.ii and lem3.7 (the virtual origins), for weights that are fractions with denominators up to n^a *)
Check (@chazelle_losses.lemma_3_8 :
  forall (R : rcfType) (n d a c : nat) (x v : nat -> 'M[R]_(n, d)) (G : nat -> rel 'I_n) (w : nat -> 'I_n -> R),
  (4 <= n)%N -> (0 < a)%N -> (a + c < n)%N ->
  chazelle_switches.flock (n%:R ^- (n ^ 4)) x v G w ->
  (forall t, (0 < t)%N -> short_weights a (w t)) ->
  (forall t, (0 < t)%N -> (forall i j, G t.+1 i j = G t i j) -> forall i, w t.+1 i = w t i) ->
  (forall i, norm2 (row i (v 1%N)) <= n%:R ^+ c) ->
  (d <= n ^ 2)%N -> (forall i q, `|x 0%N i q| <= n%:R ^+ c) ->
  forall t i j, (n ^ (2 * n ^ 4) <= t.+1)%N -> G t i j -> G t.+1 i j).
Check (@chazelle_losses.lemma_3_6_ii :
  forall (R : rcfType) (n d a c : nat) (x v : nat -> 'M[R]_(n, d)) (G : nat -> rel 'I_n) (w : nat -> 'I_n -> R),
  (4 <= n)%N -> (0 < a)%N -> (a + c < n)%N ->
  chazelle_switches.flock (n%:R ^- (n ^ 4)) x v G w ->
  (forall t, (0 < t)%N -> short_weights a (w t)) ->
  (forall t, (0 < t)%N -> (forall i j, G t.+1 i j = G t i j) -> forall i, w t.+1 i = w t i) ->
  (forall i, norm2 (row i (v 1%N)) <= n%:R ^+ c) ->
  forall t i j, 1 + n%:R ^- (n ^ 3) < norm2 (row i (x t) - row j (x t)) -> ~~ G t i j).
Check (@chazelle_losses.lemma_3_7_origins :
  forall (R : rcfType) (n d a c : nat) (x v : nat -> 'M[R]_(n, d)) (G : nat -> rel 'I_n) (w : nat -> 'I_n -> R),
  (4 <= n)%N -> (0 < a)%N -> (a + c < n)%N ->
  chazelle_switches.flock (n%:R ^- (n ^ 4)) x v G w ->
  (forall t, (0 < t)%N -> short_weights a (w t)) ->
  (forall t, (0 < t)%N -> (forall i j, G t.+1 i j = G t i j) -> forall i, w t.+1 i = w t i) ->
  (forall i, norm2 (row i (v 1%N)) <= n%:R ^+ c) ->
  (d <= n ^ 2)%N -> (forall i q, `|x 0%N i q| <= n%:R ^+ c) ->
  forall t i, (0 < t)%N ->
  norm2 (row i (x t) - t%:R *: row i (v t)) <= n%:R ^+ (a * (n - 1) ^ 2 + (c + 9) * (n - 1) + 2 * a + 10)).
(* chazelle.hyst.remark (part): the count of switches, lem3.6.ii, lem3.7 (the virtual origins) and lem3.8 with a threshold 2^h times smaller, h <= 100 *)
Check (@chazelle_losses.smaller_threshold :
  forall (R : rcfType) (n d a c : nat) (x v : nat -> 'M[R]_(n, d)) (G : nat -> rel 'I_n) (w : nat -> 'I_n -> R),
  (4 <= n)%N -> (0 < a)%N -> (a + c < n)%N ->
  (forall t, (0 < t)%N -> short_weights a (w t)) ->
  (forall t, (0 < t)%N -> (forall i j, G t.+1 i j = G t i j) -> forall i, w t.+1 i = w t i) ->
  (forall i, norm2 (row i (v 1%N)) <= n%:R ^+ c) ->
  forall h, (h <= 100)%N -> chazelle_switches.flock (2%:R ^- h * n%:R ^- (n ^ 4)) x v G w ->
  [/\ forall t, (N (changes G) t 1 <= n ^ (a * (n - 1) ^ 2 + (c + 9) * (n - 1) + 1))%N,
      forall t i j, 1 + n%:R ^- (n ^ 3) < norm2 (row i (x t) - row j (x t)) -> ~~ G t i j &
      (d <= n ^ 2)%N -> (forall i q, `|x 0%N i q| <= n%:R ^+ c) ->
        (forall t i, (0 < t)%N ->
          norm2 (row i (x t) - t%:R *: row i (v t)) <= n%:R ^+ (a * (n - 1) ^ 2 + (c + 9) * (n - 1) + 2 * a + 10)) /\
        forall t i j, (n ^ (2 * n ^ 4) <= t.+1)%N -> G t i j -> G t.+1 i j]).
(* chazelle.lem3.6.i: any threshold, any dimension *)
Check (@chazelle_losses.within_unit :
  forall (R : rcfType) (n d : nat) (eps : R) (x v : nat -> 'M[R]_(n, d)) (G : nat -> rel 'I_n) (w : nat -> 'I_n -> R),
  chazelle_switches.flock eps x v G w -> forall t i j, i != j -> norm2 (row i (x t) - row j (x t)) <= 1 -> G t i j).
(* chazelle.lem3.1.count (corrected) *)
Check (@chazelle_switches.count_corrected :
  forall (R : realFieldType) (n : nat) (G : nat -> rel 'I_n) (P : nat -> 'M[R]_n) (b : 'I_n) (T : nat -> nat)
    (V : nat -> {set 'I_n}),
  (forall t, network (G t)) ->
  (forall t, stochastic (P t)) -> (forall t i j, (P t i j != 0) = (i == j) || G t i j) ->
  T 0%N = 0%N -> V 0%N = [set: 'I_n] -> (forall k, (T k < T k.+1)%N) ->
  (forall k i, (i \in V k.+1) = (i \in V k) && (block P (V k) (T k).+1 (T k.+1 - T k) i b != 0)) ->
  (forall k t i, (T k.+1 <= t)%N -> i \in V k -> block P (V k) (T k).+1 (t - T k) i b != 0 -> i \in V k.+1) ->
  forall k t, (0 < k)%N ->
  (forall u i j, (T k < u)%N -> i \in V k -> j \in V k -> G u i j -> G u.+1 i j) ->
  (chazelle_stabilisers.N (changes G) t 1 <=
     chazelle_stabilisers.N (changes G) (T 1%N) 1
     + \sum_(2 <= l < k.+1) chazelle_stabilisers.N (changes G) (T l) (T l.-1)
     + 1 + 'C(#|V k|, 2) + chazelle_stabilisers.N (chazelle_switches.changes_in G (~: V k)) t (T k).+1)%N).
(* beyond.chazelle.recurrent (part) *)
Check (@chazelle_recurrent.tau1_repeatedly :
  forall (R : realFieldType) (n : nat) (P : nat -> 'M_n) (gamma : R) (B : nat),
  (forall t, stochastic (P t)) ->
  (forall t i, 0 < P t i i) ->
  0 < gamma ->
  (forall t i j, P t i j != 0 -> gamma <= P t i j) ->
  (forall s, rooted (window P s B)) ->
  forall s t, tau1 (span P s t) <= (1 - gamma ^+ (n.-1 * B)) ^+ (t %/ (n.-1 * B))).
(* rational numbers as real ones *)
Check (fun x : rat => erefl : chazelle_reals.value x = Rdefinitions.Rdiv
  (Rdefinitions.IZR (mathcomp.zify.ssrZ.Z_of_int (numq x))) (Rdefinitions.IZR (mathcomp.zify.ssrZ.Z_of_int (denq x)))).
(* beyond.chazelle.recurrent (part) *)
Check (@chazelle_reals.recurrent_real_limit :
  forall (n d : nat) (G : nat -> rel 'I_n) (c : nat -> 'I_n -> rat) (v : nat -> 'M[rat]_(n, d)) (alpha : rat),
  (0 < n)%N ->
  (forall t, network (G t)) ->
  (forall t, model_D (G t) (c t)) ->
  0 < alpha ->
  (forall t i j, transition (G t) (c t) i j != 0 -> alpha <= transition (G t) (c t) i j) ->
  (forall s, exists k, forall i j, connect (union G s k) i j) ->
  (forall t, (0 < t)%N -> v t.+1 = transition (G t) (c t) *m v t) ->
  exists y : 'I_d -> Rdefinitions.R, forall i l, Rseries.Un_cv (fun t => chazelle_reals.value (v t i l)) (y l)).
(* beyond.chazelle.recurrent (part) *)
Check (@chazelle_reals.repeatedly_real_limit :
  forall (n d : nat) (P : nat -> 'M[rat]_n) (v : nat -> 'M[rat]_(n, d)) (gamma : rat) (B : nat),
  (forall t, stochastic (P t)) ->
  (forall t i, 0 < P t i i) ->
  0 < gamma ->
  (forall t i j, P t i j != 0 -> gamma <= P t i j) ->
  (forall s, rooted (window P s B)) ->
  (forall t, (0 < t)%N -> v t.+1 = P t *m v t) ->
  exists y : 'I_d -> Rdefinitions.R,
    (forall i l, Rseries.Un_cv (fun t => chazelle_reals.value (v t i l)) (y l)) /\
    (forall k t i l, (k < t)%N ->
     Rdefinitions.Rle (Rbasic_fun.Rabs (Rdefinitions.Rminus (chazelle_reals.value (v t i l)) (y l)))
       (chazelle_reals.value ((1 - gamma ^+ (n.-1 * B)) ^+ (k %/ (n.-1 * B)) * extent v l)))).
(* chazelle.foot.mono (claim) *)
Check (@chazelle_model.footprints :
  forall R : realFieldType,
  (forall (n : nat) (G : nat -> rel 'I_n) (c : nat -> 'I_n -> R) (s k : nat),
   (forall t : nat, network (G t)) ->
   (forall t : nat, model_D (G t) (c t)) ->
   let P := fun t : nat => transition (G t) (c t) in
   (forall i j : 'I_n, footprint (span P s k) i j -> footprint (span P s k.+1) i j) /\
   (forall (t : nat) (i j : 'I_n), footprint (P t) i j = footprint (P t) j i) /\
   (forall (t : nat) (i : 'I_n), footprint (P t) i i)) /\
  (exists (G : nat -> rel 'I_3) (c : nat -> 'I_3 -> R),
     (forall t : nat, network (G t)) /\
     (forall t : nat, model_D (G t) (c t)) /\
     (exists i j : 'I_3,
        let P := fun t : nat => transition (G t) (c t) in
        footprint (span P 1 2) i j /\ ~~ footprint (span P 1 2) j i))).
(* chazelle.kron (claim) *)
Check (@chazelle_model.kronecker :
  forall (R : comRingType) (n p q s : nat) (A B C D : nat -> nat -> R),
  (forall i j k l : nat, (j < p)%N -> (l < q)%N -> kron p q A B (i * p + j) (k * q + l) = A i k * B j l) /\
  ((0 < q)%N ->
   forall i k : nat, mulf (n * q) (kron p q A B) (kron q s C D) i k = kron p s (mulf n A C) (mulf q B D) i k)).
(* chazelle.lem2.1 (claim) *)
Check (@chazelle_ergodicity.lemma_2_1 :
  forall (R : rcfType) (n d : nat) (x v : nat -> 'M_(n, d)) (t : nat) (i j : 'I_n),
  (forall t0 : nat, (0 < t0)%N -> x t0 = x t0.-1 + v t0) ->
  (0 < t)%N ->
  `|norm2 (row i (x t) - row j (x t)) - norm2 (row i (x t.-1) - row j (x t.-1))| <=
  norm2 (row i (v t) - row j (v t))).
(* chazelle.lem2.2.bits (claim) *)
Check (@chazelle_products.lemma_2_2_bits :
  forall (R : realFieldType) (n a : nat) (G : nat -> rel 'I_n) (c : nat -> 'I_n -> R),
  (forall u : nat, network (G u)) ->
  (forall u : nat, model_D (G u) (c u)) ->
  (forall u : nat, short_weights a (c u)) ->
  forall s t : nat,
  (s <= t)%N ->
  exists E : nat,
    [/\ (0 < E)%N, (E <= n ^ (a * n * (t - s + 1)))%N
      & forall i j : 'I_n,
        exists k : nat, (k <= E)%N /\ pprod (fun u : nat => transition (G u) (c u)) t s i j = k%:R / E%:R]).
(* chazelle.lem2.2.entries (claim) *)
Check (@chazelle_products.lemma_2_2_entries :
  forall (R : realFieldType) (n a : nat) (G : nat -> rel 'I_n) (c : nat -> 'I_n -> R) (s t : nat) (i j : 'I_n),
  (forall u : nat, network (G u)) ->
  (forall u : nat, model_D (G u) (c u)) ->
  let P := fun u : nat => transition (G u) (c u) in
  (forall (u : nat) (i0 j0 : 'I_n), P u i0 j0 != 0 -> n%:R ^- a <= P u i0 j0) ->
  (s <= t)%N ->
  pprod P t s i j != 0 -> n%:R ^- (a * n.-1) <= pprod P t s i j /\ n%:R ^- (a * n ^ 2) <= pprod P t s i j).
(* chazelle.lem2.3 (claim) *)
Check (@chazelle_products.lemma_2_3 :
  forall (R : realFieldType) (n a : nat) (G : nat -> rel 'I_n) (c : nat -> 'I_n -> R),
  (forall u : nat, network (G u)) ->
  (forall u : nat, model_D (G u) (c u)) ->
  (forall u : nat, short_weights a (c u)) ->
  forall (d b : nat) (x v : nat -> 'M_(n, d)),
  (forall t : nat, (0 < t)%N -> v t.+1 = transition (G t) (c t) *m v t) ->
  (forall t : nat, x t.+1 = x t + v t.+1) ->
  short_input b (x 0%N) ->
  short_input b (v 1%N) ->
  forall t : nat,
  (0 < t)%N ->
  (1 < n)%N ->
  exists E : nat,
    [/\ (0 < E)%N, (E <= n ^ ((2 * b * d + a) * (t * n)))%N
      & forall (i : 'I_n) (k : 'I_d),
        exists z w : int,
          [/\ v t i k = z%:~R / E%:R, x t i k = w%:~R / E%:R, (`|z| <= E * n ^ b)%N
            & (`|w| <= E * (n ^ b * t.+1))%N]]).
(* chazelle.lem2.4 (claim) *)
Check (@chazelle_ergodicity.lemma_2_4 :
  forall (R : rcfType) (m n p : nat) (A : 'M_(m, n)) (B : 'M_(n, p)),
  stochastic A -> stochastic B -> tau2 (A *m B) <= tau1 A * tau2 B).
(* chazelle.lem3.1.count (negation) *)
Check (@chazelle_count.count_fails :
  forall (R : realFieldType) (eps : R),
  0 < eps <= 1 ->
  exists (x v : nat -> 'cV[R]_3) (G : nat -> rel 'I_3) (c : nat -> 'I_3 -> R) (b : 'I_3) (T : nat -> nat)
    (V : nat -> {set 'I_3}),
  let P t := transition (G t) (c t) in
  [/\ line_flock eps x v G c,
      [/\ T 0%N = 0%N, V 0%N = [set: 'I_3], (forall k, (T k < T k.+1)%N),
        (forall k i, (i \in V k.+1) = (i \in V k) && (block P (V k) (T k).+1 (T k.+1 - T k) i b != 0)) &
        forall k t i, (T k.+1 <= t)%N -> i \in V k -> block P (V k) (T k).+1 (t - T k) i b != 0 -> i \in V k.+1],
      T 1%N = 1%N /\ (forall t i j, (0 < t)%N -> footprint (span P 1 t) i j = footprint (span P 1 1) i j),
      (forall t i j, (T 1%N + 1 < t)%N -> i \in V 1%N -> j \in V 1%N -> G t i j -> G t.+1 i j) &
      exists t, (chazelle_stabilisers.N (changes G) (T 1%N) 1 + 'C(#|V 1%N|, 2) <
                 chazelle_stabilisers.N (changes G) t 1)%N]).
(* chazelle.lem3.2 (claim) *)
Check (@chazelle_network.lemma_3_2 :
  forall (R : realFieldType) (n : nat) (G : rel 'I_n) (c : 'I_n -> R),
  network G ->
  model_D G c ->
  (forall i j : 'I_n, connect G i j) ->
  (forall i : 'I_n, 0 < c i) ->
  forall a : nat,
  (1 < n)%N ->
  (forall i : 'I_n, n%:R ^- a <= c i) ->
  (forall i : 'I_n, n%:R ^- a <= transition G c i i) ->
  forall (lam : R) (f : 'I_n -> R),
  (forall i : 'I_n, step G c f i = lam * f i) ->
  (exists i : 'I_n, f i != 0) -> lam != 1 -> `|lam| <= 1 - n%:R ^- (2 * a + 4)).
(* chazelle.lem3.3 (claim) *)
Check (@chazelle_limits.lemma_3_3 :
  forall (R : archiFieldType) (m : nat) (G : rel 'I_m.+1) (c : 'I_m.+1 -> R),
  network G ->
  model_D G c ->
  (forall i j : 'I_m.+1, connect G i j) ->
  (forall i : 'I_m.+1, 0 < c i) -> converges (Gamma_t G c) (Gamma G c)).
(* chazelle.lem3.4 (claim) *)
Check (@chazelle_limits.lemma_3_4 :
  forall (R : archiFieldType) (m : nat) (G : rel 'I_m.+1) (c : 'I_m.+1 -> R),
  network G ->
  model_D G c ->
  (forall i j : 'I_m.+1, connect G i j) ->
  (forall i : 'I_m.+1, 0 < c i) ->
  forall (d : nat) (x v : nat -> 'M_(m.+1, d)),
  (forall t : nat, x t.+1 = x t + v t.+1) ->
  (forall t : nat, (0 < t)%N -> v t.+1 = transition G c *m v t) ->
  converges (fun t : nat => relative c (x t)) ((1%:M - rank1 c) *m x 0%N + Gamma G c *m v 1%N) /\
  (forall t : nat, pirow c *m x t.+1 - pirow c *m x t = pirow c *m v 1%N)).
(* chazelle.lem3.5 (claim) *)
Check (@chazelle_bits.lemma_3_5 :
  forall (R : realFieldType) (m a b d : nat) (G : rel 'I_m.+1) (c : 'I_m.+1 -> R) (x v : 'M_(m.+1, d)),
  network G ->
  model_D G c ->
  (forall i j, connect G i j) ->
  (forall i, 0 < c i) ->
  short_weights a c ->
  let n := m.+1 in
  (exists E, [/\ (0 < E)%N, (E <= n ^ ((2 * a + 1) * n + 1))%N &
    forall i j, exists z : int, Gamma G c i j = z%:~R / E%:R /\ (`|z| <= E * n ^ (a.+1 * n + a + 1))%N]) /\
  (short_input b x -> short_input b v ->
   exists E, [/\ (0 < E)%N, (E <= n ^ ((2 * a + 1) * n + 1 + 2 * b * n * d))%N &
    forall i k, exists z : int, ((1%:M - rank1 c) *m x + Gamma G c *m v) i k = z%:~R / E%:R /\
      (`|z| <= E * n ^ (a.+1 * n + a + b + 3))%N])).
(* chazelle.modelD.stoch (claim) *)
Check (@chazelle_model.model_D_stochastic :
  forall (R : realFieldType) (n : nat) (G : rel 'I_n) (c : 'I_n -> R),
  network G -> model_D G c -> stochastic (transition G c) /\ (forall i : 'I_n, 0 < transition G c i i)).
(* chazelle.modelK.matrix (claim) *)
Check (@chazelle_model.model_K_matrix :
  forall (R : realFieldType) (n : nat) (G : rel 'I_n) (theta : 'cV_n) (i : 'I_n),
  network G ->
  (transition G (vicsek R G) *m theta) i 0 = (theta i 0 + \sum_(j | G i j) theta j 0) / (degree G i).+1%:R /\
  (forall j : 'I_n, transition G (vicsek R G) i j = (if (i == j) || G i j then (degree G i).+1%:R^-1 else 0))).
(* chazelle.pi (claim) *)
Check (@chazelle_network.stationary :
  forall (R : realFieldType) (n : nat) (G : rel 'I_n) (c : 'I_n -> R),
  network G ->
  model_D G c ->
  (forall i j : 'I_n, connect G i j) ->
  (forall i : 'I_n, 0 < c i) ->
  'I_n ->
  [/\ (forall i : 'I_n, \sum_j transition G c i j = 1) /\
      (forall j : 'I_n, \sum_i stat c i * transition G c i j = stat c j),
      (forall i : 'I_n, 0 < stat c i) /\ \sum_i stat c i = 1,
      (forall f : 'I_n -> R, (forall i : 'I_n, step G c f i = f i) -> forall i j : 'I_n, f i = f j) /\
      (forall y : 'I_n -> R,
       (forall j : 'I_n, \sum_i y i * transition G c i j = y j) ->
       exists k : R, forall i : 'I_n, y i = k * stat c i),
      forall f : 'I_n -> R,
      let g := fun i : 'I_n => f i - step G c f i in
      (forall i : 'I_n, g i - step G c g i = 0) -> forall i j : 'I_n, f i = f j
    & (forall (lam : R) (f : 'I_n -> R),
       (forall i : 'I_n, step G c f i = lam * f i) -> (exists i : 'I_n, f i != 0) -> lam = 1 \/ `|lam| < 1) /\
      (forall (x y : R) (f g : 'I_n -> R),
       (forall i : 'I_n, step G c f i = x * f i - y * g i) ->
       (forall i : 'I_n, step G c g i = x * g i + y * f i) ->
       (exists i : 'I_n, (f i != 0) || (g i != 0)) -> y = 0)]).
(* chazelle.stab (claim) *)
Check (@chazelle_stabilisers.stabilisers :
  forall (R : realFieldType) (n : nat) (P : nat -> 'M_n),
  (forall t : nat, stochastic (P t)) ->
  (forall (t : nat) (i : 'I_n), 0 < P t i i) ->
  (forall (t : nat) (i j : 'I_n), (P t i j != 0) = (P t j i != 0)) ->
  forall (b : 'I_n) (T : nat -> nat) (V : nat -> {set 'I_n}),
  V 0%N = [set: 'I_n] ->
  (forall k : nat, (T k < T k.+1)%N) ->
  (forall (k : nat) (i : 'I_n),
   (i \in V k.+1) = (i \in V k) && (block P (V k) (T k).+1 (T k.+1 - T k) i b != 0)) ->
  (forall (k t : nat) (i : 'I_n),
   (T k.+1 <= t)%N -> i \in V k -> block P (V k) (T k).+1 (t - T k) i b != 0 -> i \in V k.+1) ->
  forall k : nat,
  [/\ V k.+1 \subset V k, b \in V k,
      forall (t : nat) (i j : 'I_n),
      (T k.+1 < t)%N -> i \in V k.+1 -> j \in V k -> j \notin V k.+1 -> P t i j = 0 /\ P t j i = 0
    & forall i : 'I_n, i \in V k.+1 -> 0 < block P (V k) (T k).+1 (T k.+1 - T k) i b]).
(* chazelle.tau1 (claim) *)
Check (@chazelle_ergodicity.tau1_overlap :
  forall (R : realFieldType) (m n : nat) (A : 'M_(m, n)),
  stochastic A ->
  0 <= tau1 A /\ tau1 A = 1 - \big[Num.min/1]_ij (\sum_k Num.min (A ij.1 k) (A ij.2 k)) /\ tau1 A <= 1).
(* chazelle.tau2sqrt2 (claim) *)
Check (@chazelle_ergodicity.tau2_le_tau1 :
  forall (R : rcfType) (m n : nat) (A : 'M_(m, n)),
  stochastic A -> tau2 A <= tau1 A * tau2 1%:M /\ tau1 A * tau2 1%:M <= Num.sqrt 2 * tau1 A).
(* chazelle.xi.closed (part) *)
Check (@chazelle_spectral.xi_closed :
  forall (R : rcfType) (m : nat) (G : rel 'I_m.+1) (c : 'I_m.+1 -> R),
  network G ->
  model_D G c ->
  (forall i j : 'I_m.+1, connect G i j) ->
  (forall i : 'I_m.+1, 0 < c i) ->
  forall (U : 'M_m.+1) (lam : 'I_m.+1 -> R),
  U^T *m U = 1%:M ->
  (forall i k : 'I_m.+1, \sum_j M G c i j * U j k = lam k * U i k) ->
  (forall i : 'I_m.+1, U i 0 = u1 c i) ->
  lam 0 = 1 ->
  forall (d : nat) (x v : nat -> 'M_(m.+1, d)) (t1 : nat),
  (forall t : nat, (t1 <= t)%N -> x t.+1 = x t + v t.+1) ->
  (forall t : nat, (t1 < t)%N -> v t.+1 = transition G c *m v t) ->
  forall (tau : nat) (i : 'I_m.+1) (q : 'I_d),
  x (t1 + tau)%N i q =
  x t1 i q + drift c v t1 q *+ tau + \sum_(k | k != 0) (1 - lam k ^+ tau) / (1 - lam k) * Phi c U v t1 i k q).
End Matrices.

(* chazelle.lower_bound (corrected), chazelle.lower_paths: groups of four on the line, the hysteresis threshold eps (none for eps <= 0) *)
Module LowerBound.
Import Coq.Reals.Reals RealSums.
Local Open Scope R_scope.
Check (eq_refl : chazelle_lower.joined = fun G n i => Sum n (fun j => if G i j then 1 else 0)).
Check (eq_refl : chazelle_lower.heard = fun G n v i => Sum n (fun j => if G i j then v j else 0)).
Check (eq_refl : chazelle_lower.flock_line = fun n eps x v G =>
  (forall i j, (i < n)%nat -> (j < n)%nat -> (G 0%nat i j = true <-> i <> j /\ Rabs (x 0%nat i - x 0%nat j) <= 1)) /\
  (forall t i j, (i < n)%nat -> (j < n)%nat -> (G (S t) i j = true <-> i <> j /\ (Rabs (x (S t) i - x (S t) j) <= 1 \/
    (G t i j = true /\ Rabs (Rabs (x (S t) i - x (S t) j) - Rabs (x t i - x t j)) < eps)))) /\
  (forall t i, (i < n)%nat -> x (S t) i = x t i + v (S t) i) /\
  (forall t i, (1 <= t)%nat -> (i < n)%nat -> chazelle_lower.joined (G t) n i = 0 -> v (S t) i = v t i) /\
  (forall t i, (1 <= t)%nat -> (i < n)%nat -> chazelle_lower.joined (G t) n i <> 0 ->
    v (S t) i = v t i / 3 + 2 / (3 * chazelle_lower.joined (G t) n i) * chazelle_lower.heard (G t) n (v t) i)).
Check (eq_refl : chazelle_lower.place0 = fun i => INR (2 * (i / 2)) + (if Nat.even i then 0 else 2 / 3)).
Check (eq_refl : chazelle_lower.speed0 = fun u i => if Nat.even i then (if Nat.even (i / 2) then u else - u) else 0).
Check (eq_refl : chazelle_lower.row_net = fun four i j => (Nat.eqb (i / 4) (j / 4) && (Nat.eqb (S i) j || Nat.eqb (S j) i) && (four || Nat.eqb (i / 2) (j / 2)))%bool).
Check (chazelle_lower.lower_bound : forall (m : nat) (c eps : R) (x v : nat -> nat -> R) (G : nat -> nat -> nat -> bool) (T : nat), (1 <= m)%nat -> 8 <= Rpower (INR (4 * m)) c ->
  chazelle_lower.flock_line (4 * m) eps x v G ->
  (forall i, (i < 4 * m)%nat -> x 0%nat i = chazelle_lower.place0 i) -> (forall i, (i < 4 * m)%nat -> v 1%nat i = chazelle_lower.speed0 (Rpower (INR (4 * m)) (- c)) i) ->
  Rpower (INR (4 * m)) c / 3 <= INR T < Rpower (INR (4 * m)) c / 3 + 1 ->
  (forall t i j, (i < 4 * m)%nat -> (j < 4 * m)%nat -> (t < T)%nat -> G t i j = chazelle_lower.row_net false i j) /\
  (forall t i j, (i < 4 * m)%nat -> (j < 4 * m)%nat -> (T <= t)%nat -> G t i j = chazelle_lower.row_net true i j) /\
  (1 <= T)%nat /\ (exists i j, (i < 4 * m)%nat /\ (j < 4 * m)%nat /\ G T i j <> G (T - 1)%nat i j) /\
  forall t, (S t <> T)%nat -> forall i j, (i < 4 * m)%nat -> (j < 4 * m)%nat -> G (S t) i j = G t i j).
Check (chazelle_lower.lower_paths : forall (m : nat) (c eps : R) (x v : nat -> nat -> R) (G : nat -> nat -> nat -> bool), (1 <= m)%nat -> 8 <= Rpower (INR (4 * m)) c ->
  chazelle_lower.flock_line (4 * m) eps x v G ->
  (forall i, (i < 4 * m)%nat -> x 0%nat i = chazelle_lower.place0 i) -> (forall i, (i < 4 * m)%nat -> v 1%nat i = chazelle_lower.speed0 (Rpower (INR (4 * m)) (- c)) i) ->
  forall t, exists w, (w = 2 \/ w = 4)%nat /\ forall i j, (i < 4 * m)%nat -> (j < 4 * m)%nat -> (G t i j = true <-> (i / w)%nat = (j / w)%nat /\ (S i = j \/ S j = i))).
End LowerBound.
