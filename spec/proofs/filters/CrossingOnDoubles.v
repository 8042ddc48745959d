(* direction_behind() of src/flow/kernels/direction_across.h on doubles, with infinities and NaN. Where it says that the
   direction is known, all that it computes is finite, and is what real numbers give that are rounded after every
   operation: those that CrossingVectors.v is about. *)
From Coq Require Import Reals ZArith QArith Qreals Lra Lia Psatz Bool List.
From Flocq Require Import Core BinarySingleNaN.
From Flowcert Require Import algebra.Vector3 algebra.Cascade algebra.Crossing code.Expression code.generated.Constants
  filters.Rounding filters.RoundedVectors filters.Norms filters.Floors filters.Doubles filters.Terms filters.Filter
  filters.Directions filters.DirectionSigns filters.DirectionVectors filters.DirectionOfVector filters.DirectionStarts
  filters.CrossingVectors filters.CrossingTerms.
From Flowcert Require filters.Cells filters.DirectionStarts.
Open Scope R_scope.

(* ---- Backwards through single operations ---- *)

Lemma add_parts : forall x a b, finite (on_doubles x (Add a b)) -> finite (on_doubles x a) /\ finite (on_doubles x b) /\
  val (on_doubles x (Add a b)) = rnd (val (on_doubles x a) + val (on_doubles x b)).
Proof. intros x a b. exact (add_back (on_doubles x a) (on_doubles x b)). Qed.
Lemma mul_parts : forall x a b, finite (on_doubles x (Mul a b)) -> finite (on_doubles x a) /\ finite (on_doubles x b) /\
  val (on_doubles x (Mul a b)) = rnd (val (on_doubles x a) * val (on_doubles x b)).
Proof. intros x a b. exact (mul_back (on_doubles x a) (on_doubles x b)). Qed.
Lemma sub_parts : forall x a b, finite (on_doubles x (Sub a b)) -> finite (on_doubles x a) /\ finite (on_doubles x b) /\
  val (on_doubles x (Sub a b)) = rnd (val (on_doubles x a) - val (on_doubles x b)).
Proof. intros x a b. exact (sub_back (on_doubles x a) (on_doubles x b)). Qed.
Lemma root_parts : forall x a, finite (on_doubles x (Root a)) -> finite (on_doubles x a) /\
  val (on_doubles x (Root a)) = rnd (sqrt (val (on_doubles x a))).
Proof. intros x a. exact (root_back (on_doubles x a)). Qed.
Lemma abs_parts : forall x a, finite (on_doubles x (Abs a)) -> finite (on_doubles x a) /\
  val (on_doubles x (Abs a)) = Rabs (val (on_doubles x a)).
Proof.
  intros x a F. cbn [on_doubles] in *. unfold finite, val in *. rewrite is_finite_Babs in F. split; [exact F|].
  apply B2R_Babs.
Qed.
(* A quotient by infinity is finite, and zero. *)
Lemma div_parts : forall x a b, finite (on_doubles x b) -> finite (on_doubles x (Div a b)) ->
  finite (on_doubles x a) /\ val (on_doubles x b) <> 0 /\
  val (on_doubles x (Div a b)) = rnd (val (on_doubles x a) / val (on_doubles x b)).
Proof.
  intros x a b Fb F. cbn [on_doubles] in *. generalize dependent (on_doubles x a).
  generalize dependent (on_doubles x b). clear. intros b Fb a F. unfold finite, val in *.
  assert (N : B2R b <> 0).
  { destruct b as [s|s| |s m e H]; try discriminate.
    - exfalso. destruct a as [t|t| |t n f G]; discriminate.
    - cbn. intro Z. apply eq_0_F2R in Z. destruct s; discriminate. }
  generalize (Bdiv_correct 53 1024 _ _ mode_NE a b N). case Rlt_bool.
  - intros [V [G _]]. rewrite F in G. split; [symmetry; exact G | split; [exact N | exact V]].
  - intro V. exfalso. destruct (Bdiv mode_NE a b); discriminate.
Qed.

Lemma div_parts_positive : forall x a b, finite (on_doubles x a) -> finite (on_doubles x (Div a b)) ->
  0 < val (on_doubles x (Div a b)) ->
  finite (on_doubles x b) /\ val (on_doubles x (Div a b)) = rnd (val (on_doubles x a) / val (on_doubles x b)).
Proof.
  intros x a b Fa F P. destruct (div_back (on_doubles x a) (on_doubles x b) Fa F P) as [Fb [_ V]]. split; assumption.
Qed.
Lemma mul_term_forward : forall x a b, finite (on_doubles x a) -> finite (on_doubles x b) ->
  Rabs (val (on_doubles x a) * val (on_doubles x b)) <= bpow radix2 1000 ->
  finite (on_doubles x (Mul a b)) /\
  val (on_doubles x (Mul a b)) = rnd (val (on_doubles x a) * val (on_doubles x b)).
Proof. intros x a b. apply mul_forward. Qed.

