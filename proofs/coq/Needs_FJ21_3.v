(* FJ21, section 3: what happens without the hypotheses of the theorems, one counterexample each. *)
From Torse Require Import Prelude Blossom Curves Points Bernstein FJ07_3_blossoms Needs_blossoms Functions FJ21_2 FJ21_3_theorem FJ21_3_needs FJ21_4.

Section Dependence.
Variable K : fieldType.
Implicit Types (L M s : K).

Let entries (a b : 'rV[K]_4) : a = b -> [/\ a 0 0 = b 0 0, a 0 1 = b 0 1 & a 0 2%:R = b 0 2%:R].
Proof. by move->. Qed.

Let false_of_one : (1 = 0 :> K) -> False.
Proof. by move/eqP; rewrite oner_eq0. Qed.

(** FJ21.3.3 needs_lambda: for $\lambda_0=1$, $\lambda_1=-1$, $p_0-p_1=q_0$ and $q_1$ independent of $p_0,p_1$ there are no $\Lambda,M,\sigma$ at all. *)
Theorem FJ21_3_3_needs_lambda (p0 := row4 1 0 0 0 : 'rV[K]_4) (p1 := row4 0 1 0 0) (q0 := row4 1 (-1) 0 0) (q1 := row4 0 0 1 0) :
  1 *: p0 + (-1) *: p1 = 1 *: q0 + 0 *: q1 /\ forall L M s, (1 - L) *: p0 + L *: p1 <> s *: ((1 - M) *: q0 + M *: q1).
Proof.
split=> [|L M s]; first by apply/rowP=> -[[|[|[|[|//]]]] lt_k]; rewrite !mxE /=; ring.
move=> /entries; rewrite !mxE /= => -[h0 h1 _]; apply: false_of_one.
by apply: (by_multiple (z := 1) (congr2 (fun a b => a + b) h0 h1)); ring.
Qed.

(** FJ21.3.3 needs_mu: for $\mu_0=1$, $\mu_1=-1$, $p_0=q_0-q_1$ and $p_1$ independent of $q_0,q_1$ there are no $\Lambda,M,\sigma$ at all. *)
Theorem FJ21_3_3_needs_mu (p0 := row4 1 (-1) 0 0 : 'rV[K]_4) (p1 := row4 0 0 1 0) (q0 := row4 1 0 0 0) (q1 := row4 0 1 0 0) :
  1 *: p0 + 0 *: p1 = 1 *: q0 + (-1) *: q1 /\ forall L M s, (1 - L) *: p0 + L *: p1 <> s *: ((1 - M) *: q0 + M *: q1).
Proof.
split=> [|L M s]; first by apply/rowP=> -[[|[|[|[|//]]]] lt_k]; rewrite !mxE /=; ring.
move=> /entries; rewrite !mxE /= => -[h0 h1 h2].
have L0 : L = 0 by apply: (by_multiple (z := 1) h2); ring.
have s0 : s = 0 by rewrite L0 in h0 h1; apply: (by_multiple (z := -1) (congr2 (fun a b => a + b) h0 h1)); ring.
by apply: false_of_one; rewrite L0 s0 in h0; apply: (by_multiple (z := 1) h0); ring.
Qed.
End Dependence.

Section Rows.
Variable F : fieldType.
Notation K := {fraction {poly F}}.
Implicit Types (n : nat) (L M s : K) (p q : 'rV[{poly F}]_4).

Lemma at_infinity p q : p = row4 0 1 'X 0 -> q = row4 1 0 0 'X ->
  \det (rows4 p (pderiv p) q (pderiv q)) = 1 /\ \det (rows4 q (pderiv q) p (pderiv p)) = 1.
Proof.
move=> -> ->; have -> : pderiv (row4 0 1 'X 0) = row4 0 0 1 0 :> 'rV[{poly F}]_4.
  by apply/rowP=> -[[|[|[|[|//]]]] lt_k]; rewrite !mxE /= ?derivX -?polyC1 ?derivC ?linear0.
have -> : pderiv (row4 1 0 0 'X) = row4 0 0 0 1 :> 'rV[{poly F}]_4.
  by apply/rowP=> -[[|[|[|[|//]]]] lt_k]; rewrite !mxE /= ?derivX -?polyC1 ?derivC ?linear0.
by rewrite !det_row4; split; ring.
Qed.

(** FJ21.C3.1 tangents_needs_weight: for $p=(0,1,t,0)$, at infinity, and $q=(1,0,0,t)$ the determinant is $1$, and the left side has the factor $w=0$: no value in
    the place of $(d-c)\cdot(c'\times d')$ serves; nor for $p$ and $q$ in the other order. *)
Theorem FJ21_C3_1_tangents_needs_weight (p : 'rV[{poly F}]_4 := row4 0 1 'X 0) (q : 'rV[{poly F}]_4 := row4 1 0 0 'X) (x : K) :
  FracField.tofrac ((weight p * weight q) ^+ 2) * x <> - FracField.tofrac (\det (rows4 p (pderiv p) q (pderiv q))) /\
  FracField.tofrac ((weight q * weight p) ^+ 2) * x <> - FracField.tofrac (\det (rows4 q (pderiv q) p (pderiv p))).
Proof.
have [-> ->] := at_infinity (erefl p) (erefl q); have w0 : weight p = 0 by rewrite /weight mxE.
by rewrite w0 mulr0 mul0r expr0n tofrac0 mul0r tofrac1; split=> /esym/eqP; rewrite oppr_eq0 oner_eq0.
Qed.

(** FJ21.2.1 determinant_needs_weight: for the same rows there is no point $c$, or $d$ in the other order; with $x/0=0$ the condition (2.1) would hold, and the
    determinant is not 0. *)
Theorem FJ21_2_1_determinant_needs_weight (p : 'rV[{poly F}]_4 := row4 0 1 'X 0) (q : 'rV[{poly F}]_4 := row4 1 0 0 'X) :
  [/\ weight p = 0, \det (rows4 p (pderiv p) q (pderiv q)) <> 0 & \det (rows4 q (pderiv q) p (pderiv p)) <> 0].
Proof. by have [-> ->] := at_infinity (erefl p) (erefl q); rewrite /weight mxE; split=> //; apply/eqP; rewrite oner_eq0. Qed.

Let bent_p : 'rV[{poly F}]_4 := row4 (1 + 'X) 'X 0 'X^3.
Let bent_q : 'rV[{poly F}]_4 := row4 1 1 'X (- (3%:R * 'X^2)).

Lemma bent_rows : [/\ pderiv bent_p = row4 1 1 0 (3%:R * 'X^2), pderiv bent_q = row4 0 0 1 (- (6%:R * 'X)), weight bent_p != 0 & weight bent_q = 1].
Proof.
have D (g : {poly F}) k : (k%:R * g)^`() = k%:R * g^`() by rewrite derivM -(polyC_nat F) derivC mul0r add0r.
split; rewrite /weight ?mxE //.
- apply/rowP=> -[[|[|[|[|//]]]] lt_k]; rewrite !mxE /= ?derivD ?derivX -?polyC1 ?derivC ?add0r ?linear0 // derivXn /= mulr_natl //.
- apply/rowP=> -[[|[|[|[|//]]]] lt_k]; rewrite !mxE /= ?derivX -?polyC1 ?derivC //.
  by rewrite derivN D derivXn expr1 -(mulr_natl 'X 2) mulrA -natrM.
by rewrite /= addrC -size_poly_eq0 -polyC1 size_XaddC.
Qed.

(* p' = q - t q', while q', p, p' are independent. *)
Lemma bent_dependence : pderiv bent_p = bent_q - 'X *: pderiv bent_q.
Proof.
have [-> -> _ _] := bent_rows; apply/rowP=> -[[|[|[|[|//]]]] lt_k]; rewrite !mxE /=; move: ('X : {poly F}) => X; ring.
Qed.

Lemma bent_free : free (pfun (pderiv bent_q)) (pfun bent_p) (pfun (pderiv bent_p)).
Proof.
have [-> -> _ _] := bent_rows; move=> i j k /rowP e; have := (e 0, e 1, e 2%:R).
rewrite !mxE /= tofrac0 tofrac1 tofracD tofrac1 !mulr0 !mulr1 !addr0 !add0r; move: (FracField.tofrac 'X) => X -[[h0 h1] ->].
have j0 : j = 0 by apply: (by_multiple (z := 1) (congr2 (fun a b => a - b) h0 h1)); ring.
by split=> //; move: h1; rewrite j0 mul0r add0r.
Qed.

(** FJ21.T3.1 generic_needs_first: $p=(1+t,t,0,t^3)$ and $q=(1,1,t,-3t^2)$ have $p'=q-tq'$, so that the surface is developable, and $q',p,p'$ are independent, but there are
    no $\Lambda,M,\sigma$, in no degree $n$. *)
Theorem FJ21_T3_1_generic_needs_first (p : 'rV[{poly F}]_4 := row4 (1 + 'X) 'X 0 'X^3) (q : 'rV[{poly F}]_4 := row4 1 1 'X (- (3%:R * 'X^2))) :
  [/\ weight p != 0 /\ weight q != 0, free (pfun (pderiv q)) (pfun p) (pfun (pderiv p)), rational_developable p q
    & forall n L M s, ~ frelated n p q L M s].
Proof.
have [dp dq w0 w1] := bent_rows; have om0 : weight bent_q != 0 by rewrite w1 oner_eq0.
split=> //; first exact: bent_free.
  apply/FJ21_2_1_determinant => //; apply/det_dependent; exists 0, 1, (-1), 'X; rewrite !xpair_eqE oner_eq0 andbF; split=> //.
  by rewrite bent_dependence scale0r add0r scale1r scaleN1r addrAC subrK subrr.
move=> n L M s; rewrite /frelated /ftangent -[p]/bent_p -[q]/bent_q dp dq => /rowP e; have := (e 0, e 1); rewrite !mxE /=.
rewrite tofracD tofrac0 tofrac1 mulr0 addr0 => -[<- e1]; suff /eqP : 1 = 0 :> K by rewrite oner_eq0.
by apply: (by_multiple (z := -1) e1); ring.
Qed.

(** FJ21.T3.1 generic_needs_second: likewise for the same rows in the other order, where $p',q,q'$ are independent. *)
Theorem FJ21_T3_1_generic_needs_second (p : 'rV[{poly F}]_4 := row4 1 1 'X (- (3%:R * 'X^2))) (q : 'rV[{poly F}]_4 := row4 (1 + 'X) 'X 0 'X^3) :
  [/\ weight p != 0 /\ weight q != 0, free (pfun (pderiv p)) (pfun q) (pfun (pderiv q)), rational_developable p q
    & forall n L M s, ~ frelated n p q L M s].
Proof.
have [dq dp om0 w1] := bent_rows; have w0 : weight bent_q != 0 by rewrite w1 oner_eq0.
split=> //; first exact: bent_free.
  apply/FJ21_2_1_determinant => //; apply/det_dependent; exists (-1), 'X, 0, 1; rewrite !xpair_eqE oner_eq0 !andbF; split=> //.
  by rewrite -[q]/bent_p bent_dependence scale0r addr0 scale1r scaleN1r [- _ + _]addrC -opprB addNr.
move=> n L M s; rewrite /frelated /ftangent -[p]/bent_q -[q]/bent_p dp dq => /rowP e; have := (e 0, e 1); rewrite !mxE /=.
rewrite tofracD tofrac0 tofrac1 mulr0 addr0 => -[h0 h1].
have s0 : s = 0 by apply: (by_multiple (z := -1) (congr2 (fun a b => a - b) h0 h1)); ring.
by move/eqP: h0; rewrite s0 mul0r oner_eq0.
Qed.
End Rows.

Section Blossom.
Variable F : fieldType.

(** FJ21.3.5 needs_degree: in characteristic 2 the points $0,0,1$ of degree 2 give $p=t^2$ and $p'=0$: at $t=1$ no $y$ has $p(t)+yp'(t)=p[t,0]=0$.
    Hypotheses: $2=0$ in the field. *)
Theorem FJ21_3_5_needs_degree (c := fun i => const_mx (listed [:: 0; 0; 1] i) : 'rV[F]_1) (y : F) : 2%:R = 0 :> F ->
  ev (pcurve 2 (step01 F 2) c) 1 + y *: ev (pderiv (pcurve 2 (step01 F 2) c)) 1 <> pblossom (step01 F 2) c [:: at_ 0; at_ 1].
Proof.
move=> two; rewrite pderiv_curve; last exact: span_step01.
have z : pvelocity 2 (step01 F 2) c *+ 2 = 0.
  by apply/rowP=> k; rewrite mulmxnE -mulr_natl -(rmorph_nat [rmorphism of @polyC F]) two rmorph0 mul0r mxE.
rewrite z => /rowP/(_ 0); rewrite !mxE horner0 mulr0 addr0 horner_curve; last exact: span_step01.
rewrite /= /step /shift /step01 /coord !mxE /listed /= !subr0 !divr1 !mul1r !(mulr0, mul0r, add0r, addr0, subrr, mulr1, subr0, mul1r, sub0r, oppr0, divr1).
by move/eqP; rewrite oner_eq0.
Qed.
End Blossom.
