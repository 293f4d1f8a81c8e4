(* FJ21, Theorem 6.1 as a statement about sets of surfaces, and what the surface is where r is a point, a line or a plane curve.
   Definitions:
     degree_le n p     no coordinate of p has a degree greater than n
     degree_is n p     and one of them has the degree n
     inside N p        p(t) N = 0 for all t: the curve lies in the subspace of the points that the columns of N, planes, have in common
     on_rulings A p q  the constant point A is a combination of p(t) and q(t) with rational coefficients: all rulings pass through it *)
From Torse Require Import Prelude Blossom Curves Points Bernstein Bezier ZW06_cases FJ21_4 FJ21_6_theorem.

Section Degrees.
Variables (F : fieldType) (m : nat).
Implicit Types (p q r : 'rV[{poly F}]_m) (L M x : F) (n : nat).

Definition degree_le n p := forall k, (size (p 0%R k) <= n.+1)%N.
Definition degree_is n p := degree_le n p /\ exists k, (p 0 k)`_n != 0.

Lemma rowB p q k : (q - p) 0 k = q 0 k - p 0 k.
Proof. by rewrite !mxE. Qed.

(** FJ21.T6.1 set: rows $p,q$ of degree at most $n$ whose difference has the degree $n$ obey $p[t^{\langle n-1\rangle},\Lambda]=q[t^{\langle n-1\rangle},M]$ with constants
    $\Lambda\ne M$ iff there is a curve $r$ of degree $n+1$, and then only one, with $p=r+\frac{M-t}{n+1}r'$ and $q=r+\frac{\Lambda-t}{n+1}r'$.
    Hypotheses: $\Lambda\ne M$; $n$ and $n+1$ are not 0 in the field.
    Paper: does not exclude $\Lambda=M$; asks for degree $n$ of $p$ and $q$ themselves, which one $M$ and one $\Lambda$ can miss. *)
Theorem FJ21_T6_1_set n p q L M : n%:R != 0 :> F -> n.+1%:R != 0 :> F -> L != M ->
  [/\ degree_le n p, degree_le n q, degree_is n (q - p) & related_rows n p q L M]
    <-> exists! r, [/\ degree_is n.+1 r, p = patch n r M & q = patch n r L].
Proof.
move=> n0 n1 d; have d0 : L - M != 0 by rewrite subr_eq0.
split=> [[sp sq [_ [k ak]] rel]|[r [[[sr [k ak]] -> ->] _]]]; last first.
  have top x i := FJ21_T6_1_degree x n1 (sr i).
  split; [by move=> i; case: (top M i) | by move=> i; case: (top L i) | split | by apply/FJ21_T6_1_equivalence => //; exists r].
    move=> i; rewrite rowB (leq_trans (size_add _ _)) // geq_max size_opp.
    by case: (top L i) => -> _; case: (top M i) => -> _.
  exists k; rewrite rowB coefB (proj2 (top L k)) (proj2 (top M k)) opprD addrACA subrr add0r -mulrBl.
  by rewrite mulf_neq0.
have [r [ep eq]] := (FJ21_T6_1_equivalence p q n0 n1 d).1 rel; exists r; split=> [|r' [_ ep' eq']]; last first.
  by rewrite (FJ21_T6_1_edge r n1 d).1 (FJ21_T6_1_edge r' n1 d).1 -ep -eq -ep' -eq'.
split=> //; have er : r = edge p q L M by rewrite ep eq; exact: (FJ21_T6_1_edge r n1 d).1.
have co i : r 0 i = ((L - M)^-1)%:P * ((L%:P - 'X) * p 0 i + ('X - M%:P) * q 0 i) by rewrite er !mxE.
split=> [i|].
  rewrite co mul_polyC (leq_trans (size_scale_leq _ _)) // (leq_trans (size_add _ _)) // geq_max; apply/andP; split;
    rewrite (leq_trans (size_mul_leq _ _)) //; first by rewrite -size_opp opprB size_XsubC; have := sp i; lia.
  by rewrite size_XsubC; have := sq i; lia.
exists k; rewrite co coefCM coefD !mulrBl !coefB !coefXM !coefCM /= (leq_sizeP _ _ (sp k) n.+1) // (leq_sizeP _ _ (sq k) n.+1) // !mulr0 sub0r subr0.
by move: ak; rewrite rowB coefB addrC => ak; rewrite mulf_neq0 ?invr_eq0.
Qed.

(** FJ21.T6.1 full: for a curve $r$ of degree $n+1$ the rows $r+\frac{x-t}{n+1}r'$ have the degree $n$ for all $x$ but at most one.
    Hypotheses: $x\ne y$; $n+1\ne0$ in the field.
    Paper: takes the degree $n$ for granted. *)
Theorem FJ21_T6_1_full n r x y : n.+1%:R != 0 :> F -> degree_is n.+1 r -> x != y ->
  degree_is n (patch n r x) \/ degree_is n (patch n r y).
Proof.
move=> n1 [sr [k ak]] ne; have top z i := FJ21_T6_1_degree z n1 (sr i).
have [e|ex] := eqVneq (patch n r x 0 k)`_n 0; last by left; split; [move=> i; case: (top x i) | exists k].
right; split; first by move=> i; case: (top y i).
exists k; apply: contraNneq ak => e'; have : (x - y) * (r 0 k)`_n.+1 = 0.
  by rewrite mulrBl -[RHS](subrr 0) -[X in X - _ = _](addKr ((r 0 k)`_n / n.+1%:R)) -{1}(proj2 (top x k)) e -{2}e' (proj2 (top y k)); ring.
by move/eqP; rewrite mulf_eq0 subr_eq0 (negPf ne).
Qed.

(** FJ21.6.1 sigma: for constant $\Lambda,M,\sigma$ the edge has the equation $Er=(\Lambda-t)p+\sigma(t-M)q$, of degree at most $n+1$, with the coefficient
    $\sigma q_n-p_n$ of $t^{n+1}$; $E=\Lambda-t+\sigma(t-M)$ is constant for $\sigma=1$ only.
    Hypotheses: $E\ne0$ at $t$, for the equation, so that $v(t)$ has a meaning; $p$, $q$ have degree at most $n$, for the rest.
    Paper: "$v(t)$ is of degree one", which is so for $\sigma=1$; for other $\sigma$ it is a quotient, and the degree $n+1$ that of the homogeneous curve $Er$. *)
Theorem FJ21_6_1_sigma n p q L M s (v := fun t => s * (t - M) / (L - t + s * (t - M))) (r := (L%:P - 'X) *: p + (s *: ('X - M%:P)) *: q) :
  degree_le n p -> degree_le n q ->
  [/\ forall t, L - t + s * (t - M) != 0 -> ev r t = (L - t + s * (t - M)) *: ((1 - v t) *: ev p t + v t *: ev q t),
      degree_le n.+1 r & forall k, (r 0 k)`_n.+1 = s * (q 0 k)`_n - (p 0 k)`_n].
Proof.
move=> sp sq; split=> [t e0|k|k].
- apply/rowP=> k; rewrite !mxE !(hornerD, hornerM, hornerN, hornerZ, hornerC, hornerX) /v.
  by move: (p 0 k).[t] (q 0 k).[t] => P Q; field.
- rewrite !mxE (leq_trans (size_add _ _)) // geq_max -scalerAl; apply/andP; split; last first.
    by rewrite (leq_trans (size_scale_leq _ _)) // (leq_trans (size_mul_leq _ _)) // size_XsubC /= ltnS; exact: sq.
  by rewrite (leq_trans (size_mul_leq _ _)) // -size_opp opprB size_XsubC /= ltnS; exact: sp.
rewrite !mxE coefD -scalerAl coefZ !mulrBl !coefB !coefXM !coefCM /=.
rewrite (leq_sizeP _ _ (sp k) n.+1) // (leq_sizeP _ _ (sq k) n.+1) // !mulr0 sub0r subr0; ring.
Qed.
End Degrees.

Section Places.
Variables (F : fieldType) (m : nat).
Implicit Types (p q r : 'rV[{poly F}]_m) (A B : 'rV[F]_m) (L M x : F) (n N : nat).

Definition inside l (N : 'M[F]_(m, l)) p := p *m map_mx polyC N = 0.
Definition on_rulings A p q := exists x y z : {poly F}, z != 0 /\ z *: map_mx polyC A = x *: p + y *: q.

Lemma pderiv_mul l (N : 'M[F]_(m, l)) p : pderiv p *m map_mx polyC N = pderiv (p *m map_mx polyC N).
Proof.
apply/rowP=> k; rewrite !mxE (raddf_sum (deriv_additive _)); apply: eq_bigr => j _; rewrite !mxE /=.
by rewrite derivM derivC mulr0 addr0.
Qed.

(** FJ21.T6.1 subspace: both boundary curves lie in a subspace iff $r$ does: the surface is a point, a line or a plane iff its edge $r$ is one point, on one
    line or in one plane.
    Hypotheses: $\Lambda\ne M$; $n+1\ne0$ in the field, so that $\frac1{n+1}$ has a meaning.
    Paper: passes over it; where $r$ is a plane curve its tangents cover its plane. *)
Theorem FJ21_T6_1_subspace n r L M l (N : 'M[F]_(m, l)) : n.+1%:R != 0 :> F -> L != M ->
  inside N (patch n r M) /\ inside N (patch n r L) <-> inside N r.
Proof.
move=> n1 d; rewrite /inside; split=> [[eM eL]|e]; last first.
  by split; rewrite /patch mulmxDl -scalemxAl pderiv_mul e add0r; apply/rowP=> k; rewrite !mxE deriv0 mulr0.
by rewrite (FJ21_T6_1_edge r n1 d).1 /edge -scalemxAl mulmxDl -!scalemxAl eM eL !scaler0 addr0 scaler0.
Qed.

Lemma multiple_of A r (k : 'I_m) : A 0 k != 0 -> (forall j, (A 0 k)%:P * r 0 j = (A 0 j)%:P * r 0 k) ->
  r = ((A 0 k)^-1%:P * r 0 k) *: map_mx polyC A.
Proof.
move=> k0 e; apply/rowP=> j; rewrite !mxE -mulrA [r 0 k * _]mulrC -e mulrA -polyCM mulVf // mul1r //.
Qed.

Lemma same_rate (X Y a b a' b' : {poly F}) : Y != 0 -> X * a + Y * a' = 0 -> X * b + Y * b' = 0 -> a' * b = a * b'.
Proof.
move=> Y0 ea eb; apply: (mulfI Y0); rewrite [LHS](_ : _ = (X * a + Y * a') * b - X * a * b); last by ring.
by rewrite [RHS](_ : _ = (X * b + Y * b') * a - X * a * b); [rewrite ea eb !mul0r | ring].
Qed.

(** FJ21.T6.1 no_cone: if all rulings pass through one point $A$, then $r(t)=f(t)A+g(t)B$: the edge, hence the surface, lies on one line. So no cone and no
    cylinder other than such a line is the tangent surface of an $r$.
    Hypotheses: $A\ne0$; $r$ has a degree of at most $N$ with $N!\ne0$ in the field, as all have in characteristic 0; $n+1\ne0$ in the field, so that $\frac1{n+1}$ has a
    meaning. *)
Theorem FJ21_T6_1_no_cone n N r L M A : n.+1%:R != 0 :> F -> good F N -> degree_le N r -> A != 0 ->
  on_rulings A (patch n r M) (patch n r L) -> exists f g B, r = f *: map_mx polyC A + g *: map_mx polyC B.
Proof.
move=> _ gd sr a0 [x [y [z [z0 e]]]].
have [k k0] : exists k, A 0 k != 0.
  by case: (pickP (fun k => A 0 k != 0)) => [k k0|h]; [exists k | case/eqP: a0; apply/rowP=> k; have := h k; rewrite mxE => /negbFE/eqP].
pose X : {poly F} := x + y; pose Y : {poly F} := n.+1%:R^-1 *: (x * (M%:P - 'X) + y * (L%:P - 'X)).
have eXY j : z * (A 0 j)%:P = X * r 0 j + Y * (r 0 j)^`().
  have /rowP/(_ j) := e; rewrite !mxE => ->; rewrite /X /Y -!mul_polyC.
  by move: (r 0 j) (r 0 j)^`() (n.+1%:R^-1)%:P (M%:P - 'X) (L%:P - 'X) => a b c u v; ring.
have k1 : (A 0 k)%:P != 0 :> {poly F} by rewrite polyC_eq0.
pose s j : {poly F} := (A 0 k)%:P * r 0 j - (A 0 j)%:P * r 0 k.
have ds j : (s j)^`() = (A 0 k)%:P * (r 0 j)^`() - (A 0 j)%:P * (r 0 k)^`() by rewrite /s derivB !derivM !derivC !mul0r !add0r.
have es j : X * s j + Y * (s j)^`() = 0.
  rewrite ds /s; transitivity ((A 0 k)%:P * (X * r 0 j + Y * (r 0 j)^`()) - (A 0 j)%:P * (X * r 0 k + Y * (r 0 k)^`())); first by ring.
  by rewrite -!eXY; ring.
have [l l0|s0] := pickP (fun l => s l != 0); last first.
  exists ((A 0 k)^-1%:P * r 0 k), 0, 0; rewrite scale0r addr0; apply: multiple_of => // j.
  by apply/eqP; rewrite -subr_eq0; apply/negbFE; exact: s0.
have Y0 : Y != 0.
  apply: contraNneq l0 => Y0; have := es l; rewrite Y0 mul0r addr0 => /eqP; rewrite mulf_eq0 => /orP[/eqP X0|//].
  by have /eqP := eXY k; rewrite X0 Y0 !mul0r addr0 mulf_eq0 (negPf z0) (negPf k1).
have ss j : (size (s j) <= N.+1)%N.
  rewrite /s !mul_polyC (leq_trans (size_add _ _)) // geq_max size_opp.
  by rewrite !(leq_trans (size_scale_leq _ _)) ?sr.
have prop j : exists b : F, s j == b *: s l.
  have [b eb] : exists b : F, s j = b *: s l; last by exists b; apply/eqP.
  by apply: (proportional_polys gd) => //; apply: (same_rate Y0 (es j) (es l)).
exists ((A 0 k)^-1%:P * r 0 k), ((A 0 k)^-1%:P * s l), (\row_j xchoose (prop j)); apply/rowP=> j; rewrite !mxE.
have ek : (A 0 k)^-1%:P * (A 0 k)%:P = 1 :> {poly F} by rewrite -polyCM mulVf.
have := eqP (xchooseP (prop j)); rewrite -mul_polyC {1}/s; move: (xchoose _) => b eb.
move: eb ek; move: ((A 0 k)^-1%:P) (A 0 k)%:P (A 0 j)%:P (r 0 j) (r 0 k) (s l) b%:P => i x' y' a' b' c' d' eb ek.
by rewrite -[LHS]mul1r -ek -mulrA (_ : x' * a' = d' * c' + y' * b'); [ring | rewrite -eb subrK].
Qed.

(** FJ21.T6.1 no_cone_needs_factorial: where $N=0$ in the field, $N>0$, the tangents of $r=(t,t^N,1)$ are all parallel to $A=(1,0,0)$, and $r$ is no line: a cylinder.
    Hypotheses: $\Lambda\ne M$; $n+1\ne0$ in the field. *)
Theorem FJ21_T6_1_no_cone_needs_factorial n N L M (r : 'rV[{poly F}]_3 := vec 'X 'X^N 1) (A : 'rV[F]_3 := vec 1 0 0) :
  (0 < N)%N -> N%:R = 0 :> F -> n.+1%:R != 0 :> F -> L != M ->
  (exists x y z : {poly F}, z != 0 /\ z *: map_mx polyC A = x *: patch n r M + y *: patch n r L) /\
  forall f g (B : 'rV[F]_3), r <> f *: map_mx polyC A + g *: map_mx polyC B.
Proof.
move=> n0 nF n1 d; have d0 : L - M != 0 by rewrite subr_eq0.
have dr : pderiv r = map_mx polyC A.
  by apply: row3P; rewrite /x_ /y_ /z_ !mxE /= ?derivX ?derivC // derivXn -mulr_natr -polyC_nat nF polyC0 mulr0.
split=> [|f g B /rowP e].
  exists (- (n.+1%:R / (L - M))%:P), (n.+1%:R / (L - M))%:P, 1; split; first exact: oner_neq0.
  have eD : (n.+1%:R / (L - M))%:P * (n.+1%:R^-1%:P * (L%:P - M%:P)) = 1 :> {poly F}.
    by rewrite -polyCB -!polyCM mulrACA mulfV // mulVf // mulr1.
  rewrite /patch dr; move: (map_mx polyC A) => a.
  transitivity (((n.+1%:R / (L - M))%:P * (n.+1%:R^-1%:P * (L%:P - M%:P))) *: a); first by rewrite eD.
  by apply/rowP=> k; rewrite !mxE -!mul_polyC; move: (_ / _)%:P (n.+1%:R^-1)%:P L%:P M%:P (r 0 k) (a 0 k) 'X => d' b l u x y X; ring.
have := (e (@Ordinal 3 1 isT), e (@Ordinal 3 2 isT)); rewrite !mxE /= !mulr0 !add0r => -[e1 e2].
set x := B 0 _ in e1; set y := B 0 _ in e2.
have : 'X^N * y%:P = x%:P by rewrite e1 mulrAC -e2 mul1r.
move/(congr1 (fun h : {poly F} => h`_N)); rewrite coefMC coefXn eqxx mul1r coefC; case: N n0 {nF dr r e1 e} => // N _ /= y0.
by move/eqP: e2; rewrite y0 mulr0 oner_eq0.
Qed.
End Places.

Section Tangents.
Variables (F : fieldType) (m : nat).
Implicit Types (r : 'rV[{poly F}]_m) (f : {poly F}) (L M a b t : F) (n : nat).

(** FJ21.6 tangents: the tangent surface between $p=r$ and $q=r+fr'$ has $\Lambda(t)=t+nf(t)$, $M(t)=t$, $\sigma=1$, and where $f(t)\ne0$ the frame $\lambda=\frac1f$,
    $\mu=\nu=0$.
    Hypotheses: $n\ne0$ in the field, for the first; $f(t)\ne0$, for the frame. *)
Theorem FJ21_6_tangents n r f t (q := r + f *: pderiv r) :
  (n%:R != 0 :> F -> related_at n r q t (t + n%:R * f.[t]) t 1) /\ (f.[t] != 0 -> frame r q t f.[t]^-1 0 0).
Proof.
split=> [n0|f0]; apply/rowP=> k; rewrite !mxE.
  by rewrite hornerD hornerM; move: (r 0 k).[t] (r 0 k)^`().[t] f.[t] (_^`().[t]) => x y z w; field.
by rewrite !hornerD hornerN hornerM; move: (r 0 k).[t] (r 0 k)^`().[t] f.[t] f0 (_^`().[t]) => x y z z0 w; field.
Qed.

(** FJ21.6 lower: for $r$ of degree at most $n$ the curve $r+(at+b)r'$ has a degree of at most $n$, with the leading coefficient $(1+na)r_n$: for $r_n\ne0$ its degree is
    less than $n$ iff $1+na=0$, which is the paper's $a=-\frac1n$, whatever $b$. *)
Theorem FJ21_6_lower n r a b k (q := r + (a%:P * 'X + b%:P) *: pderiv r) : (size (r 0%R k) <= n.+1)%N ->
  [/\ (size (q 0%R k) <= n.+1)%N, (q 0 k)`_n = (1 + n%:R * a) * (r 0 k)`_n &
      (r 0 k)`_n != 0 -> (size (q 0%R k) <= n)%N = (1 + n%:R * a == 0)].
Proof.
rewrite /q !mxE; move: (r 0 k) => g sg.
have co i : (g + (a%:P * 'X + b%:P) * g^`())`_i = (1 + i%:R * a) * g`_i + b * (i.+1%:R * g`_i.+1).
  case: i => [|i]; rewrite coefD mulrDl coefD -mulrA !coefCM coefXM !coef_deriv /=.
    by rewrite mulr0 add0r mul0r addr0 !mul1r mulr1n.
  rewrite -[g`_i.+1 *+ i.+1]mulr_natl -[g`_i.+2 *+ i.+2]mulr_natl.
  by move: (i.+1%:R : F) (i.+2%:R : F) g`_i.+1 g`_i.+2 => x y z w; ring.
have top : (g + (a%:P * 'X + b%:P) * g^`())`_n = (1 + n%:R * a) * g`_n by rewrite co [g`_n.+1]nth_default // !mulr0 addr0.
have sz : (size (g + (a%:P * 'X + b%:P) * g^`())%R <= n.+1)%N.
  by apply/leq_sizeP=> j le_j; rewrite co !nth_default ?mulr0 ?addr0 // (leq_trans sg) // leqW.
split=> // g0; apply/idP/idP => [le_n|/eqP ea].
  by have := top; rewrite (leq_sizeP _ _ le_n n (leqnn n)) => /esym/eqP; rewrite mulf_eq0 (negPf g0) orbF.
apply/leq_sizeP=> j; rewrite leq_eqVlt => /orP[/eqP <-|lt_j]; last by rewrite nth_default // (leq_trans sz).
by rewrite top ea mul0r.
Qed.

(** FJ21.T6.1 frame: $p=r+\frac{M-t}{n+1}r'$ and $q=r+\frac{\Lambda-t}{n+1}r'$ have $p'=\lambda W+\mu W'+\nu p$ with $\lambda=\frac n{\Lambda-M}$, $\mu=\frac{M-t}{\Lambda-M}$,
    $\nu=0$.
    Hypotheses: $\Lambda\ne M$; $n+1\ne0$ in the field. *)
Theorem FJ21_T6_1_frame n r L M t : n.+1%:R != 0 :> F -> L != M ->
  frame (patch n r M) (patch n r L) t (n%:R / (L - M)) ((M - t) / (L - M)) 0.
Proof.
move=> n1; rewrite -subr_eq0 => d; apply/rowP=> k; rewrite !mxE !(derivD, derivN, derivM, derivZ, derivC, derivX, hornerE) /= ?hornerE.
move: (r 0 k).[t] (r 0 k)^`().[t] ((r 0 k)^`()^`()).[t] n1 => a b c; rewrite -[n.+1]addn1 natrD; move: (n%:R : F) => N n1; field.
by rewrite n1 d.
Qed.
End Tangents.
