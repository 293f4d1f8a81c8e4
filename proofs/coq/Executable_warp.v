(* Programs: the warp angle of a ruling, BZZ19.W.
   Definitions (n degree, u knots, c and d rows of points, pieces k = 1, 2, ...; x, y, z give the coordinates of a point):
     warp_of a b w                sin^2 of the warp angle of the ruling w between the tangents a and b: |w|^2 [a, w, b]^2 / (|a x w|^2 |b x w|^2)
     warp_program n u c d k t     that at the parameter t of piece k *)
From Torse Require Import Prelude Blossom Curves Points FJ21_4 BZZ19_5 Executable Executable_knots Executable_determinant Executable_rulings.
From mathcomp Require Import order ssrnum.
Import Num.Theory.

Section Programs.
Variables (T Q : Type) (K : scalars T) (V : points T Q) (x y z : Q -> T).
Implicit Types (u : seq T) (n k : nat) (c d : seq Q) (t : T).
Local Notation "x + y" := (sadd K x y).
Local Notation "x * y" := (smul K x y).

Definition warp_of (a b w : Q) :=
  let det := triple_of K x y z a w b in let square := crossed_dot K x y z in
  let m := square a w a w in let n := square b w b w in
  given (~~ same K (m * n) (zero K)) Division
    (Value [:: (x w * x w + y w * y w + z w * z w) * (det * det) * sinv K (m * n)]).
Definition warp_program n u c d k t := knot_list K n u (fits n u c (fits n u d (given (carries K n (drop k.-1 u)) Division
  (let v := drop k.-1 u in let at_t := nseq n (parameter K t) in let along := infinite K :: nseq n.-1 (parameter K t) in
   let slope := fun r => pscale V (of_nat K n) (deboor K V v (drop k.-1 r) along) in
   warp_of (slope c) (slope d) (psub V (deboor K V v (drop k.-1 d) at_t) (deboor K V v (drop k.-1 c) at_t)))))).
End Programs.

Section Equal.
Variable F : rcfType.
Implicit Types (u : seq F) (n k : nat) (c d : seq 'rV[F]_3) (t : F) (a b w : 'rV[F]_3).
Local Notation K lt := (of_field (F := [fieldType of F]) lt).
Local Notation V := (rows [fieldType of F] 3).
Local Notation X_ := (@x_ [fieldType of F]).
Local Notation Y_ := (@y_ [fieldType of F]).
Local Notation Z_ := (@z_ [fieldType of F]).
Local Notation piece_of c n u k := (pcurve n (drop_ k (nth 0 u)) (drop_ k (nth 0 c))).

(** BZZ19.W program: the program gives the square of the sine of the warp angle, and the error iff a normal $a\times w$ or $b\times w$ vanishes.
    Hypotheses: a real closed field. *)
Theorem BZZ19_W_program lt a b w : warp_of (K lt) X_ Y_ Z_ a b w =
  if (cross a w == 0) || (cross b w == 0) then Fails _ Division else Value [:: warp_sin a b w ^+ 2].
Proof.
rewrite /warp_of !crossed_dotE triple_ofE /given /= mulf_eq0 !dot_zero negb_or.
case: eqP => //= m0; case: eqP => //= n0; congr (Value [:: _]).
rewrite /warp_sin expr_div_n exprMn real_normK ?num_real // exprMn !length_sqr /dot -expr2; congr (_ * _).
Qed.

(** BZZ19.W points: the program for a parameter of a piece gives that for $a=c'(t)$, $b=d'(t)$, $w=d(t)-c(t)$, wherever it gives a value.
    Hypotheses: a real closed field. *)
Theorem BZZ19_W_points lt n u c d k t s (p := piece_of c n u k) (q := piece_of d n u k) :
  warp_program (K lt) V X_ Y_ Z_ n u c d k.+1 t = Value [:: s] ->
  s = warp_sin (ev (pderiv p) t) (ev (pderiv q) t) (ev q t - ev p t) ^+ 2.
Proof.
case/knot_listP=> hv /fitsP[sc] /fitsP[sd] e; have [car {}e] := given_Value e.
have val r : size r = (size u - n).+1 -> ev (piece_of r n u k) t = deboor (K lt) V (drop k u) (drop k r) (nseq n (parameter (K lt) t)).
  move=> sr; apply/esym/(@blossoms_value _ _ lt n u r k t); rewrite /point_program /blossom_program.
  by rewrite knot_listP fitsP car.
have slo r : size r = (size u - n).+1 -> ev (pderiv (piece_of r n u k)) t
    = pscale V (of_nat (K lt) n) (deboor (K lt) V (drop k u) (drop k r) (infinite (K lt) :: nseq n.-1 (parameter (K lt) t))).
  move=> sr; apply/esym/(@blossoms_slope _ _ lt n u r k t); rewrite /derivative_program.
  by rewrite knot_listP fitsP car.
have {}e : warp_of (K lt) X_ Y_ Z_ (ev (pderiv p) t) (ev (pderiv q) t) (ev q t - ev p t) = Value [:: s].
  by rewrite /p /q !slo // !val.
by move: e; rewrite BZZ19_W_program; case: ifP => // _ [<-].
Qed.
End Equal.
