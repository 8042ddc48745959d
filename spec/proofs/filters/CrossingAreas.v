(* The height of a crossing (passage() and direction_behind() of src/flow/kernels/direction_across.h): the angle under
   which a corner sees the next facet, times the ratio of both areas and of both edges. `height_of_areas` and
   `height_of_triangle`: what is computed is no smaller than the true one, but for 20 roundoffs. Nothing underflows
   that matters, because a height that is not huge leaves much of the second area (`there_floor`). The sizes of a
   crossing are at least what the bound needs (`size_of_corner`, `size_of_polygon`). This is about real numbers. *)
From Coq Require Import Reals Lra Lia Psatz.
From Flocq Require Import Core.
From Flowcert Require Import algebra.Vector3 filters.Rounding filters.RoundedVectors filters.Norms filters.Floors
  filters.Directions filters.DirectionVectors filters.CrossingLengths.
Open Scope R_scope.

(* ---- The ratio of areas, and the height ---- *)

Definition area_ratio here there := rnd (rnd (here * here) / rnd (there * there)).
Definition scaling_of ratio next e := rnd (sqrt (rnd (rnd (ratio * rdot next next) / rdot e e))).
Definition height_of angle square t0 t1 scaling := rnd (rnd (Rabs (rdot t0 t1) + rnd (angle * square)) * scaling).

(* The root of what algebra.Crossing.norm_square has beside the square of h. *)
Definition true_height t0 t1 N N' n e :=
  sqrt (dot t0 t1 * dot t0 t1 * (dot N N / dot N' N') * (dot n n / dot e e)).

Lemma rnd_nonneg : forall x, 0 <= x -> 0 <= rnd x.
Proof. intros. unfold rnd. apply round_ge_generic; auto with typeclass_instances. apply generic_format_0. Qed.
Lemma below_rnd : forall x, 0 <= x -> x <= 2 * rnd x + tau.
Proof.
  intros x X. assert (R := rnd_any x). rewrite (Rabs_pos_eq x X) in R. apply Rabs_le_inv in R.
  generalize u_small tau_pos. intros U0 T0. assert (u * x <= / 10 ^ 15 * x) by (apply Rmult_le_compat_r; lra).
  assert (u * tau <= / 10 ^ 15 * tau) by (apply Rmult_le_compat_r; lra). lra.
Qed.
Lemma quotient_nonneg : forall x y, 0 <= x -> 0 < y -> 0 <= x / y.
Proof. intros. apply Rmult_le_pos; [assumption | left; apply Rinv_0_lt_compat; assumption]. Qed.

(* A height that is not huge leaves much of the second area, `there`. *)
Section Floor.
Variables here there nn ee W n e L : R.
Hypothesis L_floor : / 10 ^ 26 <= L.
Hypothesis n_range : / 10 ^ 26 <= n <= 10 ^ 26.
Hypothesis e_range : / 10 ^ 26 <= e <= L.
Hypothesis nn_least : n * n <= 1.01 * nn.
Hypothesis ee_most : 0 < ee <= 1.01 * (e * e).
Hypothesis here_least : 4.89 / 10 ^ 44 * (L * L) <= here.
Hypothesis W_least : 5.5 / 10 ^ 16 * (L * L) <= W.
Hypothesis there_positive : 0 < there.
Hypothesis no_underflow : rnd (there * there) <> 0.
Let ratio := area_ratio here there.
Let y := rnd (ratio * nn).
Let z := rnd (y / ee).
Let s := rnd (sqrt z).
Hypothesis not_huge : rnd (W * s) <= 10 ^ 30 * (L * L).

Lemma squares_floor : / 10 ^ 52 <= L * L /\ / 10 ^ 52 <= n * n <= 10 ^ 52 /\ / 10 ^ 52 <= e * e <= L * L.
Proof.
  assert (P := power_positive 26).
  split; [apply (floor_mult 26 26); lra|]. split; [split; [apply (floor_mult 26 26); lra|]|].
  - replace (10 ^ 52) with (10 ^ 26 * 10 ^ 26) by (rewrite <- pow_add; reflexivity). apply Rmult_le_compat; lra.
  - split; [apply (floor_mult 26 26); lra | apply Rmult_le_compat; lra].
Qed.
Lemma there_square_positive : 0 < rnd (there * there).
Proof. assert (0 <= rnd (there * there)) by (apply rnd_nonneg, Rmult_le_pos; lra). lra. Qed.
Lemma here_square_least : 2.3 / 10 ^ 87 * (L * L * (L * L)) <= rnd (here * here).
Proof.
  destruct squares_floor as [L2 _]. assert (P := power_positive 52). generalize u_small. intro U0.
  assert (L4 : / 10 ^ (52 + 52) <= L * L * (L * L)) by (apply floor_mult; assumption). change (52 + 52)%nat with
    104%nat in
    L4.
  assert (H : 4.89 / 10 ^ 44 * (L * L) * (4.89 / 10 ^ 44 * (L * L)) <= here * here) by (apply Rmult_le_compat; lra).
  assert (N : / 10 ^ 292 <= here * here).
  { eapply Rle_trans; [apply (power_below 292 (88 + 104)); lia|].
    apply Rle_trans with (/ 10 ^ 88 * (L * L * (L * L))); [apply floor_mult; [apply Rle_refl | exact L4]|].
    eapply Rle_trans; [|exact H]. assert (P4 := power_positive 104). lra. }
  destruct (rnd_near _ N) as [R _]. assert (P4 := power_positive 104).
  assert (here * here * 0.99 <= here * here * (1 - 1.0001 * u))
    by (apply Rmult_le_compat_l; [apply Rle_0_sqr | lra]). lra.
Qed.
Lemma ratio_nonneg : 0 <= ratio.
Proof.
  apply rnd_nonneg, quotient_nonneg; [apply rnd_nonneg, Rle_0_sqr | apply there_square_positive].
