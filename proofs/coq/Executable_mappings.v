(* Programs: mappings and their values, BZZ19, section 3.2; over an ordered field, the interval that holds a parameter.
   Definitions (n degree, u knots, c points, t the parameter):
     piece_at n u t                 the piece k = 1, 2, ... that holds t, the one to the right at a knot, the last one at the end
     inside n u t                   t lies in the domain
     mapping_value_program n u c t, mapping_slope_program n u c t   c(t) and c'(t) on that piece
     greville_program n u           the coefficients (u_i + ... + u_{i+n-1}) / n
     ordered F                      the operations of an ordered field, with its order *)
From Torse Require Import Prelude Blossom Curves Points Bernstein FJ21_4 BZZ19_3_range Executable Executable_knots Executable_splines.
From mathcomp Require Import order ssrnum.
Import Order.TTheory Num.Theory.

Section Programs.
Variables (T Q : Type) (K : scalars T) (V : points T Q).
Implicit Types (u : seq T) (c : seq Q) (n : nat) (t : T).
Local Notation "u $ i" := (nth (zero K) u i) (at level 8, i at level 8, format "u $ i").

Definition piece_at n u t := (interval K n u t + 2 - n)%N.
Definition inside n u t := ~~ less K t u$(n.-1) && ~~ less K u$(last_ n u) t.
Definition mapping_value_program n u c t :=
  knot_list K n u (fits n u c (given (inside n u t) Outside (point_program K V n u c (piece_at n u t) t))).
Definition mapping_slope_program n u c t :=
  knot_list K n u (fits n u c (given (inside n u t) Outside (derivative_program K V n u c (piece_at n u t) t))).
Definition greville_program n u := knot_list K n u (Value (mkseq (fun i =>
  smul K (total K (fun j => u$j) i (i + n)) (sinv K (of_nat K n))) (last_ n u).+1)).
End Programs.

