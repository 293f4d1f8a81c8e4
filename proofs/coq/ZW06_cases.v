(* ZW06: the three types of developable surfaces a(u) + v tau(u): cylinders, cones, tangent surfaces; equations (6) to (15).
   Definitions:
     regression p w b     the curve a_1 = a(u) - b(u) tau(u) of equation (8) *)
From Torse Require Import Prelude Blossom Curves Points Dependence Bernstein Bezier BZZ19_4 FJ21_4 ZW06.

Section Wronskian.
Variable F : fieldType.
Implicit Types p q : {poly F}.

Lemma coef_top p q a b : (size p <= a.+1)%N -> (size q <= b.+1)%N -> (p * q)`_(a + b) = p`_a * q`_b.
Proof.
move=> sp sq; rewrite coefM (bigD1 (inord a)) //= big1 ?addr0; first by rewrite inordK ?addKn // ltnS leq_addr.
move=> [i lt_i] /eqP/val_eqP /=; rewrite inordK ?ltnS ?leq_addr // => ne_i.
have [lt_a|] := ltnP a i; first by rewrite nth_default ?mul0r // (leq_trans sp).
rewrite leq_eqVlt (negPf ne_i) => lt_i'; rewrite [q`__]nth_default ?mulr0 // (leq_trans sq) //; lia.
Qed.

