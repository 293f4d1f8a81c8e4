(* Curves over lists of knots, at the knots between their pieces.
   Definitions:
     lies n u t i     i is the knot u_i of the domain at which the piece begins that holds t: the one to the right at a knot, the last one from the end on *)
From Torse Require Import Prelude Blossom Curves Points Joints FJ21_4 Executable Executable_knots Executable_splines Executable_mappings.
From mathcomp Require Import order ssrnum.
Import Order.TTheory Num.Theory.

Lemma perm_nseq (T : eqType) (x : T) (s : seq T) r : (r <= count_mem x s)%N -> exists2 w, perm_eq s (nseq r x ++ w) & (r + size w)%N = size s.
Proof.
move=> le_r; exists (nseq (count_mem x s - r) x ++ filter (predC (pred1 x)) s).
  rewrite catA -nseqD subnKC // -[X in nseq X]size_filter perm_sym.
  by rewrite -(all_pred1P _ _ (filter_all (pred1 x) s)) perm_filterC.
by rewrite size_cat size_nseq addnA subnKC // -(count_predC (pred1 x) s) size_filter.
Qed.

Section Joints.
Variables (F : realFieldType) (m : nat).
Implicit Types (u v : seq F) (c : nat -> F) (n k i j l : nat) (s t y : F) (a : seq (F * F)).
Local Notation K := (ordered F).
Local Notation V := (rows [fieldType of F] m).
Local Notation at_list := (nth 0).
Local Notation valid := (valid (fun x y : F => x < y)).

Lemma repeated n u i : valid n u -> (i + n < size u)%N -> at_list u i < at_list u (i + n).
Proof.
move=> hv lt_i; have [_ _ _ mult _] := hv; rewrite lt_neqAle mult ?(knots_up hv) ?leq_addr //.
by rewrite ltn_subRL addnC.
Qed.

Lemma count_iota y u : count_mem y u = count (fun l => at_list u l == y) (iota 0 (size u)).
Proof. by rewrite -{1}(mkseq_nth 0 u) /mkseq count_map. Qed.

Lemma count_knots y u i k : (i + k <= size u)%N -> (forall l, (l < size u)%N -> at_list u l = y -> (i <= l < i + k)%N) ->
  count_mem (at_ y) (knots (at_list u) i k) = count_mem y u.
Proof.
move=> le_k in_k; rewrite count_iota /knots count_map -(subnKC le_k) !iotaD !count_cat add0n.
have none b e : (b + e <= i)%N || (i + k <= b)%N -> (b + e <= size u)%N -> count (fun l => at_list u l == y) (iota b e) = 0%N.
  move=> out le_e; apply/eqP; rewrite -leqn0 leqNgt -has_count; apply/hasPn=> l; rewrite mem_iota => /andP[le_l lt_l].
  by apply/eqP=> /(in_k l (leq_trans lt_l le_e)) => h; move: out h le_l lt_l; clear; lia.
rewrite none ?add0n ?leqnn //; last by apply: leq_trans le_k; exact: leq_addr.
rewrite [X in (_ + X)%N]none ?addn0 ?leqnn ?orbT ?subnKC //; apply: eq_count => l /=; by rewrite xpair_eqE eqxx andbT.
Qed.

Lemma count_run y u i k : (i + k <= size u)%N -> (forall l, (i <= l < i + k)%N -> at_list u l = y) -> (k <= count_mem y u)%N.
Proof.
move=> le_k eq_y; rewrite count_iota -(subnKC le_k) !iotaD !count_cat add0n; set N := count _ (iota i k).
suff -> : N = k by rewrite addnAC leq_addl.
rewrite /N -[RHS](size_iota i k); apply/eqP; rewrite -all_count; apply/allP=> l; rewrite mem_iota => in_l; exact/eqP/eq_y.
Qed.

