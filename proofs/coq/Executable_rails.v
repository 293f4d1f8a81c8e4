(* The surface of BZZ19.16 as a whole: its rows are the rails at every parameter. *)
From Torse Require Import Prelude Blossom Curves Points Bernstein Bezier BZZ19_3 BZZ19_4_pieces FJ21_4 Executable Executable_knots
  Executable_splines Executable_mappings Executable_elimination Executable_joints Executable_surface.
From mathcomp Require Import order ssrnum.
Import Order.TTheory Num.Theory.

Section Lists.
Variables (F : realFieldType) (m : nat).
Implicit Types (x : nat -> F) (nets : seq (seq 'rV[F]_m)) (D N i j J : nat).
Local Notation at_list := (nth 0).

Lemma size_glued D nets : (0 < size nets)%N -> all (fun r => size r == D.+1) nets -> size (glued nets) = (size nets * D).+1.
Proof.
case: nets => // r nets _ /= /andP[/eqP sr sz]; rewrite size_cat sr addSn mulSn; congr (_ + _).+1.
by elim: nets sz => //= q nets ih /andP[/eqP sq /ih e]; rewrite size_cat size_behead sq e mulSn.
Qed.

Lemma size_copies D N x : size (flatten (mkseq (fun j => nseq D (x j)) N)) = (N * D)%N.
Proof.
elim: N x => // N ih x; have -> : mkseq (fun j => nseq D (x j)) N.+1 = nseq D (x 0%N) :: mkseq (fun j => nseq D (x j.+1)) N.
  by rewrite /mkseq -[N.+1]add1n iotaD map_cat (iotaDl 1 0) -map_comp.
by rewrite -[flatten (_ :: _)]/(nseq D (x 0%N) ++ flatten _) size_cat size_nseq ih mulSn.
Qed.

Lemma last_copy D J : (J %/ D < J.+1 %/ D)%N -> J.+1 = ((J %/ D).+1 * D)%N.
Proof.
case: D => [|D]; first by rewrite !divn0.
have e := divn_eq J D.+1; have lt_r := ltn_pmod J (ltn0Sn D); move: e lt_r; set q := (J %/ _)%N; set r := (J %% _)%N => e lt_r lt_q.
have [lt_D|] := ltnP r.+1 D.+1; last by rewrite mulSn {1}e => le_r; move: lt_r le_r; move: (q * D.+1)%N => a; clear; lia.
by move: lt_q; rewrite {1}e -addnS divnMDl // divn_small // addn0 ltnn.
Qed.

(* The knots x_0, ..., x_N, each D times: a list of knots, and the piece that holds a parameter. *)
Lemma copies_valid D N x (z := flatten (mkseq (fun j => nseq D (x j)) N.+1)) : (0 < D)%N -> (0 < N)%N -> (forall i, (i < N)%N -> x i < x i.+1) ->
  [/\ valid (fun x y : F => x < y) D z, size z = (N.+1 * D)%N, at_list z D.-1 = x 0%N & at_list z (size z - D) = x N].
Proof.
move=> D0 N0 up; have sz : size z = (N.+1 * D)%N := size_copies D N.+1 x.
have zE i : (i < N.+1 * D)%N -> at_list z i = x (i %/ D)%N by apply: nth_copies.
have le_x i j : (i <= j)%N -> (j <= N)%N -> x i <= x j.
  elim: j => [|j ih]; first by rewrite leqn0 => /eqP ->.
  rewrite leq_eqVlt => /orP[/eqP -> //|le_i] lt_j; apply: le_trans (ih le_i (ltnW lt_j)) (ltW (up _ lt_j)).
have lt_x i j : (i < j)%N -> (j <= N)%N -> x i < x j by move=> lt_i le_j; apply: lt_le_trans (up i (leq_trans lt_i le_j)) (le_x _ _ lt_i le_j).
have le_N i : (i < N.+1 * D)%N -> (i %/ D <= N)%N by rewrite -ltn_divLR // ltnS.
have szD : (size z - D = N * D)%N by rewrite sz mulSn addKn.
have first_ : at_list z D.-1 = x 0%N.
  by rewrite zE ?divn_small ?prednK // mulSn; move: D0; move: (N * D)%N => a; clear; lia.
have last_ : at_list z (size z - D) = x N by rewrite szD zE ?mulnK // mulSn -[X in (X < _)%N]add0n ltn_add2r.
split=> //; split=> //.
- by rewrite sz mulSn leq_add2l leq_pmull.
- by move=> i lt_i; rewrite -leNgt !zE -?sz ?(ltnW lt_i) // le_x ?leq_div2r // le_N // -sz.
- move=> i lt_i; have lt_z : (i + D < N.+1 * D)%N by move: lt_i; rewrite szD mulSn addnC ltn_add2l.
  rewrite !zE //; last by apply: leq_ltn_trans lt_z; exact: leq_addr.
  have e : ((i + D) %/ D = (i %/ D).+1)%N by rewrite divnDr ?dvdnn // divnn D0 addn1.
  by rewrite lt_eqF // e lt_x // -e le_N.
by rewrite first_ last_ lt_eqF // lt_x.
Qed.
End Lists.

Section Rails.
Variable F : realFieldType.
Implicit Types (u v w b z : seq F) (c e R S : seq 'rV[F]_3) (n p d D k i j : nat) (s t y : F).
Local Notation K := (ordered F).
Local Notation V := (rows [fieldType of F] 3).
Local Notation at_list := (nth 0).
Local Notation valid := (valid (fun x y : F => x < y)).

(* The lists that the program takes and gives. *)
Lemma surface_lists n u c p v e d w b z R S (D := if Nat.leb n (p * d) then (p * d)%N else n) (x := breaks K d w u) (N := (size x).-1) :
  surface_program K V n u c p v e d w b false = Value (z, R, S) ->
  [/\ valid n u /\ size c = (size u - n).+1, valid p v /\ size e = (size v - p).+1, valid d w & (0 < D)%N] /\
  [/\ at_list u n.-1 <= at_list w d.-1, at_list w (size w - d) <= at_list u (size u - n),
    z = flatten (mkseq (fun j => nseq D (at_list x j)) N.+1), size R = (N * D).+1 & size S = (N * D).+1].
Proof.
case/knot_listP=> hu /fitsP[sc] /knot_listP[hv] /fitsP[se] /knot_listP[hw] /fitsP[sb] E.
have [/andP[lo hi] {}E] := given_Value E; rewrite /= -leNgt in lo; rewrite /= -leNgt in hi; cbv zeta in E; rewrite -/D -/x -/N in E.
move: E; case Ec : (collect (mkseq (fun j => second_net K V D p v e d w b (at_list x j) (at_list x j.+1)) N)) => [nets|] // E.
have [<- <- <-] := Value_inj E.
have [up x0 xN x1] := BZZ19_16_breaks u hw; rewrite -/x -/N in up x0 xN x1.
have sx : size x = N.+1 by rewrite /N prednK // ltnW.
have le_x i l : (i <= l)%N -> (l <= N)%N -> at_list x i <= at_list x l.
  by move=> le_i le_l; apply: sorted_leq_nth; rewrite ?inE ?sx //; [exact: le_trans | by apply: sub_sorted up => y y'; exact: ltW | exact: leq_ltn_trans le_i _].
have [D0 le_n le_pd] : [/\ (0 < D)%N, (n <= D)%N & (p * d <= D)%N].
  by have [n0 _ _] := bounds_of hu; move: n0; rewrite /D nat_lebE; move: (p * d)%N => q; clear; case: ifP => h n0; split; lia.
have g : good [fieldType of F] D.+1 by rewrite /good pnatr_eq0 -lt0n fact_gt0.
have in_w i : (i < N)%N -> at_list w d.-1 <= at_list x i <= at_list w (size w - d).
  by move=> lt_i; rewrite -x0 -xN !le_x // ltnW.
have [sn netE] := collectP [::] Ec; have N0 : (0 < N)%N by move: x1; rewrite sx.
split; split=> //; rewrite (size_glued (D := D)) ?size_mkseq ?sn //; apply/(all_nthP [::]) => i; rewrite ?size_mkseq ?sn => lt_i.
  by rewrite nth_mkseq // /first_net size_elevation size_mkseq addSn subnKC.
by have [k2 _ [-> _]] := second_netE g le_pd hv hw (in_w i lt_i) (netE i lt_i).
Qed.

Lemma value_ofE d w b s y : valid d w -> at_list w d.-1 <= s <= at_list w (size w - d) ->
  value_of K d w b s y = (curve d (drop_ (piece_at K d w s).-1 (at_list w)) (drop_ (piece_at K d w s).-1 (at_list b))).[y].
Proof. by move=> hw in_s; have [_ sp _ _] := piece_found hw in_s; rewrite /value_of drop_scalar horner_curve. Qed.

(** BZZ19.16 rails: at every $t$ of the mapping's domain the rows of the program have the points $C_1(t)$ and $C_2(\sigma(t))$.
    Hypotheses: an ordered field; $\sigma$ does not decrease. The program looks at $\sigma$ at the breakpoints only. *)
Theorem BZZ19_16_rails n u c p v e d w b z R S t (D := if Nat.leb n (p * d) then (p * d)%N else n) (sigma := fun y => value_of K d w b y y) :
  surface_program K V n u c p v e d w b false = Value (z, R, S) ->
  (forall s y, at_list w d.-1 <= s -> s <= y -> y <= at_list w (size w - d) -> sigma s <= sigma y) ->
  at_list w d.-1 <= t <= at_list w (size w - d) ->
  mapping_value_program K V D z R t = mapping_value_program K V n u c t /\
  mapping_value_program K V D z S t = mapping_value_program K V p v e (sigma t).
Proof.
move=> E up_s in_t; have [[[hu sc] [hv se] hw D0] [lo hi ez sR sS]] := surface_lists E.
move: ez sR sS; set x := breaks K d w u; set N := (size x).-1; rewrite -/D => ez sR sS.
have [up x0 xN x1] := BZZ19_16_breaks u hw; rewrite -/x -/N in up x0 xN x1.
have sx : size x = N.+1 by rewrite /N prednK // ltnW.
have N0 : (0 < N)%N by move: x1; rewrite sx.
have lt_x i : (i < N)%N -> at_list x i < at_list x i.+1.
  by move=> lt_i; apply: (sorted_ltn_nth lt_trans 0 up) => //; rewrite inE sx ltnS // ltnW.
have [hz sz z0 zN] := copies_valid D0 N0 lt_x; rewrite -ez in hz sz z0 zN.
have szD : (size z - D = N * D)%N by rewrite sz mulSn addKn.
have in_z : at_list z D.-1 <= t <= at_list z (size z - D) by rewrite z0 zN x0 xN.
have in_u : at_list u n.-1 <= t <= at_list u (size u - n) by have/andP[h1 h2] := in_t; rewrite (le_trans lo) // (le_trans h2).
have [bJ J_t up_J t_J] := lies_in hz in_z; move: bJ J_t up_J t_J; set J := interval K D z t => bJ J_t up_J t_J.
have zE i : (i < N.+1 * D)%N -> at_list z i = at_list x (i %/ D)%N by rewrite ez; apply: nth_copies.
have lt_J : (J.+1 < N.+1 * D)%N by rewrite mulSn -szD; move: bJ D0; clear; lia.
have [j [eJ eJ' lt_j]] : exists j, [/\ (J.+1 = j.+1 * D)%N, (J %/ D = j)%N & (j < N)%N].
  exists (J %/ D)%N; split=> //; last by rewrite ltn_divLR // -szD; case/andP: bJ.
  apply: last_copy; rewrite ltnNge; apply/negP=> le_J; move: up_J; rewrite (zE _ lt_J) (zE _ (ltnW lt_J)).
  by rewrite (_ : J.+1 %/ D = J %/ D)%N ?ltxx //; apply/eqP; rewrite eqn_leq le_J leq_div2r.
have ek : (J.+1 - D = j * D)%N by rewrite eJ mulSn addKn.
have zJ : at_list z J = at_list x j by rewrite zE ?eJ' // ltnW.
have zJ1 : at_list z J.+1 = at_list x j.+1 by rewrite (zE _ lt_J) eJ mulnK.
have x_t : at_list x j <= t by rewrite -zJ.
have t_x : t <= at_list x j.+1 by rewrite -zJ1; case: t_J => [/ltW //|[-> _]]; have/andP[] := in_z.
have [lt_xj [k2 [sp2 b2 l1 l2 l3] eq]] := BZZ19_16_program E lt_j.
move: lt_xj l1 l2 l3 eq; rewrite -/x -/D => lt_xj l1 l2 l3 eq.
have none (l : seq F) y : (forall q, q \in l -> q \in w ++ u) -> y <= at_list x j.+1 -> forall q, q \in l -> ~~ (at_list x j < q < y).
  move=> sub h2 q qy; have lt_sx : (j.+1 < size x)%N by rewrite sx ltnS.
  by apply: contra (none_between hw lt_sx (sub q qy)) => /andP[-> h3]; exact: lt_le_trans h3 h2.
have le_x i l : (i <= l)%N -> (l <= N)%N -> at_list x i <= at_list x l.
  by move=> le_i le_l; apply: sorted_leq_nth; rewrite ?inE ?sx //; [exact: le_trans | by apply: sub_sorted up => y y'; exact: ltW | exact: leq_ltn_trans le_i _].
have xw : at_list w d.-1 <= at_list x j by rewrite -x0 le_x // ltnW.
have wx : at_list x j.+1 <= at_list w (size w - d) by rewrite -xN le_x.
have sigE y : at_list x j <= y -> y <= at_list x j.+1 -> value_of K d w b (at_list x j) y = sigma y.
  rewrite le_eqVlt => /orP[/eqP <- //|lt_y] le_y.
  rewrite /sigma !value_ofE // ?xw ?(le_trans le_y) ?(le_trans xw (ltW lt_y)) ?(le_trans (ltW lt_xj)) //.
  apply: next_value => //; first exact: le_trans le_y wx.
  by apply: none => // q qw; rewrite mem_cat qw.
have in_xj : at_list w d.-1 <= at_list x j <= at_list w (size w - d) by rewrite xw (le_trans (ltW lt_xj)).
rewrite -!(value_ofE b _ hw in_xj) !sigE ?(ltW lt_xj) // in l1 l2 l3.
have st1 : sigma (at_list x j) <= sigma t by apply: up_s => //; have/andP[] := in_t.
have st2 : sigma t <= sigma (at_list x j.+1) by apply: up_s => //; have/andP[] := in_t.
have [p0 le_p _] := bounds_of hv.
have in_v : at_list v (p + k2 - 1) <= sigma t <= at_list v (p + k2) by rewrite (le_trans l1 st1) (le_trans st2 l3).
have dom_v : at_list v p.-1 <= sigma t <= at_list v (size v - p).
  have/andP[h1 h2] := in_v; apply/andP; split; [apply: le_trans h1 | apply: le_trans h2 _]; apply: (knots_up hv); move: b2 p0 le_p; clear; lia.
have same_u y : at_list x j <= y -> y <= at_list x j.+1 -> forall f : nat -> F,
    (curve n (drop_ (piece_at K n u (at_list x j)).-1 (at_list u)) (drop_ (piece_at K n u (at_list x j)).-1 f)).[y]
    = (curve n (drop_ (piece_at K n u y).-1 (at_list u)) (drop_ (piece_at K n u y).-1 f)).[y].
  rewrite le_eqVlt => /orP[/eqP <- //|lt_y] le_y f; apply: next_value => //; [exact: le_trans lo xw | exact: le_trans le_y (le_trans wx hi) |].
  by apply: none => // q qu; rewrite mem_cat qu orbT.
have [hR hS] : ev (pcurve D (drop_ (j * D) (at_list z)) (drop_ (j * D) (at_list R))) t
      = ev (pcurve n (drop_ (piece_at K n u (at_list x j)).-1 (at_list u)) (drop_ (piece_at K n u (at_list x j)).-1 (at_list c))) t /\
    ev (pcurve D (drop_ (j * D) (at_list z)) (drop_ (j * D) (at_list S))) t = ev (pcurve p (drop_ k2 (at_list v)) (drop_ k2 (at_list e))) (sigma t).
  have := (eq 0 t, eq 1 t); rewrite /ruled_surface subr0 subrr !scale1r !scale0r !addr0 !add0r => -[-> e1]; split=> //.
  move: e1; rewrite (_ : ev (after _ 'X) t = ev (pcurve D (drop_ (j * D) (at_list z)) (drop_ (j * D) (at_list S))) t) => [->|].
    by apply/rowP=> l; rewrite !mxE horner_comp -(value_ofE b _ hw in_xj) sigE.
  by apply/rowP=> l; rewrite !mxE horner_comp hornerX.
split.
  have -> : mapping_value_program K V n u c t
      = Value (ev (pcurve n (drop_ ((interval K n u t).+1 - n) (at_list u)) (drop_ ((interval K n u t).+1 - n) (at_list c))) t).
    by apply/BZZ19_3_value.
  apply/BZZ19_3_value; split=> //; first by rewrite sR szD.
  rewrite -/J ek hR; apply/rowP=> l; rewrite !mxE; have := same_u t x_t t_x (coord (at_list c) l).
  by have [-> _] := piece_atE hu in_u => ->.
have -> : mapping_value_program K V p v e (sigma t)
    = Value (ev (pcurve p (drop_ ((interval K p v (sigma t)).+1 - p) (at_list v)) (drop_ ((interval K p v (sigma t)).+1 - p) (at_list e))) (sigma t)).
  by apply/BZZ19_3_value.
apply/BZZ19_3_value; split=> //; first by rewrite sS szD.
rewrite -/J ek hS; apply/rowP=> l; rewrite !mxE; have [eI sp_I] := piece_atE hv dom_v.
have := piece_lies hv dom_v; rewrite eI /=; set h := (_ - p)%N => -[[/andP[_ bI] I_t up_I t_I] _].
have eh : ((p + h - 1).+1 = p + h)%N by move: p0; clear; lia.
apply: (same_piece (coord (at_list e) l) hv bI b2 sp_I sp2 _ in_v).
by rewrite I_t /= -eh; case: t_I => [/ltW //|[-> _]]; have/andP[] := dom_v.
Qed.
End Rails.
