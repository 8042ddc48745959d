(* What is known of a cascade's direction (src/flow/cascades.md), and how far a linear form in it is from that in the
   true direction. The true direction is any vector y in the plane of the facet, the plane orthogonal to its edge e:
   only its ray counts. What is known is a vector U, and a bound t on the tangent of the angle between y and the part
   of U in the plane. *)
From Coq Require Import Reals ZArith QArith Qreals Lra Lia Psatz Bool.
From Flocq Require Import Core BinarySingleNaN.
From Flowcert Require Import algebra.Vector3 code.Expression code.generated.Constants filters.Rounding
  filters.RoundedVectors filters.Norms
  filters.Floors filters.Doubles filters.Terms filters.Filter.
Open Scope R_scope.

(* ---- What is known ---- *)

(* The part of U in the plane orthogonal to e. *)
Definition in_plane e U := vsub U (vscale (dot U e / dot e e) e).

(* The angle between P and y is less than a right one, and its tangent is at most t. *)
Definition tangent_at_most t y P := 0 < dot P y /\ len (cross P y) <= t * dot P y.

Record known (e y U : vec) (t : R) : Prop := Known {
  in_facet : dot y e = 0;
  is_short : len U <= 1 + 16 * u;
  leaves_plane : Rabs (dot U e) <= 12 * u * (len U * len e);
  angle_is_small : tangent_at_most t y (in_plane e U);
  error_is_small : 4 * u <= t <= 3 / 32 }.
Lemma error_not_negative : forall e y U t, known e y U t -> 0 <= t <= 3 / 32.
Proof. intros e y U t K. generalize (error_is_small _ _ _ _ K) u_pos. lra. Qed.

(* ---- Linear forms ---- *)

Lemma len_zero : forall v, len v = 0 -> v = vzero.
Proof. intros v H. apply dot_self_zero. rewrite <- len_sq, H. ring. Qed.
Lemma len_vzero : len vzero = 0.
Proof. unfold len, dot, vzero. cbn. replace (0 * 0 + 0 * 0 + 0 * 0) with 0 by ring. apply sqrt_0. Qed.
Lemma dot_sym : forall a b, dot a b = dot b a.
Proof. intros. unfold dot. ring. Qed.

(* So P is a positive multiple of y, and a vector across y that is at most t times as long as that multiple. *)
Lemma parts_of_turned : forall t y P, tangent_at_most t y P ->
  exists s D, 0 < s /\ P = vadd (vscale s y) D /\ dot D y = 0 /\ len D <= t * (s * len y).
Proof.
  intros t y P [H T]. assert (Y0 : len y <> 0).
  { intro Z. apply len_zero in Z. rewrite Z in H. unfold dot, vzero in H. cbn in H. lra. }
  assert (Ly := len_nonneg y). assert (Y : 0 < dot y y) by (rewrite <- len_sq; nra).
  set (s := dot P y / dot y y). set (D := vsub P (vscale s y)).
  assert (S : 0 < s) by (unfold s; apply Rdiv_lt_0_compat; assumption).
  assert (E : dot P y = s * dot y y) by (unfold s; field; lra).
  assert (O : dot D y = 0).
  { unfold D. replace (dot (vsub P (vscale s y)) y) with (dot P y - s * dot y y) by (vdestruct; vunfold; ring). lra. }
  exists s, D. split; [exact S|]. split; [apply vec_eq; cbn; ring|]. split; [exact O|].
  assert (C : len D * len y = len (cross P y)).
  { replace (cross P y) with (cross D y) by (unfold D; generalize s; clear; intros; vdestruct; apply vec_eq; cbn; ring).
    unfold len. rewrite <- sqrt_mult by apply dot_self_nonneg. f_equal.
    assert (G : dot (cross D y) (cross D y) = dot D D * dot y y - dot D y * dot D y)
      by (generalize D; clear; intros; vdestruct; vunfold; ring). rewrite G, O. ring. }
  apply Rmult_le_reg_r with (len y); [lra|]. rewrite C. eapply Rle_trans; [exact T|]. right. rewrite E, <- len_sq. ring.
Qed.

