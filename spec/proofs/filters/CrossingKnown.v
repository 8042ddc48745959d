(* A crossing in real numbers and roundings: what src/flow/kernels/direction_across.h says of the direction behind a
   facet is true, if the vector and the height that it starts from are what `way_inputs` and `corner_height` say.
   `crossing_known` is the theorem, and `error_covers` is its rule: with eta for the slack, the tangent is at most
   (kappa t + r) (1 + 5.45 eta), and the code takes at least 6 for 5.45. *)
From Coq Require Import Reals Lra Lia Psatz.
From Flocq Require Import Core.
From Flowcert Require Import algebra.Vector3 algebra.Cascade algebra.Crossing filters.Rounding filters.RoundedVectors
  filters.Norms filters.Floors filters.Terms filters.Directions filters.DirectionTurns filters.DirectionVectors
  filters.CrossingVectors filters.CrossingSizes.
Open Scope R_scope.

(* |h'| f |e'|/|e| *)
Definition corner_height p0 p1 q k0 k1 c := sqrt (h k0 k1 c * h k0 k1 c *
  (dot (area_vector p0 p1 q) (area_vector p0 p1 q) / dot (area_vector k0 k1 c) (area_vector k0 k1 c)) *
  (dot (vsub k1 k0) (vsub k1 k0) / dot (vsub p1 p0) (vsub p1 p0))).

