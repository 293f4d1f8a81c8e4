(* FJ07, section 3: what the coefficients lam, mu of a cell are for Bezier curves, and Aumann's condition for regular surfaces in terms of them. *)
From Torse Require Import Prelude FJ07_3_cells FJ07_3_regular.
From mathcomp Require Import order ssrnum.
Import Order.TTheory Num.Theory.

(** FJ07.18 bezier: on the knots $a,\dots,a,p,\dots,p$ of a Bezier curve (18) gives the same $l$ and $\mu$ in all cells.
    Hypotheses: $p\ne a$, so that there is a piece. *)
Theorem FJ07_18_bezier (F : fieldType) (a p l mu : F) : p - a != 0 -> next_l a a p l mu = l /\ next_mu a a p p mu = mu.
Proof. by move=> pa; rewrite /next_l /next_mu /D subrr !mulr0 addr0; split; field. Qed.

(** FJ07.C3 convex: for $\Lambda=\frac\lambda{1-\mu}$, $M=\frac1{1-\mu}$ the condition $\Lambda,M<0$ or $\Lambda,M>1$ says that the cell is convex: $\lambda>0$, $\mu>0$,
    $\lambda+\mu>1$.
    Hypotheses: an ordered field; $\mu\ne1$, so that $\Lambda$ and $M$ have a meaning. *)
Theorem FJ07_C3_convex (F : realFieldType) (lam mu : F) : 1 - mu != 0 ->
  same_side (lam / (1 - mu)) (1 - mu)^-1 <-> [/\ 0 < lam, 0 < mu & 1 < lam + mu].
Proof.
rewrite /same_side; have -> : (0 < mu) = (1 - mu < 1) by rewrite ltr_subl_addr ltr_addl.
have -> : (1 < lam + mu) = (1 - mu < lam) by rewrite ltr_subl_addr.
move: (1 - mu) => x; case: (ltrgt0P x) => [x0|x0|->]; last by [].
- move=> _; rewrite invr_lt0 (lt_gtF x0) andbF /= ltr_pdivl_mulr // mul1r -[x^-1]mul1r ltr_pdivl_mulr // mul1r.
  by split=> [/andP[h1 h2]|[_ h1 h2]]; [split=> //; exact: lt_trans x0 h1 | rewrite h1 h2].
move=> _; rewrite invr_lt0 x0 andbT [1 < x^-1]lt_gtF ?andbF ?orbF; last by rewrite (lt_trans _ ltr01) ?invr_lt0.
rewrite nmulr_llt0 ?invr_lt0 //; split=> [l0|[]//]; split=> //; first by rewrite (lt_trans x0).
exact: lt_trans x0 l0.
Qed.
