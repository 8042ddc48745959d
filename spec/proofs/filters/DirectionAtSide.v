(* `side_right`: where start_at_side() of src/flow/kernels/direction.h says that a direction is known, it is, on
   doubles. The true direction is that from the middle of p0p1 to the centre of the circle through p0, p1 and c. *)
From Coq Require Import Reals ZArith QArith Qreals Lra Lia Psatz Bool List.
From Flocq Require Import Core BinarySingleNaN.
From Flowcert Require Import algebra.Vector3 algebra.Crossing code.Expression code.generated.Constants
  filters.Rounding filters.RoundedVectors filters.Norms filters.Floors filters.Doubles filters.Terms filters.Filter
  filters.Directions filters.DirectionSigns filters.DirectionVectors filters.DirectionOfVector filters.DirectionStarts.
From Flowcert Require algebra.Cascade filters.Cells.
Import ListNotations.
Open Scope R_scope.

(* Vector 1 is the edge, and vectors 2 and 3 are c seen from its ends. *)
Definition side_pairs := [(0, 1); (0, 2); (1, 2)]%nat.
Definition side_inputs := inputs side_pairs.
Definition angle_at_corner := edot (given 2) (given 3).
Definition zero := Cst 0 0.
Definition side_of_corner := Choose Less zero angle_at_corner one (Cst (-1) 0).
Definition unsigned i :=
  Sub (Mul (square 1) (Var (6 + i))) (Mul (edot (given 2) (given 1)) (Var (3 + i))).
Definition side_bound := Mul (Mul (in_roundoffs kSideStartBound) (square 1)) (Root (square 2)).
Definition twice_in_roundoffs (c : Z * Z) := Cst (fst c) (snd c + 1 + snd kUnitRoundoff).
Definition uncertain := Mul (twice_in_roundoffs kAngleFormBound) (Add (square 2) (square 3)).
Definition in_side n :=
  replace side_inputs
    match n with
    | 0%nat | 1%nat | 2%nat => Mul side_of_corner (unsigned n)
    | 3%nat | 4%nat | 5%nat => Var n
    | _ => side_bound
    end.
Lemma side_match :
  Code.StartAtSide.u_x = replace in_side Code.OfVector.u_x /\
  Code.StartAtSide.u_y = replace in_side Code.OfVector.u_y /\
  Code.StartAtSide.u_z = replace in_side Code.OfVector.u_z /\
  Code.StartAtSide.error = replace in_side Code.OfVector.error /\
  let aa := replace side_inputs (square 2) in
  Code.StartAtSide.is_known =
    If LessEqual low_square aa (If LessEqual aa high_square
      (If Less (replace side_inputs uncertain) (Abs (replace side_inputs angle_at_corner))
        (replace_in_tree in_side Code.OfVector.is_known)
      (Answer None)) (Answer None)) (Answer None).
Proof. repeat split; vm_compute; reflexivity. Qed.

(* The vector that the code makes, without rounding. *)
Definition sign_factor h : R := if Rlt_dec 0 h then 1 else -1.
Definition way_to_side p0 p1 c := vscale (sign_factor (dot (vsub c p0) (vsub c p1))) (side_vector p0 p1 c).
Lemma side_vector_of_code : forall p0 p1 c, let e := vsub p1 p0 in let a := vsub c p0 in
  side_vector p0 p1 c = vsub (vscale (dot e e) a) (vscale (dot a e) e).
Proof. intros. unfold side_vector, area_vector, e, a. clear. vdestruct. apply vec_eq; unfold dot; cbn; ring. Qed.
Lemma way_to_side_in_facet : forall p0 p1 c, dot (way_to_side p0 p1 c) (vsub p1 p0) = 0.
Proof.
  intros. unfold way_to_side, side_vector. generalize (sign_factor (dot (vsub c p0) (vsub c p1))) (area_vector p0 p1 c)
    (vsub p1 p0). clear. intros. vdestruct. vunfold. ring.
Qed.
Lemma way_to_side_is_to_centre : forall p0 p1 c z, area_vector p0 p1 c <> vzero -> dot (vsub c p0) (vsub c p1) <> 0 ->
  dist2 z p0 = dist2 z p1 -> dist2 z p0 = dist2 z c -> dot (vsub z p0) (area_vector p0 p1 c) = 0 ->
  exists k, 0 < k /\ way_to_side p0 p1 c = vscale k (vsub z (midpoint p0 p1)).
Proof.
  intros p0 p1 c z N H Z1 Z2 Z3. rewrite (centre_from_midpoint p0 p1 c z N Z1 Z2 Z3).
  apply dot_positive in N. set (n := dot (area_vector p0 p1 c) (area_vector p0 p1 c)) in *. unfold way_to_side,
    Cascade.h.
  set (h := dot (vsub c p0) (vsub c p1)) in *. exists (2 * n / Rabs h).
  assert (P := Rabs_pos_lt h H). split; [apply Rdiv_lt_0_compat; lra|].
  unfold sign_factor. destruct (Rlt_dec 0 h) as [L|L].
  - rewrite Rabs_pos_eq by lra. apply vec_eq; cbn; field; lra.
  - rewrite Rabs_left1 by lra. apply vec_eq; cbn; field; lra.
