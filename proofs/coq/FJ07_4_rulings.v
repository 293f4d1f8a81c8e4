(* FJ07, section 4: the ends of the rulings, equation (21); parallel and meeting end rulings.
   Definitions:
     along v w n x, beside v w n x   det(x, w, n) / det(v, w, n) and det(v, x, n) / det(v, w, n): alpha and beta for x = a(M_0) - c_L
     first_end u n K L M alpha    sigma_0;  last_end u K L M beta    tau_0 *)
From Torse Require Import Prelude Blossom Curves Points Dependence FJ07_2 FJ07_3_net FJ21_4 FJ07_2_cones FJ07_3_generic FJ07_3_segments FJ07_4.
From mathcomp Require Import order ssrnum.

Section Coefficients.
Variable F : fieldType.
Implicit Types (v w x : 'rV[F]_3) (alpha beta : F).

Definition along v w nrm x := triple x w nrm / triple v w nrm.
Definition beside v w nrm x := triple v x nrm / triple v w nrm.

(** FJ07.21 coefficients: with $n=v\times w$ a vector $x$ with $[x,v,w]=0$ is $\alpha v+\beta w$ for $\alpha=\frac{\det(x,w,n)}{\det(v,w,n)}$,
    $\beta=\frac{\det(v,x,n)}{\det(v,w,n)}$.
    Hypotheses: $\det(v,w,n)=|v\times w|^2\ne0$; over an ordered field that is $v\times w\ne0$. *)
Theorem FJ07_21_coefficients v w x (nrm := cross v w) : triple v w nrm != 0 -> triple x v w = 0 ->
  x = along v w nrm x *: v + beside v w nrm x *: w.
Proof.
move=> nz par; apply: (scalerI nz); rewrite scalerDr !scalerA /along /beside ![_ * (_ / _)]mulrC !divfK //.
have cramer e : triple v w e *: x = triple x w e *: v + triple v x e *: w + triple x v w *: e.
  by apply: row3P; coordinates; hide_entries; ring.
by rewrite cramer par scale0r addr0.
Qed.

(** FJ07.21 independent: these are the only ones.
    Hypotheses: $v\times w\ne0$. *)
Theorem FJ07_21_independent v w alpha beta alpha' beta' : cross v w != 0 ->
  alpha *: v + beta *: w = alpha' *: v + beta' *: w -> alpha = alpha' /\ beta = beta'.
Proof.
move=> nz e; have {}e : (alpha - alpha') *: v = (beta' - beta) *: w.
  apply/eqP; rewrite -subr_eq0; move/eqP: e; rewrite -subr_eq0 => /eqP e; apply/eqP.
  by rewrite -[RHS]e; by_entries k; ring.
have ea : (alpha - alpha') *: cross v w = 0 by rewrite -crossZl e crossZl cross_self scaler0.
have eb : (beta' - beta) *: cross v w = 0 by rewrite -crossZr -e crossZr cross_self scaler0.
by move/eqP: ea; move/eqP: eb; rewrite !scalemx_eq0 (negPf nz) !orbF !subr_eq0 => /eqP-> /eqP->.
Qed.

Lemma combination v w x : cross v w != 0 -> triple x v w = 0 -> exists alpha beta, x = alpha *: v + beta *: w.
Proof.
move=> nz /triple_dependent[a [b [e [nz0 eq0]]]]; have [a0|a_nz] := eqVneq a 0.
  move: eq0; rewrite a0 scale0r add0r => eq0.
  have [] := @FJ07_21_independent v w b e 0 0 nz; first by rewrite eq0 !scale0r addr0.
  by move=> b0 e0; move: nz0; rewrite a0 b0 e0 eqxx.
exists (- (b / a)), (- (e / a)); apply: (scalerI a_nz); apply/eqP; rewrite -subr_eq0 -[X in _ == X]eq0; apply/eqP.
by by_entries k; field.
Qed.
End Coefficients.

(** FJ07.21 norm: $\det(v,w,v\times w)=|v\times w|^2\ne0$ where $v\times w\ne0$.
    Hypotheses: an ordered field. *)
Theorem FJ07_21_norm (R : realFieldType) (v w : 'rV[R]_3) : cross v w != 0 -> triple v w (cross v w) != 0.
Proof.
move=> nz; have -> : triple v w (cross v w) = x_ (cross v w) ^+ 2 + y_ (cross v w) ^+ 2 + z_ (cross v w) ^+ 2.
  by coordinates; ring.
move: (cross v w) nz => e; apply: contraNneq => /eqP; rewrite !Num.Theory.paddr_eq0 ?Num.Theory.addr_ge0 ?Num.Theory.sqr_ge0 //.
by rewrite !sqrf_eq0 => /andP[/andP[/eqP ex /eqP ey] /eqP ez]; apply/eqP/row3P; rewrite ?ex ?ey ?ez ?mxE /x_ /y_ /z_ ?mxE.
Qed.

Section Ends.
Variable F : fieldType.
Implicit Types (u : nat -> F) (c d : nat -> 'rV[F]_3) (v w : 'rV[F]_3) (L M sigma tau alpha beta : F) (n i K : nat).

Definition first_end u n K L M alpha := alpha * ((L - M) / (M - u K)) * \prod_(0 <= i < K.+1) ((M - u i) / (M - u (i + n)%N)).
Definition last_end u K L M beta := beta * ((M - L) / (M - u K)).

Lemma P_inv u n M K : (forall i, (i < K.+1)%N -> M - u i != 0) -> (forall i, (i < K.+1)%N -> M - u (i + n)%N != 0) ->
  P u n M 0 K.+1 * \prod_(0 <= i < K.+1) ((M - u i) / (M - u (i + n)%N)) = 1.
Proof.
move=> off off'; rewrite /P -big_split big_nat_cond big1 // => i /andP[/andP[_ lt_i] _] /=.
by move: (off i lt_i) (off' i lt_i); move: (u i) (u (i + n)%N) => a b a0 b0; field; rewrite a0 b0.
Qed.

(** FJ07.21 interpolation: for $a(M_0)-c_L=\alpha v+\beta w$ the net of (13) from $d_0=c_0+\sigma_0v$,
    $\sigma_0=\alpha\frac{\Lambda^{*}-M_0}{M_0-u_{L-1}}\prod_{i=0}^{L-1}\frac{M_0-u_i}{M_0-u_{i+n}}$, ends in $d_L=c_L+\tau_0w$,
    $\tau_0=\beta\frac{M_0-\Lambda^{*}}{M_0-u_{L-1}}$, for every $\Lambda^{*}$.
    Hypotheses: $M_0$ is none of the knots $u_0,\dots,u_{L+n-1}$, so that the quotients have a meaning; $v$ and $w$ may be any. *)
Theorem FJ07_21_interpolation u n L M c v w alpha beta K : (forall i, (i < K.+1)%N -> M - u i != 0) ->
  (forall i, (i < K.+1)%N -> M - u (i + n)%N != 0) -> aim u n c K M - c K.+1 = alpha *: v + beta *: w ->
  net u n L M c (c 0%N + first_end u n K L M alpha *: v) K.+1 = c K.+1 + last_end u K L M beta *: w.
Proof.
move=> off off' eq_a; have [eq0 cells] := FJ07_13_exists n L c (c 0%N + first_end u n K L M alpha *: v) off.
move: (FJ07_20_last off cells); rewrite eq0 -[c K.+1 - aim _ _ _ _ _]opprB eq_a => /(canRL (subrK _)) ->.
rewrite [c 0%N + _]addrC addrK addrC; congr (_ + _); rewrite scalerA /first_end /last_end.
have := P_inv off off'; move: (P u n M 0 K.+1) (\prod_(0 <= i < K.+1) _) (M - u K) (off K (ltnSn K)) => p q e enz pq.
rewrite [p * _]mulrCA pq mulr1; by by_entries k; field.
Qed.

(** FJ07.21 lengths: $\sigma_0=0$, the first ruling shrinks to $c_0$, iff $\alpha=0$ or $\Lambda^{*}=M_0$; $\tau_0=0$ iff $\beta=0$ or $\Lambda^{*}=M_0$.
    Hypotheses: $M_0$ is none of the knots, so that $\sigma_0$ and $\tau_0$ have a meaning. *)
Theorem FJ07_21_lengths u n L M alpha beta K : (forall i, (i < K.+1)%N -> M - u i != 0) ->
  (forall i, (i < K.+1)%N -> M - u (i + n)%N != 0) ->
  (first_end u n K L M alpha == 0) = (alpha == 0) || (L == M) /\ (last_end u K L M beta == 0) = (beta == 0) || (L == M).
Proof.
move=> off off'; have e0 := off K (ltnSn K); have q0 : \prod_(0 <= i < K.+1) ((M - u i) / (M - u (i + n)%N)) != 0.
  by apply/eqP=> z; have := P_inv off off'; rewrite z mulr0 => /eqP; rewrite eq_sym oner_eq0.
rewrite /first_end /last_end; split; rewrite !mulf_eq0 invr_eq0 (negPf e0) ?(negPf q0) ?orbF subr_eq0 //.
by rewrite [M == L]eq_sym.
Qed.

(** FJ07.21 restriction: $\Lambda^{*}$ only cuts the surface, by (17): $M_0+\beta'(\Lambda^{*}-M_0)$ makes $\beta'\sigma_0$ and $\beta'\tau_0$ of $\sigma_0$,
    $\tau_0$, so that it can be chosen to pass through one given point of a ruling, but not of both.
    Hypotheses: none, but $\sigma_0$, $\tau_0$ have a meaning only where $M_0$ is none of the knots. *)
Theorem FJ07_21_restriction u n L M alpha beta scale K :
  first_end u n K (M + scale * (L - M)) M alpha = scale * first_end u n K L M alpha /\
  last_end u K (M + scale * (L - M)) M beta = scale * last_end u K L M beta.
Proof. by rewrite /first_end /last_end; split; ring. Qed.

(** FJ07.21 developable: where $M_0$ is a root, there is for every $\Lambda^{*}$ a net of (13) through $c$ with the first ruling along $v$ and the last along $w$,
    and it spans developable surfaces over all its $N$ pieces.
    Hypotheses: $M_0$ is none of the knots; $v\times w\ne0$. *)
Theorem FJ07_21_developable u n N L M c v w K : K.+1 = (n + N.-1)%N -> (forall i, (i < K.+1)%N -> M - u i != 0) ->
  (forall i, (i < K.+1)%N -> M - u (i + n)%N != 0) -> cross v w != 0 -> root (branches u n c K v w) M ->
  exists d sigma tau, [/\ forall i, (i < K.+1)%N -> cell u n L M c d i, d 0%N = c 0%N + sigma *: v, d K.+1 = c K.+1 + tau *: w &
    forall k, (k < N)%N -> span n (drop_ k u) -> developable (pcurve n (drop_ k u) (drop_ k c)) (pcurve n (drop_ k u) (drop_ k d))].
Proof.
move=> eK off off' nz /(FJ07_20_branches _ _ _ _ off)/(combination nz)[alpha [beta eq_a]].
exists (net u n L M c (c 0%N + first_end u n K L M alpha *: v)), (first_end u n K L M alpha), (last_end u K L M beta).
have [e0 cells] := FJ07_13_exists n L c (c 0%N + first_end u n K L M alpha *: v) off.
split=> //; first exact: FJ07_21_interpolation.
by apply: FJ07_13_developable; rewrite -eK.
Qed.

(** FJ07.21 unique: for given $\Lambda^{*}$ and $M_0$ there is no other net of (13) with $d_0-c_0=\sigma v$ and $d_L-c_L=\tau w$.
    Hypotheses: $M_0$ is none of the knots; $v\times w\ne0$. *)
Theorem FJ07_21_unique u n L M c d v w alpha beta sigma tau K : (forall i, (i < K.+1)%N -> M - u i != 0) ->
  (forall i, (i < K.+1)%N -> M - u (i + n)%N != 0) -> cross v w != 0 -> aim u n c K M - c K.+1 = alpha *: v + beta *: w ->
  (forall i, (i < K.+1)%N -> cell u n L M c d i) -> d 0%N = c 0%N + sigma *: v -> d K.+1 = c K.+1 + tau *: w ->
  [/\ sigma = first_end u n K L M alpha, tau = last_end u K L M beta &
      forall i, (i <= K.+1)%N -> d i = net u n L M c (c 0%N + sigma *: v) i].
Proof.
move=> off off' nz eq_a cells eq0 eqK; have [e0 cells'] := FJ07_13_exists n L c (c 0%N + sigma *: v) off.
have eq_d i : (i <= K.+1)%N -> d i = net u n L M c (c 0%N + sigma *: v) i.
  by apply: (FJ07_13_unique off cells cells'); rewrite eq0 e0.
have := FJ07_20_last off cells; rewrite eq0 eqK -[c K.+1 - aim _ _ _ _ _]opprB eq_a ![_ + _ *: _ - _]addrAC !subrr !add0r.
have := P_inv off off'; rewrite /first_end /last_end.
move: (P u n M 0 K.+1) (\prod_(0 <= i < K.+1) _) (M - u K) (off K (ltnSn K)) => p q e enz pq eq_w.
have [] := @FJ07_21_independent F v w 0 tau (p * sigma - (L - M) / e * alpha) (- ((L - M) / e * beta)) nz.
  by rewrite scale0r add0r eq_w; by_entries k; ring.
move=> es et; split=> //; last by rewrite et; field.
have es' : p * sigma = (L - M) / e * alpha by apply/eqP; rewrite -subr_eq0 -es.
by rewrite -[sigma]mul1r -pq mulrAC es'; ring.
Qed.

(** FJ07.21 branches: for $\Lambda^{*}\ne M_0$ a net of (13) with end rulings along $v$ and $w$ exists iff $M_0$ is a root of the polynomial of (20).
    Hypotheses: $M_0$ is none of the knots; $v\times w\ne0$. *)
Theorem FJ07_21_branches u n L M c v w K : (forall i, (i < K.+1)%N -> M - u i != 0) ->
  (forall i, (i < K.+1)%N -> M - u (i + n)%N != 0) -> cross v w != 0 -> L != M ->
  (exists d sigma tau, [/\ forall i, (i < K.+1)%N -> cell u n L M c d i, d 0%N = c 0%N + sigma *: v & d K.+1 = c K.+1 + tau *: w]) <->
  root (branches u n c K v w) M.
Proof.
move=> off off' nz LM; rewrite -FJ07_20_branches //; split=> [[d [sigma [tau [cells e0 eK]]]] | /(combination nz)[alpha [beta eq_a]]]; last first.
  exists (net u n L M c (c 0%N + first_end u n K L M alpha *: v)), (first_end u n K L M alpha), (last_end u K L M beta).
  have [-> cells] := FJ07_13_exists n L c (c 0%N + first_end u n K L M alpha *: v) off; split=> //.
  exact: FJ07_21_interpolation.
have := FJ07_20_last off cells; rewrite e0 eK ![_ + _ *: _ - _]addrAC !subrr !add0r.
have k0 : (L - M) / (M - u K) != 0 by rewrite mulf_neq0 ?invr_eq0 ?subr_eq0 // -subr_eq0 off.
move: (P _ _ _ _ _) ((L - M) / _) k0 (aim _ _ _ _ _ - _) (opprB (aim u n c K M) (c K.+1)) => p k k0 x <- eq_w.
have: k * triple x v w = 0.
  rewrite -tripleZl (_ : k *: x = p * sigma *: v - tau *: w); first by coordinates; ring.
  by rewrite eq_w; by_entries j; ring.
by move/eqP; rewrite mulf_eq0 (negPf k0) => /eqP.
Qed.

(** FJ07.21 needs_distinct: for $\Lambda^{*}=M^{*}$ the row $d=c$, whose rulings are points, is there for every $M^{*}$. *)
Theorem FJ07_21_needs_distinct u n M c v w K :
  exists d sigma tau, [/\ forall i, (i < K.+1)%N -> cell u n M M c d i, d 0%N = c 0%N + sigma *: v & d K.+1 = c K.+1 + tau *: w].
Proof. by exists c, 0, 0; split=> *; rewrite ?scale0r ?addr0. Qed.
End Ends.
