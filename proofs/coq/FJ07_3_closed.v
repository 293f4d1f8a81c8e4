(* FJ07, section 3: the recursion (18) in closed form and backwards; the nets that it makes, cones among them.
   Definitions:
     E a p mu x, G a p l mu x   p - a + (1 - mu) (a - x) and l (p - a) + (1 - mu) (a - x): for mu != 1 they are (1 - mu) (M* - x) and
                                (1 - mu) (L* - x), for mu = 1 they are constant; a = u_0, p = u_n in the first cell
     prev_l, prev_mu            the coefficients of the cell before, from those of a cell
     obeys u n l mu K           l_i, mu_i obey (18) up to the cell K, and no denominator vanishes *)
From Torse Require Import Prelude Blossom Curves Points FJ21_4 FJ07_3_net FJ07_3_blossoms FJ07_3_cells FJ07_2_cones FJ07_3_generic FJ07_3_segments.

Section Closed.
Variable F : fieldType.
Implicit Types (u l mu : nat -> F) (a b p q x L M : F) (n i K : nat).

Definition E a p (m : F) x := p - a + (1 - m) * (a - x).
Definition G a p (l m : F) x := l * (p - a) + (1 - m) * (a - x).
Definition prev_l a b q (l m : F) := G b q l m a / E b q m a.
Definition prev_mu a b p q (m : F) := E b q m p / E b q m a.
Definition obeys u n l mu K := forall i, (i < K)%N -> [/\ D (u i) (u i.+1) (u (i + n)%N) (mu i) != 0,
  l i.+1 = next_l (u i) (u i.+1) (u (i + n)%N) (l i) (mu i) &
  mu i.+1 = next_mu (u i) (u i.+1) (u (i + n)%N) (u (i + n).+1) (mu i)].

(** FJ07.18 closed: (18) from the first cell $(l_1,\mu_1)$ gives $l_i=G(u_{i-1})/E(u_{i-1})$, $\mu_i=E(u_{i+n-1})/E(u_{i-1})$ with
    $E(x)=u_n-u_0+(1-\mu_1)(u_0-x)$, $G(x)=l_1(u_n-u_0)+(1-\mu_1)(u_0-x)$, and $E(u_{i-1})\ne0$.
    Hypotheses: $u_n\ne u_0$; no denominator of (18) vanishes up to the cell, so that its coefficients have a meaning. *)
Theorem FJ07_18_closed u n l mu K (e := E (u 0%N) (u n) (mu 0%N)) (g := G (u 0%N) (u n) (l 0%N) (mu 0%N)) :
  u n - u 0%N != 0 -> obeys u n l mu K ->
  forall i, (i <= K)%N -> [/\ e (u i) != 0, l i = g (u i) / e (u i) & mu i = e (u (i + n)%N) / e (u i)].
Proof.
move=> width rec; elim=> [_|i ih lt_i].
  by rewrite add0n /e /g /E /G !subrr mulr0 !addr0; split=> //; field.
have [e0 l_i m_i] := ih (ltnW lt_i); have [d0 -> ->] := rec i lt_i.
have eD : D (u i) (u i.+1) (u (i + n)%N) (mu i) = e (u i.+1) * (u (i + n)%N - u i) / e (u i).
  by rewrite m_i /D; move: e0; rewrite /e /E; move: (u 0%N) (u n) (u i) (u i.+1) (u (i + n)%N) => *; field.
have [e1 w0] : e (u i.+1) != 0 /\ u (i + n)%N - u i != 0.
  by move: d0; rewrite eD !mulf_eq0 !negb_or => /andP[/andP[]].
rewrite addSn /next_l /next_mu eD l_i m_i; move: e0 e1 w0; rewrite /e /g /E /G.
move: (u 0%N) (u n) (u i) (u i.+1) (u (i + n)%N) (u (i + n).+1) (mu 0%N) (l 0%N) => u0 un a b p q m k e0 e1 w0.
by split=> //; field; rewrite e0 e1 w0.
Qed.

