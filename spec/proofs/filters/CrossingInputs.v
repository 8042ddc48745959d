(* What step_across() of src/flow/kernels/direction_across.h gives to direction_behind(), on doubles: differences of
   points, their products and the ratio of two areas. They are finite, and as near to the exact ones as the theorem on
   direction_behind() (CrossingBehind.v) asks. *)
From Coq Require Import Reals ZArith QArith Qreals Lra Lia Psatz Bool List.
From Flocq Require Import Core BinarySingleNaN.
From Flowcert Require Import algebra.Vector3 algebra.Cascade algebra.Crossing code.Expression code.generated.Constants
  filters.Rounding filters.RoundedVectors filters.Norms filters.Floors filters.Doubles filters.Terms filters.Filter
  filters.Directions filters.DirectionSigns filters.DirectionVectors filters.DirectionOfVector filters.DirectionStarts
  filters.CrossingLengths filters.CrossingAreas filters.CrossingVectors filters.CrossingKnown filters.CrossingTerms
  filters.CrossingOnDoubles filters.CrossingBehind.
From Flowcert Require filters.Cells.
Open Scope R_scope.

(* ---- What all passages are given ---- *)

Lemma sum_is_near : forall a b ac bc, fmt3 ac -> fmt3 bc -> vapprox 1 ac a -> vapprox 1 bc b ->
  len (vsub (radd ac bc) (vadd a b)) <= 2.001 * u * (len a + len b).
Proof.
  intros a b ac bc Fa Fb Va Vb. generalize u_pos u_val. intros U0 Hu.
  assert (Na := vapprox_len _ _ Va). assert (Nb := vapprox_len _ _ Vb). assert (R := radd_rounding ac bc Fa Fb).
  assert (La := len_from ac a). assert (Lb := len_from bc b). assert (T := len_triangle ac bc).
  assert (a0 := len_nonneg a). assert (b0 := len_nonneg b).
  replace (vsub (radd ac bc) (vadd a b)) with
    (vadd (vsub (radd ac bc) (vadd ac bc)) (vadd (vsub ac a) (vsub bc b))) by (apply vec_eq; cbn; ring).
  eapply Rle_trans; [apply len_triangle|]. assert (T2 := len_triangle (vsub ac a) (vsub bc b)).
  assert (u * len (vadd ac bc) <= u * ((1 + u) * (len a + len b))) by (apply Rmult_le_compat_l; lra).
  assert (0 <= u * (len a + len b)) by (apply Rmult_le_pos; lra).
  assert (u * (u * (len a + len b)) <= 0.0001 * (u * (len a + len b)))
    by (apply Rmult_le_compat_r; [assumption | rewrite Hu; lra]). lra.
Qed.
Lemma angle_is_near : forall a b ac bc G, vapprox 1 ac a -> vapprox 1 bc b -> / 10 ^ 26 <= G ->
  4 * (len a * len b) <= G * G -> Rabs (rdot ac bc - dot a b) <= 1.3 * u * (G * G).
Proof.
  intros a b ac bc G Va Vb HG H. destruct (rdot_approx 1 1 _ _ _ _ Va Vb) as [_ Er _].
  change (1 + 1 + 3)%nat with 5%nat in Er. eapply Rle_trans; [exact Er|].
  generalize u_pos u_val tau_pos (absdot_len a b). intros U0 Hu T0 A.
  assert (E5 : Rounding.E 5 <= 5.0001 * u) by (unfold Rounding.E; rewrite Hu; simpl; lra).
  assert (P26 : 0 < / 10 ^ 26) by (apply Rinv_0_lt_compat, pow_lt; lra).
  assert (GG : / 10 ^ 52 <= G * G).
  { replace (/ 10 ^ 52) with (/ 10 ^ 26 * / 10 ^ 26) by (rewrite <- Rinv_mult, <- pow_add; reflexivity).
    apply Rmult_le_compat; lra. }
  assert (T := floor_tau 52 (G * G) ltac:(lia) GG).
  assert (0 <= absdot a b) by (unfold absdot; repeat apply Rplus_le_le_0_compat; apply Rmult_le_pos; apply Rabs_pos).
  apply Rle_trans with (5.0001 * u * (G * G / 4 + 3 * (/ 10 ^ 40 * (G * G)))).
  - apply Rmult_le_compat; [apply E_nonneg | lra | exact E5 | lra].
  - rewrite Hu. lra.