Qed.
Lemma side_vector_len : forall p0 p1 c, let e := vsub p1 p0 in let a := vsub c p0 in
  len (side_vector p0 p1 c) <= len e * len e * len a.
Proof.
  intros. unfold side_vector. fold e.
  replace (area_vector p0 p1 c) with (cross e a) by (unfold area_vector, e, a; clear; vdestruct; apply vec_eq; cbn;
    ring).
  eapply Rle_trans; [apply cross_len|]. assert (C := cross_len e a). generalize (len_nonneg e). intro L.
  assert (len (cross e a) * len e <= len e * len a * len e) by (apply Rmult_le_compat_r; lra). lra.
Qed.
Lemma unit_factor : forall h v, len (vscale (sign_factor h) v) = len v.
Proof.
  intros h v. rewrite len_scale_any. unfold sign_factor. destruct (Rlt_dec 0 h); [rewrite Rabs_R1 | rewrite Rabs_left
    by lra]; ring.
Qed.

(* ---- Roundings ---- *)

Lemma close_to_itself : forall v d, fmt3 v -> vapprox 1 v d -> napprox u (len d) v d.
Proof.
  intros v d F A. generalize u_pos. intro. split; [exact F | apply vapprox_len, A | lra | lra].
Qed.
Lemma side_error : forall e a ve va, fmt3 ve -> fmt3 va -> vapprox 1 ve e -> vapprox 1 va a ->
  / 10 ^ 26 <= len e -> / 10 ^ 26 <= len a ->
  let M := len e * len e * len a in
  let y := vsub (vscale (dot e e) a) (vscale (dot a e) e) in len y <= M ->
  len (vsub (rsub (rscale (rdot ve ve) va) (rscale (rdot va ve) ve)) y) <= 15.001 * u * M.
Proof.
  intros e a ve va Fe Fa Ae Aa He Ha M y Hy. generalize u_pos u_val. intros U0 Hu.
  assert (Ne := close_to_itself ve e Fe Ae). assert (Na := close_to_itself va a Fa Aa).
  assert (P26 : 0 < / 10 ^ 26) by (apply Rinv_0_lt_compat, pow_lt; lra).
  assert (T : forall z, / 10 ^ 78 <= z -> tau <= / 10 ^ 40 * z).
  { intros z H. apply (floor_tau 78); [lia | exact H]. }
  assert (D : forall k m z, (k <= m)%nat -> / 10 ^ k <= z -> / 10 ^ m <= z).
  { intros k m z H1 H2. eapply Rle_trans; [|exact H2]. apply Rinv_le; [apply pow_lt; lra | apply Rle_pow; [lra | lia]].
    }
  assert (ee : / 10 ^ 52 <= len e * len e) by (apply (floor_mult 26 26); assumption).
  assert (ae : / 10 ^ 52 <= len a * len e) by (apply (floor_mult 26 26); assumption).
  assert (eea : / 10 ^ 78 <= len e * len e * len a) by (apply (floor_mult 52 26); assumption).
  assert (aee : / 10 ^ 78 <= len a * len e * len e) by (apply (floor_mult 52 26); assumption).
  assert (S1 := sapprox_dot _ _ _ _ _ _ _ _ (5.0002 * u) Ne Ne (T _ (D 52%nat 78%nat _ ltac:(lia) ee))
    ltac:(rewrite Hu; lra)).
  assert (S2 := sapprox_dot _ _ _ _ _ _ _ _ (5.0002 * u) Na Ne (T _ (D 52%nat 78%nat _ ltac:(lia) ae))
    ltac:(rewrite Hu; lra)).
  assert (V1 := napprox_scale _ _ _ _ _ _ _ _ (7.0003 * u) S1 Na (T _ eea) ltac:(rewrite Hu; lra)).
  assert (V2 := napprox_scale _ _ _ _ _ _ _ _ (7.0003 * u) S2 Ne (T _ aee) ltac:(rewrite Hu; lra)).
  destruct V1 as [F1 E1 _ _]. destruct V2 as [F2 E2 _ _].
  set (p := rscale (rdot ve ve) va) in *. set (q := rscale (rdot va ve) ve) in *.
  assert (M0 : 0 < M) by (assert (0 < / 10 ^ 78) by (apply Rinv_0_lt_compat, pow_lt; lra); unfold M; lra).
  assert (Diff : len (vsub (vsub p q) y) <= 14.0006 * u * M).
  { unfold y. replace (vsub (vsub p q) (vsub (vscale (dot e e) a) (vscale (dot a e) e))) with
      (vadd (vsub p (vscale (dot e e) a)) (vscale (-1) (vsub q (vscale (dot a e) e)))) by (apply vec_eq; cbn; ring).
    eapply Rle_trans; [apply len_triangle|]. rewrite len_scale_any.
    replace (Rabs (-1)) with 1 by (rewrite Rabs_left; lra). unfold M. lra. }
  assert (R := rsub_rounding p q F1 F2).
  assert (Lpq : len (vsub p q) <= M * (1 + 15 * u)).
  { eapply Rle_trans; [apply (len_from _ y)|]. assert (0 < u * M) by (apply Rmult_lt_0_compat; lra). lra. }
  eapply Rle_trans; [apply (len_between _ (vsub p q))|].
  assert (u * len (vsub p q) <= u * (M * (1 + 15 * u))) by (apply Rmult_le_compat_l; lra). rewrite Hu in *. lra.
