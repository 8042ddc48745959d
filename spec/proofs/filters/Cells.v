(* The filter of a whole Delaunay cell, as cell_forms() of src/geometry/tetrahedron_forms.h computes it: twelve angles
   and four sides of facets, each with a bound of its error. Where a form's size is above its bound, its sign is that of
   the exact polynomial, for all finite points. A bound is infinite, or no number, where a norm is out of range. *)
From Coq Require Import Reals ZArith QArith Qreals Lra Lia Psatz Bool List.
From Flocq Require Import Core BinarySingleNaN.
From Flowcert Require Import algebra.Vector3 algebra.Tetrahedron code.Expression code.generated.Constants
  filters.Rounding filters.Floors filters.Doubles filters.Terms filters.Filter filters.Predicates.
From Flowcert Require code.generated.Cells.
Module Code := code.generated.Cells.Cell.
Import ListNotations.
Open Scope R_scope.

(* ---- Doubles that are no NaN, as real numbers: infinity is 2^1024 ---- *)

Definition is_number (x : double) := is_nan x = false.
Definition extended (x : double) : R :=
  match x with B754_infinity false => bpow radix2 1024 | B754_infinity true => - bpow radix2 1024 | _ => val x end.
Lemma extended_finite : forall x, finite x -> extended x = val x.
Proof. intros [s|s| |s m e H] F; try discriminate; reflexivity. Qed.
Lemma finite_size : forall x : double, Rabs (val x) < bpow radix2 1024.
Proof. intros. apply (abs_B2R_lt_emax 53 1024). Qed.
Lemma compare_extended : forall r x y, r <> Equal -> is_number x -> is_number y ->
  compare_doubles r x y = compare_reals r (extended x) (extended y).
Proof.
  intros r x y Hr Nx Ny. assert (B := bpow_gt_0 radix2 1024).
  destruct (is_finite x) eqn:Fx, (is_finite y) eqn:Fy.
  - rewrite compare_finite, !extended_finite by assumption. reflexivity.
  - rewrite (extended_finite x Fx). generalize (finite_size x). intro S. apply Rabs_lt_inv in S.
    destruct y as [s|s| |s m e H]; try discriminate. destruct r, s; try congruence; cbn [compare_reals extended].
    + rewrite Rlt_bool_false by lra. destruct x as [t|t| |t m e H]; try destruct t; try discriminate; reflexivity.
    + rewrite Rlt_bool_true by lra. destruct x as [t|t| |t m e H]; try destruct t; try discriminate; reflexivity.
    + rewrite Rle_bool_false by lra. destruct x as [t|t| |t m e H]; try destruct t; try discriminate; reflexivity.
    + rewrite Rle_bool_true by lra. destruct x as [t|t| |t m e H]; try destruct t; try discriminate; reflexivity.
  - rewrite (extended_finite y Fy). generalize (finite_size y). intro S. apply Rabs_lt_inv in S.
    destruct x as [s|s| |s m e H]; try discriminate. destruct r, s; try congruence; cbn [compare_reals extended].
    + rewrite Rlt_bool_true by lra. destruct y as [t|t| |t m e H]; try destruct t; try discriminate; reflexivity.
    + rewrite Rlt_bool_false by lra. destruct y as [t|t| |t m e H]; try destruct t; try discriminate; reflexivity.
    + rewrite Rle_bool_true by lra. destruct y as [t|t| |t m e H]; try destruct t; try discriminate; reflexivity.
    + rewrite Rle_bool_false by lra. destruct y as [t|t| |t m e H]; try destruct t; try discriminate; reflexivity.
  - destruct x as [s|s| |s m e H], y as [t|t| |t n f G]; try discriminate.
    cbn [extended]. revert B. generalize (bpow radix2 1024). intros b B.
    destruct r, s, t; try congruence; cbn [compare_reals]; unfold compare_doubles, Bltb, Bleb; cbn; symmetry; first
      [apply Rlt_bool_true; lra | apply Rlt_bool_false; lra | apply Rle_bool_true; lra
                      | apply Rle_bool_false; lra].
Qed.

(* ---- What is not negative, or no number ---- *)

(* No number, or not negative: the sign bit is not set, or it is a zero. *)
Definition not_negative (x : double) := is_nan x = true \/ Bsign x = false.
Definition blown (x : double) := is_nan x = true \/ x = B754_infinity false.

Lemma mul_not_negative : forall x y, not_negative x -> not_negative y -> not_negative (Bmult mode_NE x y).
Proof.
  intros x y Hx Hy. unfold not_negative in *.
  destruct (is_nan (Bmult mode_NE x y)) eqn:N; [auto|]. right.
  generalize (Bmult_correct 53 1024 _ _ mode_NE x y).
  assert (Sx : Bsign x = false).
  { destruct Hx as [H|H]; [|exact H]. destruct x; try discriminate. }
  assert (Sy : Bsign y = false).
  { destruct Hy as [H|H]; [|exact H]. destruct y; try discriminate. destruct x; discriminate. }
  case Rlt_bool.
  - intros [_ [_ S]]. rewrite S by exact N. rewrite Sx, Sy. reflexivity.
  - intro E. rewrite Sx, Sy in E. cbn in E. destruct (Bmult mode_NE x y); try discriminate.
    cbn in *. unfold binary_overflow in E. cbn in E. congruence.
