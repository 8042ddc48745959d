(* direction_of_vector() of src/flow/kernels/direction.h on doubles, with infinities and NaN: where it says that a
   direction is known, it is known, if the vector is within the bound that it was given. *)
From Coq Require Import Reals ZArith QArith Qreals Lra Lia Psatz Bool List.
From Flocq Require Import Core BinarySingleNaN.
From Flowcert Require Import algebra.Vector3 code.Expression code.generated.Constants filters.Rounding
  filters.RoundedVectors filters.Norms filters.Floors filters.Doubles filters.Terms filters.Filter filters.Directions
  filters.DirectionSigns filters.DirectionVectors.
From Flowcert Require filters.Cells.
Open Scope R_scope.

Notation not_negative := Cells.not_negative.

(* ---- Single operations that do not overflow ---- *)

Lemma no_overflow_below : forall z, Rabs z <= bpow radix2 1000 -> Rlt_bool (Rabs (rnd z)) (bpow radix2 1024) = true.
Proof. intros z H. apply Rlt_bool_true. apply (no_overflow z 1000); [lia | exact H]. Qed.
Lemma mul_forward : forall a b : double, finite a -> finite b -> Rabs (val a * val b) <= bpow radix2 1000 ->
  finite (Bmult mode_NE a b) /\ val (Bmult mode_NE a b) = rnd (val a * val b).
Proof.
  intros a b Fa Fb H. generalize (Bmult_correct 53 1024 _ _ mode_NE a b).
  change (round radix2 (SpecFloat.fexp 53 1024) (round_mode mode_NE)) with rnd. unfold val in *.
  rewrite no_overflow_below by exact H. intros [V [F _]]. split; [|exact V]. unfold finite in *. rewrite F, Fa, Fb.
  reflexivity.
Qed.
Lemma sub_forward : forall a b : double, finite a -> finite b -> Rabs (val a - val b) <= bpow radix2 1000 ->
  finite (Bminus mode_NE a b) /\ val (Bminus mode_NE a b) = rnd (val a - val b).
Proof.
  intros a b Fa Fb H. generalize (Bminus_correct 53 1024 _ _ mode_NE a b Fa Fb).
  change (round radix2 (SpecFloat.fexp 53 1024) (round_mode mode_NE)) with rnd. unfold val in *.
  rewrite no_overflow_below by exact H. intros [V [F _]]. split; assumption.
Qed.
Lemma div_forward : forall a b : double, finite a -> finite b -> val b <> 0 -> Rabs (val a / val b) <= bpow radix2 1000
  ->
  finite (Bdiv mode_NE a b) /\ val (Bdiv mode_NE a b) = rnd (val a / val b).
Proof.
  intros a b Fa Fb N H. generalize (Bdiv_correct 53 1024 _ _ mode_NE a b N).
  change (round radix2 (SpecFloat.fexp 53 1024) (round_mode mode_NE)) with rnd. unfold val in *.
  rewrite no_overflow_below by exact H. intros [V [F _]]. split; [|exact V]. unfold finite in *. rewrite F. exact Fa.
Qed.
Lemma div_back : forall a b : double, finite a -> finite (Bdiv mode_NE a b) -> 0 < val (Bdiv mode_NE a b) ->
  finite b /\ val b <> 0 /\ val (Bdiv mode_NE a b) = rnd (val a / val b).
Proof.
  intros a b Fa F P. unfold finite, val in *.
  assert (N : B2R b <> 0).
  { destruct b as [s|s| |s m e H].
    - exfalso. destruct a as [t|t| |t n f G]; discriminate.
    - exfalso. destruct a as [t|t| |t n f G]; try discriminate; cbn in P; lra.
    - exfalso. destruct a as [t|t| |t n f G]; discriminate.
    - cbn. intro Z. apply eq_0_F2R in Z. destruct s; discriminate. }
  split; [destruct b; try reflexivity; cbn in N; lra|]. split; [exact N|].
  generalize (Bdiv_correct 53 1024 _ _ mode_NE a b N). case Rlt_bool.
  - intros [V _]. exact V.
  - intro V. exfalso. destruct (Bdiv mode_NE a b); try discriminate.
Qed.

Lemma one_on_doubles : forall x, finite (on_doubles x one) /\ val (on_doubles x one) = 1.
Proof.
  intro x. destruct (normal_constant 1 0 1 ltac:(lia) ltac:(lia) ltac:(lia) eq_refl) as [F V]. split; [exact F|].
  change (val (on_doubles x one)) with (val (binary_normalize 53 1024 eq_refl eq_refl mode_NE 1 0 false)). rewrite V.
  unfold F2R. cbn. lra.
Qed.

