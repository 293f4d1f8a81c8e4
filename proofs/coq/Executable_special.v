(* Programs: cylinders and the vertex of a cone, FJ07, section 2; points of tangents, FJ07.9 and FJ21.3.5.
   Definitions (n degree, u knots, c points, pieces k = 1, 2, ...):
     cylinder_program c v h        FJ07.4: c_i + h_i v
     apex_program p q a            FJ07.6: the vertex of the cone of the rows that begin with p and q
     restricted_lambda L M b       FJ07.17: M + b (L - M)
     tangent_point_program n u c k t r   c[t, ..., t, r] on piece k
     last_pair_program n u c k t   c[t, ..., t, a], c[t, ..., t, b] on piece k = [a, b] *)
From Torse Require Import Prelude Blossom Curves Points FJ07_2 FJ07_2_cones FJ07_3_net FJ21_4 Executable Executable_knots Executable_pieces.

Section Programs.
Variables (T Q : Type) (K : scalars T) (V : points T Q).
Implicit Types (u e : seq T) (c : seq Q) (n k : nat) (t a b L M : T) (r : T * T).
Local Notation "u $ i" := (nth (zero K) u i) (at level 8, i at level 8, format "u $ i").
Local Notation "x + y" := (sadd K x y).
Local Notation "x - y" := (ssub K x y).
Local Notation "x * y" := (smul K x y).

Definition cylinder_program c (v : Q) e := given (Nat.eqb (size e) (size c)) Lengths
  (Value (mkseq (fun i => padd V (nth (origin V) c i) (pscale V e$i v)) (size c))).
Definition apex_program (p q : Q) a := given (~~ same K a (one K)) Alpha
  (Value (pscale V (sinv K (a - one K)) (psub V (pscale V a p) q))).
Definition restricted_lambda L M b := M + b * (L - M).
Definition tangent_point_program n u c k t r := knot_list K n u (fits n u c (given (carries K n (drop k.-1 u)) Division
  (Value (deboor K V (drop k.-1 u) (drop k.-1 c) (r :: nseq n.-1 (parameter K t)))))).
Definition last_pair_program n u c k t := knot_list K n u (fits n u c (given (carries K n (drop k.-1 u)) Division
  (let point a := deboor K V (drop k.-1 u) (drop k.-1 c) (parameter K a :: nseq n.-1 (parameter K t)) in
   Value [:: point u$(n + k - 2)%N; point u$(n + k - 1)%N]))).
End Programs.

Section Equal.
Variables (F : fieldType) (m : nat) (lt : F -> F -> bool).
Implicit Types (u e : seq F) (c d : seq 'rV[F]_m) (v p q : 'rV[F]_m) (n k i : nat) (t a b L M : F).
Local Notation K := (of_field lt).
Local Notation V := (rows F m).
Local Notation at_list := (nth 0).

(** FJ07.4 program: the program gives $d_i=c_i+h_iv$, so that on every piece $d(t)-c(t)=h(t)\,v$, iff there is a length $h_i$ for each point. *)
Theorem FJ07_4_program n u c v e k :
  (forall r, cylinder_program K V c v e = Value r ->
    pcurve n (drop_ k (at_list u)) (drop_ k (at_list r)) - pcurve n (drop_ k (at_list u)) (drop_ k (at_list c))
      = curve n (drop_ k (at_list u)) (drop_ k (at_list e)) *: fixed v) /\
  (cylinder_program K V c v e = Fails _ Lengths <-> size e <> size c).
Proof.
rewrite /cylinder_program nat_eqbE /given; case: eqP => sz; split=> // r er.
rewrite -(Value_inj er); apply/rowP=> j; rewrite !mxE.
apply/eqP; rewrite subr_eq addrC -[X in _ == X + _]mul1r -polyC1 [X in _ == _ + X]mulrC -curve_comb; apply/eqP.
apply: blossom_ext => i _; rewrite /polys /coord /drop_; have [lt_i|ge_i] := ltnP (k + i) (size c).
  by rewrite nth_mkseq //= ?mxE ?mul1r 1?[v 0 j * _]mulrC.
by rewrite !nth_default ?size_mkseq ?sz // mxE !(mulr0, addr0).
Qed.

(** FJ07.6 program: the program gives the vertex $a$ of the cone: rows with $d_i-d_{i-1}=\alpha(c_i-c_{i-1})$ have $d_i-a=\alpha(c_i-a)$; it gives an error
    iff $\alpha=1$. *)
