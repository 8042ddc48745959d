(* OutsideCircle of src/geometry/predicates.h asks for the sum of two cotangents, and compares it at one coordinate of
   two cross products. For points of a plane, the sign at a coordinate is that of the sum. *)
From Coq Require Import Reals ZArith Lra Bool List.
From Flocq Require Import Core.
From Flowcert Require Import algebra.Vector3 code.Expression filters.RoundedVectors filters.Norms filters.Predicates.
From Flowcert Require code.generated.Predicates.
Module Code := code.generated.Predicates.
Import ListNotations.
Open Scope R_scope.

(* ---- Cross products with one edge ---- *)

Definition parallel a b := cross a b = vzero.

(* Of points in a plane, triangles over one edge have parallel normals. *)
Lemma normals_parallel : forall p0 p1 q r, det (vsub p1 p0) (vsub q p0) (vsub r p0) = 0 ->
  parallel (cross (vsub p0 q) (vsub p1 q)) (cross (vsub p0 r) (vsub p1 r)).
Proof.
  intros p0 p1 q r H. unfold parallel.
  replace (cross (cross (vsub p0 q) (vsub p1 q)) (cross (vsub p0 r) (vsub p1 r)))
    with (vscale (det (vsub p1 p0) (vsub q p0) (vsub r p0)) (vsub p1 p0)).
  - rewrite H. apply vec_eq; vunfold; ring.
  - clear. apply vec_eq; vdestruct; vunfold; ring.
Qed.

