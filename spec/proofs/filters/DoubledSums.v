(* Sum and product of double-doubles (src/geometry/double_double.h) on rounded real numbers: the result is a
   double-double, and its relative error is at most 7 u^2 for a sum, 8.5 u^2 for a product, with u = 2^-53. A sum needs
   nothing else. A product has an absolute error of 5 times the smallest double, from the underflow of low parts. The
   sum of high parts that cancel is a multiple of the last place of the low parts' sum, and then the result is exact, or
   the error is small beside what is left. *)
From Coq Require Import Reals ZArith Lra Lia.
From Flocq Require Import Core Plus_error Sterbenz.
From Flowcert Require Import filters.Rounding filters.ExactSums.
Open Scope R_scope.

(* The double h is h + l, rounded. *)
Record doubled (h l : R) : Prop := Doubled { high_fmt : fmt h; low_fmt : fmt l; high_rounded : rnd (h + l) = h }.

(* ---- Sizes ---- *)

(* A new bound, from bounds of sizes and equations. *)
Ltac bound := rewrite ?u_val in *;
  repeat match goal with H : Rabs _ <= _ |- _ => apply Rabs_le_inv in H end; apply Rabs_le; lra.

Lemma size_of_near : forall a b e, Rabs (a - b) <= e -> Rabs b - e <= Rabs a /\ Rabs a <= Rabs b + e.
Proof.
  intros a b e H. generalize (Rabs_triang (a - b) b) (Rabs_triang (b - a) a). rewrite (Rabs_minus_sym b a).
  replace (a - b + b) with a by ring. replace (b - a + a) with b by ring. lra.
Qed.
Lemma rnd_plus_within : forall a b B, fmt a -> fmt b -> Rabs (a + b) <= B -> Rabs (rnd (a + b) - (a + b)) <= u * B.
Proof.
  intros a b B Ha Hb H. eapply Rle_trans; [apply rnd_plus; auto|]. apply Rmult_le_compat_l; [|exact H].
  generalize u_pos; lra.
Qed.
Lemma low_size : forall h l, doubled h l -> Rabs l <= u * Rabs h.
Proof.
  intros h l [Fh Fl E]. generalize (rnd_plus_result h l Fh Fl). rewrite E.
  replace (h - (h + l)) with (- l) by ring. rewrite Rabs_Ropp. auto.
Qed.
Lemma low_unit : forall h l, doubled h l -> h <> 0 -> Rabs l <= / 2 * bpow radix2 (cexp radix2 fexp h).
Proof.
  intros h l [Fh Fl E] N. generalize (error_le_half_ulp_round radix2 fexp even_choice (h + l)).
  change (round radix2 fexp (Znearest even_choice)) with rnd. rewrite E, ulp_neq_0 by exact N.
  replace (h - (h + l)) with (- l) by ring. rewrite Rabs_Ropp. auto.
Qed.
Lemma rounded_doubled : forall a b l, fmt l -> l = a + b - rnd (a + b) -> doubled (rnd (a + b)) l.
Proof. intros a b l F ->. split; [apply fmt_rnd | exact F|]. f_equal. ring. Qed.
Lemma doubled_opp : forall h l, doubled h l -> doubled (- h) (- l).
Proof.
  intros h l [Fh Fl E]. split; auto using fmt_opp. rewrite <- E at 2. rewrite <- rnd_opp. f_equal. ring.
Qed.

(* Numbers cancel, so that their sum is a double (Sterbenz), or it is large. *)
Lemma cancel_or_large : forall a b, fmt a -> fmt b ->
  fmt (a + b) /\ Rabs a <= 2 * Rabs b /\ Rabs b <= 2 * Rabs a \/
  Rabs a <= 2 * Rabs (a + b) /\ Rabs b <= 2 * Rabs (a + b).
