(* The program for a higher degree: its knots, and that the curve stays. *)
From Torse Require Import Prelude Blossom Curves Points Insertion Elevation FJ21_4 Executable Executable_knots Executable_splines Executable_mappings
  Executable_joints Executable_surface Executable_windows Executable_refinement.
From mathcomp Require Import order ssrnum.
Import Order.TTheory Num.Theory.

Section Knots.
Variable F : realFieldType.
Implicit Types (u v r : seq F) (n i l : nat) (a b t x y : F).
Local Notation K := (ordered F).
Local Notation at_list := (nth 0).
Local Notation valid := (valid (fun x y : F => x < y)).

Lemma doubled_cons x u : doubled K (x :: u) = (if (size u == 0%N) || (x != at_list u 0) then [:: x; x] else [:: x]) ++ doubled K u.
Proof.
have <- : closes K (x :: u) 0 = (size u == 0%N) || (x != at_list u 0) by rewrite /closes nat_eqbE eqSS eq_sym.
by rewrite /doubled /mkseq -[size (x :: u)]/(1 + size u)%N iotaD map_cat (iotaDl 1 0) -map_comp; congr (_ ++ flatten _).
Qed.

Lemma mem_doubled u : doubled K u =i u.
Proof.
by elim: u => // x u ih y; rewrite doubled_cons mem_cat ih inE; case: ifP => _; rewrite !inE // orbb.
Qed.

Lemma doubled_more (P : pred F) u : has P u -> (count P u < count P (doubled K u))%N.
Proof.
elim: u => // x u ih; rewrite [has _ _]/= doubled_cons count_cat [count P (_ :: _)]/=; case: (boolP (has P u)) => [/ih lt_u _|none].
  by case: ifP => _ /=; rewrite ?addn0 -?addnA ?ltn_add2l ?(leq_trans lt_u) ?leq_addl.
rewrite orbF => Px; rewrite ifT /=; first by move: none; rewrite has_count Px; clear; lia.
by case: u none {ih} => //= y u /norP[nPy _]; apply/eqP=> e; rewrite e (negPf nPy) in Px.
Qed.

Lemma path_doubled x u : path <=%R x u -> path <=%R x (doubled K u).
Proof.
elim: u x => // y u ih x /= /andP[le_xy /ih le_y]; rewrite doubled_cons cat_path; by case: ifP => _ /=; rewrite le_xy ?lexx.
Qed.

Lemma doubled_times u y : sorted <=%R u -> (count_mem y (doubled K u) <= (count_mem y u).+1)%N.
Proof.
elim: u => // x u ih le_u; rewrite doubled_cons count_cat [count _ (_ :: _)]/=.
have {}ih := ih (path_sorted le_u); case: ifP => [last_|_] /=; last by rewrite addn0 -addnS leq_add2l.
have [e|_] := eqVneq x y; last by rewrite !add0n.
suff -> : count_mem y (doubled K u) = 0%N by rewrite !addn0 add1n.
apply/count_memPn; rewrite mem_doubled; case: u le_u last_ {ih} => // z u /= /andP[le_z le_u]; rewrite -e => ne.
rewrite inE negb_or ne /=; apply/negP=> xu; have /allP/(_ _ xu) := order_path_min le_trans le_u.
by rewrite leNgt lt_neqAle ne le_z.
Qed.

(* Of a sorted list those that are small come first. *)
Lemma count_first (P : pred F) r l : (forall x y, x <= y -> P y -> P x) -> sorted <=%R r -> (l < size r)%N -> P (at_list r l) = (l < count P r)%N.
Proof.
move=> down; elim: r l => // x r ih l le_r; rewrite [count _ _]/=; have {}ih := fun l => ih l (path_sorted le_r).
have ge_x z : z \in r -> x <= z by move=> zr; have /allP/(_ _ zr) := order_path_min le_trans le_r.
case: (boolP (P x)) => [Px|nPx]; first by case: l => [|l] //= /ih ->.
rewrite add0n (_ : count P r = 0%N); last first.
  by apply/eqP; rewrite -leqn0 leqNgt -has_count; apply/hasPn=> z zr; apply/negP=> Pz; case/negP: nPx; apply: down (ge_x z zr) Pz.
rewrite ltn0; case: l => [|l] lt_l; apply/negbTE => //=; apply/negP=> Pz; case/negP: nPx; apply: down Pz; exact/ge_x/mem_nth.
Qed.

Lemma sorted_knots n u : valid n u -> sorted <=%R u.
Proof.
by move=> hu; apply/(sortedP 0) => i lt_i; apply: (knots_up hu); rewrite leqnSn.
Qed.

