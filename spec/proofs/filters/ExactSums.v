(* Sums and products of two doubles without error, on rounded real numbers: what is rounded away is a double, and the
   known sequences of operations compute it (Knuth's, Dekker's for an ordered pair, and Dekker's product with the
   splitting of Veltkamp). The theorems on them are those of Flocq's translation of Pff.
   An ordered pair is |b| <= |a| there. A double-double also needs pairs in which a is smaller than b, but a multiple of
   b's last place. *)
From Coq Require Import Reals ZArith Lra Lia Bool.
From Flocq Require Import Core Plus_error Relative Sterbenz Pff.Pff2Flocq.
From Flowcert Require Import filters.Rounding.
Open Scope R_scope.

Definition even_choice := fun t => negb (Z.even t).
Lemma even_choice_symmetric : forall x, even_choice x = negb (even_choice (- (x + 1))).
Proof. intro x. unfold even_choice. rewrite Z.even_opp, Z.even_add. destruct (Z.even x); reflexivity. Qed.

(* ---- Roundings ---- *)

Lemma rnd_fmt : forall x, fmt x -> rnd x = x.
Proof. intros. apply round_generic; auto with typeclass_instances. Qed.
Lemma rnd_opp : forall x, rnd (- x) = - rnd x.
Proof. intros. apply round_NE_opp. Qed.
Lemma rnd_0 : rnd 0 = 0.
Proof. apply round_0; auto with typeclass_instances. Qed.
Lemma rnd_minus : forall x y, fmt x -> fmt y -> Rabs (rnd (x - y) - (x - y)) <= u * Rabs (x - y).
Proof. intros x y Hx Hy. apply (rnd_plus x (- y)); auto. apply fmt_opp; auto. Qed.
(* The error in units of the result. *)
Lemma rnd_plus_result : forall x y, fmt x -> fmt y -> Rabs (rnd (x + y) - (x + y)) <= u * Rabs (rnd (x + y)).
Proof.
  intros x y Hx Hy.
  destruct (FLT_plus_error_N_round_ex radix2 (-1074) 53 even_choice x y Hx Hy) as [d [Hd H]].
  change (round radix2 fexp (Znearest even_choice) (x + y)) with (rnd (x + y)) in H. rewrite u_ro_u in Hd.
  rewrite H at 2. replace (rnd (x + y) - rnd (x + y) * (1 + d)) with (- d * rnd (x + y)) by ring.
  rewrite Rabs_mult, Rabs_Ropp. apply Rmult_le_compat_r; [apply Rabs_pos | exact Hd].
Qed.
Lemma rnd_normal : forall x, tau <= Rabs x -> Rabs (rnd x - x) <= u * Rabs x.
Proof.
  intros x H. apply (relative_error_N_FLT radix2 (-1074) 53) with (choice := even_choice) in H; [|reflexivity].
  eapply Rle_trans; [exact H|]. right. rewrite <- u_ro_u. reflexivity.
Qed.
Lemma fmt_rounding_error : forall x y, fmt x -> fmt y -> fmt (x + y - rnd (x + y)).
Proof.
  intros x y Hx Hy. replace (x + y - rnd (x + y)) with (- (rnd (x + y) - (x + y))) by ring. apply fmt_opp.
  apply plus_error; auto with typeclass_instances.
Qed.

(* ---- Multiples of a power of two ---- *)

Definition multiple e x := exists n, x = IZR n * bpow radix2 e.

Lemma multiple_plus : forall e x y, multiple e x -> multiple e y -> multiple e (x + y).
Proof. intros e x y [m ->] [n ->]. exists (m + n)%Z. rewrite plus_IZR. ring. Qed.
Lemma multiple_minus : forall e x y, multiple e x -> multiple e y -> multiple e (x - y).
Proof. intros e x y [m ->] [n ->]. exists (m - n)%Z. rewrite minus_IZR. ring. Qed.
Lemma multiple_finer : forall d e x, (d <= e)%Z -> multiple e x -> multiple d x.
Proof.
  intros d e x H [n ->]. exists (n * 2 ^ (e - d))%Z. rewrite mult_IZR, Rmult_assoc. f_equal.
  rewrite (IZR_Zpower radix2) by lia. rewrite <- bpow_plus. f_equal. lia.
Qed.
Lemma multiple_fmt : forall x, fmt x -> multiple (cexp radix2 fexp x) x.
Proof. intros x H. exists (Ztrunc (scaled_mantissa radix2 fexp x)). exact H. Qed.
Lemma multiple_size : forall e x, multiple e x -> x <> 0 -> bpow radix2 e <= Rabs x.
Proof.
  intros e x [n ->] H. rewrite Rabs_mult, (Rabs_pos_eq (bpow radix2 e)) by apply bpow_ge_0.
  rewrite <- (Rmult_1_l (bpow radix2 e)) at 1. apply Rmult_le_compat_r; [apply bpow_ge_0|].
  rewrite <- abs_IZR. apply IZR_le. assert (n <> 0)%Z by (intros ->; apply H; ring). lia.
Qed.
(* A multiple below a greater power of two is below it by the unit. *)
Lemma multiple_below : forall e k x, (e <= k)%Z -> multiple e x -> Rabs x < bpow radix2 k ->
  Rabs x <= bpow radix2 k - bpow radix2 e.
Proof.
  intros e k x H [n ->]. rewrite Rabs_mult, (Rabs_pos_eq (bpow radix2 e)) by apply bpow_ge_0. rewrite <- abs_IZR.
  replace (bpow radix2 k) with (IZR (2 ^ (k - e)) * bpow radix2 e).
  2: { rewrite (IZR_Zpower radix2) by lia. rewrite <- bpow_plus. f_equal. lia. }
  intro L. apply Rmult_lt_reg_r in L; [|apply bpow_gt_0]. apply lt_IZR in L.
  replace (IZR (2 ^ (k - e)) * bpow radix2 e - bpow radix2 e) with (IZR (2 ^ (k - e) - 1) * bpow radix2 e)
    by (rewrite minus_IZR; ring).
  apply Rmult_le_compat_r; [apply bpow_ge_0|]. apply IZR_le. lia.
Qed.
Lemma fmt_multiple : forall e x, (-1074 <= e)%Z -> multiple e x -> Rabs x <= bpow radix2 (e + 53) -> fmt x.
Proof.
  intros e x He H B. destruct (Rle_lt_or_eq_dec _ _ B) as [L|E].
  - destruct H as [n ->]. apply generic_format_FLT. exists (Float radix2 n e); simpl; [reflexivity | | exact He].
    rewrite Rabs_mult, (Rabs_pos_eq (bpow radix2 e)), Z.add_comm, bpow_plus in L by apply bpow_ge_0.
    apply Rmult_lt_reg_r in L; [|apply bpow_gt_0]. rewrite <- abs_IZR in L.
    change (bpow radix2 53) with (IZR (2 ^ 53)) in L. apply lt_IZR in L. exact L.
  - assert (P : fmt (bpow radix2 (e + 53))) by (apply generic_format_FLT_bpow; [reflexivity | lia]).
    unfold Rabs in E. destruct (Rcase_abs x); [|rewrite E; exact P].
    rewrite <- (Ropp_involutive x). apply fmt_opp. rewrite E. exact P.
Qed.
Lemma multiple_rnd : forall e x, (-1074 <= e)%Z -> multiple e x -> multiple e (rnd x).
Proof.
  intros e x He H. destruct (Z.le_gt_cases e (cexp radix2 fexp x)) as [L|G].
  - apply multiple_finer with (1 := L). eexists. unfold rnd, round, F2R. cbn [Fnum Fexp]. reflexivity.
  - rewrite rnd_fmt; [exact H|]. destruct (Req_dec x 0) as [->|N]; [apply generic_format_0|].
    apply (fmt_multiple e); auto. apply Rlt_le. eapply Rlt_le_trans; [apply (bpow_mag_gt radix2)|]. apply bpow_le.
    unfold cexp, FLT_exp in G. lia.
Qed.

(* ---- Sums ---- *)

Definition sum_low a b := let s := rnd (a + b) in let t := rnd (s - a) in rnd (rnd (a - rnd (s - t)) + rnd (b - t)).
Definition ordered_low a b := rnd (b - rnd (rnd (a + b) - a)).

Lemma sum_exact : forall a b, fmt a -> fmt b -> sum_low a b = a + b - rnd (a + b).
Proof.
  intros a b Ha Hb.
  generalize (TwoSum_correct (-1074) 53 even_choice eq_refl ltac:(lia) even_choice_symmetric a b Ha Hb).
  unfold sum_low, rnd. cbv zeta. intro H. change (Znearest even_choice) with ZnearestE in H. lra.
Qed.

(* What has to be shown of an ordered sum: the first difference is a double. *)
Lemma ordered_if : forall a b, fmt a -> fmt b -> fmt (rnd (a + b) - a) -> ordered_low a b = a + b - rnd (a + b).
Proof.
  intros a b Ha Hb H. unfold ordered_low. rewrite (rnd_fmt _ H).
  replace (b - (rnd (a + b) - a)) with (a + b - rnd (a + b)) by ring. apply rnd_fmt. apply fmt_rounding_error; auto.
Qed.
Lemma ordered_where_exact : forall a b, fmt a -> fmt b -> fmt (a + b) -> ordered_low a b = a + b - rnd (a + b).
Proof.
  intros a b Ha Hb H. apply ordered_if; auto. rewrite (rnd_fmt _ H). replace (a + b - a) with b by ring. exact Hb.
Qed.
Lemma ordered_exact : forall a b, fmt a -> fmt b -> Rabs b <= Rabs a -> ordered_low a b = a + b - rnd (a + b).
Proof.
  intros a b Ha Hb H.
  generalize (Fast2Sum_correct (-1074) 53 even_choice eq_refl ltac:(lia) even_choice_symmetric a b Ha Hb H).
  change (round radix2 (FLT_exp (-1074) 53) (Znearest even_choice)) with rnd. intro E.
  unfold ordered_low. replace (rnd (a + b) - a) with (- (a - rnd (a + b))) by ring. rewrite rnd_opp.
  unfold Rminus at 1. rewrite Ropp_involutive. lra.
Qed.
Lemma ordered_multiple : forall a b, fmt a -> fmt b -> multiple (cexp radix2 fexp b) a ->
  ordered_low a b = a + b - rnd (a + b).
Proof.
  intros a b Ha Hb M. destruct (Rle_lt_dec (Rabs b) (Rabs a)) as [L|G]; [apply ordered_exact; auto|].
  apply ordered_if; auto. set (e := cexp radix2 fexp b) in *.
  assert (E : (-1074 <= e)%Z) by (unfold e, cexp, FLT_exp; lia).
  assert (Mb : multiple e b) by (apply multiple_fmt; exact Hb).
  apply (fmt_multiple e); [exact E | apply multiple_minus; [apply multiple_rnd, multiple_plus|]; auto|].
  assert (B : Rabs b < bpow radix2 (e + 53)).
  { eapply Rlt_le_trans; [apply (bpow_mag_gt radix2)|]. apply bpow_le. unfold e, cexp, FLT_exp. lia. }
  assert (C : Rabs b <= bpow radix2 (e + 53) - bpow radix2 e) by (apply multiple_below; auto; lia).
  assert (D : Rabs (rnd (a + b) - (a + b)) <= bpow radix2 e).
  { destruct (Req_dec (a + b) 0) as [Z|N].
    - rewrite Z, rnd_0. unfold Rminus. rewrite Ropp_0, Rplus_0_r, Rabs_R0. apply bpow_ge_0.
    - eapply Rle_trans; [apply (error_le_half_ulp radix2 fexp even_choice)|]. rewrite ulp_neq_0 by exact N.
      apply Rle_trans with (/ 2 * bpow radix2 (e + 1)).
      + apply Rmult_le_compat_l; [lra|]. apply bpow_le.
        assert (mag radix2 (a + b) <= e + 54)%Z; [|unfold cexp, FLT_exp; lia].
        apply mag_le_bpow; [exact N|]. replace (e + 54)%Z with (1 + (e + 53))%Z by ring. rewrite bpow_plus.
        change (bpow radix2 1) with 2. generalize (Rabs_triang a b). lra.
      + rewrite bpow_plus. change (bpow radix2 1) with 2. lra. }
  replace (rnd (a + b) - a) with ((rnd (a + b) - (a + b)) + b) by ring.
  eapply Rle_trans; [apply Rabs_triang|]. lra.
Qed.

(* ---- Products ---- *)

Definition split_high a := let c := rnd (134217729 * a) in rnd (c - rnd (c - a)).
Definition split_low a := rnd (a - split_high a).
Definition product_low a b :=
  rnd (rnd (rnd (rnd (rnd (split_high a * split_high b) - rnd (a * b)) + rnd (split_high a * split_low b)) +
    rnd (split_low a * split_high b)) + rnd (split_low a * split_low b)).
Definition eta := bpow radix2 (-1074).
(* No product is smaller whose parts do not underflow. *)
Definition smallest_product := bpow radix2 (-969).

Lemma split_same : forall a, let p := rnd (a * (bpow radix2 27 + 1)) in rnd (rnd (a - p) + p) = split_high a.
Proof.
  intros a p. unfold split_high. cbv zeta. replace (rnd (134217729 * a)) with p.
  2: { unfold p. f_equal. change (bpow radix2 27) with 134217728. ring. }
  f_equal. replace (a - p) with (- (p - a)) by ring. rewrite rnd_opp. ring.
Qed.
Theorem product_near : forall a b, fmt a -> fmt b ->
  (a * b = 0 \/ smallest_product <= Rabs (a * b) -> product_low a b = a * b - rnd (a * b)) /\
  Rabs (a * b - (rnd (a * b) + product_low a b)) <= 7 / 2 * eta.
Proof.
  intros a b Ha Hb.
  generalize (Dekker radix2 (-1074) 53 even_choice ltac:(lia) ltac:(lia) a b Ha Hb (or_introl eq_refl)).
  change (round radix2 (FLT_exp (-1074) 53) (Znearest even_choice)) with rnd.
  change (53 - Z.div2 53)%Z with 27%Z. rewrite !split_same.
  change (-1074 + 2 * 53 - 1)%Z with (-969)%Z. fold (split_low a) (split_low b) smallest_product eta.
  rewrite (Rplus_comm (- rnd (a * b))). fold (rnd (split_high a * split_high b) - rnd (a * b)).
  fold (product_low a b). intros [E B]. split; [|exact B]. intro H. specialize (E H). lra.
Qed.
