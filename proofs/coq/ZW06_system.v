(* ZW06, the method in general: a' = a tau + b tau' as a linear system for the points of tau.
   Definitions:
     column n a b i    the polynomial a B_i + b B_i': the column of the unknown tau_i
     solves n p a b tau   a' = a tau + b tau' for the Bezier curves of the points p and tau *)
From Torse Require Import Prelude Blossom Curves Points Bernstein Bezier BZZ19_4 ZW06 ZW06_cases.

Section System.
Variables (F : fieldType) (m : nat).
Implicit Types (p tau : nat -> 'rV[F]_m) (kappa : nat -> F) (a b h : {poly F}) (n D i j : nat).

Definition column n a b i : {poly F} := a * B F n i + b * (B F n i)^`().
Definition solves n p a b tau := pderiv (pbez n p) = a *: pbez n tau + b *: pderiv (pbez n tau).

Lemma along_columns n a b kappa :
  a * bez n kappa + b * (bez n kappa)^`() = \sum_(0 <= i < n.+1) (kappa i)%:P * column n a b i.
Proof.
rewrite /bez (raddf_sum (deriv_additive _)) !mulr_sumr -big_split; apply: eq_big_nat => i _ /=.
by rewrite /column derivM derivC mul0r add0r; ring.
Qed.

Lemma size_along n D a b kappa : (n <= D)%N -> (size a <= (D - n).+1)%N -> (size b <= (D - n).+2)%N ->
  (size (a * bez n kappa + b * (bez n kappa)^`())%R <= D.+1)%N.
Proof.
move=> le_n sa sb; rewrite (leq_trans (size_add _ _)) // geq_max; apply/andP; split.
  by rewrite (leq_trans (size_mul_leq _ _)) //; have := size_bez n kappa; lia.
have [->|k0] := eqVneq (bez n kappa) 0; first by rewrite linear0 mulr0 size_poly0.
rewrite (leq_trans (size_mul_leq _ _)) //; have := size_bez n kappa; have := lt_size_deriv k0; lia.
Qed.

Lemma in_bernstein_sum n D a b kappa j :
  in_bernstein D (\sum_(0 <= i < n.+1) (kappa i)%:P * column n a b i) j
    = \sum_(0 <= i < n.+1) kappa i * in_bernstein D (column n a b i) j.
Proof.
rewrite /in_bernstein; under [LHS]eq_bigr do rewrite coef_sum mulr_sumr.
rewrite exchange_big /=; apply: eq_bigr => i _; rewrite mulr_sumr; apply: eq_bigr => k _.
by rewrite coefCM mulrCA.
Qed.

(** ZW06.G system: $a'=a\tau+b\tau'$ iff for $j=0..D$ the Bernstein coefficients of degree $D$ obey $\sum_iG_{ji}\tau_i=g_j$, $G_{ji}$ those of
    $aB_i^n+b(B_i^n)'$ and $g_j$ those of $a'$.
    Hypotheses: $D\ge n+\max(\deg a,\deg b-1)$ and $D\ge n$; no $C(D,j)$ vanishes in the field, as in characteristic 0, so that $G_{ji}$ and $g_j$ have a meaning. *)
Theorem ZW06_G_system n D p tau a b : independent F D -> (n <= D)%N -> (size a <= (D - n).+1)%N -> (size b <= (D - n).+2)%N ->
  solves n p a b tau <->
  forall j, (j <= D)%N -> \sum_(0 <= i < n.+1) in_bernstein D (column n a b i) j *: tau i
    = \row_k in_bernstein D (pderiv (pbez n p) 0 k) j.
Proof.
move=> ind le_n sa sb.
have eq_k k : (a *: pbez n tau + b *: pderiv (pbez n tau)) 0 k = \sum_(0 <= i < n.+1) (coord tau k i)%:P * column n a b i.
  by rewrite -along_columns !mxE.
have sum_k j k : (\sum_(0 <= i < n.+1) in_bernstein D (column n a b i) j *: tau i) 0 k
    = in_bernstein D (\sum_(0 <= i < n.+1) (coord tau k i)%:P * column n a b i) j.
  by rewrite summxE in_bernstein_sum; apply: eq_big_nat => i _; rewrite mxE mulrC.
rewrite /solves; split=> [e j le_j|h]; apply/rowP=> k; first by rewrite sum_k -eq_k -e [RHS]mxE.
have sp : (size (pderiv (pbez n p) 0%R k) <= D.+1)%N.
  rewrite !mxE; have [->|k0] := eqVneq (bez n (coord p k)) 0; first by rewrite linear0 size_poly0.
  have := size_bez n (coord p k); have := lt_size_deriv k0; lia.
rewrite eq_k (BZZ19_14_bernstein ind sp) (BZZ19_14_bernstein ind (_ : (size (\sum_(0 <= i < n.+1) (coord tau k i)%:P * column n a b i)%R <= D.+1)%N)).
  by apply: bez_ext => j le_j; rewrite -sum_k h // !mxE.
by rewrite -(along_columns n a b (coord tau k)); apply: size_along.
Qed.

(** ZW06.G unique: the solutions are one solution plus the points with $a\kappa+b\kappa'=0$ in every coordinate: a solution is the only one iff the
    system without right side has no solution but 0.
    Hypotheses: there is a solution; the space has a dimension. *)
Theorem ZW06_G_unique n p tau a b : (0 < m)%N -> solves n p a b tau ->
  (forall tau', solves n p a b tau' -> forall i, (i <= n)%N -> tau' i = tau i) <->
  (forall kappa, a * bez n kappa + b * (bez n kappa)^`() = 0 -> forall i, (i <= n)%N -> kappa i = 0).
Proof.
move=> m0 sol; split=> [only kappa k0 i le_i | triv tau' sol' i le_i].
  pose tau' i := tau i + const_mx (kappa i).
  have sol' : solves n p a b tau'.
    rewrite /solves sol; apply/rowP=> k; rewrite !mxE.
    have -> : bez n (coord tau' k) = bez n (coord tau k) + bez n kappa.
      by rewrite -bez_add; apply: bez_ext => j _; rewrite /coord !mxE.
    by rewrite derivD !mulrDr addrACA k0 addr0.
  have /rowP/(_ (Ordinal m0)) := only tau' sol' i le_i; rewrite !mxE => /eqP.
  by rewrite -subr_eq0 addrC addKr => /eqP.
apply/rowP=> k; apply/eqP; rewrite -subr_eq0; apply/eqP.
apply: (triv (fun j => coord tau' k j - coord tau k j)) => //.
rewrite bez_sub derivB !mulrBr addrACA -opprD.
have := congr1 (fun r : 'rV_m => r 0 k) sol; have := congr1 (fun r : 'rV_m => r 0 k) sol'; rewrite !mxE => <- <-.
by rewrite subrr.
Qed.

(** ZW06.G family: two solutions without right side have a constant quotient: one of them, if it is not 0, spans them all.
    Hypotheses: $a,b$ are not both 0; $n!\ne0$ in the field. *)
Theorem ZW06_G_family n a b kappa kappa' : good F n -> (a, b) != (0, 0) -> bez n kappa != 0 ->
  a * bez n kappa + b * (bez n kappa)^`() = 0 -> a * bez n kappa' + b * (bez n kappa')^`() = 0 ->
  exists s, forall i, (i <= n)%N -> kappa' i = s * kappa i.
Proof.
move=> g nz k0 e e'; have b0 : b != 0.
  by apply: contraNneq nz => b0; move: e; rewrite b0 mul0r addr0 => /eqP; rewrite mulf_eq0 (negPf k0) orbF => /eqP ->.
have [s eq_s] : exists s : F, bez n kappa' = s *: bez n kappa.
  apply: (proportional_polys g) => //; rewrite ?size_bez //; apply: (mulfI b0).
  move: (bez n kappa) (bez n kappa') e e' => x y /(canRL (addKr _)) ex /(canRL (addKr _)) ey.
  by rewrite mulrA ey mulrCA ex; ring.
exists s; apply: (bez_inj (good_independent g)); by rewrite bez_scale mul_polyC.
Qed.

(* What the equation does to powers of u: the coefficient k of a h + (b0 + beta u) h'. *)
Lemma coef_along (a b0 beta : F) h k :
  (a%:P * h + (b0%:P + beta%:P * 'X) * h^`())`_k = (a + k%:R * beta) * h`_k + k.+1%:R * b0 * h`_k.+1.
Proof.
rewrite coefD mulrDl coefD -[_ * 'X * _]mulrA !coefCM coefXM !coef_deriv -[h`_k.+1 *+ k.+1]mulr_natl.
case: k => [|k] /=; first by rewrite mulr0 addr0 mul0r addr0 mulrCA -mulrA.
by rewrite -[h`_k.+1 *+ k.+1]mulr_natl; move: (h`_k.+1) (h`_k.+2) (k.+1%:R : F) (k.+2%:R : F) => y z v w; ring.
Qed.

(** ZW06.G square: for constant $a$ and $b=b_0+\beta u$ the system has only one solution if $a+k\beta\ne0$ for $k=0..n$.
    Hypotheses: no $C(n,i)$ vanishes in the field, as in characteristic 0. *)
Theorem ZW06_G_square n (a b0 beta : F) kappa : independent F n -> (forall k, (k <= n)%N -> a + k%:R * beta != 0) ->
  a%:P * bez n kappa + (b0%:P + beta%:P * 'X) * (bez n kappa)^`() = 0 -> forall i, (i <= n)%N -> kappa i = 0.
Proof.
move=> ind nz e; suff q0 : bez n kappa = 0.
  have z0 : bez n (fun=> 0 : F) = 0 by rewrite /bez big1 // => i _; rewrite polyC0 mul0r.
  by apply: (bez_inj ind (d := fun=> 0)); rewrite q0 z0.
move: (bez n kappa) (size_bez n kappa) e => q sq e.
have step j : (a + j%:R * beta) * q`_j = - (j.+1%:R * b0 * q`_j.+1).
  by apply/eqP; rewrite -addr_eq0 -coef_along e coef0.
have zero k : (k <= n.+1)%N -> forall j, (n.+1 - k <= j)%N -> q`_j = 0.
  elim: k => [|k ih] le_k j le_j; first by rewrite nth_default // (leq_trans sq) //; lia.
  have [lt_j|le_j'] := leqP (n.+1 - k) j; first by apply: ih => //; lia.
  have := step j; rewrite (ih _ j.+1) ?mulr0 ?oppr0; [|lia|lia] => /eqP; rewrite mulf_eq0 (negPf (nz _ _)) /= => [/eqP //|].
  by lia.
by apply/polyP=> j; rewrite coef0; apply: (zero n.+1) => //; lia.
Qed.
End System.
