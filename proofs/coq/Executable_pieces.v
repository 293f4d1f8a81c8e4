(* Programs: FJ07 from piece to piece, (10) to (12), and from cell to cell, (18).
   Definitions (n degree, u knots, pieces k = 1, 2, ...):
     begins n u k, length_ n u k      the start and the length of piece k
     local_program n u x k            the coordinate of the parameter x in piece k
     next_local_program n u x k       the same from x, that in piece k - 1
     affine_program L M, next_affine_program n u l mu k   lam, mu of (11) from Lam, M, and those of piece k from those of piece k - 1
     aumann_program c L M d           the Bezier row of (12)
     first_cell_program n u L M, next_cell n u l mu i     l, mu of (18) for the first cell, and of cell i = 2, 3, ... from those before
     cell_program n u c l mu d        the row from its first cell and its first vertex d
     restricted_program c r x         c_i + x (r_i - c_i), (17) *)
From Torse Require Import Prelude Points FJ07_3_pieces FJ07_3_net FJ07_3_cells Executable Executable_knots Executable_net.

Section Programs.
Variables (T Q : Type) (K : scalars T) (V : points T Q).
Implicit Types (u : seq T) (n k i : nat) (c r : seq Q) (x L M l mu : T) (d : Q).
Local Notation "u $ i" := (nth (zero K) u i) (at level 8, i at level 8, format "u $ i").
Local Notation vertex c i := (nth (origin V) c i).
Local Notation "1" := (one K).
Local Notation "x + y" := (sadd K x y).
Local Notation "x - y" := (ssub K x y).
Local Notation "x * y" := (smul K x y).
Local Notation "x / y" := (smul K x (sinv K y)).
Local Notation "x *: p" := (pscale V x p).

Definition begins n u k := u$(n + k - 2)%N.
Definition length_ n u k := begins n u k.+1 - begins n u k.
Definition divides x := ~~ same K x (zero K).
Definition local_program n u x k :=
  knot_list K n u (given (divides (length_ n u k)) Division (Value [:: (x - begins n u k) / length_ n u k])).
Definition next_local_program n u x k :=
  knot_list K n u (given (divides (length_ n u k)) Division (Value [:: length_ n u k.-1 / length_ n u k * (x - 1)])).
Definition affine_program L M := given (divides M) Division (Value [:: L / M; 1 - 1 / M]).
Definition next_affine_program n u l mu k := knot_list K n u (given (divides (length_ n u k.-1) && divides mu) Division
  (Value [:: (l + mu - 1) / mu; 1 + length_ n u k / length_ n u k.-1 * (1 - 1 / mu)])).
Definition aumann_program c L M d := given (divides M) At_knot (Value
  (sequence (fun i (z : Q) => sinv K M *: padd V (padd V ((1 - L) *: vertex c i) (L *: vertex c i.+1)) ((M - 1) *: z)) 0 d (size c))).

Definition first_cell_program n u L M := knot_list K n u (off_knots K u M (Value [:: (L - u$0) / (M - u$0); (M - u$n) / (M - u$0)])).
Definition next_cell n u l mu i :=
  let a := u$(i - 2)%N in let b := u$(i - 1)%N in let p := u$(i + n - 2)%N in let q := u$(i + n - 1)%N in
  let e := p - b + mu * (b - a) in
  given (divides e) (Cell i) (Value ((mu * (b - a) + l * (p - a) - b + a) / e, (p - q + mu * (q - a)) / e)).
Definition next_cell_program n u l mu i := knot_list K n u (if next_cell n u l mu i is Value (l', mu') then Value [:: l'; mu'] else Fails _ (Cell i)).
Fixpoint cell_rows n u c i l mu d k : answer (seq Q) := if k is k'.+1 then
  let d' := padd V (padd V ((1 - l - mu) *: vertex c i.-1) (l *: vertex c i)) (mu *: d) in
  if k' is 0 then Value [:: d; d'] else
  match next_cell n u l mu i.+1 with
  | Value (l', mu') => if cell_rows n u c i.+1 l' mu' d' k' is Value r then Value (d :: r) else cell_rows n u c i.+1 l' mu' d' k'
  | Fails e => Fails _ e
  end else Value [:: d].
