(* The filter of a predicate, as sign_beyond_norms() of src/geometry/predicates.h computes it: the norms of some vectors
   between points, a test of their range, the value of a polynomial, a bound of its error made of the norms, and the
   comparison. `filter_right`: whatever the doubles are, also infinities and NaN, an answer is the sign of the exact
   polynomial. A predicate's own file says what its polynomial and its bound are, and compares all of it with the
   generated term. *)
From Coq Require Import Reals ZArith QArith Qreals Lra Lia Psatz Bool List.
From Flocq Require Import Core BinarySingleNaN.
From Flowcert Require Import algebra.Vector3 code.Expression filters.Rounding filters.RoundedVectors filters.Norms
  filters.Floors filters.Doubles filters.Terms.
Import ListNotations.
Open Scope R_scope.

(* ---- A bound that is computed from norms ---- *)

(* How many roundings make it smaller. *)
Fixpoint losses e : nat :=
  match e with
  | Mul a b => losses a + losses b + 1
  | Add a b => Nat.max (losses a) (losses b) + 1
  | _ => 0
  end.
Definition deepest_bound : nat := 299.
(* It is at least 10^-depth, where every variable is at least 10^-43. *)
Fixpoint depth e : option nat :=
  match e with
  | Var _ => Some 43%nat
  | Cst m k =>
    if ((0 <? m) && (0 <=? k))%Z then Some 0%nat
    else if ((0 <? m) && (2 ^ (- k) <=? m * 10 ^ 16))%Z then Some 16%nat else None
  | Mul a b =>
    match depth a, depth b with
    | Some i, Some j => if (i + j + 1 <=? deepest_bound)%nat && (losses a + losses b + 1 <=? 1000)%nat then Some (i +
      j)%nat else None
    | _, _ => None
    end
  | Add a b =>
    match depth a, depth b with
    | Some i, Some j => if (i + 1 <=? deepest_bound)%nat && (losses a + losses b + 1 <=? 1000)%nat then Some i else None
    | _, _ => None
    end
  | _ => None
  end.

Lemma power_near_1 : forall j, (j <= 1000)%nat -> / 10 <= (1 - 2 * u) ^ j <= 1.
Proof.
  intros j Hj. assert (V : 0 < 1 - 2 * u <= 1) by (rewrite u_val; lra). split.
  - apply Rle_trans with (1 + INR j * (- (2 * u))).
    + apply le_INR in Hj. rewrite (INR_IZR_INZ 1000) in Hj. change (IZR (Z.of_nat 1000)) with 1000 in Hj.
      generalize (pos_INR j) u_pos. intros. assert (INR j * u <= 1000 * u) by (apply Rmult_le_compat_r; lra).
      rewrite u_val in *. lra.
    + destruct j as [|j]; [simpl; lra|].
      destruct (Rtotal_order (- (2 * u)) 0) as [L|[E|G]]; [|generalize u_pos; lra | generalize u_pos; lra].
      replace (1 - 2 * u) with (1 + - (2 * u)) by ring.
      (* Bernoulli *)
      clear Hj. assert (B : forall i, 1 + INR i * (- (2 * u)) <= (1 + - (2 * u)) ^ i).
      { induction i as [|i IH]; [simpl; lra|]. rewrite S_INR. simpl.
        apply Rle_trans with ((1 + - (2 * u)) * (1 + INR i * - (2 * u))).
        - generalize (pos_INR i). intro. assert (0 <= INR i * ((2 * u) * (2 * u))) by (apply Rmult_le_pos; nra). lra.
        - apply Rmult_le_compat_l; lra. }
      apply B.
  - induction j as [|j IH]; [simpl; lra|]. simpl.
    assert ((1 - 2 * u) ^ j <= 1) by (apply IH; lia). assert (0 <= (1 - 2 * u) ^ j) by (apply pow_le; lra). nra.
Qed.

Lemma power_split : forall i j, (i + j <= 1000)%nat -> (1 - 2 * u) ^ (i + j) <= (1 - 2 * u) ^ i.
Proof.
  intros i j H. rewrite pow_add. destruct (power_near_1 i ltac:(lia)), (power_near_1 j ltac:(lia)).
  rewrite <- (Rmult_1_r ((1 - 2 * u) ^ i)) at 2. apply Rmult_le_compat_l; lra.
Qed.

Theorem bound_from_below : forall n, (forall k, / 10 ^ 43 <= n k) -> forall e d, depth e = Some d ->
  / 10 ^ d <= exact n e /\ exact n e * (1 - 2 * u) ^ losses e <= rounded n e /\ (losses e <= 1000)%nat.
