(* FJ21, sections 4 and 5, for rational functions Lam, M, sigma in the place of their values at one parameter: a relation of functions of t is the relation
   at the parameter t of curves over the field of the rational functions of t, so that the theorems about one parameter say the same of functions.
   Definitions:
     generic p      the row of polynomials p with rational functions as coefficients, all of them constants *)
From Torse Require Import Prelude Blossom Curves Points Functions FJ21_2 FJ21_3_theorem FJ21_4 FJ21_4_gauge FJ21_5 FJ21_5_changes.

Section Functions.
Variable F : fieldType.
Notation K := {fraction {poly F}}.
Notation "x %:F" := (@FracField.tofrac [idomainType of {poly F}] x).
Implicit Types (L M s lam mu nu : K) (n m : nat).

Definition generic m (p : 'rV[{poly F}]_m) : 'rV[{poly K}]_m := map_mx (map_poly (fun a : F => a%:P%:F)) p.

Let constant : {rmorphism F -> K} := [rmorphism of (@FracField.tofrac [idomainType of {poly F}]) \o polyC].

Lemma generic_value (f : {poly F}) : (map_poly (fun a : F => a%:P%:F) f).['X%:F] = f%:F.
Proof.
transitivity (map_poly (@FracField.tofrac [idomainType of {poly F}]) (map_poly polyC f)).['X%:F]; first by rewrite -map_poly_comp.
by rewrite horner_map -[(map_poly _ f).['X]]/(f \Po 'X) comp_polyXr.
Qed.

Lemma ev_generic m (p : 'rV[{poly F}]_m) : ev (generic p) 'X%:F = pfun p.
Proof. by apply/rowP=> k; rewrite !mxE generic_value. Qed.

Lemma pderiv_generic m (p : 'rV[{poly F}]_m) : pderiv (generic p) = generic (pderiv p).
Proof. by apply/rowP=> k; rewrite !mxE -[map_poly _ _]/(map_poly constant (p 0 k)) deriv_map. Qed.

(** FJ21.3.5 generic: $p[t^{\langle n-1\rangle},\Lambda]=\sigma q[t^{\langle n-1\rangle},M]$ with rational functions $\Lambda,M,\sigma$ of $t$ is the relation of their values
    at the parameter $t$ of the same curves over the field of rational functions of $t$: what is said of one parameter is said of functions. *)
Theorem FJ21_3_5_generic m n (p q : 'rV[{poly F}]_m) L M s :
  frelated n p q L M s <-> related_at n (generic p) (generic q) 'X%:F L M s.
Proof. by rewrite /related_at /tangent !pderiv_generic !ev_generic. Qed.

Lemma frame_generic m (p q : 'rV[{poly F}]_m) lam mu nu :
  fframe (pfun p) (pfun q) lam mu nu <-> frame (generic p) (generic q) 'X%:F lam mu nu.
Proof.
rewrite /fframe /frame pderiv_generic ev_generic pfderivB !pfderiv_fun.
have sub r r' : ev (generic r - generic r') 'X%:F = pfun r - pfun r' :> 'rV[K]_m.
  by rewrite -!ev_generic; apply/rowP=> k; rewrite !mxE hornerD hornerN.
have der r r' : pderiv (generic r - generic r') = generic (pderiv r) - generic (pderiv r') :> 'rV[{poly K}]_m.
  by rewrite -!pderiv_generic; apply/rowP=> k; rewrite !mxE derivB.
by rewrite der !sub ev_generic.
Qed.

(** FJ21.C4.1 functions: with $\Lambda=\frac{n(\mu+1)+(\lambda-\nu)t}{\lambda-\nu}$, $M=\frac{\lambda t+n\mu}\lambda$, $\sigma=\frac\lambda{\lambda-\nu}$, all of them
    rational functions, $p'=\lambda W+\mu W'+\nu p$ iff $p[t^{\langle n-1\rangle},\Lambda]=\sigma q[t^{\langle n-1\rangle},M]$.
    Hypotheses: $\lambda\ne0$ and $\lambda\ne\nu$ as functions; $n\ne0$ in the field.
    Paper: states none of them. *)
Theorem FJ21_C4_1_functions m n (p q : 'rV[{poly F}]_m) lam mu nu : n%:R != 0 :> F -> lam != 0 -> lam - nu != 0 ->
  fframe (pfun p) (pfun q) lam mu nu <->
  frelated n p q ((n%:R * (mu + 1) + (lam - nu) * 'X%:F) / (lam - nu)) ((lam * 'X%:F + n%:R * mu) / lam) (lam / (lam - nu)).
Proof. by move=> n0 l0 d0; rewrite frame_generic FJ21_3_5_generic; apply: FJ21_C4_1_relation; rewrite ?natrF0. Qed.

(** FJ21.C4.1 functions_frame: with $E=\Lambda-\sigma M+t(\sigma-1)$ the relation holds iff the frame does for $\lambda=n\sigma/E$, $\mu=\sigma(M-t)/E$,
    $\nu=n(\sigma-1)/E$.
    Hypotheses: $E$ is not the zero function; $n\ne0$ in the field. *)
Theorem FJ21_C4_1_functions_frame m n (p q : 'rV[{poly F}]_m) L M s (E := L - s * M + 'X%:F * (s - 1)) : n%:R != 0 :> F -> E != 0 ->
  frelated n p q L M s <-> fframe (pfun p) (pfun q) (n%:R * s / E) (s * (M - 'X%:F) / E) (n%:R * (s - 1) / E).
Proof. by move=> n0 E0; rewrite frame_generic FJ21_3_5_generic; apply: FJ21_C4_1_frame; rewrite ?natrF0. Qed.

(** FJ21.C4.1 sigma: $\sigma=\frac\lambda{\lambda-\nu}$ is 1 iff $\nu=0$.
    Hypotheses: $\lambda\ne\nu$, so that $\sigma$ has a meaning. *)
Theorem FJ21_C4_1_sigma (R : fieldType) (lam nu : R) : lam - nu != 0 -> lam / (lam - nu) = 1 <-> nu = 0.
Proof.
move=> d0; split=> [|e]; last by move: d0; rewrite e subr0 => /divff.
by move/(canRL (divfK d0)); rewrite mul1r => /eqP; rewrite -subr_eq0 opprB addrCA subrr addr0 => /eqP.
Qed.

Lemma generic_linear m a b (p : 'rV[{poly F}]_m) : generic (linear a b *: p) = linear (a%:P%:F) (b%:P%:F) *: generic p.
Proof.
apply/rowP=> k; rewrite !mxE -![map_poly (fun a : F => a%:P%:F) _]/(map_poly constant _) rmorphM; congr (_ * _).
by rewrite /linear rmorphD /= map_polyC -mul_polyC rmorphM /= map_polyC map_polyX mul_polyC.
Qed.

(** FJ21.5.3 functions: (5.3) for rational functions $\Lambda,M,\sigma$ of $t$, where $f(\tilde\Lambda)$ is the function $a+b\tilde\Lambda$ for $f=a+bt$.
    Hypotheses: $nf+f(\tilde\Lambda)$ and $ng+g(\tilde M)$ are not the zero function; $n$ and $n+1$ are not 0 in the field.
    Paper: states none of them. *)
Theorem FJ21_5_3_functions m n (p q : 'rV[{poly F}]_m) L M s a b a' b' (T : K := 'X%:F) (f := fun x : K => a%:P%:F + b%:P%:F * x)
    (g := fun x : K => a'%:P%:F + b'%:P%:F * x) (H := n%:R * f T + f L) (G := n%:R * g T + g M) :
  n%:R != 0 :> F -> n.+1%:R != 0 :> F -> H != 0 -> G != 0 ->
  frelated n.+1 (linear a b *: p) (linear a' b' *: q) L M s <->
  frelated n p q ((n%:R * f T * L + f L * T) / H) ((n%:R * g T * M + g M * T) / G) (G / H * s).
Proof.
move=> n0 n1 H0 G0; rewrite !FJ21_3_5_generic !generic_linear.
by have := @FJ21_5_3_elevation _ m n (generic p) (generic q) T L M s a%:P%:F b%:P%:F a'%:P%:F b'%:P%:F;
  cbv zeta; rewrite !linearE; apply; rewrite ?natrF0.
Qed.

(** FJ21.5.4 functions: (5.4) for rational functions $\Lambda,M,\sigma$ of $t$, where $f(\tilde\Lambda)$ is the function $a+b\tilde\Lambda$ for $f=a+bt$.
    Hypotheses: $G$ and $H$ are not the zero function; $n$ and $n+1$ are not 0 in the field.
    Paper: states none of them. *)
Theorem FJ21_5_4_functions m n (p q : 'rV[{poly F}]_m) L M s a b a' b' (T : K := 'X%:F) (f := fun x : K => a%:P%:F + b%:P%:F * x)
    (g := fun x : K => a'%:P%:F + b'%:P%:F * x) (G := n%:R * g T + g M) (H := f L + n%:R * f T + s * (g M - f M + n%:R * (g T - f T))) :
  n%:R != 0 :> F -> n.+1%:R != 0 :> F -> G != 0 -> H != 0 ->
  frelated n.+1 (linear a b *: p) (linear a b *: p + linear a' b' *: (q - p)) L M s <->
  frelated n p q ((f L * T + n%:R * f T * L + s * (n%:R * M * (g T - f T) + T * (g M - f M))) / H) ((g M * T + n%:R * g T * M) / G) (s * G / H).
Proof.
move=> n0 n1 G0 H0; have sum (r r' : 'rV[{poly F}]_m) : generic (r + r') = generic r + generic r'.
  by apply/rowP=> k; rewrite !mxE -![map_poly (fun a : F => a%:P%:F) _]/(map_poly constant _) rmorphD.
have sub (r r' : 'rV[{poly F}]_m) : generic (r - r') = generic r - generic r'.
  by apply/rowP=> k; rewrite !mxE -![map_poly (fun a : F => a%:P%:F) _]/(map_poly constant _) rmorphB.
rewrite !FJ21_3_5_generic sum !generic_linear sub.
by have := @FJ21_5_4_rulings _ m n (generic p) (generic q) T L M s a%:P%:F b%:P%:F a'%:P%:F b'%:P%:F;
  cbv zeta; rewrite !linearE; apply; rewrite ?natrF0.
Qed.
End Functions.
