(* A direction that a longer precision knows is known in doubles, once each coordinate is rounded and the error is
   kGivenStartBound roundoffs more (`rounded_direction` and `keep` of src/flow/kernels/direction_rung.h).
   `known_within` is `known` of a longer precision. A direction in integers has the error 0 there. This is about real
   numbers that are rounded. The error of a rounded direction has to be 4 u at least, which the constant rests on; the
   angle grows by less, 1.2 u. *)
From Coq Require Import Reals ZArith QArith Qreals Lra Lia Psatz Bool List.
From Flocq Require Import Core.
From Flowcert Require Import algebra.Vector3 code.Expression code.generated.Constants filters.Rounding
  filters.RoundedVectors filters.Norms filters.Doubles filters.Filter filters.Directions filters.DoubleDouble.
Open Scope R_scope.

(* `known`, where w is the roundoff: of the longer precision, or 0 where nothing is rounded. *)
Record known_within (w : R) (e y U : vec) (t : R) : Prop := KnownWithin {
  lies_in_facet : dot y e = 0;
  is_short_within : len U <= 1 + 16 * w;
  leaves_plane_within : Rabs (dot U e) <= 12 * w * (len U * len e);
  angle_within : tangent_at_most t y (in_plane e U);
  error_within : 0 <= t <= 3 / 32 }.

(* ---- The constant ---- *)

Definition given_start := F2R (Float radix2 (fst kGivenStartBound) (snd kGivenStartBound)) * u.
Definition given_needs : Q := 4.
Lemma given_is_enough :
  Qle_bool given_needs (rational (fst kGivenStartBound) (snd kGivenStartBound)) = true.
Proof. vm_compute. reflexivity. Qed.
Lemma given_start_bound : 4 * u <= given_start.
Proof.
  assert (H := given_is_enough). apply Qle_bool_iff, Qle_Rle in H. rewrite rational_value in H.
  replace (Q2R given_needs) with 4 in H by (unfold Q2R; cbn; lra).
  unfold given_start. apply Rmult_le_compat_r; [generalize u_pos; lra | exact H].
Qed.

(* ---- A small change of the coordinates ---- *)

Definition coordinates_near U X := forall c, In c (cons vx (cons vy (cons vz nil))) ->
  Rabs (c X - c U) <= u * Rabs (c U) + u * tau.

Lemma change_of_coordinates : forall U X, coordinates_near U X -> / 2 <= len U ->
  len (vsub X U) <= 1.0001 * u * len U.
Proof.
  intros U X H L. generalize u_pos u_val tau_pos tau_small. intros U0 Hu T0 T1.
  apply Rle_trans with (len (vadd (vscale u (vabs U)) (V (u * tau) (u * tau) (u * tau)))).
  - apply len_mono; unfold vscale, vabs, vadd, vsub; cbn [vx vy vz]; apply H; cbn; auto.
  - eapply Rle_trans; [apply len_triangle|]. rewrite len_scale, len_vabs by lra.
    assert (Q : 0 <= u * tau) by (apply Rmult_le_pos; lra).
    assert (u * tau <= u * (/ 10 ^ 5 * len U)) by (apply Rmult_le_compat_l; lra).
    assert (B : len (V (u * tau) (u * tau) (u * tau)) <= 2 * (u * tau)).
    { generalize (u * tau) Q. intros q q0. apply len_le; [lra|]. unfold dot. cbn. assert (Q2 := Rle_0_sqr q).
      unfold Rsqr in Q2. lra. }
    lra.
Qed.

Lemma in_plane_shorter : forall e d, len (in_plane e d) <= len d.
Proof. intros e d. rewrite (whole_of_parts e d) at 2. apply part_is_shorter, across_plane. Qed.
Lemma in_plane_add : forall e U d, in_plane e (vadd U d) = vadd (in_plane e U) (in_plane e d).
Proof.
  intros e U d. unfold in_plane. replace (dot (vadd U d) e) with (dot U e + dot d e) by (vdestruct; vunfold; ring).
  unfold Rdiv. generalize (/ dot e e) (dot U e) (dot d e). intros. vdestruct. apply vec_eq; cbn; ring.
Qed.

