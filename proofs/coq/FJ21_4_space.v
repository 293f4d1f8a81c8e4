(* FJ21, equations (4.2) and (4.3): the frame of the curves in space and that of their rows. x = d - c are the rulings. *)
From Torse Require Import Prelude Blossom Curves Points Dependence Functions FJ21_2 FJ21_3_needs FJ21_4_gauge.

Section Algebra.
Variable K : fieldType.
Implicit Types (x y c : 'rV[K]_3) (p q : 'rV[K]_4) (lam mu nu a b : K).

Lemma cross_combination x y a b : a *: x + b *: y = 0 -> cross x y != 0 -> a = 0 /\ b = 0.
Proof.
move=> e xy; have zero (z : K) : z *: cross x y = 0 -> z = 0 by move/eqP; rewrite scaler_eq0 (negPf xy) orbF => /eqP.
split; apply: zero.
  transitivity (cross (a *: x + b *: y) y); last by rewrite e; apply: row3P; coordinates; ring.
  by apply: row3P; coordinates; hide_entries; ring.
transitivity (cross x (a *: x + b *: y)); last by rewrite e; apply: row3P; coordinates; ring.
by apply: row3P; coordinates; hide_entries; ring.
Qed.

Lemma coplanar_frame x y c : (exists a b, c = a *: x + b *: y) -> triple x c (c + y) = 0.
Proof. by move=> [a [b ->]]; coordinates; hide_entries; ring. Qed.

Lemma frame_of_coplanar x y c : cross x y != 0 -> triple x c (c + y) = 0 -> exists a b, c = a *: x + b *: y.
Proof.
move=> xy /triple_dependent[i [j [k [nz e]]]].
have {}e : (j + k) *: c = - i *: x + - k *: y.
  by apply/eqP; rewrite -subr_eq0 -[X in _ == X]e; apply/eqP; by_entries h; ring.
have jk : j + k != 0.
  apply: contraNneq nz => jk; move/esym: e; rewrite jk scale0r => e.
  have [/eqP i0 /eqP k0] := cross_combination e xy; move: i0 k0; rewrite !oppr_eq0 => /eqP -> /eqP k0.
  by move: jk; rewrite k0 addr0 => ->.
by exists (- i / (j + k)), (- k / (j + k)); apply: (scalerI jk); rewrite e; by_entries h; field.
Qed.

