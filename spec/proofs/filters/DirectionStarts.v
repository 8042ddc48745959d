(* The start of a direction at a Voronoi vertex, start_at_vertex() of src/flow/kernels/direction.h, on doubles: where it
   says that a direction is known, that is known of the vector from the middle of the facet's edge to the vertex. *)
From Coq Require Import Reals ZArith QArith Qreals Lra Lia Psatz Bool List.
From Flocq Require Import Core BinarySingleNaN.
From Flowcert Require Import algebra.Vector3 algebra.Tetrahedron code.Expression code.generated.Constants
  filters.Rounding filters.RoundedVectors filters.Norms filters.Floors filters.Doubles filters.Terms filters.Filter
  filters.Directions filters.DirectionSigns filters.DirectionVectors filters.DirectionOfVector.
From Flowcert Require filters.Cells.
Import ListNotations.
Open Scope R_scope.

(* ---- Backwards through polynomials ---- *)

Fixpoint is_polynomial e : bool :=
  match e with
  | Var _ => true
  | Cst m k => ((Z.abs m <? 2 ^ 53) && (-1000 <=? k) && (k <=? 900))%Z
  | Add a b | Sub a b | Mul a b => is_polynomial a && is_polynomial b
  | _ => false
  end.
Fixpoint has_variable n e : bool :=
  match e with
  | Var m => (m =? n)%nat
  | Add a b | Sub a b | Mul a b => has_variable n a || has_variable n b
  | _ => false
  end.
Theorem backward : forall x e, is_polynomial e = true -> finite (on_doubles x e) ->
  val (on_doubles x e) = rounded (fun n => val (x n)) e /\ (forall n, has_variable n e = true -> finite (x n)).
Proof.
  intros x e. unfold rounded. induction e; cbn [is_polynomial on_doubles on_reals has_variable]; intros P F;
    try discriminate.
  - split; [reflexivity|]. intros k Hk. apply Nat.eqb_eq in Hk. subst k. exact F.
  - rewrite !andb_true_iff, Z.ltb_lt, !Z.leb_le in P. destruct P as [[P1 P2] P3]. assert (L := mantissa_bits m P1).
    destruct (normal_constant m e (Z.log2 (Z.abs m) + 1 + e) P1 ltac:(lia) ltac:(lia) eq_refl) as [_ V].
    split; [exact V|]. intros k Hk. discriminate.
  - rewrite andb_true_iff in P. destruct P as [P1 P2]. destruct (add_back _ _ F) as [F1 [F2 V]].
    destruct (IHe1 P1 F1) as [V1 H1]. destruct (IHe2 P2 F2) as [V2 H2]. rewrite V, V1, V2. split; [reflexivity|].
    intros k Hk. rewrite orb_true_iff in Hk. destruct Hk; auto.
  - rewrite andb_true_iff in P. destruct P as [P1 P2]. destruct (sub_back _ _ F) as [F1 [F2 V]].
    destruct (IHe1 P1 F1) as [V1 H1]. destruct (IHe2 P2 F2) as [V2 H2]. rewrite V, V1, V2. split; [reflexivity|].
    intros k Hk. rewrite orb_true_iff in Hk. destruct Hk; auto.
  - rewrite andb_true_iff in P. destruct P as [P1 P2]. destruct (mul_back _ _ F) as [F1 [F2 V]].
    destruct (IHe1 P1 F1) as [V1 H1]. destruct (IHe2 P2 F2) as [V2 H2]. rewrite V, V1, V2. split; [reflexivity|].
    intros k Hk. rewrite orb_true_iff in Hk. destruct Hk; auto.
Qed.

(* ---- Norms ---- *)

Lemma square_not_negative : forall x, not_negative (Bmult mode_NE x x).
Proof.
  intro x. destruct (is_nan x) eqn:N.
  - left. destruct x; try discriminate. reflexivity.
  - right. apply (Cells.square_nonnegative x N).
Qed.
Lemma root_not_negative : forall x, not_negative x -> not_negative (Bsqrt mode_NE x).
Proof.
  intros x H. destruct (is_nan x) eqn:N.
  - left. destruct x; try discriminate. reflexivity.
  - right. destruct H as [H|H]; [congruence|]. apply (Cells.root_nonnegative x (conj N H)).
Qed.
Lemma norm_not_negative : forall x k, not_negative (on_doubles x (norm k)).
Proof.
  intros x k. unfold norm. cbn [on_doubles edot given tx ty tz]. apply root_not_negative.
  apply Cells.add_not_negative; [apply Cells.add_not_negative|]; apply square_not_negative.
Qed.

Lemma rlength_lower : forall v, fmt3 v -> len v * (1 - 2.6 * u) - / 10 ^ 100 <= rlength v.
Proof.
  intros v F. generalize u_pos u_val tau_pos tau_small (len_nonneg v). intros U0 Hu T0 Tau L0.
  assert (P100 : 0 < / 10 ^ 100) by (apply Rinv_0_lt_compat, pow_lt; lra).
  assert (S0 : 0 <= rlength v).
  { unfold rlength, rnd. apply round_ge_generic; auto with typeclass_instances; [apply generic_format_0 | apply
    sqrt_pos]. }
  destruct (Rle_or_lt (len v) (/ 10 ^ 100)) as [Small|Large].
  { assert (len v * (1 - 2.6 * u) <= len v * 1) by (apply Rmult_le_compat_l; [exact L0 | rewrite Hu; lra]). lra. }
  set (L := len v) in *. assert (LL : / 10 ^ 100 * / 10 ^ 100 <= L * L) by (apply Rmult_le_compat; lra).
  assert (T1 : tau <= / 10 ^ 50 * (L * L)).
  { eapply Rle_trans; [exact Tau|]. apply Rle_trans with (/ 10 ^ 50 * (/ 10 ^ 100 * / 10 ^ 100)); [|apply
      Rmult_le_compat_l; [left; apply Rinv_0_lt_compat, pow_lt; lra | exact LL]].
    rewrite <- !Rinv_mult, <- !pow_add. apply Rinv_le; [apply pow_lt; lra | apply Rle_pow; [lra | lia]]. }
  assert (T2 : tau <= / 10 ^ 50 * L).
  { eapply Rle_trans; [exact Tau|]. apply Rle_trans with (/ 10 ^ 50 * / 10 ^ 100); [|apply Rmult_le_compat_l; [left;
      apply Rinv_0_lt_compat, pow_lt; lra | lra]].
    rewrite <- !Rinv_mult, <- !pow_add. apply Rinv_le; [apply pow_lt; lra | apply Rle_pow; [lra | lia]]. }
  assert (D := rdot_rounding v v F F). rewrite <- len_sq in D. fold L in D. apply Rabs_le_inv in D.
  assert (Y : L * L * (1 - 3.0003 * u) <= rdot v v).
  { assert (0 < L * L) by (apply Rmult_lt_0_compat; lra). rewrite Hu in *. lra. }
  assert (Q : L * (1 - 1.51 * u) <= sqrt (rdot v v)).
  { rewrite <- (sqrt_Rsqr (L * (1 - 1.51 * u))) by (apply Rmult_le_pos; rewrite ?Hu; lra). apply sqrt_le_1_alt.
    unfold Rsqr. eapply Rle_trans; [|exact Y]. replace (L * (1 - 1.51 * u) * (L * (1 - 1.51 * u))) with (L * L * ((1 -
      1.51 * u) * (1 - 1.51 * u))) by ring. apply Rmult_le_compat_l; [apply Rle_0_sqr | rewrite Hu; lra]. }
  assert (R := rnd_any (sqrt (rdot v v))). rewrite (Rabs_pos_eq (sqrt _)) in R by apply sqrt_pos. apply Rabs_le_inv in
    R.
  fold (rlength v) in R.
  assert (L * (1 - 1.51 * u) * (1 - u) <= sqrt (rdot v v) * (1 - u)) by (apply Rmult_le_compat_r; [rewrite Hu; lra |
    exact Q]).
  assert (u * tau <= u * (/ 10 ^ 50 * L)) by (apply Rmult_le_compat_l; lra). rewrite Hu in *. lra.
Qed.
Lemma long_if_rlength : forall v, fmt3 v -> / 10 ^ 26 <= rlength v -> / 10 ^ 27 <= len v.
Proof.
  intros v F H. generalize u_pos u_val tau_pos tau_small (len_nonneg v). intros U0 Hu T0 Tau L0.
  apply Rnot_lt_le. intro N. set (L := len v) in *.
  assert (P27 : 0 < / 10 ^ 27) by (apply Rinv_0_lt_compat, pow_lt; lra).
  assert (LL : L * L <= / 10 ^ 27 * / 10 ^ 27) by (apply Rmult_le_compat; lra).
  assert (T : tau <= / 10 ^ 60).
  { eapply Rle_trans; [exact Tau|]. apply Rinv_le; [apply pow_lt; lra | apply Rle_pow; [lra | lia]]. }
  assert (D := rdot_rounding v v F F). rewrite <- len_sq in D. fold L in D. apply Rabs_le_inv in D.
  assert (Y : rdot v v <= 4 * (/ 10 ^ 27 * / 10 ^ 27)).
  { assert (3.0001 * u * (L * L + 3 * tau) <= L * L + 3 * tau).
    { rewrite <- (Rmult_1_l (L * L + 3 * tau)) at 2. apply Rmult_le_compat_r; [assert (0 <= L * L) by apply Rle_0_sqr;
      lra
      | rewrite Hu; lra]. } lra. }
  assert (Q : sqrt (rdot v v) <= 2 * / 10 ^ 27).
  { rewrite <- (sqrt_Rsqr (2 * / 10 ^ 27)) by lra. apply sqrt_le_1_alt. unfold Rsqr. lra. }
  assert (R := rnd_any (sqrt (rdot v v))). rewrite (Rabs_pos_eq (sqrt _)) in R by apply sqrt_pos. apply Rabs_le_inv in
    R.
  fold (rlength v) in R. rewrite Hu in *. lra.
Qed.

(* ---- The vertex ---- *)

(* a, b, c from vertex 0 of the cell, and vertex 0 from both ends of the edge. *)
Definition vertex_pairs := [(2, 3); (2, 4); (2, 5); (0, 2); (1, 2)]%nat.
Definition start_vector : term Vector :=
  let a := Given 0 in let b := Given 1 in let c := Given 2 in
  VPlus (VPlus (VPlus (Scale (Dot a a) (Cross b c)) (Scale (Dot b b) (Cross c a))) (Scale (Dot c c) (Cross a b)))
        (Scale (Dot a (Cross b c)) (VPlus (Given 3) (Given 4))).
Definition start_bound :=
  Mul (Mul (in_roundoffs kVertexStartBound) (Mul (Mul (Var 0) (Var 1)) (Var 2)))
      (Add (Add (Add (Add (Var 0) (Var 1)) (Var 2)) (Var 3)) (Var 4)).
Definition vertex_inputs := between vertex_pairs.
Definition in_start n :=
  match n with
  | 0%nat => replace vertex_inputs (tx (flatten start_vector))
  | 1%nat => replace vertex_inputs (ty (flatten start_vector))
  | 2%nat => replace vertex_inputs (tz (flatten start_vector))
  | 3%nat | 4%nat | 5%nat => between [(0, 1)]%nat (n - 3)
  | _ => replace vertex_inputs (replace norm start_bound)
  end.
Definition least a b := Choose Less b a b a.
Definition most a b := Choose Less a b b a.
Definition shortest := replace vertex_inputs (least (least (norm 0) (norm 1)) (norm 2)).
Definition longest := replace vertex_inputs (most (most (norm 0) (norm 1)) (norm 2)).
Lemma vertex_match :
  Code.StartAtVertex.u_x = replace in_start Code.OfVector.u_x /\
  Code.StartAtVertex.u_y = replace in_start Code.OfVector.u_y /\
  Code.StartAtVertex.u_z = replace in_start Code.OfVector.u_z /\
  Code.StartAtVertex.error = replace in_start Code.OfVector.error /\
  Code.StartAtVertex.is_known =
    If LessEqual low_square (Mul shortest shortest) (If LessEqual (Mul shortest shortest) high_square
      (If LessEqual low_square (Mul longest longest) (If LessEqual (Mul longest longest) high_square
        (replace_in_tree in_start Code.OfVector.is_known)
      (Answer None)) (Answer None)) (Answer None)) (Answer None).
Proof. repeat split; vm_compute; reflexivity. Qed.

Definition vertex_needs : Q := 215 # 10.

Lemma start_covers : forall c n0 n1 n2 n3 n4 l0 l1 l2 l3 l4,
  21.5 * u <= c <= 1000 * u -> / 10 ^ 28 <= l0 -> / 10 ^ 28 <= l1 -> / 10 ^ 28 <= l2 -> 0 <= l3 -> 0 <= l4 ->
  fmt n0 -> fmt n1 -> fmt n2 -> fmt n3 -> fmt n4 -> 0 <= n3 -> 0 <= n4 ->
  l0 * (1 - 3.7 * u) - / 10 ^ 99 <= n0 -> l1 * (1 - 3.7 * u) - / 10 ^ 99 <= n1 -> l2 * (1 - 3.7 * u) - / 10 ^ 99 <= n2
    ->
  l3 * (1 - 3.7 * u) - / 10 ^ 99 <= n3 -> l4 * (1 - 3.7 * u) - / 10 ^ 99 <= n4 ->
  let T := l0 * l1 * l2 * (l0 + l1 + l2 + l3 + l4) in
  c * T * (1 - 30 * u) <= rnd (rnd (c * rnd (rnd (n0 * n1) * n2)) * rnd (rnd (rnd (rnd (n0 + n1) + n2) + n3) + n4)) /\
  / 10 ^ 112 <= T.
Proof.
  intros c n0 n1 n2 n3 n4 l0 l1 l2 l3 l4 Hc L0 L1 L2 L3 L4 F0 F1 F2 F3 F4 N3 N4 H0 H1 H2 H3 H4 T.
  generalize u_pos u_val tau_small. intros U0 Hu Tau.
  assert (P : forall k, 0 < / 10 ^ k) by (intro; apply Rinv_0_lt_compat, pow_lt; lra).
  assert (P28 := P 28%nat). assert (P99 := P 99%nat).
  set (w := 1 - 3.71 * u). assert (W : / 2 <= w <= 1) by (unfold w; rewrite Hu; lra).
  assert (H0' : l0 * w <= n0) by (unfold w; rewrite Hu in *; lra).
  assert (H1' : l1 * w <= n1) by (unfold w; rewrite Hu in *; lra).
  assert (H2' : l2 * w <= n2) by (unfold w; rewrite Hu in *; lra).
  assert (M : forall l, / 10 ^ 28 <= l -> / 10 ^ 29 <= l * w).
  { intros l H. apply Rle_trans with (/ 10 ^ 28 * / 2); [lra|]. apply Rmult_le_compat; lra. }
  assert (M0 := M l0 L0). assert (M1 := M l1 L1). assert (M2 := M l2 L2). assert (P29 := P 29%nat).
  set (q := 1 - 2 * u). assert (Q : / 2 <= q <= 1) by (unfold q; rewrite Hu; lra).
  assert (Tq : forall k z, (k <= 290)%nat -> / 10 ^ k <= z -> tau <= z).
  { intros k z A B. eapply Rle_trans; [exact Tau|]. eapply Rle_trans; [|exact B]. apply Rinv_le; [apply pow_lt; lra |
      apply Rle_pow; [lra | lia]]. }
  assert (Half : forall k z v, / 10 ^ k <= z -> / 2 <= v -> / 10 ^ (k + 1) <= z * v).
  { intros k z v A B. rewrite pow_add. simpl (10 ^ 1). rewrite Rmult_1_r, Rinv_mult. generalize (P k). intro.
    apply Rmult_le_compat; lra. }
  (* the product *)
  assert (A1 : l0 * w * (l1 * w) <= n0 * n1) by (apply Rmult_le_compat; lra).
  assert (G1 := floor_mult _ _ _ _ M0 M1). cbn [Nat.add] in G1.
  assert (A1' := rnd_lower _ _ (Tq 58%nat _ ltac:(lia) G1) A1). fold q in A1'.
  assert (G1' := Half 58%nat _ q G1 (proj1 Q)). cbn [Nat.add] in G1'. assert (P59 := P 59%nat).
  assert (A2 : l0 * w * (l1 * w) * q * (l2 * w) <= rnd (n0 * n1) * n2) by (apply Rmult_le_compat; lra).
  assert (G2 := floor_mult _ _ _ _ G1' M2). cbn [Nat.add] in G2.
  assert (A2' := rnd_lower _ _ (Tq 88%nat _ ltac:(lia) G2) A2). fold q in A2'.
  assert (G2' := Half 88%nat _ q G2 (proj1 Q)). cbn [Nat.add] in G2'. assert (P89 := P 89%nat).
  assert (C0 : / 10 ^ 15 <= c) by (rewrite Hu in *; lra). assert (P15 := P 15%nat).
  assert (A3 : c * (l0 * w * (l1 * w) * q * (l2 * w) * q) <= c * rnd (rnd (n0 * n1) * n2))
    by (apply Rmult_le_compat_l; lra).
  assert (G3 := floor_mult _ _ _ _ C0 G2'). cbn [Nat.add] in G3.
  assert (A3' := rnd_lower _ _ (Tq 104%nat _ ltac:(lia) G3) A3). fold q in A3'.
  assert (G3' := Half 104%nat _ q G3 (proj1 Q)). cbn [Nat.add] in G3'. assert (P105 := P 105%nat).
  (* the sum *)
  set (Z := l0 + l1 + l2 + l3 + l4). assert (Z0 : / 10 ^ 28 <= Z) by (unfold Z; lra).
  assert (Add1 : forall a b, fmt a -> fmt b -> 0 <= a -> 0 <= b -> (a + b) * (1 - u) <= rnd (a + b) /\ 0 <= rnd (a +
    b)).
  { intros a b Fa Fb Pa Pb. assert (R := rnd_plus a b Fa Fb). rewrite (Rabs_pos_eq (a + b)) in R by lra.
    apply Rabs_le_inv in R. assert (0 <= (a + b) * (1 - u)) by (apply Rmult_le_pos; rewrite ?Hu; lra). lra. }
  destruct (Add1 n0 n1 F0 F1 ltac:(lra) ltac:(lra)) as [S1 S1p]. set (s1 := rnd (n0 + n1)) in *.
  destruct (Add1 s1 n2 (fmt_rnd _) F2 S1p ltac:(lra)) as [S2 S2p]. set (s2 := rnd (s1 + n2)) in *.
  destruct (Add1 s2 n3 (fmt_rnd _) F3 S2p N3) as [S3 S3p]. set (s3 := rnd (s2 + n3)) in *.
  destruct (Add1 s3 n4 (fmt_rnd _) F4 S3p N4) as [S4 S4p]. set (s4 := rnd (s3 + n4)) in *.
  assert (Sum : Z * (1 - 7.8 * u) <= s4).
  { assert (n012 : n0 + n1 + n2 + n3 + n4 >= Z * w).
    { unfold Z, w. assert (5 * / 10 ^ 99 <= 0.01 * u * (/ 10 ^ 28)) by (rewrite Hu; lra).
      assert (0 <= u * l3) by (apply Rmult_le_pos; lra). assert (0 <= u * l4) by (apply Rmult_le_pos; lra).
      assert (0.01 * u * / 10 ^ 28 <= 0.01 * u * l0) by (apply Rmult_le_compat_l; lra).
      assert (0 <= u * l1) by (apply Rmult_le_pos; lra). assert (0 <= u * l2) by (apply Rmult_le_pos; lra). lra. }
    assert (Chain : (n0 + n1 + n2 + n3 + n4) * (1 - 4 * u) <= s4).
    { set (m := 1 - u) in *. assert (m0 : 0 < m <= 1) by (unfold m; rewrite Hu; lra).
      assert (B1 : (n0 + n1) * m * m <= s1 * m) by (apply Rmult_le_compat_r; lra).
      assert (B2 : ((n0 + n1) * m + n2) * m <= (s1 + n2) * m) by (apply Rmult_le_compat_r; lra).
      assert (B3 : (((n0 + n1) * m + n2) * m + n3) * m <= (s2 + n3) * m) by (apply Rmult_le_compat_r; lra).
      assert (B4 : ((((n0 + n1) * m + n2) * m + n3) * m + n4) * m <= (s3 + n4) * m) by (apply Rmult_le_compat_r; lra).
      eapply Rle_trans; [|eapply Rle_trans; [exact B4 | exact S4]].
      assert (m4 : 1 - 4 * u <= m * m * m * m) by (unfold m; rewrite Hu; lra).
      assert (m3 : m * m * m * m <= m * m * m).
      { rewrite <- (Rmult_1_r (m * m * m)) at 2. apply Rmult_le_compat_l; [|lra]. apply Rmult_le_pos; [apply
        Rmult_le_pos;
          lra | lra]. }
      assert (m2 : m * m * m <= m * m) by (rewrite <- (Rmult_1_r (m * m)) at 2; apply Rmult_le_compat_l; [apply
        Rmult_le_pos; lra | lra]).
      assert (m1 : m * m <= m) by (rewrite <- (Rmult_1_r m) at 3; apply Rmult_le_compat_l; lra).
      replace (((((n0 + n1) * m + n2) * m + n3) * m + n4) * m) with ((n0 + n1) * (m * m * m * m) + n2 * (m * m * m) + n3
        * (m * m) + n4 * m) by ring.
      assert (E1 : (n0 + n1) * (1 - 4 * u) <= (n0 + n1) * (m * m * m * m)) by (apply Rmult_le_compat_l; lra).
      assert (E2 : n2 * (1 - 4 * u) <= n2 * (m * m * m)) by (apply Rmult_le_compat_l; lra).
      assert (E3 : n3 * (1 - 4 * u) <= n3 * (m * m)) by (apply Rmult_le_compat_l; lra).
      assert (E4 : n4 * (1 - 4 * u) <= n4 * m) by (apply Rmult_le_compat_l; lra). lra. }
    eapply Rle_trans; [|exact Chain].
    assert (Z * w * (1 - 4 * u) <= (n0 + n1 + n2 + n3 + n4) * (1 - 4 * u)) by (apply Rmult_le_compat_r; [rewrite Hu;
      lra |
      lra]).
    assert (Z * (1 - 7.8 * u) <= Z * (w * (1 - 4 * u))) by (apply Rmult_le_compat_l; [lra | unfold w; rewrite Hu; lra]).
    lra. }
  set (v := 1 - 7.8 * u) in *. assert (V : / 2 <= v <= 1) by (unfold v; rewrite Hu; lra).
  assert (G4 := Half 28%nat _ v Z0 (proj1 V)). cbn [Nat.add] in G4.
  assert (A4 : c * (l0 * w * (l1 * w) * q * (l2 * w) * q) * q * (Z * v) <= rnd (c * rnd (rnd (n0 * n1) * n2)) * s4)
    by (apply Rmult_le_compat; lra).
  assert (G5 := floor_mult _ _ _ _ G3' G4). cbn [Nat.add] in G5.
  assert (A5 := rnd_lower _ _ (Tq 134%nat _ ltac:(lia) G5) A4). fold q in A5.
  assert (LL : / 10 ^ 84 <= l0 * l1 * l2).
  { replace (/ 10 ^ 84) with (/ 10 ^ 28 * / 10 ^ 28 * / 10 ^ 28) by (rewrite <- !Rinv_mult, <- !pow_add; reflexivity).
    apply Rmult_le_compat; [apply Rmult_le_pos; lra | lra | apply Rmult_le_compat; lra | lra]. }
  assert (P84 := P 84%nat).
  assert (TT : / 10 ^ 112 <= T).
  { unfold T. fold Z. replace (/ 10 ^ 112) with (/ 10 ^ 84 * / 10 ^ 28) by (rewrite <- Rinv_mult, <- pow_add;
      reflexivity). apply Rmult_le_compat; lra. }
  split; [|exact TT]. eapply Rle_trans; [|exact A5].
  replace (c * (l0 * w * (l1 * w) * q * (l2 * w) * q) * q * (Z * v) * q) with (c * T * (w * w * w * (q * q * q * q) *
    v))
    by (unfold T, Z; ring).
  apply Rmult_le_compat_l; [apply Rmult_le_pos; [lra|]; assert (0 < / 10 ^ 112) by apply P; lra|].
  unfold w, q, v. rewrite Hu. lra.
Qed.
