(* FJ07, section 3: equation (11) in closed form and backwards, and what lam_k = 1 and mu_k = 1 say of L*, M*. *)
From Torse Require Import Prelude FJ07_3_pieces.

Section Classes.
Variable F : fieldType.
Implicit Types (u lam mu : nat -> F) (n k K : nat) (L M : F).

(** FJ07.11 closed: from any $(\lambda_1,\mu_1)$, cones included, $\lambda_k-1=(\lambda_1-1)\Delta u_{n-1}/e_k$,
    $\mu_k-1=(\mu_1-1)\Delta u_{n+k-2}/e_k$ with $e_k=\Delta u_{n-1}+(1-\mu_1)(u_{n-1}-u_{n+k-2})\ne0$.
    Hypotheses: no piece is empty and $\mu_1,\dots,\mu_{k-1}\ne0$, so that the quotients of (11) have a meaning. *)
Theorem FJ07_11_closed u lam mu n K (e := fun k => len u n 0 + (1 - mu 0%N) * (u (n + 0)%N - u (n + k)%N)) :
  (forall k, (k <= K)%N -> len u n k != 0) -> (forall k, (k < K)%N -> mu k != 0) ->
  (forall k, (k < K)%N -> mu k.+1 = 1 + len u n k.+1 / len u n k * (1 - (mu k)^-1)) ->
  (forall k, (k < K)%N -> lam k.+1 = (lam k + mu k - 1) / mu k) ->
  forall k, (k <= K)%N -> [/\ e k != 0, lam k - 1 = (lam 0%N - 1) * len u n 0 / e k & mu k - 1 = (mu 0%N - 1) * len u n k / e k].
Proof.
move=> pieces mu0 mu_rec lam_rec; elim=> [_|k ih lt_k].
  have l0 := pieces 0%N isT; have e0 : e 0%N = len u n 0 by rewrite /e subrr mulr0 addr0.
  by rewrite e0 !mulfK.
have [e0 eq_l eq_m] := ih (ltnW lt_k); have m0 := mu0 k lt_k; have l0 := pieces k (ltnW lt_k).
have eS : e k.+1 = e k + (mu 0%N - 1) * len u n k by rewrite /e /len addnS; ring.
have em : mu k = e k.+1 / e k by rewrite eS mulrDl divff // -eq_m addrC subrK.
have e1 : e k.+1 != 0 by apply: contraNneq m0 => z; rewrite em z mul0r.
have el : lam k = 1 + (lam 0%N - 1) * len u n 0 / e k by rewrite -eq_l addrC subrK.
split=> //; first by rewrite lam_rec // em el; move: (e k) (e k.+1) (len u n 0) e0 e1 => a b l a0 b0; field; rewrite a0 b0.
rewrite mu_rec // em addrAC subrr add0r; have -> : (mu 0%N - 1) = (e k.+1 - e k) / len u n k by rewrite eS addrAC subrr add0r mulfK.
by move: (e k) (e k.+1) (len u n k) (len u n k.+1) e0 e1 l0 => a b l l' a0 b0 l0; field; rewrite a0 b0 l0.
Qed.

(** FJ07.11 cone_same: where $\mu=1$ all pieces have the same $\lambda$: all parts of a cone share it. *)
Theorem FJ07_11_cone_same lam mu K : (forall k, (k < K)%N -> lam k.+1 = (lam k + mu k - 1) / mu k) -> (forall k, (k < K)%N -> mu k = 1) ->
  forall k, (k <= K)%N -> lam k = lam 0%N.
Proof. by move=> rec cone; elim=> // k ih lt_k; rewrite rec // cone // addrK divr1 ih // ltnW. Qed.

(** FJ07.11 backward: $\mu_{k-1}=\left(1-\frac{\Delta u_{n+k-3}}{\Delta u_{n+k-2}}(\mu_k-1)\right)^{-1}$, $\lambda_{k-1}=1+\mu_{k-1}(\lambda_k-1)$.
    Hypotheses: piece $k$ is not empty; nor is piece $k-1$ and $\mu_{k-1}\ne0$, so that $\lambda_k$, $\mu_k$ have a meaning. *)
Theorem FJ07_11_backward (l l' lam mu : F) (mu' := 1 + l' / l * (1 - mu^-1)) (lam' := (lam + mu - 1) / mu) :
  l != 0 -> l' != 0 -> mu != 0 -> (1 - l / l' * (mu' - 1))^-1 = mu /\ 1 + mu * (lam' - 1) = lam.
Proof.
move=> l0 l0' m0; have -> : 1 - l / l' * (mu' - 1) = mu^-1 by rewrite /mu'; field; rewrite l0 l0' m0.
by rewrite invrK /lam'; split=> //; field.
Qed.

(** FJ07.11 parallel: $\lambda_k=\Lambda_k/M_k=1$ iff $\Lambda^{*}=M^{*}$, whatever the piece.
    Hypotheses: the piece is not empty and $M^{*}$ not its start, $M_k\ne0$, so that the quotients have a meaning. *)
Theorem FJ07_11_parallel u n k L M : len u n k != 0 -> local u n k M != 0 -> local u n k L / local u n k M = 1 <-> L = M.
Proof.
move=> l0 m0; split=> [e|->]; last by rewrite divff.
have := FJ07_10_star L l0; have -> : local u n k L = local u n k M by rewrite -(divfK m0 (local u n k L)) e mul1r.
by rewrite FJ07_10_star.
Qed.

(** FJ07.11 no_cone: no $M^{*}$ has $\mu_k=1-1/M_k=1$: the cones of (11) have no relation of Theorem 1.
    Hypotheses: $M_k\ne0$, so that $1/M_k$ has a meaning. *)
Theorem FJ07_11_no_cone (M : F) : M != 0 -> 1 - M^-1 != 1.
Proof. by move=> m0; rewrite -subr_eq0 addrAC subrr add0r oppr_eq0 invr_neq0. Qed.
End Classes.