Qed.
Lemma scaling_most : s <= 6 * 10 ^ 45.
Proof.
  destruct squares_floor as [L2 _]. assert (P := power_positive 52).
  assert (s0 : 0 <= s) by apply rnd_nonneg, sqrt_pos.
  assert (W0 : 0 <= W) by lra.
  assert (B := below_rnd (W * s) (Rmult_le_pos _ _ W0 s0)).
  assert (T : tau <= / 10 ^ 20 * (L * L)) by (apply (tau_power 52); [lia | exact L2]).
  assert (5.5 / 10 ^ 16 * (L * L) * s <= W * s) by (apply Rmult_le_compat_r; assumption).
  apply Rmult_le_reg_l with (L * L); [lra|]. lra.
Qed.
Lemma ratio_most : ratio * (n * n) <= 7.4 * 10 ^ 92 * (e * e).
Proof.
  destruct squares_floor as [L2 [N2 E2]]. assert (P := power_positive 52). assert (S := scaling_most).
  assert (Te : tau <= / 10 ^ 20 * (e * e)) by (apply (tau_power 52); [lia | lra]).
  assert (T1 : tau <= 1) by (generalize tau_small (power_below 300 0 ltac:(lia)); rewrite pow_O, Rinv_1; lra).
  assert (nn0 : 0 <= nn) by lra. assert (R0 := ratio_nonneg).
  assert (y0 : 0 <= y) by (apply rnd_nonneg, Rmult_le_pos; assumption).
  assert (z0 : 0 <= z) by (apply rnd_nonneg, quotient_nonneg; lra).
  assert (B := below_rnd _ (sqrt_pos z)). fold s in B.
  assert (Z : z <= 1.3 * 10 ^ 46 * (1.3 * 10 ^ 46)).
  { rewrite <- (sqrt_sqrt z z0). apply Rmult_le_compat; try apply sqrt_pos; lra. }
  assert (B1 := below_rnd (y / ee) (quotient_nonneg _ _ y0 (proj1 ee_most))). fold z in B1.
  assert (Y : y <= 3.5 * 10 ^ 92 * ee).
  { replace y with (y / ee * ee) at 1 by (field; lra). apply Rmult_le_compat_r; lra. }
  assert (B2 := below_rnd (ratio * nn) (Rmult_le_pos _ _ R0 nn0)). fold y in B2.
  assert (ratio * (n * n) <= ratio * (1.01 * nn)) by (apply Rmult_le_compat_l; assumption). lra.
Qed.
Lemma there_floor : / 10 ^ 90 * (L * n) <= there.
Proof.
  destruct squares_floor as [L2 [N2 E2]]. assert (P := power_positive 52). assert (P26 := power_positive 26).
  assert (Rm := ratio_most). assert (Hh := here_square_least). assert (tt0 := there_square_positive).
  assert (hh0 : 0 <= rnd (here * here)) by apply rnd_nonneg, Rle_0_sqr.
  assert (B := below_rnd _ (quotient_nonneg _ _ hh0 tt0)). fold (area_ratio here there) ratio in B.
  assert (T : tau * (n * n) <= e * e).
  { apply Rle_trans with (/ 10 ^ 200 * 10 ^ 52).
    - apply Rmult_le_compat; [left; apply tau_pos | lra | | lra].
      eapply Rle_trans; [apply tau_small | apply power_below; lia].
    - apply Rle_trans with (/ 10 ^ 52); [|lra]. lra. }
  set (hh := rnd (here * here)) in *. set (tt := rnd (there * there)) in *.
  assert (Q : hh / tt * (n * n) <= 1.5 * 10 ^ 93 * (e * e)).
  { assert (hh / tt * (n * n) <= (2 * ratio + tau) * (n * n)) by (apply Rmult_le_compat_r; [lra | exact B]). lra. }
  assert (Q1 : hh * (n * n) <= 1.5 * 10 ^ 93 * (L * L) * tt).
  { replace (hh * (n * n)) with (hh / tt * (n * n) * tt) by (field; lra). apply Rmult_le_compat_r; lra. }
  assert (Q2 : 2.3 / 10 ^ 87 * (L * L * (L * L)) * (n * n) <= hh * (n * n)) by (apply Rmult_le_compat_r; lra).
  assert (Q3 : 1.5 / 10 ^ 180 * (L * L * (n * n)) <= tt).
  { apply Rmult_le_reg_l with (L * L); [lra|].
    assert (0 <= L * L * (L * L) * (n * n)) by (apply Rmult_le_pos; [apply Rle_0_sqr | lra]).
    apply Rmult_le_reg_l with (1.5 * 10 ^ 93); [lra|].
    apply Rle_trans with (2.3 / 10 ^ 87 * (L * L * (L * L)) * (n * n)); [|lra].
    replace (1.5 * 10 ^ 93 * (L * L * (1.5 / 10 ^ 180 * (L * L * (n * n))))) with
      (1.5 * 10 ^ 93 * (1.5 / 10 ^ 180) * (L * L * (L * L) * (n * n))) by ring.
    rewrite (Rmult_assoc (2.3 / 10 ^ 87)). apply Rmult_le_compat_r; [assumption|]. lra. }
  assert (X : / 10 ^ (52 + 52) <= L * L * (n * n)) by (apply floor_mult; lra). change (52 + 52)%nat with 104%nat in X.
  assert (P4 := power_positive 104).
  assert (R := rnd_any (there * there)). assert (t0 : 0 <= there * there) by apply Rle_0_sqr.
  rewrite (Rabs_pos_eq _ t0) in R. fold tt in R. apply Rabs_le_inv in R. generalize u_small tau_pos. intros U0 T0.
  assert (T2 : tau <= / 10 ^ 190 * (L * L * (n * n))) by (apply (tau_power 104); [lia | exact X]).
  assert (u * (there * there) <= 0.01 * (there * there)) by (apply Rmult_le_compat_r; lra).
  assert (u * tau <= 0.01 * tau) by (apply Rmult_le_compat_r; lra).
  assert (tt1 : 1.1 / 10 ^ 180 * (L * L * (n * n)) <= there * there) by lra.
  apply Rnot_lt_le. intro N.
  assert (there * there <= / 10 ^ 90 * (L * n) * (/ 10 ^ 90 * (L * n))) by (apply Rmult_le_compat; lra).
  replace (/ 10 ^ 90 * (L * n) * (/ 10 ^ 90 * (L * n))) with (/ 10 ^ 180 * (L * L * (n * n))) in *; [lra|].
  replace (/ 10 ^ 180) with (/ 10 ^ 90 * / 10 ^ 90) by (rewrite <- Rinv_mult, <- pow_add; reflexivity). ring.
