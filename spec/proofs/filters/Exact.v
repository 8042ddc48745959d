(* Where doubles are exact. Points are multiples of a power of two, and the vectors of a cell are so short that every
   intermediate result is an integer below 2^53 in units of its degree: kExactReach of src/geometry/filter_bounds.h.
   Then the forms of a cell, and what compare_sphere() computes of a sample, have no error at all. *)
From Coq Require Import Reals ZArith QArith Qreals Lra Lia Psatz Bool List.
From Flocq Require Import Core BinarySingleNaN.
From Flowcert Require Import algebra.Vector3 algebra.Tetrahedron code.Expression code.generated.Constants
  filters.Rounding filters.RoundedVectors filters.Norms filters.Floors filters.Doubles filters.Terms filters.Filter
    filters.Predicates
  filters.Cells filters.Spheres.
Import ListNotations.
Open Scope R_scope.

(* ---- Multiples of 2^e ---- *)

Definition multiple e x := exists m : Z, x = IZR m * bpow radix2 e.
Definition two_53 := bpow radix2 53.

Lemma multiple_product : forall e f x y, multiple e x -> multiple f y -> multiple (e + f) (x * y).
Proof. intros e f x y [m ->] [n ->]. exists (m * n)%Z. rewrite mult_IZR, bpow_plus. ring. Qed.
Lemma multiple_sum : forall e x y, multiple e x -> multiple e y -> multiple e (x + y).
Proof. intros e x y [m ->] [n ->]. exists (m + n)%Z. rewrite plus_IZR. ring. Qed.
Lemma multiple_difference : forall e x y, multiple e x -> multiple e y -> multiple e (x - y).
Proof. intros e x y [m ->] [n ->]. exists (m - n)%Z. rewrite minus_IZR. ring. Qed.
Lemma multiple_size : forall e x, multiple e x -> multiple e (Rabs x).
Proof.
  intros e x [m ->]. exists (Z.abs m). rewrite abs_IZR, Rabs_mult, (Rabs_pos_eq (bpow radix2 e)) by apply bpow_ge_0.
  reflexivity.
Qed.

Lemma exactly_rounded : forall e M x, multiple e x -> Rabs x <= M * bpow radix2 e -> M < two_53 -> (-1074 <= e)%Z ->
  rnd x = x.
Proof.
  intros e M x [m E] H HM He. apply round_generic; [apply valid_rnd_N|]. apply generic_format_FLT.
  exists (Float radix2 m e); cbn [Fnum Fexp]; [exact E | | exact He].
  apply lt_IZR. rewrite IZR_Zpower by lia. fold two_53. apply Rle_lt_trans with M; [|exact HM].
  apply Rmult_le_reg_r with (bpow radix2 e); [apply bpow_gt_0|]. rewrite abs_IZR.
  rewrite E, Rabs_mult, (Rabs_pos_eq (bpow radix2 e)) in H by apply bpow_ge_0. exact H.
Qed.

(* ---- Terms ---- *)

(* The size of a term, for vectors of at most `reach` units. *)
Fixpoint whole_size (reach : Z) {k} (t : term k) : Z :=
  match t with
  | Given _ => reach
  | Cross a b => whole_size reach a * whole_size reach b
  | Scale s a => whole_size reach s * whole_size reach a
  | VPlus a b => whole_size reach a + whole_size reach b
  | Dot a b => whole_size reach a * whole_size reach b
  | Times s t => whole_size reach s * whole_size reach t
  | Plus s t | Minus s t => whole_size reach s + whole_size reach t
  | Twice s => 2 * whole_size reach s
  | Part _ a => whole_size reach a
  | Size s => whole_size reach s
  end%Z.
(* Every intermediate result is an integer below 2^53 in units of its degree, and no multiple of a unit that is too
   small for a double. *)
Fixpoint is_whole (count : nat) (reach : Z) {k} (t : term k) : bool :=
  ((whole_size reach t <? 2 ^ 53)%Z && (degree t <=? 7)%nat) &&
  match t with
  | Given k => (k <? count)%nat
  | Cross a b => is_whole count reach a && is_whole count reach b
  | Scale s a => is_whole count reach s && is_whole count reach a
  | VPlus a b => is_whole count reach a && is_whole count reach b
  | Dot a b => is_whole count reach a && is_whole count reach b
  | Times s t => is_whole count reach s && is_whole count reach t
  | Plus s t | Minus s t => is_whole count reach s && is_whole count reach t
  | Twice s => is_whole count reach s
  | Part _ a => is_whole count reach a
  | Size s => is_whole count reach s
  end.

Definition is_multiple {k} (e : Z) (M : R) : meaning k -> Prop :=
  match k with
  | Scalar => fun x => multiple e x /\ Rabs x <= M * bpow radix2 e
  | Vector => fun v => (multiple e (vx v) /\ multiple e (vy v) /\ multiple e (vz v)) /\ len v <= M * bpow radix2 e
  end.

