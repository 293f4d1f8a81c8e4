(* FJ21, (4.3) over the rational functions: what happens without the hypotheses of the theorems, one counterexample each, and why the example of
   FJ21_4_gauge.v without a rational factor is none in characteristic 2. *)
From Torse Require Import Prelude Blossom Curves Points Functions FJ21_3_theorem FJ21_3_needs FJ21_4_gauge.

Section Needs.
Variable F : fieldType.
Notation K := {fraction {poly F}}.
Implicit Types (m : nat) (lam mu nu : K).

Lemma fderiv0 : fderiv (0 : K) = 0.
Proof. by rewrite -tofrac0 fderiv_poly linear0 tofrac0. Qed.

Lemma fderiv1 : fderiv (1 : K) = 0.
Proof. by rewrite -tofrac1 fderiv_poly -polyC1 derivC tofrac0. Qed.

(** FJ21.4.3 functions_needs_factor: for $f=0$ all rows $fp$, $fq$ have all frames, and $p=(1,t,t^2,0)$, $q=p+(0,0,0,1)$ none: whatever stands for $f'/f$ the rule fails. *)
Theorem FJ21_4_3_functions_needs_factor (P : 'rV[K]_4 := pfun (row4 1 'X ('X ^+ 2) 0)) (Q : 'rV[K]_4 := pfun (row4 1 'X ('X ^+ 2) 1)) :
  (forall lam mu nu, fframe (0 *: P) (0 *: Q) lam mu nu) /\ forall lam mu nu, ~ fframe P Q lam mu nu.
Proof.
split=> lam mu nu; last by have [_] := FJ21_4_3_needs_turning F; apply.
by rewrite /fframe !scale0r subrr !scaler0 /pfderiv !addr0; apply/rowP=> k; rewrite !mxE fderiv0 !mulr0 addr0.
Qed.

(** FJ21.4.3 cancel_needs_free: for $p=A$, $q=2A$, where $W=p$ and $W'=0$: $\lambda=-1$, $\mu=0$, $\nu=1$ is a frame, but $f=1$ leaves one with $\nu=0$, and
    $f'=0\ne-\nu f$. *)
Theorem FJ21_4_3_cancel_needs_free m (A : 'rV[F]_m) (P : 'rV[K]_m := pfun (map_mx polyC A)) (Q := P + P) :
  [/\ fframe P Q (-1) 0 1, fframe (1 *: P) (1 *: Q) 0 0 0 & fderiv (1 : K) <> - (1 * 1)].
Proof.
have dP : pfderiv P = 0 by rewrite pfderiv_fun; apply/rowP=> k; rewrite !mxE derivC tofrac0.
split.
- by rewrite /fframe dP /Q addrK !scale0r addr0 scaleN1r scale1r addNr.
- by rewrite /fframe !scale1r dP !scale0r !addr0.
by rewrite fderiv1 mulr1 => /eqP; rewrite eq_sym oppr_eq0 oner_eq0.
Qed.
End Needs.

Section Characteristic.
Variable F : fieldType.
Notation K := {fraction {poly F}}.
Implicit Types (lam mu nu x : K).

Lemma double0 (g : {poly F}) : 2%:R = 0 :> F -> g *+ 2 = 0.
Proof. by move=> two; rewrite -mulr_natl -(rmorph_nat [rmorphism of @polyC F]) two rmorph0 mul0r. Qed.

(* In characteristic 2 every rational function has the second derivative 0. *)
Lemma second_derivative x : 2%:R = 0 :> F -> fderiv (fderiv x) = 0.
Proof.
move=> two; have second (g : {poly F}) : g^`()^`() = 0 by rewrite -derivn1 -derivSn nderivn_def double0.
have [f [g [g0 ->]]] := fraction_ex x; rewrite !fderiv_div ?expf_neq0 // deriv_exp -[_ *+ 2]mulr_natl.
have -> : (2%:R : {poly F}) = 0 by rewrite -(rmorph_nat [rmorphism of @polyC F]) two rmorph0.
rewrite mul0r mulr0 subr0 derivB !derivM !second mul0r mulr0 add0r addr0 subrr mul0r tofrac0 mul0r //.
Qed.

(** FJ21.4.3 characteristic: in characteristic 2 a factor is always there: $f=\nu$, as $\nu'=-\nu^2$.
    Hypotheses: $2=0$ in the field; $p$, $W$, $W'$ are independent over the rational functions. *)
Theorem FJ21_4_3_characteristic m (P Q : 'rV[K]_m) lam mu nu : 2%:R = 0 :> F -> free P (Q - P) (pfderiv (Q - P)) ->
  fframe P Q lam mu nu -> exists lam' mu', fframe (nu *: P) (nu *: Q) lam' mu' 0.
Proof.
move=> two fr e; apply/(FJ21_4_3_cancel nu fr e).
have second (R : 'rV[K]_m) : pfderiv (pfderiv R) = 0 by apply/rowP=> k; rewrite !mxE second_derivative.
have derivD (R S : 'rV[K]_m) : pfderiv (R + S) = pfderiv R + pfderiv S by apply/rowP=> k; rewrite !mxE fderivD.
move: e; rewrite /fframe; move: (Q - P) fr => V fr e.
have := second P; rewrite {1}e !derivD !pfderivZ second e scaler0 addr0; move: (pfderiv V) fr => V' fr e2.
have /fr[+ _ _] : (fderiv nu + nu * nu) *: P + (fderiv lam + nu * lam) *: V + (lam + fderiv mu + nu * mu) *: V' = 0.
  by rewrite -[RHS]e2; by_entries k; ring.
by move/eqP; rewrite addr_eq0 => /eqP.
Qed.
End Characteristic.
