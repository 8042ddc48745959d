(* The Gabriel test (FC-SIGN-02): whether the midpoint of two samples is critical of index 1.
   It asks all samples, or, for an edge of a Delaunay triangulation, the samples of the cells at the edge. *)
From Coq Require Import Reals ZArith Lra Lia List.
From Flowcert Require Import algebra.Vector3 spec.Hull spec.HalfSpace spec.CriticalPoint spec.Dimension spec.Face
  spec.Stationary spec.Driver spec.Subsets spec.Delaunay algebra.Sphere algebra.LocalDelaunay.
From Flowcert Require algebra.Cascade.
Import ListNotations.
Open Scope R_scope.

(* This is h of FC-SIGN-01. *)
Local Notation h := Cascade.h.

Lemma h_is_power : forall p0 p1 q, dist2 (midpoint p0 p1) q - dist2 (midpoint p0 p1) p0 = h p0 p1 q.
Proof. intros. unfold Cascade.h. vdestruct; vunfold; field. Qed.
Lemma h_at_ends : forall p0 p1, h p0 p1 p0 = 0 /\ h p0 p1 p1 = 0.
Proof. intros. unfold Cascade.h. split; vdestruct; vunfold; ring. Qed.
Lemma midpoint_weights : forall p0 p1, comb [/ 2; / 2] [p0; p1] = midpoint p0 p1.
Proof. intros. apply vec_eq; simpl; field. Qed.
Lemma midpoint_in_relint : forall p0 p1, in_relint [p0; p1] (midpoint p0 p1).
Proof.
  intros. apply positive_weights_sound. exists [/ 2; / 2]. repeat split; auto; [|simpl; lra | apply midpoint_weights].
  repeat constructor; lra.
Qed.

Lemma pair_dimension : forall p0 p1, p0 <> p1 -> affine_dimension [p0; p1] 1.
Proof.
  intros p0 p1 N. exists p0, [vsub p1 p0]. split; [left; auto|]. split; auto. split; [|split].
  - apply (independent_cons [] (vsub p1 p0)); [intros b [] | |].
    + intros E. apply N. symmetry. apply dist2_zero, E.
    + intros [|a c] L _; [constructor | discriminate].
  - intros b [<-|[]]. exists p1. split; [right; left; auto | auto].
  - intros p [<-|[<-|[]]]; [exists [0] | exists [1]]; (split; [auto | apply vec_eq; simpl; ring]).
Qed.

(* ---- The strict Gabriel test ---- *)

Theorem gabriel : forall P i j p0 p1, NoDup P -> i <> j -> point_at P i p0 -> point_at P j p1 ->
  (critical P (midpoint p0 p1) [i; j] 1 <-> forall q, In q P -> q <> p0 -> q <> p1 -> 0 < h p0 p1 q).
Proof.
  intros P i j p0 p1 D N E0 E1. set (m := midpoint p0 p1).
  assert (HC : Forall2 (point_at P) [i; j] [p0; p1]) by (repeat constructor; auto; apply E0 || apply E1).
  assert (NK : NoDup [i; j]) by (repeat constructor; simpl; intuition).
  assert (Far : forall q, dist2 m q = dist2 m p0 + h p0 p1 q) by (intros; rewrite <- h_is_power; unfold m; ring).
  assert (Mid := midpoint_in_relint p0 p1). fold m in Mid. split.
  - intros [H _] q Hq N0 N1. destruct (conditions_hold P m [i; j] [p0; p1] H HC (proj1 Mid)) as [r [[_ B] [E [F _]]]].
    specialize (B p0 (or_introl eq_refl)). specialize (E q Hq). rewrite Far, B in E.
    destruct (Rle_lt_or_eq_dec 0 (h p0 p1 q)) as [L|Z]; [lra | exact L |]. exfalso.
    destruct (point_at_exists P q Hq) as [l El].
    assert (K : In l [i; j]) by (apply (F l q El); rewrite Far, B, <- Z; ring).
    destruct K as [<-|[<-|[]]]; [apply N0 | apply N1]; eapply point_at_same; eauto.
  - intros H. destruct (h_at_ends p0 p1) as [H0 H1].
    assert (G : forall q, In q P -> 0 <= h p0 p1 q /\ (h p0 p1 q = 0 -> q = p0 \/ q = p1)).
    { intros q Hq. destruct (vec_eq_dec q p0) as [->|N0]; [rewrite H0; split; auto; lra|].
      destruct (vec_eq_dec q p1) as [->|N1]; [rewrite H1; split; auto; lra|].
      specialize (H q Hq N0 N1). split; intros; lra. }
    assert (C : sphere_conditions P [i; j] [p0; p1] m (dist2 m p0)).
    { split; [split; [apply conv_in_aff, Mid|] |].
      - intros p [<-|[<-|[]]]; rewrite Far; lra.
      - split; [intros q Hq; rewrite (Far q); destruct (G q Hq); lra|]. split; [|apply Mid].
        intros l q El Eq. rewrite (Far q) in Eq. destruct (G q (point_at_in P l q El)) as [_ Z].
        destruct (Z ltac:(lra)) as [->| ->]; [left | right; left]; eapply point_at_once; eauto. }
    split; [apply (conditions_suffice P m (dist2 m p0) _ [p0; p1]); auto|].
    exists [p0; p1]. split; auto. split; auto. apply pair_dimension. intros <-. apply N. eapply point_at_once; eauto.
