(* ZW06: what happens without the hypotheses of the theorems, one counterexample each.
   Definitions:
     tip n, zero      the points of a line 0, ..., 0, 1, 0, ..., the n-th is 1, and the points 0
     chosen k         the points C(i, k) of a line: their Bezier curve is C(n, k) u^k *)
From Torse Require Import Prelude Blossom Curves Points Bernstein Bezier ZW06 ZW06_cases ZW06_nets ZW06_system FJ21_4 Needs_blossoms Needs_FJ07 Needs_FJ07_curves.

Section Functions.
Variable F : fieldType.
Implicit Types (p w : 'rV[{poly F}]_3) (a b : {poly F}).

(** ZW06.11 needs_rulings: without rulings, $\tau=0$, and with a constant directrix $a_1'=0$ for all $a$, $b$, also for $a=1\ne0=b'$. *)
Theorem ZW06_11_needs_rulings (w := 0 : 'rV[{poly F}]_3) (p := 0 : 'rV[{poly F}]_3) :
  [/\ pderiv p = 1 *: w + 0 *: pderiv w, pderiv (p - 0 *: w) = 0 & (1 : {poly F}) <> 0^`()].
Proof.
have d0 : pderiv (0 : 'rV[{poly F}]_3) = 0 by apply/rowP=> k; rewrite !mxE linear0.
rewrite /p /w !scaler0 scale0r subr0 addr0 d0 linear0; split=> //.
by apply/eqP; rewrite oner_eq0.
Qed.

(** ZW06.8 needs_turn: where $\tau\times\tau'=0$ every point of the ruling may be singular: $\tau$ constant and $a(u)=u\tau$, a surface that is
    a line. *)
Theorem ZW06_8_needs_turn u v (e : 'rV[F]_3) (w := map_mx polyC e) (p := 'X *: w) (b : {poly F}) :
  pderiv p = 1 *: w + b *: pderiv w /\ cross (ev (pderiv p) u + v *: ev (pderiv w) u) (ev w u) = 0.
Proof.
have dw : pderiv w = 0 by apply/rowP=> k; rewrite !mxE derivC.
have dp : pderiv p = w by apply/rowP=> k; rewrite !mxE derivM derivX derivC mulr0 addr0 mul1r.
rewrite dp dw scaler0 addr0 scale1r; split=> //.
have -> : ev (0 : 'rV[{poly F}]_3) u = 0 by apply/rowP=> k; rewrite !mxE horner0.
by rewrite scaler0 addr0; apply: row3P; coordinates; ring.
Qed.

(** ZW06.15 needs_off: where $a(u)=b'(u)$ the tangent of $a_1$ vanishes: no multiple of it is a ruling that is not 0. *)
Theorem ZW06_15_needs_off p w a b u : pderiv p = a *: w + b *: pderiv w -> a.[u] = b^`().[u] ->
  ev (pderiv (regression p w b)) u = 0.
Proof.
move=> /ZW06_9_derivative; rewrite -/(regression p w b) => -> e.
by apply/rowP=> k; rewrite !mxE hornerM hornerD hornerN e subrr mul0r.
Qed.

(** ZW06.10 needs_characteristic: where $n=0$ in the field ($n\ge1$), $a(u)=(u^n,0,0)$ and $\tau=(0,1,0)$ have $a'=0=b'$ with $a=b=0$, and
    $a_1=a(u)$ is no point. *)
Theorem ZW06_10_needs_characteristic n (p := vec 'X^n 0 0 : 'rV[{poly F}]_3) (w := vec 0 1 0 : 'rV[{poly F}]_3) :
  n%:R = 0 :> F -> (0 < n)%N ->
  pderiv p = 0 *: w + 0 *: pderiv w /\ ~ exists e : 'rV[F]_3, forall u v, ev p u + v *: ev w u = e + (v + (0 : {poly F}).[u]) *: ev w u.
Proof.
move=> n0 n1; split.
  rewrite !scale0r addr0 /p pderiv_vec derivXn -mulr_natl -polyC_nat n0 polyC0 mul0r linear0.
  by apply/rowP=> -[[|[|[|//]]] ?]; rewrite !mxE.
case=> e h; have := h 0 0; have := h 1 0; rewrite !horner0 !addr0 !scale0r !addr0 /p !ev_vec !hornerXn => <-.
move/(congr1 (fun r : 'rV_3 => r 0 0)); rewrite !mxE /= expr1n expr0n; case: (n) n1 => // k _ /eqP.
by rewrite eq_sym oner_eq0.
Qed.
End Functions.

Section Nets.
Variable F : fieldType.
Implicit Types (n i k : nat) (rho s : F).

Definition tip n : nat -> 'rV[F]_1 := fun i => const_mx (i == n)%:R.
Definition zero : nat -> 'rV[F]_1 := fun=> 0.

Lemma pbez0 n : pbez n zero = 0.
Proof. by apply/rowP=> k; rewrite !mxE /bez big1 // => i _; rewrite /coord mxE polyC0 mul0r. Qed.

Lemma deriv0 : pderiv (0 : 'rV[{poly F}]_1) = 0.
Proof. by apply/rowP=> k; rewrite !mxE linear0. Qed.

(* Where C(n, i) = 0 in the field, the Bezier curve of the point i alone is 0. *)
Lemma hidden n i : 'C(n, i)%:R = 0 :> F -> pbez n (tip i) = 0.
Proof.
move=> e; apply/rowP=> k; rewrite !mxE /bez big1_seq // => j _; rewrite /coord mxE.
by have [->|] := eqVneq j i; rewrite ?polyC0 ?mul0r // /B -(polyC_nat F) e polyC0 mul0r mulr0.
Qed.

(** ZW06.17 needs_binomials: where $C(n,i)=0$ in the field, the points $\tau_i=1$, all others and all $p_j$ 0, solve $a'=\tau$; they are not $0$. *)
Theorem ZW06_17_needs_binomials n i : (i <= n)%N -> 'C(n, i)%:R = 0 :> F ->
  pderiv (pbez n zero) = pbez n (tip i) /\ tip i i <> rate n zero i.
Proof.
move=> le_i e; rewrite pbez0 deriv0 hidden //; split=> //; rewrite /rate /prev /zero !subrr !scaler0 addr0.
by rewrite line1 !mxE eqxx => /eqP; rewrite oner_eq0.
Qed.

(** ZW06.16 needs_binomials: where $C(n,i)=0$ in the field, the same points solve $a'=2\tau+u\tau'$, and the recursion fails at $i$ or $i+1$. *)
Theorem ZW06_16_needs_binomials n i : (i < n)%N -> 'C(n, i)%:R = 0 :> F ->
  pderiv (pbez n zero) = 2%:R%:P *: pbez n (tip i) + 'X *: pderiv (pbez n (tip i)) /\
  ~ forall j, (j <= n)%N -> (j + 2)%:R *: tip i j = rate n zero j + j%:R *: prev (tip i) j.
Proof.
move=> lt_i e; rewrite pbez0 hidden // deriv0 !scaler0 addr0; split=> // h.
have rate0 j : rate n zero j = 0 by rewrite /rate /prev /zero !subrr !scaler0 addr0.
have := h i.+1 lt_i; have := h i (ltnW lt_i); rewrite !rate0 /prev /= !line1 !mxE eqxx (gtn_eqF (ltnSn i)) !mulr1 !mulr0 !add0r.
have -> : i%:R * (i.-1 == i)%:R = 0 :> F.
  by case: (i) => [|k]; [rewrite mul0r | rewrite /= (ltn_eqF (ltnSn k)) mulr0].
move=> e1 /esym e2; move/eqP: e1; rewrite addn2 -addn1 natrD.
have -> : i.+1%:R = 0 :> F by [].
by rewrite add0r oner_eq0.
Qed.

(** ZW06.16 unique_needs_next: where $n+2=0$ in the field, the points $\tau_n=1$, all others and all $p_j$ 0, have $\tau=u^n$ and solve $a'=2\tau+u\tau'$; the formula
    gives $\tau_n=0$. *)
Theorem ZW06_16_unique_needs_next n : n.+2%:R = 0 :> F ->
  pderiv (pbez n zero) = 2%:R%:P *: pbez n (tip n) + 'X *: pderiv (pbez n (tip n)) /\
  tip n n <> (n - n)%:R *: mean_step zero n + n%:R *: mean_step zero n.-1.
Proof.
move=> e; have step0 i : mean_step zero i = 0 by rewrite /mean_step big1 ?scaler0 // => j _; rewrite /zero subrr scaler0.
split; last by rewrite !step0 !scaler0 addr0 => /rowP/(_ 0); rewrite !mxE eqxx => /eqP; rewrite oner_eq0.
have power : pbez n (tip n) = const_mx 'X^n.
  apply/rowP=> k; rewrite !mxE /bez big_nat_recr //= big1_seq ?add0r; last first.
    by move=> j; rewrite mem_index_iota => /andP[_ /andP[_ lt_j]]; rewrite /coord mxE (ltn_eqF lt_j) polyC0 mul0r.
  by rewrite /coord mxE eqxx mul1r /B binn subnn expr0 mulr1 mul1r.
rewrite pbez0 deriv0 power; apply/rowP=> k; rewrite !mxE derivXn.
have -> : 'X * ('X^n.-1 *+ n) = n%:R * 'X^n :> {poly F}.
  by case: n {e power} => [|n]; [rewrite mulr0 mul0r | rewrite mulrnAr -exprS mulr_natl].
by rewrite polyC_nat -mulrDl -natrD add2n -(polyC_nat F) e polyC0 mul0r.
Qed.

(** ZW06.18 needs_binomials: where $C(n,i)=0$ in the field, the points $p_i=1$, all others and all $\tau_j$ 0, solve $u\,a'=\tau+u\tau'$, and the
    recursion fails at $i$ or $i+1$. *)
Theorem ZW06_18_needs_binomials n i : (i < n)%N -> 'C(n, i)%:R = 0 :> F ->
  'X *: pderiv (pbez n (tip i)) = pbez n zero + 'X *: pderiv (pbez n zero) /\
  ~ forall j, (j <= n)%N -> j.+1%:R *: zero j = j%:R *: (tip i j - prev (tip i) j + prev zero j).
Proof.
move=> lt_i e; rewrite pbez0 hidden // deriv0 !scaler0 addr0; split=> // h.
have i0 : (0 < i)%N by case: (i) e => // /eqP; rewrite bin0 oner_eq0.
have := h i.+1 lt_i; have := h i (ltnW lt_i); rewrite /prev /zero !scaler0 !addr0 /= !line1 !mxE eqxx (gtn_eqF (ltnSn i)).
have -> : (i.-1 == i) = false by rewrite -{2}(prednK i0) (ltn_eqF (ltnSn _)).
rewrite subr0 sub0r mulr1 mulrN mulr1 -[i.+1]addn1 natrD => <- /eqP.
by rewrite add0r eq_sym oppr_eq0 oner_eq0.
Qed.

Lemma tip_power n : pbez n (tip n) = const_mx 'X^n.
Proof.
apply/rowP=> k; rewrite !mxE /bez big_nat_recr //= big1_seq ?add0r => [|j]; last first.
  by rewrite mem_index_iota => /andP[_ lt_j]; rewrite /coord mxE (ltn_eqF lt_j) polyC0 mul0r.
by rewrite /coord mxE eqxx polyC1 mul1r /B binn subnn expr0 mulr1 mul1r.
Qed.

Lemma tip_deriv n : n%:R = 0 :> F -> pderiv (pbez n (tip n)) = 0.
Proof. by move=> n0; rewrite tip_power; apply/rowP=> k; rewrite !mxE derivXn -mulr_natl -(polyC_nat F) n0 polyC0 mul0r. Qed.

Definition chosen k : nat -> 'rV[F]_1 := fun i => const_mx 'C(i, k)%:R.

Lemma chosen_deriv n k : (k <= n)%N -> k%:R = 0 :> F -> pderiv (pbez n (chosen k)) = 0.
Proof.
move=> le_k k0; apply/rowP=> j; rewrite !mxE (@bez_ext _ n _ (fun i => 'C(i, k)%:R)) => [|i _]; last by rewrite /coord mxE.
by rewrite power_bez // mulr_natl derivMn derivXn -[_ *+ k]mulr_natl -(polyC_nat F) k0 polyC0 mul0r mul0rn.
Qed.

(** ZW06.12 needs_factorial: where $k=0$ in the field, $1\le k\le n$, the points $\tau_i=C(i,k)$, all $p_j=0$, have $\tau=C(n,k)u^k$, $\tau'=0$. *)
Theorem ZW06_12_needs_factorial n k rho : (0 < k <= n)%N -> k%:R = 0 :> F ->
  (rho - 1)%:P *: pderiv (pbez n zero) = pderiv (pbez n (chosen k)) /\
  zero k + chosen k k <> zero 0%N + chosen k 0%N + rho *: (zero k - zero 0%N).
Proof.
case/andP=> k1 le_k k0; rewrite pbez0 deriv0 scaler0 chosen_deriv //; split=> //.
rewrite /zero subrr scaler0 line1 !mxE binn bin_small // !(add0r, addr0) => /eqP.
by rewrite oner_eq0.
Qed.

(** ZW06.13 needs_binomials: where $n=0$ in the field the points $p_n=1$, all others and all $\tau_j$ 0, have $a=u^n$, $a'=0$, and the formula
    fails for $i=n-1$. *)
Theorem ZW06_13_needs_binomials n s : n.+1%:R = 0 :> F ->
  pderiv (pbez n.+1 (tip n.+1)) = s%:P *: pbez n.+1 zero + s%:P *: ('X *: pderiv (pbez n.+1 zero)) /\
  (n.+1%:R * s) *: zero n <> (n.+1 - n)%:R *: tip n.+1 n.+1 + n.+1%:R *: tip n.+1 n - n.+2%:R *: tip n.+1 0%N.
Proof.
move=> n0; rewrite pbez0 deriv0 tip_deriv // !scaler0 addr0; split=> //.
rewrite n0 ?mul0r !scale0r addr0 subSnn line1 !mxE eqxx /=. rewrite mulr1 subr0 => /eqP.
by rewrite eq_sym oner_eq0.
Qed.

(** ZW06.20 needs_factorial: where $k+1=0$ in the field, $k<n$, the points $\tau_i=C(i,k+1)$, with $\tau'=0$, solve the equation for $s=1$ and are not Aumann's. *)
Theorem ZW06_20_needs_factorial n k rho : (k < n)%N -> k.+1%:R = 0 :> F ->
  (rho - 1)%:P *: pderiv (pbez n zero) = (n%:R * (1 - 1))%:P *: pbez n (chosen k.+1) +
    ((1 - 'X) *: pderiv (pbez n (chosen k.+1)) + 1%:P *: ('X *: pderiv (pbez n (chosen k.+1)))) /\
  zero k.+1 + chosen k.+1 k.+1 <> zero k + rho *: (zero k.+1 - zero k) + 1 *: (zero k + chosen k.+1 k - zero k).
Proof.
move=> lt_k k0; rewrite pbez0 deriv0 chosen_deriv // subrr mulr0 polyC0 scale0r !scaler0 !addr0; split=> //.
rewrite /zero subrr scaler0 line1 !mxE binn bin_small // !(add0r, addr0, subr0, mulr0) => /eqP.
by rewrite oppr0 mulr0 oner_eq0.
Qed.

Lemma bez_line : bez 1 (coord (on_line [:: 0; 1 : F]) 0) = 'X.
Proof.
rewrite /bez big_nat_recr //= big_nat1 /coord !mxE /= polyC0 mul0r add0r polyC1 mul1r /B binn subnn expr0 expr1.
by rewrite mulr1 mul1r.
Qed.

(** ZW06.12 needs_rho: for $\rho=1$ the points $q_i=q_0+(p_i-p_0)$ have a constant $\tau$, and $a'=b\tau'=0$ for no $b$: $p=(0,1)$, $n=1$. *)
Theorem ZW06_12_needs_rho (p := on_line [:: 0; 1 : F]) (b : {poly F}) :
  pderiv (pbez 1 p) <> b *: pderiv (pbez 1 zero).
Proof.
rewrite pbez0 deriv0 scaler0 => /rowP/(_ 0); rewrite !mxE bez_line.
by rewrite derivX => /eqP; rewrite oner_eq0.
Qed.

(** ZW06.13 needs_s: for $s=0$ the equation $a'=0$ has no solution over a directrix that is no point: $p=(0,1)$, $n=1$. *)
Theorem ZW06_13_needs_s (p := on_line [:: 0; 1 : F]) tau :
  pderiv (pbez 1 p) <> (0 : F)%:P *: pbez 1 tau + ((0 : F)%:P * 'X) *: pderiv (pbez 1 tau).
Proof.
by rewrite polyC0 mul0r !scale0r addr0 => e; apply: (@ZW06_12_needs_rho 0); rewrite scale0r.
Qed.

(** ZW06.20 fj07_needs_s: for $s=1$ no $\Lambda,M$ will do: $p_0=p_1=0$, $q_0=q_1=1$ obey Aumann's equation for every $\rho$ and (12) for none. *)
Theorem ZW06_20_fj07_needs_s (p := on_line [:: 0; 0 : F]) (q := on_line [:: 1; 1 : F]) :
  (forall rho, q 1%N = p 0%N + rho *: (p 1%N - p 0%N) + 1 *: (q 0%N - p 0%N)) /\
  forall L M : F, (1 - L) *: p 0%N + L *: p 1%N <> (1 - M) *: q 0%N + M *: q 1%N.
Proof.
split=> [rho|L M]; rewrite line1 !mxE /=; first by ring.
by move/eqP; rewrite !mulr0 addr0 !mulr1 subrK eq_sym oner_eq0.
Qed.

(** ZW06.6 needs_factorial: where $k=0$ in the field, $1\le k\le n$, the vectors $\tau_i=(1,C(i,k))$ have $\tau'=0$ and are no multiples of one vector. *)
Theorem ZW06_6_needs_factorial n k (tau := fun i => \row_(j < 2) (if val j is 0%N then 1 else 'C(i, k)%:R) : 'rV[F]_2) : (0 < k <= n)%N ->
  k%:R = 0 :> F -> pderiv (pbez n tau) = 0 /\ ~ exists e h, forall i, (i <= n)%N -> tau i = h i *: e.
Proof.
case/andP=> k1 le_k k0; split.
  apply/rowP=> -[[|[|//]] lt_k]; rewrite !mxE.
    rewrite (bez_ext (d := fun=> 1)) => [|i _]; last by rewrite /coord mxE.
    rewrite (_ : bez n _ = 1) -?polyC1 ?derivC //; rewrite polyC1 -(B_sum F n); apply: eq_big_nat => i _.
    by rewrite polyC1 mul1r.
  have /rowP/(_ 0) := chosen_deriv le_k k0; rewrite !mxE => e; rewrite -[RHS]e; congr (_^`()).
  by apply: bez_ext => i _; rewrite /coord !mxE.
case=> e [h eq_tau]; have := congr1 (fun r : 'rV_2 => (r 0 0, r 0 1)) (eq_tau 0%N isT).
have := congr1 (fun r : 'rV_2 => r 0 1) (eq_tau k le_k); rewrite !mxE /= binn bin_small // => e1 [h0 /esym/eqP].
rewrite mulf_eq0 => /orP[/eqP h00|/eqP e10]; first by move/eqP: h0; rewrite h00 mul0r oner_eq0.
by move/eqP: e1; rewrite e10 mulr0 oner_eq0.
Qed.

(** ZW06.19 needs_binomials: where $C(n,i)=0$ in the field there is $s$ with which the points $\tau_i=1$, all others and all $p_j$ 0, solve the equation of (19)
    and not the system. *)
Theorem ZW06_19_needs_binomials n i : (i <= n)%N -> 'C(n, i)%:R = 0 :> F -> exists s, forall rho,
  (rho - 1)%:P *: pderiv (pbez n zero) = (n%:R * (1 - s))%:P *: pbez n (tip i) +
    ((1 - 'X) *: pderiv (pbez n (tip i)) + s%:P *: ('X *: pderiv (pbez n (tip i)))) /\
  ~ forall j, (j <= n)%N -> (n - j)%:R *: gap zero (tip i) rho s j + j%:R *: prev (gap zero (tip i) rho s) j = 0.
Proof.
move=> le_i e; have lt_i : (i < n)%N.
  by rewrite ltn_neqAle le_i andbT; apply/eqP=> ei; move/eqP: e; rewrite ei binn oner_eq0.
have i1 : (0 < i)%N by case: (i) e => // /eqP; rewrite bin0 oner_eq0.
have gapE rho s j : gap zero (tip i) rho s j = s *: tip i j - tip i j.+1 by rewrite /gap /zero subrr scaler0 sub0r opprB.
have [i0|i0] := eqVneq (i%:R : F) 0; [exists 1 | exists 0] => rho; rewrite pbez0 hidden // deriv0 !scaler0 !addr0; split=> // h.
  have := h i.+1 lt_i; rewrite /prev /= !gapE line1 !mxE eqxx (gtn_eqF (ltnSn i)) (gtn_eqF (leqW (ltnSn i))).
  by rewrite !(mulr0, subr0, add0r, mulr1) -addn1 natrD i0 add0r => /eqP; rewrite oner_eq0.
have := h i le_i; rewrite /prev !gapE prednK // line1 !mxE eqxx (gtn_eqF (ltnSn i)).
by rewrite !(mul0r, mulr0, subr0, add0r, sub0r, mulrN, mulr1) => /eqP; rewrite ?oppr0 ?mulr0 ?add0r oppr_eq0 (negPf i0).
Qed.
End Nets.
