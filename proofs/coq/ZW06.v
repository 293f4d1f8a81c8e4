(* ZW06: developable Bezier surfaces through a directrix a(u), the Bezier curve of p_0, ..., p_n; the rulings are
   tau(u), with points tau_i = q_i - p_i.
   Definitions:
     rate n p i       the points (n-i) (p_{i+1} - p_i) + i (p_i - p_{i-1}) of a' in degree n
     gap p tau rho s i   what Aumann's equation (20) lacks at the cell i
     mean_step p i    A_i of ZW06.16, the sum of (j+1) (p_{j+1} - p_j) over j <= i, divided by (i+1)(i+2) *)
From Torse Require Import Prelude Blossom Curves Points Dependence Bernstein Bezier.

Section Condition.
Variable F : fieldType.
Implicit Types (p w : 'rV[{poly F}]_3) (a b : {poly F}).

(** ZW06.5 condition: $a(u)+v\tau(u)$ is developable, $[a',\tau,\tau']=0$, iff $Aa'+B\tau+C\tau'=0$ with polynomials $A,B,C$
    that are not all zero. *)
Theorem ZW06_5_condition p w : triple (pderiv p) w (pderiv w) = 0 <-> dependent (pderiv p) w (pderiv w).
Proof. exact: triple_dependent. Qed.

(** ZW06.9 derivative: for $a'=a\tau+b\tau'$ the curve $a_1=a(u)-b\tau$ has $a_1'=(a-b')\tau$. *)
Theorem ZW06_9_derivative p w a b : pderiv p = a *: w + b *: pderiv w -> pderiv (p - b *: w) = (a - b^`()) *: w.
Proof.
move=> e; apply/rowP=> k; have := congr1 (fun r : 'rV__ => r 0 k) e; rewrite !mxE derivB derivM => ->.
by move: (w 0 k) (w 0 k)^`() b^`() => x y z; ring.
Qed.

(** ZW06.11 cone: $a_1'=0$, so that all rulings pass through one point, iff $a=b'$.
    Hypotheses: the rulings do not vanish identically. *)
Theorem ZW06_11_cone p w a b : w != 0 -> pderiv p = a *: w + b *: pderiv w -> pderiv (p - b *: w) = 0 <-> a = b^`().
Proof.
move=> nz /ZW06_9_derivative ->; split=> [/eqP|->]; last by rewrite subrr scale0r.
by rewrite scalemx_eq0 (negPf nz) orbF subr_eq0 => /eqP.
Qed.
End Condition.

Section Nets.
Variables (F : fieldType) (m : nat).
Implicit Types (p tau : nat -> 'rV[F]_m) (n i : nat) (rho s : F).

Definition rate n p i := (n - i)%:R *: (p i.+1 - p i) + i%:R *: (p i - prev p i) : 'rV[F]_m.

Lemma pderiv_rate n p : pderiv (pbez n p) = pbez n (rate n p).
Proof. exact: deriv_pbez. Qed.

(** ZW06.17 solves: $\tau_i=(n-i)\Delta p_i+i\Delta p_{i-1}$ gives $a'=\tau$, in every field. *)
Theorem ZW06_17_solves n p tau : (forall i, (i <= n)%N -> tau i = rate n p i) -> pderiv (pbez n p) = pbez n tau.
Proof. by move=> e; rewrite pderiv_rate; apply: pbez_ext => i /e. Qed.

(** ZW06.17 unique: $a'=\tau$ ($a=1$, $b=0$) iff $\tau_i=(n-i)\Delta p_i+i\Delta p_{i-1}$.
    Hypotheses: no binomial coefficient $C(n,i)$ vanishes in the field, as in characteristic 0. *)
Theorem ZW06_17_unique n p tau : independent F n ->
  pderiv (pbez n p) = pbez n tau <-> forall i, (i <= n)%N -> tau i = rate n p i.
Proof. by move=> g; split=> [|/ZW06_17_solves //]; rewrite pderiv_rate pbez_inj // => e i /e. Qed.

Lemma recursion16 n p tau i : rate n p i = 2%:R *: tau i + i%:R *: (tau i - prev tau i) <-> (i + 2)%:R *: tau i = rate n p i + i%:R *: prev tau i.
Proof.
by apply: eq_of_diff; apply/rowP=> k; rewrite natrD !mxE;
  move: (rate n p i 0 k) (tau i 0 k) (prev tau i 0 k) (i%:R) => r x y j; ring.
Qed.

(** ZW06.16 solves: the recursion $(i+2)\tau_i=(n-i)\Delta p_i+i\Delta p_{i-1}+i\tau_{i-1}$ gives $a'=2\tau+u\tau'$, in every field. *)
Theorem ZW06_16_solves n p tau : (forall i, (i <= n)%N -> (i + 2)%:R *: tau i = rate n p i + i%:R *: prev tau i) ->
  pderiv (pbez n p) = 2%:R%:P *: pbez n tau + 'X *: pderiv (pbez n tau).
Proof. by move=> e; rewrite pderiv_rate X_deriv_pbez pbez_scale pbez_add; apply: pbez_ext => i /e/recursion16. Qed.

(** ZW06.16 recursion: $a'=2\tau+u\tau'$ iff $(i+2)\tau_i=(n-i)\Delta p_i+i\Delta p_{i-1}+i\tau_{i-1}$.
    Hypotheses: no binomial coefficient $C(n,i)$ vanishes in the field, as in characteristic 0. *)
Theorem ZW06_16_recursion n p tau : independent F n ->
  pderiv (pbez n p) = 2%:R%:P *: pbez n tau + 'X *: pderiv (pbez n tau) <->
  forall i, (i <= n)%N -> (i + 2)%:R *: tau i = rate n p i + i%:R *: prev tau i.
Proof.
by move=> g; split=> [|/ZW06_16_solves //]; rewrite pderiv_rate X_deriv_pbez pbez_scale pbez_add pbez_inj // => e i /e/recursion16.
Qed.

Lemma recursion18 p tau i : i%:R *: (p i - prev p i) = tau i + i%:R *: (tau i - prev tau i) <->
  i.+1%:R *: tau i = i%:R *: (p i - prev p i + prev tau i).
Proof.
by apply: eq_of_diff; apply/rowP=> k; rewrite -[i.+1]addn1 natrD !mxE;
  move: (p i 0 k) (prev p i 0 k) (tau i 0 k) (prev tau i 0 k) (i%:R) => p1 p0 x y j; ring.
Qed.

(** ZW06.18 solves: the recursion $(i+1)\tau_i=i(\Delta p_{i-1}+\tau_{i-1})$ gives $u\,a'=\tau+u\tau'$, in every field. *)
Theorem ZW06_18_solves n p tau : (forall i, (i <= n)%N -> i.+1%:R *: tau i = i%:R *: (p i - prev p i + prev tau i)) ->
  'X *: pderiv (pbez n p) = pbez n tau + 'X *: pderiv (pbez n tau).
Proof. by move=> e; rewrite !X_deriv_pbez pbez_add; apply: pbez_ext => i /e/recursion18. Qed.

(** ZW06.18 recursion: $u\,a'=\tau+u\tau'$ ($a=1/u$, $b=1$) iff $q_0=p_0$ and $q_i=p_i+\frac{i}{i+1}(p_i+q_{i-1}-2p_{i-1})$, that is
    $(i+1)\tau_i=i(\Delta p_{i-1}+\tau_{i-1})$.
    Hypotheses: no binomial coefficient $C(n,i)$ vanishes in the field, as in characteristic 0. *)
Theorem ZW06_18_recursion n p tau : independent F n ->
  'X *: pderiv (pbez n p) = pbez n tau + 'X *: pderiv (pbez n tau) <->
  forall i, (i <= n)%N -> i.+1%:R *: tau i = i%:R *: (p i - prev p i + prev tau i).
Proof.
by move=> g; split=> [|/ZW06_18_solves //]; rewrite !X_deriv_pbez pbez_add pbez_inj // => e i /e/recursion18.
Qed.

(** ZW06.12 solves: a row with $\Delta\tau_i=(\rho-1)\Delta p_i$, such as $q_i=q_0+\rho(p_i-p_0)$, has $(\rho-1)a'=\tau'$, in every field. *)
Theorem ZW06_12_solves n p tau rho : (forall i, (i < n)%N -> tau i.+1 - tau i = (rho - 1) *: (p i.+1 - p i)) ->
  (rho - 1)%:P *: pderiv (pbez n p) = pderiv (pbez n tau).
Proof.
move=> e; rewrite !pderiv_rate pbez_scale; apply: pbez_ext => i le_i; rewrite /rate scalerDr !scalerA ![(rho - 1) * _]mulrC -!scalerA.
congr (_ + _); first by have [lt_i|ge_i] := ltnP i n; [rewrite e | rewrite (_ : n - i = 0)%N ?scale0r //; lia].
by case: i le_i => [|i] lt_i; rewrite ?scale0r // /prev e.
Qed.

(** ZW06.12 unique: $(\rho-1)a'=\tau'$ ($a=0$, $b=1/(\rho-1)$, a cone) iff $q_i=q_0+\rho(p_i-p_0)$.
    Hypotheses: $n!\ne0$ in the field. *)
Theorem ZW06_12_unique n p tau rho : good F n ->
  (rho - 1)%:P *: pderiv (pbez n p) = pderiv (pbez n tau) <->
  forall i, (i <= n)%N -> p i + tau i = p 0%N + tau 0%N + rho *: (p i - p 0%N).
Proof.
move=> g; have nz i := @good_nat _ n i g; rewrite !pderiv_rate pbez_scale (pbez_inj _ _ (good_independent g)).
pose h i := tau i - (rho - 1) *: p i; have eh i : (rho - 1) *: rate n p i = rate n tau i <-> rate n h i = 0.
  apply: eq_of_diff; apply/rowP=> k; rewrite /rate /h /prev !mxE;
  move: (p i.+1 0 k) (p i 0 k) (p i.-1 0 k) (tau i.+1 0 k) (tau i 0 k) (tau i.-1 0 k) (i%:R) ((n - i)%:R) => p2 p1 p0 x2 x1 x0 j l; ring.
have const : (forall i, (i <= n)%N -> rate n h i = 0) <-> forall i, (i <= n)%N -> h i = h 0%N.
  split=> [e|e i le_i]; last first.
    rewrite /rate /prev [h i]e //; have -> : h i.-1 = h 0%N by apply: e; lia.
    rewrite subrr scaler0 addr0; have [lt_i|le_n] := ltnP i n; first by rewrite e // subrr scaler0.
    by rewrite (_ : n - i = 0)%N ?scale0r //; lia.
  elim=> // i ih lt_i; rewrite -ih 1?ltnW //; move: {ih} i lt_i; elim=> [|i ih] lt_i.
    have := e 0%N isT; rewrite /rate scale0r addr0 subn0 => /eqP; rewrite scaler_eq0 (negPf (nz _ _)) ?subr_eq0 /=; last by lia.
    by move/eqP.
  have := e i.+1 (ltnW lt_i); rewrite /rate /prev /= (ih (ltnW lt_i)) subrr scaler0 addr0 => /eqP.
  by rewrite scaler_eq0 (negPf (nz _ _)) ?subr_eq0 /= => [/eqP|]; last by lia.
rewrite (_ : (forall i, _ -> (rho - 1) *: rate n p i = _) <-> (forall i, (i <= n)%N -> rate n h i = 0)); last first.
  by split=> e i /e /eh.
rewrite const; split=> e i /e; rewrite /h => {}e.
  have -> : tau i = (tau 0%N - (rho - 1) *: p 0%N) + (rho - 1) *: p i by rewrite -e subrK.
  by apply/rowP=> k; rewrite !mxE; move: (p i 0 k) (p 0%N 0 k) (tau 0%N 0 k) => p1 p0 x; ring.
have -> : tau i = p 0%N + tau 0%N + rho *: (p i - p 0%N) - p i by rewrite -e addrAC subrr add0r.
by apply/rowP=> k; rewrite !mxE; move: (p i 0 k) (p 0%N 0 k) (tau 0%N 0 k) => p1 p0 x; ring.
Qed.

Lemma recursion13 n p tau s : (forall i, (i <= n)%N -> rate n p i = s *: tau i + s *: (i%:R *: (tau i - prev tau i))) <->
  forall i, (i <= n)%N -> (i.+1%:R * s) *: tau i = (n - i)%:R *: p i.+1 + i.+1%:R *: p i - n.+1%:R *: p 0%N.
Proof.
pose S i := (i.+1%:R * s) *: tau i; pose T i := (n - i)%:R *: p i.+1 + i.+1%:R *: p i - n.+1%:R *: p 0%N.
have T0 : T 0%N = n%:R *: (p 1%N - p 0%N).
  by apply/rowP=> k; rewrite /T subn0 -[n.+1]addn1 natrD !mxE; move: (p 1%N 0 k) (p 0%N 0 k) (n%:R) => p1 p0 j; ring.
have Tr i : (i < n)%N -> T i.+1 - T i = rate n p i.+1.
  move=> lt_i; rewrite /T /rate /prev /= (_ : (n - i)%:R = (n - i.+1)%:R + 1); last by rewrite -subnSK // -addn1 natrD.
  have -> : i.+2%:R = i.+1%:R + 1 :> F by rewrite -[i.+2]addn1 natrD.
  apply/rowP=> k; rewrite !mxE.
  by move: (p i.+2 0 k) (p i.+1 0 k) (p i 0 k) (p 0%N 0 k) (i.+1%:R) ((n - i.+1)%:R) (n.+1%:R) => p3 p2 p1 p0 j l q; ring.
have Sr i : s *: tau i + s *: (i%:R *: (tau i - prev tau i)) = S i - (if i is j.+1 then S j else 0).
  case: i => [|i]; rewrite /S /prev; first by rewrite subr0 scale0r scaler0 addr0 mul1r.
  by apply/rowP=> k; rewrite -[i.+2]addn1 natrD !mxE; move: (tau i.+1 0 k) (tau i 0 k) (i.+1%:R) => x y j; ring.
split=> e.
  elim=> [|i ih] lt_i; have := e _ lt_i; rewrite Sr.
    by rewrite subr0 -/(S 0%N) -/(T 0%N) T0 /rate subn0 scale0r addr0.
  have hs : S i = T i by apply: ih; exact: ltnW.
  by move=> h; rewrite -/(S i.+1) -/(T i.+1) -[S i.+1](subrK (S i)) -h -Tr // hs subrK.
have hs i : (i <= n)%N -> S i = T i by move=> le_i; apply: e.
case=> [|i] lt_i; rewrite Sr hs //; first by rewrite subr0 T0 /rate subn0 scale0r addr0.
by rewrite hs ?Tr // ltnW.
Qed.

(** ZW06.13 solves: a row with $(i+1)s\tau_i=(n-i)p_{i+1}+(i+1)p_i-(n+1)p_0$ has $a'=s\tau+su\tau'$, in every field. *)
Theorem ZW06_13_solves n p tau s :
  (forall i, (i <= n)%N -> (i.+1%:R * s) *: tau i = (n - i)%:R *: p i.+1 + i.+1%:R *: p i - n.+1%:R *: p 0%N) ->
  pderiv (pbez n p) = s%:P *: pbez n tau + s%:P *: ('X *: pderiv (pbez n tau)).
Proof. by move/recursion13=> e; rewrite pderiv_rate X_deriv_pbez !pbez_scale pbez_add; apply: pbez_ext. Qed.

(** ZW06.13 unique: $a'=s\tau+su\tau'$ ($a=s$, $b=su$, the cone with vertex $p_0$) iff
    $(i+1)s\tau_i=(n-i)p_{i+1}+(i+1)p_i-(n+1)p_0$; for $i=n$ this is $q_n=p_n+(p_n-p_0)/s$.
    Hypotheses: no binomial coefficient $C(n,i)$ vanishes in the field, as in characteristic 0. *)
Theorem ZW06_13_unique n p tau s : independent F n ->
  pderiv (pbez n p) = s%:P *: pbez n tau + s%:P *: ('X *: pderiv (pbez n tau)) <->
  forall i, (i <= n)%N -> (i.+1%:R * s) *: tau i = (n - i)%:R *: p i.+1 + i.+1%:R *: p i - n.+1%:R *: p 0%N.
Proof. by move=> g; rewrite pderiv_rate X_deriv_pbez !pbez_scale pbez_add pbez_inj //; exact: recursion13. Qed.

Definition gap p tau rho s i : 'rV[F]_m := (rho - 1) *: (p i.+1 - p i) - (tau i.+1 - s *: tau i).

Lemma recursion19 n p tau rho s i : (i <= n)%N ->
  (rho - 1) *: rate n p i = (n%:R * (1 - s)) *: tau i + ((n - i)%:R *: (tau i.+1 - tau i) + s *: (i%:R *: (tau i - prev tau i)))
  <-> (n - i)%:R *: gap p tau rho s i + i%:R *: prev (gap p tau rho s) i = 0.
Proof.
move=> le_i; apply: (iff_trans (B := 0 = (n - i)%:R *: gap p tau rho s i + i%:R *: prev (gap p tau rho s) i)); last by split=> ->.
apply: eq_of_diff; rewrite /rate /gap /prev -{2}(subnK le_i) natrD; case: i {le_i} => [|i] /=.
  by apply/rowP=> k; rewrite subn0 !mxE; move: (p 1%N 0 k) (p 0%N 0 k) (tau 1%N 0 k) (tau 0%N 0 k) (n%:R) => p1 p0 x1 x0 j; ring.
apply/rowP=> k; rewrite !mxE; move: (p i.+2 0 k) (p i.+1 0 k) (p i 0 k) (tau i.+2 0 k) (tau i.+1 0 k) (tau i 0 k) (i.+1%:R) ((n - i.+1)%:R).
by move=> p2 p1 p0 x2 x1 x0 j l; ring.
Qed.

(** ZW06.19 system: $a'=a\tau+b\tau'$ with $a=\frac{n(1-s)}{\rho-1}$, $b=\frac{1-u+su}{\rho-1}$, here without the denominator, iff
    $(n-i)g_i+ig_{i-1}=0$, $i=0..n$, for the defects $g_i=(\rho-1)\Delta p_i-(\tau_{i+1}-s\tau_i)$ of (20).
    Hypotheses: no binomial coefficient $C(n,i)$ vanishes in the field, as in characteristic 0. *)
Theorem ZW06_19_system n p tau rho s : independent F n ->
  (rho - 1)%:P *: pderiv (pbez n p) =
    (n%:R * (1 - s))%:P *: pbez n tau + ((1 - 'X) *: pderiv (pbez n tau) + s%:P *: ('X *: pderiv (pbez n tau))) <->
  forall i, (i <= n)%N -> (n - i)%:R *: gap p tau rho s i + i%:R *: prev (gap p tau rho s) i = 0.
Proof.
move=> ind; rewrite pderiv_rate X_deriv_pbez Y_deriv_pbez !pbez_scale !pbez_add pbez_inj //.
by split=> h i le_i; [apply/recursion19/h | apply/(recursion19 _ _ _ _ le_i)/h].
Qed.

Lemma gap0 p tau rho s i (q := fun i => p i + tau i) :
  gap p tau rho s i = 0 <-> q i.+1 = p i + rho *: (p i.+1 - p i) + s *: (q i - p i).
Proof. by apply: eq_of_diff; rewrite /q /gap; by_entries k; ring. Qed.

(** ZW06.20 solves: Aumann's row $q_{i+1}=p_i+\rho(p_{i+1}-p_i)+s(q_i-p_i)$, $i=0..n-1$, obeys the equation of (19), without its denominator, in every field. *)
Theorem ZW06_20_solves n p tau rho s (q := fun i => p i + tau i) :
  (forall i, (i < n)%N -> q i.+1 = p i + rho *: (p i.+1 - p i) + s *: (q i - p i)) ->
  (rho - 1)%:P *: pderiv (pbez n p) =
    (n%:R * (1 - s))%:P *: pbez n tau + ((1 - 'X) *: pderiv (pbez n tau) + s%:P *: ('X *: pderiv (pbez n tau))).
Proof.
move=> h; rewrite pderiv_rate X_deriv_pbez Y_deriv_pbez !pbez_scale !pbez_add; apply: pbez_ext => i le_i; apply/recursion19 => //.
have none j : (j < n)%N -> gap p tau rho s j = 0 by move/h/gap0.
have -> : (n - i)%:R *: gap p tau rho s i = 0.
  by have [/none->|ge_i] := ltnP i n; [rewrite scaler0 | rewrite (_ : n - i = 0)%N ?scale0r //; lia].
by rewrite add0r; case: i le_i => [|i] lt_i; rewrite ?scale0r // /prev none ?scaler0.
Qed.

(** ZW06.20 unique: the equation of (19), without its denominator, holds iff $q_{i+1}=p_i+\rho(p_{i+1}-p_i)+s(q_i-p_i)$ (Aumann), $i=0..n-1$.
    Hypotheses: $n!\ne0$ in the field.
    Paper: sets $i=0$ and lets the defects vanish one after the other; that they must needs the hypothesis. *)
Theorem ZW06_20_unique n p tau rho s (q := fun i => p i + tau i) : good F n ->
  (rho - 1)%:P *: pderiv (pbez n p) =
    (n%:R * (1 - s))%:P *: pbez n tau + ((1 - 'X) *: pderiv (pbez n tau) + s%:P *: ('X *: pderiv (pbez n tau))) <->
  forall i, (i < n)%N -> q i.+1 = p i + rho *: (p i.+1 - p i) + s *: (q i - p i).
Proof.
move=> g; split=> [|/ZW06_20_solves //]; rewrite (ZW06_19_system _ _ _ _ (good_independent g)) => h.
suff all0 i : (i < n)%N -> gap p tau rho s i = 0 by move=> i /all0/gap0.
elim: i => [|i ih] lt_i; have := h _ (ltnW lt_i); rewrite /prev /= ?ih 1?ltnW // ?scaler0 ?scale0r addr0 => /eqP;
  by rewrite scaler_eq0 (negPf (good_nat g _)) => [/eqP|]; last by lia.
Qed.

Definition mean_step p i : 'rV[F]_m := (i.+1 * i.+2)%:R^-1 *: \sum_(0 <= j < i.+1) j.+1%:R *: (p j.+1 - p j).

Lemma mean_stepS p i : good F i.+2 ->
  i.+2%:R *: mean_step p i = i%:R *: mean_step p i.-1 + (p i.+1 - p i).
Proof.
move=> g; have nz j : (j < i.+2)%N -> j.+1%:R != 0 :> F by move=> lt_j; apply: (good_nat g).
rewrite /mean_step big_nat_recr //=; case: i g nz => [|i] g nz; rewrite natrM.
  by rewrite big_geq // add0r scale1r mul1r scalerA mulfV ?nz // scale1r scale0r add0r.
rewrite natrM; set T := \sum_(0 <= j < i.+1) _; apply/rowP=> k; rewrite !mxE.
move: (nz i (leqW (leqW (leqnn _)))) (nz i.+1 (leqW (leqnn _))) (nz i.+2 (leqnn _)).
move: (T 0 k) (p i.+2 0 k) (p i.+1 0 k) => t p2 p1.
have -> : i.+3%:R = i.+1%:R + 2 :> F by rewrite -addn2 natrD.
have -> : i.+2%:R = i.+1%:R + 1 :> F by rewrite -addn1 natrD.
by move: (i.+1%:R) => j n1 n2 n3; field; rewrite n1 n2 n3.
Qed.

(** ZW06.16 closed: $\tau_i=(n-i)A_i+iA_{i-1}$ with $A_i=\frac1{(i+1)(i+2)}\sum_{j\le i}(j+1)\Delta p_j$ solves $a'=2\tau+u\tau'$.
    Hypotheses: $(n+1)!\ne0$ in the field, so that the $A_i$ have a meaning. *)
Theorem ZW06_16_closed n p : good F n.+1 ->
  let tau := fun i => (n - i)%:R *: mean_step p i + i%:R *: mean_step p i.-1 in
  pderiv (pbez n p) = 2%:R%:P *: pbez n tau + 'X *: pderiv (pbez n tau).
Proof.
move=> g tau; apply/ZW06_16_recursion => [|i le_i]; first exact: good_independent (good_le (leqnSn n) g).
have step j : (j < n)%N -> j.+2%:R *: mean_step p j = j%:R *: mean_step p j.-1 + (p j.+1 - p j).
  by move=> lt_j; apply: mean_stepS; apply: good_le g.
have last j : (j <= n)%N -> (n - j)%:R *: (p j.+1 - p j) = (n - j)%:R *: (j.+2%:R *: mean_step p j - j%:R *: mean_step p j.-1).
  rewrite leq_eqVlt => /orP[/eqP ->|/step ->]; first by rewrite subnn !scale0r.
  by congr (_ *: _); rewrite addrAC subrr add0r.
rewrite /rate /prev /tau last //; case: i le_i => [|i] lt_i /=.
  by rewrite !subn0 !mulr0n !scale0r !addr0 !subr0; move: (mean_step p 0) => A; rewrite !scalerA mulrC.
have -> : p i.+1 - p i = i.+2%:R *: mean_step p i - i%:R *: mean_step p i.-1 by rewrite (step i lt_i) addrAC subrr add0r.
rewrite (_ : (n - i)%:R = (n - i.+1)%:R + 1 :> F); last by rewrite -subnSK // -addn1 natrD.
move: (mean_step p i.+1) (mean_step p i) (mean_step p i.-1) ((n - i.+1)%:R) => x y z k.
rewrite addn2 -!(addn1 _.+1) -!(addn1 i) !natrD.
by apply/rowP=> q; rewrite !mxE; move: (x 0 q) (y 0 q) (z 0 q) (i%:R) => x1 y1 z1 j; ring.
Qed.

End Nets.
