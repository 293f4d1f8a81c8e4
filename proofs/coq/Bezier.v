(* Bezier curves of points: rows of polynomials.
   Definitions:
     pbez n c       the Bezier curve of degree n with the points c_0, ..., c_n
     independent n  no binomial coefficient C(n, i) vanishes in the field: the Bernstein polynomials of degree n are independent
     good n         n! does not vanish in the field: its characteristic is 0 or greater than n *)
From Torse Require Import Prelude Blossom Curves Points Bernstein.

Section Bezier.
Variables (F : fieldType) (m : nat).
Implicit Types (c d : nat -> 'rV[F]_m) (n i : nat) (s : F).

Definition pbez n c : 'rV[{poly F}]_m := \row_k bez n (coord c k).
Definition independent n := forall i, (i <= n)%N -> 'C(n, i)%:R != 0 :> F.
Definition good n := n`!%:R != 0 :> F.

Lemma good_nat n i : good n -> (0 < i <= n)%N -> i%:R != 0 :> F.
Proof.
move=> g /andP[i0 le_i]; apply: contraNneq g => e; have /dvdnP[k ->] : (i %| n`!)%N by apply: dvdn_fact; rewrite i0.
by rewrite natrM e mulr0.
Qed.

Lemma good_independent n : good n -> independent n.
Proof. by move=> g i le_i; apply: contraNneq g => e; rewrite -(bin_fact le_i) natrM e mul0r. Qed.

Lemma good_le n k : (k <= n)%N -> good n -> good k.
Proof.
move=> le_k g; apply: contraNneq g => e; rewrite -(subnK le_k).
by elim: (n - k)%N => [|j ih]; [rewrite add0n e | rewrite addSn factS natrM (eqP ih) mulr0].
Qed.

Lemma pbezP n c k : pbez n c 0 k = bez n (coord c k).
Proof. by rewrite mxE. Qed.

Lemma pbez_ext n c d : (forall i, (i <= n)%N -> c i = d i) -> pbez n c = pbez n d.
Proof. by move=> e; apply/rowP=> k; rewrite !mxE; apply: bez_ext => i /e; rewrite /coord => ->. Qed.

Lemma pbez_inj n c d : independent n -> pbez n c = pbez n d <-> forall i, (i <= n)%N -> c i = d i.
Proof.
move=> g; split=> [e i le_i|]; last exact: pbez_ext.
apply/rowP=> k; have := congr1 (fun x : 'rV__ => x 0 k) e; rewrite !pbezP => /(bez_inj g); exact.
Qed.

Lemma pbez_add n c d : pbez n c + pbez n d = pbez n (fun i => c i + d i).
Proof. by apply/rowP=> k; rewrite !mxE -bez_add; apply: bez_ext => i _; rewrite /coord mxE. Qed.

Lemma pbez_scale n s c : s%:P *: pbez n c = pbez n (fun i => s *: c i).
Proof. by apply/rowP=> k; rewrite !mxE -bez_scale; apply: bez_ext => i _; rewrite /coord mxE. Qed.

Lemma X_deriv_pbez n c : 'X *: pderiv (pbez n c) = pbez n (fun i => i%:R *: (c i - prev c i)).
Proof. by apply/rowP=> k; rewrite !mxE X_deriv_bez; apply: bez_ext => i _; rewrite /coord /prev !mxE. Qed.

Lemma Y_deriv_pbez n c : (1 - 'X) *: pderiv (pbez n c) = pbez n (fun i => (n - i)%:R *: (c i.+1 - c i)).
Proof. by apply/rowP=> k; rewrite !mxE Y_deriv_bez; apply: bez_ext => i _; rewrite /coord !mxE. Qed.

(* The derivative with n + 1 points: $a'(u)=\sum_iB_i^n\,((n-i)\Delta p_i+i\Delta p_{i-1})$. *)
Theorem deriv_pbez n c :
  pderiv (pbez n c) = pbez n (fun i => (n - i)%:R *: (c i.+1 - c i) + i%:R *: (c i - prev c i)).
Proof. by rewrite -pbez_add -Y_deriv_pbez -X_deriv_pbez -scalerDl subrK scale1r. Qed.
End Bezier.

Section Blossoms.
Variable F : fieldType.
Implicit Types (c : nat -> F) (n i : nat).

(* A Bezier curve is the curve of the blossom over the knots 0, ..., 0, 1, ..., 1. *)
Theorem bezier_curve n c : curve n (step01 F n) c = bez n c.
Proof.
suff gen (g : nat -> {poly F}) : blossom (polys (step01 F n)) g (nseq n (at_ 'X)) = \sum_(0 <= i < n.+1) g i * B F n i by exact: gen.
elim: n g => [|n ih] g; first by rewrite big_nat1 /B /= bin0 expr0 subnn !mulr1.
rewrite casteljau -ih /= size_nseq (@blossom_ext_knots _ _ (polys (step01 F n))) //.
apply: blossom_ext => i; rewrite size_nseq /step => le_i; have -> : polys (step01 F n.+1) (i + n.+1)%N = 1 by rewrite /polys /step01 leq_addl.
have -> : polys (step01 F n.+1) i = 0 by rewrite /polys /step01 leqNgt ltnS le_i.
by rewrite /at_ /= !mul1r !subr0 divr1.
Qed.

End Blossoms.
