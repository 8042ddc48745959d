(* Root and quotient of double-doubles (src/geometry/double_double.h) on rounded real numbers: the result is a
   double-double, and its relative error is at most 5 u^2 for a root, 15 u^2 for a quotient, with u = 2^-53, where
   operand and quotient are zero or at least 2^-960. *)
From Coq Require Import Reals ZArith Lra Lia.
From Flocq Require Import Core Sterbenz Div_sqrt_error.
From Flowcert Require Import filters.Rounding filters.ExactSums filters.DoubledSums filters.Terms.
Open Scope R_scope.

Definition smallest := bpow radix2 (-960).

Lemma smallest_pos : 0 < smallest. Proof. apply bpow_gt_0. Qed.
Lemma smallest_tau : tau <= / 2 * smallest.
Proof. unfold tau, smallest. change (/ 2) with (bpow radix2 (-1)). rewrite <- bpow_plus. apply bpow_le. lia. Qed.
Lemma smallest_eta : eta <= / 256 * (u * u) * smallest.
Proof.
  unfold eta, u, smallest. change (/ 256) with (bpow radix2 (-8)). rewrite <- !bpow_plus. apply bpow_le. lia.
Qed.
Lemma smallest_exact : smallest_product <= / 2 * smallest.
Proof.
  unfold smallest_product, smallest. change (/ 2) with (bpow radix2 (-1)). rewrite <- bpow_plus. apply bpow_le. lia.
Qed.

Lemma quotient_bound : forall a d s B, 0 < s -> s <= Rabs d -> Rabs a <= B * s -> Rabs (a / d) <= B.
Proof.
  intros a d s B S D H. assert (P : 0 < Rabs d) by lra.
  unfold Rdiv. rewrite Rabs_mult, Rabs_inv.
  apply Rmult_le_reg_r with (Rabs d); [exact P|]. rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra.
  eapply Rle_trans; [exact H|]. apply Rmult_le_compat_l; [|exact D].
  apply Rmult_le_reg_r with s; [exact S|]. generalize (Rabs_pos a). lra.
Qed.
Lemma product_bound : forall a b A B, Rabs a <= A -> Rabs b <= B -> Rabs (a * b) <= A * B.
Proof. intros. rewrite Rabs_mult. apply Rmult_le_compat; auto using Rabs_pos. Qed.

Lemma sterbenz_near : forall a b, fmt a -> fmt b -> Rabs (b - a) <= / 2 * Rabs a -> fmt (a - b).
Proof.
  intros a b Fa Fb H. destruct (Rle_lt_dec 0 a) as [Ha|Ha].
  - rewrite (Rabs_pos_eq a) in H by exact Ha. apply Rabs_le_inv in H.
    apply sterbenz; [apply FLT_exp_valid; reflexivity | apply FLT_exp_monotone | exact Fa | exact Fb | split; lra].
  - rewrite (Rabs_left a) in H by exact Ha. apply Rabs_le_inv in H. replace (a - b) with (- (- a - - b)) by ring.
    apply fmt_opp. apply sterbenz;
      [apply FLT_exp_valid; reflexivity | apply FLT_exp_monotone | apply fmt_opp, Fa | apply fmt_opp, Fb | split; lra].
Qed.

(* ---- Root ---- *)

Definition root_n xh xl r := rnd (rnd (rnd (xh - rnd (r * r)) - product_low r r) + xl).
Definition root_q xh xl := let r := rnd (sqrt xh) in rnd (root_n xh xl r / rnd (2 * r)).
Definition root_high xh xl := rnd (rnd (sqrt xh) + root_q xh xl).
Definition root_low xh xl := ordered_low (rnd (sqrt xh)) (root_q xh xl).