(* ---- The map's determinant and norm ---- *)

Lemma corner_height_square : forall p0 p1 q k0 k1 c, polygon p0 p1 q k0 k1 c ->
  0 <= h k0 k1 c * h k0 k1 c *
    (dot (area_vector p0 p1 q) (area_vector p0 p1 q) / dot (area_vector k0 k1 c) (area_vector k0 k1 c)) *
    (dot (vsub k1 k0) (vsub k1 k0) / dot (vsub p1 p0) (vsub p1 p0)).
Proof.
  intros p0 p1 q k0 k1 c Poly. destruct (orthogonal_parts _ _ _ _ _ _ Poly) as [_ [_ [_ [_ [A1 [A2 A3]]]]]].
  assert (Q : forall a b, 0 <= a -> 0 < b -> 0 <= a / b)
    by (intros; apply Rmult_le_pos; [assumption | left; apply Rinv_0_lt_compat; assumption]).
  apply Rmult_le_pos; [apply Rmult_le_pos; [apply Rle_0_sqr | apply Q; lra]|].
  apply Q; [apply dot_self_nonneg | exact A3].
Qed.

Lemma root_of_determinant : forall p0 p1 q k0 k1 c, polygon p0 p1 q k0 k1 c ->
  sqrt (determinant_square p0 p1 q k0 k1 c) = 4 * Rabs (h p0 p1 q) * corner_height p0 p1 q k0 k1 c.
Proof.
  intros p0 p1 q k0 k1 c Poly. assert (X := corner_height_square _ _ _ _ _ _ Poly). unfold corner_height.
  unfold determinant_square. revert X. generalize (h k0 k1 c * h k0 k1 c) (dot (area_vector p0 p1 q) (area_vector p0 p1
    q)
    / dot (area_vector k0 k1 c) (area_vector k0 k1 c)) (dot (vsub k1 k0) (vsub k1 k0) / dot (vsub p1 p0) (vsub p1 p0)).
  generalize (h p0 p1 q). clear. intros a x y z X.
  replace (16 * (a * a) * x * y * z) with (Rsqr (4 * a) * (x * y * z)) by (unfold Rsqr; ring).
  rewrite sqrt_mult by (try apply Rle_0_sqr; exact X). rewrite sqrt_Rsqr_abs, Rabs_mult, (Rabs_pos_eq 4) by lra.
  reflexivity.
Qed.

Lemma root_of_norm : forall p0 p1 q k0 k1 c, polygon p0 p1 q k0 k1 c ->
  sqrt (norm_square p0 p1 q k0 k1 c) = 2 * Rmax (Rabs (h p0 p1 q)) (corner_height p0 p1 q k0 k1 c).
Proof.
  intros p0 p1 q k0 k1 c Poly. assert (X := corner_height_square _ _ _ _ _ _ Poly). unfold norm_square, corner_height.
  revert X. match goal with |- 0 <= ?w -> _ => generalize w end. generalize (h p0 p1 q). clear. intros a x X.
  assert (S2 : sqrt 4 = 2) by (replace 4 with (2 * 2) by ring; apply sqrt_square; lra).
  assert (A0 : 0 <= a * a) by apply Rle_0_sqr.
  assert (SA : sqrt (a * a) = Rabs a) by apply sqrt_Rsqr_abs.
  assert (M0 : 0 <= Rmax (a * a) x) by (eapply Rle_trans; [exact A0 | apply Rmax_l]).
  rewrite sqrt_mult by lra. rewrite S2. f_equal.
  rewrite <- SA. destruct (Rle_lt_dec (a * a) x) as [H|H].
  - rewrite !Rmax_right; [reflexivity | apply sqrt_le_1_alt; exact H | exact H].
  - rewrite !Rmax_left; [reflexivity | apply sqrt_le_1_alt; lra | lra].
Qed.

(* ---- The rule ---- *)

(* Nothing here is rounded. z is the length of the new direction's part in the plane, over the inverse. *)
Lemma inverse_of_short : forall z r p, 0 <= r <= / 15 -> 0 <= p <= 0.672 * r -> 1 - 10.2 * u - 1.0001 * (p * p) <= z ->
  0 < z /\ / z <= 1 + 11 * u + 0.46 * (r * r) /\ / z * / z <= 1 + 22 * u + 0.92 * (r * r) /\ / z <= 1.0021.
Proof.
  intros z r p Hr Hp Hz. generalize u_pos u_val. intros U0 Hu.
  assert (P : p * p <= 0.672 * r * (0.672 * r)) by (apply Rmult_le_compat; lra).
  assert (R : r * r <= / 15 * / 15) by (apply Rmult_le_compat; lra). assert (R0 : 0 <= r * r) by apply Rle_0_sqr.
  set (x := 10.2 * u + 0.4517 * (r * r)).
  assert (x1 : 0 <= x <= 0.0021) by (unfold x; rewrite Hu; lra).
  assert (z1 : 1 - x <= z) by (unfold x; lra). assert (z0 : 0 < z) by lra.
  assert (Zi : / z <= 1 + 1.003 * x).
  { apply Rmult_le_reg_r with z; [exact z0|]. rewrite Rinv_l by lra.
    apply Rle_trans with ((1 + 1.003 * x) * (1 - x)); [|apply Rmult_le_compat_l; lra].
    assert (x * x <= 0.0021 * x) by (apply Rmult_le_compat_r; lra). lra. }
  assert (Zi0 : 0 < / z) by (apply Rinv_0_lt_compat, z0).
  assert (Z2 : / z * / z <= (1 + 1.003 * x) * (1 + 1.003 * x)) by (apply Rmult_le_compat; lra).
  assert (x2 : x * x <= 0.0021 * x) by (apply Rmult_le_compat_r; lra).
  split; [exact z0|]. unfold x in *. repeat split; lra.
Qed.

Lemma rule_of_errors : forall T N r kt nt r1, 0 <= T -> 0 <= N -> 30 * u <= r -> T + N + r <= 0.0626 ->
  kt <= (T + / 10 ^ 90 * u) * (1 + 80 * u + 0.93 * (r * r)) -> nt <= (N + / 10 ^ 90 * u) * (1 + 80 * u + 0.93 * (r *
    r)) ->
  0 <= kt -> 0 <= nt -> 0 <= r1 <= 0.893 * r ->
  kt + nt + r1 <= / 15 /\
  (kt + r1) * (1 + 5 * (kt + nt + r1)) <= (T + r) * (1 + 6 * (T + N + r)) * (1 - 8.3 * u).
Proof.
  intros T N r kt nt r1 T0 N0 Hr Sum Hk Hn k0 n0 Hr1. generalize u_pos u_val. intros U0 Hu.
  assert (rr : r * r <= 0.0626 * r) by (apply Rmult_le_compat_r; lra).
  assert (rr0 : 0 <= r * r) by apply Rle_0_sqr.
  assert (F : forall w, 0 <= w <= 0.0626 -> (w + / 10 ^ 90 * u) * (1 + 80 * u + 0.93 * (r * r)) <=
    w * (1 + 80 * u) + 0.0037 * r + / 10 ^ 80 * u).
  { intros w Hw. assert (w * (r * r) <= 0.0626 * (0.0626 * r)) by (apply Rmult_le_compat; lra).
    assert (/ 10 ^ 90 * u * (1 + 80 * u + 0.93 * (r * r)) <= / 10 ^ 90 * u * 2).
    { apply Rmult_le_compat_l; [rewrite Hu; lra|]. rewrite Hu in *. lra. }
    lra. }
  assert (Fk := F T ltac:(rewrite Hu in *; lra)). assert (Fn := F N ltac:(rewrite Hu in *; lra)).
  assert (T1 : T <= 0.0626) by (rewrite Hu in *; lra).
  set (eta := T + N + r) in *. assert (e0 : 30 * u <= eta) by (unfold eta; lra).
  assert (TT : T * T <= T * eta) by (apply Rmult_le_compat_l; unfold eta; lra).
  assert (Sq : 80 * T <= 3 + 600 * (T * T)).
  { assert (0 <= (T - 0.0666) * (T - 0.0666)) by apply Rle_0_sqr. lra. }
  assert (Sq2 : u * (80 * T) <= u * (3 + 600 * (T * T))) by (apply Rmult_le_compat_l; lra).
  set (w := T * eta) in *. assert (w0 : 0 <= w) by (apply Rmult_le_pos; lra).
  assert (K1 : kt + r1 <= T + r + 600 * u * w).
  { assert (u * (T * T) <= u * w) by (apply Rmult_le_compat_l; lra). rewrite Hu in *. lra. }
  assert (K2 : 600 * u * w <= 600 * u * ((T + r) * eta)).
  { apply Rmult_le_compat_l; [lra|]. apply Rmult_le_compat_r; lra. }
  set (Q := T + r) in *. assert (Q0 : 0 < Q) by (unfold Q; lra).
  assert (E1 : kt + nt + r1 <= eta + 2.5 * u).
  { assert (u * (T + N) <= u * 0.0626) by (apply Rmult_le_compat_l; unfold eta in *; lra). unfold eta. rewrite Hu in *.
    lra. }
  split; [rewrite Hu in *; lra|].
  assert (E2 : 1 + 5 * (kt + nt + r1) <= 1 + 5.45 * eta) by lra.
  apply Rle_trans with (Q * (1 + 600 * u * eta) * (1 + 5.45 * eta)).
  - apply Rmult_le_compat; lra.
  - rewrite (Rmult_assoc Q), (Rmult_assoc Q). apply Rmult_le_compat_l; [lra|].
    assert (ee : eta * eta <= 0.0626 * eta) by (apply Rmult_le_compat_r; lra).
    assert (0 <= eta * eta) by apply Rle_0_sqr. rewrite Hu in *. lra.
Qed.

(* ---- The rounded bound ---- *)

Lemma fmt_of_parts : forall m k, (Z.abs m < 2 ^ 53)%Z -> (-1074 <= k)%Z -> fmt (IZR m * bpow radix2 k).
Proof.
  intros m k M K. apply generic_format_FLT. exists (Float radix2 m k); [reflexivity | exact M | exact K].
Qed.

Lemma error_covers : forall kB turn norm t r, 6 <= kB <= 8 -> fmt turn -> fmt norm -> fmt r -> 0 <= turn -> 0 <= norm ->
  0 <= t <= 3 / 32 -> 30 * u <= r ->
  let slack := way_slack turn norm t r in let error := way_error kB turn t r slack in slack < / 16 ->
  turn * t + norm * t + r <= 0.0626 /\ error <= 3 / 32 /\ 4 * u <= error /\
  (turn * t + r) * (1 + 6 * (turn * t + norm * t + r)) * (1 - 8.3 * u) <= error.
Proof.
  intros kB turn norm t r HB Ft Fn Fr T0 N0 Ht Hr slack error Hs. generalize u_pos u_val underflow_tiny.
  intros U0 Hu [tau0 tau1].
  destruct (slack_parts turn norm t r Ft Fn Fr T0 N0 ltac:(lra) ltac:(lra)) as [S1 [S2 [S3 S4]]].
  fold slack in S1, S2, S3, S4. replace ((turn + norm) * t) with (turn * t + norm * t) in S4 by ring.
  assert (Tt : 0 <= turn * t) by (apply Rmult_le_pos; lra). assert (Nt : 0 <= norm * t) by (apply Rmult_le_pos; lra).
  set (T := turn * t) in *. set (N := norm * t) in *. set (eta := T + N + r) in *.
  assert (e1 : eta <= 0.0626) by (rewrite Hu in *; lra). assert (e0 : 30 * u <= eta) by (unfold eta; lra).
  split; [exact e1|].
  set (q := rnd (rnd T + r)) in *. assert (X0 : 0 <= rnd T) by apply rnd_nonneg, Tt.
  assert (q0 : 0 <= q) by (apply rnd_nonneg; lra).
  unfold error, way_error. change (turn * t) with T. fold q. set (w := rnd (kB * slack)). set (v := rnd (1 + w)).
  assert (s0 : 0 <= slack) by lra.
  assert (B1 : 6 * slack <= kB * slack) by (apply Rmult_le_compat_r; lra).
  assert (B2 : kB * slack <= 8 * slack) by (apply Rmult_le_compat_r; lra).
  assert (W0 := rnd_at_least (kB * slack) ltac:(lra)). fold w in W0.
  assert (w0 : 0 <= w) by (apply rnd_nonneg; lra).
  assert (V0 := rnd_at_least (1 + w) ltac:(lra)). fold v in V0. assert (v0 : 0 <= v) by (apply rnd_nonneg; lra).
  assert (qv : 0 <= q * v) by (apply Rmult_le_pos; assumption).
  assert (E0 := rnd_at_least (q * v) qv).
  (* from above *)
  assert (P1 : bpow radix2 (-1) = / 2) by reflexivity.
  assert (F12 : fmt (/ 2)) by (replace (/ 2) with (IZR 1 * bpow radix2 (-1)) by (rewrite P1; lra); apply fmt_of_parts;
    lia).
  assert (F32 : fmt (3 / 2)) by (replace (3 / 2) with (IZR 3 * bpow radix2 (-1)) by (rewrite P1; lra); apply
    fmt_of_parts; lia).
  assert (F332 : fmt (3 / 32)).
  { replace (3 / 32) with (IZR 3 * bpow radix2 (-5)) by (change (bpow radix2 (-5)) with (/ 32); lra). apply
    fmt_of_parts; lia. }
  assert (w1 : w <= / 2) by (apply rnd_below; [exact F12 | lra]).
  assert (v1 : v <= 3 / 2) by (apply rnd_below; [exact F32 | lra]).
  assert (qv1 : q * v <= / 16 * (3 / 2)) by (apply Rmult_le_compat; lra).
  split; [apply rnd_below; [exact F332 | lra]|].
  (* from below *)
  assert (R1 := rnd_at_least T Tt).
  assert (R2 := rnd_plus (rnd T) r (fmt_rnd _) Fr). rewrite (Rabs_pos_eq (rnd T + r)) in R2 by lra. fold q in R2.
  apply Rabs_le_inv in R2.
  assert (Hq : (T + r) * (1 - 2.1 * u) <= q).
  { assert ((T * (1 - u) - u * tau + r) * (1 - u) <= (rnd T + r) * (1 - u)) by (apply Rmult_le_compat_r; [rewrite Hu;
    lra | lra]).
    rewrite Hu in *. lra. }
  assert (W1 : 6 * slack * (1 - u) <= kB * slack * (1 - u)) by (apply Rmult_le_compat_r; [rewrite Hu; lra | exact B1]).
  assert (W2 : 6 * (eta * (1 - 3.01 * u) - 3 * (u * tau)) * (1 - u) <= 6 * slack * (1 - u))
    by (apply Rmult_le_compat_r; [rewrite Hu; lra | lra]).
  assert (W3 : 6 * eta * (1 - 4.1 * u) - 20 * (u * tau) <= w) by (rewrite Hu in *; lra).
  assert (V1 : (1 + 6 * eta) * (1 - 5.1 * u) <= v).
  { assert ((1 + (6 * eta * (1 - 4.1 * u) - 20 * (u * tau))) * (1 - u) <= (1 + w) * (1 - u))
      by (apply Rmult_le_compat_r; [rewrite Hu; lra | lra]). rewrite Hu in *. lra. }
  set (Q := T + r) in *. assert (Q1 : 30 * u <= Q) by (unfold Q; lra).
  assert (QV : Q * (1 - 2.1 * u) * ((1 + 6 * eta) * (1 - 5.1 * u)) <= q * v).
  { apply Rmult_le_compat; try assumption; apply Rmult_le_pos; rewrite ?Hu in *; lra. }
  set (m := Q * (1 + 6 * eta)) in *.
  assert (m1 : Q <= m) by (unfold m; assert (0 <= Q * (6 * eta)) by (apply Rmult_le_pos; lra); lra).
  replace (Q * (1 - 2.1 * u) * ((1 + 6 * eta) * (1 - 5.1 * u))) with (m * ((1 - 2.1 * u) * (1 - 5.1 * u))) in QV
    by (unfold m; ring).
  assert (E1 : m * ((1 - 2.1 * u) * (1 - 5.1 * u)) * (1 - u) <= q * v * (1 - u))
    by (apply Rmult_le_compat_r; [rewrite Hu; lra | exact QV]).
  assert (E2 : m * (1 - 8.3 * u) <= rnd (q * v)) by (rewrite Hu in *; lra).
  split; [rewrite Hu in *; lra | exact E2].
Qed.

(* ---- Tangents ---- *)

Lemma tangent_weaken : forall s t y P, tangent_at_most s y P -> s <= t -> tangent_at_most t y P.
Proof.
  intros s t y P [H1 H2] H. split; [exact H1|]. eapply Rle_trans; [exact H2|]. apply Rmult_le_compat_r; lra.
Qed.
Lemma tangent_of_multiple : forall k t y P, 0 < k -> tangent_at_most t y (vscale k P) -> tangent_at_most t y P.
Proof.
  intros k t y P K [H1 H2]. rewrite (dot_sym (vscale k P)), dot_scale_right, (dot_sym y) in H1, H2.
  replace (cross (vscale k P) y) with (vscale k (cross P y)) in H2 by (clear; vdestruct; apply vec_eq; cbn; ring).
  rewrite len_scale in H2 by lra. split; [nra|]. apply Rmult_le_reg_l with k; [exact K | lra].
Qed.

Lemma square_of_parts : forall e Y m, dot m e = 0 ->
  len Y * len Y <= len (in_plane e Y) * len (in_plane e Y) + len (vsub Y m) * len (vsub Y m).
Proof.
  intros e Y m M. assert (O := across_plane e Y). set (out := vscale (dot Y e / dot e e) e) in *.
  assert (E : len Y * len Y = len (in_plane e Y) * len (in_plane e Y) + len out * len out).
  { rewrite !len_sq. rewrite (whole_of_parts e Y) at 1 2. fold out.
    replace (dot (vadd (in_plane e Y) out) (vadd (in_plane e Y) out)) with
      (dot (in_plane e Y) (in_plane e Y) + 2 * dot (in_plane e Y) out + dot out out)
      by (generalize (in_plane e Y) out; clear; intros; vdestruct; vunfold; ring). rewrite O. ring. }
  assert (L : len out <= len (vsub Y m)).
  { assert (E2 : out = vscale (dot (vsub Y m) e / dot e e) e).
    { unfold out. f_equal. f_equal. rewrite (dot_sym (vsub Y m)), dot_sub_right, (dot_sym e m), M, (dot_sym e Y). ring.
      }
    rewrite E2. rewrite (whole_of_parts e (vsub Y m)) at 2.
    replace (vadd (in_plane e (vsub Y m)) (vscale (dot (vsub Y m) e / dot e e) e)) with
      (vadd (vscale (dot (vsub Y m) e / dot e e) e) (in_plane e (vsub Y m))) by (apply vec_eq; cbn; ring).
    apply part_is_shorter. rewrite dot_sym. apply across_plane. }
  assert (L0 := len_nonneg out). rewrite E. apply Rplus_le_compat_l. apply Rmult_le_compat; assumption.
Qed.

Lemma known_opposite : forall e y U t, known e y U t -> known e (vscale (-1) y) (vscale (-1) U) t.
Proof.
  intros e y U t [F S Lv [T1 T2] B].
  assert (L : len (vscale (-1) U) = len U).
  { rewrite len_scale_any. replace (Rabs (-1)) with 1 by (rewrite Rabs_left; lra). ring. }
  assert (D : forall k a b, dot (vscale k a) b = k * dot a b) by (intros; unfold dot, vscale; cbn; ring).
  split.
  - rewrite D, F. ring.
  - rewrite L. exact S.
  - rewrite D, L, Rabs_mult. replace (Rabs (-1)) with 1 by (rewrite Rabs_left; lra). lra.
  - rewrite in_plane_scale. split; rewrite D, dot_scale_right.
    + lra.
    + replace (cross (vscale (-1) (in_plane e U)) (vscale (-1) y)) with (cross (in_plane e U) y)
        by (generalize (in_plane e U); clear; intros; vdestruct; apply vec_eq; cbn; ring). lra.
  - exact B.
Qed.
Lemma shortened_opposite : forall i f Y, shortened (-1 * i) f Y = vscale (-1) (shortened i f Y).
Proof.
  intros i f Y. assert (O : forall x, rnd (-1 * i * x) = -1 * rnd (i * x)).
  { intro x. replace (-1 * i * x) with (- (i * x)) by ring. unfold rnd. rewrite round_NE_opp. ring. }
  unfold shortened, rscale, vscale. cbn. rewrite !O. reflexivity.
Qed.

Lemma divided_sum : forall i a b m, i <> 0 ->
  vsub (vscale (/ i) (vadd (vscale i a) b)) m = vadd (vscale (/ i) b) (vsub a m).
Proof. intros i a b m I. apply vec_eq; cbn; field; exact I. Qed.

(* ---- The theorem ---- *)

Ltac products := repeat match goal with |- 0 <= _ * _ => apply Rmult_le_pos end.

Theorem crossing_known : forall p0 p1 q k0 k1 c0 U gc Dc hc S d L Lq y t c c2 kB height nc sigma,
  polygon p0 p1 q k0 k1 c0 ->
  way_inputs p0 p1 q k0 k1 U gc Dc hc S d L Lq -> known (vsub p1 p0) y U t ->
  36.5 * u <= c -> 1.6 * u <= c2 -> 6 <= kB <= 8 ->
  fmt3 nc -> len (vsub nc (vsub k1 k0)) <= u * len (vsub k1 k0) -> / 10 ^ 26 <= len (vsub k1 k0) <= 10 ^ 26 ->
  corner_height p0 p1 q k0 k1 c0 * (1 - 20 * u) <= height ->
  let Y := way_vector U gc hc Dc in let i := way_inverse Y in let r := way_rounding c Lq i in
  let angle := way_angle c2 hc S in let turn := way_turn angle height i in let norm := way_norm angle height i in
  let slack := way_slack turn norm t r in
  len Y <= 10 ^ 160 -> 0 < i -> slack < / 16 -> sigma = 1 \/ sigma = -1 ->
  4 * u <= way_error kB turn t r slack <= 3 / 32 /\
  known (vsub k1 k0) (vscale sigma (step p0 p1 q y k0 k1)) (shortened (sigma * i) nc Y) (way_error kB turn t r slack).
Proof.
  intros p0 p1 q k0 k1 c0 U gc Dc hc S d L Lq y t c c2 kB height nc sigma Poly In K Hc Hc2 HB Fnc Near Edge Height
    Y i r angle turn norm slack High i0 Hs Sigma.
  generalize u_pos u_val (power_positive 26) (power_positive 140). intros U0 Hu P26 P140.
  assert (Ht : 0 <= t <= 3 / 32) by (generalize (error_is_small _ _ _ _ K); lra).
  assert (h0 : 0 <= height).
  { eapply Rle_trans; [|exact Height]. apply Rmult_le_pos; [apply sqrt_pos | rewrite Hu; lra]. }
  destruct (bound_of_slack _ _ _ _ _ _ _ _ _ _ _ _ _ t c c2 height In Hc Hc2 h0 ltac:(lra) i0 Hs) as
    [Fr [Ft [Fn [Fa [r0 [rs [A1 _]]]]]]]. fold Y i r angle turn norm in Fr, Ft, Fn, Fa, r0, rs, A1.
  assert (a0 : 0 <= angle) by (generalize (Rabs_pos (h p0 p1 q)); lra).
  destruct (way_core _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ c In K Hc High i0 rs) as
    [[d0 [S1 S2]] [[Off [I1 _]] [Low [Unit [R1 [Q1 i70]]]]]]. fold Y i r in Off, Low, Unit, R1, Q1, i70.
  destruct (crossing_flat _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ c Poly In K Hc High i0 rs) as [_ [_ Flat]]. fold Y in Flat.
  destruct (turn_at_least angle height i Fa a0 h0 (conj i0 i70)) as [turn0 B1]. fold turn in turn0, B1.
  destruct (norm_at_least angle height i a0 (conj i0 i70)) as [norm0 B2]. fold norm in norm0, B2.
  set (n := vsub k1 k0) in *. set (P := in_plane (vsub p1 p0) U) in *.
  set (image := step p0 p1 q P k0 k1) in *. set (l := len Y) in *. set (LL := L * L) in *.
  destruct (shortened_right n nc Y i Fnc (way_vector_format _ _ _ _) Near Edge Low Flat Unit) as [Short [Main _]].
  fold Y in Short, Main. set (U1 := shortened i nc Y) in *. set (V1 := in_plane n U1) in *.
  assert (Zi : dot image n = 0) by (apply (image_in_facet _ _ _ _ _ c0); [exact Poly | apply in_plane_orthogonal]).
  (* sizes over |Y| *)
  assert (G0 : / 10 ^ 26 <= L) by (generalize (way_range _ _ _ _ _ _ _ _ _ _ _ _ _ In); lra).
  assert (LL0 : 0 < LL) by (apply Rmult_lt_0_compat; lra).
  assert (uLL : 0 < u * LL) by (apply Rmult_lt_0_compat; lra).
  assert (lu : l <= 1.2074 * LL) by (assert (F := len_from Y image); fold l in F; rewrite Hu in *; lra).
  set (lam := i * (u * LL)) in *. assert (lam0 : 0 < lam) by (apply Rmult_lt_0_compat; assumption).
  assert (il : u * (i * l) <= 1.2074 * lam).
  { unfold lam. replace (1.2074 * (i * (u * LL))) with (u * (i * (1.2074 * LL))) by ring.
    apply Rmult_le_compat_l; [lra|]. apply Rmult_le_compat_l; lra. }
  assert (il1 : u * (1 - 3.6 * u) <= u * (i * l)) by (apply Rmult_le_compat_l; lra).
  assert (r30 : 30 * u <= r) by (rewrite Hu in *; lra).
  set (s := len (vsub Y image)) in *. assert (s0 : 0 <= s) by apply len_nonneg.
  assert (is : i * s <= 24.51 * lam).
  { unfold lam. replace (24.51 * (i * (u * LL))) with (i * (24.51 * (u * LL))) by ring. apply Rmult_le_compat_l; lra. }
  assert (is0 : 0 <= i * s) by (apply Rmult_le_pos; lra).
  assert (l0 : 0 < l) by lra.
  (* the part in the plane *)
  assert (Part : V1 = vadd (vscale i (in_plane n Y)) (in_plane n (vsub U1 (vscale i (in_plane n Y))))).
  { unfold V1. rewrite in_plane_sub, in_plane_scale, (in_plane_id n (in_plane n Y)) by apply in_plane_orthogonal.
    apply vec_eq; cbn; ring. }
  set (W := in_plane n (vsub U1 (vscale i (in_plane n Y)))) in *.
  assert (LW : len W <= 6.6 * u) by (eapply Rle_trans; [apply in_plane_len | exact Main]).
  set (z := len V1) in *.
  assert (Long : 1 - 10.2 * u - 1.0001 * ((i * s) * (i * s)) <= z).
  { assert (Sq := square_of_parts n Y image Zi). fold l s in Sq. set (m := len (in_plane n Y)) in *.
    assert (m0 : 0 <= m) by apply len_nonneg.
    assert (A : i * l - 1.00005 * ((i * s) * (i * s)) <= i * m).
    { set (x := i * l) in *. set (v := (i * s) * (i * s)) in *. set (w := i * m).
      assert (w0 : 0 <= w) by (apply Rmult_le_pos; lra).
      assert (X : x * x <= w * w + v).
      { replace (x * x) with (i * i * (l * l)) by (unfold x; ring). replace (w * w + v) with
          (i * i * (m * m + s * s)) by (unfold w, v; ring). apply Rmult_le_compat_l; [apply Rle_0_sqr | exact Sq]. }
      assert (v0 : 0 <= v) by apply Rle_0_sqr.
      apply Rnot_lt_le. intro Neg.
      assert (w * w <= w * (x - 1.00005 * v)) by (apply Rmult_le_compat_l; lra).
      assert (w * x <= (x - 1.00005 * v) * x) by (apply Rmult_le_compat_r; [rewrite Hu in *; lra | lra]).
      assert (0 <= w * v) by (apply Rmult_le_pos; lra).
      assert (1.00005 * v * (1 - 3.6 * u) <= 1.00005 * v * x) by (apply Rmult_le_compat_l; lra).
      destruct v0 as [v0|v0]; [|rewrite <- v0 in *; nra]. rewrite Hu in *. nra. }
    assert (T : i * m <= z + len W).
    { replace (i * m) with (len (vscale i (in_plane n Y))) by (rewrite len_scale by lra; reflexivity).
      eapply Rle_trans; [apply (len_from _ V1)|]. apply Rplus_le_compat_l. rewrite Part.
      replace (vsub (vscale i (in_plane n Y)) (vadd (vscale i (in_plane n Y)) W)) with (vscale (-1) W)
        by (apply vec_eq; cbn; ring). rewrite len_scale_any. replace (Rabs (-1)) with 1 by (rewrite Rabs_left; lra).
          lra. }
    assert (0 <= (i * s) * (i * s)) by apply Rle_0_sqr. lra. }
  destruct (inverse_of_short z r (i * s) ltac:(lra) ltac:(lra) Long) as [z0 [Z1 [Z2 Z3]]].
  (* the bound *)
  destruct (error_covers kB turn norm t r HB Ft Fn Fr turn0 norm0 Ht r30 Hs) as [Sum [E1 [E2 E3]]].
  fold slack in E1, E2, E3. set (error := way_error kB turn t r slack) in *.
  set (w := / (1 - 20 * u)). assert (w1 : 0 < w <= 1 + 20.01 * u).
  { unfold w. assert (0 < 1 - 20 * u) by (rewrite Hu; lra). split; [apply Rinv_0_lt_compat; assumption|].
    apply Rmult_le_reg_r with (1 - 20 * u); [assumption|]. rewrite Rinv_l by lra. rewrite Hu. lra. }
  assert (Hw : corner_height p0 p1 q k0 k1 c0 <= height * w).
  { apply Rmult_le_reg_r with (1 - 20 * u); [rewrite Hu; lra|]. rewrite Rmult_assoc. unfold w. rewrite Rinv_l by
    (rewrite Hu; lra).
    lra. }
  set (ch := corner_height p0 p1 q k0 k1 c0) in *. assert (ch0 : 0 <= ch) by apply sqrt_pos.
  set (ah := Rabs (h p0 p1 q)) in *. assert (ah0 : 0 <= ah) by apply Rabs_pos.
  set (K4 := 4 * angle * height * i * i) in *. set (M2 := 2 * Rmax angle height * i) in *.
  assert (Mx := Rmax_l angle height). assert (My := Rmax_r angle height). set (big := Rmax angle height) in *.
  assert (K40 : 0 <= K4) by (unfold K4; products; lra).
  assert (M20 : 0 <= M2) by (unfold M2; products; lra).
  set (kappa := K4 * (w * (1 + 33 * u)) * (/ z * / z)). set (tau' := M2 * (w * (1 + 16 * u)) * / z).
  set (r1 := 32.5 * lam * / z). assert (zi0 : 0 < / z) by (apply Rinv_0_lt_compat, z0).
  assert (zz0 : 0 < / z * / z) by (apply Rmult_lt_0_compat; assumption).
  assert (k0' : 0 <= kappa) by (unfold kappa; products; lra).
  assert (n0' : 0 <= tau') by (unfold tau'; products; lra).
  assert (r1' : 0 <= r1 <= 0.893 * r).
  { unfold r1. split; [apply Rmult_le_pos; lra|]. apply Rle_trans with (32.5 * lam * 1.0021); [apply Rmult_le_compat_l;
    lra | lra]. }
  assert (Tt : 0 <= turn * t) by (apply Rmult_le_pos; lra). assert (Nt : 0 <= norm * t) by (apply Rmult_le_pos; lra).
  set (T := turn * t) in *. set (N := norm * t) in *. set (e := / 10 ^ 100 * u) in *.
  assert (e0 : 0 <= e <= / 10 ^ 90 * u * 0.5) by (unfold e; rewrite Hu; lra).
  assert (rr0 : 0 <= r * r) by apply Rle_0_sqr.
  assert (rr1 : r * r <= 0.0626 * 0.0626) by (apply Rmult_le_compat; lra).
  assert (Kt : kappa * t <= (T + / 10 ^ 90 * u) * (1 + 80 * u + 0.93 * (r * r))).
  { assert (X1 : K4 * t * (1 - 3.01 * u) <= T + e).
    { replace (K4 * t * (1 - 3.01 * u)) with (K4 * (1 - 3.01 * u) * t) by ring.
      apply Rle_trans with ((turn + e) * t); [apply Rmult_le_compat_r; lra|]. unfold T.
      assert (e * t <= e * 1) by (apply Rmult_le_compat_l; lra). lra. }
    assert (Kt0 : 0 <= K4 * t) by (apply Rmult_le_pos; lra).
    assert (X2 : K4 * t <= (T + e) * (1 + 3.02 * u)).
    { apply Rmult_le_reg_r with (1 - 3.01 * u); [rewrite Hu; lra|]. eapply Rle_trans; [exact X1|].
      rewrite Rmult_assoc. rewrite <- (Rmult_1_r (T + e)) at 1. apply Rmult_le_compat_l; [lra | rewrite Hu; lra]. }
    assert (X3 : w * (1 + 33 * u) <= 1 + 53.1 * u).
    { apply Rle_trans with ((1 + 20.01 * u) * (1 + 33 * u)); [apply Rmult_le_compat_r; lra | rewrite Hu; lra]. }
    assert (X4 : w * (1 + 33 * u) * (/ z * / z) <= (1 + 53.1 * u) * (1 + 22 * u + 0.92 * (r * r))).
    { apply Rmult_le_compat; try lra. apply Rmult_le_pos; lra. }
    replace (kappa * t) with (K4 * t * (w * (1 + 33 * u) * (/ z * / z))) by (unfold kappa; ring).
    apply Rle_trans with ((T + e) * (1 + 3.02 * u) * ((1 + 53.1 * u) * (1 + 22 * u + 0.92 * (r * r)))).
    - apply Rmult_le_compat; try lra. products; lra.
    - rewrite Rmult_assoc. apply Rmult_le_compat; try lra.
      + products; lra.
      + rewrite Hu in *. lra. }
  assert (Nb : tau' * t <= (N + / 10 ^ 90 * u) * (1 + 80 * u + 0.93 * (r * r))).
  { assert (X1 : M2 * t * (1 - 2.01 * u) <= N + e).
    { replace (M2 * t * (1 - 2.01 * u)) with (M2 * (1 - 2.01 * u) * t) by ring.
      apply Rle_trans with ((norm + e) * t); [apply Rmult_le_compat_r; lra|]. unfold N.
      assert (e * t <= e * 1) by (apply Rmult_le_compat_l; lra). lra. }
    assert (Mt0 : 0 <= M2 * t) by (apply Rmult_le_pos; lra).
    assert (X2 : M2 * t <= (N + e) * (1 + 2.02 * u)).
    { apply Rmult_le_reg_r with (1 - 2.01 * u); [rewrite Hu; lra|]. eapply Rle_trans; [exact X1|].
      rewrite Rmult_assoc. rewrite <- (Rmult_1_r (N + e)) at 1. apply Rmult_le_compat_l; [lra | rewrite Hu; lra]. }
    assert (X3 : w * (1 + 16 * u) <= 1 + 36.1 * u).
    { apply Rle_trans with ((1 + 20.01 * u) * (1 + 16 * u)); [apply Rmult_le_compat_r; lra | rewrite Hu; lra]. }
    assert (X4 : w * (1 + 16 * u) * / z <= (1 + 36.1 * u) * (1 + 11 * u + 0.46 * (r * r))).
    { apply Rmult_le_compat; try lra. apply Rmult_le_pos; lra. }
    replace (tau' * t) with (M2 * t * (w * (1 + 16 * u) * / z)) by (unfold tau'; ring).
    apply Rle_trans with ((N + e) * (1 + 2.02 * u) * ((1 + 36.1 * u) * (1 + 11 * u + 0.46 * (r * r)))).
    - apply Rmult_le_compat; try lra. products; lra.
    - rewrite Rmult_assoc. apply Rmult_le_compat; try lra.
      + products; lra.
      + rewrite Hu in *. lra. }
  destruct (rule_of_errors T N r (kappa * t) (tau' * t) r1 Tt Nt r30 Sum Kt Nb
    ltac:(apply Rmult_le_pos; lra) ltac:(apply Rmult_le_pos; lra) r1') as [Eta Rule].
  (* the tangent *)
  set (V2 := vscale (/ i) V1). assert (ii0 : 0 < / i) by (apply Rinv_0_lt_compat, i0).
  assert (LV : len V2 = / i * z) by (unfold V2; rewrite len_scale by lra; reflexivity).
  set (delta := vsub V2 image). assert (EV : vadd image delta = V2) by (unfold delta; apply vec_eq; cbn; ring).
  assert (Delta : len delta <= r1 * len V2).
  { assert (ED : delta = vadd (vscale (/ i) W) (in_plane n (vsub Y image))).
    { unfold delta, V2. rewrite Part, in_plane_sub, (in_plane_id n image Zi).
      apply divided_sum. lra. }
    rewrite ED. eapply Rle_trans; [apply len_triangle|]. rewrite len_scale by lra.
    assert (X1 := in_plane_len n (vsub Y image)). fold s in X1.
    apply Rmult_le_reg_l with i; [exact i0|]. rewrite LV.
    replace (i * (r1 * (/ i * z))) with (32.5 * lam) by (unfold r1; field; lra).
    apply Rle_trans with (len W + i * s).
    - rewrite Rmult_plus_distr_l, <- Rmult_assoc, Rinv_r, Rmult_1_l by lra. apply Rplus_le_compat_l, Rmult_le_compat_l;
      lra.
    - rewrite Hu in *. lra. }
  assert (LP : len P <= 1 + 16 * u) by (apply (out_of_plane _ _ _ _ K)). assert (LP0 := len_nonneg P).
  assert (LP2 : len P * len P <= 1 + 33 * u).
  { apply Rle_trans with ((1 + 16 * u) * (1 + 16 * u)); [apply Rmult_le_compat; lra | rewrite Hu; lra]. }
  assert (Det : sqrt (determinant_square p0 p1 q k0 k1 c0) * (len P * len P) <= kappa * (len V2 * len V2)).
  { rewrite (root_of_determinant _ _ _ _ _ _ Poly), LV. fold ah ch.
    replace (kappa * (/ i * z * (/ i * z))) with (4 * angle * (height * w) * (1 + 33 * u))
      by (unfold kappa, K4; field; lra).
    apply Rmult_le_compat; try lra.
    - products; lra.
    - apply Rle_0_sqr.
    - apply Rmult_le_compat; lra. }
  assert (Norm : sqrt (norm_square p0 p1 q k0 k1 c0) * len P <= tau' * len V2).
  { rewrite (root_of_norm _ _ _ _ _ _ Poly), LV. fold ah ch.
    replace (tau' * (/ i * z)) with (2 * (big * w) * (1 + 16 * u)) by (unfold tau', M2; field; lra).
    assert (w2 : 1 <= w).
    { unfold w. rewrite <- Rinv_1. apply Rinv_le; rewrite Hu; lra. }
    assert (Bw : big * 1 <= big * w) by (apply Rmult_le_compat_l; lra).
    assert (Hb : height * w <= big * w) by (apply Rmult_le_compat_r; lra).
    assert (Rmax ah ch <= big * w) by (apply Rmax_lub; lra).
    assert (0 <= Rmax ah ch) by (eapply Rle_trans; [exact ah0 | apply Rmax_l]).
    apply Rmult_le_compat; lra. }
  assert (V20 : 0 < len V2) by (rewrite LV; apply Rmult_lt_0_compat; lra).
  assert (Turn := tangent_behind p0 p1 q k0 k1 c0 Poly y P t delta kappa tau' r1 (in_facet _ _ _ _ K)
    (in_plane_orthogonal _ _) (angle_is_small _ _ _ _ K) (proj1 Ht)). cbv beta zeta in Turn. fold image in Turn.
  rewrite EV in Turn. specialize (Turn V20 k0' n0' (proj1 r1') Det Norm Delta Eta).
  assert (Turn2 := tangent_of_multiple _ _ _ _ ii0 Turn).
  assert (Turn3 := tangent_weaken _ error _ _ Turn2 ltac:(eapply Rle_trans; [exact Rule | exact E3])).
  split; [split; assumption|].
  assert (Known : known n (step p0 p1 q y k0 k1) U1 error).
  { split.
    - apply (image_in_facet _ _ _ _ _ c0); [exact Poly | apply (in_facet _ _ _ _ K)].
    - lra.
    - assert (A : dot U1 n = dot (vsub U1 (vscale i (in_plane n Y))) n).
      { rewrite (dot_sym (vsub _ _)), dot_sub_right, dot_scale_right, (dot_sym n (in_plane n Y)), in_plane_orthogonal,
          (dot_sym n U1). ring. }
      rewrite A. eapply Rle_trans; [apply dot_len|].
      assert (LU : 0.9 <= len U1).
      { apply Rle_trans with z; [|apply in_plane_len].
        assert ((i * s) * (i * s) <= 0.672 * 0.0626 * (0.672 * 0.0626)) by (apply Rmult_le_compat; lra).
        rewrite Hu in *. lra. }
      assert (len (vsub U1 (vscale i (in_plane n Y))) * len n <= 6.6 * u * len n) by (apply Rmult_le_compat_r; lra).
      assert (0 < u * len n) by (apply Rmult_lt_0_compat; lra).
      assert (0.9 * (u * len n) <= len U1 * (u * len n)) by (apply Rmult_le_compat_r; lra). lra.
    - exact Turn3.
    - lra. }
  destruct Sigma as [->| ->].
  - rewrite Rmult_1_l. replace (vscale 1 (step p0 p1 q y k0 k1)) with (step p0 p1 q y k0 k1) by (apply vec_eq; cbn;
    ring).
    exact Known.
  - rewrite shortened_opposite. apply known_opposite. exact Known.
Qed.
