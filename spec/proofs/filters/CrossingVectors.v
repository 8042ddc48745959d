(* The vector Y = A D + 2 h U that src/flow/kernels/direction_across.h computes behind a facet, as real numbers and
   roundings. `way_vector_near`: it is near to the image of what was known before. `way_core`: it is so within
   24.51 u L^2; and where the rounding is less than 1/16 of its length, then L^2 is not much longer than Y. *)
From Coq Require Import Reals Lra Lia Psatz.
From Flocq Require Import Core.
From Flowcert Require Import algebra.Vector3 algebra.Cascade algebra.Crossing filters.Rounding filters.RoundedVectors
  filters.Norms filters.Floors filters.Terms filters.Directions filters.DirectionSigns filters.DirectionVectors.
Open Scope R_scope.

(* ---- What is computed ---- *)

Definition way_vector U gc hc Dc := radd (rscale (rdot U gc) Dc) (rscale (rnd (2 * hc)) U).
Definition way_inverse Y := rnd (1 / rlength Y).
Definition way_rounding c Lq i := rnd (rnd (c * Lq) * i).
Definition way_angle c2 hc S := rnd (Rabs hc + rnd (c2 * S)).
Definition way_turn angle height i := rnd (rnd (rnd (rnd (4 * angle) * height) * i) * i).
Definition way_norm angle height i := rnd (rnd (2 * Rmax angle height) * i).
Definition way_slack turn norm t r := rnd (rnd (rnd (turn + norm) * t) + r).
Definition way_error kB turn t r slack := rnd (rnd (rnd (turn * t) + r) * rnd (1 + rnd (kB * slack))).

(* G *)
Definition seen_from p0 p1 q := seen_size (vsub q p0) (vsub q p1).

(* What is known of the doubles that the vector is made of. d is the size of the drop, and L that of the way. *)
Record way_inputs (p0 p1 q k0 k1 U gc Dc : vec) (hc S d L Lq : R) : Prop := WayInputs {
  way_formats : fmt3 U /\ fmt3 gc /\ fmt3 Dc /\ fmt hc;
  way_g : len (vsub gc (bisector_g p0 p1 q)) <= 2.001 * u * seen_from p0 p1 q;
  way_h : Rabs (hc - h p0 p1 q) <= 1.3 * u * (seen_from p0 p1 q * seen_from p0 p1 q);
  way_size : Rabs (S - seen_from p0 p1 q * seen_from p0 p1 q) <= 7.01 * u * (seen_from p0 p1 q * seen_from p0 p1 q);
  way_drop : len (D p0 p1 k0 k1) <= d;
  way_drop_near : len (vsub Dc (D p0 p1 k0 k1)) <= 2.001 * u * d;
  way_length : (d <= 0.7072 * seen_from p0 p1 q /\ L = seen_from p0 p1 q) \/ L = seen_from p0 p1 q + d;
  way_square : L * L * (1 - 14 * u) <= Lq;
  way_range : / 10 ^ 26 <= seen_from p0 p1 q <= 10 ^ 26 }.

(* ---- Roundings ---- *)

Lemma rnd_mono : forall x y, x <= y -> rnd x <= rnd y.
Proof. intros. apply round_le; auto with typeclass_instances. Qed.
Lemma rnd_id : forall x, fmt x -> rnd x = x.
Proof. intros. apply round_generic; [apply valid_rnd_N | assumption]. Qed.
Lemma rnd_above : forall x y, fmt x -> x <= y -> x <= rnd y.
Proof. intros. apply round_ge_generic; auto with typeclass_instances. Qed.
Lemma rnd_below : forall x y, fmt y -> x <= y -> rnd x <= y.
Proof. intros. apply round_le_generic; auto with typeclass_instances. Qed.
Lemma rnd_nonneg : forall x, 0 <= x -> 0 <= rnd x.
Proof. intros. apply rnd_above; [apply generic_format_0 | assumption]. Qed.
Lemma rnd_at_least : forall z, 0 <= z -> z * (1 - u) - u * tau <= rnd z.
Proof. intros z H. generalize (rnd_any z). rewrite (Rabs_pos_eq z H). intro R. apply Rabs_le_inv in R. lra. Qed.
Lemma rnd_at_most : forall z, 0 <= z -> rnd z <= z * (1 + u) + u * tau.
Proof. intros z H. generalize (rnd_any z). rewrite (Rabs_pos_eq z H). intro R. apply Rabs_le_inv in R. lra. Qed.
Lemma rnd_four : forall x, fmt x -> rnd (4 * x) = 4 * x.
Proof.
  intros x F. assert (F2 : fmt (2 * x)) by (rewrite <- rnd_double by exact F; apply fmt_rnd).
  replace (4 * x) with (2 * (2 * x)) by ring. apply rnd_double, F2.