Lemma root_size : forall h, smallest <= h -> 0 < sqrt h /\ h = sqrt h * sqrt h /\ bpow radix2 (-480) <= sqrt h.
Proof.
  intros h H. generalize smallest_pos. intro P. assert (S : 0 < sqrt h) by (apply sqrt_lt_R0; lra).
  assert (E : h = sqrt h * sqrt h) by (symmetry; apply sqrt_sqrt; lra). split; [exact S|]. split; [exact E|].
  apply Rsqr_incr_0_var; [|lra]. unfold Rsqr. rewrite <- bpow_plus, <- E. exact H.
Qed.
Lemma rounded_root : forall h, smallest <= h -> Rabs (rnd (sqrt h) - sqrt h) <= u * sqrt h.
Proof.
  intros h H. destruct (root_size h H) as [S [_ B]]. rewrite <- (Rabs_pos_eq (sqrt h)) at 3 by lra.
  apply rnd_normal. rewrite Rabs_pos_eq by lra. apply Rle_trans with (2 := B). apply bpow_le. lia.
Qed.

(* The rest of a rounded root is a double. *)
Lemma root_residual : forall h, fmt h -> smallest <= h -> fmt (h - rnd (sqrt h) * rnd (sqrt h)).
Proof.
  intros h F H. destruct (root_size h H) as [S [_ B]]. generalize (rounded_root h H).
  set (s := sqrt h) in *. set (r := rnd s). intro Er.
  destruct (Rle_lt_dec (bpow radix2 (-1022)) (Rabs (h - r * r))) as [L|G].
  - apply generic_format_FLT_FLX; [exact L|]. unfold r, rnd.
    rewrite (round_FLT_FLX radix2 (-1074) 53)
      by (rewrite Rabs_pos_eq by lra; apply Rle_trans with (2 := B); apply bpow_le; lia).
    apply (sqrt_error_FLX_N radix2 53 even_choice); [reflexivity|].
    apply (generic_format_FLX_FLT _ (-1074)). exact F.
  - apply (fmt_multiple (-1074)); [lia | | apply Rlt_le; eapply Rlt_trans; [exact G | apply bpow_lt; lia]].
    assert (C : forall z, (-1074 <= cexp radix2 fexp z)%Z) by (intro; unfold cexp, FLT_exp; lia).
    apply multiple_minus; [apply multiple_finer with (1 := C h), multiple_fmt, F|].
    destruct (multiple_fmt r (fmt_rnd s)) as [n E]. set (c := cexp radix2 fexp r) in *.
    apply multiple_finer with (c + c)%Z.
    + assert (M : (-481 < mag radix2 r)%Z); [|unfold c, cexp, FLT_exp; lia]. apply mag_gt_bpow.
      destruct (size_of_near _ _ _ Er) as [L _]. rewrite (Rabs_pos_eq s) in L by lra.
      change (-481)%Z with (-480 + -1)%Z. rewrite bpow_plus. change (bpow radix2 (-1)) with (/ 2).
      rewrite u_val in *. lra.
    + exists (n * n)%Z. rewrite E at 1 2. rewrite mult_IZR, bpow_plus. ring.
Qed.

(* s is the root of the high part, and r is s, rounded. *)
Lemma root_numerator : forall xh xl r s, doubled xh xl -> smallest <= xh -> xh = s * s -> 0 < s ->
  fmt r -> Rabs (r - s) <= u * s -> fmt (xh - r * r) ->
  Rabs (root_n xh xl r - (xh + xl - r * r)) <= 302 / 100 * (u * u) * (s * s) /\
  Rabs (xh + xl - r * r) <= 301 / 100 * u * (s * s).
