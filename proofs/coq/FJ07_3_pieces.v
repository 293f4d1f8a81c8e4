(* FJ07, section 3, from piece to piece: equations (10) and (11).
   Definitions:
     len u n k        the length u_{n+k-1} - u_{n+k-2} of piece k = 1, 2, ...
     local u n k x    the coordinate (x - u_{n+k-2}) / len of the parameter x in piece k: Lam_k is local of L*, M_k of M*
   Pieces count from 0 here: k stands for the paper's k - 1. *)
From Torse Require Import Prelude.

Section Pieces.
Variable F : fieldType.
Implicit Types (u lam mu : nat -> F) (n k j : nat) (L M : F).

(* n is one less than the degree: piece k is [u_{n+k}, u_{n+k+1}]. *)
Definition len u n k := u (n + k).+1 - u (n + k)%N.
Definition local u n k x := (x - u (n + k)%N) / len u n k.

(** FJ07.10 star: $(1-\Lambda_k)u_{n+k-2}+\Lambda_ku_{n+k-1}=\Lambda^{*}$ on every piece.
    Hypotheses: piece $k$ is not empty. *)
Theorem FJ07_10_star u n k x : len u n k != 0 ->
  (1 - local u n k x) * u (n + k)%N + local u n k x * u (n + k).+1 = x.
Proof. by rewrite /local /len => h; field. Qed.

(** FJ07.10 recursion: $\Lambda_k=\frac{\Delta u_{n+k-3}}{\Delta u_{n+k-2}}(\Lambda_{k-1}-1)$; $M_k$ likewise.
    Hypotheses: piece $k-1$ is not empty, nor is piece $k$, so that $\Lambda_k$ has a meaning. *)
Theorem FJ07_10_recursion u n k x : len u n k != 0 -> len u n k.+1 != 0 ->
  local u n k.+1 x = len u n k / len u n k.+1 * (local u n k x - 1).
Proof.
rewrite /local /len addnS => h h'.
by field; rewrite ?h ?h'.
Qed.

(** FJ07.10 jump: $\Lambda_k=(\Delta u_{n+j-2}\Lambda_j+u_{n+j-2}-u_{n+k-2})/\Delta u_{n+k-2}$ for any pieces $j,k$.
    Hypotheses: piece $j$ is not empty; nor is piece $k$, where $\Lambda_k$ is to have a meaning. *)
Theorem FJ07_10_jump u n j k x : len u n j != 0 ->
  local u n k x = (len u n j * local u n j x + u (n + j)%N - u (n + k)%N) / len u n k.
Proof. by move=> h; rewrite /local mulrCA mulfV // mulr1 subrK. Qed.

(** FJ07.10 unique: a sequence that obeys the recursion comes from one $\Lambda^{*}$.
    Hypotheses: no piece is empty, so that the quotients have a meaning. *)
Theorem FJ07_10_unique u n (Lam : nat -> F) K : (forall k, (k <= K)%N -> len u n k != 0) ->
  (forall k, (k < K)%N -> Lam k.+1 = len u n k / len u n k.+1 * (Lam k - 1)) ->
  forall k, (k <= K)%N -> Lam k = local u n k ((1 - Lam 0%N) * u (n + 0)%N + Lam 0%N * u (n + 0).+1).
Proof.
move=> hl rec; elim=> [|k ih] le_k; first by have := hl 0%N isT; rewrite /local /len => h; field.
by rewrite rec // ih 1?ltnW // FJ07_10_recursion // hl // ltnW.
Qed.

(** FJ07.11 recursion: $\lambda_k=\Lambda_k/M_k$ and $\mu_k=1-1/M_k$ obey
    $\mu_k=1+\frac{\Delta u_{n+k-2}}{\Delta u_{n+k-3}}(1-1/\mu_{k-1})$, $\lambda_k=(\lambda_{k-1}+\mu_{k-1}-1)/\mu_{k-1}$.
    Hypotheses: both pieces are not empty, so that $\Lambda_k$, $M_k$ have a meaning; $M_{k-1}\ne0$ and $M_k\ne0$, that is $\mu_{k-1}\ne0$: $M^{*}$ starts neither piece.
    Paper: states none of them. *)
Theorem FJ07_11_recursion u n k L M (Lam := local u n k L) (Mu := local u n k M)
    (Lam' := local u n k.+1 L) (Mu' := local u n k.+1 M) :
  len u n k != 0 -> len u n k.+1 != 0 -> Mu != 0 -> Mu' != 0 ->
  1 - Mu'^-1 = 1 + len u n k.+1 / len u n k * (1 - (1 - Mu^-1)^-1) /\
  Lam' / Mu' = (Lam / Mu + (1 - Mu^-1) - 1) / (1 - Mu^-1).
Proof.
move=> h h'; rewrite /Lam' /Mu' !FJ07_10_recursion // -/Lam -/Mu => m0 m1.
have m1' : Mu - 1 != 0 by apply: contraNneq m1 => ->; rewrite mulr0.
by split; field; rewrite ?m0 ?h ?h' ?m1'.
Qed.

Section Recursion.
Variables (u lam mu : nat -> F) (n K : nat).
Hypothesis pieces : forall k, (k <= K)%N -> len u n k != 0.
Hypothesis mu_rec : forall k, (k < K)%N -> mu k.+1 = 1 + len u n k.+1 / len u n k * (1 - (mu k)^-1).
Hypothesis lam_rec : forall k, (k < K)%N -> lam k.+1 = (lam k + mu k - 1) / mu k.
Hypothesis mu_neq0 : forall k, (k < K)%N -> mu k != 0.

(** FJ07.11 cylinder: $\lambda_k=1$ on one piece iff on all.
    Hypotheses: $\mu_1,\dots,\mu_{N-1}\ne0$, so that the recursion has a meaning.
    Paper: "regardless of the values of $\mu$"; at $\mu_k=0$ the recursion stops. *)
Theorem FJ07_11_cylinder j k : (j <= K)%N -> (k <= K)%N -> lam j = 1 -> lam k = 1.
Proof.
suff iff0 k' : (k' <= K)%N -> (lam k' == 1) = (lam 0%N == 1).
  by move=> le_j le_k /eqP; rewrite iff0 // -(iff0 k) // => /eqP.
elim: k' => // k' ih lt_k; rewrite -ih 1?ltnW // lam_rec //; have m0 := mu_neq0 lt_k.
rewrite -[X in _ == X](divff m0) (inj_eq (mulIf _)) ?invr_eq0 // -subr_eq0 -[RHS]subr_eq0.
by congr (_ == 0); ring.
Qed.

(** FJ07.11 cone: $\mu_k=1$ on one piece iff on all.
    Hypotheses: no piece is empty; $\mu_1,\dots,\mu_{N-1}\ne0$, so that the recursion has a meaning. *)
Theorem FJ07_11_cone j k : (j <= K)%N -> (k <= K)%N -> mu j = 1 -> mu k = 1.
Proof.
suff iff0 k' : (k' <= K)%N -> (mu k' == 1) = (mu 0%N == 1).
  by move=> le_j le_k /eqP; rewrite iff0 // -(iff0 k) // => /eqP.
elim: k' => // k' ih lt_k; rewrite -ih 1?ltnW // mu_rec //; have m0 := mu_neq0 lt_k.
rewrite -subr_eq0 addrC addKr mulf_eq0 mulf_eq0 invr_eq0 (negPf (pieces lt_k)) (negPf (pieces (ltnW lt_k))) /=.
by rewrite subr_eq0 eq_sym -{1}invr1 (inj_eq invr_inj).
Qed.
End Recursion.

(** FJ07.11 needs_mu: at $\mu_{k-1}=0$ and $\lambda_{k-1}=1$ the equation $\mu_{k-1}\lambda_k=\lambda_{k-1}+\mu_{k-1}-1$ holds for all $\lambda_k$, and
    $\mu_{k-1}\mu_k=\mu_{k-1}+r(\mu_{k-1}-1)$, $r=\Delta u_{n+k-2}/\Delta u_{n+k-3}\ne0$, for no $\mu_k$. *)
Theorem FJ07_11_needs_mu (lam mu r : F) : r != 0 -> 0 * lam = 1 + 0 - 1 /\ 0 * mu <> 0 + r * (0 - 1).
Proof. by move=> r0; rewrite !mul0r addr0 subrr add0r sub0r mulrN1; split=> // /esym/eqP; rewrite oppr_eq0 (negPf r0). Qed.

End Pieces.
