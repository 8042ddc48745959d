(* `vertex_right`: where start_at_vertex() of src/flow/kernels/direction.h says that a direction is known, it is, on
   doubles. The true direction is that from the middle of the facet's edge to the centre of the sphere. *)
From Coq Require Import Reals ZArith QArith Qreals Lra Lia Psatz Bool List.
From Flocq Require Import Core BinarySingleNaN.
From Flowcert Require Import algebra.Vector3 algebra.Tetrahedron code.Expression code.generated.Constants
  filters.Rounding filters.RoundedVectors filters.Norms filters.Floors filters.Doubles filters.Terms filters.Filter
  filters.Directions filters.DirectionSigns filters.DirectionVectors filters.DirectionOfVector filters.DirectionStarts.
From Flowcert Require filters.Cells.
Import ListNotations.
Open Scope R_scope.

(* The vector that the code makes, without rounding: 2 det times the way from the middle of p0p1 to the centre. *)
Definition way_to_vertex p0 p1 v0 v1 v2 v3 :=
  let a := vsub v1 v0 in let b := vsub v2 v0 in let c := vsub v3 v0 in
  vadd (numerator a b c) (vscale (det a b c) (vadd (vsub v0 p0) (vsub v0 p1))).

Definition from_middle p0 p1 v0 v1 v2 v3 :=
  vsub (vadd v0 (centre (vsub v1 v0) (vsub v2 v0) (vsub v3 v0))) (midpoint p0 p1).
Lemma way_is_to_centre : forall p0 p1 v0 v1 v2 v3, det (vsub v1 v0) (vsub v2 v0) (vsub v3 v0) <> 0 ->
  way_to_vertex p0 p1 v0 v1 v2 v3 =
  vscale (2 * det (vsub v1 v0) (vsub v2 v0) (vsub v3 v0)) (from_middle p0 p1 v0 v1 v2 v3).
Proof.
  intros p0 p1 v0 v1 v2 v3 D. unfold way_to_vertex, from_middle, centre, midpoint.
  generalize dependent (det (vsub v1 v0) (vsub v2 v0) (vsub v3 v0)).
  generalize (numerator (vsub v1 v0) (vsub v2 v0) (vsub v3 v0)). intros n D N.
  apply vec_eq; cbn; field; exact N.
Qed.
(* The centre is as far from both ends of an edge of its own cell. *)
Lemma way_is_in_facet : forall p0 p1 v0 v1 v2 v3, let c := vadd v0 (centre (vsub v1 v0) (vsub v2 v0) (vsub v3 v0)) in
  det (vsub v1 v0) (vsub v2 v0) (vsub v3 v0) <> 0 -> dist2 c p0 = dist2 c p1 ->
  dot (way_to_vertex p0 p1 v0 v1 v2 v3) (vsub p1 p0) = 0.
Proof.
  intros p0 p1 v0 v1 v2 v3 c D H. rewrite way_is_to_centre by exact D. unfold from_middle. fold c.
  assert (E : forall k, dot (vscale k (vsub c (midpoint p0 p1))) (vsub p1 p0) = k * (dist2 c p0 - dist2 c p1) / 2).
  { generalize c. clear. intros. vdestruct. vunfold. field. }
  rewrite E, H. field.
Qed.

Lemma start_in_other_order : forall a b c t,
  vadd (vadd (vadd (vscale (dot a a) (cross b c)) (vscale (dot b b) (cross c a))) (vscale (dot c c) (cross a b))) t =
  vadd (numerator a b c) t.
Proof. intros. unfold numerator. apply vec_eq; cbn; ring. Qed.

Section Vertex.
Variable x : nat -> double.
Let w n := on_doubles x (vertex_inputs n).
Let z n := on_doubles x (in_start n).
Let d k := value_of_vector (exact_between vertex_pairs x) k.
Let v k := value_of_vector (fun n => val (w n)) k.
Let n k := val (on_doubles w (norm k)).

Lemma norms_of_bound : finite (z 6%nat) ->
  (forall k, (k < 5)%nat -> finite (on_doubles w (norm k))) /\
  val (z 6%nat) = rnd (rnd (val (on_doubles x (in_roundoffs kVertexStartBound)) * rnd (rnd (n 0%nat * n 1%nat) * n
    2%nat))
    * rnd (rnd (rnd (rnd (n 0%nat + n 1%nat) + n 2%nat) + n 3%nat) + n 4%nat)).
Proof.
  intro F. unfold z, in_start in F |- *. rewrite on_doubles_replace in F |- *. fold w in F |- *.
  change (fun n => on_doubles x (vertex_inputs n)) with w in F |- *.
  rewrite on_doubles_replace in F |- *.
  destruct (backward (fun k => on_doubles w (norm k)) start_bound eq_refl F) as [V H]. split.
  - intros k Hk. apply H. destruct k as [|[|[|[|[|k]]]]]; try reflexivity. lia.
  - rewrite V. unfold rounded, start_bound. cbn [on_reals].
    rewrite (constant_on_reals kVertexStartBound _ x) by reflexivity. reflexivity.
Qed.

(* A vector whose norm is finite. *)
Lemma vector_of_norm : forall k, finite (on_doubles w (norm k)) -> fmt3 (v k) /\ vapprox 1 (v k) (d k) /\
  n k = rlength (v k) /\ len (d k) * (1 - 3.7 * u) - / 10 ^ 99 <= n k /\ 0 <= n k /\
  (/ 10 ^ 26 <= n k -> / 10 ^ 28 <= len (d k)).
Proof.
  intros k F. destruct (vector_back vertex_pairs x k F) as [_ [p [q [Fp [Fq [E1 [E2 E3]]]]]]].
  change (value_of_vector (fun n0 => val (on_doubles x (between vertex_pairs n0))) k) with (v k) in E1.
  change (value_of_vector (exact_between vertex_pairs x) k) with (d k) in E2. change (n k = rlen (rsub p q)) in E3.
  assert (A : vapprox 1 (v k) (d k)) by (rewrite E1, E2; apply vapprox_difference; assumption).
  assert (Fv : fmt3 (v k)) by (rewrite E1; repeat split; apply fmt_rnd).
  assert (En : n k = rlength (v k)) by (rewrite E1; exact E3).
  generalize u_pos u_val (len_nonneg (d k)) (len_nonneg (v k)). intros U0 Hu D0 V0.
  assert (N := vapprox_len _ _ A).
  assert (B1 := len_from (d k) (v k)). rewrite len_sub_sym in B1.
  assert (B2 := len_from (v k) (d k)).
  split; [exact Fv|]. split; [exact A|]. split; [exact En|].
  assert (L := rlength_lower (v k) Fv). rewrite <- En in L.
  assert (P99 : / 10 ^ 100 <= / 10 ^ 99) by (apply Rinv_le; [apply pow_lt; lra | apply Rle_pow; [lra | lia]]).
  split; [|split].
  - assert (len (d k) * (1 - u) * (1 - 2.6 * u) <= len (v k) * (1 - 2.6 * u)) by (apply Rmult_le_compat_r; rewrite ?Hu
    in
      *; lra). rewrite Hu in *. lra.
  - rewrite En. unfold rlength, rnd. apply round_ge_generic; auto with typeclass_instances; [apply generic_format_0 |
      apply sqrt_pos].
  - intro H. rewrite En in H. assert (Lv := long_if_rlength (v k) Fv H). rewrite Hu in *. lra.
Qed.

(* A chosen norm is no longer than the others. *)
Lemma shortest_below : (forall k, (k < 5)%nat -> finite (on_doubles w (norm k))) ->
  finite (on_doubles x shortest) /\ forall k, (k < 3)%nat -> val (on_doubles x shortest) <= n k.
Proof.
  intro F. unfold shortest. rewrite on_doubles_replace. change (fun n => on_doubles x (vertex_inputs n)) with w.
  assert (Least : forall a b, finite (on_doubles w a) -> finite (on_doubles w b) -> finite (on_doubles w (least a b)) /\
    val (on_doubles w (least a b)) <= val (on_doubles w a) /\ val (on_doubles w (least a b)) <= val (on_doubles w b)).
  { intros a b Fa Fb. unfold least. cbn [on_doubles]. rewrite compare_finite by assumption. cbn [compare_reals].
    case Rlt_bool_spec; intro; (split; [assumption | split; lra]). }
  destruct (Least (norm 0) (norm 1) (F 0%nat ltac:(lia)) (F 1%nat ltac:(lia))) as [F1 [A1 A2]].
  destruct (Least (least (norm 0) (norm 1)) (norm 2) F1 (F 2%nat ltac:(lia))) as [F2 [B1 B2]].
  split; [exact F2|]. intros [|[|[|k]]] Hk; unfold n; [lra | lra | lra | lia].
Qed.

Lemma vector_of_start : (forall i, (i < 3)%nat -> finite (z i)) ->
  value_of_vector (fun m => val (z m)) 0 = on_shape rnd (fun m => val (w m)) (flatten start_vector).
Proof.
  intro F. assert (B : forall i e, z i = on_doubles w e -> (i < 3)%nat -> is_polynomial e = true ->
    val (z i) = rounded (fun m => val (w m)) e).
  { intros i e E Hi P. rewrite E. apply (backward w e P). rewrite <- E. apply F, Hi. }
  assert (E : forall e, on_doubles x (replace vertex_inputs e) = on_doubles w e) by (intro; apply on_doubles_replace).
  unfold value_of_vector. cbn [Nat.mul Nat.add on_shape].
  rewrite (B 0%nat (tx (flatten start_vector)) (E _) ltac:(lia) eq_refl).
  rewrite (B 1%nat (ty (flatten start_vector)) (E _) ltac:(lia) eq_refl).
  rewrite (B 2%nat (tz (flatten start_vector)) (E _) ltac:(lia) eq_refl). reflexivity.
Qed.

Theorem vertex_start_is_good :
  let p k := point x k in let e := vsub (p 1%nat) (p 0%nat) in
  let y := way_to_vertex (p 0%nat) (p 1%nat) (p 2%nat) (p 3%nat) (p 4%nat) (p 5%nat) in
  dot y e = 0 ->
  compare_doubles LessEqual (on_doubles x low_square) (on_doubles x (Mul shortest shortest)) = true ->
  compare_doubles LessEqual (on_doubles x (Mul shortest shortest)) (on_doubles x high_square) = true ->
  good_start e y z.
Proof.
  intros p e y Ye HL HH. generalize u_pos u_val. intros U0 Hu. split; [exact Ye | | |].
  - intro F. apply vapprox_len. assert (S : forall i, (i < 3)%nat -> approx 1 (Rabs (val (x (3 + i)%nat) - val (x i)))
      (val (z (3 + i)%nat)) (val (x (3 + i)%nat) - val (x i))).
    { intros i Hi. assert (E : z (3 + i)%nat = Bminus mode_NE (x (3 + i)%nat) (x i)).
      { destruct i as [|[|[|i]]]; try reflexivity. lia. }
      assert (Fi := F i Hi). rewrite E in Fi |- *. destruct (sub_back _ _ Fi) as [_ [_ V]]. rewrite V.
      apply approx_difference; apply fmt_val. }
    exact (conj (S 0%nat ltac:(lia)) (conj (S 1%nat ltac:(lia)) (S 2%nat ltac:(lia)))).
  - unfold z, in_start. rewrite !on_doubles_replace. apply Cells.positive_not_negative; [|reflexivity].
    intro k. apply norm_not_negative.
  - intros Fb Fy. destruct (norms_of_bound Fb) as [Fn Eb].
    destruct (shortest_below Fn) as [Fs Below].
    destruct (square_range_back x (Mul shortest shortest) (conj HL HH)) as [Fq Rq]. cbn [on_doubles] in Fq, Rq.
    destruct (mul_back _ _ Fq) as [_ [_ Eq]]. set (s := val (on_doubles x shortest)) in *.
    assert (V : forall k, (k < 5)%nat -> fmt3 (v k) /\ vapprox 1 (v k) (d k) /\ n k = rlength (v k) /\
      len (d k) * (1 - 3.7 * u) - / 10 ^ 99 <= n k /\ 0 <= n k /\ (/ 10 ^ 26 <= n k -> / 10 ^ 28 <= len (d k)))
      by (intros k Hk; apply vector_of_norm, Fn, Hk).
    assert (P26 : 0 < / 10 ^ 26) by (apply Rinv_0_lt_compat, pow_lt; lra).
    assert (P28 : 0 < / 10 ^ 28) by (apply Rinv_0_lt_compat, pow_lt; lra).
    assert (s26 : / 10 ^ 26 <= s).
    { assert (s0 : 0 <= s).
      { assert (s = n 0%nat \/ s = n 1%nat \/ s = n 2%nat) as [->|[->| ->]]; try apply V; try lia.
        unfold s, shortest. rewrite on_doubles_replace. change (fun m => on_doubles x (vertex_inputs m)) with w.
        unfold least. cbn [on_doubles]. unfold n. destruct (compare_doubles Less (on_doubles w (norm 2)) _); [auto|].
        destruct (compare_doubles Less (on_doubles w (norm 1)) _); auto. }
      apply Rnot_lt_le. intro N. assert (ss : s * s <= / 10 ^ 26 * / 10 ^ 26) by (apply Rmult_le_compat; lra).
      assert (R := rnd_any (s * s)). rewrite (Rabs_pos_eq (s * s)) in R by apply Rle_0_sqr. apply Rabs_le_inv in R.
      assert (T : u * tau <= / 10 ^ 60).
      { apply Rle_trans with (1 * / 10 ^ 60); [|lra]. apply Rmult_le_compat; [lra | left; apply tau_pos | rewrite Hu;
        lra
          |]. eapply Rle_trans; [apply tau_small|]. apply Rinv_le; [apply pow_lt; lra | apply Rle_pow; [lra | lia]]. }
      rewrite Eq in Rq. rewrite Hu in *. lra. }
    assert (D28 : forall k, (k < 3)%nat -> / 10 ^ 28 <= len (d k)).
    { intros k Hk. apply V; [lia|]. eapply Rle_trans; [exact s26 | apply Below, Hk]. }
    destruct (header_constant kVertexStartBound vertex_needs 1000 eq_refl x) as [Fc Hc].
    replace (Q2R vertex_needs) with 21.5 in Hc by (unfold Q2R; cbn; lra).
    replace (Q2R 1000) with 1000 in Hc by (unfold Q2R; cbn; lra).
    set (c := val (on_doubles x (in_roundoffs kVertexStartBound))) in *.
    destruct (start_covers c (n 0%nat) (n 1%nat) (n 2%nat) (n 3%nat) (n 4%nat) (len (d 0%nat)) (len (d 1%nat)) (len (d
      2%nat)) (len (d 3%nat)) (len (d 4%nat)) Hc (D28 0%nat ltac:(lia)) (D28 1%nat ltac:(lia)) (D28 2%nat ltac:(lia))
      (len_nonneg _) (len_nonneg _) (fmt_val _) (fmt_val _) (fmt_val _) (fmt_val _) (fmt_val _)) as [Cover Large];
      try (apply V; lia).
    rewrite <- Eb in Cover.
    set (T := len (d 0%nat) * len (d 1%nat) * len (d 2%nat) * (len (d 0%nat) + len (d 1%nat) + len (d 2%nat) + len (d
      3%nat) + len (d 4%nat))) in *.
    (* the vector *)
    set (m k := len (d k) + / 10 ^ 43). assert (P43 : 0 < / 10 ^ 43) by (apply Rinv_0_lt_compat, pow_lt; lra).
    assert (Er := errors 5 m (fun _ => unit) (fun k => val (w k)) (exact_between vertex_pairs x)
      ltac:(intro k; unfold m; generalize (len_nonneg (d k)); lra)).
    specialize (Er ltac:(intros k Hk; cbv beta; rewrite unit_u; change (napprox u (m k) (v k) (d k)); split;
      [ apply (V k Hk) | eapply Rle_trans; [apply vapprox_len, (V k Hk)|]; unfold m; apply Rmult_le_compat_l; lra
      | unfold m; lra | lra ]) Vector start_vector eq_refl).
    cbn [approximates] in Er. destruct Er as [_ Error Size _]. rewrite <- (vector_of_start Fy) in Error.
    set (Y := value_of_vector (fun k => val (z k)) 0) in *.
    assert (Exact : on_shape (fun r => r) (exact_between vertex_pairs x) (flatten start_vector) = y).
    { change (on_shape (fun r => r) (exact_between vertex_pairs x) (flatten start_vector)) with
        (vadd (vadd (vadd (vscale (dot (d 0%nat) (d 0%nat)) (cross (d 1%nat) (d 2%nat)))
                          (vscale (dot (d 1%nat) (d 1%nat)) (cross (d 2%nat) (d 0%nat))))
                    (vscale (dot (d 2%nat) (d 2%nat)) (cross (d 0%nat) (d 1%nat))))
              (vscale (dot (d 0%nat) (cross (d 1%nat) (d 2%nat))) (vadd (d 3%nat) (d 4%nat)))).
      change y with (vadd (numerator (d 0%nat) (d 1%nat) (d 2%nat))
        (vscale (dot (d 0%nat) (cross (d 1%nat) (d 2%nat))) (vadd (d 3%nat) (d 4%nat)))).
      apply start_in_other_order. }
    rewrite Exact in Error, Size.
    assert (Sizes : size m start_vector <= T * (1 + 50 * u)).
    { cbn [size start_vector].
      assert (Near : forall k, (k < 3)%nat -> m k <= len (d k) * (1 + 9.1 * u)).
      { intros k Hk. assert (A := D28 k Hk). unfold m. assert (/ 10 ^ 43 <= 9.1 * u * / 10 ^ 28) by (rewrite Hu; lra).
        assert (9.1 * u * / 10 ^ 28 <= 9.1 * u * len (d k)) by (apply Rmult_le_compat_l; lra). lra. }
      assert (N0 := Near 0%nat ltac:(lia)). assert (N1 := Near 1%nat ltac:(lia)). assert (N2 := Near 2%nat ltac:(lia)).
      assert (M : forall k, 0 <= m k) by (intro k; unfold m; generalize (len_nonneg (d k)); lra).
      assert (Sum : m 0%nat + m 1%nat + m 2%nat + m 3%nat + m 4%nat <= (len (d 0%nat) + len (d 1%nat) + len (d 2%nat) +
        len (d 3%nat) + len (d 4%nat)) * (1 + 20 * u)).
      { assert (A0 := D28 0%nat ltac:(lia)). assert (A1 := D28 1%nat ltac:(lia)). assert (A2 := D28 2%nat ltac:(lia)).
        assert (A3 := len_nonneg (d 3%nat)). assert (A4 := len_nonneg (d 4%nat)). unfold m.
        assert (5 * / 10 ^ 43 <= 20 * u * (3 * / 10 ^ 28)) by (rewrite Hu; lra).
        assert (20 * u * (3 * / 10 ^ 28) <= 20 * u * (len (d 0%nat) + len (d 1%nat) + len (d 2%nat) + len (d 3%nat) +
          len (d 4%nat))) by (apply Rmult_le_compat_l; lra). lra. }
      assert (Product : m 0%nat * m 1%nat * m 2%nat <= len (d 0%nat) * (1 + 9.1 * u) * (len (d 1%nat) * (1 + 9.1 * u)) *
        (len (d 2%nat) * (1 + 9.1 * u))).
      { apply Rmult_le_compat; [apply Rmult_le_pos; apply M | apply M | apply Rmult_le_compat; auto | exact N2]. }
      replace (m 0%nat * m 0%nat * (m 1%nat * m 2%nat) + m 1%nat * m 1%nat * (m 2%nat * m 0%nat) + m 2%nat * m 2%nat *
        (m
        0%nat * m 1%nat) + m 0%nat * (m 1%nat * m 2%nat) * (m 3%nat + m 4%nat)) with
        (m 0%nat * m 1%nat * m 2%nat * (m 0%nat + m 1%nat + m 2%nat + m 3%nat + m 4%nat)) by ring.
      eapply Rle_trans; [apply Rmult_le_compat; [| |exact Product | exact Sum]|].
      - apply Rmult_le_pos; [apply Rmult_le_pos; apply M | apply M].
      - generalize (M 0%nat) (M 1%nat) (M 2%nat) (M 3%nat) (M 4%nat). lra.
      - replace (len (d 0%nat) * (1 + 9.1 * u) * (len (d 1%nat) * (1 + 9.1 * u)) * (len (d 2%nat) * (1 + 9.1 * u)) *
        ((len
          (d 0%nat) + len (d 1%nat) + len (d 2%nat) + len (d 3%nat) + len (d 4%nat)) * (1 + 20 * u))) with
          (T * ((1 + 9.1 * u) * (1 + 9.1 * u) * (1 + 9.1 * u) * (1 + 20 * u))) by (unfold T; ring).
        apply Rmult_le_compat_l; [assert (0 < / 10 ^ 112) by (apply Rinv_0_lt_compat, pow_lt; lra); lra | rewrite Hu;
          lra].
      }
    assert (P112 : 0 < / 10 ^ 112) by (apply Rinv_0_lt_compat, pow_lt; lra).
    destruct (error_below (error (fun _ => unit) start_vector) (1345 # 100)) as [Q0 Q]; [vm_compute; reflexivity|].
    replace (Q2R (1345 # 100)) with 13.45 in Q by (unfold Q2R; cbn; lra).
    set (S := size m start_vector) in *.
    assert (S0 : 0 <= S) by (eapply Rle_trans; [apply (len_nonneg y) | exact Size]).
    assert (Error' : len (vsub Y y) <= 13.45 * u * (T * (1 + 50 * u))).
    { eapply Rle_trans; [exact Error|]. apply Rmult_le_compat; assumption. }
    assert (LY : len Y <= T * (1 + 70 * u)).
    { eapply Rle_trans; [apply (len_from Y y)|]. rewrite Hu in *. lra. }
    assert (Low : 21.49 * u * T <= val (z 6%nat)).
    { eapply Rle_trans; [|exact Cover].
      assert (21.5 * u * (T * (1 - 30 * u)) <= c * (T * (1 - 30 * u))) by (apply Rmult_le_compat_r; [apply
        Rmult_le_pos; rewrite ?Hu; lra | lra]). rewrite Hu in *. lra. }
    assert (uL : 8 * u * len Y <= 8 * u * (T * (1 + 70 * u))) by (apply Rmult_le_compat_l; lra).
    assert (uL2 : 20 * u * len Y <= 20 * u * (T * (1 + 70 * u))) by (apply Rmult_le_compat_l; lra).
    split; [|split].
    + rewrite Hu in *. lra.
    + rewrite Hu in *. lra.
    + eapply Rle_trans; [|exact Low]. apply Rle_trans with (21.49 * u * / 10 ^ 112); [|apply Rmult_le_compat_l; lra].
      rewrite Hu. lra.
Qed.
End Vertex.

(* p0p1 is the facet's edge, and v0 v1 v2 v3 the cell. way_is_in_facet tells where y is in the facet's plane. *)
Theorem vertex_right : forall x,
  let p k := point x k in let e := vsub (p 1%nat) (p 0%nat) in
  let y := way_to_vertex (p 0%nat) (p 1%nat) (p 2%nat) (p 3%nat) (p 4%nat) (p 5%nat) in
  dot y e = 0 -> run x Code.StartAtVertex.is_known = Some Positive ->
  (forall t, In t [Code.StartAtVertex.u_x; Code.StartAtVertex.u_y; Code.StartAtVertex.u_z; Code.StartAtVertex.error] ->
    finite (on_doubles x t)) /\
  known e y (V (val (on_doubles x Code.StartAtVertex.u_x)) (val (on_doubles x Code.StartAtVertex.u_y))
    (val (on_doubles x Code.StartAtVertex.u_z))) (val (on_doubles x Code.StartAtVertex.error)).
Proof.
  intros x p e y Ye H. destruct vertex_match as [T1 [T2 [T3 [T4 Known]]]]. rewrite Known in H. cbn [run] in H.
  lazymatch type of H with (if ?test then _ else _) = _ => destruct test eqn:HL; [|discriminate] end.
  lazymatch type of H with (if ?test then _ else _) = _ => destruct test eqn:HH; [|discriminate] end.
  do 2 lazymatch type of H with (if ?test then _ else _) = _ => destruct test; [|discriminate] end.
  rewrite run_replace in H.
  destruct (of_vector_right e y _ (vertex_start_is_good x Ye HL HH) H) as [F K].
  rewrite <- !on_doubles_replace in K. rewrite T1, T2, T3, T4. split; [|exact K].
  intros t [<-|[<-|[<-|[<-|[]]]]]; rewrite on_doubles_replace; apply F; cbn; tauto.
Qed.
