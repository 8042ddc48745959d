(* The operations of src/geometry/double_double.h on IEEE doubles, as they are generated. Where nothing overflows, which
   is where the low part of the result is finite, the sum of two doubles is exact, and a sum of double-doubles has a
   relative error of at most kDoubledRoundoff. So have a product, a quotient and a root where they are zero or at least
   2^-960, and a product of two doubles is exact where it is zero or at least 2^-969. Every result is a double-double:
   its high part is the sum of both parts, rounded. *)
From Coq Require Import Reals ZArith Lra Lia Bool List.
From Flocq Require Import Core BinarySingleNaN.
From Flowcert Require Import code.Expression code.generated.Constants code.generated.Doubled filters.Rounding
  filters.ExactSums filters.DoubledSums filters.DoubledQuotients filters.Doubles.
Import ListNotations.
Open Scope R_scope.

(* ---- Terms with quotients and roots ---- *)

Lemma div_back : forall x y : double, finite (Bdiv mode_NE x y) ->
  finite x /\ (finite y -> val y <> 0 /\ val (Bdiv mode_NE x y) = rnd (val x / val y)).
Proof.
  intros x y H. unfold finite, val in *. split.
  { destruct x as [sx|sx| |sx mx ex Hx], y as [sy|sy| |sy my ey Hy]; simpl in *; try reflexivity; discriminate. }
  intro Fy. assert (N : B2R y <> 0).
  { destruct y as [sy|sy| |sy my ey Hy]; try discriminate.
    - exfalso. destruct x; simpl in H; discriminate.
    - simpl. destruct sy; [apply Rlt_not_eq, F2R_lt_0; reflexivity | apply Rgt_not_eq, F2R_gt_0; reflexivity]. }
  split; [exact N|]. generalize (Bdiv_correct 53 1024 _ _ mode_NE x y N). case Rlt_bool.
  - intros [E _]. exact E.
  - intros E. exfalso. destruct (Bdiv mode_NE x y); simpl in *; discriminate.
Qed.

Definition is_constant m k := ((Z.abs m <? 2 ^ 53) && (-1074 <=? k) && (Z.log2 (Z.abs m) + 1 + k <=? 1023))%Z.
Fixpoint is_arithmetic e : bool :=
  match e with
  | Var _ => true
  | Cst m k => is_constant m k
  | Add a b | Sub a b | Mul a b | Div a b => is_arithmetic a && is_arithmetic b
  | Neg a | Root a => is_arithmetic a
  | _ => false
  end.
Fixpoint divisors e : list expr :=
  match e with
  | Add a b | Sub a b | Mul a b => divisors a ++ divisors b
  | Div a b => b :: divisors a ++ divisors b
  | Neg a | Root a => divisors a
  | _ => []
  end.

(* A finite result has the value of the rounded reals, where its divisors are finite. *)
Theorem backward : forall x e, is_arithmetic e = true -> Forall (fun d => finite (on_doubles x d)) (divisors e) ->
  finite (on_doubles x e) -> val (on_doubles x e) = rounded (fun n => val (x n)) e.
Proof.
  intros x. unfold rounded. induction e; intros A D F; cbn [is_arithmetic divisors on_doubles on_reals] in *;
    rewrite ?andb_true_iff, ?Forall_app in *; try discriminate.
  - reflexivity.
  - unfold is_constant in A. rewrite !andb_true_iff, Z.ltb_lt, !Z.leb_le in A. destruct A as [[M K] T].
    apply (normal_constant m e (Z.log2 (Z.abs m) + 1 + e) M K); [|reflexivity].
    generalize (mantissa_bits m M). lia.
  - destruct A, D, (add_back _ _ F) as [F1 [F2 V]]. rewrite V, IHe1, IHe2; auto.
  - destruct A, D, (sub_back _ _ F) as [F1 [F2 V]]. rewrite V, IHe1, IHe2; auto.
  - destruct A, D, (mul_back _ _ F) as [F1 [F2 V]]. rewrite V, IHe1, IHe2; auto.
  - apply Forall_cons_iff in D. rewrite Forall_app in D. destruct A, D as [D [D1 D2]], (div_back _ _ F) as [F1 V].
    destruct (V D) as [_ E]. rewrite E, IHe1, IHe2; auto.
  - unfold finite, val in *. rewrite is_finite_Bopp in F. rewrite B2R_Bopp, IHe; auto.
  - destruct (root_back _ F) as [F1 V]. rewrite V, IHe; auto.
