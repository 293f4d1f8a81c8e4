(* FJ21, Theorem 3.1: developable surfaces without Lam, M, sigma.
   Definitions:
     row4 a b c d     the row with these four entries *)
From Torse Require Import Prelude Blossom Curves Points Functions FJ21_2 FJ21_3_theorem.

Definition row4 (R : ringType) (a b c d : R) : 'rV[R]_4 := \row_k nth 0 [:: a; b; c; d] k.

Lemma row4E (R : ringType) (a b c d : R) : [/\ row4 a b c d 0 0 = a, row4 a b c d 0 1 = b, row4 a b c d 0 2%:R = c & row4 a b c d 0 3%:R = d].
Proof. by split; rewrite mxE. Qed.

Lemma det_row4 (R : idomainType) (a b c d e f g h i j k l w x y z : R) :
  \det (rows4 (row4 a b c d) (row4 e f g h) (row4 i j k l) (row4 w x y z)) =
  a * (f * (k * z - l * y) + g * (l * x - j * z) + h * (j * y - k * x)) - e * (b * (k * z - l * y) + c * (l * x - j * z) + d * (j * y - k * x))
  + i * (b * (g * z - h * y) + c * (h * x - f * z) + d * (f * y - g * x)) - w * (b * (g * l - h * k) + c * (h * j - f * l) + d * (f * k - g * j)).
Proof. by rewrite det_rows4 !place_seq !weight_seq !triple_vec /=; ring. Qed.

(* A family q = k p + V has no relation; the tangents q = p' have one iff p depends on p' and p''. *)
Lemma no_relation_translated (K : fieldType) m (p p' v : 'rV[K]_m) (k x y s : K) : free p p' v ->
  p + x *: p' <> s *: (k *: p + v + y *: (k *: p')).
Proof.
move=> fr e; have /fr[/eqP s1 _ /eqP]: (1 - s * k) *: p + (x - s * y * k) *: p' + (- s) *: v = 0.
  by transitivity (p + x *: p' - s *: (k *: p + v + y *: (k *: p'))); [by_entries h; ring | rewrite e subrr].
by rewrite oppr_eq0 => /eqP s0; rewrite s0 mul0r subr0 oner_eq0 in s1.
Qed.

Lemma relation_tangents (K : fieldType) m (p p' p'' : 'rV[K]_m) (x y s : K) :
  p + x *: p' = s *: (p' + y *: p'') <-> p = (s - x) *: p' + (s * y) *: p''.
