(* Lengths of computed vectors and of their cross products, as the crossing of a facet uses them
   (src/flow/kernels/direction_across.h, passage()): errors counted in roundoffs from below or from above, with
   underflow. `area_here_least` and `area_there_most`: the enlarged area is no smaller than the true one, and what is
   left of the other one is no larger, but for four roundoffs. This is about real numbers. *)
From Coq Require Import Reals Lra Lia Psatz.
From Flocq Require Import Core.
From Flowcert Require Import algebra.Vector3 filters.Rounding filters.RoundedVectors filters.Norms filters.Floors
  filters.Directions filters.DirectionVectors.
Open Scope R_scope.

(* ---- Roundings that are counted from below or from above ---- *)

(* But for k roundoffs, x is at least X, or at most X. *)
Definition at_least k X x := X * (1 - k * u) <= x.
Definition at_most k X x := x <= X * (1 + k * u).

Lemma u_small : 0 < u <= / 10 ^ 15. Proof. rewrite u_val. lra. Qed.
Lemma power_positive : forall j, 0 < / 10 ^ j.
Proof. intro. apply Rinv_0_lt_compat, pow_lt. lra. Qed.
Lemma power_below : forall j k, (k <= j)%nat -> / 10 ^ j <= / 10 ^ k.
Proof. intros. apply Rinv_le; [apply pow_lt; lra | apply Rle_pow; [lra | assumption]]. Qed.
Lemma tau_power : forall j k x, (j + k <= 300)%nat -> / 10 ^ j <= x -> tau <= / 10 ^ k * x.
Proof.
  intros j k x H X. eapply Rle_trans; [apply tau_small|]. eapply Rle_trans; [apply (power_below 300 (k + j)); lia|].
  apply floor_mult; [apply Rle_refl | exact X].
Qed.

Lemma rnd_near : forall x, / 10 ^ 292 <= x -> x * (1 - 1.0001 * u) <= rnd x <= x * (1 + 1.0001 * u).
Proof.
  intros x X. assert (T := tau_power 292 8 x ltac:(lia) X). assert (P := power_positive 292).
  assert (R := rnd_any x). rewrite (Rabs_pos_eq x) in R by lra. apply Rabs_le_inv in R.
  generalize u_pos. intro U0. assert (u * tau <= u * (/ 10 ^ 8 * x)) by (apply Rmult_le_compat_l; lra).
  assert (0 < u * x) by (apply Rmult_lt_0_compat; lra). lra.
Qed.
Lemma at_least_rnd : forall k X x, 0 <= X -> 0 <= k -> / 10 ^ 292 <= x -> at_least k X x ->
  at_least (k + 1.0001) X (rnd x).
Proof.
  unfold at_least. intros k X x X0 K N H. destruct (rnd_near x N) as [R _]. generalize u_small. intro U0.
  eapply Rle_trans; [|exact R]. apply Rle_trans with (X * (1 - k * u) * (1 - 1.0001 * u)).
  - rewrite Rmult_assoc. apply Rmult_le_compat_l; [exact X0|].
    assert (0 <= k * u * (1.0001 * u)) by (apply Rmult_le_pos; [apply Rmult_le_pos|]; lra). lra.
  - apply Rmult_le_compat_r; lra.
Qed.
Lemma at_most_rnd : forall k X x, 0 <= X -> 0 <= k <= 20 -> / 10 ^ 292 <= x -> at_most k X x ->
  at_most (k + 1.0002) X (rnd x).
Proof.
  unfold at_most. intros k X x X0 K N H. destruct (rnd_near x N) as [_ R]. generalize u_small. intro U0.
  eapply Rle_trans; [exact R|]. apply Rle_trans with (X * (1 + k * u) * (1 + 1.0001 * u)).
  - apply Rmult_le_compat_r; lra.
  - rewrite Rmult_assoc. apply Rmult_le_compat_l; [exact X0|].
    assert (k * u * (1.0001 * u) <= 20 * u * (1.0001 * u)).
    { apply Rmult_le_compat_r; [lra|]. apply Rmult_le_compat_r; lra. }
    assert (u * u <= / 10 ^ 15 * u) by (apply Rmult_le_compat_r; lra). lra.
Qed.
Lemma at_least_product : forall j k X Y x y, 0 <= X -> 0 <= Y -> 0 <= j <= 100 -> 0 <= k <= 100 ->
  at_least j X x -> at_least k Y y -> at_least (j + k) (X * Y) (x * y).