Proof.
  intros xh xl r s Dx Hx Es S Fr Er Residual. generalize (low_size _ _ Dx). intro Lx. destruct Dx as [Fxh Fxl _].
  generalize smallest_pos. intro P. rewrite (Rabs_pos_eq xh), Es in Lx by lra.
  rewrite Es in Fxh, Residual. unfold root_n. rewrite Es.
  set (X := s * s) in *. assert (X0 : 0 < X) by lra.
  assert (E1 : Rabs (r * r - X) <= 20001 / 10000 * u * X).
  { unfold X. replace (r * r - s * s) with ((r - s) * (r + s)) by ring.
    replace (20001 / 10000 * u * (s * s)) with ((u * s) * (20001 / 10000 * s)) by ring.
    apply product_bound; [exact Er | bound]. }
  destruct (size_of_near _ _ _ E1) as [Low High]. rewrite (Rabs_pos_eq X) in Low, High by lra.
  assert (Big : smallest_product <= Rabs (r * r)) by (generalize smallest_exact; rewrite u_val in *; lra).
  destruct (product_near r r Fr Fr) as [Ep _]. rewrite (Ep (or_intror Big)).
  assert (Esh : Rabs (rnd (r * r) - r * r) <= 101 / 100 * u * X).
  { eapply Rle_trans; [apply rnd_normal; generalize smallest_tau; rewrite u_val in *; lra|]. rewrite u_val in *. lra. }
  set (sh := rnd (r * r)) in *. assert (Fsh : fmt sh) by apply fmt_rnd.
  assert (Fd : fmt (X - sh)).
  { apply sterbenz_near; auto. rewrite (Rabs_pos_eq X) by lra. assert (Rabs (sh - X) <= 4 * u * X) by bound.
    rewrite u_val in *. lra. }
  rewrite (rnd_fmt _ Fd). replace (X - sh - (r * r - sh)) with (X - r * r) by ring. rewrite (rnd_fmt _ Residual).
  assert (N : Rabs (X + xl - r * r) <= 301 / 100 * u * X) by bound. split; [|exact N].
  replace (X + xl - r * r) with (X - r * r + xl) in * by ring.
  eapply Rle_trans; [apply (rnd_plus_within _ _ _ Residual Fxl N)|]. rewrite u_val. lra.
Qed.

(* What is added to the root r, before it is rounded. *)
Lemma root_correction : forall xh xl, doubled xh xl -> smallest <= xh ->
  let s := sqrt xh in let r := rnd s in let n := root_n xh xl r in
  0 < s /\ xh = s * s /\ smallest <= s /\ Rabs (r - s) <= u * s /\
  199 / 100 * s <= Rabs (2 * r) /\ Rabs (n - (xh + xl - r * r)) <= 302 / 100 * (u * u) * (s * s) /\
  Rabs (n / (2 * r)) <= 152 / 100 * u * s.
Proof.
  intros xh xl Dx Hx s r n. destruct (root_size xh Hx) as [S [Es Large]]. fold s in S, Es, Large.
  assert (Small : smallest <= s) by (apply Rle_trans with (2 := Large); apply bpow_le; lia).
  assert (Er : Rabs (r - s) <= u * s) by (apply rounded_root, Hx).
  destruct (root_numerator xh xl r s Dx Hx Es S (fmt_rnd s) Er (root_residual xh (high_fmt _ _ Dx) Hx)) as [En Bn].
  fold n in En. destruct (size_of_near _ _ _ Er) as [R1 _]. rewrite (Rabs_pos_eq s) in R1 by lra.
  assert (D : 199 / 100 * s <= Rabs (2 * r)).
  { rewrite Rabs_mult, (Rabs_pos_eq 2) by lra. rewrite u_val in *. lra. }
  repeat (split; [assumption|]).
  assert (SS : 0 < s * s) by (apply Rmult_lt_0_compat; exact S).
  apply quotient_bound with (199 / 100 * s); [lra | exact D|].
  replace (152 / 100 * u * s * (199 / 100 * s)) with (30248 / 10000 * u * (s * s)) by field. bound.
Qed.

Lemma root_of_sum : forall xh xl s, doubled xh xl -> 0 < s -> xh = s * s ->
  let t := sqrt (xh + xl) in 0 < t /\ xh + xl = t * t /\ Rabs (t - s) <= 6 / 10 * u * s.
