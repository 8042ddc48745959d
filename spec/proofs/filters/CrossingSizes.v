(* What src/flow/kernels/direction_across.h makes of the vector behind a facet, as real numbers and roundings.
   `slack_parts`, `turn_at_least`: its bound is not less than it should be. `crossing_sizes`: where the bound is small,
   no length that it is made of is tiny, and the height is not large. `crossing_flat`: the vector is nearly in the next
   facet. `sign_of_way_right`: the sign that the code takes for the factor is the true one. *)
From Coq Require Import Reals Lra Lia Psatz.
From Flocq Require Import Core.
From Flowcert Require Import algebra.Vector3 algebra.Cascade algebra.Crossing filters.Rounding filters.RoundedVectors
  filters.Norms filters.Floors filters.Terms filters.Directions filters.DirectionSigns filters.DirectionVectors
  filters.CrossingVectors.
Open Scope R_scope.

(* ---- The slack ---- *)

Lemma slack_parts : forall turn norm t r, fmt turn -> fmt norm -> fmt r -> 0 <= turn -> 0 <= norm -> 0 <= t <= 1 -> 0
  <= r ->
  let slack := way_slack turn norm t r in
  r <= slack /\ rnd (turn * t) <= slack /\ rnd (rnd (turn * t) + r) <= slack /\
  ((turn + norm) * t + r) * (1 - 3.01 * u) - 3 * (u * tau) <= slack.
Proof.
  intros turn norm t r Ft Fn Fr T0 N0 [t0 t1] r0 slack. generalize u_pos u_val underflow_tiny. intros U0 Hu [tau0 _].
  assert (S1 : turn <= rnd (turn + norm)) by (apply rnd_above; [exact Ft | lra]).
  assert (S2 : turn * t <= rnd (turn + norm) * t) by (apply Rmult_le_compat_r; lra).
  assert (S3 := rnd_mono _ _ S2). assert (X0 : 0 <= rnd (turn * t)) by (apply rnd_nonneg, Rmult_le_pos; assumption).
  unfold slack, way_slack. set (x := rnd (rnd (turn + norm) * t)) in *.
  split; [apply rnd_above; [exact Fr | lra]|]. split; [eapply Rle_trans; [exact S3 | apply rnd_above; [apply fmt_rnd |
    lra]]|].
  split; [apply rnd_mono; lra|].
  assert (A0 : 0 <= turn + norm) by lra.
  assert (A1 : (turn + norm) * (1 - u) <= rnd (turn + norm)).
  { assert (P := rnd_plus turn norm Ft Fn). rewrite (Rabs_pos_eq (turn + norm)) in P by exact A0.
    apply Rabs_le_inv in P. lra. }
  assert (A2 : (turn + norm) * (1 - u) * t <= rnd (turn + norm) * t) by (apply Rmult_le_compat_r; lra).
  set (K := (turn + norm) * t) in *. assert (K0 : 0 <= K) by (apply Rmult_le_pos; lra).
  replace ((turn + norm) * (1 - u) * t) with (K * (1 - u)) in A2 by (unfold K; ring).
  assert (A3 := rnd_at_least (rnd (turn + norm) * t) ltac:(assert (0 <= K * (1 - u)) by (apply Rmult_le_pos; rewrite
    ?Hu; lra); lra)).
  fold x in A3.
  assert (A4 : K * (1 - u) * (1 - u) <= rnd (turn + norm) * t * (1 - u)) by (apply Rmult_le_compat_r; [rewrite Hu; lra
    | exact A2]).
  assert (X1 : 0 <= x) by lra.
  assert (A5 := rnd_plus x r (fmt_rnd _) Fr). rewrite (Rabs_pos_eq (x + r)) in A5 by lra. apply Rabs_le_inv in A5.
  assert (A6 : (K * (1 - u) * (1 - u) - u * tau + r) * (1 - u) <= (x + r) * (1 - u))
    by (apply Rmult_le_compat_r; [rewrite Hu; lra | lra]).
  rewrite Hu in *. lra.
Qed.

Lemma turn_at_least : forall angle height i, fmt angle -> 0 <= angle -> 0 <= height -> 0 < i <= 10 ^ 70 ->
  let turn := way_turn angle height i in
  0 <= turn /\ 4 * angle * height * i * i * (1 - 3.01 * u) <= turn + / 10 ^ 100 * u.
