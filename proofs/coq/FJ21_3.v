(* FJ21, section 3: equation (3.2), Proposition and Corollary 3.1.
   Definitions:
     last_point n u c a     c[t, ..., t, a], a point of the last step of de Casteljau's or de Boor's algorithm: c_0^{n-1}(t) for a = 0 or
                            a = u_{n-1}, c_1^{n-1}(t) for a = 1 or a = u_n
     coplanar a b c d       four points of space lie on a plane N.x = e, N not 0 *)
From Torse Require Import Prelude Blossom Curves Points Dependence Functions BZZ19_3 FJ21_2.

Section LastPoints.
Variables (F : fieldType) (m : nat).
Implicit Types (u : nat -> F) (c : nat -> 'rV[F]_m) (a b : F) (n : nat).

Definition last_point n u c a : 'rV[{poly F}]_m :=
  \row_k blossom (polys u) (polys (coord c k)) (at_ a%:P :: nseq n.-1 (at_ 'X)).

Lemma last_pointE n u c a : (0 < n)%N -> last_point n u c a = pcurve n u c + (a%:P - 'X) *: pvelocity n u c.
Proof.
case: n => // n _; apply/rowP=> k; rewrite !mxE (_ : at_ a%:P = comb 1 (at_ 'X) (a%:P - 'X) (direction _)); last first.
  by rewrite /comb /= !mul1r mulr1 mulr0 addr0 addrC subrK.
by rewrite (blossoms_multilinear _ _ [::]) mul1r.
Qed.

Lemma size_blossom_X n u (g : nat -> {poly F}) s : span n u -> (forall i, (size (g i) <= s)%N) ->
  (size (blossom (polys u) g (nseq n (at_ 'X))) <= s + n)%N.
Proof.
elim: n u g s => [|n ih] u g s sp sg /=; first by rewrite addn0.
rewrite addnS -addSn; apply: ih; first exact: span_shift.
move=> i; rewrite size_nseq /step /polys /= !mul1r -polyCB polyCV mulrC.
rewrite (leq_trans (size_mul_leq _ _)) //.
have s2 (x : F) : (size (x%:P - 'X)%R <= 2)%N.
  by rewrite -opprB size_opp size_XsubC.
have s2' (x : F) : (size ('X - x%:P)%R <= 2)%N by rewrite size_XsubC.
have sS (x y : {poly F}) : (size x <= 2)%N -> (size y <= s)%N -> (size (x * y)%R <= s.+1)%N.
  by move=> sx sy; rewrite (leq_trans (size_mul_leq _ _)) //; lia.
have := leq_trans (size_add _ _) (_ : (_ <= s.+1)%N); move=> sD.
apply: (@leq_trans (1 + s.+1).-1); last by [].
rewrite -!subn1 leq_sub2r // leq_add ?size_polyC_leq1 //.
by apply: sD; rewrite geq_max !sS.
Qed.

Lemma size_last_point n u c a k : (0 < n)%N -> span n u -> (size (last_point n u c a 0%R k) <= n)%N.
Proof.
case: n => // n _ sp; rewrite mxE /= size_nseq -add1n; apply: size_blossom_X; first exact: span_shift.
move=> i; rewrite /step /polys /= !mul1r -!polyCB polyCV -!polyCM -polyCD -polyCM; exact: size_polyC_leq1.
Qed.
End LastPoints.

Lemma size_det (F : fieldType) m k (A : 'M[{poly F}]_m) : (forall i j, (size (A i j) <= k.+1)%N) -> (size (\det A)%R <= (m * k).+1)%N.
Proof.
move=> sA; apply: (leq_trans (size_sum _ _ _)); apply/bigmax_leqP=> s _.
have sum_le : (\sum_(i < m) size (A i (perm.PermDef.fun_of_perm s i)) <= m * k.+1)%N.
  by rewrite -[X in (X * _)%N](card_ord m) -sum_nat_const; apply: leq_sum.
by rewrite mulr_sign; case: (perm.odd_perm _); rewrite ?size_opp (leq_trans (size_prod_leq _ _)) // cardT size_enum_ord leq_subLR addnS ltnS -mulnS.
Qed.

(* The algebra of (3.2) and of Proposition 3.1, in any field. *)
Lemma quotient_step (L : fieldType) (w v c e x y h : L) n : w != 0 -> w + x * v != 0 -> w + y * v != 0 -> h != 0 -> y - x = h ->
  (w ^+ 2)^-1 * (w * (e *+ n) - v *+ n * c)
    = n%:R * (w + x * v) * (w + y * v) / (h * w ^+ 2) * ((w + y * v)^-1 * (c + y * e) - (w + x * v)^-1 * (c + x * e)).
Proof.
rewrite -(mulr_natl e) -(mulr_natl v); move: (n%:R) => k w0 x0 y0 h0 eh; move: h0; rewrite -eh => h0.
by field; rewrite w0 x0 y0 h0.
Qed.

Lemma affine_step (L : fieldType) (p q : 'rV[L]_4) (x y h : L) n (c := fun r : 'rV[L]_4 => (weight r)^-1 *: place r) :
  weight p != 0 -> weight (p + x *: q) != 0 -> weight (p + y *: q) != 0 -> h != 0 -> y - x = h ->
  (weight p ^+ 2)^-1 *: (weight p *: place (q *+ n) - weight (q *+ n) *: place p)
    = (n%:R * weight (p + x *: q) * weight (p + y *: q) / (h * weight p ^+ 2)) *: (c (p + y *: q) - c (p + x *: q)).
Proof.
move=> w0 x0 y0 h0 eh; apply/rowP=> k; move: w0 x0 y0; rewrite /c /weight /place !mxE !mulmxnE => w0 x0 y0.
exact: quotient_step.
Qed.

Lemma det_points (L : fieldType) (p q r s : 'rV[L]_4) (c := fun x : 'rV[L]_4 => (weight x)^-1 *: place x) :
  weight p != 0 -> weight q != 0 -> weight r != 0 -> weight s != 0 ->
  \det (rows4 p q r s) = weight p * weight q * weight r * weight s * triple (c q - c p) (c r - c p) (c s - c p).
Proof.
rewrite det_rows4 /c; move: (weight p) (weight q) (weight r) (weight s) (place p) (place q) (place r) (place s).
have e (w : L) (x : 'rV[L]_3) : w != 0 -> x = w *: (w^-1 *: x) by move=> w0; rewrite scalerA mulfV // scale1r.
move=> wp wq wr ws P Q R S /e-/(_ P) eP /e-/(_ Q) eQ /e-/(_ R) eR /e-/(_ S) eS; move: eP eQ eR eS.
move: (wp^-1 *: P) (wq^-1 *: Q) (wr^-1 *: R) (ws^-1 *: S) => p' q' r' s' -> -> -> ->.
have scaled (i j k : L) (x y z : 'rV[L]_3) : triple (i *: x) (j *: y) (k *: z) = i * j * k * triple x y z by coordinates; hide_entries; ring.
have moved (x y z w : 'rV[L]_3) : triple (y - x) (z - x) (w - x) = triple y z w - triple x z w + triple x y w - triple x y z.
  by coordinates; hide_entries; ring.
by rewrite !scaled moved; ring.
Qed.

Definition coplanar (L : idomainType) (a b c d : 'rV[L]_3) :=
  exists N e, N != 0 /\ [/\ dot N a = e, dot N b = e, dot N c = e & dot N d = e].

Lemma triple_coplanar (L : idomainType) (a b c d : 'rV[L]_3) : triple (b - a) (c - a) (d - a) = 0 <-> coplanar a b c d.
Proof.
have dotB N (x y : 'rV[L]_3) : dot N (x - y) = dot N x - dot N y by coordinates; ring.
rewrite BZZ19_7_common; split=> [] [N].
  by case=> nz; rewrite !dotB => /eqP ec /eqP ed /eqP eb; move: eb ec ed; rewrite !subr_eq0 => /eqP eb /eqP ec /eqP ed; exists N, (dot N a).
by case=> e [nz [ea eb ec ed]]; exists N; rewrite !dotB ea eb ec ed subrr.
Qed.

Section Rational.
Variable F : fieldType.
Notation K := {fraction {poly F}}.
Notation "x %:F" := (@FracField.tofrac [idomainType of {poly F}] x).
Implicit Types (u : nat -> F) (c d : nat -> 'rV[F]_4) (a b : F) (n : nat).

(** FJ21.3.2 homogeneous: $(b-a)\,p'(t)=n\,(p[t^{\langle n-1\rangle},b]-p[t^{\langle n-1\rangle},a])$ for all coordinates, the weight among them.
    Hypotheses: the knots carry the piece, so that the curve has a meaning. *)
Theorem FJ21_3_2_homogeneous m n u (c : nat -> 'rV[F]_m) a b : span n u ->
  (b - a)%:P *: pderiv (pcurve n u c) = (last_point n u c b - last_point n u c a) *+ n.
Proof.
move=> sp; rewrite pderiv_curve // -scalerMnr; case: (posnP n) => [n0|n0]; first by rewrite [in _ *+ n]n0 [in RHS]n0 !mulr0n.
rewrite !last_pointE //; congr (_ *+ n).
by rewrite opprD addrACA subrr add0r -scalerBl polyCB opprB addrA subrK.
Qed.

(** FJ21.3.2 derivative: $c'(t)=\frac{n\,w_0^{n-1}w_1^{n-1}}{(b-a)\,w^2}\,(c_1^{n-1}-c_0^{n-1})$, where $c_0^{n-1}$, $c_1^{n-1}$ are the points of
    $p[t^{\langle n-1\rangle},a]$, $p[t^{\langle n-1\rangle},b]$: $a=0$, $b=1$ on $[0,1]$; $a=u_{n-1}$, $b=u_n$ on a piece of a spline.
    Hypotheses: $a\ne b$; the knots carry the piece and the weights $w$, $w_0^{n-1}$, $w_1^{n-1}$ do not vanish identically, so that the curve and the points have a meaning.
    Paper: states none of them; its formula is for $b-a=1$. *)
Theorem FJ21_3_2_derivative n u c a b (p := pcurve n u c) (p0 := last_point n u c a) (p1 := last_point n u c b) :
  span n u -> a != b -> weight p != 0 -> weight p0 != 0 -> weight p1 != 0 ->
  pfderiv (affine p) = ((n%:R * weight p0 * weight p1)%:F / ((b - a)%:P * weight p ^+ 2)%:F) *: (affine p1 - affine p0).
Proof.
move=> sp ab w0 a0 b0; rewrite (pfderiv_affine w0) (pderiv_curve c sp).
have -> : pfun (pvelocity n u c *+ n) = pfun (pvelocity n u c) *+ n by apply/rowP=> k; rewrite !(mxE, mulmxnE) tofracMn.
have [n0|n0] := posnP n.
  have zn : n%:R = 0 :> {poly F} by rewrite n0.
  have zq (r : 'rV[K]_4) : r *+ n = 0 by rewrite n0 mulr0n.
  have z0 : place 0 = 0 :> 'rV[K]_3 by apply/rowP=> k; rewrite !mxE.
  have wz : weight (0 : 'rV[K]_4) = 0 by rewrite /weight mxE.
  by rewrite zq zn !mul0r z0 wz !scale0r ?(scaler0, subr0).
have e x : pfun (last_point n u c x) = pfun p + (x%:P - 'X)%:F *: pfun (pvelocity n u c) by rewrite (last_pointE u c x n0) pfunD pfunZ.
have := (e a, e b); rewrite -/p0 -/p1; move: (pfun (pvelocity n u c)) => q; move: w0 a0 b0; clear e; clearbody p p0 p1 => w0 a0 b0 [e0 e1].
have -> : (n%:R * weight p0 * weight p1)%:F / ((b - a)%:P * weight p ^+ 2)%:F
    = n%:R * weight (pfun p0) * weight (pfun p1) / ((b - a)%:P%:F * weight (pfun p) ^+ 2).
  rewrite !weightE; move: (weight p0) (weight p1) (weight p) (b - a)%:P => x y w h.
  by rewrite !expr2 !tofracM (rmorph_nat [rmorphism of @FracField.tofrac [idomainType of {poly F}]]).
rewrite /affine e0 e1; rewrite -weight_fun e0 in a0; rewrite -weight_fun e1 in b0.
apply: affine_step => //; first by rewrite weight_fun.
  by rewrite tofrac_eq0 polyC_eq0 subr_eq0 eq_sym.
by rewrite -tofracB polyCB opprB addrA subrK.
Qed.

Lemma det_last n u c d a b : span n u -> (b - a) ^+ 2 *: \det (rows4 (pcurve n u c) (pderiv (pcurve n u c)) (pcurve n u d) (pderiv (pcurve n u d)))
  = (n ^ 2)%:R * \det (rows4 (last_point n u c a) (last_point n u c b) (last_point n u d a) (last_point n u d b)).
Proof.
have times (x : 'rV[{poly F}]_4) : x *+ n = n%:R *: x by rewrite scaler_nat.
move=> sp; rewrite !pderiv_curve // !times det_scaled; case: (posnP n) => [e|n0].
  have z : n%:R = 0 :> {poly F} by rewrite e.
  by rewrite natrX z expr0n !mul0r ?scaler0.
rewrite !last_pointE // det_lines -mul_polyC natrX mulrCA polyC_exp.
by rewrite polyCB [b%:P - 'X - _](_ : _ = b%:P - a%:P) // opprB addrA subrK.
Qed.

(** FJ21.C3.1 determinant: $(b-a)^2w^2\omega^2\,(d-c)\cdot(c'\times d')=-n^2\det(p[t^{\langle n-1\rangle},a],p[t^{\langle n-1\rangle},b],
    q[t^{\langle n-1\rangle},a],q[t^{\langle n-1\rangle},b])$; the points $p_0^{n-1},p_1^{n-1}$ of the paper have $a=0$, $b=1$ on $[0,1]$ and $a=u_{n-1}$, $b=u_n$ on a
    piece of a spline.
    Hypotheses: the knots carry the piece and the weights $w$, $\omega$ do not vanish identically, so that $c$, $d$ have a meaning. *)
Theorem FJ21_C3_1_determinant n u c d a b (p := pcurve n u c) (q := pcurve n u d) :
  span n u -> weight p != 0 -> weight q != 0 ->
  (((b - a)%:P * weight p * weight q) ^+ 2)%:F * triple (affine q - affine p) (pfderiv (affine p)) (pfderiv (affine q))
    = - ((n ^ 2)%:R * \det (rows4 (last_point n u c a) (last_point n u c b) (last_point n u d a) (last_point n u d b)))%:F.
Proof.
move=> sp w0 om0; rewrite -det_last // -mulrA exprMn tofracM -mulrA FJ21_C3_1_tangents // mulrN -tofracM.
by rewrite -mul_polyC polyC_exp.
Qed.

(* Where w vanishes identically so do the weights of the last points, unless n = 0 in the field. *)
Lemma weight_last n u (c : nat -> 'rV[F]_4) a : span n u -> weight (pcurve n u c) = 0 -> weight (last_point n u c a) != 0 -> n%:R = 0 :> F.
Proof.
case: n => [//|n] sp w0; rewrite last_pointE // /weight !mxE; move: w0; rewrite /weight mxE => w0; rewrite w0 add0r mulf_eq0 negb_or => /andP[_ v0].
have := blossoms_derivative (coord c 0) sp; rewrite w0 linear0 => /esym/eqP.
by rewrite -[_ *+ n.+1]mulr_natl mulf_eq0 (negPf v0) orbF -polyC1 -polyCMn polyC_eq0 => /eqP.
Qed.

(** FJ21.P3.1 points: $(d-c)\cdot(c'\times d')=-n^2\frac{w_0w_1\omega_0\omega_1}{(b-a)^2w^2\omega^2}\,[\,c_1-c_0,\,d_0-c_0,\,d_1-c_0\,]$
    for the points $c_0,c_1,d_0,d_1$ of the rows $p[t^{\langle n-1\rangle},a]$, ..., here without denominators.
    Hypotheses: the knots carry the piece and none of the four weights vanishes identically, so that the four points have a meaning; $w$, $\omega$ do not vanish then
    unless $n=0$ in the field, where both sides are 0 whatever stands for the left determinant. *)
Theorem FJ21_P3_1_points n u c d a b (p := pcurve n u c) (q := pcurve n u d)
    (p0 := last_point n u c a) (p1 := last_point n u c b) (q0 := last_point n u d a) (q1 := last_point n u d b) :
  span n u -> weight p0 != 0 -> weight p1 != 0 -> weight q0 != 0 -> weight q1 != 0 ->
  (((b - a)%:P * weight p * weight q) ^+ 2)%:F * triple (affine q - affine p) (pfderiv (affine p)) (pfderiv (affine q))
    = - ((n ^ 2)%:R * (weight p0 * weight p1 * weight q0 * weight q1))%:F
      * triple (affine p1 - affine p0) (affine q0 - affine p0) (affine q1 - affine p0).
Proof.
move=> sp p00 p10 q00 q10.
have void : (weight p * weight q) ^+ 2 = 0 -> n%:R = 0 :> F.
  by move/eqP; rewrite expf_eq0 mulf_eq0 => /orP[] /eqP w0; [exact: weight_last sp w0 p00 | exact: weight_last sp w0 q00].
have [e|nz] := eqVneq ((weight p * weight q) ^+ 2) 0.
  by rewrite -mulrA exprMn e mulr0 tofrac0 mul0r natrX -polyC1 -polyCMn void // polyC0 expr0n !mul0r tofrac0 oppr0 mul0r.
have [w0 om0] : weight p != 0 /\ weight q != 0 by apply/andP; move: nz; rewrite expf_eq0 mulf_eq0 negb_or.
rewrite FJ21_C3_1_determinant // !tofracM mulNr -mulrA; congr (- (_ * _)).
by rewrite det_pfun det_points ?weight_fun // /affine !weightE.
Qed.

(** FJ21.P3.1 coplanar: the surface is developable iff the points $c_0^{n-1}(t)$, $c_1^{n-1}(t)$, $d_0^{n-1}(t)$, $d_1^{n-1}(t)$ are coplanar.
    Hypotheses: $a\ne b$; $n\ne0$ in the field; the knots carry the piece and none of the four weights vanishes identically, so that the points have a meaning.
    Paper: states none of them; where $w_0^{n-1}$ vanishes there is no point $c_0^{n-1}$, and Corollary 3.1 still holds. *)
Theorem FJ21_P3_1_coplanar n u c d a b (p := pcurve n u c) (q := pcurve n u d)
    (p0 := last_point n u c a) (p1 := last_point n u c b) (q0 := last_point n u d a) (q1 := last_point n u d b) :
  n%:R != 0 :> F -> span n u -> a != b ->
  weight p0 != 0 -> weight p1 != 0 -> weight q0 != 0 -> weight q1 != 0 ->
  rational_developable p q <-> coplanar (affine p0) (affine p1) (affine q0) (affine q1).
Proof.
move=> n0 sp ab p00 p10 q00 q10; have w0 : weight p != 0 by apply: contraNneq n0 => w0; apply/eqP; exact: weight_last sp w0 p00.
have om0 : weight q != 0 by apply: contraNneq n0 => z0; apply/eqP; exact: weight_last sp z0 q00.
rewrite -triple_coplanar; have := FJ21_P3_1_points sp p00 p10 q00 q10; rewrite /rational_developable -/p -/q => e.
have nz : ((b - a)%:P * weight p * weight q) ^+ 2 != 0.
  by rewrite expf_neq0 // !mulf_neq0 // polyC_eq0 subr_eq0 eq_sym.
have nz' : (n ^ 2)%:R * (weight p0 * weight p1 * weight q0 * weight q1) != 0.
  by rewrite !mulf_neq0 // natrX expf_neq0 // -polyC1 -polyCMn polyC_eq0.
split=> h; move: e; rewrite h mulr0 => /eqP; last by rewrite mulf_eq0 tofrac_eq0 (negPf nz) => /eqP.
by rewrite eq_sym mulf_eq0 oppr_eq0 tofrac_eq0 (negPf nz') => /eqP.
Qed.

(** FJ21.C3.1 degree: that determinant has degree at most $4(n-1)$.
    Hypotheses: $n>0$ and the knots carry the piece, so that the rows have a meaning; with $x/0=0$ the bound would hold without. *)
Theorem FJ21_C3_1_degree n u c d a b : (0 < n)%N -> span n u ->
  (size (\det (rows4 (last_point n u c a) (last_point n u c b) (last_point n u d a) (last_point n u d b)))%R <= (4 * (n - 1)).+1)%N.
Proof.
move=> n0 sp; apply: size_det => i j; rewrite subn1 prednK // mxE.
by case: i => -[|[|[|[|//]]]] lt_i; apply: size_last_point.
Qed.

(** FJ21.C3.1 dependent: the surface is developable iff $p_0^{n-1},p_1^{n-1},q_0^{n-1},q_1^{n-1}$ are dependent over the polynomials.
    Hypotheses: $a\ne b$; $n\ne0$ in the field; the knots carry the piece and the weights do not vanish identically, so that $c$, $d$ have a meaning. *)
Theorem FJ21_C3_1_dependent n u c d a b (p := pcurve n u c) (q := pcurve n u d) :
  n%:R != 0 :> F -> span n u -> a != b -> weight p != 0 -> weight q != 0 -> rational_developable p q <->
  dependent4 (last_point n u c a) (last_point n u c b) (last_point n u d a) (last_point n u d b).
Proof.
move=> n0 sp ab w0 om0; rewrite FJ21_2_1_determinant // -det_dependent; have := det_last c d a b sp; rewrite -/p -/q => e; split=> h; move: e; rewrite h.
  rewrite scaler0 => /esym/eqP; rewrite natrX mulf_eq0 expf_eq0 /= => /orP[|/eqP //].
  by rewrite -polyC1 -polyCMn polyC_eq0 (negPf n0).
by rewrite mulr0 => /eqP; rewrite scaler_eq0 expf_eq0 subr_eq0 eq_sym (negPf ab) /= => /eqP.
Qed.
End Rational.
