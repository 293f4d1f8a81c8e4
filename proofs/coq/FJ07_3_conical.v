(* FJ07.19 for the nets that have no Lam* and M*: those with proportional sides. *)
From Torse Require Import Prelude Blossom Curves Points Bernstein Bezier Segments FJ07_3_pieces FJ07_2_cones FJ07_3_segments.

Section Constant.
Variable F : fieldType.
Implicit Types (u e : nat -> F) (a b x : F) (n i k : nat).

Lemma blossom_constant u x (s : seq F) : span (size s) u -> blossom u (fun=> x) [seq at_ t | t <- s] = x.
Proof.
elim: s u => [|t s ih] u sp //=; rewrite -[RHS](ih (shift u) (span_shift sp)).
apply: blossom_ext => i; rewrite size_map => le_i; rewrite /step /at_ /= !mul1r -mulrDl addrA subrK mulrC mulKf //.
by rewrite -unitfE; apply: sp; rewrite //= leqnn andbT addnS ltnS leq_addl.
Qed.

Lemma ends_at n a b i : ends n a b i = [seq at_ t | t <- nseq (n - i) a ++ nseq i b].
Proof. by rewrite map_cat !map_nseq. Qed.

Lemma segment_constant n a b u e x : b - a != 0 -> span n u ->
  (forall i, (i <= n)%N -> e i = x) <-> (forall i, (i <= n)%N -> segment a b n u e i = x).
Proof.
move=> ab sp; split=> h i le_i.
  rewrite /segment (@blossom_ext _ _ _ (fun=> x)); last by move=> j; rewrite size_ends // => /h.
  by rewrite ends_at blossom_constant // size_cat !size_nseq subnK.
pose w := [seq at_ ((u j - a) / (b - a)) | j <- iota i n].
have ek : knots u i n = [seq local_arg a b y | y <- w].
  by rewrite /knots -map_comp; apply: eq_map => j; rewrite /local_arg /at_ /= mul1r divfK // addrC subrK.
have sw : size w = n by rewrite size_map size_iota.
rewrite -(blossoms_knots e sp le_i) ek (blossom_local a b e sp sw) (@blossom_ext _ _ _ (fun=> x)); last by move=> j; rewrite sw => /h.
by rewrite /w (map_comp (@at_ F)) blossom_constant // size_map size_iota; exact: span_step01.
Qed.
End Constant.

