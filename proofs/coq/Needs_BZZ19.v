(* BZZ19: what happens without the hypotheses of the theorems, and what an increasing mapping does not give.
   Definitions:
     loop_x, loop_y      the plane cubic ((t-1)(t-3), (t-1)(t-2)(t-3)), which passes through 0 at t = 1 and t = 3
     loop h              the curve (loop_x, loop_y, t + h) of space *)
From Torse Require Import Prelude Blossom Curves Points Bernstein Bezier BZZ19_3 BZZ19_4 BZZ19_4_pieces FJ21_4.
From mathcomp Require Import order ssrnum.
From Torse Require Import Needs_blossoms Needs_FJ07_curves.
Import Order.TTheory Num.Theory.

Section Field.
Variable F : fieldType.
Implicit Types (c d u b : nat -> F) (n k i : nat) (p : {poly F}).

(** BZZ19.4 needs_span: over the knots $0,1,0,0$ of degree 2, where $u_2=u_0$, the coefficients $\sigma_1=1$, $\sigma_2=0$ give the slope 1 at $t=0$ and the rule gives 2, whatever
    stands for $\frac10$. *)
Theorem BZZ19_4_needs_span (k : F) b (u := bent F) : b 1%N = 1 -> b 2%N = 0 ->
  (curve_with k 2 u b)^`() <> curve_with k 1 (shift u) (fun i => divided k (b i.+1 - b i) (u (i + 2)%N - u i)) *+ 2.
Proof.
move=> b1 b2; rewrite /u bent_curve b1 b2 /curve_with /= /step_with /polys /shift /bent /listed /= polyC0 polyC1 (dividedN1 _ _ (sub0r 1)) b1 b2.
rewrite (dividedN1 _ (0 - 1) (sub0r 1)) !sub0r opprK polyC1 !mul0r addr0.
move/(congr1 (fun p => p.[0])); rewrite mulr2n !(derivM, derivB, derivD, derivX, derivC) !(hornerM, hornerD, hornerN, hornerC, hornerX) => /eqP.
by rewrite -subr_eq0 (_ : _ - _ = -1) ?oppr_eq0 ?oner_eq0 //; ring.
Qed.

(* The coefficient of X^k (1-X)^(n-k) in X^k is 1. *)
Lemma lowest n k (g : nat -> F) : (k <= n)%N -> \sum_(0 <= i < n.+1) (g i)%:P * ('X^i * (1 - 'X) ^+ (n - i)) = 'X^k -> g k = 1.
Proof.
elim: k n g => [|k ih] [|n] // g le_k.
- by rewrite big_nat1 !expr0 !mulr1 => /polyC_inj.
- rewrite big_nat_recl // !expr0 mul1r => /(congr1 (fun p => p.[0])); rewrite hornerD horner_sum big1 ?addr0 => [|i _].
    by rewrite !hornerE horner_exp !hornerE subr0 expr1n mulr1.
  by rewrite !hornerM hornerXn exprS !mul0r mulr0.
rewrite big_nat_recl // expr0 mul1r subn0 => e; have eX : \sum_(0 <= i < n.+1) (g i.+1)%:P * ('X^i.+1 * (1 - 'X) ^+ (n.+1 - i.+1))
    = 'X * \sum_(0 <= i < n.+1) (g i.+1)%:P * ('X^i * (1 - 'X) ^+ (n - i)).
  by rewrite mulr_sumr; apply: eq_big_nat => i _; rewrite subSS exprS; ring.
have g0 : g 0%N = 0.
  have := congr1 (fun p : {poly F} => p.[0]) e.
  have Y0 : (1 - 'X : {poly F}).[0] = 1 by rewrite !hornerE subr0.
  by rewrite eX hornerD !hornerM hornerC horner_exp Y0 expr1n mulr1 hornerX mul0r addr0 hornerXn [X in _ = X -> _]exprS mul0r.
move: e; rewrite g0 polyC0 mul0r add0r eX exprS => /mulfI e.
by apply: (ih n (fun i => g i.+1)) => //; apply: e; rewrite polyX_eq0.
Qed.

(** BZZ19.14 needs_binomial: where $C(D,k)=0$ in the field $t^k$ is no combination of the Bernstein polynomials of degree $D$. *)
Theorem BZZ19_14_needs_binomial n k c : (k <= n)%N -> 'C(n, k)%:R = 0 :> F -> 'X^k <> bez n c.
Proof.
move=> le_k e; rewrite /bez => /esym eq_k.
have := @lowest n k (fun i => c i * 'C(n, i)%:R) le_k; rewrite e mulr0 => one; have /eqP := oner_neq0 F; apply; apply/esym/one.
by rewrite -eq_k; apply: eq_big_nat => i _; rewrite /B polyCM polyC_nat -mulrA.
Qed.

(** BZZ19.14 needs_degree: a polynomial of degree greater than $D$ is not one: $t^{D+1}$. *)
Theorem BZZ19_14_needs_degree n c : 'X^n.+1 <> bez n c.
Proof. by move/(congr1 (fun p : {poly F} => size p)) => e; have := size_bez n c; rewrite -e size_polyXn ltnn. Qed.

(** BZZ19.13 needs_binomials: in characteristic 2, $C_2=T^2$ and $\sigma=t$ are of degree 3 and $C_2(\sigma)$ is no Bezier curve of degree 9. *)
Theorem BZZ19_13_needs_binomials : 2%:R = 0 :> F ->
  exists c s, forall e, bez 3 c \Po bez 3 s <> bez (3 * 3) e.
Proof.
move=> two; have bins k : (k <= 3)%N -> 'C(3, k)%:R != 0 :> F.
  have three : 3%:R = 1 :> F by rewrite (natrD _ 1 2) two addr0.
  by case: k => [|[|[|[|//]]]] _; rewrite -?[binomial _ _]/3%N ?three ?bin0 ?binn ?oner_eq0.
exists (fun i => 'C(i, 2)%:R / 'C(3, 2)%:R), (fun i => 'C(i, 1)%:R / 'C(3, 1)%:R) => e.
rewrite -!BZZ19_14_power ?bins // expr1 comp_polyXr; apply: BZZ19_14_needs_binomial => //.
by rewrite -[binomial _ _]/(2 * 18)%N natrM two mul0r.
Qed.

Lemma falling : curve 1 (step01 F 1) (listed [:: 1; 0]) = 1 - 'X.
Proof. by rewrite bezier_curve /bez /B big_nat_recr //= big_nat1 polyC0 polyC1 mul0r addr0 bin0 expr0 subn0 expr1 !mul1r. Qed.

Lemma square : curve 2 (step01 F 2) (listed [:: 0; 0; 1]) = 'X^2.
Proof.
by rewrite bezier_curve /bez /B big_nat_recr // big_nat_recr //= big_nat1 polyC0 polyC1 !mul0r !add0r binn subnn expr0 !mul1r mulr1.
Qed.

(** BZZ19.5 needs_order: falling coefficients: $1,0$ on $[0,1]$ give $\sigma=1-t$, of slope $-1$. *)
Theorem BZZ19_5_needs_order (sigma := curve 1 (step01 F 1) (listed [:: 1; 0])) :
  [/\ sigma^`().[0] = -1, sigma.[0] = 1 & sigma.[1] = 0].
