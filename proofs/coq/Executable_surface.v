(* Programs: the same curve over more knots and in a higher degree, and the surface of BZZ19.16 as a whole.
   Definitions (n, p, d degrees, u, v, w knots, c, e points, b coefficients of the mapping, pieces k = 1, 2, ...):
     window w n i               the arguments w_i, ..., w_{i+n-1}
     over_piece u c k a         the blossom at the arguments a on piece k
     piece_under n u t          the piece of u that holds t or starts there, the last one behind the domain, 0 before it
     piece_of n u v m i         the first of the pieces under v_i, ..., v_{i+m-1}
     refined_program n u c v    the points over the knots v
     doubled u, elevated_knots n u   each group of equal knots once more; cut to n + 1 knots up to the start and from the end of the domain
     mean_of u c n k a          the mean of the n + 1 blossoms that leave one argument out
     raised_program n u c       the knots and the points in degree n + 1
     sorted_into t x, breaks n u v   t into a sorted list; the ends of u's domain, and the knots of u and v inside, each once
     piece_of_values p v s t    the piece of v between s and t
     first_net, second_net      the points of C_1 and of C_2 o sigma between two breakpoints, of degree D
     glued nets                 the nets one after the other, each without its first point but the first
     surface_program            the knots and the two rows *)
From Torse Require Import Prelude Blossom Curves Points Bernstein Bezier Segments Insertion BZZ19_3 BZZ19_4 BZZ19_4_pieces BZZ19_4_written FJ21_4 Executable Executable_knots
  Executable_splines Executable_composition Executable_mappings Executable_joints Executable_elimination.
From mathcomp Require Import order ssrnum.
Import Order.TTheory Num.Theory.

Section Programs.
Variables (T Q : Type) (K : scalars T) (V : points T Q).
Implicit Types (u v w b x : seq T) (c e : seq Q) (n p d m k i j : nat) (s t : T).
Local Notation "u $ i" := (nth (zero K) u i) (at level 8, i at level 8, format "u $ i").
Local Notation "x + y" := (sadd K x y).
Local Notation "x - y" := (ssub K x y).
Local Notation "x * y" := (smul K x y).
Local Notation "x / y" := (smul K x (sinv K y)).

Definition window w m i := [seq parameter K w$j | j <- iota i m].
Definition over_piece u c k a := deboor K V (drop k.-1 u) (drop k.-1 c) a.
Definition piece_under n u t := if less K t u$(n.-1) then 0%N else piece_at K n u t.
Definition piece_of n u v m i := head 0%N (filter (Nat.ltb 0) [seq piece_under n u v$j | j <- iota i m]).
Definition refined_program n u c v := knot_list K n u (fits n u c (knot_list K n v
  (Value (mkseq (fun i => over_piece u c (piece_of n u v n i) (window v n i)) (last_ n v).+1)))).

Definition closes u i := Nat.eqb i.+1 (size u) || ~~ same K u$i u$(i.+1).
Definition doubled u := flatten (mkseq (fun i => if closes u i then [:: u$i; u$i] else [:: u$i]) (size u)).
Definition elevated_knots n u := let r := doubled u in
  let first := count (fun t => ~~ less K u$(n.-1) t) r in let last := count (fun t => less K t u$(last_ n u)) r in
  drop (first - n.+1) (take (last + n.+1)%nat r).
Definition mean_of u c n k a := pscale V (sinv K (of_nat K n.+1))
  (total_of V (fun i => over_piece u c k (take i a ++ drop i.+1 a)) 0 n.+1).
Definition raised_program n u c := knot_list K n u (fits n u c (let v := elevated_knots n u in knot_list K n.+1 v
  (Value (v, mkseq (fun i => mean_of u c n (piece_of n u v n.+1 i) (window v n.+1 i)) (last_ n.+1 v).+1)))).

Fixpoint sorted_into t x := if x is s :: x' then if less K t s then t :: x else if less K s t then s :: sorted_into t x' else x else [:: t].
Definition breaks n u v := let s := u$(n.-1) in let t := u$(last_ n u) in
  s :: rcons (foldr sorted_into [::] (filter (fun y => less K s y && less K y t) (u ++ v))) t.
Definition piece_of_values p v s t : answer nat := let k := piece_at K p v ((s + t) / of_nat K 2) in
  given (~~ less K t s && ~~ less K s v$(p.-1) && ~~ less K v$(last_ p v) t) Sigma
  (given (~~ less K s v$(p + k - 2)%nat && ~~ less K v$(p + k - 1)%nat t) Sigma (Value k)).