Qed.

(* Vectors of a query, in front of a passage. *)
Section Vectors.
Variables (pairs : list (nat * nat)) (y : nat -> double).
Let w n := on_doubles y (inputs pairs n).
Let d k := value_of_vector (exact_inputs pairs y) k.
Let v k := value_of_vector (fun n => val (w n)) k.

Lemma vector_is_near : forall k, (forall i, (i < 3)%nat -> finite (w (3 * S k + i)%nat)) ->
  fmt3 (v (S k)) /\ vapprox 1 (v (S k)) (d (S k)).
Proof.
  intros k F. split; [repeat split; apply fmt_val|].
  assert (A : forall i, (i < 3)%nat -> approx 1 (Rabs (exact_inputs pairs y (3 * S k + i)))
    (val (w (3 * S k + i)%nat)) (exact_inputs pairs y (3 * S k + i))).
  { intros i Hi. assert (Fx := F i Hi). unfold exact_inputs, w, inputs in *.
    replace (3 * S k + i <? 3)%nat with false in * by (symmetry; apply Nat.ltb_ge; lia).
    unfold between in Fx |- *. cbn [on_doubles] in Fx |- *. destruct (sub_back _ _ Fx) as [_ [_ V]]. rewrite V.
    unfold exact_between. apply approx_difference; apply fmt_val. }
  assert (A0 := A 0%nat ltac:(lia)). assert (A1 := A 1%nat ltac:(lia)). assert (A2 := A 2%nat ltac:(lia)).
  rewrite !Nat.add_0_r in A0. unfold vapprox, v, d, value_of_vector. cbn [vx vy vz]. auto.
Qed.

Lemma seen_is_near : square_in_range w (seen_square 1 2) ->
  let G := seen_size (d 1%nat) (d 2%nat) in let S2 := val (on_doubles w (seen_square 1 2)) in
  (fmt3 (v 1%nat) /\ vapprox 1 (v 1%nat) (d 1%nat)) /\ (fmt3 (v 2%nat) /\ vapprox 1 (v 2%nat) (d 2%nat)) /\
  Rabs (S2 - G * G) <= 7.01 * u * (G * G) /\ / 10 ^ 26 <= G <= 10 ^ 26 /\ G * (1 - 4.01 * u) <= rnd (sqrt S2).
Proof.
  intros R G S2. destruct (seen_back pairs y 0 1 R) as [F [B1 [B2 [HG [_ [L [_ _]]]]]]].
  change (value_of_vector (exact_inputs pairs y) 1) with (d 1%nat) in *.
  change (value_of_vector (exact_inputs pairs y) 2) with (d 2%nat) in *. fold G in HG, L, B1, B2.
  assert (N1 := vector_is_near 0 (are_finite _ _ _ _ B1)). assert (N2 := vector_is_near 1 (are_finite _ _ _ _ B2)).
  split; [exact N1|]. split; [exact N2|]. split; [|split; [exact HG | exact L]].
  change (finite (on_doubles w (seen_square 1 2))) in F. unfold S2, seen_square in *.
  destruct (mul_parts _ _ _ F) as [_ [F1 E]]. destruct (add_parts _ _ _ F1) as [Fi [Fj E1]].
  destruct (square_back w 1 Fi) as [_ Ei]. destruct (square_back w 2 Fj) as [_ Ej].
  rewrite (proj2 (power_constant 1 w ltac:(lia))) in E. change (bpow radix2 1) with 2 in E.
  rewrite rnd_double in E by apply fmt_val. cbv zeta in Ei, Ej.
  change (value_of_vector (fun n => val (w n)) 1) with (v 1%nat) in Ei.
  change (value_of_vector (fun n => val (w n)) 2) with (v 2%nat) in Ej.
  assert (P := approx_plus _ _ _ _ _ _ _ (rdot_approx 1 1 _ _ _ _ (proj2 N1) (proj2 N1))
    (rdot_approx 1 1 _ _ _ _ (proj2 N2) (proj2 N2))).
  change (S (1 + 1 + 3)) with 6%nat in P. destruct P as [_ P _]. rewrite !absdot_self in P.
  rewrite E, E1, Ei, Ej. unfold G. rewrite seen_size_square, <- Rmult_minus_distr_l, Rabs_mult, (Rabs_pos_eq 2) by lra.
  generalize u_pos u_val tau_pos. intros U0 Hu T0.
  assert (E6 : Rounding.E 6 <= 6.0001 * u) by (unfold Rounding.E; rewrite Hu; simpl; lra).
  assert (GG : / 10 ^ 52 <= G * G).
  { replace (/ 10 ^ 52) with (/ 10 ^ 26 * / 10 ^ 26) by (rewrite <- Rinv_mult, <- pow_add; reflexivity).
    assert (0 < / 10 ^ 26) by (apply Rinv_0_lt_compat, pow_lt; lra). apply Rmult_le_compat; lra. }
  assert (T := floor_tau 52 (G * G) ltac:(lia) GG). unfold G in T. rewrite seen_size_square in T.
  generalize (dot_self_nonneg (d 1%nat)) (dot_self_nonneg (d 2%nat)). intros P1 P2.
  set (A := dot (d 1%nat) (d 1%nat)) in *. set (B := dot (d 2%nat) (d 2%nat)) in *.
  assert (Rounding.E 6 * (A + 3 * tau + (B + 3 * tau)) <= 6.0001 * u * (A + 3 * tau + (B + 3 * tau)))
    by (apply Rmult_le_compat_r; lra).
  rewrite Hu in *. lra.