Proof.
by rewrite /sigma falling derivB derivC derivX sub0r; split; rewrite ?hornerN ?hornerD ?hornerN ?hornerC ?hornerX ?subr0 ?subrr //.
Qed.

(** BZZ19.5 needs_within: off the piece: $0,0,1$ on $[0,1]$ give $\sigma=t^2$, of slope $-2$ at $-1$, and $\sigma(-1)=1$, $\sigma(0)=0$. *)
Theorem BZZ19_5_needs_within (sigma := curve 2 (step01 F 2) (listed [:: 0; 0; 1])) :
  [/\ sigma^`().[-1] = - 2%:R, sigma.[-1] = 1 & sigma.[0] = 0].
Proof.
rewrite /sigma square derivXn hornerMn !hornerXn expr1 sqrrN expr1n expr0n mulNrn; by split.
Qed.

(** BZZ19.5 slope_needs_span: over the knots $1,0,1,1$ of degree 2, where $u_2=u_0$, the coefficients $-1,-1,-1$, which do not fall, would give $\sigma=-t$, whatever stands
    for $\frac10$. *)
Theorem BZZ19_5_slope_needs_span (k : F) : curve_with k 2 (listed [:: 1; 0; 1; 1]) (fun=> -1 : F) = - 'X.
Proof.
rewrite /curve_with /= /step_with /shift /polys /listed /= polyC0 polyC1 polyCN polyC1 (divided0 _ _ (subrr 1)) !(divided1 _ _ (subr0 1)).
by move: 'X => X; ring.
Qed.

Definition loop_x : {poly F} := ('X - 1) * ('X - 3%:R%:P).
Definition loop_y : {poly F} := loop_x * ('X - 2%:R%:P).
Definition loop h : 'rV[{poly F}]_3 := vec loop_x loop_y ('X + h%:P).

Lemma loop_developable : developable (loop 0) (loop 4%:R).
Proof.
have -> : developable (loop 0) (loop 4%:R) = (triple (pderiv (loop 4%:R)) (pderiv (loop 0)) (vec 0 0 4%:R%:P) = 0).
  rewrite /developable /loop; congr (triple _ _ _ = 0); apply/rowP=> -[[|[|[|//]]] ?]; rewrite !mxE /= ?subrr //.
  by rewrite polyC0 addr0 addrC addKr.
by rewrite /loop !pderiv_vec tripleE !vec_xyz !derivD !derivC !derivX; ring.
Qed.

Lemma loop_meets s : ruled_surface (loop 0) (loop 4%:R) 'X s 1 = vec 0 0 (1 + 4%:R * s) /\
  ruled_surface (loop 0) (loop 4%:R) 'X s 3%:R = vec 0 0 (3%:R + 4%:R * s).
Proof.
have at_t t h : loop_x.[t] = 0 -> ev (loop h) t = vec 0 0 (t + h).
  by move=> x0; rewrite /loop ev_vec x0 /loop_y hornerM x0 mul0r hornerD hornerX hornerC.
have id_ h : after (loop h) 'X = loop h by apply/rowP=> k; rewrite !mxE comp_polyXr.
have [x1 x3] : loop_x.[1] = 0 /\ loop_x.[3%:R] = 0 by rewrite /loop_x; split; rewrite !hornerE ?subrr ?mul0r ?mulr0.
rewrite /ruled_surface !id_ !at_t //.
by split; apply/rowP=> -[[|[|[|//]]] ?]; rewrite !mxE /=; ring.
Qed.
End Field.

Section Order.
Variable F : realFieldType.

(** BZZ19.5 crossing: an increasing mapping does not keep the surface from going through itself. With $\sigma(t)=t$ on $[0,4]$, the linear
    spline of the coefficients $0,2^2$, take $C_1=((t-1)(t-3),(t-1)(t-2)(t-3),t)$ and $C_2=C_1+(0,0,4)$: a cylinder, exactly developable, over
    rails that are regular and simple ($z=t$), and $S(\frac34,1)=S(\frac14,3)$.
    Paper: guarantees that there are no self-intersections. *)
Theorem BZZ19_5_crossing (C1 := loop (0 : F)) (C2 := loop (4%:R : F))
    (sigma := curve 1 (listed [:: 0; 4%:R]) (steps (listed [:: 0; 2%:R] : nat -> F))) :
  [/\ sigma = 'X, developable C1 (after C2 sigma), (forall t, z_ (ev (pderiv C1) t) = 1) &
      ruled_surface C1 C2 sigma (3%:R / 4%:R) 1 = ruled_surface C1 C2 sigma (1 / 4%:R) 3%:R].
Proof.
have n4 : 4%:R != 0 :> F by rewrite pnatr_eq0.
have -> : sigma = 'X.
  rewrite /sigma /curve /= /step /polys /listed /steps big_nat1 big_nat_recr ?big_nat1 //= expr0n add0r polyC0 !mul1r !subr0 mulr0 add0r.
  by rewrite -natrX mulrK // poly_unitE size_polyC coefC /= unitfE (_ : (2 ^ 2)%:R = 4%:R) ?n4.
have id_ (h : F) : after (loop h) 'X = loop h by apply/rowP=> k; rewrite !mxE comp_polyXr.
rewrite /C1 /C2 id_; split=> //; first exact: loop_developable.
  by move=> t; rewrite /loop pderiv_vec ev_vec vec_xyz derivD derivX derivC addr0 hornerC.
rewrite (loop_meets _).1 (loop_meets _).2; congr (vec _ _ _); by field.
Qed.
End Order.
