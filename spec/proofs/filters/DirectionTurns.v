(* The rule of a crossing's error (src/flow/cascades.md): the tangent of the angle between the computed direction Y
   behind a facet and the true one. Y is the image of what was known before, and something more, at most r |Y|. With
   kappa and tau for the determinant and the norm of the map, over the square of |Y| and over |Y|, and
   eta = kappa t + tau t + r <= 1/15, the tangent is at most (kappa t + r) (1 + 5 eta). This is about real numbers. *)
From Coq Require Import Reals Lra Psatz.
From Flocq Require Import Core.
From Flowcert Require Import algebra.Vector3 algebra.Cascade algebra.Crossing filters.Rounding filters.RoundedVectors
  filters.Norms filters.Directions.
Open Scope R_scope.

(* x is |MP| / |Y|. *)
Lemma rule_of_tangents : forall K T r x, 0 <= K -> 0 <= T -> 0 <= r -> K + T + r <= / 15 -> 1 - r <= x <= 1 + r ->
  let eta := K + T + r in
  0 < x * x - x * T - r * (x + T) /\
  K + r * (x + T) <= (K + r) * (1 + 5 * eta) * (x * x - x * T - r * (x + T)).
Proof.
  intros K T r x HK HT Hr H [X1 X2] eta.
  assert (B : 1 - 3 * eta <= x * x - x * T - r * (x + T)).
  { assert (0 <= (x - (1 - r)) * (x + (1 - r) - T - r)) by (apply Rmult_le_pos; lra).
    assert (0 <= r * r) by apply Rle_0_sqr. unfold eta. lra. }
  assert (E : 0 <= eta <= / 15) by (unfold eta; lra).
  split; [lra|].
  assert (C : K + r * (x + T) <= (K + r) * (1 + eta)).
  { assert (r * (x + T) <= r * (1 + eta)) by (apply Rmult_le_compat_l; unfold eta; lra).
    assert (0 <= K * eta) by (apply Rmult_le_pos; lra). lra. }
  eapply Rle_trans; [exact C|]. rewrite Rmult_assoc. apply Rmult_le_compat_l; [lra|].
  apply Rle_trans with ((1 + 5 * eta) * (1 - 3 * eta)); [nra|]. apply Rmult_le_compat_l; lra.
Qed.

Lemma step_linear : forall p0 p1 q k0 k1 s a b,
  step p0 p1 q (vadd (vscale s a) b) k0 k1 = vadd (vscale s (step p0 p1 q a k0 k1)) (step p0 p1 q b k0 k1).
Proof.
  intros p0 p1 q k0 k1 s a b. unfold step, A. generalize (h p0 p1 q) (D p0 p1 k0 k1) (bisector_g p0 p1 q). clear.
  intros. vdestruct. apply vec_eq; unfold dot; cbn; ring.
Qed.
Lemma sqrt_scale : forall c v, 0 <= c -> sqrt (c * dot v v) = sqrt c * len v.
Proof. intros c v C. rewrite sqrt_mult by (auto using dot_self_nonneg). reflexivity. Qed.
Lemma cross_orthogonal_len : forall a b, dot a b = 0 -> len (cross a b) = len a * len b.
Proof.
  intros a b H. unfold len. rewrite <- sqrt_mult by apply dot_self_nonneg. f_equal. rewrite cross_square, H. ring.
Qed.

Theorem tangent_behind : forall p0 p1 q k0 k1 c, polygon p0 p1 q k0 k1 c ->
  let e := vsub p1 p0 in let map x := step p0 p1 q x k0 k1 in
  forall y P t delta kappa tau r, dot y e = 0 -> dot P e = 0 -> tangent_at_most t y P -> 0 <= t ->
  let Y := vadd (map P) delta in let eta := kappa * t + tau * t + r in
  0 < len Y -> 0 <= kappa -> 0 <= tau -> 0 <= r ->
  sqrt (determinant_square p0 p1 q k0 k1 c) * (len P * len P) <= kappa * (len Y * len Y) ->
  sqrt (norm_square p0 p1 q k0 k1 c) * len P <= tau * len Y -> len delta <= r * len Y -> eta <= / 15 ->
  tangent_at_most ((kappa * t + r) * (1 + 5 * eta)) (map y) Y.