(* The knots that the program gives: the domain stays, and inside it each knot is there once more. *)
Lemma elevated_knotsE n u (v := elevated_knots K n u) : valid n u ->
  [/\ valid n.+1 v, at_list v n = at_list u n.-1, at_list v (size v - n.+1) = at_list u (size u - n) & holds_knots 1 n u n.+1 v].
Proof.
move=> hu; have [n0 le_n dom] := bounds_of hu; pose r := doubled K u; pose a := at_list u n.-1; pose b := at_list u (size u - n).
have lt_ab : a < b by rewrite lt_neqAle dom (knots_up hu) //; lia.
have [n_u L_u] : (n.-1 < size u)%N /\ (size u - n < size u)%N by lia.
have [au bu] : a \in u /\ b \in u by split; apply: mem_nth.
have le_u := sorted_knots hu; have le_r : sorted <=%R r.
  by rewrite /r; case: (u) (le_u) => // x s le_s; apply: (@path_sorted _ _ x); apply: path_doubled; rewrite /= lexx.
pose small x := x <= a; pose low x := x < b.
have down_a x y : x <= y -> small y -> small x by exact: le_trans.
have down_b x y : x <= y -> low y -> low x by exact: le_lt_trans.
pose f := count small r; pose g := count low r; pose d := (f - n.+1)%N.
have n_f : (n.+1 <= f)%N.
  apply: leq_ltn_trans (doubled_more _); last by apply/hasP; exists a; [exact: au | exact: lexx].
  by have /esym := count_first down_a le_u n_u; rewrite /small lexx prednK.
have f_g : (f <= g)%N by apply: sub_count => x le_x; apply: le_lt_trans lt_ab.
have g_n : (g + n.+1 <= size r)%N.
  rewrite -(count_predC low r) leq_add2l; apply: leq_ltn_trans (doubled_more _); last first.
    by apply/hasP; exists b; [exact: bu | rewrite /= /low ltxx].
  have e := count_first down_b le_u L_u; rewrite {1}/low ltxx in e; have := count_predC low u.
  have {e} : (count low u <= size u - n)%N by rewrite leqNgt -e.
  by move: le_n; clear; lia.
have [d1 d2 d3] : [/\ (d + n < f)%N, (d + n < size r)%N & (g < size r)%N] by rewrite /d; move: n_f f_g g_n; clear; move: f g (size r) => x y z; clear; split; lia.
have vE : v = drop d (take (g + n.+1) r).
  by rewrite /v /elevated_knots /d /f (@eq_count _ _ small) // => x; rewrite /= -leNgt.
have sz : size v = (g + n.+1 - d)%N by rewrite vE size_drop size_takel.
have nthE i : (i < size v)%N -> at_list v i = at_list r (d + i).
  by move=> lt_i; rewrite vE nth_drop nth_take //; move: lt_i; rewrite sz; clear; lia.
have at_up i j : (i <= j)%N -> (j < size r)%N -> at_list r i <= at_list r j.
  by move=> le_i lt_j; apply: sorted_leq_nth; rewrite ?inE //; [exact: le_trans | exact: leq_ltn_trans lt_j].
have e_a : at_list v n = a.
  rewrite nthE; last by rewrite sz /d; move: n_f f_g; clear; lia.
  have ar : a \in r by rewrite mem_doubled.
  apply/eqP; rewrite eq_le; apply/andP; split.
    by rewrite -/(small _) (count_first down_a).
  have [q lt_q e_q] := nthP 0 ar; have: small (at_list r q) by rewrite e_q /small lexx.
  rewrite (count_first down_a) // -/f => lt_f; rewrite -e_q; apply: at_up => //; move: lt_f n_f; rewrite /d; clear; lia.
have e_b : at_list v (size v - n.+1) = b.
  rewrite nthE; last by rewrite sz /d; move: n_f f_g; clear; lia.
  rewrite (_ : d + _ = g)%N; last by rewrite sz /d; move: n_f f_g; clear; lia.
  have br : b \in r by rewrite mem_doubled.
  apply/eqP; rewrite eq_le; apply/andP; split; last first.
    by rewrite leNgt -/(low _) (count_first down_b) ?ltnn.
  have [q lt_q e_q] := nthP 0 br; have: ~~ low (at_list r q) by rewrite e_q /low ltxx.
  by rewrite (count_first down_b) // -/g -leqNgt => le_q; rewrite -e_q at_up.
