(* Knots that are not there often enough: some curve shows it, so that the conditions under which pieces have the same blossom, and finer knots the same curve, are
   necessary for all curves.
   Definitions:
     doubled_ends y n i    n knots y, then y + 1
     peak y n q a          the blossom over these knots of the points that are 0 but for the one with the index q, 1 *)
From Torse Require Import Prelude Blossom Curves Points Insertion FJ21_4 FJ21_7 Executable Executable_knots Executable_splines Executable_mappings Executable_joints
  Executable_surface Executable_windows Executable_refinement.
From mathcomp Require Import order ssrnum.
Import Order.TTheory Num.Theory.

Section Peak.
Variable F : fieldType.
Implicit Types (x y : F) (a : seq (F * F)) (s : seq F) (n m q r : nat).

Definition doubled_ends y n i : F := y + (n <= i)%:R.
Definition peak y n q a := blossom (doubled_ends y n) (fun i => (i == q)%:R) a.

Lemma span_ends y n : span n (doubled_ends y n).
Proof. by move=> i j lt_i /andP[le_j _]; rewrite /doubled_ends le_j leqNgt lt_i addr0 addrC addKr unitr1. Qed.

Lemma peak_cons y m q x a : size a = m ->
  peak y m.+1 q (at_ x :: a) = (y + 1 - x) * peak y m q a + (x - y) * (if q is q'.+1 then peak y m q' a else 0).
Proof.
move=> sz; have -> : (if q is q'.+1 then peak y m q' a else 0) = blossom (doubled_ends y m) (fun i => (i.+1 == q)%:R) a.
  by case: q => [|q] //; rewrite -(blossom0 (doubled_ends y m) a); apply: blossom_ext.
rewrite /peak /= -blossom_linear sz; apply: blossom_ext => i; rewrite sz => le_i.
by rewrite /step /doubled_ends leq_addl leqNgt ltnS le_i /= !mul1r addr0 [y + 1 - y]addrAC subrr add0r divr1.
Qed.

Lemma peak_y y m q r a : size a = m -> peak y (r + m) q (nseq r (at_ y) ++ a) = peak y m q a.
Proof.
move=> sz; elim: r => // r ih; rewrite addSn [nseq _ _ ++ _]/= peak_cons ?size_cat ?size_nseq ?sz // ih.
by rewrite addrAC subrr add0r mul1r mul0r addr0.
Qed.

Lemma peak_out y m q a : (m < q)%N -> size a = m -> peak y m q a = 0.
Proof.
by move=> lt_m sz; rewrite -(blossom0 (doubled_ends y m) a); apply: blossom_ext => i; rewrite sz => le_i; rewrite ltn_eqF // (leq_ltn_trans le_i).
Qed.

Lemma peak_top y s : peak y (size s) (size s) [seq at_ x | x <- s] = \prod_(x <- s) (x - y).
Proof.
elim: s => [|x s ih]; first by rewrite big_nil.
by rewrite big_cons [size _]/= [map _ _]/= peak_cons ?size_map // peak_out ?size_map // mulr0 add0r ih.
Qed.

Lemma peak_front y s n q r : size s = n -> (r <= count_mem y s)%N -> exists2 w : seq F, perm_eq s (nseq r y ++ w) &
  (r + size w)%N = n /\ peak y n q [seq at_ x | x <- s] = peak y (size w) q [seq at_ x | x <- w].
Proof.
move=> sz /perm_nseq[w pw sw]; exists w => //; rewrite -sz sw; split=> //.
rewrite -(peak_y y q r (size_map _ w)) sw -map_nseq -map_cat; apply: blossoms_symmetric; last exact: perm_map.
by rewrite size_map; exact: span_ends.
Qed.

Lemma peak_many y s n q : size s = n -> (q <= n)%N -> (n - q < count_mem y s)%N -> peak y n q [seq at_ x | x <- s] = 0.
Proof.
by move=> sz le_q lt_q; have [w _ [sw ->]] := peak_front q sz lt_q; apply: peak_out; rewrite ?size_map //; move: sw le_q; clear; lia.
Qed.

