(* The vertices of a finer list of knots, each from the piece of the curve that the first of its knots in the domain belongs to, are those of one piece.
   Definitions:
     holds_at e n u p v J     each knot y inside the domain of u, degree n, that is not behind v_{J+1} and follows one of v_{J+1-p}, ..., v_J in that domain, is among
                              the knots of v, e times more often
     holds_knots e n u p v    the same for the knots that are not behind the domain of v, degree p, and follow any knot of v in that of u *)
From Torse Require Import Prelude Blossom Curves Points Insertion Executable Executable_knots Executable_splines Executable_mappings Executable_joints
  Executable_surface.
From mathcomp Require Import order ssrnum.
Import Order.TTheory Num.Theory.

Section Windows.
Variable F : realFieldType.
Implicit Types (u v : seq F) (c : nat -> F) (n p e k i j h l J : nat) (s t y : F) (a : seq (F * F)).
Local Notation K := (ordered F).
Local Notation at_list := (nth 0).
Local Notation valid := (valid (fun x y : F => x < y)).
Local Notation piece n i u := (drop_ (i.+1 - n) u).

Definition holds_at e n u p v J := forall l y, (J.+1 - p <= l <= J)%N -> y \in u -> at_list u n.-1 <= at_list v l < y -> y < at_list u (size u - n) ->
  y <= at_list v J.+1 -> (count_mem y u + e <= count_mem y v)%N.
Definition holds_knots e n u p v := forall x y, x \in v -> y \in u -> at_list u n.-1 <= x < y -> y < at_list u (size u - n) ->
  y <= at_list v (size v - p) -> (count_mem y u + e <= count_mem y v)%N.

Lemma holds_pieces e n u p v J : valid p v -> holds_knots e n u p v -> (p.-1 <= J < size v - p)%N -> holds_at e n u p v J.
Proof.
move=> hv H bJ l y /andP[_ le_l] yu l_y y_L y_J; have [p0 le_p _] := bounds_of hv.
have lt_l : (l < size v)%N by move: le_l bJ p0 le_p; clear; lia.
apply: (H _ _ (mem_nth 0 lt_l) yu l_y y_L).
by apply: le_trans y_J _; apply: (knots_up hv); move: bJ p0 le_p; clear; lia.
Qed.

Lemma lies_under n u t : valid n u -> at_list u n.-1 <= t -> lies n u t (interval K n u t).
Proof.
move=> hv le_t; have [n0 le_n _] := bounds_of hv; have [in_t|/ltW out] := leP t (at_list u (size u - n)).
  by apply: lies_in; rewrite // le_t.
have -> : interval K n u t = interval K n u (at_list u (size u - n)).
  congr last; apply/eq_in_filter => l; rewrite mem_iota => b; have {}b : (n.-1 <= l < n.-1 + (size u - n - n.-1))%N := b.
  congr (_ && _); rewrite /= -!leNgt.
  have le_l : at_list u l <= at_list u (size u - n) by apply: (knots_up hv); move: b n0 le_n; clear; lia.
  by rewrite le_l (le_trans le_l).
have dom : at_list u n.-1 <= at_list u (size u - n) <= at_list u (size u - n) by rewrite lexx andbT (knots_up hv) //; move: n0 le_n; clear; lia.
have [b le_L up in_L] := lies_in hv dom; split=> //; first exact: le_trans le_L out.
right; split=> //; case: in_L => [lt_L|[]] //; move: lt_L; rewrite ltNge (knots_up hv) //; move: b n0 le_n; clear; lia.
Qed.

Lemma piece_ofE n u v k i : valid n u -> (exists2 l, (i <= l < i + k)%N & at_list u n.-1 <= at_list v l) ->
  exists l h, [/\ (i <= l < i + k)%N, forall q, (i <= q < l)%N -> at_list v q < at_list u n.-1, lies n u (at_list v l) h & (piece_of K n u v k i).-1 = (h.+1 - n)%N].
