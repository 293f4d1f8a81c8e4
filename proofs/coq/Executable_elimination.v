(* Programs: linear systems for points, equation by equation: each is freed of the pivots of those before it.
   Definitions (N unknowns):
     equation                   coefficients, the right side, and what combination of the given equations it is
     lower e k a, over e a      e - a k and e / a
     pivot N l                  the last j with l_j not zero, N where there is none
     reduced kept e             e without the pivots of the rows that are kept, each with its pivot, the newest first
     outcome, eliminate         the rows that are kept after all equations, or the first contradiction
     solved kept x              the solution with the unknowns that are no pivots as in x
     kernel N kept f            the solution in scalars without right sides that is 1 at f and 0 at the other unknowns that are no pivots
     module_of Q                the operations of a module
     sat N x e, sats, obeys     x obeys an equation; all with pivots; all of a list
     echelon N kept             the rows are 1 at their pivots and 0 at those of the rows before
     made N M G g e             e is the combination that it says of the M equations with coefficients G and right sides g
     every P s                  P holds for all members *)
From Torse Require Import Prelude Executable Executable_knots.

Record equation T Q := Row {coefficients : seq T; right_side : Q; sources : seq T}.
Inductive outcome T Q := Solved of seq (nat * equation T Q) | Refuted of equation T Q.

Section Programs.
Variables (T Q : Type) (K : scalars T) (V : points T Q) (vanishes : Q -> bool).
Implicit Types (l : seq T) (e k : equation T Q) (kept : seq (nat * equation T Q)) (x : seq Q) (N f : nat) (a : T).
Local Notation "l $ i" := (nth (zero K) l i) (at level 8, i at level 8, format "l $ i").

Definition without l (k : seq T) a := mkseq (fun i => ssub K l$i (smul K a k$i)) (size l).
Definition lower e k a : equation T Q := Row (without (coefficients e) (coefficients k) a) (psub V (right_side e) (pscale V a (right_side k)))
  (without (sources e) (sources k) a).
Definition over e a : equation T Q := let s := sinv K a in Row (map (smul K s) (coefficients e)) (pscale V s (right_side e)) (map (smul K s) (sources e)).
Definition pivot N l := last N (filter (fun j => ~~ same K l$j (zero K)) (iota 0 N)).
Definition reduced kept e := foldr (fun q e => lower e q.2 (coefficients e)$(q.1)) e kept.
Fixpoint eliminate N kept (es : seq (equation T Q)) := if es is e :: es' then
  let e' := reduced kept e in let p := pivot N (coefficients e') in
  if Nat.eqb p N then if vanishes (right_side e') then eliminate N kept es' else Refuted e'
  else eliminate N ((p, over e' (coefficients e')$p) :: kept) es'
  else Solved kept.
Definition solved N kept x := foldl (fun x q => set_nth (origin V) x q.1 (padd V (nth (origin V) x q.1)
  (psub V (right_side q.2) (total_of V (fun j => pscale V (coefficients q.2)$j (nth (origin V) x j)) 0 N)))) x kept.
End Programs.

Definition is_pivot T Q (kept : seq (nat * equation T Q)) j := has (fun k => Nat.eqb k.1 j) kept.
Arguments is_pivot : simpl never.
Definition kernel T Q (K : scalars T) N (kept : seq (nat * equation T Q)) f :=
  solved K (itself K) N [seq (k.1, Row (coefficients k.2) (zero K) [::]) | k <- kept] (mkseq (fun j => if Nat.eqb j f then one K else zero K) N).

Definition module_of (F : fieldType) (Q : lmodType F) : points F Q := @Points F Q 0 +%R (fun x y => x - y) *:%R.

Section Elimination.
Variables (F : fieldType) (lt : F -> F -> bool) (Q : lmodType F) (N : nat).
Implicit Types (l : seq F) (e k : equation F Q) (kept : seq (nat * equation F Q)) (es : seq (equation F Q)) (x y : seq Q) (j p : nat) (a : F).
Local Notation K := (of_field lt).
Local Notation V := (module_of Q).
Local Notation at_list := (nth 0).

