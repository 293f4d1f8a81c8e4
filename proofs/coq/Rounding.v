(* Rounding errors of the construction of a net, ruling by ruling, in any arithmetic that keeps the standard model.
   Definitions:
     close eps x y     y is x with a relative error of at most eps;  rounded eps x y   relative to x or to y
     gamma eps k       k eps / (1 - k eps), the relative error of k operations
     factor eps k t    t lies between (1 - eps)^k and its inverse, as does a product of k numbers from 1 - eps to 1 / (1 - eps)
     arithmetic T      four operations on T, which may round;  exactly F   those of a field
     next_ruling, ruling, vertex   the recursion FJ07.13.rulings in one coordinate, operation by operation as the library computes it, from
                       the vertex d beside p_0 past p_1, p_2, ..., where near_j and far_j are the knots of step j
     kept A val ...    the model holds for each operation of the first N steps, or else 0 / x = 0; val being the value of a T
     perturbed x j     a step of the recursion with rounding factors;  across a b i N   the product of a_j / b_j for i <= j < N
     spread ...        the bound of the error of a ruling: the terms of FJ07.16, each in absolute value and times its gamma *)
From Torse Require Import Prelude.
From mathcomp Require Import order ssrnum.
Import Order.TTheory Num.Theory.

Record arithmetic (T : Type) := Arithmetic {plus : T -> T -> T; minus : T -> T -> T; times : T -> T -> T; over : T -> T -> T}.
Definition exactly (F : fieldType) : arithmetic F := Arithmetic +%R (fun x y => x - y) *%R (fun x y => x / y).

Section Program.
Variables (T : Type) (A : arithmetic T) (L M : T) (near far p : nat -> T) (d : T).
Local Notation "x [+] y" := (plus A x y) (at level 50, left associativity).
Local Notation "x [-] y" := (minus A x y) (at level 50, left associativity).
Local Notation "x [*] y" := (times A x y) (at level 40, left associativity).
Local Notation "x [/] y" := (over A x y) (at level 40, left associativity).

Definition next_ruling r j := ((p j.+1 [-] p j) [*] (L [-] M) [+] (M [-] near j) [*] r) [/] (M [-] far j).
Fixpoint ruling N := if N is j.+1 then next_ruling (ruling j) j else d [-] p 0%N.
Definition vertex N := if N is 0%N then d else p N [+] ruling N.
End Program.

Section Model.
Variable F : realFieldType.
Implicit Types (eps x y s t : F) (k : nat).

Definition close eps x y := `|y - x| <= eps * `|x|.
Definition rounded eps x y := close eps x y \/ close eps y x.
Definition gamma eps k := k%:R * eps / (1 - k%:R * eps).
Definition factor eps k t := (1 - eps) ^+ k <= t <= ((1 - eps) ^+ k)^-1.

Section Factors.
Variable eps : F.
Hypothesis range : 0 <= eps < 1.
Let eps_ge0 : 0 <= eps. Proof. by case/andP: range. Qed.
Let base_gt0 : 0 < 1 - eps. Proof. by rewrite subr_gt0; case/andP: range. Qed.
Let power_gt0 k : 0 < (1 - eps) ^+ k. Proof. exact: exprn_gt0. Qed.

Lemma factor_gt0 k t : factor eps k t -> 0 < t.
Proof. by case/andP=> lo _; exact: lt_le_trans (power_gt0 k) lo. Qed.
Lemma factor_mul j k s t : factor eps j s -> factor eps k t -> factor eps (j + k) (s * t).
Proof.
move=> hs ht; have [s0 t0] := (ltW (factor_gt0 hs), ltW (factor_gt0 ht)).
case/andP: hs => ls us; case/andP: ht => lt ut; rewrite /factor exprD invfM.
by rewrite !ler_pmul // ltW ?power_gt0.
Qed.

Lemma factor_inv k t : factor eps k t -> factor eps k t^-1.
Proof.
move=> ht; have t0 := factor_gt0 ht; case/andP: ht => lo up; apply/andP; split.
  by rewrite -[X in X <= _]invrK lef_pinv // posrE // invr_gt0.
by rewrite lef_pinv // posrE.
Qed.

Lemma factor1 : factor eps 1 1.
Proof. by rewrite /factor expr1 ler_subl_addr ler_addl eps_ge0 /= invf_ge1 // ler_subl_addr ler_addl. Qed.