Qed.

Lemma power_positive : forall k, 0 < / 10 ^ k. Proof. intro. apply Rinv_0_lt_compat, pow_lt. lra. Qed.
Lemma tau_below_power : forall k, (k <= 300)%nat -> tau <= / 10 ^ k.
Proof.
  intros k H. eapply Rle_trans; [apply tau_small|]. apply Rinv_le; [apply pow_lt; lra | apply Rle_pow; [lra | lia]].
Qed.
Lemma underflow_tiny : 0 < u * tau <= / 10 ^ 250 * u.
Proof.
  generalize u_pos tau_pos (tau_below_power 250 ltac:(lia)). intros. split; [apply Rmult_lt_0_compat; assumption|].
  rewrite (Rmult_comm u). apply Rmult_le_compat_r; lra.
Qed.

Lemma radd_rounding : forall a b, fmt3 a -> fmt3 b -> len (vsub (radd a b) (vadd a b)) <= u * len (vadd a b).
Proof.
  intros a b [A1 [A2 A3]] [B1 [B2 B3]]. generalize u_pos. intro U0.
  apply Rle_trans with (len (vscale u (vabs (vadd a b)))).
  - apply len_mono; unfold radd, vscale, vabs, vadd, vsub; simpl; apply rnd_plus; assumption.
  - right. rewrite len_scale, len_vabs by lra. reflexivity.
Qed.
Lemma scaled_apart : forall s z a b, len (vsub (rscale s a) (vscale z b)) <=
  u * (Rabs s * len a) + 2 * (u * tau) + Rabs s * len (vsub a b) + Rabs (s - z) * len b.
Proof.
  intros s z a b. assert (R := rscale_rounding s a).
  assert (T1 := len_between (rscale s a) (vscale s a) (vscale z b)).
  assert (T2 := len_between (vscale s a) (vscale s b) (vscale z b)).
  replace (vsub (vscale s a) (vscale s b)) with (vscale s (vsub a b)) in T2 by (apply vec_eq; cbn; ring).
  replace (vsub (vscale s b) (vscale z b)) with (vscale (s - z) b) in T2 by (apply vec_eq; cbn; ring).
  rewrite !len_scale_any in T2. lra.
Qed.
Lemma sums_apart : forall a b x y, fmt3 a -> fmt3 b -> len (vsub (radd a b) (vadd x y)) <=
  u * len (vadd x y) + (1 + u) * (len (vsub a x) + len (vsub b y)).
Proof.
  intros a b x y Fa Fb. assert (R := radd_rounding a b Fa Fb). generalize u_pos. intro U0.
  assert (T1 := len_between (radd a b) (vadd a b) (vadd x y)).
  assert (T2 := len_from (vadd a b) (vadd x y)).
  assert (E : vsub (vadd a b) (vadd x y) = vadd (vsub a x) (vsub b y)) by (apply vec_eq; cbn; ring).
  rewrite E in T1, T2. assert (T3 := len_triangle (vsub a x) (vsub b y)).
  assert (u * len (vadd a b) <= u * (len (vadd x y) + (len (vsub a x) + len (vsub b y))))
    by (apply Rmult_le_compat_l; lra).
  lra.
Qed.

(* ---- The vector ---- *)

Lemma seen_by_both : forall p0 p1 q, len (bisector_g p0 p1 q) <= seen_from p0 p1 q /\
  4 * Rabs (h p0 p1 q) <= seen_from p0 p1 q * seen_from p0 p1 q /\
  len (vsub q p0) <= seen_from p0 p1 q /\ len (vsub q p1) <= seen_from p0 p1 q.