Proof.
  intros angle height i Fa a0 h0 [i0 i1] turn. generalize u_pos u_val underflow_tiny. intros U0 Hu [T0 T].
  unfold turn, way_turn. rewrite (rnd_four angle Fa).
  assert (x0 : 0 <= 4 * angle * height) by (apply Rmult_le_pos; lra). set (x := 4 * angle * height) in *.
  assert (A1 := rnd_at_least x x0). set (z1 := rnd x) in *. assert (B1 : 0 <= z1) by (apply rnd_nonneg, x0).
  assert (c1 : 0 <= z1 * i) by (apply Rmult_le_pos; lra).
  assert (A2 := rnd_at_least _ c1). set (z2 := rnd (z1 * i)) in *. assert (B2 : 0 <= z2) by (apply rnd_nonneg, c1).
  assert (c2 : 0 <= z2 * i) by (apply Rmult_le_pos; lra).
  assert (A3 := rnd_at_least _ c2). split; [apply rnd_nonneg, c2|].
  assert (D1 : (x * (1 - u) - u * tau) * i <= z1 * i) by (apply Rmult_le_compat_r; lra).
  assert (D2 : (z1 * i * (1 - u) - u * tau) * i <= z2 * i) by (apply Rmult_le_compat_r; lra).
  assert (D3 : (x * (1 - u) - u * tau) * i * ((1 - u) * i) <= z1 * i * ((1 - u) * i))
    by (apply Rmult_le_compat_r; [apply Rmult_le_pos; rewrite ?Hu; lra | exact D1]).
  set (K := x * i * i). assert (K0 : 0 <= K) by (apply Rmult_le_pos; [apply Rmult_le_pos|]; lra).
  assert (ii : i * i <= 10 ^ 140).
  { replace (10 ^ 140) with (10 ^ 70 * 10 ^ 70) by (rewrite <- pow_add; reflexivity). apply Rmult_le_compat; lra. }
  assert (E1 : u * tau * (i * i) <= / 10 ^ 250 * u * 10 ^ 140) by (apply Rmult_le_compat; try lra; apply Rle_0_sqr).
  assert (E2 : u * tau * i <= / 10 ^ 250 * u * 10 ^ 70) by (apply Rmult_le_compat; lra).
  assert (E3 : 0 <= u * tau * (i * i)) by (apply Rmult_le_pos; [lra | apply Rle_0_sqr]).
  assert (E4 : 0 <= u * tau * i) by (apply Rmult_le_pos; lra).
  replace ((x * (1 - u) - u * tau) * i * ((1 - u) * i)) with (K * ((1 - u) * (1 - u)) - u * tau * (i * i) * (1 - u)) in
    D3
    by (unfold K; ring).
  assert (F1 : (K * ((1 - u) * (1 - u)) - u * tau * (i * i) * (1 - u) - u * tau * i) * (1 - u) <= z2 * i * (1 - u)).
  { apply Rmult_le_compat_r; [rewrite Hu; lra|]. lra. }
  fold K. set (e1 := u * tau * (i * i)) in *. set (e2 := u * tau * i) in *. rewrite Hu in *. lra.
Qed.

Lemma norm_at_least : forall angle height i, 0 <= angle -> 0 < i <= 10 ^ 70 ->
  let norm := way_norm angle height i in
  0 <= norm /\ 2 * Rmax angle height * i * (1 - 2.01 * u) <= norm + / 10 ^ 100 * u.
Proof.
  intros angle height i a0 [i0 i1] norm. generalize u_pos u_val underflow_tiny. intros U0 Hu [T0 T].
  assert (M := Rmax_l angle height). unfold norm, way_norm. set (m := 2 * Rmax angle height).
  assert (m0 : 0 <= m) by (unfold m; lra).
  assert (A1 := rnd_at_least m m0). assert (B1 := rnd_nonneg m m0).
  assert (c1 : 0 <= rnd m * i) by (apply Rmult_le_pos; lra). assert (A2 := rnd_at_least _ c1).
  split; [apply rnd_nonneg, c1|].
  assert (D : (m * (1 - u) - u * tau) * i <= rnd m * i) by (apply Rmult_le_compat_r; lra).
  assert (D2 : (m * (1 - u) - u * tau) * i * (1 - u) <= rnd m * i * (1 - u))
    by (apply Rmult_le_compat_r; [rewrite Hu; lra | exact D]).
  assert (mi : 0 <= m * i) by (apply Rmult_le_pos; lra).
  assert (E2 : u * tau * i <= / 10 ^ 250 * u * 10 ^ 70) by (apply Rmult_le_compat; lra).
  assert (E4 : 0 <= u * tau * i) by (apply Rmult_le_pos; lra).
  replace ((m * (1 - u) - u * tau) * i * (1 - u)) with (m * i * ((1 - u) * (1 - u)) - u * tau * i * (1 - u)) in D2 by
    ring.
  set (e2 := u * tau * i) in *. set (z := m * i) in *. rewrite Hu in *. lra.
Qed.

(* The enlarged angle is not less than the true one. *)
Lemma angle_at_least : forall hc hh S c2 GG, fmt hc -> / 10 ^ 52 <= GG -> 4 * Rabs hh <= GG ->
  Rabs (hc - hh) <= 1.3 * u * GG -> Rabs (S - GG) <= 7.01 * u * GG -> 1.6 * u <= c2 ->
  let angle := way_angle c2 hc S in Rabs hh <= angle /\ 1.59 * u * GG <= angle /\ 1.59 * u * GG <= rnd (c2 * S).
