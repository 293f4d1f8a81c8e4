(* What the files begin with that speak of binary numbers in the words of mathcomp: Coq's real numbers, Flocq, and the prelude. *)
From Coq Require Export ZArith Reals Psatz.
From Flocq Require Export Core BinarySingleNaN.
From Torse Require Export Prelude.
From mathcomp Require Export order ssrnum ssrZ.
Export Order.TTheory Num.Theory.
Delimit Scope R_scope with Re.
Global Open Scope ring_scope.
