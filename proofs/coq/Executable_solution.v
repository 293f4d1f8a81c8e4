(* What the program for the rulings of a directrix gives, ZW06.G. *)
From Torse Require Import Prelude Blossom Curves Points Bernstein Bezier FJ21_4 BZZ19_4 BZZ19_4_written ZW06 ZW06_cases ZW06_system ZW06_unique Executable Executable_knots
  Executable_ZW06 Executable_splines Executable_composition Executable_polynomials Executable_elimination Executable_directrix.

Section Solution.
Variables (F : fieldType) (m : nat) (lt : F -> F -> bool).
Implicit Types (a b : seq F) (c tau x : seq 'rV[F]_m) (D n k i j : nat) (v : 'rV[F]_m).
Local Notation K := (of_field lt).
Local Notation V := (rows F m).
Local Notation at_list := (nth 0).
Local Notation curve_of c := (pbez (size c).-1 (at_list c)).

Lemma Contradiction_inj (s s' : seq F) (r r' : 'rV[F]_m) : Contradiction s r = Contradiction s' r' -> s = s' /\ r = r'. Proof. by case. Qed.
Lemma Only_inj (r r' : seq 'rV[F]_m) : Only F r = Only F r' -> r = r'. Proof. by case. Qed.
Lemma Family_inj (s s' : seq F) (r r' : seq 'rV[F]_m) : Family r s = Family r' s' -> r = r' /\ s = s'. Proof. by case. Qed.

Lemma solves_ext n p A B (tau tau' : nat -> 'rV[F]_m) : (forall i, (i <= n)%N -> tau i = tau' i) -> solves n p A B tau <-> solves n p A B tau'.
Proof. by move=> e; rewrite /solves (pbez_ext e). Qed.

Lemma without_right_side n p A B (tau tau' : nat -> 'rV[F]_m) (k : 'I_m) (h := fun i => tau' i 0 k - tau i 0 k) : solves n p A B tau -> solves n p A B tau' ->
  A * bez n h + B * (bez n h)^`() = 0.
Proof.
move=> sol sol'; rewrite bez_sub derivB !mulrBr addrACA -opprD.
have := congr1 (fun r : 'rV_m => r 0 k) sol; have := congr1 (fun r : 'rV_m => r 0 k) sol'; rewrite !mxE => <- <-.
by rewrite subrr.
Qed.

Lemma bernstein0 e : independent F (size e).-1 -> bernstein e = 0 -> all_zero K e.
Proof.
move=> ind e0; apply/allP=> y /(nthP 0)[i lt_i <-] /=; apply/eqP.
have z0 : bez (size e).-1 (fun=> 0 : F) = 0 by rewrite /bez big1 // => j _; rewrite polyC0 mul0r.
by apply: (bez_inj ind (d := fun=> 0)); rewrite -?/(bernstein e) ?e0 ?z0 // -ltnS prednK //; apply: leq_ltn_trans lt_i.
Qed.

(** ZW06.G program: the program for $a'=a\tau+b\tau'$ gives $s_j$ with $\sum_js_jG_{ji}=0$ for all $i$ and $\sum_js_jg_j\ne0$ where no $\tau$ solves the equation;
    $\tau$ where it is the only solution; $\tau$ and $\kappa$ where the solutions are the $\tau_i+\kappa_iv$ for all vectors $v$; and an error iff there are
    fewer than two points, or else $a=b=0$.
    Hypotheses: characteristic 0 or greater than $D=n+\max(\deg a,\deg b-1)$, so that the program divides by no zero. *)
Theorem ZW06_G_program c a b (n := (size c).-1) (D := degree_of n a b) (found := directrix_program K V (fun p => p == 0) c a b)
    (solution := solves n (at_list c) (bernstein a) (bernstein b)) : good F D ->
  [/\ forall s r, found = Value (Contradiction s r) -> [/\ r != 0, r = \sum_(0 <= j < D.+1) s`_j *: right_of c D j,
        forall i, (i <= n)%N -> \sum_(0 <= j < D.+1) s`_j * left_of a b n D j i = 0 & forall tau : nat -> 'rV[F]_m, ~ solution tau],
      forall t, found = Value (Only F t) -> forall tau : nat -> 'rV[F]_m, solution tau <-> forall i, (i <= n)%N -> tau i = at_list t i,
      forall t kappa, found = Value (Family t kappa) -> forall tau : nat -> 'rV[F]_m, solution tau <-> exists v, forall i, (i <= n)%N -> tau i = at_list t i + kappa`_i *: v,
      found = Fails _ Directrix <-> (size c <= 1)%N &
      found = Fails _ Equation <-> [/\ (1 < size c)%N, bernstein a = 0 & bernstein b = 0]].
Proof.
move=> g; rewrite /found /directrix_program nat_lebE /given; case: (ltnP 1 (size c)) => [c1|c1] /=; last by split=> //; split=> // -[].
have [|le_n la lb] := @degree_of_bounds F n a b; first by rewrite /n prednK // ltnW.
rewrite -/D in le_n la lb; have n1 : n.+1 = size c by rewrite /n prednK // ltnW.
have ind k : (k <= D)%N -> independent F k by move=> le_k; apply: good_independent; exact: good_le g.
have [ia ib] : independent F (size a).-1 /\ independent F (size b).-1.
  have low p q r s : (p <= s - r)%N -> (q <= (s - r).+1)%N -> (r <= s)%N -> (1 < r.+1)%N -> (p <= s)%N /\ (q <= s)%N by split; lia.
  by have [] := low _ _ _ _ la lb le_n; rewrite ?n1 //; split; exact: ind.
case: (boolP (all_zero K a && all_zero K b)) => [/andP[za zb]|nz] /=.
  have z e : all_zero K e -> bernstein e = 0 by rewrite all_zeroE => /eqP e0; rewrite /bernstein /bez big1 // => i _; rewrite -coef_Poly e0 coef0 polyC0 mul0r.
  split=> //; split=> // _; split=> //; exact: z.
have ab : (bernstein a, bernstein b) != (0, 0).
  apply: contra nz => /eqP[ea eb]; by rewrite !bernstein0.
set N := size c in n1 c1 *; set es := equations K V c a b; pose d0 := Row [::] 0 [::] : equation F 'rV[F]_m.
have ses : size es = D.+1 by rewrite size_mkseq.
have eqj j : (j < size es)%N -> made N D.+1 (left_of a b n D) (right_of c D) (nth d0 es j).
  by rewrite ses ltnS => le_j; have [] := equation_of lt g c1 le_j.
have all_N : all (fun e => size (coefficients e) == N) es by apply/(all_nthP d0) => j /eqj[-> _ _ _].
have sol_of (tau : nat -> 'rV[F]_m) : solution tau <-> obeys N (mkseq tau N) es.
  rewrite -systemP // -/n /solution; apply: solves_ext => i le_i; rewrite nth_mkseq // -n1 ltnS //.
have sol_at x : size x = N -> obeys N x es -> solution (at_list x).
  by move=> _; rewrite /es -systemP.
have := @eliminateP F lt _ N (fun p => p == 0) [::] es (fun=> erefl) I all_N.
have := @eliminate_made F lt _ N D.+1 (left_of a b n D) (right_of c D) (fun p => p == 0) [::] es I (every_nth eqj).
case: (eliminate _ _ _ _ _ _) => [kept _ [ech hk]|e [_ _ ec er] [z r0 none]]; last first.
  split.
  - move=> s r E; have [<- <-] := Contradiction_inj (Value_inj E); split=> //; last by move=> tau /sol_of h; apply: (none (mkseq tau N)).
    by move=> i le_i; rewrite -ec ?z // -n1 ltnS.
  - by move=> t' E; have := Value_inj E.
  - by move=> t' kappa E; have := Value_inj E.
  - by [].
  by split=> // -[_ ea eb]; rewrite ea eb eqxx in ab.
have [st ht off] := solvedP lt ech (size_nseq N (0 : 'rV[F]_m)); set t := solved _ _ _ _ _ in st ht off *.
have solt : solution (at_list t) by apply: sol_at => //; have /hk[] := ht.
have kept_of (tau : nat -> 'rV[F]_m) : solution tau <-> sats N (mkseq tau N) kept by rewrite sol_of; split=> [h|/hk[]//]; apply/hk.
set f := last N _; rewrite nat_eqbE; have := last_filterP (fun j => ~~ is_pivot kept j) N; rewrite -/f => -[/andP[lt_f nf]|[-> all_p]]; last first.
  rewrite eqxx; split; first (by move=> s r E; have := Value_inj E); last 3 first.
  - by move=> t' kappa E; have := Value_inj E.
  - by [].
  - by split=> // -[_ ea eb]; rewrite ea eb eqxx in ab.
  move=> t' E tau; rewrite -(Only_inj (Value_inj E)); split=> [/kept_of h i le_i|e]; last by apply/(solves_ext _ _ _ e).
  have lt_i : (i < N)%N by rewrite -n1.
  rewrite -[tau i](nth_mkseq 0 _ lt_i); apply: (sats_unique ech h ht) => // j lt_j np; by have := all_p j lt_j; rewrite np.
rewrite (ltn_eqF lt_f); split; first (by move=> s r E; have := Value_inj E); last 2 first.
- by [].
- by split=> // -[_ ea eb]; rewrite ea eb eqxx in ab.
- by move=> t' E; have := Value_inj E.
move=> t' kappa E tau; have [<- <-] := Family_inj (Value_inj E); pose hom (q : nat * equation F 'rV[F]_m) : nat * equation F [lmodType F of F^o] := (q.1, Row (coefficients q.2) (0 : F^o) [::]).
have piv j : is_pivot (map hom kept) j = is_pivot kept j by rewrite /is_pivot has_map.
have ech' : echelon N (map hom kept).
  by elim: (kept) ech => //= q old ih [h1 h2 h3 h4 /ih]; split=> // j; rewrite /is_pivot has_map; exact: h4.
pose start := mkseq (fun j => if Nat.eqb j f then 1 else 0 : F) N.
have [sk hkap koff] := @solvedP F lt [lmodType F of F^o] N (map hom kept) start ech' (size_mkseq _ _).
rewrite (_ : kernel K N kept f = solved K (module_of [lmodType F of F^o]) N (map hom kept) start) //; set kap := solved _ _ _ _ _ in sk hkap koff *.
have kapf : kap`_f = 1 by rewrite [LHS](koff f) ?piv // nth_mkseq // nat_eqbE eqxx.
have move_by (x : seq 'rV[F]_m) v : sats N x kept -> sats N (mkseq (fun i => at_list x i + kap`_i *: v) N) kept.
  elim: (kept) hkap => //= q old ih [h0 /ih{}ih] [hx /ih]; split=> //; move: hx h0; rewrite /sat /= => <- h0.
  rewrite (eq_big_nat _ _ (F2 := fun j => (coefficients q.2)`_j *: at_list x j + ((coefficients q.2)`_j * kap`_j) *: v)).
    by rewrite big_split /= -scaler_suml (_ : \sum_(0 <= i < N) _ = 0) ?scale0r ?addr0.
  by move=> j /andP[_ lt_j]; rewrite nth_mkseq // scalerDr scalerA.
split=> [sol|[v e]]; last first.
  by apply/kept_of; rewrite (_ : mkseq tau N = mkseq (fun i => at_list t i + kap`_i *: v) N); [exact: move_by | apply/eq_in_map => i; rewrite mem_iota -n1 ltnS; exact: e].
have [m0|m0] := posnP m.
  by exists 0 => i _; apply/rowP=> -[k lt_k]; exfalso; move: (lt_k); rewrite m0.
have homk : bernstein a * bez n (at_list kap) + bernstein b * (bez n (at_list kap))^`() = 0.
  have := move_by t (const_mx 1) ht; set y := mkseq _ N => hy.
  have soly : solution (at_list y) by apply: sol_at; [rewrite size_mkseq | have /hk[] := hy].
  have := without_right_side (Ordinal m0) solt soly; set h := (fun i => _).
  rewrite (_ : bez n h = bez n (at_list kap)) //; apply: bez_ext => i le_i; rewrite /h nth_mkseq -?n1 // !mxE addrC addKr mulr1 //.
have kap0 : bez n (at_list kap) != 0.
  apply/eqP=> k0; have z0 : bez n (fun=> 0 : F) = 0 by rewrite /bez big1 // => j _; rewrite polyC0 mul0r.
  have le_f : (f <= n)%N by rewrite -ltnS n1.
  by have := bez_inj (ind n le_n) (etrans k0 (esym z0)) le_f; rewrite kapf => /eqP; rewrite oner_eq0.
have gn : good F n by exact: good_le g.
exists (tau f - at_list t f) => i le_i; apply/eqP; rewrite addrC -subr_eq; apply/eqP/rowP=> k.
have [s es_k] := ZW06_G_family gn ab kap0 homk (without_right_side k solt sol).
have := es_k f; rewrite kapf mulr1 -ltnS n1 => /(_ lt_f) ef; have := es_k i le_i.
by rewrite !mxE mulrC ef.
Qed.
End Solution.
