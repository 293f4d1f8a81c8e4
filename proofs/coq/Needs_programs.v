(* The programs of the files Executable*.v: what happens without the hypotheses of their theorems, one counterexample each, where those of the formulas that they compute
   (Needs_FJ21.v, ...) do not say it already. *)
From Torse Require Import Prelude Blossom Curves Points Bernstein Bezier Functions BZZ19_3 BZZ19_3_range BZZ19_4 BZZ19_4_written.
From Torse Require Import FJ21_2 FJ21_3 FJ21_3_needs FJ21_4 FJ21_5 FJ21_5_changes FJ21_6_theorem.
From Torse Require Import Needs_blossoms Needs_FJ07 Needs_FJ21 Needs_FJ21_5 Needs_ZW06 Executable Executable_knots Executable_FJ21 Executable_changes Executable_determinant.
From Torse Require Import Executable_edge Executable_rational Executable_composition Executable_splines Executable_mappings Executable_directrix.

Ltac by_units := rewrite ?(mul0r, mulr0, mul1r, mulr1, add0r, addr0, subr0, sub0r, subrr, addNr, oppr0, mulrN1, mulN1r, mulrNN, opprK, invrN, invr1, oppr_eq0, oner_eq0).

Section Jets.
Variables (F : fieldType) (lt : F -> F -> bool).
Notation e1 := (e1 F).
Notation e2 := (e2 F).
Local Notation K := (of_field lt).
Implicit Types (n : nat) (k : F).
Let one_is_not_zero := @one_is_not_zero F.

(** FJ21.5.3 inverse_needs_factor: for $f=t$, $g=1$ at $t=0$ the program for $\Lambda=\sigma=1$, $M=0$ gives $\tilde\Lambda=\tilde M=\tilde\sigma=0$, which relate $fp$, $gq$ for all
    $p$, $q$; the given numbers do not relate $p=(1,0,0)$, $q=(0,1,0)$.
    Hypotheses: $n$ and $n+1$ are not 0 in the field. *)
Theorem FJ21_5_3_inverse_needs_factor n (p := jet e1 0) (q := jet e2 0) : n%:R != 0 :> F -> n.+1%:R != 0 :> F ->
  [/\ elevated_program K n 0 1 0 1 0 1 1 0 = Value [:: 0; 0; 0], related_at n.+1 (linear 0 1 *: p) (linear 1 0 *: q) 0 0 0 0 & ~ related_at n p q 0 1 0 1].
Proof.
rewrite natrS /p /q => n0 n1; split; at_zero; [|by by_coords; ring | by split_coords => h1 _ _; refute (1 : F) h1].
by rewrite /elevated_program of_natE /nonzero /=; by_units; rewrite n0 n1 /=; by_units.
Qed.

(** FJ21.5.4 inverse_needs_f: likewise for $f=t$, $g=1$ at $t=0$.
    Hypotheses: $n\ne0$ in the field. *)
Theorem FJ21_5_4_inverse_needs_f n (p := jet e1 0) (q := jet e2 0) (f := linear 0 1) (g := linear 1 0) : n%:R != 0 :> F ->
  [/\ shortened_program K n 0 1 0 1 0 1 1 0 = Value [:: 0; 0; 0], related_at n.+1 (f *: p) (f *: p + g *: (q - p)) 0 0 0 0 & ~ related_at n p q 0 1 0 1].
Proof.
rewrite /p /q /f /g => n0; split; at_zero; [|by by_coords; ring | by split_coords => h1 _ _; refute (1 : F) h1].
by rewrite /shortened_program of_natE /nonzero /=; by_units; rewrite n0 /=; by_units.
Qed.

(** FJ21.5.4 inverse_needs_g: for $f=1$, $g=t$ at $t=0$ the program for $\Lambda=0$, $M=\sigma=1$ gives $\tilde\Lambda=\tilde M=0$, $\tilde\sigma=1$, which relate $fp$ and
    $fp+g(q-p)$ for all $p$, $q$; the given numbers do not relate $p=(1,0,0)$, $q=(0,1,0)$. *)
