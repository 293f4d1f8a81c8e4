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
End Conical.
