(* What direction_of_vector() of src/flow/kernels/direction.h makes of a vector Y: its part in a facet's plane,
  shortened
   to 1. `of_vector_right`: if Y is within the bound of a true direction, and something is known, then it is true. *)
From Coq Require Import Reals ZArith QArith Qreals Lra Lia Psatz Bool List.
From Flocq Require Import Core BinarySingleNaN.
From Flowcert Require Import algebra.Vector3 algebra.Crossing code.Expression code.generated.Constants filters.Rounding
  filters.RoundedVectors filters.Norms filters.Floors filters.Doubles filters.Terms filters.Filter filters.Directions.
Open Scope R_scope.

(* ---- Roundings of vectors ---- *)

Lemma rscale_rounding : forall s a, len (vsub (rscale s a) (vscale s a)) <= u * (Rabs s * len a) + 2 * (u * tau).
Proof.
  intros s a. generalize u_pos tau_pos. intros U0 T0. assert (UT : 0 < u * tau) by (apply Rmult_lt_0_compat; lra).
  apply Rle_trans with (len (vadd (vscale u (vabs (vscale s a))) (V (u * tau) (u * tau) (u * tau)))).
  - apply len_mono; unfold rscale, vscale, vabs, vadd, vsub; simpl; apply rnd_any.
  - eapply Rle_trans; [apply len_triangle|]. rewrite len_scale, len_vabs, len_scale_any by lra.
    apply Rplus_le_compat; [apply Rle_refl|]. apply (len_le _ (2 * (u * tau))); [lra|]. unfold dot; simpl. nra.
Qed.
Lemma rsub_rounding : forall a b, fmt3 a -> fmt3 b -> len (vsub (rsub a b) (vsub a b)) <= u * len (vsub a b).
Proof.
  intros a b [A1 [A2 A3]] [B1 [B2 B3]]. generalize u_pos. intro U0.
  apply Rle_trans with (len (vscale u (vabs (vsub a b)))).
  - apply len_mono; unfold rsub, vscale, vabs, vsub; simpl; apply (rnd_plus _ (- _)); auto using fmt_opp.
  - right. rewrite len_scale, len_vabs by lra. reflexivity.
Qed.
Lemma dot_sub_right : forall a b c, dot a (vsub b c) = dot a b - dot a c.
Proof. intros. vdestruct. vunfold. ring. Qed.
Lemma len_sub_sym : forall a b, len (vsub a b) = len (vsub b a).
Proof. intros. unfold len. f_equal. unfold dot, vsub. cbn. ring. Qed.
Lemma len_between : forall a b c, len (vsub a c) <= len (vsub a b) + len (vsub b c).
Proof.
  intros a b c. replace (vsub a c) with (vadd (vsub a b) (vsub b c)) by (apply vec_eq; cbn; ring). apply len_triangle.
Qed.
Lemma len_from : forall a b, len a <= len b + len (vsub a b).
Proof.
  intros a b. replace a with (vadd b (vsub a b)) at 1 by (apply vec_eq; cbn; ring). apply len_triangle.
Qed.
Lemma rdot_rounding : forall a b, fmt3 a -> fmt3 b ->
  Rabs (rdot a b - dot a b) <= 3.0001 * u * (len a * len b + 3 * tau).
Proof.
  intros a b [A1 [A2 A3]] [B1 [B2 B3]].
  assert (Va : vapprox 0 a a) by (repeat split; simpl; apply approx_exact; auto).
  assert (Vb : vapprox 0 b b) by (repeat split; simpl; apply approx_exact; auto).
  destruct (rdot_approx 0 0 _ _ _ _ Va Vb) as [_ Er _]. change (0 + 0 + 3)%nat with 3%nat in Er.
  eapply Rle_trans; [exact Er|]. generalize u_pos u_val tau_pos (absdot_len a b). intros.
  assert (E 3 <= 3.0001 * u) by (unfold E; rewrite u_val; simpl; lra). assert (P := E_nonneg 3).
  assert (0 <= absdot a b) by (unfold absdot; repeat apply Rplus_le_le_0_compat; apply Rmult_le_pos; apply Rabs_pos).
  apply Rmult_le_compat; lra.
Qed.

(* ---- The part in the plane ---- *)

Lemma in_plane_len : forall e x, len (in_plane e x) <= len x.
Proof. intros. rewrite (whole_of_parts e x) at 2. apply part_is_shorter, across_plane. Qed.
Lemma in_plane_sub : forall e x y, in_plane e (vsub x y) = vsub (in_plane e x) (in_plane e y).
Proof.
  intros. unfold in_plane. replace (dot (vsub x y) e) with (dot x e - dot y e) by (vdestruct; vunfold; ring).
  apply vec_eq; cbn; unfold Rdiv; ring.
Qed.
Lemma in_plane_scale : forall e k x, in_plane e (vscale k x) = vscale k (in_plane e x).
Proof.
  intros. unfold in_plane. replace (dot (vscale k x) e) with (k * dot x e) by (vdestruct; vunfold; ring).
  apply vec_eq; cbn; unfold Rdiv; ring.
Qed.
Lemma in_plane_id : forall e x, dot x e = 0 -> in_plane e x = x.
Proof. intros e x H. unfold in_plane. rewrite H. apply vec_eq; cbn; unfold Rdiv; ring. Qed.
Lemma in_plane_orthogonal : forall e x, dot (in_plane e x) e = 0.
Proof.
  intros e x. destruct (Req_dec (dot e e) 0) as [Z|N].
  - apply dot_self_zero in Z. rewrite Z. unfold dot, vzero. cbn. ring.
  - unfold in_plane. replace (dot (vsub x (vscale (dot x e / dot e e) e)) e) with (dot x e - dot x e / dot e e * dot e
    e)
      by (generalize (dot x e / dot e e); clear; intros; vdestruct; vunfold; ring). field. exact N.
Qed.

