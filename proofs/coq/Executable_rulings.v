(* Programs: a developable surface through a clamped curve with given end rulings, FJ07.20 and 21.
   Definitions (n degree, u knots, c points, L their last index, v and w the end rulings, M for M_0, S for the free starred Lambda):
     aim_program n u c M i         the point a(M) of (20) for the vertex i, L in the paper
     times_root a s                the coefficients of (X - a) times the polynomial with the coefficients s
     chord_rows n u c i k h t      k steps more from the step i of the sum (c_L - a(M)) prod_{j < L-1} (M - u_j)
     branch_program n u c v w      the coefficients of the polynomial whose roots are the values M_0
     crossed_dot a b c d           (a x b).(c x d)
     coordinates_program p v w     alpha, beta of p = alpha v + beta w
     ends_program n u c v w M S    sigma_0, tau_0 of (21)
     interpolation_program n u c v w M S   the row d *)
From Torse Require Import Prelude Blossom Curves Points FJ07_2 FJ07_2_cones FJ07_3_net FJ07_3_generic FJ07_4 FJ07_4_rulings Executable Executable_knots Executable_net
  Executable_determinant.
From mathcomp Require Import order ssrnum.

Section Programs.
Variables (T Q : Type) (K : scalars T) (V : points T Q) (x y z : Q -> T).
Implicit Types (u h : seq T) (c s : seq Q) (n k i : nat) (a M S : T) (v w p : Q).
Local Notation "u $ i" := (nth (zero K) u i) (at level 8, i at level 8, format "u $ i").
Local Notation vertex c i := (nth (origin V) c i).
Local Notation "x + y" := (sadd K x y).
Local Notation "x - y" := (ssub K x y).
Local Notation "x * y" := (smul K x y).
Local Notation "x / y" := (smul K x (sinv K y)).
Local Notation "x *: p" := (pscale V x p).

Definition aim_of n u c M i := padd V (((M - u$(i.-1)) / (M - u$0) * ratios K n u M 1 i) *: vertex c 0) (weighted K V n u c M i).
Definition aim_program n u c M i := in_row K n u c M (Value (aim_of n u c M i)).

Definition times_root R (W : points T R) a (s : seq R) :=
  mkseq (fun j => psub W (if j is i.+1 then nth (origin W) s i else origin W) (pscale W a (nth (origin W) s j))) (size s).+1.
Fixpoint chord_rows n u c i k h s := if k is k'.+1 then
  chord_rows n u c i.+1 k' (times_root (itself K) u$i h) (mkseq (fun j => padd V (vertex (times_root V u$(i + n)%N s) j) (h$j *: difference V c i)) (size h))
  else s.
Definition branch_program n u c v w := knot_list K n u (fits n u c
  (Value (map (fun p => triple_of K x y z p v w) (chord_rows n u c 0 (last_ n u) [:: one K] [::])))).

Definition minor_x v w := y v * z w - z v * y w.
Definition minor_y v w := z v * x w - x v * z w.
Definition minor_z v w := x v * y w - y v * x w.
Definition crossed_dot (a b c d : Q) := minor_x a b * minor_x c d + minor_y a b * minor_y c d + minor_z a b * minor_z c d.
Definition coordinates_program p v w := let e := crossed_dot v w v w in
  given (~~ same K e (zero K)) Parallel (Value [:: crossed_dot p w v w / e; crossed_dot v p v w / e]).

Definition ends_of n u c v w M S := let l := last_ n u in
  match coordinates_program (psub V (aim_of n u c M l) (vertex c l)) v w with
  | Value r => let over := M - u$(l.-1) in Value [:: r$0 * ((S - M) / over) / ratios K n u M 0 l; r$1 * ((M - S) / over)]
  | Fails e => Fails _ e
  end.
Definition ends_program n u c v w M S := in_row K n u c M (ends_of n u c v w M S).
Definition interpolation_program n u c v w M S := knot_list K n u (fits n u c
  (given (same K u$0 u$(n.-1) && same K u$(last_ n u) u$((size u).-1)) Knots (off_knots K u M
  match ends_of n u c v w M S with
  | Value r => Value (net_row K V n u c S M 0 (padd V (vertex c 0) (r$0 *: v)))
  | Fails e => Fails _ e
  end))).
End Programs.

Section Equal.
Variables (F : fieldType) (lt : F -> F -> bool).
Implicit Types (u h : seq F) (c s : seq 'rV[F]_3) (n k i K : nat) (a M S : F) (v w p : 'rV[F]_3).
Local Notation R := (of_field lt).
Local Notation V := (rows F 3).
Local Notation X_ := (@x_ F).
Local Notation Y_ := (@y_ F).
Local Notation Z_ := (@z_ F).
Local Notation at_list := (nth 0).

