(* FJ07, section 3: the edge of regression of a net of Theorem 1, and the four points of equation (9) on a ruling.
   Definitions:
     on_sides w n x r c K   the points c_0, ..., c_K are those of the blossom r[., x] of degree n, for r of degree n + 1 over the knots w:
                            each lies on a side of the polygon r
     last_but_one u n k t e c   c[t, ..., t, e] on piece k, one of the two last but one points of de Boor's algorithm for an end e *)
From Torse Require Import Prelude Blossom Curves Points FJ21_4 FJ07_3_pieces FJ07_3_net FJ07_3_blossoms FJ07_3_segments.

Section Edge.
Variables (F : fieldType) (m : nat).
Implicit Types (u w : nat -> F) (c d r : nat -> 'rV[F]_m) (L M x : F) (n i K : nat).

Definition on_sides w n x r c K := forall i, (i <= K)%N ->
  (w (i + n.+1)%N - w i) *: c i = (w (i + n.+1)%N - x) *: r i + (x - w i) *: r i.+1.

Lemma cell_shift w n L M c d i : cell (shift w) n L M c d i <->
  (w (i + n.+1)%N - L) *: c i + (L - w i.+1) *: c i.+1 = (w (i + n.+1)%N - M) *: d i + (M - w i.+1) *: d i.+1.
Proof. by rewrite /cell /shift addnS. Qed.

(** FJ07.T1 edge: the nets of (13) with $\Lambda^{*}\ne M^{*}$ are those of the tangents of a spline $r$ of degree $n+1$, the edge of
    regression: with a further knot at each end and $w_i=u_{i-1}$ the points $c_i$, $d_i$ are
    $\frac{(w_{i+n+1}-x)r_i+(x-w_i)r_{i+1}}{w_{i+n+1}-w_i}$ for $x=M^{*}$ and $x=\Lambda^{*}$, and every polygon $r$ makes such a net.
    Hypotheses: $\Lambda^{*}\ne M^{*}$, and $w_{i+n+1}\ne w_i$; neither $\Lambda^{*}$ nor $M^{*}$ has to be off the knots. *)
Theorem FJ07_T1_edge w n L M c d K : L - M != 0 -> (forall i, (i <= K)%N -> w (i + n.+1)%N - w i != 0) ->
  (forall i, (i < K)%N -> cell (shift w) n L M c d i) <-> exists r, on_sides w n M r c K /\ on_sides w n L r d K.
Proof.
move=> nz width; split=> [cells | [r [eq_c eq_d]] i lt_i]; last first.
  apply/cell_shift; have w0 := width i (ltnW lt_i); have w1 := width i.+1 lt_i.
  have := eq_d i.+1 lt_i; have := eq_d i (ltnW lt_i); have := eq_c i.+1 lt_i; have := eq_c i (ltnW lt_i).
  move: w0 w1; rewrite addSn; move: (w i) (w i.+1) (w (i + n.+1)%N) (w (i + n.+1).+1) => a b p q w0 w1 e1 e2 e3 e4.
  have solve (s : F) (y z : 'rV[F]_m) : s != 0 -> s *: y = z -> y = s^-1 *: z by move=> s0 <-; rewrite scalerA mulVf // scale1r.
  rewrite (solve _ _ _ w0 e1) (solve _ _ _ w1 e2) (solve _ _ _ w0 e3) (solve _ _ _ w1 e4).
  by by_entries k; field; rewrite w0 w1.
pose out i := (M - L)^-1 *: ((M - w i) *: d i - (L - w i) *: c i).
pose back i := (M - L)^-1 *: ((w (i + n.+1)%N - L) *: c i - (w (i + n.+1)%N - M) *: d i).
exists (fun i => if (i <= K)%N then out i else back i.-1).
have nz' : M - L != 0 by rewrite -opprB oppr_eq0.
have meet i : (i <= K)%N -> (if (i.+1 <= K)%N then out i.+1 else back i) = back i.
  case: ifP => // lt_i _; have /cell_shift e := cells i lt_i; congr (_ *: _); apply/eqP.
  by rewrite subr_eq addrAC eq_sym subr_eq [X in _ == X]addrC -e addrC.
split=> i le_i /=; rewrite le_i meet // /out /back; by move: (w i) (w (i + n.+1)%N) => a p; by_entries k; field.
Qed.

(** FJ07.T1 edge_blossom: then $c[v_1,\dots,v_n]=r[M^{*},v_1,\dots,v_n]$, so that $c(t)$ is the point $M^{*}$, and $d(t)$ the point
    $\Lambda^{*}$, on the tangent of $r$ at $t$.
    Hypotheses: the knots carry the piece, so that its points have a meaning. *)
Theorem FJ07_T1_edge_blossom w n x r c v : span n.+1 w -> size v = n -> on_sides w n x r c n ->
  pblossom (shift w) c v = pblossom w r (at_ x :: v).
Proof.
move=> sp sz sides; apply/rowP=> k; rewrite !mxE /= sz; apply: blossom_ext => i; rewrite sz => le_i.
have nz : w (i + n.+1)%N - w i != 0 by rewrite -unitfE; apply: sp; lia.
have := congr1 (fun z : 'rV_m => z 0 k) (sides i le_i); rewrite /step /coord /at_ /= !mul1r !mxE => <-.
by rewrite mulrC mulKf.
Qed.

(** FJ07.T1 needs_distinct: for $\Lambda^{*}=M^{*}$ the rows on the sides of one polygon are equal, and all rulings points. *)
Theorem FJ07_T1_needs_distinct w n x r c d K : (forall i, (i <= K)%N -> w (i + n.+1)%N - w i != 0) ->
  on_sides w n x r c K -> on_sides w n x r d K -> forall i, (i <= K)%N -> c i = d i.
Proof. by move=> width sc sd i le_i; apply: (scalerI (width i le_i)); rewrite sc // sd. Qed.
End Edge.

Section Points.
Variables (F : fieldType) (m : nat).
Implicit Types (u : nat -> F) (c d : nat -> 'rV[F]_m) (L M t e : F) (n i k : nat).

Definition last_but_one u n k t e c : 'rV[F]_m := pblossom (drop_ k u) (drop_ k c) (at_ e :: nseq n (at_ t)).

(** FJ07.9 points: on piece $k=[a,b]$, with $c_0^{n-1}=c[t^{\langle n-1\rangle},a]$, $c_1^{n-1}=c[t^{\langle n-1\rangle},b]$:
    $(1-\Lambda_k)c_0^{n-1}+\Lambda_kc_1^{n-1}=(1-M_k)d_0^{n-1}+M_kd_1^{n-1}$ for all $t$.
    Hypotheses: the knots carry the piece, so that its points have a meaning. *)
Theorem FJ07_9_points u n k L M c d t (a := u (n + k)%N) (b := u (n + k).+1) (Lam := local u n k L) (Mu := local u n k M) :
  span n.+1 (drop_ k u) -> related (drop_ k u) n.+1 L M (drop_ k c) (drop_ k d) ->
  (1 - Lam) *: last_but_one u n k t a c + Lam *: last_but_one u n k t b c
    = (1 - Mu) *: last_but_one u n k t a d + Mu *: last_but_one u n k t b d.
Proof.
move=> sp rel; have nz := piece_len sp; have {rel} := rel (nseq n (at_ t)); rewrite size_nseq => /(_ erefl).
rewrite -{1}(FJ07_10_star L nz) -{1}(FJ07_10_star M nz) -/a -/b -/Lam -/Mu => eq_cd; apply/rowP=> j.
have := congr1 (fun z : 'rV_m => z 0 j) eq_cd; rewrite ![pblossom _ _ _ _ _]mxE.
by rewrite !(blossoms_affine _ _ [::]) /last_but_one !mxE.
Qed.

(** FJ07.9 barycentric: that is $d_1^{n-1}=(1-\lambda-\mu)c_0^{n-1}+\lambda c_1^{n-1}+\mu d_0^{n-1}$, $\lambda=\Lambda_k/M_k$, $\mu=1-1/M_k$.
    Hypotheses: the knots carry the piece, so that its points have a meaning; $M^{*}$ is not its start, so that $\lambda$, $\mu$ have a meaning. *)
Theorem FJ07_9_barycentric u n k L M c d t (a := u (n + k)%N) (b := u (n + k).+1) (Lam := local u n k L) (Mu := local u n k M)
    (lam := Lam / Mu) (mu := 1 - Mu^-1) :
  span n.+1 (drop_ k u) -> M != a -> related (drop_ k u) n.+1 L M (drop_ k c) (drop_ k d) ->
  last_but_one u n k t b d = (1 - lam - mu) *: last_but_one u n k t a c + lam *: last_but_one u n k t b c + mu *: last_but_one u n k t a d.
Proof.
move=> sp Ma rel; have := FJ07_9_points t sp rel; rewrite -/a -/b -/Lam -/Mu.
have nz : Mu != 0 by rewrite /Mu /local mulf_neq0 ?invr_neq0 ?piece_len // subr_eq0.
pose p i := last_but_one u n k t (if i is 0%N then a else b) c; pose q i := last_but_one u n k t (if i is 0%N then a else b) d.
exact: (iffLR (@FJ07_12_barycentric F m Lam Mu p q 0 nz)).
Qed.
End Points.

(** FJ07.3 points: $[d',c',d-c]=\left(\frac n{b-a}\right)^2[c_1^{n-1}-c_0^{n-1},d_0^{n-1}-c_0^{n-1},d_1^{n-1}-c_0^{n-1}]$ on a piece $[a,b]$:
    the condition (3) says that the four last but one points of de Boor's algorithm are coplanar.
    Hypotheses: the knots carry the piece, so that its points have a meaning. *)
Theorem FJ07_3_points (F : fieldType) (u : nat -> F) n k (c d : nat -> 'rV[F]_3) t (a := u (n + k)%N) (b := u (n + k).+1)
    (c0 := last_but_one u n k t a c) (c1 := last_but_one u n k t b c) (d0 := last_but_one u n k t a d) (d1 := last_but_one u n k t b d)
    (C := pcurve n.+1 (drop_ k u) (drop_ k c)) (D := pcurve n.+1 (drop_ k u) (drop_ k d)) : span n.+1 (drop_ k u) ->
  triple (ev (pderiv D) t) (ev (pderiv C) t) (ev D t - ev C t)
    = (n.+1%:R / (b - a)) ^+ 2 * triple (c1 - c0) (d0 - c0) (d1 - c0).
Proof.
move=> sp; have nz : b - a != 0 := piece_len sp.
have [n0|n0] := eqVneq (n.+1%:R : F) 0.
  have still (x : nat -> 'rV[F]_3) : ev (pderiv (pcurve n.+1 (drop_ k u) (drop_ k x))) t = 0.
    by rewrite pderiv_curve //; apply/rowP=> j; rewrite !(mxE, mulmxnE) hornerMn -mulr_natr n0 mulr0.
  by rewrite !still n0 mul0r expr0n mul0r; coordinates; ring.
have solve (x : nat -> 'rV[F]_3) (X := pcurve n.+1 (drop_ k u) (drop_ k x)) (x0 := last_but_one u n k t a x) (x1 := last_but_one u n k t b x) :
  ev (pderiv X) t = (n.+1%:R / (b - a)) *: (x1 - x0) /\ ev X t = x0 + ((t - a) / (b - a)) *: (x1 - x0).
  have e0 := FJ21_3_5_tangent (drop_ k x) t a n0 sp; have e1 := FJ21_3_5_tangent (drop_ k x) t b n0 sp.
  rewrite -/X -/x0 -/x1 in e0 e1; rewrite /x0 /x1 /last_but_one -e0 -e1 /tangent; move: (ev X t) (ev (pderiv X) t) => y y'.
  move: n0 nz; move: (n.+1%:R : F) (a) (b) => N p q n0 nz.
  by split; by_entries j; field; rewrite n0 nz.
have [-> ->] := solve c; have [-> ->] := solve d; rewrite -/c0 -/c1 -/d0 -/d1; move: c0 c1 d0 d1 => p q r s.
by move: (b - a) (t - a) (n.+1%:R) nz => l y N nz; coordinates; hide_entries; field.
Qed.