Definition cell_program n u c l mu d := knot_list K n u (fits n u c (cell_rows n u c 1 l mu d (last_ n u))).
Definition restricted_program c r x := mkseq (fun i => padd V (vertex c i) (x *: psub V (vertex r i) (vertex c i))) (size c).
End Programs.

Section Equal.
Variables (F : fieldType) (m : nat) (lt : F -> F -> bool).
Implicit Types (u : seq F) (n k i : nat) (c r : seq 'rV[F]_m) (x y L M l mu : F) (d : 'rV[F]_m).
Local Notation K := (of_field lt).
Local Notation V := (rows F m).
Local Notation at_list := (nth 0).

Lemma length1E n u k : length_ K n.+1 u k.+2.-1 = len (at_list u) n k.
Proof. by rewrite /length_ /begins /len !addSn !addnS !subSS !subn0. Qed.

Lemma lengthE n u k : length_ K n.+1 u k.+1 = len (at_list u) n k.
Proof. by rewrite /length_ /begins /len !addSn !addnS !subSS !subn0. Qed.

(** FJ07.10 program: the program gives $\Lambda_k=(\Lambda^{*}-u_{n+k-2})/\Delta u_{n+k-2}$, wherever it gives a value, and then the piece is not empty. *)
Theorem FJ07_10_program n u x k y : local_program K n.+1 u x k.+1 = Value [:: y] ->
  len (at_list u) n k != 0 /\ y = local (at_list u) n k x.
Proof.
case/knot_listP=> _; rewrite lengthE /divides => e; have [nz {}e] := given_Value e; split=> //.
by case: e => <-; rewrite /local /begins addSn addnS !subSS subn0.
Qed.

(** FJ07.10 step: the program of the recursion gives $\Lambda_k$ from $\Lambda_{k-1}$, wherever it gives a value.
    Hypotheses: piece $k-1$ is not empty. *)
Theorem FJ07_10_step n u x k y : len (at_list u) n k != 0 ->
  next_local_program K n.+1 u (local (at_list u) n k x) k.+2 = Value [:: y] -> y = local (at_list u) n k.+1 x.
Proof.
move=> h /knot_listP[_]; rewrite length1E lengthE /divides => e; have [nz {}e] := given_Value e.
by case: e => <-; rewrite FJ07_10_recursion.
Qed.

(** FJ07.11 program: the programs give $\lambda=\Lambda/M$, $\mu=1-1/M$ and their recursion from piece to piece, wherever they give values.
    Hypotheses: piece $k$ is not empty; $M^{*}$ does not start it. *)
Theorem FJ07_11_program n u k L M l mu l' mu' (v := at_list u) :
  affine_program K (local v n k L) (local v n k M) = Value [:: l; mu] ->
  next_affine_program K n.+1 u l mu k.+2 = Value [:: l'; mu'] -> len v n k.+1 != 0 -> local v n k.+1 M != 0 ->
  affine_program K (local v n k.+1 L) (local v n k.+1 M) = Value [:: l'; mu'].
Proof.
rewrite /affine_program /divides /= => e; have [m0 [<- <-]] := given_Value e.
case/knot_listP=> _; rewrite length1E lengthE /divides => {}e; have [/andP[h0 mu0] [<- <-]] := given_Value e => h1 m1.
rewrite /given m1 !mul1r; have := FJ07_11_recursion L h0 h1 m0 m1; rewrite /= => -[-> ->].
by [].
Qed.

(** FJ07.12 program: the program of (12) gives a Bezier row $D$ with $(1-\Lambda)C_i+\Lambda C_{i+1}=(1-M)D_i+MD_{i+1}$, $i<n$, wherever it gives a row. *)
Theorem FJ07_12_program c L M d r : aumann_program K V c L M d = Value r -> [/\ size r = size c, (0 < size c)%N -> at_list r 0 = d &
  forall i, (i.+1 < size c)%N -> (1 - L) *: at_list c i + L *: at_list c i.+1 = (1 - M) *: at_list r i + M *: at_list r i.+1].
