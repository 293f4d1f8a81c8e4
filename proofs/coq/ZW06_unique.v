(* ZW06, the method for a constant and b of degree one: the determinant of the system, the recursion of its solution, and when there is exactly one.
   Definitions:
     system n a b    the matrix of the system in degree n: the Bernstein coefficients of a B_i + b B_i', row j and column i
     in_powers n     the coefficients of the B_i, row k and column i *)
From Torse Require Import Prelude Blossom Curves Points Bernstein Bezier BZZ19_4 ZW06 ZW06_system ZW06_square.

Section Unique.
Variables (F : fieldType) (m : nat).
Implicit Types (p tau : nat -> 'rV[F]_m) (a beta : F) (b g h : {poly F}) (n i j k : nat).

Definition system n a b : 'M[F]_n.+1 := \matrix_(j, i) in_bernstein n (column n a%:P b i) j.
Definition in_powers n : 'M[F]_n.+1 := \matrix_(k, i) (B F n i)`_k.

Lemma B_bez n i : (i <= n)%N -> B F n i = bez n (fun j => (j == i)%:R).
Proof.
move=> le_i; rewrite /bez big_mkord (bigD1 (Ordinal (n := n.+1) le_i)) //= eqxx mul1r big1 ?addr0 // => j ne.
by rewrite (_ : (j == i :> nat) = false) ?mul0r //; apply/negbTE.
Qed.

Lemma bez_out n (c : nat -> F) k : (n < k)%N -> (bez n c)`_k = 0.
Proof. by move=> lt_k; rewrite nth_default // (leq_trans (size_bez _ _)). Qed.

(** ZW06.G.unique recursion: for constant $a$ and $b=b_0+\beta u$ the points $\tau_i$ solve $a'=a\tau+b\tau'$ iff the coefficients $t_k$ of $\tau=\sum_kt_ku^k$ obey
    $(a+k\beta)t_k=g_k-(k+1)b_0t_{k+1}$, $k=0..n$, where $a'=\sum_kg_ku^k$ is the derivative of the directrix. *)
Theorem ZW06_G_unique_recursion n p tau a (b0 : F) beta : solves n p a%:P (b0%:P + beta%:P * 'X) tau <->
  forall k (i : 'I_m), (k <= n)%N -> (a + k%:R * beta) * (pbez n tau 0 i)`_k = (pderiv (pbez n p) 0 i)`_k - k.+1%:R * b0 * (pbez n tau 0 i)`_k.+1.
Proof.
split=> [/rowP e k i _|e]; first by have := congr1 (fun g : {poly F} => g`_k) (e i); rewrite !mxE coef_along => ->; rewrite addrK.
apply/rowP=> i; apply/polyP=> k; rewrite !mxE coef_along; have [le_k|lt_k] := leqP k n.
  by have := e k i le_k; rewrite !mxE => ->; rewrite subrK.
by rewrite coef_deriv !bez_out ?leqW // mul0rn !mulr0 addr0.
Qed.
Lemma coef_B n i k : (k <= i)%N -> (B F n i)`_k = if k == i then 'C(n, i)%:R else 0.
Proof.
move=> le_k; rewrite /B mulr_natl coefMn coefXnM; have [->|ne] := eqVneq k i; last by rewrite ltn_neqAle ne le_k /= mul0rn.
by rewrite ltnn subnn -horner_coef0 horner_exp hornerD hornerN hornerC hornerX subr0 expr1n.
Qed.

Lemma det_in_powers n : \det (in_powers n) = \prod_(i < n.+1) 'C(n, i)%:R.
Proof.
rewrite det_trig; first by apply: eq_bigr => i _; rewrite mxE coef_B // eqxx.
by apply/is_trig_mxP=> i j lt_i; rewrite mxE coef_B ?(ltnW lt_i) // ltn_eqF.
Qed.

(* The system in powers: the matrix of the recursion. *)
Lemma system_in_powers n a (b0 : F) beta : independent F n ->
  in_powers n *m system n a (b0%:P + beta%:P * 'X)
    = (\matrix_(k, l) ((a + k%:R * beta) *+ (l == k) + (k.+1%:R * b0) *+ (l == k.+1 :> nat))) *m in_powers n.
Proof.
move=> ind; apply/matrixP=> k i; rewrite !mxE.
have le_i : (i <= n)%N by rewrite -ltnS.
have sc : (size (column n a%:P (b0%:P + beta%:P * 'X) i) <= n.+1)%N.
  rewrite /column B_bez //; apply: size_along; rewrite ?subnn ?size_polyC_leq1 //.
  rewrite (leq_trans (size_add _ _)) // geq_max (leq_trans (size_polyC_leq1 _)) //.
  by rewrite mul_polyC (leq_trans (size_scale_leq _ _)) // size_polyX.
transitivity ((column n a%:P (b0%:P + beta%:P * 'X) i)`_k).
  rewrite [in RHS](BZZ19_14_bernstein ind sc) /bez big_mkord coef_sum.
  by apply: eq_bigr => j _; rewrite !mxE coefCM mulrC.
rewrite /column coef_along; under eq_bigr do rewrite !mxE mulrDl.
rewrite big_split /=; congr (_ + _).
  by rewrite (bigD1 k) //= eqxx big1 ?addr0 // => j /negPf ->; rewrite mul0r.
have [lt_k|le_k] := ltnP k n.
  rewrite (bigD1 (Ordinal (n := n.+1) (lt_k : (k.+1 < n.+1)%N))) //= eqxx big1 ?addr0 // => j ne.
  by rewrite (_ : (j == k.+1 :> nat) = false) ?mul0r //; apply/negbTE.
rewrite B_bez // bez_out ?mulr0 // big1 // => j _.
by rewrite ltn_eqF ?mul0r // (leq_trans (ltn_ord j)).
Qed.

(** ZW06.G.unique determinant: for constant $a$ and $b=b_0+\beta u$ the determinant of the system is $\prod_{k=0}^n(a+k\beta)$.
    Hypotheses: no $C(n,i)$ vanishes in the field, as in characteristic 0, so that the system has a meaning. *)
Theorem ZW06_G_unique_determinant n a (b0 : F) beta : independent F n ->
  \det (system n a (b0%:P + beta%:P * 'X)) = \prod_(k < n.+1) (a + k%:R * beta).
Proof.
move=> ind; have nz : \det (in_powers n) != 0.
  by rewrite det_in_powers; apply/prodf_neq0 => i _; apply: ind; rewrite -ltnS.
apply: (mulfI nz); rewrite -det_mulmx system_in_powers // det_mulmx mulrC; congr (_ * _).
rewrite -det_tr det_trig; first by apply: eq_bigr => k _; rewrite !mxE eqxx (ltn_eqF (ltnSn k)) addr0.
apply/is_trig_mxP=> i j lt_i; rewrite !mxE (ltn_eqF (leqW lt_i : (i < j.+1)%N)).
by rewrite (_ : (i == j) = false) ?addr0 // -val_eqE /= ltn_eqF.
Qed.

(** ZW06.G.unique exactly: a directrix $p$ has only one solution $\tau$ iff $a+k\beta\ne0$ for $k=0..n$; the solutions with right side 0 are the null vectors of
    the matrix of the system.
    Hypotheses: $p$ has a solution; the space has a dimension; no $C(n,i)$ vanishes in the field, as in characteristic 0. *)
Theorem ZW06_G_unique_exactly n p tau a (b0 : F) beta (b := b0%:P + beta%:P * 'X) : (0 < m)%N -> independent F n -> solves n p a%:P b tau ->
  (forall tau', solves n p a%:P b tau' -> forall i, (i <= n)%N -> tau' i = tau i) <-> (forall k, (k <= n)%N -> a + k%:R * beta != 0).
Proof.
move=> m0 ind sol; rewrite (ZW06_G_unique m0 sol); split=> [triv k le_k|nz kappa]; last exact: ZW06_G_square ind nz.
apply/eqP=> ak; have : \det (system n a b)^T == 0.
  by rewrite det_tr ZW06_G_unique_determinant // (bigD1 (Ordinal (n := n.+1) le_k)) //= ak mul0r.
case/det0P=> v v0 /rowP ev; move/eqP: v0; apply; apply/rowP=> i; rewrite mxE.
pose kappa j := if insub j is Some i then v 0 i else 0.
have kE (j : 'I_n.+1) : kappa j = v 0 j by rewrite /kappa valK.
rewrite -kE; apply: triv (ltn_ord i); rewrite along_columns.
have sz : (size (\sum_(0 <= i < n.+1) (kappa i)%:P * column n a%:P b i)%R <= n.+1)%N.
  rewrite -along_columns; apply: size_along; rewrite ?subnn ?size_polyC_leq1 //.
  rewrite (leq_trans (size_add _ _)) // geq_max (leq_trans (size_polyC_leq1 _)) //.
  by rewrite mul_polyC (leq_trans (size_scale_leq _ _)) // size_polyX.
rewrite (BZZ19_14_bernstein ind sz) (@bez_ext _ _ _ (fun=> 0)); first by rewrite /bez big1 // => j _; rewrite mul0r.
move=> j le_j; rewrite in_bernstein_sum big_mkord; have := ev (Ordinal (n := n.+1) le_j); rewrite !mxE => e.
by rewrite -[RHS]e; apply: eq_bigr => l _; rewrite !mxE kE.
Qed.
End Unique.
