(* How the crossing of a facet maps errors of directions (src/flow/cascades.md, "How the error of the direction is
   mapped"). All corners of the polygon lie on one circle. Then the map stretches two orthogonal directions of the
   facet's plane, and the tangent of the angle between two directions grows by no more than its determinant and its
   norm allow. *)
From Coq Require Import Reals Lra Psatz.
From Flowcert Require Import algebra.Vector3 algebra.Cascade.
Open Scope R_scope.

(* As long as the triangle's area, twice, and along its normal. *)
Definition area_vector p0 p1 q := cross (vsub q p0) (vsub q p1).
(* In the triangle's plane, orthogonal to p0p1, to the side of q. *)
Definition side_vector p0 p1 q := cross (area_vector p0 p1 q) (vsub p1 p0).

Lemma dot_positive : forall a, a <> vzero -> 0 < dot a a.
Proof.
  intros a H. destruct (dot_self_nonneg a) as [P|Z]; [exact P|]. exfalso. apply H, dot_self_zero. congruence.
Qed.
Lemma cross_square : forall a b, dot (cross a b) (cross a b) = dot a a * dot b b - dot a b * dot a b.
Proof. intros. vdestruct. vunfold. ring. Qed.
(* The determinant of all dot products of three vectors. *)
Lemma gram : forall a b c, dot a (cross b c) * dot a (cross b c) =
  dot a a * (dot b b * dot c c - dot b c * dot b c) - dot a b * (dot a b * dot c c - dot b c * dot a c) +
  dot a c * (dot a b * dot b c - dot b b * dot a c).
Proof. intros. vdestruct. vunfold. ring. Qed.

(* A vector orthogonal to e, by its parts along n and n x e. *)
Lemma parts_in_plane : forall n e x, dot n e = 0 -> n <> vzero -> e <> vzero -> dot x e = 0 ->
  x = vadd (vscale (dot x (cross n e) / (dot n n * dot e e)) (cross n e)) (vscale (dot x n / dot n n) n).
Proof.
  intros n e x NE N E XE. apply dot_positive in N, E.
  set (w := cross n e). assert (W : dot w w = dot n n * dot e e) by (unfold w; rewrite cross_square, NE; ring).
  assert (WN : dot w n = 0) by (unfold w; clear; vdestruct; vunfold; ring).
  set (p := dot x w / (dot n n * dot e e)). set (q := dot x n / dot n n).
  assert (G := gram x n e). fold w in G. rewrite NE, XE in G.
  assert (Z : dot (vsub x (vadd (vscale p w) (vscale q n))) (vsub x (vadd (vscale p w) (vscale q n))) = 0).
  { replace (dot _ _) with (dot x x - 2 * p * dot x w - 2 * q * dot x n + p * p * dot w w + 2 * p * q * dot w n + q * q
      * dot n n) by (clear; vdestruct; vunfold; ring).
    rewrite W, WN.
    assert (X : dot x w * dot x w = dot x x * (dot n n * dot e e) - dot x n * dot x n * dot e e) by lra.
    replace (dot x x - 2 * p * dot x w - 2 * q * dot x n + p * p * (dot n n * dot e e) + 2 * p * q * 0 + q * q * dot n
      n) with (dot x x - dot x w * dot x w / (dot n n * dot e e) - dot x n * dot x n / dot n n)
      by (unfold p, q; field; lra).
    rewrite X. field. lra. }
  apply dot_self_zero in Z. apply vec_eq; [apply (f_equal vx) in Z | apply (f_equal vy) in Z | apply (f_equal vz) in Z];
    cbn in Z |- *; lra.
Qed.

(* There is no proof by vdestruct in the section below: destruct never clears its variables. *)
Lemma scale_square : forall s v, dot (vscale s v) (vscale s v) = s * s * dot v v.
Proof. intros. vdestruct. vunfold. ring. Qed.
Lemma cross_orthogonal : forall a b, dot (cross a b) a = 0.
Proof. intros. vdestruct. vunfold. ring. Qed.
Lemma cross_of_sums : forall a b f1 g1 f2 g2,
  cross (vadd (vscale f1 a) (vscale g1 b)) (vadd (vscale f2 a) (vscale g2 b)) = vscale (f1 * g2 - g1 * f2) (cross a b).
Proof. intros. vdestruct. apply vec_eq; cbn; ring. Qed.
Lemma dot_of_sum : forall i j a b g, dot (vadd (vscale i a) (vscale j b)) g = i * dot a g + j * dot b g.
Proof. intros. vdestruct. vunfold. ring. Qed.
Lemma dot_scale_right : forall k a b, dot a (vscale k b) = k * dot a b.
Proof. intros. vdestruct. vunfold. ring. Qed.
Lemma orthogonal_square : forall f g a b, dot a b = 0 ->
  dot (vadd (vscale f a) (vscale g b)) (vadd (vscale f a) (vscale g b)) = f * f * dot a a + g * g * dot b b.
Proof.
  intros f g a b H. replace (dot (vadd _ _) _) with (f * f * dot a a + 2 * f * g * dot a b + g * g * dot b b)
    by (vdestruct; vunfold; ring). rewrite H. ring.
Qed.

Lemma area_orthogonal : forall p0 p1 q, dot (area_vector p0 p1 q) (vsub p1 p0) = 0.
Proof. intros. unfold area_vector. vdestruct. vunfold. ring. Qed.
Lemma area_sees_nothing : forall p0 p1 q, dot (area_vector p0 p1 q) (bisector_g p0 p1 q) = 0.
Proof. intros. unfold area_vector, bisector_g. vdestruct. vunfold. ring. Qed.
Lemma side_sees_area : forall p0 p1 q, dot (side_vector p0 p1 q) (bisector_g p0 p1 q) =
  2 * dot (area_vector p0 p1 q) (area_vector p0 p1 q).
Proof. intros. unfold side_vector, area_vector, bisector_g. vdestruct. vunfold. ring. Qed.
Lemma edge_of_area : forall p0 p1 q, area_vector p0 p1 q <> vzero -> vsub p1 p0 <> vzero.
Proof.
  intros p0 p1 q N E. apply N. unfold area_vector. replace (vsub q p1) with (vsub q p0).
  - apply vec_eq; cbn; ring.
  - apply vec_eq; [apply (f_equal vx) in E | apply (f_equal vy) in E | apply (f_equal vz) in E]; cbn in E |- *; lra.
Qed.

(* The centre of the triangle's circle, seen from the middle of p0p1. *)
Theorem centre_from_midpoint : forall p0 p1 q z, area_vector p0 p1 q <> vzero ->
  dist2 z p0 = dist2 z p1 -> dist2 z p0 = dist2 z q -> dot (vsub z p0) (area_vector p0 p1 q) = 0 ->
  vsub z (midpoint p0 p1) =
  vscale (h p0 p1 q / (2 * dot (area_vector p0 p1 q) (area_vector p0 p1 q))) (side_vector p0 p1 q).
Proof.
  intros p0 p1 q z N H1 H2 H3. assert (E := edge_of_area _ _ _ N). assert (NE := area_orthogonal p0 p1 q).
  set (x := vsub z (midpoint p0 p1)).
  assert (XE : dot x (vsub p1 p0) = 0).
  { assert (dot x (vsub p1 p0) = (dist2 z p0 - dist2 z p1) / 2); [|lra].
    unfold x. generalize p0 p1. clear. intros. vdestruct. vunfold. field. }
  assert (XN : dot x (area_vector p0 p1 q) = 0).
  { assert (dot x (area_vector p0 p1 q) = dot (vsub z p0) (area_vector p0 p1 q) - dot (area_vector p0 p1 q) (vsub p1 p0)
      / 2); [|lra]. unfold x. generalize (area_vector p0 p1 q) p0 p1. clear. intros. vdestruct. vunfold. field. }
  assert (XG : dot x (bisector_g p0 p1 q) = h p0 p1 q).
  { assert (dot x (bisector_g p0 p1 q) - h p0 p1 q = (dist2 z p0 + dist2 z p1) / 2 - dist2 z q); [|lra].
    unfold x, bisector_g, h. generalize p0 p1 q. clear. intros. vdestruct. vunfold. field. }
  assert (P := parts_in_plane _ _ x NE N E XE). fold (side_vector p0 p1 q) in P. rewrite XN in P.
  assert (Q := XG). rewrite P in Q.
  set (n := area_vector p0 p1 q) in *. set (w := side_vector p0 p1 q) in *.
  set (k := dot x w / (dot n n * dot (vsub p1 p0) (vsub p1 p0))) in *.
  assert (D : dot (vadd (vscale k w) (vscale (0 / dot n n) n)) (bisector_g p0 p1 q) = k * (2 * dot n n)).
  { unfold w, n. rewrite <- side_sees_area. fold w n. unfold Rdiv. rewrite Rmult_0_l.
    generalize k w n (bisector_g p0 p1 q). clear. intros. vdestruct. vunfold. ring. }
  rewrite D in Q. apply dot_positive in N. rewrite P. replace (h p0 p1 q / (2 * dot n n)) with k.
  - apply vec_eq; cbn; unfold Rdiv; ring.
  - rewrite <- Q. field. lra.
Qed.

(* A corner c sees the next facet's edge k0k1 in the polygon of p0, p1 and q. *)
Record polygon (p0 p1 q k0 k1 c : vec) : Prop := Polygon {
  has_area : area_vector p0 p1 q <> vzero;
  has_next_area : area_vector k0 k1 c <> vzero;
  is_plane : exists k, area_vector k0 k1 c = vscale k (area_vector p0 p1 q);
  has_circle : exists z, dot (vsub z p0) (area_vector p0 p1 q) = 0 /\ dot (vsub z k0) (area_vector k0 k1 c) = 0 /\
    dist2 z p0 = dist2 z p1 /\ dist2 z p0 = dist2 z q /\ dist2 z k0 = dist2 z k1 /\ dist2 z k0 = dist2 z c }.

Lemma drop_of_polygon : forall p0 p1 q k0 k1 c, polygon p0 p1 q k0 k1 c ->
  D p0 p1 k0 k1 = vsub
    (vscale (h k0 k1 c / dot (area_vector k0 k1 c) (area_vector k0 k1 c)) (side_vector k0 k1 c))
    (vscale (h p0 p1 q / dot (area_vector p0 p1 q) (area_vector p0 p1 q)) (side_vector p0 p1 q)).
Proof.
  intros p0 p1 q k0 k1 c [N M _ [z [P1 [P2 [Z1 [Z2 [Z3 Z4]]]]]]].
  assert (C := centre_from_midpoint p0 p1 q z N Z1 Z2 P1). assert (C' := centre_from_midpoint k0 k1 c z M Z3 Z4 P2).
  apply dot_positive in N, M.
  set (a := dot (area_vector p0 p1 q) (area_vector p0 p1 q)) in *. set (b := dot (area_vector k0 k1 c) (area_vector k0
    k1 c)) in *. set (w := side_vector p0 p1 q) in *. set (w' := side_vector k0 k1 c) in *.
  replace (h p0 p1 q / (2 * a)) with (/ 2 * (h p0 p1 q / a)) in C by (field; lra).
  replace (h k0 k1 c / (2 * b)) with (/ 2 * (h k0 k1 c / b)) in C' by (field; lra).
  generalize dependent (h p0 p1 q / a). generalize dependent (h k0 k1 c / b). intros i C' j C. unfold D, midpoint in *.
  apply vec_eq;
    [ apply (f_equal vx) in C; apply (f_equal vx) in C' | apply (f_equal vy) in C; apply (f_equal vy) in C'
    | apply (f_equal vz) in C; apply (f_equal vz) in C' ]; cbn in *; lra.
Qed.

(* What the map does to a vector of the facet's plane: two orthogonal parts are multiplied. *)
Section Map.
Variables p0 p1 q k0 k1 c : vec.
Hypothesis P : polygon p0 p1 q k0 k1 c.
Let n := area_vector p0 p1 q.
Let w := side_vector p0 p1 q.
Let n' := area_vector k0 k1 c.
Let w' := side_vector k0 k1 c.
Let map x := step p0 p1 q x k0 k1.
Let stretch := 2 * dot n n * (h k0 k1 c / dot n' n').

Lemma map_of_parts : forall i j, map (vadd (vscale i w) (vscale j n)) =
  vadd (vscale (i * stretch) w') (vscale (j * (2 * h p0 p1 q)) n).
Proof.
  intros i j. unfold map, step. rewrite (drop_of_polygon _ _ _ _ _ _ P). fold n w n' w'.
  assert (Seen : A p0 p1 q (vadd (vscale i w) (vscale j n)) = i * (2 * dot n n)).
  { unfold A. assert (S1 := side_sees_area p0 p1 q). assert (S2 := area_sees_nothing p0 p1 q). fold n w in S1, S2.
    rewrite <- S1, dot_of_sum, S2. ring. }
  rewrite Seen. assert (N := has_area _ _ _ _ _ _ P). apply dot_positive in N. fold n in N.
  assert (N' := has_next_area _ _ _ _ _ _ P). apply dot_positive in N'. fold n' in N'.
  unfold stretch. apply vec_eq; cbn; field; lra.
Qed.

Let e := vsub p1 p0.
Let e' := vsub k1 k0.
Definition determinant_square := 16 * (h p0 p1 q * h p0 p1 q) * (h k0 k1 c * h k0 k1 c) *
  (dot n n / dot n' n') * (dot e' e' / dot e e).
Definition norm_square := 4 * Rmax (h p0 p1 q * h p0 p1 q)
  (h k0 k1 c * h k0 k1 c * (dot n n / dot n' n') * (dot e' e' / dot e e)).

Lemma orthogonal_parts : dot w n = 0 /\ dot w' n = 0 /\ dot w w = dot n n * dot e e /\
  dot w' w' = dot n' n' * dot e' e' /\ 0 < dot n n /\ 0 < dot n' n' /\ 0 < dot e e.
Proof.
  destruct (is_plane _ _ _ _ _ _ P) as [k K]. fold n n' in K.
  assert (N := has_area _ _ _ _ _ _ P). assert (E := edge_of_area _ _ _ N). apply dot_positive in N, E. fold n e in N,
    E.
  assert (N' := has_next_area _ _ _ _ _ _ P). apply dot_positive in N'. fold n' in N'.
  split; [apply cross_orthogonal|]. split.
  - assert (Z := cross_orthogonal n' e'). change (cross n' e') with w' in Z. rewrite K in Z at 1.
    rewrite dot_scale_right in Z. assert (k <> 0) by (intro Z0; rewrite K, Z0, scale_square in N'; lra).
    destruct (Rmult_integral _ _ Z); [contradiction | assumption].
  - unfold w, w'. unfold side_vector. fold n n' e e'. rewrite !cross_square.
    assert (A1 := area_orthogonal p0 p1 q). assert (A2 := area_orthogonal k0 k1 c). fold n e in A1. fold n' e' in A2.
    rewrite A1, A2. repeat split; try assumption; ring.
Qed.

Lemma parts : forall x, dot x e = 0 -> exists i j, x = vadd (vscale i w) (vscale j n).
Proof.
  intros x H. assert (N := has_area _ _ _ _ _ _ P).
  eexists. eexists. exact (parts_in_plane _ _ x (area_orthogonal p0 p1 q) N (edge_of_area _ _ _ N) H).
Qed.

Theorem map_determinant : forall x y, dot x e = 0 -> dot y e = 0 ->
  dot (cross (map x) (map y)) (cross (map x) (map y)) = determinant_square * dot (cross x y) (cross x y).
Proof.
  intros x y X Y. destruct (parts x X) as [i [j ->]]. destruct (parts y Y) as [k [l ->]].
  rewrite !map_of_parts. destruct orthogonal_parts as [O1 [O2 [W [W' [N [N' E]]]]]].
  rewrite !cross_of_sums, !scale_square, !cross_square, O1, O2, W, W'. unfold determinant_square, stretch.
  field. lra.
Qed.

Theorem map_norm : forall x, dot x e = 0 -> dot (map x) (map x) <= norm_square * dot x x.
Proof.
  intros x X. destruct (parts x X) as [i [j ->]]. rewrite map_of_parts.
  destruct orthogonal_parts as [O1 [O2 [W [W' [N [N' E]]]]]].
  rewrite !orthogonal_square by assumption. rewrite W, W'.
  set (big := h k0 k1 c * h k0 k1 c * (dot n n / dot n' n') * (dot e' e' / dot e e)).
  assert (X1 : i * stretch * (i * stretch) * (dot n' n' * dot e' e') = 4 * big * (i * i * (dot n n * dot e e))).
  { unfold big, stretch. field. lra. }
  rewrite X1. unfold norm_square. fold big.
  assert (M1 := Rmax_l (h p0 p1 q * h p0 p1 q) big). assert (M2 := Rmax_r (h p0 p1 q * h p0 p1 q) big).
  set (m := Rmax (h p0 p1 q * h p0 p1 q) big) in *.
  assert (Y1 : 4 * big * (i * i * (dot n n * dot e e)) <= 4 * m * (i * i * (dot n n * dot e e))).
  { apply Rmult_le_compat_r; [|lra]. apply Rmult_le_pos; [nra|]. apply Rmult_le_pos; lra. }
  assert (Y2 : 4 * (h p0 p1 q * h p0 p1 q) * (j * j * dot n n) <= 4 * m * (j * j * dot n n)).
  { apply Rmult_le_compat_r; [|lra]. apply Rmult_le_pos; [nra | lra]. }
  lra.
Qed.
End Map.

(* The triangle itself, with an edge that has q and keeps one end of p0p1. *)
Lemma circle_of_triangle : forall p0 p1 q, area_vector p0 p1 q <> vzero -> exists z,
  dot (vsub z p0) (area_vector p0 p1 q) = 0 /\ dist2 z p0 = dist2 z p1 /\ dist2 z p0 = dist2 z q.
Proof.
  intros p0 p1 q N. apply dot_positive in N. assert (S := side_sees_area p0 p1 q).
  assert (E : dot (side_vector p0 p1 q) (vsub p1 p0) = 0)
    by (unfold side_vector; clear; vdestruct; vunfold; ring).
  assert (O : dot (side_vector p0 p1 q) (area_vector p0 p1 q) = 0) by apply cross_orthogonal.
  assert (F := area_orthogonal p0 p1 q).
  set (n := area_vector p0 p1 q) in *. set (w := side_vector p0 p1 q) in *.
  set (k := h p0 p1 q / (2 * dot n n)).
  assert (K : k * dot w (bisector_g p0 p1 q) = h p0 p1 q) by (rewrite S; unfold k; field; lra).
  exists (vadd (midpoint p0 p1) (vscale k w)). split; [|split].
  - assert (dot (vsub (vadd (midpoint p0 p1) (vscale k w)) p0) n = dot n (vsub p1 p0) / 2 + k * dot w n).
    { generalize w n k. clear. intros. vdestruct. vunfold. field. }
    rewrite H, F, O. field.
  - assert (dist2 (vadd (midpoint p0 p1) (vscale k w)) p0 - dist2 (vadd (midpoint p0 p1) (vscale k w)) p1 = 2 * k * dot
    w
      (vsub p1 p0)); [|rewrite E in H; lra]. generalize w k. clear. intros. vdestruct. vunfold. field.
  - assert (dist2 (vadd (midpoint p0 p1) (vscale k w)) p0 - dist2 (vadd (midpoint p0 p1) (vscale k w)) q = k * dot w
      (bisector_g p0 p1 q) - h p0 p1 q + k * dot w (vsub p1 p0)); [|rewrite E in H; lra].
    unfold bisector_g, h. generalize w k. clear. intros. vdestruct. vunfold. field.
Qed.
Lemma triangle_is_polygon : forall p0 p1 q, area_vector p0 p1 q <> vzero ->
  polygon p0 p1 q p0 q p1 /\ polygon p0 p1 q p1 q p0.
Proof.
  intros p0 p1 q N. destruct (circle_of_triangle p0 p1 q N) as [z [Z [Z1 Z2]]].
  assert (A1 : area_vector p0 q p1 = vscale (-1) (area_vector p0 p1 q))
    by (unfold area_vector; vdestruct; apply vec_eq; cbn; ring).
  assert (A2 : area_vector p1 q p0 = vscale 1 (area_vector p0 p1 q))
    by (unfold area_vector; vdestruct; apply vec_eq; cbn; ring).
  assert (M : forall k, k <> 0 -> vscale k (area_vector p0 p1 q) <> vzero).
  { intros k K V. apply dot_positive in N. apply (f_equal (fun v => dot v v)) in V. rewrite scale_square in V.
    replace (dot vzero vzero) with 0 in V by (unfold dot, vzero; cbn; ring).
    destruct (Rmult_integral _ _ V) as [W|W]; [apply Rmult_integral in W; tauto | lra]. }
  assert (Z' : dot (vsub z p1) (area_vector p0 p1 q) = 0).
  { assert (F := area_orthogonal p0 p1 q).
    assert (dot (vsub z p1) (area_vector p0 p1 q) = dot (vsub z p0) (area_vector p0 p1 q) - dot (area_vector p0 p1 q)
      (vsub p1 p0)) by (generalize (area_vector p0 p1 q); clear; intros; vdestruct; vunfold; ring). lra. }
  split; split; try assumption.
  - rewrite A1. apply M. lra.
  - exists (-1). exact A1.
  - exists z. rewrite A1, dot_scale_right. repeat split; try assumption; try (symmetry; assumption); rewrite ?Z; ring.
  - rewrite A2. apply M. lra.
  - exists 1. exact A2.
  - exists z. rewrite A2, dot_scale_right, Z'. repeat split; try assumption; try ring; congruence.
Qed.
