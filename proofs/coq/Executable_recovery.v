(* Programs: the way back from a net to what made it, FJ21.7.1.
   Definitions (n degree, u knots, c and d homogeneous rows; f, g, h and w, x, y, z give coordinates of a row):
     cofactors f g h p q r s       the cofactors of four rows, of the coordinates f, g, h
     dependence_of p q r s         those of the first three coordinates for which they do not all vanish
     functions_program n u c d i   L*, M*, sigma of cell i *)
From Torse Require Import Prelude Points Functions Executable Executable_knots Executable_FJ21 Executable_changes Executable_determinant Executable_rational.

Section Programs.
Variables (T Q : Type) (K : scalars T) (V : points T Q) (w x y z : Q -> T).
Implicit Types (u : seq T) (c d : seq Q) (n i : nat).
Local Notation "u $ i" := (nth (zero K) u i) (at level 8, i at level 8, format "u $ i").
Local Notation "x + y" := (sadd K x y).
Local Notation "x - y" := (ssub K x y).
Local Notation "x * y" := (smul K x y).

Definition cofactors (f g h : Q -> T) (p q r s : Q) := let minor := triple_of K f g h in
  [:: minor q r s; zero K - minor p r s; minor p q s; zero K - minor p q r].
Definition dependence_of (p q r s : Q) := head [::] (filter (has (nonzero K))
  [:: cofactors x y z p q r s; cofactors w y z p q r s; cofactors w x z p q r s; cofactors w x y p q r s]).
Definition functions_program n u c d i := knot_list K n u (fits n u c (fits n u d (given (Nat.ltb i (last_ n u)) Vertex
  (let p := nth (origin V) c i in let q := nth (origin V) c i.+1 in let r := nth (origin V) d i in let s := nth (origin V) d i.+1 in
   given (same K (det_of K w x y z p q r s) (zero K)) (Cell i)
   (if dependence_of p q r s is [:: l0; l1; m0; m1] then
      if dependence_program K l0 l1 (zero K - m0) (zero K - m1) is Value [:: L; M; o] then
        let long := u$(i + n)%N - u$i in Value [:: u$i + long * L; u$i + long * M; o]
      else dependence_program K l0 l1 (zero K - m0) (zero K - m1)
    else Fails _ (Cell i)))))).
End Programs.

Section Recovery.
Variables (F : fieldType) (lt : F -> F -> bool).
Implicit Types (u : seq F) (c d : seq 'rV[F]_4) (p q r s : 'rV[F]_4) (n i : nat) (L M o : F).
Local Notation K := (of_field lt).
Local Notation V := (rows F 4).
Local Notation at_list := (nth 0).
Local Notation wt := (@weight F).
Local Notation px := (fun p => x_ (place p)).
Local Notation py := (fun p => y_ (place p)).
Local Notation pz := (fun p => z_ (place p)).
Local Notation dependence_of := (dependence_of K wt px py pz).