Section Conical.
Variables (F : fieldType) (m : nat).
Implicit Types (u : nat -> F) (c d : nat -> 'rV[F]_m) (al : F) (n i k : nat).

Lemma proportional_constant al c d K : proportional al c d K <-> forall i, (i <= K)%N -> d i - al *: c i = d 0%N - al *: c 0%N.
Proof.
split=> [h|h i lt_i]; last first.
  transitivity ((d i.+1 - al *: c i.+1) - (d i - al *: c i) + al *: (c i.+1 - c i)); first by by_entries j; ring.
  by rewrite (h _ lt_i) (h _ (ltnW lt_i)) subrr add0r.
elim=> [//|i ih] lt_i; rewrite -(ih (ltnW lt_i)); have := h i lt_i => e.
by rewrite -[d i.+1](subrK (d i)) e; by_entries j; ring.
Qed.

(** FJ07.19 cone: a piece of the spline has proportional sides, $d_{i+1}-d_i=\alpha(c_{i+1}-c_i)$, iff its Bezier net has, with the same $\alpha$:
    equation (12) with $\lambda=\alpha$ and $\mu=1$, where there are no $\Lambda_k$ and $M_k$.
    Hypotheses: the knots carry the piece, so that its points have a meaning.
    Paper: says that (18) holds for cones too, and gives the Bezier nets by $\Lambda_k$, $M_k$ only. *)
Theorem FJ07_19_cone u n k al c d (C := bezier_net u n k c) (D := bezier_net u n k d) : span n.+1 (drop_ k u) ->
  proportional al (drop_ k c) (drop_ k d) n.+1 <-> proportional al C D n.+1.
Proof.
move=> sp; have ab : u (n + k).+1 - u (n + k)%N != 0 := piece_len sp.
have lin i j : D i 0 j - al * C i 0 j
    = segment (u (n + k)%N) (u (n + k).+1) n.+1 (drop_ k u) (fun l => drop_ k d l 0 j - al * drop_ k c l 0 j) i.
  rewrite /C /D /bezier_net !mxE /segment -[blossom _ (coord (drop_ k d) j) _]mul1r -mulNr -blossom_linear.
  by apply: blossom_ext => l _; rewrite mul1r mulNr.
have sub (r s : nat -> 'rV[F]_m) i j : (r i - al *: s i) 0 j = r i 0 j - al * s i 0 j by rewrite !mxE.
rewrite !proportional_constant; split=> h i le_i; apply/rowP=> j.
  have e l : (l <= n.+1)%N -> (fun l => drop_ k d l 0 j - al * drop_ k c l 0 j) l = drop_ k d 0%N 0 j - al * drop_ k c 0%N 0 j.
    by move=> /h/rowP/(_ j); rewrite !sub.
  have s := (segment_constant _ _ ab sp).1 e.
  by rewrite !sub !lin !s.
have e l : (l <= n.+1)%N -> segment (u (n + k)%N) (u (n + k).+1) n.+1 (drop_ k u) (fun l => drop_ k d l 0 j - al * drop_ k c l 0 j) l
    = D 0%N 0 j - al * C 0%N 0 j.
  by move=> /h/rowP/(_ j); rewrite -lin !sub.
have s := (segment_constant _ _ ab sp).2 e.
by have := s i le_i; have := s 0%N isT => /= e0 ei; rewrite !sub ei e0.
Qed.

Lemma pblossom_combination u c d s t v : pblossom u (fun i => s *: c i + t *: d i) v = s *: pblossom u c v + t *: pblossom u d v.
Proof.
apply/rowP=> k; rewrite !mxE -blossom_linear.
by apply: blossom_ext => i _; rewrite /coord !mxE.
Qed.

Lemma pblossom_constant u (x : 'rV[F]_m) s : span (size s) u -> pblossom u (fun=> x) [seq at_ t | t <- s] = x.
Proof. by move=> sp; apply/rowP=> k; rewrite mxE /coord blossom_constant. Qed.

(** FJ07.T1 cone_blossoms: in the place of the relation a cone has $\alpha\,(c[v_1,\dots,v_{n-1},b]-c[v_1,\dots,v_{n-1},a])=d[v_1,\dots,v_{n-1},b]-d[v_1,\dots,v_{n-1},a]$ for all
    parameters $v_i$, $a$, $b$: so it has iff the sides are proportional, $d_{i+1}-d_i=\alpha(c_{i+1}-c_i)$.
    Hypotheses: the knots carry the piece, so that its points have a meaning.
    Paper: has $a$ and $b$ at the ends of the piece. *)
Theorem FJ07_T1_cone_blossoms u al n c d : span n.+1 u ->
  (forall v a b, size v = n -> al *: (pblossom u c [seq at_ t | t <- rcons v b] - pblossom u c [seq at_ t | t <- rcons v a])
    = pblossom u d [seq at_ t | t <- rcons v b] - pblossom u d [seq at_ t | t <- rcons v a]) <-> proportional al c d n.+1.
Proof.
move=> sp; rewrite proportional_constant; pose e i := 1 *: d i + (- al) *: c i.
have eE i : e i = d i - al *: c i by rewrite /e scale1r scaleNr.
have parts w : pblossom u e w = pblossom u d w - al *: pblossom u c w by rewrite pblossom_combination scale1r scaleNr.
have flat : (forall i, (i <= n.+1)%N -> e i = e 0%N) <->
    (forall v a b, size v = n -> pblossom u e [seq at_ t | t <- rcons v b] = pblossom u e [seq at_ t | t <- rcons v a]).
  split=> [h v a b sz|h].
    have all s : size s = n.+1 -> pblossom u e [seq at_ t | t <- s] = e 0%N.
      move=> szs; rewrite -[RHS](@pblossom_constant u _ s) ?szs //; apply/rowP=> k; rewrite !mxE.
      by apply: blossom_ext => i; rewrite size_map szs => /h; rewrite /coord => ->.
    by rewrite !all ?size_rcons ?sz.
  have at_knots i : (i <= n.+1)%N -> e i = pblossom u e [seq at_ t | t <- [seq u j | j <- iota i n.+1]].
    by move=> le_i; apply/rowP=> k; rewrite [RHS]mxE -map_comp -[RHS]/(blossom u (coord e k) (knots u i n.+1)) blossoms_knots.
  elim=> // i ih lt_i; rewrite -(ih (ltnW lt_i)) (at_knots i.+1) // (at_knots i) ?(ltnW lt_i) //.
  have -> : iota i.+1 n.+1 = rcons (iota i.+1 n) (i.+1 + n)%N by rewrite -cats1 -[n.+1]addn1 iotaD.
  rewrite map_rcons (h _ (u i)) ?size_map ?size_iota //; apply/rowP=> k; rewrite !mxE; apply: blossoms_symmetric.
    by rewrite !size_map size_rcons size_map size_iota.
  by apply: perm_map; rewrite /= perm_rcons.
have -> : (forall i, (i <= n.+1)%N -> d i - al *: c i = d 0%N - al *: c 0%N) <-> (forall i, (i <= n.+1)%N -> e i = e 0%N).
  by split=> h i /h; rewrite !eE.
rewrite flat; split=> h v a b sz; have := h v a b sz; rewrite ?parts => e'; apply/eqP; rewrite -subr_eq0.
  by apply/eqP; move/eqP: e'; rewrite -subr_eq0 => /eqP e'; rewrite -oppr0 -{}e'; by_entries k; ring.
by apply/eqP; move/eqP: e'; rewrite -subr_eq0 => /eqP e'; rewrite -oppr0 -{}e'; by_entries k; ring.
Qed.
End Conical.
