(* `circle_right`: where start_at_circle() of src/flow/kernels/direction.h says that a direction is known, it is, on
   doubles. The true direction is that from the middle of p0p1 to the centre of the circle through three points, of
   which p0p1 is no side. *)
From Coq Require Import Reals ZArith QArith Qreals Lra Lia Psatz Bool List.
From Flocq Require Import Core BinarySingleNaN.
From Flowcert Require Import algebra.Vector3 algebra.Crossing code.Expression code.generated.Constants
  filters.Rounding filters.RoundedVectors filters.Norms filters.Floors filters.Doubles filters.Terms filters.Filter
  filters.Directions filters.DirectionSigns filters.DirectionVectors filters.DirectionOfVector filters.DirectionStarts.
From Flowcert Require filters.Cells.
Import ListNotations.
Open Scope R_scope.

(* Vectors 1 and 2 lead from v0 to v1 and v2, and vectors 3 and 4 to v0 from the ends of the edge. *)
Definition circle_pairs := [(2, 3); (2, 4); (0, 2); (1, 2)]%nat.
Definition circle_inputs := inputs circle_pairs.
Definition normal_of_circle := ecross (given 1) (given 2).
Definition difference i := Sub (Mul (square 1) (Var (6 + i))) (Mul (square 2) (Var (3 + i))).
Definition arm := ecross (Triple (difference 0) (difference 1) (difference 2)) normal_of_circle.
Definition weighted i := Mul (edot normal_of_circle normal_of_circle) (Add (Var (9 + i)) (Var (12 + i))).
Definition circle_coordinate i := Add (weighted i) (part i arm).
Definition circle_bound := Mul (Mul (Mul (in_roundoffs kCircleStartBound) (square 1)) (square 2))
  (Add (Add (Add (norm 1) (norm 2)) (norm 3)) (norm 4)).
Definition on_circle n :=
  match n with
  | 0%nat | 1%nat | 2%nat => replace circle_inputs (circle_coordinate n)
  | 3%nat | 4%nat | 5%nat => between [(0, 1)]%nat (n - 3)
  | _ => replace circle_inputs circle_bound
  end.
Lemma circle_match :
  Code.StartAtCircle.u_x = replace on_circle Code.OfVector.u_x /\
  Code.StartAtCircle.u_y = replace on_circle Code.OfVector.u_y /\
  Code.StartAtCircle.u_z = replace on_circle Code.OfVector.u_z /\
  Code.StartAtCircle.error = replace on_circle Code.OfVector.error /\
  let aa := replace circle_inputs (square 1) in let bb := replace circle_inputs (square 2) in
  Code.StartAtCircle.is_known =
    If LessEqual low_square aa (If LessEqual aa high_square
      (If LessEqual low_square bb (If LessEqual bb high_square
        (replace_in_tree on_circle Code.OfVector.is_known)
      (Answer None)) (Answer None)) (Answer None)) (Answer None).
Proof. repeat split; vm_compute; reflexivity. Qed.

(* The vector that the code makes, without rounding: 2 |n|^2 times the way from the middle of p0p1 to the centre. *)
Definition circle_vector a b w := let n := cross a b in
  vadd (vscale (dot n n) w) (cross (vsub (vscale (dot a a) b) (vscale (dot b b) a)) n).
Definition way_to_circle p0 p1 v0 v1 v2 :=
  circle_vector (vsub v1 v0) (vsub v2 v0) (vadd (vsub v0 p0) (vsub v0 p1)).

(* The centre of the circle through v0, v1 and v2, and that it is one. *)
Definition centre_of_circle v0 v1 v2 :=
  let a := vsub v1 v0 in let b := vsub v2 v0 in let n := cross a b in
  vadd v0 (vscale (/ (2 * dot n n)) (cross (vsub (vscale (dot a a) b) (vscale (dot b b) a)) n)).
Lemma circle_arm : forall a b, let n := cross a b in
  let k := cross (vsub (vscale (dot a a) b) (vscale (dot b b) a)) n in
  dot k a = dot a a * dot n n /\ dot k b = dot b b * dot n n.
Proof. intros a b. clear. vdestruct. vunfold. split; ring. Qed.
Lemma centre_of_circle_right : forall v0 v1 v2, cross (vsub v1 v0) (vsub v2 v0) <> vzero ->
  let c := centre_of_circle v0 v1 v2 in dist2 c v0 = dist2 c v1 /\ dist2 c v0 = dist2 c v2.
Proof.
  intros v0 v1 v2 N c. apply dot_positive in N. unfold c, centre_of_circle.
  destruct (circle_arm (vsub v1 v0) (vsub v2 v0)) as [K1 K2]. revert N K1 K2.
  generalize (dot (cross (vsub v1 v0) (vsub v2 v0)) (cross (vsub v1 v0) (vsub v2 v0)))
    (cross (vsub (vscale (dot (vsub v1 v0) (vsub v1 v0)) (vsub v2 v0)) (vscale (dot (vsub v2 v0) (vsub v2 v0)) (vsub v1
      v0))) (cross (vsub v1 v0) (vsub v2 v0))). intros n k N K1 K2. clear c.
  assert (E : forall s v, dist2 (vadd v0 (vscale s k)) v0 - dist2 (vadd v0 (vscale s k)) v = 2 * s * dot k (vsub v v0) -
    dot (vsub v v0) (vsub v v0)) by (clear; intros; vdestruct; vunfold; ring).
  split; apply Rminus_diag_uniq; rewrite E, ?K1, ?K2; field; lra.