Definition value_of d w b s t := deboor K (itself K) (drop (piece_at K d w s).-1 w) (drop (piece_at K d w s).-1 b) (nseq d (parameter K t)).
Definition first_net D n u c s t := elevation_program K V (restricted_points K V n u c (piece_at K n u s) s t) (D - n).
Definition second_net D p v e d w b s t := match piece_of_values p v (value_of d w b s s) (value_of d w b s t) with
  | Value k => let lo := v$(p + k - 2)%nat in let hi := v$(p + k - 1)%nat in
    let f := [seq (y - lo) / (hi - lo) | y <- restricted_points K (itself K) d w b (piece_at K d w s) s t] in
    match composed_program K V (restricted_points K V p v e k lo hi) f with Value r => Value (elevation_program K V r (D - p * d)) | Fails r => Fails _ r end
  | Fails r => Fails _ r end.
Definition glued (nets : seq (seq Q)) := if nets is r :: nets' then r ++ flatten (map behead nets') else [::].
Fixpoint collect A (list : seq (answer A)) : answer (seq A) := if list is y :: rest then
  match y with Value z => match collect rest with Value l => Value (z :: l) | Fails r => Fails _ r end | Fails r => Fails _ r end else Value [::].
Definition surface_program n u c p v e d w b even := knot_list K n u (fits n u c (knot_list K p v (fits p v e (knot_list K d w (fits d w b
  (given (~~ less K w$(d.-1) u$(n.-1) && ~~ less K u$(last_ n u) w$(last_ d w)) Sigma (
   let D := if Nat.leb n (p * d) then (p * d)%nat else n in let x := breaks d w u in let N := (size x).-1 in
   match collect (mkseq (fun j => second_net D p v e d w b x$j x$(j.+1)) N) with
   | Value nets => let knot j := if even then x$0 + of_nat K j * (x$N - x$0) / of_nat K N else x$j in
     Value (flatten (mkseq (fun j => nseq D (knot j)) N.+1), glued (mkseq (fun j => first_net D n u c x$j x$(j.+1)) N), glued nets)
   | Fails r => Fails _ r end))))))).
End Programs.

