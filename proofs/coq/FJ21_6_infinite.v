(* FJ21, Corollary 6.1 where E = Lam - t + sigma (t - M) vanishes identically: v is infinite, and the edge is the curve W = q - p. *)
From Torse Require Import Prelude Blossom Curves Points Functions FJ21_2 FJ21_3_theorem FJ21_4 FJ21_4_gauge.

(* The algebra, in any field. *)
Section Algebra.
Variables (K : fieldType) (m : nat).
Implicit Types (P Q : 'rV[K]_m).

Lemma infinite_edge P P' Q Q' (t L M s n : K) : n != 0 -> L - t + s * (t - M) = 0 ->
  P + ((L - t) / n) *: P' = s *: (Q + ((M - t) / n) *: Q') -> (s * (M - t)) *: (Q' - P') = n *: (P - s *: Q).
Proof.
move=> n0 e0 /rowP e; have eL : L = t + s * (M - t) by apply: (by_multiple (z := 1) e0); ring.
apply/rowP=> k; have := e k; rewrite eL !mxE; move: (P 0 k) (P' 0 k) (Q 0 k) (Q' 0 k) => a a' b b' eq_P.
by apply: (by_multiple (z := - n) eq_P); field.
Qed.

Lemma infinite_direction (w om a b z s n : K) (rho := om - w) (x := b - a) (rho' := n * (w - s * om) / z) (x' := n * (a - s * b) / z) :
  z != 0 -> w != 0 -> om != 0 -> rho != 0 ->
  - rho' / rho ^+ 2 * x + rho^-1 * x' = n * (s - 1) * (w * om) / (z * rho ^+ 2) * (om^-1 * b - w^-1 * a).
Proof. by rewrite /rho' /x' /rho /x => z0 w0 om0 r0; field; rewrite z0 w0 om0 r0. Qed.
End Algebra.

Section Infinite.
Variable F : fieldType.
Notation K := {fraction {poly F}}.
Notation "x %:F" := (@FracField.tofrac [idomainType of {poly F}] x).
Implicit Types (L M s : K) (n m : nat).

