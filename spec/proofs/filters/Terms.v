(* The errors of polynomials in vectors, by computation. A term says how an expression of coordinates is made of
   vectors: with dot products, cross products, sums and multiples. `flatten` gives the expression, which a proof
     compares
   with the generated one. `size` bounds the value by a polynomial in the vectors' norms, and `error` is the error in
   units of that size. The rules are those of Norms.v. *)
From Coq Require Import Reals ZArith QArith Qreals Qround Lra Lia Psatz Bool.
From Flocq Require Import Core.
From Flowcert Require Import algebra.Vector3 code.Expression filters.Rounding filters.RoundedVectors filters.Norms
  filters.Floors.
Open Scope R_scope.

Inductive kind := Scalar | Vector.
Inductive term : kind -> Type :=
  | Given (k : nat) : term Vector  (* variables 3 k, 3 k + 1 and 3 k + 2 *)
  | Cross (a b : term Vector) : term Vector
  | Scale (s : term Scalar) (a : term Vector) : term Vector
  | VPlus (a b : term Vector) : term Vector
  | Dot (a b : term Vector) : term Scalar
  | Times (s t : term Scalar) : term Scalar
  | Plus (s t : term Scalar) : term Scalar
  | Minus (s t : term Scalar) : term Scalar
  | Twice (s : term Scalar) : term Scalar
  | Part (i : nat) (a : term Vector) : term Scalar  (* a coordinate *)
  | Size (s : term Scalar) : term Scalar.

(* ---- The expression ---- *)

Record triple A := Triple { tx : A; ty : A; tz : A }.
Arguments Triple {A}. Arguments tx {A}. Arguments ty {A}. Arguments tz {A}.
Definition shape k := match k with Scalar => expr | Vector => triple expr end.
Definition edot a b := Add (Add (Mul (tx a) (tx b)) (Mul (ty a) (ty b))) (Mul (tz a) (tz b)).
Definition ecross a b := Triple
  (Sub (Mul (ty a) (tz b)) (Mul (tz a) (ty b))) (Sub (Mul (tz a) (tx b)) (Mul (tx a) (tz b)))
  (Sub (Mul (tx a) (ty b)) (Mul (ty a) (tx b))).
Definition given k := Triple (Var (3 * k)) (Var (3 * k + 1)) (Var (3 * k + 2)).

Definition part {A} i (v : triple A) := match i with 0%nat => tx v | 1%nat => ty v | _ => tz v end.

Fixpoint flatten {k} (t : term k) : shape k :=
  match t with
  | Given n => given n
  | Cross a b => ecross (flatten a) (flatten b)
  | Scale s a => let f := flatten s in let v := flatten a in Triple (Mul f (tx v)) (Mul f (ty v)) (Mul f (tz v))
  | VPlus a b => let v := flatten a in let w := flatten b in
    Triple (Add (tx v) (tx w)) (Add (ty v) (ty w)) (Add (tz v) (tz w))
  | Dot a b => edot (flatten a) (flatten b)
  | Times s t => Mul (flatten s) (flatten t)
  | Plus s t => Add (flatten s) (flatten t)
  | Minus s t => Sub (flatten s) (flatten t)
  | Twice s => Mul (Cst 1 1) (flatten s)
  | Part i a => part i (flatten a)
  | Size s => Abs (flatten s)
  end.

(* ---- Values ---- *)

Definition meaning k := match k with Scalar => R | Vector => vec end.
Definition on_shape round (x : nat -> R) {k} : shape k -> meaning k :=
  match k with
  | Scalar => fun e => on_reals round x e
  | Vector => fun v => V (on_reals round x (tx v)) (on_reals round x (ty v)) (on_reals round x (tz v))
  end.

(* ---- Sizes and errors ---- *)

Fixpoint size (n : nat -> R) {k} (t : term k) : R :=
  match t with
  | Given k => n k
  | Cross a b => size n a * size n b
  | Scale s a => size n s * size n a
  | VPlus a b => size n a + size n b
  | Dot a b => size n a * size n b
  | Times s t => size n s * size n t
  | Plus s t | Minus s t => size n s + size n t
  | Twice s => 2 * size n s
  | Part _ a => size n a
  | Size s => size n s
  end.