Qed.

(* ---- Delaunay triangulations ---- *)

Definition at_edge p0 p1 (t : list vec) := In p0 t /\ In p1 t.

(* A corner of a cell is off some plane that has all others. *)
Lemma off_plane : forall P T t p, delaunay_triangulation P T -> In t T -> In p t ->
  exists u l, dot u p <> l /\ forall q, In q t -> q <> p -> dot u q = l.
Proof.
  intros P T t p D Ht Hp. assert (U := fun w w' => cells_are_simplices P T D t w w' Ht). clear Ht.
  apply in_split in Hp. destruct Hp as [C1 [C2 ->]].
  destruct (in_aff_or_apart (C1 ++ C2) p) as [[w [L [S E]]]|[u [l [A N]]]].
  - exfalso. assert (Split : exists w1 w2, w = w1 ++ w2 /\ length w1 = length C1 /\ length w2 = length C2).
    { rewrite app_length in L. exists (firstn (length C1) w), (skipn (length C1) w).
      rewrite firstn_skipn, firstn_length, skipn_length. repeat split; lia. }
    destruct Split as [w1 [w2 [-> [L1 L2]]]].
    assert (App : forall a b : list R, sum (a ++ b) = sum a + sum b).
    { clear. induction a as [|x a IH]; intros b; simpl; [ring|]. rewrite IH. ring. }
    assert (Zero : forall C, comb (repeat 0 (length C)) C = vzero).
    { clear. induction C as [|q C IH]; simpl; auto. rewrite IH. apply vec_eq; simpl; ring. }
    assert (F : w1 ++ 0 :: w2 = repeat 0 (length C1) ++ 1 :: repeat 0 (length C2)).
    { rewrite App in S. rewrite comb_app in E by auto. apply U.
      - rewrite !app_length. simpl. lia.
      - rewrite !app_length. simpl. rewrite !repeat_length. lia.
      - rewrite App. simpl. lra.
      - rewrite App. simpl. rewrite !sum_repeat. lra.
      - rewrite !comb_app by (rewrite ?repeat_length; auto). simpl. rewrite !Zero, <- E. apply vec_eq; simpl; ring. }
    apply (f_equal (fun l => nth (length C1) l 0)) in F.
    rewrite !app_nth2 in F by (rewrite ?repeat_length; lia). rewrite repeat_length, L1, Nat.sub_diag in F. simpl in F.
    lra.
  - exists u, l. split; auto. intros q Hq Nq. apply A, in_or_app. apply in_app_or in Hq.
    destruct Hq as [Hq|[Hq|Hq]]; auto. congruence.
Qed.

(* A hull that does not contain m has no points close to it on the way to q. *)
Lemma hull_is_closed : forall C m q, in_conv C m \/
  exists e, 0 < e /\ forall a, 0 < a <= e -> ~ in_conv C (vadd m (vscale a (vsub q m))).
