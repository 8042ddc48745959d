(* The driver (FC-DIST-02): the point of a hull that is nearest to x. There is exactly one.
   It is the centre of the smallest ball that encloses the points, if these are at one distance from x. *)
From Coq Require Import Reals ZArith Lra Lia List.
From Flowcert Require Import algebra.Vector3 spec.Hull spec.HalfSpace spec.CriticalPoint spec.Dimension
  spec.Stationary.
Import ListNotations.
Open Scope R_scope.

Definition nearest_in_hull C x c := in_conv C c /\ forall y, in_conv C y -> dist2 x c <= dist2 x y.

(* C has the points of the contact set of x. *)
Definition contacts P x C := forall p, In p C <-> nearest P x p.
Definition driver P x c := exists C, contacts P x C /\ nearest_in_hull C x c.

(* ---- What tells the nearest point ---- *)

Theorem nearest_iff_angles : forall C x c, in_conv C c ->
  (nearest_in_hull C x c <-> forall p, In p C -> dot (vsub x c) (vsub p c) <= 0).
Proof.
  intros C x c H. split.
  - intros [_ N] p Hp. apply Rnot_lt_le. intro P. set (k := dot (vsub x c) (vsub p c)) in *.
    set (d := dist2 p c). assert (D : 0 <= d) by apply dot_self_nonneg.
    (* a small step towards p comes nearer *)
    set (a := Rmin 1 (k / (d + 1))).
    assert (Ha : 0 < a) by (apply Rmin_pos; [lra | apply Rdiv_lt_0_compat; lra]).
    assert (Ha1 : a <= 1) by apply Rmin_l.
    assert (Had : a * d < 2 * k).
    { assert (a <= k / (d + 1)) by apply Rmin_r. assert (k / (d + 1) * (d + 1) = k) by (field; lra). nra. }
    assert (Q := N _ (conv_between C c p a H (point_in_conv C p Hp) (conj (Rlt_le _ _ Ha) Ha1))).
    assert (E : dist2 x (vadd c (vscale a (vsub p c))) = dist2 x c - 2 * a * k + a * (a * d)).
    { unfold k, d. clear. generalize a. intros. vdestruct; vunfold; ring. }
    nra.
  - intros A. split; auto. intros y Hy.
    assert (B : dot (vsub x c) y <= dot (vsub x c) c).
    { apply (conv_below _ _ C); auto. intros p Hp. specialize (A p Hp). apply Rminus_le.
      replace (dot (vsub x c) p - dot (vsub x c) c) with (dot (vsub x c) (vsub p c)); auto.
      clear. vdestruct; vunfold; ring. }
    assert (E : dist2 x y = dist2 x c - 2 * (dot (vsub x c) y - dot (vsub x c) c) + dist2 y c)
      by (clear; vdestruct; vunfold; ring).
    generalize (dot_self_nonneg (vsub y c)). fold (dist2 y c). lra.
Qed.

