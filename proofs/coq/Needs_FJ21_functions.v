(* FJ21, Corollary 4.1, (5.3) and (5.4) for rational functions: what happens without the hypotheses, one counterexample each.
   Definitions:
     bent      the rows (1+t, t, t^2, t^3) of a twisted cubic *)
From Torse Require Import Prelude Blossom Curves Points Functions FJ21_2 FJ21_3_theorem FJ21_3_needs FJ21_4 FJ21_4_gauge FJ21_5 Needs_FJ21_6_edge.

Section Needs.
Variable F : fieldType.
Notation K := {fraction {poly F}}.
Notation "x %:F" := (@FracField.tofrac [idomainType of {poly F}] x).
Notation T := ('X%:F : K).
Implicit Types (L M s lam mu nu : K) (n : nat).

Definition bent : 'rV[{poly F}]_4 := row4 (1 + 'X) 'X ('X ^+ 2) ('X ^+ 3).

Lemma entries_bent : [/\ bent 0 0 = 1 + 'X, bent 0 1 = 'X, pderiv bent 0 0 = 1 & pderiv bent 0 1 = 1].
Proof. by rewrite /bent; split; rewrite !mxE //= ?derivD derivX // -polyC1 derivC add0r. Qed.

Lemma bend_bent : pderiv (pderiv bent) 0 0 = 0 /\ pderiv (pderiv bent) 0 1 = 0.
Proof. by have [_ _ d0 d1] := entries_bent; rewrite !pderivE -!(pderivE bent) d0 d1 -polyC1 derivC. Qed.

Lemma ftangentE m n (r : 'rV[{poly F}]_m) x k : ftangent n r x 0 k = (r 0 k)%:F + (x - T) / n%:R * (pderiv r 0 k)%:F.
Proof. by rewrite /ftangent mxE [in X in _ + X]mxE !pfunE. Qed.

Lemma no_relation n L M s : ~ frelated n bent (pderiv bent) L M s.
Proof. by have [_ _ _ no] := FJ21_T3_1_needs_tangents F; apply: no. Qed.

(* Coordinates 0 and 1 of p'+xp'' are 1 and those of p+yp' differ by 1. *)
Lemma no_relation_back n L M s : ~ frelated n (pderiv bent) bent L M s.
Proof.
have [p0 p1 d0 d1] := entries_bent; have [e0 e1] := bend_bent.
have scaled (x : 'rV[K]_4) k : (s *: x) 0 k = s * x 0 k by rewrite mxE.
move=> /rowP e; have := e 0; have := e 1; rewrite !scaled !ftangentE p0 p1 d0 d1 e0 e1 tofrac0 tofrac1 tofracD tofrac1 mulr0 addr0 !mulr1 => h1 h0.
have s0 : s = 0 by rewrite -[s]mulr1 -{1}(addrK (T + (M - T) / n%:R) 1) addrA mulrBr -h0 -h1 subrr.
by move/eqP: h0; rewrite s0 mul0r oner_eq0.
Qed.

(** FJ21.C4.1 functions_needs_difference: $p=(1+t,t,t^2,t^3)$ and $q=p'$ have the frame $\lambda=\nu=1$, $\mu=0$, and there are no $\Lambda,M,\sigma$, in no degree $n$. *)
Theorem FJ21_C4_1_functions_needs_difference : fframe (pfun bent) (pfun (pderiv bent)) 1 0 1 /\ forall n L M s, ~ frelated n bent (pderiv bent) L M s.
Proof. by split=> [|n L M s]; [rewrite /fframe scale0r addr0 !scale1r subrK pfderiv_fun | exact: no_relation]. Qed.

(** FJ21.C4.1 functions_needs_lambda: for the same $p$ the rows $p'$ and $2p'-p$ have the frame $\lambda=0$, $\mu=\nu=1$, and there are no $\Lambda,M,\sigma$, in no degree $n$. *)
Theorem FJ21_C4_1_functions_needs_lambda (p := pderiv bent) (q := p + (p - bent)) :
  fframe (pfun p) (pfun q) 0 1 1 /\ forall n L M s, ~ frelated n p q L M s.
Proof.
have dq : pderiv q = pderiv p + (pderiv p - p).
  by apply/rowP=> k; rewrite !mxE derivD derivB.
split=> [|n L M s /rowP e].
  rewrite /fframe pfderivB !pfderiv_fun dq /q scale0r add0r !scale1r pfunD pfunB.
  by apply/rowP=> k; rewrite !mxE; hide_entries; ring.
have [p0 p1 d0 d1] := entries_bent; have [e0 e1] := bend_bent.
have scaled (x : 'rV[K]_4) k : (s *: x) 0 k = s * x 0 k by rewrite mxE.
have sum (x y : 'rV[{poly F}]_4) k : (x + (x - y)) 0 k = x 0 k + (x 0 k - y 0 k) by rewrite !mxE.
have := e 0; have := e 1; rewrite !scaled !ftangentE dq /q !sum p0 p1 /p d0 d1 e0 e1 !tofracD !tofracN tofrac0 tofrac1 tofracD tofrac1 mulr0 addr0 => h1 h0.
have s0 : s = 0 by transitivity (s * (1 + (1 - T) + (M - T) / n%:R * (0 + (0 - 1))) - s * (1 + (1 - (1 + T)) + (M - T) / n%:R * (0 + (0 - 1)))); [ring | rewrite -h0 -h1 subrr].
by move/eqP: h0; rewrite s0 mul0r oner_eq0.
Qed.

(** FJ21.C4.1 functions_needs_E: the cylinder $p=(1,t,t^2,0)$, $q=p+t(0,0,0,1)$ is related by $\Lambda=M=t-nt$, $\sigma=1$, where $E=0$, and has no frame.
    Hypotheses: $n\ne0$ in the field. *)
Theorem FJ21_C4_1_functions_needs_E n (p : 'rV[{poly F}]_4 := row4 1 'X ('X ^+ 2) 0) (q : 'rV[{poly F}]_4 := row4 1 'X ('X ^+ 2) 'X) (L := T - n%:R * T) : n%:R != 0 :> F ->
  [/\ frelated n p q L L 1, L - 1 * L + T * (1 - 1) = 0 & forall lam mu nu, ~ fframe (pfun p) (pfun q) lam mu nu].
Proof.
move=> n0; have [rel _ _] := FJ21_C6_1_needs_E n0; split=> // [|lam mu nu /rowP e]; first by rewrite mul1r !subrr mulr0 addr0.
have := (e 0, e 1); rewrite !mxE /= !fderiv_poly !subrr derivX -polyC1 derivC tofrac0 tofrac1.
rewrite -tofrac0 fderiv_poly linear0 tofrac0 !mulr0 !add0r mulr1 => -[<-].
by rewrite mul0r => /eqP; rewrite oner_eq0.
Qed.

(* The rows fp and fp' for f=1+t. *)
Lemma tangent_at m n (r : 'rV[{poly F}]_m) : ftangent n r T = pfun r.
Proof. by rewrite /ftangent subrr mul0r scale0r addr0. Qed.

Lemma factor_value : (linear 1 1)%:F = 1 + T.
Proof. by rewrite /linear scale1r polyC1 tofracD tofrac1. Qed.

Lemma tangent_off m n (r : 'rV[{poly F}]_m) : n.+1%:R != 0 :> F ->
  ftangent n.+1 (linear 1 1 *: r) (- (1 + n%:R * (1 + T))) = - ((1 + T) ^+ 2) *: pfun (pderiv r).
Proof.
move=> /natrF0 n1; rewrite /ftangent; have -> : (- (1 + n%:R * (1 + T)) - T) / n.+1%:R = - (1 + T) :> K.
  by apply: (canLR (mulfK n1)); rewrite mulrSr; ring.
have -> : pderiv (linear 1 1 *: r) = r + linear 1 1 *: pderiv r by apply/rowP=> k; rewrite !mxE derivM deriv_linear polyC1 mul1r.
by rewrite pfunD !pfunZ factor_value; by_entries k; ring.
Qed.

(** FJ21.5.3 functions_needs_H: for $f=g=1+t$, $\tilde\Lambda=-1-n(1+t)$ and $\tilde M=t$, so that $nf+f(\tilde\Lambda)=0$, the rows $fp$ and $gp'$ are related in degree
    $n+1$ with $\tilde\sigma=-(1+t)$, and there are no $\Lambda,M,\sigma$ in degree $n$.
    Hypotheses: $n+1\ne0$ in the field. *)
Theorem FJ21_5_3_functions_needs_H n (f := linear 1 1) (L := - (1 + n%:R * (1 + T))) : n.+1%:R != 0 :> F ->
  [/\ n%:R * (1 + T) + (1 + L) = 0, frelated n.+1 (f *: bent) (f *: pderiv bent) L T (- (1 + T))
    & forall L' M s, ~ frelated n bent (pderiv bent) L' M s].
Proof.
move=> n1; split=> [||L' M s]; [by rewrite /L; ring | | exact: no_relation].
rewrite /frelated tangent_off // tangent_at pfunZ scalerA; congr (_ *: _).
by rewrite factor_value; ring.
Qed.

(** FJ21.5.3 functions_needs_G: likewise for $\tilde\Lambda=t$, $\tilde M=-1-n(1+t)$ and $\tilde\sigma=-\frac1{1+t}$, so that $ng+g(\tilde M)=0$, and the rows $fp'$, $gp$.
    Hypotheses: $n+1\ne0$ in the field. *)
Theorem FJ21_5_3_functions_needs_G n (f := linear 1 1) (M := - (1 + n%:R * (1 + T))) : n.+1%:R != 0 :> F ->
  [/\ n%:R * (1 + T) + (1 + M) = 0, frelated n.+1 (f *: pderiv bent) (f *: bent) T M (- (1 + T)^-1)
    & forall L M' s, ~ frelated n (pderiv bent) bent L M' s].
Proof.
move=> n1; split=> [||L M' s]; [by rewrite /M; ring | | exact: no_relation_back].
rewrite /frelated tangent_off // tangent_at pfunZ scalerA; congr (_ *: _).
have T1 : 1 + T != 0 by rewrite -tofrac1 -tofracD tofrac_eq0 addrC -size_poly_eq0 -polyC1 size_XaddC.
by rewrite factor_value mulrNN expr2 mulrA mulVf // mul1r.
Qed.

(** FJ21.5.4 functions_needs_H: the same rows $fp$ and $fp+f(p'-p)=fp'$ have $H=0$ for $g=f$ and no $\Lambda,M,\sigma$ in degree $n$.
    Hypotheses: $n+1\ne0$ in the field. *)
Theorem FJ21_5_4_functions_needs_H n (f := linear 1 1) (L := - (1 + n%:R * (1 + T))) (s := - (1 + T)) : n.+1%:R != 0 :> F ->
  [/\ 1 + L + n%:R * (1 + T) + s * (1 + T - (1 + T) + n%:R * (1 + T - (1 + T))) = 0,
      frelated n.+1 (f *: bent) (f *: bent + f *: (pderiv bent - bent)) L T s & forall L' M s', ~ frelated n bent (pderiv bent) L' M s'].
Proof.
move=> /FJ21_5_3_functions_needs_H[e rel no]; split=> //; first by rewrite -e /L; ring.
by rewrite -scalerDr addrC subrK.
Qed.

(** FJ21.5.4 functions_needs_G: and $fp'$ and $fp'+f(p-p')=fp$ have $G=0$.
    Hypotheses: $n+1\ne0$ in the field. *)
Theorem FJ21_5_4_functions_needs_G n (f := linear 1 1) (M := - (1 + n%:R * (1 + T))) : n.+1%:R != 0 :> F ->
  [/\ n%:R * (1 + T) + (1 + M) = 0, frelated n.+1 (f *: pderiv bent) (f *: pderiv bent + f *: (bent - pderiv bent)) T M (- (1 + T)^-1)
    & forall L M' s, ~ frelated n (pderiv bent) bent L M' s].
Proof. by move=> /FJ21_5_3_functions_needs_G[e rel no]; split=> //; rewrite -scalerDr addrC subrK. Qed.
End Needs.