Proof.
  intros hc hh S c2 GG Fh HG Lh Nh NS Hc angle. generalize u_pos u_val. intros U0 Hu. assert (P52 := power_positive 52).
  assert (uG : 0 < u * GG) by (apply Rmult_lt_0_compat; lra). apply Rabs_le_inv in NS.
  assert (C : 1.6 * u * (GG * (1 - 7.01 * u)) <= c2 * S).
  { apply Rmult_le_compat; try lra. apply Rmult_le_pos; [lra | rewrite Hu; lra]. }
  assert (T1 : tau <= 1.6 * u * (GG * (1 - 7.01 * u))).
  { eapply Rle_trans; [apply (tau_below GG)|].
    - eapply Rle_trans; [|exact HG]. apply Rinv_le; [apply pow_lt; lra | apply Rle_pow; [lra | lia]].
    - rewrite Hu. lra. }
  assert (W := rnd_lower _ _ T1 C). set (w := rnd (c2 * S)) in *.
  assert (W1 : 1.59 * u * GG <= w) by (rewrite Hu in *; lra).
  assert (H0 := Rabs_pos hc).
  assert (A1 : Rabs hh - 1.3 * u * GG <= Rabs hc).
  { assert (A := Rabs_triang (hh - hc) hc). rewrite Rabs_minus_sym in A. replace (hh - hc + hc) with hh in A by ring.
    lra. }
  assert (Fa : fmt (Rabs hc)) by (apply generic_format_abs; exact Fh).
  unfold angle, way_angle. fold w. split; [|split; [|exact W1]].
  - assert (P := rnd_plus (Rabs hc) w Fa (fmt_rnd _)). rewrite (Rabs_pos_eq (Rabs hc + w)) in P by lra.
    apply Rabs_le_inv in P.
    destruct (Rle_lt_dec (Rabs hc) (Rabs hh)) as [L|L].
    + rewrite Hu in *. lra.
    + apply Rle_trans with (Rabs hc); [lra|]. apply rnd_above; [exact Fa | lra].
  - apply Rle_trans with w; [exact W1|]. apply rnd_above; [apply fmt_rnd | lra].
Qed.

(* ---- What a small bound says of the sizes ---- *)

Lemma bisector_from_first : forall p0 p1 q P, dot P (vsub p1 p0) = 0 -> dot P (bisector_g p0 p1 q) = 2 * dot P (vsub q
  p0).
Proof.
  intros p0 p1 q P H. replace (dot P (bisector_g p0 p1 q)) with (2 * dot P (vsub q p0) - dot P (vsub p1 p0)); [lra|].
  unfold bisector_g, dot, vadd, vsub. cbn. ring.
Qed.
Lemma bisector_from_second : forall p0 p1 q P, dot P (vsub p1 p0) = 0 ->
  dot P (bisector_g p0 p1 q) = 2 * dot P (vsub q p1).
Proof.
  intros p0 p1 q P H. replace (dot P (bisector_g p0 p1 q)) with (2 * dot P (vsub q p1) + dot P (vsub p1 p0)); [lra|].
  unfold bisector_g, dot, vadd, vsub. cbn. ring.
Qed.

(* Where q is near to an end of the edge, the image is short. *)
Lemma image_below : forall p0 p1 q k0 k1 P, dot P (vsub p1 p0) = 0 ->
  let a := vsub q p0 in let b := vsub q p1 in let x := len (step p0 p1 q P k0 k1) in
  x <= 2 * (len P * (len a * (len (D p0 p1 k0 k1) + len b))) /\ x <= 2 * (len P * (len b * (len (D p0 p1 k0 k1) + len
    a))).
Proof.
  intros p0 p1 q k0 k1 P H a b x.
  assert (T : x <= Rabs (dot P (bisector_g p0 p1 q)) * len (D p0 p1 k0 k1) + 2 * (len a * len b) * len P).
  { unfold x, step, A. eapply Rle_trans; [apply len_triangle|]. rewrite !len_scale_any, Rabs_mult, (Rabs_pos_eq 2) by
    lra.
    apply Rplus_le_compat_l, Rmult_le_compat_r; [apply len_nonneg|]. apply Rmult_le_compat_l; [lra|]. apply dot_len. }
  generalize (len_nonneg (D p0 p1 k0 k1)). intro D0. split.
  - rewrite (bisector_from_first _ _ _ _ H), Rabs_mult, (Rabs_pos_eq 2) in T by lra. assert (B := dot_len P a). fold a
    in T.
    assert (Rabs (dot P a) * len (D p0 p1 k0 k1) <= len P * len a * len (D p0 p1 k0 k1)) by (apply Rmult_le_compat_r;
      lra).
    lra.
  - rewrite (bisector_from_second _ _ _ _ H), Rabs_mult, (Rabs_pos_eq 2) in T by lra. assert (B := dot_len P b). fold b
    in T.
    assert (Rabs (dot P b) * len (D p0 p1 k0 k1) <= len P * len b * len (D p0 p1 k0 k1)) by (apply Rmult_le_compat_r;
      lra).
    lra.