Lemma whole_below : forall z : Z, (z < 2 ^ 53)%Z -> IZR z < two_53.
Proof. intros. unfold two_53. rewrite <- (IZR_Zpower radix2) by lia. apply IZR_lt. exact H. Qed.

Section Exact.
Variables (count : nat) (reach g : Z) (x : nat -> R).
Hypothesis unit_is_large : (-151 <= g)%Z.
Hypothesis vectors : forall k, (k < count)%nat ->
  is_multiple (k := Vector) g (IZR reach) (V (x (3 * k)%nat) (x (3 * k + 1)%nat) (x (3 * k + 2)%nat)).

Let unit_of {k} (t : term k) := (g * Z.of_nat (degree t))%Z.

Lemma exact_product : forall M N e f r s, multiple e r -> multiple f s -> Rabs r <= M * bpow radix2 e ->
  Rabs s <= N * bpow radix2 f -> M * N < two_53 -> (-1074 <= e + f)%Z ->
  rnd (r * s) = r * s /\ multiple (e + f) (r * s) /\ Rabs (r * s) <= M * N * bpow radix2 (e + f).
Proof.
  intros M N e f r s Hr Hs Br Bs L U. assert (B : Rabs (r * s) <= M * N * bpow radix2 (e + f)).
  { rewrite Rabs_mult, bpow_plus. replace (M * N * (bpow radix2 e * bpow radix2 f))
      with (M * bpow radix2 e * (N * bpow radix2 f)) by ring. apply Rmult_le_compat; auto using Rabs_pos. }
  split; [|split; [apply multiple_product; assumption | exact B]].
  apply (exactly_rounded (e + f) (M * N)); auto. apply multiple_product; assumption.
Qed.

(* Where a dot product and a cross product of exact vectors are exact. *)
Lemma exact_dot : forall M N e f v w, is_multiple (k := Vector) e M v -> is_multiple (k := Vector) f N w ->
  M * N < two_53 -> (-1074 <= e + f)%Z ->
  rdot v w = dot v w /\ is_multiple (k := Scalar) (e + f) (M * N) (dot v w).
Proof.
  intros M N e f v w [[V1 [V2 V3]] LV] [[W1 [W2 W3]] LW] L U.
  destruct (coordinate_bound v _ LV) as [A1 [A2 A3]]. destruct (coordinate_bound w _ LW) as [B1 [B2 B3]].
  destruct (exact_product M N e f _ _ V1 W1 A1 B1 L U) as [E1 [M1 _]].
  destruct (exact_product M N e f _ _ V2 W2 A2 B2 L U) as [E2 [M2 _]].
  destruct (exact_product M N e f _ _ V3 W3 A3 B3 L U) as [E3 [M3 _]].
  assert (S : absdot v w <= M * N * bpow radix2 (e + f)).
  { eapply Rle_trans; [apply absdot_len|]. rewrite bpow_plus.
    replace (M * N * (bpow radix2 e * bpow radix2 f)) with (M * bpow radix2 e * (N * bpow radix2 f)) by ring.
    apply Rmult_le_compat; auto; apply len_nonneg. }
  assert (S2 : Rabs (vx v * vx w + vy v * vy w) <= M * N * bpow radix2 (e + f)).
  { eapply Rle_trans; [apply Rabs_triang|]. rewrite !Rabs_mult. unfold absdot in S.
    generalize (Rmult_le_pos _ _ (Rabs_pos (vz v)) (Rabs_pos (vz w))). lra. }
  assert (S3 : Rabs (dot v w) <= M * N * bpow radix2 (e + f)).
  { eapply Rle_trans; [apply absdot_dot | exact S]. }
  assert (T2 := multiple_sum _ _ _ M1 M2). assert (T3 := multiple_sum _ _ _ T2 M3).
  split; [|split; [exact T3 | exact S3]]. unfold rdot. rewrite E1, E2, E3.
  rewrite (exactly_rounded (e + f) (M * N) _ T2 S2 L U). exact (exactly_rounded (e + f) (M * N) _ T3 S3 L U).
Qed.
Lemma exact_cross : forall M N e f v w, is_multiple (k := Vector) e M v -> is_multiple (k := Vector) f N w ->
  M * N < two_53 -> (-1074 <= e + f)%Z ->
  rcross v w = cross v w /\ is_multiple (k := Vector) (e + f) (M * N) (cross v w).
