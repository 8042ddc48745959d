(* The filter of the nearest samples, as src/geometry/distance_filter.h computes it: where a sample's rounded distance
   is above the reach of another one's, it is farther from the position. The position is a point of real numbers, and
   its nearest doubles are finite; the samples are finite. Distances may overflow and underflow. *)
From Coq Require Import Reals ZArith QArith Qreals Lra Lia Psatz Bool List.
From Flocq Require Import Core BinarySingleNaN.
From Flowcert Require Import algebra.Vector3 code.Expression code.generated.Constants
  filters.Rounding filters.RoundedVectors filters.Norms filters.Floors filters.Doubles filters.Terms filters.Filter
  filters.Predicates filters.Cells.
From Flowcert Require code.generated.Distances.
Module Code := code.generated.Distances.Distances.
Import ListNotations.
Open Scope R_scope.

(* ---- A rounded distance ---- *)

(* What underflow takes away. *)
Definition lost := / 10 ^ 150.
Lemma lost_pos : 0 < lost. Proof. unfold lost. apply Rinv_0_lt_compat, pow_lt; lra. Qed.
Lemma tau_lost : tau <= lost * lost.
Proof.
  eapply Rle_trans; [apply tau_small|]. unfold lost. right. rewrite <- Rinv_mult, <- pow_add. reflexivity.
Qed.

Lemma root_of_sum : forall s a b, 0 <= s -> 0 <= a -> 0 <= b -> s * s <= a * a + b * b -> s <= a + b.
Proof. intros. apply Rsqr_incr_0_var; [unfold Rsqr; nra | lra]. Qed.

Lemma distance_error : forall p q, fmt3 p -> fmt3 q -> let D := len (vsub p q) in
  D * (1 - 3.51 * u) - lost <= rlen (rsub p q) <= D * (1 + 3.51 * u) + lost.
