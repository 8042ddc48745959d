(* The algebra of one step of a cascade (spec/cascades.md, "Crossing a facet"; src/flow/kernels/direction_across.h). *)
From Coq Require Import Reals Lra.
From Flowcert Require Import algebra.Vector3.
Open Scope R_scope.

(* No Section with vec variables: destruct never clears them, and vdestruct would not end. *)
Definition bisector_g p0 p1 q := vadd (vsub q p0) (vsub q p1).
Definition h p0 p1 q := dot (vsub q p0) (vsub q p1).
Definition A p0 p1 q U := dot U (bisector_g p0 p1 q).
(* Where the ray from the midpoint along U is as far from q as from p0 and p1. *)
Definition exit_point p0 p1 q U := vadd (midpoint p0 p1) (vscale (h p0 p1 q / A p0 p1 q U) U).

Theorem exit_equidistant_p0_p1 : forall p0 p1 q U,
  dot U (vsub p1 p0) = 0 ->
  dist2 (exit_point p0 p1 q U) p0 = dist2 (exit_point p0 p1 q U) p1.
Proof.
  intros p0 p1 q U HU. unfold exit_point. generalize (h p0 p1 q / A p0 p1 q U). intros s.
  assert (F : dist2 (vadd (midpoint p0 p1) (vscale s U)) p0 - dist2 (vadd (midpoint p0 p1) (vscale s U)) p1
              = 2 * s * dot U (vsub p1 p0)).
  { clear; vdestruct; vunfold; field. }
  rewrite HU in F. lra.
Qed.

Theorem exit_equidistant_q : forall p0 p1 q U,
  dot U (vsub p1 p0) = 0 -> A p0 p1 q U <> 0 ->
  dist2 (exit_point p0 p1 q U) p0 = dist2 (exit_point p0 p1 q U) q.
Proof.
  intros p0 p1 q U HU HA.
  assert (E : (h p0 p1 q / A p0 p1 q U) * A p0 p1 q U = h p0 p1 q) by (field; exact HA).
  unfold exit_point. revert E. generalize (h p0 p1 q / A p0 p1 q U). intros s E.
  assert (F : dist2 (vadd (midpoint p0 p1) (vscale s U)) p0 - dist2 (vadd (midpoint p0 p1) (vscale s U)) q
              = s * A p0 p1 q U - h p0 p1 q + s * dot U (vsub p1 p0)).
  { unfold A, h, bisector_g; clear; vdestruct; vunfold; field. }
  rewrite HU in F. lra.
Qed.

(* The next direction, before it is normalized: A D + 2 h U. *)
Definition D p0 p1 k0 k1 := vsub (vadd p0 p1) (vadd k0 k1).
Definition step p0 p1 q U k0 k1 := vadd (vscale (A p0 p1 q U) (D p0 p1 k0 k1)) (vscale (2 * h p0 p1 q) U).

Theorem step_is_crossing : forall p0 p1 q U k0 k1, A p0 p1 q U <> 0 ->
  step p0 p1 q U k0 k1 = vscale (2 * A p0 p1 q U) (vsub (exit_point p0 p1 q U) (midpoint k0 k1)).
Proof.
  intros p0 p1 q U k0 k1. unfold step, exit_point, D.
  generalize (A p0 p1 q U) (h p0 p1 q). clear. intros c k Hc.
  apply vec_eq; unfold vscale, vadd, vsub, midpoint; simpl; field; exact Hc.
Qed.

(* The multiple of the step that has the sign of A is a positive multiple of the way from the next midpoint to the
   exit. *)
Theorem step_direction : forall p0 p1 q U k0 k1, A p0 p1 q U <> 0 ->
  exists c, 0 < c /\
    vscale (if Rlt_dec (A p0 p1 q U) 0 then -1 else 1) (step p0 p1 q U k0 k1)
    = vscale c (vsub (exit_point p0 p1 q U) (midpoint k0 k1)).
Proof.
  intros p0 p1 q U k0 k1 HA. exists (2 * Rabs (A p0 p1 q U)). split.
  - generalize (Rabs_pos_lt _ HA); lra.
  - rewrite step_is_crossing by exact HA. unfold Rabs.
    destruct (Rcase_abs (A p0 p1 q U)), (Rlt_dec (A p0 p1 q U) 0); try lra;
    apply vec_eq; unfold vscale; simpl; ring.
Qed.

(* Why the exit is as far from k0 and k1: all corners of the polygon lie on one circle, and the exit is as far from
   three of them that are not on a line. *)
Theorem cocircular_equidistant : forall x z p0 p1 q k s t,
  (* k lies in the plane of p0, p1, q *)
  vsub k p0 = vadd (vscale s (vsub p1 p0)) (vscale t (vsub q p0)) ->
  (* z is a point as far from all four *)
  dist2 z p0 = dist2 z p1 -> dist2 z p0 = dist2 z q -> dist2 z p0 = dist2 z k ->
  dist2 x p0 = dist2 x p1 -> dist2 x p0 = dist2 x q -> dist2 x p0 = dist2 x k.
Proof.
  intros x z p0 p1 q k s t K Z1 Z2 Z3 X1 X2.
  (* x - z is orthogonal to p1 - p0 and to q - p0, so also to k - p0 *)
  assert (P : forall r, dot (vsub x z) (vsub r p0)
                        = / 2 * ((dist2 x p0 - dist2 x r) - (dist2 z p0 - dist2 z r))).
  { clear; intros; vdestruct; vunfold; field. }
  assert (O1 : dot (vsub x z) (vsub p1 p0) = 0) by (rewrite P, Z1, X1; ring).
  assert (O2 : dot (vsub x z) (vsub q p0) = 0) by (rewrite P, Z2, X2; ring).
  assert (O3 : dot (vsub x z) (vsub k p0) = 0).
  { rewrite K. replace (dot (vsub x z) _) with
      (s * dot (vsub x z) (vsub p1 p0) + t * dot (vsub x z) (vsub q p0)).
    - rewrite O1, O2; ring.
    - clear; vdestruct; vunfold; ring. }
  rewrite P, Z3 in O3. lra.
Qed.

(* So the new direction lies in the plane of the next facet. *)
Theorem step_in_next_facet : forall p0 p1 q U k0 k1,
  A p0 p1 q U <> 0 ->
  dist2 (exit_point p0 p1 q U) k0 = dist2 (exit_point p0 p1 q U) k1 ->
  dot (step p0 p1 q U k0 k1) (vsub k1 k0) = 0.
Proof.
  intros p0 p1 q U k0 k1 HA Hx. rewrite step_is_crossing by exact HA.
  revert Hx. generalize (exit_point p0 p1 q U) (A p0 p1 q U). clear. intros x c Hx.
  assert (F : dot (vscale (2 * c) (vsub x (midpoint k0 k1))) (vsub k1 k0) = c * (dist2 x k0 - dist2 x k1)).
  { clear; vdestruct; vunfold; field. }
  rewrite F, Hx. ring.
Qed.
