(* From IEEE 754 doubles, with infinities and NaN, to rounded reals.
   Forwards: an expression whose variables are bounded does not overflow, and has the value of the rounded reals.
   Backwards: where a result is finite, so is what it was made of. *)
From Coq Require Import Reals ZArith Lra Psatz Bool Lia.
From Flocq Require Import Core BinarySingleNaN.
From Flowcert Require Import filters.Rounding code.Expression.
Open Scope R_scope.

Definition finite (x : double) := is_finite x = true.
Definition val (x : double) : R := B2R x.

Lemma fmt_val : forall x, fmt (val x).
Proof. intros. apply (generic_format_B2R 53 1024). Qed.

(* ---- Backwards ---- *)

Lemma add_back : forall x y : double, finite (Bplus mode_NE x y) ->
  finite x /\ finite y /\ val (Bplus mode_NE x y) = rnd (val x + val y).
Proof.
  intros x y H. unfold finite, val in *.
  assert (F : is_finite x = true /\ is_finite y = true).
  { destruct x as [sx|sx| |sx mx ex Hx], y as [sy|sy| |sy my ey Hy]; simpl in *; try (split; reflexivity);
      try discriminate. destruct (Bool.eqb sx sy); discriminate. }
  destruct F as [Fx Fy]. generalize (Bplus_correct 53 1024 _ _ mode_NE x y Fx Fy).
  case Rlt_bool.
  - intros [E _]. auto.
  - intros [E _]. exfalso. destruct (Bplus mode_NE x y); simpl in *; try discriminate.
Qed.
Lemma sub_back : forall x y : double, finite (Bminus mode_NE x y) ->
  finite x /\ finite y /\ val (Bminus mode_NE x y) = rnd (val x - val y).
Proof.
  intros x y H. unfold finite, val in *.
  assert (F : is_finite x = true /\ is_finite y = true).
  { destruct x as [sx|sx| |sx mx ex Hx], y as [sy|sy| |sy my ey Hy]; simpl in *; try (split; reflexivity);
      try discriminate. destruct (Bool.eqb sx (negb sy)); discriminate. }
  destruct F as [Fx Fy]. generalize (Bminus_correct 53 1024 _ _ mode_NE x y Fx Fy).
  case Rlt_bool.
  - intros [E _]. auto.
  - intros [E _]. exfalso. destruct (Bminus mode_NE x y); simpl in *; try discriminate.
Qed.
Lemma mul_back : forall x y : double, finite (Bmult mode_NE x y) ->
  finite x /\ finite y /\ val (Bmult mode_NE x y) = rnd (val x * val y).
Proof.
  intros x y H. unfold finite, val in *.
  generalize (Bmult_correct 53 1024 _ _ mode_NE x y).
  case Rlt_bool.
  - intros [E [F _]]. rewrite H in F. symmetry in F. apply andb_true_iff in F. destruct F; auto.
  - intros E. exfalso. destruct (Bmult mode_NE x y); simpl in *; try discriminate.
Qed.
Lemma root_back : forall x : double, finite (Bsqrt mode_NE x) ->
  finite x /\ val (Bsqrt mode_NE x) = rnd (sqrt (val x)).
Proof.
  intros x H. unfold finite, val in *.
  destruct (Bsqrt_correct 53 1024 _ _ mode_NE x) as [E [F _]]. split; auto.
  destruct x; simpl in *; auto; try discriminate. destruct s; discriminate.
Qed.

(* ---- Comparisons ---- *)

Lemma compare_finite : forall r x y, finite x -> finite y -> compare_doubles r x y = compare_reals r (val x) (val y).
Proof. intros [] x y Fx Fy; [apply Bltb_correct | apply Bleb_correct | apply Beqb_correct]; auto. Qed.

(* ---- Forwards ---- *)

Lemma rnd_power : forall x k, (-1074 <= k)%Z -> Rabs x <= bpow radix2 k -> Rabs (rnd x) <= bpow radix2 k.
Proof.
  intros x k Hk H. apply abs_round_le_generic; auto with typeclass_instances.
  apply generic_format_FLT_bpow; [reflexivity | exact Hk].
Qed.
Lemma no_overflow : forall x k, (-1074 <= k <= 1023)%Z -> Rabs x <= bpow radix2 k -> Rabs (rnd x) < bpow radix2 1024.
Proof.
  intros x k Hk H. apply Rle_lt_trans with (bpow radix2 k); [apply rnd_power; [apply Hk | exact H]|].
  apply bpow_lt. lia.
Qed.

(* A power of two that the expression does not exceed, for variables that do not exceed those of `top`. *)
Definition in_doubles k := ((-1074 <=? k) && (k <=? 1023))%Z.
Definition checked k := if in_doubles k then Some k else None.
Fixpoint height (top : nat -> Z) e : option Z :=
  match e with
  | Var n => checked (top n)
  | Cst m k =>
    if ((Z.abs m <? 2 ^ 53) && (-1074 <=? k))%Z then checked (Z.log2 (Z.abs m) + 1 + k)%Z else None
  | Add a b | Sub a b =>
    match height top a, height top b with Some i, Some j => checked (Z.max i j + 1)%Z | _, _ => None end
  | Mul a b => match height top a, height top b with Some i, Some j => checked (i + j)%Z | _, _ => None end
  | Neg a | Abs a | Wide a => height top a
  | Choose _ a b yes no =>
    match height top a, height top b, height top yes, height top no with
    | Some _, Some _, Some i, Some j => checked (Z.max i j) | _, _, _, _ => None
    end
  | _ => None
  end.

