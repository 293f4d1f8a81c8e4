(* FJ07, sections 3 and 4, inner knots: which curves have nets of (13) with M* at an inner knot of any multiplicity, and what that says of the roots of (20). *)
From Torse Require Import Prelude Blossom Curves Points Insertion Joints FJ07_3_net FJ07_2_cones FJ21_4 FJ07_3_knots FJ07_3_vertices FJ07_4.

Section Inner.
Variables (F : fieldType) (m : nat).
Implicit Types (u : nat -> F) (c d : nat -> 'rV[F]_m) (x y : 'rV[F]_m) (L M : F) (n i r s K : nat).

Lemma ev_chord u n c K M : ev (chord u n c K) M = \sum_(0 <= i < K.+1) (starts u M 0 i * finishes u n M i.+1 K.+1) *: (c i.+1 - c i).
Proof.
rewrite /chord ev_sum; apply: eq_bigr => i _; apply/rowP=> k; rewrite !mxE hornerM hornerC /factor hornerM !horner_prod.
by congr (_ * _ * _); apply: eq_bigr => j _; rewrite hornerD hornerN hornerX hornerC.
Qed.

Lemma starts_at u r k : (r < k)%N -> starts u (u r) 0 k = 0.
Proof. by move=> lt_r; rewrite /starts big_mkord (bigD1 (Ordinal lt_r)) //= subrr mul0r. Qed.

Lemma finishes_at u n s a k M : (a <= s < k)%N -> M = u (s + n)%N -> finishes u n M a k = 0.
Proof.
by move=> /andP[le_s lt_s] e; rewrite /finishes (big_cat_nat _ _ _ le_s) ?(ltnW lt_s) //= [X in _ * X]big_ltn // e subrr mul0r mulr0.
Qed.

(** FJ07.13 inner_needs: where $M^{*}=u_r$ starts a cell and $M^{*}=u_{s+n}$ ends one, as an inner knot does, a net of (13) with $\Lambda^{*}\ne M^{*}$ asks for
    $\sum_{i=0}^{L-1}\prod_{j<i}(M^{*}-u_j)\prod_{i<j<L}(M^{*}-u_{j+n})\,(c_{i+1}-c_i)=0$ of the curve.
    Paper: passes over it. *)
Theorem FJ07_13_inner_needs u n L M c d K r s : (r <= K)%N -> M = u r -> (s <= K)%N -> M = u (s + n)%N -> L != M ->
  (forall i, (i < K.+1)%N -> cell u n L M c d i) -> ev (chord u n c K) M = 0.
Proof.
move=> le_r er le_s es LM /FJ07_16_cleared; rewrite -ev_chord (finishes_at (s := s)) // er starts_at // !scale0r add0r.
by move/esym/eqP; rewrite scaler_eq0 subr_eq0 -er (negPf LM) => /eqP.
Qed.

(** FJ07.13 inner: that is enough: for an inner knot $M^{*}$, of which $u_r$ is the first among the starts of cells, there is a net of (13) iff the sum is 0, and
    then both its end vertices may be any points $x$ and $y$.
    Hypotheses: $\Lambda^{*}\ne M^{*}$; $M^{*}$ is none of $u_0,\dots,u_{r-1}$, nor of the ends $u_{i+n}$ of the cells $i>r$, as for a knot that is at most $n$-fold.
    Paper: passes over it. *)
Theorem FJ07_13_inner u n L M c K r s x y : (s < r <= K)%N -> M = u r -> M = u (s + n)%N -> L != M ->
  (forall i, (i < r)%N -> M - u i != 0) -> (forall i, (r < i <= K)%N -> M - u (i + n)%N != 0) ->
  (exists d, [/\ forall i, (i < K.+1)%N -> cell u n L M c d i, d 0%N = x & d K.+1 = y]) <-> ev (chord u n c K) M = 0.
Proof.
move=> /andP[lt_s le_r] er es LM off off'; split=> [[d [cells _ _]]|sum0].
  exact: (FJ07_13_inner_needs le_r er (leq_trans (ltnW lt_s) le_r) es LM cells).
