(* Programs: the rulings of a directrix c for a' = a tau + b tau', ZW06: the linear system, the edge of regression and the vertex of a cone.
   Definitions (a, b lists of Bernstein coefficients, c and tau points):
     powers e             the coefficients of 1, X, X^2, ... of the polynomial with the Bernstein coefficients e
     slopes f, plus_ f g, minus_ f g   f', f + g, f - g for lists of such coefficients
     is_cone a b          a = b'
     indicator n i        the list with 1 at the place i and 0 at the other n
     column_of a b n i    a B_i + b B_i', from powers to powers
     in_degree D f        the Bernstein coefficients of degree D
     degree_of n a b      n + max(deg a, deg b - 1)
     sides D c            the Bezier points of a' in degree D
     equations c a b      the linear system for the points of tau
     rulings, directrix_program c a b   what there is: none, with the combination of the equations and what it gives; one; a family
     times_rows b c       the Bezier points of b(u) c(u)
     edge_of c tau b      those of c - b tau, 8
     vertex_of_cone c tau a b   c(0) - b(0) tau(0), 11
     equation_program n rho s   a and b of 19
     bernstein e          the polynomial with the Bernstein coefficients e
     left_of, right_of    G and g of the system *)
From Torse Require Import Prelude Blossom Curves Points Bernstein Bezier FJ21_4 BZZ19_4 BZZ19_4_written ZW06 ZW06_cases ZW06_system ZW06_unique Executable Executable_knots
  Executable_ZW06 Executable_splines Executable_composition Executable_polynomials Executable_elimination.

Inductive rulings T Q := Contradiction of seq T & Q | Only of seq Q | Family of seq Q & seq T.

Section Programs.
Variables (T Q : Type) (K : scalars T) (V : points T Q) (vanishes : Q -> bool).
Implicit Types (a b e f g : seq T) (c tau : seq Q) (D n k i j : nat) (rho s : T).
Local Notation "x + y" := (sadd K x y).
Local Notation "x - y" := (ssub K x y).
Local Notation "x * y" := (smul K x y).
Local Notation "x / y" := (smul K x (sinv K y)).
Local Notation "f $ i" := (nth (zero K) f i) (at level 8, i at level 8, format "f $ i").

Definition powers e := let d := (size e).-1 in
  deboor_polynomial K (nseq d (zero K) ++ nseq d (one K)) (mkseq (fun i => [:: e$i]) d.+1) d.
Definition slopes f := mkseq (fun i => of_nat K i.+1 * f$(i.+1)) (size f).-1.
Definition plus_ f g := mkseq (fun i => f$i + g$i) (addn (size f) (size g)).
Definition minus_ f g := mkseq (fun i => f$i - g$i) (addn (size f) (size g)).
Definition all_zero f := all (fun x => same K x (zero K)) f.
Definition is_cone a b := all_zero (minus_ (powers a) (slopes (powers b))).

Definition indicator n i := mkseq (fun j => if Nat.eqb j i then one K else zero K) n.+1.
Definition column_of a b n i := let e := powers (indicator n i) in plus_ (form_times K a e) (form_times K b (slopes e)).
Definition in_degree D f := let w := pascal K D in mkseq (fun j => let r := pascal K j in total K (fun k => r$k / w$k * f$k) 0 D.+1) D.+1.
Definition degree_of n a b := let k := (size a).-1 in let l := (size b).-2 in addn n (if Nat.leb k l then l else k).
Definition sides D c := let n := (size c).-1 in elevation_program K V (mkseq (fun i =>
  padd V (pscale V (of_nat K (n - i)) (forward V c i)) (pscale V (of_nat K i) (backward V c i))) (size c)) (D - n).
Definition equations c a b := let n := (size c).-1 in let D := degree_of n a b in let pa := powers a in let pb := powers b in
  let columns := mkseq (fun i => in_degree D (column_of pa pb n i)) (size c) in let r := sides D c in
  mkseq (fun j => Row [seq col$j | col <- columns] (nth (origin V) r j) (indicator D j)) D.+1.