Proof.
  unfold at_least. intros j k X Y x y X0 Y0 J K HX HY. generalize u_small. intro U0.
  assert (Q : forall i, 0 <= i <= 100 -> 0 <= i * u <= / 10).
  { intros i I. split; [apply Rmult_le_pos; lra|]. apply Rle_trans with (100 * / 10 ^ 15); [|lra].
    apply Rmult_le_compat; lra. }
  assert (QJ := Q j J). assert (QK := Q k K).
  apply Rle_trans with (X * (1 - j * u) * (Y * (1 - k * u))).
  - replace (X * (1 - j * u) * (Y * (1 - k * u))) with (X * Y * ((1 - j * u) * (1 - k * u))) by ring.
    apply Rmult_le_compat_l; [apply Rmult_le_pos; assumption|].
    assert (0 <= j * u * (k * u)) by (apply Rmult_le_pos; lra). lra.
  - apply Rmult_le_compat; [apply Rmult_le_pos; lra | apply Rmult_le_pos; lra | exact HX | exact HY].
Qed.
Lemma at_most_product : forall j k X Y x y, 0 <= x -> 0 <= y -> 0 <= X -> 0 <= Y -> 0 <= j <= 20 -> 0 <= k <= 20 ->
  at_most j X x -> at_most k Y y -> at_most (j + k + 0.0001) (X * Y) (x * y).
Proof.
  unfold at_most. intros j k X Y x y x0 y0 X0 Y0 J K HX HY. generalize u_small. intro U0.
  apply Rle_trans with (X * (1 + j * u) * (Y * (1 + k * u))).
  - apply Rmult_le_compat; assumption.
  - replace (X * (1 + j * u) * (Y * (1 + k * u))) with (X * Y * ((1 + j * u) * (1 + k * u))) by ring.
    apply Rmult_le_compat_l; [apply Rmult_le_pos; assumption|].
    assert (j * u * (k * u) <= 20 * u * (20 * u)).
    { apply Rmult_le_compat; try (apply Rmult_le_pos; lra); apply Rmult_le_compat_r; lra. }
    assert (u * u <= / 10 ^ 15 * u) by (apply Rmult_le_compat_r; lra). lra.
Qed.
Lemma at_least_quotient : forall j k X Y x y, 0 <= X -> 0 < Y -> 0 < y -> 0 <= j <= 100 -> 0 <= k <= 100 ->
  at_least j X x -> at_most k Y y -> at_least (j + k) (X / Y) (x / y).
Proof.
  unfold at_least, at_most. intros j k X Y x y X0 Y0 y0 J K HX HY. generalize u_small. intro U0.
  assert (Q : forall i, 0 <= i <= 100 -> 0 <= i * u <= / 10).
  { intros i I. split; [apply Rmult_le_pos; lra|]. apply Rle_trans with (100 * / 10 ^ 15); [|lra].
    apply Rmult_le_compat; lra. }
  assert (QJ := Q j J). assert (QK := Q k K).
  assert (Z : 0 <= X / Y) by (apply Rmult_le_pos; [exact X0 | left; apply Rinv_0_lt_compat, Y0]).
  apply Rmult_le_reg_r with y; [exact y0|]. replace (x / y * y) with x by (field; lra).
  eapply Rle_trans; [|exact HX].
  apply Rle_trans with (X / Y * (1 - (j + k) * u) * (Y * (1 + k * u))).
  - apply Rmult_le_compat_l; [apply Rmult_le_pos; lra | exact HY].
  - replace (X / Y * (1 - (j + k) * u) * (Y * (1 + k * u))) with (X * ((1 - (j + k) * u) * (1 + k * u))) by (field;
    lra).
    apply Rmult_le_compat_l; [exact X0|].
    assert (0 <= (j + k) * u * (k * u)) by (apply Rmult_le_pos; lra). lra.
Qed.
Lemma at_least_root : forall k X x, 0 <= X -> 0 <= k <= 100 -> at_least (2 * k) X x ->
  at_least (k + 0.0001) (sqrt X) (sqrt x).
Proof.
  unfold at_least. intros k X x X0 K H. generalize u_small. intro U0.
  assert (Q : (k + 0.0001) * u <= / 10).
  { apply Rle_trans with (101 * / 10 ^ 15); [|lra]. apply Rmult_le_compat; lra. }
  rewrite <- (sqrt_square (1 - (k + 0.0001) * u)) by lra. rewrite <- sqrt_mult by (try apply Rle_0_sqr; exact X0).
  apply sqrt_le_1_alt. eapply Rle_trans; [|exact H]. apply Rmult_le_compat_l; [exact X0|].
  assert ((k + 0.0001) * u * ((k + 0.0001) * u) <= 101 * u * (101 * / 10 ^ 15)).
  { apply Rmult_le_compat; try (apply Rmult_le_pos; lra); [apply Rmult_le_compat_r|apply Rmult_le_compat]; lra. }
  lra.