Lemma rounded_factor x y : rounded eps x y -> exists2 t, factor eps 1 t & y = x * t.
Proof.
have [->|x0] := eqVneq x 0.
  rewrite /rounded /close normr0 mulr0 sub0r normrN subr0 => h; exists 1; rewrite ?mul0r; first exact: factor1.
  apply/eqP; rewrite -normr_le0; case: h => // h; rewrite leNgt; apply/negP=> y0.
  by move: h; rewrite leNgt -[X in _ < X]mul1r ltr_pmul2r // -subr_gt0 base_gt0.
move=> h; exists (y / x); last by rewrite mulrC divfK.
have {h}: `|y / x - 1| <= eps \/ `|y / x - 1| <= eps * `|y / x|.
  have e : y / x - 1 = (y - x) / x by rewrite mulrBl divff.
  have nx : 0 < `|x| by rewrite normr_gt0.
  rewrite e !normf_div; case: h => h; [left|right]; first by rewrite ler_pdivr_mulr.
  by rewrite mulrA ler_pdivr_mulr // divfK ?gt_eqF // distrC.
move: (y / x) => t; rewrite /factor expr1; have inv_ge : 1 + eps <= (1 - eps)^-1.
  by rewrite -[X in _ <= X]mul1r ler_pdivl_mulr // mulrC -subr_sqr expr1n ler_subl_addr ler_addl sqr_ge0.
case; first by rewrite ler_distl => /andP[-> up]; apply: le_trans up inv_ge.
have [t0|t0] := leP t 0.
  have t1 : 0 <= 1 - t by rewrite subr_ge0 (le_trans t0) ?ler01.
  rewrite distrC (ger0_norm t1) (ler0_norm t0) => h; exfalso.
  have : 1 - t <= - t by apply: le_trans h _; rewrite ler_pimull ?oppr_ge0 // ltW // -subr_gt0.
  by rewrite -subr_ge0 opprB addrA addNr sub0r oppr_ge0 leNgt ltr01.
rewrite (gtr0_norm t0) ler_distl => /andP[lo up]; apply/andP; split.
  have h : 1 <= t * (1 + eps) by rewrite mulrDr mulr1 mulrC -ler_subl_addr.
  have h' : (1 - eps) * (1 + eps) <= 1 by rewrite -subr_sqr expr1n ler_subl_addr ler_addl sqr_ge0.
  have e0 : 0 < 1 + eps by apply: lt_le_trans ltr01 _; rewrite ler_addl.
  by rewrite -(ler_pmul2r e0); apply: le_trans h' h.
by rewrite -[X in _ <= X]mul1r ler_pdivl_mulr // mulrBr mulr1 ler_subl_addr [t * eps]mulrC.
Qed.

(** rounding factors: a product of $k$ factors from $1-\varepsilon$ to $1/(1-\varepsilon)$ is $1+\theta$ with $|\theta|\le\gamma_k=\frac{k\varepsilon}{1-k\varepsilon}$.
    Hypotheses: $0\le\varepsilon<1$ and $k\varepsilon<1$. *)
