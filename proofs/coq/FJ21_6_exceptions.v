(* FJ21, section 6: the edge of regression as a rational curve (Corollary 6.1), and the exceptional cases of Theorem 6.1. *)
From Torse Require Import Prelude Blossom Curves Points Bernstein Functions FJ21_2 FJ21_3_theorem FJ21_4 FJ21_6_theorem.

(* The algebra of Corollary 6.1, in any field. *)
Section Algebra.
Variable K : fieldType.

Lemma edge_vectors m (P P' Q Q' : 'rV[K]_m) (t L M s n : K) (E := L - t + s * (t - M)) (v := s * (t - M) / E) : n != 0 -> E != 0 ->
  P + ((L - t) / n) *: P' = s *: (Q + ((M - t) / n) *: Q') ->
  (1 - v) *: P' + v *: Q' = (n * s * (L - M) / E ^+ 2) *: (Q - P) + (n * (s - 1) / E) *: ((1 - v) *: P + v *: Q).
Proof.
rewrite /v /E => n0 e0 /rowP e; apply/rowP=> k; have := e k; rewrite !mxE.
move: (P 0 k) (Q 0 k) (P' 0 k) (Q' 0 k) => a b a' b' eq_P.
by apply: (by_multiple (z := n / (L - t + s * (t - M))) eq_P); field; rewrite n0 e0.
Qed.

Lemma edge_direction (w om a b v g be : K) (rho := (1 - v) * w + v * om) (x := (1 - v) * a + v * b) : w != 0 -> om != 0 -> rho != 0 ->
  - (g * (om - w) + be * rho) / rho ^+ 2 * x + rho^-1 * (g * (b - a) + be * x) = g * (w * om) / rho ^+ 2 * (om^-1 * b - w^-1 * a).
Proof. by rewrite /rho /x => w0 om0 r0; field; rewrite w0 om0 r0. Qed.

Lemma blend_rule (v a b v' a' b' : K) : (0 - v') * a + (1 - v) * a' + (v' * b + v * b') = (1 - v) * a' + v * b' + v' * (b - a).
Proof. by ring. Qed.
End Algebra.

Section Edge.
Variable F : fieldType.
Notation K := {fraction {poly F}}.
Notation "x %:F" := (@FracField.tofrac [idomainType of {poly F}] x).
Implicit Types (L M s v : K) (n : nat).

Lemma pfderiv_blend m (P Q : 'rV[K]_m) v :
  pfderiv ((1 - v) *: P + v *: Q) = (1 - v) *: pfderiv P + v *: pfderiv Q + fderiv v *: (Q - P).
Proof.
have f1 : fderiv (1 : K) = 0 by rewrite -tofrac1 fderiv_poly derivC tofrac0.
by apply/rowP=> k; rewrite !mxE fderivD !fderivM fderivB f1; exact: blend_rule.
Qed.

(** FJ21.C6.1 tangent: the edge $r=(1-v)p+vq$, $v=\frac{\sigma(t-M)}{\Lambda-t+\sigma(t-M)}$, of rational functions $\Lambda,M,\sigma$ has
    $r'=(\alpha+v')(q-p)+\beta r$ with the $\alpha$, $\beta$ of section 6.
    Hypotheses: $E=\Lambda-t+\sigma(t-M)\ne0$; $n\ne0$ in the field. Where $E=0$ the edge is $q-p$ ("infinite" below).
    Paper: states neither. *)
Theorem FJ21_C6_1_tangent m n (p q : 'rV[{poly F}]_m) L M s (E := L - 'X%:F + s * ('X%:F - M)) (v := s * ('X%:F - M) / E)
    (r := (1 - v) *: pfun p + v *: pfun q) : n%:R != 0 :> F -> E != 0 -> frelated n p q L M s ->
  pfderiv r = (n%:R * s * (L - M) / E ^+ 2 + fderiv v) *: pfun (q - p) + (n%:R * (s - 1) / E) *: r.