Qed.
Lemma add_not_negative : forall x y, not_negative x -> not_negative y -> not_negative (Bplus mode_NE x y).
Proof.
  intros x y Hx Hy. unfold not_negative in *.
  destruct (is_nan (Bplus mode_NE x y)) eqn:N; [auto|]. right.
  assert (Sx : Bsign x = false).
  { destruct Hx as [H|H]; [|exact H]. destruct x; discriminate. }
  assert (Sy : Bsign y = false).
  { destruct Hy as [H|H]; [|exact H]. destruct y; try discriminate. destruct x; discriminate. }
  destruct (is_finite x) eqn:Fx, (is_finite y) eqn:Fy.
  - generalize (Bplus_correct 53 1024 _ _ mode_NE x y Fx Fy).
    assert (P : 0 <= B2R x + B2R y).
    { assert (Q : forall z : double, Bsign z = false -> 0 <= B2R z).
      { intros [s|s| |s m e H] S; cbn in *; try lra. subst s. apply F2R_ge_0. cbn. lia. }
      generalize (Q x Sx) (Q y Sy). lra. }
    case Rlt_bool.
    + intros [_ [_ S]]. rewrite S. case Rcompare_spec; intro C; [lra | | reflexivity]. rewrite Sx, Sy. reflexivity.
    + intros [E _]. destruct (Bplus mode_NE x y); try discriminate; cbn in *.
      unfold binary_overflow in E. cbn in E. rewrite Sx in E. congruence.
  - destruct x as [s|s| |s m e H], y as [t|t| |t n f G]; cbn in *; congruence.
  - destruct x as [s|s| |s m e H], y as [t|t| |t n f G]; cbn in *; congruence.
  - destruct x as [s|s| |s m e H], y as [t|t| |t n f G]; cbn in *; try discriminate.
    destruct (Bool.eqb s t); cbn in *; congruence.
Qed.
Lemma mul_blown_left : forall x y, blown x -> not_negative y -> blown (Bmult mode_NE x y).
Proof.
  intros x y [H|H] Hy.
  - left. destruct x; try discriminate. destruct y; reflexivity.
  - subst x. destruct Hy as [H|H]; [left; destruct y; try discriminate; reflexivity|].
    destruct y as [t|t| |t n f G]; cbn in *; subst; [left | right | left | right]; reflexivity.
Qed.
Lemma mul_blown_right : forall x y, not_negative x -> blown y -> blown (Bmult mode_NE x y).
Proof.
  intros x y Hx [H|H].
  - left. destruct y; try discriminate. destruct x; reflexivity.
  - subst y. destruct Hx as [H|H]; [left; destruct x; try discriminate; reflexivity|].
    destruct x as [t|t| |t n f G]; cbn in *; subst; [left | right | left | right]; reflexivity.
Qed.

Lemma blown_is_greater : forall x y, blown x -> Bltb x (Babs y) = false.
Proof.
  intros x y [H|H].
  - destruct x; try discriminate. destruct y; reflexivity.
  - subst x. destruct y as [t|t| |t n f G]; reflexivity.
Qed.

(* An expression of what is not negative is not negative. It is blown where a factor of it is. *)
Fixpoint is_positive e : bool :=
  match e with
  | Var _ => true
  | Cst m k => ((0 <? m) && (m <? 2 ^ 53) && (-1000 <=? k) && (k <=? 900))%Z
  | Add a b | Mul a b => is_positive a && is_positive b
  | _ => false
  end.
Fixpoint blows (v : nat) e : bool :=
  match e with
  | Var n => (n =? v)%nat
  | Mul a b => blows v a && is_positive b || is_positive a && blows v b
  | _ => false
  end.
Lemma positive_not_negative : forall x e, (forall n, not_negative (x n)) -> is_positive e = true ->
  not_negative (on_doubles x e).
Proof.
  intros x e Hx. induction e; cbn [is_positive on_doubles]; intro H; try discriminate.
  - apply Hx.
  - rewrite !andb_true_iff, !Z.ltb_lt, !Z.leb_le in H. destruct H as [[[H1 H2] H3] H4]. right.
    assert (A : (Z.abs m < 2 ^ 53)%Z) by (rewrite Z.abs_eq; [exact H2 | apply Z.lt_le_incl, H1]).
    assert (L := mantissa_bits m A).
    destruct (normal_constant m e (Z.log2 (Z.abs m) + 1 + e) A ltac:(lia) ltac:(lia) eq_refl) as [F V].
    match type of F with finite ?z => set (w := z) in * end.
    change (Bsign w = false). assert (P : 0 < val w).
    { rewrite V. apply F2R_gt_0. exact H1. }
    clear V F. clearbody w. destruct w as [s|s| |s mm ee Hm]; try (exfalso; cbn in P; lra). destruct s; [|reflexivity].
    exfalso. change (0 < F2R (Float radix2 (Z.neg mm) ee)) in P.
    assert (N : F2R (Float radix2 (Z.neg mm) ee) <= 0) by (apply F2R_le_0; cbn; lia). lra.
  - rewrite andb_true_iff in H. apply add_not_negative; tauto.
  - rewrite andb_true_iff in H. apply mul_not_negative; tauto.