Qed.

Definition side_needs : Q := 2301 # 100.
Definition uncertain_needs : Q := 13 # 10.

(* The bound, and the certain angle. *)
Lemma side_covers : forall c ee r E A, 23.01 * u <= c <= 1000 * u -> / 10 ^ 26 <= E -> / 10 ^ 26 <= A ->
  E * E * (1 - 5.001 * u) <= ee -> A * (1 - 3.51 * u) <= r ->
  let M := E * E * A in 23.0095 * u * M <= rnd (rnd (c * ee) * r) /\ / 10 ^ 78 <= M.
Proof.
  intros c ee r E A Hc HE HA Hee Hr M. generalize u_pos u_val tau_small. intros U0 Hu Tau.
  assert (P : forall k, 0 < / 10 ^ k) by (intro; apply Rinv_0_lt_compat, pow_lt; lra). assert (P26 := P 26%nat).
  assert (EE : / 10 ^ 52 <= E * E) by (apply (floor_mult 26 26); assumption). assert (P52 := P 52%nat).
  assert (MM : / 10 ^ 78 <= M) by (apply (floor_mult 52 26); assumption). assert (P78 := P 78%nat).
  assert (T : forall k z, (k <= 290)%nat -> / 10 ^ k <= z -> tau <= z).
  { intros k z A1 A2. eapply Rle_trans; [exact Tau|]. eapply Rle_trans; [|exact A2]. apply Rinv_le; [apply pow_lt; lra |
      apply Rle_pow; [lra | lia]]. }
  split; [|exact MM].
  set (Z := 23.01 * u * (E * E * (1 - 5.001 * u))).
  assert (Z0 : / 10 ^ 67 <= Z).
  { apply Rle_trans with (23.01 * u * (/ 10 ^ 52 * (1 - 5.001 * u))); [rewrite Hu; lra|].
    apply Rmult_le_compat_l; [lra|]. apply Rmult_le_compat_r; [rewrite Hu; lra | exact EE]. }
  assert (H1 : Z <= c * ee).
  { apply Rmult_le_compat; [lra | apply Rmult_le_pos; rewrite ?Hu; lra | lra | exact Hee]. }
  assert (R1 := rnd_lower _ Z (T 67%nat _ ltac:(lia) Z0) H1).
  assert (P67 := P 67%nat).
  assert (H2 : Z * (1 - 2 * u) * (A * (1 - 3.51 * u)) <= rnd (c * ee) * r).
  { apply Rmult_le_compat; [apply Rmult_le_pos; rewrite ?Hu; lra | apply Rmult_le_pos; rewrite ?Hu; lra | exact R1 |
      exact Hr]. }
  assert (EZ : Z * (1 - 2 * u) * (A * (1 - 3.51 * u)) = 23.01 * u * M * ((1 - 5.001 * u) * (1 - 2 * u) * (1 - 3.51 *
    u))) by (unfold Z, M; ring).
  assert (Z2 : / 10 ^ 94 <= Z * (1 - 2 * u) * (A * (1 - 3.51 * u))).
  { rewrite EZ. apply Rle_trans with (23.01 * u * / 10 ^ 78 * ((1 - 5.001 * u) * (1 - 2 * u) * (1 - 3.51 * u)));
      [rewrite Hu; lra|]. apply Rmult_le_compat_r; [rewrite Hu; lra|]. apply Rmult_le_compat_l; lra. }
  eapply Rle_trans; [|exact (rnd_lower _ _ (T 94%nat _ ltac:(lia) Z2) H2)]. rewrite EZ. rewrite Hu in *. lra.
Qed.

Lemma certain_angle : forall c aa bb h H A B, 2.6 * u <= c -> / 10 ^ 26 <= A -> 0 <= B -> fmt aa -> fmt bb ->
  Rabs (aa - A * A) <= Rounding.E 5 * (A * A + 3 * tau) -> Rabs (bb - B * B) <= Rounding.E 5 * (B * B + 3 * tau) ->
  Rabs (h - H) <= Rounding.E 5 * (A * B + 3 * tau) -> rnd (c * rnd (aa + bb)) < Rabs h ->
  (0 < h -> 0 < H) /\ (h <= 0 -> H <= 0).