Proof.
  intros M N e f v w [[V1 [V2 V3]] LV] [[W1 [W2 W3]] LW] L U.
  destruct (coordinate_bound v _ LV) as [A1 [A2 A3]]. destruct (coordinate_bound w _ LW) as [B1 [B2 B3]].
  assert (S : len (cross v w) <= M * N * bpow radix2 (e + f)).
  { eapply Rle_trans; [apply cross_len|]. rewrite bpow_plus.
    replace (M * N * (bpow radix2 e * bpow radix2 f)) with (M * bpow radix2 e * (N * bpow radix2 f)) by ring.
    apply Rmult_le_compat; auto; apply len_nonneg. }
  destruct (coordinate_bound _ _ S) as [S1 [S2 S3]].
  assert (D : forall p q r s, multiple e p -> multiple f q -> multiple e r -> multiple f s ->
    Rabs p <= M * bpow radix2 e -> Rabs q <= N * bpow radix2 f -> Rabs r <= M * bpow radix2 e ->
    Rabs s <= N * bpow radix2 f -> Rabs (p * q - r * s) <= M * N * bpow radix2 (e + f) ->
    rnd (rnd (p * q) - rnd (r * s)) = p * q - r * s /\ multiple (e + f) (p * q - r * s)).
  { intros p q r s Mp Mq Mr Ms Bp Bq Br Bs B.
    destruct (exact_product M N e f _ _ Mp Mq Bp Bq L U) as [-> [T1 _]].
    destruct (exact_product M N e f _ _ Mr Ms Br Bs L U) as [-> [T2 _]].
    assert (T := multiple_difference _ _ _ T1 T2). split; [|exact T]. exact (exactly_rounded _ _ _ T B L U). }
  destruct (D _ _ _ _ V2 W3 V3 W2 A2 B3 A3 B2 S1) as [E1 T1].
  destruct (D _ _ _ _ V3 W1 V1 W3 A3 B1 A1 B3 S2) as [E2 T2].
  destruct (D _ _ _ _ V1 W2 V2 W1 A1 B2 A2 B1 S3) as [E3 T3].
  split; [unfold rcross, cross; rewrite E1, E2, E3; reflexivity|]. split; [|exact S].
  split; [exact T1 | split; [exact T2 | exact T3]].
Qed.

Lemma scaled_length : forall k v M N, Rabs k <= M -> len v <= N -> len (vscale k v) <= M * N.
Proof. intros. rewrite len_scale_any. apply Rmult_le_compat; auto using Rabs_pos, len_nonneg. Qed.

Theorem stays_exact : forall k (t : term k), is_whole count reach t = true -> is_homogeneous t = true ->
  on_shape rnd x (flatten t) = on_shape (fun r => r) x (flatten t) /\
  is_multiple (unit_of t) (IZR (whole_size reach t)) (on_shape (fun r => r) x (flatten t)).
