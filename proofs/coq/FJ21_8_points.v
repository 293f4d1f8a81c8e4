(* FJ21, section 8: what determines the net of the worked example, and its control points after each of the changes.
   The field has characteristic 0 so that all printed fractions have a meaning.
   Definitions:
     elevated_p, elevated_q     the printed rows of degree 4
     inserted c                 Boehm's points for the knot 2/3 in 0, 0, 0, 1, 1, 1;  inserted_knots those knots with it *)
From Torse Require Import Prelude Blossom Curves Points Bernstein Bezier FJ07_3_net FJ21_3_needs FJ21_4 FJ21_8.
From mathcomp Require Import order ssrnum.
Import Num.Theory.

Section Example.
Variable F : numFieldType.
Local Notation p := (@example_p F).
Local Notation q := (@example_q F).
Local Notation weighted := (@weighted F).

Lemma row4_eq (a b : 'rV[F]_4) : a 0 0 = b 0 0 -> a 0 1 = b 0 1 -> a 0 2%:R = b 0 2%:R -> a 0 3%:R = b 0 3%:R -> a = b.
Proof.
move=> e0 e1 e2 e3; apply/rowP=> -[[|[|[|[|//]]]] lt_i].
- by rewrite (_ : Ordinal _ = 0) //; apply/val_inj.
- by rewrite (_ : Ordinal _ = 1) //; apply/val_inj.
- by rewrite (_ : Ordinal _ = 2%:R) //; apply/val_inj.
by rewrite (_ : Ordinal _ = 3%:R) //; apply/val_inj.
Qed.

(** FJ21.E8 unique: the points $c_0,\dots,c_3$, $d_0$, $d_1$ with their weights determine all others: a net of (7.1) over them has $\Lambda=-\frac43$, $M=-2$, $\sigma=1$ and
    the printed $d_2$, $d_3$, $\omega_2$, $\omega_3$.
    Hypotheses: a number field, such as the rationals. *)
Theorem FJ21_E8_unique (L M s : F) r : r 0%N = q 0%N -> r 1%N = q 1%N ->
  (forall j, (j < 3)%N -> (1 - L) *: p j + L *: p j.+1 = s *: ((1 - M) *: r j + M *: r j.+1)) ->
  [/\ L = - (4%:R / 3%:R), M = - 2%:R, s = 1, r 2%N = q 2%N & r 3%N = q 3%N].
Proof.
move=> e0 e1 cells; have /rowP c0 := cells 0%N isT; rewrite e0 e1 in c0.
have := (c0 0, c0 1, c0 3%:R); rewrite !mxE /= => -[[w x] z].
have es : s = 1 by move: w; rewrite !(mulr1, subrK) => <-.
have eM : M = - 2%:R.
  apply/eqP; rewrite -subr_eq0 opprK; apply/eqP; transitivity (s * ((1 - M) * (1 * 2%:R) + M * (1 * 3%:R))); first by rewrite es; ring.
  by rewrite -z; ring.
have eL : L = - (4%:R / 3%:R).
  have n3 : 3%:R != 0 :> F by rewrite pnatr_eq0.
  apply: (mulIf n3); transitivity ((1 - L) * (1 * 0) + L * (1 * 3%:R)); first by ring.
  by rewrite x es eM; field.
have M0 : M != 0 by rewrite eM oppr_eq0 pnatr_eq0.
have next j : (j < 3)%N -> r j = q j -> r j.+1 = q j.+1.
  move=> lt_j ej; have := cells j lt_j; rewrite es !scale1r ej eL; have := @FJ21_E8_net F j lt_j; rewrite scale1r => -> /esym.
  by rewrite -eM => /addrI /(scalerI M0).
have e2 := next 1%N isT e1; by split=> //; exact: (next 2%N isT e2).
Qed.

(** FJ21.E8 unique_needs_second: without $d_1$ there are other nets: $d_0$, $c_0$, $c_1$, $c_2$ with $\Lambda=0$, $M=1$, $\sigma=1$.
    Hypotheses: a number field, such as the rationals. *)
Theorem FJ21_E8_unique_needs_second (r := nth 0 [:: q 0%N; p 0%N; p 1%N; p 2%N]) :
  r 0%N = q 0%N /\ forall j, (j < 3)%N -> (1 - 0) *: p j + 0 *: p j.+1 = 1 *: ((1 - 1) *: r j + 1 *: r j.+1).
Proof.
by split=> // j lt_j; rewrite subr0 subrr !scale1r !scale0r addr0 add0r; case: j lt_j => [|[|[|//]]].
Qed.

(** FJ21.E8 unique_needs_first: nor is one determined without $d_0$: $2d_1-c_0$, $d_1$, $\frac12(c_1+d_1)$, $\frac12c_2+\frac14(c_1+d_1)$ with $\Lambda=0$, $M=2$, $\sigma=1$.
    Hypotheses: a number field, such as the rationals. *)
Theorem FJ21_E8_unique_needs_first (x := 2%:R^-1 *: (p 1%N + q 1%N)) (r := nth 0 [:: 2%:R *: q 1%N - p 0%N; q 1%N; x; 2%:R^-1 *: (p 2%N + x)]) :
  r 1%N = q 1%N /\ forall j, (j < 3)%N -> (1 - 0) *: p j + 0 *: p j.+1 = 1 *: ((1 - 2%:R) *: r j + 2%:R *: r j.+1).
Proof.
have n2 : 2%:R != 0 :> F by rewrite pnatr_eq0.
split=> // j lt_j; rewrite subr0 !scale1r scale0r addr0 (_ : 1 - 2%:R = -1) ?scaleN1r; last by ring.
case: j lt_j => [|[|[|//]]] _; rewrite /r /x /=; first by rewrite opprB subrK.
- by rewrite scalerA mulfV // scale1r addrC addrK.
by rewrite [X in _ + X]scalerA mulfV // scale1r addrC addrK.
Qed.

Definition elevated_p := nth 0 [:: weighted 1 0 0 0; weighted 1 (9%:R / 4%:R) (9%:R / 4%:R) 0;
  weighted (4%:R / 5%:R) (27%:R / 8%:R) 3%:R 0; weighted (79%:R / 120%:R) (341%:R / 79%:R) (162%:R / 79%:R) 0; weighted (5%:R / 6%:R) 5%:R 0 0].
Definition elevated_q := nth 0 [:: weighted 1 0 0 2%:R; weighted 1 (3%:R / 2%:R) (3%:R / 2%:R) (11%:R / 4%:R);
  weighted (13%:R / 15%:R) (93%:R / 52%:R) (81%:R / 52%:R) (225%:R / 52%:R);
  weighted (71%:R / 90%:R) (887%:R / 568%:R) (189%:R / 568%:R) (3645%:R / 568%:R);
  weighted (43%:R / 45%:R) (293%:R / 172%:R) (- (189%:R / 172%:R)) (1215%:R / 172%:R)].

Lemma elevated_row (a b : nat -> 'rV[F]_4) :
  (forall j k, (j <= 4)%N -> 4%:R * b j 0 k = j%:R * a j.-1 0 k + (4%:R - j%:R) * a j 0 k) -> pbez 4 b = pbez 3 a.
Proof.
move=> e; apply/rowP=> k; rewrite !mxE; have n4 : (4%:R : F)%:P != 0 by rewrite polyC_eq0 pnatr_eq0.
apply: (mulfI n4); rewrite elevate_bez -bez_scale; apply: bez_ext => j le_j.
by have := e j k le_j; rewrite /elevated /prev /coord natrB //= => ->.
Qed.

(** FJ21.E8 elevated_points: the printed points and weights of degree 4 are those of the same curves.
    Hypotheses: a number field, such as the rationals. *)
Theorem FJ21_E8_elevated_points : pbez 4 elevated_p = pbez 3 p /\ pbez 4 elevated_q = pbez 3 q.
Proof.
split; apply: elevated_row => -[|[|[|[|[|//]]]]] [[|[|[|[|//]]]] lt_k] _; rewrite !mxE /=; field; rewrite ?pnatr_eq0 //.
Qed.

(** FJ21.E8 moebius_weights: for $b=2$ the weights become $8,4,\frac65,\frac56$ and $8,4,\frac{22}{15},\frac{43}{45}$: $2^{3-j}$ times the old ones.
    Hypotheses: a number field, such as the rationals. *)
Theorem FJ21_E8_moebius_weights j : (j < 4)%N ->
  2%:R ^+ (3 - j) * p j 0 0 = nth 0 [:: 8%:R; 4%:R; 6%:R / 5%:R; 5%:R / 6%:R] j /\
  2%:R ^+ (3 - j) * q j 0 0 = nth 0 [:: 8%:R; 4%:R; 22%:R / 15%:R; 43%:R / 45%:R] j.
Proof. by case: j => [|[|[|[|//]]]] _; split; rewrite !mxE /=; field; rewrite ?pnatr_eq0. Qed.

Definition inserted (c : nat -> 'rV[F]_4) := nth 0 [:: c 0%N; 3%:R^-1 *: c 0%N + (2%:R / 3%:R) *: c 1%N;
  3%:R^-1 *: c 1%N + (2%:R / 3%:R) *: c 2%N; 3%:R^-1 *: c 2%N + (2%:R / 3%:R) *: c 3%N; c 3%N].
Definition inserted_knots := nth 0 [:: 0; 0; 0; 2%:R / 3%:R; 1; 1; 1 : F].

Lemma inserted_cell (a b : nat -> 'rV[F]_4) (L M : F) j : (forall i, (i < 3)%N -> (1 - L) *: a i + L *: a i.+1 = (1 - M) *: b i + M *: b i.+1) ->
  (j < 4)%N -> cell inserted_knots 3 L M (inserted a) (inserted b) j.
Proof.
move=> cells; have /rowP e0 := cells 0%N isT; have /rowP e1 := cells 1%N isT; have /rowP e2 := cells 2%N isT.
rewrite /cell /inserted /inserted_knots; case: j => [|[|[|[|//]]]] _ /=; apply/rowP=> k; have := (e0 k, e1 k, e2 k);
  rewrite !mxE => -[[f0 f1] f2].
- apply: (by_multiple (z := 2%:R / 3%:R) f0); move: (a 0%N 0 k) (a 1%N 0 k) (b 0%N 0 k) (b 1%N 0 k) => *; by field.
- have f : 3%:R^-1 * ((1 - L) * a 0%N 0 k + L * a 1%N 0 k) + 2%:R / 3%:R * ((1 - L) * a 1%N 0 k + L * a 2%N 0 k)
    = 3%:R^-1 * ((1 - M) * b 0%N 0 k + M * b 1%N 0 k) + 2%:R / 3%:R * ((1 - M) * b 1%N 0 k + M * b 2%N 0 k) by rewrite f0 f1.
  apply: (by_multiple (z := 1) f); move: (a 0%N 0 k) (a 1%N 0 k) (a 2%N 0 k) (b 0%N 0 k) (b 1%N 0 k) (b 2%N 0 k) => *; by field.
- have f : 3%:R^-1 * ((1 - L) * a 1%N 0 k + L * a 2%N 0 k) + 2%:R / 3%:R * ((1 - L) * a 2%N 0 k + L * a 3%N 0 k)
    = 3%:R^-1 * ((1 - M) * b 1%N 0 k + M * b 2%N 0 k) + 2%:R / 3%:R * ((1 - M) * b 2%N 0 k + M * b 3%N 0 k) by rewrite f1 f2.
  apply: (by_multiple (z := 1) f); move: (a 1%N 0 k) (a 2%N 0 k) (a 3%N 0 k) (b 1%N 0 k) (b 2%N 0 k) (b 3%N 0 k) => *; by field.
apply: (by_multiple (z := 3%:R^-1) f2); move: (a 2%N 0 k) (a 3%N 0 k) (b 2%N 0 k) (b 3%N 0 k) => *; by field.
Qed.

(** FJ21.E8 inserted: with the knot $\frac23$ inserted both rows obey the net equations of a spline with the same $\Lambda=-\frac43$, $M=-2$, $\sigma=1$.
    Hypotheses: a number field, such as the rationals. *)
Theorem FJ21_E8_inserted j : (j < 4)%N -> cell inserted_knots 3 (- (4%:R / 3%:R)) (- 2%:R) (inserted p) (inserted q) j.
Proof. by apply: inserted_cell => i lt_i; rewrite (FJ21_E8_net F lt_i) scale1r. Qed.
End Example.
