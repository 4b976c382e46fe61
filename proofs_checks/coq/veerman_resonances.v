(* Veerman, Stosic, Olvera, Table 1: the main resonance of 4, 8 and 16 followers, f = g = -1, in decimals.
     veerman.table1_numeric: no cell of these rows, in either pair of columns, is the resonance to its digits. *)
From Coq Require Import Reals ZArith QArith List Lra.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import veerman_complex veerman_front veerman_chain veerman_amplitude certificate_peaks gen_peaks.
From Flockproof Require veerman_numbers.
Import ListNotations.
Open Scope R_scope.

Lemma same_peak f g N lo hi a b f' g' lo' hi' a' b' : has_peak f g N lo hi a b ->
  f = f' -> g = g' -> lo = lo' -> hi = hi' -> a = a' -> b = b' -> has_peak f' g' N lo' hi' a' b'.
Proof. now intros H <- <- <- <- <- <-. Qed.
Ltac decimals := unfold Q2R, Qnum, Qden; lra.

Theorem resonance_4 : has_peak (-1) (-1) 3 0.27310829 0.27310884 4.6548995380734 4.654899538074.
Proof. eapply same_peak; [exact veerman_table1_numeric_M_4|decimals..]. Qed.
Theorem resonance_8 : has_peak (-1) (-1) 7 0.13827819 0.13827847 9.2043186764187 9.2043186764198.
Proof. eapply same_peak; [exact veerman_table1_numeric_M_8|decimals..]. Qed.
Theorem resonance_16 : has_peak (-1) (-1) 15 0.069350142 0.069350282 18.357835519798 18.357835519801.
Proof. eapply same_peak; [exact veerman_table1_numeric_M_16|decimals..]. Qed.

Lemma peak_of N lo hi a b : 0 < lo -> has_peak (-1) (-1) N lo hi a b ->
  (exists w, main_resonance (-1) (-1) N w) /\ forall w, main_resonance (-1) (-1) N w -> lo < w < hi /\ a <= amplitude (-1) (-1) N w < b.
Proof.
  intros L (_ & _ & (w & W & A & M) & O). split; [exists w; split; [lra|exact M]|].
  intros v [V0 V]. pose proof (V w ltac:(lra)) as Vw. pose proof (M v V0) as Mv.
  destruct (Rlt_dec lo v) as [L1|L1], (Rlt_dec v hi) as [L2|L2]; [split; lra| | |];
    pose proof (O v V0 ltac:(tauto)); lra.
Qed.
(* a row of the table and the number N + 1 of followers: there is a strongest response, and no cell is its frequency or size *)
Definition no_cell_is_true (row : R * veerman_numbers.cell * veerman_numbers.cell * veerman_numbers.cell * veerman_numbers.cell) (N : nat) : Prop :=
  match row with (_, nf, na, tf, ta) =>
    (exists w, main_resonance (-1) (-1) N w) /\ forall w, main_resonance (-1) (-1) N w ->
      ~ veerman_numbers.agrees nf w /\ ~ veerman_numbers.agrees na (amplitude (-1) (-1) N w) /\
      ~ veerman_numbers.agrees tf w /\ ~ veerman_numbers.agrees ta (amplitude (-1) (-1) N w)
  end.
Theorem table_rows_fail : Forall2 no_cell_is_true (firstn 3 veerman_numbers.table) [3; 7; 15]%nat.
Proof.
  assert (K : forall c x, snd c < fst c - x \/ snd c < x - fst c -> ~ veerman_numbers.agrees c x).
  { unfold veerman_numbers.agrees. intros c x [H|H] A; apply Rabs_le_between in A; lra. }
  assert (Row : forall N lo hi a b row, 0 < lo -> has_peak (-1) (-1) N lo hi a b ->
    (forall w m, lo < w < hi -> a <= m < b -> match row with (_, nf, na, tf, ta) =>
       ~ veerman_numbers.agrees nf w /\ ~ veerman_numbers.agrees na m /\ ~ veerman_numbers.agrees tf w /\ ~ veerman_numbers.agrees ta m end) ->
    no_cell_is_true row N).
  { intros N lo hi a b [[[[y nf] na] tf] ta] L H R. destruct (peak_of N lo hi a b L H) as [E U]. split; [exact E|].
    intros w W. destruct (U w W) as [U1 U2]. now apply (R w _ U1 U2). }
  unfold veerman_numbers.table. cbn [firstn]. repeat apply Forall2_cons; [| | |apply Forall2_nil].
  - refine (Row _ _ _ _ _ _ _ resonance_4 _); [lra|]. intros w m W M. repeat split; apply K; cbn [fst snd]; lra.
  - refine (Row _ _ _ _ _ _ _ resonance_8 _); [lra|]. intros w m W M. repeat split; apply K; cbn [fst snd]; lra.
  - refine (Row _ _ _ _ _ _ _ resonance_16 _); [lra|]. intros w m W M. repeat split; apply K; cbn [fst snd]; lra.
Qed.

(* Other gains, f = -4 and g = -1/3, with 6 followers. *)
Theorem resonance_6_other_gains : has_peak (-4) (-1/3) 5 0.36913899 0.36913974 41.159656756735 41.159656756741.
Proof.
  eapply same_peak; [apply (peak_certificate (-4 # 1) (-1 # 3) 5 (36913899 # 100000000) (36913974 # 100000000)
    (36913936731909 # 100000000000000) (41159656756735 # 1000000000000) (41159656756741 # 1000000000000) 64);
    vm_cast_no_check (eq_refl true) | decimals..].
Qed.
(* What the check refuses: the range of 4 followers beside the peak, with its ends exchanged, for 5 followers, with an
   lower amplitude that is not reached, an upper one that is exceeded, a lower one that is exceeded outside, one of 0. *)
Definition check_4 (N : nat) (lo hi : Z) (least most : Z) : bool :=
  peak_check (-1 # 1) (-1 # 1) N (lo # 100000000) (hi # 100000000) (27310856427488 # 100000000000000)
    (least # 10000000000000) (most # 10000000000000) 64.
Example accepted : check_4 3 27310829 27310884 46548995380734 46548995380740 = true.
Proof. vm_cast_no_check (eq_refl true). Qed.
Example refused : forallb negb
  [check_4 3 27310857 27310884 46548995380734 46548995380740; check_4 3 27310884 27310829 46548995380734 46548995380740;
   check_4 4 27310829 27310884 46548995380734 46548995380740; check_4 3 27310829 27310884 46548995380740 46548995380745;
   check_4 3 27310829 27310884 46548995380734 46548995380738; check_4 3 27310829 27310884 46548995300000 46548995380740;
   check_4 3 27310829 27310884 0 46548995380740] = true.
Proof. vm_cast_no_check (eq_refl true). Qed.
