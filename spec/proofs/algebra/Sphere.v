(* The sphere through the corners of a simplex, and whether a point is outside of it (FC-CERT-02, T3; FC-CERT-03).
   The certificate's checkers compute one of two polynomials: the volume of the cell lifted to the paraboloid around the
   point (outside_sphere in spec/proof.py), or one that has the numerator and the denominator of the sphere's centre
   (side_of_sphere in oracle/proof/points.h, outside in spec/proof.py, OutsideSphere in src/geometry/predicates.h).
   Both are the cell's volume, or the centre's denominator, times the power of the point to the sphere. So where that
   factor is positive, they are positive, zero and negative outside of the sphere, on it and inside. *)
From Coq Require Import Reals Lra Lia List.
From Flowcert Require Import algebra.Vector3 algebra.Tetrahedron.
Open Scope R_scope.

(* The power of x to the sphere around z with the squared radius r2. *)
Definition power z r2 x := dist2 z x - r2.
Definition on_sphere z r2 C := forall p, In p C -> power z r2 p = 0.
Lemma on_sphere_at : forall z r2 C p, on_sphere z r2 C -> In p C -> dist2 z p = r2.
Proof. intros z r2 C p S H. apply Rminus_diag_uniq, S, H. Qed.

(* The sign of v tells where x is: outside of the sphere around z through p, on it, or inside. *)
Definition tells v z p x :=
  (0 < v <-> dist2 z p < dist2 z x) /\ (v = 0 <-> dist2 z x = dist2 z p) /\ (v < 0 <-> dist2 z x < dist2 z p).

Lemma multiple_tells : forall k v z p x, 0 < k -> v = k * power z (dist2 z p) x -> tells v z p x.
Proof. unfold tells, power. intros k v z p x Hk E. repeat split; intros; nra. Qed.

(* ---- The cell lifted to the paraboloid around the point ---- *)

(* In a plane or on a line, m is the vector of an axis or its opposite, so that the first cell has positive volume. *)
Definition volume_in_space p0 p1 p2 p3 := det (vsub p1 p0) (vsub p2 p0) (vsub p3 p0).
Definition volume_in_plane m p0 p1 p2 := dot m (cross (vsub p1 p0) (vsub p2 p0)).
Definition volume_on_line m p0 p1 := dot m (vsub p1 p0).

Definition lifted_in_space p0 p1 p2 p3 x :=
  let a := vsub p0 x in let b := vsub p1 x in let c := vsub p2 x in let d := vsub p3 x in
  - dot a a * det b c d + dot b b * det a c d - dot c c * det a b d + dot d d * det a b c.
Definition lifted_in_plane m p0 p1 p2 x :=
  let a := vsub p0 x in let b := vsub p1 x in let c := vsub p2 x in
  - dot a a * dot m (cross b c) + dot b b * dot m (cross a c) - dot c c * dot m (cross a b).
Definition lifted_on_line m p0 p1 x :=
  let a := vsub p0 x in let b := vsub p1 x in - dot a a * dot m b + dot b b * dot m a.

(* The squares of the vectors from x to points of the sphere are all equal, up to a linear function of the vector. *)
Lemma lift_on_sphere : forall z p q x, dist2 z q = dist2 z p ->
  dot (vsub q x) (vsub q x) = 2 * dot (vsub z x) (vsub q x) - power z (dist2 z p) x.
Proof.
  intros z p q x E. unfold power. rewrite <- E. clear E. vdestruct; vunfold; ring.
Qed.

Theorem lifted_in_space_power : forall p0 p1 p2 p3 z x,
  dist2 z p1 = dist2 z p0 -> dist2 z p2 = dist2 z p0 -> dist2 z p3 = dist2 z p0 ->
  lifted_in_space p0 p1 p2 p3 x = volume_in_space p0 p1 p2 p3 * power z (dist2 z p0) x.
Proof.
  intros p0 p1 p2 p3 z x E1 E2 E3. unfold lifted_in_space. cbv zeta.
  rewrite (lift_on_sphere z p0 p0), (lift_on_sphere z p0 p1), (lift_on_sphere z p0 p2), (lift_on_sphere z p0 p3)
    by auto.
  generalize (power z (dist2 z p0) x). clear. intros. unfold volume_in_space. vdestruct; vunfold; ring.
Qed.

(* x lies in the plane of the cell. *)
Theorem lifted_in_plane_power : forall m p0 p1 p2 z x,
  dist2 z p1 = dist2 z p0 -> dist2 z p2 = dist2 z p0 -> det (vsub p0 x) (vsub p1 x) (vsub p2 x) = 0 ->
  lifted_in_plane m p0 p1 p2 x = volume_in_plane m p0 p1 p2 * power z (dist2 z p0) x.
Proof.
  intros m p0 p1 p2 z x E1 E2 F. unfold lifted_in_plane. cbv zeta.
  rewrite (lift_on_sphere z p0 p0), (lift_on_sphere z p0 p1), (lift_on_sphere z p0 p2) by auto.
  generalize (power z (dist2 z p0) x). intros k.
  transitivity (volume_in_plane m p0 p1 p2 * k
                - 2 * dot m (vsub z x) * det (vsub p0 x) (vsub p1 x) (vsub p2 x)); [|rewrite F; ring].
  clear. unfold volume_in_plane. vdestruct; vunfold; ring.