Lemma div_not_negative : forall a b, not_negative a -> not_negative b -> not_negative (Bdiv mode_NE a b).
Proof.
  intros a b Ha Hb. unfold Cells.not_negative in *.
  destruct (is_nan (Bdiv mode_NE a b)) eqn:N; [auto|]. right.
  assert (Sa : Bsign a = false).
  { destruct Ha as [H|H]; [|exact H]. destruct a; discriminate. }
  assert (Sb : Bsign b = false).
  { destruct Hb as [H|H]; [|exact H]. destruct b; try discriminate. destruct a; discriminate. }
  destruct b as [t|t| |t n f G].
  - destruct a as [s|s| |s m e H]; cbn in *; try discriminate; subst; reflexivity.
  - destruct a as [s|s| |s m e H]; cbn in *; try discriminate; subst; reflexivity.
  - destruct a as [s|s| |s m e H]; discriminate.
  - assert (Z : B2R (B754_finite t n f G) <> 0).
    { cbn. intro Z. apply eq_0_F2R in Z. destruct t; discriminate. }
    generalize (Bdiv_correct 53 1024 _ _ mode_NE a (B754_finite t n f G) Z). case Rlt_bool.
    + intros [_ [_ S]]. rewrite S by exact N. rewrite Sa, Sb. reflexivity.
    + intro E. rewrite Sa, Sb in E. cbn [xorb] in E. destruct (Bdiv mode_NE a _); try discriminate.
      unfold binary_overflow in E. cbn in E |- *. congruence.
Qed.
Lemma positive_not_negative : forall a : double, 0 < val a -> not_negative a.
Proof.
  intros a P. right. destruct a as [s|s| |s m e H]; try (exfalso; cbn in P; lra). destruct s; [|reflexivity].
  exfalso. change (0 < F2R (Float radix2 (Z.neg m) e)) in P.
  assert (N : F2R (Float radix2 (Z.neg m) e) <= 0) by (apply F2R_le_0; cbn; lia). lra.
Qed.
Lemma abs_not_negative : forall a : double, not_negative (Babs a).
Proof. intros [s|s| |s m e H]; [right | right | left | right]; reflexivity. Qed.
Lemma above_zero : forall x a, compare_doubles Less (on_doubles x (Cst 0 0)) a = true ->
  not_negative a /\ (finite a -> 0 < val a).
Proof.
  intros x a H. assert (Fz : finite (on_doubles x (Cst 0 0))) by reflexivity.
  assert (Ez : val (on_doubles x (Cst 0 0)) = 0) by reflexivity.
  generalize dependent (on_doubles x (Cst 0 0)). intros zero H Fz Ez.
  assert (P : finite a -> 0 < val a).
  { intro F. rewrite compare_finite in H by assumption. cbn [compare_reals] in H. revert H.
    case Rlt_bool_spec; [|discriminate]. intros L _. lra. }
  split; [|exact P]. destruct a as [s|s| |s m e G].
  - apply positive_not_negative, P. reflexivity.
  - destruct s; [|right; reflexivity]. exfalso. destruct zero as [t|t| |t n f K]; discriminate.
  - left. reflexivity.
  - apply positive_not_negative, P. reflexivity.
Qed.
Lemma below_is_finite : forall a c : double, not_negative a -> finite c -> compare_doubles Less a c = true -> finite a.
Proof.
  intros a c N F H. destruct a as [s|s| |s m e G]; try reflexivity; exfalso.
  - destruct N as [N|N]; [discriminate|]. cbn in N. subst s. destruct c as [t|t| |t n f K]; discriminate.
  - destruct c as [t|t| |t n f K]; discriminate.
Qed.

(* ---- Constants ---- *)

Lemma times_roundoff_value : forall k x,
  ((Z.abs (fst k) <? 2 ^ 53)%Z && (-900 <=? snd k)%Z && (snd k <=? 900)%Z && (snd kUnitRoundoff =? -53)%Z = true) ->
  finite (on_doubles x (times_roundoff k)) /\
  val (on_doubles x (times_roundoff k)) = val (on_doubles x (in_roundoffs k)).
Proof.
  intros [m e] x H. unfold times_roundoff, roundoff, in_roundoffs. cbn [fst snd] in *.
  rewrite !andb_true_iff, Z.ltb_lt, !Z.leb_le, Z.eqb_eq in H. destruct H as [[[H1 H2] H3] H4].
  change kUnitRoundoff with (1, -53)%Z in *. cbn [fst snd] in *.
  assert (L := mantissa_bits m H1).
  destruct (normal_constant m e (Z.log2 (Z.abs m) + 1 + e) H1 ltac:(lia) ltac:(lia) eq_refl) as [F1 V1].
  destruct (normal_constant m (e + -53) (Z.log2 (Z.abs m) + 1 + (e + -53)) H1 ltac:(lia) ltac:(lia) eq_refl) as [_ V].
  destruct (normal_constant 1 (-53) (-52) ltac:(lia) ltac:(lia) ltac:(lia) eq_refl) as [F2 V2].
  destruct (constant_value m (e + -53) H1 ltac:(lia)) as [B Fmt].
  assert (E : F2R (Float radix2 m e) * F2R (Float radix2 1 (-53)) = F2R (Float radix2 m (e + -53))).
  { unfold F2R. cbn [Fnum Fexp]. rewrite bpow_plus. ring. }
  change (finite (on_doubles x (Cst m e))) in F1. change (val (on_doubles x (Cst m e)) = F2R (Float radix2 m e)) in V1.
  change (finite (on_doubles x (Cst 1 (-53)))) in F2.
  change (val (on_doubles x (Cst 1 (-53))) = F2R (Float radix2 1 (-53))) in V2.
  change (val (on_doubles x (Cst m (e + -53))) = F2R (Float radix2 m (e + -53))) in V.
  destruct (mul_forward (on_doubles x (Cst m e)) (on_doubles x (Cst 1 (-53))) F1 F2) as [F3 V3].
  { rewrite V1, V2, E. eapply Rle_trans; [exact B | apply bpow_le; lia]. }
  split; [exact F3|].
  change (on_doubles x (Mul (Cst m e) (Cst 1 (-53)))) with
    (Bmult mode_NE (on_doubles x (Cst m e)) (on_doubles x (Cst 1 (-53)))).
  rewrite V3, V1, V2, E, V. apply round_generic; [apply valid_rnd_N | exact Fmt].