Proof.
rewrite /aumann_program /divides => e; have [/= m0 [<-]] := given_Value e; split; [exact: size_sequence | by case: (size c)|].
move=> i lt_i; rewrite nth_sequence // add0n /=; move: (nth _ (sequence _ _ _ _) _) (nth 0 c i) (nth 0 c i.+1) => x y z.
by by_entries j; field.
Qed.

(** FJ07.18 program: the program that goes from cell to cell by (18), from the first cell of $\Lambda^{*}$, $M^{*}$, gives the row of (13).
    Hypotheses: the list is one of knots, there are $L+1$ points, $M^{*}$ is none of the knots. *)
Theorem FJ07_18_program n u c L M d l mu : size c = (size u - n).+1 -> first_cell_program K n u L M = Value [:: l; mu] ->
  cell_program K V n u c l mu d = Value (mkseq (net (at_list u) n L M (at_list c) d) (size u - n).+1).
Proof.
move=> sc /knot_listP[hv /off_knotsP[off e]]; rewrite /cell_program knot_listP; split=> //; rewrite fitsP; split=> //.
have [n0 le_n _ mult _] := hv; have nz j (lt_j : (j < size u)%N) : M - at_list u j != 0 by exact: off_neq.
pose lc i := (L - at_list u i) / (M - at_list u i); pose mc i := (M - at_list u (i + n)) / (M - at_list u i).
have [-> ->] : l = lc 0%N /\ mu = mc 0%N by case: e => <- <-.
suff go k i : (i + k = size u - n)%N -> cell_rows K V n u c i.+1 (lc i) (mc i) (net (at_list u) n L M (at_list c) d i) k
    = Value [seq net (at_list u) n L M (at_list c) d j | j <- iota i k.+1] by exact: (go (size u - n)%N 0%N).
elim: k i => [|k ih] i sz; first by [].
have step : net (at_list u) n L M (at_list c) d i.+1 = (1 - lc i - mc i) *: at_list c i + lc i *: at_list c i.+1
    + mc i *: net (at_list u) n L M (at_list c) d i.
  by apply/(FJ07_18_cell n L (at_list c) _ (nz i _)); [lia | apply: net_off => //; lia].
rewrite [cell_rows _ _ _ _ _ _ _ _ _ _]/= -step; case: k ih sz => [|k] ih sz; first by [].
have [b0 p0] : M - at_list u i.+1 != 0 /\ at_list u (i + n) - at_list u i != 0.
  by split; [apply: nz; lia | rewrite subr_eq0 eq_sym mult //; lia].
have a0 : M - at_list u i != 0 by apply: nz; lia.
have [el em] := FJ07_18_recursion (at_list u (i + n).+1) L a0 b0 p0.
have eD : D (at_list u i) (at_list u i.+1) (at_list u (i + n)) (mc i) != 0.
  rewrite (_ : D _ _ _ _ = (M - at_list u i.+1) * (at_list u (i + n) - at_list u i) / (M - at_list u i)); last by rewrite /D /mc; field.
  by rewrite !mulf_neq0 ?invr_eq0.
have -> : next_cell K n u (lc i) (mc i) i.+2 = Value (lc i.+1, mc i.+1).
  rewrite /next_cell /divides !addSn !subSS !subn0 /=; move: eD; rewrite /D => /= eD; rewrite /given.
  by rewrite eD; congr (Value (_, _)); [exact: el | exact: em].
by rewrite ih; last by lia.
Qed.

(** FJ07.17 program: the program for $\tilde d_i=c_i+\beta(d_i-c_i)$ gives a row that obeys (13) with $M^{*}$ and $M^{*}+\beta(\Lambda^{*}-M^{*})$. *)
Theorem FJ07_17_program n (u : nat -> F) c r L M x i : (i.+1 < size c)%N -> cell u n L M (at_list c) (at_list r) i ->
  cell u n (M + x * (L - M)) M (at_list c) (at_list (restricted_program V c r x)) i.
Proof.
move=> lt_i /(FJ07_17_restriction x); rewrite /cell /restricted_program !nth_mkseq //; exact: ltnW.
Qed.
End Equal.