Qed.

Lemma near_end_is_far : forall x a m b L n, x <= 2 * (m * (a * (n + b))) -> 0 <= a -> 0 <= m <= 1.0001 -> 0 <= n -> 0
  <= b ->
  n + b <= 1.7072 * L -> / 10 ^ 26 <= L -> 554 * (u * (L * L)) <= x -> L <= 10 ^ 14 * a /\ / 10 ^ 40 <= a.
Proof.
  intros x a m b L n H a0 m0 n0 b0 Hn HL Hx. generalize u_pos u_val (power_positive 26). intros U0 Hu P26.
  assert (A1 : a * (n + b) <= a * (1.7072 * L)) by (apply Rmult_le_compat_l; lra).
  assert (a1 : 0 <= a * (n + b)) by (apply Rmult_le_pos; lra).
  assert (A2 : m * (a * (n + b)) <= 1.0001 * (a * (1.7072 * L))) by (apply Rmult_le_compat; lra).
  assert (A3 : 554 * u * L <= 3.4149 * a).
  { apply Rmult_le_reg_r with L; [lra|].
    replace (554 * u * L * L) with (554 * (u * (L * L))) by ring. lra. }
  assert (A4 : L <= 10 ^ 14 * a) by (rewrite Hu in *; lra). split; [exact A4|]. lra.
Qed.

Lemma turn_nonneg : forall angle height i, 0 <= angle -> 0 <= height -> 0 <= i ->
  0 <= way_turn angle height i /\ 0 <= way_norm angle height i.
Proof.
  intros angle height i a0 h0 i0. assert (M := Rmax_l angle height).
  split; unfold way_turn, way_norm; repeat (apply rnd_nonneg; try apply Rmult_le_pos); lra.
Qed.

(* Where the slack is small, so is the rounding; and the enlarged angle is not less than the true one. *)
Lemma bound_of_slack : forall p0 p1 q k0 k1 U gc Dc hc S d L Lq t c c2 height,
  way_inputs p0 p1 q k0 k1 U gc Dc hc S d L Lq -> 36.5 * u <= c -> 1.6 * u <= c2 -> 0 <= height -> 0 <= t <= 1 ->
  let Y := way_vector U gc hc Dc in let i := way_inverse Y in let r := way_rounding c Lq i in
  let angle := way_angle c2 hc S in let turn := way_turn angle height i in let norm := way_norm angle height i in
  0 < i -> way_slack turn norm t r < / 16 ->
  fmt r /\ fmt turn /\ fmt norm /\ fmt angle /\ 0 <= r /\ r < / 16 /\ Rabs (h p0 p1 q) <= angle /\
  1.59 * u * (seen_from p0 p1 q * seen_from p0 p1 q) <= angle.
Proof.
  intros p0 p1 q k0 k1 U gc Dc hc S d L Lq t c c2 height In Hc Hc2 h0 Ht Y i r angle turn norm i0 Hs.
  generalize u_pos u_val (power_positive 26). intros U0 Hu P26.
  destruct (seen_by_both p0 p1 q) as [_ [Lh _]]. destruct In as [[_ [_ [_ Fh]]] _ Nh NS _ _ _ HLq [HG _]].
  set (G := seen_from p0 p1 q) in *.
  assert (GG : / 10 ^ 52 <= G * G).
  { replace (/ 10 ^ 52) with (/ 10 ^ 26 * / 10 ^ 26) by (rewrite <- Rinv_mult, <- pow_add; reflexivity).
    apply Rmult_le_compat; lra. }
  destruct (angle_at_least hc (h p0 p1 q) S c2 _ Fh GG Lh Nh NS Hc2) as [A1 [A2 _]]. fold angle in A1, A2.
  assert (a0 : 0 <= angle) by (generalize (Rabs_pos (h p0 p1 q)); lra).
  assert (r0 : 0 <= r).
  { apply rnd_nonneg, Rmult_le_pos; [|lra]. apply rnd_nonneg, Rmult_le_pos; [lra|]. eapply Rle_trans; [|exact HLq].
    apply Rmult_le_pos; [apply Rle_0_sqr | rewrite Hu; lra]. }
  destruct (turn_nonneg angle height i a0 h0 ltac:(lra)) as [turn0 norm0].
  destruct (slack_parts turn norm t r (fmt_rnd _) (fmt_rnd _) (fmt_rnd _) turn0 norm0 Ht r0) as [B _].
  repeat (split; [apply fmt_rnd|]). repeat split; lra.
