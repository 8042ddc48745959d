(* The side of a facet on which the centre lies (FC-SIGN-03; SideOfPlane in src/geometry/predicates.h). *)
From Coq Require Import Reals Lra.
From Flowcert Require Import algebra.Vector3.
Open Scope R_scope.

(* The tetrahedron 0, a, b, c. *)
Definition numerator a b c :=
  vadd (vscale (dot a a) (cross b c)) (vadd (vscale (dot b b) (cross c a)) (vscale (dot c c) (cross a b))).
Definition centre a b c := vscale (/ (2 * det a b c)) (numerator a b c).

Theorem centre_equidistant : forall a b c, det a b c <> 0 ->
  dist2 (centre a b c) vzero = dist2 (centre a b c) a /\
  dist2 (centre a b c) vzero = dist2 (centre a b c) b /\
  dist2 (centre a b c) vzero = dist2 (centre a b c) c.
Proof.
  intros a b c Hd.
  assert (N : dot (numerator a b c) a = dot a a * det a b c /\
              dot (numerator a b c) b = dot b b * det a b c /\
              dot (numerator a b c) c = dot c c * det a b c).
  { unfold numerator; vdestruct; vunfold; repeat split; ring. }
  destruct N as [N1 [N2 N3]].
  assert (S : forall p k, 2 * (/ (2 * k)) * (dot p p * k) = dot p p \/ k = 0).
  { intros p k. destruct (Req_dec k 0); [right; assumption | left; field; assumption]. }
  assert (E : forall k n p, dist2 (vscale k n) vzero - dist2 (vscale k n) p = 2 * k * dot n p - dot p p).
  { intros; vdestruct; vunfold; ring. }
  unfold centre.
  repeat split; apply Rminus_diag_uniq; rewrite E, ?N1, ?N2, ?N3; field; exact Hd.
Qed.

(* The code's polynomial <a x b, numerator> has the sign of (height of the centre) times (height of c) over the plane
   of 0, a, b: positive where both lie on one side. *)
Theorem side_polynomial : forall a b c, det a b c <> 0 ->
  dot (cross a b) (centre a b c) * dot (cross a b) c = / 2 * dot (cross a b) (numerator a b c).
Proof.
  intros a b c Hd. unfold centre.
  replace (dot (cross a b) c) with (det a b c) by (vdestruct; vunfold; ring).
  replace (dot (cross a b) (vscale (/ (2 * det a b c)) (numerator a b c)))
    with (/ (2 * det a b c) * dot (cross a b) (numerator a b c)) by (unfold dot, vscale; simpl; ring).
  field. exact Hd.
Qed.

(* z: the centre of the circle through three points of a facet; o: the centre of the sphere, over z along the normal n;
   the facet's point p and the opposite vertex q both lie on the sphere. *)
Theorem side_is_outside_smallest_sphere : forall z n t p q,
  let o := vadd z (vscale t n) in
  dot (vsub p z) n = 0 ->             (* p lies in the facet's plane *)
  0 < dot (vsub q z) n ->             (* q lies on the side of n *)
  dist2 o p = dist2 o q ->
  dist2 q z - dist2 p z = 2 * t * dot (vsub q z) n.
Proof.
  intros z n t p q o Hp Hq E.
  assert (F : dist2 q z - dist2 p z - 2 * t * dot (vsub q z) n
              = dist2 o q - dist2 o p - 2 * t * dot (vsub p z) n).
  { unfold o; clear; vdestruct; vunfold; ring. }
  rewrite Hp, E in F. lra.
Qed.

Corollary side_sign : forall z n t p q,
  let o := vadd z (vscale t n) in
  dot (vsub p z) n = 0 -> 0 < dot (vsub q z) n -> dist2 o p = dist2 o q ->
  (0 < t <-> dist2 p z < dist2 q z) /\ (t = 0 <-> dist2 p z = dist2 q z) /\ (t < 0 <-> dist2 q z < dist2 p z).
Proof.
  intros z n t p q o Hp Hq E.
  generalize (side_is_outside_smallest_sphere z n t p q Hp Hq E). intro F.
  set (k := dot (vsub q z) n) in *. clearbody k. repeat split; intros; nra.
Qed.

(* The s of the facet opposite vertex 0: 2 det^2 minus the other three (tetrahedron_forms.h). *)
Theorem far_side : forall a b c,
  2 * (det a b c * det a b c) - dot (cross b c) (numerator a b c) - dot (cross c a) (numerator a b c)
    - dot (cross a b) (numerator a b c)
  = dot (cross (vsub b a) (vsub c a)) (vsub (vscale (2 * det a b c) a) (numerator a b c)).
Proof. intros. unfold numerator. vdestruct; vunfold. ring. Qed.