Qed.
Lemma way_to_circle_is_to_centre : forall p0 p1 v0 v1 v2, cross (vsub v1 v0) (vsub v2 v0) <> vzero ->
  way_to_circle p0 p1 v0 v1 v2 =
  vscale (2 * dot (cross (vsub v1 v0) (vsub v2 v0)) (cross (vsub v1 v0) (vsub v2 v0)))
    (vsub (centre_of_circle v0 v1 v2) (midpoint p0 p1)).
Proof.
  intros p0 p1 v0 v1 v2 N. apply dot_positive in N. unfold way_to_circle, circle_vector, centre_of_circle, midpoint.
  revert N. generalize (dot (cross (vsub v1 v0) (vsub v2 v0)) (cross (vsub v1 v0) (vsub v2 v0)))
    (cross (vsub (vscale (dot (vsub v1 v0) (vsub v1 v0)) (vsub v2 v0)) (vscale (dot (vsub v2 v0) (vsub v2 v0)) (vsub v1
      v0))) (cross (vsub v1 v0) (vsub v2 v0))). intros n k N. apply vec_eq; cbn; field; lra.
Qed.

(* ---- Roundings ---- *)

Lemma napprox_sub : forall e N M a b x y g, napprox e N a x -> napprox e M b y -> e + u * (1 + e) <= g ->
  napprox g (N + M) (rsub a b) (vsub x y).
Proof.
  intros e N M a b x y g [Fa Ea Xa Ca] [Fb Eb Xb _] Hg. generalize u_pos (len_nonneg x) (len_nonneg y). intros U0 Lx Ly.
  assert (D : len (vsub (vsub a b) (vsub x y)) <= e * (N + M)).
  { replace (vsub (vsub a b) (vsub x y)) with (vadd (vsub a x) (vscale (-1) (vsub b y))) by (apply vec_eq; cbn; ring).
    eapply Rle_trans; [apply len_triangle|]. rewrite len_scale_any. replace (Rabs (-1)) with 1 by (rewrite Rabs_left;
      lra). lra. }
  assert (S : len (vsub x y) <= N + M).
  { replace (vsub x y) with (vadd x (vscale (-1) y)) by (apply vec_eq; cbn; ring).
    eapply Rle_trans; [apply len_triangle|]. rewrite len_scale_any. replace (Rabs (-1)) with 1 by (rewrite Rabs_left;
      lra). lra. }
  assert (R := rsub_rounding a b Fa Fb). assert (L := len_from (vsub a b) (vsub x y)).
  assert (u * len (vsub a b) <= u * ((1 + e) * (N + M))) by (apply Rmult_le_compat_l; lra).
  assert (NM : 0 <= N + M) by lra.
  assert (G : (e + u * (1 + e)) * (N + M) <= g * (N + M)) by (apply Rmult_le_compat_r; assumption).
  split; [repeat split; apply fmt_rnd | | exact S |].
  - eapply Rle_trans; [apply (len_between _ (vsub a b))|]. lra.
  - assert (0 <= u * (1 + e)) by (apply Rmult_le_pos; lra). lra.
Qed.

Lemma circle_error : forall a b w va vb vw A B W, napprox u A va a -> napprox u B vb b -> napprox (2.0001 * u) W vw w ->
  / 10 ^ 26 <= A -> / 10 ^ 26 <= B -> / 10 ^ 43 <= W ->
  let n := rcross va vb in
  let y := radd (rscale (rdot n n) vw) (rcross (rsub (rscale (rdot va va) vb) (rscale (rdot vb vb) va)) n) in
  napprox (15.86 * u) (A * A * (B * B) * (A + B + W)) y (circle_vector a b w).