(* A product of a bound and a positive number that is below a constant. *)
Lemma product_back : forall zero b i c : double, finite zero -> val zero = 0 -> finite c -> not_negative b ->
  compare_doubles Less zero i = true -> compare_doubles Less (Bmult mode_NE b i) c = true ->
  finite (Bmult mode_NE b i) /\ finite b /\ finite i /\ 0 < val i.
Proof.
  intros zero b i c Fz Ez Fc Nb Hi Hc.
  assert (Ni : not_negative i).
  { right. destruct i as [s|s| |s m e H].
    - exfalso. rewrite compare_finite in Hi by (assumption || reflexivity). cbn [compare_reals] in Hi. revert Hi. case
      Rlt_bool_spec;
        [|discriminate]. intros Hi _. rewrite Ez in Hi. cbn in Hi. lra.
    - destruct s; [|reflexivity]. exfalso. destruct zero as [t|t| |t n f G]; discriminate.
    - exfalso. destruct zero as [t|t| |t n f G]; discriminate.
    - destruct s; [|reflexivity]. exfalso. rewrite compare_finite in Hi by (assumption || reflexivity). cbn
      [compare_reals] in Hi. revert Hi.
      case Rlt_bool_spec; [|discriminate]. intros Hi _. rewrite Ez in Hi. cbn in Hi.
      assert (F2R (Float radix2 (Z.neg m) e) <= 0) by (apply F2R_le_0; cbn; lia). lra. }
  assert (F : finite (Bmult mode_NE b i)).
  { destruct (Cells.mul_not_negative b i Nb Ni) as [N|S].
    - exfalso. destruct (Bmult mode_NE b i); discriminate.
    - destruct (Bmult mode_NE b i) as [s|s| |s m e H]; try reflexivity; exfalso.
      + cbn in S. subst s. destruct c as [t|t| |t n f G]; discriminate.
      + discriminate. }
  destruct (mul_back _ _ F) as [Fb [Fi _]]. split; [exact F|]. split; [exact Fb|]. split; [exact Fi|].
  rewrite compare_finite in Hi by (assumption || reflexivity). cbn [compare_reals] in Hi. revert Hi. case
    Rlt_bool_spec; [|discriminate].
  intros Hi _. lra.
Qed.

(* ---- What is generated ---- *)

Definition inverse_length := Div one (Root (square 0)).
Definition along_edge := Div (edot (given 0) (given 1)) (square 1).
Definition sine := Mul (Var 6) inverse_length.
Definition largest_error := Cst (fst kLargestError) (snd kLargestError).
Definition tangent := Mul sine (Add one (Mul (Cst (fst kTangentOfSine) (snd kTangentOfSine)) sine)).
Definition coordinate i := Mul inverse_length (Sub (Var i) (Mul along_edge (Var (3 + i)))).

Lemma of_vector_match : Code.OfVector.u_x = coordinate 0 /\ Code.OfVector.u_y = coordinate 1 /\
  Code.OfVector.u_z = coordinate 2 /\ Code.OfVector.error = tangent /\
  Code.OfVector.is_known =
    If LessEqual low_square (square 1) (If LessEqual (square 1) high_square
      (If Less (Cst 0 0) inverse_length (If Less sine largest_error (Answer (Some Positive)) (Answer None))
      (Answer None)) (Answer None)) (Answer None).
Proof. vm_compute. repeat split. Qed.

