(* Programs: pieces of a spline as polynomials of its parameter, and polynomials over an interval in Bernstein form, BZZ19.14.
   Definitions (a list f of coefficients stands for f_0 + f_1 X + ...):
     line_times f a b           (a + b X) f
     after_line f a b           f(a + b X)
     bernstein_program f n a b  the n + 1 Bernstein coefficients of f(a + (b-a) X)
     step_polynomial u m c i    a step of de Boor's algorithm at X, on lists of coefficients
     deboor_polynomial u c n    n steps
     polynomial_program n u c k the coefficients of piece k = 1, 2, ... of the spline with the coefficients c *)
From Torse Require Import Prelude Blossom Curves Bernstein Bezier FJ21_4 BZZ19_4 BZZ19_4_pieces Executable Executable_knots Executable_composition.

Section Programs.
Variables (T : Type) (K : scalars T).
Implicit Types (u f g : seq T) (c : seq (seq T)) (n m k i : nat) (a b : T).
Local Notation "x + y" := (sadd K x y).
Local Notation "x - y" := (ssub K x y).
Local Notation "x * y" := (smul K x y).
Local Notation "x / y" := (smul K x (sinv K y)).
Local Notation "f $ i" := (nth (zero K) f i) (at level 8, i at level 8, format "f $ i").

Definition line_times f a b := mkseq (fun i => if i is j.+1 then a * f$i + b * f$j else a * f$0) (size f).+1.
Definition after_line f a b := foldr (fun x r => if line_times r a b is y :: s then y + x :: s else [::]) [::] f.
Definition bernstein_program f n a b := let g := after_line f a (b - a) in
  given (all (fun x => same K x (zero K)) (drop n.+1 g)) Division (Value (let of_n := pascal K n in
    mkseq (fun i => let of_i := pascal K i in total K (fun j => of_i$j / of_n$j * g$j) 0 n.+1) n.+1)).

Definition step_polynomial u m c i := let hi := u$(i + m) in let lo := u$i in let p := nth [::] c i in let q := nth [::] c i.+1 in
  mkseq (fun j => (hi * p$j - lo * q$j + (if j is h.+1 then q$h - p$h else zero K)) / (hi - lo)) (size p).+1.
Fixpoint deboor_polynomial u c n := if n is n'.+1 then deboor_polynomial (behead u) (mkseq (step_polynomial u n c) n) n' else nth [::] c 0.
Definition polynomial_program n u f k := knot_list K n u (fits n u f (given (carries K n (drop k.-1 u)) Division
  (Value (deboor_polynomial (drop k.-1 u) (mkseq (fun i => [:: nth (zero K) f (k.-1 + i)%N]) n.+1) n)))).
End Programs.

Section Equal.
Variables (F : fieldType) (lt : F -> F -> bool).
Implicit Types (u f g : seq F) (c : seq (seq F)) (n m k i : nat) (a b : F).
Local Notation K := (of_field lt).
Local Notation at_list := (nth 0).

