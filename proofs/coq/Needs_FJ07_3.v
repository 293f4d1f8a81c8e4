(* FJ07, sections 2 and 3, Theorem 1, the cones and the decision by the determinant: what happens without the hypotheses, one counterexample each, over any field. *)
From Torse Require Import Prelude Blossom Curves Points Bernstein Bezier FJ07_2 FJ07_2_tangent FJ07_3_net FJ07_3_blossoms FJ07_2_cones
  FJ07_3_vertices FJ21_4 Needs_blossoms Needs_FJ07 Executable Executable_knots Executable_determinant.

Section Needs.
Variable F : fieldType.
Implicit Types (u : nat -> F) (L M t v k al : F) (n i K : nat).

(** FJ07.13 smooth_needs_knot: for $M^{*}=2$, not the inner knot 1 of the knots $0,1,2$, $n=1$, and $\Lambda^{*}=0$ the bent polygon $0,0,1$ has the net $0,0,-1$.
    Hypotheses: $2\ne0$ in the field, so that the knots carry their pieces. *)
Theorem FJ07_13_smooth_needs_knot (u := fun i : nat => i%:R : F) (c := @on_line F [:: 0; 0; 1]) (d := on_line [:: 0; 0; -1]) :
  2%:R != 0 :> F ->
  [/\ 0 != 2%:R :> F, 2%:R != u 1%N, forall i, (i < 2)%N -> cell u 1 0 2%:R c d i &
      pblossom (drop_ 0 u) (drop_ 0 c) [:: at_ 2%:R] <> pblossom (drop_ 1 u) (drop_ 1 c) [:: at_ 2%:R]].
