(* Programs: the functions of FJ21 at one parameter, and the rational net.
   Definitions (n degree, t the parameter; a factor is a + b t):
     nonzero x           x is not zero
     to_blossom_program n t lam mu nu, to_frame_program n t L M s   Corollary 4.1, both ways
     standard_program v w o        4.1, the parameter on the affine ruling
     gauge_program lam mu nu f g   4.3 for f(t) = f, f'(t) = g
     weights_program L M s x y     weights times x and y
     unelevated_program, elevated_program n t L M s a b a' b'   5.3 as printed and its inverse
     edge_program n t L M s        section 6: v, alpha, beta
     rational_program n u c L M s d   7.1 over the knots u, from the first row d *)
From Torse Require Import Prelude Points FJ07_3_net FJ21_4 FJ21_5 FJ21_6 Executable Executable_knots Executable_net.

Section Programs.
Variables (T Q : Type) (K : scalars T) (V : points T Q).
Implicit Types (n : nat) (t x y L M s a b : T).
Local Notation "1" := (one K).
Local Notation "x + y" := (sadd K x y).
Local Notation "x - y" := (ssub K x y).
Local Notation "x * y" := (smul K x y).
Local Notation "x / y" := (smul K x (sinv K y)).

Definition nonzero x := ~~ same K x (zero K).
Definition to_blossom_program n t lam mu nu := let N := of_nat K n in let e := lam - nu in
  given (nonzero e && nonzero lam) Division (Value [:: (N * (mu + 1) + e * t) / e; (lam * t + N * mu) / lam; lam / e]).
Definition to_frame_program n t L M s := let N := of_nat K n in let e := L - s * M + t * (s - 1) in
  given (nonzero e) Division (Value [:: N * s / e; s * (M - t) / e; N * (s - 1) / e]).
Definition standard_program x w o := let e := (1 - x) * w + x * o in given (nonzero e) Division (Value [:: x * o / e]).
Definition gauge_program lam mu nu x y := given (nonzero x) Division (Value [:: lam - mu * y / x; mu; nu + y / x]).
Definition weights_program L M s x y := given (nonzero y) Division (Value [:: L; M; x * s / y]).
Definition edge_program n t L M s := let N := of_nat K n in let e := L - t + s * (t - M) in
  given (nonzero e) Division (Value [:: s * (t - M) / e; N * s * (L - M) / (e * e); N * (s - 1) / e]).

Definition unelevated_program n t L M s a b a' b' := let N := of_nat K n in
  let f := fun x => a + b * x in let g := fun x => a' + b' * x in
  let h := N * f t + f L in let k := N * g t + g M in
  given (nonzero h && nonzero k) Division (Value [:: (N * f t * L + f L * t) / h; (N * g t * M + g M * t) / k; k / h * s]).