Theorem FJ07_6_program p q a c d k : 
  (forall o, apex_program K V p q a = Value o -> at_list c 0 = p -> at_list d 0 = q -> proportional a (at_list c) (at_list d) k ->
    forall i, (i <= k)%N -> at_list d i - o = a *: (at_list c i - o)) /\
  (apex_program K V p q a = Fails _ Alpha <-> a = 1).
Proof.
rewrite /apex_program /given /=; case: eqVneq => [->|a1]; split=> //; last by split=> // e; case/eqP: a1.
move=> o e ep eq prop; rewrite -(Value_inj e) {e}.
have a0 : a - 1 != 0 by rewrite subr_eq0.
have -> : (a - 1)^-1 *: (a *: p - q) = vertex a (at_list c) (at_list d) by rewrite /vertex ep eq.
exact/(FJ07_6_vertex _ _ _ a0).
Qed.

(** FJ07.17 lambda: the programs for the row and for $\tilde\Lambda^{*}$ keep (13), with the same $M^{*}$. *)
Theorem FJ07_17_lambda n (u : nat -> F) c d L M b i : (i.+1 < size c)%N -> cell u n L M (at_list c) (at_list d) i ->
  cell u n (restricted_lambda K L M b) M (at_list c) (at_list (restricted_program V c d b)) i.
Proof. exact: FJ07_17_program. Qed.

(** FJ21.3.5 program: the program gives $c[t^{\langle n-1\rangle},x]=c(t)+\frac{x-t}nc'(t)$ on piece $k$, and at the infinite parameter $c'(t)/n$, wherever it gives
    a value.
    Hypotheses: $n\ne0$ in the field. *)
Theorem FJ21_3_5_program n u c k t p (C := pcurve n (drop_ k (at_list u)) (drop_ k (at_list c))) : n%:R != 0 :> F ->
  (forall x, tangent_point_program K V n u c k.+1 t (parameter K x) = Value p -> p = tangent n C t x) /\
  (tangent_point_program K V n u c k.+1 t (infinite K) = Value p -> p = n%:R^-1 *: ev (pderiv C) t).
Proof.
move=> n0; have spd : carries K n (drop k.+1.-1 u) -> span n (drop_ k (at_list u)).
  by move/carriesP=> sp i j lt_i le_j; have := sp i j lt_i le_j; rewrite !nth_drop.
split=> [x|] /knot_listP[[pos _ _ _ _] /fitsP[_ e]]; have [/spd sp {}e] := given_Value e; rewrite -(Value_inj e) deboor_drop.
  by rewrite FJ21_3_5_tangent.
apply: (scalerI n0); rewrite scalerA mulfV // scale1r; apply/rowP=> j; rewrite !mxE blossoms_derivative // hornerMn horner_velocity //.
exact: mulr_natl.
Qed.

(** FJ21.3.2 pair: for the two points that the program gives on a piece $[a,b]$, $c'(t)=\frac n{b-a}(c_1^{n-1}(t)-c_0^{n-1}(t))$, and $a\ne b$, wherever it gives
    points. *)
Theorem FJ21_3_2_pair n u c k t p q (a := at_list u (n + k - 1)) (b := at_list u (n + k)) :
  last_pair_program K V n u c k.+1 t = Value [:: p; q] -> a != b /\
  ev (pderiv (pcurve n (drop_ k (at_list u)) (drop_ k (at_list c)))) t = (n%:R / (b - a)) *: (q - p).
Proof.
move=> /knot_listP[[pos _ _ _ _] /fitsP[_ e]]; have [/carriesP sp {}e] := given_Value e.
have spd : span n (drop_ k (at_list u)) by move=> i j lt_i le_j; have := sp i j lt_i le_j; rewrite !nth_drop.
have ba : b - a != 0.
  by rewrite -unitfE /a /b (_ : n + k = k + n)%N 1?(_ : k + n - 1 = k + n.-1)%N; [apply: spd; lia | lia | lia].
split; first by rewrite eq_sym -subr_eq0.
have := Value_inj e; rewrite !deboor_drop (_ : n + k.+1 - 2 = n + k - 1)%N 1?(_ : n + k.+1 - 1 = n + k)%N; [|lia|lia].
rewrite -/a -/b => -[<- <-]; apply/rowP=> j; rewrite !mxE blossoms_derivative // hornerMn horner_velocity //.
have -> : direction F = comb (b - a)^-1 (at_ b) (- (b - a)^-1) (at_ a).
  by rewrite /comb /direction /at_ /=; congr (_, _); field.
rewrite (blossoms_multilinear _ _ [::]) -mulr_natl /=; move: (blossom _ _ _) (blossom _ _ _) n%:R => x y N; by field.
Qed.
End Equal.