(* Pythagoras. *)
Lemma part_is_shorter : forall a b, dot a b = 0 -> len a <= len (vadd a b).
Proof.
  intros a b H. unfold len. apply sqrt_le_1_alt.
  replace (dot (vadd a b) (vadd a b)) with (dot a a + 2 * dot a b + dot b b) by (vdestruct; vunfold; ring).
  generalize (dot_self_nonneg b). lra.
Qed.

Lemma across_plane : forall e U, dot (in_plane e U) (vscale (dot U e / dot e e) e) = 0.
Proof.
  intros e U. unfold in_plane. set (k := dot U e / dot e e).
  replace (dot (vsub U (vscale k e)) (vscale k e)) with (k * (dot U e - k * dot e e)) by (vdestruct; vunfold; ring).
  destruct (Req_dec (dot e e) 0) as [Z|N].
  - apply dot_self_zero in Z. rewrite Z. replace (dot U vzero) with 0 by (unfold dot, vzero; cbn; ring).
    replace (dot vzero vzero) with 0 by (unfold dot, vzero; cbn; ring). ring.
  - replace (k * dot e e) with (dot U e) by (unfold k; field; exact N). ring.
Qed.
Lemma whole_of_parts : forall e U, U = vadd (in_plane e U) (vscale (dot U e / dot e e) e).
Proof. intros. apply vec_eq; unfold in_plane; cbn; ring. Qed.
Lemma leaving_len : forall e U w, Rabs (dot U e) <= w * (len U * len e) -> 0 <= w ->
  len (vscale (dot U e / dot e e) e) <= w * len U.
Proof.
  intros e U w H W. rewrite len_scale_any. generalize (len_nonneg e) (len_nonneg U). intros Le LU.
  destruct (Req_dec (len e) 0) as [Z|N].
  - rewrite Z, Rmult_0_r. apply Rmult_le_pos; assumption.
  - rewrite <- (len_sq e). unfold Rdiv. rewrite Rabs_mult, Rabs_inv, (Rabs_pos_eq (len e * len e)) by nra.
    apply Rmult_le_reg_r with (len e); [lra|].
    replace (Rabs (dot U e) * / (len e * len e) * len e * len e) with (Rabs (dot U e)) by (field; exact N). lra.
Qed.

Theorem form_of_known : forall e y U t, known e y U t -> exists s, 0 < s /\
  forall c, Rabs (dot U c - s * dot y c) <= (t + 12 * u) * (1 + 16 * u) * len c.
Proof.
  intros e y U t [F L W Turn E]. destruct (parts_of_turned _ _ _ Turn) as [s [D [S [P [O T]]]]].
  exists s. split; [exact S|]. intro c.
  generalize u_pos (len_nonneg U) (len_nonneg c) (len_nonneg y) (len_nonneg D). intros U0 LU Lc Ly LD.
  set (k := vscale (dot U e / dot e e) e). assert (K : len k <= 12 * u * len U) by (apply leaving_len; lra).
  assert (X : dot U c - s * dot y c = dot D c + dot k c).
  { rewrite (whole_of_parts e U) at 1. rewrite P. fold k. generalize k. clear. intro k. vdestruct. vunfold. ring. }
  rewrite X. eapply Rle_trans; [apply Rabs_triang|].
  assert (B1 := dot_len D c). assert (B2 := dot_len k c).
  assert (Q : s * len y <= len U).
  { rewrite <- len_scale by lra.
    apply Rle_trans with (len (in_plane e U)).
    - rewrite P. apply part_is_shorter.
      replace (dot (vscale s y) D) with (s * dot D y) by (unfold dot, vscale; cbn; ring). rewrite O. ring.
    - rewrite (whole_of_parts e U) at 2. apply part_is_shorter, across_plane. }
  assert (D1 : len D <= t * len U) by (eapply Rle_trans; [exact T | apply Rmult_le_compat_l; lra]).
  assert (D2 : len D * len c <= t * len U * len c) by (apply Rmult_le_compat_r; lra).
  assert (D3 : len k * len c <= 12 * u * len U * len c) by (apply Rmult_le_compat_r; lra).
  assert (D4 : (t + 12 * u) * len U <= (t + 12 * u) * (1 + 16 * u)) by (apply Rmult_le_compat_l; lra).
  assert (D5 : (t + 12 * u) * len U * len c <= (t + 12 * u) * (1 + 16 * u) * len c) by (apply Rmult_le_compat_r; lra).
  lra.