Qed.
End Vectors.

(* ---- The ratio of areas ---- *)

Lemma root_of_square_forward : forall (s : double) k, (-500 <= k)%Z -> finite s -> 0 <= val s <= bpow radix2 (k + k) ->
  finite (Bsqrt mode_NE s) /\ val (Bsqrt mode_NE s) = rnd (sqrt (val s)) /\
  Rabs (val (Bsqrt mode_NE s)) <= bpow radix2 k.
Proof.
  intros s k K F [P B].
  assert (R : finite (Bsqrt mode_NE s)).
  { destruct (Rlt_le_dec 0 (val s)) as [L|L]; [apply (root_forward s F L)|].
    destruct s as [t|t| |t m e H]; try discriminate; [reflexivity|]. exfalso. unfold val in *. cbn in P, L.
    assert (Z : F2R (Float radix2 (SpecFloat.cond_Zopp t (Zpos m)) e) = 0) by lra. apply eq_0_F2R in Z.
    destruct t; discriminate. }
  destruct (root_back s R) as [_ E]. split; [exact R|]. split; [exact E|]. rewrite E. apply rnd_power; [lia|].
  rewrite Rabs_pos_eq by apply sqrt_pos. rewrite <- (sqrt_square (bpow radix2 k)) by apply bpow_ge_0.
  apply sqrt_le_1_alt. rewrite <- bpow_plus. exact B.
Qed.
Lemma rdot_nonneg : forall v, 0 <= rdot v v.
Proof.
  intro v. unfold rdot. apply rnd_nonneg, Rplus_le_le_0_compat; [apply rnd_nonneg, Rplus_le_le_0_compat|];
    apply rnd_nonneg, Rle_0_sqr.
Qed.

Definition area_error w := val (on_doubles w (in_roundoffs kAreaBound)).
Lemma area_error_same : forall z w, area_error z = area_error w.
Proof. intros z w. unfold area_error. reflexivity. Qed.
Lemma area_forward : forall z, (forall n, (n < 6)%nat -> finite (z n) /\ Rabs (val (z n)) <= bpow radix2 134) ->
  let v k := value_of_vector (fun n => val (z n)) k in
  finite (on_doubles z (area_at_corner 0 1)) /\ Rabs (val (on_doubles z (area_at_corner 0 1))) <= bpow radix2 275 /\
  val (on_doubles z (area_at_corner 0 1)) = area_there (area_error z) (v 0%nat) (v 1%nat).
