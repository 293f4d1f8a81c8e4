(* FJ07, section 2: tangent surfaces, equation (7) and the net after it.
   Definitions:
     tangent_row n c i    c_i + (n-i) c_{i+1} + (2i-n) c_i - i c_{i-1}
     interval a b n       the knots a, ..., a, b, ..., b of a Bezier piece on [a, b] *)
From Torse Require Import Prelude Blossom Curves Points Bernstein Bezier Segments FJ07_2.

Section Tangent.
Variables (F : fieldType).
Implicit Types (C : 'rV[{poly F}]_3) (lam v : {poly F}).

(** FJ07.7 developable: $c+v\lambda c'$ is developable for every function $\lambda$, here a polynomial. *)
Theorem FJ07_7_developable C lam : developable C (C + lam *: pderiv C).
Proof.
rewrite /developable /pderiv; coordinates; rewrite !derivD !derivM.
by hide_entries; move: lam^`() => l; ring.
Qed.

(** FJ07.7 edge: $b=c+v\lambda c'$ has $b_t\times b_v=v\lambda^2\,c''\times c'$: it is singular along $c$, the edge of regression. *)
Theorem FJ07_7_edge C lam v :
  normal (pderiv C) (pderiv (C + lam *: pderiv C)) (lam *: pderiv C) v = (v * lam ^+ 2) *: cross (pderiv (pderiv C)) (pderiv C).
Proof.
have -> : pderiv (C + lam *: pderiv C) = pderiv C + (lam^`() *: pderiv C + lam *: pderiv (pderiv C)) by apply/rowP=> k; rewrite !mxE derivD derivM.
by rewrite /normal; move: (pderiv (pderiv C)) (pderiv C) lam^`() => a b l; apply: row3P; coordinates; hide_entries; ring.
Qed.

End Tangent.

Section Net.
Variables (F : fieldType) (m : nat).
Implicit Types (c d : nat -> 'rV[F]_m) (n i : nat).

Definition tangent_row n c i := c i + ((n - i)%:R *: c i.+1 + (i.*2%:R - n%:R) *: c i - i%:R *: prev c i).

Lemma tangent_step n c i : (i <= n)%N ->
  tangent_row n c i = c i + ((n - i)%:R *: (c i.+1 - c i) + i%:R *: (c i - prev c i)).
Proof.
move=> le_i; rewrite /tangent_row natrB // -muln2 natrM; congr (_ + _).
by move: (n%:R) (i%:R) (prev c i) => N I p; by_entries k; ring.
Qed.

(** FJ07.7 net: on $[0,1]$ the row $c_i+\{(n-i)c_{i+1}+(2i-n)c_i-ic_{i-1}\}$ is that of $c(t)+c'(t)$. *)
Theorem FJ07_7_net n c : pbez n (tangent_row n c) = pbez n c + pderiv (pbez n c).
Proof.
by rewrite deriv_pbez pbez_add; apply: pbez_ext => i le_i; rewrite tangent_step.
Qed.

(** FJ07.7 scaled: for a constant $\lambda$ the row $c_i+\lambda\{(n-i)c_{i+1}+(2i-n)c_i-ic_{i-1}\}$ is that of $c(t)+\lambda c'(t)$ on $[0,1]$. *)
Theorem FJ07_7_scaled n c lam :
  pbez n (fun i => c i + lam *: (tangent_row n c i - c i)) = pbez n c + lam%:P *: pderiv (pbez n c).
Proof.
rewrite deriv_pbez pbez_scale pbez_add; apply: pbez_ext => i le_i; rewrite tangent_step //.
by rewrite addrAC subrr add0r.
Qed.

Definition interval a b n i : F := if (i < n)%N then a else b.

Lemma interval_span a b n : b - a != 0 -> span n (interval a b n).
Proof. by move=> nz i j lt_i /andP[le_j _]; rewrite /interval lt_i ltnNge le_j unitfE. Qed.

Lemma interval_knots a b n i : (i <= n)%N -> knots (interval a b n) i n = ends n a b i.
Proof.
move=> le_i; rewrite -local_knots //; rewrite /knots -map_comp; apply: eq_map => j.
by rewrite /interval /local_arg /at_ /= ltnNge; case: leqP => _ /=; congr (_, _); ring.
Qed.

(* The piece on [a, b] is the Bezier curve at (t - a) / (b - a). *)
Lemma curve_interval a b n (c : nat -> F) (s := (b - a)^-1 *: ('X - a%:P) : {poly F}) : b - a != 0 ->
  curve n (interval a b n) c = bez n c \Po s.
Proof.
move=> nz; have sp := @interval_span a b n nz; rewrite -bezier_curve /curve.
have {1}-> : 'X = a%:P + s * (b%:P - a%:P).
  by rewrite /s -polyCB mulrC mul_polyC scalerA mulfV // scale1r addrC subrK.
rewrite (_ : nseq n (at_ (a%:P + _)) = [seq local_arg a%:P b%:P x | x <- nseq n (at_ s)]); last first.
  by rewrite map_nseq /local_arg /= mul1r.
rewrite (blossom_local _ _ _ (span_polys sp)) ?size_nseq //.
rewrite -[RHS]/([rmorphism of comp_poly s] _) (blossom_morph [rmorphism of comp_poly s]); last first.
  by rewrite size_nseq; apply/span_polys/span_step01.
rewrite map_nseq /= comp_polyX rmorph1 (@blossom_ext_knots _ _ (comp_poly s \o polys (step01 F n))); last first.
  by move=> i _ /=; rewrite /polys /step01 comp_polyC polyC_nat.
apply: blossom_ext => i; rewrite size_nseq => le_i /=; rewrite /polys comp_polyC /segment.
rewrite -[in RHS](blossoms_knots c sp le_i) -[RHS]/([rmorphism of polyC] _) (blossom_morph [rmorphism of polyC]); last first.
  by rewrite size_knots.
by rewrite interval_knots // /ends map_cat !map_nseq.
Qed.

(** FJ07.7 interval: on $[a,b]$ the net of the paper is that of $c(t)+(b-a)c'(t)$.
    Hypotheses: $a\ne b$, so that the points of the curve have a meaning.
    Paper: speaks of $\lambda=1$, which is $[0,1]$. *)
Theorem FJ07_7_interval n c a b : b - a != 0 ->
  pcurve n (interval a b n) (tangent_row n c) = pcurve n (interval a b n) c + (b - a)%:P *: pderiv (pcurve n (interval a b n) c).
Proof.
move=> nz; apply/rowP=> k; have := congr1 (fun r : 'rV_m => r 0 k) (FJ07_7_net n c); rewrite !mxE !curve_interval // => ->.
rewrite comp_polyD deriv_comp derivZ derivB derivX derivC subr0 mulrCA alg_polyC -polyCM mulfV // mulr1 //.
Qed.

(** FJ07.7 unique: there is no other net of $c(t)+c'(t)$.
    Hypotheses: no $C(n,i)$ vanishes in the field, as in characteristic 0. *)
Theorem FJ07_7_unique n c d : independent F n ->
  pbez n d = pbez n c + pderiv (pbez n c) <-> forall i, (i <= n)%N -> d i = tangent_row n c i.
Proof.
move=> nz; rewrite -FJ07_7_net; split=> [eq_d i le_i|]; last exact: pbez_ext.
apply/rowP=> k; have := congr1 (fun x : 'rV__ => x 0 k) eq_d; rewrite !pbezP => /(bez_inj nz); exact.
Qed.
End Net.