Proof.
  assert (S : forall a b, fmt a -> fmt b -> 0 <= a -> b <= 0 ->
    fmt (a + b) /\ Rabs a <= 2 * Rabs b /\ Rabs b <= 2 * Rabs a \/
    Rabs a <= 2 * Rabs (a + b) /\ Rabs b <= 2 * Rabs (a + b)).
  { intros a b Fa Fb Ha Hb. rewrite (Rabs_pos_eq a), (Rabs_left1 b) by assumption.
    generalize (Rle_abs (a + b)) (Rle_abs (- (a + b))). rewrite Rabs_Ropp. intros.
    destruct (Rle_lt_dec (2 * a) (- b)); [right; lra|]. destruct (Rle_lt_dec (2 * - b) a); [right; lra|]. left.
    split; [|lra]. replace (a + b) with (a - - b) by ring.
    apply sterbenz; [apply FLT_exp_valid; reflexivity | apply FLT_exp_monotone | exact Fa | apply fmt_opp, Fb |].
    split; lra. }
  intros a b Fa Fb. destruct (Rle_lt_dec 0 a) as [Ha|Ha], (Rle_lt_dec 0 b) as [Hb|Hb].
  - right. rewrite !Rabs_pos_eq by lra. lra.
  - apply S; auto; lra.
  - rewrite (Rplus_comm a b). destruct (S b a Fb Fa ltac:(lra) ltac:(lra)) as [[F H]|H]; [left | right]; tauto.
  - right. rewrite !Rabs_left1 by lra. lra.
Qed.

(* ---- Sum ---- *)

Definition plus_c xh xl yh yl := rnd (sum_low xh yh + rnd (xl + yl)).
Definition plus_v xh xl yh yl := rnd (rnd (xh + yh) + plus_c xh xl yh yl).
Definition plus_w xh xl yh yl := rnd (sum_low xl yl + ordered_low (rnd (xh + yh)) (plus_c xh xl yh yl)).
Definition plus_high xh xl yh yl := rnd (plus_v xh xl yh yl + plus_w xh xl yh yl).
Definition plus_low xh xl yh yl := ordered_low (plus_v xh xl yh yl) (plus_w xh xl yh yl).

(* What is proved of the last three operations. v + w is the result. *)
Definition plus_right xh xl yh yl v w :=
  ordered_low v w = v + w - rnd (v + w) /\
  Rabs (v + w - (xh + xl + (yh + yl))) <= 7 * (u * u) * Rabs (xh + xl + (yh + yl)).

Lemma plus_large : forall xh xl yh yl sh th c, doubled xh xl -> doubled yh yl ->
  Rabs xh <= 2 * Rabs (xh + yh) -> Rabs yh <= 2 * Rabs (xh + yh) ->
  sh = rnd (xh + yh) -> th = rnd (xl + yl) -> c = rnd (xh + yh - sh + th) ->
  plus_right xh xl yh yl (rnd (sh + c)) (rnd (xl + yl - th + ordered_low sh c)).