Proof.
  intros n Hn. unfold exact, rounded.
  assert (T : forall d z, (d + 1 <= deepest_bound)%nat -> / 10 ^ (d + 1) <= z -> tau <= z).
  { intros d z Hd H. eapply Rle_trans; [apply tau_small|]. eapply Rle_trans; [|exact H].
    apply Rinv_le; [apply pow_lt; lra | apply Rle_pow; [lra | unfold deepest_bound in Hd; lia]]. }
  assert (P : forall d, 0 < / 10 ^ d) by (intro; apply Rinv_0_lt_compat, pow_lt; lra).
  assert (Shrunk : forall d z j, / 10 ^ d <= z -> (j <= 1000)%nat -> / 10 ^ (d + 1) <= z * (1 - 2 * u) ^ j).
  { intros d z j Hz Hj. destruct (power_near_1 j Hj). rewrite pow_add. simpl (10 ^ 1). rewrite Rmult_1_r.
    replace (/ (10 ^ d * 10)) with (/ 10 ^ d * / 10) by (field; apply pow_nonzero; lra).
    generalize (P d). intro. apply Rmult_le_compat; lra. }
  induction e; intros d Hd; cbn [depth losses on_reals] in *; try discriminate.
  - injection Hd; intro; subst d. simpl ((1 - 2 * u) ^ 0). generalize (Hn n0). split; [auto | split; [lra | lia]].
  - simpl ((1 - 2 * u) ^ 0). unfold F2R; cbn [Fnum Fexp].
    destruct (Z.ltb_spec 0 m); cbn [andb] in Hd; [|discriminate].
    assert (M : 1 <= IZR m) by (apply IZR_le; lia).
    destruct (Z.leb_spec 0 e) as [K|K].
    { injection Hd; intro; subst d. split; [|split; [lra | lia]]. simpl (10 ^ 0). rewrite Rinv_1.
      assert (1 <= bpow radix2 e) by (apply (bpow_le radix2 0 e); exact K). generalize (Rmult_le_compat 1 _ 1 _
        ltac:(lra) ltac:(lra) M H0). lra. }
    destruct (Z.leb_spec (2 ^ - e) (m * 10 ^ 16)) as [E|E]; [|discriminate].
    injection Hd; intro; subst d. split; [|split; [lra | lia]].
    apply Rmult_le_reg_r with (bpow radix2 (- e)); [apply bpow_gt_0|].
    rewrite Rmult_assoc, <- bpow_plus. replace (e + - e)%Z with 0%Z by lia. change (bpow radix2 0) with 1.
    rewrite Rmult_1_r. rewrite <- (IZR_Zpower radix2) by lia. change (radix_val radix2) with 2%Z.
    apply Rmult_le_reg_l with (10 ^ 16); [apply pow_lt; lra|].
    rewrite <- Rmult_assoc, Rinv_r, Rmult_1_l by (apply pow_nonzero; lra).
    rewrite pow_IZR, <- mult_IZR. apply IZR_le. rewrite Z.mul_comm. exact E.
  - destruct (depth e1) as [i|]; [|discriminate]. destruct (depth e2) as [j|]; [|discriminate].
    destruct (Nat.leb_spec (i + 1) deepest_bound), (Nat.leb_spec (losses e1 + losses e2 + 1) 1000); try discriminate.
    injection Hd; intro; subst d.
    destruct (IHe1 i eq_refl) as [A1 [A2 A3]], (IHe2 j eq_refl) as [B1 [B2 B3]].
    set (x := on_reals (fun r => r) n e1) in *. set (y := on_reals (fun r => r) n e2) in *.
    set (k := Nat.max (losses e1) (losses e2)). assert (K : (k <= 1000)%nat) by (unfold k; lia).
    generalize (P i) (P j). intros Pi Pj. split; [lra|].
    assert (S1 : x * (1 - 2 * u) ^ k <= x * (1 - 2 * u) ^ losses e1).
    { apply Rmult_le_compat_l; [lra|]. unfold k. replace (Nat.max _ _) with (losses e1 + (Nat.max (losses e1) (losses
      e2) - losses e1))%nat by lia.
      apply power_split. lia. }
    assert (S2 : y * (1 - 2 * u) ^ k <= y * (1 - 2 * u) ^ losses e2).
    { apply Rmult_le_compat_l; [lra|]. unfold k. replace (Nat.max _ _) with (losses e2 + (Nat.max (losses e1) (losses
      e2) - losses e2))%nat by lia.
      apply power_split. lia. }
    destruct (power_near_1 k K).
    assert (Y0 : 0 <= y * (1 - 2 * u) ^ k) by (apply Rmult_le_pos; lra).
    split.
    + rewrite pow_add, <- Rmult_assoc. simpl ((1 - 2 * u) ^ 1). rewrite Rmult_1_r.
      apply rnd_lower; [|lra]. apply (T i); [lia|].
      rewrite Rmult_plus_distr_r. generalize (Shrunk i x k A1 K). lra.
    + unfold k. lia.
  - destruct (depth e1) as [i|]; [|discriminate]. destruct (depth e2) as [j|]; [|discriminate].
    destruct (Nat.leb_spec (i + j + 1) deepest_bound), (Nat.leb_spec (losses e1 + losses e2 + 1) 1000); try
      discriminate.
    injection Hd; intro; subst d.
    destruct (IHe1 i eq_refl) as [A1 [A2 A3]], (IHe2 j eq_refl) as [B1 [B2 B3]].
    set (x := on_reals (fun r => r) n e1) in *. set (y := on_reals (fun r => r) n e2) in *.
    generalize (P i) (P j). intros Pi Pj. split; [apply floor_mult; auto|].
    destruct (power_near_1 (losses e1) A3), (power_near_1 (losses e2) B3).
    split.
    + rewrite !pow_add. simpl ((1 - 2 * u) ^ 1). rewrite Rmult_1_r.
      replace (x * y * ((1 - 2 * u) ^ losses e1 * (1 - 2 * u) ^ losses e2 * (1 - 2 * u)))
        with (x * (1 - 2 * u) ^ losses e1 * (y * (1 - 2 * u) ^ losses e2) * (1 - 2 * u)) by ring.
      apply rnd_mult_lower; auto; try (apply Rmult_le_pos; lra).
      apply (T (i + j)%nat); [lia|].
      replace (x * (1 - 2 * u) ^ losses e1 * (y * (1 - 2 * u) ^ losses e2))
        with (x * y * (1 - 2 * u) ^ (losses e1 + losses e2)) by (rewrite pow_add; ring).
      apply Shrunk; [apply floor_mult; auto | lia].
    + lia.
