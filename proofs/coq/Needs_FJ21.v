(* FJ21, section 4: what happens without the hypotheses of the theorems on the values at one parameter, here t = 0 unless it is said.
   Where n = 0 in the field, as for n = p in characteristic p, p + (x-t)/n p' has no meaning; the examples show that no number in the place of 1/n serves.
   Definitions:
     jet A B          the row A + B X of polynomials: its value at 0 is A, its derivative B
     e1, e2, e3       the points (1,0,0), (0,1,0), (0,0,1)
     related_with k p q t L M s   related_at with a number k in the place of 1/n *)
From Torse Require Import Prelude Blossom Curves Points FJ21_4 FJ21_5.

Section Jets.
Variable F : fieldType.
Implicit Types (A B C D : 'rV[F]_3) (f g : {poly F}) (p q : 'rV[{poly F}]_3) (L M s lam mu nu a b c x y z : F) (n : nat).

Definition jet A B : 'rV[{poly F}]_3 := map_mx polyC A + 'X *: map_mx polyC B.
Definition e1 : 'rV[F]_3 := vec 1 0 0.
Definition e2 : 'rV[F]_3 := vec 0 1 0.
Definition e3 : 'rV[F]_3 := vec 0 0 1.
Definition related_with m (k : F) (p q : 'rV[{poly F}]_m) t L M s :=
  ev p t + ((L - t) * k) *: ev (pderiv p) t = s *: (ev q t + ((M - t) * k) *: ev (pderiv q) t).

Lemma ev_jet A B t : ev (jet A B) t = A + t *: B.
Proof. by apply/rowP=> k; rewrite !mxE !hornerE. Qed.

Lemma ev_pderiv_jet A B t : ev (pderiv (jet A B)) t = B.
Proof. by apply/rowP=> k; rewrite !mxE derivD derivM derivX !derivC mulr0 addr0 mul1r add0r hornerC. Qed.

Lemma evD p q t : ev (p + q) t = ev p t + ev q t.
Proof. by apply/rowP=> k; rewrite !mxE hornerD. Qed.

Lemma evN p t : ev (- p) t = - ev p t.
Proof. by apply/rowP=> k; rewrite !mxE hornerN. Qed.

Lemma ev_scale f p t : ev (f *: p) t = f.[t] *: ev p t.
Proof. by apply/rowP=> k; rewrite !mxE hornerM. Qed.

Lemma ev_pderivD p q t : ev (pderiv (p + q)) t = ev (pderiv p) t + ev (pderiv q) t.
Proof. by apply/rowP=> k; rewrite !mxE derivD hornerD. Qed.

Lemma ev_pderivN p t : ev (pderiv (- p)) t = - ev (pderiv p) t.
Proof. by apply/rowP=> k; rewrite !mxE derivN hornerN. Qed.

Lemma ev_pderiv_scale f p t : ev (pderiv (f *: p)) t = f^`().[t] *: ev p t + f.[t] *: ev (pderiv p) t.
Proof. by apply/rowP=> k; rewrite !mxE derivM hornerD !hornerM. Qed.
End Jets.

Notation jetE := (ev_jet, ev_pderiv_jet, evD, evN, ev_pderivD, ev_pderivN, ev_scale, ev_pderiv_scale, FJ21_5.linearE, deriv_linear).

Lemma one_is_not_zero (F : fieldType) : (1 = 0 :> F) -> False.
Proof. by move/eqP; rewrite oner_eq0. Qed.

(* The equation at hand, simplified, and coordinate by coordinate. *)
Ltac at_jets := rewrite /related_at /related_with /tangent /frame ?jetE /e1 /e2 /e3 ?hornerX ?hornerC ?derivX ?derivC ?horner0 ?hornerC.
Ltac as_vec := rewrite ?scale0r ?scaler0 ?scale1r ?add0r ?addr0 ?vec0 ?vecE.
Ltac by_coords := as_vec; congr vec.
Ltac split_coords := as_vec; move=> /coords; case.
(* h: l = r cannot be, as z (l - r) is 1. *)
Ltac refute z h := apply: one_is_not_zero; apply: (by_multiple (z := z) h); ring.

Section Needs.
Variable F : fieldType.
Notation e1 := (e1 F).
Notation e2 := (e2 F).
Notation e3 := (e3 F).
Implicit Types (L M s lam mu nu a b x y v w omega : F) (n : nat).
Let one_is_not_zero := @one_is_not_zero F.

(** FJ21.4.1 needs_denominator: where $(1-\tilde v)w+\tilde v\omega=0$ the row $(1-\tilde v)wc+\tilde v\omega d$ is a multiple of no point $(1-v)c+vd$ of the
    ruling: $c=(1,0,0)$, $d=(0,1,0)$. *)
Theorem FJ21_4_1_needs_denominator w omega v x y : (1 - v) * w + v * omega = 0 ->
  x *: ((1 - v) *: (w *: e1) + v *: (omega *: e2)) <> (1 - y) *: e1 + y *: e2.
Proof.
move=> d0; rewrite /e1 /e2; split_coords => h1 h2 _; apply: one_is_not_zero.
transitivity ((1 - y) * 1 + y * 0 + ((1 - y) * 0 + y * 1)); first by ring.
by rewrite -h1 -h2; transitivity (x * ((1 - v) * w + v * omega)); [ring | rewrite d0 mulr0].
Qed.

(** FJ21.4.3 gauge_needs_factor: $p=(1,0,0)$, $q=(1,1,0)$ constant and $f=t$: where $f(t)=0$ there are no $\tilde\lambda,\tilde\mu,\tilde\nu$ at all. *)
Theorem FJ21_4_3_gauge_needs_factor mu (p := jet e1 0) (q := jet (e1 + e2) 0) :
  frame p q 0 0 mu 0 /\ forall lam' mu' nu', ~ frame ('X *: p) ('X *: q) 0 lam' mu' nu'.
Proof.
rewrite /p /q; split=> [|lam' mu' nu']; at_jets; first by by_coords; ring.
by split_coords => h1 _ _; refute (1 : F) h1.
Qed.

(** FJ21.4.3 unique_needs_free: a cylinder, $p=(1,0,0)$, $q=(1,1,0)$ constant: $W'=0$ and every $\mu$ serves. *)
Theorem FJ21_4_3_unique_needs_free mu (p := jet e1 0) (q := jet (e1 + e2) 0) : frame p q 0 0 mu 0.
Proof. by rewrite /p /q; at_jets; by_coords; ring. Qed.

(** FJ21.C4.1 needs_lambda: for $\lambda=0$, $\mu=\nu=1$ the frame may hold and there be no $\Lambda,M,\sigma$ at all: $p=W'=(0,0,1)$ added to $p$ itself: $p'=W'+p$. *)
Theorem FJ21_C4_1_needs_lambda n (p := jet e1 (e1 + e3)) (q := jet (e1 + e2) (e1 + e3 + e3)) :
  frame p q 0 0 1 1 /\ forall L M s, ~ related_at n p q 0 L M s.
Proof.
rewrite /p /q; split=> [|L M s]; at_jets; first by by_coords; ring.
split_coords => h1 h2 h3; have s0 : s = 0 by apply: (by_multiple (z := -1) h2); ring.
rewrite s0 in h1 h3; have x0 : (L - 0) / n%:R = 0 by apply: (by_multiple (z := 1) h3); ring.
by rewrite x0 in h1; refute (1 : F) h1.
Qed.

(** FJ21.C4.1 needs_difference: for $\lambda=\nu=1$, $\mu=0$ the frame may hold and there be no $\Lambda,M,\sigma$ at all: $\Lambda$ is infinite. *)
Theorem FJ21_C4_1_needs_difference n (p := jet e1 (e1 + e2)) (q := jet (e1 + e2) (e1 + e2 + e3)) :
  frame p q 0 1 0 1 /\ forall L M s, ~ related_at n p q 0 L M s.
Proof.
rewrite /p /q; split=> [|L M s]; at_jets; first by by_coords; ring.
split_coords => h1 h2 h3; have e : 1 = s - s :> F; last by refute (1 : F) e.
by apply: (by_multiple (z := 1) (congr2 (fun a b => a - b) h1 h2)); ring.
Qed.

(** FJ21.C4.1 needs_E: for $\Lambda=M=t$, $\sigma=1$, so that $E=0$, the relation may hold and there be no $\lambda,\mu,\nu$: $p=q=0$, $p'=(1,0,0)$, $W'=(0,1,0)$. *)
Theorem FJ21_C4_1_needs_E n (p := jet 0 e1) (q := jet 0 (e1 + e2)) :
  related_at n p q 0 0 0 1 /\ forall lam mu nu, ~ frame p q 0 lam mu nu.
Proof.
rewrite /p /q; split=> [|lam mu nu]; at_jets; first by by_coords; ring.
by split_coords => h1 _ _; refute (1 : F) h1.
Qed.

(** FJ21.C4.1 relation_needs_degree: where $n=0$ in the field $\lambda=1$, $\mu=\nu=0$ give $\Lambda=M=t$, $\sigma=1$, so that the relation would be $p=q$ whatever stands for
    $\frac1n$; but $p=0$, $q=p'=q'=(1,0,0)$ have this frame. *)
Theorem FJ21_C4_1_relation_needs_degree n (p := jet 0 e1) (q := jet e1 e1) : n%:R = 0 :> F ->
  [/\ frame p q 0 1 0 0, (n%:R * (0 + 1) + (1 - 0) * 0) / (1 - 0) = 0 :> F & forall k, ~ related_with k p q 0 0 0 1].
Proof.
rewrite /p /q => n0; split=> [||k]; at_jets; rewrite ?n0; [by by_coords; ring | by rewrite !mul0r mulr0 addr0 mul0r |].
by split_coords => h1 _ _; refute (-1 : F) h1.
Qed.

(** FJ21.C4.1 frame_needs_degree: where $n=0$ in the field $\Lambda=1$, $M=0$, $\sigma=1$, so that $E=1$, give $\lambda=\mu=\nu=0$: the frame of the constant $p=(1,0,0)$,
    $q=(0,1,0)$; whatever stands for $\frac1n$ the relation would be $p=q$. *)
Theorem FJ21_C4_1_frame_needs_degree n (p := jet e1 0) (q := jet e2 0) : n%:R = 0 :> F ->
  frame p q 0 (n%:R * 1 / 1) (1 * (0 - 0) / 1) (n%:R * (1 - 1) / 1) /\ forall k, ~ related_with k p q 0 1 0 1.
Proof.
rewrite /p /q => n0; split=> [|k]; at_jets; rewrite ?n0; first by by_coords; ring.
by split_coords => h1 _ _; refute (1 : F) h1.
Qed.

(** FJ21.4.4 needs_degree: where $n=0$ in the field and $p'\ne0$ no rows $p_0,p_1$ have $p'=n(p_1-p_0)$, and for $\lambda=\mu=\nu=0$ the right side of (4.4) is
    0 for all rows $p_i$, $q_i$, the left side $p'$. *)
Theorem FJ21_4_4_needs_degree n (p := jet 0 e1) (p0 p1 q0 q1 : 'rV[F]_3) : n%:R = 0 :> F ->
  ev (pderiv p) 0 <> n%:R *: (p1 - p0) /\
  ev (pderiv p) 0 <> (n%:R * (1 + 0) + 0 * (0 - 0)) *: p1 + ((1 - 0) * (0 - 0) - n%:R * (1 + 0)) *: p0
    - (0 * 0 + n%:R * 0) *: q1 - (0 * (1 - 0) - n%:R * 0) *: q0.
Proof.
rewrite /p => n0; rewrite n0; split; at_jets; rewrite ?addr0 !(mul0r, mulr0, addr0, subr0, scale0r); split_coords => h1 _ _; refute (1 : F) h1.
Qed.
End Needs.