Definition sat x e := \sum_(0 <= j < N) (coefficients e)`_j *: at_list x j = right_side e.
Fixpoint sats x kept := if kept is k :: old then sat x k.2 /\ sats x old else True.
Fixpoint obeys x es := if es is e :: es' then sat x e /\ obeys x es' else True.
Fixpoint echelon kept := if kept is k :: old then [/\ (k.1 < N)%N, (coefficients k.2)`_k.1 = 1, size (coefficients k.2) = N,
  forall q, is_pivot old q -> (coefficients k.2)`_q = 0 & echelon old] else True.

Lemma total_ofE_ (f : nat -> Q) (a b : nat) : total_of V f a b = \sum_(a <= i < b) f i.
Proof. by rewrite unlock. Qed.

Lemma nth_without l (k : seq F) a j : (j < size l)%N -> (without K l k a)`_j = l`_j - a * k`_j.
Proof. by move=> lt_j; rewrite /without nth_mkseq. Qed.

Lemma sat_lower x e k a : size (coefficients e) = N -> sat x k -> sat x (lower K V e k a) <-> sat x e.
Proof.
rewrite /sat [right_side (lower _ _ _ _ _)]/= => sz <-; rewrite [coefficients _]/= (eq_big_nat _ _ (F2 := fun j => (coefficients e)`_j *: at_list x j - a *: ((coefficients k)`_j *: at_list x j))).
  by rewrite sumrB -scaler_sumr; split=> [/(addIr _)|->].
by move=> j /andP[_ lt_j]; rewrite nth_without ?sz // scalerBl scalerA.
Qed.

