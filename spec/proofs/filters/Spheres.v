(* Comparing a sample with a cell's sphere, as compare_sphere() of src/geometry/tetrahedron_forms.h does: where it says
   that the polynomial is beyond its bound, the sample is not on the sphere, for all finite points. *)
From Coq Require Import Reals ZArith QArith Qreals Lra Lia Psatz Bool List.
From Flocq Require Import Core BinarySingleNaN.
From Flowcert Require Import algebra.Vector3 algebra.Tetrahedron code.Expression code.generated.Constants
  filters.Rounding filters.Doubles filters.Terms filters.Filter filters.Predicates filters.Cells.
Import ListNotations.
Open Scope R_scope.

Definition with_sample := [(0, 1); (0, 2); (0, 3); (0, 4)]%nat.

(* Above a bound in size is above it, or below its negative. *)
Lemma size_above : forall e v : double, Bltb e (Babs v) = true -> Bltb e v = true \/ Bltb v (Bopp e) = true.
Proof.
  intros e v H. destruct (is_finite e) eqn:Fe, (is_finite v) eqn:Fv.
  - change (Bltb e v) with (compare_doubles Less e v). change (Bltb v (Bopp e)) with (compare_doubles Less v (Bopp e)).
    change (compare_doubles Less e (Babs v) = true) in H.
    assert (Fa : finite (Babs v)) by (unfold finite; rewrite is_finite_Babs; exact Fv).
    assert (Fo : finite (Bopp e)) by (unfold finite; rewrite is_finite_Bopp; exact Fe).
    rewrite !compare_finite by assumption. rewrite compare_finite in H by assumption. cbn [compare_reals] in *.
    replace (val (Babs v)) with (Rabs (val v)) in H by (symmetry; apply B2R_Babs).
    replace (val (Bopp e)) with (- val e) by (symmetry; apply B2R_Bopp).
    revert H. case (Rlt_bool_spec (val e)); [|discriminate]. intros H _. destruct (Rle_or_lt 0 (val v)) as [P|P].
    + left. apply Rlt_bool_true. rewrite Rabs_pos_eq in H by exact P. exact H.
    + right. apply Rlt_bool_true. rewrite Rabs_left in H by exact P. lra.
  - destruct v as [[|]|[|]| |[|] m k F], e as [[|]|[|]| |[|] n l G]; try discriminate; auto.
  - destruct v as [[|]|[|]| |[|] m k F], e as [[|]|[|]| |[|] n l G]; try discriminate; auto.
  - destruct v as [[|]|[|]| |[|] m k F], e as [[|]|[|]| |[|] n l G]; try discriminate; auto.
Qed.

(* All four norms are in range where the tests say so of the least and the largest of a cell, and of the sample's. *)
Lemma sphere_range : forall y, (forall n, finite (y n)) ->
  let x n := on_doubles y (between with_sample n) in
  compare_doubles LessEqual (on_doubles x low) (on_doubles x smallest) = true ->
  compare_doubles LessEqual (on_doubles x largest) (on_doubles x high) = true ->
  compare_doubles LessEqual (on_doubles x low) (on_doubles x (norm 3)) = true ->
  compare_doubles LessEqual (on_doubles x (norm 3)) (on_doubles x high) = true ->
  are_in_range kSmallestNorm kLargestNorm 4 x.
Proof.
  intros y Fy x HL HH H3 H4.
  destruct (cell_range with_sample y Fy ltac:(vm_compute; reflexivity) HL HH) as [Norms _].
  intros k Hk. destruct (Nat.eq_dec k 3) as [->|N]; [split; assumption|]. apply Norms. lia.
Qed.

Theorem beyond_sphere_right : forall y, (forall n, finite (y n)) ->
  forall s, run (fun n => on_doubles y (between with_sample n)) Code.is_beyond_sphere = Some s ->
  dot (from_0 y 4) (from_0 y 4) * det (from_0 y 1) (from_0 y 2) (from_0 y 3) -
  dot (numerator (from_0 y 1) (from_0 y 2) (from_0 y 3)) (from_0 y 4) <> 0.
Proof.
  intros y Fy s H. set (x n := on_doubles y (between with_sample n)) in *.
  assert (E : Code.is_beyond_sphere =
    If LessEqual low smallest (If LessEqual largest high (If LessEqual low (norm 3) (If LessEqual (norm 3) high
      (If Less (replace norm outside_sphere_bound) (Abs (flatten outside_sphere)) (Answer (Some Positive)) (Answer
        None))
      (Answer None)) (Answer None)) (Answer None)) (Answer None)) by by_computation.
  rewrite E in H. cbn [run] in H.
  destruct (compare_doubles LessEqual (on_doubles x low) (on_doubles x smallest)) eqn:HL; [|discriminate].
  destruct (compare_doubles LessEqual (on_doubles x largest) (on_doubles x high)) eqn:HH; [|discriminate].
  destruct (compare_doubles LessEqual (on_doubles x low) (on_doubles x (norm 3))) eqn:H3; [|discriminate].
  destruct (compare_doubles LessEqual (on_doubles x (norm 3)) (on_doubles x high)) eqn:H4; [|discriminate].
  assert (Norms := sphere_range y Fy HL HH H3 H4). clear E HL HH H3 H4.
  set (e := replace norm outside_sphere_bound) in *. set (v := flatten outside_sphere) in *.
  assert (A : exists t, t <> Zero /\ run x (decided v e) = Some t).
  { cbn [on_doubles] in H. unfold decided. cbn [run on_doubles].
    destruct (compare_doubles Less (on_doubles x e) (Babs (on_doubles x v))) eqn:C; [|discriminate].
    destruct (compare_doubles Less (on_doubles x e) (on_doubles x v)) eqn:P;
      [exists Positive; split; [discriminate | reflexivity]|].
    destruct (size_above _ _ C) as [S|S]; [change (compare_doubles Less (on_doubles x e) (on_doubles x v) = true) in S;
      congruence|].
    exists Negative. change (compare_doubles Less (on_doubles x v) (Bopp (on_doubles x e)) = true) in S. rewrite S.
    split; [discriminate | reflexivity]. }
  destruct A as [t [T R]].
  apply (decided_right 4 kSmallestNorm kLargestNorm outside_sphere outside_sphere_bound
    (scaled_value kOutsideSphereBound)) in R; [| by_computation | by_computation | same_size | exact Norms].
  match goal with |- ?z <> 0 => assert (S : is_sign t z) by (same_polynomial R); revert S; generalize z end.
  intros z S. destruct t; cbn [is_sign] in S; [lra | congruence | lra].
Qed.