Proof.
  intros p0 p1 q. assert (S := sum_below_seen_size (vsub q p0) (vsub q p1)).
  assert (T := len_triangle (vsub q p0) (vsub q p1)). assert (B := dot_len (vsub q p0) (vsub q p1)).
  assert (Q := product_below_seen_size (vsub q p0) (vsub q p1)).
  generalize (len_nonneg (vsub q p0)) (len_nonneg (vsub q p1)). intros.
  unfold seen_from, bisector_g, h. repeat split; lra.
Qed.

Lemma out_of_plane : forall e y U t, known e y U t ->
  len (vsub U (in_plane e U)) <= 12.01 * u /\ len (in_plane e U) <= 1 + 16 * u.
Proof.
  intros e y U t [_ Short Leaves _ _]. generalize u_pos u_val. intros U0 Hu.
  split; [|eapply Rle_trans; [apply in_plane_len | exact Short]].
  assert (K := leaving_len e U (12 * u) Leaves ltac:(lra)).
  replace (vsub U (in_plane e U)) with (vscale (dot U e / dot e e) e)
    by (unfold in_plane; apply vec_eq; cbn; ring).
  eapply Rle_trans; [exact K|]. apply Rle_trans with (12 * u * (1 + 16 * u)); [apply Rmult_le_compat_l; lra|].
  rewrite Hu. lra.
Qed.

Lemma dot_near : forall A U gc g P, A - dot P g = (A - dot U gc) + dot U (vsub gc g) + dot (vsub U P) g.
Proof. intros. unfold dot, vsub. cbn. ring. Qed.

Lemma form_near : forall p0 p1 q U gc y t, fmt3 U -> fmt3 gc ->
  let G := seen_from p0 p1 q in let g := bisector_g p0 p1 q in let P := in_plane (vsub p1 p0) U in
  len (vsub gc g) <= 2.001 * u * G -> / 10 ^ 26 <= G -> known (vsub p1 p0) y U t ->
  Rabs (rdot U gc - dot P g) <= 17.02 * u * G /\ Rabs (dot P g) <= (1 + 16 * u) * G /\
  Rabs (rdot U gc - dot U g) <= 5.0022 * u * G.
Proof.
  intros p0 p1 q U gc y t FU Fg G g P Ng HG K. generalize u_pos u_val. intros U0 Hu.
  destruct (out_of_plane _ _ _ _ K) as [W LP]. fold P in W, LP. assert (LU := is_short _ _ _ _ K).
  destruct (seen_by_both p0 p1 q) as [Lg _]. fold G g in Lg.
  assert (G0 : 0 < G) by (generalize (power_positive 26); lra). assert (uG : 0 < u * G) by (apply Rmult_lt_0_compat;
    lra).
  generalize (len_nonneg U) (len_nonneg P) (len_nonneg g) (len_nonneg gc) (len_nonneg (vsub U P))
    (len_nonneg (vsub gc g)). intros.
  assert (Lgc : len gc <= G * (1 + 2.001 * u)) by (assert (T := len_from gc g); lra).
  assert (R := rdot_rounding U gc FU Fg).
  assert (T : tau <= / 10 ^ 60 * G).
  { eapply Rle_trans; [apply (tau_below G)|apply Rmult_le_compat_r; [lra|]].
    - eapply Rle_trans; [|exact HG]. apply Rinv_le; [apply pow_lt; lra | apply Rle_pow; [lra | lia]].
    - apply Rinv_le; [apply pow_lt; lra | apply Rle_pow; [lra | lia]]. }
  assert (B1 : len U * len gc <= (1 + 16 * u) * (G * (1 + 2.001 * u))) by (apply Rmult_le_compat; lra).
  assert (B2 : len U * len (vsub gc g) <= (1 + 16 * u) * (2.001 * u * G)) by (apply Rmult_le_compat; lra).
  assert (B3 : len (vsub U P) * len g <= 12.01 * u * G) by (apply Rmult_le_compat; lra).
  assert (B4 : len P * len g <= (1 + 16 * u) * G) by (apply Rmult_le_compat; lra).
  assert (B5 : 3.0001 * u * (len U * len gc + 3 * tau) <= 3.0002 * u * G).
  { apply Rle_trans with (3.0001 * u * ((1 + 16 * u) * (G * (1 + 2.001 * u)) + 3 * (/ 10 ^ 60 * G))).
    - apply Rmult_le_compat_l; lra.
    - rewrite Hu. lra. }
  assert (C1 := dot_len U (vsub gc g)). assert (C2 := dot_len (vsub U P) g). assert (C3 := dot_len P g).
  assert (X : Rabs (rdot U gc - dot U g) <= 5.0022 * u * G).
  { replace (rdot U gc - dot U g) with ((rdot U gc - dot U gc) + dot U (vsub gc g)) by (rewrite dot_sub_right; ring).
    eapply Rle_trans; [apply Rabs_triang|]. rewrite Hu in *. lra. }
  split; [|split; [lra | exact X]].
  replace (rdot U gc - dot P g) with ((rdot U gc - dot U g) + dot (vsub U P) g)
    by (unfold dot, vsub; cbn; ring).
  eapply Rle_trans; [apply Rabs_triang|]. lra.
