(* BZZ19, section 3.2: where the mapping increases strictly over all pieces of its knots. *)
From Torse Require Import Prelude Blossom Curves BZZ19_3 BZZ19_3_range BZZ19_3_pieces.
From mathcomp Require Import order ssrnum.
Import Order.TTheory Num.Theory.

Section Monotone.
Variable F : realFieldType.
Implicit Types (u b : nat -> F) (n i j k : nat) (s t x : F).

(** BZZ19.5 spline_strict: on the whole interval $\sigma(s)<\sigma(t)$ for $s<t$, if no piece from that of $s$ to that of $t$ has all its coefficients equal.
    Hypotheses: an ordered field; knots and coefficients do not decrease; neither the piece of $s$ nor that of $t$ is empty; $\beta_l<\beta_{l+d}$ for the pieces
    $l=j..k$ that are not empty. *)
Theorem BZZ19_5_spline_strict n u b j k s t : (j <= k)%N -> (forall i, (i < k + n.*2.+1)%N -> u i <= u i.+1) ->
  (forall i, (i < k + n.+1)%N -> b i <= b i.+1) -> on_piece n.+1 u j s -> on_piece n.+1 u k t -> s < t ->
  (forall l, (j <= l <= k)%N -> u (l + n)%N < u (l + n.+1)%N -> b l < b (l + n.+1)%N) ->
  (mapping n.+1 u b j).[s] < (mapping n.+1 u b k).[t].
Proof.
move=> le_jk up ub pj pk lt_st rises; have [lt_j /andP[/= js sj]] := pj; have [lt_k /andP[/= kt tk]] := pk.
have climbs i l : (i <= l <= k + n.*2.+1)%N -> u i <= u l by exact: (climb up).
suff [l [x [y [/andP[le_jl le_lk] px py lt_xy [le_sx le_yt]]]]] : exists l x y,
    [/\ (j <= l <= k)%N, on_piece n.+1 u l x, on_piece n.+1 u l y, x < y & s <= x /\ y <= t].
  have up_l i : (i < l + n.*2.+1)%N -> u i <= u i.+1 by move=> h; apply: up; rewrite (leq_trans h) // leq_add2r.
  have ub_l i : (i < l + n.+1)%N -> b i <= b i.+1 by move=> h; apply: ub; rewrite (leq_trans h) // leq_add2r.
  apply: le_lt_trans (BZZ19_5_spline le_jl up_l ub_l pj px le_sx) (lt_le_trans _ (BZZ19_5_spline le_lk up ub py pk le_yt)).
  apply: BZZ19_5_strict lt_xy _ _; [exact: (piece_within up_l) px | exact: (piece_within up_l) py | |].
    by move=> i le_i; rewrite /drop_ addnS; apply: ub_l; rewrite ltn_add2l ltnS.
  by rewrite /drop_ addn0; apply: rises; [rewrite le_jl | case: px].
have [ejk|ne_jk] := eqVneq j k; first by exists j, s, t; rewrite leqnn le_jk; split=> //; rewrite ejk.
have lt_jk : (j < k)%N by rewrite ltn_neqAle ne_jk.
have le_ends : u (j + n.+1)%N <= u (k + n)%N by apply: climbs; clear -lt_jk; lia.
have [lt_s|le_s] := ltP s (u (j + n.+1)%N).
  exists j, s, (u (j + n.+1)%N); rewrite leqnn le_jk; split=> //; first by split; rewrite // lexx ltW.
  by rewrite (le_trans le_ends).
have [lt_t|le_t] := ltP (u (k + n)%N) t.
  exists k, (u (k + n)%N), t; rewrite leqnn le_jk; split=> //; first by split; rewrite // lexx ltW.
  by rewrite (le_trans sj).
have lt_jk2 : (j.+1 < k)%N.
  rewrite ltn_neqAle lt_jk andbT; apply/eqP=> e; have := lt_le_trans lt_st le_t.
  by rewrite -e addSnnS ltNge le_s.
have [|l le_l lt_l] := @rise F (fun i => u (j + n.+1 + i)%N) (k - j).-2.
  apply: le_lt_trans (_ : _ <= s) (lt_le_trans lt_st (le_trans le_t _)); first by rewrite addn0.
  by apply: climbs; clear -lt_jk2; lia.
have e1 : (j + l.+1 + n = j + n.+1 + l)%N by clear; lia.
have e2 : (j + l.+1 + n.+1 = j + n.+1 + l.+1)%N by clear; lia.
have piece x : u (j + n.+1 + l)%N <= x <= u (j + n.+1 + l.+1)%N -> on_piece n.+1 u (j + l.+1) x by split; rewrite /= ?e1 ?e2.
exists (j + l.+1)%N, (u (j + n.+1 + l)%N), (u (j + n.+1 + l.+1)%N); split=> //; [clear -le_l lt_jk2; lia | | |].
- by apply: piece; rewrite lexx ltW.
- by apply: piece; rewrite lexx ltW.
split; first by apply: le_trans sj _; apply: climbs; clear -le_l lt_jk2; lia.
by apply: le_trans kt; apply: climbs; clear -le_l lt_jk2; lia.
Qed.
End Monotone.
