(* FJ21, Theorem 6.1: the curves r and f r, one curve in space, have one tangent surface, and no others have.
   Definitions:
     in_ruling x p q         x is a combination of p and q with rational functions as coefficients: it lies on the ruling through them
     same_rulings p q a b    the rulings through p and q are those through a and b *)
From Torse Require Import Prelude Blossom Curves Points Functions FJ21_3_theorem FJ21_3_needs FJ21_4 FJ21_4_gauge FJ21_6_theorem.

Section Rulings.
Variables (K : fieldType) (m : nat).
Implicit Types (x y p q a b c d : 'rV[K]_m) (i j k : K).

Definition in_ruling x p q := exists i j, x = i *: p + j *: q.
Definition same_rulings p q a b := [/\ in_ruling a p q, in_ruling b p q, in_ruling p a b & in_ruling q a b].

Lemma in_ruling_trans x a b c d : in_ruling x a b -> in_ruling a c d -> in_ruling b c d -> in_ruling x c d.
Proof.
move=> [i [j ->]] [i1 [j1 ->]] [i2 [j2 ->]]; exists (i * i1 + j * i2), (i * j1 + j * j2).
by by_entries h; ring.
Qed.

Lemma same_trans a b c d p q : same_rulings a b c d -> same_rulings c d p q -> same_rulings a b p q.
Proof. by move=> [h1 h2 h3 h4] [g1 g2 g3 g4]; split; [move: g1|move: g2|move: h3|move: h4] => /in_ruling_trans; apply. Qed.

Lemma same_sym a b c d : same_rulings a b c d -> same_rulings c d a b.
Proof. by case. Qed.

(* r and r' where r1 = f r: the tangents are the same. *)
Lemma tangents_factor r r' i j : i != 0 -> same_rulings r r' (i *: r) (j *: r + i *: r').
Proof.
move=> i0; split; first by exists i, 0; rewrite scale0r addr0.
- by exists j, i.
- by exists i^-1, 0; rewrite scale0r addr0 scalerA mulVf // scale1r.
by exists (- (j / i / i)), i^-1; by_entries h; field.
Qed.

(* Conversely, a r + b r' has its derivative in the ruling for b = 0 only. *)
Lemma tangents_proportional r r' r'' i j i' j' : free r r' r'' ->
  in_ruling (i' *: r + (i + j') *: r' + j *: r'') r r' -> j = 0.
Proof.
move=> fr [k [l e]]; have /fr[_ _ ->] // : (i' - k) *: r + (i + j' - l) *: r' + j *: r'' = 0.
transitivity (i' *: r + (i + j') *: r' + j *: r'' - (k *: r + l *: r')); last by rewrite e subrr.
by by_entries h; ring.
Qed.
End Rulings.

Section Factor.
Variables (F : fieldType) (m : nat).
Notation K := {fraction {poly F}}.
Notation "x %:F" := (@FracField.tofrac [idomainType of {poly F}] x).
Implicit Types (r : 'rV[{poly F}]_m) (L M x : F) (f : K) (n N : nat).

Lemma pfun_patch n r x : pfun (patch n r x) = pfun r + (n.+1%:R^-1 *: (x%:P - 'X))%:F *: pfun (pderiv r).
Proof. by rewrite /patch pfunD pfunZ. Qed.

(** FJ21.T6.1 rulings: the rulings through $p=r+\frac{M-t}{n+1}r'$ and $q=r+\frac{\Lambda-t}{n+1}r'$ are those through $r$ and $r'$, whatever $n$ and $\Lambda\ne M$.
    Hypotheses: $\Lambda\ne M$; $n+1\ne0$ in the field, so that $\frac1{n+1}$ has a meaning. *)
Theorem FJ21_T6_1_rulings n r L M : n.+1%:R != 0 :> F -> L != M ->
  same_rulings (pfun r) (pfun (pderiv r)) (pfun (patch n r M)) (pfun (patch n r L)).
Proof.
move=> n1 d; have [er ed] := FJ21_T6_1_edge r n1 d; split.
- by exists 1, (n.+1%:R^-1 *: (M%:P - 'X))%:F; rewrite scale1r pfun_patch.
- by exists 1, (n.+1%:R^-1 *: (L%:P - 'X))%:F; rewrite scale1r pfun_patch.
- exists (((L - M)^-1)%:P * (L%:P - 'X))%:F, (((L - M)^-1)%:P * ('X - M%:P))%:F.
  by rewrite {1}er /edge -!pfunZ -pfunD -!scalerA -scalerDr.
have c0 : ((L - M) / n.+1%:R)%:P != 0 :> {poly F} by rewrite polyC_eq0 mulf_neq0 ?invr_eq0 // subr_eq0.
exists (- (((L - M) / n.+1%:R)%:P%:F)^-1), (((L - M) / n.+1%:R)%:P%:F)^-1.
rewrite scaleNr addrC -scalerBr -pfunB ed pfunZ scalerA mulVf ?scale1r //.
by rewrite tofrac_eq0.
Qed.

(** FJ21.T6.1 factor: the tangent surfaces of $r$, in degree $n$ with $\Lambda,M$, and of $r_1$, in degree $n_1$ with $\Lambda_1,M_1$, have the same rulings iff $r_1=fr$ for a
    rational $f\ne0$: Theorem 6.1 gives every such surface infinitely often, once for each factor of $r$.
    Hypotheses: $r,r',r''$ are independent over the rational functions, for the "only if"; $\Lambda\ne M$, $\Lambda_1\ne M_1$; $n+1$ and $n_1+1$ are not 0 in the field,
    so that $\frac1{n+1}$ has a meaning.
    Paper: counts curves $r$ of degree $n+1$; the surface determines $r$ up to a factor, and $r$ and $n$ determine $p$ and $q$. *)
Theorem FJ21_T6_1_factor n N r r1 L M L1 M1 : n.+1%:R != 0 :> F -> N.+1%:R != 0 :> F -> L != M -> L1 != M1 ->
  free (pfun r) (pfun (pderiv r)) (pfun (pderiv (pderiv r))) ->
  same_rulings (pfun (patch n r M)) (pfun (patch n r L)) (pfun (patch N r1 M1)) (pfun (patch N r1 L1)) <->
  exists f, f != 0 /\ pfun r1 = f *: pfun r.
Proof.
move=> n1 N1 d d1 fr; have s := FJ21_T6_1_rulings r n1 d; have s1 := FJ21_T6_1_rulings r1 N1 d1.
split=> [e|[f [f0 e]]]; last first.
  apply: (same_trans (same_sym s)); apply: same_trans s1; rewrite -(pfderiv_fun r1) e pfderivZ pfderiv_fun.
  exact: tangents_factor.
have [[i [j er]] /= e2 e3 _] : same_rulings (pfun r) (pfun (pderiv r)) (pfun r1) (pfun (pderiv r1)).
  by apply: same_trans s _; apply: same_trans e (same_sym s1).
have j0 : j = 0.
  apply: (tangents_proportional (i := i) (i' := fderiv i) (j' := fderiv j) fr); move: e2; rewrite -(pfderiv_fun r1) er.
  rewrite (_ : pfderiv _ = pfderiv (i *: pfun r) + pfderiv (j *: pfun (pderiv r))); last by apply/rowP=> k; rewrite !mxE fderivD.
  by rewrite !pfderivZ !pfderiv_fun scalerDl !addrA.
exists i; split; last by rewrite er j0 scale0r addr0.
apply/eqP=> i0; move: e3; rewrite er i0 j0 !scale0r addr0 -(pfderiv_fun r1) er i0 j0 !scale0r addr0 => -[k [l]].
have -> : pfderiv (0 : 'rV[K]_m) = 0 by apply/rowP=> h; rewrite !mxE -tofrac0 fderiv_poly linear0 tofrac0.
rewrite !scaler0 addr0 => r0; have [|/eqP] := fr 1 0 0; last by rewrite oner_eq0.
by rewrite r0 !scale0r scaler0 !addr0.
Qed.
End Factor.
