(* FJ07, section 4: what happens without the hypotheses of the theorems, one counterexample each, over any field. *)
From Torse Require Import Prelude Blossom Curves Points FJ07_2 FJ07_3_net FJ07_3_blossoms FJ21_4 FJ07_2_cones FJ07_3_generic FJ07_4 FJ07_4_rulings
  FJ07_4_special.

Section Needs.
Variable F : fieldType.
Implicit Types (u : nat -> F) (c d : nat -> 'rV[F]_3) (v w x : 'rV[F]_3) (L M s : F) (n i K : nat).

(** FJ07.20 first_knot_needs_width: where $u_n=u_0$ too, the first cell holds at $M^{*}=u_0$ for $c_1=c_0$ and every first ruling, along $c_1-c_0=0$ or not. *)
Theorem FJ07_20_first_knot_needs_width u n L c d : u n = u 0%N -> c 1%N = c 0%N -> d 0%N != c 0%N ->
  cell u n L (u 0%N) c d 0 /\ forall s, d 0%N - c 0%N <> s *: (c 1%N - c 0%N).
Proof.
move=> e ec dc; split=> [|s]; first by apply/FJ07_13_rulings; rewrite add0n e ec !subrr !scale0r scaler0 addr0.
by rewrite ec subrr scaler0 => /eqP; rewrite subr_eq0 (negPf dc).
Qed.

(** FJ07.20 last_knot_needs_width: where $u_{L+n-1}=u_{L-1}$ the last cell holds at $M^{*}=u_{L+n-1}$ for $c_L=c_{L-1}$ and every last ruling. *)
Theorem FJ07_20_last_knot_needs_width u n L c d K : u (K + n)%N = u K -> c K.+1 = c K -> d K.+1 != c K.+1 ->
  cell u n L (u (K + n)%N) c d K /\ forall s, d K.+1 - c K.+1 <> s *: (c K.+1 - c K).
Proof.
move=> e ec dc; split=> [|s]; first by apply/FJ07_13_rulings; rewrite e ec !subrr !scale0r scaler0 addr0.
by rewrite -ec subrr scaler0 => /eqP; rewrite subr_eq0 (negPf dc).
Qed.

(** FJ07.20 end_roots_needs_simple: for $L=2$ and $u_{n+1}=u_0$ the knot $u_0=u_{L+n-1}$ is a root of the polynomial of (20) whatever $[c_1-c_0,v,w]$ and
    $[c_2-c_1,v,w]$ are. *)
