(* BZZ19, section 3: parametrization mappings, the developability conditions.
   Definitions:
     steps eps i      beta_i = eps_0^2 + ... + eps_i^2
     slope n u b i    (b_{i+1} - b_i) / (u_{i+n} - u_i): n times these are the coefficients of sigma'
     within n u t     t lies on the piece: u_i <= t for i < n, t <= u_j for n <= j < 2n
     after d sigma    the curve d(sigma(t)), coordinate by coordinate *)
From Torse Require Import Prelude Blossom Curves Points Dependence.
From mathcomp Require Import order ssrnum.
Import Order.TTheory Num.Theory.

Section Derivative.
Variable F : fieldType.
Implicit Types (u b : nat -> F) (n : nat).

Definition slope n u b i := (b i.+1 - b i) / (u (i + n)%N - u i).

Lemma velocity_slope n u b : velocity n.+1 u b = curve n (shift u) (slope n.+1 u b).
Proof.
rewrite /velocity /curve /= size_nseq; apply: blossom_ext => i _; rewrite /step /slope /polys /= !mul0r !sub0r subr0 mul1r mulN1r addrC.
by rewrite -!polyCB polyCV -polyCM.
Qed.

(** BZZ19.4 derivative: $\sigma'(t)=d\sum_i\frac{\beta_{i+1}-\beta_i}{t_{i+d}-t_i}B_{i,d-1}(t)$, over the same knots without the first.
    Hypotheses: the knots carry a piece, so that its points have a meaning.
    Paper: begins its sum of $\beta_i-\beta_{i-1}$ at $i=0$, where there is no $\beta_{-1}$. *)
Theorem BZZ19_4_derivative n u b : span n.+1 u -> (curve n.+1 u b)^`() = curve n (shift u) (slope n.+1 u b) *+ n.+1.
Proof. by move=> sp; rewrite blossoms_derivative // velocity_slope. Qed.
End Derivative.

Section Monotone.
Variable F : realFieldType.
Implicit Types (u b eps : nat -> F) (n i : nat) (s t : F).

Definition steps eps i : F := \sum_(0 <= j < i.+1) eps j ^+ 2.
Definition within n u t := (forall i, (i < n)%N -> u i <= t) /\ (forall j, (n <= j < n.*2)%N -> t <= u j).

(** BZZ19.5 steps: $\beta_i=\sum_{j\le i}\epsilon_j^2$ do not decrease and are not negative.
    Paper: also writes $\beta_{i+1}=\beta_i+\epsilon_i^2$, where (5) has $\epsilon_{i+1}^2$. *)
Theorem BZZ19_5_steps eps i : 0 <= steps eps i <= steps eps i.+1.
Proof.
rewrite /steps sumr_ge0 /= => [|j _]; last exact: sqr_ge0.
by rewrite [X in _ <= X]big_nat_recr //= ler_addl sqr_ge0.
Qed.

Lemma within_shift n u t : within n.+1 u t -> within n (shift u) t.
Proof. by case=> lo hi; split=> i h; [apply: lo; lia | apply: hi; lia]. Qed.

Lemma within_span n u s t : s < t -> within n u s -> within n u t -> span n u.
Proof.
move=> lt_st [lo _] [_ hi] i j lt_i /andP[le_j le_ij]; rewrite unitfE subr_eq0 gt_eqF //.
by apply: le_lt_trans (lo i lt_i) (lt_le_trans lt_st (hi j _)); lia.
Qed.

Lemma blossom_ge0 u b (v : seq F) : (forall t, t \in v -> within (size v) u t) ->
  (forall i, (i <= size v)%N -> 0 <= b i) -> 0 <= blossom u b [seq at_ t | t <- v].
Proof.
elim: v u b => [|t v ih] u b h b_ge0 /=; first exact: b_ge0.
apply: ih => [s sv | i le_i]; first by apply: within_shift; apply: h; rewrite inE sv orbT.
have [lo hi] := h t (mem_head _ _); rewrite /= in lo hi.
have le_lo : u i <= t by apply: lo; lia.
have le_hi : t <= u (i + (size v).+1)%N by apply: hi; lia.
rewrite /step size_map /at_ /= !mul1r mulr_ge0 ?addr_ge0 ?mulr_ge0 ?invr_ge0 ?b_ge0 ?subr_ge0 ?(leq_trans le_i) //=; try by lia.
exact: le_trans le_lo le_hi.
Qed.

Lemma direction_first n u b (v : seq (F * F)) : size v = n -> blossom u b (direction F :: v) = blossom (shift u) (slope n.+1 u b) v.
Proof.
by move=> sz /=; apply: blossom_ext => i _; rewrite sz /step /slope /= !mul0r !sub0r subr0 mul1r mulN1r addrC.
Qed.

Lemma slope_ge0 n u b i : (forall i, (i <= n)%N -> b i <= b i.+1) -> (i <= n)%N ->
  u i <= u (i + n.+1)%N -> 0 <= slope n.+1 u b i.
Proof. by move=> up le_i le_u; rewrite /slope mulr_ge0 ?invr_ge0 ?subr_ge0 ?up. Qed.

(** BZZ19.5 slope: coefficients that do not decrease give $\sigma'(t)\ge0$ on the piece.
    Hypotheses: the knots carry a piece, $t$ lies on it. *)
Theorem BZZ19_5_slope n u b t : span n.+1 u -> within n.+1 u t -> (forall i, (i <= n)%N -> b i <= b i.+1) ->
  0 <= ((curve n.+1 u b)^`()).[t].
