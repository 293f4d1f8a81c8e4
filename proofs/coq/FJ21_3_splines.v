(* FJ21, Theorem 3.2: splines, where every piece has its own Lam, M, sigma. *)
From Torse Require Import Prelude Blossom Curves Points Functions FJ21_2 FJ21_3_theorem FJ21_3_needs FJ21_4.

(* The two cells of an example, as equations for Lam, M, sigma. *)
Lemma first_cell (E : fieldType) (L M s : E) (a := 10%:R^-1 : E) : 10%:R != 0 :> E ->
  [/\ (1 - L) * 1 + (L - 0) * 1 = s * ((1 - M) * 1 + (M - 0) * (a * 9%:R)), (1 - L) * 0 + (L - 0) * 1 = s * ((1 - M) * 0 + (M - 0) * (a * 3%:R)),
      (1 - L) * 0 + (L - 0) * 0 = s * ((1 - M) * 1 + (M - 0) * (a * 8%:R)) & (1 - L) * 0 + (L - 0) * 2%:R = s * ((1 - M) * 1 + (M - 0) * (a * 14%:R))]
  <-> [/\ L = 3%:R, M = 5%:R & s = 2%:R].
Proof.
rewrite /a => n10; have [n2 n5] : 2%:R != 0 :> E /\ 5%:R != 0 :> E.
  by apply/andP; rewrite -negb_or -mulf_eq0 -natrM.
split=> [[e0 e1 e2 _]|[-> -> ->]]; last by split; field.
have y1 : s * M = 10%:R * (s - 1) by apply: (by_multiple (z := 10%:R) e0); field.
have y2 : s * M = 5%:R * s by apply: (by_multiple (z := 5%:R) e2); field.
have s2 : s = 2%:R by apply: (mulfI n5); apply: (by_multiple (z := 1) (etrans (esym y1) y2)); ring.
have M5 : M = 5%:R by apply: (mulfI n2); move: y2; rewrite s2 => ->; ring.
by split=> //; apply: (by_multiple (z := 1) e1); rewrite s2 M5; field.
Qed.

Lemma tangent_of_line (E : fieldType) (t v w x y L : E) :
  (w - t) * x + (t - v) * y + (L - t) * ((0 - 1) * x + (w - t) * 0 + ((1 - 0) * y + (t - v) * 0)) = (w - L) * x + (L - v) * y.
Proof. by ring. Qed.

Lemma second_cell (E : fieldType) (L M s : E) (a := 10%:R^-1 : E) (b := 20%:R^-1 : E) : 70%:R != 0 :> E ->
  [/\ (2%:R - L) * 1 + (L - 1) * 2%:R = s * ((2%:R - M) * (a * 9%:R) + (M - 1) * (b * - 13%:R)),
      (2%:R - L) * 1 + (L - 1) * 3%:R = s * ((2%:R - M) * (a * 3%:R) + (M - 1) * (b * - 61%:R)),
      (2%:R - L) * 0 + (L - 1) * 1 = s * ((2%:R - M) * (a * 8%:R) + (M - 1) * (b * - 6%:R))
    & (2%:R - L) * 2%:R + (L - 1) * 0 = s * ((2%:R - M) * (a * 14%:R) + (M - 1) * (b * 82%:R))]
  <-> [/\ L = 4%:R, M = -1 & s = 1].
