(* Programs: knot insertion, Bezier pieces, and the mappings and elevation of BZZ19.
   Definitions (n degree, u knots, c points, pieces k = 1, 2, ...):
     interval n u t            the last j, n-1 <= j <= L-1, with u_j <= t and u_j < u_{j+1}
     inserted u j t            t after u_j
     vertex_of n u c j t i     the vertex i after the insertion
     insertion_program n u c t the knots and the points with t inserted once
     pieces_program n u c k a b   the Bezier points c[a, ..., a, b, ..., b] of piece k on [a, b]
     bezier_program n u c k    those on the piece itself
     steps_program e           the sums of squares of BZZ19.5
     elevation_program c k     the points of the same Bezier curve in degree k higher, one degree at a time *)
From Torse Require Import Prelude Blossom Curves Points Bernstein Bezier BZZ19_4 Executable Executable_knots.
From mathcomp Require Import order ssrnum.
Import Order.TTheory Num.Theory.

Section Programs.
Variables (T Q : Type) (K : scalars T) (V : points T Q).
Implicit Types (u e : seq T) (c : seq Q) (n k i j : nat) (t a b : T).
Local Notation "u $ i" := (nth (zero K) u i) (at level 8, i at level 8, format "u $ i").
Local Notation vertex c i := (nth (origin V) c i).

Definition interval n u t := last 0%N (filter (fun j => ~~ less K t u$j && less K u$j u$(j.+1)) (iota n.-1 (last_ n u - n.-1))).
Definition inserted u j t := take j.+1 u ++ t :: drop j.+1 u.
Definition vertex_of n u c j t i :=
  if Nat.ltb (i + n) (j + 2) then vertex c i else if Nat.ltb j.+1 i then vertex c i.-1
  else step_point K V u n (parameter K t) c i.-1.
Definition insertion_program n u c t := knot_list K n u (fits n u c
  (given (~~ less K t u$(n.-1) && ~~ less K u$(last_ n u) t) Outside
  (let j := interval n u t in let v := inserted u j t in
   knot_list K n v (Value (v, mkseq (vertex_of n u c j t) (last_ n u).+2))))).
Definition restricted_points n u c k a b := mkseq (fun i =>
  deboor K V (drop k.-1 u) (drop k.-1 c) (nseq (n - i) (parameter K a) ++ nseq i (parameter K b))) n.+1.
Definition pieces_program n u c k a b :=
  knot_list K n u (fits n u c (given (carries K n (drop k.-1 u)) Division (Value (restricted_points n u c k a b)))).
Definition bezier_program n u c k := pieces_program n u c k u$(n + k - 2)%N u$(n + k - 1)%N.
Definition steps_program e := mkseq (fun i => total K (fun j => smul K e$j e$j) 0 i.+1) (size e).
Definition raise c := let n := size c in mkseq (fun i => pscale V (sinv K (of_nat K n))
  (padd V (pscale V (of_nat K i) (vertex c i.-1)) (pscale V (of_nat K (n - i)) (vertex c i)))) n.+1.
Definition elevation_program c k := iter k raise c.
End Programs.

