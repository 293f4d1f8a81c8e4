(* The operations of IEEE 754 keep the standard model, in terms of rational numbers, which Rounding_net.v can take.
   Definitions:
     real x           a rational number among the real ones
     rational x       the value of a number; 0 for infinities and NaN
     machine prec emax   the four operations of Binary.v
     unit_roundoff prec, least_normal emax   2^-prec and 2^(2 - emax)
     times_survives x y, over_survives x y   a product, a quotient that do not underflow *)
From Torse Require Import Prelude_binary Binary Rounding.

Section Values.
Definition real (x : rat) : R := (IZR (Z_of_int (numq x)) / IZR (Z_of_int (denq x)))%Re.
Arguments real x%R.

Lemma IZR_neq0 (b : int) : b != 0 -> IZR (Z_of_int b) <> 0%Re.
Proof. by move=> nz /eq_IZR_R0 e; case/eqP: nz; lia. Qed.

Lemma real_frac (a b : int) : b != 0 -> real (a%:~R / b%:~R) = (IZR (Z_of_int a) / IZR (Z_of_int b))%Re.
Proof.
move=> nb; set x := a%:~R / b%:~R; rewrite /real; have nd := denq_neq0 x.
have e : numq x * b = a * denq x.
  apply/eqP; rewrite -(eqr_int [numDomainType of rat]) !rmorphM /= -eqr_div ?intr_eq0 // divq_num_den.
  by rewrite /x.
have := congr1 (fun z => IZR (Z_of_int z)) e; rewrite !rmorphM /= !mult_IZR => {}e.
by apply: quotient_eq => //; exact: IZR_neq0.
Qed.

Lemma real_add x y : real (x + y) = (real x + real y)%Re.
Proof.
rewrite -{1}[x]divq_num_den -{1}[y]divq_num_den addf_div ?intr_eq0 ?denq_neq0 //.
rewrite -!intrM -intrD real_frac ?mulf_neq0 ?denq_neq0 // rmorphD !rmorphM plus_IZR !mult_IZR.
by apply: quotient_sum; apply: IZR_neq0; exact: denq_neq0.
Qed.

Lemma real_mul x y : real (x * y) = (real x * real y)%Re.
Proof.
rewrite -{1}[x]divq_num_den -{1}[y]divq_num_den mulf_div -!intrM real_frac ?mulf_neq0 ?denq_neq0 //.
rewrite !rmorphM !mult_IZR.
by apply: quotient_product; apply: IZR_neq0; exact: denq_neq0.
Qed.

Lemma real_int (z : int) : real z%:~R = IZR (Z_of_int z).
Proof. by rewrite /real numq_int denq_int /= /Rdiv Rinv_1 Rmult_1_r. Qed.

Lemma real_opp x : real (- x) = (- real x)%Re.
Proof. by rewrite /real numqN denqN rmorphN opp_IZR /Rdiv Ropp_mult_distr_l. Qed.

Lemma real_sub x y : real (x - y) = (real x - real y)%Re.
Proof. by rewrite real_add real_opp. Qed.

Lemma real_pos x : 0 < x -> (0 < real x)%Re.
Proof.
have pos (z : int) : 0 < z -> (0 < IZR (Z_of_int z))%Re by move=> z0; apply: IZR_lt; lia.
by move=> x0; apply: Rdiv_lt_0_compat; apply: pos; rewrite ?numq_gt0 ?denq_gt0.
Qed.

Lemma real_le x y : (real x <= real y)%Re -> x <= y.
Proof.
move=> h; rewrite leNgt; apply/negP; rewrite -subr_gt0 => /real_pos; rewrite real_sub.
by move=> h'; lra.
Qed.

Lemma real_increasing x y : x <= y -> (real x <= real y)%Re.
Proof.
rewrite le_eqVlt => /orP[/eqP->|]; first exact: Rle_refl.
by rewrite -subr_gt0 => /real_pos; rewrite real_sub; lra.
Qed.

Lemma real_gt0 x : (0 < real x)%Re -> 0 < x.
Proof. by move=> h; rewrite ltNge; apply/negP=> /real_increasing; rewrite (real_int 0) => h'; exact: (Rlt_irrefl _ (Rlt_le_trans _ _ _ h h')). Qed.