Qed.
Lemma blows_blown : forall x v e, (forall n, not_negative (x n)) -> blown (x v) -> blows v e = true ->
  blown (on_doubles x e).
Proof.
  intros x v e Hx Hv. induction e; cbn [blows on_doubles]; intro H; try discriminate.
  - apply Nat.eqb_eq in H. subst n. exact Hv.
  - rewrite orb_true_iff, !andb_true_iff in H. destruct H as [[H1 H2]|[H1 H2]].
    + apply mul_blown_left; [tauto | apply positive_not_negative; auto].
    + apply mul_blown_right; [apply positive_not_negative; auto | tauto].
Qed.

(* ---- Norms of finite points ---- *)

Definition nonnegative (x : double) := is_number x /\ Bsign x = false.
Lemma nonnegative_not_negative : forall x, nonnegative x -> not_negative x.
Proof. intros x [_ H]. right. exact H. Qed.
Lemma difference_number : forall x y : double, finite x -> finite y -> is_number (Bminus mode_NE x y).
Proof.
  intros x y Fx Fy. unfold is_number. generalize (Bminus_correct 53 1024 _ _ mode_NE x y Fx Fy). case Rlt_bool.
  - intros [_ [F _]]. destruct (Bminus mode_NE x y); try discriminate; reflexivity.
  - intros [E _]. destruct (Bminus mode_NE x y); try discriminate; reflexivity.
Qed.
Lemma square_nonnegative : forall x, is_number x -> nonnegative (Bmult mode_NE x x).
Proof.
  intros x N. unfold nonnegative, is_number in *.
  assert (M : is_nan (Bmult mode_NE x x) = false).
  { destruct (is_finite x) eqn:Fx.
    - generalize (Bmult_correct 53 1024 _ _ mode_NE x x). case Rlt_bool.
      + intros [_ [F _]]. rewrite Fx in F. destruct (Bmult mode_NE x x); try discriminate; reflexivity.
      + intro E. destruct (Bmult mode_NE x x); try discriminate; reflexivity.
    - destruct x as [s|s| |s m e H]; try discriminate; reflexivity. }
  split; [exact M|].
  generalize (Bmult_correct 53 1024 _ _ mode_NE x x). case Rlt_bool.
  - intros [_ [_ S]]. rewrite S by exact M. apply xorb_nilpotent.
  - intro E. rewrite xorb_nilpotent in E. destruct (Bmult mode_NE x x); try discriminate. cbn in *.
    unfold binary_overflow in E. cbn in E. congruence.
Qed.
Lemma sum_nonnegative : forall x y, nonnegative x -> nonnegative y -> nonnegative (Bplus mode_NE x y).
Proof.
  intros x y [Nx Sx] [Ny Sy]. unfold nonnegative, is_number in *.
  assert (M : is_nan (Bplus mode_NE x y) = false).
  { destruct (is_finite x) eqn:Fx, (is_finite y) eqn:Fy.
    - generalize (Bplus_correct 53 1024 _ _ mode_NE x y Fx Fy). case Rlt_bool.
      + intros [_ [F _]]. destruct (Bplus mode_NE x y); try discriminate; reflexivity.
      + intros [E _]. destruct (Bplus mode_NE x y); try discriminate; reflexivity.
    - destruct x as [s|s| |s m e H], y as [t|t| |t n f G]; cbn in *; congruence.
    - destruct x as [s|s| |s m e H], y as [t|t| |t n f G]; cbn in *; congruence.
    - destruct x as [s|s| |s m e H], y as [t|t| |t n f G]; cbn in *; try discriminate. subst. reflexivity. }
  split; [exact M|]. destruct (add_not_negative x y) as [N|S]; auto; [right; auto | right; auto | congruence].
Qed.
Lemma root_nonnegative : forall x, nonnegative x -> nonnegative (Bsqrt mode_NE x).
Proof.
  intros x [N S]. unfold nonnegative, is_number in *. destruct (Bsqrt_correct 53 1024 _ _ mode_NE x) as [_ [F G]].
  assert (M : is_nan (Bsqrt mode_NE x) = false).
  { assert (K : is_finite (Bsqrt mode_NE x) = true -> is_nan (Bsqrt mode_NE x) = false)
      by (destruct (Bsqrt mode_NE x); try discriminate; reflexivity).
    destruct x as [s|s| |s m e H]; try discriminate; cbn [Bsign] in S; subst; try reflexivity. apply K, F. }
  split; [exact M|]. rewrite G by exact M. exact S.
Qed.

(* ---- The range test of a cell, and its unit ---- *)

(* As `least` and `most` of the code. *)
Definition least a b := Choose Less b a b a.
Definition most a b := Choose Less a b b a.
Definition smallest := least (least (norm 0) (norm 1)) (norm 2).
Definition largest := most (most (norm 0) (norm 1)) (norm 2).
Definition low := Cst (fst kSmallestNorm) (snd kSmallestNorm).
Definition high := Cst (fst kLargestNorm) (snd kLargestNorm).
Definition kUnit := Cst (fst kUnitRoundoff) (snd kUnitRoundoff).
Definition unit_or_infinity := Choose LessEqual low smallest (Choose LessEqual largest high kUnit Infinite) Infinite.