Proof.
  intros a b w va vb vw A B W Ha Hb Hw LA LB LW n y. generalize u_pos u_val. intros U0 Hu.
  assert (T : forall k z, (k <= 260)%nat -> / 10 ^ k <= z -> tau <= / 10 ^ 40 * z) by apply floor_tau.
  assert (AB := floor_mult 26 26 _ _ LA LB). assert (AA := floor_mult 26 26 _ _ LA LA).
  assert (BB := floor_mult 26 26 _ _ LB LB). assert (BA := floor_mult 26 26 _ _ LB LA). cbn [Nat.add] in *.
  assert (Hn := napprox_cross _ _ _ _ _ _ _ _ (4.4145 * u) Ha Hb (T 52%nat _ ltac:(lia) AB) ltac:(rewrite Hu; lra)).
  fold n in Hn.
  assert (Nn := floor_mult 52 52 _ _ AB AB). cbn [Nat.add] in Nn.
  assert (Snn := sapprox_dot _ _ _ _ _ _ _ _ (11.8295 * u) Hn Hn (T 104%nat _ ltac:(lia) Nn) ltac:(rewrite Hu; lra)).
  assert (NW := floor_mult 104 43 _ _ Nn LW). cbn [Nat.add] in NW.
  assert (H1 := napprox_scale _ _ _ _ _ _ _ _ (14.84 * u) Snn Hw (T 147%nat _ ltac:(lia) NW) ltac:(rewrite Hu; lra)).
  assert (Saa := sapprox_dot _ _ _ _ _ _ _ _ (5.0002 * u) Ha Ha (T 52%nat _ ltac:(lia) AA) ltac:(rewrite Hu; lra)).
  assert (Sbb := sapprox_dot _ _ _ _ _ _ _ _ (5.0002 * u) Hb Hb (T 52%nat _ ltac:(lia) BB) ltac:(rewrite Hu; lra)).
  assert (AAB := floor_mult 52 26 _ _ AA LB). assert (BBA := floor_mult 52 26 _ _ BB LA). cbn [Nat.add] in AAB, BBA.
  assert (Q1 := napprox_scale _ _ _ _ _ _ _ _ (7.0003 * u) Saa Hb (T 78%nat _ ltac:(lia) AAB) ltac:(rewrite Hu; lra)).
  assert (Q2 := napprox_scale _ _ _ _ _ _ _ _ (7.0003 * u) Sbb Ha (T 78%nat _ ltac:(lia) BBA) ltac:(rewrite Hu; lra)).
  assert (Q := napprox_sub _ _ _ _ _ _ _ (8.0004 * u) Q1 Q2 ltac:(rewrite Hu; lra)).
  assert (P78 : 0 < / 10 ^ 78) by (apply Rinv_0_lt_compat, pow_lt; lra).
  assert (QS : / 10 ^ 78 <= A * A * B + B * B * A) by lra.
  assert (QN := floor_mult 78 52 _ _ QS AB). cbn [Nat.add] in QN.
  assert (H2 := napprox_cross _ _ _ _ _ _ _ _ (14.84 * u) Q Hn (T 130%nat _ ltac:(lia) QN) ltac:(rewrite Hu; lra)).
  assert (H := napprox_add _ _ _ _ _ _ _ (15.86 * u) H1 H2 ltac:(rewrite Hu; lra)).
  replace (A * A * (B * B) * (A + B + W)) with (A * B * (A * B) * W + (A * A * B + B * B * A) * (A * B)) by ring.
  exact H.
Qed.

Lemma circle_covers : forall c aa bb na nb n3 n4 A B l3 l4, 24 * u <= c <= 1000 * u ->
  / 10 ^ 26 <= A -> / 10 ^ 26 <= B -> 0 <= l3 -> 0 <= l4 -> A * A * (1 - 5.001 * u) <= aa -> B * B * (1 - 5.001 * u) <=
    bb
  -> A * (1 - 3.51 * u) <= na -> B * (1 - 3.51 * u) <= nb -> l3 * (1 - 3.7 * u) - / 10 ^ 99 <= n3 ->
  l4 * (1 - 3.7 * u) - / 10 ^ 99 <= n4 -> fmt na -> fmt nb -> fmt n3 -> fmt n4 -> 0 <= n3 -> 0 <= n4 ->
  let T := A * A * (B * B) * (A + B + l3 + l4) in
  c * T * (1 - 30 * u) <= rnd (rnd (rnd (c * aa) * bb) * rnd (rnd (rnd (na + nb) + n3) + n4)) /\ / 10 ^ 130 <= T.
