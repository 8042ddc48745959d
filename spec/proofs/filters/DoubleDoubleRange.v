(* Where the operations of src/geometry/double_double.h do not overflow: where the high parts of the operands, and the
   quotient of high parts, are at most 2^450, for a root 2^900. A sum may have operands up to 2^1000. The low part of
   the result is finite there, which the theorems of DoubleDouble.v ask for. *)
From Coq Require Import Reals ZArith Lra Lia Bool List.
From Flocq Require Import Core BinarySingleNaN.
From Flowcert Require Import code.Expression code.generated.Doubled filters.Rounding filters.ExactSums
  filters.DoubledSums filters.DoubledQuotients filters.Doubles filters.Terms filters.DoubleDouble.
Import ListNotations.
Open Scope R_scope.

Definition is_at_most k (z : double) := Rabs (val z) <= bpow radix2 k.
Definition are_at_most k (x : nat -> double) := is_at_most k (x 0%nat) /\ is_at_most k (x 2%nat).

(* The first `count` variables are finite, and at most 2^k. *)
Definition top count k n := if (n <? count)%nat then k else (-2000)%Z.
Lemma forward_of : forall count k x e m, (forall n, (n < count)%nat -> finite (x n) /\ is_at_most k (x n)) ->
  height (top count k) e = Some m -> finite (on_doubles x e).
Proof.
  intros count k x e m H E. apply (forward x (top count k) e m); [|exact E]. intros n. unfold top.
  destruct (Nat.ltb_spec n count) as [L|G]; [intros _; apply H, L | discriminate].
Qed.

Lemma low_at_most : forall k h l, double_double h l -> is_at_most k h -> is_at_most k l.
Proof.
  intros k h l D H. generalize (low_size _ _ (doubled_of _ _ D)) (Rabs_pos (val h)). unfold is_at_most in *.
  rewrite u_val. lra.
Qed.
Lemma one_operand : forall k x, double_double (x 0%nat) (x 1%nat) -> is_at_most k (x 0%nat) ->
  forall n, (n < 2)%nat -> finite (x n) /\ is_at_most k (x n).
Proof.
  intros k x D A n H. assert (N : n = 0%nat \/ n = 1%nat) by lia. destruct N as [-> | ->]; split;
    try apply D; [exact A | apply (low_at_most _ _ _ D A)].
Qed.
Lemma two_operands : forall k x, operands x -> are_at_most k x ->
  forall n, (n < 4)%nat -> finite (x n) /\ is_at_most k (x n).
Proof.
  intros k x [Dx Dy] [Ax Ay] n H. destruct (Nat.lt_ge_cases n 2) as [L|G]; [apply one_operand; auto|].
  assert (N : n = 2%nat \/ n = 3%nat) by lia. destruct N as [-> | ->]; split;
    try apply Dy; [exact Ay | apply (low_at_most _ _ _ Dy Ay)].
Qed.

Theorem sum_finite : forall x, (forall n, (n < 2)%nat -> finite (x n) /\ is_at_most 1000 (x n)) ->
  finite (on_doubles x Doubled.sum_low).
Proof. intros x H. apply (forward_of 2 1000 x _ 1005 H). reflexivity. Qed.
Theorem product_finite : forall x, (forall n, (n < 2)%nat -> finite (x n) /\ is_at_most 450 (x n)) ->
  finite (on_doubles x Doubled.product_low).
Proof. intros x H. apply (forward_of 2 450 x _ 964 H). reflexivity. Qed.
Theorem plus_finite : forall x, operands x -> are_at_most 1000 x -> finite (on_doubles x Doubled.plus_low).
Proof. intros x D A. apply (forward_of 4 1000 x _ 1013 (two_operands _ _ D A)). reflexivity. Qed.
Theorem minus_finite : forall x, operands x -> are_at_most 1000 x -> finite (on_doubles x Doubled.minus_low).
Proof. intros x D A. apply (forward_of 4 1000 x _ 1013 (two_operands _ _ D A)). reflexivity. Qed.
Theorem times_finite : forall x, operands x -> are_at_most 450 x -> finite (on_doubles x Doubled.times_low).
Proof. intros x D A. apply (forward_of 4 450 x _ 968 (two_operands _ _ D A)). reflexivity. Qed.

(* ---- Quotient and root ---- *)

Lemma div_forward : forall k (a b : double), (-1074 <= k <= 1023)%Z -> finite a -> val b <> 0 ->
  Rabs (val a / val b) <= bpow radix2 k ->
  finite (Bdiv mode_NE a b) /\ val (Bdiv mode_NE a b) = rnd (val a / val b) /\ is_at_most k (Bdiv mode_NE a b).