Lemma last_filter (a : pred nat) b k (s := filter a (iota b k)) x : x \in s -> last 0%N s \in s /\ (x <= last 0%N s)%N.
Proof.
rewrite /s {s}; elim: k => // k ih; rewrite -addn1 iotaD filter_cat /= last_cat mem_cat.
case: (boolP (a (b + k)%N)) => [ak|_] /=; last by rewrite cats0 orbF; exact: ih.
rewrite !mem_cat !inE eqxx orbT; case/orP=> [|/eqP -> //]; rewrite mem_filter mem_iota => /andP[_ /andP[_ /ltnW lt_x]]; by split.
Qed.

Section Ordered.
Variables (F : realFieldType) (m : nat).
Implicit Types (u : seq F) (c : seq 'rV[F]_m) (n k i j : nat) (t : F).
Definition ordered := of_field (fun x y : F => x < y).
Local Notation V := (rows F m).
Local Notation at_list := (nth 0).
Local Notation valid := (valid (fun x y : F => x < y)).

Lemma bounds_of n u : valid n u -> [/\ (0 < n)%N, (n + n <= size u)%N & at_list u n.-1 != at_list u (size u - n)%N].
Proof. by case. Qed.

Lemma knots_up n u i j : valid n u -> (i <= j < size u)%N -> at_list u i <= at_list u j.
Proof.
case=> _ _ up _ _ /andP[]; elim: j => [|j ih]; first by rewrite leqn0 => /eqP ->.
rewrite leq_eqVlt => /orP[/eqP -> //|le_i] lt_j; apply: le_trans (ih le_i (ltnW lt_j)) _.
by rewrite leNgt; apply: up.
Qed.

(** blossoms carried: where a list of knots is accepted every piece that is not empty is carried by its knots: no denominator of de Boor's algorithm
    vanishes.
    Hypotheses: an ordered field. *)
Theorem blossoms_carried n u j : valid n u -> (n.-1 <= j < size u - n)%N -> at_list u j != at_list u j.+1 ->
  span n (drop_ (j.+1 - n) (at_list u)).
Proof.
move=> hv; have [n0 le_n _] := bounds_of hv => /andP[le_j lt_j] ne i l lt_i /andP[le_l le_li].
rewrite unitfE subr_eq0 gt_eqF // /drop_; apply: le_lt_trans (knots_up hv (j := j) _) _; first by lia.
apply: lt_le_trans (knots_up hv (i := j.+1) _); last by lia.
by rewrite lt_neqAle ne (knots_up hv) //; lia.
Qed.

Lemma no_step n u t a : valid n u -> (n.-1 <= a <= size u - n)%N -> at_list u a <= t ->
  (forall i, (a <= i < size u - n)%N -> at_list u i <= t -> ~~ (at_list u i < at_list u i.+1)) -> at_list u (size u - n)%N <= at_list u a.
Proof.
move=> hv /andP[_ le_a] le_t none; suff go k : (a + k <= size u - n)%N -> at_list u (a + k)%N <= at_list u a.
  by have := go (size u - n - a)%N; rewrite subnKC // => ->.
elim: k => [|k ih] le_k; first by rewrite addn0.
have le_ak : at_list u (a + k)%N <= at_list u a by apply: ih; lia.
by rewrite addnS; apply: le_trans (le_ak); rewrite leNgt; apply: none; [lia | apply: le_trans le_ak le_t].
Qed.

(** blossoms interval: the program for knot insertion and for mappings finds $j$ with $n-1\le j<L$ and $u_j\le t\le u_{j+1}$, $u_j<u_{j+1}$; $t<u_{j+1}$ but at
    the end of the domain.
    Hypotheses: an ordered field; the list of knots is accepted; $u_{n-1}\le t\le u_L$. *)
Theorem blossoms_interval n u t (j := interval ordered n u t) : valid n u -> at_list u n.-1 <= t <= at_list u (size u - n)%N ->
  [/\ (n.-1 <= j < size u - n)%N, at_list u j <= t <= at_list u j.+1, at_list u j < at_list u j.+1 &
    t < at_list u j.+1 \/ t = at_list u (size u - n)%N].
Proof.
move=> hv /andP[lo hi]; have [n0 le_n dom] := bounds_of hv.
have mem i : (i \in filter (fun i => ~~ (t < at_list u i) && (at_list u i < at_list u i.+1)) (iota n.-1 (size u - n - n.-1)))
    = [&& at_list u i <= t, at_list u i < at_list u i.+1 & (n.-1 <= i < size u - n)%N].
  rewrite mem_filter mem_iota -leNgt -andbA; congr (_ && (_ && _)). by rewrite subnKC //; lia.
have step a : (n.-1 <= a <= size u - n)%N -> at_list u a <= t -> at_list u a < at_list u (size u - n)%N ->
    exists2 i, (a <= i)%N & i \in filter (fun i => ~~ (t < at_list u i) && (at_list u i < at_list u i.+1)) (iota n.-1 (size u - n - n.-1)).
  move=> in_a le_t lt_a; case: (boolP (has (fun i => (a <= i)%N && (at_list u i <= t) && (at_list u i < at_list u i.+1)) (iota a (size u - n - a)))).
    case/hasP=> i; rewrite mem_iota => in_i /andP[/andP[le_a le_i] lt_i]; exists i => //; rewrite mem le_i lt_i /=; move: in_a in_i; clear; lia.
  move/hasPn=> none; suff : at_list u (size u - n)%N <= at_list u a by rewrite leNgt lt_a.
  apply: (no_step hv in_a le_t) => i in_i le_i; have := none i; rewrite mem_iota le_i andbT; case/andP: in_i => -> lt_i /=; apply; move: in_a lt_i; clear; lia.
have [i _ in_i] : exists2 i, (n.-1 <= i)%N & i \in filter (fun i => ~~ (t < at_list u i) && (at_list u i < at_list u i.+1)) (iota n.-1 (size u - n - n.-1)).
  by apply: step => //; [move: le_n; clear; lia | rewrite lt_neqAle dom (knots_up hv) //; move: n0 le_n; clear; lia].
have [in_j _] := last_filter in_i.
have [le_j lt_j bounds] : [/\ at_list u j <= t, at_list u j < at_list u j.+1 & (n.-1 <= j < size u - n)%N] by apply/and3P; rewrite -mem.
rewrite bounds le_j lt_j /=.
have [lt_t|ge_t] := ltP t (at_list u j.+1); first by split=> //; [exact: ltW | left].
have e : at_list u j.+1 = at_list u (size u - n)%N.
  apply/eqP; rewrite eq_le (knots_up hv) /=; last by move: bounds n0; clear; lia.
  rewrite leNgt; apply/negP=> lt_e; have [|h le_h in_h] := step j.+1 _ ge_t lt_e; first by move: bounds; clear; lia.
  have [_ le_j'] := last_filter in_h; have {}le_j' : (h <= j)%N := le_j'; by rewrite ltnNge le_j' in le_h.
have et : t = at_list u j.+1 by apply/eqP; rewrite eq_le ge_t e hi.
by split=> //; [rewrite et | right; rewrite et].
Qed.

Lemma insideE n u t : inside ordered n u t = (at_list u n.-1 <= t <= at_list u (size u - n)%N).
Proof. by rewrite /inside /= -!leNgt. Qed.

Lemma piece_atE n u t (j := interval ordered n u t) : valid n u -> at_list u n.-1 <= t <= at_list u (size u - n)%N ->
  piece_at ordered n u t = (j.+1 - n).+1 /\ span n (drop_ (j.+1 - n) (at_list u)).
Proof.
move=> hv in_t; have [b _ lt_j _] := blossoms_interval hv in_t; have [n0 le_n _] := bounds_of hv; split; last by apply: blossoms_carried; rewrite ?lt_eqF.
by rewrite /piece_at -/j; lia.
Qed.

(** BZZ19.3 value: the program gives $\sigma(t)$, the value of the piece that holds $t$, iff the list of knots is accepted, there are as many
    coefficients as it asks for and $t$ lies in the domain.
    Hypotheses: an ordered field. *)
Theorem BZZ19_3_value n u c t p (k := ((interval ordered n u t).+1 - n)%N) : mapping_value_program ordered V n u c t = Value p <->
  [/\ valid n u, size c = (size u - n).+1, at_list u n.-1 <= t <= at_list u (size u - n)%N &
    p = ev (pcurve n (drop_ k (at_list u)) (drop_ k (at_list c))) t].
Proof.
rewrite /mapping_value_program knot_listP fitsP insideE /given; split=> [[hv [sc]]|[hv sc in_t ->]].
  case: ifP => // in_t; have [-> sp] := piece_atE hv in_t => e; split=> //; exact: blossoms_value e.
split=> //; split=> //; rewrite in_t; have [-> sp] := piece_atE hv in_t.
rewrite /point_program; apply/blossoms_program; split=> //; apply/rowP=> i; rewrite !mxE horner_curve //.
Qed.

(** BZZ19.4 value: the program gives $\sigma'(t)$ of that piece, wherever it gives a value.
    Hypotheses: an ordered field. *)
Theorem BZZ19_4_value n u c t p (k := ((interval ordered n u t).+1 - n)%N) : mapping_slope_program ordered V n u c t = Value p ->
  p = ev (pderiv (pcurve n (drop_ k (at_list u)) (drop_ k (at_list c)))) t.
Proof.
case/knot_listP=> hv /fitsP[sc]; rewrite insideE /given; case: ifP => // in_t; have [-> _] := piece_atE hv in_t; exact: blossoms_slope.
Qed.

(** blossoms inserted: where the program of knot insertion gives the lists $u'$ and $c'$, each vertex that it changes is
    $c'_{i+1}=c[u'_{i+1},\dots,u'_{i+n}]$ on the piece that holds $t$.
    Hypotheses: an ordered field. *)
Theorem blossoms_inserted n u c t v r i (j := interval ordered n u t) (k := (j.+1 - n)%N) :
  insertion_program ordered V n u c t = Value (v, r) -> (k <= i <= j)%N ->
  nth 0 r i.+1 = pblossom (drop_ k (at_list u)) (drop_ k (at_list c)) (knots (at_list v) i.+1 n).
Proof.
rewrite /k /j {k j}; case/knot_listP=> hv /fitsP[sc]; rewrite -/(inside ordered n u t) insideE /given; case: ifP => // in_t.
case/knot_listP=> _ e; have [<- <-] := Value_inj e; have [b _ _ _] := blossoms_interval hv in_t; have [_ sp] := piece_atE hv in_t.
have [n0 le_n _] := bounds_of hv; move: {e} (interval ordered n u t) b sp => j /andP[le_nj lt_j] sp /andP[le_k le_j].
have sz : (j < size u)%N by lia.
rewrite nth_mkseq; last by rewrite /last_; lia.
by apply: blossoms_insertion => //; lia.
Qed.
End Ordered.

(** BZZ19.3 coefficients: with the coefficients of the program $\sigma(t)=t$ on every piece that the knots carry, wherever it gives them.
    Hypotheses: $n\ne0$ in the field. *)
Theorem BZZ19_3_coefficients (F : fieldType) (lt : F -> F -> bool) n (u r : seq F) k : n%:R != 0 :> F -> (k <= size u - n - n)%N ->
  span n (drop_ k (nth 0 u)) -> greville_program (of_field lt) n u = Value r -> curve n (drop_ k (nth 0 u)) (drop_ k (nth 0 r)) = 'X.
Proof.
move=> n0 le_k sp /knot_listP[[pos le_n _ _ _] e]; rewrite -(Value_inj e) /last_; set v := drop_ k (nth 0 u); set b := drop_ k _.
have scaled_b : curve n v (fun i => n%:R * b i) = n%:R%:P * curve n v b.
  rewrite /curve -[RHS]addr0 -[X in _ + X](mul0r (curve n v b)) -blossom_linear; apply: blossom_ext => i _.
  by rewrite /polys polyCM mul0r addr0.
apply: (@mulfI _ n%:R%:P); first by rewrite polyC_eq0.
rewrite -scaled_b polyC_nat -(BZZ19_3_identity sp); apply: blossom_ext => i; rewrite size_nseq => le_i; congr _%:P.
rewrite /b /drop_ nth_mkseq; last by lia.
rewrite totalE of_natE /= mulrC divfK // /greville /v /drop_ [(k + i)%N]addnC big_addn (_ : i + k + n - k = i + n)%N; last by lia.
by apply: eq_bigr => j _; rewrite addnC.
Qed.
