(* The three signs that steer a moving point, as src/flow/kernels/direction.h computes them: where a direction is known
   (Directions.v), an answer is the sign of the exact linear form in the true direction. The points may be any doubles,
   also infinities and NaN. *)
From Coq Require Import Reals ZArith QArith Qreals Lra Lia Psatz Bool List.
From Flocq Require Import Core BinarySingleNaN.
From Flowcert Require Import algebra.Vector3 code.Expression code.generated.Constants filters.Rounding
  filters.RoundedVectors filters.Norms filters.Floors filters.Doubles filters.Terms filters.Filter filters.Directions.
From Flowcert Require code.generated.Directions.
Module Code := code.generated.Directions.
Import ListNotations.
Open Scope R_scope.

(* A constant of direction_bounds.h times the roundoff. *)
Definition in_roundoffs (c : Z * Z) := Cst (fst c) (snd c + snd kUnitRoundoff).
Definition units_of (c : Z * Z) : Q := rational (fst c) (snd c).
Definition point (x : nat -> double) k :=
  V (val (x (3 * k)%nat)) (val (x (3 * k + 1)%nat)) (val (x (3 * k + 2)%nat)).

(* ---- Values ---- *)

Definition top_of_inputs count n :=
  if (n / 3 =? 0)%nat then 1%Z else if (n / 3 <? count)%nat then 88%Z else 5000%Z.
Definition error_of_input k : Q := if (k =? 0)%nat then 0 else unit.
Definition size_of_input pairs y k :=
  if (k =? 0)%nat then 1 + 16 * u else len (value_of_vector (exact_inputs pairs y) k) + / 10 ^ 43.

Definition is_direction (x : nat -> double) :=
  (forall k, (18 <= k <= 20)%nat -> finite (x k)) /\ len (direction_of x) <= 1 + 16 * u.

Lemma value_of_inputs : forall count (value : term Scalar) top pairs y,
  is_above_underflow count value && (1 <=? count)%nat = true -> height (top_of_inputs count) (flatten value) = Some top
    ->
  is_direction y ->
  (forall k, (1 <= k < count)%nat -> exists G, bounded_vector pairs y k G /\ G <= 10 ^ 26) ->
  let x n := on_doubles y (inputs pairs n) in
  finite (on_doubles x (flatten value)) /\ Rabs (val (on_doubles x (flatten value))) <= bpow radix2 top /\
  Rabs (val (on_doubles x (flatten value)) - exact (exact_inputs pairs y) (flatten value)) <=
    Q2R (error error_of_input value) * size (size_of_input pairs y) value.
Proof.
  intros count value top pairs y A H [FU LU] HV x. rewrite andb_true_iff, Nat.leb_le in A. destruct A as [A C1].
  generalize u_pos u_val. intros U0 Hu. assert (P43 : 0 < / 10 ^ 43) by (apply Rinv_0_lt_compat, pow_lt; lra).
  destruct (forward x (top_of_inputs count) (flatten value) top) as [F [Ev [B _]]]; [|exact H|].
  - intros n Hn. unfold top_of_inputs in *. destruct (Nat.eqb_spec (n / 3) 0) as [Z|N].
    + assert (L : (n < 3)%nat) by (apply Nat.div_small_iff in Z; [exact Z | discriminate]).
      unfold x, inputs. replace (n <? 3)%nat with true by (symmetry; apply Nat.ltb_lt, L). cbn [on_doubles].
      split; [apply FU; lia|]. change (bpow radix2 1) with 2.
      assert (L2 : len (direction_of y) <= 2) by (rewrite Hu in *; lra).
      destruct (coordinate_bound _ _ L2) as [L3 [L4 L5]]. unfold direction_of in *. cbn [vx vy vz] in *.
      destruct n as [|[|[|n]]]; [exact L3 | exact L4 | exact L5 | lia].
    + destruct (Nat.ltb_spec (n / 3) count) as [L|L]; [|discriminate].
      destruct (HV (n / 3)%nat ltac:(lia)) as [G [HB HG]].
      assert (M : (n mod 3 < 3)%nat) by (apply Nat.mod_upper_bound; discriminate).
      replace n with (3 * (n / 3) + n mod 3)%nat by (symmetry; apply Nat.div_mod; discriminate).
      apply (coordinate_powers pairs y _ G HB HG _ M).
  - split; [exact F|]. split; [rewrite Ev; exact B|]. rewrite Ev.
    assert (Er := errors count (size_of_input pairs y) error_of_input (fun n => val (x n)) (exact_inputs pairs y)).
    assert (E := Er ltac:(intro k; unfold size_of_input; destruct (k =? 0)%nat;
      [rewrite Hu; lra | generalize (len_nonneg (value_of_vector (exact_inputs pairs y) k)); lra])).
    specialize (E ltac:(
      intros k Hk; unfold size_of_input, error_of_input; destruct (Nat.eqb_spec k 0) as [->|N];
      [ cbn [Nat.mul Nat.add]; change (V (val (x 0%nat)) (val (x 1%nat)) (val (x 2%nat))) with (direction_of y);
        change (V (exact_inputs pairs y 0) (exact_inputs pairs y 1) (exact_inputs pairs y 2)) with (direction_of y);
        split; [repeat split; apply fmt_val | | exact LU | unfold Q2R; cbn; lra];
        replace (vsub (direction_of y) (direction_of y)) with vzero by (apply vec_eq; cbn; ring);
        rewrite len_vzero; unfold Q2R; cbn [Qnum Qden]; lra
      | destruct (HV k ltac:(lia)) as [G [[_ HB _] _]]; rewrite unit_u; exact HB ])).
    destruct (E Scalar value A) as [_ Error _ _]. exact Error.