Proof.
  intros xh xl yh yl sh th c Dx Dy Hx Hy Esh Eth Ec.
  generalize (low_size _ _ Dx) (low_size _ _ Dy) (Rabs_pos (xh + yh)). intros Lx Ly S0.
  destruct Dx as [Fxh Fxl _], Dy as [Fyh Fyl _].
  assert (Fsh : fmt sh) by (subst; apply fmt_rnd). assert (Fth : fmt th) by (subst; apply fmt_rnd).
  assert (Fc : fmt c) by (subst c; apply fmt_rnd).
  assert (Fsl : fmt (xh + yh - sh)) by (subst; apply fmt_rounding_error; auto).
  assert (Ftl : fmt (xl + yl - th)) by (subst; apply fmt_rounding_error; auto).
  set (S := Rabs (xh + yh)) in *.
  assert (Bxl : Rabs xl <= 2 * u * S) by (rewrite u_val in *; lra).
  assert (Byl : Rabs yl <= 2 * u * S) by (rewrite u_val in *; lra).
  assert (Esl : Rabs (sh - (xh + yh)) <= u * S) by (subst sh; apply rnd_plus; auto).
  assert (Etl : Rabs (th - (xl + yl)) <= u * (4 * u * S)) by (subst th; apply rnd_plus_within; auto; bound).
  assert (E1 : Rabs (c - (xh + yh - sh + th)) <= u * (51 / 10 * u * S))
    by (subst c; apply rnd_plus_within; auto; bound).
  assert (Bc : Rabs c <= 6 * u * S) by bound.
  assert (Oc : Rabs c <= Rabs sh).
  { destruct (size_of_near _ _ _ Esl) as [N _]. fold S in N. rewrite u_val in *. lra. }
  rewrite (ordered_exact _ _ Fsh Fc Oc).
  set (v := rnd (sh + c)). assert (Fv : fmt v) by apply fmt_rnd.
  assert (Fvl : fmt (sh + c - v)) by (apply fmt_rounding_error; auto).
  assert (Bv : Rabs (sh + c) <= 11 / 10 * S).
  { destruct (size_of_near _ _ _ Esl) as [_ N]. fold S in N. generalize (Rabs_triang sh c). rewrite u_val in *. lra. }
  assert (Ev : Rabs (v - (sh + c)) <= u * (11 / 10 * S)) by (apply rnd_plus_within; auto).
  set (w := rnd (xl + yl - th + (sh + c - v))).
  assert (Ew : Rabs (w - (xl + yl - th + (sh + c - v))) <= u * (12 / 10 * u * S))
    by (apply rnd_plus_within; auto; bound).
  assert (Bw : Rabs w <= 2 * u * S) by bound.
  assert (Near : Rabs (v - (xh + yh)) <= 10 * u * S) by bound.
  assert (Near2 : Rabs (xh + xl + (yh + yl) - (xh + yh)) <= 4 * u * S) by bound.
  assert (Error : Rabs (v + w - (xh + xl + (yh + yl))) <= 64 / 10 * (u * u) * S).
  { clear Near Near2 Bw Bv Bc Oc. replace (v + w - (xh + xl + (yh + yl))) with
      ((c - (xh + yh - sh + th)) + (w - (xl + yl - th + (sh + c - v)))) by ring.
    eapply Rle_trans; [apply Rabs_triang|]. rewrite u_val in *. lra. }
  destruct (size_of_near _ _ _ Near) as [N _]. destruct (size_of_near _ _ _ Near2) as [N2 _]. fold S in N, N2.
  split; [apply ordered_exact; auto; [apply fmt_rnd|]|]; fold w; rewrite u_val in *; lra.
Qed.