Proof.
  intros c aa bb h H A B Hc HA HB Fa Fb Haa Hbb Hh Hr. generalize u_pos u_val tau_pos tau_small. intros U0 Hu T0 Tau.
  assert (E5 : 0 <= Rounding.E 5 <= 5.0001 * u).
  { split; [apply E_nonneg|]. unfold Rounding.E. rewrite Hu. simpl. lra. }
  assert (P26 : 0 < / 10 ^ 26) by (apply Rinv_0_lt_compat, pow_lt; lra).
  assert (AA : / 10 ^ 52 <= A * A) by (apply (floor_mult 26 26); assumption).
  assert (BB : 0 <= B * B) by apply Rle_0_sqr. assert (AB : 0 <= A * B) by (apply Rmult_le_pos; lra).
  assert (T : tau <= / 10 ^ 100 * (A * A)).
  { eapply Rle_trans; [exact Tau|]. apply Rle_trans with (/ 10 ^ 100 * / 10 ^ 52); [|apply Rmult_le_compat_l; [left;
    apply
      Rinv_0_lt_compat, pow_lt; lra | exact AA]]. rewrite <- Rinv_mult, <- pow_add. apply Rinv_le; [apply pow_lt; lra |
      apply Rle_pow; [lra | lia]]. }
  assert (X : forall z, 0 <= z -> Rounding.E 5 * (z + 3 * tau) <= 5.0001 * u * (z + 3 * tau))
    by (intros; apply Rmult_le_compat_r; lra).
  assert (X1 := X _ (Rlt_le _ _ (Rlt_le_trans _ _ _ (Rinv_0_lt_compat _ (pow_lt 10 52 ltac:(lra))) AA))).
  assert (X2 := X _ BB). assert (X3 := X _ AB). apply Rabs_le_inv in Haa, Hbb, Hh.
  set (S := A * A + B * B) in *. assert (S0 : / 10 ^ 52 <= S) by (unfold S; lra).
  assert (TS : tau <= / 10 ^ 100 * S).
  { eapply Rle_trans; [exact T|]. apply Rmult_le_compat_l; [left; apply Rinv_0_lt_compat, pow_lt; lra | unfold S; lra].
    }
  assert (ab : S * (1 - 5.01 * u) <= aa + bb) by (unfold S in *; rewrite Hu in *; lra).
  assert (P52 : 0 < / 10 ^ 52) by (apply Rinv_0_lt_compat, pow_lt; lra).
  assert (R := rnd_plus aa bb Fa Fb). rewrite (Rabs_pos_eq (aa + bb)) in R by (rewrite Hu in *; lra).
  apply Rabs_le_inv in R. set (s := rnd (aa + bb)) in *.
  assert (s1 : S * (1 - 6.02 * u) <= s) by (rewrite Hu in *; lra).
  assert (cs : 2.6 * u * (S * (1 - 6.02 * u)) <= c * s).
  { apply Rmult_le_compat; [lra | apply Rmult_le_pos; rewrite ?Hu; lra | exact Hc | exact s1]. }
  assert (Tt : tau <= 2.6 * u * (S * (1 - 6.02 * u))).
  { eapply Rle_trans; [exact TS|]. rewrite Hu. lra. }
  assert (Low := rnd_lower _ _ Tt cs).
  assert (Q : A * B <= S / 2).
  { assert (0 <= (A - B) * (A - B)) by apply Rle_0_sqr. unfold S. lra. }
  assert (Big : 5.0001 * u * (A * B + 3 * tau) < Rabs h).
  { eapply Rle_lt_trans; [|exact Hr]. eapply Rle_trans; [|exact Low]. rewrite Hu in *. lra. }
  split; intro D.
  - rewrite Rabs_pos_eq in Big by lra. lra.
  - rewrite Rabs_left1 in Big by exact D. lra.
Qed.

Lemma factor_below : forall b : double, finite (Bmult mode_NE b b) -> finite b /\ Rabs (val b) <= bpow radix2 512.
Proof.
  intros b F. destruct (mul_back _ _ F) as [Fb [_ V]]. split; [exact Fb|]. apply Rnot_lt_le. intro N.
  assert (B : bpow radix2 1024 <= val b * val b).
  { replace (val b * val b) with (Rabs (val b) * Rabs (val b)) by (rewrite <- Rabs_mult; apply Rabs_pos_eq, Rle_0_sqr).
    change 1024%Z with (512 + 512)%Z. rewrite bpow_plus. generalize (bpow_gt_0 radix2 512). intro.
    apply Rmult_le_compat; lra. }
  assert (R : bpow radix2 1024 <= rnd (val b * val b)).
  { unfold rnd. apply round_ge_generic; auto with typeclass_instances. apply generic_format_FLT_bpow; [reflexivity |
    lia].
    }
  rewrite <- V in R. generalize (abs_B2R_lt_emax 53 1024 (Bmult mode_NE b b)). fold (val (Bmult mode_NE b b)).
  generalize (Rle_abs (val (Bmult mode_NE b b))). lra.