Lemma checked_some : forall k i, checked k = Some i -> i = k /\ (-1074 <= k <= 1023)%Z.
Proof.
  unfold checked, in_doubles. intros k i. destruct (Z.leb_spec (-1074) k), (Z.leb_spec k 1023); simpl; try discriminate.
  intro H1. injection H1. intros. split; [congruence | lia].
Qed.

Lemma mantissa_bits : forall m, (Z.abs m < 2 ^ 53)%Z -> (0 <= Z.log2 (Z.abs m) <= 52)%Z.
Proof.
  intros m H. split; [apply Z.log2_nonneg|]. destruct (Z.eq_dec m 0) as [->|N]; [vm_compute; discriminate|].
  assert (Z.log2 (Z.abs m) < 53)%Z by (apply Z.log2_lt_pow2; lia). lia.
Qed.
Lemma constant_value : forall m k, (Z.abs m < 2 ^ 53)%Z -> (-1074 <= k)%Z ->
  Rabs (F2R (Float radix2 m k)) <= bpow radix2 (Z.log2 (Z.abs m) + 1 + k) /\ fmt (F2R (Float radix2 m k)).
Proof.
  intros m k Hm Hk. split.
  - unfold F2R; simpl. rewrite Rabs_mult, (Rabs_pos_eq (bpow radix2 k)) by apply bpow_ge_0.
    rewrite bpow_plus. apply Rmult_le_compat_r; [apply bpow_ge_0|].
    rewrite <- abs_IZR. rewrite <- (IZR_Zpower radix2) by (generalize (Z.log2_nonneg (Z.abs m)); lia). apply IZR_le.
    change (radix_val radix2) with 2%Z.
    destruct (Z.eq_dec m 0) as [->|N]; [vm_compute; discriminate|].
    generalize (Z.log2_spec (Z.abs m)). unfold Z.succ. lia.
  - apply generic_format_FLT. exists (Float radix2 m k); simpl; auto.
Qed.

Lemma normal_constant : forall m k i, (Z.abs m < 2 ^ 53)%Z -> (-1074 <= k)%Z ->
  (-1074 <= i <= 1023)%Z -> i = (Z.log2 (Z.abs m) + 1 + k)%Z ->
  let c := binary_normalize 53 1024 eq_refl eq_refl mode_NE m k false in finite c /\ val c = F2R (Float radix2 m k).
Proof.
  intros m k i Hm Hk Hi E c. destruct (constant_value m k Hm Hk) as [B F].
  generalize (binary_normalize_correct 53 1024 eq_refl eq_refl mode_NE m k false). fold c. cbv zeta.
  assert (Ef : SpecFloat.fexp 53 1024 = FLT_exp (-1074) 53) by reflexivity.
  rewrite Ef. change (round_mode mode_NE) with ZnearestE.
  rewrite (round_generic radix2 (FLT_exp (-1074) 53) ZnearestE _ F).
  rewrite Rlt_bool_true.
  - intros [V [G _]]. split; [exact G | exact V].
  - eapply Rle_lt_trans; [exact B|]. apply bpow_lt. lia.
Qed.

Theorem forward : forall x top e k,
  (forall n, in_doubles (top n) = true -> finite (x n) /\ Rabs (val (x n)) <= bpow radix2 (top n)) -> height top e =
    Some k ->
  finite (on_doubles x e) /\ val (on_doubles x e) = rounded (fun n => val (x n)) e /\
  Rabs (rounded (fun n => val (x n)) e) <= bpow radix2 k /\ (-1074 <= k <= 1023)%Z.
