(* FJ07, section 2: developable surfaces; cylinders.
   Definitions:
     normal a b w v      the normal b_u x b_v at v of the ruling w between curves with velocities a and b *)
From Torse Require Import Prelude Blossom Curves Points.

Section Vectors.
Variable R : comUnitRingType.
Implicit Types a b w e f : 'rV[R]_3.

Definition normal a b w v := cross ((1 - v) *: a + v *: b) w.

Lemma along_ruling a b w v : triple (b - a) ((1 - v) *: a + v *: b) w = triple b a w.
Proof. by coordinates; hide_entries; ring. Qed.

Lemma cross_cross a b w : cross (cross a w) (cross b w) = triple a b w *: w.
Proof. by apply: row3P; coordinates; hide_entries; ring. Qed.

(** FJ07.1 curvature: with $a=c'$, $b=d'$, $w=d-c$, $e=c''$, $f=d''$ and $n=b_u\times b_v$:
    $(b_{uu}\cdot n)(b_{vv}\cdot n)-(b_{uv}\cdot n)^2=-[d',c',d-c]^2$, as $b_{vv}=0$; so (1) holds iff (3) does.
    Paper: for the unit normal, which singular points lack; any multiple of it will do. *)
Theorem FJ07_1_curvature a b w e f v :
  dot ((1 - v) *: e + v *: f) (normal a b w v) * dot 0 (normal a b w v) - dot (b - a) (normal a b w v) ^+ 2
    = - triple b a w ^+ 2.
Proof.
have -> x : dot 0 x = 0 :> R by coordinates; rewrite !mul0r !addr0.
by rewrite mulr0 sub0r -[dot _ _]/(triple (b - a) ((1 - v) *: a + v *: b) w) along_ruling.
Qed.

(** FJ07.2 ruling: $[b_{uv},b_u,b_v](u,v)=[d',c',d-c]$ whatever $v$ is. *)
Theorem FJ07_2_ruling a b w v : triple (b - a) ((1 - v) *: a + v *: b) w = triple b a w.
Proof. exact: along_ruling. Qed.

(** FJ07.3 normals: along a ruling $n(v)\times n(v')=(v-v')\,[d',c',d-c]\,(d-c)$: the tangent plane is constant iff (3).
    Paper: where $d=c$ the ruling has no direction, and this says nothing. *)
Theorem FJ07_3_normals a b w v v' : cross (normal a b w v) (normal a b w v') = ((v - v') * triple b a w) *: w.
Proof. by rewrite cross_cross; congr (_ *: w); coordinates; hide_entries; ring. Qed.
End Vectors.

Section Surfaces.
Variable F : fieldType.
Implicit Types (u h : nat -> F) (c d : nat -> 'rV[F]_3) (n : nat).

(** FJ07.3 blossoms: $[d',c',d-c]=n^2[d_1-d_0,\;c_1-c_0,\;d-c]$ with the last differences of de Boor's algorithm (divided
    by the length of the piece): the condition speaks of four points.
    Hypotheses: the knots carry a piece, so that its points have a meaning. *)
Theorem FJ07_3_blossoms n u c d : span n u ->
  triple (pderiv (pcurve n u d)) (pderiv (pcurve n u c)) (pcurve n u d - pcurve n u c)
    = (n ^ 2)%:R * triple (pvelocity n u d) (pvelocity n u c) (pcurve n u d - pcurve n u c).
Proof.
move=> sp; rewrite !pderiv_curve // natrX -!scaler_nat.
by coordinates; ring.
Qed.

Lemma curve_comb n u (s t : F) (c d : nat -> F) :
  curve n u (fun i => s * c i + t * d i) = s%:P * curve n u c + t%:P * curve n u d.
Proof.
rewrite -(blossom_linear (polys u)); apply: blossom_ext => i _.
by rewrite /polys polyCD !polyCM.
Qed.

Lemma curve_const n u (a : F) : span n u -> curve n u (fun=> a) = a%:P.
Proof.
rewrite /curve => /span_polys; elim: n (polys u) => [|n ih] p sp //=.
rewrite -[RHS](ih (shift p)); last exact: span_shift.
apply: blossom_ext => i; rewrite !size_nseq => le_i; rewrite /step /at_ /= !mul1r.
have ud : p (i + n.+1)%N - p i \is a GRing.unit by apply: sp; lia.
by rewrite -mulrDl addrA addrNK mulrAC mulrV // mul1r.
Qed.

(** FJ07.4 cylinder: rulings $d_i-c_i=h_iv$ give $d(t)-c(t)=\lambda(t)v$, $\lambda$ the spline of the $h_i$, and a developable surface. *)
Theorem FJ07_4_cylinder n u c h (e : 'rV[F]_3) (d := fun i => c i + h i *: e) :
  pcurve n u d - pcurve n u c = curve n u h *: map_mx polyC e /\ developable (pcurve n u c) (pcurve n u d).
Proof.
have eq_w k : pcurve n u d 0 k = pcurve n u c 0 k + curve n u h * (e 0 k)%:P.
  rewrite !mxE -[in RHS](mul1r (curve n u _)) mulrC [_ * (e 0 k)%:P]mulrC [curve n u _ * 1]mulrC.
  rewrite -(curve_comb n u 1); apply: blossom_ext => i _; rewrite /polys /coord !mxE.
  by rewrite mul1r mulrC.
split; first by apply/rowP=> k; have := eq_w k; rewrite !mxE => ->; rewrite addrAC subrr add0r.
rewrite /developable /pderiv; coordinates; have := (eq_w (Ordinal (isT : (0 < 3)%N)), eq_w (Ordinal (isT : (1 < 3)%N)), eq_w (Ordinal (isT : (2 < 3)%N))).
by rewrite !mxE => -[[-> ->] ->]; rewrite !derivD !derivM !derivC; ring.
Qed.

End Surfaces.