Definition directrix_program c a b := given (Nat.leb 2 (size c)) Directrix (given (~~ (all_zero a && all_zero b)) Equation (Value (
  let N := size c in match eliminate K V vanishes N [::] (equations c a b) with
  | Refuted e => Contradiction (sources e) (right_side e)
  | Solved kept => let tau := solved K V N kept (nseq N (origin V)) in
    let free := last N (filter (fun j => ~~ is_pivot kept j) (iota 0 N)) in
    if Nat.eqb free N then Only T tau else Family tau (kernel K N kept free)
  end))).

Definition times_rows b c := let n := (size c).-1 in let d := (size b).-1 in let w := pascal K n in let f := form_of K b in let v := pascal K (addn n d) in
  mkseq (fun k => pscale V (sinv K v$k) (total_of V (fun i => pscale V (f$i * w$(k - i)%N) (nth (origin V) c (k - i))) 0 k.+1)) (addn n d).+1.
Definition edge_of c tau b := let e := elevation_program K V c (size b).-1 in let r := times_rows b tau in
  mkseq (fun k => psub V (nth (origin V) e k) (nth (origin V) r k)) (size e).
Definition vertex_of_cone c tau a b := given (is_cone a b) Equation
  (Value (psub V (nth (origin V) c 0) (pscale V b$0 (nth (origin V) tau 0)))).
Definition equation_program n rho s := given (~~ same K rho (one K)) Rho
  (let r := rho - one K in Value ([:: of_nat K n * (one K - s) / r], [:: one K / r; s / r])).
End Programs.

Section Polynomials.
Variables (F : fieldType) (lt : F -> F -> bool).
Implicit Types (a b e f g : seq F) (D n k i j : nat) (rho s : F).
Local Notation K := (of_field lt).
Local Notation at_list := (nth 0).
Definition bernstein e := bez (size e).-1 (at_list e).

Lemma powersE e : Poly (powers K e) = bernstein e.
Proof.
rewrite /powers /bernstein; set d := (size e).-1; rewrite deboor_polynomialE => [|i le_i]; last by rewrite !nth_mkseq.
rewrite -bezier_curve /curve (@blossom_ext_knots _ _ (polys (step01 F d))); last first.
  move=> i; rewrite size_nseq => lt_i; rewrite /polys /step01 nth_cat size_nseq !nth_nseq; case: ltnP => // le_d; rewrite ifT //; lia.
by apply: blossom_ext => i; rewrite size_nseq => le_i; rewrite /polys nth_mkseq //= cons_poly_def mul0r add0r.
Qed.

