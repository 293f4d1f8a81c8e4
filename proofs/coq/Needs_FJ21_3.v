(* FJ21, section 3: what happens without the hypotheses of the theorems, one counterexample each. *)
From mathcomp Require Import all_ssreflect all_algebra ring zify.
From Torse Require Import Blossom Curves Points FJ07_3_blossoms Needs_blossoms Functions FJ21_2 FJ21_3_theorem FJ21_3_needs FJ21_4.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Import GRing.Theory.
Local Open Scope ring_scope.

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

Let at_infinity p q : p = row4 0 1 'X 0 -> q = row4 1 0 0 'X -> \det (rows4 p (pderiv p) q (pderiv q)) = 1.
Proof.
move=> -> ->; rewrite det_rows4 /weight /place; coordinates; rewrite /= ?derivX ?linear0 ?derivC.
by rewrite -?polyC1 ?derivC; ring.
Qed.

(** FJ21.C3.1 tangents_needs_weight: for $p=(0,1,t,0)$, at infinity, and $q=(1,0,0,t)$ the determinant is $1$, and the left side has the factor $w=0$: no value in
    the place of $(d-c)\cdot(c'\times d')$ serves. *)
Theorem FJ21_C3_1_tangents_needs_weight (p : 'rV[{poly F}]_4 := row4 0 1 'X 0) (q : 'rV[{poly F}]_4 := row4 1 0 0 'X) (x : K) :
  FracField.tofrac ((weight p * weight q) ^+ 2) * x <> - FracField.tofrac (\det (rows4 p (pderiv p) q (pderiv q))).
Proof.
rewrite at_infinity // /weight !mxE /= mul0r expr0n tofrac0 mul0r tofrac1 => /esym/eqP.
by rewrite oppr_eq0 oner_eq0.
Qed.

(** FJ21.2.1 determinant_needs_weight: for the same rows there is no point $c$; with $x/0=0$ the condition (2.1) would hold, and the determinant is not 0. *)
Theorem FJ21_2_1_determinant_needs_weight (p : 'rV[{poly F}]_4 := row4 0 1 'X 0) (q : 'rV[{poly F}]_4 := row4 1 0 0 'X) :
  weight p = 0 /\ \det (rows4 p (pderiv p) q (pderiv q)) <> 0.
Proof. by rewrite at_infinity // /weight mxE; split=> //; apply/eqP; rewrite oner_eq0. Qed.

(** FJ21.T3.1 exact_needs_degree: where $n=0$ in the field $p+\frac{\Lambda-t}np'$ has no meaning; with $x/0=0$ the relation would say $p=\sigma q$, which $p=(1,t,0,0)$,
    $q=(1,0,t,0)$ do not obey, though $p=q-tq'+tp'$ and $q=p-tp'+tq'$. *)
Theorem FJ21_T3_1_exact_needs_degree n (p : 'rV[{poly F}]_4 := row4 1 'X 0 0) (q : 'rV[{poly F}]_4 := row4 1 0 'X 0) : n%:R = 0 :> K ->
  p = 'X *: pderiv p + 1 *: q + (- 'X) *: pderiv q /\ forall L M s, ~ frelated n p q L M s.
Proof.
move=> n0; split=> [|L M s]; last first.
  rewrite /frelated /ftangent n0 invr0 !mulr0 !scale0r !addr0 => /rowP h; have := h 1; rewrite !mxE /= tofrac0 mulr0 => /eqP.
  by rewrite tofrac_eq0 polyX_eq0.
apply/rowP=> -[[|[|[|[|//]]]] lt_k]; rewrite !mxE /= ?derivX -?polyC1 ?derivC ?linear0 ?polyC1; ring.
Qed.
End Rows.

Section Blossom.
Variable F : fieldType.

(** FJ21.3.5 needs_degree: in characteristic 2 the points $0,0,1$ of degree 2 give $p=t^2$ and $p'=0$: at $t=1$ no $y$ has $p(t)+yp'(t)=p[t,0]=0$.
    Hypotheses: $2=0$ in the field. *)
Theorem FJ21_3_5_needs_degree (c := fun i => const_mx (listed [:: 0; 0; 1] i) : 'rV[F]_1) (y : F) : 2%:R = 0 :> F ->
  ev (pcurve 2 (bez F 2) c) 1 + y *: ev (pderiv (pcurve 2 (bez F 2) c)) 1 <> pblossom (bez F 2) c [:: at_ 0; at_ 1].
Proof.
move=> two; rewrite pderiv_curve; last exact: bez_span.
have z : pvelocity 2 (bez F 2) c *+ 2 = 0.
  by apply/rowP=> k; rewrite mulmxnE -mulr_natl -(rmorph_nat [rmorphism of @polyC F]) two rmorph0 mul0r mxE.
rewrite z => /rowP/(_ 0); rewrite !mxE horner0 mulr0 addr0 horner_curve; last exact: bez_span.
rewrite /= /step /shift /bez /coord !mxE /listed /= !subr0 !divr1 !mul1r !(mulr0, mul0r, add0r, addr0, subrr, mulr1, subr0, mul1r, sub0r, oppr0, divr1).
by move/eqP; rewrite oner_eq0.
Qed.
End Blossom.
