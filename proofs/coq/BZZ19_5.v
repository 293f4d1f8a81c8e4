(* BZZ19, sections 3.3 and 5: the common normal, the function that is minimised, and the warp angle.
   Definitions:
     E2 x a b w          (x.a)^2 + (x.b)^2 + (x.w)^2, equation (8)
     objective l1 l2 K x a b w   l1 times the sum of the E2 plus l2 times that of the (|x_i|^2 - 1)^2, i < K, equation (9)
     length_ x           |x|
     warp_sin a b w, warp_cos a b w   the angle between the normals a x w and b x w at the ends of a ruling w *)
From Torse Require Import Prelude Points Dependence BZZ19_3.
From mathcomp Require Import order ssrnum.
Import Order.TTheory Num.Theory.

Section Warp.
Variable R : comUnitRingType.
Implicit Types a b w x : 'rV[R]_3.

Definition E2 x a b w : R := dot x a ^+ 2 + dot x b ^+ 2 + dot x w ^+ 2.

(** BZZ19.7 normal: $E_1x=(x\cdot w)\,a\times b+(x\cdot a)\,b\times w+(x\cdot b)\,w\times a$ for $E_1=[w,a,b]$: where a vector $x\ne0$ is normal to
    all three, $E_1=0$. *)
Theorem BZZ19_7_normal a b w x :
  triple w a b *: x = dot x w *: cross a b + dot x a *: cross b w + dot x b *: cross w a.
Proof. by apply: row3P; coordinates; hide_entries; ring. Qed.

(** BZZ19.8 product: the normal $a\times b$ has $E_2=E_1^2$. *)
Theorem BZZ19_8_product a b w (x := cross a b) : E2 x a b w = triple w a b ^+ 2.
Proof. by rewrite /x /E2; coordinates; hide_entries; ring. Qed.

(** BZZ19.W product: the normals $m=a\times w$, $n=b\times w$ at the ends of a ruling obey $m\times n=-[a,w,b]\,w$. *)
Theorem BZZ19_W_product a b w : cross (cross a w) (cross b w) = - triple a w b *: w.
Proof. by apply: row3P; coordinates; hide_entries; ring. Qed.

(** BZZ19.W sine: $|w|^2[a,w,b]^2+(m\cdot n)^2=|m|^2|n|^2$: so $\sin=|w|\,|[a,w,b]|/(|m|\,|n|)$ where $m$ and $n$ are not 0. *)
Theorem BZZ19_W_sine a b w (m := cross a w) (n := cross b w) :
  dot w w * triple a w b ^+ 2 + dot m n ^+ 2 = dot m m * dot n n.
Proof. by rewrite /m /n; coordinates; hide_entries; ring. Qed.
End Warp.

Section Real.
Variable F : realFieldType.
Implicit Types a b w x : 'rV[F]_3.

