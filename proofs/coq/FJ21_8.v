(* FJ21, section 8: the worked example, over any number field (numFieldType), such as the rationals.
   The field has characteristic 0 so that all printed fractions have a meaning.
   Definitions:
     weighted w x y z   the homogeneous row of the point (x, y, z) with the weight w
     example_p, example_q   the rows of c(t) and d(t) *)
From Torse Require Import Prelude Points FJ07_3_blossoms FJ21_3_needs FJ21_7_net.
From mathcomp Require Import order ssrnum.
Import Num.Theory.

Section Example.
Variable F : numFieldType.

Definition weighted (w x y z : F) : 'rV[F]_4 := row4 w (w * x) (w * y) (w * z).
Definition example_p := nth 0 [:: weighted 1 0 0 0; weighted 1 3%:R 3%:R 0; weighted (3%:R / 5%:R) 4%:R 3%:R 0; weighted (5%:R / 6%:R) 5%:R 0 0].
Definition example_q := nth 0 [:: weighted 1 0 0 2%:R; weighted 1 2%:R 2%:R 3%:R;
  weighted (11%:R / 15%:R) (3%:R / 2%:R) (21%:R / 22%:R) (135%:R / 22%:R);
  weighted (43%:R / 45%:R) (293%:R / 172%:R) (- (189%:R / 172%:R)) (1215%:R / 172%:R)].

(** FJ21.E8 net: the printed points and weights obey the net equations of (7.1) with $\Lambda=-\frac43$, $M=-2$, $\sigma=1$.
    Hypotheses: a number field, such as the rationals. *)
Theorem FJ21_E8_net (L := - (4%:R / 3%:R) : F) (M := - 2%:R : F) j : (j < 3)%N ->
  (1 - L) *: example_p j + L *: example_p j.+1 = 1 *: ((1 - M) *: example_q j + M *: example_q j.+1).
Proof.
rewrite /L /M; case: j => [|[|[|//]]] _; apply/rowP=> -[[|[|[|[|//]]]] lt_k]; rewrite !mxE /=; field; rewrite ?pnatr_eq0 //.
Qed.

(** FJ21.E8 edge: $v(t)=\frac{t-M}{\Lambda-t+t-M}=\frac32t+3$.
    Hypotheses: a number field, such as the rationals. *)
Theorem FJ21_E8_edge (L := - (4%:R / 3%:R) : F) (M := - 2%:R : F) t : (t - M) / (L - t + (t - M)) = 3%:R / 2%:R * t + 3%:R.
Proof.
have -> : L - t + (t - M) = 2%:R / 3%:R by rewrite /L /M; field.
by rewrite /M; field.
Qed.

(** FJ21.E8 moebius: for $b=2$: $\tilde\Lambda=8$, $\tilde M=4$, $\tilde\sigma=3$.
    Hypotheses: a number field, such as the rationals. *)
Theorem FJ21_E8_moebius (L := - (4%:R / 3%:R) : F) (M := - 2%:R : F) (b := 2%:R : F) :
  [/\ b * L / (1 + (b - 1) * L) = 8%:R, b * M / (1 + (b - 1) * M) = 4%:R & 1 * (1 + (b - 1) * M) / (1 + (b - 1) * L) = 3%:R].
Proof.
have e1 : 1 + (b - 1) * L = - (1 / 3%:R) by rewrite /b /L; field.
have e2 : 1 + (b - 1) * M = - 1 by rewrite /b /M; ring.
by rewrite e1 e2 /b /L /M; split; field.
Qed.

(** FJ21.E8 elevated: in degree 4: $\tilde\Lambda=-\frac u3-\frac{16}9$, $\tilde M=-\frac u3-\frac83$, by (5.3) with $f=g=1$.
    Hypotheses: a number field, such as the rationals. *)
Theorem FJ21_E8_elevated t (L := - (4%:R / 3%:R) : F) (M := - 2%:R : F) :
  (4%:R * L - t) / 3%:R = - (t / 3%:R) - 16%:R / 9%:R /\ (4%:R * M - t) / 3%:R = - (t / 3%:R) - 8%:R / 3%:R.
Proof. by rewrite /L /M; split; field; rewrite ?pnatr_eq0. Qed.

(** FJ21.E8 trimmed: for $g=1-\frac34t$: $\tilde\Lambda=\frac{9t^2-3t-32}{9(1-2t)}$ and $\tilde M=\frac{7t-16}{3(1-2t)}$ give $\Lambda=-\frac43$, $M=-2$ by (5.4) with $f=1$,
    $\tilde\sigma=1$.
    Hypotheses: a number field; $t\ne\frac12$, so that $\tilde\Lambda$ and $\tilde M$ have a meaning, and $t\ne\frac43$, where the ruling has no length, so that the quotients
    of (5.4) have one, $G=H=0$ there.
    Paper: writes $\tilde d=c+g(d-c)$; it is the rows that have $\tilde q=p+g(q-p)$, and the weights are not equal. *)
Theorem FJ21_E8_trimmed t (g := fun x : F => 1 - 3%:R / 4%:R * x) (M := (7%:R * t - 16%:R) / (3%:R * (1 - 2%:R * t)))
    (L := (9%:R * t ^+ 2 - 3%:R * t - 32%:R) / (9%:R * (1 - 2%:R * t))) (G := 3%:R * g t + g M) : 1 - 2%:R * t != 0 -> 3%:R * t - 4%:R != 0 ->
  (1 * t + 3%:R * 1 * L + 1 * (3%:R * M * (g t - 1) + t * (g M - 1))) / (1 + 3%:R * 1 + 1 * (g M - 1 + 3%:R * (g t - 1))) = - (4%:R / 3%:R) /\
  (g M * t + 3%:R * g t * M) / G = - 2%:R.
Proof.
move=> t0 t1; have eG : G = (3%:R * t - 4%:R) ^+ 2 / (2%:R * (1 - 2%:R * t)) by rewrite /G /g /M; field; rewrite ?t0 ?pnatr_eq0.
have G0 : G != 0 by rewrite eG !mulf_neq0 ?invr_eq0 ?mulf_neq0 ?expf_neq0 ?pnatr_eq0.
have -> : 1 + 3%:R * 1 + 1 * (g M - 1 + 3%:R * (g t - 1)) = G by rewrite /G; ring.
split; apply: (mulIf G0); rewrite divfK // eG /g /L /M; field; by rewrite ?t0 ?pnatr_eq0.
Qed.
End Example.