(* The rounded projection of Y along the rounded edge f, and its multiple by `inverse`. *)
Definition projection f Y := rsub Y (rscale (rnd (rdot Y f / rdot f f)) f).
Definition shortened inverse f Y := rscale inverse (projection f Y).

Section Projection.
Variables (e f Y : vec) (inverse : R).
Hypothesis Ff : fmt3 f.
Hypothesis FY : fmt3 Y.
Hypothesis near : len (vsub f e) <= u * len e.
Hypothesis edge : / 10 ^ 26 <= len e <= 10 ^ 26.
Hypothesis long : / 10 ^ 140 <= len Y.
Hypothesis flat : Rabs (dot Y e) <= len Y * len e / 15.
Hypothesis unit_length : 1 - 3.6 * u <= inverse * len Y <= 1 + 3.6 * u.

Lemma tau_of_lengths : tau <= / 10 ^ 140 * len Y /\ tau <= / 10 ^ 80 * (len Y * len e).
Proof.
  generalize tau_small. intro T.
  assert (P : forall k, 0 < / 10 ^ k) by (intro; apply Rinv_0_lt_compat, pow_lt; lra).
  assert (P1 := P 80%nat). assert (P2 := P 140%nat). assert (P3 := P 26%nat). assert (P4 := P 60%nat).
  assert (Q : forall j k m, (j + k + m <= 300)%nat -> / 10 ^ 300 <= / 10 ^ j * (/ 10 ^ k * / 10 ^ m)).
  { intros j k m H. rewrite <- !Rinv_mult, <- !pow_add. apply Rinv_le; [apply pow_lt; lra | apply Rle_pow; [lra | lia]].
    }
  assert (T4 : / 10 ^ 140 * / 10 ^ 26 <= len Y * len e) by (apply Rmult_le_compat; lra).
  split; (eapply Rle_trans; [exact T|]).
  - apply Rle_trans with (/ 10 ^ 140 * (/ 10 ^ 140 * / 10 ^ 0)); [apply Q; lia|].
    rewrite (pow_O 10), Rinv_1, Rmult_1_r. apply Rmult_le_compat_l; lra.
  - apply Rle_trans with (/ 10 ^ 80 * (/ 10 ^ 140 * / 10 ^ 26)); [apply Q; lia|]. apply Rmult_le_compat_l; lra.
Qed.

Lemma factor_of_projection : let k0 := dot Y e / dot e e in let k := rnd (rdot Y f / rdot f f) in
  Rabs (k - k0) * len e <= 4.41 * u * len Y /\ Rabs k0 * len e <= len Y / 15 /\
  0 < rdot f f /\ Rabs (rdot Y f / rdot f f) <= len Y / len e.
