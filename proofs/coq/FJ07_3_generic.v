(* FJ07, section 3: what "generic" means in Theorem 1. A developable surface whose boundaries have tangents that are not
   parallel has Lam(t) and M(t), rational functions; constants are a special case.
   Definitions:
     tangents_meet e A B C D   e (D - C) = A C' - B D' with polynomials e, A, B: Lam = t + n A/e, M = t + n B/e *)
From Torse Require Import Prelude Blossom Curves Points Bernstein Bezier BZZ19_4 Dependence FJ07_2 FJ07_3_net FJ07_3_blossoms FJ21_4.
From Torse Require Import Segments FJ07_2_cones FJ07_2_tangent.

Section Spatial.
Variable R : idomainType.
Implicit Types a b w : 'rV[R]_3.

Lemma crossZl (s : R) a b : cross (s *: a) b = s *: cross a b.
Proof. by apply: row3P; coordinates; ring. Qed.

Lemma crossZr (s : R) a b : cross a (s *: b) = s *: cross a b.
Proof. by apply: row3P; coordinates; ring. Qed.

Lemma crossC a b : cross a b = - cross b a.
Proof. by apply: row3P; coordinates; ring. Qed.

Lemma cross_self a : cross a a = 0.
Proof. by apply: row3P; coordinates; ring. Qed.

Lemma crossDr a b w : cross a (b + w) = cross a b + cross a w.
Proof. by apply: row3P; coordinates; ring. Qed.

Lemma crossDl a b w : cross (a + b) w = cross a w + cross b w.
Proof. by apply: row3P; coordinates; ring. Qed.

Lemma triple_comb s t a b : triple a b (s *: b + t *: a) = 0.
Proof. by coordinates; ring. Qed.

Lemma triple_cross a b w : triple a b w = dot (cross a b) w.
Proof. by coordinates; ring. Qed.

Lemma tripleZ (s : R) a b w : triple a b (s *: w) = s * triple a b w.
Proof. by coordinates; ring. Qed.
End Spatial.