Proof.
move=> sp inside up; rewrite BZZ19_4_derivative // hornerMn horner_curve; last exact: span_shift.
rewrite pmulrn_lge0 // -map_nseq; apply: blossom_ge0 => [s|i]; rewrite size_nseq.
  by rewrite mem_nseq => /andP[_ /eqP ->]; apply: within_shift.
move=> le_i; apply: slope_ge0 => //; case: inside => lo hi; apply: le_trans (lo i _) (hi _ _); lia.
Qed.

(* The blossom of k arguments t and l arguments s does not decrease where an s becomes a t. *)
Lemma mixed_le n u b s t k l : span n.+1 u -> within n.+1 u s -> within n.+1 u t -> s <= t ->
  (forall i, (i <= n)%N -> b i <= b i.+1) -> (k + l = n.+1)%N ->
  blossom u b (nseq k (at_ t) ++ nseq l (at_ s)) <= blossom u b (nseq n.+1 (at_ t)).
Proof.
move=> sp in_s in_t le_st up; have nseqS T i (x : T) w : nseq i.+1 x ++ w = nseq i x ++ x :: w by elim: i => //= i ->.
elim: l k => [|l ih] k sz; first by rewrite cats0 -sz addn0.
apply: le_trans (ih k.+1 _); last by rewrite addSnnS.
have -> : nseq k.+1 (at_ t) ++ nseq l (at_ s) = nseq k (at_ t) ++ comb 1 (at_ s) (t - s) (direction F) :: nseq l (at_ s).
  by rewrite nseqS; congr (_ ++ (_, _) :: _); rewrite /=; ring.
rewrite blossoms_multilinear mul1r ler_addl mulr_ge0 ?subr_ge0 //.
rewrite blossom_move ?size_nseq -?addnS ?sz // (@direction_first n) ?size_cat ?size_nseq; last by lia.
rewrite -!map_nseq -map_cat; apply: blossom_ge0 => [x|i]; rewrite size_cat !size_nseq (_ : (k + l = n)%N); try lia.
  by rewrite mem_cat !mem_nseq => /orP[] /andP[_ /eqP ->]; apply: within_shift.
by move=> le_i; apply: slope_ge0 => //; case: in_s => lo hi; apply: le_trans (lo i _) (hi _ _); lia.
Qed.

(** BZZ19.5 monotone: then $\sigma(s)\le\sigma(t)$ for $s\le t$ on the piece, over any ordered field.
    Hypotheses: $s$ and $t$ lie on the piece (for $s<t$ the knots then carry it).
    Paper: says that monotone coefficients make the surface free of self-intersections; they make $\sigma$ monotone, no more. *)