Proof.
  intros p q Fp Fq D. set (a := rsub p q). set (x := vsub p q).
  assert (Ha : vapprox 1 a x) by (apply vapprox_difference; assumption).
  generalize (rdot_approx 1 1 _ _ _ _ Ha Ha). change (1 + 1 + 3)%nat with 5%nat. rewrite absdot_self.
  intros [_ HS _]. unfold rlen. set (S := rdot a a) in *. set (s := sqrt S).
  assert (Hr : Rabs (rnd s - s) <= u * Rabs s + u * tau) by apply rnd_any.
  assert (Hs0 : 0 <= s) by apply sqrt_pos. rewrite (Rabs_pos_eq s Hs0) in Hr.
  generalize tau_pos tau_lost u_pos u_val lost_pos. intros T0 T1 U0 Hu L0.
  rewrite <- len_sq in HS. change (len x) with D in HS. assert (D0 : 0 <= D) by apply len_nonneg.
  assert (E5 : E 5 <= 5.0001 * u) by (unfold E; rewrite Hu; simpl; lra). assert (E50 := E_nonneg 5).
  assert (B : E 5 * (D * D + 3 * tau) <= 5.0001 * u * (D * D) + / 100 * (lost * lost)).
  { apply Rle_trans with (5.0001 * u * (D * D + 3 * tau)); [apply Rmult_le_compat_r; nra|].
    rewrite Hu in *. nra. }
  apply Rabs_le_inv in HS. apply Rabs_le_inv in Hr.
  assert (D2 : 0 <= D * D) by nra.
  assert (L2 : lost <= / 10 ^ 2) by (unfold lost; apply Rinv_le; [apply pow_lt; lra | apply Rle_pow; [lra | lia]]).
  assert (Small : u * tau <= / 10 * lost).
  { assert (u * tau <= u * (lost * lost)) by (apply Rmult_le_compat_l; lra). rewrite Hu in *. nra. }
  split.
  - assert (R : D * (1 - 2.5001 * u) <= s + / 10 * lost).
    { apply root_of_sum; [apply Rmult_le_pos; [exact D0 | rewrite Hu; lra] | exact Hs0 | lra |].
      destruct (Rle_or_lt 0 S) as [P|P].
      - unfold s. rewrite sqrt_sqrt by exact P.
        replace (D * (1 - 2.5001 * u) * (D * (1 - 2.5001 * u))) with (D * D * ((1 - 2.5001 * u) * (1 - 2.5001 * u)))
          by ring.
        assert (D * D * ((1 - 2.5001 * u) * (1 - 2.5001 * u)) <= D * D * (1 - 5.0001 * u))
          by (apply Rmult_le_compat_l; [exact D2 | rewrite Hu; lra]).
        lra.
      - replace s with 0 by (unfold s; symmetry; apply sqrt_neg_0; lra).
        replace (D * (1 - 2.5001 * u) * (D * (1 - 2.5001 * u))) with (D * D * ((1 - 2.5001 * u) * (1 - 2.5001 * u)))
          by ring.
        assert (D * D * ((1 - 2.5001 * u) * (1 - 2.5001 * u)) <= D * D * (1 - 5.0001 * u))
          by (apply Rmult_le_compat_l; [exact D2 | rewrite Hu; lra]).
        lra. }
    assert (D * (1 - 3.51 * u) <= D * ((1 - 2.5001 * u) * (1 - u))) by (apply Rmult_le_compat_l; [exact D0|];
      rewrite Hu; lra).
    assert ((D * (1 - 2.5001 * u)) * (1 - u) <= (s + / 10 * lost) * (1 - u)) by (apply Rmult_le_compat_r; lra).
    assert (0 <= / 10 * lost * u) by (apply Rmult_le_pos; lra). lra.
  - assert (R : s <= D * (1 + 2.5001 * u) + / 10 * lost).
    { apply root_of_sum; [exact Hs0 | apply Rmult_le_pos; [exact D0 | rewrite Hu; lra] | lra |].
      destruct (Rle_or_lt 0 S) as [P|P].
      - unfold s. rewrite sqrt_sqrt by exact P.
        replace (D * (1 + 2.5001 * u) * (D * (1 + 2.5001 * u))) with (D * D * ((1 + 2.5001 * u) * (1 + 2.5001 * u)))
          by ring.
        assert (D * D * (1 + 5.0001 * u) <= D * D * ((1 + 2.5001 * u) * (1 + 2.5001 * u)))
          by (apply Rmult_le_compat_l; [exact D2 | rewrite Hu; lra]).
        lra.
      - replace s with 0 by (unfold s; symmetry; apply sqrt_neg_0; lra). nra. }
    assert (D * ((1 + 2.5001 * u) * (1 + u)) <= D * (1 + 3.51 * u)) by (apply Rmult_le_compat_l; [exact D0|];
      rewrite Hu; lra).
    assert (s * (1 + u) <= (D * (1 + 2.5001 * u) + / 10 * lost) * (1 + u)) by (apply Rmult_le_compat_r; lra).
    assert (/ 10 * lost * u <= / 10 * lost * / 100) by (apply Rmult_le_compat_l; [lra | rewrite Hu; lra]). lra.
Qed.

(* ---- On doubles ---- *)

(* The position is point 0, and the sample is point 1. *)
Definition distance y := on_doubles y Code.distance.
Definition true_distance y := len (vsub (at_point y 1) (at_point y 0)).
Definition far := bpow radix2 505.

(* A distance is never less than nothing, and where it overflows the sample is far. *)
Lemma distance_on_doubles : forall y, (forall n, finite (y n)) ->
  (finite (distance y) /\
   true_distance y * (1 - 3.51 * u) - lost <= val (distance y) <= true_distance y * (1 + 3.51 * u) + lost) \/
  (distance y = B754_infinity false /\ far < true_distance y).