Proof.
  intros xh xl s Dx S Es t. generalize (low_size _ _ Dx). intro Lx. set (x := xh + xl) in *.
  assert (X : 0 < s * s) by (apply Rmult_lt_0_compat; exact S). rewrite Es, (Rabs_pos_eq (s * s)) in Lx by lra.
  assert (X1 : 64 / 100 * (s * s) <= x) by (unfold x; apply Rabs_le_inv in Lx; rewrite u_val in *; lra).
  assert (T : 0 < t) by (apply sqrt_lt_R0; lra). assert (Et : x = t * t) by (symmetry; apply sqrt_sqrt; lra).
  split; [exact T|]. split; [exact Et|].
  replace (t - s) with (xl / (t + s)).
  2: { replace xl with ((t - s) * (t + s)); [field; lra|]. replace ((t - s) * (t + s)) with (t * t - s * s) by ring.
    rewrite <- Et, <- Es. unfold x. ring. }
  assert (Half : 8 / 10 * s <= t).
  { apply Rsqr_incr_0_var; [|lra]. unfold Rsqr. rewrite <- Et. lra. }
  apply quotient_bound with (18 / 10 * s); [lra | rewrite Rabs_pos_eq; lra|]. rewrite u_val in *. lra.
Qed.

Theorem root_doubled : forall xh xl, doubled xh xl -> smallest <= xh ->
  let zh := root_high xh xl in let zl := root_low xh xl in
  doubled zh zl /\ Rabs (zh + zl - sqrt (xh + xl)) <= 5 * (u * u) * sqrt (xh + xl).
Proof.
  intros xh xl Dx Hx zh zl. destruct (root_correction xh xl Dx Hx) as [S [Es [Small [Er [D [En Q1]]]]]].
  destruct (root_of_sum xh xl (sqrt xh) Dx S Es) as [T [Et Ts]].
  unfold zh, zl, root_high, root_low, root_q. cbv zeta.
  set (s := sqrt xh) in *. set (r := rnd s) in *. set (n := root_n xh xl r) in *. set (x := xh + xl) in *.
  set (t := sqrt x) in *. assert (Fr : fmt r) by apply fmt_rnd. rewrite (rnd_double r Fr).
  assert (D0 : 2 * r <> 0). { intro Z. rewrite Z, Rabs_R0 in D. lra. }
  destruct (size_of_near _ _ _ Er) as [R1 _]. rewrite (Rabs_pos_eq s) in R1 by lra.
  assert (SS : 0 < s * s) by (apply Rmult_lt_0_compat; exact S).
  generalize (rnd_product _ _ Q1). set (q := rnd (n / (2 * r))). intro Eq. generalize smallest_eta. intro Eta.
  assert (Bq : Rabs q <= 2 * u * s) by bound.
  assert (Fq : fmt q) by apply fmt_rnd.
  assert (O : ordered_low r q = r + q - rnd (r + q)) by (apply ordered_exact; auto; rewrite u_val in *; lra).
  split; [apply rounded_doubled; [apply fmt_rnd | exact O]|]. rewrite O.
  replace (rnd (r + q) + (r + q - rnd (r + q)) - t) with
    ((q - n / (2 * r)) + (n - (x - r * r)) / (2 * r) + (t - r) * (t - r) / (2 * r)).
  2: { rewrite Et. field. lra. }
  assert (Q2 : Rabs ((n - (x - r * r)) / (2 * r)) <= 153 / 100 * (u * u) * s).
  { apply quotient_bound with (199 / 100 * s); [lra | exact D|].
    replace (153 / 100 * (u * u) * s * (199 / 100 * s)) with (30447 / 10000 * (u * u) * (s * s)) by field.
    rewrite u_val in *. lra. }
  assert (Q3 : Rabs ((t - r) * (t - r) / (2 * r)) <= 14 / 10 * (u * u) * s).
  { apply quotient_bound with (199 / 100 * s); [lra | exact D|].
    assert (B : Rabs (t - r) <= 161 / 100 * u * s) by bound.
    eapply Rle_trans; [apply product_bound; exact B|].
    replace (161 / 100 * u * s * (161 / 100 * u * s)) with (25921 / 10000 * (u * u) * (s * s)) by field.
    replace (14 / 10 * (u * u) * s * (199 / 100 * s)) with (2786 / 1000 * (u * u) * (s * s)) by field.
    rewrite u_val. lra. }
  bound.