(* A bound has the norms for variables 0, 1 and 2, the largest one for 3, and the unit for 4. *)
Definition of_bound k := match k with 3%nat => largest | 4%nat => unit_or_infinity | _ => norm k end.
Definition with_unit bound := replace (fun k => if (k =? 4)%nat then kUnit else Var k) bound.

Section Cell.
Variable pairs : list (nat * nat).
Variable y : nat -> double.
Hypothesis points_are_finite : forall n, finite (y n).
Let x n := on_doubles y (between pairs n).

Lemma norm_nonnegative : forall k, nonnegative (on_doubles x (norm k)).
Proof.
  assert (N : forall n, is_number (x n)) by (intro; apply difference_number; apply points_are_finite).
  intro k. unfold norm. cbn [on_doubles edot given tx ty tz]. apply root_nonnegative.
  apply sum_nonnegative; [apply sum_nonnegative|]; apply square_nonnegative, N.
Qed.

Lemma choose_double : forall a b yes no, is_number (on_doubles x a) -> is_number (on_doubles x b) ->
  on_doubles x (Choose Less a b yes no) =
  if Rlt_bool (extended (on_doubles x a)) (extended (on_doubles x b)) then on_doubles x yes else on_doubles x no.
Proof.
  intros a b yes no Na Nb. cbn [on_doubles]. rewrite compare_extended; [reflexivity | discriminate | exact Na | exact
    Nb].
Qed.

Lemma least_value : forall a b, nonnegative (on_doubles x a) -> nonnegative (on_doubles x b) ->
  nonnegative (on_doubles x (least a b)) /\
  extended (on_doubles x (least a b)) <= extended (on_doubles x a) /\
  extended (on_doubles x (least a b)) <= extended (on_doubles x b).
Proof.
  intros a b [Na Sa] [Nb Sb]. unfold least. rewrite choose_double by assumption.
  case Rlt_bool_spec; intro; (split; [split; assumption | split; lra]).
Qed.
Lemma most_value : forall a b, nonnegative (on_doubles x a) -> nonnegative (on_doubles x b) ->
  nonnegative (on_doubles x (most a b)) /\
  extended (on_doubles x a) <= extended (on_doubles x (most a b)) /\
  extended (on_doubles x b) <= extended (on_doubles x (most a b)).
Proof.
  intros a b [Na Sa] [Nb Sb]. unfold most. rewrite choose_double by assumption.
  case Rlt_bool_spec; intro; (split; [split; assumption | split; lra]).
Qed.

Lemma constant_number : forall m k, (Z.abs m < 2 ^ 53)%Z -> (-1000 <= k <= 900)%Z ->
  finite (on_doubles x (Cst m k)).
Proof.
  intros m k Hm Hk. assert (L := mantissa_bits m Hm).
  exact (proj1 (normal_constant m k (Z.log2 (Z.abs m) + 1 + k) Hm ltac:(lia) ltac:(lia) eq_refl)).
Qed.
Lemma finite_number : forall z, finite z -> is_number z.
Proof. intros [s|s| |s m e H] F; try discriminate; reflexivity. Qed.

(* Where the unit is one, all three norms are in range, and so is the largest one. *)
Lemma cell_range : is_range kSmallestNorm kLargestNorm = true ->
  compare_doubles LessEqual (on_doubles x low) (on_doubles x smallest) = true ->
  compare_doubles LessEqual (on_doubles x largest) (on_doubles x high) = true ->
  are_in_range kSmallestNorm kLargestNorm 3 x /\ is_in_range kSmallestNorm kLargestNorm x largest /\
  forall k, (k < 3)%nat -> val (on_doubles x (norm k)) <= val (on_doubles x largest).
