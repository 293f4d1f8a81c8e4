(* BZZ19, section 4: Algorithm 1, from splines to Bezier pieces and back, equations (10) to (13) and (16).
   Definitions:
     line a b              the polynomial a + (b - a) X, which takes [0, 1] to [a, b]
     stretched s a b       the mapping of a piece, (s(a + (b-a) X) - s(a)) / (s(b) - s(a)), equation (13)
     joined D x i          the knots x_0, ..., x_0, x_1, ..., x_1, ..., each D times
     ruled_surface c d sigma s t   the point (1-s) c(t) + s d(sigma(t)) of equation (10) *)
From Torse Require Import Prelude Blossom Curves Points Bernstein Bezier Segments BZZ19_3 FJ21_4.

Section Pieces.
Variable F : fieldType.
Implicit Types (u c x : nat -> F) (a b t : F) (sigma f : {poly F}) (n D k i : nat).

Definition line a b : {poly F} := a%:P + (b - a)%:P * 'X.

Lemma line_at a b t : (line a b).[t] = a + (b - a) * t.
Proof. by rewrite /line hornerD hornerM !hornerC hornerX. Qed.

(* The de Casteljau form of the piece: substitution of a line for the parameter. *)
Lemma blossom_comp n u c f : span n u ->
  (curve n u c) \Po f = blossom (polys u) (polys c) (nseq n (at_ f)).
Proof.
move=> sp; rewrite -[LHS]/(comp_poly f (curve n u c)) /curve.
rewrite (blossom_morph [rmorphism of comp_poly f]); last by rewrite size_nseq; apply: span_polys.
rewrite map_nseq /= comp_polyX comp_polyC.
rewrite (@blossom_ext_knots _ _ (polys u)); last by move=> i _ /=; rewrite comp_polyC.
by apply: blossom_ext => i _ /=; rewrite comp_polyC.
Qed.

(** BZZ19.11 piece: on a piece the polynomial $\hat\sigma(\hat t)=\sigma(a+(b-a)\hat t)$ has the Bernstein coefficients
    $P_i=\sigma[a^{\langle d-i\rangle},b^{\langle i\rangle}]$, those of $d$-fold knots at $a$ and $b$; so have the pieces of the curves.
    Hypotheses: the knots carry the piece, so that its points have a meaning. *)