Proof.
  intros k0 k. generalize u_pos u_val tau_pos. intros U0 Hu T0.
  destruct tau_of_lengths as [T1 T2].
  set (E := len e) in *. set (L := len Y) in *.
  assert (E0 : 0 < E) by (assert (0 < / 10 ^ 26) by (apply Rinv_0_lt_compat, pow_lt; lra); lra).
  assert (L0 : 0 < L) by (assert (0 < / 10 ^ 140) by (apply Rinv_0_lt_compat, pow_lt; lra); lra).
  assert (EE : dot e e = E * E) by (symmetry; apply len_sq).
  assert (LE : 0 < L * E) by (apply Rmult_lt_0_compat; assumption).
  assert (F1 : len f <= E * (1 + u)) by (eapply Rle_trans; [apply (len_from f e)|]; fold E; lra).
  assert (F2 : E * (1 - u) <= len f).
  { assert (A := len_from e f). rewrite len_sub_sym in A. fold E in A. lra. }
  assert (F0 := len_nonneg f).
  assert (FF1 : len f * len f <= E * E * ((1 + u) * (1 + u))).
  { replace (E * E * ((1 + u) * (1 + u))) with (E * (1 + u) * (E * (1 + u))) by ring. apply Rmult_le_compat; lra. }
  assert (FF2 : E * E * ((1 - u) * (1 - u)) <= len f * len f).
  { replace (E * E * ((1 - u) * (1 - u))) with (E * (1 - u) * (E * (1 - u))) by ring.
    assert (0 <= E * (1 - u)) by (apply Rmult_le_pos; rewrite ?Hu; lra). apply Rmult_le_compat; lra. }
  assert (E2 : 0 < E * E) by (apply Rmult_lt_0_compat; assumption).
  assert (T3 : tau <= / 10 ^ 80 * (E * E)).
  { eapply Rle_trans; [apply (tau_below (E * E))|].
    - apply Rle_trans with (/ 10 ^ 26 * / 10 ^ 26); [rewrite <- Rinv_mult, <- pow_add; apply Rinv_le; [apply pow_lt;
      lra |
        apply Rle_pow; [lra | lia]]|]. assert (0 < / 10 ^ 26) by (apply Rinv_0_lt_compat, pow_lt; lra).
      apply Rmult_le_compat; lra.
    - apply Rmult_le_compat_r; [lra|]. apply Rinv_le; [apply pow_lt; lra | apply Rle_pow; [lra | lia]]. }
  (* the square *)
  assert (Q := rdot_rounding f f Ff Ff). rewrite <- len_sq in Q. apply Rabs_le_inv in Q.
  set (ee := rdot f f) in *.
  assert (Qb : 3.0001 * u * (len f * len f + 3 * tau) <= 3.0002 * u * (E * E)).
  { apply Rle_trans with (3.0001 * u * (E * E * ((1 + u) * (1 + u)) + 3 * (/ 10 ^ 80 * (E * E)))).
    - apply Rmult_le_compat_l; lra.
    - rewrite Hu. lra. }
  assert (Q1 : E * E * (1 - 5.001 * u) <= ee <= E * E * (1 + 5.001 * u)) by (rewrite Hu in *; lra).
  assert (ee0 : 0 < ee) by (rewrite Hu in *; lra).
  (* the product *)
  assert (D := rdot_rounding Y f FY Ff). fold L in D.
  assert (Db : 3.0001 * u * (L * len f + 3 * tau) <= 3.0002 * u * (L * E)).
  { apply Rle_trans with (3.0001 * u * (L * (E * (1 + u)) + 3 * (/ 10 ^ 80 * (L * E)))).
    - apply Rmult_le_compat_l; [lra|]. apply Rplus_le_compat; [apply Rmult_le_compat_l; lra | lra].
    - rewrite Hu. lra. }
  assert (D1 : Rabs (rdot Y f - dot Y e) <= 4.0003 * u * (L * E)).
  { replace (rdot Y f - dot Y e) with ((rdot Y f - dot Y f) + dot Y (vsub f e)) by (rewrite dot_sub_right; ring).
    eapply Rle_trans; [apply Rabs_triang|]. assert (B := dot_len Y (vsub f e)). fold L in B.
    assert (L * len (vsub f e) <= L * (u * E)) by (apply Rmult_le_compat_l; lra).
    assert (0 < u * (L * E)) by (apply Rmult_lt_0_compat; lra). lra. }
  (* the quotient *)
  assert (K0 : k0 * (E * E) = dot Y e) by (unfold k0; rewrite EE; field; lra).
  assert (K1 : Rabs k0 * E <= L / 15).
  { apply Rmult_le_reg_r with E; [exact E0|]. rewrite Rmult_assoc.
    replace (Rabs k0 * (E * E)) with (Rabs (dot Y e)) by (rewrite <- K0, Rabs_mult, (Rabs_pos_eq (E * E)); lra). lra. }
  set (q := rdot Y f / ee). assert (Eq : q * ee = rdot Y f) by (unfold q; field; lra).
  assert (X : Rabs (q - k0) * ee <= 4.0003 * u * (L * E) + Rabs k0 * (5.001 * u * (E * E))).
  { rewrite <- (Rabs_pos_eq ee) at 1 by lra. rewrite <- Rabs_mult.
    replace ((q - k0) * ee) with ((rdot Y f - dot Y e) + k0 * (E * E - ee)) by lra.
    eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_mult.
    assert (Rabs (E * E - ee) <= 5.001 * u * (E * E)) by (apply Rabs_le; lra).
    assert (Rabs k0 * Rabs (E * E - ee) <= Rabs k0 * (5.001 * u * (E * E))) by (apply Rmult_le_compat_l; auto using
      Rabs_pos). lra. }
  assert (X1 : Rabs (q - k0) * E <= 4.335 * u * L).
  { apply Rmult_le_reg_r with (E * (1 - 5.001 * u)); [apply Rmult_lt_0_compat; [exact E0 | rewrite Hu; lra]|].
    apply Rle_trans with (Rabs (q - k0) * ee).
    - replace (Rabs (q - k0) * E * (E * (1 - 5.001 * u))) with (Rabs (q - k0) * (E * E * (1 - 5.001 * u))) by ring.
      apply Rmult_le_compat_l; [apply Rabs_pos | lra].
    - eapply Rle_trans; [exact X|].
      assert (Rabs k0 * (5.001 * u * (E * E)) <= L / 15 * (5.001 * u * E)).
      { replace (Rabs k0 * (5.001 * u * (E * E))) with (Rabs k0 * E * (5.001 * u * E)) by ring.
        apply Rmult_le_compat_r; [apply Rmult_le_pos; lra | exact K1]. }
      assert (0 < u * (L * E)) by (apply Rmult_lt_0_compat; lra). rewrite Hu in *. lra. }
  assert (X2 : Rabs q * E <= L * 0.067).
  { assert (A : Rabs q <= Rabs (q - k0) + Rabs k0).
    { replace q with ((q - k0) + k0) at 1 by ring. apply Rabs_triang. }
    assert (Rabs q * E <= (Rabs (q - k0) + Rabs k0) * E) by (apply Rmult_le_compat_r; lra). rewrite Hu in *. lra. }
  assert (R : Rabs (k - q) <= u * Rabs q + u * tau) by apply rnd_any.
  assert (X3 : Rabs (k - q) * E <= 0.068 * u * L).
  { apply Rle_trans with ((u * Rabs q + u * tau) * E); [apply Rmult_le_compat_r; lra|].
    assert (u * (Rabs q * E) <= u * (L * 0.067)) by (apply Rmult_le_compat_l; lra).
    assert (tau * E <= / 10 ^ 140 * L * 10 ^ 26) by (apply Rmult_le_compat; lra).
    assert (u * (tau * E) <= u * (/ 10 ^ 50 * L)) by (apply Rmult_le_compat_l; lra). rewrite Hu in *. lra. }
  split; [|split; [exact K1 | split; [exact ee0|]]].
  - assert (A : Rabs (k - k0) <= Rabs (k - q) + Rabs (q - k0)).
    { replace (k - k0) with ((k - q) + (q - k0)) by ring. apply Rabs_triang. }
    assert (Rabs (k - k0) * E <= (Rabs (k - q) + Rabs (q - k0)) * E) by (apply Rmult_le_compat_r; lra).
    assert (0 < u * L) by (apply Rmult_lt_0_compat; lra). lra.
  - apply Rmult_le_reg_r with E; [exact E0|]. fold q. replace (L / E * E) with L by (field; lra). lra.
Qed.

Theorem shortened_right : let U := shortened inverse f Y in
  len U <= 1 + 10.3 * u /\ len (vsub U (vscale inverse (in_plane e Y))) <= 6.6 * u /\
  inverse * len (projection f Y) <= 1 + 10 * u.