Lemma combinationE m (p q : 'rV[{poly F}]_m) (x y : K) k : (x *: (pfun p - y *: pfun q)) 0 k = x * ((p 0 k)%:F - y * (q 0 k)%:F).
Proof. by rewrite !mxE. Qed.

(** FJ21.C6.1 infinite: where $E=\Lambda-t+\sigma(t-M)$ vanishes identically, $W=q-p$ has $\sigma(M-t)W'=n(p-\sigma q)$: the edge is $W$, which is $(1-v)p+vq$ for an infinite
    $v$, as its tangent lies in the ruling.
    Hypotheses: $E=0$; $n\ne0$ in the field, so that $p[t^{\langle n-1\rangle},\Lambda]$ has a meaning.
    Paper: passes over it. *)
Theorem FJ21_C6_1_infinite m n (p q : 'rV[{poly F}]_m) L M s : n%:R != 0 :> F -> L - 'X%:F + s * ('X%:F - M) = 0 -> frelated n p q L M s ->
  (s * (M - 'X%:F)) *: pfderiv (pfun (q - p)) = n%:R *: (pfun p - s *: pfun q).
Proof.
by move=> n0 e0 rel; rewrite pfunB pfderivB !pfderiv_fun; exact: infinite_edge (natrF0 n0) e0 rel.
Qed.

(** FJ21.C6.1 infinite_point: if $\Lambda=t$ as well, then $p=\sigma q$: the rulings are points.
    Hypotheses: $E=0$, $\Lambda=t$. True whatever stands for $\frac1n$ where $n=0$ in the field. *)
Theorem FJ21_C6_1_infinite_point m n (p q : 'rV[{poly F}]_m) M s : s * ('X%:F - M) = 0 -> frelated n p q 'X%:F M s -> pfun p = s *: pfun q.
Proof.
move=> e0; have {}e0 : s * ((M - 'X%:F) / n%:R) = 0 by rewrite mulrA -opprB mulrN e0 oppr0 mul0r.
by rewrite /frelated /ftangent subrr mul0r scale0r addr0 scalerDr scalerA e0 scale0r addr0.
Qed.

(** FJ21.C6.1 infinite_cone: if $\sigma=1$, then all coordinates of $W$ have constant quotients, $W_i'W_j=W_iW_j'$: the edge is one point, the surface a cone, or a cylinder
    where the weights $w=\omega$ are the same.
    Hypotheses: $E=0$, which is $\Lambda=M$. True whatever stands for $\frac1n$ where $n=0$ in the field. *)
Theorem FJ21_C6_1_infinite_cone m n (p q : 'rV[{poly F}]_m) M i j (W := pfun (q - p)) : frelated n p q M M 1 ->
  fderiv (W 0 i) * W 0 j = W 0 i * fderiv (W 0 j).
Proof.
rewrite /frelated /ftangent scale1r; set x := (M - _) / _ => /rowP e.
have dW k : W 0 k = - (x * fderiv (W 0 k)).
  have := e k; rewrite /W pfunB !mxE fderivB !fderiv_poly.
  by move: ((p 0 k)%:F) ((q 0 k)%:F) (((p 0 k)^`())%:F) (((q 0 k)^`())%:F) => a b a' b' h; apply: (by_multiple (z := -1) h); ring.
by rewrite {1}(dW j) {2}(dW i); move: (fderiv (W 0 i)) (fderiv (W 0 j)) => a b; ring.
Qed.

(** FJ21.C6.1 infinite_ruling: in space the tangent of the edge $e=(\omega d-wc)/(\omega-w)$ is the ruling: $e'=\frac{n(\sigma-1)w\omega}{\sigma(M-t)(\omega-w)^2}(d-c)$.
    Hypotheses: $E=0$; $\Lambda\ne t$, $n\ne0$ in the field and the weights $w$, $\omega$, $\omega-w$ do not vanish identically, so that the quotient,
    $p[t^{\langle n-1\rangle},\Lambda]$, $c$, $d$ and $e$ have a meaning; where $\omega=w$ it follows that $\sigma=1$. *)
Theorem FJ21_C6_1_infinite_ruling n (p q : 'rV[{poly F}]_4) L M s : n%:R != 0 :> F -> L - 'X%:F + s * ('X%:F - M) = 0 -> L != 'X%:F ->
  weight p != 0 -> weight q != 0 -> weight (q - p) != 0 -> frelated n p q L M s ->
  pfderiv (affine (q - p)) = (n%:R * (s - 1) * (weight p * weight q)%:F / (s * (M - 'X%:F) * (weight (q - p))%:F ^+ 2)) *: (affine q - affine p).
Proof.
move=> n0 e0 ne w0 om0 r0 rel; have z0 : s * (M - 'X%:F) != 0.
  by apply: contraNneq ne => z; rewrite -subr_eq0 -[L - _](addrK (s * ('X%:F - M))) e0 sub0r -mulrN opprB z.
have /rowP e := FJ21_C6_1_infinite n0 e0 rel.
have dW k : fderiv ((q - p) 0 k)%:F = n%:R * ((p 0 k)%:F - s * (q 0 k)%:F) / (s * (M - 'X%:F)).
  apply: (mulfI z0); rewrite [RHS]mulrCA mulfV // mulr1; have := e k.
  by rewrite [LHS]mxE [pfderiv _ 0 k]mxE pfunE combinationE => ->.
have WE k : ((q - p) 0 k)%:F = (q 0 k)%:F - (p 0 k)%:F :> K by rewrite [(q - p) 0 k]mxE [(- p) 0 k]mxE tofracB.
apply/rowP=> k; rewrite mxE [affine _ 0 k]mxE weightE [place _ 0 k]mxE pfunE fderivM fderivV ?tofrac_eq0 // /weight !dW.
rewrite [RHS]mxE [X in _ = _ * X]mxE [affine q 0 k]mxE [X in _ = _ * (_ + X)]mxE [affine p 0 k]mxE !weightE ![place (pfun _) 0 k]mxE !pfunE /weight !WE tofracM.
by apply: infinite_direction; rewrite ?tofrac_eq0 // -WE tofrac_eq0.
Qed.

(** FJ21.C6.1 infinite_weights: where $E=0$ and $\omega=w$, $\sigma=1$: the surface is the cylinder above.
    Hypotheses: $E=0$; $n\ne0$ in the field and $w$ does not vanish identically, so that $p[t^{\langle n-1\rangle},\Lambda]$ and $c$ have a meaning. *)
Theorem FJ21_C6_1_infinite_weights n (p q : 'rV[{poly F}]_4) L M s : n%:R != 0 :> F -> L - 'X%:F + s * ('X%:F - M) = 0 ->
  weight p != 0 -> weight q = weight p -> frelated n p q L M s -> s = 1.
Proof.
move=> n0 e0 w0 om rel; have /rowP/(_ 0) := FJ21_C6_1_infinite n0 e0 rel.
rewrite /weight in w0 om; rewrite mxE [pfderiv _ 0 0]mxE pfunE [(q - p) 0 0]mxE [(- p) 0 0]mxE om subrr tofrac0.
have -> : fderiv (0 : K) = 0 by rewrite -tofrac0 fderiv_poly linear0 tofrac0.
rewrite mulr0 combinationE om => /esym/eqP.
have -> : (p 0 0)%:F - s * (p 0 0)%:F = (1 - s) * (p 0 0)%:F by rewrite mulrBl mul1r.
by rewrite !mulf_eq0 (negPf (natrF0 n0)) tofrac_eq0 (negPf w0) orbF subr_eq0 => /eqP.
Qed.
End Infinite.
