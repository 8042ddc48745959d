(* The order of two exits, order_sign() of src/flow/kernels/direction.h: where a direction is known (Directions.v), an
   answer is the sign of the exact form. The code compares squares. *)
From Coq Require Import Reals ZArith QArith Qreals Lra Lia Psatz Bool List.
From Flocq Require Import Core BinarySingleNaN.
From Flowcert Require Import algebra.Vector3 code.Expression code.generated.Constants filters.Rounding
  filters.RoundedVectors filters.Norms filters.Floors filters.Doubles filters.Terms filters.Filter filters.Directions
  filters.DirectionSigns.
Import ListNotations.
Open Scope R_scope.

Definition seen_twice := [(0, 2); (1, 2); (0, 3); (1, 3)]%nat.
Definition order :=
  Minus (Times (Dot (Given 3) (Given 4)) (Dot (Given 0) (VPlus (Given 1) (Given 2))))
        (Times (Dot (Given 1) (Given 2)) (Dot (Given 0) (VPlus (Given 3) (Given 4)))).
Definition order_part :=
  Add (Mul (Cst (fst kOrderTurn) (snd kOrderTurn)) error_variable) (in_roundoffs kOrderBound).
Definition of_sizes t i j := Mul (Mul (Mul (Cst 1 1) t) t) (Mul (Mul i j) (Add i j)).
Definition order_bound := of_sizes order_part (size_square seen_twice 1 2) (size_square seen_twice 3 4).
Definition order_needs : Q := 686 # 100.

Lemma order_match :
  let size_i := size_square seen_twice 1 2 in let size_j := size_square seen_twice 3 4 in
  let value := replace (inputs seen_twice) (flatten order) in
  Code.Order.sign =
  If Less error_variable one (If Less order_bound (Mul value value)
    (If LessEqual low_square size_i (If LessEqual size_i high_square
      (If LessEqual low_square size_j (If LessEqual size_j high_square
        (If Less (Cst 0 0) value (Answer (Some Positive)) (Answer (Some Negative)))
      (Answer None)) (Answer None)) (Answer None)) (Answer None)) (Answer None)) (Answer None).
Proof. vm_compute. reflexivity. Qed.

Lemma rnd_upper : forall z, 0 <= z -> rnd z <= z * (1 + u) + u * tau.
Proof. intros z H. generalize (rnd_any z). rewrite (Rabs_pos_eq z H). intro R. apply Rabs_le_inv in R. lra. Qed.

(* Where the square of the value is above the bound, the value is above what it has to be. *)
Lemma order_covers : forall t q c Gi Gj Si Sj v,
  0 <= t <= 3 / 32 -> / 4 <= q <= 1 -> 6.86 * u <= c <= 1000 * u -> fmt c ->
  / 10 ^ 26 <= Gi -> / 10 ^ 26 <= Gj -> Gi * Gi <= Si * (1 + 8 * u) -> Gj * Gj <= Sj * (1 + 8 * u) ->
  let part := rnd (rnd (q * t) + c) in
  rnd (rnd (rnd (2 * part) * part) * rnd (rnd (Si * Sj) * rnd (Si + Sj))) < rnd (v * v) ->
  ((t + 12 * u) * (1 + 16 * u) / 4 + 3.0004 * u) * (Gi * Gj * (Gi + Gj)) < Rabs v.