Proof.
  intro U. generalize u_pos u_val tau_pos. intros U0 Hu T0. destruct tau_of_lengths as [T1 _].
  destruct factor_of_projection as [K1 [K2 _]].
  set (k0 := dot Y e / dot e e) in *. set (k := rnd (rdot Y f / rdot f f)) in *.
  set (E := len e) in *. set (L := len Y) in *.
  assert (L0 : 0 < L) by (assert (0 < / 10 ^ 140) by (apply Rinv_0_lt_compat, pow_lt; lra); lra).
  assert (uL : 0 < u * L) by (apply Rmult_lt_0_compat; lra).
  assert (F1 : len f <= E * (1 + u)) by (eapply Rle_trans; [apply (len_from f e)|]; fold E; lra).
  assert (UT : u * tau <= / 10 ^ 20 * (u * L)).
  { replace (/ 10 ^ 20 * (u * L)) with (u * (/ 10 ^ 20 * L)) by ring. apply Rmult_le_compat_l; lra. }
  set (Q := rscale k f). assert (HQ := rscale_rounding k f). fold Q in HQ.
  assert (Kf : Rabs k * len f <= 0.068 * L).
  { assert (A : Rabs k <= Rabs (k - k0) + Rabs k0).
    { replace k with ((k - k0) + k0) at 1 by ring. apply Rabs_triang. }
    apply Rle_trans with ((Rabs (k - k0) + Rabs k0) * (E * (1 + u))).
    - apply Rmult_le_compat; auto using Rabs_pos, len_nonneg.
    - replace ((Rabs (k - k0) + Rabs k0) * (E * (1 + u))) with ((Rabs (k - k0) * E + Rabs k0 * E) * (1 + u)) by ring.
      apply Rle_trans with ((4.41 * u * L + L / 15) * (1 + u)); [apply Rmult_le_compat_r; lra|]. rewrite Hu. lra. }
  assert (Q1 : len (vsub (vscale k f) (vscale k0 e)) <= 4.48 * u * L).
  { replace (vsub (vscale k f) (vscale k0 e)) with (vadd (vscale (k - k0) f) (vscale k0 (vsub f e)))
      by (apply vec_eq; cbn; ring).
    eapply Rle_trans; [apply len_triangle|]. rewrite !len_scale_any.
    assert (Rabs (k - k0) * len f <= Rabs (k - k0) * (E * (1 + u))) by (apply Rmult_le_compat_l; auto using Rabs_pos).
    assert (Rabs k0 * len (vsub f e) <= Rabs k0 * (u * E)) by (apply Rmult_le_compat_l; auto using Rabs_pos).
    assert (A : Rabs (k - k0) * E * (1 + u) <= 4.41 * u * L * (1 + u)) by (apply Rmult_le_compat_r; lra).
    assert (B : u * (Rabs k0 * E) <= u * (L / 15)) by (apply Rmult_le_compat_l; lra).
    assert (u * (u * L) <= 0.0001 * (u * L)) by (apply Rmult_le_compat_r; [lra | rewrite Hu; lra]). lra. }
  assert (Q2 : len (vsub Q (vscale k0 e)) <= 4.55 * u * L).
  { eapply Rle_trans; [apply (len_between _ (vscale k f))|].
    assert (u * (Rabs k * len f) <= u * (0.068 * L)) by (apply Rmult_le_compat_l; lra). lra. }
  set (I := in_plane e Y). assert (EI : I = vsub Y (vscale k0 e)) by reflexivity.
  assert (LI : len I <= L) by apply in_plane_len.
  assert (Y1 : len (vsub (vsub Y Q) I) <= 4.55 * u * L).
  { rewrite EI. replace (vsub (vsub Y Q) (vsub Y (vscale k0 e))) with (vsub (vscale k0 e) Q) by (apply vec_eq; cbn;
    ring).
    rewrite len_sub_sym. exact Q2. }
  set (R := projection f Y). assert (FQ : fmt3 Q) by (repeat split; apply fmt_rnd).
  assert (HR := rsub_rounding Y Q FY FQ). change (rsub Y Q) with R in HR.
  assert (LYQ : len (vsub Y Q) <= L * (1 + 4.55 * u)) by (eapply Rle_trans; [apply (len_from _ I)|]; lra).
  assert (R1 : len (vsub R I) <= 5.56 * u * L).
  { eapply Rle_trans; [apply (len_between _ (vsub Y Q))|].
    assert (u * len (vsub Y Q) <= u * (L * (1 + 4.55 * u))) by (apply Rmult_le_compat_l; lra).
    assert (u * (u * L) <= 0.0001 * (u * L)) by (apply Rmult_le_compat_r; [lra | rewrite Hu; lra]). lra. }
  assert (LR : len R <= L * (1 + 5.56 * u)) by (eapply Rle_trans; [apply (len_from _ I)|]; lra).
  assert (i0 : 0 <= inverse).
  { apply Rnot_lt_le. intro N. assert (inverse * L < 0 * L) by (apply Rmult_lt_compat_r; lra). rewrite Hu in *. lra. }
  assert (HU := rscale_rounding inverse R). change (rscale inverse R) with U in HU. rewrite (Rabs_pos_eq _ i0) in HU.
  assert (iR : inverse * len R <= (1 + 3.6 * u) * (1 + 5.56 * u)).
  { apply Rle_trans with (inverse * (L * (1 + 5.56 * u))); [apply Rmult_le_compat_l; lra|].
    replace (inverse * (L * (1 + 5.56 * u))) with (inverse * L * (1 + 5.56 * u)) by ring. apply Rmult_le_compat_r; lra.
      }
  assert (iRI : inverse * len (vsub R I) <= 5.56 * u * (1 + 3.6 * u)).
  { apply Rle_trans with (inverse * (5.56 * u * L)); [apply Rmult_le_compat_l; lra|].
    replace (inverse * (5.56 * u * L)) with (5.56 * u * (inverse * L)) by ring. apply Rmult_le_compat_l; lra. }
  assert (TT : u * tau <= / 10 ^ 20 * u).
  { replace (/ 10 ^ 20 * u) with (u * / 10 ^ 20) by ring. apply Rmult_le_compat_l; [lra|].
    eapply Rle_trans; [apply tau_small|]. apply Rinv_le; [apply pow_lt; lra | apply Rle_pow; [lra | lia]]. }
  assert (Main : len (vsub U (vscale inverse I)) <= 6.6 * u).
  { eapply Rle_trans; [apply (len_between _ (vscale inverse R))|].
    replace (vsub (vscale inverse R) (vscale inverse I)) with (vscale inverse (vsub R I)) by (apply vec_eq; cbn; ring).
    rewrite len_scale by exact i0.
    assert (u * (inverse * len R) <= u * ((1 + 3.6 * u) * (1 + 5.56 * u))) by (apply Rmult_le_compat_l; lra).
    rewrite Hu in *. lra. }
  split; [|split; [exact Main | rewrite Hu in *; lra]].
  eapply Rle_trans; [apply (len_from _ (vscale inverse I))|]. rewrite len_scale by exact i0.
  assert (inverse * len I <= inverse * L) by (apply Rmult_le_compat_l; lra). lra.
