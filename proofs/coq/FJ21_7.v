(* FJ21, section 7: constant Lam, M, sigma; polarisation. *)
From Torse Require Import Prelude Blossom Curves Points FJ07_2.

Section Polarisation.
Variable F : fieldType.
Implicit Types (u c d : nat -> F) (n : nat).

Lemma step_direction u m c i : step u m (direction F) c i = (c i.+1 - c i) / (u (i + m)%N - u i).
Proof. by rewrite /step /= !mul0r sub0r subr0 mul1r mulN1r addrC. Qed.

(** FJ21.7.1 polarisation: curves that agree at $t,\dots,t$ have the same control points, hence the same blossom.
    Hypotheses: $n!\ne0$ in the field; the knots carry the piece, so that the curves have a meaning.
    Paper: does not say that the characteristic matters. *)
Theorem FJ21_7_1_polarisation n u c d : n`!%:R != 0 :> F -> span n u -> curve n u c = curve n u d ->
  forall i, (i <= n)%N -> c i = d i.
Proof.
elim: n u c d => [|n ih] u c d nz sp eq_cd.
  by case=> // _; apply: polyC_inj; move: eq_cd; rewrite /curve /= /polys.
have [nz1 nz2] : n.+1%:R != 0 :> F /\ n`!%:R != 0 :> F.
  by move: nz; rewrite factS natrM mulf_eq0 negb_or => /andP[].
have eq_v : velocity n.+1 u c = velocity n.+1 u d.
  have := congr1 (@deriv F) eq_cd; rewrite !blossoms_derivative // => eq_d.
  apply: (@mulfI _ (n.+1%:R : {poly F})); first by rewrite -polyC1 -polyCMn polyC_eq0.
  by rewrite !mulr_natl.
have vel a : velocity n.+1 u a = curve n (shift u) (step u n.+1 (direction F) a).
  rewrite /velocity /curve /= size_nseq; apply: blossom_ext => i; rewrite size_nseq => le_i.
  by rewrite /polys step_direction /step /= !mul0r sub0r subr0 mul1r mulN1r polyCM -polyCV !polyCB addrC.
rewrite !vel in eq_v; have {eq_v} eq_s := ih _ _ _ nz2 (span_shift sp) eq_v.
have diff i : (i <= n.+1)%N -> c i - d i = c 0%N - d 0%N.
  elim: i => // i ihi lt_i; rewrite -ihi 1?ltnW //.
  have := eq_s i lt_i; rewrite !step_direction => /mulIf eq_i.
  have {eq_i} : c i.+1 - c i = d i.+1 - d i.
    by apply: eq_i; rewrite invr_eq0 -unitfE; apply: sp; lia.
  by move/(canRL (subrK _)) ->; ring.
have eq_0 : c 0%N - d 0%N = 0.
  apply: polyC_inj; rewrite -(curve_const (c 0%N - d 0%N) sp); transitivity (curve n.+1 u c - curve n.+1 u d).
    have := curve_comb n.+1 u 1 (-1) c d; rewrite polyCN polyC1 mul1r mulN1r => <-; rewrite /curve.
    by apply: blossom_ext => i; rewrite size_nseq => le_i; rewrite /polys mul1r mulN1r diff.
  by rewrite eq_cd subrr.
by move=> i le_i; apply/eqP; rewrite -subr_eq0 diff // eq_0.
Qed.
End Polarisation.
