(* Programs: products of polynomials in Bernstein form, and a Bezier curve after a polynomial, BZZ19, section 4.
   Definitions (a form f of degree d has d + 1 coefficients, f_i that of (1-X)^(d-i) X^i):
     pascal n               C(n,0), ..., C(n,n)
     form_times f g         the product of two forms
     form_power f k         the power
     form_of e             the form with the Bernstein coefficients e
     form_of_rest e                 the form of 1 - e
     composed_program c e   the Bezier points of c(e(t)), 13
     homogeneous n p        the sum over i = 0..n of p_i X^i (1-X)^(n-i)
     form f                 the polynomial that f stands for *)
From Torse Require Import Prelude Blossom Curves Points Bernstein Bezier Executable Executable_knots.

Section Programs.
Variables (T Q : Type) (K : scalars T) (V : points T Q).
Implicit Types (e f g : seq T) (c : seq Q) (n k i : nat).
Local Notation "x + y" := (sadd K x y).
Local Notation "x - y" := (ssub K x y).
Local Notation "x * y" := (smul K x y).
Local Notation "x / y" := (smul K x (sinv K y)).
Local Notation "f $ i" := (nth (zero K) f i) (at level 8, i at level 8, format "f $ i").

Definition pascal n := iter n (fun (r : seq T) => mkseq (fun i => r$i + (if i is j.+1 then r$j else zero K)) (size r).+1) [:: one K].
Definition form_times f g := mkseq (fun k => total K (fun i => f$i * g$(k - i)%N) 0 k.+1) (size f + size g).-1.
Definition form_power f k := iter k (form_times f) [:: one K].
Definition form_of e := let w := pascal (size e).-1 in mkseq (fun i => e$i * w$i) (size e).
Definition form_of_rest e := let w := pascal (size e).-1 in let r := form_of e in mkseq (fun i => w$i - r$i) (size e).
Definition composed_program c e := given (Nat.ltb 0 (size c) && Nat.ltb 0 (size e)) Vertices (Value (
  let p := (size c).-1 in let d := (size e).-1 in let outer := pascal p in let inner := pascal (p * d)%N in
  let weights := mkseq (fun i => form_times (form_power (form_of_rest e) (p - i)) (form_power (form_of e) i)) (size c) in
  mkseq (fun j => total_of V (fun i => pscale V (outer$i * (nth [::] weights i)$j / inner$j) (nth (origin V) c i)) 0 (size c)) (p * d).+1)).
End Programs.