Lemma row4P p q : wt p = wt q -> px p = px q -> py p = py q -> pz p = pz q -> p = q.
Proof.
move=> ew ex ey ez; apply/rowP=> i; move: ew ex ey ez; rewrite /weight /place /x_ /y_ /z_ !mxE => e0 e1 e2 e3.
case: i => -[|[|[|[|//]]]] lt_i.
- by rewrite (_ : Ordinal lt_i = 0) //; apply: val_inj.
- by move: e1; congr (p _ _ = q _ _); apply: val_inj.
- by move: e2; congr (p _ _ = q _ _); apply: val_inj.
by move: e3; congr (p _ _ = q _ _); apply: val_inj.
Qed.

(* The coordinates of a combination of rows. *)
Lemma coordinates4 a0 a1 a2 a3 p q r s (v := a0 *: p + a1 *: q + a2 *: r + a3 *: s) :
  [/\ wt v = a0 * wt p + a1 * wt q + a2 * wt r + a3 * wt s, px v = a0 * px p + a1 * px q + a2 * px r + a3 * px s,
     py v = a0 * py p + a1 * py q + a2 * py r + a3 * py s & pz v = a0 * pz p + a1 * pz q + a2 * pz r + a3 * pz s].
Proof. by rewrite /v /weight /place /x_ /y_ /z_ !mxE. Qed.

Lemma coordinates4_0 : [/\ wt 0 = 0, px 0 = 0, py 0 = 0 & pz 0 = 0].
Proof. by rewrite /weight /place /x_ /y_ /z_ !mxE. Qed.

(* The cofactors of the coordinates f, g, h are a dependence of these, and the only one where they do not all vanish. *)
Lemma cofactorsP (f g h : 'rV[F]_4 -> F) p q r s (l := cofactors K f g h p q r s) (sum := fun (k : seq F) e => k`_0 * e p + k`_1 * e q + k`_2 * e r + k`_3 * e s) :
  [/\ sum l f = 0, sum l g = 0, sum l h = 0 &
    forall k, sum k f = 0 -> sum k g = 0 -> sum k h = 0 -> forall i j, (i < 4)%N -> (j < 4)%N -> k`_i * l`_j = k`_j * l`_i].
Proof.
rewrite /sum /l /cofactors /triple_of /=; split=> [| | |k].
1-3: by move: (f p) (f q) (f r) (f s) (g p) (g q) (g r) (g s) (h p) (h q) (h r) (h s) => *; ring.
set k0 := k`_0; set k1 := k`_1; set k2 := k`_2; set k3 := k`_3.
move: (f p) (f q) (f r) (f s) (g p) (g q) (g r) (g s) (h p) (h q) (h r) (h s) => f0 f1 f2 f3 g0 g1 g2 g3 h0 h1 h2 h3 ef eg eh.
have pair e fa fb ga gb ha hb X Y : X - Y = e * ((k0 * f0 + k1 * f1 + k2 * f2 + k3 * f3) * (ga * hb - ha * gb)
    + (k0 * g0 + k1 * g1 + k2 * g2 + k3 * g3) * (ha * fb - fa * hb) + (k0 * h0 + k1 * h1 + k2 * h2 + k3 * h3) * (fa * gb - ga * fb)) -> X = Y.
  by rewrite ef eg eh !mul0r !addr0 mulr0 => /eqP; rewrite subr_eq0 => /eqP.
have all6 (P : nat -> nat -> F) : (forall i, P i i = 0) -> (forall i j, P j i = - P i j) ->
    P 0%N 1%N = 0 -> P 0%N 2%N = 0 -> P 0%N 3%N = 0 -> P 1%N 2%N = 0 -> P 1%N 3%N = 0 -> P 2%N 3%N = 0 -> forall i j, (i < 4)%N -> (j < 4)%N -> P i j = 0.
  move=> d a p01 p02 p03 p12 p13 p23 i j lt_i lt_j.
  wlog le : i j lt_i lt_j / (i <= j)%N.
    by move=> th; case: (leqP i j) => [le|/ltnW le]; [exact: th | rewrite a th // oppr0].
  by case: i j lt_i lt_j le => [|[|[|[|//]]]] [|[|[|[|//]]]].
move=> i j lt_i lt_j; apply/eqP; rewrite -subr_eq0; apply/eqP; move: i j lt_i lt_j; apply: all6 => [i|i j||||||] /=; first by rewrite subrr.
  by rewrite opprB.
all: apply/eqP; rewrite subr_eq0; apply/eqP; rewrite -/k0 -/k1 -/k2 -/k3.
- by apply: (pair (-1) f2 f3 g2 g3 h2 h3); ring.
- by apply: (pair 1 f1 f3 g1 g3 h1 h3); ring.
- by apply: (pair (-1) f1 f2 g1 g2 h1 h2); ring.
- by apply: (pair (-1) f0 f3 g0 g3 h0 h3); ring.
- by apply: (pair 1 f0 f2 g0 g2 h0 h2); ring.
by apply: (pair (-1) f0 f1 g0 g1 h0 h1); ring.
Qed.

Local Notation depends k p q r s := (k`_0 *: p + k`_1 *: q + k`_2 *: r + k`_3 *: s = 0).

(* The cofactors of four dependent rows are a dependence, and the only one where they do not all vanish. *)
Lemma dependence_ofP p q r s l : det_of K wt px py pz p q r s = 0 -> dependence_of p q r s = l -> l <> [::] ->
  [/\ exists2 i, (i < 4)%N & l`_i != 0, depends l p q r s &
    forall k, depends k p q r s -> forall i j, (i < 4)%N -> (j < 4)%N -> k`_i * l`_j = k`_j * l`_i].
Proof.
move=> det0; rewrite /dependence_of; set a := has (nonzero K); set all4 := [:: _; _; _; _]; move=> el l0.
have [in_l nz] : l \in all4 /\ a l.
  case: (filter a all4) (mem_filter a^~ all4) el => [|y ys] memf e; first by case: l0.
  by have := memf y; rewrite mem_head -e /= => /esym/andP[-> ->].
have [i lt_i ni] : exists2 i, (i < size l)%N & l`_i != 0 by move/hasP: nz => [x /(nthP 0)[i lt_i <-]]; exists i.
have size4 : size l = 4%N by move: in_l; rewrite !inE => /or4P[]/eqP->.
rewrite size4 in lt_i; have sums (k : seq F) : depends k p q r s <-> [/\ k`_0 * wt p + k`_1 * wt q + k`_2 * wt r + k`_3 * wt s = 0,
    k`_0 * px p + k`_1 * px q + k`_2 * px r + k`_3 * px s = 0, k`_0 * py p + k`_1 * py q + k`_2 * py r + k`_3 * py s = 0 &
    k`_0 * pz p + k`_1 * pz q + k`_2 * pz r + k`_3 * pz s = 0].
  have [zw zx zy zz] := coordinates4_0; have [ew ex ey ez] := coordinates4 k`_0 k`_1 k`_2 k`_3 p q r s.
  split=> [e|[e0 e1 e2 e3]]; last by apply: row4P; rewrite ?ew ?ex ?ey ?ez ?zw ?zx ?zy ?zz.
  by rewrite -ew -ex -ey -ez e zw zx zy zz.
split; first by exists i.
  move: in_l det0; rewrite !inE /det_of /triple_of /= => /or4P[]/eqP-> det0; apply/sums; rewrite /cofactors /triple_of /=.
  all: move: (wt p) (wt q) (wt r) (wt s) (px p) (px q) (px r) (px s) (py p) (py q) (py r) (py s) (pz p) (pz q) (pz r) (pz s) det0.
  all: move=> w0 w1 w2 w3 x0 x1 x2 x3 y0 y1 y2 y3 z0 z1 z2 z3 det0.
  all: have neg (x : F) : - x = 0 -> x = 0 by move/eqP; rewrite oppr_eq0 => /eqP.
  1: split; [rewrite -[RHS]det0; ring | ring | ring | ring].
  1: split; [ring | apply: neg; rewrite -[RHS]det0; ring | ring | ring].
  1: split; [ring | ring | rewrite -[RHS]det0; ring | ring].
  1: split; [ring | ring | ring | apply: neg; rewrite -[RHS]det0; ring].
move=> k /sums[ew ex ey ez]; move: in_l; rewrite !inE => /or4P[]/eqP->.
- by have [_ _ _ other] := cofactorsP px py pz p q r s; exact: other.
- by have [_ _ _ other] := cofactorsP wt py pz p q r s; exact: other.
- by have [_ _ _ other] := cofactorsP wt px pz p q r s; exact: other.
by have [_ _ _ other] := cofactorsP wt px py p q r s; exact: other.
Qed.

(** FJ21.7.1 recovered: the program gives $\Lambda^{*},M^{*},\sigma\ne0$ with
    $(u_{i+n}-\Lambda^{*})p_i+(\Lambda^{*}-u_i)p_{i+1}=\sigma\bigl((u_{i+n}-M^{*})q_i+(M^{*}-u_i)q_{i+1}\bigr)$ on cell $i$, and no other three numbers do, wherever
    it gives a value. *)
Theorem FJ21_7_1_recovered n u c d i L M o (at_cell := fun L M o => (at_list u (i + n) - L) *: at_list c i + (L - at_list u i) *: at_list c i.+1
    = o *: ((at_list u (i + n) - M) *: at_list d i + (M - at_list u i) *: at_list d i.+1)) :
  functions_program K V wt px py pz n u c d i = Value [:: L; M; o] ->
  o != 0 /\ forall L' M' o', at_cell L' M' o' <-> [/\ L' = L, M' = M & o' = o].
Proof.
case/knot_listP=> -[_ _ _ mult _] /fitsP[_] /fitsP[_ e]; have [lt_i {}e] := given_Value e.
rewrite nat_ltbE /last_ in lt_i; have [/= /eqP det0 {}e] := given_Value e.
move: e; set p := at_list c i; set q := at_list c i.+1; set r := at_list d i; set s := at_list d i.+1.
case E: (dependence_of p q r s) => [|l0 [|l1 [|l2 [|l3 [|]]]]] //; rewrite /dependence_program /nonzero /= !sub0r /given.
case: ifP => // l01; case: ifP => // l23 [<- <- <-]; set W := at_list u (i + n) - at_list u i.
have W0 : W != 0 by rewrite subr_eq0 eq_sym mult.
have [_ dep other] := dependence_ofP det0 E (fun e => False_ind _ (ltac:(discriminate e))).
split=> [|L' M' o']; first by rewrite mulf_neq0 ?invr_eq0.
rewrite /at_cell; move: W0 dep other; rewrite /W /= -/p -/q -/r -/s; move: (at_list u (i + n)) (at_list u i) => hi lo W0 dep other.
split=> [e|[-> -> ->]]; last first.
  have -> : hi - (lo + (hi - lo) * (l1 / (l0 + l1))) = (hi - lo) / (l0 + l1) * l0 by field.
  have -> : lo + (hi - lo) * (l1 / (l0 + l1)) - lo = (hi - lo) / (l0 + l1) * l1 by field.
  have -> : hi - (lo + (hi - lo) * (- l3 / (- l2 - l3))) = (hi - lo) / (- l2 - l3) * - l2 by field.
  have -> : lo + (hi - lo) * (- l3 / (- l2 - l3)) - lo = (hi - lo) / (- l2 - l3) * - l3 by field.
  have : (- l2 - l3) / (l0 + l1) * ((hi - lo) / (- l2 - l3)) = (hi - lo) / (l0 + l1) by field; rewrite l01 l23.
  move: ((hi - lo) / (l0 + l1)) ((hi - lo) / (- l2 - l3)) (_ / (l0 + l1)) => A B o2 eAB.
  rewrite -!scalerA -!scalerDr [RHS]scalerA eAB; congr (_ *: _); apply/eqP; rewrite -subr_eq0; apply/eqP; rewrite -[RHS]dep.
  by rewrite !scaleNr opprD !opprK !addrA.
have dk : depends [:: hi - L'; L' - lo; - (o' * (hi - M')); - (o' * (M' - lo))] p q r s.
  rewrite /= !scaleNr -!scalerA -addrA -opprD -scalerDr e; exact: subrr.
have {}other a b lt_a lt_b := other _ dk a b lt_a lt_b.
have k0 : [/\ (hi - L') * l1 = (L' - lo) * l0, (hi - L') * l2 = - (o' * (hi - M')) * l0 & (hi - L') * l3 = - (o' * (M' - lo)) * l0].
  by split; [exact: (other 0%N 1%N) | exact: (other 0%N 2%N) | exact: (other 0%N 3%N)].
have k1 : [/\ (L' - lo) * l2 = - (o' * (hi - M')) * l1, (L' - lo) * l3 = - (o' * (M' - lo)) * l1 & - (o' * (hi - M')) * l3 = - (o' * (M' - lo)) * l2].
  by split; [exact: (other 1%N 2%N) | exact: (other 1%N 3%N) | exact: (other 2%N 3%N)].
have [e01 e02 e03] := k0; have [e12 e13 e23] := k1.
have eL : L' = lo + (hi - lo) * (l1 / (l0 + l1)).
  apply: (mulIf l01); rewrite mulrDl mulrA -[_ * l1 / _ * _]mulrA mulVf // mulr1.
  by rewrite (_ : (hi - lo) * l1 = (hi - L') * l1 + (L' - lo) * l1); [rewrite e01; ring | ring].
have eo : o' = (- l2 - l3) / (l0 + l1).
  apply: (mulIf l01); rewrite divfK //; apply: (mulIf W0).
  transitivity (- (- (o' * (hi - M')) * l0 + - (o' * (hi - M')) * l1 + - (o' * (M' - lo)) * l0 + - (o' * (M' - lo)) * l1)); first by ring.
  by rewrite -e02 -e03 -e12 -e13; ring.
have o0 : o' != 0 by rewrite eo mulf_neq0 ?invr_eq0.
split=> //; apply: (mulIf l23); rewrite [RHS]mulrDl mulrA divfK //; apply: (mulfI o0); apply/eqP; rewrite -subr_eq0; apply/eqP.
transitivity (- (- (o' * (hi - M')) * l3) + - (o' * (M' - lo)) * l2); [ring | by rewrite e23 addNr].
Qed.
End Recovery.