Proof.
  intros k a b K F N B. unfold finite, is_at_most, val in *. generalize (Bdiv_correct 53 1024 _ _ mode_NE a b N).
  change (round radix2 (SpecFloat.fexp 53 1024) (round_mode mode_NE)) with rnd.
  rewrite Rlt_bool_true by (eapply no_overflow; eauto). intros [V [G _]]. rewrite G, V. split; [exact F|].
  split; [reflexivity|]. apply rnd_power; [lia | exact B].
Qed.

(* The first operation of a quotient and of a root as variable 4, so that no quotient and no root is left of what is
   made of it. *)
Fixpoint with_variable e :=
  match e with
  | Div (Var 0) (Var 2) | Root (Var 0) => Var 4
  | Add a b => Add (with_variable a) (with_variable b)
  | Sub a b => Sub (with_variable a) (with_variable b)
  | Mul a b => Mul (with_variable a) (with_variable b)
  | e => e
  end.
Definition numbered first n := if (n =? 4)%nat then first else Var n.
(* The variables are at most 2^k, and the first operation 2^j. *)
Lemma correction_finite : forall x first count k j e m, replace (numbered first) (with_variable e) = e ->
  (forall n, (n < count)%nat -> finite (x n) /\ is_at_most k (x n)) ->
  finite (on_doubles x first) -> is_at_most j (on_doubles x first) ->
  height (fun n => if (n =? 4)%nat then j else top count k n) (with_variable e) = Some m -> finite (on_doubles x e).
Proof.
  intros x first count k j e m E H F A T. rewrite <- E, on_doubles_replace. refine (proj1 (forward _ _ _ m _ T)).
  intros n. unfold numbered, top. destruct (Nat.eqb_spec n 4) as [_|N]; [auto|].
  destruct (Nat.ltb_spec n count); [intros _; apply H; assumption | discriminate].
Qed.
(* The last sum of both. *)
Lemma last_finite : forall k x a b, (k <= 1000)%Z -> (-1000 <= k)%Z -> finite (on_doubles x a) ->
  is_at_most k (on_doubles x a) ->
  finite (on_doubles x b) -> is_at_most k (on_doubles x b) -> finite (on_doubles x (Sub b (Sub (Add a b) a))).
Proof.
  intros k x a b K1 K2 Fa Aa Fb Ab.
  assert (E : Sub b (Sub (Add a b) a) = replace (fun n => if (n =? 0)%nat then a else b)
    (Sub (Var 1) (Sub (Add (Var 0) (Var 1)) (Var 0)))) by reflexivity.
  rewrite E, on_doubles_replace. apply (forward_of 2 k _ _ (k + 3)).
  - intros n _. destruct (n =? 0)%nat; auto.
  - unfold height, top, checked, in_doubles. cbn [Nat.ltb Nat.leb].
    repeat (match goal with |- context [(?a <=? ?b)%Z] => rewrite (proj2 (Z.leb_le a b)) by lia end; cbn [andb]).
    f_equal. lia.
Qed.

Definition quotient_numerator_term := match Doubled.x40 with Div a _ => a | e => e end.

Theorem quotient_finite : forall x, operands x -> are_at_most 450 x -> val (x 2%nat) <> 0 ->
  is_not_small (val (x 0%nat)) -> is_not_small (val (x 0%nat) / val (x 2%nat)) ->
  Rabs (val (x 0%nat) / val (x 2%nat)) <= bpow radix2 450 -> finite (on_doubles x Doubled.quotient_low).
Proof.
  intros x O A Y Bx Bq Q. destruct (O) as [Dx Dy]. assert (F0 : finite (x 0%nat)) by apply Dx.
  assert (Fy : finite (on_doubles x (Var 2))) by apply Dy. apply doubled_of in Dx, Dy.
  destruct (div_forward 450 (x 0%nat) (x 2%nat) ltac:(lia) F0 Y Q) as [F1 [V1 A1]].
  change (Bdiv mode_NE (x 0%nat) (x 2%nat)) with (on_doubles x Doubled.x33) in *.
  assert (Fn : finite (on_doubles x quotient_numerator_term)).
  { apply (correction_finite x Doubled.x33 4 450 450 _ 970 eq_refl (two_operands _ _ O A) F1 A1).
    vm_compute. reflexivity. }
  assert (Vn : val (on_doubles x quotient_numerator_term) = quotient_n (val (x 0%nat)) (val (x 1%nat)) (val (x 2%nat))
    (val (x 3%nat)) (rnd (val (x 0%nat) / val (x 2%nat)))) by value_of x quotient_numerator_term Fn.
  assert (Bn : Rabs (val (on_doubles x quotient_numerator_term) / val (x 2%nat)) <= bpow radix2 450).
  { rewrite Vn. destruct (zero_or_not_small _ _ Y Bx Bq) as [Z|[Hx Hq]].
    - rewrite Z in *. rewrite (zero_low _ Dx), zero_quotient, quotient_n_zero by apply fmt_val.
      unfold Rdiv. rewrite Rmult_0_l, Rabs_R0. apply bpow_ge_0.
    - destruct (quotient_correction _ _ _ _ Dx Dy Y Hx Hq) as [_ [_ [_ [_ B]]]].
      eapply Rle_trans; [exact B|]. generalize (Rabs_pos (val (x 0%nat) / val (x 2%nat))). rewrite u_val. lra. }
  destruct (div_forward 450 _ (x 2%nat) ltac:(lia) Fn Y Bn) as [F2 [_ A2]].
  apply (last_finite 450 x Doubled.x33 Doubled.x40); auto; lia.
