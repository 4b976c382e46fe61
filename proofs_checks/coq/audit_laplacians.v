(* Audit of the eigenvalues of Laplacians: each theorem of theorems.tsv with its statement written out; the objects of the statements are restated first. *)
Set Warnings "-notation-overridden,-ambiguous-paths".
From mathcomp Require Import all_ssreflect all_algebra.
From Flockproof Require chazelle_model laplacian_edges.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Import GRing.Theory Num.Theory.
Local Open Scope ring_scope.

Check (fun n (G : rel 'I_n) => erefl : chazelle_model.network G = (symmetric G /\ irreflexive G)).
Check (fun n (G : rel 'I_n) i => erefl : chazelle_model.degree G i = #|[pred j | G i j]|).
Check (fun (R : realFieldType) n (G : rel 'I_n) i j => mxE _ _ i j : chazelle_model.laplacian R G i j =
  if i == j then (chazelle_model.degree G i)%:R else if G i j then -1 else 0).
Check (fun (R : rcfType) m (A : 'M[R]_m.+1) lam => erefl : laplacian_edges.eigenvalues_of A lam = (exists U : 'M[R]_m.+1,
  [/\ U^T *m U = 1%:M, A *m U = U *m diag_mx (\row_k lam k) & forall j k : 'I_m.+1, (j <= k)%N -> lam k <= lam j])).
(* there are such numbers, the roots of the characteristic polynomial with their multiplicities *)
Check (@laplacian_edges.laplacian_eigenvalues : forall (R : rcfType) m (G : rel 'I_m.+1), chazelle_model.network G ->
  (exists lam, laplacian_edges.eigenvalues_of (chazelle_model.laplacian R G) lam) /\
  forall lam, laplacian_edges.eigenvalues_of (chazelle_model.laplacian R G) lam -> char_poly (chazelle_model.laplacian R G) = \prod_k ('X - (lam k)%:P)).
(* tanner2.cor2_merris *)
Check (@laplacian_edges.new_edge : forall (R : rcfType) (m : nat) (G G' : rel 'I_m.+1) (p q : 'I_m.+1), chazelle_model.network G -> p != q -> ~~ G p q ->
  (forall i j, G' i j = [|| G i j, (i == p) && (j == q) | (i == q) && (j == p)]) ->
  forall lam mu : 'I_m.+1 -> R, laplacian_edges.eigenvalues_of (chazelle_model.laplacian R G) lam -> laplacian_edges.eigenvalues_of (chazelle_model.laplacian R G') mu ->
  (forall k, lam k <= mu k) /\ \sum_k mu k = \sum_k lam k + 2%:R).
