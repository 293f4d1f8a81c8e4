(* BZZ19, the mapping: what happens without the hypotheses of the theorems on its range, its ends and its monotony, one counterexample each. *)
From Torse Require Import Prelude Blossom Curves Bezier BZZ19_3 BZZ19_3_range BZZ19_3_pieces Needs_blossoms Needs_BZZ19.
From mathcomp Require Import order ssrnum.
Import Order.TTheory Num.Theory.

Lemma quadratic (F : fieldType) (u b : nat -> F) t : span 2 u -> (curve 2 u b).[t] =
  ((u 2%N - t) * (((u 2%N - t) * b 0%N + (t - u 0%N) * b 1%N) / (u 2%N - u 0%N))
    + (t - u 1%N) * (((u 3%N - t) * b 1%N + (t - u 1%N) * b 2%N) / (u 3%N - u 1%N))) / (u 2%N - u 1%N).
Proof. by move=> sp; rewrite horner_curve //= /step /shift /= !mul1r. Qed.

Section Needs.
Variable F : realFieldType.
Implicit Types (u b : nat -> F) (t : F).

(** BZZ19.3 range_needs_within: off the piece: $0,0,1$ on $[0,1]$ give $\sigma=t^2$, and $\sigma(2)=4$. *)
Theorem BZZ19_3_range_needs_within (b := @listed F [:: 0; 0; 1]) : (forall i, (i <= 2)%N -> 0 <= b i <= 1) /\
  (curve 2 (step01 F 2) b).[2%:R] = 4%:R.
Proof.
split; last by rewrite square hornerXn -natrX.
by move=> [|[|[|//]]] _; rewrite /b /listed /= ?lexx ?ler01.
Qed.

(** BZZ19.3 ends_needs_multiplicity: on the simple knots $-1,0,1,2$ the coefficients $0,1,1$ give $\sigma(0)=\frac12\ne\beta_0$. *)
Theorem BZZ19_3_ends_needs_multiplicity (u := @listed F [:: -1; 0; 1; 2%:R]) (b := @listed F [:: 0; 1; 1]) :
  span 2 u /\ (curve 2 u b).[0] = 2%:R^-1.
Proof.
have sp : span 2 u.
  move=> i j lt_i /andP[le_j le_ij]; rewrite unitfE; have : i = 0%N /\ (j = 2 \/ j = 3)%N \/ i = 1%N /\ (j = 2 \/ j = 3)%N by lia.
  case=> [[-> [] ej]|[-> [] ej]]; rewrite ej ?/u /listed /= ?subr0 ?oner_eq0 ?pnatr_eq0 // opprK -[1]/(1%:R) -natrD pnatr_eq0 //.
split=> //; rewrite quadratic // /u /b /listed /=; by field.
Qed.

(** BZZ19.3 joint_needs_degree: in degree 0 every piece is its own constant. *)
Theorem BZZ19_3_joint_needs_degree u b t : (curve 0 u b).[t] = b 0%N /\ (curve 0 (shift u) (shift b)).[t] = b 1%N.
Proof. by rewrite /curve /= /polys !hornerC. Qed.

(** BZZ19.5 spline_needs_sorted: over the knots $3,0,1,2$ the coefficients $0,1,1$ give $\sigma(0)=\frac32$ and $\sigma(1)=1$ on the piece $[0,1]$. *)
Theorem BZZ19_5_spline_needs_sorted (u := @listed F [:: 3%:R; 0; 1; 2%:R]) (b := @listed F [:: 0; 1; 1]) :
  [/\ on_piece 2 u 0 0 /\ on_piece 2 u 0 1, (forall i, (i < 2)%N -> b i <= b i.+1), (mapping 2 u b 0).[0] = 3%:R / 2%:R & (mapping 2 u b 0).[1] = 1].
Proof.
have sp : span 2 u.
  move=> i j lt_i /andP[le_j le_ij]; rewrite unitfE; have : i = 0%N /\ (j = 2 \/ j = 3)%N \/ i = 1%N /\ (j = 2 \/ j = 3)%N by lia.
  case=> [[-> [] ej]|[-> [] ej]]; rewrite ej ?/u /listed /= ?subr0 ?oner_eq0 ?pnatr_eq0 // subr_eq0 ?(eq_sym 1) ?eqr_nat // -[1]/(1%:R) eqr_nat //.
split.
- by rewrite /on_piece /u /listed /= ltr01 !lexx ler01.
- by case=> [|[|//]] _; rewrite /b /listed /= ?ler01 ?lexx.
- by rewrite /mapping -[drop_ 0 u]/u quadratic // /drop_ /u /b /listed /=; field.
by rewrite /mapping -[drop_ 0 u]/u quadratic // /drop_ /u /b /listed /=; field.
Qed.

(** BZZ19.5 spline_needs_first: at a knot of multiplicity $d+1$ the piece after it may have a greater value than the one before it: $d=1$, knots $0,1,1,2$,
    coefficients $0,0,1,1$, $s=t=1$ with $s$ on the later piece. *)
Theorem BZZ19_5_spline_needs_first (u := @listed F [:: 0; 1; 1; 2%:R]) (b := @listed F [:: 0; 0; 1; 1]) :
  [/\ on_piece 1 u 2 1, on_piece 1 u 0 1, (mapping 1 u b 2).[1] = 1 & (mapping 1 u b 0).[1] = 0].
Proof.
have e1 : 2%:R - 1 = 1 :> F by rewrite mulr2n addrK.
have s0 : span 1 (drop_ 0 u) by move=> [|//] j _ /andP[h1 h2]; rewrite (_ : j = 1%N); [rewrite /drop_ /u /= subr0 unitr1 | lia].
have s2 : span 1 (drop_ 2 u).
  by move=> [|//] j _ /andP[h1 h2]; rewrite (_ : j = 1%N); [rewrite /drop_ /u /= e1 unitr1 | lia].
split; rewrite /on_piece /u /listed /= ?lexx ?ltr1n ?ler1n ?ltr01 ?ler01 //.
  by rewrite /mapping horner_curve // /= /step /drop_ /u /b /listed /= !mul1r e1 subrr mul0r addr0 mulr1 divr1.
by rewrite /mapping horner_curve // /= /step /drop_ /u /b /listed /= !mul1r !mulr0 addr0 mul0r.
Qed.
End Needs.

(** BZZ19.3 onto_needs_closed: over the rational numbers $\sigma=t^2$ on $[0,1]$ takes no value 2 between $\sigma(0)=0$ and $\sigma(2)=4$. *)
Theorem BZZ19_3_onto_needs_closed (sigma := curve 2 (step01 _ 2) (listed [:: 0; 0; 1 : rat])) :
  [/\ sigma.[0] = 0, sigma.[2%:R] = 4%:R & forall x, sigma.[x] <> 2%:R].
Proof.
rewrite /sigma square; split=> [||x]; rewrite hornerXn ?expr0n -?natrX //.
by apply/eqP; exact: no_root.
Qed.