Lemma real_inj x y : real x = real y -> x = y.
Proof. by move=> e; apply/le_anti/andP; split; apply: real_le; rewrite e; exact: Rle_refl. Qed.

Lemma real_norm x : real `|x| = Rabs (real x).
Proof.
have [x0|x0|->] := ltrgt0P x.
- by rewrite Rabs_pos_eq //; exact/Rlt_le/real_pos.
- by rewrite real_opp Rabs_left //; move: x0; rewrite -oppr_gt0 => /real_pos; rewrite real_opp; lra.
by rewrite (real_int 0) Rabs_R0.
Qed.

Lemma real_neq0 x : x != 0 -> real x <> 0%Re.
Proof. by rewrite -normr_gt0 => /real_pos; rewrite real_norm => h e; move: h; rewrite e Rabs_R0; exact: Rlt_irrefl. Qed.

Lemma real_inv x : x != 0 -> real x^-1 = (/ real x)%Re.
Proof.
move=> nz; apply: (Rmult_eq_reg_r (real x)); last exact: real_neq0.
by rewrite -real_mul mulVf // Rinv_l ?(real_int 1) //; exact: real_neq0.
Qed.

Lemma real_power (e : int) : real (2%:R ^ e) = bpow radix2 (Z_of_int e).
Proof.
have two : real 2%:R = 2%Re by rewrite (real_int 2).
have nat_power k : real (2%:R ^+ k) = bpow radix2 (Z.of_nat k).
  elim: k => [|k ih]; first by rewrite expr0 (real_int 1).
  by rewrite exprS real_mul ih two Nat2Z.inj_succ bpow_plus_1.
case: e => k; first by rewrite -exprnP nat_power.
rewrite NegzE -exprnN real_inv ?expf_neq0 // nat_power -bpow_opp.
by congr (bpow _ _); lia.
Qed.

Section Rational.
Variables (prec emax : Z).
Definition rational (x : number prec emax) : rat :=
  if x is B754_finite s m e _ then (int_of_Z (cond_Zopp s (Zpos m)))%:~R * 2%:R ^ (int_of_Z e) else 0.

Lemma real_rational x : real (rational x) = B2R x.
Proof.
case: x => [s|s| |s m e h] /=; try exact: (real_int 0).
by rewrite real_mul real_int real_power !int_of_ZK.
Qed.
End Rational.
End Values.
Arguments rational {prec emax} x.

Definition unit_roundoff (prec : Z) : rat := 2%:R ^ (- int_of_Z prec).
Definition least_normal (emax : Z) : rat := 2%:R ^ int_of_Z (2 - emax)%Z.

Lemma real_unit prec : real (unit_roundoff prec) = bpow radix2 (- prec).
Proof. by rewrite /unit_roundoff real_power rmorphN /= int_of_ZK. Qed.
Lemma real_least emax : real (least_normal emax) = bpow radix2 (2 - emax).
Proof. by rewrite /least_normal real_power int_of_ZK. Qed.

Lemma unit_ge0 prec : 0 <= unit_roundoff prec.
Proof. by rewrite /unit_roundoff exprz_ge0 // ler0n. Qed.
Lemma least_gt0 emax : 0 < least_normal emax.
Proof. by rewrite /least_normal exprz_gt0. Qed.
Opaque unit_roundoff least_normal.

Section Model.
Variables (prec emax : Z).
Context {prec_pos : Prec_gt_0 prec} {prec_emax : Prec_lt_emax prec emax}.
Implicit Types x y : number prec emax.
Local Notation eps := (unit_roundoff prec).
Local Notation least_normal := (least_normal emax).
Local Notation u := (bpow radix2 (- prec)).
Local Notation rnd := (round radix2 (FLT_exp (3 - emax - prec) prec) ZnearestE).

Definition machine : arithmetic (number prec emax) := Arithmetic bplus bminus btimes bover.
Definition times_survives x y := [\/ rational x = 0, rational y = 0 | least_normal <= `|rational (btimes x y)|].
Definition over_survives x y := rational x = 0 \/ least_normal <= `|rational (bover x y)|.

Lemma close_of_real (x y : rat) rx ry : real x = rx -> real y = ry -> (Rabs (ry - rx) <= u * Rabs rx)%Re -> close eps x y.
Proof. by move=> <- <-; rewrite -real_unit -real_sub -!real_norm -real_mul => /real_le. Qed.

Lemma rounded_of_real (x y : rat) rx ry : real x = rx -> real y = ry -> (Rabs (ry - rx) <= u * Rabs ry)%Re -> rounded eps x y.
Proof. by move=> ex ey h; right; apply: (close_of_real ey ex); rewrite Rabs_minus_sym. Qed.

Lemma real_sum x y : real (rational x + rational y) = (B2R x + B2R y)%Re.
Proof. by rewrite real_add !real_rational. Qed.
Lemma real_difference x y : real (rational x - rational y) = (B2R x - B2R y)%Re.
Proof. by rewrite real_sub !real_rational. Qed.
Lemma real_product x y : real (rational x * rational y) = (B2R x * B2R y)%Re.
Proof. by rewrite real_mul !real_rational. Qed.
Lemma real_quotient x y : rational y != 0 -> real (rational x / rational y) = (B2R x / B2R y)%Re.
Proof. by move=> nz; rewrite real_mul real_inv // !real_rational. Qed.

(** rounding.binary sum: a sum and a difference of numbers with $p$ bits that do not overflow have a relative error of at most $2^{-p}$, however small they are. *)
Theorem rounding_binary_sum x y :
  (is_finite (bplus x y) = true -> close eps (rational x + rational y) (rational (bplus x y))) /\
  (is_finite (bminus x y) = true -> close eps (rational x - rational y) (rational (bminus x y))).
Proof.
split=> h; first exact: (close_of_real (real_sum x y) (real_rational _) (plus_close h)).
exact: (close_of_real (real_difference x y) (real_rational _) (minus_close h)).
Qed.

Lemma zero_value x : rational x = 0 -> B2R x = 0%Re.
Proof. by move=> h; rewrite -real_rational h (real_int 0). Qed.

Lemma normal_value x : least_normal <= `|rational x| -> (bpow radix2 (2 - emax) <= Rabs (B2R x))%Re.
Proof. by move=> /real_increasing h; rewrite -real_least -real_rational -real_norm. Qed.

