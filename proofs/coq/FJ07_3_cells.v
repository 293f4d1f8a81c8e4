(* FJ07, section 3, cell by cell: equations (8) and (18); cones and cylinders among them.
   Definitions:
     bary l mu c d i    d_{i+1} = (1 - l - mu) c_i + l c_{i+1} + mu d_i
     D, next_l, next_mu   the denominator and the right sides of (18) for the cell after the one that begins at a = u_{i-2}, with
                        b = u_{i-1}, p = u_{i+n-2}, q = u_{i+n-1} *)
From Torse Require Import Prelude Points FJ07_3_net.

Section Cells.
Variables (F : fieldType) (m : nat).
Implicit Types (u : nat -> F) (c d : nat -> 'rV[F]_m) (L M l mu a b p q : F) (n i K : nat).

Definition bary l mu c d i := d i.+1 = (1 - l - mu) *: c i + l *: c i.+1 + mu *: d i.
Definition D a b p mu : F := p - b + mu * (b - a).
Definition next_l a b p l mu : F := (mu * (b - a) + l * (p - a) - b + a) / D a b p mu.
Definition next_mu a b p q mu : F := (p - q + mu * (q - a)) / D a b p mu.

(** FJ07.18 cell: equation (13) of a cell is the barycentric combination with $l=\frac{\Lambda^{*}-u_i}{M^{*}-u_i}$, $\mu=\frac{M^{*}-u_{i+n}}{M^{*}-u_i}$.
    Hypotheses: $M^{*}\ne u_i$. *)
Theorem FJ07_18_cell u n L M c d i : M - u i != 0 ->
  cell u n L M c d i <-> bary ((L - u i) / (M - u i)) ((M - u (i + n)%N) / (M - u i)) c d i.
Proof.
move=> nz; have -> : bary ((L - u i) / (M - u i)) ((M - u (i + n)%N) / (M - u i)) c d i <-> (M - u i) *: d i.+1 =
    (M - u i) *: ((1 - (L - u i) / (M - u i) - (M - u (i + n)%N) / (M - u i)) *: c i + ((L - u i) / (M - u i)) *: c i.+1
    + ((M - u (i + n)%N) / (M - u i)) *: d i) by rewrite /bary; split=> [->|/(scalerI nz)].
by apply: eq_of_diff; by_entries k; field.
Qed.

(** FJ07.18 recursion: these $l$, $\mu$ obey (18) from cell to cell.
    Hypotheses: $M^{*}\ne u_{i-1}$ and $u_{i+n-2}\ne u_{i-2}$; $M^{*}\ne u_{i-2}$, so that $l$, $\mu$ have a meaning.
    Paper: states none of them. *)
Theorem FJ07_18_recursion a b p q L M : M - a != 0 -> M - b != 0 -> p - a != 0 ->
  next_l a b p ((L - a) / (M - a)) ((M - p) / (M - a)) = (L - b) / (M - b) /\
  next_mu a b p q ((M - p) / (M - a)) = (M - q) / (M - b).
Proof.
move=> na nb np; have eq_D : D a b p ((M - p) / (M - a)) = (M - b) * (p - a) / (M - a) by rewrite /D; field.
by rewrite /next_l /next_mu eq_D; split; field; rewrite na nb np.
Qed.

(** FJ07.18 cylinder: $l=1$ passes from a cell to the next, and back.
    Hypotheses: $u_{i+n-2}\ne u_{i-2}$; the denominator of (18) is not 0, so that the next $l$ has a meaning. *)
Theorem FJ07_18_cylinder a b p l mu : D a b p mu != 0 -> p - a != 0 -> next_l a b p l mu = 1 <-> l = 1.
Proof.
rewrite /next_l /D => nd np; have eq_l : (mu * (b - a) + l * (p - a) - b + a) / (p - b + mu * (b - a)) - 1
    = (l - 1) * ((p - a) / (p - b + mu * (b - a))) by field.
split=> [e|->]; last by apply/eqP; rewrite -subr_eq0; apply/eqP; field.
move/eqP: eq_l; rewrite e subrr eq_sym mulf_eq0 mulf_eq0 invr_eq0 (negPf nd) (negPf np) !orbF subr_eq0.
by move/eqP.
Qed.

(** FJ07.18 cone: $\mu=1$ passes from a cell to the next, and back.
    Hypotheses: $u_{i+n-1}\ne u_{i-1}$; the denominator of (18) is not 0, so that the next $\mu$ has a meaning. *)
Theorem FJ07_18_cone a b p q mu : D a b p mu != 0 -> q - b != 0 -> next_mu a b p q mu = 1 <-> mu = 1.
Proof.
rewrite /next_mu /D => nd nq; have eq_m : (p - q + mu * (q - a)) / (p - b + mu * (b - a)) - 1
    = (mu - 1) * ((q - b) / (p - b + mu * (b - a))) by field.
split=> [e|e]; last first.
  move: nd; rewrite e (_ : p - q + 1 * (q - a) = p - b + 1 * (b - a)); last by ring.
  by move=> nd; rewrite divff.
move/eqP: eq_m; rewrite e subrr eq_sym mulf_eq0 mulf_eq0 invr_eq0 (negPf nd) (negPf nq) !orbF subr_eq0.
by move/eqP.
Qed.

(** FJ07.18 cone_same: where $\mu=1$ the next cell has the same $l$.
    Hypotheses: $u_{i+n-2}\ne u_{i-2}$: the denominator of (18) is $u_{i+n-2}-u_{i-2}$, so that the next $l$ has a meaning. *)
Theorem FJ07_18_cone_same a b p l : p - a != 0 -> next_l a b p l 1 = l.
Proof. by rewrite /next_l /D => h; field; rewrite (_ : p - b + (b - a) = p - a) //; ring. Qed.

(** FJ07.18 cone_sides: cells with $\mu=1$ have $d_{i+1}-d_i=l(c_{i+1}-c_i)$, equation (6). *)
Theorem FJ07_18_cone_sides l c d i : bary l 1 c d i <-> d i.+1 - d i = l *: (c i.+1 - c i).
Proof. rewrite /bary; split=> [->|/(canRL (subrK _)) ->]; by_entries k; ring. Qed.

(** FJ07.8 quadratic: for $n=2$, (8) is (18): $u_{i+n-2}=u_i$, $u_{i+n-1}=u_{i+1}$. *)
Theorem FJ07_8_quadratic u i l mu :
  next_l (u i) (u i.+1) (u i.+2) l mu = (mu * (u i.+1 - u i) + l * (u i.+2 - u i) - u i.+1 + u i)
    / (u i.+2 - u i.+1 + mu * (u i.+1 - u i)) /\
  next_mu (u i) (u i.+1) (u i.+2) (u i.+3) mu = (u i.+2 - u i.+3 + mu * (u i.+3 - u i))
    / (u i.+2 - u i.+1 + mu * (u i.+1 - u i)).
Proof. by []. Qed.

End Cells.
