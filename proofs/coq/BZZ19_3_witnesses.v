(* BZZ19, section 3.1: an increasing mapping gives neither a simple nor a regular patch. Both examples have sigma(t) = t.
   Definitions:
     crossing_x, crossing_y   the plane cubic (tau^2 - 1, tau^3 - tau), tau = 3 t - 3/2, which passes through 0 at t = 1/6 and t = 5/6
     crossing h               the curve (crossing_x, crossing_y, (tau + 1)/4 + h) of space
     cubic                    the curve (tau, tau^2, tau^3), tau = 2 + t *)
From Torse Require Import Prelude Points BZZ19_3 BZZ19_4_pieces FJ21_4 Needs_FJ07_curves.
From mathcomp Require Import order ssrnum.
Import Num.Theory.

Section Witnesses.
Variable F : numFieldType.

Definition crossing_tau : {poly F} := 3%:R%:P * 'X - (3%:R / 2%:R)%:P.
Definition crossing_x : {poly F} := crossing_tau ^+ 2 - 1.
Definition crossing_y : {poly F} := crossing_tau * crossing_x.
Definition crossing h : 'rV[{poly F}]_3 := vec crossing_x crossing_y ((4%:R^-1)%:P * (crossing_tau + 1) + h%:P).
Definition cubic : 'rV[{poly F}]_3 := vec ('X + 2%:R%:P) (('X + 2%:R%:P) ^+ 2) (('X + 2%:R%:P) ^+ 3).

Let after_X (c : 'rV[{poly F}]_3) : after c 'X = c.
Proof. by apply/rowP=> k; rewrite mxE comp_polyXr. Qed.

Let tau_at t : crossing_tau.[t] = 3%:R * t - 3%:R / 2%:R.
Proof. by rewrite /crossing_tau !hornerE. Qed.

Let slope_tau : crossing_tau^`() = 3%:R%:P.
Proof. by rewrite /crossing_tau derivB derivM derivX !derivC mul0r add0r mulr1 subr0. Qed.

(** BZZ19.5.witnesses crossing: (a) $C_1=(\tau^2-1,\tau^3-\tau,\frac{\tau+1}4)$ with $\tau=3t-\frac32$, $C_2=C_1+(0,0,1)$ and $\sigma(t)=t$: a cylinder over a
    rail with $z'=\frac34$, exactly developable, and $S(\frac12,\frac16)=S(0,\frac56)$.
    Paper: guarantees that there are no self-intersections. *)
Theorem BZZ19_5_witnesses_crossing (C1 := crossing 0) (C2 := crossing 1) :
  [/\ developable C1 (after C2 'X), (forall t, z_ (ev (pderiv C1) t) = 3%:R / 4%:R)
    & ruled_surface C1 C2 'X (1 / 2%:R) (1 / 6%:R) = ruled_surface C1 C2 'X 0 (5%:R / 6%:R)].
Proof.
rewrite /C1 /C2 after_X; split.
- rewrite /developable (_ : crossing 1 - crossing 0 = vec 0 0 1); last first.
    apply/rowP=> -[[|[|[|//]]] ?]; rewrite !mxE /= ?subrr //.
    by rewrite polyC0 polyC1 addr0 addrC addKr.
  by rewrite /crossing !pderiv_vec tripleE !vec_xyz !derivD !derivC; ring.
- by move=> t; rewrite /crossing pderiv_vec ev_vec vec_xyz polyC0 addr0 derivM [(crossing_tau + 1)^`()]derivD slope_tau !derivC mul0r add0r addr0 !hornerE mulrC.
have [before behind] : crossing_tau.[1 / 6%:R] = -1 /\ crossing_tau.[5%:R / 6%:R] = 1 by rewrite !tau_at; split; field; rewrite ?pnatr_eq0.
rewrite /ruled_surface !after_X /crossing !ev_vec !vecE /crossing_y /crossing_x.
move: crossing_tau before behind => tau; rewrite mul1r => before behind; congr vec; rewrite !hornerE /= before behind; field; rewrite ?pnatr_eq0 //.
Qed.

(** BZZ19.5.witnesses regression: (b) $C_1=r+r'$, $C_2=r-r'$ for $r=(\tau,\tau^2,\tau^3)$, $\tau=2+t$, and $\sigma(t)=t$: exactly developable, and
    $S_s\times S_t=0$ on the curve $s=\frac12$, which is $r=(2+t,(2+t)^2,(2+t)^3)$. *)
Theorem BZZ19_5_witnesses_regression (C1 := cubic + pderiv cubic) (C2 := cubic - pderiv cubic) :
  [/\ developable C1 (after C2 'X),
      forall t, cross (ev C2 t - ev C1 t) ((1 - 2%:R^-1) *: ev (pderiv C1) t + 2%:R^-1 *: ev (pderiv C2) t) = 0
    & forall t, ruled_surface C1 C2 'X 2%:R^-1 t = vec (2%:R + t) ((2%:R + t) ^+ 2) ((2%:R + t) ^+ 3)].
Proof.
rewrite after_X; have [dp dm] : pderiv C1 = pderiv cubic + pderiv (pderiv cubic) /\ pderiv C2 = pderiv cubic - pderiv (pderiv cubic).
  by split; apply/rowP=> k; rewrite !mxE ?derivD ?derivN.
have n2 : 2%:R != 0 :> F by rewrite pnatr_eq0.
split=> [|t|t].
- rewrite /developable dp dm /C1 /C2; move: (pderiv (pderiv cubic)) (pderiv cubic) cubic => a b c.
  by coordinates; hide_entries; ring.
- have evD p q : ev (p + q) t = ev p t + ev q t :> 'rV[F]_3 by apply/rowP=> k; rewrite !mxE hornerD.
  have evN p : ev (- p) t = - ev p t :> 'rV[F]_3 by apply/rowP=> k; rewrite !mxE hornerN.
  rewrite dp dm /C1 /C2 !evD !evN (_ : _ *: _ + _ *: _ = ev (pderiv cubic) t); last first.
    by move: (ev _ t) (ev _ t) => A B; apply/rowP=> k; rewrite !mxE; move: (A 0 k) (B 0 k) => x y; field.
  by move: (ev _ t) (ev _ t) => A B; apply: row3P; coordinates; hide_entries; ring.
transitivity (ev cubic t).
  rewrite /ruled_surface after_X; apply/rowP=> k; rewrite !mxE !(hornerD, hornerN).
  by move: (cubic 0 k).[t] ((cubic 0 k)^`()).[t] => x y; field.
by rewrite /cubic ev_vec !horner_exp !hornerD !hornerX !hornerC addrC.
Qed.
End Witnesses.
