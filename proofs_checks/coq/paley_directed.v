(* Paley and others: a circulant graph, directed or not, has a balanced stationary point of W_1.  All partial derivatives at the splay arrangement are equal,
   because both the graph and the one with all arcs turned round have it as an eigenvector, and they add up to zero.
     paley.balexist. *)
From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums paley_model paley_phase paley_laplacian paley_gradient paley_fourier.
Open Scope R_scope.

Definition turned_round (adj : graph) : graph := fun k j => adj j k.
Lemma circulant_round n adj s : circulant n adj s -> circulant n (turned_round adj) (fun d => s ((n - d) mod n)%nat).
Proof.
  intros C k j Hk Hj. unfold turned_round. rewrite (C j k Hj Hk). f_equal. destruct (Nat.lt_total j k) as [L|[->|L]].
  - rewrite (Nat.mod_small (j + n - k)) by lia. replace (k + n - j)%nat with ((k - j) + 1 * n)%nat by lia. rewrite Nat.mod_add by lia. f_equal. lia.
  - replace (k + n - k)%nat with (0 + 1 * n)%nat by lia. rewrite Nat.mod_add by lia. rewrite Nat.mod_small by lia. now rewrite Nat.sub_0_r, Nat.mod_same by lia.
  - replace (j + n - k)%nat with ((j - k) + 1 * n)%nat by lia. rewrite Nat.mod_add by lia. rewrite (Nat.mod_small (j - k)) by lia. f_equal. lia.
Qed.
Lemma sines_equal n adj s : (1 <= n)%nat -> circulant n adj s -> exists c, forall k, (k < n)%nat -> Sum n (fun j => lap n adj k j * sin (wave n 1 j - wave n 1 k)) = c.
Proof.
  intros Hn C. exists (snd (circulant_eigenvalue n s 1)). intros k Hk. rewrite <- inner_i_row.
  pose proof (circulant_eigenvector n adj s 1 Hn C k Hk) as E. cbv beta in E. change (fun k => expi (wave n 1 k)) with (phasors (wave n 1)) in E. rewrite E, inner_i_mul, inner_expi_self. ring.
Qed.
Theorem balanced_exists_directed n adj s : (2 <= n)%nat -> circulant n adj s -> exists th, balanced n th /\ stationary n (W1 n adj) th.
Proof.
  intros Hn C. assert (H1 : (1 <= n)%nat) by lia. pose proof (INR_pos n H1) as P. exists (wave n 1). split; [now apply splay_balanced|].
  destruct (sines_equal n adj s H1 C) as [c1 E1]. destruct (sines_equal n (turned_round adj) _ H1 (circulant_round n adj s C)) as [c2 E2].
  set (th := wave n 1) in *. set (d := fun k => Sum n (fun j => (lap n adj k j + lap n adj j k) * sin (th j - th k))).
  assert (T : forall k, (k < n)%nat -> Sum n (fun j => lap n adj j k * sin (th j - th k)) = c2).
  { intros k Hk. rewrite <- (E2 k Hk). apply Sum_ext. intros j Hj. unfold lap, turned_round, w. destruct (Nat.eq_dec j k) as [->|N]; [rewrite Rminus_eq_0, sin_0; ring|]. rewrite !delta_neq by congruence. ring. }
  assert (Eq : forall k, (k < n)%nat -> d k = c1 + c2).
  { intros k Hk. unfold d. rewrite <- (E1 k Hk), <- (T k Hk), <- Sum_plus. apply Sum_ext. intros; ring. }
  assert (Z : Sum n d = 0).
  { apply Sum_antisym. intros i j _ _. replace (th i - th j) with (- (th j - th i)) by ring. rewrite sin_neg. ring. }
  assert (Z0 : c1 + c2 = 0). { rewrite (Sum_ext n d (fun _ => c1 + c2) Eq), Sum_const in Z. apply Rmult_integral in Z. destruct Z; [lra|assumption]. }
  intros k Hk. pose proof (partial_cos_pairs n (lap n adj) th k Hk) as D. unfold partial in *. fold (d k) in D. rewrite (Eq k Hk), Z0 in D.
  apply (is_derive_ext (fun s => / (2 * INR n) * cos_pairs n (lap n adj) (upd th k s))); [intros t; unfold W1; symmetry; apply Q_phasors|].
  eapply D_eq; [apply D_scal; exact D|ring].
Qed.
