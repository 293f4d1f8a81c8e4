(* BZZ19, section 5: the common normal and the warp angle, as identities of vectors of space. *)
From mathcomp Require Import all_ssreflect all_algebra ring zify.
From Torse Require Import Points.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Import GRing.Theory.
Local Open Scope ring_scope.

Section Warp.
Variable R : comUnitRingType.
Implicit Types a b w x : 'rV[R]_3.

(** BZZ19.7 normal: $E_1x=(x\cdot w)\,a\times b+(x\cdot a)\,b\times w+(x\cdot b)\,w\times a$ for $E_1=[w,a,b]$: where a vector $x\ne0$ is normal to
    all three, $E_1=0$. *)
Theorem BZZ19_7_normal a b w x :
  triple w a b *: x = dot x w *: cross a b + dot x a *: cross b w + dot x b *: cross w a.
Proof. by apply: row3P; coordinates; hide_entries; ring. Qed.

(** BZZ19.8 product: the normal $a\times b$ has $E_2=E_1^2$. *)
Theorem BZZ19_8_product a b w (x := cross a b) : dot x a ^+ 2 + dot x b ^+ 2 + dot x w ^+ 2 = triple w a b ^+ 2.
Proof. by rewrite /x; coordinates; hide_entries; ring. Qed.

(** BZZ19.W product: the normals $m=a\times w$, $n=b\times w$ at the ends of a ruling obey $m\times n=-[a,w,b]\,w$. *)
Theorem BZZ19_W_product a b w : cross (cross a w) (cross b w) = - triple a w b *: w.
Proof. by apply: row3P; coordinates; hide_entries; ring. Qed.

(** BZZ19.W sine: $|w|^2[a,w,b]^2+(m\cdot n)^2=|m|^2|n|^2$: so $\sin=|w|\,|[a,w,b]|/(|m|\,|n|)$ where $m$ and $n$ are not 0. *)
Theorem BZZ19_W_sine a b w (m := cross a w) (n := cross b w) :
  dot w w * triple a w b ^+ 2 + dot m n ^+ 2 = dot m m * dot n n.
Proof. by rewrite /m /n; coordinates; hide_entries; ring. Qed.
End Warp.