Lemma nearest_unique : forall C x c c', nearest_in_hull C x c -> nearest_in_hull C x c' -> c = c'.
Proof.
  intros C x c c' [H N] [H' N'].
  assert (M := conv_between C c c' (/ 2) H H' ltac:(lra)). apply N in M. specialize (N' c H).
  apply dist2_zero. apply Rle_antisym; [|apply dot_self_nonneg].
  assert (E : dist2 x (vadd c (vscale (/ 2) (vsub c' c))) = / 2 * dist2 x c + / 2 * dist2 x c' - / 4 * dist2 c c').
  { clear. vdestruct; vunfold; field. }
  lra.
Qed.
Lemma nearest_same : forall C D x c, incl C D -> incl D C -> nearest_in_hull C x c -> nearest_in_hull D x c.
Proof.
  intros C D x c I J [H N]. split; [apply (conv_incl C); auto|]. intros y Hy. apply N. apply (conv_incl D); auto.
Qed.

(* ---- There is one ---- *)

(* The point of the affine hull that is nearest to x. *)
Lemma foot : forall C x p, In p C ->
  exists q, in_aff C q /\ forall y, in_aff C y -> dist2 x y = dist2 x q + dist2 q y.
Proof.
  intros C x p Hp. destruct (span_bound (map (fun q => vsub q p) C)) as [_ F].
  destruct (F (vsub x p)) as [s [[c [L E]] O]]. rewrite map_length in L.
  destruct (unit_weights C p Hp) as [e [Le [_ [Se Ee]]]].
  assert (Q : in_aff C (vadd p s)).
  { exists (ladd c (lscale (1 - sum c) e)). repeat split.
    - apply ladd_length; rewrite ?lscale_length; auto.
    - rewrite sum_ladd, sum_lscale, Se by (rewrite lscale_length; congruence). ring.
    - rewrite comb_ladd, comb_lscale, Ee by (rewrite ?lscale_length; auto). rewrite <- E, comb_shift by auto.
      apply vec_eq; simpl; ring. }
  exists (vadd p s). split; auto.
  assert (G : forall y, in_aff C y -> dot (vsub (vsub x p) s) (vsub y p) = 0).
  { intros y [w [Lw [Sw Ew]]]. apply O. exists w. split; [rewrite map_length; auto|].
    rewrite comb_shift, Sw, Ew by auto. apply vec_eq; simpl; ring. }
  intros y Hy. apply G in Hy. apply G in Q. clear - Hy Q. apply Rminus_diag_uniq.
  transitivity (2 * (dot (vsub (vsub x p) s) (vsub (vadd p s) p) - dot (vsub (vsub x p) s) (vsub y p)));
    [|rewrite Hy, Q; ring]. clear. vdestruct; vunfold; ring.
Qed.

(* No weight of w is negative. On the way from w to v a first one becomes 0, or none becomes negative. *)
Definition mix s w v := ladd (lscale (1 - s) w) (lscale s v).
Lemma mix_1 : forall w v, length w = length v -> mix 1 w v = v.
Proof.
  unfold mix. induction w as [|a w IH]; intros [|b v] L; simpl in *; try discriminate; auto.
  f_equal; [ring | auto].
Qed.
Lemma exit_time : forall w v, length w = length v -> Forall (fun a => 0 <= a) w ->
  exists s, 0 <= s <= 1 /\ Forall (fun a => 0 <= a) (mix s w v) /\ (s = 1 \/ In 0 (mix s w v)).
Proof.
  induction w as [|a w IH]; intros [|b v] L N; try discriminate.
  - exists 1. repeat split; auto; lra.
  - inversion N as [|a' w' Ha Hw]; subst. destruct (IH v) as [s [Hs [M Z]]]; auto.
    destruct (Rle_dec 0 ((1 - s) * a + s * b)) as [P|P].
    + exists s. unfold mix in *. simpl. repeat split; auto; try lra. tauto.
    + assert (B : b < a) by nra. set (r := a / (a - b)).
      assert (Er : (1 - r) * a + r * b = 0) by (unfold r; field; lra).
      assert (Rr : 0 <= r) by (apply Rmult_le_pos; [lra | left; apply Rinv_0_lt_compat; lra]).
      assert (Ra : r * (a - b) = a) by (unfold r; field; lra).
      assert (Rs : r <= s) by (apply Rnot_lt_le; intro; nra).
      exists r. unfold mix in *. simpl. rewrite Er. repeat split; auto; try lra. constructor; [lra|].
      injection L; intro L'. clear - M Hw Rr Rs Hs L'. revert v L' M.
      induction Hw as [|c w Hc Hw IH]; intros [|d v] L M; simpl in *; try discriminate; constructor;
        inversion M; subst; auto.
      replace ((1 - r) * c + r * d) with (c + r * (d - c)) by ring.
      destruct (Rle_dec 0 (d - c)); [assert (0 <= r * (d - c)) by (apply Rmult_le_pos; auto); lra|].
      assert (0 <= (s - r) * (c - d)) by (apply Rmult_le_pos; lra). lra.
Qed.

(* The lists that lack one of the points. *)
Fixpoint without_one (C : list vec) :=
  match C with [] => [] | p :: C' => C' :: map (cons p) (without_one C') end.
Lemma without_one_in : forall C1 p C2, In (C1 ++ C2) (without_one (C1 ++ p :: C2)).
Proof.
  induction C1 as [|q C1 IH]; intros p C2; simpl; [left; auto|]. right. apply in_map, IH.
Qed.
Lemma without_one_right : forall C D, In D (without_one C) -> length C = S (length D) /\ incl D C.
Proof.
  induction C as [|p C IH]; intros D H; [destruct H|]. destruct H as [<-|H].
  - split; auto. intros q Hq. right. auto.
  - apply in_map_iff in H. destruct H as [D' [<- H]]. apply IH in H. destruct H as [L I]. simpl. split; [lia|].
    intros q [<-|Hq]; [left | right]; auto.
Qed.

(* One of finitely many hulls has the point that is nearest to x of all. *)
Lemma nearest_of_all : forall x Ds, Ds <> [] -> (forall D, In D Ds -> exists c, nearest_in_hull D x c) ->
  exists D c, In D Ds /\ in_conv D c /\ forall D' y, In D' Ds -> in_conv D' y -> dist2 x c <= dist2 x y.
Proof.
  induction Ds as [|D Ds IH]; intros H E; [congruence|].
  destruct (E D (or_introl eq_refl)) as [c [Hc N]]. destruct Ds as [|D0 Ds].
  - exists D, c. split; [left; auto|]. split; auto. intros D' y [<-|[]]; auto.
  - destruct IH as [D1 [c1 [H1 [Hc1 N1]]]]; [discriminate | intros; apply E; right; auto |].
    destruct (Rle_dec (dist2 x c) (dist2 x c1)) as [Le|Gt].
    + exists D, c. split; [left; auto|]. split; auto. intros D' y [<-|H'] Hy; auto.
      apply Rle_trans with (dist2 x c1); eauto.
    + exists D1, c1. split; [right; auto|]. split; auto. intros D' y [<-|H'] Hy; [|eauto].
      apply N in Hy. lra.
Qed.

(* A weight of 0 leaves a hull of fewer points. *)
Lemma drop_zero : forall C w, length w = length C -> Forall (fun a => 0 <= a) w -> In 0 w ->
  exists D v, In D (without_one C) /\ length v = length D /\ Forall (fun a => 0 <= a) v /\ sum v = sum w /\
    comb v D = comb w C.
Proof.
  intros C w L N Z. apply in_split in Z. destruct Z as [m1 [m2 ->]]. rewrite app_length in L. simpl in L.
  assert (Split : exists C1 r C2, C = C1 ++ r :: C2 /\ length C1 = length m1).
  { assert (L1 : length (firstn (length m1) C) = length m1) by (rewrite firstn_length; lia).
    destruct (skipn (length m1) C) as [|r C2] eqn:E.
    - exfalso. apply (f_equal (@length vec)) in E. rewrite skipn_length in E. simpl in E. lia.
    - exists (firstn (length m1) C), r, C2. rewrite <- E, firstn_skipn. auto. }
  destruct Split as [C1 [r [C2 [-> L1]]]]. exists (C1 ++ C2), (m1 ++ m2).
  split; [apply without_one_in|].
  rewrite app_length in L. simpl in L. rewrite Forall_app in N. destruct N as [N1 N2]. inversion N2; subst.
  repeat split.
  - rewrite !app_length. lia.
  - apply Forall_app. auto.
  - clear. induction m1; simpl; [ring | rewrite IHm1; ring].
  - rewrite !comb_app by auto. simpl. apply vec_eq; simpl; ring.
Qed.

(* From a point y of the hull the way to v, which is outside, leads out of it: to a hull of fewer points. *)
Lemma way_out : forall C w v, length w = length C -> Forall (fun a => 0 <= a) w -> sum w = 1 ->
  length v = length C -> sum v = 1 -> ~ Forall (fun a => 0 <= a) v ->
  exists s D, 0 <= s <= 1 /\ In D (without_one C) /\
    in_conv D (vadd (comb w C) (vscale s (vsub (comb v C) (comb w C)))).
Proof.
  intros C w v Lw Nw Sw Lv Sv Nv.
  destruct (exit_time w v) as [s [Hs [M Z]]]; [congruence | auto |].
  assert (Lm : length (mix s w v) = length C) by (apply ladd_length; rewrite lscale_length; auto).
  assert (Sm : sum (mix s w v) = 1).
  { unfold mix. rewrite sum_ladd, !sum_lscale, Sv, Sw by (rewrite !lscale_length; congruence). ring. }
  assert (Em : comb (mix s w v) C = vadd (comb w C) (vscale s (vsub (comb v C) (comb w C)))).
  { unfold mix. rewrite comb_ladd, !comb_lscale by (rewrite ?lscale_length; auto). apply vec_eq; simpl; ring. }
  destruct Z as [->|Z].
  - exfalso. apply Nv. rewrite mix_1 in M by congruence. exact M.
  - destruct (drop_zero C (mix s w v)) as [D [x [HD [Lx [Nx [Sx Ex]]]]]]; auto. exists s, D. rewrite <- Em.
    split; auto. split; auto. exists x. rewrite Sx. auto.
Qed.

Theorem nearest_exists : forall C x p, In p C -> exists c, nearest_in_hull C x c.
Proof.
  intros C. remember (length C) as n eqn:Hn. revert C Hn.
  induction n as [|n IH]; intros C Hn x p Hp; [destruct C; [destruct Hp | discriminate]|].
  destruct (foot C x p Hp) as [q [[v [Lv [Sv Ev]]] Q]].
  destruct (Forall_dec (fun a => 0 <= a) (Rle_dec 0) v) as [Nv|Nv].
  { exists q. split; [exists v; auto|]. intros y Hy. rewrite (Q y (conv_in_aff C y Hy)).
    generalize (dot_self_nonneg (vsub q y)). fold (dist2 q y). lra. }
  assert (Way : forall y, in_conv C y -> exists D z, In D (without_one C) /\ in_conv D z /\ dist2 x z <= dist2 x y).
  { intros y Hy. destruct (Hy) as [w [Lw [Nw [Sw Ew]]]].
    destruct (way_out C w v) as [s [D [Hs [HD Hz]]]]; auto. rewrite Ew, Ev in Hz.
    set (z := vadd y (vscale s (vsub q y))) in *. exists D, z. repeat split; auto.
    assert (Az : in_aff C z) by (apply (aff_incl D); [apply without_one_right; auto | apply conv_in_aff; auto]).
    rewrite (Q y (conv_in_aff C y Hy)), (Q z Az).
    assert (E : dist2 q z = (1 - s) * (1 - s) * dist2 q y) by (unfold z; clear; vdestruct; vunfold; ring).
    rewrite E. assert (P : 0 <= dist2 q y) by apply dot_self_nonneg.
    assert (S1 : (1 - s) * (1 - s) <= 1) by nra. clear - P S1.
    generalize (Rmult_le_compat_r _ _ _ P S1). lra. }
  assert (Hull : forall D z, In D (without_one C) -> in_conv D z ->
    In D (filter (fun D => negb (Nat.eqb (length D) 0)) (without_one C))).
  { intros D z HD Hz. apply filter_In. split; auto. destruct (hull_nonempty D z Hz) as [d Hd].
    destruct D; [destruct Hd | auto]. }
  destruct (nearest_of_all x (filter (fun D => negb (Nat.eqb (length D) 0)) (without_one C))) as [D [c [HD [Hc N]]]].
  - destruct (Way p (point_in_conv C p Hp)) as [D [z [HD [Hz _]]]]. intro E.
    generalize (Hull D z HD Hz). rewrite E. intros [].
  - intros D HD. apply filter_In in HD. destruct HD as [HD Ne]. apply without_one_right in HD. destruct HD as [L _].
    destruct D as [|d D]; [discriminate|]. apply (IH (d :: D) ltac:(simpl in *; lia) x d). left. auto.
  - apply filter_In in HD. destruct HD as [HD _]. apply without_one_right in HD. destruct HD as [_ I].
    exists c. split; [apply (conv_incl D); auto|]. intros y Hy. destruct (Way y Hy) as [D' [z [HD' [Hz Le]]]].
    apply Rle_trans with (dist2 x z); [apply (N D'); eauto | exact Le].
Qed.

(* ---- The driver ---- *)

Lemma least : forall (f : vec -> R) P, P <> [] -> exists p, In p P /\ forall q, In q P -> f p <= f q.
Proof.
  induction P as [|p P IH]; intros H; [congruence|]. destruct P as [|p' P].
  - exists p. split; [left; auto|]. intros q [<-|[]]. lra.
  - destruct IH as [r [Hr L]]; [discriminate|]. destruct (Rle_dec (f p) (f r)) as [Le|Gt].
    + exists p. split; [left; auto|]. intros q [<-|Hq]; [lra|]. apply L in Hq. lra.
    + exists r. split; [right; auto|]. intros q [<-|Hq]; [lra | auto].
Qed.
Lemma contacts_exist : forall P x, P <> [] -> exists C p, contacts P x C /\ In p C.
Proof.
  intros P x H. destruct (least (dist2 x) P H) as [p [Hp L]].
  exists (filter (fun q => if Req_EM_T (dist2 x q) (dist2 x p) then true else false) P), p.
  assert (E : forall q, In q (filter (fun q => if Req_EM_T (dist2 x q) (dist2 x p) then true else false) P) <->
    In q P /\ dist2 x q = dist2 x p).
  { intros q. rewrite filter_In. destruct (Req_EM_T (dist2 x q) (dist2 x p)); intuition congruence. }
  split; [|apply E; auto]. intros q. rewrite E. split.
  - intros [Hq Eq]. split; auto. intros r Hr. rewrite Eq. auto.
  - intros [Hq Nq]. split; auto. apply Rle_antisym; auto.
Qed.

Theorem driver_exists : forall P x, P <> [] -> exists c, driver P x c.
Proof.
  intros P x H. destruct (contacts_exist P x H) as [C [p [HC Hp]]]. destruct (nearest_exists C x p Hp) as [c Hc].
  exists c, C. auto.
Qed.
Theorem driver_unique : forall P x c c', driver P x c -> driver P x c' -> c = c'.
Proof.
  intros P x c c' [C [HC N]] [D [HD N']]. apply (nearest_unique C x); auto.
  apply (nearest_same D); auto; intros p Hp; [apply HC, HD | apply HD, HC]; auto.
Qed.

(* FC-DIST-02: it is also the centre of the smallest ball. *)
Theorem driver_is_centre_of_ball : forall P x c, driver P x c ->
  exists C r, contacts P x C /\ (forall p, In p C -> dist2 c p <= r) /\
    forall z s, (forall p, In p C -> dist2 z p <= s) -> r + dist2 c z <= s.
Proof.
  intros P x c [C [HC [H N]]]. destruct (hull_nonempty C c H) as [p0 H0].
  set (d := dist2 x p0). assert (D : forall p, In p C -> dist2 x p = d).
  { intros p Hp. apply HC in Hp, H0. destruct Hp as [Ip Np], H0 as [I0 N0]. unfold d.
    apply Rle_antisym; [apply Np | apply N0]; auto. }
  clearbody d. exists C, (d - dist2 x c). split; auto.
  assert (A := proj1 (nearest_iff_angles C x c H) (conj H N)). split.
  - intros p Hp. specialize (A p Hp). rewrite <- (D p Hp). revert A. clear. vdestruct; vunfold. lra.
  - intros z s Z. (* the mean of the squared distances from z, with the weights of c, is d - |x - c|^2 + |c - z|^2 *)
    assert (B : forall p, In p C -> dot (vscale 2 (vsub x z)) p <= s - d + dot x x - dot z z).
    { intros p Hp. specialize (Z p Hp). specialize (D p Hp). rewrite <- D. revert Z. clear. vdestruct; vunfold. lra. }
    apply (conv_below _ _ C c B) in H. revert H. clear. generalize d. intros. vdestruct; vunfold. lra.
Qed.