Proof.
move=> hv; have [n0 _ _] := bounds_of hv; elim: k i => [|k ih] i [l in_l le_l]; first by move: in_l; clear; lia.
rewrite /piece_of [iota _ _]/= [map _ _]/= /piece_under /=; have [lt_i|le_i] := ltP (at_list v i) (at_list u n.-1).
  have [|q [h [in_q before h_q e_h]]] := ih i.+1.
    exists l => //; move: in_l; rewrite leq_eqVlt => /andP[/orP[/eqP e|lt_l] h_l]; last by rewrite lt_l addSnnS.
    by move: lt_i; rewrite e ltNge le_l.
  exists q, h; split=> //; first by move: in_q; clear; lia.
  by move=> r /andP[]; rewrite leq_eqVlt => /orP[/eqP <- //|lt_r] h_r; apply: before; rewrite lt_r.
exists i, (interval K n u (at_list v i)); have h_i := lies_under hv le_i; split=> //; [by move: in_l; clear; lia | by move=> q; clear; lia |].
have [b _ _ _] := h_i; rewrite /piece_at; case: (interval _ _ _ _) b => [|h] b; rewrite nat_ltbE ifT /=; move: b n0; clear; lia.
Qed.

Lemma piece_of_before n u v k i : (forall q, (i <= q < i + k)%N -> at_list v q < at_list u n.-1) -> piece_of K n u v k i = 0%N.
Proof.
elim: k i => // k ih i before; rewrite /piece_of [iota _ _]/= [map _ _]/= /piece_under /= before; last by rewrite leqnn addnS ltnS leq_addr.
by apply: ih => q /andP[lt_q h_q]; apply: before; rewrite (ltnW lt_q) -addSnnS.
Qed.

Section Piece.
Variables (n p e : nat) (u v : seq F) (J j : nat).
Hypotheses (hu : valid n u) (hv : valid p v) (H : holds_at e n u p v J).
Hypotheses (in_J : (p.-1 <= J < size v - p)%N) (up_J : at_list v J < at_list v J.+1) (h_j : lies n u (at_list v J) j).

Lemma bounds_ : [/\ (0 < n)%N, (n + n <= size u)%N, (0 < p)%N & (p + p <= size v)%N].
Proof. by have [? ? _] := bounds_of hu; have [? ? _] := bounds_of hv. Qed.

(* A knot of u after its piece that holds v_J: it is not before v_{J+1}, and one of v if it is that. *)
Lemma later y : y \in u -> at_list u j < y -> y < at_list u (size u - n) ->
  at_list v J.+1 <= y /\ (y <= at_list v J.+1 -> (count_mem y u + e <= count_mem y v)%N).
Proof.
have [n0 le_n p0 le_p] := bounds_; have [b le_j up_j in_j] := h_j => yu lt_y y_L.
have lt_j : (j.+1 < size u)%N by move: b n0 le_n; clear; lia.
have ge_y := next_knot hu lt_j yu lt_y.
have J_y : at_list v J < y.
  by case: in_j => [lt_J|[e_L _]]; [exact: lt_le_trans lt_J ge_y | move: y_L; rewrite -e_L ltNge ge_y].
have often : y <= at_list v J.+1 -> (count_mem y u + e <= count_mem y v)%N.
  apply: (H (l := J)) => //; first by move: in_J p0; clear; lia.
  by rewrite J_y andbT; apply: le_trans le_j; apply: (knots_up hu); move: b n0 le_n; clear; lia.
split=> //; rewrite leNgt; apply/negP=> lt_J; suff : at_list v J.+1 <= y by rewrite leNgt lt_J.
apply: (next_knot hv) => //; first by move: in_J p0 le_p; clear; lia.
by rewrite -has_pred1 has_count; apply: leq_trans (often (ltW lt_J)); rewrite addn_gt0 -has_count has_pred1 yu.
Qed.

Lemma window_piece i : (i <= J.+1 <= i + p)%N -> exists h, [/\ (n.-1 <= h < size u - n)%N, at_list u h < at_list u h.+1,
  (piece_of K n u v p i).-1 = (h.+1 - n)%N & forall y, y \in u -> (at_list u h < y <= at_list u j) || (at_list u j < y <= at_list u h) ->
  (count_mem y u + e <= count_mem (at_ y) (knots (at_list v) i p))%N].
Proof.
have [n0 le_n p0 le_p] := bounds_; have [b le_j up_j in_j] := h_j => /andP[le_i ge_i].
have u0 : at_list u n.-1 <= at_list u j by apply: (knots_up hu); move: b n0 le_n; clear; lia.
have JJ : (J.+1 < size v)%N by move: in_J p0; clear; lia.
have win : (i + p <= size v)%N by move: le_i in_J p0 le_p; clear; lia.
have [|l [h [in_l before h_l e_h]]] := @piece_ofE n u v p i hu.
  exists (maxn i J); first by move: le_i ge_i p0; clear; lia.
  by apply: le_trans u0 (le_trans le_j _); apply: (knots_up hv); move: le_i in_J p0 le_p; clear; lia.
have [bh le_h up_h in_h] := h_l; exists h; split=> // y yu in_y.
have uh : at_list u n.-1 <= at_list u h by apply: (knots_up hu); move: bh n0 le_n; clear; lia.
have Lj : at_list u j.+1 <= at_list u (size u - n) by apply: (knots_up hu); move: b n0 le_n; clear; lia.
have Lh : at_list u h.+1 <= at_list u (size u - n) by apply: (knots_up hu); move: bh n0 le_n; clear; lia.
have [iJ|Ji] := leqP i J.
  have lJ : (l <= J)%N.
    rewrite leqNgt; apply/negP=> lt_J; have := before J; rewrite iJ lt_J => /(_ isT).
    by rewrite ltNge (le_trans u0).
  have vl : at_list v l <= at_list v J by apply: (knots_up hv); rewrite lJ; apply: ltnW.
  have hj : (h <= j)%N by apply: lies_up h_l h_j vl.
  have huj : at_list u h <= at_list u j by apply: (knots_up hu); rewrite hj; move: b n0 le_n; clear; lia.
  have {in_y}/andP[lt_y le_y] : at_list u h < y <= at_list u j.
    by case/orP: in_y => // /andP[lt_y le_y]; move: (lt_le_trans lt_y le_y); rewrite ltNge huj.
  have lt_h : (h.+1 < size u)%N by move: bh n0 le_n; clear; lia.
  have ge_y := next_knot hu lt_h yu lt_y.
  have ly : at_list v l < y.
    case: in_h => [lt_l|[e_L _]]; first exact: lt_le_trans lt_l ge_y.
    by move: (le_lt_trans le_y up_j); rewrite ltNge (le_trans Lj) // -e_L.
  have yJ : y <= at_list v J := le_trans le_y le_j.
  have l_v : (l < size v)%N by move: in_l win; clear; lia.
  rewrite count_knots //.
    apply: (H (l := l)) => //; first by move: in_l ge_i lJ; clear; lia.
    - by rewrite ly (le_trans uh).
    - by rewrite (le_lt_trans le_y) // (lt_le_trans up_j).
    by rewrite (le_trans yJ) // ltW.
  move=> q lt_q e_q; apply/andP; split; rewrite leqNgt; apply/negP=> h_q.
    have : at_list v q <= at_list v l by apply: (knots_up hv); move: h_q in_l win; clear; lia.
    by rewrite e_q leNgt ly.
  have : at_list v J.+1 <= at_list v q by apply: (knots_up hv); move: h_q ge_i lt_q; clear; lia.
  by rewrite e_q leNgt (le_lt_trans yJ).
have e_i : i = J.+1 by apply/eqP; rewrite eqn_leq le_i.
have Jv : at_list v J <= at_list v J.+1 by exact: ltW.
have e_l : l = J.+1.
  apply/eqP; rewrite eqn_leq -{2}e_i; have/andP[-> _] := in_l; rewrite andbT leqNgt; apply/negP=> lt_l.
  by have := before J.+1; rewrite -e_i leqnn e_i lt_l => /(_ isT); rewrite ltNge (le_trans u0) // (le_trans le_j).
rewrite e_l in le_h h_l; have jh : (j <= h)%N by apply: lies_up h_j h_l Jv.
have ujh : at_list u j <= at_list u h by apply: (knots_up hu); rewrite jh; move: bh n0 le_n; clear; lia.
have {in_y}/andP[lt_y le_y] : at_list u j < y <= at_list u h.
  by case/orP: in_y => // /andP[lt_y le_y]; move: (lt_le_trans lt_y le_y); rewrite ltNge ujh.
have y_J : y <= at_list v J.+1 := le_trans le_y le_h.
have [|J_y /(_ y_J) often] := later yu lt_y; first by rewrite (le_lt_trans le_y) // (lt_le_trans up_h).
have e_y : y = at_list v J.+1 by apply/eqP; rewrite eq_le y_J.
rewrite count_knots // => q lt_q e_q; apply/andP; split; rewrite leqNgt; apply/negP=> h_q.
  have : at_list v q <= at_list v J by apply: (knots_up hv); move: h_q e_i JJ; clear; lia.
  by rewrite e_q e_y leNgt up_J.
have big : (J.+1 + p <= q)%N by move: h_q e_i; clear; lia.
have := repeated hv (leq_ltn_trans big lt_q); rewrite -e_y -e_q ltNge (knots_up hv) //.
by rewrite big.
Qed.

Lemma window_blossom c i a : (i <= J.+1 <= i + p)%N -> size a = n ->
  (forall y, (count_mem (at_ y) (knots (at_list v) i p) <= count_mem (at_ y) a + e)%N) ->
  blossom (drop_ (piece_of K n u v p i).-1 (at_list u)) (drop_ (piece_of K n u v p i).-1 c) a = blossom (piece n j (at_list u)) (piece n j c) a.
Proof.
move=> in_i sz often; have [h [bh up_h -> holds]] := window_piece in_i; have [b _ up_j _] := h_j.
apply: crossed_pieces => // y yu in_y; have := leq_trans (holds y yu in_y) (often y); by rewrite leq_add2r.
Qed.

(* From the piece of u that holds v_J to the one that holds t. *)
Lemma same_point c t jt : at_list v J <= t <= at_list v J.+1 -> t <= at_list u (size u - n) -> lies n u t jt ->
  blossom (piece n j (at_list u)) (piece n j c) (nseq n (at_ t)) = blossom (piece n jt (at_list u)) (piece n jt c) (nseq n (at_ t)).
Proof.
have [n0 le_n p0 le_p] := bounds_; have [b le_j up_j in_j] := h_j => /andP[le_t ge_t] t_L h_t; have [bt le_jt up_t _] := h_t.
have jjt : (j <= jt)%N by apply: lies_up h_j h_t le_t.
apply: crossed_pieces; rewrite ?size_nseq // => y yu in_y.
have ujt : at_list u j <= at_list u jt by apply: (knots_up hu); rewrite jjt; move: bt n0 le_n; clear; lia.
have {in_y}/andP[lt_y le_y] : at_list u j < y <= at_list u jt.
  by case/orP: in_y => // /andP[lt_y le_y]; move: (lt_le_trans lt_y le_y); rewrite ltNge ujt.
have y_t : y <= t := le_trans le_y le_jt.
have Lt : at_list u jt.+1 <= at_list u (size u - n) by apply: (knots_up hu); move: bt n0 le_n; clear; lia.
have [|J_y _] := later yu lt_y; first by rewrite (le_lt_trans le_y) // (lt_le_trans up_t).
have -> : y = t by apply/eqP; rewrite eq_le y_t (le_trans ge_t).
by rewrite count_nseq /= eqxx mul1n times_of.
Qed.
End Piece.

Lemma first_vertex p (w b b' : nat -> F) t : w p = t -> (forall i, (0 < i <= p)%N -> b i = b' i) ->
  (0 < p)%N -> blossom w b (nseq p (at_ t)) = blossom w b' (nseq p (at_ t)).
Proof.
case: p => // p e_t eq_b _ /=; rewrite size_nseq; apply: blossom_ext => i; rewrite size_nseq => le_i; rewrite /step /= (eq_b i.+1) //.
case: i le_i => [|i] le_i; last by rewrite eq_b //= leqW.
by rewrite add0n e_t mul1r subrr !mul0r.
Qed.

(* G k is the polar form of degree p of the curve on the piece from k on. *)
Section Form.
Variables (n p e : nat) (u v : seq F) (c r : nat -> F) (G : nat -> seq (F * F) -> F).
Hypotheses (hu : valid n u) (hv : valid p v).
Hypothesis pol : forall k, span n (drop_ k (at_list u)) -> polar p (G k).
Hypothesis rE : forall i, (i <= size v - p)%N -> r i = G (piece_of K n u v p i).-1 (knots (at_list v) i p).
Hypothesis same : forall i j J, holds_at e n u p v J -> (p.-1 <= J < size v - p)%N -> at_list v J < at_list v J.+1 -> lies n u (at_list v J) j -> (i <= J.+1 <= i + p)%N ->
  G (piece_of K n u v p i).-1 (knots (at_list v) i p) = G (j.+1 - n)%N (knots (at_list v) i p).

Lemma piece_stays J j w : holds_at e n u p v J -> (p.-1 <= J < size v - p)%N -> at_list v J < at_list v J.+1 -> lies n u (at_list v J) j -> size w = p ->
  blossom (piece p J (at_list v)) (piece p J r) w = G (j.+1 - n)%N w.
Proof.
move=> H bJ up_J h_j sz; have [p0 _ _] := bounds_of hv; have [bj _ up_j _] := h_j.
have sp_j : span n (piece n j (at_list u)) by apply: blossoms_carried; rewrite ?lt_eqF.
have sp_J : span p (piece p J (at_list v)) by apply: blossoms_carried; rewrite ?lt_eqF.
rewrite (blossoms_unique (pol sp_j) sp_J sz); apply: blossom_ext => i; rewrite sz => le_i.
rewrite /drop_ rE; last by move: le_i bJ p0; clear; lia.
rewrite (same H bJ up_J h_j); last by move: le_i bJ p0; clear; lia.
by congr (G _ _); apply: knots_ext => q _; rewrite /drop_ addnA.
Qed.

Lemma spline_stays t (J := interval K p v t) (jt := interval K n u t) : holds_at e n u p v J -> ~~ (at_list v J < at_list u n.-1 < at_list v J.+1) ->
  at_list v p.-1 <= t <= at_list v (size v - p) -> at_list u n.-1 <= t <= at_list u (size u - n) ->
  (forall k, G k (nseq p (at_ t)) = blossom (drop_ k (at_list u)) (drop_ k c) (nseq n (at_ t))) ->
  blossom (piece p J (at_list v)) (piece p J r) (nseq p (at_ t)) = blossom (piece n jt (at_list u)) (piece n jt c) (nseq n (at_ t)).
Proof.
move=> H begin_ in_v in_u val.
have [n0 le_n _] := bounds_of hu; have [p0 le_p _] := bounds_of hv.
have [bJ J_t up_J t_J] := lies_in hv in_v; rewrite -/J in bJ J_t up_J t_J.
have t_J1 : t <= at_list v J.+1 by case: t_J => [/ltW //|[-> _]]; have/andP[] := in_v.
have sp_J : span p (piece p J (at_list v)) by apply: blossoms_carried; rewrite ?lt_eqF.
have h_t : lies n u t jt by apply: lies_in.
have [u_J|J_u] := leP (at_list u n.-1) (at_list v J); last first.
  have e_t : at_list v J.+1 = t.
    apply/eqP; rewrite eq_le t_J1 andbT; apply: (@le_trans _ _ (at_list u n.-1)); last by have/andP[] := in_u.
    by move: begin_; rewrite J_u -leNgt.
  have [_ _ up_t _] := h_t; have sp_t : span n (piece n jt (at_list u)) by have [b _ _ _] := h_t; apply: blossoms_carried; rewrite ?lt_eqF.
  rewrite -val (blossoms_unique (pol sp_t) sp_J) ?size_nseq //; apply: first_vertex => // [|i /andP[i0 le_i]].
    by rewrite /drop_ -e_t; congr at_list; move: bJ p0; clear; lia.
  rewrite /drop_ rE; last by move: le_i bJ p0; clear; lia.
  have [|l [h [in_l before h_l ->]]] := @piece_ofE n u v p (J.+1 - p + i) hu.
    by exists J.+1; [move: i0 le_i bJ p0; clear; lia | rewrite e_t; have/andP[] := in_u].
  have e_l : l = J.+1.
    apply/eqP; rewrite eqn_leq; apply/andP; split; rewrite leqNgt; apply/negP=> lt_l.
      have lo : (J.+1 - p + i <= J.+1)%N by move: le_i bJ p0; clear; lia.
      by have := before J.+1; rewrite lo lt_l e_t => /(_ isT); rewrite ltNge; have/andP[-> _] := in_u.
    have [b le_h _ _] := h_l; have : at_list u n.-1 <= at_list u h by apply: (knots_up hu); move: b n0 le_n; clear; lia.
    rewrite leNgt (le_lt_trans le_h) // (le_lt_trans _ J_u) // (knots_up hv) //; move: lt_l bJ p0 le_p; clear; lia.
  rewrite e_l e_t in h_l; have -> : h = jt by apply/eqP; rewrite eqn_leq (lies_up hu h_l h_t) // (lies_up hu h_t h_l).
  by congr (G _ _); apply: knots_ext => q _; rewrite /drop_ addnA.
have {}J_u : at_list v J <= at_list u (size u - n) by apply: le_trans J_t _; have/andP[] := in_u.
pose j := interval K n u (at_list v J).
have h_j : lies n u (at_list v J) j by apply: lies_in; rewrite // u_J.
rewrite -(same_point hu hv H bJ h_j c (t := t)) ?J_t //; last by have/andP[] := in_u.
by rewrite -val (piece_stays H bJ up_J h_j) ?size_nseq.
Qed.
End Form.
End Windows.
