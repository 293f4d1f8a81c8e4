(* Blossoms: what happens without the hypotheses of the theorems, one counterexample each, over any field. Where knots do not carry a piece a step divides by 0;
   the examples hold for every number k in the place of 1/0.
   Definitions:
     divided k a b    a / b, and a k where b = 0
     blossom_with k u c v, pblossom_with k u c v   blossoms whose steps divide so
     curve_with k n u c, velocity_with k n u c     curves and their velocities; pcurve_with, pvelocity_with those of points
     listed s i       member i of the list s of numbers
     bent             the knots 0, 1, 0, 0 of degree 2: of the denominators of the steps only u_2 - u_0 vanishes *)
From Torse Require Import Prelude Blossom Curves Points.

Section Divided.
Variable R : comUnitRingType.
Implicit Types (u c : nat -> R) (x : R * R) (v : seq (R * R)) (k a b : R).

Definition divided k a b := if b == 0 then a * k else a / b.
Definition step_with k u m x c i := divided k ((x.2 * u (i + m)%N - x.1) * c i + (x.1 - x.2 * u i) * c i.+1) (u (i + m)%N - u i).
Fixpoint blossom_with k u c v := if v is x :: v' then blossom_with k (shift u) (step_with k u (size v) x c) v' else c 0%N.

Lemma blossom_with_ext k u c c' v : (forall i, (i <= size v)%N -> c i = c' i) -> blossom_with k u c v = blossom_with k u c' v.
Proof.
elim: v u c c' => [|x v ih] u c c' e /=; first exact: e.
by apply: ih => i le_i; rewrite /step_with !e //=; lia.
Qed.

(* Where the knots carry the piece nothing is divided by 0; and 0 in the place of 1/0 is what mathcomp takes. *)
Lemma blossom_with_span k u c v : span (size v) u -> blossom_with k u c v = blossom u c v.
Proof.
elim: v u c => [|x v ih] u c //= sp; rewrite ih; last exact: span_shift.
apply: blossom_ext => i le_i; rewrite /step_with /divided; case: eqP => // e; have := sp i (i + (size v).+1)%N.
by rewrite e unitr0 => sp0; suff : false by []; apply: sp0; lia.
Qed.

Lemma blossom_with0 u c v : blossom_with 0 u c v = blossom u c v.
Proof.
elim: v u c => [|x v ih] u c //=; rewrite ih; apply: blossom_ext => i _.
by rewrite /step_with /divided; case: eqP => // e; rewrite /step e invr0.
Qed.
Lemma divided0 k a b : b = 0 -> divided k a b = a * k.
Proof. by move=> ->; rewrite /divided eqxx. Qed.

Lemma divided1 k a b : b = 1 -> divided k a b = a.
Proof. by move=> ->; rewrite /divided oner_eq0 divr1. Qed.

Lemma dividedN1 k a b : b = -1 -> divided k a b = - a.
Proof. by move=> ->; rewrite /divided oppr_eq0 oner_eq0 invrN invr1 mulrN1. Qed.

(* The two steps over the knots 0, 1, 0, 0. *)
Lemma bent_steps u c k x y : u 0%N = 0 -> u 1%N = 1 -> u 2%N = 0 -> u 3%N = 0 -> blossom_with k u c [:: x; y]
  = y.1 * (x.1 * (c 1%N - c 0%N) * k) + (y.2 - y.1) * (x.1 * c 1%N + (x.2 - x.1) * c 2%N).
Proof.
move=> u0 u1 u2 u3; rewrite /= /step_with /shift /= u0 u1 u2 u3 (divided0 _ _ (subrr 0)) !(dividedN1 _ _ (sub0r 1)).
by move: (c 0%N) (c 1%N) (c 2%N) x.1 x.2 y.1 y.2 => *; ring.
Qed.
End Divided.

