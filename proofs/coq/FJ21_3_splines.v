(* FJ21, Theorem 3.2: splines, where every piece has its own Lam, M, sigma. *)
From mathcomp Require Import all_ssreflect all_algebra ring zify.
From Torse Require Import Blossom Curves Points Functions FJ21_2 FJ21_3_theorem FJ21_3_needs FJ21_4.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Import GRing.Theory.
Local Open Scope ring_scope.

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
    Hypotheses: the weights do not vanish identically on the piece. *)
Theorem FJ21_T3_2_developable n u (c d : nat -> 'rV[F]_4) L M s k (p := pcurve n (drop_ k u) (drop_ k c)) (q := pcurve n (drop_ k u) (drop_ k d)) :
  weight p != 0 -> weight q != 0 -> frelated n p q L M s -> rational_developable p q.
Proof. exact: FJ21_T3_1_developable. Qed.

Lemma pcurve1 m u (c : nat -> 'rV[F]_m) : u 1%N - u 0%N = 1 ->
  pcurve 1 u c = ((u 1%N)%:P - 'X) *: map_mx polyC (c 0%N) + ('X - (u 0%N)%:P) *: map_mx polyC (c 1%N).
Proof.
move=> e; apply/rowP=> k; rewrite !mxE /curve /= /step /polys /coord /= !mul1r add0n.
by rewrite -polyCB e polyC1 divr1.
Qed.

Lemma no_common_triple (E : fieldType) (T L M s : E) :
  1 + (L - T) * 0 = s * (1 + (M - T) * 0) -> 0 + (L - T) * 0 = s * (1 + T + (M - T) * 1) ->
  T + (L - T) * 1 = s * (0 + (M - T) * 0) -> T - 1 + (L - T) * 1 = s * (T - 1 + (M - T) * 1) -> False.
Proof.
rewrite !mulr0 !addr0 !mulr1 mulr0 => <-; rewrite !mul1r => h2 g1 g3; have /eqP := oner_neq0 E; apply.
transitivity (1 + T + (M - T) - (T - 1 + (M - T)) + (T - 1 + (L - T)) - (T + (L - T))); first by ring.
by rewrite -h2 g1 g3 sub0r addNr subr0.
Qed.

Let phi : {rmorphism F -> K} := [rmorphism of @FracField.tofrac [idomainType of {poly F}] \o @polyC F].

Lemma ftangent1 m u (c : nat -> 'rV[F]_m) L (k : 'I_m) : u 1%N - u 0%N = 1 ->
  ftangent 1 (pcurve 1 u c) L 0 k = (phi (u 1%N) - L) * phi (c 0%N 0 k) + (L - phi (u 0%N)) * phi (c 1%N 0 k).
Proof.
move=> e; rewrite /ftangent pcurve1 // !mxE divr1 !(derivD, derivN, derivM, derivC, derivX) !(tofracD, tofracN, tofracM) !tofrac0 tofrac1 /phi /=.
exact: tangent_of_line.
Qed.

(** FJ21.T3.2.pieces example: $n=1$, the knots $0,1,2$, the rows $(1,0,0,0),(1,1,0,2),(2,3,1,0)$ and $(1,0,1,1),\frac1{10}(9,3,8,14),\frac1{20}(-13,-61,-6,82)$:
    $\Lambda,M,\sigma$ are $3,5,2$ on the first piece and $4,-1,1$ on the second, and nothing else.
    Hypotheses: $70\ne0$ in the field, as in characteristic 0. *)
Theorem FJ21_T3_2_pieces_example (u := fun i => i%:R : F)
    (c := nth (0 : 'rV[F]_4) [:: row4 1 0 0 0; row4 1 1 0 2%:R; row4 2%:R 3%:R 1 0])
    (d := nth (0 : 'rV[F]_4) [:: row4 1 0 1 1; 10%:R^-1 *: row4 9%:R 3%:R 8%:R 14%:R; 20%:R^-1 *: row4 (- 13%:R) (- 61%:R) (- 6%:R) 82%:R])
    (p := fun k => pcurve 1 (drop_ k u) (drop_ k c)) (q := fun k => pcurve 1 (drop_ k u) (drop_ k d)) L M s : 70%:R != 0 :> F ->
  (frelated 1 (p 0%N) (q 0%N) L M s <-> [/\ L = 3%:R, M = 5%:R & s = 2%:R]) /\
  (frelated 1 (p 1%N) (q 1%N) L M s <-> [/\ L = 4%:R, M = -1 & s = 1]).
Proof.
move=> n70; have n10 : 10%:R != 0 :> F by move: n70; rewrite (natrM _ 7 10) mulf_eq0 negb_or => /andP[].
have nK := natrF0 n70; have nK' := natrF0 n10.
have entry k : u k.+1 - u k = 1 -> frelated 1 (p k) (q k) L M s <-> forall h : 'I_4,
    (phi (u k.+1) - L) * phi (c k 0 h) + (L - phi (u k)) * phi (c k.+1 0 h)
    = s * ((phi (u k.+1) - M) * phi (d k 0 h) + (M - phi (u k)) * phi (d k.+1 0 h)).
  have e0 (g : nat -> F) : drop_ k g 0%N = g k by rewrite /drop_ addn0.
  have e1 (g : nat -> F) : drop_ k g 1%N = g k.+1 by rewrite /drop_ addn1.
  have f0 (g : nat -> 'rV[F]_4) : drop_ k g 0%N = g k by rewrite /drop_ addn0.
  have f1 (g : nat -> 'rV[F]_4) : drop_ k g 1%N = g k.+1 by rewrite /drop_ addn1.
  move=> e; rewrite /frelated; split=> [/rowP h i|h]; last apply/rowP=> i; have := h i;
    by rewrite [fun_of_matrix (_ *: _) 0 i]mxE !ftangent1 ?e0 ?e1 ?f0 ?f1.
have four (f g : 'I_4 -> K) : (forall h, f h = g h) <-> [/\ f 0 = g 0, f 1 = g 1, f 2%:R = g 2%:R & f 3%:R = g 3%:R].
  split=> [e|[h0 h1 h2 h3] [[|[|[|[|//]]]] lt_h]]; first by split; apply: e.
  - by rewrite (_ : Ordinal _ = 0) //; apply/val_inj.
  - by rewrite (_ : Ordinal _ = 1) //; apply/val_inj.
  - by rewrite (_ : Ordinal _ = 2%:R) //; apply/val_inj.
  - by rewrite (_ : Ordinal _ = 3%:R) //; apply/val_inj.
have u0 : u 1%N - u 0%N = 1 by rewrite /u subr0.
have u1 : u 2%N - u 1%N = 1 by rewrite /u -natrB.
rewrite !entry //; move: (phi) nK nK' => f nK nK'.
split; rewrite four /u /c /d !mxE /= !(rmorphM, rmorphN, fmorphV, rmorph_nat, rmorph0, rmorph1); [exact: first_cell|exact: second_cell].
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
have e0 : drop_ 0 u 1%N - drop_ 0 u 0%N = 1 by rewrite /drop_ /u subr0.
have e1 : drop_ 1 u 1%N - drop_ 1 u 0%N = 1 by rewrite /drop_ /u -natrB.
have P0 : p 0%N = row4 1 'X 0 0.
  rewrite /p pcurve1 //; apply/rowP=> -[[|[|[|[|//]]]] lt_k]; rewrite !mxE /drop_ /u /= ?polyC1 ?polyC0; ring.
have Q0 : q 0%N = row4 1 0 (1 + 'X) 0.
  rewrite /q pcurve1 //; apply/rowP=> -[[|[|[|[|//]]]] lt_k]; rewrite !mxE /drop_ /u /= ?polyC1 ?polyC0 ?polyC_natr; ring.
have P1 : p 1%N = row4 1 'X 0 ('X - 1).
  rewrite /p pcurve1 //; apply/rowP=> -[[|[|[|[|//]]]] lt_k]; rewrite !mxE /drop_ /u /= ?polyC1 ?polyC0; ring.
have Q1 : q 1%N = row4 1 0 ('X *+ 2) ('X - 1).
  rewrite /q pcurve1 //; apply/rowP=> -[[|[|[|[|//]]]] lt_k]; rewrite !mxE /drop_ /u /= ?polyC1 ?polyC0; ring.
have entry (a b : 'rV[{poly F}]_4) L M s : frelated 1 a b L M s <-> forall k : 'I_4,
    (a 0 k)%:F + (L - 'X%:F) * ((a 0 k)^`())%:F = s * ((b 0 k)%:F + (M - 'X%:F) * ((b 0 k)^`())%:F).
  by split=> [/rowP e k|e]; [have := e k | apply/rowP=> k; have := e k]; rewrite !mxE !divr1.
have D : [/\ deriv ('X : {poly F}) = 1, deriv ('X - 1 : {poly F}) = 1, deriv (1 + 'X : {poly F}) = 1, deriv ('X *+ 2 : {poly F}) = 1 *+ 2
    & deriv (1 : {poly F}) = 0 /\ deriv (0 : {poly F}) = 0].
  by rewrite !(derivD, derivN, derivMn, derivX, derivC) subr0 add0r.
case: D => D1 D2 D3 D4 [D5 D6]; rewrite P0 Q0 P1 Q1; have simp := (mulr0, mul0r, addr0, add0r, mul1r, mulr1, sub0r, subrr).
split.
- apply/entry=> -[[|[|[|[|//]]]] lt_k]; rewrite !mxE /= ?D1 ?D3 ?D5 ?D6 ?tofracD ?tofrac1 ?tofrac0; move: ('X%:F) => T; rewrite !simp //.
  by rewrite addrACA !subrr addr0.
- apply/entry=> -[[|[|[|[|//]]]] lt_k]; rewrite !mxE /= ?D1 ?D2 ?D4 ?D5 ?D6 ?tofracB ?tofracMn ?tofrac1 ?tofrac0; move: ('X%:F) => T; rewrite !simp //.
  by rewrite mulrnAr mulr1 mulNrn subrr.
move=> L M s [/entry h /entry g].
have := (h 0, h 2%:R, g 1, g 3%:R); rewrite !mxE /= ?D1 ?D2 ?D3 ?D5 ?D6 ?tofracD ?tofracN ?tofrac1 ?tofrac0.
move: ('X%:F) => T -[[[s1 h2] g1] g3].
exact: no_common_triple s1 h2 g1 g3.
Qed.
End Splines.
