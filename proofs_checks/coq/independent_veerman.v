(* Clauses of the claims about Veerman's paper, formalised from their words before the theorems were looked at. *)
From Coq Require Import Reals Lia List.
From Coquelicot Require Import Coquelicot.
Open Scope R_scope.

(* ---- systems (1), (2) on deviations: a leader 0 and followers 1, .., N + 1; rows of P_1, P_2 ---- *)
Definition p1 (x : nat -> C) (k : nat) : C := (x k - x (k - 1)%nat)%C.
Definition p2 (N : nat) (x : nat -> C) (k : nat) : C :=
  if Nat.eqb k (S N) then (x k - x (k - 1)%nat)%C else (x k - / 2 * (x (k - 1)%nat + x (k + 1)%nat))%C.
(* eigenvalue of a reduced matrix (x 0 = 0) and of M: x' = u, u' = f P x + g P u *)
Definition eig N (p : (nat -> C) -> nat -> C) (lam : C) := exists x : nat -> C, x 0%nat = 0%C /\ (exists k, (1 <= k <= S N)%nat /\ x k <> 0%C) /\
  forall k, (1 <= k <= S N)%nat -> p x k = (lam * x k)%C.
Definition eig_M N (p : (nat -> C) -> nat -> C) (f g : R) (nu : C) := exists x u : nat -> C, x 0%nat = 0%C /\ u 0%nat = 0%C /\
  (exists k, (1 <= k <= S N)%nat /\ (x k <> 0%C \/ u k <> 0%C)) /\
  forall k, (1 <= k <= S N)%nat -> u k = (nu * x k)%C /\ (RtoC f * p x k + RtoC g * p u k)%C = (nu * u k)%C.
Definition hurwitz N p f g := forall nu, eig_M N p f g nu -> fst nu < 0.
(* veerman.lem1 clauses 1, 2 *)
Definition lem1 : Prop := forall f g, ((forall N, hurwitz N p1 f g) <-> f < 0 /\ g < 0) /\ ((forall N, hurwitz N (p2 N) f g) <-> f < 0 /\ g < 0).
(* veerman.eigAK *)
Definition eigAK : Prop := forall (f g : R) (lam nu : C),
  ((exists a b : C, (a <> 0 \/ b <> 0)%C /\ b = (nu * a)%C /\ (lam * RtoC f * a + lam * RtoC g * b)%C = (nu * b)%C) <->
   (nu * nu - lam * RtoC g * nu - lam * RtoC f = 0)%C) /\
  forall s : C, (s * s)%C = ((lam * RtoC g) * (lam * RtoC g) + 4 * lam * RtoC f)%C ->
   ((nu * nu - lam * RtoC g * nu - lam * RtoC f = 0)%C <-> nu = (/ 2 * (lam * RtoC g + s))%C \/ nu = (/ 2 * (lam * RtoC g - s))%C).
(* veerman.specM clauses 3, 4 *)
Definition specM : Prop := forall N p (f g : R), p = p1 \/ p = p2 N ->
  (forall nu, eig_M N p f g nu <-> exists lam, eig N p lam /\ (nu * nu - lam * RtoC g * nu - lam * RtoC f = 0)%C) /\
  (f <> 0 -> ~ eig_M N p f g 0%C).
(* veerman.specP2 *)
Definition specP2 : Prop := forall N,
  (forall lam, eig N (p2 N) lam <-> exists k, (1 <= k <= S N)%nat /\ lam = RtoC (1 - cos ((2 * INR k - 1) * PI / (2 * (INR N + 1))))) /\
  (forall k l, (1 <= k <= S N)%nat -> (1 <= l <= S N)%nat -> k <> l ->
     cos ((2 * INR k - 1) * PI / (2 * (INR N + 1))) <> cos ((2 * INR l - 1) * PI / (2 * (INR N + 1)))).
(* beyond.veerman.decay_rate clauses 1 to 4 *)
Definition slowest N f g (r : R) := (exists nu, eig_M N (p2 N) f g nu /\ fst nu = - r) /\ forall nu, eig_M N (p2 N) f g nu -> fst nu <= - r.
Definition decay : Prop := forall f g, f < 0 -> g < 0 ->
  (forall N, INR N + 1 >= Rabs g / sqrt (Rabs f) -> slowest N f g (Rabs g * (1 - cos (PI / (2 * (INR N + 1)))) / 2)) /\
  (forall N, Rabs g * (1 - cos (PI / (2 * (INR N + 1)))) / 2 < PI ^ 2 * Rabs g / (16 * (INR N + 1) ^ 2)) /\
  (forall N, hurwitz N (p2 N) f g) /\
  ~ exists r, 0 < r /\ forall N nu, eig_M N (p2 N) f g nu -> fst nu <= - r.

(* ---- the responses to a leader e^{i w t}: amplitudes a_k, a_0 = 1 ---- *)
Definition z (f g w : R) : C := (f, w * g).
Definition response1 f g w (a : nat -> C) := a 0%nat = 1%C /\ forall k, (1 <= k)%nat -> (- RtoC (w ^ 2) * a k = z f g w * p1 a k)%C.
Definition response2 f g w N (a : nat -> C) := a 0%nat = 1%C /\ forall k, (1 <= k <= S N)%nat -> (- RtoC (w ^ 2) * a k = z f g w * p2 N a k)%C.
Definition gam f g w : C := ((z f g w + RtoC (w ^ 2)) / z f g w)%C.
Fixpoint power (x : C) n : C := match n with O => 1%C | S n => (x * power x n)%C end.
(* veerman.cor1, veerman.cor1_special *)
Definition cor1 : Prop := forall f g w a, z f g w <> 0%C -> gam f g w <> 0%C ->
  (response1 f g w a <-> a 0%nat = 1%C /\ forall k, a k = (/ power (gam f g w) k)%C).
Definition cor1_special : Prop := forall f g w a, f < 0 -> g < 0 -> w = sqrt (Rabs f) -> response1 f g w a ->
  forall k, a k = power (1 + Ci * RtoC (sqrt (Rabs f) / g))%C k.
(* veerman.gain_iff clauses 3, 4; veerman.gain_max clauses 2, 3, 4 *)
Definition gain_iff : Prop := forall f g w, f < 0 -> g < 0 -> 0 <= w -> (1 < Cmod (/ gam f g w)%C <-> 0 < w ^ 2 < 2 * Rabs f).
Definition gain_max : Prop := forall f g, f < 0 -> g < 0 ->
  let s := f ^ 2 / g ^ 2 * (sqrt (1 + 2 * g ^ 2 / Rabs f) - 1) in
  (forall w, 0 <= w -> (w ^ 2 = s <-> forall w', 0 <= w' -> Cmod (/ gam f g w')%C <= Cmod (/ gam f g w)%C)) /\ 0 < s < Rabs f.
(* veerman.lem2; the square root of gamma^2 - 1 enters by its square *)
Definition lem2 : Prop := forall f g w N a mp mm, f < 0 -> g < 0 -> 0 < w -> response2 f g w N a ->
  (mp + mm = 2 * gam f g w)%C -> (mp * mm = 1)%C ->
  (a (S N) * (power mm (S N) + power mp (S N)) = 2)%C.
(* veerman.lem2_eigvec clause 5 left out; veerman.cor2 *)
Definition cor2_1 : Prop := forall f g w mp mm, f < 0 -> g < 0 -> w <> 0 -> (mp + mm = 2 * gam f g w)%C -> (mp * mm = 1)%C -> Cmod mp <> Cmod mm.
Definition cor2_2 : Prop := forall f g w, f < 0 -> g < 0 -> w <> 0 -> exists K q, 0 <= q < 1 /\
  forall N a, response2 f g w N a -> Cmod (a (S N)) <= K * q ^ N.
(* ---- the main resonance of system (2): the frequency w > 0 of the largest amplitude of the last car ---- *)
Definition size f g N w A := exists a, response2 f g w N a /\ Cmod (a (S N)) = A.
Definition peak f g N w A := 0 < w /\ size f g N w A /\ forall w' A', 0 < w' -> size f g N w' A' -> A' <= A.
(* veerman.thm1_omega, thm1_amp, thm1_x clauses 3, 4: there is a main resonance, and every one is there *)
Definition thm1 : Prop := forall f g, f < 0 -> g < 0 -> exists K N0, forall N, (N0 <= N)%nat -> (exists w A, peak f g N w A) /\
  forall w A, peak f g N w A ->
    Rabs (w - sqrt (Rabs f) * PI / ((INR N + 1) * 2 * sqrt 2)) <= K / INR N ^ 3 /\
    Rabs (A - 8 * sqrt (2 * Rabs f) / (PI ^ 2 * Rabs g) * (INR N + 1)) <= K / INR N.
Definition thm1_x : Prop := forall f g, f < 0 -> g < 0 -> let x := PI ^ 2 * Rabs g / (8 * sqrt 2 * sqrt (Rabs f)) in
  exists K N0, forall N, (N0 <= N)%nat -> forall w A, peak f g N w A -> Rabs (A - (INR N + 1) / x) <= K / INR N /\
  forall mp mm, (mp + mm = 2 * gam f g w)%C -> (mp * mm = 1)%C -> Cmod mm <= Cmod mp ->
    Rabs (Cmod mp ^ S N - exp (x / (INR N + 1))) <= K / INR N ^ 3 /\ Rabs (Cmod mm ^ S N - exp (- x / (INR N + 1))) <= K / INR N ^ 3.
(* veerman.thm1_mod *)
Definition thm1_mod : Prop := forall f g, f < 0 -> g < 0 -> exists K e, 0 < e /\ forall w mp mm, 0 < w < e ->
  (mp + mm = 2 * gam f g w)%C -> (mp * mm = 1)%C -> Cmod mm <= Cmod mp ->
  Rabs (Cmod mp ^ 2 - (1 + sqrt 2 * w ^ 2 * Rabs g / (Rabs f * sqrt (Rabs f)))) <= K * w ^ 4 /\
  Rabs (Cmod mm ^ 2 - (1 - sqrt 2 * w ^ 2 * Rabs g / (Rabs f * sqrt (Rabs f)))) <= K * w ^ 4.
(* veerman.lem3 *)
Definition lem3 : Prop := forall f g (w : nat -> R) A, f < 0 -> g < 0 -> 0 < A ->
  (forall N, exists B, size f g N (w N) B /\ A <= B) -> is_lim_seq w 0.
(* veerman.cor3 clause 1: local maxima of the amplitude near (2k+1) times the main resonance *)
Definition cor3 : Prop := forall f g k, f < 0 -> g < 0 -> forall e, 0 < e -> exists N0, forall N, (N0 <= N)%nat ->
  forall w0 A0, peak f g N w0 A0 -> exists w A, Rabs (w - (2 * INR k + 1) * w0) <= e * w0 /\ size f g N w A /\
    exists r, 0 < r /\ forall w' A', Rabs (w' - w) < r -> size f g N w' A' -> A' <= A.
(* veerman.prop1 clauses 2, 3 *)
Definition prop1 : Prop := forall f g a0 D N a, f < 0 -> g < 0 -> 0 < a0 -> 0 < D -> response1 f g (sqrt (Rabs f)) a ->
  (a0 * Cmod (a (S N)) <= D <-> INR N + 1 <= 2 * ln (D / a0) / ln (1 + Rabs f / g ^ 2)).
(* veerman.prop2: N <= X D/a0 + o(D/a0) *)
Definition prop2 : Prop := forall f g, f < 0 -> g < 0 -> forall e, 0 < e -> exists Y, forall a0 D N w A, 0 < a0 -> 0 < D -> Y <= D / a0 ->
  peak f g N w A -> a0 * A <= D -> INR N <= (PI ^ 2 * Rabs g / (8 * sqrt 2 * sqrt (Rabs f)) + e) * (D / a0).