have [e0 cells1] := FJ07_13_exists n L c x off; set d1 := net u n L M c x in e0 cells1.
have [||d2 [eK cells2]] := @FJ07_13_vertex F m (drop_ r.+1 u) n L M (drop_ r.+1 c) y (K - r) (K - r) (leqnn _).
- by move=> i /andP[]; rewrite leqNgt => /negPf ->.
- by move=> i lt_i; rewrite /drop_ addnA; apply: off'; clear -lt_i le_r; lia.
pose d i := if (i <= r)%N then d1 i else d2 (i - r.+1)%N.
exists d; split; last 2 first.
- by rewrite /d leq0n.
- by rewrite /d ltnNge le_r /= subSS.
move=> i lt_i; have [lt_r|] := ltnP i r; first by rewrite /cell /d lt_r (ltnW lt_r); exact: cells1.
rewrite leq_eqVlt => /predU1P[<-{lt_i i}|lt_r]; last first.
  have e1 : (i <= r)%N = false by clear -lt_r; lia.
  have e2 : (i.+1 <= r)%N = false by clear -lt_r; lia.
  have := cells2 (i - r.+1)%N; rewrite /cell /drop_ /d e1 e2 !addnA addnS !subnKC // subSn //.
  by apply; clear -lt_r lt_i; lia.
apply/FJ07_13_rulings; rewrite -{1}er subrr scale0r.
have nz : starts u M 0 r != 0 by rewrite /starts prodf_seq_neq0; apply/allP=> j; rewrite mem_index_iota => /andP[_ lt_j]; exact: off.
have nz' : finishes u n M r.+1 K.+1 != 0.
  by rewrite /finishes prodf_seq_neq0; apply/allP=> j; rewrite mem_index_iota => h; exact: off'.
apply: (scalerI nz); rewrite scaler0 scalerDr !scalerA [_ * (M - u (r + n)%N)]mulrC [_ * (L - M)]mulrC -!scalerA.
have := FJ07_16_cleared cells1; rewrite (finishes_at (s := s)) // scale0r add0r /d leqnn => ->.
rewrite scalerA mulrC -scalerA -scalerDr.
have: ev (chord u n c K) M = finishes u n M r.+1 K.+1 *:
    ((M - u (r + n)%N) *: (\sum_(0 <= i < r) (starts u M 0 i * finishes u n M i.+1 r) *: (c i.+1 - c i)) + starts u M 0 r *: (c r.+1 - c r)).
  rewrite ev_chord (big_cat_nat _ _ _ (leq0n r.+1)) ?ltnS //= [X in _ + X]big1_seq; last first.
    by move=> i /andP[_]; rewrite mem_index_iota => /andP[lt_i _]; rewrite er starts_at // mul0r scale0r.
  rewrite addr0 big_nat_recr //= [in RHS]scalerDr !scalerA [_ * starts u M 0 r]mulrC; congr (_ + _).
  rewrite scaler_sumr; apply: eq_big_nat => i /andP[_ lt_i]; rewrite scalerA; congr (_ *: _).
  rewrite [finishes u n M i.+1 K.+1](_ : _ = finishes u n M i.+1 r.+1 * finishes u n M r.+1 K.+1).
    by rewrite finishes_last //; move: (starts u M 0 i) (finishes u n M i.+1 r) (finishes u n M r.+1 K.+1) (M - _) => a b e f; ring.
  by rewrite /finishes -big_cat_nat // ltnW.
