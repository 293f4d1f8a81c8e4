(* The Bezier net of a piece of a spline by its blossom, and what a curve says of its control points.
   Definitions:
     ends n a b i           the arguments a, ..., a, b, ..., b: n - i times a, i times b
     local_arg a b x        the argument x of the parameter s taken at (1 - s) a + s b
     segment a b n u c i    the blossom value c[a, ..., a, b, ..., b]: the Bezier point i of the piece on [a, b]
     psegment               the same for points *)
From Torse Require Import Prelude Blossom Curves Points Bernstein Bezier.

Lemma map_all (T : eqType) (S : Type) (f : T -> S) (y : S) (s : seq T) : {in s, forall x, f x = y} -> map f s = nseq (size s) y.
Proof.
elim: s => [|x s ih] //= eq_f; rewrite eq_f ?mem_head // ih // => z sz.
by apply: eq_f; rewrite inE sz orbT.
Qed.

Section Arguments.
Variable R : comUnitRingType.
Implicit Types (u c : nat -> R) (a b : R) (x y : R * R) (n i : nat).

Definition ends n a b i := nseq (n - i) (at_ a) ++ nseq i (at_ b).
Definition local_arg a b x : R * R := (x.2 * a + x.1 * (b - a), x.2).
Definition segment a b n u c i := blossom u c (ends n a b i).

Lemma size_ends n a b i : (i <= n)%N -> size (ends n a b i) = n.
Proof. by move=> le_i; rewrite size_cat !size_nseq subnK. Qed.

Lemma local_knots n a b i : (i <= n)%N ->
  [seq local_arg a b x | x <- knots (fun j => (n <= j)%:R : R) i n] = ends n a b i.
Proof.
move=> le_i; have eq_i : iota i n = iota i (n - i) ++ iota n i by rewrite -{1}(subnK le_i) iotaD subnKC.
rewrite /knots eq_i -map_comp map_cat; congr (_ ++ _).
  rewrite -[in RHS](size_iota i (n - i)); apply: map_all => j; rewrite mem_iota subnKC // => /andP[_ lt_j].
  by rewrite /= /local_arg /at_ leqNgt lt_j /=; congr (_, _); ring.
rewrite -[in RHS](size_iota n i); apply: map_all => j; rewrite mem_iota => /andP[le_j _].
by rewrite /= /local_arg /at_ le_j /=; congr (_, _); ring.
Qed.

Lemma local_comb a b s x t y : local_arg a b (comb s x t y) = comb s (local_arg a b x) t (local_arg a b y).
Proof. by rewrite /local_arg /comb /=; congr (_, _); ring. Qed.

Lemma unit_span n : span n (fun j => (n <= j)%:R : R).
Proof. by move=> i j lt_i /andP[le_j _]; rewrite le_j leqNgt lt_i subr0 unitr1. Qed.

Lemma blossom_local n a b u c v : span n u -> size v = n ->
  blossom u c [seq local_arg a b x | x <- v] = blossom (fun j => (n <= j)%:R) (segment a b n u c) v.