Lemma sat_over x e a : a != 0 -> size (coefficients e) = N -> sat x (over K V e a) <-> sat x e.
Proof.
rewrite /sat [right_side (over _ _ _ _)]/= [coefficients (over _ _ _ _)]/= => a0 sz; rewrite (eq_big_nat _ _ (F2 := fun j => a^-1 *: ((coefficients e)`_j *: at_list x j))).
  by rewrite -scaler_sumr; split=> [/(scalerI _)->|->]; rewrite ?invr_eq0.
by move=> j /andP[_ lt_j]; rewrite (nth_map 0) ?sz // scalerA.
Qed.

Lemma is_pivotP (k : nat * equation F Q) kept q : is_pivot (k :: kept) q = (k.1 == q) || is_pivot kept q.
Proof. by rewrite /is_pivot /= nat_eqbE. Qed.

Lemma reducedP kept e (e' := reduced K V kept e) : echelon kept -> size (coefficients e) = N ->
  [/\ size (coefficients e') = N, forall q, is_pivot kept q -> (coefficients e')`_q = 0 & forall x, sats x kept -> sat x e' <-> sat x e].
Proof.
move=> ech sz; rewrite {}/e'; elim: kept ech => [|k kept ih]; first by split.
case=> lt_p one_p sk zero_k /ih; rewrite [reduced K V (k :: kept) e]/=; set e1 := reduced _ _ _ _ => -[s1 z1 h1]; split=> [|q|x [hk /h1 <-]].
- by rewrite size_mkseq.
- rewrite is_pivotP; case: (ltnP q N) => [lt_q|ge_q]; last by rewrite nth_default // size_mkseq s1.
  rewrite nth_without ?s1 //; case/predU1P=> [<-|piv]; first by rewrite one_p mulr1 subrr.
  by rewrite z1 // zero_k // mulr0 subr0.
exact: sat_lower.
Qed.

Lemma pivotP l (p := pivot K N l) : (p < N)%N && (l`_p != 0) \/ p = N /\ forall j, (j < N)%N -> l`_j = 0.
Proof.
rewrite /p /pivot; set s := filter _ _; have [E|ne] := eqVneq s [::].
  right; rewrite E; split=> // j lt_j; apply/eqP; have : j \notin s by rewrite E.
  by rewrite mem_filter mem_iota /= lt_j andbT negbK.
left; have : last N s \in s by case: (s) ne => //= y r _; exact: mem_last.
by rewrite {2}/s mem_filter mem_iota /= => /andP[-> ->].
Qed.

Definition of_zero e := forall j, (j < N)%N -> (coefficients e)`_j = 0.

Lemma eliminateP (van : Q -> bool) kept es : (forall z : Q, van z = (z == 0)) -> echelon kept -> all (fun e => size (coefficients e) == N) es ->
  match eliminate K V van N kept es with
  | Solved kept' => echelon kept' /\ forall x, sats x kept' <-> sats x kept /\ obeys x es
  | Refuted e => [/\ of_zero e, right_side e != 0 & forall x, sats x kept -> ~ obeys x es]
  end.
Proof.
move=> vanE; elim: es kept => [|e es ih] kept ech /=; first by split=> // x; split=> [|[]].
case/andP=> /eqP sz all_es; have [s1 z1 h1] := reducedP ech sz; set e1 := reduced _ _ _ _ in s1 z1 h1 *.
rewrite nat_eqbE vanE; case: (pivotP (coefficients e1)) => [/andP[lt_p nz]|[-> z]].
  rewrite (ltn_eqF lt_p); set p := pivot _ _ _ in lt_p nz *; set k := (p, _).
  have ech1 : echelon (k :: kept).
    split=> //=; first by rewrite (nth_map 0) ?s1 //= mulVf.
      by rewrite size_map.
    move=> q piv; case: (ltnP q N) => [lt_q|ge_q]; last by rewrite nth_default // size_map s1.
    by rewrite (nth_map 0) ?s1 // z1 // mulr0.
  have eq_sats x : sats x (k :: kept) <-> sats x kept /\ sat x e.
    have so : sat x k.2 <-> sat x e1 by apply: sat_over.
    by split=> [[/so h hk]|[hk h]]; split=> //; [exact/(h1 _ hk) | exact/so/(h1 _ hk)].
  have := ih _ ech1 all_es; case: (eliminate _ _ _ _ _ _) => [kept'|e'].
    by case=> ech' h; split=> // x; split=> [/h[/eq_sats[hk he] hes]|[hk [he hes]]] //; apply/h; split=> //; apply/eq_sats.
  by case=> z' n' h; split=> // x hk [he]; apply: h; apply/eq_sats.
rewrite eqxx; have sat0 x : sat x e1 <-> right_side e1 = 0.
  rewrite /sat big1_seq => [|j]; first by split=> ->.
  by rewrite mem_index_iota => /andP[_ /andP[_ lt_j]]; rewrite z // scale0r.
case: eqP => [r0|/eqP r0].
  have := ih _ ech all_es; case: (eliminate _ _ _ _ _ _) => [kept'|e'].
    case=> ech' h; split=> // x; rewrite h; split=> [[hk hes]|[hk [_ hes]]] //; split=> //; split=> //; exact/h1/sat0.
  by case=> z' n' h; split=> // x hk [_]; exact: h.
by split=> // x hk [/(h1 _ hk)/sat0 e0 _]; rewrite e0 eqxx in r0.
Qed.

Lemma solvedP kept x (y := solved K V N kept x) : echelon kept -> size x = N ->
  [/\ size y = N, sats y kept & forall j, ~~ is_pivot kept j -> at_list y j = at_list x j].
Proof.
rewrite {}/y; elim: kept x => [|[p k] kept ih] x ech sx; first by split.
case: ech => /= lt_p one_p sk zero_k ech; set v := _ + _; have sx' : size (set_nth 0 x p v) = N by rewrite size_set_nth sx; apply/maxn_idPr.
have [sy hy ey] := ih _ ech sx'; split=> // [|j]; last first.
  by rewrite is_pivotP negb_or /= eq_sym => /andP[/negPf ne /ey ->]; rewrite nth_set_nth /= ne.
split=> //; rewrite /sat; have e j : (coefficients k)`_j *: at_list (solved K V N kept (set_nth 0 x p v)) j
    = (coefficients k)`_j *: at_list x j + (if j == p then v - at_list x p else 0).
  have [-> |ne] := eqVneq j p.
    case: (boolP (is_pivot kept p)) => [/zero_k z|/ey ->]; first by move: one_p; rewrite z => /esym/eqP; rewrite oner_eq0.
    by rewrite nth_set_nth /= eqxx one_p !scale1r addrC subrK.
  case: (boolP (is_pivot kept j)) => [/zero_k ->|/ey ->]; first by rewrite !scale0r addr0.
  by rewrite nth_set_nth /= (negPf ne) addr0.
have only (w : Q) : \sum_(0 <= j < N) (if j == p then w else 0) = w.
  by rewrite big_mkord (bigD1 (Ordinal lt_p)) //= eqxx big1 ?addr0 // => i; rewrite -val_eqE /= => /negPf ->.
under eq_bigr do rewrite e; rewrite big_split /= only.
by rewrite /v total_ofE_ /= [X in _ + X]addrC addKr addrC subrK.
Qed.

Lemma sats_unique kept x y : echelon kept -> sats x kept -> sats y kept ->
  (forall j, (j < N)%N -> ~~ is_pivot kept j -> at_list x j = at_list y j) -> forall j, (j < N)%N -> at_list x j = at_list y j.
Proof.
elim: kept => [_ _ _ h j lt_j|[p k] kept ih]; first exact: h.
case=> /= lt_p one_p sk zero_k ech [hx hxs] [hy hys] h; apply: ih => // j lt_j np.
have [->|ne] := eqVneq j p; last by apply: h; rewrite // is_pivotP negb_or np eq_sym ne.
have : \sum_(0 <= j < N) ((coefficients k)`_j *: at_list x j - (coefficients k)`_j *: at_list y j) = 0.
  by rewrite sumrB; move: hx hy; rewrite /sat => -> ->; rewrite subrr.
rewrite big_mkord (bigD1 (Ordinal lt_p)) //= one_p !scale1r big1 => [|i ne_i]; first by rewrite addr0 => /eqP; rewrite subr_eq0 => /eqP.
case: (boolP (is_pivot kept i)) => [/zero_k ->|npi]; first by rewrite !scale0r subrr.
rewrite h ?subrr // is_pivotP negb_or npi andbT /= eq_sym; exact: ne_i.
Qed.

(* Equations stay the combinations of the given ones that they say. *)
Section Sources.
Variables (M : nat) (G : nat -> nat -> F) (g : nat -> Q).

Definition made e := [/\ size (coefficients e) = N, size (sources e) = M,
  forall j, (j < N)%N -> (coefficients e)`_j = \sum_(0 <= i < M) (sources e)`_i * G i j &
  right_side e = \sum_(0 <= i < M) (sources e)`_i *: g i].
Fixpoint every A (P : A -> Prop) s := if s is z :: s' then P z /\ every P s' else True.

Lemma made_lower e k a : made e -> made k -> made (lower K V e k a).
Proof.
case=> ze se ce re [zk sk ck rk]; split=> [||j lt_j|]; rewrite ?size_mkseq //=.
  rewrite nth_without ?ze // ce // ck // mulr_sumr -sumrB; apply: eq_big_nat => i /andP[_ lt_i].
  by rewrite nth_without ?se // mulrBl mulrA.
rewrite re rk scaler_sumr -sumrB; apply: eq_big_nat => i /andP[_ lt_i].
by rewrite nth_without ?se // scalerBl scalerA.
Qed.

Lemma made_over e a : made e -> made (over K V e a).
Proof.
case=> ze se ce re; split=> [||j lt_j|]; rewrite ?size_map //=.
  rewrite (nth_map 0) ?ze // ce // mulr_sumr; apply: eq_big_nat => i /andP[_ lt_i].
  by rewrite (nth_map 0) ?se //= mulrA.
rewrite re scaler_sumr; apply: eq_big_nat => i /andP[_ lt_i].
by rewrite (nth_map 0) ?se //= scalerA.
Qed.

Lemma eliminate_made (van : Q -> bool) kept es : every (fun q : nat * equation F Q => made q.2) kept -> every made es ->
  if eliminate K V van N kept es is Refuted e then made e else True.
Proof.
elim: es kept => // e es ih kept mk [me mes]; rewrite [eliminate _ _ _ _ _ _]/=.
have m1 : made (reduced K V kept e) by elim: kept mk => //= q kept IH [mq /IH]; move/made_lower; exact.
case: ifP => _; last by apply: ih => //; split=> //; exact: made_over.
by case: ifP => _; [exact: ih | ].
Qed.
End Sources.
End Elimination.
Arguments eliminate : simpl never.
