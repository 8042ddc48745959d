(* The filters of src/geometry/predicates.h, as they are generated: whatever the doubles are, also infinities and NaN,
  an
   answer is the sign of the exact polynomial in the points as they are. The constants are those of filter_bounds.h. *)
From Coq Require Import Reals ZArith QArith Qreals Lra Lia Psatz Bool List.
From Flocq Require Import Core BinarySingleNaN.
From Flowcert Require Import algebra.Vector3 algebra.Tetrahedron code.Expression code.generated.Constants
  filters.Rounding filters.Doubles filters.Terms filters.Filter.
From Flowcert Require code.generated.Predicates.
Module Code := code.generated.Predicates.
Import ListNotations.
Open Scope R_scope.

(* A constant of filter_bounds.h times the unit roundoff. *)
Definition scaled (c : Z * Z) := Cst (fst c) (snd c + snd kUnitRoundoff).
Definition scaled_value (c : Z * Z) := rational (fst c) (snd c + snd kUnitRoundoff).
Lemma scaled_exact : forall n c, Q2R (scaled_value c) = exact n (scaled c).
Proof. intros. unfold scaled_value. rewrite rational_value. reflexivity. Qed.

(* The same vectors, as the code names them. *)
Definition a := Given 0. Definition b := Given 1. Definition c := Given 2. Definition d := Given 3.
Definition n0 := Var 0. Definition n1 := Var 1. Definition n2 := Var 2. Definition n3 := Var 3.
Definition at_point (y : nat -> double) k := V (val (y (3 * k)%nat)) (val (y (3 * k + 1)%nat)) (val (y (3 * k +
  2)%nat)).

Definition from_0 y k := vsub (at_point y k) (at_point y 0).

Ltac by_computation := vm_compute; reflexivity.
Ltac same_size := intros n Hn; rewrite (scaled_exact n); unfold exact; cbn -[Rmult Rplus scaled]; right; ring.
Ltac same_polynomial H :=
  match type of H with is_sign _ ?z => match goal with |- is_sign _ ?x =>
    replace x with z; [exact H | clear; unfold from_0, numerator, exact, at_point, exact_between, ends; vunfold; ring]
      end end.
(* What is generated is this filter, and the theorem on filters holds of it. *)
Definition whole count pairs (value : term Scalar) bound :=
  replace_in_tree (between pairs) (filter (Cst (fst kSmallestNorm) (snd kSmallestNorm))
    (Cst (fst kLargestNorm) (snd kLargestNorm)) count (flatten value) bound).
Ltac filter_of code count pairs value bound constant :=
  intros y s H; assert (E : code = whole count pairs value bound) by by_computation; rewrite E in H;
  apply (filter_right count kSmallestNorm kLargestNorm value bound (scaled_value constant)) in H;
  [exact H | by_computation | by_computation | same_size].

Definition angle := Dot a b.
Definition angle_bound := Mul (Mul (scaled kAngleBound) n0) n1.
Theorem angle_right : forall y s, run y Code.Angle.sign = Some s ->
  is_sign s (dot (vsub (at_point y 0) (at_point y 1)) (vsub (at_point y 2) (at_point y 1))).
Proof.
  filter_of Code.Angle.sign 2%nat [(1, 0); (1, 2)]%nat angle angle_bound kAngleBound.
Qed.

Definition orientation := Dot a (Cross b c).
Definition orientation_bound := Mul (Mul (Mul (scaled kOrientationBound) n0) n1) n2.
Theorem orientation_right : forall y s, run y Code.Orientation.sign = Some s ->
  is_sign s (det (from_0 y 1) (from_0 y 2) (from_0 y 3)).
Proof.
  filter_of Code.Orientation.sign 3%nat [(0, 1); (0, 2); (0, 3)]%nat orientation orientation_bound kOrientationBound.
Qed.

Definition centre_numerator :=
  VPlus (VPlus (Scale (Dot a a) (Cross b c)) (Scale (Dot b b) (Cross c a))) (Scale (Dot c c) (Cross a b)).
Definition side_of_plane := Dot (Cross a b) centre_numerator.
Definition side_of_plane_bound :=
  Mul (Mul (Mul (scaled kSideOfPlaneBound) (Mul n0 n1)) (Mul (Mul n0 n1) n2)) (Add (Add n0 n1) n2).
Theorem side_of_plane_right : forall y s, run y Code.SideOfPlane.sign = Some s ->
  is_sign s (dot (cross (from_0 y 1) (from_0 y 2)) (numerator (from_0 y 1) (from_0 y 2) (from_0 y 3))).
Proof.
  assert (F : forall y s, run y Code.SideOfPlane.sign = Some s ->
    is_sign s (exact (exact_between [(0, 1); (0, 2); (0, 3)]%nat y) (flatten side_of_plane))).
  { filter_of Code.SideOfPlane.sign 3%nat [(0, 1); (0, 2); (0, 3)]%nat side_of_plane side_of_plane_bound
      kSideOfPlaneBound. }
  intros y s H. apply F in H. same_polynomial H.