Definition elevated_program n t L M s a b a' b' := let N := of_nat K n in
  let f := fun x => a + b * x in let g := fun x => a' + b' * x in
  let h := N * f t + b * (t - L) in let k := N * g t + b' * (t - M) in
  let L' := (L * (N * f t + a) - a * t) / h in let M' := (M * (N * g t + a') - a' * t) / k in
  given (nonzero h && nonzero k && nonzero (N * g t + g M')) Division
    (Value [:: L'; M'; s * (N * f t + f L') / (N * g t + g M')]).

Definition rational_program n u c L M s d := knot_list K n u (fits n u c (given (nonzero s) Sigma (off_knots K u M
  (Value (net_row K V n u (map (pscale V (sinv K s)) c) L M 0 d))))).
End Programs.

Section Equal.
Variables (F : fieldType) (m : nat) (lt : F -> F -> bool).
Implicit Types (n : nat) (p q : 'rV[{poly F}]_m) (t x y L M s a b lam mu nu : F).
Local Notation K := (of_field lt).
Local Notation V := (rows F m).

(** FJ21.C4.1 program: the program takes $\lambda,\mu,\nu$ to $\Lambda,M,\sigma$ with $p[t^{\langle n-1\rangle},\Lambda]=\sigma q[t^{\langle n-1\rangle},M]$
    iff the frame of $p$, $q$ at $t$ has these $\lambda,\mu,\nu$, wherever it gives a value.
    Hypotheses: $n\ne0$ in the field. *)
Theorem FJ21_C4_1_program n p q t lam mu nu L M s : n%:R != 0 :> F -> to_blossom_program K n t lam mu nu = Value [:: L; M; s] ->
  frame p q t lam mu nu <-> related_at n p q t L M s.
Proof.
move=> n0; rewrite /to_blossom_program of_natE /nonzero /= /given; case: ifP => // /andP[l0 l1] [<- <- <-].
exact: FJ21_C4_1_relation.
Qed.

(** FJ21.C4.1 inverse: the program of the other direction takes $\Lambda,M,\sigma$ to the $\lambda,\mu,\nu$ of the frame, wherever it gives a value.
    Hypotheses: $n\ne0$ in the field. *)
Theorem FJ21_C4_1_inverse n p q t lam mu nu L M s : n%:R != 0 :> F -> to_frame_program K n t L M s = Value [:: lam; mu; nu] ->
  related_at n p q t L M s <-> frame p q t lam mu nu.
Proof.
move=> n0; rewrite /to_frame_program of_natE /nonzero /= /given; case: ifP => // e0 [<- <- <-].
exact: FJ21_C4_1_frame.
Qed.

(** FJ21.4.1 program: the program gives the $V$ for which $\frac{(1-v)wc+v\omega d}{(1-v)w+v\omega}=(1-V)c+Vd$, wherever it gives a value. *)
Theorem FJ21_4_1_program (c d : 'rV[F]_m) w o v x : standard_program K v w o = Value [:: x] ->
  ((1 - v) * w + v * o)^-1 *: ((1 - v) *: (w *: c) + v *: (o *: d)) = (1 - x) *: c + x *: d.
Proof.
rewrite /standard_program /nonzero /= /given; case: ifP => // e0 [<-]; exact: FJ21_4_1_parameter.
Qed.

(** FJ21.4.3 program: the program gives the frame of $fp$, $fq$ at $t$ from that of $p$, $q$, wherever it gives a value. *)
Theorem FJ21_4_3_program p q (f : {poly F}) t lam mu nu lam' mu' nu' :
  gauge_program K lam mu nu f.[t] f^`().[t] = Value [:: lam'; mu'; nu'] -> frame p q t lam mu nu ->
  frame (f *: p) (f *: q) t lam' mu' nu'.
Proof.
rewrite /gauge_program /nonzero /= /given; case: ifP => // e0 [<- <- <-]; exact: FJ21_4_3_gauge.
Qed.

(** FJ21.W program: the program gives the functions for weights times $x$ and $y$, wherever it gives a value. *)
Theorem FJ21_W_program n p q t L M s x y L' M' s' : weights_program K L M s x y = Value [:: L'; M'; s'] ->
  related_at n p q t L M s -> related_at n (x%:P *: p) (y%:P *: q) t L' M' s'.
Proof.
rewrite /weights_program /nonzero /= /given; case: ifP => // e0 [<- <- <-]; exact: FJ21_W_weights.
Qed.

(** FJ21.6 program: the program gives $v,\alpha,\beta$ with $(1-v)p'+vq'=\alpha(q-p)+\beta((1-v)p+vq)$, wherever it gives a value.
    Hypotheses: $n\ne0$ in the field. *)
Theorem FJ21_6_program n p q t L M s v x y : n%:R != 0 :> F -> edge_program K n t L M s = Value [:: v; x; y] ->
  related_at n p q t L M s ->
  (1 - v) *: ev (pderiv p) t + v *: ev (pderiv q) t = x *: ev (q - p) t + y *: ((1 - v) *: ev p t + v *: ev q t).
Proof.
move=> n0; rewrite /edge_program of_natE /nonzero /= /given; case: ifP => // e0 [<- <- <-]; rewrite -expr2; exact: FJ21_6_edge.
Qed.

(** FJ21.5.3 program: the program gives the functions of $p$, $q$ in degree $n$ from those of $fp$, $gq$ in degree $n+1$, wherever it gives a value.
    Hypotheses: $n$ and $n+1$ are not 0 in the field. *)
Theorem FJ21_5_3_program n p q t L M s a b a' b' L' M' s' : n%:R != 0 :> F -> n.+1%:R != 0 :> F ->
  unelevated_program K n t L M s a b a' b' = Value [:: L'; M'; s'] ->
  related_at n.+1 (linear a b *: p) (linear a' b' *: q) t L M s <-> related_at n p q t L' M' s'.
Proof.
move=> n0 n1; rewrite /unelevated_program of_natE /nonzero /= /given; case: ifP => // /andP[h0 k0] [<- <- <-].
rewrite -!FJ21_5.linearE in h0 k0; have := FJ21_5_3_elevation p q s n0 n1 h0 k0; by rewrite !FJ21_5.linearE.
Qed.

(** FJ21.5.3 inverse: the program of the inverse gives functions of $fp$, $gq$ in degree $n+1$ where $p$, $q$ have the given ones, and conversely, wherever it gives
    a value. Where $n$ or $n+1$ is 0 in the field, or $g(t)=0$, it gives none.
    Hypotheses: for the converse: $f(t)\ne0$. *)
Theorem FJ21_5_3_inverse n p q t L M s a b a' b' L' M' s' (low := related_at n p q t L M s)
    (high := related_at n.+1 (linear a b *: p) (linear a' b' *: q) t L' M' s') :
  elevated_program K n t L M s a b a' b' = Value [:: L'; M'; s'] -> (low -> high) /\ (a + b * t != 0 -> high -> low).
Proof.
rewrite /elevated_program of_natE /nonzero /= /given; case: ifP => // /andP[/andP[h0 k0] g0] [eL eM es].
have H : n%:R * (a + b * t) + (a + b * L') = n%:R * n.+1%:R * (a + b * t) ^+ 2 / (n%:R * (a + b * t) + b * (t - L)).
  by rewrite -eL natrS; move: (n%:R) h0 => N h0; field.
have G : n%:R * (a' + b' * t) + (a' + b' * M') = n%:R * n.+1%:R * (a' + b' * t) ^+ 2 / (n%:R * (a' + b' * t) + b' * (t - M)).
  by rewrite -eM natrS; move: (n%:R) k0 => N k0; field.
have [n0 n1] : n%:R != 0 :> F /\ n.+1%:R != 0 :> F.
  by move: g0; rewrite eM G !mulf_eq0 !negb_or => /andP[/andP[/andP[-> ->]]].
have [f0|f0] := eqVneq (a + b * t) 0.
  split=> // _; have Lt : L' = t.
    by rewrite -eL; apply: (mulIf h0); rewrite divfK //; apply: (by_multiple (z := (n%:R + 1) * (L - t)) f0); ring.
  have s0 : s' = 0 by rewrite -es eL Lt f0 mulr0 addr0 mulr0 mul0r.
  by apply/rowP=> k; rewrite !mxE hornerM FJ21_5.linearE f0 Lt s0 subrr !mul0r addr0.
suff all : low <-> high by split=> [/all|_ /all].
have H0 : n%:R * (a + b * t) + (a + b * L') != 0 by rewrite H mulf_neq0 ?invr_eq0 // !mulf_neq0 // expf_neq0.
rewrite eM in g0 es; rewrite eL in es; rewrite -!FJ21_5.linearE in H0 g0; have := FJ21_5_3_elevation p q s' n0 n1 H0 g0; rewrite !FJ21_5.linearE.
rewrite !FJ21_5.linearE in H0 g0.
have -> : (n%:R * (a + b * t) * L' + (a + b * L') * t) / (n%:R * (a + b * t) + (a + b * L')) = L.
  apply: (mulIf H0); rewrite divfK // -eL; move: (n%:R) h0 => N h0; field; exact: h0.
have -> : (n%:R * (a' + b' * t) * M' + (a' + b' * M') * t) / (n%:R * (a' + b' * t) + (a' + b' * M')) = M.
  apply: (mulIf g0); rewrite divfK // -eM; move: (n%:R) k0 => N k0; field; exact: k0.
have -> : (n%:R * (a' + b' * t) + (a' + b' * M')) / (n%:R * (a + b * t) + (a + b * L')) * s' = s.
  by rewrite -es mulrCA -!mulrA; move: H0 g0; move: (_ + (a + _)) (_ + (a' + _)) => x y x0 y0; field; rewrite x0 y0.
by rewrite /high => h; split=> /h.
Qed.

(** FJ21.7.1 program: the program gives a row $q$ through the first row $d$ with
    $(u_{i+n}-\Lambda^{*})p_i+(\Lambda^{*}-u_i)p_{i+1}=\sigma((u_{i+n}-M^{*})q_i+(M^{*}-u_i)q_{i+1})$, $i=0..L-1$, wherever it gives a row. *)
Theorem FJ21_7_1_program n (u : seq F) (c : seq 'rV[F]_m) L M s (d : 'rV[F]_m) (r : seq 'rV[F]_m) :
  rational_program K V n u c L M s d = Value r ->
  [/\ size r = (size u - n).+1, nth 0 r 0 = d & forall i, (i < size u - n)%N ->
    (nth 0 u (i + n) - L) *: nth 0 c i + (L - nth 0 u i) *: nth 0 c i.+1
      = s *: ((nth 0 u (i + n) - M) *: nth 0 r i + (M - nth 0 u i) *: nth 0 r i.+1)].
Proof.
rewrite /rational_program => /knot_listP[hv /fitsP[hs]] e; have [s0 {}e] := given_Value e; rewrite /nonzero /= in s0.
have eq_r : net_program K V n u (map (pscale V (sinv K s)) c) L M 0 d = Value r.
  by rewrite /net_program knot_listP fitsP size_map; do 2!split=> //; rewrite -e /off_knots nat_lebE.
have [off sr r0 cells] := FJ07_13_program eq_r; split=> // i lt_i; have := cells i lt_i; rewrite /cell !(nth_map 0) ?hs ?ltnS //; last exact: ltnW.
move=> <- /=; move: (nth 0 c i) (nth 0 c i.+1) (nth 0 u _) (nth 0 u i) => c0 c1 x y.
by by_entries k; field.
Qed.
End Equal.
