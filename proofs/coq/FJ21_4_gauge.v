(* FJ21, equation (4.3): when there is a frame, and when a factor f removes its term along p. Curves are rows of rational functions of t.
   Definitions:
     fframe P Q lam mu nu   P' = lam W + mu W' + nu P with rational functions lam, mu, nu, W = Q - P *)
From Torse Require Import Prelude Blossom Curves Points Functions FJ21_2 FJ21_3_theorem FJ21_3_needs.

(* The algebra of the gauge rule, in any field. *)
Section Algebra.
Variables (K : fieldType) (m : nat).
Implicit Types (P Q : 'rV[K]_m) (f g lam mu nu : K).

Lemma gauge_rule P Q (P' Q' : 'rV[K]_m) f g lam mu nu : f != 0 -> P' = lam *: (Q - P) + mu *: (Q' - P') + nu *: P <->
  g *: P + f *: P' = (lam - mu * g / f) *: (f *: Q - f *: P) + mu *: (g *: Q + f *: Q' - (g *: P + f *: P')) + (nu + g / f) *: (f *: P).
Proof.
move=> f0; split=> [e|e].
  by rewrite {1}e; apply/rowP=> k; rewrite !mxE; move: (P 0 k) (Q 0 k) (P' 0 k) (Q' 0 k) => *; field.
apply: (scalerI f0); apply: (addrI (g *: P)); rewrite e; apply/rowP=> k; rewrite !mxE.
by move: (P 0 k) (Q 0 k) (P' 0 k) (Q' 0 k) => *; field.
Qed.

Lemma regroup P Q (P' Q' : 'rV[K]_m) (i j k l : K) :
  i *: P + j *: P' + k *: Q + l *: Q' = (i + k) *: P + (j + l) *: P' + k *: (Q - P) + l *: (Q' - P').
Proof. by by_entries h; ring. Qed.

Lemma solve_frame (P P' V V' : 'rV[K]_m) (i j k l : K) : j != 0 -> i *: P + j *: P' + k *: V + l *: V' = 0 ->
  P' = (- k / j) *: V + (- l / j) *: V' + (- i / j) *: P.
Proof.
move=> j0 e; apply: (scalerI j0); apply/eqP; rewrite -subr_eq0; apply/eqP; rewrite -[RHS]e.
by by_entries h; field.
Qed.

Lemma frame_zero P Q (P' Q' : 'rV[K]_m) lam mu nu : P' = lam *: (Q - P) + mu *: (Q' - P') + nu *: P ->
  (nu - lam) *: P + (- 1 - mu) *: P' + lam *: Q + mu *: Q' = 0.
Proof.
move=> e; transitivity (lam *: (Q - P) + mu *: (Q' - P') + nu *: P - P'); last by rewrite -e subrr.
by by_entries h; ring.
Qed.

Lemma two_frames (P V V' : 'rV[K]_m) (l m' n l1 m1 n1 : K) : l *: V + m' *: V' + n *: P = l1 *: V + m1 *: V' + n1 *: P ->
  (n - n1) *: P + (l - l1) *: V + (m' - m1) *: V' = 0.
Proof.
move=> e; transitivity (l *: V + m' *: V' + n *: P - (l1 *: V + m1 *: V' + n1 *: P)); last by rewrite e subrr.
by by_entries h; ring.
Qed.

Lemma free_tangents P Q (Q' : 'rV[K]_m) : free P Q Q' -> free P (Q - P) (Q' - Q).
Proof.
move=> fr i j k e; have /fr[ij jk k0] : (i - j) *: P + (j - k) *: Q + k *: Q' = 0 by rewrite -[RHS]e; by_entries h; ring.
by move/eqP: jk; rewrite k0 subr0 => /eqP j0; move: ij; rewrite j0 subr0.
Qed.

Lemma power_rule (E c n x : K) : E != 0 -> x != 0 -> - (n * c * x) / (E * x) ^+ 2 = - (n * c / E * (E * x)^-1).
Proof. by move=> E0 x0; field; rewrite E0 x0. Qed.
End Algebra.

Section Frames.
Variable F : fieldType.
Notation K := {fraction {poly F}}.
Notation "x %:F" := (@FracField.tofrac [idomainType of {poly F}] x).
Implicit Types (f lam mu nu : K) (n m : nat).

Definition fframe m (P Q : 'rV[K]_m) lam mu nu := pfderiv P = lam *: (Q - P) + mu *: pfderiv (Q - P) + nu *: P.

Lemma pfderivB m (P Q : 'rV[K]_m) : pfderiv (Q - P) = pfderiv Q - pfderiv P.
Proof. by apply/rowP=> k; rewrite !mxE fderivB. Qed.

Lemma pfderivZ m f (P : 'rV[K]_m) : pfderiv (f *: P) = fderiv f *: P + f *: pfderiv P.
Proof. by apply/rowP=> k; rewrite !mxE fderivM. Qed.

(** FJ21.4.3 exists: the surface is developable iff rational functions $\lambda,\mu,\nu$ with $p'=\lambda W+\mu W'+\nu p$, $W=q-p$, exist.
    Hypotheses: $p$, $W$, $W'$ are independent over the rational functions, for the direction from the surface to the frame; the weights do not vanish identically,
    so that there are curves $c$ and $d$.
    Paper: excludes cylinders; it must exclude all surfaces where $W'$ depends on $p$ and $W$. *)
Theorem FJ21_4_3_exists (p q : 'rV[{poly F}]_4) : weight p != 0 -> weight q != 0 ->
  free (pfun p) (pfun q - pfun p) (pfderiv (pfun q - pfun p)) ->
  rational_developable p q <-> exists lam mu nu, fframe (pfun p) (pfun q) lam mu nu.
Proof.
move=> w0 om0 fr; split=> [dev|[lam [mu [nu fe]]]].
  have /eqP := (FJ21_2_1_determinant w0 om0).1 dev; rewrite -tofrac_eq0 det_pfun => /eqP/det_dependent [i [j [k [l [nz e]]]]].
  move: fr; rewrite /fframe pfderivB !pfderiv_fun; move: (pfun p) (pfun q) (pfun (pderiv p)) (pfun (pderiv q)) e => P Q P' Q' e fr.
  rewrite regroup in e.
  have jl : j + l != 0.
    apply: contraNneq nz => jl; rewrite jl scale0r addr0 in e; have [ik k0 l0] := fr _ _ _ e.
    by move: ik jl; rewrite k0 l0 !addr0 => -> ->.
  by exists (- k / (j + l)), (- l / (j + l)), (- (i + k) / (j + l)); exact: solve_frame e.
apply/(FJ21_2_1_determinant w0 om0)/eqP; rewrite -tofrac_eq0 det_pfun; apply/eqP/det_dependent.
move: fe; rewrite /fframe pfderivB !pfderiv_fun; move: (pfun p) (pfun q) (pfun (pderiv p)) (pfun (pderiv q)) => P Q P' Q' e.
exists (nu - lam), (- 1 - mu), lam, mu; split; last exact: frame_zero e.
apply/eqP=> -[_ /eqP + _ mu0]; by rewrite mu0 subr0 oppr_eq0 oner_eq0.
Qed.

(** FJ21.4.3 functions: for rational $f\ne0$: $\lambda,\mu,\nu$ are the functions of $p$, $q$ iff $\lambda-\mu f'/f$, $\mu$, $\nu+f'/f$ are those of $fp$, $fq$.
    Hypotheses: $f$ is not the zero function. *)
Theorem FJ21_4_3_functions m (P Q : 'rV[K]_m) f lam mu nu : f != 0 ->
  fframe P Q lam mu nu <-> fframe (f *: P) (f *: Q) (lam - mu * fderiv f / f) mu (nu + fderiv f / f).
Proof. by move=> f0; rewrite /fframe !pfderivB !pfderivZ; exact: gauge_rule. Qed.

(** FJ21.4.3 cancel: a rational factor $f$ removes the term $\nu$ iff $f'=-\nu f$.
    Hypotheses: $p$, $W$, $W'$ are independent over the rational functions.
    Paper: $f=e^{-\int\nu}$, which need not be rational. *)
Theorem FJ21_4_3_cancel m (P Q : 'rV[K]_m) f lam mu nu : free P (Q - P) (pfderiv (Q - P)) -> fframe P Q lam mu nu ->
  (exists lam' mu', fframe (f *: P) (f *: Q) lam' mu' 0) <-> fderiv f = - (nu * f).
Proof.
move=> fr e; have f1 : fderiv (0 : K) = 0 by rewrite -tofrac0 fderiv_poly linear0 tofrac0.
have [->|f0] := eqVneq f 0.
  split=> [_|_]; first by rewrite mulr0 oppr0 f1.
  by exists 0, 0; rewrite /fframe pfderivZ f1 !scale0r !addr0.
split=> [[lam' [mu' e']]|ef]; last first.
  exists (lam - mu * fderiv f / f), mu; have := (FJ21_4_3_functions P Q lam mu nu f0).1 e.
  by rewrite {2}ef mulNr mulfK // subrr.
have := (FJ21_4_3_functions P Q (lam' + mu' * fderiv f / f) mu' (- (fderiv f / f)) f0).2; rewrite addrK addNr => /(_ e') e2.
have /fr[/eqP + _ _] := two_frames (etrans (esym e) e2).
by rewrite subr_eq0 => /eqP ->; rewrite mulNr opprK divfK.
Qed.

(** FJ21.4.3 constants: for constant $\Lambda,M,\sigma$, where $\nu=n(\sigma-1)/E$ with $E=\Lambda-\sigma M+t(\sigma-1)$, the factor $f=E^{-n}$ is rational and has $f'=-\nu f$.
    Hypotheses: $E$ is not the zero polynomial, so that $\nu$ and $f$ have a meaning. *)
Theorem FJ21_4_3_constants n (L M s : F) (E : {poly F} := (L - s * M)%:P + (s - 1) *: 'X) (f := (E%:F ^+ n)^-1) : E != 0 ->
  fderiv f = - (n%:R * ((s - 1)%:P)%:F / E%:F * f).
Proof.
move=> E0; have EF : E%:F != 0 by rewrite tofrac_eq0.
have dE : fderiv (E%:F ^+ n) = n%:R * ((s - 1)%:P)%:F * E%:F ^+ n.-1.
  have dp : (E ^+ n)^`() = n%:R * (s - 1)%:P * E ^+ n.-1.
    by rewrite deriv_exp derivD derivC derivZ derivX add0r alg_polyC -mulrA mulr_natl.
  by rewrite -tofracX fderiv_poly dp !tofracM tofracX tofracMn tofrac1.
rewrite /f fderivV ?expf_neq0 // dE; case: n {dE f} => [|n]; first by rewrite !mul0r oppr0 mul0r.
rewrite [E%:F ^+ n.+1]exprS; apply: power_rule; rewrite ?expf_neq0 //.
Qed.

(* A rational function with f' = -f vanishes: f = a/b has a'b - ab' = -ab, of a lower degree than ab. *)
Lemma no_exponential f : fderiv f = - f -> f = 0.
Proof.
have [a [b [b0 ->]]] := fraction_ex f; have bF : b%:F != 0 by rewrite tofrac_eq0.
rewrite fderiv_div // => e; have [->|a0] := eqVneq a 0; first by rewrite tofrac0 mul0r.
have : a^`() * b - a * b^`() = - (a * b).
  apply/eqP; rewrite -tofrac_eq; apply/eqP; rewrite tofracX in e.
  have := congr1 ( *%R^~ (b%:F ^+ 2)) e; rewrite divfK ?expf_neq0 // => ->.
  by rewrite mulNr expr2 mulrA divfK // tofracN tofracM.
have lt (x y : {poly F}) : x != 0 -> y != 0 -> (size (x^`() * y)%R < size (x * y)%R)%N.
  move=> x0 y0; have [->|d0] := eqVneq (x^`()) 0; first by rewrite mul0r size_poly0 size_poly_gt0; exact: mulf_neq0.
  rewrite !size_mul //; have := lt_size_deriv x0; have : (0 < size y)%N by rewrite size_poly_gt0.
  move: (size x) (size y) (size (x^`())) => i j k lt_j lt_k.
  by case: j lt_j => // j _; rewrite !addnS /= ltn_add2r.
move/(congr1 (fun h : {poly F} => size h)); rewrite size_opp => es.
have : (size (a^`() * b - a * b^`())%R < size (a * b)%R)%N.
  rewrite (leq_ltn_trans (size_add _ _)) // size_opp gtn_max lt //= [a * _]mulrC [a * b]mulrC lt //.
by rewrite es ltnn.
Qed.

(** FJ21.4.3 needs_exponential: for $p=(1+t,t,t^2,t^3)$ and $q=p'$, with $\lambda=\nu=1$, $\mu=0$, no rational $f\ne0$ removes $\nu$: $e^{-t}$ is not rational.
    Hypotheses: $2\ne0$ in the field: in characteristic 2 there always is one ("characteristic" below). *)
Theorem FJ21_4_3_needs_exponential (p : 'rV[{poly F}]_4 := row4 (1 + 'X) 'X ('X ^+ 2) ('X ^+ 3)) (P := pfun p) (Q := pfun (pderiv p)) : 2%:R != 0 :> F ->
  fframe P Q 1 0 1 /\ forall f lam mu, f != 0 -> ~ fframe (f *: P) (f *: Q) lam mu 0.
Proof.
move=> n2; have e : fframe P Q 1 0 1 by rewrite /fframe scale0r addr0 !scale1r subrK pfderiv_fun.
split=> // f lam mu f0 e'; have fr : free P (Q - P) (pfderiv (Q - P)).
  have fr3 : free P Q (pfderiv Q).
    rewrite /Q pfderiv_fun; apply: (free_bent (t := FracField.tofrac 'X)); rewrite /weight !mxE /= ?derivD ?derivC ?derivX ?add0r ?tofrac1 ?tofrac0 //.
    - by rewrite tofracD tofrac1.
    - by rewrite derivC tofrac0.
    - by rewrite derivC tofrac0.
    by rewrite tofrac_eq0 derivXn derivMn derivX /= -polyC1 -polyCMn polyC_eq0.
  by rewrite pfderivB (_ : pfderiv P = Q) ?pfderiv_fun //; apply: free_tangents; rewrite -pfderiv_fun.
have /no_exponential/eqP : fderiv f = - f by rewrite -[in RHS](mul1r f); apply/(FJ21_4_3_cancel f fr e); exists lam, mu.
by rewrite (negPf f0).
Qed.

(** FJ21.4.3 needs_turning: a cylinder over a parabola, $q=p+(0,0,0,1)$ with $p=(1,t,t^2,0)$, has no frame: $W'=0$, and $p'$ is no combination of $W$ and $p$. *)
Theorem FJ21_4_3_needs_turning (p : 'rV[{poly F}]_4 := row4 1 'X ('X ^+ 2) 0) (q : 'rV[{poly F}]_4 := row4 1 'X ('X ^+ 2) 1) :
  rational_developable p q /\ forall lam mu nu, ~ fframe (pfun p) (pfun q) lam mu nu.
Proof.
have [w wv] : weight p = 1 /\ weight q = 1 by rewrite /weight !mxE.
have dv : pderiv q = pderiv p by apply/rowP=> k; rewrite !mxE; case: k => -[|[|[|[|//]]]] lt_k /=; rewrite ?derivC.
split=> [|lam mu nu].
  apply/FJ21_2_1_determinant; rewrite ?w ?wv ?oner_eq0 //; apply/det_dependent; exists 0, 1, 0, (-1); split.
    by rewrite !xpair_eqE oner_eq0 andbF.
  by rewrite dv !scale0r add0r addr0 scale1r scaleN1r subrr.
rewrite /fframe pfderivB !pfderiv_fun dv subrr scaler0 addr0 => /rowP e; have := (e 0, e 1); rewrite !mxE /= derivC derivX.
by rewrite !subrr !mulr0 !add0r tofrac0 tofrac1 mulr1 => -[<-]; rewrite mul0r => /eqP; rewrite oner_eq0.
Qed.
End Frames.
