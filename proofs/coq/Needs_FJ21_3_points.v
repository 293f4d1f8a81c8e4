(* FJ21, (3.2), Proposition and Corollary 3.1, Theorem 3.1 in a field of characteristic 2: what happens without the hypotheses, one counterexample each.
   Definitions:
     twisted a b      the control points a, a, b of degree 2, whose last points are a and a + t(b-a), and whose curve is a + t^2(b-a) *)
From Torse Require Import Prelude Blossom Curves Points FJ07_3_blossoms Functions FJ21_2 FJ21_3 FJ21_3_theorem FJ21_3_needs FJ21_3_splines.

Section Needs.
Variable F : fieldType.
Notation K := {fraction {poly F}}.
Implicit Types (n : nat) (L M s : K) (a b : 'rV[F]_4) (p q : 'rV[{poly F}]_4).

Definition twisted a b := nth 0 [:: a; a; b].

(** FJ21.3.2 derivative_needs_distinct: for $a=b$ the points $c_0^{n-1}$, $c_1^{n-1}$ are one, and $c'\ne0$ is no multiple of their difference. *)
Theorem FJ21_3_2_derivative_needs_distinct n u (c : nat -> 'rV[F]_4) (a : F) (p := pcurve n u c) (p0 := last_point n u c a) (x : K) :
  pfderiv (affine p) != 0 -> pfderiv (affine p) <> x *: (affine p0 - affine p0).
Proof. by move=> nz e; case/eqP: nz; rewrite e subrr scaler0. Qed.

Lemma saddle_curves (c := nth 0 [:: row4 1 0 0 0; row4 1 1 0 0]) (d := nth 0 [:: row4 1 0 0 1; row4 1 0 1 1] : nat -> 'rV[F]_4) :
  pcurve 1 (step01 F 1) c = row4 1 'X 0 0 /\ pcurve 1 (step01 F 1) d = row4 1 0 'X 1.
Proof.
have u1 : step01 F 1 1 - step01 F 1 0 = 1 by rewrite /step01 /= subr0.
split; rewrite pcurve1 // /step01 /= polyC1 polyC0 subr0; apply/rowP=> -[[|[|[|[|//]]]] lt_k]; rewrite !mxE /= ?polyC1 ?polyC0; ring.
Qed.

Lemma saddle_bent p q : p = row4 1 'X 0 0 -> q = row4 1 0 'X 1 -> ~ rational_developable p q.
Proof.
move=> -> -> /FJ21_2_1_determinant; rewrite /weight !mxE oner_eq0 => /(_ isT isT).
have dp : pderiv (row4 1 'X 0 0) = row4 0 1 0 0 :> 'rV[{poly F}]_4.
  by apply/rowP=> -[[|[|[|[|//]]]] lt_k]; rewrite !mxE /= ?derivX -?polyC1 ?derivC ?linear0.
have dq : pderiv (row4 1 0 'X 1) = row4 0 0 1 0 :> 'rV[{poly F}]_4.
  by apply/rowP=> -[[|[|[|[|//]]]] lt_k]; rewrite !mxE /= ?derivX -?polyC1 ?derivC ?linear0.
rewrite dp dq det_row4 => /eqP; rewrite !(mulr0, mul0r, mulr1, mul1r, addr0, add0r, subr0, sub0r, oppr0).
by rewrite ?oppr_eq0 oner_eq0.
Qed.

(** FJ21.P3.1 coplanar_needs_distinct: for $a=b$ the four points, $c_0,c_0,d_0,d_0$, are always coplanar; the surface between $c=(t,0,0)$ and $d=(0,t,1)$, $n=1$, is not
    developable. *)
Theorem FJ21_P3_1_coplanar_needs_distinct x (c := nth 0 [:: row4 1 0 0 0; row4 1 1 0 0]) (d := nth 0 [:: row4 1 0 0 1; row4 1 0 1 1] : nat -> 'rV[F]_4)
    (p0 := last_point 1 (step01 F 1) c x) (q0 := last_point 1 (step01 F 1) d x) :
  [/\ weight p0 = 1, weight q0 = 1, coplanar (affine p0) (affine p0) (affine q0) (affine q0)
    & ~ rational_developable (pcurve 1 (step01 F 1) c) (pcurve 1 (step01 F 1) d)].
Proof.
have w (e : nat -> 'rV[F]_4) : e 0%N 0 0 = 1 -> e 1%N 0 0 = 1 -> weight (last_point 1 (step01 F 1) e x) = 1.
  move=> e0 e1; rewrite /weight mxE /= /step /polys /step01 /coord /= e0 e1 polyC1 polyC0; move: x%:P => X; rewrite subr0 divr1; ring.
split; [by apply: w; rewrite /c mxE | by apply: w; rewrite /d mxE | | by have [] := saddle_curves; apply: saddle_bent].
by apply/triple_coplanar; rewrite subrr tripleE /x_ /y_ /z_ ![(0 : 'rV[_]_3) _ _]mxE !mul0r !addr0.
Qed.

(** FJ21.C3.1 dependent_needs_distinct: for $a=b$ the rows $p_0,p_0,q_0,q_0$ are always dependent; the same surface is not developable. *)
Theorem FJ21_C3_1_dependent_needs_distinct x (c := nth 0 [:: row4 1 0 0 0; row4 1 1 0 0]) (d := nth 0 [:: row4 1 0 0 1; row4 1 0 1 1] : nat -> 'rV[F]_4)
    (p0 := last_point 1 (step01 F 1) c x) (q0 := last_point 1 (step01 F 1) d x) :
  dependent4 p0 p0 q0 q0 /\ ~ rational_developable (pcurve 1 (step01 F 1) c) (pcurve 1 (step01 F 1) d).
Proof.
split; last by have [] := saddle_curves; apply: saddle_bent.
exists 1, (-1), 0, 0; rewrite !xpair_eqE oner_eq0 /=; split=> //.
by rewrite scale1r scaleN1r subrr !scale0r !addr0.
Qed.

Lemma twisted_curve a b : pcurve 2 (step01 F 2) (twisted a b) = map_mx polyC a + 'X^2 *: map_mx polyC (b - a).
Proof.
apply/rowP=> k; rewrite !mxE /curve /= /step /shift /polys /step01 /coord /= !polyC1 !polyC0 !subr0 !divr1 !mul1r polyCD polyCN.
by move: (a 0 k)%:P (b 0 k)%:P 'X => x y X; ring.
Qed.

Lemma twisted_last a b x : last_point 2 (step01 F 2) (twisted a b) x = map_mx polyC a + (x%:P * 'X) *: map_mx polyC (b - a).
Proof.
apply/rowP=> k; rewrite !mxE /= /step /shift /polys /step01 /coord /= !polyC1 !polyC0 !subr0 !divr1 !mul1r polyCD polyCN.
by move: (a 0 k)%:P (b 0 k)%:P x%:P 'X => y z w X; ring.
Qed.

Lemma twisted_deriv a b : 2%:R = 0 :> F -> pderiv (pcurve 2 (step01 F 2) (twisted a b)) = 0.
Proof.
move=> two; rewrite pderiv_curve; last exact: span_step01.
by apply/rowP=> k; rewrite mulmxnE -mulr_natl -(rmorph_nat [rmorphism of @polyC F]) two rmorph0 mul0r mxE.
Qed.

Let a0 : 'rV[F]_4 := row4 1 0 0 0.
Let a1 : 'rV[F]_4 := row4 1 1 0 0.
Let b0 : 'rV[F]_4 := row4 1 0 1 0.
Let b1 : 'rV[F]_4 := row4 1 0 1 1.

Lemma weight_twisted a b : weight a = 1 -> weight b = 1 -> weight (pcurve 2 (step01 F 2) (twisted a b)) = 1.
Proof. by rewrite /weight twisted_curve !mxE => -> ->; rewrite subrr polyC0 mulr0 addr0. Qed.

Lemma weight_twisted_last a b x : weight a = 1 -> weight b = 1 -> weight (last_point 2 (step01 F 2) (twisted a b) x) = 1.
Proof. by rewrite /weight twisted_last !mxE => -> ->; rewrite subrr polyC0 mulr0 addr0. Qed.

Lemma twisted_det : \det (rows4 (last_point 2 (step01 F 2) (twisted a0 a1) 0) (last_point 2 (step01 F 2) (twisted a0 a1) 1)
  (last_point 2 (step01 F 2) (twisted b0 b1) 0) (last_point 2 (step01 F 2) (twisted b0 b1) 1)) = 'X^2.
Proof.
have e x y z v w : map_mx polyC (row4 1 0 y 0) + (x%:P * 'X) *: map_mx polyC (row4 1 z v w - row4 1 0 y 0 : 'rV[F]_4)
    = row4 1 (x%:P * 'X * z%:P) (y%:P + x%:P * 'X * (v - y)%:P) (x%:P * 'X * w%:P).
  by apply/rowP=> -[[|[|[|[|//]]]] lt_k]; rewrite !mxE /= ?subrr ?subr0 ?polyC1 ?polyC0; ring.
by rewrite !twisted_last /a0 /a1 /b0 /b1 !e det_row4 !subrr !polyC1 !polyC0 !(mul0r, mulr0, mul1r, mulr1, addr0, add0r, subr0) expr2.
Qed.

Lemma twisted_developable : 2%:R = 0 :> F -> rational_developable (pcurve 2 (step01 F 2) (twisted a0 a1)) (pcurve 2 (step01 F 2) (twisted b0 b1)).
Proof.
move=> two; apply/FJ21_2_1_determinant; rewrite ?weight_twisted ?oner_neq0 // /weight ?mxE //.
apply/det_dependent; exists 0, 1, 0, 0; rewrite !xpair_eqE oner_eq0 andbF; split=> //.
by rewrite twisted_deriv // !scale0r scaler0 !addr0.
Qed.

(** FJ21.P3.1 coplanar_needs_degree: in characteristic 2 the curves of the points $a,a,b$ of degree 2 have $c'=0$, so that the surface is developable by (2.1), and
    $c_0^1=a$, $c_1^1=a+t(b-a)$ and those of another such curve need not be coplanar.
    Hypotheses: $2=0$ in the field. *)
Theorem FJ21_P3_1_coplanar_needs_degree (c := twisted (row4 1 0 0 0) (row4 1 1 0 0)) (d := twisted (row4 1 0 1 0) (row4 1 0 1 1))
    (P := fun e x => last_point 2 (step01 F 2) e x) : 2%:R = 0 :> F ->
  [/\ forall x, weight (P c x) = 1, forall x, weight (P d x) = 1, rational_developable (pcurve 2 (step01 F 2) c) (pcurve 2 (step01 F 2) d)
    & ~ coplanar (affine (P c 0)) (affine (P c 1)) (affine (P d 0)) (affine (P d 1))].
Proof.
move=> two; have wc x : weight (P c x) = 1 by apply: weight_twisted_last; rewrite /weight mxE.
have wd x : weight (P d x) = 1 by apply: weight_twisted_last; rewrite /weight mxE.
split=> //; first exact: twisted_developable.
move/triple_coplanar=> e; have := congr1 (@FracField.tofrac _) twisted_det; rewrite det_pfun det_points ?weight_fun ?wc ?wd ?oner_eq0 //.
by rewrite -!/(affine _) e mulr0 => /esym/eqP; rewrite tofrac_eq0 expf_eq0 polyX_eq0.
Qed.

(** FJ21.C3.1 dependent_needs_degree: nor need their rows be dependent.
    Hypotheses: $2=0$ in the field. *)
Theorem FJ21_C3_1_dependent_needs_degree (c := twisted (row4 1 0 0 0) (row4 1 1 0 0)) (d := twisted (row4 1 0 1 0) (row4 1 0 1 1))
    (P := fun e x => last_point 2 (step01 F 2) e x) : 2%:R = 0 :> F ->
  rational_developable (pcurve 2 (step01 F 2) c) (pcurve 2 (step01 F 2) d) /\ ~ dependent4 (P c 0) (P c 1) (P d 0) (P d 1).
Proof.
move=> two; split; first exact: twisted_developable.
by move/det_dependent/eqP; rewrite twisted_det expf_eq0 polyX_eq0.
Qed.

(** FJ21.T3.1 exact_needs_degree: in characteristic 2 $p=(1,t^2,0,0)$ and $q=(1,0,t^2,0)$, of degree 2, have $p[t,0]=q[t,0]$, which is the relation for $\Lambda=M=0$,
    $\sigma=1$, and $p$ is no combination of $p'=q'=0$ and $q$.
    Hypotheses: $2=0$ in the field. *)
Theorem FJ21_T3_1_exact_needs_degree (c := twisted (row4 1 0 0 0) (row4 1 1 0 0)) (d := twisted (row4 1 0 0 0) (row4 1 0 1 0))
    (p := pcurve 2 (step01 F 2) c) (q := pcurve 2 (step01 F 2) d) : 2%:R = 0 :> F ->
  last_point 2 (step01 F 2) c 0 = last_point 2 (step01 F 2) d 0 /\ ~ spanned (pfun p) (pfun (pderiv p)) (pfun q) (pfun (pderiv q)).
Proof.
move=> two; split; first by rewrite !twisted_last mul0r !scale0r.
move=> [i [j [k]]]; rewrite /p /q !twisted_deriv // !twisted_curve => /rowP e; have := e 1.
rewrite !mxE /= subrr !(subr0, polyC0, polyC1, tofrac0, mulr0, add0r, addr0, mulr1) => /eqP.
by rewrite tofrac_eq0 expf_eq0 polyX_eq0.
Qed.
End Needs.