Section Converse.
Variable F : fieldType.
Implicit Types (C D : 'rV[{poly F}]_3) (e A B : {poly F}) (n : nat) (t L M : F).

Definition tangents_meet e A B C D := e *: (D - C) = A *: pderiv C - B *: pderiv D.

(** FJ07.T1 converse: $[d',c',d-c]\equiv0$ iff $c'\times d'\equiv0$ (parallel tangents along every ruling: cones and translated
    curves among others), or $e(d-c)=Ac'-Bd'$ with polynomials $e\ne0$, $A$, $B$: the tangents of a ruling meet at
    $c[t^{\langle n-1\rangle},\Lambda(t)]=d[t^{\langle n-1\rangle},M(t)]$, $\Lambda=t+nA/e$, $M=t+nB/e$.
    Paper: "we focus on constant $\lambda,\mu$"; in general they are functions. *)
Theorem FJ07_T1_converse C D : developable C D <->
  cross (pderiv C) (pderiv D) = 0 \/ exists e A B, e != 0 /\ tangents_meet e A B C D.
Proof.
split=> [/triple_dependent[a [b [e [nz eq0]]]] | [par | [e [A [B [nz eq_W]]]]]]; last 2 first.
- by rewrite /developable triple_cross crossC par; coordinates; ring.
- apply: (mulfI nz); rewrite mulr0 -tripleZ eq_W -scaleNr.
  exact: triple_comb.
have [e0|e_nz] := eqVneq e 0; last first.
  right; exists e, (- b), a; split=> //; rewrite /tangents_meet; apply/eqP; rewrite -subr_eq0; apply/eqP.
  by rewrite -[RHS]eq0; move: (pderiv C) (pderiv D) (D - C) => C' D' W; by_entries k; ring.
left; move: eq0; rewrite e0 scale0r addr0 => eq0.
have a0 : a *: cross (pderiv C) (pderiv D) = 0.
  rewrite -crossZr (_ : a *: pderiv D = - b *: pderiv C); last by apply/eqP; rewrite scaleNr -addr_eq0 eq0.
  by rewrite crossZr cross_self scaler0.
have b0 : b *: cross (pderiv C) (pderiv D) = 0.
  rewrite -crossZl (_ : b *: pderiv C = - a *: pderiv D); last by apply/eqP; rewrite scaleNr -addr_eq0 addrC eq0.
  by rewrite crossZl cross_self scaler0.
move/eqP: a0; rewrite scalemx_eq0 => /orP[/eqP a0|/eqP //]; move/eqP: b0; rewrite scalemx_eq0 => /orP[/eqP b0|/eqP //].
by move: nz; rewrite a0 b0 e0 eqxx.
Qed.

Lemma ev_linear m (p q : 'rV[{poly F}]_m) A B t : ev (A *: p - B *: q) t = A.[t] *: ev p t - B.[t] *: ev q t.
Proof. by apply/rowP=> k; rewrite !mxE hornerD hornerN !hornerM. Qed.

(** FJ07.T1 functions: where $e(d-c)=Ac'-Bd'$ and $e(t)\ne0$, the relation (9) holds with $\Lambda(t)=t+nA(t)/e(t)$, $M(t)=t+nB(t)/e(t)$.
    Hypotheses: $n\ne0$ in the field and $e(t)\ne0$, so that the quotients have a meaning. *)
Theorem FJ07_T1_functions n e A B C D t : n%:R != 0 :> F -> e.[t] != 0 -> tangents_meet e A B C D ->
  related_at n C D t (t + n%:R * A.[t] / e.[t]) (t + n%:R * B.[t] / e.[t]) 1.
Proof.
move=> n0 e0 /(congr1 (fun p => ev p t)); rewrite ev_linear => eq_W; apply/rowP=> k.
have := congr1 (fun r : 'rV_3 => r 0 k) eq_W; rewrite !mxE !hornerM hornerD hornerN.
move: (C 0 k).[t] (D 0 k).[t] (C 0 k)^`().[t] (D 0 k)^`().[t] e.[t] A.[t] B.[t] n%:R n0 e0 => P Q P' Q' E a b N n0 e0 eq_P.
by apply: (by_multiple (z := - E^-1) eq_P); field; rewrite e0 n0.
Qed.

(** FJ07.T1 unique: $\Lambda(t)$ and $M(t)$ are the only ones.
    Hypotheses: $c'(t)\times d'(t)\ne0$; $n\ne0$ in the field, so that the relation, which divides by $n$, has a meaning. *)
Theorem FJ07_T1_unique n C D t L M L' M' : n%:R != 0 :> F -> cross (ev (pderiv C) t) (ev (pderiv D) t) != 0 ->
  related_at n C D t L M 1 -> related_at n C D t L' M' 1 -> L = L' /\ M = M'.
Proof.
move=> n0 nz; rewrite /related_at /tangent !scale1r; move: (ev C t) (ev D t) (ev (pderiv C) t) (ev (pderiv D) t) nz => P Q P' Q' nz e1 e2.
have eq_T : (L - L') *: P' = (M - M') *: Q'.
  apply/rowP=> k; have := congr1 (fun r : 'rV_3 => r 0 k) e1; have := congr1 (fun r : 'rV_3 => r 0 k) e2; rewrite !mxE.
  move: (P 0 k) (Q 0 k) (P' 0 k) (Q' 0 k) n%:R n0 => p q p' q' N n0 h2 h1.
  have {h1 h2}: p + (L - t) / N * p' - (p + (L' - t) / N * p') = q + (M - t) / N * q' - (q + (M' - t) / N * q') by rewrite h1 h2.
  by move=> h; apply: (by_multiple (z := N) h); field.
have l0 : (L - L') *: cross P' Q' = 0.
  by rewrite -crossZl eq_T crossZl cross_self scaler0.
have m0 : (M - M') *: cross P' Q' = 0.
  by rewrite -crossZr -eq_T crossZr cross_self scaler0.
by move/eqP: l0; move/eqP: m0; rewrite !scalemx_eq0 (negPf nz) !orbF !subr_eq0 => /eqP-> /eqP->.
Qed.

(** FJ07.T1 needs_tangents: where $d=c$ every $\Lambda=M$ will do. *)
Theorem FJ07_T1_needs_tangents n C t L : related_at n C C t L L 1.
Proof. by rewrite /related_at scale1r. Qed.

(** FJ07.T1 joint: where two pieces join with the same points and derivatives $c,c',d,d'$ (class $C^1$), both have the same $\Lambda^{*}$ and
    $M^{*}$, which is (10).
    Hypotheses: $c'(t)\times d'(t)\ne0$ at the joint; $n\ne0$ in the field, so that the relation has a meaning.
    Paper: "the final surface is at least C^1". *)
Theorem FJ07_T1_joint n (C D C' D' : 'rV[{poly F}]_3) t L M L' M' : n%:R != 0 :> F -> cross (ev (pderiv C) t) (ev (pderiv D) t) != 0 ->
  ev C t = ev C' t -> ev D t = ev D' t -> ev (pderiv C) t = ev (pderiv C') t -> ev (pderiv D) t = ev (pderiv D') t ->
  related_at n C D t L M 1 -> related_at n C' D' t L' M' 1 -> L = L' /\ M = M'.
Proof.
move=> n0 nz ec ed ec' ed' rel rel'; apply: (FJ07_T1_unique n0 nz rel).
by move: rel'; rewrite /related_at /tangent -ec -ed -ec' -ed'.
Qed.

(** FJ07.T1 cone_needs_curve: on a straight line through the vertex, $c=a+tw$, there are such values.
    Hypotheses: $n\ne0$ in the field, so that the relation has a meaning. *)
Theorem FJ07_T1_cone_needs_curve n (a w : 'rV[F]_3) (al : F) t (C := fixed a + 'X *: fixed w) : n%:R != 0 :> F ->
  related_at n C (fixed a + al%:P *: (C - fixed a)) t (t + n%:R * ((al - 1) * t)) t 1.
Proof.
move=> n0; apply/rowP=> k; rewrite !mxE subrr mul0r mul0r addr0 mul1r.
rewrite !(derivD, derivM, derivC, derivX) !hornerE /=; move: (a 0 k) (w 0 k) n%:R n0 => x y N n0; field.
exact: n0.
Qed.

(** FJ07.T1 cone: on the cone $d=a+\alpha(c-a)$ no values $\Lambda$, $M$ whatever have $c[t^{\langle n-1\rangle},\Lambda]=d[t^{\langle n-1\rangle},M]$.
    Hypotheses: $\alpha\ne1$; the curve does not run towards the vertex, $(c(t)-a)\times c'(t)\ne0$.
    Paper: says that cones fall out. *)
Theorem FJ07_T1_cone n C (a : 'rV[F]_3) (al : F) t L M : al != 1 -> cross (ev C t - a) (ev (pderiv C) t) != 0 ->
  ~ related_at n C (fixed a + al%:P *: (C - fixed a)) t L M 1.
Proof.
move=> nz1 nz eq_T; move/negP: nz; apply; set s : F := (L - t) / n%:R - (M - t) / n%:R * al.
have eq_P : (al - 1) *: (ev C t - a) = s *: ev (pderiv C) t.
  apply/rowP=> k; have := congr1 (fun r : 'rV_3 => r 0 k) eq_T; rewrite !mxE /s.
  rewrite derivD derivM derivB !derivC !(hornerD, hornerM, hornerN, hornerC, horner0).
  move: (C 0 k).[t] (C 0 k)^`().[t] (a 0 k) (_ / _) (_ / _) => p p' x y z h.
  by apply: (by_multiple (z := -1) h); ring.
have e : (al - 1) *: cross (ev C t - a) (ev (pderiv C) t) = 0.
  by rewrite -crossZl eq_P crossZl cross_self scaler0.
by move/eqP: e; rewrite scalemx_eq0 subr_eq0 (negPf nz1).
Qed.

(** FJ07.T1 translation: nor on the cylinder $d=c+w$ with equal rulings.
    Hypotheses: the curve does not run along them, $w\times c'(t)\ne0$. *)
Theorem FJ07_T1_translation n C (w : 'rV[F]_3) t L M : cross w (ev (pderiv C) t) != 0 -> ~ related_at n C (C + fixed w) t L M 1.
Proof.
move=> nz eq_T; move/negP: nz; apply; set s : F := (L - t) / n%:R - (M - t) / n%:R.
have -> : w = s *: ev (pderiv C) t.
  apply/rowP=> k; have := congr1 (fun r : 'rV_3 => r 0 k) eq_T; rewrite !mxE /s.
  rewrite derivD derivC !(hornerD, hornerM, hornerN, hornerC, horner0).
  move: (C 0 k).[t] (C 0 k)^`().[t] (w 0 k) (_ / _) (_ / _) => p p' x y z h.
  by apply: (by_multiple (z := -1) h); ring.
by rewrite crossZl cross_self scaler0.
Qed.

(** FJ07.T1 translation_needs_curve: on the straight line $c=tw$ there are such values.
    Hypotheses: $n\ne0$ in the field, so that the relation has a meaning. *)
Theorem FJ07_T1_translation_needs_curve n (w : 'rV[F]_3) t : n%:R != 0 :> F ->
  related_at n ('X *: fixed w) ('X *: fixed w + fixed w) t (t + n%:R) t 1.
Proof.
move=> n0; apply/rowP=> k; rewrite !mxE subrr !mul0r addr0 mul1r !(derivD, derivM, derivC, derivX) !hornerE /=.
by move: (w 0 k) n%:R n0 => x N n0; field.
Qed.

(** FJ07.T1 tangents: the tangent surface of (7), $d=c+\lambda c'$, has $\Lambda(t)=t+n\lambda(t)$, $M(t)=t$.
    Hypotheses: $n\ne0$ in the field, so that the relation has a meaning. *)
Theorem FJ07_T1_tangents n C lam t : n%:R != 0 :> F -> related_at n C (C + lam *: pderiv C) t (t + n%:R * lam.[t]) t 1.
Proof.
move=> n0; apply/rowP=> k; rewrite !mxE subrr mul0r mul0r addr0 mul1r hornerD hornerM.
by move: (C 0 k).[t] (C 0 k)^`().[t] lam.[t] n%:R n0 => p p' l N n0; field.
Qed.
End Converse.

Section NoConstants.
Variable F : fieldType.
Implicit Types (u : nat -> F) (c d : nat -> 'rV[F]_3) (n : nat) (L M : F).

(** FJ07.T1 straight: if the tangent surface $d=c+\lambda c'$, $\lambda\ne0$, obeys Theorem 1 with constants, $c$ is a straight line.
    Hypotheses: $\lambda\ne0$; the knots carry the piece, so that its points have a meaning. *)
Theorem FJ07_T1_straight n u L M c d lam : span n u -> lam != 0 -> related u n L M c d ->
  pcurve n u d = pcurve n u c + lam *: pderiv (pcurve n u c) -> cross (pderiv (pderiv (pcurve n u c))) (pderiv (pcurve n u c)) = 0.
Proof.
case: (posnP n) => [-> sp _ _ _|n0 sp l0 rel eq_d].
  by rewrite (pderiv_curve c sp) mulr0n; apply: row3P; coordinates; rewrite !mulr0 subrr.
have := congr1 (fun p => p *+ n) (FJ07_9_curve n0 rel).
rewrite !mulrnDl !scalerMnr -!pderiv_curve // eq_d.
move: (pcurve n u c) => C; rewrite (_ : pderiv (C + lam *: pderiv C) = (1 + lam^`()) *: pderiv C + lam *: pderiv (pderiv C)); last first.
  by apply/rowP=> k; rewrite !mxE derivD derivM; move: (C 0 k)^`() => x; ring.
move: (pderiv C) (pderiv (pderiv C)) => A B eq_T.
have {eq_T} eq_B : ((M%:P - 'X) * lam) *: B = (L%:P - 'X - lam *+ n - (M%:P - 'X) * (1 + lam^`())) *: A.
  have h k := congr1 (fun r : 'rV_3 => r 0 k) eq_T; apply/rowP=> k; have := h k; rewrite !(mxE, mulmxnE).
  move: (C 0 k) (A 0 k) (B 0 k) (lam^`()) (M%:P - 'X) (L%:P - 'X) => x y z l m p hk.
  by apply: (by_multiple (z := -1) hk); ring.
have: ((M%:P - 'X) * lam) *: cross B A = 0 by rewrite -crossZl eq_B crossZl cross_self scaler0.
move/eqP; rewrite scalemx_eq0 mulf_eq0 (negPf l0) orbF -opprB oppr_eq0 polyXsubC_eq0 /=.
by move/eqP.
Qed.

(** FJ07.T1 needs_functions: there are developable surfaces, tangent surfaces of $(t,t^2,t^3)$ of every degree $n\ge3$, without constants
    $\Lambda^{*}$, $M^{*}$.
    Hypotheses: 2 and the $C(n,i)$ are not 0 in the field, as in characteristic 0.
    Paper: "this result is generic". *)
Theorem FJ07_T1_needs_functions n : (2 < n)%N -> 2%:R != 0 :> F -> independent F n ->
  exists c d : nat -> 'rV[F]_3, developable (pbez n c) (pbez n d) /\ forall L M, ~ related (step01 F n) n L M c d.
Proof.
move=> lt_n two nz; pose p : 'rV[{poly F}]_3 := \row_(k < 3) 'X^k.+1.
have sp k : (size (p 0%R k) <= n.+1)%N by rewrite mxE size_polyXn; have := ltn_ord k; lia.
pose c i : 'rV[F]_3 := \row_k in_bernstein n (p 0 k) i.
have eq_c : pcurve n (step01 F n) c = p by exact: pcurve_onto.
have curve_bez (a : nat -> 'rV[F]_3) : pcurve n (step01 F n) a = pbez n a.
  by apply/rowP=> k; rewrite !mxE bezier_curve.
exists c, (tangent_row n c); rewrite FJ07_7_net -[pderiv _]scale1r; split; first exact: FJ07_7_developable.
move=> L M rel; have := @FJ07_T1_straight n _ L M c _ 1 (@span_step01 F n) (oner_neq0 _) rel.
rewrite !curve_bez FJ07_7_net scale1r => /(_ erefl); rewrite -curve_bez eq_c.
have [x1 y1] : x_ (pderiv p) = 1 /\ y_ (pderiv p) = 'X + 'X.
  by rewrite /x_ /y_ /pderiv !mxE derivX derivXn /= mulr2n.
have [x2 y2] : x_ (pderiv (pderiv p)) = 0 /\ y_ (pderiv (pderiv p)) = 1 + 1.
  by move: x1 y1; rewrite /x_ /y_ /pderiv ![map_mx _ (map_mx _ _) _ _]mxE => -> ->; rewrite derivC derivD derivX.
move=> par; have : z_ (cross (pderiv (pderiv p)) (pderiv p)) = 0 by rewrite par /z_ mxE.
rewrite {1}/z_ /cross /vec mxE /= x1 x2 y1 y2 mul0r sub0r mulr1 => /eqP; rewrite oppr_eq0 -polyC1 -polyCD polyC_eq0.
by apply/negP; rewrite (_ : 1 + 1 = 2%:R).
Qed.
End NoConstants.