Qed.

(* ---- Double-doubles ---- *)

Record double_double (h l : double) : Prop := DoubleDouble {
  finite_high : finite h;
  finite_low : finite l;
  rounded_high : rnd (val h + val l) = val h }.
Definition value h l := val h + val l.
Definition roundoff := F2R (Float radix2 (fst kDoubledRoundoff) (snd kDoubledRoundoff)).
(* The high and the low part are a double-double that stands for the real number. *)
Definition is_near (h l : double) (z : R) := double_double h l /\ Rabs (value h l - z) <= roundoff * Rabs z.

Lemma roundoff_value : 15 * (u * u) <= roundoff.
Proof.
  rewrite u_val. unfold roundoff, F2R. simpl. lra.
Qed.
Lemma doubled_of : forall h l, double_double h l -> doubled (val h) (val l).
Proof. intros h l [Fh Fl E]. split; auto using fmt_val. Qed.

(* The last operation of a low part is one on the high part. *)
Lemma high_back : forall x a b c, finite (on_doubles x (Sub a (Sub b c))) -> finite (on_doubles x b).
Proof.
  intros x a b c F. cbn [on_doubles] in F. apply sub_back in F. destruct F as [_ [F _]]. apply sub_back in F. apply F.
Qed.

Lemma near_of : forall x high low h l z k, finite (on_doubles x high) -> finite (on_doubles x low) ->
  val (on_doubles x high) = h -> val (on_doubles x low) = l -> doubled h l ->
  Rabs (h + l - z) <= k * (u * u) * Rabs z -> k <= 15 -> is_near (on_doubles x high) (on_doubles x low) z.
Proof.
  intros x high low h l z k Fh Fl <- <- [_ _ E] Err K. split; [split; assumption|].
  eapply Rle_trans; [exact Err|]. apply Rmult_le_compat_r; [apply Rabs_pos|].
  eapply Rle_trans; [|apply roundoff_value]. apply Rmult_le_compat_r; [|exact K].
  generalize u_pos. intro. apply Rmult_le_pos; lra.
Qed.

Lemma near_zero : forall h l : double, finite h -> finite l -> val h = 0 -> val l = 0 -> is_near h l 0.
Proof.
  intros h l Fh Fl Zh Zl. unfold is_near, value. rewrite Zh, Zl, Rplus_0_r, Rminus_0_r, Rabs_R0, Rmult_0_r.
  split; [|lra]. split; auto. rewrite Zh, Zl, Rplus_0_r. apply rnd_0.
Qed.

Lemma splitting_constant : F2R (Float radix2 134217729 0) = 134217729.
Proof. unfold F2R. cbn [Fnum Fexp]. change (bpow radix2 0) with 1. ring. Qed.
Lemma doubling_constant : F2R (Float radix2 1 1) = 2.
Proof. unfold F2R. cbn [Fnum Fexp]. change (bpow radix2 1) with 2. ring. Qed.
(* The value of a finite term. Its divisors have to be known as finite. *)
Ltac finite_divisors e :=
  let all := eval vm_compute in (divisors e) in change (divisors e) with all;
  repeat (constructor; [assumption|]); constructor.
Ltac value_of x e F :=
  etransitivity; [exact (backward x e eq_refl ltac:(finite_divisors e) F)|];
  let expanded := eval vm_compute in e in
  change e with expanded; unfold rounded; cbn [on_reals]; rewrite ?splitting_constant, ?doubling_constant;
  cbv beta zeta delta [sum_low ordered_low product_low split_high split_low plus_high plus_low plus_v plus_w plus_c
    times_high times_low times_d quotient_high quotient_low quotient_q quotient_n back_high back_low back_d
    root_high root_low root_q root_n];
  generalize rnd; intro; reflexivity.

(* a + b *)
Theorem sum_right : forall x, let h := on_doubles x Doubled.sum_high in let l := on_doubles x Doubled.sum_low in
  finite l -> double_double h l /\ value h l = val (x 0%nat) + val (x 1%nat).