Proof.
  intros z Hz v. set (top n := if (n <? 6)%nat then 134%Z else 5000%Z).
  assert (Hz' : forall n, in_doubles (top n) = true -> finite (z n) /\ Rabs (val (z n)) <= bpow radix2 (top n)).
  { intros n Hn. unfold top in *. destruct (Nat.ltb_spec n 6); [apply Hz; assumption | discriminate]. }
  set (c := flatten (Cross (Given 0) (Given 1))).
  destruct (forward z top (edot c c) 540 Hz' ltac:(vm_compute; reflexivity)) as [Fc [Ec [Bc _]]].
  destruct (forward z top (square 0) 270 Hz' ltac:(vm_compute; reflexivity)) as [F0 [E0 [B0 _]]].
  destruct (forward z top (square 1) 270 Hz' ltac:(vm_compute; reflexivity)) as [F1 [E1 [B1 _]]].
  rewrite <- Ec in Bc. rewrite <- E0 in B0. rewrite <- E1 in B1.
  assert (Ec' : val (on_doubles z (edot c c)) = rdot (rcross (v 0%nat) (v 1%nat)) (rcross (v 0%nat) (v 1%nat)))
    by exact Ec.
  assert (E0' : val (on_doubles z (square 0)) = rdot (v 0%nat) (v 0%nat)) by exact E0.
  assert (E1' : val (on_doubles z (square 1)) = rdot (v 1%nat) (v 1%nat)) by exact E1.
  assert (N : forall v, 0 <= rdot v v) by apply rdot_nonneg.
  destruct (root_of_square_forward _ 270 ltac:(lia) Fc) as [Gc [Vc Tc]].
  { rewrite Ec' in *. split; [apply N | rewrite Rabs_pos_eq in Bc by apply N; exact Bc]. }
  destruct (root_of_square_forward _ 135 ltac:(lia) F0) as [G0 [V0 T0]].
  { rewrite E0' in *. split; [apply N | rewrite Rabs_pos_eq in B0 by apply N; exact B0]. }
  destruct (root_of_square_forward _ 135 ltac:(lia) F1) as [G1 [V1 T1]].
  { rewrite E1' in *. split; [apply N | rewrite Rabs_pos_eq in B1 by apply N; exact B1]. }
  rewrite Ec' in Vc. rewrite E0' in V0. rewrite E1' in V1.
  set (s n := match n with 0%nat => Root (edot c c) | 1%nat => Root (square 0) | _ => Root (square 1) end).
  change (area_at_corner 0 1) with (replace s (Sub (Var 0) (Mul (Mul (in_roundoffs kAreaBound) (Var 1)) (Var 2)))).
  rewrite on_doubles_replace. set (t n := on_doubles z (s n)).
  destruct (forward t (fun n => match n with 0%nat => 270 | 1%nat | 2%nat => 135 | _ => 5000 end)%Z
    (Sub (Var 0) (Mul (Mul (in_roundoffs kAreaBound) (Var 1)) (Var 2))) 271) as [F [E [B _]]].
  - intros [|[|[|n]]] Hn; [exact (conj Gc Tc) | exact (conj G0 T0) | exact (conj G1 T1) | discriminate Hn].
  - vm_compute. reflexivity.
  - split; [exact F|]. rewrite E. split.
    + eapply Rle_trans; [exact B | apply bpow_le; lia].
    + unfold rounded. cbn [on_reals]. rewrite (constant_on_reals kAreaBound _ z) by reflexivity. fold (area_error z).
      change (val (t 0%nat)) with (val (Bsqrt mode_NE (on_doubles z (edot c c)))).
      change (val (t 1%nat)) with (val (Bsqrt mode_NE (on_doubles z (square 0)))).
      change (val (t 2%nat)) with (val (Bsqrt mode_NE (on_doubles z (square 1)))).
      rewrite Vc, V0, V1. reflexivity.
Qed.

Lemma ratio_is_right : forall w i j, let v k := value_of_vector (fun n => val (w n)) k in
  (forall n, (n < 3)%nat -> finite (w (3 * i + n)%nat)) -> (forall n, (n < 3)%nat -> finite (w (3 * j + n)%nat)) ->
  len (v i) <= bpow radix2 134 -> len (v j) <= bpow radix2 134 -> finite (on_doubles w (ratio_of_areas i j)) ->
  let here := area_here (area_error w) (v 1%nat) (v 2%nat) in let there := area_there (area_error w) (v i) (v j) in
  0 < there /\ rnd (there * there) <> 0 /\ val (on_doubles w (ratio_of_areas i j)) = area_ratio here there.
Proof.
  intros w i j v Fi Fj Li Lj F here there.
  destruct (coordinate_bound _ _ Li) as [I0 [I1 I2]]. destruct (coordinate_bound _ _ Lj) as [J0 [J1 J2]].
  assert (Fi0 := Fi 0%nat ltac:(lia)). assert (Fj0 := Fj 0%nat ltac:(lia)). rewrite !Nat.add_0_r in *.
  set (g n := match n with 0%nat => Var (3 * i) | 1%nat => Var (3 * i + 1) | 2%nat => Var (3 * i + 2)
    | 3%nat => Var (3 * j) | 4%nat => Var (3 * j + 1) | _ => Var (3 * j + 2) end).
  set (z n := on_doubles w (g n)).
  destruct (area_forward z) as [Ft [Bt Et]].
  { intros [|[|[|[|[|[|n]]]]]] Hn; [| | | | | | lia].
    - exact (conj Fi0 I0).
    - exact (conj (Fi 1%nat ltac:(lia)) I1).
    - exact (conj (Fi 2%nat ltac:(lia)) I2).
    - exact (conj Fj0 J0).
    - exact (conj (Fj 1%nat ltac:(lia)) J1).
    - exact (conj (Fj 2%nat ltac:(lia)) J2). }
  assert (A : on_doubles z (area_at_corner 0 1) = on_doubles w (area_at_corner i j)).
  { unfold z. rewrite <- on_doubles_replace. apply f_equal. reflexivity. }
  rewrite A in Ft, Bt, Et. rewrite (area_error_same z w) in Et.
  change (value_of_vector (fun n => val (z n)) 0) with (v i) in Et.
  change (value_of_vector (fun n => val (z n)) 1) with (v j) in Et. fold there in Et.
  unfold ratio_of_areas in F |- *.
  destruct (compare_doubles Less (on_doubles w (Cst 0 0)) (on_doubles w (area_at_corner i j))) eqn:H.
  - rewrite (choose_yes _ _ _ _ _ H) in F |- *. destruct (above_zero w _ H) as [_ P]. specialize (P Ft).
    rewrite Et in P. split; [exact P|].
    destruct (mul_term_forward w _ _ Ft Ft) as [Ftt Ett].
    { rewrite Rabs_mult. apply Rle_trans with (bpow radix2 275 * bpow radix2 275).
      - apply Rmult_le_compat; auto using Rabs_pos.
      - rewrite <- bpow_plus. apply bpow_le. lia. }
    destruct (div_parts w _ _ Ftt F) as [Fhh [N E]]. rewrite Ett, Et in N, E. split; [exact N|].
    destruct (mul_parts w _ _ Fhh) as [Fh [_ Ehh]]. rewrite Ehh in E. rewrite E. unfold area_ratio.
    assert (Eh : val (on_doubles w area_at_q) = here); [|rewrite Eh; reflexivity].
    destruct (add_parts w _ _ Fh) as [Fr [Fm E1]]. destruct (root_parts w _ Fr) as [Fc E2].
    destruct (mul_parts w _ _ Fm) as [Fm1 [Fr2 E3]]. destruct (mul_parts w _ _ Fm1) as [_ [Fr1 E4]].
    destruct (root_parts w _ Fr1) as [Fs1 E5]. destruct (root_parts w _ Fr2) as [Fs2 E6].
    destruct (square_back w 1 Fs1) as [_ E7]. destruct (square_back w 2 Fs2) as [_ E8].
    assert (Ec : val (on_doubles w (edot (flatten (Cross (Given 1) (Given 2))) (flatten (Cross (Given 1) (Given 2))))) =
      rdot (rcross (v 1%nat) (v 2%nat)) (rcross (v 1%nat) (v 2%nat))).
    { apply (backward w (edot (flatten (Cross (Given 1) (Given 2))) (flatten (Cross (Given 1) (Given 2)))));
        [reflexivity | exact Fc]. }
    unfold here, area_here, area_bound, area_at_q, rlength. cbv zeta. rewrite E1, E2, E3, E4, E5, E6, E7, E8, Ec.
    reflexivity.
  - exfalso. rewrite (choose_no _ _ _ _ _ H) in F. discriminate F.
Qed.

(* ---- Passages ---- *)

Lemma square_in_range_same : forall x w e f, on_doubles x e = on_doubles w f -> square_in_range x e ->
  square_in_range w f.
Proof. intros x w e f E [H1 H2]. unfold square_in_range. rewrite <- E. split; [exact H1 | exact H2]. Qed.

Section Passage.
Variables (pairs : list (nat * nat)) (y : nat -> double).
Variables (drop e next : term Vector) (angle : term Scalar) (size ratio : expr).
Let w n := on_doubles y (inputs pairs n).
Let x n := on_doubles y (passage pairs drop e next angle size ratio n).
Let X n := val (x n).
Let d k := value_of_vector (exact_inputs pairs y) k.
Let v k := value_of_vector (fun n => val (w n)) k.

Lemma seen_of_passage : square_in_range x seen_square_size -> square_in_range w (seen_square 1 2).
Proof.
  apply square_in_range_same. change (on_doubles x seen_square_size) with (on_doubles y (size_square pairs 1 2)).
  unfold size_square. apply on_doubles_replace.
Qed.
Lemma edge_of_passage : forall k, square_in_range w (square (S k)) ->
  vapprox 1 (v (S k)) (d (S k)) /\ / 10 ^ 26 <= len (d (S k)) <= 10 ^ 26.
Proof.
  intros k R. destruct (length_back pairs y k R) as [F [_ [B _]]]. split; [|exact B].
  apply (difference_back pairs y k F).
Qed.
Lemma part_of_passage : forall n e', passage pairs drop e next angle size ratio n = replace (inputs pairs) e' ->
  x n = on_doubles w e'.
Proof. intros n e' E. unfold x. rewrite E. apply on_doubles_replace. Qed.

Lemma inputs_of_passage : forall p0 p1 q k0 k1 dd L, d 1%nat = vsub q p0 -> d 2%nat = vsub q p1 ->
  (forall n, (6 <= n <= 23)%nat -> n <> 11%nat -> finite (x n)) -> square_in_range x seen_square_size ->
  len (D p0 p1 k0 k1) <= dd -> len (vsub (value_of_vector X 4) (D p0 p1 k0 k1)) <= 2.001 * u * dd ->
  let G := seen_from p0 p1 q in (dd <= 0.7072 * G /\ L = G) \/ L = G + dd -> L * L * (1 - 14 * u) <= X 16%nat ->
  way_inputs p0 p1 q k0 k1 (value_of_vector X 0) (value_of_vector X 2) (value_of_vector X 4) (X 9%nat) (X 10%nat) dd L
    (X 16%nat).
Proof.
  intros p0 p1 q k0 k1 dd L D1 D2 F R Drop Near G Length Square. apply seen_of_passage in R.
  destruct (seen_is_near pairs y R) as [[F1 V1] [[F2 V2] [HS [HG _]]]].
  change (value_of_vector (exact_inputs pairs y) 1) with (d 1%nat) in *.
  change (value_of_vector (exact_inputs pairs y) 2) with (d 2%nat) in *.
  change (value_of_vector (fun n => val (on_doubles y (inputs pairs n))) 1) with (v 1%nat) in *.
  change (value_of_vector (fun n => val (on_doubles y (inputs pairs n))) 2) with (v 2%nat) in *.
  assert (EG : seen_size (d 1%nat) (d 2%nat) = G) by (unfold G, seen_from; rewrite D1, D2; reflexivity).
  rewrite EG in HS, HG.
  assert (Sum := sum_below_seen_size (d 1%nat) (d 2%nat)). assert (Prod := product_below_seen_size (d 1%nat) (d 2%nat)).
  rewrite EG in Sum, Prod.
  assert (E9 : X 9%nat = rdot (v 1%nat) (v 2%nat)).
  { assert (F9 := F 9%nat ltac:(lia) ltac:(lia)). unfold X.
    rewrite (part_of_passage 9 (edot (given 1) (given 2)) eq_refl) in F9 |- *. apply (dot_parts w 1 2 F9). }
  assert (Eg : value_of_vector X 2 = radd (v 1%nat) (v 2%nat)).
  { assert (P : forall j, (j < 3)%nat -> X (6 + j)%nat = rnd (val (w (3 + j)%nat) + val (w (6 + j)%nat))).
    { intros j Hj. assert (Fj := F (6 + j)%nat ltac:(lia) ltac:(lia)). unfold X.
      assert (E : x (6 + j)%nat = on_doubles w (Add (Var (3 + j)) (Var (6 + j)))).
      { apply part_of_passage. destruct j as [|[|[|j]]]; [reflexivity | reflexivity | reflexivity | lia]. }
      rewrite E in Fj |- *. apply (add_parts w _ _ Fj). }
    assert (P0 := P 0%nat ltac:(lia)). assert (P1 := P 1%nat ltac:(lia)). assert (P2 := P 2%nat ltac:(lia)).
    cbn [Nat.add] in P0, P1, P2. unfold value_of_vector, radd. cbn [Nat.mul Nat.add]. rewrite P0, P1, P2. reflexivity. }
  split; try assumption.
  - repeat split; apply fmt_val.
  - rewrite Eg. replace (bisector_g p0 p1 q) with (vadd (d 1%nat) (d 2%nat))
      by (unfold bisector_g; rewrite D1, D2; reflexivity).
    eapply Rle_trans; [apply (sum_is_near _ _ _ _ F1 F2 V1 V2)|]. apply Rmult_le_compat_l; [generalize u_pos; lra|].
    exact Sum.
  - rewrite E9. unfold h. rewrite <- D1, <- D2. apply (angle_is_near _ _ _ _ _ V1 V2 (proj1 HG) Prod).
Qed.
End Passage.

Lemma height_needs : forall x, 5.02 * u <= val (on_doubles x (times_roundoff kHeightBound)).
Proof.
  intro x. destruct (header_times_roundoff kHeightBound (502 # 100) 1000 eq_refl x) as [_ [H _]].
  replace (Q2R (502 # 100)) with 5.02 in H by (unfold Q2R; cbn; lra). exact H.
Qed.
Lemma area_needs : forall x, 4.42 * u <= area_error x.
Proof.
  intro x. destruct (header_constant kAreaBound (442 # 100) 1000 eq_refl x) as [_ [H _]].
  replace (Q2R (442 # 100)) with 4.42 in H by (unfold Q2R; cbn; lra). exact H.
Qed.

(* The squared size of the way and the ratio of areas are not negative. *)
Lemma squared_positive : forall x e, not_negative (on_doubles x (squared e)).
Proof. intros x e. apply square_not_negative. Qed.
Lemma ratio_positive : forall x i j, not_negative (on_doubles x (ratio_of_areas i j)).
Proof.
  intros x i j. assert (N : not_negative (on_doubles x (Div (Mul area_at_q area_at_q) (Mul (area_at_corner i j)
    (area_at_corner i j))))) by (apply div_positive; apply square_not_negative).
  unfold ratio_of_areas.
  destruct (compare_doubles Less (on_doubles x (Cst 0 0)) (on_doubles x (area_at_corner i j))) eqn:H.
  - rewrite (choose_yes _ _ _ _ _ H). exact N.
  - rewrite (choose_no _ _ _ _ _ H). right. reflexivity.
Qed.

Lemma height_with_areas : forall (x w : nat -> double) i j a b t0 t1 e n L,
  let v k := value_of_vector (fun n => val (w n)) k in let X n := val (x n) in
  x 15%nat = on_doubles w (edot (given i) (given j)) -> x 17%nat = on_doubles w (ratio_of_areas i j) ->
  finite (x 15%nat) -> finite (x 17%nat) ->
  vapprox 1 (v 1%nat) a -> vapprox 1 (v 2%nat) b -> vapprox 1 (v i) t0 -> vapprox 1 (v j) t1 ->
  vapprox 1 (value_of_vector X 6) e -> vapprox 1 (value_of_vector X 7) n ->
  / 10 ^ 26 <= len e <= 10 ^ 26 -> / 10 ^ 26 <= len n <= 10 ^ 26 -> / 10 ^ 26 <= L <= 10 ^ 40 ->
  L <= 10 ^ 14 * len a -> L <= 10 ^ 14 * len b -> len e <= L -> len t0 <= L -> len t1 <= L ->
  L * L * (1 - 14 * u) <= X 16%nat -> height_value x <= 10 ^ 30 * (L * L) ->
  true_height t0 t1 (cross a b) (cross t0 t1) n e * (1 - 20 * u) <= height_value x.
Proof.
  intros x w i j a b t0 t1 e n L v X E15 E17 F15 F17 Va Vb V0 V1 Ve Vn Be Bn BL La Lb Le L0 L1 Square Top.
  rewrite E15 in F15. rewrite E17 in F17. destruct (dot_parts w i j F15) as [Fij Edot].
  assert (Big : forall k t, vapprox 1 (v k) t -> len t <= L -> len (v k) <= bpow radix2 134).
  { intros k t V Ht. assert (N := vapprox_len _ _ V). assert (T := len_from (v k) t).
    apply Rle_trans with (10 ^ 40 * 2).
    - generalize u_val. intro Hu. rewrite Hu in *. lra.
    - change (bpow radix2 134) with (IZR (2 ^ 134)). rewrite pow_IZR, <- mult_IZR. apply IZR_le, Z.leb_le. vm_compute.
      reflexivity. }
  destruct (ratio_is_right w i j (fun n Hn => proj1 (Fij n Hn)) (fun n Hn => proj2 (Fij n Hn)) (Big _ _ V0 L0)
    (Big _ _ V1 L1) F17) as [Positive [Square_positive Eratio]].
  fold (v i) (v j) (v 1%nat) (v 2%nat) in Positive, Square_positive, Eratio.
  unfold height_value in *. fold (X 15%nat) (X 16%nat) (X 17%nat) in *.
  assert (E15' : X 15%nat = rdot (v i) (v j)) by (unfold X; rewrite E15; exact Edot).
  assert (E17' : X 17%nat = area_ratio (area_here (area_error w) (v 1%nat) (v 2%nat))
    (area_there (area_error w) (v i) (v j))) by (unfold X; rewrite E17; exact Eratio).
  rewrite E15', E17' in *.
  apply (height_of_areas a b t0 t1 e n (v 1%nat) (v 2%nat) (v i) (v j) (value_of_vector X 6) (value_of_vector X 7) L
    (X 16%nat) (area_error w) _ Va Vb V0 V1 Ve Vn Be Bn (proj1 BL) La Lb Le L0 L1 Square (area_needs w) (height_needs x)
    Positive Square_positive Top).
Qed.

(* What step_across() knows of the direction before a facet. *)
Lemma direction_of_passage : forall pairs drop e next angle size ratio edge t y, known_on_doubles edge t y ->
  let x n := on_doubles y (passage pairs drop e next angle size ratio n) in
  (forall k, (k < 4)%nat -> finite (x k)) /\ known edge t (value_of_vector (fun n => val (x n)) 0) (val (x 3%nat)).
Proof.
  intros pairs drop e next angle size ratio edge t y [F K] x. split; [|exact K].
  intros [|[|[|[|k]]]] Hk; [| | | | lia]; apply F; lia.
Qed.

Lemma across_right : forall through u_x u_y u_z error is_known edge true_next (y : nat -> double),
  is_passage through u_x u_y u_z error is_known -> run y is_known = Some Positive ->
  (let x n := on_doubles y (through n) in run x Code.Behind.is_known = Some Positive ->
    (forall t, In t (Code.Behind.u_x :: Code.Behind.u_y :: Code.Behind.u_z :: Code.Behind.error :: nil) ->
      finite (on_doubles x t)) /\
    known edge true_next (V (val (on_doubles x Code.Behind.u_x)) (val (on_doubles x Code.Behind.u_y))
      (val (on_doubles x Code.Behind.u_z))) (val (on_doubles x Code.Behind.error))) ->
  (forall t, In t (u_x :: u_y :: u_z :: error :: nil) -> finite (on_doubles y t)) /\
  known edge true_next (V (val (on_doubles y u_x)) (val (on_doubles y u_y)) (val (on_doubles y u_z)))
    (val (on_doubles y error)).
Proof.
  intros through u_x u_y u_z error is_known edge true_next y [-> [-> [-> [-> ->]]]] Run H. rewrite run_replace in Run.
  rewrite !on_doubles_replace. destruct (H Run) as [F K]. split; [|exact K].
  intros t [<-|[<-|[<-|[<-|[]]]]]; rewrite on_doubles_replace; apply F; cbn; tauto.
Qed.
Lemma square_positive : forall w k, not_negative (on_doubles w (square k)).
Proof.
  intros w k. unfold square, edot. apply add_positive; [apply add_positive|]; apply square_not_negative.
Qed.
Lemma opposite_length : forall a, len (vscale (-1) a) = len a.
Proof. intro a. rewrite len_scale_any, Rabs_left by lra. ring. Qed.
