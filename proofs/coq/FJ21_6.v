(* FJ21, section 6: the edge of regression. *)
From Torse Require Import Prelude Blossom Curves Points FJ21_4.

Section Edge.
Variables (F : fieldType) (m : nat).
Implicit Types (p q r : 'rV[{poly F}]_m) (t L M s : F) (n : nat).

(** FJ21.6 edge: with $E=\Lambda-t+\sigma(t-M)$, $v=\sigma(t-M)/E$, $\alpha=n\sigma(\Lambda-M)/E^2$, $\beta=n(\sigma-1)/E$:
    $(1-v)p'+vq'=\alpha(q-p)+\beta((1-v)p+vq)$: at $v$ the surface is singular.
    Hypotheses: $E\ne0$, and $n\ne0$ in the field.
    Paper: states neither. *)
Theorem FJ21_6_edge n p q t L M s (E := L - t + s * (t - M)) (v := s * (t - M) / E) : n%:R != 0 :> F -> E != 0 ->
  related_at n p q t L M s ->
  (1 - v) *: ev (pderiv p) t + v *: ev (pderiv q) t
    = (n%:R * s * (L - M) / E ^+ 2) *: ev (q - p) t + (n%:R * (s - 1) / E) *: ((1 - v) *: ev p t + v *: ev q t).
Proof.
rewrite /v /E => n0 e0 /rowP eq_p; apply/rowP=> k; have := eq_p k; rewrite !mxE !hornerD !hornerN.
move: (p 0 k).[t] (q 0 k).[t] (p 0 k)^`().[t] (q 0 k)^`().[t] n%:R n0 => P Q P' Q' N n0 eq_P.
by apply: (by_multiple (z := N / (L - t + s * (t - M))) eq_P); field; rewrite n0 e0.
Qed.

(** FJ21.6.1 degree: for constant $\Lambda\ne M$ and $\sigma=1$ the edge $r=(1-v)p+vq$, $v=\frac{t-M}{\Lambda-M}$, is a curve of degree $n+1$:
    $(\Lambda-M)r=(\Lambda-t)p+(t-M)q$.
    Hypotheses: $\Lambda\ne M$; $p$, $q$ have degree at most $n$. *)
Theorem FJ21_6_1_degree n p q r L M k : L != M -> (L - M)%:P *: r = (L%:P - 'X) *: p + ('X - M%:P) *: q ->
  (size (p 0%R k) <= n.+1)%N -> (size (q 0%R k) <= n.+1)%N -> (size (r 0%R k) <= n.+2)%N.
Proof.
move=> ne /rowP/(_ k); rewrite !mxE mul_polyC => e sp sq.
rewrite -(@size_scale _ (L - M)) ?subr_eq0 // e.
have lin (f g : {poly F}) : (size f <= 2)%N -> (size g <= n.+1)%N -> (size (f * g)%R <= n.+2)%N.
  by move=> sf sg; apply: leq_trans (size_mul_leq _ _) _; move: (size f) (size g) sf sg => x y; lia.
rewrite (leq_trans (size_add _ _)) // geq_max; apply/andP; split; apply: lin => //; last by rewrite size_XsubC.
by rewrite -[L%:P - 'X]opprB size_opp size_XsubC.
Qed.

(** FJ21.T6.1 tangent: for any curve $r$ the rows $p=r+\frac{M-t}{n+1}r'$, $q=r+\frac{\Lambda-t}{n+1}r'$ obey
    $p[t^{\langle n-1\rangle},\Lambda]=q[t^{\langle n-1\rangle},M]$ for all $t$.
    Hypotheses: $n$ and $n+1$ are not 0 in the field. *)
Theorem FJ21_T6_1_tangent n r L M t : n%:R != 0 :> F -> n.+1%:R != 0 :> F ->
  related_at n (\row_k (r 0 k + (n.+1%:R^-1 *: (M%:P - 'X)) * (r 0 k)^`())) (\row_k (r 0 k + (n.+1%:R^-1 *: (L%:P - 'X)) * (r 0 k)^`())) t L M 1.
Proof.
rewrite natrS => n0 n1; apply/rowP=> k; rewrite !mxE !derivD !derivM !derivZ !derivB !derivC !derivX.
rewrite !(hornerD, hornerN, hornerM, hornerZ, hornerC, hornerX, horner0).
move: (r 0 k).[t] (r 0 k)^`().[t] (r 0 k)^`()^`().[t] n%:R n0 n1 => R R' R'' N n0 n1.
by field; rewrite n0 n1.
Qed.
End Edge.
