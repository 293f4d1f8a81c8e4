(* Bernstein polynomials and Bezier curves on [0, 1], one coordinate.
   Definitions:
     B n i          C(n,i) X^i (1-X)^(n-i)
     bez n c        the sum of c_i B n i, i = 0..n
     prev c i       c_{i-1}, anything for i = 0, where it is always multiplied by 0
     elevated n c   the points i c_{i-1} + (n+1-i) c_i, (n+1) times those of degree n+1 *)
From Torse Require Import Prelude.

Definition prev (T : Type) (c : nat -> T) i := c i.-1.

Section Bernstein.
Variable F : fieldType.
Implicit Types (c d : nat -> F) (n m i k : nat).

Definition B n i : {poly F} := 'C(n, i)%:R * ('X^i * (1 - 'X) ^+ (n - i)).
Definition bez n c : {poly F} := \sum_(0 <= i < n.+1) (c i)%:P * B n i.
Definition elevated n c i := i%:R * prev c i + (n.+1 - i)%:R * c i.

Lemma polyC_nat k : (k%:R : F)%:P = k%:R.
Proof. exact: rmorph_nat. Qed.

Lemma B_out n i : (n < i)%N -> B n i = 0.
Proof. by move=> lt_i; rewrite /B bin_small ?mul0r. Qed.

Lemma bez_ext n c d : (forall i, (i <= n)%N -> c i = d i) -> bez n c = bez n d.
Proof. by move=> eq_c; apply: eq_big_nat => i /andP[_ lt_i]; rewrite eq_c. Qed.

Lemma bez_comb n s t c d : bez n (fun i => s * c i + t * d i) = s%:P * bez n c + t%:P * bez n d.
Proof.
by rewrite /bez !mulr_sumr -big_split /=; apply: eq_big_nat => i _; rewrite polyCD !polyCM; ring.
Qed.

Lemma bez_scale n s c : bez n (fun i => s * c i) = s%:P * bez n c.
Proof. by rewrite /bez mulr_sumr; apply: eq_big_nat => i _; rewrite polyCM mulrA. Qed.

Lemma bez_add n c d : bez n (fun i => c i + d i) = bez n c + bez n d.
Proof. by rewrite /bez -big_split /=; apply: eq_big_nat => i _; rewrite polyCD mulrDl. Qed.

Lemma bez_sub n c d : bez n (fun i => c i - d i) = bez n c - bez n d.
Proof. by rewrite /bez -sumrB /=; apply: eq_big_nat => i _; rewrite polyCB mulrBl. Qed.

(* The sum may run on: the B n i beyond n vanish. *)
Lemma bez_long n m c : (n < m)%N -> bez n c = \sum_(0 <= i < m) (c i)%:P * B n i.
Proof.
move=> lt_n; rewrite (big_cat_nat _ _ _ (leq0n n.+1)) //= [X in _ = _ + X]big_nat_cond.
by rewrite [X in _ = _ + X]big1 ?addr0 // => i /andP[/andP[lt_i _] _]; rewrite B_out ?mulr0.
Qed.

Let Y : {poly F} := 1 - 'X.

Lemma X_B n i : n.+1%:R * ('X * B n i) = i.+1%:R * B n.+1 i.+1.
Proof.
rewrite /B subSS exprS -/Y; have := congr1 (fun k => k%:R : {poly F}) (mul_bin_diag n.+1 i); rewrite !natrM /=.
by move: ('C(n, i)%:R) ('C(n.+1, i.+1)%:R) => a b e; rewrite !mulrA -e; ring.
Qed.

Lemma XC_B n i : (i <= n)%N -> n.+1%:R * (Y * B n i) = (n.+1 - i)%:R * B n.+1 i.
Proof.
move=> le_i; rewrite /B -/Y subSn // exprS; have := congr1 (fun k => k%:R : {poly F}) (mul_bin_down n.+1 i).
rewrite !natrM /= subSn //; move: ('C(n, i)%:R) ('C(n.+1, i)%:R) => a b e; rewrite !mulrA -e; ring.
Qed.

Lemma B_pascal n i : B n.+1 i.+1 = Y * B n i.+1 + 'X * B n i.
Proof.
rewrite /B binS natrD -/Y subSS exprS; have [lt_i|le_i] := ltnP i n; last first.
  rewrite bin_small ?ltnS // !mul0r mulr0 !add0r.
  by move: ('X^i) (Y ^+ (n - i)) ('C(n, i)%:R) => x y c; ring.
rewrite -subnSK // [Y ^+ (n - i.+1).+1]exprS.
by move: ('X^i) (Y ^+ (n - i.+1)) ('C(n, i)%:R) ('C(n, i.+1)%:R) => x y c d; ring.
Qed.

(* One step of de Casteljau's algorithm. *)
Lemma casteljau n (g : nat -> {poly F}) :
  \sum_(0 <= i < n.+2) g i * B n.+1 i = \sum_(0 <= i < n.+1) (Y * g i + 'X * g i.+1) * B n i.
Proof.
rewrite (eq_big_nat _ _ (F1 := fun i => (Y * g i + 'X * g i.+1) * B n i) (F2 := fun i => Y * (g i * B n i) + 'X * (g i.+1 * B n i))); last first.
  by move=> i _; ring.
rewrite big_split /= (_ : \sum_(0 <= i < n.+1) Y * (g i * B n i) = \sum_(0 <= i < n.+2) Y * (g i * B n i)); last first.
  by rewrite [RHS]big_nat_recr //= B_out // !mulr0 addr0.
rewrite big_nat_recl // [X in _ = X + _]big_nat_recl // -addrA -big_split /=; congr (_ + _).
  by rewrite /B !bin0 !expr0 !mul1r !subn0 -/Y exprS; ring.
by apply: eq_big_nat => i _; rewrite B_pascal; ring.
Qed.

Lemma deriv_Y k : (Y ^+ k)^`() = - k%:R * Y ^+ k.-1.
Proof. by rewrite deriv_exp derivB derivC derivX sub0r mulN1r -mulr_natl mulrN mulNr. Qed.

Lemma X_deriv_B n i : (i <= n)%N -> 'X * (B n i)^`() = i%:R * B n i - i.+1%:R * B n i.+1.
Proof.
move=> le_i; rewrite /B -/Y; set c := 'C(n, i)%:R; have -> : (c * ('X^i * Y ^+ (n - i)))^`() = c * ('X^i * Y ^+ (n - i))^`().
  by rewrite derivM /c (_ : _%:R = ('C(n, i)%:R)%:P) ?derivC ?mul0r ?add0r // raddfMn.
rewrite derivM derivXn deriv_Y -mulr_natl.
have e : i.+1%:R * 'C(n, i.+1)%:R = (n - i)%:R * c :> {poly F} by rewrite /c -!natrM mul_bin_left.
have eX : i%:R * ('X * 'X^i.-1) = i%:R * 'X^i :> {poly F} by case: (i) => [|j]; rewrite ?mul0r // -exprS.
have -> : (n - i.+1)%N = (n - i).-1 by rewrite subnS.
rewrite !mulrA e exprS; move: ('X^i) ('X^i.-1) (Y ^+ (n - i)) (Y ^+ (n - i).-1) (i%:R) ((n - i)%:R) eX => p q r s j k eX.
by transitivity (c * (j * ('X * q)) * r - k * c * ('X * p) * s); [ring | rewrite eX; ring].
Qed.

Lemma Y_deriv_B n i : (i <= n)%N -> Y * (B n i)^`() = (n - i.-1)%:R * (if i is j.+1 then B n j else 0) - (n - i)%:R * B n i.
Proof.
move=> le_i; rewrite /B -/Y; set c := 'C(n, i)%:R; have -> : (c * ('X^i * Y ^+ (n - i)))^`() = c * ('X^i * Y ^+ (n - i))^`().
  by rewrite derivM /c (_ : _%:R = ('C(n, i)%:R)%:P) ?derivC ?mul0r ?add0r // raddfMn.
rewrite derivM derivXn deriv_Y -mulr_natl.
have eY : (n - i)%:R * (Y * Y ^+ (n - i).-1) = (n - i)%:R * Y ^+ (n - i) :> {poly F}.
  by case: (n - i)%N => [|j]; rewrite ?mul0r // -exprS.
transitivity (i%:R * c * 'X^i.-1 * (Y * Y ^+ (n - i)) - (n - i)%:R * (c * ('X^i * Y ^+ (n - i)))).
  transitivity (i%:R * c * 'X^i.-1 * (Y * Y ^+ (n - i)) - c * 'X^i * ((n - i)%:R * (Y * Y ^+ (n - i).-1))); last by rewrite eY; ring.
  by move: ('X^i) ('X^i.-1) (Y ^+ (n - i)) (Y ^+ (n - i).-1) (i%:R) ((n - i)%:R) => p q r s j k; ring.
congr (_ - _); case: i le_i @c {eY} => [|i] lt_i c; first by rewrite !mul0r mulr0.
have e : i.+1%:R * c = (n - i)%:R * 'C(n, i)%:R :> {poly F} by rewrite /c -!natrM mul_bin_left.
rewrite e /= -exprS -subSn // subSS !mulrA; ring.
Qed.

(* u c' and (1-u) c' in the same degree. *)
Lemma X_deriv_bez n c : 'X * (bez n c)^`() = bez n (fun i => i%:R * (c i - prev c i)).
Proof.
rewrite /bez (raddf_sum (deriv_additive _)) mulr_sumr /=.
rewrite (eq_big_nat _ _ (F2 := fun i => i%:R%:P * (c i)%:P * B n i - i.+1%:R%:P * (c i)%:P * B n i.+1)); last first.
  move=> i /andP[_ lt_i]; rewrite derivM derivC mul0r add0r mulrCA X_deriv_B // !raddfMn /=; ring.
rewrite sumrB [X in _ - X](_ : _ = \sum_(0 <= i < n.+1) i%:R%:P * (prev c i)%:P * B n i).
  by rewrite -sumrB; apply: eq_big_nat => i _; rewrite polyCM polyCB; ring.
rewrite big_nat_recr //= B_out // mulr0 addr0 [RHS]big_nat_recl //= mul0r mul0r add0r.
by apply: eq_big_nat => i _.
Qed.

Lemma Y_deriv_bez n c : Y * (bez n c)^`() = bez n (fun i => (n - i)%:R * (c i.+1 - c i)).
Proof.
rewrite /bez (raddf_sum (deriv_additive _)) mulr_sumr /=.
rewrite (eq_big_nat _ _ (F2 := fun i => (n - i.-1)%:R%:P * (c i)%:P * (if i is j.+1 then B n j else 0) - (n - i)%:R%:P * (c i)%:P * B n i)); last first.
  move=> i /andP[_ lt_i]; rewrite derivM derivC mul0r add0r mulrCA Y_deriv_B // !raddfMn /=; ring.
rewrite sumrB [X in X - _](_ : _ = \sum_(0 <= i < n.+1) (n - i)%:R%:P * (c i.+1)%:P * B n i).
  by rewrite -sumrB; apply: eq_big_nat => i _; rewrite polyCM polyCB; ring.
rewrite big_nat_recl //= mulr0 add0r [RHS]big_nat_recr //= subnn mul0r mul0r addr0.
by apply: eq_big_nat => i _.
Qed.

(* The derivative in the same degree: c' has the points (n-i) (c_{i+1} - c_i) + i (c_i - c_{i-1}). *)
Theorem deriv_bez n c : (bez n c)^`() = bez n (fun i => (n - i)%:R * (c i.+1 - c i) + i%:R * (c i - prev c i)).
Proof. by rewrite bez_add -X_deriv_bez -Y_deriv_bez; rewrite /Y; ring. Qed.

Lemma X_bez n c : n.+1%:R%:P * ('X * bez n c) = bez n.+1 (fun i => i%:R * prev c i).
Proof.
rewrite /bez !mulr_sumr [RHS]big_nat_recl //= mul0r polyC0 mul0r add0r; apply: eq_big_nat => i _.
rewrite /prev /=; have := X_B n i; rewrite polyCM !polyC_nat => e.
by transitivity ((c i)%:P * (n.+1%:R * ('X * B n i))); [ring | rewrite e; ring].
Qed.

Lemma Y_bez n c : n.+1%:R%:P * (Y * bez n c) = bez n.+1 (fun i => (n.+1 - i)%:R * c i).
Proof.
rewrite /bez !mulr_sumr [RHS]big_nat_recr //= subnn mul0r polyC0 mul0r addr0; apply: eq_big_nat => i /andP[_ lt_i].
have := @XC_B n i lt_i; rewrite polyCM !polyC_nat => e.
by transitivity ((c i)%:P * (n.+1%:R * (Y * B n i))); [ring | rewrite e; ring].
Qed.

Theorem elevate_bez n c : n.+1%:R%:P * bez n c = bez n.+1 (elevated n c).
Proof. by rewrite /elevated bez_add -X_bez -Y_bez /Y; ring. Qed.

(* The Bernstein polynomials are independent where no binomial coefficient C(n, i) vanishes, as in characteristic 0. *)
Lemma weighted0 n (w c : nat -> F) : (forall i, (i <= n)%N -> w i != 0) ->
  \sum_(0 <= i < n.+1) (c i)%:P * ((w i)%:P * ('X^i * Y ^+ (n - i))) = 0 -> forall i, (i <= n)%N -> c i = 0.
Proof.
elim: n w c => [|n ih] w c nz.
  rewrite big_nat1 expr0 subnn expr0 mulr1 mulr1 -polyCM => /eqP; rewrite polyC_eq0 mulf_eq0 (negPf (nz _ _)) // orbF => /eqP e [|//].
  by [].
rewrite big_nat_recl // expr0 mul1r subn0 => e.
have e1 : \sum_(0 <= i < n.+1) (c i.+1)%:P * ((w i.+1)%:P * ('X^i.+1 * Y ^+ (n.+1 - i.+1)))
        = 'X * \sum_(0 <= i < n.+1) (c i.+1)%:P * ((w i.+1)%:P * ('X^i * Y ^+ (n - i))).
  by rewrite mulr_sumr; apply: eq_big_nat => i _; rewrite subSS exprS; ring.
have c0 : c 0%N = 0.
  have := congr1 (fun p => p.[0]) e; rewrite e1 !hornerE /= horner_exp !hornerE subr0 expr1n mulr1 => /eqP.
  by rewrite mulf_eq0 (negPf (nz _ _)) // orbF => /eqP.
move: e; rewrite c0 polyC0 mul0r add0r e1 => /eqP; rewrite mulf_eq0 polyX_eq0 /= => /eqP e.
have := ih (fun i => w i.+1) (fun i => c i.+1) (fun i le_i => nz i.+1 le_i) e => h [|i] //; exact: h.
Qed.

Theorem bez_inj n c d : (forall i, (i <= n)%N -> 'C(n, i)%:R != 0 :> F) -> bez n c = bez n d -> forall i, (i <= n)%N -> c i = d i.
Proof.
move=> nz /eqP; rewrite -subr_eq0 -bez_sub => /eqP e i le_i; apply/eqP; rewrite -subr_eq0; apply/eqP.
apply: (@weighted0 n (fun i => 'C(n, i)%:R) (fun i => c i - d i) nz _ i le_i).
by rewrite -[RHS]e; apply: eq_big_nat => j _; rewrite /B !polyC_nat.
Qed.

Lemma B_sum n : \sum_(0 <= i < n.+1) B n i = 1.
Proof.
have <- : (Y + 'X) ^+ n = 1 by rewrite /Y subrK expr1n.
rewrite exprDn big_mkord; apply: eq_bigr => i _; by rewrite /B -/Y -[RHS]mulr_natl ['X^i * _]mulrC.
Qed.

Lemma bin_bin n j k : (j + k <= n)%N -> ('C(j + k, k) * 'C(n, j + k) = 'C(n, k) * 'C(n - k, j))%N.
Proof.
move=> le_n; have f0 : (0 < k`! * (j`! * (n - (j + k))`!))%N by rewrite !muln_gt0 !fact_gt0.
apply/eqP; rewrite -(eqn_pmul2r f0); apply/eqP.
have e1 : ('C(j + k, k) * (k`! * j`!) = (j + k)`!)%N by have := @bin_fact (j + k) k (leq_addl _ _); rewrite addnK.
have e2 := bin_fact le_n.
have e3 : ('C(n - k, j) * (j`! * (n - (j + k))`!) = (n - k)`!)%N.
  by have := @bin_fact (n - k) j; rewrite -subnDA [(k + j)%N]addnC; apply; lia.
have e4 : ('C(n, k) * (k`! * (n - k)`!) = n`!)%N by apply: bin_fact; lia.
transitivity n`!; first by rewrite -e2 -e1 !mulnA; congr (_ * _ * _ * _)%N; exact: mulnC.
by rewrite -e4 -e3 !mulnA; congr (_ * _ * _)%N; rewrite -!mulnA; congr (_ * _)%N; exact: mulnC.
Qed.

(* The powers in the Bernstein basis. *)
Theorem power_bez n k : (k <= n)%N -> bez n (fun i => 'C(i, k)%:R) = 'C(n, k)%:R * 'X^k.
Proof.
move=> le_k; rewrite /bez (big_cat_nat _ _ _ (leq0n k)) ?leqW //= big_nat_cond big1 ?add0r; last first.
  by move=> i /andP[/andP[_ lt_i] _]; rewrite bin_small // polyC0 mul0r.
rewrite -{1}[k]add0n big_addn subSn // -[RHS]mulr1 -[X in _ = _ * X](B_sum (n - k)) mulr_sumr; apply: eq_big_nat => j /andP[_ lt_j].
have le_n : (j + k <= n)%N by lia.
have := congr1 (fun i => i%:R : {poly F}) (bin_bin le_n); rewrite !natrM polyC_nat /B exprD -subnDA [(k + j)%N]addnC.
have eY : (1 - 'X : {poly F}) = Y by []; rewrite !eY; move: ('C(j + k, k)%:R) ('C(n, j + k)%:R) ('C(n, k)%:R) ('C(n - k, j)%:R) => p q r s e.
move: ('X^j) ('X^k) (Y ^+ (n - (j + k))) => x y z; transitivity (p * q * (x * y * z)); [ring | rewrite e; ring].
Qed.

End Bernstein.
