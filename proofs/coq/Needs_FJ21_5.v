(* FJ21, section 5: what happens without the hypotheses of the theorems, one counterexample each. The first are values at one parameter, as in Needs_FJ21.v. *)
From Torse Require Import Prelude Blossom Curves Points FJ07_3_net FJ07_3_blossoms FJ21_4 FJ21_5 FJ21_5_changes Insertion Needs_blossoms Needs_FJ21.

Section Sides.
Variable F : fieldType.
Implicit Types (a b k x : F) (A B C D : 'rV[F]_3).

(* The sides of a relation at t = 0, at once: quicker than part by part. *)
Lemma side_jet k A B x : ev (jet A B) 0 + ((x - 0) * k) *: ev (pderiv (jet A B)) 0 = A + (x * k) *: B.
Proof. by rewrite ev_jet ev_pderiv_jet scale0r addr0 subr0. Qed.

Lemma ev_linear a b A B : ev (linear a b *: jet A B) 0 = a *: A.
Proof. by rewrite ev_scale ev_jet FJ21_5.linearE mulr0 scale0r !addr0. Qed.

Lemma ev_pderiv_linear a b A B : ev (pderiv (linear a b *: jet A B)) 0 = b *: A + a *: B.
Proof. by rewrite ev_pderiv_scale ev_jet ev_pderiv_jet FJ21_5.linearE deriv_linear hornerC mulr0 scale0r !addr0. Qed.

Lemma side_linear k a b A B x :
  ev (linear a b *: jet A B) 0 + ((x - 0) * k) *: ev (pderiv (linear a b *: jet A B)) 0 = a *: A + (x * k) *: (b *: A + a *: B).
Proof. by rewrite ev_linear ev_pderiv_linear subr0. Qed.

Lemma side_lengths k a b a' b' A B C D x (r := linear a b *: jet A B + linear a' b' *: (jet C D - jet A B)) :
  ev r 0 + ((x - 0) * k) *: ev (pderiv r) 0 = a *: A + a' *: (C - A) + (x * k) *: (b *: A + a *: B + (b' *: (C - A) + a' *: (D - B))).
Proof.
rewrite /r !(evD, ev_pderivD) ev_linear ev_pderiv_linear ev_scale ev_pderiv_scale !(evD, ev_pderivD, evN, ev_pderivN, ev_jet, ev_pderiv_jet).
by rewrite FJ21_5.linearE deriv_linear hornerC mulr0 !scale0r !addr0 subr0.
Qed.
End Sides.

Ltac at_zero := rewrite /related_at /related_with /tangent ?(side_lengths, side_linear, side_jet) ?FJ21_5.linearE /e1 /e2 /e3.

Section Needs.
Variable F : fieldType.
Notation e1 := (e1 F).
Notation e2 := (e2 F).
Notation e3 := (e3 F).
Implicit Types (L M s a b x y k : F) (n : nat).
Let one_is_not_zero := @one_is_not_zero F.

(** FJ21.W needs_weight: with the weights of $q$ times $\beta=0$ there are no $\Lambda,M,\sigma$: $p=q=(1,0,0)$, constant. *)
Theorem FJ21_W_needs_weight n L M (p := jet e1 0) :
  related_at n p p 0 L M 1 /\ forall L' M' s', ~ related_at n (1%:P *: p) (0%:P *: p) 0 L' M' s'.
Proof.
rewrite /p; split=> [|L' M' s']; at_jets; first by by_coords; ring.
by split_coords => h1 _ _; refute (1 : F) h1.
Qed.

(** FJ21.5.3 needs_degree: where $n=0$ in the field, $f=g=1$: $\tilde\Lambda=1$, $\tilde M=0$, $\tilde\sigma=1$ relate $fp$, $gq$ in degree $n+1$ for $p=0$, $p'=q=(1,0,0)$,
    $q'=0$; the formulas give $\Lambda=M=t$, $\sigma=1$, and $p\ne q$ whatever stands for $\frac1n$. *)
Theorem FJ21_5_3_needs_degree n (p := jet 0 e1) (q := jet e1 0) : n%:R = 0 :> F ->
  related_at n.+1 (linear 1 0 *: p) (linear 1 0 *: q) 0 1 0 1 /\ forall k, ~ related_with k p q 0 0 0 1.
Proof.
rewrite /p /q => n0; split=> [|k]; at_zero; rewrite ?natrS ?n0 ?add0r ?invr1; first by by_coords; ring.
by split_coords => h1 _ _; refute (-1 : F) h1.
Qed.

(** FJ21.5.3 needs_next: where $n+1=0$ in the field, $f=g=1+t$: $\tilde\Lambda=\tilde M=\tilde\sigma=1$, for which $nf(t)+f(\tilde\Lambda)=ng(t)+g(\tilde M)=1$, give
    $\Lambda=M=-1$, $\sigma=1$; these relate $p=(1-t)(1,0,0)$ and $q=(1-t)(0,1,0)$ in degree $n$, but $fp$ and $gq$ are not related in degree $n+1$, whatever stands for $\frac1{n+1}$. *)
Theorem FJ21_5_3_needs_next n (f := linear 1 1) (p := jet e1 (- e1)) (q := jet e2 (- e2)) : n.+1%:R = 0 :> F ->
  [/\ n%:R * f.[0] + f.[1] = 1, related_at n p q 0 ((n%:R * f.[0] * 1 + f.[1] * 0) / 1) ((n%:R * f.[0] * 1 + f.[1] * 0) / 1) (1 / 1 * 1)
    & forall k, ~ related_with k (f *: p) (f *: q) 0 1 1 1].
Proof.
rewrite /f /p /q => n1; have nN : n%:R = -1 :> F by apply/eqP; rewrite -addr_eq0 -natrS n1.
split=> [||k]; at_zero; rewrite ?nN ?invrN ?invr1; [by ring | by by_coords; ring |].
by split_coords => h1 _ _; refute (1 : F) h1.
Qed.

(** FJ21.5.3 needs_H: for $f=1+t$, $g=1$ and $\tilde\Lambda=-(n+1)$, $nf(t)+f(\tilde\Lambda)=0$: $fp$ and $gq$ are related in degree $n+1$ with $\tilde M=0$, $\tilde\sigma=1$,
    and there are no $\Lambda,M,\sigma$ in degree $n$.
    Hypotheses: $n+1\ne0$ in the field. *)
Theorem FJ21_5_3_needs_H n (p := jet e1 (- e2)) (q := jet e2 0) : n.+1%:R != 0 :> F ->
  related_at n.+1 (linear 1 1 *: p) (linear 1 0 *: q) 0 (- n.+1%:R) 0 1 /\ forall L M s, ~ related_at n p q 0 L M s.
Proof.
rewrite /p /q => n1; split=> [|L M s]; at_zero; first by rewrite mulNr mulfV //; by_coords; ring.
by split_coords => h1 _ _; refute (1 : F) h1.
Qed.

(** FJ21.5.3 needs_G: likewise for $f=1$, $g=1+t$ and $\tilde M=-(n+1)$, $\tilde\Lambda=0$, $\tilde\sigma=1$: $ng(t)+g(\tilde M)=0$.
    Hypotheses: $n+1\ne0$ in the field. *)
Theorem FJ21_5_3_needs_G n (p := jet e2 0) (q := jet e1 (- e2)) : n.+1%:R != 0 :> F ->
  related_at n.+1 (linear 1 0 *: p) (linear 1 1 *: q) 0 0 (- n.+1%:R) 1 /\ forall L M s, ~ related_at n p q 0 L M s.
Proof.
rewrite /p /q => n1; split=> [|L M s]; at_zero; first by rewrite mulNr mulfV //; by_coords; ring.
split_coords => h1 h2 _; have s0 : s = 0 by apply: (by_multiple (z := -1) h1); ring.
by rewrite s0 in h2; refute (1 : F) h2.
Qed.

(** FJ21.5.3 usual_needs_degree: where $n=0$ in the field, at $t=1$, $p=t(1,0,0)$, $q=0$ and $\Lambda=1$: whatever stands for $\frac1n$, $\tilde\Lambda=0$ relates
    them in degree $n+1$, but $p(t)\ne0$. *)
Theorem FJ21_5_3_usual_needs_degree n k M (p := jet 0 e1) (q := jet 0 0) : n%:R = 0 :> F ->
  related_at n.+1 p q 1 ((n.+1%:R * 1 - 1) * k) ((n.+1%:R * M - 1) * k) 1 /\ ~ related_with k p q 1 1 M 1.
Proof.
rewrite /p /q => n0; split; at_jets; rewrite ?natrS ?n0 ?add0r ?invr1; first by by_coords; ring.
by split_coords => h1 _ _; refute (1 : F) h1.
Qed.

(** FJ21.5.3 usual_needs_next: where $n+1=0$ in the field $\tilde\Lambda=\tilde M=t$ for all $\Lambda$, $M$: $p=q=0$, $p'=(1,0,0)$, $q'=0$ are related in degree $n+1$,
    whatever stands for $\frac1{n+1}$, but not in degree $n$ for $\Lambda=1$, $M=0$. *)
Theorem FJ21_5_3_usual_needs_next n k (p := jet 0 e1) (q := jet 0 0) : n.+1%:R = 0 :> F ->
  related_with k p q 0 ((n.+1%:R * 1 - 0) / n%:R) ((n.+1%:R * 0 - 0) / n%:R) 1 /\ ~ related_at n p q 0 1 0 1.
Proof.
rewrite /p /q => n1; have nN : n%:R = -1 :> F by apply/eqP; rewrite -addr_eq0 -natrS n1.
split; at_jets; rewrite ?n1 ?nN ?invrN ?invr1; first by by_coords; ring.
by split_coords => h1 _ _; refute (-1 : F) h1.
Qed.

(** FJ21.5.4 needs_degree: where $n=0$ in the field, $f=g=1$, the example of (5.3): $\tilde\Lambda=1$, $\tilde M=0$, $\tilde\sigma=1$ give $\Lambda=M=t$, $\sigma=1$, and $p\ne q$
    whatever stands for $\frac1n$. *)
Theorem FJ21_5_4_needs_degree n (p := jet 0 e1) (q := jet e1 0) (f := linear 1 0) : n%:R = 0 :> F ->
  related_at n.+1 (f *: p) (f *: p + f *: (q - p)) 0 1 0 1 /\ forall k, ~ related_with k p q 0 0 0 1.
Proof.
rewrite /p /q /f => n0; split=> [|k]; at_zero; rewrite ?natrS ?n0 ?add0r ?invr1; first by by_coords; ring.
by split_coords => h1 _ _; refute (-1 : F) h1.
Qed.

(** FJ21.5.4 needs_next: where $n+1=0$ in the field, $f=g=1+t$, the example of (5.3): $\Lambda=M=-1$, $\sigma=1$, those of the formula for
    $\tilde\Lambda=\tilde M=\tilde\sigma=1$, for which $G=H=1$, relate $p$ and $q$, but the rows of degree $n+1$ are not related, whatever stands for $\frac1{n+1}$. *)
Theorem FJ21_5_4_needs_next n (f := linear 1 1) (p := jet e1 (- e1)) (q := jet e2 (- e2)) : n.+1%:R = 0 :> F ->
  [/\ n%:R * f.[0] + f.[1] = 1, related_at n p q 0 (-1) (-1) 1 & forall k, ~ related_with k (f *: p) (f *: p + f *: (q - p)) 0 1 1 1].
Proof.
rewrite /f /p /q => n1; have nN : n%:R = -1 :> F by apply/eqP; rewrite -addr_eq0 -natrS n1.
split=> [||k]; at_zero; rewrite ?nN ?invrN ?invr1; [by ring | by by_coords; ring |].
by split_coords => h1 _ _; refute (1 : F) h1.
Qed.

(** FJ21.5.4 needs_H: for $f=1+t$, $g=1$, $\tilde\Lambda=-(n+1)$, $\tilde M=0$, $\tilde\sigma=1$, so that $H=0$, the rows $fp$ and $fp+g(q-p)$ are related in degree
    $n+1$ and there are no $\Lambda,M,\sigma$ in degree $n$.
    Hypotheses: $n+1\ne0$ in the field. *)
Theorem FJ21_5_4_needs_H n (p := jet e1 (- e2)) (q := jet e2 0) (f := linear 1 1) (g := linear 1 0) : n.+1%:R != 0 :> F ->
  related_at n.+1 (f *: p) (f *: p + g *: (q - p)) 0 (- n.+1%:R) 0 1 /\ forall L M s, ~ related_at n p q 0 L M s.
Proof.
rewrite /p /q /f /g => n1; split=> [|L M s]; at_zero; first by rewrite mulNr mulfV //; by_coords; ring.
by split_coords => h1 _ _; refute (1 : F) h1.
Qed.

(** FJ21.5.4 needs_G: for $f=t$, $g=1+t$, $\tilde M=-(n+1)$, $\tilde\Lambda=0$, $\tilde\sigma=1$, so that $G=0$ and $H=n+1$: likewise.
    Hypotheses: $n+1\ne0$ in the field. *)
Theorem FJ21_5_4_needs_G n (p := jet e1 0) (q := jet (e1 + e2) (- e1)) (f := linear 0 1) (g := linear 1 1) : n.+1%:R != 0 :> F ->
  related_at n.+1 (f *: p) (f *: p + g *: (q - p)) 0 0 (- n.+1%:R) 1 /\ forall L M s, ~ related_at n p q 0 L M s.
Proof.
rewrite /p /q /f /g => n1; split=> [|L M s]; at_zero; first by rewrite mulNr mulfV //; by_coords; ring.
split_coords => h1 h2 _; have s0 : s = 0 by apply: (by_multiple (z := -1) h2); ring.
by rewrite s0 in h1; refute (1 : F) h1.
Qed.
End Needs.

Section Moebius.
Variable F : fieldType.
Notation e1 := (e1 F).
Notation e2 := (e2 F).
Notation e3 := (e3 F).
Implicit Types (L M s b x y : F).
Let one_is_not_zero := @one_is_not_zero F.

Lemma line_blossom m (c : nat -> 'rV[F]_m) x : pblossom (step01 F 1) c [:: at_ x] = (1 - x) *: c 0%N + x *: c 1%N.
Proof. by apply/rowP=> k; rewrite !mxE /= /step /step01 /coord /= !mul1r !subr0 divr1. Qed.

Lemma moebius_line m b (c : nat -> 'rV[F]_m) x :
  pblossom (step01 F 1) (moebius 1 b c) [:: at_ x] = ((1 - x) * b) *: c 0%N + x *: c 1%N.
Proof. by rewrite line_blossom /moebius subn0 subnn expr1 expr0 scale1r scalerA. Qed.

(** FJ21.5.1 curve_needs_finite: where $(1-b)u+b=0$ the parameter $t(u)$ is infinite, and no point $y$ in the place of $p(t)$ has $\tilde p(u)=((1-b)u+b)^ny$: the points
    $0,1$ of degree 1.
    Hypotheses: $b\ne0$. *)
Theorem FJ21_5_1_curve_needs_finite b x (y : 'rV[F]_1) (c := nth 0 [:: 0; const_mx 1] : nat -> 'rV[F]_1) : b != 0 -> (1 - b) * x + b = 0 ->
  pblossom (step01 F 1) (moebius 1 b c) [:: at_ x] <> ((1 - b) * x + b) ^+ 1 *: y.
Proof.
move=> b0 d0; rewrite d0 expr1 scale0r moebius_line /c /= scaler0 add0r => /rowP/(_ 0); rewrite !mxE mulr1 => x0.
by case/eqP: b0; rewrite -d0 x0 mulr0 add0r.
Qed.

(** FJ21.5.2 functions_needs_b: for $b=0$ the rows keep their last points only: $c_0=1$, $d_0=c_1=d_1=0$ become related for $\tilde\Lambda=\tilde M=0$, and are not for
    $\Lambda=M=0$, $\sigma=1$. *)
Theorem FJ21_5_2_functions_needs_b (c := nth 0 [:: const_mx 1] : nat -> 'rV[F]_1) (d := fun=> 0 : 'rV[F]_1) :
  pblossom (step01 F 1) (moebius 1 0 c) [:: at_ 0] = 1 *: pblossom (step01 F 1) (moebius 1 0 d) [:: at_ 0] /\
  pblossom (step01 F 1) c [:: at_ 0] <> 1 *: pblossom (step01 F 1) d [:: at_ 0].
Proof.
rewrite !moebius_line !line_blossom /c /d /=; split; first by rewrite !(mulr0, scale0r, scaler0, addr0).
by rewrite !(scaler0, scale0r, addr0, subr0, scale1r) => /rowP/(_ 0); rewrite !mxE => /one_is_not_zero.
Qed.

(** FJ21.5.2 functions_needs_finite: where $(1-b)u+b=0$ the rows of the constants $c=1$, $d=0$ of degree 2 are related for all $\tilde\Lambda$, $\tilde M$, $\tilde\sigma$, and at no $t$ are
    $c$ and $d$. *)
Theorem FJ21_5_2_functions_needs_finite b x L M s (c := fun=> const_mx 1 : 'rV[F]_1) (d := fun=> 0 : 'rV[F]_1) : (1 - b) * x + b = 0 ->
  pblossom (step01 F 2) (moebius 2 b c) [:: at_ L; at_ x] = s *: pblossom (step01 F 2) (moebius 2 b d) [:: at_ M; at_ x] /\
  forall t L' M' s', pblossom (step01 F 2) c [:: at_ L'; at_ t] <> s' *: pblossom (step01 F 2) d [:: at_ M'; at_ t].
Proof.
move=> d0; have zero e v : pblossom (step01 F 2) (fun i => e i *: d i) v = 0.
  by apply/rowP=> k; rewrite !mxE -[RHS](blossom0 (step01 F 2) v); apply: blossom_ext => i _; rewrite /coord /d !mxE mulr0.
split=> [|t L' M' s'].
  rewrite [X in s *: X]zero scaler0; apply/rowP=> k; rewrite !mxE /= /step /shift /step01 /coord /moebius /c !mxE /=; rewrite !subr0 !divr1 !mulr1 !mul1r !subr0.
  have e : (1 - x) * b + x = 0 by apply: (by_multiple (z := 1) d0); ring.
  by apply: (by_multiple (z := (1 - L) * b + L) e); ring.
have none v : pblossom (step01 F 2) d v = 0.
  by apply/rowP=> k; rewrite !mxE -[RHS](blossom0 (step01 F 2) v); apply: blossom_ext => i _; rewrite /coord mxE.
rewrite none scaler0 => /rowP/(_ 0); rewrite !mxE /= /step /shift /step01 /coord /c !mxE /= !subr0 !divr1 !mul1r !mulr1 => e.
by apply: one_is_not_zero; rewrite -[RHS]e; ring.
Qed.

(** FJ21.5.2 functions_needs_Lambda: where $1+(b-1)\Lambda=0$, so that $\Lambda$ goes to infinity, $c=(1-t)e_1+te_2$ and $d=(1-t)c(\Lambda)+te_3$ are related with $M=0$,
    $\sigma=1$, and after the transformation with no $\tilde\Lambda$, $\tilde M$, $\tilde\sigma$ at all.
    Hypotheses: $b\ne0$. *)
Theorem FJ21_5_2_functions_needs_Lambda b L (c := nth 0 [:: e1; e2]) (d := nth 0 [:: (1 - L) *: e1 + L *: e2; e3]) : b != 0 -> 1 + (b - 1) * L = 0 ->
  pblossom (step01 F 1) c [:: at_ L] = 1 *: pblossom (step01 F 1) d [:: at_ 0] /\
  forall x y s, pblossom (step01 F 1) (moebius 1 b c) [:: at_ x] <> s *: pblossom (step01 F 1) (moebius 1 b d) [:: at_ y].
Proof.
move=> b0 a0; split=> [|x y s]; rewrite ?moebius_line ?line_blossom /c /d /e1 /e2 /e3 /=; first by by_coords; ring.
split_coords => h1 h2 _; apply: one_is_not_zero; apply: (mulfI b0).
have e : (1 - x) * b + b * x = s * (1 - y) * b * (1 + (b - 1) * L).
  by apply: (by_multiple (z := 1) (congr2 (fun u v => u + b * v) h1 h2)); ring.
by move: e; rewrite a0 !mulr0 => <-; ring.
Qed.

(** FJ21.5.2 functions_needs_M: where $1+(b-1)M=0$: $d=(1-t)e_1+te_2$ and $c=(1-t)d(M)+te_3$ are related with $\Lambda=0$, $\sigma=1$, and after the transformation with no
    $\tilde\Lambda$, $\tilde M$, $\tilde\sigma$ at all.
    Hypotheses: $b\ne0$. *)
Theorem FJ21_5_2_functions_needs_M b M (c := nth 0 [:: (1 - M) *: e1 + M *: e2; e3]) (d := nth 0 [:: e1; e2]) : b != 0 -> 1 + (b - 1) * M = 0 ->
  pblossom (step01 F 1) c [:: at_ 0] = 1 *: pblossom (step01 F 1) d [:: at_ M] /\
  forall x y s, pblossom (step01 F 1) (moebius 1 b c) [:: at_ x] <> s *: pblossom (step01 F 1) (moebius 1 b d) [:: at_ y].
Proof.
move=> b0 a0; split=> [|x y s]; rewrite ?moebius_line ?line_blossom /c /d /e1 /e2 /e3 /=; first by by_coords; ring.
split_coords => h1 h2 h3; have x0 : x = 0 by apply: (by_multiple (z := 1) h3); ring.
rewrite x0 in h1 h2; have s0 : s = 0.
  apply: (mulfI b0); rewrite mulr0; transitivity (b * (1 + (b - 1) * M)); last by rewrite a0 mulr0.
  by apply: (by_multiple (z := -1) (congr2 (fun u v => u + b * v) h1 h2)); ring.
have M0 : M = 0 by apply: (mulfI b0); move: h2; rewrite s0 => h2; apply: (by_multiple (z := 1) h2); ring.
by apply: one_is_not_zero; rewrite -[RHS]a0 M0; ring.
Qed.
End Moebius.

Section Insertion.
Variable F : fieldType.
Implicit Types (a M s : F).

(** FJ21.K relation_needs_first: for $n=2$ and the knots $0,1,a,0$ the points $1,0,0$ and $q=0$ have $p[t,a]=0=\sigma q[t,M]$; with $0$ inserted as knot $1$ Boehm's points of
    the first piece, over the knots $0,0,1,a$, have $\hat p[0,a]=1$.
    Hypotheses: $a\ne0$ and $a\ne1$. *)
Theorem FJ21_K_relation_needs_first a M s (u := listed [:: 0; 1; a; 0]) (c := fun i => const_mx (listed [:: 1; 0; 0] i) : 'rV[F]_1) (d := fun=> 0 : 'rV[F]_1)
    (u' := insert_knot 1 0 u) : a != 0 -> a != 1 ->
  [/\ span 2 u, span 2 u', forall t, pblossom u c [:: at_ a; at_ t] = s *: pblossom u d [:: at_ M; at_ t]
    & pblossom u' (insert_points 2 1 0 u c) [:: at_ a; at_ 0] <> s *: pblossom u' (insert_points 2 1 0 u d) [:: at_ M; at_ 0]].
Proof.
move=> a0 a1; have a1' : a - 1 != 0 by rewrite subr_eq0.
have simp := (mul0r, mulr0, mul1r, mulr1, addr0, add0r, subrr, subr0, sub0r, oppr0, divr1).
have zero v (w : nat -> F) (e : nat -> 'rV[F]_1) : e =1 d -> pblossom w e v = 0.
  by move=> ed; apply/rowP=> k; rewrite !mxE -[RHS](blossom0 w v); apply: blossom_ext => i _; rewrite /coord ed mxE.
split.
- by move=> [|[|[|//]]] [|[|[|[|//]]]] // _ _; rewrite unitfE /u /listed /= ?subr0 ?sub0r ?oppr_eq0 ?oner_eq0.
- by move=> [|[|[|//]]] [|[|[|[|//]]]] // _ _; rewrite unitfE /u' /insert_knot /u /listed /= ?subr0 ?oner_eq0.
- move=> t; rewrite [X in _ = s *: X]zero // scaler0; apply/rowP=> k; rewrite !mxE /= /step /shift /u /coord /c /listed /= !mxE /=.
  by rewrite !simp.
rewrite [X in _ <> s *: X]zero; last first.
  move=> i; apply/rowP=> k; rewrite !mxE /insert_point /step /coord !mxE; case: ifP => // _; case: ifP => // _.
  by rewrite !simp.
rewrite scaler0 => /rowP/(_ 0); rewrite !mxE /= /step /shift /u' /insert_knot /insert_points /insert_point /u /coord /c /listed /= !mxE /=.
by rewrite /step /= !mxE /= !simp mulfV // !simp subrK => /eqP; rewrite oner_eq0.
Qed.

(** FJ21.K net_needs_first: there the first cell of $c$ and $d=0$ has $\Lambda^{*}=a$, and that of Boehm's points does not, whatever $M^{*}$ is.
    Hypotheses: $a\ne0$. *)
Theorem FJ21_K_net_needs_first a M (u := listed [:: 0; 1; a; 0]) (c := fun i => const_mx (listed [:: 1; 0; 0] i) : 'rV[F]_1) (d := fun=> 0 : 'rV[F]_1)
    (u' := insert_knot 1 0 u) : a != 0 ->
  [/\ forall k, (k < 1 <= k + 2)%N -> u (k + 2)%N - u k != 0, cell u 2 a M c d 0 & ~ cell u' 2 a M (insert_points 2 1 0 u c) (insert_points 2 1 0 u d) 0].
Proof.
move=> a0; have simp := (mul0r, mulr0, mul1r, mulr1, addr0, add0r, subrr, subr0, sub0r, oppr0, scale0r, scaler0, scale1r).
split; first by case=> [|//] _; rewrite /u /listed /= subr0.
- by apply/rowP=> k; rewrite /cell !mxE /u /c /d /listed /= !simp.
rewrite /cell => /rowP/(_ 0); rewrite !mxE /u' /insert_knot /insert_point /step /u /coord /c /d /listed /= !mxE /= !simp.
by rewrite mulfV // !mulr1 subrK => /eqP; rewrite oner_eq0.
Qed.
End Insertion.
