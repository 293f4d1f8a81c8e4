(* Rational functions of t, and points whose coordinates are rational functions.
   Definitions:
     fderiv x       the derivative of a rational function, by the quotient rule
     pfun p         a row of polynomials as a row of rational functions
     pfderiv x      the derivative of such a row, coordinate by coordinate
     weight p, place p     the first coordinate of a homogeneous row and the others
     affine p       the point place p / weight p of space *)
From Torse Require Import Prelude Points.
From mathcomp Require Import generic_quotient ring_quotient.

Section Quotient.
Import FracField.
Local Open Scope quotient_scope.
Variable R : idomainType.
Notation "x %:F" := (@tofrac R x).

Lemma fraction_div (x : {fraction R}) : x = (\n_(repr x))%:F / (\d_(repr x))%:F.
Proof.
have d0 : (\d_(repr x))%:F != 0 :> {fraction R} by rewrite tofrac_eq0; exact: denom_ratioP.
apply: (mulIf d0); rewrite divfK // -[X in X * _]reprK !piE; apply/eqmodP.
by rewrite /= equivfE /mulf !numden_Ratio ?oner_neq0 ?mulr1 ?denom_ratioP //= mulrC.
Qed.
End Quotient.

(* The quotient rule of sums and products, over any field: `field` is slow on fractions. *)
Lemma quotient_rule_sum (L : fieldType) (f g h k f' g' h' k' : L) : g != 0 -> k != 0 ->
  ((f' * k + f * k' + (h' * g + h * g')) * (g * k) - (f * k + h * g) * (g' * k + g * k')) / (g * k) ^+ 2
    = (f' * g - f * g') / g ^+ 2 + (h' * k - h * k') / k ^+ 2.
Proof. by move=> g0 k0; field; rewrite g0 k0. Qed.

Lemma quotient_rule_product (L : fieldType) (f g h k f' g' h' k' : L) : g != 0 -> k != 0 ->
  ((f' * h + f * h') * (g * k) - f * h * (g' * k + g * k')) / (g * k) ^+ 2
    = (f' * g - f * g') / g ^+ 2 * (h / k) + f / g * ((h' * k - h * k') / k ^+ 2).
Proof. by move=> g0 k0; field; rewrite g0 k0. Qed.

Lemma quotient_inverse (L : fieldType) (x z : L) : x != 0 -> - (z * x^-1) = x * (- z / x ^+ 2).
Proof. by move=> x0; field. Qed.

Section Functions.
Variable F : fieldType.
Notation K := {fraction {poly F}}.
Notation "x %:F" := (@FracField.tofrac [idomainType of {poly F}] x).
Implicit Types (x y : K) (f g : {poly F}).

Definition fderiv x : K := let n := \n_(repr x) in let d := \d_(repr x) in (n^`() * d - n * d^`())%:F / (d ^+ 2)%:F.

Lemma fraction_ex x : exists f g, g != 0 /\ x = f%:F / g%:F.
Proof. by exists (\n_(repr x)), (\d_(repr x)); split; [exact: denom_ratioP | exact: fraction_div]. Qed.

(* The quotient rule, whatever numerator and denominator represent the function. *)
Lemma fderiv_div f g : g != 0 -> fderiv (f%:F / g%:F) = (f^`() * g - f * g^`())%:F / (g ^+ 2)%:F.
Proof.
move=> g0; rewrite /fderiv; set x := f%:F / g%:F.
have := fraction_div x; have := denom_ratioP (repr x).
move: (\n_(repr x)) (\d_(repr x)) => n d d0.
have gF : g%:F != 0 by rewrite tofrac_eq0.
have dF : d%:F != 0 by rewrite tofrac_eq0.
move/eqP; rewrite /x eqr_div // -!tofracM tofrac_eq => /eqP e.
have := congr1 (@deriv F) e; rewrite !derivM => e'.
apply/eqP; rewrite eqr_div ?tofracX ?expf_neq0 // -!tofracX -!tofracM tofrac_eq -subr_eq0.
rewrite (_ : _ - _ = d * g * ((n^`() * g + n * g^`()) - (f^`() * d + f * d^`())) + (d^`() * g + d * g^`()) * (f * d - n * g)).
  by rewrite e e' !subrr !mulr0 addr0.
by move: (n^`()) (d^`()) (f^`()) (g^`()) => *; ring.
Qed.

