(* FJ07: what happens without the hypotheses of the theorems, one counterexample each, over any field.
   Definitions:
     on_line s i      member i of the list s of numbers, as a point of a line *)
From Torse Require Import Prelude Blossom Curves Points FJ07_2 FJ07_3_pieces FJ07_3_net FJ07_3_blossoms FJ07_3_cells Needs_blossoms.

Section Lines.
Variable F : fieldType.
Implicit Types (u : nat -> F) (c d : nat -> 'rV[F]_1) (L M l mu a b e p q x : F) (n k i : nat).

Definition on_line (s : seq F) i : 'rV[F]_1 := const_mx (nth 0 s i).

Lemma line1 (x y : 'rV[F]_1) : x = y <-> x 0 0 = y 0 0.
Proof. by split=> [->|e] //; apply/rowP=> k; rewrite ord1. Qed.

(** FJ07.10 needs_piece: on an empty piece every $\Lambda_k$ gives the knot $u_{n+k-2}$ and no other $\Lambda^{*}$. *)
Theorem FJ07_10_needs_piece u n k (Lam : F) : len u n k = 0 -> (1 - Lam) * u (n + k)%N + Lam * u (n + k).+1 = u (n + k)%N.
Proof. by move/subr0_eq => ->; ring. Qed.

(** FJ07.10 needs_pieces: after an empty piece the recursion gives $\Lambda_k=0$ whatever $\Lambda_{k-1}$ is; true is
    $(\Lambda^{*}-u_{n+k-2})/\Delta u_{n+k-2}$, which is not 0 unless $\Lambda^{*}$ is the knot. *)
Theorem FJ07_10_needs_pieces u n k x (Lam : F) : len u n k = 0 -> len u n k.+1 != 0 -> x != u (n + k.+1)%N ->
  len u n k / len u n k.+1 * (Lam - 1) = 0 /\ local u n k.+1 x != 0.
Proof. by move=> -> h nx; rewrite !mul0r /local; split=> //; rewrite mulf_neq0 ?invr_neq0 // subr_eq0. Qed.

(** FJ07.10 needs_jump: from an empty piece $j$ no value in the place of $\Lambda_j$ tells two $\Lambda^{*}$ apart: the formula gives
    $(u_{n+j-2}-u_{n+k-2})/\Delta u_{n+k-2}$. *)
Theorem FJ07_10_needs_jump u n j k x (Lam : F) : len u n j = 0 -> len u n k != 0 -> x != u (n + j)%N ->
  local u n k x != (len u n j * Lam + u (n + j)%N - u (n + k)%N) / len u n k.
Proof.
move=> -> h nx; rewrite mul0r add0r; apply: contraNneq nx; rewrite /local => e.
by have /addIr -> : x - u (n + k)%N = u (n + j)%N - u (n + k)%N by apply: (mulIf (invr_neq0 h)).
Qed.

(** FJ07.11 needs_first: where $M^{*}$ starts the piece there is no $\mu_{k-1}=1-1/M_{k-1}$: no value of it gives $1-1/M_{k-1}$ when (11)
    is read as $\mu M=M-1$. *)
Theorem FJ07_11_needs_first u n k mu : len u n k != 0 -> mu * local u n k (u (n + k)%N) != local u n k (u (n + k)%N) - 1.
Proof. by move=> h; rewrite /local subrr !mul0r mulr0 sub0r eq_sym oppr_eq0 oner_neq0. Qed.

(** FJ07.11 needs_second: where $M^{*}$ ends the piece $\mu_{k-1}=0$ and there is no $\mu_k$. *)
Theorem FJ07_11_needs_second u n k (x := u (n + k).+1) : len u n k != 0 ->
  1 - (local u n k x)^-1 = 0 /\ local u n k.+1 x = 0.
Proof. by move=> h; rewrite /local /x addnS subrr mul0r divff // invr1 subrr. Qed.

(** FJ07.11 needs_pieces: over an empty piece the recursion makes a cone, $\mu_k=1$, of every $\mu_{k-1}$. *)
Theorem FJ07_11_needs_pieces u n k mu : len u n k.+1 = 0 -> 1 + len u n k.+1 / len u n k * (1 - mu^-1) = 1.
Proof. by move=> ->; rewrite !mul0r addr0. Qed.

(** FJ07.12 needs_M: for $M=0$ equation (12) may hold where no $\lambda,\mu$ give $D_{i+1}$: $C_0=C_1=D_0=0$, $D_1=1$. *)
Theorem FJ07_12_needs_M (c := on_line [::]) (d := on_line [:: 0; 1]) :
  (forall L, (1 - L) *: c 0%N + L *: c 1%N = (1 - 0) *: d 0%N + 0 *: d 1%N) /\
  forall l mu, d 1%N <> (1 - l - mu) *: c 0%N + l *: c 1%N + mu *: d 0%N.
Proof.
split=> [L | l mu]; rewrite line1 !mxE /=; first by ring.
by move/eqP; rewrite !mulr0 !addr0 oner_eq0.
Qed.

(** FJ07.13 needs_distinct: where $u_{i+n}=u_i$ too, the cell holds for all points: $n=1$, $u_0=u_1=\Lambda^{*}=M^{*}=0$. *)
Theorem FJ07_13_needs_distinct c d : cell (listed [::]) 1 0 0 c d 0.
Proof. by rewrite /cell /listed !nth_nil subrr !scale0r. Qed.

(* $M^{*}=u_0$ and the row 0, 1 over the row 0, 0: equation (13) does not bind $d_1$. *)
Lemma free_vertex L : cell (listed [:: 0; 1]) 1 L 0 (on_line [::]) (on_line [:: 0; 1]) 0.
Proof. by rewrite /cell line1 !mxE /=; ring. Qed.

(** FJ07.14 needs_off: where $M^{*}=u_0$ no formula $d_1=pd_0+qc_0+rc_1$ holds for all solutions of (13): $n=1$, $u=(0,1)$, $M^{*}=0$. *)
Theorem FJ07_14_needs_off (c := on_line [::]) (d := on_line [:: 0; 1]) :
  (forall L, cell (listed [:: 0; 1]) 1 L 0 c d 0) /\ forall p q r, d 1%N <> p *: d 0%N + q *: c 0%N + r *: c 1%N.
Proof.
split=> [|p q r]; first exact: free_vertex.
by rewrite line1 !mxE /= !mulr0 !addr0 => /eqP; rewrite oner_eq0.
Qed.

(** FJ07.15 needs_off: where $M^{*}=u_0$ no formula $d_1-c_1=p(d_0-c_0)+q(c_1-rc_0)$ holds for all solutions of (13). *)
Theorem FJ07_15_needs_off (c := on_line [::]) (d := on_line [:: 0; 1]) :
  (forall L, cell (listed [:: 0; 1]) 1 L 0 c d 0) /\
  forall p q r, d 1%N - c 1%N <> p *: (d 0%N - c 0%N) + q *: (c 1%N - r *: c 0%N).
Proof.
split=> [|p q r]; first exact: free_vertex.
by rewrite line1 !mxE /= !mulr0 !subrr !mulr0 subr0 addr0 => /eqP; rewrite oner_eq0.
Qed.

(** FJ07.16 needs_off: where $M^{*}=u_0$ no formula $d_1-c_1=p(d_0-c_0)+q(c_1-c_0)$ holds for all solutions of (13). *)
Theorem FJ07_16_needs_off (c := on_line [::]) (d := on_line [:: 0; 1]) :
  (forall L, cell (listed [:: 0; 1]) 1 L 0 c d 0) /\ forall p q, d 1%N - c 1%N <> p *: (d 0%N - c 0%N) + q *: (c 1%N - c 0%N).
Proof.
split=> [|p q]; first exact: free_vertex.
by rewrite line1 !mxE /= subrr !mulr0 subr0 addr0 => /eqP; rewrite oner_eq0.
Qed.

(** FJ07.C2 needs_off: for $\Lambda^{*}=M^{*}=u_0$ the net need not be a cylinder: $d_0-c_0=0$ and $d_1-c_1=1$. *)
Theorem FJ07_C2_needs_off (c := on_line [::]) (d := on_line [:: 0; 1]) :
  cell (listed [:: 0; 1]) 1 0 0 c d 0 /\ forall p, d 1%N - c 1%N <> p *: (d 0%N - c 0%N).
Proof.
split=> [|p]; first exact: free_vertex.
by rewrite line1 !mxE /= subrr mulr0 subr0 => /eqP; rewrite oner_eq0.
Qed.

(** FJ07.18 needs_start: where $M^{*}=u_i$ equation (13) may hold where no $l,\mu$ give $d_{i+1}$. *)
Theorem FJ07_18_needs_start (c := on_line [::]) (d := on_line [:: 0; 1]) :
  (forall L, cell (listed [:: 0; 1]) 1 L 0 c d 0) /\ forall l mu, ~ bary l mu c d 0.
Proof.
split=> [|l mu]; first exact: free_vertex.
by rewrite /bary line1 !mxE /= !mulr0 !addr0 => /eqP; rewrite oner_eq0.
Qed.

(** FJ07.18 needs_next: where $M^{*}=u_{i-1}$, the start of the next cell, the denominator of (18) is 0. *)
Theorem FJ07_18_needs_next a b p : b - a != 0 -> D a b p ((b - p) / (b - a)) = 0.
Proof. by rewrite /D => h; field. Qed.

(** FJ07.18 needs_width: where $u_{i+n-2}=u_{i-2}$ the denominator of (18) is 0, for every $M^{*}$. *)
Theorem FJ07_18_needs_width a b M : M - a != 0 -> D a b a ((M - a) / (M - a)) = 0.
Proof. by rewrite /D => h; field. Qed.

(** FJ07.18 cylinder_needs_width: where $u_{i+n-2}=u_{i-2}$ every $l$ is followed by $l=1$. *)
Theorem FJ07_18_cylinder_needs_width a b l mu : D a b a mu != 0 -> next_l a b a l mu = 1.
Proof. by move=> h; rewrite /next_l -[RHS](divff h) /D; congr (_ / _); ring. Qed.

(** FJ07.18 cone_needs_width: where $u_{i+n-1}=u_{i-1}$ every $\mu$ is followed by $\mu=1$. *)
Theorem FJ07_18_cone_needs_width a b p mu : D a b p mu != 0 -> next_mu a b p b mu = 1.
Proof. by move=> h; rewrite /next_mu -[RHS](divff h). Qed.

(** FJ07.18 cylinder_needs_denominator: where the denominator $D$ of (18) is 0 and $l_{i-1}=1$ the equation $D\,l_i=\dots$ holds for all $l_i$. *)
Theorem FJ07_18_cylinder_needs_denominator a b p mu l : D a b p mu = 0 -> D a b p mu * l = mu * (b - a) + 1 * (p - a) - b + a.
Proof. by move=> e; rewrite {1}e mul0r -e /D; ring. Qed.

(** FJ07.18 cone_needs_denominator: where the denominator is 0 and $\mu_{i-1}=1$ the equation $D\,\mu_i=\dots$ holds for all $\mu_i$. *)
Theorem FJ07_18_cone_needs_denominator a b p q mu : D a b p 1 = 0 -> D a b p 1 * mu = p - q + 1 * (q - a).
Proof. by move=> e; rewrite {1}e mul0r -e /D; ring. Qed.

(** FJ07.T1 needs_span: over the knots $0,1,1,2$, an empty piece of degree 2, the blossoms of the points $1,1,1$ and of $0,0,0$ are 0 whatever stands for $\frac10$, so that
    the relation holds for all $\Lambda^{*}$, $M^{*}$, and (13) fails. *)
Theorem FJ07_T1_needs_span L M (u := listed [:: 0; 1; 1; 2%:R]) (c := on_line [:: 1; 1; 1]) (d := on_line [::]) :
  (forall (k : F) (x : F * F), pblossom_with k u c [:: at_ L; x] = pblossom_with k u d [:: at_ M; x]) /\ ~ cell u 2 L M c d 0.
Proof.
split=> [k x|]; last first.
  rewrite /cell line1 !mxE /= /u /listed /= => /eqP.
  by rewrite !mulr0 !mulr1 addr0 subr0 subrK oner_eq0.
rewrite line1 !mxE /= /step_with /u /listed /coord /shift !mxE /= subr0 (divided0 _ _ (subrr 1)) (divided0 k (_ + _) (subrr 1)).
rewrite !(divided1 _ _ (erefl (1 : F))) (_ : 2%:R - 1 = 1) ?mulr2n ?addrK // !(divided1 _ _ (erefl (1 : F))).
by move: x.1 x.2 => y w; ring.
Qed.

(** FJ07.C2 needs_cover: where a cell belongs to no piece that is not empty, the pieces are related and (13) fails: $n=1$, $N=2$,
    $u=(0,0,1)$, a first piece that is empty. *)
Theorem FJ07_C2_needs_cover (u := listed [:: 0; 0; 1]) (c := on_line [:: 1; 0; 0]) (d := on_line [::]) :
  (forall k, (k < 2)%N -> span 1 (drop_ k u) -> related (drop_ k u) 1 1 0 (drop_ k c) (drop_ k d)) /\ ~ cell u 1 1 0 c d 0.
Proof.
split=> [[|[|//]] _ sp|].
- by have := sp 0%N 1%N isT isT; rewrite unitfE /drop_ /u /listed /= subrr eqxx.
- by apply/(FJ07_T1_piece _ _ _ _ sp) => -[|//] _; rewrite /cell line1 !mxE /=; ring.
rewrite /cell line1 !mxE /= /u /listed /= => /eqP.
by rewrite !sub0r !subr0 !mulr0 !addr0 mulr1 oppr_eq0 oner_eq0.
Qed.

(** FJ07.9 needs_degree: degree 0 has no arguments to relate: $c_0=c_1=1$, $d_0=d_1=0$. *)
Theorem FJ07_9_needs_degree L M (u := listed [:: 0; 1]) (c := on_line [:: 1; 1]) (d := on_line [::]) :
  related u 0 L M c d /\
  pcurve 0 u c + (L%:P - 'X) *: pvelocity 0 u c <> pcurve 0 u d + (M%:P - 'X) *: pvelocity 0 u d.
Proof.
split=> // /rowP/(_ 0); rewrite !mxE /curve /velocity /= /step /polys /coord !mxE /=.
rewrite !mul0r !sub0r !mulN1r subr0 !mul1r !addNr !mul0r !mulr0 !addr0 polyC0 => /eqP.
by rewrite polyC1 oner_eq0.
Qed.

End Lines.