Proof.
  assert (U : forall k (t : term k), (degree t <= 7)%nat -> (-1074 <= unit_of t)%Z) by (intros; unfold unit_of; nia).
  assert (Degrees : forall i j, (g * Z.of_nat (i + j) = g * Z.of_nat i + g * Z.of_nat j)%Z) by (intros; nia).
  induction t; intros A H; cbn [is_whole] in A; cbn [is_homogeneous] in H; rewrite !andb_true_iff in A;
    rewrite ?andb_true_iff in H; destruct A as [[L D] A]; apply Z.ltb_lt in L; apply Nat.leb_le in D;
    assert (B := U _ _ D); apply whole_below in L; unfold unit_of in *; cbn [degree whole_size] in *.
  - split; [reflexivity|]. rewrite Z.mul_1_r. apply vectors, Nat.ltb_lt, A.
  - destruct A as [A1 A2], H as [H1 H2]. destruct (IHt1 A1 H1) as [E1 M1], (IHt2 A2 H2) as [E2 M2].
    rewrite Degrees, mult_IZR in *. destruct (exact_cross _ _ _ _ _ _ M1 M2 L B) as [E M]. split; [|exact M].
    rewrite <- E1, <- E2 in E at 1. exact E.
  - destruct A as [A1 A2], H as [H1 H2]. destruct (IHt1 A1 H1) as [E1 [M1 S1]], (IHt2 A2 H2) as [E2 [[V1 [V2 V3]] SV]].
    rewrite Degrees, mult_IZR in *. destruct (coordinate_bound _ _ SV) as [C1 [C2 C3]].
    destruct (exact_product _ _ _ _ _ _ M1 V1 S1 C1 L B) as [P1 [T1 _]].
    destruct (exact_product _ _ _ _ _ _ M1 V2 S1 C2 L B) as [P2 [T2 _]].
    destruct (exact_product _ _ _ _ _ _ M1 V3 S1 C3 L B) as [P3 [T3 _]].
    assert (SS := scaled_length _ _ _ _ S1 SV). cbn [on_shape vx vy vz] in *.
    injection E2; intros Ez Ey Ex. split.
    + cbn [flatten on_shape on_reals tx ty tz]. rewrite E1, Ex, Ey, Ez. apply vec_eq; assumption.
    + split; [split; [exact T1 | split; [exact T2 | exact T3]]|]. rewrite bpow_plus.
      replace (IZR (whole_size reach t1) * IZR (whole_size reach t2) *
        (bpow radix2 (g * Z.of_nat (degree t1)) * bpow radix2 (g * Z.of_nat (degree t2))))
        with (IZR (whole_size reach t1) * bpow radix2 (g * Z.of_nat (degree t1)) *
          (IZR (whole_size reach t2) * bpow radix2 (g * Z.of_nat (degree t2)))) by ring. exact SS.
  - destruct H as [[H1 H2] H3]. apply Nat.eqb_eq in H3. destruct A as [A1 A2].
    destruct (IHt1 A1 H1) as [E1 [[V1 [V2 V3]] SV]], (IHt2 A2 H2) as [E2 [[W1 [W2 W3]] SW]].
    rewrite <- H3 in *. rewrite plus_IZR in *.
    assert (S := len_triangle (on_shape (fun r => r) x (flatten t1)) (on_shape (fun r => r) x (flatten t2))).
    assert (S' : len (vadd (on_shape (fun r => r) x (flatten t1)) (on_shape (fun r => r) x (flatten t2))) <=
      (IZR (whole_size reach t1) + IZR (whole_size reach t2)) * bpow radix2 (g * Z.of_nat (degree t1))) by lra.
    clear S. destruct (coordinate_bound _ _ S') as [C1 [C2 C3]]. cbn [on_shape vx vy vz] in *.
    injection E1; intros Ez Ey Ex. injection E2; intros Fz Fy Fx.
    assert (T1 := multiple_sum _ _ _ V1 W1). assert (T2 := multiple_sum _ _ _ V2 W2).
    assert (T3 := multiple_sum _ _ _ V3 W3). split.
    + cbn [flatten on_shape on_reals tx ty tz]. rewrite Ex, Ey, Ez, Fx, Fy, Fz.
      apply vec_eq; cbn [vx vy vz]; eapply exactly_rounded; eassumption.
    + split; [split; [exact T1 | split; [exact T2 | exact T3]] | exact S'].
  - destruct A as [A1 A2], H as [H1 H2]. destruct (IHt1 A1 H1) as [E1 M1], (IHt2 A2 H2) as [E2 M2].
    rewrite Degrees, mult_IZR in *. destruct (exact_dot _ _ _ _ _ _ M1 M2 L B) as [E M]. split; [|exact M].
    rewrite <- E1, <- E2 in E at 1. exact E.
  - destruct A as [A1 A2], H as [H1 H2]. destruct (IHt1 A1 H1) as [E1 [M1 S1]], (IHt2 A2 H2) as [E2 [M2 S2]].
    rewrite Degrees, mult_IZR in *. destruct (exact_product _ _ _ _ _ _ M1 M2 S1 S2 L B) as [E [M S]].
    split; [|split; [exact M | exact S]]. rewrite <- E1, <- E2 in E at 1. exact E.
  - destruct H as [[H1 H2] H3]. apply Nat.eqb_eq in H3. destruct A as [A1 A2].
    destruct (IHt1 A1 H1) as [E1 [M1 S1]], (IHt2 A2 H2) as [E2 [M2 S2]]. rewrite <- H3 in *. rewrite plus_IZR in *.
    cbn [on_shape] in *. assert (T := multiple_sum _ _ _ M1 M2).
    assert (S := Rabs_triang (on_reals (fun r => r) x (flatten t1)) (on_reals (fun r => r) x (flatten t2))).
    assert (S' : Rabs (on_reals (fun r => r) x (flatten t1) + on_reals (fun r => r) x (flatten t2)) <=
      (IZR (whole_size reach t1) + IZR (whole_size reach t2)) * bpow radix2 (g * Z.of_nat (degree t1))) by lra.
    split; [|split; [exact T | exact S']]. cbn [flatten on_reals]. rewrite E1, E2.
    exact (exactly_rounded _ _ _ T S' L B).
  - destruct H as [[H1 H2] H3]. apply Nat.eqb_eq in H3. destruct A as [A1 A2].
    destruct (IHt1 A1 H1) as [E1 [M1 S1]], (IHt2 A2 H2) as [E2 [M2 S2]]. rewrite <- H3 in *. rewrite plus_IZR in *.
    cbn [on_shape] in *. assert (T := multiple_difference _ _ _ M1 M2).
    assert (S := Rabs_triang (on_reals (fun r => r) x (flatten t1)) (- on_reals (fun r => r) x (flatten t2))).
    rewrite Rabs_Ropp in S.
    assert (S' : Rabs (on_reals (fun r => r) x (flatten t1) - on_reals (fun r => r) x (flatten t2)) <=
      (IZR (whole_size reach t1) + IZR (whole_size reach t2)) * bpow radix2 (g * Z.of_nat (degree t1)))
      by (unfold Rminus; lra).
    split; [|split; [exact T | exact S']]. cbn [flatten on_reals]. rewrite E1, E2.
    exact (exactly_rounded _ _ _ T S' L B).
  - destruct (IHt A H) as [E [[m M] S]]. rewrite mult_IZR in *. cbn [on_shape flatten on_reals] in *.
    replace (F2R (Float radix2 1 1)) with 2 by (unfold F2R; cbn [Fnum Fexp]; change (bpow radix2 1) with 2; ring).
    assert (T : multiple (g * Z.of_nat (degree t)) (2 * on_reals (fun r => r) x (flatten t))).
    { exists (2 * m)%Z. rewrite M, mult_IZR. ring. }
    assert (S' : Rabs (2 * on_reals (fun r => r) x (flatten t)) <=
      2 * IZR (whole_size reach t) * bpow radix2 (g * Z.of_nat (degree t))).
    { rewrite Rabs_mult, (Rabs_pos_eq 2) by lra. lra. }
    split; [|split; [exact T | exact S']]. rewrite E. exact (exactly_rounded _ _ _ T S' L B).
  - destruct (IHt A H) as [E [[V1 [V2 V3]] S]]. destruct (coordinate_bound _ _ S) as [C1 [C2 C3]].
    cbn [on_shape vx vy vz flatten] in *. injection E; intros Ez Ey Ex.
    destruct i as [|[|i]]; cbn [part]; (split; [assumption | split; assumption]).
  - destruct (IHt A H) as [E [M S]]. cbn [on_shape flatten on_reals] in *. rewrite E.
    split; [reflexivity|]. split; [apply multiple_size, M | rewrite Rabs_Rabsolu; exact S].
Qed.
End Exact.

(* ---- Points on a grid ---- *)

Definition reach_units := (fst kExactReach * 2 ^ snd kExactReach)%Z.
(* Coordinates are multiples of 2^g, and few enough bits that their differences are exact (kSmallBits are 18). *)
Definition points_on_grid g (y : nat -> double) :=
  forall n, finite (y n) /\ exists m : Z, (Z.abs m < 2 ^ 52)%Z /\ val (y n) = IZR m * bpow radix2 g.

Section Grid.
Variables (g : Z) (y : nat -> double) (pairs : list (nat * nat)) (count : nat).
Hypothesis grid : points_on_grid g y.
Let x n := on_doubles y (between pairs n).
Hypothesis norms : are_in_range kSmallestNorm kLargestNorm count x.
Hypothesis are_near : forall k, (k < count)%nat -> val (on_doubles x (norm k)) <= IZR reach_units * bpow radix2 g.

Let range : is_range kSmallestNorm kLargestNorm = true := eq_refl.

Lemma unit_of_near : (0 < count)%nat -> (-151 <= g)%Z.
Proof.
  intros C. destruct (vectors_in_range count _ _ range pairs y norms 0 C) as [_ [[_ [Low _]] _]].
  assert (N := are_near 0%nat C). fold x in Low. destruct (Z_le_gt_dec (-151) g) as [H|H]; [exact H|]. exfalso.
  assert (B : bpow radix2 g <= bpow radix2 (-152)) by (apply bpow_le; lia).
  assert (V : IZR reach_units * bpow radix2 (-152) < / 10 ^ 43).
  { unfold reach_units. cbn [fst snd kExactReach]. change (bpow radix2 (-152)) with (/ IZR (Z.pow_pos 2 152)).
    rewrite pow_IZR. apply Rmult_lt_reg_r with (IZR (Z.pow_pos 2 152)); [apply IZR_lt; reflexivity|].
    rewrite Rmult_assoc, Rinv_l, Rmult_1_r by (apply IZR_neq; discriminate).
    apply Rmult_lt_reg_l with (IZR (10 ^ Z.of_nat 43)); [apply IZR_lt; reflexivity|].
    rewrite <- Rmult_assoc, Rinv_r, Rmult_1_l by (apply IZR_neq; discriminate). rewrite <- mult_IZR. apply IZR_lt.
    reflexivity. }
  assert (G := guarded _ Low). assert (P : 0 <= IZR reach_units) by (apply IZR_le; discriminate).
  assert (IZR reach_units * bpow radix2 g <= IZR reach_units * bpow radix2 (-152)) by (apply Rmult_le_compat_l; auto).
  lra.
Qed.

Lemma coordinate_back : forall n, finite (x n) -> val (x n) = rnd (exact_between pairs y n).
Proof. intros n F. exact (proj2 (proj2 (sub_back _ _ F))). Qed.
Lemma coordinate_multiple : forall n, multiple g (exact_between pairs y n).
Proof.
  intro n. unfold exact_between. destruct (grid (3 * snd (ends pairs n) + n mod 3)%nat) as [_ [m [_ ->]]].
  destruct (grid (3 * fst (ends pairs n) + n mod 3)%nat) as [_ [k [_ ->]]].
  apply multiple_difference; eexists; reflexivity.
Qed.

(* The length of a near vector is at most the reach, because its square is an integer. *)
Lemma near_length : forall v n, multiple g (vx v) -> multiple g (vy v) -> multiple g (vz v) ->
  len v <= n * (1 + 4 * u) -> n <= IZR reach_units * bpow radix2 g -> len v <= IZR reach_units * bpow radix2 g.
Proof.
  intros v n [i Ei] [j Ej] [k Ek] L N. set (b := bpow radix2 g) in *. assert (B : 0 < b) by apply bpow_gt_0.
  assert (P : 0 <= IZR reach_units * b) by (apply Rmult_le_pos; [apply IZR_le; discriminate | lra]).
  assert (U := u_pos). assert (L2 : len v <= IZR reach_units * b * (1 + 4 * u)).
  { eapply Rle_trans; [exact L|]. apply Rmult_le_compat_r; lra. }
  set (q := (i * i + j * j + k * k)%Z).
  assert (D : dot v v = IZR q * (b * b)).
  { unfold dot, q. rewrite Ei, Ej, Ek, !plus_IZR, !mult_IZR. ring. }
  assert (S : IZR q * (b * b) <= IZR (reach_units * reach_units) * ((1 + 4 * u) * (1 + 4 * u)) * (b * b)).
  { rewrite <- D, <- len_sq, mult_IZR.
    replace (IZR reach_units * IZR reach_units * ((1 + 4 * u) * (1 + 4 * u)) * (b * b))
      with (IZR reach_units * b * (1 + 4 * u) * (IZR reach_units * b * (1 + 4 * u))) by ring.
    apply Rmult_le_compat; auto using len_nonneg. }
  assert (BB : 0 < b * b) by (apply Rmult_lt_0_compat; exact B).
  apply Rmult_le_reg_r in S; [|exact BB].
  assert (Q : (q <= reach_units * reach_units)%Z).
  { apply Z.lt_succ_r, lt_IZR. rewrite succ_IZR. eapply Rle_lt_trans; [exact S|].
    unfold reach_units. cbn [fst snd kExactReach]. rewrite u_val.
    match goal with |- IZR ?z * _ < _ => let w := eval vm_compute in z in change z with w end. lra. }
  apply len_le; [exact P|]. rewrite D. apply IZR_le in Q. rewrite mult_IZR in Q.
  replace (IZR reach_units * b * (IZR reach_units * b)) with (IZR reach_units * IZR reach_units * (b * b)) by ring.
  apply Rmult_le_compat_r; [lra | exact Q].
Qed.

Lemma near_vector : forall k, (k < count)%nat ->
  is_multiple (k := Vector) g (IZR reach_units) (value_of_vector (exact_between pairs y) k).
Proof.
  intros k Hk. destruct (vectors_in_range count _ _ range pairs y norms k Hk) as [[_ _ L _] _]. fold x in L.
  assert (M : multiple g (vx (value_of_vector (exact_between pairs y) k)) /\
    multiple g (vy (value_of_vector (exact_between pairs y) k)) /\
    multiple g (vz (value_of_vector (exact_between pairs y) k))) by (repeat split; apply coordinate_multiple).
  split; [exact M|]. destruct M as [M1 [M2 M3]]. exact (near_length _ _ M1 M2 M3 L (are_near k Hk)).
Qed.
Lemma near_coordinate : forall k i, (k < count)%nat -> (i < 3)%nat ->
  val (x (3 * k + i)%nat) = exact_between pairs y (3 * k + i).
Proof.
  intros k i Hk Hi. destruct (vectors_in_range count _ _ range pairs y norms k Hk) as [_ [_ F]].
  destruct (F i Hi) as [Fi _]. fold x in Fi. rewrite coordinate_back by exact Fi.
  destruct (near_vector k Hk) as [_ L]. destruct (coordinate_bound _ _ L) as [B1 [B2 B3]].
  apply (exactly_rounded g (IZR reach_units)).
  - apply coordinate_multiple.
  - destruct i as [|[|[|i]]]; [rewrite Nat.add_0_r; exact B1 | exact B2 | exact B3 | lia].
  - apply whole_below. reflexivity.
  - assert (G := unit_of_near ltac:(lia)). lia.
Qed.

Definition is_exact_form (value : term Scalar) :=
  (0 <? count)%nat && has_variables_below (3 * count) (flatten value) &&
  is_whole count reach_units value && is_homogeneous value && is_some (height (top_of_vectors count) (flatten value)).

Theorem exact_form : forall value, is_exact_form value = true ->
  finite (on_doubles x (flatten value)) /\
  val (on_doubles x (flatten value)) = exact (exact_between pairs y) (flatten value).
Proof.
  intros value H. unfold is_exact_form in H. rewrite !andb_true_iff, Nat.ltb_lt in H.
  destruct H as [[[[C B] W] H] S].
  assert (Parts : forall j, (j < 3 * count)%nat -> (j / 3 < count /\ j mod 3 < 3)%nat /\ j = (3 * (j / 3) + j mod
    3)%nat).
  { intros j Hj. split; [split; [apply Nat.div_lt_upper_bound; lia | apply Nat.mod_upper_bound; discriminate]|].
    apply Nat.div_mod. discriminate. }
  destruct (height (top_of_vectors count) (flatten value)) as [h|] eqn:E; [|discriminate].
  destruct (forward x (top_of_vectors count) (flatten value) h) as [F [V _]]; [|exact E|].
  { intros j Hj. unfold top_of_vectors in *. destruct (Nat.ltb_spec (j / 3) count) as [L|L]; [|discriminate].
    destruct (Parts j) as [[_ M] ->]; [generalize (Nat.div_mod j 3 ltac:(discriminate)) (Nat.mod_upper_bound j 3
      ltac:(discriminate)); lia|].
    apply (vectors_in_range count _ _ range pairs y norms _ L), M. }
  split; [exact F|]. rewrite V. unfold rounded, exact.
  rewrite (reals_same_below rnd (3 * count) _ (exact_between pairs y) (flatten value) B).
  - exact (proj1 (stays_exact count reach_units g (exact_between pairs y) (unit_of_near C) near_vector Scalar value W
    H)).
  - intros j Hj. destruct (Parts j Hj) as [[L M] ->]. apply near_coordinate; assumption.
Qed.
End Grid.

(* ---- What the code calls exact ---- *)

(* Variable 15 is the reach, which is kExactReach in units of the grid. *)
Definition with_reach (reach : double) (x : nat -> double) n := if (n =? 15)%nat then reach else x n.
Definition is_reach g (reach : double) := finite reach /\ val reach <= IZR reach_units * bpow radix2 g.
Definition is_exactly pairs y (value : term Scalar) :=
  let x n := on_doubles y (between pairs n) in
  finite (on_doubles x (flatten value)) /\
  val (on_doubles x (flatten value)) = exact (exact_between pairs y) (flatten value).

Lemma without_reach : forall reach x e, has_variables_below 15 e = true ->
  on_doubles (with_reach reach x) e = on_doubles x e.
Proof.
  intros reach x e H. apply (same_below 15); [exact H|]. intros n Hn. unfold with_reach.
  destruct (Nat.eqb_spec n 15); [lia | reflexivity].
Qed.

Definition sides := [s0; s1; s2; s3].
Lemma near_reach : forall g x reach e, is_reach g reach -> is_in_range kSmallestNorm kLargestNorm x e ->
  compare_doubles LessEqual (on_doubles x e) reach = true -> val (on_doubles x e) <= IZR reach_units * bpow radix2 g.
Proof.
  intros g x reach e [F R] [A B] H.
  destruct (in_range_back x kSmallestNorm kLargestNorm eq_refl e A B) as [Fe _].
  rewrite compare_finite in H by assumption. cbn [compare_reals] in H. revert H.
  case (Rle_bool_spec (val (on_doubles x e))); [|discriminate]. intros H _. lra.
Qed.

Theorem exact_cell_right : forall g y reach s, points_on_grid g y -> is_reach g reach ->
  run (with_reach reach (fun n => on_doubles y (from_vertex n))) Code.is_cell_exact = Some s ->
  forall value, In value (cell_angles ++ sides) -> is_exactly [(0, 1); (0, 2); (0, 3)]%nat y value.
Proof.
  intros g y reach s G R H value Hv.
  assert (Fy : forall n, finite (y n)) by (intro n; apply (G n)).
  assert (E : Code.is_cell_exact = If LessEqual low smallest (If LessEqual largest high
    (If LessEqual largest (Var 15) (Answer (Some Positive)) (Answer None)) (Answer None)) (Answer None))
    by by_computation.
  set (x n := on_doubles y (from_vertex n)) in *. rewrite E in H. clear E. cbn [run] in H.
  rewrite (without_reach reach x low), (without_reach reach x smallest), (without_reach reach x largest),
    (without_reach reach x high) in H by reflexivity.
  destruct (compare_doubles LessEqual (on_doubles x low) (on_doubles x smallest)) eqn:HL; [|discriminate].
  destruct (compare_doubles LessEqual (on_doubles x largest) (on_doubles x high)) eqn:HH; [|discriminate].
  destruct (compare_doubles LessEqual (on_doubles x largest) (on_doubles (with_reach reach x) (Var 15))) eqn:HR;
    [|discriminate].
  destruct (cell_range _ y Fy eq_refl HL HH) as [Norms [Largest Most]].
  assert (N := near_reach g x reach largest R Largest HR).
  apply (exact_form g y _ 3 G Norms).
  - intros k Hk. eapply Rle_trans; [apply Most, Hk | exact N].
  - assert (A : forallb (is_exact_form 3) (cell_angles ++ sides) = true) by by_computation.
    rewrite forallb_forall in A. apply A, Hv.
Qed.

(* Also of a sample: its polynomial is that of the real numbers, so that it is 0 exactly on the sphere. *)
Theorem exact_sphere_right : forall g y reach s, points_on_grid g y -> is_reach g reach ->
  run (with_reach reach (fun n => on_doubles y (between with_sample n))) Code.is_exact = Some s ->
  (exists t, run (fun n => on_doubles y (between with_sample n)) Code.is_on_sphere = Some t) <->
  dot (from_0 y 4) (from_0 y 4) * det (from_0 y 1) (from_0 y 2) (from_0 y 3) -
  dot (numerator (from_0 y 1) (from_0 y 2) (from_0 y 3)) (from_0 y 4) = 0.
Proof.
  intros g y reach s G R H. assert (Fy : forall n, finite (y n)) by (intro n; apply (G n)).
  assert (E : Code.is_exact = If LessEqual low smallest (If LessEqual largest high (If LessEqual low (norm 3)
    (If LessEqual (norm 3) high (If LessEqual largest (Var 15) (If LessEqual (norm 3) (Var 15)
      (Answer (Some Positive)) (Answer None)) (Answer None)) (Answer None)) (Answer None)) (Answer None)) (Answer None))
    by by_computation.
  set (x n := on_doubles y (between with_sample n)) in *. rewrite E in H. clear E. cbn [run] in H.
  rewrite (without_reach reach x low), (without_reach reach x smallest), (without_reach reach x largest),
    (without_reach reach x high), (without_reach reach x (norm 3)) in H by reflexivity.
  destruct (compare_doubles LessEqual (on_doubles x low) (on_doubles x smallest)) eqn:HL; [|discriminate].
  destruct (compare_doubles LessEqual (on_doubles x largest) (on_doubles x high)) eqn:HH; [|discriminate].
  destruct (compare_doubles LessEqual (on_doubles x low) (on_doubles x (norm 3))) eqn:H3; [|discriminate].
  destruct (compare_doubles LessEqual (on_doubles x (norm 3)) (on_doubles x high)) eqn:H4; [|discriminate].
  destruct (compare_doubles LessEqual (on_doubles x largest) (on_doubles (with_reach reach x) (Var 15))) eqn:HR;
    [|discriminate].
  destruct (compare_doubles LessEqual (on_doubles x (norm 3)) (on_doubles (with_reach reach x) (Var 15))) eqn:HN;
    [|discriminate].
  destruct (cell_range with_sample y Fy eq_refl HL HH) as [_ [Largest Most]].
  assert (Norms := sphere_range y Fy HL HH H3 H4).
  assert (N := near_reach g x reach largest R Largest HR).
  assert (N3 := near_reach g x reach (norm 3) R (Norms 3%nat ltac:(lia)) HN).
  destruct (exact_form g y with_sample 4 G Norms) with (value := outside_sphere) as [F V].
  - intros k Hk. destruct (Nat.eq_dec k 3) as [->|K]; [exact N3|].
    eapply Rle_trans; [apply Most; lia | exact N].
  - by_computation.
  - assert (P : exact (exact_between with_sample y) (flatten outside_sphere) =
      dot (from_0 y 4) (from_0 y 4) * det (from_0 y 1) (from_0 y 2) (from_0 y 3) -
      dot (numerator (from_0 y 1) (from_0 y 2) (from_0 y 3)) (from_0 y 4)).
    { clear. unfold from_0, numerator, exact, at_point, exact_between, ends. vunfold. ring. }
    rewrite <- P, <- V. clear P.
    assert (E : Code.is_on_sphere = If Equal (flatten outside_sphere) (Cst 0 0) (Answer (Some Positive)) (Answer None))
      by by_computation.
    rewrite E. cbn [run]. fold x.
    change (on_doubles (fun n => on_doubles y (between with_sample n)) (flatten outside_sphere))
      with (on_doubles x (flatten outside_sphere)) in *.
    assert (FZ : finite (on_doubles x (Cst 0 0))) by reflexivity.
    assert (Z : val (on_doubles x (Cst 0 0)) = 0) by reflexivity.
    rewrite compare_finite by assumption. rewrite Z. cbn [compare_reals]. case Req_bool_spec; intro Q.
    + split; [intros _; exact Q | intros _; eexists; reflexivity].
    + split; [intros [t T]; discriminate | intro T; contradiction].
Qed.
