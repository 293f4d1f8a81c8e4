(* Programs: the Bezier rows of all pieces, from piece to piece by FJ07.10, 12 and 19.
   Definitions (n degree, u knots, c points, pieces k = 1, 2, ...; L, M the starred parameters):
     empty n u k             piece k has length zero
     locals n u L M k b      Lam_k and M_k: from those of piece k - 1, where b has them, else from L, M
     rows_from n u c L M k j b d   the rows of the pieces k, ..., k + j - 1 that are not empty; d is where the first begins
     rows_program n u c L M d      those of all pieces
     relate n u c L M ks d rows    the rows are those of the pieces ks + 1, from d on: (12) on each with the paper's Lam_k, M_k, and each begins
                                   where the one before ends *)
From Torse Require Import Prelude Blossom Curves Points Segments FJ07_3_pieces FJ07_3_segments Executable Executable_knots Executable_net Executable_pieces
  Executable_splines.

Section Programs.
Variables (T Q : Type) (K : scalars T) (V : points T Q).
Implicit Types (u : seq T) (c : seq Q) (n k j : nat) (L M : T) (d : Q).
Local Notation "x - y" := (ssub K x y).
Local Notation "x * y" := (smul K x y).
Local Notation "x / y" := (smul K x (sinv K y)).

Definition empty n u k := same K (begins K n u k) (begins K n u k.+1).
Definition locals n u L M k (before : option (T * T)) :=
  if before is Some (l, m) then let step := length_ K n u k.-1 / length_ K n u k in (step * (l - one K), step * (m - one K))
  else ((L - begins K n u k) / length_ K n u k, (M - begins K n u k) / length_ K n u k).
Fixpoint rows_from n u c L M k j before d : answer (seq (seq Q)) := if j is j'.+1 then
  if empty n u k then rows_from n u c L M k.+1 j' None d else
  given (carries K n (drop k.-1 u)) Division (
    let lm := locals n u L M k before in
    match aumann_program K V (restricted_points K V n u c k (begins K n u k) (begins K n u k.+1)) lm.1 lm.2 d with
    | Value row => match rows_from n u c L M k.+1 j' (Some lm) (last d row) with Value rows => Value (row :: rows) | Fails e => Fails _ e end
    | Fails e => Fails _ e
    end)
  else Value [::].
Definition rows_program n u c L M d := knot_list K n u (fits n u c (rows_from n u c L M 1 (last_ n u - n).+1 None d)).
End Programs.

Section Equal.
Variables (F : fieldType) (m : nat) (lt : F -> F -> bool).
Implicit Types (u : seq F) (c row : seq 'rV[F]_m) (n k j : nat) (L M : F) (d : 'rV[F]_m).
Local Notation K := (of_field lt).
Local Notation V := (rows F m).
Local Notation at_list := (nth 0).

(* n is one less than the degree, pieces count from 0. *)
Fixpoint relate n u c L M ks d rows : Prop := match ks, rows with
  | k :: ks', row :: rows' => let C := bezier_net (at_list u) n k (at_list c) in let lam := local (at_list u) n k L in let mu := local (at_list u) n k M in
    [/\ span n.+1 (drop_ k (at_list u)), size row = n.+2, at_list row 0 = d,
        forall i, (i < n.+1)%N -> (1 - lam) *: C i + lam *: C i.+1 = (1 - mu) *: at_list row i + mu *: at_list row i.+1 &
        relate n u c L M ks' (at_list row n.+1) rows']
  | [::], [::] => True
  | _, _ => False
  end.

Lemma emptyE n u k : empty K n.+1 u k.+1 = (len (at_list u) n k == 0).
Proof. by rewrite /empty /begins /len !addSn !addnS !subSS !subn0 subr_eq0 eq_sym. Qed.