Lemma line_timesE f a b : Poly (line_times K f a b) = (a%:P + b%:P * 'X) * Poly f.
Proof.
apply/polyP=> i; rewrite mulrDl coefD -mulrA !coefCM coefXM; have [lt_i|ge_i] := ltnP i (size f).+1.
  by rewrite [LHS]coef_Poly nth_mkseq //; case: i lt_i => [|i] _; rewrite /= ?mulr0 ?addr0 !coef_Poly.
rewrite [LHS]coef_Poly [LHS]nth_default ?size_mkseq //; case: i ge_i => // i ge_i.
by rewrite /= !coef_Poly !nth_default ?mulr0 ?addr0 // ltnW.
Qed.

Lemma after_lineE f a b : Poly (after_line K f a b) = Poly f \Po (a%:P + b%:P * 'X) /\ size (after_line K f a b) = size f.
Proof.
elim: f => [|x f [ih sz]]; first by rewrite comp_poly0.
have -> : after_line K (x :: f) a b = if line_times K (after_line K f a b) a b is y :: s then y + x :: s else [::] by [].
have := line_timesE (after_line K f a b) a b; have : size (line_times K (after_line K f a b) a b) = (size f).+1 by rewrite size_mkseq sz.
case: (line_times _ _ _ _) => // y s /= -> e; split=> //.
rewrite !cons_poly_def in e *; rewrite comp_polyD comp_polyM comp_polyX comp_polyC -ih [in RHS]mulrC -e.
by rewrite polyCD !addrA.
Qed.

(** BZZ19.14 program: the program gives the Bernstein coefficients of degree $D$ of $f(a+(b-a)t)$, by $\sum_k\frac{C(i,k)}{C(D,k)}a_k$; it gives an error iff
    the degree of that polynomial is greater.
    Hypotheses: for the coefficients: no $C(D,k)$ vanishes in the field, as in characteristic 0. *)
Theorem BZZ19_14_program f n a b (p := Poly f \Po line a b) :
  (forall r, independent F n -> bernstein_program K f n a b = Value r -> size r = n.+1 /\ bez n (at_list r) = p) /\
  (bernstein_program K f n a b = Fails _ Division <-> (n.+1 < size p)%N).
Proof.
rewrite /bernstein_program /given; have [] := @after_lineE f a (b - a).
set g := after_line _ _ _ _ => eg sg.
have -> : all (fun x => same K x (zero K)) (drop n.+1 g) = (size p <= n.+1)%N.
  apply/allP/leq_sizeP => [h i le_i|h x /(nthP 0)[i lt_i <-]].
    rewrite /p -eg coef_Poly -(subnKC le_i) -nth_drop; have [lt_j|ge_j] := ltnP (i - n.+1) (size (drop n.+1 g)).
      by apply/eqP; apply: h; exact: mem_nth.
    by rewrite nth_default.
  by rewrite nth_drop; have := h _ (leq_addr i n.+1); rewrite /p -eg coef_Poly => /eqP.
case: leqP => le_p; split=> // r ind e.
rewrite -(Value_inj e) size_mkseq; split=> //; rewrite [RHS](BZZ19_14_bernstein ind le_p).
apply: bez_ext => i le_i; rewrite nth_mkseq // totalE; apply: eq_big_nat => j _.
by rewrite !pascalE /p -eg coef_Poly.
Qed.

Lemma deboor_polynomialE u c n : (forall i, (i <= n)%N -> size (nth [::] c i) = size (nth [::] c 0)) ->
  Poly (deboor_polynomial K u c n) = blossom (polys (at_list u)) (fun i => Poly (nth [::] c i)) (nseq n (at_ 'X)).
Proof.
elim: n u c => [|n ih] u c sz //.
rewrite [deboor_polynomial _ _ _ _]/= ih => [|i le_i]; last by rewrite !nth_mkseq // ?size_mkseq sz // ltnW.
rewrite [RHS]/= size_nseq (@blossom_ext_knots _ _ (shift (polys (at_list u)))) => [|i _]; last by rewrite /polys nth_behead.
apply: blossom_ext => i; rewrite size_nseq => le_i; rewrite nth_mkseq // /step /polys.
rewrite mul1r -polyCB; move: (sz i (leqW le_i)) (sz i.+1 le_i); rewrite /step_polynomial.
move: (at_list u (i + n.+1)) (at_list u i) (nth [::] c i) (nth [::] c i.+1) (nth [::] c 0) => hi lo p q r sp sq.
have {sq} spq : size q = size p by rewrite sp sq.
have -> (x : {poly F}) : x / (hi - lo)%:P = (hi - lo)^-1%:P * x by rewrite mulrC polyCV.
apply/polyP=> j; rewrite coefCM mulrC !mul1r mulrBl mulrBl coefD !coefB !coefCM !coefXM [LHS]coef_Poly.
have [lt_j|ge_j] := ltnP j (size p).+1.
  rewrite nth_mkseq //; case: j lt_j => [|j] _ /=; rewrite !coef_Poly ?subr0; congr (_ / _); first by rewrite addr0 add0r.
  by move: (at_list p j.+1) (at_list q j.+1) (at_list p j) (at_list q j) => *; ring.
rewrite nth_default ?size_mkseq //; case: j ge_j => // j ge_j.
by rewrite /= !coef_Poly !nth_default ?spq // 1?ltnW //; rewrite !(mulr0, subr0, addr0, mul0r).
Qed.

(** blossoms polynomial: the program gives the coefficients of the polynomial of piece $k$; it gives a value iff the list is one of knots, there are as many
    coefficients as it asks for and the knots carry the piece. *)
Theorem blossoms_polynomial n u f k : 
  (forall r, polynomial_program K n u f k.+1 = Value r -> Poly r = curve n (drop_ k (at_list u)) (drop_ k (at_list f))) /\
  ((exists r, polynomial_program K n u f k.+1 = Value r) <->
    [/\ valid lt n u, size f = (size u - n).+1 & span n (drop_ k (at_list u))]).
Proof.
have spE : span n (at_list (drop k u)) <-> span n (drop_ k (at_list u)).
  by split=> sp i j lt_i le_j; have := sp i j lt_i le_j; rewrite !nth_drop.
split=> [r|].
  case/knot_listP=> hv /fitsP[hs]; rewrite /given; case: carriesP => // sp e; rewrite -(Value_inj e).
  rewrite deboor_polynomialE => [|i le_i]; last by rewrite !nth_mkseq.
  rewrite (@blossom_ext_knots _ _ (polys (drop_ k (at_list u)))) => [|i _]; last by rewrite /polys nth_drop.
  by apply: blossom_ext => i; rewrite size_nseq => le_i; rewrite nth_mkseq //= /polys cons_poly_def mul0r add0r.
rewrite /polynomial_program; split=> [[r /knot_listP[hv /fitsP[hs]]]|[hv hs /spE/carriesP ok]].
  by rewrite /given; case: carriesP => // /spE sp _.
by eexists; apply/knot_listP; split=> //; apply/fitsP; split=> //; rewrite ok.
Qed.
End Equal.