Qed.

(* ---- Quotient ---- *)

(* y q, as a double-double *)
Definition back_d yh yl q := rnd (product_low yh q + rnd (yl * q)).
Definition back_high yh yl q := rnd (rnd (yh * q) + back_d yh yl q).
Definition back_low yh yl q := ordered_low (rnd (yh * q)) (back_d yh yl q).
Definition quotient_n xh xl yh yl q := rnd (rnd (xh - back_high yh yl q) + rnd (xl - back_low yh yl q)).
Definition quotient_q xh xl yh yl := rnd (quotient_n xh xl yh yl (rnd (xh / yh)) / yh).
Definition quotient_high xh xl yh yl := rnd (rnd (xh / yh) + quotient_q xh xl yh yl).
Definition quotient_low xh xl yh yl := ordered_low (rnd (xh / yh)) (quotient_q xh xl yh yl).

(* X is |xh|. *)
Lemma quotient_numerator : forall xh xl yh yl q X, doubled xh xl -> doubled yh yl -> fmt q ->
  X = Rabs xh -> smallest <= X -> Rabs (yh * q - xh) <= u * X ->
  Rabs (quotient_n xh xl yh yl q - (xh + xl - (yh + yl) * q)) <= 81 / 10 * (u * u) * X /\
  Rabs (xh + xl - (yh + yl) * q) <= 301 / 100 * u * X.