Qed.
End Projection.

(* ---- The inverse of a length ---- *)

Definition rlength Y := rnd (sqrt (rdot Y Y)).
Lemma inverse_of_length : forall Y, fmt3 Y -> / 10 ^ 139 <= rlength Y -> len Y <= 10 ^ 160 ->
  / 10 ^ 140 <= len Y /\ 1 - 3.6 * u <= rnd (1 / rlength Y) * len Y <= 1 + 3.6 * u.
Proof.
  intros Y FY HS HL. generalize u_pos u_val tau_pos tau_small. intros U0 Hu T0 T.
  assert (P : forall k, 0 < / 10 ^ k) by (intro; apply Rinv_0_lt_compat, pow_lt; lra).
  assert (P1 := P 139%nat). assert (P2 := P 140%nat). assert (P3 := P 300%nat).
  assert (T1 : tau <= / 10 ^ 150 * / 10 ^ 139).
  { eapply Rle_trans; [exact T|]. rewrite <- Rinv_mult, <- pow_add. apply Rinv_le; [apply pow_lt; lra | apply
      Rle_pow; [lra | lia]]. }
  unfold rlength in *. set (yy := rdot Y Y) in *. set (q := sqrt yy) in *. set (s := rnd q) in *.
  assert (q0 : 0 <= q) by apply sqrt_pos.
  assert (R := rnd_any q). rewrite (Rabs_pos_eq q q0) in R. fold s in R.
  apply Rabs_le_inv in R.
  assert (UT : u * tau <= / 10 ^ 140 * (u * q)).
  { assert (q1 : / 10 ^ 139 * / 2 <= q) by (rewrite Hu in *; lra).
    replace (/ 10 ^ 140 * (u * q)) with (u * (/ 10 ^ 140 * q)) by ring. apply Rmult_le_compat_l; [lra|].
    eapply Rle_trans; [exact T1|]. assert (/ 10 ^ 150 * / 10 ^ 139 <= / 10 ^ 140 * (/ 10 ^ 139 * / 2)); [|assert (/ 10 ^
      140 * (/ 10 ^ 139 * / 2) <= / 10 ^ 140 * q) by (apply Rmult_le_compat_l; lra); lra].
    change (/ 10 ^ 150) with (/ 10 ^ (140 + 10)). rewrite pow_add, Rinv_mult. assert (0 < / 10 ^ 140 * / 10 ^ 139) by
      (apply Rmult_lt_0_compat; lra).
    replace (/ 10 ^ 140 * / 10 ^ 10 * / 10 ^ 139) with (/ 10 ^ 140 * / 10 ^ 139 * / 10 ^ 10) by ring.
    rewrite <- Rmult_assoc. apply Rmult_le_compat_l; lra. }
  assert (q1 : / 10 ^ 139 * (1 - 2 * u) <= q) by (rewrite Hu in *; lra).
  assert (yy0 : 0 < yy).
  { apply Rnot_le_lt. intro N. unfold q in q1. rewrite (sqrt_neg_0 yy) in q1 by exact N. rewrite Hu in q1. lra. }
  assert (qq : q * q = yy) by (apply sqrt_sqrt; lra).
  assert (D := rdot_rounding Y Y FY FY). fold yy in D. rewrite <- len_sq in D. apply Rabs_le_inv in D.
  assert (L0 := len_nonneg Y). set (L := len Y) in *.
  assert (Tq : tau <= / 10 ^ 10 * yy).
  { rewrite <- qq. apply Rle_trans with (/ 10 ^ 10 * (/ 10 ^ 139 * / 2 * (/ 10 ^ 139 * / 2))).
    - eapply Rle_trans; [exact T|]. replace (/ 10 ^ 10 * (/ 10 ^ 139 * / 2 * (/ 10 ^ 139 * / 2))) with (/ 10 ^ 10 * (/
      10
        ^ 139 * / 10 ^ 139) * (/ 2 * / 2)) by ring. rewrite <- !Rinv_mult, <- !pow_add.
      apply Rinv_le; [apply Rmult_lt_0_compat; [apply pow_lt; lra | lra]|].
      apply Rle_trans with (10 ^ (10 + (139 + 139)) * 10 ^ 2); [apply Rmult_le_compat_l; [apply pow_le; lra | lra]|].
      rewrite <- pow_add. apply Rle_pow; [lra | lia].
    - apply Rmult_le_compat_l; [lra|]. apply Rmult_le_compat; rewrite Hu in *; lra. }
  assert (Y1 : L * L * (1 - 3.0003 * u) <= yy <= L * L * (1 + 3.0003 * u)).
  { assert (3.0001 * u * (3 * tau) <= / 10 ^ 5 * (u * yy)) by (replace (/ 10 ^ 5 * (u * yy)) with (u * (/ 10 ^ 5 * yy))
    by
      ring; replace (3.0001 * u * (3 * tau)) with (u * (9.0003 * tau)) by lra; apply Rmult_le_compat_l; lra).
    assert (0 <= u * (L * L)) by (apply Rmult_le_pos; [lra | apply Rle_0_sqr]). rewrite Hu in *. lra. }
  assert (q2 : q <= L * (1 + 1.51 * u)).
  { apply Rsqr_incr_0_var; [|apply Rmult_le_pos; lra]. unfold Rsqr. rewrite qq.
    eapply Rle_trans; [exact (proj2 Y1)|]. replace (L * (1 + 1.51 * u) * (L * (1 + 1.51 * u))) with
      (L * L * ((1 + 1.51 * u) * (1 + 1.51 * u))) by ring. apply Rmult_le_compat_l; [apply Rle_0_sqr | rewrite Hu;
        lra]. }
  assert (q3 : L * (1 - 1.51 * u) <= q).
  { apply Rsqr_incr_0_var; [|exact q0]. unfold Rsqr. rewrite qq.
    eapply Rle_trans; [|exact (proj1 Y1)]. replace (L * (1 - 1.51 * u) * (L * (1 - 1.51 * u))) with
      (L * L * ((1 - 1.51 * u) * (1 - 1.51 * u))) by ring. apply Rmult_le_compat_l; [apply Rle_0_sqr | rewrite Hu;
        lra]. }
  assert (L1 : / 10 ^ 140 <= L) by (rewrite Hu in *; lra).
  split; [exact L1|].
  assert (uq : u * q <= u * (L * (1 + 1.51 * u))) by (apply Rmult_le_compat_l; lra).
  assert (s1 : L * (1 - 2.52 * u) <= s <= L * (1 + 2.52 * u)).
  { assert (0 <= u * L) by (apply Rmult_le_pos; lra). assert (0 <= u * q) by (apply Rmult_le_pos; lra).
    assert (u * (u * L) <= 0.0001 * (u * L)) by (apply Rmult_le_compat_r; [lra | rewrite Hu; lra]). lra. }
  assert (s0 : 0 < s) by lra.
  assert (I := rnd_any (1 / s)). rewrite (Rabs_pos_eq (1 / s)) in I by (apply Rlt_le, Rdiv_lt_0_compat; lra).
  apply Rabs_le_inv in I. set (i := rnd (1 / s)) in *.
  set (z := L / s). assert (Ez : 1 / s * L = z) by (unfold z; field; lra).
  assert (z1 : 1 - 2.53 * u <= z <= 1 + 2.53 * u).
  { assert (Es : z * s = L) by (unfold z; field; lra). split; apply Rmult_le_reg_r with s; try exact s0; rewrite Es.
    - apply Rle_trans with ((1 - 2.53 * u) * (L * (1 + 2.52 * u))); [apply Rmult_le_compat_l; rewrite Hu in *; lra |
        rewrite Hu in *; lra].
    - apply Rle_trans with ((1 + 2.53 * u) * (L * (1 - 2.52 * u))); [rewrite Hu in *; lra | apply Rmult_le_compat_l;
        lra]. }
  assert (TL : u * tau * L <= / 10 ^ 50 * u).
  { replace (u * tau * L) with (u * (tau * L)) by ring. replace (/ 10 ^ 50 * u) with (u * / 10 ^ 50) by ring.
    apply Rmult_le_compat_l; [lra|]. apply Rle_trans with (/ 10 ^ 300 * 10 ^ 160); [apply Rmult_le_compat; lra|].
    change (/ 10 ^ 300) with (/ 10 ^ (140 + 160)). rewrite pow_add, Rinv_mult, Rmult_assoc, Rinv_l, Rmult_1_r by (apply
      pow_nonzero; lra).
    apply Rinv_le; [apply pow_lt; lra | apply Rle_pow; [lra | lia]]. }
  assert (I1 : (1 / s - u * (1 / s) - u * tau) * L <= i * L) by (apply Rmult_le_compat_r; lra).
  assert (I2 : i * L <= (1 / s + u * (1 / s) + u * tau) * L) by (apply Rmult_le_compat_r; lra).
  replace ((1 / s - u * (1 / s) - u * tau) * L) with (1 / s * L * (1 - u) - u * tau * L) in I1 by ring.
  replace ((1 / s + u * (1 / s) + u * tau) * L) with (1 / s * L * (1 + u) + u * tau * L) in I2 by ring.
  rewrite Ez in I1, I2.
  assert (z * (1 + u) <= (1 + 2.53 * u) * (1 + u)) by (apply Rmult_le_compat_r; lra).
  assert ((1 - 2.53 * u) * (1 - u) <= z * (1 - u)) by (apply Rmult_le_compat_r; rewrite ?Hu in *; lra).
  rewrite Hu in *. lra.
