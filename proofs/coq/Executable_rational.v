(* Programs: the 4 x 4 determinant of FJ21 Corollary 3.1, and the decision for rational surfaces.
   Definitions (n degree, u knots, c and d homogeneous rows, pieces k = 1, 2, ...; w, x, y, z give the coordinates of a row):
     det_of a b c d           the determinant of the rows a, b, c, d
     condition4 n u c d k t   that of c[t, ..., t, a], c[t, ..., t, b], d[t, ..., t, a], d[t, ..., t, b] on piece k = [a, b]
     determinant4_program n u c d k s   n^4 times it at the coordinate s of piece k
     refuted4 n u c d k       condition4 does not vanish at one of the parameters 0, 1, ..., 4(n-1)
     check4_program n u c d   the first piece that is not empty and refuted; 0 where there is none *)
From Torse Require Import Prelude Blossom Curves Points Functions FJ21_2 FJ21_3 FJ21_4 Executable Executable_knots Executable_determinant.

Section Programs.
Variables (T Q : Type) (K : scalars T) (V : points T Q) (w x y z : Q -> T).
Implicit Types (u : seq T) (n k : nat) (c d : seq Q) (s t : T).
Local Notation "u $ i" := (nth (zero K) u i) (at level 8, i at level 8, format "u $ i").
Local Notation "x + y" := (sadd K x y).
Local Notation "x - y" := (ssub K x y).
Local Notation "x * y" := (smul K x y).
Local Notation triple_of := (triple_of K x y z).

Definition det_of (a b c d : Q) := w a * triple_of b c d - w b * triple_of a c d + w c * triple_of a b d - w d * triple_of a b c.
Definition condition4 n u c d k t :=
  let v := drop k.-1 u in let from := fun r x => deboor K V v (drop k.-1 r) (parameter K x :: nseq n.-1 (parameter K t)) in
  let a := u$(n + k - 2)%N in let b := u$(n + k - 1)%N in det_of (from c a) (from c b) (from d a) (from d b).
Definition determinant4_program n u c d k s := knot_list K n u (fits n u c (fits n u d (given (carries K n (drop k.-1 u)) Division
  (let a := u$(n + k - 2)%N in let len := u$(n + k - 1)%N - a in let N := of_nat K n in
   Value [:: N * N * (N * N) * condition4 n u c d k (a + s * len)])))).
Definition refuted4 n u c d k := ~~ all (fun j => same K (condition4 n u c d k (of_nat K j)) (zero K)) (iota 0 (4 * n.-1).+1).
Definition check4_program n u c d := knot_list K n u (fits n u c (fits n u d
  (Value (head 0%N (filter (fun k => carries K n (drop k.-1 u) && refuted4 n u c d k) (iota 1 (last_ n u - n).+1)))))).
End Programs.

Lemma head_filter (a : pred nat) K k : head 0%N (filter a (iota 1 K)) = k ->
  (k = 0%N <-> forall j, (j < K)%N -> ~~ a j.+1) /\ forall j, k = j.+1 -> (j < K)%N /\ a j.+1.
Proof.
have in_all j : (j.+1 \in filter a (iota 1 K)) = a j.+1 && (j < K)%N by rewrite mem_filter mem_iota /= add1n ltnS.
case E : (filter a (iota 1 K)) in_all => [|i s] in_all <- /=.
  by split=> //; split=> // _ j lt_j; have := in_all j; rewrite lt_j andbT => <-.
have [i0 lt_i a_i] : [/\ (0 < i)%N, (i <= K)%N & a i].
  by have := mem_head i s; rewrite -E mem_filter mem_iota add1n ltnS => /andP[-> /andP[]].
split=> [|j <-]; last by split=> //; rewrite -(prednK i0).
split=> [e|h]; first by rewrite e in i0.
case: i i0 lt_i a_i E in_all => // i _ _ a_i _ in_all; have := in_all i; rewrite mem_head a_i /= => /esym/h.
by rewrite a_i.
Qed.

