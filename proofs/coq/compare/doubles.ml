(* Doubles as their 64 bits, and the answers of running error analysis, extracted from Running.v, for them. *)
module Zarith = Z
open Running

let rec positive n =
  if Zarith.equal n Zarith.one then XH
  else let half = positive (Zarith.shift_right n 1) in if Zarith.testbit n 0 then XI half else XO half
let integer n = match Zarith.sign n with 0 -> Z0 | 1 -> Zpos (positive n) | _ -> Zneg (positive (Zarith.neg n))
let rec of_positive = function
  | XH -> Zarith.one
  | XO half -> Zarith.shift_left (of_positive half) 1
  | XI half -> Zarith.succ (Zarith.shift_left (of_positive half) 1)
let of_integer = function Z0 -> Zarith.zero | Zpos n -> of_positive n | Zneg n -> Zarith.neg (of_positive n)

let least = -1074
let hidden = Zarith.shift_left Zarith.one 52

let number bits =
  let sign = Zarith.testbit bits 63 and field = Zarith.to_int (Zarith.extract bits 52 11) and fraction = Zarith.extract bits 0 52 in
  let none = Zarith.sign fraction = 0 in
  if field = 2047 then (if none then B754_infinity sign else B754_nan)
  else if field = 0 && none then B754_zero sign
  else if field = 0 then B754_finite (sign, positive fraction, integer (Zarith.of_int least))
  else B754_finite (sign, positive (Zarith.add hidden fraction), integer (Zarith.of_int (least - 1 + field)))

let text x =
  let bits sign field fraction =
    let whole = Zarith.add (Zarith.shift_left (Zarith.of_int field) 52) fraction in
    Zarith.to_string (if sign then Zarith.add (Zarith.shift_left Zarith.one 63) whole else whole) in
  match x with
  | B754_nan -> "nan"
  | B754_infinity sign -> bits sign 2047 Zarith.zero
  | B754_zero sign -> bits sign 0 Zarith.zero
  | B754_finite (sign, m, e) ->
    let m = of_positive m and e = Zarith.to_int (of_integer e) in
    if Zarith.lt m hidden then bits sign 0 m else bits sign (e - least + 1) (Zarith.sub m hidden)

(* binary64 of IEEE 754. *)
let prec = integer (Zarith.of_int 53) and emax = integer (Zarith.of_int 1024)

let running = function [value; bound] -> { value = number value; bound = number bound } | _ -> failwith "a value and its bound"
let answer x = (if is_finite prec emax x.bound then "" else "error ") ^ text x.value ^ " " ^ text x.bound
let decided = function Yes -> "yes" | No -> "no" | Not_known -> "error unknown"

let one operation x = answer (operation prec emax (running x))
let two operation x y = answer (operation prec emax (running x) (running y))
