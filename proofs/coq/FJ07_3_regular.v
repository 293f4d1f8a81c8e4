(* FJ07, section 3: where a developable spline surface is regular; Corollary 3 with its converse.
   Definitions:
     velocity_on c d t v    b_t at (t, v) on the surface (1 - v) c + v d
     same_side x y          x, y < 0 or x, y > 1, as Corollary 3 asks of Lam_k, M_k *)
From Torse Require Import Prelude Blossom Curves Points FJ07_3_pieces FJ07_3_net FJ07_3_blossoms FJ21_4 FJ07_3_singular FJ07_3_generic FJ07_3_segments.
From mathcomp Require Import order ssrnum.
Import Order.Theory Num.Theory.

Section Point.
Variable F : fieldType.
Implicit Types (c d : 'rV[{poly F}]_3) (t L M v : F) (n : nat).

Definition velocity_on c d t v : 'rV[F]_3 := (1 - v) *: ev (pderiv c) t + v *: ev (pderiv d) t.

Lemma apart n c d t L M : related_at n c d t L M 1 -> cross (ev (pderiv c) t) (ev d t - ev c t) != 0 -> M - t != 0.
Proof.
move=> rel; apply: contraNneq => mt; have -> : ev d t - ev c t = ((L - t) / n%:R) *: ev (pderiv c) t.
  by move: rel; rewrite /related_at /tangent mt mul0r scale0r addr0 scale1r => <-; rewrite addrAC subrr add0r.
by rewrite crossZr cross_self scaler0.
Qed.

Lemma normal_scale n c d t L M v : n%:R != 0 :> F -> related_at n c d t L M 1 ->
  (M - t) *: cross (velocity_on c d t v) (ev d t - ev c t)
    = ((1 - v) * (M - t) + v * (L - t)) *: cross (ev (pderiv c) t) (ev d t - ev c t).
Proof.
move=> n0 rel; rewrite -crossZl (FJ07_C3_velocity v n0 rel); move: (ev (pderiv c) t) (ev d t - ev c t) => a w.
by apply: row3P; coordinates; ring.
Qed.

(** FJ07.C3 point: a ruling that does not touch the curve has its only singular point at $v=\frac{t-M^{*}}{\Lambda^{*}-M^{*}}$, on the edge of
    regression, and none for $\Lambda^{*}=M^{*}$.
    Hypotheses: $c'\times(d-c)\ne0$; $n\ne0$ in the field, where else the relation of $c$ and $d$, which divides by $n$, has no meaning. *)
Theorem FJ07_C3_point n c d t L M v : n%:R != 0 :> F -> related_at n c d t L M 1 ->
  cross (ev (pderiv c) t) (ev d t - ev c t) != 0 ->
  cross (velocity_on c d t v) (ev d t - ev c t) = 0 <-> v * (L - M) = t - M.
Proof.
move=> n0 rel nz; have mt := apart rel nz; have e := normal_scale v n0 rel.
have eq_f : (1 - v) * (M - t) + v * (L - t) = v * (L - M) - (t - M) by ring.
rewrite eq_f in e; split=> [z|z].
  by move: e; rewrite z scaler0 => /esym/eqP; rewrite scalemx_eq0 (negPf nz) orbF subr_eq0 => /eqP.
by apply: (scalerI mt); rewrite e z subrr scale0r scaler0.
Qed.
End Point.

Section Ordered.
Variable F : realFieldType.
Implicit Types (c d : 'rV[{poly F}]_3) (t L M v x y : F) (n k : nat).

(** FJ07.C3 exact: the ruling $0\le v\le1$ is free of singular points iff $\Lambda^{*}$ and $M^{*}$ lie on one side of $t$.
    Hypotheses: an ordered field; $c'\times(d-c)\ne0$; $n\ge1$, so that the relation (9), which divides by $n$, has a meaning. *)
Theorem FJ07_C3_exact n c d t L M : (0 < n)%N -> related_at n c d t L M 1 ->
  cross (ev (pderiv c) t) (ev d t - ev c t) != 0 ->
  (forall v, 0 <= v <= 1 -> cross (velocity_on c d t v) (ev d t - ev c t) != 0) <-> 0 < (M - t) * (L - t).
Proof.
move=> n0 rel nz; have nF : n%:R != 0 :> F by rewrite pnatr_eq0 -lt0n.
have sing v := FJ07_C3_point v nF rel nz; split=> [reg | pos v /andP[v0 v1]]; last first.
  apply/negP=> /eqP/sing e; have : (t - M) * (t - M) = v * (L - M) * (t - M) by rewrite e.
  have pos2 : (M - t) * (M - t) > 0 by rewrite -expr2 lt_def sqr_ge0 andbT sqrf_eq0 (apart rel nz).
  have -> : v * (L - M) * (t - M) = v * ((M - t) * (M - t)) - v * ((M - t) * (L - t)) by ring.
  move=> h; have: 0 < (1 - v) * ((M - t) * (M - t)) + v * ((M - t) * (L - t)).
    have [->|v_n0] := eqVneq v 0; first by rewrite subr0 mul1r mul0r addr0.
    apply: ltr_paddl; first by apply: mulr_ge0; [rewrite subr_ge0 | apply: ltW].
    by apply: mulr_gt0 => //; rewrite lt_def v_n0.
  have -> : (1 - v) * ((M - t) * (M - t)) + v * ((M - t) * (L - t)) = (t - M) * (t - M) - (v * ((M - t) * (M - t)) - v * ((M - t) * (L - t))) by ring.
  by rewrite h subrr ltxx.
have mt := apart rel nz; have lt_ : L - t != 0.
  by apply: contra (reg 1 _) => [/eqP e|]; rewrite ?ler01 ?lexx //; apply/eqP/sing; rewrite mul1r -(subrK t L) e add0r.
rewrite lt_def mulf_neq0 // leNgt; apply/negP=> neg.
have q0 : M - L != 0.
  apply: contraTneq neg => /eqP; rewrite subr_eq0 => /eqP ->; rewrite -leNgt -expr2 sqr_ge0 //.
pose v := (M - t) / (M - L); have ev : v * (L - M) = t - M by rewrite /v; field.
suff in01 : 0 <= v <= 1 by move: (reg v in01); rewrite (iffRL (sing v) ev) eqxx.
have eq_v : v = (M - t) ^+ 2 / ((M - t) ^+ 2 - (M - t) * (L - t)).
  by rewrite /v; field; rewrite q0 (_ : _ - _ = (M - t) * (M - L)) ?mulf_neq0 //; ring.
have s0 : 0 <= (M - t) ^+ 2 by apply: sqr_ge0.
have den : 0 < (M - t) ^+ 2 - (M - t) * (L - t) by rewrite ltr_paddl // oppr_gt0.
rewrite eq_v divr_ge0 //= ?(ltW den) // ler_pdivr_mulr // mul1r ler_addl oppr_ge0 ltW //.
Qed.

Definition same_side x y := (x < 0) && (y < 0) || (1 < x) && (1 < y).

Lemma local_side u n k x t : 0 < len u n k -> u (n + k)%N <= t <= u (n + k).+1 -> 
  (local u n k x < 0 -> x < t) /\ (1 < local u n k x -> t < x).
Proof.
rewrite /local => l0 /andP[ta tb]; split.
  rewrite pmulr_llt0 ?invr_gt0 // subr_lt0 => /lt_le_trans; exact.
by rewrite ltr_pdivl_mulr // mul1r /len ltr_subl_addr subrK; apply: le_lt_trans.
Qed.

Lemma local_sides u n k L M : 0 < len u n k ->
  same_side (local u n k L) (local u n k M) <-> forall t, u (n + k)%N <= t <= u (n + k).+1 -> 0 < (M - t) * (L - t).
Proof.
move=> l0; split=> [side t ht|pos].
  have [Ll Lr] := local_side L l0 ht; have [Ml Mr] := local_side M l0 ht.
  case/orP: side => /andP[hL hM].
    by rewrite -mulrNN mulr_gt0 // oppr_gt0 subr_lt0; [apply: Ml | apply: Ll].
  by rewrite mulr_gt0 // subr_gt0; [apply: Mr | apply: Lr].
have le_ab : u (n + k)%N <= u (n + k).+1 by rewrite -subr_ge0 ltW.
have out x : (forall t, u (n + k)%N <= t <= u (n + k).+1 -> x != t) -> (x < u (n + k)%N) || (u (n + k).+1 < x).
  move=> h; rewrite ltNge; case: (boolP (u (n + k)%N <= x)) => //= ax; rewrite ltNge; apply/negP=> xb.
  by have := h x; rewrite ax xb => /(_ isT)/eqP.
have oM : (M < u (n + k)%N) || (u (n + k).+1 < M).
  by apply: out => t /pos; apply: contraTneq => ->; rewrite subrr mul0r ltxx.
have oL : (L < u (n + k)%N) || (u (n + k).+1 < L).
  by apply: out => t /pos; apply: contraTneq => ->; rewrite subrr mulr0 ltxx.
have neg x : (local u n k x < 0) = (x < u (n + k)%N) by rewrite /local pmulr_llt0 ?invr_gt0 // subr_lt0.
have big x : (1 < local u n k x) = (u (n + k).+1 < x) by rewrite /local ltr_pdivl_mulr // mul1r /len ltr_subl_addr subrK.
rewrite /same_side !neg !big; have := pos (u (n + k)%N); rewrite lexx le_ab => /(_ isT).
case/orP: oM => hM; case/orP: oL => hL; rewrite ?hM ?hL ?orbT // => /ltW; rewrite leNgt => /negP[].
  by rewrite nmulr_rlt0 ?subr_lt0 // subr_gt0 (le_lt_trans le_ab).
by rewrite pmulr_rlt0 ?subr_lt0 // subr_gt0 (le_lt_trans le_ab).
Qed.

(** FJ07.C3 piece: over a piece where no ruling touches the curve the surface has no singular point with $0\le v\le1$ iff
    $\Lambda_k,M_k<0$ or $\Lambda_k,M_k>1$.
    Hypotheses: an ordered field; $c'\times(d-c)\ne0$ all over the piece; it has a positive length and its knots carry it, so that its points have a meaning.
    Paper: omits that no ruling touches the curve, and leaves the converse open. *)
Theorem FJ07_C3_piece u n k L M (c d : nat -> 'rV[F]_3) (C := pcurve n.+1 (drop_ k u) (drop_ k c)) (D := pcurve n.+1 (drop_ k u) (drop_ k d)) :
  0 < len u n k -> span n.+1 (drop_ k u) -> (forall i, (i < n.+1)%N -> cell u n.+1 L M c d (k + i)) ->
  (forall t, u (n + k)%N <= t <= u (n + k).+1 -> cross (ev (pderiv C) t) (ev D t - ev C t) != 0) ->
  (forall t v, u (n + k)%N <= t <= u (n + k).+1 -> 0 <= v <= 1 -> cross (velocity_on C D t v) (ev D t - ev C t) != 0) <->
  same_side (local u n k L) (local u n k M).
Proof.
move=> l0 sp cells reg; rewrite local_sides //; have nF : n.+1%:R != 0 :> F by rewrite pnatr_eq0.
have rel t : related_at n.+1 C D t L M 1.
  rewrite /related_at /C /D !FJ21_3_5_tangent // scale1r; apply: (iffRL (FJ07_T1_piece L M _ _ sp)); last by rewrite size_nseq.
  by move=> i lt_i; apply/cell_drop/cells.
split=> [sing t ht|side t v ht]; first by apply/(FJ07_C3_exact (ltn0Sn n) (rel t) (reg t ht)) => v; apply: sing.
by move: v; apply/(FJ07_C3_exact (ltn0Sn n) (rel t) (reg t ht))/side.
Qed.

(** FJ07.C3 safe: $\Lambda_1<0$ on the first piece passes on to all pieces: a safe choice whatever the knots.
    Hypotheses: an ordered field; all pieces have positive length. *)
Theorem FJ07_C3_safe u n K x : (forall k, (k <= K)%N -> 0 < len u n k) -> local u n 0 x < 0 -> forall k, (k <= K)%N -> local u n k x < 0.
Proof.
move=> l0 x0; elim=> // k ih lt_k; have lk := l0 k (ltnW lt_k); have lk' := l0 k.+1 lt_k.
rewrite FJ07_10_recursion ?gt_eqF // pmulr_rlt0 ?divr_gt0 // subr_lt0.
by apply: lt_trans (ih (ltnW lt_k)) ltr01.
Qed.
End Ordered.
