(* Degree elevation: the mean of a blossom over the ways to leave one argument out is a blossom of one degree more, that of the same curve.
   Definitions:
     omit h a            the arguments a but a_h
     mean_form n b a     the mean of z_h b(omit h a), z_h the weight of a_h: with parameters for arguments the mean of b(omit h a), h = 0..n *)
From Torse Require Import Prelude Blossom Curves.

Section Elevation.
Variable R : comUnitRingType.
Implicit Types (u v c : nat -> R) (a w : seq (R * R)) (x y : R * R) (n h i : nat) (s t : R).

Definition omit (T : Type) h (a : seq T) := take h a ++ drop h.+1 a.
Definition mean_form n (b : seq (R * R) -> R) a := n.+1%:R^-1 * \sum_(0 <= h < n.+1) (nth (direction R) a h).2 * b (omit h a).

Lemma perm_without (T : eqType) (z : T) (a : seq T) h : (h < size a)%N -> perm_eq a (nth z a h :: omit h a).
Proof. by move=> lt_h; rewrite -{1}(cat_take_drop h a) (drop_nth z) // perm_catC /= perm_cons perm_catC. Qed.

Lemma size_without (T : eqType) (a : seq T) h : (h < size a)%N -> size (omit h a) = (size a).-1.
Proof. by case: a => // z a lt_h; have /perm_size/= [->] := perm_without z lt_h. Qed.

Section Form.
Variables (n : nat) (b : seq (R * R) -> R).
Hypothesis sym : forall a w, size a = n -> perm_eq a w -> b a = b w.

Lemma mean_rem a : size a = n.+1 -> mean_form n b a = n.+1%:R^-1 * \sum_(x <- a) x.2 * b (rem x a).
Proof.
move=> sz; rewrite /mean_form (big_nth (direction R)) sz; congr (_ * _); apply: eq_big_nat => h /andP[_ lt_h]; congr (_ * _).
have lt_a : (h < size a)%N by rewrite sz.
apply: sym; first by rewrite size_without // sz.
rewrite -(perm_cons (nth (direction R) a h)) perm_sym -(permPl (perm_to_rem (mem_nth _ lt_a))); exact: perm_without.
Qed.

Lemma mean_symmetric a w : size a = n.+1 -> perm_eq a w -> mean_form n b a = mean_form n b w.
Proof.
move=> sz eq_aw; have szw : size w = n.+1 by rewrite -(perm_size eq_aw).
rewrite !mean_rem // (perm_big _ eq_aw); congr (_ * _); apply: eq_big_seq => x xw; congr (_ * _).
have xa : x \in a by rewrite (perm_mem eq_aw).
apply: sym; first by rewrite size_rem // sz.
by rewrite -(perm_cons x) -(permPl (perm_to_rem xa)) -(permPr (perm_to_rem xw)).
Qed.
End Form.

Lemma mean_polar n u c : span n u -> polar n.+1 (fun a => if size a == n.+1 then mean_form n (blossom u c) a else 0).
Proof.
move=> sp; have sym a w : size a = n -> perm_eq a w -> blossom u c a = blossom u c w.
  by move=> sz; apply: blossoms_symmetric; rewrite sz.
split=> [a w eq_aw|s x t y a [sz]]; first by rewrite (perm_size eq_aw); case: eqP => // sz; apply: mean_symmetric; rewrite ?(perm_size eq_aw).
have split_ z : mean_form n (blossom u c) (z :: a) = n.+1%:R^-1 * (z.2 * blossom u c a + \sum_(0 <= h < n) (nth (direction R) a h).2 * blossom u c (z :: omit h a)).
  rewrite /mean_form big_nat_recl //; congr (_ * (_ * blossom u c _ + _)); first by rewrite /omit /= drop0.
rewrite /= sz eqxx !split_ mulrCA [t * _]mulrCA -mulrDr; congr (_ * _).
rewrite !mulrDr addrACA; congr (_ + _); first by rewrite /comb /=; ring.
rewrite !mulr_sumr -big_split; apply: eq_bigr => h _; rewrite -[comb s x t y :: _]cat0s blossoms_multilinear !cat0s; cbv beta.
move: (blossom u c (x :: _)) (blossom u c (y :: _)) (_.2) => p q r; rewrite /GRing.add_comoid /=; ring.
Qed.

(** blossoms elevation: over any knots $v$ that carry a piece in degree $n+1$, the points $\frac1{n+1}\sum_hc[v_i,\dots,\widehat{v_{i+h}},\dots,v_{i+n}]$, one
    argument left out, have the blossom $\frac1{n+1}\sum_hc[\dots,\widehat{t_h},\dots]$ at parameters $t_0,\dots,t_n$.
    Hypotheses: both knot lists carry a piece. *)
Theorem blossoms_elevation n u v c w : span n u -> span n.+1 v -> size w = n.+1 ->
  blossom v (fun i => mean_form n (blossom u c) (knots v i n.+1)) w = mean_form n (blossom u c) w.
Proof.
move=> spu spv sz; have := blossoms_unique (mean_polar c spu) spv sz; rewrite sz eqxx => ->.
by apply: blossom_ext => i _; rewrite size_knots eqxx.
Qed.

Lemma mean_nseq n b t : n.+1%:R \is a @GRing.unit R -> mean_form n b (nseq n.+1 (at_ t)) = b (nseq n (at_ t)).
Proof.
move=> un; rewrite /mean_form (eq_big_nat _ _ (F2 := fun=> b (nseq n (at_ t)))) => [|h /andP[_ lt_h]].
  by rewrite sumr_const_nat subn0 -[b _ *+ _]mulr_natl mulKr.
rewrite nth_nseq lt_h mul1r; congr b; rewrite /omit drop_nseq -(cat_take_drop h (nseq n.+1 _)).
by rewrite take_nseq 1?ltnW // take_size_cat ?size_nseq // -nseqD; congr nseq; lia.
Qed.

(** blossoms elevated: in particular it is the curve of these points: $\hat c(t)=c(t)$.
    Hypotheses: both knot lists carry a piece; $n+1$ has an inverse, so that the mean has a meaning. *)
Theorem blossoms_elevated n u v c t : n.+1%:R \is a @GRing.unit R -> span n u -> span n.+1 v ->
  blossom v (fun i => mean_form n (blossom u c) (knots v i n.+1)) (nseq n.+1 (at_ t)) = blossom u c (nseq n (at_ t)).
Proof. by move=> un spu spv; rewrite blossoms_elevation ?size_nseq // mean_nseq. Qed.
End Elevation.
