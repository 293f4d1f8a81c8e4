(* The bounds of Rounding_binary_net.v and Rounding_binary_printed.v for the formats that processors have.
   Definitions:
     net_bound, net_down_bound, printed_bound, printed_down_bound   what Rounding_binary_net.v and Rounding_binary_printed.v say of a format
     double, doubles  binary64 of IEEE 754, 53 bits and exponents up to 1024, and its operations; binary32 has 24 bits and exponents up to 128 *)
From Torse Require Import Prelude_binary Points FJ07_3_net Rounding Rounding_net Rounding_printed Binary Rounding_binary Rounding_binary_net Rounding_binary_printed.

Definition double := number 53 1024.
#[export] Instance prec_double : Prec_gt_0 53 := erefl.
#[export] Instance range_double : Prec_lt_emax 53 1024 := erefl.
#[export] Instance prec_single : Prec_gt_0 24 := erefl.
#[export] Instance range_single : Prec_lt_emax 24 128 := erefl.
Definition doubles : arithmetic double := machine 53 1024.

(* The statements of `rounding.binary` for one format. *)
Section Bounds.
Variables (prec emax : Z).
Context {prec_pos : Prec_gt_0 prec} {prec_emax : Prec_lt_emax prec emax}.
Local Notation T := (number prec emax).
Local Notation machine := (machine prec emax).
Local Notation eps := (unit_roundoff prec).