Lemma slopesE f : Poly (slopes K f) = (Poly f)^`().
Proof.
rewrite /slopes; apply/polyP=> i; rewrite coef_deriv !coef_Poly; have [lt_i|ge_i] := ltnP i (size f).-1.
  by rewrite nth_mkseq // of_natE /= mulr_natl.
by rewrite nth_default ?size_mkseq // nth_default ?mul0rn // -add1n -leq_subLR subn1.
Qed.

Lemma plusE f g : Poly (plus_ K f g) = Poly f + Poly g.
Proof.
rewrite /plus_; apply/polyP=> i; rewrite coefD !coef_Poly; have [lt_i|ge_i] := ltnP i (size f + size g); first by rewrite nth_mkseq.
by rewrite !nth_default ?addr0 ?size_mkseq // (leq_trans _ ge_i) ?leq_addr ?leq_addl.
Qed.

Lemma minusE f g : Poly (minus_ K f g) = Poly f - Poly g.
Proof.
rewrite /minus_; apply/polyP=> i; rewrite coefB !coef_Poly; have [lt_i|ge_i] := ltnP i (size f + size g); first by rewrite nth_mkseq.
by rewrite !nth_default ?subr0 ?size_mkseq // (leq_trans _ ge_i) ?leq_addr ?leq_addl.
Qed.

Lemma timesE f g : Poly (form_times K f g) = Poly f * Poly g.
Proof.
rewrite /form_times; apply/polyP=> k; rewrite coefM coef_Poly; have [lt_k|ge_k] := ltnP k (size f + size g).-1.
  by rewrite nth_mkseq // totalE big_mkord; apply: eq_bigr => j _; rewrite /= !coef_Poly.
rewrite nth_default ?size_mkseq // big1 // => j _; rewrite !coef_Poly; have [lt_j|ge_j] := ltnP j (size f); last by rewrite nth_default ?mul0r.
rewrite [X in _ * X]nth_default ?mulr0 //; move: ge_k (ltn_ord j) lt_j; move: (size f) (size g) (j : nat) => *; lia.
Qed.

Lemma all_zeroE f : all_zero K f = (Poly f == 0).
Proof.
apply/allP/eqP=> [h|e x /(nthP 0)[i _ <-]]; last by rewrite /= -coef_Poly e coef0 eqxx.
apply/polyP=> i; rewrite coef0 coef_Poly; have [lt_i|ge_i] := ltnP i (size f); last by rewrite nth_default.
by apply/eqP; apply: h; exact: mem_nth.
Qed.

(** ZW06.9 program: the program decides whether $a=b'$, where $a_1=a(u)-b\tau$ is a point. *)
Theorem ZW06_9_program a b : is_cone K a b <-> bernstein a = (bernstein b)^`().
Proof. by rewrite /is_cone all_zeroE minusE slopesE !powersE subr_eq0; split=> /eqP. Qed.

Lemma in_degreeE D f j : (j <= D)%N -> at_list (in_degree K D f) j = in_bernstein D (Poly f) j.
Proof.
by move=> le_j; rewrite /in_degree nth_mkseq // totalE; apply: eq_bigr => k _; rewrite !pascalE coef_Poly.
Qed.

Lemma column_ofE a b n i : (i <= n)%N -> Poly (column_of K a b n i) = column n (Poly a) (Poly b) i.
Proof.
move=> le_i; rewrite plusE !timesE slopesE powersE /bernstein size_mkseq [_.+1.-1]/= /column B_bez //.
by have -> : bez n (at_list (indicator K n i)) = bez n (fun j => (j == i)%:R) by apply: bez_ext => j le_j; rewrite nth_mkseq // nat_eqbE; case: eqP.
Qed.

(** ZW06.19 program: the program gives $a=\frac{n(1-s)}{\rho-1}$ and $b=\frac{1-u+su}{\rho-1}$ as polynomials, and an error iff $\rho=1$. *)
Theorem ZW06_19_program n rho s :
  (forall a b, equation_program K n rho s = Value (a, b) -> (rho - 1) *: bernstein a = (n%:R * (1 - s))%:P /\
    (rho - 1) *: bernstein b = 1 - 'X + s *: 'X) /\
  (equation_program K n rho s = Fails _ Rho <-> rho = 1).