Proof.
  intros x h l Fl. assert (Fh : finite h).
  { unfold l in Fl. cbn [on_doubles Doubled.sum_low] in Fl. apply add_back in Fl. destruct Fl as [Fl _].
    apply sub_back in Fl. destruct Fl as [_ [Fl _]]. apply sub_back in Fl. apply Fl. }
  assert (Eh : val h = rnd (val (x 0%nat) + val (x 1%nat))) by value_of x Doubled.sum_high Fh.
  assert (El : val l = sum_low (val (x 0%nat)) (val (x 1%nat))) by value_of x Doubled.sum_low Fl.
  rewrite sum_exact in El by apply fmt_val.
  assert (E : val h + val l = val (x 0%nat) + val (x 1%nat)) by (rewrite Eh, El; ring).
  split; [|exact E]. split; auto. rewrite E, Eh. reflexivity.
Qed.

(* a b *)
Theorem product_right : forall x, let h := on_doubles x Doubled.product_high in
  let l := on_doubles x Doubled.product_low in let exact := val (x 0%nat) * val (x 1%nat) in
  finite l ->
  finite h /\ val h = rnd exact /\ Rabs (value h l - exact) <= 7 / 2 * bpow radix2 (-1074) /\
  (exact = 0 \/ bpow radix2 (-969) <= Rabs exact -> double_double h l /\ value h l = exact).
Proof.
  intros x h l exact Fl. assert (Fh : finite h).
  { unfold l in Fl. cbn [on_doubles Doubled.product_low] in Fl. do 3 (apply add_back in Fl; destruct Fl as [Fl _]).
    apply sub_back in Fl. apply Fl. }
  assert (Eh : val h = rnd exact) by value_of x Doubled.product_high Fh.
  assert (El : val l = product_low (val (x 0%nat)) (val (x 1%nat))) by value_of x Doubled.product_low Fl.
  destruct (product_near _ _ (fmt_val (x 0%nat)) (fmt_val (x 1%nat))) as [E B]. rewrite <- El in E, B.
  fold exact in E, B. rewrite <- Eh in E, B. unfold value. split; [exact Fh|]. split; [exact Eh|].
  split; [rewrite Rabs_minus_sym; exact B|]. intro H. specialize (E H).
  assert (V : val h + val l = exact) by (rewrite E; ring).
  split; [|exact V]. split; [exact Fh | exact Fl|]. rewrite V. symmetry. exact Eh.
Qed.

(* A double is the high part of a double-double whose low part is 0. *)
Lemma from_double : forall a zero : double, finite a -> finite zero -> val zero = 0 ->
  double_double a zero /\ value a zero = val a.
Proof.
  intros a z Fa Fz Z. unfold value. rewrite Z, Rplus_0_r. split; [|reflexivity]. split; [exact Fa | exact Fz|].
  rewrite Z, Rplus_0_r. apply rnd_fmt, fmt_val.
Qed.

(* x + y. The variables are the parts of x, and those of y. *)
Definition of_x (x : nat -> double) := value (x 0%nat) (x 1%nat).
Definition of_y (x : nat -> double) := value (x 2%nat) (x 3%nat).
Definition operands (x : nat -> double) := double_double (x 0%nat) (x 1%nat) /\ double_double (x 2%nat) (x 3%nat).

Theorem plus_right : forall x, operands x -> finite (on_doubles x Doubled.plus_low) ->
  is_near (on_doubles x Doubled.plus_high) (on_doubles x Doubled.plus_low) (of_x x + of_y x).
Proof.
  intros x [Dx Dy] Fl. assert (Fh := high_back _ _ _ _ Fl). apply doubled_of in Dx, Dy.
  destruct (plus_doubled _ _ _ _ Dx Dy) as [D E].
  refine (near_of x _ _ _ _ _ 7 Fh Fl _ _ D E ltac:(lra));
    [value_of x Doubled.plus_high Fh | value_of x Doubled.plus_low Fl].
Qed.
Theorem minus_right : forall x, operands x -> finite (on_doubles x Doubled.minus_low) ->
  is_near (on_doubles x Doubled.minus_high) (on_doubles x Doubled.minus_low) (of_x x - of_y x).
Proof.
  intros x [Dx Dy] Fl. assert (Fh := high_back _ _ _ _ Fl). apply doubled_of in Dx, Dy. apply doubled_opp in Dy.
  destruct (plus_doubled _ _ _ _ Dx Dy) as [D E].
  replace (of_x x - of_y x) with (val (x 0%nat) + val (x 1%nat) + (- val (x 2%nat) + - val (x 3%nat)))
    by (unfold of_x, of_y, value; ring).
  refine (near_of x _ _ _ _ _ 7 Fh Fl _ _ D E ltac:(lra));
    [value_of x Doubled.minus_high Fh | value_of x Doubled.minus_low Fl].
