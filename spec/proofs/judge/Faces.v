(* Weights and a linear form that the judge accepts tell the kind of a stationary point: where the form is least on the
   contact set, there is a face of its hull, and the weights put the point in the relative interior of that face. *)
From Coq Require Import Reals ZArith Lra Lia List Bool.
From Flowcert Require Import algebra.Vector3 spec.Hull spec.CriticalPoint spec.StationaryPoint judge.Judge
  judge.Dimension.
Import ListNotations.
Open Scope R_scope.

(* ---- Weights ---- *)

(* The place c / W, on a grid of the unit s. *)
Definition center_at s W c := vscale (s / IZR W) (emb c).

Lemma positive_combination : forall s W c v F, (0 < W)%Z -> length v = length F -> Forall (fun a => (0 < a)%Z) v ->
  zsum v = W -> zcomb v F = c -> in_relint (map (scaled s) F) (center_at s W c).
Proof.
  intros s W c v F HW HL HP HS HC. assert (WR : 0 < IZR W) by (apply IZR_lt; auto).
  apply positive_weights_sound. exists (map (fun a => IZR a / IZR W) v). repeat split.
  - rewrite !map_length. auto.
  - apply Forall_forall. intros a Ha. apply in_map_iff in Ha. destruct Ha as [b [<- Hb]].
    rewrite Forall_forall in HP. apply Rdiv_lt_0_compat; auto. apply IZR_lt, HP, Hb.
  - rewrite emb_sum, HS by lra. field. lra.
  - unfold scaled. rewrite <- (map_map emb (vscale s)), comb_scaled, emb_comb, HC by lra.
    unfold center_at. apply vec_eq; simpl; field; lra.
Qed.

(* ---- Faces ---- *)

Lemma height_right : forall s W n c p, (0 < W)%Z ->
  dot (emb n) (scaled s p) - dot (emb n) (center_at s W c) = s / IZR W * IZR (height W n c p).
Proof.
  intros s W n c p HW. apply IZR_lt in HW. unfold height, scaled, center_at.
  rewrite minus_IZR, mult_IZR, !emb_dot. unfold dot, vscale; simpl. field. lra.
Qed.

Lemma fitting_weights : forall W n c w C, weights_fit W n c w C = true ->
  (forall p, In p C -> (0 <= height W n c p)%Z) /\
  exists v, length v = length (filter (on_face W n c) C) /\ Forall (fun a => (0 < a)%Z) v /\
    zsum v = zsum w /\ zcomb v (filter (on_face W n c) C) = zcomb w C.
Proof.
  intros W n c. induction w as [|a w IH]; intros [|p C] H; simpl in H; try discriminate.
  - split; [intros p []|]. exists []. simpl. auto.
  - apply andb_true_iff in H. destruct H as [H1 H2]. destruct (IH C H2) as [I1 [v [V1 [V2 [V3 V4]]]]].
    assert (On : on_face W n c p = (height W n c p =? 0)%Z) by reflexivity.
    simpl filter. rewrite On in H1 |- *. clear On. destruct (Z.eqb_spec (height W n c p) 0) as [E|E].
    + apply Z.ltb_lt in H1. split; [intros q [<-|Hq]; [lia | auto]|].
      exists (a :: v). simpl. rewrite V1, V3, V4. auto.
    + rewrite andb_true_iff, Z.ltb_lt, Z.eqb_eq in H1. destruct H1 as [H1 ->].
      split; [intros q [<-|Hq]; [lia | auto]|]. exists v. split; [auto|]. split; [auto|]. split; [simpl; auto|].
      simpl. rewrite V4. destruct (zcomb w C). unfold zadd, zscale; simpl. reflexivity.
Qed.

(* A combination of points at which a form is at least h. *)
Lemma least_of_combination : forall n h w C, length w = length C -> Forall (fun a => 0 <= a) w ->
  (forall p, In p C -> h <= dot n p) -> h * sum w <= dot n (comb w C).
Proof.
  intros n h. induction w as [|a w IH]; intros [|p C] L H HC; simpl in *; try discriminate.
  - unfold dot, vzero; simpl. lra.
  - inversion H as [|? ? Ha Hw]; subst. assert (I := IH C ltac:(lia) Hw (fun q Hq => HC q (or_intror Hq))).
    assert (P := HC p (or_introl eq_refl)). assert (h * a <= dot n p * a) by (apply Rmult_le_compat_r; auto).
    replace (dot n (vadd (vscale a p) (comb w C))) with (dot n p * a + dot n (comb w C))
      by (unfold dot, vadd, vscale; simpl; ring). lra.
Qed.

