(* FJ21, section 6: what happens without the hypotheses of the theorems, one counterexample each. The first are values at t = 0, as in Needs_FJ21.v. *)
From Torse Require Import Prelude Blossom Curves Points FJ21_4 FJ21_5 FJ21_6 FJ21_6_theorem Needs_FJ21.

Section Values.
Variable F : fieldType.
Notation e1 := (e1 F).
Notation e2 := (e2 F).
Notation e3 := (e3 F).
Implicit Types (L M s al be v k : F) (n : nat).
Let one_is_not_zero := @one_is_not_zero F.

(** FJ21.6 edge_needs_degree: where $n=0$ in the field, for $\Lambda=1$, $M=0$, $\sigma=1$, so that $E=1$, $v=0$ and $\alpha=\beta=0$: whatever number $k$ stands for $\frac1n$,
    $p=-kp'$ and $q=0$ are related, but $p'\ne0$. *)
Theorem FJ21_6_edge_needs_degree n k (p := jet (- k *: e1) e1) (q := jet 0 0) : n%:R = 0 :> F ->
  related_with k p q 0 1 0 1 /\ (1 - 0) *: ev (pderiv p) 0 + 0 *: ev (pderiv q) 0
    <> (n%:R * 1 * (1 - 0) / 1 ^+ 2) *: ev (q - p) 0 + (n%:R * (1 - 1) / 1) *: ((1 - 0) *: ev p 0 + 0 *: ev q 0).
Proof.
rewrite /p /q => n0; split; at_jets; rewrite ?n0; first by by_coords; ring.
by rewrite subr0 expr1n divr1 !mulr1 subrr mulr0 mul0r; split_coords => h1 _ _; refute (1 : F) h1.
Qed.

(** FJ21.6 edge_needs_E: for $\Lambda=M=t$, $\sigma=1$, so that $E=0$, there may be no singular point: $p=q=0$, $p'=(1,0,0)$, $q'=(0,1,0)$. *)
Theorem FJ21_6_edge_needs_E n (p := jet 0 e1) (q := jet 0 e2) : related_at n p q 0 0 0 1 /\
  forall v al be, (1 - v) *: ev (pderiv p) 0 + v *: ev (pderiv q) 0 <> al *: ev (q - p) 0 + be *: ((1 - v) *: ev p 0 + v *: ev q 0).
Proof.
rewrite /p /q; split=> [|v al be]; at_jets; first by by_coords; ring.
split_coords => h1 h2 _; have v0 : v = 0 by apply: (by_multiple (z := 1) h2); ring.
by rewrite v0 in h1; refute (1 : F) h1.
Qed.

(** FJ21.6 unique_needs_free: where $p=q=p'=q'=0$ every $v$, $\alpha$, $\beta$ serves. *)
Theorem FJ21_6_unique_needs_free n v al be (p := jet 0 0) : related_at n p p 0 1 0 1 /\
  (1 - v) *: ev (pderiv p) 0 + v *: ev (pderiv p) 0 = al *: ev (p - p) 0 + be *: ((1 - v) *: ev p 0 + v *: ev p 0).
Proof. by rewrite /p; split; at_jets; by_coords; ring. Qed.

(** FJ21.6 unique_needs_degree: where $n=0$ in the field, for $\Lambda=1$, $M=0$, $\sigma=1$: whatever $k\ne0$ stands for $\frac1n$, $p=(1,0,0)$, $p'=(0,1,0)$, $q=p+kp'$,
    $q'=p'+(0,0,1)$ are related and $p,W,W'$ independent, and the singular point has $\alpha=\frac1k$, not $n\sigma(\Lambda-M)/E^2=0$. For $k=0$ the relation $p=\sigma q$
    would make $p$ and $W$ dependent. *)
Theorem FJ21_6_unique_needs_degree n k (p := jet e1 e2) (q := jet (e1 + k *: e2) (e2 + e3)) : n%:R = 0 :> F -> k != 0 ->
  [/\ free_at p q 0, related_with k p q 0 1 0 1,
      (1 - 0) *: ev (pderiv p) 0 + 0 *: ev (pderiv q) 0 = k^-1 *: ev (q - p) 0 + 0 *: ((1 - 0) *: ev p 0 + 0 *: ev q 0)
    & k^-1 <> n%:R * 1 * (1 - 0) / 1 ^+ 2].