Qed.

Theorem way_vector_near : forall p0 p1 q k0 k1 U gc Dc hc S d L Lq y t,
  way_inputs p0 p1 q k0 k1 U gc Dc hc S d L Lq -> known (vsub p1 p0) y U t ->
  let G := seen_from p0 p1 q in let image := step p0 p1 q (in_plane (vsub p1 p0) U) k0 k1 in
  len (vsub (way_vector U gc hc Dc) image) <= u * (21.04 * (G * d) + 9.61 * (G * G)) /\
  len image <= (1 + 16 * u) * (G * d + G * G / 2).
Proof.
  intros p0 p1 q k0 k1 U gc Dc hc S d L Lq y t [[FU [Fg [FD Fh]]] Ng Nh _ LD ND _ _ [HG _]] K G image.
  generalize u_pos u_val. intros U0 Hu.
  assert (LU := is_short _ _ _ _ K). destruct (out_of_plane _ _ _ _ K) as [W LP].
  destruct (form_near p0 p1 q U gc y t FU Fg Ng HG K) as [FA [A0 _]].
  destruct (seen_by_both p0 p1 q) as [Lg [Lh _]].
  unfold image, way_vector, step, A. rewrite (rnd_double hc Fh). fold G in HG, Ng, Nh, FA, A0, Lg, Lh.
  set (P := in_plane (vsub p1 p0) U) in *. set (g := bisector_g p0 p1 q) in *. set (DD := D p0 p1 k0 k1) in *.
  set (hh := h p0 p1 q) in *. set (a := rdot U gc) in *. set (b := dot P g) in *.
  assert (G0 : 0 < G) by (generalize (power_positive 26); lra).
  generalize (len_nonneg U) (len_nonneg P) (len_nonneg DD) (len_nonneg (vsub U P)) (len_nonneg Dc) (Rabs_pos a)
    (Rabs_pos b) (Rabs_pos hc) (Rabs_pos hh) (Rabs_pos (hc - hh)) (Rabs_pos (a - b)) (len_nonneg (vsub Dc DD)). intros.
  assert (d0 : 0 <= d) by lra.
  assert (Lc : len Dc <= d * (1 + 2.001 * u)) by (assert (T := len_from Dc DD); lra).
  assert (La : Rabs a <= G * 1.0001).
  { replace a with ((a - b) + b) by ring. eapply Rle_trans; [apply Rabs_triang|]. rewrite Hu in *. lra. }
  assert (gg : / 10 ^ 52 <= G * G).
  { replace (/ 10 ^ 52) with (/ 10 ^ 26 * / 10 ^ 26) by (rewrite <- Rinv_mult, <- pow_add; reflexivity).
    generalize (power_positive 26). intro. apply Rmult_le_compat; lra. }
  assert (gd : 0 <= G * d) by (apply Rmult_le_pos; lra).
  assert (T : u * tau <= / 10 ^ 60 * (u * (G * G))).
  { replace (/ 10 ^ 60 * (u * (G * G))) with (u * (/ 10 ^ 60 * (G * G))) by ring. apply Rmult_le_compat_l; [lra|].
    eapply Rle_trans; [apply (tau_below (G * G))|apply Rmult_le_compat_r; [lra|]].
    - eapply Rle_trans; [|exact gg]. apply Rinv_le; [apply pow_lt; lra | apply Rle_pow; [lra | lia]].
    - apply Rinv_le; [apply pow_lt; lra | apply Rle_pow; [lra | lia]]. }
  assert (ug : 0 < u * (G * G)) by (apply Rmult_lt_0_compat; [lra | apply Rmult_lt_0_compat; lra]).
  assert (ud : 0 <= u * (G * d)) by (apply Rmult_le_pos; lra).
  (* the two products *)
  assert (X := scaled_apart a b Dc DD).
  assert (X1 : Rabs a * len Dc <= G * 1.0001 * (d * (1 + 2.001 * u))) by (apply Rmult_le_compat; lra).
  assert (X2 : Rabs a * len (vsub Dc DD) <= G * 1.0001 * (2.001 * u * d)) by (apply Rmult_le_compat; lra).
  assert (X3 : Rabs (a - b) * len DD <= 17.02 * u * G * d) by (apply Rmult_le_compat; lra).
  assert (X4 : u * (Rabs a * len Dc) <= u * (G * 1.0001 * (d * (1 + 2.001 * u)))) by (apply Rmult_le_compat_l; lra).
  assert (X5 : len (vsub (rscale a Dc) (vscale b DD)) <= 20.0215 * (u * (G * d)) + 2 * (u * tau)).
  { eapply Rle_trans; [exact X|].
    replace (u * (G * 1.0001 * (d * (1 + 2.001 * u)))) with (1.0001 * (1 + 2.001 * u) * (u * (G * d))) in X4 by ring.
    replace (G * 1.0001 * (2.001 * u * d)) with (1.0001 * 2.001 * (u * (G * d))) in X2 by ring.
    replace (17.02 * u * G * d) with (17.02 * (u * (G * d))) in X3 by ring.
    assert (1.0001 * (1 + 2.001 * u) * (u * (G * d)) <= 1.0002 * (u * (G * d)))
      by (apply Rmult_le_compat_r; [exact ud | rewrite Hu; lra]). lra. }
  assert (Z := scaled_apart (2 * hc) (2 * hh) U P).
  replace (2 * hc - 2 * hh) with (2 * (hc - hh)) in Z by ring. rewrite !(Rabs_mult 2), (Rabs_pos_eq 2) in Z by lra.
  assert (Lhc : Rabs hc <= 0.2501 * (G * G)).
  { replace hc with ((hc - hh) + hh) by ring. eapply Rle_trans; [apply Rabs_triang|]. rewrite Hu in *. lra. }
  assert (Z1 : Rabs hc * len U <= 0.2501 * (G * G) * (1 + 16 * u)) by (apply Rmult_le_compat; lra).
  assert (Z2 : Rabs hc * len (vsub U P) <= 0.2501 * (G * G) * (12.01 * u)) by (apply Rmult_le_compat; lra).
  assert (Z3 : Rabs (hc - hh) * len P <= 1.3 * u * (G * G) * (1 + 16 * u)) by (apply Rmult_le_compat; lra).
  assert (Z4 : u * (Rabs hc * len U) <= u * (0.2501 * (G * G) * (1 + 16 * u))) by (apply Rmult_le_compat_l; lra).
  assert (Z5 : len (vsub (rscale (2 * hc) U) (vscale (2 * hh) P)) <= 9.109 * (u * (G * G)) + 2 * (u * tau)).
  { eapply Rle_trans; [exact Z|].
    replace (u * (0.2501 * (G * G) * (1 + 16 * u))) with (0.2501 * (1 + 16 * u) * (u * (G * G))) in Z4 by ring.
    replace (0.2501 * (G * G) * (12.01 * u)) with (0.2501 * 12.01 * (u * (G * G))) in Z2 by ring.
    replace (1.3 * u * (G * G) * (1 + 16 * u)) with (1.3 * (1 + 16 * u) * (u * (G * G))) in Z3 by ring.
    assert (0.2501 * (1 + 16 * u) * (u * (G * G)) <= 0.25011 * (u * (G * G)))
      by (apply Rmult_le_compat_r; [lra | rewrite Hu; lra]).
    assert (1.3 * (1 + 16 * u) * (u * (G * G)) <= 1.30001 * (u * (G * G)))
      by (apply Rmult_le_compat_r; [lra | rewrite Hu; lra]). lra. }
  (* the sum *)
  assert (I : len (vadd (vscale b DD) (vscale (2 * hh) P)) <= (1 + 16 * u) * (G * d + G * G / 2)).
  { eapply Rle_trans; [apply len_triangle|]. rewrite !len_scale_any, Rabs_mult, (Rabs_pos_eq 2) by lra.
    assert (Rabs b * len DD <= (1 + 16 * u) * G * d) by (apply Rmult_le_compat; lra).
    assert (2 * Rabs hh * len P <= G * G / 2 * (1 + 16 * u)) by (apply Rmult_le_compat; lra). lra. }
  split; [|exact I].
  assert (F1 : fmt3 (rscale a Dc)) by (repeat split; apply fmt_rnd).
  assert (F2 : fmt3 (rscale (2 * hc) U)) by (repeat split; apply fmt_rnd).
  eapply Rle_trans; [apply (sums_apart _ _ (vscale b DD) (vscale (2 * hh) P) F1 F2)|].
  assert (J : u * len (vadd (vscale b DD) (vscale (2 * hh) P)) <= u * ((1 + 16 * u) * (G * d + G * G / 2)))
    by (apply Rmult_le_compat_l; lra).
  replace (u * ((1 + 16 * u) * (G * d + G * G / 2))) with ((1 + 16 * u) * (u * (G * d) + u * (G * G) / 2)) in J by
    field.
  assert ((1 + 16 * u) * (u * (G * d) + u * (G * G) / 2) <= 1.0001 * (u * (G * d) + u * (G * G) / 2))
    by (apply Rmult_le_compat_r; [lra | rewrite Hu; lra]).
  assert ((1 + u) * (len (vsub (rscale a Dc) (vscale b DD)) + len (vsub (rscale (2 * hc) U) (vscale (2 * hh) P))) <=
    1.0001 * (20.0215 * (u * (G * d)) + 2 * (u * tau) + (9.109 * (u * (G * G)) + 2 * (u * tau)))).
  { generalize (len_nonneg (vsub (rscale a Dc) (vscale b DD)))
      (len_nonneg (vsub (rscale (2 * hc) U) (vscale (2 * hh) P))). intros.
    apply Rmult_le_compat; [rewrite Hu; lra | lra | rewrite Hu; lra | lra]. }
  lra.