Qed.

Section Side.
Variable x : nat -> double.
Let w n := on_doubles x (side_inputs n).
Let z n := on_doubles x (in_side n).
Let d k := value_of_vector (exact_inputs side_pairs x) k.
Let v k := value_of_vector (fun n => val (w n)) k.

Lemma square_near : forall k, finite (on_doubles w (square (S k))) ->
  fmt3 (v (S k)) /\ vapprox 1 (v (S k)) (d (S k)) /\
  (forall i, (i < 3)%nat -> finite (w (3 * S k + i)%nat)) /\ val (on_doubles w (square (S k))) = rdot (v (S k)) (v (S
    k))
  /\ Rabs (val (on_doubles w (square (S k))) - len (d (S k)) * len (d (S k))) <= Rounding.E 5 * (len (d (S k)) * len (d
    (S
    k)) + 3 * tau).
Proof.
  intros k F. destruct (difference_back side_pairs x k F) as [C [M [A E]]].
  change (fun n => on_doubles x (inputs side_pairs n)) with w in *. fold (v (S k)) (d (S k)) in M, A, E.
  split; [exact M|]. split; [exact A|]. split; [exact C|]. split; [exact E|]. rewrite E.
  destruct (rdot_approx 1 1 _ _ _ _ A A) as [_ P _]. rewrite absdot_self, <- len_sq in P. exact P.
Qed.

Theorem side_start_is_good :
  let p k := point x k in let e := vsub (p 1%nat) (p 0%nat) in let y := way_to_side (p 0%nat) (p 1%nat) (p 2%nat) in
  square_in_range w (square 1) -> square_in_range w (square 2) ->
  compare_doubles Less (on_doubles w uncertain) (Babs (on_doubles w angle_at_corner)) = true ->
  good_start e y z.