Lemma aim_ofE n u c M K : aim_of R V n u c M K.+1 = aim (at_list u) n (at_list c) K M.
Proof. by rewrite /aim_of /weighted ratiosE total_ofE /aim; congr (_ + _); under eq_bigr do rewrite crossedE. Qed.

(** FJ07.20 program: the program gives the point $a(M)$, wherever it gives a value. *)
Theorem FJ07_20_program n u c M K p : aim_program R V n u c M K.+1 = Value p -> p = aim (at_list u) n (at_list c) K M.
Proof. by case/knot_listP=> _ /fitsP[_] /off_knotsP[_ e]; rewrite -(Value_inj e) aim_ofE. Qed.

(* The polynomial with the coordinates j of points as coefficients. *)
Definition poly_of s j : {poly F} := Poly (map (fun p : 'rV[F]_3 => p 0 j) s).

Lemma coef_poly_of s j i : (poly_of s j)`_i = (at_list s i) 0 j.
Proof.
rewrite coef_Poly; have [lt_i|le_i] := ltnP i (size s); first by rewrite (nth_map 0).
by rewrite !nth_default ?size_map // mxE.
Qed.

Lemma poly_of_times a s j : poly_of (times_root V a s) j = ('X - a%:P) * poly_of s j.
Proof.
apply/polyP=> i; rewrite mulrBl coefB coefXM coefCM !coef_poly_of; have [lt_i|le_i] := ltnP i (size s).+1.
  by rewrite nth_mkseq //; case: i lt_i => [|i] _ /=; rewrite !mxE.
rewrite nth_default ?size_mkseq // mxE; case: i le_i => // i le_i /=.
by rewrite !nth_default ?mxE ?mulr0 ?subr0 //; exact: ltnW.
Qed.

Lemma Poly_times a h : Poly (times_root (itself R) a h) = ('X - a%:P) * Poly h.
Proof.
apply/polyP=> i; rewrite mulrBl coefB coefXM coefCM !coef_Poly; have [lt_i|le_i] := ltnP i (size h).+1.
  by rewrite nth_mkseq //; case: i lt_i.
rewrite nth_default ?size_mkseq //; case: i le_i => // i le_i /=.
by rewrite !nth_default ?mulr0 ?subr0 //; exact: ltnW.
Qed.

Lemma chord_rowsE n u c i k h s j : size h = i.+1 -> size s = i ->
  let U := at_list u in let C := at_list c in
  Poly h = \prod_(0 <= l < i) ('X - (U l)%:P) ->
  poly_of s j = \sum_(0 <= l < i) (\prod_(0 <= g < l) ('X - (U g)%:P) * \prod_(l.+1 <= g < i) ('X - (U (g + n)%N)%:P)) * ((C l.+1 - C l) 0 j)%:P ->
  poly_of (chord_rows R V n u c i k h s) j =
    \sum_(0 <= l < i + k) (\prod_(0 <= g < l) ('X - (U g)%:P) * \prod_(l.+1 <= g < i + k) ('X - (U (g + n)%N)%:P)) * ((C l.+1 - C l) 0 j)%:P.
Proof.
move=> sh ss U C; elim: k i h s sh ss => [|k ih] i h s sh ss eh es; first by rewrite addn0.
rewrite /= addnS -addSn; apply: ih; rewrite ?size_mkseq ?sh ?ss //.
  by rewrite Poly_times eh mulrC big_nat_recr.
rewrite [RHS]big_nat_recr //= [\prod_(i.+1 <= _ < i.+1) _]big_geq // mulr1 -eh.
transitivity (poly_of (times_root V (U (i + n)%N) s) j + Poly h * ((C i.+1 - C i) 0 j)%:P).
  apply/polyP=> l; rewrite coefD coefMC !coef_poly_of coef_Poly; have [lt_l|le_l] := ltnP l i.+1.
    by rewrite nth_mkseq //= !mxE.
  rewrite [at_list (mkseq _ _) l]nth_default ?size_mkseq ?sh // [at_list (times_root _ _ _) l]nth_default ?size_mkseq ?ss //.
  by rewrite [h`_l]nth_default ?sh // !mul0r addr0.
rewrite poly_of_times es mulr_sumr; congr (_ + _); apply: eq_big_nat => l /andP[_ lt_l].
rewrite [\prod_(l.+1 <= _ < i.+1) _]big_nat_recr //=; move: (\prod_(0 <= _ < l) _) (\prod_(l.+1 <= _ < i) _) => f g.
by ring.
Qed.

(** FJ07.20 coefficients: the program gives the coefficients of the polynomial whose roots are the values $M_0$, wherever it gives a value. *)
Theorem FJ07_20_coefficients n u c v w K r : K.+1 = (size u - n)%N -> branch_program R V X_ Y_ Z_ n u c v w = Value r ->
  Poly r = branches (at_list u) n (at_list c) K v w.
Proof.
move=> eK /knot_listP[_] /fitsP[_ e]; rewrite -(Value_inj e) /last_ -eK {e}; set s := chord_rows _ _ _ _ _ _ _ _ _.
have es j : poly_of s j = chord (at_list u) n (at_list c) K 0 j.
  rewrite (@chord_rowsE n u c 0 K.+1 [:: 1] [::] j) //.
  - rewrite /chord summxE; apply: eq_big_nat => l _; rewrite /factor [RHS]mxE; congr (_ * _).
    by rewrite /fixed [RHS]mxE.
  - by rewrite big_geq //; apply/polyP=> l; rewrite coef_Poly coefC; case: l => [|l] //=; rewrite nth_nil.
  by rewrite big_geq //; apply/polyP=> l; rewrite coef_poly_of nth_nil mxE coef0.
have co l : triple (at_list s l) v w = (branches (at_list u) n (at_list c) K v w)`_l.
  rewrite /branches !tripleE /x_ /y_ /z_ -!es /fixed !mxE -!polyCM -!polyCB !(coefD, coefMC) !coef_poly_of.
  by coordinates; ring.
apply/polyP=> l; rewrite coef_Poly -co; have [lt_l|le_l] := ltnP l (size s).
  by rewrite (nth_map 0) // triple_ofE.
rewrite !nth_default ?size_map //; coordinates; ring.
Qed.

Lemma crossed_dotE (a b c d : 'rV[F]_3) : crossed_dot R X_ Y_ Z_ a b c d = dot (cross a b) (cross c d).
Proof. by coordinates. Qed.

Lemma coordinatesE p v w (nrm := cross v w) : coordinates_program R X_ Y_ Z_ p v w =
  given (triple v w nrm != 0) Parallel (Value [:: along v w nrm p; beside v w nrm p]).
Proof.
rewrite /coordinates_program !crossed_dotE /nrm /along /beside /=.
have -> : triple v w (cross v w) = dot (cross v w) (cross v w) by coordinates; ring.
have -> : triple p w (cross v w) = dot (cross p w) (cross v w) by coordinates; ring.
have -> : triple v p (cross v w) = dot (cross v p) (cross v w) by coordinates; ring.
by [].
Qed.

(** FJ07.21 coordinates: the program gives $\alpha$, $\beta$ with $x=\alpha v+\beta w$ for every $x$ with $[x,v,w]=0$, wherever it gives values. *)
Theorem FJ07_21_coordinates p v w alpha beta : coordinates_program R X_ Y_ Z_ p v w = Value [:: alpha; beta] ->
  triple p v w = 0 -> p = alpha *: v + beta *: w.
Proof. by rewrite coordinatesE => e par; have [nz [<- <-]] := given_Value e; exact: FJ07_21_coefficients. Qed.

Lemma ends_ofE n u c v w M S K sigma tau : (0 < n)%N -> M \notin u -> K.+1 = (size u - n)%N ->
  ends_of R V X_ Y_ Z_ n u c v w M S = Value [:: sigma; tau] -> root (branches (at_list u) n (at_list c) K v w) M ->
  net (at_list u) n S M (at_list c) (at_list c 0 + sigma *: v) K.+1 = at_list c K.+1 + tau *: w.
Proof.
move=> n0 off eK; rewrite /ends_of /last_ -eK aim_ofE coordinatesE /given; case: ifP => // nz [<- <-].
have nz1 i : (i < K.+1)%N -> M - at_list u i != 0 by move=> lt_i; apply: off_neq off _; lia.
have nz2 i : (i < K.+1)%N -> M - at_list u (i + n)%N != 0 by move=> lt_i; apply: off_neq off _; lia.
move=> rt; have par := (FJ07_20_branches n (at_list c) v w nz1).2 rt; have := @FJ07_21_coefficients F v w _ nz par.
move: (along _ _ _ _) (beside _ _ _ _) => al be e.
have := FJ07_21_interpolation S nz1 nz2 e; rewrite /first_end /last_end ratiosE.
have -> : \prod_(0 <= i < K.+1) ((M - at_list u i) / (M - at_list u (i + n)%N)) = (P (at_list u) n M 0 K.+1)^-1.
  by rewrite /P -prodfV; apply: eq_bigr => i _; rewrite invf_div.
by [].
Qed.

Lemma ends_same n u c v w M sigma tau : ends_of R V X_ Y_ Z_ n u c v w M M = Value [:: sigma; tau] -> sigma = 0 /\ tau = 0.
Proof. by rewrite /ends_of coordinatesE /given; case: ifP => // _ [<- <-]; rewrite /= subrr !(mul0r, mulr0). Qed.

Lemma last_along (u : nat -> F) n S M (c : nat -> 'rV[F]_3) v w K sigma tau : (forall i, (i < K.+1)%N -> M - u i != 0) -> S != M ->
  net u n S M c (c 0%N + sigma *: v) K.+1 = c K.+1 + tau *: w -> triple (aim u n c K M - c K.+1) v w = 0.
Proof.
move=> off; rewrite -subr_eq0 => S0 e; have [e0 cells] := FJ07_13_exists n S c (c 0%N + sigma *: v) off.
have := FJ07_20_last off cells; rewrite e0 e ![_ + _ *: _ - _]addrAC !subrr !add0r.
have k0 : (S - M) / (M - u K) != 0 by rewrite mulf_neq0 ?invr_eq0 // off.
move: (aim _ _ _ _ _) (P _ _ _ _ _) k0 => a p; move: ((S - M) / (M - u K)) => k k0 {}e.
have -> : a - c K.+1 = k^-1 *: (p *: (sigma *: v) - tau *: w).
  by rewrite -[LHS]scale1r -(mulVf k0) -[LHS]scalerA; congr (_ *: _); rewrite e opprD addrA subrr sub0r -scalerN opprB.
by coordinates; ring.
Qed.

(** FJ07.21 program: for a value $M_0$ the programs give $\sigma_0$, $\tau_0$ and the row $d$ with $d_0=c_0+\sigma_0v$ and (13) in all cells, wherever they give
    values; $d_L=c_L+\tau_0w$ iff $M_0$ is a root of the polynomial of (20), or $\Lambda^{*}=M_0$, where $d=c$. *)
Theorem FJ07_21_program n u c v w M S K sigma tau (r : seq 'rV[F]_3) : K.+1 = (size u - n)%N ->
  ends_program R V X_ Y_ Z_ n u c v w M S = Value [:: sigma; tau] -> interpolation_program R V X_ Y_ Z_ n u c v w M S = Value r ->
  [/\ at_list r 0 = at_list c 0 + sigma *: v, forall i, (i < K.+1)%N -> cell (at_list u) n S M (at_list c) (at_list r) i &
    at_list r K.+1 = at_list c K.+1 + tau *: w <-> root (branches (at_list u) n (at_list c) K v w) M \/ S = M].
Proof.
move=> eK /knot_listP[hv] /fitsP[sc] /off_knotsP[off ends]; have [n0 _ _ _ _] := hv.
case/knot_listP=> _ /fitsP[_] e; have [_ {}e] := given_Value e; case/off_knotsP: e => _; rewrite ends => /= er.
have en : net_program R V n u c S M 0 (at_list c 0 + sigma *: v) = Value r.
  by rewrite /net_program knot_listP; split=> //; rewrite fitsP; split=> //; rewrite off_knotsP; split.
have [_ _ r0 cells] := FJ07_13_program en; split=> // [i lt_i|]; first by apply: cells; rewrite -eK.
have nz i : (i < K.+1)%N -> M - at_list u i != 0 by move=> lt_i; apply: off_neq off _; move: lt_i eK; clear; lia.
have [_ _ _ ->] := (FJ07_13_row _ _ _ _ _ _ _ _).1 en; rewrite nth_mkseq -?eK //; split=> [e|[rt|eS]].
- have [->|S_M] := eqVneq S M; [by right | left].
  by apply/(FJ07_20_branches n (at_list c) v w nz); apply: last_along nz S_M e.
- exact: ends_ofE ends rt.
subst S; have [es et] := ends_same ends; have [e0 all_cells] := FJ07_13_exists n M (at_list c) (at_list c 0 + sigma *: v) nz.
have := FJ07_20_last nz all_cells; rewrite e0 es et !scale0r !addr0 !subrr mul0r !(scaler0, scale0r) addr0 => /eqP.
by rewrite subr_eq0 => /eqP.
Qed.

End Equal.

(** FJ07.21 parallel: the program for $\alpha$, $\beta$ gives the error of parallel rulings iff $v\times w=0$.
    Hypotheses: an ordered field. *)
Theorem FJ07_21_parallel (G : realFieldType) (less_ : G -> G -> bool) (p v w : 'rV[G]_3) :
  coordinates_program (of_field less_) (@x_ G) (@y_ G) (@z_ G) p v w = Fails _ Parallel <-> cross v w = 0.
Proof.
rewrite coordinatesE /given.
have [e|nz] := eqVneq (triple v w (cross v w)) 0; split=> //=.
  by move=> _; apply/eqP; apply: contraT => /FJ07_21_norm; rewrite e eqxx.
by move=> e; move: nz; rewrite e; rewrite (_ : triple v w 0 = 0) ?eqxx //; coordinates; ring.
Qed.
