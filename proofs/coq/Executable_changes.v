(* Programs: Lam, M, sigma from a dependence, and what changes of the curves do to them, FJ21.3.3, 5.1, 5.2, 5.4.
   Definitions (n degree, t the parameter; a factor is a + b t):
     dependence_program l0 l1 m0 m1   3.3
     moebius_program b x           5.1, t(u) for u = x
     moebius_rows b c              the rows b^(n-i) c_i of 5.2
     moebius_functions_program L M s b   5.2
     unshortened_program, shortened_program n t L M s a b a' b'   5.4 as printed and its inverse *)
From Torse Require Import Prelude Blossom Curves Points FJ07_3_blossoms FJ21_3_theorem FJ21_4 FJ21_5 FJ21_5_changes Executable Executable_FJ21.

Section Programs.
Variables (T Q : Type) (K : scalars T) (V : points T Q).
Implicit Types (n : nat) (c : seq Q) (t x L M s a b : T).
Local Notation "1" := (one K).
Local Notation "x + y" := (sadd K x y).
Local Notation "x - y" := (ssub K x y).
Local Notation "x * y" := (smul K x y).
Local Notation "x / y" := (smul K x (sinv K y)).
Local Notation nonzero := (nonzero K).

Definition dependence_program l0 l1 m0 m1 :=
  given (nonzero (l0 + l1)) Lambda (given (nonzero (m0 + m1)) At_knot (Value [:: l1 / (l0 + l1); m1 / (m0 + m1); (m0 + m1) / (l0 + l1)])).
Definition moebius_program b x := let e := (1 - b) * x + b in given (nonzero e) Division (Value [:: x / e]).
Definition moebius_rows b c := mkseq (fun i => pscale V (iter ((size c).-1 - i) (smul K b) 1) (nth (origin V) c i)) (size c).
Definition moebius_functions_program L M s b := let e := 1 + (b - 1) * L in let h := 1 + (b - 1) * M in
  given (nonzero e && nonzero h) Division (Value [:: b * L / e; b * M / h; s * h / e]).

Definition unshortened_program n t L M s a b a' b' := let N := of_nat K n in
  let f := fun x => a + b * x in let g := fun x => a' + b' * x in
  let h := N * g t + g M in let e := f L + N * f t + s * (g M - f M + N * (g t - f t)) in
  given (nonzero h && nonzero e) Division
    (Value [:: (f L * t + N * f t * L + s * (N * M * (g t - f t) + t * (g M - f M))) / e; (g M * t + N * g t * M) / h; s * h / e]).
Definition shortened_program n t L M s a b a' b' := let N := of_nat K n in
  let f := a + b * t in let g := a' + b' * t in let l := L - t in let m := M - t in
  let h := N * g - b' * m in let e := g * g * (N * f - b * l) + s * (f * f * h - g * g * (N * f - b * m)) in
  given (nonzero h && nonzero e) Division
    (Value [:: t + (N + 1) * f * g * (g * l + s * m * (f - g)) / e; t + (N + 1) * g * m / h; s * f * f * h / e]).
End Programs.

Section Equal.
Variables (F : fieldType) (m : nat) (lt : F -> F -> bool).
Implicit Types (n : nat) (c d : seq 'rV[F]_m) (p q : 'rV[{poly F}]_m) (t x L M s a b : F).
Local Notation K := (of_field lt).
Local Notation V := (rows F m).
Local Notation at_list := (nth 0).

(** FJ21.3.3 program: the program takes $\lambda_0p_0+\lambda_1p_1=\mu_0q_0+\mu_1q_1$ to $(1-\Lambda)p_0+\Lambda p_1=\sigma((1-M)q_0+Mq_1)$, and conversely,
    wherever it gives a value. *)