Proof.
  intros p e y R1 R2 Certain. generalize u_pos u_val. intros U0 Hu.
  assert (EW : forall t, on_doubles x (replace side_inputs t) = on_doubles w t) by (intro; apply on_doubles_replace).
  assert (SN : forall k, not_negative (on_doubles w (square k))).
  { intro k. unfold square. cbn [on_doubles edot given tx ty tz].
    apply Cells.add_not_negative; [apply Cells.add_not_negative|]; apply square_not_negative. }
  split.
  - apply way_to_side_in_facet.
  - intro F. destruct (square_range_back w _ R1) as [F1 _]. destruct (square_near 0 F1) as [_ [A _]].
    apply vapprox_len. exact A.
  - unfold z, in_side. rewrite EW. unfold side_bound. cbn [on_doubles].
    apply Cells.mul_not_negative; [apply Cells.mul_not_negative|].
    + apply (Cells.positive_not_negative (fun _ => B754_zero false) (in_roundoffs kSideStartBound)); [|reflexivity].
      intro k. right. reflexivity.
    + apply SN.
    + apply root_not_negative, SN.
  - intros Fb Fy.
    destruct (square_range_back w _ R1) as [F1 _]. destruct (square_near 0 F1) as [M1 [A1 [C1 [E1 B1]]]].
    destruct (square_range_back w _ R2) as [F2 _]. destruct (square_near 1 F2) as [M2 [A2 [C2 [E2 B2]]]].
    destruct (length_back side_pairs x 0 R1) as [_ [_ [H1 _]]].
    destruct (length_back side_pairs x 1 R2) as [_ [V2 [H2 [L2 P2]]]].
    change (value_of_vector (exact_inputs side_pairs x) 1) with (d 1%nat) in *.
    change (value_of_vector (exact_inputs side_pairs x) 2) with (d 2%nat) in *.
    (* the certain angle *)
    assert (Fu : finite (on_doubles w uncertain)).
    { assert (N : not_negative (on_doubles w uncertain)).
      { unfold uncertain. cbn [on_doubles]. apply Cells.mul_not_negative.
        - apply (Cells.positive_not_negative (fun _ => B754_zero false) (twice_in_roundoffs kAngleFormBound));
            [|reflexivity]. intro k. right. reflexivity.
        - apply Cells.add_not_negative; apply SN. }
      destruct (on_doubles w uncertain) as [t|t| |t m k G]; try reflexivity.
      - exfalso. destruct N as [N|N]; [discriminate|]. cbn in N. subst t.
        destruct (on_doubles w angle_at_corner) as [t|t| |t m k G]; discriminate.
      - exfalso. destruct (on_doubles w angle_at_corner) as [t|t| |t m k G]; discriminate. }
    assert (Fu2 := Fu). unfold uncertain in Fu2. cbn [on_doubles] in Fu2. destruct (mul_back _ _ Fu2) as [_ [Fs Eu]].
    destruct (add_back _ _ Fs) as [_ [F3 Es]]. destruct (square_near 2 F3) as [M3 [A3 [C3 [E3 B3]]]].
    assert (S3 : forall i, (i < 3)%nat -> Rabs (val (w (3 * 3 + i)%nat)) <= bpow radix2 512).
    { assert (F := F3). unfold square in F. cbn [on_doubles edot given tx ty tz] in F.
      destruct (add_back _ _ F) as [G1 [G2 _]]. destruct (add_back _ _ G1) as [G3 [G4 _]].
      intros [|[|[|i]]] Hi; [apply (factor_below _ G3) | apply (factor_below _ G4) | apply (factor_below _ G2) | lia]. }
    destruct (forward w (fun n => if (n <? 6)%nat then 5000 else if (n <? 9)%nat then 88 else if (n <? 12)%nat then 512
      else 5000)%Z angle_at_corner 602) as [Fh [Eh _]]; [|vm_compute; reflexivity|].
    { intros n Hn. destruct (Nat.ltb_spec n 6); [discriminate Hn|]. destruct (Nat.ltb_spec n 9).
      - replace n with (3 * 2 + (n - 6))%nat by lia. apply (coordinate_powers side_pairs x 2 _ V2); [apply H2 | lia].
      - destruct (Nat.ltb_spec n 12); [|discriminate Hn]. replace n with (3 * 3 + (n - 9))%nat by lia.
        split; [apply C3; lia | apply S3; lia]. }
    assert (Eh' : val (on_doubles w angle_at_corner) = rdot (v 2%nat) (v 3%nat)) by exact Eh. clear Eh.
    set (hc := val (on_doubles w angle_at_corner)) in *.
    assert (Bh : Rabs (hc - dot (d 2%nat) (d 3%nat)) <= Rounding.E 5 * (len (d 2%nat) * len (d 3%nat) + 3 * tau)).
    { rewrite Eh'. destruct (rdot_approx 1 1 _ _ _ _ A2 A3) as [_ P _]. change (1 + 1 + 3)%nat with 5%nat in P.
      eapply Rle_trans; [exact P|]. apply Rmult_le_compat_l; [apply E_nonneg|]. generalize (absdot_len (d 2%nat) (d
        3%nat)). lra. }
    change (compare_doubles Less (on_doubles w uncertain) (Babs (on_doubles w angle_at_corner)) = true) in Certain.
    rewrite compare_finite in Certain by (try assumption; unfold finite; rewrite is_finite_Babs; exact Fh).
    cbn [compare_reals] in Certain. replace (val (Babs (on_doubles w angle_at_corner))) with (Rabs hc) in Certain
      by (symmetry; apply B2R_Babs). revert Certain. case Rlt_bool_spec; [|discriminate]. intros Certain _.
    set (c4 := val (on_doubles w (twice_in_roundoffs kAngleFormBound))).
    assert (Hc4 : 2.6 * u <= c4).
    { assert (Q : Qle_bool ((26 # 10) * unit) (rational (fst kAngleFormBound) (snd kAngleFormBound + 1 + snd
        kUnitRoundoff)) = true) by (vm_compute; reflexivity).
      apply Qle_bool_iff, Qle_Rle in Q. rewrite Q2R_mult, unit_u, rational_value in Q.
      replace (Q2R (26 # 10)) with 2.6 in Q by (unfold Q2R; cbn; lra).
      destruct (height (fun _ => 5000%Z) (twice_in_roundoffs kAngleFormBound)) as [top|] eqn:Top;
        [|vm_compute in Top; discriminate].
      destruct (forward w (fun _ => 5000%Z) (twice_in_roundoffs kAngleFormBound) top) as [_ [V _]];
        [intros n Hn; discriminate Hn | exact Top|]. unfold c4. rewrite V. exact Q. }
    assert (Eu' : val (on_doubles w uncertain) = rnd (c4 * rnd (val (on_doubles w (square 2)) + val (on_doubles w
      (square
      3))))) by (rewrite <- Es; exact Eu).
    rewrite Eu' in Certain.
    destruct (certain_angle c4 _ _ hc (dot (d 2%nat) (d 3%nat)) (len (d 2%nat)) (len (d 3%nat)) Hc4 (proj1 H2)
      (len_nonneg
      _) (fmt_val _) (fmt_val _) B2 B3 Bh Certain) as [Up Down].
    (* the sign *)
    set (sigma := sign_factor (dot (d 2%nat) (d 3%nat))).
    assert (Side : finite (on_doubles w side_of_corner) /\ val (on_doubles w side_of_corner) = sigma).
    { unfold side_of_corner. cbn [on_doubles].
      rewrite compare_finite by (first [exact Fh | reflexivity]). cbn [compare_reals]. fold hc.
      change (val (binary_normalize 53 1024 _ _ mode_NE 0 0 false)) with 0.
      unfold sigma, sign_factor. case Rlt_bool_spec; intro Q.
      - destruct (Rlt_dec 0 (dot (d 2%nat) (d 3%nat))) as [_|N]; [apply (one_on_doubles w) | exfalso; apply N, Up, Q].
      - destruct (Rlt_dec 0 (dot (d 2%nat) (d 3%nat))) as [N|_]; [exfalso; generalize (Down Q); lra|].
        destruct (normal_constant (-1) 0 1 ltac:(lia) ltac:(lia) ltac:(lia) eq_refl) as [F V]. split; [exact F|].
        etransitivity; [exact V|]. unfold F2R. cbn. lra. }
    destruct Side as [_ Es2].
    assert (Sig : sigma = 1 \/ sigma = -1) by (unfold sigma, sign_factor; destruct Rlt_dec; auto).
    set (Q := rsub (rscale (rdot (v 1%nat) (v 1%nat)) (v 2%nat)) (rscale (rdot (v 2%nat) (v 1%nat)) (v 1%nat))).
    assert (Coordinate : forall i, (i < 3)%nat -> val (z i) = sigma * rounded (fun n => val (w n)) (unsigned i)).
    { intros i Hi. assert (E : z i = Bmult mode_NE (on_doubles w side_of_corner) (on_doubles w (unsigned i))).
      { unfold z, in_side. rewrite EW. destruct i as [|[|[|i]]]; [reflexivity | reflexivity | reflexivity | lia]. }
      assert (Fi := Fy i Hi). rewrite E in Fi |- *. destruct (mul_back _ _ Fi) as [_ [Fz V]]. rewrite V, Es2.
      assert (P : is_polynomial (unsigned i) = true) by reflexivity.
      destruct (backward w (unsigned i) P Fz) as [Ez _]. rewrite <- Ez.
      apply round_generic; [apply valid_rnd_N|]. destruct Sig as [-> | ->].
      - rewrite Rmult_1_l. apply fmt_val.
      - replace (-1 * val (on_doubles w (unsigned i))) with (- val (on_doubles w (unsigned i))) by ring.
        apply fmt_opp, fmt_val. }
    assert (EY : value_of_vector (fun n => val (z n)) 0 = vscale sigma Q).
    { unfold value_of_vector. cbn [Nat.mul Nat.add]. rewrite !Coordinate by lia. reflexivity. }
    assert (Ey : y = vscale sigma (vsub (vscale (dot (d 1%nat) (d 1%nat)) (d 2%nat)) (vscale (dot (d 2%nat) (d 1%nat))
      (d
      1%nat)))).
    { unfold y, way_to_side. rewrite side_vector_of_code. reflexivity. }
    rewrite EY, Ey.
    set (y0 := vsub (vscale (dot (d 1%nat) (d 1%nat)) (d 2%nat)) (vscale (dot (d 2%nat) (d 1%nat)) (d 1%nat))) in *.
    assert (Ly : len y0 <= len (d 1%nat) * len (d 1%nat) * len (d 2%nat)).
    { assert (A := side_vector_len (p 0%nat) (p 1%nat) (p 2%nat)). rewrite side_vector_of_code in A. exact A. }
    assert (Err := side_error (d 1%nat) (d 2%nat) (v 1%nat) (v 2%nat) M1 M2 A1 A2 (proj1 H1) (proj1 H2) Ly).
    fold Q y0 in Err. cbv zeta in Err.
    replace (vsub (vscale sigma Q) (vscale sigma y0)) with (vscale sigma (vsub Q y0)) by (apply vec_eq; cbn; ring).
    unfold sigma. rewrite !unit_factor.
    (* the bound *)
    destruct (header_constant kSideStartBound side_needs 1000 eq_refl w) as [Fc Hc].
    replace (Q2R side_needs) with 23.01 in Hc by (unfold Q2R; cbn; lra).
    replace (Q2R 1000) with 1000 in Hc by (unfold Q2R; cbn; lra).
    assert (E6 : z 6%nat = Bmult mode_NE (Bmult mode_NE (on_doubles w (in_roundoffs kSideStartBound)) (on_doubles w
      (square
      1))) (Bsqrt mode_NE (on_doubles w (square 2)))) by (unfold z, in_side; rewrite EW; reflexivity).
    rewrite E6 in Fb |- *. destruct (mul_back _ _ Fb) as [Fb1 [Fb2 Eb]]. destruct (mul_back _ _ Fb1) as [_ [_ Eb1]].
    destruct (root_back _ Fb2) as [_ Eb2]. rewrite Eb, Eb1, Eb2. clear E6.
    set (ee := val (on_doubles w (square 1))) in *.
    assert (P26 : 0 < / 10 ^ 26) by (apply Rinv_0_lt_compat, pow_lt; lra).
    assert (LE : len (d 1%nat) * len (d 1%nat) * (1 - 5.001 * u) <= ee).
    { assert (EE : / 10 ^ 52 <= len (d 1%nat) * len (d 1%nat)) by (apply (floor_mult 26 26); apply H1).
      assert (T := tau_below (len (d 1%nat) * len (d 1%nat)) ltac:(eapply Rle_trans; [|exact EE]; apply Rinv_le; [apply
        pow_lt; lra | apply Rle_pow; [lra | lia]])).
      assert (P52 : 0 < / 10 ^ 52) by (apply Rinv_0_lt_compat, pow_lt; lra).
      assert (E5 : 0 <= Rounding.E 5 <= 5.0001 * u).
      { split; [apply E_nonneg|]. unfold Rounding.E. rewrite Hu. simpl. lra. }
      assert (Rounding.E 5 * (len (d 1%nat) * len (d 1%nat) + 3 * tau) <= 5.0001 * u * (len (d 1%nat) * len (d 1%nat) +
        3
        * tau)) by (apply Rmult_le_compat_r; generalize tau_pos; lra).
      apply Rabs_le_inv in B1. rewrite Hu in *. lra. }
    destruct (side_covers _ ee _ _ _ Hc (proj1 H1) (proj1 H2) LE L2) as [Cover Large].
    set (M := len (d 1%nat) * len (d 1%nat) * len (d 2%nat)) in *.
    assert (P78 : 0 < / 10 ^ 78) by (apply Rinv_0_lt_compat, pow_lt; lra).
    assert (LQ : len Q <= M * (1 + 16 * u)).
    { eapply Rle_trans; [apply (len_from Q y0)|]. assert (0 < u * M) by (apply Rmult_lt_0_compat; lra). lra. }
    assert (Q8 : 8 * u * len Q <= 8 * u * (M * (1 + 16 * u))) by (apply Rmult_le_compat_l; lra).
    assert (Q20 : 20 * u * len Q <= 20 * u * (M * (1 + 16 * u))) by (apply Rmult_le_compat_l; lra).
    split; [|split].
    + eapply Rle_trans; [|exact Cover]. rewrite Hu in *. lra.
    + eapply Rle_trans; [|exact Cover]. rewrite Hu in *. lra.
    + eapply Rle_trans; [|exact Cover]. apply Rle_trans with (23.0095 * u * / 10 ^ 78); [rewrite Hu; lra |
        apply Rmult_le_compat_l; lra].
