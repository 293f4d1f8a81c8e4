(* FJ21, section 6: an example for each condition that Theorem 6.1 passes over in silence, for n = 2, Lam = 3 and M = 2.
   Definitions:
     side x r     r + (x - t)/3 r', so that p is side 2 r and q is side 3 r *)
From Torse Require Import Prelude Blossom Curves Points Bernstein Functions FJ21_2 FJ21_3_needs FJ21_4 FJ21_6_theorem.

Section Witnesses.
Variable F : fieldType.
Implicit Types (r : 'rV[{poly F}]_4) (x t : F).

Definition side x r := patch 2 r x.

Let a3 : {poly F} := (3%:R^-1)%:P.

Lemma sideE x r k : side x r 0 k = r 0 k + a3 * (x%:P - 'X) * (r 0 k)^`().
Proof. by rewrite /side !mxE -mul_polyC. Qed.

Lemma third : 3%:R != 0 :> F -> a3 * 3%:R = 1.
Proof. by move=> n3; rewrite /a3 -(rmorph_nat [rmorphism of @polyC F]) -polyCM mulVf. Qed.

Let slope k (g : {poly F}) : (k%:R * g)^`() = k%:R * g^`().
Proof. by rewrite derivM -(polyC_nat F) derivC mul0r add0r. Qed.

Let slopes : [/\ (1 : {poly F})^`() = 0, ('X^2)^`() = 2%:R * 'X :> {poly F} & ('X^3)^`() = 3%:R * 'X^2 :> {poly F}].
Proof. by rewrite !derivXn expr1 !mulr_natl derivC. Qed.

(** FJ21.T6.1.witnesses relation: each of these $p$, $q$ obeys $p[t,\Lambda]=q[t,M]$ with $\Lambda=3$, $M=2$, $\sigma=1$.
    Hypotheses: $2$ and $3$ are not 0 in the field, so that $\frac1n$ and $\frac1{n+1}$ have a meaning. *)
Theorem FJ21_T6_1_witnesses_relation r t : 2%:R != 0 :> F -> 3%:R != 0 :> F ->
  related_at 2 (side 2%:R r) (side 3%:R r) t 3%:R 2%:R 1.
Proof.
move=> n2 n3; apply/FJ21_T6_1_relation/FJ21_T6_1_equivalence => //; last by exists r.
by rewrite -subr_eq0 (_ : 3%:R - 2%:R = 1) ?oner_neq0 //; ring.
Qed.

(** FJ21.T6.1.witnesses point: (a) for $r=(t+1)^3A$, one point, $p=3(t+1)^2A$ and $q=4(t+1)^2A$ are that point.
    Hypotheses: $3\ne0$ in the field, so that $\frac13$ has a meaning. *)
Theorem FJ21_T6_1_witnesses_point (A : 'rV[F]_4) (r := ('X + 1) ^+ 3 *: map_mx polyC A) : 3%:R != 0 :> F ->
  side 2%:R r = (3%:R * ('X + 1) ^+ 2) *: map_mx polyC A /\ side 3%:R r = (4%:R * ('X + 1) ^+ 2) *: map_mx polyC A.
Proof.
move/third => e3; have D : (('X + 1) ^+ 3)^`() = 3%:R * ('X + 1) ^+ 2 :> {poly F}.
  by rewrite deriv_exp derivD derivX derivC addr0 mul1r mulr_natl.
by split; apply/rowP=> k; rewrite sideE !mxE derivM derivC mulr0 addr0 D polyC_nat; move: a3 e3 'X (A 0 k)%:P => a e3 X b;
  [apply: (by_multiple (z := b * (X + 1) ^+ 2 * (2%:R - X)) e3) | apply: (by_multiple (z := b * (X + 1) ^+ 2 * (3%:R - X)) e3)]; ring.
Qed.

(** FJ21.T6.1.witnesses line: (b) for $r=(1+t^2)(1,t,2t,0)$ both curves lie on the line $y=2x$, $z=0$: all rulings are that line. *)
Theorem FJ21_T6_1_witnesses_line x (r := (1 + 'X^2) *: row4 1 'X (2%:R * 'X) 0 : 'rV[{poly F}]_4) :
  side x r 0 2%:R = 2%:R * side x r 0 1 /\ side x r 0 3%:R = 0.
Proof.
split; rewrite !sideE !mxE /=; last by rewrite mulr0 linear0 mulr0 addr0.
by rewrite mulrCA slope; move: a3 (_^`()) => a d; ring.
Qed.

(** FJ21.T6.1.witnesses plane: (c) for $r=(1,t,t^2+t^3,0)$ both curves, and the surface, lie in the plane $z=0$. *)
Theorem FJ21_T6_1_witnesses_plane x (r := row4 1 'X ('X^2 + 'X^3) 0 : 'rV[{poly F}]_4) : side x r 0 3%:R = 0.
Proof. by rewrite sideE !mxE /= linear0 mulr0 addr0. Qed.

(** FJ21.T6.1.witnesses infinity: (d) where the weight of $r$ is $(t-2)^3$ the weight of $p$ vanishes identically: $p$ lies at infinity.
    Hypotheses: $3\ne0$ in the field, so that $\frac13$ has a meaning. *)
Theorem FJ21_T6_1_witnesses_infinity (r := row4 (('X - 2%:R) ^+ 3) 'X ('X^2) ('X^3) : 'rV[{poly F}]_4) : 3%:R != 0 :> F ->
  weight (side 2%:R r) = 0.
Proof.
move/third => e3; have d2 : ('X - 2%:R)^`() = 1 :> {poly F} by rewrite derivB derivX -(polyC_nat F) derivC subr0.
rewrite /weight sideE mxE /= deriv_exp d2 mul1r -[_ *+ 3]mulr_natl (polyC_nat F) -[2%:R - 'X]opprB /=.
by move: ('X - 2%:R) => X; apply: (by_multiple (z := - X ^+ 3) e3); move: a3 => a; ring.
Qed.

(** FJ21.T6.1.witnesses degree: (e) for $r=(1,t,t^2,1+2t+3t^2)$, of degree 2 and not 3, $q-p=\frac13r'$ has degree 1 and not 2. *)
Theorem FJ21_T6_1_witnesses_degree (r := row4 1 'X ('X^2) (1 + 2%:R * 'X + 3%:R * 'X^2) : 'rV[{poly F}]_4) :
  side 3%:R r - side 2%:R r = a3 *: row4 0 1 (2%:R * 'X) (2%:R + 6%:R * 'X).
Proof.
have [s1 s2 s3] := slopes; apply/rowP=> -[[|[|[|[|//]]]] lt_k]; rewrite [LHS]mxE [X in _ + X]mxE !sideE !mxE /= ?polyC_nat ?derivD ?slope ?s1 ?s2 ?derivX;
  move: a3 'X => a X; ring.
Qed.

(** FJ21.T6.1.witnesses first: (f) for $r=t^3a+t^2b+\dots$ with $b=-6a=-(n+1)Ma$ the curve $p$ has degree 1 and not 2.
    Hypotheses: $3\ne0$ in the field, so that $\frac13$ has a meaning. *)
Theorem FJ21_T6_1_witnesses_first (r := row4 1 'X (1 + 'X - 6%:R * 'X^2 + 'X^3) (2%:R * 'X^3 - 12%:R * 'X^2) : 'rV[{poly F}]_4) : 3%:R != 0 :> F ->
  side 2%:R r = a3 *: row4 3%:R (2%:R + 2%:R * 'X) (5%:R - 22%:R * 'X) (- (48%:R * 'X)).
Proof.
move/third => e3; have [s1 s2 s3] := slopes.
apply/rowP=> -[[|[|[|[|//]]]] lt_k]; rewrite sideE !mxE /= ?polyC_nat ?derivD ?derivN ?derivD ?derivN ?slope ?s1 ?s2 ?s3 ?derivX; move: a3 e3 'X => a e3 X.
- by rewrite mulr0 addr0 e3.
- by apply: (by_multiple (z := - X) e3); ring.
- by apply: (by_multiple (z := - (1 + X - 6%:R * X ^+ 2 + X ^+ 3)) e3); ring.
by apply: (by_multiple (z := - (2%:R * X ^+ 3 - 12%:R * X ^+ 2)) e3); ring.
Qed.
End Witnesses.