Proof.
  intros C m q. destruct C as [|p C].
  { right. exists 1. split; [lra|]. intros a _ H. apply hull_nonempty in H. destruct H as [p []]. }
  destruct (nearest_exists (p :: C) m p (or_introl eq_refl)) as [c N]. assert (H := proj1 N).
  destruct (Req_dec (dist2 m c) 0) as [Z|Z]; [left; rewrite (dist2_zero m c Z); auto|]. right.
  assert (D : 0 < dist2 m c) by (assert (0 <= dist2 m c) by apply dot_self_nonneg; lra).
  set (b := Rabs (dot (vsub m c) (vsub q m))). assert (Hb : 0 <= b) by apply Rabs_pos.
  exists (dist2 m c / (2 * (b + 1))). split; [apply Rdiv_lt_0_compat; lra|].
  intros a Ha Hy. assert (A := proj1 (nearest_iff_angles (p :: C) m c H) N).
  assert (B : dot (vsub m c) (vadd m (vscale a (vsub q m))) <= dot (vsub m c) c).
  { apply (conv_below _ _ (p :: C)); auto. intros r Hr. specialize (A r Hr). apply Rminus_le.
    replace (dot (vsub m c) r - dot (vsub m c) c) with (dot (vsub m c) (vsub r c)); auto.
    clear. vdestruct; vunfold; ring. }
  assert (E : dot (vsub m c) (vadd m (vscale a (vsub q m))) - dot (vsub m c) c
              = dist2 m c + a * dot (vsub m c) (vsub q m)) by (clear; vdestruct; vunfold; ring).
  assert (L : - b <= dot (vsub m c) (vsub q m)).
  { unfold b. generalize (Rle_abs (- dot (vsub m c) (vsub q m))). rewrite Rabs_Ropp. lra. }
  assert (F : dist2 m c / (2 * (b + 1)) * (b + 1) = dist2 m c / 2) by (field; lra).
  assert (a * (b + 1) <= dist2 m c / 2) by (rewrite <- F; apply Rmult_le_compat_r; lra).
  assert (a * - b <= a * dot (vsub m c) (vsub q m)) by (apply Rmult_le_compat_l; lra). lra.
Qed.
Lemma hulls_are_closed : forall (T : list (list vec)) m q, exists e, 0 < e <= 1 /\
  forall t, In t T -> in_conv t (vadd m (vscale e (vsub q m))) -> in_conv t m.
Proof.
  intros T m q.
  assert (G : exists e, 0 < e <= 1 /\ forall t a, In t T -> 0 < a <= e ->
    in_conv t (vadd m (vscale a (vsub q m))) -> in_conv t m).
  { induction T as [|t T [e [He IH]]]; [exists 1; split; [lra | intros t a []]|].
    destruct (hull_is_closed t m q) as [M|[d [Hd N]]].
    - exists e. split; auto. intros s a [<-|Hs] Ha H; eauto.
    - exists (Rmin d e). split; [split; [apply Rmin_pos; lra | generalize (Rmin_r d e); lra]|].
      intros s a [<-|Hs] Ha H; [exfalso; apply (N a); auto; generalize (Rmin_l d e); lra|].
      apply (IH s a); auto. generalize (Rmin_r d e); lra. }
  destruct G as [e [He G]]. exists e. split; auto. intros t Ht. apply G; auto. lra.
Qed.

(* A hull of corners of a cell that contains the midpoint of an edge has both ends among these. *)
Lemma edge_of_cell : forall P T t F p0 p1, delaunay_triangulation P T -> In t T -> In p0 t -> In p1 t -> p0 <> p1 ->
  incl F t -> in_conv F (midpoint p0 p1) -> In p0 F.
Proof.
  intros P T t F p0 p1 D Ht H0 H1 N I M. destruct (off_plane P T t p0 D Ht H0) as [u [l [U L]]].
  destruct (in_dec vec_eq_dec p0 F) as [Y|Y]; auto.
  exfalso. apply U. assert (E : dot u (midpoint p0 p1) = l).
  { apply (aff_level u l F); [|apply conv_in_aff; auto]. intros q Hq. apply L; auto. intros ->. auto. }
  assert (E1 : dot u p1 = l) by (apply L; auto). revert E E1. clear. vdestruct; vunfold. lra.
Qed.

(* Near the midpoint of an edge, every way into the hull of the samples begins in a cell at the edge. *)
Lemma star_of_edge : forall P T t0 p0 p1 q, delaunay_triangulation P T -> In t0 T -> at_edge p0 p1 t0 -> p0 <> p1 ->
  In q P ->
  exists t e, In t T /\ at_edge p0 p1 t /\ 0 < e <= 1 /\
    in_conv t (vadd (midpoint p0 p1) (vscale e (vsub q (midpoint p0 p1)))).