Qed.
Lemma header_times_roundoff : forall k (needs most : Q),
  ((Z.abs (fst k) <? 2 ^ 53)%Z && (-900 <=? snd k)%Z && (snd k <=? 900)%Z && Qle_bool needs (units_of k) &&
   Qle_bool (units_of k) most && (snd kUnitRoundoff =? -53)%Z = true) -> forall x,
  finite (on_doubles x (times_roundoff k)) /\ Q2R needs * u <= val (on_doubles x (times_roundoff k)) <= Q2R most * u.
Proof.
  intros k needs most H x. destruct (header_constant k needs most H x) as [_ B].
  destruct (times_roundoff_value k x) as [F V].
  - rewrite !andb_true_iff in *. tauto.
  - split; [exact F|]. rewrite V. exact B.
Qed.
Lemma power_constant : forall k x, (-1000 <= k <= 900)%Z ->
  finite (on_doubles x (Cst 1 k)) /\ val (on_doubles x (Cst 1 k)) = bpow radix2 k.
Proof.
  intros k x H. destruct (normal_constant 1 k (k + 1) ltac:(lia) ltac:(lia) ltac:(lia)
    ltac:(change (Z.log2 (Z.abs 1)) with 0%Z; lia)) as [F V].
  split; [exact F|]. change (val (on_doubles x (Cst 1 k)) = F2R (Float radix2 1 k)) in V. rewrite V.
  unfold F2R. cbn [Fnum Fexp]. ring.
Qed.

(* ---- direction_behind() ---- *)

Lemma vector_parts : forall x a b c, finite (on_doubles x (edot (Triple a b c) (Triple a b c))) ->
  (finite (on_doubles x a) /\ finite (on_doubles x b) /\ finite (on_doubles x c)) /\
  let v := V (val (on_doubles x a)) (val (on_doubles x b)) (val (on_doubles x c)) in
  val (on_doubles x (edot (Triple a b c) (Triple a b c))) = rdot v v.