Qed.
Lemma at_least_weaken : forall j k X x, 0 <= X -> j <= k -> at_least j X x -> at_least k X x.
Proof.
  unfold at_least. intros j k X x X0 J H. eapply Rle_trans; [|exact H]. apply Rmult_le_compat_l; [exact X0|].
  assert (j * u <= k * u) by (apply Rmult_le_compat_r; [generalize u_pos; lra | exact J]). lra.
Qed.

(* ---- Lengths ---- *)

Lemma rlength_near : forall v, fmt3 v -> / 10 ^ 145 <= len v ->
  len v * (1 - 2.51 * u) <= rlength v <= len v * (1 + 2.51 * u).
Proof.
  intros v F H. generalize u_small tau_pos. intros U0 T0. set (L := len v) in *.
  assert (LL : / 10 ^ (145 + 145) <= L * L) by (apply floor_mult; exact H). change (145 + 145)%nat with 290%nat in LL.
  assert (T := tau_power 290 6 _ ltac:(lia) LL). assert (P := power_positive 290). assert (P1 := power_positive 145).
  assert (D := rdot_rounding v v F F). rewrite <- len_sq in D. fold L in D. apply Rabs_le_inv in D.
  assert (Y : L * L * (1 - 2 * 1.5001 * u) <= rdot v v <= L * L * (1 + 3.0002 * u)).
  { assert (u * tau <= u * (/ 10 ^ 6 * (L * L))) by (apply Rmult_le_compat_l; lra).
    assert (0 < u * (L * L)) by (apply Rmult_lt_0_compat; lra). lra. }
  destruct Y as [Y1 Y2]. apply at_least_root in Y1; [|lra|lra]. rewrite sqrt_square in Y1 by lra.
  assert (Y3 : at_most 1.5002 L (sqrt (rdot v v))).
  { unfold at_most. rewrite <- (sqrt_square (L * (1 + 1.5002 * u))) by (apply Rmult_le_pos; lra).
    apply sqrt_le_1_alt. eapply Rle_trans; [exact Y2|].
    replace (L * (1 + 1.5002 * u) * (L * (1 + 1.5002 * u))) with (L * L * ((1 + 1.5002 * u) * (1 + 1.5002 * u))) by
      ring.
    apply Rmult_le_compat_l; [lra|]. assert (0 <= u * u) by apply Rle_0_sqr. lra. }
  assert (N : / 10 ^ 292 <= sqrt (rdot v v)).
  { unfold at_least in Y1. assert (L * 0.5 <= L * (1 - (1.5001 + 0.0001) * u)) by (apply Rmult_le_compat_l; lra).
    assert (N := power_below 292 146 ltac:(lia)). assert (M : / 10 ^ 146 = / 10 * / 10 ^ 145)
      by (rewrite <- Rinv_mult; reflexivity). lra. }
  apply at_least_rnd in Y1; [|lra|lra|exact N]. apply at_most_rnd in Y3; [|lra|lra|exact N].
  unfold at_least, at_most in Y1, Y3. fold (rlength v) in Y1, Y3.
  assert (0 < u * L) by (apply Rmult_lt_0_compat; lra). lra.
Qed.
Lemma rlength_nonneg : forall v, 0 <= rlength v.
Proof.
  intro v. unfold rlength, rnd. apply round_ge_generic; auto with typeclass_instances;
    [apply generic_format_0 | apply sqrt_pos].
Qed.
(* The same holds of any vector, but for what underflows. *)
Lemma rlength_least : forall v, fmt3 v -> len v * (1 - 2.51 * u) - / 10 ^ 145 <= rlength v.
Proof.
  intros v F. assert (P := power_positive 145). destruct (Rle_or_lt (/ 10 ^ 145) (len v)) as [H|H].
  - destruct (rlength_near v F H) as [R _]. lra.
  - assert (R := rlength_nonneg v). generalize u_small (len_nonneg v). intros U0 L0.
    assert (len v * (1 - 2.51 * u) <= len v * 1) by (apply Rmult_le_compat_l; lra). lra.