Qed.

(* x lies on the line of the cell. *)
Theorem lifted_on_line_power : forall m p0 p1 z x,
  dist2 z p1 = dist2 z p0 -> cross (vsub p0 x) (vsub p1 x) = vzero ->
  lifted_on_line m p0 p1 x = volume_on_line m p0 p1 * power z (dist2 z p0) x.
Proof.
  intros m p0 p1 z x E1 F. unfold lifted_on_line. cbv zeta.
  rewrite (lift_on_sphere z p0 p0), (lift_on_sphere z p0 p1) by auto.
  generalize (power z (dist2 z p0) x). intros k.
  transitivity (volume_on_line m p0 p1 * k
                + 2 * dot (cross m (vsub z x)) (cross (vsub p0 x) (vsub p1 x))).
  - clear. unfold volume_on_line. vdestruct; vunfold; ring.
  - rewrite F. clear. vdestruct; vunfold; ring.
Qed.

(* If the cell has positive volume, the sign tells where the point is. *)
Corollary lifted_in_space_tells : forall p0 p1 p2 p3 z x,
  dist2 z p1 = dist2 z p0 -> dist2 z p2 = dist2 z p0 -> dist2 z p3 = dist2 z p0 ->
  0 < volume_in_space p0 p1 p2 p3 -> tells (lifted_in_space p0 p1 p2 p3 x) z p0 x.
Proof. intros. eapply multiple_tells; eauto using lifted_in_space_power. Qed.
Corollary lifted_in_plane_tells : forall m p0 p1 p2 z x,
  dist2 z p1 = dist2 z p0 -> dist2 z p2 = dist2 z p0 -> det (vsub p0 x) (vsub p1 x) (vsub p2 x) = 0 ->
  0 < volume_in_plane m p0 p1 p2 -> tells (lifted_in_plane m p0 p1 p2 x) z p0 x.
Proof. intros. eapply multiple_tells; eauto using lifted_in_plane_power. Qed.
Corollary lifted_on_line_tells : forall m p0 p1 z x,
  dist2 z p1 = dist2 z p0 -> cross (vsub p0 x) (vsub p1 x) = vzero ->
  0 < volume_on_line m p0 p1 -> tells (lifted_on_line m p0 p1 x) z p0 x.
Proof. intros. eapply multiple_tells; eauto using lifted_on_line_power. Qed.

