(* Blossoms of polynomial and spline curves over a commutative ring with units; the points enter by one coordinate.
   Definitions:
     at_ t           the argument "parameter t", (t, 1); an argument is a pair (a, w)
     direction       the argument (1, 0): a blossom with it is a derivative
     comb s x t y    the argument s x + t y
     shift u         the list u without its first member
     step u m x c    one step of de Boor's algorithm for degree m: ((w u_{i+m} - a) c_i + (a - w u_i) c_{i+1}) / (u_{i+m} - u_i)
     blossom u c v   c[v_1, ..., v_n], n the length of v, over the knots u_0, ..., u_{2n-1}, by n steps
     span n u        the knots u_0, ..., u_{2n-1} carry a piece: no denominator of any step vanishes
     knots u i n     the arguments u_i, ..., u_{i+n-1}
     polar n f       f is symmetric and linear in each of its n arguments *)
From Torse Require Import Prelude.

Definition shift (T : Type) (u : nat -> T) i := u i.+1.

Section Blossom.
Variable R : comUnitRingType.
Implicit Types (u c : nat -> R) (x y : R * R) (v w : seq (R * R)) (n m i : nat).

Definition at_ (t : R) : R * R := (t, 1).
Definition direction : R * R := (1, 0).
Definition comb (s : R) x (t : R) y : R * R := (s * x.1 + t * y.1, s * x.2 + t * y.2).
Definition step u m x c i := ((x.2 * u (i + m)%N - x.1) * c i + (x.1 - x.2 * u i) * c i.+1) / (u (i + m)%N - u i).
Fixpoint blossom u c v := if v is x :: v' then blossom (shift u) (step u (size v) x c) v' else c 0%N.
Definition span n u := forall i j, (i < n)%N -> (n <= j <= i + n)%N -> u j - u i \is a GRing.unit.
Definition knots u i n := [seq at_ (u j) | j <- iota i n].
Definition polar n (f : seq (R * R) -> R) :=
  (forall v w, perm_eq v w -> f v = f w) /\
  (forall s x t y v, (size v).+1 = n -> f (comb s x t y :: v) = s * f (x :: v) + t * f (y :: v)).

Lemma span_shift n u : span n.+1 u -> span n (shift u).
Proof. by move=> sp i j lt_i /andP[le_j le_ij]; apply: sp; lia. Qed.

Lemma blossom_ext u c c' v : (forall i, (i <= size v)%N -> c i = c' i) -> blossom u c v = blossom u c' v.
Proof.
elim: v u c c' => [|x v ih] u c c' eq_c /=; first exact: eq_c.
by apply: ih => i le_i; rewrite /step !eq_c //=; lia.
Qed.