Proof.
  intros y Fy. set (x n := on_doubles y (between [(0, 1)]%nat n)).
  assert (E : distance y = on_doubles x (norm 0)).
  { unfold distance. replace Code.distance with (replace (between [(0, 1)]%nat) (norm 0)) by by_computation.
    apply on_doubles_replace. }
  assert (N := norm_nonnegative [(0, 1)]%nat y Fy 0). fold x in N. rewrite E.
  destruct (is_finite (on_doubles x (norm 0))) eqn:F.
  - left. split; [exact F|].
    destruct (vector_back [(0, 1)]%nat y 0 F) as [_ [p [q [Fp [Fq [_ [V W]]]]]]].
    change (val (on_doubles x (norm 0)) = rlen (rsub p q)) in W. rewrite W.
    replace (true_distance y) with (len (vsub p q)) by (rewrite <- V; reflexivity).
    apply distance_error; assumption.
  - right. destruct N as [N S].
    split. { destruct (on_doubles x (norm 0)) as [s|s| |s m e H]; try discriminate; cbn in S; subst s; reflexivity. }
    apply Rnot_le_lt. intro D. unfold true_distance in D. destruct (coordinate_bound _ _ D) as [D1 [D2 D3]].
    assert (C : forall i, (i < 3)%nat -> finite (x i) /\ Rabs (val (x i)) <= far).
    { assert (M : forall p q : double, finite p -> finite q -> Rabs (val p - val q) <= far ->
        finite (Bminus mode_NE p q) /\ Rabs (val (Bminus mode_NE p q)) <= far).
      { intros p q Fp Fq B. generalize (Bminus_correct 53 1024 _ _ mode_NE p q Fp Fq).
        change (round radix2 (SpecFloat.fexp 53 1024) (round_mode mode_NE)) with rnd.
        rewrite Rlt_bool_true by (apply (no_overflow _ 505); [lia | exact B]).
        intros [V [G _]]. split; [exact G|]. unfold val at 1. rewrite V. apply rnd_power; [lia | exact B]. }
      intros [|[|[|i]]] Hi; [| | | lia]; apply M; try apply Fy; assumption. }
    assert (G : finite (on_doubles x (edot (given 0) (given 0)))).
    { destruct (forward x (fun n => if (n <? 3)%nat then 505%Z else 5000%Z) (edot (given 0) (given 0)) 1012)
        as [G _]; [|reflexivity | exact G].
      intros n H. destruct (Nat.ltb_spec n 3) as [L|L]; [apply C, L | discriminate]. }
    assert (R := sum_nonnegative _ _ (sum_nonnegative _ _ (square_nonnegative _ (finite_number _ (proj1 (C 0%nat
      ltac:(lia)))))
      (square_nonnegative _ (finite_number _ (proj1 (C 1%nat ltac:(lia))))))
      (square_nonnegative _ (finite_number _ (proj1 (C 2%nat ltac:(lia)))))).
    change (nonnegative (on_doubles x (edot (given 0) (given 0)))) in R. destruct R as [_ R].
    unfold norm in F. cbn [on_doubles] in F.
    destruct (Bsqrt_correct 53 1024 _ _ mode_NE (on_doubles x (edot (given 0) (given 0)))) as [_ [Q _]].
    rewrite F in Q. destruct (on_doubles x (edot (given 0) (given 0))) as [s|s| |s m e H]; try discriminate.
    cbn [Bsign] in R. subst s. discriminate.
Qed.

(* ---- The reach ---- *)

(* The constants of the generated term, and what they have to be. *)
Definition factor : (Z * Z) * (Z * Z) * (Z * Z) :=
  match Code.reach with
  | Choose _ _ (Add (Add (Mul _ (Cst m k)) (Mul (Cst n l) _)) (Cst o j)) _ _ => ((m, k), (n, l), (o, j))
  | _ => ((0, 0), (0, 0), (0, 0))
  end%Z.
Definition of_distance := fst (fst factor).
Definition of_position := snd (fst factor).
Definition of_underflow := snd factor.
Definition value_of (k : Z * Z) := rational (fst k) (snd k).
Definition bound_of_distance := Add (Add (Mul (Var 0) (Cst (fst of_distance) (snd of_distance)))
  (Mul (Cst (fst of_position) (snd of_position)) (Var 1))) (Cst (fst of_underflow) (snd of_underflow)).
Definition limit := Cst (fst kLargestDistance) (snd kLargestDistance).
Theorem reach_matches : Code.reach = Choose Less limit bound_of_distance Infinite bound_of_distance.
Proof. by_computation. Qed.
(* They are those of the header, in units of u, without rounding. *)
Theorem constants_match :
  Qeq_bool (value_of of_distance) (1 + value_of kDistanceBound * unit) = true /\
  Qeq_bool (value_of of_position) (value_of kPositionBound * unit) = true /\ of_underflow = kDistanceUnderflow.
Proof. repeat split; by_computation. Qed.

Definition distance_needs : Q := 1004 # 100.
Definition position_needs : Q := 3465 # 1000.
Definition underflow_needs : Q := 4 # 10 ^ 150.
Definition distance_allows : Q := 2 * 10 ^ 151 # 1.
Theorem constants_are_enough :
  Qle_bool distance_needs (value_of kDistanceBound) && Qle_bool position_needs (value_of kPositionBound) &&
  Qle_bool underflow_needs (value_of kDistanceUnderflow) && Qle_bool (value_of kLargestDistance) distance_allows &&
  Qle_bool (value_of kDistanceBound) 1000 && Qle_bool (value_of kPositionBound) 1000 = true.
