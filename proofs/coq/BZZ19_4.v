(* BZZ19, section 4: the pieces of the B-spline surface, Algorithm 1.
   Definitions:
     in_bernstein n p i    the sum over k of C(i,k)/C(n,k) times the coefficient k of p: the Bernstein coefficients of p *)
From Torse Require Import Prelude Blossom Curves Points Bernstein Bezier.

Section Polynomials.
Variable F : fieldType.
Implicit Types (c s : nat -> F) (p q : {poly F}) (n d k i : nat).

Definition in_bernstein n p i : F := \sum_(0 <= k < n.+1) 'C(i, k)%:R / 'C(n, k)%:R * p`_k.

(** BZZ19.14 power: $t^k=\sum_i\frac{C(i,k)}{C(D,k)}B_i^D(t)$ for $k\le D$.
    Hypotheses: $C(D,k)\ne0$ in the field. *)
Theorem BZZ19_14_power n k : (k <= n)%N -> 'C(n, k)%:R != 0 :> F ->
  'X^k = bez n (fun i => 'C(i, k)%:R / 'C(n, k)%:R : F).
Proof.
move=> le_k nz; have e : ('C(n, k)%:R : F)%:P * 'X^k = bez n (fun i => 'C(i, k)%:R) by rewrite power_bez // polyC_nat.
rewrite (bez_ext (d := fun i => 'C(n, k)%:R^-1 * 'C(i, k)%:R)); last by move=> i _; rewrite mulrC.
by rewrite bez_scale -e mulrA -polyCM mulVf // mul1r.
Qed.

(** BZZ19.14 bernstein: a polynomial of degree at most $D$ has the Bernstein coefficients $\sum_k\frac{C(i,k)}{C(D,k)}a_k$.
    Hypotheses: no $C(D,k)$ vanishes in the field, as in characteristic 0. *)
Theorem BZZ19_14_bernstein n p : (forall k, (k <= n)%N -> 'C(n, k)%:R != 0 :> F) -> (size p <= n.+1)%N ->
  p = bez n (in_bernstein n p).
Proof.
move=> nz le_p; rewrite -{1}[p]coefK poly_def.
have -> : \sum_(i < size p) p`_i *: 'X^i = \sum_(0 <= k < n.+1) p`_k *: 'X^k.
  rewrite big_mkord (big_ord_widen _ (fun k => p`_k *: 'X^k) le_p) big_mkcond /=; apply: eq_bigr => k _.
  by case: ltnP => // le_k; rewrite nth_default // scale0r.
rewrite /bez /in_bernstein.
rewrite (eq_big_nat _ _ (F2 := fun k => \sum_(0 <= i < n.+1) ('C(i, k)%:R / 'C(n, k)%:R * p`_k)%:P * B F n i)); last first.
  move=> k /andP[_ lt_k]; rewrite [X in _ *: X](BZZ19_14_power (n := n) lt_k) ?nz // -mul_polyC /bez mulr_sumr.
  by apply: eq_big_nat => i _; rewrite mulrA -polyCM mulrC [p`_k * _]mulrC mulrC.
rewrite exchange_big /=; apply: eq_big_nat => i _; rewrite -mulr_suml; congr (_ * _).
by rewrite (raddf_sum (polyC_additive _)).
Qed.

Lemma size_bez n c : (size (bez n c) <= n.+1)%N.
Proof.
rewrite /bez (leq_trans (size_sum _ _ _)) // big_mkord; apply/bigmax_leqP => i _.
rewrite mul_polyC (leq_trans (size_scale_leq _ _)) // /B -polyC_nat mul_polyC (leq_trans (size_scale_leq _ _)) //.
rewrite (leq_trans (size_mul_leq _ _)) // size_polyXn /=.
set Y : {poly F} := 1 - 'X; have sY : (size (Y ^+ (n - i))%R <= (n - i).+1)%N.
  rewrite (leq_trans (size_exp_leq _ _)) // ltnS -[X in (_ <= X)%N]mul1n leq_mul2r.
  by rewrite /Y -opprB size_opp (_ : 'X - 1 = 'X - 1%:P) // size_XsubC orbT.
by rewrite (leq_trans (leq_add (leqnn _) sY)) // addnS ltnS subnKC // -ltnS.
Qed.

(** BZZ19.13 composition: $C_2(\sigma(t))$ of degree $p$ after $d$ is a Bezier curve of degree $pd$.
    Hypotheses: no $C(pd,k)$ vanishes in the field, as in characteristic 0. *)
Theorem BZZ19_13_composition n d c s : (forall k, (k <= n * d)%N -> 'C(n * d, k)%:R != 0 :> F) ->
  bez n c \Po bez d s = bez (n * d) (in_bernstein (n * d) (bez n c \Po bez d s)).
Proof.
move=> nz; apply: BZZ19_14_bernstein => //.
apply: leq_trans (size_comp_poly_leq _ _) _; rewrite ltnS.
by apply: leq_mul; rewrite -ltnS -[X in (X < _)%N]subn1 -?subn1 ltnS leq_subLR add1n size_bez.
Qed.

(** BZZ19.15 elevation: $(D+1)\sum_ic_iB_i^D=\sum_i(ic_{i-1}+(D+1-i)c_i)B_i^{D+1}$. *)
Theorem BZZ19_15_elevation n c : n.+1%:R%:P * bez n c = bez n.+1 (fun i => i%:R * prev c i + (n.+1 - i)%:R * c i).
Proof. exact: elevate_bez. Qed.

End Polynomials.