Proof.
  intros Range HL HH. generalize (norm_nonnegative 0) (norm_nonnegative 1) (norm_nonnegative 2). intros N0 N1 N2.
  destruct (least_value (norm 0) (norm 1) N0 N1) as [L1 [L2 L3]].
  destruct (least_value (least (norm 0) (norm 1)) (norm 2) L1 N2) as [M1 [M2 M3]].
  destruct (most_value (norm 0) (norm 1) N0 N1) as [P1 [P2 P3]].
  destruct (most_value (most (norm 0) (norm 1)) (norm 2) P1 N2) as [Q1 [Q2 Q3]].
  fold smallest in M1, M2, M3. fold largest in Q1, Q2, Q3.
  assert (Fl : is_number (on_doubles x low))
    by (apply finite_number, constant_number; [vm_compute; reflexivity | vm_compute; split; discriminate]).
  assert (Fh : is_number (on_doubles x high))
    by (apply finite_number, constant_number; [vm_compute; reflexivity | vm_compute; split; discriminate]).
  rewrite compare_extended in HL; [|discriminate | exact Fl | apply M1].
  rewrite compare_extended in HH; [|discriminate | apply Q1 | exact Fh].
  cbn [compare_reals] in HL, HH.
  assert (HL' : extended (on_doubles x low) <= extended (on_doubles x smallest))
    by (revert HL; case Rle_bool_spec; [auto | discriminate]).
  assert (HH' : extended (on_doubles x largest) <= extended (on_doubles x high))
    by (revert HH; case Rle_bool_spec; [auto | discriminate]).
  assert (In : forall e, nonnegative (on_doubles x e) -> extended (on_doubles x low) <= extended (on_doubles x e) ->
    extended (on_doubles x e) <= extended (on_doubles x high) -> is_in_range kSmallestNorm kLargestNorm x e).
  { intros e [Ne _] H1 H2. split; (rewrite compare_extended; [|discriminate | assumption | assumption]);
      apply Rle_bool_true; assumption. }
  assert (A0 : is_in_range kSmallestNorm kLargestNorm x (norm 0)) by (apply In; [exact N0 | lra | lra]).
  assert (A1 : is_in_range kSmallestNorm kLargestNorm x (norm 1)) by (apply In; [exact N1 | lra | lra]).
  assert (A2 : is_in_range kSmallestNorm kLargestNorm x (norm 2)) by (apply In; [exact N2 | lra | lra]).
  assert (A3 : is_in_range kSmallestNorm kLargestNorm x largest) by (apply In; [exact Q1 | lra | lra]).
  assert (F : forall e, is_in_range kSmallestNorm kLargestNorm x e -> extended (on_doubles x e) = val (on_doubles x e)).
  { intros e [E1 E2]. apply extended_finite. apply (in_range_back x kSmallestNorm kLargestNorm Range e E1 E2). }
  rewrite (F _ A0), (F _ A3) in *. rewrite (F _ A1), (F _ A2) in *.
  split; [|split; [exact A3|]].
  - intros [|[|[|k]]] Hk; [exact A0 | exact A1 | exact A2 | lia].
  - intros [|[|[|k]]] Hk; [lra | lra | lra | lia].
Qed.

Lemma run_certain_sign : forall form error s,
  run (fun k => match k with 0%nat => form | _ => error end) Code.certain_sign = Some s ->
  Bltb error (Babs form) = true /\ s = (if Bltb form (on_doubles x (Cst 0 0)) then Negative else Positive).
Proof.
  intros form error s H. unfold Code.certain_sign in H. cbn [run on_doubles compare_doubles] in H.
  destruct (Bltb error (Babs form)); [|discriminate]. split; [reflexivity|]. cbn [on_doubles].
  destruct (Bltb form _); congruence.
Qed.

Lemma unit_value : on_doubles x unit_or_infinity =
  if compare_doubles LessEqual (on_doubles x low) (on_doubles x smallest) then
    if compare_doubles LessEqual (on_doubles x largest) (on_doubles x high) then on_doubles x kUnit
    else B754_infinity false
  else B754_infinity false.
Proof. reflexivity. Qed.

Theorem form_right : forall (value : term Scalar) bound c,
  is_enough 3 4 value (with_unit bound) c = true -> blows 4 bound = true ->
  (forall n, (forall k, 0 < n k) -> (forall k, (k < 3)%nat -> n k <= n 3%nat) ->
    Q2R c * size n value <= exact n (with_unit bound)) ->
  forall s, run (fun k => match k with 0%nat => on_doubles x (flatten value)
                                      | _ => on_doubles x (replace of_bound bound) end) Code.certain_sign = Some s ->
  is_sign s (exact (exact_between pairs y) (flatten value)).
Proof.
  intros value bound c Good Blows Bound s H. apply run_certain_sign in H. destruct H as [HC Hs].
  assert (Range : is_range kSmallestNorm kLargestNorm = true) by (vm_compute; reflexivity).
  generalize (norm_nonnegative 0) (norm_nonnegative 1) (norm_nonnegative 2). intros N0 N1 N2.
  destruct (most_value (norm 0) (norm 1) N0 N1) as [P1 _].
  destruct (most_value (most (norm 0) (norm 1)) (norm 2) P1 N2) as [Q1 _]. fold largest in Q1.
  destruct (compare_doubles LessEqual (on_doubles x low) (on_doubles x smallest)) eqn:HL;
    [destruct (compare_doubles LessEqual (on_doubles x largest) (on_doubles x high)) eqn:HH|].
  2, 3: exfalso; rewrite on_doubles_replace, blown_is_greater in HC; [discriminate HC|];
    (apply (blows_blown _ 4 bound); [intro k | | exact Blows]).
  2, 4: destruct k as [|[|[|[|[|k]]]]]; cbn [of_bound]; try (apply nonnegative_not_negative; assumption || apply
    norm_nonnegative);
    right; rewrite unit_value, HL, ?HH; reflexivity.
  2, 3: right; cbn [of_bound]; rewrite unit_value, HL, ?HH; reflexivity.
  destruct (cell_range Range HL HH) as [Norms [Largest Most]].
  set (z := fun k => on_doubles x (of_bound k)).
  assert (EZ : on_doubles x (replace of_bound bound) = on_doubles z (with_unit bound)).
  { unfold with_unit. rewrite !on_doubles_replace. apply on_doubles_same. intro k.
    destruct (Nat.eqb_spec k 4) as [->|K]; [|reflexivity]. cbn [of_bound]. rewrite unit_value, HL, HH. reflexivity. }
  destruct (value_within_bound 3 4 kSmallestNorm kLargestNorm value (with_unit bound) c Good Range pairs y z Norms)
    as [FV [FB Final]].
  { intros k Hk. assert (A : is_in_range kSmallestNorm kLargestNorm x (of_bound k)).
    { destruct k as [|[|[|[|k]]]]; [apply (Norms 0%nat) | apply (Norms 1%nat) | apply (Norms 2%nat) | exact Largest |];
      lia. }
    destruct A as [A B]. destruct (in_range_back x kSmallestNorm kLargestNorm Range _ A B) as [F [L T]].
    split; [exact F|]. split; [apply guarded, L|]. eapply Rle_trans; [exact T | lra]. }
  { intros n Hn Pn. set (m := fun k => if (k <? 4)%nat then val (z k) else 1).
    assert (S : size n value = size m value).
    { apply (size_same 3); [unfold is_enough in Good; rewrite !andb_true_iff in Good; apply Good|].
      intros k Hk. rewrite Hn by exact Hk. unfold m, z. destruct k as [|[|[|k]]]; [reflexivity | reflexivity |
        reflexivity | lia]. }
    rewrite S. apply Bound.
    - assert (E : forall k, (k < 3)%nat -> n k = val (z k)).
      { intros k Hk. rewrite Hn by exact Hk. unfold z. destruct k as [|[|[|k]]]; [reflexivity | reflexivity |
        reflexivity | lia]. }
      assert (L := Most 0%nat ltac:(lia)). change (val (z 0%nat) <= val (z 3%nat)) in L.
      rewrite <- (E 0%nat) in L by lia. generalize (Pn 0%nat) (Pn 1%nat) (Pn 2%nat). intros G0 G1 G2.
      intro k. unfold m. destruct k as [|[|[|[|k]]]]; cbn [Nat.ltb Nat.leb].
      + rewrite <- E by lia. exact G0.
      + rewrite <- E by lia. exact G1.
      + rewrite <- E by lia. exact G2.
      + lra.
      + lra.
    - intros k Hk. unfold m, z. destruct k as [|[|[|k]]]; try lia; apply Most; lia. }
  fold x in FV, Final. change (on_doubles (fun n => on_doubles y (between pairs n)) (flatten value))
    with (on_doubles x (flatten value)) in *.
  rewrite EZ in HC. set (e := on_doubles z (with_unit bound)) in *. set (v := on_doubles x (flatten value)) in *.
  apply Rabs_le_inv in Final.
  assert (FA : finite (Babs v)) by (unfold finite; rewrite is_finite_Babs; exact FV).
  assert (L : val e < Rabs (val v)).
  { change (compare_doubles Less e (Babs v) = true) in HC. rewrite compare_finite in HC by assumption.
    cbn [compare_reals] in HC. unfold val in HC at 2. rewrite B2R_Babs in HC. fold (val v) in HC.
    revert HC. case Rlt_bool_spec; [auto | discriminate]. }
  assert (FZ : finite (on_doubles x (Cst 0 0))) by reflexivity.
  assert (Zero : val (on_doubles x (Cst 0 0)) = 0) by reflexivity.
  change (Bltb v (on_doubles x (Cst 0 0))) with (compare_doubles Less v (on_doubles x (Cst 0 0))) in Hs.
  rewrite compare_finite in Hs by assumption. rewrite Zero in Hs. cbn [compare_reals] in Hs. subst s.
  case Rlt_bool_spec; intro V; cbn [is_sign].
  - rewrite Rabs_left in L by exact V. lra.
  - rewrite Rabs_pos_eq in L by exact V. lra.
Qed.
End Cell.

(* ---- The forms of a cell ---- *)

Definition largest_norm := Var 3.
Definition units := Var 4.
(* As the code multiplies a constant by the unit. *)
Definition constant (k : Z * Z) := Cst (fst k) (snd k).
Definition cell_angles : list (term Scalar) :=
  let ab := Dot a b in let bc := Dot b c in let ca := Dot c a in
  let aa := Dot a a in let bb := Dot b b in let cc := Dot c c in
  [ab; ca; bc; Minus aa ab; Minus aa ca; Plus (Minus bc ab) (Minus aa ca);
   Minus bb ab; Minus bb bc; Plus (Minus ca ab) (Minus bb bc);
   Minus cc ca; Minus cc bc; Plus (Minus ab ca) (Minus cc bc)].
Definition cell_angle_bound := Mul (Mul (Mul (constant kCellAngleBound) units) largest_norm) largest_norm.
Definition code_angles := [Code.angle_0; Code.angle_1; Code.angle_2; Code.angle_3; Code.angle_4; Code.angle_5;
  Code.angle_6; Code.angle_7; Code.angle_8; Code.angle_9; Code.angle_10; Code.angle_11].

Definition s1 := Dot (Cross b c) centre_numerator.
Definition s2 := Dot (Cross c a) centre_numerator.
Definition s3 := Dot (Cross a b) centre_numerator.
Definition s0 :=
  let det := Dot a (Cross b c) in Minus (Minus (Minus (Times (Twice det) det) s1) s2) s3.
Definition t := Mul (Mul (Mul n0 n1) n2) (Add (Add n0 n1) n2).
Definition side_bound pair := Mul (Mul (Mul (constant kCellSideBound) units) t) pair.
Definition far_side_bound :=
  Mul (Mul (Mul (constant kFarCellSideBound) units) t) (Add (Add (Mul n0 n1) (Mul n1 n2)) (Mul n2 n0)).

(* The code computes these terms. *)
Theorem cell_angles_match : map flatten cell_angles = code_angles.
Proof. by_computation. Qed.
Theorem cell_sides_match :
  map flatten [s0; s1; s2; s3] = [Code.side_0; Code.side_1; Code.side_2; Code.side_3].
Proof. by_computation. Qed.
Theorem cell_bounds_match : map (replace of_bound)
    [cell_angle_bound; far_side_bound; side_bound (Mul n1 n2); side_bound (Mul n2 n0); side_bound (Mul n0 n1)] =
  [Code.angle_error; Code.side_error_0; Code.side_error_1; Code.side_error_2; Code.side_error_3].
Proof. by_computation. Qed.

(* A sign that certain_sign() gives of a form and its bound. *)
Definition answers y form error s :=
  run (fun k => match k with 0%nat => on_doubles y form | _ => on_doubles y error end) Code.certain_sign = Some s.
Definition from_vertex := between [(0, 1); (0, 2); (0, 3)]%nat.
Definition exact_from_vertex := exact_between [(0, 1); (0, 2); (0, 3)]%nat.

Definition all_enough values bound k := forallb (fun v => is_enough 3 4 v (with_unit bound) k) values.

Lemma unit_of_bound : forall n, exact n kUnit = u.
Proof. intros. unfold exact, kUnit, F2R. cbn [on_reals fst snd kUnitRoundoff]. unfold F2R, u. cbn [Fnum Fexp]. ring.
  Qed.
Lemma scaled_by_unit : forall n k, Q2R (scaled_value k) = exact n (constant k) * u.
Proof.
  intros. unfold scaled_value. rewrite rational_value. unfold exact, constant, u. cbn [on_reals]. unfold F2R.
  cbn [Fnum Fexp]. rewrite bpow_plus. change (snd kUnitRoundoff) with (-53)%Z. ring.
Qed.
Lemma fraction : forall p q, Q2R (Z.pos p # q) = IZR (Z.pos p) / IZR (Z.pos q).
Proof. reflexivity. Qed.

Lemma angle_sizes : forall n, (forall k, 0 < n k) -> (forall k, (k < 3)%nat -> n k <= n 3%nat) ->
  forall value, In value cell_angles -> size n value <= 4 * (n 3%nat * n 3%nat).
Proof.
  intros n P L. assert (M : forall i j, (i < 3)%nat -> (j < 3)%nat -> n i * n j <= n 3%nat * n 3%nat).
  { intros i j Hi Hj. generalize (P i) (P j) (L i Hi) (L j Hj). intros. apply Rmult_le_compat; lra. }
  generalize (M 0 0 ltac:(lia) ltac:(lia))%nat (M 0 1 ltac:(lia) ltac:(lia))%nat (M 1 1 ltac:(lia) ltac:(lia))%nat
    (M 1 2 ltac:(lia) ltac:(lia))%nat (M 2 2 ltac:(lia) ltac:(lia))%nat (M 2 0 ltac:(lia) ltac:(lia))%nat.
  intros M00 M01 M11 M12 M22 M20.
  assert (0 < n 3%nat * n 3%nat) by (apply Rmult_lt_0_compat; apply P).
  intros value Hv. unfold cell_angles in Hv.
  repeat (destruct Hv as [<-|Hv]; [cbn [size a b c]; lra|]). destruct Hv.
Qed.

Theorem cell_angles_right : forall value, In value cell_angles -> forall y, (forall n, finite (y n)) ->
  forall s, answers (fun n => on_doubles y (from_vertex n)) (flatten value) Code.angle_error s ->
  is_sign s (exact (exact_from_vertex y) (flatten value)).
Proof.
  intros value Hv y Fy s H. replace Code.angle_error with (replace of_bound cell_angle_bound) in H by by_computation.
  apply (form_right _ y Fy value cell_angle_bound (scaled_value kCellAngleBound * (1 # 4)) ) in H; [exact H | | |].
  - assert (E : all_enough cell_angles cell_angle_bound (scaled_value kCellAngleBound * (1 # 4)) = true) by
    by_computation.
    unfold all_enough in E. rewrite forallb_forall in E. apply E, Hv.
  - by_computation.
  - intros n P L. rewrite Q2R_mult, (scaled_by_unit n), fraction.
    change (exact n (with_unit cell_angle_bound)) with (exact n (constant kCellAngleBound) * exact n kUnit * n 3%nat * n
      3%nat).
    rewrite unit_of_bound. generalize (angle_sizes n P L value Hv). intro S.
    replace (exact n (constant kCellAngleBound) * u * (1 / 4) * size n value)
      with (exact n (constant kCellAngleBound) * u * (size n value / 4)) by field.
    rewrite (Rmult_assoc _ (n 3%nat)). apply Rmult_le_compat_l; [|lra].
    apply Rmult_le_pos; [apply F2R_ge_0; vm_compute; discriminate | generalize u_pos; lra].
Qed.

(* A bound that is a constant times the unit times `p`. *)
Lemma scaled_form_right : forall value bound k q p,
  is_enough 3 4 value (with_unit bound) (scaled_value k * q) = true -> blows 4 bound = true -> (0 <=? fst k)%Z = true ->
  (forall n, exact n (with_unit bound) = exact n (constant k) * exact n kUnit * p n) ->
  (forall n, (forall k, 0 < n k) -> Q2R q * size n value <= p n) ->
  forall y, (forall n, finite (y n)) ->
  forall s, answers (fun n => on_doubles y (from_vertex n)) (flatten value) (replace of_bound bound) s ->
  is_sign s (exact (exact_from_vertex y) (flatten value)).
Proof.
  intros value bound k q p Good Blows K Same Size y Fy s H.
  apply (form_right _ y Fy value bound (scaled_value k * q)) in H; [exact H | exact Good | exact Blows |].
  intros n P _. rewrite Q2R_mult, (scaled_by_unit n), Same, unit_of_bound, Rmult_assoc.
  apply Rmult_le_compat_l; [|apply Size, P].
  apply Rmult_le_pos; [apply F2R_ge_0; apply Z.leb_le, K | generalize u_pos; lra].
Qed.

Definition products n := n 0%nat * n 1%nat * n 2%nat * (n 0%nat + n 1%nat + n 2%nat).

(* A facet at vertex 0, whose edges from there have the norms i and j. *)
Ltac near_side side i j :=
  apply (scaled_form_right side (side_bound (Mul (Var i) (Var j))) kCellSideBound 1
    (fun n => products n * (n i * n j)));
    [by_computation | by_computation | by_computation
    | let n := fresh "n" in intro n; change (exact n (with_unit (side_bound (Mul (Var i) (Var j)))))
        with (exact n (constant kCellSideBound) * exact n kUnit * products n * (n i * n j)); ring
    | let n := fresh "n" in intros n _; rewrite Q2R_1; unfold products; cbn -[Rmult Rplus]; right; ring].

Theorem side_1_right : forall y, (forall n, finite (y n)) ->
  forall s, answers (fun n => on_doubles y (from_vertex n)) Code.side_1 Code.side_error_1 s ->
  is_sign s (exact (exact_from_vertex y) (flatten s1)).
Proof. near_side s1 1%nat 2%nat. Qed.
Theorem side_2_right : forall y, (forall n, finite (y n)) ->
  forall s, answers (fun n => on_doubles y (from_vertex n)) Code.side_2 Code.side_error_2 s ->
  is_sign s (exact (exact_from_vertex y) (flatten s2)).
Proof. near_side s2 2%nat 0%nat. Qed.
Theorem side_3_right : forall y, (forall n, finite (y n)) ->
  forall s, answers (fun n => on_doubles y (from_vertex n)) Code.side_3 Code.side_error_3 s ->
  is_sign s (exact (exact_from_vertex y) (flatten s3)).
Proof. near_side s3 0%nat 1%nat. Qed.

(* The square of |a||b||c| is at most a ninth of what the other three sides make. *)
Lemma nine_products : forall x y z, 0 < x -> 0 < y -> 0 < z -> 9 * (x * y * z) <= (x + y + z) * (x * y + y * z + z * x).
Proof.
  intros x y z Px Py Pz.
  assert (0 <= x * ((y - z) * (y - z))) by (apply Rmult_le_pos; [lra | apply Rle_0_sqr]).
  assert (0 <= y * ((z - x) * (z - x))) by (apply Rmult_le_pos; [lra | apply Rle_0_sqr]).
  assert (0 <= z * ((x - y) * (x - y))) by (apply Rmult_le_pos; [lra | apply Rle_0_sqr]).
  replace ((x + y + z) * (x * y + y * z + z * x)) with (9 * (x * y * z) + x * ((y - z) * (y - z)) +
    y * ((z - x) * (z - x)) + z * ((x - y) * (x - y))) by ring. lra.
Qed.
Theorem side_0_right : forall y, (forall n, finite (y n)) ->
  forall s, answers (fun n => on_doubles y (from_vertex n)) Code.side_0 Code.side_error_0 s ->
  is_sign s (exact (exact_from_vertex y) (flatten s0)).
Proof.
  apply (scaled_form_right s0 far_side_bound kFarCellSideBound (9 # 11)
    (fun n => products n * (n 0%nat * n 1%nat + n 1%nat * n 2%nat + n 2%nat * n 0%nat)));
    [by_computation | by_computation | by_computation | |].
  - intro n. change (exact n (with_unit far_side_bound)) with (exact n (constant kFarCellSideBound) * exact n kUnit *
      (n 0%nat * n 1%nat * n 2%nat * (n 0%nat + n 1%nat + n 2%nat)) *
      (n 0%nat * n 1%nat + n 1%nat * n 2%nat + n 2%nat * n 0%nat)).
    unfold products. ring.
  - intros n P. rewrite fraction. unfold products. cbn -[Rmult Rplus Rdiv].
    generalize (P 0%nat) (P 1%nat) (P 2%nat). generalize (n 0%nat) (n 1%nat) (n 2%nat). intros x y z Px Py Pz.
    assert (N := nine_products x y z Px Py Pz).
    assert (M : 0 < x * y * z) by (repeat apply Rmult_lt_0_compat; assumption).
    assert (N' : x * y * z * (9 * (x * y * z)) <= x * y * z * ((x + y + z) * (x * y + y * z + z * x)))
      by (apply Rmult_le_compat_l; lra). lra.
Qed.
