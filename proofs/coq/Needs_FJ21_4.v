(* FJ21, (4.3) over the rational functions: what happens without the hypotheses of the theorems, one counterexample each. *)
From mathcomp Require Import all_ssreflect all_algebra ring zify.
From Torse Require Import Blossom Curves Points Functions FJ21_3_theorem FJ21_3_needs FJ21_4_gauge.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Import GRing.Theory.
Local Open Scope ring_scope.

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
