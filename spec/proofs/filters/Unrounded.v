(* Predicates of points that are multiples of a power of two, and near to one another: unrounded_sign() of
   src/geometry/predicates.h, as it is generated. An answer is the sign of the exact polynomial, zero too, because
   nothing was rounded (filters/Exact.v). Variable 15 is the reach. *)
From Coq Require Import Reals ZArith Lra Lia Bool List.
From Flocq Require Import Core BinarySingleNaN.
From Flowcert Require Import algebra.Vector3 algebra.Tetrahedron code.Expression code.generated.Constants
  filters.Doubles filters.Terms filters.Filter filters.Predicates filters.Cells filters.Exact.
From Flowcert Require code.generated.Predicates.
Module Code := code.generated.Predicates.
Import ListNotations.
Open Scope R_scope.

Fixpoint near_tests (norms : list expr) (rest : tree (option sign)) : tree (option sign) :=
  match norms with
  | [] => rest
  | n :: others => If LessEqual low n (If LessEqual n high (If LessEqual n (Var 15)
      (near_tests others rest) (Answer None)) (Answer None)) (Answer None)
  end.
Definition sign_tree value : tree (option sign) :=
  If Less (Cst 0 0) value (Answer (Some Positive)) (If Less value (Cst 0 0) (Answer (Some Negative))
    (Answer (Some Zero))).
Definition or_reach pairs n := if (n =? 15)%nat then Var 15 else between pairs n.
Definition unrounded count pairs decision :=
  replace_in_tree (or_reach pairs) (near_tests (map norm (seq 0 count)) decision).

Lemma run_same : forall A x y (t : tree A), (forall n, x n = y n) -> run x t = run y t.
Proof.
  induction t; intro H; cbn [run]; [reflexivity|].
  rewrite (on_doubles_same x y a H), (on_doubles_same x y b H), IHt1, IHt2 by exact H. reflexivity.
Qed.

Lemma run_near_tests : forall x rest s norms, run x (near_tests norms rest) = Some s ->
  (forall e, In e norms -> is_in_range kSmallestNorm kLargestNorm x e /\
                           compare_doubles LessEqual (on_doubles x e) (x 15%nat) = true) /\
  run x rest = Some s.
Proof.
  induction norms as [|e norms IH]; cbn [near_tests run]; intro H; [split; [intros e [] | exact H]|].
  destruct (compare_doubles LessEqual (on_doubles x low) (on_doubles x e)) eqn:A; [|discriminate].
  destruct (compare_doubles LessEqual (on_doubles x e) (on_doubles x high)) eqn:B; [|discriminate].
  destruct (compare_doubles LessEqual (on_doubles x e) (on_doubles x (Var 15))) eqn:C; [|discriminate].
  destruct (IH H) as [I1 I2]. split; [|exact I2]. intros f [<-|F]; [split; [split; assumption | exact C] | auto].
Qed.

Lemma run_sign_tree : forall x value s, finite (on_doubles x value) -> run x (sign_tree value) = Some s ->
  is_sign s (val (on_doubles x value)).
Proof.
  intros x value s F. assert (FZ : finite (on_doubles x (Cst 0 0))) by reflexivity.
  assert (Z : val (on_doubles x (Cst 0 0)) = 0) by reflexivity.
  unfold sign_tree. cbn [run]. rewrite !compare_finite by assumption. rewrite Z. cbn [compare_reals].
  case Rlt_bool_spec; intro P; [intro H; injection H; intro; subst s; exact P|].
  case Rlt_bool_spec; intro N; intro H; injection H; intro; subst s; cbn [is_sign]; lra.
Qed.

Section Unrounded.
Variables (g : Z) (y : nat -> double) (reach : double) (count : nat) (pairs : list (nat * nat)).
Hypothesis grid : points_on_grid g y.
Hypothesis is_reach_of_grid : is_reach g reach.
Hypothesis few_vectors : (count <=? 5)%nat = true.
Hypothesis few_points : forallb (fun pair => (fst pair <? 5) && (snd pair <? 5))%nat pairs = true.
Let x n := on_doubles y (between pairs n).