Qed.

Theorem crossing_sizes : forall p0 p1 q k0 k1 U gc Dc hc S d L Lq y t c c2 height,
  way_inputs p0 p1 q k0 k1 U gc Dc hc S d L Lq -> known (vsub p1 p0) y U t -> 4 * u <= t ->
  36.5 * u <= c -> 1.6 * u <= c2 -> 0 <= height ->
  let Y := way_vector U gc hc Dc in let i := way_inverse Y in let r := way_rounding c Lq i in
  let angle := way_angle c2 hc S in let turn := way_turn angle height i in let norm := way_norm angle height i in
  let slack := way_slack turn norm t r in
  len Y <= 10 ^ 160 -> 0 < i -> slack < / 16 ->
  L <= 10 ^ 14 * seen_from p0 p1 q /\ L <= 10 ^ 14 * len (vsub q p0) /\ L <= 10 ^ 14 * len (vsub q p1) /\
  / 10 ^ 40 <= len (vsub q p0) /\ / 10 ^ 40 <= len (vsub q p1) /\ height <= 10 ^ 30 * (L * L).
Proof.
  intros p0 p1 q k0 k1 U gc Dc hc S d L Lq y t c c2 height In K t4 Hc Hc2 h0 Y i r angle turn norm slack High i0 Hs.
  generalize u_pos u_val (power_positive 26) underflow_tiny. intros U0 Hu P26 [T0 T].
  assert (t1 := proj2 (error_is_small _ _ _ _ K)).
  destruct (seen_by_both p0 p1 q) as [_ [_ [La Lb]]].
  destruct (bound_of_slack _ _ _ _ _ _ _ _ _ _ _ _ _ t c c2 height In Hc Hc2 h0 ltac:(lra) i0 Hs) as
    [Fr [Ft [Fn [Fa [r0 [rs [A1 A2]]]]]]]. fold Y i r angle turn norm in Fr, Ft, Fn, Fa, r0, rs, A1, A2.
  assert (a0 : 0 <= angle) by (generalize (Rabs_pos (h p0 p1 q)); lra).
  destruct (way_core _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ c In K Hc High i0 rs) as
    [[d0 [S1 S2]] [[Near [I1 I2]] [Low [Unit [R1 [Q1 i70]]]]]].
  fold Y in Near, Low, Unit, R1, Q1, i70. fold i in Unit, R1, i70. fold r in R1.
  set (G := seen_from p0 p1 q) in *. set (l := len Y) in *.
  assert (HG : / 10 ^ 26 <= G) by (apply (way_range _ _ _ _ _ _ _ _ _ _ _ _ _ In)).
  set (image := step p0 p1 q (in_plane (vsub p1 p0) U) k0 k1) in *.
  assert (LY : l <= len image + len (vsub Y image)) by apply len_from.
  assert (LL : 0 < u * (L * L)) by (apply Rmult_lt_0_compat; [lra | apply Rmult_lt_0_compat; lra]).
  assert (Long : 554 * (u * (L * L)) <= len image) by lra.
  assert (GL : L <= 10 ^ 14 * G).
  { assert (554 * u * L <= 1.2073 * G); [|rewrite Hu in *; lra].
    apply Rmult_le_reg_r with L; [lra|]. replace (554 * u * L * L) with (554 * (u * (L * L))) by ring. lra. }
  destruct (image_below p0 p1 q k0 k1 (in_plane (vsub p1 p0) U) (in_plane_orthogonal _ _)) as [B1 B2]. fold image in
    B1, B2.
  destruct (out_of_plane _ _ _ _ K) as [_ LP]. assert (LP0 := len_nonneg (in_plane (vsub p1 p0) U)).
  assert (LP1 : 0 <= len (in_plane (vsub p1 p0) U) <= 1.0001) by (rewrite Hu in *; lra).
  assert (DD := way_drop _ _ _ _ _ _ _ _ _ _ _ _ _ In). assert (D0 := len_nonneg (D p0 p1 k0 k1)).
  assert (a00 := len_nonneg (vsub q p0)). assert (b00 := len_nonneg (vsub q p1)).
  destruct (near_end_is_far _ _ _ _ L _ B1 a00 LP1 D0 b00 ltac:(lra) ltac:(lra) Long) as [C1 C2].
  destruct (near_end_is_far _ _ _ _ L _ B2 b00 LP1 D0 a00 ltac:(lra) ltac:(lra) Long) as [C3 C4].
  repeat (split; [assumption|]).
  (* the height *)
  destruct (turn_at_least angle height i Fa a0 h0 (conj i0 i70)) as [turn0 B3]. fold turn in turn0, B3.
  destruct (norm_at_least angle height i a0 (conj i0 i70)) as [norm0 _]. fold norm in norm0.
  destruct (slack_parts turn norm t r Ft Fn Fr turn0 norm0 ltac:(lra) r0) as [_ [B4 _]]. fold slack in B4.
  assert (tt : 0 <= turn * t) by (apply Rmult_le_pos; lra).
  assert (B5 := rnd_at_least _ tt). assert (B6 : turn * t <= 0.0626) by (rewrite Hu in *; lra).
  assert (B7 : turn * (4 * u) <= turn * t) by (apply Rmult_le_compat_l; lra).
  set (K4 := 4 * angle * height * i * i) in *.
  assert (B8 : K4 * u <= 0.01566).
  { assert (K4 * u * (1 - 3.01 * u) <= turn * u + / 10 ^ 100 * (u * u)).
    { replace (K4 * u * (1 - 3.01 * u)) with (K4 * (1 - 3.01 * u) * u) by ring.
      replace (turn * u + / 10 ^ 100 * (u * u)) with ((turn + / 10 ^ 100 * u) * u) by ring. apply Rmult_le_compat_r;
        lra. }
    rewrite Hu in *. lra. }
  assert (ii : 0 < i * i) by (apply Rmult_lt_0_compat; lra).
  assert (hii : 0 <= height * (i * i)) by (apply Rmult_le_pos; lra).
  assert (B9 : 1.59 * u * (G * G) * (height * (i * i)) <= angle * (height * (i * i))) by (apply Rmult_le_compat_r; lra).
  replace K4 with (4 * (angle * (height * (i * i)))) in B8 by (unfold K4; ring).
  assert (B10 : u * u * (6.36 * (G * G) * (height * (i * i))) <= 0.01566).
  { assert (B : u * (1.59 * u * (G * G) * (height * (i * i))) <= u * (angle * (height * (i * i))))
      by (apply Rmult_le_compat_l; lra). lra. }
  (* times (l/i)^2 *)
  assert (l0 : 0 < l) by (generalize (power_positive 140); lra).
  assert (lGL : l <= 1.28 * (G * L)) by lra.
  assert (GL0 : 0 < G * L) by (apply Rmult_lt_0_compat; lra).
  assert (il : 0.999 <= i * (1.28 * (G * L))).
  { apply Rle_trans with (i * l); [rewrite Hu in *; lra|]. apply Rmult_le_compat_l; lra. }
  assert (il2 : 0.999 * 0.999 <= i * (1.28 * (G * L)) * (i * (1.28 * (G * L)))) by (apply Rmult_le_compat; lra).
  assert (B11 : height * (0.999 * 0.999) <= height * (i * (1.28 * (G * L)) * (i * (1.28 * (G * L)))))
    by (apply Rmult_le_compat_l; lra).
  replace (height * (i * (1.28 * (G * L)) * (i * (1.28 * (G * L))))) with
    (G * G * (height * (i * i)) * (1.28 * 1.28 * (L * L))) in B11 by ring.
  assert (B12 : G * G * (height * (i * i)) <= 2 * 10 ^ 29).
  { rewrite Hu in B10. lra. }
  assert (L0 : 0 <= 1.28 * 1.28 * (L * L)) by (assert (0 <= L * L) by apply Rle_0_sqr; lra).
  assert (B13 := Rmult_le_compat_r _ _ _ L0 B12). lra.