Proof.
rewrite /p /q => n0 k0; split.
- move=> i j l; at_jets; split_coords => h1 h2 h3.
  have i0 : i = 0 by apply: (by_multiple (z := 1) h1); ring.
  have l0 : l = 0 by apply: (by_multiple (z := 1) h3); ring.
  by split=> //; apply: (mulfI k0); apply: (by_multiple (z := 1) h2); rewrite l0; ring.
- by at_jets; by_coords; ring.
- by at_jets; by_coords; field.
by rewrite n0 !mul0r => /eqP; rewrite invr_eq0 (negPf k0).
Qed.

(** FJ21.6 functions_needs_degree: where $n=0$ in the field, $v=0$, $\alpha=1$, $\beta=0$ give $\Lambda=M=t$, $\sigma=1$: $p'=q-p$ for $p=0$, $q=(1,0,0)$, and $p\ne q$ whatever
    stands for $\frac1n$. *)
Theorem FJ21_6_functions_needs_degree n (p := jet 0 e1) (q := jet e1 0) : n%:R = 0 :> F ->
  [/\ (1 - 0) *: ev (pderiv p) 0 + 0 *: ev (pderiv q) 0 = 1 *: ev (q - p) 0 + 0 *: ((1 - 0) *: ev p 0 + 0 *: ev q 0),
      0 + n%:R * (1 - 0) / (1 + (0 - 1) * 0) = 0 :> F & forall k, ~ related_with k p q 0 0 0 1].
Proof.
rewrite /p /q => n0; split=> [||k]; at_jets; rewrite ?n0; [by by_coords; ring | by rewrite !mul0r addr0 |].
by split_coords => h1 _ _; refute (-1 : F) h1.
Qed.

(** FJ21.6 functions_needs_Lambda: for $v=0$, $\alpha=\beta=1$, where $\alpha+(v-1)\beta=0$, $p'=q$ is the condition, and there are no $\Lambda,M,\sigma$ for
    $p=(1,0,0)$, $q=p'=(0,1,0)$, $q'=0$. *)
Theorem FJ21_6_functions_needs_Lambda n (p := jet e1 e2) (q := jet e2 0) :
  (1 - 0) *: ev (pderiv p) 0 + 0 *: ev (pderiv q) 0 = 1 *: ev (q - p) 0 + 1 *: ((1 - 0) *: ev p 0 + 0 *: ev q 0) /\
  forall L M s, ~ related_at n p q 0 L M s.
Proof.
rewrite /p /q; split=> [|L M s]; at_jets; first by by_coords; ring.
by split_coords => h1 _ _; refute (1 : F) h1.
Qed.

(** FJ21.6 functions_needs_M: for $v=1$, $\alpha=-1$, $\beta=1$, where $\alpha+v\beta=0$, $q'=p$ is the condition, and there are no $\Lambda,M,\sigma$ for $q=(0,1,0)$,
    $p=q'=(1,0,0)$, $p'=0$. *)
Theorem FJ21_6_functions_needs_M n (p := jet e1 0) (q := jet e2 e1) :
  (1 - 1) *: ev (pderiv p) 0 + 1 *: ev (pderiv q) 0 = (-1) *: ev (q - p) 0 + 1 *: ((1 - 1) *: ev p 0 + 1 *: ev q 0) /\
  forall L M s, ~ related_at n p q 0 L M s.
Proof.
rewrite /p /q; split=> [|L M s]; at_jets; first by by_coords; ring.
split_coords => h1 h2 _; have s0 : s = 0 by apply: (by_multiple (z := -1) h2); ring.
by rewrite s0 in h1; refute (1 : F) h1.
Qed.
End Values.

Section Rows.
Variable F : fieldType.
Implicit Types (L M x y : F) (n : nat).

(* A row of one polynomial. *)
Let row1 (g : {poly F}) : 'rV[{poly F}]_1 := const_mx g.

Let row1P (g h : {poly F}) : row1 g = row1 h -> g = h.
Proof. by move/rowP/(_ 0); rewrite !mxE. Qed.

(** FJ21.T6.1 equivalence_needs_degree: where $n=0$ in the field and $r'\ne0$, $\Lambda\ne M$, the rows $r+\frac{M-t}{n+1}r'$ and $r+\frac{\Lambda-t}{n+1}r'$ are not related,
    whatever number $k$ stands for $\frac1n$. *)
