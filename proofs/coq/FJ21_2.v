(* FJ21, section 2: the condition of developability for rational curves.
   Curves are homogeneous rows (weight, weight times point) of polynomials; c = affine p, d = affine q are rows of rational functions of t.
   Definitions:
     rows4 p q r s          the matrix with these rows
     dependent4 p q r s     a p + b q + c r + d s = 0 for some a, b, c, d that are not all zero
     rational_developable p q   (d - c).(c' x d') = 0, the condition (2.1), for c = affine p, d = affine q *)
From Torse Require Import Prelude Blossom Curves Points Dependence Functions BZZ19_3.

Section Plane.
Variable R : idomainType.
Implicit Types a b w : 'rV[R]_3.

(** FJ21.2.1 ruling: $(d-c)\cdot(c'\times d')=-[\,b_{tv},b_t,b_v\,](t,v)$ for every $v$, with $a=c'$, $b=d'$, $w=d-c$. *)
Theorem FJ21_2_1_ruling a b w v : triple w a b = - triple (b - a) ((1 - v) *: a + v *: b) w.
Proof. by coordinates; hide_entries; ring. Qed.

(** FJ21.2.1 plane: $(d-c)\cdot(c'\times d')=0$ iff one plane $N^\perp$ contains $b_t=(1-v)c'+vd'$ and $b_v=d-c$ at every point of the ruling.
    Paper: "the tangent plane"; at a singular point of the surface there is none, and $N^\perp$ is any plane that serves. *)
Theorem FJ21_2_1_plane a b w : triple w a b = 0 <->
  exists N, [/\ N != 0, dot N w = 0 & forall v, dot N ((1 - v) *: a + v *: b) = 0].
Proof.
rewrite BZZ19_7_common; split=> [] [N [nz]].
  move=> ea eb ew; exists N; split=> // v.
  by transitivity ((1 - v) * dot N a + v * dot N b); [coordinates; ring | rewrite ea eb !mulr0 addr0].
move=> ew ev; exists N; split=> //; first by have := ev 0; rewrite subr0 scale1r scale0r addr0.
by have := ev 1; rewrite subrr scale0r scale1r add0r.
Qed.
End Plane.

Section Determinant.
Variable R : idomainType.
Implicit Types p q r s : 'rV[R]_4.

Definition rows4 p q r s : 'M[R]_4 := \matrix_(i, j) nth 0 [:: p; q; r; s] i 0 j.
Definition dependent4 p q r s := exists a b c d : R, (a, b, c, d) != (0, 0, 0, 0) /\ a *: p + b *: q + c *: r + d *: s = 0.

Lemma det_rows4 p q r s : \det (rows4 p q r s) =
  weight p * triple (place q) (place r) (place s) - weight q * triple (place p) (place r) (place s)
  + weight r * triple (place p) (place q) (place s) - weight s * triple (place p) (place q) (place r).
Proof.
rewrite (expand_det_col _ 0) !big_ord_recl big_ord0 /cofactor addr0 !triple_det.
have minor i : row' i (col' 0 (rows4 p q r s)) = \matrix_(k, j) place (nth 0 [:: p; q; r; s] (lift i k)) 0 j.
  by apply/matrixP=> k j; rewrite !mxE.
