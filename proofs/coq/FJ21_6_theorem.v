(* FJ21, section 6: what determines the edge of regression, its tangents, and Theorem 6.1 in both directions.
   Definitions:
     related_rows n p q L M   p[t, ..., t, L] = q[t, ..., t, M] for all t, as rows of polynomials, L and M constant, sigma = 1
     edge p q L M             ((L - t) p + (t - M) q) / (L - M)
     patch n r x              r + (x - t)/(n+1) r' *)
From Torse Require Import Prelude Blossom Curves Points FJ21_4.

Section Pointwise.
Variables (F : fieldType) (m : nat).
Implicit Types (p q : 'rV[{poly F}]_m) (t L M s v al be lam mu nu : F) (n : nat).

(* p, W and W' are independent at t. *)
Definition free_at p q t := forall i j k : F, i *: ev p t + j *: ev (q - p) t + k *: ev (pderiv (q - p)) t = 0 -> [/\ i = 0, j = 0 & k = 0].

(** FJ21.4.3 unique: $\lambda,\mu,\nu$ of $p'=\lambda W+\mu W'+\nu p$ are determined.
    Hypotheses: $p$, $W$, $W'$ are independent at $t$.
    Paper: excludes cylinders; for a cone $W'$ may be a multiple of $W$ as well. *)
Theorem FJ21_4_3_unique p q t lam mu nu lam' mu' nu' : free_at p q t ->
  frame p q t lam mu nu -> frame p q t lam' mu' nu' -> [/\ lam = lam', mu = mu' & nu = nu'].
Proof.
move=> fr e e'; have /fr[/eqP n0 /eqP l0 /eqP m0] :
    (nu - nu') *: ev p t + (lam - lam') *: ev (q - p) t + (mu - mu') *: ev (pderiv (q - p)) t = 0.
  by transitivity (ev (pderiv p) t - ev (pderiv p) t); [rewrite {1}e e'; by_entries k; ring | rewrite subrr].
by move: n0 l0 m0; rewrite !subr_eq0 => /eqP -> /eqP -> /eqP ->.
Qed.

(** FJ21.6 unique: $v$, $\alpha$, $\beta$ of the singular point are determined: $(1-v)p'+vq'=\alpha(q-p)+\beta((1-v)p+vq)$ only for those of the
    paper.
    Hypotheses: $n\ne0$ in the field; $p$, $W$, $W'$ are independent at $t$, so that $E\ne0$.
    Paper: states none of them. *)
Theorem FJ21_6_unique n p q t L M s v al be (E := L - t + s * (t - M)) : n%:R != 0 :> F -> free_at p q t ->
  related_at n p q t L M s ->
  (1 - v) *: ev (pderiv p) t + v *: ev (pderiv q) t = al *: ev (q - p) t + be *: ((1 - v) *: ev p t + v *: ev q t) ->
  [/\ v = s * (t - M) / E, al = n%:R * s * (L - M) / E ^+ 2 & be = n%:R * (s - 1) / E].
Proof.
move=> n0 fr rel eq_v; have e0 : E != 0.
  apply/eqP=> e0; have eL : L = t + s * (M - t) by apply: (by_multiple (z := 1) e0); rewrite /E; ring.
  have [|/eqP s1 /eqP s0 _] := fr (1 - s) (- s) (- (s * ((M - t) / n%:R))).
    apply/rowP=> k; have /rowP/(_ k) := rel; rewrite !mxE !derivB !hornerD !hornerN eL.
    move: (p 0 k).[t] (q 0 k).[t] (p 0 k)^`().[t] (q 0 k)^`().[t] n%:R n0 => P Q P' Q' N n0 e.
    by apply: (by_multiple (z := 1) e); field.
  by move: s1; rewrite oppr_eq0 in s0; rewrite (eqP s0) subr0 oner_eq0.
have eE : L - s * M + t * (s - 1) = E by rewrite /E; ring.
have fr1 : frame p q t (al + be * v) (- v) be.
  apply/rowP=> k; have /rowP/(_ k) := eq_v; rewrite !mxE !derivB !hornerD !hornerN.
  move: (p 0 k).[t] (q 0 k).[t] (p 0 k)^`().[t] (q 0 k)^`().[t] => P Q P' Q' e.
  by apply: (by_multiple (z := 1) e); ring.
have fr2 : frame p q t (n%:R * s / E) (s * (M - t) / E) (n%:R * (s - 1) / E).
  by rewrite -eE; apply/FJ21_C4_1_frame; rewrite ?eE.
have [e1 e2 e3] := FJ21_4_3_unique fr fr1 fr2.
have ev : v = s * (t - M) / E by rewrite -[v]opprK e2; field.
by split=> //; rewrite -[al](addrK (be * v)) e1 e3 ev /E; field.
Qed.

(** FJ21.6 functions: $\Lambda=t+\frac{n(1-v)}{\alpha+(v-1)\beta}$, $M=t-\frac{nv}{\alpha+v\beta}$, $\sigma=\frac{\alpha+v\beta}{\alpha+(v-1)\beta}$: the singular point at
    $v$ gives the relation, and conversely.
    Hypotheses: both denominators do not vanish; $n\ne0$ in the field. *)
Theorem FJ21_6_functions n p q t v al be : n%:R != 0 :> F -> al + (v - 1) * be != 0 -> al + v * be != 0 ->
  (1 - v) *: ev (pderiv p) t + v *: ev (pderiv q) t = al *: ev (q - p) t + be *: ((1 - v) *: ev p t + v *: ev q t) <->
  related_at n p q t (t + n%:R * (1 - v) / (al + (v - 1) * be)) (t - n%:R * v / (al + v * be)) ((al + v * be) / (al + (v - 1) * be)).
Proof.
move=> n0 a0 b0; rewrite /related_at /tangent; split=> /rowP e; apply/rowP=> k; have := e k; rewrite !mxE !hornerD !hornerN;
  move: (p 0 k).[t] (q 0 k).[t] (p 0 k)^`().[t] (q 0 k)^`().[t] n%:R n0 => P Q P' Q' N n0 eq_P.
  by apply: (by_multiple (z := (al + (v - 1) * be)^-1) eq_P); field; rewrite n0 a0 b0.
by apply: (by_multiple (z := al + (v - 1) * be) eq_P); field; rewrite n0 a0 b0.
Qed.
End Pointwise.

Section Theorem6_1.
Variables (F : fieldType) (m : nat).
Implicit Types (p q r : 'rV[{poly F}]_m) (L M x : F) (n : nat).

Definition related_rows n p q L M :=
  p + (n%:R^-1 *: (L%:P - 'X)) *: pderiv p = q + (n%:R^-1 *: (M%:P - 'X)) *: pderiv q.
Definition edge p q L M : 'rV[{poly F}]_m := ((L - M)^-1)%:P *: ((L%:P - 'X) *: p + ('X - M%:P) *: q).
Definition patch n r x : 'rV[{poly F}]_m := r + (n.+1%:R^-1 *: (x%:P - 'X)) *: pderiv r.

(** FJ21.T6.1 relation: where the rows of polynomials agree, $p[t^{\langle n-1\rangle},\Lambda]=q[t^{\langle n-1\rangle},M]$ at every $t$. *)
Theorem FJ21_T6_1_relation n p q L M t : related_rows n p q L M -> related_at n p q t L M 1.
Proof.
move=> /rowP e; apply/rowP=> k; have := congr1 (fun y : {poly F} => y.[t]) (e k); rewrite !mxE !(hornerD, hornerN, hornerM, hornerZ, hornerC, hornerX) mul1r.
by rewrite ![n%:R^-1 * _]mulrC.
Qed.

(* One coordinate of Theorem 6.1. *)
Lemma patch_coordinate n (r : {poly F}) L M : n%:R != 0 :> F -> n.+1%:R != 0 :> F ->
  let p := r + (n.+1%:R^-1 *: (M%:P - 'X)) * r^`() in let q := r + (n.+1%:R^-1 *: (L%:P - 'X)) * r^`() in
  p + (n%:R^-1 *: (L%:P - 'X)) * p^`() = q + (n%:R^-1 *: (M%:P - 'X)) * q^`().
Proof.
move=> n0 n1 /=; rewrite !derivD !derivM !derivZ !derivB !derivC !derivX -!mul_polyC sub0r.
have eN : (n%:R^-1)%:P * n%:R%:P = 1 :> {poly F} by rewrite -polyCM mulVf.
have eN1 : (n.+1%:R^-1)%:P * (n%:R%:P + 1) = 1 :> {poly F} by rewrite -polyC1 -polyCD -natrS -polyCM mulVf.
move: ((n%:R^-1)%:P) ((n.+1%:R^-1)%:P) (n%:R%:P) L%:P M%:P (r^`()) (r^`()^`()) 'X eN eN1 => a b N l u r1 r2 X eN eN1.
apply/eqP; rewrite -subr_eq0; apply/eqP.
transitivity ((l - u) * r1 * (a * (1 - b) - b)); first by ring.
rewrite (_ : a * (1 - b) - b = a * (1 - b * (N + 1)) + (a * N - 1) * b); last by ring.
by rewrite eN eN1 !subrr mulr0 mul0r addr0 mulr0.
Qed.

Lemma edge_coordinate n (p q : {poly F}) L M : n%:R != 0 :> F -> n.+1%:R != 0 :> F -> L - M != 0 ->
  p + (n%:R^-1 *: (L%:P - 'X)) * p^`() = q + (n%:R^-1 *: (M%:P - 'X)) * q^`() ->
  let r := ((L - M)^-1)%:P * ((L%:P - 'X) * p + ('X - M%:P) * q) in
  [/\ r^`() = (n.+1%:R / (L - M))%:P * (q - p), p = r + (n.+1%:R^-1 *: (M%:P - 'X)) * r^`() & q = r + (n.+1%:R^-1 *: (L%:P - 'X)) * r^`()].
Proof.
move=> n0 n1 d0 e r; have er : r^`() = (n.+1%:R / (L - M))%:P * (q - p).
  rewrite /r !(derivM, derivD, derivN, derivC, derivX) polyCM [(n.+1%:R)%:P * _]mulrC mul0r add0r -mulrA; congr (_ * _).
  have eN : n%:R%:P * (n%:R^-1)%:P = 1 :> {poly F} by rewrite -polyCM mulfV.
  rewrite natrS polyCD polyC1; move: e eN; rewrite -!mul_polyC.
  move: ((n%:R^-1)%:P) (n%:R%:P) (L%:P) (M%:P) (p^`()) (q^`()) 'X => a N l u p' q' X e aN.
  apply: (by_multiple (z := N) e); have -> : N * (p + a * (l - X) * p' - (q + a * (u - X) * q')) = N * (p - q) + (N * a) * ((l - X) * p' - (u - X) * q') by ring.
  by rewrite aN; ring.
have eD : ((L - M)^-1)%:P * (L%:P - M%:P) = 1 :> {poly F} by rewrite -polyCB -polyCM mulVf.
have eN : (n.+1%:R^-1)%:P * (n.+1%:R / (L - M))%:P = ((L - M)^-1)%:P :> {poly F} by rewrite -polyCM mulrA mulVf // mul1r.
split=> //; rewrite er -mul_polyC mulrA [_ * _ * (n.+1%:R / _)%:P]mulrAC eN /r; move: eD;
  move: (((L - M)^-1)%:P) (L%:P) (M%:P) 'X => d l u X eD.
  by rewrite -[LHS]mul1r -eD; ring.
by rewrite -[LHS]mul1r -eD; ring.
Qed.

(** FJ21.T6.1 equivalence: for constant $\Lambda\ne M$ and $\sigma=1$ the relation $p[t^{\langle n-1\rangle},\Lambda]=q[t^{\langle n-1\rangle},M]$ holds as polynomials iff
    $p=r+\frac{M-t}{n+1}r'$, $q=r+\frac{\Lambda-t}{n+1}r'$ for some $r$.
    Hypotheses: $\Lambda\ne M$; $n$ and $n+1$ are not 0 in the field.
    Paper: does not exclude $\Lambda=M$. *)
Theorem FJ21_T6_1_equivalence n p q L M : n%:R != 0 :> F -> n.+1%:R != 0 :> F -> L != M ->
  related_rows n p q L M <-> exists r, p = patch n r M /\ q = patch n r L.
Proof.
move=> n0 n1; rewrite -subr_eq0 => d0; split=> [/rowP e|[r [-> ->]]]; last first.
  apply/rowP=> k; have := patch_coordinate (r 0 k) L M n0 n1; rewrite /patch !mxE; exact.
exists (edge p q L M); split; apply/rowP=> k; have := e k; rewrite !mxE => /(edge_coordinate n0 n1 d0) [_ ep eq]; [exact: ep | exact: eq].
Qed.

(** FJ21.T6.1 edge: then $r=\frac{(\Lambda-t)p+(t-M)q}{\Lambda-M}$, and $q-p=\frac{\Lambda-M}{n+1}r'$: the rulings are the tangents of $r$.
    Hypotheses: $\Lambda\ne M$; $n+1\ne0$ in the field, so that $\frac1{n+1}$ has a meaning: whatever stands for it, $r$ is as said. *)
Theorem FJ21_T6_1_edge n r L M : n.+1%:R != 0 :> F -> L != M ->
  r = edge (patch n r M) (patch n r L) L M /\ patch n r L - patch n r M = ((L - M) / n.+1%:R)%:P *: pderiv r.
Proof.
move=> n1; rewrite -subr_eq0 => d0; have eD : ((L - M)^-1)%:P * (L%:P - M%:P) = 1 :> {poly F} by rewrite -polyCB -polyCM mulVf.
split; apply/rowP=> k; rewrite !mxE.
  move: eD; rewrite -!mul_polyC; move: ((L - M)^-1)%:P (L%:P) (M%:P) 'X (n.+1%:R^-1)%:P (r 0 k) (r 0 k)^`() => d l u X b R R' eD.
  by rewrite -[LHS]mul1r -eD; ring.
rewrite -!mul_polyC polyCM polyCB; move: (L%:P) (M%:P) 'X (n.+1%:R^-1)%:P (r 0 k) (r 0 k)^`() => l u X b R R'; ring.
Qed.

(** FJ21.T6.1 degree: if $r=at^{n+1}+bt^n+\dots$ then $r+\frac{x-t}{n+1}r'$ has degree at most $n$, with the leading coefficient $\frac b{n+1}+xa$:
    $p$ has degree $n$ iff $b+(n+1)Ma\ne0$, $q$ iff $b+(n+1)\Lambda a\ne0$, and $q-p$ iff $a\ne0$.
    Hypotheses: $r$ has degree at most $n+1$; $n+1\ne0$ in the field.
    Paper: takes the degrees for granted. *)
Theorem FJ21_T6_1_degree n r x k : n.+1%:R != 0 :> F -> (size (r 0%R k) <= n.+2)%N ->
  (size (patch n r x 0%R k) <= n.+1)%N /\ (patch n r x 0 k)`_n = (r 0 k)`_n / n.+1%:R + x * (r 0 k)`_n.+1.
Proof.
move=> n1; rewrite !mxE; move: (r 0 k) => g sg.
have co i : (g + (n.+1%:R^-1 *: (x%:P - 'X)) * g^`())`_i = g`_i + n.+1%:R^-1 * (x * (g`_i.+1 *+ i.+1) - g`_i *+ i).
  rewrite coefD -scalerAl coefZ mulrBl coefB coefCM coefXM coef_deriv; congr (_ + _ * (_ - _)).
  by case: i => [|i] /=; rewrite ?mulr0n // coef_deriv.
split; last first.
  rewrite co -(mulr_natr g`_n.+1) -(mulr_natr g`_n); move: n1; rewrite natrS; move: (n%:R) g`_n g`_n.+1 => N a b n1; by field.
apply/leq_sizeP=> j; rewrite leq_eqVlt => /orP[/eqP <-|lt_j]; rewrite co.
  rewrite [g`_n.+2](leq_sizeP _ _ sg) // mul0rn mulr0 sub0r -(mulr_natr g`_n.+1) mulrN mulrCA mulVf // mulr1 subrr //.
rewrite (leq_sizeP _ _ sg j lt_j) (leq_sizeP _ _ sg j.+1 (leqW lt_j)) !mul0rn mulr0 subr0 mulr0 addr0 //.
Qed.
End Theorem6_1.
