(* Blossoms: what happens without the hypotheses of the theorems, one counterexample each, over any field.
   Definitions:
     listed s i       member i of the list s of numbers
     bent             the knots 0, 1, 0, 0 of degree 2: of the denominators of the steps only u_2 - u_0 vanishes *)
From Torse Require Import Prelude Blossom Curves Points.

Section Blossoms.
Variable F : fieldType.
Implicit Types (u c : nat -> F).

Definition listed (s : seq F) i := nth 0 s i.
Definition bent : nat -> F := listed [:: 0; 1; 0; 0].

Lemma bent_curve (c : nat -> F) : curve 2 bent c = (1 - 'X) * ((c 1%N)%:P * 'X + (c 2%N)%:P * (1 - 'X)).
Proof.
rewrite /curve /= /step /shift /polys /bent /listed /= polyC0 polyC1 !subrr !invr0 !mulr0 !mul1r add0r.
by rewrite !sub0r ?invrN invr1 !mulrN1; move: (c 1%N)%:P (c 2%N)%:P 'X => x y z; ring.
Qed.

Lemma bent_velocity (c : nat -> F) : velocity 2 bent c = (1 - 'X) * ((c 1%N)%:P - (c 2%N)%:P).
Proof.
rewrite /velocity /= /step /shift /polys /bent /listed /= polyC0 polyC1 !subrr !invr0 !mulr0 !mul0r !mul1r add0r.
by rewrite !sub0r ?invrN invr1 !mulrN1; move: (c 1%N)%:P (c 2%N)%:P 'X => x y z; ring.
Qed.

Lemma bent_blossom (c : nat -> F) a x : blossom bent c [:: at_ a; x] = (x.2 - x.1) * (a * c 1%N + (1 - a) * c 2%N).
Proof.
rewrite /= /step /shift /bent /listed /= !subrr !invr0 !mulr0 !mul1r add0r.
by rewrite !sub0r ?invrN invr1 !mulrN1; move: (c 1%N) (c 2%N) x.1 x.2 => p q y z; ring.
Qed.


(** blossoms needs_span: where $u_0=u_1$ in degree 1 the arguments of $c_0$ and $c_1$ are the same: no function has both values. *)
Theorem blossoms_needs_span u : u 0%N = u 1%N -> knots u 0 1 = knots u 1 1.
Proof. by rewrite /knots /= => ->. Qed.

(** blossoms symmetric_needs_span: over the knots $0,1,0,0$ the points $0,1,0$ give $c[1,0]=1$ and $c[0,1]=0$ when $x/0=0$: where
    $u_2=u_0$ the order of the arguments matters. *)
Theorem blossoms_symmetric_needs_span (c := listed [:: 0; 1; 0]) :
  blossom bent c [:: at_ 1; at_ 0] <> blossom bent c [:: at_ 0; at_ 1].
Proof. by rewrite !bent_blossom /c /listed /= !subrr subr0 mul1r mulr0 addr0 mul0r mulr1 => /eqP; rewrite oner_eq0. Qed.

(** blossoms injective_needs_span: over the knots $0,0$ of degree 1 all blossoms are the same when $x/0=0$. *)
Theorem blossoms_injective_needs_span c d x : blossom (listed [::]) c [:: x] = blossom (listed [::]) d [:: x].
Proof. by rewrite /= /step /listed !nth_nil subrr invr0 !mulr0. Qed.

(** blossoms unique_needs_span: the symmetric linear function $f(a,w)=w$ is not the blossom of its values over the knots $0,0$. *)
Theorem blossoms_unique_needs_span (f := fun v : seq (F * F) => if v is [:: x] then x.2 else 0) :
  polar 1 f /\ f [:: at_ 0] <> blossom (listed [::]) (fun i => f (knots (listed [::]) i 1)) [:: at_ 0].
Proof.
split; last by rewrite /= /step /listed subrr invr0 mulr0 => /eqP; rewrite oner_eq0.
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

(** blossoms derivative_needs_span: knots $0,1,0,0$ of degree 2 with $u_2=u_0$: the rule would make the curve $c_1=1$, $c_2=0$, which
    is $(1-t)t$, the derivative $2(1-t)$. *)
Theorem blossoms_derivative_needs_span (c := listed [:: 0; 1; 0]) :
  (curve 2 bent c)^`() <> velocity 2 bent c *+ 2.
Proof.
rewrite bent_curve bent_velocity /c /listed /= polyC0 polyC1 mul0r addr0 mul1r subr0 mulr1.
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
