(* Three vectors of space over an integral domain are dependent iff their determinant vanishes.
   Definitions:
     rows x y z       the matrix with these rows
     dependent x y z  a x + b y + c z = 0 for some a, b, c that are not all zero *)
From Torse Require Import Prelude Points.

Section Determinants.
Variable R : comRingType.

Lemma det2 (A : 'M[R]_2) : \det A = A 0 0 * A 1 1 - A 0 1 * A 1 0.
Proof.
rewrite (expand_det_row _ 0) !big_ord_recl big_ord0 /cofactor !det_mx11 !mxE /= addr0 expr0 expr1 mul1r mulN1r mulrN.
by congr (_ * _ - _ * _); congr (A _ _); apply/val_inj.
Qed.

Lemma det3 (A : 'M[R]_3) (i0 := 0 : 'I_3) (i1 := 1 : 'I_3) (i2 := 2%:R : 'I_3) :
  \det A = A i0 i0 * (A i1 i1 * A i2 i2 - A i1 i2 * A i2 i1) - A i0 i1 * (A i1 i0 * A i2 i2 - A i1 i2 * A i2 i0)
           + A i0 i2 * (A i1 i0 * A i2 i1 - A i1 i1 * A i2 i0).
Proof.
rewrite (expand_det_row _ 0) !big_ord_recl big_ord0 /cofactor !det2 !mxE /= addr0.
rewrite expr0 expr1 -signr_odd /= expr0 !mul1r mulN1r mulrN addrA.
by congr (_ * (_ * _ - _ * _) - _ * (_ * _ - _ * _) + _ * (_ * _ - _ * _)); congr (A _ _); apply/val_inj.
Qed.
End Determinants.

Section Dependence.
Variable R : idomainType.
Implicit Types x y z : 'rV[R]_3.

Definition rows x y z : 'M[R]_3 := \matrix_(i, j) nth 0 [:: x; y; z] i 0 j.
Definition dependent x y z := exists a b c : R, (a, b, c) != (0, 0, 0) /\ a *: x + b *: y + c *: z = 0.

Lemma rowsE x y z j :
  [/\ rows x y z 0 j = x 0 j, rows x y z 1 j = y 0 j & rows x y z 2%:R j = z 0 j].
Proof. by split; rewrite mxE. Qed.

Lemma coordinatesE x : [/\ x_ x = x 0 0, y_ x = x 0 1 & z_ x = x 0 2%:R].
Proof. by split; congr (x _ _); apply/val_inj. Qed.

Lemma triple_det x y z : triple x y z = \det (rows x y z).
Proof.
rewrite det3 tripleE; case: (coordinatesE x) (coordinatesE y) (coordinatesE z) => -> -> -> [-> -> ->] [-> -> ->].
case: (rowsE x y z 0) (rowsE x y z 1) (rowsE x y z 2%:R) => -> -> -> [-> -> ->] [-> -> ->].
move: (x 0 0) (x 0 1) (x 0 2%:R) (y 0 0) (y 0 1) (y 0 2%:R) (z 0 0) (z 0 1) (z 0 2%:R) => x0 x1 x2 y0 y1 y2 z0 z1 z2.
ring.
Qed.

(* Cramer: $[x,y,z]=0$ iff $x,y,z$ are dependent. *)
Theorem triple_dependent x y z : triple x y z = 0 <-> dependent x y z.
Proof.
have mul (v : 'rV[R]_3) : v *m rows x y z = v 0 0 *: x + v 0 1 *: y + v 0 2%:R *: z.
  apply/rowP=> k; rewrite !mxE !big_ord_recl big_ord0 !mxE /= addr0 addrA.
  by congr (_ * _ + _ * _ + _ * _); congr (v _ _); apply/val_inj.
rewrite triple_det; split=> [/eqP/det0P[v nz e]|[a [b [c [nz e]]]]].
  exists (v 0 0), (v 0 1), (v 0 2%:R); rewrite -mul e; split=> //.
  apply: contraNneq nz => -[v0 v1 v2]; apply/eqP/rowP=> -[[|[|[|//]]] lt_i]; rewrite [RHS]mxE.
  - by rewrite -v0; congr (v _ _); apply/val_inj.
  - by rewrite -v1; congr (v _ _); apply/val_inj.
  - by rewrite -v2; congr (v _ _); apply/val_inj.
apply/eqP/det0P; exists (\row_k nth 0 [:: a; b; c] k); last by rewrite mul !mxE.
apply: contraNneq nz => /rowP h; apply/eqP; have := (h 0, h 1, h 2%:R); rewrite !mxE /=.
by move=> -[[-> ->] ->].
Qed.

End Dependence.