Proof.
rewrite /equation_program /given /=; case: eqVneq => [->|r1]; split=> //=; last by split=> // e; rewrite e eqxx in r1.
have r0 : rho - 1 != 0 by rewrite subr_eq0.
have one x : bernstein [:: x] = x%:P by rewrite /bernstein /bez /= big_nat1 /B subnn !expr0 !mulr1.
have two x y : bernstein [:: x; y] = x%:P * (1 - 'X) + y%:P * 'X.
  by rewrite /bernstein /bez /= big_nat_recl // big_nat1 /B bin0 binn subn0 subnn !expr0 !expr1 !mul1r mulr1.
move=> a b [<- <-]; rewrite one two of_natE -!mul_polyC -polyCM mulrCA mulfV // mulr1; split=> //.
by rewrite mulrDr !mulrA -!polyCM mul1r mulfV // mulrCA mulfV // mulr1 polyC1 mul1r.
Qed.
End Polynomials.

Section Curves.
Variables (F : fieldType) (m : nat) (lt : F -> F -> bool).
Implicit Types (a b : seq F) (c tau x : seq 'rV[F]_m) (D n k i j : nat) (v : 'rV[F]_m).
Local Notation K := (of_field lt).
Local Notation V := (rows F m).
Local Notation at_list := (nth 0).
Local Notation curve_of c := (pbez (size c).-1 (at_list c)).

Lemma times_rowsE b c : independent F ((size c).-1 + (size b).-1) -> (0 < size c)%N ->
  pbez ((size c).-1 + (size b).-1) (at_list (times_rows K V b c)) = bernstein b *: curve_of c.
Proof.
move=> ind c0; apply/rowP=> k; have [b0|b0] := posnP (size b).
  rewrite (size0nil b0) /bernstein !mxE [X in _ = X * _]/bez big_nat1 polyC0 !mul0r /bez big1_seq // => j; rewrite mem_index_iota => lt_j.
  by rewrite /coord nth_mkseq // total_ofE big1 ?mxE ?mulr0 ?polyC0 ?mul0r // => i _; rewrite [nth _ (form_of _ _) _]nth_nil /= mul0r scale0r.
 rewrite !mxE; set n := (size c).-1 in ind *; set d := (size b).-1 in ind *.
have [ck [sk eck]] : exists ck : seq F, size ck = size c /\ forall i, at_list ck i = at_list c i 0 k.
  exists [seq (p : 'rV_m) 0 k | p <- c]; rewrite size_map; split=> // i; have [lt_i|ge_i] := ltnP i (size c); first by rewrite (nth_map 0).
  by rewrite !nth_default ?size_map // mxE.
have -> : bez n (coord (at_list c) k) = form (form_of K ck).
  by rewrite form_ofE sk //; apply: bez_ext => i _; rewrite eck.
have [sb sc] : size (form_of K b) = d.+1 /\ size (form_of K ck) = n.+1 by rewrite !size_mkseq sk !prednK.
rewrite /bernstein -(form_ofE lt b0); have [|| st <-] := @form_timesE F lt (form_of K b) (form_of K ck); rewrite ?sb ?sc //.
apply/esym/form_bez; first by rewrite st sb sc addSn addnS addnC.
move=> i le_i; rewrite nth_mkseq; last by rewrite sb sc addSn addnS addnC.
rewrite totalE /coord nth_mkseq // total_ofE mxE pascalE summxE mulrAC mulVf ?ind // mul1r; apply: eq_bigr => j _.
rewrite mxE pascalE -mulrA; congr (_ * _); rewrite mulrC; have [lt_i|ge_i] := ltnP (i - j) (size c).
  by rewrite nth_mkseq ?sk //= pascalE eck.
by rewrite [LHS]nth_default ?size_mkseq ?sk // nth_default // mxE mul0r.
Qed.

(** ZW06.8 program: the program gives the Bezier points of $a_1=a(u)-b\tau$, where the surface for $a'=a\tau+b\tau'$ has its singular points.
    Hypotheses: $n+1,\dots,D$ and the $C(D,j)$, $D=n+\deg b$, by which the program divides, are not 0 in the field, as in characteristic 0; $a(u)$ and $\tau$ have
    the same number of points. *)
Theorem ZW06_8_program c tau b : (forall i, (size c <= i < size c + (size b).-1)%N -> i%:R != 0 :> F) ->
  independent F ((size c).-1 + (size b).-1) -> size tau = size c ->
  pbez ((size c).-1 + (size b).-1) (at_list (edge_of K V c tau b)) = curve_of c - bernstein b *: curve_of tau.
Proof.
move=> nz ind st; have := @BZZ19_15_program _ _ lt _ _ nz; have [c0|c0] := posnP (size c).
  have d0 : (size b).-1 = 0%N by apply/eqP; rewrite -leqn0 leqNgt; apply/negP=> d0; have := nz 0%N; rewrite c0 d0 eqxx => /(_ isT).
  have t0 : size tau = 0%N by rewrite st.
  move=> _; rewrite /edge_of c0 d0 (size0nil c0) (size0nil t0) /=; apply/rowP=> k; rewrite !mxE /bez !big_nat1 /coord nth_nil mxE polyC0 !mul0r mulr0 subr0 //.
rewrite -!subn1 -addnBAC // !subn1 => <-; rewrite -times_rowsE ?st //.
apply/rowP=> k; rewrite !mxE -bez_sub; apply: bez_ext => i le_i; rewrite /coord nth_mkseq ?mxE // size_elevation.
by rewrite -(prednK c0) addSn ltnS.
Qed.

(** ZW06.11 program: the program gives the vertex $e$ of the cone: $a(u)+v\tau(u)=e+(v+b(u))\tau(u)$ where $a'=a\tau+b\tau'$; it gives an error iff $a\ne b'$.
    Hypotheses: for the vertex: characteristic 0 or greater than the degrees of $a(u)$ and $b\tau$. *)
Theorem ZW06_11_program c tau a b :
  (forall e, (forall i, (0 < i <= maxn (size c).-1 ((size b).-1 + (size tau).-1))%N -> i%:R != 0 :> F) ->
    vertex_of_cone K V c tau a b = Value e -> pderiv (curve_of c) = bernstein a *: curve_of tau + bernstein b *: pderiv (curve_of tau) ->
    forall u v : F, ev (curve_of c) u + v *: ev (curve_of tau) u = e + (v + (bernstein b).[u]) *: ev (curve_of tau) u) /\
  (vertex_of_cone K V c tau a b = Fails _ Equation <-> bernstein a <> (bernstein b)^`()).
Proof.
rewrite /vertex_of_cone /given; have := ZW06_9_program lt a b; case: is_cone => -[ab ba]; split=> //; last first.
- by split=> // _ /ba.
- by split=> // /(_ (ab isT)).
move=> e nz ee eq u v; rewrite -(Value_inj ee); pose r := curve_of c - bernstein b *: curve_of tau.
have const (k : 'I_m) : r 0 k = ((r 0 k)`_0)%:P.
  apply: constant_poly => [i lt_i|]; last first.
    have := congr1 (fun z : 'rV__ => z 0 k) eq; rewrite !mxE derivB derivM => ->; rewrite (ab isT); ring.
  apply: nz; rewrite /= -ltnS; apply: leq_trans lt_i _; rewrite !mxE (leq_trans (size_add _ _)) // size_opp geq_max -maxnSS !leq_max size_bez /=.
  apply/orP; right; apply: leq_trans (size_mul_leq _ _) _; have := size_bez (size b).-1 (at_list b); have := size_bez (size tau).-1 (coord (at_list tau) k).
  by rewrite -/(bernstein b); move: (size (bernstein b)) (size (bez _ _)) => x y; clear; lia.
have -> : psub V (at_list c 0) (pscale V (at_list b 0) (at_list tau 0)) = ev r 0.
  by apply/rowP=> k; rewrite !mxE hornerD hornerN hornerM !(bez_ends _ _).1.
have -> : ev r 0 = ev r u by apply/rowP=> k; rewrite !mxE; have := const k; rewrite !mxE => ->; rewrite !hornerC.
have -> : ev r u = ev (curve_of c) u - (bernstein b).[u] *: ev (curve_of tau) u by apply/rowP=> k; rewrite !mxE hornerD hornerN hornerM.
by rewrite scalerDl addrACA addNr addr0.
Qed.

Lemma obeysP N (x : seq 'rV[F]_m) es d : obeys N x es <-> forall j, (j < size es)%N -> sat N x (nth d es j).
Proof.
elim: es => [|e es ih]; first by split.
split=> [[h hs] [|j] //= lt_j|h]; first exact: (iffLR ih).
by split; [exact: (h 0%N) | apply/ih => j lt_j; exact: (h j.+1)].
Qed.

Lemma every_nth (A : Type) (P : A -> Prop) s d : (forall j, (j < size s)%N -> P (nth d s j)) -> every P s.
Proof. by elim: s => //= y s ih h; split; [exact: (h 0%N) | apply: ih => j; exact: (h j.+1)]. Qed.

Lemma last_filterP (P : pred nat) N (f := last N (filter P (iota 0 N))) : (f < N)%N && P f \/ f = N /\ forall j, (j < N)%N -> ~~ P j.
Proof.
rewrite /f; set s := filter _ _; have [E|ne] := eqVneq s [::].
  right; rewrite E; split=> // j lt_j; apply/negP=> Pj; have : j \in s by rewrite mem_filter Pj mem_iota.
  by rewrite E.
left; have : last N s \in s by case: (s) ne => //= y r _; exact: mem_last.
by rewrite {2}/s mem_filter mem_iota /= => /andP[-> ->].
Qed.

(* The equations of the program, G and g. *)
Definition left_of a b n D j i : F := in_bernstein D (column n (bernstein a) (bernstein b) i) j.
Definition right_of c D j : 'rV[F]_m := \row_k in_bernstein D (pderiv (curve_of c) 0 k) j.

Lemma degree_of_bounds n a b (D := degree_of n a b) : (1 < n.+1)%N -> [/\ (n <= D)%N, ((size a).-1 <= D - n)%N & ((size b).-1 <= (D - n).+1)%N].
Proof.
rewrite /D /degree_of nat_lebE => n0; rewrite !addKn; split; first exact: leq_addr.
  by move: (size a) (size b) => k l; case: ifP; lia.
by move: (size a) (size b) => k l; case: ifP; lia.
Qed.

Lemma size_bernstein (e : seq F) : (size (bernstein e) <= (size e).-1.+1)%N.
Proof. exact: size_bez. Qed.

Lemma sidesE c D j : good F D -> (0 < size c)%N -> ((size c).-1 <= D)%N -> (j <= D)%N -> at_list (sides K V D c) j = right_of c D j.
Proof.
move=> g c0 le_n le_j; set n := (size c).-1 in le_n *; set r := mkseq (fun i => padd V (pscale V (of_nat K (n - i)) (forward V c i))
  (pscale V (of_nat K i) (backward V c i))) (size c); have sr : size r = n.+1 by rewrite size_mkseq prednK.
have sz : (size r + (D - n)).-1 = D by rewrite sr addSn subnKC.
have := @BZZ19_15_program _ _ lt r (D - n); rewrite sz sr -[(n.+1 + (D - n))%N]/(n + (D - n)).+1 subnKC //.
have nz i : (n < i < D.+1)%N -> i%:R != 0 :> F by move=> /andP[lt_i le_i]; apply: (good_nat g); clear -lt_i le_i; lia.
move/(_ nz).
rewrite (_ : pbez n.+1.-1 (at_list r) = pderiv (curve_of c)); last first.
  rewrite pderiv_rate; apply: pbez_ext => i le_i; rewrite nth_mkseq; last by rewrite -(prednK c0).
  by rewrite !of_natE.
move=> e.
apply/rowP=> k; rewrite [RHS]mxE; have := congr1 (fun z : 'rV__ => z 0 k) e; rewrite [LHS]mxE => ek.
have sp : (size (pderiv (curve_of c) 0%R k) <= D.+1)%N.
  rewrite -ek; exact: size_bez.
apply: (bez_inj (n := D) (c := coord (at_list (sides K V D c)) k) (d := in_bernstein D (pderiv (curve_of c) 0 k)) (good_independent g)) => //.
by rewrite -BZZ19_14_bernstein //; exact: good_independent.
Qed.

Lemma equation_of c a b (n := (size c).-1) (D := degree_of n a b) j : good F D -> (1 < size c)%N -> (j <= D)%N ->
  made (size c) D.+1 (left_of a b n D) (right_of c D) (nth (Row [::] 0 [::]) (equations K V c a b) j) /\
  (forall i, (i < size c)%N -> (coefficients (nth (Row [::] 0 [::]) (equations K V c a b) j))`_i = left_of a b n D j i) /\
  right_side (nth (Row [::] 0 [::]) (equations K V c a b) j) = right_of c D j.
Proof.
move=> g c1 le_j; have c0 : (0 < size c)%N by exact: ltnW.
have [|le_n la lb] := @degree_of_bounds n a b; first by rewrite /n prednK.
rewrite /equations -/n -/D nth_mkseq //.
have el i : (i < size c)%N -> (coefficients (Row [seq col`_j | col <- mkseq (fun i => in_degree K D (column_of K (powers K a) (powers K b) n i)) (size c)]
    (at_list (sides K V D c) j) (indicator K D j)))`_i = left_of a b n D j i.
  move=> lt_i; rewrite /= (nth_map [::]) ?size_mkseq // nth_mkseq // in_degreeE // column_ofE ?powersE //.
  by rewrite -ltnS /n prednK.
have er : at_list (sides K V D c) j = right_of c D j by exact: sidesE.
have un k : (k < D.+1)%N -> (indicator K D j)`_k = (k == j)%:R by move=> lt_k; rewrite nth_mkseq // nat_eqbE; case: eqP.
have pick (A : lmodType F) (f : nat -> A) : \sum_(0 <= k < D.+1) (indicator K D j)`_k *: f k = f j.
  rewrite big_mkord (bigD1 (Ordinal (n := D.+1) le_j)) //= un // eqxx scale1r big1 ?addr0 // => k ne.
  by rewrite un // (_ : (k == j :> nat) = false) ?scale0r //; apply/negbTE.
split; [split|split] => //; first by rewrite size_map size_mkseq.
- by rewrite size_mkseq.
- by move=> i lt_i; rewrite el //; have := @pick [lmodType F of F^o] (fun k => left_of a b n D k i); move=> <-.
by rewrite [right_side _]/= er -(pick _ (right_of c D)).
Qed.

Lemma systemP c a b (n := (size c).-1) (D := degree_of n a b) (x : seq 'rV[F]_m) : good F D -> (1 < size c)%N ->
  solves n (at_list c) (bernstein a) (bernstein b) (at_list x) <-> obeys (size c) x (equations K V c a b).
Proof.
move=> g c1; have c0 : (0 < size c)%N by exact: ltnW.
have [|le_n la lb] := @degree_of_bounds n a b; first by rewrite /n prednK.
have ind := good_independent g; rewrite (@ZW06_G_system _ _ n D) //; last 2 first.
- exact: leq_trans (size_bernstein a) _.
- exact: leq_trans (size_bernstein b) _.
rewrite (obeysP _ _ _ (Row [::] 0 [::])) /equations size_mkseq -/(equations K V c a b) -/n -/D prednK //.
have eqj j : (j <= D)%N -> sat (size c) x (nth (Row [::] 0 [::]) (equations K V c a b) j) <->
    \sum_(0 <= i < size c) left_of a b n D j i *: at_list x i = right_of c D j.
  move=> le_j; have [_ [el er]] := equation_of g c1 le_j; rewrite /sat er.
  by rewrite (eq_big_nat _ _ (F2 := fun i => left_of a b n D j i *: at_list x i)) // => i /andP[_ lt_i]; rewrite el.
by split=> h j lt_j; have := h j lt_j; move/eqj; apply.
Qed.
End Curves.