Qed.
Lemma rlength_most : forall v, fmt3 v -> rlength v <= 2 * len v + 2 * / 10 ^ 145.
Proof.
  intros v F. assert (P := power_positive 145). generalize u_small (len_nonneg v) tau_pos. intros U0 L0 T0.
  destruct (Rle_or_lt (/ 10 ^ 145) (len v)) as [H|H].
  - destruct (rlength_near v F H) as [_ R].
    assert (len v * (1 + 2.51 * u) <= len v * 2) by (apply Rmult_le_compat_l; lra). lra.
  - set (p := / 10 ^ 145) in *. set (L := len v) in *. assert (LL : L * L <= p * p) by (apply Rmult_le_compat; lra).
    assert (PP : / 10 ^ 290 <= p * p) by (apply (floor_mult 145 145); apply Rle_refl).
    assert (T := tau_power 290 6 _ ltac:(lia) PP). assert (PP0 : 0 < p * p) by (apply Rmult_lt_0_compat; exact P).
    assert (D := rdot_rounding v v F F). rewrite <- len_sq in D. fold L in D. apply Rabs_le_inv in D.
    assert (A : 3.0001 * u * (L * L + 3 * tau) <= 0.1 * (p * p + 3 * tau)).
    { apply Rmult_le_compat; try lra. assert (0 <= L * L) by apply Rle_0_sqr. lra. }
    assert (Q : sqrt (rdot v v) <= 1.2 * p).
    { rewrite <- (sqrt_square (1.2 * p)) by lra. apply sqrt_le_1_alt. lra. }
    assert (R := rnd_any (sqrt (rdot v v))). rewrite (Rabs_pos_eq (sqrt _)) in R by apply sqrt_pos.
    apply Rabs_le_inv in R. fold (rlength v) in R.
    assert (T1 : tau <= / 10 ^ 6 * p) by (apply (tau_power 145); [lia | apply Rle_refl]).
    assert (u * sqrt (rdot v v) <= 0.1 * (1.2 * p)) by (apply Rmult_le_compat; try lra; apply sqrt_pos).
    assert (u * tau <= 0.1 * tau) by (apply Rmult_le_compat_r; lra). lra.
Qed.

(* The vector a is a difference x of points, with each coordinate rounded once. *)
Lemma fmt_of_approx : forall k a x, vapprox k a x -> fmt3 a.
Proof. intros k a x [[F1 _ _] [[F2 _ _] [F3 _ _]]]. repeat split; assumption. Qed.
Lemma len_of_approx : forall a x, vapprox 1 a x -> len x * (1 - u) <= len a <= len x * (1 + u).
Proof.
  intros a x H. apply vapprox_len in H. assert (A := len_from a x). assert (B := len_from x a).
  rewrite len_sub_sym in B. lra.
Qed.
Lemma difference_length : forall a x, vapprox 1 a x -> / 10 ^ 144 <= len x ->
  len x * (1 - 3.52 * u) <= rlength a <= len x * (1 + 3.52 * u).
Proof.
  intros a x H X. assert (F := fmt_of_approx _ _ _ H). apply len_of_approx in H. generalize u_small. intro U0.
  assert (P := power_positive 144).
  assert (M : / 10 ^ 145 = / 10 * / 10 ^ 144) by (rewrite <- Rinv_mult; reflexivity).
  assert (B : len x * 0.5 <= len x * (1 - u)) by (apply Rmult_le_compat_l; lra).
  destruct (rlength_near a F) as [R1 R2]; [lra|]. set (X0 := len x) in *. set (A := len a) in *.
  assert (0 < u * X0) by (apply Rmult_lt_0_compat; lra).
  assert (0 <= u * (u * X0) <= / 10 ^ 15 * (u * X0)).
  { split; [apply Rmult_le_pos; lra | apply Rmult_le_compat_r; lra]. }
  assert (X0 * (1 - u) * (1 - 2.51 * u) <= A * (1 - 2.51 * u)) by (apply Rmult_le_compat_r; lra).
  assert (A * (1 + 2.51 * u) <= X0 * (1 + u) * (1 + 2.51 * u)) by (apply Rmult_le_compat_r; lra). lra.
Qed.
Lemma difference_length_least : forall a x, vapprox 1 a x -> len x * (1 - 3.52 * u) - / 10 ^ 145 <= rlength a.
Proof.
  intros a x H. assert (R := rlength_least a (fmt_of_approx _ _ _ H)). apply len_of_approx in H.
  generalize u_small (len_nonneg x). intros U0 X. set (X0 := len x) in *. set (A := len a) in *.
  assert (0 <= u * X0) by (apply Rmult_le_pos; lra).
  assert (0 <= u * (u * X0)) by (apply Rmult_le_pos; lra).
  assert (X0 * (1 - u) * (1 - 2.51 * u) <= A * (1 - 2.51 * u)) by (apply Rmult_le_compat_r; lra). lra.