Let zero_rounded : (Rabs (rnd 0 - 0) <= u * Rabs (rnd 0))%Re.
Proof. by rewrite round_0 Rminus_0_r Rabs_R0 Rmult_0_r; exact: Rle_refl. Qed.

(** rounding.binary product: a product of numbers with $p$ bits that neither over- nor underflows has a relative error of at most $2^{-p}$.
    Hypotheses: the computed product is finite; a factor is zero, or the computed product is at least the smallest normal number in size. *)
Theorem rounding_binary_product x y : is_finite (btimes x y) = true -> times_survives x y ->
  rounded eps (rational x * rational y) (rational (btimes x y)).
Proof.
move=> h normal; apply: (rounded_of_real (real_product x y) (real_rational _)); rewrite (times_round h).
case: normal => [/zero_value->|/zero_value->|/normal_value].
- by rewrite Rmult_0_l.
- by rewrite Rmult_0_r.
by rewrite (times_round h); exact: rounded_normal.
Qed.

(** rounding.binary quotient: a quotient of numbers with $p$ bits that neither over- nor underflows has a relative error of at most $2^{-p}$.
    Hypotheses: the computed quotient and the divisor are finite; the dividend is zero, or the computed quotient is at least the smallest normal number in size. *)
Theorem rounding_binary_quotient x y : is_finite (bover x y) = true -> is_finite y = true -> over_survives x y ->
  rational y != 0 /\ rounded eps (rational x / rational y) (rational (bover x y)).
Proof.
move=> h hy normal; have ny := divisor_neq0 h hy.
have y0 : rational y != 0 by apply/eqP=> y0; apply: ny; exact: zero_value.
split; first exact: y0.
apply: (rounded_of_real (real_quotient x y0) (real_rational _)); rewrite (over_round h hy).
case: normal => [/zero_value->|/normal_value]; first by rewrite /Rdiv Rmult_0_l.
by rewrite (over_round h hy); exact: rounded_normal.
Qed.
End Model.
Arguments machine prec emax {prec_pos prec_emax}.