Qed.

(* A sign that is certain. `value` and `bound` are doubles that are not beyond all numbers. *)
Lemma sign_of_certain : forall value bound z s l error,
  Rabs (value - z) <= error -> Rabs (z - s * l) <= bound - error -> 0 < s ->
  (bound < value -> 0 < l) /\ (value < - bound -> l < 0).
Proof.
  intros value bound z s l error H1 H2 S. apply Rabs_le_inv in H1, H2.
  split; intro H; [assert (0 < s * l) by lra | assert (s * l < 0) by lra]; nra.
Qed.

(* ---- Vectors of a query: the direction, and differences of points ---- *)

(* Vector 0 is the direction, which has variables 18, 19 and 20. Vector k + 1 is pair k. *)
Definition inputs (pairs : list (nat * nat)) n : expr :=
  if (n <? 3)%nat then Var (18 + n) else between pairs (n - 3).
Definition exact_inputs (pairs : list (nat * nat)) (x : nat -> double) n : R :=
  if (n <? 3)%nat then val (x (18 + n)%nat) else exact_between pairs x (n - 3).

Definition direction_of (x : nat -> double) := V (val (x 18%nat)) (val (x 19%nat)) (val (x 20%nat)).
Definition error_of (x : nat -> double) := val (x 21%nat).
Definition known_on_doubles e y (x : nat -> double) :=
  (forall k, (18 <= k <= 21)%nat -> finite (x k)) /\ known e y (direction_of x) (error_of x).

(* The square of a computed difference that is finite. *)
Definition square k := edot (given k) (given k).
Lemma square_back : forall x k, finite (on_doubles x (square k)) ->
  (forall i, (i < 3)%nat -> finite (x (3 * k + i)%nat)) /\
  let v := value_of_vector (fun n => val (x n)) k in val (on_doubles x (square k)) = rdot v v.
Proof.
  intros x k F1. unfold square in *. cbn [on_doubles edot given tx ty tz] in *.
  destruct (add_back _ _ F1) as [F2 [F3 E2]]. destruct (add_back _ _ F2) as [F4 [F5 E3]].
  destruct (mul_back _ _ F3) as [Fz [_ E4]]. destruct (mul_back _ _ F4) as [Fx [_ E5]].
  destruct (mul_back _ _ F5) as [Fy [_ E6]].
  split. { intros [|[|[|i]]] Hi; [rewrite Nat.add_0_r; exact Fx | exact Fy | exact Fz | lia]. }
  unfold value_of_vector, rdot. cbn [vx vy vz]. rewrite E2, E3, E4, E5, E6. reflexivity.
Qed.

Lemma vapprox_len : forall a x, vapprox 1 a x -> len (vsub a x) <= u * len x.
Proof.
  intros a x [[_ E1 _] [[_ E2 _] [_ E3 _]]]. generalize u_pos. intro U0. replace (E 1) with u in * by (unfold E; ring).
  rewrite <- len_scale by lra. apply Rle_trans with (len (vscale u (vabs x))).
  - apply len_mono; unfold vscale, vabs; simpl in *; auto.
  - right. rewrite !len_scale, len_vabs by lra. reflexivity.
Qed.

Section Inputs.
Variables (pairs : list (nat * nat)) (y : nat -> double).
Let x n := on_doubles y (inputs pairs n).
Definition vector_of (z : nat -> R) k := value_of_vector z k.

Lemma difference_back : forall k, finite (on_doubles x (square (S k))) ->
  let v := value_of_vector (fun n => val (x n)) (S k) in let d := value_of_vector (exact_inputs pairs y) (S k) in
  (forall i, (i < 3)%nat -> finite (x (3 * S k + i)%nat)) /\ fmt3 v /\ vapprox 1 v d /\
  val (on_doubles x (square (S k))) = rdot v v.