Qed.

(* ---- The image lies in the next facet ---- *)

Lemma cross_orthogonal_right : forall a b, dot (cross a b) b = 0.
Proof. intros. vdestruct. vunfold. ring. Qed.
Lemma image_in_facet : forall p0 p1 q k0 k1 c x, polygon p0 p1 q k0 k1 c -> dot x (vsub p1 p0) = 0 ->
  dot (step p0 p1 q x k0 k1) (vsub k1 k0) = 0.
Proof.
  intros p0 p1 q k0 k1 c x Poly X. destruct (parts _ _ _ _ _ _ Poly x X) as [i [j ->]].
  rewrite (map_of_parts _ _ _ _ _ _ Poly), dot_of_sum.
  change (side_vector k0 k1 c) with (cross (area_vector k0 k1 c) (vsub k1 k0)). rewrite cross_orthogonal_right.
  destruct (is_plane _ _ _ _ _ _ Poly) as [k Ek]. assert (O := area_orthogonal k0 k1 c).
  assert (N := has_next_area _ _ _ _ _ _ Poly). rewrite Ek in O, N. rewrite dot_sym, dot_scale_right in O.
  destruct (Rmult_integral _ _ O) as [Z|Z].
  - exfalso. apply N. rewrite Z. apply vec_eq; cbn; ring.
  - rewrite (dot_sym (area_vector p0 p1 q) (vsub k1 k0)), Z. ring.
Qed.