Section Curves.
Variables (F : fieldType) (m : nat).
Implicit Types (u c : nat -> F) (p : nat -> 'rV[F]_m) (k : F) (n : nat).

Definition curve_with k n u c := blossom_with k%:P (polys u) (polys c) (nseq n (at_ 'X)).
Definition velocity_with k n u c := blossom_with k%:P (polys u) (polys c) (direction _ :: nseq n.-1 (at_ 'X)).
Definition pblossom_with k u p v : 'rV[F]_m := \row_j blossom_with k u (coord p j) v.
Definition pcurve_with k n u p : 'rV[{poly F}]_m := \row_j curve_with k n u (coord p j).
Definition pvelocity_with k n u p : 'rV[{poly F}]_m := \row_j velocity_with k n u (coord p j).
End Curves.

Section Blossoms.
Variable F : fieldType.
Implicit Types (u c : nat -> F) (k : F).

Definition listed (s : seq F) i := nth 0 s i.
Definition bent : nat -> F := listed [:: 0; 1; 0; 0].

Lemma bent_curve k (c : nat -> F) : curve_with k 2 bent c
  = 'X * ('X * (c 1%N - c 0%N)%:P * k%:P) + (1 - 'X) * ((c 1%N)%:P * 'X + (c 2%N)%:P * (1 - 'X)).
Proof.
rewrite /curve_with bent_steps /polys /bent /listed /= ?polyC0 ?polyC1 // polyCB.
by move: (c 0%N)%:P (c 1%N)%:P (c 2%N)%:P k%:P 'X => *; ring.
Qed.

Lemma bent_velocity k (c : nat -> F) : velocity_with k 2 bent c = 'X * ((c 1%N - c 0%N)%:P * k%:P) + (1 - 'X) * ((c 1%N)%:P - (c 2%N)%:P).
Proof.
rewrite /velocity_with bent_steps /polys /bent /listed /= ?polyC0 ?polyC1 // polyCB.
by move: (c 0%N)%:P (c 1%N)%:P (c 2%N)%:P k%:P 'X => *; ring.
Qed.

Lemma bent_blossom k (c : nat -> F) a x : blossom_with k bent c [:: at_ a; x]
  = x.1 * (a * (c 1%N - c 0%N) * k) + (x.2 - x.1) * (a * c 1%N + (1 - a) * c 2%N).
Proof. by rewrite bent_steps. Qed.

(** blossoms needs_span: where $u_0=u_1$ in degree 1 the arguments of $c_0$ and $c_1$ are the same: no function has both values. *)
Theorem blossoms_needs_span u : u 0%N = u 1%N -> knots u 0 1 = knots u 1 1.
Proof. by rewrite /knots /= => ->. Qed.

(** blossoms symmetric_needs_span: over the knots $0,1,0,0$ the points $1,1,0$ give $c[1,0]=1$ and $c[0,1]=0$ whatever stands for $\frac10$: where
    $u_2=u_0$ the order of the arguments matters. *)
Theorem blossoms_symmetric_needs_span k (c := listed [:: 1; 1; 0]) :
  blossom_with k bent c [:: at_ 1; at_ 0] <> blossom_with k bent c [:: at_ 0; at_ 1].
Proof.
by rewrite !bent_blossom /c /listed /= ?(subrr, subr0, sub0r, mul0r, mulr0, mul1r, mulr1, addr0, add0r) => /eqP; rewrite oner_eq0.
Qed.

(** blossoms injective_needs_span: over the knots $0,0$ of degree 1 the blossoms of the points $0,0$ and of $1,1$ are the same, whatever stands for $\frac10$. *)
Theorem blossoms_injective_needs_span k x : blossom_with k (listed [::]) (fun=> 0) [:: x] = blossom_with k (listed [::]) (fun=> 1) [:: x].
Proof. by rewrite /= /step_with /listed !nth_nil !divided0 ?subrr //; ring. Qed.

(** blossoms unique_needs_span: the symmetric linear function $f(a,w)=w$ is not the blossom of its values over the knots $0,0$, whatever stands for $\frac10$. *)
Theorem blossoms_unique_needs_span (f := fun v : seq (F * F) => if v is [:: x] then x.2 else 0) :
  polar 1 f /\ forall k, f [:: at_ 0] <> blossom_with k (listed [::]) (fun i => f (knots (listed [::]) i 1)) [:: at_ 0].
Proof.
split=> [|k]; last by rewrite /= /step_with /listed divided0 ?subrr // ?(mulr0, mul0r, subr0, addr0) => /eqP; rewrite oner_eq0.
split=> [[|x [|y v]] [|z [|t w]] // eq_vw|s x t y [|//] _] //; try by have := perm_size eq_vw.
by have := perm_mem eq_vw x; rewrite !inE eqxx => /esym/eqP ->.
Qed.

(** blossoms unique_needs_linear: $f(a,w)=aw$ is not linear and not the blossom of its values over the knots $0,1$. *)
Theorem blossoms_unique_needs_linear (u := listed [:: 0; 1]) (f := fun v : seq (F * F) => if v is [:: x] then x.1 * x.2 else 0) :
  f [:: direction F] <> blossom u (fun i => f (knots u i 1)) [:: direction F].
Proof.
rewrite /= /step /u /listed /= !mul0r !mulr0 !subr0 divr1 !mulr1 add0r => /eqP.
by rewrite eq_sym oner_eq0.
Qed.

(** blossoms unique_needs_symmetric: $f[x,y]$, the parameter of $x$ times the weight of $y$, is linear in each argument but not symmetric, and
    not the blossom of its values over the knots $0,0,1,1$. *)
Theorem blossoms_unique_needs_symmetric (u := listed [:: 0; 0; 1; 1])
    (f := fun v : seq (F * F) => if v is [:: x; y] then x.1 * y.2 else 0) :
  f [:: at_ 1; at_ 0] <> blossom u (fun i => f (knots u i 2)) [:: at_ 1; at_ 0].
Proof.
rewrite /= /step /shift /u /listed /= ?(mul0r, mulr0, mul1r, mulr1, subr0, sub0r, add0r, addr0, subrr, divr1) => /eqP.
by rewrite oppr0 oner_eq0.
Qed.

(** blossoms derivative_needs_span: knots $0,1,0,0$ of degree 2 with $u_2=u_0$: of the points $1,1,0$ the curve would be $(1-t)t$, of the derivative $1$ at $t=0$, and the
    rule gives $2(1-t)$, whatever stands for $\frac10$. *)
Theorem blossoms_derivative_needs_span k (c := listed [:: 1; 1; 0]) : (curve_with k 2 bent c)^`() <> velocity_with k 2 bent c *+ 2.
Proof.
rewrite bent_curve bent_velocity /c /listed /= polyC0 polyC1 subrr polyC0 !(mul0r, mulr0, addr0, add0r) mul1r subr0 mulr1.
move/(congr1 (fun p => p.[0])); rewrite mulr2n derivM derivB derivX derivC sub0r !hornerE /=.
by move/eqP; rewrite !subr0 eq_sym -subr_eq0 addrK oner_eq0.
Qed.

End Blossoms.

(* No power of a rational number is 2. *)
Lemma no_root k (x : rat) : (1 < k)%N -> x ^+ k != 2%:R.
Proof.
move=> lt_k; apply/eqP; rewrite -[x]divq_num_den exprMn exprVn => /(canRL (divfK _)) e.
have {e} e : numq x ^+ k = 2%:R * denq x ^+ k.
  by apply: (@intr_inj rat_numDomainType); rewrite rmorphX /= e ?expf_neq0 ?intr_eq0 ?denq_neq0 // rmorphM rmorphX.
have d0 : (0 < `|denq x| ^ k)%N by rewrite expn_gt0 absz_gt0 denq_neq0.
have : (`|numq x| ^ k = 2 * `|denq x| ^ k)%N by rewrite -!abszX e abszM.
move/(congr1 (logn 2)); rewrite lognM // !lognX [logn 2 2]logn_prime // eqxx => /(congr1 (fun r => r %% k)%N).
by rewrite modnMr -modnDmr modnMr addn0 modn_small.
Qed.