Proof.
  intros k F v d. destruct (square_back x (S k) F) as [Fi E]. split; [exact Fi|].
  split; [repeat split; apply fmt_val|]. split; [|exact E].
  assert (A : forall i, (i < 3)%nat ->
    approx 1 (Rabs (exact_inputs pairs y (3 * S k + i))) (val (x (3 * S k + i)%nat)) (exact_inputs pairs y (3 * S k +
      i))).
  { intros i Hi. assert (Fx := Fi i Hi). unfold exact_inputs, x, inputs in *.
    replace (3 * S k + i <? 3)%nat with false in * by (symmetry; apply Nat.ltb_ge; lia).
    unfold between in Fx |- *. cbn [on_doubles] in Fx |- *. destruct (sub_back _ _ Fx) as [_ [_ V]]. rewrite V.
    unfold exact_between. apply approx_difference; apply fmt_val. }
  assert (A0 := A 0%nat ltac:(lia)). assert (A1 := A 1%nat ltac:(lia)). assert (A2 := A 2%nat ltac:(lia)).
  rewrite !Nat.add_0_r in A0. unfold vapprox, v, d, value_of_vector. cbn [vx vy vz]. auto.
Qed.
End Inputs.

(* ---- Squares in range ---- *)

Definition low_square := Cst (fst kSmallestSquare) (snd kSmallestSquare).
Definition high_square := Cst (fst kLargestSquare) (snd kLargestSquare).
Definition square_in_range x e :=
  compare_doubles LessEqual (on_doubles x low_square) (on_doubles x e) = true /\
  compare_doubles LessEqual (on_doubles x e) (on_doubles x high_square) = true.

