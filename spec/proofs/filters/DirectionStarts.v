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
  assert (R := rnd_any (sqrt (rdot v v))). rewrite (Rabs_pos_eq (sqrt _)) in R by apply sqrt_pos. apply Rabs_le_inv in R.
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
    { rewrite <- (Rmult_1_l (L * L + 3 * tau)) at 2. apply Rmult_le_compat_r; [assert (0 <= L * L) by apply Rle_0_sqr; lra
      | rewrite Hu; lra]. } lra. }
  assert (Q : sqrt (rdot v v) <= 2 * / 10 ^ 27).
  { rewrite <- (sqrt_Rsqr (2 * / 10 ^ 27)) by lra. apply sqrt_le_1_alt. unfold Rsqr. lra. }
  assert (R := rnd_any (sqrt (rdot v v))). rewrite (Rabs_pos_eq (sqrt _)) in R by apply sqrt_pos. apply Rabs_le_inv in R.
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
  [Code.StartAtVertex.u_x; Code.StartAtVertex.u_y; Code.StartAtVertex.u_z; Code.StartAtVertex.error] =
    map (replace in_start) results /\
  Code.StartAtVertex.is_known =
    If LessEqual low_square (Mul shortest shortest) (If LessEqual (Mul shortest shortest) high_square
      (If LessEqual low_square (Mul longest longest) (If LessEqual (Mul longest longest) high_square
        (replace_in_tree in_start Code.OfVector.is_known)
      (Answer None)) (Answer None)) (Answer None)) (Answer None).
Proof. split; vm_compute; reflexivity. Qed.
