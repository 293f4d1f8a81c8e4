(* FJ07, section 3: plane cells alone do not make a surface developable. *)
From Torse Require Import Prelude Blossom Curves Points Bernstein Bezier FJ07_3_cells FJ21_4 FJ07_2_cones FJ07_4 BZZ19_3.

Section Quadratic.
Variable F : fieldType.

Lemma bez2 (a : nat -> F) t : (bez 2 a).[t] = (1 - t) ^+ 2 * a 0%N + 2%:R * t * (1 - t) * a 1%N + t ^+ 2 * a 2%N /\
  ((bez 2 a)^`()).[t] = 2%:R * ((1 - t) * (a 1%N - a 0%N) + t * (a 2%N - a 1%N)).
Proof.
have -> : bez 2 a = (a 0%N)%:P * (1 - 'X) ^+ 2 + (2%:R * a 1%N)%:P * ('X * (1 - 'X)) + (a 2%N)%:P * 'X ^+ 2.
  rewrite /bez /index_iota /= !big_cons big_nil /B bin0 bin1 binn /= polyCM polyC_nat.
  by move: ((a 0%N)%:P) ((a 1%N)%:P) ((a 2%N)%:P) => x y z; ring.
split; first by rewrite !hornerE /=; ring.
by rewrite !(derivD, derivM, derivN, derivC, derivX) /= !hornerE /=; ring.
Qed.

(** FJ07.C1 needs_same: a quadratic net with plane cells, $D_1=-C_0+C_1+D_0$ and $D_2=-2C_1+2C_2+D_1$, that is not developable:
    $C=(0,0,0),(1,0,0),(1,1,0)$, $D=(0,0,1),(1,0,1),(1,2,1)$.
    Hypotheses: $2\ne0$ in the field; where $2=0$ all quadratic curves have $c'=0$ and their surfaces are developable. *)
Theorem FJ07_C1_needs_same : 2%:R != 0 :> F -> exists c d : nat -> 'rV[F]_3,
  [/\ bary 1 1 c d 0, bary 2%:R 1 c d 1 & ~ developable (pbez 2 c) (pbez 2 d)].
Proof.
move=> two; pose c i : 'rV[F]_3 := nth 0 [:: 0; vec 1 0 0; vec 1 1 0] i.
pose d i : 'rV[F]_3 := nth 0 [:: vec 0 0 1; vec 1 0 1; vec 1 2%:R 1] i; exists c, d; split.
- by apply: row3P; rewrite /x_ /y_ /z_ /c /d /vec !mxE /=; ring.
- by apply: row3P; rewrite /x_ /y_ /z_ /c /d /vec !mxE /=; ring.
move/(congr1 (fun p : {poly F} => p.[-1])); rewrite horner0 ev_triple.
have val (e : nat -> 'rV[F]_3) k : ev (pbez 2 e) (-1) 0 k = (1 - -1) ^+ 2 * e 0%N 0 k + 2%:R * -1 * (1 - -1) * e 1%N 0 k + (-1) ^+ 2 * e 2%N 0 k.
  by rewrite !mxE; case: (bez2 (coord e k) (-1)).
have der (e : nat -> 'rV[F]_3) k : ev (pderiv (pbez 2 e)) (-1) 0 k = 2%:R * ((1 - -1) * (e 1%N 0 k - e 0%N 0 k) + -1 * (e 2%N 0 k - e 1%N 0 k)).
  by rewrite !mxE; case: (bez2 (coord e k) (-1)).
have dif : ev (pbez 2 d - pbez 2 c) (-1) = ev (pbez 2 d) (-1) - ev (pbez 2 c) (-1).
  by apply/rowP=> k; rewrite !mxE hornerD hornerN.
have eC : ev (pbez 2 c) (-1) = vec (- 3%:R) 1 0 by apply: row3P; rewrite /x_ /y_ /z_ val /c /vec !mxE /=; ring.
have eD : ev (pbez 2 d) (-1) = vec (- 3%:R) 2%:R 1 by apply: row3P; rewrite /x_ /y_ /z_ val /d /vec !mxE /=; ring.
have eC' : ev (pderiv (pbez 2 c)) (-1) = vec 4%:R (- 2%:R) 0 by apply: row3P; rewrite /x_ /y_ /z_ der /c /vec !mxE /=; ring.
have eD' : ev (pderiv (pbez 2 d)) (-1) = vec 4%:R (- 4%:R) 0 by apply: row3P; rewrite /x_ /y_ /z_ der /d /vec !mxE /=; ring.
rewrite dif eC eD eC' eD' {val der dif eC eD eC' eD'} => det; have : 2%:R ^+ 3 = 0 :> F.
  by rewrite -[RHS]det; coordinates; ring.
by move/eqP; rewrite expf_eq0 (negPf two) andbF.
Qed.
End Quadratic.

Section Plane.
Variable F : fieldType.
Implicit Types (C D : 'rV[{poly F}]_3) (N : 'rV[F]_3) (h : F).

(** FJ07.3 plane: curves in one plane $N\cdot x=h$ span a developable surface, a part of the plane.
    Hypotheses: $N\ne0$, so that there is a plane. *)
Theorem FJ07_3_plane C D N h : N != 0 -> dot (fixed N) C = h%:P -> dot (fixed N) D = h%:P -> developable C D.
Proof.
move=> N0 eC eD; have slope (X : 'rV[{poly F}]_3) : dot (fixed N) X = h%:P -> dot (fixed N) (pderiv X) = 0.
  move/(congr1 (@deriv F)); rewrite derivC => <-; rewrite /dot /x_ /y_ /z_ !derivD !derivM !mxE !derivC.
  by move: (X 0 _) (X 0 _) (X 0 _) => *; ring.
apply/BZZ19_7_common; exists (fixed N); split; rewrite ?slope //.
  by apply: contraNneq N0 => /rowP e; apply/eqP/rowP=> k; have /eqP := e k; rewrite !mxE polyC_eq0 => /eqP.
by transitivity (dot (fixed N) D - dot (fixed N) C); [coordinates; hide_entries; ring | rewrite eC eD subrr].
Qed.
End Plane.
