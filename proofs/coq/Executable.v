(* Programs that run: written over the operations of a field, so that the same text is a definition over any `fieldType`, about which theorems
   speak, and OCaml over exact rationals, which ./x coq runs beside the C++ library.
   Definitions:
     scalars T        the operations of a field on T, the test of equality and the order
     points T P       the operations of a module P over T
     itself K         the scalars as points
     of_field F lt, rows F m   the same of a field with the order lt, and of row vectors with m entries
     reason           why there is no value: the errors that the library throws
     answer A         a value or a reason
     given b e a      the answer a, where b holds; e otherwise
     quotient x y     x / y, unless y is zero
     product, total, total_of   a product, a sum, a sum of points over i = a, ..., b - 1
     of_nat k         1 + ... + 1
     sequence next i x k   x_i = x, x_{i+1} = next i x_i, ...: k members *)
From Torse Require Import Prelude.

Record scalars T := Scalars {
  zero : T; one : T; sadd : T -> T -> T; ssub : T -> T -> T; smul : T -> T -> T; sinv : T -> T; same : T -> T -> bool; less : T -> T -> bool}.
Record points T P := Points {origin : P; padd : P -> P -> P; psub : P -> P -> P; pscale : T -> P -> P}.
Definition itself T (K : scalars T) := Points (zero K) (sadd K) (ssub K) (smul K).

Inductive reason := Division | Degree | Knots | Knot of nat | Vertices | At_knot | Vertex | Cell of nat | Sigma | Outside | Lambda | Weight of nat
  | Rho | Factor | Alpha | Parallel | Lengths | Equation | Directrix.
Inductive answer A := Value of A | Fails of reason.

Definition given A (b : bool) e (a : answer A) := if b then a else Fails A e.

Section Programs.
Variables (T P : Type) (K : scalars T) (V : points T P).

Definition quotient x y := given (~~ same K y (zero K)) Division (Value (smul K x (sinv K y))).
Definition product (f : nat -> T) a b := foldr (fun i x => smul K (f i) x) (one K) (iota a (b - a)).
Definition total (f : nat -> T) a b := foldr (fun i x => sadd K (f i) x) (zero K) (iota a (b - a)).
Definition total_of (f : nat -> P) a b := foldr (fun i x => padd V (f i) x) (origin V) (iota a (b - a)).
Definition of_nat k := iter k (sadd K (one K)) (zero K).

Fixpoint sequence (A : Type) (next : nat -> A -> A) i x k := if k is k'.+1 then x :: sequence next i.+1 (next i x) k' else [::].
End Programs.

Definition of_field (F : fieldType) (lt : F -> F -> bool) : scalars F :=
  @Scalars F 0 1 +%R (fun x y => x - y) *%R (fun x => x^-1) (fun x y => x == y) lt.
Definition rows (F : fieldType) m : points F 'rV[F]_m := @Points F 'rV[F]_m 0 +%R (fun x y => x - y) *:%R.

Section Equal.
Variables (F : fieldType) (m : nat) (lt : F -> F -> bool).
Local Notation K := (of_field lt).

Lemma Value_inj A (x y : A) : Value x = Value y -> x = y.
Proof. by case. Qed.

Lemma productE (f : nat -> F) a b : product K f a b = \prod_(a <= i < b) f i.
Proof. by rewrite unlock. Qed.

Lemma totalE (f : nat -> F) a b : total K f a b = \sum_(a <= i < b) f i.
Proof. by rewrite unlock. Qed.

Lemma total_ofE (f : nat -> 'rV[F]_m) a b : total_of (rows F m) f a b = \sum_(a <= i < b) f i.
Proof. by rewrite unlock. Qed.

Lemma of_natE k : of_nat K k = k%:R.
Proof. by elim: k => //= k ->; rewrite mulrS. Qed.

Lemma sequenceE A (next : nat -> A -> A) (f : nat -> A) i k : (forall j, (i <= j)%N -> f j.+1 = next j (f j)) ->
  sequence next i (f i) k = [seq f j | j <- iota i k].
Proof.
elim: k i => //= k ih i rec; congr (_ :: _); rewrite -rec // ih // => j lt_j; apply: rec; exact: ltnW.
Qed.

Lemma size_sequence A (next : nat -> A -> A) i x k : size (sequence next i x k) = k.
Proof. by elim: k i x => //= k ih i x; rewrite ih. Qed.

Lemma nth_sequence A (z : A) (next : nat -> A -> A) i x k j : (j.+1 < k)%N ->
  nth z (sequence next i x k) j.+1 = next (i + j)%N (nth z (sequence next i x k) j).
Proof.
elim: k i x j => // k ih i x [|j]; first by case: k {ih} => // k _; rewrite addn0.
by move=> lt_j; rewrite /= ih // addSnnS.
Qed.

Lemma given_Value A (b : bool) e (a : answer A) x : given b e a = Value x -> b /\ a = Value x.
Proof. by case: b. Qed.

Lemma quotient_Value (x y z : F) : quotient K x y = Value z -> y != 0 /\ z = x / y.
Proof. by rewrite /quotient /= /given; case: ifP => // nz [<-]. Qed.
End Equal.
