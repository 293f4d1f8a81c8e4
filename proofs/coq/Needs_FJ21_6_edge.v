(* FJ21, section 6: the edge as a curve, the tangents, and the exceptional cases of Theorem 6.1: what happens without the hypotheses, one counterexample each. *)
From Torse Require Import Prelude Blossom Curves Points Bernstein Functions FJ21_3_theorem FJ21_3_needs FJ21_4 FJ21_4_gauge FJ21_6_theorem FJ21_6_curves FJ21_6_factor Needs_FJ21.

Section Values.
Variable F : fieldType.
Notation e1 := (e1 F).
Notation e2 := (e2 F).
Implicit Types (L M k lam mu nu : F) (n : nat).
Let one_is_not_zero := @one_is_not_zero F.

(** FJ21.6 tangents_needs_degree: where $n=0$ in the field $\Lambda=t+nf(t)=t$, and $r=q=r+fr'$ does not hold for $f=1$, $r'\ne0$, whatever stands for $\frac1n$. *)
Theorem FJ21_6_tangents_needs_degree n k (r := jet e1 e2) (q := r + 1 *: pderiv r) : n%:R = 0 :> F -> ~ related_with k r q 0 (0 + n%:R * 1) 0 1.
Proof.
rewrite /q /r => n0; rewrite /related_with /tangent n0 mul0r addr0 subrr !mul0r !scale0r !addr0 scale1r => /rowP/(_ (@Ordinal 3 1 isT)).
rewrite !mxE /= derivD derivM derivX !derivC mulr0 addr0 mul1r add0r !hornerE => e; apply: one_is_not_zero.
by apply: (by_multiple (z := -1) e); ring.
Qed.

(** FJ21.6 tangents_needs_factor: for $f=0$, $q=r$, there is no frame at all where $r$ and $r'$ are independent. *)
Theorem FJ21_6_tangents_needs_factor lam mu nu (r := jet e1 e2) : ~ frame r (r + 0 *: pderiv r) 0 lam mu nu.
Proof.
rewrite /r scale0r addr0; rewrite /frame subrr; at_jets => e.
have z : ev (0 : 'rV[{poly F}]_3) 0 = 0 /\ ev (pderiv (0 : 'rV[{poly F}]_3)) 0 = 0 by split; apply/rowP=> i; rewrite !mxE ?linear0 horner0.
by move: e; case: z => -> ->; split_coords => _ h2 _; refute (1 : F) h2.
Qed.

(** FJ21.T6.1 frame_needs_distinct: for $\Lambda=M$, where $q=p$, there is no frame at all if $p$ and $p'$ are independent: $r=(1,t,0)$.
    Hypotheses: $n$ and $n+1$ are not 0 in the field. *)
Theorem FJ21_T6_1_frame_needs_distinct n M lam mu nu (r := jet e1 e2) : n%:R != 0 :> F -> n.+1%:R != 0 :> F ->
  ~ frame (patch n r M) (patch n r M) 0 lam mu nu.
Proof.
move=> n0 n1; have [p0 p1] : patch n r M 0 (@Ordinal 3 0 isT) = 1 /\ patch n r M 0 (@Ordinal 3 1 isT) = 'X + n.+1%:R^-1 *: (M%:P - 'X).
  by split; rewrite /r /jet !mxE /= derivD derivM derivX !derivC !(mulr0, addr0, mulr1, mul1r, add0r, polyC1).
move: (patch n r M) p0 p1 => p p0 p1; rewrite /frame subrr => /rowP e; have := (e (@Ordinal 3 0 isT), e (@Ordinal 3 1 isT)); rewrite !mxE p0 p1.
rewrite -polyC1 !(derivD, derivZ, derivN, derivX, derivC, hornerE, linear0, horner0) /= => -[h0 h1].
have nu0 : nu = 0 by apply: (by_multiple (z := -1) h0); ring.
move: h1; rewrite nu0 => h1; case/eqP: n0; apply: (by_multiple (z := n.+1%:R) h1).
by move: n1; rewrite natrS; move: (n%:R) => N n1; field.
Qed.
End Values.

Section Rows.
Variable F : fieldType.
Implicit Types (L M a b k x : F) (n m : nat).

(** FJ21.T6.1 frame_needs_next: where $n+1=0$ in the field the rows $r+k(M-t)r'$ and $r+k(\Lambda-t)r'$, whatever number $k$ stands for $\frac1{n+1}$, do not have the frame
    $\lambda=\frac n{\Lambda-M}$, $\mu=\frac{M-t}{\Lambda-M}$, $\nu=0$ where $r'(t)\ne0$.
    Hypotheses: $\Lambda\ne M$. *)