Proof.
  intros t q c Gi Gj Si Sj v Ht Hq Hc Fc HGi HGj HSi HSj part H. generalize u_pos u_val tau_pos tau_small.
  intros U0 Hu T0 T1.
  assert (Pos : forall k, 0 < / 10 ^ k) by (intro; apply Rinv_0_lt_compat, pow_lt; lra).
  assert (Pi := Pos 26%nat). assert (T : tau <= / 10 ^ 300) by exact T1.
  (* the part *)
  set (p0 := (t / 4 + c) * (1 - 2.01 * u)).
  assert (Hp : p0 <= part).
  { assert (A : t / 4 * (1 - u) - u * tau <= rnd (q * t)).
    { generalize (rnd_any (q * t)). rewrite (Rabs_pos_eq (q * t)) by (apply Rmult_le_pos; lra). intro R. apply
      Rabs_le_inv in R.
      assert (/ 4 * t * (1 - u) <= q * t * (1 - u)).
      { apply Rmult_le_compat_r; [rewrite Hu; lra|]. apply Rmult_le_compat_r; lra. }
      lra. }
    assert (Tc : u * tau <= / 10 ^ 100 * u).
    { assert (tau <= / 10 ^ 100) by (eapply Rle_trans; [exact T|]; apply Rinv_le; [apply pow_lt; lra | apply
        Rle_pow; [lra | lia]]). rewrite Hu. lra. }
    assert (B0 : 0 <= rnd (q * t)).
    { unfold rnd. apply round_ge_generic; auto with typeclass_instances; [apply generic_format_0|].
      apply Rmult_le_pos; lra. }
    assert (B := rnd_plus (rnd (q * t)) c (fmt_rnd _) Fc). rewrite (Rabs_pos_eq (rnd (q * t) + c)) in B by lra.
    apply Rabs_le_inv in B. fold part in B. unfold p0.
    assert ((t / 4 * (1 - u) - u * tau + c) * (1 - u) <= (rnd (q * t) + c) * (1 - u))
      by (apply Rmult_le_compat_r; [rewrite Hu; lra | lra]).
    set (e := u * tau) in *. rewrite Hu in *. lra. }
  assert (P0 : 6.8 * u <= p0) by (unfold p0; rewrite Hu in *; lra).
  (* products *)
  assert (Si0 : Gi * Gi * (1 - 8 * u) <= Si).
  { apply Rmult_le_reg_r with (1 + 8 * u); [lra|].
    assert (Gi * Gi * ((1 - 8 * u) * (1 + 8 * u)) <= Gi * Gi * 1); [|lra].
    apply Rmult_le_compat_l; [nra | rewrite Hu; lra]. }
  assert (Sj0 : Gj * Gj * (1 - 8 * u) <= Sj).
  { apply Rmult_le_reg_r with (1 + 8 * u); [lra|].
    assert (Gj * Gj * ((1 - 8 * u) * (1 + 8 * u)) <= Gj * Gj * 1); [|lra].
    apply Rmult_le_compat_l; [nra | rewrite Hu; lra]. }
  clear HSi HSj.
  assert (Qi : / 10 ^ 52 <= Gi * Gi).
  { replace (/ 10 ^ 52) with (/ 10 ^ 26 * / 10 ^ 26) by (rewrite <- Rinv_mult, <- pow_add; reflexivity).
    apply Rmult_le_compat; lra. }
  assert (Qj : / 10 ^ 52 <= Gj * Gj).
  { replace (/ 10 ^ 52) with (/ 10 ^ 26 * / 10 ^ 26) by (rewrite <- Rinv_mult, <- pow_add; reflexivity).
    apply Rmult_le_compat; lra. }
  set (gi := Gi * Gi) in *. set (gj := Gj * Gj) in *. set (w8 := 1 - 8 * u) in *. set (w2 := 1 - 2 * u).
  assert (W8 : / 2 <= w8 <= 1) by (unfold w8; rewrite Hu; lra).
  assert (W2 : / 2 <= w2 <= 1) by (unfold w2; rewrite Hu; lra).
  assert (Half : forall k z w, / 10 ^ k <= z -> / 2 <= w -> / 10 ^ (k + 1) <= z * w).
  { intros k z w A B. rewrite pow_add. simpl (10 ^ 1). rewrite Rmult_1_r, Rinv_mult. generalize (Pos k). intro.
    apply Rmult_le_compat; lra. }
  assert (Tau : forall k z, (k <= 300)%nat -> / 10 ^ k <= z -> tau <= z).
  { intros k z A B. eapply Rle_trans; [exact T|]. eapply Rle_trans; [|exact B]. apply Rinv_le; [apply pow_lt; lra |
      apply Rle_pow; [lra | exact A]]. }
  assert (Ri := Half 52%nat _ _ Qi (proj1 W8)). assert (Rj := Half 52%nat _ _ Qj (proj1 W8)).
  assert (Gi0 := Pos 53%nat). assert (Gj0 := Pos 53%nat). cbn [Nat.add] in Ri, Rj.
  assert (M1 : gi * w8 * (gj * w8) <= Si * Sj) by (apply Rmult_le_compat; lra).
  assert (F1 := floor_mult _ _ _ _ Ri Rj). cbn [Nat.add] in F1.
  assert (M1' := rnd_lower _ _ (Tau 106%nat _ ltac:(lia) F1) M1). fold w2 in M1'.
  assert (M2 : gi * w8 + gj * w8 <= Si + Sj) by lra.
  assert (F2 : / 10 ^ 53 <= gi * w8 + gj * w8) by lra.
  assert (M2' := rnd_lower _ _ (Tau 53%nat _ ltac:(lia) F2) M2). fold w2 in M2'.
  assert (F1' := Half _ _ w2 F1 (proj1 W2)). assert (F2' := Half _ _ w2 F2 (proj1 W2)). cbn [Nat.add] in F1', F2'.
  assert (Pos107 := Pos 107%nat). assert (Pos54 := Pos 54%nat).
  assert (M3 : gi * w8 * (gj * w8) * w2 * ((gi * w8 + gj * w8) * w2) <= rnd (Si * Sj) * rnd (Si + Sj))
    by (apply Rmult_le_compat; lra).
  assert (F3 := floor_mult _ _ _ _ F1' F2'). cbn [Nat.add] in F3.
  assert (M3' := rnd_lower _ _ (Tau 161%nat _ ltac:(lia) F3) M3). fold w2 in M3'.
  assert (F3' := Half _ _ w2 F3 (proj1 W2)). cbn [Nat.add] in F3'. assert (Pos162 := Pos 162%nat).
  (* the factor *)
  rewrite rnd_double in H by apply fmt_rnd.
  assert (N1 : 2 * p0 * p0 <= 2 * part * part) by (apply Rmult_le_compat; lra).
  assert (F4 : / 10 ^ 32 <= 2 * p0 * p0).
  { apply Rle_trans with (2 * (6.8 * u) * (6.8 * u)); [rewrite Hu; lra|]. apply Rmult_le_compat; lra. }
  assert (N1' := rnd_lower _ _ (Tau 32%nat _ ltac:(lia) F4) N1). fold w2 in N1'.
  assert (F4' := Half _ _ w2 F4 (proj1 W2)). cbn [Nat.add] in F4'. assert (Pos33 := Pos 33%nat).
  match type of H with rnd (rnd ?f * rnd ?m) < _ => set (f' := rnd f) in *; set (m' := rnd m) in * end.
  assert (N2 : 2 * p0 * p0 * w2 * (gi * w8 * (gj * w8) * w2 * ((gi * w8 + gj * w8) * w2) * w2) <= f' * m')
    by (apply Rmult_le_compat; lra).
  assert (F5 := floor_mult _ _ _ _ F4' F3'). cbn [Nat.add] in F5.
  assert (N2' := rnd_lower _ _ (Tau 195%nat _ ltac:(lia) F5) N2). fold w2 in N2'.
  (* the squares *)
  set (K := Gi * Gj * (Gi + Gj)).
  assert (V0 : 0 <= v * v) by apply Rle_0_sqr.
  assert (Up := rnd_upper (v * v) V0).
  set (w := w2 * w2 * w2 * w2 * w2 * (w8 * w8 * w8)).
  assert (HW : 1 - 34.01 * u <= w) by (unfold w, w2, w8; rewrite Hu; lra).
  assert (Low : p0 * K * (p0 * K) * w <= 2 * p0 * p0 * w2 * (gi * w8 * (gj * w8) * w2 * ((gi * w8 + gj * w8) * w2) *
    w2) * w2).
  { replace (2 * p0 * p0 * w2 * (gi * w8 * (gj * w8) * w2 * ((gi * w8 + gj * w8) * w2) * w2) * w2)
      with (p0 * p0 * (gi * gj * (2 * (gi + gj))) * w) by (unfold w; ring).
    assert (0 <= w) by (rewrite Hu in *; lra). apply Rmult_le_compat_r; [assumption|].
    replace (p0 * K * (p0 * K)) with (p0 * p0 * (gi * gj * ((Gi + Gj) * (Gi + Gj)))) by (unfold K, gi, gj; ring).
    apply Rmult_le_compat_l; [apply Rmult_le_pos; lra|]. apply Rmult_le_compat_l; [apply Rmult_le_pos; lra|].
    unfold gi, gj. assert (0 <= (Gi - Gj) * (Gi - Gj)) by apply Rle_0_sqr. lra. }
  assert (K0 : / 10 ^ 78 <= K).
  { unfold K. replace (/ 10 ^ 78) with (/ 10 ^ 26 * / 10 ^ 26 * / 10 ^ 26)
      by (rewrite <- !Rinv_mult, <- !pow_add; reflexivity).
    apply Rmult_le_compat; [apply Rmult_le_pos; lra | lra | apply Rmult_le_compat; lra | lra]. }
  assert (Pos78 := Pos 78%nat).
  set (z := p0 * K) in *. assert (Z0 : / 10 ^ 95 <= z).
  { unfold z. replace (/ 10 ^ 95) with (/ 10 ^ 17 * / 10 ^ 78) by (rewrite <- Rinv_mult, <- pow_add; reflexivity).
    apply Rmult_le_compat; rewrite Hu in *; lra. }
  assert (Pos95 := Pos 95%nat).
  assert (ZZ : / 10 ^ 190 <= z * z).
  { replace (/ 10 ^ 190) with (/ 10 ^ 95 * / 10 ^ 95) by (rewrite <- Rinv_mult, <- pow_add; reflexivity).
    apply Rmult_le_compat; lra. }
  assert (Small : u * tau <= u * (u * (z * z))).
  { apply Rmult_le_compat_l; [lra|]. eapply Rle_trans; [exact T|].
    apply Rle_trans with (/ 10 ^ 20 * / 10 ^ 190).
    - rewrite <- Rinv_mult, <- pow_add. apply Rinv_le; [apply pow_lt; lra | apply Rle_pow; [lra | lia]].
    - apply Rmult_le_compat; try lra; rewrite Hu; lra. }
  assert (Sq : z * (1 - 17.6 * u) * (z * (1 - 17.6 * u)) < v * v).
  { assert (B : z * z * w < v * v * (1 + u) + u * (u * (z * z))) by lra.
    apply Rmult_lt_reg_r with (1 + u); [lra|].
    replace (z * (1 - 17.6 * u) * (z * (1 - 17.6 * u)) * (1 + u)) with (z * z * ((1 - 17.6 * u) * (1 - 17.6 * u) * (1 +
      u))) by ring.
    assert (z * z * ((1 - 17.6 * u) * (1 - 17.6 * u) * (1 + u) + u * u) <= z * z * w).
    { apply Rmult_le_compat_l; [nra|]. eapply Rle_trans; [|exact HW]. rewrite Hu. lra. }
    lra. }
  assert (Y0 : 0 <= z * (1 - 17.6 * u)) by (apply Rmult_le_pos; rewrite ?Hu; lra).
  assert (Lv : z * (1 - 17.6 * u) < Rabs v).
  { apply Rnot_le_lt. intro N. assert (Rabs v * Rabs v <= z * (1 - 17.6 * u) * (z * (1 - 17.6 * u))).
    { apply Rmult_le_compat; auto using Rabs_pos. }
    rewrite <- Rabs_mult, (Rabs_pos_eq _ V0) in H0. lra. }
  eapply Rle_lt_trans; [|exact Lv]. unfold z.
  replace (p0 * K * (1 - 17.6 * u)) with (p0 * (1 - 17.6 * u) * K) by ring.
  fold K. apply Rmult_le_compat_r; [lra|]. unfold p0. rewrite Hu in *. lra.
Qed.

(* The value's error, and what the direction's error makes of it, in units of Gi Gj (Gi + Gj). *)
Lemma order_sizes : forall n0 ai bi aj bj Gi Gj, 0 <= n0 -> 0 <= ai -> 0 <= bi -> 0 <= aj -> 0 <= bj ->
  ai + bi <= Gi -> aj + bj <= Gj -> 4 * (ai * bi) <= Gi * Gi -> 4 * (aj * bj) <= Gj * Gj ->
  aj * bj * (n0 * (ai + bi)) + ai * bi * (n0 * (aj + bj)) <= n0 * (Gi * Gj * (Gi + Gj)) / 4.
Proof.
  intros n0 ai bi aj bj Gi Gj N A1 A2 A3 A4 S1 S2 P1 P2.
  assert (0 <= aj * bj) by (apply Rmult_le_pos; lra). assert (0 <= ai * bi) by (apply Rmult_le_pos; lra).
  assert (X1 : aj * bj * (ai + bi) <= Gj * Gj / 4 * Gi) by (apply Rmult_le_compat; lra).
  assert (X2 : ai * bi * (aj + bj) <= Gi * Gi / 4 * Gj) by (apply Rmult_le_compat; lra).
  assert (X3 : n0 * (aj * bj * (ai + bi) + ai * bi * (aj + bj)) <= n0 * (Gj * Gj / 4 * Gi + Gi * Gi / 4 * Gj))
    by (apply Rmult_le_compat_l; lra).
  lra.
Qed.

Definition form_of_order dj1 dj2 di1 di2 :=
  vsub (vscale (dot dj1 dj2) (vadd di1 di2)) (vscale (dot di1 di2) (vadd dj1 dj2)).
Lemma form_of_order_len : forall dj1 dj2 di1 di2, let Gi := seen_size di1 di2 in let Gj := seen_size dj1 dj2 in
  len (form_of_order dj1 dj2 di1 di2) <= Gi * Gj * (Gi + Gj) / 4.
Proof.
  intros dj1 dj2 di1 di2 Gi Gj. unfold form_of_order.
  assert (T := len_triangle (vscale (dot dj1 dj2) (vadd di1 di2)) (vscale (- dot di1 di2) (vadd dj1 dj2))).
  replace (vadd (vscale (dot dj1 dj2) (vadd di1 di2)) (vscale (- dot di1 di2) (vadd dj1 dj2)))
    with (vsub (vscale (dot dj1 dj2) (vadd di1 di2)) (vscale (dot di1 di2) (vadd dj1 dj2))) in T
    by (apply vec_eq; unfold vadd, vsub, vscale; cbn; ring).
  rewrite !len_scale_any, Rabs_Ropp in T. eapply Rle_trans; [exact T|].
  generalize (dot_len dj1 dj2) (dot_len di1 di2) (len_triangle di1 di2) (len_triangle dj1 dj2) (sum_below_seen_size di1
    di2) (sum_below_seen_size dj1 dj2) (product_below_seen_size di1 di2) (product_below_seen_size dj1 dj2)
    (len_nonneg di1) (len_nonneg di2) (len_nonneg dj1) (len_nonneg dj2) (Rabs_pos (dot dj1 dj2)) (Rabs_pos (dot di1
    di2)) (len_nonneg (vadd di1 di2)) (len_nonneg (vadd dj1 dj2)). fold Gi Gj. intros D1 D2 T1 T2 S1 S2 P1 P2.
  intros. apply Rle_trans with (len dj1 * len dj2 * (1 * (len di1 + len di2)) + len di1 * len di2 * (1 * (len dj1 + len
    dj2))).
  - rewrite !Rmult_1_l. apply Rplus_le_compat; apply Rmult_le_compat; assumption.
  - eapply Rle_trans; [apply order_sizes with (Gi := Gi) (Gj := Gj); lra|]. lra.
Qed.

Lemma seen_in_range : forall x i j,
  compare_doubles LessEqual (on_doubles x low_square) (on_doubles x (size_square seen_twice i j)) = true ->
  compare_doubles LessEqual (on_doubles x (size_square seen_twice i j)) (on_doubles x high_square) = true ->
  square_in_range (fun n => on_doubles x (inputs seen_twice n)) (seen_square i j).
Proof. intros x i j L H. unfold size_square in L, H. rewrite on_doubles_replace in L, H. split; assumption. Qed.

Lemma square_power : forall G S, / 10 ^ 26 <= G <= 10 ^ 26 -> 0 < S -> S <= G * G * (1 + 8 * u) ->
  Rabs S <= bpow radix2 176.
Proof.
  intros G S HG HS H. rewrite Rabs_pos_eq by lra. eapply Rle_trans; [exact H|].
  apply Rle_trans with (10 ^ 26 * 10 ^ 26 * 2).
  - apply Rmult_le_compat; [apply Rmult_le_pos | rewrite u_val | apply Rmult_le_compat | rewrite u_val]; lra.
  - change (bpow radix2 176) with (IZR (2 ^ 176)). rewrite pow_IZR, <- !mult_IZR. apply IZR_le. vm_compute.
    discriminate.
Qed.

Theorem order_right : forall e y x s, known_on_doubles e y x -> run x Code.Order.sign = Some s ->
  let p0 := point x 0 in let p1 := point x 1 in let qi := point x 2 in let qj := point x 3 in
  is_sign s (dot y (form_of_order (vsub qj p0) (vsub qj p1) (vsub qi p0) (vsub qi p1))).
Proof.
  intros e y x s K H p0 p1 qi qj. rewrite order_match in H. cbn [run] in H.
  set (value := replace (inputs seen_twice) (flatten order)) in *.
  destruct (compare_doubles Less (on_doubles x error_variable) _); [|discriminate].
  destruct (compare_doubles Less (on_doubles x order_bound) _) eqn:Beyond; [|discriminate].
  destruct (compare_doubles LessEqual (on_doubles x low_square) (on_doubles x (size_square seen_twice 1 2))) eqn:Li;
    [|discriminate].
  destruct (compare_doubles LessEqual (on_doubles x (size_square seen_twice 1 2)) _) eqn:Hi; [|discriminate].
  destruct (compare_doubles LessEqual (on_doubles x low_square) (on_doubles x (size_square seen_twice 3 4))) eqn:Lj;
    [|discriminate].
  destruct (compare_doubles LessEqual (on_doubles x (size_square seen_twice 3 4)) _) eqn:Hj; [|discriminate].
  destruct (seen_back seen_twice x 0 1 (seen_in_range x 1 2 Li Hi)) as [Fi [B1 [B2 [HGi [Si1 [_ [Si2 Pi]]]]]]].
  destruct (seen_back seen_twice x 2 3 (seen_in_range x 3 4 Lj Hj)) as [Fj [B3 [B4 [HGj [Sj1 [_ [Sj2 Pj]]]]]]].
  clear Li Hi Lj Hj.
  rewrite <- (on_doubles_replace (inputs seen_twice)) in Fi, Fj, Si1, Si2, Pi, Sj1, Sj2, Pj.
  change (replace (inputs seen_twice) (seen_square 1 2)) with (size_square seen_twice 1 2) in *.
  change (replace (inputs seen_twice) (seen_square 3 4)) with (size_square seen_twice 3 4) in *.
  set (d k := value_of_vector (exact_inputs seen_twice x) k) in *.
  change (value_of_vector (exact_inputs seen_twice x) 1) with (d 1%nat) in *.
  change (value_of_vector (exact_inputs seen_twice x) 2) with (d 2%nat) in *.
  change (value_of_vector (exact_inputs seen_twice x) 3) with (d 3%nat) in *.
  change (value_of_vector (exact_inputs seen_twice x) 4) with (d 4%nat) in *.
  set (Gi := seen_size (d 1%nat) (d 2%nat)) in *. set (Gj := seen_size (d 3%nat) (d 4%nat)) in *.
  set (Si := on_doubles x (size_square seen_twice 1 2)) in *. set (Sj := on_doubles x (size_square seen_twice 3 4)) in
    *.
  (* the value *)
  destruct (value_of_inputs 5 order 271 seen_twice x) as [FV [Small Error]]; [vm_compute; reflexivity | vm_compute;
    reflexivity | apply (known_is_direction e y), K | |].
  { intros k Hk. destruct k as [|[|[|[|[|k]]]]]; [lia | | | | | lia]; eexists; (split; [eassumption | lra]). }
  rewrite <- on_doubles_replace in FV, Small, Error. fold value in FV, Small, Error.
  destruct K as [Fx K]. set (t := error_of x). assert (Ht : 0 <= t <= 3 / 32) by exact (error_not_negative _ _ _ _ K).
  set (v := on_doubles x value) in *.
  (* the squares are finite *)
  destruct (forward (fun _ => v) (fun n => match n with 0%nat => 271 | _ => 5000 end)%Z (Mul (Var 0) (Var 0)) 542)
    as [FQ [EQ _]].
  { intros [|n] Hn; [split; [exact FV | exact Small] | discriminate Hn]. }
  { vm_compute. reflexivity. }
  change (on_doubles (fun _ => v) (Mul (Var 0) (Var 0))) with (Bmult mode_NE v v) in FQ, EQ.
  assert (EQ' : val (Bmult mode_NE v v) = rnd (val v * val v)) by exact EQ.
  set (w n := match n with 0%nat => x 21%nat | 1%nat => Si | _ => Sj end).
  set (part := Add (Mul (Cst (fst kOrderTurn) (snd kOrderTurn)) (Var 0)) (in_roundoffs kOrderBound)).
  set (tops := fun n => match n with 0%nat => 0 | 1%nat | 2%nat => 176 | _ => 5000 end%Z).
  destruct (height tops (of_sizes part (Var 1) (Var 2))) as [top|] eqn:Top; [|vm_compute in Top; discriminate].
  destruct (forward w tops (of_sizes part (Var 1) (Var 2)) top) as [FB [EB _]]; [|exact Top|].
  { intros [|[|[|n]]] Hn; [| | | discriminate Hn]; cbn [w]; unfold tops.
    - split; [apply Fx; lia|]. change (val (x 21%nat)) with t. change (bpow radix2 0) with 1. rewrite Rabs_pos_eq; lra.
    - split; [exact Fi | apply (square_power Gi); assumption].
    - split; [exact Fj | apply (square_power Gj); assumption]. }
  change (on_doubles w (of_sizes part (Var 1) (Var 2))) with (on_doubles x order_bound) in *.
  cbn [on_doubles] in Beyond. fold v in Beyond. rewrite compare_finite in Beyond by assumption.
  cbn [compare_reals] in Beyond. rewrite EQ' in Beyond. revert Beyond. case Rlt_bool_spec; [|discriminate].
  intros Beyond _.
  destruct (header_constant kOrderBound order_needs 1000 eq_refl x) as [Fc Hc].
  replace (Q2R order_needs) with 6.86 in Hc by (unfold Q2R; cbn; lra).
  replace (Q2R 1000) with 1000 in Hc by (unfold Q2R; cbn; lra).
  set (turn := on_reals rnd (fun n => val (w n)) (Cst (fst kOrderTurn) (snd kOrderTurn))).
  assert (Hq : / 4 <= turn <= 1).
  { assert (A : Qle_bool (1 # 4) (units_of kOrderTurn) && Qle_bool (units_of kOrderTurn) 1 = true)
      by (vm_compute; reflexivity).
    rewrite andb_true_iff, !Qle_bool_iff in A. destruct A as [A1 A2]. apply Qle_Rle in A1, A2.
    unfold units_of in A1, A2. rewrite rational_value in A1, A2.
    replace (Q2R (1 # 4)) with (/ 4) in A1 by (unfold Q2R; cbn; lra). rewrite Q2R_1 in A2. exact (conj A1 A2). }
  assert (EB' : val (on_doubles x order_bound) = let p := rnd (rnd (turn * t) + val (on_doubles x (in_roundoffs
    kOrderBound))) in rnd (rnd (rnd (2 * p) * p) * rnd (rnd (val Si * val Sj) * rnd (val Si + val Sj)))).
  { rewrite EB. unfold rounded, of_sizes, part. cbn [on_reals].
    rewrite (constant_on_reals kOrderBound _ x) by reflexivity. fold turn.
    replace (F2R (Float radix2 1 1)) with 2 by (unfold F2R; cbn [Fnum Fexp]; change (bpow radix2 1) with 2; ring).
    reflexivity. }
  rewrite EB' in Beyond.
  assert (Cover := order_covers t turn _ Gi Gj _ _ _ Ht Hq Hc (fmt_val _) (proj1 HGi) (proj1 HGj) Si1 Sj1 Beyond).
  (* the form *)
  set (form := form_of_order (d 3%nat) (d 4%nat) (d 1%nat) (d 2%nat)).
  change (is_sign s (dot y form)).
  assert (Exact : exact (exact_inputs seen_twice x) (flatten order) = dot (direction_of x) form).
  { unfold form, form_of_order. change (exact (exact_inputs seen_twice x) (flatten order)) with
      (dot (d 3%nat) (d 4%nat) * dot (direction_of x) (vadd (d 1%nat) (d 2%nat)) -
       dot (d 1%nat) (d 2%nat) * dot (direction_of x) (vadd (d 3%nat) (d 4%nat))).
    generalize (dot (d 3%nat) (d 4%nat)) (dot (d 1%nat) (d 2%nat)) (direction_of x) (vadd (d 1%nat) (d 2%nat))
      (vadd (d 3%nat) (d 4%nat)). clear. intros. vdestruct. vunfold. ring. }
  rewrite Exact in Error. destruct (form_of_known e y _ _ K) as [scale [Ps Form]]. specialize (Form form).
  fold t in Form. assert (Long := form_of_order_len (d 3%nat) (d 4%nat) (d 1%nat) (d 2%nat)). fold Gi Gj form in Long.
  set (N := Gi * Gj * (Gi + Gj)) in *.
  generalize u_pos u_val. intros U0 Hu.
  assert (N0 : 0 <= N).
  { assert (0 < / 10 ^ 26) by (apply Rinv_0_lt_compat, pow_lt; lra).
    unfold N. apply Rmult_le_pos; [apply Rmult_le_pos|]; lra. }
  assert (Form' : Rabs (dot (direction_of x) form - scale * dot y form) <= (t + 12 * u) * (1 + 16 * u) / 4 * N).
  { eapply Rle_trans; [exact Form|].
    apply Rle_trans with ((t + 12 * u) * (1 + 16 * u) * (N / 4)); [|right; field].
    apply Rmult_le_compat_l; [apply Rmult_le_pos; lra | exact Long]. }
  assert (P43 : 0 < / 10 ^ 43) by (apply Rinv_0_lt_compat, pow_lt; lra).
  assert (Error' : Q2R (Terms.error error_of_input order) * size (size_of_input seen_twice x) order <= 3.0004 * u * N).
  { destruct (error_below (Terms.error error_of_input order) (120005 # 10000)) as [Q0 Q];
      [vm_compute; reflexivity|]. replace (Q2R (120005 # 10000)) with 12.0005 in Q by (unfold Q2R; cbn; lra).
    cbn [size order]. unfold size_of_input. cbn [Nat.eqb].
    fold (d 1%nat) (d 2%nat) (d 3%nat) (d 4%nat).
    generalize (len_nonneg (d 1%nat)) (len_nonneg (d 2%nat)) (len_nonneg (d 3%nat)) (len_nonneg (d 4%nat)).
    generalize (sum_below_seen_size (d 1%nat) (d 2%nat)) (sum_below_seen_size (d 3%nat) (d 4%nat))
      (product_below_seen_size (d 1%nat) (d 2%nat)) (product_below_seen_size (d 3%nat) (d 4%nat)).
    fold Gi Gj. clearbody Gi Gj. generalize (len (d 1%nat)) (len (d 2%nat)) (len (d 3%nat)) (len (d 4%nat)).
    intros l1 l2 l3 l4 S1 S2 P1 P2 L1 L2 L3 L4.
    assert (Wide : forall l m G, 0 <= l -> 0 <= m -> l + m <= G -> 4 * (l * m) <= G * G -> / 10 ^ 26 <= G ->
      l + / 10 ^ 43 + (m + / 10 ^ 43) <= G * (1 + u) /\
      4 * ((l + / 10 ^ 43) * (m + / 10 ^ 43)) <= G * (1 + u) * (G * (1 + u))).
    { intros l m G A1 A2 A3 A4 A5.
      assert (E1 : l + / 10 ^ 43 + (m + / 10 ^ 43) <= G * (1 + u)) by (rewrite Hu in *; lra).
      split; [exact E1|]. set (p := l + / 10 ^ 43) in *. set (q := m + / 10 ^ 43) in *.
      assert (0 <= (p - q) * (p - q)) by apply Rle_0_sqr.
      assert ((p + q) * (p + q) <= G * (1 + u) * (G * (1 + u))) by (apply Rmult_le_compat; unfold p, q in *; lra). lra.
        }
    destruct (Wide l1 l2 Gi L1 L2 S1 P1 (proj1 HGi)) as [W1 W2].
    destruct (Wide l3 l4 Gj L3 L4 S2 P2 (proj1 HGj)) as [W3 W4].
    assert (Sizes := order_sizes (1 + 16 * u) (l1 + / 10 ^ 43) (l2 + / 10 ^ 43) (l3 + / 10 ^ 43) (l4 + / 10 ^ 43)
      (Gi * (1 + u)) (Gj * (1 + u)) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) W1 W3 W2 W4).
    eapply Rle_trans; [apply Rmult_le_compat; [exact Q0 | | exact Q | exact Sizes]|].
    - apply Rplus_le_le_0_compat; apply Rmult_le_pos; try (apply Rmult_le_pos; lra); apply Rmult_le_pos; lra.
    - replace (Gi * (1 + u) * (Gj * (1 + u)) * (Gi * (1 + u) + Gj * (1 + u))) with (N * ((1 + u) * (1 + u) * (1 + u)))
        by (unfold N; ring). rewrite Hu in *. lra. }
  assert (Final : Rabs (val v - dot (direction_of x) form) <= 3.0004 * u * N)
    by (eapply Rle_trans; [exact Error | exact Error']).
  destruct (sign_of_certain (val v) (((t + 12 * u) * (1 + 16 * u) / 4 + 3.0004 * u) * N) _ scale (dot y form) _ Final)
    as [Up Down]; [lra | exact Ps|].
  assert (Zero : finite (on_doubles x (Cst 0 0)) /\ val (on_doubles x (Cst 0 0)) = 0) by (split; reflexivity).
  destruct Zero as [FZ EZ]. rewrite compare_finite in H by assumption. rewrite EZ in H. cbn [compare_reals] in H.
  revert H. case Rlt_bool_spec; intros Side H.
  - assert (s = Positive) by congruence. subst s. apply Up. rewrite Rabs_pos_eq in Cover by lra. exact Cover.
  - assert (s = Negative) by congruence. subst s. apply Down. rewrite Rabs_left1 in Cover by exact Side. lra.
Qed.