Proof.
  intros p0 p1 q k0 k1 c Poly e map y P t delta kappa tau r Ye Pe [Hd Ht] T0 Y eta L0 K0 N0 R0 Det Norm Delta Eta.
  (* y is a multiple of P, and W across it *)
  assert (LP := len_nonneg P). assert (PP : 0 < dot P P).
  { destruct (dot_self_nonneg P) as [H|H]; [exact H|]. exfalso. symmetry in H. apply dot_self_zero in H. rewrite H in
    Hd.
    unfold dot, vzero in Hd. cbn in Hd. lra. }
  assert (LP0 : 0 < len P) by (assert (S := len_sq P); nra).
  set (l := dot P y / dot P P). set (W := vsub y (vscale l P)).
  assert (l0 : 0 < l) by (unfold l; apply Rdiv_lt_0_compat; assumption).
  assert (El : dot P y = l * dot P P) by (unfold l; field; lra).
  assert (Ey : y = vadd (vscale l P) W) by (unfold W; apply vec_eq; cbn; ring).
  assert (OW : dot P W = 0).
  { unfold W. replace (dot P (vsub y (vscale l P))) with (dot P y - l * dot P P)
      by (generalize l; clear; intros; vdestruct; vunfold; ring). lra. }
  assert (We : dot W e = 0).
  { unfold W. replace (dot (vsub y (vscale l P)) e) with (dot y e - l * dot P e)
      by (generalize l e; clear; intros; vdestruct; vunfold; ring). rewrite Ye, Pe. ring. }
  assert (CW : cross P y = cross P W) by (rewrite Ey; generalize l W; clear; intros; vdestruct; apply vec_eq; cbn;
    ring).
  assert (LW : len W <= t * l * len P).
  { rewrite CW, cross_orthogonal_len, El, <- len_sq in Ht by exact OW.
    apply Rmult_le_reg_r with (len P); [exact LP0|]. lra. }
  (* the images *)
  assert (My : map y = vadd (vscale l (map P)) (map W)) by (rewrite Ey at 1; apply step_linear).
  assert (D0 : 0 <= determinant_square p0 p1 q k0 k1 c).
  { destruct (orthogonal_parts _ _ _ _ _ _ Poly) as [_ [_ [_ [_ [A1 [A2 A3]]]]]]. unfold determinant_square.
    assert (Q : forall a b, 0 <= a -> 0 < b -> 0 <= a / b)
      by (intros; apply Rmult_le_pos; [assumption | left; apply Rinv_0_lt_compat; assumption]).
    apply Rmult_le_pos; [apply Rmult_le_pos; [apply Rmult_le_pos; [apply Rmult_le_pos; [lra|]|]|]|];
      [apply Rle_0_sqr | apply Rle_0_sqr | apply Q; lra | apply Q; [apply dot_self_nonneg | exact A3]]. }
  assert (D1 : 0 <= norm_square p0 p1 q k0 k1 c).
  { unfold norm_square. assert (M := Rmax_l (h p0 p1 q * h p0 p1 q) (h k0 k1 c * h k0 k1 c * (dot (area_vector p0 p1 q)
      (area_vector p0 p1 q) / dot (area_vector k0 k1 c) (area_vector k0 k1 c)) * (dot (vsub k1 k0) (vsub k1 k0) / dot
      (vsub p1 p0) (vsub p1 p0)))). assert (S := Rle_0_sqr (h p0 p1 q)). unfold Rsqr in S. lra. }
  assert (Len : len (map W) <= t * l * tau * len Y).
  { assert (B := map_norm _ _ _ _ _ _ Poly W We). apply sqrt_le_1_alt in B. rewrite sqrt_scale in B by exact D1.
    change (sqrt (dot (step p0 p1 q W k0 k1) (step p0 p1 q W k0 k1))) with (len (map W)) in B.
    eapply Rle_trans; [exact B|].
    apply Rle_trans with (sqrt (norm_square p0 p1 q k0 k1 c) * (t * l * len P)).
    - apply Rmult_le_compat_l; [apply sqrt_pos | exact LW].
    - replace (sqrt (norm_square p0 p1 q k0 k1 c) * (t * l * len P)) with (t * l * (sqrt (norm_square p0 p1 q k0 k1 c)
        * len P)) by ring. rewrite !Rmult_assoc. rewrite <- Rmult_assoc. rewrite <- (Rmult_assoc t l).
      apply Rmult_le_compat_l; [apply Rmult_le_pos; lra | exact Norm]. }
  assert (Area : len (cross (map P) (map W)) <= t * l * kappa * (len Y * len Y)).
  { assert (B := map_determinant _ _ _ _ _ _ Poly P W Pe We). apply (f_equal sqrt) in B. rewrite sqrt_scale in B by
    exact
      D0. change (sqrt (dot (cross (step p0 p1 q P k0 k1) (step p0 p1 q W k0 k1)) (cross (step p0 p1 q P k0 k1) (step p0
      p1 q W k0 k1)))) with (len (cross (map P) (map W))) in B. rewrite B, cross_orthogonal_len by exact OW.
    set (d := sqrt (determinant_square p0 p1 q k0 k1 c)) in *. assert (d0 : 0 <= d) by apply sqrt_pos.
    apply Rle_trans with (t * l * (d * (len P * len P))).
    - assert (d * len P * len W <= d * len P * (t * l * len P)) by (apply Rmult_le_compat_l; [apply Rmult_le_pos; lra |
        exact LW]). lra.
    - rewrite (Rmult_assoc (t * l) kappa). apply Rmult_le_compat_l; [apply Rmult_le_pos; lra | exact Det]. }
  (* lengths over |Y| *)
  set (L := len Y) in *. set (m := len (map P)).
  assert (m1 : L <= m + r * L) by (unfold L, Y, m in *; eapply Rle_trans; [apply len_triangle|]; apply
    Rplus_le_compat_l;
    exact Delta).
  assert (m2 : m <= L + r * L).
  { unfold m. replace (map P) with (vadd Y (vscale (-1) delta)) by (unfold Y; apply vec_eq; cbn; ring).
    eapply Rle_trans; [apply len_triangle|]. rewrite len_scale_any. replace (Rabs (-1)) with 1 by (rewrite Rabs_left;
      lra). fold L. lra. }
  set (x := m / L). assert (Ex : m = x * L) by (unfold x; field; lra).
  assert (X : 1 - r <= x <= 1 + r) by (split; apply Rmult_le_reg_r with L; lra).
  set (K := kappa * t) in *. set (T := tau * t) in *.
  assert (K' : 0 <= K) by (apply Rmult_le_pos; lra). assert (T' : 0 <= T) by (apply Rmult_le_pos; lra).
  assert (r1 : r <= / 15) by (unfold eta in Eta; lra).
  destruct (rule_of_tangents K T r x K' T' R0 Eta X) as [Pos Rule]. fold eta in Rule.
  assert (LMy : len (map y) <= l * (x + T) * L).
  { rewrite My. eapply Rle_trans; [apply len_triangle|]. rewrite len_scale by lra. fold m. rewrite Ex. unfold T. lra. }
  (* along *)
  assert (Along : l * (L * L) * (x * x - x * T - r * (x + T)) <= dot Y (map y)).
  { assert (E : dot Y (map y) = l * (m * m) + dot (map P) (map W) + dot delta (map y)).
    { unfold m. rewrite len_sq. unfold Y. rewrite My.
      replace (dot (vadd (map P) delta) (vadd (vscale l (map P)) (map W))) with
        (dot (map P) (vadd (vscale l (map P)) (map W)) + dot delta (vadd (vscale l (map P)) (map W)))
        by (generalize (map P) (map W) l; clear; intros; vdestruct; vunfold; ring).
      f_equal. generalize (map P) (map W) l. clear. intros. vdestruct. vunfold. ring. }
    assert (A1 := dot_len (map P) (map W)). assert (A2 := dot_len delta (map y)). apply Rabs_le_inv in A1, A2. fold m
      in A1.
    assert (A3 : m * len (map W) <= x * L * (l * T * L)).
    { rewrite Ex. apply Rmult_le_compat_l; [apply Rmult_le_pos; lra|]. unfold T. lra. }
    assert (A4 : len delta * len (map y) <= r * L * (l * (x + T) * L)).
    { apply Rmult_le_compat; auto using len_nonneg. }
    rewrite E. rewrite Ex. lra. }
  assert (Across : len (cross Y (map y)) <= l * (L * L) * (K + r * (x + T))).
  { replace (cross Y (map y)) with (vadd (cross (map P) (map W)) (cross delta (map y))).
    - eapply Rle_trans; [apply len_triangle|].
      assert (A4 : len (cross delta (map y)) <= r * L * (l * (x + T) * L)).
      { eapply Rle_trans; [apply cross_len|]. apply Rmult_le_compat; auto using len_nonneg. }
      unfold K. lra.
    - unfold Y. rewrite My. generalize (map P) (map W) l. clear. intros. vdestruct. apply vec_eq; cbn; ring. }
  assert (LL : 0 < l * (L * L)) by (apply Rmult_lt_0_compat; [exact l0 | apply Rmult_lt_0_compat; exact L0]).
  split.
  - eapply Rlt_le_trans; [|exact Along]. apply Rmult_lt_0_compat; assumption.
  - eapply Rle_trans; [exact Across|].
    apply Rle_trans with ((K + r) * (1 + 5 * eta) * (l * (L * L) * (x * x - x * T - r * (x + T)))).
    + replace ((K + r) * (1 + 5 * eta) * (l * (L * L) * (x * x - x * T - r * (x + T)))) with
        (l * (L * L) * ((K + r) * (1 + 5 * eta) * (x * x - x * T - r * (x + T)))) by ring.
      apply Rmult_le_compat_l; [lra | exact Rule].
    + apply Rmult_le_compat_l; [|exact Along]. apply Rmult_le_pos; [lra|]. unfold eta, K, T in *. lra.
Qed.
