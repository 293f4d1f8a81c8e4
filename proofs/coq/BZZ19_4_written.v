(* BZZ19, section 4, from the mapping to the written surface: the pieces of C_1, C_2 and sigma on [a, b] become Bezier nets of one degree, and the B-spline surface that
   holds these nets one after the other is the ruled surface S(s, t) = (1 - s) C_1(t) + s C_2(sigma(t)) on every piece.
   Definitions:
     lift_ n c, raised n r c    the Bezier points of degree n + 1, and of degree n + r, of the curve of degree n of the points c
     scaled A B w               the coefficients (w_i - A) / (B - A)
     composed p d c w           the Bezier points of degree p d of the curve of degree p of the points c after that of degree d of the coefficients w
     holds D N R P              the row R has the nets of N pieces of degree D one after the other: R_{jD+i} = P^j_i *)
From Torse Require Import Prelude Blossom Curves Points Bernstein Bezier Segments FJ21_4 BZZ19_3 BZZ19_4 BZZ19_4_pieces.

Section Nets.
Variables (F : fieldType) (m : nat).
Implicit Types (u : nat -> F) (c : nat -> 'rV[F]_m) (w : nat -> F) (f g : {poly F}) (a b A B : F) (n r p d i : nat).

Definition lift_ n c i : 'rV[F]_m := n.+1%:R^-1 *: (i%:R *: prev c i + (n.+1 - i)%:R *: c i).
Fixpoint raised n r c := if r is r'.+1 then lift_ (n + r') (raised n r' c) else c.
Definition scaled A B w i : F := (w i - A) / (B - A).
Definition composed p d c w i : 'rV[F]_m := \row_k in_bernstein (p * d) (bez p (coord c k) \Po bez d w) i.

(** BZZ19.15 raised: $r$ elevations give the same curve with points of degree $n+r$.
    Hypotheses: $n+1,\dots,n+r\ne0$ in the field, so that the quotients have a meaning. *)
Theorem BZZ19_15_raised n r c : (forall k, (n < k <= n + r)%N -> k%:R != 0 :> F) -> pbez (n + r) (raised n r c) = pbez n c.
Proof.
elim: r => [|r ih] nz; first by rewrite addn0.
rewrite -{}ih; last by move=> k h; apply: nz; lia.
have n0 : (n + r).+1%:R != 0 :> F by apply: nz; lia.
rewrite addnS; apply/rowP=> k; rewrite !mxE /=; move: (raised n r c) => e; set q := (n + r)%N in n0 *.
apply: (@mulfI _ q.+1%:R%:P); first by rewrite polyC_eq0.
rewrite BZZ19_15_elevation -bez_scale; apply: bez_ext => i _.
by rewrite /coord /lift_ /prev !mxE mulrA divff // mul1r.
Qed.

(** BZZ19.15 power: the paper's way gives the same points: those of degree $D=n+r$ are $\sum_k\frac{C(i,k)}{C(D,k)}f_k$, by (14), for $c(t)=\sum_kf_kt^k$.
    Hypotheses: no $C(D,k)$ vanishes in the field, and $n+1,\dots,D\ne0$, so that the quotients have a meaning. *)
Theorem BZZ19_15_power n r c i k : independent F (n + r) -> (forall j, (n < j <= n + r)%N -> j%:R != 0 :> F) -> (i <= n + r)%N ->
  raised n r c i 0 k = in_bernstein (n + r) (pbez n c 0 k) i.
Proof.
move=> ind nz le_i; have := BZZ19_15_raised c nz => /rowP/(_ k); rewrite mxE => e.
have sz : (size (pbez n c 0%R k) <= (n + r).+1)%N by rewrite mxE (leq_trans (size_bez _ _)) // ltnS leq_addr.
have same : bez (n + r) (coord (raised n r c) k) = bez (n + r) (in_bernstein (n + r) (pbez n c 0 k)) by rewrite e -BZZ19_14_bernstein.
exact: (bez_inj ind same le_i).
Qed.

(** BZZ19.13 net: for any $A\ne B$ the piece of $C_2$ on $[A,B]$ after $\hat T=\frac{\hat\sigma-A}{B-A}$ is a Bezier curve of degree $pd$, and it is
    $C_2(\sigma(a+(b-a)\hat t))$.
    Hypotheses: $A\ne B$ and no $C(pd,k)$ vanishes in the field, so that the coefficients have a meaning; the knots carry both pieces, so that their points have one.
    Paper: takes $A=\sigma(a)$ and $B=\sigma(b)$, which may be equal. *)
Theorem BZZ19_13_net p d u c v w a b A B : independent F (p * d) -> B - A != 0 -> span p u -> span d v ->
  pbez (p * d) (composed p d (psegment A B p u c) (scaled A B (segment a b d v w)))
    = map_mx (fun f => (f \Po curve d v w) \Po line a b) (pcurve p u c).
Proof.
move=> ind nz spu spv; apply/rowP=> k; rewrite !mxE.
have -> : bez (p * d) (coord (composed p d (psegment A B p u c) (scaled A B (segment a b d v w))) k)
    = bez p (coord (psegment A B p u c) k) \Po bez d (scaled A B (segment a b d v w)).
  by rewrite [RHS]BZZ19_13_composition //; apply: bez_ext => i _; rewrite /coord mxE.
have -> : bez p (coord (psegment A B p u c) k) = curve p u (coord c k) \Po line A B.
  by rewrite BZZ19_11_piece //; apply: bez_ext => i _; rewrite /coord /psegment /pblossom mxE.
have one : bez d (fun=> 1 : F) = 1 by rewrite -(B_sum F d); apply: eq_big_nat => i _; rewrite mul1r.
have eT : bez d (scaled A B (segment a b d v w)) = (B - A)^-1%:P * (curve d v w \Po line a b) - (A / (B - A))%:P.
  rewrite BZZ19_11_piece //; transitivity ((B - A)^-1%:P * bez d (segment a b d v w) + (- (A / (B - A)))%:P * bez d (fun=> 1)).
    by rewrite -bez_comb; apply: bez_ext => i _; rewrite /scaled mulr1 mulrBl mulrC.
  by rewrite one mulr1 polyCN.
rewrite -!comp_polyA; congr (_ \Po _); rewrite {1}/line comp_polyD comp_polyM !comp_polyC comp_polyX eT.
have e : (B - A)%:P * (B - A)^-1%:P = 1 :> {poly F} by rewrite -polyCM divff.
by rewrite mulrBr mulrA e mul1r -polyCM [(B - A) * _]mulrC divfK // addrC subrK.
Qed.

Definition holds D N (R : nat -> 'rV[F]_m) (P : nat -> nat -> 'rV[F]_m) :=
  forall j i, (j < N)%N -> (i <= D)%N -> R (j * D + i)%N = P j i.

(** BZZ19.16 rows: there is such a row iff neighbouring nets have a point in common, $P^j_D=P^{j+1}_0$. *)
Theorem BZZ19_16_rows D N P : (exists R, holds D.+1 N R P) <-> forall j, (j.+1 < N)%N -> P j D.+1 = P j.+1 0%N.
Proof.
split=> [[R e] j lt_j|e].
  by rewrite -(e _ _ (ltnW lt_j)) // -(e _ _ lt_j) //; congr R; lia.
exists (fun i => if (i %/ D.+1 < N)%N then P (i %/ D.+1)%N (i %% D.+1)%N else P N.-1 D.+1) => j i lt_j le_i.
move: le_i; rewrite leq_eqVlt => /predU1P[->|lt_i]; last by rewrite divnMDl // modnMDl divn_small // modn_small // addn0 lt_j.
rewrite -[(j * D.+1 + D.+1)%N]addn0 -mulSnr divnMDl // modnMDl div0n mod0n addn0; case: ltnP => [lt_j1|le_N]; first by rewrite e.
by congr (P _ _); lia.
Qed.

Lemma bez_ends n w : (bez n w).[0] = w 0%N /\ (bez n w).[1] = w n.
Proof.
have [at0 at1] : (1 - 'X : {poly F}).[0] = 1 /\ (1 - 'X : {poly F}).[1] = 0 by rewrite !hornerE subrr subr0.
rewrite /bez !horner_sum; split.
  rewrite big_nat_recl // big1 ?addr0 => [|i _]; last by rewrite /B !hornerM hornerXn expr0n /= mul0r !mulr0.
  by rewrite hornerM hornerC /B bin0 expr0 !mul1r horner_exp at0 expr1n mulr1.
rewrite big_nat_recr //= big1_seq ?add0r => [|i /andP[_]]; last first.
  rewrite mem_index_iota => /andP[_ lt_i]; rewrite /B !hornerM hornerXn horner_exp at1.
  by rewrite expr0n subn_eq0 leqNgt lt_i /= !mulr0.
by rewrite hornerM hornerC /B binn subnn expr0 mulr1 mul1r hornerXn expr1n mulr1.
Qed.

(** BZZ19.16 ends: the net of a piece on $[a,b]$ begins and ends with the points of the curve at $a$ and $b$, so that the nets of a continuous curve have the points at
    its joints in common. *)
Theorem BZZ19_16_ends D c (C : 'rV[{poly F}]_m) a b : pbez D c = map_mx (fun f => f \Po line a b) C -> c 0%N = ev C a /\ c D = ev C b.
Proof.
move=> /rowP e; have val k t : (bez D (coord c k)).[t] = (C 0 k).[a + (b - a) * t] by have := e k; rewrite !mxE => ->; rewrite horner_comp line_at.
split; apply/rowP=> k; rewrite [RHS]mxE.
  by rewrite -[LHS]/(coord c k 0%N) -(bez_ends D _).1 val mulr0 addr0.
by rewrite -[LHS]/(coord c k D) -(bez_ends D _).2 val mulr1 addrC subrK.
Qed.

(** BZZ19.16 piece: where the row $R$ holds the net of a piece on $[x_j,x_{j+1}]$, the spline of degree $D$ over the knots $x_0,x_1,\dots$, each $D$ times, is that piece.
    Hypotheses: $x_j\ne x_{j+1}$, so that its points have a meaning; $D\ge1$. *)
Theorem BZZ19_16_piece D N x R P (C : 'rV[{poly F}]_m) j t : (j < N)%N -> x j.+1 - x j != 0 -> holds D.+1 N R P ->
  pbez D.+1 (P j) = map_mx (fun f => f \Po line (x j) (x j.+1)) C ->
  ev (pcurve D.+1 (drop_ (j * D.+1) (joined D.+1 x)) (drop_ (j * D.+1) R)) t = ev C t.
Proof.
move=> lt_j nz h /rowP e; apply/rowP=> k; rewrite !mxE -(BZZ19_12_parameter _ t nz) -[RHS](BZZ19_12_parameter _ t nz).
have := e k; rewrite !mxE => <-; rewrite -[LHS]/((curve D.+1 (drop_ (j * D.+1) (joined D.+1 x)) (drop_ (j * D.+1) (coord R k)) \Po _).[_]).
rewrite BZZ19_16_joined //; congr (_.[_]); apply: bez_ext => i le_i.
by rewrite /drop_ /coord h.
Qed.
End Nets.

Section Surface.
Variable F : fieldType.
Implicit Types (u v x b : nat -> F) (c : nat -> 'rV[F]_3) (n p q d D N j i : nat) (s t : F).

(** BZZ19.16 surface: let $C_1$, $C_2$, $\sigma$ be on $[x_j,x_{j+1}]$ the curves of degrees $n$, $p$, $d$ over the knots $u_j$, $v_j$, $w_j$ with points $c_j$, $e_j$ and
    coefficients $\beta_j$; let the rows $R$ and $S$ hold the nets of $C_1$, and of $C_2\circ\sigma$ by (13), elevated to degree $D$. Then the B-spline surface of
    $R$ and $S$ over the knots $x_0,x_1,\dots$, each $D$ times, is the surface (10), $(1-s)C_1(t)+sC_2(\sigma(t))$, on every piece.
    Hypotheses: $D\ge n$, $D\ge pd$, $D\ge1$; $D!\ne0$ in the field, as in characteristic 0, $A_j\ne B_j$ and $x_j\ne x_{j+1}$, so that the quotients have a meaning; the
    knots carry their pieces, so that their points have a meaning. *)
Theorem BZZ19_16_surface D N n p d x (u v w : nat -> nat -> F) (c e : nat -> nat -> 'rV[F]_3) (b : nat -> nat -> F) (A B : nat -> F) R S
    (C1 := fun j => pcurve n (u j) (c j)) (C2 := fun j => pcurve p (v j) (e j)) (sigma := fun j => curve d (w j) (b j))
    (P := fun j => raised n (D.+1 - n) (psegment (x j) (x j.+1) n (u j) (c j)))
    (Q := fun j => raised (p * d) (D.+1 - p * d)
      (composed p d (psegment (A j) (B j) p (v j) (e j)) (scaled (A j) (B j) (segment (x j) (x j.+1) d (w j) (b j))))) :
  good F D.+1 -> (n <= D.+1)%N -> (p * d <= D.+1)%N -> holds D.+1 N R P -> holds D.+1 N S Q ->
  forall j s t, (j < N)%N -> x j.+1 - x j != 0 -> B j - A j != 0 -> span n (u j) -> span p (v j) -> span d (w j) ->
  ruled_surface (pcurve D.+1 (drop_ (j * D.+1) (joined D.+1 x)) (drop_ (j * D.+1) R))
      (pcurve D.+1 (drop_ (j * D.+1) (joined D.+1 x)) (drop_ (j * D.+1) S)) 'X s t
    = ruled_surface (C1 j) (C2 j) (sigma j) s t.
Proof.
move=> g le_n le_p hR hS j s t lt_j nz AB spu spv spw.
have nat_neq k : (0 < k <= D.+1)%N -> k%:R != 0 :> F by exact: good_nat.
have eP : pbez D.+1 (P j) = map_mx (fun f => f \Po line (x j) (x j.+1)) (C1 j).
  rewrite -{1}(subnKC le_n) /P BZZ19_15_raised; last by move=> k h; apply: nat_neq; move: h; rewrite subnKC //; lia.
  by apply/rowP=> k; rewrite !mxE BZZ19_11_piece //; apply: bez_ext => i _; rewrite /coord /psegment /pblossom mxE.
have eQ : pbez D.+1 (Q j) = map_mx (fun f => f \Po line (x j) (x j.+1)) (after (C2 j) (sigma j)).
  rewrite -{1}(subnKC le_p) /Q BZZ19_15_raised; last by move=> k h; apply: nat_neq; move: h; rewrite subnKC //; lia.
  rewrite BZZ19_13_net //; last exact: good_independent (good_le le_p g).
  by apply/rowP=> k; rewrite !mxE.
rewrite /ruled_surface (BZZ19_16_piece t lt_j nz hR eP).
have -> (T : 'rV[{poly F}]_3) : after T 'X = T by apply/rowP=> k; rewrite mxE comp_polyXr.
by rewrite (BZZ19_16_piece t lt_j nz hS eQ).
Qed.
End Surface.