(* The size is at least 10^-floor where every norm is at least 10^-43. *)
Fixpoint floor {k} (t : term k) : nat :=
  match t with
  | Given _ => 43
  | Cross a b => floor a + floor b
  | Scale s a => floor s + floor a
  | VPlus a b => floor a
  | Dot a b => floor a + floor b
  | Times s t => floor s + floor t
  | Plus s t | Minus s t => floor s
  | Twice s => floor s
  | Part _ a => floor a
  | Size s => floor s
  end%nat.
Definition deepest : nat := 260.
(* It has the first `count` vectors alone, and no product of it comes near underflow. *)
Fixpoint is_above_underflow (count : nat) {k} (t : term k) : bool :=
  match t with
  | Given k => (k <? count)%nat
  | Cross a b => is_above_underflow count a && is_above_underflow count b && (floor a + floor b <=? deepest)%nat
  | Scale s a => is_above_underflow count s && is_above_underflow count a && (floor s + floor a <=? deepest)%nat
  | VPlus a b => is_above_underflow count a && is_above_underflow count b
  | Dot a b => is_above_underflow count a && is_above_underflow count b && (floor a + floor b <=? deepest)%nat
  | Times s t => is_above_underflow count s && is_above_underflow count t && (floor s + floor t <=? deepest)%nat
  | Plus s t | Minus s t => is_above_underflow count s && is_above_underflow count t
  | Twice s => is_above_underflow count s
  | Part _ a => is_above_underflow count a
  | Size s => is_above_underflow count s
  end.