Theorem FJ21_T6_1_frame_needs_next m n (r : 'rV[{poly F}]_m) L M k t : n.+1%:R = 0 :> F -> L != M -> ev (pderiv r) t != 0 ->
  ~ frame (r + (k *: (M%:P - 'X)) *: pderiv r) (r + (k *: (L%:P - 'X)) *: pderiv r) t (n%:R / (L - M)) ((M - t) / (L - M)) 0.
Proof.
move=> n1; rewrite -subr_eq0 => d r0 /rowP e; case/eqP: r0; have nN : n%:R = -1 :> F by apply/eqP; rewrite -addr_eq0 -natrS n1.
apply/rowP=> i; have := e i; rewrite nN !mxE !(derivD, derivN, derivM, derivZ, derivC, derivX, hornerE) /= ?hornerE.
by move: (r 0 i).[t] (r 0 i)^`().[t] ((r 0 i)^`()^`()).[t] => x y z e1; apply: (by_multiple (z := 1) e1); field.
Qed.

Let row1 (g : {poly F}) : 'rV[{poly F}]_1 := const_mx g.

(** FJ21.6.1 degree_needs_distinct: for $\Lambda=M$ the equation of $r$ says $p=q$ and nothing of $r$: $p=q=0$, $r=t^{n+2}$. *)
Theorem FJ21_6_1_degree_needs_distinct n M (r := row1 'X^n.+2) : (M - M)%:P *: r = (M%:P - 'X) *: 0 + ('X - M%:P) *: 0 /\ (n.+2 < size (r 0%R 0%R))%N.
Proof. by split; [rewrite subrr polyC0 scale0r !scaler0 addr0 | rewrite mxE size_polyXn]. Qed.

(** FJ21.6.1 degree_needs_size: for $p=t^{n+1}$, $q=0$ or $p=0$, $q=t^{n+1}$ the edge has degree $n+2$.
    Hypotheses: $\Lambda\ne M$. *)
Theorem FJ21_6_1_degree_needs_size n L M (d := (L - M)^-1) (r := row1 (d *: ((L%:P - 'X) * 'X^n.+1))) (s := row1 (d *: (('X - M%:P) * 'X^n.+1))) : L != M ->
  [/\ (L - M)%:P *: r = (L%:P - 'X) *: row1 'X^n.+1 + ('X - M%:P) *: 0, (n.+2 < size (r 0%R 0%R))%N,
      (L - M)%:P *: s = (L%:P - 'X) *: 0 + ('X - M%:P) *: row1 'X^n.+1 & (n.+2 < size (s 0%R 0%R))%N].
Proof.
rewrite -subr_eq0 => d0; have dV : d != 0 by rewrite invr_eq0.
have eD g : (L - M)%:P * (d *: g) = g :> {poly F} by rewrite -mul_polyC mulrA -polyCM mulfV // mul1r.
have sz x : size (('X - x%:P) * 'X^n.+1 : {poly F})%R = n.+3 by rewrite size_Mmonic ?monicXn ?polyXsubC_eq0 // size_XsubC size_polyXn.
split; rewrite ?mxE ?size_scale // ?sz //.
- by apply/rowP=> i; rewrite !mxE mulr0 addr0 eD.
- by rewrite -(opprB 'X) mulNr size_opp sz.
by apply/rowP=> i; rewrite !mxE mulr0 add0r eD.
Qed.

(** FJ21.6 lower_needs_size: for $r=t^{n+1}$ and $a=b=0$ the degree is $n+1$. *)
Theorem FJ21_6_lower_needs_size n (r := row1 'X^n.+1) : (n.+1 < size ((r + (0%:P * 'X + 0%:P) *: pderiv r)%R 0%R 0%R))%N.
Proof. by rewrite !mxE mul0r add0r mul0r addr0 size_polyXn. Qed.

(** FJ21.T6.1 degree_needs_size: for $r=t^{n+2}$ the rows $r+\frac{x-t}{n+1}r'$ have degree $n+2$.
    Hypotheses: $n+1\ne0$ in the field. *)
Theorem FJ21_T6_1_degree_needs_size n x (r := row1 'X^n.+2) : n.+1%:R != 0 :> F -> (patch n r x 0 0)`_n.+2 != 0.
Proof.
move=> n1; have [g [eg g1 g2]] : exists g : {poly F}, [/\ ('X^n.+2)^`() = g *+ n.+2, g`_n.+1 = 1 & g`_n.+2 = 0].
  by exists 'X^n.+1; rewrite derivXn !coefXn eqxx gtn_eqF.
rewrite !mxE eg coefD coefXn eqxx mulrnAr -scalerAl coefMn coefZ mulrBl coefB coefCM coefXM /= g1 g2 mulr0 sub0r.
by rewrite mulrN1 -[_ *+ n.+2]mulr_natr [n.+2%:R]natrS mulNr mulrDr mulVf // mulr1 opprD addrA subrr sub0r oppr_eq0 invr_eq0.
Qed.

(** FJ21.T6.1 infinity_needs_size: in characteristic 2 and for $n+1=1$, $g=(t-M)^3$ has $g+\frac{M-t}{n+1}g'=0$ and is no $a(t-M)$.
    Hypotheses: $2=0$ in the field. *)
Theorem FJ21_T6_1_infinity_needs_size M (g := ('X - M%:P) ^+ 3 : {poly F}) : 2%:R = 0 :> F ->
  g + (1%:R^-1 *: (M%:P - 'X)) * g^`() = 0 /\ ~ exists a, g = a%:P * ('X - M%:P) ^+ 1.
Proof.
move=> two; rewrite /g; split=> [|[a /(congr1 (fun g : {poly F} => size g))]]; last first.
  rewrite size_exp_XsubC expr1 mul_polyC; have [->|a0] := eqVneq a 0; first by rewrite scale0r size_poly0.
  by rewrite size_scale // size_XsubC.
have two' : 2%:R = 0 :> {poly F} by rewrite -(rmorph_nat [rmorphism of @polyC F]) two rmorph0.
rewrite deriv_exp derivB derivX derivC subr0 mul1r invr1 scale1r -[_ *+ 3]mulr_natl -[M%:P - 'X]opprB /=.
by apply: (by_multiple (z := - ('X - M%:P) ^+ 3) two'); move: ('X - M%:P) => y; ring.
Qed.

(** FJ21.T6.1 factor_needs_free: $r=(1,t)$ and $r_1=(1,1+t)$, in the same line, have the same rulings, that line, and are not proportional.
    Hypotheses: $n+1$ is not 0 in the field; $\Lambda\ne M$. *)
Theorem FJ21_T6_1_factor_needs_free n L M (r := \row_j nth 0 [:: 1; 'X] j : 'rV[{poly F}]_2) (s := \row_j nth 0 [:: 1; 1 + 'X] j) :
  n.+1%:R != 0 :> F -> L != M ->
  same_rulings (pfun (patch n r M)) (pfun (patch n r L)) (pfun (patch n s M)) (pfun (patch n s L)) /\ forall f, pfun s <> f *: pfun r.
Proof.
move=> n1 d; split=> [|f /rowP e]; last first.
  have := (e 0, e 1); rewrite !mxE /= tofracD tofrac1 mulr1 => -[<- /eqP]; rewrite mul1r -subr_eq0 addrK oner_eq0 //.
have D (g : {poly F}) : pderiv (\row_j nth 0 [:: 1; g] j : 'rV_2) = \row_j nth 0 [:: 0; g^`()] j.
  by apply/rowP=> -[[|[|//]] lt_j]; rewrite !mxE /= -?polyC1 ?derivC.
apply: same_trans (same_sym (FJ21_T6_1_rulings r n1 d)) _; apply: same_trans (FJ21_T6_1_rulings s n1 d).
have er : pderiv s = pderiv r by rewrite /r /s !D derivD derivX -polyC1 derivC add0r.
have es : pfun s = pfun r + pfun (pderiv r).
  rewrite -pfunD /r D derivX; congr pfun; apply/rowP=> -[[|[|//]] lt_j]; rewrite !mxE /= ?addr0 //; exact: addrC.
rewrite er; split.
- by exists 1, 1; rewrite !scale1r.
- by exists 0, 1; rewrite scale0r add0r scale1r.
- by exists 1, (-1); rewrite scale1r scaleN1r es addrK.
by exists 0, 1; rewrite scale0r add0r scale1r.
Qed.

(** FJ21.T6.1 rulings_needs_distinct: for $\Lambda=M$ the rows $p=q$ span no ruling: $r=(1,t)$, where $r'$ is no multiple of $p$. *)
Theorem FJ21_T6_1_rulings_needs_distinct n M (r := \row_j nth 0 [:: 1; 'X] j : 'rV[{poly F}]_2) :
  ~ same_rulings (pfun r) (pfun (pderiv r)) (pfun (patch n r M)) (pfun (patch n r M)).
Proof.
case=> _ _ _ [i [j]]; rewrite -scalerDl => /rowP e; have := (e 0, e 1); rewrite !mxE /= derivX -polyC1 derivC mulr0 addr0 polyC1.
by rewrite tofrac0 tofrac1 mulr1 => -[<- /eqP]; rewrite mul0r oner_eq0.
Qed.
End Rows.

Section Functions.
Variable F : fieldType.
Notation K := {fraction {poly F}}.
Notation "x %:F" := (@FracField.tofrac [idomainType of {poly F}] x).
Implicit Types (n m : nat).

(** FJ21.C6.1 needs_degree: where $n=0$ in the field, for $\Lambda=t+1$, $M=t$, $\sigma=1$, so that $E=1$, $v=\beta=0$ and $\alpha=n\sigma(\Lambda-M)/E^2=0$: whatever number $k$
    stands for $\frac1n$, $p$ and $q=p+kp'$ are related, and $r=p$ has not $r'=0$ where $p'\ne0$. *)
Theorem FJ21_C6_1_needs_degree n m (p : 'rV[{poly F}]_m) (k : F) (q := p + k%:P *: pderiv p) (L := 'X%:F + 1 : K) (M := 'X%:F : K) (r := (1 - 0 : K) *: pfun p + (0 : K) *: pfun q) :
  n%:R = 0 :> K -> pderiv p != 0 ->
  pfun p + ((L - 'X%:F) * k%:P%:F) *: pfun (pderiv p) = 1 *: (pfun q + ((M - 'X%:F) * k%:P%:F) *: pfun (pderiv q)) /\
  pfderiv r <> (n%:R * 1 * (L - M) / 1 ^+ 2 + fderiv (0 : K)) *: pfun (q - p) + (n%:R * (1 - 1) / 1) *: r.
Proof.
move=> n0 p0; split.
  by rewrite /L /M [_ + 1]addrC addrK subrr mul1r mul0r scale0r addr0 scale1r /q pfunD pfunZ.
have f0 : fderiv (0 : K) = 0 by rewrite -tofrac0 fderiv_poly linear0 tofrac0.
rewrite n0 f0 !mul0r addr0 !scale0r addr0 /r subr0 scale1r scale0r addr0 pfderiv_fun => e; case/eqP: p0.
apply: (@pfun_inj F m); rewrite e; apply/rowP=> i; by rewrite !mxE tofrac0.
Qed.

(** FJ21.C6.1 needs_E: a cylinder, $p=(1,t,t^2,0)$, $q=p+t(0,0,0,1)$, related by $\Lambda=M=t-nt$, $\sigma=1$, where $E=0$: no curve $(1-v)p+vq$ with a rational $v$ has its
    tangents in the rulings.
    Hypotheses: $n\ne0$ in the field. *)
Theorem FJ21_C6_1_needs_E n (p : 'rV[{poly F}]_4 := row4 1 'X ('X ^+ 2) 0) (q : 'rV[{poly F}]_4 := row4 1 'X ('X ^+ 2) 'X) (L := 'X%:F - n%:R * 'X%:F : K) : n%:R != 0 :> F ->
  [/\ frelated n p q L L 1, L - 'X%:F + 1 * ('X%:F - L) = 0
    & forall v x y : K, pfderiv ((1 - v) *: pfun p + v *: pfun q) <> x *: pfun (q - p) + y *: ((1 - v) *: pfun p + v *: pfun q)].
Proof.
move=> /natrF0 n0; split=> [||v x y /rowP e].
- rewrite /frelated /ftangent scale1r; have -> : (L - 'X%:F) / n%:R = - 'X%:F by rewrite /L addrAC subrr add0r mulNr mulrAC mulfV // mul1r.
  apply/rowP=> -[[|[|[|[|//]]]] lt_k]; rewrite !mxE //= derivX linear0 tofrac0 tofrac1 mulr0 mulr1 addr0 subrr //.
- by rewrite mul1r addrA subrK subrr.
have entry (a : {poly F}) : (1 - v) * a%:F + v * a%:F = a%:F by rewrite -mulrDl subrK mul1r.
have := (e 0, e 1); rewrite !mxE /= !entry !fderiv_poly derivX -polyC1 derivC polyC1 tofrac0 tofrac1 !subrr !tofrac0 !mulr0 !add0r mulr1 => -[<-].
by rewrite mul0r => /eqP; rewrite oner_eq0.
Qed.
End Functions.
