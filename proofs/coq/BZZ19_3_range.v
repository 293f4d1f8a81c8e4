(* BZZ19, section 3.2: the mapping as a B-spline function, its range, and that it increases strictly.
   Definitions:
     basis n u i       the B-spline function B_i on the piece: the curve of the points 0, ..., 1, ..., 0
     greville n u i    u_i + ... + u_{i+n-1}, n times the Greville abscissa
     inside n u t      t lies on the piece and is none of its ends *)
From Torse Require Import Prelude Blossom Curves FJ07_2 BZZ19_3.
From mathcomp Require Import order ssrnum.
Import Order.TTheory Num.Theory.

Section Basis.
Variable F : fieldType.
Implicit Types (u b : nat -> F) (n i : nat).

Definition basis n u i : {poly F} := curve n u (fun j => (j == i)%:R).
Definition greville n u i : F := \sum_(i <= j < i + n) u j.

(** BZZ19.3 basis: $\sigma(t)=\sum_i\beta_iB_{i,d}(t)$ on each piece.
    Paper: its knots begin with $t_0=\dots=t_{d+1}=0$; clamped ones have $d+1$ zeros, $t_0=\dots=t_d$. *)
Theorem BZZ19_3_basis n u b : curve n u b = \sum_(0 <= i < n.+1) (b i)%:P * basis n u i.
Proof.
rewrite -(blossoms_linear (polys u)); apply: blossom_ext => j; rewrite size_nseq => le_j.
rewrite (bigD1_seq j) ?mem_index_iota ?iota_uniq //= /polys eqxx mulr1 big1 ?addr0 // => i ne_i.
by rewrite eq_sym (negPf ne_i) mulr0.
Qed.

(** BZZ19.3 partition: $\sum_iB_{i,d}(t)=1$.
    Hypotheses: the knots carry the piece, so that its points have a meaning. *)
Theorem BZZ19_3_partition n u : span n u -> \sum_(0 <= i < n.+1) basis n u i = 1.
Proof.
move=> sp; rewrite -polyC1 -(curve_const 1 sp) BZZ19_3_basis; apply: eq_big_nat => i _.
by rewrite polyC1 mul1r.
Qed.

