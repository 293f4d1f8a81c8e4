(* Points as row vectors, and the vector algebra of space.
   Definitions:
     coord c k              coordinate k of the points c
     pblossom u c v         the blossom of points, coordinate by coordinate
     pcurve n u c, pvelocity n u c   the curve and c'/n of points, rows of polynomials; pderiv the derivative
     x_ p, y_ p, z_ p       the coordinates of a point of space
     triple a b c           the determinant [a, b, c];  cross a b;  dot a b
     developable c d        [d', c', d - c] is the zero polynomial *)
From Torse Require Import Prelude Blossom Curves.

(* Two equations say the same where the difference of the sides of the one is that of the other. *)
Lemma eq_of_diff (U : zmodType) (a b a' b' : U) : a - b = b' - a' -> a = b <-> a' = b'.
Proof.
move=> e; split=> h; apply/eqP; first by rewrite eq_sym -subr_eq0 -e h subrr.
by rewrite -subr_eq0 e h subrr.
Qed.

Section Vectors.
Variables (R : comUnitRingType) (m : nat).
Implicit Types (u : nat -> R) (c : nat -> 'rV[R]_m).

Definition coord c k i := c i 0 k.
Definition pblossom u c v : 'rV[R]_m := \row_k blossom u (coord c k) v.
End Vectors.

Section Space.
Variable R : comUnitRingType.
Implicit Types a b c : 'rV[R]_3.

Definition x_ a := a 0 (@Ordinal 3 0 isT).
Definition y_ a := a 0 (@Ordinal 3 1 isT).
Definition z_ a := a 0 (@Ordinal 3 2 isT).
Definition vec (x y z : R) : 'rV[R]_3 := \row_k nth 0 [:: x; y; z] k.
Definition cross a b := vec (y_ a * z_ b - z_ a * y_ b) (z_ a * x_ b - x_ a * z_ b) (x_ a * y_ b - y_ a * x_ b).
Definition dot a b := x_ a * x_ b + y_ a * y_ b + z_ a * z_ b.
Definition triple a b c := dot a (cross b c).

Lemma row3P a b : x_ a = x_ b -> y_ a = y_ b -> z_ a = z_ b -> a = b.
Proof.
move=> ex ey ez; apply/rowP=> -[[|[|[|//]]] lt_i].
- by rewrite (_ : Ordinal _ = @Ordinal 3 0 isT) //; apply/val_inj.
- by rewrite (_ : Ordinal _ = @Ordinal 3 1 isT) //; apply/val_inj.
- by rewrite (_ : Ordinal _ = @Ordinal 3 2 isT) //; apply/val_inj.
Qed.

Lemma tripleE a b c : triple a b c =
  x_ a * (y_ b * z_ c - z_ b * y_ c) + y_ a * (z_ b * x_ c - x_ b * z_ c) + z_ a * (x_ b * y_ c - y_ b * x_ c).
Proof. by rewrite /triple /dot /cross /x_ /y_ /z_ /vec !mxE. Qed.

(* Sums and multiples of points given by their coordinates: quicker than entry by entry. *)
Section Coordinates.
Variables s p q r x y z : R.

Lemma vec0 : 0 = vec 0 0 0.
Proof. by apply: row3P; rewrite /x_ /y_ /z_ !mxE. Qed.

Lemma vecD : vec p q r + vec x y z = vec (p + x) (q + y) (r + z).
Proof. by apply: row3P; rewrite /x_ /y_ /z_ !mxE. Qed.

Lemma vecN : - vec x y z = vec (- x) (- y) (- z).
Proof. by apply: row3P; rewrite /x_ /y_ /z_ !mxE. Qed.

Lemma vecZ : s *: vec x y z = vec (s * x) (s * y) (s * z).
Proof. by apply: row3P; rewrite /x_ /y_ /z_ !mxE. Qed.

Lemma coords : vec p q r = vec x y z -> [/\ p = x, q = y & r = z].
Proof. by move=> /rowP e; have := (e (@Ordinal 3 0 isT), e (@Ordinal 3 1 isT), e (@Ordinal 3 2 isT)); rewrite !mxE => -[[]]. Qed.
End Coordinates.
End Space.

Notation vecE := (vecZ, vecN, vecD).

(* vector_identity: an identity of row vectors or determinants of space, coordinate by coordinate. *)
Ltac coordinates := rewrite ?tripleE /dot /cross /x_ /y_ /z_ /vec ?mxE /=.

(* hide_entries: every entry of a matrix becomes a variable, which `ring` likes better. *)
Ltac hide_entries := repeat match goal with |- context [@fun_of_matrix ?T ?a ?b ?A ?i ?j] => move: (@fun_of_matrix T a b A i j) => ? end.

(* by_entries k: an equation of rows becomes that of their entries k, which the goal no longer shows to be entries. *)
Ltac by_entries k :=
  apply/rowP=> k; rewrite ?mxE; hide_entries.

Section Curves3.
Variables (F : fieldType) (m : nat).
Implicit Types (u : nat -> F) (c d : nat -> 'rV[F]_m).

Definition pcurve n u c : 'rV[{poly F}]_m := \row_k curve n u (coord c k).
Definition pvelocity n u c : 'rV[{poly F}]_m := \row_k velocity n u (coord c k).
Definition pderiv (p : 'rV[{poly F}]_m) : 'rV[{poly F}]_m := map_mx (@deriv F) p.

Lemma pderiv_curve n u c : span n u -> pderiv (pcurve n u c) = pvelocity n u c *+ n.
Proof. by move=> sp; apply/rowP=> k; rewrite mulmxnE !mxE blossoms_derivative. Qed.
End Curves3.

Definition developable (F : fieldType) (c d : 'rV[{poly F}]_3) := triple (pderiv d) (pderiv c) (d - c) = 0.