(* A direction P turns by the tangent k at most, where it changes by k |P| at most, nearly. *)
Lemma turn_of_change : forall t y P d, tangent_at_most t y P -> 0 <= t <= 3 / 32 -> len d <= 1.001 * u * len P ->
  forall s, t + 1.2 * u <= s * (1 - 1.2 * u) -> tangent_at_most s y (vadd P d).
Proof.
  intros t y P d T Ht Hd s Hs. generalize u_pos u_val (len_nonneg y) (len_nonneg d). intros U0 Hu Ly Ld.
  assert (Y0 : len y <> 0).
  { intro Z. apply len_zero in Z. destruct T as [T _]. rewrite Z in T. unfold dot, vzero in T. cbn in T. lra. }
  destruct (parts_of_turned _ _ _ T) as [k [D [K [E [O B]]]]].
  set (L := k * len y) in *. assert (L0 : 0 < L) by (apply Rmult_lt_0_compat; lra).
  assert (LP : len P <= (1 + t) * L).
  { rewrite E. eapply Rle_trans; [apply len_triangle|]. rewrite len_scale by lra. fold L. lra. }
  assert (Hd1 : len d <= 1.2 * u * L).
  { eapply Rle_trans; [exact Hd|]. apply Rle_trans with (1.001 * u * ((1 + t) * L)).
    - apply Rmult_le_compat_l; lra.
    - rewrite <- Rmult_assoc. apply Rmult_le_compat_r; [lra|].
      assert (u * t <= u * (3 / 32)) by (apply Rmult_le_compat_l; lra). lra. }
  assert (LY : 0 < L * len y) by (apply Rmult_lt_0_compat; lra).
  assert (dy : len d * len y <= 1.2 * u * L * len y) by (apply Rmult_le_compat_r; lra).
  assert (A : L * len y * (1 - 1.2 * u) <= dot (vadd P d) y).
  { assert (X : dot (vadd P d) y = L * len y + dot d y).
    { replace (dot (vadd P d) y) with (dot P y + dot d y) by (clear; vdestruct; vunfold; ring). f_equal.
      rewrite E. replace (dot (vadd (vscale k y) D) y) with (k * dot y y + dot D y)
        by (clear; vdestruct; vunfold; ring). rewrite O, <- len_sq. unfold L. ring. }
    rewrite X. assert (H := dot_len d y). apply Rabs_le_inv in H. lra. }
  split.
  - eapply Rlt_le_trans; [|exact A]. apply Rmult_lt_0_compat; [exact LY | rewrite Hu; lra].
  - apply Rle_trans with ((t + 1.2 * u) * (L * len y)).
    + replace (cross (vadd P d) y) with (vadd (cross D y) (cross d y))
        by (rewrite E; clear; vdestruct; apply vec_eq; cbn; ring).
      eapply Rle_trans; [apply len_triangle|]. assert (C1 := cross_len D y). assert (C2 := cross_len d y).
      assert (len D * len y <= t * L * len y) by (apply Rmult_le_compat_r; lra). lra.
    + assert (S0 : 0 <= s).
      { apply Rnot_lt_le. intro N. assert (s * (1 - 1.2 * u) < 0) by (rewrite Hu; lra). lra. }
      apply Rle_trans with (s * (1 - 1.2 * u) * (L * len y)); [apply Rmult_le_compat_r; lra|].
      rewrite Rmult_assoc. apply Rmult_le_compat_l; lra.
Qed.

Theorem near_known : forall w e y U X t s, 0 <= w <= / 10 ^ 30 -> known_within w e y U t -> / 2 <= len U ->
  coordinates_near U X -> (t + given_start) * (1 - 3 * u) <= s -> 4 * u <= s <= 3 / 32 -> known e y X s.
