(* Programs: the linear construction of FJ07, section 3, and its closed forms.
   Definitions (n degree, u knots, c points, L and M for the paper's starred parameters, vertices count from 0):
     off_knots u M a         a, where M is none of the knots
     net_program n u c L M k dk   the row d through d_k = dk by (13), upwards and downwards
     left_side n u c L i     the left side of equation (13)
     products_program n u M a b   P(a, b) and Q(a, b)
     closed14, closed15, closed16_program n u c L M d0 i   d_i by (14), d_i - c_i by (15) and by (16) *)
From Torse Require Import Prelude Points FJ07_3_net Executable Executable_knots.

Section Programs.
Variables (T Q : Type) (K : scalars T) (V : points T Q).
Implicit Types (u : seq T) (c : seq Q) (n k i : nat) (L M : T).
Local Notation "u $ i" := (nth (zero K) u i) (at level 8, i at level 8, format "u $ i").
Local Notation vertex c i := (nth (origin V) c i).
Local Notation "x - y" := (ssub K x y).
Local Notation "x / y" := (smul K x (sinv K y)).
Local Notation "x * y" := (smul K x y).
Local Notation "p + q" := (padd V p q).
Local Notation "x *: p" := (pscale V x p).

Definition off_knots A u M (a : answer A) := given (~~ has (same K M) u) At_knot a.
Definition left_side n u c L i := (u$(i + n)%N - L) *: vertex c i + (L - u$i) *: vertex c i.+1.
Definition next_vertex n u c L M i d := sinv K (M - u$i) *: (left_side n u c L i + (M - u$(i + n)%N) *: d).
Definition previous_vertex n u c L M i d := sinv K (u$(i + n)%N - M) *: (left_side n u c L i + (u$i - M) *: d).
Definition net_row n u c L M k dk :=
  rev (behead (sequence (fun j => previous_vertex n u c L M (k - j.+1)%N) 0 dk k.+1))
  ++ sequence (next_vertex n u c L M) k dk (last_ n u - k).+1.
Definition net_program n u c L M k dk := knot_list K n u (fits n u c (off_knots u M
  (given (Nat.leb k (last_ n u)) Vertex (Value (net_row n u c L M k dk))))).

Definition ratios n u M a b := product K (fun i => (M - u$(i + n)%N) / (M - u$i)) a b.
Definition crossed n u M i N := product K (fun j => (M - u$(n + j).+1) / (M - u$j)) i N.-1.
Definition weighted n u c M N := total_of V (fun i => ((u$(i + n)%N - u$(i.-1)) / (M - u$(i.-1)) * crossed n u M i N) *: vertex c i) 1 N.
Definition difference c i := psub V (vertex c i.+1) (vertex c i).
Definition in_row A n u c M (a : answer A) := knot_list K n u (fits n u c (off_knots u M a)).
Definition products_program n u M a b := knot_list K n u (off_knots u M (Value [:: ratios n u M a b; crossed n u M a b])).
Definition closed14_program n u c L M d0 i := in_row n u c M (Value (
  ratios n u M 0 i *: d0 + ((u$n - L) / (M - u$0) * ratios n u M 1 i) *: vertex c 0 + ((L - u$(i.-1)) / (M - u$(i.-1))) *: vertex c i
    + ((M - L) / (M - u$(i.-1))) *: weighted n u c M i)).
Definition closed15_program n u c L M d0 i := in_row n u c M (Value (
  ratios n u M 0 i *: psub V d0 (vertex c 0) + ((L - M) / (M - u$(i.-1))) *:
    psub V (psub V (vertex c i) (((M - u$(i.-1)) / (M - u$0) * ratios n u M 1 i) *: vertex c 0)) (weighted n u c M i))).
Definition closed16_program n u c L M d0 i := in_row n u c M (Value (
  ratios n u M 0 i *: psub V d0 (vertex c 0)
    + (L - M) *: total_of V (fun j => (ratios n u M j.+1 i / (M - u$j)) *: difference c j) 0 i)).
End Programs.

Section Equal.
Variables (F : fieldType) (m : nat) (lt : F -> F -> bool).
Implicit Types (u : seq F) (c : seq 'rV[F]_m) (d dk p : 'rV[F]_m) (n k i : nat) (L M : F).
Local Notation K := (of_field lt).
Local Notation V := (rows F m).
Local Notation at_list := (nth 0).

Lemma off_knotsP A u M (a : answer A) x : off_knots K u M a = Value x <-> M \notin u /\ a = Value x.
Proof. by rewrite /off_knots -has_pred1 /given /= (eq_has (a2 := pred1 M)) => [|y]; [case: has; split=> // -[] | rewrite /= eq_sym]. Qed.

Lemma off_neq u M i : M \notin u -> (i < size u)%N -> M - at_list u i != 0.
Proof. by move=> off lt_i; rewrite subr_eq0; apply: contraNneq off => ->; rewrite mem_nth. Qed.

Lemma nth_above n u c L M k dk i : (i <= last_ n u - k)%N ->
  at_list (net_row K V n u c L M k dk) (k + i) = at_list (sequence (next_vertex K V n u c L M) k dk (last_ n u - k).+1) i.
Proof. by move=> le_i; rewrite nth_cat size_rev size_behead size_sequence /= ltnNge leq_addr addKn. Qed.

Lemma nth_below n u c L M k dk i : (i <= k)%N -> at_list (net_row K V n u c L M k dk) i
  = at_list (sequence (fun j => previous_vertex K V n u c L M (k - j.+1)) 0 dk k.+1) (k - i).
Proof.
rewrite leq_eqVlt => /orP[/eqP ->|lt_i]; first by rewrite -{2}[k]addn0 nth_above // subnn.
by rewrite nth_cat size_rev size_behead size_sequence lt_i nth_rev ?size_behead ?size_sequence // nth_behead -subSn // subSS.
Qed.

(** FJ07.13 program: the program that goes up and down from $d_k$ gives a row with (13) in all cells, wherever it gives a row. *)
Theorem FJ07_13_program n u c L M k dk (d : seq 'rV[F]_m) : net_program K V n u c L M k dk = Value d ->
  [/\ M \notin u, size d = (size u - n).+1, at_list d k = dk & forall i, (i < size u - n)%N -> cell (at_list u) n L M (at_list c) (at_list d) i].
Proof.
case/knot_listP=> -[n0 le_n _ _ _] /fitsP[_] /off_knotsP[off]; rewrite nat_lebE => e; have [le_k {}e] := given_Value e; rewrite -(Value_inj e) {e}.
rewrite /last_ in le_k.
split=> //; first by rewrite size_cat size_rev size_behead !size_sequence /last_; lia.
  by rewrite nth_below // subnn.
move=> i lt_i; have nz j (lt_j : (j < size u)%N) : M - at_list u j != 0 by exact: off_neq.
have [lt_ik|le_ki] := ltnP i k.
  rewrite /cell !nth_below //; last exact: ltnW.
  have nz1 : at_list u (i + n)%N - M != 0 by rewrite subr_eq0 eq_sym -subr_eq0 nz //; lia.
  rewrite (_ : (k - i)%N = (k - i.+1).+1); last by lia.
  rewrite nth_sequence; last by lia.
  move: (at_list (sequence _ _ _ _) _) => d1.
  rewrite /previous_vertex /left_side (_ : (k - (0 + (k - i.+1)).+1)%N = i) /=; last by lia.
  move: (at_list c i) (at_list c i.+1) => c0 c1; move: (at_list u (i + n)%N) (at_list u i) nz1 => p q nz1.
  by by_entries j; field.
rewrite /cell -(subnKC le_ki) -addnS !nth_above /last_; try lia.
rewrite nth_sequence /last_; last by lia.
move: (at_list (sequence _ _ _ _) _) => d1.
rewrite /next_vertex /left_side subnKC //= addnS subnKC //; have nz1 : M - at_list u i != 0 by apply: nz; lia.
move: (at_list c i) (at_list c i.+1) => c0 c1; move: (at_list u (i + n)%N) (at_list u i) nz1 => p q nz1.
by by_entries j; field.
Qed.

(** FJ07.13 row: from the first vertex the program gives the row $d_0,\dots,d_L$ of the recursion; it gives one iff the list is one of
    knots, there are $L+1$ points and $M^{*}$ is none of the knots. *)
Theorem FJ07_13_row n u c L M d0 (d : seq 'rV[F]_m) : net_program K V n u c L M 0 d0 = Value d <->
  [/\ valid lt n u, size c = (size u - n).+1, M \notin u & d = mkseq (net (at_list u) n L M (at_list c) d0) (size u - n).+1].
Proof.
have row : net_row K V n u c L M 0 d0 = mkseq (net (at_list u) n L M (at_list c) d0) (size u - n).+1.
  rewrite /net_row /last_ subn0; apply: etrans (sequenceE (f := net (at_list u) n L M (at_list c) d0) _ _) => // i _ /=.
  by congr (_ *: _); rewrite -[LHS]addrA [LHS]addrC.
rewrite /net_program knot_listP fitsP off_knotsP row; split=> [[hv [hs [off e]]]|[hv hs off ->]] //.
by split=> //; rewrite (Value_inj e).
Qed.

Lemma net_off n u c L M d0 i : M \notin u -> (i < size u)%N -> cell (at_list u) n L M (at_list c) (net (at_list u) n L M (at_list c) d0) i.
Proof. by move=> off lt_i; have [_] := @FJ07_13_exists _ _ (at_list u) n L M (at_list c) d0 _ (fun j => off_neq off (i := j)); exact. Qed.

Lemma ratiosE n u M a b : ratios K n u M a b = P (at_list u) n M a b.
Proof. by rewrite /ratios productE. Qed.

Lemma crossedE n u M i N : crossed K n u M i N = Q (at_list u) n M i N.
Proof. by rewrite /crossed productE. Qed.

Lemma row_cells n u c L M d0 i : M \notin u -> (i < size u)%N ->
  (forall j, (j < i.+1)%N -> M - at_list u j != 0) /\
  forall j, (j < i.+1)%N -> cell (at_list u) n L M (at_list c) (net (at_list u) n L M (at_list c) d0) j.
Proof. by move=> off lt_i; split=> j lt_j; [apply: off_neq | apply: net_off]; rewrite //; lia. Qed.

(** FJ07.14 products: the program gives $P(a,b)$ and $Q(a,b)$, wherever it gives values. *)
Theorem FJ07_14_products n u M a b x y : products_program K n u M a b = Value [:: x; y] ->
  x = P (at_list u) n M a b /\ y = Q (at_list u) n M a b.
Proof. by case/knot_listP=> _ /off_knotsP[_ e]; have [<- <-] := Value_inj e; rewrite ratiosE crossedE. Qed.

(** FJ07.14 program: the program of the closed form gives the vertex $i\ge1$ of the row that the recursion (13) gives, wherever it gives a value. *)
Theorem FJ07_14_program n u c L M d0 i p : (0 < i <= size u - n)%N -> closed14_program K V n u c L M d0 i = Value p ->
  p = net (at_list u) n L M (at_list c) d0 i.
Proof.
case: i => // i lt_i /knot_listP[[n0 le_n _ _ _]] /fitsP[_] /off_knotsP[off e]; rewrite -(Value_inj e) {e}.
have lt_iu : (i < size u)%N by lia.
have [h1 h2] := row_cells n c L d0 off lt_iu.
by rewrite (FJ07_14_closed h1 h2) // !ratiosE /weighted total_ofE; under eq_bigr do rewrite crossedE.
Qed.

(** FJ07.15 program: the program of the closed form gives $d_i-c_i$ of that row for $i\ge1$, wherever it gives a value. *)
Theorem FJ07_15_program n u c L M d0 i p : (0 < i <= size u - n)%N -> closed15_program K V n u c L M d0 i = Value p ->
  p = net (at_list u) n L M (at_list c) d0 i - at_list c i.
Proof.
case: i => // i lt_i /knot_listP[[n0 le_n _ _ _]] /fitsP[_] /off_knotsP[off e]; rewrite -(Value_inj e) {e}.
have lt_iu : (i < size u)%N by lia.
have [h1 h2] := row_cells n c L d0 off lt_iu.
by rewrite (FJ07_15_closed h1 h2) // !ratiosE /weighted total_ofE; under eq_bigr do rewrite crossedE.
Qed.

(** FJ07.16 program: likewise with (16), for every $i$. *)
Theorem FJ07_16_program n u c L M d0 i p : (i <= size u - n)%N -> closed16_program K V n u c L M d0 i = Value p ->
  p = net (at_list u) n L M (at_list c) d0 i - at_list c i.
Proof.
move=> lt_i /knot_listP[[n0 le_n _ _ _]] /fitsP[_] /off_knotsP[off e]; rewrite -(Value_inj e) {e}.
have lt_iu : (i < size u)%N by lia.
have [h1 h2] := row_cells n c L d0 off lt_iu.
by rewrite (FJ07_16_closed h1 h2) // ratiosE total_ofE; under eq_bigr do rewrite ratiosE.
Qed.

End Equal.
