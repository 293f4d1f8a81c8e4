(* BZZ19, section 3.2: the mapping over all pieces of its knots.
   Definitions:
     mapping n u b j      sigma on piece j: the curve of degree n of b_j, ..., b_{j+n} over the knots without their first j members
     on_piece n u j t     piece j, from u_{j+n-1} to u_{j+n}, is not empty and t lies on it, n >= 1 *)
From Torse Require Import Prelude Blossom Curves Joints BZZ19_3 BZZ19_3_range.
From mathcomp Require Import order ssrnum.
Import Order.TTheory Num.Theory.

Section Joints.
Variable F : fieldType.
Implicit Types (u b : nat -> F) (n m r j : nat) (x : F).

Definition mapping n u b j := curve n (drop_ j u) (drop_ j b).

(** BZZ19.3 joints: at a knot $x=t_{j+d}=\dots=t_{j+d+r-1}$ of any multiplicity $r\le d$ the pieces $j$ and $j+r$, before and after it, have the same value: the mapping is
    continuous.
    Hypotheses: the knots carry both pieces, so that their points have a meaning; $r\le d$.
    Paper: its knots are simple but for the ends. *)
Theorem BZZ19_3_joints n r u b j x : (r <= n)%N -> span n (drop_ j u) -> span n (drop_ (j + r) u) ->
  (forall i, (n <= i < n + r)%N -> u (j + i)%N = x) -> (mapping n u b j).[x] = (mapping n u b (j + r)).[x].
Proof.
move=> le_r sp sp' e; have dropD (v : nat -> F) i : drop_ r (drop_ j v) i = drop_ (j + r) v i by rewrite /drop_ addnA.
have sp2 : span n (drop_ r (drop_ j u)) by move=> i l h1 h2; rewrite !dropD; apply: sp'.
have sz : (r + size (nseq (n - r) (at_ x)))%N = n by rewrite size_nseq subnKC.
rewrite /mapping !horner_curve // (_ : nseq n (at_ x) = nseq r (at_ x) ++ nseq (n - r) (at_ x)); last by rewrite -nseqD subnKC.
rewrite (blossoms_joint _ sz sp sp2) //.
rewrite (@blossom_ext_knots _ _ (drop_ (j + r) u)); last by move=> i _; exact: dropD.
by apply: blossom_ext => i _; exact: dropD.
Qed.

(** BZZ19.3 joints_needs_multiplicity: at a knot of multiplicity $d+1$ it need not be: $d=1$, knots $0,1,1,2$ and coefficients $0,0,1,1$.
    Hypotheses: none. *)
Theorem BZZ19_3_joints_needs_multiplicity (u := fun i => nth 0 [:: 0; 1; 1; 2%:R] i : F) (b := fun i => (1 < i)%N%:R : F) :
  [/\ span 1 (drop_ 0 u), span 1 (drop_ 2 u) & (mapping 1 u b 0).[1] <> (mapping 1 u b 2).[1]].