Proof.
  intros w e y U X t s W [F Sh Lv T E] L N Hs Rs. generalize u_pos u_val given_start_bound (len_nonneg e).
  intros U0 Hu G Le.
  assert (C := change_of_coordinates _ _ N L). set (d := vsub X U) in *. assert (Ld := len_nonneg d).
  assert (EX : X = vadd U d) by (unfold d; apply vec_eq; cbn; ring).
  assert (Low : len U <= len X + len d).
  { replace U with (vadd X (vscale (-1) d)) at 1 by (unfold d; apply vec_eq; cbn; ring).
    eapply Rle_trans; [apply len_triangle|]. rewrite len_scale_any, Rabs_left by lra. lra. }
  assert (High : len X <= len U + len d) by (rewrite EX; apply len_triangle).
  assert (LU : len U <= 1.1) by lra.
  assert (WU : 12 * w * len U <= 0.001 * u * len U) by (apply Rmult_le_compat_r; [lra|]; rewrite Hu; lra).
  split.
  - exact F.
  - assert (u * len U <= u * 1.1) by (apply Rmult_le_compat_l; lra). rewrite Hu in *. lra.
  - rewrite EX at 1. replace (dot (vadd U d) e) with (dot U e + dot d e) by (clear; vdestruct; vunfold; ring).
    eapply Rle_trans; [apply Rabs_triang|]. assert (B := dot_len d e).
    assert (P1 : len d * len e <= 1.0001 * u * len U * len e) by (apply Rmult_le_compat_r; lra).
    assert (P2 : 12 * w * len U * len e <= 0.001 * u * len U * len e) by (apply Rmult_le_compat_r; lra).
    assert (P3 : len U <= 1.1 * len X) by (rewrite Hu in *; lra).
    assert (P4 : u * len e * len U <= u * len e * (1.1 * len X))
      by (apply Rmult_le_compat_l; [apply Rmult_le_pos; lra | exact P3]).
    assert (P5 : 0 <= u * len e * len X) by (apply Rmult_le_pos; [apply Rmult_le_pos; lra | apply len_nonneg]). lra.
  - rewrite EX, in_plane_add. apply (turn_of_change t); [exact T | exact E | |].
    + eapply Rle_trans; [apply in_plane_shorter|].
      assert (K : len (vscale (dot U e / dot e e) e) <= 12 * w * len U) by (apply leaving_len; lra).
      assert (B : len U <= len (in_plane e U) + len (vscale (dot U e / dot e e) e)).
      { rewrite (whole_of_parts e U) at 1. apply len_triangle. }
      assert (P : len U * (1 - 0.001 * u) <= len (in_plane e U)) by lra.
      assert (P2 : 1.001 * u * (len U * (1 - 0.001 * u)) <= 1.001 * u * len (in_plane e U))
        by (apply Rmult_le_compat_l; lra).
      assert (u * (u * len U) <= u * (0.0001 * len U)).
      { apply Rmult_le_compat_l; [lra|]. apply Rmult_le_compat_r; rewrite ?Hu; lra. }
      lra.
    + assert (P1 : u * s <= u * (3 / 32)) by (apply Rmult_le_compat_l; lra).
      assert (P2 : (t + 4 * u) * (1 - 3 * u) <= (t + given_start) * (1 - 3 * u))
        by (apply Rmult_le_compat_r; [rewrite Hu; lra | lra]).
      rewrite Hu in *. lra.
  - exact Rs.
Qed.

(* ---- From the longer precision ---- *)

Definition rounded_vector U := V (rnd (vx U)) (rnd (vy U)) (rnd (vz U)).
Lemma rounded_near : forall U, coordinates_near U (rounded_vector U).
Proof. intros U c H. cbn in H. destruct H as [<-|[<-|[<-|[]]]]; apply rnd_any. Qed.

Lemma rnd_not_below : forall x y, fmt x -> x <= y -> x <= rnd y.
Proof.
  intros x y F H. rewrite <- (round_generic radix2 fexp ZnearestE x F). apply round_le; [|apply valid_rnd_N | exact H].
  apply FLT_exp_valid. reflexivity.
Qed.
Lemma fmt_four_units : fmt (4 * u).
Proof.
  apply generic_format_FLT. exists (Float radix2 4 (-53)); [reflexivity | cbn; lia | cbn; lia].
Qed.

(* The sum of the error and the constant is rounded in the longer precision, too, and no further than to the constant:
   that is a number there. *)
Theorem longer_known : forall w e y U t sum, 0 <= w <= / 10 ^ 30 -> known_within w e y U t -> / 2 <= len U ->
  given_start <= sum -> (t + given_start) * (1 - w) <= sum -> rnd sum <= 3 / 32 ->
  known e y (rounded_vector U) (rnd sum).