Lemma obeys_width u n l mu K : u n - u 0%N != 0 -> obeys u n l mu K -> forall i, (i < K)%N -> u (i + n)%N - u i != 0.
Proof.
move=> w0 rec i lt_i; have [e0 _ m_i] := FJ07_18_closed w0 rec (ltnW lt_i); have [e1 _ _] := FJ07_18_closed w0 rec lt_i.
have [d0 _ _] := rec i lt_i; apply: contraNneq d0 => /eqP; rewrite subr_eq0 => /eqP e.
by rewrite m_i e divff // /D mul1r subrKA subrr.
Qed.

(** FJ07.18 classes: $l_i=1$ in one cell iff in all, and $\mu_i=1$ in one cell iff in all, and then all $l_i$ are equal.
    Hypotheses: $u_{i+n-1}\ne u_{i-1}$ in the first and in the last cell; no denominator of (18) vanishes, so that it has a meaning. *)
Theorem FJ07_18_classes u n l mu K i j : u n - u 0%N != 0 -> u (K + n)%N - u K != 0 -> obeys u n l mu K ->
  (i <= K)%N -> (j <= K)%N -> [/\ l i = 1 -> l j = 1, mu i = 1 -> mu j = 1 & mu i = 1 -> l i = l j].
Proof.
move=> w0 wK rec le_i le_j; have closed := FJ07_18_closed w0 rec.
have width r : (r <= K)%N -> u (r + n)%N - u r != 0.
  by rewrite leq_eqVlt => /predU1P[->|] //; exact: obeys_width w0 rec r.
have l1 r : (r <= K)%N -> (l r == 1) = (l 0%N == 1).
  move=> /closed[e0 -> _]; rewrite -[RHS]subr_eq0 -[LHS]subr_eq0; set e := E _ _ _ _ in e0 *.
  have -> : G (u 0%N) (u n) (l 0%N) (mu 0%N) (u r) / e - 1 = (l 0%N - 1) * ((u n - u 0%N) / e).
    by rewrite -[X in _ - X = _](divff e0) -mulrBl /e /G /E mulrA; congr (_ / _); ring.
  by rewrite mulf_eq0 [X in _ || X]mulf_eq0 invr_eq0 (negPf w0) (negPf e0) !orbF.
have m1 r : (r <= K)%N -> (mu r == 1) = (mu 0%N == 1).
  move=> le_r; have [e0 _ ->] := closed r le_r; rewrite -[RHS]subr_eq0 -[LHS]subr_eq0; set e := E _ _ _ (u r) in e0 *.
  have -> : E (u 0%N) (u n) (mu 0%N) (u (r + n)%N) / e - 1 = (mu 0%N - 1) * ((u (r + n)%N - u r) / e).
    by rewrite -[X in _ - X = _](divff e0) -mulrBl /e /E mulrA; congr (_ / _); ring.
  by rewrite mulf_eq0 [X in _ || X]mulf_eq0 invr_eq0 (negPf (width r le_r)) (negPf e0) !orbF.
split=> [/eqP|/eqP|/eqP]; rewrite ?l1 ?m1 // => e; first by apply/eqP; rewrite l1.
  by apply/eqP; rewrite m1.
have [_ -> _] := closed i le_i; have [_ -> _] := closed j le_j.
by rewrite /G /E (eqP e) subrr !mul0r.
Qed.

(** FJ07.18 backward: the cell before has $l=G'(u_{i-2})/E'(u_{i-2})$, $\mu=E'(u_{i+n-2})/E'(u_{i-2})$ with
    $E'(x)=u_{i+n-1}-u_{i-1}+(1-\mu_i)(u_{i-1}-x)$, $G'(x)=l_i(u_{i+n-1}-u_{i-1})+(1-\mu_i)(u_{i-1}-x)$, so that any cell gives all.
    Hypotheses: $u_{i+n-2}\ne u_{i-2}$, $u_{i+n-1}\ne u_{i-1}$; the denominator of (18) is not 0, so that it has a meaning. *)