Qed.

Lemma root_forward : forall a : double, finite a -> 0 <= val a -> finite (Bsqrt mode_NE a).
Proof.
  intros a F P. unfold finite, val in *. rewrite (proj1 (proj2 (Bsqrt_correct 53 1024 _ _ mode_NE a))).
  destruct a as [s|s| |s m e H]; try discriminate; [reflexivity|]. destruct s; [|reflexivity]. exfalso.
  apply (Rle_not_lt _ _ P). apply F2R_lt_0. reflexivity.
Qed.
Definition root_numerator_term := match Doubled.x47 with Div a _ => a | e => e end.

Theorem root_finite : forall x, double_double (x 0%nat) (x 1%nat) -> 0 <= val (x 0%nat) <= bpow radix2 900 ->
  is_not_small (val (x 0%nat)) -> finite (on_doubles x (run x Doubled.root_low)).
Proof.
  intros x D [Pos A] Big. assert (F0 : finite (x 0%nat)) by apply D. assert (Dx := doubled_of _ _ D).
  assert (C : compare_doubles Less (on_doubles x (Cst 0 0)) (on_doubles x (Var 0)) = Rlt_bool 0 (val (x 0%nat)))
    by (rewrite compare_finite; [reflexivity | reflexivity | exact F0]).
  unfold Doubled.root_low. cbn [run]. rewrite C. clear C.
  destruct (Rlt_bool_spec 0 (val (x 0%nat))) as [L|G]; [|reflexivity].
  assert (Hx : smallest <= val (x 0%nat)).
  { destruct Big as [Z|Big]; [lra|]. rewrite Rabs_pos_eq in Big by exact Pos. exact Big. }
  assert (Fr : finite (on_doubles x Doubled.x42)) by (apply root_forward; assumption).
  assert (Vr : val (on_doubles x Doubled.x42) = rnd (sqrt (val (x 0%nat)))) by (destruct (root_back _ Fr); assumption).
  assert (S : sqrt (val (x 0%nat)) <= bpow radix2 450).
  { rewrite <- (sqrt_Rsqr (bpow radix2 450)) by apply bpow_ge_0. apply sqrt_le_1_alt. unfold Rsqr.
    rewrite <- bpow_plus. exact A. }
  assert (Ar : is_at_most 450 (on_doubles x Doubled.x42)).
  { unfold is_at_most. rewrite Vr. apply rnd_power; [lia|]. rewrite Rabs_pos_eq by apply sqrt_pos. exact S. }
  assert (Fd : finite (on_doubles x (Mul (Cst 1 1) Doubled.x42))).
  { apply (twice_finite _ Fr). eapply Rle_trans; [exact Ar|]. apply bpow_le. lia. }
  assert (Vd : val (on_doubles x (Mul (Cst 1 1) Doubled.x42)) = 2 * rnd (sqrt (val (x 0%nat)))).
  { rewrite <- rnd_double by apply fmt_rnd. value_of x (Mul (Cst 1 1) Doubled.x42) Fd. }
  destruct (root_correction _ _ Dx Hx) as [P [_ [_ [_ [Large [_ B]]]]]].
  assert (Fn : finite (on_doubles x root_numerator_term)).
  { refine (correction_finite x Doubled.x42 2 900 450 _ 966 eq_refl (one_operand _ _ D _) Fr Ar _).
    - unfold is_at_most. rewrite Rabs_pos_eq by exact Pos. exact A.
    - vm_compute. reflexivity. }
  assert (Vn : val (on_doubles x root_numerator_term) = root_n (val (x 0%nat)) (val (x 1%nat))
    (rnd (sqrt (val (x 0%nat))))) by value_of x root_numerator_term Fn.
  rewrite <- Vn, <- Vd in B. rewrite <- Vd in Large.
  assert (Nd : val (on_doubles x (Mul (Cst 1 1) Doubled.x42)) <> 0).
  { intro Z. rewrite Z, Rabs_R0 in Large. lra. }
  destruct (div_forward 450 _ _ ltac:(lia) Fn Nd) as [F2 [_ A2]].
  { eapply Rle_trans; [exact B|]. rewrite u_val. lra. }
  apply (last_finite 450 x Doubled.x42 Doubled.x47); auto; lia.
Qed.
