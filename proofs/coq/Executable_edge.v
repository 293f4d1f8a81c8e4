(* Programs: the edge of regression of a Bezier patch as a curve, and the patch on the tangents of a curve, FJ21, section 6.
   Definitions (rows of Bezier points):
     times_program c a b     the rows of (a + b t) c(t), one degree higher
     edge_rows_program p q L M s   the rows of r = ((L - t) p + s (t - M) q) / (L - M)
     patch_program r x       the rows of r + (x - t)/(n+1) r', r of degree n + 1 *)
From Torse Require Import Prelude Blossom Curves Points Bernstein Bezier BZZ19_3 FJ21_4 FJ21_5 FJ21_6_theorem Executable Executable_FJ21.

Section Programs.
Variables (T Q : Type) (K : scalars T) (V : points T Q).
Implicit Types (n i : nat) (c p q r : seq Q) (x L M s a b : T).
Local Notation "x + y" := (sadd K x y).
Local Notation "x - y" := (ssub K x y).
Local Notation "x * y" := (smul K x y).
Local Notation vertex c i := (nth (origin V) c i).

Definition times_program c a b := let n := size c in mkseq (fun i => pscale V (sinv K (of_nat K n))
  (padd V (pscale V (of_nat K (n - i) * a) (vertex c i)) (pscale V (of_nat K i * (a + b)) (vertex c i.-1)))) n.+1.
Definition edge_rows_program p q L M s := given (~~ same K L M) Lambda (
  let o := sinv K (L - M) in let right := s * o in
  let r := times_program p (L * o) (zero K - o) in let r' := times_program q (zero K - M * right) right in
  Value (mkseq (fun i => padd V (vertex r i) (vertex r' i)) (size p).+1)).
Definition patch_program r x := mkseq (fun i => padd V (pscale V (one K - x) (vertex r i)) (pscale V x (vertex r i.+1))) (size r).-1.
End Programs.

Section Equal.
Variables (F : fieldType) (m : nat) (lt : F -> F -> bool).
Implicit Types (n i : nat) (c p q r : seq 'rV[F]_m) (t x L M s a b : F).
Local Notation K := (of_field lt).
Local Notation V := (rows F m).
Local Notation at_list := (nth 0).
Local Notation bezier c := (pbez (size c).-1 (at_list c)).

Lemma times_programE c a b : (size c)%:R != 0 :> F ->
  pbez (size c) (at_list (times_program K V c a b)) = linear a b *: bezier c.
Proof.
case: c => [|z c] nz; first by case/eqP: nz.
rewrite [(size (z :: c)).-1]/=; apply/rowP=> k; rewrite !mxE; set d := z :: c.
have nz' : (size d)%:R%:P != 0 :> {poly F} by rewrite polyC_eq0.
apply: (mulfI nz'); transitivity (a%:P * ((size d)%:R%:P * ((1 - 'X) * bez (size c) (coord (at_list d) k)))
    + (a + b)%:P * ((size d)%:R%:P * ('X * bez (size c) (coord (at_list d) k)))); last first.
  by rewrite /linear -mul_polyC polyCD; move: 'X => X; ring.
rewrite Y_bez X_bez -!bez_scale -bez_add; apply: bez_ext => i le_i; rewrite /coord nth_mkseq // !of_natE /= !mxE /prev.
rewrite mulrA mulfV // mul1r -[(size c).+1]/(size d); move: (at_list d i) (at_list d i.-1) => e h.
by move: (e 0 k) (h 0 k) => *; ring.
Qed.

(** FJ21.6.1 program: the program gives the points of the curve $r=\frac{(\Lambda-t)p+\sigma(t-M)q}{\Lambda-M}$ of degree $n+1$ iff $\Lambda\ne M$.
    Hypotheses: for the curve: as many rows $q$ as $p$; $n+1\ne0$ in the field, so that there is a row. *)
Theorem FJ21_6_1_program p q L M s :
  (L = M -> edge_rows_program K V p q L M s = Fails _ Lambda) /\
  (size q = size p -> (size p)%:R != 0 :> F -> L != M -> exists r, [/\ edge_rows_program K V p q L M s = Value r, size r = (size p).+1 &
    bezier r = ((L - M)^-1)%:P *: ((L%:P - 'X) *: bezier p + (s%:P * ('X - M%:P)) *: bezier q)]).
Proof.
rewrite /edge_rows_program /= /given; split=> [->|sq nz /negPf->]; first by rewrite eqxx.
set r := mkseq _ _; exists r; rewrite size_mkseq; split=> //=; set o := (L - M)^-1.
transitivity (pbez (size p) (at_list (times_program K V p (L * o) (0 - o))) + pbez (size p) (at_list (times_program K V q (0 - M * (s * o)) (s * o)))).
  by rewrite pbez_add; apply: pbez_ext => i le_i; rewrite nth_mkseq.
have eq_q a b : pbez (size p) (at_list (times_program K V q a b)) = linear a b *: bezier q.
  by rewrite -{1}sq times_programE ?sq.
rewrite times_programE // eq_q; apply/rowP=> k; rewrite !mxE /linear -!mul_polyC.
move: (bez _ _) (bez _ _) => x y; rewrite !(polyCB, polyCM) polyC0; move: 'X o%:P L%:P M%:P s%:P => X e l u z; ring.
Qed.

(** FJ21.6.1 edge_program: the curve passes through the edge of regression: $r(t)=\frac E{\Lambda-M}((1-v)p+vq)$, $E=\Lambda-t+\sigma(t-M)$, for the $v$ of
    the program of section 6, wherever both give values.
    Hypotheses: as many rows $q$ as $p$; $n+1\ne0$ in the field, so that there is a row. *)
Theorem FJ21_6_1_edge_program n p q t L M s v x y r : size q = size p -> (size p)%:R != 0 :> F ->
  edge_program K n t L M s = Value [:: v; x; y] -> edge_rows_program K V p q L M s = Value r ->
  ev (bezier r) t = ((L - t + s * (t - M)) / (L - M)) *: ((1 - v) *: ev (bezier p) t + v *: ev (bezier q) t).
Proof.
move=> sq nz; rewrite /edge_program /nonzero /= /given; case: ifP => // e0 [<- _ _] er.
have [fails] := FJ21_6_1_program p q L M s; have [/fails|LM] := eqVneq L M; first by rewrite er.
case/(_ sq nz isT)=> r' [e' _ er']; have -> : r = r' by apply: Value_inj; rewrite -er -e'.
rewrite er'.
have d0 : L - M != 0 by rewrite subr_eq0.
apply/rowP=> k; rewrite !mxE !(hornerM, hornerD, hornerN, hornerC, hornerX); move: (bez _ _).[t] (bez _ _).[t] => a b; by field; rewrite e0 d0.
Qed.

Lemma deriv_bez_low n (c : nat -> F) : (bez n.+1 c)^`() = n.+1%:R *: bez n (fun i => c i.+1 - c i).
Proof.
rewrite -!bezier_curve BZZ19_4_derivative; last exact: span_step01.
rewrite scaler_nat; congr (_ *+ _); rewrite /curve (@blossom_ext_knots _ _ (polys (step01 F n))) //.
by apply: blossom_ext => i; rewrite size_nseq => le_i; rewrite /polys /slope /step01 leq_addl leqNgt ltnS le_i /= subr0 divr1.
Qed.

(** FJ21.T6.1 program: the program gives the points of the patch's boundary $r+\frac{x-t}{n+1}r'$ of degree $n$: those of $p$ for $x=M$, of $q$ for
    $x=\Lambda$.
    Hypotheses: $r$ has $n+2$ rows; $n+1\ne0$ in the field. *)
Theorem FJ21_T6_1_program n r x (z := patch_program K V r x) : size r = n.+2 -> n.+1%:R != 0 :> F ->
  size z = n.+1 /\ pbez n (at_list z) = patch n (bezier r) x.
Proof.
rewrite /z => sr n1; rewrite size_mkseq sr; split=> //; apply/rowP=> k; rewrite !mxE /= deriv_bez_low.
set c := coord (at_list r) k; transitivity (bez n (fun i => (1 - x) * c i + x * c i.+1)).
  by apply: bez_ext => i le_i; rewrite /coord nth_mkseq ?sr //= !mxE.
rewrite -scalerAl -scalerAr scalerA mulVf // scale1r {2}/bez casteljau /bez mulr_sumr -big_split /=.
by apply: eq_big_nat => i _; rewrite !(polyCD, polyCM, polyCB) polyC1; move: 'X (B F n i) => *; ring.
Qed.
End Equal.