Theorem FJ21_3_3_program (p0 p1 q0 q1 : 'rV[F]_m) l0 l1 m0 m1 L M s : dependence_program K l0 l1 m0 m1 = Value [:: L; M; s] ->
  l0 *: p0 + l1 *: p1 = m0 *: q0 + m1 *: q1 <-> (1 - L) *: p0 + L *: p1 = s *: ((1 - M) *: q0 + M *: q1).
Proof.
rewrite /dependence_program /nonzero /= /given; case: ifP => // l; case: ifP => // m' [<- <- <-]; exact: FJ21_3_3_dependence.
Qed.

(** FJ21.3.3 fails: the program gives the error of $\Lambda$ iff $\lambda_0+\lambda_1=0$, and that of $M$ iff only $\mu_0+\mu_1=0$. *)
Theorem FJ21_3_3_fails l0 l1 m0 m1 (r := dependence_program K l0 l1 m0 m1) :
  (r = Fails _ Lambda <-> l0 + l1 = 0) /\ (r = Fails _ At_knot <-> l0 + l1 != 0 /\ m0 + m1 = 0).
Proof.
rewrite /r /dependence_program /nonzero /= /given; case: eqVneq => [->|l]; case: eqVneq => [->|m'] /=; split; split=> //.
- by case.
- by case.
- by move=> e; rewrite e eqxx in l.
- by move=> e; rewrite e eqxx in l.
by case=> _ e; rewrite e eqxx in m'.
Qed.

Lemma iter_mul b x k : iter k (smul K b) x = b ^+ k * x.
Proof. by elim: k => [|k ih]; rewrite ?mul1r //= ih exprS mulrA. Qed.

Lemma moebius_rowsE b c i : at_list (moebius_rows K V b c) i = moebius (size c).-1 b (at_list c) i.
Proof.
have [lt_i|ge_i] := ltnP i (size c); first by rewrite nth_mkseq // iter_mul /moebius mulr1.
by rewrite /moebius !nth_default ?size_mkseq // scaler0.
Qed.

(* In any degree they are those of the curve of that degree but for a factor. *)
Lemma moebius_rows_degree n b c i : b != 0 -> (i <= n)%N -> at_list (moebius_rows K V b c) i = (b ^+ (size c).-1 / b ^+ n) *: moebius n b (at_list c) i.
Proof.
move=> b0 le_i; rewrite moebius_rowsE /moebius scalerA; have [lt_i|ge_i] := ltnP i (size c); last by rewrite nth_default // !scaler0.
congr (_ *: _); rewrite !exprB ?unitfE //; last by lia.
by move: (expf_neq0 i b0) (expf_neq0 n b0); move: (b ^+ i) (b ^+ n) (b ^+ _) => x y z x0 y0; field; rewrite x0 y0.
Qed.

Lemma pblossom_scale (u : nat -> F) (c : nat -> 'rV[F]_m) x v : pblossom u (fun i => x *: c i) v = x *: pblossom u c v.
Proof.
apply/rowP=> k; rewrite !mxE -[RHS]addr0 -[X in _ + X](mul0r (blossom u (coord c k) v)) -blossom_linear.
by apply: blossom_ext => i _; rewrite /coord mxE mul0r addr0.
Qed.

Lemma pblossom_ext (u : nat -> F) (c d : nat -> 'rV[F]_m) v : (forall i, (i <= size v)%N -> c i = d i) -> pblossom u c v = pblossom u d v.
Proof. by move=> e; apply/rowP=> k; rewrite !mxE; apply: blossom_ext => i /e; rewrite /coord => ->. Qed.

(** FJ21.5.1 program: the rows of the program are those of $\tilde p(u)=((1-b)u+b)^n\,p(t(u))$, and its $t(u)$ is the parameter, wherever it gives one. *)
Theorem FJ21_5_1_program b c x y (n := (size c).-1) : moebius_program K b x = Value [:: y] ->
  pblossom (step01 F n) (at_list (moebius_rows K V b c)) (nseq n (at_ x))
    = ((1 - b) * x + b) ^+ n *: pblossom (step01 F n) (at_list c) (nseq n (at_ y)).
Proof.
rewrite /moebius_program /nonzero /= /given; case: ifP => // e0 [<-]; rewrite -FJ21_5_1_curve //.
by apply: pblossom_ext => i _; rewrite moebius_rowsE.
Qed.

(** FJ21.5.2 program: with the functions of the program at $u$ the rows of the program are related,
    $\tilde p[u^{\langle n-1\rangle},\tilde\Lambda]=\tilde\sigma\tilde q[u^{\langle n-1\rangle},\tilde M]$, iff $p[t^{\langle n-1\rangle},\Lambda]=\sigma q[t^{\langle n-1\rangle},M]$ at
    $t=t(u)$, wherever both programs give values.
    Hypotheses: $b\ne0$; as many rows of the one as of the other. *)
Theorem FJ21_5_2_program n b c d x y L M s L' M' s' : b != 0 -> size c = size d ->
  moebius_program K b x = Value [:: y] -> moebius_functions_program K L M s b = Value [:: L'; M'; s'] ->
  pblossom (step01 F n.+1) (at_list (moebius_rows K V b c)) (at_ L' :: nseq n (at_ x))
    = s' *: pblossom (step01 F n.+1) (at_list (moebius_rows K V b d)) (at_ M' :: nseq n (at_ x)) <->
  pblossom (step01 F n.+1) (at_list c) (at_ L :: nseq n (at_ y)) = s *: pblossom (step01 F n.+1) (at_list d) (at_ M :: nseq n (at_ y)).
Proof.
move=> b0 sz; rewrite /moebius_program /moebius_functions_program /nonzero /= /given; case: ifP => // x0 [<-].
case: ifP => // /andP[l0 m0] [<- <- <-]; have := @FJ21_5_2_functions F m n b (at_list c) (at_list d) x L M s b0 x0 l0 m0.
have e (r : seq 'rV[F]_m) z : pblossom (step01 F n.+1) (at_list (moebius_rows K V b r)) (at_ z :: nseq n (at_ x))
    = (b ^+ (size r).-1 / b ^+ n.+1) *: pblossom (step01 F n.+1) (moebius n.+1 b (at_list r)) (at_ z :: nseq n (at_ x)).
  by rewrite -pblossom_scale; apply: pblossom_ext => i; rewrite /= size_nseq => le_i; exact: moebius_rows_degree.
have k0 : b ^+ (size d).-1 / b ^+ n.+1 != 0 by rewrite mulf_neq0 ?invr_eq0 ?expf_neq0.
by rewrite !e sz => <-; rewrite scalerA [_ * (b ^+ _ / _)]mulrC -[X in _ = X <-> _]scalerA; split=> [/(scalerI k0)|->].
Qed.

(** FJ21.5.4 program: the program gives the functions of $p$, $q$ in degree $n$ from those of $fp$, $fp+g(q-p)$ in degree $n+1$, wherever it gives a value.
    Hypotheses: $n$ and $n+1$ are not 0 in the field. *)
Theorem FJ21_5_4_program n p q t L M s a b a' b' L' M' s' (f := linear a b) (g := linear a' b') : n%:R != 0 :> F -> n.+1%:R != 0 :> F ->
  unshortened_program K n t L M s a b a' b' = Value [:: L'; M'; s'] ->
  related_at n.+1 (f *: p) (f *: p + g *: (q - p)) t L M s <-> related_at n p q t L' M' s'.
Proof.
move=> n0 n1; rewrite /unshortened_program of_natE /nonzero /= /given; case: ifP => // /andP[h0 k0] [<- <- <-].
by have := @FJ21_5_4_rulings F m n p q t L M s a b a' b' n0 n1; rewrite !FJ21_5.linearE => /(_ h0 k0).
Qed.

(** FJ21.5.4 inverse: the program of the inverse gives functions of $fp$, $fp+g(q-p)$ in degree $n+1$ where $p$, $q$ have the given ones, and conversely, wherever
    it gives a value.
    Hypotheses: $n$ and $n+1$ are not 0 in the field; for the converse: $f(t)\ne0$, $g(t)\ne0$. *)
Theorem FJ21_5_4_inverse n p q t L M s a b a' b' L' M' s' (f := linear a b) (g := linear a' b') (low := related_at n p q t L M s)
    (high := related_at n.+1 (f *: p) (f *: p + g *: (q - p)) t L' M' s') : n%:R != 0 :> F -> n.+1%:R != 0 :> F ->
  shortened_program K n t L M s a b a' b' = Value [:: L'; M'; s'] ->
  (low -> high) /\ (a + b * t != 0 -> a' + b' * t != 0 -> high -> low).
Proof.
move=> n0 n1; rewrite /shortened_program of_natE /nonzero /= /given; case: ifP => // /andP[h0 e0] [eL eM es].
set N := n%:R in n0 h0 e0 eL eM es *; set h := N * _ - b' * _ in h0 e0 eL eM es; set e := _ + s * _ in e0 eL es.
have n1' : N + 1 != 0 by rewrite /N -natrS.
have [f0|f0] := eqVneq (a + b * t) 0.
  split=> // _; have Lt : L' = t by rewrite -eL f0 mulr0 !mul0r addr0.
  have s0 : s' = 0 by rewrite -es f0 mulr0 !mul0r.
  by apply/rowP=> k; rewrite /high /f !mxE hornerM FJ21_5.linearE f0 Lt s0 subrr !mul0r addr0.
have [g0|g0] := eqVneq (a' + b' * t) 0.
  split=> // _; have Lt : L' = t by rewrite -eL g0 mulr0 !mul0r addr0.
  have Mt : M' = t by rewrite -eM g0 mulr0 !mul0r addr0.
  have s1 : s' = 1 by rewrite -es -[RHS](divff e0) /e g0 !mul0r subr0 add0r !mulrA.
  by apply/rowP=> k; rewrite /high /f /g !mxE hornerD !hornerM !FJ21_5.linearE g0 Lt Mt s1 subrr !mul0r !addr0 mul1r.
suff all : low <-> high by split=> [/all|_ _ /all].
have H : N * (a' + b' * t) + (a' + b' * M') = (N + 1) * N * (a' + b' * t) ^+ 2 / h.
  by rewrite -eM; move: h0; rewrite /h => h0; field.
have E : (a + b * L') + N * (a + b * t) + s' * (a' + b' * M' - (a + b * M') + N * (a' + b' * t - (a + b * t)))
    = (N + 1) * N * (a + b * t) ^+ 2 * (a' + b' * t) ^+ 2 / e.
  by rewrite -eL -eM -es; move: h0 e0; rewrite /e /h => h0 e0; field; rewrite h0 e0.
have H0 : N * (a' + b' * t) + (a' + b' * M') != 0 by rewrite H !mulf_neq0 ?invr_eq0 // expf_neq0.
have E0 : (a + b * L') + N * (a + b * t) + s' * (a' + b' * M' - (a + b * M') + N * (a' + b' * t - (a + b * t))) != 0.
  by rewrite E !mulf_neq0 ?invr_eq0 // expf_neq0.
have := @FJ21_5_4_rulings F m n p q t L' M' s' a b a' b' n0 n1; rewrite !FJ21_5.linearE -/N => /(_ H0 E0).
have -> : s' * (N * (a' + b' * t) + (a' + b' * M')) / ((a + b * L') + N * (a + b * t) + s' * (a' + b' * M' - (a + b * M') + N * (a' + b' * t - (a + b * t)))) = s.
  by rewrite H E -es; field; rewrite n0 n1' f0 g0 h0 e0.
have -> : ((a' + b' * M') * t + N * (a' + b' * t) * M') / (N * (a' + b' * t) + (a' + b' * M')) = M.
  apply: (mulIf H0); rewrite divfK // -eM; move: h0; rewrite /h => h0; field; exact: h0.
set X := (_ + s' * (_ + t * _)) / _; suff -> : X = L by move=> i; split=> /i.
apply: (mulIf E0); rewrite /X divfK // -eL -eM -es; move: h0 e0; rewrite /e /h => h0 e0; field; rewrite h0 e0 //.
Qed.
End Equal.