Theorem FJ21_5_4_inverse_needs_g n (p := jet e1 0) (q := jet e2 0) (f := linear 1 0) (g := linear 0 1) :
  [/\ shortened_program K n 0 0 1 1 1 0 0 1 = Value [:: 0; 0; 1], related_at n.+1 (f *: p) (f *: p + g *: (q - p)) 0 0 0 1 & ~ related_at n p q 0 0 1 1].
Proof.
rewrite /p /q /f /g; split; at_zero; [|by by_coords; ring | by split_coords => h1 _ _; refute (1 : F) h1].
by rewrite /shortened_program of_natE /nonzero /=; by_units => /=; by_units.
Qed.

(** FJ21.5.4 inverse_needs_degree: where $n=0$ in the field, $f=g=1+t$ at $t=0$: the program for $\Lambda=M=\sigma=1$ gives $\tilde\Lambda=\tilde M=-1$, $\tilde\sigma=1$, which relate
    the rows of $p=(1,0,0)$, $q=(0,1,0)$ in degree $n+1$; whatever stands for $\frac1n$ the given numbers do not relate $p$ and $q$. *)
Theorem FJ21_5_4_inverse_needs_degree n (p := jet e1 0) (q := jet e2 0) (f := linear 1 1) : n%:R = 0 :> F ->
  [/\ shortened_program K n 0 1 1 1 1 1 1 1 = Value [:: -1; -1; 1], related_at n.+1 (f *: p) (f *: p + f *: (q - p)) 0 (-1) (-1) 1
    & forall k, ~ related_with k p q 0 1 1 1].
Proof.
rewrite /p /q /f => n0; split=> [||k]; at_zero; rewrite ?natrS ?n0 ?add0r ?invr1; [|by by_coords; ring | by split_coords => h1 _ _; refute (1 : F) h1].
by rewrite /shortened_program of_natE /nonzero /= n0; by_units => /=; by_units.
Qed.

(** FJ21.5.4 inverse_needs_next: where $n+1=0$ in the field, $f=g=1$ at $t=0$: the program for $\Lambda=M=\sigma=1$ gives $\tilde\Lambda=\tilde M=0$, $\tilde\sigma=1$; the given numbers
    relate $p=(1,0,0)$ and $q=-t(1,0,0)$, and whatever stands for $\frac1{n+1}$ those of the program do not relate the rows in degree $n+1$. *)
Theorem FJ21_5_4_inverse_needs_next n (p := jet e1 0) (q := jet 0 (- e1)) (f := linear 1 0) : n.+1%:R = 0 :> F ->
  [/\ shortened_program K n 0 1 1 1 1 0 1 0 = Value [:: 0; 0; 1], related_at n p q 0 1 1 1
    & forall k, ~ related_with k (f *: p) (f *: p + f *: (q - p)) 0 0 0 1].
Proof.
rewrite /p /q /f => n1; have nN : n%:R = -1 :> F by apply/eqP; rewrite -addr_eq0 -natrS n1.
split=> [||k]; at_zero; rewrite ?nN ?invrN ?invr1; [|by by_coords; ring | by split_coords => h1 _ _; refute (1 : F) h1].
by rewrite /shortened_program of_natE /nonzero /= nN; by_units => /=; by_units.
Qed.

(** FJ21.5.2 program_needs_rows: two rows $1,1$ and three rows $1,1,1$ in degree 1: $\Lambda=M=0$, $\sigma=1$ relate them at $t=0$, and the rows of the program, $b,1$ and $b^2,b,1$,
    are not related by its $\tilde\Lambda=\tilde M=0$, $\tilde\sigma=1$.
    Hypotheses: $b\ne0$ and $b\ne1$. *)
