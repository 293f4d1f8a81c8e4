(* FJ07, section 4, over the real numbers: whether there is a surface through the curve with the given end rulings. *)
From Torse Require Import Prelude Blossom Curves Points Bezier FJ07_2_cones FJ07_4.
From mathcomp Require Import order ssrnum.
Import Order.Theory Num.Theory.

Lemma branches_sum (F : fieldType) (u : nat -> F) n (c : nat -> 'rV[F]_3) K v w :
  branches u n c K v w = \sum_(0 <= i < K.+1) triple (c i.+1 - c i) v w *: factor u n K i.
Proof.
rewrite /branches /chord; elim: (index_iota _ _) => [|i r ih].
  by rewrite !big_nil; move: (fixed v) (fixed w) => p q; coordinates; rewrite !mul0r !addr0.
rewrite !big_cons -ih -mul_polyC; move: (\sum_(j <- r) _) (factor u n K i) (c i.+1 - c i) => s f e.
rewrite /fixed; coordinates; rewrite !(polyCD, polyCN, polyCM, polyCB); hide_entries; ring.
Qed.

(** FJ07.20 odd: for skew end rulings and $L-1$ odd the polynomial of (20) has a real root $M_0$: there is a surface, unless all real roots
    are knots.
    Hypotheses: a real closed field; the lines through $c_0$ along $v$ and $c_L$ along $w$ are skew. *)
Theorem FJ07_20_odd (F : rcfType) (u : nat -> F) n (c : nat -> 'rV[F]_3) K v w : odd K -> triple (c K.+1 - c 0%N) v w != 0 ->
  exists M, root (branches u n c K v w) M.
Proof.
move=> oddK skew; have [sz co] := FJ07_20_count u n c K v w; set p := branches u n c K v w in sz co *.
have sp : size p = K.+1.
  by apply/eqP; rewrite eqn_leq sz ltnNge; apply: contra skew => le; rewrite -co nth_default.
have lead : lead_coef p != 0 by rewrite lead_coefE sp /= co.
pose q := (lead_coef p)^-1 *: p; pose q' := - (q \Po (- 'X)).
have sq : size q = K.+1 by rewrite size_scale ?invr_neq0.
have mq : q \is monic by rewrite monicE lead_coefZ mulVf.
have sX : size (- 'X : {poly F}) = 2%N by rewrite size_opp size_polyX.
have mq' : q' \is monic.
  by rewrite monicE lead_coefN lead_coef_comp ?sX // lead_coefN lead_coefX (monicP mq) sq /= mul1r -signr_odd oddK expr1 opprK.
have [a pa] := monic_Cauchy_bound mq; have [b pb] := monic_Cauchy_bound mq'.
pose m := Num.max (Num.max a b) 0.
have le_m : - m <= m by rewrite ge0_cp // /m le_maxr lexx orbT.
have [x _ rx] : exists2 x, - m <= x <= m & root q x.
  apply: poly_ivt => //; apply/andP; split.
    by have := pb m; rewrite !le_maxr lexx orbT /= => /(_ isT); rewrite hornerN horner_comp hornerN hornerX oppr_gt0 => /ltW.
  by apply/ltW/pa; rewrite !le_maxr lexx.
by exists x; rewrite -(rootZ _ _ (invr_neq0 lead)).
Qed.

(** FJ07.20 needs_odd: for $L-1=2$ there may be no surface: cubic Bezier curves with $[\Delta c_0,v,w]=[\Delta c_2,v,w]=1$ and
    $[\Delta c_1,v,w]=0$ have the polynomial $(M-1)^2+M^2$.
    Hypotheses: an ordered field. *)
Theorem FJ07_20_needs_odd (F : realFieldType) (c : nat -> 'rV[F]_3) v w : triple (c 1%N - c 0%N) v w = 1 ->
  triple (c 2%N - c 1%N) v w = 0 -> triple (c 3%N - c 2%N) v w = 1 -> forall M, ~~ root (branches (step01 F 3) 3 c 2 v w) M.
Proof.
move=> e0 e1 e2 M; rewrite branches_sum /factor /index_iota /= !big_cons !big_nil e0 e1 e2 scale0r add0r !addr0 !scale1r.
rewrite /step01 /= rootE !hornerE /= -!expr2 paddr_eq0 ?sqr_ge0 // !sqrf_eq0; apply/negP=> /andP[/eqP a /eqP b].
by move: a; rewrite subr0 in b; rewrite b sub0r; apply/eqP; rewrite oppr_eq0 oner_eq0.
Qed.