Proof.
  intros xh xl yh yl q X Dx Dy Fq EX HX Eq.
  generalize (low_size _ _ Dx) (low_size _ _ Dy). rewrite <- EX. intros Lx Ly.
  destruct Dx as [Fxh Fxl _], Dy as [Fyh Fyl _].
  generalize smallest_pos smallest_eta smallest_tau smallest_exact eta_pos. intros P Eta Tau Big E0.
  destruct (size_of_near _ _ _ Eq) as [Low High]. rewrite <- EX in Low, High.
  assert (Big2 : smallest_product <= Rabs (yh * q)) by (rewrite u_val in *; lra).
  destruct (product_near yh q Fyh Fq) as [Ep _]. specialize (Ep (or_intror Big2)).
  assert (Eb : Rabs (rnd (yh * q) - yh * q) <= u * (1001 / 1000 * X)).
  { eapply Rle_trans; [apply rnd_normal; rewrite u_val in *; lra|]. rewrite u_val in *. lra. }
  assert (Bm : Rabs (yl * q) <= 1001 / 1000 * u * X).
  { rewrite Rabs_mult in *. generalize (Rmult_le_compat_r _ _ _ (Rabs_pos q) Ly). rewrite u_val in *. lra. }
  assert (Em : Rabs (rnd (yl * q) - yl * q) <= 102 / 100 * (u * u) * X).
  { generalize (rnd_product _ _ Bm). rewrite u_val in *. lra. }
  unfold quotient_n, back_high, back_low, back_d. rewrite Ep.
  set (bh := rnd (yh * q)) in *. set (m := rnd (yl * q)) in *.
  assert (Fbh : fmt bh) by apply fmt_rnd. assert (Fm : fmt m) by apply fmt_rnd.
  assert (Fbl : fmt (yh * q - bh)) by (rewrite <- Ep; apply fmt_rnd).
  assert (Ek : Rabs (rnd (yh * q - bh + m) - (yh * q - bh + m)) <= u * (201 / 100 * u * X))
    by (apply rnd_plus_within; auto; bound).
  set (k := rnd (yh * q - bh + m)) in *. assert (Fk : fmt k) by apply fmt_rnd.
  assert (Bk : Rabs k <= 202 / 100 * u * X) by bound.
  assert (Hb : Rabs (bh - xh) <= 201 / 100 * u * X) by bound.
  destruct (size_of_near _ _ _ Hb) as [LowB _]. rewrite <- EX in LowB.
  assert (O : ordered_low bh k = bh + k - rnd (bh + k)) by (apply ordered_exact; auto; rewrite u_val in *; lra).
  rewrite O.
  assert (Near : Rabs (bh + k - xh) <= 4 * u * X) by bound.
  assert (Erh : Rabs (rnd (bh + k) - (bh + k)) <= u * (1001 / 1000 * X)).
  { apply rnd_plus_within; auto. destruct (size_of_near _ _ _ Near) as [_ N]. rewrite <- EX in N.
    rewrite u_val in *. lra. }
  set (rh := rnd (bh + k)) in *. assert (Frh : fmt rh) by apply fmt_rnd.
  assert (Frl : fmt (bh + k - rh)) by (apply fmt_rounding_error; auto).
  assert (Frl2 : fmt (- (bh + k - rh))) by (apply fmt_opp; exact Frl).
  assert (Ff : fmt (xh - rh)).
  { apply sterbenz_near; auto. rewrite <- EX. assert (Rabs (rh - xh) <= 6 * u * X) by bound. rewrite u_val in *. lra. }
  rewrite (rnd_fmt _ Ff).
  assert (Eg : Rabs (rnd (xl + - (bh + k - rh)) - (xl + - (bh + k - rh))) <= u * (201 / 100 * u * X))
    by (apply rnd_plus_within; auto; bound).
  fold (xl - (bh + k - rh)) in Eg. set (g := rnd (xl - (bh + k - rh))) in *. assert (Fg : fmt g) by apply fmt_rnd.
  assert (N : Rabs (xh + xl - (yh + yl) * q) <= 301 / 100 * u * X).
  { replace (xh + xl - (yh + yl) * q) with (xl - (yh * q - xh) - yl * q) by ring. bound. }
  assert (En0 : Rabs (xh - rh + g - (xh + xl - (yh + yl) * q)) <= 506 / 100 * (u * u) * X).
  { replace (xh - rh + g - (xh + xl - (yh + yl) * q)) with
      ((g - (xl - (bh + k - rh))) - (k - (yh * q - bh + m)) - (m - yl * q)) by ring. bound. }
  assert (En : Rabs (rnd (xh - rh + g) - (xh - rh + g)) <= u * (302 / 100 * u * X)).
  { apply rnd_plus_within; auto. destruct (size_of_near _ _ _ En0) as [_ B]. rewrite u_val in *. lra. }
  split; [|exact N]. bound.
Qed.

(* What is added to the quotient q of the high parts, before it is rounded. *)
Lemma quotient_correction : forall xh xl yh yl, doubled xh xl -> doubled yh yl -> yh <> 0 ->
  smallest <= Rabs xh -> smallest <= Rabs (xh / yh) ->
  let T := Rabs (xh / yh) in let q := rnd (xh / yh) in let n := quotient_n xh xl yh yl q in
  T * Rabs yh = Rabs xh /\ Rabs (q - xh / yh) <= u * T /\
  Rabs (n - (xh + xl - (yh + yl) * q)) <= 81 / 10 * (u * u) * (T * Rabs yh) /\
  Rabs (xh + xl - (yh + yl) * q) <= 301 / 100 * u * (T * Rabs yh) /\ Rabs (n / yh) <= 302 / 100 * u * T.