Qed.

(* ---- The tangent of an angle whose sine is known ---- *)

Lemma turn_of_offset : forall z G g t, 0 < t -> len G <= g -> g < len z -> g * g <= t * t * (len z * len z - g * g) ->
  tangent_at_most t z (vadd z G).
Proof.
  intros z G g t T0 HG Hz H. assert (G0 := len_nonneg G). assert (z0 := len_nonneg z).
  assert (A := dot_len G z). apply Rabs_le_inv in A. set (a := dot G z) in *.
  assert (Ga : len G * len z <= g * len z) by (apply Rmult_le_compat_r; lra).
  assert (E : dot (vadd z G) z = len z * len z + a) by (unfold a; rewrite len_sq; vdestruct; vunfold; ring).
  assert (gz : g * len z < len z * len z) by (apply Rmult_lt_compat_r; lra).
  split; rewrite E; [lra|].
  replace (cross (vadd z G) z) with (cross G z) by (clear; vdestruct; apply vec_eq; cbn; ring).
  apply len_le; [apply Rmult_le_pos; lra|].
  assert (C : dot (cross G z) (cross G z) = dot G G * dot z z - a * a)
    by (unfold a; clear; vdestruct; vunfold; ring).
  rewrite C, <- !len_sq. set (Z := len z * len z) in *.
  assert (GG : len G * len G * Z <= g * g * Z) by (apply Rmult_le_compat_r; [apply Rle_0_sqr | apply
    Rmult_le_compat; lra]).
  assert (S : (1 + t * t) * (t * t * ((Z + a) * (Z + a)) + a * a) = ((1 + t * t) * a + t * t * Z) * ((1 + t * t) * a + t
    * t * Z) + t * t * (Z * Z)) by ring.
  assert (S0 := Rle_0_sqr ((1 + t * t) * a + t * t * Z)). unfold Rsqr in S0.
  assert (S1 : g * g * (1 + t * t) * Z <= t * t * Z * Z).
  { apply Rmult_le_compat_r; [apply Rle_0_sqr|]. lra. }
  assert (S2 : g * g * Z <= t * t * ((Z + a) * (Z + a)) + a * a).
  { apply Rmult_le_reg_l with (1 + t * t); [assert (0 <= t * t) by apply Rle_0_sqr; lra|]. lra. }
  lra.