Qed.

(* The sizes of a way. *)
Lemma sizes_of_way : forall G d L, 0 < G -> 0 <= d -> (d <= 0.7072 * G /\ L = G) \/ L = G + d ->
  G <= L /\ G + d <= 1.7072 * L /\ G * d + G * G / 2 <= 1.2072 * (L * L) /\ G * d + G * G / 2 <= 1.2072 * (G * L) /\
  21.04 * (G * d) + 9.61 * (G * G) <= 24.5 * (L * L).
Proof.
  intros G d L G0 d0 H. assert (gg : 0 < G * G) by (apply Rmult_lt_0_compat; lra).
  assert (gd : 0 <= G * d) by (apply Rmult_le_pos; lra). assert (dd : 0 <= d * d) by apply Rle_0_sqr.
  destruct H as [[H1 ->]| ->].
  - assert (G * d <= G * (0.7072 * G)) by (apply Rmult_le_compat_l; lra). repeat split; lra.
  - replace ((G + d) * (G + d)) with (G * G + 2 * (G * d) + d * d) by ring.
    replace (G * (G + d)) with (G * G + G * d) by ring. repeat split; lra.
Qed.

(* ---- The inverse of its length ---- *)

Lemma way_vector_format : forall U gc hc Dc, fmt3 (way_vector U gc hc Dc).
Proof. intros. repeat split; apply fmt_rnd. Qed.