Proof. by_computation. Qed.

Lemma rnd_from_below : forall z, 0 <= z -> z * (1 - u) - u * tau <= rnd z.
Proof. intros z Z. generalize (rnd_any z). rewrite (Rabs_pos_eq z Z). intro H. apply Rabs_le_inv in H. lra. Qed.

(* For the distances D from the rounded position and the way delta from the position to that. *)
Lemma reach_covers : forall D delta d L c p l, 0 <= D -> 0 <= d -> 0 <= L -> D * (1 - 3.51 * u) - lost <= d ->
  delta <= 1.7321 * (u * (1 + 2 * u) * L + 2 * u * tau) ->
  1 + 10.04 * u <= c <= 1 + 1000 * u -> 3.465 * u <= p <= 1000 * u -> 4 * lost <= l ->
  (D + 2 * delta) * (1 + 3.51 * u) + lost <= rnd (rnd (rnd (d * c) + rnd (p * L)) + l).
Proof.
  intros D delta d L c p l HD Hd HL Below Delta [C1 C2] [P1 P2] Low.
  generalize tau_pos tau_lost u_pos u_val lost_pos. intros T0 T1 U0 Hu L0.
  assert (Small : u * tau <= / 1000 * lost).
  { assert (u * tau <= u * (lost * lost)) by (apply Rmult_le_compat_l; lra).
    assert (L2 : lost <= / 10 ^ 2) by (unfold lost; apply Rinv_le; [apply pow_lt; lra | apply Rle_pow; [lra | lia]]).
    assert (lost * lost <= lost * 1) by (apply Rmult_le_compat_l; lra). rewrite Hu in *. lra. }
  set (e := u * tau) in *. assert (E0 : 0 < e) by (apply Rmult_lt_0_compat; lra).
  assert (R : forall z, 0 <= z -> z * (1 - u) - e <= rnd z) by apply rnd_from_below.
  assert (V : 0 < 1 - u <= 1) by (rewrite Hu; lra).
  assert (N : forall z, 0 <= z -> 0 <= rnd z).
  { intros z Z. unfold rnd. apply round_ge_generic; auto with typeclass_instances. apply generic_format_0. }
  assert (A0 : 0 <= d * c) by (apply Rmult_le_pos; lra). assert (B0 : 0 <= p * L) by (apply Rmult_le_pos; lra).
  assert (A1 := R _ A0). assert (B1 := R _ B0). assert (A2 := N _ A0). assert (B2 := N _ B0).
  assert (S1 := R (rnd (d * c) + rnd (p * L)) ltac:(lra)). assert (S2 := N (rnd (d * c) + rnd (p * L)) ltac:(lra)).
  set (s := rnd (rnd (d * c) + rnd (p * L))) in *. assert (F := R (s + l) ltac:(lra)).
  eapply Rle_trans; [|exact F].
  assert (S3 : (d * c + p * L) * ((1 - u) * (1 - u)) - 3 * e <= s).
  { eapply Rle_trans; [|exact S1].
    assert ((d * c * (1 - u) - e + (p * L * (1 - u) - e)) * (1 - u) <= (rnd (d * c) + rnd (p * L)) * (1 - u))
      by (apply Rmult_le_compat_r; lra).
    assert (2 * e * (1 - u) <= 2 * e * 1) by (apply Rmult_le_compat_l; lra). lra. }
  assert (S4 : ((d * c + p * L) * ((1 - u) * (1 - u)) - 3 * e) * (1 - u) <= s * (1 - u))
    by (apply Rmult_le_compat_r; lra).
  assert (S5 : 3 * e * (1 - u) <= 3 * e * 1) by (apply Rmult_le_compat_l; lra).
  assert (S6 : 4 * lost * (1 - u) <= l * (1 - u)) by (apply Rmult_le_compat_r; lra).
  assert (S7 : 4 * lost * u <= / 1000 * lost) by (rewrite Hu; lra).
  (* the distance *)
  assert (X1 : (D * (1 - 3.51 * u) - lost) * (c * ((1 - u) * (1 - u) * (1 - u))) <=
    d * (c * ((1 - u) * (1 - u) * (1 - u)))).
  { apply Rmult_le_compat_r; [|exact Below]. repeat apply Rmult_le_pos; lra. }
  set (w := (1 - u) * (1 - u) * (1 - u)) in *.
  assert (W : 1 - 3 * u <= w <= 1) by (unfold w; rewrite Hu; lra).
  assert (X2 : 1 + 3.52 * u <= (1 - 3.51 * u) * (c * w)).
  { apply Rle_trans with ((1 - 3.51 * u) * ((1 + 10.04 * u) * (1 - 3 * u))); [rewrite Hu; lra|].
    apply Rmult_le_compat_l; [rewrite Hu; lra|]. apply Rmult_le_compat; rewrite ?Hu in *; lra. }
  assert (X3 : D * (1 + 3.52 * u) <= D * ((1 - 3.51 * u) * (c * w))) by (apply Rmult_le_compat_l; lra).
  assert (X4 : lost * (c * w) <= lost * 1.001).
  { apply Rmult_le_compat_l; [lra|]. apply Rle_trans with (c * 1); [apply Rmult_le_compat_l; lra|]. rewrite Hu in *.
    lra. }
  (* the position *)
  assert (Y1 : 3.4645 * u * L <= p * L * w).
  { replace (p * L * w) with (p * w * L) by ring. apply Rmult_le_compat_r; [exact HL|].
    apply Rle_trans with (3.465 * u * (1 - 3 * u)); [rewrite Hu; lra|]. apply Rmult_le_compat; rewrite ?Hu in *; lra. }
  assert (Y2 : 2 * delta * (1 + 3.51 * u) <= 3.4643 * u * L + 10 * e).
  { apply Rle_trans with (2 * (1.7321 * (u * (1 + 2 * u) * L + 2 * e)) * (1 + 3.51 * u)).
    - apply Rmult_le_compat_r; [rewrite Hu; lra|]. unfold e. lra.
    - assert (Z : 2 * 1.7321 * ((1 + 2 * u) * (1 + 3.51 * u)) * (u * L) <= 3.4643 * (u * L)).
      { apply Rmult_le_compat_r; [apply Rmult_le_pos; lra | rewrite Hu; lra]. }
      assert (Z2 : 2 * 1.7321 * 2 * (1 + 3.51 * u) * e <= 10 * e) by (apply Rmult_le_compat_r; [lra | rewrite Hu; lra]).
      lra. }
  assert (Y3 : 3.4643 * u * L <= 3.4645 * u * L).
  { assert (0 <= u * L) by (apply Rmult_le_pos; lra). lra. }
  assert (D * (1 + 3.51 * u) <= D * (1 + 3.52 * u)) by (apply Rmult_le_compat_l; lra).
  unfold w in *. lra.
