(* FJ21, section 5: what operations on the curves do to Lam, M, sigma.
   Definitions:
     linear a b       the factor a + b X of degree one *)
From Torse Require Import Prelude Blossom Curves Points FJ07_3_blossoms FJ21_4.

Section Features.
Variables (F : fieldType) (m : nat).
Implicit Types (p q : 'rV[{poly F}]_m) (f g : {poly F}) (t L M s a b : F) (n : nat).

Definition linear a b : {poly F} := a%:P + b *: 'X.

Lemma linearE a b t : (linear a b).[t] = a + b * t.
Proof. by rewrite /linear hornerD hornerC hornerZ hornerX. Qed.

Lemma deriv_linear a b : (linear a b)^`() = b%:P.
Proof. by rewrite /linear derivD derivC derivZ derivX add0r -mul_polyC mulr1. Qed.

(** FJ21.W weights: weights times $\alpha$, $\beta$ leave $\Lambda$, $M$ and make $\alpha\sigma/\beta$ of $\sigma$.
    Hypotheses: $\beta\ne0$. *)
Theorem FJ21_W_weights n p q t L M s (alpha beta : F) : beta != 0 -> related_at n p q t L M s ->
  related_at n (alpha%:P *: p) (beta%:P *: q) t L M (alpha * s / beta).
Proof.
move=> nz /rowP eq_p; apply/rowP=> k; have := eq_p k; rewrite !mxE !derivM !derivC !(hornerD, hornerM, hornerC, horner0).
rewrite !mul0r !add0r; move: (p 0 k).[t] (q 0 k).[t] (p 0 k)^`().[t] (q 0 k)^`().[t] (_ / _) (_ / _) => P Q P' Q' x y eq_P.
by apply: (by_multiple (z := alpha) eq_P); field.
Qed.

(** FJ21.5.3 elevation: for $\tilde p=fp$, $\tilde q=gq$ with $f,g$ of degree one, a relation $\tilde\Lambda,\tilde M,\tilde\sigma$ in degree $n+1$ is one
    in degree $n$ with $\Lambda=\frac{nf(t)\tilde\Lambda+f(\tilde\Lambda)t}{nf(t)+f(\tilde\Lambda)}$, $M$ likewise with $g$,
    $\sigma=\frac{ng(t)+g(\tilde M)}{nf(t)+f(\tilde\Lambda)}\tilde\sigma$, and conversely.
    Hypotheses: $nf(t)+f(\tilde\Lambda)\ne0$ and $ng(t)+g(\tilde M)\ne0$; $n$ and $n+1$ are not 0 in the field.
    Paper: states none of them. *)
Theorem FJ21_5_3_elevation n p q t L M s a b a' b' (f := linear a b) (g := linear a' b')
    (H := n%:R * f.[t] + f.[L]) (G := n%:R * g.[t] + g.[M]) :
  n%:R != 0 :> F -> n.+1%:R != 0 :> F -> H != 0 -> G != 0 ->
  related_at n.+1 (f *: p) (g *: q) t L M s <->
  related_at n p q t ((n%:R * f.[t] * L + f.[L] * t) / H) ((n%:R * g.[t] * M + g.[M] * t) / G) (G / H * s).
Proof.
rewrite /H /G /f /g !linearE natrS => n0 n1 h0 g0; rewrite /related_at /tangent.
split=> /rowP eq_p; apply/rowP=> k; have := eq_p k; rewrite !mxE !derivM !deriv_linear /linear !(hornerD, hornerM, hornerC, hornerZ, hornerX) ?natrS;
  move: (p 0 k).[t] (q 0 k).[t] (p 0 k)^`().[t] (q 0 k)^`().[t] n%:R n0 n1 h0 g0 => P Q P' Q' N n0 n1 h0 g0 eq_P.
  by apply: (by_multiple (z := (N + 1) / (N * (a + b * t) + (a + b * L))) eq_P); field; rewrite n0 n1 h0 g0.
by apply: (by_multiple (z := (N * (a + b * t) + (a + b * L)) / (N + 1)) eq_P); field; rewrite n0 n1 h0 g0.
Qed.

(** FJ21.5.2 blossom: weights times $b^{n-i}$ are the substitution $(a,w)\mapsto(a,(1-b)a+bw)$ in every argument:
    $\tilde p[u_1,\dots,u_n]=\prod_i((1-b)u_i+b)\;p[\frac{u_1}{(1-b)u_1+b},\dots]$. *)
Theorem FJ21_5_2_blossom (c : nat -> F) b v :
  blossom (step01 F (size v)) (fun i => b ^+ (size v - i) * c i) v
    = blossom (step01 F (size v)) c [seq (x.1, (1 - b) * x.1 + b * x.2) | x <- v].
Proof.
elim: v c => [|x v ih] c /=; first by rewrite subn0 mul1r.
rewrite -/(size v) size_map.
rewrite (@blossom_ext_knots _ _ (step01 F (size v))) // -[RHS](@blossom_ext_knots _ (step01 F (size v))) //.
rewrite -ih; apply: blossom_ext => i le_i; rewrite /step /step01 leq_addl leqNgt ltnS le_i /= !subr0 !divr1 !mulr1 !mulr0 !subr0.
by rewrite subSn // exprS subSS; ring.
Qed.
End Features.
