(* FJ07, section 3, the five free parameters of (13): a net is determined by any one vertex, or by the first two. *)
From Torse Require Import Prelude Blossom Curves Points FJ07_3_net FJ07_3_blossoms FJ07_3_cells FJ21_4.

Section Vertices.
Variables (F : fieldType) (m : nat).
Implicit Types (u : nat -> F) (c d : nat -> 'rV[F]_m) (x : 'rV[F]_m) (L M : F) (n i j K : nat).

(** FJ07.13 backward: a cell gives $d_i$ from $d_{i+1}$: $(M^{*}-u_{i+n})d_i=(M^{*}-u_i)d_{i+1}-(u_{i+n}-\Lambda^{*})c_i-(\Lambda^{*}-u_i)c_{i+1}$. *)
Theorem FJ07_13_backward u n L M c d i : cell u n L M c d i <->
  (M - u (i + n)%N) *: d i = (M - u i) *: d i.+1 - (u (i + n)%N - L) *: c i - (L - u i) *: c i.+1.
Proof.
have sym (a b : 'rV[F]_m) : a = b <-> b = a by split.
by rewrite [X in _ <-> X]sym /cell; apply: eq_of_diff; by_entries k; ring.
Qed.

Lemma cell_tail u n L M c d r i : cell (drop_ r u) n L M (drop_ r c) d i <->
  (u (r + i + n)%N - L) *: c (r + i)%N + (L - u (r + i)%N) *: c (r + i).+1 = (u (r + i + n)%N - M) *: d i + (M - u (r + i)%N) *: d i.+1.
Proof. by rewrite /cell /drop_ addnA addnS. Qed.

(** FJ07.13 vertex: for every $c$, $\Lambda^{*}$, $M^{*}$ and every point $x$ there is a row with $d_j=x$ that obeys (13).
    Hypotheses: $M^{*}$ is none of the knots $u_j,\dots,u_{L-1}$ after the vertex, nor of the $u_n,\dots,u_{j+n-1}$ before it. *)
Theorem FJ07_13_vertex u n L M c x j K : (j <= K)%N -> (forall i, (j <= i < K)%N -> M - u i != 0) ->
  (forall i, (i < j)%N -> M - u (i + n)%N != 0) -> exists d, d j = x /\ forall i, (i < K)%N -> cell u n L M c d i.
Proof.
elim: j x K => [|j ih] x K le_j after before; first by exists (net u n L M c x); exact: FJ07_13_exists.
pose y := (M - u (j + n)%N)^-1 *: ((M - u j) *: x - (u (j + n)%N - L) *: c j - (L - u j) *: c j.+1).
have [||| d' [ey cells']] := ih y j; rewrite ?leqnn //.
- by move=> i /andP[le_i lt_i]; lia.
- by move=> i lt_i; apply: before; lia.
pose d i := if (i <= j)%N then d' i else net (drop_ j.+1 u) n L M (drop_ j.+1 c) x (i - j.+1).
exists d; split; first by rewrite /d ltnn subnn.
move=> i lt_i; case: (ltngtP i j) => [lt_ij|gt_ij|->].
- by have := cells' i lt_ij; rewrite /cell /d (ltnW lt_ij) lt_ij.
- have off r : (r < K - j.+1)%N -> M - drop_ j.+1 u r != 0 by move=> lt_r; apply: after; lia.
  have [_ h] := FJ07_13_exists n L (drop_ j.+1 c) x off; have lt_r : (i - j.+1 < K - j.+1)%N by lia.
  have := h _ lt_r; rewrite cell_tail subnKC // /cell /d ![(_ <= j)%N]leqNgt gt_ij ltnS (ltnW gt_ij) /=.
  by rewrite subSn.
apply/FJ07_13_backward; rewrite /d leqnn ltnn subnn /= ey /y scalerA mulfV ?scale1r //.
by apply: before.
Qed.

(** FJ07.13 needs_before: at $M^{*}=u_{i+n}$ the cell $i$ does not determine $d_i$ and binds $d_{i+1}$. *)
Theorem FJ07_13_needs_before u n L c d i : cell u n L (u (i + n)%N) c d i <->
  (u (i + n)%N - L) *: c i + (L - u i) *: c i.+1 = (u (i + n)%N - u i) *: d i.+1.
Proof. by rewrite /cell subrr scale0r add0r. Qed.

(** FJ07.13 vertex_unique: there is no other row with this $d_j$.
    Hypotheses: as before. *)