Proof.
rewrite /a /b => n70; have [n7 n10] : 7%:R != 0 :> E /\ 10%:R != 0 :> E by apply/andP; rewrite -negb_or -mulf_eq0 -natrM.
have n2 : 2%:R != 0 :> E by move: n10; rewrite (natrM _ 2 5) mulf_eq0 negb_or => /andP[].
have n20 : 20%:R != 0 :> E by rewrite (natrM _ 2 10) mulf_neq0.
have n80 : 80%:R != 0 :> E by rewrite (natrM _ 4 20) (natrM _ 2 2) !mulf_neq0.
split=> [[e0 _ e2 e3]|[-> -> ->]]; last by split; field; rewrite n10 n20.
pose x := s * (2%:R - M); pose y := s * (M - 1).
have f0 : 20%:R * L = 18%:R * x - 13%:R * y by apply: (by_multiple (z := 20%:R) e0); rewrite /x /y; field; rewrite n10 n20.
have f2 : 20%:R * L = 20%:R + 16%:R * x - 6%:R * y by apply: (by_multiple (z := 20%:R) e2); rewrite /x /y; field; rewrite n10 n20.
have f3 : 80%:R - 40%:R * L = 28%:R * x + 82%:R * y by apply: (by_multiple (z := 20%:R) e3); rewrite /x /y; field; rewrite n10 n20.
have h1 : 2%:R * x - 7%:R * y = 20%:R by apply: (by_multiple (z := 1) (etrans (esym f0) f2)); ring.
have h2 : 64%:R * x + 56%:R * y = 80%:R.
  have g3 : 80%:R - 2%:R * (20%:R * L) = 28%:R * x + 82%:R * y by apply: (by_multiple (z := 1) f3); ring.
  by apply: (by_multiple (z := -1) g3); rewrite f0; ring.
have x3 : x = 3%:R.
  have g1 : 80%:R * x - 8%:R * (2%:R * x - 7%:R * y) = 80%:R by apply: (by_multiple (z := 1) h2); ring.
  by apply: (mulfI n80); apply: (by_multiple (z := 1) g1); rewrite h1; ring.
have y2 : y = - 2%:R by apply: (mulfI n7); apply: (by_multiple (z := -1) h1); rewrite x3; ring.
have sE : s = x + y by rewrite /x /y; ring.
have s1 : s = 1 by rewrite sE x3 y2; ring.
split=> //; last by move: y2; rewrite /y s1 mul1r => /(canRL (subrK _)) ->; ring.
by apply: (mulfI n20); rewrite f0 x3 y2; ring.
Qed.

(* The equations of the other example have no common solution. *)
Lemma no_common_triple (E : fieldType) (L M s : E) :
  (1 - L) * 1 + (L - 0) * 1 = s * ((1 - M) * 1 + (M - 0) * 1) -> (1 - L) * 0 + (L - 0) * 0 = s * ((1 - M) * 1 + (M - 0) * 2%:R) ->
  (2%:R - L) * 1 + (L - 1) * 2%:R = s * ((2%:R - M) * 0 + (M - 1) * 0) ->
  (2%:R - L) * 0 + (L - 1) * 1 = s * ((2%:R - M) * 0 + (M - 1) * 1) -> False.
Proof.
move=> h0 h2 l1 g3; have /eqP := oner_neq0 E; apply; have s1 : s = 1 by apply: (by_multiple (z := -1) h0); ring.
move: h2 l1 g3; rewrite s1 => h2 l1 g3.
by apply: (by_multiple (z := -1) (congr2 (fun x y => x + y) (congr2 (fun x y => x - y) l1 g3) h2)); ring.
Qed.

Lemma row4_nth (R : ringType) (a b c d : R) h : row4 a b c d 0 h = nth 0 [:: a; b; c; d] h.
Proof. by rewrite mxE. Qed.