Qed.
End Floor.

(* The scaling is at least this, where the ratio of areas is at least F. *)
Lemma scaling_least : forall k F ratio nc ec n e, vapprox 1 nc n -> vapprox 1 ec e ->
  / 10 ^ 26 <= len n <= 10 ^ 26 -> / 10 ^ 26 <= len e <= 10 ^ 26 -> 0 <= F -> 0 <= k <= 20 ->
  at_least k F ratio -> / 10 ^ 100 <= ratio ->
  at_least (k / 2 + 7.01) (sqrt (F * (dot n n / dot e e))) (scaling_of ratio nc ec) /\
  / 10 ^ 110 <= scaling_of ratio nc ec.
Proof.
  intros k F ratio nc ec n e An Ae Hn He F0 K HF HR. assert (P26 := power_positive 26).
  assert (P144 := power_below 144 26 ltac:(lia)). generalize u_small. intro U0.
  destruct (difference_square _ _ An ltac:(lra)) as [N1 _]. destruct (difference_square _ _ Ae ltac:(lra)) as [E1 E2].
  assert (n2 : / 10 ^ (26 + 26) <= dot n n) by (rewrite <- len_sq; apply floor_mult; lra).
  assert (e2 : / 10 ^ (26 + 26) <= dot e e) by (rewrite <- len_sq; apply floor_mult; lra).
  assert (e3 : dot e e <= 10 ^ 52).
  { replace (10 ^ 52) with (10 ^ 26 * 10 ^ 26) by (rewrite <- pow_add; reflexivity). rewrite <- len_sq.
    apply Rmult_le_compat; lra. }
  change (26 + 26)%nat with 52%nat in *. assert (P52 := power_positive 52).
  unfold scaling_of. set (nn := rdot nc nc) in *. set (ee := rdot ec ec) in *.
  assert (L53 : / 10 ^ 53 = / 10 * / 10 ^ 52) by (rewrite <- Rinv_mult; reflexivity).
  assert (nn0 : / 10 ^ 53 <= nn).
  { assert (dot n n * 0.5 <= dot n n * (1 - 5.001 * u)) by (apply Rmult_le_compat_l; lra). lra. }
  assert (ee0 : 0 < ee <= 1.1 * 10 ^ 52).
  { assert (dot e e * 0.5 <= dot e e * (1 - 5.001 * u)) by (apply Rmult_le_compat_l; lra).
    assert (dot e e * (1 + 5.001 * u) <= dot e e * 1.1) by (apply Rmult_le_compat_l; lra). lra. }
  change (at_least 5.001 (dot n n) nn) in N1. change (at_most 5.001 (dot e e) ee) in E2.
  assert (A := at_least_product k 5.001 _ _ _ _ F0 (dot_self_nonneg n) ltac:(lra) ltac:(lra) HF N1).
  assert (A0 : / 10 ^ (100 + 53) <= ratio * nn) by (apply floor_mult; assumption).
  assert (Fn : 0 <= F * dot n n) by (apply Rmult_le_pos; [exact F0 | lra]).
  assert (Low : forall j, (j <= 292)%nat -> / 10 ^ 292 <= / 10 ^ j) by (intros; apply power_below; assumption).
  assert (Half : forall j x, (j <= 292)%nat -> / 10 ^ j <= x -> / 10 ^ (S j) <= rnd x).
  { intros j x J X. destruct (rnd_near x) as [R _]; [eapply Rle_trans; [apply Low, J | exact X]|].
    assert (Pj := power_positive j). assert (Sj : / 10 ^ S j = / 10 * / 10 ^ j) by (rewrite <- Rinv_mult; reflexivity).
    assert (x * 0.5 <= x * (1 - 1.0001 * u)) by (apply Rmult_le_compat_l; lra). lra. }
  change (100 + 53)%nat with 153%nat in A0.
  apply at_least_rnd in A; [|exact Fn | lra | eapply Rle_trans; [apply (Low 153%nat); lia | exact A0]].
  apply (Half 153%nat) in A0; [|lia]. set (y := rnd (ratio * nn)) in *.
  assert (B := at_least_quotient (k + 5.001 + 1.0001) 5.001 _ _ _ _ Fn (Rlt_le_trans _ _ _ P52 e2) (proj1 ee0)
    ltac:(lra)
    ltac:(lra) A E2).
  assert (B0 : / 10 ^ (154 + 53) <= y / ee).
  { unfold Rdiv. apply floor_mult; [exact A0|]. apply Rinv_le; [lra|].
    replace (10 ^ 53) with (10 * 10 ^ 52) by reflexivity. lra. }
  change (154 + 53)%nat with 207%nat in B0.
  assert (Q : F * (dot n n / dot e e) = F * dot n n / dot e e) by (unfold Rdiv; ring). rewrite Q.
  assert (Q0 : 0 <= F * dot n n / dot e e) by (apply quotient_nonneg; lra).
  apply at_least_rnd in B; [|exact Q0 | lra | eapply Rle_trans; [apply (Low 207%nat); lia | exact B0]].
  apply (Half 207%nat) in B0; [|lia]. set (z := rnd (y / ee)) in *.
  replace (k + 5.001 + 1.0001 + 5.001 + 1.0001) with (2 * (k / 2 + 6.0011)) in B by lra.
  apply at_least_root in B; [|exact Q0 | lra].
  assert (B1 : / 10 ^ 104 <= sqrt z).
  { rewrite <- (sqrt_square (/ 10 ^ 104)) by (left; apply power_positive). apply sqrt_le_1_alt.
    rewrite <- Rinv_mult, <- pow_add. exact B0. }
  apply at_least_rnd in B; [|apply sqrt_pos | lra | eapply Rle_trans; [apply (Low 104%nat); lia | exact B1]].
  split.
  - eapply at_least_weaken; [apply sqrt_pos | | exact B]. lra.
  - eapply Rle_trans; [apply (power_below 110 105); lia|]. apply (Half 104%nat); [lia | exact B1].