Proof.
  intros xh xl yh yl Dx Dy Y0 Hx Hq T q n. generalize smallest_pos smallest_tau. intros P Tau.
  assert (YP : 0 < Rabs yh) by (apply Rabs_pos_lt; exact Y0).
  assert (EX : T * Rabs yh = Rabs xh).
  { unfold T. rewrite <- Rabs_mult. f_equal. field. exact Y0. }
  assert (Eq : Rabs (q - xh / yh) <= u * T) by (apply rnd_normal; lra).
  assert (Back : Rabs (yh * q - xh) <= u * (T * Rabs yh)).
  { replace (yh * q - xh) with ((q - xh / yh) * yh) by (field; exact Y0). rewrite <- Rmult_assoc.
    apply product_bound; [exact Eq | apply Rle_refl]. }
  destruct (quotient_numerator xh xl yh yl q (T * Rabs yh) Dx Dy (fmt_rnd _) EX ltac:(lra) Back) as [En Bn].
  fold n in En. repeat (split; [assumption|]).
  apply quotient_bound with (Rabs yh); [exact YP | apply Rle_refl|].
  replace (302 / 100 * u * T * Rabs yh) with (302 / 100 * u * (T * Rabs yh)) by ring.
  set (X := T * Rabs yh) in *. assert (X0 : 0 < X) by lra. bound.
Qed.

(* T is |xh / yh|, and Y is |yh|. *)
Lemma quotient_size : forall xh xl yh yl T Y, doubled xh xl -> doubled yh yl -> Y = Rabs yh -> T * Y = Rabs xh ->
  0 < Y -> 0 < T -> yh + yl <> 0 /\ 999 / 1000 * Y <= Rabs (yh + yl) /\
  999 / 1000 * T <= Rabs ((xh + xl) / (yh + yl)).
Proof.
  intros xh xl yh yl T Y Dx Dy EY EX YP TP. generalize (low_size _ _ Dx) (low_size _ _ Dy).
  rewrite <- EX, <- EY. intros Lx Ly. assert (TY : 0 < T * Y) by (apply Rmult_lt_0_compat; assumption).
  assert (Ey : Rabs (yh + yl - yh) <= u * Y) by (replace (yh + yl - yh) with yl by ring; exact Ly).
  assert (Ex : Rabs (xh + xl - xh) <= u * (T * Y)) by (replace (xh + xl - xh) with xl by ring; exact Lx).
  destruct (size_of_near _ _ _ Ey) as [Ly1 Ly2]. destruct (size_of_near _ _ _ Ex) as [Lx1 _].
  rewrite <- EY in Ly1, Ly2. rewrite <- EX in Lx1. set (y := yh + yl) in *. set (x := xh + xl) in *.
  assert (Y1 : 999 / 1000 * Y <= Rabs y) by (rewrite u_val in *; lra).
  assert (y0 : y <> 0). { intro Z. rewrite Z, Rabs_R0 in Y1. lra. }
  split; [exact y0|]. split; [exact Y1|].
  apply Rmult_le_reg_r with (Rabs y); [lra|]. rewrite <- Rabs_mult. replace (x / y * y) with x by (field; exact y0).
  apply Rle_trans with (999 / 1000 * T * (1001 / 1000 * Y)).
  - apply Rmult_le_compat_l; [lra | rewrite u_val in *; lra].
  - replace (999 / 1000 * T * (1001 / 1000 * Y)) with (999999 / 1000000 * (T * Y)) by field. rewrite u_val in *. lra.
Qed.

Theorem quotient_doubled : forall xh xl yh yl, doubled xh xl -> doubled yh yl -> yh <> 0 ->
  smallest <= Rabs xh -> smallest <= Rabs (xh / yh) ->
  let zh := quotient_high xh xl yh yl in let zl := quotient_low xh xl yh yl in
  doubled zh zl /\ Rabs (zh + zl - (xh + xl) / (yh + yl)) <= 15 * (u * u) * Rabs ((xh + xl) / (yh + yl)).
