(* FJ07, section 4: parallel and meeting end rulings, and what fails there. *)
From Torse Require Import Prelude Blossom Curves Points Dependence Segments FJ07_2 FJ07_3_net FJ21_4 FJ07_2_cones FJ07_3_generic FJ07_4.

Section Clamped.
Variables (F : fieldType) (m : nat).
Implicit Types (u : nat -> F) (c : nat -> 'rV[F]_m) (n N : nat).

(** FJ07.20 clamped: with $u_0=\dots=u_{n-1}=a$ the curve starts in $c_0$, so that the ruling at $a$ is the line $c_0d_0$; likewise at the
    end of the last piece, $u_L=\dots=u_{L+n-1}=b$.
    Hypotheses: these knots are equal; the knots carry the first and the last piece, so that their points have a meaning. *)
Theorem FJ07_20_clamped n N u c a b : span n u -> span n (drop_ N u) -> (forall i, (i < n)%N -> u i = a) ->
  (forall i, (i < n)%N -> u (N + (n + i))%N = b) ->
  ev (pcurve n u c) a = c 0%N /\ ev (pcurve n (drop_ N u) (drop_ N c)) b = c (N + n)%N.
Proof.
move=> sp spN eq_a eq_b; split; apply/rowP=> k; rewrite !mxE horner_curve //.
  rewrite -[RHS](blossoms_knots (coord c k) sp (leq0n n)); congr blossom.
  rewrite /knots -[in LHS](size_iota 0 n); apply/esym/map_all => i; rewrite mem_iota => /andP[_ lt_i].
  by rewrite eq_a.
rewrite -[RHS](blossoms_knots (coord (drop_ N c) k) spN (leqnn n)); congr blossom.
rewrite /knots -[in LHS](size_iota n n); apply/esym/map_all => i; rewrite mem_iota => /andP[le_i lt_i].
by rewrite /drop_ -(subnKC le_i) eq_b //; lia.
Qed.
End Clamped.

Section Special.
Variable F : fieldType.
Implicit Types (u h : nat -> F) (c d : nat -> 'rV[F]_3) (v w : 'rV[F]_3) (L M sigma tau : F) (n i k K : nat).

(** FJ07.20 parallel: for end rulings along the same $v$ the polynomial is 0, every $M_0$ a root; but a net of (13) with $\Lambda^{*}\ne M^{*}$ has
    such end rulings only if $(c_L-a(M^{*}))\times v=0$, two equations more.
    Hypotheses: $\Lambda^{*}\ne M^{*}$; $M^{*}$ is none of $u_0,\dots,u_{L-1}$, so that $a(M^{*})$ has a meaning. *)
Theorem FJ07_20_parallel u n L M c d v s sigma tau K : (forall i, (i < K.+1)%N -> M - u i != 0) -> L != M ->
  (forall i, (i < K.+1)%N -> cell u n L M c d i) -> d 0%N = c 0%N + sigma *: v -> d K.+1 = c K.+1 + tau *: v ->
  branches u n c K v (s *: v) = 0 /\ cross (c K.+1 - aim u n c K M) v = 0.
Proof.
move=> off LM cells e0 eK; split.
  rewrite /branches (_ : fixed (s *: v) = s%:P *: fixed v); last by apply/rowP=> k; rewrite !mxE polyCM.
  by move: (fixed v) (s%:P) (chord _ _ _ _) => p t q; coordinates; hide_entries; ring.
have := FJ07_20_last off cells; rewrite e0 eK ![_ + _ *: _ - _]addrAC !subrr !add0r.
have k0 : (L - M) / (M - u K) != 0 by rewrite mulf_neq0 ?invr_eq0 ?subr_eq0 // -subr_eq0 off.
move: (P _ _ _ _ _) ((L - M) / _) k0 (c K.+1 - _) => p k k0 x eq_w.
apply: (scalerI k0); rewrite scaler0 -crossZl (_ : k *: x = (tau - p * sigma) *: v) ?crossZl ?cross_self ?scaler0 //.
by rewrite scalerBl eq_w; by_entries j; ring.
Qed.

(** FJ07.20 cylinder: for end rulings along $v$ the rows $d_i=c_i+h_iv$ span a cylinder through the curve on every piece, whatever $h$. *)
Theorem FJ07_20_cylinder n u c h v k (d := fun i => c i + h i *: v) :
  pcurve n (drop_ k u) (drop_ k d) - pcurve n (drop_ k u) (drop_ k c) = curve n (drop_ k u) (drop_ k h) *: fixed v /\
  developable (pcurve n (drop_ k u) (drop_ k c)) (pcurve n (drop_ k u) (drop_ k d)).
Proof. exact: FJ07_4_cylinder. Qed.

(** FJ07.20 cone: for end rulings that meet in $O$ the rows $d_i=c_i+\beta(O-c_i)$, with proportional sides for $\alpha=1-\beta$, span a cone
    through the curve: on every piece $d(t)-c(t)=\beta(O-c(t))$.
    Hypotheses: the knots carry the piece, so that its points have a meaning. *)
Theorem FJ07_20_cone n u c (O : 'rV[F]_3) beta k (d := fun i => c i + beta *: (O - c i))
    (C := pcurve n (drop_ k u) (drop_ k c)) (D := pcurve n (drop_ k u) (drop_ k d)) : span n (drop_ k u) ->
  [/\ forall K, proportional (1 - beta) c d K, D - C = beta%:P *: (fixed O - C) & developable C D].
Proof.
move=> sp; have eq_D : D = fixed (beta *: O) + (1 - beta)%:P *: C.
  rewrite /D /C -pcurve_move //; apply: pcurve_ext => i _; rewrite /drop_ /d.
  by by_entries j; ring.
split.
- by move=> K i _; rewrite /d; by_entries j; ring.
- rewrite eq_D (_ : fixed (beta *: O) = beta%:P *: fixed O) ?polyCB; last by apply/rowP=> j; rewrite !mxE polyCM.
  by move: (fixed O) (C) => o p; rewrite polyC1; by_entries j; ring.
apply/FJ07_T1_converse; left; rewrite eq_D (_ : pderiv (_ + _) = (1 - beta)%:P *: pderiv C) ?crossZr ?cross_self ?scaler0 //.
by apply/rowP=> j; rewrite !mxE derivD derivM !derivC mul0r !add0r.
Qed.

(** FJ07.20 meeting: if the line through $c_0$ along $v$ meets that through $c_L$ along $w$, or they are parallel, $[c_L-c_0,v,w]=0$: the degree of
    the polynomial of (20) drops below $L-1$. *)
Theorem FJ07_20_meeting u n c K v w sigma tau : c 0%N + sigma *: v = c K.+1 + tau *: w ->
  (size (branches u n c K v w) <= K)%N.
Proof.
move=> meet; have [sz co] := FJ07_20_count u n c K v w.
have top : triple (c K.+1 - c 0%N) v w = 0.
  rewrite (_ : c K.+1 - c 0%N = sigma *: v - tau *: w); first by coordinates; ring.
  have -> : c K.+1 = c 0%N + sigma *: v - tau *: w by rewrite meet addrK.
  by by_entries k; ring.
move: sz; rewrite leq_eqVlt => /orP[/eqP sz|//]; move: co; rewrite top.
by rewrite -[K in _`_K]/(K.+1.-1) -sz -lead_coefE => /eqP; rewrite lead_coef_eq0 => /eqP ->; rewrite size_poly0.
Qed.

(** FJ07.21 needs_off: at $M_0=u_{i+n}$, $i<L$, the last vertex does not depend on $d_0$: nets of (13) from all points $d_0$ end in the same $d_L$.
    Hypotheses: $M_0$ is none of $u_0,\dots,u_{L-1}$, so that the net has a meaning. *)
Theorem FJ07_21_needs_off u n L M c (d0 d0' : 'rV[F]_3) K j : (forall i, (i < K.+1)%N -> M - u i != 0) -> (j < K.+1)%N -> M = u (j + n)%N ->
  net u n L M c d0 K.+1 = net u n L M c d0' K.+1.
Proof.
move=> off lt_j eq_M; have p0 : P u n M 0 K.+1 = 0.
  by rewrite /P (big_cat_nat _ _ _ (leq0n j) (ltnW lt_j)) /= [\prod_(j <= _ < _) _]big_ltn // -eq_M subrr !mul0r mulr0.
have [_ cells] := FJ07_13_exists n L c d0 off; have [_ cells'] := FJ07_13_exists n L c d0' off.
have := FJ07_20_last off cells; have := FJ07_20_last off cells'; rewrite p0 !scale0r !add0r.
by move=> /(canRL (subrK _)) -> /(canRL (subrK _)) ->.
Qed.

(** FJ07.21 needs_skew: with parallel end rulings a root $M_0$ need not be a net: for $n=1$, $c_1-c_0$ not along $v$, and $w=v$ every $M_0$ is a
    root and no net of (13) with $\Lambda^{*}\ne M_0$ has both end rulings along $v$. *)
Theorem FJ07_21_needs_skew u L M c v : M - u 0%N != 0 -> L != M -> cross (c 1%N - c 0%N) v != 0 ->
  root (branches u 1 c 0 v v) M /\
  ~ exists d sigma tau, [/\ cell u 1 L M c d 0, d 0%N = c 0%N + sigma *: v & d 1%N = c 1%N + tau *: v].
Proof.
move=> off LM nz; split.
  by rewrite /root /branches; move: (fixed v) (chord _ _ _ _) => p q; rewrite (_ : triple q p p = 0) ?horner0 //; coordinates; ring.
move=> [d [sigma [tau [cells e0 e1]]]]; move/negP: nz; apply.
have cells' i : (i < 1)%N -> cell u 1 L M c d i by case: i.
have off' i : (i < 1)%N -> M - u i != 0 by case: i.
have [_] := FJ07_20_parallel 1 off' LM cells' e0 e1.
by rewrite /aim big_geq // addr0 divff // mul1r /P big_geq // scale1r => ->.
Qed.
End Special.
