(* What every file begins with: the part of mathcomp that most of them use (all of it takes half as long again to import), its tactics, and settings.
   Files over ordered fields import order and ssrnum as well. *)
From mathcomp Require Export ssreflect ssrfun ssrbool eqtype ssrnat seq choice path div prime fintype tuple finfun bigop binomial perm.
From mathcomp Require Export ssralg poly polydiv ssrint rat zmodp matrix mxalgebra mxpoly fraction ring zify.
Export GRing.Theory.
#[export] Set Implicit Arguments.
#[export] Unset Strict Implicit.
#[export] Unset Printing Implicit Defensive.
Global Open Scope ring_scope.
