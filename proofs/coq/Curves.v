(* Curves as polynomials, points as row vectors, pieces of splines.
   Definitions:
     drop_ k u         the list u without its first k members: piece k+1 of a spline has the knots drop_ k u
     curve n u c       the polynomial c[X, ..., X], one coordinate; velocity n u c is c[1-direction, X, ..., X], so c' = n velocity
     polys u           the list u as constant polynomials
     step01 n          the knots of a Bezier curve: n zeros, then ones *)
From Torse Require Import Prelude Blossom.

Definition drop_ (T : Type) k (u : nat -> T) i := u (k + i)%N.

Section Morphism.
Variables (R S : comUnitRingType) (f : {rmorphism R -> S}).

Lemma span_morph n (u : nat -> R) : span n u -> span n (f \o u).
Proof. by move=> sp i j lt_i le_j; rewrite /= -rmorphB rmorph_unit // sp. Qed.

Lemma blossom_morph (u c : nat -> R) v : span (size v) u ->
  f (blossom u c v) = blossom (f \o u) (f \o c) [seq (f x.1, f x.2) | x <- v].
Proof.
elim: v u c => [|x v ih] u c //= sp; rewrite ih; last exact: span_shift.
rewrite size_map; apply: blossom_ext => i; rewrite size_map => le_i.
rewrite /step /= rmorphM rmorphV; last by apply: sp; [exact: le_i | rewrite leqnn andbT addnS ltnS leq_addl].
by rewrite rmorphB !(rmorphD, rmorphN, rmorphM).
Qed.
End Morphism.

Section Curve.
Variable F : fieldType.
Implicit Types (u c : nat -> F) (n k : nat).

Definition polys u : nat -> {poly F} := fun i => (u i)%:P.
Definition step01 n i : F := (n <= i)%:R.
Definition curve n u c := blossom (polys u) (polys c) (nseq n (at_ 'X)).
Definition velocity n u c := blossom (polys u) (polys c) (direction _ :: nseq n.-1 (at_ 'X)).

Lemma span_step01 n : span n (step01 n).
Proof. by move=> i j lt_i /andP[le_j _]; rewrite /step01 le_j leqNgt lt_i subr0 unitr1. Qed.

Lemma span_polys n u : span n u -> span n (polys u).
Proof. by move=> sp; apply: (span_morph [rmorphism of polyC] sp). Qed.

Lemma deriv_step u m x (g : nat -> {poly F}) i :
  (step (polys u) m x g i)^`()
    = step (polys u) m x (fun i => (g i)^`()) i + step (polys u) m (x.1^`(), x.2^`()) g i.
Proof.
have [a eq_a] : exists a : F, (polys u (i + m)%N - polys u i)^-1 = a%:P.
  by exists (u (i + m)%N - u i)^-1; rewrite /polys -polyCB polyCV.
by rewrite /step /= eq_a /polys !(derivM, derivD, derivN, derivC); ring.
Qed.

Lemma deriv_blossom_X n u (g : nat -> {poly F}) : span n u ->
  (blossom (polys u) g (nseq n (at_ 'X)))^`()
    = blossom (polys u) (fun i => (g i)^`()) (nseq n (at_ 'X))
      + (if n is m.+1 then blossom (polys u) g (direction _ :: nseq m (at_ 'X)) else 0) *+ n.
Proof.
elim: n u g => [|n ih] u g sp /=; first by rewrite addr0.
have sp' := span_shift sp.
rewrite (ih (shift u)) // size_nseq.
rewrite (@blossom_ext _ _ _ (fun i => 1 * step (polys u) n.+1 (at_ 'X) (fun i => (g i)^`()) i
                                      + 1 * step (polys u) n.+1 (direction _) g i)); last first.
  by move=> i _; rewrite deriv_step /= derivX derivC !mul1r.
rewrite blossom_linear !mul1r -addrA; congr (_ + _).
case: n ih sp sp' => [|n] ih sp sp'; first by rewrite addr0 mulr1n.
rewrite [RHS]mulrS; congr (_ + _ *+ _).
have sp2 : span (size (nseq n (at_ ('X : {poly F})))).+2 (polys u) by rewrite size_nseq; apply: span_polys.
by have := blossom_swap g (at_ 'X) (direction _) sp2; rewrite /= !size_nseq; apply.
Qed.

(** blossoms derivative: $c'(t)=n\,c[\delta,t,\dots,t]$ for the direction $\delta=(1,0)$.
    Hypotheses: the knots carry a piece, so that its points have a meaning. *)
Theorem blossoms_derivative n u c : span n u -> (curve n u c)^`() = velocity n u c *+ n.
Proof.
move=> sp; rewrite /curve /velocity deriv_blossom_X //.
rewrite (@blossom_ext _ _ _ (fun=> 0)) ?blossom0 ?add0r; first by case: n sp.
by move=> i _; rewrite derivC.
Qed.

Lemma horner_curve n u c t : span n u -> (curve n u c).[t] = blossom u c (nseq n (at_ t)).
Proof.
move=> sp; rewrite -[LHS]/(horner_eval t (curve n u c)) /curve.
rewrite (blossom_morph [rmorphism of horner_eval t]); last by rewrite size_nseq; apply: span_polys.
rewrite map_nseq /= /horner_eval hornerX hornerC.
rewrite (@blossom_ext_knots _ _ u); last by move=> i _ /=; rewrite /horner_eval hornerC.
by apply: blossom_ext => i _ /=; rewrite /horner_eval hornerC.
Qed.

End Curve.