Qed.

(* ---- Roots ---- *)

Lemma root_forward : forall s : double, finite s -> 0 < val s ->
  finite (Bsqrt mode_NE s) /\ val (Bsqrt mode_NE s) = rnd (sqrt (val s)).
Proof.
  intros s F P. unfold finite, val in *. destruct (Bsqrt_correct 53 1024 _ _ mode_NE s) as [E [Fi _]].
  split; [|exact E]. rewrite Fi. destruct s as [t|t| |t m k H]; try discriminate; [reflexivity|].
  destruct t; [|reflexivity]. exfalso. cbn in P.
  assert (F2R (Float radix2 (Z.neg m) k) <= 0) by (apply F2R_le_0; cbn; lia). lra.
Qed.

(* ---- RayAtInfinity ---- *)

Definition seen_from_edge := [(0, 2); (1, 2)]%nat.
Definition approach := Dot (Given 0) (VPlus (Given 1) (Given 2)).
Definition one := Cst 1 0.
Definition error_variable := Var 21.
Definition size_square pairs i j := replace (inputs pairs) (seen_square i j).
Definition approach_bound := Mul (Add error_variable (in_roundoffs kExitBound)) (Root (size_square seen_from_edge 1 2)).
Definition approach_needs : Q := 1917 # 100.

Lemma approach_match : Code.Approach.sign =
  If Less error_variable one
    (If LessEqual low_square (size_square seen_from_edge 1 2) (If LessEqual (size_square seen_from_edge 1 2) high_square
      (decided (replace (inputs seen_from_edge) (flatten approach)) approach_bound) (Answer None)) (Answer None))
    (Answer None).
Proof. vm_compute. reflexivity. Qed.

Lemma approach_covers : forall t c G S, 0 <= t <= 3 / 32 -> 19.17 * u <= c <= 1000 * u -> fmt t -> fmt c ->
  / 10 ^ 26 <= G -> G * (1 - 4.01 * u) <= S ->
  (t + 12 * u) * (1 + 16 * u) * G + 5.0002 * u * G <= rnd (rnd (t + c) * S).
Proof.
  intros t c G S Ht Hc Ft Fc HG HS. generalize u_pos u_val. intros U0 Hu.
  assert (P := rnd_plus t c Ft Fc). rewrite (Rabs_pos_eq (t + c)) in P by lra. apply Rabs_le_inv in P.
  assert (T : 0 <= t * G <= 3 / 32 * G) by (split; [apply Rmult_le_pos; lra | apply Rmult_le_compat_r; lra]).
  assert (C : 19.17 * u * G <= c * G <= 1000 * u * G) by (split; apply Rmult_le_compat_r; lra).
  set (Z := (t + c) * (1 - u) * (G * (1 - 4.01 * u))).
  assert (HZ : Z <= rnd (t + c) * S).
  { apply Rmult_le_compat; [apply Rmult_le_pos; rewrite ?Hu in *; lra | apply Rmult_le_pos; rewrite ?Hu; lra | lra |
      exact HS]. }
  assert (Low : 19 * u * G <= Z).
  { replace Z with ((t * G + c * G) * ((1 - u) * (1 - 4.01 * u))) by (unfold Z; ring). rewrite Hu in *. lra. }
  assert (Tau : tau <= Z).
  { eapply Rle_trans; [apply (tau_below G); eapply Rle_trans; [|exact HG]; apply Rinv_le; [apply pow_lt; lra | apply
      Rle_pow; [lra | lia]]|]. eapply Rle_trans; [|exact Low]. rewrite Hu. lra. }
  eapply Rle_trans; [|exact (rnd_lower _ Z Tau HZ)].
  replace (Z * (1 - 2 * u)) with ((t * G + c * G) * ((1 - u) * (1 - 4.01 * u) * (1 - 2 * u))) by (unfold Z; ring).
  replace ((t + 12 * u) * (1 + 16 * u) * G) with ((t * G + 12 * u * G) * (1 + 16 * u)) by ring.
  rewrite Hu in *. lra.
