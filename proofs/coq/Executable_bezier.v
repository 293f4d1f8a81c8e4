(* The Bezier points that the programs give are those of the whole curve, piece by piece. *)
From Torse Require Import Prelude Blossom Curves Points Bernstein Bezier Segments BZZ19_3 BZZ19_4_pieces Joints FJ21_4 Executable Executable_knots
  Executable_splines Executable_mappings Executable_joints.
From mathcomp Require Import order ssrnum.
Import Order.TTheory Num.Theory.

(** blossoms restricted: the points that the program gives for $[a,b]$ are those of a Bezier curve $C$ with $C(s)=c((1-s)a+sb)$ on piece $k$, wherever it gives a
    value. *)
Theorem blossoms_restricted (F : fieldType) m lt n (u : seq F) (c : seq 'rV[F]_m) k a b r :
  pieces_program (of_field lt) (rows F m) n u c k.+1 a b = Value r ->
  pbez n (nth 0 r) = map_mx (fun f => f \Po line a b) (pcurve n (drop_ k (nth 0 u)) (drop_ k (nth 0 c))).
Proof.
case/blossoms_pieces=> sp e; apply/rowP=> i; rewrite !mxE BZZ19_11_piece //; apply: bez_ext => j le_j.
by rewrite /coord e // mxE.
Qed.

Section Curves.
Variables (F : realFieldType) (m : nat).
Implicit Types (u : seq F) (c r : seq 'rV[F]_m) (n k : nat) (t : F).
Local Notation K := (ordered F).
Local Notation V := (rows [fieldType of F] m).
Local Notation at_list := (nth 0).

(* The zeros behind a list of knots can carry a piece that begins at the end of the domain. *)
Lemma same_end n u (g : nat -> F) i j t : valid (fun x y : F => x < y) n u -> lies n u t i -> t <= at_list u (size u - n) -> (size u - n <= j)%N ->
  at_list u j <= t -> at_list u j < at_list u j.+1 -> span n (drop_ (j.+1 - n) (at_list u)) ->
  (curve n (drop_ (i.+1 - n) (at_list u)) (drop_ (i.+1 - n) g)).[t] = (curve n (drop_ (j.+1 - n) (at_list u)) (drop_ (j.+1 - n) g)).[t].
Proof.
move=> hu [bi _ up_i t_i] t_L le_j j_t up_j sp_j; have [n0 le_n _] := bounds_of hu.
have lt_j : (j < size u)%N.
  by rewrite ltnNge; apply/negP=> out; move: up_j; rewrite !nth_default ?ltxx // leqW.
have e_i : at_list u i.+1 = at_list u (size u - n).
  case: t_i => [lt_t|[] //]; suff up : at_list u i.+1 <= at_list u j by move: (lt_le_trans (le_lt_trans j_t lt_t) up); rewrite ltxx.
  by apply: (knots_up hu); move: bi le_j lt_j; clear; lia.
have e_t : at_list u j = t.
  by apply/eqP; rewrite eq_le j_t (le_trans t_L) // (knots_up hu) // le_j.
have run l : (i < l <= j)%N -> at_list u l = t.
  move=> in_l; apply/eqP; rewrite eq_le -{1}e_t (knots_up hu) ?(le_trans t_L) // -?e_i ?(knots_up hu) //; move: in_l lt_j; clear; lia.
pose r := (j - i)%N; have er : (i.+1 + r = j.+1)%N by rewrite /r; move: bi le_j; clear; lia.
have le_r : (r <= n)%N.
  by apply: leq_trans (times_of t hu); apply: (@count_run _ t u i.+1); rewrite ?er // => l; rewrite ltnS => h; apply: run.
have sp_i : span n (drop_ (i.+1 - n) (at_list u)) by apply: blossoms_carried; rewrite ?lt_eqF.
have dropE (w : nat -> F) q : drop_ (j.+1 - n) w q = drop_ r (drop_ (i.+1 - n) w) q.
  by rewrite /drop_; congr (w _); move: bi er n0; clear; lia.
rewrite !horner_curve // (_ : nseq n (at_ t) = nseq r (at_ t) ++ nseq (n - r) (at_ t)); last by rewrite -nseqD subnKC.
rewrite (blossoms_joint (n := n)) ?size_nseq ?subnKC //.
- rewrite [RHS](@blossom_ext_knots _ _ (drop_ r (drop_ (i.+1 - n) (at_list u)))) => [|q _]; last exact: dropE.
  by apply: blossom_ext => q _; rewrite -dropE.
- by move=> q q' h1 h2; rewrite -!dropE; exact: sp_j.
by move=> q h_q; apply: run; move: h_q bi er n0; clear; lia.
Qed.

(** blossoms bezier: the point at $t$ of the curve is that at $\frac{t-a}{b-a}$ of the Bezier curve whose points the program gives for a piece $[a,b]$ that holds
    $t$, the one before a knot or the one after it.
    Hypotheses: an ordered field. $k$ may be any: a piece behind the curve's last one, which the zeros that the program finds there can carry, holds no $t$ of the
    domain but its end. *)
Theorem blossoms_bezier n u c k r t q (a := at_list u (n + k - 1)) (b := at_list u (n + k)) : mapping_value_program K V n u c t = Value q ->
  bezier_program K V n u c k.+1 = Value r -> a <= t <= b -> q = ev (pbez n (at_list r)) ((t - a) / (b - a)).
Proof.
case/BZZ19_3_value=> hu _ in_u -> e in_t; have [n0 le_n _] := bounds_of hu.
have [e1 e2] : (n + k.+1 - 2 = n + k - 1 /\ n + k.+1 - 1 = n + k)%N by move: n0; clear; lia.
rewrite /bezier_program /= e1 e2 -/a -/b in e; have [sp _] := blossoms_pieces e.
have [ek ek'] : ((n + k - 1).+1 = n + k /\ n + k - n = k)%N by move: n0; clear; lia.
have [lo lo'] : (n.-1 <= n + k - 1)%N /\ (n.-1 + k = n + k - 1)%N by move: n0; clear; lia.
have up : a < b.
  rewrite lt_neqAle (le_trans (proj1 (andP in_t)) (proj2 (andP in_t))) andbT.
  have := sp n.-1 n; rewrite unitfE /drop_ subr_eq0 eq_sym [(k + n.-1)%N]addnC lo' [(k + n)%N]addnC; apply; move: n0; clear; lia.
have -> : ev (pbez n (at_list r)) ((t - a) / (b - a)) = ev (pcurve n (drop_ k (at_list u)) (drop_ k (at_list c))) t.
  rewrite (blossoms_restricted e); apply/rowP=> i; rewrite !mxE horner_comp; congr (_.[_]).
  by rewrite /line hornerD hornerM hornerX !hornerC mulrC divfK ?subr_eq0 ?gt_eqF // addrC subrK.
have [bI I_t up_I t_I] := lies_in hu in_u; rewrite -[in RHS]ek' -ek.
have I_in : at_list u (interval K n u t) <= t <= at_list u (interval K n u t).+1.
  by rewrite I_t; case: t_I => [/ltW|[->]] //; have/andP[] := in_u.
have [lt_k|ge_k] := ltnP (n + k - 1) (size u - n).
  by apply: blossoms_continuous; rewrite ?lo ?ek //; rewrite -ek.
apply/rowP=> l; rewrite !mxE; apply: (same_end (coord (at_list c) l) hu (lies_in hu in_u)) => //; rewrite ?ek ?ek' //; last by have/andP[] := in_t.
by have/andP[] := in_u.
Qed.

(** blossoms bezier_exists: for every $t$ of the domain the program gives the points of a piece that holds $t$.
    Hypotheses: an ordered field. *)
Theorem blossoms_bezier_exists n u c t q : mapping_value_program K V n u c t = Value q ->
  exists k r, [/\ bezier_program K V n u c k.+1 = Value r, (n + k - 1 < size u - n)%N & at_list u (n + k - 1) <= t <= at_list u (n + k)].
Proof.
case/BZZ19_3_value=> hu sc in_u _; have [[/andP[b1 b2] le_t up in_t] e] := piece_lies hu in_u; have [n0 le_n _] := bounds_of hu.
move: b1 b2 le_t up in_t e; set k := (piece_at K n u t).-1 => b1 b2 le_t up in_t e.
have ek : ((n + k - 1).+1 = n + k)%N by move: n0; clear; lia.
have sp : span n (drop_ k (at_list u)) by rewrite -e; apply: blossoms_carried; rewrite ?b1 ?lt_eqF.
exists k; eexists; split=> //.
  apply/knot_listP; split=> //; apply/fitsP; split=> //; rewrite /given ifT //.
  by apply/carriesP=> i j h1 h2; rewrite !nth_drop; exact: sp.
by rewrite le_t /= -ek; case: in_t => [/ltW|[->]] //; have/andP[] := in_u.
Qed.
End Curves.
