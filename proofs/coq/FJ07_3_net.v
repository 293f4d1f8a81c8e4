(* FJ07, section 3, the linear construction: equations (13) to (17).
   Definitions:
     cell u n L M c d i   equation (13) of the cell i, for points of any dimension
     net u n L M c d0     the row d of the construction
     P u n M a b, Q u n M i N   the products of (14) to (16) *)
From Torse Require Import Prelude Points.

Section Net.
Variables (F : fieldType) (m : nat).
Implicit Types (u : nat -> F) (c d : nat -> 'rV[F]_m) (L M beta : F) (n N K : nat).

Definition cell u n L M c d i :=
  (u (i + n)%N - L) *: c i + (L - u i) *: c i.+1 = (u (i + n)%N - M) *: d i + (M - u i) *: d i.+1.
Fixpoint net u n L M c (d0 : 'rV[F]_m) i : 'rV[F]_m := if i is j.+1 then
  (M - u j)^-1 *: ((M - u (j + n)%N) *: net u n L M c d0 j + (u (j + n)%N - L) *: c j + (L - u j) *: c j.+1)
  else d0.
Definition P u n M a b := \prod_(a <= i < b) ((M - u (i + n)%N) / (M - u i)).
Definition Q u n M i N := \prod_(i <= j < N.-1) ((M - u (n + j).+1) / (M - u j)).

(** FJ07.13 exists: for every $c$, $d_0$, $\Lambda^{*}$, $M^{*}$ the recursion gives a row $d$ with
    $(u_{i+n}-\Lambda^{*})c_i+(\Lambda^{*}-u_i)c_{i+1}=(u_{i+n}-M^{*})d_i+(M^{*}-u_i)d_{i+1}$, $i=0..L-1$.
    Hypotheses: $M^{*}$ is none of $u_0,\dots,u_{L-1}$.
    Paper: states no hypothesis. *)
Theorem FJ07_13_exists u n L M c (d0 : 'rV_m) K : (forall i, (i < K)%N -> M - u i != 0) ->
  net u n L M c d0 0 = d0 /\ forall i, (i < K)%N -> cell u n L M c (net u n L M c d0) i.
Proof.
move=> h; split=> // i /h nz; rewrite /cell /= scalerA mulfV // scale1r.
by by_entries k; ring.
Qed.

(** FJ07.13 unique: there is no other row.
    Hypotheses: $M^{*}$ is none of $u_0,\dots,u_{L-1}$. *)
Theorem FJ07_13_unique u n L M c d d' K : (forall i, (i < K)%N -> M - u i != 0) ->
  (forall i, (i < K)%N -> cell u n L M c d i) -> (forall i, (i < K)%N -> cell u n L M c d' i) ->
  d 0%N = d' 0%N -> forall i, (i <= K)%N -> d i = d' i.
Proof.
move=> h hd hd' e0; elim=> // i ih lt_i; have := hd' i lt_i; rewrite /cell (hd i lt_i) ih 1?ltnW //.
by move/addrI/(scalerI (h i lt_i)).
Qed.

(** FJ07.13 knot: where $M^{*}=u_i$ the cell $i$ does not determine $d_{i+1}$ and binds $d_i$: it holds iff
    $(u_{i+n}-\Lambda^{*})c_i+(\Lambda^{*}-u_i)c_{i+1}=(u_{i+n}-u_i)d_i$, whatever $d_{i+1}$ is. *)
Theorem FJ07_13_knot u n L c d i :
  cell u n L (u i) c d i <-> (u (i + n)%N - L) *: c i + (L - u i) *: c i.+1 = (u (i + n)%N - u i) *: d i.
Proof. by rewrite /cell subrr scale0r addr0. Qed.

(** FJ07.13 knot_line: at $M^{*}=u_i$ and $\Lambda^{*}=M^{*}$ the cell asks for $c_i=d_i$, the ruling shrinks to a point.
    Hypotheses: $u_{i+n}\ne u_i$. *)
Theorem FJ07_13_knot_line u n c d i : u (i + n)%N - u i != 0 -> cell u n (u i) (u i) c d i <-> c i = d i.
Proof. by move=> h; rewrite FJ07_13_knot subrr scale0r addr0; split=> [/(scalerI h)|->]. Qed.

(** FJ07.13 rulings: the recursion for the rulings $w_i=d_i-c_i$:
    $(M^{*}-u_i)w_{i+1}=(M^{*}-u_{i+n})w_i+(\Lambda^{*}-M^{*})(c_{i+1}-c_i)$ is equation (13). *)
Theorem FJ07_13_rulings u n L M c d i : cell u n L M c d i <->
  (M - u i) *: (d i.+1 - c i.+1) = (M - u (i + n)%N) *: (d i - c i) + (L - M) *: (c i.+1 - c i).
Proof.
by apply: eq_of_diff; by_entries k; ring.
Qed.

(** FJ07.17 restriction: $\tilde d_i=c_i+\beta(d_i-c_i)$ obeys (13) with $\tilde M^{*}=M^{*}$, $\tilde\Lambda^{*}=M^{*}+\beta(\Lambda^{*}-M^{*})$. *)
Theorem FJ07_17_restriction u n L M beta c d i : cell u n L M c d i ->
  cell u n (M + beta * (L - M)) M c (fun j => c j + beta *: (d j - c j)) i.
Proof.
rewrite !FJ07_13_rulings => eq_w; have e j : c j + beta *: (d j - c j) - c j = beta *: (d j - c j).
  by rewrite addrAC subrr add0r.
have {}e j : (fun j => c j + beta *: (d j - c j)) j - c j = beta *: (d j - c j) by exact: e.
rewrite !e scalerA mulrC -scalerA eq_w scalerDr !scalerA (addrAC M) subrr add0r.
by congr (_ *: _ + _); rewrite mulrC.
Qed.

(** FJ07.17 swap: exchanging $c$ and $d$ exchanges $\Lambda^{*}$ and $M^{*}$. *)
Theorem FJ07_17_swap u n L M c d i : cell u n L M c d i <-> cell u n M L d c i.
Proof. by rewrite /cell; split=> ->. Qed.

End Net.

Section ClosedForms.
Variables (F : fieldType) (m : nat).
Variables (u : nat -> F) (n : nat) (L M : F) (c d : nat -> 'rV[F]_m) (N : nat).
Hypothesis off : forall i, (i < N)%N -> M - u i != 0.
Hypothesis cells : forall i, (i < N)%N -> cell u n L M c d i.
Local Notation P := (P u n M).
Local Notation Q := (Q u n M).

Let ratio i := (M - u (i + n)%N) / (M - u i).

Lemma P_recr a b : (a <= b)%N -> P a b.+1 = P a b * ratio b.
Proof. by move=> le_ab; rewrite /P big_nat_recr. Qed.

Lemma P_last b : P b b = 1.
Proof. by rewrite /P big_geq. Qed.

(** FJ07.16 closed: $d_N-c_N=P(0,N)(d_0-c_0)+(\Lambda^{*}-M^{*})\sum_{i=0}^{N-1}P(i+1,N)\frac{c_{i+1}-c_i}{M^{*}-u_i}$.
    Hypotheses: $M^{*}$ is none of $u_0,\dots,u_{N-1}$.
    Paper: states none. *)
Theorem FJ07_16_closed k : (k <= N)%N ->
  d k - c k = P 0 k *: (d 0%N - c 0%N) + (L - M) *: \sum_(0 <= i < k) (P i.+1 k / (M - u i)) *: (c i.+1 - c i).
Proof.
elim: k => [|k ih] lt_k; first by rewrite big_geq // P_last scale1r scaler0 addr0.
have nz := off lt_k; have := cells lt_k; rewrite FJ07_13_rulings => eq_w.
apply: (scalerI nz); rewrite eq_w (ih (ltnW lt_k)) big_nat_recr //= P_last P_recr //.
rewrite [in RHS](eq_big_nat _ _ (F2 := fun i => ratio k *: ((P i.+1 k / (M - u i)) *: (c i.+1 - c i)))); last first.
  by move=> i lt_i; rewrite P_recr // scalerA; congr (_ *: _); ring.
rewrite -scaler_sumr; set S := \sum_(0 <= i < k) _; move: S (P 0 k) => S p.
by rewrite /ratio; by_entries j; field.
Qed.

Lemma P_Q i : (i < N)%N -> forall K, (i <= K)%N -> (K < N)%N -> P i.+1 K.+1 / (M - u i) = Q i K.+1 / (M - u K).
Proof.
move=> lt_i; elim=> [|K ih] le_K lt_K.
  by move: le_K; rewrite leqn0 => /eqP ->; rewrite P_last /Q big_geq.
move: le_K; rewrite leq_eqVlt => /orP[/eqP <-|le_K]; first by rewrite P_last /Q big_geq.
rewrite P_recr // /Q [K.+2.-1]/= big_nat_recr //= -/(Q i K.+1) mulrAC (ih le_K (ltnW lt_K)) /ratio.
have := off lt_K; have := off (ltnW lt_K); rewrite [(K.+1 + n)%N]addnC addnS.
by move: (Q i K.+1) => q h1 h2; field; rewrite h1 h2.
Qed.

(** FJ07.15 closed: $d_N-c_N=P(0,N)(d_0-c_0)+\frac{\Lambda^{*}-M^{*}}{M^{*}-u_{N-1}}\{c_N-\frac{M^{*}-u_{N-1}}{M^{*}-u_0}P(1,N)c_0
    -\sum_{i=1}^{N-1}\frac{u_{i+n}-u_{i-1}}{M^{*}-u_{i-1}}Q(i,N)c_i\}$, for $N\ge1$.
    Hypotheses: $M^{*}$ is none of $u_0,\dots,u_{N-1}$. *)
Theorem FJ07_15_closed K : (K < N)%N ->
  d K.+1 - c K.+1 = P 0 K.+1 *: (d 0%N - c 0%N) + ((L - M) / (M - u K)) *:
    (c K.+1 - ((M - u K) / (M - u 0%N) * P 1 K.+1) *: c 0%N
      - \sum_(1 <= i < K.+1) ((u (i + n)%N - u i.-1) / (M - u i.-1) * Q i K.+1) *: c i).
Proof.
move=> lt_K; rewrite FJ07_16_closed //; congr (_ + _).
rewrite -scalerA; congr (_ *: _); elim: K lt_K => [|K ih] lt_K.
  rewrite big_nat1 P_last mulr1 [\sum_(1 <= i < 1) _]big_geq // subr0 mulfV ?off // scale1r.
  by rewrite mul1r.
have nz := off (ltnW lt_K); have nz' := off lt_K; have nz0 := off (leq_ltn_trans (leq0n _) lt_K).
rewrite big_nat_recr //= P_last mul1r.
rewrite [\sum_(0 <= i < K.+1) _](eq_big_nat _ _ (F2 := fun i => ratio K.+1 *: ((P i.+1 K.+1 / (M - u i)) *: (c i.+1 - c i))));
  last by move=> i lt_i; rewrite P_recr // scalerA; congr (_ *: _); ring.
have Q1 : Q K.+1 K.+2 = 1 by rewrite /Q big_geq.
rewrite -scaler_sumr (ih (ltnW lt_K)) [in RHS]big_nat_recr //= [P 1 K.+2]P_recr // Q1 mulr1.
rewrite [in RHS](eq_big_nat _ _ (F2 := fun i => ((M - u (n + K).+1) / (M - u K)) *:
   (((u (i + n)%N - u i.-1) / (M - u i.-1) * Q i K.+1) *: c i))); last first.
  move=> i /andP[le_i lt_i]; rewrite scalerA; congr (_ *: _).
  by rewrite /Q [K.+2.-1]/= big_nat_recr //=; ring.
rewrite -scaler_sumr; set S := \sum_(1 <= i < K.+1) _; move: S (P 1 K.+1) => S p.
rewrite /ratio [(K.+1 + n)%N]addnC addnS; move: (u (n + K).+1) => U.
by by_entries j; field; rewrite nz0 nz nz'.
Qed.

(** FJ07.14 closed: $d_N=P(0,N)d_0+\frac{u_n-\Lambda^{*}}{M^{*}-u_0}P(1,N)c_0+\frac{\Lambda^{*}-u_{N-1}}{M^{*}-u_{N-1}}c_N
    +\frac{M^{*}-\Lambda^{*}}{M^{*}-u_{N-1}}\sum_{i=1}^{N-1}\frac{u_{i+n}-u_{i-1}}{M^{*}-u_{i-1}}Q(i,N)c_i$, for $N\ge1$.
    Hypotheses: $M^{*}$ is none of $u_0,\dots,u_{N-1}$. *)
Theorem FJ07_14_closed K : (K < N)%N ->
  d K.+1 = P 0 K.+1 *: d 0%N + ((u n - L) / (M - u 0%N) * P 1 K.+1) *: c 0%N + ((L - u K) / (M - u K)) *: c K.+1
    + ((M - L) / (M - u K)) *: \sum_(1 <= i < K.+1) ((u (i + n)%N - u i.-1) / (M - u i.-1) * Q i K.+1) *: c i.
Proof.
move=> lt_K; have := FJ07_15_closed lt_K; move/(canRL (subrK _)) ->.
have nz := off lt_K; have nz0 := off (leq_ltn_trans (leq0n _) lt_K).
have -> : P 0 K.+1 = (M - u n) / (M - u 0%N) * P 1 K.+1 by rewrite /P big_ltn.
set S := \sum_(1 <= i < K.+1) _; move: S (P 1 K.+1) => S p.
by by_entries j; field; rewrite nz nz0.
Qed.

(** FJ07.C2 cylinder: for $\Lambda^{*}=M^{*}$ the net is a cylinder: $d_N-c_N=P(0,N)(d_0-c_0)$.
    Hypotheses: $M^{*}$ is none of $u_0,\dots,u_{N-1}$. *)
Theorem FJ07_C2_cylinder k : L = M -> (k <= N)%N -> d k - c k = P 0 k *: (d 0%N - c 0%N).
Proof. by move=> eq_LM le_k; rewrite FJ07_16_closed // eq_LM subrr scale0r addr0. Qed.

End ClosedForms.

Section Counterexamples.
Variable F : fieldType.

(** FJ07.13 needs_off: where $M^{*}=u_0$ there may be no row at all, or two with the same $d_0$: $n=1$, $u_i=i$, $M^{*}=0$. *)
Theorem FJ07_13_needs_off (u := fun i => i%:R : F) :
  (forall c d : nat -> 'rV[F]_1, c 0%N = 0 -> c 1%N = const_mx 1 -> d 0%N = 0 -> ~ cell u 1 1 0 c d 0) /\
  exists d d' : nat -> 'rV[F]_1, [/\ d 0%N = d' 0%N, d 1%N <> d' 1%N & forall L, cell u 1 L 0 (fun=> 0) d 0 /\ cell u 1 L 0 (fun=> 0) d' 0].
Proof.
have [u0 u1] : u 0%N = 0 /\ u (0 + 1)%N = 1 by [].
split=> [c d c0 c1 d0|].
  rewrite /cell u0 u1 c0 c1 d0 !scaler0 !subr0 scale1r scale0r !add0r => /rowP/(_ 0).
  by rewrite !mxE => /eqP; rewrite oner_eq0.
exists (fun=> 0), (fun i => if i is 1%N then const_mx 1 else 0); split=> // [/rowP/(_ 0)/eqP|L].
  by rewrite !mxE eq_sym oner_eq0.
by rewrite /cell u0 !subr0 !scale0r !scaler0.
Qed.

End Counterexamples.