Proof.
move=> n2; split; first by rewrite eq_sym.
- by rewrite /u -subr_eq0 mulr2n addrK oner_eq0.
- by case=> [|[|//]] _; rewrite /cell line1 !mxE /u /=; ring.
move/rowP/(_ 0); rewrite !mxE /= /step /drop_ /u /coord /on_line /= !mxE /= => /eqP.
have e1 : 2%:R - 1 = 1 :> F by rewrite mulr2n addrK.
rewrite !mulr0 !mulr1 -[(1 + (0 + 1))%N]/2%N -[(1 + 0)%:R]/(1 : F) e1 !addr0 ?add0r ?mul0r ?divr1.
by rewrite eq_sym oner_eq0.
Qed.

(** FJ07.13 parameters_needs_width: where $u_n=u_0$ all pairs $\Lambda^{*}=M^{*}$ have the same first cell, a parallelogram. *)
Theorem FJ07_13_parameters_needs_width m u n (c d : nat -> 'rV[F]_m) M : u n = u 0%N -> d 1%N - d 0%N = c 1%N - c 0%N -> cell u n M M c d 0.
Proof.
move=> e side; apply/FJ07_13_rulings; rewrite add0n e subrr scale0r addr0; congr (_ *: _).
by rewrite -[d 1%N](subrK (d 0%N)) side; move: (c 0%N) (c 1%N) (d 0%N) => x y z; by_entries j; ring.
Qed.

(** FJ07.T1 straight_needs_length: for $\lambda=0$, $d=c$, every curve obeys Theorem 1 with $\Lambda^{*}=M^{*}$. *)
Theorem FJ07_T1_straight_needs_length m u n L (c : nat -> 'rV[F]_m) :
  related u n L L c c /\ pcurve n u c = pcurve n u c + 0 *: pderiv (pcurve n u c).
Proof. by split=> [v _|] //; rewrite scale0r addr0. Qed.

(** FJ07.6 unique_needs_alpha: for $\alpha=1$ and $d_0=c_0$ every point $a$ has $d_0-a=\alpha(c_0-a)$. *)
Theorem FJ07_6_unique_needs_alpha m (c d : nat -> 'rV[F]_m) a : d 0%N = c 0%N -> d 0%N - a = 1 *: (c 0%N - a).
Proof. by move=> ->; rewrite scale1r. Qed.

(** FJ07.7 unique_needs_binomials: where $C(n,i)=0$ in the field two rows that differ in their point $i$ have the same curve. *)
Theorem FJ07_7_unique_needs_binomials n i (c : nat -> 'rV[F]_1) (d := fun j => tangent_row n c j + const_mx (j == i)%:R) :
  (i <= n)%N -> 'C(n, i)%:R = 0 :> F ->
  pbez n d = pbez n c + pderiv (pbez n c) /\ d i <> tangent_row n c i.
Proof.
move=> le_i e; split; last first.
  by rewrite /d eqxx -[RHS]addr0 => /addrI/rowP/(_ 0); rewrite !mxE => /eqP; rewrite oner_eq0.
rewrite -FJ07_7_net; apply/rowP=> k; rewrite !mxE /bez; apply: eq_bigr => j _; rewrite /coord /d !mxE polyCD [LHS]mulrDl.
have [->|_] := eqVneq j i; last by rewrite mulr0n polyC0 mul0r addr0.
by rewrite /B -(polyC_nat F) e polyC0 mul0r !mulr0 ?addr0.
Qed.
End Needs.

Section Values.
Variable F : fieldType.
Local Notation K := (of_field (fun _ _ : F => false)).
Local Notation V := (rows F 3).
Local Notation u := [:: 0; 0; 1; 1 : F].
Local Notation c := [:: 0; 0; vec 1 0 0 : 'rV[F]_3].
Local Notation d := [:: vec 0 0 1; vec 0 (-1) 1; vec 1 1 2%:R : 'rV[F]_3].
Local Notation curve_of r := (pcurve 2 (drop_ 0 (nth 0 u)) (drop_ 0 (nth 0 r))).

Lemma carried : span 2 (drop_ 0 (nth 0 u)).
Proof. by move=> [|[|//]] [|[|[|[|//]]]] // _ _; rewrite unitfE /drop_ /= subr0 oner_eq0. Qed.

Lemma parabola (r : seq 'rV[F]_3) k : curve_of r 0 k =
  (1 - 'X) * (1 - 'X) * (nth 0 r 0 0 k)%:P + 'X * (1 - 'X) * (nth 0 r 1 0 k + nth 0 r 1 0 k)%:P + 'X * 'X * (nth 0 r 2 0 k)%:P.
Proof.
rewrite mxE /curve /= /step /shift /polys /drop_ /coord /= !polyC0 !polyC1 !subr0 !divr1 !mul1r polyCD.
by move: (nth 0 r 0 0 k)%:P (nth 0 r 1 0 k)%:P (nth 0 r 2 0 k)%:P 'X => *; ring.
Qed.

Lemma det_of (p q : 'rV[{poly F}]_3) : x_ p = 'X * 'X -> y_ p = 0 -> z_ p = 0 -> x_ q = 'X * 'X -> y_ q = 'X -> z_ q = 'X * 'X + 1 ->
  triple (pderiv q) (pderiv p) (q - p) = 2%:R * ('X ^+ 3 - 'X).
Proof.
rewrite tripleE /x_ /y_ /z_ !mxE => -> -> -> -> -> ->; rewrite !(derivD, derivM, derivX, derivC, deriv0).
by move: 'X => X; ring.
Qed.

(** FJ07.3 decides_needs_characteristic: in characteristic 3, $n=2$, the Bezier points $0,0,(1,0,0)$ and $(0,0,1),(0,-1,1),(1,1,2)$ are those of $(t^2,0,0)$ and
    $(t^2,t,t^2+1)$, with the determinant $2(t^3-t)$, which is 0 at all the parameters $0,\dots,5$: the programs do not refute the surface, and it is not developable.
    Hypotheses: $3=0$ in the field. *)
Theorem FJ07_3_decides_needs_characteristic : 3%:R = 0 :> F ->
  [/\ ~~ refuted K V (@x_ F) (@y_ F) (@z_ F) 2 u c d 1, check_program K V (@x_ F) (@y_ F) (@z_ F) 2 u c d = Value 0%N & ~ developable (curve_of c) (curve_of d)].
Proof.
move=> three; have two : 2%:R != 0 :> F.
  by apply: contra_neq (oner_neq0 F) => two; rewrite -[RHS]three (natrD _ 2 1) two add0r.
have P3 : 3%:R = 0 :> {poly F} by rewrite -(polyC_nat F) three.
have det : triple (pderiv (curve_of d)) (pderiv (curve_of c)) (curve_of d - curve_of c) = 2%:R * ('X ^+ 3 - 'X).
  apply: det_of; rewrite /x_ /y_ /z_ !parabola /= /vec !mxE /= !(addr0, polyC0, polyC1, mulr0, mulr1, add0r) //.
    by rewrite polyCD polyCN polyC1; apply: (by_multiple (z := 'X * 'X - 'X) P3); move: 'X => X; ring.
  by rewrite polyCD polyC1; move: 'X => X; ring.
have ok : ~~ refuted K V (@x_ F) (@y_ F) (@z_ F) 2 u c d 1.
  rewrite /refuted negbK; apply/allP=> j _; rewrite of_natE; apply/(@eqP F).
  have := @conditionE F (fun _ _ => false) 2 u c d 0 j%:R isT carried; rewrite det.
  have cube : 2%:R * (j%:R ^+ 3 - j%:R) = 0 :> F.
    elim: j => [|j ih]; first by rewrite exprS mul0r subrr mulr0.
    by rewrite -[j.+1]addn1 natrD -[RHS]ih; move: (j%:R) => x; apply: (by_multiple (z := 2%:R * (x * x + x)) three); ring.
  by rewrite -(polyC_nat F) !(hornerM, hornerC, hornerD, hornerN, hornerXn, hornerX) cube => /esym/eqP; rewrite mulf_eq0 natrX expf_eq0 (negPf two) => /eqP.
split=> //.
  apply/knot_listP; split; last first.
    by apply/fitsP; split=> //; apply/fitsP; split=> //; rewrite /last_ /= (negPf ok) andbF.
  by split=> //; [case=> [|[|//]] _ /= | rewrite /=]; rewrite eq_sym oner_eq0.
rewrite /developable det => /eqP; rewrite mulf_eq0 -(polyC_nat F) polyC_eq0 (negPf two) subr_eq0 /= => /eqP e.
by have := congr1 (fun f : {poly F} => f`_1) e; rewrite coefXn coefX /= => /esym/eqP; rewrite oner_eq0.
Qed.
End Values.