Theorem BZZ19_5_monotone n u b s t : within n.+1 u s -> within n.+1 u t -> s <= t ->
  (forall i, (i <= n)%N -> b i <= b i.+1) -> (curve n.+1 u b).[s] <= (curve n.+1 u b).[t].
Proof.
move=> in_s in_t; rewrite le_eqVlt => /orP[/eqP -> //|lt_st] up.
have sp := within_span lt_st in_s in_t; rewrite !horner_curve //.
exact: (@mixed_le _ _ _ _ _ 0 n.+1 sp in_s in_t (ltW lt_st) up).
Qed.
End Monotone.

Section Surface.
Variable F : fieldType.
Implicit Types (c d : 'rV[{poly F}]_3) (sigma : {poly F}).

Definition after d sigma : 'rV[{poly F}]_3 := map_mx (fun p => p \Po sigma) d.

Lemma pderiv_after d sigma : pderiv (after d sigma) = sigma^`() *: after (pderiv d) sigma.
Proof. by apply/rowP=> k; rewrite !mxE deriv_comp mulrC. Qed.

(** BZZ19.6 determinant: the determinant of the surface between $C_1$ and $C_2\circ\sigma$ is $\sigma'E_1$ with
    $E_1=[C_2'(\sigma),C_1',C_2(\sigma)-C_1]$. *)
Theorem BZZ19_6_determinant c d sigma :
  triple (pderiv (after d sigma)) (pderiv c) (after d sigma - c) =
  sigma^`() * triple (after (pderiv d) sigma) (pderiv c) (after d sigma - c).
Proof.
rewrite pderiv_after; move: (after (pderiv d) sigma) (pderiv c) (after d sigma - c) => x y z.
rewrite !tripleE [x_ (_ *: _)]mxE [y_ (_ *: _)]mxE [z_ (_ *: _)]mxE -/(x_ x) -/(y_ x) -/(z_ x).
by move: (x_ x) (y_ x) (z_ x) (x_ y) (y_ y) (z_ y) (x_ z) (y_ z) (z_ z) => *; ring.
Qed.

(** BZZ19.6 condition: the surface is developable iff $\sigma'=0$ or $E_1=0$.
    Paper: leaves out $\sigma'=0$: there $\sigma$ is constant in characteristic 0 and the rulings pass through one point. *)
Theorem BZZ19_6_condition c d sigma : developable c (after d sigma) <->
  sigma^`() = 0 \/ triple (after (pderiv d) sigma) (pderiv c) (after d sigma - c) = 0.
Proof.
rewrite /developable BZZ19_6_determinant; split=> [/eqP|[->|->]]; rewrite ?mul0r ?mulr0 //.
by rewrite mulf_eq0 => /orP[] /eqP ->; [left|right].
Qed.
End Surface.

Section Conditions.
Variable R : idomainType.
Implicit Types (N w a b : 'rV[R]_3).

(** BZZ19.7 common: $E_1=[w,a,b]=0$ iff there is a vector $N\ne0$ with $N\cdot a=N\cdot b=N\cdot w=0$. *)
Theorem BZZ19_7_common w a b :
  triple w a b = 0 <-> exists N, [/\ N != 0, dot N a = 0, dot N b = 0 & dot N w = 0].
Proof.
have mulT N (j : 'I_3) : (N *m (rows w a b)^T) 0 j = dot N (nth 0 [:: w; a; b] j).
  rewrite !mxE !big_ord_recl big_ord0 !mxE /= addr0 addrA /dot /x_ /y_ /z_.
  by congr (_ * _ + _ * _ + _ * _); congr (fun_of_matrix _ _ _); apply/val_inj.
rewrite triple_det -det_tr; split=> [/eqP/det0P[N nz /rowP e]|[N [nz ea eb ew]]].
  by exists N; have := (e 0, e 1, e 2%:R); rewrite !mulT !mxE /= => -[[ew ea] eb].
apply/eqP/det0P; exists N => //; apply/rowP=> -[j lt_j]; rewrite mulT mxE.
by case: j lt_j => [|[|[|]]].
Qed.
End Conditions.