Theorem FJ21_5_2_program_needs_rows b (V := rows F 1) (c := nseq 2 (const_mx 1 : 'rV[F]_1)) (d := nseq 3 (const_mx 1 : 'rV[F]_1)) : b != 0 -> b != 1 ->
  [/\ moebius_program K b 0 = Value [:: 0], moebius_functions_program K 0 0 1 b = Value [:: 0; 0; 1],
      pblossom (step01 F 1) (nth 0 c) [:: at_ 0] = 1 *: pblossom (step01 F 1) (nth 0 d) [:: at_ 0] &
      pblossom (step01 F 1) (nth 0 (moebius_rows K V b c)) [:: at_ 0] <> 1 *: pblossom (step01 F 1) (nth 0 (moebius_rows K V b d)) [:: at_ 0]].
Proof.
move=> b0 b1; split.
- by rewrite /moebius_program /nonzero /=; by_units; rewrite b0.
- by rewrite /moebius_functions_program /nonzero /=; by_units => /=; by_units.
- by rewrite !line_blossom scale1r.
rewrite !line_blossom scale1r !subr0 !scale0r !addr0 !scale1r /= => /rowP/(_ 0); rewrite !mxE !mulr1 -[LHS]mulr1 => /(mulfI b0)/esym/eqP.
by rewrite (negPf b1).
Qed.
End Jets.