Theorem crossing_flat : forall p0 p1 q k0 k1 c0 U gc Dc hc S d L Lq y t c,
  polygon p0 p1 q k0 k1 c0 ->
  way_inputs p0 p1 q k0 k1 U gc Dc hc S d L Lq -> known (vsub p1 p0) y U t -> 36.5 * u <= c ->
  let Y := way_vector U gc hc Dc in let i := way_inverse Y in let r := way_rounding c Lq i in
  len Y <= 10 ^ 160 -> 0 < i -> r < / 16 ->
  / 10 ^ 140 <= len Y /\ 1 - 3.6 * u <= i * len Y <= 1 + 3.6 * u /\
  Rabs (dot Y (vsub k1 k0)) <= len Y * len (vsub k1 k0) / 15.
Proof.
  intros p0 p1 q k0 k1 c0 U gc Dc hc S d L Lq y t c Poly In K Hc Y i r High i0 rs.
  destruct (way_core _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ c In K Hc High i0 rs) as
    [_ [[Near _] [Low [Unit [_ [Q1 _]]]]]].
  split; [exact Low|]. split; [exact Unit|].
  set (image := step p0 p1 q (in_plane (vsub p1 p0) U) k0 k1) in *.
  fold Y in Near, Low, Q1.
  assert (Z : dot image (vsub k1 k0) = 0) by (apply (image_in_facet _ _ _ _ _ c0); [exact Poly | apply
    in_plane_orthogonal]).
  replace (dot Y (vsub k1 k0)) with (dot (vsub Y image) (vsub k1 k0)).
  - eapply Rle_trans; [apply dot_len|]. generalize (len_nonneg (vsub k1 k0)). intro.
    assert (len (vsub Y image) * len (vsub k1 k0) <= len Y / 15 * len (vsub k1 k0))
      by (apply Rmult_le_compat_r; [assumption | lra]). lra.
  - rewrite (dot_sym (vsub Y image)), dot_sub_right, (dot_sym _ image), Z, dot_sym. ring.
Qed.

(* ---- The sign of the way ---- *)

Lemma way_covers : forall t c G R, 0 <= t <= 3 / 32 -> 19.3 * u <= c <= 1000 * u -> fmt t -> fmt c ->
  / 10 ^ 26 <= G -> G * (1 - 4.53 * u) <= R ->
  (t + 12 * u) * (1 + 16 * u) * G + 5.0022 * u * G <= rnd (rnd (t + c) * R).
Proof.
  intros t c G R Ht Hc Ft Fc HG HR. generalize u_pos u_val (power_positive 26). intros U0 Hu P26.
  assert (P := rnd_plus t c Ft Fc). rewrite (Rabs_pos_eq (t + c)) in P by lra. apply Rabs_le_inv in P.
  assert (T : 0 <= t * G <= 3 / 32 * G) by (split; [apply Rmult_le_pos; lra | apply Rmult_le_compat_r; lra]).
  assert (C : 19.3 * u * G <= c * G <= 1000 * u * G) by (split; apply Rmult_le_compat_r; lra).
  set (Z := (t + c) * (1 - u) * (G * (1 - 4.53 * u))).
  assert (HZ : Z <= rnd (t + c) * R).
  { apply Rmult_le_compat; [apply Rmult_le_pos; rewrite ?Hu in *; lra | apply Rmult_le_pos; rewrite ?Hu; lra | lra |
      exact HR]. }
  assert (Low : 19 * u * G <= Z).
  { replace Z with ((t * G + c * G) * ((1 - u) * (1 - 4.53 * u))) by (unfold Z; ring). rewrite Hu in *. lra. }
  assert (Z0 : 0 <= Z) by (assert (0 <= u * G) by (apply Rmult_le_pos; lra); lra).
  assert (B := rnd_at_least (rnd (t + c) * R) ltac:(lra)).
  assert (B2 : Z * (1 - u) <= rnd (t + c) * R * (1 - u)) by (apply Rmult_le_compat_r; [rewrite Hu; lra | exact HZ]).
  assert (Tau : u * tau <= / 1000 * (u * G)).
  { replace (/ 1000 * (u * G)) with (u * (/ 1000 * G)) by ring. apply Rmult_le_compat_l; [lra|].
    assert (A := tau_below_power 40 ltac:(lia)). lra. }
  replace (Z * (1 - u)) with ((t * G + c * G) * ((1 - u) * (1 - 4.53 * u) * (1 - u))) in B2 by (unfold Z; ring).
  replace ((t + 12 * u) * (1 + 16 * u) * G) with ((t * G + 12 * u * G) * (1 + 16 * u)) by ring.
  rewrite Hu in *. lra.
Qed.

Lemma root_at_least : forall S G, / 10 ^ 26 <= G -> Rabs (S - G * G) <= 7.01 * u * (G * G) ->
  G * (1 - 4.53 * u) <= rnd (sqrt S).