Qed.
Lemma difference_square : forall a x, vapprox 1 a x -> / 10 ^ 144 <= len x ->
  dot x x * (1 - 5.001 * u) <= rdot a a <= dot x x * (1 + 5.001 * u).
Proof.
  intros a x H X. destruct (rdot_approx 1 1 _ _ _ _ H H) as [_ D _]. rewrite absdot_self in D.
  change (1 + 1 + 3)%nat with 5%nat in D. rewrite <- len_sq in *. set (L := len x) in *.
  generalize u_small tau_pos. intros U0 T0.
  assert (LL : / 10 ^ (144 + 144) <= L * L) by (apply floor_mult; exact X). change (144 + 144)%nat with 288%nat in LL.
  assert (T := tau_power 288 6 _ ltac:(lia) LL). assert (P := power_positive 288).
  assert (E5 : E 5 <= 5.0001 * u) by (unfold E; rewrite u_val; simpl; lra).
  assert (E 5 * (L * L + 3 * tau) <= 5.0001 * u * (L * L + 3 * tau)) by (apply Rmult_le_compat_r; lra).
  assert (u * tau <= u * (/ 10 ^ 6 * (L * L))) by (apply Rmult_le_compat_l; lra).
  assert (0 < u * (L * L)) by (apply Rmult_lt_0_compat; lra). apply Rabs_le_inv in D. lra.
Qed.

(* ---- Areas ---- *)

Definition area_bound area a b := rnd (rnd (area * rlength a) * rlength b).
Definition area_here area a b := rnd (rlength (rcross a b) + area_bound area a b).
Definition area_there area a b := rnd (rlength (rcross a b) - area_bound area a b).

Lemma cross_of_differences : forall ac bc a b, vapprox 1 ac a -> vapprox 1 bc b ->
  len (vsub (rcross ac bc) (cross a b)) <= 4.4144 * u * (len a * len b) + 6 * (u * tau).
Proof.
  intros ac bc a b A B. assert (La := len_of_approx _ _ A). assert (Lb := len_of_approx _ _ B).
  apply vapprox_len in A, B. generalize u_small (len_nonneg a) (len_nonneg b) (len_nonneg ac) (len_nonneg bc).
  intros U0 A0 B0 C0 D0.
  eapply Rle_trans; [apply (len_between _ (cross ac bc))|].
  assert (R := rcross_rounding ac bc).
  replace (vsub (cross ac bc) (cross a b)) with (vadd (cross (vsub ac a) bc) (cross a (vsub bc b)))
    by (apply vec_eq; cbn; ring).
  assert (T := len_triangle (cross (vsub ac a) bc) (cross a (vsub bc b))).
  assert (T1 := cross_len (vsub ac a) bc). assert (T2 := cross_len a (vsub bc b)).
  set (P := len a * len b) in *. assert (P0 : 0 <= P) by (apply Rmult_le_pos; assumption).
  assert (X1 : len (vsub ac a) * len bc <= u * len a * (len b * (1 + u)))
    by (apply Rmult_le_compat; try apply len_nonneg; lra).
  assert (X2 : len a * len (vsub bc b) <= len a * (u * len b)) by (apply Rmult_le_compat_l; assumption).
  assert (X3 : len ac * len bc <= len a * (1 + u) * (len b * (1 + u))) by (apply Rmult_le_compat; lra).
  replace (u * len a * (len b * (1 + u))) with (u * P + u * (u * P)) in X1 by (unfold P; ring).
  replace (len a * (u * len b)) with (u * P) in X2 by (unfold P; ring).
  replace (len a * (1 + u) * (len b * (1 + u))) with (P * ((1 + u) * (1 + u))) in X3 by (unfold P; ring).
  assert (0 <= u * P) by (apply Rmult_le_pos; lra).
  assert (u * (u * P) <= / 10 ^ 15 * (u * P)) by (apply Rmult_le_compat_r; lra).
  assert (X4 : (u + 1.4143 * (u + u * u)) * (len ac * len bc) <= 2.41431 * u * (P * 1.00001)).
  { assert (u * u <= / 10 ^ 15 * u) by (apply Rmult_le_compat_r; lra). assert (0 <= u * u) by apply Rle_0_sqr.
    apply Rmult_le_compat; [lra | apply Rmult_le_pos; assumption | lra|].
    eapply Rle_trans; [exact X3|]. apply Rmult_le_compat_l; [exact P0 | lra]. }
  lra.
Qed.

