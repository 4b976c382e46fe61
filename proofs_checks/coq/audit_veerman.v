(* What is proved for the paper of Veerman, Stosic and Olvera, written out again, with the axioms of each theorem.
   The definitions the statements use are restated first. *)
From Coq Require Import Reals List.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import veerman_complex veerman_matrices veerman_front veerman_chain veerman_stability veerman_lemma1.
From Flockproof Require veerman_numbers veerman_rest veerman_amplitude veerman_theorem1 veerman_size_limit veerman_exponent veerman_lesser veerman_root certificate_peaks veerman_resonances.
From Flockproof Require Import veerman_settling veerman_rates veerman_unsettled.
Open Scope R_scope.

Check (den_printed : forall f g w : R, den f g w = (RtoC f + Ci * w * g)%C).
Check (num_printed : forall f g w : R, num f g w = (RtoC f + Ci * w * g + RtoC (w ^ 2))%C).
Check (fun f g w : R => eq_refl : gamma f g w = (num f g w / den f g w)%C).
Check (fun (f g : R) h x u => eq_refl : equation_1 f g h x u = forall k t, Cderive (x (S k)) t (u (S k) t) /\
  Cderive (u (S k)) t ((f * ((x (S k) t - h (S k)) - (x k t - h k)) + g * (u (S k) t - u k t))%C)).
Check (fun z t d => eq_refl : Cderive z t d =
  (is_derive (fun s : R => fst (z s)) t (fst d) /\ is_derive (fun s : R => snd (z s)) t (snd d))).
Check (fun h a w k t => eq_refl : wave_x h a w k t = (RtoC (h k) + a k * cis (w * t))%C).
Check (fun f g w N a => eq_refl : equation_2 f g w N a =
  ((forall k, (1 <= k <= N)%nat ->
     ((- w ^ 2)%R * a k = den f g w * (a k - / 2 * (a (k - 1)%nat + a (k + 1)%nat)))%C) /\
   ((- w ^ 2)%R * a (S N) = den f g w * (a (S N) - a N))%C)).
Check (Csqrt_sqr : forall z : C, (Csqrt z * Csqrt z)%C = z).
Check (Csqrt_angle : forall z : C, 0 < fst (Csqrt z) \/ (fst (Csqrt z) = 0 /\ 0 <= snd (Csqrt z))).
Check (fun gam : C => eq_refl : mu_plus gam = (gam + Csqrt (gam * gam - 1))%C).
Check (fun gam : C => eq_refl : mu_minus gam = (gam - Csqrt (gam * gam - 1))%C).
Check (fun gam : C => eq_refl : Cmat gam = Mat2 0%C 1%C (- (1))%C (2 * gam)%C).
Check (fun x k => eq_refl : row1 x k = (x k - x (k - 1)%nat)%C).
Check (fun N x k => eq_refl : row2 N x k =
  if Nat.eqb k (S N) then (x k - x (k - 1)%nat)%C else (x k - / 2 * (x (k - 1)%nat + x (k + 1)%nat))%C).
Check (fun N P lam => eq_refl : eigenvalue N P lam = exists x : nat -> C,
  (exists k, (1 <= k <= S N)%nat /\ x k <> RtoC 0) /\ forall k, (1 <= k <= S N)%nat -> P x k = (lam * x k)%C).
Check (fun N P (f g : R) nu => eq_refl : eigenvalue_M N P f g nu = exists x u : nat -> C, (nonzero N x \/ nonzero N u) /\
  forall k, (1 <= k <= S N)%nat -> u k = (nu * x k)%C /\ (f * P x k + g * P u k)%C = (nu * u k)%C).
Check (fun N P f g => eq_refl : stable N P f g = forall nu, eigenvalue_M N P f g nu -> fst nu < 0).
Check (fun (f g : R) N h x u => eq_refl : system_1 f g N h x u = forall k t, (1 <= k <= S N)%nat -> 0 <= t ->
  is_derive (x k) t (u k t) /\
  is_derive (u k) t (f * ((x k t - h k) - (x (k - 1)%nat t - h (k - 1)%nat)) + g * (u k t - u (k - 1)%nat t))).
Check (fun (f g : R) N h x u => eq_refl : system_2 f g N h x u = forall k t, (1 <= k <= S N)%nat -> 0 <= t ->
  is_derive (x k) t (u k t) /\
  is_derive (u k) t (if Nat.eqb k (S N)
    then f * ((x k t - h k) - (x (k - 1)%nat t - h (k - 1)%nat)) + g * (u k t - u (k - 1)%nat t)
    else f * ((x k t - h k) - / 2 * ((x (k - 1)%nat t - h (k - 1)%nat) + (x (k + 1)%nat t - h (k + 1)%nat))) +
         g * (u k t - / 2 * (u (k - 1)%nat t + u (k + 1)%nat t)))).
Check (fun x u => eq_refl : leader_cruises x u =
  exists V : R, forall t, 0 <= t -> x 0%nat t = x 0%nat 0 + V * t /\ u 0%nat t = V).
Check (fun h x k t => eq_refl : deviation h x k t = (x k t - h k) - (x 0%nat t - h 0%nat)).
Check (fun (u : nat -> R -> R) k t => eq_refl : excess u k t = u k t - u 0%nat t).
Check (fun N h x u => eq_refl : settles N h x u = forall k, (1 <= k <= S N)%nat ->
  is_lim (deviation h x k) p_infty 0 /\ is_lim (excess u k) p_infty 0).
