(* ZW06, the method in general: the square case has a solution. *)
From Torse Require Import Prelude Blossom Curves Points Bernstein Bezier BZZ19_4 ZW06 ZW06_system.

Section Square.
Variables (F : fieldType) (m : nat).
Implicit Types (p tau : nat -> 'rV[F]_m) (a beta : F) (g h : {poly F}) (n k : nat).

(* One coordinate, from the leading coefficient down. *)
Lemma square_solution n a (b0 : F) beta g : (forall k, (k <= n)%N -> a + k%:R * beta != 0) -> (size g <= n.+1)%N ->
  exists h, (size h <= n.+1)%N /\ a%:P * h + (b0%:P + beta%:P * 'X) * h^`() = g.
Proof.
move=> nz; have [k] := ubnP (size g); elim: k g => // k ih g; rewrite ltnS => le_k le_n.
have [->|g0] := eqVneq g 0; first by exists 0; rewrite size_poly0 linear0 !mulr0 addr0.
case: k ih le_k => [|k] ih le_k; first by move: le_k; rewrite leqn0 size_poly_eq0 (negPf g0).
have [lt_k|le_kn] := ltnP n k; first by apply: ih => //; apply: leq_ltn_trans le_n _.
pose x := g`_k / (a + k%:R * beta); pose top : {poly F} := x *: 'X^k.
pose image : {poly F} := a%:P * top + (b0%:P + beta%:P * 'X) * top^`().
have co j : image`_j = (a + j%:R * beta) * top`_j + j.+1%:R * b0 * top`_j.+1 by exact: coef_along.
have zero j : (k < j)%N -> top`_j = 0 by move=> lt_j; rewrite coefZ coefXn gtn_eqF // mulr0.
have [||h [sh eh]] := ih (g - image).
- rewrite ltnS; apply/leq_sizeP=> j; rewrite leq_eqVlt coefB co => /orP[/eqP <-|lt_j].
    by rewrite (zero k.+1) // !mulr0 addr0 coefZ coefXn eqxx mulr1 /x mulrC divfK ?nz // subrr.
  by rewrite !zero ?mulr0 ?addr0 ?subr0 ?(leqW lt_j) // nth_default //; exact: leq_trans le_k lt_j.
- rewrite (leq_trans (size_add _ _)) // geq_max le_n size_opp; apply/leq_sizeP=> j le_j.
  by have kj : (k < j)%N := leq_ltn_trans le_kn le_j; rewrite co !zero ?(leqW kj) // !mulr0 addr0.
exists (h + top); split.
  by rewrite (leq_trans (size_add _ _)) // geq_max sh (leq_trans (size_scale_leq _ _)) // size_polyXn ltnS.
rewrite derivD !mulrDr addrACA eh -/image; exact: subrK.
Qed.

(** ZW06.G square_exists: for constant $a$ and $b=b_0+\beta u$ with $a+k\beta\ne0$, $k=0..n$, the system has exactly one solution $\tau_0,\dots,\tau_n$, whatever the
    directrix.
    Hypotheses: $a+k\beta\ne0$ for $k=0..n$; no $C(n,i)$ vanishes in the field, as in characteristic 0. *)
Theorem ZW06_G_square_exists n p a (b0 : F) beta : independent F n -> (forall k, (k <= n)%N -> a + k%:R * beta != 0) ->
  exists tau, solves n p a%:P (b0%:P + beta%:P * 'X) tau /\
    forall tau', solves n p a%:P (b0%:P + beta%:P * 'X) tau' -> forall i, (i <= n)%N -> tau' i = tau i.
Proof.
move=> ind nz; set b := b0%:P + beta%:P * 'X.
have sd (k : 'I_m) : (size (pderiv (pbez n p) 0%R k) <= n.+1)%N.
  rewrite !mxE; have [->|d0] := eqVneq (bez n (coord p k)) 0; first by rewrite linear0 size_poly0.
  exact: leq_trans (ltnW (lt_size_deriv d0)) (size_bez _ _).
have some (k : 'I_m) : exists h, (size h <= n.+1)%N && (a%:P * h + b * h^`() == pderiv (pbez n p) 0 k).
  by have [h [sh eh]] := square_solution b0 nz (sd k); exists h; rewrite sh /b eh eqxx.
have [sol spec] : exists sol : 'I_m -> {poly F}, forall k : 'I_m, (size (sol k) <= n.+1)%N /\ a%:P * sol k + b * (sol k)^`() = pderiv (pbez n p) 0 k.
  by exists (fun k : 'I_m => xchoose (some k)) => k; have /andP[sk /eqP ek] := xchooseP (some k).
exists (fun i => \row_k in_bernstein n (sol k) i).
have eq_sol : solves n p a%:P b (fun i => \row_k in_bernstein n (sol k) i).
  apply/rowP=> k; have [sk ek] := spec k.
  have e : bez n (coord (fun i => \row_k in_bernstein n (sol k) i) k) = sol k.
    rewrite [RHS](BZZ19_14_bernstein ind sk); apply: bez_ext => i _; by rewrite /coord mxE.
  by rewrite -ek !mxE e.
split=> // tau' eq_tau' i le_i; apply/rowP=> k; apply/eqP; rewrite -subr_eq0; apply/eqP.
apply: (ZW06_G_square (b0 := b0) (kappa := fun j => coord tau' k j - coord (fun i => \row_k in_bernstein n (sol k) i) k j) ind nz _ le_i).
rewrite -/b bez_sub derivB !mulrBr addrACA -opprD.
have := congr1 (fun r : 'rV_m => r 0 k) eq_sol; have := congr1 (fun r : 'rV_m => r 0 k) eq_tau'; rewrite !mxE => <- <-.
by rewrite subrr.
Qed.
End Square.
