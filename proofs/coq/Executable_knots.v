(* Programs: the checks of a knot list, blossoms, points and derivatives of curves.
   Definitions (lists u of knots and c of points, degree n; L is the index of the last point):
     last_ n u        L = size u - n
     knot_list n u a  a, where u is a knot list of degree n; the reason why it is not otherwise, as the library's KnotList finds it
     fits n u c a     a, where c has the L + 1 points that the knots ask for
     carries n u      no denominator of de Boor's algorithm vanishes over the first 2n knots
     deboor u c v     de Boor's algorithm, all points of a row at a time
     blossom_program n u c k v, point_program n u c k t, derivative_program n u c k t   c[v_1, ..., v_n], c(t), c'(t) on piece k = 1, 2, ... *)
From Torse Require Import Prelude Blossom Curves Points FJ21_4 Executable.
From mathcomp Require Import order ssrnum.
Import Order.TTheory Num.Theory.

Section Programs.
Variables (T P : Type) (K : scalars T) (V : points T P).
Implicit Types (u : seq T) (c : seq P) (n k i : nat) (x : T * T).
Local Notation "u $ i" := (nth (zero K) u i) (at level 8, i at level 8, format "u $ i").

Definition last_ n u := (size u - n)%N.
Definition descends u i := less K u$(i.+1) u$i.
Definition repeats n u i := same K u$i u$(i + n).
Definition knot_list A n u (a : answer A) : answer A :=
  let down := find (descends u) (iota 0 (size u).-1) in
  let many := find (repeats n u) (iota 0 (last_ n u)) in
  given (Nat.ltb 0 n) Degree
  (given (Nat.leb (n + n) (size u)) Knots
  (given (Nat.eqb down (size u).-1) (Knot down.+1)
  (given (Nat.eqb many (last_ n u)) (Knot (many + n))
  (given (~~ same K u$(n.-1) u$(last_ n u)) Knots a)))).
Definition fits A n u c (a : answer A) := given (Nat.eqb (size c) (last_ n u).+1) Vertices a.

Definition carries n u :=
  all (fun i => all (fun j => ~~ same K (ssub K u$j u$i) (zero K)) (iota n i.+1)) (iota 0 n).
Definition step_point u m x c i := let hi := u$(i + m) in let lo := u$i in
  pscale V (sinv K (ssub K hi lo))
    (padd V (pscale V (ssub K (smul K x.2 hi) x.1) (nth (origin V) c i)) (pscale V (ssub K x.1 (smul K x.2 lo)) (nth (origin V) c i.+1))).
Fixpoint deboor u c v := if v is x :: v' then deboor (behead u) (mkseq (step_point u (size v) x c) (size v)) v' else nth (origin V) c 0.
Definition blossom_program n u c k v := knot_list n u (fits n u c
  (given (carries n (drop k.-1 u)) Division (Value (deboor (drop k.-1 u) (drop k.-1 c) v)))).
Definition parameter (t : T) := (t, one K).
Definition infinite := (one K, zero K).
Definition point_program n u c k t := blossom_program n u c k (nseq n (parameter t)).
Definition derivative_program n u c k t := knot_list n u (fits n u c (given (carries n (drop k.-1 u)) Division
  (Value (pscale V (of_nat K n) (deboor (drop k.-1 u) (drop k.-1 c) (infinite :: nseq n.-1 (parameter t))))))).
End Programs.

Section Equal.
Variables (F : fieldType) (m : nat) (lt : F -> F -> bool).
Implicit Types (u : seq F) (c : seq 'rV[F]_m) (n k : nat) (t : F).
Local Notation K := (of_field lt).
Local Notation V := (rows F m).
Local Notation at_list := (nth 0).

Lemma nat_ltbE a b : Nat.ltb a b = (a < b)%N. Proof. by apply/PeanoNat.Nat.ltb_spec0/idP; lia. Qed.
Lemma nat_lebE a b : Nat.leb a b = (a <= b)%N. Proof. by apply/PeanoNat.Nat.leb_spec0/idP; lia. Qed.
Lemma nat_eqbE a b : Nat.eqb a b = (a == b). Proof. by apply/PeanoNat.Nat.eqb_spec/eqP. Qed.

Lemma carriesP n u : reflect (span n (at_list u)) (carries K n u).
Proof.
apply: (iffP allP) => h.
  move=> i j lt_i le_j; rewrite unitfE; have := allP (h i _) j; rewrite !mem_iota /= => -> //; lia.
move=> i; rewrite mem_iota => lt_i; apply/allP => j; rewrite mem_iota => le_j /=.
by rewrite -unitfE; apply: h; lia.
Qed.

Lemma deboorE u c v : deboor K V u c v = pblossom (at_list u) (at_list c) v.
Proof.
elim: v u c => [|x v ih] u c; first by apply/rowP=> k; rewrite !mxE.
apply/rowP=> k; rewrite [deboor _ _ _ _ _]/= ih !mxE /= (@blossom_ext_knots _ _ (shift (at_list u))); last first.
  by move=> i _; rewrite nth_behead.
by apply: blossom_ext => i le_i; rewrite /coord nth_mkseq // !mxE /step /= mulrC.
Qed.

Lemma nth_drop_ T (x : T) (s : seq T) k i : nth x (drop k s) i = drop_ k (nth x s) i.
Proof. by rewrite nth_drop. Qed.

Lemma all_find T (a : T -> bool) s : Nat.eqb (find a s) (size s) = all (predC a) s.
Proof. by rewrite nat_eqbE all_predC has_find -leqNgt eqn_leq find_size. Qed.

Lemma iotaP (a : nat -> bool) k : reflect (forall i, (i < k)%N -> a i) (all a (iota 0 k)).
Proof. by apply: (iffP allP) => h i => [lt_i|]; [apply: h; rewrite mem_iota | rewrite mem_iota => /h]. Qed.

Definition valid n u := [/\ (0 < n)%N, (n + n <= size u)%N, forall i, (i.+1 < size u)%N -> ~~ lt (at_list u i.+1) (at_list u i),
  forall i, (i < size u - n)%N -> at_list u i != at_list u (i + n)%N & at_list u n.-1 != at_list u (size u - n)%N].

Lemma knot_listP A n u (a : answer A) x : knot_list K n u a = Value x <-> valid n u /\ a = Value x.
Proof.
have sz k (f : pred nat) : Nat.eqb (find f (iota 0 k)) k = all (predC f) (iota 0 k) by rewrite -{2}(size_iota 0 k) all_find.
rewrite /knot_list !sz nat_ltbE nat_lebE /given; split=> [|[[n0 le_n up mult dom] ->]].
  case: ltnP => // n0; case: leqP => // le_n; case: iotaP => // up; case: iotaP => // mult; case: ifP => //= dom ->.
  split=> //; split=> // i lt_i; apply: (up i); rewrite -subn1 ltn_subRL add1n //.
rewrite n0 le_n; have -> : all (predC (descends K u)) (iota 0 (size u).-1) by apply/iotaP=> i; rewrite -subn1 ltn_subRL add1n; apply: up.
have -> : all (predC (repeats K n u)) (iota 0 (last_ n u)) by apply/iotaP; exact: mult.
by rewrite /last_ /= dom.
Qed.

Lemma fitsP (P : Type) A n u (c : seq P) (a : answer A) x : fits n u c a = Value x <-> size c = (size u - n).+1 /\ a = Value x.
Proof. by rewrite /fits nat_eqbE /given; split=> [|[-> ->]]; rewrite ?eqxx //; case: ifP => // /eqP. Qed.

Lemma deboor_drop u c k v : deboor K V (drop k u) (drop k c) v = pblossom (drop_ k (at_list u)) (drop_ k (at_list c)) v.
Proof.
rewrite deboorE; apply/rowP=> j; rewrite !mxE (@blossom_ext_knots _ _ (drop_ k (at_list u))) => [|i _]; last by rewrite nth_drop.
by apply: blossom_ext => i _; rewrite /coord nth_drop.
Qed.

(** blossoms program: de Boor's algorithm, as a program on lists, gives $c[v_1,\dots,v_n]$ on piece $k$; it gives a value iff the list is one
    of knots, there are as many points as it asks for and the knots carry the piece. *)
Theorem blossoms_program n u c k v p : blossom_program K V n u c k.+1 v = Value p <->
  [/\ valid n u, size c = (size u - n).+1, span n (drop_ k (at_list u)) & p = pblossom (drop_ k (at_list u)) (drop_ k (at_list c)) v].
Proof.
rewrite /blossom_program knot_listP fitsP deboor_drop.
have spE : span n (at_list (drop k u)) <-> span n (drop_ k (at_list u)).
  by split=> sp i j lt_i le_j; have := sp i j lt_i le_j; rewrite !nth_drop.
split=> [[hv [hs]]|[hv hs /spE/carriesP ok ->]]; last by rewrite ok.
by rewrite /given; case: carriesP => // /spE sp [<-].
Qed.

(** blossoms value: the program for a point of a curve gives $c(t)$ on piece $k$, wherever it gives a value. *)
Theorem blossoms_value n u c k t p : point_program K V n u c k.+1 t = Value p ->
  p = ev (pcurve n (drop_ k (at_list u)) (drop_ k (at_list c))) t.
Proof.
case/blossoms_program=> hv hs sp ->; apply/rowP=> j; rewrite !mxE horner_curve //.
Qed.

Lemma horner_velocity n (v b : nat -> F) t : (0 < n)%N -> span n v ->
  (velocity n v b).[t] = blossom v b (direction F :: nseq n.-1 (at_ t)).
Proof.
case: n => // n _ sp; rewrite -[LHS]/(horner_eval t _) /velocity (blossom_morph [rmorphism of horner_eval t]); last first.
  by rewrite /= size_nseq; apply: span_polys.
rewrite /= map_nseq /= /horner_eval hornerX !hornerC.
rewrite (@blossom_ext_knots _ _ (shift v)); last by move=> i _ /=; rewrite /shift /= hornerC.
by apply: blossom_ext => i _ /=; rewrite /step /= /horner_eval /polys !hornerC ?size_map ?size_nseq.
Qed.

(** blossoms slope: the program for a derivative gives $c'(t)$ on piece $k$, wherever it gives a value. *)
Theorem blossoms_slope n u c k t p : derivative_program K V n u c k.+1 t = Value p ->
  p = ev (pderiv (pcurve n (drop_ k (at_list u)) (drop_ k (at_list c)))) t.
Proof.
case/knot_listP=> -[n0 _ _ _ _] /fitsP[_]; rewrite /given; case: carriesP => // sp e; rewrite -(Value_inj e).
have spd : span n (drop_ k (at_list u)) by move=> i j lt_i le_j; have := sp i j lt_i le_j; rewrite !nth_drop.
rewrite deboor_drop of_natE; apply/rowP=> j; rewrite !mxE blossoms_derivative // hornerMn horner_velocity // mulr_natl //.
Qed.
End Equal.