Theorem FJ07_18_backward a b p q (l m : F) (l' := next_l a b p l m) (m' := next_mu a b p q m) : D a b p m != 0 -> p - a != 0 -> q - b != 0 ->
  [/\ E b q m' a != 0, prev_l a b q l' m' = l & prev_mu a b p q m' = m].
Proof.
move=> d0 pa qb; have eE : E b q m' a = (q - b) * (p - a) / D a b p m.
  by move: d0; rewrite /m' /next_mu /E /D => d0; field.
have e0 : E b q m' a != 0 by rewrite eE !mulf_neq0 ?invr_neq0.
split=> //; rewrite /prev_l /prev_mu eE /G /E /l' /m' /next_l /next_mu; move: d0; rewrite /D => d0; field; by rewrite d0 pa qb.
Qed.

(** FJ07.18 parameters: for $\mu_1\ne1$ these are $E(x)=(1-\mu_1)(M^{*}-x)$, $G(x)=(1-\mu_1)(\Lambda^{*}-x)$ with
    $M^{*}=u_0+\frac{u_n-u_0}{1-\mu_1}$, $\Lambda^{*}=u_0+l_1\frac{u_n-u_0}{1-\mu_1}$.
    Hypotheses: $\mu_1\ne1$, so that the quotients have a meaning; for $\mu_1=1$, a cone, $E$ and $G$ are constant. *)
Theorem FJ07_18_parameters a p (l m : F) x : 1 - m != 0 ->
  E a p m x = (1 - m) * (a + (p - a) / (1 - m) - x) /\ G a p l m x = (1 - m) * (a + l * ((p - a) / (1 - m)) - x).
Proof. by rewrite /E /G => nz; split; field. Qed.
End Closed.