(* $f[x_1,...,x_n]=\sum_k a_k\prod_{j\ne k}w_j$ for $x_j=(a_j,w_j)$. *)
Let total (R : comUnitRingType) (v : seq (R * R)) : R := (\prod_(x <- v) (x.2%:P + x.1 *: 'X))`_1.

Lemma total_polar (R : comUnitRingType) n : polar n (@total R).
Proof.
split=> [v w eq_vw | s x t y v _]; first by rewrite /total (perm_big _ eq_vw).
rewrite /total !big_cons -!coefZ -coefD /comb /=; congr (_`_1); move: (\prod_(j <- v) _) => P.
by rewrite polyCD !polyCM scalerDl -!scalerA -!mul_polyC !mulrDl !mulrDr !mulrA addrACA.
Qed.

Lemma total_at (R : comUnitRingType) (s : seq R) : total [seq at_ t | t <- s] = \sum_(t <- s) t.
Proof.
rewrite /total big_map /=; pose P (r : seq R) := \prod_(t <- r) (1%:P + t *: 'X); rewrite -/(P s).
suff [] : (P s)`_0 = 1 /\ (P s)`_1 = \sum_(t <- s) t by [].
elim: s => [|t s [ih0 ih1]]; first by rewrite /P !big_nil !coefC.
rewrite /P !big_cons -/(P s) mulrDl mul1r -scalerAl !coefD !coefZ !coefXM /= ih0 ih1 mulr0 mulr1 addr0.
by rewrite addrC.
Qed.

(** BZZ19.3 identity: $d\,t$ is the mapping with the coefficients $t_{i+1}+\dots+t_{i+d}$: the start $\sigma(t)=t$ has the Greville abscissae.
    Hypotheses: the knots carry the piece, so that its points have a meaning.
    Paper: takes "a number of values on $T=t$"; others give $\sigma=t$ for $d=1$ only. *)
Theorem BZZ19_3_identity n u : span n u -> curve n u (greville n u) = n%:R * 'X.
Proof.
move=> sp; have := blossoms_unique (@total_polar _ n) (span_polys sp) (size_nseq n (at_ 'X)).
rewrite -map_nseq total_at; have -> : \sum_(t <- nseq n ('X : {poly F})) t = n%:R * 'X.
  by rewrite big_nseq iter_addr_0 mulr_natl.
move=> ->; rewrite /curve map_nseq; apply: blossom_ext => i _; rewrite /knots (map_comp (@at_ _) (polys u)) total_at.
rewrite big_map /polys /greville /= /index_iota addKn -[LHS]/([rmorphism of polyC] _) rmorph_sum.
by [].
Qed.
End Basis.

Section Range.
Variable F : realFieldType.
Implicit Types (u b : nat -> F) (n i : nat) (s t lo hi : F).

(** BZZ19.3 range: on a piece $\sigma$ lies between bounds of its coefficients.
    Hypotheses: $t$ lies on the piece; the knots carry it, so that its points have a meaning. *)
Theorem BZZ19_3_range n u b t lo hi : span n u -> within n u t -> (forall i, (i <= n)%N -> lo <= b i <= hi) ->
  lo <= (curve n u b).[t] <= hi.
Proof.
move=> sp inside bounds.
have ge0 (c : nat -> F) : (forall i, (i <= n)%N -> 0 <= c i) -> 0 <= (curve n u c).[t].
  move=> c0; rewrite horner_curve // -map_nseq; apply: blossom_ge0; rewrite size_nseq // => x.
  by rewrite mem_nseq => /andP[_ /eqP ->].
have shift_ s (x : F) : (curve n u (fun i => s * b i + x)).[t] = s * (curve n u b).[t] + x.
  have <- : (curve n u (fun i => s * b i + x * 1)) = curve n u (fun i => s * b i + x).
    by apply: blossom_ext => i _; rewrite /polys mulr1.
  by rewrite curve_comb curve_const // hornerD !hornerM !hornerC mulr1.
have := ge0 (fun i => 1 * b i + (- lo)); have := ge0 (fun i => -1 * b i + hi); rewrite !shift_ !mul1r !mulN1r subr_ge0 [- _ + _]addrC subr_ge0.
move=> le_hi le_lo; apply/andP; split; [apply: le_lo | apply: le_hi] => i /bounds /andP[l h].
  by rewrite mul1r subr_ge0.
by rewrite mulN1r addrC subr_ge0.
Qed.

(** BZZ19.3 ends: where the knots are $n$-fold at the ends of the piece, $\sigma$ takes them to the first and the last coefficient.
    Hypotheses: the knots carry the piece, so that its points have a meaning. *)
Theorem BZZ19_3_ends n u b a e : span n u -> (forall i, (i < n)%N -> u i = a) -> (forall j, (n <= j < n.*2)%N -> u j = e) ->
  (curve n u b).[a] = b 0%N /\ (curve n u b).[e] = b n.
Proof.
move=> sp eq_a eq_e; rewrite !horner_curve // -[in RHS](blossoms_knots b sp (leq0n n)) -[X in _ /\ _ = X](blossoms_knots b sp (leqnn n)).
have all_at (s : seq nat) y : {in s, forall j, u j = y} -> [seq at_ (u j) | j <- s] = nseq (size s) (at_ y).
  by elim: s => //= j s ih h; rewrite h ?mem_head // ih // => k ks; apply: h; rewrite inE ks orbT.
split; congr blossom; rewrite /knots; apply/esym.
  by rewrite (all_at _ a) ?size_iota // => j; rewrite mem_iota => /andP[_ lt_j]; apply: eq_a.
by rewrite (all_at _ e) ?size_iota // => j; rewrite mem_iota addnn; exact: eq_e.
Qed.

Definition inside n u t := (forall i, (i < n)%N -> u i < t) /\ (forall j, (n <= j < n.*2)%N -> t < u j).

Lemma blossom_gt0 u b (v : seq F) k : (forall t, t \in v -> inside (size v) u t) -> (forall i, (i <= size v)%N -> 0 <= b i) ->
  (k <= size v)%N -> 0 < b k -> 0 < blossom u b [seq at_ t | t <- v].
Proof.
elim: v u b k => [|t v ih] u b k h b_ge0 /= le_k b_k; first by move: b_k; rewrite (eqP (_ : k == 0%N)) -?leqn0.
have [lo hi] := h t (mem_head _ _); rewrite /= in lo hi.
have lt_u i : (i <= size v)%N -> u i < t < u (i + (size v).+1)%N by move=> le_i; rewrite lo ?hi //; lia.
have den i : (i <= size v)%N -> 0 < u (i + (size v).+1)%N - u i.
  by move=> /lt_u /andP[lt1 lt2]; rewrite subr_gt0 (lt_trans lt1).
have nonneg i : (i <= size v)%N -> 0 <= step u (size [seq at_ t | t <- v]).+1 (at_ t) b i.
  move=> le_i; rewrite size_map /step /at_ /= !mul1r divr_ge0 ?(ltW (den i le_i)) //.
  have /andP[lt1 lt2] := lt_u i le_i.
  by rewrite addr_ge0 // mulr_ge0 ?subr_ge0 ?(ltW lt1) ?(ltW lt2) //; apply: b_ge0 => /=; lia.
have inside' x : x \in v -> inside (size v) (shift u) x.
  move=> xv; have [|l r] := h x _; first by rewrite inE xv orbT.
  by split=> i h1; [apply: l | apply: r]; rewrite /=; lia.
have [le_k'|lt_k] := leqP k (size v).
  apply: (ih _ _ k) => //; rewrite size_map /step /at_ /= !mul1r divr_gt0 ?den //; have /andP[lt1 lt2] := lt_u k le_k'.
  by rewrite ltr_paddr ?mulr_gt0 ?mulr_ge0 ?subr_gt0 ?subr_ge0 ?(ltW lt1) //; apply: b_ge0 => /=; lia.
have ek : k = (size v).+1 by lia.
apply: (ih _ _ (size v)) => //; rewrite size_map /step /at_ /= !mul1r divr_gt0 ?den //; have /andP[lt1 lt2] := lt_u (size v) (leqnn _).
rewrite ltr_paddl ?mulr_gt0 ?mulr_ge0 ?subr_gt0 ?subr_ge0 ?(ltW lt2) -?ek //; apply: b_ge0 => /=; lia.
Qed.

Lemma rise b n : b 0%N < b n.+1 -> exists2 i, (i <= n)%N & b i < b i.+1.
Proof.
elim: n => [|n ih] lt_b; first by exists 0%N.
have [lt_n|le_n] := ltP (b n.+1) (b n.+2); first by exists n.+1.
by have [i le_i lt_i] := ih (lt_le_trans lt_b le_n); exists i; rewrite ?(leq_trans le_i).
Qed.

(** BZZ19.5 strict: coefficients that do not decrease, and are not all equal, make $\sigma(s)<\sigma(t)$ for $s<t$ on the piece.
    Hypotheses: $s$ and $t$ lie on the piece; $\beta_0<\beta_d$. *)
Theorem BZZ19_5_strict n u b s t : within n.+1 u s -> within n.+1 u t -> s < t ->
  (forall i, (i <= n)%N -> b i <= b i.+1) -> b 0%N < b n.+1 -> (curve n.+1 u b).[s] < (curve n.+1 u b).[t].
Proof.
move=> in_s in_t lt_st up lt_b; have sp := within_span lt_st in_s in_t.
pose x := (s + t) / 2%:R; pose y := (x + t) / 2%:R.
have [lt_sx lt_xt] : s < x /\ x < t by rewrite !midf_lt.
have [lt_xy lt_yt] : x < y /\ y < t by rewrite !midf_lt.
have inside_ z : s < z -> z < t -> inside n.+1 u z.
  case: in_s in_t => lo _ [_ hi] lt_sz lt_zt.
  by split=> i h; [apply: le_lt_trans (lo i h) lt_sz | apply: lt_le_trans lt_zt (hi i h)].
have within_ z : inside n.+1 u z -> within n.+1 u z by case=> lo hi; split=> i h; apply: ltW; [apply: lo | apply: hi].
have in_x := inside_ x lt_sx lt_xt; have in_y := inside_ y (lt_trans lt_sx lt_xy) lt_yt.
apply: le_lt_trans (BZZ19_5_monotone in_s (within_ _ in_x) (ltW lt_sx) up) _.
apply: lt_le_trans _ (BZZ19_5_monotone (within_ _ in_y) in_t (ltW lt_yt) up).
rewrite !horner_curve //; apply: lt_le_trans (@mixed_le _ _ _ _ _ _ 1 n sp (within_ _ in_x) (within_ _ in_y) (ltW lt_xy) up _) => //.
rewrite [X in X < _]/(blossom u b (at_ x :: nseq n (at_ x))) /cat -[X in _ < X]/(blossom u b (at_ y :: nseq n (at_ x))).
have -> : at_ y = comb 1 (at_ x) (y - x) (direction F) by rewrite /comb /at_ /= !mul1r mulr1 mulr0 addr0 addrC subrK.
rewrite (blossoms_multilinear _ _ [::]) mul1r ltr_addl mulr_gt0 ?subr_gt0 // (@direction_first _ n) ?size_nseq // -map_nseq.
have width i : (i <= n)%N -> u i < u (i + n.+1)%N.
  by case: in_x => lo hi le_i; apply: lt_trans (lo i _) (hi _ _); lia.
have [k le_k lt_k] := rise lt_b; apply: (@blossom_gt0 _ _ _ k); rewrite ?size_nseq //.
- by move=> z; rewrite mem_nseq => /andP[_ /eqP ->]; case: in_x => lo hi; split=> i h; [apply: lo | apply: hi]; lia.
- by move=> i le_i; rewrite slope_ge0 ?(ltW (width i le_i)).
by rewrite /slope divr_gt0 ?subr_gt0 // width.
Qed.

(** BZZ19.5 strict_needs_rise: where all coefficients are equal $\sigma$ is constant. *)
Theorem BZZ19_5_strict_needs_rise n u (x s t : F) : span n u -> (curve n u (fun=> x)).[s] = (curve n u (fun=> x)).[t].
Proof. by move=> sp; rewrite curve_const // !hornerC. Qed.
End Range.

(** BZZ19.3 onto: over a real closed field $\sigma$ takes every value between its values at $s\le t$, so that it maps $[a,b]$ onto
    $[\beta_0,\beta_n]$ where the knots are $n$-fold at $a$ and $b$.
    Hypotheses: a real closed field, such as the real numbers. *)
Theorem BZZ19_3_onto (F : rcfType) n (u b : nat -> F) s t y : s <= t -> (curve n u b).[s] <= y <= (curve n u b).[t] ->
  exists2 x, s <= x <= t & (curve n u b).[x] = y.
Proof.
move=> le_st /andP[le_y ge_y].
have [|x x_in /rootP] := @poly_ivt F (curve n u b - y%:P) s t le_st.
  by rewrite !hornerD !hornerN !hornerC subr_le0 subr_ge0 le_y.
by rewrite hornerD hornerN hornerC => /eqP; rewrite subr_eq0 => /eqP; exists x.
Qed.

(** BZZ19.3 joint: neighbouring pieces have the same value at the knot $t_k$ between them: the mapping is continuous.
    Hypotheses: $d\ge1$; the knots carry both pieces, so that their points have a meaning. *)
Theorem BZZ19_3_joint (F : fieldType) n (u b : nat -> F) : span n u -> span n (shift u) -> (0 < n)%N ->
  (curve n u b).[u n] = (curve n (shift u) (shift b)).[u n].
Proof.
move=> sp sp'; rewrite !horner_curve //; case: n sp sp' => // n; elim: n u b => [|n ih] u b sp sp' _.
  have u0 : u 1%N - u 0%N != 0 by rewrite -unitfE; apply: sp.
  have u1 : u 2%N - u 1%N != 0 by rewrite -unitfE; apply: (sp' 0%N 1%N).
  rewrite /= /step /shift /at_ /= !addn1 !mul1r !subrr !mul0r add0r addr0 ![_ * b 1%N]mulrC !mulfK //.
have first (w c : nat -> F) x : blossom w c (nseq n.+2 x) = blossom (shift w) (step w n.+2 x c) (nseq n.+1 x) by rewrite /= size_nseq.
rewrite !first; exact: ih (span_shift sp) (span_shift sp') isT.
Qed.