Proof.
move=> n0 e0 rel; rewrite pfderiv_blend !pfderiv_fun (edge_vectors (natrF0 n0) e0 rel) pfunB -/E -/v -/r.
by rewrite scalerDl addrAC.
Qed.

(** FJ21.C6.1 ruling: in space the tangent of the edge $e=r/\rho$ is the ruling: $e'=(\alpha+v')\frac{w\omega}{\rho^2}(d-c)$.
    Hypotheses: $E\ne0$; $n\ne0$ in the field; the weights $w,\omega$ of $p,q$ and $\rho$ of $r$ do not vanish identically, so that $c$, $d$, $e$ have a meaning.
    Paper: "has a rational edge": where $\alpha+v'=0$ it is one point, and the surface a cone or a cylinder. *)
Theorem FJ21_C6_1_ruling n (p q : 'rV[{poly F}]_4) L M s (E := L - 'X%:F + s * ('X%:F - M)) (v := s * ('X%:F - M) / E)
    (r := (1 - v) *: pfun p + v *: pfun q) : n%:R != 0 :> F -> E != 0 -> weight p != 0 -> weight q != 0 -> weight r != 0 ->
  frelated n p q L M s ->
  pfderiv ((weight r)^-1 *: place r)
    = ((n%:R * s * (L - M) / E ^+ 2 + fderiv v) * (weight p * weight q)%:F / weight r ^+ 2) *: (affine q - affine p).
Proof.
move=> n0 e0 w0 om0 r0 rel; have /rowP dr := FJ21_C6_1_tangent n0 e0 rel.
have dk k : fderiv (r 0 k) = (n%:R * s * (L - M) / E ^+ 2 + fderiv v) * ((q 0 k)%:F - (p 0 k)%:F) + n%:R * (s - 1) / E * r 0 k.
  by have := dr k; rewrite [LHS]mxE [RHS]mxE [X in _ = X + _]mxE pfunB [X in _ = _ * X + _]mxE [X in _ = _ * (_ + X) + _]mxE !pfunE [X in _ = _ + X]mxE.
have rE k : r 0 k = (1 - v) * (p 0 k)%:F + v * (q 0 k)%:F by rewrite /r [LHS]mxE [X in X + _]mxE [X in _ + X]mxE !pfunE.
apply/rowP=> k; rewrite mxE [in LHS]mxE [place r _ _]mxE fderivM fderivV // !dk [RHS]mxE [X in _ = _ * X]mxE [affine q 0 k]mxE [X in _ = _ * (_ + X)]mxE [affine p 0 k]mxE.
rewrite !weightE ![place (pfun _) 0 k]mxE !pfunE tofracM /weight; move: r0; rewrite /weight !rE => r0.
by apply: edge_direction; rewrite // tofrac_eq0.
Qed.
End Edge.