Qed.

Lemma constant_of_header : forall k : Z * Z, (Z.abs (fst k) < 2 ^ 53)%Z -> (-1000 <= snd k <= 900)%Z -> forall x,
  finite (on_doubles x (Cst (fst k) (snd k))) /\ val (on_doubles x (Cst (fst k) (snd k))) = Q2R (value_of k).
Proof.
  intros k M E x. assert (B := mantissa_bits _ M).
  destruct (normal_constant (fst k) (snd k) (Z.log2 (Z.abs (fst k)) + 1 + snd k) M ltac:(lia) ltac:(lia) eq_refl)
    as [F V]. split; [exact F|]. unfold value_of. rewrite rational_value. exact V.
Qed.

(* Variable 0 is the distance, and variable 1 the largest coordinate. *)
Definition given_to_reach (d L : double) (n : nat) := match n with 0%nat => d | _ => L end.
Definition reach d L := on_doubles (given_to_reach d L) Code.reach.

Lemma finite_reach : forall d L r, nonnegative d -> finite L -> nonnegative L -> Bltb (reach d L) r = true ->
  finite d /\ finite (reach d L) /\ val (reach d L) <= Q2R distance_allows /\
  exists c p l, 1 + 10.04 * u <= c <= 1 + 1000 * u /\ 3.465 * u <= p <= 1000 * u /\ 4 * lost <= l /\
  val (reach d L) = rnd (rnd (rnd (val d * c) + rnd (p * val L)) + l).
