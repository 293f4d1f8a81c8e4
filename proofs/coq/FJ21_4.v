(* FJ21, section 4: reparametrisation, the frame p, W, W' and the functions Lam, M, sigma.
   A curve is a row of polynomials: four for homogeneous coordinates; all is said at one parameter t.
   Definitions:
     ev p t               the point at t
     tangent n p t x      p(t) + (x-t)/n p'(t), which is the blossom p[t, ..., t, x]
     related_at n p q t L M s   p[t, ..., t, Lam] = sigma q[t, ..., t, M] at t, for the values Lam, M, sigma at t
     frame p q t lam mu nu      p' = lam W + mu W' + nu p at t, W = q - p *)
From Torse Require Import Prelude Blossom Curves Points.

(* x = y follows from l = r where x - y is a multiple of l - r. *)
Lemma by_multiple (R : ringType) (z x y l r : R) : l = r -> x - y = z * (l - r) -> x = y.
Proof. by move=> -> /eqP; rewrite subrr mulr0 subr_eq0 => /eqP. Qed.

Section Frame.
Variables (F : fieldType) (m : nat).
Implicit Types (p q r : 'rV[{poly F}]_m) (f g : {poly F}) (t x L M s lam mu nu : F) (n : nat).

Definition ev p t : 'rV[F]_m := \row_k (p 0 k).[t].
Definition tangent n p t x : 'rV[F]_m := ev p t + ((x - t) / n%:R) *: ev (pderiv p) t.
Definition related_at n p q t L M s := tangent n p t L = s *: tangent n q t M.
Definition frame p q t lam mu nu :=
  ev (pderiv p) t = lam *: ev (q - p) t + mu *: ev (pderiv (q - p)) t + nu *: ev p t.

Lemma natrS n : n.+1%:R = n%:R + 1 :> F.
Proof. by rewrite mulrSr. Qed.

Lemma pderivE p k : pderiv p 0 k = (p 0 k)^`().
Proof. by rewrite mxE. Qed.

(** FJ21.3.5 tangent: $p[t^{\langle n-1\rangle},x]=p(t)+\frac{x-t}np'(t)$ on every piece.
    Hypotheses: $n\ne0$ in the field; the knots carry the piece, so that the curve has a meaning. *)
Theorem FJ21_3_5_tangent n (u : nat -> F) (c : nat -> 'rV[F]_m) t x : (n%:R : F) != 0 -> span n u ->
  tangent n (pcurve n u c) t x = pblossom u c (at_ x :: nseq n.-1 (at_ t)).
Proof.
case: n => [|n] nz sp; first by rewrite eqxx in nz.
apply/rowP=> k; rewrite !mxE blossoms_derivative // hornerMn horner_curve //.
have -> : (velocity n.+1 u (coord c k)).[t] = blossom u (coord c k) (direction F :: nseq n (at_ t)).
  rewrite -[LHS]/(horner_eval t _) /velocity (blossom_morph [rmorphism of horner_eval t]); last by rewrite /= size_nseq; apply: span_polys.
  rewrite /= map_nseq /= /horner_eval hornerX !hornerC.
  rewrite (@blossom_ext_knots _ _ (shift u)); last by move=> i _ /=; rewrite /shift /= hornerC.
  by apply: blossom_ext => i _ /=; rewrite /step /= /horner_eval /polys !hornerC ?size_map ?size_nseq.
rewrite -[X in _ * X]mulr_natl mulrA divfK //.
rewrite -[blossom u _ (nseq _ _)]mul1r -(blossoms_multilinear _ _ [::]) /= /comb /at_ /=.
by congr (blossom _ _ ((_, _) :: _)); ring.
Qed.

(** FJ21.4.1 parameter: $\tilde b(t,\tilde v)=\frac{(1-\tilde v)wc+\tilde v\omega d}{(1-\tilde v)w+\tilde v\omega}=(1-v)c+vd$
    for $v=\frac{\tilde v\omega}{(1-\tilde v)w+\tilde v\omega}$.
    Hypotheses: the denominator is not 0. *)
Theorem FJ21_4_1_parameter (c d : 'rV[F]_m) w omega v (D := (1 - v) * w + v * omega) : D != 0 ->
  D^-1 *: ((1 - v) *: (w *: c) + v *: (omega *: d)) = (1 - v * omega / D) *: c + (v * omega / D) *: d.
Proof. by rewrite /D => nz; by_entries k; field. Qed.

(** FJ21.4.3 gauge: for $\tilde p=fp$, $\tilde q=fq$: $\tilde\lambda=\lambda-\mu f'/f$, $\tilde\mu=\mu$, $\tilde\nu=\nu+f'/f$.
    Hypotheses: $f(t)\ne0$. *)
Theorem FJ21_4_3_gauge p q f t lam mu nu : f.[t] != 0 -> frame p q t lam mu nu ->
  frame (f *: p) (f *: q) t (lam - mu * f^`().[t] / f.[t]) mu (nu + f^`().[t] / f.[t]).
Proof.
move=> nz /rowP eq_p; apply/rowP=> k; have := eq_p k; rewrite !mxE !derivB !derivM !(hornerD, hornerN, hornerM).
move: f.[t] f^`().[t] (p 0 k).[t] (q 0 k).[t] (p 0 k)^`().[t] (q 0 k)^`().[t] nz => a b P Q P' Q' nz eq_P.
by apply: (by_multiple (z := a) eq_P); field.
Qed.

(** FJ21.C4.1 relation: with $\Lambda=\frac{n(\mu+1)+(\lambda-\nu)t}{\lambda-\nu}$, $M=\frac{\lambda t+n\mu}\lambda$,
    $\sigma=\frac\lambda{\lambda-\nu}$ the frame gives $p[t^{\langle n-1\rangle},\Lambda]=\sigma q[t^{\langle n-1\rangle},M]$, and conversely.
    Hypotheses: $\lambda\ne0$, $\lambda\ne\nu$, and $n\ne0$ in the field.
    Paper: states none of them. *)
Theorem FJ21_C4_1_relation n p q t lam mu nu : n%:R != 0 :> F -> lam != 0 -> lam - nu != 0 ->
  frame p q t lam mu nu <->
  related_at n p q t ((n%:R * (mu + 1) + (lam - nu) * t) / (lam - nu)) ((lam * t + n%:R * mu) / lam) (lam / (lam - nu)).
Proof.
move=> n0 l0 ln0; rewrite /frame /related_at /tangent; split=> /rowP eq_p; apply/rowP=> k; have := eq_p k; rewrite !mxE !derivB !hornerD !hornerN.
  move: (p 0 k).[t] (q 0 k).[t] (p 0 k)^`().[t] (q 0 k)^`().[t] n%:R n0 => P Q P' Q' N n0 eq_P.
  by apply: (by_multiple (z := (lam - nu)^-1) eq_P); field; rewrite n0 l0 ln0.
move: (p 0 k).[t] (q 0 k).[t] (p 0 k)^`().[t] (q 0 k)^`().[t] n%:R n0 => P Q P' Q' N n0 eq_P.
by apply: (by_multiple (z := lam - nu) eq_P); field; rewrite n0 l0 ln0.
Qed.

(** FJ21.C4.1 frame: with $E=\Lambda-\sigma M+t(\sigma-1)$ the relation gives the frame for $\lambda=n\sigma/E$, $\mu=\sigma(M-t)/E$,
    $\nu=n(\sigma-1)/E$, and conversely.
    Hypotheses: $E\ne0$, and $n\ne0$ in the field. *)
Theorem FJ21_C4_1_frame n p q t L M s (E := L - s * M + t * (s - 1)) : n%:R != 0 :> F -> E != 0 ->
  related_at n p q t L M s <-> frame p q t (n%:R * s / E) (s * (M - t) / E) (n%:R * (s - 1) / E).
Proof.
rewrite /E => n0 e0; rewrite /frame /related_at /tangent; split=> /rowP eq_p; apply/rowP=> k; have := eq_p k; rewrite !mxE !derivB !hornerD !hornerN;
  move: (p 0 k).[t] (q 0 k).[t] (p 0 k)^`().[t] (q 0 k)^`().[t] n%:R n0 => P Q P' Q' N n0 eq_P.
  by apply: (by_multiple (z := N / (L - s * M + t * (s - 1))) eq_P); field; rewrite n0 e0.
by apply: (by_multiple (z := (L - s * M + t * (s - 1)) / N) eq_P); field; rewrite n0 e0.
Qed.

End Frame.
