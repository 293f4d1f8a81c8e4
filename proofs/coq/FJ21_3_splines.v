(* FJ21, Theorem 3.2: splines, where every piece has its own Lam, M, sigma. *)
From mathcomp Require Import all_ssreflect all_algebra ring zify.
From Torse Require Import Blossom Curves Points Functions FJ21_2 FJ21_3_theorem FJ21_3_needs.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Import GRing.Theory.
Local Open Scope ring_scope.

Section Splines.
Variable F : fieldType.
Notation K := {fraction {poly F}}.
Notation "x %:F" := (@FracField.tofrac [idomainType of {poly F}] x).
Implicit Types (u : nat -> F) (n N k : nat) (L M s : K).

(** FJ21.T3.2 pieces: on every piece of a spline that is not empty there are rational $\Lambda_k,M_k,\sigma_k\ne0$ with
    $p[t^{\langle n-1\rangle},\Lambda_k]=\sigma_kq[t^{\langle n-1\rangle},M_k]$ iff on every such piece $p$ is a combination of $p',q,q'$ and $q$ one of $q',p,p'$.
    Hypotheses: $n\ne0$ in the field.
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