Proof.
  intros w e y U t sum W K L G S R. generalize u_pos u_val tau_small given_start_bound. intros U0 Hu T G4.
  assert (T0 := error_within _ _ _ _ _ K).
  assert (F : 4 * u <= rnd sum) by (apply rnd_not_below; [apply fmt_four_units | lra]).
  apply (near_known w e y U _ t); try assumption; [apply rounded_near | | lra].
  assert (B := rnd_any sum). rewrite (Rabs_pos_eq sum) in B by lra. apply Rabs_le_inv in B.
  set (x := t + given_start) in *. assert (X : 4 * u <= x) by (unfold x; lra).
  assert (B1 : x * (1 - w) * (1 - u) <= sum * (1 - u)) by (apply Rmult_le_compat_r; [rewrite Hu; lra | exact S]).
  assert (B2 : x * w <= x * (0.1 * u)) by (apply Rmult_le_compat_l; [lra | rewrite Hu; lra]).
  assert (B3 : 0 <= x * w * u) by (apply Rmult_le_pos; [apply Rmult_le_pos; lra | lra]).
  assert (B4 : u * tau <= u * (0.1 * x)).
  { apply Rmult_le_compat_l; [lra|]. eapply Rle_trans; [exact T|]. rewrite Hu in X. lra. }
  assert (B5 : 0 <= x * u) by (apply Rmult_le_pos; lra).
  replace (x * (1 - w) * (1 - u)) with (x - x * w - x * u + x * w * u) in B1 by ring. lra.
Qed.

(* ---- From doubled doubles ---- *)

(* The high part of each coordinate, and of the error. *)
Theorem doubled_known : forall w e y x0 y0 z0 t0 x1 y1 z1 t1, 0 <= w <= / 10 ^ 30 ->
  double_double x0 x1 -> double_double y0 y1 -> double_double z0 z1 -> double_double t0 t1 ->
  let U := V (value x0 x1) (value y0 y1) (value z0 z1) in
  known_within w e y U (value t0 t1) -> / 2 <= len U ->
  let error := rnd (val t0 + given_start) in error <= 3 / 32 ->
  known e y (V (val x0) (val y0) (val z0)) error.
Proof.
  intros w e y x0 y0 z0 t0 x1 y1 z1 t1 W DX DY DZ DT U K L error R.
  generalize u_pos u_val tau_small tau_pos given_start_bound. intros U0 Hu T TP G4.
  assert (T0 := error_within _ _ _ _ _ K). set (t := value t0 t1) in *.
  assert (H : val t0 = rnd t) by (symmetry; apply (rounded_high _ _ DT)).
  assert (H0 : 0 <= val t0) by (rewrite H; apply rnd_not_below; [apply generic_format_0 | lra]).
  assert (E : V (val x0) (val y0) (val z0) = rounded_vector U).
  { apply vec_eq; cbn; symmetry; apply rounded_high; assumption. }
  rewrite E. assert (F : 4 * u <= error) by (apply rnd_not_below; [apply fmt_four_units | lra]).
  apply (near_known w e y U _ t); try assumption; [apply rounded_near | | lra].
  assert (B := rnd_any (val t0 + given_start)). fold error in B. rewrite (Rabs_pos_eq (val t0 + given_start)) in B by
    lra. apply Rabs_le_inv in B.
  assert (C := rnd_any t). rewrite <- H, (Rabs_pos_eq t) in C by lra. apply Rabs_le_inv in C.
  set (g := given_start) in *. assert (u * tau <= u * (0.1 * g)).
  { apply Rmult_le_compat_l; [lra|]. eapply Rle_trans; [exact T|]. rewrite Hu in G4. lra. }
  assert (X : (t * (1 - u) - u * (0.1 * g) + g) * (1 - u) <= (val t0 + g) * (1 - u)).
  { apply Rmult_le_compat_r; [rewrite Hu; lra | lra]. }
  assert (0 <= u * u * t) by (apply Rmult_le_pos; [apply Rmult_le_pos|]; lra).
  assert (0 <= u * u * g) by (apply Rmult_le_pos; [apply Rmult_le_pos|]; lra).
  assert (0 <= u * g) by (apply Rmult_le_pos; lra). assert (0 <= u * t) by (apply Rmult_le_pos; lra). lra.
Qed.
