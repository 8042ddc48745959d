(* `triangle_right`, `corner_right`, `polygon_right`: where step_across() of src/flow/kernels/direction_across.h says
   that the direction behind a facet is known, it is, on doubles, for all points. The facet is left through a triangle,
   or through a polygon, to an edge of it that keeps one end of the facet's edge or none. *)
From Coq Require Import Reals ZArith QArith Qreals Lra Lia Psatz Bool List.
From Flocq Require Import Core BinarySingleNaN.
From Flowcert Require Import algebra.Vector3 algebra.Cascade algebra.Crossing code.Expression code.generated.Constants
  filters.Rounding filters.RoundedVectors filters.Norms filters.Floors filters.Doubles filters.Terms filters.Filter
  filters.Directions filters.DirectionSigns filters.DirectionVectors filters.DirectionOfVector filters.DirectionStarts
  filters.CrossingLengths filters.CrossingAreas filters.CrossingVectors filters.CrossingKnown filters.CrossingTerms
  filters.CrossingOnDoubles filters.CrossingBehind filters.CrossingInputs.
From Flowcert Require filters.Cells.
Open Scope R_scope.

(* ---- Through a triangle ---- *)

Lemma same_area : forall a b c,
  dot (area_vector a b c) (area_vector a b c) = dot (area_vector a c b) (area_vector a c b).
Proof.
  intros a b c. replace (area_vector a c b) with (vscale (-1) (area_vector a b c)); [rewrite scale_square; ring|].
  unfold area_vector. vdestruct. apply vec_eq; cbn; ring.
Qed.

Section Triangle.
Variable y : nat -> double.
Let p k := point y k.
Let w n := on_doubles y (inputs triangle_pairs n).
Let x n := on_doubles y (in_triangle n).
Let d k := value_of_vector (exact_inputs triangle_pairs y) k.
Let v k := value_of_vector (fun n => val (w n)) k.
Let G := seen_from (p 0%nat) (p 1%nat) (p 2%nat).

Lemma second_below_seen_size : forall a b, len b <= 0.7072 * seen_size a b.
Proof.
  intros a b. apply len_le; [apply Rmult_le_pos; [lra | apply seen_size_nonneg]|].
  replace (0.7072 * seen_size a b * (0.7072 * seen_size a b)) with (0.7072 * 0.7072 * (seen_size a b * seen_size a b))
    by ring. rewrite seen_size_square. generalize (dot_self_nonneg a) (dot_self_nonneg b). lra.
Qed.

Lemma triangle_is_good : area_vector (p 0%nat) (p 1%nat) (p 2%nat) <> vzero ->
  good_passage x (p 0%nat) (p 1%nat) (p 2%nat) (p 0%nat) (p 2%nat) (p 1%nat) (len (d 3%nat)) G.
Proof.
  intro Area. generalize u_pos u_val. intros U0 Hu.
  assert (D1 : d 1%nat = vsub (p 2%nat) (p 0%nat)) by reflexivity.
  assert (D2 : d 2%nat = vsub (p 2%nat) (p 1%nat)) by reflexivity.
  assert (D3 : d 3%nat = vsub (p 1%nat) (p 2%nat)) by reflexivity.
  assert (D4 : d 4%nat = vsub (p 1%nat) (p 0%nat)) by reflexivity.
  assert (L3 : len (d 3%nat) = len (d 2%nat)).
  { rewrite D3, D2. apply len_sub_sym. }
  assert (EG : seen_size (d 1%nat) (d 2%nat) = G) by (unfold G, seen_from; rewrite D1, D2; reflexivity).
  assert (Part : forall n e, in_triangle n = replace (inputs triangle_pairs) e -> x n = on_doubles w e)
    by (intros n e E; unfold x, w; rewrite E; apply on_doubles_replace).
  assert (Seen : square_in_range x seen_square_size -> Rabs (val (x 10%nat) - G * G) <= 7.01 * u * (G * G) /\
    / 10 ^ 26 <= G <= 10 ^ 26).
  { intro R. apply (square_in_range_same x w seen_square_size (seen_square 1 2) (Part 10%nat _ eq_refl)) in R.
    destruct (seen_is_near triangle_pairs y R) as [_ [_ [HS [HG _]]]].
    change (value_of_vector (exact_inputs triangle_pairs y) 1) with (d 1%nat) in HS, HG.
    change (value_of_vector (exact_inputs triangle_pairs y) 2) with (d 2%nat) in HS, HG. rewrite EG in HS, HG.
    split; [|exact HG]. rewrite (Part 10%nat (seen_square 1 2) eq_refl). exact HS. }
  assert (E16 : x 16%nat = x 10%nat) by reflexivity.
  assert (Square : square_in_range x seen_square_size -> G * G * (1 - 14 * u) <= val (x 16%nat)).
  { intro R. destruct (Seen R) as [HS _]. rewrite E16. apply Rabs_le_inv in HS.
    assert (0 <= u * (G * G)) by (apply Rmult_le_pos; [lra | apply Rle_0_sqr]). lra. }
  assert (V3 : (forall n, (6 <= n <= 23)%nat -> n <> 11%nat -> finite (x n)) -> vapprox 1 (v 3%nat) (d 3%nat)).
  { intro F. apply (vector_is_near triangle_pairs y 2). intros [|[|[|i]]] Hi; [| | | lia].
    - exact (F 12%nat ltac:(lia) ltac:(lia)).
    - exact (F 13%nat ltac:(lia) ltac:(lia)).
    - exact (F 14%nat ltac:(lia) ltac:(lia)). }
  assert (R6 : square_in_range x (square 6) -> vapprox 1 (v 4%nat) (d 4%nat) /\ / 10 ^ 26 <= len (d 4%nat) <= 10 ^ 26).
  { intro R. apply (edge_of_passage triangle_pairs y 3).
    exact (square_in_range_same x w (square 6) (square 4) eq_refl R). }
  assert (R7 : square_in_range x (square 7) -> vapprox 1 (v 1%nat) (d 1%nat) /\ / 10 ^ 26 <= len (d 1%nat) <= 10 ^ 26).
  { intro R. apply (edge_of_passage triangle_pairs y 0).
    exact (square_in_range_same x w (square 7) (square 1) eq_refl R). }
  split.
  - apply triangle_is_polygon, Area.
  - rewrite (Part 16%nat (seen_square 1 2) eq_refl). apply mul_positive.
    + apply positive_not_negative. rewrite (proj2 (power_constant 1 w ltac:(lia))). apply bpow_gt_0.
    + apply add_positive; apply square_positive.
  - apply positive_not_negative. change (x 17%nat) with (on_doubles y one). rewrite (proj2 (one_on_doubles y)). lra.
  - intros F R. assert (ED : D (p 0%nat) (p 1%nat) (p 0%nat) (p 2%nat) = d 3%nat).
    { rewrite D3. apply vec_eq; cbn; ring. }
    apply (inputs_of_passage triangle_pairs y (Given 3) (Given 4) (Given 1) (Dot (Given 4) (Given 3))
      (seen_square 1 2) one _ _ _ _ _ _ _ D1 D2 F R).
    + rewrite ED. lra.
    + rewrite ED. eapply Rle_trans; [exact (vapprox_len _ _ (V3 F))|].
      apply Rmult_le_compat_r; [apply len_nonneg | lra].
    + left. split; [|reflexivity]. rewrite L3. fold G. rewrite <- EG. apply second_below_seen_size.
    + exact (Square R).
  - intro R. destruct (R7 R) as [V1 B]. rewrite <- D1. split; [exact (vapprox_len _ _ V1) | exact B].
  - intros F R10 R6' R7' _ _ _ _. destruct (R6 R6') as [V4 B4]. destruct (R7 R7') as [V1 B1].
    assert (F15 := F 15%nat ltac:(lia) ltac:(lia)).
    rewrite (Part 15%nat (edot (given 4) (given 3)) eq_refl) in F15.
    assert (E15 : val (x 15%nat) = rdot (v 4%nat) (v 3%nat)).
    { rewrite (Part 15%nat (edot (given 4) (given 3)) eq_refl). apply (dot_parts w 4 3 F15). }
    assert (E17 : val (x 17%nat) = 1) by exact (proj2 (one_on_doubles y)).
    unfold height_value. rewrite E15, E17.
    change (value_of_vector (fun n => val (x n)) 6) with (v 4%nat).
    change (value_of_vector (fun n => val (x n)) 7) with (v 1%nat).
    assert (Same : dot (area_vector (p 0%nat) (p 1%nat) (p 2%nat)) (area_vector (p 0%nat) (p 1%nat) (p 2%nat)) =
      dot (area_vector (p 0%nat) (p 2%nat) (p 1%nat)) (area_vector (p 0%nat) (p 2%nat) (p 1%nat))).
    { apply same_area. }
    apply (height_of_triangle _ _ (d 4%nat) (d 3%nat) (d 4%nat) (d 1%nat) _ _ _ _ G (val (x 16%nat)) _
      V4 (V3 F) V4 V1 Same B4 B1 (proj1 (proj2 (Seen R10)))).
    + rewrite <- EG. replace (d 4%nat) with (vsub (d 1%nat) (d 2%nat)); [apply edge_below_seen_size|].
      rewrite D1, D2, D4. apply vec_eq; cbn; ring.
    + rewrite L3, <- EG. generalize (second_below_seen_size (d 1%nat) (d 2%nat)) (seen_size_nonneg (d 1%nat) (d 2%nat)).
      lra.
    + exact (Square R10).
    + apply height_needs.
Qed.
End Triangle.

(* The facet of p0p1 is left through the triangle p0 p1 p2, and the next facet's edge is p0p2. y is the true direction,
   and sigma the sign of <y, g> or of h, where one of the two is not zero. *)
Theorem triangle_right : forall x y sigma, let p k := point x k in
  known_on_doubles (vsub (p 1%nat) (p 0%nat)) y x -> area_vector (p 0%nat) (p 1%nat) (p 2%nat) <> vzero ->
  way_of_sign (p 0%nat) (p 1%nat) (p 2%nat) y sigma -> run x Code.AcrossTriangle.is_known = Some Positive ->
  (forall e, In e (Code.AcrossTriangle.u_x :: Code.AcrossTriangle.u_y :: Code.AcrossTriangle.u_z ::
    Code.AcrossTriangle.error :: nil) -> finite (on_doubles x e)) /\
  known (vsub (p 2%nat) (p 0%nat))
    (vscale sigma (step (p 0%nat) (p 1%nat) (p 2%nat) y (p 0%nat) (p 2%nat)))
    (V (val (on_doubles x Code.AcrossTriangle.u_x)) (val (on_doubles x Code.AcrossTriangle.u_y))
      (val (on_doubles x Code.AcrossTriangle.u_z))) (val (on_doubles x Code.AcrossTriangle.error)).
Proof.
  intros x y sigma p K Area Way H. apply (across_right in_triangle _ _ _ _ _ _ _ x triangle_match H). intros z Run.
  destruct (direction_of_passage triangle_pairs (Given 3) (Given 4) (Given 1) (Dot (Given 4) (Given 3))
    (seen_square 1 2) one _ _ _ K) as [F Kx].
  exact (behind_right _ _ _ _ _ _ _ _ _ _ _ (triangle_is_good x Area) F Kx Way Run).
Qed.

(* ---- Through a polygon, to an edge that keeps one end ---- *)

Section Corner.
Variable y : nat -> double.
Let p k := point y k.
Let w n := on_doubles y (inputs corner_pairs n).
Let x n := on_doubles y (in_corner n).
Let d k := value_of_vector (exact_inputs corner_pairs y) k.
Let v k := value_of_vector (fun n => val (w n)) k.
Let G := seen_from (p 0%nat) (p 1%nat) (p 2%nat).
Let L := G + len (d 3%nat).

Lemma corner_is_good : polygon (p 0%nat) (p 1%nat) (p 2%nat) (p 0%nat) (p 3%nat) (p 1%nat) ->
  good_passage x (p 0%nat) (p 1%nat) (p 2%nat) (p 0%nat) (p 3%nat) (p 1%nat) (len (d 3%nat)) L.
Proof.
  intro Poly. generalize u_pos u_val. intros U0 Hu.
  assert (D1 : d 1%nat = vsub (p 2%nat) (p 0%nat)) by reflexivity.
  assert (D2 : d 2%nat = vsub (p 2%nat) (p 1%nat)) by reflexivity.
  assert (D3 : d 3%nat = vsub (p 1%nat) (p 3%nat)) by reflexivity.
  assert (D4 : d 4%nat = vsub (p 1%nat) (p 0%nat)) by reflexivity.
  assert (D5 : d 5%nat = vsub (p 3%nat) (p 0%nat)) by reflexivity.
  assert (EG : seen_size (d 1%nat) (d 2%nat) = G) by (unfold G, seen_from; rewrite D1, D2; reflexivity).
  assert (Part : forall n e, in_corner n = replace (inputs corner_pairs) e -> x n = on_doubles w e)
    by (intros n e E; unfold x, w; rewrite E; apply on_doubles_replace).
  assert (Seen : square_in_range x seen_square_size -> vapprox 1 (v 1%nat) (d 1%nat) /\ vapprox 1 (v 2%nat) (d 2%nat) /\
    / 10 ^ 26 <= G <= 10 ^ 26 /\ G * (1 - 4.01 * u) <= rnd (sqrt (val (on_doubles w (seen_square 1 2))))).
  { intro R. apply (square_in_range_same x w seen_square_size (seen_square 1 2) (Part 10%nat _ eq_refl)) in R.
    destruct (seen_is_near corner_pairs y R) as [[_ V1] [[_ V2] [_ [HG Low]]]].
    change (value_of_vector (exact_inputs corner_pairs y) 1) with (d 1%nat) in V1, HG, Low.
    change (value_of_vector (exact_inputs corner_pairs y) 2) with (d 2%nat) in V2, HG, Low. rewrite EG in HG, Low.
    exact (conj V1 (conj V2 (conj HG Low))). }
  assert (V3 : (forall n, (6 <= n <= 23)%nat -> n <> 11%nat -> finite (x n)) -> vapprox 1 (v 3%nat) (d 3%nat)).
  { intro F. apply (vector_is_near corner_pairs y 2). intros [|[|[|i]]] Hi; [| | | lia].
    - exact (F 12%nat ltac:(lia) ltac:(lia)).
    - exact (F 13%nat ltac:(lia) ltac:(lia)).
    - exact (F 14%nat ltac:(lia) ltac:(lia)). }
  assert (Square : (forall n, (6 <= n <= 23)%nat -> n <> 11%nat -> finite (x n)) ->
    square_in_range x seen_square_size -> L * L * (1 - 14 * u) <= val (x 16%nat)).
  { intros F R. destruct (Seen R) as [_ [_ [HG Low]]]. assert (F16 := F 16%nat ltac:(lia) ltac:(lia)).
    rewrite (Part 16%nat (squared (Add (Root (seen_square 1 2)) (Root (square 3)))) eq_refl) in F16 |- *.
    destruct (mul_parts w _ _ F16) as [Fs [_ E]]. destruct (add_parts w _ _ Fs) as [Fr [F3 E1]].
    destruct (root_parts w _ Fr) as [_ E2]. destruct (root_parts w _ F3) as [Fq E3].
    destruct (square_back w 3 Fq) as [_ E4]. unfold squared. rewrite E, E1, E2, E3, E4.
    exact (size_of_corner G _ (d 3%nat) (v 3%nat) (proj1 HG) Low (fmt_rnd _) (V3 F)). }
  assert (R6 : square_in_range x (square 6) -> vapprox 1 (v 4%nat) (d 4%nat) /\ / 10 ^ 26 <= len (d 4%nat) <= 10 ^ 26).
  { intro R. apply (edge_of_passage corner_pairs y 3).
    exact (square_in_range_same x w (square 6) (square 4) eq_refl R). }
  assert (R7 : square_in_range x (square 7) -> vapprox 1 (v 5%nat) (d 5%nat) /\ / 10 ^ 26 <= len (d 5%nat) <= 10 ^ 26).
  { intro R. apply (edge_of_passage corner_pairs y 4).
    exact (square_in_range_same x w (square 7) (square 5) eq_refl R). }
  split.
  - exact Poly.
  - rewrite (Part 16%nat (squared (Add (Root (seen_square 1 2)) (Root (square 3)))) eq_refl). apply squared_positive.
  - rewrite (Part 17%nat (ratio_of_areas 4 3) eq_refl). apply ratio_positive.
  - intros F R. assert (ED : D (p 0%nat) (p 1%nat) (p 0%nat) (p 3%nat) = d 3%nat).
    { rewrite D3. apply vec_eq; cbn; ring. }
    apply (inputs_of_passage corner_pairs y (Given 3) (Given 4) (Given 5) (Dot (Given 4) (Given 3))
      (squared (Add (Root (seen_square 1 2)) (Root (square 3)))) (ratio_of_areas 4 3) _ _ _ _ _ _ _ D1 D2 F R).
    + rewrite ED. lra.
    + rewrite ED. eapply Rle_trans; [exact (vapprox_len _ _ (V3 F))|].
      apply Rmult_le_compat_r; [apply len_nonneg | lra].
    + right. reflexivity.
    + exact (Square F R).
  - intro R. destruct (R7 R) as [V5 B]. rewrite <- D5. split; [exact (vapprox_len _ _ V5) | exact B].
  - intros F R10 R6' R7' Sq La Lb Top. destruct (R6 R6') as [V4 B4]. destruct (R7 R7') as [V5 B5].
    destruct (Seen R10) as [V1 [V2 [HG _]]]. assert (L3 := len_nonneg (d 3%nat)).
    assert (L4 : len (d 4%nat) <= G).
    { rewrite <- EG. replace (d 4%nat) with (vsub (d 1%nat) (d 2%nat)); [apply edge_below_seen_size|].
      rewrite D1, D2, D4. apply vec_eq; cbn; ring. }
    assert (L1 : len (d 1%nat) <= G).
    { rewrite <- EG. eapply Rle_trans; [|apply sum_below_seen_size]. generalize (len_nonneg (d 2%nat)). lra. }
    rewrite <- D1 in La. rewrite <- D2 in Lb.
    apply (height_with_areas x w 4 3 (d 1%nat) (d 2%nat) (d 4%nat) (d 3%nat) (d 4%nat) (d 5%nat) L
      (Part 15%nat _ eq_refl) (Part 17%nat _ eq_refl) (F 15%nat ltac:(lia) ltac:(lia)) (F 17%nat ltac:(lia) ltac:(lia))
      V1 V2 V4 (V3 F) V4 V5 B4 B5); try assumption; unfold L in *; lra.
Qed.
End Corner.

(* The next edge is p0p3, where the corners of the polygon lie on one circle. *)
Theorem corner_right : forall x y sigma, let p k := point x k in
  known_on_doubles (vsub (p 1%nat) (p 0%nat)) y x ->
  polygon (p 0%nat) (p 1%nat) (p 2%nat) (p 0%nat) (p 3%nat) (p 1%nat) ->
  way_of_sign (p 0%nat) (p 1%nat) (p 2%nat) y sigma -> run x Code.AcrossCorner.is_known = Some Positive ->
  (forall e, In e (Code.AcrossCorner.u_x :: Code.AcrossCorner.u_y :: Code.AcrossCorner.u_z ::
    Code.AcrossCorner.error :: nil) -> finite (on_doubles x e)) /\
  known (vsub (p 3%nat) (p 0%nat))
    (vscale sigma (step (p 0%nat) (p 1%nat) (p 2%nat) y (p 0%nat) (p 3%nat)))
    (V (val (on_doubles x Code.AcrossCorner.u_x)) (val (on_doubles x Code.AcrossCorner.u_y))
      (val (on_doubles x Code.AcrossCorner.u_z))) (val (on_doubles x Code.AcrossCorner.error)).
Proof.
  intros x y sigma p K Poly Way H. apply (across_right in_corner _ _ _ _ _ _ _ x corner_match H). intros z Run.
  destruct (direction_of_passage corner_pairs (Given 3) (Given 4) (Given 5) (Dot (Given 4) (Given 3))
    (squared (Add (Root (seen_square 1 2)) (Root (square 3)))) (ratio_of_areas 4 3) _ _ _ K) as [F Kx].
  exact (behind_right _ _ _ _ _ _ _ _ _ _ _ (corner_is_good x Poly) F Kx Way Run).
Qed.

(* ---- Through a polygon, to an edge that keeps no end ---- *)

Section Polygon.
Variable y : nat -> double.
Let p k := point y k.
Let w n := on_doubles y (inputs polygon_pairs n).
Let x n := on_doubles y (in_polygon n).
Let d k := value_of_vector (exact_inputs polygon_pairs y) k.
Let v k := value_of_vector (fun n => val (w n)) k.
Let G := seen_from (p 0%nat) (p 1%nat) (p 2%nat).
Let dd := len (d 3%nat) + len (d 4%nat).
Let L := G + dd.

Lemma polygon_is_good : polygon (p 0%nat) (p 1%nat) (p 2%nat) (p 3%nat) (p 4%nat) (p 0%nat) ->
  good_passage x (p 0%nat) (p 1%nat) (p 2%nat) (p 3%nat) (p 4%nat) (p 0%nat) dd L.
Proof.
  intro Poly. generalize u_pos u_val. intros U0 Hu.
  assert (D1 : d 1%nat = vsub (p 2%nat) (p 0%nat)) by reflexivity.
  assert (D2 : d 2%nat = vsub (p 2%nat) (p 1%nat)) by reflexivity.
  assert (D3 : d 3%nat = vsub (p 0%nat) (p 3%nat)) by reflexivity.
  assert (D4 : d 4%nat = vsub (p 1%nat) (p 4%nat)) by reflexivity.
  assert (D5 : d 5%nat = vsub (p 1%nat) (p 0%nat)) by reflexivity.
  assert (D6 : d 6%nat = vsub (p 4%nat) (p 3%nat)) by reflexivity.
  assert (D7 : d 7%nat = vsub (p 0%nat) (p 4%nat)) by reflexivity.
  assert (EG : seen_size (d 1%nat) (d 2%nat) = G) by (unfold G, seen_from; rewrite D1, D2; reflexivity).
  assert (Part : forall n e, in_polygon n = replace (inputs polygon_pairs) e -> x n = on_doubles w e)
    by (intros n e E; unfold x, w; rewrite E; apply on_doubles_replace).
  assert (Seen : square_in_range x seen_square_size -> vapprox 1 (v 1%nat) (d 1%nat) /\ vapprox 1 (v 2%nat) (d 2%nat) /\
    / 10 ^ 26 <= G <= 10 ^ 26 /\ G * (1 - 4.01 * u) <= rnd (sqrt (val (on_doubles w (seen_square 1 2))))).
  { intro R. apply (square_in_range_same x w seen_square_size (seen_square 1 2) (Part 10%nat _ eq_refl)) in R.
    destruct (seen_is_near polygon_pairs y R) as [[_ V1] [[_ V2] [_ [HG Low]]]].
    change (value_of_vector (exact_inputs polygon_pairs y) 1) with (d 1%nat) in V1, HG, Low.
    change (value_of_vector (exact_inputs polygon_pairs y) 2) with (d 2%nat) in V2, HG, Low. rewrite EG in HG, Low.
    exact (conj V1 (conj V2 (conj HG Low))). }
  assert (Drop : (forall n, (6 <= n <= 23)%nat -> n <> 11%nat -> finite (x n)) ->
    (fmt3 (v 3%nat) /\ vapprox 1 (v 3%nat) (d 3%nat)) /\ (fmt3 (v 4%nat) /\ vapprox 1 (v 4%nat) (d 4%nat)) /\
    value_of_vector (fun n => val (x n)) 4 = radd (v 3%nat) (v 4%nat)).
  { intro F. assert (P : forall j, (j < 3)%nat -> finite (w (9 + j)%nat) /\ finite (w (12 + j)%nat) /\
      val (x (12 + j)%nat) = rnd (val (w (9 + j)%nat) + val (w (12 + j)%nat))).
    { intros j Hj. assert (Fj := F (12 + j)%nat ltac:(lia) ltac:(lia)).
      assert (E : x (12 + j)%nat = on_doubles w (Add (Var (9 + j)) (Var (12 + j)))).
      { apply Part. destruct j as [|[|[|j]]]; [reflexivity | reflexivity | reflexivity | lia]. }
      rewrite E in Fj |- *. exact (add_parts w _ _ Fj). }
    destruct (P 0%nat ltac:(lia)) as [A0 [B0 E0]]. destruct (P 1%nat ltac:(lia)) as [A1 [B1 E1]].
    destruct (P 2%nat ltac:(lia)) as [A2 [B2 E2]]. cbn [Nat.add] in *. split; [|split].
    - apply (vector_is_near polygon_pairs y 2). intros [|[|[|i]]] Hi; [exact A0 | exact A1 | exact A2 | lia].
    - apply (vector_is_near polygon_pairs y 3). intros [|[|[|i]]] Hi; [exact B0 | exact B1 | exact B2 | lia].
    - unfold value_of_vector, radd. cbn [Nat.mul Nat.add]. rewrite E0, E1, E2. reflexivity. }
  assert (Square : (forall n, (6 <= n <= 23)%nat -> n <> 11%nat -> finite (x n)) ->
    square_in_range x seen_square_size -> L * L * (1 - 14 * u) <= val (x 16%nat)).
  { intros F R. destruct (Seen R) as [_ [_ [HG Low]]]. assert (F16 := F 16%nat ltac:(lia) ltac:(lia)).
    rewrite (Part 16%nat (squared (Add (Root (seen_square 1 2)) (Add (Root (square 3)) (Root (square 4))))) eq_refl)
      in F16 |- *.
    destruct (mul_parts w _ _ F16) as [Fs [_ E]]. destruct (add_parts w _ _ Fs) as [Fr [Fd E1]].
    destruct (root_parts w _ Fr) as [_ E2]. destruct (add_parts w _ _ Fd) as [F3 [F4 E3]].
    destruct (root_parts w _ F3) as [Fq3 E4]. destruct (root_parts w _ F4) as [Fq4 E5].
    destruct (square_back w 3 Fq3) as [_ E6]. destruct (square_back w 4 Fq4) as [_ E7].
    unfold squared. rewrite E, E1, E2, E3, E4, E5, E6, E7. destruct (Drop F) as [[_ V3] [[_ V4] _]].
    exact (size_of_polygon G _ (d 3%nat) (d 4%nat) (v 3%nat) (v 4%nat) (proj1 HG) Low (fmt_rnd _) V3 V4). }
  assert (R6 : square_in_range x (square 6) -> vapprox 1 (v 5%nat) (d 5%nat) /\ / 10 ^ 26 <= len (d 5%nat) <= 10 ^ 26).
  { intro R. apply (edge_of_passage polygon_pairs y 4).
    exact (square_in_range_same x w (square 6) (square 5) eq_refl R). }
  assert (R7 : square_in_range x (square 7) -> vapprox 1 (v 6%nat) (d 6%nat) /\ / 10 ^ 26 <= len (d 6%nat) <= 10 ^ 26).
  { intro R. apply (edge_of_passage polygon_pairs y 5).
    exact (square_in_range_same x w (square 7) (square 6) eq_refl R). }
  split.
  - exact Poly.
  - rewrite (Part 16%nat (squared (Add (Root (seen_square 1 2)) (Add (Root (square 3)) (Root (square 4))))) eq_refl).
    apply squared_positive.
  - rewrite (Part 17%nat (ratio_of_areas 3 7) eq_refl). apply ratio_positive.
  - intros F R. destruct (Drop F) as [[F3 V3] [[F4 V4] Ed]].
    assert (ED : D (p 0%nat) (p 1%nat) (p 3%nat) (p 4%nat) = vadd (d 3%nat) (d 4%nat)).
    { rewrite D3, D4. apply vec_eq; cbn; ring. }
    apply (inputs_of_passage polygon_pairs y (VPlus (Given 3) (Given 4)) (Given 5) (Given 6) (Dot (Given 3) (Given 7))
      (squared (Add (Root (seen_square 1 2)) (Add (Root (square 3)) (Root (square 4))))) (ratio_of_areas 3 7)
      _ _ _ _ _ _ _ D1 D2 F R).
    + rewrite ED. apply len_triangle.
    + rewrite ED. change (len (vsub (value_of_vector (fun n => val (x n)) 4) (vadd (d 3%nat) (d 4%nat))) <=
        2.001 * u * dd). rewrite Ed. exact (sum_is_near _ _ _ _ F3 F4 V3 V4).
    + right. reflexivity.
    + exact (Square F R).
  - intro R. destruct (R7 R) as [V6 B]. rewrite <- D6. split; [exact (vapprox_len _ _ V6) | exact B].
  - intros F R10 R6' R7' Sq La Lb Top. destruct (R6 R6') as [V5 B5]. destruct (R7 R7') as [V6 B6].
    destruct (Seen R10) as [V1 [V2 [HG _]]]. destruct (Drop F) as [[_ V3] _].
    assert (V7 : vapprox 1 (v 7%nat) (d 7%nat)).
    { assert (F15 := F 15%nat ltac:(lia) ltac:(lia)). rewrite (Part 15%nat (edot (given 3) (given 7)) eq_refl) in F15.
      apply (vector_is_near polygon_pairs y 6). intros i Hi. apply (proj1 (dot_parts w 3 7 F15) i Hi). }
    assert (L5 : len (d 5%nat) <= G).
    { rewrite <- EG. replace (d 5%nat) with (vsub (d 1%nat) (d 2%nat)); [apply edge_below_seen_size|].
      rewrite D1, D2, D5. apply vec_eq; cbn; ring. }
    assert (L1 : len (d 1%nat) <= G).
    { rewrite <- EG. eapply Rle_trans; [|apply sum_below_seen_size]. generalize (len_nonneg (d 2%nat)). lra. }
    destruct (differences_below_size G (d 5%nat) (d 3%nat) (d 4%nat) L5) as [Le [L3 L7]].
    replace (vsub (d 4%nat) (d 5%nat)) with (d 7%nat) in L7 by (rewrite D4, D5, D7; apply vec_eq; cbn; ring).
    assert (G0 := len_nonneg (d 3%nat)). assert (G1 := len_nonneg (d 4%nat)).
    rewrite <- D1 in La. rewrite <- D2 in Lb.
    apply (height_with_areas x w 3 7 (d 1%nat) (d 2%nat) (d 3%nat) (d 7%nat) (d 5%nat) (d 6%nat) L
      (Part 15%nat _ eq_refl) (Part 17%nat _ eq_refl) (F 15%nat ltac:(lia) ltac:(lia)) (F 17%nat ltac:(lia) ltac:(lia))
      V1 V2 V3 V7 V5 V6 B5 B6); try assumption; unfold L, dd in *; lra.
Qed.
End Polygon.

(* The next edge is p3p4. *)
Theorem polygon_right : forall x y sigma, let p k := point x k in
  known_on_doubles (vsub (p 1%nat) (p 0%nat)) y x ->
  polygon (p 0%nat) (p 1%nat) (p 2%nat) (p 3%nat) (p 4%nat) (p 0%nat) ->
  way_of_sign (p 0%nat) (p 1%nat) (p 2%nat) y sigma -> run x Code.AcrossPolygon.is_known = Some Positive ->
  (forall e, In e (Code.AcrossPolygon.u_x :: Code.AcrossPolygon.u_y :: Code.AcrossPolygon.u_z ::
    Code.AcrossPolygon.error :: nil) -> finite (on_doubles x e)) /\
  known (vsub (p 4%nat) (p 3%nat))
    (vscale sigma (step (p 0%nat) (p 1%nat) (p 2%nat) y (p 3%nat) (p 4%nat)))
    (V (val (on_doubles x Code.AcrossPolygon.u_x)) (val (on_doubles x Code.AcrossPolygon.u_y))
      (val (on_doubles x Code.AcrossPolygon.u_z))) (val (on_doubles x Code.AcrossPolygon.error)).
Proof.
  intros x y sigma p K Poly Way H. apply (across_right in_polygon _ _ _ _ _ _ _ x polygon_match H). intros z Run.
  destruct (direction_of_passage polygon_pairs (VPlus (Given 3) (Given 4)) (Given 5) (Given 6) (Dot (Given 3) (Given 7))
    (squared (Add (Root (seen_square 1 2)) (Add (Root (square 3)) (Root (square 4))))) (ratio_of_areas 3 7)
    _ _ _ K) as [F Kx].
  exact (behind_right _ _ _ _ _ _ _ _ _ _ _ (polygon_is_good x Poly) F Kx Way Run).
Qed.