Proof.
  intros d L r [Nd Sd] FL [NL SL] H.
  assert (E : reach d L = let b := on_doubles (given_to_reach d L) bound_of_distance in
    if Bltb (on_doubles (given_to_reach d L) limit) b then B754_infinity false else b).
  { unfold reach. rewrite reach_matches. reflexivity. }
  cbv zeta in E.
  assert (P : not_negative (on_doubles (given_to_reach d L) bound_of_distance)).
  { apply positive_not_negative; [|reflexivity]. intros [|n]; right; [exact Sd | exact SL]. }
  destruct (constant_of_header kLargestDistance) with (x := given_to_reach d L) as [Fm Vm];
    [reflexivity | vm_compute; split; discriminate|].
  fold limit in Fm, Vm.
  destruct (constant_of_header of_distance) with (x := given_to_reach d L) as [Fc Vc];
    [reflexivity | vm_compute; split; discriminate|].
  destruct (constant_of_header of_position) with (x := given_to_reach d L) as [Fp Vp];
    [reflexivity | vm_compute; split; discriminate|].
  destruct (constant_of_header of_underflow) with (x := given_to_reach d L) as [Fl Vl];
    [reflexivity | vm_compute; split; discriminate|].
  assert (B : on_doubles (given_to_reach d L) bound_of_distance = Bplus mode_NE (Bplus mode_NE
    (Bmult mode_NE d (on_doubles (given_to_reach d L) (Cst (fst of_distance) (snd of_distance))))
    (Bmult mode_NE (on_doubles (given_to_reach d L) (Cst (fst of_position) (snd of_position))) L))
    (on_doubles (given_to_reach d L) (Cst (fst of_underflow) (snd of_underflow)))) by reflexivity.
  set (b := on_doubles (given_to_reach d L) bound_of_distance) in *.
  revert Fm Vm Fc Vc Fp Vp Fl Vl B E.
  generalize (on_doubles (given_to_reach d L) limit) (on_doubles (given_to_reach d L) (Cst (fst of_distance) (snd
    of_distance))) (on_doubles (given_to_reach d L) (Cst (fst of_position) (snd of_position)))
    (on_doubles (given_to_reach d L) (Cst (fst of_underflow) (snd of_underflow))).
  clearbody b. intros m c p l Fm Vm Fc Vc Fp Vp Fl Vl B E.
  destruct (Bltb m b) eqn:T.
  { rewrite E in H. destruct r as [s|s| |s k e G]; try discriminate; destruct s; discriminate. }
  rewrite E in *. clear E.
  assert (Fb : finite b).
  { destruct b as [s|s| |s k e G]; try reflexivity; exfalso.
    - destruct P as [P|P]; [discriminate|]. cbn in P. subst s.
      destruct m as [s|s| |s k e G]; try discriminate; destruct s; discriminate.
    - destruct r; discriminate. }
  assert (Eb := B). rewrite B in Fb. destruct (add_back _ _ Fb) as [F1 [_ V1]]. destruct (add_back _ _ F1) as [F2 [F3
    V2]].
  destruct (mul_back _ _ F2) as [Fd [_ V3]]. destruct (mul_back _ _ F3) as [_ [_ V4]]. rewrite <- B in Fb, V1.
  split; [exact Fd|]. split; [exact Fb|].
  assert (Good := constants_are_enough). rewrite !andb_true_iff, !Qle_bool_iff in Good.
  destruct Good as [[[[[G1 G2] G3] G4] G5] G6]. apply Qle_Rle in G1, G2, G3, G4, G5, G6.
  destruct constants_match as [M1 [M2 M3]]. apply Qeq_bool_eq, Qeq_eqR in M1, M2.
  rewrite Q2R_plus, Q2R_mult, unit_u, Q2R_1 in M1. rewrite Q2R_mult, unit_u in M2.
  assert (U := u_pos).
  split.
  - assert (Hb : compare_doubles Less m b = false) by exact T. rewrite compare_finite in Hb by assumption.
    cbn [compare_reals] in Hb. revert Hb. case Rlt_bool_spec; [discriminate|]. intros Hb _. lra.
  - exists (val c), (val p), (val l). rewrite Vc, Vp, Vl, M1, M2, M3, V1, V2, V3, V4, Vc, Vp, Vl, M1, M2, M3.
    assert (N1 : Q2R distance_needs = 10.04) by (unfold Q2R; cbn; lra).
    assert (N2 : Q2R position_needs = 3.465) by (unfold Q2R; cbn; lra).
    assert (N3 : Q2R 1000 = 1000) by (unfold Q2R; cbn; lra).
    assert (N4 : Q2R underflow_needs = 4 * lost).
    { unfold Q2R, lost, underflow_needs. cbn [Qnum Qden].
      replace (10 ^ 150)%positive with (Z.to_pos (10 ^ Z.of_nat 150)) by (vm_compute; reflexivity).
      rewrite Z2Pos.id by reflexivity. rewrite <- pow_IZR. reflexivity. }
    rewrite N1 in G1. rewrite N2 in G2. rewrite N4 in G3. rewrite N3 in G5, G6.
    assert (K1 : 10.04 * u <= Q2R (value_of kDistanceBound) * u) by (apply Rmult_le_compat_r; lra).
    assert (K2 : Q2R (value_of kDistanceBound) * u <= 1000 * u) by (apply Rmult_le_compat_r; lra).
    assert (K3 : 3.465 * u <= Q2R (value_of kPositionBound) * u) by (apply Rmult_le_compat_r; lra).
    assert (K4 : Q2R (value_of kPositionBound) * u <= 1000 * u) by (apply Rmult_le_compat_r; lra).
    repeat split; lra.