Qed.

(* The enlarged angle is no smaller than the true one, and not tiny. *)
Lemma angle_least : forall t0c t1c t0 t1 L square angle, vapprox 1 t0c t0 -> vapprox 1 t1c t1 ->
  / 10 ^ 26 <= L -> len t0 <= L -> len t1 <= L -> L * L * (1 - 14 * u) <= square -> 5.02 * u <= angle ->
  at_least 1.0001 (Rabs (dot t0 t1)) (rnd (Rabs (rdot t0c t1c) + rnd (angle * square))) /\
  5.5 / 10 ^ 16 * (L * L) <= rnd (Rabs (rdot t0c t1c) + rnd (angle * square)).
Proof.
  intros t0c t1c t0 t1 L square angle A0 A1 HL H0 H1 HS HA. generalize u_small tau_pos. intros U0 T0.
  assert (P26 := power_positive 26).
  assert (LL : / 10 ^ (26 + 26) <= L * L) by (apply floor_mult; exact HL). change (26 + 26)%nat with 52%nat in LL.
  assert (P52 := power_positive 52). assert (T := tau_power 52 50 _ ltac:(lia) LL).
  assert (U16 : 1.11 / 10 ^ 16 <= u) by (rewrite u_val; lra).
  destruct (rdot_approx 1 1 _ _ _ _ A0 A1) as [_ D _]. change (1 + 1 + 3)%nat with 5%nat in D.
  assert (Ad : absdot t0 t1 <= L * L).
  { eapply Rle_trans; [apply absdot_len|]. apply Rmult_le_compat; auto using len_nonneg. }
  assert (Ad0 : 0 <= absdot t0 t1)
    by (eapply Rle_trans; [|apply absdot_dot]; apply Rabs_pos).
  assert (E5 : E 5 <= 5.0001 * u) by (unfold E; rewrite u_val; simpl; lra).
  assert (D1 : E 5 * (absdot t0 t1 + 3 * tau) <= 5.0001 * u * (L * L + 3 * tau)).
  { apply Rmult_le_compat; [apply E_nonneg | lra | exact E5 | lra]. }
  assert (uL : 0 < u * (L * L)) by (apply Rmult_lt_0_compat; lra).
  assert (uT : u * tau <= / 10 ^ 50 * (u * (L * L))).
  { replace (/ 10 ^ 50 * (u * (L * L))) with (u * (/ 10 ^ 50 * (L * L))) by ring. apply Rmult_le_compat_l; lra. }
  assert (C1 : at_least 0 (5.02 * u) angle) by (unfold at_least; lra).
  assert (C2 : at_least 14 (L * L) square) by exact HS.
  assert (C := at_least_product 0 14 (5.02 * u) _ _ _ ltac:(lra) (Rlt_le _ _ (Rlt_le_trans _ _ _ P52 LL))
    ltac:(lra) ltac:(lra) C1 C2).
  assert (N : / 10 ^ 292 <= angle * square).
  { eapply Rle_trans; [apply (power_below 292 (16 + 53)); lia|]. apply floor_mult; [lra|].
    assert (L53 : / 10 ^ 53 = / 10 * / 10 ^ 52) by (rewrite <- Rinv_mult; reflexivity).
    assert (L * L * 0.5 <= L * L * (1 - 14 * u)) by (apply Rmult_le_compat_l; lra). lra. }
  assert (X0 : 0 <= 5.02 * u * (L * L)) by lra.
  apply at_least_rnd in C; [|exact X0 | lra | exact N]. unfold at_least in C.
  set (r := rnd (angle * square)) in *. set (hk := rdot t0c t1c) in *.
  assert (r1 : 5.0199 * u * (L * L) <= r).
  { eapply Rle_trans; [|exact C].
    assert (5.02 * u * (L * L) * (1 - / 10 ^ 10) <= 5.02 * u * (L * L) * (1 - (0 + 14 + 1.0001) * u))
      by (apply Rmult_le_compat_l; lra). lra. }
  assert (hk1 : Rabs (dot t0 t1) <= Rabs hk + 5.0002 * u * (L * L)).
  { assert (B := Rabs_triang hk (dot t0 t1 - hk)). replace (hk + (dot t0 t1 - hk)) with (dot t0 t1) in B by ring.
    rewrite Rabs_minus_sym in D. lra. }
  assert (hk0 := Rabs_pos hk).
  assert (r2 : / 10 ^ 292 <= Rabs hk + r).
  { apply Rle_trans with (5.0199 * u * (L * L)); [|lra].
    eapply Rle_trans; [apply (power_below 292 (16 + 52)); lia|]. apply floor_mult; lra. }
  split.
  - assert (G : at_least 0 (Rabs (dot t0 t1)) (Rabs hk + r)) by (unfold at_least; lra).
    apply at_least_rnd in G; [|apply Rabs_pos | lra | exact r2].
    eapply at_least_weaken; [apply Rabs_pos | | exact G]. lra.
  - destruct (rnd_near _ r2) as [G _]. eapply Rle_trans; [|exact G].
    assert (1.11 / 10 ^ 16 * (L * L) <= u * (L * L)) by (apply Rmult_le_compat_r; lra).
    assert ((Rabs hk + r) * (1 - / 10 ^ 10) <= (Rabs hk + r) * (1 - 1.0001 * u)) by (apply Rmult_le_compat_l; lra).
    lra.
