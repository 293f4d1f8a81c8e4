(* ZW06, the method as a linear system: what happens without the hypotheses of the theorems, one counterexample each. *)
From Torse Require Import Prelude Blossom Curves Points Bernstein Bezier BZZ19_4 ZW06 ZW06_system Needs_FJ07 Needs_ZW06.

Section Needs.
Variable F : fieldType.
Implicit Types (n i k : nat) (kappa : nat -> F).

(** ZW06.G needs_factor: where $a+k\beta=0$ and $b=\beta u$ the system without right side has the solution $u^k$. *)
Theorem ZW06_G_needs_factor (a beta : F) k : a + k%:R * beta = 0 -> a%:P * 'X^k + (beta%:P * 'X) * ('X^k)^`() = 0.
Proof.
move=> e; have -> : a = - (k%:R * beta) by apply/eqP; rewrite -addr_eq0 e.
rewrite derivXn; case: k {e} => [|k]; first by rewrite mulr0n mulr0 mul0r oppr0 polyC0 mul0r addr0.
rewrite -['X^k.+1.-1 *+ k.+1]mulr_natl exprS polyCN polyCM polyC_nat.
by move: (k.+1%:R : {poly F}) (beta%:P) ('X^k : {poly F}) => x y z; ring.
Qed.

Lemma bez_one n : bez n (fun=> 1 : F) = 1.
Proof. by rewrite -(B_sum F n); apply: eq_big_nat => i _; rewrite polyC1 mul1r. Qed.

(** ZW06.G family_needs_factorial: where $k=0$ in the field, $1\le k\le n$, $\tau'=0$ ($a=0$, $b=1$) has the solutions $\kappa_i=1$ and $\kappa'_i=C(i,k)$, which is no
    multiple of the first. *)
Theorem ZW06_G_family_needs_factorial n k (kappa := fun=> 1 : F) (kappa' := fun i => 'C(i, k)%:R : F) : (0 < k <= n)%N -> k%:R = 0 :> F ->
  [/\ 0 * bez n kappa + 1 * (bez n kappa)^`() = 0, 0 * bez n kappa' + 1 * (bez n kappa')^`() = 0 &
      ~ exists s, forall i, (i <= n)%N -> kappa' i = s * kappa i].
Proof.
case/andP=> k1 le_k k0; split; rewrite ?mul0r ?add0r ?mul1r.
- by rewrite bez_one -polyC1 derivC.
- have /rowP/(_ 0) := chosen_deriv le_k k0; rewrite !mxE => <-; congr (_^`()).
  by apply: bez_ext => i _; rewrite /coord mxE.
case=> s h; have := h k le_k; rewrite -(h 0%N isT) /kappa' binn bin_small // => /eqP.
by rewrite oner_eq0.
Qed.

(** ZW06.G family_needs_equation: for $a=b=0$ all rows are solutions, $\kappa_i=1$ and $\kappa'_i=i$ for $n\ge1$. *)
Theorem ZW06_G_family_needs_equation n kappa : 0 * bez n kappa + 0 * (bez n kappa)^`() = 0 /\
  ~ exists s, forall i, (i <= n.+1)%N -> i%:R = s * 1 :> F.
Proof.
split=> [|[s h]]; first by rewrite !mul0r addr0.
by have := h 1%N isT; rewrite -(h 0%N isT) => /eqP; rewrite oner_eq0.
Qed.

(** ZW06.G family_needs_nonzero: $\kappa=0$ is a solution and spans none but itself, not $\kappa'_i=1$ with $\tau'=0$ ($a=0$, $b=1$). *)
Theorem ZW06_G_family_needs_nonzero n : 0 * bez n (fun=> 1 : F) + 1 * (bez n (fun=> 1 : F))^`() = 0 /\
  ~ exists s, forall i, (i <= n)%N -> 1 = s * 0 :> F.
Proof.
split=> [|[s h]]; first by rewrite bez_one -polyC1 derivC !(mul0r, mulr0) addr0.
by move/eqP: (h 0%N isT); rewrite mulr0 oner_eq0.
Qed.

(** ZW06.G square_needs_binomials: where $C(n,i)=0$ in the field the row $\kappa_i=1$, all others 0, solves the system without right side for all $a$, $b$. *)
Theorem ZW06_G_square_needs_binomials n i (a b : {poly F}) (kappa := fun j => (j == i)%:R : F) : 'C(n, i)%:R = 0 :> F ->
  a * bez n kappa + b * (bez n kappa)^`() = 0 /\ kappa i <> 0.
Proof.
move=> /hidden/rowP/(_ 0); rewrite !mxE => e; have -> : bez n kappa = 0.
  by rewrite -[RHS]e; apply: bez_ext => j _; rewrite /coord mxE.
by rewrite linear0 !mulr0 addr0 /kappa eqxx; split=> //; apply/eqP; rewrite oner_eq0.
Qed.

(** ZW06.G.unique needs_binomials: there a row that solves $a'=a\tau+b\tau'$ still does when every coordinate of $\tau_i$ has 1 added. *)
Theorem ZW06_G_unique_needs_binomials m n i (p tau : nat -> 'rV[F]_m) (a b : {poly F}) : 'C(n, i)%:R = 0 :> F -> solves n p a b tau ->
  solves n p a b (fun j => tau j + const_mx (j == i)%:R).
Proof.
move=> e; rewrite /solves => ->; have -> // : pbez n (fun j => tau j + const_mx (j == i)%:R) = pbez n tau.
apply/rowP=> k; rewrite !mxE -[RHS]addr0; have /rowP/(_ 0) := hidden e; rewrite !mxE => <-; rewrite -bez_add.
by apply: bez_ext => j _; rewrite /coord !mxE.
Qed.

(** ZW06.G unique_needs_dimension: in a space of dimension 0 there is one row only, though for $a=b=0$ every $\kappa$ is a solution. *)
Theorem ZW06_G_unique_needs_dimension n (p tau tau' : nat -> 'rV[F]_0) kappa i :
  [/\ solves n p 0 0 tau, tau' i = tau i & 0 * bez n kappa + 0 * (bez n kappa)^`() = 0].
Proof. by split; [apply/rowP=> -[] | apply/rowP=> -[] | rewrite !mul0r addr0]. Qed.

(** ZW06.G unique_needs_solution: for $a=b=0$ the directrix $p=(0,1)$, $n=1$, has no solution, so that all are equal, and every $\kappa$ is one without
    right side. *)
Theorem ZW06_G_unique_needs_solution (p := on_line [:: 0; 1 : F]) tau kappa :
  ~ solves 1 p 0 0 tau /\ 0 * bez 1 kappa + 0 * (bez 1 kappa)^`() = 0.
Proof.
split; last by rewrite !mul0r addr0.
by rewrite /solves !scale0r addr0 => e; apply: (@ZW06_12_needs_rho F 0); rewrite scale0r.
Qed.

Lemma side0 D j n : \row_k in_bernstein D (pderiv (pbez n (zero F)) 0 k) j = 0.
Proof. by rewrite pbez0 deriv0; apply/rowP=> k; rewrite !mxE /in_bernstein big1 // => l _; rewrite coef0 mulr0. Qed.

Lemma unsolved n (tau : nat -> 'rV[F]_1) (a b : {poly F}) : a * bez n (coord tau 0) + b * (bez n (coord tau 0))^`() != 0 ->
  ~ solves n (zero F) a b tau.
Proof. by move=> h; rewrite /solves pbez0 deriv0 => /rowP/(_ 0); rewrite !mxE => e; rewrite -e eqxx in h. Qed.

(** ZW06.G system_needs_degree: where $D$ is too small the system misses the high powers: $n=D=0$, $a=u$, $b=0$; $n=D=1$, $a=0$, $b=u^2$; and $n=1$, $D=0$, $a=1$,
    $b=0$, where $D<n$. With $p=0$ the row $\tau=(1)$, in the other two $\tau=(0,1)$, obeys it and is no solution. *)
Theorem ZW06_G_system_needs_degree
    (obeys := fun n D (a b : {poly F}) (tau : nat -> 'rV[F]_1) => forall j, (j <= D)%N ->
      \sum_(0 <= i < n.+1) in_bernstein D (column n a b i) j *: tau i = \row_k in_bernstein D (pderiv (pbez n (zero F)) 0 k) j) :
  [/\ obeys 0%N 0%N 'X 0 (on_line [:: 1]) /\ ~ solves 0 (zero F) 'X 0 (on_line [:: 1]),
      obeys 1%N 1%N 0 'X^2 (on_line [:: 0; 1]) /\ ~ solves 1 (zero F) 0 'X^2 (on_line [:: 0; 1]) &
      obeys 1%N 0%N 1 0 (on_line [:: 0; 1]) /\ ~ solves 1 (zero F) 1 0 (on_line [:: 0; 1])].
Proof.
have tau0 : on_line [:: 0; 1 : F] 0 = 0 by apply/rowP=> k; rewrite !mxE.
split; split; rewrite /obeys.
- move=> j _; rewrite side0 // big_nat1 /in_bernstein big_nat1 /column mul0r addr0 coefXM /= mulr0 scale0r //.
- apply: unsolved; rewrite mul0r addr0 /bez big_nat1 /coord mxE /= polyC1 mul1r /B bin0 expr0 subnn expr0 !mulr1.
  by rewrite polyX_eq0.
- move=> j _; rewrite side0 // big_nat_recr //= big_nat1 tau0 scaler0 add0r.
  rewrite /in_bernstein big_nat_recr //= big_nat1 /column mul0r add0r !coefXnM /= !mulr0 addr0 scale0r //.
- apply: unsolved; rewrite bez_line mul0r add0r derivX mulr1.
  by rewrite -size_poly_eq0 size_polyXn.
- move=> j _; rewrite side0 // big_nat_recr //= big_nat1 tau0 scaler0 add0r.
  by rewrite /in_bernstein big_nat1 /column mul1r mul0r addr0 /B binn expr1 subnn expr0 mulr1 mul1r coefX /= mulr0 scale0r.
by apply: unsolved; rewrite bez_line mul0r addr0 mul1r polyX_eq0.
Qed.
End Needs.