Lemma peak_exact y s n : size s = n -> peak y n (n - count_mem y s) [seq at_ x | x <- s] != 0.
Proof.
move=> sz; have [w pw [sw ->]] := @peak_front y s n (n - count_mem y s) (count_mem y s) sz (leqnn _).
rewrite (_ : n - _ = size w)%N; last by move: sw; clear; lia.
rewrite peak_top prodf_seq_neq0; apply/allP=> x xw; rewrite subr_eq0 /=; apply/negP=> /eqP e.
have := seq.permP pw (pred1 y); rewrite count_cat count_nseq /= eqxx mul1n => /eqP; rewrite -{1}[count _ s]addn0 eqn_add2l eq_sym -leqn0 leqNgt -has_count.
by case/hasP; exists x => //=; rewrite e.
Qed.
End Peak.

Section Needs.
Variable F : realFieldType.
Implicit Types (u v s : seq F) (n i j h l J : nat) (t x y : F).
Local Notation K := (ordered F).
Local Notation at_list := (nth 0).
Local Notation valid := (valid (fun x y : F => x < y)).
Local Notation piece n i u := (drop_ (i.+1 - n) u).

Lemma knots_map (w : nat -> F) i n : knots w i n = [seq at_ x | x <- [seq w l | l <- iota i n]].
Proof. by rewrite -map_comp. Qed.

Lemma count_at y s : count_mem (at_ y) [seq at_ x | x <- s] = count_mem y s.
Proof. by rewrite count_map; apply: eq_count => x /=; rewrite xpair_eqE eqxx andbT. Qed.

(** blossoms crossed_needs_knots: where a knot $y$ with $u_i<y\le u_j$ is among the arguments less often than among the knots some curve has blossoms on the pieces
    that begin at $u_i$ and at $u_j$ that differ: on the first it is 0.
    Hypotheses: an ordered field; the list of knots is accepted; the piece $j$ is not empty. *)
Theorem blossoms_crossed_needs_knots n u i j y s (a := [seq at_ x | x <- s]) : valid n u -> size s = n -> (n.-1 <= i <= j)%N -> (j < size u - n)%N ->
  at_list u j < at_list u j.+1 -> at_list u i < y <= at_list u j -> (count_mem y s < count_mem y u)%N ->
  exists c : nat -> F, blossom (piece n i (at_list u)) (piece n i c) a = 0 /\ blossom (piece n j (at_list u)) (piece n j c) a != 0.
Proof.
move=> hv sz /andP[le_i le_ij] lt_j up_j /andP[i_y y_j] few; have [n0 le_n _] := bounds_of hv.
have yu : y \in u by rewrite -has_pred1 has_count; apply: leq_ltn_trans few.
pose p := index y u; have lt_p : (p < size u)%N by rewrite index_mem.
have e_p : at_list u p = y by rewrite nth_index.
have i_p : (i < p)%N.
  by rewrite ltnNge; apply/negP=> le_p; move: i_y; rewrite -e_p ltNge (knots_up hv) // le_p; move: le_ij lt_j; clear; lia.
have all_y l : (l < size u)%N -> at_list u l = y -> (p <= l <= j)%N.
  move=> lt_l e_l; apply/andP; split; rewrite leqNgt; apply/negP=> h; first by have := before_find 0 h; rewrite /= e_l eqxx.
  have up : at_list u j.+1 <= at_list u l by apply: (knots_up hv); rewrite h.
  by move: (lt_le_trans up_j up); rewrite e_l ltNge y_j.
pose q := (n - count_mem y s)%N; have le_s : (count_mem y s <= n)%N by rewrite -sz count_size.
pose c l := if (l <= p)%N then 0 else peak y n q (knots (at_list u) l n).
exists c; split.
  apply: etrans (blossom0 (piece n i (at_list u)) a); apply: blossom_ext => l; rewrite size_map sz => le_l; rewrite /drop_ /c ifT //.
  by move: i_p le_i le_l n0; clear; lia.