Proof.
  intros xh xl yh yl Dx Dy Y0 Hx Hq zh zl. generalize smallest_pos smallest_eta. intros P Eta.
  destruct (quotient_correction xh xl yh yl Dx Dy Y0 Hx Hq) as [EX [Eq [En [Bn Q1]]]].
  generalize (low_size _ _ Dy). intro Ly. assert (YP : 0 < Rabs yh) by (apply Rabs_pos_lt; exact Y0).
  unfold zh, zl, quotient_high, quotient_low, quotient_q.
  set (T := Rabs (xh / yh)) in *. set (q := rnd (xh / yh)) in *. set (n := quotient_n xh xl yh yl q) in *.
  set (Y := Rabs yh) in *. assert (TY : 0 < T * Y) by lra.
  destruct (quotient_size xh xl yh yl T Y Dx Dy eq_refl EX YP ltac:(lra)) as [y0 [Y1 Size]].
  assert (Fq : fmt q) by apply fmt_rnd.
  generalize (rnd_product _ _ Q1). set (p := rnd (n / yh)). intro Ep. assert (Fp : fmt p) by apply fmt_rnd.
  assert (Bp : Rabs p <= 4 * u * T) by bound.
  destruct (size_of_near _ _ _ Eq) as [Lq _]. fold T in Lq.
  assert (O : ordered_low q p = q + p - rnd (q + p)) by (apply ordered_exact; auto; rewrite u_val in *; lra).
  split; [apply rounded_doubled; [apply fmt_rnd | exact O]|]. rewrite O.
  set (x := xh + xl) in *. set (y := yh + yl) in *.
  replace (rnd (q + p) + (q + p - rnd (q + p)) - x / y) with
    ((p - n / yh) + (n - (x - y * q)) / yh + (x - y * q) * yl / (yh * y)).
  2: { replace yl with (y - yh) by (unfold y; ring). field. split; assumption. }
  assert (Q2 : Rabs ((n - (x - y * q)) / yh) <= 81 / 10 * (u * u) * T).
  { apply quotient_bound with Y; [exact YP | apply Rle_refl|]. lra. }
  assert (Q3 : Rabs ((x - y * q) * yl / (yh * y)) <= 303 / 100 * (u * u) * T).
  { assert (YY : 0 < Y * (999 / 1000 * Y)) by (apply Rmult_lt_0_compat; lra).
    apply quotient_bound with (Y * (999 / 1000 * Y)); [exact YY | |].
    - rewrite Rabs_mult. fold Y. apply Rmult_le_compat_l; lra.
    - eapply Rle_trans; [apply product_bound; [exact Bn | exact Ly]|].
      replace (301 / 100 * u * (T * Y) * (u * Y)) with (301 / 100 * (u * u) * (T * Y * Y)) by ring.
      replace (303 / 100 * (u * u) * T * (Y * (999 / 1000 * Y))) with
        (302697 / 100000 * (u * u) * (T * Y * Y)) by field.
      assert (0 < T * Y * Y) by (apply Rmult_lt_0_compat; [exact TY | exact YP]). rewrite u_val. lra. }
  bound.
Qed.
Lemma quotient_n_zero : forall yh yl, fmt yh -> quotient_n 0 0 yh yl 0 = 0.
Proof.
  intros yh yl F. destruct (product_near yh 0 F (generic_format_0 _ _)) as [E _].
  unfold quotient_n, back_high, back_low, back_d. rewrite E by (left; ring).
  rewrite !Rmult_0_r, rnd_0. replace (0 - 0 + 0) with 0 by ring. rewrite !rnd_0, ordered_zero, Rplus_0_r, rnd_0.
  rewrite Rminus_0_r, rnd_0, Rplus_0_r. apply rnd_0.
Qed.
Lemma zero_quotient : forall y, rnd (0 / y) = 0.
Proof. intro y. unfold Rdiv. rewrite Rmult_0_l. apply rnd_0. Qed.
Lemma quotient_zero : forall yh yl, fmt yh -> quotient_high 0 0 yh yl = 0 /\ quotient_low 0 0 yh yl = 0.
Proof.
  intros yh yl F. unfold quotient_high, quotient_low, quotient_q. rewrite !zero_quotient, quotient_n_zero by exact F.
  rewrite zero_quotient, Rplus_0_r. split; [apply rnd_0 | apply ordered_zero].
Qed.