Section Equal.
Variables (F : fieldType) (m : nat) (lt : F -> F -> bool).
Implicit Types (u e : seq F) (c : seq 'rV[F]_m) (n k i j : nat) (t a b : F).
Local Notation K := (of_field lt).
Local Notation V := (rows F m).
Local Notation at_list := (nth 0).

(** blossoms pieces: the program gives the points $c[a^{\langle n-i\rangle},b^{\langle i\rangle}]$ of piece $k$, wherever it gives a value. *)
Theorem blossoms_pieces n u c k a b (r : seq 'rV[F]_m) : pieces_program K V n u c k.+1 a b = Value r ->
  span n (drop_ k (at_list u)) /\ forall i, (i <= n)%N ->
  at_list r i = pblossom (drop_ k (at_list u)) (drop_ k (at_list c)) (nseq (n - i) (at_ a) ++ nseq i (at_ b)).
Proof.
case/knot_listP=> _ /fitsP[_]; rewrite /given; case: carriesP => // sp e.
split=> [i j lt_i le_j|i le_i]; first by have := sp i j lt_i le_j; rewrite !nth_drop.
by rewrite -(Value_inj e) nth_mkseq // deboor_drop.
Qed.

Lemma nth_inserted u j t i : (j < size u)%N -> at_list (inserted u j t) i =
  if (i <= j)%N then at_list u i else if i == j.+1 then t else at_list u i.-1.
Proof.
move=> lt_j; rewrite /inserted nth_cat size_takel //; case: (ltngtP i j.+1) => [lt_i|gt_i|->].
- by rewrite -ltnS lt_i nth_take.
- rewrite leqNgt (ltn_trans _ gt_i) //=; case: i gt_i => // i gt_i; rewrite subSS.
  by rewrite -[(i - j)%N]prednK ?subn_gt0 //= nth_drop -subnS subnKC.
by rewrite ltnn subnn.
Qed.

Lemma knots_inserted n u j t i : (j < size u)%N -> (i <= j)%N -> (j < i + n)%N -> knots (at_list (inserted u j t)) i.+1 n =
  knots (at_list u) i.+1 (j - i) ++ at_ t :: knots (at_list u) j.+1 (i + n - j.+1).
Proof.
move=> lt_j le_i lt_n; rewrite {1}(_ : n = (j - i) + (i + n - j.+1).+1)%N; last by lia.
rewrite /knots iotaD map_cat /= (_ : i.+1 + (j - i) = j.+1)%N; last by lia.
congr (_ ++ at_ _ :: _).
- by apply/eq_in_map => l; rewrite mem_iota nth_inserted // => h; rewrite (_ : l <= j)%N //; lia.
- by rewrite nth_inserted // ltnn eqxx.
rewrite -[j.+2]/(1 + j.+1)%N iotaDl -map_comp; apply/eq_in_map => l; rewrite mem_iota => /andP[lt_l _].
by rewrite /= nth_inserted // add1n /= leqNgt ltnW // eqSS gtn_eqF.
Qed.

(** blossoms insertion: the program of knot insertion gives the blossom of the curve at the consecutive knots of the new list as each vertex that
    it changes, $c'_{i+1}=c[u'_{i+1},\dots,u'_{i+n}]$ with $t$ among them, on every piece $k$ of the curve that $c_i$ and $c_{i+1}$ belong to.
    Hypotheses: the knots carry the piece. *)
Theorem blossoms_insertion n u c j t i k : (j < size u)%N -> (i <= j)%N -> (j < i + n)%N -> (k <= i)%N -> (i < k + n)%N ->
  span n (drop_ k (at_list u)) ->
  vertex_of K V n u c j t i.+1 = pblossom (drop_ k (at_list u)) (drop_ k (at_list c)) (knots (at_list (inserted u j t)) i.+1 n).
Proof.
case: n => [|n] lt_j le_i lt_n le_k lt_k sp; first by move: lt_k; rewrite addn0 ltnNge le_k.
rewrite knots_inserted // /vertex_of !nat_ltbE (_ : (i.+1 + n.+1 < j + 2)%N = false); last by lia.
rewrite (_ : (j.+1 < i.+1)%N = false); last by lia.
apply/rowP=> l; rewrite !mxE; set v1 := knots _ _ _; set v2 := knots _ _ _.
have sz : (size v1 + size v2)%N = n by rewrite !size_knots; lia.
rewrite blossom_move; last by rewrite sz.
have -> : v1 ++ v2 = knots (shift (drop_ k (at_list u))) (i - k) n.
  rewrite knots_shift /knots (_ : (i - k).+1 = i.+1 - k)%N; last by lia.
  rewrite /v1 /v2 /knots -map_cat (_ : j.+1 = i.+1 + (j - i))%N; last by lia.
  rewrite -iotaD (_ : (j - i + _)%N = n); last by lia.
  rewrite -{1}[i.+1](subnKC (leqW le_k)) iotaDl -map_comp; exact: eq_map.
rewrite /= size_knots blossoms_knots; [|exact: span_shift|lia].
rewrite /step /drop_ /coord (_ : k + (i - k + n.+1) = i + n.+1)%N; last by lia.
rewrite (_ : k + (i - k) = i)%N; last by lia.
rewrite (_ : k + (i - k).+1 = i.+1)%N; last by lia.
by rewrite mulrC !mul1r.
Qed.

(** BZZ19.5 program: the program gives $\beta_i=\sum_{j\le i}\epsilon_j^2$. *)
Theorem BZZ19_5_program e i : (i < size e)%N -> at_list (steps_program K e) i = \sum_(0 <= j < i.+1) at_list e j ^+ 2.
Proof. by move=> lt_i; rewrite nth_mkseq // totalE. Qed.

Lemma raiseE c : (size c)%:R != 0 :> F -> pbez (size c) (at_list (raise K V c)) = pbez (size c).-1 (at_list c).
Proof.
case: c => [|p c] nz; first by case/eqP: nz.
rewrite [(size (p :: c)).-1]/=; apply/rowP=> k; rewrite !mxE; set d := p :: c.
have e : (size d)%:R%:P * bez (size c) (coord (at_list d) k) = (size d)%:R%:P * bez (size d) (coord (at_list (raise K V d)) k).
  rewrite BZZ19_15_elevation -bez_scale; apply: bez_ext => i le_i; rewrite /coord nth_mkseq // !of_natE /= !mxE /prev.
  by rewrite mulrA mulfV // mul1r.
by apply/esym; apply: mulfI e; rewrite polyC_eq0.
Qed.

Lemma size_raise c : size (raise K V c) = (size c).+1.
Proof. exact: size_mkseq. Qed.

Lemma size_elevation c k : size (elevation_program K V c k) = (size c + k)%N.
Proof. by elim: k => [|k ih]; rewrite ?addn0 // /elevation_program iterS size_raise -/(elevation_program K V c k) ih addnS. Qed.

(** BZZ19.15 program: the program that raises the degree $k$ times gives the points of the same curve.
    Hypotheses: $n+1,\dots,n+k$, for $n+1$ points, are not 0 in the field. *)
Theorem BZZ19_15_program c k : (forall i, (size c <= i < size c + k)%N -> i%:R != 0 :> F) ->
  pbez (size c + k).-1 (at_list (elevation_program K V c k)) = pbez (size c).-1 (at_list c).
Proof.
elim: k => [|k ih] nz; first by rewrite addn0.
rewrite -ih => [|i /andP[le_i lt_i]]; last by apply: nz; rewrite le_i addnS leqW.
have -> : elevation_program K V c k.+1 = raise K V (elevation_program K V c k) by [].
by rewrite addnS [_.+1.-1]/= -(size_elevation c k) raiseE ?size_elevation //; apply: nz; rewrite leq_addr addnS ltnSn.
Qed.
End Equal.
