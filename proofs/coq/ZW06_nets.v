(* ZW06: the second rows q_i = p_i + tau_i as the paper prints them, with denominators and in closed form, and Aumann's surfaces
   as those of FJ07.
   Definitions:
     edges p i    p_i - p_{i-1} *)
From Torse Require Import Prelude Blossom Curves Points Bernstein Bezier ZW06 FJ07_3_net FJ07_3_blossoms.

Section Nets.
Variables (F : fieldType) (m : nat).
Implicit Types (p q tau : nat -> 'rV[F]_m) (n i : nat) (rho s : F).

Lemma divided (a : F) (x y : 'rV[{poly F}]_m) : a != 0 -> a%:P *: x = y <-> x = a^-1%:P *: y.
Proof.
move=> nz; split=> [<-|->]; by rewrite scalerA -polyCM ?mulVf ?mulfV // scale1r.
Qed.

Lemma same_difference (a b a' b' : 'rV[F]_m) : a - b = a' - b' -> a = b <-> a' = b'.
Proof. by move=> e; split=> h; apply/eqP; [rewrite -subr_eq0 -e | rewrite -subr_eq0 e]; rewrite h subrr. Qed.

(** ZW06.12 cone: for $a=0$, $b=1/(\rho-1)$ the equation $a'=\frac1{\rho-1}\tau'$ holds iff $q_i=q_0+\rho(p_i-p_0)$.
    Hypotheses: $n!\ne0$ in the field; $\rho\ne1$, so that $b$ has a meaning. *)
Theorem ZW06_12_cone n p tau rho (q := fun i => p i + tau i) : good F n -> rho - 1 != 0 ->
  pderiv (pbez n p) = (rho - 1)^-1%:P *: pderiv (pbez n tau) <->
  forall i, (i <= n)%N -> q i = q 0%N + rho *: (p i - p 0%N).
Proof. by move=> g nz; rewrite -divided //; exact: ZW06_12_unique. Qed.

(** ZW06.13 closed: for $a=s$, $b=su$ the equation holds iff $q_i=p_i+\frac{(n-i)p_{i+1}+(i+1)p_i-(n+1)p_0}{(i+1)s}$.
    Hypotheses: $s\ne0$ and $(n+1)!\ne0$ in the field, so that the quotients have a meaning; no $C(n,i)$ vanishes then. *)
Theorem ZW06_13_closed n p tau s (q := fun i => p i + tau i) : good F n.+1 -> s != 0 ->
  pderiv (pbez n p) = s%:P *: pbez n tau + (s%:P * 'X) *: pderiv (pbez n tau) <->
  forall i, (i <= n)%N -> q i = p i + (i.+1%:R * s)^-1 *: ((n - i)%:R *: p i.+1 + i.+1%:R *: p i - n.+1%:R *: p 0%N).
Proof.
move=> g nz; rewrite -scalerA ZW06_13_unique; last exact: good_independent (good_le (leqnSn n) g).
have d0 i : (i <= n)%N -> i.+1%:R * s != 0 by move=> le_i; rewrite mulf_neq0 // (good_nat g).
split=> h i le_i; first by rewrite /q -h // scalerA mulVf ?d0 // scale1r.
by have := h i le_i => /addrI ->; rewrite scalerA mulfV ?d0 // scale1r.
Qed.

Definition edges p i : 'rV[F]_m := p i - p i.-1.

(** ZW06.18 closed: $u\,a'=\tau+u\tau'$ iff $\tau_i=\frac1{i+1}\sum_{j\le i}j\,\Delta p_{j-1}$.
    Hypotheses: $(n+1)!\ne0$ in the field, so that the quotients have a meaning; no $C(n,i)$ vanishes then. *)
Theorem ZW06_18_closed n p tau : good F n.+1 ->
  'X *: pderiv (pbez n p) = pbez n tau + 'X *: pderiv (pbez n tau) <->
  forall i, (i <= n)%N -> tau i = i.+1%:R^-1 *: \sum_(0 <= j < i.+1) j%:R *: edges p j.
Proof.
move=> g; rewrite ZW06_18_recursion; last exact: good_independent (good_le (leqnSn n) g).
have nz i : (i <= n)%N -> i.+1%:R != 0 :> F by move=> le_i; apply: (good_nat g).
pose S i := \sum_(0 <= j < i.+1) j%:R *: edges p j.
have S0 : S 0%N = 0 by rewrite /S big_nat1 scale0r.
have Sr i : S i.+1 = S i + i.+1%:R *: edges p i.+1 by rewrite /S big_nat_recr.
rewrite -/(S _); split=> h.
  suff hS i : (i <= n)%N -> i.+1%:R *: tau i = S i.
    by move=> i le_i; rewrite -/(S i) -hS // scalerA mulVf ?nz // scale1r.
  elim: i => [|i ih] le_i; first by rewrite h // S0 scale0r.
  by rewrite h // /prev /= scalerDr ih ?Sr 1?addrC // ltnW.
have {}h i : (i <= n)%N -> i.+1%:R *: tau i = S i.
  by move=> le_i; rewrite h // -/(S i) scalerA mulfV ?nz // scale1r.
case=> [|i] le_i; first by rewrite h // S0 scale0r.
by rewrite h // Sr -h 1?ltnW // /prev /= [RHS]scalerDr [RHS]addrC.
Qed.

(** ZW06.16 unique: $a'=2\tau+u\tau'$ iff $\tau_i=(n-i)A_i+iA_{i-1}$ with $A_i=\frac1{(i+1)(i+2)}\sum_{j\le i}(j+1)\Delta p_j$.
    Hypotheses: $n+2\ne0$ in the field; $(n+1)!\ne0$, so that the $A_i$ have a meaning. *)
Theorem ZW06_16_unique n p tau : n.+2%:R != 0 :> F -> good F n.+1 ->
  pderiv (pbez n p) = 2%:R%:P *: pbez n tau + 'X *: pderiv (pbez n tau) <->
  forall i, (i <= n)%N -> tau i = (n - i)%:R *: mean_step p i + i%:R *: mean_step p i.-1.
Proof.
move=> n2 g; have ind : independent F n by exact: good_independent (good_le (leqnSn n) g).
have := ZW06_16_closed p g; cbv zeta; set sol := fun i => _; rewrite [_ = _ + _](ZW06_16_recursion _ sol ind) => closed.
split=> [/(ZW06_16_recursion _ _ ind) h|h]; last first.
  by apply/(ZW06_16_recursion _ _ ind) => i le_i; rewrite h // closed //; case: i le_i => [|i] le_i; rewrite /prev //= h // ltnW.
have nz i : (i <= n)%N -> (i + 2)%:R != 0 :> F.
  by rewrite addn2 leq_eqVlt => /orP[/eqP -> //|lt_i]; apply: (good_nat g).
suff e i : (i <= n)%N -> tau i = sol i by [].
elim: i => [|i ih] le_i; apply: (scalerI (nz _ le_i)); rewrite h ?closed // /prev /=; first by rewrite !scale0r.
by rewrite ih // ltnW.
Qed.

(** ZW06.19 aumann: $a'=a\tau+b\tau'$ with $a=\frac{n(1-s)}{\rho-1}$, $b=\frac{1-u+su}{\rho-1}$ iff $q_{i+1}=p_i+\rho(p_{i+1}-p_i)+s(q_i-p_i)$.
    Hypotheses: $n!\ne0$ in the field; $\rho\ne1$, so that $a$ and $b$ have a meaning. *)
Theorem ZW06_19_aumann n p tau rho s (q := fun i => p i + tau i)
    (a := (n%:R * (1 - s) / (rho - 1))%:P) (b := (rho - 1)^-1%:P * (1 - 'X + s%:P * 'X)) : good F n -> rho - 1 != 0 ->
  pderiv (pbez n p) = a *: pbez n tau + b *: pderiv (pbez n tau) <->
  forall i, (i < n)%N -> q i.+1 = p i + rho *: (p i.+1 - p i) + s *: (q i - p i).
Proof.
move=> g nz; rewrite -ZW06_20_unique // divided //.
suff -> : a *: pbez n tau + b *: pderiv (pbez n tau) = (rho - 1)^-1%:P *: ((n%:R * (1 - s))%:P *: pbez n tau
  + ((1 - 'X) *: pderiv (pbez n tau) + s%:P *: ('X *: pderiv (pbez n tau)))) by [].
rewrite /a /b polyCM; move: (pbez n tau) (pderiv (pbez n tau)) => x y.
by by_entries k; ring.
Qed.

(** ZW06.20 closed: Aumann's points are $\tau_i=s^i\tau_0+(\rho-1)\sum_{j<i}s^{i-1-j}\Delta p_j$. *)
Theorem ZW06_20_closed n p tau rho s (q := fun i => p i + tau i) :
  (forall i, (i < n)%N -> q i.+1 = p i + rho *: (p i.+1 - p i) + s *: (q i - p i)) <->
  forall i, (i <= n)%N -> tau i = s ^+ i *: tau 0%N + (rho - 1) *: \sum_(0 <= j < i) s ^+ (i.-1 - j) *: (p j.+1 - p j).
Proof.
pose T i := s ^+ i *: tau 0%N + (rho - 1) *: \sum_(0 <= j < i) s ^+ (i.-1 - j) *: (p j.+1 - p j).
have Tr i : T i.+1 = (rho - 1) *: (p i.+1 - p i) + s *: T i.
  rewrite /T big_nat_recr //= subnn expr0 scale1r.
  rewrite (eq_big_nat _ _ (F2 := fun j => s *: (s ^+ (i.-1 - j) *: (p j.+1 - p j)))); last first.
    by move=> j /andP[_ lt_j]; rewrite scalerA -exprS; congr (s ^+ _ *: _); lia.
  rewrite -scaler_sumr exprS; move: (\sum_(0 <= j < i) _) (s ^+ i) => S r.
  by apply/rowP=> k; rewrite !mxE; move: (S 0 k) (tau 0%N 0 k) (p i.+1 0 k) (p i 0 k) => x y z w; ring.
have step i : q i.+1 = p i + rho *: (p i.+1 - p i) + s *: (q i - p i) <-> tau i.+1 = (rho - 1) *: (p i.+1 - p i) + s *: tau i.
  by apply: same_difference; rewrite /q; by_entries k; ring.
have T0 : T 0%N = tau 0%N by rewrite /T expr0 scale1r big_geq // scaler0 addr0.
rewrite -[X in _ <-> X]/(forall i, (i <= n)%N -> tau i = T i); move: T T0 Tr => T' T0 Tr.
split=> h; last by move=> i lt_i; apply/step; rewrite (h _ lt_i) (h _ (ltnW lt_i)).
elim=> [|i ih] le_i; first by rewrite T0.
by have /step -> := h i le_i; rewrite Tr (ih (ltnW le_i)).
Qed.

(** ZW06.20 fj07: Aumann's equation is FJ07.12 with the constants $\Lambda=\frac\rho{1-s}$, $M=\frac1{1-s}$ ($\lambda=\rho$, $\mu=s$ of FJ07).
    Hypotheses: $s\ne1$, so that $\Lambda$, $M$ have a meaning; for $s=1$ it is the cone of ZW06.12. *)
Theorem ZW06_20_fj07 p q rho s i (L := rho / (1 - s)) (M := (1 - s)^-1) : 1 - s != 0 ->
  q i.+1 = p i + rho *: (p i.+1 - p i) + s *: (q i - p i) <->
  (1 - L) *: p i + L *: p i.+1 = (1 - M) *: q i + M *: q i.+1.
Proof.
move=> nz; have M0 : M != 0 by rewrite /M invr_eq0.
have el : L / M = rho by rewrite /L /M invrK divfK.
have em : 1 - M^-1 = s by rewrite /M invrK; ring.
rewrite FJ07_12_barycentric // el em.
by apply: same_difference; by_entries k; ring.
Qed.

(** ZW06.20 blossoms: so the method of ZW06 with (19) and that of FJ07 give the same surfaces: $a'=a\tau+b\tau'$ with $a,b$ of (19) iff
    $p[v_1,\dots,v_{n-1},\Lambda]=q[v_1,\dots,v_{n-1},M]$.
    Hypotheses: $n!\ne0$ in the field; $\rho\ne1$, $s\ne1$, so that $a$, $b$ and $\Lambda$, $M$ have a meaning. *)
Theorem ZW06_20_blossoms n p tau rho s (q := fun i => p i + tau i)
    (a := (n%:R * (1 - s) / (rho - 1))%:P) (b := (rho - 1)^-1%:P * (1 - 'X + s%:P * 'X)) : good F n -> rho - 1 != 0 -> 1 - s != 0 ->
  pderiv (pbez n p) = a *: pbez n tau + b *: pderiv (pbez n tau) <->
  related (step01 F n) n (rho / (1 - s)) (1 - s)^-1 p q.
Proof.
move=> g nr ns; rewrite ZW06_19_aumann // FJ07_C1_blossoms.
by split=> h i /h; rewrite -/(q _) -?ZW06_20_fj07 //; move/(iffRL (ZW06_20_fj07 _ _ _ _ ns)).
Qed.
End Nets.
