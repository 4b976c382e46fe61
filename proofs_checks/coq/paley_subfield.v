(* Theorems over any field, read in the complex numbers: countably many complex numbers lie in a subfield that is a field in the sense
   of the library (its elements are expressions, up to having one value), with determinants that have the same value. *)
Set Warnings "-notation-overridden,-ambiguous-paths".
From mathcomp Require Import all_ssreflect all_algebra generic_quotient.
From mathcomp Require Import ring zify.
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Flockproof Require Import RealSums paley_model.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Import GRing.Theory.
Delimit Scope nat_scope with N.
Delimit Scope ring_scope with F.

Section Subfield.
Variable p : nat -> C.
Notation expr := (GenTree.tree nat).
Fixpoint value (e : expr) : C :=
  match e with
  | GenTree.Leaf i => p i
  | GenTree.Node 0 [:: a; b] => Cplus (value a) (value b)
  | GenTree.Node _ [:: a; b] => Cmult (value a) (value b)
  | GenTree.Node 0 [:: a] => Copp (value a)
  | GenTree.Node _ [:: a] => Cinv (value a)
  | GenTree.Node 0 _ => RtoC 0
  | GenTree.Node _ _ => RtoC 1
  end.
Definition same (a b : expr) : bool := Ceq_dec (value a) (value b).
Lemma sameP a b : reflect (value a = value b) (same a b).
Proof. by rewrite /same; case: (Ceq_dec (value a) (value b)) => h; constructor. Qed.
Lemma same_refl : reflexive same. Proof. by move=> a; apply/sameP. Qed.
Lemma same_sym : symmetric same. Proof. by move=> a b; apply/sameP/sameP. Qed.
Lemma same_trans : transitive same. Proof. by move=> b a c /sameP E /sameP E'; apply/sameP; rewrite E. Qed.
Canonical same_equiv := EquivRel same same_refl same_sym same_trans.
Definition subfield := {eq_quot same_equiv}%qT.
Canonical subfield_eqType := [eqType of subfield].
Canonical subfield_choiceType := [choiceType of subfield].
Canonical subfield_eqQuotType := [eqQuotType same_equiv of subfield].

Definition phi (x : subfield) : C := value (repr x).
Lemma phi_pi e : phi (\pi_subfield e)%qT = value e.
Proof. by apply/sameP; rewrite -[same _ _]/(same_equiv _ _) -eqmodE reprK. Qed.
Lemma phi_inj : injective phi.
Proof. by move=> x y /sameP E; rewrite -[x]reprK -[y]reprK; apply/eqmodP. Qed.

Definition op0 t : subfield := (\pi_subfield (GenTree.Node t [::]))%qT.
Definition op1 t (x : subfield) : subfield := (\pi_subfield (GenTree.Node t [:: repr x]))%qT.
Definition op2 t (x y : subfield) : subfield := (\pi_subfield (GenTree.Node t [:: repr x; repr y]))%qT.
Lemma phi_add x y : phi (op2 0 x y) = Cplus (phi x) (phi y). Proof. by rewrite phi_pi. Qed.
Lemma phi_mul x y : phi (op2 1 x y) = Cmult (phi x) (phi y). Proof. by rewrite phi_pi. Qed.
Lemma phi_opp x : phi (op1 0 x) = Copp (phi x). Proof. by rewrite phi_pi. Qed.
Lemma phi_inv x : phi (op1 1 x) = Cinv (phi x). Proof. by rewrite phi_pi. Qed.
Lemma phi_0 : phi (op0 0) = RtoC 0. Proof. by rewrite phi_pi. Qed.
Lemma phi_1 : phi (op0 1) = RtoC 1. Proof. by rewrite phi_pi. Qed.

Let P := (phi_add, phi_mul, phi_opp, phi_0, phi_1).
Lemma addA : associative (op2 0). Proof. by move=> x y z; apply: phi_inj; rewrite !P Cplus_assoc. Qed.
Lemma addC : commutative (op2 0). Proof. by move=> x y; apply: phi_inj; rewrite !P Cplus_comm. Qed.
Lemma add0 : left_id (op0 0) (op2 0). Proof. by move=> x; apply: phi_inj; rewrite !P Cplus_0_l. Qed.
Lemma addN : left_inverse (op0 0) (op1 0) (op2 0). Proof. by move=> x; apply: phi_inj; rewrite !P Cplus_comm Cplus_opp_r. Qed.
Definition zmod_mixin := ZmodMixin addA addC add0 addN.
Canonical subfield_zmodType := ZmodType subfield zmod_mixin.
Lemma mulA : associative (op2 1). Proof. by move=> x y z; apply: phi_inj; rewrite !P Cmult_assoc. Qed.
Lemma mulC : commutative (op2 1). Proof. by move=> x y; apply: phi_inj; rewrite !P Cmult_comm. Qed.
Lemma mul1 : left_id (op0 1) (op2 1). Proof. by move=> x; apply: phi_inj; rewrite !P Cmult_1_l. Qed.
Lemma mulDl : left_distributive (op2 1) (op2 0). Proof. by move=> x y z; apply: phi_inj; rewrite !P Cmult_plus_distr_r. Qed.
Lemma one_neq0 : op0 1 != op0 0.
Proof. by apply/eqP=> /(congr1 phi); rewrite !P => - []; lra. Qed.
Definition ring_mixin := ComRingMixin mulA mulC mul1 mulDl one_neq0.
Canonical subfield_ringType := RingType subfield ring_mixin.
Canonical subfield_comRingType := ComRingType subfield mulC.
Lemma mulV (x : subfield) : x != op0 0 -> op2 1 (op1 1 x) x = op0 1.
Proof.
move=> /eqP x0; apply: phi_inj; rewrite !P phi_inv; apply: Cinv_l => Z; apply: x0; apply: phi_inj; by rewrite Z P.
Qed.
Lemma inv0 : op1 1 (op0 0) = op0 0.
Proof.
apply: phi_inj; rewrite phi_inv !P /Cinv /RtoC /=; congr pair; rewrite /Rdiv; ring.
Qed.
Definition unit_mixin := FieldUnitMixin mulV inv0.
Canonical subfield_unitRing := UnitRingType subfield unit_mixin.
Canonical subfield_comUnitRing := [comUnitRingType of subfield].
Lemma field_axiom : GRing.Field.mixin_of subfield_unitRing. Proof. by []. Qed.
Definition idomain_axiom := FieldIdomainMixin field_axiom.
Canonical subfield_idomainType := IdomainType subfield idomain_axiom.
Canonical subfield_fieldType := FieldType subfield field_axiom.
Definition given i : subfield := (\pi_subfield (GenTree.Leaf i))%qT.
Lemma phi_given i : phi (given i) = p i. Proof. by rewrite phi_pi. Qed.
End Subfield.