Qed.

(* How far the position is from its nearest doubles. *)
Lemma rounding_of_position : forall X R L, vx R = rnd (vx X) -> vy R = rnd (vy X) -> vz R = rnd (vz X) ->
  Rabs (vx R) <= L -> Rabs (vy R) <= L -> Rabs (vz R) <= L ->
  len (vsub X R) <= 1.7321 * (u * (1 + 2 * u) * L + 2 * u * tau).
Proof.
  intros X R L Rx Ry Rz Bx By Bz. generalize tau_pos u_pos u_val. intros T0 U0 Hu.
  set (m := u * (1 + 2 * u) * L + 2 * u * tau).
  assert (C : forall r z, r = rnd z -> Rabs r <= L -> Rabs (z - r) <= m).
  { intros r z Er B. subst r. assert (H := rnd_any z). rewrite Rabs_minus_sym.
    assert (A : Rabs z <= Rabs (rnd z) + Rabs (rnd z - z)).
    { replace z with (rnd z - (rnd z - z)) at 1 by ring. eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_Ropp.
      lra. }
    assert (L0 : 0 <= L) by (generalize (Rabs_pos (rnd z)); lra).
    assert (T : u * tau <= tau * / 100) by (rewrite Hu; lra).
    assert (Z : Rabs z * (1 - u) <= L + u * tau) by lra.
    assert (Z2 : Rabs z <= (L + u * tau) * (1 + 2 * u)).
    { apply Rmult_le_reg_r with (1 - u); [rewrite Hu; lra|]. eapply Rle_trans; [exact Z|].
      rewrite Rmult_assoc. rewrite <- (Rmult_1_r (L + u * tau)) at 1. apply Rmult_le_compat_l.
      - assert (0 < u * tau) by (apply Rmult_lt_0_compat; lra). lra.
      - rewrite Hu. lra. }
    eapply Rle_trans; [exact H|]. assert (u * Rabs z <= u * ((L + u * tau) * (1 + 2 * u))) by (apply
      Rmult_le_compat_l; lra).
    assert (u * (u * tau * (1 + 2 * u)) <= u * tau).
    { replace (u * (u * tau * (1 + 2 * u))) with (u * tau * (u * (1 + 2 * u))) by ring.
      rewrite <- (Rmult_1_r (u * tau)) at 2. apply Rmult_le_compat_l; [apply Rmult_le_pos; lra | rewrite Hu; lra]. }
    unfold m. lra. }
  assert (M0 : 0 <= m) by (generalize (C _ _ Rx Bx) (Rabs_pos (vx X - vx R)); lra).
  apply len_le; [lra|]. assert (Q : forall t, Rabs t <= m -> t * t <= m * m).
  { intros t Ht. generalize (Rabs_pos t). replace (t * t) with (Rabs t * Rabs t). { intro. apply Rmult_le_compat; lra. }
    rewrite <- Rabs_mult. apply Rabs_pos_eq. nra. }
  assert (Q1 := Q _ (C _ _ Rx Bx)). assert (Q2 := Q _ (C _ _ Ry By)). assert (Q3 := Q _ (C _ _ Rz Bz)).
  unfold dot, vsub. cbn [vx vy vz]. assert (0 <= m * m) by nra. lra.
Qed.

