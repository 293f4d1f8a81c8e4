(* The programs for a knot and for more knots give the same curve, on all pieces.
   Definitions:
     enough n u v J    each knot inside the domain of u that is not behind v_{J+1} and follows one of v_{J+1-n}, ..., v_J in that domain is a knot of v, at least
                       as often *)
From Torse Require Import Prelude Blossom Curves Points Insertion FJ21_4 Executable Executable_knots Executable_splines Executable_mappings Executable_joints
  Executable_surface Executable_windows.
From mathcomp Require Import order ssrnum.
Import Order.TTheory Num.Theory.

Section Curves.
Variables (F : realFieldType) (m : nat).
Implicit Types (u v : seq F) (c r : seq 'rV[F]_m) (n i j : nat) (t y : F).
Local Notation K := (ordered F).
Local Notation V := (rows [fieldType of F] m).
Local Notation at_list := (nth 0).
Local Notation valid := (valid (fun x y : F => x < y)).
Local Notation piece n i u := (drop_ (i.+1 - n) u).

Lemma span_at n u t : valid n u -> at_list u n.-1 <= t <= at_list u (size u - n) -> span n (piece n (interval K n u t) (at_list u)).
Proof. by move=> hu in_u; have [_ sp] := piece_atE hu in_u. Qed.

Section Refined.
Variables (n : nat) (u v : seq F) (l : 'I_m).
Hypotheses (hu : valid n u) (hv : valid n v).
Let G c k a := if size a == n then blossom (drop_ k (at_list u)) (drop_ k (coord (at_list c) l)) a else 0.

Lemma vertex_form c k a : size a = n -> G c k a = blossom (drop_ k (at_list u)) (drop_ k (coord (at_list c) l)) a.
Proof. by rewrite /G => ->; rewrite eqxx. Qed.

Lemma refined_form c r : refined_program K V n u c v = Value r -> [/\ forall k, span n (drop_ k (at_list u)) -> polar n (G c k),
  forall i, (i <= size v - n)%N -> coord (at_list r) l i = G c (piece_of K n u v n i).-1 (knots (at_list v) i n) &
  forall i j J, holds_at 0 n u n v J -> (n.-1 <= J < size v - n)%N -> at_list v J < at_list v J.+1 -> lies n u (at_list v J) j -> (i <= J.+1 <= i + n)%N ->
    G c (piece_of K n u v n i).-1 (knots (at_list v) i n) = G c (j.+1 - n)%N (knots (at_list v) i n)].
Proof.
move=> e; have [_ _ rE _] := blossoms_refined e; split=> [k sp|i le_i|i j J H bJ up_J h_j in_i]; first exact: blossom_polar.
  by rewrite vertex_form ?size_knots // /coord rE // mxE.
rewrite !vertex_form ?size_knots //; apply: (window_blossom (e := 0) hu hv H bJ up_J h_j) => // [|y]; first exact: size_knots.
by rewrite addn0.
Qed.
End Refined.

Definition enough n u v J := forall l y, (J.+1 - n <= l <= J)%N -> at_list u n.-1 <= at_list v l < y -> y < at_list u (size u - n) ->
  y <= at_list v J.+1 -> (count_mem y u <= count_mem y v)%N.

Lemma enough_holds n u v J : enough n u v J -> holds_at 0 n u n v J.
Proof. by move=> often l y in_l _ l_y y_L y_J; rewrite addn0; apply: often in_l l_y y_L y_J. Qed.

(** blossoms refined_blossom: on every piece of the new knots from the start of the old domain on, $v_J\le t\le v_{J+1}$, the blossom of the new vertices is that of
    the piece of the curve that holds $v_J$, the last one behind the domain.
    Hypotheses: an ordered field; $u_{n-1}\le v_J$; the piece is not empty; each knot inside the old domain that is not behind $v_{J+1}$ and follows one of
    $v_{J+1-n},\dots,v_J$ in the old domain is a new knot, at least as often. *)
Theorem blossoms_refined_blossom n u c v r J w (j := interval K n u (at_list v J)) : refined_program K V n u c v = Value r -> enough n u v J ->
  (n.-1 <= J < size v - n)%N -> at_list v J < at_list v J.+1 -> at_list u n.-1 <= at_list v J -> size w = n ->
  pblossom (piece n J (at_list v)) (piece n J (at_list r)) w = pblossom (piece n j (at_list u)) (piece n j (at_list c)) w.
Proof.
move=> e often bJ up_J u_J sz; have [hv _ _ _] := blossoms_refined e; have hu : valid n u by case/knot_listP: e.
apply/rowP=> l; rewrite !mxE; have [pol rE same] := refined_form l hu hv e.
by rewrite (piece_stays hu hv pol rE same (enough_holds often) bJ up_J (lies_under hu u_J) sz) sz eqxx.
Qed.

(** blossoms refined_before: on a piece of the new knots inside which the old domain starts, $v_J<u_{n-1}<v_{J+1}$, the blossom of the new vertices is that of the
    curve's first piece.
    Hypotheses: an ordered field; $u_{n-1}<u_n$, so that the vertices before the domain have a meaning; no knot inside the old domain is before $v_{J+1}$, nor is it
    more than once at $v_{J+1}$. *)
Theorem blossoms_refined_before n u c v r J w : refined_program K V n u c v = Value r -> (n.-1 <= J < size v - n)%N ->
  at_list v J < at_list u n.-1 < at_list v J.+1 -> at_list u n.-1 < at_list u n ->
  (forall y, y \in u -> at_list u n.-1 < y < at_list u (size u - n) -> y <= at_list v J.+1 -> y = at_list v J.+1 /\ (count_mem y u <= 1)%N) -> size w = n ->
  pblossom (piece n J (at_list v)) (piece n J (at_list r)) w = pblossom (at_list u) (at_list c) w.
Proof.
move=> e bJ /andP[J_u u_J] up_u simple sz; have [hv _ rE _] := blossoms_refined e; have hu : valid n u by case/knot_listP: e.
have [n0 le_n _] := bounds_of hu; have [_ le_v _] := bounds_of hv; have e_n : n.-1.+1 = n := prednK n0.
have b0 : (n.-1 <= n.-1 < size u - n)%N by move: n0 le_n; clear; lia.
have sp_u : span n (piece n n.-1 (at_list u)) by apply: blossoms_carried => //; rewrite e_n lt_eqF.
have sp_J : span n (piece n J (at_list v)) by apply: blossoms_carried; rewrite ?lt_eqF // (lt_trans J_u).
have first (T : Type) (g : nat -> T) i : piece n n.-1 g i = g i by rewrite /drop_ e_n subnn.
apply/rowP=> l; rewrite !mxE; transitivity (blossom (piece n n.-1 (at_list u)) (piece n n.-1 (coord (at_list c) l)) w); last first.
  rewrite (@blossom_ext_knots _ _ (at_list u)) => [|i _]; last exact: first.
  by apply: blossom_ext => i _; exact: first.
rewrite -(blossoms_refinement _ sp_u sp_J sz); apply: blossom_ext => q; rewrite sz => le_q; set i := (J.+1 - n + q)%N.
have -> : knots (piece n J (at_list v)) q n = knots (at_list v) i n by apply: knots_ext => k _; rewrite /drop_ addnA.
have le_i : (i <= J.+1)%N by rewrite /i; move: le_q bJ n0; clear; lia.
rewrite {1}/coord {1}/drop_ -/i rE; last by apply: leq_trans le_i _; case/andP: bJ.
rewrite mxE -/(coord (drop_ _ (at_list c)) l).
have [e_q|q0] := posnP q.
  rewrite piece_of_before /=; last first.
    by move=> k h_k; apply: le_lt_trans J_u; apply: (knots_up hv); move: h_k bJ n0; rewrite /i e_q; clear; lia.
  rewrite [RHS](@blossom_ext_knots _ _ (drop_ 0 (at_list u))) => [|k _]; last exact: first.
  by apply: blossom_ext => k _; rewrite first.
have in_i : (i <= J.+1 < i + n)%N by rewrite /i; move: le_q q0 bJ n0; clear; lia.
have [|k [h [in_k before h_k ->]]] := @piece_ofE F n u v n i hu; first by exists J.+1; rewrite // ltW.
have e_k : k = J.+1.
  apply/eqP; rewrite eqn_leq; apply/andP; split; rewrite leqNgt; apply/negP=> lt_k.
    by have := before J.+1; rewrite lt_k; have/andP[-> _] := in_i => /(_ isT); rewrite ltNge ltW.
  have [b le_h _ _] := h_k; have : at_list u n.-1 <= at_list u h by apply: (knots_up hu); move: b n0 le_n; clear; lia.
  by rewrite leNgt (le_lt_trans le_h) // (le_lt_trans _ J_u) // (knots_up hv) //; move: lt_k bJ n0; clear; lia.
rewrite e_k in h_k; have [b le_h up_h _] := h_k.
have le_u : at_list u n.-1 <= at_list u h by apply: (knots_up hu); move: b n0 le_n; clear; lia.
apply: (crossed_pieces (coord (at_list c) l) hu (size_knots _ _ _) b b0 up_h) => [|y yu /orP[|] /andP[lt_y le_y]]; first by rewrite e_n.
  by move: (lt_le_trans lt_y le_y); rewrite ltNge le_u.
have [|e_y le_1] := simple y yu _ (le_trans le_y le_h).
  rewrite lt_y (le_lt_trans le_y) // (lt_le_trans up_h) // (knots_up hu) //; move: b n0; clear; lia.
by apply: leq_trans le_1 _; rewrite -has_count has_pred1 e_y (map_f (fun g => at_ (at_list v g))) // mem_iota.
Qed.

(** blossoms refined_curve: the point at $t$ of the curve over the new knots is that of the curve, for every $t$ that both domains hold.
    Hypotheses: an ordered field; the start of the old domain is not inside the piece $[v_J,v_{J+1}]$ of the new knots that holds $t$; each knot inside the old domain
    that is not behind $v_{J+1}$ and follows one of $v_{J+1-n},\dots,v_J$ in the old domain is a new knot, at least as often. *)
Theorem blossoms_refined_curve n u c v r t q (J := interval K n v t) : refined_program K V n u c v = Value r ->
  ~~ (at_list v J < at_list u n.-1 < at_list v J.+1) -> enough n u v J -> at_list v n.-1 <= t <= at_list v (size v - n) ->
  mapping_value_program K V n u c t = Value q -> mapping_value_program K V n v r t = Value q.
Proof.
move=> e begin_ often in_v /BZZ19_3_value[hu sc in_u ->].
have [hv sr _ _] := blossoms_refined e; apply/BZZ19_3_value; split=> //.
apply/rowP=> l; rewrite !mxE !horner_curve; [|exact: span_at..]; have [pol rE same] := refined_form l hu hv e.
by apply/esym; apply: (spline_stays (c := coord (at_list c) l) hu hv pol rE same (enough_holds often) begin_ in_v in_u) => k; rewrite size_nseq eqxx.
Qed.

(* What the program of knot insertion gives, and the piece k of the curve under the piece J of the new list. *)
Lemma insertion_lists n u c x v r (j := interval K n u x) : insertion_program K V n u c x = Value (v, r) ->
  [/\ valid n u, valid n v, size v = (size u).+1 & size r = (size v - n).+1] /\
  [/\ (n.-1 <= j < size u - n)%N, at_list u j <= x <= at_list u j.+1, at_list v =1 insert_knot j.+1 x (at_list u) &
    forall i l, (i <= size v - n)%N -> coord (at_list r) l i = insert_point n j.+1 x (at_list u) (coord (at_list c) l) i].
Proof.
case/knot_listP=> hu /fitsP[sc]; rewrite -/(inside K n u x) insideE /given; case: ifP => // in_x.
case/knot_listP=> hv e; have [ev er] := Value_inj e; move: hv; rewrite ev => hv {e}.
have [bj in_j _ _] := blossoms_interval hu in_x; move: bj in_j ev er; rewrite -/j; clearbody j => bj in_j ev er.
have [n0 le_n _] := bounds_of hu; have lt_j : (j < size u)%N by move: bj n0 le_n; clear; lia.
have sv : size v = (size u).+1 by rewrite -ev /inserted size_cat /= size_takel // size_drop; move: lt_j; clear; lia.
have lt_L : (size v - n = (size u - n).+1)%N by rewrite sv; move: le_n; clear; lia.
split; first by split=> //; rewrite -er size_mkseq /last_ lt_L.
split=> // [i|i l le_i]; first by rewrite -ev nth_inserted.
rewrite -er /coord nth_mkseq; last by rewrite /last_ -lt_L ltnS.
rewrite /vertex_of /insert_point !nat_ltbE addn2 ltnS; case: ifP => // _; case: ifP => // _.
by rewrite !mxE /step /coord mulrC.
Qed.

Lemma insertion_facts n u c x v r J (j := interval K n u x) (k := if (J <= j)%N then J else J.-1) : insertion_program K V n u c x = Value (v, r) ->
  [/\ valid n u, valid n v, size r = (size v - n).+1, at_list v n.-1 = at_list u n.-1 & at_list v (size v - n) = at_list u (size u - n)] /\
  ((n.-1 <= J < size v - n)%N -> at_list v J < at_list v J.+1 ->
    [/\ (n.-1 <= k < size u - n)%N, at_list u k <= at_list v J, at_list v J.+1 <= at_list u k.+1 &
      forall l w, size w = n -> blossom (piece n J (at_list v)) (piece n J (coord (at_list r) l)) w
        = blossom (piece n k (at_list u)) (piece n k (coord (at_list c) l)) w]).
Proof.
move=> e; have [[hu hv sv sr] [bj /andP[j_x x_j] vE rE]] := insertion_lists e; rewrite -/j in bj j_x x_j vE rE.
have [n0 le_n _] := bounds_of hu; have lt_L : (size v - n = (size u - n).+1)%N by rewrite sv; move: le_n; clear; lia.
split; first split=> //.
- by rewrite vE /insert_knot ifT //; move: bj; clear; lia.
- by rewrite vE lt_L /insert_knot ifF ?ifF //; move: bj; clear; lia.
move=> bJ up_J; rewrite -/k; have [u_k k_u] : at_list u k <= at_list v J /\ at_list v J.+1 <= at_list u k.+1.
  rewrite !vE /k /insert_knot !ltnS eqSS; have [Jj|Jj] := leqP J j.
    by split=> //; move: Jj; rewrite leq_eqVlt => /orP[/eqP ->|-> //]; rewrite ltnn eqxx.
  rewrite (ltn_predK Jj) ltnNge (ltnW Jj) (gtn_eqF Jj) lexx /=; split=> //; case: eqP => // ->; exact: j_x.
have bk : (n.-1 <= k < size u - n)%N by rewrite /k; have [Jj|Jj] := leqP J j; move: bj bJ Jj; rewrite lt_L; clear; lia.
split=> // l w sz; have up_k : at_list u k < at_list u k.+1 := le_lt_trans u_k (lt_le_trans up_J k_u).
have sp_k : span n (piece n k (at_list u)) by apply: blossoms_carried; rewrite ?lt_eqF.
have sp_J : span n (piece n J (at_list v)) by apply: blossoms_carried; rewrite ?lt_eqF.
have e_k : (k.+1 - n = if (J.+1 - n + n <= j.+1)%N then J.+1 - n else (J.+1 - n).-1)%N.
  by rewrite /k; move: bJ n0; clear; have [Jj|Jj] := leqP J j; case: ifP; lia.
rewrite [LHS](@blossom_ext_knots _ _ (drop_ (J.+1 - n) (insert_knot j.+1 x (at_list u)))) => [|i _]; last exact: vE.
have sp_J' : span n (drop_ (J.+1 - n) (insert_knot j.+1 x (at_list u))).
  by move=> i i' h1 h2; have := sp_J i i' h1 h2; rewrite /drop_ !vE.
rewrite e_k in sp_k *; rewrite -(blossoms_boehm (coord (at_list c) l) _ sp_k sp_J') //; last first.
  by apply/orP; left; move: bj; clear; lia.
by apply: blossom_ext => i; rewrite sz => le_i; rewrite /drop_ rE //; move: le_i bJ n0; clear; lia.
Qed.

(** blossoms inserted_blossom: on every piece $[v_J,v_{J+1}]$ of the knots with $x$ inserted after $u_j$ the blossom of the new vertices is that of the piece of the
    curve that begins at $u_J$ if $J\le j$, at $u_{J-1}$ otherwise.
    Hypotheses: an ordered field; the piece is not empty. *)
Theorem blossoms_inserted_blossom n u c x v r J w (j := interval K n u x) (k := if (J <= j)%N then J else J.-1) :
  insertion_program K V n u c x = Value (v, r) -> (n.-1 <= J < size v - n)%N -> at_list v J < at_list v J.+1 -> size w = n ->
  pblossom (piece n J (at_list v)) (piece n J (at_list r)) w = pblossom (piece n k (at_list u)) (piece n k (at_list c)) w.
Proof.
move=> e bJ up_J sz; have [_ facts] := insertion_facts J e; have [_ _ _ same] := facts bJ up_J.
by apply/rowP=> l; rewrite !mxE; apply: same.
Qed.

(** blossoms inserted_curve: the point at $t$ of the curve with a knot inserted is that of the curve, for every $t$ of the domain.
    Hypotheses: an ordered field. *)
Theorem blossoms_inserted_curve n u c x v r t q : insertion_program K V n u c x = Value (v, r) ->
  mapping_value_program K V n u c t = Value q -> mapping_value_program K V n v r t = Value q.
Proof.
move=> e /BZZ19_3_value[_ _ in_t ->]; have [[hu hv sr v_a v_b] facts] := insertion_facts (interval K n v t) e.
have in_v : at_list v n.-1 <= t <= at_list v (size v - n) by rewrite v_a v_b.
apply/BZZ19_3_value; split=> //; apply/rowP=> l; rewrite !mxE !horner_curve; [|exact: span_at..].
have [bJ J_t up_J t_J] := lies_in hv in_v; have [bk u_k k_u same] := facts bJ up_J.
rewrite [RHS]same ?size_nseq //; move: bk u_k k_u {facts same}; set k := if _ then _ else _ => bk u_k k_u.
have h_k : lies n u t k.
  split=> //; [exact: le_trans u_k J_t | exact: le_lt_trans u_k (lt_le_trans up_J k_u) |].
  case: t_J => [lt_t|[e_J le_t]]; first by left; apply: lt_le_trans k_u.
  right; split; last by rewrite -v_b.
  have [n0 le_n _] := bounds_of hu.
  by apply/eqP; rewrite eq_le -{2}v_b -e_J k_u andbT (knots_up hu) //; move: bk n0 le_n; clear; lia.
have h_t := lies_in hu in_t.
by have -> : k = interval K n u t by apply/eqP; rewrite eqn_leq (lies_up hu h_k h_t) // (lies_up hu h_t h_k).
Qed.

(** FJ21.K inserted: what the program of knot insertion makes of two curves over the same knots has the relation
    $p[t_1,\dots,t_{n-1},\Lambda]=\sigma q[t_1,\dots,t_{n-1},M]$ on every piece of the new knots iff the curves have it on the piece that holds this one:
    $\Lambda$, $M$ and $\sigma$ do not change. With $\sigma=1$ it is the relation of FJ07.9.
    Hypotheses: an ordered field; the piece is not empty. *)
Theorem FJ21_K_inserted n u p q x v r s J w L M g (j := interval K n u x) (k := if (J <= j)%N then J else J.-1) :
  insertion_program K V n u p x = Value (v, r) -> insertion_program K V n u q x = Value (v, s) -> (n.-1 <= J < size v - n)%N ->
  at_list v J < at_list v J.+1 -> (size w).+1 = n ->
  pblossom (piece n J (at_list v)) (piece n J (at_list r)) (at_ L :: w) = g *: pblossom (piece n J (at_list v)) (piece n J (at_list s)) (at_ M :: w) <->
  pblossom (piece n k (at_list u)) (piece n k (at_list p)) (at_ L :: w) = g *: pblossom (piece n k (at_list u)) (piece n k (at_list q)) (at_ M :: w).
Proof. by move=> e1 e2 bJ up_J sz; rewrite (blossoms_inserted_blossom e1) // (blossoms_inserted_blossom e2). Qed.

(** FJ21.K refined: so have the curves over any finer knots.
    Hypotheses: an ordered field; $u_{n-1}\le v_J$; the piece is not empty; each knot inside the old domain that is not behind $v_{J+1}$ and follows one of
    $v_{J+1-n},\dots,v_J$ in the old domain is a new knot, at least as often. *)
Theorem FJ21_K_refined n u p q v r s J w L M g (j := interval K n u (at_list v J)) :
  refined_program K V n u p v = Value r -> refined_program K V n u q v = Value s -> enough n u v J ->
  (n.-1 <= J < size v - n)%N -> at_list v J < at_list v J.+1 -> at_list u n.-1 <= at_list v J -> (size w).+1 = n ->
  pblossom (piece n J (at_list v)) (piece n J (at_list r)) (at_ L :: w) = g *: pblossom (piece n J (at_list v)) (piece n J (at_list s)) (at_ M :: w) <->
  pblossom (piece n j (at_list u)) (piece n j (at_list p)) (at_ L :: w) = g *: pblossom (piece n j (at_list u)) (piece n j (at_list q)) (at_ M :: w).
Proof. by move=> e1 e2 often bJ up_J u_J sz; rewrite (blossoms_refined_blossom e1) // (blossoms_refined_blossom e2). Qed.
End Curves.