Qed.

(* x y *)
(* x y, whatever underflows *)
Theorem times_near : forall x, let h := on_doubles x Doubled.times_high in let l := on_doubles x Doubled.times_low in
  operands x -> finite l ->
  double_double h l /\
  Rabs (value h l - of_x x * of_y x) <= roundoff * Rabs (of_x x * of_y x) + 5 * bpow radix2 (-1074).
Proof.
  intros x h l [Dx Dy] Fl. assert (Fh : finite h) by (unfold l in Fl; exact (high_back _ _ _ _ Fl)).
  apply doubled_of in Dx, Dy.
  destruct (times_doubled _ _ _ _ Dx Dy) as [[_ _ D] E]. cbv zeta in D, E.
  assert (Eh : val h = times_high (val (x 0%nat)) (val (x 1%nat)) (val (x 2%nat)) (val (x 3%nat)))
    by value_of x Doubled.times_high Fh.
  assert (El : val l = times_low (val (x 0%nat)) (val (x 1%nat)) (val (x 2%nat)) (val (x 3%nat)))
    by value_of x Doubled.times_low Fl.
  rewrite <- Eh, <- El in D, E. split; [split; assumption|].
  eapply Rle_trans; [exact E|]. apply Rplus_le_compat_r, Rmult_le_compat_r; [apply Rabs_pos|].
  generalize roundoff_value u_pos. nra.
Qed.

(* A number that is zero or not small. *)
Definition is_not_small z := z = 0 \/ bpow radix2 (-960) <= Rabs z.

Theorem times_right : forall x, operands x -> finite (on_doubles x Doubled.times_low) ->
  is_not_small (of_x x * of_y x) ->
  is_near (on_doubles x Doubled.times_high) (on_doubles x Doubled.times_low) (of_x x * of_y x).
Proof.
  intros x [Dx Dy] Fl Big. assert (Fh := high_back _ _ _ _ Fl). apply doubled_of in Dx, Dy.
  destruct (times_doubled _ _ _ _ Dx Dy) as [D E].
  refine (near_of x _ _ _ _ _ 9 Fh Fl _ _ D _ ltac:(lra));
    [value_of x Doubled.times_high Fh | value_of x Doubled.times_low Fl|].
  destruct Big as [Z|Big].
  - destruct (times_zero _ _ _ _ Dx Dy Z) as [-> ->]. rewrite Z, Rplus_0_r, Rminus_0_r, Rabs_R0. lra.
  - eapply Rle_trans; [exact E|]. fold (value (x 0%nat) (x 1%nat)) (value (x 2%nat) (x 3%nat)) (of_x x) (of_y x).
    generalize smallest_eta u_pos. intros Eta U. fold smallest in Big.
    assert (/ 256 * (u * u) * smallest <= / 256 * (u * u) * Rabs (of_x x * of_y x))
      by (apply Rmult_le_compat_l; [nra | exact Big]).
    assert (0 <= (u * u) * Rabs (of_x x * of_y x)) by (apply Rmult_le_pos; [nra | apply Rabs_pos]). lra.
Qed.

Lemma zero_or_not_small : forall a b, b <> 0 -> is_not_small a -> is_not_small (a / b) ->
  a = 0 \/ smallest <= Rabs a /\ smallest <= Rabs (a / b).
Proof.
  intros a b Y [Z|Ha] [Zq|Hq]; [left; exact Z | left; exact Z | left | right; split; assumption].
  replace a with (a / b * b) by (field; exact Y). rewrite Zq. ring.
Qed.

(* x / y *)
Theorem quotient_right : forall x, operands x -> finite (on_doubles x Doubled.quotient_low) ->
  is_not_small (val (x 0%nat)) -> is_not_small (val (x 0%nat) / val (x 2%nat)) ->
  of_y x <> 0 /\ is_near (on_doubles x Doubled.quotient_high) (on_doubles x Doubled.quotient_low) (of_x x / of_y x).