Definition net_bound := forall (m n : nat) (u : nat -> T) (L M : T) (c : nat -> 'I_m -> T) (dK : 'I_m -> T) (d : nat -> 'rV[rat]_m) (K J : nat) k,
  d K = \row_k rational (dK k) -> (K <= J)%N -> (5 * (J - K) + 1)%:R * eps < 1 ->
  (forall i, (K <= i < J)%N -> cell (fun i => rational (u i)) n (rational L) (rational M) (read rational c) d i) ->
  upwards u n (c^~ k) K (fun near far p => survives L M near far p (dK k) (J - K)) ->
  `|rational (net_from machine u n L M (c^~ k) (dK k) K J) - d J 0 k|
    <= eps * `|d J 0 k| + (1 + eps) * bound_up eps (fun i => rational (u i)) n (rational L) (rational M) (fun i => rational (c i k)) (rational (dK k)) K J.

Definition net_down_bound := forall (m n : nat) (u : nat -> T) (L M : T) (c : nat -> 'I_m -> T) (dK : 'I_m -> T) (d : nat -> 'rV[rat]_m) (K J : nat) k,
  d K = \row_k rational (dK k) -> (J <= K)%N -> (5 * (K - J) + 1)%:R * eps < 1 ->
  (forall i, (J <= i < K)%N -> cell (fun i => rational (u i)) n (rational L) (rational M) (read rational c) d i) ->
  downwards u n (c^~ k) K (fun near far p => survives L M near far p (dK k) (K - J)) ->
  `|rational (net_from machine u n L M (c^~ k) (dK k) K J) - d J 0 k|
    <= eps * `|d J 0 k| + (1 + eps) * bound_down eps (fun i => rational (u i)) n (rational L) (rational M) (fun i => rational (c i k)) (rational (dK k)) K J.

Definition printed_bound := forall (m n : nat) (u : nat -> T) (L M : T) (c : nat -> 'I_m -> T) (dK : 'I_m -> T) (d : nat -> 'rV[rat]_m) (K J : nat) k,
  d K = \row_k rational (dK k) -> (K <= J)%N -> (5 * (J - K) + 1)%:R * eps < 1 ->
  (forall i, (K <= i < J)%N -> cell (fun i => rational (u i)) n (rational L) (rational M) (read rational c) d i) ->
  printed_up u n L M (c^~ k) K (fun b h s o p q => survives_printed b h s o p q (dK k) (J - K)) ->
  `|rational (printed_from machine u n L M (c^~ k) (dK k) K J) - d J 0 k| <= printed_bound_up rational eps u n L M c dK K J k.

Definition printed_down_bound := forall (m n : nat) (u : nat -> T) (L M : T) (c : nat -> 'I_m -> T) (dK : 'I_m -> T) (d : nat -> 'rV[rat]_m) (K J : nat) k,
  d K = \row_k rational (dK k) -> (J <= K)%N -> (5 * (K - J) + 1)%:R * eps < 1 ->
  (forall i, (J <= i < K)%N -> cell (fun i => rational (u i)) n (rational L) (rational M) (read rational c) d i) ->
  printed_down u n L M (c^~ k) K (fun b h s o p q => survives_printed b h s o p q (dK k) (K - J)) ->
  `|rational (printed_from machine u n L M (c^~ k) (dK k) K J) - d J 0 k| <= printed_bound_down rational eps u n L M c dK K J k.

End Bounds.

(** rounding.binary64 net: the vertex $J\ge K$ that the library computes in doubles from the vertex $K$ has in each coordinate an error of at most
    $u|d_J|+(1+u)\bigl(\gamma_{5(J-K)+1}|P(K,J)||d_K-c_K|
    +|\Lambda^{*}-M^{*}|\sum_{i=K}^{J-1}\gamma_{5(J-i)+1}|P(i+1,J)|\frac{|c_{i+1}-c_i|}{|M^{*}-u_i|}\bigr)$ with $u=2^{-53}$, where $d$ is the exact row (13).
    Hypotheses: $(5(J-K)+1)u<1$; the computed $d_J$ and the knots $u_K,\dots,u_{J-1}$ are finite; each computed product and quotient on the way is at
    least $2^{-1022}$ in size, unless a factor of it, or the dividend, is zero. That $M^{*}$ is none of these knots follows. *)
Theorem rounding_binary64_net : @net_bound 53 1024 _ _.
Proof. by move=> m n u L M c dK d K J k start; exact: rounding_binary_net. Qed.

(** rounding.binary64 net_down: the vertex $J\le K$ has in each coordinate an error of at most
    $u|d_J|+(1+u)\bigl(\gamma_{5(K-J)+1}|P(J,K)|^{-1}|d_K-c_K|
    +|\Lambda^{*}-M^{*}|\sum_{i=J}^{K-1}\gamma_{5(i+1-J)+1}|P(J,i)|^{-1}\frac{|c_{i+1}-c_i|}{|M^{*}-u_{i+n}|}\bigr)$ with $u=2^{-53}$.
    Hypotheses: as upwards, with the knots $u_{J+n},\dots,u_{K-1+n}$. *)
Theorem rounding_binary64_net_down : @net_down_bound 53 1024 _ _.
Proof. by move=> m n u L M c dK d K J k start; exact: rounding_binary_net_down. Qed.

(** rounding.binary64 printed: the vertex $J\ge K$ that the library computes in doubles from the vertex $K$ as (13) stands has in each coordinate an error of at most
    $\gamma_{5(J-K)}|P(K,J)||d_K|+\sum_{i=K}^{J-1}\gamma_{5(J-i)+1}\frac{|P(i+1,J)|}{|M^{*}-u_i|}\bigl(|u_{i+n}-\Lambda^{*}||c_i|+|\Lambda^{*}-u_i||c_{i+1}|\bigr)$ with $u=2^{-53}$.
    Hypotheses: $(5(J-K)+1)u<1$; the computed $d_J$ and the computed $M^{*}-u_i$, $K\le i<J$, are finite; each computed product and quotient on the way is at least
    $2^{-1022}$ in size, unless a factor of it, or the dividend, is zero. That $M^{*}$ is none of these knots follows. *)
Theorem rounding_binary64_printed : @printed_bound 53 1024 _ _.
Proof. by move=> m n u L M c dK d K J k start; exact: rounding_binary_printed. Qed.

(** rounding.binary64 printed_down: the vertex $J\le K$ has in each coordinate an error of at most
    $\gamma_{5(K-J)}|P(J,K)|^{-1}|d_K|+\sum_{i=J}^{K-1}\gamma_{5(i+1-J)+1}\frac{|P(J,i)|^{-1}}{|M^{*}-u_{i+n}|}
    \bigl(|u_{i+n}-\Lambda^{*}||c_i|+|\Lambda^{*}-u_i||c_{i+1}|\bigr)$ with $u=2^{-53}$.
    Hypotheses: as upwards, with the computed $u_{i+n}-M^{*}$, $J\le i<K$. *)
Theorem rounding_binary64_printed_down : @printed_down_bound 53 1024 _ _.
Proof. by move=> m n u L M c dK d K J k start; exact: rounding_binary_printed_down. Qed.

(** rounding.binary32 net: the bound of `rounding.binary64` net holds for the vertex $J\ge K$ that the library computes in singles, with $u=2^{-24}$.
    Hypotheses: as there, with $2^{-126}$ in the place of $2^{-1022}$. *)
Theorem rounding_binary32_net : @net_bound 24 128 _ _.
Proof. by move=> m n u L M c dK d K J k start; exact: rounding_binary_net. Qed.

(** rounding.binary32 net_down: the same for $J\le K$, with the bound of `rounding.binary64` net_down.
    Hypotheses: as upwards, with the knots $u_{J+n},\dots,u_{K-1+n}$. *)
Theorem rounding_binary32_net_down : @net_down_bound 24 128 _ _.
Proof. by move=> m n u L M c dK d K J k start; exact: rounding_binary_net_down. Qed.

(** rounding.binary32 printed: the bound of `rounding.binary64` printed holds for the vertex $J\ge K$ that the library computes in singles as (13) stands, with $u=2^{-24}$.
    Hypotheses: as there, with $2^{-126}$ in the place of $2^{-1022}$. *)
Theorem rounding_binary32_printed : @printed_bound 24 128 _ _.
Proof. by move=> m n u L M c dK d K J k start; exact: rounding_binary_printed. Qed.

(** rounding.binary32 printed_down: the same for $J\le K$, with the bound of `rounding.binary64` printed_down.
    Hypotheses: as upwards, with the computed $u_{i+n}-M^{*}$, $J\le i<K$. *)
Theorem rounding_binary32_printed_down : @printed_down_bound 24 128 _ _.
Proof. by move=> m n u L M c dK d K J k start; exact: rounding_binary_printed_down. Qed.