Lemma area_bound_nonneg : forall area a b, 0 <= area -> 0 <= area_bound area a b.
Proof.
  assert (N : forall x, 0 <= x -> 0 <= rnd x).
  { intros. unfold rnd. apply round_ge_generic; auto with typeclass_instances. apply generic_format_0. }
  intros area a b A. apply N, Rmult_le_pos; [apply N, Rmult_le_pos; [exact A|]|]; apply rlength_nonneg.
Qed.
Lemma area_bound_least : forall area ac bc a b, vapprox 1 ac a -> vapprox 1 bc b ->
  / 10 ^ 120 <= len a -> / 10 ^ 120 <= len b -> 4.42 * u <= area ->
  4.4199 * u * (len a * len b) <= area_bound area ac bc.
Proof.
  intros area ac bc a b A B Ha Hb C. generalize u_small. intro U0.
  assert (P144 := power_below 144 120 ltac:(lia)). assert (P := power_positive 120).
  destruct (difference_length _ _ A ltac:(lra)) as [A1 _]. destruct (difference_length _ _ B ltac:(lra)) as [B1 _].
  change (at_least 3.52 (len a) (rlength ac)) in A1. change (at_least 3.52 (len b) (rlength bc)) in B1.
  assert (Q : forall x y, / 10 ^ 120 <= x -> at_least 3.52 x y -> / 10 ^ 121 <= y).
  { unfold at_least. intros x y X Y. assert (M : / 10 ^ 121 = / 10 * / 10 ^ 120) by (rewrite <- Rinv_mult; reflexivity).
    assert (x * 0.5 <= x * (1 - 3.52 * u)) by (apply Rmult_le_compat_l; lra). lra. }
  assert (QA := Q _ _ Ha A1). assert (QB := Q _ _ Hb B1).
  assert (C1 : at_least 0 (4.42 * u) area) by (unfold at_least; lra).
  assert (U16 : / 10 ^ 16 <= u) by (rewrite u_val; lra).
  assert (D := at_least_product 0 3.52 (4.42 * u) _ _ _ ltac:(lra) (len_nonneg a) ltac:(lra) ltac:(lra) C1 A1).
  assert (N1 : / 10 ^ (16 + 121) <= area * rlength ac) by (apply floor_mult; lra).
  assert (P292 : forall j, (j <= 292)%nat -> / 10 ^ 292 <= / 10 ^ j) by (intros; apply power_below; assumption).
  assert (PA : 0 <= 4.42 * u * len a) by (apply Rmult_le_pos; [lra | apply len_nonneg]).
  apply at_least_rnd in D; [|exact PA | lra | eapply Rle_trans; [apply (P292 137%nat); lia | exact N1]].
  assert (N2 : / 10 ^ 138 <= rnd (area * rlength ac)).
  { unfold at_least in D. assert (M : / 10 ^ (16 + 120) <= u * len a) by (apply floor_mult; lra).
    change (16 + 120)%nat with 136%nat in M. assert (M2 : / 10 ^ 138 <= / 10 ^ 136) by (apply power_below; lia).
    assert (4.42 * u * len a * 0.5 <= 4.42 * u * len a * (1 - (0 + 3.52 + 1.0001) * u)) by (apply Rmult_le_compat_l;
      lra).
    assert (0 < / 10 ^ 136) by apply power_positive. lra. }
  assert (G := at_least_product (0 + 3.52 + 1.0001) 3.52 _ _ _ _ PA (len_nonneg b) ltac:(lra) ltac:(lra) D B1).
  assert (N3 : / 10 ^ (138 + 121) <= rnd (area * rlength ac) * rlength bc) by (apply floor_mult; assumption).
  assert (PB : 0 <= 4.42 * u * len a * len b) by (apply Rmult_le_pos; [exact PA | apply len_nonneg]).
  apply at_least_rnd in G; [|exact PB | lra | eapply Rle_trans; [apply (P292 259%nat); lia | exact N3]].
  unfold at_least in G. fold (area_bound area ac bc) in G. eapply Rle_trans; [|exact G].
  replace (4.42 * u * len a * len b) with (u * (len a * len b) * 4.42) by ring.
  replace (4.4199 * u * (len a * len b)) with (u * (len a * len b) * 4.4199) by ring.
  rewrite (Rmult_assoc _ 4.42).
  apply Rmult_le_compat_l; [|lra]. apply Rmult_le_pos; [lra | apply Rmult_le_pos; apply len_nonneg].
Qed.

Lemma area_here_least : forall area ac bc a b, vapprox 1 ac a -> vapprox 1 bc b ->
  / 10 ^ 50 <= len a -> / 10 ^ 50 <= len b -> 4.42 * u <= area ->
  at_least 3.52 (len (cross a b)) (area_here area ac bc) /\ 4.41 * u * (len a * len b) <= area_here area ac bc.