(* L^2 over the length, in units of u, is small where the rounding is. *)
Lemma inverse_of_rounding : forall Y c Lq L, let i := way_inverse Y in let r := way_rounding c Lq i in
  fmt3 Y -> len Y <= 10 ^ 160 -> len Y <= 1.3 * (L * L) -> / 10 ^ 26 <= L -> L * L * (1 - 14 * u) <= Lq ->
  36.5 * u <= c -> 0 < i -> r < / 16 ->
  / 10 ^ 140 <= len Y /\ 1 - 3.6 * u <= i * len Y <= 1 + 3.6 * u /\ 36.48 * (i * (u * (L * L))) <= r /\
  579 * (u * (L * L)) <= len Y /\ i <= 10 ^ 70.
Proof.
  intros Y c Lq L i r FY High Below HL HLq Hc i0 Hr. generalize u_pos u_val underflow_tiny. intros U0 Hu [T0 T].
  assert (P52 := power_positive 52). assert (P26 := power_positive 26).
  assert (LL : / 10 ^ 52 <= L * L).
  { replace (/ 10 ^ 52) with (/ 10 ^ 26 * / 10 ^ 26) by (rewrite <- Rinv_mult, <- pow_add; reflexivity).
    apply Rmult_le_compat; lra. }
  set (Q := L * L) in *. assert (uQ : 0 < u * Q) by (apply Rmult_lt_0_compat; lra).
  assert (C : 36.5 * u * (Q * (1 - 14 * u)) <= c * Lq).
  { apply Rmult_le_compat; try lra. apply Rmult_le_pos; [lra | rewrite Hu; lra]. }
  assert (T1 : tau <= 36.5 * u * (Q * (1 - 14 * u))).
  { eapply Rle_trans; [apply (tau_below Q)|].
    - eapply Rle_trans; [|exact LL]. apply Rinv_le; [apply pow_lt; lra | apply Rle_pow; [lra | lia]].
    - rewrite Hu. lra. }
  assert (W := rnd_lower _ _ T1 C). set (w := rnd (c * Lq)) in *.
  assert (W1 : 36.49 * (u * Q) <= w) by (rewrite Hu in *; lra).
  assert (wi : 36.49 * (u * Q) * i <= w * i) by (apply Rmult_le_compat_r; lra).
  assert (wi0 : 0 <= w * i) by (apply Rmult_le_pos; lra).
  assert (R1 := rnd_at_least _ wi0). change (rnd (w * i)) with r in R1.
  assert (wi2 : w * i <= 0.0626) by (rewrite Hu in *; lra).
  assert (iQ : i * (u * Q) <= 0.00172) by lra.
  assert (i70 : i <= 10 ^ 70).
  { apply Rmult_le_reg_r with (u * / 10 ^ 52); [rewrite Hu; lra|].
    apply Rle_trans with (i * (u * Q)); [apply Rmult_le_compat_l; [lra | apply Rmult_le_compat_l; lra]|].
    apply Rle_trans with 0.00172; [exact iQ | rewrite Hu; lra]. }
  assert (s0 : 0 <= rlength Y) by apply rnd_nonneg, sqrt_pos.
  assert (S0 : 0 < rlength Y).
  { destruct s0 as [s0|s0]; [exact s0|]. exfalso. unfold i, way_inverse in i0. rewrite <- s0 in i0. unfold Rdiv in i0.
    rewrite Rinv_0, Rmult_0_r in i0. unfold rnd in i0. rewrite round_0 in i0 by apply valid_rnd_N. lra. }
  assert (LowS : / 10 ^ 139 <= rlength Y).
  { assert (q0 : 0 <= 1 / rlength Y) by (left; apply Rdiv_lt_0_compat; lra).
    assert (B := rnd_at_least _ q0). change (rnd (1 / rlength Y)) with i in B.
    assert (B1 : 1 / rlength Y <= 2 * 10 ^ 70) by (rewrite Hu in *; lra).
    assert (B2 : 1 <= 2 * 10 ^ 70 * rlength Y).
    { replace 1 with (1 / rlength Y * rlength Y) at 1 by (field; lra). apply Rmult_le_compat_r; lra. }
    assert (/ 10 ^ 139 <= / 10 ^ 71) by (apply Rinv_le; [apply pow_lt; lra | apply Rle_pow; [lra | lia]]).
    assert (/ 10 ^ 71 <= rlength Y); [|lra]. lra. }
  destruct (inverse_of_length Y FY LowS High) as [L1 L2]. change (rnd (1 / rlength Y)) with i in L2.
  assert (P140 := power_positive 140). set (l := len Y) in *.
  assert (i * l <= i * (1.3 * Q)) by (apply Rmult_le_compat_l; lra).
  assert (iq : 0.76 <= i * Q) by (rewrite Hu in *; lra).
  assert (uiQ : 0.76 * u <= i * (u * Q)).
  { replace (i * (u * Q)) with (i * Q * u) by ring. apply Rmult_le_compat_r; lra. }
  assert (R2 : 36.48 * (i * (u * Q)) <= r) by (rewrite Hu in *; lra).
  split; [exact L1|]. split; [exact L2|]. split; [exact R2|]. split; [|exact i70].
  apply Rmult_le_reg_l with i; [exact i0|]. replace (i * (579 * (u * Q))) with (579 * (i * (u * Q))) by ring.
  rewrite Hu in *. lra.