Proof.
have s0 : span 1 (drop_ 0 u) by move=> [|//] j _ /andP[h1 h2]; rewrite (_ : j = 1%N); [rewrite /drop_ /u /= subr0 unitr1 | lia].
have e1 : 2%:R - 1 = 1 :> F by rewrite mulr2n addrK.
have s2 : span 1 (drop_ 2 u).
  by move=> [|//] j _ /andP[h1 h2]; rewrite (_ : j = 1%N); [rewrite /drop_ /u /= e1 unitr1 | lia].
split=> //; rewrite /mapping !horner_curve // /= /step /drop_ /u /b /= !mul1r e1 !mulr0 addr0 mul0r subrr mul0r addr0 divr1 mul1r.
by move/eqP; rewrite eq_sym oner_eq0.
Qed.
End Joints.

Section Monotone.
Variable F : realFieldType.
Implicit Types (u b : nat -> F) (n i j k : nat) (s t x : F).

Definition on_piece n u j t := u (j + n.-1)%N < u (j + n)%N /\ u (j + n.-1)%N <= t <= u (j + n)%N.

Lemma climb (v : nat -> F) m i l : (forall i, (i < m)%N -> v i <= v i.+1) -> (i <= l <= m)%N -> v i <= v l.
Proof.
move=> up; elim: l => [|l ih] /andP[le_i le_l]; first by move: le_i; rewrite leqn0 => /eqP ->.
move: le_i; rewrite leq_eqVlt => /orP[/eqP -> //|]; rewrite ltnS => le_i.
by apply: le_trans (ih _) (up l _); lia.
Qed.

Lemma piece_within n u m j t : (forall i, (i < m)%N -> u i <= u i.+1) -> (j + n.*2.+1 <= m)%N -> on_piece n.+1 u j t ->
  within n.+1 (drop_ j u) t.
Proof.
move=> up le_m [_ /andP[lo hi]]; split=> i h; rewrite /drop_.
  by apply: le_trans _ lo; apply: (climb up); rewrite /=; lia.
by apply: le_trans hi _; apply: (climb up); lia.
Qed.

Lemma piece_span n u m j t : (forall i, (i < m)%N -> u i <= u i.+1) -> (j + n.*2.+1 <= m)%N -> on_piece n.+1 u j t ->
  span n.+1 (drop_ j u).
Proof.
move=> up le_m [lt_u _]; apply: (within_span lt_u); apply: (piece_within up le_m); split=> //; rewrite lexx ltW //.
Qed.

Lemma piece_bounds n u b m j x : (forall i, (i < m)%N -> b i <= b i.+1) -> (j + n.+1 <= m)%N -> span n.+1 (drop_ j u) ->
  within n.+1 (drop_ j u) x -> b j <= (mapping n.+1 u b j).[x] <= b (j + n.+1)%N.
Proof.
move=> ub le_m sp inside; apply: BZZ19_3_range => // l le_l; rewrite /drop_.
by apply/andP; split; apply: (climb ub); rewrite ?leq_addr ?leq_add2l ?le_l ?(leq_trans _ le_m) // leq_add2l.
Qed.

(** BZZ19.5 spline: on the whole interval $\sigma(s)\le\sigma(t)$ for $s\le t$: $s$ on a piece $j$ and $t$ on a piece $k\ge j$ of a spline of degree $d\ge1$ over knots of any
    multiplicities.
    Hypotheses: an ordered field; knots and coefficients do not decrease; neither piece is empty. *)
Theorem BZZ19_5_spline n u b j k s t : (j <= k)%N -> (forall i, (i < k + n.*2.+1)%N -> u i <= u i.+1) ->
  (forall i, (i < k + n.+1)%N -> b i <= b i.+1) -> on_piece n.+1 u j s -> on_piece n.+1 u k t -> s <= t ->
  (mapping n.+1 u b j).[s] <= (mapping n.+1 u b k).[t].
Proof.
move=> le_jk up ub; have [m] := ubnP (k - j); elim: m j s le_jk => // m ih j s le_jk lt_m pj pk le_st.
have in_ i x : (i <= k)%N -> on_piece n.+1 u i x -> within n.+1 (drop_ i u) x by move=> le_i; apply: (piece_within up); lia.
have span_ i x : (i <= k)%N -> on_piece n.+1 u i x -> span n.+1 (drop_ i u) by move=> le_i; apply: (piece_span up); lia.
have same i x y : (i <= k)%N -> on_piece n.+1 u i x -> on_piece n.+1 u i y -> x <= y -> (mapping n.+1 u b i).[x] <= (mapping n.+1 u b i).[y].
  move=> le_i px py le_xy; apply: BZZ19_5_monotone le_xy _; [exact: in_ px | exact: in_ py |].
  by move=> l le_l; rewrite /drop_ addnS; apply: ub; lia.
have [ejk|ne_jk] := eqVneq j k; first by move: pj; rewrite ejk => pj; exact: same.
have ex : exists i, (j < i)%N && (u (i + n)%N < u (i + n.+1)%N) by exists k; rewrite (proj1 pk) andbT; lia.
case: (ex_minnP ex) => i /andP[lt_ji lt_i] min_i; have le_ik : (i <= k)%N by apply: min_i; rewrite (proj1 pk) andbT; lia.
set x := u (j + n.+1)%N.
have flat l : (n.+1 <= l < n.+1 + (i - j))%N -> u (j + l)%N = x.
  elim: l => [//|l IH] /andP[h1 h2]; have [e|ne] := eqVneq l n; first by rewrite e.
  rewrite -IH; last by lia.
  apply/eqP; rewrite eq_le; apply/andP; split; last by rewrite addnS; apply: up; lia.
  rewrite leNgt; apply/negP=> lt_l; have e1 : (j + (l - n) + n = j + l)%N by lia.
  have e2 : (j + (l - n) + n.+1 = j + l.+1)%N by lia.
  have lt_j : (j < j + (l - n))%N by lia.
  by have := min_i (j + (l - n))%N; rewrite e1 e2 lt_l lt_j => /(_ isT); lia.
have ei : u (i + n)%N = x by rewrite -(flat (i - j + n)%N); [congr (u _); lia | lia].
have px : on_piece n.+1 u j x by split; rewrite ?(proj1 pj) // lexx andbT ltW // (proj1 pj).
have px' : on_piece n.+1 u i x by split; rewrite // -ei lexx ltW.
have le_sx : s <= x by case: pj => _ /andP[].
have le_xt : x <= t by case: pk => _ /andP[lo _]; apply: le_trans _ lo; rewrite -ei; apply: (climb up); lia.
apply: le_trans (same j s x le_jk pj px le_sx) _.
apply: le_trans _ (ih i x le_ik _ px' pk le_xt); last by lia.
have [le_r|lt_r] := leqP (i - j) n.+1.
  have := @BZZ19_3_joints F n.+1 (i - j) u b j x le_r (span_ j _ le_jk px); rewrite subnKC ?(ltnW lt_ji) // => -> //.
  by apply: span_ px'.
have /andP[_ h1] := piece_bounds (m := k + n.+1) ub (leq_add le_jk (leqnn _)) (span_ j _ le_jk px) (in_ j _ le_jk px).
have /andP[h2 _] := piece_bounds (m := k + n.+1) ub (leq_add le_ik (leqnn _)) (span_ i _ le_ik px') (in_ i _ le_ik px').
apply: le_trans h1 (le_trans _ h2); apply: (climb ub).
by rewrite -leq_subRL ?(ltnW lt_ji) // (ltnW lt_r) (leq_trans le_ik) ?leq_addr.
Qed.
End Monotone.
