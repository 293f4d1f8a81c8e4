(* Blossoms of neighbouring pieces: what they share at the knots between them. *)
From Torse Require Import Prelude Blossom Curves.

Section Joints.
Variable R : comUnitRingType.
Implicit Types (u b : nat -> R) (v w : seq (R * R)) (n r i : nat) (x : R).

Lemma knots_same u i r x : (forall l, (i <= l < i + r)%N -> u l = x) -> knots u i r = nseq r (at_ x).
Proof.
elim: r i => [|r ih] i e; first by [].
by rewrite knotsS e ?ih //; [move=> l h; apply: e; lia | lia].
Qed.

Lemma joint_last r u b x v (n := (size v + r)%N) : span n u -> span n (drop_ r u) -> (forall i, (n <= i < n + r)%N -> u i = x) ->
  blossom u b (v ++ nseq r (at_ x)) = blossom (drop_ r u) (drop_ r b) (v ++ nseq r (at_ x)).
Proof.
rewrite /n {n}; elim: v u b => [|y v ih] u b /=.
  rewrite !add0n => sp sp' e; rewrite -(@knots_same u r r) // blossoms_knots // (knots_same e).
  rewrite -(@knots_same (drop_ r u) 0 r); last by move=> l h; apply: e; lia.
  by rewrite blossoms_knots // /drop_ addn0.
rewrite addSn => sp sp' e; rewrite (ih _ _ (span_shift sp)); last by move=> i h; apply: e; lia.
  rewrite (@blossom_ext_knots _ (drop_ r (shift u)) (shift (drop_ r u))); last by move=> i _; rewrite /drop_ /shift addnS.
  by apply: blossom_ext => i _; rewrite /step /drop_ !addnS !addnA.
by move=> i l h1 h2; have := span_shift sp' h1 h2; rewrite /shift /drop_ !addnS.
Qed.

(** blossoms joint: at a knot $x=u_n=\dots=u_{n+r-1}$ of multiplicity $r$ the piece before it and that after it have the same blossom where $r$ of
    the arguments are $x$: $c_k[x^{\langle r\rangle},v_1,\dots,v_{n-r}]=c_{k+r}[x^{\langle r\rangle},v_1,\dots,v_{n-r}]$, class $C^{n-r}$.
    Hypotheses: the knots carry both pieces, so that their points have a meaning. *)
Theorem blossoms_joint n r u b x v : (r + size v)%N = n -> span n u -> span n (drop_ r u) -> (forall i, (n <= i < n + r)%N -> u i = x) ->
  blossom u b (nseq r (at_ x) ++ v) = blossom (drop_ r u) (drop_ r b) (nseq r (at_ x) ++ v).
Proof.
rewrite addnC => <- sp sp' e; have sz : size (nseq r (at_ x) ++ v) = (size v + r)%N by rewrite size_cat size_nseq addnC.
have pe : perm_eq (nseq r (at_ x) ++ v) (v ++ nseq r (at_ x)) by rewrite perm_catC.
by rewrite (blossoms_symmetric b (v := _ ++ v) _ pe) ?sz // (blossoms_symmetric (drop_ r b) (v := _ ++ v) _ pe) ?sz // joint_last.
Qed.
End Joints.

Section Needs.
Variable F : fieldType.

(** blossoms joint_needs_arguments: $r$ arguments $x$ are needed: over the simple knots $0,1,2$ of degree 1 the points $0,0,1$ have $c_0[2]=0$ and $c_1[2]=1$. *)
Theorem blossoms_joint_needs_arguments (u := fun i : nat => i%:R : F) (b := fun i : nat => (i == 2)%N%:R : F) :
  [/\ span 1 u, span 1 (drop_ 1 u), blossom u b [:: at_ 2%:R] = 0 & blossom (drop_ 1 u) (drop_ 1 b) [:: at_ 2%:R] = 1].
Proof.
have sp k : span 1 (drop_ k u).
  move=> [|//] j _ /andP[h1 h2]; have -> : j = 1%N by lia.
  by rewrite /drop_ /u addn0 addn1 mulrSr addrC addKr unitr1.
have e1 : 2%:R - 1 = 1 :> F by rewrite mulr2n addrK.
split=> //; [exact: (sp 0%N) | by rewrite /= /step /b /= !mulr0 addr0 mul0r |].
by rewrite /= /step /drop_ /u /b /= !mulr0 add0r !mul1r mulr1 -[(1 + (0 + 1))%N]/2%N -[(1 + 0)%:R]/(1 : F) e1 divr1.
Qed.
End Needs.