Definition objective l1 l2 K (x a b w : nat -> 'rV[F]_3) : F :=
  l1 * (\sum_(0 <= i < K) E2 (x i) (a i) (b i) (w i)) + l2 * (\sum_(0 <= i < K) (dot (x i) (x i) - 1) ^+ 2).

Lemma E2_zero x a b w : (E2 x a b w == 0) = [&& dot x a == 0, dot x b == 0 & dot x w == 0].
Proof. by rewrite /E2 paddr_eq0 ?addr_ge0 ?sqr_ge0 // paddr_eq0 ?sqr_ge0 // !sqrf_eq0 andbA. Qed.

Lemma dot_zero x : (dot x x == 0) = (x == 0).
Proof.
rewrite /dot -!expr2 paddr_eq0 ?addr_ge0 ?sqr_ge0 // paddr_eq0 ?sqr_ge0 // !sqrf_eq0.
apply/idP/eqP=> [/andP[/andP[/eqP x0 /eqP x1] /eqP x2]|->]; last by rewrite /x_ /y_ /z_ !mxE !eqxx.
by apply: row3P; rewrite ?x0 ?x1 ?x2 /x_ /y_ /z_ mxE.
Qed.

(** BZZ19.8 condition: $E_1=0$ iff $E_2=0$ for a vector $N\ne0$.
    Hypotheses: an ordered field. *)
Theorem BZZ19_8_condition a b w : triple w a b = 0 <-> exists x, x != 0 /\ E2 x a b w = 0.
Proof.
rewrite BZZ19_7_common; split=> [[x [nz ea eb ew]]|[x [nz e]]]; exists x.
  by split=> //; apply/eqP; rewrite E2_zero ea eb ew !eqxx.
by have := e => /eqP; rewrite E2_zero => /and3P[/eqP ea /eqP eb /eqP ew].
Qed.

(** BZZ19.9 minimum: the function that is minimised is not negative, and 0 iff all $N_i$ are unit vectors with $E_2=0$, so that every sampled
    ruling is developable.
    Hypotheses: an ordered field; positive weights. *)
Theorem BZZ19_9_minimum l1 l2 K (x a b w : nat -> 'rV[F]_3) : 0 < l1 -> 0 < l2 ->
  0 <= objective l1 l2 K x a b w /\
  (objective l1 l2 K x a b w = 0 <-> forall i, (i < K)%N -> dot (x i) (x i) = 1 /\ E2 (x i) (a i) (b i) (w i) = 0).
Proof.
move=> l1_gt0 l2_gt0; have e_ge0 i : 0 <= E2 (x i) (a i) (b i) (w i) by rewrite /E2; do ?apply: addr_ge0; apply: sqr_ge0.
have s_ge0 : 0 <= \sum_(0 <= i < K) E2 (x i) (a i) (b i) (w i) by rewrite sumr_ge0.
have u_ge0 : 0 <= \sum_(0 <= i < K) (dot (x i) (x i) - 1) ^+ 2 by rewrite sumr_ge0 // => i _; exact: sqr_ge0.
rewrite /objective; split; first by apply: addr_ge0; apply: mulr_ge0 => //; apply: ltW.
split=> [/eqP|h]; last first.
  rewrite big1_seq => [|i]; last by rewrite mem_index_iota => /andP[_ /andP[_ /h[_ ->]]].
  rewrite big1_seq ?mulr0 ?addr0 // => i; rewrite mem_index_iota => /andP[_ /andP[_ /h[-> _]]].
  by rewrite subrr expr0n.
rewrite paddr_eq0; try by apply: mulr_ge0 => //; apply: ltW.
rewrite !mulf_eq0 (gt_eqF l1_gt0) (gt_eqF l2_gt0) /= => /andP[].
rewrite !big_mkord !psumr_eq0 // => [/allP e0 /allP u0 i lt_i|i _]; last exact: sqr_ge0.
have in_i := mem_index_enum (Ordinal lt_i); split; last by apply/eqP; exact: e0 in_i.
by have := u0 _ in_i; rewrite /= sqrf_eq0 subr_eq0 => /eqP.
Qed.

(** BZZ19.9 needs_weight: without the first term, $\lambda_1=0$, all unit vectors $N_i$ give the minimum on every surface. *)
Theorem BZZ19_9_needs_weight l2 K (x a b w : nat -> 'rV[F]_3) : (forall i, dot (x i) (x i) = 1) -> objective 0 l2 K x a b w = 0.
Proof.
move=> unit; rewrite /objective mul0r add0r big1 ?mulr0 // => i _.
by rewrite unit subrr expr0n.
Qed.

(** BZZ19.9 needs_unit: without the second term, $\lambda_2=0$, all $N_i=0$ give the minimum on every surface. *)
Theorem BZZ19_9_needs_unit l1 K (a b w : nat -> 'rV[F]_3) : objective l1 0 K (fun=> 0) a b w = 0.
Proof.
rewrite /objective mul0r addr0 big1 ?mulr0 // => i _.
by rewrite /E2 /dot /x_ /y_ /z_ !mxE !mul0r !addr0 expr0n !addr0.
Qed.
End Real.

(** BZZ19.8 needs_order: where $-1=i^2$ in the field, $N=(1,i,0)$ has $E_2=0$ and $E_1=1$ for the three unit vectors. *)
Theorem BZZ19_8_needs_order (F : fieldType) (i : F) (x := vec 1 i 0) (a := vec 1 0 0) (b := vec 0 1 0) (w := vec 0 0 1) :
  i ^+ 2 = -1 -> E2 x a b w = 0 /\ triple w a b = 1.
Proof.
move=> i2; rewrite /E2 tripleE /dot /x /a /b /w; coordinates; split; last by ring.
by rewrite !(mulr0, mul0r, mulr1, addr0, add0r) i2 expr1n expr0n addr0 subrr.
Qed.

Section Angle.
Variable F : rcfType.
Implicit Types a b w : 'rV[F]_3.

Definition length_ (x : 'rV[F]_3) := Num.sqrt (dot x x).
Definition warp_sin a b w := length_ w * `|triple a w b| / (length_ (cross a w) * length_ (cross b w)).
Definition warp_cos a b w := dot (cross a w) (cross b w) / (length_ (cross a w) * length_ (cross b w)).

Lemma length_sqr x : length_ x ^+ 2 = dot x x.
Proof. by rewrite sqr_sqrtr // /dot -!expr2; do ?apply: addr_ge0; apply: sqr_ge0. Qed.

Lemma length_eq0 x : (length_ x == 0) = (x == 0).
Proof. by rewrite -sqrf_eq0 length_sqr dot_zero. Qed.

(** BZZ19.W angle: sine and cosine of the warp angle are those of an angle between 0 and $\pi$, and the sine is 0 iff $[a,w,b]=0$.
    Hypotheses: a real closed field; $a\times w\ne0$ and $b\times w\ne0$, so that the angle has a meaning. *)
Theorem BZZ19_W_angle a b w : cross a w != 0 -> cross b w != 0 ->
  [/\ warp_sin a b w ^+ 2 + warp_cos a b w ^+ 2 = 1, 0 <= warp_sin a b w & warp_sin a b w = 0 <-> triple a w b = 0].
Proof.
move=> m0 n0; have d0 : length_ (cross a w) * length_ (cross b w) != 0 by rewrite mulf_neq0 ?length_eq0.
have w0 : length_ w != 0.
  by rewrite length_eq0; apply: contraNneq m0 => ->; apply/eqP; apply: row3P; coordinates; ring.
split.
- rewrite /warp_sin /warp_cos !expr_div_n -mulrDl exprMn real_normK ?num_real // (length_sqr w) BZZ19_W_sine exprMn.
  by rewrite (length_sqr (cross a w)) (length_sqr (cross b w)) divff // mulf_neq0 ?dot_zero.
- by rewrite divr_ge0 ?mulr_ge0 ?sqrtr_ge0 ?normr_ge0.
rewrite /warp_sin; split=> [/eqP|->]; last by rewrite normr0 mulr0 mul0r.
by rewrite !mulf_eq0 invr_eq0 (negPf d0) orbF (negPf w0) normr_eq0 => /eqP.
Qed.

(** BZZ19.W needs_normals: where $a$ is parallel to the ruling there is no normal and no angle: numerators and denominators of sine and cosine are all 0. *)
Theorem BZZ19_W_needs_normals a b w : cross a w = 0 ->
  [/\ length_ w * `|triple a w b| = 0, dot (cross a w) (cross b w) = 0 & length_ (cross a w) * length_ (cross b w) = 0].
Proof.
move=> e; have -> : triple a w b = dot (cross a w) b by coordinates; ring.
have z x : dot 0 x = 0 :> F by coordinates; rewrite !mul0r !addr0.
by rewrite e !z normr0 mulr0 /length_ z sqrtr0 mul0r.
Qed.
End Angle.