Qed.

(* ---- Homogeneous sizes ---- *)

Fixpoint degree {k} (t : term k) : nat :=
  match t with
  | Given _ => 1
  | Cross a b => degree a + degree b
  | Scale s a => degree s + degree a
  | VPlus a b => degree a
  | Dot a b => degree a + degree b
  | Times s t => degree s + degree t
  | Plus s t | Minus s t => degree s
  | Twice s => degree s
  | Part _ a => degree a
  | Size s => degree s
  end.
Fixpoint is_homogeneous {k} (t : term k) : bool :=
  match t with
  | Given _ => true
  | Cross a b => is_homogeneous a && is_homogeneous b
  | Scale s a => is_homogeneous s && is_homogeneous a
  | VPlus a b => is_homogeneous a && is_homogeneous b && (degree a =? degree b)%nat
  | Dot a b => is_homogeneous a && is_homogeneous b
  | Times s t => is_homogeneous s && is_homogeneous t
  | Plus s t | Minus s t => is_homogeneous s && is_homogeneous t && (degree s =? degree t)%nat
  | Twice s => is_homogeneous s
  | Part _ a => is_homogeneous a
  | Size s => is_homogeneous s
  end.
Lemma size_of_multiple : forall w n k (t : term k), is_homogeneous t = true ->
  size (fun i => n i * w) t = w ^ degree t * size n t.
Proof.
  induction t; cbn [is_homogeneous size degree]; rewrite ?andb_true_iff, ?Nat.eqb_eq; intro H;
    try (simpl; ring); decompose [and] H;
    repeat match goal with IH : is_homogeneous _ = true -> _ |- _ => rewrite IH by assumption end;
    rewrite ?pow_add; try ring.
  - replace (degree t2) with (degree t1) by assumption. ring.
  - replace (degree t2) with (degree t1) by assumption. ring.
  - replace (degree t2) with (degree t1) by assumption. ring.
Qed.

(* ---- Only some variables ---- *)

Fixpoint has_variables_below (count : nat) e : bool :=
  match e with
  | Var n => (n <? count)%nat
  | Cst _ _ | Infinite => true
  | Add a b | Sub a b | Mul a b | Div a b => has_variables_below count a && has_variables_below count b
  | Neg a | Abs a | Root a | Wide a => has_variables_below count a
  | Choose _ a b yes no => has_variables_below count a && has_variables_below count b &&
                           has_variables_below count yes && has_variables_below count no
  end.
Lemma same_below : forall count x y e, has_variables_below count e = true ->
  (forall n, (n < count)%nat -> x n = y n) -> on_doubles x e = on_doubles y e.
Proof.
  intros count x y e H E. induction e; cbn [has_variables_below on_doubles] in *;
    rewrite ?andb_true_iff, ?Nat.ltb_lt in H; auto; decompose [and] H;
    rewrite ?IHe, ?IHe1, ?IHe2, ?IHe3, ?IHe4 by assumption; reflexivity.
Qed.
Lemma reals_same_below : forall round count x y e, has_variables_below count e = true ->
  (forall n, (n < count)%nat -> x n = y n) -> on_reals round x e = on_reals round y e.
Proof.
  intros round count x y e H E. induction e; cbn [has_variables_below on_reals] in *;
    rewrite ?andb_true_iff, ?Nat.ltb_lt in H; auto; decompose [and] H;
    rewrite ?IHe, ?IHe1, ?IHe2, ?IHe3, ?IHe4 by assumption; reflexivity.
Qed.

(* ---- The filter ---- *)

Definition norm k := Root (edot (given k) (given k)).
Fixpoint range_tests small large (norms : list expr) (rest : tree (option sign)) : tree (option sign) :=
  match norms with
  | [] => rest
  | n :: others =>
    If LessEqual small n (If LessEqual n large (range_tests small large others rest) (Answer None)) (Answer None)
  end.
Definition decided value error : tree (option sign) :=
  If Less error value (Answer (Some Positive)) (If Less value (Neg error) (Answer (Some Negative)) (Answer None)).
(* `bound` has the norms for variables. *)
Definition filter small large count value bound :=
  range_tests small large (map norm (seq 0 count)) (decided value (replace norm bound)).

(* Vector k leads from the point fst to the point snd of pair k. *)
Definition ends (pairs : list (nat * nat)) n := nth (n / 3) pairs (0, 0)%nat.
Definition between pairs n : expr :=
  Sub (Var (3 * snd (ends pairs n) + n mod 3)) (Var (3 * fst (ends pairs n) + n mod 3)).
(* Between the points as they are, without rounding. *)
Definition exact_between pairs (x : nat -> double) n : R :=
  val (x (3 * snd (ends pairs n) + n mod 3)%nat) - val (x (3 * fst (ends pairs n) + n mod 3)%nat).