Lemma wronskian_zero n p q : good F n -> (size q <= n.+1)%N -> (size p < size q)%N -> p^`() * q = p * q^`() -> p = 0.
Proof.
move=> g sq lt_pq e; have [//|p0] := eqVneq p 0.
have := congr1 (fun f => ('X * f)`_((size p).-1 + (size q).-1)) e.
have sp1 : size p = (size p).-1.+1 by rewrite prednK // size_poly_gt0.
have sq1 : size q = (size q).-1.+1 by rewrite prednK //; lia.
have sX (f : {poly F}) : (size ('X * f^`())%R <= (size f).-1.+1)%N.
  have [->|f0] := eqVneq f 0; first by rewrite linear0 mulr0 size_poly0.
  by rewrite (leq_trans (size_mul_leq _ _)) // size_polyX prednK ?size_poly_gt0 //; exact: lt_size_deriv.
have cX (f : {poly F}) k : ('X * f^`())`_k = k%:R * f`_k.
  by rewrite coefXM; case: k => [|k]; rewrite ?mul0r //= coef_deriv mulr_natl.
rewrite /= mulrA (mulrCA 'X) !coef_top ?sX -?sp1 -?sq1 // !cX -/(lead_coef p) -/(lead_coef q) => /eqP.
have q0 : q != 0 by rewrite -size_poly_gt0; lia.
rewrite mulrCA mulrA -subr_eq0 -mulrBl mulf_eq0 lead_coef_eq0 (negPf q0) orbF.
rewrite -mulrBl mulf_eq0 lead_coef_eq0 (negPf p0) orbF -opprB oppr_eq0 -natrB; last by rewrite -ltnS -sp1 -sq1 ltnW.
rewrite (negPf (good_nat g _)) // subn_gt0 -ltnS -sp1 -sq1 lt_pq /=.
by rewrite (leq_trans (leq_subr _ _)) // -ltnS -sq1.
Qed.

Lemma proportional_polys n p q : good F n -> (size p <= n.+1)%N -> (size q <= n.+1)%N -> q != 0 ->
  p^`() * q = p * q^`() -> exists s : F, p = s *: q.
Proof.
move=> g sp sq q0 e; have [lt_pq|] := ltnP (size p) (size q).
  by exists 0; rewrite scale0r; apply: wronskian_zero g sq lt_pq e.
rewrite leq_eqVlt => /orP[/eqP e_s|lt_qp]; last first.
  have := wronskian_zero g sp lt_qp; rewrite mulrC -e mulrC => /(_ erefl)/eqP.
  by rewrite (negPf q0).
exists (lead_coef p / lead_coef q); apply/eqP; rewrite -subr_eq0; apply/eqP.
set s := _ / _; apply: (wronskian_zero g sq); last first.
  by rewrite derivB derivZ !mulrBl e; congr (_ - _); rewrite -!scalerAl; congr (_ *: _); exact: mulrC.
have sq1 : size q = (size q).-1.+1 by rewrite prednK // size_poly_gt0.
rewrite [X in (_ < X)%N]sq1 ltnS; apply/leq_sizeP=> j; rewrite leq_eqVlt coefB coefZ => /orP[/eqP <-|lt_j].
  by rewrite -/(lead_coef q) {1}e_s -/(lead_coef p) /s divfK ?lead_coef_eq0 // subrr.
have le_j : (size q <= j)%N by rewrite sq1.
by rewrite !nth_default ?mulr0 ?subr0 // -e_s.
Qed.

Lemma constant_poly p : (forall i, (i.+1 < size p)%N -> i.+1%:R != 0 :> F) -> p^`() = 0 -> p = (p`_0)%:P.
Proof.
move=> nz e; apply/polyP=> -[|i]; rewrite coefC //=; have [le_i|lt_i] := leqP (size p) i.+1; first by rewrite nth_default.
have := congr1 (fun f : {poly F} => f`_i) e; rewrite coef_deriv coef0.
by rewrite -mulr_natr => /eqP; rewrite mulf_eq0 (negPf (nz i lt_i)) orbF => /eqP.
Qed.
End Wronskian.

Section Cylinders.
Variables (F : fieldType) (m : nat).
Implicit Types (tau : nat -> 'rV[F]_m) (e : 'rV[F]_m) (h : nat -> F) (B C : {poly F}) (n i : nat).

(** ZW06.6 cylinder: $B\tau+C\tau'=0$ with polynomials $B,C$ that are not both zero (the case $A=0$) iff all $q_i-p_i=\tau_i$ are
    multiples of one vector $e$.
    Hypotheses: $n!\ne0$ in the field for the direction from (5) to the net. *)
Theorem ZW06_6_cylinder n tau : good F n ->
  (exists B C, (B, C) != (0, 0) /\ B *: pbez n tau + C *: pderiv (pbez n tau) = 0) <->
  exists e h, forall i, (i <= n)%N -> tau i = h i *: e.
Proof.
move=> g; split=> [[B [C [nz eq_BC]]]|[e [h eq_tau]]]; last first.
  have eq_w : pbez n tau = bez n h *: map_mx polyC e.
    rewrite (pbez_ext eq_tau); apply/rowP=> k; rewrite !mxE mulrC -bez_scale; apply: bez_ext => i _.
    by rewrite /coord mxE mulrC.
  have [h0|h0] := eqVneq (bez n h) 0.
    exists 1, 0; split; first by rewrite xpair_eqE oner_eq0.
    by rewrite eq_w h0 !scale0r scaler0 addr0.
  exists (- (bez n h)^`()), (bez n h); split; first by rewrite xpair_eqE negb_and h0 orbT.
  apply/rowP=> k; rewrite eq_w !mxE derivM derivC mulr0 addr0; ring.
have eq_k k : B * bez n (coord tau k) + C * (bez n (coord tau k))^`() = 0.
  by have := congr1 (fun r : 'rV__ => r 0 k) eq_BC; rewrite !mxE.
have [w0|[k k0]] : pbez n tau = 0 \/ exists k, bez n (coord tau k) != 0.
  have [/eqP|/eqP/rowP ne] := boolP (pbez n tau == 0); first by left.
  right; apply/existsP; apply: contraT => /existsPn all0; case: ne => k.
  by have := all0 k; rewrite negbK => /eqP; rewrite !mxE.
  exists 0, (fun=> 0) => i le_i; rewrite scale0r.
  have : pbez n tau = pbez n (fun=> 0).
    by rewrite w0; apply/rowP=> j; rewrite !mxE /bez big1 // => i' _; rewrite /coord mxE polyC0 mul0r.
  by move/(pbez_inj _ _ (good_independent g))/(_ i le_i).
have C0 : C != 0.
  apply: contraNneq nz => C0; have := eq_k k; rewrite C0 mul0r addr0 => /eqP; rewrite mulf_eq0 (negPf k0) orbF => /eqP ->.
  by [].
have prop j : exists s : F, bez n (coord tau j) = s *: bez n (coord tau k).
  apply: (proportional_polys g) => //; rewrite ?size_bez //.
  apply: (mulfI C0); have := eq_k j; have := eq_k k.
  move: (bez n (coord tau k)) (bez n (coord tau j)) => p q /(canRL (addKr _)) ek /(canRL (addKr _)) ej.
  by rewrite mulrA ej mulrCA ek; ring.
have /fin_all_exists[s eq_s] := prop.
exists (\row_j s j), (fun i => tau i 0 k) => i le_i; apply/rowP=> j; rewrite !mxE.
have := eq_s j; rewrite -mul_polyC -bez_scale => /(bez_inj (good_independent g))/(_ i le_i).
by rewrite /coord mulrC.
Qed.
End Cylinders.

Section Cases.
Variable F : fieldType.
Implicit Types (p w : 'rV[{poly F}]_3) (a b : {poly F}) (u v : F).

(** ZW06.6 cases: a surface $a(u)+v\tau(u)$ is developable iff $\tau\times\tau'=0$ (the case $A=0$) or $Aa'=B\tau+C\tau'$ with polynomials
    and $A\ne0$, that is $a'=\frac BA\tau+\frac CA\tau'$. *)
Theorem ZW06_6_cases p w : triple (pderiv p) w (pderiv w) = 0 <->
  cross w (pderiv w) = 0 \/ exists A B C, A != 0 /\ A *: pderiv p = B *: w + C *: pderiv w.
Proof.
split=> [/triple_dependent[A [B [C [nz e]]]]|[e|[A [B [C [A0 e]]]]]].
- have [A0|A0] := eqVneq A 0; last first.
    right; exists A, (- B), (- C); split=> //; apply/eqP; rewrite -subr_eq0 -[X in _ == X]e; apply/eqP.
    by rewrite !scaleNr opprD !opprK addrA.
  left; move: e; rewrite A0 scale0r add0r => e; have [C0|C0] := eqVneq C 0; last first.
    have ec : C *: cross w (pderiv w) = cross w (B *: w + C *: pderiv w).
      by apply: row3P; coordinates; hide_entries; ring.
    have /eqP : C *: cross w (pderiv w) = 0 by rewrite ec e; apply: row3P; coordinates; ring.
    by rewrite scalemx_eq0 (negPf C0) => /eqP.
  move: e nz; rewrite A0 C0 scale0r addr0 => /eqP; rewrite scalemx_eq0 => /orP[/eqP ->|/eqP -> _]; first by rewrite eqxx.
  by apply: row3P; coordinates; ring.
- rewrite /triple e /dot; coordinates; ring.
apply/triple_dependent; exists A, (- B), (- C); split; first by apply: contraNneq A0 => -[->].
by rewrite e !scaleNr -addrA -opprD subrr.
Qed.

Definition regression p w b := p - b *: w.

(** ZW06.7 shift: $a(u)+v\tau=a_1(u)+(v+b)\tau$ with $a_1=a(u)-b\tau$. *)
Theorem ZW06_7_shift p w b v : p + v%:P *: w = regression p w b + (v%:P + b) *: w.
Proof. by rewrite /regression scalerDl addrACA addNr addr0. Qed.

Lemma ev_regression p w b u : ev (regression p w b) u = ev p u - b.[u] *: ev w u.
Proof. by apply/rowP=> k; rewrite !mxE hornerD hornerN hornerM. Qed.

(** ZW06.8 singular: for $a'=a\tau+b\tau'$ the point $a_1(u)$ is the one singular point of the ruling, at $v=-b(u)$.
    Hypotheses: $\tau(u)\times\tau'(u)\ne0$, so that the ruling turns. *)
Theorem ZW06_8_singular p w a b u v : pderiv p = a *: w + b *: pderiv w ->
  cross (ev (pderiv w) u) (ev w u) != 0 ->
  cross (ev (pderiv p) u + v *: ev (pderiv w) u) (ev w u) = 0 <-> ev p u + v *: ev w u = ev (regression p w b) u.
Proof.
move=> e turn; have e_u : ev (pderiv p) u = a.[u] *: ev w u + b.[u] *: ev (pderiv w) u.
  by rewrite e; apply/rowP=> k; rewrite !mxE hornerD !hornerM.
have -> : cross (ev (pderiv p) u + v *: ev (pderiv w) u) (ev w u) = (v + b.[u]) *: cross (ev (pderiv w) u) (ev w u).
  by rewrite e_u; move: (ev w u) (ev (pderiv w) u) => x y; apply: row3P; coordinates; hide_entries; ring.
rewrite ev_regression; have w0 : ev w u != 0.
  by apply: contraNneq turn => ->; apply/eqP; apply: row3P; coordinates; ring.
split=> [/eqP|/addrI/eqP].
  by rewrite scalemx_eq0 (negPf turn) orbF addr_eq0 => /eqP ->; rewrite scaleNr.
by rewrite -scaleNr -subr_eq0 -scalerBl opprK scalemx_eq0 (negPf w0) orbF => /eqP ->; rewrite scale0r.
Qed.

(** ZW06.10 cone: where $a=b'$ there is a vertex $e$ with $a(u)+v\tau(u)=e+\bar v\tau(u)$, $\bar v=v+b(u)$: all rulings pass through it.
    Hypotheses: characteristic 0 or greater than the degree of $a_1=a(u)-b\tau$. *)
Theorem ZW06_10_cone p w a b : (forall k i, (i.+1 < size (regression p w b 0%R k))%N -> i.+1%:R != 0 :> F) -> pderiv p = a *: w + b *: pderiv w -> a = b^`() ->
  exists e : 'rV[F]_3, forall u v, ev p u + v *: ev w u = e + (v + b.[u]) *: ev w u.
Proof.
move=> nz /ZW06_9_derivative; rewrite -/(regression p w b) => e ab; move: e; rewrite ab subrr scale0r => e.
exists (\row_k (regression p w b 0 k)`_0) => u v.
have -> : \row_k (regression p w b 0 k)`_0 = ev (regression p w b) u.
  apply/rowP=> k; have := constant_poly (nz k); have := congr1 (fun r : 'rV__ => r 0 k) e; rewrite !mxE => e_k /(_ e_k) {}e_k.
  by rewrite [in RHS]e_k hornerC.
by rewrite ev_regression scalerDl addrACA addNr addr0.
Qed.

(** ZW06.14 parameter: $\bar v=\frac{v+b}{a-b'}$ is a parameter of the ruling in the place of $v$: $v=(a-b')\bar v-b$.
    Hypotheses: $a(u)\ne b'(u)$, so that the quotient has a meaning.
    Paper: $a\ne b'$; at single $u$ with $a(u)=b'(u)$ there is no $\bar v$. *)
Theorem ZW06_14_parameter a b u v v' : a.[u] - b^`().[u] != 0 ->
  v' = (v + b.[u]) / (a.[u] - b^`().[u]) <-> v = (a.[u] - b^`().[u]) * v' - b.[u].
Proof. by move=> nz; split=> ->; field. Qed.

(** ZW06.15 tangent: $a(u)+v\tau(u)=a_1(u)+\frac{v+b}{a-b'}a_1'(u)$: the rulings are tangents of $a_1$.
    Hypotheses: $a(u)\ne b'(u)$, so that the quotient has a meaning.
    Paper: $a\ne b'$; where $a(u)=b'(u)$ the curve $a_1$ has no tangent, $a_1'(u)=0$. *)
Theorem ZW06_15_tangent p w a b u v : pderiv p = a *: w + b *: pderiv w -> a.[u] - b^`().[u] != 0 ->
  ev p u + v *: ev w u = ev (regression p w b) u + ((v + b.[u]) / (a.[u] - b^`().[u])) *: ev (pderiv (regression p w b)) u.
Proof.
move=> /ZW06_9_derivative; rewrite -/(regression p w b) => -> nz.
have -> : ev ((a - b^`()) *: w) u = (a.[u] - b^`().[u]) *: ev w u by apply/rowP=> k; rewrite !mxE hornerM hornerD hornerN.
by rewrite scalerA divfK // ev_regression scalerDl addrACA addNr addr0.
Qed.
End Cases.
