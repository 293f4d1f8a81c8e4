(* FJ07, section 2: cylinders, the direction from surface to net.
   Definitions:
     ends_only v w n i     the rulings v, 0, ..., 0, w of a spline of degree n and two pieces *)
From Torse Require Import Prelude Blossom Curves Points Bernstein Bezier Segments FJ07_2 FJ07_2_cones FJ07_3_generic.

Section Direction.
Variable F : fieldType.
Implicit Types (p q h : {poly F}) (W : 'rV[{poly F}]_3) (v w : 'rV[F]_3) (n i k : nat).

Lemma deriv0 n p : good F n -> (size p <= n.+1)%N -> p^`() = 0 -> p = (p`_0)%:P.
Proof.
move=> nz sz e; apply/polyP=> -[|i]; rewrite coefC //=; have [lt_i|le_i] := ltnP i n; last by apply: (leq_sizeP _ _ sz).
have := congr1 (fun q => q`_i) e; rewrite coef_deriv coef0 -mulr_natr => /eqP.
by rewrite mulf_eq0 (negPf (good_nat (i := i.+1) nz _)) ?orbF // => /eqP.
Qed.

Lemma wronskian n p q : good F n -> (size p <= n.+1)%N -> (size q <= n.+1)%N -> q != 0 -> p^`() * q = p * q^`() -> exists r, p = r *: q.
Proof.
move=> nz sp sq q0 e; pose g := gcdp p q; have g0 : g != 0 by rewrite gcdp_eq0 negb_and q0 orbT.
pose a := p %/ g; pose b := q %/ g.
have [sa sb] : (size a <= n.+1)%N /\ (size b <= n.+1)%N by split; apply: leq_trans (leq_divp _ _) _.
have ep : p = a * g by rewrite divpK // dvdp_gcdl.
have eq : q = b * g by rewrite divpK // dvdp_gcdr.
have b0 : b != 0 by apply: contraNneq q0 => z; rewrite eq z mul0r.
have eab : a^`() * b = a * b^`().
  have gg : g * g != 0 by rewrite mulf_neq0.
  apply: (mulfI gg); apply/eqP; rewrite -subr_eq0; apply/eqP.
  have: p^`() * q - p * q^`() = 0 by rewrite e subrr.
  by rewrite {1 2}ep {1 2}eq !derivM => <-; move: (a^`()) (b^`()) (g^`()) (a) (b) (g) => *; ring.