Lemma times_of n u y : valid n u -> (count_mem y u <= n)%N.
Proof.
move=> hv; have [n0 le_n _] := bounds_of hv; case: (boolP (y \in u)) => [yu|/count_memPn -> //].
have [i [lt_i e_i first_i]] : exists i, [/\ (i < size u)%N, at_list u i = y & forall l, at_list u l = y -> (i <= l)%N].
  exists (index y u); rewrite index_mem nth_index //; split=> // l e_l.
  by rewrite leqNgt; apply/negP=> /(before_find 0) /=; rewrite e_l eqxx.
have run l : (l < size u)%N -> at_list u l = y -> (i <= l < i + n)%N.
  move=> lt_l e_l; rewrite first_i // ltnNge /=; apply/negP=> ge_l; have := repeated hv (leq_ltn_trans ge_l lt_l).
  by rewrite e_i -e_l ltNge (knots_up hv) // ge_l.
have [in_u|out_u] := leqP (i + n) (size u).
  by rewrite -(count_knots in_u run) (leq_trans (count_size _ _)) ?size_knots.
have le_s : (i + (size u - i) <= size u)%N by rewrite subnKC // ltnW.
rewrite -(count_knots le_s); first by rewrite (leq_trans (count_size _ _)) ?size_knots //; move: out_u; clear; lia.
by move=> l lt_l e_l; have := run l lt_l e_l; move: lt_l; clear; lia.
Qed.

(* The piece that begins at knot i. *)
Local Notation piece n i u := (drop_ (i.+1 - n) u).

Lemma level_knots n u i j : valid n u -> (j < size u)%N -> (forall l, (i <= l < j)%N -> ~~ (at_list u l < at_list u l.+1)) ->
  forall l, (i <= l <= j)%N -> at_list u l = at_list u j.
Proof.
move=> hv lt_j flat l /andP[le_l]; move: {2}(j - l)%N (erefl (j - l)%N) => d; elim: d l le_l => [|d ih] l le_l e_d le_j; first by congr nth; lia.
rewrite -(ih l.+1); [|by lia..]; apply/eqP; rewrite eq_le (knots_up hv); last by lia.
by rewrite leNgt flat //; lia.
Qed.

(** blossoms crossed: the pieces of a curve that begin at the knots $u_i\le u_j$ have the same blossom where each knot $y$ with $u_i<y\le u_j$ is
    among the arguments as often as among the knots.
    Hypotheses: an ordered field; the list of knots is accepted; the pieces are not empty. *)
Theorem blossoms_crossed n u c i j a : valid n u -> size a = n -> (n.-1 <= i <= j)%N -> (j < size u - n)%N ->
  at_list u i < at_list u i.+1 -> at_list u j < at_list u j.+1 ->
  (forall y, at_list u i < y <= at_list u j -> (count_mem y u <= count_mem (at_ y) a)%N) ->
  blossom (piece n i (at_list u)) (piece n i c) a = blossom (piece n j (at_list u)) (piece n j c) a.
Proof.
move=> hv sz; have [n0 le_n _] := bounds_of hv.
move: {2}(j - i)%N (leqnn (j - i)%N) => d; elim: d i => [|d ih] i le_d /andP[le_i le_j] lt_j up_i up_j often.
  by rewrite (_ : i = j) //; lia.
move: le_j; rewrite leq_eqVlt => /orP[/eqP -> //|lt_ij].
have ex : exists l, (i < l)%N && (at_list u l < at_list u l.+1) by exists j; rewrite lt_ij.
case: (ex_minnP ex) => h /andP[lt_ih up_h] first_h; have le_hj : (h <= j)%N by apply: first_h; rewrite lt_ij.
have lt_h : (h < size u)%N by lia.
have flat l : (i.+1 <= l <= h)%N -> at_list u l = at_list u h.
  apply: (level_knots hv lt_h) => q /andP[le_q lt_q]; apply/negP=> up_q.
  by have := first_h q; rewrite le_q up_q => /(_ isT); rewrite leqNgt lt_q.
pose r := (h - i)%N; pose y := at_list u h.
have le_yj : y <= at_list u j by apply: knots_up hv _; lia.
have lt_iy : at_list u i < y by rewrite (lt_le_trans up_i) // flat //; lia.
have le_r : (r <= count_mem (at_ y) a)%N.
  apply: leq_trans (often y _); last by rewrite lt_iy.
  by apply: (@count_run _ _ i.+1) => [|l]; [move: lt_ih lt_h; rewrite /r; clear; lia | rewrite /r => h_l; apply: flat; move: lt_ih h_l; clear; lia].
rewrite -(ih h) //; [| by lia | by lia |]; last first.
  by move=> z /andP[lt_z le_z]; apply: often; rewrite le_z andbT (lt_trans lt_iy).
have [w pw sw] := perm_nseq le_r; rewrite sz in sw.
have sp_i : span n (piece n i (at_list u)) by apply: blossoms_carried; rewrite ?lt_eqF //; lia.
have sp_h : span n (piece n h (at_list u)) by apply: blossoms_carried; rewrite ?lt_eqF //; lia.
rewrite (blossoms_symmetric _ _ pw) ?sz // [RHS](blossoms_symmetric _ _ pw) ?sz //.
have e_k q : (h.+1 - n + q = i.+1 - n + (r + q))%N by move: lt_ih le_i n0; rewrite /r; clear; lia.
have dropE (g : nat -> F) q : piece n h g q = drop_ r (piece n i g) q by rewrite /drop_ e_k.
rewrite [RHS](@blossom_ext_knots _ _ (drop_ r (piece n i (at_list u)))) => [|q _]; last exact: dropE.
rewrite [RHS](@blossom_ext _ _ _ (drop_ r (piece n i c))) => [|q _]; last exact: dropE.
rewrite (blossoms_joint (n := n)) //; first by move=> q q' h1 h2; rewrite -2!(dropE (at_list u)); exact: sp_h.
by move=> q; rewrite /r => h_q; apply: flat; move: h_q lt_ih le_i n0; clear; lia.
Qed.

Definition lies n u t i := [/\ (n.-1 <= i < size u - n)%N, at_list u i <= t, at_list u i < at_list u i.+1 &
  t < at_list u i.+1 \/ at_list u i.+1 = at_list u (size u - n) /\ at_list u (size u - n) <= t].

Lemma lies_in n u t : valid n u -> at_list u n.-1 <= t <= at_list u (size u - n) -> lies n u t (interval K n u t).
Proof.
move=> hv in_t; have [b /andP[le_t ge_t] up [lt_t|e_t]] := blossoms_interval hv in_t; split=> //; first by left.
right; split; last by rewrite -e_t.
by apply/eqP; rewrite eq_le -{2}e_t ge_t (knots_up hv) //; have [n0 le_n _] := bounds_of hv; move: b n0; clear; lia.
Qed.

Lemma next_knot n u i y : valid n u -> (i.+1 < size u)%N -> y \in u -> at_list u i < y -> at_list u i.+1 <= y.
Proof.
move=> hv lt_i /(nthP 0)[l lt_l <-] lt_y; rewrite (knots_up hv) // lt_l andbT ltnNge; apply/negP=> le_l.
by move: lt_y; rewrite ltNge (knots_up hv) // le_l ltnW.
Qed.

Lemma lies_up n u s t i j : valid n u -> lies n u s i -> lies n u t j -> s <= t -> (i <= j)%N.
Proof.
move=> hv [bi le_s up_i _] [bj _ up_j in_t] le_st; rewrite leqNgt; apply/negP=> lt_ji; have [n0 le_n _] := bounds_of hv.
have le_i : at_list u j.+1 <= at_list u i by apply: (knots_up hv); move: bi lt_ji n0; clear; lia.
have le_L : at_list u i.+1 <= at_list u (size u - n) by apply: (knots_up hv); move: bi n0 le_n; clear; lia.
case: in_t => [lt_t|[e _]]; first by move: (lt_le_trans lt_t le_i); rewrite ltNge (le_trans le_s).
by move: (lt_le_trans up_i le_L); rewrite -e ltNge le_i.
Qed.

Lemma crossed_pieces n u c i j a : valid n u -> size a = n -> (n.-1 <= i < size u - n)%N -> (n.-1 <= j < size u - n)%N ->
  at_list u i < at_list u i.+1 -> at_list u j < at_list u j.+1 ->
  (forall y, y \in u -> (at_list u i < y <= at_list u j) || (at_list u j < y <= at_list u i) -> (count_mem y u <= count_mem (at_ y) a)%N) ->
  blossom (piece n i (at_list u)) (piece n i c) a = blossom (piece n j (at_list u)) (piece n j c) a.
Proof.
move=> hv sz /andP[le_i lt_i] /andP[le_j lt_j] up_i up_j often; have {}often y :
    (at_list u i < y <= at_list u j) || (at_list u j < y <= at_list u i) -> (count_mem y u <= count_mem (at_ y) a)%N.
  by move=> in_y; case: (boolP (y \in u)) => [yu|/count_memPn -> //]; apply: often.
by case/orP: (leq_total i j) => le_ij; [|apply/esym]; apply: blossoms_crossed; rewrite ?le_i ?le_j //= => y in_y; apply: often; rewrite in_y ?orbT.
Qed.

Lemma same_value n u c i j t : valid n u -> (n.-1 <= i < size u - n)%N -> (n.-1 <= j < size u - n)%N ->
  at_list u i < at_list u i.+1 -> at_list u j < at_list u j.+1 -> at_list u i <= t <= at_list u i.+1 -> at_list u j <= t <= at_list u j.+1 ->
  (curve n (piece n i (at_list u)) (piece n i c)).[t] = (curve n (piece n j (at_list u)) (piece n j c)).[t].
Proof.
move=> hv bi bj up_i up_j in_i in_j; rewrite !horner_curve; [|by apply: blossoms_carried; rewrite ?lt_eqF..].
rewrite (crossed_pieces _ hv (size_nseq _ _) bi bj up_i up_j) // => y yu in_y; have [n0 le_n _] := bounds_of hv.
have [lt_i lt_j] : (i.+1 < size u)%N /\ (j.+1 < size u)%N by move: bi bj n0 le_n; clear; split; lia.
have -> : y = t.
  have/andP[le_i ge_i] := in_i; have/andP[le_j ge_j] := in_j; apply/eqP; rewrite eq_le.
  by case/orP: in_y => /andP[lt_y le_y]; rewrite (le_trans le_y) // (le_trans _ (next_knot hv _ yu lt_y)).
by rewrite count_nseq /= eqxx mul1n times_of.
Qed.

Lemma same_piece p v c k1 k2 t : valid p v -> (p + k1 - 1 < size v - p)%N -> (p + k2 - 1 < size v - p)%N ->
  span p (drop_ k1 (at_list v)) -> span p (drop_ k2 (at_list v)) ->
  at_list v (p + k1 - 1) <= t <= at_list v (p + k1) -> at_list v (p + k2 - 1) <= t <= at_list v (p + k2) ->
  (curve p (drop_ k1 (at_list v)) (drop_ k1 c)).[t] = (curve p (drop_ k2 (at_list v)) (drop_ k2 c)).[t].
Proof.
move=> hv; have [p0 le_p _] := bounds_of hv; have ek k : ((p + k - 1).+1 = p + k /\ p + k - p = k)%N by move: p0; clear; lia.
have up k : (p + k - 1 < size v - p)%N -> span p (drop_ k (at_list v)) -> at_list v (p + k - 1) < at_list v (p + k).
  move=> lt_k sp; rewrite lt_neqAle (knots_up hv) ?andbT; last by move: lt_k p0 le_p; clear; lia.
  have e : (k + p.-1 = p + k - 1)%N by move: p0; clear; lia.
  by have := sp p.-1 p; rewrite unitfE /drop_ subr_eq0 eq_sym e [(k + p)%N]addnC; apply; move: p0; clear; lia.
move=> b1 b2 sp1 sp2 in_1 in_2; have := @same_value p v c (p + k1 - 1) (p + k2 - 1) t hv.
rewrite (ek k1).1 (ek k2).1 (ek k1).2 (ek k2).2.
have lo k : (p.-1 <= p + k - 1)%N by move: p0; clear; lia.
by apply; rewrite ?lo //; [rewrite -(ek k1).1 | rewrite -(ek k2).1 | exact: up | exact: up].
Qed.

Lemma piece_lies n u t (k := (piece_at K n u t).-1) : valid n u -> at_list u n.-1 <= t <= at_list u (size u - n) ->
  lies n u t (n + k - 1) /\ ((n + k - 1).+1 - n = k)%N.
Proof.
move=> hv in_t; have [e _] := piece_atE hv in_t; have h := lies_in hv in_t; have [b _ _ _] := h; have [n0 _ _] := bounds_of hv.
by rewrite /k e; move: b h; set j := interval _ _ _ _ => b h; rewrite (_ : n + _ - 1 = j)%N //; move: b n0; clear; lia.
Qed.

(* The piece that the program finds for s holds the next parameter t with no knot between as well. *)
Lemma next_value n u c s t (k := (piece_at K n u s).-1) (h := (piece_at K n u t).-1) : valid n u -> at_list u n.-1 <= s -> s < t ->
  t <= at_list u (size u - n) -> (forall y, y \in u -> ~~ (s < y < t)) ->
  (curve n (drop_ k (at_list u)) (drop_ k c)).[t] = (curve n (drop_ h (at_list u)) (drop_ h c)).[t].
Proof.
move=> hv le_s lt_st le_t none; have [n0 le_n _] := bounds_of hv.
have [|[bk k_s up_k s_k] ek] := @piece_lies n u s hv; first by rewrite le_s ltW // (lt_le_trans lt_st).
have [|[bh h_t up_h t_h] eh] := @piece_lies n u t hv; first by rewrite le_t (le_trans le_s) // ltW.
rewrite -/k in bk k_s up_k s_k ek; rewrite -/h in bh h_t up_h t_h eh; rewrite -ek -eh.
apply: same_value => //; last by rewrite h_t; case: t_h => [/ltW|[->]].
rewrite (le_trans k_s (ltW lt_st)) /= leNgt; apply/negP=> lt_t; case: s_k => [lt_s|[_ ge_s]].
  have lt_k : ((n + k - 1).+1 < size u)%N by move: bk n0 le_n; clear; lia.
  by have := none _ (mem_nth 0 lt_k); rewrite lt_s lt_t.
by move: lt_st; rewrite ltNge (le_trans le_t).
Qed.

(** blossoms continuous: the pieces of a curve that hold $t$, $u_i\le t\le u_{i+1}$ and $u_j\le t\le u_{j+1}$, have the same point there.
    Hypotheses: an ordered field; the list of knots is accepted, so that no knot is there more than $n$ times; the pieces are not empty. *)
Theorem blossoms_continuous n u (c : nat -> 'rV[F]_m) i j t : valid n u -> (n.-1 <= i < size u - n)%N -> (n.-1 <= j < size u - n)%N ->
  at_list u i < at_list u i.+1 -> at_list u j < at_list u j.+1 -> at_list u i <= t <= at_list u i.+1 -> at_list u j <= t <= at_list u j.+1 ->
  ev (pcurve n (piece n i (at_list u)) (piece n i c)) t = ev (pcurve n (piece n j (at_list u)) (piece n j c)) t.
Proof. by move=> hv bi bj up_i up_j in_i in_j; apply/rowP=> l; rewrite !mxE; apply: (same_value (coord c l)). Qed.
End Joints.