Proof.
  intros c aa bb na nb n3 n4 A B l3 l4 Hc HA HB L3 L4 Haa Hbb Hna Hnb H3 H4 Fa Fb F3 F4 N3 N4 T.
  generalize u_pos u_val tau_small. intros U0 Hu Tau.
  assert (P : forall k, 0 < / 10 ^ k) by (intro; apply Rinv_0_lt_compat, pow_lt; lra).
  assert (P26 := P 26%nat). assert (P99 := P 99%nat). assert (P52 := P 52%nat). assert (P104 := P 104%nat).
  assert (AA := floor_mult 26 26 _ _ HA HA). assert (BB := floor_mult 26 26 _ _ HB HB).
  assert (AABB := floor_mult 52 52 _ _ AA BB). cbn [Nat.add] in *.
  assert (Tq : forall k z, (k <= 290)%nat -> / 10 ^ k <= z -> tau <= z).
  { intros k z A1 A2. eapply Rle_trans; [exact Tau|]. eapply Rle_trans; [|exact A2]. apply Rinv_le; [apply pow_lt; lra |
      apply Rle_pow; [lra | lia]]. }
  set (Z := A + B + l3 + l4). assert (Z0 : / 10 ^ 26 <= Z) by (unfold Z; lra).
  assert (TT : / 10 ^ 130 <= T) by (apply (floor_mult 104 26); [exact AABB | exact Z0]).
  split; [|exact TT].
  set (v := 1 - 5.001 * u) in *. assert (V : 0.99 <= v <= 1) by (unfold v; rewrite Hu; lra).
  assert (c0 : / 10 ^ 15 <= c) by (rewrite Hu in *; lra). assert (P15 := P 15%nat).
  assert (A1 : c * (A * A * v) <= c * aa) by (apply Rmult_le_compat_l; lra).
  assert (G1 : / 10 ^ 68 <= c * (A * A * v)).
  { apply Rle_trans with (/ 10 ^ 15 * (/ 10 ^ 52 * 0.99)); [lra|].
    apply Rmult_le_compat; [lra | lra | exact c0 | apply Rmult_le_compat; lra]. }
  assert (B1 := rnd_lower _ _ (Tq 68%nat _ ltac:(lia) G1) A1). assert (P68 := P 68%nat).
  set (q := 1 - 2 * u) in *. assert (Q : 0.99 <= q <= 1) by (unfold q; rewrite Hu; lra).
  assert (A2 : c * (A * A * v) * q * (B * B * v) <= rnd (c * aa) * bb).
  { apply Rmult_le_compat; [apply Rmult_le_pos; lra | apply Rmult_le_pos; lra | exact B1 | exact Hbb]. }
  assert (G2 : / 10 ^ 121 <= c * (A * A * v) * q * (B * B * v)).
  { apply Rle_trans with (/ 10 ^ 68 * 0.99 * (/ 10 ^ 52 * 0.99)); [lra|].
    apply Rmult_le_compat; [lra | lra | apply Rmult_le_compat; lra | apply Rmult_le_compat; lra]. }
  assert (B2 := rnd_lower _ _ (Tq 121%nat _ ltac:(lia) G2) A2). fold q in B2. assert (P121 := P 121%nat).
  (* the sum *)
  assert (Add1 : forall a b, fmt a -> fmt b -> 0 <= a -> 0 <= b -> (a + b) * (1 - u) <= rnd (a + b) /\ 0 <= rnd (a +
    b)).
  { intros a b Xa Xb Pa Pb. assert (R := rnd_plus a b Xa Xb). rewrite (Rabs_pos_eq (a + b)) in R by lra.
    apply Rabs_le_inv in R. assert (0 <= (a + b) * (1 - u)) by (apply Rmult_le_pos; rewrite ?Hu; lra). lra. }
  assert (na0 : 0 <= na) by (rewrite Hu in *; lra). assert (nb0 : 0 <= nb) by (rewrite Hu in *; lra).
  destruct (Add1 na nb Fa Fb na0 nb0) as [S1 S1p]. set (s1 := rnd (na + nb)) in *.
  destruct (Add1 s1 n3 (fmt_rnd _) F3 S1p N3) as [S2 S2p]. set (s2 := rnd (s1 + n3)) in *.
  destruct (Add1 s2 n4 (fmt_rnd _) F4 S2p N4) as [S3 S3p]. set (s3 := rnd (s2 + n4)) in *.
  assert (Sum : Z * (1 - 6.8 * u) <= s3).
  { assert (0 <= u * l3) by (apply Rmult_le_pos; lra). assert (0 <= u * l4) by (apply Rmult_le_pos; lra).
    assert (0 < u * A) by (apply Rmult_lt_0_compat; lra). assert (0 < u * B) by (apply Rmult_lt_0_compat; lra).
    assert (Raw : Z * (1 - 3.71 * u) <= na + nb + n3 + n4).
    { unfold Z. assert (2 * / 10 ^ 99 <= 0.01 * u * / 10 ^ 26) by (rewrite Hu; lra).
      assert (0.01 * u * / 10 ^ 26 <= 0.01 * u * A) by (apply Rmult_le_compat_l; lra). lra. }
    assert (C : (na + nb + n3 + n4) * (1 - 3 * u) <= s3).
    { rewrite Hu in *. lra. }
    assert (Z * (1 - 3.71 * u) * (1 - 3 * u) <= (na + nb + n3 + n4) * (1 - 3 * u)) by (apply Rmult_le_compat_r; [rewrite
      Hu; lra | exact Raw]). rewrite Hu in *. lra. }
  set (m := 1 - 6.8 * u) in *. assert (Hm : 0.99 <= m <= 1) by (unfold m; rewrite Hu; lra).
  assert (A3 : c * (A * A * v) * q * (B * B * v) * q * (Z * m) <= rnd (rnd (c * aa) * bb) * s3).
  { apply Rmult_le_compat; [apply Rmult_le_pos; lra | apply Rmult_le_pos; lra | exact B2 | exact Sum]. }
  assert (G3 : / 10 ^ 148 <= c * (A * A * v) * q * (B * B * v) * q * (Z * m)).
  { apply Rle_trans with (/ 10 ^ 121 * 0.99 * (/ 10 ^ 26 * 0.99)); [lra|].
    apply Rmult_le_compat; [lra | lra | apply Rmult_le_compat; lra | apply Rmult_le_compat; lra]. }
  eapply Rle_trans; [|exact (rnd_lower _ _ (Tq 148%nat _ ltac:(lia) G3) A3)]. fold q.
  replace (c * (A * A * v) * q * (B * B * v) * q * (Z * m) * q) with (c * T * (v * v * (q * q * q) * m))
    by (unfold T, Z; ring).
  apply Rmult_le_compat_l; [apply Rmult_le_pos; [lra|]; generalize (P 130%nat); lra|].
  unfold v, q, m. rewrite Hu. lra.
