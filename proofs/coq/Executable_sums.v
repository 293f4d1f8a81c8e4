(* Programs: one side of FJ07.13, all rulings of FJ07.16, sigma' of BZZ19.4 and the conditions of BZZ19.6 to 9; vertices of splines.
   Definitions (n degree, u knots, c points, pieces k = 1, 2, ...; x, y, z give the coordinates of a point):
     side_program n u c i t          c[u_{i+1}, ..., u_{i+n-1}, t]
     rulings_program n u c L M d0    d_i - c_i, i = 1..L, by (16)
     slope_points n u c k            the points (c_{i+1} - c_i) / (u_{i+n} - u_i) of piece k
     slope_program n u c k t         n times the spline of degree n - 1 of these points
     determinant_of w a b            [w, a, b]
     products_of N w a b             N.a, N.b, N.w
     squares_of N w a b, unit_of N   the sum of their squares; (N.N - 1)^2
     vertex_program n u b k i        c_i from the Bezier points b of piece k *)
From Torse Require Import Prelude Blossom Curves Points Bernstein Bezier Segments Insertion FJ07_3_net FJ07_4 FJ21_4 BZZ19_3 BZZ19_5 Executable Executable_knots Executable_net
  Executable_determinant Executable_rulings Executable_splines.
From mathcomp Require Import ssrnum.
Import Num.Theory.

Section Programs.
Variables (T Q : Type) (K : scalars T) (V : points T Q) (x y z : Q -> T).
Implicit Types (u : seq T) (c b : seq Q) (n k i : nat) (t L M : T) (w a N d : Q).
Local Notation "u $ i" := (nth (zero K) u i) (at level 8, i at level 8, format "u $ i").
Local Notation "s + t" := (sadd K s t).
Local Notation "s - t" := (ssub K s t).
Local Notation "s * t" := (smul K s t).

Definition side_program n u c i t := knot_list K n u (fits n u c (Value (step_point K V u n (parameter K t) c i))).
Definition rulings_program n u c L M d := in_row K n u c M (Value (mkseq (fun i => padd V
  (pscale V (ratios K n u M 0 i.+1) (psub V d (nth (origin V) c 0)))
  (pscale V (L - M) (total_of V (fun j => pscale V (ratios K n u M j.+1 i.+1 * sinv K (M - u$j)) (difference V c j)) 0 i.+1))) (last_ n u))).
Definition slope_points n u c k := mkseq (fun i => let j := (k.-1 + i)%N in
  pscale V (sinv K (u$(j + n)%N - u$j)) (psub V (nth (origin V) c j.+1) (nth (origin V) c j))) n.
Definition slope_program n u c k t := knot_list K n u (fits n u c (given (carries K n (drop k.-1 u)) Division
  (Value (pscale V (of_nat K n) (deboor K V (drop k u) (slope_points n u c k) (nseq n.-1 (parameter K t))))))).

Definition inner (p q : Q) := x p * x q + y p * y q + z p * z q.
Definition determinant_of w a (b : Q) := triple_of K x y z w a b.
Definition products_of N w a (b : Q) := [:: inner N a; inner N b; inner N w].
Definition squares_of N w a (b : Q) := inner N a * inner N a + inner N b * inner N b + inner N w * inner N w.
Definition unit_of N := let e := inner N N - one K in e * e.

Definition vertex_program n u b k i := knot_list K n u (let v := nseq n u$(n + k - 2)%N ++ nseq n u$(n + k - 1)%N in
  knot_list K n v (Value (deboor K V v b [seq parameter K u$j | j <- iota i n]))).
End Programs.