Proof.
  intros x a b c F. unfold edot in *. cbn [tx ty tz] in *.
  destruct (add_parts _ _ _ F) as [F1 [Fc E1]]. destruct (add_parts _ _ _ F1) as [Fa [Fb E2]].
  destruct (mul_parts _ _ _ Fa) as [Fa' [_ E3]]. destruct (mul_parts _ _ _ Fb) as [Fb' [_ E4]].
  destruct (mul_parts _ _ _ Fc) as [Fc' [_ E5]]. split; [auto|]. unfold rdot. cbn [vx vy vz].
  rewrite E1, E2, E3, E4, E5. reflexivity.
Qed.
Lemma dot_parts : forall x j k, finite (on_doubles x (edot (given j) (given k))) ->
  (forall i, (i < 3)%nat -> finite (x (3 * j + i)%nat) /\ finite (x (3 * k + i)%nat)) /\
  val (on_doubles x (edot (given j) (given k))) =
  rdot (value_of_vector (fun n => val (x n)) j) (value_of_vector (fun n => val (x n)) k).
Proof.
  intros x j k F. unfold edot, given in *. cbn [tx ty tz] in *.
  destruct (add_parts _ _ _ F) as [F1 [Fc E1]]. destruct (add_parts _ _ _ F1) as [Fa [Fb E2]].
  destruct (mul_parts _ _ _ Fa) as [Fa1 [Fa2 E3]]. destruct (mul_parts _ _ _ Fb) as [Fb1 [Fb2 E4]].
  destruct (mul_parts _ _ _ Fc) as [Fc1 [Fc2 E5]]. split.
  - intros [|[|[|i]]] Hi; [rewrite !Nat.add_0_r; split; assumption | split; assumption | split; assumption | lia].
  - unfold rdot, value_of_vector. cbn [vx vy vz]. rewrite E1, E2, E3, E4, E5. reflexivity.
Qed.
Lemma most_parts : forall x a b, finite (on_doubles x a) -> finite (on_doubles x b) ->
  val (on_doubles x (DirectionStarts.most a b)) = Rmax (val (on_doubles x a)) (val (on_doubles x b)).
Proof.
  intros x a b Fa Fb. unfold DirectionStarts.most. cbn [on_doubles]. rewrite compare_finite by assumption.
  cbn [compare_reals]. case Rlt_bool_spec; intro H; symmetry; [apply Rmax_right | apply Rmax_left]; lra.
Qed.

Lemma if_back : forall x r a b rest, run x (If r a b rest (Answer None)) = Some Positive ->
  compare_doubles r (on_doubles x a) (on_doubles x b) = true /\ run x rest = Some Positive.
Proof.
  intros x r a b rest H. cbn [run] in H. destruct (compare_doubles r _ _); [|discriminate].
  split; [reflexivity | exact H].
Qed.
Lemma range_back : forall x e rest, run x (if_in_range e rest) = Some Positive ->
  square_in_range x e /\ run x rest = Some Positive.
Proof.
  intros x e rest H. unfold if_in_range in H. apply if_back in H. destruct H as [H1 H]. apply if_back in H.
  destruct H as [H2 H]. exact (conj (conj H1 H2) H).
Qed.

(* Where a is below b, and where it is not. *)
Definition holds x a b := compare_doubles Less (on_doubles x a) (on_doubles x b) = true.
Definition fails x a b := compare_doubles Less (on_doubles x a) (on_doubles x b) = false.
Definition one_of_four x a b c d e f g h :=
  holds x a b \/ (fails x a b /\ holds x c d) \/ (fails x a b /\ fails x c d /\ holds x e f) \/
  (fails x a b /\ fails x c d /\ holds x g h).
Lemma four_ways : forall x a b c d e f g h rest,
  run x (If Less a b rest (If Less c d rest (If Less e f rest (If Less g h rest (Answer None))))) = Some Positive ->
  one_of_four x a b c d e f g h /\ run x rest = Some Positive.
Proof.
  intros x a b c d e f g h rest H. unfold one_of_four, holds, fails. cbn [run] in H.
  destruct (compare_doubles Less (on_doubles x a) _), (compare_doubles Less (on_doubles x c) _),
    (compare_doubles Less (on_doubles x e) _), (compare_doubles Less (on_doubles x g) _); tauto || discriminate.
Qed.

Lemma add_positive : forall x a b, not_negative (on_doubles x a) -> not_negative (on_doubles x b) ->
  not_negative (on_doubles x (Add a b)).
Proof. intros x a b. apply Cells.add_not_negative. Qed.
Lemma mul_positive : forall x a b, not_negative (on_doubles x a) -> not_negative (on_doubles x b) ->
  not_negative (on_doubles x (Mul a b)).
Proof. intros x a b. apply Cells.mul_not_negative. Qed.
Lemma div_positive : forall x a b, not_negative (on_doubles x a) -> not_negative (on_doubles x b) ->
  not_negative (on_doubles x (Div a b)).
Proof. intros x a b. apply div_not_negative. Qed.
Lemma root_positive : forall x a, not_negative (on_doubles x a) -> not_negative (on_doubles x (Root a)).
Proof. intros x a. apply root_not_negative. Qed.
Lemma abs_positive : forall x a, not_negative (on_doubles x (Abs a)).
Proof. intros x a. apply abs_not_negative. Qed.
Lemma most_positive : forall x a b, not_negative (on_doubles x a) -> not_negative (on_doubles x b) ->
  not_negative (on_doubles x (DirectionStarts.most a b)).
Proof.
  intros x a b Ha Hb. unfold DirectionStarts.most. cbn [on_doubles]. destruct (compare_doubles Less _ _); assumption.
Qed.

Section Behind.
Variable x : nat -> double.
Let X n := val (x n).
Let U := value_of_vector X 0.
Let gc := value_of_vector X 2.
Let Dc := value_of_vector X 4.
Let ec := value_of_vector X 6.
Let nc := value_of_vector X 7.
Let value e := val (on_doubles x e).
Let Y := way_vector U gc (X 9%nat) Dc.

(* The four ways in which the sign of a way is certain. *)
Definition certain_way := one_of_four x approach_bound_behind approach_behind angle_form_bound angle_form
  approach_behind (Neg approach_bound_behind) angle_form (Neg angle_form_bound).
Lemma behind_tests : run x Code.Behind.is_known = Some Positive ->
  square_in_range x seen_square_size /\ square_in_range x (square 6) /\ square_in_range x (square 7) /\
  holds x (Cst 0 0) inverse_behind /\ holds x slack_behind largest_error /\ certain_way.
Proof.
  intro H. destruct behind_match as [_ [_ [_ [_ M]]]]. rewrite M in H. clear M.
  apply if_back in H. destruct H as [_ H]. apply range_back in H. destruct H as [R1 H].
  apply range_back in H. destruct H as [R2 H]. apply range_back in H. destruct H as [R3 H].
  apply four_ways in H. destruct H as [W H]. apply if_back in H. destruct H as [P H].
  apply if_back in H. destruct H as [Q _]. exact (conj R1 (conj R2 (conj R3 (conj P (conj Q W))))).
Qed.

Hypothesis direction_is_finite : forall k, (k < 4)%nat -> finite (x k).
Hypothesis error_is_positive : 0 < X 3 <= 3 / 32.
Hypothesis size_is_positive : not_negative (x 16%nat).
Hypothesis ratio_is_positive : not_negative (x 17%nat).
Hypothesis is_known : run x Code.Behind.is_known = Some Positive.

Let c := value (times_roundoff kCrossingBound).
Let c2 := value (times_roundoff kAngleFormBound).
Let c6 := value (times_roundoff kHeightBound).
Let c_exit := value (times_roundoff kExitBound).
Let kB := F2R (Float radix2 (fst kTangentBehind) (snd kTangentBehind)).

Definition height_value :=
  rnd (rnd (Rabs (X 15) + rnd (c6 * X 16%nat)) * rnd (sqrt (rnd (rnd (X 17 * rdot nc nc) / rdot ec ec)))).
Let i := CrossingVectors.way_inverse Y.
Let r := way_rounding c (X 16) i.
Let angle := way_angle c2 (X 9) (X 10).
Let turn := way_turn angle height_value i.
Let norm := way_norm angle height_value i.
Let slack := way_slack turn norm (X 3) r.

Record values_behind : Prop := ValuesBehind {
  parts_finite : forall n, (6 <= n <= 23)%nat -> n <> 11%nat -> finite (x n);
  seen_size_range : 0.999 / 10 ^ 50 <= X 10 <= 10 ^ 50 * 1.001;
  edge_square_range : square_in_range x (square 6) /\ finite (on_doubles x (square 6)) /\
    value (square 6) = rdot ec ec;
  next_square_range : square_in_range x (square 7) /\ finite (on_doubles x (square 7)) /\
    value (square 7) = rdot nc nc;
  approach_value : finite (on_doubles x approach_behind) /\ value approach_behind = rdot U gc;
  vector_value : (forall j, (j < 3)%nat -> finite (on_doubles x (part_behind j))) /\
    V (value (part_behind 0)) (value (part_behind 1)) (value (part_behind 2)) = Y;
  vector_below : len Y <= 10 ^ 160;
  inverse_value : finite (on_doubles x inverse_behind) /\ value inverse_behind = i /\ 0 < i;
  angle_bound_value : finite (on_doubles x angle_form_bound) /\ value angle_form_bound = rnd (c2 * X 10);
  height_finite : finite (on_doubles x (Div (Mul squared_ratio (square 7)) (square 6))) /\ 0 <= height_value;
  slack_value : slack < / 16;
  error_value : finite (on_doubles x error_behind) /\
    value error_behind = way_error kB turn (X 3) r slack }.

Lemma nothing_is_negative : holds x (Cst 0 0) inverse_behind -> square_in_range x seen_square_size ->
  square_in_range x (square 6) -> square_in_range x (square 7) -> not_negative (on_doubles x slack_behind) /\
  not_negative (on_doubles x turn_behind) /\ not_negative (on_doubles x norm_behind) /\
  not_negative (on_doubles x rounding_behind) /\ not_negative (on_doubles x height_behind).
Proof.
  intros Hi R10 R6 R7. destruct (above_zero x _ Hi) as [Ni _].
  assert (P : forall e, square_in_range x e -> not_negative (on_doubles x e)).
  { intros e R. apply positive_not_negative. destruct (square_range_back x e R) as [_ B]. lra. }
  assert (K : forall k, ((Z.abs (fst k) <? 2 ^ 53)%Z && (-900 <=? snd k)%Z && (snd k <=? 900)%Z && Qle_bool 1 (units_of
    k) && Qle_bool (units_of k) 1000 && (snd kUnitRoundoff =? -53)%Z = true) ->
    not_negative (on_doubles x (times_roundoff k))).
  { intros k Hk. apply positive_not_negative. destruct (header_times_roundoff k 1 1000 Hk x) as [_ [B _]].
    replace (Q2R 1) with 1 in B by (unfold Q2R; cbn; lra). generalize u_pos. lra. }
  assert (C : forall k, (-1000 <= k <= 900)%Z -> not_negative (on_doubles x (Cst 1 k))).
  { intros k Hk. apply positive_not_negative. rewrite (proj2 (power_constant k x Hk)). apply bpow_gt_0. }
  assert (Na : not_negative (on_doubles x angle_form_bound)).
  { exact (mul_positive x _ _ (K kAngleFormBound eq_refl) (P _ R10)). }
  assert (Nla : not_negative (on_doubles x angle_behind)).
  { exact (add_positive x _ _ (abs_positive x angle_form) Na). }
  assert (Nq : not_negative (on_doubles x (Div (Mul squared_ratio (square 7)) (square 6)))).
  { exact (div_positive x _ _ (mul_positive x squared_ratio _ ratio_is_positive (P _ R7)) (P _ R6)). }
  assert (Nh : not_negative (on_doubles x height_behind)).
  { exact (mul_positive x _ _ (add_positive x _ _ (abs_positive x next_angle_form) (mul_positive x _ way_square_size
      (K kHeightBound eq_refl) size_is_positive)) (root_positive x _ Nq)). }
  assert (Nt : not_negative (on_doubles x turn_behind)).
  { exact (mul_positive x _ _ (mul_positive x _ _ (mul_positive x _ _ (mul_positive x _ _ (C 2%Z ltac:(lia)) Nla) Nh)
      Ni) Ni). }
  assert (Nn : not_negative (on_doubles x norm_behind)).
  { exact (mul_positive x _ _ (mul_positive x _ _ (C 1%Z ltac:(lia)) (most_positive x _ _ Nla Nh)) Ni). }
  assert (Nr : not_negative (on_doubles x rounding_behind)).
  { exact (mul_positive x _ _ (mul_positive x _ way_square_size (K kCrossingBound eq_refl) size_is_positive) Ni). }
  assert (N3 : not_negative (on_doubles x old_error)).
  { apply positive_not_negative. exact (proj1 error_is_positive). }
  exact (conj (add_positive x _ _ (mul_positive x _ _ (add_positive x _ _ Nt Nn) N3) Nr)
    (conj Nt (conj Nn (conj Nr Nh)))).
Qed.

Lemma sign_of_value : forall a : double, finite a -> not_negative a -> 0 <= val a.
Proof.
  intros a F [N|N]; destruct a as [s|s| |s m e H]; try discriminate; cbn in N |- *; try lra. subst s.
  apply F2R_ge_0. cbn. lia.
Qed.

Theorem values_are_right : values_behind.
Proof.
  destruct (behind_tests is_known) as [R10 [R6 [R7 [Hi [Hs _]]]]].
  destruct (square_range_back x _ R10) as [F10 B10]. destruct (square_range_back x _ R6) as [Fee Bee].
  destruct (square_range_back x _ R7) as [Fnn Bnn].
  destruct (square_back x 6 Fee) as [Fe Eee]. destruct (square_back x 7 Fnn) as [Fn Enn].
  destruct (nothing_is_negative Hi R10 R6 R7) as [Ns [Nt [Nn [Nr Nh]]]].
  destruct (forward x (fun _ => 5000%Z) largest_error (Z.log2 (Z.abs (fst kLargestError)) + 1 + snd kLargestError))
    as [Fl [El _]]; [intros n Hn; discriminate Hn | vm_compute; reflexivity|].
  assert (Hl : val (on_doubles x largest_error) <= / 16).
  { assert (A := rule_of_starts). rewrite !andb_true_iff, !Qle_bool_iff in A. destruct A as [[A1 _] _].
    apply Qle_Rle in A1. unfold units_of in A1. rewrite rational_value in A1.
    replace (Q2R (1 # 16)) with (/ 16) in A1 by (unfold Q2R; cbn; lra). rewrite El. exact A1. }
  (* all parts of the slack *)
  assert (Fs := below_is_finite _ _ Ns Fl Hs).
  destruct (add_parts _ _ _ Fs) as [Ft1 [Fr Es]]. destruct (mul_parts _ _ _ Ft1) as [Ft2 [_ Et1]].
  destruct (add_parts _ _ _ Ft2) as [Ft [Fnorm Et2]].
  destruct (mul_parts _ _ _ Ft) as [Ft3 [Fi Et3]]. destruct (mul_parts _ _ _ Ft3) as [Ft4 [_ Et4]].
  destruct (mul_parts _ _ _ Ft4) as [Ft5 [Fh Et5]]. destruct (mul_parts _ _ _ Ft5) as [_ [Fa Et6]].
  destruct (add_parts _ _ _ Fa) as [Fa1 [Fab Ea]]. destruct (abs_parts _ _ Fa1) as [F9 Ea1].
  destruct (mul_parts _ _ _ Fab) as [_ [_ Eab]].
  destruct (mul_parts _ _ _ Fnorm) as [Fn1 [_ En1]]. destruct (mul_parts _ _ _ Fn1) as [_ [_ En2]].
  rewrite (most_parts x _ _ Fa Fh) in En2.
  destruct (mul_parts _ _ _ Fr) as [Fr1 [_ Er1]]. destruct (mul_parts _ _ _ Fr1) as [_ [F16 Er2]].
  destruct (mul_parts _ _ _ Fh) as [Fh1 [Fsc Eh]]. destruct (add_parts _ _ _ Fh1) as [Fh2 [Fh3 Eh1]].
  destruct (abs_parts _ _ Fh2) as [F15 Eh2]. destruct (mul_parts _ _ _ Fh3) as [_ [_ Eh3]].
  destruct (root_parts _ _ Fsc) as [Fq Esc]. destruct (div_parts _ _ _ Fee Fq) as [Fq1 [_ Eq]].
  destruct (mul_parts _ _ _ Fq1) as [F17 [_ Eq1]].
  (* the vector *)
  destruct (above_zero x _ Hi) as [_ Pi]. specialize (Pi Fi).
  destruct (one_on_doubles x) as [F1 E1].
  destruct (div_parts_positive x one (Root (edot vector_behind vector_behind)) F1 Fi Pi) as [Frt Ei].
  rewrite E1 in Ei. change (Div one (Root (edot vector_behind vector_behind))) with inverse_behind in Ei.
  destruct (root_parts _ _ Frt) as [Fyy Ert].
  destruct (vector_parts _ _ _ _ Fyy) as [[Fy0 [Fy1 Fy2]] Eyy]. cbv zeta in Eyy.
  change (edot (Triple (part_behind 0) (part_behind 1) (part_behind 2))
    (Triple (part_behind 0) (part_behind 1) (part_behind 2))) with (edot vector_behind vector_behind) in Eyy.
  assert (FA : finite (on_doubles x approach_behind)).
  { destruct (add_parts _ _ _ Fy0) as [A [_ _]]. apply (mul_parts _ _ _ A). }
  destruct (dot_parts _ _ _ FA) as [Fg EA]. change (edot (given 0) (given 2)) with approach_behind in EA.
  change (val (on_doubles x approach_behind) = rdot U gc) in EA.
  assert (Part : forall j, (j < 3)%nat -> finite (on_doubles x (part_behind j)) -> finite (x (12 + j)%nat) /\
    value (part_behind j) = rnd (rnd (rdot U gc * X (12 + j)%nat) + rnd (rnd (2 * X 9%nat) * X j))).
  { intros j Hj F. destruct (add_parts _ _ _ F) as [P1 [P2 V]]. destruct (mul_parts _ _ _ P1) as [_ [P3 V1]].
    destruct (mul_parts _ _ _ P2) as [P4 [_ V2]]. destruct (mul_parts _ _ _ P4) as [_ [_ V3]].
    split; [exact P3|]. unfold value, part_behind. rewrite V, V1, V2, V3, EA.
    rewrite (proj2 (power_constant 1 x ltac:(lia))). change (bpow radix2 1) with 2. reflexivity. }
  destruct (Part 0%nat ltac:(lia) Fy0) as [F12 V0]. destruct (Part 1%nat ltac:(lia) Fy1) as [F13 V1].
  destruct (Part 2%nat ltac:(lia) Fy2) as [F14 V2].
  assert (EY : V (value (part_behind 0)) (value (part_behind 1)) (value (part_behind 2)) = Y).
  { rewrite V0, V1, V2. reflexivity. }
  unfold value in EY. rewrite EY in Eyy.
  assert (FY : fmt3 Y) by (repeat split; apply fmt_rnd).
  assert (LY := length_below _ Y FY Eyy).
  assert (Ei' : value inverse_behind = i).
  { unfold value, i, CrossingVectors.way_inverse, rlength. rewrite Ei, Ert, Eyy. reflexivity. }
  (* values *)
  rewrite (proj2 (power_constant 2 x ltac:(lia))) in Et6. change (bpow radix2 2) with 4 in Et6.
  rewrite (proj2 (power_constant 1 x ltac:(lia))) in En2. change (bpow radix2 1) with 2 in En2.
  assert (Ea' : value angle_behind = angle).
  { unfold value, angle, way_angle, angle_behind. rewrite Ea, Ea1. unfold angle_form_bound. rewrite Eab. reflexivity. }
  assert (Eh' : value height_behind = height_value).
  { unfold value, height_value, height_behind. rewrite Eh, Eh1, Eh2, Eh3. unfold scaling_behind.
    rewrite Esc, Eq, Eq1, Eee, Enn. reflexivity. }
  assert (Et' : value turn_behind = turn).
  { unfold value, turn, way_turn, turn_behind. rewrite Et3, Et4, Et5, Et6.
    fold (value angle_behind) (value height_behind) (value inverse_behind). rewrite Ea', Eh', Ei'. reflexivity. }
  assert (En' : value norm_behind = norm).
  { unfold value, norm, way_norm, norm_behind. rewrite En1, En2. fold (value angle_behind) (value height_behind)
      (value inverse_behind). rewrite Ea', Eh', Ei'. reflexivity. }
  assert (Er' : value rounding_behind = r).
  { unfold value, r, way_rounding, rounding_behind. rewrite Er1, Er2. fold (value inverse_behind). rewrite Ei'.
    reflexivity. }
  assert (Es' : value slack_behind = slack).
  { unfold value, slack, way_slack, slack_behind. rewrite Es, Et1, Et2. fold (value turn_behind) (value norm_behind)
      (value rounding_behind). rewrite Et', En', Er'. reflexivity. }
  assert (Small : slack < / 16).
  { rewrite <- Es'. unfold holds in Hs. rewrite compare_finite in Hs by assumption. cbn [compare_reals] in Hs.
    revert Hs. case Rlt_bool_spec; [|discriminate]. intros L _. unfold value. lra. }
  assert (T0 := sign_of_value _ Ft Nt). fold (value turn_behind) in T0.
  assert (N0 := sign_of_value _ Fnorm Nn). fold (value norm_behind) in N0.
  assert (R0 := sign_of_value _ Fr Nr). fold (value rounding_behind) in R0.
  assert (S0 := sign_of_value _ Fs Ns). fold (value slack_behind) in S0.
  rewrite Et' in T0. rewrite En' in N0. rewrite Er' in R0. rewrite Es' in S0.
  split.
  - intros n [H1 H2] H3. do 6 (destruct n as [|n]; [lia|]).
    destruct n as [|[|[|[|[|[|n]]]]]]; try (exact F9 || exact F10 || lia).
    + apply (Fg 0%nat). lia.
    + apply (Fg 1%nat). lia.
    + apply (Fg 2%nat). lia.
    + destruct n as [|[|[|[|[|[|n]]]]]]; try (exact F12 || exact F13 || exact F14 || exact F15 || exact F16 ||
        exact F17).
      destruct n as [|[|[|[|[|[|n]]]]]]; try lia;
        [ apply (Fe 0%nat) | apply (Fe 1%nat) | apply (Fe 2%nat) | apply (Fn 0%nat) | apply (Fn 1%nat)
        | apply (Fn 2%nat) ]; lia.
  - exact B10.
  - exact (conj R6 (conj Fee Eee)).
  - exact (conj R7 (conj Fnn Enn)).
  - exact (conj FA EA).
  - split; [|exact EY]. intros [|[|[|j]]] Hj; [exact Fy0 | exact Fy1 | exact Fy2 | lia].
  - exact LY.
  - split; [exact Fi|]. split; [exact Ei'|]. rewrite <- Ei'. exact Pi.
  - exact (conj Fab Eab).
  - split; [exact Fq|]. rewrite <- Eh'. apply (sign_of_value _ Fh Nh).
  - exact Small.
  - (* the error *)
    assert (Mono : forall a b, a <= b -> rnd a <= rnd b)
      by (intros; apply round_le; auto with typeclass_instances).
    assert (Same : forall a, fmt a -> rnd a = a) by (intros; apply round_generic; [apply valid_rnd_N | assumption]).
    assert (Ftu : fmt turn) by (rewrite <- Et'; apply fmt_val). assert (Fro : fmt r) by (rewrite <- Er'; apply fmt_val).
    assert (S1 : rnd (rnd (turn + norm) * X 3%nat) + r <= / 16 + / 16).
    { apply Rnot_lt_le. intro L. assert (/ 16 <= slack); [|lra].
      rewrite <- (Same (/ 16)); [apply Mono; lra|].
      replace (/ 16) with (bpow radix2 (-4)) by reflexivity. apply generic_format_FLT_bpow; [reflexivity | lia]. }
    assert (T1 : turn <= rnd (turn + norm)) by (rewrite <- (Same turn) at 1 by exact Ftu; apply Mono; lra).
    assert (T2 : turn * X 3%nat <= rnd (turn + norm) * X 3%nat) by (apply Rmult_le_compat_r; lra).
    assert (T3 := Mono _ _ T2). assert (T4 : 0 <= rnd (turn * X 3%nat)).
    { rewrite <- (Same 0) by apply generic_format_0. apply Mono, Rmult_le_pos; lra. }
    assert (T5 : turn * X 3%nat <= 1).
    { apply Rnot_lt_le. intro L. assert (1 <= rnd (turn * X 3%nat)); [|lra].
      rewrite <- (Same 1) at 1; [apply Mono; lra|].
      replace 1 with (bpow radix2 0) by reflexivity. apply generic_format_FLT_bpow; [reflexivity | lia]. }
    destruct (mul_term_forward x turn_behind old_error Ft (direction_is_finite 3%nat ltac:(lia))) as [Fm Em].
    { fold (value turn_behind). rewrite Et'. change (val (on_doubles x old_error)) with (X 3%nat).
      rewrite Rabs_pos_eq by (apply Rmult_le_pos; lra).
      eapply Rle_trans; [exact T5|]. change 1 with (bpow radix2 0). apply bpow_le. lia. }
    fold (value turn_behind) in Em. rewrite Et' in Em. change (val (on_doubles x old_error)) with (X 3%nat) in Em.
    change error_behind with (replace (fun n => match n with 0%nat => Mul turn_behind old_error
      | 1%nat => rounding_behind | _ => slack_behind end)
      (Mul (Add (Var 0) (Var 1)) (Add one (Mul (Cst (fst kTangentBehind) (snd kTangentBehind)) (Var 2))))).
    unfold value. rewrite on_doubles_replace. set (w n := on_doubles x (match n with 0%nat => Mul turn_behind old_error
      | 1%nat => rounding_behind | _ => slack_behind end)).
    assert (W0 : val (w 0%nat) = rnd (turn * X 3%nat)) by exact Em.
    assert (W1 : val (w 1%nat) = r) by exact Er'. assert (W2 : val (w 2%nat) = slack) by exact Es'.
    destruct (forward w (fun n => if (n <? 3)%nat then 0 else 5000)%Z
      (Mul (Add (Var 0) (Var 1)) (Add one (Mul (Cst (fst kTangentBehind) (snd kTangentBehind)) (Var 2)))) 6)
      as [Fer [Eer _]].
    + assert (One : bpow radix2 0 = 1) by reflexivity.
      intros [|[|[|n]]] Hn; [| | |discriminate Hn]; cbn [Nat.ltb Nat.leb]; rewrite One.
      * split; [exact Fm|]. rewrite W0, Rabs_pos_eq; lra.
      * split; [exact Fr|]. rewrite W1, Rabs_pos_eq; lra.
      * split; [exact Fs|]. rewrite W2, Rabs_pos_eq; lra.
    + vm_compute. reflexivity.
    + split; [exact Fer|]. rewrite Eer. unfold rounded, one. cbn [on_reals]. rewrite W0, W1, W2.
      replace (F2R (Float radix2 1 0)) with 1 by (unfold F2R; cbn; lra). reflexivity.
Qed.
End Behind.