Proof.
split=> [e|->]; last by by_entries h; ring.
by rewrite -[LHS](addrK (x *: p')) e; by_entries h; ring.
Qed.

Lemma tangent_differences (K : fieldType) m (p p' p'' : 'rV[K]_m) (t L M s n : K) : n != 0 ->
  p + ((1 - t) / n) *: p' - (p + ((0 - t) / n) *: p') = n^-1 *: p' /\
  p + ((L - t) / n) *: p' - s *: (p' + ((M - t) / n) *: p'') = p + ((L - t) / n - s) *: p' - (s * ((M - t) / n)) *: p''.
Proof. by move=> n0; split; apply/rowP=> k; rewrite !mxE; move: (p 0 k) (p' 0 k) (p'' 0 k) => a b c; field. Qed.

(* The first, the second and the fourth coordinate, or the first three, show that rows are free. *)
Lemma free_first (K : fieldType) (p p' v : 'rV[K]_4) : weight p != 0 -> weight p' = 0 -> weight v = 0 -> p' 0 1 != 0 -> v 0 1 = 0 ->
  p 0 3%:R = 0 -> p' 0 3%:R = 0 -> v 0 3%:R != 0 -> free p p' v.
Proof.
rewrite /weight => w0 w' wv p1 v1 p3 p3' v3 i j k /rowP e; have := (e 0, e 1, e 3%:R); rewrite !mxE w' wv v1 p3 p3' !mulr0 !addr0 !add0r.
move=> [[/eqP]]; rewrite mulf_eq0 (negPf w0) orbF => /eqP -> + /eqP; rewrite mul0r add0r mulf_eq0 (negPf v3) orbF => /eqP + /eqP.
by rewrite mulf_eq0 (negPf p1) orbF => /eqP -> ->.
Qed.

Lemma free_bent (K : fieldType) (p p' v : 'rV[K]_4) (t : K) : weight p = 1 + t -> p 0 1 = t -> weight p' = 1 -> p' 0 1 = 1 ->
  weight v = 0 -> v 0 1 = 0 -> v 0 2%:R != 0 -> free p p' v.
Proof.
rewrite /weight => w p1 w' p1' wv v1 v2 i j k /rowP e; have := (e 0, e 1, e 2%:R); rewrite !mxE w p1 w' p1' wv v1 !mulr0 !addr0 !mulr1.
move=> [[e0 e1] e2]; have i0 : i = 0 by transitivity (i * (1 + t) + j - (i * t + j)); [ring | rewrite e0 e1 subrr].
move: e1 e2; rewrite i0 mul0r add0r => -> /eqP; rewrite !mul0r !add0r mulf_eq0 (negPf v2) orbF => /eqP -> //.
Qed.

Section Needs.
Variable F : fieldType.
Notation K := {fraction {poly F}}.
Notation "x %:F" := (@FracField.tofrac [idomainType of {poly F}] x).
Implicit Types (n : nat) (L M s : K).

(** FJ21.T3.1.excluded difference: for $q=p'$: $p_1^{n-1}-p_0^{n-1}=\frac1nq(t)$ for $p_i^{n-1}=p[t^{\langle n-1\rangle},i]$, and
    $p[t^{\langle n-1\rangle},\Lambda]-\sigma q[t^{\langle n-1\rangle},M]=p+\bigl(\frac{\Lambda-t}n-\sigma\bigr)p'-\sigma\frac{M-t}np''$.
    Hypotheses: $n\ne0$ in the field, so that $\frac1n$ has a meaning. *)
Theorem FJ21_T3_1_excluded_difference m n (p : 'rV[{poly F}]_m) L M s (T := FracField.tofrac 'X : K) : n%:R != 0 :> F ->
  ftangent n p 1 - ftangent n p 0 = n%:R^-1 *: pfun (pderiv p) /\
  ftangent n p L - s *: ftangent n (pderiv p) M
    = pfun p + ((L - T) / n%:R - s) *: pfun (pderiv p) - (s * ((M - T) / n%:R)) *: pfun (pderiv (pderiv p)).
Proof.
move=> /natrF0 n0; rewrite /ftangent -/T; move: T (n%:R : K) n0 => x N n0.
move: (pfun p) (pfun (pderiv p)) (pfun (pderiv (pderiv p))) => P P' P''.
exact: tangent_differences.
Qed.

(** FJ21.T3.1.excluded relation: $p$ and $q=p'$ bound a developable surface, and $\Lambda,M,\sigma$ with $p[t^{\langle n-1\rangle},\Lambda]=\sigma q[t^{\langle n-1\rangle},M]$
    exist iff $p$ is a combination of $p'$ and $p''$ with rational coefficients.
    Hypotheses: the weights $w$, $w'$ do not vanish identically, so that there are curves; $n\ne0$ in the field, for the "if", so that $p[t^{\langle n-1\rangle},\Lambda]$
    has a meaning. *)
Theorem FJ21_T3_1_excluded_relation (p : 'rV[{poly F}]_4) : weight p != 0 -> weight (pderiv p) != 0 ->
  [/\ rational_developable p (pderiv p),
      forall n L M s, frelated n p (pderiv p) L M s -> exists a b : K, pfun p = a *: pfun (pderiv p) + b *: pfun (pderiv (pderiv p))
    & forall n (a b : K), n%:R != 0 :> F -> pfun p = a *: pfun (pderiv p) + b *: pfun (pderiv (pderiv p)) ->
      exists L M s, s != 0 /\ frelated n p (pderiv p) L M s].
Proof.
move=> w0 om0; split=> [|n L M s /relation_tangents e|n a b n0 e].
- apply/FJ21_2_1_determinant => //; apply/det_dependent; exists 0, 1, (-1), 0; split.
    by rewrite !xpair_eqE oner_eq0 andbF.
  by rewrite !scale0r add0r addr0 scale1r scaleN1r subrr.
- by eexists; eexists; exact: e.
exists ('X%:F + (1 - a) * n%:R), ('X%:F + b * n%:R), 1; split; first exact: oner_neq0.
rewrite /frelated /ftangent ![_ + _ * _]addrC !addrK !mulfK ?natrF0 //; apply/relation_tangents.
by rewrite subKr mul1r.
Qed.

(** FJ21.T3.1 needs_generic: a cylinder over a parabola, $d=c+(0,0,1)$ with $c=(t,t^2,0)$ and weights 1: developable, and there are no
    $\Lambda,M,\sigma$, in no degree $n$. *)
Theorem FJ21_T3_1_needs_generic : exists p q : 'rV[{poly F}]_4, [/\ weight p = 1, weight q = 1, rational_developable p q
  & forall n L M s, ~ frelated n p q L M s].
Proof.
pose p : 'rV[{poly F}]_4 := row4 1 'X ('X ^+ 2) 0; pose v : 'rV[{poly F}]_4 := row4 0 0 0 1; exists p, (p + v).
have [w wv] : weight p = 1 /\ weight (p + v) = 1 by rewrite /weight !mxE /= addr0.
have dv : pderiv (p + v) = pderiv p.
  by apply/rowP=> k; rewrite !mxE derivD; case: k => -[|[|[|[|//]]]] lt_k /=; rewrite ?derivC ?addr0.
have fr : free (pfun p) (pfun (pderiv p)) (pfun v).
  by apply: free_first; rewrite /weight !mxE /= ?derivC ?derivX ?tofrac0 ?tofrac1 ?oner_eq0.
split=> // [|n L M s]; last first.
  rewrite /frelated /ftangent dv pfunD; have := @no_relation_translated _ _ _ _ _ 1 ((L - FracField.tofrac 'X) / n%:R) ((M - FracField.tofrac 'X) / n%:R) s fr.
  by rewrite !scale1r.
apply/FJ21_2_1_determinant; rewrite ?w ?wv ?oner_eq0 //; apply/det_dependent; exists 0, 1, 0, (-1); split.
  by rewrite !xpair_eqE oner_eq0 andbF.
by rewrite dv !scale0r add0r addr0 scale1r scaleN1r subrr.
Qed.

(** FJ21.T3.1 needs_tangents: between $p=(1+t,t,t^2,t^3)$ and $q=p'$, a patch of the tangent surface of a twisted cubic, there are no
    $\Lambda,M,\sigma$ either: the exception is not one of cylinders and cones alone. *)
Theorem FJ21_T3_1_needs_tangents (p : 'rV[{poly F}]_4 := row4 (1 + 'X) 'X ('X ^+ 2) ('X ^+ 3)) :
  [/\ weight p != 0, weight (pderiv p) != 0, rational_developable p (pderiv p) & forall n L M s, ~ frelated n p (pderiv p) L M s].
Proof.
have w0 : weight p != 0 by rewrite /weight mxE /= addrC -size_poly_eq0 -polyC1 size_XaddC.
have w1 : weight (pderiv p) = 1 by rewrite /weight !mxE /= derivD derivC derivX add0r.
have om0 : weight (pderiv p) != 0 by rewrite w1 oner_eq0.
have [dev rel _] := FJ21_T3_1_excluded_relation w0 om0; split=> // n L M s /rel[a [b /rowP e]]; have := (e 0, e 1).
rewrite !mxE /= derivD derivX -?polyC1 !derivC add0r polyC1 -?polyC1 !derivC polyC1 tofracD tofrac1 tofrac0 !mulr1 !mulr0 !addr0 => -[h0 h1].
by move/eqP: h0; rewrite -h1 -subr_eq0 addrK oner_eq0.
Qed.
End Needs.