(* y has the rounded position and the farther sample, z the same position and the other one. *)
Theorem farther_right : forall X L y z, (forall n, finite (y n)) -> (forall n, finite (z n)) ->
  (forall n, (n < 3)%nat -> z n = y n) ->
  val (y 0%nat) = rnd (vx X) -> val (y 1%nat) = rnd (vy X) -> val (y 2%nat) = rnd (vz X) ->
  finite L -> nonnegative L -> (forall n, (n < 3)%nat -> Rabs (val (y n)) <= val L) ->
  Bltb (reach (distance z) L) (distance y) = true -> len (vsub (at_point z 1) X) < len (vsub (at_point y 1) X).
Proof.
  intros X L y z Fy Fz Same Rx Ry Rz FL NL BL H.
  set (R := at_point y 0). assert (RZ : at_point z 0 = R).
  { unfold R, at_point. cbn [Nat.mul Nat.add]. rewrite !Same by lia. reflexivity. }
  assert (Nd : nonnegative (distance z)).
  { unfold distance. replace Code.distance with (replace (between [(0, 1)]%nat) (norm 0)) by by_computation.
    rewrite on_doubles_replace. apply norm_nonnegative, Fz. }
  destruct (finite_reach _ _ _ Nd FL NL H) as [Fd [Fr [Top [c [p [l [C [P [Low E]]]]]]]]].
  destruct (distance_on_doubles z Fz) as [[_ [Below _]]|[I _]]; [|rewrite I in Fd; discriminate].
  assert (Delta := rounding_of_position X R (val L) Rx Ry Rz (BL 0 ltac:(lia))%nat (BL 1 ltac:(lia))%nat (BL 2
    ltac:(lia))%nat).
  assert (Pd : 0 <= val (distance z)).
  { destruct Nd as [_ S]. destruct (distance z) as [s|s| |s m e G]; try discriminate; cbn in S; subst s; [cbn; lra|].
    apply F2R_ge_0. discriminate. }
  assert (PL : 0 <= val L) by (generalize (BL 0%nat ltac:(lia)) (Rabs_pos (val (y 0%nat))); lra).
  assert (Cover := reach_covers (true_distance z) (len (vsub X R)) (val (distance z)) (val L) c p l (len_nonneg _) Pd PL
    Below Delta C P Low).
  rewrite <- E in Cover.
  assert (Dy : true_distance z + 2 * len (vsub X R) < true_distance y).
  { generalize u_pos u_val lost_pos (len_nonneg (vsub X R)) (len_nonneg (vsub (at_point z 1) (at_point z 0))).
    fold (true_distance z). intros U0 Hu L0 D0 Z0.
    destruct (distance_on_doubles y Fy) as [[F [_ Above]]|[_ Far]].
    - change (compare_doubles Less (reach (distance z) L) (distance y) = true) in H. rewrite compare_finite in H by
      assumption.
      cbn [compare_reals] in H. revert H. case Rlt_bool_spec; [|discriminate]. intros H _.
      apply Rmult_lt_reg_r with (1 + 3.51 * u); [rewrite Hu; lra|]. lra.
    - apply Rle_lt_trans with far; [|exact Far]. apply Rle_trans with (Q2R distance_allows).
      + assert ((true_distance z + 2 * len (vsub X R)) * 1 <= (true_distance z + 2 * len (vsub X R)) * (1 + 3.51 * u))
          by (apply Rmult_le_compat_l; lra). lra.
      + unfold far, distance_allows. rewrite <- (IZR_Zpower radix2) by lia. unfold Q2R. cbn [Qnum Qden].
        rewrite Rinv_1, Rmult_1_r. apply IZR_le. vm_compute. discriminate. }
  unfold true_distance in Dy. rewrite RZ in Dy. fold R in Dy.
  assert (T1 := len_triangle (vsub (at_point z 1) R) (vsub R X)).
  assert (T2 := len_triangle (vsub (at_point y 1) X) (vsub X R)).
  replace (vadd (vsub (at_point z 1) R) (vsub R X)) with (vsub (at_point z 1) X) in T1 by (apply vec_eq; cbn; ring).
  replace (vadd (vsub (at_point y 1) X) (vsub X R)) with (vsub (at_point y 1) R) in T2 by (apply vec_eq; cbn; ring).
  assert (S : len (vsub R X) = len (vsub X R)).
  { unfold len. apply f_equal. unfold dot, vsub; cbn [vx vy vz]. ring. }
  lra.
Qed.