Theorem rounding_factors k t : k%:R * eps < 1 -> factor eps k t -> `|t - 1| <= gamma eps k.
Proof.
move=> small /andP[lo up]; have gap : 0 < 1 - k%:R * eps by rewrite subr_gt0.
have bernoulli : 1 - k%:R * eps <= (1 - eps) ^+ k.
  elim: k {lo up small gap} => [|k ih]; first by rewrite mul0r subr0 expr0.
  have ge0 : 0 <= k%:R * eps ^+ 2 by rewrite mulr_ge0 ?ler0n ?sqr_ge0.
  rewrite exprSr; apply: le_trans (ler_wpmul2r (ltW base_gt0) ih).
  have -> : 1 - k.+1%:R * eps = (1 - k%:R * eps) * (1 - eps) - k%:R * eps ^+ 2.
    by rewrite -addn1 natrD; move: k%:R => z; ring.
  by rewrite ler_subl_addr ler_addl.
have eg : gamma eps k = (1 - k%:R * eps)^-1 - 1.
  by rewrite /gamma; move: (k%:R * eps) gap => z /lt0r_neq0 nz; field.
have g0 : 0 <= k%:R * eps by rewrite mulr_ge0 ?ler0n.
rewrite ler_distl; apply/andP; split; last first.
  by rewrite eg addrC subrK; apply: le_trans up _; rewrite lef_pinv ?posrE.
apply: le_trans (le_trans bernoulli lo); rewrite ler_add2l ler_opp2 /gamma ler_pdivl_mulr //.
by rewrite mulrBr mulr1 ler_subl_addr ler_addl mulr_ge0.
Qed.
End Factors.

Section Steps.
Variables (T : Type) (A : arithmetic T) (val : T -> F) (eps : F).
Variables (L M : T) (near far p : nat -> T) (d : T).

Definition kept N := [/\ close eps (val d - val (p 0%N)) (val (minus A d (p 0%N))), close eps (val L - val M) (val (minus A L M)) &
  forall j, (j < N)%N -> let side := minus A (p j.+1) (p j) in let r := ruling A L M near far p d j in
    let moved := times A side (minus A L M) in let passed := times A (minus A M (near j)) r in
    let sum := plus A moved passed in let divisor := minus A M (far j) in let quotient := ruling A L M near far p d j.+1 in
    [/\ close eps (val (p j.+1) - val (p j)) (val side), close eps (val M - val (near j)) (val (minus A M (near j))),
      rounded eps (val side * val (minus A L M)) (val moved), rounded eps (val (minus A M (near j)) * val r) (val passed) &
      close eps (val moved + val passed) (val sum) /\
      (close eps (val M - val (far j)) (val divisor) /\ rounded eps (val sum / val divisor) (val quotient) \/ val sum = 0 /\ val quotient = 0)]].

Hypothesis range : 0 <= eps < 1.

(** rounding cell: one step of the recursion $r_{j+1}=\frac{(\Lambda^{*}-M^{*})(p_{j+1}-p_j)+(M^{*}-\mathit{near}_j)r_j}{M^{*}-\mathit{far}_j}$ computes
    $\hat r_{j+1}=\frac{(\Lambda^{*}-M^{*})(p_{j+1}-p_j)s+(M^{*}-\mathit{near}_j)\hat r_jt}{M^{*}-\mathit{far}_j}$, $s$ with six rounding factors, $t$ with five.
    Hypotheses: the operations keep the standard model; $M^{*}\ne\mathit{far}_j$. *)
Theorem rounding_cell N j : kept N -> (j < N)%N -> val M - val (far j) != 0 -> exists s t, [/\ factor eps 6 s, factor eps 5 t &
  val (ruling A L M near far p d j.+1) = ((val L - val M) * (val (p j.+1) - val (p j)) * s
    + (val M - val (near j)) * val (ruling A L M near far p d j) * t) / (val M - val (far j))].
Proof.
case=> _ hg steps lt_j nz; have [hs hn hm hp [ha hq]] := steps j lt_j.
have [g fg eg] := rounded_factor range (or_introl hg); have [s fs es] := rounded_factor range (or_introl hs).
have [a fa ea] := rounded_factor range (or_introl hn); have [w fw ew] := rounded_factor range (or_introl ha).
have [x fx ex] := rounded_factor range hm; have [y fy ey] := rounded_factor range hp.
set sum := plus A _ _ in ew hq; set quotient := ruling _ _ _ _ _ _ _ _.
have [z fz eq] : exists2 z, factor eps 2 z & val quotient = val sum / (val M - val (far j)) * z.
  case: hq => [[hf hr]|[-> ->]]; last by exists (1 * 1); rewrite ?mul0r //; exact: (factor_mul range (factor1 range) (factor1 range)).
  have [b fb eb] := rounded_factor range (or_introl hf); have [q fq eq] := rounded_factor range hr.
  exists (b^-1 * q); first exact: (factor_mul range (factor_inv range fb) fq).
  by rewrite eq eb invfM !mulrA.
exists (s * g * x * w * z), (a * y * w * z); split.
- exact: (factor_mul range (factor_mul range (factor_mul range (factor_mul range fs fg) fx) fw) fz).
- exact: (factor_mul range (factor_mul range (factor_mul range fa fy) fw) fz).
by rewrite eq ew ex ey es eg ea; move: (val _) (val _ - val _) nz => r v nz; field.
Qed.
End Steps.

Section Unrolled.
Variables (eps gap : F) (a b side : nat -> F).
Hypothesis range : 0 <= eps < 1.

Definition across i N := \prod_(i <= j < N) (a j / b j).
Definition perturbed (x : nat -> F) j := exists s t, [/\ factor eps 6 s, factor eps 5 t &
  x j.+1 = (gap * side j * s + a j * x j * t) / b j].

Lemma unroll (x : nat -> F) x0 N : (exists2 t, factor eps 1 t & x 0%N = x0 * t) -> (forall j, (j < N)%N -> perturbed x j) ->
  exists t0 (t : nat -> F), [/\ factor eps (5 * N + 1) t0, forall i, (i < N)%N -> factor eps (5 * (N - i) + 1) (t i) &
    x N = across 0 N * x0 * t0 + gap * \sum_(0 <= i < N) across i.+1 N * side i / b i * t i].
Proof.
move=> start; elim: N => [|N ih] steps.
  have [t ft ex] := start; exists t, (fun=> 1); split=> //.
  by rewrite ex /across !big_geq // mulr0 addr0 mul1r.
have [t0 [t [f0 ft ex]]] := ih (fun j lt_j => steps j (ltnW lt_j)).
have [s [w [fs fw ew]]] := steps N (leqnn _).
exists (t0 * w), (fun i => if i == N then s else t i * w); split.
- by rewrite mulnS [(5 + _)%N]addnC addnAC; exact: factor_mul.
- move=> i; rewrite ltnS leq_eqVlt; case: eqVneq => [-> _|_ /= lt_i]; first by rewrite subSnn.
  by rewrite subSn ?(ltnW lt_i) // mulnS [(5 + _)%N]addnC addnAC; apply: factor_mul => //; exact: ft.
have recr i : (i <= N)%N -> across i N.+1 = across i N * (a N / b N) by move=> le_i; rewrite /across big_nat_recr.
have last : across N.+1 N.+1 = 1 by rewrite /across big_geq.
rewrite ew ex big_nat_recr //= eqxx recr // last mul1r.
rewrite [in RHS](eq_big_nat _ _ (F2 := fun i => (across i.+1 N * side i / b i * t i) * (a N / b N * w))); last first.
  by move=> i /andP[_ lt_i]; rewrite ltn_eqF // recr //; ring.
rewrite -mulr_suml; move: (\sum_(_ <= _ < _) _) (across 0 N) (b N)^-1 => S P0 v; ring.
Qed.
End Unrolled.

Section Bound.
Variables (T : Type) (A : arithmetic T) (val : T -> F) (eps : F).
Variables (L M : T) (near far p : nat -> T) (d : T) (N : nat).
Local Notation gap := (val L - val M).
Local Notation a := (fun j => val M - val (near j)).
Local Notation b := (fun j => val M - val (far j)).
Local Notation side := (fun j => val (p j.+1) - val (p j)).
Local Notation P := (across a b).
Local Notation computed := (ruling A L M near far p d N).
Definition spread := gamma eps (5 * N + 1) * `|P 0%N N| * `|val d - val (p 0%N)|
  + `|gap| * \sum_(0 <= i < N) gamma eps (5 * (N - i) + 1) * `|P i.+1 N| * `|side i| / `|b i|.

Hypothesis eps_ge0 : 0 <= eps.
Hypothesis off : forall j, (j < N)%N -> b j != 0.
Hypothesis model : kept A val eps L M near far p d N.

(** rounding mixed: the computed ruling is the exact one for a first ruling and edges with relative errors:
    $\hat r_N=P(0,N)(d_0-p_0)t_0+(\Lambda^{*}-M^{*})\sum_{i=0}^{N-1}P(i+1,N)\frac{(p_{i+1}-p_i)t_i}{M^{*}-\mathit{far}_i}$, where the first
    $t_0$ has $5N+1$ rounding factors and $t_i$ under the sum $5(N-i)+1$; $P(a,b)=\prod_{i=a}^{b-1}\frac{M^{*}-\mathit{near}_i}{M^{*}-\mathit{far}_i}$.
    Hypotheses: the operations keep the standard model; $0\le\varepsilon<1$; $M^{*}\ne\mathit{far}_i$ for $i<N$. *)
Theorem rounding_mixed : eps < 1 -> exists t0 (t : nat -> F), [/\ factor eps (5 * N + 1) t0,
  forall i, (i < N)%N -> factor eps (5 * (N - i) + 1) (t i) & val computed =
  P 0%N N * (val d - val (p 0%N)) * t0 + gap * \sum_(0 <= i < N) P i.+1 N * side i / b i * t i].
Proof.
move=> eps_lt1; have range : 0 <= eps < 1 by rewrite eps_ge0.
apply: (unroll (x := fun j => val (ruling A L M near far p d j)) range); last by move=> j lt_j; apply: (rounding_cell range model); rewrite ?off.
by case: model => h _ _; exact: (rounded_factor range (or_introl h)).
Qed.

(** rounding ruling: $|\hat r_N-r_N|\le\gamma_{5N+1}|P(0,N)||d_0-p_0|
    +|\Lambda^{*}-M^{*}|\sum_{i=0}^{N-1}\gamma_{5(N-i)+1}|P(i+1,N)|\frac{|p_{i+1}-p_i|}{|M^{*}-\mathit{far}_i|}$, where
    $r_0=d_0-p_0$, $(M^{*}-\mathit{far}_i)r_{i+1}=(M^{*}-\mathit{near}_i)r_i+(\Lambda^{*}-M^{*})(p_{i+1}-p_i)$.
    Hypotheses: the operations keep the standard model; $(5N+1)\varepsilon<1$; $M^{*}\ne\mathit{far}_i$ for $i<N$. *)
Theorem rounding_ruling (r : nat -> F) : (5 * N + 1)%:R * eps < 1 -> r 0%N = val d - val (p 0%N) ->
  (forall j, (j < N)%N -> b j * r j.+1 = a j * r j + gap * side j) -> `|val computed - r N| <= spread.