Qed.

(* The constants of the header, as numbers. *)
Lemma header_constant : forall k (needs most : Q),
  ((Z.abs (fst k) <? 2 ^ 53)%Z && (-900 <=? snd k)%Z && (snd k <=? 900)%Z && Qle_bool needs (units_of k) &&
   Qle_bool (units_of k) most && (snd kUnitRoundoff =? -53)%Z = true) -> forall x,
  finite (on_doubles x (in_roundoffs k)) /\ Q2R needs * u <= val (on_doubles x (in_roundoffs k)) <= Q2R most * u.
Proof.
  intros [m e] needs most H x. unfold units_of, in_roundoffs in *. cbn [fst snd] in *.
  rewrite !andb_true_iff, Z.ltb_lt, !Z.leb_le, !Qle_bool_iff, Z.eqb_eq in H. destruct H as [[[[[H1 H2] H3] H4] H5] H6].
  rewrite H6. assert (L := mantissa_bits m H1).
  destruct (normal_constant m (e + -53) (Z.log2 (Z.abs m) + 1 + (e + -53)) H1 ltac:(lia) ltac:(lia) eq_refl) as [F W].
  split; [exact F|]. cbn [on_doubles].
  change (val (binary_normalize 53 1024 _ _ mode_NE m (e + -53) false)) with
    (val (binary_normalize 53 1024 eq_refl eq_refl mode_NE m (e + -53) false)). rewrite W.
  replace (F2R (Float radix2 m (e + -53))) with (F2R (Float radix2 m e) * u).
  - apply Qle_Rle in H4, H5. rewrite rational_value in H4, H5. generalize u_pos. intro.
    split; apply Rmult_le_compat_r; lra.
  - unfold F2R, u. cbn [Fnum Fexp]. rewrite bpow_plus. ring.
Qed.

Lemma error_below : forall e most : Q, Qle_bool e (most * unit) && Qle_bool 0 e = true ->
  0 <= Q2R e <= Q2R most * u.
Proof.
  intros e most H. rewrite andb_true_iff, !Qle_bool_iff in H. destruct H as [H1 H2]. apply Qle_Rle in H1, H2.
  rewrite Q2R_mult, unit_u in H1. replace (Q2R 0) with 0 in H2 by (unfold Q2R; cbn; lra). lra.
Qed.
Lemma constant_on_reals : forall k w x,
  ((Z.abs (fst k) <? 2 ^ 53)%Z && (-900 <=? snd k)%Z && (snd k <=? 900)%Z && (snd kUnitRoundoff =? -53)%Z = true) ->
  on_reals rnd w (in_roundoffs k) = val (on_doubles x (in_roundoffs k)).
Proof.
  intros [m e] w x H. unfold in_roundoffs. cbn [fst snd] in *.
  rewrite !andb_true_iff, Z.ltb_lt, !Z.leb_le, Z.eqb_eq in H. destruct H as [[[H1 H2] H3] H4]. rewrite H4.
  assert (L := mantissa_bits m H1).
  destruct (normal_constant m (e + -53) (Z.log2 (Z.abs m) + 1 + (e + -53)) H1 ltac:(lia) ltac:(lia) eq_refl) as [_ W].
  symmetry. exact W.
Qed.

Lemma known_is_direction : forall e y x, known_on_doubles e y x -> is_direction x.
Proof. intros e y x [F K]. split; [intros k Hk; apply F; lia | apply K]. Qed.

(* The root of a square that vectors i and j are seen by. *)
Lemma size_back : forall pairs y i j, square_in_range (fun n => on_doubles y (inputs pairs n)) (seen_square (S i) (S j))
  -> let G := seen_size (value_of_vector (exact_inputs pairs y) (S i)) (value_of_vector (exact_inputs pairs y) (S j)) in
  let r := on_doubles y (Root (size_square pairs (S i) (S j))) in
  finite r /\ 0 <= val r <= bpow radix2 88 /\ G * (1 - 4.01 * u) <= val r.