Qed.

Lemma tangent_scale : forall k t y P, 0 < k -> tangent_at_most t (vscale k y) P -> tangent_at_most t y P.
Proof.
  intros k t y P K [H1 H2]. rewrite dot_scale_right in H1, H2.
  replace (cross P (vscale k y)) with (vscale k (cross P y)) in H2 by (clear; vdestruct; apply vec_eq; cbn; ring).
  rewrite len_scale in H2 by lra. split; [nra|]. apply Rmult_le_reg_l with k; [exact K | lra].
Qed.

Lemma tangent_of_sine : forall s t z, 19.9 * u <= s <= / 16 -> s * (1 + 2 * s) * (1 - 3.1 * u) <= t ->
  1 - s - 3.7 * u <= z -> s * s <= t * t * (z * z - s * s).
Proof.
  intros s t z [S1 S2] Ht Hz. generalize u_pos u_val. intros U0 Hu.
  set (b := (1 + 2 * s) * (1 - 3.1 * u)). assert (b0 : 0 < b).
  { unfold b. apply Rmult_lt_0_compat; rewrite ?Hu in *; lra. }
  assert (T : s * b * (s * b) <= t * t).
  { assert (0 <= s * b) by (apply Rmult_le_pos; lra). unfold b in *. apply Rmult_le_compat; lra. }
  assert (Z : (1 - s - 3.7 * u) * (1 - s - 3.7 * u) <= z * z) by (apply Rmult_le_compat; rewrite ?Hu in *; lra).
  assert (D : 1 - 2 * s - 7.4 * u <= z * z - s * s).
  { assert (0 <= u * s) by (apply Rmult_le_pos; lra). assert (0 <= u * u) by (apply Rle_0_sqr). lra. }
  apply Rle_trans with (s * b * (s * b) * (1 - 2 * s - 7.4 * u)).
  - replace (s * b * (s * b) * (1 - 2 * s - 7.4 * u)) with (s * s * (b * b * (1 - 2 * s - 7.4 * u))) by ring.
    rewrite <- (Rmult_1_r (s * s)) at 1. apply Rmult_le_compat_l; [apply Rle_0_sqr|].
    assert (B : (1 + 4 * s + 4 * (s * s)) * (1 - 6.2 * u) <= b * b).
    { replace (b * b) with ((1 + 4 * s + 4 * (s * s)) * ((1 - 3.1 * u) * (1 - 3.1 * u))) by (unfold b; ring).
      apply Rmult_le_compat_l; [nra | rewrite Hu; lra]. }
    assert (Q : 0 <= 1 - 2 * s - 7.4 * u) by (rewrite Hu in *; lra).
    apply Rle_trans with ((1 + 4 * s + 4 * (s * s)) * (1 - 6.2 * u) * (1 - 2 * s - 7.4 * u)).
    + assert (s2 : s * s <= / 16 * s) by (apply Rmult_le_compat_r; lra).
      assert (s3 : s * s * s <= / 16 * s * s) by (apply Rmult_le_compat_r; lra).
      assert (s0 : 0 <= s * s) by apply Rle_0_sqr. assert (s30 : 0 <= s * s * s) by (apply Rmult_le_pos; lra).
      replace ((1 + 4 * s + 4 * (s * s)) * (1 - 6.2 * u) * (1 - 2 * s - 7.4 * u)) with
        ((1 - 6.2 * u) * (1 + 2 * s - 4 * (s * s) - 8 * (s * s * s) - 7.4 * u * (1 + 4 * s + 4 * (s * s)))) by ring.
      rewrite Hu in *. lra.
    + apply Rmult_le_compat_r; assumption.
  - assert (0 <= s * b * (s * b)) by apply Rle_0_sqr. assert (Q : 0 <= 1 - 2 * s - 7.4 * u) by (rewrite Hu in *; lra).
    apply Rmult_le_compat; lra.
Qed.

(* ---- What is known of the shortened vector ---- *)

Theorem shortened_known : forall e f Y y bound s t inverse, fmt3 f -> fmt3 Y ->
  len (vsub f e) <= u * len e -> / 10 ^ 26 <= len e <= 10 ^ 26 -> / 10 ^ 140 <= len Y ->
  1 - 3.6 * u <= inverse * len Y <= 1 + 3.6 * u -> dot y e = 0 ->
  len (vsub Y y) + 8 * u * len Y <= bound -> 20 * u * len Y <= bound ->
  inverse * bound * (1 - u) - u * tau <= s <= inverse * bound * (1 + u) + u * tau -> s <= / 16 ->
  s * (1 + 2 * s) * (1 - 3.1 * u) <= t <= 3 / 32 ->
  known e y (shortened inverse f Y) t.