Section Lists.
Variables (F : fieldType) (m : nat).
Implicit Types (x : nat -> F) (nets : seq (seq 'rV[F]_m)) (D N i j : nat).
Local Notation at_list := (nth 0).
Local Notation net nets j := (nth [::] nets j).

Lemma nth_copies D N x i : (i < N * D)%N -> at_list (flatten (mkseq (fun j => nseq D (x j)) N)) i = joined D x i.
Proof.
case: D => [|D]; first by rewrite muln0.
elim: N x i => // N ih x i lt_i; have -> : mkseq (fun j => nseq D.+1 (x j)) N.+1 = nseq D.+1 (x 0%N) :: mkseq (fun j => nseq D.+1 (x j.+1)) N.
  by rewrite /mkseq -[N.+1]add1n iotaD map_cat (iotaDl 1 0) -map_comp.
rewrite -[flatten (_ :: _)]/(nseq D.+1 (x 0%N) ++ flatten (mkseq (fun j => nseq D.+1 (x j.+1)) N)) nth_cat size_nseq /joined.
have [lt_D|le_D] := ltnP i D.+1; first by rewrite nth_nseq lt_D divn_small.
rewrite (ih (fun j => x j.+1)); last by move: lt_i; rewrite mulSn; move: (N * D.+1)%N => M; lia.
by rewrite /joined -{2}(subnKC le_D) divnDl ?dvdnn // divnn.
Qed.

Lemma nth_beheads D nets i j : (j < size nets)%N -> (i < D)%N -> all (fun r => size r == D.+1) nets ->
  at_list (flatten (map behead nets)) (j * D + i) = at_list (net nets j) i.+1.
Proof.
move=> lt_j lt_i; elim: nets j lt_j => //= r nets ih j lt_j /andP[/eqP sr /ih{}ih]; rewrite nth_cat size_behead sr /=.
case: j lt_j => [|j] lt_j; first by rewrite mul0n lt_i nth_behead.
by rewrite mulSn -addnA ltnNge leq_addr /= addKn ih.
Qed.

Lemma glued_holds D nets : all (fun r => size r == D.+2) nets ->
  (forall j, (j.+1 < size nets)%N -> at_list (net nets j) D.+1 = at_list (net nets j.+1) 0) ->
  holds D.+1 (size nets) (at_list (glued nets)) (fun j => at_list (net nets j)).
Proof.
move=> sz meet; suff pos j i : (j < size nets)%N -> (0 < i <= D.+1)%N || (j == 0)%N && (i <= D.+1)%N -> at_list (glued nets) (j * D.+1 + i) = at_list (net nets j) i.
  move=> j [|i] lt_j le_i; last by apply: pos; rewrite // le_i.
  case: j lt_j => [|j] lt_j; first exact: pos.
  by rewrite -meet // addn0 mulSn addnC; apply: pos; rewrite ?leqnn // ltnW.
case: nets sz {meet} => // r nets /= /andP[/eqP sr sz] lt_j pos; rewrite nth_cat sr.
case: j lt_j pos => [|j] lt_j /=; first by rewrite mul0n add0n orbC => h; rewrite ifT //; lia.
rewrite orbF; case: i => // i le_i; rewrite mulSn ifF; last by move: (j * D.+1)%N => M; lia.
rewrite -(nth_beheads lt_j le_i sz); congr nth; move: (j * D.+1)%N => M; lia.
Qed.
End Lists.

Section Surface.
Variable F : realFieldType.
Implicit Types (u v w b x : seq F) (c e : seq 'rV[F]_3) (n p d D k i j : nat) (s t y : F).
Local Notation K := (ordered F).
Local Notation V := (rows [fieldType of F] 3).
Local Notation at_list := (nth 0).
Local Notation valid := (valid (fun x y : F => x < y)).

Lemma insert_path (lo hi : F) t x : path <%R lo (rcons x hi) -> lo < t < hi -> path <%R lo (rcons (sorted_into K t x) hi).
Proof.
elim: x lo => [|y x ih] lo /=; first by move=> _ /andP[-> ->].
case/andP=> lo_y py /andP[lo_t t_hi]; case: ltP => [t_y|y_t] /=; first by rewrite lo_t t_y.
case: ltP => [y_lt|_] /=; last by rewrite lo_y.
by rewrite lo_y ih // y_lt.
Qed.

(** BZZ19.16 breaks: the program gives the breakpoints: a list that increases strictly from the begin to the end of the mapping's domain.
    Hypotheses: an ordered field; the list of the mapping's knots is accepted. *)
Theorem BZZ19_16_breaks d w u (x := breaks K d w u) : valid d w ->
  [/\ sorted <%R x, at_list x 0 = at_list w d.-1, at_list x (size x).-1 = at_list w (size w - d) & (1 < size x)%N].
Proof.
move=> hv; have [d0 le_d dom] := bounds_of hv; rewrite /x /breaks; set lo := at_list w d.-1; set hi := at_list w _; set y := foldr _ _ _.
have lt_dom : lo < hi by rewrite lt_neqAle dom (knots_up hv) //; move: d0 le_d; clear; lia.
split=> //; last by rewrite /= size_rcons.
- rewrite /y /=; elim: (w ++ u) => [|t s ih] /=; first by rewrite lt_dom.
  by case: ifP => //= in_t; apply: insert_path.
by rewrite /= size_rcons /= nth_rcons ltnn eqxx.
Qed.

Lemma restrictedE n u c k s t : (0 < k)%N -> span n (drop_ k.-1 (at_list u)) ->
  pbez n (at_list (restricted_points K V n u c k s t)) = map_mx (fun f => f \Po line s t) (pcurve n (drop_ k.-1 (at_list u)) (drop_ k.-1 (at_list c))).
Proof.
move=> k0 sp; apply/rowP=> i; rewrite !mxE BZZ19_11_piece //; apply: bez_ext => j le_j.
by rewrite /coord nth_mkseq // deboor_drop mxE.
Qed.

Lemma deboor_scalar w b (a : seq (F * F)) : deboor K (itself K) w b a = blossom (at_list w) (at_list b) a.
Proof.
elim: a w b => [|x a ih] w b //=; rewrite ih (@blossom_ext_knots _ _ (shift (at_list w))) => [|i _]; last by rewrite nth_behead.
by apply: blossom_ext => i le_i; rewrite nth_mkseq // /step /= mulrC.
Qed.

Lemma drop_scalar w b k (a : seq (F * F)) : deboor K (itself K) (drop k w) (drop k b) a = blossom (drop_ k (at_list w)) (drop_ k (at_list b)) a.
Proof.
rewrite deboor_scalar (@blossom_ext_knots _ _ (drop_ k (at_list w))) => [|i _]; last by rewrite nth_drop.
by apply: blossom_ext => i _; rewrite nth_drop.
Qed.

Lemma restricted_scalar d w b k s t i : (i <= d)%N ->
  at_list (restricted_points K (itself K) d w b k s t) i = segment s t d (drop_ k.-1 (at_list w)) (drop_ k.-1 (at_list b)) i.
Proof. by move=> le_i; rewrite nth_mkseq // drop_scalar. Qed.

Lemma elevationE c k D : good [fieldType of F] D.+1 -> (0 < size c)%N -> (size c + k)%N = D.+1 ->
  pbez D (at_list (elevation_program K V c k)) = pbez (size c).-1 (at_list c).
Proof.
move=> g c0 sz; have := @BZZ19_15_program [fieldType of F] 3 (fun x y : F => x < y) c k; rewrite sz; apply=> i /andP[le_i lt_i].
by apply: (good_nat g); rewrite (leq_trans c0 le_i) ltnW.
Qed.

Lemma in_left y w u : y \in w -> y \in w ++ u.
Proof. by move=> yw; rewrite mem_cat yw. Qed.

(* The piece that the program finds for a parameter. *)
Lemma piece_found n u t (k := (piece_at K n u t).-1) : valid n u -> at_list u n.-1 <= t <= at_list u (size u - n) ->
  [/\ (0 < piece_at K n u t)%N, span n (drop_ k (at_list u)), at_list u (n + k - 1) < at_list u (n + k) & (n + k - 1 < size u - n)%N].
Proof.
move=> hv in_t; have [e sp] := piece_atE hv in_t; have [b _ lt_j _] := blossoms_interval hv in_t; have [n0 le_n _] := bounds_of hv.
rewrite /k e; move: b lt_j sp; set j := interval _ _ _ _ => b lt_j sp.
have [-> ->] : (n + (j.+1 - n).+1.-1 - 1 = j)%N /\ (n + (j.+1 - n).+1.-1 = j.+1)%N by move: b n0; clear; lia.
by split=> //; case/andP: b.
Qed.

Lemma second_netE D p v e d w b s t r (k := (piece_at K d w s).-1) (sigma := curve d (drop_ k (at_list w)) (drop_ k (at_list b))) :
  good [fieldType of F] D.+1 -> (p * d <= D)%N -> valid p v -> valid d w -> at_list w d.-1 <= s <= at_list w (size w - d) ->
  second_net K V D p v e d w b s t = Value r ->
  exists2 k2, [/\ span p (drop_ k2 (at_list v)), (p + k2 - 1 < size v - p)%N, at_list v (p + k2 - 1) <= sigma.[s], sigma.[s] <= sigma.[t] & sigma.[t] <= at_list v (p + k2)] &
    size r = D.+1 /\ pbez D (at_list r) = map_mx (fun f => f \Po line s t) (after (pcurve p (drop_ k2 (at_list v)) (drop_ k2 (at_list e))) sigma).
Proof.
move=> g le_D hv hw in_s; have [k0 spw ltw _] := piece_found hw in_s; rewrite /second_net.
have val y : value_of K d w b s y = sigma.[y] by rewrite /value_of drop_scalar /sigma horner_curve.
case Ep : (piece_of_values K p v (value_of K d w b s s) (value_of K d w b s t)) => [k2|] //; move: Ep; rewrite /piece_of_values !val.
move=> Ep; have [/andP[/andP[st lo] hi] Ep2] := given_Value Ep; have [/andP[lo2 hi2] Ep3] := given_Value Ep2; have ek := Value_inj Ep3.
rewrite /= -leNgt in st; rewrite /= -leNgt in lo; rewrite /= -leNgt /last_ in hi; rewrite ek /= -leNgt in lo2; rewrite ek /= -leNgt in hi2.
have mid : at_list v p.-1 <= (sigma.[s] + sigma.[t]) / of_nat K 2 <= at_list v (size v - p).
  rewrite of_natE ler_pdivl_mulr ?ltr0n // ler_pdivr_mulr ?ltr0n // !mulr_natr !mulr2n.
  by rewrite !ler_add // ?(le_trans st) // (le_trans lo).
have := piece_found hv mid; rewrite [piece_at _ _ _ _]ek => -[k20 spv ltv last_v].
have [elo ehi] : (p + k2 - 2 = p + k2.-1 - 1)%N /\ (p + k2 - 1 = p + k2.-1)%N by move: k20; clear; lia.
pose A := at_list v (p + k2 - 2); pose B := at_list v (p + k2 - 1); pose pts := restricted_points K V p v e k2 A B.
pose f := [seq (y - A) / (B - A) | y <- restricted_points K (itself K) d w b (piece_at K d w s) s t].
rewrite -[X in X = Value r]/(match composed_program K V pts f with Value r => Value (elevation_program K V r (D - p * d)) | Fails r => Fails _ r end).
case E : (composed_program K V pts f) => [q|] // e_r; rewrite -(Value_inj e_r).
have nz : B - A != 0 by rewrite /A /B elo ehi subr_eq0 gt_eqF.
have [sp_ sf] : size pts = p.+1 /\ size f = d.+1 by rewrite /f size_map /pts /restricted_points !size_mkseq.
have ind : independent [fieldType of F] (p * d) by apply: good_independent; apply: good_le g; exact: leqW.
have ind2 : independent [fieldType of F] ((size pts).-1 * (size f).-1) by rewrite sp_ sf.
have [/(_ _ ind2) h _] := @BZZ19_13_program [fieldType of F] 3 (fun x y : F => x < y) pts f.
have [sq eq] := h q E; rewrite sp_ sf /= in sq eq.
rewrite -elo in last_v; exists k2.-1; first by rewrite -elo -ehi; split.
rewrite size_elevation sq addSn subnKC //; split=> //; rewrite elevationE ?sq // ?addSn ?subnKC //.
rewrite -[RHS](_ : map_mx (fun h => (h \Po sigma) \Po line s t) (pcurve p (drop_ k2.-1 (at_list v)) (drop_ k2.-1 (at_list e))) = _); last first.
  by apply/rowP=> i; rewrite !mxE.
rewrite -(BZZ19_13_net (drop_ k2.-1 (at_list e)) (drop_ k (at_list b)) s t ind nz spv spw).
apply/rowP=> i; rewrite !mxE eq.
transitivity (bez p (coord (psegment A B p (drop_ k2.-1 (at_list v)) (drop_ k2.-1 (at_list e))) i)
    \Po bez d (scaled A B (segment s t d (drop_ k (at_list w)) (drop_ k (at_list b))))); last first.
  by rewrite [LHS]BZZ19_13_composition //; apply: bez_ext => j _; rewrite /coord mxE.
congr (_ \Po _); apply: bez_ext => j le_j; last by rewrite /coord /pts /restricted_points nth_mkseq // deboor_drop.
by rewrite /f (nth_map 0); [rewrite restricted_scalar | rewrite size_mkseq].
Qed.

Lemma collectP A (y0 : A) (f : nat -> answer A) N l : collect (mkseq f N) = Value l -> size l = N /\ forall j, (j < N)%N -> f j = Value (nth y0 l j).
Proof.
elim: N f l => [|N ih] f l; first by move=> el; rewrite -(Value_inj el).
have -> : mkseq f N.+1 = f 0%N :: mkseq (fun j => f j.+1) N by rewrite /mkseq -[N.+1]add1n iotaD map_cat (iotaDl 1 0) -map_comp.
rewrite [collect _]/=; case E : (f 0%N) => [y|] //; case E' : (collect _) => [r|] // el; rewrite -(Value_inj el) /=.
by have [-> h] := ih _ _ E'; split=> // -[|j] //; exact: h.
Qed.

Lemma pcurve_knots n (u u' : nat -> F) (c : nat -> 'rV[F]_3) : (forall i, (i < n.*2)%N -> u i = u' i) -> pcurve n u c = pcurve n u' c.
Proof.
move=> eq_u; apply/rowP=> i; rewrite !mxE /curve; apply: blossom_ext_knots => j; rewrite size_nseq => lt_j.
by rewrite /polys eq_u.
Qed.

Lemma mem_sorted t x : sorted_into K t x =i t :: x.
Proof.
elim: x => // s x ih y /=; case: ifP => // lt_s; case: ifP => [_|gt_s]; first by rewrite !inE ih inE orbCA.
have -> : t = s by apply/eqP; rewrite eq_le !leNgt lt_s gt_s.
by rewrite !inE orbA orbb.
Qed.

Lemma none_between d w u (x := breaks K d w u) j y : valid d w -> (j.+1 < size x)%N -> y \in w ++ u -> ~~ (at_list x j < y < at_list x j.+1).
Proof.
move=> hw lt_j y_wu; have [up x0 xN x1] := BZZ19_16_breaks u hw; rewrite -/x in up x0 xN x1; apply/negP=> /andP[j_y y_j].
have le_x i l : (i <= l)%N -> (l < size x)%N -> at_list x i <= at_list x l.
  by move=> le_i lt_l; apply: sorted_leq_nth; rewrite ?inE //; [exact: le_trans | by apply: sub_sorted up => a b'; exact: ltW | exact: leq_ltn_trans lt_l].
have in_y : at_list w d.-1 < y < at_list w (size w - d).
  by rewrite -x0 -xN (le_lt_trans _ j_y) ?(lt_le_trans y_j) // le_x // ?prednK //; move: lt_j; clear; lia.
have y_x : y \in x.
  rewrite /x /breaks inE mem_rcons inE; apply/orP; right; apply/orP; right.
  elim: (w ++ u) y_wu => // z r ih; rewrite inE => /orP[/eqP <-|/ih y_r] /=; first by rewrite in_y /= mem_sorted mem_head.
  by case: ifP => // _; rewrite /= mem_sorted inE y_r orbT.
have [l lt_l e_l] := nthP 0 y_x; have [le_l|gt_l] := leqP l j.
  by move: j_y; rewrite -e_l ltNge le_x // ltnW.
by move: y_j; rewrite -e_l ltNge le_x.
Qed.

(** BZZ19.16 program: the program gives knots and two rows whose B-spline surface is (10), $(1-s)C_1(t)+sC_2(\sigma(t))$, on every piece between two breakpoints
    $x_j<x_{j+1}$: with the pieces of $C_1$ and $\sigma$ that hold $x_j$ and a piece $[v_-,v_+]$ of $C_2$ with $v_-\le\sigma(x_j)\le\sigma(x_{j+1})\le v_+$, wherever it gives
    a value.
    Hypotheses: an ordered field. *)
Theorem BZZ19_16_program n u c p v e d w b z (R S : seq 'rV[F]_3) (D := if Nat.leb n (p * d) then (p * d)%N else n) (x := breaks K d w u) (N := (size x).-1) j
    (k1 := (piece_at K n u (at_list x j)).-1) (k := (piece_at K d w (at_list x j)).-1) (sigma := curve d (drop_ k (at_list w)) (drop_ k (at_list b))) :
  surface_program K V n u c p v e d w b false = Value (z, R, S) -> (j < N)%N -> at_list x j < at_list x j.+1 /\ exists2 k2,
    [/\ span p (drop_ k2 (at_list v)), (p + k2 - 1 < size v - p)%N, at_list v (p + k2 - 1) <= sigma.[at_list x j],
      sigma.[at_list x j] <= sigma.[at_list x j.+1] & sigma.[at_list x j.+1] <= at_list v (p + k2)] &
    forall s t, ruled_surface (pcurve D (drop_ (j * D) (at_list z)) (drop_ (j * D) (at_list R)))
        (pcurve D (drop_ (j * D) (at_list z)) (drop_ (j * D) (at_list S))) 'X s t
      = ruled_surface (pcurve n (drop_ k1 (at_list u)) (drop_ k1 (at_list c))) (pcurve p (drop_ k2 (at_list v)) (drop_ k2 (at_list e))) sigma s t.
Proof.
case/knot_listP=> hu /fitsP[sc] /knot_listP[hv] /fitsP[se] /knot_listP[hw] /fitsP[sb] E lt_j.
have [/andP[lo hi] {}E] := given_Value E; rewrite /= -leNgt in lo; rewrite /= -leNgt in hi; cbv zeta in E; rewrite -/D -/x -/N in E.
move: E; case Ec : (collect (mkseq (fun j => second_net K V D p v e d w b (at_list x j) (at_list x j.+1)) N)) => [nets|] // E.
have [<- <- <-] := Value_inj E.
have [up x0 xN x1] := BZZ19_16_breaks u hw; rewrite -/x -/N in up x0 xN x1.
have le_x i l : (i <= l)%N -> (l <= N)%N -> at_list x i <= at_list x l.
  rewrite leq_eqVlt => /orP[/eqP -> //|lt_i] le_l; apply: ltW; have sx : size x = N.+1 by rewrite /N prednK // ltnW.
  by apply: (sorted_ltn_nth lt_trans 0 up) => //; rewrite inE sx ltnS // ltnW // (leq_trans lt_i).
have lt_x i : (i < N)%N -> at_list x i < at_list x i.+1.
  move=> lt_i; have sx : size x = N.+1 by rewrite /N prednK // ltnW.
  by apply: (sorted_ltn_nth lt_trans 0 up) => //; rewrite inE sx ltnS // ltnW.
split; first exact: lt_x.
have [D0 le_n le_pd] : [/\ (0 < D)%N, (n <= D)%N & (p * d <= D)%N].
  by have [n0 _ _] := bounds_of hu; move: n0; rewrite /D nat_lebE; move: (p * d)%N => q; clear; case: ifP => h n0; split; lia.
have g h : good [fieldType of F] h by rewrite /good pnatr_eq0 -lt0n fact_gt0.
have in_w i : (i < N)%N -> at_list w d.-1 <= at_list x i <= at_list w (size w - d).
  by move=> lt_i; rewrite -x0 -xN !le_x // ltnW.
have in_u i : (i < N)%N -> at_list u n.-1 <= at_list x i <= at_list u (size u - n).
  by move=> /in_w/andP[h1 h2]; rewrite (le_trans lo) // (le_trans h2).
have [sn netE] := collectP [::] Ec.
have second i (lt_i : (i < N)%N) := second_netE (g D.+1) le_pd hv hw (in_w i lt_i) (netE i lt_i).
have [k2 [spv bv l1 l2 l3] [_ eS]] := second j lt_j; exists k2 => // s t.
set firsts := mkseq _ N; have sfirst : size firsts = N by rewrite size_mkseq.
have eP i : (i < N)%N -> size (nth [::] firsts i) = D.+1 /\ pbez D (at_list (nth [::] firsts i))
    = map_mx (fun f => f \Po line (at_list x i) (at_list x i.+1)) (pcurve n (drop_ (piece_at K n u (at_list x i)).-1 (at_list u))
        (drop_ (piece_at K n u (at_list x i)).-1 (at_list c))).
  move=> lt_i; have [p0 sp _ _] := piece_found hu (in_u i lt_i); rewrite nth_mkseq // /first_net size_elevation size_mkseq addSn subnKC //; split=> //.
  by rewrite elevationE ?size_mkseq ?addSn ?subnKC //; exact: restrictedE.
have eQ i : (i < N)%N -> size (nth [::] nets i) = D.+1 by move=> lt_i; have [h _ []] := second i lt_i.
have size_D (r : seq (seq 'rV[F]_3)) : size r = N -> (forall i, (i < N)%N -> size (nth [::] r i) = D.+1) -> all (fun q => size q == D.+1) r.
  by move=> sr h; apply/(all_nthP [::]) => i; rewrite sr => /h ->.
have [D' eD] : exists D', D = D'.+1 by exists D.-1; rewrite prednK.
have hR := @glued_holds [fieldType of F] 3 D' firsts; have hS := @glued_holds [fieldType of F] 3 D' nets; rewrite -eD sfirst in hR; rewrite -eD sn in hS.
have none i y : (i.+1 < N)%N -> y \in w ++ u -> ~~ (at_list x i < y < at_list x i.+1).
  by move=> lt_i; apply: none_between => //; rewrite -/x; move: lt_i; rewrite /N; clear; lia.
have m1 i : (i.+1 < N)%N -> at_list (nth [::] firsts i) D = at_list (nth [::] firsts i.+1) 0.
  move=> lt_i; have [_ /BZZ19_16_ends[_ ->]] := eP i (ltnW lt_i); have [_ /BZZ19_16_ends[-> _]] := eP i.+1 lt_i.
  apply/rowP=> l; rewrite !mxE; have/andP[h1 _] := in_u i (ltnW lt_i); have/andP[_ h2] := in_u i.+1 lt_i.
  by apply: (next_value (coord (at_list c) l)) => //; [exact: lt_x (ltnW lt_i) | move=> y yu; apply: none; rewrite // mem_cat yu orbT].
have m2 i : (i.+1 < N)%N -> at_list (nth [::] nets i) D = at_list (nth [::] nets i.+1) 0.
  move=> lt_i; have [i1 [sp1 b1 lo1 up1 hi1] [_ /BZZ19_16_ends[_ ->]]] := second i (ltnW lt_i).
  have [i2 [sp2 b2 lo2 up2 hi2] [_ /BZZ19_16_ends[-> _]]] := second i.+1 lt_i.
  apply/rowP=> l; rewrite !mxE !horner_comp; have/andP[h1 _] := in_w i (ltnW lt_i); have/andP[_ h2] := in_w i.+1 lt_i.
  have eq_s := next_value (at_list b) hw h1 (lt_x i (ltnW lt_i)) h2.
  have {}eq_s := eq_s (fun y yw => none i y lt_i (in_left u yw)).
  have := le_trans lo1 up1; rewrite eq_s in hi1 * => lo1'.
  by apply: (same_piece (coord (at_list e) l) hv b1 b2 sp1 sp2); [rewrite lo1' hi1 | rewrite lo2 (le_trans up2)].
have {}hR := hR (size_D _ sfirst (fun i lt_i => (eP i lt_i).1)) m1; have {}hS := hS (size_D _ sn eQ) m2.
have zE (r : seq 'rV[F]_3) : pcurve D (drop_ (j * D) (at_list (flatten (mkseq (fun j => nseq D (at_list x j)) N.+1)))) (drop_ (j * D) (at_list r))
    = pcurve D (drop_ (j * D) (joined D (at_list x))) (drop_ (j * D) (at_list r)).
  apply: pcurve_knots => i lt_i; rewrite /drop_ nth_copies // mulSn; move: lt_i lt_j; rewrite -addnn => lt_i lt_j.
  apply: (@leq_trans (j * D + (D + D))); first by rewrite ltn_add2l.
  by rewrite addnCA leq_add2l -mulSnr leq_mul2r lt_j orbT.
have nz : at_list x j.+1 - at_list x j != 0 by rewrite subr_eq0 gt_eqF ?lt_x.
rewrite !zE /ruled_surface (_ : after _ 'X = pcurve D (drop_ (j * D) (joined D (at_list x))) (drop_ (j * D) (at_list (glued nets)))); last first.
  by apply/rowP=> i; rewrite mxE comp_polyXr.
move: hR hS eS (eP j lt_j).2; rewrite eD => hR hS eS eP'.
by rewrite (BZZ19_16_piece t lt_j nz hR eP') (BZZ19_16_piece t lt_j nz hS eS).
Qed.
End Surface.

Section Refinement.
Variables (F : fieldType) (m : nat) (lt : F -> F -> bool).
Implicit Types (u v : seq F) (c r : seq 'rV[F]_m) (n k i j : nat) (t : F).
Local Notation K := (of_field lt).
Local Notation V := (rows F m).
Local Notation at_list := (nth 0).

(** blossoms refined: the program gives the vertices $c[v_i,\dots,v_{i+n-1}]$ over the new knots, each by the piece of the curve that the first of these knots in the
    domain belongs to; where the vertices of a new piece belong to one piece of the curve, they are the points of that piece's curve.
    Hypotheses: for the curve: the knots carry both pieces. *)
Theorem blossoms_refined n u c v r : refined_program K V n u c v = Value r ->
  [/\ valid lt n v, size r = (size v - n).+1,
    forall i (k := (piece_of K n u v n i).-1), (i <= size v - n)%N ->
      at_list r i = pblossom (drop_ k (at_list u)) (drop_ k (at_list c)) (knots (at_list v) i n) &
    forall j k t, (j + n <= size v - n)%N -> (forall i, (i <= n)%N -> (piece_of K n u v n (j + i)).-1 = k) ->
      span n (drop_ k (at_list u)) -> span n (drop_ j (at_list v)) ->
      ev (pcurve n (drop_ j (at_list v)) (drop_ j (at_list r))) t = ev (pcurve n (drop_ k (at_list u)) (drop_ k (at_list c))) t].
Proof.
case/knot_listP=> _ /fitsP[_] /knot_listP[hv e].
have val i (k := (piece_of K n u v n i).-1) : (i <= size v - n)%N -> at_list r i = pblossom (drop_ k (at_list u)) (drop_ k (at_list c)) (knots (at_list v) i n).
  by move=> le_i; rewrite -(Value_inj e) nth_mkseq // /over_piece deboor_drop.
split=> //; first by rewrite -(Value_inj e) size_mkseq.
move=> j k t le_j one spu spv; apply/rowP=> l; rewrite !mxE !horner_curve // -(blossoms_refinement _ spu spv) ?size_nseq //.
apply: blossom_ext => i; rewrite size_nseq => le_i; have le_ji : (j + i <= size v - n)%N by apply: leq_trans le_j; rewrite leq_add2l.
have := val _ le_ji; rewrite /= one // => e_i; rewrite -[LHS]/(at_list r (j + i) 0 l) e_i.
by rewrite mxE; congr blossom; apply: knots_ext => h _; rewrite /drop_ addnA.
Qed.

(** blossoms raised: the program gives knots $v$ and, as the vertex $i$, the mean of the $n+1$ blossoms of the curve at $v_i,\dots,v_{i+n}$ without one of them. *)
Theorem blossoms_raised n u c v r : raised_program K V n u c = Value (v, r) ->
  [/\ valid lt n.+1 v, size r = (size v - n.+1).+1 & forall i (k := (piece_of K n u v n.+1 i).-1), (i <= size v - n.+1)%N ->
    at_list r i = n.+1%:R^-1 *: \sum_(0 <= h < n.+1) pblossom (drop_ k (at_list u)) (drop_ k (at_list c))
      (take h (knots (at_list v) i n.+1) ++ drop h.+1 (knots (at_list v) i n.+1))].
Proof.
case/knot_listP=> _ /fitsP[_] /knot_listP[hv e]; have [ev er] := Value_inj e; rewrite {}ev in hv er; rewrite -er size_mkseq; split=> // i k le_i.
rewrite nth_mkseq // /mean_of of_natE total_ofE; congr (_ *: _); first by rewrite mulrS.
by apply: eq_bigr => h _; rewrite /over_piece deboor_drop.
Qed.
End Refinement.