Proof.
  intros pairs y i j R G r. destruct (seen_back pairs y i j R) as [F [_ [_ [HG [_ [L [B P]]]]]]]. fold G in HG, L, B.
  unfold r, size_square. cbn [on_doubles]. rewrite on_doubles_replace.
  destruct (root_forward _ F P) as [Fr Er]. split; [exact Fr|]. rewrite Er. split; [|exact L]. split.
  - assert (0 <= G * (1 - 4.01 * u)) by (apply Rmult_le_pos; rewrite ?u_val; lra). lra.
  - rewrite <- (Rabs_pos_eq (rnd _)).
    + apply rnd_power; [lia|]. rewrite Rabs_pos_eq by apply sqrt_pos.
      apply Rle_trans with (sqrt (bpow radix2 88 * bpow radix2 88)); [|rewrite sqrt_square by apply bpow_ge_0; lra].
      apply sqrt_le_1_alt. eapply Rle_trans; [exact B|].
      assert (G <= bpow radix2 88 * / 2).
      { assert (10 ^ 26 <= bpow radix2 88 * / 2); [|lra]. change (bpow radix2 88) with (IZR (2 ^ 88)).
        apply Rmult_le_reg_r with 2; [lra|]. rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra.
        rewrite pow_IZR, <- mult_IZR. apply IZR_le. vm_compute. discriminate. }
      assert (GG : G * G <= bpow radix2 88 * / 2 * (bpow radix2 88 * / 2)) by (apply Rmult_le_compat; lra).
      assert (0 <= bpow radix2 88 * bpow radix2 88) by (apply Rmult_le_pos; apply bpow_ge_0).
      apply Rle_trans with (G * G * 2); [apply Rmult_le_compat_l; [nra | rewrite u_val; lra]|]. lra.
    + assert (0 <= G * (1 - 4.01 * u)) by (apply Rmult_le_pos; rewrite ?u_val; lra). lra.
Qed.

(* Value and bound are finite, and the comparison is that of their values. *)
Lemma decided_on_doubles : forall y value bound s, finite (on_doubles y value) -> finite (on_doubles y bound) ->
  run y (decided value bound) = Some s ->
  (s = Positive /\ val (on_doubles y bound) < val (on_doubles y value)) \/
  (s = Negative /\ val (on_doubles y value) < - val (on_doubles y bound)).
Proof.
  intros y value bound s FV FB H. unfold decided in H. cbn [run on_doubles] in H.
  rewrite !compare_finite in H by (try assumption; unfold finite; rewrite is_finite_Bopp; exact FB).
  cbn [compare_reals] in H. replace (val (Bopp (on_doubles y bound))) with (- val (on_doubles y bound)) in H
    by (symmetry; apply B2R_Bopp).
  destruct (Rlt_bool_spec (val (on_doubles y bound)) (val (on_doubles y value))) as [L|L]; [left; split; congruence|].
  destruct (Rlt_bool_spec (val (on_doubles y value)) (- val (on_doubles y bound))) as [L'|L']; [|discriminate].
  right. split; congruence.
Qed.

Theorem approach_right : forall e y x s, known_on_doubles e y x -> run x Code.Approach.sign = Some s ->
  is_sign s (dot y (vadd (vsub (point x 2) (point x 0)) (vsub (point x 2) (point x 1)))).