Proof.
  intros e f Y y bound s t inverse Ff FY Near Edge Long Unit Ye HB HB2 HS S16 Ht.
  generalize u_pos u_val tau_pos tau_small. intros U0 Hu T0 Tau.
  assert (P140 : 0 < / 10 ^ 140) by (apply Rinv_0_lt_compat, pow_lt; lra).
  assert (P26 : 0 < / 10 ^ 26) by (apply Rinv_0_lt_compat, pow_lt; lra).
  assert (TT : u * tau <= / 10 ^ 20 * u).
  { replace (/ 10 ^ 20 * u) with (u * / 10 ^ 20) by ring. apply Rmult_le_compat_l; [lra|].
    eapply Rle_trans; [exact Tau|]. apply Rinv_le; [apply pow_lt; lra | apply Rle_pow; [lra | lia]]. }
  set (L := len Y) in *. set (E := len e) in *.
  assert (i0 : 0 < inverse).
  { apply Rnot_le_lt. intro N. assert (inverse * L <= 0 * L) by (apply Rmult_le_compat_r; lra). rewrite Hu in *. lra. }
  assert (D0 := len_nonneg (vsub Y y)). set (d := len (vsub Y y)) in *.
  assert (B1 : inverse * (20 * u * L) <= inverse * bound) by (apply Rmult_le_compat_l; lra).
  assert (B2 : inverse * (d + 8 * u * L) <= inverse * bound) by (apply Rmult_le_compat_l; lra).
  assert (B3 : 20 * u * (1 - 3.6 * u) <= 20 * u * (inverse * L)) by (apply Rmult_le_compat_l; lra).
  assert (B4 : 8 * u * (1 - 3.6 * u) <= 8 * u * (inverse * L)) by (apply Rmult_le_compat_l; lra).
  assert (Sb : inverse * bound <= s * (1 + 1.01 * u) + / 10 ^ 19 * u).
  { apply Rmult_le_reg_r with (1 - u); [rewrite Hu; lra|].
    assert (0 <= s) by (rewrite Hu in *; lra). apply Rle_trans with (s + / 10 ^ 20 * u); [lra|]. rewrite Hu in *. lra. }
  assert (S1 : 19.9 * u <= s) by (rewrite Hu in *; lra).
  assert (Off : inverse * d + 6.6 * u <= s) by (rewrite Hu in *; lra).
  assert (dL : d <= L / 15).
  { apply Rmult_le_reg_l with inverse; [exact i0|]. rewrite Hu in *. lra. }
  assert (Flat : Rabs (dot Y e) <= L * E / 15).
  { replace (dot Y e) with (dot (vsub Y y) e).
    - eapply Rle_trans; [apply dot_len|]. fold d E. assert (d * E <= L / 15 * E) by (apply Rmult_le_compat_r; lra). lra.
    - rewrite (dot_sym (vsub Y y)), dot_sub_right, (dot_sym e y), Ye, dot_sym. ring. }
  destruct (shortened_right e f Y inverse Ff FY Near Edge Long Flat Unit) as [Short [Main _]].
  set (U := shortened inverse f Y) in *. set (I := in_plane e Y) in *.
  assert (OI : dot I e = 0) by apply in_plane_orthogonal.
  set (G := vsub (in_plane e U) (vscale inverse y)).
  assert (EG : G = vadd (in_plane e (vsub U (vscale inverse I))) (vscale inverse (in_plane e (vsub Y y)))).
  { unfold G. rewrite !in_plane_sub, !in_plane_scale, (in_plane_id e I OI), (in_plane_id e y Ye). fold I.
    apply vec_eq; cbn; ring. }
  assert (LG : len G <= s).
  { rewrite EG. eapply Rle_trans; [apply len_triangle|]. rewrite len_scale by lra.
    assert (A1 := in_plane_len e (vsub U (vscale inverse I))). assert (A2 := in_plane_len e (vsub Y y)). fold d in A2.
    assert (inverse * len (in_plane e (vsub Y y)) <= inverse * d) by (apply Rmult_le_compat_l; lra). lra. }
  set (z := vscale inverse y).
  assert (Lz : 1 - s - 3.7 * u <= len z).
  { unfold z. rewrite len_scale by lra. assert (A := len_from Y y). fold L d in A.
    assert (inverse * L <= inverse * (len y + d)) by (apply Rmult_le_compat_l; lra). lra. }
  assert (EU : in_plane e U = vadd z G) by (unfold G, z; apply vec_eq; cbn; ring).
  split.
  - exact Ye.
  - lra.
  - assert (A : dot U e = dot (vsub U (vscale inverse I)) e).
    { rewrite (dot_sym (vsub _ _)), dot_sub_right, dot_scale_right, (dot_sym e I), OI, (dot_sym e U). ring. }
    rewrite A. eapply Rle_trans; [apply dot_len|]. fold E.
    assert (LU : 0.87 <= len U).
    { apply Rle_trans with (len (in_plane e U)); [|apply in_plane_len]. rewrite EU.
      assert (C := len_from z (vadd z G)). replace (vsub z (vadd z G)) with (vscale (-1) G) in C by (apply vec_eq; cbn;
        ring). rewrite len_scale_any in C. replace (Rabs (-1)) with 1 in C by (rewrite Rabs_left; lra).
      rewrite Hu in *. lra. }
    assert (len (vsub U (vscale inverse I)) * E <= 6.6 * u * E) by (apply Rmult_le_compat_r; lra).
    assert (0 < u * E) by (apply Rmult_lt_0_compat; lra).
    assert (0.87 * (u * E) <= len U * (u * E)) by (apply Rmult_le_compat_r; [apply Rmult_le_pos; lra | exact LU]). lra.
  - apply (tangent_scale inverse); [exact i0|]. fold z. rewrite EU.
    assert (t0 : 0 < t).
    { eapply Rlt_le_trans; [|exact (proj1 Ht)]. apply Rmult_lt_0_compat; [apply Rmult_lt_0_compat; lra|].
      rewrite Hu; lra. }
    apply (turn_of_offset z G s t); [exact t0 | exact LG | rewrite Hu in *; lra|].
    apply (tangent_of_sine s t (len z)); [lra | exact (proj1 Ht) | exact Lz].
  - split; [|exact (proj2 Ht)]. eapply Rle_trans; [|exact (proj1 Ht)].
    assert (19.9 * u * 0.99 <= s * (1 + 2 * s) * (1 - 3.1 * u)); [|lra].
    assert (19.9 * u * 1 <= s * (1 + 2 * s)) by (apply Rmult_le_compat; lra).
    apply Rmult_le_compat; rewrite ?Hu in *; lra.
Qed.
