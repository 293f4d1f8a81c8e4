(* FJ07, the nets of section 3 and what they say of Theorem 1 and section 4: what happens without the hypotheses, one counterexample each. *)
From Torse Require Import Prelude Blossom Curves Points Bezier FJ07_2 FJ07_2_cones FJ07_3_pieces FJ07_3_net FJ07_3_cells FJ07_3_closed FJ07_3_edge FJ21_4 FJ07_4
  FJ07_4_knots FJ07_4_real Needs_blossoms.
From mathcomp Require Import order ssrnum.
Import Order.Theory Num.Theory.

Section Cells.
Variables (F : fieldType) (m : nat).
Implicit Types (u l mu : nat -> F) (c d r : nat -> 'rV[F]_m) (L M a b p q : F) (n i k : nat).

(** FJ07.18 closed_needs_width: where $u_n=u_0$ both $G$ and $E$ vanish in the first cell, whatever $l_1$ and $\mu_1$ are. *)
Theorem FJ07_18_closed_needs_width a (l' m' : F) : E a a m' a = 0 /\ G a a l' m' a = 0.
Proof. by rewrite /E /G; split; ring. Qed.

(** FJ07.18 net_needs_width: where $u_n=u_0$ the number in the place of $M^{*}$ is $u_0$, whatever $\mu_1$ is. *)
Theorem FJ07_18_net_needs_width u n (m' : F) : u n = u 0%N -> u 0%N + (u n - u 0%N) / (1 - m') - u 0%N = 0.
Proof. by move=> ->; rewrite subrr mul0r addr0 subrr. Qed.

(** FJ07.18 cone_converse_needs_l: for $l=1$ the row $d=c$, whose rulings are points on all lines through $a$, obeys (18) with every $\mu$. *)
Theorem FJ07_18_cone_converse_needs_l c (o : 'rV[F]_m) (m' : F) i : c i - o = 1 *: (c i - o) /\ bary 1 m' c c i.
Proof. by split; rewrite ?scale1r // /bary; by_entries k; ring. Qed.

(** FJ07.18 cone_converse_needs_two: one cell alone does not do: for every $\mu\ne0$, every $l$ and all $c_i$, $c_{i+1}$, $a$ there are $d_i$, $d_{i+1}$ on the
    lines $ac_i$, $ac_{i+1}$. *)
Theorem FJ07_18_cone_converse_needs_two c d (o : 'rV[F]_m) (l' m' : F) i : m' != 0 ->
  d i - o = (1 - (1 - l') / m') *: (c i - o) -> d i.+1 - o = l' *: (c i.+1 - o) -> bary l' m' c d i.
Proof. by move=> m0 /(canRL (subrK _)) e0 /(canRL (subrK _)) e1; rewrite /bary e0 e1; by_entries k; field. Qed.

(** FJ07.18 cone_converse_needs_width: where $u_{i+n-1}=u_{i-2}$ there are such rows, of two cells, for every $\mu\ne0$, every $l$ and all points $c$, $a$. *)
Theorem FJ07_18_cone_converse_needs_width a b p c (o : 'rV[F]_m) (l' m' : F)
    (rho := fun i => nth 0 [:: 1 - (1 - l') / m'; l'; next_l a b p l' m'] i) (d := fun i => o + rho i *: (c i - o)) : m' != 0 -> D a b p m' != 0 ->
  (forall i, d i - o = rho i *: (c i - o)) /\ (bary l' m' c d 0 /\ bary (next_l a b p l' m') (next_mu a b p a m') c d 1).
Proof.
move=> m0 d0; have e i : d i - o = rho i *: (c i - o) by rewrite /d addrAC subrr add0r.
split=> //; split; first by apply: FJ07_18_cone_converse_needs_two (e 0%N) (e 1%N).
have eq_m : next_mu a b p a m' * (l' - 1) = next_l a b p l' m' - 1.
  by rewrite /next_mu /next_l; move: d0; rewrite /D => d0; field.
rewrite /bary /d /rho /=; move: eq_m; move: (next_mu _ _ _ _ _) (next_l _ _ _ _ _) => y z eq_m.
have -> : z = 1 + y * (l' - 1) by rewrite eq_m addrC subrK.
by by_entries k; ring.
Qed.

(** FJ07.18 cone_converse_needs_independent: where $c_i=c_{i+1}=d_i=d_{i+1}$ the cell obeys every $l$, $\mu$, and its two lines meet anywhere on them. *)
Theorem FJ07_18_cone_converse_needs_independent (x : 'rV[F]_m) (l' m' : F) : bary l' m' (fun=> x) (fun=> x) 0.
Proof. by rewrite /bary; by_entries k; ring. Qed.

(** FJ07.C2 cylinder_needs_equal: for $\Lambda^{*}\ne M^{*}$ the net is none: from $d_0=c_0$ it does not come back to $d_1=c_1$ unless $c_1=c_0$. *)
Theorem FJ07_C2_cylinder_needs_equal u n L M c d : L != M -> c 1%N != c 0%N -> d 0%N = c 0%N -> cell u n L M c d 0 ->
  d 1%N - c 1%N <> P u n M 0 1 *: (d 0%N - c 0%N).
Proof.
move=> LM cc e0 /FJ07_13_rulings; rewrite e0 subrr !scaler0 add0r => e /eqP; rewrite subr_eq0 => /eqP e1.
by move/eqP: e; rewrite e1 subrr scaler0 eq_sym scaler_eq0 !subr_eq0 (negPf LM) (negPf cc).
Qed.

(** FJ07.T1 edge_needs_width: where $w_{n+1}=w_0$ the point $c_0$ is on the polygon's side in no way and free: the polygon $r=0$ has the rows
    $c_0=x$, all other points 0, which do not obey (13). *)
Theorem FJ07_T1_edge_needs_width w n L M (x : 'rV[F]_m) (r := fun=> 0 : 'rV[F]_m) (c := fun i => (if i is 0%N then x else 0) : 'rV[F]_m) :
  w n.+1 = w 0%N -> L != w 0%N -> x != 0 ->
  [/\ on_sides w n M r c 1, on_sides w n L r r 1 & ~ cell (shift w) n L M c r 0].
Proof.
move=> e Lw x0; split=> [[|[|//]] _|i _|]; rewrite /r /c ?scaler0 ?addr0 //=.
  by rewrite add0n e subrr scale0r.
rewrite /cell /shift add0n /= !scaler0 !addr0 e => /eqP; rewrite scaler_eq0 (negPf x0) orbF subr_eq0 eq_sym.
by rewrite (negPf Lw).
Qed.

(** FJ07.13 two_needs_width: where $u_n=u_0$ the formula gives $M^{*}=u_0$ for every $\mu\ne1$. *)
Theorem FJ07_13_two_needs_width u n (m' : F) : u n = u 0%N -> 1 - m' != 0 -> (u n - m' * u 0%N) / (1 - m') - u 0%N = 0.
Proof. by move=> -> h; field. Qed.

(** FJ07.20 clamped_needs_ends: a piece of degree 1 with $c_1\ne c_0$ goes through $c_0$ at $u_0$ only.
    Hypotheses: $u_1\ne u_0$, so that there is a piece. *)
Theorem FJ07_20_clamped_needs_ends u c t : u 1%N - u 0%N != 0 -> c 1%N != c 0%N -> ev (pcurve 1 u c) t = c 0%N <-> t = u 0%N.
Proof.
move=> w0 cc; have -> : ev (pcurve 1 u c) t = c 0%N + ((t - u 0%N) / (u 1%N - u 0%N)) *: (c 1%N - c 0%N).
  have sp : span 1 u by move=> [|//] j _ /andP[h1 h2]; have -> : j = 1%N by [lia]; rewrite unitfE.
  by apply/rowP=> k; rewrite !mxE horner_curve //= /step /coord /= !mul1r; move: (c 0%N 0 k) (c 1%N 0 k) (u 0%N) (u 1%N) w0 => x y a b w0; field.
split=> [|->]; last by rewrite subrr mul0r scale0r addr0.
move/eqP; rewrite -subr_eq0 addrAC subrr add0r scaler_eq0 subr_eq0 (negPf cc) orbF mulf_eq0 invr_eq0 (negPf w0) orbF subr_eq0.
by move/eqP.
Qed.
End Cells.

Section Ends.
Variable F : fieldType.
Implicit Types (u : nat -> F) (c d : nat -> 'rV[F]_3) (L : F) (n : nat).

(** FJ07.21 first_knot_needs_simple: where $u_0=u_{n+1}$ (for $L=2$) the last ruling is not free: it runs along the last side. *)
Theorem FJ07_21_first_knot_needs_simple u n L c d : u n.+1 = u 0%N -> u 1%N != u 0%N ->
  cell u n L (u 0%N) c d 1 <-> d 2%N - c 2%N = ((L - u 0%N) / (u 0%N - u 1%N)) *: (c 2%N - c 1%N).
Proof.
move=> e h; have w0 : u (1 + n)%N - u 1%N != 0 by rewrite add1n e subr_eq0 eq_sym.
by have := FJ07_20_last_knot L c d w0; rewrite add1n e.
Qed.

(** FJ07.21 last_knot_needs_simple: where $u_{n+1}=u_0$ (for $L=2$) the first ruling is not free: it runs along the first side. *)
Theorem FJ07_21_last_knot_needs_simple u n L c d : u n.+1 = u 0%N -> u n != u 0%N ->
  cell u n L (u n.+1) c d 0 <-> d 0%N - c 0%N = ((L - u 0%N) / (u n - u 0%N)) *: (c 1%N - c 0%N).
Proof. by move=> -> h; apply: FJ07_20_first_knot; rewrite subr_eq0. Qed.
End Ends.

Section Relation.
Variables (F : fieldType) (m : nat).
Implicit Types (C D : 'rV[{poly F}]_m) (n : nat) (t L M s x : F).

(** FJ07.T1 cone_needs_alpha: for $\alpha=1$, $d=c$, every $\Lambda=M$ will do. *)
Theorem FJ07_T1_cone_needs_alpha n C (a : 'rV[F]_m) t L : related_at n C (fixed a + 1 *: (C - fixed a)) t L L 1.
Proof. by rewrite scale1r addrC subrK /related_at scale1r. Qed.

(** FJ07.T1 joint_needs_derivatives: where the derivatives behind the joint are $s$ times as large (class $G^1$), $\Lambda'=t+(\Lambda-t)/s$ and
    $M'=t+(M-t)/s$.
    Hypotheses: $s\ne0$; $n\ne0$ in the field, so that the relation has a meaning. *)
Theorem FJ07_T1_joint_needs_derivatives n C D t L M s (again := fun A : 'rV[{poly F}]_m => fixed (ev A t) + s%:P *: (A - fixed (ev A t))) :
  n%:R != 0 :> F -> s != 0 -> related_at n C D t L M 1 ->
  (forall A, ev (again A) t = ev A t /\ ev (pderiv (again A)) t = s *: ev (pderiv A) t) /\
  related_at n (again C) (again D) t (t + (L - t) / s) (t + (M - t) / s) 1.
Proof.
move=> n0 s0 rel; have e A : ev (again A) t = ev A t /\ ev (pderiv (again A)) t = s *: ev (pderiv A) t.
  split; apply/rowP=> k; rewrite !mxE ?(derivD, derivM, derivN, derivC) !hornerE /=; first by move: (A 0 k).[t] => y; ring.
  by move: (A 0 k)^`().[t] => y; ring.
split=> //; move: rel; rewrite /related_at /tangent !(e C).1 !(e D).1 !(e C).2 !(e D).2 !scalerA.
have simple x : (t + (x - t) / s - t) / n%:R * s = (x - t) / n%:R by field; rewrite n0 s0.
by rewrite !simple.
Qed.

(** FJ07.T1 joint_needs_points: where $d$ jumps by $\frac xnd'(t)$ at the joint, with the same derivatives, $M'=M-x$.
    Hypotheses: $n\ne0$ in the field, so that the relation has a meaning. *)
Theorem FJ07_T1_joint_needs_points n C D t L M x (D' := D + fixed ((x / n%:R) *: ev (pderiv D) t)) : n%:R != 0 :> F ->
  related_at n C D t L M 1 -> pderiv D' = pderiv D /\ related_at n C D' t L (M - x) 1.
Proof.
move=> n0 rel; have e : pderiv D' = pderiv D by apply/rowP=> k; rewrite !mxE derivD derivC addr0.
split=> //; move: rel; rewrite /related_at /tangent e => ->; rewrite !scale1r; apply/rowP=> k; rewrite !mxE hornerD hornerC.
by move: (D 0 k).[t] (D 0 k)^`().[t] n%:R n0 => P Q N n0; field.
Qed.
End Relation.

Section Order.
Variable F : realFieldType.

(** FJ07.C3 safe_needs_order: over the falling knots $1,-1$ of the second piece $\Lambda^{*}=-1$ has $\Lambda_1=-1$ on the piece $[0,1]$ before it, and $\Lambda_2=1$. *)
Theorem FJ07_C3_safe_needs_order (u := listed [:: 0; 0; 1; -1] : nat -> F) : local u 1 0 (-1) = -1 /\ local u 1 1 (-1) = 1.
Proof.
rewrite /local /len /u /listed /=; split; first by rewrite !subr0 divr1.
by rewrite divff // -opprD oppr_eq0 (_ : 1 + 1 = 2%:R) ?pnatr_eq0.
Qed.
End Order.

(** FJ07.20 odd_needs_closed: over the rational numbers quartic Bezier curves with $[\Delta c_0,v,w]=1$, $[\Delta c_1,v,w]=[\Delta c_2,v,w]=0$ and
    $[\Delta c_3,v,w]=-2$ have the polynomial $(M-1)^3-2M^3$, which has no root. *)
Theorem FJ07_20_odd_needs_closed (c : nat -> 'rV[rat]_3) v w : triple (c 1%N - c 0%N) v w = 1 -> triple (c 2%N - c 1%N) v w = 0 ->
  triple (c 3%N - c 2%N) v w = 0 -> triple (c 4%N - c 3%N) v w = - 2%:R -> forall M, ~~ root (branches (step01 _ 4) 4 c 3 v w) M.
Proof.
move=> e0 e1 e2 e3 M; apply/negP; rewrite branches_sum /factor /index_iota /= !big_cons !big_nil e0 e1 e2 e3 !scale0r !add0r !addr0 scale1r.
rewrite /step01 /= rootE !(hornerD, hornerN, hornerZ, hornerM, hornerX, hornerC) => /eqP e.
have {e} e : (M - 1) ^+ 3 = 2%:R * M ^+ 3 by apply/eqP; rewrite -subr_eq0 -e; apply/eqP; ring.
have M0 : M != 0 by apply/eqP=> z; move/eqP: e; rewrite z expr0n mulr0 sub0r expf_eq0 oppr_eq0 oner_eq0 andbF.
have := @no_root 3 ((M - 1) / M) isT; by rewrite exprMn e exprVn mulfK ?eqxx // expf_neq0.
Qed.