Proof.
  intros area ac bc a b A B Ha Hb C. generalize u_small tau_pos. intros U0 T0.
  assert (P120 := power_below 120 50 ltac:(lia)).
  assert (Bound := area_bound_least area ac bc a b A B ltac:(lra) ltac:(lra) C).
  assert (Cr := cross_of_differences ac bc a b A B).
  assert (X := len_from (cross a b) (rcross ac bc)). rewrite len_sub_sym in X.
  assert (S := cross_len a b). assert (S0 := len_nonneg (cross a b)).
  assert (PP : / 10 ^ (50 + 50) <= len a * len b) by (apply floor_mult; assumption).
  change (50 + 50)%nat with 100%nat in PP. assert (P := power_positive 100).
  assert (T := tau_power 100 20 _ ltac:(lia) PP).
  assert (R : len (rcross ac bc) * (1 - 2.51 * u) - / 10 ^ 145 <= rlength (rcross ac bc))
    by (apply rlength_least; repeat split; apply fmt_rnd).
  assert (U16 : / 10 ^ 16 <= u) by (rewrite u_val; lra).
  unfold area_here. set (bound := area_bound area ac bc) in *. set (l := rlength (rcross ac bc)) in *.
  set (p := len a * len b) in *. set (z := len (cross a b)) in *. set (y := len (rcross ac bc)) in *.
  assert (up : / 10 ^ (16 + 100) <= u * p) by (apply floor_mult; assumption). change (16 + 100)%nat with 116%nat in up.
  assert (P145 : / 10 ^ 145 <= / 10 ^ 20 * (u * p)).
  { eapply Rle_trans; [apply (power_below 145 (20 + 116)); lia|]. apply floor_mult; [apply Rle_refl | exact up]. }
  assert (u * tau <= / 10 ^ 20 * (u * p)).
  { replace (/ 10 ^ 20 * (u * p)) with (u * (/ 10 ^ 20 * p)) by ring. apply Rmult_le_compat_l; lra. }
  assert (P116 := power_positive 116). assert (l0 : 0 <= l) by apply rlength_nonneg.
  assert (uu : 0 <= u * (u * p) <= / 10 ^ 15 * (u * p)).
  { split; [apply Rmult_le_pos; lra | apply Rmult_le_compat_r; lra]. }
  assert (ut : 0 < u * tau) by (apply Rmult_lt_0_compat; lra).
  assert (y1 : z - 4.4145 * u * p <= y) by lra.
  assert (y2 : (z - 4.4145 * u * p) * (1 - 2.51 * u) <= y * (1 - 2.51 * u)) by (apply Rmult_le_compat_r; lra).
  assert (Sum : at_least 2.51 z (l + bound)) by (unfold at_least; lra).
  assert (Sum2 : at_least 0 (4.4199 * u * p) (l + bound)) by (unfold at_least; lra).
  assert (N : / 10 ^ 292 <= l + bound).
  { eapply Rle_trans; [apply (power_below 292 116); lia|]. lra. }
  apply at_least_rnd in Sum; [|exact S0 | lra | exact N]. apply at_least_rnd in Sum2; [|lra | lra | exact N].
  split.
  - eapply at_least_weaken; [exact S0 | | exact Sum]. lra.
  - unfold at_least in Sum2. lra.
Qed.

Lemma rnd_below_fmt : forall x y, fmt y -> x <= y -> rnd x <= y.
Proof. intros. unfold rnd. apply round_le_generic; auto with typeclass_instances. Qed.

(* What is left of an area is at most 2.1 times the product of both lengths. *)
Lemma area_there_floor : forall area ac bc a b, vapprox 1 ac a -> vapprox 1 bc b -> 0 <= area ->
  / 10 ^ 143 <= area_there area ac bc ->
  area_there area ac bc <= 2.1 * (len a * len b) /\ / 10 ^ 145 <= len (rcross ac bc).