Qed.

Lemma height_least : forall k F t0c t1c t0 t1 L square angle nc ec n e ratio,
  vapprox 1 t0c t0 -> vapprox 1 t1c t1 -> vapprox 1 nc n -> vapprox 1 ec e ->
  / 10 ^ 26 <= len n <= 10 ^ 26 -> / 10 ^ 26 <= len e <= 10 ^ 26 -> / 10 ^ 26 <= L -> len t0 <= L -> len t1 <= L ->
  L * L * (1 - 14 * u) <= square -> 5.02 * u <= angle -> 0 <= F -> 0 <= k <= 20 -> at_least k F ratio ->
  / 10 ^ 100 <= ratio ->
  at_least (k / 2 + 9.1) (sqrt (dot t0 t1 * dot t0 t1 * F * (dot n n / dot e e)))
    (height_of angle square t0c t1c (scaling_of ratio nc ec)).
Proof.
  intros k F t0c t1c t0 t1 L square angle nc ec n e ratio A0 A1 An Ae Hn He HL H0 H1 HS HA F0 K HF HR.
  destruct (angle_least t0c t1c t0 t1 L square angle A0 A1 HL H0 H1 HS HA) as [W1 W2].
  destruct (scaling_least k F ratio nc ec n e An Ae Hn He F0 K HF HR) as [S1 S2].
  unfold height_of. set (W := rnd (Rabs (rdot t0c t1c) + rnd (angle * square))) in *.
  set (s := scaling_of ratio nc ec) in *.
  assert (W3 : / 10 ^ 68 <= W).
  { eapply Rle_trans; [apply (floor_mult 16 52 (/ 10 ^ 16) (L * L)); [apply Rle_refl | apply (floor_mult 26 26); exact
    HL]|].
    assert (0 <= L * L) by apply Rle_0_sqr. lra. }
  replace (sqrt (dot t0 t1 * dot t0 t1 * F * (dot n n / dot e e))) with
    (Rabs (dot t0 t1) * sqrt (F * (dot n n / dot e e))).
  2: { rewrite (Rmult_assoc (dot t0 t1 * dot t0 t1)), (sqrt_mult_alt (dot t0 t1 * dot t0 t1)) by apply Rle_0_sqr.
       f_equal. symmetry. apply sqrt_Rsqr_abs. }
  assert (X := at_least_product 1.0001 (k / 2 + 7.01) _ _ _ _ (Rabs_pos _) (sqrt_pos _) ltac:(lra) ltac:(lra) W1 S1).
  assert (X0 : 0 <= Rabs (dot t0 t1) * sqrt (F * (dot n n / dot e e)))
    by (apply Rmult_le_pos; [apply Rabs_pos | apply sqrt_pos]).
  apply at_least_rnd in X; [|exact X0 | lra |].
  - eapply at_least_weaken; [exact X0 | | exact X]. lra.
  - eapply Rle_trans; [apply (power_below 292 (68 + 110)); lia|]. apply floor_mult; assumption.
Qed.

(* ---- The height behind a polygon, and behind a triangle ---- *)

Theorem height_of_areas : forall a b t0 t1 e n ac bc t0c t1c ec nc L square area angle,
  vapprox 1 ac a -> vapprox 1 bc b -> vapprox 1 t0c t0 -> vapprox 1 t1c t1 -> vapprox 1 ec e -> vapprox 1 nc n ->
  / 10 ^ 26 <= len e <= 10 ^ 26 -> / 10 ^ 26 <= len n <= 10 ^ 26 -> / 10 ^ 26 <= L ->
  L <= 10 ^ 14 * len a -> L <= 10 ^ 14 * len b -> len e <= L -> len t0 <= L -> len t1 <= L ->
  L * L * (1 - 14 * u) <= square -> 4.42 * u <= area -> 5.02 * u <= angle ->
  let here := area_here area ac bc in let there := area_there area t0c t1c in
  let height := height_of angle square t0c t1c (scaling_of (area_ratio here there) nc ec) in
  0 < there -> rnd (there * there) <> 0 -> height <= 10 ^ 30 * (L * L) ->
  0 < dot (cross t0 t1) (cross t0 t1) /\
  true_height t0 t1 (cross a b) (cross t0 t1) n e * (1 - 20 * u) <= height.