Lemma ends_below : forall n, (fst (ends pairs n) < 5 /\ snd (ends pairs n) < 5)%nat.
Proof.
  intro n. unfold ends. destruct (nth_in_or_default (n / 3) pairs (0, 0)%nat) as [I| ->]; [|cbn; lia].
  rewrite forallb_forall in few_points. apply few_points in I. rewrite andb_true_iff, !Nat.ltb_lt in I. exact I.
Qed.
Lemma vectors_with_reach : forall n, on_doubles (with_reach reach y) (or_reach pairs n) = with_reach reach x n.
Proof.
  intro n. unfold or_reach, with_reach, x. destruct (Nat.eqb_spec n 15) as [->|N]; [reflexivity|].
  destruct (ends_below n) as [A B]. assert (M := Nat.mod_upper_bound n 3 ltac:(discriminate)).
  unfold between. cbn [on_doubles].
  destruct (Nat.eqb_spec (3 * snd (ends pairs n) + n mod 3) 15); [lia|].
  destruct (Nat.eqb_spec (3 * fst (ends pairs n) + n mod 3) 15); [lia|]. reflexivity.
Qed.

Lemma norm_variables : forall k, (k < 5)%nat -> has_variables_below 15 (norm k) = true.
Proof. intros k K. do 5 (destruct k as [|k]; [reflexivity|]). lia. Qed.

(* The value of each of these forms has the sign that its part of the tree answers. *)
Theorem unrounded_back : forall decision s, run (with_reach reach y) (unrounded count pairs decision) = Some s ->
  run (with_reach reach x) decision = Some s /\
  forall value, is_exact_form count value = true -> run (with_reach reach x) (sign_tree (flatten value)) = Some s ->
    is_sign s (exact (exact_between pairs y) (flatten value)).
Proof.
  intros decision s H. unfold unrounded in H. rewrite run_replace in H.
  rewrite (run_same _ _ _ _ vectors_with_reach) in H. apply run_near_tests in H. destruct H as [Norms H].
  split; [exact H|]. clear H. intros value V H. apply Nat.leb_le in few_vectors.
  assert (Near : forall k, (k < count)%nat -> is_in_range kSmallestNorm kLargestNorm x (norm k) /\
    compare_doubles LessEqual (on_doubles x (norm k)) reach = true).
  { intros k K. destruct (Norms (norm k)) as [[A B] C]; [apply in_map, in_seq; lia|].
    assert (N := norm_variables k ltac:(lia)). rewrite (without_reach reach x (norm k) N) in A, B, C.
    split; [split; [exact A | exact B] | exact C]. }
  destruct (exact_form g y pairs count grid) with (value := value) as [F E].
  - intros k K. apply Near, K.
  - intros k K. apply (near_reach g x reach _ is_reach_of_grid); apply Near, K.
  - exact V.
  - fold x in F, E. rewrite <- E. unfold is_exact_form in V. rewrite !andb_true_iff in V.
    destruct V as [[[[_ V] _] _] _].
    assert (B : has_variables_below 15 (flatten value) = true).
    { revert V. generalize (flatten value). intro e. assert (L : (3 * count <= 15)%nat) by lia. clear - L.
      induction e; cbn [has_variables_below]; rewrite ?andb_true_iff, ?Nat.ltb_lt; intuition lia. }
    assert (S := without_reach reach x (flatten value) B). rewrite <- S. apply run_sign_tree; [|exact H].
    rewrite S. exact F.
Qed.
End Unrounded.

Theorem unrounded_orientation_right : forall g y reach s, points_on_grid g y -> is_reach g reach ->
  run (with_reach reach y) Code.Orientation.unrounded_sign = Some s ->
  is_sign s (det (from_0 y 1) (from_0 y 2) (from_0 y 3)).
