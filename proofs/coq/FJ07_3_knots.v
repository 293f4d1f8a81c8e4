(* FJ07, section 3, where M* is a knot: the closed forms (14) to (16) without denominators, and what equation (13) then asks of the curve.
   Definitions:
     starts u M a b       (M - u_a) ... (M - u_{b-1})
     finishes u n M a b   (M - u_{a+n}) ... (M - u_{b-1+n}) *)
From Torse Require Import Prelude Joints Blossom Curves Points FJ07_3_net FJ07_3_blossoms.

Section Products.
Variables (F : fieldType) (m : nat).
Implicit Types (u : nat -> F) (c d : nat -> 'rV[F]_m) (L M : F) (n i j k : nat).

Definition starts u M a b := \prod_(a <= j < b) (M - u j).
Definition finishes u n M a b := \prod_(a <= j < b) (M - u (j + n)%N).

Lemma starts_last u M k : starts u M 0 k.+1 = starts u M 0 k * (M - u k).
Proof. by rewrite /starts big_nat_recr. Qed.

Lemma finishes_last u n M a k : (a <= k)%N -> finishes u n M a k.+1 = finishes u n M a k * (M - u (k + n)%N).
Proof. by move=> le_a; rewrite /finishes big_nat_recr. Qed.

Lemma finishes_none u n M k : finishes u n M k k = 1.
Proof. by rewrite /finishes big_geq. Qed.

(* (13) times a number. *)
Lemma ruling_step (s w z f : F) (x y e : 'rV[F]_m) : w *: x = z *: y + f *: e -> (s * w) *: x = z *: (s *: y) + (s * f) *: e.
Proof. by move=> h; rewrite -scalerA h scalerDr !scalerA [s * z]mulrC. Qed.

Lemma vertex_step (s w z p q : F) (x y e f : 'rV[F]_m) : w *: x = z *: y + p *: e + q *: f ->
  (s * w) *: x = z *: (s *: y) + (s * p) *: e + (s * q) *: f.
Proof. by move=> h; rewrite -scalerA h !scalerDr !scalerA [s * z]mulrC. Qed.

(** FJ07.16 cleared: $\prod_{i<N}(M^{*}-u_i)\,(d_N-c_N)=\prod_{i<N}(M^{*}-u_{i+n})\,(d_0-c_0)
    +(\Lambda^{*}-M^{*})\sum_{i=0}^{N-1}\prod_{j<i}(M^{*}-u_j)\prod_{i<j<N}(M^{*}-u_{j+n})\,(c_{i+1}-c_i)$ for every net of (13).
    Hypotheses: none: $M^{*}$ may be a knot, and at $M^{*}=u_j$ with $j<N$ the left side is 0.
    Paper: divides. *)
Theorem FJ07_16_cleared u n L M c d k : (forall i, (i < k)%N -> cell u n L M c d i) ->
  starts u M 0 k *: (d k - c k) = finishes u n M 0 k *: (d 0%N - c 0%N)
    + (L - M) *: \sum_(0 <= i < k) (starts u M 0 i * finishes u n M i.+1 k) *: (c i.+1 - c i).
Proof.
elim: k => [|k ih] cells; first by rewrite /starts /finishes !big_geq // scaler0 addr0.
have {}ih : starts u M 0 k *: (d k - c k) = _ := ih (fun i lt_i => cells i (ltnW lt_i)).
have /FJ07_13_rulings h := cells k (ltnSn k).
rewrite starts_last (ruling_step (starts u M 0 k) h) ih finishes_last // big_nat_recr //= finishes_none mulr1.
rewrite (eq_big_nat _ _ (F1 := fun i => (starts u M 0 i * finishes u n M i.+1 k.+1) *: (c i.+1 - c i))
  (F2 := fun i => (M - u (k + n)%N) *: ((starts u M 0 i * finishes u n M i.+1 k) *: (c i.+1 - c i)))); last first.
  by move=> i /andP[_ lt_i]; rewrite finishes_last // scalerA; congr (_ *: _); rewrite mulrA mulrC.
rewrite -scaler_sumr; move: (\sum_(0 <= i < k) _) (finishes u n M 0 k) (starts u M 0 k) (M - u (k + n)%N) => S f s z.
by by_entries j; ring.
Qed.

(** FJ07.16 knot: at $M^{*}=u_j$ the cells $0..j$ bind the first vertex:
    $\prod_{i\le j}(u_j-u_{i+n})\,(d_0-c_0)=(u_j-\Lambda^{*})\sum_{i\le j}\prod_{l<i}(u_j-u_l)\prod_{i<l\le j}(u_j-u_{l+n})\,(c_{i+1}-c_i)$, and say nothing of $d_{j+1}$.
    Paper: passes over it. *)
Theorem FJ07_16_knot u n L c d j (M := u j) : (forall i, (i <= j)%N -> cell u n L M c d i) ->
  finishes u n M 0 j.+1 *: (d 0%N - c 0%N) = (M - L) *: \sum_(0 <= i < j.+1) (starts u M 0 i * finishes u n M i.+1 j.+1) *: (c i.+1 - c i).
Proof.
move=> cells; have := FJ07_16_cleared (k := j.+1) cells; rewrite starts_last subrr mulr0 scale0r => /esym/eqP.
by rewrite addr_eq0 -scaleNr opprB => /eqP.
Qed.

(** FJ07.14 cleared: $\prod_{i<N}(M^{*}-u_i)\,d_N=\prod_{i<N}(M^{*}-u_{i+n})\,d_0+(u_n-\Lambda^{*})\prod_{1\le i<N}(M^{*}-u_{i+n})\,c_0
    +(\Lambda^{*}-u_{N-1})\prod_{i<N-1}(M^{*}-u_i)\,c_N+(M^{*}-\Lambda^{*})\sum_{i=1}^{N-1}(u_{i+n}-u_{i-1})\prod_{j<i-1}(M^{*}-u_j)\prod_{i<j<N}(M^{*}-u_{j+n})\,c_i$.
    Hypotheses: $N\ge1$; $M^{*}$ may be a knot. *)
Theorem FJ07_14_cleared u n L M c d k : (forall i, (i < k.+1)%N -> cell u n L M c d i) ->
  starts u M 0 k.+1 *: d k.+1 = finishes u n M 0 k.+1 *: d 0%N + ((u n - L) * finishes u n M 1 k.+1) *: c 0%N
    + ((L - u k) * starts u M 0 k) *: c k.+1
    + (M - L) *: \sum_(1 <= i < k.+1) ((u (i + n)%N - u i.-1) * starts u M 0 i.-1 * finishes u n M i.+1 k.+1) *: c i.
Proof.
have solve i : cell u n L M c d i -> (M - u i) *: d i.+1 = (M - u (i + n)%N) *: d i + (u (i + n)%N - L) *: c i + (L - u i) *: c i.+1.
  by rewrite /cell -addrA => ->; rewrite -[in RHS]opprB scaleNr addKr.
elim: k => [|k ih] cells.
  rewrite /starts /finishes !big_nat1 !big_geq // scaler0 addr0 !mulr1 (solve 0%N) ?add0n //; exact: cells.
have {}ih := ih (fun i lt_i => cells i (ltnW lt_i)); have h := solve _ (cells k.+1 (ltnSn _)).
rewrite starts_last (vertex_step (starts u M 0 k.+1) h) ih.
rewrite !(finishes_last _ _ _ (leq0n _)) !(finishes_last _ _ _ (ltn0Sn _)) [in RHS]big_nat_recr //= finishes_none mulr1.
rewrite (eq_big_nat _ _ (F1 := fun i => ((u (i + n)%N - u i.-1) * starts u M 0 i.-1 * finishes u n M i.+1 k.+2) *: c i)
  (F2 := fun i => (M - u (k.+1 + n)%N) *: (((u (i + n)%N - u i.-1) * starts u M 0 i.-1 * finishes u n M i.+1 k.+1) *: c i))); last first.
  by move=> i /andP[_ lt_i]; rewrite finishes_last // scalerA; congr (_ *: _); rewrite mulrA mulrC.
rewrite -scaler_sumr starts_last.
move: (\sum_(1 <= i < k.+1) _) (finishes u n M 0 k.+1) (finishes u n M 1 k.+1) (starts u M 0 k) (u (k.+1 + n)%N) => S f g s z.
by by_entries j; ring.
Qed.
End Products.

Section Smooth.
Variable F : fieldType.
Implicit Types (u b : nat -> F) (n k : nat).

Lemma any_argument (L M : F) x : L != M -> x = comb ((x.1 - x.2 * M) / (L - M)) (at_ L) ((x.2 * L - x.1) / (L - M)) (at_ M).
Proof. by rewrite -subr_eq0; case: x => a w d; rewrite /comb /at_ /=; congr (_, _); field. Qed.

(** FJ07.13 smooth: at an inner knot $M^{*}=u_{k+n}=\dots=u_{k+n+r}$ of multiplicity $r+1$ between two pieces, and for $\Lambda^{*}\ne M^{*}$, equation (13) in the cells
    $k,\dots,k+n+r$ of both pieces asks that they join with one derivative more than such a knot allows,
    $c_k[M^{*\langle r\rangle},v_1,\dots,v_{n-r}]=c_{k+r+1}[M^{*\langle r\rangle},v_1,\dots,v_{n-r}]$, class $C^{n-r}$; for $r=0$ they are one polynomial. A spline that
    needs all its knots there has no net with this $M^{*}$.
    Hypotheses: $\Lambda^{*}\ne M^{*}$; the knots carry both pieces, so that their points have a meaning.
    Paper: passes over it. *)
Theorem FJ07_13_smooth m u n r k L M (c d : nat -> 'rV[F]_m) v : (forall i, (n <= i <= n + r)%N -> u (k + i)%N = M) -> L != M ->
  span n (drop_ k u) -> span n (drop_ (k + r.+1) u) -> (forall i, (k <= i <= k + n + r)%N -> cell u n L M c d i) ->
  (r + size v)%N = n -> pblossom (drop_ k u) (drop_ k c) (nseq r (at_ M) ++ v)
    = pblossom (drop_ (k + r.+1) u) (drop_ (k + r.+1) c) (nseq r (at_ M) ++ v).
Proof.
move=> eM LM sp sp' cells sz.
have dropD (T : Type) (w : nat -> T) i : drop_ r.+1 (drop_ k w) i = drop_ (k + r.+1) w i by rewrite /drop_ addnA.
case: v sz => [|x v] /= sz.
  have {sz} er : r = n by rewrite -sz addn0.
  subst r.
  have e : c (k + n)%N = c (k + n).+1.
    have := cells (k + n)%N; rewrite leq_addr leq_addr => /(_ isT).
    rewrite /cell -addnA !eM ?leqnn ?leq_addr // subrr !scale0r addr0 -opprB scaleNr addrC -scalerBr => /eqP.
    by rewrite scaler_eq0 subr_eq0 (negPf LM) subr_eq0 => /eqP.
  rewrite cats0; apply/rowP=> j; rewrite !mxE.
  rewrite -{1}(@knots_same _ (drop_ k u) n n M); last by move=> l h; apply: eM; clear -h; lia.
  rewrite -(@knots_same _ (drop_ (k + n.+1) u) 0 n M); last by move=> l h; rewrite /drop_ -addnA; apply: eM; clear -h; lia.
  by rewrite !blossoms_knots // /coord /drop_ addn0 e addnS.
have sz' : (r.+1 + size v)%N = n by rewrite -sz addSnnS.
have nseqS (y : F * F) : nseq r y ++ y :: v = y :: nseq r y ++ v by elim: (r) => //= r' ->.
have atM (b : nat -> 'rV[F]_m) l : blossom (drop_ k u) (coord (drop_ k b) l) (at_ M :: nseq r (at_ M) ++ v)
    = blossom (drop_ (k + r.+1) u) (coord (drop_ (k + r.+1) b) l) (at_ M :: nseq r (at_ M) ++ v).
  have sp2 : span n (drop_ r.+1 (drop_ k u)) by move=> i j h1 h2; rewrite !dropD; apply: sp'.
  rewrite -[at_ M :: _]/(nseq r.+1 (at_ M) ++ v) (blossoms_joint _ sz' sp sp2); last by move=> i h; apply: eM; lia.
  rewrite (@blossom_ext_knots _ _ (drop_ (k + r.+1) u)); last by move=> i _; exact: dropD.
  by apply: blossom_ext => i _; rewrite -[LHS]/(coord (drop_ r.+1 (drop_ k b)) l i) /coord dropD.
have rel j : (j <= r.+1)%N -> span n (drop_ (k + j) u) -> related (drop_ (k + j) u) n L M (drop_ (k + j) c) (drop_ (k + j) d).
  by move=> le_j spj; apply/FJ07_T1_piece => // i lt_i; apply/cell_drop; apply: cells; clear -le_j lt_i; lia.
have szw : (size (nseq r (at_ M) ++ v)).+1 = n by rewrite size_cat size_nseq -sz'.
have r0 := rel 0%N isT; rewrite addn0 in r0; have /rowP {}r0 := r0 sp _ szw; have /rowP r1 := rel r.+1 (leqnn _) sp' _ szw.
have move_x w b y : span n w -> blossom w b (nseq r (at_ M) ++ y :: v) = blossom w b (y :: nseq r (at_ M) ++ v).
  by move=> spw; apply: (@blossom_move F); rewrite size_nseq (_ : (r + size v).+1 = n).
have atL l : blossom (drop_ k u) (coord (drop_ k c) l) (at_ L :: nseq r (at_ M) ++ v)
    = blossom (drop_ (k + r.+1) u) (coord (drop_ (k + r.+1) c) l) (at_ L :: nseq r (at_ M) ++ v).
  by have := r0 l; have := r1 l; rewrite !mxE => -> ->; exact: atM.
have lin w b s y t z : blossom w b (comb s y t z :: nseq r (at_ M) ++ v) = s * blossom w b (y :: nseq r (at_ M) ++ v) + t * blossom w b (z :: nseq r (at_ M) ++ v).
  exact: (@blossoms_multilinear F w b [::] (nseq r (at_ M) ++ v)).
apply/rowP=> l; rewrite !mxE !move_x // (any_argument x LM).
by rewrite !lin atL atM.
Qed.

(** FJ07.13 smooth_needs_distinct: for $\Lambda^{*}=M^{*}$ at the inner knot 1 of the knots $0,1,2$, $n=1$, the net $d=c$ of the bent polygon $0,0,1$ obeys (13).
    Hypotheses: none. *)
Theorem FJ07_13_smooth_needs_distinct (u := fun i : nat => i%:R : F) (c := fun i : nat => const_mx (i == 2%N)%:R : 'rV[F]_1) :
  [/\ span 1 (drop_ 0 u), span 1 (drop_ 1 u), forall i, cell u 1 1 1 c c i &
      pblossom (drop_ 0 u) (drop_ 0 c) [:: at_ 2%:R] <> pblossom (drop_ 1 u) (drop_ 1 c) [:: at_ 2%:R]].
Proof.
have sp k : span 1 (drop_ k u).
  move=> [|//] j _ /andP[h1 h2]; have -> : j = 1%N by lia.
  by rewrite /drop_ /u addn0 addn1 mulrSr addrC addKr unitr1.
split=> //; move/rowP/(_ 0); rewrite !mxE /= /step /drop_ /u /coord /= !mxE /= => /eqP.
have e1 : 2%:R - 1 = 1 :> F by rewrite mulr2n addrK.
rewrite !mulr0 !mulr1 -[(1 + (0 + 1))%N]/2%N -[(1 + 0)%:R]/(1 : F) e1 !addr0 ?add0r ?mul0r ?divr1.
by rewrite eq_sym oner_eq0.
Qed.
End Smooth.
