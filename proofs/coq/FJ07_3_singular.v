(* FJ07, section 3, singular points: Corollary 3 in its true form, over an ordered field. *)
From Torse Require Import Prelude Points FJ21_4.
From mathcomp Require Import order ssrnum.
Import Order.Theory Num.Theory.

(** FJ07.C3 cleared: where $n\,c(t)+(\Lambda^{*}-t)c'(t)=n\,d(t)+(M^{*}-t)d'(t)$, which is (9) without its denominator, the same identity holds for every $n$,
    also where $n=0$ in the field. *)
Theorem FJ07_C3_cleared (F : fieldType) m n (c d : 'rV[{poly F}]_m) t L M v :
  n%:R *: ev c t + (L - t) *: ev (pderiv c) t = n%:R *: ev d t + (M - t) *: ev (pderiv d) t ->
  (M - t) *: ((1 - v) *: ev (pderiv c) t + v *: ev (pderiv d) t)
    = ((1 - v) * (M - t) + v * (L - t)) *: ev (pderiv c) t - (n%:R * v) *: (ev d t - ev c t).
Proof.
move=> /rowP eq_p; apply/rowP=> k; have := eq_p k; rewrite !mxE.
move: (c 0 k).[t] (d 0 k).[t] (c 0 k)^`().[t] (d 0 k)^`().[t] n%:R => P Q P' Q' N eq_P.
by apply: (by_multiple (z := - v) eq_P); ring.
Qed.

(** FJ07.C3 velocity: with $W=d-c$: $(M^{*}-t)\,b_t(t,v)=\{(1-v)(M^{*}-t)+v(\Lambda^{*}-t)\}\,c'(t)-nv\,W(t)$.
    Hypotheses: $n\ne0$ in the field, so that the relation (9), which divides by $n$, has a meaning. *)
Theorem FJ07_C3_velocity (F : fieldType) m n (c d : 'rV[{poly F}]_m) t L M v : n%:R != 0 :> F -> related_at n c d t L M 1 ->
  (M - t) *: ((1 - v) *: ev (pderiv c) t + v *: ev (pderiv d) t)
    = ((1 - v) * (M - t) + v * (L - t)) *: ev (pderiv c) t - (n%:R * v) *: (ev d t - ev c t).
Proof.
move=> n0 rel; apply: FJ07_C3_cleared; have := congr1 (fun x => n%:R *: x) rel.
by rewrite /tangent !scale1r !scalerDr !scalerA ![n%:R * _]mulrC !divfK.
Qed.

(** FJ07.C3 regular: where $\Lambda^{*}$ and $M^{*}$ lie on one side of $t$ (which $\Lambda_k,M_k<0$ or $\Lambda_k,M_k>1$ on every piece says) and
    $c'\times(d-c)\ne0$, the surface is regular on the whole ruling $0\le v\le1$.
    Hypotheses: an ordered field; $c'(t)\times(d(t)-c(t))\ne0$: the curve is not stationary, the ruling has a length and does
    not touch the curve; $n\ge1$, so that the relation (9) has a meaning.
    Paper: omits the last, without which the corollary is false. *)
Theorem FJ07_C3_regular (F : realFieldType) n (c d : 'rV[{poly F}]_3) t L M v : (0 < n)%N -> related_at n c d t L M 1 ->
  (t < L) && (t < M) || (L < t) && (M < t) -> 0 <= v <= 1 -> cross (ev (pderiv c) t) (ev d t - ev c t) != 0 ->
  cross ((1 - v) *: ev (pderiv c) t + v *: ev (pderiv d) t) (ev d t - ev c t) != 0.
Proof.
move=> n0 rel side /andP[v0 v1] reg; apply: contraNneq reg => sing.
have nz : n%:R != 0 :> F by rewrite pnatr_eq0 -lt0n.
pose f := (1 - v) * (M - t) + v * (L - t).
have f0 : f != 0.
  rewrite /f; case/orP: side => /andP[l m].
    have [->|v_gt0] := eqVneq v 0; first by rewrite subr0 mul1r mul0r addr0 subr_eq0 gt_eqF.
    rewrite gt_eqF // ltr_spaddr ?mulr_ge0 ?mulr_gt0 ?subr_gt0 ?subr_ge0 // ?ltW // lt_def v_gt0 //.
  have [->|v_gt0] := eqVneq v 0; first by rewrite subr0 mul1r mul0r addr0 subr_eq0 lt_eqF.
  rewrite lt_eqF // -oppr_gt0 opprD -!mulrN !opprB ltr_spaddr ?mulr_ge0 ?mulr_gt0 ?subr_gt0 ?subr_ge0 // ?ltW // lt_def v_gt0 //.
have eq_v := FJ07_C3_velocity v nz rel.
have: (M - t) *: cross ((1 - v) *: ev (pderiv c) t + v *: ev (pderiv d) t) (ev d t - ev c t) = f *: cross (ev (pderiv c) t) (ev d t - ev c t).
  have lin (s : F) (x y : 'rV[F]_3) : s *: cross x y = cross (s *: x) y by apply: row3P; coordinates; hide_entries; ring.
  rewrite lin eq_v /f; move: (ev (pderiv c) t) (ev d t - ev c t) => a w.
  by apply: row3P; coordinates; hide_entries; ring.
by rewrite sing scaler0 => /esym/eqP; rewrite scaler_eq0 (negPf f0) /= => /eqP ->.
Qed.