Section Exceptions.
Variables (F : fieldType) (m : nat).
Implicit Types (p q r : 'rV[{poly F}]_m) (L M x : F) (n : nat) (g h : {poly F}).

(* Euler's equation. *)
Lemma euler n g M : n`!%:R != 0 :> F -> (size g <= n.+1)%N ->
  n%:R%:P * g = ('X - M%:P) * g^`() <-> exists a, g = a%:P * ('X - M%:P) ^+ n.
Proof.
move=> nz sg; split=> [|[a ->]]; last first.
  rewrite derivM derivC mul0r add0r deriv_exp derivB derivX derivC subr0 mul1r polyC_nat.
  case: n {nz sg} => [|n]; first by rewrite mul0r mulr0n !mulr0.
  by rewrite -(mulr_natr (('X - M%:P) ^+ n)) exprS /=; move: (('X - M%:P) ^+ n) ('X - M%:P) (n.+1%:R : {poly F}) => a' b c; ring.
elim: n g nz sg => [|n ih] g nz sg e.
  by exists (g`_0); rewrite expr0 mulr1; exact: size1_polyC.
have [nz1 nz2] : n.+1%:R != 0 :> F /\ n`!%:R != 0 :> F by move: nz; rewrite factS natrM mulf_eq0 negb_or => /andP[].
have root_g : root g M.
  have := congr1 (fun y : {poly F} => y.[M]) e; rewrite !hornerM hornerC hornerXsubC subrr mul0r => /eqP.
  by rewrite mulf_eq0 (negPf nz1).
have [h eh] := factor_theorem _ _ root_g; have X0 : 'X - M%:P != 0 :> {poly F} by rewrite polyXsubC_eq0.
have sh : (size h <= n.+1)%N.
  have [h0|h0] := eqVneq h 0; first by rewrite h0 size_poly0.
  by move: sg; rewrite eh size_Mmonic ?monicXsubC // size_XsubC addn2.
have [|a ea] := ih h nz2 sh; last by exists a; rewrite eh ea exprSr mulrA.
apply: (mulfI X0); move: e; rewrite eh derivM derivB derivX derivC subr0 mulr1 natrS polyCD polyC1.
by move: ('X - M%:P) (n%:R%:P) (h^`()) => X N h' e; apply: (by_multiple (z := 1) e); ring.
Qed.

(** FJ21.T6.1.cone equivalence: for $\Lambda=M$ and $\sigma=1$ the relation holds iff $q=p+(t-M)^nA$ for one $A$: all rulings pass through the point $A$, a cone,
    or a cylinder where $A$ has weight 0.
    Hypotheses: $q-p$ has degree at most $n$, $n>0$; $n!\ne0$ in the field, as in characteristic 0.
    Paper: does not exclude $\Lambda=M$, where there is no edge. *)
Theorem FJ21_T6_1_cone_equivalence n p q M : n`!%:R != 0 :> F -> (0 < n)%N -> (forall k, (size (q 0%R k - p 0%R k)%R <= n.+1)%N) ->
  related_rows n p q M M <-> exists A : 'rV[F]_m, q = p + ('X - M%:P) ^+ n *: map_mx polyC A.
Proof.
move=> nz n0 sz; have n1 : n%:R != 0 :> F.
  by apply: contraNneq nz => e; case: n n0 e {sz} => // n _ e; rewrite factS natrM e mul0r.
have co k : (p 0 k + (n%:R^-1 *: (M%:P - 'X)) * (p 0 k)^`() = q 0 k + (n%:R^-1 *: (M%:P - 'X)) * (q 0 k)^`()) <->
    n%:R%:P * (q 0 k - p 0 k) = ('X - M%:P) * (q 0 k - p 0 k)^`().
  have eN : n%:R%:P * (n%:R^-1)%:P = 1 :> {poly F} by rewrite -polyCM mulfV.
  rewrite derivB -!mul_polyC; move: eN; move: (n%:R%:P) ((n%:R^-1)%:P) (p 0 k) (q 0 k) (p 0 k)^`() (q 0 k)^`() 'X M%:P => N a P Q P' Q' X u aN.
  split=> e.
    apply: (by_multiple (z := - N) e); rewrite (_ : - N * _ = N * (Q - P) + N * a * (X - u) * (P' - Q')); last by ring.
    by rewrite aN; ring.
  apply: (by_multiple (z := - a) e); rewrite (_ : - a * _ = N * a * (P - Q) + a * (X - u) * (Q' - P')); last by ring.
  by rewrite aN; ring.
split=> [/rowP e|[A eq]]; last first.
  apply/rowP=> k; rewrite !mxE; apply/(co k)/(euler _ nz (sz k)); exists (A 0 k).
  by rewrite eq !mxE addrAC subrr add0r mulrC.
exists (\row_k ((q 0 k - p 0 k) %/ ('X - M%:P) ^+ n)`_0); apply/rowP=> k; rewrite !mxE.
have := e k; rewrite !mxE => /co /(euler _ nz (sz k)) [a ea].
by rewrite ea mulpK ?expf_neq0 ?polyXsubC_eq0 // coefC eqxx mulrC -ea addrC subrK.
Qed.

(** FJ21.T6.1.cone vertex: then $(\Lambda-t)p+(t-M)q=(t-M)^{n+1}A$: the edge would be the point $A$. *)
Theorem FJ21_T6_1_cone_vertex n p M (A : 'rV[F]_m) (q := p + ('X - M%:P) ^+ n *: map_mx polyC A) :
  (M%:P - 'X) *: p + ('X - M%:P) *: q = ('X - M%:P) ^+ n.+1 *: map_mx polyC A.
Proof. by rewrite /q exprS; move: (_ ^+ n) (map_mx polyC A) => y B; by_entries k; ring. Qed.

(** FJ21.T6.1 needs_distinct: for $\Lambda=M$ there are related rows that no $r$ gives, whatever $p$ is: $q=p+(t-M)^nA$ with $A\ne0$.
    Hypotheses: $n\ne0$ in the field. *)
Theorem FJ21_T6_1_needs_distinct n p M (A : 'rV[F]_m) (q := p + ('X - M%:P) ^+ n *: map_mx polyC A) : n%:R != 0 :> F -> A != 0 ->
  related_rows n p q M M /\ forall r, ~ (p = patch n r M /\ q = patch n r M).
Proof.
move=> n0 a0; split.
  apply/rowP=> k; rewrite !mxE derivD derivM derivC mulr0 addr0 deriv_exp derivB derivX derivC subr0 mul1r.
  have eN : (n%:R^-1)%:P * n%:R = 1 :> {poly F} by rewrite -polyC_nat -polyCM mulVf.
  case: n n0 @q eN => [|n] n0 q eN; first by rewrite eqxx in n0.
  rewrite -(mulr_natr (('X - M%:P) ^+ n)) exprS /= -mul_polyC; move: eN; move: (n.+1%:R : {poly F}) ((n.+1%:R^-1)%:P) (p 0 k) (p 0 k)^`() (A 0 k)%:P 'X M%:P => N a P P' b X u aN.
  move: ((X - u) ^+ n) => Y.
  rewrite (_ : _ + _ * (P' + _) = P + (X - u) * Y * b * (1 - a * N) + a * (u - X) * P'); last by ring.
  by rewrite aN subrr mulr0 addr0.
move=> r [ep eq]; have /rowP e : q = p by rewrite ep.
move/eqP: a0; apply; apply/rowP=> k; have /eqP := e k; rewrite !mxE -[X in _ == X]addr0 (inj_eq (addrI _)).
by rewrite mulf_eq0 expf_eq0 polyXsubC_eq0 andbF polyC_eq0 => /eqP.
Qed.

(** FJ21.T6.1 infinity: the weight of $r+\frac{M-t}{n+1}r'$ vanishes identically, so that $p$ lies at infinity, iff the weight of $r$ is $a(t-M)^{n+1}$.
    Hypotheses: that weight $g$ has degree at most $n+1$; $(n+1)!\ne0$ in the field.
    Paper: passes over it. *)
Theorem FJ21_T6_1_infinity n g M : n.+1`!%:R != 0 :> F -> (size g <= n.+2)%N ->
  g + (n.+1%:R^-1 *: (M%:P - 'X)) * g^`() = 0 <-> exists a, g = a%:P * ('X - M%:P) ^+ n.+1.
Proof.
move=> nz sg; rewrite -(euler M nz sg); have n1 : n.+1%:R != 0 :> F by move: nz; rewrite factS natrM mulf_eq0 negb_or => /andP[].
have eN : n.+1%:R%:P * (n.+1%:R^-1)%:P = 1 :> {poly F} by rewrite -polyCM mulfV.
rewrite -!mul_polyC; move: eN; move: (n.+1%:R%:P) ((n.+1%:R^-1)%:P) (g^`()) 'X M%:P => N a g' X u aN; split=> e.
  by apply: (by_multiple (z := N) e); rewrite [RHS](_ : _ = N * g + N * a * (u - X) * g'); [rewrite aN; ring | ring].
by apply: (by_multiple (z := a) e); rewrite [RHS](_ : _ = N * a * g - a * (X - u) * g'); [rewrite aN; ring | ring].
Qed.
End Exceptions.