Lemma row4Z (R : ringType) (x a b c d : R) : x *: row4 a b c d = row4 (x * a) (x * b) (x * c) (x * d).
Proof. by apply/rowP=> -[[|[|[|[|//]]]] lt_k]; rewrite !mxE. Qed.

(* In degree 1 the relation on a piece is an equation of numbers for each coordinate; the field of the functions has the numbers f x. *)
Notation cells f u c d k L M s := (let e (h : 'I_4) := (f (u k.+1) - L) * f (c k 0 h) + (L - f (u k)) * f (c k.+1 0 h)
  = s * ((f (u k.+1) - M) * f (d k 0 h) + (M - f (u k)) * f (d k.+1 0 h)) in [/\ e 0, e 1, e 2%:R & e 3%:R]).

Section Examples.
Variables (F E : fieldType) (f : {rmorphism F -> E}).
Implicit Types L M s : E.
Let u i : F := i%:R.
Let c := nth (0 : 'rV[F]_4) [:: row4 1 0 0 0; row4 1 1 0 2%:R; row4 2%:R 3%:R 1 0].
Let d := nth (0 : 'rV[F]_4) [:: row4 1 0 1 1; 10%:R^-1 *: row4 9%:R 3%:R 8%:R 14%:R; 20%:R^-1 *: row4 (- 13%:R) (- 61%:R) (- 6%:R) 82%:R].

(* f of numbers; the structures are found once here and not at every place. *)
Let f0 : f 0 = 0 := rmorph0 f.
Let f1 : f 1 = 1 := rmorph1 f.
Let fn k : f k%:R = k%:R := rmorph_nat f k.
Let fN x : f (- x) = - f x := rmorphN f x.
Let fM x y : f (x * y) = f x * f y := rmorphM f x y.
Let fV x : f x^-1 = (f x)^-1 := fmorphV f x.
Let fE := (fM, fN, fV, fn, f0, f1).

Lemma cells_rows (c' d' : nat -> 'rV[F]_4) k L M s p0 p1 p2 p3 q0 q1 q2 q3 r0 r1 r2 r3 t0 t1 t2 t3 :
  c' k = row4 p0 p1 p2 p3 -> c' k.+1 = row4 q0 q1 q2 q3 -> d' k = row4 r0 r1 r2 r3 -> d' k.+1 = row4 t0 t1 t2 t3 -> cells f u c' d' k L M s <->
  [/\ (f (u k.+1) - L) * f p0 + (L - f (u k)) * f q0 = s * ((f (u k.+1) - M) * f r0 + (M - f (u k)) * f t0),
      (f (u k.+1) - L) * f p1 + (L - f (u k)) * f q1 = s * ((f (u k.+1) - M) * f r1 + (M - f (u k)) * f t1),
      (f (u k.+1) - L) * f p2 + (L - f (u k)) * f q2 = s * ((f (u k.+1) - M) * f r2 + (M - f (u k)) * f t2)
    & (f (u k.+1) - L) * f p3 + (L - f (u k)) * f q3 = s * ((f (u k.+1) - M) * f r3 + (M - f (u k)) * f t3)].
Proof. by move=> -> -> -> ->; rewrite /= !row4_nth. Qed.

Lemma cells_first L M s : 10%:R != 0 :> F -> cells f u c d 0%N L M s <-> [/\ L = 3%:R, M = 5%:R & s = 2%:R].
Proof.
rewrite -(fmorph_eq0 f) fn => n10; rewrite (cells_rows (c' := c) (d' := d) (k := 0%N) _ _ _ erefl erefl erefl (row4Z _ _ _ _ _)) /u !fE.
exact: first_cell.
Qed.

Lemma cells_second L M s : 70%:R != 0 :> F -> cells f u c d 1%N L M s <-> [/\ L = 4%:R, M = -1 & s = 1].
Proof.
rewrite -(fmorph_eq0 f) fn => n70; rewrite (cells_rows (c' := c) (d' := d) (k := 1%N) _ _ _ erefl erefl (row4Z _ _ _ _ _) (row4Z _ _ _ _ _)) /u !fE.
exact: second_cell.
Qed.

Lemma cells_seven : 7%:R = 0 :> F -> cells f u c d 1%N 2%:R 1 3%:R.
Proof.
move=> /(congr1 f); rewrite f0 fn => n7; apply/(cells_rows (c' := c) (d' := d) (k := 1%N) _ _ _ erefl erefl (row4Z _ _ _ _ _) (row4Z _ _ _ _ _)); rewrite /u !fE.
have n10 : 10%:R != 0 :> E.
  by apply/eqP=> n10; have /eqP := oner_neq0 E; apply; apply: (by_multiple (z := 1) (congr2 (fun x y => 3%:R * x - 2%:R * y) n7 n10)); ring.
by rewrite !subrr !mul0r !addr0 !add0r; split; apply: (mulfI n10); [apply: (by_multiple (z := -1) n7) | apply: (by_multiple (z := 3%:R) n7) | apply: (by_multiple (z := - 2%:R) n7) | apply: (by_multiple (z := - 6%:R) n7)];
  field; exact: n10.
Qed.

Let a := nth (0 : 'rV[F]_4) [:: row4 1 0 0 0; row4 1 1 0 0; row4 1 2%:R 0 1].
Let b := nth (0 : 'rV[F]_4) [:: row4 1 0 1 0; row4 1 0 2%:R 0; row4 1 0 4%:R 1].

Lemma cells_pieces : [/\ cells f u a b 0%N 0 (-1) 1, cells f u a b 1%N 0 0 1
  & forall L M s, ~ (cells f u a b 0%N L M s /\ cells f u a b 1%N L M s)].
Proof.
pose rows k := @cells_rows a b k; split=> [||L M s [/(rows 0%N _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ erefl erefl erefl erefl) h
    /(rows 1%N _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ erefl erefl erefl erefl)]].
- by apply/(rows 0%N _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ erefl erefl erefl erefl); rewrite /u !fE; split; ring.
- by apply/(rows 1%N _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ erefl erefl erefl erefl); rewrite /u !fE; split; ring.
by move: h; rewrite /u !fE => -[s1 _ h2 _] [_ l1 _ g3]; exact: no_common_triple s1 h2 l1 g3.
Qed.
End Examples.

Section Splines.
Variable F : fieldType.
Notation K := {fraction {poly F}}.
Notation "x %:F" := (@FracField.tofrac [idomainType of {poly F}] x).
Implicit Types (u : nat -> F) (n N k : nat) (L M s : K).

(** FJ21.T3.2 pieces: on every piece of a spline that is not empty there are rational $\Lambda_k,M_k,\sigma_k\ne0$ with
    $p[t^{\langle n-1\rangle},\Lambda_k]=\sigma_kq[t^{\langle n-1\rangle},M_k]$ iff on every such piece $p$ is a combination of $p',q,q'$ and $q$ one of $q',p,p'$.
    Hypotheses: $n\ne0$ in the field: where $n=0$, so that $p'=q'=0$, $p+\frac{\Lambda-t}np'$ has no meaning; with $x/0=0$
    it would be $p$, and both sides would say $p=\sigma_kq$, $\sigma_k\ne0$.
    Paper: asks for one triple of functions on the whole spline. *)
Theorem FJ21_T3_2_pieces m n N u (c d : nat -> 'rV[F]_m) (p := fun k => pcurve n (drop_ k u) (drop_ k c)) (q := fun k => pcurve n (drop_ k u) (drop_ k d)) :
  n%:R != 0 :> F ->
  (forall k, (k < N)%N -> span n (drop_ k u) -> exists L M s, s != 0 /\ frelated n (p k) (q k) L M s) <->
  (forall k, (k < N)%N -> span n (drop_ k u) ->
    spanned (pfun (p k)) (pfun (pderiv (p k))) (pfun (q k)) (pfun (pderiv (q k))) /\
    spanned (pfun (q k)) (pfun (pderiv (q k))) (pfun (p k)) (pfun (pderiv (p k)))).
Proof.
move=> n0; split=> h k lt_k sp; have e := FJ21_T3_1_exact (p k) (q k) n0.
  exact: (iffLR e (h k lt_k sp)).
exact: (iffRL e (h k lt_k sp)).
Qed.

(** FJ21.T3.2 developable: one triple $\Lambda,M,\sigma$ of rational functions on the whole spline makes every piece developable.
    Hypotheses: the weights do not vanish identically on the piece, so that $c$, $d$ have a meaning. *)
Theorem FJ21_T3_2_developable n u (c d : nat -> 'rV[F]_4) L M s k (p := pcurve n (drop_ k u) (drop_ k c)) (q := pcurve n (drop_ k u) (drop_ k d)) :
  weight p != 0 -> weight q != 0 -> frelated n p q L M s -> rational_developable p q.
Proof. exact: FJ21_T3_1_developable. Qed.

Lemma pcurve1 m u (c : nat -> 'rV[F]_m) : u 1%N - u 0%N = 1 ->
  pcurve 1 u c = ((u 1%N)%:P - 'X) *: map_mx polyC (c 0%N) + ('X - (u 0%N)%:P) *: map_mx polyC (c 1%N).
Proof.
move=> e; apply/rowP=> k; rewrite !mxE /curve /= /step /polys /coord /= !mul1r add0n.
by rewrite -polyCB e polyC1 divr1.
Qed.

Let phi : {rmorphism F -> K} := [rmorphism of @FracField.tofrac [idomainType of {poly F}] \o @polyC F].

Lemma ftangent1 m u (c : nat -> 'rV[F]_m) L (k : 'I_m) : u 1%N - u 0%N = 1 ->
  ftangent 1 (pcurve 1 u c) L 0 k = (phi (u 1%N) - L) * phi (c 0%N 0 k) + (L - phi (u 0%N)) * phi (c 1%N 0 k).
Proof.
move=> e; rewrite /ftangent pcurve1 // !mxE divr1 !(derivD, derivN, derivM, derivC, derivX) !(tofracD, tofracN, tofracM) !tofrac0 tofrac1 /phi /=.
exact: tangent_of_line.
Qed.

Lemma cellsP : exists f : {rmorphism F -> K}, forall u (c d : nat -> 'rV[F]_4) k L M s, u k.+1 - u k = 1 ->
  frelated 1 (pcurve 1 (drop_ k u) (drop_ k c)) (pcurve 1 (drop_ k u) (drop_ k d)) L M s <-> cells f u c d k L M s.
Proof.
exists phi => u c d k L M s uk; set e := (fun h : 'I_4 => _ = _ :> K).
have at0 (T : Type) (g : nat -> T) : drop_ k g 0%N = g k by rewrite /drop_ addn0.
have at1 (T : Type) (g : nat -> T) : drop_ k g 1%N = g k.+1 by rewrite /drop_ addn1.
have eE h : e h <-> ftangent 1 (pcurve 1 (drop_ k u) (drop_ k c)) L 0 h
    = s * ftangent 1 (pcurve 1 (drop_ k u) (drop_ k d)) M 0 h.
  by rewrite /e !ftangent1 !at0 !at1.
have {}eE h : e h <-> ftangent 1 (pcurve 1 (drop_ k u) (drop_ k c)) L 0 h
    = (s *: ftangent 1 (pcurve 1 (drop_ k u) (drop_ k d)) M) 0 h.
  by rewrite eE [X in _ <-> _ = X]mxE.
rewrite /frelated; split=> [r|[h0 h1 h2 h3]]; first by split; apply/eE; rewrite r.
apply/rowP=> -[[|[|[|[|//]]]] lt_h]; apply/eE.
- by rewrite (_ : Ordinal _ = 0) //; apply/val_inj.
- by rewrite (_ : Ordinal _ = 1) //; apply/val_inj.
- by rewrite (_ : Ordinal _ = 2%:R) //; apply/val_inj.
- by rewrite (_ : Ordinal _ = 3%:R) //; apply/val_inj.
Qed.

(** FJ21.T3.2.pieces example: $n=1$, the knots $0,1,2$, the rows $(1,0,0,0),(1,1,0,2),(2,3,1,0)$ and $(1,0,1,1),\frac1{10}(9,3,8,14),\frac1{20}(-13,-61,-6,82)$:
    $\Lambda,M,\sigma$ are $3,5,2$ on the first piece and $4,-1,1$ on the second, and nothing else.
    Hypotheses: $70\ne0$ in the field, as in characteristic 0, so that the rows have a meaning, for 10, and for the last claim, for 7. *)
Theorem FJ21_T3_2_pieces_example (u := fun i => i%:R : F)
    (c := nth (0 : 'rV[F]_4) [:: row4 1 0 0 0; row4 1 1 0 2%:R; row4 2%:R 3%:R 1 0])
    (d := nth (0 : 'rV[F]_4) [:: row4 1 0 1 1; 10%:R^-1 *: row4 9%:R 3%:R 8%:R 14%:R; 20%:R^-1 *: row4 (- 13%:R) (- 61%:R) (- 6%:R) 82%:R])
    (p := fun k => pcurve 1 (drop_ k u) (drop_ k c)) (q := fun k => pcurve 1 (drop_ k u) (drop_ k d)) L M s : 70%:R != 0 :> F ->
  (frelated 1 (p 0%N) (q 0%N) L M s <-> [/\ L = 3%:R, M = 5%:R & s = 2%:R]) /\
  (frelated 1 (p 1%N) (q 1%N) L M s <-> [/\ L = 4%:R, M = -1 & s = 1]).
Proof.
move=> n70; have n10 : 10%:R != 0 :> F by move: n70; rewrite (natrM _ 7 10) mulf_eq0 negb_or => /andP[].
have [u0 u1] : u 1%N - u 0%N = 1 /\ u 2%N - u 1%N = 1 by rewrite /u subr0 -natrB.
have [f e] := cellsP; split; first exact: iff_trans (e u c d 0%N L M s u0) (cells_first f L M s n10).
exact: iff_trans (e u c d 1%N L M s u1) (cells_second f L M s n70).
Qed.

(** FJ21.T3.2.pieces example_needs_seven: in characteristic 7 the second piece has other triples too, such as $2,1,3$.
    Hypotheses: $7=0$ in the field. *)
Theorem FJ21_T3_2_pieces_example_needs_seven (u := fun i => i%:R : F)
    (c := nth (0 : 'rV[F]_4) [:: row4 1 0 0 0; row4 1 1 0 2%:R; row4 2%:R 3%:R 1 0])
    (d := nth (0 : 'rV[F]_4) [:: row4 1 0 1 1; 10%:R^-1 *: row4 9%:R 3%:R 8%:R 14%:R; 20%:R^-1 *: row4 (- 13%:R) (- 61%:R) (- 6%:R) 82%:R]) : 7%:R = 0 :> F ->
  frelated 1 (pcurve 1 (drop_ 1 u) (drop_ 1 c)) (pcurve 1 (drop_ 1 u) (drop_ 1 d)) 2%:R 1 3%:R.
Proof.
have u1 : u 2%N - u 1%N = 1 by rewrite /u -natrB.
by have [f e] := cellsP => n7; exact/(e u c d 1%N _ _ _ u1)/cells_seven.
Qed.

(** FJ21.T3.2 needs_pieces: one triple for the whole spline is not necessary: for $n=1$ on the knots $0,1,2$ the rows
    $(1,0,0,0),(1,1,0,0),(1,2,0,1)$ and $(1,0,1,0),(1,0,2,0),(1,0,4,1)$ are developable on both pieces, with $\Lambda=0$, $\sigma=1$ and $M=-1$ on the first, $M=0$
    on the second, and no triple serves both. *)
Theorem FJ21_T3_2_needs_pieces (u := fun i => i%:R : F)
    (c := nth (0 : 'rV[F]_4) [:: row4 1 0 0 0; row4 1 1 0 0; row4 1 2%:R 0 1]) (d := nth (0 : 'rV[F]_4) [:: row4 1 0 1 0; row4 1 0 2%:R 0; row4 1 0 4%:R 1])
    (p := fun k => pcurve 1 (drop_ k u) (drop_ k c)) (q := fun k => pcurve 1 (drop_ k u) (drop_ k d)) :
  [/\ frelated 1 (p 0%N) (q 0%N) 0 (-1) 1, frelated 1 (p 1%N) (q 1%N) 0 0 1
    & forall L M s, ~ (frelated 1 (p 0%N) (q 0%N) L M s /\ frelated 1 (p 1%N) (q 1%N) L M s)].
Proof.
have [u0 u1] : u 1%N - u 0%N = 1 /\ u 2%N - u 1%N = 1 by rewrite /u subr0 -natrB.
have [f e] := cellsP; have [e0 e1 none] := cells_pieces f.
split=> [||L M s [/(e u c d 0%N _ _ _ u0) r0 /(e u c d 1%N _ _ _ u1) r1]]; [exact/(e u c d 0%N _ _ _ u0) | exact/(e u c d 1%N _ _ _ u1) | exact: none (conj r0 r1)].
Qed.
End Splines.
