(* Programs: the determinant of developability, and the decision.
   Definitions (n degree, u knots, c and d rows of points, pieces k = 1, 2, ...; x, y, z give the coordinates of a point):
     triple_of a b c          the determinant [a, b, c]
     condition n u c d k t    [d', c', d - c] / n^2 at t, by de Boor's algorithm on piece k
     determinant_program n u c d k s    n len^2 [d', c', d - c] at the coordinate s of piece k
     refuted n u c d k        condition does not vanish at one of the parameters 0, 1, ..., 3n - 1
     check_program n u c d    the first piece that is not empty and refuted; 0 where there is none *)
From Torse Require Import Prelude Blossom Curves Points Bernstein FJ21_4 FJ07_2 Executable Executable_knots.

Section Programs.
Variables (T Q : Type) (K : scalars T) (V : points T Q) (x y z : Q -> T).
Implicit Types (u : seq T) (n k : nat) (c d : seq Q) (s t : T).
Local Notation "u $ i" := (nth (zero K) u i) (at level 8, i at level 8, format "u $ i").
Local Notation "x + y" := (sadd K x y).
Local Notation "x - y" := (ssub K x y).
Local Notation "x * y" := (smul K x y).

Definition triple_of (a b c : Q) :=
  x a * (y b * z c - z b * y c) + y a * (z b * x c - x b * z c) + z a * (x b * y c - y b * x c).
Definition condition n u c d k t :=
  let w := drop k.-1 u in let along := infinite K :: nseq n.-1 (parameter K t) in let at_t := nseq n (parameter K t) in
  triple_of (deboor K V w (drop k.-1 d) along) (deboor K V w (drop k.-1 c) along)
    (psub V (deboor K V w (drop k.-1 d) at_t) (deboor K V w (drop k.-1 c) at_t)).
Definition determinant_program n u c d k s := knot_list K n u (fits n u c (fits n u d (given (carries K n (drop k.-1 u)) Division
  (let a := u$(n + k - 2)%N in let len := u$(n + k - 1)%N - a in let N := of_nat K n in
   Value [:: N * N * N * (len * len) * condition n u c d k (a + s * len)])))).
Definition refuted n u c d k := ~~ all (fun j => same K (condition n u c d k (of_nat K j)) (zero K)) (iota 0 (3 * n)).
Definition check_program n u c d := knot_list K n u (fits n u c (fits n u d
  (let wrong := filter (fun k => carries K n (drop k.-1 u) && refuted n u c d k) (iota 1 (last_ n u - n).+1) in Value (head 0%N wrong)))).
End Programs.