Lemma only_on_face : forall n h w C, length w = length C -> Forall (fun a => 0 < a) w ->
  (forall p, In p C -> h <= dot n p) -> dot n (comb w C) = h * sum w -> forall p, In p C -> dot n p = h.
Proof.
  intros n h. induction w as [|a w IH]; intros [|p C] L H HC E q Hq; simpl in *; try discriminate; [contradiction|].
  inversion H as [|? ? Ha Hw]; subst.
  assert (Hw' : Forall (fun a => 0 <= a) w) by (eapply Forall_impl; [|exact Hw]; intros; simpl in *; lra).
  assert (HC' : forall q, In q C -> h <= dot n q) by auto.
  assert (I := least_of_combination n h w C ltac:(lia) Hw' HC'). assert (P := HC p (or_introl eq_refl)).
  replace (dot n (vadd (vscale a p) (comb w C))) with (dot n p * a + dot n (comb w C)) in E
    by (unfold dot, vadd, vscale; simpl; ring).
  assert (h * a <= dot n p * a) by (apply Rmult_le_compat_r; lra).
  destruct Hq as [<-|Hq].
  - apply Rmult_eq_reg_r with a; lra.
  - apply (IH C); auto; lra.
Qed.

Section Supported.
Variables (A : Type) (at_point : A -> vec) (on : A -> bool) (n : vec) (h : R).

Lemma wider_combination : forall l v, length v = length (filter on l) -> Forall (fun a => 0 <= a) v ->
  exists w, length w = length l /\ Forall (fun a => 0 <= a) w /\ sum w = sum v /\
    comb w (map at_point l) = comb v (map at_point (filter on l)).
Proof.
  induction l as [|a l IH]; intros v L H; simpl in *.
  - exists []. destruct v; [auto | discriminate].
  - destruct (on a); simpl in L.
    + destruct v as [|b v]; [discriminate|]. inversion H; subst. destruct (IH v) as [w [W1 [W2 [W3 W4]]]]; auto.
      exists (b :: w). simpl. rewrite W1, W3, W4. auto.
    + destruct (IH v) as [w [W1 [W2 [W3 W4]]]]; auto. exists (0 :: w). simpl. rewrite W1, W3, W4.
      split; auto. split; [constructor; [lra | auto]|]. split; [lra|]. apply vec_eq; simpl; ring.
Qed.

Lemma narrower_combination : forall l w, length w = length l -> Forall (fun a => 0 <= a) w ->
  (forall a, In a l -> h <= dot n (at_point a) /\ (on a = true <-> dot n (at_point a) = h)) ->
  dot n (comb w (map at_point l)) = h * sum w ->
  exists v, length v = length (filter on l) /\ Forall (fun a => 0 <= a) v /\ sum v = sum w /\
    comb v (map at_point (filter on l)) = comb w (map at_point l).
Proof.
  induction l as [|a l IH]; intros [|b w] L H HC E; simpl in *; try discriminate; [exists []; auto|].
  inversion H as [|? ? Hb Hw]; subst. destruct (HC a (or_introl eq_refl)) as [P On].
  assert (I : h * sum w <= dot n (comb w (map at_point l))).
  { apply least_of_combination; [rewrite map_length; lia | auto|].
    intros p Hp. apply in_map_iff in Hp. destruct Hp as [c [<- Hc]]. apply HC; auto. }
  replace (dot n (vadd (vscale b (at_point a)) (comb w (map at_point l))))
    with (dot n (at_point a) * b + dot n (comb w (map at_point l))) in E by (unfold dot, vadd, vscale; simpl; ring).
  assert (h * b <= dot n (at_point a) * b) by (apply Rmult_le_compat_r; auto).
  destruct (IH w) as [v [V1 [V2 [V3 V4]]]]; auto; try lra.
  destruct (on a) eqn:F.
  - exists (b :: v). simpl. rewrite V1, V3, V4. auto.
  - exists v. rewrite V1, V3, V4. assert (b = 0).
    { assert (dot n (at_point a) <> h) by (intro Q; apply On in Q; discriminate).
      apply Rmult_eq_reg_l with (dot n (at_point a) - h); [lra | intro; apply H1; lra]. }
    subst b. split; auto. split; auto. split; [lra|]. apply vec_eq; simpl; ring.
Qed.

Lemma supported_face : forall l,
  (forall a, In a l -> h <= dot n (at_point a) /\ (on a = true <-> dot n (at_point a) = h)) ->
  hull_face (map at_point l) (map at_point (filter on l)).
Proof.
  intros l HC. exists n, h. split.
  - intros y [w [L [P [S E]]]]. rewrite <- E, <- (Rmult_1_r h), <- S. apply least_of_combination; auto.
    intros p Hp. apply in_map_iff in Hp. destruct Hp as [a [<- Ha]]. apply HC; auto.
  - intros y. split.
    + intros [v [L [P [S E]]]]. rewrite map_length in L. split.
      * destruct (wider_combination l v) as [w [W1 [W2 [W3 W4]]]]; auto.
        exists w. rewrite map_length, W3, W4. auto.
      * rewrite <- E. clear E y. rewrite <- (Rmult_1_r h), <- S. clear S P. revert v L.
        induction l as [|a l IH]; intros v L; simpl in *.
        { destruct v; [simpl; unfold dot, vzero; simpl; ring | discriminate]. }
        destruct (HC a (or_introl eq_refl)) as [_ On]. destruct (on a); simpl in *; [|apply IH; auto].
        destruct v as [|b v]; [discriminate|]. simpl in *.
        replace (dot n (vadd (vscale b (at_point a)) (comb v (map at_point (filter on l)))))
          with (dot n (at_point a) * b + dot n (comb v (map at_point (filter on l))))
          by (unfold dot, vadd, vscale; simpl; ring).
        rewrite IH by auto. destruct On as [On _]. rewrite On by auto. ring.
    + intros [[w [L [P [S E]]]] D]. rewrite map_length in L.
      destruct (narrower_combination l w) as [v [V1 [V2 [V3 V4]]]]; auto.
      * rewrite E, S, D. ring.
      * exists v. rewrite map_length, V1, V3, V4. auto.
Qed.
End Supported.

(* ---- Kinds ---- *)

Lemma kind_right : forall s W n c w C k, 0 < s -> (0 < W)%Z -> zsum w = W -> zcomb w C = c ->
  weights_fit W n c w C = true -> kind_checked W n c C k = true ->
  has_kind (map (scaled s) C) (center_at s W c) k.
Proof.
  intros s W n c w C k Hs HW HS HC Hfit Hk.
  destruct (fitting_weights _ _ _ _ _ Hfit) as [Low [v [V1 [V2 [V3 V4]]]]]. rewrite HS in V3. rewrite HC in V4.
  assert (In_face : in_relint (map (scaled s) (filter (on_face W n c) C)) (center_at s W c))
    by (eapply positive_combination; eauto).
  assert (K0 : 0 < s / IZR W) by (apply Rdiv_lt_0_compat; [auto | apply IZR_lt; auto]).
  set (h := dot (emb n) (center_at s W c)).
  assert (Support : forall p, In p C -> h <= dot (emb n) (scaled s p) /\
            (on_face W n c p = true <-> dot (emb n) (scaled s p) = h)).
  { intros p Hp. assert (E := height_right s W n c p HW). fold h in E. assert (L := Low p Hp). apply IZR_le in L.
    assert (0 <= s / IZR W * IZR (height W n c p)) by (apply Rmult_le_pos; lra).
    split; [lra|]. unfold on_face. rewrite Z.eqb_eq. split.
    - intros Z. rewrite Z in E. lra.
    - intros Z. rewrite Z in E. apply eq_IZR. apply Rmult_eq_reg_l with (s / IZR W); lra. }
  assert (S0 : s <> 0) by lra.
  assert (F := supported_face _ (scaled s) (on_face W n c) (emb n) h C Support).
  destruct k as [i|i j]; simpl in *; rewrite ?andb_true_iff in Hk.
  - destruct Hk as [H1 H2]. split; [|apply has_dimension_right; auto].
    rewrite forallb_forall in H1. replace (filter (on_face W n c) C) with C in In_face; [auto|].
    symmetry. apply (proj2 (filter_ext_in_iff _ (fun _ => true) C)) in H1. rewrite H1. clear.
    induction C; simpl; congruence.
  - destruct Hk as [[H1 H2] H3]. split; [|split; [|split]].
    + destruct F as [m [h' [_ F]]]. apply (F (center_at s W c)). destruct In_face; auto.
    + intros H. apply positive_weights_complete in H. destruct H as [u [U1 [U2 [U3 U4]]]].
      apply negb_true_iff in H1. apply not_true_iff_false in H1. apply H1, forallb_forall. intros p Hp.
      apply Support; auto. apply (only_on_face (emb n) h u (map (scaled s) C)); auto.
      * intros q Hq. apply in_map_iff in Hq. destruct Hq as [a [<- Ha]]. apply Support; auto.
      * rewrite U3, U4. unfold h. ring.
      * apply in_map; auto.
    + apply has_dimension_right; auto.
    + exists (map (scaled s) (filter (on_face W n c) C)). split; auto. split; auto. apply has_dimension_right; auto.
Qed.