Section Rows.
Variables (F : fieldType) (lt : F -> F -> bool).
Local Notation K := (of_field lt).
Local Notation V := (rows F 1).
Local Notation bezier c := (pbez (size c).-1 (nth 0 c)).
Implicit Types (n : nat) (k x L M : F) (r : seq 'rV[F]_1).

Let point x : 'rV[F]_1 := const_mx x.

(* Where n + 1 = 0 in the field every Bezier curve of degree n + 1 has the derivative 0. *)
Lemma still n (c : nat -> 'rV[F]_1) : n.+1%:R = 0 :> F -> pderiv (pbez n.+1 c) = 0.
Proof. by move=> n1; apply/rowP=> k; rewrite !mxE deriv_bez_low n1 scale0r. Qed.

Lemma bez_first n : bez n (fun i => (i == 0%N)%:R : F) = (1 - 'X) ^+ n.
Proof.
rewrite /bez big_nat_recl // big1_seq => [|i _]; last by rewrite polyC0 mul0r.
by rewrite polyC1 mul1r addr0 /B bin0 expr0 subn0 !mul1r.
Qed.

(** BZZ19.15 program_needs_next: where $n+1=0$ in the field no Bezier curve of degree $n+1$ is the curve $(1-t)^n$ of the points $1,0,\dots,0$ of degree $n$. *)
Theorem BZZ19_15_program_needs_next n (c := mkseq (fun i => point (i == 0%N)%:R) n.+1) (r : nat -> 'rV[F]_1) : n.+1%:R = 0 :> F -> pbez n.+1 r <> bezier c.
Proof.
move=> n1 e; have := congr1 (@pderiv F 1) e; rewrite still // => /rowP/(_ 0); rewrite size_mkseq !mxE.
rewrite (_ : bez n _ = (1 - 'X) ^+ n); last by rewrite -bez_first; apply: bez_ext => i le_i; rewrite /coord nth_mkseq // mxE.
have nN : n%:R = -1 :> F by apply/eqP; rewrite -addr_eq0 -natrS n1.
move/(congr1 (fun p : {poly F} => p.[0])); rewrite deriv_Y hornerM horner_exp !(hornerN, hornerD, hornerC, hornerX) -(polyC_nat F) hornerC nN subr0 expr1n ?horner0.
by rewrite opprK mulr1 => /esym/eqP; rewrite oner_eq0.
Qed.

(** FJ21.6.1 program_needs_next: where $n+1=0$ in the field no Bezier curve of degree $n+1$ is the edge $\frac{\Lambda-t}{\Lambda-M}$ of the constant rows $p=q=1$ for $\sigma=0$.
    Hypotheses: $\Lambda\ne M$. *)
Theorem FJ21_6_1_program_needs_next n L M (p := nseq n.+1 (point 1)) (r : nat -> 'rV[F]_1) : n.+1%:R = 0 :> F -> L != M ->
  pbez n.+1 r <> ((L - M)^-1)%:P *: ((L%:P - 'X) *: bezier p + (0%:P * ('X - M%:P)) *: bezier p).
Proof.
move=> n1; rewrite -subr_eq0 => d0 e; have := congr1 (@pderiv F 1) e; rewrite still // => /rowP/(_ 0); rewrite size_nseq !mxE.
rewrite (_ : bez n _ = 1); last by rewrite -(bez1 F n); apply: bez_ext => i le_i; rewrite /coord nth_nseq ltnS le_i mxE.
rewrite polyC0 mul0r mul0r addr0 mulr1 derivM derivB !derivC derivX mul0r add0r sub0r mulrN1 => /eqP.
by rewrite eq_sym oppr_eq0 polyC_eq0 invr_eq0 (negPf d0).
Qed.

(** FJ21.6.1 program_needs_rows: for the two rows $p=(0,0)$ and the one row $q=1$, $\Lambda=\sigma=1$, $M=0$ the program gives a curve that is 0 at $t=1$, where
    $\frac{(\Lambda-t)p+\sigma(t-M)q}{\Lambda-M}$ is 1. *)
Theorem FJ21_6_1_program_needs_rows (p := [:: point 0; point 0]) (q := [:: point 1]) r : edge_rows_program K V p q 1 0 1 = Value r ->
  bezier r <> ((1 - 0)^-1)%:P *: ((1%:P - 'X) *: bezier p + (1%:P * ('X - 0%:P)) *: bezier q).
Proof.
rewrite /edge_rows_program /= oner_eq0 /= => -[<-] /rowP/(_ 0)/(congr1 (fun g : {poly F} => g.[1])).
rewrite !mxE /= (bez_ends _ _).2 !(hornerM, hornerD, hornerN, hornerC, hornerX) !(bez_ends _ _).2 /coord /= !mxE.
by by_units => /esym/eqP; rewrite oner_eq0.
Qed.

(** FJ21.T6.1 program_needs_next: where $n+1=0$ in the field the curve $r=t^{n+1}$ of the points $0,\dots,0,1$ has $r'=0$, so that $r+k(x-t)r'=r$ for every number $k$ in the place of
    $\frac1{n+1}$, and $r$ is no Bezier curve of degree $n$. *)
Theorem FJ21_T6_1_program_needs_next n k x (c := mkseq (tip F n.+1) n.+2) (z : nat -> 'rV[F]_1) : n.+1%:R = 0 :> F ->
  bezier c + (k *: (x%:P - 'X)) *: pderiv (bezier c) <> pbez n z.
Proof.
move=> n1; rewrite size_mkseq /= still // scaler0 addr0 (pbez_ext (d := tip F n.+1)) => [|i le_i]; last by rewrite nth_mkseq.
rewrite tip_power => /rowP/(_ 0); rewrite !mxE => e; have := size_bez n (coord z 0).
by rewrite -e size_polyXn ltnn.
Qed.

(** ZW06.8 program_needs_points: for the two points $0,0$ of the directrix, the one vector $\tau=1$ and $b=1$ the program gives a curve that is 0 at $u=1$, where
    $a(u)-b\tau=-1$. *)
Theorem ZW06_8_program_needs_points (c := [:: point 0; point 0]) (tau := [:: point 1]) :
  pbez ((size c).-1 + (size [:: 1 : F]).-1) (nth 0 (edge_of K V c tau [:: 1])) <> bezier c - bernstein [:: 1] *: bezier tau.
Proof.
move/rowP/(_ 0)/(congr1 (fun g : {poly F} => g.[1])); rewrite !mxE /bernstein !(hornerD, hornerN, hornerM) !(bez_ends _ _).2 /coord /= !mxE.
by by_units => /esym/eqP; rewrite oppr_eq0 oner_eq0.
Qed.

(** ZW06.11 program_needs_characteristic: where $n=0$ in the field ($n\ge1$) $a(u)=u^n$ and a constant $\tau$ have $a'=0$, so that $a=b=0$ is the equation of a cone, and the
    program gives the vertex $0$, not on the ruling through $a(1)=1$ for $\tau=0$. *)
Theorem ZW06_11_program_needs_characteristic n (c := mkseq (tip F n) n.+1) (tau := [:: point 0]) : n%:R = 0 :> F -> (0 < n)%N ->
  [/\ vertex_of_cone K V c tau [::] [::] = Value 0, pderiv (bezier c) = bernstein [::] *: bezier tau + bernstein [::] *: pderiv (bezier tau)
    & ev (bezier c) 1 + 0 *: ev (bezier tau) 1 <> 0 + (0 + (bernstein [::]).[1]) *: ev (bezier tau) 1].
Proof.
move=> n0 n1; have none : bernstein [::] = 0 :> {poly F} by rewrite /bernstein /bez big_nat1 polyC0 mul0r.
have ec : bezier c = const_mx 'X^n.
  by rewrite size_mkseq /= (pbez_ext (d := tip F n)) ?tip_power // => i le_i; rewrite nth_mkseq.
split.
- rewrite /vertex_of_cone (_ : is_cone K [::] [::] = true) /=; last by apply/ZW06_9_program; rewrite none linear0.
  by congr Value; apply/rowP=> j; rewrite !mxE eq_sym (gtn_eqF n1) mul0r subr0.
- rewrite ec none !scale0r addr0; apply/rowP=> j; rewrite !mxE derivXn -mulr_natl -(polyC_nat F) n0 polyC0 mul0r //.
rewrite ec none horner0 addr0 !scale0r !addr0 => /rowP/(_ 0); rewrite !mxE hornerXn expr1n => /eqP.
by rewrite oner_eq0.
Qed.

(** BZZ19.3 coefficients_needs_degree: where $n=0$ in the field the coefficients $k(u_i+\dots+u_{i+n-1})$ give $\sigma=0$, whatever number $k$ stands for $\frac1n$.
    Hypotheses: the knots carry the piece. *)
Theorem BZZ19_3_coefficients_needs_degree n (u : nat -> F) k : n%:R = 0 :> F -> span n u -> curve n u (fun i => k * greville n u i) <> 'X.
Proof.
move=> n0 sp; have -> : curve n u (fun i => k * greville n u i) = k%:P * curve n u (greville n u).
  rewrite /curve -[RHS]addr0 -[X in _ + X](mul0r (curve n u (greville n u))) -blossom_linear; apply: blossom_ext => i _.
  by rewrite /polys polyCM mul0r addr0.
by rewrite BZZ19_3_identity // -(polyC_nat F) n0 polyC0 mul0r mulr0 => /esym/eqP; rewrite polyX_eq0.
Qed.

(** BZZ19.3 coefficients_needs_piece: off the list there are no coefficients: for the knots $0,0,1,2$ of degree 2 the program gives $0,\frac12,\frac32$; with zeros behind
    the lists the knots $0,1,2,0$ carry a piece, on which $\sigma(0)=1$.
    Hypotheses: $2\ne0$ in the field. *)
Theorem BZZ19_3_coefficients_needs_piece (u := [:: 0; 0; 1; 2%:R : F]) (r := [:: 0; 2%:R^-1; 3%:R / 2%:R : F]) : 2%:R != 0 :> F ->
  [/\ greville_program (of_field (fun _ _ : F => false)) 2 u = Value r, span 2 (drop_ 1 (nth 0 u)) & (curve 2 (drop_ 1 (nth 0 u)) (drop_ 1 (nth 0 r))).[0] = 1].
Proof.
move=> n2; have e1 : 2%:R - 1 = 1 :> F by rewrite mulr2n addrK.
have sp : span 2 (drop_ 1 (nth 0 u)).
  by move=> [|[|//]] [|[|[|[|//]]]] // _ _; rewrite unitfE /drop_ /u /= ?subr0 ?sub0r ?e1 ?oppr_eq0 ?oner_eq0.
split=> //; last first.
  rewrite horner_curve // /= /step /shift /drop_ /u /r /= e1 !(mul1r, mulr1, subr0, sub0r, mul0r, mulr0, addr0, add0r, oppr0, divr1).
  by field; rewrite n2.
apply/knot_listP; split.
  split=> // [[|[|//]] _ /=|]; rewrite /u /= eq_sym ?oner_eq0 //.
by congr Value; rewrite /r /total /last_ /mkseq /= !(add0r, addr0) mul0r mul1r; congr [:: _; _; _ / _].
Qed.
End Rows.

Section Determinant.
Variable F : fieldType.
Local Notation K := (of_field (fun _ _ : F => false)).
Local Notation V := (rows F 4).
Local Notation wt := (@weight F).
Local Notation px := (fun p => x_ (place p)).
Local Notation py := (fun p => y_ (place p)).
Local Notation pz := (fun p => z_ (place p)).
Local Notation u := [:: 0; 0; 1; 1 : F].
Local Notation c := [:: row4 1 0 0 0; 0; row4 0 1 0 0 : 'rV[F]_4].
Local Notation d := [:: row4 1 0 1 0; row4 0 0 0 1; row4 0 0 1 0 : 'rV[F]_4].
Local Notation last_of r x := (last_point 2 (drop_ 0 (nth 0 u)) (drop_ 0 (nth 0 r)) x).

Lemma carried : span 2 (drop_ 0 (nth 0 u)).
Proof. by move=> [|[|//]] [|[|[|[|//]]]] // _ _; rewrite unitfE /drop_ /= subr0 oner_eq0. Qed.

Lemma last_ofE (r : seq 'rV[F]_4) x : last_of r x
  = (1 - 'X) *: map_mx polyC ((1 - x) *: nth 0 r 0 + x *: nth 0 r 1) + 'X *: map_mx polyC ((1 - x) *: nth 0 r 1 + x *: nth 0 r 2).
Proof.
apply/rowP=> k; rewrite !mxE /= /step /shift /polys /drop_ /coord /= !polyC0 !polyC1 !subr0 !divr1 !mul1r !polyCD !polyCM polyCB polyC1.
by move: (nth 0 r 0 0 k)%:P (nth 0 r 1 0 k)%:P (nth 0 r 2 0 k)%:P x%:P 'X => *; ring.
Qed.

Lemma example_det : \det (rows4 (last_of c 0) (last_of c 1) (last_of d 0) (last_of d 1)) = (1 - 'X) * 'X * (1 - 'X - 'X).
Proof.
rewrite !last_ofE !(subr0, subrr, scale0r, scale1r, addr0, add0r) /=.
have e (x y z w x' y' z' w' : F) : (1 - 'X) *: map_mx polyC (row4 x y z w) + 'X *: map_mx polyC (row4 x' y' z' w')
    = row4 ((1 - 'X) * x%:P + 'X * x'%:P) ((1 - 'X) * y%:P + 'X * y'%:P) ((1 - 'X) * z%:P + 'X * z'%:P) ((1 - 'X) * w%:P + 'X * w'%:P).
  by apply/rowP=> -[[|[|[|[|//]]]] lt_k]; rewrite !mxE.
have -> : (0 : 'rV[F]_4) = row4 0 0 0 0 by apply/rowP=> -[[|[|[|[|//]]]] lt_k]; rewrite !mxE.
by rewrite !e det_row4 polyC0 polyC1; move: 'X => X; ring.
Qed.

(** FJ21.C3.1 decides_needs_characteristic: in characteristic 3, $n=2$, the determinant of the Bezier points $(1,0,0,0),0,(0,1,0,0)$ and $(1,0,1,0),(0,0,0,1),(0,0,1,0)$ is
    $t(1-t)(1-2t)$, which is 0 at all the parameters $0,\dots,4$: the programs do not refute the surface, and the rows are independent and the surface is not developable.
    Hypotheses: $3=0$ in the field. *)
Theorem FJ21_C3_1_decides_needs_characteristic : 3%:R = 0 :> F ->
  [/\ ~~ refuted4 K V wt px py pz 2 u c d 1, check4_program K V wt px py pz 2 u c d = Value 0%N,
      ~ dependent4 (last_of c 0) (last_of c 1) (last_of d 0) (last_of d 1) &
      ~ rational_developable (pcurve 2 (drop_ 0 (nth 0 u)) (drop_ 0 (nth 0 c))) (pcurve 2 (drop_ 0 (nth 0 u)) (drop_ 0 (nth 0 d)))].
Proof.
move=> three; have two : 2%:R != 0 :> F.
  by apply: contra_neq (oner_neq0 F) => two; rewrite -[RHS]three (natrD _ 2 1) two add0r.
have cube j : (1 - j%:R) * j%:R * (1 - j%:R - j%:R) = 0 :> F.
  elim: j => [|j ih]; rewrite ?mulr0 ?mul0r // mulrSr; move: (j%:R) ih => x ih.
  by rewrite -[RHS]ih; apply: (by_multiple (z := 2%:R * x * x) three); ring.
have ok : ~~ refuted4 K V wt px py pz 2 u c d 1.
  rewrite /refuted4 negbK; apply/allP=> j _; rewrite of_natE -(@condition4E F _ 2 u c d 0 j%:R isT carried); apply/(@eqP F).
  by have := congr1 (fun f : {poly F} => f.[j%:R]) example_det; rewrite !(hornerM, hornerD, hornerN, hornerX, hornerC) cube.
have indep : ~ dependent4 (last_of c 0) (last_of c 1) (last_of d 0) (last_of d 1).
  have nz (f : {poly F}) : f.[0] = 1 -> f != 0 by move=> f1; apply: contra_neq (oner_neq0 F) => f0; rewrite -f1 f0 horner0.
  move/det_dependent/eqP; rewrite example_det !mulf_eq0 polyX_eq0 orbF (negPf (nz _ _)) ?(negPf (nz (_ - _ - _) _)) //.
  - by rewrite !hornerE !subr0.
  - by rewrite !hornerE subr0.
split=> //.
  apply/knot_listP; split; last first.
    by apply/fitsP; split=> //; apply/fitsP; split=> //; rewrite /last_ /= (negPf ok) andbF.
  by split=> //; [case=> [|[|//]] _ /= | rewrite /=]; rewrite eq_sym oner_eq0.
have w0 (r : seq 'rV[F]_4) : nth 0 r 0 0 0 = 1 -> weight (pcurve 2 (drop_ 0 (nth 0 u)) (drop_ 0 (nth 0 r))) != 0.
  move=> r0; apply/eqP=> /(congr1 (fun f : {poly F} => f.[0])); rewrite horner0 /weight mxE horner_curve; last exact: carried.
  by rewrite /= /step /shift /drop_ /coord /= r0; by_units => /eqP; rewrite ?divr1; by_units.
have ab : 0 != 1 :> F by rewrite eq_sym oner_eq0.
by move/(FJ21_C3_1_dependent two carried ab (w0 _ _) (w0 _ _)) => dep; apply: indep; apply: dep; rewrite mxE.
Qed.
End Determinant.