Qed.
End Side.

(* p0p1 is the facet's edge, and c the third corner of the triangle. *)
Theorem side_right : forall x,
  let p k := point x k in let e := vsub (p 1%nat) (p 0%nat) in let y := way_to_side (p 0%nat) (p 1%nat) (p 2%nat) in
  run x Code.StartAtSide.is_known = Some Positive ->
  (forall t, In t [Code.StartAtSide.u_x; Code.StartAtSide.u_y; Code.StartAtSide.u_z; Code.StartAtSide.error] ->
    finite (on_doubles x t)) /\
  known e y (V (val (on_doubles x Code.StartAtSide.u_x)) (val (on_doubles x Code.StartAtSide.u_y))
    (val (on_doubles x Code.StartAtSide.u_z))) (val (on_doubles x Code.StartAtSide.error)).
Proof.
  intros x p e y H. destruct side_match as [T1 [T2 [T3 [T4 Known]]]]. cbv zeta in Known. rewrite Known in H.
  cbn [run] in H.
  lazymatch type of H with (if ?test then _ else _) = _ => destruct test eqn:HL; [|discriminate] end.
  lazymatch type of H with (if ?test then _ else _) = _ => destruct test eqn:HH; [|discriminate] end.
  lazymatch type of H with (if ?test then _ else _) = _ => destruct test eqn:HC; [|discriminate] end.
  rewrite run_replace in H. cbn [on_doubles] in HC. rewrite !on_doubles_replace in HL, HH, HC.
  assert (R1 : square_in_range (fun n => on_doubles x (side_inputs n)) (square 1)).
  { assert (H' := H). destruct of_vector_match as [_ [_ [_ [_ Mk]]]]. rewrite Mk in H'. cbn [run] in H'.
    destruct (compare_doubles LessEqual (on_doubles (fun n => on_doubles x (in_side n)) low_square) _) eqn:G1;
      [|discriminate].
    destruct (compare_doubles LessEqual (on_doubles (fun n => on_doubles x (in_side n)) (square 1)) _) eqn:G2;
      [|discriminate].
    split; [exact G1 | exact G2]. }
  destruct (of_vector_right e y _ (side_start_is_good x R1 (conj HL HH) HC) H) as [F K].
  rewrite <- !on_doubles_replace in K. rewrite T1, T2, T3, T4. split; [|exact K].
  intros t [<-|[<-|[<-|[<-|[]]]]]; rewrite on_doubles_replace; apply F; cbn; tauto.
Qed.