Theorem FJ07_13_vertex_unique u n L M c d d' j K : (j <= K)%N -> (forall i, (j <= i < K)%N -> M - u i != 0) ->
  (forall i, (i < j)%N -> M - u (i + n)%N != 0) -> (forall i, (i < K)%N -> cell u n L M c d i) ->
  (forall i, (i < K)%N -> cell u n L M c d' i) -> d j = d' j -> forall i, (i <= K)%N -> d i = d' i.
Proof.
move=> le_j after before cells cells' ej.
have down r : (r <= j)%N -> d (j - r)%N = d' (j - r)%N.
  elim: r => [|r ih] lt_r; first by rewrite subn0.
  have lt_K : (j - r.+1 < K)%N by lia.
  have := cells _ lt_K; have := cells' _ lt_K; rewrite !FJ07_13_backward -subSn // subSS ih 1?ltnW // => <- /scalerI; apply.
  by apply: before; lia.
move=> i le_i; have [lt_i|le_ji] := leqP i j; first by rewrite -(subKn lt_i) down // leq_subr.
suff up r : (r + j <= K)%N -> d (r + j)%N = d' (r + j)%N by rewrite -(subnK (ltnW le_ji)) up // subnK // ltnW.
elim: r => [//|r ih] lt_K; rewrite addSn.
have := cells _ lt_K; have := cells' _ lt_K; rewrite /cell ih 1?ltnW // => -> /addrI/scalerI e.
have nz : M - u (r + j)%N != 0 by apply: after; rewrite leq_addl.
exact/esym/(e nz).
Qed.

(** FJ07.13.rulings vertex: the net of (13) computed from any of its vertices $d_j$, ruling by ruling: for $w_i=d_i-c_i$ a row obeys (13) iff
    $w_{i+1}=\frac{(M^{*}-u_{i+n})w_i+(\Lambda^{*}-M^{*})(c_{i+1}-c_i)}{M^{*}-u_i}$ after the vertex and
    $w_i=\frac{(M^{*}-u_i)w_{i+1}-(\Lambda^{*}-M^{*})(c_{i+1}-c_i)}{M^{*}-u_{i+n}}$ before it.
    Hypotheses: $M^{*}$ is none of the knots $u_j,\dots,u_{L-1}$ after the vertex, nor of the $u_n,\dots,u_{j+n-1}$ before it. *)
Theorem FJ07_13_rulings_vertex u n L M c d j K : (j <= K)%N -> (forall i, (j <= i < K)%N -> M - u i != 0) ->
  (forall i, (i < j)%N -> M - u (i + n)%N != 0) ->
  (forall i, (i < K)%N -> cell u n L M c d i) <->
  (forall i, (j <= i < K)%N ->
    d i.+1 - c i.+1 = (M - u i)^-1 *: ((M - u (i + n)%N) *: (d i - c i) + (L - M) *: (c i.+1 - c i))) /\
  (forall i, (i < j)%N ->
    d i - c i = (M - u (i + n)%N)^-1 *: ((M - u i) *: (d i.+1 - c i.+1) - (L - M) *: (c i.+1 - c i))).
Proof.
move=> le_j after before; have part (x : F) (a b : 'rV[F]_m) : x != 0 -> x *: a = b <-> a = x^-1 *: b.
  by move=> nz; split=> [<-|->]; rewrite scalerA ?mulVf ?mulfV ?scale1r.
have back i : cell u n L M c d i <-> (M - u (i + n)%N) *: (d i - c i) = (M - u i) *: (d i.+1 - c i.+1) - (L - M) *: (c i.+1 - c i).
  by rewrite FJ07_13_rulings; split=> [->|->]; rewrite ?addrK ?subrK.
split=> [cells|[forth down] i lt_i]; last first.
  have [lt_ij|le_ji] := ltnP i j; first by apply/back/part; [exact: before | exact: down].
  by apply/FJ07_13_rulings/part; [apply: after | apply: forth]; rewrite le_ji.
split=> i; first by case/andP=> le_i lt_i; apply/part; [apply: after; rewrite le_i | apply/FJ07_13_rulings/cells].
by move=> lt_i; apply/part; [exact: before | apply/back/cells; exact: leq_trans lt_i le_j].
Qed.

(** FJ07.13 two: the first two vertices determine $\Lambda^{*}$ and $M^{*}$: for $d_1=(1-l-\mu)c_0+lc_1+\mu d_0$ they are
    $M^{*}=\frac{u_n-\mu u_0}{1-\mu}$, $\Lambda^{*}=u_0+l(M^{*}-u_0)$.
    Hypotheses: $\mu\ne1$, $u_n\ne u_0$.
    Paper: "the first two vertices", of a plane cell that is not a cone's. *)
Theorem FJ07_13_two u n c d l mu (M := (u n - mu * u 0%N) / (1 - mu)) (L := u 0%N + l * (M - u 0%N)) : 1 - mu != 0 -> u n - u 0%N != 0 ->
  M - u 0%N != 0 /\ (bary l mu c d 0 <-> cell u n L M c d 0).
Proof.
move=> m1 w; have eM : M - u 0%N = (u n - u 0%N) / (1 - mu) by rewrite /M; field.
have nz : M - u 0%N != 0 by rewrite eM mulf_neq0 ?invr_neq0.
split=> //; rewrite FJ07_18_cell // add0n.
have -> : (L - u 0%N) / (M - u 0%N) = l by rewrite /L addrAC subrr add0r mulfK.
have -> : (M - u n) / (M - u 0%N) = mu by rewrite eM /M; field; rewrite m1 w.
by [].
Qed.

(** FJ07.13 parameters: the cell determines them: no two pairs $\Lambda^{*}$, $M^{*}$ have the same first cell.
    Hypotheses: $c_1-c_0$ and $d_0-c_0$ are independent; $u_n\ne u_0$. *)
Theorem FJ07_13_parameters u n c d L M L' M' : u n - u 0%N != 0 ->
  (forall a b : F, a *: (c 1%N - c 0%N) + b *: (d 0%N - c 0%N) = 0 -> a = 0 /\ b = 0) ->
  cell u n L M c d 0 -> cell u n L' M' c d 0 -> L = L' /\ M = M'.
Proof.
move=> w indep; rewrite !FJ07_13_rulings add0n; move: (c 1%N - _) (d 0%N - _) (d 1%N - _) indep => a b e indep h h'.
have [|h1 h2] := indep ((M' - u 0%N) * (L - M) - (M - u 0%N) * (L' - M')) ((u n - u 0%N) * (M - M')).
  apply/rowP=> k; have := congr1 (fun r : 'rV_m => r 0 k) h; have := congr1 (fun r : 'rV_m => r 0 k) h'; rewrite !mxE.
  move: (a 0 k) (b 0 k) (e 0 k) => x y z g' g.
  have g0 : (M - u 0%N) * ((M' - u 0%N) * z) = (M' - u 0%N) * ((M - u 0%N) * z) by ring.
  by rewrite g g' in g0; apply: (by_multiple (z := -1) g0); ring.
have eM : M = M' by apply/eqP; rewrite -subr_eq0; move/eqP: h2; rewrite mulf_eq0 (negPf w).
split=> //; move/eqP: h1; rewrite -eM (_ : _ - _ = (M - u 0%N) * (L - L')); last by ring.
rewrite mulf_eq0 !subr_eq0 => /orP[/eqP e0|/eqP //].
have [|_ z0] := indep (L - M) (M - u n); first by rewrite addrC -h e0 subrr scale0r.
by move: w; rewrite -(opprK (u n - _)) opprB -e0 z0 oppr0 eqxx.
Qed.

(** FJ07.13 needs_no_cone: a first cell with $\mu=1$, that of a cone, has no $\Lambda^{*}$, $M^{*}$.
    Hypotheses: $c_1-c_0$ and $d_0-c_0$ are independent; $u_n\ne u_0$. *)
Theorem FJ07_13_needs_no_cone u n c d l L M : u n - u 0%N != 0 ->
  (forall a b : F, a *: (c 1%N - c 0%N) + b *: (d 0%N - c 0%N) = 0 -> a = 0 /\ b = 0) -> bary l 1 c d 0 -> ~ cell u n L M c d 0.
Proof.
move=> w indep e; rewrite FJ07_13_rulings add0n; have -> : d 1%N - c 1%N = (d 0%N - c 0%N) + (l - 1) *: (c 1%N - c 0%N).
  by rewrite e; by_entries k; ring.
move: (c 1%N - _) (d 0%N - _) indep => a b indep h.
have [|_ z] := indep ((M - u 0%N) * (l - 1) - (L - M)) (u n - u 0%N); last by move: w; rewrite z eqxx.
apply/rowP=> k; have := congr1 (fun r : 'rV_m => r 0 k) h; rewrite !mxE; move: (a 0 k) (b 0 k) => x y g.
by apply: (by_multiple (z := 1) g); ring.
Qed.

(** FJ07.13 needs_side: for $c_0=c_1$ the first cell does not depend on $\Lambda^{*}$. *)
Theorem FJ07_13_needs_side u n c d L L' M : c 1%N = c 0%N -> cell u n L M c d 0 -> cell u n L' M c d 0.
Proof. by rewrite !FJ07_13_rulings => ->; rewrite subrr !scaler0. Qed.

(** FJ07.13 needs_ruling: where $d_0=c_0$ all nets with $\Lambda^{*}-M^{*}=\beta(M^{*}-u_0)$ have the same $d_1=c_1+\beta(c_1-c_0)$.
    Hypotheses: $M^{*}\ne u_0$. *)
Theorem FJ07_13_needs_ruling u n c d beta M : d 0%N = c 0%N -> M - u 0%N != 0 ->
  cell u n (M + beta * (M - u 0%N)) M c d 0 <-> d 1%N - c 1%N = beta *: (c 1%N - c 0%N).
Proof.
move=> e nz; rewrite FJ07_13_rulings e subrr scaler0 add0r addrAC subrr add0r [beta * _]mulrC -scalerA.
by split=> [/(scalerI nz)|->].
Qed.
End Vertices.