Check (fun r N h x u => eq_refl : settles_at_rate r N h x u = exists C : R, forall k t, (1 <= k <= S N)%nat -> 0 <= t ->
  Rabs (deviation h x k t) <= C * exp (- r * t) /\ Rabs (excess u k t) <= C * exp (- r * t)).
Check (fun f g N => eq_refl : stable_1 f g N =
  forall h x u, system_1 f g N h x u -> leader_cruises x u -> settles N h x u).
Check (fun f g N => eq_refl : stable_2 f g N =
  forall h x u, system_2 f g N h x u -> leader_cruises x u -> settles N h x u).
Check (fun N => eq_refl : lowest N = 1 - cos (PI / (2 * (INR N + 1)))).
(* the amplitude of the last of N + 1 followers, and where it is largest *)
Check (veerman_amplitude.amplitude_spec : forall (f g : R) (N : nat) (w : R), f < 0 -> g < 0 ->
  (exists a, a 0%nat = RtoC 1 /\ equation_2 f g w N a) /\
  forall a, a 0%nat = RtoC 1 -> equation_2 f g w N a -> Cmod (a (S N)) = veerman_amplitude.amplitude f g N w).
Check (fun f g N lo hi least most => eq_refl : certificate_peaks.has_peak f g N lo hi least most =
  let amplitude := veerman_amplitude.amplitude f g N in
  ((exists s, is_derive (fun w => amplitude w ^ 2) lo s /\ 0 < s) /\
   (exists s, is_derive (fun w => amplitude w ^ 2) hi s /\ s < 0) /\
   (exists w, lo < w < hi /\ least <= amplitude w < most /\ forall w', 0 < w' -> amplitude w' <= amplitude w) /\
   forall w, 0 < w -> ~ (lo < w < hi) -> amplitude w < least)).
Check (fun f g N w => eq_refl : veerman_amplitude.main_resonance f g N w = (0 < w /\
  forall w', 0 < w' -> veerman_amplitude.amplitude f g N w' <= veerman_amplitude.amplitude f g N w)).
Check (fun y nf na tf ta N => eq_refl : veerman_resonances.no_cell_is_true (y, nf, na, tf, ta) N =
  ((exists w, veerman_amplitude.main_resonance (-1) (-1) N w) /\ forall w, veerman_amplitude.main_resonance (-1) (-1) N w ->
   ~ veerman_numbers.agrees nf w /\ ~ veerman_numbers.agrees na (veerman_amplitude.amplitude (-1) (-1) N w) /\
   ~ veerman_numbers.agrees tf w /\ ~ veerman_numbers.agrees ta (veerman_amplitude.amplitude (-1) (-1) N w))).
(* powers, phases, the waves and positions of corollary 1, the strongest frequency *)
Check (fun z n => conj eq_refl eq_refl : Cpw z 0 = RtoC 1 /\ Cpw z (S n) = (z * Cpw z n)%C).
Check (fun t : R => eq_refl : cis t = (cos t, sin t)).
Check (fun a w k t => eq_refl : wave_u a w k t = ((0, w) * (a k * cis (w * t)))%C).
Check (fun f g => eq_refl : strongest f g = f ^ 2 / g ^ 2 * (sqrt (1 + 2 * g ^ 2 / Rabs f) - 1)).
Check (fun (a0 : R) h gam w k t => eq_refl : position a0 h gam w k t = h k + fst (RtoC a0 * (Cpw (/ gam)%C k * cis (w * t)))%C).
(* the matrices L of the two systems, and the components of a row of the vector form *)
Check (fun i j => eq_refl : L1 i j =
  if Nat.eqb i 0 then 0 else if Nat.eqb i j then 1 else if Nat.eqb i (S j) then -1 else 0).
Check (fun N i j => eq_refl : L2 N i j = if Nat.eqb i 0 then 0 else if Nat.eqb i j then 1
  else if Nat.eqb i (S N) then (if Nat.eqb i (S j) then -1 else 0)
  else if Nat.eqb i (S j) then - / 2 else if Nat.eqb j (S i) then - / 2 else 0).
Check (fun F n => conj eq_refl eq_refl : veerman_matrices.sum F 0 = 0 /\
  veerman_matrices.sum F (S n) = veerman_matrices.sum F n + F (S n)).
Check (fun (u : nat -> R) k => eq_refl : form_x u k = 1 * u k).
Check (fun f g L N x h u k => eq_refl : form_u f g L N x h u k =
  veerman_matrices.sum (fun j => L k j * (f * (x j - h j) + g * u j)) (S N) + L k 0%nat * (f * (x 0%nat - h 0%nat) + g * u 0%nat)).
(* spectra: P leaves out the leader's column, that is x_0 = 0 *)
Check (fun row x k => eq_refl : reduced row x k = row (fun j => match j with O => RtoC 0 | _ => x j end) k).
Check (fun N => conj eq_refl eq_refl : P1 = reduced row1 /\ P2 N = reduced (row2 N)).
Check (fun N x => eq_refl : nonzero N x = exists k, (1 <= k <= S N)%nat /\ x k <> RtoC 0).
Check (fun N P lam x => eq_refl : eigenvector N P lam x =
  (nonzero N x /\ forall k, (1 <= k <= S N)%nat -> P x k = (lam * x k)%C)).
Check (fun (f g : R) lam nu => eq_refl : eigenvalue_AK f g lam nu = exists a b : C, (a <> RtoC 0 \/ b <> RtoC 0) /\
  b = (nu * a)%C /\ (lam * f * a + lam * g * b)%C = (nu * b)%C).
Check (fun N row lam => eq_refl : L_eigenvalue N row lam = exists x : nat -> C,
  (exists k, (k <= S N)%nat /\ x k <> RtoC 0) /\ RtoC 0 = (lam * x 0%nat)%C /\
  forall k, (1 <= k <= S N)%nat -> row x k = (lam * x k)%C).
Check (fun N k => eq_refl : angle N k = (2 * INR k - 1) * PI / (2 * (INR N + 1))).
(* lemma 2: the matrix C as a map of pairs, its powers and trace, the recurrence of the amplitudes *)
Check (fun gam (p : C * C) => eq_refl : Cmap gam p = (snd p, (2 * gam * snd p - fst p)%C)).
Check (fun a11 a12 a21 a22 b11 b12 b21 b22 => eq_refl : mat2_mul (Mat2 a11 a12 a21 a22) (Mat2 b11 b12 b21 b22) =
  Mat2 (a11 * b11 + a12 * b21)%C (a11 * b12 + a12 * b22)%C (a21 * b11 + a22 * b21)%C (a21 * b12 + a22 * b22)%C).
Check (fun M n => conj eq_refl eq_refl : mat2_pow M 0 = Mat2 (RtoC 1) (RtoC 0) (RtoC 0) (RtoC 1) /\
  mat2_pow M (S n) = mat2_mul M (mat2_pow M n)).
Check (fun a b c d => eq_refl : trace2 (Mat2 a b c d) = (a + d)%C).
Check (fun gam N a => eq_refl : chain gam N a =
  ((forall k, (1 <= k <= N)%nat -> (a k, a (k + 1)%nat) = Cmap gam (a (k - 1)%nat, a k)) /\ a N = (gam * a (S N))%C)).
(* theorem 1's numbers, the printed cells with one unit of the last digit, and what a cell agrees with *)
Check (fun f M => eq_refl : veerman_numbers.frequency f M = sqrt (Rabs f) * PI / (M * 2 * sqrt 2)).
Check (fun f g M => eq_refl : veerman_numbers.amplitude f g M = 8 * sqrt (2 * Rabs f) / (PI ^ 2 * Rabs g) * M).
Check (eq_refl : veerman_numbers.cell = (R * R)%type).
Check (fun c x => eq_refl : veerman_numbers.agrees c x = (Rabs (fst c - x) <= snd c)).
Check (eq_refl : veerman_numbers.table =
  (4, (0.2776801836, 1e-10), (4.58527335, 1e-8), (0.2727291, 1e-7), (4.49064609, 1e-8)) ::
  (8, (0.1388400918, 1e-10), (9.17054669, 1e-8), (0.1382221, 1e-7), (9.11739657, 1e-8)) ::
  (16, (0.0694200459, 1e-10), (18.34109338, 1e-8), (0.06934994, 1e-8), (18.3135253, 1e-7)) ::
  (32, (0.0347100229, 1e-10), (36.68218677, 1e-8), (0.03470038, 1e-8), (36.6683866, 1e-7)) ::
  (64, (0.0173550115, 1e-10), (73.36437354, 1e-8), (0.017353935, 1e-9), (73.3562112, 1e-7)) ::
  (128, (0.0086775057, 1e-10), (146.72874707, 1e-8), (0.008677381, 1e-9), (146.7227220, 1e-7)) :: nil).
(* a resonance is a weak local maximum of the amplitude *)
Check (fun F w => eq_refl : veerman_lesser.local_maximum F w =
  exists r, 0 < r /\ forall v, Rabs (v - w) < r -> F v <= F w).
(* other graphs: everyone tracks the leader; the n-th agent in front and behind, and paths of tracking *)
Check (fun f g w a => eq_refl : veerman_numbers.equation_star f g w a =
  (a 0%nat = RtoC 1 /\ forall k, ((- w ^ 2)%R * a (S k))%C = (den f g w * (a (S k) - a 0%nat))%C)).
Check (fun n N i j => eq_refl : veerman_numbers.tracks n N i j =
  ((i <= S N)%nat /\ (j <= S N)%nat /\ (j = i + n \/ i = j + n)%nat)).
Check (veerman_numbers.there : forall n N i j k,
  veerman_numbers.tracks n N i j -> veerman_numbers.joined n N j k -> veerman_numbers.joined n N i k).
Check (veerman_numbers.joined_ind : forall (n N : nat) (Q : nat -> nat -> Prop), (forall i, Q i i) ->
  (forall i j k, veerman_numbers.tracks n N i j -> veerman_numbers.joined n N j k -> Q j k -> Q i k) ->
  forall i j, veerman_numbers.joined n N i j -> Q i j).
(* beyond.veerman.decay_rate (claim) *)
Check (@veerman_unsettled.decay_rate :
  forall f g : R,
  f < 0 ->
  g < 0 ->
  (forall N : nat,
   Rabs g / sqrt (Rabs f) <= INR (S N) ->
   let rate := Rabs g * (1 - cos (PI / (2 * INR (S N)))) / 2 in
   (forall nu : C, eigenvalue_M N (P2 N) f g nu -> fst nu <= - rate) /\
   (exists nu : C, eigenvalue_M N (P2 N) f g nu /\ fst nu = - rate) /\
   rate < PI ^ 2 * Rabs g / (16 * INR (S N) ^ 2) /\
   (forall (h : nat -> R) (x u : nat -> R -> R),
    system_2 f g N h x u -> leader_cruises x u -> settles_at_rate rate N h x u)) /\
  (forall N : nat, stable N (P2 N) f g) /\
  (forall common : R, 0 < common -> exists (N : nat) (nu : C), eigenvalue_M N (P2 N) f g nu /\ - common < fst nu)).
(* veerman.cor1 (claim) *)
Check (@veerman_front.corollary_1 :
  forall (f g : R) (h : nat -> R) (a : nat -> C) (w : R),
  f < 0 ->
  g < 0 ->
  a 0%nat = 1 ->
  equation_1 f g h (wave_x h a w) (wave_u a w) <-> (forall k : nat, a k = Cpw (/ gamma f g w)%C k)).
(* veerman.cor1.proof (corrected) *)
Check (@veerman_front.substitution :
  forall (f g : R) (h : nat -> R) (a : nat -> C) (w : R),
  equation_1 f g h (wave_x h a w) (wave_u a w) <->
  (forall k : nat, ((- w ^ 2)%R * a (S k))%C = (f * (a (S k) - a k) + (0, w) * g * (a (S k) - a k))%C)).
(* veerman.cor1_special (claim) *)
Check (@veerman_front.corollary_1_special :
  forall (f g : R) (k : nat),
  f < 0 -> g < 0 -> Cpw (/ gamma f g (sqrt (Rabs f)))%C k = Cpw (1, sqrt (Rabs f) / g) k).
(* veerman.cor2 (claim) *)
Check (@veerman_chain.corollary_2 :
  forall f g w : R,
  f < 0 ->
  g < 0 ->
  w <> 0 ->
  let gam := gamma f g w in
  Cmod (mu_plus gam) <> Cmod (mu_minus gam) /\
  (exists rho : R,
     1 < rho /\
     (forall (N : nat) (a : nat -> C),
      a 0%nat = 1 ->
      equation_2 f g w N a -> 2 / (rho ^ S N + / rho ^ S N) <= Cmod (a (S N)) <= 2 / (rho ^ S N - / rho ^ S N)))).
(* veerman.eigAK (claim) *)
Check (@veerman_lemma1.eigenvalues_AK :
  forall (f g : R) (lam : C),
  (forall nu : C, eigenvalue_AK f g lam nu <-> (nu * nu - lam * g * nu - lam * f)%C = 0) /\
  (forall nu s : C,
   (s * s)%C = (lam * g * (lam * g) + 4 * lam * f)%C ->
   eigenvalue_AK f g lam nu <-> nu = (/ 2 * (lam * g + s))%C \/ nu = (/ 2 * (lam * g - s))%C)).
(* veerman.eq1_matrix (part) *)
Check (@veerman_matrices.equation_1_vector :
  forall (f g : R) (N : nat) (x h u : nat -> R) (k : nat),
  (1 <= k <= S N)%nat ->
  form_x u k = u k /\
  form_u f g L1 N x h u k = f * (x k - h k - (x (k - 1)%nat - h (k - 1)%nat)) + g * (u k - u (k - 1)%nat)).
(* veerman.eq1_matrix (part) *)
Check (@veerman_stability.spectrum_P1 :
  forall (N : nat) (lam : C), eigenvalue N P1 lam <-> lam = 1).
(* veerman.eq2_matrix (claim) *)
Check (@veerman_matrices.equation_2_vector :
  forall (f g : R) (N : nat) (x h u : nat -> R) (k : nat),
  (1 <= k <= S N)%nat ->
  form_x u k = u k /\
  form_u f g (L2 N) N x h u k =
  (if k =? S N
   then f * (x k - h k - (x (k - 1)%nat - h (k - 1)%nat)) + g * (u k - u (k - 1)%nat)
   else
    f * (x k - h k - / 2 * (x (k - 1)%nat - h (k - 1)%nat + (x (k + 1)%nat - h (k + 1)%nat))) +
    g * (u k - / 2 * (u (k - 1)%nat + u (k + 1)%nat)))).
(* veerman.gain_iff (corrected) *)
Check (@veerman_front.gain_above_one :
  forall f g w : R, f < 0 -> g < 0 -> 1 < Cmod (/ gamma f g w)%C <-> 0 < w ^ 2 < 2 * Rabs f).
(* veerman.gain_iff (negation) *)
Check (@veerman_front.gain_iff_printed_fails :
  ~ (forall f g w : R, f < 0 -> g < 0 -> 1 < Cmod (/ gamma f g w)%C <-> w ^ 2 < 2 * Rabs f)).
(* veerman.gain_max (corrected) *)
Check (@veerman_front.gain_strongest :
  forall f g w : R,
  f < 0 ->
  g < 0 ->
  let v := strongest f g in
  v < Rabs f /\
  (w ^ 2 = v -> forall w' : R, Cmod (/ gamma f g w')%C <= Cmod (/ gamma f g w)%C) /\
  (w ^ 2 <> v -> exists w' : R, Cmod (/ gamma f g w)%C < Cmod (/ gamma f g w')%C)).
(* veerman.gain_max (negation) *)
Check (@veerman_front.gain_max_printed_fails :
  forall f g w : R,
  f < 0 -> g < 0 -> w ^ 2 = Rabs f -> exists w' : R, Cmod (/ gamma f g w)%C < Cmod (/ gamma f g w')%C).
(* veerman.lem1 (claim) *)
Check (@veerman_lemma1.lemma_1 :
  forall f g : R,
  (forall N : nat, stable N P1 f g <-> f < 0 /\ g < 0) /\
  (forall N : nat, stable N (P2 N) f g <-> f < 0 /\ g < 0) /\
  ((forall N : nat, stable N P1 f g /\ stable N (P2 N) f g) <-> f < 0 /\ g < 0)).
(* veerman.lem1 (claim) *)
Check (@veerman_unsettled.lemma_1_in_time :
  forall f g : R,
  (forall N : nat, stable_1 f g N <-> f < 0 /\ g < 0) /\ (forall N : nat, stable_2 f g N <-> f < 0 /\ g < 0)).
(* veerman.lem1 (part) *)
Check (@veerman_rates.one_sided_settles :
  forall (f g s : R) (N : nat) (h : nat -> R) (x u : nat -> R -> R),
  g < 0 ->
  0 <= s ->
  2 * s < - g ->
  0 < - f + g * s + s ^ 2 -> system_1 f g N h x u -> leader_cruises x u -> settles_at_rate s N h x u).
(* veerman.lem1 (part) *)
Check (@veerman_rates.two_sided_settles :
  forall (f g r : R) (N : nat) (h : nat -> R) (x u : nat -> R -> R),
  0 < r ->
  - g * r <= - f ->
  2 * r <= - g * lowest N -> system_2 f g N h x u -> leader_cruises x u -> settles_at_rate r N h x u).
(* veerman.lem1 (part) *)
Check (@veerman_settling.mode_decays :
  forall (f g mu r : R) (x u : R -> R),
  0 <= r ->
  2 * r <= - mu * g ->
  0 < - mu * f + mu * g * r + r ^ 2 ->
  (forall t : R, 0 <= t -> is_derive x t (u t) /\ is_derive u t (mu * (f * x t + g * u t))) ->
  let q := - mu * f + mu * g * r + r ^ 2 in
  forall t : R,
  0 <= t -> (u t + r * x t) ^ 2 + q * x t ^ 2 <= ((u 0 + r * x 0) ^ 2 + q * x 0 ^ 2) * exp (- (2 * r) * t)).
(* veerman.lem2 (claim) *)
Check (@veerman_chain.lemma_2 :
  forall (f g w : R) (N : nat) (a : nat -> C),
  f < 0 ->
  g < 0 ->
  a 0%nat = 1 ->
  equation_2 f g w N a ->
  let gam := gamma f g w in
  a (S N) = (2 / trace2 (mat2_pow (Cmat gam) (S N)))%C /\
  a (S N) = (2 / (Cpw (mu_minus gam) (S N) + Cpw (mu_plus gam) (S N)))%C).
(* veerman.lem2_eigvec (part) *)
Check (@veerman_chain.lemma_2_eigenvectors :
  forall gam : C,
  let s := Csqrt (gam * gam - 1)%C in
  Cmap gam (RtoC 1, mu_plus gam) = ((mu_plus gam * 1)%C, (mu_plus gam * mu_plus gam)%C) /\
  Cmap gam (RtoC 1, mu_minus gam) = ((mu_minus gam * 1)%C, (mu_minus gam * mu_minus gam)%C) /\
  (1 - gam * mu_plus gam)%C = (- s * mu_plus gam)%C /\ (1 - gam * mu_minus gam)%C = (s * mu_minus gam)%C).
(* veerman.lem2_eigvec (part) *)
Check (@veerman_chain.equation_2_chain :
  forall (f g w : R) (N : nat) (a : nat -> C),
  f < 0 -> g < 0 -> equation_2 f g w N a <-> chain (gamma f g w) N a).
(* veerman.lem2_eigvec (part) *)
Check (@veerman_chain.lemma_2_constant :
  forall (f g w : R) (N : nat) (a : nat -> C),
  f < 0 ->
  g < 0 ->
  w <> 0 ->
  a 0%nat = 1 ->
  equation_2 f g w N a ->
  let gam := gamma f g w in
  let p := mu_plus gam in
  let m := mu_minus gam in
  forall c : C,
  (forall k : nat, (k <= S N)%nat -> a k = (c * Cpw p k + (1 - c) * Cpw m k)%C) ->
  c = (Cpw m (S N) / (Cpw m (S N) + Cpw p (S N)))%C).
(* veerman.lem3 (claim) *)
Check (@veerman_chain.lemma_3 :
  forall (f g w : R) (N : nat) (a : nat -> C),
  f < 0 ->
  g < 0 ->
  0 < w ->
  a 0%nat = 1 ->
  equation_2 f g w N a -> Cmod (a (S N)) * (INR (S N) * (- g * w ^ 3 / (f ^ 2 + (w * g) ^ 2))) <= 1).
(* veerman.nth_neighbour (corrected) *)
Check (@veerman_numbers.nth_neighbour :
  forall n N : nat, (2 <= n)%nat -> ~ veerman_numbers.joined n N 0 1).
(* veerman.nth_neighbour (negation) *)
Check (@veerman_numbers.nth_neighbour_printed_fails :
  forall N i j : nat, (i <= S N)%nat -> (j <= S N)%nat -> veerman_numbers.joined 1 N i j).
(* veerman.onlytwo (negation) *)
Check (@veerman_numbers.star_peak :
  forall f g : R,
  f < 0 ->
  g < 0 ->
  exists A : R,
    1 < A /\
    (forall N : nat,
     (exists w : R, forall a : nat -> C, veerman_numbers.equation_star f g w a -> Cmod (a (S N)) = A) /\
     (forall (w : R) (a : nat -> C), veerman_numbers.equation_star f g w a -> Cmod (a (S N)) <= A))).
(* veerman.prop1 (corrected) *)
Check (@veerman_front.proposition_1 :
  forall (f g a0 D : R) (N : nat),
  f < 0 ->
  g < 0 ->
  0 < a0 ->
  0 < D ->
  let A := a0 * Cmod (Cpw (/ gamma f g (sqrt (Rabs f)))%C (S N)) in
  A <= D <-> INR (S N) <= 2 * ln (D / a0) / ln (1 + Rabs f / g ^ 2)).
(* veerman.prop1 (negation) *)
Check (@veerman_front.proposition_1_printed_fails :
  ~
  (forall (f g a0 D : R) (N : nat),
   f < 0 ->
   g < 0 ->
   0 < a0 ->
   a0 < D ->
   a0 * Cmod (Cpw (/ gamma f g (Rabs f))%C (S N)) <= D -> INR N <= 2 * ln (D / a0) / ln (1 + Rabs f / g ^ 2))).
(* veerman.sec7.omega0 (claim) *)
Check (@veerman_numbers.omega_0 :
  forall N : nat, veerman_numbers.frequency (-1) (INR (N + 1)) = PI * sqrt 2 / (4 * INR (N + 1))).
(* veerman.sep_remark (corrected) *)
Check (@veerman_front.separation :
  forall (a0 : R) (h : nat -> R) (gam : C) (w : R) (k : nat) (t : R),
  h (S k) - h k = 1 ->
  position a0 h gam w (S k) t - position a0 h gam w k t =
  a0 * fst (Cpw (/ gam) (S k) * cis (w * t))%C - a0 * fst (Cpw (/ gam) k * cis (w * t))%C + 1).
(* veerman.sep_remark (negation) *)
Check (@veerman_front.separation_printed_fails :
  forall (a0 : R) (h : nat -> R) (gam : C) (w : R) (k : nat) (t : R),
  0 < a0 ->
  h (S k) - h k = 1 ->
  position a0 h gam w (S k) t - position a0 h gam w k t <>
  a0 * fst (Cpw (/ gam) (S k) * cis (w * t))%C - a0 * fst (Cpw (/ gam) k * cis (w * t) + 1)%C).
(* veerman.specM (corrected) *)
Check (@veerman_lemma1.spectrum_M_systems :
  forall (N : nat) (f g : R) (nu : C),
  (eigenvalue_M N P1 f g nu <->
   (exists lam : C, L_eigenvalue N row1 lam /\ lam <> 0 /\ eigenvalue_AK f g lam nu)) /\
  (eigenvalue_M N (P2 N) f g nu <->
   (exists lam : C, L_eigenvalue N (row2 N) lam /\ lam <> 0 /\ eigenvalue_AK f g lam nu))).
(* veerman.specM (part) *)
Check (@veerman_stability.spectrum_L :
  forall (N : nat) (row : (nat -> C) -> nat -> C) (lam : C),
  (forall (x y : nat -> C) (k : nat),
   (1 <= k <= S N)%nat -> (forall j : nat, (j <= S N)%nat -> x j = y j) -> row x k = row y k) ->
  lam <> 0 -> L_eigenvalue N row lam <-> eigenvalue N (reduced row) lam).
(* veerman.specM (negation) *)
Check (@veerman_lemma1.spectrum_M_printed_fails :
  forall (N : nat) (g : R),
  exists nu lam : C,
    L_eigenvalue N row1 lam /\ lam <> 0 /\ eigenvalue_AK 0 g lam nu /\ ~ (eigenvalue_M N P1 0 g nu /\ nu <> 0)).
(* veerman.specP2 (claim) *)
Check (@veerman_lemma1.spectrum_P2_whole :
  forall N : nat,
  (forall lam : C,
   eigenvalue N (P2 N) lam <->
   (exists k : nat, (1 <= k <= S N)%nat /\ lam = 1 - cos ((2 * INR k - 1) * PI / (2 * (INR N + 1))))) /\
  (forall j k : nat,
   (1 <= j <= S N)%nat -> (1 <= k <= S N)%nat -> j <> k -> 1 - cos (angle N j) <> 1 - cos (angle N k)) /\
  (forall (lam : C) (x y : nat -> C),
   eigenvector N (P2 N) lam x ->
   eigenvector N (P2 N) lam y -> exists c : C, forall k : nat, (1 <= k <= S N)%nat -> y k = (c * x k)%C)).
(* veerman.table1.size (part) *)
Check (@veerman_numbers.table_size_printed_fails :
  List.Forall
    (fun r : R * veerman_numbers.cell * veerman_numbers.cell * veerman_numbers.cell * veerman_numbers.cell =>
     let (y, _) := r in
     let (y0, _) := y in
     let (y1, na) := y0 in
     let (N, nf) := y1 in
     ~ veerman_numbers.agrees nf (veerman_numbers.frequency (-1) (N + 1)) /\
     ~ veerman_numbers.agrees na (veerman_numbers.amplitude (-1) (-1) (N + 1))) veerman_numbers.table).
(* veerman.table1_numeric (negation) *)
Check (@veerman_numbers.table_numeric_fails :
  (forall a : nat -> C, a 0%nat = 1 -> equation_2 (-1) (-1) 0.27311 3 a -> 4.6548 <= Cmod (a 4%nat)) /\
  (forall a : nat -> C, a 0%nat = 1 -> equation_2 (-1) (-1) 0.22 4 a -> 5.7 <= Cmod (a 5%nat))).
(* veerman.table1_numeric (negation) *)
Check (@veerman_resonances.table_rows_fail :
  List.Forall2 veerman_resonances.no_cell_is_true (List.firstn 3 veerman_numbers.table) (3 :: 7 :: 15 :: nil)%nat).
(* veerman.table1_numeric (instance) *)
Check (@veerman_resonances.resonance_4 :
  certificate_peaks.has_peak (-1) (-1) 3 0.27310829 0.27310884 4.6548995380734 4.654899538074).
(* veerman.table1_numeric (instance) *)
Check (@veerman_resonances.resonance_8 :
  certificate_peaks.has_peak (-1) (-1) 7 0.13827819 0.13827847 9.2043186764187 9.2043186764198).
(* veerman.table1_numeric (instance) *)
Check (@veerman_resonances.resonance_16 :
  certificate_peaks.has_peak (-1) (-1) 15 0.069350142 0.069350282 18.357835519798 18.357835519801).
(* veerman.table1_theory (corrected) *)
Check (@veerman_numbers.table_theory :
  List.Forall
    (fun r : R * veerman_numbers.cell * veerman_numbers.cell * veerman_numbers.cell * veerman_numbers.cell =>
     let (y, _) := r in
     let (y0, _) := y in
     let (y1, na) := y0 in
     let (N, nf) := y1 in
     veerman_numbers.agrees nf (veerman_numbers.frequency (-1) N) /\
     veerman_numbers.agrees na (veerman_numbers.amplitude (-1) (-1) N)) veerman_numbers.table).
(* veerman.table1_theory (negation) *)
Check (@veerman_numbers.table_theory_printed_fails :
  List.Forall
    (fun r : R * veerman_numbers.cell * veerman_numbers.cell * veerman_numbers.cell * veerman_numbers.cell =>
     let (y, ta) := r in
     let (y0, tf) := y in
     let (y1, _) := y0 in
     let (N, _) := y1 in
     ~ veerman_numbers.agrees tf (veerman_numbers.frequency (-1) (N + 1)) /\
     ~ veerman_numbers.agrees ta (veerman_numbers.amplitude (-1) (-1) (N + 1)) /\
     ~ veerman_numbers.agrees tf (veerman_numbers.frequency (-1) N) /\
     ~ veerman_numbers.agrees ta (veerman_numbers.amplitude (-1) (-1) N)) veerman_numbers.table).
(* veerman.thm1_amp, veerman.thm1_omega (claim) *)
Check (fun f M => eq_refl : veerman_numbers.frequency f M = sqrt (Rabs f) * PI / (M * 2 * sqrt 2)).
Check (fun f g M => eq_refl : veerman_numbers.amplitude f g M = 8 * sqrt (2 * Rabs f) / (PI ^ 2 * Rabs g) * M).
Check (@veerman_theorem1.theorem_1 :
  forall f g : R, f < 0 -> g < 0 ->
  exists C M0 : R, forall N : nat, M0 <= INR (S N) ->
  (exists w, veerman_amplitude.main_resonance f g N w) /\
  (forall w, veerman_amplitude.main_resonance f g N w ->
   Rabs (w - veerman_numbers.frequency f (INR (S N))) <= C / INR (S N) ^ 3 /\
   Rabs (veerman_amplitude.amplitude f g N w - veerman_numbers.amplitude f g (INR (S N))) <= C / INR (S N))).
(* veerman.prop2 (claim) *)
Check (@veerman_size_limit.proposition_2 :
  forall f g : R, f < 0 -> g < 0 ->
  let X := PI ^ 2 * Rabs g / (8 * sqrt 2 * sqrt (Rabs f)) in
  exists C M0 : R, forall (N : nat) (a0 D w : R), M0 <= INR (S N) -> 0 < a0 -> veerman_amplitude.main_resonance f g N w ->
  (a0 * veerman_amplitude.amplitude f g N w <= D -> INR (S N) <= X * (D / a0) + C / INR (S N)) /\
  (INR (S N) + C / INR (S N) <= X * (D / a0) -> a0 * veerman_amplitude.amplitude f g N w <= D) /\
  (a0 * veerman_amplitude.amplitude f g N w <= D -> INR N <= X * (D / a0))).
(* veerman.thm1_x (corrected) *)
Check (@veerman_exponent.exponent :
  forall f g : R, f < 0 -> g < 0 ->
  let X := PI ^ 2 * Rabs g / (8 * sqrt 2 * sqrt (Rabs f)) in
  exists C M0 : R, forall (N : nat) (w : R), M0 <= INR (S N) -> veerman_amplitude.main_resonance f g N w ->
  let M := INR (S N) in
  Rabs (Cmod (mu_plus (gamma f g w)) ^ S N - exp (X / M)) <= C / M ^ 3 /\
  Rabs (Cmod (mu_minus (gamma f g w)) ^ S N - exp (- (X / M))) <= C / M ^ 3 /\
  Rabs (veerman_amplitude.amplitude f g N w - M / X) <= C / M).
(* veerman.thm1_x (negation) *)
Check (@veerman_exponent.exponent_printed_fails :
  ~ (forall f g : R, f < 0 -> g < 0 -> let x := PI ^ 2 * Rabs g / (8 * sqrt 2 * Rabs f) in
     exists C M0 : R, forall (N : nat) (w : R), M0 <= INR (S N) -> veerman_amplitude.main_resonance f g N w ->
     Rabs (veerman_amplitude.amplitude f g N w - INR (S N) / x) <= C / INR (S N))).
(* veerman.thm1_mod (claim) *)
Check (@veerman_exponent.moduli :
  forall f g : R, f < 0 -> g < 0 -> exists C small : R, 0 < small /\ (forall w : R, 0 < w <= small ->
  let u := sqrt 2 * w ^ 2 * Rabs g / (Rabs f * sqrt (Rabs f)) in
  Rabs (Cmod (mu_plus (gamma f g w)) ^ 2 - (1 + u)) <= C * w ^ 4 /\
  Rabs (Cmod (mu_minus (gamma f g w)) ^ 2 - (1 - u)) <= C * w ^ 4)).
(* veerman.cor3 (claim) *)
Check (fun F w => eq_refl : veerman_lesser.local_maximum F w = exists r, 0 < r /\ forall v, Rabs (v - w) < r -> F v <= F w).
Check (@veerman_lesser.corollary_3 :
  forall (f g : R) (k : nat) (e : R), f < 0 -> g < 0 -> (1 <= k)%nat -> 0 < e ->
  exists M0 : R, forall N : nat, M0 <= INR (S N) -> forall main : R, veerman_amplitude.main_resonance f g N main ->
  exists w : R, 0 < w /\ Rabs (w / main - (2 * INR k - 1)) <= e /\
    veerman_lesser.local_maximum (veerman_amplitude.amplitude f g N) w).

(* veerman.specM, corrected: both systems *)
Check (spectrum_L_systems :
  forall (N : nat) (lam : C), (L_eigenvalue N row1 lam /\ lam <> 0%C <-> eigenvalue N P1 lam) /\
       (L_eigenvalue N (row2 N) lam /\ lam <> 0%C <-> eigenvalue N (P2 N) lam)).
Check (spectrum_M_nonzero :
  forall (N : nat) (f g : R), f <> 0 -> ~ eigenvalue_M N P1 f g 0%C /\ ~ eigenvalue_M N (P2 N) f g 0%C).
(* veerman.nth_neighbour, corrected *)
Check (eq_refl : veerman_rest.follows = fun n N f g rho z v => (forall k j, rho k j <> 0 -> veerman_numbers.tracks n N k j) /\
  forall k t, (1 <= k <= S N)%nat -> 0 <= t -> is_derive (z k) t (v k t) /\
  is_derive (v k) t (RealSums.Sum (S (S N)) (fun j => rho k j * (f * (z k t - z j t) + g * (v k t - v j t))))).
Check (veerman_rest.unjoined_rest :
  forall (n N : nat) (f g : R) (rho : nat -> nat -> R) (z v : nat -> R -> R), veerman_rest.follows n N f g rho z v ->
       (forall k, (1 <= k <= S N)%nat -> ~ veerman_numbers.joined n N 0 k -> z k 0 = 0 /\ v k 0 = 0) ->
       forall k t, (1 <= k <= S N)%nat -> ~ veerman_numbers.joined n N 0 k -> 0 <= t -> z k t = 0 /\ v k t = 0).

(* veerman.thm1_eps (corrected): the principal root of gamma^2 - 1 *)
Check (eq_refl : veerman_root.eps_series = fun f g w => (Ci * RtoC (sqrt 2) * RtoC (w / sqrt (Rabs f)) *
  ((RtoC 1 - Ci * RtoC (w * Rabs g / (2 * Rabs f))) + RtoC (w ^ 2 / 2 * (- (3 / 4) * (g ^ 2 / f ^ 2) - 1 / (2 * Rabs f)))))%C).
Check (veerman_root.thm1_eps : forall f g : R, f < 0 -> g < 0 -> exists K w0, 0 < K /\ 0 < w0 /\ forall w, 0 < w < w0 ->
  Cmod (Csqrt (gamma f g w * gamma f g w - 1) - veerman_root.eps_series f g w)%C <= K * w ^ 4).

(* veerman.cor3, clause 2 *)
Check (veerman_lesser.lesser : forall f g k e, f < 0 -> g < 0 -> (2 <= k)%nat -> 0 < e <= 1 -> exists M0, forall N, M0 <= INR (S N) -> forall main, veerman_amplitude.main_resonance f g N main ->
  (exists w, 0 < w /\ Rabs (w / main - (2 * INR k - 1)) <= e /\ veerman_lesser.local_maximum (veerman_amplitude.amplitude f g N) w) /\
  forall w, Rabs (w / main - (2 * INR k - 1)) <= e -> veerman_amplitude.amplitude f g N w < veerman_amplitude.amplitude f g N main).
