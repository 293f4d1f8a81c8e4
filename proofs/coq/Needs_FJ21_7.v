(* FJ21, section 7: what happens without the hypotheses of the theorems, one counterexample each. *)
From Torse Require Import Prelude Blossom Curves Points FJ07_3_net FJ07_3_blossoms FJ21_3 FJ21_7_net Needs_blossoms Needs_FJ07.

Section Needs.
Variable F : fieldType.

(** FJ21.7.1 diagonal_needs_factorial: in characteristic 2 the points $0,1,0,0$ of degree 3 have $p[t,t,0]=2t(1-t)=0$, which for $q=0$ is the diagonal form with
    $\Lambda=0$, and $p[0,1,0]=1$: the full form does not hold.
    Hypotheses: $2=0$ in the field. *)
Theorem FJ21_7_1_diagonal_needs_factorial M s (c := fun i => const_mx (i == 1%N)%:R : 'rV[F]_1) (d := fun=> 0 : 'rV[F]_1) : 2%:R = 0 :> F ->
  last_point 3 (step01 F 3) c 0 = s%:P *: last_point 3 (step01 F 3) d M /\
  pblossom (step01 F 3) c [:: at_ 0; at_ 0; at_ 1] <> s *: pblossom (step01 F 3) d [:: at_ M; at_ 0; at_ 1].
Proof.
move=> two; have t0 (x : {poly F}) : x + x = 0 by rewrite -mulr2n -mulr_natr -(rmorph_nat [rmorphism of @polyC F]) /= two mulr0.
have simp := (mul0r, mulr0, mul1r, mulr1, addr0, add0r, subr0, sub0r, divr1, subrr, oppr0).
split; last first.
  move=> /rowP/(_ 0); rewrite !mxE /= /step /shift /step01 /coord /c /d !mxE /= !simp => /eqP.
  by rewrite oner_eq0.
apply/rowP=> k; rewrite !mxE /= /step /shift /polys /step01 /coord /c /d !mxE /= ?polyC1 ?polyC0 !simp.
by rewrite [X in _ + X]mulrC t0.
Qed.

(** FJ21.7.1 spline_needs_cover: where a cell belongs to no piece that is not empty, the pieces are related and the net equations fail: $n=1$, $N=2$, the knots
    $0,0,1$, $\Lambda=1$, $M=0$, $\sigma=1$, the points $1,0,0$ and $0,0,0$. *)
Theorem FJ21_7_1_spline_needs_cover (u := listed [:: 0; 0; 1] : nat -> F) (c := on_line [:: 1; 0; 0]) (d := on_line [::]) :
  (forall k, (k < 2)%N -> span 1 (drop_ k u) -> forall v, (size v).+1 = 1%N ->
    pblossom (drop_ k u) (drop_ k c) (at_ 1 :: v) = 1 *: pblossom (drop_ k u) (drop_ k d) (at_ 0 :: v)) /\
  (u 1%N - 1) *: c 0%N + (1 - u 0%N) *: c 1%N <> 1 *: ((u 1%N - 0) *: d 0%N + (0 - u 0%N) *: d 1%N).
Proof.
split; last first.
  rewrite /u /c /d /on_line /listed /= => /rowP/(_ 0); rewrite !mxE !sub0r ?nth_nil !(mulr0, mul0r, addr0, mulr1) => /eqP.
  by rewrite oppr_eq0 oner_eq0.
move=> [|[|//]] _ sp [] // _.
  by have := sp 0%N 1%N isT isT; rewrite /u /drop_ /listed /= subrr unitr0.
apply/rowP=> k; rewrite !mxE /= /step /drop_ /u /coord /c /d /on_line /listed /= !mxE ?nth_nil /=.
by rewrite !(mulr0, mul0r, addr0, add0r, subrr).
Qed.
End Needs.
