(* FJ07, section 3, blossoms: equations (9), (12), (19), Theorem 1 and Corollaries 1 and 2.
   Definitions:
     related u n L M c d   c[v_1, ..., v_{n-1}, L*] = d[v_1, ..., v_{n-1}, M*] for all arguments v_i, on one piece *)
From Torse Require Import Prelude Blossom Curves Points FJ07_3_pieces FJ07_3_net.

Section Piece.
Variables (F : fieldType) (m : nat).
Implicit Types (u : nat -> F) (c d : nat -> 'rV[F]_m) (L M t : F) (n : nat).

Definition related u n L M c d := forall v, (size v).+1 = n -> pblossom u c (at_ L :: v) = pblossom u d (at_ M :: v).

Lemma step_cell u n L M c d i : (u (i + n)%N - u i) != 0 ->
  cell u n L M c d i <-> forall k, step u n (at_ L) (coord c k) i = step u n (at_ M) (coord d k) i.
Proof.
move=> nz; rewrite /cell /step /coord /at_ /=; split=> [eq_cd k | eq_cd].
  by have /rowP/(_ k) := eq_cd; rewrite !mxE !mul1r => ->.
apply/rowP=> k; rewrite !mxE; have := eq_cd k; rewrite !mul1r.
by apply: mulIf; rewrite invr_neq0.
Qed.

Lemma span_neq u n i : span n u -> (i < n)%N -> u (i + n)%N - u i != 0.
Proof. by move=> sp lt_i; rewrite -unitfE; apply: sp; lia. Qed.

(** FJ07.T1 piece: on a piece, $c[v_1,\dots,v_{n-1},\Lambda^{*}]=d[v_1,\dots,v_{n-1},M^{*}]$ for all $v_i$ iff equation (13)
    holds for its $n$ cells.
    Hypotheses: the knots carry the piece, so that its points have a meaning. *)
Theorem FJ07_T1_piece u n L M c d : span n u ->
  related u n L M c d <-> forall i, (i < n)%N -> cell u n L M c d i.
Proof.
case: n => [|n] sp; first by split=> // _ v.
have sc i (lt_i : (i < n.+1)%N) := step_cell L M c d (span_neq sp lt_i).
split=> [rel i lt_i | cells v [sz]]; last first.
  apply/rowP=> k; rewrite !mxE /= sz; apply: blossom_ext => i; rewrite sz => le_i.
  exact: (iffLR (sc i le_i) (cells i le_i)).
apply: (iffRL (sc i lt_i)) => k.
apply: (blossoms_injective (span_shift sp)) (lt_i : (i <= n)%N) => v sz.
by have /rowP/(_ k) := rel v (congr1 _ sz); rewrite !mxE /= sz.
Qed.

Lemma cell_drop u n L M c d k i : cell (drop_ k u) n L M (drop_ k c) (drop_ k d) i <-> cell u n L M c d (k + i).
Proof. by rewrite /cell /drop_ addnA addnS. Qed.

(** FJ07.C2 spans: the relation of Theorem 1 holds on every piece of $N$ that is not empty iff equation (13) holds for $i=0..L-1$, $L=n+N-1$.
    Hypotheses: every cell belongs to a piece that is not empty, as when no knot is more than $n$-fold and the first and
    the last piece are not empty; this serves the direction from blossoms to (13) only.
    Paper: does not state it. *)
Theorem FJ07_C2_spans u n L M c d N :
  (forall i, (i < n + N.-1)%N -> exists k, [/\ (k < N)%N, (k <= i < k + n)%N & span n (drop_ k u)]) ->
  (forall k, (k < N)%N -> span n (drop_ k u) -> related (drop_ k u) n L M (drop_ k c) (drop_ k d)) <->
  (forall i, (i < n + N.-1)%N -> cell u n L M c d i).
Proof.
move=> cover; split=> [rel i lt_i | cells k lt_k sp].
  have [k [lt_k le_k sp]] := cover i lt_i.
  have := iffLR (FJ07_T1_piece L M (drop_ k c) (drop_ k d) sp) (rel k lt_k sp) (i - k)%N.
  by rewrite cell_drop subnKC; [apply; lia | lia].
by apply: (iffRL (FJ07_T1_piece L M _ _ sp)) => i lt_i; apply/cell_drop; apply: cells; lia.
Qed.

(* Blossoms that agree for all numbers agree for all polynomials, as they are linear in each argument. *)
Lemma blossom_agree u (g h : nat -> F) v (xs : seq ({poly F} * {poly F})) (up := fun x : F * F => (x.1%:P, x.2%:P)) :
  (forall w, size w = size xs -> blossom u g (v ++ w) = blossom u h (v ++ w)) ->
  blossom (polys u) (polys g) (map up v ++ xs) = blossom (polys u) (polys h) (map up v ++ xs).
Proof.
have constant (s : seq (F * F)) (w c : nat -> F) : blossom (polys w) (polys c) (map up s) = (blossom w c s)%:P.
  elim: s w c => [|x s ih] w c //=; rewrite -(ih (shift w)) size_map; apply: blossom_ext => i _.
  by rewrite /step /polys /= !(polyCM, polyCB, polyCD, =^~ polyCV).
elim: xs v => [|x xs ih] v eq_b; first by have := eq_b [::]; rewrite !cats0 !constant => ->.
have one y : blossom (polys u) (polys g) (map up v ++ up y :: xs) = blossom (polys u) (polys h) (map up v ++ up y :: xs).
  have := ih (rcons v y); rewrite map_rcons !cat_rcons; apply => w sz; rewrite !cat_rcons; apply: eq_b; by rewrite /= sz.
have -> : x = comb x.1 (up (direction _)) x.2 (up (at_ 0)).
  by case: x {eq_b} => a w; rewrite /comb /up /direction /at_ /= !polyC0 !polyC1 !mulr0 !mulr1 addr0 add0r.
by rewrite !blossoms_multilinear !one.
Qed.

(** FJ07.9 curve: on a piece $c+\frac{\Lambda^{*}-t}{n}c'=d+\frac{M^{*}-t}{n}d'$ (here $c'/n$ is the blossom with one direction, so that
    the characteristic of the field does not matter).
    Hypotheses: $n\ge1$; none on the knots, but where they carry no piece the blossoms are mere formulas. *)
Theorem FJ07_9_curve u n L M c d : (0 < n)%N -> related u n L M c d ->
  pcurve n u c + (L%:P - 'X) *: pvelocity n u c = pcurve n u d + (M%:P - 'X) *: pvelocity n u d.
Proof.
case: n => // n _ rel.
have tangent (x : F) (a : nat -> F) : curve n.+1 u a + (x%:P - 'X) * velocity n.+1 u a
    = blossom (polys u) (polys a) (at_ x%:P :: nseq n (at_ 'X)).
  rewrite (_ : at_ x%:P = comb 1 (at_ 'X) (x%:P - 'X) (direction _)); last by rewrite /comb /= !mul1r mulr1 mulr0 addr0 addrC subrK.
  by rewrite (blossoms_multilinear _ _ [::]) mul1r.
apply/rowP=> k; rewrite !mxE !tangent /=.
have first (x : F) (a : nat -> F) i : step (polys u) (size (nseq n (at_ ('X : {poly F})))).+1 (at_ x%:P) (polys a) i
    = polys (step u n.+1 (at_ x) a) i.
  by rewrite size_nseq /step /polys /at_ /= !mul1r !(polyCM, polyCB, polyCD, =^~ polyCV).
rewrite (blossom_ext _ (fun i _ => first L _ i)) (blossom_ext _ (fun i _ => first M _ i)).
apply: (@blossom_agree (shift u) _ _ [::]) => w; rewrite size_nseq => sz.
by have /rowP/(_ k) := rel w (congr1 S sz); rewrite !mxE /= sz.
Qed.

(** FJ07.12 aumann: $(1-\Lambda)C_i+\Lambda C_{i+1}=(1-M)D_i+MD_{i+1}$, $i=0..n-1$, is equation (13) on the knots $0,\dots,0,1,\dots,1$. *)
Theorem FJ07_12_aumann n L M c d i : (i < n)%N ->
  cell (step01 F n) n L M c d i <-> (1 - L) *: c i + L *: c i.+1 = (1 - M) *: d i + M *: d i.+1.
Proof. by move=> lt_i; rewrite /cell /step01 leq_addl leqNgt lt_i subr0 subr0. Qed.

(** FJ07.12 barycentric: equation (12) is $D_{i+1}=(1-\lambda-\mu)C_i+\lambda C_{i+1}+\mu D_i$, $\lambda=\Lambda/M$, $\mu=1-1/M$.
    Hypotheses: $M\ne0$.
    Paper: does not state it. *)
Theorem FJ07_12_barycentric L M c d i (l := L / M) (mu := 1 - M^-1) : M != 0 ->
  (1 - L) *: c i + L *: c i.+1 = (1 - M) *: d i + M *: d i.+1 <->
  d i.+1 = (1 - l - mu) *: c i + l *: c i.+1 + mu *: d i.
Proof.
move=> nz; have -> : d i.+1 = (1 - l - mu) *: c i + l *: c i.+1 + mu *: d i <->
    M *: d i.+1 = M *: ((1 - l - mu) *: c i + l *: c i.+1 + mu *: d i).
  by split=> [->|/(scalerI nz)].
by apply: eq_of_diff; rewrite /l /mu; by_entries k; field.
Qed.

(** FJ07.C1 blossoms: two Bezier curves are related by $c[v_1,\dots,v_{n-1},\Lambda]=d[v_1,\dots,v_{n-1},M]$ iff (12) holds for $i=0..n-1$. *)
Theorem FJ07_C1_blossoms n L M c d : related (step01 F n) n L M c d <->
  forall i, (i < n)%N -> (1 - L) *: c i + L *: c i.+1 = (1 - M) *: d i + M *: d i.+1.
Proof.
rewrite FJ07_T1_piece; last exact: span_step01.
by split=> cells i lt_i; have := cells i lt_i; rewrite FJ07_12_aumann.
Qed.

(** FJ07.C1 cells: (12) makes each cell plane: its four vertices are dependent with coefficients of sum 0. *)
Theorem FJ07_C1_cells L M c d i : (1 - L) *: c i + L *: c i.+1 = (1 - M) *: d i + M *: d i.+1 ->
  exists a : 'rV[F]_4, [/\ a != 0, a 0 0 *: c i + a 0 1 *: c i.+1 + a 0 2%:R *: d i + a 0 3%:R *: d i.+1 = 0 & \sum_k a 0 k = 0].
Proof.
move=> eq_cd; exists (\row_k nth 0 [:: 1 - L; L; M - 1; - M] k); split.
- apply/eqP=> /rowP a0; have := a0 0; have := a0 1; rewrite !mxE /= => -> /eqP.
  by rewrite subr0 oner_eq0.
- rewrite !mxE /= eq_cd; by_entries k; ring.
- by rewrite !big_ord_recl big_ord0 !mxE /=; ring.
Qed.
End Piece.

(** FJ07.T1 developable: the relation of Theorem 1 implies that the surface is developable.
    Hypotheses: the knots carry the piece, so that its points have a meaning. $\Lambda^{*}$ and $M^{*}$ may be any, equal or at knots.
    Paper: "generic"; nothing generic is needed in this direction. *)
Theorem FJ07_T1_developable (F : fieldType) (u : nat -> F) n L M (c d : nat -> 'rV[F]_3) :
  span n u -> related u n L M c d -> developable (pcurve n u c) (pcurve n u d).
Proof.
case: n => [|n] sp rel.
  by rewrite /developable !pderiv_curve // !mulr0n; coordinates; ring.
have := FJ07_9_curve (ltn0Sn n) rel; rewrite /developable !pderiv_curve //.
move: (pcurve _ _ c) (pcurve _ _ d) (pvelocity _ _ c) (pvelocity _ _ d) => C D A B eq_cd.
have {eq_cd} -> : D = C + (L%:P - 'X) *: A - (M%:P - 'X) *: B by rewrite eq_cd addrK.
rewrite -!scaler_nat; coordinates.
by hide_entries; ring.
Qed.
