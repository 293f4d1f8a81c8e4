(* FJ21, section 3: equation (3.3) and Theorem 3.1 in its true form, over the rational functions of t.
   Definitions:
     ftangent n p x         p[t, ..., t, x] = p + (x-t)/n p' for a rational function x of t
     frelated n p q L M s   p[t, ..., t, L] = s q[t, ..., t, M] for rational functions L, M, s
     spanned x a b c        x is a combination of a, b, c with rational functions as coefficients
     free a b c             a, b, c are independent *)
From Torse Require Import Prelude Blossom Curves Points Functions FJ21_2.

Section Spans.
Variables (K : fieldType) (m : nat).
Implicit Types (p q x a b c : 'rV[K]_m).

Definition spanned x a b c := exists i j k : K, x = i *: a + j *: b + k *: c.
Definition free a b c := forall i j k : K, i *: a + j *: b + k *: c = 0 -> [/\ i = 0, j = 0 & k = 0].

(** FJ21.3.3 dependence: for $\Lambda=\frac{\lambda_1}{\lambda_0+\lambda_1}$, $M=\frac{\mu_1}{\mu_0+\mu_1}$, $\sigma=\frac{\mu_0+\mu_1}{\lambda_0+\lambda_1}$:
    $\lambda_0p_0+\lambda_1p_1=\mu_0q_0+\mu_1q_1$ iff $(1-\Lambda)p_0+\Lambda p_1=\sigma((1-M)q_0+Mq_1)$.
    Hypotheses: $\lambda_0+\lambda_1\ne0$ and $\mu_0+\mu_1\ne0$.
    Paper: excludes the first only. *)
Theorem FJ21_3_3_dependence p0 p1 q0 q1 (l0 l1 m0 m1 : K) (L := l1 / (l0 + l1)) (M := m1 / (m0 + m1)) :
  l0 + l1 != 0 -> m0 + m1 != 0 ->
  l0 *: p0 + l1 *: p1 = m0 *: q0 + m1 *: q1 <->
  (1 - L) *: p0 + L *: p1 = ((m0 + m1) / (l0 + l1)) *: ((1 - M) *: q0 + M *: q1).
Proof.
move=> l m'; have -> : (1 - L) *: p0 + L *: p1 = (l0 + l1)^-1 *: (l0 *: p0 + l1 *: p1).
  by rewrite /L; by_entries k; field.
have -> : ((m0 + m1) / (l0 + l1)) *: ((1 - M) *: q0 + M *: q1) = (l0 + l1)^-1 *: (m0 *: q0 + m1 *: q1).
  by rewrite /M; by_entries k; field; rewrite l m'.
by split=> [-> //|]; apply: scalerI; rewrite invr_eq0.
Qed.

(* Theorem 3.1 for four vectors p, p', q, q'. *)
Lemma related_spanned p p' q q' : (exists x y s : K, s != 0 /\ p + x *: p' = s *: (q + y *: q')) <->
  spanned p p' q q' /\ spanned q q' p p'.
Proof.
split=> [[x [y [s [s0 e]]]]|[[i [j [k ep]]] [i' [j' [k' eq]]]]].
  split; first exists (- x), s, (s * y); last exists (- y), s^-1, (s^-1 * x).
    by rewrite [LHS](_ : p = s *: (q + y *: q') - x *: p'); [by_entries h; ring | rewrite -e addrK].
  rewrite [LHS](_ : q = s^-1 *: (p + x *: p') - y *: q'); first by by_entries h; ring.
  by rewrite e scalerA mulVf // scale1r addrK.
have [j0|j0] := eqVneq j 0; last first.
  exists (- i), (k / j), j; split=> //; rewrite {1}ep; by_entries h; by field.
have [j0'|j0'] := eqVneq j' 0; last first.
  exists (k' / j'), (- i'), j'^-1; split; first by rewrite invr_neq0.
  by rewrite [in RHS]eq; by_entries h; field.
exists (- i - k'), (- i' - k), (-1); split; first by rewrite oppr_eq0 oner_neq0.
have {}ep : p = i *: p' + k *: q' by rewrite ep j0 scale0r addr0.
have {}eq : q = i' *: q' + k' *: p' by rewrite eq j0' scale0r addr0.
by rewrite ep eq; by_entries h; ring.
Qed.

Lemma solve_for p p' q q' (i j k l : K) : i != 0 -> i *: p + j *: p' + k *: q + l *: q' = 0 -> spanned p p' q q'.
Proof.
move=> i0 e; exists (- j / i), (- k / i), (- l / i); apply: (scalerI i0); apply/eqP; rewrite -subr_eq0; apply/eqP.
by rewrite -[RHS]e; by_entries h; field.
Qed.
End Spans.

Lemma slope_of_multiple (K : fieldType) (x : K) (p : 'rV[K]_4) : weight (x *: p) *: place p - weight p *: place (x *: p) = 0.
Proof. by rewrite /weight /place; by_entries k; ring. Qed.

(* The polynomials of a curve in any field that holds them, with the first argument any member of it. *)
Lemma blossom_function (F E : fieldType) (f : {rmorphism {poly F} -> E}) n (u c : nat -> F) x : span n.+1 u ->
  f (curve n.+1 u c) + (x - f 'X) * f (velocity n.+1 u c)
    = blossom (fun i => f (u i)%:P) (fun i => f (c i)%:P) (at_ x :: nseq n (at_ (f 'X))).
Proof.
move=> sp; have lift y : f (blossom (polys u) (polys c) (y :: nseq n (at_ 'X)))
    = blossom (fun i => f (u i)%:P) (fun i => f (c i)%:P) ((f y.1, f y.2) :: nseq n (at_ (f 'X))).
  by rewrite blossom_morph /= ?map_nseq /= ?rmorph1 // size_nseq; exact: span_polys.
rewrite -[curve _ _ _]/(blossom (polys u) (polys c) (at_ 'X :: nseq n (at_ 'X))) /velocity !lift /= rmorph1 rmorph0.
rewrite -[X in X + _]mul1r -(blossoms_multilinear _ _ [::]) /= /comb /at_ /=.
by rewrite !mul1r mulr1 mulr0 addr0 addrC subrK.
Qed.

Section Functions.
Variable F : fieldType.
Notation K := {fraction {poly F}}.
Notation "x %:F" := (@FracField.tofrac [idomainType of {poly F}] x).
Implicit Types (L M s x : K) (n : nat).

Definition ftangent m n (p : 'rV[{poly F}]_m) x : 'rV[K]_m := pfun p + ((x - 'X%:F) / n%:R) *: pfun (pderiv p).
Definition frelated m n (p q : 'rV[{poly F}]_m) L M s := ftangent n p L = s *: ftangent n q M.

Lemma natrF0 n : n%:R != 0 :> F -> n%:R != 0 :> K.
Proof. by move=> n0; rewrite -tofrac1 -tofracMn tofrac_eq0 -polyC1 -polyCMn polyC_eq0. Qed.

(** FJ21.3.5 function: $p[t^{\langle n-1\rangle},x(t)]=p(t)+\frac{x(t)-t}np'(t)$ on every piece, for a rational function $x$: the blossom over the field of
    rational functions.
    Hypotheses: $n\ne0$ in the field; the knots carry the piece, so that the curve has a meaning. *)
Theorem FJ21_3_5_function m n (u : nat -> F) (c : nat -> 'rV[F]_m) x : n%:R != 0 :> F -> span n u ->
  ftangent n (pcurve n u c) x
    = pblossom (fun i => ((u i)%:P)%:F) (fun i => map_mx (fun a => (a%:P)%:F) (c i)) (at_ x :: nseq n.-1 (at_ 'X%:F)).
Proof.
move=> n0 sp; have := natrF0 n0; case: n n0 sp => [|n] n0 sp nK; first by rewrite eqxx in n0.
apply/rowP=> k; rewrite !mxE blossoms_derivative // tofracMn -[FracField.tofrac _ *+ n.+1]mulr_natr mulrA mulrAC divfK //.
rewrite (blossom_function [rmorphism of @FracField.tofrac [idomainType of {poly F}]]) //.
by apply: blossom_ext => i _; rewrite /step /coord !mxE.
Qed.

(** FJ21.T3.1 exact: rational $\Lambda,M,\sigma$ with $\sigma\ne0$ and $p[t^{\langle n-1\rangle},\Lambda]=\sigma q[t^{\langle n-1\rangle},M]$ exist iff $p$ is a combination of
    $p',q,q'$ and $q$ one of $q',p,p'$ with rational coefficients: this is what "generic developable" means.
    Hypotheses: $n\ne0$ in the field, so that $p+\frac{\Lambda-t}np'$ has a meaning; the blossom has one for every $n$, but is no such sum.
    Paper: leaves "generic" open. *)
Theorem FJ21_T3_1_exact m n (p q : 'rV[{poly F}]_m) : n%:R != 0 :> F ->
  (exists L M s, s != 0 /\ frelated n p q L M s) <->
  spanned (pfun p) (pfun (pderiv p)) (pfun q) (pfun (pderiv q)) /\ spanned (pfun q) (pfun (pderiv q)) (pfun p) (pfun (pderiv p)).
Proof.
move=> n0; rewrite -related_spanned /frelated /ftangent; split=> [[L [M [s [s0 e]]]]|[x [y [s [s0 e]]]]].
  by exists ((L - 'X%:F) / n%:R), ((M - 'X%:F) / n%:R), s.
by exists ('X%:F + x * n%:R), ('X%:F + y * n%:R), s; rewrite ![_ + _ * _]addrC !addrK !mulfK ?natrF0.
Qed.

(** FJ21.T3.1 developable: $p[t^{\langle n-1\rangle},\Lambda]=\sigma q[t^{\langle n-1\rangle},M]$ with any rational $\Lambda,M,\sigma$ makes the surface developable.
    Hypotheses: the weights do not vanish identically, so that $c$, $d$ have a meaning. True whatever stands for $\frac1n$ where $n=0$ in the field. *)
Theorem FJ21_T3_1_developable n (p q : 'rV[{poly F}]_4) L M s : weight p != 0 -> weight q != 0 ->
  frelated n p q L M s -> rational_developable p q.
Proof.
move=> w0 om0 /eqP; rewrite /frelated /ftangent -subr_eq0 => /eqP e; apply/(FJ21_2_1_determinant w0 om0)/eqP.
rewrite -tofrac_eq0 det_pfun; apply/eqP/det_dependent.
exists 1, ((L - 'X%:F) / n%:R), (- s), (- (s * ((M - 'X%:F) / n%:R))); split.
  by apply/eqP=> -[/eqP]; rewrite oner_eq0.
by rewrite -[RHS]e scale1r !scaleNr scalerDr scalerA opprD addrA.
Qed.

(** FJ21.T3.1 generic: the surface is developable iff rational $\Lambda,M,\sigma$ with $\sigma\ne0$ and $p[t^{\langle n-1\rangle},\Lambda]=\sigma q[t^{\langle n-1\rangle},M]$ exist.
    Hypotheses: $p',q,q'$ are independent over the rational functions, and $q',p,p'$; $n\ne0$ in the field and the weights do not vanish identically, so that
    $p+\frac{\Lambda-t}np'$ and $c$, $d$ have a meaning.
    Paper: "generic". *)
Theorem FJ21_T3_1_generic n (p q : 'rV[{poly F}]_4) : n%:R != 0 :> F -> weight p != 0 -> weight q != 0 ->
  free (pfun (pderiv p)) (pfun q) (pfun (pderiv q)) -> free (pfun (pderiv q)) (pfun p) (pfun (pderiv p)) ->
  rational_developable p q <-> exists L M s, s != 0 /\ frelated n p q L M s.
Proof.
move=> n0 w0 om0 fp fq; split=> [|[L [M [s [_ e]]]]]; last exact: FJ21_T3_1_developable e.
move/(FJ21_2_1_determinant w0 om0)/eqP; rewrite -tofrac_eq0 det_pfun => /eqP/det_dependent.
case=> i [j [k [l [nz]]]]; rewrite FJ21_T3_1_exact //; move: (pfun p) (pfun q) (pfun (pderiv p)) (pfun (pderiv q)) fp fq.
move=> P Q P' Q' fp fq e; have i0 : i != 0.
  apply: contraNneq nz => i0; rewrite i0 scale0r add0r in e.
  by have [-> -> ->] := fp _ _ _ e; rewrite i0.
have k0 : k != 0.
  apply: contraNneq nz => k0; have /fq[-> -> ->] : l *: Q' + i *: P + j *: P' = 0.
    by rewrite -[RHS]e k0 scale0r addr0 -addrA addrC.
  by rewrite k0.
split; first exact: solve_for i0 e.
by apply: (solve_for k0 (_ : k *: Q + l *: Q' + i *: P + j *: P' = 0)); rewrite -addrA addrC addrA.
Qed.

(** FJ21.T3.1 sigma: with $\sigma=0$ the relation says that $c$ is one point.
    Hypotheses: the weight does not vanish identically, so that $c$ has a meaning. True whatever stands for $\frac1n$ where $n=0$ in the field. *)
Theorem FJ21_T3_1_sigma n (p q : 'rV[{poly F}]_4) L M : weight p != 0 -> frelated n p q L M 0 -> pfderiv (affine p) = 0.
Proof.
move=> w0; rewrite /frelated /ftangent scale0r => /eqP; rewrite addr_eq0 -scaleNr => /eqP e.
by rewrite pfderiv_affine // e slope_of_multiple scaler0.
Qed.
End Functions.