have co : coprimep b a by rewrite coprimep_sym coprimep_div_gcd // q0 orbT.
have db : b^`() = 0.
  apply/eqP; apply: contraTT (lt_size_deriv b0) => nz'; rewrite -leqNgt; apply: dvdp_leq nz' _.
  by rewrite -(Gauss_dvdpr _ co) -eab dvdp_mull.
have da : a^`() = 0 by apply/eqP; move/eqP: eab; rewrite db mulr0 mulf_eq0 (negPf b0) orbF.
have c0 : b`_0 != 0 by rewrite -polyC_eq0 -(deriv0 nz sb).
exists (a`_0 / b`_0); rewrite ep eq (deriv0 nz sa da) (deriv0 nz sb db) mul_polyC mul_polyC !coefC /= scalerA divfK //.
Qed.

(** FJ07.4 converse: rulings $w(t)$ with $w'$ parallel to $w$ have a constant direction, $w(t)=\lambda(t)v$, on a piece.
    Hypotheses: $n!\ne0$ in the field for the degree $n$ of $w$.
    Paper: does not say that it speaks of one piece. *)
Theorem FJ07_4_converse n W : good F n -> (forall k : 'I_3, (size (W 0%R k) <= n.+1)%N) -> cross W (pderiv W) = 0 -> exists h v, v != 0 /\ W = h *: fixed v.
Proof.
move=> nz sz par; have [W0|W0] := eqVneq W 0.
  exists 0, (vec 1 0 0); rewrite W0 scale0r; split=> //; apply/eqP=> /(congr1 (@x_ _)).
  by rewrite /x_ /vec !mxE => /eqP; rewrite oner_eq0.
have [k k0] : exists k : 'I_3, W 0 k != 0.
  case: (pickP (fun k : 'I_3 => W 0 k != 0)) => [k k0 | z]; first by exists k.
  by case/eqP: W0; apply/rowP=> k; have := z k; rewrite mxE => /negbFE/eqP.
have minor (i j : 'I_3) : (W 0 i)^`() * W 0 j = W 0 i * (W 0 j)^`().
  have [ex ey ez] : [/\ x_ (cross W (pderiv W)) = 0, y_ (cross W (pderiv W)) = 0 & z_ (cross W (pderiv W)) = 0].
    by rewrite par /x_ /y_ /z_ !mxE.
  have ord (l : 'I_3) : [\/ l = @Ordinal 3 0 isT, l = @Ordinal 3 1 isT | l = @Ordinal 3 2 isT].
    by case: l => -[|[|[|//]]] ?; [apply: Or31 | apply: Or32 | apply: Or33]; apply/val_inj.
  move: ex ey ez; coordinates => /eqP; rewrite subr_eq0 => /eqP ex /eqP; rewrite subr_eq0 => /eqP ey /eqP; rewrite subr_eq0 => /eqP ez.
  by case: (ord i) => ->; case: (ord j) => -> //; rewrite mulrC // ?ex ?ey ?ez // -?ex -?ey -?ez // mulrC.
have prop (j : 'I_3) : exists r, W 0 j == r *: W 0 k by have [r ->] := wronskian nz (sz j) (sz k) k0 (minor j k); exists r.
have eq_W : W = W 0 k *: fixed (\row_j xchoose (prop j)).
  by apply/rowP=> j; rewrite !mxE {1}(eqP (xchooseP (prop j))) -mul_polyC mulrC.
exists (W 0 k), (\row_j xchoose (prop j)); split=> //; apply: contraNneq W0 => z.
by rewrite eq_W z; apply/eqP/rowP=> j; rewrite !mxE mulr0.
Qed.

(** FJ07.4 converse_needs_factorial: where $p=0$ in the field the ruling $w=(1,t^p,0)$ has $w'=0$ and no constant direction. *)
Theorem FJ07_4_converse_needs_factorial (p : nat) (W := vec 1 'X^p 0 : 'rV[{poly F}]_3) : (0 < p)%N -> p%:R = 0 :> F ->
  cross W (pderiv W) = 0 /\ forall h v, W <> h *: fixed v.
Proof.
move=> p0 e; split=> [|h v eq_W].
  suff -> : pderiv W = 0 by rewrite -[X in cross _ X](scale0r W) crossZr scale0r.
  apply: row3P; rewrite /x_ /y_ /z_ /W /vec !mxE /= ?derivC //.
  by rewrite derivXn -mulr_natl -(polyC_nat F) e polyC0 mul0r.
have := congr1 (@x_ _) eq_W; have := congr1 (@y_ _) eq_W; rewrite /x_ /y_ /W /vec !mxE /= => ey ex.
have : 'X^p * (x_ v)%:P = (y_ v)%:P by rewrite ey /x_ /y_ mulrAC -ex mul1r.
move/(congr1 (fun q : {poly F} => q`_p)); rewrite coefMC coefXn eqxx mul1r coefC gtn_eqF // => z.
by move/eqP: ex; rewrite -/(x_ v) z polyC0 mulr0 oner_eq0.
Qed.

(** FJ07.4 needs_ruling: a spline of two pieces with the rulings $v,0,\dots,0,w$ is a cylinder along $v$ on the first piece and one along
    $w$ on the second: the ruling at the joint is 0, and the direction turns there. *)
Theorem FJ07_4_needs_ruling n u (c : nat -> 'rV[F]_3) v w (d := fun i => c i + (if i is 0%N then v else if i == n.+1 then w else 0)) :
  [/\ exists h, pcurve n u d - pcurve n u c = h *: fixed v,
      exists h, pcurve n (drop_ 1 u) (drop_ 1 d) - pcurve n (drop_ 1 u) (drop_ 1 c) = h *: fixed w,
      developable (pcurve n u c) (pcurve n u d) &
      developable (pcurve n (drop_ 1 u) (drop_ 1 c)) (pcurve n (drop_ 1 u) (drop_ 1 d))].
Proof.
pose h i : F := (i == 0%N)%:R; pose h' i : F := (i == n)%:R.
have e1 : pcurve n u d = pcurve n u (fun i => c i + h i *: v).
  apply: pcurve_ext => -[|i] le_i; rewrite /d /h /= ?scale1r ?scale0r //.
  by rewrite ifF // eqSS; apply/negbTE; rewrite neq_ltn le_i.
have e2 : pcurve n (drop_ 1 u) (drop_ 1 d) = pcurve n (drop_ 1 u) (fun i => drop_ 1 c i + h' i *: w).
  apply: pcurve_ext => i le_i; rewrite /d /h' /drop_ add1n eqSS; case: eqP => _; by rewrite ?scale1r ?scale0r.
rewrite e1 e2; have [a b] := FJ07_4_cylinder n u c h v; have [a' b'] := FJ07_4_cylinder n (drop_ 1 u) (drop_ 1 c) h' w.
by split=> //; [exists (curve n u h) | exists (curve n (drop_ 1 u) h')].
Qed.
End Direction.