Lemma blossom_ext_knots u u' c v :
  (forall i, (i < (size v).*2)%N -> u i = u' i) -> blossom u c v = blossom u' c v.
Proof.
elim: v u u' c => [|x v ih] u u' c eq_u //=.
rewrite (ih _ (shift u')); last by move=> i lt_i; apply: eq_u => /=; lia.
by apply: blossom_ext => i le_i; rewrite /step !eq_u //=; lia.
Qed.

Lemma blossom_linear u (s t : R) c c' v :
  blossom u (fun i => s * c i + t * c' i) v = s * blossom u c v + t * blossom u c' v.
Proof.
elim: v u c c' => [|x v ih] u c c' //=.
by rewrite -ih; apply: blossom_ext => i _; rewrite /step /=; ring.
Qed.

Lemma blossom0 u v : blossom u (fun=> 0) v = 0.
Proof.
by elim: v u => [|x v ih] u //=; apply: etrans (ih (shift u)); apply: blossom_ext => i _; rewrite /step /= !mulr0 addr0 mul0r.
Qed.

(** blossoms linear: $c[v]$ is linear in the control points. *)
Theorem blossoms_linear u (I : Type) (r : seq I) (a : I -> R) (c : I -> nat -> R) v :
  blossom u (fun i => \sum_(k <- r) a k * c k i) v = \sum_(k <- r) a k * blossom u (c k) v.
Proof.
elim: r => [|k r ih].
  by rewrite big_nil -[RHS](blossom0 u v); apply: blossom_ext => i _; rewrite big_nil.
rewrite big_cons -ih -[X in _ + X]mul1r -blossom_linear.
by apply: blossom_ext => i _; rewrite big_cons mul1r.
Qed.

Lemma step_comb u m (s : R) x (t : R) y c i : step u m (comb s x t y) c i = s * step u m x c i + t * step u m y c i.
Proof. by rewrite /step /=; ring. Qed.

(** blossoms multilinear: $c[\dots,sx+ty,\dots]=s\,c[\dots,x,\dots]+t\,c[\dots,y,\dots]$ for arguments $x,y$ in the plane of pairs $(a,w)$. *)
Theorem blossoms_multilinear u c v w (s : R) x (t : R) y :
  blossom u c (v ++ comb s x t y :: w) = s * blossom u c (v ++ x :: w) + t * blossom u c (v ++ y :: w).
Proof.
elim: v u c => [|z v ih] u c /=.
  by rewrite -blossom_linear; apply: blossom_ext => i _; rewrite step_comb.
by rewrite !size_cat /= ih.
Qed.

(** blossoms affine: $c[\dots,(1-s)a+sb,\dots]=(1-s)c[\dots,a,\dots]+s\,c[\dots,b,\dots]$ for parameters $a,b$. *)
Theorem blossoms_affine u c v w (s a b : R) :
  blossom u c (v ++ at_ ((1 - s) * a + s * b) :: w)
    = (1 - s) * blossom u c (v ++ at_ a :: w) + s * blossom u c (v ++ at_ b :: w).
Proof. by rewrite -blossoms_multilinear /comb /at_ /=; congr (blossom u c (_ ++ (_, _) :: _)); ring. Qed.

Lemma step_swap u m x y c i :
  u (i + m.+2)%N - u i \is a GRing.unit -> u (i.+1 + m.+2)%N - u i.+1 \is a GRing.unit ->
  step (shift u) m.+1 y (step u m.+2 x c) i = step (shift u) m.+1 x (step u m.+2 y c) i.
Proof.
rewrite /step /shift !addnS !addSn => /mulrV dA /mulrV dB; case: x y => [a w] [b z] /=.
move: dA dB; set E := (_ - u i.+1)^-1; set A := (_ - u i)^-1; set B := (_ - u i.+1)^-1; move: E A B => E A B dA dB.
move: (u i) (u i.+1) (u (i + m).+2) (u (i + m).+3) (c i) (c i.+1) (c i.+2) dA dB => p q r s c0 c1 c2 dA dB.
apply/eqP; rewrite -subr_eq0; apply/eqP.
rewrite (_ : _ - _ = (((r - p) * A) * (a * z - w * b) + ((s - q) * E) * (w * b - a * z)) * B * c1); last by ring.
by rewrite dA dB; ring.
Qed.

Lemma blossom_swap u c x y v : span (size v).+2 u -> blossom u c (x :: y :: v) = blossom u c (y :: x :: v).
Proof.
by move=> sp /=; apply: blossom_ext => i le_i; apply: step_swap; apply: sp; lia.
Qed.

Lemma blossom_move u c x v w : span (size v + size w).+1 u -> blossom u c (v ++ x :: w) = blossom u c (x :: v ++ w).
Proof.
elim: v u c => [|y v ih] u c sp //.
rewrite (_ : blossom u c (x :: (y :: v) ++ w) = blossom u c (y :: x :: v ++ w)); last first.
  by apply: blossom_swap; rewrite size_cat.
rewrite /= ih; last by apply: span_shift.
by rewrite /= !size_cat /= !addnS.
Qed.

(** blossoms symmetric: $c[v_1,\dots,v_n]$ does not depend on the order of its arguments.
    Hypotheses: the knots carry a piece, so that its points have a meaning. *)
Theorem blossoms_symmetric u c v w : span (size v) u -> perm_eq v w -> blossom u c v = blossom u c w.
Proof.
elim: v u c w => [|x v ih] u c w sp eq_vw; first by rewrite perm_sym in eq_vw; rewrite (perm_small_eq _ eq_vw).
have xw : x \in w by rewrite -(perm_mem eq_vw) mem_head.
case/path.splitPr: xw eq_vw => w1 w2 eq_vw.
have {}eq_vw : perm_eq v (w1 ++ w2).
  by rewrite -(perm_cons x) (perm_trans eq_vw) // perm_catC /= perm_cons perm_catC.
have sz : size v = (size w1 + size w2)%N by rewrite (perm_size eq_vw) size_cat.
rewrite blossom_move; last by rewrite -sz.
by rewrite /= (ih _ _ _ (span_shift sp) eq_vw) (perm_size eq_vw).
Qed.

Lemma blossom_polar n u c : span n u -> polar n (fun v => if size v == n then blossom u c v else 0).
Proof.
move=> sp; split=> [v w eq_vw | s x t y v sz].
  by rewrite (perm_size eq_vw); case: eqP => // sz; apply: blossoms_symmetric; rewrite ?(perm_size eq_vw) ?sz.
have sz' z : size (z :: v) == n by rewrite /= sz.
by rewrite !sz' (blossoms_multilinear u c [::]).
Qed.

Lemma size_knots u i n : size (knots u i n) = n.
Proof. by rewrite size_map size_iota. Qed.

Lemma knots_shift u i n : knots (shift u) i n = knots u i.+1 n.
Proof. by rewrite /knots (iotaDl 1 i) -map_comp. Qed.

Lemma knotsS u i n : knots u i n.+1 = at_ (u i) :: knots u i.+1 n.
Proof. by []. Qed.

Lemma knots_last u i n : knots u i n.+1 = rcons (knots u i n) (at_ (u (i + n)%N)).
Proof. by rewrite /knots -addn1 iotaD map_cat cats1. Qed.

(** blossoms unique: a symmetric function linear in each of its $n$ arguments is the blossom of its values at consecutive knots.
    Hypotheses: the knots carry a piece, so that its points have a meaning. *)
Theorem blossoms_unique n f u v :
  polar n f -> span n u -> size v = n -> f v = blossom u (fun i => f (knots u i n)) v.
Proof.
elim: n f u v => [|n ih] f u [|x v] // pf sp [sz]; have [sym lin] := pf.
have pg : polar n (fun w => f (x :: w)).
  split=> [v1 w1 eq_vw | s y t z w szw]; first by apply: sym; rewrite perm_cons.
  have swap y' : f (x :: y' :: w) = f (y' :: x :: w).
    by apply: sym; rewrite -(cat1s x) -(cat1s y') perm_catCA.
  by rewrite !swap lin //= szw.
rewrite (ih _ (shift u) v pg) ?sz //=; last exact: span_shift.
apply: blossom_ext => i le_i.
have ud : u (i + n.+1)%N - u i \is a GRing.unit by apply: sp; lia.
rewrite knots_shift /step sz -[LHS](mulrK ud); congr (_ / _).
have -> : f (knots u i.+1 n.+1) = f (at_ (u (i + n.+1)%N) :: knots u i.+1 n).
  by apply: sym; rewrite knots_last addSnnS perm_rcons.
have szk : (size (knots u i.+1 n)).+1 = n.+1 by rewrite size_knots.
rewrite -lin // [LHS]mulrC.
rewrite [comb _ _ _ _](_ : _ = comb (u (i + n.+1)%N - u i) x 0 x).
  by rewrite lin // mul0r addr0.
by rewrite /comb /at_; congr (_, _) => /=; ring.
Qed.

(** blossoms knots: $c[u_i,\dots,u_{i+n-1}]=c_i$, $i=0..n$.
    Hypotheses: the knots carry a piece, so that its points have a meaning. *)
Theorem blossoms_knots n u c i : span n u -> (i <= n)%N -> blossom u c (knots u i n) = c i.
Proof.
elim: n u c i => [|n ih] u c i sp le_i; first by case: i le_i.
have sp' := span_shift sp.
case: i le_i => [|i] le_i.
  rewrite knotsS -knots_shift [LHS]/= ih // size_knots /step /at_ add0n !mul1r subrr mul0r addr0 mulrC mulKr //.
  by apply: (sp 0%N n.+1); lia.
rewrite knots_last -cats1 blossom_move ?size_knots ?addn0 // cats0 [LHS]/= size_knots -knots_shift ih // /step /at_.
rewrite !mul1r addSnnS subrr mul0r add0r mulrC mulKr //; apply: sp; lia.
Qed.

(** blossoms injective: curves with the same blossom have the same control points.
    Hypotheses: the knots carry a piece, so that its points have a meaning. *)
Theorem blossoms_injective n u c c' :
  span n u -> (forall v, size v = n -> blossom u c v = blossom u c' v) -> forall i, (i <= n)%N -> c i = c' i.
Proof. by move=> sp eq_b i le_i; rewrite -(blossoms_knots c sp le_i) eq_b ?size_knots // blossoms_knots. Qed.

End Blossom.