Definition is_square_range (small large : Z * Z) : bool :=
  let (m, k) := small in let (n, l) := large in
  ((Z.abs m <? 2 ^ 53) && (-1000 <=? k) && (k <=? 0) && (Z.abs n <? 2 ^ 53) && (-1000 <=? l) && (l <=? 900))%Z &&
  Qle_bool (999 # (1000 * 10 ^ 50)) (rational m k) && Qle_bool (rational n l) (inject_Z (10 ^ 50) * (1001 # 1000)).
Lemma square_range : is_square_range kSmallestSquare kLargestSquare = true.
Proof. vm_compute. reflexivity. Qed.

Lemma square_range_back : forall x e, square_in_range x e ->
  finite (on_doubles x e) /\ 0.999 / 10 ^ 50 <= val (on_doubles x e) <= 10 ^ 50 * 1.001.
Proof.
  intros x e [HL HH]. generalize square_range HL HH. unfold low_square, high_square.
  destruct kSmallestSquare as [m k], kLargestSquare as [n l]. cbn [fst snd]. clear HL HH. intros H HL HH.
  unfold is_square_range in H.
  rewrite !andb_true_iff, !Z.ltb_lt, !Z.leb_le, !Qle_bool_iff in H. destruct H as [[[[[[[H1 H2] H3] H4] H5] H6] H7] H8].
  assert (Lm := mantissa_bits m H1). assert (Ln := mantissa_bits n H4).
  destruct (normal_constant m k (Z.log2 (Z.abs m) + 1 + k) H1 ltac:(lia) ltac:(lia) eq_refl) as [FL VL].
  destruct (normal_constant n l (Z.log2 (Z.abs n) + 1 + l) H4 ltac:(lia) ltac:(lia) eq_refl) as [FH VH].
  change (finite (on_doubles x (Cst m k))) in FL. change (finite (on_doubles x (Cst n l))) in FH.
  change (val (on_doubles x (Cst m k)) = F2R (Float radix2 m k)) in VL.
  change (val (on_doubles x (Cst n l)) = F2R (Float radix2 n l)) in VH.
  assert (F : finite (on_doubles x e)) by exact (finite_between _ _ _ FL FH HL HH).
  split; [exact F|]. rewrite compare_finite in HL, HH by assumption. cbn [compare_reals] in HL, HH.
  generalize (Rle_bool_spec (val (on_doubles x (Cst m k))) (val (on_doubles x e)))
    (Rle_bool_spec (val (on_doubles x e)) (val (on_doubles x (Cst n l)))).
  rewrite HL, HH. intros I1 I2. inversion I1. inversion I2.
  apply Qle_Rle in H7, H8. rewrite rational_value in H7, H8. rewrite <- VL in H7. rewrite <- VH in H8.
  assert (Q1 : Q2R (999 # (1000 * 10 ^ 50)) = 0.999 / 10 ^ 50).
  { unfold Q2R. cbn [Qnum Qden]. replace (1000 * 10 ^ 50)%positive with (Z.to_pos (1000 * 10 ^ Z.of_nat 50))
      by (vm_compute; reflexivity). rewrite Z2Pos.id by reflexivity. rewrite mult_IZR, <- pow_IZR. field. }
  assert (Q2 : Q2R (inject_Z (10 ^ 50) * (1001 # 1000)) = 10 ^ 50 * 1.001).
  { rewrite Q2R_mult, Q2R_integer. replace (10 ^ 50)%Z with (10 ^ Z.of_nat 50)%Z by (vm_compute; reflexivity).
    rewrite <- pow_IZR. reflexivity. }
  rewrite Q1 in H7. rewrite Q2 in H8. lra.
Qed.

(* ---- Lengths from computed squares ---- *)

Lemma tau_below : forall z, / 10 ^ 100 <= z -> tau <= / 10 ^ 150 * z.
Proof.
  intros z H. eapply Rle_trans; [apply tau_small|]. apply Rle_trans with (/ 10 ^ 150 * / 10 ^ 100).
  - rewrite <- Rinv_mult, <- pow_add. apply Rinv_le; [apply pow_lt; lra | apply Rle_pow; [lra | lia]].
  - apply Rmult_le_compat_l; [left; apply Rinv_0_lt_compat, pow_lt; lra | exact H].
Qed.

(* S is a computed square, with k roundings, of the length L. *)
Lemma root_of_square : forall k S L, (k <= 7)%nat -> 0 <= L -> 0.99 / 10 ^ 50 <= S ->
  Rabs (S - L * L) <= E k * (L * L + 12 * tau) ->
  / 10 ^ 26 <= L /\ L * L <= S * (1 + 8 * u) /\ L * (1 - (INR k / 2 + 1.01) * u) <= rnd (sqrt S) /\
  S <= L * L * (1 + 8 * u).
Proof.
  intros k S L Hk HL HS H. generalize u_pos u_val tau_pos. intros U0 Hu T0.
  assert (Ek : E k <= (INR k + 0.001) * u /\ 0 <= E k).
  { split; [|apply E_nonneg]. unfold E. rewrite Hu.
    do 8 (destruct k as [|k]; [cbn [INR]; simpl; lra|]). lia. }
  assert (K : 0 <= INR k <= 7).
  { split; [apply pos_INR|]. replace 7 with (INR 7) by (cbn; lra). apply le_INR, Hk. }
  assert (L0 : 0 <= L * L) by nra.
  assert (T := tau_below (S * 10) ltac:(lra)).
  apply Rabs_le_inv in H.
  assert (B : E k * (L * L + 12 * tau) <= (INR k + 0.001) * u * (L * L + 12 * tau)) by (apply Rmult_le_compat_r; lra).
  assert (B7 : (INR k + 0.001) * u * (L * L + 12 * tau) <= 7.001 * u * (L * L + 12 * tau)).
  { apply Rmult_le_compat_r; [lra|]. apply Rmult_le_compat_r; lra. }
  assert (T2 : 7.001 * u * (12 * tau) <= / 10 ^ 140 * S) by (rewrite Hu; lra).
  assert (LL : 0.98 / 10 ^ 50 <= L * L) by (rewrite Hu in *; lra).
  assert (L1 : / 10 ^ 26 <= L).
  { apply Rnot_lt_le. intro N. assert (L * L <= / 10 ^ 26 * / 10 ^ 26) by (apply Rmult_le_compat; lra). lra. }
  split; [exact L1|]. split; [rewrite Hu in *; lra|]. split; [|rewrite Hu in *; lra].
  set (c := INR k / 2 + 0.003).
  assert (C : 0 <= c <= 3.51) by (unfold c; lra).
  assert (T3 : (INR k + 0.001) * u * (12 * tau) <= / 10 ^ 120 * (L * L)).
  { assert ((INR k + 0.001) * u * (12 * tau) <= 7.001 * u * (12 * tau)).
    { apply Rmult_le_compat_r; [lra|]. apply Rmult_le_compat_r; lra. }
    assert (S <= L * L * 2) by (rewrite Hu in *; lra). lra. }
  assert (R1 : L * (1 - c * u) <= sqrt S).
  { rewrite <- (sqrt_Rsqr (L * (1 - c * u))) by (apply Rmult_le_pos; rewrite ?Hu; lra).
    apply sqrt_le_1_alt. unfold Rsqr.
    apply Rle_trans with (L * L * (1 - (INR k + 0.002) * u)); [|rewrite Hu in *; lra].
    replace (L * (1 - c * u) * (L * (1 - c * u))) with (L * L * ((1 - c * u) * (1 - c * u))) by ring.
    apply Rmult_le_compat_l; [exact L0|].
    assert (c * c * (u * u) <= 13 * (u * u)) by (apply Rmult_le_compat_r; nra).
    unfold c in *. rewrite Hu in *. lra. }
  assert (R0 : 0 <= sqrt S) by apply sqrt_pos.
  generalize (rnd_any (sqrt S)). rewrite (Rabs_pos_eq _ R0). intro R. apply Rabs_le_inv in R.
  assert (R2 : L * (1 - c * u) * (1 - u) <= sqrt S * (1 - u)) by (apply Rmult_le_compat_r; [rewrite Hu; lra | exact
    R1]).
  assert (T4 : u * tau <= / 1000 * u * L).
  { assert (tau <= / 10 ^ 150 * L) by (apply tau_below; lra). rewrite Hu in *. lra. }
  assert (c * u * L <= 3.51 * u * L) by (apply Rmult_le_compat_r; [lra | apply Rmult_le_compat_r; lra]).
  replace (L * (1 - c * u) * (1 - u)) with (L * (1 - c * u) - u * L + u * (c * u * L)) in R2 by ring.
  assert (0 <= u * (c * u * L)) by (apply Rmult_le_pos; [lra | apply Rmult_le_pos; [apply Rmult_le_pos; lra | lra]]).
  assert (0 <= u * L) by (apply Rmult_le_pos; lra). unfold c in *. lra.
Qed.

(* ---- What a facet's neighbour sees ---- *)

(* G: the length that all bounds on what it sees are made of. *)
Definition seen_size a b := sqrt (2 * (dot a a + dot b b)).
Lemma seen_size_square : forall a b, seen_size a b * seen_size a b = 2 * (dot a a + dot b b).
Proof. intros. apply sqrt_sqrt. generalize (dot_self_nonneg a) (dot_self_nonneg b). lra. Qed.
Lemma seen_size_nonneg : forall a b, 0 <= seen_size a b. Proof. intros. apply sqrt_pos. Qed.
Lemma sum_below_seen_size : forall a b, len a + len b <= seen_size a b.
Proof.
  intros a b. apply Rsqr_incr_0_var; [|apply seen_size_nonneg]. unfold Rsqr. rewrite seen_size_square.
  rewrite <- !len_sq. generalize (len a) (len b). intros p q. assert (0 <= (p - q) * (p - q)) by apply Rle_0_sqr. lra.
Qed.
Lemma product_below_seen_size : forall a b, 4 * (len a * len b) <= seen_size a b * seen_size a b.
Proof.
  intros a b. rewrite seen_size_square. rewrite <- !len_sq. generalize (len a) (len b). intros p q.
  assert (0 <= (p - q) * (p - q)) by apply Rle_0_sqr. lra.
Qed.

(* The square of G, as the code computes it of vectors i and j. *)
Definition seen_square i j := Mul (Cst 1 1) (Add (square i) (square j)).

Section Seen.
Variables (pairs : list (nat * nat)) (y : nat -> double).
Let x n := on_doubles y (inputs pairs n).
Let d k := value_of_vector (exact_inputs pairs y) k.
Let v k := value_of_vector (fun n => val (x n)) k.

(* What is known of a vector whose size is at most G. *)
Record bounded_vector (k : nat) (G : R) : Prop := Bounded {
  are_finite : forall i, (i < 3)%nat -> finite (x (3 * k + i)%nat);
  are_close : napprox u (len (d k) + / 10 ^ 43) (v k) (d k);
  are_below : len (d k) <= G }.

Lemma close_difference : forall k, fmt3 (v k) -> vapprox 1 (v k) (d k) ->
  napprox u (len (d k) + / 10 ^ 43) (v k) (d k).
Proof.
  intros k F A. assert (P : 0 < / 10 ^ 43) by (apply Rinv_0_lt_compat, pow_lt; lra). generalize u_pos. intro U0.
  split; [exact F | | lra | lra]. eapply Rle_trans; [apply vapprox_len, A|]. apply Rmult_le_compat_l; lra.
Qed.

Lemma coordinate_powers : forall k G, bounded_vector k G -> G <= 10 ^ 26 -> forall i, (i < 3)%nat ->
  finite (x (3 * k + i)%nat) /\ Rabs (val (x (3 * k + i)%nat)) <= bpow radix2 88.
Proof.
  intros k G [F C B] HG i Hi. split; [exact (F i Hi)|]. apply napprox_len in C.
  assert (P : 10 ^ 26 * 1.001 <= bpow radix2 88).
  { change (bpow radix2 88) with (IZR (Z.pow_pos 2 88)). apply Rle_trans with (IZR (10 ^ 26 * 2)).
    - rewrite mult_IZR. change (10 ^ 26)%Z with (10 ^ Z.of_nat 26)%Z. rewrite <- pow_IZR. lra.
    - apply IZR_le, Z.leb_le. vm_compute. reflexivity. }
  assert (L : len (v k) <= bpow radix2 88).
  { eapply Rle_trans; [exact C|]. eapply Rle_trans; [|exact P].
    apply Rle_trans with ((1 + u) * (10 ^ 26 + / 10 ^ 43)).
    - apply Rmult_le_compat_l; [generalize u_pos; lra | lra].
    - rewrite u_val. lra. }
  destruct (coordinate_bound _ _ L) as [L0 [L1 L2]]. unfold v, value_of_vector in L0, L1, L2. cbn [vx vy vz] in *.
  destruct i as [|[|[|i]]]; [rewrite Nat.add_0_r; exact L0 | exact L1 | exact L2 | lia].
Qed.

Theorem seen_back : forall i j, square_in_range x (seen_square (S i) (S j)) ->
  let G := seen_size (d (S i)) (d (S j)) in let S2 := val (on_doubles x (seen_square (S i) (S j))) in
  finite (on_doubles x (seen_square (S i) (S j))) /\
  bounded_vector (S i) G /\ bounded_vector (S j) G /\ / 10 ^ 26 <= G <= 10 ^ 26 /\
  G * G <= S2 * (1 + 8 * u) /\ G * (1 - 4.01 * u) <= rnd (sqrt S2) /\ S2 <= G * G * (1 + 8 * u) /\ 0 < S2.
Proof.
  intros i j R G S2. destruct (square_range_back x _ R) as [F B]. fold S2 in B. split; [exact F|].
  unfold S2, seen_square in *. cbn [on_doubles] in *. destruct (mul_back _ _ F) as [_ [F1 E]].
  destruct (add_back _ _ F1) as [Fi [Fj E1]].
  destruct (difference_back pairs y i Fi) as [Ci [Mi [Ai Ei]]]. destruct (difference_back pairs y j Fj) as [Cj [Mj [Aj
    Ej]]]. fold x in Ci, Mi, Ai, Ei, Cj, Mj, Aj, Ej. fold (v (S i)) (d (S i)) in Mi, Ai, Ei. fold (v (S j)) (d (S j)) in
    Mj, Aj, Ej.
  generalize (sum_below_seen_size (d (S i)) (d (S j))) (len_nonneg (d (S i))) (len_nonneg (d (S j))).
  fold G. intros Sum Li Lj.
  set (s := Bplus mode_NE (on_doubles x (square (S i))) (on_doubles x (square (S j)))) in *.
  assert (Two : val (binary_normalize 53 1024 eq_refl eq_refl mode_NE 1 1 false) = 2).
  { destruct (normal_constant 1 1 2 ltac:(lia) ltac:(lia) ltac:(lia) eq_refl) as [_ V]. rewrite V.
    unfold F2R. cbn [Fnum Fexp]. change (bpow radix2 1) with 2. ring. }
  change (val (binary_normalize 53 1024 _ _ mode_NE 1 1 false)) with
    (val (binary_normalize 53 1024 eq_refl eq_refl mode_NE 1 1 false)) in E. rewrite Two in E.
  rewrite rnd_double in E by apply fmt_val.
  match type of E with val ?z = _ => set (S3 := val z) in * end.
  assert (Err : Rabs (S3 - G * G) <= Rounding.E 6 * (G * G + 12 * tau)).
  { unfold G. rewrite seen_size_square. rewrite E, E1, Ei, Ej.
    assert (P := approx_plus _ _ _ _ _ _ _ (rdot_approx 1 1 _ _ _ _ Ai Ai) (rdot_approx 1 1 _ _ _ _ Aj Aj)).
    change (Datatypes.S (1 + 1 + 3)) with 6%nat in P. destruct P as [_ P _]. rewrite !absdot_self in P.
    set (A := dot (d (S i)) (d (S i))) in *. set (Bb := dot (d (S j)) (d (S j))) in *.
    rewrite <- Rmult_minus_distr_l.
    rewrite Rabs_mult, (Rabs_pos_eq 2) by lra. lra. }
  destruct (root_of_square 6 S3 G ltac:(lia) (seen_size_nonneg _ _) ltac:(lra) Err) as [G1 [G2 [G3 G4]]].
  assert (G5 : G <= 10 ^ 26).
  { apply Rnot_lt_le. intro N. assert (10 ^ 26 * 10 ^ 26 <= G * G) by (apply Rmult_le_compat; lra).
    generalize u_val. intro Hu. rewrite Hu in *. lra. }
  split; [split; [exact Ci | apply close_difference; assumption | lra]|].
  split; [split; [exact Cj | apply close_difference; assumption | lra]|].
  replace (INR 6 / 2 + 1.01) with 4.01 in G3 by (cbn; lra).
  repeat split; lra.
Qed.

Theorem length_back : forall k, square_in_range x (square (S k)) ->
  let S2 := val (on_doubles x (square (S k))) in
  finite (on_doubles x (square (S k))) /\ bounded_vector (S k) (len (d (S k))) /\
  / 10 ^ 26 <= len (d (S k)) <= 10 ^ 26 /\ len (d (S k)) * (1 - 3.51 * u) <= rnd (sqrt S2) /\ 0 < S2 <= bpow radix2 176.
Proof.
  intros k R S2. destruct (square_range_back x _ R) as [F B]. fold S2 in B. split; [exact F|].
  destruct (difference_back pairs y k F) as [C [M [A E]]]. fold x in C, M, A, E. fold (v (S k)) (d (S k)) in M, A, E.
  fold S2 in E.
  assert (Err : Rabs (S2 - len (d (S k)) * len (d (S k))) <= Rounding.E 5 * (len (d (S k)) * len (d (S k)) + 12 * tau)).
  { rewrite len_sq. destruct (rdot_approx 1 1 _ _ _ _ A A) as [_ P _]. rewrite absdot_self in P.
    change (1 + 1 + 3)%nat with 5%nat in P. rewrite E. eapply Rle_trans; [exact P|].
    apply Rmult_le_compat_l; [apply E_nonneg | generalize tau_pos; lra]. }
  destruct (root_of_square 5 S2 _ ltac:(lia) (len_nonneg _) ltac:(lra) Err) as [G1 [G2 [G3 G4]]].
  split; [split; [exact C | apply close_difference; assumption | lra]|].
  replace (INR 5 / 2 + 1.01) with 3.51 in G3 by (cbn; lra).
  split; [split; [exact G1|]|].
  - apply Rnot_lt_le. intro N. assert (10 ^ 26 * 10 ^ 26 <= len (d (S k)) * len (d (S k)))
      by (apply Rmult_le_compat; lra). generalize u_val. intro Hu. rewrite Hu in *. lra.
  - split; [exact G3|]. split; [lra|]. apply Rle_trans with (10 ^ 50 * 1.001); [lra|].
    change (bpow radix2 176) with (IZR (2 ^ 176)). apply Rle_trans with (IZR (10 ^ 50 * 2)).
    + rewrite mult_IZR. change (10 ^ 50)%Z with (10 ^ Z.of_nat 50)%Z. rewrite <- pow_IZR. lra.
    + apply IZR_le. vm_compute. discriminate.
Qed.
End Seen.