Theorem BZZ19_11_piece n u c a b : span n u -> (curve n u c) \Po (line a b) = bez n (segment a b n u c).
Proof.
move=> sp; rewrite blossom_comp // -bezier_curve {1}/curve.
have {1}-> : nseq n (at_ (line a b)) = [seq local_arg a%:P b%:P z | z <- nseq n (at_ ('X : {poly F}))].
  by rewrite map_nseq /local_arg /at_ /line /= polyCB mul1r mulrC.
rewrite (blossom_local _ _ _ (span_polys sp)) ?size_nseq // /curve.
rewrite (@blossom_ext_knots _ _ (polys (step01 F n))); last by move=> i _; rewrite /polys /step01 polyC_nat.
apply: blossom_ext => i; rewrite size_nseq => le_i; rewrite /polys /segment.
rewrite -[RHS]/([rmorphism of polyC] _) (blossom_morph [rmorphism of polyC]); last by rewrite size_ends.
by congr blossom; rewrite /ends map_cat !map_nseq /= /at_.
Qed.

(** BZZ19.12 parameter: $\hat\sigma(\frac{t-a}{b-a})=\sigma(t)$.
    Hypotheses: $a\ne b$, so that the quotient has a meaning. *)
Theorem BZZ19_12_parameter sigma a b t : b - a != 0 -> (sigma \Po line a b).[(t - a) / (b - a)] = sigma.[t].
Proof. by move=> nz; rewrite horner_comp line_at mulrC divfK // addrC subrK. Qed.

(** BZZ19.12 needs_length: on an empty piece $a=b$ the polynomial $\hat\sigma$ is the constant $\sigma(a)$. *)
Theorem BZZ19_12_needs_length sigma a t : (sigma \Po line a a).[t] = sigma.[a].
Proof. by rewrite horner_comp line_at subrr mul0r addr0. Qed.

Definition stretched sigma a b : {poly F} := (sigma.[b] - sigma.[a])^-1%:P * (sigma \Po line a b - sigma.[a]%:P).

(** BZZ19.13 piece: with $\hat T=\frac{\hat\sigma(\hat t)-\sigma(a)}{\sigma(b)-\sigma(a)}$ the piece $\hat C_2(\hat T)=C_2(\sigma(a)+(\sigma(b)-\sigma(a))\hat T)$
    gives $\hat C_2(\hat T(\hat t))=C_2(\sigma(a+(b-a)\hat t))$, and $\hat T$ takes 0 to 0 and 1 to 1.
    Hypotheses: $\sigma(a)\ne\sigma(b)$.
    Paper: does not state it; its mappings may be constant on a piece. *)
Theorem BZZ19_13_piece f sigma a b : sigma.[b] - sigma.[a] != 0 ->
  [/\ (f \Po line sigma.[a] sigma.[b]) \Po stretched sigma a b = (f \Po sigma) \Po line a b,
      (stretched sigma a b).[0] = 0 & (stretched sigma a b).[1] = 1].
Proof.
move=> nz; split; last 2 first.
- by rewrite hornerM hornerD hornerN !hornerC horner_comp line_at mulr0 addr0 subrr mulr0.
- by rewrite hornerM hornerD hornerN !hornerC horner_comp line_at (_ : a + (b - a) * 1 = b) ?mulVf //; ring.
rewrite -!comp_polyA; congr (_ \Po _); rewrite {1}/line comp_polyD comp_polyM !comp_polyC comp_polyX /stretched.
by rewrite mulrA -polyCM mulfV // mul1r addrC subrK.
Qed.

(** BZZ19.13 needs_step: where $\sigma(a)=\sigma(b)$ and $\sigma$ is not constant between no $\hat T$ will do: $\sigma=t(1-t)$ on $[0,1]$, $C_2=(T)$. *)
Theorem BZZ19_13_needs_step (sigma := 'X * (1 - 'X) : {poly F}) (f := 'X : {poly F}) :
  sigma.[0] = sigma.[1] /\ forall T, (f \Po line sigma.[0] sigma.[1]) \Po T <> (f \Po sigma) \Po line 0 1.
Proof.
have [s0 s1] : sigma.[0] = 0 /\ sigma.[1] = 0 by rewrite /sigma; split; rewrite !hornerE ?subrr ?mulr0.
rewrite s0 s1; split=> // T; have -> : line 0 1 = 'X by rewrite /line subr0 polyC0 polyC1 mul1r add0r.
rewrite /line subrr polyC0 mul0r addr0 /f !comp_polyX comp_polyXr comp_poly0 => /esym/eqP.
by rewrite /sigma mulf_eq0 polyX_eq0 -opprB oppr_eq0 -polyC1 polyXsubC_eq0.
Qed.

Definition joined D x i : F := x (i %/ D)%N.

(** BZZ19.16 joined: pieces of degree $D$ whose ends meet, $P^{j}_D=P^{j+1}_0$, are one spline with the points $P_{jD+i}=P^j_i$ over the knots
    $x_0,x_1,\dots$, each $D$ times: on $[x_j,x_{j+1}]$ it is the Bezier curve of $P^j_0,\dots,P^j_D$.
    Hypotheses: $x_j\ne x_{j+1}$, so that its points have a meaning; $D\ge1$. *)
Theorem BZZ19_16_joined D x c j (u := joined D.+1 x) : x j.+1 - x j != 0 ->
  (curve D.+1 (drop_ (j * D.+1) u) (drop_ (j * D.+1) c)) \Po line (x j) (x j.+1) = bez D.+1 (drop_ (j * D.+1) c).
Proof.
move=> nz; set v := drop_ _ u; have lo i : (i < D.+1)%N -> v i = x j.
  by move=> lt_i; rewrite /v /drop_ /u /joined divnMDl // divn_small // addn0.
have hi i : (D.+1 <= i < D.+1.*2)%N -> v i = x j.+1.
  move=> /andP[le_i lt_i]; rewrite /v /drop_ /u /joined divnMDl // -(subnK le_i) divnDr // divnn /= divn_small ?add0n ?addn1 //.
  by rewrite -(ltn_add2r D.+1) subnK // addnn.
have sp : span D.+1 v by move=> i k lt_i le_k; rewrite unitfE (lo i) // (hi k) //; lia.
rewrite BZZ19_11_piece //; apply: bez_ext => i le_i; rewrite -[RHS](blossoms_knots _ sp le_i) /segment /ends.
congr blossom; have eq_i : iota i D.+1 = iota i (D.+1 - i) ++ iota D.+1 i by rewrite -{1}(subnK le_i) iotaD subnKC.
rewrite /knots eq_i map_cat; congr (_ ++ _); apply/esym.
  by rewrite (map_all (y := at_ (x j))) ?size_iota // => k; rewrite mem_iota subnKC // => /andP[_ lt_k]; rewrite lo.
by rewrite (map_all (y := at_ (x j.+1))) ?size_iota // => k; rewrite mem_iota => /andP[le_k lt_k]; rewrite hi //; lia.
Qed.

End Pieces.

Section Surface.
Variables (F : fieldType).
Implicit Types (c d : 'rV[{poly F}]_3) (sigma : {poly F}) (s t : F).

Definition ruled_surface c d sigma s t := (1 - s) *: ev c t + s *: ev (after d sigma) t.

(** BZZ19.10 rails: the surface (10) is bounded by $C_1$ and by points of $C_2$: $S(0,t)=C_1(t)$, $S(1,t)=C_2(\sigma(t))$. *)
Theorem BZZ19_10_rails c d sigma t :
  ruled_surface c d sigma 0 t = ev c t /\ ruled_surface c d sigma 1 t = ev d sigma.[t].
Proof.
rewrite /ruled_surface subr0 subrr !scale0r !scale1r addr0 add0r; split=> //.
by apply/rowP=> k; rewrite !mxE horner_comp.
Qed.
End Surface.