Proof.
  intros P T t0 p0 p1 q D H0 [A0 A1] N Hq. set (m := midpoint p0 p1).
  destruct (hulls_are_closed T m q) as [e [He G]].
  assert (I0 : incl t0 P) by (intros v Hv; apply (vertices_are_samples P T D); exists t0; auto).
  assert (M0 : in_conv t0 m).
  { apply (conv_incl [p0; p1]); [intros p [<-|[<-|[]]]; auto | apply midpoint_in_relint]. }
  destruct (proj1 (cells_fill_the_hull P T D (vadd m (vscale e (vsub q m))))) as [t [Ht Y]].
  { apply conv_between; [apply (conv_incl t0); auto | apply point_in_conv; auto | lra]. }
  exists t, e. split; auto. split; [|auto].
  destruct (cells_meet_in_faces P T D t0 t m H0 Ht M0 (G t Ht Y)) as [F [F0 [Ft MF]]].
  split; apply Ft.
  - apply (edge_of_cell P T t0 F p0 p1); auto.
  - apply (edge_of_cell P T t0 F p1 p0); auto. replace (midpoint p1 p0) with m; auto.
    unfold m, midpoint. apply vec_eq; simpl; ring.
Qed.

(* On the line through both ends, h is 0 at these alone. The way from the midpoint to q begins between them. *)
Lemma h_on_line : forall p0 p1 q e, e <> 0 ->
  in_conv [p0; p1] (vadd (midpoint p0 p1) (vscale e (vsub q (midpoint p0 p1)))) ->
  h p0 p1 q = 0 -> q = p0 \/ q = p1.
