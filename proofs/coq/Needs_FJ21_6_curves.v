(* FJ21, Theorem 6.1: what happens without the hypotheses about surfaces and their curves, one counterexample each, over any field. *)
From Torse Require Import Prelude Blossom Curves Points FJ21_3 FJ21_6_theorem FJ21_6_curves.

Section Needs.
Variable F : fieldType.
Implicit Types (L M x : F) (n : nat).

Lemma patch_power n x : n.+1%:R != 0 :> F -> patch n (const_mx (('X - x%:P) ^+ n.+1) : 'rV[{poly F}]_1) x = 0.
Proof.
move=> n1; apply/rowP=> k; rewrite !mxE deriv_exp derivB derivX derivC subr0 mul1r /=.
by rewrite -(opprB 'X x%:P) scalerN mulNr -scaler_nat -scalerAr -scalerAl scalerA mulfV // scale1r -exprS subrr.
Qed.

(** FJ21.T6.1 full_needs_distinct: for $r=(t-x)^{n+1}$ the row for $x$ is 0, so that one value $x$ alone may miss the degree.
    Hypotheses: $n+1\ne0$ in the field. *)
Theorem FJ21_T6_1_full_needs_distinct n x (r := const_mx (('X - x%:P) ^+ n.+1) : 'rV[{poly F}]_1) : n.+1%:R != 0 :> F ->
  degree_is n.+1 r /\ ~ degree_is n (patch n r x).
Proof.
move=> n1; split; last by rewrite /r patch_power // => -[_ [k]]; rewrite mxE coef0 eqxx.
split=> [k|]; first by rewrite mxE size_exp_XsubC.
by exists 0; rewrite mxE; have := monic_neq0 (monic_exp n.+1 (monicXsubC x)); rewrite -lead_coef_eq0 lead_coefE size_exp_XsubC.
Qed.

(** FJ21.T6.1 full_needs_degree: for $r=0$ no row has the degree $n$. *)
Theorem FJ21_T6_1_full_needs_degree n x : ~ degree_is n (patch n (0 : 'rV[{poly F}]_1) x).
Proof. by case=> _ [k]; rewrite !mxE linear0 mulr0 addr0 coef0 eqxx. Qed.

(** FJ21.T6.1 subspace_needs_distinct: for $\Lambda=M$ both rows of $r=(t-M)^{n+1}$ are 0, which lies in every subspace, and $r$ is not 0.
    Hypotheses: $n+1\ne0$ in the field. *)
Theorem FJ21_T6_1_subspace_needs_distinct n M (r := const_mx (('X - M%:P) ^+ n.+1) : 'rV[{poly F}]_1) : n.+1%:R != 0 :> F ->
  inside (1%:M : 'M[F]_1) (patch n r M) /\ ~ inside (1%:M : 'M[F]_1) r.
Proof.
move=> n1; rewrite /inside map_mx1 !mulmx1 /r patch_power //; split=> // /rowP/(_ 0); rewrite !mxE => /eqP.
by rewrite expf_eq0 /= polyXsubC_eq0.
Qed.

(** FJ21.T6.1 no_cone_needs_point: for $A=0$ all rulings pass through it, and $r=(1,t,0)$ is no point. *)
Theorem FJ21_T6_1_no_cone_needs_point n L M (r : 'rV[{poly F}]_3 := vec 1 'X 0) :
  on_rulings 0 (patch n r M) (patch n r L) /\ forall f g (B : 'rV[F]_3), r <> f *: map_mx polyC 0 + g *: map_mx polyC B.
Proof.
split=> [|f g B]; first by exists 0, 0, 1; rewrite oner_neq0 map_mx0 !scale0r scaler0 addr0.
rewrite map_mx0 scaler0 add0r => e; have := congr1 (@x_ _) e; have := congr1 (@y_ _) e; rewrite /x_ /y_ !mxE /= => ey ex.
have b0 : g * (B 0 (@Ordinal 3 0 isT))%:P = 1 by rewrite -ex.
have : 'X * (B 0 (@Ordinal 3 0 isT))%:P = (B 0 (@Ordinal 3 1 isT))%:P :> {poly F} by rewrite ey mulrAC b0 mul1r.
move/(congr1 (fun p : {poly F} => p`_1)); rewrite coefMC coefX /= mul1r coefC /= => z.
by move/eqP: b0; rewrite z polyC0 mulr0 eq_sym oner_eq0.
Qed.
End Needs.