Proof.
  intros e y x s K H. rewrite approach_match in H. cbn [run] in H.
  destruct (compare_doubles Less _ _); [|discriminate].
  destruct (compare_doubles LessEqual (on_doubles x low_square) _) eqn:HL; [|discriminate].
  destruct (compare_doubles LessEqual _ (on_doubles x high_square)) eqn:HH; [|discriminate].
  set (z n := on_doubles x (inputs seen_from_edge n)).
  assert (R : square_in_range z (seen_square 1 2)).
  { unfold size_square in HL, HH. rewrite on_doubles_replace in HL, HH. split; assumption. }
  destruct (seen_back seen_from_edge x 0 1 R) as [_ [B1 [B2 [HG _]]]].
  destruct (size_back seen_from_edge x 0 1 R) as [Fr [Hr Lr]].
  set (G := seen_size (value_of_vector (exact_inputs seen_from_edge x) 1) (value_of_vector (exact_inputs
    seen_from_edge x) 2)) in *.
  destruct K as [Fx K].
  destruct (height (top_of_inputs 3) (flatten approach)) as [top|] eqn:Top; [|vm_compute in Top; discriminate].
  destruct (value_of_inputs 3 approach top seen_from_edge x) as [FV [_ Error]]; [vm_compute; reflexivity | exact Top |
    apply (known_is_direction e y); split; assumption | |].
  { intros k Hk. destruct k as [|[|[|k]]]; [lia | exists G; split; [exact B1 | lra] | exists G; split; [exact B2 | lra]
    |
      lia]. }
  destruct (header_constant kExitBound approach_needs 1000 eq_refl x) as [Fc Hc].
  replace (Q2R approach_needs) with 19.17 in Hc by (unfold Q2R; cbn; lra).
  replace (Q2R 1000) with 1000 in Hc by (unfold Q2R; cbn; lra).
  (* the bound is finite *)
  set (t := error_of x). assert (Ht : 0 <= t <= 3 / 32) by exact (error_not_negative _ _ _ _ K).
  set (w n := match n with 0%nat => x 21%nat | _ => on_doubles x (Root (size_square seen_from_edge 1 2)) end).
  destruct (forward w (fun n => match n with 0%nat => 0 | 1%nat => 88 | _ => 5000 end)%Z
    (Mul (Add (Var 0) (in_roundoffs kExitBound)) (Var 1)) 89) as [FB [EB _]].
  { intros [|[|n]] Hn; [| | discriminate Hn]; cbn [w].
    - split; [apply Fx; lia|]. change (val (x 21%nat)) with t. change (bpow radix2 0) with 1. rewrite Rabs_pos_eq; lra.
    - split; [exact Fr|]. rewrite Rabs_pos_eq; apply Hr. }
  { vm_compute. reflexivity. }
  change (on_doubles w (Mul (Add (Var 0) (in_roundoffs kExitBound)) (Var 1))) with (on_doubles x approach_bound) in *.
  rewrite <- on_doubles_replace in FV, Error.
  destruct (form_of_known e y _ _ K) as [scale [Ps Form]].
  set (d k := value_of_vector (exact_inputs seen_from_edge x) k) in *.
  assert (Exact : exact (exact_inputs seen_from_edge x) (flatten approach) = dot (direction_of x) (vadd (d 1%nat) (d
    2%nat))).
  { unfold exact, d, direction_of, value_of_vector, dot, vadd. reflexivity. }
  rewrite Exact in Error. specialize (Form (vadd (d 1%nat) (d 2%nat))). fold t in Form.
  assert (Sum := sum_below_seen_size (d 1%nat) (d 2%nat)). fold G in Sum.
  assert (Long : len (vadd (d 1%nat) (d 2%nat)) <= G) by (eapply Rle_trans; [apply len_triangle | exact Sum]).
  generalize u_pos u_val. intros U0 Hu.
  assert (Form' : Rabs (dot (direction_of x) (vadd (d 1%nat) (d 2%nat)) - scale * dot y (vadd (d 1%nat) (d 2%nat)))
    <= (t + 12 * u) * (1 + 16 * u) * G).
  { eapply Rle_trans; [exact Form|]. apply Rmult_le_compat_l; [apply Rmult_le_pos; lra | exact Long]. }
  assert (Error' : Q2R (error error_of_input approach) * size (size_of_input seen_from_edge x) approach <= 5.0002 * u *
    G).
  { cbn [size approach]. unfold size_of_input. cbn [Nat.eqb].
    fold (d 1%nat) (d 2%nat). destruct (error_below (error error_of_input approach) (50001001 # 10000000)) as [Q0 Q];
      [vm_compute; reflexivity|]. replace (Q2R (50001001 # 10000000)) with 5.0001001 in Q by (unfold Q2R; cbn; lra).
    apply Rle_trans with (5.0001001 * u * ((1 + 16 * u) * (G * (1 + u)))).
    - generalize (len_nonneg (d 1%nat)) (len_nonneg (d 2%nat)). intros L1 L2.
      assert (0 <= 1 + 16 * u) by lra.
      apply Rmult_le_compat; [exact Q0 | | exact Q |].
      + apply Rmult_le_pos; [lra|]. assert (0 < / 10 ^ 43) by (apply Rinv_0_lt_compat, pow_lt; lra). lra.
      + apply Rmult_le_compat_l; [lra|]. rewrite Hu in *. lra.
    - rewrite Hu in *. lra. }
  assert (EB' : val (on_doubles x approach_bound) = rnd (rnd (t + val (on_doubles x (in_roundoffs kExitBound))) * val
    (on_doubles x (Root (size_square seen_from_edge 1 2))))).
  { rewrite EB. unfold rounded. cbn [on_reals w]. rewrite (constant_on_reals kExitBound _ x) by reflexivity.
    reflexivity. }
  assert (Cover := approach_covers t _ G _ Ht Hc (fmt_val _) (fmt_val _) (proj1 HG) Lr).
  rewrite <- EB' in Cover.
  assert (Final : Rabs (val (on_doubles x (replace (inputs seen_from_edge) (flatten approach))) - dot (direction_of x)
    (vadd (d 1%nat) (d 2%nat))) <= 5.0002 * u * G) by (eapply Rle_trans; [exact Error | exact Error']).
  destruct (sign_of_certain _ (val (on_doubles x approach_bound)) _ scale (dot y (vadd (d 1%nat) (d 2%nat))) _ Final)
    as [Up Down]; [lra | exact Ps|].
  destruct (decided_on_doubles _ _ _ _ FV FB H) as [[-> Q]|[-> Q]]; cbn [is_sign]; [exact (Up Q) | exact (Down Q)].
Qed.

(* ---- AlongEdge ---- *)

Definition seen_from_corner := [(2, 3); (2, 4)]%nat.
Definition normal := Dot (Given 0) (Cross (Given 1) (Given 2)).
Definition corner_square k := replace (inputs seen_from_corner) (square k).
Definition normal_bound :=
  Mul (Mul (Add error_variable (in_roundoffs kNormalBound)) (Root (corner_square 1))) (Root (corner_square 2)).
Definition normal_needs : Q := 2206 # 100.

Lemma normal_match : Code.Normal.sign =
  If Less error_variable one
    (If LessEqual low_square (corner_square 1) (If LessEqual (corner_square 1) high_square
      (If LessEqual low_square (corner_square 2) (If LessEqual (corner_square 2) high_square
        (decided (replace (inputs seen_from_corner) (flatten normal)) normal_bound) (Answer None)) (Answer None))
      (Answer None)) (Answer None)) (Answer None).
Proof. vm_compute. reflexivity. Qed.

Lemma normal_covers : forall t c L M R S, 0 <= t <= 3 / 32 -> 22.06 * u <= c <= 1000 * u -> fmt t -> fmt c ->
  / 10 ^ 26 <= L -> / 10 ^ 26 <= M -> L * (1 - 3.51 * u) <= R -> M * (1 - 3.51 * u) <= S ->
  (t + 12 * u) * (1 + 16 * u) * (L * M) + 7.4146 * u * (L * M) <= rnd (rnd (rnd (t + c) * R) * S).
Proof.
  intros t c L M R S Ht Hc Ft Fc HL HM HR HS. generalize u_pos u_val. intros U0 Hu.
  assert (P := rnd_plus t c Ft Fc). rewrite (Rabs_pos_eq (t + c)) in P by lra. apply Rabs_le_inv in P.
  assert (LM : / 10 ^ 52 <= L * M).
  { replace (/ 10 ^ 52) with (/ 10 ^ 26 * / 10 ^ 26) by (rewrite <- Rinv_mult, <- pow_add; reflexivity).
    apply Rmult_le_compat; auto; left; apply Rinv_0_lt_compat, pow_lt; lra. }
  set (N := L * M) in *. assert (N0 : 0 < N).
  { eapply Rlt_le_trans; [|exact LM]. apply Rinv_0_lt_compat, pow_lt. lra. }
  assert (L0 : 0 < L) by (eapply Rlt_le_trans; [|exact HL]; apply Rinv_0_lt_compat, pow_lt; lra).
  assert (M0 : 0 < M) by (eapply Rlt_le_trans; [|exact HM]; apply Rinv_0_lt_compat, pow_lt; lra).
  assert (T : 0 <= t * N <= 3 / 32 * N) by (split; [apply Rmult_le_pos; lra | apply Rmult_le_compat_r; lra]).
  assert (C : 22.06 * u * N <= c * N <= 1000 * u * N) by (split; apply Rmult_le_compat_r; lra).
  assert (V : 0 < 1 - 3.51 * u) by (rewrite Hu; lra).
  set (Z := (t + c) * (1 - u) * (L * (1 - 3.51 * u))).
  assert (P0 : 22 * u <= (t + c) * (1 - u)) by (rewrite Hu in *; lra).
  assert (HZ : Z <= rnd (t + c) * R).
  { apply Rmult_le_compat; [lra | apply Rmult_le_pos; lra | lra | exact HR]. }
  assert (Low : 21 * u * L <= Z).
  { unfold Z. apply Rle_trans with (22 * u * (L * (1 - 3.51 * u))); [|apply Rmult_le_compat_r; [apply Rmult_le_pos;
      lra | exact P0]]. rewrite Hu. lra. }
  assert (Tau : forall z w, / 10 ^ 60 <= z -> 20 * u * z <= w -> tau <= w).
  { intros z w H1 H2. eapply Rle_trans; [apply (tau_below z); eapply Rle_trans; [|exact H1]; apply Rinv_le; [apply
      pow_lt; lra | apply Rle_pow; [lra | lia]]|]. eapply Rle_trans; [|exact H2]. rewrite Hu. lra. }
  assert (Deep : forall k w, (k <= 60)%nat -> / 10 ^ k <= w -> / 10 ^ 60 <= w).
  { intros k w H1 H2. eapply Rle_trans; [|exact H2]. apply Rinv_le; [apply pow_lt; lra | apply Rle_pow; [lra | lia]]. }
  assert (uL : 0 < u * L) by (apply Rmult_lt_0_compat; lra).
  assert (Q := rnd_lower _ Z (Tau L Z (Deep 26%nat L ltac:(lia) HL) ltac:(lra)) HZ).
  set (Y := Z * (1 - 2 * u) * (M * (1 - 3.51 * u))).
  assert (Z0 : 0 < Z) by (eapply Rlt_le_trans; [|exact Low]; lra).
  assert (HY : Y <= rnd (rnd (t + c) * R) * S).
  { apply Rmult_le_compat; [apply Rmult_le_pos; rewrite ?Hu; lra | apply Rmult_le_pos; lra | lra | exact HS]. }
  assert (EY : Y = (t * N + c * N) * ((1 - u) * (1 - 2 * u) * ((1 - 3.51 * u) * (1 - 3.51 * u))))
    by (unfold Y, Z, N; ring).
  assert (LowY : 20 * u * N <= Y) by (rewrite EY; rewrite Hu in *; lra).
  eapply Rle_trans; [|exact (rnd_lower _ Y (Tau N Y (Deep 52%nat N ltac:(lia) LM) LowY) HY)].
  rewrite EY. replace ((t + 12 * u) * (1 + 16 * u) * N) with ((t * N + 12 * u * N) * (1 + 16 * u)) by ring.
  rewrite Hu in *. lra.
Qed.

Lemma root_of_corner : forall x k, 0 < val (on_doubles (fun n => on_doubles x (inputs seen_from_corner n)) (square (S
  k))) <= bpow radix2 176 -> finite (on_doubles (fun n => on_doubles x (inputs seen_from_corner n)) (square (S k))) ->
  let r := on_doubles x (Root (corner_square (S k))) in finite r /\ Rabs (val r) <= bpow radix2 88 /\
  val r = rnd (sqrt (val (on_doubles (fun n => on_doubles x (inputs seen_from_corner n)) (square (S k))))).
Proof.
  intros x k [P B] F r. unfold r, corner_square. cbn [on_doubles]. rewrite on_doubles_replace.
  destruct (root_forward _ F P) as [Fr Er]. split; [exact Fr|]. rewrite Er. split; [|reflexivity].
  apply rnd_power; [lia|]. rewrite Rabs_pos_eq by apply sqrt_pos.
  apply Rle_trans with (sqrt (bpow radix2 88 * bpow radix2 88)); [|rewrite sqrt_square by apply bpow_ge_0; lra].
  apply sqrt_le_1_alt. rewrite <- bpow_plus. exact B.
Qed.

Theorem normal_right : forall e y x s, known_on_doubles e y x -> run x Code.Normal.sign = Some s ->
  is_sign s (dot y (cross (vsub (point x 3) (point x 2)) (vsub (point x 4) (point x 2)))).
Proof.
  intros e y x s K H. rewrite normal_match in H. cbn [run] in H.
  destruct (compare_doubles Less _ _); [|discriminate].
  destruct (compare_doubles LessEqual (on_doubles x low_square) (on_doubles x (corner_square 1))) eqn:HL;
    [|discriminate].
  destruct (compare_doubles LessEqual (on_doubles x (corner_square 1)) _) eqn:HH; [|discriminate].
  destruct (compare_doubles LessEqual (on_doubles x low_square) (on_doubles x (corner_square 2))) eqn:HL2;
    [|discriminate].
  destruct (compare_doubles LessEqual (on_doubles x (corner_square 2)) _) eqn:HH2; [|discriminate].
  set (z n := on_doubles x (inputs seen_from_corner n)).
  assert (R1 : square_in_range z (square 1)).
  { unfold corner_square in HL, HH. rewrite on_doubles_replace in HL, HH. split; assumption. }
  assert (R2 : square_in_range z (square 2)).
  { unfold corner_square in HL2, HH2. rewrite on_doubles_replace in HL2, HH2. split; assumption. }
  destruct (length_back seen_from_corner x 0 R1) as [F1 [B1 [H1 [L1 P1]]]].
  destruct (length_back seen_from_corner x 1 R2) as [F2 [B2 [H2 [L2 P2]]]].
  destruct (root_of_corner x 0 P1 F1) as [Fr1 [Br1 Er1]]. destruct (root_of_corner x 1 P2 F2) as [Fr2 [Br2 Er2]].
  rewrite <- Er1 in L1. rewrite <- Er2 in L2.
  set (d k := value_of_vector (exact_inputs seen_from_corner x) k) in *.
  change (value_of_vector (exact_inputs seen_from_corner x) 1) with (d 1%nat) in *.
  change (value_of_vector (exact_inputs seen_from_corner x) 2) with (d 2%nat) in *.
  destruct K as [Fx K].
  destruct (height (top_of_inputs 3) (flatten normal)) as [top|] eqn:Top; [|vm_compute in Top; discriminate].
  destruct (value_of_inputs 3 normal top seen_from_corner x) as [FV [_ Error]]; [vm_compute; reflexivity | exact Top |
    apply (known_is_direction e y); split; assumption | |].
  { intros k Hk. destruct k as [|[|[|k]]]; [lia | eexists; split; [exact B1 | lra] | eexists; split; [exact B2 | lra] |
      lia]. }
  rewrite <- on_doubles_replace in FV, Error.
  destruct (header_constant kNormalBound normal_needs 1000 eq_refl x) as [Fc Hc].
  replace (Q2R normal_needs) with 22.06 in Hc by (unfold Q2R; cbn; lra).
  replace (Q2R 1000) with 1000 in Hc by (unfold Q2R; cbn; lra).
  set (t := error_of x). assert (Ht : 0 <= t <= 3 / 32) by exact (error_not_negative _ _ _ _ K).
  set (w n := match n with 0%nat => x 21%nat | 1%nat => on_doubles x (Root (corner_square 1))
                         | _ => on_doubles x (Root (corner_square 2)) end).
  destruct (forward w (fun n => match n with 0%nat => 0 | 1%nat | 2%nat => 88 | _ => 5000 end)%Z
    (Mul (Mul (Add (Var 0) (in_roundoffs kNormalBound)) (Var 1)) (Var 2)) 177) as [FB [EB _]].
  { intros [|[|[|n]]] Hn; [| | | discriminate Hn]; cbn [w].
    - split; [apply Fx; lia|]. change (val (x 21%nat)) with t. change (bpow radix2 0) with 1. rewrite Rabs_pos_eq; lra.
    - split; [exact Fr1 | exact Br1].
    - split; [exact Fr2 | exact Br2]. }
  { vm_compute. reflexivity. }
  change (on_doubles w (Mul (Mul (Add (Var 0) (in_roundoffs kNormalBound)) (Var 1)) (Var 2)))
    with (on_doubles x normal_bound) in *.
  destruct (form_of_known e y _ _ K) as [scale [Ps Form]].
  assert (Exact : exact (exact_inputs seen_from_corner x) (flatten normal) = dot (direction_of x) (cross (d 1%nat) (d
    2%nat))).
  { unfold exact, d, direction_of, value_of_vector, dot, cross. reflexivity. }
  rewrite Exact in Error. specialize (Form (cross (d 1%nat) (d 2%nat))). fold t in Form.
  set (N := len (d 1%nat) * len (d 2%nat)). assert (Long := cross_len (d 1%nat) (d 2%nat)). fold N in Long.
  generalize u_pos u_val. intros U0 Hu.
  assert (Form' : Rabs (dot (direction_of x) (cross (d 1%nat) (d 2%nat)) - scale * dot y (cross (d 1%nat) (d 2%nat)))
    <= (t + 12 * u) * (1 + 16 * u) * N).
  { eapply Rle_trans; [exact Form|]. apply Rmult_le_compat_l; [apply Rmult_le_pos; lra | exact Long]. }
  assert (P43 : 0 < / 10 ^ 43) by (apply Rinv_0_lt_compat, pow_lt; lra).
  assert (Error' : Q2R (error error_of_input normal) * size (size_of_input seen_from_corner x) normal <= 7.4146 * u *
    N).
  { cbn [size normal]. unfold size_of_input. cbn [Nat.eqb].
    fold (d 1%nat) (d 2%nat). destruct (error_below (error error_of_input normal) (74145 # 10000)) as [Q0 Q];
      [vm_compute; reflexivity|]. replace (Q2R (74145 # 10000)) with 7.4145 in Q by (unfold Q2R; cbn; lra).
    assert (N0 : 0 <= N) by (apply Rmult_le_pos; apply len_nonneg).
    apply Rle_trans with (7.4145 * u * ((1 + 16 * u) * (N * ((1 + u) * (1 + u))))).
    - assert (0 <= 1 + 16 * u) by lra. generalize (len_nonneg (d 1%nat)) (len_nonneg (d 2%nat)). intros.
      apply Rmult_le_compat; [exact Q0 | | exact Q |].
      + apply Rmult_le_pos; [lra|]. apply Rmult_le_pos; lra.
      + apply Rmult_le_compat_l; [lra|]. unfold N.
        replace (len (d 1%nat) * len (d 2%nat) * ((1 + u) * (1 + u)))
          with ((len (d 1%nat) * (1 + u)) * (len (d 2%nat) * (1 + u))) by ring.
        apply Rmult_le_compat; rewrite Hu in *; lra.
    - rewrite Hu in *. lra. }
  assert (EB' : val (on_doubles x normal_bound) = rnd (rnd (rnd (t + val (on_doubles x (in_roundoffs kNormalBound))) *
    val (on_doubles x (Root (corner_square 1)))) * val (on_doubles x (Root (corner_square 2))))).
  { rewrite EB. unfold rounded. cbn [on_reals w]. rewrite (constant_on_reals kNormalBound _ x) by reflexivity.
    reflexivity. }
  assert (Cover := normal_covers t _ _ _ _ _ Ht Hc (fmt_val _) (fmt_val _) (proj1 H1) (proj1 H2) L1 L2). fold N in
    Cover.
  rewrite <- EB' in Cover.
  assert (Final : Rabs (val (on_doubles x (replace (inputs seen_from_corner) (flatten normal))) - dot (direction_of x)
    (cross (d 1%nat) (d 2%nat))) <= 7.4146 * u * N) by (eapply Rle_trans; [exact Error | exact Error']).
  destruct (sign_of_certain _ (val (on_doubles x normal_bound)) _ scale (dot y (cross (d 1%nat) (d 2%nat))) _ Final)
    as [Up Down]; [lra | exact Ps|].
  destruct (decided_on_doubles _ _ _ _ FV FB H) as [[-> Q]|[-> Q]]; cbn [is_sign]; [exact (Up Q) | exact (Down Q)].
Qed.