Proof.
  intros x top e k Hx. revert k. unfold rounded.
  assert (Op : forall z k, (-1074 <= k <= 1023)%Z -> Rabs z <= bpow radix2 k ->
    Rlt_bool (Rabs (rnd z)) (bpow radix2 1024) = true /\ Rabs (rnd z) <= bpow radix2 k).
  { intros z k Hk H. split; [apply Rlt_bool_true; eapply no_overflow; eauto | apply rnd_power; [apply Hk | exact H]]. }
  assert (Twice : forall i j, bpow radix2 i + bpow radix2 j <= bpow radix2 (Z.max i j + 1)).
  { intros. rewrite bpow_plus. change (bpow radix2 1) with 2.
    assert (bpow radix2 i <= bpow radix2 (Z.max i j)) by (apply bpow_le; lia).
    assert (bpow radix2 j <= bpow radix2 (Z.max i j)) by (apply bpow_le; lia). lra. }
  induction e; intros k Hk; cbn [height on_doubles on_reals] in *; try discriminate.
  - assert (D : in_doubles (top n) = true) by (unfold checked in Hk; destruct in_doubles; [reflexivity | discriminate]).
    apply checked_some in Hk. destruct Hk as [-> R]. destruct (Hx n D). auto.
  - destruct (Z.ltb_spec (Z.abs m) (2 ^ 53)), (Z.leb_spec (-1074) e); cbn [andb] in Hk; try discriminate.
    apply checked_some in Hk. destruct Hk as [-> R].
    destruct (normal_constant m e _ H H0 R eq_refl) as [F V]. destruct (constant_value m e H H0) as [B _].
    split; [exact F|]. split; [exact V|]. split; [exact B | exact R].
  - destruct (height top e1) as [i|]; [|discriminate]. destruct (height top e2) as [j|]; [|discriminate].
    apply checked_some in Hk. destruct Hk as [-> R].
    destruct (IHe1 i eq_refl) as [F1 [V1 [B1 _]]], (IHe2 j eq_refl) as [F2 [V2 [B2 _]]].
    rewrite <- V1, <- V2 in *. generalize (Twice i j). intro T.
    assert (B : Rabs (val (on_doubles x e1) + val (on_doubles x e2)) <= bpow radix2 (Z.max i j + 1))
      by (eapply Rle_trans; [apply Rabs_triang | lra]).
    destruct (Op _ _ R B) as [O1 O2].
    generalize (Bplus_correct 53 1024 _ _ mode_NE _ _ F1 F2).
    change (round radix2 (SpecFloat.fexp 53 1024) (round_mode mode_NE)) with rnd. unfold val in *. rewrite O1.
    intros [V [F _]]. auto.
  - destruct (height top e1) as [i|]; [|discriminate]. destruct (height top e2) as [j|]; [|discriminate].
    apply checked_some in Hk. destruct Hk as [-> R].
    destruct (IHe1 i eq_refl) as [F1 [V1 [B1 _]]], (IHe2 j eq_refl) as [F2 [V2 [B2 _]]].
    rewrite <- V1, <- V2 in *. generalize (Twice i j). intro T.
    assert (B : Rabs (val (on_doubles x e1) - val (on_doubles x e2)) <= bpow radix2 (Z.max i j + 1)).
    { unfold Rminus. eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_Ropp. lra. }
    destruct (Op _ _ R B) as [O1 O2].
    generalize (Bminus_correct 53 1024 _ _ mode_NE _ _ F1 F2).
    change (round radix2 (SpecFloat.fexp 53 1024) (round_mode mode_NE)) with rnd. unfold val in *. rewrite O1.
    intros [V [F _]]. auto.
  - destruct (height top e1) as [i|]; [|discriminate]. destruct (height top e2) as [j|]; [|discriminate].
    apply checked_some in Hk. destruct Hk as [-> R].
    destruct (IHe1 i eq_refl) as [F1 [V1 [B1 _]]], (IHe2 j eq_refl) as [F2 [V2 [B2 _]]].
    rewrite <- V1, <- V2 in *.
    assert (B : Rabs (val (on_doubles x e1) * val (on_doubles x e2)) <= bpow radix2 (i + j)).
    { rewrite Rabs_mult, bpow_plus. apply Rmult_le_compat; auto using Rabs_pos. }
    destruct (Op _ _ R B) as [O1 O2].
    generalize (Bmult_correct 53 1024 _ _ mode_NE (on_doubles x e1) (on_doubles x e2)).
    change (round radix2 (SpecFloat.fexp 53 1024) (round_mode mode_NE)) with rnd. unfold val in *. rewrite O1.
    intros [V [F _]]. split; [|auto]. unfold finite in *. rewrite F, F1, F2. reflexivity.
  - destruct (IHe k Hk) as [F [V [B R]]]. unfold finite, val in *.
    rewrite is_finite_Bopp, B2R_Bopp, V, Rabs_Ropp. auto.
  - destruct (IHe k Hk) as [F [V [B R]]]. unfold finite, val in *.
    rewrite is_finite_Babs, B2R_Babs, V, Rabs_Rabsolu. auto.
  - apply IHe; auto.
  - destruct (height top e1) as [i1|]; [|discriminate]. destruct (height top e2) as [i2|]; [|discriminate].
    destruct (height top e3) as [i|]; [|discriminate]. destruct (height top e4) as [j|]; [|discriminate].
    apply checked_some in Hk. destruct Hk as [-> R].
    destruct (IHe1 i1 eq_refl) as [F1 [V1 _]], (IHe2 i2 eq_refl) as [F2 [V2 _]].
    destruct (IHe3 i eq_refl) as [F3 [V3 [B3 _]]], (IHe4 j eq_refl) as [F4 [V4 [B4 _]]].
    rewrite compare_finite, V1, V2 by auto.
    assert (bpow radix2 i <= bpow radix2 (Z.max i j)) by (apply bpow_le; lia).
    assert (bpow radix2 j <= bpow radix2 (Z.max i j)) by (apply bpow_le; lia).
    destruct compare_reals; (split; [assumption|]; split; [assumption|]; split; [lra | assumption]).
Qed.