Proof.
move=> small r0 rec; have small_k k : (k <= 5 * N + 1)%N -> k%:R * eps < 1.
  by move=> le_k; apply: le_lt_trans small; rewrite ler_wpmul2r // ler_nat.
have eps_lt1 : eps < 1 by rewrite -[eps]mul1r (small_k 1%N) // addn1.
have range : 0 <= eps < 1 by rewrite eps_ge0.
have [t0 [t [f0 ft ->]]] := rounding_mixed eps_lt1.
have one k s : factor (0 : F) k s -> s = 1 by rewrite /factor subr0 expr1n invr1 => /le_anti.
have one' k : factor (0 : F) k 1 by rewrite /factor subr0 expr1n invr1 lexx.
have range0 : 0 <= (0 : F) < 1 by rewrite lexx ltr01.
have [||s0 [s [/one -> fs ->]]] := unroll (eps := 0) (gap := gap) (a := a) (b := b) (side := side) (x := r) (x0 := r 0%N) (N := N) range0.
- by exists 1; rewrite ?mulr1.
- move=> j lt_j; exists 1, 1; split=> //; apply: (mulfI (off lt_j)).
  by rewrite (rec j lt_j) !mulr1 mulrCA mulfV ?off // mulr1 addrC.
rewrite r0; set x0 := _ - val (p _).
rewrite [X in _ - (_ + _ * X)](eq_big_nat _ _ (F2 := fun i => P i.+1 N * side i / b i)); last first.
  by move=> i /andP[_ /fs/one ->]; rewrite mulr1.
have -> x y : P 0%N N * x0 * t0 + gap * x - (P 0%N N * x0 * 1 + gap * y) = (t0 - 1) * P 0%N N * x0 + gap * (x - y) by ring.
apply: le_trans (ler_norm_add _ _) _; rewrite /spread !normrM -sumrB; apply: ler_add.
  have := rounding_factors range small f0; move: (gamma _ _) => g h.
  by rewrite -!mulrA ler_wpmul2r ?mulr_ge0.
apply: ler_wpmul2l => //; apply: le_trans (ler_norm_sum _ _ _) _; rewrite !big_mkord; apply: ler_sum => i _.
have -> : P i.+1 N * side i / b i * t i - P i.+1 N * side i / b i = (t i - 1) * (P i.+1 N * side i / b i) by ring.
have := rounding_factors range (small_k _ _) (ft i (ltn_ord i)); rewrite leq_add2r leq_mul2l leq_subr.
move: (gamma _ _) => g /(_ isT) h.
by rewrite !normrM normfV -!mulrA ler_wpmul2r ?mulr_ge0 ?invr_ge0.
Qed.
End Bound.
End Model.