Qed.

Definition circle_needs : Q := 24 # 1.

(* The bound, backwards. *)
Lemma bound_back : forall c s1 s2 n1 n2 n3 n4 : double,
  let bound := Bmult mode_NE (Bmult mode_NE (Bmult mode_NE c s1) s2) (Bplus mode_NE (Bplus mode_NE (Bplus mode_NE n1 n2)
    n3) n4) in finite bound -> (finite n1 /\ finite n2 /\ finite n3 /\ finite n4) /\
  val bound = rnd (rnd (rnd (val c * val s1) * val s2) * rnd (rnd (rnd (val n1 + val n2) + val n3) + val n4)).
Proof.
  intros c s1 s2 n1 n2 n3 n4 bound F. unfold bound in *.
  destruct (mul_back _ _ F) as [G1 [G2 E]]. destruct (mul_back _ _ G1) as [G3 [_ E1]].
  destruct (mul_back _ _ G3) as [_ [_ E2]]. destruct (add_back _ _ G2) as [G4 [F4 E3]].
  destruct (add_back _ _ G4) as [G5 [F3 E4]]. destruct (add_back _ _ G5) as [F1 [F2 E5]].
  split; [repeat split; assumption|]. rewrite E, E1, E2, E3, E4, E5. reflexivity.
Qed.

Lemma long_of_range : forall s L, 0 <= L -> 0.999 / 10 ^ 50 <= s ->
  Rabs (s - L * L) <= Rounding.E 5 * (L * L + 3 * tau) -> 9 / 10 ^ 26 <= L.
Proof.
  intros s L L0 Hs H. generalize u_pos u_val tau_pos tau_small. intros U0 Hu T0 Tau.
  assert (T : tau <= / 10 ^ 60) by (eapply Rle_trans; [exact Tau|]; apply Rinv_le; [apply pow_lt; lra | apply Rle_pow;
    [lra | lia]]).
  assert (E5 : 0 <= Rounding.E 5 <= 5.0001 * u) by (split; [apply E_nonneg | unfold Rounding.E; rewrite Hu; simpl;
    lra]).
  assert (LL := Rle_0_sqr L). unfold Rsqr in LL.
  assert (Rounding.E 5 * (L * L + 3 * tau) <= 5.0001 * u * (L * L + 3 * tau)) by (apply Rmult_le_compat_r; lra).
  apply Rabs_le_inv in H. apply Rnot_lt_le. intro N.
  assert (L * L <= 9 / 10 ^ 26 * (9 / 10 ^ 26)) by (apply Rmult_le_compat; lra). rewrite Hu in *. lra.
Qed.

Section Circle.
Variable x : nat -> double.
Let w n := on_doubles x (circle_inputs n).
Let z n := on_doubles x (on_circle n).
Let d k := value_of_vector (exact_inputs circle_pairs x) k.
Let v k := value_of_vector (fun n => val (w n)) k.

(* A vector whose norm is finite. *)
Lemma circle_vector_back : forall k, finite (on_doubles w (norm (S k))) ->
  fmt3 (v (S k)) /\ vapprox 1 (v (S k)) (d (S k)) /\ 0 <= val (on_doubles w (norm (S k))) /\
  len (d (S k)) * (1 - 3.7 * u) - / 10 ^ 99 <= val (on_doubles w (norm (S k))) /\
  val (on_doubles w (norm (S k))) = rnd (sqrt (val (on_doubles w (square (S k))))) /\
  Rabs (val (on_doubles w (square (S k))) - len (d (S k)) * len (d (S k))) <= Rounding.E 5 * (len (d (S k)) * len (d (S
    k)) + 3 * tau).
Proof.
  intros k F. destruct (root_back (on_doubles w (square (S k))) F) as [F2 E2].
  destruct (difference_back circle_pairs x k F2) as [_ [M0 [A0 E0]]].
  assert (M : fmt3 (v (S k))) by exact M0. assert (A : vapprox 1 (v (S k)) (d (S k))) by exact A0. clear M0 A0.
  assert (E : val (on_doubles w (square (S k))) = rdot (v (S k)) (v (S k))) by exact E0. clear E0.
  assert (En : val (on_doubles w (norm (S k))) = rlength (v (S k))) by (unfold rlength; rewrite <- E; exact E2).
  generalize u_pos u_val (len_nonneg (d (S k))) (len_nonneg (v (S k))). intros U0 Hu D0 V0.
  assert (N := vapprox_len _ _ A). assert (B1 := len_from (d (S k)) (v (S k))). rewrite len_sub_sym in B1.
  assert (L := rlength_lower (v (S k)) M). rewrite <- En in L.
  assert (P99 : / 10 ^ 100 <= / 10 ^ 99) by (apply Rinv_le; [apply pow_lt; lra | apply Rle_pow; [lra | lia]]).
  split; [exact M|]. split; [exact A|]. split; [|split; [|split; [exact E2|]]].
  - rewrite En. unfold rlength, rnd. apply round_ge_generic; auto with typeclass_instances; [apply generic_format_0 |
      apply sqrt_pos].
  - assert (len (d (S k)) * (1 - u) * (1 - 2.6 * u) <= len (v (S k)) * (1 - 2.6 * u)) by (apply Rmult_le_compat_r;
      rewrite ?Hu in *; lra). rewrite Hu in *. lra.
  - rewrite E. destruct (rdot_approx 1 1 _ _ _ _ A A) as [_ P _]. rewrite absdot_self, <- len_sq in P. exact P.