Proof.
  intros area ac bc a b A B C H. generalize u_small tau_pos. intros U0 T0.
  assert (Bound := area_bound_nonneg area ac bc C).
  assert (R : rlength (rcross ac bc) <= 2 * len (rcross ac bc) + 2 * / 10 ^ 145)
    by (apply rlength_most; repeat split; apply fmt_rnd).
  assert (L : area_there area ac bc <= rlength (rcross ac bc)).
  { unfold area_there. apply rnd_below_fmt; [apply fmt_rnd | lra]. }
  assert (Cr := cross_of_differences ac bc a b A B).
  assert (X := len_from (rcross ac bc) (cross a b)). assert (S := cross_len a b).
  assert (M : / 10 ^ 145 = / 10 ^ 2 * / 10 ^ 143) by (rewrite <- Rinv_mult, <- pow_add; reflexivity).
  assert (P := power_positive 143). assert (T := tau_power 143 20 _ ltac:(lia) (Rle_refl (/ 10 ^ 143))).
  set (y := len (rcross ac bc)) in *. set (p := len a * len b) in *. set (t := area_there area ac bc) in *.
  assert (p0 : 0 <= p) by (apply Rmult_le_pos; apply len_nonneg).
  assert (u * p <= / 10 ^ 15 * p) by (apply Rmult_le_compat_r; lra).
  assert (u * tau <= / 10 ^ 15 * tau) by (apply Rmult_le_compat_r; lra).
  split; lra.
Qed.

Lemma area_there_most : forall area ac bc a b, vapprox 1 ac a -> vapprox 1 bc b -> 4.42 * u <= area ->
  / 10 ^ 120 <= len a -> / 10 ^ 120 <= len b -> / 10 ^ 143 <= area_there area ac bc ->
  at_most 3.53 (len (cross a b)) (area_there area ac bc) /\ 0 < len (cross a b).
Proof.
  intros area ac bc a b A B C Ha Hb H. generalize u_small tau_pos. intros U0 T0.
  destruct (area_there_floor area ac bc a b A B ltac:(lra) H) as [Prod Long].
  assert (Bound := area_bound_least area ac bc a b A B Ha Hb C).
  assert (Cr := cross_of_differences ac bc a b A B).
  assert (X := len_from (rcross ac bc) (cross a b)). assert (S0 := len_nonneg (cross a b)).
  assert (F : fmt3 (rcross ac bc)) by (repeat split; apply fmt_rnd).
  destruct (rlength_near _ F Long) as [_ R].
  assert (P := power_positive 143).
  set (p := len a * len b) in *. set (z := len (cross a b)) in *. set (y := len (rcross ac bc)) in *.
  assert (PP : / 10 ^ 144 <= p).
  { assert (M : / 10 ^ 144 = / 10 * / 10 ^ 143) by (rewrite <- Rinv_mult; reflexivity). lra. }
  assert (T := tau_power 144 20 _ ltac:(lia) PP). assert (P4 := power_positive 144).
  assert (ut : u * tau <= u * (/ 10 ^ 20 * p)) by (apply Rmult_le_compat_l; lra).
  assert (up : 0 < u * p) by (apply Rmult_lt_0_compat; lra).
  assert (uu : 0 <= u * (u * p) <= / 10 ^ 15 * (u * p)).
  { split; [apply Rmult_le_pos; lra | apply Rmult_le_compat_r; lra]. }
  assert (y1 : y <= z + 4.4145 * u * p) by lra.
  assert (y2 : y * (1 + 2.51 * u) <= (z + 4.4145 * u * p) * (1 + 2.51 * u)) by (apply Rmult_le_compat_r; lra).
  assert (uz : 0 <= u * z) by (apply Rmult_le_pos; lra).
  assert (uuz : 0 <= u * (u * z) <= / 10 ^ 15 * (u * z)).
  { split; [apply Rmult_le_pos; lra | apply Rmult_le_compat_r; lra]. }
  unfold area_there in *. set (l := rlength (rcross ac bc)) in *. set (bound := area_bound area ac bc) in *.
  assert (D : l - bound <= z * (1 + 2.51 * u)) by lra.
  assert (R1 : Rabs (rnd (l - bound) - (l - bound)) <= u * Rabs (l - bound)).
  { apply (rnd_plus l (- bound)); [apply fmt_rnd | apply fmt_opp, fmt_rnd]. }
  assert (D0 : 0 < l - bound).
  { apply Rnot_le_lt. intro N. assert (rnd (l - bound) <= 0) by (apply rnd_below_fmt; [apply generic_format_0 | exact
    N]).
    lra. }
  rewrite (Rabs_pos_eq (l - bound)) in R1 by lra. apply Rabs_le_inv in R1.
  assert (u * (l - bound) <= u * (z * (1 + 2.51 * u))) by (apply Rmult_le_compat_l; lra).
  assert (Z : rnd (l - bound) <= z * (1 + 3.53 * u)) by lra.
  split; [exact Z|]. apply Rnot_le_lt. intro N. assert (Z0 : z = 0) by lra. rewrite Z0 in Z. lra.
Qed.
