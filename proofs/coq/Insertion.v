(* Knot insertion: control points over finer knots are blossom values, and the curve stays.
   Definitions:
     insert_knot p x u         the knots with x as knot number p; those from u_p on move up
     insert_point n p x u c    Boehm's control points over these knots *)
From Torse Require Import Prelude Blossom Curves Points.

Section Insertion.
Variable R : comUnitRingType.
Implicit Types (u c : nat -> R) (x : R) (n p i j k : nat).

Definition insert_knot p x u i := if (i < p)%N then u i else if i == p then x else u i.-1.
Definition insert_point n p x u c i :=
  if (i + n <= p)%N then c i else if (p < i)%N then c i.-1 else step u n (at_ x) c i.-1.

(** blossoms refinement: over any knots $v$ that carry a piece, the blossom of $c$ has the control points $c[v_i,\dots,v_{i+n-1}]$.
    Hypotheses: both knot lists carry a piece. *)
Theorem blossoms_refinement n u v c w : span n u -> span n v -> size w = n ->
  blossom v (fun i => blossom u c (knots v i n)) w = blossom u c w.
Proof.
move=> spu spv sz; have := blossoms_unique (blossom_polar c spu) spv sz; rewrite sz eqxx => ->.
by apply: blossom_ext => i _; rewrite size_knots eqxx.
Qed.

Lemma knots_ext u v i j n : (forall k, (k < n)%N -> u (i + k)%N = v (j + k)%N) -> knots u i n = knots v j n.
Proof.
elim: n i j => [|n ih] i j e //; rewrite !knotsS (ih i.+1 j.+1).
  by have := e 0%N isT; rewrite !addn0 => ->.
by move=> k lt_k; rewrite !addSnnS; apply: e.
Qed.

Lemma knots_cat u i a b : knots u i (a + b) = knots u i a ++ knots u (i + a) b.
Proof. by rewrite /knots iotaD map_cat. Qed.

(* A blossom at a window of knots with one more argument. *)
Lemma blossom_window n u c x i a b : span n.+1 u -> (i <= n)%N -> (a + b = n)%N ->
  blossom u c (knots u i.+1 a ++ at_ x :: knots u (i.+1 + a) b) = step u n.+1 (at_ x) c i.
Proof.
move=> sp le_i eq_n; rewrite blossom_move ?size_knots ?eq_n //= size_cat !size_knots eq_n.
rewrite -[knots u i.+1 a ++ _](_ : knots (shift u) i n = _); first by rewrite blossoms_knots //; exact: span_shift.
by rewrite knots_shift /knots -map_cat -iotaD eq_n.
Qed.

(** blossoms boehm: Boehm's points over the knots with $x$ inserted as knot $p$ give the same blossom: a piece of the new list from $j$ on
    agrees with the piece $j$ of the old one if $x$ is in its second half or beyond ($j+n\le p$), and with the piece $j-1$ otherwise.
    Hypotheses: $n\le p$ or $j\ge1$: of the new list that has $x$ among its first $n$ knots the piece 0 is no piece of the old one; both pieces carry
    their knots, so that their points have a meaning. *)
Theorem blossoms_boehm n p x u c j w (u' := insert_knot p x u) (c' := insert_point n p x u c)
    (k := if (j + n <= p)%N then j else j.-1) :
  (n <= p)%N || (0 < j)%N -> span n (drop_ k u) -> span n (drop_ j u') -> size w = n ->
  blossom (drop_ j u') (drop_ j c') w = blossom (drop_ k u) (drop_ k c) w.
Proof.
case: n @c' @k => [|n] c' k le_p spk spj sz.
  move: w sz => [|//] _; rewrite /= /drop_ !addn0 /c' /insert_point /k addn0.
  by case: leqP => // lt_j.
rewrite -(blossoms_refinement (drop_ k c) spk spj sz).
apply: blossom_ext => i; rewrite sz => le_i; rewrite {1}/drop_ /c' /insert_point.
have k_ge : (if (j + n.+1 <= p) then k = j else k.+1 = j)%N by rewrite /k; case: leqP => h //=; case/orP: le_p; lia.
clearbody k.
case: ifP => [left | /negbT]; last rewrite -ltnNge => middle.
  have ek : k = j by move: k_ge; case: leqP => h //; lia.
  rewrite (@knots_ext _ (drop_ k u) i i); first by rewrite blossoms_knots // ek.
  by move=> h lt_h; rewrite /drop_ /u' /insert_knot ek ifT //; lia.
case: ifP => [right | /negbT]; last rewrite -leqNgt => inside.
  have [i' ei] : exists i', (k + i' = (j + i).-1)%N /\ (i' <= n.+1)%N.
    by move: k_ge; case: leqP => h e; [exists i.-1 | exists i]; lia.
  rewrite (@knots_ext _ (drop_ k u) i i'); first by rewrite blossoms_knots ?ei.2 // /drop_ ei.1.
  by move=> h lt_h; rewrite /drop_ /u' /insert_knot ifF ?ifF; [congr u; lia | lia | lia].
have [i' [ei le_i']] : exists i', (k + i' = (j + i).-1)%N /\ (i' <= n)%N.
  by move: k_ge; case: leqP => h e; [exists i.-1 | exists i]; lia.
pose a := (p - (j + i))%N; have eab : (a + (n - a) = n)%N by rewrite subnKC // /a; lia.
transitivity (step (drop_ k u) n.+1 (at_ x) (drop_ k c) i').
  by rewrite /step /drop_ /= !addnA !addnS ei.
rewrite -(blossom_window (drop_ k c) x spk le_i' eab); congr (blossom _ _ _).
rewrite -[in RHS]eab -addnS knots_cat knotsS; congr (_ ++ _ :: _).
- by apply: knots_ext => h lt_h; rewrite /drop_ /u' /insert_knot ifT; [congr u; lia | lia].
- by rewrite /drop_ /u' /insert_knot ifF ?ifT //; lia.
- by apply: knots_ext => h lt_h; rewrite /drop_ /u' /insert_knot ifF ?ifF; [congr u; lia | lia | lia].
Qed.
(** blossoms boehm_needs_place: with $x$ inserted among the first knots, $p=1<n=2$, the first point of the new list is $c[x,u_1]$ where it should be $c[u_0,x]$.
    Hypotheses: the knots carry both pieces, so that their points have a meaning. *)
Theorem blossoms_boehm_needs_place x u c : span 2 u -> span 2 (insert_knot 1 x u) ->
  blossom (insert_knot 1 x u) (insert_point 2 1 x u c) [:: at_ (u 0%N); at_ x] = blossom u c [:: at_ x; at_ (u 1%N)].
Proof.
move=> sp sp'; have u21 : u 2%N - u 1%N \is a GRing.unit by exact: sp.
rewrite (blossoms_knots (insert_point 2 1 x u c) sp' (leq0n 2)) /insert_point /= [RHS]/step /shift /at_ /= !mul1r subrr mul0r addr0.
by rewrite [RHS]mulrAC mulrV // mul1r.
Qed.
End Insertion.