Lemma multiple_of_parallel : forall a b, parallel a b -> a <> vzero -> exists t, b = vscale t a.
Proof.
  intros a b H N. exists (dot a b / dot a a). assert (D : dot a a <> 0) by (intro E; apply N, dot_self_zero, E).
  assert (F : vsub (vscale (dot a b) a) (vscale (dot a a) b) = cross a (cross a b))
    by (clear; apply vec_eq; vdestruct; vunfold; ring).
  rewrite H in F. replace (cross a vzero) with vzero in F by (apply vec_eq; vunfold; ring).
  assert (E : vscale (dot a a) b = vscale (dot a b) a).
  { revert F. generalize (dot a b) (dot a a). clear. intros x y F. destruct a as [ax ay az], b as [bx by' bz].
    unfold vsub, vscale, vzero in *. cbn [vx vy vz] in *. injection F. intros. apply vec_eq; cbn [vx vy vz]; lra. }
  replace b with (vscale (/ dot a a) (vscale (dot a a) b)) at 1 by (apply vec_eq; cbn; field; exact D).
  rewrite E. apply vec_eq; cbn; field; exact D.
Qed.

(* ---- One coordinate stands for the length ---- *)

Lemma sign_of_multiple : forall s k x y, s <> Zero -> 0 <= k -> 0 < len y -> is_sign s (k * x) ->
  is_sign s (len y * x).
Proof.
  intros s k x y S K L H. destruct s; cbn [is_sign] in *; [| congruence |].
  - assert (x < 0) by (destruct (Rle_or_lt 0 x) as [P|P]; [|exact P]; generalize (Rmult_le_pos _ _ K P); lra).
    rewrite Rmult_comm. replace 0 with (0 * len y) by ring. apply Rmult_lt_compat_r; assumption.
  - assert (0 < x).
    { destruct (Rle_or_lt x 0) as [P|P]; [|exact P].
      assert (0 <= k * - x) by (apply Rmult_le_pos; lra). lra. }
    apply Rmult_lt_0_compat; assumption.
Qed.

Lemma coordinate_of_multiple : forall part, In part [vx; vy; vz] -> forall t a,
  Rabs (part (vscale t a)) = Rabs t * Rabs (part a).
Proof. intros part [<-|[<-|[<-|[]]]] t a; cbn; apply Rabs_mult. Qed.
Lemma coordinate_of_zero : forall part, In part [vx; vy; vz] -> part vzero = 0.
Proof. intros part [<-|[<-|[<-|[]]]]; reflexivity. Qed.

(* Both are multiples of one vector that is not zero, unless both are zero. *)
Lemma multiples_of_one : forall a b, parallel a b ->
  (a = vzero /\ b = vzero) \/ exists n r s, n <> vzero /\ a = vscale r n /\ b = vscale s n.
Proof.
  assert (One : forall n, vscale 1 n = n) by (intro n; apply vec_eq; cbn; ring).
  assert (None : forall n, vscale 0 n = vzero) by (intro n; apply vec_eq; cbn; ring).
  assert (D : forall v, v = vzero \/ v <> vzero).
  { intros [x y z]. destruct (Req_EM_T x 0), (Req_EM_T y 0), (Req_EM_T z 0); subst; try (left; reflexivity);
      right; intro E; injection E; intros; contradiction. }
  intros a b P. destruct (D a) as [->|N].
  - destruct (D b) as [->|N]; [left; split; reflexivity|].
    right. exists b, 0, 1. rewrite One, None. repeat split; exact N.
  - right. destruct (multiple_of_parallel a b P N) as [t E]. exists a, 1, t. rewrite One. repeat split; assumption.
Qed.
Lemma len_positive : forall v, v <> vzero -> 0 < len v.
Proof.
  intros v N. destruct (Rle_lt_or_eq_dec 0 (len v) (len_nonneg v)) as [L|L]; [exact L|]. exfalso. apply N.
  apply dot_self_zero. rewrite <- len_sq, <- L. ring.
Qed.

Theorem coordinate_tells : forall s part at_q at_r dq dr, s <> Zero -> In part [vx; vy; vz] -> parallel at_q at_r ->
  is_sign s (dq * Rabs (part at_r) + dr * Rabs (part at_q)) -> is_sign s (dq * len at_r + dr * len at_q).
Proof.
  intros s part at_q at_r dq dr S P Par H. destruct (multiples_of_one at_q at_r Par) as [[-> ->]|[n [a [b [N [->
    ->]]]]]].
  - rewrite (coordinate_of_zero part P), Rabs_R0, !Rmult_0_r, Rplus_0_r in H. destruct s; cbn [is_sign] in H;
      [lra | congruence | lra].
  - rewrite !(coordinate_of_multiple part P) in H. rewrite !len_scale_any.
    replace (dq * (Rabs b * len n) + dr * (Rabs a * len n)) with (len n * (dq * Rabs b + dr * Rabs a)) by ring.
    apply (sign_of_multiple s (Rabs (part n))); [exact S | apply Rabs_pos | apply len_positive, N|].
    replace (Rabs (part n) * (dq * Rabs b + dr * Rabs a))
      with (dq * (Rabs b * Rabs (part n)) + dr * (Rabs a * Rabs (part n))) by ring. exact H.
Qed.

(* ---- The filter ---- *)

Fixpoint never_zero (t : tree (option sign)) : bool :=
  match t with
  | Answer (Some Zero) => false
  | Answer _ => true
  | If _ _ _ yes no => never_zero yes && never_zero no
  end.
Lemma run_never_zero : forall x t s, never_zero t = true -> run x t = Some s -> s <> Zero.
Proof.
  intros x t s. induction t as [a|r a b yes IHy no IHn]; cbn [never_zero run]; intros N H.
  - rewrite H in N. destruct s; [discriminate | discriminate N | discriminate].
  - rewrite andb_true_iff in N. destruct (compare_doubles r _ _); [apply IHy | apply IHn]; tauto.
Qed.

(* The cotangent of the angle at q is the dot product over the cross product's length, so that this is the sum of the
   cotangents at q and at r times both lengths. *)
Theorem outside_circle_cotangents : forall y s, run y Code.OutsideCircle.sign = Some s ->
  let p0 := at_point y 0 in let p1 := at_point y 1 in let q := at_point y 2 in let r := at_point y 3 in
  det (vsub p1 p0) (vsub q p0) (vsub r p0) = 0 ->
  is_sign s (dot (vsub p0 q) (vsub p1 q) * len (cross (vsub p0 r) (vsub p1 r)) +
             dot (vsub p0 r) (vsub p1 r) * len (cross (vsub p0 q) (vsub p1 q))).
Proof.
  intros y s H p0 p1 q r Flat. destruct (outside_circle_right y s H) as [part [P S]].
  apply (coordinate_tells s part); [| exact P | apply normals_parallel, Flat | exact S].
  apply (run_never_zero y Code.OutsideCircle.sign s); [vm_compute; reflexivity | exact H].
Qed.