rewrite !minor !mxE /= !addn0 /bump /= !exprS !expr0 !mulr1 !mulrN !mulr1 !mul1r !mulN1r !mulrN opprK mulN1r mulrN !mul1r !addrA.
congr (_ - _ + _ - _); congr (_ * _); apply: (congr1 (@determinant R 3));
  by apply/matrixP=> -[[|[|[|//]]] lt_i] j; rewrite !mxE.
Qed.

Lemma mul_rows4 (v : 'rV[R]_4) p q r s : v *m rows4 p q r s = v 0 0 *: p + v 0 1 *: q + v 0 2%:R *: r + v 0 3%:R *: s.
Proof.
apply/rowP=> k; rewrite !mxE !big_ord_recl big_ord0 !mxE /= addr0 !addrA.
by congr (_ * _ + _ * _ + _ * _ + _ * _); congr (v _ _); apply/val_inj.
Qed.

(* Four combinations of four rows: their determinant is the product. *)
Lemma det_combinations (a b c d : seq R) p q r s
    (x := fun v : seq R => v`_0 *: p + v`_1 *: q + v`_2 *: r + v`_3 *: s) (y := fun v : seq R => \row_k v`_(val k) : 'rV[R]_4) :
  \det (rows4 (x a) (x b) (x c) (x d)) = \det (rows4 (y a) (y b) (y c) (y d)) * \det (rows4 p q r s).
Proof.
have e v : x v = y v *m rows4 p q r s by rewrite mul_rows4 /y !mxE.
rewrite -det_mulmx; congr (\det _); apply/matrixP=> i j; rewrite mxE [RHS]mxE.
case: i => -[|[|[|[|//]]]] lt_i; rewrite /= e [LHS]mxE; apply: eq_bigr => k _; by rewrite [rows4 _ _ _ _ _ k]mxE.
Qed.

Lemma triple_vec (a b c d e f g h i : R) :
  triple (vec a b c) (vec d e f) (vec g h i) = a * (e * i - f * h) + b * (f * g - d * i) + c * (d * h - e * g).
Proof. by rewrite tripleE /x_ /y_ /z_ !mxE. Qed.

Lemma place_seq (v : seq R) : place (\row_(k < 4) v`_k) = vec v`_1 v`_2 v`_3.
Proof. by apply/rowP=> -[[|[|[|//]]] lt_k]; rewrite !mxE. Qed.

Lemma weight_seq (v : seq R) : weight (\row_(k < 4) v`_k) = v`_0.
Proof. by rewrite /weight mxE. Qed.

(* Two rows p, p' and two rows q, q' in the place of points on their lines. *)
Lemma det_lines p p' q q' (a b : R) :
  \det (rows4 (p + a *: p') (p + b *: p') (q + a *: q') (q + b *: q')) = (b - a) ^+ 2 * \det (rows4 p p' q q').
Proof.
have := det_combinations [:: 1; a; 0; 0] [:: 1; b; 0; 0] [:: 0; 0; 1; a] [:: 0; 0; 1; b] p p' q q'.
by rewrite /= !scale0r !scale1r !addr0 !add0r => ->; congr (_ * _); rewrite det_rows4 !place_seq !weight_seq !triple_vec /=; ring.
Qed.

Lemma det_scaled p p' q q' (k : R) : \det (rows4 p (k *: p') q (k *: q')) = k ^+ 2 * \det (rows4 p p' q q').
Proof.
have := det_combinations [:: 1; 0; 0; 0] [:: 0; k; 0; 0] [:: 0; 0; 1; 0] [:: 0; 0; 0; k] p p' q q'.
by rewrite /= !scale0r !scale1r !addr0 !add0r => ->; congr (_ * _); rewrite det_rows4 !place_seq !weight_seq !triple_vec /=; ring.
Qed.

Lemma det_dependent p q r s : \det (rows4 p q r s) = 0 <-> dependent4 p q r s.
Proof.
split=> [/eqP/det0P[v nz e]|[a [b [c [d [nz e]]]]]].
  exists (v 0 0), (v 0 1), (v 0 2%:R), (v 0 3%:R); rewrite -mul_rows4 e; split=> //.
  apply: contraNneq nz => -[v0 v1 v2 v3]; apply/eqP/rowP=> -[[|[|[|[|//]]]] lt_i]; rewrite [RHS]mxE.
  - by rewrite -v0; congr (v _ _); apply/val_inj.
  - by rewrite -v1; congr (v _ _); apply/val_inj.
  - by rewrite -v2; congr (v _ _); apply/val_inj.
  - by rewrite -v3; congr (v _ _); apply/val_inj.
apply/eqP/det0P; exists (\row_k nth 0 [:: a; b; c; d] k); last by rewrite mul_rows4 !mxE.
apply: contraNneq nz => /rowP h; apply/eqP; have := (h 0, h 1, h 2%:R, h 3%:R); rewrite !mxE /=.
by move=> -[[[-> ->] ->] ->].
Qed.
End Determinant.

(* The determinant of the values and derivatives of two rational curves, in any field that holds them. *)
Lemma det_quotients (L : fieldType) (p p' q q' : 'rV[L]_4) (w := weight p) (om := weight q) : w != 0 -> om != 0 ->
  let slope (a b : 'rV[L]_4) := (weight a ^+ 2)^-1 *: (weight a *: place b - weight b *: place a) in
  w ^+ 2 * om ^+ 2 * triple (om^-1 *: place q - w^-1 *: place p) (slope p p') (slope q q') = - \det (rows4 p p' q q').
Proof.
move=> w0 om0 /=; rewrite det_rows4 -/w -/om; move: (weight p') (weight q') (place p) (place p') (place q) (place q') w0 om0.
move: w om => w om w' om' P P' Q Q' w0 om0; coordinates; hide_entries.
by field; rewrite w0 om0.
Qed.

Section Rational.
Variable F : fieldType.
Notation K := {fraction {poly F}}.
Notation "x %:F" := (@FracField.tofrac [idomainType of {poly F}] x).
Implicit Types (p q : 'rV[{poly F}]_4) (u : nat -> F) (c d : nat -> 'rV[F]_4) (a b : F) (n : nat).

Definition rational_developable p q := triple (affine q - affine p) (pfderiv (affine p)) (pfderiv (affine q)) = 0.

Lemma weight_fun p : (weight (pfun p) == 0) = (weight p == 0).
Proof. by rewrite /weight mxE tofrac_eq0. Qed.

Lemma pfderiv_affine p : weight p != 0 -> pfderiv (affine p) =
  (weight (pfun p) ^+ 2)^-1 *: (weight (pfun p) *: place (pfun (pderiv p)) - weight (pfun (pderiv p)) *: place (pfun p)).
Proof.
move=> w0; apply/rowP=> k; rewrite /affine /weight /place !mxE [_^-1 * (_)%:F]mulrC fderiv_div // tofracX [RHS]mulrC; congr (_ / _).
by rewrite tofracB !tofracM mulrC [X in _ - X]mulrC.
Qed.

Lemma weightE p : weight (pfun p) = (weight p)%:F.
Proof. by rewrite /weight mxE. Qed.

Lemma det_pfun p p' q q' : (\det (rows4 p p' q q'))%:F = \det (rows4 (pfun p) (pfun p') (pfun q) (pfun q')).
Proof. by rewrite -det_map_mx; congr (\det _); apply/matrixP=> -[[|[|[|[|//]]]] lt_i] j; rewrite !mxE. Qed.

(** FJ21.C3.1 tangents: $w^2\omega^2\,(d-c)\cdot(c'\times d')=-\det(p,p',q,q')$ for any rows of polynomials $p=(w,wc)$, $q=(\omega,\omega d)$.
    Hypotheses: the weights $w$, $\omega$ do not vanish identically: there are curves $c$, $d$. *)
Theorem FJ21_C3_1_tangents p q : weight p != 0 -> weight q != 0 ->
  ((weight p * weight q) ^+ 2)%:F * triple (affine q - affine p) (pfderiv (affine p)) (pfderiv (affine q))
    = - (\det (rows4 p (pderiv p) q (pderiv q)))%:F.
Proof.
move=> w0 om0; rewrite !pfderiv_affine // /affine exprMn tofracM !tofracX.
by rewrite det_pfun -det_quotients ?weight_fun // !weightE.
Qed.

(** FJ21.2.1 determinant: the surface of $c=p/w$ and $d=q/\omega$ is developable iff $\det(p,p',q,q')$ is the zero polynomial.
    Hypotheses: the weights $w$, $\omega$ do not vanish identically: there are curves $c$, $d$. *)
Theorem FJ21_2_1_determinant p q : weight p != 0 -> weight q != 0 ->
  rational_developable p q <-> \det (rows4 p (pderiv p) q (pderiv q)) = 0.
Proof.
move=> w0 om0; have := FJ21_C3_1_tangents w0 om0; rewrite /rational_developable => e; split=> h; move: e; rewrite h.
  by rewrite mulr0 => /eqP; rewrite eq_sym oppr_eq0 tofrac_eq0 => /eqP.
by move/eqP; rewrite tofrac0 oppr0 mulf_eq0 tofrac_eq0 expf_eq0 mulf_eq0 (negPf w0) (negPf om0) /= => /eqP.
Qed.

End Rational.