Proof.
  intros a b t0 t1 e n ac bc t0c t1c ec nc L square area angle Aa Ab A0 A1 Ae An He Hn HL La Lb Le L0 L1 HS HC HA here
    there height There NoUnderflow NotHuge.
  assert (P26 := power_positive 26). generalize u_small. intro U0.
  assert (P50 : forall x, L <= 10 ^ 14 * x -> / 10 ^ 14 * L <= x) by (intros; lra).
  assert (Fa := P50 _ La). assert (Fb := P50 _ Lb).
  assert (P50' : forall x, / 10 ^ 14 * L <= x -> / 10 ^ 50 <= x).
  { intros x X. eapply Rle_trans; [apply (power_below 50 (14 + 26)); lia|]. eapply Rle_trans; [|exact X].
    apply floor_mult; [apply Rle_refl | exact HL]. }
  destruct (area_here_least area ac bc a b Aa Ab (P50' _ Fa) (P50' _ Fb) HC) as [Here1 Here2].
  fold here in Here1, Here2.
  assert (LL : / 10 ^ (26 + 26) <= L * L) by (apply floor_mult; exact HL). change (26 + 26)%nat with 52%nat in LL.
  assert (P52 := power_positive 52).
  assert (Here3 : 4.89 / 10 ^ 44 * (L * L) <= here).
  { eapply Rle_trans; [|exact Here2].
    assert (X : / 10 ^ 14 * L * (/ 10 ^ 14 * L) <= len a * len b) by (apply Rmult_le_compat; lra).
    replace (/ 10 ^ 14 * L * (/ 10 ^ 14 * L)) with (/ 10 ^ 28 * (L * L)) in X by field.
    assert (U16 : 4.89 / 10 ^ 16 <= 4.41 * u) by (rewrite u_val; lra).
    apply Rle_trans with (4.89 / 10 ^ 16 * (/ 10 ^ 28 * (L * L))); [lra|]. apply Rmult_le_compat; lra. }
  destruct (angle_least t0c t1c t0 t1 L square angle A0 A1 HL L0 L1 HS HA) as [_ W2].
  assert (P144 := power_below 144 26 ltac:(lia)).
  destruct (difference_square _ _ An ltac:(lra)) as [N1 _]. destruct (difference_square _ _ Ae ltac:(lra)) as [E1 E2].
  assert (n2 : / 10 ^ 52 <= dot n n) by (rewrite <- len_sq; apply (floor_mult 26 26); lra).
  assert (e2 : / 10 ^ 52 <= dot e e) by (rewrite <- len_sq; apply (floor_mult 26 26); lra).
  assert (Floor : / 10 ^ 90 * (L * len n) <= there).
  { apply (there_floor here there (rdot nc nc) (rdot ec ec)
      (rnd (Rabs (rdot t0c t1c) + rnd (angle * square))) (len n) (len e) L); try assumption.
    - split; [apply He | exact Le].
    - rewrite len_sq. assert (dot n n * (1 - / 10 ^ 10) <= dot n n * (1 - 5.001 * u)) by (apply Rmult_le_compat_l; lra).
      lra.
    - rewrite len_sq. assert (dot e e * 0.5 <= dot e e * (1 - 5.001 * u)) by (apply Rmult_le_compat_l; lra).
      assert (dot e e * (1 + 5.001 * u) <= dot e e * 1.01) by (apply Rmult_le_compat_l; lra). lra. }
  assert (Ln : / 10 ^ (26 + 26) <= L * len n) by (apply floor_mult; lra).
  assert (There143 : / 10 ^ 143 <= there).
  { eapply Rle_trans; [apply (power_below 143 (90 + 52)); lia|]. eapply Rle_trans; [|exact Floor].
    apply floor_mult; [apply Rle_refl | exact Ln]. }
  destruct (area_there_floor area t0c t1c t0 t1 A0 A1 ltac:(lra) There143) as [Prod _]. fold there in Prod.
  assert (Long : forall x y, 0 <= x -> 0 <= y -> y <= L -> there <= 2.1 * (x * y) -> / 10 ^ 120 <= x).
  { intros x y X Y YL H. apply Rnot_lt_le. intro N.
    assert (x * y <= / 10 ^ 120 * L) by (apply Rmult_le_compat; lra).
    assert (L * / 10 ^ 26 <= L * len n) by (apply Rmult_le_compat_l; lra).
    assert (M : / 10 ^ 120 = / 10 ^ 4 * / 10 ^ 90 * / 10 ^ 26) by (rewrite <- !Rinv_mult, <- !pow_add; reflexivity).
    assert (0 < / 10 ^ 90 * (L * / 10 ^ 26)).
    { apply Rmult_lt_0_compat; [apply power_positive | apply Rmult_lt_0_compat; lra]. }
    assert (/ 10 ^ 90 * (L * / 10 ^ 26) <= / 10 ^ 90 * (L * len n))
      by (apply Rmult_le_compat_l; [left; apply power_positive | assumption]). rewrite M in *. lra. }
  assert (Long0 := Long _ _ (len_nonneg t0) (len_nonneg t1) L1 Prod).
  assert (Long1 : / 10 ^ 120 <= len t1).
  { apply (Long _ (len t0)); auto using len_nonneg. rewrite (Rmult_comm (len t1)). exact Prod. }
  destruct (area_there_most area t0c t1c t0 t1 A0 A1 HC Long0 Long1 There143) as [There1 Area]. fold there in There1.
  assert (DD : 0 < dot (cross t0 t1) (cross t0 t1)) by (rewrite <- len_sq; apply Rmult_lt_0_compat; exact Area).
  split; [exact DD|].
  (* the ratio *)
  assert (HH := at_least_product 3.52 3.52 _ _ _ _ (len_nonneg _) (len_nonneg _) ltac:(lra) ltac:(lra) Here1 Here1).
  assert (Hh := here_square_least here (len n) (len e) L HL Hn (conj (proj1 He) Le) Here3).
  assert (L4 : / 10 ^ (52 + 52) <= L * L * (L * L)) by (apply floor_mult; assumption).
  change (52 + 52)%nat with 104%nat in L4. assert (P104 := power_positive 104).
  assert (hh1 : / 10 ^ 292 <= here * here).
  { eapply Rle_trans; [apply (power_below 292 (88 + 104)); lia|].
    apply Rle_trans with (/ 10 ^ 88 * (L * L * (L * L))); [apply floor_mult; [apply Rle_refl | exact L4]|].
    assert (4.89 / 10 ^ 44 * (L * L) * (4.89 / 10 ^ 44 * (L * L)) <= here * here) by (apply Rmult_le_compat; lra). lra.
      }
  rewrite len_sq in HH. apply at_least_rnd in HH; [|apply dot_self_nonneg | lra | exact hh1].
  assert (TT := at_most_product 3.53 3.53 _ _ _ _ (Rlt_le _ _ There) (Rlt_le _ _ There) (len_nonneg _) (len_nonneg _)
    ltac:(lra) ltac:(lra) There1 There1).
  assert (tt1 : / 10 ^ 292 <= there * there).
  { eapply Rle_trans; [apply (power_below 292 (143 + 143)); lia|]. apply floor_mult; assumption. }
  rewrite len_sq in TT. apply at_most_rnd in TT; [|lra | split; lra | exact tt1].
  assert (tt0 := there_square_positive there There NoUnderflow).
  assert (Q := at_least_quotient (3.52 + 3.52 + 1.0001) (3.53 + 3.53 + 0.0001 + 1.0002) _ _ _ _ (dot_self_nonneg _) DD
    tt0
    ltac:(lra) ltac:(lra) HH TT).
  assert (Q0 : 0 <= dot (cross a b) (cross a b) / dot (cross t0 t1) (cross t0 t1))
    by (apply quotient_nonneg; [apply dot_self_nonneg | exact DD]).
  assert (There2 : rnd (there * there) <= 10 * (L * L * (L * L))).
  { destruct (rnd_near _ tt1) as [_ R]. eapply Rle_trans; [exact R|].
    assert (len t0 * len t1 <= L * L) by (apply Rmult_le_compat; auto using len_nonneg).
    assert (there * there <= 2.1 * (L * L) * (2.1 * (L * L))) by (apply Rmult_le_compat; lra).
    assert (there * there * (1 + 1.0001 * u) <= 2.1 * (L * L) * (2.1 * (L * L)) * 2).
    { apply Rmult_le_compat; [apply Rle_0_sqr | lra | assumption | lra]. } lra. }
  assert (q1 : / 10 ^ 90 <= rnd (here * here) / rnd (there * there)).
  { apply Rmult_le_reg_r with (rnd (there * there)); [exact tt0|].
    replace (rnd (here * here) / rnd (there * there) * rnd (there * there)) with (rnd (here * here)) by (field; lra).
    eapply Rle_trans; [|exact Hh].
    apply Rle_trans with (/ 10 ^ 90 * (10 * (L * L * (L * L)))).
    - apply Rmult_le_compat_l; [left; apply power_positive | exact There2].
    - lra. }
  assert (q292 : / 10 ^ 292 <= rnd (here * here) / rnd (there * there))
    by (eapply Rle_trans; [apply (power_below 292 90); lia | exact q1]).
  apply at_least_rnd in Q; [|exact Q0 | lra | exact q292]. fold (area_ratio here there) in Q.
  assert (r1 : / 10 ^ 100 <= area_ratio here there).
  { destruct (rnd_near _ q292) as [R _]. eapply Rle_trans; [|exact R].
    assert (P90 := power_positive 90).
    assert (M : / 10 ^ 100 = / 10 ^ 10 * / 10 ^ 90) by (rewrite <- Rinv_mult, <- pow_add; reflexivity). rewrite M.
    set (q := rnd (here * here) / rnd (there * there)) in *.
    assert (q * 0.5 <= q * (1 - 1.0001 * u)) by (apply Rmult_le_compat_l; lra). lra. }
  assert (Z := height_least (3.52 + 3.52 + 1.0001 + (3.53 + 3.53 + 0.0001 + 1.0002) + 1.0001) _ t0c t1c t0 t1 L square
    angle nc
    ec n e _ A0 A1 An Ae Hn He HL L0 L1 HS HA Q0 ltac:(lra) Q r1).
  apply (at_least_weaken _ 20) in Z; [exact Z | apply sqrt_pos | lra].
Qed.

(* A triangle has the same area for both edges. *)
Theorem height_of_triangle : forall N N' t0 t1 e n t0c t1c ec nc L square angle,
  vapprox 1 t0c t0 -> vapprox 1 t1c t1 -> vapprox 1 ec e -> vapprox 1 nc n -> dot N N = dot N' N' ->
  / 10 ^ 26 <= len e <= 10 ^ 26 -> / 10 ^ 26 <= len n <= 10 ^ 26 -> / 10 ^ 26 <= L ->
  len t0 <= L -> len t1 <= L -> L * L * (1 - 14 * u) <= square -> 5.02 * u <= angle ->
  let height := height_of angle square t0c t1c (scaling_of 1 nc ec) in
  true_height t0 t1 N N' n e * (1 - 20 * u) <= height.
Proof.
  intros N N' t0 t1 e n t0c t1c ec nc L square angle A0 A1 Ae An HN He Hn HL L0 L1 HS HA height.
  assert (Q : 0 <= dot N N / dot N' N' <= 1).
  { rewrite HN. destruct (dot_self_nonneg N') as [P|Z].
    - replace (dot N' N' / dot N' N') with 1 by (field; lra). lra.
    - rewrite <- Z. unfold Rdiv. rewrite Rmult_0_l. lra. }
  assert (One : at_least 0 (dot N N / dot N' N') 1) by (unfold at_least; lra).
  assert (P : / 10 ^ 100 <= 1) by (generalize (power_below 100 0 ltac:(lia)); rewrite pow_O, Rinv_1; lra).
  assert (Z := height_least 0 _ t0c t1c t0 t1 L square angle nc ec n e 1 A0 A1 An Ae Hn He HL L0 L1 HS HA (proj1 Q)
    ltac:(lra) One P).
  apply (at_least_weaken _ 20) in Z; [exact Z | apply sqrt_pos | lra].
Qed.

(* ---- The size of what a crossing sees ---- *)

Lemma square_of_size : forall k X x, / 10 ^ 27 <= X -> 0 <= k <= 4.6 -> at_least k X x ->
  X * X * (1 - 14 * u) <= rnd (rnd x * rnd x).
Proof.
  intros k X x HX K H. generalize u_small. intro U0. assert (P := power_positive 27).
  assert (X28 : / 10 ^ 28 = / 10 * / 10 ^ 27) by (rewrite <- Rinv_mult; reflexivity).
  assert (ku : k * u <= / 10 ^ 10).
  { apply Rle_trans with (4.6 * / 10 ^ 15); [|lra]. apply Rmult_le_compat; lra. }
  assert (x1 : / 10 ^ 28 <= x).
  { unfold at_least in H. assert (X * 0.5 <= X * (1 - k * u)) by (apply Rmult_le_compat_l; lra). lra. }
  assert (X29 : / 10 ^ 29 = / 10 * / 10 ^ 28) by (rewrite <- Rinv_mult; reflexivity).
  assert (x292 : / 10 ^ 292 <= x) by (eapply Rle_trans; [apply (power_below 292 28); lia | exact x1]).
  assert (x2 : / 10 ^ 29 <= rnd x).
  { destruct (rnd_near x x292) as [R _].
    assert (x * 0.5 <= x * (1 - 1.0001 * u)) by (apply Rmult_le_compat_l; lra). lra. }
  apply at_least_rnd in H; [|lra | lra | exact x292].
  assert (Q := at_least_product (k + 1.0001) (k + 1.0001) X X _ _ ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) H H).
  apply at_least_rnd in Q; [|apply Rle_0_sqr | lra |].
  - apply (at_least_weaken _ 14) in Q; [exact Q | apply Rle_0_sqr | lra].
  - eapply Rle_trans; [apply (power_below 292 (29 + 29)); lia|]. apply floor_mult; assumption.
Qed.

Theorem size_of_corner : forall G root t tc, / 10 ^ 26 <= G -> G * (1 - 4.01 * u) <= root -> fmt root -> vapprox 1 tc t
  ->
  let size := rnd (root + rlength tc) in
  (G + len t) * (G + len t) * (1 - 14 * u) <= rnd (size * size).
Proof.
  intros G root t tc HG HR _ A size. assert (R := difference_length_least _ _ A). generalize u_small (len_nonneg t).
  intros U0 L0. assert (P := power_positive 26). assert (P27 := power_below 27 26 ltac:(lia)).
  apply (square_of_size 4.02); [lra | lra|]. unfold at_least.
  assert (U16 : / 10 ^ 16 <= u) by (rewrite u_val; lra).
  assert (uG : / 10 ^ (16 + 26) <= u * G) by (apply floor_mult; assumption). change (16 + 26)%nat with 42%nat in uG.
  assert (M : / 10 ^ 145 <= / 10 ^ 10 * / 10 ^ 42).
  { rewrite <- Rinv_mult, <- pow_add. apply power_below. lia. }
  assert (0 <= u * len t) by (apply Rmult_le_pos; lra). assert (P42 := power_positive 42). lra.
Qed.
Theorem size_of_polygon : forall G root t w tc wc, / 10 ^ 26 <= G -> G * (1 - 4.01 * u) <= root -> fmt root ->
  vapprox 1 tc t -> vapprox 1 wc w ->
  let size := rnd (root + rnd (rlength tc + rlength wc)) in
  (G + (len t + len w)) * (G + (len t + len w)) * (1 - 14 * u) <= rnd (size * size).
Proof.
  intros G root t w tc wc HG HR _ A B size.
  assert (R := difference_length_least _ _ A). assert (S := difference_length_least _ _ B).
  generalize u_small (len_nonneg t) (len_nonneg w).
  intros U0 L0 L1. assert (P := power_positive 26). assert (P27 := power_below 27 26 ltac:(lia)).
  apply (square_of_size 4.6); [lra | lra|]. unfold at_least.
  assert (U16 : / 10 ^ 16 <= u) by (rewrite u_val; lra).
  assert (uG : / 10 ^ (16 + 26) <= u * G) by (apply floor_mult; assumption). change (16 + 26)%nat with 42%nat in uG.
  assert (M : / 10 ^ 145 <= / 10 ^ 10 * / 10 ^ 42).
  { rewrite <- Rinv_mult, <- pow_add. apply power_below. lia. }
  assert (P42 := power_positive 42). assert (P145 := power_positive 145).
  assert (D := rnd_plus (rlength tc) (rlength wc) (fmt_rnd _) (fmt_rnd _)).
  assert (d0 : 0 <= rlength tc + rlength wc) by (apply Rplus_le_le_0_compat; apply rlength_nonneg).
  rewrite (Rabs_pos_eq (_ + _) d0) in D. apply Rabs_le_inv in D.
  set (d := rlength tc + rlength wc) in *. set (z := len t + len w) in *.
  assert (d1 : z * (1 - 3.52 * u) - 2 * / 10 ^ 145 <= d) by (unfold d, z; lra).
  assert (z0 : 0 <= z) by (unfold z; lra).
  assert (d2 : (z * (1 - 3.52 * u) - 2 * / 10 ^ 145) * (1 - u) <= d * (1 - u)) by (apply Rmult_le_compat_r; lra).
  assert (uz : 0 <= u * z) by (apply Rmult_le_pos; lra). assert (0 <= u * (u * z)) by (apply Rmult_le_pos; lra).
  assert (0 <= u * / 10 ^ 145) by (apply Rmult_le_pos; lra). lra.
Qed.

(* No difference is longer than the size, neither the edge, nor those from the next edge's ends to the corner. *)
Lemma edge_below_seen_size : forall a b, len (vsub a b) <= seen_size a b.
Proof.
  intros a b. apply Rle_trans with (len a + len b); [|apply sum_below_seen_size].
  replace (vsub a b) with (vadd a (vscale (-1) b)) by (apply vec_eq; cbn; ring).
  eapply Rle_trans; [apply len_triangle|]. rewrite len_scale_any. replace (Rabs (-1)) with 1 by (rewrite Rabs_left;
    lra).
  lra.
Qed.
Lemma differences_below_size : forall G e t w, len e <= G ->
  let L := G + (len t + len w) in len e <= L /\ len t <= L /\ len (vsub w e) <= L.
Proof.
  intros G e t w H L. generalize (len_nonneg e) (len_nonneg t) (len_nonneg w). intros E0 T0 W0. unfold L.
  repeat split; try lra. replace (vsub w e) with (vadd w (vscale (-1) e)) by (apply vec_eq; cbn; ring).
  eapply Rle_trans; [apply len_triangle|]. rewrite len_scale_any. replace (Rabs (-1)) with 1 by (rewrite Rabs_left;
    lra).
  lra.
Qed.