Lemma fderiv_poly f : fderiv f%:F = (f^`())%:F.
Proof.
by rewrite -[f%:F]divr1 -tofrac1 fderiv_div ?oner_neq0 // derivC mulr0 subr0 mulr1 expr1n tofrac1 divr1.
Qed.

Lemma fderivD x y : fderiv (x + y) = fderiv x + fderiv y.
Proof.
have [f [g [g0 ->]]] := fraction_ex x; have [h [k [k0 ->]]] := fraction_ex y.
have [gF kF] : g%:F != 0 /\ k%:F != 0 by rewrite !tofrac_eq0.
rewrite addf_div // -!tofracM -tofracD !fderiv_div ?mulf_neq0 // !derivD !derivM.
rewrite !(tofracB, tofracD, tofracM, tofracX); exact: quotient_rule_sum.
Qed.

Lemma fderivM x y : fderiv (x * y) = fderiv x * y + x * fderiv y.
Proof.
have [f [g [g0 ->]]] := fraction_ex x; have [h [k [k0 ->]]] := fraction_ex y.
have [gF kF] : g%:F != 0 /\ k%:F != 0 by rewrite !tofrac_eq0.
rewrite mulf_div -!tofracM !fderiv_div ?mulf_neq0 // !derivM.
rewrite !(tofracB, tofracD, tofracM, tofracX); exact: quotient_rule_product.
Qed.

Lemma fderivN x : fderiv (- x) = - fderiv x.
Proof.
have f1 : fderiv (-1) = 0 by rewrite -tofrac1 -tofracN fderiv_poly derivN derivC oppr0 tofrac0.
by rewrite -mulN1r fderivM f1 mul0r add0r mulN1r.
Qed.

Lemma fderivB x y : fderiv (x - y) = fderiv x - fderiv y.
Proof. by rewrite fderivD fderivN. Qed.

Lemma fderivV x : x != 0 -> fderiv x^-1 = - fderiv x / x ^+ 2.
Proof.
move=> x0; have := congr1 fderiv (mulfV x0); rewrite fderivM -tofrac1 fderiv_poly derivC tofrac0 => /eqP.
rewrite addrC addr_eq0 => /eqP e; by apply: (mulfI x0); rewrite e quotient_inverse.
Qed.
End Functions.

Section Rows.
Variables (F : fieldType) (m : nat).
Notation K := {fraction {poly F}}.
Notation "x %:F" := (@FracField.tofrac [idomainType of {poly F}] x).
Implicit Types (p q : 'rV[{poly F}]_m) (x : 'rV[K]_m).

Definition pfun p : 'rV[K]_m := map_mx (@FracField.tofrac _) p.
Definition pfderiv x : 'rV[K]_m := map_mx (@fderiv F) x.

Lemma pfunE p k : pfun p 0 k = (p 0 k)%:F.
Proof. by rewrite mxE. Qed.

Lemma pfderivE x k : pfderiv x 0 k = fderiv (x 0 k).
Proof. by rewrite mxE. Qed.

Lemma pfderiv_fun p : pfderiv (pfun p) = pfun (pderiv p).
Proof. by apply/rowP=> k; rewrite !mxE fderiv_poly. Qed.

Lemma pfunD p q : pfun (p + q) = pfun p + pfun q.
Proof. by apply/rowP=> k; rewrite !mxE tofracD. Qed.

Lemma pfunB p q : pfun (p - q) = pfun p - pfun q.
Proof. by apply/rowP=> k; rewrite !mxE tofracB. Qed.

Lemma pfunZ f p : pfun (f *: p) = f%:F *: pfun p.
Proof. by apply/rowP=> k; rewrite !mxE tofracM. Qed.

Lemma pfun_inj : injective pfun.
Proof. by move=> p q /rowP e; apply/rowP=> k; have /eqP := e k; rewrite !mxE tofrac_eq => /eqP. Qed.
End Rows.

Section Space.
Variable F : fieldType.
Implicit Type p : 'rV[{poly F}]_4.

Definition weight (R : Type) (p : 'rV[R]_4) := p 0 0.
Definition place (R : Type) (p : 'rV[R]_4) : 'rV[R]_3 := \row_k p 0 (lift ord0 k).
Definition affine p : 'rV[{fraction {poly F}}]_3 := (weight (pfun p))^-1 *: place (pfun p).
End Space.