Qed.

Lemma square_lower : forall s L, / 10 ^ 26 <= L -> Rabs (s - L * L) <= Rounding.E 5 * (L * L + 3 * tau) ->
  L * L * (1 - 5.001 * u) <= s.
Proof.
  intros s L HL H. generalize u_pos u_val tau_pos. intros U0 Hu T0.
  assert (LL : / 10 ^ 52 <= L * L) by (apply (floor_mult 26 26); exact HL).
  assert (T := tau_below (L * L) ltac:(eapply Rle_trans; [|exact LL]; apply Rinv_le; [apply pow_lt; lra | apply Rle_pow;
    [lra | lia]])).
  assert (P52 : 0 < / 10 ^ 52) by (apply Rinv_0_lt_compat, pow_lt; lra).
  assert (E5 : 0 <= Rounding.E 5 <= 5.0001 * u) by (split; [apply E_nonneg | unfold Rounding.E; rewrite Hu; simpl;
    lra]).
  assert (Rounding.E 5 * (L * L + 3 * tau) <= 5.0001 * u * (L * L + 3 * tau)) by (apply Rmult_le_compat_r; lra).
  apply Rabs_le_inv in H. rewrite Hu in *. lra.
Qed.

Theorem circle_start_is_good :
  let p k := point x k in let e := vsub (p 1%nat) (p 0%nat) in
  let y := way_to_circle (p 0%nat) (p 1%nat) (p 2%nat) (p 3%nat) (p 4%nat) in
  dot y e = 0 -> square_in_range w (square 1) -> square_in_range w (square 2) -> good_start e y z.
