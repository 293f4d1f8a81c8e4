(* FJ07, section 3, piece by piece: equation (19), the Bezier nets of the pieces of a spline, and all pieces at once. *)
From Torse Require Import Prelude Blossom Curves Points Bernstein Bezier Segments FJ07_3_pieces FJ07_3_net FJ07_3_blossoms.

Section Piece.
Variables (F : fieldType) (m : nat).
Implicit Types (u : nat -> F) (c d : nat -> 'rV[F]_m) (a b L M : F) (n i k : nat).

Lemma pblossom_local n a b u c v : span n u -> size v = n ->
  pblossom u c [seq local_arg a b x | x <- v] = pblossom (step01 F n) (psegment a b n u c) v.
Proof.
move=> sp sz; apply/rowP=> k; rewrite !mxE (blossom_local a b (coord c k) sp sz).
by apply: blossom_ext => i _; rewrite /coord mxE.
Qed.

Lemma related_local n a b u L M c d : b - a != 0 -> span n u ->
  related u n (a + L * (b - a)) (a + M * (b - a)) c d <-> related (step01 F n) n L M (psegment a b n u c) (psegment a b n u d).
Proof.
move=> nz sp; have arg x : at_ (a + x * (b - a)) = local_arg a b (at_ x) by rewrite /local_arg /= mul1r.
rewrite /related; split=> rel v sz; rewrite ?arg.
  have sz' x : size (at_ x :: v) = n by rewrite /= sz.
  rewrite -!(pblossom_local a b _ sp (sz' _)) !map_cons -!arg; apply: rel.
  by rewrite size_map.
pose w := [seq ((x.1 - x.2 * a) / (b - a), x.2) | x <- v].
have -> : v = [seq local_arg a b x | x <- w].
  rewrite -map_comp -[LHS]map_id; apply: eq_map => -[x y]; rewrite /local_arg /=; congr (_, _).
  by rewrite divfK // addrC subrK.
have szw : (size w).+1 = n by rewrite size_map.
have sz' x : size (at_ x :: w) = n by rewrite /= szw.
by rewrite -!map_cons !(pblossom_local a b _ sp (sz' _)); apply: rel.
Qed.

(* n is one less than the degree, as for local: piece k is [u_{n+k}, u_{n+k+1}]. *)
Definition bezier_net u n k c := psegment (u (n + k)%N) (u (n + k).+1) n.+1 (drop_ k u) (drop_ k c).

Lemma piece_len n k u : span n.+1 (drop_ k u) -> len u n k != 0.
Proof.
move=> sp; rewrite /len -unitfE; have -> : u (n + k).+1 - u (n + k)%N = drop_ k u n.+1 - drop_ k u n by rewrite /drop_ addnC addnS.
by apply: sp; lia.
Qed.

(** FJ07.19 net: with $C_i=c[a^{\langle n-i\rangle},b^{\langle i\rangle}]$ on the piece $[a,b]=[u_{n+k-2},u_{n+k-1}]$ the relation of Theorem 1
    holds on piece $k$ iff $(1-\Lambda_k)C_i+\Lambda_kC_{i+1}=(1-M_k)D_i+M_kD_{i+1}$, $i=0..n-1$.
    Hypotheses: the knots carry the piece, so that its points have a meaning. *)
Theorem FJ07_19_net u n k L M c d (C := bezier_net u n k c) (D := bezier_net u n k d)
    (Lam := local u n k L) (Mu := local u n k M) : span n.+1 (drop_ k u) ->
  related (drop_ k u) n.+1 L M (drop_ k c) (drop_ k d) <->
  forall i, (i < n.+1)%N -> (1 - Lam) *: C i + Lam *: C i.+1 = (1 - Mu) *: D i + Mu *: D i.+1.
Proof.
move=> sp; have nz := piece_len sp; rewrite -FJ07_C1_blossoms.
have star x : x = u (n + k)%N + local u n k x * (u (n + k).+1 - u (n + k)%N).
  by rewrite -/(len u n k) /local divfK // addrC subrK.
by rewrite {1}(star L) {1}(star M); apply: related_local.
Qed.

(** FJ07.19 cells: the Bezier net of piece $k$ of the spline of (13) obeys (12) with $\Lambda_k$, $M_k$, and conversely.
    Hypotheses: the knots carry the piece, so that its points have a meaning. *)
Theorem FJ07_19_cells u n k L M c d (C := bezier_net u n k c) (D := bezier_net u n k d)
    (Lam := local u n k L) (Mu := local u n k M) : span n.+1 (drop_ k u) ->
  (forall i, (i < n.+1)%N -> cell u n.+1 L M c d (k + i)) <->
  (forall i, (i < n.+1)%N -> (1 - Lam) *: C i + Lam *: C i.+1 = (1 - Mu) *: D i + Mu *: D i.+1).
Proof.
move=> sp; rewrite -FJ07_19_net // FJ07_T1_piece //.
by split=> cells i lt_i; have := cells i lt_i; rewrite cell_drop.
Qed.

(** FJ07.19 ends: $C_0=c(a)$ and $C_n=c(b)$: neighbouring pieces have a point in common.
    Hypotheses: the knots carry the piece, so that its points have a meaning. *)
Theorem FJ07_19_ends u n k c : span n.+1 (drop_ k u) ->
  (forall j, (bezier_net u n k c 0%N) 0 j = (curve n.+1 (drop_ k u) (coord (drop_ k c) j)).[u (n + k)%N]) /\
  (forall j, (bezier_net u n k c n.+1) 0 j = (curve n.+1 (drop_ k u) (coord (drop_ k c) j)).[u (n + k).+1]).
Proof.
by move=> sp; split=> j; rewrite horner_curve // mxE /ends ?subn0 ?subnn ?cats0.
Qed.
End Piece.

Section Surface.
Variable F : fieldType.
Implicit Types (u : nat -> F) (c d : nat -> 'rV[F]_3) (L M : F) (n N k i : nat).

(** FJ07.C2 developable: a net that obeys (13), $i=0..L-1$, spans a developable surface over each of its $N$ pieces.
    Hypotheses: none, the pieces without length apart. *)
Theorem FJ07_C2_developable u n L M c d N : (forall i, (i < n + N.-1)%N -> cell u n L M c d i) ->
  forall k, (k < N)%N -> span n (drop_ k u) -> developable (pcurve n (drop_ k u) (drop_ k c)) (pcurve n (drop_ k u) (drop_ k d)).
Proof.
move=> cells k lt_k sp; apply: (FJ07_T1_developable sp (L := L) (M := M)); apply/FJ07_T1_piece => // i lt_i.
by apply/cell_drop/cells; lia.
Qed.

(** FJ07.13 developable: so does the row of the construction, for every $c$, $d_0$, $\Lambda^{*}$, $M^{*}$.
    Hypotheses: $M^{*}$ is none of $u_0,\dots,u_{L-1}$, so that the row has a meaning. *)
Theorem FJ07_13_developable u n L M c (d0 : 'rV[F]_3) N (d := net u n L M c d0) : (forall i, (i < n + N.-1)%N -> M - u i != 0) ->
  forall k, (k < N)%N -> span n (drop_ k u) -> developable (pcurve n (drop_ k u) (drop_ k c)) (pcurve n (drop_ k u) (drop_ k d)).
Proof. by move=> off; apply: (FJ07_C2_developable (L := L) (M := M)); case: (FJ07_13_exists n L c d0 off). Qed.
End Surface.