have sp_j : span n (piece n j (at_list u)) by apply: blossoms_carried; rewrite ?lt_eqF // lt_j (leq_trans le_i).
have sza : size a = n by rewrite size_map.
have := blossoms_unique (blossom_polar (fun i => (i == q)%:R) (@span_ends F y n)) sp_j sza; rewrite sza eqxx => e.
rewrite (_ : blossom _ _ _ = peak y n q a); first exact: peak_exact.
rewrite /peak e; apply: blossom_ext => l; rewrite sza size_knots eqxx => le_l.
rewrite -[blossom (doubled_ends _ _) _ _]/(peak y n q _) {1}/drop_ /c; set l' := (j.+1 - n + l)%N.
have -> : knots (piece n j (at_list u)) l n = knots (at_list u) l' n.
  by rewrite /knots /l' iotaDl -map_comp.
case: ifP => // le_l'; rewrite knots_map peak_many ?size_map ?size_iota ?leq_subr //.
rewrite subKn // -[X in (_ < X)%N]count_at -knots_map (@count_knots F y u) //; first by move: le_l lt_j le_i le_ij; rewrite /l'; clear; lia.
by move=> k lt_k /(all_y k lt_k); move: le_l' le_i le_ij; rewrite /l'; clear; lia.
Qed.

Lemma knot_under n u t h y : valid n u -> lies n u t h -> y \in u -> y <= t -> y < at_list u (size u - n) -> y <= at_list u h.
Proof.
move=> hu [b _ _ in_h] yu y_t y_L; rewrite leNgt; apply/negP=> lt_y; have [n0 le_n _] := bounds_of hu.
have ge_y : at_list u h.+1 <= y by apply: (next_knot hu) => //; move: b n0 le_n; clear; lia.
by case: in_h => [lt_t|[e _]]; [move: (lt_le_trans lt_t ge_y); rewrite ltNge y_t | move: y_L; rewrite -e ltNge ge_y].
Qed.

Lemma count_window v i n y : (i + n <= size v)%N -> (count_mem y [seq at_list v l | l <- iota i n] <= count_mem y v)%N.
Proof. by move=> le_n; rewrite [X in (_ <= X)%N]count_iota count_map -(subnKC le_n) !iotaD !count_cat addnAC leq_addl. Qed.

(* No polynomial but 0 vanishes on an interval. *)
Lemma vanishes (f : {poly F}) x y : x < y -> (forall t, x < t < y -> f.[t] = 0) -> f = 0.
Proof.
move=> lt_xy zeros; have up : 0 < y - x by rewrite subr_gt0.
apply: (@roots_geq_poly_eq0 _ f [seq x + (y - x) / i.+2%:R | i <- iota 0 (size f)]).
- apply/allP=> _ /mapP[i _ ->]; rewrite rootE zeros // ltr_addl divr_gt0 ?ltr0n //= -ltr_subr_addl ltr_pdivr_mulr ?ltr0n //.
  by rewrite ltr_pmulr // ltr1n.
- rewrite map_inj_uniq ?iota_uniq // => i j /addrI/(mulfI (lt0r_neq0 up))/invr_inj/eqP; rewrite eqr_nat => /eqP e; lia.
by rewrite size_map size_iota.
Qed.