Proof.
move=> sp sz; have [sym lin] := blossom_polar c sp.
have pf : polar n (fun w => if size w == n then blossom u c [seq local_arg a b x | x <- w] else 0).
  split=> [w w' eq_w | s x t y w szw].
    rewrite (perm_size eq_w); case: eqP => // szw; have := sym _ _ (perm_map (local_arg a b) eq_w).
    by rewrite !size_map (perm_size eq_w) szw eqxx.
  have := lin s (local_arg a b x) t (local_arg a b y) (map (local_arg a b) w).
  by rewrite /= !size_map szw eqxx -local_comb; apply.
have := blossoms_unique pf (@unit_span n) sz; rewrite sz eqxx => ->.
by apply: blossom_ext => i; rewrite sz => le_i; rewrite size_knots eqxx local_knots.
Qed.
End Arguments.

Section Field.
Variable F : fieldType.
Implicit Types (u c d : nat -> F) (a b s : F) (n i : nat).

(** blossoms segment: with $C_i=c[a^{\langle n-i\rangle},b^{\langle i\rangle}]$ the curve is the Bezier curve of these points on $[a,b]$:
    $c[(1-s_1)a+s_1b,\dots]=C[s_1,\dots]$ for the knots $0,\dots,0,1,\dots,1$.
    Hypotheses: the knots carry the piece, so that its points have a meaning. *)
Theorem blossoms_segment n a b u c (s : seq F) : span n u -> size s = n ->
  blossom u c [seq at_ ((1 - t) * a + t * b) | t <- s] = blossom (step01 F n) (segment a b n u c) [seq at_ t | t <- s].
Proof.
move=> sp sz; rewrite -[RHS](blossom_local a b c sp) ?size_map // -map_comp; congr blossom.
by apply: eq_map => t; rewrite /= /local_arg /at_ /=; congr (_, _); ring.
Qed.

Lemma curve_segment n u c : span n u -> curve n u c = bez n (segment 0 1 n u c).
Proof.
move=> sp; rewrite -bezier_curve {1}/curve.
have {1}-> : nseq n (at_ 'X) = [seq local_arg 0 1 x | x <- nseq n (at_ ('X : {poly F}))].
  by rewrite map_nseq /local_arg /at_ /= mulr0 add0r subr0 mulr1.
rewrite (blossom_local _ _ _ (span_polys sp)) ?size_nseq // /curve.
rewrite (@blossom_ext_knots _ _ (polys (step01 F n))); last by move=> i _; rewrite /polys /step01 polyC_nat.
apply: blossom_ext => i; rewrite size_nseq => le_i; rewrite /polys /segment.
rewrite -[RHS]/([rmorphism of polyC] _) (blossom_morph [rmorphism of polyC]); last by rewrite size_ends.
by congr blossom; rewrite /ends map_cat !map_nseq /= /at_.
Qed.

(** blossoms diagonal: curves that agree at $t,\dots,t$ have the same control points, hence the same blossom.
    Hypotheses: the knots carry the piece, so that its points have a meaning; no binomial coefficient $C(n,i)$ vanishes in the field, as in characteristic 0. *)
Theorem blossoms_diagonal n u c d : independent F n -> span n u ->
  curve n u c = curve n u d -> forall i, (i <= n)%N -> c i = d i.
Proof.
move=> nz sp; rewrite !curve_segment // => /(bez_inj nz) eq_s; apply: (blossoms_injective sp) => v sz.
have arg : v = [seq local_arg 0 1 x | x <- v].
  by rewrite -[LHS]map_id; apply: eq_map => -[x y]; rewrite /local_arg /=; congr (_, _); ring.
rewrite arg !(blossom_local _ _ _ sp) //; apply: blossom_ext => i; rewrite sz; exact: eq_s.
Qed.

(** blossoms needs_binomials: where $C(n,i)=0$ in the field the Bezier curve with $c_i=1$ and all other points 0 is 0. *)
Theorem blossoms_needs_binomials n i : (i <= n)%N -> 'C(n, i)%:R = 0 :> F ->
  curve n (step01 F n) (fun j => (j == i)%:R) = curve n (step01 F n) (fun=> 0).
Proof.
move=> le_i e; rewrite !bezier_curve /bez [RHS]big1 => [|j _]; last by rewrite polyC0 mul0r.
rewrite big1_seq // => j _; have [->|] := eqVneq j i; last by rewrite polyC0 mul0r.
by rewrite /B -(polyC_nat F) e polyC0 mul0r mulr0.
Qed.
End Field.

Section Points.
Variables (F : fieldType) (m : nat).
Implicit Types (u : nat -> F) (c d : nat -> 'rV[F]_m) (a b : F) (n i : nat).

Definition psegment a b n u c i : 'rV[F]_m := pblossom u c (ends n a b i).

Lemma pcurve_inj n u c d : independent F n -> span n u ->
  pcurve n u c = pcurve n u d -> forall i, (i <= n)%N -> c i = d i.
Proof.
move=> nz sp eq_cd i le_i; apply/rowP=> k; have := congr1 (fun r : 'rV_m => r 0 k) eq_cd; rewrite !mxE.
by move/(blossoms_diagonal nz sp)/(_ i le_i).
Qed.
End Points.