Proof.
  intros p e y Ye R1 R2. generalize u_pos u_val. intros U0 Hu.
  assert (EW : forall t, on_doubles x (replace circle_inputs t) = on_doubles w t) by (intro; apply on_doubles_replace).
  assert (SN : forall k, not_negative (on_doubles w (square k))).
  { intro k. unfold square. cbn [on_doubles edot given tx ty tz].
    apply Cells.add_not_negative; [apply Cells.add_not_negative|]; apply square_not_negative. }
  split; [exact Ye | | |].
  - intro F. apply vapprox_len. assert (S : forall i, (i < 3)%nat -> approx 1 (Rabs (val (x (3 + i)%nat) - val (x i)))
      (val (z (3 + i)%nat)) (val (x (3 + i)%nat) - val (x i))).
    { intros i Hi. assert (E : z (3 + i)%nat = Bminus mode_NE (x (3 + i)%nat) (x i)).
      { destruct i as [|[|[|i]]]; try reflexivity. lia. }
      assert (Fi := F i Hi). rewrite E in Fi |- *. destruct (sub_back _ _ Fi) as [_ [_ V]]. rewrite V.
      apply approx_difference; apply fmt_val. }
    exact (conj (S 0%nat ltac:(lia)) (conj (S 1%nat ltac:(lia)) (S 2%nat ltac:(lia)))).
  - unfold z, on_circle. rewrite EW. unfold circle_bound. cbn [on_doubles].
    apply Cells.mul_not_negative; [apply Cells.mul_not_negative; [apply Cells.mul_not_negative|]|].
    + apply (Cells.positive_not_negative (fun _ => B754_zero false) (in_roundoffs kCircleStartBound)); [|reflexivity].
      intro k. right. reflexivity.
    + apply SN.
    + apply SN.
    + apply Cells.add_not_negative; [apply Cells.add_not_negative; [apply Cells.add_not_negative|]|];
        apply norm_not_negative.
  - intros Fb Fy. assert (E6 : z 6%nat = on_doubles w circle_bound) by apply EW. rewrite E6 in Fb |- *.
    destruct (bound_back (on_doubles w (in_roundoffs kCircleStartBound)) (on_doubles w (square 1)) (on_doubles w (square
      2)) (on_doubles w (norm 1)) (on_doubles w (norm 2)) (on_doubles w (norm 3)) (on_doubles w (norm 4)) Fb)
      as [[F1 [F2 [F3 F4]]] Eb'].
    change (Bmult mode_NE (Bmult mode_NE (Bmult mode_NE (on_doubles w (in_roundoffs kCircleStartBound)) (on_doubles w
      (square 1))) (on_doubles w (square 2))) (Bplus mode_NE (Bplus mode_NE (Bplus mode_NE (on_doubles w (norm 1))
      (on_doubles w (norm 2))) (on_doubles w (norm 3))) (on_doubles w (norm 4)))) with (on_doubles w circle_bound) in
        Eb'.
    destruct (circle_vector_back 0 F1) as [M1 [A1 [_ [_ [N1 S1]]]]].
    destruct (circle_vector_back 1 F2) as [M2 [A2 [_ [_ [N2 S2]]]]].
    destruct (circle_vector_back 2 F3) as [M3 [A3 [P3 [L3 _]]]].
    destruct (circle_vector_back 3 F4) as [M4 [A4 [P4 [L4 _]]]].
    destruct (length_back circle_pairs x 0 R1) as [_ [_ [H1 [L1 _]]]].
    destruct (length_back circle_pairs x 1 R2) as [_ [_ [H2 [L2 _]]]].
    change (value_of_vector (exact_inputs circle_pairs x) 1) with (d 1%nat) in *.
    change (value_of_vector (exact_inputs circle_pairs x) 2) with (d 2%nat) in *.
    change (len (d 1%nat) * (1 - 3.51 * u) <= rnd (sqrt (val (on_doubles w (square 1))))) in L1.
    change (len (d 2%nat) * (1 - 3.51 * u) <= rnd (sqrt (val (on_doubles w (square 2))))) in L2.
    rewrite <- N1 in L1. rewrite <- N2 in L2.
    destruct (header_constant kCircleStartBound circle_needs 1000 eq_refl w) as [_ Hc].
    replace (Q2R circle_needs) with 24 in Hc by (unfold Q2R; cbn; lra).
    replace (Q2R 1000) with 1000 in Hc by (unfold Q2R; cbn; lra).
    set (c := val (on_doubles w (in_roundoffs kCircleStartBound))) in *.
    destruct (circle_covers c _ _ _ _ _ _ _ _ _ _ Hc (proj1 H1) (proj1 H2) (len_nonneg (d 3%nat)) (len_nonneg (d 4%nat))
      (square_lower _ _ (proj1 H1) S1) (square_lower _ _ (proj1 H2) S2) L1 L2 L3 L4 (fmt_val _) (fmt_val _) (fmt_val _)
      (fmt_val _) P3 P4) as [Cover Positive_size].
    rewrite <- Eb' in Cover.
    (* the vector *)
    set (Yc := radd (rscale (rdot (rcross (v 1%nat) (v 2%nat)) (rcross (v 1%nat) (v 2%nat))) (radd (v 3%nat) (v 4%nat)))
      (rcross (rsub (rscale (rdot (v 1%nat) (v 1%nat)) (v 2%nat)) (rscale (rdot (v 2%nat) (v 2%nat)) (v 1%nat)))
        (rcross (v 1%nat) (v 2%nat)))).
    assert (EY : value_of_vector (fun n => val (z n)) 0 = Yc).
    { assert (C : forall i, (i < 3)%nat -> val (z i) = rounded (fun n => val (w n)) (circle_coordinate i)).
      { intros i Hi. assert (E : z i = on_doubles w (circle_coordinate i)).
        { rewrite <- EW. destruct i as [|[|[|i]]]; [reflexivity | reflexivity | reflexivity | lia]. }
        assert (Fi := Fy i Hi). rewrite E in Fi |- *. apply (backward w (circle_coordinate i)); [|exact Fi].
        destruct i as [|[|[|i]]]; [reflexivity | reflexivity | reflexivity | lia]. }
      unfold value_of_vector. cbn [Nat.mul Nat.add]. rewrite !C by lia. reflexivity. }
    rewrite EY.
    assert (P43 : 0 < / 10 ^ 43) by (apply Rinv_0_lt_compat, pow_lt; lra).
    assert (Near : forall k m, fmt3 (v k) -> vapprox 1 (v k) (d k) -> len (d k) <= m -> napprox u m (v k) (d k)).
    { intros k m F A B. split; [exact F | | exact B | lra]. eapply Rle_trans; [apply vapprox_len, A|].
      apply Rmult_le_compat_l; lra. }
    set (l3 := len (d 3%nat)) in *. set (l4 := len (d 4%nat)) in *.
    assert (Hw := napprox_add _ _ _ _ _ _ _ (2.0001 * u) (Near 3%nat (l3 + / 10 ^ 43) M3 A3 ltac:(unfold l3; lra))
      (Near 4%nat (l4 + / 10 ^ 43) M4 A4 ltac:(unfold l4; lra)) ltac:(rewrite Hu; lra)).
    assert (l30 : 0 <= l3) by apply len_nonneg. assert (l40 : 0 <= l4) by apply len_nonneg.
    assert (Er := circle_error _ _ _ _ _ _ _ _ _ (Near 1%nat _ M1 A1 (Rle_refl _)) (Near 2%nat _ M2 A2 (Rle_refl _)) Hw
      (proj1 H1) (proj1 H2) ltac:(lra)). cbv zeta in Er. fold Yc in Er.
    change (circle_vector (d 1%nat) (d 2%nat) (vadd (d 3%nat) (d 4%nat))) with y in Er.
    destruct Er as [_ Error Size _].
    set (A := len (d 1%nat)) in *. set (B := len (d 2%nat)) in *.
    set (T := A * A * (B * B) * (A + B + l3 + l4)) in *. cbv zeta in Positive_size. fold T in Positive_size.
    assert (P26 : 0 < / 10 ^ 26) by (apply Rinv_0_lt_compat, pow_lt; lra).
    assert (P130 : 0 < / 10 ^ 130) by (apply Rinv_0_lt_compat, pow_lt; lra).
    assert (Sizes : A * A * (B * B) * (A + B + (l3 + / 10 ^ 43 + (l4 + / 10 ^ 43))) <= T * (1 + u)).
    { unfold T. rewrite (Rmult_assoc (A * A * (B * B))). apply Rmult_le_compat_l.
      - apply Rmult_le_pos; apply Rle_0_sqr.
      - assert (2 * / 10 ^ 43 <= u * / 10 ^ 26) by (rewrite Hu; lra).
        assert (u * / 10 ^ 26 <= u * (A + B + l3 + l4)) by (apply Rmult_le_compat_l; lra). lra. }
    assert (Error' : len (vsub Yc y) <= 15.86 * u * (T * (1 + u))).
    { eapply Rle_trans; [exact Error|]. apply Rmult_le_compat_l; [lra | exact Sizes]. }
    assert (LY : len Yc <= T * (1 + 20 * u)).
    { eapply Rle_trans; [apply (len_from Yc y)|]. rewrite Hu in *. lra. }
    assert (Low : 23.99 * u * T <= val (on_doubles w circle_bound)).
    { eapply Rle_trans; [|exact Cover].
      assert (24 * u * (T * (1 - 30 * u)) <= c * (T * (1 - 30 * u))) by (apply Rmult_le_compat_r; [apply Rmult_le_pos;
        rewrite ?Hu; lra | lra]). rewrite Hu in *. lra. }
    assert (uL : 8 * u * len Yc <= 8 * u * (T * (1 + 20 * u))) by (apply Rmult_le_compat_l; lra).
    assert (uL2 : 20 * u * len Yc <= 20 * u * (T * (1 + 20 * u))) by (apply Rmult_le_compat_l; lra).
    split; [|split].
    + eapply Rle_trans; [|exact Low]. rewrite Hu in *. lra.
    + eapply Rle_trans; [|exact Low]. rewrite Hu in *. lra.
    + assert (A9 := long_of_range _ _ (len_nonneg _) (proj1 (proj2 (square_range_back w _ R1))) S1).
      assert (B9 := long_of_range _ _ (len_nonneg _) (proj1 (proj2 (square_range_back w _ R2))) S2). fold A in A9. fold
        B in
      B9. assert (N9 : 0 < 9 / 10 ^ 26) by lra.
      assert (Large : 9 / 10 ^ 26 * (9 / 10 ^ 26) * (9 / 10 ^ 26 * (9 / 10 ^ 26)) * (18 / 10 ^ 26) <= T).
      { unfold T. apply Rmult_le_compat; [|lra | | lra].
        - apply Rmult_le_pos; apply Rmult_le_pos; lra.
        - apply Rmult_le_compat; [apply Rmult_le_pos; lra | apply Rmult_le_pos; lra | apply Rmult_le_compat; lra | apply
            Rmult_le_compat; lra]. }
      eapply Rle_trans; [|exact Low].
      eapply Rle_trans; [|apply Rmult_le_compat_l; [lra | exact Large]]. rewrite Hu. lra.
Qed.
End Circle.

(* p0p1 is the facet's edge, and v0, v1 and v2 are the three points. *)
Theorem circle_right : forall x,
  let p k := point x k in let e := vsub (p 1%nat) (p 0%nat) in
  let y := way_to_circle (p 0%nat) (p 1%nat) (p 2%nat) (p 3%nat) (p 4%nat) in
  dot y e = 0 -> run x Code.StartAtCircle.is_known = Some Positive ->
  (forall t, In t [Code.StartAtCircle.u_x; Code.StartAtCircle.u_y; Code.StartAtCircle.u_z; Code.StartAtCircle.error] ->
    finite (on_doubles x t)) /\
  known e y (V (val (on_doubles x Code.StartAtCircle.u_x)) (val (on_doubles x Code.StartAtCircle.u_y))
    (val (on_doubles x Code.StartAtCircle.u_z))) (val (on_doubles x Code.StartAtCircle.error)).
Proof.
  intros x p e y Ye H. destruct circle_match as [T1 [T2 [T3 [T4 Known]]]]. cbv zeta in Known. rewrite Known in H.
  cbn [run] in H.
  lazymatch type of H with (if ?test then _ else _) = _ => destruct test eqn:HL; [|discriminate] end.
  lazymatch type of H with (if ?test then _ else _) = _ => destruct test eqn:HH; [|discriminate] end.
  lazymatch type of H with (if ?test then _ else _) = _ => destruct test eqn:HL2; [|discriminate] end.
  lazymatch type of H with (if ?test then _ else _) = _ => destruct test eqn:HH2; [|discriminate] end.
  rewrite run_replace in H. rewrite on_doubles_replace in HL, HH, HL2, HH2.
  destruct (of_vector_right e y _ (circle_start_is_good x Ye (conj HL HH) (conj HL2 HH2)) H) as [F K].
  rewrite <- !on_doubles_replace in K. rewrite T1, T2, T3, T4. split; [|exact K].
  intros t [<-|[<-|[<-|[<-|[]]]]]; rewrite on_doubles_replace; apply F; cbn; tauto.
Qed.