Lemma same_blossoms n (w w' b c : nat -> F) x y a : span n w -> span n w' -> x < y ->
  (forall t, x < t < y -> blossom w b (nseq n (at_ t)) = blossom w' c (nseq n (at_ t))) -> size a = n -> blossom w b a = blossom w' c a.
Proof.
move=> sp sp' lt_xy same sz; rewrite -(blossoms_refinement c sp' sp sz).
have nz : n`!%:R != 0 :> F by rewrite pnatr_eq0 -lt0n fact_gt0.
have e : curve n w b = curve n w (fun i => blossom w' c (knots w i n)).
  apply/eqP; rewrite -subr_eq0; apply/eqP; apply: (vanishes lt_xy) => t in_t.
  by rewrite hornerD hornerN !horner_curve // blossoms_refinement ?size_nseq // same // subrr.
by apply: blossom_ext => i; rewrite sz; apply: (FJ21_7_1_polarisation nz sp e).
Qed.

Section Refined.
Variable m : nat.
Implicit Type c r : seq 'rV[F]_m.+1.
Local Notation V := (rows [fieldType of F] m.+1).

Lemma missed n u v i h j y : valid n u -> valid n v -> (i <= size v - n)%N -> (n.-1 <= h < size u - n)%N -> at_list u h < at_list u h.+1 ->
  (n.-1 <= j < size u - n)%N -> at_list u j < at_list u j.+1 -> (piece_of K n u v n i).-1 = (h.+1 - n)%N ->
  (at_list u h < y <= at_list u j) || (at_list u j < y <= at_list u h) -> (count_mem y [seq at_list v l | l <- iota i n] < count_mem y u)%N ->
  exists c r, refined_program K V n u c v = Value r /\ forall J, (n.-1 <= J < size v - n)%N -> at_list v J < at_list v J.+1 -> (J.+1 - n <= i <= J.+1)%N ->
    pblossom (piece n J (at_list v)) (piece n J (at_list r)) (knots (at_list v) i n)
      <> pblossom (piece n j (at_list u)) (piece n j (at_list c)) (knots (at_list v) i n).
Proof.
move=> hu hv le_i bh up_h bj up_j e_h in_y few; have [n0 le_n _] := bounds_of hu.
pose s := [seq at_list v l | l <- iota i n]; have sz : size s = n by rewrite size_map size_iota.
have [b differ] : exists b : nat -> F, blossom (piece n h (at_list u)) (piece n h b) (knots (at_list v) i n)
    != blossom (piece n j (at_list u)) (piece n j b) (knots (at_list v) i n).
  rewrite knots_map -/s; case/orP: (in_y) => [in_y'|in_y'].
    have le_hj : (n.-1 <= h <= j)%N.
      have/andP[-> _] := bh; rewrite leqNgt; apply/negP=> lt_j; case/andP: in_y' => h_y y_j; move: (lt_le_trans h_y y_j).
      by rewrite ltNge (knots_up hu) //; move: lt_j bh; clear; lia.
    have/andP[_ lt_j] := bj; have [b [e0 ne]] := blossoms_crossed_needs_knots hu sz le_hj lt_j up_j in_y' few.
    by exists b; rewrite e0 eq_sym.
  have le_jh : (n.-1 <= j <= h)%N.
    have/andP[-> _] := bj; rewrite leqNgt; apply/negP=> lt_h; case/andP: in_y' => j_y y_h; move: (lt_le_trans j_y y_h).
    by rewrite ltNge (knots_up hu) //; move: lt_h bj; clear; lia.
  have/andP[_ lt_h] := bh; have [b [e0 ne]] := blossoms_crossed_needs_knots hu sz le_jh lt_h up_h in_y' few.
  by exists b; rewrite e0.
pose c : seq 'rV[F]_m.+1 := mkseq (fun l => const_mx (b l)) (size u - n).+1.
have [r e] : exists r, refined_program K V n u c v = Value r.
  eexists; apply/knot_listP; split=> //; apply/fitsP; split; first by rewrite size_mkseq.
  by apply/knot_listP; split.
have [_ _ rE _] := blossoms_refined e; exists c, r; split=> // J bJ up_J in_i /rowP/(_ 0); rewrite !mxE.
have sp_J : span n (piece n J (at_list v)) by apply: blossoms_carried; rewrite ?lt_eqF.
pose l := (i - (J.+1 - n))%N; have e_l : (J.+1 - n + l = i)%N by rewrite /l; move: in_i; clear; lia.
have win : knots (at_list v) i n = knots (piece n J (at_list v)) l n by apply: knots_ext => q _; rewrite /drop_ addnA e_l.
have cE k : (n.-1 <= k < size u - n)%N -> blossom (piece n k (at_list u)) (coord (piece n k (at_list c)) 0) (knots (at_list v) i n)
    = blossom (piece n k (at_list u)) (piece n k b) (knots (at_list v) i n).
  move=> bk; apply: blossom_ext => q; rewrite size_knots => le_q; rewrite /coord /drop_ nth_mkseq ?mxE //; move: bk le_q n0; clear; lia.
rewrite {1}win blossoms_knots //; last by rewrite /l; move: in_i bJ; clear; lia.
rewrite {1}/coord /drop_ e_l rE // mxE e_h => /eqP.
by rewrite -/(drop_ (h.+1 - n)) -/(drop_ (j.+1 - n)) !cE // (negPf differ).
Qed.

Lemma few_window n v J i y k : valid n v -> (n.-1 <= J < size v - n)%N -> (count_mem y v < k)%N -> (J.+1 - n <= i <= J.+1)%N ->
  (count_mem y [seq at_list v l | l <- iota i n] < k)%N.
Proof.
by move=> hv bJ few in_i; apply: leq_ltn_trans few; apply: count_window; have [_ le_v _] := bounds_of hv; move: in_i bJ le_v; clear; lia.
Qed.

(* The vertex that shows it. *)
Lemma shown n u v J l y : valid n u -> valid n v -> (n.-1 <= J < size v - n)%N -> at_list u n.-1 <= at_list v J -> (J.+1 - n <= l <= J)%N ->
  at_list u n.-1 <= at_list v l < y -> y < at_list u (size u - n) -> y <= at_list v J.+1 -> y \in u ->
  exists i h, [/\ (J.+1 - n <= i <= J.+1)%N, (n.-1 <= h < size u - n)%N, at_list u h < at_list u h.+1, (piece_of K n u v n i).-1 = (h.+1 - n)%N &
    if y <= at_list v J then at_list u h < y else y <= at_list u h].
Proof.
move=> hu hv bJ u_J in_l /andP[u_l l_y] y_L y_J yu; have [n0 le_n _] := bounds_of hu; have [_ le_v _] := bounds_of hv.
have [y_vJ|J_y] := leP y (at_list v J); last first.
  have [|l' [h [in_l' before h_l e_h]]] := @piece_ofE F n u v n J.+1 hu.
    exists J.+1; first by move: n0; clear; lia.
    by apply: le_trans u_J _; apply: (knots_up hv); move: bJ n0; clear; lia.
  have e_l : l' = J.+1.
    apply/eqP; rewrite eqn_leq; have/andP[-> _] := in_l'; rewrite andbT leqNgt; apply/negP=> lt_l.
    by have := before J.+1; rewrite leqnn lt_l => /(_ isT); rewrite ltNge (le_trans (le_trans u_l (ltW l_y))).
  have [bh _ up_h _] := h_l; exists J.+1, h; split=> //; first by rewrite leq_subr leqnn.
  by rewrite e_l in h_l; exact: knot_under h_l yu y_J y_L.
have [|l' [h [in_l' before h_l e_h]]] := @piece_ofE F n u v n (J.+1 - n) hu.
  by exists l => //; move: in_l bJ n0; clear; lia.
have [bh h_v up_h _] := h_l; exists (J.+1 - n)%N, h; split=> //; first by rewrite leqnn leq_subr.
have le_l : (l' <= l)%N.
  rewrite leqNgt; apply/negP=> lt_l; have/andP[in_1 _] := in_l; have := before l; rewrite in_1 lt_l => /(_ isT).
  by rewrite ltNge u_l.
by apply: le_lt_trans h_v (le_lt_trans _ l_y); apply: (knots_up hv); rewrite le_l; move: in_l bJ n0; clear; lia.
Qed.

(** blossoms refined_blossom_needs_knots: the condition on the knots is necessary: if the blossom of the new vertices on a piece $[v_J,v_{J+1}]$ is that of the curve's
    piece that holds $v_J$ for all curves, then each knot inside the old domain that is not behind $v_{J+1}$ and follows one of $v_{J+1-n},\dots,v_J$ in the old domain
    is a new knot, at least as often.
    Hypotheses: an ordered field; both lists of knots are accepted; $u_{n-1}\le v_J$; the piece is not empty; points of one coordinate or more. *)
Theorem blossoms_refined_blossom_needs_knots n u v J (j := interval K n u (at_list v J)) : valid n u -> valid n v -> (n.-1 <= J < size v - n)%N ->
  at_list v J < at_list v J.+1 -> at_list u n.-1 <= at_list v J ->
  (forall c r w, refined_program K V n u c v = Value r -> size w = n ->
    pblossom (piece n J (at_list v)) (piece n J (at_list r)) w = pblossom (piece n j (at_list u)) (piece n j (at_list c)) w) -> enough n u v J.
Proof.
move=> hu hv bJ up_J u_J all_same l y in_l l_y y_L y_J; rewrite leqNgt; apply/negP=> few; have few_in i := @few_window n v J i y _ hv bJ few.
have yu : y \in u by rewrite -has_pred1 has_count; apply: leq_ltn_trans few.
have h_j : lies n u (at_list v J) j by apply: lies_under.
have [bj le_j up_j _] := h_j; have [i [h [in_i bh up_h e_h place]]] := shown hu hv bJ u_J in_l l_y y_L y_J yu.
have [||c [r [e differ]]] := missed hu hv _ bh up_h bj up_j e_h (y := y) _ (few_in i in_i); first by move: in_i bJ; clear; lia.
  by move: place; case: ifP => [y_vJ ->|/negbT]; [rewrite (knot_under hu h_j) | rewrite -ltNge => J_y ->; rewrite (le_lt_trans le_j J_y) orbT].
by apply: (differ J bJ up_J in_i); apply: all_same; rewrite ?size_knots.
Qed.

(** blossoms refined_before_needs_simple: where the old domain starts inside the piece the condition on the knots is necessary as well.
    Hypotheses: an ordered field; both lists of knots are accepted; $u_{n-1}<u_n$; points of one coordinate or more. *)
Theorem blossoms_refined_before_needs_simple n u v J y : valid n u -> valid n v -> (n.-1 <= J < size v - n)%N ->
  at_list v J < at_list u n.-1 < at_list v J.+1 -> at_list u n.-1 < at_list u n ->
  (forall c r w, refined_program K V n u c v = Value r -> size w = n ->
    pblossom (piece n J (at_list v)) (piece n J (at_list r)) w = pblossom (at_list u) (at_list c) w) ->
  y \in u -> at_list u n.-1 < y < at_list u (size u - n) -> y <= at_list v J.+1 -> y = at_list v J.+1 /\ (count_mem y u <= 1)%N.
Proof.
move=> hu hv bJ /andP[J_u u_J] up_u all_same yu /andP[u_y y_L] y_J; have [n0 le_n _] := bounds_of hu.
have e_n : n.-1.+1 = n := prednK n0; have b0 : (n.-1 <= n.-1 < size u - n)%N by move: n0 le_n; clear; lia.
pose i := (J.+2 - n)%N; have in_i : (J.+1 - n <= i <= J.+1)%N by rewrite /i; move: n0; clear; lia.
have [|k [h [in_k before h_k e_h]]] := @piece_ofE F n u v n i hu; first by exists J.+1; [rewrite /i; move: bJ n0; clear; lia | exact: ltW].
have e_k : k = J.+1.
  apply/eqP; rewrite eqn_leq; have/andP[_ lt_k] := in_k; apply/andP; split; first by move: lt_k bJ n0; rewrite /i; clear; lia.
  rewrite leqNgt; apply/negP=> k_J; have [b le_h _ _] := h_k.
  have : at_list u n.-1 <= at_list u h by apply: (knots_up hu); move: b n0 le_n; clear; lia.
  rewrite leNgt (le_lt_trans le_h) // (le_lt_trans _ J_u) // (knots_up hv) //; have [_ le_v _] := bounds_of hv; move: k_J bJ le_v; clear; lia.
rewrite e_k in h_k; have [bh _ up_h _] := h_k.
have few : (count_mem y [seq at_list v l | l <- iota i n] <= (y == at_list v J.+1))%N.
  have e_i : iota i n = rcons (iota i n.-1) J.+1.
    by rewrite -cats1 -{1}e_n -[n.-1.+1]addn1 iotaD /= /i; congr (_ ++ [:: _]); move: bJ n0; clear; lia.
  rewrite e_i map_rcons -cats1 count_cat /= addn0 [at_list v J.+1 == y]eq_sym (_ : count _ _ = 0%N) //.
  apply/eqP; rewrite -leqn0 leqNgt -has_count has_map; apply/hasPn=> l; rewrite mem_iota => in_l /=.
  rewrite lt_eqF // (le_lt_trans _ (lt_trans J_u u_y)) // (knots_up hv) //; have [_ le_v _] := bounds_of hv; move: in_l bJ le_v n0; rewrite /i; clear; lia.
suff : (count_mem y u <= (y == at_list v J.+1))%N.
  case: eqP => // _; rewrite leqn0 => /eqP z; move: yu; by rewrite -has_pred1 has_count z.
rewrite leqNgt; apply/negP=> many; have := leq_ltn_trans few many => {}few.
have [|||c [r [e differ]]] := missed hu hv _ bh up_h b0 _ e_h (y := y) _ few.
- by rewrite /i; move: bJ n0; clear; lia.
- by rewrite e_n.
- by rewrite u_y (knot_under hu h_k) // orbT.
apply: (differ J bJ (lt_trans J_u u_J) in_i); rewrite (all_same _ _ _ e) ?size_knots //.
apply/rowP=> l; rewrite !mxE (@blossom_ext_knots _ _ (piece n n.-1 (at_list u))) => [|q _]; last by rewrite /drop_ e_n subnn.
by apply: blossom_ext => q _; rewrite /coord /drop_ e_n subnn.
Qed.

(** blossoms refined_curve_needs_knots: likewise if the point at $t$ of the curve over the new knots is that of the curve, for all curves and all $t$ inside the
    piece that both domains hold.
    Hypotheses: an ordered field; both lists of knots are accepted; $u_{n-1}\le v_J<u_L$; the piece is not empty; points of one coordinate or more. *)
Theorem blossoms_refined_curve_needs_knots n u v J : valid n u -> valid n v -> (n.-1 <= J < size v - n)%N -> at_list v J < at_list v J.+1 ->
  at_list u n.-1 <= at_list v J < at_list u (size u - n) ->
  (forall c r t q, refined_program K V n u c v = Value r -> at_list v J < t < at_list v J.+1 ->
    mapping_value_program K V n u c t = Value q -> mapping_value_program K V n v r t = Value q) -> enough n u v J.
Proof.
move=> hu hv bJ up_J /andP[u_J J_L] all_same l y in_l l_y y_L y_J; rewrite leqNgt; apply/negP=> few; have few_in i := @few_window n v J i y _ hv bJ few.
have [n0 le_n _] := bounds_of hu; have [_ le_v _] := bounds_of hv.
have yu : y \in u by rewrite -has_pred1 has_count; apply: leq_ltn_trans few.
have [i [h [in_i bh up_h e_h place]]] := shown hu hv bJ u_J in_l l_y y_L y_J yu.
have [j [[bj up_j] [x [z [lt_xz [j_x x_j] [J_x x_J]]]] place_j]] : exists j, [/\ (n.-1 <= j < size u - n)%N /\ at_list u j < at_list u j.+1,
    exists x z, [/\ x < z, at_list u j <= x /\ z <= at_list u j.+1 & at_list v J <= x /\ z <= at_list v J.+1] &
    if y <= at_list v J then y <= at_list u j else at_list u j < y].
  have [y_vJ|J_y] := leP y (at_list v J); last first.
    pose p := index y u; have lt_p : (p < size u)%N by rewrite index_mem.
    have e_p : at_list u p = y by rewrite nth_index.
    have n_p : (n.-1 < p)%N.
      rewrite ltnNge; apply/negP=> le_p; case/andP: l_y => u_l l_y; move: (le_lt_trans u_l l_y); rewrite -e_p ltNge (knots_up hu) // le_p.
      by move: n0 le_n; clear; lia.
    have p_L : (p < size u - n)%N.
      by rewrite ltnNge; apply/negP=> le_p; move: y_L; rewrite -e_p ltNge (knots_up hu) // le_p.
    have e_p1 : p.-1.+1 = p by apply: ltn_predK n_p.
    have up_p : at_list u p.-1 < at_list u p.
      rewrite lt_neqAle (knots_up hu) ?andbT; last by rewrite lt_p leq_pred.
      by have := before_find 0 (_ : (p.-1 < p)%N); rewrite e_p => /(_ _)/negbT; apply; rewrite e_p1.
    exists p.-1; rewrite e_p1; split; first by split=> //; move: n_p p_L n0; clear; lia.
      exists (Num.max (at_list u p.-1) (at_list v J)), y; rewrite lt_maxl -e_p up_p e_p J_y !le_maxr !lexx ?orbT; split=> //.
    by rewrite -e_p.
  have h_j := lies_under hu u_J; have [b le_j up_j in_j] := h_j; have J_j : at_list v J < at_list u (interval K n u (at_list v J)).+1.
    by case: in_j => // -[_]; rewrite leNgt J_L.
  exists (interval K n u (at_list v J)); split=> //; last exact: knot_under h_j yu y_vJ y_L.
  exists (at_list v J), (Num.min (at_list u (interval K n u (at_list v J)).+1) (at_list v J.+1)).
  by rewrite lt_minr J_j up_J !le_minl !lexx ?orbT.
have [||c [r [e differ]]] := missed hu hv _ bh up_h bj up_j e_h (y := y) _ (few_in i in_i); first by move: in_i bJ; clear; lia.
  by move: place place_j; case: ifP => _ -> ->; rewrite ?orbT.
apply: (differ J bJ up_J in_i); apply/rowP=> k; rewrite !mxE.
have sp_J : span n (piece n J (at_list v)) by apply: blossoms_carried; rewrite ?lt_eqF.
have sp_j : span n (piece n j (at_list u)) by apply: blossoms_carried; rewrite ?lt_eqF.
apply: (same_blossoms sp_J sp_j lt_xz) => [t /andP[x_t t_z]|]; last exact: size_knots.
have at_piece w (b : seq 'rV[F]_m.+1) q h' t' : valid n w -> (n.-1 <= h' < size w - n)%N -> at_list w h' <= t' < at_list w h'.+1 ->
    mapping_value_program K V n w b t' = Value q -> q = ev (pcurve n (piece n h' (at_list w)) (piece n h' (at_list b))) t'.
  move=> hw bh' /andP[le_t lt_t] /BZZ19_3_value[_ _ in_t ->]; have h_t := lies_in hw in_t.
  have h_t' : lies n w t' h' by split=> //; [exact: le_lt_trans le_t lt_t | left].
  by rewrite (_ : interval _ _ _ _ = h') //; apply/eqP; rewrite eqn_leq (lies_up hw h_t h_t') // (lies_up hw h_t' h_t).
have t_u : at_list u j <= t < at_list u j.+1 by rewrite (le_trans j_x (ltW x_t)) (lt_le_trans t_z).
have t_v : at_list v J <= t < at_list v J.+1 by rewrite (le_trans J_x (ltW x_t)) (lt_le_trans t_z).
have sc : size c = (size u - n).+1 by case/knot_listP: e => _ /fitsP[].
have in_u : at_list u n.-1 <= t <= at_list u (size u - n).
  case/andP: t_u => u_t t_u; rewrite (le_trans _ u_t) ?(le_trans (ltW t_u)) // (knots_up hu) //; move: bj n0 le_n; clear; lia.
have in_J : at_list v J < t < at_list v J.+1 by rewrite (le_lt_trans J_x x_t) (lt_le_trans t_z).
have val_u := (BZZ19_3_value n u c t _).2 (And4 hu sc in_u erefl); have val_v := all_same _ _ _ _ e in_J val_u.
rewrite -!horner_curve //; have := etrans (esym (at_piece _ _ _ _ _ hv bJ t_v val_v)) (at_piece _ _ _ _ _ hu bj t_u val_u).
by move/rowP/(_ k); rewrite !mxE.
Qed.
End Refined.
End Needs.