Proof.
  intros p0 p1 q e He [w [L [_ [S E]]]] H. destruct w as [|a [|b [|]]]; try discriminate. simpl in S.
  set (k := / e * (b - / 2) + / 2).
  assert (Q : q = vadd p0 (vscale k (vsub p1 p0))).
  { assert (D : vscale e (vsub q (midpoint p0 p1)) = vscale (b - / 2) (vsub p1 p0)).
    { assert (Ea : a = 1 - b) by lra. subst a. clear - E. simpl in E. vdestruct; vunfold.
      injection E; intros; apply vec_eq; simpl; lra. }
    assert (D' : vsub q (midpoint p0 p1) = vscale (/ e * (b - / 2)) (vsub p1 p0)).
    { transitivity (vscale (/ e) (vscale e (vsub q (midpoint p0 p1)))); [apply vec_eq; simpl; field; auto|].
      rewrite D. apply vec_eq; simpl; ring. }
    transitivity (vadd (vsub q (midpoint p0 p1)) (midpoint p0 p1)); [apply vec_eq; simpl; ring|].
    rewrite D'. unfold k, midpoint. apply vec_eq; simpl; field; auto. }
  clearbody k. assert (Z : k * (k - 1) * dist2 p1 p0 = 0).
  { rewrite <- H, Q. unfold Cascade.h. clear. vdestruct; vunfold; ring. }
  apply Rmult_integral in Z. destruct Z as [Z|Z].
  - apply Rmult_integral in Z. rewrite Q. destruct Z as [Z|Z]; [left | right].
    + rewrite Z. apply vec_eq; simpl; ring.
    + replace k with 1 by lra. apply vec_eq; simpl; ring.
  - left. apply dist2_zero in Z. rewrite Q, Z. apply vec_eq; simpl; ring.
Qed.

(* h less the power to the cell's sphere is an affine function. It is 0 at the midpoint, and not negative at the cell's
   samples. So it is not negative on the way from the midpoint into the cell, nor at q, where this way leads. *)
Lemma cell_at_edge : forall t z r2 p0 p1 q e, on_sphere z r2 t -> r2 <= dist2 z q -> at_edge p0 p1 t ->
  (forall v, In v t -> v <> p0 -> v <> p1 -> 0 < h p0 p1 v) -> 0 < e ->
  in_conv t (vadd (midpoint p0 p1) (vscale e (vsub q (midpoint p0 p1)))) ->
  q <> p0 -> q <> p1 -> 0 < h p0 p1 q.
Proof.
  intros t z r2 p0 p1 q e S Out [A0 A1] H He Y N0 N1. set (m := midpoint p0 p1) in *.
  set (r := dist2 m p0). set (u := gradient z m). set (k := dot m m - dot z z - r + r2).
  (* u x - k is the power of x to the cell's sphere less h *)
  assert (G : forall x, dot u x - k = power z r2 x - h p0 p1 x).
  { intros x. unfold u, k. rewrite <- lift_difference, <- h_is_power. fold m. unfold lift, power, r. ring. }
  assert (On : forall v, In v t -> dot u v - k = - h p0 p1 v).
  { intros v Hv. rewrite G, (S v Hv). ring. }
  destruct (h_at_ends p0 p1) as [Z0 Z1].
  assert (D : forall v, In v t -> dot u v <= k /\ (dot u v = k -> v = p0 \/ v = p1)).
  { intros v Hv. specialize (On v Hv). destruct (vec_eq_dec v p0) as [->|V0]; [rewrite Z0 in On; split; auto; lra|].
    destruct (vec_eq_dec v p1) as [->|V1]; [rewrite Z1 in On; split; auto; lra|].
    specialize (H v Hv V0 V1). split; intros; lra. }
  assert (M : dot u m = k).
  { apply On in A0, A1. rewrite Z0 in A0. rewrite Z1 in A1. assert (E : dot u m = / 2 * (dot u p0 + dot u p1)).
    { unfold m. clear. generalize u. intros. vdestruct; vunfold; field. }
    lra. }
  set (y := vadd m (vscale e (vsub q m))) in *.
  assert (Ey : dot u y - k = e * (dot u q - k)).
  { transitivity (dot u m - k + e * (dot u q - dot u m)); [|rewrite M; ring]. unfold y. clear. generalize u m. intros.
    vdestruct; vunfold; ring. }
  assert (Ly : dot u y <= k) by (apply (conv_below u k t); auto; intros v Hv; apply D; auto).
  assert (Lq : dot u q <= k) by (apply Rnot_lt_le; intro; nra).
  assert (Gq := G q). unfold power in Gq.
  destruct (Rlt_dec 0 (h p0 p1 q)) as [Pos|Neg]; auto. exfalso.
  assert (Eq : dot u q = k) by lra. assert (Hz : h p0 p1 q = 0) by lra.
  assert (Yk : dot u y = k) by (rewrite Eq in Ey; lra).
  assert (Line : in_conv [p0; p1] y).
  { apply (conv_incl (filter (on_plane u (dot u y)) t)).
    - intros v Hv. apply on_plane_right in Hv. destruct Hv as [Hv Ev]. rewrite Yk in Ev.
      destruct (proj2 (D v Hv) Ev); simpl; auto.
    - apply conv_on_plane; auto. intros v Hv. rewrite Yk. apply D; auto. }
  destruct (h_on_line p0 p1 q e) as [E|E]; auto. lra.
Qed.

Theorem gabriel_at_edge : forall P T t0 i j p0 p1, NoDup P -> i <> j -> point_at P i p0 -> point_at P j p1 ->
  delaunay_triangulation P T -> In t0 T -> at_edge p0 p1 t0 ->
  (critical P (midpoint p0 p1) [i; j] 1 <->
   forall t q, In t T -> at_edge p0 p1 t -> In q t -> q <> p0 -> q <> p1 -> 0 < h p0 p1 q).
Proof.
  intros P T t0 i j p0 p1 D N E0 E1 DT H0 A. rewrite gabriel by auto. split.
  - intros H t q Ht _ Hq. apply H. apply (vertices_are_samples P T DT). exists t. auto.
  - intros H q Hq N0 N1. assert (N01 : p0 <> p1) by (intros <-; apply N; eapply point_at_once; eauto).
    destruct (star_of_edge P T t0 p0 p1 q DT H0 A N01 Hq) as [t [e [Ht [At [He Y]]]]].
    destruct (spheres_exist P T DT t Ht) as [z [r2 S]].
    apply (cell_at_edge t z r2 p0 p1 q e); auto; [| | |apply He].
    + intros v Hv. apply Rminus_diag_eq, S, Hv.
    + apply (spheres_are_empty P T DT t); auto.
    + intros v Hv. apply (H t); auto.
Qed.