Section Nets.
Variables (F : fieldType) (m : nat).
Implicit Types (u l mu : nat -> F) (c d : nat -> 'rV[F]_m) (n i K : nat).

(** FJ07.18 net: cells whose coefficients obey (18) obey (13) with these $\Lambda^{*}$, $M^{*}$ if $\mu_1\ne1$; if $\mu_1=1$ they have
    proportional sides, $d_i-d_{i-1}=l_1(c_i-c_{i-1})$.
    Hypotheses: $u_n\ne u_0$; no denominator of (18) vanishes, so that it has a meaning. *)
Theorem FJ07_18_net u n l mu c d K (M := u 0%N + (u n - u 0%N) / (1 - mu 0%N)) (L := u 0%N + l 0%N * ((u n - u 0%N) / (1 - mu 0%N))) :
  u n - u 0%N != 0 -> obeys u n l mu K -> (forall i, (i <= K)%N -> bary (l i) (mu i) c d i) ->
  if mu 0%N == 1 then proportional (l 0%N) c d K.+1
  else forall i, (i <= K)%N -> M - u i != 0 /\ cell u n L M c d i.
Proof.
move=> width rec cells; have closed := FJ07_18_closed width rec; case: eqP => [m1 i lt_i|/eqP m1 i lt_i].
  have := cells i lt_i; have [_ -> ->] := closed i lt_i.
  rewrite /E /G m1 subrr !mul0r !addr0 divff // mulfK //.
  by move/FJ07_18_cone_sides.
have m1' : 1 - mu 0%N != 0 by rewrite subr_eq0 eq_sym.
have [e0 eq_l eq_m] := closed i lt_i; have eE x := (FJ07_18_parameters (u 0%N) (u n) (l 0%N) x m1').1.
have eG x := (FJ07_18_parameters (u 0%N) (u n) (l 0%N) x m1').2.
have nz : M - u i != 0 by move: e0; rewrite eE -/M mulf_eq0 negb_or => /andP[].
split=> //; apply/FJ07_18_cell => //; move: (cells i lt_i); rewrite eq_l eq_m !eE eG -/M -/L.
by rewrite -!mulf_div divff // !mul1r.
Qed.

(** FJ07.18 rulings: if $l_i=1$ in all cells, all rulings are parallel: $d_i-c_i=\mu_1\cdots\mu_i(d_0-c_0)$.
    Hypotheses: none. *)
Theorem FJ07_18_rulings l mu c d K : (forall i, (i < K)%N -> l i = 1) -> (forall i, (i < K)%N -> bary (l i) (mu i) c d i) ->
  forall i, (i <= K)%N -> d i - c i = (\prod_(0 <= j < i) mu j) *: (d 0%N - c 0%N).
Proof.
move=> l1 cells; elim=> [_|i ih lt_i]; first by rewrite big_geq // scale1r.
rewrite big_nat_recr //= mulrC -scalerA -ih 1?ltnW // (cells i lt_i) l1 //.
by by_entries k; ring.
Qed.

(** FJ07.18 cylinder_converse: a cell with two rulings along $v$ has $l=1$.
    Hypotheses: the side $c_{i+1}-c_i$ is not along $v$. *)
Theorem FJ07_18_cylinder_converse (l mu : F) c d i (v : 'rV[F]_m) s t : (forall x, c i.+1 - c i <> x *: v) ->
  d i - c i = s *: v -> d i.+1 - c i.+1 = t *: v -> bary l mu c d i -> l = 1.
Proof.
move=> off ws wt cell_i; apply/eqP; rewrite -subr_eq0; apply: contraT => nz.
case: (off ((t - mu * s) / (l - 1))); apply: (scalerI nz); rewrite scalerA mulrC divfK // scalerBl -wt -scalerA -ws cell_i.
by by_entries k; ring.
Qed.

(** FJ07.18 cylinder_needs_side: where $c_{i+1}-c_i$ and $d_i-c_i$ are along $v$, so is $d_{i+1}-c_{i+1}$, whatever $l$ is. *)
Theorem FJ07_18_cylinder_needs_side (l mu : F) c d i (v : 'rV[F]_m) s x : c i.+1 - c i = x *: v -> d i - c i = s *: v ->
  bary l mu c d i -> d i.+1 - c i.+1 = ((l - 1) * x + mu * s) *: v.
Proof. by move=> ex es e; rewrite [RHS]scalerDl -!scalerA -ex -es e; by_entries k; ring. Qed.

(** FJ07.18 cone_vertex: if $\mu_i=1$ in all cells, with the same $l\ne1$, every line $c_id_i$ passes through $a=(lc_0-d_0)/(l-1)$:
    $d_i-a=l(c_i-a)$; and only then.
    Hypotheses: $l\ne1$, so that there is such a point. *)
Theorem FJ07_18_cone_vertex (l : F) c d K (a := vertex l c d) : l - 1 != 0 ->
  (forall i, (i < K)%N -> bary l 1 c d i) <-> forall i, (i <= K)%N -> d i - a = l *: (c i - a).
Proof.
move=> nz; rewrite -FJ07_6_vertex //; split=> cells i lt_i; first by apply/FJ07_18_cone_sides/cells.
by apply/FJ07_18_cone_sides/cells.
Qed.

(** FJ07.18 cone_converse: if the lines $c_id_i$ of two neighbouring cells that obey (18) pass through one point $a$, $d_j-a=\rho_j(c_j-a)$, both
    cells have $\mu=1$.
    Hypotheses: $l\ne1$; $c_i-a$, $c_{i+1}-a$ are independent in both cells; $u_{i+n-1}\ne u_{i-2}$; the denominator of (18) is not 0, so that the second cell
    has a meaning. *)
Theorem FJ07_18_cone_converse (a b p q l mu : F) c d (o : 'rV[F]_m) (rho : nat -> F) i : l != 1 -> D a b p mu != 0 -> q - a != 0 ->
  (forall j x y, (i <= j <= i.+1)%N -> x *: (c j - o) + y *: (c j.+1 - o) = 0 -> x = 0 /\ y = 0) ->
  (forall j, (i <= j <= i.+2)%N -> d j - o = rho j *: (c j - o)) ->
  bary l mu c d i -> bary (next_l a b p l mu) (next_mu a b p q mu) c d i.+1 -> mu = 1.
Proof.
move=> l1 d0 qa indep through.
have step j k z : (i <= j <= i.+1)%N -> bary k z c d j -> rho j.+1 = k /\ z * (rho j - 1) = k - 1.
  move=> le_j cell_j; have := @indep j (z * (rho j - 1) - (k - 1)) (k - rho j.+1) le_j.
  have t0 : d j = rho j *: (c j - o) + o by apply: (canRL (subrK _)); apply: through; lia.
  have t1 : d j.+1 = rho j.+1 *: (c j.+1 - o) + o by apply: (canRL (subrK _)); apply: through; lia.
  case.
    apply/rowP=> r; have := congr1 (fun w : 'rV_m => w 0 r) cell_j; rewrite t0 t1 !mxE.
    move: (c j 0 r) (c j.+1 0 r) (o 0 r) (rho j) (rho j.+1) => x y w s t e.
    by apply: (by_multiple (z := -1) e); ring.
  by move=> /eqP; rewrite subr_eq0 => /eqP -> /eqP; rewrite subr_eq0 => /eqP ->.
move=> /step[|r1 _]; first by lia.
move=> /step[|_]; first by lia.
rewrite r1 => e; have nz : l - 1 != 0 by rewrite subr_eq0.
have eq_l : next_l a b p l mu - 1 = (l - 1) * ((p - a) / D a b p mu).
  by move: d0; rewrite /next_l /D => d0; field.
move: e; rewrite eq_l mulrC => /(mulfI nz); rewrite /next_mu => /(mulIf (invr_neq0 d0)) e.
have: (q - a) * (mu - 1) = 0 by apply: (by_multiple (z := 1) e); ring.
by move/eqP; rewrite mulf_eq0 (negPf qa) subr_eq0 => /eqP.
Qed.
End Nets.

(** FJ07.18 developable: every first cell $(l_1,\mu_1)$, that of a cone included, makes a net that spans developable surfaces over all its pieces.
    Hypotheses: no denominator of (18) vanishes, so that it has a meaning; of the knots none, the pieces without length apart. *)
Theorem FJ07_18_developable (F : fieldType) (u l mu : nat -> F) (c d : nat -> 'rV[F]_3) n N :
  obeys u n l mu (n + N.-1).-1 ->
  (forall i, (i <= (n + N.-1).-1)%N -> bary (l i) (mu i) c d i) ->
  forall k, (k < N)%N -> span n (drop_ k u) -> developable (pcurve n (drop_ k u) (drop_ k c)) (pcurve n (drop_ k u) (drop_ k d)).
Proof.
case: n => [|n] rec cells k lt_k sp; first by rewrite /developable !pderiv_curve // !mulr0n; coordinates; ring.
have w0 : drop_ k u n.+1 - drop_ k u 0%N != 0 by rewrite -unitfE; apply: sp; lia.
have rec_k : obeys (drop_ k u) n.+1 (drop_ k l) (drop_ k mu) n.
  by move=> i lt_i; have [|] := rec (k + i)%N; [lia | rewrite /drop_ !addnS addnA].
have cells_k i : (i <= n)%N -> bary (drop_ k l i) (drop_ k mu i) (drop_ k c) (drop_ k d) i.
  by move=> le_i; rewrite /bary /drop_ addnS; apply: cells; lia.
have := FJ07_18_net w0 rec_k cells_k; case: eqP => [_ sides|_ net_k].
  exact: (@FJ07_6_developable F n.+1 (drop_ k u) (drop_ k c) (drop_ k d) _ n.+1 0%N (leqnn _) sp sides).2.
by apply: (FJ07_T1_developable sp); apply/(FJ07_T1_piece _ _ _ _ sp) => i lt_i; have [_ cell_i] := net_k i lt_i; exact: cell_i.
Qed.