Proof.
  intros g y reach s G R H. set (pairs := [(0, 1); (0, 2); (0, 3)]%nat).
  assert (E : Code.Orientation.unrounded_sign = unrounded 3 pairs (sign_tree (flatten orientation)))
    by by_computation.
  rewrite E in H. apply (unrounded_back g y reach 3 pairs G R eq_refl eq_refl) in H. destruct H as [H V].
  apply V in H; [exact H | by_computation].
Qed.

Theorem unrounded_sphere_right : forall g y reach s, points_on_grid g y -> is_reach g reach ->
  run (with_reach reach y) Code.OutsideSphere.unrounded_sign = Some s ->
  is_sign s (dot (from_0 y 4) (from_0 y 4) * det (from_0 y 1) (from_0 y 2) (from_0 y 3) -
             dot (numerator (from_0 y 1) (from_0 y 2) (from_0 y 3)) (from_0 y 4)).
Proof.
  intros g y reach s G R H. set (pairs := [(0, 1); (0, 2); (0, 3); (0, 4)]%nat).
  assert (E : Code.OutsideSphere.unrounded_sign = unrounded 4 pairs (sign_tree (flatten outside_sphere)))
    by by_computation.
  rewrite E in H. apply (unrounded_back g y reach 4 pairs G R eq_refl eq_refl) in H. destruct H as [H V].
  apply V in H; [|by_computation]. unfold pairs in H. same_polynomial H.
Qed.

Theorem unrounded_circle_right : forall g y reach s, points_on_grid g y -> is_reach g reach ->
  run (with_reach reach y) Code.OutsideCircle.unrounded_sign = Some s ->
  let p0 := at_point y 0 in let p1 := at_point y 1 in let q := at_point y 2 in let r := at_point y 3 in
  let at_q := cross (vsub p0 q) (vsub p1 q) in let at_r := cross (vsub p0 r) (vsub p1 r) in
  exists part, In part [vx; vy; vz] /\
  is_sign s (dot (vsub p0 q) (vsub p1 q) * Rabs (part at_r) + dot (vsub p0 r) (vsub p1 r) * Rabs (part at_q)).
Proof.
  intros g y reach s G R H p0 p1 q r at_q at_r.
  set (decision i := sign_tree (flatten (outside_circle i))).
  set (size_at_q i := flatten (Size (Part i (Cross a b)))).
  assert (E : Code.OutsideCircle.unrounded_sign = unrounded 4 outside_circle_pairs
    (If LessEqual (size_at_q 1%nat) (size_at_q 0%nat)
      (If LessEqual (size_at_q 2%nat) (size_at_q 0%nat) (decision 0%nat)
        (If LessEqual (size_at_q 2%nat) (size_at_q 1%nat) (decision 1%nat) (decision 2%nat)))
      (If LessEqual (size_at_q 2%nat) (size_at_q 1%nat) (decision 1%nat) (decision 2%nat)))) by by_computation.
  rewrite E in H. apply (unrounded_back g y reach 4 outside_circle_pairs G R eq_refl eq_refl) in H.
  destruct H as [H V]. set (x := with_reach reach (fun n => on_doubles y (between outside_circle_pairs n))) in *.
  assert (D : exists i, (i < 3)%nat /\ run x (decision i) = Some s).
  { cbn [run] in H. clearbody decision size_at_q x.
    repeat match type of H with (if ?e then _ else _) = _ => destruct e end;
      [exists 0%nat | exists 1%nat | exists 2%nat | exists 1%nat | exists 2%nat]; (split; [lia | exact H]). }
  destruct D as [i [Hi D]]. apply V in D.
  - destruct i as [|[|[|i]]]; [exists vx | exists vy | exists vz | lia];
      (split; [cbn; tauto|]); unfold at_q, at_r, p0, p1, q, r; same_polynomial D.
  - destruct i as [|[|[|i]]]; [by_computation | by_computation | by_computation | lia].
Qed.