split=> //; last first.
  move=> x y _ yu /andP[a_x x_y] y_b _; have in_y : a < y < b by rewrite (le_lt_trans a_x).
  rewrite addn1; apply: leq_trans (doubled_more (P := pred1 y) _) _; first by rewrite has_pred1.
  rewrite -/r -[X in (count _ X <= _)%N](cat_take_drop (g + n.+1) r) count_cat -[X in (count _ X + _ <= _)%N](cat_take_drop d (take _ r)) count_cat -vE.
  rewrite [X in (X + _ + _)%N](_ : _ = 0%N) ?[X in (_ + _ + X)%N](_ : _ = 0%N) ?addn0 //; apply/count_memPn/negP=> /(nthP 0)[q].
    rewrite size_drop nth_drop ltn_subRL => lt_q e_q; have/andP[_] := in_y.
    by rewrite -e_q -/(low _) (count_first down_b) // -/g ltnNge -addnA leq_addr.
  rewrite size_takel; last by rewrite size_takel // /d; move: n_f f_g; clear; lia.
  have [d4 d5] : (d <= f)%N /\ (d <= g + n.+1)%N by rewrite /d; move: f_g; clear; lia.
  move=> lt_q; rewrite !nth_take // 1?(leq_trans lt_q) // => e_q; have/andP[] := in_y.
  rewrite ltNge -e_q -/(small _) (count_first down_a) // -/f ?(leq_trans lt_q) //.
  by apply: leq_trans (leq_addr n d) (ltnW d2).
split=> //.
- by rewrite sz /d; move: n_f f_g; clear; lia.
- by move=> i lt_i; rewrite -leNgt !nthE //; [apply: at_up; move: lt_i; rewrite sz; move: g_n; clear; lia | apply: ltnW].
- move=> i lt_i; have i_v : (i + n.+1 < size v)%N by move: lt_i; clear; lia.
  rewrite !nthE //; last by move: i_v; clear; lia.
  have lt_r : (d + (i + n.+1) < size r)%N by move: i_v; rewrite sz; move: g_n; clear; lia.
  apply/eqP=> e; have : (n.+2 <= count_mem (at_list r (d + i)) r)%N.
    apply: (@count_run _ _ _ (d + i)); first by rewrite (_ : d + i + n.+2 = (d + (i + n.+1)).+1)%N //; clear; lia.
    move=> l /andP[le_l lt_l]; have l_d : (l <= d + (i + n.+1))%N by move: lt_l; clear; lia.
    by apply/eqP; rewrite eq_le {1}e !at_up // (leq_ltn_trans l_d).
  by rewrite ltnNge (leq_trans (doubled_times _ le_u)) // ltnS times_of.
by rewrite e_a e_b.
Qed.
End Knots.

