(* The position of a crossing, x' = m + h U / <U,g>, and its bound (`sphere_at_crossing` of
   src/flow/kernels/crossing_sphere.h; src/flow/cascades.md, "The value of a crossing"): each coordinate is as near to
   the true one as the code says, if the direction U is known. This is about real numbers. Each operation has a relative
   error of at most w, and an error of at most nu where it underflows. The bound is made of such operations, too. *)
From Coq Require Import Reals ZArith QArith Qreals Lra Lia Psatz Bool List.
From Flocq Require Import Core.
From Flowcert Require Import algebra.Vector3 code.Expression code.generated.Constants filters.Rounding
  filters.RoundedVectors filters.Norms filters.Terms filters.Filter filters.Directions filters.DirectionGiven.
Open Scope R_scope.

(* ---- The constants ---- *)

Definition number (k : Z * Z) := F2R (Float radix2 (fst k) (snd k)).
Definition is_at_least (needs : Q) (k : Z * Z) := Qle_bool needs (rational (fst k) (snd k)).
Lemma at_least_number : forall needs k, is_at_least needs k = true -> Q2R needs <= number k.
Proof.
  intros needs k H. apply Qle_bool_iff, Qle_Rle in H. rewrite rational_value in H. exact H.
Qed.
Lemma exit_at_least : 19.4 <= number kExitBound.
Proof.
  replace 19.4 with (Q2R (194 # 10)) by (unfold Q2R; cbn; lra). apply at_least_number. vm_compute. reflexivity.
Qed.
Lemma angle_form_at_least : 1.31 <= number kAngleFormBound.
Proof.
  replace 1.31 with (Q2R (131 # 100)) by (unfold Q2R; cbn; lra). apply at_least_number. vm_compute. reflexivity.
Qed.
Lemma slack_at_least : 1.0001 <= number kCrossingSlack.
Proof.
  replace 1.0001 with (Q2R (10001 # 10000)) by (unfold Q2R; cbn; lra). apply at_least_number. vm_compute. reflexivity.
Qed.

Lemma coordinate_at_least : 1.01 <= number kCoordinateBound.
Proof.
  replace 1.01 with (Q2R (101 # 100)) by (unfold Q2R; cbn; lra). apply at_least_number. vm_compute. reflexivity.
Qed.

(* ---- The true direction ---- *)

(* U is as near to a positive multiple of the true direction as its error says. *)
Lemma true_multiple : forall w e y U t, 0 <= w -> known_within w e y U t -> exists s, 0 < s /\
  len (vsub U (vscale s y)) <= (t + 12 * w) * (1 + 16 * w) /\ len (vscale s y) <= 1 + 16 * w.
Proof.
  intros w e y U t W [F L Lv Turn E]. destruct (parts_of_turned _ _ _ Turn) as [s [D [S [P [O T]]]]].
  exists s. split; [exact S|].
  generalize (len_nonneg U) (len_nonneg y) (len_nonneg D). intros LU Ly LD.
  set (k := vscale (dot U e / dot e e) e). assert (K : len k <= 12 * w * len U) by (apply leaving_len; lra).
  assert (Q : len (vscale s y) <= len U).
  { apply Rle_trans with (len (in_plane e U)).
    - rewrite P. apply part_is_shorter.
      replace (dot (vscale s y) D) with (s * dot D y) by (unfold dot, vscale; cbn; ring). rewrite O. ring.
    - rewrite (whole_of_parts e U) at 2. apply part_is_shorter, across_plane. }
  split; [|lra]. assert (X : vsub U (vscale s y) = vadd D k).
  { rewrite (whole_of_parts e U) at 1. rewrite P. fold k. generalize k. clear. intro k. vdestruct. apply vec_eq; cbn;
    ring. }
  rewrite X. eapply Rle_trans; [apply len_triangle|]. rewrite <- len_scale in T by lra.
  assert (D1 : t * len (vscale s y) <= t * len U) by (apply Rmult_le_compat_l; lra).
  rewrite len_scale in D1 at 1 by lra. rewrite len_scale in T by lra.
  assert (D2 : (t + 12 * w) * len U <= (t + 12 * w) * (1 + 16 * w)) by (apply Rmult_le_compat_l; lra). lra.
Qed.

Lemma dot_of_difference : forall A U Y g, A - dot Y g = (A - dot U g) + dot (vsub U Y) g.
Proof. intros. vdestruct. vunfold. ring. Qed.
Lemma dot_of_multiple : forall s y g, dot (vscale s y) g = s * dot y g.
Proof. intros. vdestruct. vunfold. ring. Qed.
(* i and j stand for 1 / <U,g> as it is computed and in truth. *)
Lemma parts_of_way : forall step U Y factor H h i j, vsub step (vscale (h * j) Y) =
  vadd (vsub step (vscale factor U)) (vadd (vscale (factor - H * i) U) (vadd (vscale ((H - h) * i) U)
    (vadd (vscale (h * i) (vsub U Y)) (vscale (h * i - h * j) Y)))).
Proof. intros. vdestruct. apply vec_eq; cbn; ring. Qed.
Lemma same_multiple : forall h d s y, s <> 0 -> d <> 0 -> vscale (h / d) y = vscale (h / (s * d)) (vscale s y).
Proof. intros. vdestruct. apply vec_eq; cbn; field; auto. Qed.

Section Position.
Variables w nu : R.

(* What is computed for X. *)
Definition near x X := Rabs (x - X) <= w * Rabs X + nu.

(* G is the length that the bounds are made of, and S and size are computed for its square and for G. *)
Variables (e y U g : vec) (t h G A H S size : R).
(* What the code computes from these. *)
Variables turn alpha height_bound rest ratio spread height_sum product sum quotient error : R.

Hypothesis roundoff : 0 < w <= / 10 ^ 30.
Hypothesis underflow : 0 <= nu /\ nu <= / 10 ^ 20 * (w * w) /\ nu <= / 10 ^ 20 * (w * w) * G /\
  nu <= / 10 ^ 20 * (w * w) * (G * G).
Hypothesis known_direction : known_within w e y U t.
Hypothesis seen_size : 0 < G /\ len g <= G.
(* The table of cascades.md, "Notation". *)
Hypothesis approach_right : Rabs (A - dot U g) <= 5.2 * w * G.
Hypothesis height_right : Rabs (H - h) <= 1.3 * w * (G * G).
Hypothesis square_right : G * G * (1 - 8 * w) <= S.
Hypothesis size_right : G * (1 - 5 * w) <= size.

Hypothesis turn_near : near turn (t + number kExitBound * w).
Hypothesis alpha_near : near alpha (turn * size).
Hypothesis is_long : 2 * alpha < Rabs A.
Hypothesis height_bound_near : near height_bound (number kAngleFormBound * w * S).
Hypothesis rest_near : near rest (Rabs A - alpha).
Hypothesis ratio_near : near ratio (alpha / rest).
Hypothesis spread_near : near spread (turn + ratio).
Hypothesis height_sum_near : near height_sum (Rabs H + height_bound).
Hypothesis product_near : near product (height_sum * spread).
Hypothesis sum_near : near sum (height_bound + product).
Hypothesis quotient_near : near quotient (sum / Rabs A).
Hypothesis error_near : near error (quotient * number kCrossingSlack).

Lemma near_below : forall x X, near x X -> 0 <= X -> X * (1 - w) - nu <= x.
Proof. intros x X N P. unfold near in N. rewrite (Rabs_pos_eq X P) in N. apply Rabs_le_inv in N. lra. Qed.
Lemma near_above : forall x X, near x X -> 0 <= X -> x <= X * (1 + w) + nu.
Proof. intros x X N P. unfold near in N. rewrite (Rabs_pos_eq X P) in N. apply Rabs_le_inv in N. lra. Qed.

(* What underflows is far less than all bounds. *)
Lemma tiny_squares : w * w <= / 10 ^ 30 * w /\ w * w * G <= / 10 ^ 30 * (w * G) /\
  w * w * (G * G) <= / 10 ^ 30 * (w * (G * G)) /\ 0 < w * G /\ 0 < w * (G * G).
Proof.
  destruct seen_size as [G0 _]. assert (GG : 0 < G * G) by (apply Rmult_lt_0_compat; exact G0).
  assert (W : w * w <= / 10 ^ 30 * w) by (apply Rmult_le_compat_r; lra). split; [exact W|].
  split; [|split; [|split; apply Rmult_lt_0_compat; lra]].
  - rewrite <- (Rmult_assoc (/ 10 ^ 30)). apply Rmult_le_compat_r; lra.
  - rewrite <- (Rmult_assoc (/ 10 ^ 30)). apply Rmult_le_compat_r; lra.
Qed.
Lemma tiny : 0 <= nu /\ nu <= / 10 ^ 50 * w /\ nu <= / 10 ^ 50 * (w * G) /\ nu <= / 10 ^ 50 * (w * (G * G)).
Proof. destruct underflow as [N0 [N1 [N2 N3]]], tiny_squares as [W1 [W2 [W3 _]]]. repeat split; lra. Qed.

Lemma turn_low : t + 19.3 * w <= turn.
Proof.
  destruct known_direction as [_ _ _ _ T]. destruct tiny as [N0 [N1 _]], tiny_squares as [W1 _].
  assert (K := exit_at_least).
  assert (P : 19.4 * w <= number kExitBound * w) by (apply Rmult_le_compat_r; lra).
  assert (B := near_below _ _ turn_near ltac:(lra)).
  assert (B1 : (t + 19.4 * w) * (1 - w) <= (t + number kExitBound * w) * (1 - w)) by (apply Rmult_le_compat_r; lra).
  assert (t * w <= 3 / 32 * w) by (apply Rmult_le_compat_r; lra). lra.
Qed.

Lemma alpha_low : (t + 18.72 * w) * G <= alpha.
Proof.
  destruct known_direction as [_ _ _ _ T]. destruct tiny as [N0 [N1 [N2 _]]], tiny_squares as [W1 [_ [_ [W4 _]]]].
  assert (L := turn_low). destruct seen_size as [G0 _].
  assert (D : (t + 19.3 * w) * (G * (1 - 5 * w)) <= turn * size).
  { apply Rmult_le_compat; try lra. apply Rmult_le_pos; lra. }
  assert (D0 : 0 <= (t + 19.3 * w) * (G * (1 - 5 * w))) by (apply Rmult_le_pos; [lra | apply Rmult_le_pos; lra]).
  assert (B := near_below _ _ alpha_near ltac:(lra)).
  assert (B1 : (t + 19.3 * w) * (G * (1 - 5 * w)) * (1 - w) <= turn * size * (1 - w))
    by (apply Rmult_le_compat_r; lra).
  assert (C : t + 18.73 * w <= (t + 19.3 * w) * ((1 - 5 * w) * (1 - w))).
  { assert (P : (t + 19.3 * w) * (1 - 6 * w) <= (t + 19.3 * w) * ((1 - 5 * w) * (1 - w))).
    { apply Rmult_le_compat_l; [lra|]. assert (S2 := Rle_0_sqr w). unfold Rsqr in S2. lra. }
    assert (t * w <= 3 / 32 * w) by (apply Rmult_le_compat_r; lra). lra. }
  assert (C1 : (t + 18.73 * w) * G <= (t + 19.3 * w) * ((1 - 5 * w) * (1 - w)) * G)
    by (apply Rmult_le_compat_r; lra).
  lra.
Qed.

(* ---- The bound ---- *)

Let a := Rabs A.
Let rho := alpha / (a - alpha).
Let hs := Rabs H + height_bound.
Let spread_low := t + 19.2 * w + rho.
Let least := height_bound + hs * spread_low.

Lemma approach_size : a <= 1.001 * G.
Proof.
  destruct known_direction as [_ L _ _ _], seen_size as [G0 Hg]. destruct tiny_squares as [_ [_ [_ [W4 _]]]].
  assert (B := dot_len U g). assert (P : len U * len g <= (1 + 16 * w) * G).
  { apply Rmult_le_compat; auto using len_nonneg. }
  assert (R : w * G <= / 10 ^ 30 * G) by (apply Rmult_le_compat_r; lra).
  unfold a. replace A with (dot U g + (A - dot U g)) by ring.
  eapply Rle_trans; [apply Rabs_triang|]. lra.
Qed.

Lemma alpha_size : 0 < alpha < a - alpha /\ 18 * (w * G) <= alpha.
Proof.
  assert (L := alpha_low). destruct known_direction as [_ _ _ _ T], seen_size as [G0 _].
  destruct tiny_squares as [_ [_ [_ [W4 _]]]]. assert (0 <= t * G) by (apply Rmult_le_pos; lra).
  unfold a. split; [split|]; lra.
Qed.

Lemma ratio_low : 0 < rho <= 1 /\ rho * 0.9999999 - nu <= ratio.
Proof.
  destruct alpha_size as [[A0 A1] A2], underflow as [N0 [_ [N2 _]]], tiny_squares as [W1 [W2 [_ [W4 _]]]].
  set (r := a - alpha) in *. assert (r0 : 0 < r) by lra.
  assert (E : rho * r = alpha) by (unfold rho; fold r; field; lra).
  assert (P : 0 < rho) by (unfold rho; fold r; apply Rdiv_lt_0_compat; lra).
  assert (P1 : rho <= 1) by (apply Rmult_le_reg_r with r; lra).
  split; [lra|]. change (near rest r) in rest_near.
  assert (X1 := near_above _ _ rest_near ltac:(lra)). assert (X2 := near_below _ _ rest_near ltac:(lra)).
  assert (Q : w * (18 * (w * G)) <= w * r) by (apply Rmult_le_compat_l; lra).
  assert (wr : w * r <= / 10 ^ 30 * r) by (apply Rmult_le_compat_r; lra).
  assert (Y : rest <= r * (1 + 2 * w)) by lra. assert (Y0 : 0 < rest) by lra.
  assert (Z : rho * (1 - 2 * w) <= alpha / rest).
  { apply Rmult_le_reg_r with rest; [exact Y0|]. replace (alpha / rest * rest) with alpha by (field; lra).
    apply Rle_trans with (rho * (1 - 2 * w) * (r * (1 + 2 * w))).
    - apply Rmult_le_compat_l; [apply Rmult_le_pos; lra | exact Y].
    - replace (rho * (1 - 2 * w) * (r * (1 + 2 * w))) with (rho * r * (1 - 4 * (w * w))) by ring. rewrite E.
      assert (0 <= alpha * (w * w)) by (apply Rmult_le_pos; [lra | apply Rle_0_sqr]). lra. }
  assert (Z0 : 0 <= rho * (1 - 2 * w)) by (apply Rmult_le_pos; lra).
  assert (B := near_below _ _ ratio_near ltac:(lra)).
  assert (B1 : rho * (1 - 2 * w) * (1 - w) <= alpha / rest * (1 - w)) by (apply Rmult_le_compat_r; lra).
  assert (B2 : rho * 0.9999999 <= rho * ((1 - 2 * w) * (1 - w))).
  { apply Rmult_le_compat_l; [lra|]. assert (S2 := Rle_0_sqr w). unfold Rsqr in S2. lra. }
  lra.
Qed.

Lemma spread_at_least : spread_low * 0.999999 <= spread /\ 0 < spread_low.
Proof.
  destruct ratio_low as [R0 R1], tiny as [N0 [N1 _]]. assert (L := turn_low).
  destruct known_direction as [_ _ _ _ T].
  assert (B := near_below _ _ spread_near ltac:(lra)).
  assert (B1 : (t + 19.3 * w + (rho * 0.9999999 - nu)) * (1 - w) <= (turn + ratio) * (1 - w))
    by (apply Rmult_le_compat_r; lra).
  assert (B2 : (t + 19.3 * w + (rho * 0.9999999 - nu)) * 0.9999999 <=
    (t + 19.3 * w + (rho * 0.9999999 - nu)) * (1 - w)) by (apply Rmult_le_compat_l; lra).
  unfold spread_low. lra.
Qed.

Lemma height_bound_low : 1.305 * (w * (G * G)) <= height_bound.
Proof.
  destruct tiny as [N0 [_ [_ N3]]], tiny_squares as [_ [_ [W3 [_ W5]]]]. assert (K := angle_form_at_least).
  assert (P0 : 0 <= G * G * (1 - 8 * w)) by (apply Rmult_le_pos; [apply Rle_0_sqr | lra]).
  assert (P1 : 1.31 * w * (G * G * (1 - 8 * w)) <= number kAngleFormBound * w * S).
  { apply Rmult_le_compat; try lra. apply Rmult_le_compat_r; lra. }
  assert (P2 : 0 <= 1.31 * w * (G * G * (1 - 8 * w))) by (apply Rmult_le_pos; lra).
  assert (B := near_below _ _ height_bound_near ltac:(lra)).
  assert (B1 : 1.31 * w * (G * G * (1 - 8 * w)) * 0.9999 <= number kAngleFormBound * w * S * (1 - w)).
  { apply Rmult_le_compat; lra. }
  lra.
Qed.

Lemma error_low : 1.00008 * least <= error * a /\ 1.305 * (w * (G * G)) <= least.
Proof.
  destruct tiny as [N0 [N1 [N2 N3]]], tiny_squares as [_ [_ [_ [W4 W5]]]], alpha_size as [[A0 A1] _].
  assert (HB := height_bound_low). destruct spread_at_least as [S1 S0]. assert (AG := approach_size).
  destruct seen_size as [G0 _]. assert (HH := Rabs_pos H).
  assert (Na : nu * a <= / 10 ^ 49 * (w * (G * G))).
  { apply Rle_trans with (/ 10 ^ 50 * (w * G) * (1.001 * G)); [apply Rmult_le_compat; lra | lra]. }
  assert (Hs : hs * 0.999999 <= height_sum).
  { assert (B := near_below _ _ height_sum_near ltac:(lra)). fold hs in B.
    assert (hs * w <= hs * / 10 ^ 30) by (apply Rmult_le_compat_l; unfold hs; lra). unfold hs in *. lra. }
  assert (Hs0 : 0 < hs) by (unfold hs; lra).
  set (m := hs * spread_low) in *. assert (m0 : 0 < m) by (apply Rmult_lt_0_compat; lra).
  assert (Pr : m * 0.999997 - nu <= product).
  { assert (D : hs * 0.999999 * (spread_low * 0.999999) <= height_sum * spread) by (apply Rmult_le_compat; lra).
    replace (hs * 0.999999 * (spread_low * 0.999999)) with (m * (0.999999 * 0.999999)) in D by (unfold m; ring).
    assert (B := near_below _ _ product_near ltac:(lra)).
    assert (B1 : m * (0.999999 * 0.999999) * 0.9999999 <= height_sum * spread * (1 - w))
      by (apply Rmult_le_compat; lra).
    lra. }
  assert (L0 : 0 < least) by (unfold least; fold m; lra).
  assert (Su : least * 0.999995 <= sum).
  { assert (B := near_below _ _ sum_near ltac:(lra)).
    assert (B1 : (height_bound + (m * 0.999997 - nu)) * 0.9999999 <= (height_bound + product) * (1 - w))
      by (apply Rmult_le_compat; lra).
    unfold least. fold m. lra. }
  assert (a0 : 0 < a) by lra. assert (LB : 1.305 * (w * (G * G)) <= least) by (unfold least; fold m; lra).
  assert (Qu : least * 0.999993 <= quotient * a).
  { assert (D : sum / a * a = sum) by (field; lra). assert (D0 : 0 <= sum / a).
    { apply Rmult_le_pos; [lra | left; apply Rinv_0_lt_compat, a0]. }
    assert (B := near_below _ _ quotient_near D0). fold a in B.
    assert (B1 : (sum / a * (1 - w) - nu) * a <= quotient * a) by (apply Rmult_le_compat_r; lra).
    replace ((sum / a * (1 - w) - nu) * a) with (sum / a * a * (1 - w) - nu * a) in B1 by ring. rewrite D in B1.
    assert (least * 0.999995 * 0.9999999 <= sum * (1 - w)) by (apply Rmult_le_compat; lra). lra. }
  split; [|exact LB]. assert (K := slack_at_least).
  assert (q0 : 0 <= quotient).
  { apply Rnot_lt_le. intro N. assert (quotient * a < 0) by (apply Ropp_lt_cancel; rewrite Ropp_0, Ropp_mult_distr_l;
    apply Rmult_lt_0_compat; lra). lra. }
  assert (D0 : 0 <= quotient * number kCrossingSlack) by (apply Rmult_le_pos; lra).
  assert (B := near_below _ _ error_near D0).
  assert (B1 : (quotient * number kCrossingSlack * (1 - w) - nu) * a <= error * a) by (apply Rmult_le_compat_r; lra).
  assert (B2 : quotient * a * (1.0001 * 0.9999999) <= quotient * a * (number kCrossingSlack * (1 - w))).
  { apply Rmult_le_compat_l; [lra|]. apply Rmult_le_compat; lra. }
  lra.
Qed.

(* ---- The way from the midpoint ---- *)

Variables (factor : R) (step : vec).
Hypothesis factor_near : near factor (H / A).
Hypothesis step_near : forall c, In c (cons vx (cons vy (cons vz nil))) -> near (c step) (factor * c U).

(* x' - m in truth. *)
Definition true_way := vscale (h / dot y g) y.

Lemma way_near : dot y g <> 0 /\ len (vsub step true_way) * a <= 1.00001 * least.
Proof.
  destruct known_direction as [F LU Lv Turn T]. destruct seen_size as [G0 Hg].
  destruct tiny as [N0 [N1 [N2 N3]]], tiny_squares as [_ [_ [_ [W4 W5]]]], alpha_size as [[A0 A1] _].
  destruct ratio_low as [R0 _].
  assert (AG := approach_size). assert (HB := height_bound_low). assert (AL := alpha_low).
  destruct (true_multiple w e y U t ltac:(lra) known_direction) as [s [S0 [D1 D2]]].
  set (Y := vscale s y) in *. set (b := dot Y g).
  assert (gam : (t + 12 * w) * (1 + 16 * w) <= t + 13.51 * w).
  { assert (t * w <= 3 / 32 * w) by (apply Rmult_le_compat_r; lra).
    assert (w * w <= / 10 ^ 30 * w) by (apply Rmult_le_compat_r; lra). lra. }
  assert (NearA : Rabs (A - b) <= alpha).
  { unfold b. rewrite (dot_of_difference A U Y g).
    eapply Rle_trans; [apply Rabs_triang|]. assert (B := dot_len (vsub U Y) g).
    assert (P : len (vsub U Y) * len g <= (t + 13.51 * w) * G)
      by (apply Rmult_le_compat; try apply len_nonneg; lra). lra. }
  assert (BA : a - alpha <= Rabs b).
  { unfold a. replace A with ((A - b) + b) by ring. assert (X := Rabs_triang (A - b) b). lra. }
  assert (b0 : b <> 0) by (intro Z; rewrite Z, Rabs_R0 in BA; lra).
  assert (yg : dot y g <> 0).
  { intro Z. apply b0. unfold b, Y. rewrite dot_of_multiple, Z. ring. }
  split; [exact yg|].
  assert (a0 : 0 < a) by lra. assert (An : A <> 0) by (intro Z; unfold a in a0; rewrite Z, Rabs_R0 in a0; lra).
  assert (True : true_way = vscale (h / b) Y).
  { unfold true_way, b, Y. rewrite dot_of_multiple. apply same_multiple; [lra | exact yg]. }
  rewrite True.
  set (v1 := vsub step (vscale factor U)). set (v2 := vscale (factor - H / A) U).
  set (v3 := vscale ((H - h) / A) U). set (v4 := vscale (h / A) (vsub U Y)). set (v5 := vscale (h / A - h / b) Y).
  assert (Sum : vsub step (vscale (h / b) Y) = vadd v1 (vadd v2 (vadd v3 (vadd v4 v5)))).
  { unfold v1, v2, v3, v4, v5, Rdiv. apply parts_of_way. }
  assert (Tri : len (vsub step (vscale (h / b) Y)) <= len v1 + (len v2 + (len v3 + (len v4 + len v5)))).
  { rewrite Sum. eapply Rle_trans; [apply len_triangle|]. apply Rplus_le_compat_l.
    eapply Rle_trans; [apply len_triangle|]. apply Rplus_le_compat_l.
    eapply Rle_trans; [apply len_triangle|]. apply Rplus_le_compat_l. apply len_triangle. }
  assert (Over : forall x, Rabs (x / A) * a = Rabs x).
  { intro x. unfold a. rewrite <- Rabs_mult. f_equal. field. exact An. }
  assert (H1 := Rabs_pos H). assert (h1 := Rabs_pos h). assert (hh : Rabs h <= hs).
  { unfold hs. replace h with (H - (H - h)) by ring. unfold Rminus at 1. eapply Rle_trans; [apply Rabs_triang|].
    rewrite Rabs_Ropp. lra. }
  assert (Hhs : Rabs H <= hs) by (unfold hs; lra). assert (hs0 : 0 < hs) by (unfold hs; lra).
  assert (Na : 0 <= nu * a <= / 10 ^ 49 * (w * (G * G))).
  { split; [apply Rmult_le_pos; lra|].
    apply Rle_trans with (/ 10 ^ 50 * (w * G) * (1.001 * G)); [apply Rmult_le_compat; lra | lra]. }
  assert (LU1 : len U <= 1.0001) by lra. assert (LU0 := len_nonneg U).
  assert (Fa : Rabs (factor - H / A) * a <= w * Rabs H + nu * a).
  { apply Rle_trans with ((w * Rabs (H / A) + nu) * a); [apply Rmult_le_compat_r; [lra | exact factor_near]|].
    rewrite Rmult_plus_distr_r, Rmult_assoc, Over. lra. }
  assert (wH : 0 <= w * Rabs H <= w * hs) by (split; [apply Rmult_le_pos | apply Rmult_le_compat_l]; lra).
  assert (Fb : Rabs factor * a <= Rabs H + w * hs + nu * a).
  { replace factor with (H / A + (factor - H / A)) by ring.
    apply Rle_trans with ((Rabs (H / A) + Rabs (factor - H / A)) * a);
      [apply Rmult_le_compat_r; [lra | apply Rabs_triang]|]. rewrite Rmult_plus_distr_r, Over. lra. }
  assert (whs : w * hs <= / 10 ^ 30 * hs) by (apply Rmult_le_compat_r; lra).
  assert (B1 : len v1 * a <= 1.0002 * (w * hs) + 3 * (nu * a)).
  { apply Rle_trans with ((w * (Rabs factor * len U) + 2 * nu) * a).
    - apply Rmult_le_compat_r; [lra|].
      apply Rle_trans with (len (vadd (vscale w (vabs (vscale factor U))) (V nu nu nu))).
      + unfold v1. apply len_mono; unfold vscale, vabs, vadd, vsub; cbn [vx vy vz]; apply step_near; cbn; auto.
      + eapply Rle_trans; [apply len_triangle|]. rewrite len_scale, len_vabs, len_scale_any by lra.
        apply Rplus_le_compat_l. apply len_le; [lra|]. unfold dot. cbn. assert (Q := Rle_0_sqr nu). unfold Rsqr in Q.
        lra.
    - replace ((w * (Rabs factor * len U) + 2 * nu) * a) with (w * (Rabs factor * a * len U) + 2 * (nu * a)) by ring.
      assert (P : Rabs factor * a * len U <= (1.0000001 * hs + nu * a) * 1.0001).
      { apply Rmult_le_compat; try lra. apply Rmult_le_pos; [apply Rabs_pos | lra]. }
      assert (P1 : w * (Rabs factor * a * len U) <= w * ((1.0000001 * hs + nu * a) * 1.0001))
        by (apply Rmult_le_compat_l; lra).
      assert (P2 : w * (nu * a) <= / 10 ^ 30 * (nu * a)) by (apply Rmult_le_compat_r; lra). lra. }
  assert (B2 : len v2 * a <= 1.0001 * (w * hs) + 2 * (nu * a)).
  { unfold v2. rewrite len_scale_any.
    replace (Rabs (factor - H / A) * len U * a) with (Rabs (factor - H / A) * a * len U) by ring.
    apply Rle_trans with ((w * hs + nu * a) * 1.0001); [|lra].
    apply Rmult_le_compat; try lra. apply Rmult_le_pos; [apply Rabs_pos | lra]. }
  assert (B3 : len v3 * a <= 1.3002 * (w * (G * G))).
  { unfold v3. rewrite len_scale_any.
    replace (Rabs ((H - h) / A) * len U * a) with (Rabs ((H - h) / A) * a * len U) by ring. rewrite Over.
    apply Rle_trans with (1.3 * w * (G * G) * 1.0001); [|lra]. apply Rmult_le_compat; try lra. apply Rabs_pos. }
  assert (B4 : len v4 * a <= hs * (t + 13.51 * w)).
  { unfold v4. rewrite len_scale_any.
    replace (Rabs (h / A) * len (vsub U Y) * a) with (Rabs (h / A) * a * len (vsub U Y)) by ring. rewrite Over.
    apply Rmult_le_compat; try lra. apply len_nonneg. }
  assert (B5 : len v5 * a <= hs * (rho * 1.00001)).
  { unfold v5. rewrite len_scale_any.
    replace (h / A - h / b) with (h / A * ((b - A) / b)) by (field; auto). rewrite Rabs_mult.
    replace (Rabs (h / A) * Rabs ((b - A) / b) * len Y * a) with (Rabs (h / A) * a * (Rabs ((b - A) / b) * len Y))
      by ring. rewrite Over.
    assert (Ra : Rabs ((b - A) / b) <= rho).
    { unfold Rdiv. rewrite Rabs_mult, Rabs_inv, Rabs_minus_sym. unfold rho, Rdiv.
      apply Rmult_le_compat; [apply Rabs_pos | left; apply Rinv_0_lt_compat; lra | exact NearA |].
      apply Rinv_le; [lra | exact BA]. }
    apply Rmult_le_compat; try lra.
    - apply Rmult_le_pos; [apply Rabs_pos | apply len_nonneg].
    - apply Rmult_le_compat; try lra; [apply Rabs_pos | apply len_nonneg]. }
  assert (Tri2 := Rmult_le_compat_r a _ _ ltac:(lra) Tri).
  unfold least, spread_low. assert (0 <= hs * t) by (apply Rmult_le_pos; lra).
  assert (0 <= hs * rho) by (apply Rmult_le_pos; lra). lra.
Qed.

Lemma way_right : 1.00002 * len (vsub step true_way) + 1000 * nu <= error.
Proof.
  destruct way_near as [_ L], error_low as [E B], tiny as [N0 [N1 [N2 N3]]], alpha_size as [[A0 A1] _].
  assert (AG := approach_size). destruct seen_size as [G0 _], tiny_squares as [_ [_ [_ [W4 W5]]]].
  assert (Na : nu * a <= / 10 ^ 49 * (w * (G * G))).
  { apply Rle_trans with (/ 10 ^ 50 * (w * G) * (1.001 * G)); [apply Rmult_le_compat; lra | lra]. }
  apply Rmult_le_reg_r with a; lra.
Qed.

(* ---- A coordinate ---- *)

Variables middle_true middle value sizes part bound : R.
Variable coordinate : vec -> R.
Hypothesis is_coordinate : In coordinate (cons vx (cons vy (cons vz nil))).
Hypothesis middle_near : near middle middle_true.
Hypothesis value_near : near value (middle + coordinate step).
Hypothesis sizes_near : near sizes (Rabs middle + Rabs value).
Hypothesis sizes_positive : 0 <= sizes.
Hypothesis part_near : near part (number kCoordinateBound * w * sizes).
Hypothesis bound_near : near bound (error + part).

Theorem position_right : dot y g <> 0 /\ Rabs (value - (middle_true + coordinate true_way)) <= bound.
Proof.
  destruct way_near as [Y _]. split; [exact Y|]. assert (L := way_right). destruct tiny as [N0 [N1 _]].
  set (d := vsub step true_way) in *. assert (Ld := len_nonneg d).
  assert (Cd : Rabs (coordinate step - coordinate true_way) <= len d).
  { destruct (coordinate_bound d _ (Rle_refl _)) as [C1 [C2 C3]].
    destruct is_coordinate as [<-|[<-|[<-|[]]]]; assumption. }
  unfold near in middle_near, value_near.
  assert (M0 := Rabs_pos middle). assert (V0 := Rabs_pos value). assert (T0 := Rabs_pos middle_true).
  assert (M1 : Rabs middle_true <= 1.001 * (Rabs middle + nu)).
  { assert (X := Rabs_triang middle (- (middle - middle_true))). rewrite Rabs_Ropp in X.
    replace (middle + - (middle - middle_true)) with middle_true in X by ring.
    assert (w * Rabs middle_true <= / 10 ^ 30 * Rabs middle_true) by (apply Rmult_le_compat_r; lra). lra. }
  set (z := middle + coordinate step) in *. assert (z0 := Rabs_pos z).
  assert (V1 : Rabs z <= 1.001 * (Rabs value + nu)).
  { assert (X := Rabs_triang value (- (value - z))). rewrite Rabs_Ropp in X.
    replace (value + - (value - z)) with z in X by ring.
    assert (w * Rabs z <= / 10 ^ 30 * Rabs z) by (apply Rmult_le_compat_r; lra). lra. }
  assert (M2 : w * Rabs middle_true <= w * (1.001 * (Rabs middle + nu))) by (apply Rmult_le_compat_l; lra).
  assert (V2 : w * Rabs z <= w * (1.001 * (Rabs value + nu))) by (apply Rmult_le_compat_l; lra).
  assert (wn : w * nu <= / 10 ^ 30 * nu) by (apply Rmult_le_compat_r; lra).
  assert (E : Rabs (value - (middle_true + coordinate true_way)) <=
    len d + 1.001 * w * (Rabs middle + Rabs value) + 3 * nu).
  { replace (value - (middle_true + coordinate true_way)) with
      ((value - z) + ((middle - middle_true) + (coordinate step - coordinate true_way))) by (unfold z; ring).
    eapply Rle_trans; [apply Rabs_triang|]. assert (X := Rabs_triang (middle - middle_true)
      (coordinate step - coordinate true_way)). lra. }
  eapply Rle_trans; [exact E|].
  set (q := Rabs middle + Rabs value) in *. assert (q0 : 0 <= q) by (unfold q; lra).
  assert (S1 := near_below _ _ sizes_near q0). assert (K := coordinate_at_least).
  assert (wq : w * (q * w) <= w * (q * / 10 ^ 30)).
  { apply Rmult_le_compat_l; [lra|]. apply Rmult_le_compat_l; lra. }
  assert (P0 : 0 <= w * sizes) by (apply Rmult_le_pos; lra).
  assert (P1 : 1.01 * (w * sizes) <= number kCoordinateBound * (w * sizes)) by (apply Rmult_le_compat_r; lra).
  assert (P2 := near_below _ _ part_near ltac:(rewrite Rmult_assoc; lra)).
  assert (P3 : 1.01 * (w * sizes) * 0.9999 <= number kCoordinateBound * w * sizes * (1 - w)).
  { apply Rmult_le_compat; lra. }
  assert (P4 : w * (q * (1 - w) - nu) <= w * sizes) by (apply Rmult_le_compat_l; lra).
  assert (wq0 : 0 <= w * q) by (apply Rmult_le_pos; lra).
  assert (P5 : 1.009 * (w * q) - 2 * nu <= part) by lra.
  assert (B0 : 0 <= error + part) by lra. assert (B := near_below _ _ bound_near B0).
  assert (B1 : (1.00002 * len d + 1000 * nu + (1.009 * (w * q) - 2 * nu)) * 0.9999999 <= (error + part) * (1 - w))
    by (apply Rmult_le_compat; lra).
  lra.
Qed.
End Position.
