(* FJ07: what happens without the hypotheses of the theorems on curves and surfaces, one counterexample each.
   Definitions:
     bent_c, bent_d   two rows over the knots `bent`
     tangent_side x   the row 3 r + (x - t) r' of the tangent surface of r = (t, t^2, t^3), of degree 2 *)
From Torse Require Import Prelude Blossom Curves Points FJ07_2 FJ07_3_blossoms FJ21_4 FJ07_3_singular Needs_blossoms.
From mathcomp Require Import order ssrnum.
Import Order.Theory Num.Theory.

Section Space.
Variable R : comUnitRingType.

Lemma vec_xyz (x y z : R) : (x_ (vec x y z) = x) * (y_ (vec x y z) = y) * (z_ (vec x y z) = z).
Proof. by rewrite /x_ /y_ /z_ /vec !mxE. Qed.

Lemma crossE (a b : 'rV[R]_3) : (x_ (cross a b) = y_ a * z_ b - z_ a * y_ b) *
  (y_ (cross a b) = z_ a * x_ b - x_ a * z_ b) * (z_ (cross a b) = x_ a * y_ b - y_ a * x_ b).
Proof. by rewrite /cross /x_ /y_ /z_ /vec !mxE. Qed.
End Space.

Section Curves.
Variable F : fieldType.
Implicit Types (c d : 'rV[{poly F}]_3) (t : F).

Lemma ev_vec (p q r : {poly F}) t : ev (vec p q r) t = vec p.[t] q.[t] r.[t].
Proof. by apply/rowP=> -[[|[|[|//]]] ?]; rewrite !mxE. Qed.

Lemma pderiv_vec (p q r : {poly F}) : pderiv (vec p q r) = vec p^`() q^`() r^`().
Proof. by apply/rowP=> -[[|[|[|//]]] ?]; rewrite !mxE. Qed.
End Curves.

Section Bent.
Variable F : fieldType.
Notation bent := (bent F).
Implicit Types (k : F) (c : nat -> 'rV[F]_3).
Definition bent_c i : 'rV[F]_3 := nth 0 [:: 0; vec 0 1 0; vec 1 0 0] i.
Definition bent_d i : 'rV[F]_3 := nth 0 [:: vec 1 0 0; vec 1 0 0; vec 0 0 1] i.

Lemma bent_related k x : pblossom_with k bent bent_c [:: at_ 0; x] = pblossom_with k bent bent_d [:: at_ 1; x].
Proof.
apply/rowP=> j; rewrite !mxE !bent_blossom /coord /bent_c /bent_d /=; hide_entries.
by move=> *; ring.
Qed.

Lemma bent_pcurve k c : pcurve_with k 2 bent c
  = \row_j ('X * ('X * (c 1%N 0 j - c 0%N 0 j)%:P * k%:P) + (1 - 'X) * ((c 1%N 0 j)%:P * 'X + (c 2%N 0 j)%:P * (1 - 'X))).
Proof. by apply/rowP=> j; rewrite !mxE bent_curve. Qed.

Lemma bent_pvelocity k c : pvelocity_with k 2 bent c
  = \row_j ('X * ((c 1%N 0 j - c 0%N 0 j)%:P * k%:P) + (1 - 'X) * ((c 1%N 0 j)%:P - (c 2%N 0 j)%:P)).
Proof. by apply/rowP=> j; rewrite !mxE bent_velocity. Qed.

(* The value at 0 of the determinant of rows of polynomials. *)
Lemma triple_at0 (p q r : 'rV[{poly F}]_3) : (triple p q r).[0] = triple (ev p 0) (ev q 0) (ev r 0).
Proof.
rewrite !tripleE !hornerE /x_ /y_ /z_ !mxE.
by [].
Qed.
End Bent.

Section Failures.
Variables (F : fieldType) (k : F).

Let rows_at0 (C := pcurve_with k 2 (bent F) (bent_c F)) (D := pcurve_with k 2 (bent F) (bent_d F)) :
  [/\ ev (D - C) 0 = vec (-1) 0 1, ev (pderiv C) 0 = vec (-1 - 1) 1 0 & ev (pderiv D) 0 = vec 1 0 (-1 - 1)].
Proof.
have at0 z x y : ('X * ('X * z%:P * k%:P) + (1 - 'X) * (x%:P * 'X + y%:P * (1 - 'X))).[0] = y :> F.
  by rewrite !(hornerM, hornerD, hornerN, hornerC, hornerX); ring.
have slope z x y : ('X * ('X * z%:P * k%:P) + (1 - 'X) * (x%:P * 'X + y%:P * (1 - 'X)))^`().[0] = x - y - y :> F.
  by rewrite !(derivM, derivB, derivD, derivX, derivC) !(hornerM, hornerD, hornerN, hornerC, hornerX); ring.
rewrite /C /D !bent_pcurve; split; apply/rowP=> -[[|[|[|//]]] ?]; rewrite !mxE 1?hornerD 1?hornerN ?slope ?at0 /= ?mxE /= ?mxE /=.
all: by rewrite ?subrr ?subr0 ?sub0r ?oppr0.
Qed.

(** FJ07.3 needs_span: over such knots, $0,1,0,0$ of degree 2, the determinant of the four points is another at $t=0$ than that of the curves, whatever stands for
    $\frac10$. *)
Theorem FJ07_3_needs_span (C := pcurve_with k 2 (bent F) (bent_c F)) (D := pcurve_with k 2 (bent F) (bent_d F)) :
  triple (pderiv D) (pderiv C) (D - C)
    <> (2 ^ 2)%:R * triple (pvelocity_with k 2 (bent F) (bent_d F)) (pvelocity_with k 2 (bent F) (bent_c F)) (D - C).
Proof.
move/(congr1 (fun p => p.[0])); rewrite hornerM !triple_at0; case: rows_at0 => -> -> ->.
have at0 z x y : ('X * (z%:P * k%:P) + (1 - 'X) * (x%:P - y%:P)).[0] = x - y :> F.
  by rewrite !(hornerM, hornerD, hornerN, hornerC, hornerX); ring.
have -> : ev (pvelocity_with k 2 (bent F) (bent_c F)) 0 = vec (-1) 1 0.
  by rewrite bent_pvelocity; apply/rowP=> -[[|[|[|//]]] ?]; rewrite !mxE at0 /= ?mxE /=; ring.
have -> : ev (pvelocity_with k 2 (bent F) (bent_d F)) 0 = vec 1 0 (-1).
  by rewrite bent_pvelocity; apply/rowP=> -[[|[|[|//]]] ?]; rewrite !mxE at0 /= ?mxE /=; ring.
rewrite !tripleE !vec_xyz => /eqP; rewrite -subr_eq0 (_ : _ - _ = -1) ?oppr_eq0 ?oner_eq0 //.
by move: _.[0] => x; ring.
Qed.

(** FJ07.T1 developable_needs_span: over the same knots rows that obey the relation for $\Lambda^{*}=0$, $M^{*}=1$ need not span a developable surface, whatever stands for
    $\frac10$. *)
Theorem FJ07_T1_developable_needs_span :
  (forall x, pblossom_with k (bent F) (bent_c F) [:: at_ 0; x] = pblossom_with k (bent F) (bent_d F) [:: at_ 1; x]) /\
  ~ developable (pcurve_with k 2 (bent F) (bent_c F)) (pcurve_with k 2 (bent F) (bent_d F)).
Proof.
split=> [x|]; first exact: bent_related.
move/(congr1 (fun p => p.[0])); rewrite triple_at0; case: rows_at0 => -> -> ->; rewrite horner0 tripleE !vec_xyz => /eqP.
by rewrite (_ : _ + _ = -1) ?oppr_eq0 ?oner_eq0 //; ring.
Qed.
End Failures.

Section Singular.
Variable F : fieldType.
Implicit Types (t v L M : F).

Let related_vec n p q r p' q' r' t L M (x := (L - t) / n%:R) (y := (M - t) / n%:R) :
  p.[t] + x * p^`().[t] = p'.[t] + y * p'^`().[t] -> q.[t] + x * q^`().[t] = q'.[t] + y * q'^`().[t] ->
  r.[t] + x * r^`().[t] = r'.[t] + y * r'^`().[t] -> related_at n (vec p q r) (vec p' q' r') t L M 1.
Proof.
move=> e0 e1 e2; rewrite /related_at /tangent scale1r !pderiv_vec !ev_vec.
by apply/rowP=> -[[|[|[|//]]] ?]; rewrite !mxE /=.
Qed.

Lemma cusp_singular (c := vec 'X^2 'X^3 0) (d := vec 'X^2 'X^3 (('X + 1) ^+ 3)) : 3%:R != 0 :> F ->
  (forall t, related_at 3 c d t (-1) (-1) 1) /\
  forall v, cross ((1 - v) *: ev (pderiv c) 0 + v *: ev (pderiv d) 0) (ev d 0 - ev c 0) = 0.
Proof.
rewrite /c /d => n3; split=> [t|v].
  apply: related_vec => //; rewrite deriv_exp derivD derivX !derivC addr0 mul1r !hornerE /= -opprD [1 + t]addrC.
  move: (t + 1) => x; have -> : x * x + x * x + x * x = 3%:R * (x * x) by ring.
  by move: (x * x) 3%:R n3 => y k k0; field.
have d0 k : ('X^k.+2)^`().[0] = 0 :> F by rewrite derivXn hornerMn hornerXn exprS mul0r mul0rn.
by rewrite !pderiv_vec !ev_vec; apply: row3P; rewrite !crossE; coordinates; rewrite !d0; ring.
Qed.

Definition tangent_side x : 'rV[{poly F}]_3 :=
  vec (x%:P + 2%:R%:P * 'X) ((2%:R * x)%:P * 'X + 'X^2) ((3%:R * x)%:P * 'X^2).

Lemma tangent_side_at x t : ev (tangent_side x) t = vec (x + 2%:R * t) (2%:R * x * t + t ^+ 2) (3%:R * x * t ^+ 2) /\
  ev (pderiv (tangent_side x)) t = vec 2%:R (2%:R * x + t *+ 2) (3%:R * x * (t *+ 2)).
Proof.
rewrite /tangent_side pderiv_vec !ev_vec !(derivD, derivM, derivC, derivX, derivXn) !(mul0r, add0r, mulr1).
by rewrite !(hornerD, hornerM, hornerC, hornerX) mul1r mulr2n expr2.
Qed.

Lemma tangent_sides t L M : 2%:R != 0 :> F -> related_at 2 (tangent_side M) (tangent_side L) t L M 1.
Proof.
move=> n2; rewrite /related_at /tangent scale1r !(tangent_side_at _ _).1 !(tangent_side_at _ _).2 !vecE.
have half x : x = t + 2%:R * ((x - t) / 2%:R) by rewrite mulrC divfK // addrC subrK.
move: (half L) (half M); move: ((L - t) / 2%:R) ((M - t) / 2%:R) => x y -> ->.
by congr vec; ring.
Qed.

(* The normal at (0, v) of the surface between the rows for x and y. *)
Lemma tangent_normal x y v (c := tangent_side x) (d := tangent_side y) :
  cross ((1 - v) *: ev (pderiv c) 0 + v *: ev (pderiv d) 0) (ev d 0 - ev c 0)
    = vec 0 0 (2%:R * (x - y) * ((1 - v) * x + v * y)).
Proof.
rewrite /c /d !(tangent_side_at _ _).1 !(tangent_side_at _ _).2 mul0rn expr0n !mulr0 !addr0.
by apply: row3P; rewrite !crossE !vec_xyz; coordinates; ring.
Qed.

Lemma tangent_normal0 x y (c := tangent_side x) (d := tangent_side y) : 2%:R != 0 :> F -> x != 0 -> x != y ->
  cross (ev (pderiv c) 0) (ev d 0 - ev c 0) != 0.
Proof.
move=> n2 x0 xy; have -> : ev (pderiv c) 0 = (1 - 0) *: ev (pderiv c) 0 + 0 *: ev (pderiv d) 0.
  by rewrite subr0 scale1r scale0r addr0.
rewrite tangent_normal subr0 mul1r mul0r addr0.
apply/eqP=> /(congr1 (@z_ _)); rewrite vec_xyz /z_ mxE => /eqP.
by rewrite !mulf_eq0 (negPf n2) (negPf x0) subr_eq0 (negPf xy).
Qed.
End Singular.

Section Corollary3.
Variable F : realFieldType.
Implicit Types (t v L M : F).

(** FJ07.C3 needs_transversal: $\Lambda^{*}=M^{*}=-1$, so that $\Lambda,M<0$ on the piece $[0,1]$: the cylinder with rulings $(0,0,(t+1)^3)$
    over $c=(t^2,t^3,0)$ is singular along the whole ruling of the cusp $t=0$.
    Paper: Corollary 3 as printed says that it is not. *)
Theorem FJ07_C3_needs_transversal (c := vec 'X^2 'X^3 0 : 'rV[{poly F}]_3) (d := vec 'X^2 'X^3 (('X + 1) ^+ 3)) :
  (forall t, related_at 3 c d t (-1) (-1) 1) /\
  forall v, cross ((1 - v) *: ev (pderiv c) 0 + v *: ev (pderiv d) 0) (ev d 0 - ev c 0) = 0.
Proof. by apply: cusp_singular; rewrite pnatr_eq0. Qed.

(** FJ07.C3 needs_side: $\Lambda^{*}=-1<0<1=M^{*}$: the rows $r+\frac{M^{*}-t}3r'$, $r+\frac{\Lambda^{*}-t}3r'$ of the tangent surface of
    $r=(t,t^2,t^3)$ (times 3) have a regular first curve that no ruling touches at $t=0$, and a singular point at $v=1/2$. *)
Theorem FJ07_C3_needs_side (c := tangent_side 1 : 'rV[{poly F}]_3) (d := tangent_side (-1)) :
  [/\ forall t, related_at 2 c d t (-1) 1 1, cross (ev (pderiv c) 0) (ev d 0 - ev c 0) != 0 &
   cross ((1 - 2%:R^-1) *: ev (pderiv c) 0 + 2%:R^-1 *: ev (pderiv d) 0) (ev d 0 - ev c 0) = 0].
Proof.
have n2 : 2%:R != 0 :> F by rewrite pnatr_eq0.
split=> [t||]; [exact: tangent_sides|apply: tangent_normal0 => //|].
- by rewrite oner_eq0.
- by rewrite -subr_eq0 opprK.
rewrite /c /d tangent_normal (_ : _ * _ = 0); last by field.
by apply/rowP=> -[[|[|[|//]]] ?]; rewrite !mxE.
Qed.

(** FJ07.C3 needs_patch: $\Lambda^{*}=2$ and $M^{*}=1$ lie on one side of $t=0$ and the same surface is singular at $v=-1$, off the patch
    $0\le v\le1$. *)
Theorem FJ07_C3_needs_patch (c := tangent_side 1 : 'rV[{poly F}]_3) (d := tangent_side 2%:R) :
  [/\ forall t, related_at 2 c d t 2%:R 1 1, cross (ev (pderiv c) 0) (ev d 0 - ev c 0) != 0 &
   cross ((1 - (-1)) *: ev (pderiv c) 0 + (-1) *: ev (pderiv d) 0) (ev d 0 - ev c 0) = 0].
Proof.
have n2 : 2%:R != 0 :> F by rewrite pnatr_eq0.
split=> [t||]; [exact: tangent_sides|apply: tangent_normal0 => //|].
- by rewrite oner_eq0.
- by rewrite eq_sym -subr_eq0 (_ : 2%:R - 1 = 1) ?oner_eq0 //; ring.
rewrite /c /d tangent_normal (_ : _ * _ = 0); last by ring.
by apply/rowP=> -[[|[|[|//]]] ?]; rewrite !mxE.
Qed.
End Corollary3.