Section Equal.
Variables (F : fieldType) (m : nat) (lt : F -> F -> bool).
Implicit Types (e f g : seq F) (c : seq 'rV[F]_m) (n k i : nat) (p q : {poly F}).
Local Notation K := (of_field lt).
Local Notation V := (rows F m).
Local Notation at_list := (nth 0).

Let Y : {poly F} := 1 - 'X.
Definition homogeneous n p := \sum_(0 <= i < n.+1) (p`_i)%:P * ('X^i * Y ^+ (n - i)).

Lemma size_pascal n : size (pascal K n) = n.+1.
Proof. by elim: n => // n ih; rewrite /pascal iterS -/(pascal K n) size_mkseq ih. Qed.

Lemma pascalE n i : at_list (pascal K n) i = 'C(n, i)%:R.
Proof.
elim: n i => [|n ih] i; first by case: i => [|[|i]].
rewrite /pascal iterS -/(pascal K n) size_pascal; have [lt_i|ge_i] := ltnP i n.+2; last first.
  by rewrite nth_default ?size_mkseq // bin_small.
by rewrite nth_mkseq // ih; case: i lt_i => [|i] _ /=; rewrite ?ih ?addr0 ?bin0 // binS natrD.
Qed.

Lemma homogeneous_sum n (I : Type) (s : seq I) (w : I -> F) (P : I -> {poly F}) :
  homogeneous n (\sum_(i <- s) (w i)%:P * P i) = \sum_(i <- s) (w i)%:P * homogeneous n (P i).
Proof.
rewrite /homogeneous (eq_bigr (fun j => \sum_(i <- s) ((w i)%:P * ((P i)`_j)%:P * ('X^j * Y ^+ (n - j))))) => [|j _].
  by rewrite exchange_big; apply: eq_bigr => i _; rewrite mulr_sumr; apply: eq_bigr => j _; rewrite -!mulrA.
rewrite coef_sum (raddf_sum (polyC_additive _)) mulr_suml; apply: eq_bigr => i _.
by rewrite coefCM -polyCM.
Qed.

Lemma homogeneous_power n k : (k <= n)%N -> homogeneous n 'X^k = 'X^k * Y ^+ (n - k).
Proof.
move=> le_k; rewrite /homogeneous big_mkord (bigD1 (Ordinal (le_k : k < n.+1)%N)) //= coefXn eqxx mul1r big1 ?addr0 //.
by move=> i ne; rewrite coefXn (_ : (i == k :> nat) = false) ?mul0r //; apply: contra_neqF ne => /eqP e; exact: val_inj.
Qed.

Lemma poly_sum n p : (size p <= n.+1)%N -> p = \sum_(0 <= i < n.+1) (p`_i)%:P * 'X^i.
Proof.
move=> le_p; rewrite -{1}[p]coefK poly_def big_mkord (big_ord_widen _ (fun i => p`_i *: 'X^i) le_p) big_mkcond /=.
by apply: eq_bigr => i _; case: ltnP => [_|le_i]; rewrite mul_polyC // nth_default ?scale0r.
Qed.

(* Products of homogeneous forms are those of polynomials. *)
Lemma homogeneous_mul n k p q : (size p <= n.+1)%N -> (size q <= k.+1)%N ->
  homogeneous n p * homogeneous k q = homogeneous (n + k) (p * q).
Proof.
move=> sp sq; rewrite {2}(poly_sum sp) mulr_suml; under [in RHS]eq_bigr do rewrite -mulrA.
rewrite homogeneous_sum {1}/homogeneous mulr_suml; apply: eq_big_nat => i /andP[_ lt_i]; rewrite -mulrA; congr (_ * _).
rewrite {2}(poly_sum sq) mulr_sumr; under [in RHS]eq_bigr do rewrite mulrCA -exprD.
rewrite homogeneous_sum {1}/homogeneous mulr_sumr; apply: eq_big_nat => j /andP[_ lt_j].
rewrite homogeneous_power; last by lia.
rewrite (_ : (n + k - (i + j) = (n - i) + (k - j))%N); last by lia.
by rewrite !exprD; move: 'X^i 'X^j (Y ^+ _) (Y ^+ (k - j)) => x y z t; ring.
Qed.

Definition form f := homogeneous (size f).-1 (Poly f).

Lemma form_timesE f g : (0 < size f)%N -> (0 < size g)%N ->
  size (form_times K f g) = (size f + size g).-1 /\ form (form_times K f g) = form f * form g.
Proof.
move=> f0 g0; rewrite /form size_mkseq; split=> //; rewrite homogeneous_mul ?prednK ?size_Poly //.
rewrite (_ : (size f + size g).-1.-1 = (size f).-1 + (size g).-1)%N; last by lia.
apply: eq_big_nat => i /andP[_ lt_i]; rewrite coef_Poly nth_mkseq; last by lia.
rewrite totalE coefM big_mkord; congr (_%:P * _); apply: eq_bigr => j _ /=; by rewrite !coef_Poly.
Qed.

Lemma form_powerE f k : (0 < size f)%N ->
  size (form_power K f k) = ((size f).-1 * k).+1 /\ form (form_power K f k) = form f ^+ k.
Proof.
move=> f0; elim: k => [|k [sk ek]]; first by rewrite muln0 /form /homogeneous big_nat1 coef_Poly /= !mulr1.
rewrite /form_power iterS -/(form_power K f k); have [|-> ->] := @form_timesE f (form_power K f k) f0; first by rewrite sk.
by rewrite ek exprS sk mulnS; split=> //; lia.
Qed.

Lemma form_bez n f (w : nat -> F) : size f = n.+1 -> (forall i, (i <= n)%N -> at_list f i = w i * 'C(n, i)%:R) -> form f = bez n w.
Proof.
move=> sf e; rewrite /form sf; apply: eq_big_nat => i /andP[_ lt_i]; rewrite coef_Poly e // polyCM -!mulrA; congr (_ * _).
by rewrite /B polyC_nat.
Qed.

Lemma form_ofE e : (0 < size e)%N -> form (form_of K e) = bez (size e).-1 (at_list e).
Proof.
move=> e0; apply: form_bez; first by rewrite size_mkseq prednK.
by move=> i le_i; rewrite nth_mkseq ?pascalE // -(prednK e0).
Qed.

Lemma bez1 n : bez n (fun=> 1) = 1 :> {poly F}.
Proof. by rewrite /bez -[RHS](B_sum F n); apply: eq_bigr => i _; rewrite mul1r. Qed.

Lemma form_of_restE e : (0 < size e)%N -> form (form_of_rest K e) = 1 - bez (size e).-1 (at_list e).
Proof.
move=> e0; rewrite -(bez1 (size e).-1) -bez_sub; apply: form_bez; first by rewrite size_mkseq prednK.
move=> i le_i; have lt_i : (i < size e)%N by rewrite -(prednK e0).
by rewrite nth_mkseq //= nth_mkseq // !pascalE mulrBl mul1r.
Qed.

Lemma comp_bez n (b : nat -> F) p : bez n b \Po p = \sum_(0 <= i < n.+1) (b i)%:P * ('C(n, i)%:R * (p ^+ i * (1 - p) ^+ (n - i))).
Proof.
rewrite /bez (raddf_sum [additive of comp_poly p]); apply: eq_bigr => i _ /=.
by rewrite /B comp_polyM comp_polyC !rmorphM /= rmorph_nat !rmorphX /= comp_polyB comp_polyX rmorph1.
Qed.

(** BZZ19.13 program: the program gives the Bezier points of $c(e(t))$, of degree $pd$ for $c$ of degree $p$ and $e$ of degree $d$; it gives an error iff one of
    the two has no points.
    Hypotheses: for the points: no $C(pd,j)$ vanishes in the field, as in characteristic 0. *)
Theorem BZZ19_13_program c e (p := (size c).-1) (d := (size e).-1) :
  (forall r, independent F (p * d) -> composed_program K V c e = Value r -> size r = (p * d).+1 /\
    forall k : 'I_m, bez (p * d) (coord (at_list r) k) = bez p (coord (at_list c) k) \Po bez d (at_list e)) /\
  (composed_program K V c e = Fails _ Vertices <-> size c = 0%N \/ size e = 0%N).
Proof.
rewrite /composed_program !nat_ltbE /given; split=> [r ind|]; last first.
  by move: (size c) (size e) => [|k] [|l]; split=> // h; by [left | right | case: h].
case: ifP => // /andP[c0 e0] er; rewrite -(Value_inj er) size_mkseq; split=> // k {r er}.
set f := form_power K (form_of_rest K e); set g := form_power K (form_of K e).
have [sl sr] : size (form_of_rest K e) = d.+1 /\ size (form_of K e) = d.+1 by rewrite !size_mkseq prednK.
have w i : (i <= p)%N -> size (form_times K (f (p - i)%N) (g i)) = (p * d).+1 /\
    form (form_times K (f (p - i)%N) (g i)) = (1 - bez d (at_list e)) ^+ (p - i) * bez d (at_list e) ^+ i.
  move=> le_i; have [] := @form_powerE (form_of_rest K e) (p - i); first by rewrite sl.
  have [] := @form_powerE (form_of K e) i; first by rewrite sr.
  rewrite -/f -/g form_of_restE // form_ofE // sl sr => sg <- sf <-; have [||-> ->] := @form_timesE (f (p - i)%N) (g i); rewrite ?sf ?sg //.
  by split=> //; rewrite addSn addnS /= -mulnDr subnK // mulnC.
rewrite comp_bez [LHS](_ : _ = \sum_(0 <= i < p.+1) (coord (at_list c) k i * 'C(p, i)%:R)%:P * form (form_times K (f (p - i)%N) (g i))).
  apply: eq_big_nat => i /andP[_ le_i]; have [_ ->] := w i le_i; rewrite polyCM polyC_nat -mulrA; congr (_ * (_ * _)); exact: mulrC.
rewrite /form; under [RHS]eq_big_nat => i le_i do rewrite (proj1 (w i _)) //; rewrite -homogeneous_sum.
apply: eq_big_nat => j /andP[_ lt_j]; rewrite /B mulrA -polyC_nat -polyCM; congr (_%:P * _).
rewrite /coord nth_mkseq // total_ofE summxE mulr_suml coef_sum prednK //; apply: eq_big_nat => i /andP[_ lt_i].
rewrite !mxE !pascalE /= nth_mkseq // coefCM coef_Poly.
have := ind j lt_j; rewrite -/p -/d.
move: ('C(p * d, j)%:R : F) ('C(p, i)%:R : F) (at_list (form_times K (f (p - i)%N) (g i)) j) (at_list c i 0 k) => w0 x y z nz.
by field.
Qed.
End Equal.