rewrite sum0 => /esym/eqP; rewrite scaler_eq0 (negPf nz') => /eqP ->.
by rewrite scaler0.
Qed.

(** FJ07.13 inner_smooth: for an inner knot $M^{*}=u_{k+n}=\dots=u_{k+n+r}$ of any multiplicity $r+1$ the sum of FJ07.13 inner is 0 iff the pieces before and after the
    knot join with one derivative more than such a knot allows,
    $c_k[M^{*\langle r\rangle},v_1,\dots,v_{n-r}]=c_{k+r+1}[M^{*\langle r\rangle},v_1,\dots,v_{n-r}]$, class $C^{n-r}$; for $r=0$, iff they are one polynomial. So
    there is a net of (13) with this $M^{*}\ne\Lambda^{*}$ iff the curve does not need the knot that often.
    Hypotheses: $n\ge1$; the knots carry both pieces, so that their points have a meaning; $M^{*}$ is none of $u_0,\dots,u_{k+n-1}$, nor of the ends $u_{i+n}$ of the
    cells $i>k+n$, as for a knot that is at most $n$-fold.
    Paper: passes over it. *)
Theorem FJ07_13_inner_smooth u n M c K r k : (0 < n)%N -> (k + n + r <= K)%N -> (forall i, (n <= i <= n + r)%N -> u (k + i)%N = M) ->
  span n (drop_ k u) -> span n (drop_ (k + r.+1) u) -> (forall i, (i < k + n)%N -> M - u i != 0) -> (forall i, (k + n < i <= K)%N -> M - u (i + n)%N != 0) ->
  ev (chord u n c K) M = 0 <-> forall v, (r + size v)%N = n -> pblossom (drop_ k u) (drop_ k c) (nseq r (at_ M) ++ v)
    = pblossom (drop_ (k + r.+1) u) (drop_ (k + r.+1) c) (nseq r (at_ M) ++ v).
Proof.
move=> n0 le_K eM sp sp' off off'; have eM' i : (k + n <= i <= k + n + r)%N -> M = u i.
  by move=> h; rewrite -(eM (i - k)%N); [congr u; clear -h; lia | clear -h; lia].
have join (b : nat -> 'rV[F]_m) : ev (chord u n b K) M = 0 -> forall v, (r + size v)%N = n -> pblossom (drop_ k u) (drop_ k b) (nseq r (at_ M) ++ v)
    = pblossom (drop_ (k + r.+1) u) (drop_ (k + r.+1) b) (nseq r (at_ M) ++ v).
  move=> b0 v sz; have ne : M + 1 != M by rewrite -subr_eq0 addrC addKr oner_neq0.
  have [] := @FJ07_13_inner u n (M + 1) M b K (k + n) k 0 0 _ (eM' _ _) (eM' _ _) ne off off'; [by clear -n0 le_K; lia | by clear; lia | by clear; lia |].
  move=> _ /(_ b0)[d [cells _ _]]; apply: (FJ07_13_smooth eM ne sp sp' _ sz) => i h; apply: cells; clear -h le_K; lia.
split=> [|smooth]; first exact: join.
have le_r : (r <= n)%N.
  rewrite leqNgt; apply/negP=> lt_r; have := off' (k + n).+1; rewrite -(eM' ((k + n).+1 + n)%N) ?subrr ?eqxx; last by clear -lt_r; lia.
  by move=> /(_ _)/negP; apply; clear -lt_r le_K; lia.
pose f := starts u M 0 (k + n) * finishes u n M (k + n).+1 K.+1; have f0 : f != 0.
  rewrite mulf_neq0 // prodf_seq_neq0; apply/allP=> j; rewrite mem_index_iota; [exact: off | exact: off'].
pose z := f^-1 *: ev (chord u n c K) M; pose e i := (k + n < i)%N%:R : F; pose b i := c i - e i *: z.
have b0 : ev (chord u n b K) M = 0.
  apply/eqP; rewrite ev_chord (eq_bigr (fun i => (starts u M 0 i * finishes u n M i.+1 K.+1) *: (c i.+1 - c i)
      - (starts u M 0 i * finishes u n M i.+1 K.+1) *: ((e i.+1 - e i) *: z))) => [|i _]; last first.
    by rewrite /b; move: (c i) (c i.+1) (starts _ _ _ _ * _) => x y g; by_entries j; ring.
  rewrite sumrB -ev_chord subr_eq0 (bigD1_seq (k + n)%N) ?mem_index_iota ?iota_uniq //=; last by clear -le_K; lia.
  rewrite big1 => [|i ne]; last by rewrite /e ltnS leq_eqVlt eq_sym (negPf ne) subrr scale0r scaler0.
  by rewrite addr0 /e ltnSn ltnn subr0 scale1r scalerA mulfV // scale1r.
pose v := knots (drop_ (k + r.+1) u) n (n - r).
have sz : (r + size v)%N = n by rewrite size_knots subnKC.
have win : nseq r (at_ M) ++ v = knots (drop_ (k + r.+1) u) (n - r) n.
  transitivity (knots (drop_ (k + r.+1) u) (n - r) (r + (n - r))); last by rewrite subnKC.
  rewrite knots_cat subnK // (@knots_same _ (drop_ (k + r.+1) u) (n - r) r M) // => l h; apply/esym/eM'; clear -h le_r; lia.
have at_end (g : nat -> 'rV[F]_m) : pblossom (drop_ (k + r.+1) u) (drop_ (k + r.+1) g) (nseq r (at_ M) ++ v) = g (k + n).+1.
  apply/rowP=> j; rewrite mxE win blossoms_knots ?leq_subr // /coord /drop_; congr (g _ 0 j); clear -le_r; lia.
have left : pblossom (drop_ k u) (drop_ k b) (nseq r (at_ M) ++ v) = pblossom (drop_ k u) (drop_ k c) (nseq r (at_ M) ++ v).
  apply/rowP=> j; rewrite !mxE; apply: blossom_ext => i; rewrite size_cat size_nseq sz => le_i.
  by rewrite /coord /drop_ /b /e ltnNge leq_add2l le_i scale0r subr0.
have := join b b0 v sz; rewrite left smooth // !at_end /b /e ltnSn scale1r => /esym/eqP.
by rewrite -subr_eq0 addrAC subrr add0r oppr_eq0 /z scaler_eq0 invr_eq0 (negPf f0) => /eqP.
Qed.

(** FJ07.13 inner_needs_fold: for an $(n+2)$-fold knot $M^{*}=u_r=u_{r+n}=u_{r+n+1}$ the sum is 0 for every curve, and there is no net unless $c_{r+1}=c_r$. *)
Theorem FJ07_13_inner_needs_fold u n L M c d K r : (r < K)%N -> M = u r -> M = u (r + n)%N -> M = u (r.+1 + n)%N -> L != M ->
  ev (chord u n c K) M = 0 /\ (c r.+1 != c r -> ~ cell u n L M c d r).
Proof.
move=> lt_r er er_n er1 LM; split.
  rewrite ev_chord big1_seq // => i /andP[_]; rewrite mem_index_iota => /andP[_ lt_i]; have [le_i|lt_ri] := leqP i r.
    by rewrite (finishes_at (s := r.+1)) ?mulr0 ?scale0r // !ltnS le_i.
  by rewrite er starts_at // mul0r scale0r.
move=> ne /FJ07_13_rulings; rewrite -er -er_n subrr !scale0r add0r => /esym/eqP.
by rewrite scaler_eq0 !subr_eq0 (negPf LM) (negPf ne).
Qed.

(** FJ07.13 inner_needs_distinct: for $\Lambda^{*}=M^{*}$ the row $d=c$ is a net for every curve and every knot. *)
Theorem FJ07_13_inner_needs_distinct u n M c i : cell u n M M c c i.
Proof. by []. Qed.
End Inner.

(** FJ07.21 inner_knot: an inner knot $M_0$ is a root of the polynomial of (20) iff $[S,v,w]=0$ for the sum $S$ of FJ07.13; but there is a net of (13) with
    $\Lambda^{*}\ne M_0$ and end rulings along $v$ and $w$ iff $S=0$, whatever $v$ and $w$ are, so iff the curve does not need the knot that often (FJ07.13
    inner_smooth).
    Hypotheses: $\Lambda^{*}\ne M_0$; $M_0=u_r$ starts a cell and is none of $u_0,\dots,u_{r-1}$, nor of the ends $u_{i+n}$ of the cells $i>r$, as for a knot that is
    at most $n$-fold.
    Paper: excludes no root. *)
Theorem FJ07_21_inner_knot (F : fieldType) (u : nat -> F) n L M (c : nat -> 'rV[F]_3) v w K r s (S := ev (chord u n c K) M) :
  (s < r <= K)%N -> M = u r -> M = u (s + n)%N -> L != M -> (forall i, (i < r)%N -> M - u i != 0) ->
  (forall i, (r < i <= K)%N -> M - u (i + n)%N != 0) ->
  (root (branches u n c K v w) M <-> triple S v w = 0) /\
  ((exists d sigma tau, [/\ forall i, (i < K.+1)%N -> cell u n L M c d i, d 0%N = c 0%N + sigma *: v & d K.+1 = c K.+1 + tau *: w]) <-> S = 0).
Proof.
move=> le er es LM off off'; split; first by rewrite /root /branches ev_triple !ev_fixed; split=> /eqP.
rewrite /S -(FJ07_13_inner c (c 0%N) (c K.+1) le er es LM off off'); split=> [[d [sigma [tau [cells _ _]]]]|[d [cells e0 eK]]].
  have S0 : ev (chord u n c K) M = 0.
    by case/andP: le => lt_s le_r; apply: (FJ07_13_inner_needs le_r er (leq_trans (ltnW lt_s) le_r) es LM cells).
  exact: (FJ07_13_inner c (c 0%N) (c K.+1) le er es LM off off').2.
by exists d, 0, 0; rewrite !scale0r !addr0.
Qed.