Proof.
  intros x [Dx Dy] Fl Bx Bq. assert (Fh := high_back _ _ _ _ Fl).
  assert (Fy : finite (on_doubles x (Var 2))) by apply Dy.
  apply doubled_of in Dx, Dy.
  assert (Y : val (x 2%nat) <> 0).
  { cbn [on_doubles Doubled.quotient_high Doubled.x41] in Fh. apply add_back in Fh. destruct Fh as [F _].
    cbn [on_doubles Doubled.x33] in F. apply div_back in F. apply F. exact Fy. }
  assert (Y1 : of_y x <> 0) by (intro Z; apply Y; apply (low_zero _ _ Dy Z)).
  split; [exact Y1|].
  assert (Eh : val (on_doubles x Doubled.quotient_high) =
    quotient_high (val (x 0%nat)) (val (x 1%nat)) (val (x 2%nat)) (val (x 3%nat)))
    by value_of x Doubled.quotient_high Fh.
  assert (El : val (on_doubles x Doubled.quotient_low) =
    quotient_low (val (x 0%nat)) (val (x 1%nat)) (val (x 2%nat)) (val (x 3%nat)))
    by value_of x Doubled.quotient_low Fl.
  destruct (zero_or_not_small _ _ Y Bx Bq) as [Z|[Hx Hq]].
  - unfold of_x, value at 1. rewrite Z in *. rewrite (zero_low _ Dx) in *.
    destruct (quotient_zero _ (val (x 3%nat)) (fmt_val (x 2%nat))) as [Zh Zl]. rewrite Zh in Eh. rewrite Zl in El.
    replace ((0 + 0) / of_y x) with 0 by (field; exact Y1). apply near_zero; assumption.
  - destruct (quotient_doubled _ _ _ _ Dx Dy Y Hx Hq) as [D E].
    exact (near_of x _ _ _ _ _ 15 Fh Fl Eh El D E ltac:(lra)).
Qed.

(* The root of x *)
Lemma twice_finite : forall r : double, finite r -> Rabs (val r) <= bpow radix2 512 ->
  finite (on_doubles (fun _ => r) (Mul (Cst 1 1) (Var 0))).
Proof.
  intros r F B. apply (forward (fun _ => r) (fun _ => 512%Z) (Mul (Cst 1 1) (Var 0)) 514); [|reflexivity].
  intros n _. split; assumption.
Qed.
Lemma root_size : forall a : double, finite a -> Rabs (rnd (sqrt (val a))) <= bpow radix2 512.
Proof.
  intros a F. apply rnd_power; [lia|]. rewrite Rabs_pos_eq by apply sqrt_pos.
  rewrite <- (sqrt_Rsqr (bpow radix2 512)) by apply bpow_ge_0. apply sqrt_le_1_alt. unfold Rsqr. rewrite <- bpow_plus.
  eapply Rle_trans; [apply Rle_abs|]. apply Rlt_le. apply (abs_B2R_lt_emax 53 1024).
Qed.

Theorem root_right : forall x, double_double (x 0%nat) (x 1%nat) ->
  0 <= val (x 0%nat) -> is_not_small (val (x 0%nat)) ->
  let h := on_doubles x (run x Doubled.root_high) in let l := on_doubles x (run x Doubled.root_low) in
  finite l -> is_near h l (sqrt (of_x x)).
