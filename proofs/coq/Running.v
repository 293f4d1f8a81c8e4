(* Running error analysis, exact/instrumented/running_error.hpp line by line, in any binary format.
   Definitions:
     running              a number beside a bound of its distance from the exact result, the class RunningError
     zero, unknown        0 and plus infinity
     up, down             1 + 2^(4 - prec) and 1 - 2^(1 - prec), in doubles 1 + 2^-49 and 1 - 2^-52
     underflow, tiny      in doubles 2^-1070 and 2^-960;  most, ulps   2^prec and 2^(1 - prec), in doubles 2^53 and 2^-52
     inexact, exactly_zero   a bound that is not 0, a result that is 0 with the bound 0
     lost, rounded_up     what an underflow may take from a residual, and a computed bound made a bound
     of_number, of_int    a number and an integer as exact operands
     plus_running ...     the operations
     truth, is_zero, is_less   the decisions
     exact                the result of an exact program, if it divides by no zero and takes no root of a negative number;
                          both, opposite_exact, over_exact, root_exact are the operations
     tracks r X           the bound of r is infinite, or it is finite, the exact result X exists, and it is within the bound *)
From Coq Require Import ZArith Reals Psatz.
From Flocq Require Import Core Operations BinarySingleNaN.
From Torse Require Import Binary.

Section Model.
Variables (prec emax : Z).
Context {prec_pos : Prec_gt_0 prec} {prec_emax : Prec_lt_emax prec emax}.
Local Notation number := (number prec emax).
Local Notation emin := (3 - emax - prec)%Z.
Implicit Types a b : number.

Record running := Running {value : number; bound : number}.
Implicit Types x y : running.

Definition zero : number := B754_zero false.
Definition unknown : number := B754_infinity false.
Definition binary (m e : Z) : number := binary_normalize prec emax _ _ mode_NE m e false.
Definition up : number := binary (2 ^ (prec - 4) + 1) (4 - prec).
Definition down : number := binary (2 ^ (prec - 1) - 1) (1 - prec).
Definition underflow : number := binary 1 (emin + 4).
Definition tiny : number := binary 1 (emin + 2 * prec + 8).
Definition most : number := binary 1 prec.
Definition ulps : number := binary 1 (1 - prec).

Definition inexact b := negb (Beqb b zero).
Definition exactly_zero x := (Beqb (value x) zero && Beqb (bound x) zero)%bool.
Definition lost b := if Bltb (Babs b) tiny then underflow else zero.
Definition rounded_up b := if Bleb zero b then btimes b up else unknown.

Definition of_number a := Running a (if is_finite a then zero else unknown).
Definition of_int (i : Z) :=
  let v := binary i 0 in Running v (if Bleb most (Babs v) then btimes (Babs v) ulps else zero).

Definition plus_running x y :=
  let sum := bplus (value x) (value y) in
  let y_part := bminus sum (value x) in
  let local := bplus (bminus (value x) (bminus sum y_part)) (bminus (value y) y_part) in
  Running sum (rounded_up (bplus (bplus (Babs local) (bound x)) (bound y))).
Definition opposite_running x := Running (Bopp (value x)) (bound x).
Definition minus_running x y := plus_running x (opposite_running y).

Definition times_running x y :=
  let product := btimes (value x) (value y) in
  if (exactly_zero x || exactly_zero y)%bool then Running product (if Bltb (bplus (bound x) (bound y)) unknown then zero else unknown)
  else
    let b := bplus (Babs (Bfma mode_NE (value x) (value y) (Bopp product))) (lost product) in
    let b := if (inexact (bound x) || inexact (bound y))%bool
             then bplus b (bplus (bplus (bplus (btimes (Babs (value x)) (bound y)) (btimes (Babs (value y)) (bound x)))
                                        (btimes (bound x) (bound y))) underflow)
             else b in
    Running product (rounded_up b).

Definition over_running x y :=
  let quotient := bover (value x) (value y) in
  let divisor := btimes (bminus (Babs (value y)) (bound y)) down in
  if negb (Bltb zero divisor) then Running quotient unknown
  else if exactly_zero x then Running quotient zero
  else
    let rest := bplus (bplus (Babs (Bfma mode_NE (Bopp quotient) (value y) (value x))) (lost (value x))) (lost quotient) in
    let rest := if (inexact (bound x) || inexact (bound y))%bool
                then bplus rest (bplus (bplus (btimes (Babs quotient) (bound y)) (bound x)) underflow)
                else rest in
    Running quotient (if Beqb rest zero then zero else rounded_up (bplus (bover rest divisor) underflow)).

Definition root_running x :=
  let v := Bsqrt mode_NE (value x) in
  if exactly_zero x then Running v zero
  else if negb (Bltb (bound x) (value x)) then Running v unknown
  else
    let rest := bplus (bplus (Babs (Bfma mode_NE v v (Bopp (value x)))) (lost (value x))) (bound x) in
    Running v (if Beqb rest zero then zero else rounded_up (bplus (bover rest v) underflow)).

Inductive truth := yes | no | not_known.
Definition is_zero x :=
  if Bltb (bound x) (Babs (value x)) then no else if Beqb (bound x) zero then yes else not_known.
Definition is_less x y :=
  let rest := minus_running y x in
  match is_zero rest with
  | no => if Bltb zero (value rest) then yes else no
  | yes => no
  | not_known => not_known
  end.

Definition exact := option R.
Implicit Types X Y : exact.
Definition both (f : R -> R -> R) X Y : exact :=
  match X, Y with Some x, Some y => Some (f x y) | _, _ => None end.
Definition opposite_exact X : exact := option_map Ropp X.
Definition over_exact X Y : exact :=
  match X, Y with Some x, Some y => if Req_EM_T y 0 then None else Some (x / y)%R | _, _ => None end.
Definition root_exact X : exact :=
  match X with Some x => if Rlt_dec x 0 then None else Some (sqrt x) | None => None end.

Definition tracks x X : Prop :=
  if is_finite (bound x)
  then is_finite (value x) = true /\ exists r, X = Some r /\ (Rabs (B2R (value x) - r) <= B2R (bound x))%R
  else bound x = unknown.
End Model.
Arguments zero {prec emax}.
Arguments unknown {prec emax}.
Arguments Running {prec emax} value bound.
Arguments value {prec emax} r.
Arguments bound {prec emax} r.
Arguments tracks {prec emax} x X.