Definition unit : Q := 1 # 9007199254740992.
Definition tiny : Q := 1 # (10 ^ 30).
Definition larger (e f : Q) : Q := if Qle_bool e f then f else e.
(* Rounded up, so that numbers stay short. *)
Definition precision : positive := 2 ^ 120.
Definition up (q : Q) : Q := Qceiling (q * (Zpos precision # 1)) # precision.
(* Of a product whose factors have the errors e and f, with `rounding` of the computed factors' product. *)
Definition of_product (e f rounding : Q) : Q := up (e * (1 + f) + f + rounding * ((1 + e) * (1 + f)) + tiny).
Definition of_sum (e f : Q) : Q := let g := larger e f in up (g + unit * (1 + g)).
Fixpoint error (given : nat -> Q) {k} (t : term k) : Q :=
  match t with
  | Given k => given k
  | Cross a b => of_product (error given a) (error given b) (unit + (14143 # 10000) * (unit + unit * unit))
  | Scale s a => of_product (error given s) (error given a) unit
  | VPlus a b => of_sum (error given a) (error given b)
  | Dot a b => of_product (error given a) (error given b) ((30001 # 10000) * unit)
  | Times s t => of_product (error given s) (error given t) unit
  | Plus s t | Minus s t => of_sum (error given s) (error given t)
  | Twice s => error given s
  | Part _ a => error given a
  | Size s => error given s
  end%Q.

Definition approximates {k} (e n : R) : meaning k -> meaning k -> Prop :=
  match k with Scalar => sapprox e n | Vector => napprox e n end.

Lemma size_same : forall count n m k (t : term k), is_above_underflow count t = true ->
  (forall i, (i < count)%nat -> n i = m i) -> size n t = size m t.
Proof.
  intros count n m k t A E. induction t; cbn [is_above_underflow size] in *;
    rewrite ?andb_true_iff, ?Nat.ltb_lt in A; auto; decompose [and] A;
    rewrite ?IHt, ?IHt1, ?IHt2 by assumption; reflexivity.
Qed.

(* ---- Doubling, and coordinates ---- *)

Lemma rnd_double : forall x, fmt x -> rnd (2 * x) = 2 * x.
Proof.
  intros x Hx. apply round_generic; [apply valid_rnd_N|].
  apply FLT_format_generic in Hx; [|reflexivity]. destruct Hx as [[m k] E M K]. simpl in M, K.
  apply generic_format_FLT. exists (Float radix2 m (k + 1)); simpl; [|exact M | lia].
  rewrite E. unfold F2R; simpl. rewrite bpow_plus. change (bpow radix2 1) with 2. ring.
Qed.

Lemma coordinate_bound : forall v n, len v <= n -> Rabs (vx v) <= n /\ Rabs (vy v) <= n /\ Rabs (vz v) <= n.
Proof.
  intros v n H. unfold len in H.
  assert (G : forall t, t * t <= dot v v -> Rabs t <= n).
  { intros t Ht. eapply Rle_trans; [|exact H]. rewrite <- sqrt_Rsqr_abs. apply sqrt_le_1_alt. exact Ht. }
  repeat split; apply G; unfold dot; nra.
Qed.

(* ---- The theorem ---- *)

Lemma unit_u : Q2R unit = u. Proof. rewrite u_val. unfold Q2R; simpl. lra. Qed.
Lemma tiny_value : Q2R tiny = / 10 ^ 30. Proof.
  unfold Q2R. change (IZR (Qnum tiny)) with 1. rewrite Rmult_1_l, pow_IZR. apply f_equal. reflexivity.
Qed.
Lemma up_larger : forall q, Q2R q <= Q2R (up q).
Proof.
  intros q. apply Qle_Rle. unfold up. generalize (Qle_ceiling (q * (Zpos precision # 1))).
  generalize (Qceiling (q * (Zpos precision # 1))). intro z. unfold Qle, inject_Z. cbn [Qnum Qden Qmult]. lia.
Qed.
Lemma larger_left : forall e f, Q2R e <= Q2R (larger e f).
Proof.
  intros. unfold larger. destruct (Qle_bool e f) eqn:H; [|lra]. apply Qle_bool_iff in H. apply Qle_Rle. exact H.
Qed.
Lemma larger_right : forall e f, Q2R f <= Q2R (larger e f).
Proof.
  intros. unfold larger. destruct (Qle_bool e f) eqn:H; [lra|]. apply Qle_Rle.
  destruct (Qlt_le_dec f e) as [L|L]; [apply Qlt_le_weak, L|]. apply Qle_bool_iff in L. congruence.
Qed.
Ltac qreals := unfold of_product, of_sum, Qminus; cbv zeta; (eapply Rle_trans; [|apply up_larger]); repeat first
  [rewrite Q2R_plus | rewrite Q2R_mult]; rewrite ?tiny_value, ?unit_u;
  change (Q2R 1) with (1 * / 1); rewrite ?Rinv_1, ?Rmult_1_r.

Lemma floor_size : forall n, (forall k, / 10 ^ 43 <= n k) -> forall k (t : term k), / 10 ^ floor t <= size n t.
Proof.
  intros n Hn. assert (P : forall j, 0 < / 10 ^ j) by (intro; apply Rinv_0_lt_compat, pow_lt; lra).
  induction t; cbn [floor size]; auto using floor_mult.
  - generalize (P (floor t2)). lra.
  - generalize (P (floor t2)). lra.
  - generalize (P (floor t2)). lra.
  - generalize (P (floor t)). lra.
Qed.

Theorem errors : forall count n given x y,
  (forall k, / 10 ^ 43 <= n k) ->
  (forall k, (k < count)%nat -> napprox (Q2R (given k)) (n k) (V (x (3 * k)%nat) (x (3 * k + 1)%nat) (x (3 * k +
    2)%nat))
    (V (y (3 * k)%nat) (y (3 * k + 1)%nat) (y (3 * k + 2)%nat))) ->
  forall k (t : term k), is_above_underflow count t = true ->
  approximates (Q2R (error given t)) (size n t) (on_shape rnd x (flatten t)) (on_shape (fun r => r) y (flatten t)).
Proof.
  intros count n given x y Hn Hg.
  assert (U : forall j z, (j <= deepest)%nat -> / 10 ^ j <= z -> tau <= / 10 ^ 40 * z).
  { intros. eapply floor_tau; eauto. }
  induction t; intro A; cbn [is_above_underflow] in A; rewrite ?andb_true_iff, ?Nat.leb_le, ?Nat.ltb_lt in A.
  - apply Hg, A.
  - destruct A as [[A1 A2] A3]. specialize (IHt1 A1). specialize (IHt2 A2). cbn [approximates error size] in *.
    apply (napprox_cross _ _ _ _ _ _ _ _ (Q2R (error given (Cross t1 t2))) IHt1 IHt2).
    + apply (U _ _ A3). apply floor_mult; apply floor_size; auto.
    + cbn [error]. qreals. change (Q2R (14143 # 10000)) with 1.4143. lra.
  - destruct A as [[A1 A2] A3]. specialize (IHt1 A1). specialize (IHt2 A2). cbn [approximates error size] in *.
    apply (napprox_scale _ _ _ _ _ _ _ _ (Q2R (error given (Scale t1 t2))) IHt1 IHt2).
    + apply (U _ _ A3). apply floor_mult; apply floor_size; auto.
    + cbn [error]. qreals. lra.
  - destruct A as [A1 A2]. specialize (IHt1 A1). specialize (IHt2 A2). cbn [approximates error size] in *.
    apply (napprox_add (Q2R (larger (error given t1) (error given t2))) _ _ (on_shape rnd x (flatten t1))
      (on_shape rnd x (flatten t2)) (on_shape (fun r => r) y (flatten t1)) (on_shape (fun r => r) y (flatten t2))).
    + eapply napprox_weaken; [exact IHt1 | apply larger_left].
    + eapply napprox_weaken; [exact IHt2 | apply larger_right].
    + qreals. lra.
  - destruct A as [[A1 A2] A3]. specialize (IHt1 A1). specialize (IHt2 A2). cbn [approximates error size] in *.
    apply (sapprox_dot _ _ _ _ _ _ _ _ (Q2R (error given (Dot t1 t2))) IHt1 IHt2).
    + apply (U _ _ A3). apply floor_mult; apply floor_size; auto.
    + cbn [error]. qreals. change (Q2R (30001 # 10000)) with 3.0001. lra.
  - destruct A as [[A1 A2] A3]. specialize (IHt1 A1). specialize (IHt2 A2). cbn [approximates error size] in *.
    apply (sapprox_mult _ _ _ _ _ _ _ _ (Q2R (error given (Times t1 t2))) IHt1 IHt2).
    + apply (U _ _ A3). apply floor_mult; apply floor_size; auto.
    + cbn [error]. qreals. lra.
  - destruct A as [A1 A2]. specialize (IHt1 A1). specialize (IHt2 A2). cbn [approximates error size] in *.
    assert (H : sapprox (Q2R (of_sum (error given t1) (error given t2))) (size n t1 + size n t2)
      (rnd (on_shape rnd x (flatten t1) - - on_shape rnd x (flatten t2)))
      (on_shape (fun r => r) y (flatten t1) - - on_shape (fun r => r) y (flatten t2))).
    { eapply (sapprox_minus (Q2R (larger (error given t1) (error given t2)))).
      - eapply sapprox_weaken; [exact IHt1 | apply larger_left].
      - apply sapprox_opp. eapply sapprox_weaken; [exact IHt2 | apply larger_right].
      - qreals. lra. }
    unfold Rminus in H. rewrite !Ropp_involutive in H. exact H.
  - destruct A as [A1 A2]. specialize (IHt1 A1). specialize (IHt2 A2). cbn [approximates error size] in *.
    eapply (sapprox_minus (Q2R (larger (error given t1) (error given t2)))).
    + eapply sapprox_weaken; [exact IHt1 | apply larger_left].
    + eapply sapprox_weaken; [exact IHt2 | apply larger_right].
    + qreals. lra.
  - specialize (IHt A). cbn [approximates error size flatten on_shape on_reals] in *.
    replace (F2R (Float radix2 1 1)) with 2 by (unfold F2R; cbn [Fnum Fexp]; change (bpow radix2 1) with 2; ring).
    destruct IHt as [F He Hx C]. split; auto.
    + apply fmt_rnd.
    + rewrite rnd_double by auto.
      replace (2 * on_reals rnd x (flatten t) - 2 * on_reals (fun r => r) y (flatten t))
        with (2 * (on_reals rnd x (flatten t) - on_reals (fun r => r) y (flatten t))) by ring.
      rewrite Rabs_mult, (Rabs_pos_eq 2) by lra. lra.
    + rewrite Rabs_mult, (Rabs_pos_eq 2) by lra. lra.
  - specialize (IHt A). cbn [approximates error size] in *. destruct IHt as [[F1 [F2 F3]] He Hx C].
    destruct (coordinate_bound _ _ He) as [E1 [E2 E3]]. destruct (coordinate_bound _ _ Hx) as [S1 [S2 S3]].
    cbn [flatten]. destruct i as [|[|i]]; split; assumption.
  - specialize (IHt A). cbn [approximates error size flatten on_shape on_reals] in *.
    destruct IHt as [F He Hx C]. split; auto.
    + apply generic_format_abs. exact F.
    + eapply Rle_trans; [apply Rabs_triang_inv2 | exact He].
    + rewrite Rabs_Rabsolu. exact Hx.
Qed.