Section Curves.
Variables (F : realFieldType) (m : nat).
Implicit Types (u v : seq F) (c r : seq 'rV[F]_m) (n i j : nat) (t y : F).
Local Notation K := (ordered F).
Local Notation V := (rows [fieldType of F] m).
Local Notation at_list := (nth 0).
Local Notation valid := (valid (fun x y : F => x < y)).
Local Notation piece n i u := (drop_ (i.+1 - n) u).

(** blossoms raised_value: the program for a higher degree gives a value iff the list is one of knots and there are as many points as it asks for; then
    the domain stays.
    Hypotheses: an ordered field. *)
Theorem blossoms_raised_value n u c :
  ((exists v r, raised_program K V n u c = Value (v, r)) <-> valid n u /\ size c = (size u - n).+1) /\
  forall v r, raised_program K V n u c = Value (v, r) -> at_list v n = at_list u n.-1 /\ at_list v (size v - n.+1) = at_list u (size u - n).
Proof.
split=> [|v r]; last first.
  case/knot_listP=> hu /fitsP[_] /knot_listP[_ e]; have [<- _] := Value_inj e; by have [] := elevated_knotsE hu.
split=> [[v [r]]|[hu sc]]; first by case/knot_listP=> hu /fitsP[sc] _.
do 2!eexists; rewrite /raised_program; apply/knot_listP; split; first exact: hu.
apply/fitsP; split=> //; apply/knot_listP; split; last by reflexivity.
by have [] := elevated_knotsE hu.
Qed.

Lemma raised_form n u c v r (l : 'I_m) (b := fun k => blossom (drop_ k (at_list u)) (drop_ k (coord (at_list c) l)))
    (G := fun k a => if size a == n.+1 then mean_form n (b k) a else 0) : raised_program K V n u c = Value (v, r) ->
  [/\ valid n u, valid n.+1 v, holds_knots 1 n u n.+1 v & [/\ forall k, span n (drop_ k (at_list u)) -> polar n.+1 (G k),
    forall i, (i <= size v - n.+1)%N -> coord (at_list r) l i = G (piece_of K n u v n.+1 i).-1 (knots (at_list v) i n.+1) &
    forall i j J, holds_at 1 n u n.+1 v J -> (n <= J < size v - n.+1)%N -> at_list v J < at_list v J.+1 -> lies n u (at_list v J) j -> (i <= J.+1 <= i + n.+1)%N ->
      G (piece_of K n u v n.+1 i).-1 (knots (at_list v) i n.+1) = G (j.+1 - n)%N (knots (at_list v) i n.+1)]].
Proof.
move=> e; have [hv sr rE] := blossoms_raised e; have hu : valid n u by case/knot_listP: e.
have ev : v = elevated_knots K n u by case/knot_listP: e => _ /fitsP[_] /knot_listP[_ e]; have [<- _] := Value_inj e.
have [_ _ _ H] := elevated_knotsE hu; rewrite -ev in H.
have G_n k a : size a = n.+1 -> G k a = mean_form n (b k) a by rewrite /G => ->; rewrite eqxx.
split=> //; split=> [k sp|i le_i|i j J HJ bJ up_J h_j in_i]; first exact: mean_polar.
  rewrite G_n ?size_knots // /coord rE // mxE summxE; congr (_ * _); apply: eq_big_nat => h /andP[_ lt_h].
  rewrite mxE /b /omit (_ : (nth _ _ h).2 = 1) ?mul1r //.
  by rewrite /knots (nth_map 0%N) // size_iota.
rewrite !G_n ?size_knots // /mean_form; congr (_ * _); apply: eq_big_nat => h /andP[_ lt_h]; congr (_ * _).
have lt_k : (h < size (knots (at_list v) i n.+1))%N by rewrite size_knots.
apply: (@window_blossom _ n n.+1 1 u v J j) => // [|y]; first by rewrite size_without ?size_knots.
rewrite (seq.permP (perm_without (direction F) lt_k)) /= addnC leq_add2l; exact: leq_b1.
Qed.

(** blossoms raised_blossom: on every piece $[v_J,v_{J+1}]$ of the new knots the blossom of the new vertices at $t_0,\dots,t_n$ is the mean of those of the curve's
    piece that holds $v_J$, one argument left out.
    Hypotheses: an ordered field; the piece is not empty. *)
Theorem blossoms_raised_blossom n u c v r J (s : seq F) (j := interval K n u (at_list v J)) (w := [seq at_ t | t <- s]) :
  raised_program K V n u c = Value (v, r) -> (n <= J < size v - n.+1)%N -> at_list v J < at_list v J.+1 -> size s = n.+1 ->
  pblossom (piece n.+1 J (at_list v)) (piece n.+1 J (at_list r)) w
    = n.+1%:R^-1 *: \sum_(0 <= h < n.+1) pblossom (piece n j (at_list u)) (piece n j (at_list c)) (omit h w).
Proof.
move=> e bJ up_J sz; have szw : size w = n.+1 by rewrite size_map.
apply/rowP=> l; have [hu hv H [pol rE same]] := raised_form l e; rewrite !mxE summxE.
have [_ stay] := blossoms_raised_value n u c; have [v_a _] := stay _ _ e.
have u_J : at_list u n.-1 <= at_list v J.
  by rewrite -v_a (knots_up hv) //; have [_ le_p _] := bounds_of hv; move: bJ le_p; clear; lia.
rewrite (piece_stays hu hv pol rE same (holds_pieces hv H bJ) bJ up_J (lies_under hu u_J) szw) szw eqxx; congr (_ * _); apply: eq_big_nat => h /andP[_ lt_h].
by rewrite mxE (nth_map 0) ?sz // mul1r.
Qed.

(** blossoms raised_curve: the point at $t$ of the curve in the higher degree is that of the curve, for every $t$ of the domain.
    Hypotheses: an ordered field. *)
Theorem blossoms_raised_curve n u c v r t q : raised_program K V n u c = Value (v, r) ->
  mapping_value_program K V n u c t = Value q -> mapping_value_program K V n.+1 v r t = Value q.
Proof.
move=> e /BZZ19_3_value[hu sc in_u ->]; have [hv sr _] := blossoms_raised e.
have [_ stay] := blossoms_raised_value n u c; have [v_a v_b] := stay _ _ e.
have in_v : at_list v n <= t <= at_list v (size v - n.+1) by rewrite v_a v_b.
apply/BZZ19_3_value; split=> //; apply/rowP=> l; rewrite !mxE !horner_curve; [|exact: span_at..].
have [_ _ H [pol rE same]] := raised_form l e; apply/esym.
have [bJ _ _ _] := lies_in hv in_v.
apply: (spline_stays (c := coord (at_list c) l) hu hv pol rE same (holds_pieces hv H bJ) _ in_v in_u) => [|k].
  by rewrite negb_and -leNgt -v_a (knots_up hv) //; have [_ le_p _] := bounds_of hv; move: bJ le_p; clear; lia.
by rewrite size_nseq eqxx mean_nseq // unitfE pnatr_eq0.
Qed.
End Curves.