Section Equal.
Variables (F : fieldType) (m : nat) (lt : F -> F -> bool).
Implicit Types (u : seq F) (c d b r : seq 'rV[F]_m) (n k i : nat) (t L M : F).
Local Notation K := (of_field lt).
Local Notation V := (rows F m).
Local Notation at_list := (nth 0).

(** FJ07.13 sides: the program gives one side of (13), $\frac{(u_{i+n}-t)c_i+(t-u_i)c_{i+1}}{u_{i+n}-u_i}$, where $u_i\ne u_{i+n}$, wherever it gives a value; rows obey (13)
    in cell $i$ iff it gives the same point for $c$ and $\Lambda^{*}$ and for $d$ and $M^{*}$.
    Hypotheses: $i<L$. *)
Theorem FJ07_13_sides n u c d i L M p q : (i < size u - n)%N -> side_program K V n u c i L = Value p -> side_program K V n u d i M = Value q ->
  [/\ at_list u (i + n) - at_list u i != 0,
    p = (at_list u (i + n) - at_list u i)^-1 *: ((at_list u (i + n) - L) *: at_list c i + (L - at_list u i) *: at_list c i.+1) &
    cell (at_list u) n L M (at_list c) (at_list d) i <-> p = q].
Proof.
move=> lt_i /knot_listP[[_ _ _ mult _] /fitsP[_ e]] /knot_listP[_ /fitsP[_ e']]; have nz : at_list u (i + n) - at_list u i != 0.
  by rewrite subr_eq0 eq_sym mult.
rewrite -(Value_inj e) -(Value_inj e') /step_point /= !mul1r; split=> //; rewrite /cell.
by split=> [->|/(scalerI _)->] //; rewrite invr_eq0.
Qed.

(** FJ07.16 rulings: the program gives $d_i-c_i$, $i=1..L$, of the row that the recursion (13) gives; it gives them iff the list is one of knots, there are $L+1$
    points and $M^{*}$ is none of the knots. *)
Theorem FJ07_16_rulings n u c L M (d0 : 'rV[F]_m) r : rulings_program K V n u c L M d0 = Value r <->
  [/\ valid lt n u, size c = (size u - n).+1, M \notin u &
    r = mkseq (fun i => net (at_list u) n L M (at_list c) d0 i.+1 - at_list c i.+1) (size u - n)].
Proof.
have eq_row : valid lt n u -> size c = (size u - n).+1 -> M \notin u -> rulings_program K V n u c L M d0
    = Value (mkseq (fun i => net (at_list u) n L M (at_list c) d0 i.+1 - at_list c i.+1) (size u - n)).
  move=> hv sc off; apply/knot_listP; split=> //; apply/fitsP; split=> //; apply/off_knotsP; split=> //; congr Value.
  apply/eq_in_map => i; rewrite mem_iota add0n => /andP[_ lt_i].
  apply: (@FJ07_16_program _ _ lt n u c L M d0 i.+1) => //.
  by apply/knot_listP; split=> //; apply/fitsP; split=> //; apply/off_knotsP.
split=> [e|[hv sc off ->]]; last exact: eq_row.
have [hv /fitsP[sc /off_knotsP[off _]]] := iffLR (knot_listP _ _ _ _ _) e.
by split=> //; apply: Value_inj; rewrite -e eq_row.
Qed.

(** BZZ19.4 sum: the program gives $c'(t)$ on piece $k$ as $n\sum_i\frac{c_{i+1}-c_i}{u_{i+n}-u_i}B_{i,n-1}(t)$, wherever it gives a value; for a mapping this is $\sigma'(t)$. *)
Theorem BZZ19_4_sum n u c k t p : slope_program K V n u c k.+1 t = Value p ->
  p = ev (pderiv (pcurve n (drop_ k (at_list u)) (drop_ k (at_list c)))) t.
Proof.
case/knot_listP=> -[n0 _ _ _ _] /fitsP[_ e]; have [/carriesP sp {}e] := given_Value e; rewrite -(Value_inj e) deboorE of_natE.
have {}sp : span n (drop_ k (at_list u)) by move=> i j lt_i le_j; have := sp i j lt_i le_j; rewrite !nth_drop.
case: n n0 sp e => // n _ sp _; apply/rowP=> j; rewrite !mxE BZZ19_4_derivative // hornerMn horner_curve; last exact: span_shift.
rewrite mulr_natl; congr (_ *+ _); rewrite (@blossom_ext_knots _ _ (shift (drop_ k (at_list u)))) => [|i _]; last first.
  by rewrite nth_drop /shift /drop_ addSnnS.
apply: blossom_ext => i; rewrite size_nseq => le_i; rewrite /coord nth_mkseq // !mxE /slope /drop_ mulrC !addnS.
by rewrite addnA.
Qed.

Lemma knots_two n (a b : F) i (v := nseq n a ++ nseq n b) : (i <= n)%N -> knots (at_list v) i n = nseq (n - i) (at_ a) ++ nseq i (at_ b).
Proof.
move=> le_i; have eq_i : iota i n = iota i (n - i) ++ iota n i by rewrite -{1}(subnK le_i) iotaD subnKC.
rewrite /knots eq_i map_cat; congr (_ ++ _).
  rewrite (map_all (y := at_ a)) ?size_iota // => j; rewrite mem_iota => /andP[le_j lt_j].
  by rewrite /v nth_cat size_nseq nth_nseq !ifT //; lia.
rewrite (map_all (y := at_ b)) ?size_iota // => j; rewrite mem_iota => /andP[le_j lt_j].
by rewrite /v nth_cat size_nseq [(j < n)%N]ltnNge le_j /= nth_nseq ifT //; lia.
Qed.

(** blossoms vertex: the program gives back the vertex $c_i$ from the Bezier points of a piece to which it belongs, wherever it gives a value.
    Hypotheses: $k\le i\le k+n$. *)
Theorem blossoms_vertex n u c b k i p : (k <= i <= k + n)%N -> bezier_program K V n u c k.+1 = Value b ->
  vertex_program K V n u b k.+1 i = Value p -> p = at_list c i.
Proof.
move=> /andP[le_i lt_i] /blossoms_pieces[sp eb] /knot_listP[hv]; set v := _ ++ _ => /knot_listP[[n0 _ _ mult _] e]; rewrite -(Value_inj e) {e} deboorE.
have spv : span n (at_list v).
  move=> h j lt_h /andP[le_j lt_j]; have := mult 0%N; rewrite size_cat !size_nseq addnK => /(_ n0); rewrite add0n /v !nth_cat size_nseq !nth_nseq ltnn subnn n0.
  by rewrite lt_h [(j < n)%N]ltnNge le_j /= ifT 1?unitfE 1?subr_eq0 1?eq_sym //; lia.
have -> : [seq parameter K (at_list u j) | j <- iota i n] = knots (drop_ k (at_list u)) (i - k) n.
  by rewrite /knots -{1}(subnKC le_i) iotaDl -map_comp.
apply/rowP=> j; rewrite mxE; have kn : blossom (drop_ k (at_list u)) (drop_ k (coord (at_list c) j)) (knots (drop_ k (at_list u)) (i - k) n)
    = coord (at_list c) j i.
  by rewrite blossoms_knots //; [rewrite /drop_ subnKC | lia].
rewrite -[RHS]kn -(blossoms_refinement _ sp spv) ?size_knots //.
apply: blossom_ext => h; rewrite size_knots => le_h; rewrite /coord eb // mxE knots_two //.
Qed.
End Equal.

Section Conditions.
Variables (F : fieldType) (lt : F -> F -> bool).
Local Notation K := (of_field lt).
Local Notation X_ := (@x_ F).
Local Notation Y_ := (@y_ F).
Local Notation Z_ := (@z_ F).
Implicit Types (N w a b : 'rV[F]_3) (c d : 'rV[{poly F}]_3) (sigma : {poly F}) (t : F).

Lemma innerE p q : inner K X_ Y_ Z_ p q = dot p q.
Proof. by []. Qed.

(** BZZ19.6 program: for $w=C_1(t)-C_2(\sigma(t))$, $a=C_1'(t)$, $b=C_2'(\sigma(t))$ the program gives $E_1$: times $\sigma'(t)$ it is the determinant of the surface between
    $C_1$ and $C_2\circ\sigma$ at $t$. *)
Theorem BZZ19_6_program c d sigma t (w := ev c t - ev (after d sigma) t) (a := ev (pderiv c) t) (b := ev (after (pderiv d) sigma) t) :
  determinant_of K X_ Y_ Z_ w a b = triple w a b /\
  sigma^`().[t] * determinant_of K X_ Y_ Z_ w a b = (triple (pderiv (after d sigma)) (pderiv c) (after d sigma - c)).[t].
Proof.
rewrite /determinant_of triple_ofE; split=> //; rewrite BZZ19_6_determinant hornerM; congr (_ * _).
rewrite ev_triple /w /a /b (_ : ev (after d sigma - c) t = ev (after d sigma) t - ev c t); last by by_entries i; rewrite hornerD hornerN.
by move: (ev _ t) (ev (after d sigma) t) (ev (pderiv c) t) (ev c t) => p q r s; coordinates; hide_entries; ring.
Qed.

(** BZZ19.7 program: where the three numbers of the program are 0 for some $N\ne0$, and only there, $E_1=0$. *)
Theorem BZZ19_7_program w a b : determinant_of K X_ Y_ Z_ w a b = 0 <-> exists N, N != 0 /\ products_of K X_ Y_ Z_ N w a b = [:: 0; 0; 0].
Proof.
rewrite /determinant_of triple_ofE BZZ19_7_common /products_of; split=> -[N].
  by case=> nz ea eb ew; exists N; rewrite !innerE ea eb ew.
by case=> nz [ea eb ew]; exists N.
Qed.

(** BZZ19.9 program: the program gives $(|N|^2-1)^2$, which is 0 iff $N$ is a unit vector. *)
Theorem BZZ19_9_program N (s := unit_of K X_ Y_ Z_ N) : s = (dot N N - 1) ^+ 2 /\ (s = 0 <-> dot N N = 1).
Proof.
have e : s = (dot N N - 1) ^+ 2 by rewrite expr2.
by rewrite e; split=> //; split=> [/eqP|->]; [rewrite sqrf_eq0 subr_eq0 => /eqP | rewrite subrr expr0n].
Qed.
End Conditions.

Section Squares.
Variables (F : realFieldType) (lt : F -> F -> bool).
Local Notation K := (@of_field [fieldType of F] lt).
Implicit Types (N w a b : 'rV[F]_3).

(** BZZ19.8 program: the program gives $E_2$, which is 0 iff the three products are.
    Hypotheses: an ordered field. *)
Theorem BZZ19_8_program N w a b (s := squares_of K (@x_ F) (@y_ F) (@z_ F) N w a b) :
  s = E2 N a b w /\ (s = 0 <-> [/\ dot N a = 0, dot N b = 0 & dot N w = 0]).
Proof.
have e : s = E2 N a b w by rewrite /E2 !expr2.
rewrite e; split=> //; split=> [/eqP|[ea eb ew]]; rewrite ?E2_zero; first by case/and3P=> /eqP ea /eqP eb /eqP ew.
by apply/eqP; rewrite E2_zero ea eb ew eqxx.
Qed.

End Squares.