Lemma bezier_netE n u c k i : (i <= n.+1)%N ->
  at_list (restricted_points K V n.+1 u c k.+1 (begins K n.+1 u k.+1) (begins K n.+1 u k.+2)) i = bezier_net (at_list u) n k (at_list c) i.
Proof.
move=> le_i; rewrite /restricted_points nth_mkseq // deboor_drop /bezier_net /psegment /ends /begins !addSn !addnS !subSS !subn0 //.
Qed.

Lemma rows_fromS n u c L M k j before d : rows_from K V n u c L M k j.+1 before d =
  if empty K n u k then rows_from K V n u c L M k.+1 j None d else
  given (carries K n (drop k.-1 u)) Division (
    match aumann_program K V (restricted_points K V n u c k (begins K n u k) (begins K n u k.+1)) (locals K n u L M k before).1
      (locals K n u L M k before).2 d with
    | Value row => match rows_from K V n u c L M k.+1 j (Some (locals K n u L M k before)) (last d row) with
        Value rows => Value (row :: rows) | Fails e => Fails _ e end
    | Fails e => Fails _ e
    end).
Proof. by []. Qed.

Lemma rows_fromE n u c L M k j before d rows : rows_from K V n.+1 u c L M k.+1 j before d = Value rows ->
  (forall lm, before = Some lm -> exists2 h, k = h.+1 & len (at_list u) n h != 0 /\ lm = (local (at_list u) n h L, local (at_list u) n h M)) ->
  relate n u c L M [seq h <- iota k j | len (at_list u) n h != 0] d rows.
Proof.
elim: j k before d rows => [|j ih] k before d rows; first by move=> e _; rewrite -(Value_inj e).
rewrite rows_fromS emptyE [iota k _]/= [filter _ _]/=; case: eqP => /= [_|/eqP nz] e known.
  by apply: ih e _ => lm.
have [/carriesP sp {}e] := given_Value e.
have spd : span n.+1 (drop_ k (at_list u)) by move=> i l lt_i le_l; have := sp i l lt_i le_l; rewrite !nth_drop.
have lmE : locals K n.+1 u L M k.+1 before = (local (at_list u) n k L, local (at_list u) n k M).
  rewrite /locals lengthE; case: before known e => [[l' m']|] known _.
    have [h eh [nh]] := known _ erefl => -[-> ->]; subst k.
    by rewrite length1E !FJ07_10_recursion.
  by rewrite /local /begins !addSn !addnS !subSS !subn0.
move: e; rewrite lmE /=; set C := restricted_points _ _ _ _ _ _ _ _; have sC : size C = n.+2 by rewrite size_mkseq.
case E : (aumann_program _ _ _ _ _ _) => [row|//]; case E' : (rows_from _ _ _ _ _ _ _ _ _ _ _) => [rest|//] e.
have [sr r0 rel] := FJ07_12_program E; rewrite sC in sr r0 rel; rewrite -(Value_inj e) /=; split=> // [|i lt_i|].
- exact: r0.
- by have := rel i lt_i; rewrite !bezier_netE //; exact: ltnW.
have <- : last d row = at_list row n.+1 by rewrite -nth_last sr; apply: set_nth_default; rewrite sr.
by apply: ih E' _ => _ [<-]; exists k.
Qed.

(** FJ07.19 program: the program gives a row for each piece that is not empty, in order: with $C_i$, $\Lambda_k$ and $M_k$ of the piece
    $(1-\Lambda_k)C_i+\Lambda_kC_{i+1}=(1-M_k)D_i+M_kD_{i+1}$, $i<n$; the first begins at the given point, each other where the one before ends. *)
Theorem FJ07_19_program n u c L M d rows : rows_program K V n.+1 u c L M d = Value rows ->
  relate n u c L M [seq k <- iota 0 (size u - n.+1 - n.+1).+1 | len (at_list u) n k != 0] d rows.
Proof. by case/knot_listP=> _ /fitsP[_] /rows_fromE; apply. Qed.

End Equal.