Qed.

Lemma way_core : forall p0 p1 q k0 k1 U gc Dc hc S d L Lq y t c,
  way_inputs p0 p1 q k0 k1 U gc Dc hc S d L Lq -> known (vsub p1 p0) y U t -> 36.5 * u <= c ->
  let G := seen_from p0 p1 q in let image := step p0 p1 q (in_plane (vsub p1 p0) U) k0 k1 in
  let Y := way_vector U gc hc Dc in let i := way_inverse Y in let r := way_rounding c Lq i in
  len Y <= 10 ^ 160 -> 0 < i -> r < / 16 ->
  (0 <= d /\ G <= L /\ G + d <= 1.7072 * L) /\
  (len (vsub Y image) <= 24.51 * (u * (L * L)) /\ len image <= 1.2073 * (L * L) /\ len image <= 1.2073 * (G * L)) /\
  / 10 ^ 140 <= len Y /\ 1 - 3.6 * u <= i * len Y <= 1 + 3.6 * u /\ 36.48 * (i * (u * (L * L))) <= r /\
  579 * (u * (L * L)) <= len Y /\ i <= 10 ^ 70.
Proof.
  intros p0 p1 q k0 k1 U gc Dc hc S d L Lq y t c In K Hc G image Y i r High i0 Hr.
  generalize u_pos u_val (power_positive 26). intros U0 Hu P26.
  destruct (way_vector_near _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ In K) as [Near Size]. fold G image in Near, Size.
  change (way_vector U gc hc Dc) with Y in Near. destruct In as [_ _ _ _ LD _ HL HLq [HG _]]. fold G in HL, HG.
  assert (d0 : 0 <= d) by (generalize (len_nonneg (D p0 p1 k0 k1)); lra).
  destruct (sizes_of_way G d L ltac:(lra) d0 HL) as [S1 [S2 [S3 [S4 S5]]]].
  assert (N : len (vsub Y image) <= 24.51 * (u * (L * L))).
  { eapply Rle_trans; [exact Near|]. assert (0 <= u * (L * L)) by (apply Rmult_le_pos; [lra | apply Rle_0_sqr]).
    assert (u * (21.04 * (G * d) + 9.61 * (G * G)) <= u * (24.5 * (L * L))) by (apply Rmult_le_compat_l; lra). lra. }
  assert (LL : 0 < L * L) by (apply Rmult_lt_0_compat; lra). assert (GL : 0 < G * L) by (apply Rmult_lt_0_compat; lra).
  assert (I1 : len image <= 1.2073 * (L * L)).
  { eapply Rle_trans; [exact Size|]. apply Rle_trans with ((1 + 16 * u) * (1.2072 * (L * L)));
      [apply Rmult_le_compat_l; lra | rewrite Hu; lra]. }
  assert (I2 : len image <= 1.2073 * (G * L)).
  { eapply Rle_trans; [exact Size|]. apply Rle_trans with ((1 + 16 * u) * (1.2072 * (G * L)));
      [apply Rmult_le_compat_l; lra | rewrite Hu; lra]. }
  assert (Below : len Y <= 1.3 * (L * L)) by (assert (F := len_from Y image); rewrite Hu in *; lra).
  split; [repeat split; assumption|]. split; [repeat split; assumption|].
  apply (inverse_of_rounding Y c Lq L); try assumption; [apply way_vector_format | lra].
Qed.