Section Equal.
Variables (F : fieldType) (lt : F -> F -> bool).
Implicit Types (u : seq F) (n k i j : nat) (c d : seq 'rV[F]_4) (s t : F).
Local Notation K := (of_field lt).
Local Notation V := (rows F 4).
Local Notation at_list := (nth 0).
Local Notation wt := (@weight F).
Local Notation px := (fun p => x_ (place p)).
Local Notation py := (fun p => y_ (place p)).
Local Notation pz := (fun p => z_ (place p)).
Local Notation condition4 := (condition4 K V wt px py pz).
Local Notation points_of n u c d k := (let v := drop_ k (at_list u) in let a := at_list u (n + k.+1 - 2)%N in let b := at_list u (n + k.+1 - 1)%N in
  rows4 (last_point n v (drop_ k (at_list c)) a) (last_point n v (drop_ k (at_list c)) b)
    (last_point n v (drop_ k (at_list d)) a) (last_point n v (drop_ k (at_list d)) b)).

Lemma det_ofE (a b c d : 'rV[F]_4) : det_of K wt px py pz a b c d = \det (rows4 a b c d).
Proof. by rewrite det_rows4 !tripleE. Qed.

Lemma horner_det4 (a b c d : 'rV[{poly F}]_4) t : (\det (rows4 a b c d)).[t] = \det (rows4 (ev a t) (ev b t) (ev c t) (ev d t)).
Proof.
rewrite -[LHS]/(horner_eval t _) -det_map_mx; congr (\det _); apply/matrixP=> i j; rewrite !mxE /= /horner_eval.
by case: i => -[|[|[|[|//]]]] lt_i /=; rewrite mxE.
Qed.

Lemma horner_last m n v (c : nat -> 'rV[F]_m) a t : span n v -> (0 < n)%N ->
  ev (last_point n v c a) t = pblossom v c (at_ a :: nseq n.-1 (at_ t)).
Proof.
case: n => // n sp _; apply/rowP=> j; rewrite !mxE -[LHS]/(horner_eval t _).
rewrite (blossom_morph [rmorphism of horner_eval t]); last by rewrite /= size_nseq; apply: span_polys.
rewrite /= map_nseq /= /horner_eval hornerX !hornerC.
rewrite (@blossom_ext_knots _ _ (shift v)); last by move=> i _ /=; rewrite /shift /= hornerC.
by apply: blossom_ext => i _ /=; rewrite /step /= /horner_eval /polys !hornerC ?size_map ?size_nseq.
Qed.

Lemma condition4E n u c d k t : (0 < n)%N -> span n (drop_ k (at_list u)) -> (\det (points_of n u c d k)).[t] = condition4 n u c d k.+1 t.
Proof. by move=> n0 sp; rewrite horner_det4 !horner_last // /condition4 det_ofE !deboor_drop. Qed.

(** FJ21.C3.1 program: the program gives $n^4\det(p[t^{\langle n-1\rangle},a],p[t^{\langle n-1\rangle},b],q[t^{\langle n-1\rangle},a],q[t^{\langle n-1\rangle},b])$ at the
    coordinate $s$ of piece $k=[a,b]$, wherever it gives a value. *)
Theorem FJ21_C3_1_program n u c d k s p (v := drop_ k (at_list u)) (a := at_list u (n + k)) (b := at_list u (n + k).+1) :
  determinant4_program K V wt px py pz n.+1 u c d k.+1 s = Value [:: p] ->
  p = n.+1%:R ^+ 4 * (\det (rows4 (last_point n.+1 v (drop_ k (at_list c)) a) (last_point n.+1 v (drop_ k (at_list c)) b)
    (last_point n.+1 v (drop_ k (at_list d)) a) (last_point n.+1 v (drop_ k (at_list d)) b))).[a + s * (b - a)].
Proof.
case/knot_listP=> _ /fitsP[_] /fitsP[_]; rewrite /given; case: carriesP => // sp e.
have spd : span n.+1 v by move=> i j lt_i le_j; have := sp i j lt_i le_j; rewrite !nth_drop.
have <- : n.+1%:R * n.+1%:R * (n.+1%:R * n.+1%:R) * condition4 n.+1 u c d k.+1 (a + s * (b - a)) = p.
  by move: e; rewrite of_natE !addSn !addnS !subSS !subn0 => -[<-].
rewrite -condition4E // !addSn !addnS !subSS !subn0; move: (_.[_]) (n.+1%:R) => x N; ring.
Qed.

(** FJ21.C3.1 decides: the program that evaluates the determinant of a piece at $4(n-1)+1$ parameters says that it is refuted iff
    $p[t^{\langle n-1\rangle},a]$, ... are independent over the polynomials.
    Hypotheses: the knots carry the piece, so that its points have a meaning; $1,\dots,4(n-1)$ are not 0 in the field. *)
Theorem FJ21_C3_1_decides n u c d k (v := drop_ k (at_list u)) (a := at_list u (n + k)) (b := at_list u (n + k).+1) :
  (forall i, (0 < i <= 4 * n)%N -> i%:R != 0 :> F) -> span n.+1 v ->
  ~~ refuted4 K V wt px py pz n.+1 u c d k.+1 <->
  dependent4 (last_point n.+1 v (drop_ k (at_list c)) a) (last_point n.+1 v (drop_ k (at_list c)) b)
    (last_point n.+1 v (drop_ k (at_list d)) a) (last_point n.+1 v (drop_ k (at_list d)) b).
Proof.
move=> nz sp; rewrite /refuted4 negbK -det_dependent; set f := \det _.
have fE j : same K (condition4 n.+1 u c d k.+1 (of_nat K j)) (zero K) = (f.[j%:R] == 0).
  by rewrite -condition4E // of_natE /= !addSn !addnS !subSS !subn0.
split=> [/iotaP all0|]; last by move=> e; apply/iotaP=> j _; rewrite fE e horner0.
apply: (@roots_geq_poly_eq0 _ f [seq j%:R | j <- iota 0 (4 * n).+1]).
- by apply/allP=> _ /mapP[j lt_j ->]; rewrite rootE -fE all0 //; move: lt_j; rewrite mem_iota.
- rewrite map_inj_in_uniq ?iota_uniq // => i j; rewrite !mem_iota /= => lt_i lt_j.
  wlog le_ij : i j lt_i lt_j / (i <= j)%N.
    by move=> th e; case: (leqP i j) => [le_ij|/ltnW le_ji]; [apply: th | symmetry; apply: th].
  move/eqP; rewrite -subr_eq0 -opprB oppr_eq0 -natrB // => /eqP e; apply/eqP; rewrite eqn_leq le_ij /= leqNgt; apply/negP=> lt_ij.
  have le_ji : (0 < j - i <= 4 * n)%N by lia.
  by have := nz _ le_ji; rewrite e eqxx.
by rewrite size_map size_iota; have := FJ21_C3_1_degree (drop_ k (at_list c)) (drop_ k (at_list d)) a b (ltn0Sn n) sp; rewrite subn1.
Qed.

(** FJ21.C3.1 check: the program gives 0 iff every piece of the list that the knots carry is developable, and else one that is not.
    Hypotheses: the program gives a value; $1,\dots,4(n-1)$ are not 0 in the field; no weight vanishes identically on a piece that the knots carry, so that its
    curves have points. *)
Theorem FJ21_C3_1_check n u c d k (piece := fun r j => pcurve n.+1 (drop_ j (at_list u)) (drop_ j (at_list r))) :
  (forall i, (0 < i <= 4 * n)%N -> i%:R != 0 :> F) ->
  (forall j, (j <= size u - n.+1 - n.+1)%N -> span n.+1 (drop_ j (at_list u)) -> weight (piece c j) != 0 /\ weight (piece d j) != 0) ->
  check4_program K V wt px py pz n.+1 u c d = Value k ->
  (k = 0%N <-> forall j, (j <= size u - n.+1 - n.+1)%N -> span n.+1 (drop_ j (at_list u)) -> rational_developable (piece c j) (piece d j)) /\
  forall j, k = j.+1 -> span n.+1 (drop_ j (at_list u)) /\ ~ rational_developable (piece c j) (piece d j).
Proof.
move=> nz w0 /knot_listP[_ e]; have [_ {}e] := (fitsP _ _ _ _ _).1 e; have [_ {}e] := (fitsP _ _ _ _ _).1 e.
have [h0 h1] := head_filter (Value_inj e).
have carryE j : carries K n.+1 (drop j u) = true <-> span n.+1 (drop_ j (at_list u)).
  split=> [/carriesP sp|sp]; last apply/carriesP; move=> i l lt_i le_l; have := sp i l lt_i le_l; rewrite !nth_drop //.
have devE j : (j <= size u - n.+1 - n.+1)%N -> span n.+1 (drop_ j (at_list u)) -> ~~ refuted4 K V wt px py pz n.+1 u c d j.+1 <-> rational_developable (piece c j) (piece d j).
  move=> le_j sp; have [wc wd] := w0 j le_j sp; have ab : at_list u (n + j) != at_list u (n + j).+1.
    have := sp n n.+1 (ltnSn n) (introT andP (conj (leqnn _) (leq_addl _ _))).
    by rewrite unitfE subr_eq0 /drop_ addnS [(j + n)%N]addnC eq_sym.
  rewrite (FJ21_C3_1_dependent (a := at_list u (n + j)) (b := at_list u (n + j).+1)) //; first exact: FJ21_C3_1_decides.
  by case: (n) nz => [_|n' nz]; [exact: oner_neq0 | apply: nz; lia].
split=> [|j /h1 [le_j /= /andP[/carryE sp bad]]]; last by split=> // /(devE j le_j sp); rewrite bad.
rewrite h0; split=> all_dev j le_j; last by rewrite /= negb_and; case: (boolP (carries _ _ _)) => //= /carryE sp; apply/(devE j le_j sp)/all_dev.
by move=> /[dup] sp /carryE ok; apply/(devE j le_j sp); have := all_dev j le_j; rewrite /= ok.
Qed.
End Equal.