(* Where the high parts cancel, their sum is a multiple of the last place of the low parts' sum. *)
Lemma last_place : forall xh xl yh yl, doubled xh xl -> doubled yh yl -> Rabs yh <= Rabs xh -> Rabs xh <= 2 * Rabs yh ->
  rnd (xl + yl) <> 0 -> multiple (cexp radix2 fexp (rnd (xl + yl))) (xh + yh).
Proof.
  intros xh xl yh yl Dx Dy Le Lt N. destruct (Req_dec yh 0) as [Zy|Ny].
  { exists 0%Z. rewrite Zy, Rabs_R0, Rmult_0_r in Lt. generalize (Rabs_pos xh). intro P.
    rewrite Zy, (Rabs_eq_R0 xh) by lra. ring. }
  assert (Nx : xh <> 0).
  { intros ->. rewrite Rabs_R0 in Le. generalize (Rabs_pos_lt yh Ny). lra. }
  generalize (low_unit _ _ Dx Nx) (low_unit _ _ Dy Ny). intros Ux Uy.
  destruct Dx as [Fxh Fxl _], Dy as [Fyh Fyl _]. set (e := cexp radix2 fexp yh) in *.
  assert (E : (-1074 <= e)%Z) by (unfold e, cexp, FLT_exp; lia).
  assert (Ey : (e <= cexp radix2 fexp xh <= e + 1)%Z).
  { generalize (mag_le_abs radix2 yh xh Ny Le). intro M1.
    assert (M2 : (mag radix2 xh <= mag radix2 yh + 1)%Z).
    { apply mag_le_bpow; [exact Nx|]. rewrite bpow_plus. change (bpow radix2 1) with 2.
      generalize (bpow_mag_gt radix2 yh). lra. }
    unfold e, cexp, FLT_exp. lia. }
  assert (Bx : bpow radix2 (cexp radix2 fexp xh) <= 2 * bpow radix2 e).
  { rewrite Rmult_comm. change 2 with (bpow radix2 1). rewrite <- bpow_plus. apply bpow_le. lia. }
  generalize (bpow_gt_0 radix2 e). intro P.
  assert (B : Rabs (xl + yl) <= 3 / 2 * bpow radix2 e).
  { eapply Rle_trans; [apply Rabs_triang|]. lra. }
  assert (T : Rabs (rnd (xl + yl)) < bpow radix2 (e + 1)).
  { generalize (rnd_plus_within _ _ _ Fxl Fyl B). intro R. destruct (size_of_near _ _ _ R) as [_ S].
    rewrite bpow_plus. change (bpow radix2 1) with 2. rewrite u_val in *. lra. }
  assert (C : (cexp radix2 fexp (rnd (xl + yl)) <= e)%Z).
  { generalize (mag_le_bpow radix2 _ _ N T). unfold cexp at 1, FLT_exp. lia. }
  apply (multiple_finer _ e); [exact C|].
  apply multiple_plus; [apply multiple_finer with (1 := proj1 Ey)|]; apply multiple_fmt; auto.
Qed.

Lemma plus_cancelled : forall xh xl yh yl sh th c, doubled xh xl -> doubled yh yl ->
  fmt (xh + yh) -> Rabs yh <= Rabs xh -> Rabs xh <= 2 * Rabs yh ->
  sh = rnd (xh + yh) -> th = rnd (xl + yl) -> c = rnd (xh + yh - sh + th) ->
  plus_right xh xl yh yl (rnd (sh + c)) (rnd (xl + yl - th + ordered_low sh c)).
Proof.
  intros xh xl yh yl sh th c Dx Dy F Le Lt Esh Eth Ec.
  assert (M : th <> 0 -> multiple (cexp radix2 fexp th) sh).
  { rewrite Esh, Eth, (rnd_fmt _ F). apply last_place; auto. }
  destruct Dx as [Fxh Fxl _], Dy as [Fyh Fyl _]. rewrite (rnd_fmt _ F) in Esh.
  assert (Fth : fmt th) by (subst th; apply fmt_rnd). assert (Fsh : fmt sh) by (subst sh; exact F).
  assert (Ftl : fmt (xl + yl - th)) by (subst th; apply fmt_rounding_error; auto).
  assert (Dt : doubled th (xl + yl - th))
    by (rewrite Eth at 1; apply rounded_doubled; [exact Ftl | subst; reflexivity]).
  assert (Bt : Rabs (xl + yl - th) <= u * Rabs th) by (apply low_size; exact Dt).
  assert (C : c = th).
  { rewrite Ec. rewrite Esh. replace (xh + yh - (xh + yh) + th) with th by ring. apply rnd_fmt, Fth. }
  rewrite C. assert (O : ordered_low sh th = sh + th - rnd (sh + th)).
  { destruct (Req_dec th 0) as [Z|N]; [|apply ordered_multiple; auto].
    apply ordered_exact; auto. rewrite Z, Rabs_R0. apply Rabs_pos. }
  rewrite O. set (tl := xl + yl - th) in *. unfold plus_right.
  replace (xh + xl + (yh + yl)) with (sh + th + tl) by (unfold tl; rewrite Esh; ring).
  destruct (cancel_or_large sh th Fsh Fth) as [[Fv _]|[_ L]].
  - rewrite (rnd_fmt _ Fv). replace (tl + (sh + th - (sh + th))) with tl by ring. rewrite (rnd_fmt _ Ftl). split.
    + destruct (Req_dec (sh + th) 0) as [Z|N].
      { apply ordered_where_exact; auto. rewrite Z, Rplus_0_l. exact Ftl. }
      apply ordered_exact; auto. destruct (Req_dec th 0) as [Zt|Nt].
      { rewrite Zt, Rabs_R0, Rmult_0_r in Bt. eapply Rle_trans; [exact Bt | apply Rabs_pos]. }
      generalize (low_unit _ _ Dt Nt) (bpow_gt_0 radix2 (cexp radix2 fexp th)). intros.
      apply Rle_trans with (bpow radix2 (cexp radix2 fexp th)); [lra|].
      apply multiple_size; [|exact N]. apply multiple_plus; [apply M, Nt | apply multiple_fmt, Fth].
    + replace (sh + th + tl - (sh + th + tl)) with 0 by ring. rewrite Rabs_R0.
      generalize (Rabs_pos (sh + th + tl)). rewrite u_val. lra.
  - set (V := Rabs (sh + th)) in *. set (v := rnd (sh + th)). assert (Fv : fmt v) by apply fmt_rnd.
    assert (V0 : 0 <= V) by apply Rabs_pos.
    assert (Fvl : fmt (sh + th - v)) by (apply fmt_rounding_error; auto).
    assert (Ev : Rabs (v - (sh + th)) <= u * V) by (apply rnd_plus; auto).
    assert (Bl : Rabs tl <= 2 * u * V) by (rewrite u_val in *; lra).
    set (w := rnd (tl + (sh + th - v))).
    assert (Ew : Rabs (w - (tl + (sh + th - v))) <= u * (3 * u * V)) by (apply rnd_plus_within; auto; bound).
    assert (Bw : Rabs w <= 4 * u * V) by bound.
    assert (Near : Rabs (sh + th + tl - (sh + th)) <= 2 * u * V).
    { replace (sh + th + tl - (sh + th)) with tl by ring. exact Bl. }
    destruct (size_of_near _ _ _ Ev) as [N _]. destruct (size_of_near _ _ _ Near) as [N2 _]. fold V in N, N2.
    replace (v + w - (sh + th + tl)) with (w - (tl + (sh + th - v))) by ring.
    split; [apply ordered_exact; auto; [apply fmt_rnd|]|]; fold w; rewrite u_val in *; lra.
Qed.

Lemma plus_right_swapped : forall xh xl yh yl v w, plus_right yh yl xh xl v w -> plus_right xh xl yh yl v w.
Proof. intros xh xl yh yl v w. unfold plus_right. rewrite (Rplus_comm (xh + xl)). auto. Qed.

Theorem plus_doubled : forall xh xl yh yl, doubled xh xl -> doubled yh yl ->
  let zh := plus_high xh xl yh yl in let zl := plus_low xh xl yh yl in
  doubled zh zl /\ Rabs (zh + zl - (xh + xl + (yh + yl))) <= 7 * (u * u) * Rabs (xh + xl + (yh + yl)).
Proof.
  intros xh xl yh yl Dx Dy zh zl.
  assert (R : plus_right xh xl yh yl (plus_v xh xl yh yl) (plus_w xh xl yh yl)).
  { unfold plus_v, plus_w, plus_c. destruct (Dx) as [Fxh Fxl _], (Dy) as [Fyh Fyl _].
    rewrite (sum_exact xh yh), (sum_exact xl yl) by auto.
    destruct (cancel_or_large xh yh Fxh Fyh) as [[F [X Y]]|[X Y]]; [|apply plus_large; auto].
    destruct (Rle_lt_dec (Rabs yh) (Rabs xh)) as [L|G]; [apply plus_cancelled; auto|].
    apply plus_right_swapped. rewrite (Rplus_comm xh yh), (Rplus_comm xl yl).
    apply plus_cancelled; auto; [rewrite Rplus_comm; exact F | apply Rlt_le, G]. }
  destruct R as [O E]. unfold zh, zl, plus_high, plus_low. split.
  - apply rounded_doubled; [apply fmt_rnd | exact O].
  - rewrite O. replace (rnd (plus_v xh xl yh yl + plus_w xh xl yh yl) + (plus_v xh xl yh yl + plus_w xh xl yh yl -
      rnd (plus_v xh xl yh yl + plus_w xh xl yh yl))) with (plus_v xh xl yh yl + plus_w xh xl yh yl) by ring. exact E.
Qed.

(* ---- Product ---- *)

Definition times_d xh xl yh yl := rnd (product_low xh yh + rnd (rnd (xh * yl) + rnd (xl * yh))).
Definition times_high xh xl yh yl := rnd (rnd (xh * yh) + times_d xh xl yh yl).
Definition times_low xh xl yh yl := ordered_low (rnd (xh * yh)) (times_d xh xl yh yl).

Lemma eta_value : u * tau = / 2 * eta.
Proof.
  unfold u, tau, eta. rewrite <- bpow_plus. change (/ 2) with (bpow radix2 (-1)). rewrite <- bpow_plus. f_equal.
Qed.
Lemma eta_pos : 0 < eta. Proof. apply bpow_gt_0. Qed.
Lemma rnd_product : forall x B, Rabs x <= B -> Rabs (rnd x - x) <= u * B + / 2 * eta.
Proof.
  intros x B H. eapply Rle_trans; [apply rnd_any|]. rewrite eta_value. generalize u_pos. intro.
  apply Rplus_le_compat_r, Rmult_le_compat_l; lra.
Qed.
(* An ordered sum is exact where the second number is larger, if both are a few of the smallest doubles. *)
Lemma ordered_near : forall a b, fmt a -> fmt b -> Rabs b <= Rabs a \/ Rabs (a + b) <= 64 * eta ->
  ordered_low a b = a + b - rnd (a + b).
Proof.
  intros a b Ha Hb [H|H]; [apply ordered_exact; auto|]. apply ordered_where_exact; auto.
  apply FLT_format_plus_small; auto; [reflexivity|]. eapply Rle_trans; [exact H|].
  unfold eta. change 64 with (bpow radix2 6). rewrite <- bpow_plus. apply bpow_le. lia.
Qed.

Theorem times_doubled : forall xh xl yh yl, doubled xh xl -> doubled yh yl ->
  let zh := times_high xh xl yh yl in let zl := times_low xh xl yh yl in
  doubled zh zl /\
  Rabs (zh + zl - (xh + xl) * (yh + yl)) <=
    17 / 2 * (u * u) * Rabs ((xh + xl) * (yh + yl)) + 5 * eta.
Proof.
  intros xh xl yh yl Dx Dy zh zl.
  generalize (low_size _ _ Dx) (low_size _ _ Dy). intros Lx Ly.
  destruct Dx as [Fxh Fxl _], Dy as [Fyh Fyl _].
  unfold zh, zl, times_high, times_low, times_d.
  set (P := Rabs (xh * yh)). assert (P0 : 0 <= P) by apply Rabs_pos. generalize eta_pos. intro Eta.
  assert (B1 : Rabs (xh * yl) <= u * P).
  { unfold P. rewrite !Rabs_mult. generalize (Rmult_le_compat_l _ _ _ (Rabs_pos xh) Ly). lra. }
  assert (B2 : Rabs (xl * yh) <= u * P).
  { unfold P. rewrite !Rabs_mult. generalize (Rmult_le_compat_r _ _ _ (Rabs_pos yh) Lx). lra. }
  assert (B3 : Rabs (xl * yl) <= u * u * P).
  { unfold P. rewrite !Rabs_mult. generalize (Rmult_le_compat _ _ _ _ (Rabs_pos xl) (Rabs_pos yl) Lx Ly). lra. }
  destruct (product_near xh yh Fxh Fyh) as [_ Ep]. set (ph := rnd (xh * yh)) in *. set (pl := product_low xh yh) in *.
  assert (Fph : fmt ph) by apply fmt_rnd. assert (Fpl : fmt pl) by apply fmt_rnd.
  assert (Eh : Rabs (ph - xh * yh) <= u * P + / 2 * eta) by (apply rnd_product; apply Rle_refl).
  generalize (rnd_product _ _ B1) (rnd_product _ _ B2).
  set (a := rnd (xh * yl)). set (b := rnd (xl * yh)). intros Ea Eb.
  assert (Fa : fmt a) by apply fmt_rnd. assert (Fb : fmt b) by apply fmt_rnd.
  set (c := rnd (a + b)). assert (Fc : fmt c) by apply fmt_rnd.
  assert (Ec : Rabs (c - (a + b)) <= u * (21 / 10 * u * P + 11 / 10 * eta)) by (apply rnd_plus_within; auto; bound).
  set (d := rnd (pl + c)). assert (Fd : fmt d) by apply fmt_rnd.
  assert (Ed : Rabs (d - (pl + c)) <= u * (32 / 10 * u * P + 6 * eta)) by (apply rnd_plus_within; auto; bound).
  assert (Bd : Rabs d <= 4 * u * P + 7 * eta) by bound.
  assert (Error : Rabs (ph + d - (xh + xl) * (yh + yl)) <= 84 / 10 * (u * u) * P + 49 / 10 * eta).
  { replace (ph + d - (xh + xl) * (yh + yl)) with ((d - (pl + c)) + (c - (a + b)) + (a - xh * yl) + (b - xl * yh) -
      (xh * yh - (ph + pl)) - xl * yl) by ring. bound. }
  assert (Size : Rabs ((xh + xl) * (yh + yl) - xh * yh) <= 3 * u * P).
  { replace ((xh + xl) * (yh + yl) - xh * yh) with (xh * yl + xl * yh + xl * yl) by ring. bound. }
  destruct (size_of_near _ _ _ Size) as [N _]. destruct (size_of_near _ _ _ Eh) as [H1 H2]. fold P in N, H1, H2.
  assert (O : ordered_low ph d = ph + d - rnd (ph + d)).
  { apply ordered_near; auto. destruct (Rle_lt_dec (Rabs d) (Rabs ph)) as [L|G]; [left; exact L|]. right.
    generalize (Rabs_triang ph d). rewrite u_val in *. lra. }
  split; [apply rounded_doubled; [apply fmt_rnd | exact O]|]. rewrite O.
  replace (rnd (ph + d) + (ph + d - rnd (ph + d))) with (ph + d) by ring. rewrite u_val in *. lra.
Qed.

Lemma low_zero : forall h l, doubled h l -> h + l = 0 -> h = 0 /\ l = 0.
Proof. intros h l [_ _ E] Z. rewrite Z, rnd_0 in E. subst h. lra. Qed.
Lemma zero_low : forall l, doubled 0 l -> l = 0.
Proof.
  intros l D. generalize (low_size _ _ D) (Rabs_pos l). rewrite Rabs_R0, Rmult_0_r. intros. apply Rabs_eq_R0. lra.
Qed.
Lemma ordered_zero : ordered_low 0 0 = 0.
Proof. unfold ordered_low. rewrite Rplus_0_r, !rnd_0, !Rminus_0_r, !rnd_0, Rminus_0_r. apply rnd_0. Qed.
Lemma times_zero : forall xh xl yh yl, doubled xh xl -> doubled yh yl -> (xh + xl) * (yh + yl) = 0 ->
  times_high xh xl yh yl = 0 /\ times_low xh xl yh yl = 0.
Proof.
  intros xh xl yh yl Dx Dy Z.
  assert (P : xh * yh = 0 /\ xh * yl = 0 /\ xl * yh = 0).
  { apply Rmult_integral in Z.
    destruct Z as [Z|Z]; [destruct (low_zero _ _ Dx Z) as [-> ->] | destruct (low_zero _ _ Dy Z) as [-> ->]];
      rewrite ?Rmult_0_l, ?Rmult_0_r; auto. }
  destruct P as [P1 [P2 P3]], Dx as [Fxh _ _], Dy as [Fyh _ _].
  destruct (product_near xh yh Fxh Fyh) as [E _].
  unfold times_high, times_low, times_d. rewrite E by (left; exact P1).
  rewrite P1, P2, P3, rnd_0, Rplus_0_r, rnd_0. replace (0 - 0 + 0) with 0 by ring.
  rewrite rnd_0, Rplus_0_r, rnd_0. split; [reflexivity | apply ordered_zero].
Qed.

(* ---- Order ---- *)

Lemma doubled_less : forall xh xl yh yl, doubled xh xl -> doubled yh yl ->
  (xh + xl < yh + yl <-> xh < yh \/ xh = yh /\ xl < yl).
Proof.
  intros xh xl yh yl [_ _ Ex] [_ _ Ey].
  assert (M : forall a b, a <= b -> rnd a <= rnd b) by (intros; apply round_le; auto with typeclass_instances).
  split.
  - intro L. generalize (M _ _ (Rlt_le _ _ L)). rewrite Ex, Ey. intro H.
    destruct (Rle_lt_or_eq_dec _ _ H); [left | right]; lra.
  - intros [L|[E L]]; [|lra]. apply Rnot_le_lt. intro H. generalize (M _ _ H). rewrite Ex, Ey. lra.
Qed.