Fixpoint replace_in_tree {A} (s : nat -> expr) (t : tree A) : tree A :=
  match t with
  | Answer a => Answer a
  | If r a b yes no => If r (replace s a) (replace s b) (replace_in_tree s yes) (replace_in_tree s no)
  end.
Lemma run_replace : forall A s x (t : tree A), run x (replace_in_tree s t) = run (fun n => on_doubles x (s n)) t.
Proof. induction t; simpl; rewrite ?on_doubles_replace, ?IHt1, ?IHt2; reflexivity. Qed.

Definition top_of_vectors count n := if (n / 3 <? count)%nat then 143%Z else 5000%Z.
Definition top_of_norms count n := if (n <? count)%nat then 143%Z else 5000%Z.
Definition is_some {A} (o : option A) := match o with Some _ => true | None => false end.
Definition rational (m k : Z) : Q := if (0 <=? k)%Z then inject_Z (m * 2 ^ k) else (m # Z.to_pos (2 ^ - k)).
Definition smallest : Q := (1 # (10 ^ 42)) * (1 - unit).
Definition largest : Q := inject_Z (10 ^ 42) * (1001 # 1000).

Fixpoint power (x : Q) n : Q := match n with O => 1 | S m => x * power x m end.

(* What the proof asks of a predicate's parts. c: the bound is at least c times the size of the value. *)
Definition is_enough count variables (value : term Scalar) bound (c : Q) : bool :=
  is_above_underflow count value && is_homogeneous value && has_variables_below variables bound &&
  is_some (height (top_of_vectors count) (flatten value)) && is_some (height (top_of_norms variables) bound) &&
  is_some (depth bound) && (degree value <=? 100)%nat &&
  Qle_bool (error (fun _ => unit) value * power (1 + 4 * unit) (degree value))
    (c * power (1 - 2 * unit) (losses bound)).
Definition is_range (small large : Z * Z) : bool :=
  let (m, k) := small in let (n, l) := large in
  ((Z.abs m <? 2 ^ 53) && (-1000 <=? k) && (k <=? 0) && (Z.abs n <? 2 ^ 53) && (-1000 <=? l) && (l <=? 900))%Z &&
  Qle_bool smallest (rational m k) && Qle_bool (rational n l) largest.

Lemma power_value : forall x n, Q2R (power x n) = Q2R x ^ n.
Proof. induction n; cbn [power pow]; [unfold Q2R; cbn; lra | rewrite Q2R_mult, IHn; reflexivity]. Qed.
Lemma Q2R_1 : Q2R 1 = 1. Proof. unfold Q2R; cbn; lra. Qed.
Lemma Q2R_integer : forall z, Q2R (inject_Z z) = IZR z.
Proof. intros. unfold Q2R, inject_Z. cbn [Qnum Qden]. rewrite Rinv_1, Rmult_1_r. reflexivity. Qed.
Lemma rational_value : forall m k, Q2R (rational m k) = F2R (Float radix2 m k).
Proof.
  intros. unfold rational, F2R; cbn [Fnum Fexp]. destruct (Z.leb_spec 0 k) as [H|H].
  - rewrite Q2R_integer, mult_IZR, <- (IZR_Zpower radix2) by exact H. reflexivity.
  - unfold Q2R; cbn [Qnum Qden]. f_equal. rewrite <- (Z.opp_involutive k) at 2. rewrite bpow_opp.
    rewrite <- (IZR_Zpower radix2) by lia. change (radix_val radix2) with 2%Z.
    rewrite Z2Pos.id by (apply Z.pow_pos_nonneg; lia). reflexivity.
Qed.

Lemma Q2R_fraction : forall n, (0 < n)%Z -> Q2R (1 # Z.to_pos n) = / IZR n.
Proof. intros. unfold Q2R. cbn [Qnum Qden]. rewrite Z2Pos.id by assumption. ring. Qed.
Lemma smallest_value : Q2R smallest = smallest_norm.
Proof.
  unfold smallest. rewrite Q2R_mult. unfold Qminus. rewrite Q2R_plus, Q2R_opp, unit_u, Q2R_1.
  replace (10 ^ 42)%positive with (Z.to_pos (10 ^ Z.of_nat 42)) by (vm_compute; reflexivity). rewrite Q2R_fraction, <-
    pow_IZR by reflexivity.
  unfold smallest_norm, Rminus. reflexivity.
Qed.
Lemma largest_value : Q2R largest = 10 ^ 42 * 1.001.
Proof.
  unfold largest. rewrite Q2R_mult, Q2R_integer. replace (10 ^ 42)%Z with (10 ^ Z.of_nat 42)%Z by (vm_compute;
    reflexivity). rewrite <- pow_IZR.
  reflexivity.
Qed.
Lemma finite_between : forall a b c : double, finite a -> finite c -> Bleb a b = true -> Bleb b c = true -> finite b.
Proof.
  intros a b c Fa Fc H1 H2. destruct b as [s|s| |s m e Hm]; try reflexivity.
  - destruct s.
    + destruct a as [t|t| |t m e Hm]; try destruct t; discriminate.
    + destruct c as [t|t| |t m e Hm]; try destruct t; discriminate.
  - destruct a as [t|t| |t m e Hm]; try destruct t; discriminate.
Qed.

(* What a norm in range tells of its vector. *)
Lemma in_range_back : forall a small large, is_range small large = true ->
  let value := on_doubles a in let low := value (Cst (fst small) (snd small)) in
  let high := value (Cst (fst large) (snd large)) in
  forall e, compare_doubles LessEqual low (value e) = true -> compare_doubles LessEqual (value e) high = true ->
  finite (value e) /\ smallest_norm <= val (value e) <= 10 ^ 42 * 1.001.
Proof.
  intros a [m k] [n l] H value low high e HL HH. cbn [fst snd] in *. unfold is_range in H.
  rewrite !andb_true_iff, !Z.ltb_lt, !Z.leb_le, !Qle_bool_iff in H. destruct H as [[[[[[[H1 H2] H3] H4] H5] H6] H7] H8].
  assert (Lm := mantissa_bits m H1).
  assert (Ln := mantissa_bits n H4).
  destruct (normal_constant m k (Z.log2 (Z.abs m) + 1 + k) H1 ltac:(lia) ltac:(lia) eq_refl) as [FL VL].
  destruct (normal_constant n l (Z.log2 (Z.abs n) + 1 + l) H4 ltac:(lia) ltac:(lia) eq_refl) as [FH VH].
  change (finite low) in FL. change (finite high) in FH. change (val low = F2R (Float radix2 m k)) in VL.
  change (val high = F2R (Float radix2 n l)) in VH.
  assert (F : finite (value e)).
  { exact (finite_between _ _ _ FL FH HL HH). }
  split; [exact F|]. rewrite compare_finite in HL, HH by auto. cbn [compare_reals] in *.
  generalize (Rle_bool_spec (val low) (val (value e))) (Rle_bool_spec (val (value e)) (val high)).
  rewrite HL, HH. intros I1 I2. inversion I1. inversion I2.
  apply Qle_Rle in H7, H8. rewrite rational_value in H7, H8. rewrite <- VL, smallest_value in H7.
  rewrite <- VH, largest_value in H8. lra.
Qed.

Lemma index_of : forall k i, (i < 3)%nat -> ((3 * k + i) / 3 = k /\ (3 * k + i) mod 3 = i)%nat.
Proof.
  intros k i H. split.
  - rewrite Nat.mul_comm, Nat.div_add_l by discriminate. rewrite Nat.div_small by exact H. lia.
  - rewrite Nat.add_comm, Nat.mul_comm, Nat.mod_add by discriminate. apply Nat.mod_small, H.
Qed.

(* Runs all range tests. *)
Lemma run_range_tests : forall x small large rest s norms, run x (range_tests small large norms rest) = Some s ->
  (forall e, In e norms -> compare_doubles LessEqual (on_doubles x small) (on_doubles x e) = true /\
                           compare_doubles LessEqual (on_doubles x e) (on_doubles x large) = true) /\
  run x rest = Some s.
Proof.
  induction norms as [|e norms IH]; cbn [range_tests run]; intro H; [split; [intros e [] | exact H]|].
  destruct (compare_doubles LessEqual (on_doubles x small) (on_doubles x e)) eqn:A; [|discriminate].
  destruct (compare_doubles LessEqual (on_doubles x e) (on_doubles x large)) eqn:B; [|discriminate].
  destruct (IH H) as [I1 I2]. split; [|exact I2]. intros f [<-|F]; auto.
Qed.

Section Vectors.
Variables (pairs : list (nat * nat)) (y : nat -> double).
Let x n := on_doubles y (between pairs n).
Definition value_of_vector (z : nat -> R) k := V (z (3 * k)%nat) (z (3 * k + 1)%nat) (z (3 * k + 2)%nat).

(* A vector whose norm is finite. *)
Lemma vector_back : forall k, finite (on_doubles x (norm k)) ->
  (forall i, (i < 3)%nat -> finite (x (3 * k + i)%nat)) /\
  exists p q, fmt3 p /\ fmt3 q /\ value_of_vector (fun n => val (x n)) k = rsub p q /\
  value_of_vector (exact_between pairs y) k = vsub p q /\ val (on_doubles x (norm k)) = rlen (rsub p q).
Proof.
  intros k F. unfold norm in *. cbn [on_doubles] in F. destruct (root_back _ F) as [F1 E1].
  cbn [on_doubles edot given tx ty tz] in *.
  destruct (add_back _ _ F1) as [F2 [F3 E2]]. destruct (add_back _ _ F2) as [F4 [F5 E3]].
  destruct (mul_back _ _ F3) as [Fz [_ E4]]. destruct (mul_back _ _ F4) as [Fx [_ E5]].
  destruct (mul_back _ _ F5) as [Fy [_ E6]].
  split. { intros [|[|[|i]]] Hi; [rewrite Nat.add_0_r; exact Fx | exact Fy | exact Fz | lia]. }
  set (f := fst (nth k pairs (0, 0)%nat)). set (t := snd (nth k pairs (0, 0)%nat)).
  assert (X : forall i, (i < 3)%nat -> x (3 * k + i)%nat = Bminus mode_NE (y (3 * t + i)%nat) (y (3 * f + i)%nat)).
  { intros i Hi. unfold x, between, ends. destruct (index_of k i Hi) as [-> ->]. reflexivity. }
  assert (Y : forall i, (i < 3)%nat ->
    exact_between pairs y (3 * k + i) = val (y (3 * t + i)%nat) - val (y (3 * f + i)%nat)).
  { intros i Hi. unfold exact_between, ends. destruct (index_of k i Hi) as [-> ->]. reflexivity. }
  exists (value_of_vector (fun n => val (y n)) t), (value_of_vector (fun n => val (y n)) f).
  assert (S : forall i, (i < 3)%nat -> finite (x (3 * k + i)%nat) ->
    val (x (3 * k + i)%nat) = rnd (val (y (3 * t + i)%nat) - val (y (3 * f + i)%nat))).
  { intros i Hi Fi. rewrite X in * by exact Hi. apply sub_back in Fi. apply Fi. }
  assert (Sx := S 0%nat ltac:(lia)). assert (Yx := Y 0%nat ltac:(lia)). rewrite !Nat.add_0_r in Sx, Yx.
  specialize (Sx Fx). assert (Sy := S 1%nat ltac:(lia) Fy). assert (Sz := S 2%nat ltac:(lia) Fz).
  split. { repeat split; apply fmt_val. } split. { repeat split; apply fmt_val. }
  unfold value_of_vector. split. { unfold rsub; cbn [vx vy vz]. rewrite Sx, Sy, Sz. reflexivity. }
  split. { unfold vsub; cbn [vx vy vz]. rewrite Yx, !Y by lia. reflexivity. }
  unfold rlen, rdot, rsub; cbn [vx vy vz]. rewrite <- Sx, <- Sy, <- Sz. rewrite E1, E2, E3, E4, E5, E6. reflexivity.
Qed.
End Vectors.

Lemma vector_size : forall p q, fmt3 p -> fmt3 q -> smallest_norm <= rlen (rsub p q) <= 10 ^ 42 * 1.001 ->
  let a := rsub p q in
  Rabs (vx a) <= bpow radix2 143 /\ Rabs (vy a) <= bpow radix2 143 /\ Rabs (vz a) <= bpow radix2 143.
Proof.
  intros p q Hp Hq [H1 H2] a. assert (A := napprox_difference p q _ Hp Hq H1 eq_refl). fold a in A.
  apply napprox_len in A. assert (L : len a <= 10 ^ 43).
  { eapply Rle_trans; [exact A|]. fold a in H1, H2. set (r := rlen a) in *.
    replace ((1 + u) * (r * (1 + 4 * u))) with (r * ((1 + u) * (1 + 4 * u))) by ring.
    assert (0 <= r) by (generalize (guarded _ H1); assert (0 < / 10 ^ 43) by (apply Rinv_0_lt_compat, pow_lt; lra);
      lra).
    apply Rle_trans with (10 ^ 42 * 1.001 * 1.001); [|lra]. apply Rmult_le_compat; auto; rewrite u_val; lra. }
  assert (B : 10 ^ 43 <= bpow radix2 143).
  { change (bpow radix2 143) with (IZR (Z.pow_pos 2 143)). rewrite pow_IZR. apply IZR_le. apply Z.leb_le. vm_compute.
    reflexivity. }
  destruct (coordinate_bound _ _ (Rle_trans _ _ _ L B)) as [? [? ?]]. auto.
Qed.

(* Norms of the first `count` vectors that passed the range tests. *)
Definition is_in_range small large x e :=
  compare_doubles LessEqual (on_doubles x (Cst (fst small) (snd small))) (on_doubles x e) = true /\
  compare_doubles LessEqual (on_doubles x e) (on_doubles x (Cst (fst large) (snd large))) = true.
Definition are_in_range small large count x := forall k, (k < count)%nat -> is_in_range small large x (norm k).

Lemma power_of_10 : 10 ^ 43 <= bpow radix2 143.
Proof.
  change (bpow radix2 143) with (IZR (Z.pow_pos 2 143)). rewrite pow_IZR. apply IZR_le. apply Z.leb_le.
  vm_compute. reflexivity.
Qed.

(* What a vector is whose norm passed the range tests. *)
Lemma vectors_in_range : forall count small large, is_range small large = true ->
  forall pairs y, let x n := on_doubles y (between pairs n) in are_in_range small large count x ->
  forall k, (k < count)%nat -> let n := val (on_doubles x (norm k)) in
  napprox (Q2R unit) (n * (1 + 4 * u)) (value_of_vector (fun n => val (x n)) k)
    (value_of_vector (exact_between pairs y) k) /\
  (finite (on_doubles x (norm k)) /\ smallest_norm <= n <= 10 ^ 42 * 1.001) /\
  forall i, (i < 3)%nat -> finite (x (3 * k + i)%nat) /\ Rabs (val (x (3 * k + i)%nat)) <= bpow radix2 143.
Proof.
  intros count small large Range pairs y x Norms k Hk n. destruct (Norms k Hk) as [A B].
  destruct (in_range_back x small large Range (norm k) A B) as [F S]. fold n in S.
  destruct (vector_back pairs y k F) as [Fi [a [b [Fa [Fb [E1 [E2 E3]]]]]]].
  change (value_of_vector (fun n => val (x n)) k = rsub a b) in E1. change (n = rlen (rsub a b)) in E3.
  split; [|split; [split; [exact F | exact S]|]].
  - rewrite E1, E2, E3, unit_u. apply napprox_difference; auto. rewrite <- E3. apply S.
  - rewrite E3 in S. destruct (vector_size a b Fa Fb S) as [S1 [S2 S3]]. rewrite <- E1 in S1, S2, S3.
    unfold value_of_vector in *. cbn [vx vy vz] in *. intros i Hi. split; [apply Fi, Hi|].
    destruct i as [|[|[|i]]]; [rewrite Nat.add_0_r; exact S1 | exact S2 | exact S3 | lia].
Qed.

(* The value is within its bound. The bound is made of the variables z, each of which is a norm or the like. *)
Theorem value_within_bound : forall count variables small large (value : term Scalar) bound c,
  is_enough count variables value bound c = true -> is_range small large = true ->
  forall pairs y z, let x n := on_doubles y (between pairs n) in are_in_range small large count x ->
  (forall k, (k < variables)%nat -> finite (z k) /\ / 10 ^ 43 <= val (z k) <= 10 ^ 43) ->
  (forall n, (forall k, (k < count)%nat -> n k = val (on_doubles x (norm k))) -> (forall k, 0 < n k) ->
    Q2R c * size n value <= exact (fun k => if (k <? variables)%nat then val (z k) else 1) bound) ->
  finite (on_doubles x (flatten value)) /\ finite (on_doubles z bound) /\
  Rabs (val (on_doubles x (flatten value)) - exact (exact_between pairs y) (flatten value)) <= val (on_doubles z bound).
Proof.
  intros count variables small large value bound c Good Range pairs y z x Norms HZ Bound.
  unfold is_enough in Good. rewrite !andb_true_iff, Nat.leb_le, Qle_bool_iff in Good.
  destruct Good as [[[[[[[G1 G2] G3] G4] G5] G6] G7] G8].
  assert (N : forall k, (k < count)%nat -> finite (on_doubles x (norm k)) /\
    smallest_norm <= val (on_doubles x (norm k)) <= 10 ^ 42 * 1.001).
  { intros k Hk. destruct (Norms k Hk) as [A B].
    apply (in_range_back x small large Range (norm k)); [exact A | exact B]. }
  set (n := fun k => if (k <? count)%nat then val (on_doubles x (norm k)) else 1).
  assert (N43 : forall k, / 10 ^ 43 <= n k).
  { intro k. unfold n. destruct (Nat.ltb_spec k count) as [L|L]; [apply guarded, (N k L)|]. lra. }
  assert (P43 : 0 < / 10 ^ 43) by (apply Rinv_0_lt_compat, pow_lt; lra).
  (* the value *)
  assert (VB := vectors_in_range count small large Range pairs y Norms). fold x in VB. cbv zeta in VB.
  assert (VN : forall k, (k < count)%nat -> napprox (Q2R unit) (n k * (1 + 4 * u))
    (value_of_vector (fun n => val (x n)) k) (value_of_vector (exact_between pairs y) k)).
  { intros k Hk. unfold n. destruct (Nat.ltb_spec k count) as [L|L]; [|lia]. apply (VB k L). }
  destruct (height (top_of_vectors count) (flatten value)) as [hv|] eqn:HV; [|discriminate].
  destruct (forward x (top_of_vectors count) (flatten value) hv) as [FV [EV _]]; [|exact HV|].
  { intros j Hj. unfold top_of_vectors in *. destruct (Nat.ltb_spec (j / 3) count) as [L|L]; [|discriminate].
    assert (M : (j mod 3 < 3)%nat) by (apply Nat.mod_upper_bound; discriminate).
    replace j with (3 * (j / 3) + j mod 3)%nat by (symmetry; apply Nat.div_mod; discriminate).
    apply (VB _ L), M. }
  (* the bound *)
  set (w := fun k => if (k <? variables)%nat then z k else binary_normalize 53 1024 eq_refl eq_refl mode_NE 1 0 false).
  set (m := fun k => if (k <? variables)%nat then val (z k) else 1).
  assert (One : finite (binary_normalize 53 1024 eq_refl eq_refl mode_NE 1 0 false) /\
                val (binary_normalize 53 1024 eq_refl eq_refl mode_NE 1 0 false) = 1).
  { destruct (normal_constant 1 0 1 ltac:(lia) ltac:(lia) ltac:(lia) eq_refl) as [F V]. split; [exact F|].
    rewrite V. unfold F2R; simpl. ring. }
  assert (WM : forall k, val (w k) = m k).
  { intro k. unfold w, m. destruct (k <? variables)%nat; [reflexivity | apply One]. }
  assert (M43 : forall k, / 10 ^ 43 <= m k).
  { intro k. unfold m. destruct (Nat.ltb_spec k variables) as [L|L]; [apply (HZ k L)|]. lra. }
  destruct (height (top_of_norms variables) bound) as [hb|] eqn:HB; [|discriminate].
  destruct (forward w (top_of_norms variables) bound hb) as [FB [EB _]]; [|exact HB|].
  { intros k Hk. rewrite WM. unfold top_of_norms, w, m in *. destruct (Nat.ltb_spec k variables) as [L|L];
    [|discriminate].
    destruct (HZ k L) as [F B]. split; [exact F|]. rewrite Rabs_pos_eq by lra. generalize power_of_10. lra. }
  assert (EZ : on_doubles z bound = on_doubles w bound).
  { apply (same_below variables); [exact G3|]. intros k Hk. unfold w. apply Nat.ltb_lt in Hk. rewrite Hk. reflexivity. }
  assert (EB' : val (on_doubles w bound) = rounded m bound).
  { rewrite EB. apply on_reals_same. exact WM. }
  destruct (depth bound) as [d|] eqn:DB; [|discriminate].
  destruct (bound_from_below m M43 bound d DB) as [_ [Low _]].
  assert (W : 1 <= 1 + 4 * u) by (generalize u_pos; lra).
  destruct (errors count (fun k => n k * (1 + 4 * u)) (fun _ => unit) (fun j => val (x j)) (exact_between pairs y))
    with (k := Scalar) (t := value) as [_ Er _ _].
  { intro k. generalize (N43 k). intro. rewrite <- (Rmult_1_r (/ 10 ^ 43)). apply Rmult_le_compat; lra. }
  { exact VN. }
  { exact G1. }
  cbn [on_shape] in Er. fold (rounded (fun j => val (x j)) (flatten value)) in Er. rewrite <- EV in Er.
  rewrite size_of_multiple in Er by exact G2.
  apply Qle_Rle in G8. rewrite !Q2R_mult, !power_value in G8. unfold Qminus in G8.
  rewrite !Q2R_plus, Q2R_opp, !Q2R_mult, Q2R_1, unit_u in G8. change (Q2R 4) with (4 * / 1) in G8.
  change (Q2R 2) with (2 * / 1) in G8. rewrite Rinv_1, !Rmult_1_r in G8. fold (1 - 2 * u) in G8.
  assert (S0 : 0 <= size n value).
  { apply Rle_trans with (/ 10 ^ floor value); [left; apply Rinv_0_lt_compat, pow_lt; lra | apply floor_size; exact
    N43]. }
  split; [exact FV|]. rewrite EZ. split; [exact FB|].
  rewrite EB'. eapply Rle_trans; [exact Er|]. eapply Rle_trans; [|exact Low].
  rewrite <- Rmult_assoc. eapply Rle_trans; [apply Rmult_le_compat_r; [exact S0 | exact G8]|].
  rewrite (Rmult_comm (Q2R c)), Rmult_assoc, Rmult_comm. apply Rmult_le_compat_r.
  - apply pow_le. rewrite u_val. lra.
  - apply Bound.
    + intros k Hk. unfold n. apply Nat.ltb_lt in Hk. rewrite Hk. reflexivity.
    + intro k. generalize (N43 k). lra.
Qed.

Theorem decided_right : forall count small large value bound c,
  is_enough count count value bound c = true -> is_range small large = true ->
  (forall n, (forall k, 0 < n k) -> Q2R c * size n value <= exact n bound) ->
  forall pairs y s, let x n := on_doubles y (between pairs n) in are_in_range small large count x ->
  run x (decided (flatten value) (replace norm bound)) = Some s ->
  is_sign s (exact (exact_between pairs y) (flatten value)).
Proof.
  intros count small large value bound c Good Range Bound pairs y s x Norms H.
  destruct (value_within_bound count count small large value bound c Good Range pairs y
    (fun k => on_doubles x (norm k)) Norms) as [FV [FB Final]].
  { intros k Hk. destruct (Norms k Hk) as [A B].
    destruct (in_range_back x small large Range (norm k) A B) as [F [L T]]. split; [exact F|].
    split; [apply guarded, L|]. lra. }
  { intros n Hn Pn. eapply Rle_trans; [apply Bound, Pn|]. right.
    apply (reals_same_below (fun r => r) count); [unfold is_enough in Good; rewrite !andb_true_iff in Good; apply
      Good|].
    intros k Hk. rewrite (Hn k Hk). apply Nat.ltb_lt in Hk. rewrite Hk. reflexivity. }
  fold x in FV, Final. apply Rabs_le_inv in Final. unfold decided in H. cbn [run on_doubles] in H.
  rewrite on_doubles_replace in H. set (e := on_doubles (fun k => on_doubles x (norm k)) bound) in *.
  change (on_doubles (fun n => on_doubles y (between pairs n)) (flatten value)) with (on_doubles x (flatten value)) in
    *.
  set (v := on_doubles x (flatten value)) in *.
  rewrite !compare_finite in H by (try assumption; unfold finite; rewrite is_finite_Bopp; exact FB).
  cbn [compare_reals] in H. replace (val (Bopp e)) with (- val e) in H by (symmetry; apply B2R_Bopp).
  destruct (Rlt_bool_spec (val e) (val v)) as [L|L].
  - assert (s = Positive) by congruence. subst s. cbn [is_sign]. lra.
  - destruct (Rlt_bool_spec (val v) (- val e)) as [L'|L']; [|discriminate].
    assert (s = Negative) by congruence. subst s. cbn [is_sign]. lra.
Qed.

Theorem filter_right : forall count small large value bound c,
  is_enough count count value bound c = true -> is_range small large = true ->
  (forall n, (forall k, 0 < n k) -> Q2R c * size n value <= exact n bound) ->
  forall pairs y s,
  run y (replace_in_tree (between pairs)
    (filter (Cst (fst small) (snd small)) (Cst (fst large) (snd large)) count (flatten value) bound)) = Some s ->
  is_sign s (exact (exact_between pairs y) (flatten value)).
Proof.
  intros count small large value bound c Good Range Bound pairs y s H. rewrite run_replace in H.
  unfold filter in H. apply run_range_tests in H. destruct H as [Norms H].
  apply (decided_right count small large value bound c Good Range Bound pairs y s); [|exact H].
  intros k Hk. apply Norms, in_map, in_seq. lia.
Qed.