Theorem FJ21_T6_1_equivalence_needs_degree m n L M k (r : 'rV[{poly F}]_m) (p := patch n r M) (q := patch n r L) :
  n%:R = 0 :> F -> L != M -> pderiv r != 0 ->
  p + (k *: (L%:P - 'X)) *: pderiv p <> q + (k *: (M%:P - 'X)) *: pderiv q.
Proof.
move=> n0 d r0 /rowP e; case/eqP: r0; apply/rowP=> i; have := e i; rewrite /p /q /patch natrS n0 add0r invr1 !mxE !scale1r.
rewrite !(derivD, derivN, derivM, derivC, derivX) sub0r -!mul_polyC => e1.
have dP : L%:P - M%:P != 0 :> {poly F} by rewrite -polyCB polyC_eq0 subr_eq0.
by apply: (mulfI dP); apply: (by_multiple (z := -1) e1); move: (r 0 i) (r 0 i)^`() (r 0 i)^`()^`() k%:P L%:P M%:P ('X : {poly F}) => *; ring.
Qed.

(** FJ21.T6.1 equivalence_needs_next: where $n+1=0$ in the field and $r'\ne0$, $\Lambda\ne M$, the rows $r+k(M-t)r'$ and $r+k(\Lambda-t)r'$ are not related in degree $n$, whatever
    number $k$ stands for $\frac1{n+1}$. *)
Theorem FJ21_T6_1_equivalence_needs_next m n L M k (r : 'rV[{poly F}]_m) : n.+1%:R = 0 :> F -> L != M -> pderiv r != 0 ->
  ~ related_rows n (r + (k *: (M%:P - 'X)) *: pderiv r) (r + (k *: (L%:P - 'X)) *: pderiv r) L M.
Proof.
move=> n1 d r0 /rowP e; case/eqP: r0; have nN : n%:R = -1 :> F by apply/eqP; rewrite -addr_eq0 -natrS n1.
apply/rowP=> i; have := e i; rewrite nN invrN invr1 !mxE !scaleN1r !(derivD, derivN, derivM, derivZ, derivC, derivX) sub0r -!mul_polyC => e1.
have dP : L%:P - M%:P != 0 :> {poly F} by rewrite -polyCB polyC_eq0 subr_eq0.
by apply: (mulfI dP); apply: (by_multiple (z := -1) e1); move: (r 0 i) (r 0 i)^`() (r 0 i)^`()^`() k%:P L%:P M%:P ('X : {poly F}) => *; ring.
Qed.

(** FJ21.T6.1 edge_needs_distinct: for $\Lambda=M$ no multiple of $(\Lambda-t)p+(t-M)q$ is $r\ne0$. *)
Theorem FJ21_T6_1_edge_needs_distinct m n L x (r : 'rV[{poly F}]_m) : r != 0 ->
  r <> x%:P *: ((L%:P - 'X) *: patch n r L + ('X - L%:P) *: patch n r L).
Proof. by move=> r0 e; move/eqP: r0; apply; rewrite e -scalerDl addrA subrK subrr scale0r scaler0. Qed.

(** FJ21.T6.1 degree_needs_next: where $n+1=0$ in the field, $r=t^{n+1}$ and no value $k$ in the place of $\frac1{n+1}$ makes the degree of $r+k(x-t)r'$ less than $n+1$. *)
Theorem FJ21_T6_1_degree_needs_next n x k : n.+1%:R = 0 :> F ->
  ('X^n.+1 + (k *: (x%:P - 'X)) * ('X^n.+1)^`())`_n.+1 = 1 :> F.
Proof. by move=> n1; rewrite derivXn -mulr_natl -(rmorph_nat [rmorphism of @polyC F]) n1 rmorph0 mul0r mulr0 addr0 coefXn eqxx. Qed.

(** FJ21.T6.1.cone needs_degree: in degree 0 the rows $p=0$ and $q=p+A$ with $A=1$ are not related, whatever number $k$ stands for $\frac1n$. *)
Theorem FJ21_T6_1_cone_needs_degree M k (p := row1 0) (q := row1 1) :
  p + (k *: (M%:P - 'X)) *: pderiv p <> q + (k *: (M%:P - 'X)) *: pderiv q /\ q = p + ('X - M%:P) ^+ 0 *: map_mx polyC (const_mx 1).
Proof.
split; last by apply/rowP=> i; rewrite !mxE expr0 mul1r add0r.
by move/rowP/(_ 0); rewrite !mxE linear0 -polyC1 derivC !mulr0 !addr0 polyC1 => /eqP; rewrite eq_sym oner_eq0.
Qed.

(** FJ21.T6.1.cone needs_factorial: in characteristic 2 and degree 3, $p=0$ and $q=t-M$ are related for $\Lambda=M$, and $q\ne p+(t-M)^3A$ for all $A$.
    Hypotheses: $2=0$ in the field. *)
Theorem FJ21_T6_1_cone_needs_factorial M (p := row1 0) (q := row1 ('X - M%:P)) : 2%:R = 0 :> F ->
  related_rows 3 p q M M /\ ~ exists A : 'rV[F]_1, q = p + ('X - M%:P) ^+ 3 *: map_mx polyC A.
Proof.
move=> two; have three : 3%:R = 1 :> F by rewrite (natrD _ 1 2) two addr0.
split=> [|[A /rowP/(_ 0)]]; last first.
  rewrite !mxE add0r => /(congr1 (fun g : {poly F} => size g)); rewrite size_XsubC.
  have [->|a0] := eqVneq (A 0 0) 0; first by rewrite polyC0 mulr0 size_poly0.
  by rewrite mulrC size_Mmonic ?monic_exp ?monicXsubC ?polyC_eq0 // size_exp_XsubC size_polyC a0.
apply/rowP=> k; rewrite !mxE linear0 derivB derivX derivC subr0 mulr1 mulr0 addr0 three invr1 scale1r.
by rewrite addrA subrK subrr.
Qed.

(** FJ21.T6.1.cone needs_size: in characteristic 2 and degree 1, $p=0$ and $q=(t-M)^3$ are related for $\Lambda=M$, and $q\ne p+(t-M)A$ for all $A$.
    Hypotheses: $2=0$ in the field. *)
Theorem FJ21_T6_1_cone_needs_size M (p := row1 0) (q := row1 (('X - M%:P) ^+ 3)) : 2%:R = 0 :> F ->
  related_rows 1 p q M M /\ ~ exists A : 'rV[F]_1, q = p + ('X - M%:P) ^+ 1 *: map_mx polyC A.
Proof.
move=> two; split=> [|[A /rowP/(_ 0)]]; last first.
  rewrite !mxE add0r => /(congr1 (fun g : {poly F} => size g)); rewrite size_exp_XsubC expr1.
  have [->|a0] := eqVneq (A 0 0) 0; first by rewrite polyC0 mulr0 size_poly0.
  by rewrite mulrC size_Mmonic ?monicXsubC ?polyC_eq0 // size_XsubC size_polyC a0.
have two' : 2%:R = 0 :> {poly F} by rewrite -(rmorph_nat [rmorphism of @polyC F]) two rmorph0.
apply/rowP=> k; rewrite !mxE linear0 deriv_exp derivB derivX derivC subr0 mul1r mulr0 addr0 invr1 scale1r -[_ *+ 3]mulr_natl -[M%:P - 'X]opprB /=.
by apply: (by_multiple (z := - ('X - M%:P) ^+ 3) (esym two')); move: ('X - M%:P) => y; ring.
Qed.

(** FJ21.T6.1 infinity_needs_factorial: in characteristic 2 and for $n+1=3$, $g=t-M$ has $g+\frac{M-t}{n+1}g'=0$ and is no $a(t-M)^3$.
    Hypotheses: $2=0$ in the field. *)
Theorem FJ21_T6_1_infinity_needs_factorial M (g := 'X - M%:P : {poly F}) : 2%:R = 0 :> F ->
  g + (3%:R^-1 *: (M%:P - 'X)) * g^`() = 0 /\ ~ exists a, g = a%:P * ('X - M%:P) ^+ 3.
Proof.
move=> two; have three : 3%:R = 1 :> F by rewrite (natrD _ 1 2) two addr0.
rewrite /g; split=> [|[a /(congr1 (fun g : {poly F} => size g))]].
  by rewrite derivB derivX derivC subr0 mulr1 three invr1 scale1r addrA subrK subrr.
rewrite size_XsubC mul_polyC; have [->|a0] := eqVneq a 0; first by rewrite scale0r size_poly0.
by rewrite size_scale // size_exp_XsubC.
Qed.
End Rows.