Section Equal.
Variables (F : fieldType) (lt : F -> F -> bool).
Implicit Types (u : seq F) (n k i j : nat) (c d : seq 'rV[F]_3) (s t : F).
Local Notation K := (of_field lt).
Local Notation V := (rows F 3).
Local Notation at_list := (nth 0).
Local Notation condition := (condition K V (@x_ F) (@y_ F) (@z_ F)).
Local Notation piece_of c n u k := (pcurve n (drop_ k (at_list u)) (drop_ k (at_list c))).
Local Notation det n u c d k := (triple (pderiv (piece_of d n u k)) (pderiv (piece_of c n u k)) (piece_of d n u k - piece_of c n u k)).

Lemma horner_triple (a b w : 'rV[{poly F}]_3) t : (triple a b w).[t] = triple (ev a t) (ev b t) (ev w t).
Proof. by rewrite !tripleE /x_ /y_ /z_ !mxE !(hornerD, hornerN, hornerM). Qed.

Lemma triple_ofE (a b w : 'rV[F]_3) : triple_of K (@x_ F) (@y_ F) (@z_ F) a b w = triple a b w.
Proof. by rewrite tripleE. Qed.

Lemma conditionE n u c d k t : (0 < n)%N -> span n (drop_ k (at_list u)) ->
  (det n u c d k).[t] = (n ^ 2)%:R * condition n u c d k.+1 t.
Proof.
move=> n0 sp; rewrite FJ07_3_blossoms //; have <- : ((n ^ 2)%:R : F)%:P = (n ^ 2)%:R := polyC_nat _ _.
rewrite hornerM hornerC horner_triple; congr (_ * _).
rewrite /condition triple_ofE !deboor_drop; congr (triple _ _ _); apply/rowP=> j; rewrite !mxE ?hornerD ?hornerN.
- by rewrite horner_velocity.
- by rewrite horner_velocity.
by rewrite !horner_curve.
Qed.

Lemma size_steps (v : nat -> {poly F}) (g : nat -> {poly F}) a n : (forall i, exists e, v i = e%:P) -> (forall i, (size (g i) <= a)%N) ->
  (size (blossom v g (nseq n (at_ 'X))) <= a + n)%N.
Proof.
elim: n v g a => [|n ih] v g a cv sg /=; first by rewrite addn0.
rewrite addnS -addSn; apply: ih => [i|i]; first exact: cv.
rewrite /step size_nseq; have [e ->] := cv (i + n.+1)%N; have [e' ->] := cv i; rewrite -polyCB polyCV mulrC mul_polyC.
rewrite (leq_trans (size_scale_leq _ _)) // /= !mul1r (leq_trans (size_add _ _)) // geq_max.
have mul_le (f h : {poly F}) : (size f <= 2)%N -> (size h <= a)%N -> (size (f * h)%R <= a.+1)%N.
  by move=> sf sh; rewrite (leq_trans (size_mul_leq _ _)) // -subn1 leq_subLR add1n -add2n leq_add.
by rewrite !mul_le ?sg ?size_XsubC // -opprB size_opp size_XsubC.
Qed.

Lemma size_deriv_le n (f : {poly F}) : (size f <= n.+1)%N -> (size f^`() <= n)%N.
Proof. by have [->|/lt_size_deriv lt_f le_f] := eqVneq f 0; [rewrite deriv0 size_poly0 | rewrite -ltnS (leq_trans lt_f)]. Qed.

Lemma size_curve n (v g : nat -> F) : (size (curve n v g) <= n.+1)%N.
Proof. by rewrite -add1n; apply: size_steps => i; [exists (v i) | exact: size_polyC_leq1]. Qed.

Lemma size_triple (a b w : 'rV[{poly F}]_3) i j k : (forall l, (size (a 0%R l) <= i)%N) -> (forall l, (size (b 0%R l) <= j)%N) ->
  (forall l, (size (w 0%R l) <= k)%N) -> (size (triple a b w) <= (i + (j + k).-1).-1)%N.
Proof.
move=> sa sb sw; have mul_le (f g : {poly F}) x y : (size f <= x)%N -> (size g <= y)%N -> (size (f * g)%R <= (x + y).-1)%N.
  by move=> sf sg; rewrite (leq_trans (size_mul_leq _ _)) // -!subn1 leq_sub2r // leq_add.
have add_le (f g : {poly F}) x : (size f <= x)%N -> (size g <= x)%N -> (size (f + g)%R <= x)%N.
  by move=> sf sg; rewrite (leq_trans (size_add _ _)) // geq_max sf.
have sub_le (f g : {poly F}) x : (size f <= x)%N -> (size g <= x)%N -> (size (f - g)%R <= x)%N.
  by move=> sf sg; rewrite add_le // size_opp.
rewrite tripleE /x_ /y_ /z_.
have s2 r0 r1 r2 r3 : (size (b 0%R r0 * w 0%R r1 - b 0%R r2 * w 0%R r3)%R <= (j + k).-1)%N by apply: sub_le; apply: (mul_le _ _ j k).
by apply: (add_le (_ + _)); [apply: add_le|]; apply: (mul_le _ _ i (j + k).-1).
Qed.

(** FJ07.3 program: the program gives $n\,\mathrm{len}^2\,[d',c',d-c]$ at the coordinate $s$ of piece $k$, wherever it gives a value. *)
Theorem FJ07_3_program n u c d k s p (a := at_list u (n + k)) (len := at_list u (n + k).+1 - a) :
  determinant_program K V (@x_ F) (@y_ F) (@z_ F) n.+1 u c d k.+1 s = Value [:: p] ->
  p = n.+1%:R * len ^+ 2 * (det n.+1 u c d k).[a + s * len].
Proof.
case/knot_listP=> _ /fitsP[_] /fitsP[_]; rewrite /given; case: carriesP => // sp e.
have spd : span n.+1 (drop_ k (at_list u)) by move=> i j lt_i le_j; have := sp i j lt_i le_j; rewrite !nth_drop.
rewrite conditionE //; have {}e := Value_inj e; rewrite addSn addnS !subSS !subn0 of_natE -/len in e.
move: e; rewrite natrX -[addn n k]/(n + k)%N -/a -/len; move: (condition _ _ _ _ _ _) (n.+1%:R) => q N [<-] /=.
by rewrite /len; move: (_ - a) => l; ring.
Qed.

Lemma triple_left (R : comUnitRingType) (a b w : 'rV[R]_3) (r x : R) : triple a b (r *: w - x *: (a - b)) = r * triple a b w.
Proof. by coordinates; hide_entries; ring. Qed.

(* The terms of degree n of n f and t f' are the same. *)
Lemma size_left n (f : {poly F}) : (size f <= n.+1)%N -> (size (n%:R%:P * f - 'X * f^`())%R <= n)%N.
Proof.
move=> sf; apply/leq_sizeP=> j; rewrite coefB mul_polyC coefZ coefXM coef_deriv leq_eqVlt => /predU1P[<-|lt_j].
  by case: n {sf} => [|n] /=; rewrite ?mul0r ?subr0 // mulr_natl subrr.
by rewrite (leq_sizeP _ _ sf) // mulr0; case: j lt_j => //= j lt_j; rewrite (leq_sizeP _ _ sf) // mul0rn subrr.
Qed.

(** FJ07.3 degree: the determinant $[d',c',d-c]$ of a piece has degree $3n-3$ at most, so that $3n-2$ of its values decide it.
    Hypotheses: the knots carry a piece, so that its points have a meaning. *)
Theorem FJ07_3_degree n (v : nat -> F) (p q : nat -> 'rV[F]_3) : span n v ->
  (size (triple (pderiv (pcurve n v q)) (pderiv (pcurve n v p)) (pcurve n v q - pcurve n v p)) <= 3 * n - 2)%N.
Proof.
move=> sp; have [n0|n0] := eqVneq (n%:R : F) 0.
  by rewrite FJ07_3_blossoms // natrX -(polyC_nat F) n0 polyC0 expr0n mul0r size_poly0.
have n0' : (0 < n)%N by case: n n0 {sp} => //; rewrite eqxx.
set a := pderiv _; set b := pderiv _; set w := _ - _.
have sa l : (size (a 0%R l) <= n)%N by rewrite !mxE; apply: size_deriv_le; exact: size_curve.
have sb l : (size (b 0%R l) <= n)%N by rewrite !mxE; apply: size_deriv_le; exact: size_curve.
rewrite -(size_scale _ n0) -mul_polyC -(triple_left a b w n%:R%:P 'X).
have -> : (3 * n - 2 = (n + (n + n).-1).-1)%N by move: n0'; clear; lia.
apply: size_triple => // l; have -> : (n%:R%:P *: w - 'X *: (a - b)) 0 l = n%:R%:P * w 0 l - 'X * (w 0 l)^`() by rewrite !mxE derivB.
by apply: size_left; rewrite !mxE (leq_trans (size_add _ _)) // size_opp geq_max !size_curve.
Qed.

(** FJ07.3 decides: the program that evaluates the determinant of a piece at $3n$ parameters says that it is refuted iff the piece is not developable.
    Hypotheses: the knots carry the piece; $1,\dots,3n-3$ are not 0 in the field, so that $3n-2$ of the parameters differ. *)
Theorem FJ07_3_decides n u c d k : (0 < n)%N -> (forall i, (0 < i < 3 * n - 2)%N -> i%:R != 0 :> F) -> span n (drop_ k (at_list u)) ->
  ~~ refuted K V (@x_ F) (@y_ F) (@z_ F) n u c d k.+1 <-> developable (piece_of c n u k) (piece_of d n u k).
Proof.
move=> n0 nz sp; rewrite /refuted negbK; set f := det n u c d k.
have n1 : n%:R != 0 :> F by have [->|n1] := eqVneq n 1%N; [rewrite oner_neq0 | apply: nz; move: n0 n1; clear; lia].
have n2 : (n ^ 2)%:R != 0 :> F by rewrite natrX expf_neq0.
have fE j : same K (condition n u c d k.+1 (of_nat K j)) (zero K) = (f.[j%:R] == 0).
  by rewrite /f conditionE // of_natE mulf_eq0 (negPf n2).
split=> [/iotaP all0|]; last by move=> e; apply/iotaP=> j _; rewrite fE /f e horner0.
apply: (@roots_geq_poly_eq0 _ f [seq j%:R | j <- iota 0 (3 * n - 2)]).
- by apply/allP=> _ /mapP[j lt_j ->]; rewrite rootE -fE all0 //; move: lt_j; rewrite mem_iota; clear; lia.
- rewrite map_inj_in_uniq ?iota_uniq // => i j; rewrite !mem_iota /= => lt_i lt_j.
  wlog le_ij : i j lt_i lt_j / (i <= j)%N.
    by move=> th e; case: (leqP i j) => [le_ij|/ltnW le_ji]; [apply: th | symmetry; apply: th].
  move/eqP; rewrite -subr_eq0 -opprB oppr_eq0 -natrB // => /eqP e; apply/eqP; rewrite eqn_leq le_ij /= leqNgt; apply/negP=> lt_ij.
  have le_ji : (0 < j - i < 3 * n - 2)%N by move: lt_ij lt_j; clear; lia.
  by have := nz _ le_ji; rewrite e eqxx.
by rewrite size_map size_iota; apply: FJ07_3_degree.
Qed.

(** FJ07.3 check: the program gives 0 iff every piece of the list that the knots carry is developable, and else one that is not.
    Hypotheses: the program gives a value; $1,\dots,3n-3$ are not 0 in the field. *)
Theorem FJ07_3_check n u c d k : (forall i, (0 < i < 3 * n - 2)%N -> i%:R != 0 :> F) ->
  check_program K V (@x_ F) (@y_ F) (@z_ F) n u c d = Value k ->
  (k = 0%N <-> forall j, (j <= size u - n - n)%N -> span n (drop_ j (at_list u)) -> developable (piece_of c n u j) (piece_of d n u j)) /\
  forall j, k = j.+1 -> span n (drop_ j (at_list u)) /\ ~ developable (piece_of c n u j) (piece_of d n u j).
Proof.
move=> nz /knot_listP[[n0 _ _ _ _]] /fitsP[_] /fitsP[_] e; have {e} <- := Value_inj e.
rewrite /last_; set wrong := filter _ _.
have carryE j : carries K n (drop j u) = true <-> span n (drop_ j (at_list u)).
  split=> [/carriesP sp|sp]; last apply/carriesP; move=> i l lt_i le_l; have := sp i l lt_i le_l; rewrite !nth_drop //.
have wrongP j : j.+1 \in wrong -> span n (drop_ j (at_list u)) /\ ~ developable (piece_of c n u j) (piece_of d n u j).
  rewrite mem_filter => /andP[/andP[/carryE sp bad] _]; split=> // /(iffRL (FJ07_3_decides c d n0 nz sp)).
  by rewrite bad.
have [w0|w0] : wrong = [::] \/ exists j, head 0%N wrong = j.+1 /\ j.+1 \in wrong.
- case E : wrong => [|[|j] w]; [by left | | by right; exists j; rewrite mem_head].
  by have := mem_head 0%N w; rewrite -E mem_filter mem_iota andbF.
- rewrite w0; split=> //; split=> // _ j le_j /carryE sp; apply/FJ07_3_decides => //; first exact/carryE.
  apply/negP => bad; have : j.+1 \in wrong by rewrite mem_filter sp bad mem_iota /= add1n ltnS ltnS.
  by rewrite w0.
have [j [-> in_w]] := w0; have [sp bad] := wrongP j in_w; split=> [|l [<-]] //.
split=> // all_dev; case: bad; apply: all_dev => //.
by move: in_w; rewrite mem_filter mem_iota /= add1n ltnS ltnS => /andP[].
Qed.
End Equal.