Qed.

Definition outside_sphere := Minus (Times (Dot d d) (Dot a (Cross b c))) (Dot centre_numerator d).
Definition outside_sphere_bound :=
  Mul (Mul (Mul (scaled kOutsideSphereBound) (Mul (Mul n0 n1) n2)) n3) (Add (Add (Add n0 n1) n2) n3).
Theorem outside_sphere_right : forall y s, run y Code.OutsideSphere.sign = Some s ->
  is_sign s (dot (from_0 y 4) (from_0 y 4) * det (from_0 y 1) (from_0 y 2) (from_0 y 3) -
             dot (numerator (from_0 y 1) (from_0 y 2) (from_0 y 3)) (from_0 y 4)).
Proof.
  assert (F : forall y s, run y Code.OutsideSphere.sign = Some s ->
    is_sign s (exact (exact_between [(0, 1); (0, 2); (0, 3); (0, 4)]%nat y) (flatten outside_sphere))).
  { filter_of Code.OutsideSphere.sign 4%nat [(0, 1); (0, 2); (0, 3); (0, 4)]%nat outside_sphere outside_sphere_bound
      kOutsideSphereBound. }
  intros y s H. apply F in H. same_polynomial H.
Qed.

(* The same coordinate of both cross products, whose sizes are their lengths up to one factor. *)
Definition outside_circle i :=
  Plus (Times (Dot a b) (Size (Part i (Cross c d)))) (Times (Dot c d) (Size (Part i (Cross a b)))).
Definition outside_circle_bound := Mul (Mul (scaled kOutsideCircleBound) (Mul n0 n1)) (Mul n2 n3).
Definition outside_circle_pairs := [(2, 0); (2, 1); (3, 0); (3, 1)]%nat.
Theorem outside_circle_right : forall y s, run y Code.OutsideCircle.sign = Some s ->
  let p0 := at_point y 0 in let p1 := at_point y 1 in let q := at_point y 2 in let r := at_point y 3 in
  let at_q := cross (vsub p0 q) (vsub p1 q) in let at_r := cross (vsub p0 r) (vsub p1 r) in
  exists part, In part [vx; vy; vz] /\
  is_sign s (dot (vsub p0 q) (vsub p1 q) * Rabs (part at_r) + dot (vsub p0 r) (vsub p1 r) * Rabs (part at_q)).
Proof.
  intros y s H p0 p1 q r at_q at_r.
  set (decision i := decided (flatten (outside_circle i)) (replace norm outside_circle_bound)).
  set (size_at_q i := flatten (Size (Part i (Cross a b)))).
  assert (E : Code.OutsideCircle.sign = replace_in_tree (between outside_circle_pairs)
    (range_tests (Cst (fst kSmallestNorm) (snd kSmallestNorm)) (Cst (fst kLargestNorm) (snd kLargestNorm))
      (map norm (seq 0 4))
      (If LessEqual (size_at_q 1%nat) (size_at_q 0%nat)
        (If LessEqual (size_at_q 2%nat) (size_at_q 0%nat) (decision 0%nat)
          (If LessEqual (size_at_q 2%nat) (size_at_q 1%nat) (decision 1%nat) (decision 2%nat)))
        (If LessEqual (size_at_q 2%nat) (size_at_q 1%nat) (decision 1%nat) (decision 2%nat))))) by by_computation.
  rewrite E, run_replace in H. apply run_range_tests in H. destruct H as [Norms H].
  set (x := fun n => on_doubles y (between outside_circle_pairs n)) in *.
  assert (D : exists i, (i < 3)%nat /\ run x (decision i) = Some s).
  { cbn [run] in H. clearbody decision size_at_q x.
    repeat match type of H with (if ?e then _ else _) = _ => destruct e end;
      [exists 0%nat | exists 1%nat | exists 2%nat | exists 1%nat | exists 2%nat]; (split; [lia | exact H]). }
  destruct D as [i [Hi D]].
  assert (S : is_sign s (exact (exact_between outside_circle_pairs y) (flatten (outside_circle i)))).
  { apply (decided_right 4 kSmallestNorm kLargestNorm (outside_circle i) outside_circle_bound
      (scaled_value kOutsideCircleBound * (1 # 2))); [| by_computation | | | exact D].
    - destruct i as [|[|[|i]]]; [by_computation | by_computation | by_computation | lia].
    - intros n Hn. rewrite Q2R_mult, (scaled_exact n). replace (Q2R (1 # 2)) with (/ 2) by (unfold Q2R; cbn; lra).
      unfold exact. cbn -[Rmult Rplus scaled]. right. field.
    - intros k Hk. apply Norms, in_map, in_seq. lia. }
  destruct i as [|[|[|i]]]; [exists vx | exists vy | exists vz | lia];
    (split; [cbn; tauto|]); unfold at_q, at_r, p0, p1, q, r; same_polynomial S.
Qed.