Proof.
  intros x Dx Pos Big h l Fl. assert (F0 : finite (x 0%nat)) by apply Dx. apply doubled_of in Dx.
  assert (C : compare_doubles Less (on_doubles x (Cst 0 0)) (on_doubles x (Var 0)) = Rlt_bool 0 (val (x 0%nat)))
    by (rewrite compare_finite; [reflexivity | reflexivity | exact F0]).
  unfold h, l in *. unfold Doubled.root_high, Doubled.root_low in *. cbn [run] in *. rewrite C in *. clear C.
  destruct Big as [Z|Big].
  - rewrite Z, Rlt_bool_false in * by lra.
    assert (R : val (on_doubles x Doubled.x42) = 0).
    { transitivity (rnd (sqrt (val (x 0%nat)))); [apply (Bsqrt_correct 53 1024 _ _ mode_NE (x 0%nat))|].
      rewrite Z, sqrt_0. apply rnd_0. }
    assert (Fr : finite (on_doubles x Doubled.x42)).
    { cbn [on_doubles Doubled.x42]. unfold finite, val in *.
      destruct (x 0%nat) as [s|s| |s m e H]; try discriminate; [reflexivity|]. exfalso. revert Z. simpl.
      destruct s; [apply Rlt_not_eq, F2R_lt_0; reflexivity | apply Rgt_not_eq, F2R_gt_0; reflexivity]. }
    unfold of_x, value. rewrite Z in *. rewrite (zero_low _ Dx), Rplus_0_r, sqrt_0.
    apply near_zero; auto; reflexivity.
  - rewrite (Rabs_pos_eq _ Pos) in Big. fold smallest in Big. generalize smallest_pos. intro P.
    rewrite Rlt_bool_true in * by lra.
    assert (Fh := high_back _ _ _ _ Fl).
    assert (Fr : finite (on_doubles x Doubled.x42)).
    { cbn [on_doubles] in Fh. apply add_back in Fh. apply Fh. }
    assert (Fd : finite (on_doubles x (Mul (Cst 1 1) (Root (Var 0))))).
    { apply (twice_finite (on_doubles x Doubled.x42) Fr). destruct (root_back _ Fr) as [_ V].
      cbn [on_doubles Doubled.x42] in *. unfold val in *. rewrite V. apply root_size. exact F0. }
    destruct (root_doubled _ _ Dx Big) as [D E]. rewrite <- (Rabs_pos_eq (sqrt _)) in E at 2 by apply sqrt_pos.
    refine (near_of x _ _ _ _ _ 5 Fh Fl _ _ D E ltac:(lra)).
    + match goal with |- val (on_doubles x ?e) = _ => value_of x e Fh end.
    + match goal with |- val (on_doubles x ?e) = _ => value_of x e Fl end.
Qed.

(* |x| *)
Theorem absolute_right : forall x, double_double (x 0%nat) (x 1%nat) ->
  let h := on_doubles x (run x Doubled.absolute_high) in let l := on_doubles x (run x Doubled.absolute_low) in
  double_double h l /\ value h l = Rabs (of_x x).
Proof.
  intros x Dx h l. assert (F0 : finite (x 0%nat)) by apply Dx. assert (D := doubled_of _ _ Dx).
  assert (Z : doubled 0 0).
  { split; [apply generic_format_0 | apply generic_format_0 | rewrite Rplus_0_r; apply rnd_0]. }
  assert (C : compare_doubles Less (on_doubles x (Var 0)) (on_doubles x (Cst 0 0)) = Rlt_bool (val (x 0%nat)) 0)
    by (rewrite compare_finite; [reflexivity | exact F0 | reflexivity]).
  unfold h, l, Doubled.absolute_high, Doubled.absolute_low, of_x. cbn [run]. rewrite C. clear h l C.
  destruct (Rlt_bool_spec (val (x 0%nat)) 0) as [L|G]; cbn [on_doubles].
  - assert (O : forall z, val (Bopp z) = - val z) by (intro; apply B2R_Bopp). unfold value. rewrite Rabs_left, !O.
    + split; [|ring]. destruct Dx as [Fh Fl E]. split; unfold finite in *; rewrite ?is_finite_Bopp, ?O; auto.
      rewrite <- E at 2. rewrite <- rnd_opp. f_equal. ring.
    + generalize (proj2 (doubled_less _ _ _ _ D Z)). rewrite Rplus_0_r. auto.
  - split; [exact Dx|]. unfold value. symmetry. apply Rabs_pos_eq. apply Rnot_lt_le. intro H.
    rewrite <- (Rplus_0_r 0) in H. apply (doubled_less _ _ _ _ D Z) in H. destruct H as [H|[H1 H2]]; [lra|].
    rewrite H1 in D. apply zero_low in D. lra.
Qed.

(* x < y *)
Theorem less_right : forall x, operands x -> (run x Doubled.is_less = Some Positive <-> of_x x < of_y x).
Proof.
  intros x [Dx Dy]. unfold of_x, of_y, value. rewrite (doubled_less _ _ _ _ (doubled_of _ _ Dx) (doubled_of _ _ Dy)).
  destruct Dx as [F0 F1 _], Dy as [F2 F3 _]. unfold Doubled.is_less. cbn [run on_doubles].
  rewrite !compare_finite by assumption. cbn [compare_reals].
  destruct (Rlt_bool_spec (val (x 0%nat)) (val (x 2%nat))); [split; auto|].
  destruct (Req_bool_spec (val (x 0%nat)) (val (x 2%nat))).
  - destruct (Rlt_bool_spec (val (x 1%nat)) (val (x 3%nat))); split; auto; [discriminate | lra].
  - split; [discriminate | lra].
Qed.