Proof.
  intros S G HG H. generalize u_pos u_val (power_positive 26). intros U0 Hu P26. apply Rabs_le_inv in H.
  assert (GG : 0 < G * G) by (apply Rmult_lt_0_compat; lra).
  assert (R : G * (1 - 3.51 * u) <= sqrt S).
  { rewrite <- (sqrt_Rsqr (G * (1 - 3.51 * u))) by (apply Rmult_le_pos; rewrite ?Hu; lra).
    apply sqrt_le_1_alt. unfold Rsqr. replace (G * (1 - 3.51 * u) * (G * (1 - 3.51 * u))) with
      (G * G * ((1 - 3.51 * u) * (1 - 3.51 * u))) by ring. rewrite Hu in *. lra. }
  assert (s0 : 0 <= sqrt S) by apply sqrt_pos. assert (B := rnd_at_least _ s0).
  assert (R2 : G * (1 - 3.51 * u) * (1 - u) <= sqrt S * (1 - u)) by (apply Rmult_le_compat_r; [rewrite Hu; lra | exact
    R]).
  assert (Tau : u * tau <= / 1000 * (u * G)).
  { replace (/ 1000 * (u * G)) with (u * (/ 1000 * G)) by ring. apply Rmult_le_compat_l; [lra|].
    assert (A := tau_below_power 40 ltac:(lia)). lra. }
  rewrite Hu in *. lra.
Qed.

Theorem sign_of_way_right : forall p0 p1 q k0 k1 U gc Dc hc S d L Lq y t c2 c_exit sigma,
  way_inputs p0 p1 q k0 k1 U gc Dc hc S d L Lq -> known (vsub p1 p0) y U t ->
  1.6 * u <= c2 -> 19.3 * u <= c_exit <= 1000 * u -> fmt t -> fmt c_exit ->
  let bound := rnd (rnd (t + c_exit) * rnd (sqrt S)) in let h_bound := rnd (c2 * S) in
  sigma = 1 \/ sigma = -1 ->
  (0 < sigma * dot y (bisector_g p0 p1 q) /\ 0 <= sigma * h p0 p1 q) \/
  (0 <= sigma * dot y (bisector_g p0 p1 q) /\ 0 < sigma * h p0 p1 q) ->
  (bound < rdot U gc \/ h_bound < hc -> sigma = 1) /\ (rdot U gc < - bound \/ hc < - h_bound -> sigma = -1).
Proof.
  intros p0 p1 q k0 k1 U gc Dc hc S d L Lq y t c2 c_exit sigma In K Hc2 Hce Ft Fc bound h_bound Hs Way.
  generalize u_pos u_val (power_positive 26). intros U0 Hu P26.
  assert (Ht : 0 <= t <= 3 / 32) by (generalize (error_is_small _ _ _ _ K); lra).
  destruct In as [[FU [Fg [_ Fh]]] Ng Nh NS _ _ _ _ [HG _]].
  destruct (form_near p0 p1 q U gc y t FU Fg Ng HG K) as [_ [_ FA]].
  destruct (seen_by_both p0 p1 q) as [Lg [Lh _]].
  set (G := seen_from p0 p1 q) in *. set (g := bisector_g p0 p1 q) in *.
  destruct (form_of_known _ _ _ _ K) as [s [s0 Form]]. specialize (Form g).
  assert (Form' : Rabs (dot U g - s * dot y g) <= (t + 12 * u) * (1 + 16 * u) * G).
  { eapply Rle_trans; [exact Form|]. apply Rmult_le_compat_l; [apply Rmult_le_pos; lra | exact Lg]. }
  assert (Cover := way_covers t c_exit G _ Ht Hce Ft Fc HG (root_at_least S G HG NS)). fold bound in Cover.
  destruct (sign_of_certain (rdot U gc) bound (dot U g) s (dot y g) _ FA ltac:(lra) s0) as [Up Down].
  assert (GG : / 10 ^ 52 <= G * G).
  { replace (/ 10 ^ 52) with (/ 10 ^ 26 * / 10 ^ 26) by (rewrite <- Rinv_mult, <- pow_add; reflexivity).
    apply Rmult_le_compat; lra. }
  destruct (angle_at_least hc (h p0 p1 q) S c2 (G * G) Fh GG Lh Nh NS Hc2) as [_ [_ Hb]]. fold h_bound in Hb.
  apply Rabs_le_inv in Nh. assert (uG : 0 < u * (G * G)) by (apply Rmult_lt_0_compat; [lra | generalize (power_positive
    52); lra]).
  split; intros [H|H].
  - assert (A := Up H). destruct Hs as [->| ->]; [reflexivity|]. exfalso. lra.
  - assert (0 < h p0 p1 q) by lra. destruct Hs as [->| ->]; [reflexivity|]. exfalso. lra.
  - assert (A := Down H). destruct Hs as [->| ->]; [|reflexivity]. exfalso. lra.
  - assert (h p0 p1 q < 0) by lra. destruct Hs as [->| ->]; [|reflexivity]. exfalso. lra.
Qed.