Lemma divided (D a b : K) (x y c : 'rV[K]_3) : D != 0 -> D *: c = a *: x + b *: y -> c = (a / D) *: x + (b / D) *: y.
Proof. by move=> D0 e; apply: (scalerI D0); rewrite e; by_entries k; field. Qed.

(* The rows P = (w, w c), Q = (om, om d) and their derivatives. *)
Lemma frame_in_space (w om w' om' lam mu nu : K) (c x c' x' : 'rV[K]_3) : w != 0 ->
  let D := w - mu * (om - w) in
  (w' = lam * (om - w) + mu * (om' - w') + nu * w /\
   w' *: c + w *: c' = lam *: (om *: (c + x) - w *: c) + mu *: (om' *: (c + x) + om *: (c' + x') - (w' *: c + w *: c')) + nu *: (w *: c)) <->
  nu = (w' - lam * (om - w) - mu * (om' - w')) / w /\ D *: c' = (lam * om + mu * om') *: x + (mu * om) *: x'.
Proof.
move=> w0 /=; split=> [[e1 e2]|[-> e2]].
  split; first by rewrite {1}e1; field.
  apply/eqP; rewrite -subr_eq0; apply/eqP; transitivity (w' *: c + w *: c'
    - (lam *: (om *: (c + x) - w *: c) + mu *: (om' *: (c + x) + om *: (c' + x') - (w' *: c + w *: c')) + nu *: (w *: c))
    - (w' - (lam * (om - w) + mu * (om' - w') + nu * w)) *: c); first by by_entries k; ring.
  by rewrite -e2 -e1 !subrr scale0r subr0.
split; first by field.
apply/eqP; rewrite -subr_eq0; apply/eqP.
transitivity ((w - mu * (om - w)) *: c' - ((lam * om + mu * om') *: x + (mu * om) *: x')); first by by_entries k; field.
by rewrite e2 subrr.
Qed.
End Algebra.

Section Space.
Variable F : fieldType.
Notation K := {fraction {poly F}}.
Implicit Types (p q : 'rV[{poly F}]_4) (lam mu nu : K).

(** FJ21.4.3 tangent: equation (4.2): the surface is developable iff $c'=\lambda x+\mu x'$ with rational functions $\lambda,\mu$, for $x=d-c$.
    Hypotheses: $x\times x'\ne0$, the rulings turn, for the direction from the surface to $\lambda,\mu$.
    Paper: excludes cylinders, which have $x\times x'=0$. *)
Theorem FJ21_4_3_tangent p q (x := affine q - affine p) : cross x (pfderiv x) != 0 ->
  rational_developable p q <-> exists lam mu, pfderiv (affine p) = lam *: x + mu *: pfderiv x.
Proof.
move=> turn; have -> : rational_developable p q = (triple x (pfderiv (affine p)) (pfderiv (affine p) + pfderiv x) = 0).
  by rewrite /rational_developable /x pfderivB [_ + (_ - _)]addrC subrK.
by split; [exact: frame_of_coplanar | exact: coplanar_frame].
Qed.

(** FJ21.4.3 space: (4.3) in space: with the weights $w$, $\omega$ of $p$, $q$ and $x=d-c$: $p'=\lambda W+\mu W'+\nu p$ iff
    $\bigl(w-\mu(\omega-w)\bigr)c'=(\lambda\omega+\mu\omega')\,x+\mu\omega\,x'$ and $\nu=\frac{w'-\lambda(\omega-w)-\mu(\omega'-w')}w$: the term $\nu p$ vanishes in space.
    Hypotheses: the weights do not vanish identically, so that $c$, $d$ have a meaning.
    Paper: "rewrite this condition"; the $\lambda$, $\mu$ of (4.2) and of (4.3) are not the same. *)
Theorem FJ21_4_3_space p q lam mu nu (w := weight (pfun p)) (om := weight (pfun q)) (c := affine p) (x := affine q - affine p) :
  weight p != 0 -> weight q != 0 ->
  fframe (pfun p) (pfun q) lam mu nu <->
  nu = (fderiv w - lam * (om - w) - mu * (fderiv om - fderiv w)) / w /\
  (w - mu * (om - w)) *: pfderiv c = (lam * om + mu * fderiv om) *: x + (mu * om) *: pfderiv x.
Proof.
rewrite -!weight_fun -/w -/om => w0 om0; rewrite -(frame_in_space _ _ _ _ _ _ c) // /fframe.
have row (P Q : 'rV[K]_4) : P = Q <-> weight P = weight Q /\ place P = place Q.
  split=> [->|[e0 /rowP e]] //; apply/rowP=> k; case: (unliftP ord0 k) => [k'|] ->; last exact: e0.
  by have := e k'; rewrite !mxE.
have eP : place (pfun p) = w *: c by rewrite /c /affine -/w scalerA divff // scale1r.
have eQ : place (pfun q) = om *: (c + x) by rewrite /x addrC subrK /affine -/om scalerA divff // scale1r.
have slope (P : 'rV[K]_4) : place (pfderiv P) = pfderiv (place P) by apply/rowP=> k; rewrite !mxE.
have dP : place (pfderiv (pfun p)) = fderiv w *: c + w *: pfderiv c by rewrite slope eP pfderivZ.
have dQ : place (pfderiv (pfun q)) = fderiv om *: (c + x) + om *: (pfderiv c + pfderiv x).
  by rewrite slope eQ pfderivZ; congr (_ + _ *: _); rewrite /x pfderivB [RHS]addrC subrK addrC subrK.
have parts (P Q R : 'rV[K]_4) (i j k : K) : weight (i *: P + j *: Q + k *: R) = i * weight P + j * weight Q + k * weight R /\
    place (i *: P + j *: Q + k *: R) = i *: place P + j *: place Q + k *: place R.
  by split; [rewrite /weight !mxE | apply/rowP=> h; rewrite !mxE].
rewrite row; case: (parts (pfun q - pfun p) (pfderiv (pfun q - pfun p)) (pfun p) lam mu nu) => -> ->.
have sub (P Q : 'rV[K]_4) : weight (P - Q) = weight P - weight Q /\ place (P - Q) = place P - place Q.
  by split; [rewrite /weight !mxE | apply/rowP=> h; rewrite !mxE].
rewrite pfderivB; case: (sub (pfun q) (pfun p)) (sub (pfderiv (pfun q)) (pfderiv (pfun p))) => -> -> [-> ->].
have dw (P : 'rV[K]_4) : weight (pfderiv P) = fderiv (weight P) by rewrite /weight mxE.
by rewrite dP dQ eP eQ !dw.
Qed.

(** FJ21.4.3 projected: so (4.3) gives (4.2): $c'=\frac{\lambda\omega+\mu\omega'}D\,x+\frac{\mu\omega}D\,x'$ with $D=w-\mu(\omega-w)\ne0$.
    Hypotheses: $x\times x'\ne0$: the rulings turn; the weights do not vanish identically, so that $c$, $d$ have a meaning. *)
Theorem FJ21_4_3_projected p q lam mu nu (w := weight (pfun p)) (om := weight (pfun q)) (x := affine q - affine p) (D := w - mu * (om - w)) :
  weight p != 0 -> weight q != 0 -> cross x (pfderiv x) != 0 -> fframe (pfun p) (pfun q) lam mu nu ->
  D != 0 /\ pfderiv (affine p) = ((lam * om + mu * fderiv om) / D) *: x + (mu * om / D) *: pfderiv x.
Proof.
move=> w0 om0 turn /(FJ21_4_3_space lam mu nu w0 om0)[_ e]; rewrite -/w -/om -/x -/D in e.
have D0 : D != 0.
  apply/eqP=> D0; move: e; rewrite D0 scale0r => /esym e; have [_ /eqP] := cross_combination e turn.
  rewrite mulf_eq0 [om == 0]weight_fun (negPf om0) orbF => /eqP mu0.
  by move/eqP: D0; rewrite /D mu0 mul0r subr0 [_ == 0]weight_fun (negPf w0).
by split=> //; exact: divided D0 e.
Qed.

(** FJ21.4.3 tangent_needs_turning: the cylinder over a parabola, $p=(1,t,t^2,0)$, $q=p+(0,0,0,1)$, is developable, $x$ is constant and $c'$ is no multiple of it. *)
Theorem FJ21_4_3_tangent_needs_turning (p : 'rV[{poly F}]_4 := row4 1 'X ('X ^+ 2) 0) (q : 'rV[{poly F}]_4 := row4 1 'X ('X ^+ 2) 1) (x := affine q - affine p) :
  rational_developable p q /\ forall lam mu, pfderiv (affine p) <> lam *: x + mu *: pfderiv x.
Proof.
split=> [|lam mu /rowP/(_ 0)]; first by case: (FJ21_4_3_needs_turning F).
have first (r : 'rV[{poly F}]_4) : weight r = 1 -> place r 0 0 = 'X -> affine r 0 0 = FracField.tofrac 'X.
  by move=> r0; rewrite mxE => r1; rewrite /affine /weight !mxE r1 -/(weight r) r0 tofrac1 invr1 mul1r.
have ep : affine p 0 0 = FracField.tofrac 'X by apply: first; rewrite /weight /place ?mxE //= mxE.
have eq : affine q 0 0 = FracField.tofrac 'X by apply: first; rewrite /weight /place ?mxE //= mxE.
have x1 : x 0 0 = 0 by rewrite /x mxE [X in _ + X]mxE ep eq subrr.
have slope (y : 'rV[K]_3) : pfderiv y 0 0 = fderiv (y 0 0) by rewrite mxE.
rewrite slope [RHS]mxE [X in X + _]mxE [X in _ + X]mxE slope ep x1 -tofrac0 !fderiv_poly derivX derivC tofrac1 tofrac0 !mulr0 addr0 => /eqP.
by rewrite oner_eq0.
Qed.

(** FJ21.4.3 projected_needs_turning: $p=(1,t,t^2,0)$, $q=(2,2t,2t^2,2)$, the same cylinder, has $p'=W'$, the frame $\lambda=\nu=0$, $\mu=1$, and $D=0$.
    Hypotheses: $2\ne0$ in the field, so that there is a curve $d$. *)
Theorem FJ21_4_3_projected_needs_turning (p : 'rV[{poly F}]_4 := row4 1 'X ('X ^+ 2) 0) (q : 'rV[{poly F}]_4 := p + (p + row4 0 0 0 2%:R)) : 2%:R != 0 :> F ->
  [/\ weight q != 0, fframe (pfun p) (pfun q) 0 1 0 & weight (pfun p) - 1 * (weight (pfun q) - weight (pfun p)) = 0].
Proof.
move=> two; have wp : weight p = 1 by rewrite /weight mxE.
have wq : weight q = 2%:R by rewrite /weight /q mxE [X in _ + X]mxE ![row4 _ _ _ _ 0 0]mxE /= addr0.
split; rewrite ?weightE ?wp ?wq; first by rewrite -(rmorph_nat (polyC_rmorphism F)) polyC_eq0.
  rewrite /fframe pfderivB !pfderiv_fun scale0r scale1r scale0r addr0 add0r.
  have -> : pderiv q = pderiv p + pderiv p.
    apply/rowP=> k; rewrite !mxE !derivD; congr (_ + _); rewrite -[RHS]addr0; congr (_ + _).
    by case: k => -[|[|[|[|//]]]] lt_k; rewrite /= ?linear0 // -(rmorph_nat (polyC_rmorphism F)) derivC.
  by rewrite pfunD addrK.
by rewrite mul1r -[2%:R]/(1 + 1) tofracD addrK subrr.
Qed.
End Space.