Theorem FJ07_20_end_roots_needs_simple u n c v w : u n.+1 = u 0%N -> root (branches u n c 1 v w) (u 0%N).
Proof.
move=> e; rewrite /root /branches ev_triple !ev_fixed /chord ev_sum !big_nat_recr //= big_geq // add0r.
have z i : (i <= 1)%N -> ev (factor u n 1 i *: fixed (c i.+1 - c i)) (u 0%N) = 0.
  case: i => [|[|//]] _; apply/rowP=> k; rewrite !mxE hornerM /factor !hornerE !horner_prod.
    by rewrite [X in _ * X * _]big_nat1 !hornerE add1n e subrr mulr0 mul0r.
  by rewrite [X in X * _ * _]big_nat1 !hornerE subrr !mul0r.
by rewrite !z // addr0; apply/eqP; coordinates; ring.
Qed.

(** FJ07.20 meeting_needs_meeting: for skew end rulings, $[c_L-c_0,v,w]\ne0$, the degree is $L-1$. *)
Theorem FJ07_20_meeting_needs_meeting u n c K v w : triple (c K.+1 - c 0%N) v w != 0 -> size (branches u n c K v w) = K.+1.
Proof.
move=> top; have [sz co] := FJ07_20_count u n c K v w; apply/eqP; rewrite eqn_leq sz /= ltnNge; apply: contra top => le_K.
by rewrite -co nth_default.
Qed.

(** FJ07.20 finite_needs_skew: for end rulings along the same $v$ all numbers are roots. *)
Theorem FJ07_20_finite_needs_skew u n c K v M : root (branches u n c K v v) M.
Proof.
rewrite (_ : branches _ _ _ _ _ _ = 0) ?root0 // /branches.
by move: (fixed v) (chord _ _ _ _) => p q; coordinates; hide_entries; ring.
Qed.

(** FJ07.20 odd_needs_skew: for $L-1=1$, $[c_1-c_0,v,w]=1$ and $[c_2-c_1,v,w]=-1$, so that $[c_2-c_0,v,w]=0$, there is no root over any field.
    Hypotheses: $u_{n+1}\ne u_0$. *)
Theorem FJ07_20_odd_needs_skew u n c v w M : u n.+1 != u 0%N -> triple (c 1%N - c 0%N) v w = 1 -> triple (c 2%N - c 1%N) v w = -1 ->
  ~~ root (branches u n c 1 v w) M.
Proof.
move=> ne t0 t1; rewrite /root /branches ev_triple !ev_fixed /chord ev_sum !big_nat_recr //= big_geq // add0r.
have evf i : ev (factor u n 1 i *: fixed (c i.+1 - c i)) M = (factor u n 1 i).[M] *: (c i.+1 - c i).
  by apply/rowP=> k; rewrite !mxE hornerM hornerC.
have addl x y : triple (x + y) v w = triple x v w + triple y v w by coordinates; ring.
rewrite !evf addl !tripleZl t0 t1 /factor !hornerM !big_nat1 !big_geq // !hornerE add1n.
by move: (u n.+1) (u 0%N) ne => a b ne; apply: contraNneq ne => e; apply/eqP; apply: esym; apply: subr0_eq; rewrite -[RHS]e; ring.
Qed.

(** FJ07.20 parallel_needs_distinct: for $\Lambda^{*}=M^{*}$ the row $d=c$ is a net whatever $v$ is: with $L=1$ the point $a(M^{*})$ is $c_0$, and
    $(c_1-c_0)\times v$ need not be 0. *)
Theorem FJ07_20_parallel_needs_distinct u n M c v : M - u 0%N != 0 -> cross (c 1%N - c 0%N) v != 0 ->
  [/\ cell u n M M c c 0, c 0%N = c 0%N + 0 *: v, c 1%N = c 1%N + 0 *: v & cross (c 1%N - aim u n c 0 M) v != 0].
Proof.
move=> off ne; rewrite !scale0r !addr0; split=> //.
by rewrite /aim /P !big_geq // ?scaler0 addr0 mulr1 divff // scale1r.
Qed.

(** FJ07.21 first_knot_needs_off: where $u_n=u_0$ and $\Lambda^{*}\ne u_0$ no row obeys the first cell at $M_0=u_0$ unless $c_1=c_0$, whatever direction the side
    $c_1-c_0$ has. *)
Theorem FJ07_21_first_knot_needs_off u n L c d : u n = u 0%N -> L != u 0%N -> c 1%N != c 0%N -> ~ cell u n L (u 0%N) c d 0.
Proof.
move=> e; rewrite -subr_eq0 => L0 ne /FJ07_13_rulings; rewrite add0n e subrr !scale0r add0r => /esym/eqP.
by rewrite scaler_eq0 (negPf L0) subr_eq0 (negPf ne).
Qed.

(** FJ07.21 last_knot_needs_off: likewise at $M_0=u_{L+n-1}=u_{L-1}$ unless $c_L=c_{L-1}$. *)
Theorem FJ07_21_last_knot_needs_off u n L c d K (M := u (K + n)%N) : M = u K -> L != M -> c K.+1 != c K -> ~ cell u n L M c d K.
Proof.
move=> e; rewrite -subr_eq0 => L0 ne /FJ07_13_rulings; rewrite -/M -e subrr !scale0r add0r => /esym/eqP.
by rewrite scaler_eq0 (negPf L0) subr_eq0 (negPf ne).
Qed.

(** FJ07.21 first_knot_needs_distinct: for $\Lambda^{*}=M_0=u_0$ the row $d=c$ is there though $c_1-c_0$ is not along $v$; likewise at the last knot. *)
Theorem FJ07_21_first_knot_needs_distinct u n M c v w K : exists d,
  [/\ forall i, (i < K.+1)%N -> cell u n M M c d i, exists s, d 0%N - c 0%N = s *: v & exists s, d K.+1 - c K.+1 = s *: w].
Proof. by exists c; split=> //; exists 0; rewrite subrr scale0r. Qed.

(** FJ07.21 coefficients_needs_independent: for $v=w=0$ every $x$ has $[x,v,w]=0$, and only $x=0$ is $\alpha v+\beta w$. *)
Theorem FJ07_21_coefficients_needs_independent x : x != 0 -> triple x 0 0 = 0 /\ forall alpha beta : F, x <> alpha *: 0 + beta *: 0.
Proof.
move=> x0; split=> [|al be]; first by coordinates; ring.
by rewrite !scaler0 addr0 => e; rewrite e eqxx in x0.
Qed.

(** FJ07.21 coefficients_needs_plane: a combination of $v$ and $w$ has $[x,v,w]=0$. *)
Theorem FJ07_21_coefficients_needs_plane v w alpha beta : triple (alpha *: v + beta *: w) v w = 0.
Proof. by coordinates; ring. Qed.

(** FJ07.21 independent_needs_independent: for $w=v$ the coefficients are not unique, $1v+0v=0v+1v$. *)
Theorem FJ07_21_independent_needs_independent v : 1 *: v + 0 *: v = 0 *: v + 1 *: v /\ 1 <> 0 :> F.
Proof. by rewrite addrC; split=> //; apply/eqP; rewrite oner_eq0. Qed.

(** FJ07.21 norm_needs_order: where $i^2=-1$ in the field $v=(1,i,0)$ and $w=(0,0,1)$ have $v\times w\ne0$ and $\det(v,w,v\times w)=0$. *)
Theorem FJ07_21_norm_needs_order (i : F) (v := vec 1 i 0) (w := vec 0 0 1) : i * i = -1 ->
  cross v w != 0 /\ triple v w (cross v w) = 0.
Proof.
move=> e; split; last by coordinates; apply: etrans (_ : 1 + i * i = 0); [ring | rewrite e subrr].
apply/eqP=> /(congr1 (@y_ _)); rewrite /cross /v /w /x_ /y_ /z_ /vec !mxE /= => /eqP.
by rewrite mul0r mulr1 sub0r oppr_eq0 oner_eq0.
Qed.

(** FJ07.21 unique_needs_independent: for $n=1$, $L=1$, $w=v$ and a side $c_1-c_0=sv$ there are nets of (13) from every $d_0=c_0+\sigma v$.
    Hypotheses: $M_0\ne u_0$. *)
Theorem FJ07_21_unique_needs_independent u L M c v s sigma : M - u 0%N != 0 -> c 1%N - c 0%N = s *: v ->
  exists d tau, [/\ cell u 1 L M c d 0, d 0%N = c 0%N + sigma *: v & d 1%N = c 1%N + tau *: v].
Proof.
move=> off side; set tau := ((M - u 1%N) * sigma + (L - M) * s) / (M - u 0%N).
exists (fun i => if i is 0%N then c 0%N + sigma *: v else c 1%N + tau *: v), tau; split=> //.
apply/FJ07_13_rulings; rewrite add0n /= ![_ + _ *: _ - _]addrAC !subrr !add0r side !scalerA -scalerDl /tau; congr (_ *: _).
by rewrite mulrC divfK.
Qed.
End Needs.