(* Largest error at most 1/16, and at least twice the sine in its tangent. *)
Lemma rule_of_starts : Qle_bool (units_of kLargestError) (1 # 16) && Qle_bool 2 (units_of kTangentOfSine) &&
  Qle_bool (units_of kTangentOfSine) 4 = true.
Proof. vm_compute. reflexivity. Qed.

Lemma tangent_covers : forall s c, 19 * u <= s <= / 16 -> 2 <= c <= 4 -> fmt s ->
  let t := rnd (s * rnd (1 + rnd (c * s))) in s * (1 + 2 * s) * (1 - 3.1 * u) <= t <= 3 / 32.
Proof.
  intros s c Hs Hc Fs t. generalize u_pos u_val tau_pos tau_small. intros U0 Hu T0 Tau.
  assert (TT : u * tau <= / 10 ^ 80 * u).
  { replace (/ 10 ^ 80 * u) with (u * / 10 ^ 80) by ring. apply Rmult_le_compat_l; [lra|].
    eapply Rle_trans; [exact Tau|]. apply Rinv_le; [apply pow_lt; lra | apply Rle_pow; [lra | lia]]. }
  assert (s0 : 0 < s) by lra.
  assert (cs : 2 * s <= c * s <= 4 * s) by (split; apply Rmult_le_compat_r; lra).
  assert (R1 := rnd_any (c * s)). rewrite (Rabs_pos_eq (c * s)) in R1 by lra. apply Rabs_le_inv in R1.
  set (z := rnd (c * s)) in *.
  assert (z1 : 2 * s * (1 - u) - u * tau <= z).
  { assert (2 * s * (1 - u) <= c * s * (1 - u)) by (apply Rmult_le_compat_r; rewrite ?Hu; lra). lra. }
  assert (z2 : z <= 4 * s * (1 + u) + u * tau).
  { assert (c * s * (1 + u) <= 4 * s * (1 + u)) by (apply Rmult_le_compat_r; lra). lra. }
  assert (z0 : 0 <= z) by (rewrite Hu in *; lra).
  assert (R2 := rnd_any (1 + z)). rewrite (Rabs_pos_eq (1 + z)) in R2 by lra. apply Rabs_le_inv in R2.
  set (w := rnd (1 + z)) in *.
  assert (w1 : (1 + 2 * s) * (1 - 2.01 * u) <= w) by (rewrite Hu in *; lra).
  assert (w2 : w <= 1.26) by (rewrite Hu in *; lra).
  assert (w0 : 0 < w) by (rewrite Hu in *; lra).
  assert (sw1 : s * ((1 + 2 * s) * (1 - 2.01 * u)) <= s * w) by (apply Rmult_le_compat_l; lra).
  assert (sw2 : s * w <= / 16 * 1.26) by (apply Rmult_le_compat; lra).
  assert (sw0 : 0 < s * w) by (apply Rmult_lt_0_compat; assumption).
  assert (R3 := rnd_any (s * w)). rewrite (Rabs_pos_eq (s * w)) in R3 by lra. apply Rabs_le_inv in R3. fold t in R3.
  split; [|rewrite Hu in *; lra].
  set (m := s * (1 + 2 * s)). assert (m0 : 19 * u <= m).
  { unfold m. apply Rle_trans with (19 * u * 1); [lra|]. apply Rmult_le_compat; lra. }
  replace (s * ((1 + 2 * s) * (1 - 2.01 * u))) with (m * (1 - 2.01 * u)) in sw1 by (unfold m; ring).
  assert (m * (1 - 2.01 * u) * (1 - u) <= s * w * (1 - u)) by (apply Rmult_le_compat_r; [rewrite Hu; lra | exact sw1]).
  assert (u * tau <= / 10 ^ 30 * u * m).
  { eapply Rle_trans; [exact TT|]. rewrite Hu in *. lra. }
  rewrite Hu in *. lra.
Qed.

Definition results := (Code.OfVector.u_x :: Code.OfVector.u_y :: Code.OfVector.u_z :: Code.OfVector.error :: nil)%list.

(* A vector whose computed square is no larger than all doubles. *)
Lemma length_below : forall (s : double) Y, fmt3 Y -> val s = rdot Y Y -> len Y <= 10 ^ 160.
Proof.
  intros s Y F E. generalize u_pos u_val tau_pos tau_small. intros U0 Hu T0 Tau.
  assert (D := rdot_rounding Y Y F F). rewrite <- len_sq, <- E in D. apply Rabs_le_inv in D.
  assert (Top : val s < bpow radix2 1024) by (eapply Rle_lt_trans; [apply Rle_abs | apply (abs_B2R_lt_emax 53 1024)]).
  apply Rnot_lt_le. intro N. assert (N2 : 10 ^ 160 * 10 ^ 160 <= len Y * len Y).
  { assert (0 <= 10 ^ 160) by (apply pow_le; lra). apply Rmult_le_compat; lra. }
  assert (P : bpow radix2 1024 * 2 <= 10 ^ 160 * 10 ^ 160).
  { change (bpow radix2 1024) with (IZR (2 ^ 1024)). rewrite pow_IZR, <- !mult_IZR. apply IZR_le. apply Z.leb_le.
    vm_compute. reflexivity. }
  assert (T3 : 3.0001 * u * (3 * tau) <= 1).
  { assert (tau <= 1) by (eapply Rle_trans; [exact Tau|]; rewrite <- Rinv_1; apply Rinv_le; [lra | apply pow_R1_Rle;
      lra]). rewrite Hu. lra. }
  assert (2 <= bpow radix2 1024) by (change 2 with (bpow radix2 1); apply bpow_le; lia).
  rewrite Hu in *. lra.
Qed.

(* The coordinates of a vector that is projected and multiplied by a double i, the inverse of its length, or less than
   zero. *)
Lemma shortened_on_doubles : forall e (x : nat -> double) (factor : double) i,
  let Y := value_of_vector (fun n => val (x n)) 0 in let f := value_of_vector (fun n => val (x n)) 1 in
  (forall j, (j < 3)%nat -> finite (x j)) -> (forall j, (j < 3)%nat -> finite (x (3 + j)%nat)) ->
  finite (on_doubles x (square 1)) -> len (vsub f e) <= u * len e -> / 10 ^ 26 <= len e <= 10 ^ 26 ->
  / 10 ^ 140 <= len Y <= 10 ^ 160 -> 1 - 3.6 * u <= i * len Y <= 1 + 3.6 * u ->
  Rabs (dot Y e) <= len Y * len e / 15 -> finite factor -> Rabs (val factor) = i ->
  let part j := Bmult mode_NE factor (on_doubles x (Sub (Var j) (Mul along_edge (Var (3 + j))))) in
  (forall j, (j < 3)%nat -> finite (part j)) /\
  V (val (part 0%nat)) (val (part 1%nat)) (val (part 2%nat)) = shortened (val factor) f Y.
Proof.
  intros e x factor i Y f Fy Ff Fee Near Edge [LowY HighY] Unit Flat Fi Ei part. generalize u_pos u_val. intros U0 Hu.
  assert (Ffmt : fmt3 f) by (repeat split; apply fmt_val). assert (Yfmt : fmt3 Y) by (repeat split; apply fmt_val).
  destruct (square_back x 1 Fee) as [_ Eee]. fold f in Eee.
  assert (Pi : 0 <= i) by (rewrite <- Ei; apply Rabs_pos).
  destruct (factor_of_projection e f Y i Ffmt Yfmt Near Edge LowY Flat Unit) as [_ [_ [ee0 Q]]].
  destruct (shortened_right e f Y i Ffmt Yfmt Near Edge LowY Flat Unit) as [_ [_ Fit]].
  assert (P532 : 10 ^ 160 <= bpow radix2 532) by (change (bpow radix2 532) with (IZR (2 ^ 532)); rewrite pow_IZR; apply
    IZR_le, Z.leb_le; vm_compute; reflexivity).
  assert (P88 : 10 ^ 26 * 2 <= bpow radix2 88) by (change (bpow radix2 88) with (IZR (2 ^ 88)); rewrite pow_IZR, <-
    mult_IZR; apply IZR_le, Z.leb_le; vm_compute; reflexivity).
  assert (P619 : 10 ^ 160 * 10 ^ 26 <= bpow radix2 619) by (change (bpow radix2 619) with (IZR (2 ^ 619)); rewrite
    !pow_IZR, <- mult_IZR; apply IZR_le, Z.leb_le; vm_compute; reflexivity).
  assert (Lf : len f <= bpow radix2 88).
  { eapply Rle_trans; [|exact P88]. eapply Rle_trans; [apply (len_from f e)|]. rewrite Hu in *. lra. }
  assert (CY : forall j, (j < 3)%nat -> Rabs (val (x j)) <= bpow radix2 532).
  { destruct (coordinate_bound Y _ (Rle_trans _ _ _ HighY P532)) as [C0 [C1 C2]].
    intros [|[|[|j]]] Hj; [exact C0 | exact C1 | exact C2 | lia]. }
  assert (Cf : forall j, (j < 3)%nat -> Rabs (val (x (3 + j)%nat)) <= bpow radix2 88).
  { destruct (coordinate_bound f _ Lf) as [C0 [C1 C2]].
    intros [|[|[|j]]] Hj; [exact C0 | exact C1 | exact C2 | lia]. }
  destruct (forward x (fun n => if (n <? 3)%nat then 532 else if (n <? 6)%nat then 88 else 5000)%Z
    (edot (given 0) (given 1)) 622) as [Fd [Ed _]].
  { intros n Hn. destruct (Nat.ltb_spec n 3); [split; [apply Fy | apply CY]; assumption|].
    destruct (Nat.ltb_spec n 6); [|discriminate Hn]. replace n with (3 + (n - 3))%nat by lia.
    split; [apply Ff | apply Cf]; lia. }
  { vm_compute. reflexivity. }
  assert (Ed' : val (on_doubles x (edot (given 0) (given 1))) = rdot Y f) by exact Ed. clear Ed.
  cbv zeta in Eee.
  assert (E0 : 0 < len e) by (assert (0 < / 10 ^ 26) by (apply Rinv_0_lt_compat, pow_lt; lra); lra).
  assert (Big : Rabs (rdot Y f / rdot f f) <= bpow radix2 619).
  { eapply Rle_trans; [exact Q|]. eapply Rle_trans; [|exact P619]. unfold Rdiv. apply Rmult_le_compat; try lra.
    - left. apply Rinv_0_lt_compat, E0.
    - rewrite <- (Rinv_inv (10 ^ 26)). apply Rinv_le; [apply Rinv_0_lt_compat, pow_lt;
        lra | lra]. }
  assert (Wide : bpow radix2 619 <= bpow radix2 1000) by (apply bpow_le; lia).
  destruct (div_forward (on_doubles x (edot (given 0) (given 1))) (on_doubles x (square 1)) Fd Fee) as [Fk Ek].
  { rewrite Eee. lra. }
  { rewrite Ed', Eee. lra. }
  rewrite Ed', Eee in Ek.
  change (Bdiv mode_NE (on_doubles x (edot (given 0) (given 1))) (on_doubles x (square 1))) with (on_doubles x
    along_edge) in Fk, Ek.
  assert (Bk : Rabs (val (on_doubles x along_edge)) <= bpow radix2 619) by (rewrite Ek; apply rnd_power; [lia | exact
    Big]).
  assert (Part : forall j, (j < 3)%nat -> let r := on_doubles x (Sub (Var j) (Mul along_edge (Var (3 + j)))) in finite r
    /\ val r = rnd (val (x j) - rnd (val (on_doubles x along_edge) * val (x (3 + j)%nat)))).
  { intros j Hj r. assert (Cj := Cf j Hj). assert (Yj := CY j Hj).
    assert (M : Rabs (val (on_doubles x along_edge) * val (x (3 + j)%nat)) <= bpow radix2 707).
    { rewrite Rabs_mult. change 707%Z with (619 + 88)%Z. rewrite bpow_plus. apply Rmult_le_compat; auto using Rabs_pos.
      }
    destruct (mul_forward (on_doubles x along_edge) (x (3 + j)%nat) Fk (Ff j Hj)) as [Fm Em].
    { eapply Rle_trans; [exact M | apply bpow_le; lia]. }
    destruct (sub_forward (x j) (Bmult mode_NE (on_doubles x along_edge) (x (3 + j)%nat)) (Fy j Hj) Fm) as [Fr2 Er2].
    { rewrite Em. assert (Rm := rnd_power _ 707 ltac:(lia) M). unfold Rminus. eapply Rle_trans; [apply Rabs_triang|].
      rewrite Rabs_Ropp. apply Rle_trans with (bpow radix2 707 * 2).
      - assert (bpow radix2 532 <= bpow radix2 707) by (apply bpow_le; lia). lra.
      - change 2 with (bpow radix2 1). rewrite <- bpow_plus. apply bpow_le. lia. }
    split; [exact Fr2|]. rewrite Em in Er2. exact Er2. }
  set (parts j := Sub (Var j) (Mul along_edge (Var (3 + j)))) in *.
  assert (Proj : projection f Y = V (val (on_doubles x (parts 0%nat))) (val (on_doubles x (parts 1%nat))) (val
    (on_doubles
    x (parts 2%nat)))).
  { destruct (Part 0%nat ltac:(lia)) as [_ V0]. destruct (Part 1%nat ltac:(lia)) as [_ V1]. destruct (Part 2%nat
      ltac:(lia)) as [_ V2]. change (Sub (Var 0) (Mul along_edge (Var (3 + 0)))) with (parts 0%nat) in V0.
    change (Sub (Var 1) (Mul along_edge (Var (3 + 1)))) with (parts 1%nat) in V1.
    change (Sub (Var 2) (Mul along_edge (Var (3 + 2)))) with (parts 2%nat) in V2.
    rewrite V0, V1, V2, Ek. reflexivity. }
  assert (Coord : forall j, (j < 3)%nat -> finite (part j) /\
    val (part j) = rnd (val factor * val (on_doubles x (parts j)))).
  { intros j Hj. destruct (Part j Hj) as [Fj _].
    apply (mul_forward factor (on_doubles x (parts j)) Fi Fj).
    rewrite Rabs_mult, Ei. apply Rle_trans with 2.
    - apply Rle_trans with (i * len (projection f Y)); [|rewrite Hu in *; lra]. apply Rmult_le_compat_l; [lra|].
      destruct (coordinate_bound _ _ (Rle_refl (len (projection f Y)))) as [C0 [C1 C2]].
      rewrite Proj in C0, C1, C2. cbn [vx vy vz] in C0, C1, C2. rewrite <- Proj in C0, C1, C2.
      destruct j as [|[|[|j]]]; [exact C0 | exact C1 | exact C2 | lia].
    - change 2 with (bpow radix2 1). apply bpow_le. lia. }
  destruct (Coord 0%nat ltac:(lia)) as [Fc0 Ec0]. destruct (Coord 1%nat ltac:(lia)) as [Fc1 Ec1].
  destruct (Coord 2%nat ltac:(lia)) as [Fc2 Ec2].
  split; [intros [|[|[|j]]] Hj; [assumption | assumption | assumption | lia]|].
  rewrite Ec0, Ec1, Ec2. unfold shortened. rewrite Proj. reflexivity.
Qed.

Section OfVector.
Variables (e y : vec) (x : nat -> double).
Let Y := value_of_vector (fun n => val (x n)) 0.
Let f := value_of_vector (fun n => val (x n)) 1.
Let b := val (x 6%nat).

Record good_start : Prop := GoodStart {
  start_in_facet : dot y e = 0;
  edge_is_near : (forall i, (i < 3)%nat -> finite (x (3 + i)%nat)) -> len (vsub f e) <= u * len e;
  bound_is_positive : not_negative (x 6%nat);
  start_is_near : finite (x 6%nat) -> (forall i, (i < 3)%nat -> finite (x i)) ->
    len (vsub Y y) + 8 * u * len Y <= b /\ 20 * u * len Y <= b /\ / 10 ^ 140 <= b }.

Lemma edge_range : square_in_range x (square 1) -> len (vsub f e) <= u * len e ->
  val (on_doubles x (square 1)) = rdot f f -> / 10 ^ 26 <= len e <= 10 ^ 26.
Proof.
  intros R Near E. destruct (square_range_back x _ R) as [_ B]. rewrite E in B. generalize u_pos u_val. intros U0 Hu.
  assert (Ff : fmt3 f) by (repeat split; apply fmt_val).
  assert (Va : vapprox 0 f f) by (destruct Ff as [F1 [F2 F3]]; repeat split; simpl; apply approx_exact; auto).
  destruct (rdot_approx 0 0 _ _ _ _ Va Va) as [_ Er _]. rewrite absdot_self, <- len_sq in Er.
  change (0 + 0 + 3)%nat with 3%nat in Er.
  assert (Er' : Rabs (rdot f f - len f * len f) <= Rounding.E 3 * (len f * len f + 12 * tau)).
  { eapply Rle_trans; [exact Er|]. apply Rmult_le_compat_l; [apply E_nonneg|]. generalize tau_pos. intro. lra. }
  destruct (root_of_square 3 (rdot f f) (len f) ltac:(lia) (len_nonneg f) ltac:(lra) Er') as [_ [G2 [_ G4]]].
  assert (F0 := len_nonneg f). assert (e0 := len_nonneg e).
  assert (L1 : 2 / 10 ^ 26 <= len f).
  { apply Rnot_lt_le. intro N. assert (len f * len f <= 2 / 10 ^ 26 * (2 / 10 ^ 26)) by (apply Rmult_le_compat; lra).
    rewrite Hu in *. lra. }
  assert (L2 : len f <= 10 ^ 26 / 2).
  { apply Rnot_lt_le. intro N. assert (10 ^ 26 / 2 * (10 ^ 26 / 2) <= len f * len f) by (apply Rmult_le_compat; lra).
    rewrite Hu in *. lra. }
  assert (A := len_from f e). assert (B2 := len_from e f). rewrite len_sub_sym in B2. rewrite Hu in *. lra.
Qed.

Theorem of_vector_right : good_start -> run x Code.OfVector.is_known = Some Positive ->
  (forall z, List.In z results -> finite (on_doubles x z)) /\
  known e y (V (val (on_doubles x Code.OfVector.u_x)) (val (on_doubles x Code.OfVector.u_y))
    (val (on_doubles x Code.OfVector.u_z))) (val (on_doubles x Code.OfVector.error)).
Proof.
  intros [Ye NearIf Positive_bound Start] H. destruct of_vector_match as [Mx [My [Mz [Me Mk]]]]. rewrite Mk in H.
  unfold results. rewrite Mx, My, Mz, Me. clear Mx My Mz Me Mk. cbn [run] in H.
  destruct (compare_doubles LessEqual (on_doubles x low_square) _) eqn:HL; [|discriminate].
  destruct (compare_doubles LessEqual (on_doubles x (square 1)) _) eqn:HH; [|discriminate].
  destruct (compare_doubles Less (on_doubles x (Cst 0 0)) _) eqn:HI; [|discriminate].
  destruct (compare_doubles Less (on_doubles x sine) _) eqn:HS; [|discriminate]. clear H.
  generalize u_pos u_val tau_pos tau_small. intros U0 Hu T0 Tau.
  (* the edge *)
  assert (R : square_in_range x (square 1)) by (split; assumption). clear HL HH.
  destruct (square_range_back x _ R) as [Fee Ree]. destruct (square_back x 1 Fee) as [Ff Eee]. fold f in Eee.
  assert (Near := NearIf Ff). assert (Edge := edge_range R Near Eee).
  assert (Ffmt : fmt3 f) by (repeat split; apply fmt_val). assert (Yfmt : fmt3 Y) by (repeat split; apply fmt_val).
  (* the sine *)
  assert (A := rule_of_starts). rewrite !andb_true_iff, !Qle_bool_iff in A. destruct A as [[A1 A2] A3].
  apply Qle_Rle in A1, A2, A3. unfold units_of in A1, A2, A3. rewrite rational_value in A1, A2, A3.
  replace (Q2R (1 # 16)) with (/ 16) in A1 by (unfold Q2R; cbn; lra). replace (Q2R 2) with 2 in A2 by (unfold Q2R; cbn;
    lra). replace (Q2R 4) with 4 in A3 by (unfold Q2R; cbn; lra).
  destruct (forward x (fun _ => 5000%Z) largest_error (Z.log2 (Z.abs (fst kLargestError)) + 1 + snd kLargestError))
    as [Fl [El _]]; [intros n Hn; discriminate Hn | vm_compute; reflexivity|].
  assert (Hl : val (on_doubles x largest_error) <= / 16) by (rewrite El; exact A1).
  destruct (product_back (on_doubles x (Cst 0 0)) (x 6%nat) (on_doubles x inverse_length) (on_doubles x largest_error)
    eq_refl eq_refl Fl Positive_bound HI HS) as [Fs [Fb [Fi Pi]]].
  change (Bmult mode_NE (x 6%nat) (on_doubles x inverse_length)) with (on_doubles x sine) in *.
  assert (Es : val (on_doubles x sine) = rnd (b * val (on_doubles x inverse_length)))
    by apply (mul_back (x 6%nat) (on_doubles x inverse_length) Fs).
  rewrite compare_finite in HS by assumption. cbn [compare_reals] in HS. revert HS. case Rlt_bool_spec; [|discriminate].
  intros HS _.
  (* the length *)
  destruct (one_on_doubles x) as [F1 E1].
  destruct (div_back (on_doubles x one) (on_doubles x (Root (square 0))) F1 Fi Pi) as [Fr [Nr Er0]].
  assert (Er : val (on_doubles x inverse_length) = rnd (1 / val (on_doubles x (Root (square 0)))))
    by (rewrite <- E1; exact Er0). clear Er0.
  destruct (root_back (on_doubles x (square 0)) Fr) as [Fy2 Er2].
  destruct (square_back x 0 Fy2) as [Fy Ey2]. fold Y in Ey2. cbn [Nat.mul Nat.add] in Fy.
  assert (Er3 : val (on_doubles x (Root (square 0))) = rlength Y)
    by (unfold rlength; rewrite <- Ey2; exact Er2). clear Er2.
  rewrite Er3 in Er, Nr.
  destruct (Start Fb Fy) as [B1 [B2 B3]].
  set (i := val (on_doubles x inverse_length)) in *. set (s := val (on_doubles x sine)) in *.
  assert (P140 : 0 < / 10 ^ 140) by (apply Rinv_0_lt_compat, pow_lt; lra).
  assert (bi0 : 0 < b * i) by (apply Rmult_lt_0_compat; lra).
  assert (Rs := rnd_any (b * i)). rewrite <- Es, (Rabs_pos_eq (b * i)) in Rs by lra. apply Rabs_le_inv in Rs.
  assert (S0 : 0 < rlength Y).
  { assert (0 <= rlength Y); [|lra]. unfold rlength, rnd. apply round_ge_generic; auto with typeclass_instances;
    [apply generic_format_0 | apply sqrt_pos]. }
  assert (LowS : / 10 ^ 139 <= rlength Y).
  { assert (Ri := rnd_any (1 / rlength Y)). rewrite <- Er, (Rabs_pos_eq (1 / rlength Y)) in Ri
      by (apply Rlt_le, Rdiv_lt_0_compat; lra). apply Rabs_le_inv in Ri.
    assert (bi : b * i <= 0.07) by (rewrite Hu in *; lra).
    assert (ib : i <= 0.07 * 10 ^ 140).
    { apply Rmult_le_reg_l with b; [lra|]. eapply Rle_trans; [exact bi|].
      replace 0.07 with (/ 10 ^ 140 * (0.07 * 10 ^ 140)) at 1 by (field; apply pow_nonzero; lra).
      apply Rmult_le_compat_r; [|exact B3]. apply Rmult_le_pos; [lra | apply pow_le; lra]. }
    assert (one140 : 1 <= 10 ^ 140) by (apply pow_R1_Rle; lra).
    assert (si : 1 / rlength Y <= 0.08 * 10 ^ 140).
    { apply Rmult_le_reg_r with (1 - u); [rewrite Hu; lra|]. rewrite Hu in *. lra. }
    assert (S1 : 1 <= 0.08 * 10 ^ 140 * rlength Y).
    { replace 1 with (1 / rlength Y * rlength Y) at 1 by (field; lra). apply Rmult_le_compat_r; lra. }
    apply Rmult_le_reg_l with (0.08 * 10 ^ 140); [lra|]. eapply Rle_trans; [|exact S1].
    change 140%nat with (139 + 1)%nat. rewrite pow_add. simpl (10 ^ 1).
    assert (I : 10 ^ 139 * / 10 ^ 139 = 1) by (apply Rinv_r, pow_nonzero; lra). revert I.
    generalize (10 ^ 139) (/ 10 ^ 139). intros j k I. apply Rle_trans with (0.8 * (j * k)); [lra | rewrite I; lra]. }
  assert (HighY : len Y <= 10 ^ 160) by exact (length_below (on_doubles x (square 0)) Y Yfmt Ey2).
  destruct (inverse_of_length Y Yfmt LowS HighY) as [LowY Unit]. rewrite <- Er in Unit.
  assert (Hs1 : i * b * (1 - u) - u * tau <= s <= i * b * (1 + u) + u * tau) by (rewrite (Rmult_comm i b); lra).
  assert (L0 : 0 < len Y) by (assert (0 < / 10 ^ 140) by (apply Rinv_0_lt_compat, pow_lt; lra); lra).
  assert (Ls : 19.9 * u <= s).
  { assert (i * (20 * u * len Y) <= i * b) by (apply Rmult_le_compat_l; lra).
    assert (20 * u * (1 - 3.6 * u) <= 20 * u * (i * len Y)) by (apply Rmult_le_compat_l; lra).
    assert (u * tau <= 0.001 * u).
    { replace (0.001 * u) with (u * 0.001) by lra. apply Rmult_le_compat_l; [lra|]. eapply Rle_trans; [exact Tau|].
      apply Rle_trans with (/ 10 ^ 3); [apply Rinv_le; [apply pow_lt; lra | apply Rle_pow; [lra | lia]] | lra]. }
    rewrite Hu in *. lra. }
  (* the tangent *)
  destruct (forward (fun _ => on_doubles x sine) (fun n => match n with 0%nat => 0 | _ => 5000 end)%Z
    (Mul (Var 0) (Add one (Mul (Cst (fst kTangentOfSine) (snd kTangentOfSine)) (Var 0)))) 3) as [Ft [Et _]].
  { intros [|n] Hn; [|discriminate Hn]. split; [exact Fs|]. fold s. change (bpow radix2 0) with 1.
    rewrite Rabs_pos_eq; lra. }
  { vm_compute. reflexivity. }
  change (on_doubles (fun _ => on_doubles x sine) (Mul (Var 0) (Add one (Mul (Cst (fst kTangentOfSine) (snd
    kTangentOfSine)) (Var 0))))) with (on_doubles x tangent) in *.
  assert (Tc := tangent_covers s (F2R (Float radix2 (fst kTangentOfSine) (snd kTangentOfSine))) ltac:(lra)
    (conj A2 A3) (fmt_val (on_doubles x sine))). cbv zeta in Tc.
  assert (Et' : val (on_doubles x tangent) = rnd (s * rnd (1 + rnd (F2R (Float radix2 (fst kTangentOfSine) (snd
    kTangentOfSine)) * s)))).
  { rewrite Et. unfold rounded, one. cbn [on_reals]. fold s. replace (F2R (Float radix2 1 0)) with 1
      by (unfold F2R; cbn; lra). reflexivity. }
  rewrite <- Et' in Tc.
  assert (Known := shortened_known e f Y y b s _ i Ffmt Yfmt Near Edge LowY Unit Ye B1 B2 Hs1 ltac:(lra) Tc).
  (* the coordinates are finite *)
  assert (Flat : Rabs (dot Y e) <= len Y * len e / 15).
  { replace (dot Y e) with (dot (vsub Y y) e).
    - assert (dL : len (vsub Y y) <= len Y / 15).
      { apply Rmult_le_reg_l with i; [exact Pi|].
        assert (i * (len (vsub Y y) + 8 * u * len Y) <= i * b) by (apply Rmult_le_compat_l; lra).
        assert (0 <= i * (u * len Y)) by (apply Rmult_le_pos; [lra | apply Rmult_le_pos; lra]).
        assert (u * tau <= 0.001 * u).
        { replace (0.001 * u) with (u * 0.001) by lra. apply Rmult_le_compat_l; [lra|]. eapply Rle_trans; [exact Tau|].
          apply Rle_trans with (/ 10 ^ 3); [apply Rinv_le; [apply pow_lt; lra | apply Rle_pow; [lra | lia]] | lra]. }
        assert (i * b <= / 16 * (1 + 3 * u) + u) by (rewrite Hu in *; lra). rewrite Hu in *. lra. }
      eapply Rle_trans; [apply dot_len|].
      assert (len (vsub Y y) * len e <= len Y / 15 * len e) by (apply Rmult_le_compat_r; [apply len_nonneg | exact dL]).
      lra.
    - rewrite (dot_sym (vsub Y y)), dot_sub_right, (dot_sym e y), Ye, dot_sym. ring. }
  destruct (shortened_on_doubles e x (on_doubles x inverse_length) i Fy Ff Fee Near Edge (conj LowY HighY) Unit Flat Fi
    (Rabs_pos_eq i (Rlt_le _ _ Pi))) as [Coord Value].
  split.
  - intros z [<-|[<-|[<-|[<-|[]]]]]; [exact (Coord 0%nat ltac:(lia)) | exact (Coord 1%nat ltac:(lia)) |
      exact (Coord 2%nat ltac:(lia)) | exact Ft].
  - refine (eq_ind _ (fun U => known e y U _) Known _ (eq_sym Value)).
Qed.
End OfVector.