(* ---- The centre's numerator and denominator ---- *)

(* The edge, the triangle and the tetrahedron have one corner at 0, and the others at a, b, c. *)
Definition edge_sphere (a : vec) : vec * R := (a, 1).
Definition triangle_sphere a b : vec * R :=
  (vadd (vscale (dot a a) (cross b (cross a b))) (vscale (dot b b) (cross (cross a b) a)),
   dot (cross a b) (cross a b)).
Definition tetrahedron_sphere a b c : vec * R := (numerator a b c, dot (cross a b) c).

(* The corner at 0 is moved to p0. *)
Definition centre_at p0 (s : vec * R) := vadd p0 (vscale (/ (2 * snd s)) (fst s)).
Definition side_of_sphere (s : vec * R) p0 x :=
  let y := vsub x p0 in snd s * dot y y - dot (fst s) y.

Lemma side_power : forall s p0 x, snd s <> 0 ->
  side_of_sphere s p0 x = snd s * power (centre_at p0 s) (dist2 (centre_at p0 s) p0) x.
Proof.
  intros [n k] p0 x Hk. unfold side_of_sphere, power, centre_at; simpl in *.
  transitivity (k * dot (vsub x p0) (vsub x p0) - 2 * k * / (2 * k) * dot n (vsub x p0)).
  - field. exact Hk.
  - generalize (/ (2 * k)). clear. intros. vdestruct; vunfold; ring.
Qed.
Lemma on_sphere_of_side : forall s p0 p, snd s <> 0 -> side_of_sphere s p0 p = 0 ->
  dist2 (centre_at p0 s) p = dist2 (centre_at p0 s) p0.
Proof.
  intros s p0 p Hk H. rewrite side_power in H by exact Hk. unfold power in H.
  apply Rmult_integral in H. destruct H; [contradiction | lra].
Qed.
Lemma side_tells : forall s p0 x, 0 < snd s -> tells (side_of_sphere s p0 x) (centre_at p0 s) p0 x.
Proof. intros. eapply multiple_tells; [eassumption|]. apply side_power. lra. Qed.

(* The ball is the smallest one around the edge: its centre is the midpoint. *)
Theorem edge_sphere_right : forall p0 p1 x,
  let s := edge_sphere (vsub p1 p0) in let z := centre_at p0 s in
  z = midpoint p0 p1 /\ dist2 z p1 = dist2 z p0 /\ tells (side_of_sphere s p0 x) z p0 x.
Proof.
  intros p0 p1 x s z. split; [|split].
  - unfold z, s, centre_at, edge_sphere. vdestruct; vunfold. apply vec_eq; simpl; field.
  - apply on_sphere_of_side; [simpl; lra|]. unfold s, side_of_sphere, edge_sphere; simpl. ring.
  - apply side_tells. simpl. lra.
Qed.

Lemma cross_square_pos : forall a b, cross a b <> vzero -> 0 < dot (cross a b) (cross a b).
Proof.
  intros a b H. destruct (Rlt_dec 0 (dot (cross a b) (cross a b))) as [L|L]; [exact L|].
  exfalso. apply H, dot_self_zero. generalize (dot_self_nonneg (cross a b)); lra.
Qed.

(* The centre lies in the triangle's plane: it is the smallest sphere through the triangle. *)
Theorem triangle_sphere_right : forall p0 p1 p2 x, cross (vsub p1 p0) (vsub p2 p0) <> vzero ->
  let s := triangle_sphere (vsub p1 p0) (vsub p2 p0) in let z := centre_at p0 s in
  dot (vsub z p0) (cross (vsub p1 p0) (vsub p2 p0)) = 0 /\
  dist2 z p1 = dist2 z p0 /\ dist2 z p2 = dist2 z p0 /\ tells (side_of_sphere s p0 x) z p0 x.
Proof.
  intros p0 p1 p2 x H s z. assert (K : 0 < snd s) by (apply cross_square_pos, H).
  split; [|split; [|split]].
  - unfold z, centre_at. generalize (/ (2 * snd s)). unfold s, triangle_sphere; simpl fst. clear.
    generalize (vsub p1 p0) (vsub p2 p0). intros. vdestruct; vunfold; ring.
  - apply on_sphere_of_side; [lra|]. unfold s, side_of_sphere, triangle_sphere; simpl fst; simpl snd. clear.
    generalize (vsub p1 p0) (vsub p2 p0). intros. vdestruct; vunfold; ring.
  - apply on_sphere_of_side; [lra|]. unfold s, side_of_sphere, triangle_sphere; simpl fst; simpl snd. clear.
    generalize (vsub p1 p0) (vsub p2 p0). intros. vdestruct; vunfold; ring.
  - apply side_tells, K.
Qed.

Theorem tetrahedron_sphere_right : forall p0 p1 p2 p3 x, 0 < volume_in_space p0 p1 p2 p3 ->
  let s := tetrahedron_sphere (vsub p1 p0) (vsub p2 p0) (vsub p3 p0) in let z := centre_at p0 s in
  dist2 z p1 = dist2 z p0 /\ dist2 z p2 = dist2 z p0 /\ dist2 z p3 = dist2 z p0 /\
  tells (side_of_sphere s p0 x) z p0 x.
Proof.
  intros p0 p1 p2 p3 x H s z.
  assert (K : 0 < snd s).
  { replace (snd s) with (volume_in_space p0 p1 p2 p3); [exact H|]. unfold s, volume_in_space, tetrahedron_sphere.
    simpl. generalize (vsub p1 p0) (vsub p2 p0) (vsub p3 p0). clear. intros. vdestruct; vunfold; ring. }
  repeat split; try (apply side_tells, K);
    (apply on_sphere_of_side; [lra|]; unfold s, side_of_sphere, tetrahedron_sphere, numerator; simpl fst; simpl snd;
     clear; generalize (vsub p1 p0) (vsub p2 p0) (vsub p3 p0); intros; vdestruct; vunfold; ring).
Qed.

(* The two polynomials of a tetrahedron are the same one. *)
Theorem lifted_is_side : forall p0 p1 p2 p3 x,
  lifted_in_space p0 p1 p2 p3 x =
  side_of_sphere (tetrahedron_sphere (vsub p1 p0) (vsub p2 p0) (vsub p3 p0)) p0 x.
Proof.
  intros. assert (E : forall q, vsub q x = vsub (vsub q p0) (vsub x p0)).
  { intros. apply vec_eq; simpl; ring. }
  unfold lifted_in_space, side_of_sphere, tetrahedron_sphere; simpl fst; simpl snd. cbv zeta.
  rewrite (E p0), (E p1), (E p2), (E p3). replace (vsub p0 p0) with vzero by (apply vec_eq; simpl; ring).
  clear. generalize (vsub p1 p0) (vsub p2 p0) (vsub p3 p0) (vsub x p0). intros.
  unfold numerator. vdestruct; vunfold; ring.
Qed.

(* The filter of OutsideSphere gives the sign of this one (filters.Predicates.outside_sphere_right). *)
Corollary predicate_is_side : forall p0 p1 p2 p3 x,
  let a := vsub p1 p0 in let b := vsub p2 p0 in let c := vsub p3 p0 in let d := vsub x p0 in
  dot d d * det a b c - dot (numerator a b c) d = side_of_sphere (tetrahedron_sphere a b c) p0 x.
Proof.
  intros. unfold side_of_sphere, tetrahedron_sphere; simpl fst; simpl snd. cbv zeta. fold d.
  replace (dot (cross a b) c) with (det a b c) by (clear; vdestruct; vunfold; ring). ring.
Qed.
