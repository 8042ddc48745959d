(* The simplices that the checker lists are those of FC-CERT-03, each once, and its contact sets are right. *)
From Coq Require Import Reals ZArith Lra Lia List Bool Permutation Sorting.
From Flowcert Require Import algebra.Vector3 spec.Hull spec.HalfSpace algebra.Sphere spec.CriticalPoint
  spec.Stationary judge.Judge judge.Dimension.
From Flowcert Require Import checker.Simplices checker.Certificate checker.Conditions checker.Faces.
From Flowcert Require Import checker.StationaryList checker.Affine checker.Volumes checker.Tiling checker.Delaunay.
From Flowcert Require Import checker.StationarySimplices checker.Centres checker.Sound.
Import ListNotations.
Open Scope R_scope.

(* ---- Sublists ---- *)

Lemma sublists_incl : forall l s, In s (sublists l) -> incl s l.
Proof.
  induction l as [|a l IH]; intros s H; simpl in H.
  - destruct H as [<-|[]]. intros x [].
  - apply in_app_or in H. destruct H as [H|H].
    + apply in_map_iff in H. destruct H as [t [<- H]]. intros x [->|Hx]; [left; auto | right; apply (IH t); auto].
    + intros x Hx. right. apply (IH s); auto.
Qed.
Lemma sublists_nodup : forall l s, NoDup l -> In s (sublists l) -> NoDup s.
Proof.
  induction l as [|a l IH]; intros s N H; simpl in H.
  - destruct H as [<-|[]]. constructor.
  - inversion N as [|? ? Na Nl]; subst. apply in_app_or in H. destruct H as [H|H]; [|apply IH; auto].
    apply in_map_iff in H. destruct H as [t [<- H]]. constructor; [|apply IH; auto].
    intro F. apply Na. apply (sublists_incl l t); auto.
Qed.
Lemma sublists_ascending : forall l s, StronglySorted le l -> In s (sublists l) -> StronglySorted le s.
Proof.
  induction l as [|a l IH]; intros s N H; simpl in H.
  - destruct H as [<-|[]]. constructor.
  - inversion N as [|? ? Nl Na]; subst. apply in_app_or in H. destruct H as [H|H]; [|apply IH; auto].
    apply in_map_iff in H. destruct H as [t [<- H]]. constructor; [apply IH; auto|].
    apply Forall_forall. intros x Hx. rewrite Forall_forall in Na. apply Na. apply (sublists_incl l t); auto.
Qed.
Lemma filter_in_sublists : forall f l, In (filter f l) (sublists l).
Proof.
  intros f. induction l as [|a l IH]; simpl; auto. apply in_or_app. destruct (f a); [left; apply in_map; auto | right;
    auto].
Qed.
Lemma insert_ascending : forall a l, StronglySorted le l -> StronglySorted le (insert a l).
Proof.
  intros a. induction l as [|b l IH]; intro S; simpl; [repeat constructor|].
  inversion S as [|? ? Sl Sb]; subst. rewrite Forall_forall in Sb. destruct (Nat.leb a b) eqn:E.
  - apply Nat.leb_le in E. constructor; auto. constructor; auto. apply Forall_forall. intros x Hx. apply Sb in Hx. lia.
  - apply Nat.leb_gt in E. constructor; auto. apply Forall_forall. intros x Hx.
    apply (Permutation_in _ (insert_permutation a l)) in Hx. destruct Hx as [<-|Hx]; [lia | auto].
Qed.
Lemma sorted_ascending : forall s, StronglySorted le (sorted s).
Proof. unfold sorted. induction s; simpl; [constructor | apply insert_ascending; auto]. Qed.
Lemma ascending_sorted : forall s, StronglySorted le s -> sorted s = s.
Proof.
  unfold sorted. induction 1 as [|a s S IH F]; simpl; auto. rewrite IH. destruct s as [|b s]; simpl; auto.
  inversion F as [|? ? B _]; subst. apply Nat.leb_le in B. rewrite B. auto.
Qed.

(* ---- Sums over fewer points ---- *)

Lemma total_permutation : forall u w f, Permutation u w -> total u f = total w f.
Proof. unfold total. induction 1; simpl; lra. Qed.
Lemma total_sub : forall s u f, NoDup s -> NoDup u -> incl s u -> (forall v, In v u -> ~ In v s -> f v = 0) ->
  total s f = total u f.
Proof.
  intros s u f Ns Nu I Z. set (g := fun v => if in_dec vec_eq_dec v s then true else false).
  rewrite <- (total_filter u g f).
  - apply total_permutation. apply NoDup_Permutation; auto; [apply NoDup_filter; auto|].
    intro v. rewrite filter_In. unfold g. destruct (in_dec vec_eq_dec v s); split; intros; auto; try tauto.
    destruct H. discriminate.
  - intros v Hv. unfold g. destruct (in_dec vec_eq_dec v s); [discriminate | intros _; apply Z; auto].
Qed.
Lemma weight_at : forall w s (h : vec -> R) a v, NoDup s -> length w = length s -> In (a, v) (combine w s) ->
  h v = 1 -> (forall p, In p s -> p <> v -> h p = 0) -> sum (map (fun '(a, p) => a * h p) (combine w s)) = a.
Proof.
  induction w as [|c w IH]; intros [|p s] h a v N L H One Zero; simpl in *; try contradiction; try discriminate.
  inversion N as [|? ? Np Ns]; subst. destruct H as [E|H].
  - injection E; intros; subst.
    assert (Z : sum (map (fun '(a, p) => a * h p) (combine w s)) = 0); [|rewrite Z, One; lra].
    assert (G : forall q, In q s -> h q = 0) by (intros q Hq; apply Zero; auto; congruence).
    clear - G. revert s G. induction w as [|c w IH]; intros [|q s] G; simpl; auto.
    rewrite IH by (intros; apply G; right; auto). rewrite (G q) by (left; auto). lra.
  - rewrite (IH s h a v) by auto. rewrite (Zero p); auto; [lra|].
    intros ->. apply Np. apply in_combine_r in H. auto.
Qed.
Lemma in_combine_left : forall (w : list R) (s : list vec) a, length w = length s -> In a w ->
  exists v, In (a, v) (combine w s).
Proof.
  induction w as [|c w IH]; intros [|p s] a L H; simpl in *; try contradiction; try discriminate.
  destruct H as [->|H]; [exists p; auto|]. destruct (IH s a) as [v Hv]; auto. exists v. auto.
Qed.

Section ListSound.
Variable rows : list zvec.
Variable first : simplex.
Variable cells : list simplex.
Hypothesis acc : accepted rows first cells.
Let P := samples rows.
Let real_cells := map (real rows) cells.
Let b := coordinate (emb (normal (places rows first))).
Let proper : proper_cells (in_conv P) affine P real_cells b := accepted_proper rows first cells acc.
Let local : local_delaunay P real_cells := accepted_local rows first cells acc.
Hypothesis glued : glued_cells (in_conv P) real_cells b.

Lemma listed_iff : forall s, In s (stationary_simplices rows cells) <->
  is_empty_at rows cells s = true /\ exists c, In c cells /\ In s (sublists (sorted c)) /\ (2 <= length s)%nat /\
    centre_is_inside (places rows s) = true.
Proof.
  intro s. unfold stationary_simplices, centred_simplices. rewrite filter_In, nodup_In, in_flat_map. split.
  - intros [[c [Hc H]] E]. split; auto. exists c. unfold centred_faces in H. apply filter_In in H.
    rewrite andb_true_iff, Nat.leb_le in H. tauto.
  - intros [E [c [Hc [H [L I]]]]]. split; auto. exists c. split; auto. unfold centred_faces. apply filter_In.
    rewrite andb_true_iff, Nat.leb_le. tauto.
Qed.

(* A face of a cell, as a list of samples in ascending order. *)
Definition listed_face c s := In c cells /\ In s (sublists (sorted c)) /\ (2 <= length s)%nat.
Lemma face_facts : forall c s, listed_face c s ->
  incl s c /\ NoDup s /\ (2 <= length s <= 4)%nat /\ sorted s = s /\ incl (real rows s) (real rows c) /\
  NoDup (real rows s).
Proof.
  intros c s [Hc [H L]].
  assert (Nc : NoDup c) by (apply (cell_of_nodup rows first cells acc); auto).
  assert (I : incl s c) by (intros x Hx; apply in_sorted; apply (sublists_incl _ s); auto).
  assert (N : NoDup s).
  { apply (sublists_nodup (sorted c)); auto.
    apply (Permutation_NoDup (Permutation_sym (sorted_is_permutation c))); auto. }
  split; auto. split; auto. split.
  { split; auto. generalize (NoDup_incl_length N I), (cell_length rows first cells acc c Hc). lia. }
  split. { apply ascending_sorted. apply (sublists_ascending (sorted c)); auto. apply sorted_ascending. }
  split. { apply incl_map. auto. }
  assert (In_names : forall p, In p s -> In p (names rows)) by (intros; apply (acc_names _ _ _ acc c); auto).
  clear - N In_names. unfold real. induction N as [|p s Hp N IH]; simpl; constructor.
  - intro F. apply in_map_iff in F. destruct F as [q [E Hq]]. apply Hp.
    replace p with q; auto. apply (place_injective rows); auto; apply In_names; simpl; auto.
  - apply IH. intros; apply In_names; right; auto.
Qed.

(* The volume of a face is not 0. *)
Lemma face_scale : forall c s, listed_face c s -> scale_of (places rows s) <> 0%Z.
Proof.
  intros c s F. destruct (face_facts c s F) as [_ [_ [L [_ [I N]]]]]. destruct F as [Hc _].
  assert (Hu : In (real rows c) real_cells) by (apply in_real_cells; eauto).
  assert (Form : forall v, In v (real rows s) -> exists g,
    forall w x, In w (real rows s) -> In x (real rows s) -> dot g (vsub w x) =
      (if vec_eq_dec w v then 1 else 0) - (if vec_eq_dec x v then 1 else 0)).
  { intros v Hv. destruct (coord_lin proper (real rows c) v Hu (I v Hv)) as [g [k G]]. exists g.
    assert (V : forall w, In w (real rows s) -> b (real rows c) v w = if vec_eq_dec w v then 1 else 0).
    { intros w Hw. destruct (vec_eq_dec w v) as [->|D].
      - apply (coord_one proper); auto.
      - apply (coord_zero proper); auto. }
    intros w x Hw Hx. rewrite <- (V w), <- (V x), !G by auto. clear. vdestruct; vunfold; ring. }
  intro K. unfold scale_of, places in K. unfold real in *.
  destruct s as [|o [|p [|q [|r [|t s]]]]]; simpl length in L; try lia; simpl in K, Form, N; try discriminate.
  - apply (f_equal IZR) in K. rewrite emb_dot, emb_cross, !emb_sub in K. apply dot_self_zero in K.
    destruct (Form (emb (place rows p)) ltac:(auto)) as [g1 G1].
    destruct (Form (emb (place rows q)) ltac:(auto)) as [g2 G2].
    inversion N as [|? ? N1 N']; subst. inversion N' as [|? ? N2 _]; subst. simpl in N1, N2.
    set (a := vsub (emb (place rows p)) (emb (place rows o))) in *.
    set (e := vsub (emb (place rows q)) (emb (place rows o))) in *.
    assert (A1 : dot g1 a = 1).
    { unfold a. rewrite G1 by auto. destruct (vec_eq_dec _ _); [|congruence]. destruct (vec_eq_dec _ _); [exfalso;
        intuition congruence | lra]. }
    assert (A2 : dot g1 e = 0).
    { unfold e. rewrite G1 by auto. destruct (vec_eq_dec _ _); [exfalso; intuition congruence|].
      destruct (vec_eq_dec _ _); [exfalso; intuition congruence | lra]. }
    assert (A3 : dot g2 a = 0).
    { unfold a. rewrite G2 by auto. destruct (vec_eq_dec _ _); [exfalso; intuition congruence|].
      destruct (vec_eq_dec _ _); [exfalso; intuition congruence | lra]. }
    assert (A4 : dot g2 e = 1).
    { unfold e. rewrite G2 by auto. destruct (vec_eq_dec _ _); [|congruence]. destruct (vec_eq_dec _ _); [exfalso;
        intuition congruence | lra]. }
    assert (Id : dot (cross g1 g2) (cross a e) = dot g1 a * dot g2 e - dot g1 e * dot g2 a)
      by (clear; vdestruct; vunfold; ring).
    rewrite K, A1, A2, A3, A4 in Id. unfold dot at 1, vzero in Id. simpl in Id. lra.
  - apply (f_equal IZR) in K. rewrite emb_det, !emb_sub in K.
    destruct (Form (emb (place rows p)) ltac:(auto)) as [g1 G1].
    destruct (Form (emb (place rows q)) ltac:(auto)) as [g2 G2].
    destruct (Form (emb (place rows r)) ltac:(auto 6)) as [g3 G3].
    inversion N as [|? ? N1 N']; subst. inversion N' as [|? ? N2 N'']; subst. inversion N'' as [|? ? N3 _]; subst.
    simpl in N1, N2, N3.
    set (a := vsub (emb (place rows p)) (emb (place rows o))) in *.
    set (e := vsub (emb (place rows q)) (emb (place rows o))) in *.
    set (f := vsub (emb (place rows r)) (emb (place rows o))) in *.
    assert (Dual : forall g v w, (forall x y, In x (map (fun i => emb (place rows i)) [o; p; q; r]) ->
      In y (map (fun i => emb (place rows i)) [o; p; q; r]) ->
      dot g (vsub x y) = (if vec_eq_dec x v then 1 else 0) - (if vec_eq_dec y v then 1 else 0)) ->
      In w (map (fun i => emb (place rows i)) [o; p; q; r]) -> emb (place rows o) <> v ->
      dot g (vsub w (emb (place rows o))) = if vec_eq_dec w v then 1 else 0).
    { intros g v w G Hw D. rewrite G by (auto; left; auto).
      destruct (vec_eq_dec (emb (place rows o)) v); [contradiction|]. ring. }
    assert (A : dot g1 a = 1 /\ dot g1 e = 0 /\ dot g1 f = 0 /\ dot g2 a = 0 /\ dot g2 e = 1 /\ dot g2 f = 0 /\
                dot g3 a = 0 /\ dot g3 e = 0 /\ dot g3 f = 1).
    { unfold a, e, f.
      rewrite (Dual g1 _ (emb (place rows p)) G1), (Dual g1 _ (emb (place rows q)) G1),
        (Dual g1 _ (emb (place rows r)) G1), (Dual g2 _ (emb (place rows p)) G2), (Dual g2 _ (emb (place rows q)) G2),
        (Dual g2 _ (emb (place rows r)) G2), (Dual g3 _ (emb (place rows p)) G3), (Dual g3 _ (emb (place rows q)) G3),
        (Dual g3 _ (emb (place rows r)) G3) by (simpl; auto 6; intuition congruence).
      repeat split; destruct (vec_eq_dec _ _); auto; exfalso; intuition congruence. }
    destruct A as [A1 [A2 [A3 [A4 [A5 [A6 [A7 [A8 A9]]]]]]]].
    assert (Id : det g1 g2 g3 * det a e f =
      dot g1 a * (dot g2 e * dot g3 f - dot g2 f * dot g3 e) - dot g1 e * (dot g2 a * dot g3 f - dot g2 f * dot g3 a) +
      dot g1 f * (dot g2 a * dot g3 e - dot g2 e * dot g3 a)) by (clear; vdestruct; vunfold; ring).
    fold a e f in K. rewrite K, A1, A2, A3, A4, A5, A6, A7, A8, A9 in Id. lra.
Qed.

(* The powers of samples are what the checker computes. *)
Lemma outside_sign : forall c s p, listed_face c s ->
  ((0 <= outside (places rows s) (place rows p))%Z <->
   0 <= power (centre_of (places rows s)) (radius2_of (places rows s)) (emb (place rows p))) /\
  (outside (places rows s) (place rows p) = 0%Z <->
   power (centre_of (places rows s)) (radius2_of (places rows s)) (emb (place rows p)) = 0).
Proof.
  intros c s p F. assert (K := face_scale c s F).
  generalize (outside_power (places rows s) (place rows p) K).
  generalize (outside (places rows s) (place rows p)). intro z.
  generalize (power (centre_of (places rows s)) (radius2_of (places rows s)) (emb (place rows p))). intro w.
  assert (N : IZR (scale_of (places rows s)) <> 0) by (intro E; apply eq_IZR in E; auto).
  assert (Q : 0 < IZR (scale_of (places rows s)) * IZR (scale_of (places rows s))) by nra.
  revert Q. generalize (IZR (scale_of (places rows s)) * IZR (scale_of (places rows s))). intros k Q E. split; split;
    intro H.
  - apply IZR_le in H. rewrite E in H. apply Rmult_le_reg_l with k; auto. lra.
  - apply le_IZR. rewrite E. apply Rmult_le_pos; lra.
  - subst z. symmetry in E. destruct (Rmult_integral _ _ E); auto. lra.
  - apply eq_IZR. rewrite E, H. ring.
Qed.
Lemma face_on_sphere : forall c s, listed_face c s ->
  on_sphere (centre_of (places rows s)) (radius2_of (places rows s)) (real rows s).
Proof.
  intros c s F v Hv. apply in_map_iff in Hv. destruct Hv as [p [<- Hp]]. apply (outside_sign c s p F).
  apply outside_self; [|apply in_map; auto]. unfold places. rewrite map_length. apply (face_facts c s F).
Qed.
Lemma link_is_link : forall c s, listed_face c s -> (is_empty_at rows cells s = true <->
  forall c' p, In c' cells -> incl s c' -> In p c' -> ~ In p s ->
    (0 <= outside (places rows s) (place rows p))%Z).
Proof.
  intros c s F. unfold is_empty_at. rewrite forallb_forall. split.
  - intros H c' p Hc' I Hp N. assert (At : In c' (cells_at cells s)).
    { unfold cells_at. apply filter_In. split; auto. apply is_face_spec. auto. }
    specialize (H c' At). rewrite forallb_forall in H. apply Z.leb_le. apply H. unfold link_samples. apply filter_In.
    split; auto. apply negb_true_iff. apply not_true_iff_false. rewrite has_sample_spec. auto.
  - intros H c' At. unfold cells_at in At. apply filter_In in At. destruct At as [Hc' I]. apply is_face_spec in I.
    apply forallb_forall. intros p Hp. unfold link_samples in Hp. apply filter_In in Hp. destruct Hp as [Hp N].
    apply negb_true_iff, not_true_iff_false in N. rewrite has_sample_spec in N. apply Z.leb_le. apply (H c'); auto.
Qed.
Lemma real_incl : forall s c, (forall p, In p s -> In p (names rows)) -> In c cells ->
  incl (real rows s) (real rows c) -> incl s c.
Proof.
  intros s c Ns Hc I p Hp. assert (Q : In (emb (place rows p)) (real rows c))
    by (apply I; apply (in_map (fun i => emb (place rows i))); auto).
  apply in_map_iff in Q. destruct Q as [q [E Hq]].
  replace p with q; auto. apply (place_injective rows); auto. apply (acc_names _ _ _ acc c); auto.
Qed.

Theorem listed_is_centred : forall s, In s (stationary_simplices rows cells) ->
  centred_simplex real_cells (real rows s) (centre_of (places rows s)).
Proof.
  intros s H. apply listed_iff in H. destruct H as [E [c [Hc [Sub [L In_]]]]].
  assert (F : listed_face c s) by (repeat split; auto).
  destruct (face_facts c s F) as [I [N [B [_ [RI RN]]]]]. assert (K := face_scale c s F).
  split; [exists (real rows c); split; auto; apply in_real_cells; eauto|]. split; auto.
  split; [unfold real; rewrite map_length; auto|]. split.
  - apply positive_weights_sound.
    destruct (centre_is_comb (places rows s)) as [Lw [Sw Cw]]; auto; [unfold places; rewrite map_length; auto|].
    exists (real_weights (places rows s)). rewrite real_places. repeat split; auto.
    apply Forall_forall. intros a Ha. unfold real_weights in Ha. apply in_map_iff in Ha. destruct Ha as [z [<- Hz]].
    unfold centre_is_inside in In_. rewrite forallb_forall in In_. apply In_, Z.ltb_lt in Hz. apply Rdiv_lt_0_compat.
    + apply IZR_lt; auto.
    + apply IZR_lt. nia.
  - exists (radius2_of (places rows s)). split; [apply (face_on_sphere c); auto|].
    intros v [u [Hu [Iu [Hv Nv]]]]. apply in_real_cells in Hu. destruct Hu as [c' [Hc' ->]].
    apply in_map_iff in Hv. destruct Hv as [p [<- Hp]]. apply (outside_sign c s p F).
    apply (proj1 (link_is_link c s F) E c' p); auto.
    + apply real_incl; auto. intros q Hq. apply (acc_names _ _ _ acc c); auto.
    + intro Q. apply Nv. apply (in_map (fun i => emb (place rows i))); auto.
Qed.

(* The sphere through s with its centre in aff s is unique. *)
Lemma sphere_unique : forall s z r2 z' s2, in_aff s z -> in_aff s z' -> on_sphere z r2 s -> on_sphere z' s2 s ->
  z = z' /\ (s <> [] -> r2 = s2).
Proof.
  intros s z r2 z' s2 A A' O O'. assert (D := fun p => on_sphere_at _ _ _ p O).
  assert (D' := fun p => on_sphere_at _ _ _ p O').
  assert (E : z = z').
  { apply (centre_unique s); auto; intros p q Hp Hq; [rewrite !D by auto | rewrite !D' by auto]; auto. }
  split; auto. intros N. destruct s as [|p s]; [contradiction|]. subst z'.
  transitivity (dist2 z p); [symmetry; apply D | apply D']; left; auto.
Qed.

Theorem centred_is_listed : forall t z, centred_simplex real_cells t z ->
  exists s, In s (stationary_simplices rows cells) /\ z = centre_of (places rows s) /\
    forall v, In v t <-> In v (real rows s).
Proof.
  intros t z [[u [Hu I]] [Nt [Lt [Hz [r2 [O Link]]]]]].
  assert (Hu' := Hu). apply in_real_cells in Hu'. destruct Hu' as [c [Hc ->]].
  set (s := filter (fun p => if in_dec vec_eq_dec (emb (place rows p)) t then true else false) (sorted c)).
  assert (Same : forall v, In v t <-> In v (real rows s)).
  { intro v. unfold real. rewrite in_map_iff. split.
    - intro Hv. destruct (in_real rows c v (I v Hv)) as [i [B ->]]. exists (nth i c 0%nat). split; auto.
      apply filter_In. split; [apply in_sorted; apply nth_In; auto|]. destruct (in_dec vec_eq_dec _ t); auto.
    - intros [p [<- Hp]]. apply filter_In in Hp. destruct Hp as [_ Hp]. destruct (in_dec vec_eq_dec _ t); auto.
      discriminate. }
  assert (Sub : In s (sublists (sorted c))) by apply filter_in_sublists.
  assert (Ls : (2 <= length s)%nat).
  { apply Nat.le_trans with (length t); auto. rewrite <- (map_length (fun i => emb (place rows i)) s).
    apply NoDup_incl_length; auto. intros v Hv. apply Same. auto. }
  assert (F : listed_face c s) by (repeat split; auto).
  destruct (face_facts c s F) as [Is [N [B [_ [RI RN]]]]]. assert (K := face_scale c s F).
  assert (LP : length (places rows s) = length s) by (unfold places; apply map_length).
  destruct (centre_is_comb (places rows s)) as [Lw [Sw Cw]]; auto; [rewrite LP; auto|].
  rewrite <- real_places in Lw, Cw.
  (* z has positive coordinates at s alone *)
  assert (Coord : forall v, In v (real rows c) -> (In v (real rows s) -> 0 < b (real rows c) v z) /\
                                                  (~ In v (real rows s) -> b (real rows c) v z = 0)).
  { intros v Hv. rewrite <- Same. apply (relint_coordinate P real_cells b proper (real rows c) t z v); auto. }
  assert (Pz : in_conv P z).
  { apply (conv_incl t); [|apply Hz]. intros v Hv. apply (cell_points proper (real rows c)); auto. }
  assert (Sum : forall k, affine k -> k z = total (real rows s) (fun v => b (real rows c) v z * k v)).
  { intros k Ak. rewrite (total_sub _ (real rows c)); auto.
    - apply (expand proper); auto.
    - apply (cell_nodup proper); auto.
    - intros v Hv D. rewrite (proj2 (Coord v Hv) D). ring. }
  set (wz := map (fun v => b (real rows c) v z) (real rows s)).
  assert (Swz : sum wz = 1).
  { rewrite (Sum (fun _ => 1)) by apply affine_const. unfold total, wz. f_equal. apply map_ext. intro v. ring. }
  assert (Cwz : comb wz (real rows s) = z).
  { unfold wz. rewrite comb_total, <- !Sum by auto using affine_vx, affine_vy, affine_vz. destruct z; reflexivity. }
  assert (O' : on_sphere z r2 (real rows s)) by (intros v Hv; apply O; apply Same; auto).
  destruct (sphere_unique (real rows s) z r2 _ _ (ex_intro _ wz (conj (map_length _ _) (conj Swz Cwz)))
    (ex_intro _ (real_weights (places rows s)) (conj Lw (conj Sw Cw))) O' (face_on_sphere c s F)) as [Ez Er].
  assert (Er2 : r2 = radius2_of (places rows s)).
  { apply Er. intro G. apply (f_equal (@length vec)) in G. unfold real in G. rewrite map_length in G. simpl in G. lia. }
  exists s. split; [|split; auto]. apply listed_iff. split.
  - apply (link_is_link c s F). intros c' p Hc' I' Hp Np. apply (outside_sign c s p F). rewrite <- Ez, <- Er2.
    apply Link. exists (real rows c'). split; [apply in_real_cells; eauto|]. split; [|split].
    + intros v Hv. apply Same in Hv. apply (incl_map (fun i => emb (place rows i)) I'). auto.
    + apply (in_map (fun i => emb (place rows i))); auto.
    + intro Q. apply Same in Q. apply in_map_iff in Q. destruct Q as [q [E Hq]]. apply Np.
      replace p with q; auto. apply (place_injective rows); auto; [apply (acc_names _ _ _ acc c); auto|].
      apply (acc_names _ _ _ acc c'); auto.
  - exists c. split; auto. split; auto. split; auto. unfold centre_is_inside. apply forallb_forall. intros a Ha.
    apply Z.ltb_lt. apply lt_IZR.
    set (k2 := (2 * scale_of (places rows s) * scale_of (places rows s))%Z).
    assert (Pk : 0 < IZR k2) by (apply IZR_lt; unfold k2; nia).
    assert (Hw : In (IZR a / IZR k2) (real_weights (places rows s)))
      by (unfold real_weights; apply (in_map (fun a => IZR a / IZR k2)); auto).
    destruct (in_combine_left _ (real rows s) _ Lw Hw) as [v Hv].
    assert (Iv : In v (real rows s)) by (apply in_combine_r in Hv; auto).
    assert (Pos : 0 < IZR a / IZR k2).
    { rewrite <- (weight_at _ (real rows s) (b (real rows c) v) _ v RN Lw Hv).
      - rewrite <- affine_comb by (auto; apply (coord_lin proper); auto).
        rewrite Cw, <- Ez. apply Coord; auto.
      - apply (coord_one proper); auto.
      - intros p Hp D. apply (coord_zero proper); auto. }
    replace (IZR a) with (IZR a / IZR k2 * IZR k2) by (field; lra). apply Rmult_lt_0_compat; auto.
Qed.

Theorem listed_once : forall s s', In s (stationary_simplices rows cells) -> In s' (stationary_simplices rows cells) ->
  centre_of (places rows s) = centre_of (places rows s') -> s = s'.
Proof.
  intros s s' H H' E. assert (C := listed_is_centred s H). assert (C' := listed_is_centred s' H').
  rewrite <- E in C'. apply listed_iff in H, H'.
  destruct H as [_ [c [Hc [Sub [L _]]]]]. destruct H' as [_ [c' [Hc' [Sub' [L' _]]]]].
  destruct (face_facts c s ltac:(repeat split; auto)) as [I [N [_ [Asc _]]]].
  destruct (face_facts c' s' ltac:(repeat split; auto)) as [I' [N' [_ [Asc' _]]]].
  assert (Half : forall s s' c c', In c cells -> In c' cells -> incl s c -> incl s' c' ->
    (forall v, In v (real rows s) -> In v (real rows s')) -> incl s s').
  { intros s1 s2 c1 c2 H1 H2 I1 I2 Sub12 p Hp.
    assert (Q := Sub12 _ (in_map (fun i => emb (place rows i)) s1 p Hp)). apply in_map_iff in Q.
    destruct Q as [q [F Hq]]. replace p with q; auto.
    apply (place_injective rows); auto; [apply (acc_names _ _ _ acc c2) | apply (acc_names _ _ _ acc c1)]; auto. }
  rewrite <- Asc, <- Asc'. apply sorted_permutation. apply NoDup_Permutation; auto. intro p. split.
  - apply (Half s s' c c'); auto. apply (centred_simplex_unique P real_cells b proper glued _ _ _ C C').
  - apply (Half s' s c' c); auto. apply (centred_simplex_unique P real_cells b proper glued _ _ _ C' C).
Qed.

(* The contact set of a listed simplex: the samples that are nearest to its centre. *)
Theorem contacts_right : forall s p, In s (stationary_simplices rows cells) ->
  (In p (contact_samples rows s) <-> In p (names rows) /\
   forall q, In q P -> dist2 (centre_of (places rows s)) (emb (place rows p)) <= dist2 (centre_of (places rows s)) q).
Proof.
  intros s p H. assert (C := listed_is_centred s H). apply listed_iff in H. destruct H as [_ [c [Hc [Sub [L _]]]]].
  assert (F : listed_face c s) by (repeat split; auto).
  destruct C as [T [N [_ [Hz [r2 [O Link]]]]]].
  assert (S := face_on_sphere c s F).
  assert (r2 = radius2_of (places rows s)).
  { destruct s as [|i s]; [simpl in L; lia|]. generalize (O _ (or_introl eq_refl)), (S _ (or_introl eq_refl)).
    unfold power. lra. }
  subst r2. set (z := centre_of (places rows s)) in *. set (r2 := radius2_of (places rows s)) in *.
  assert (Empty : forall q, In q P -> 0 <= power z r2 q)
    by (intros; apply (empty_sphere_of_simplex P real_cells b proper glued local (real rows s)); auto).
  assert (Some_ : exists v, In v P /\ power z r2 v = 0).
  { destruct (face_facts c s F) as [I _]. destruct s as [|i s]; [simpl in L; lia|].
    exists (emb (place rows i)). split; [|apply S; left; auto].
    apply (in_map (fun i => emb (place rows i))). apply (acc_names _ _ _ acc c); auto. apply I. left. auto. }
  unfold contact_samples, is_on_sphere. rewrite filter_In, Z.eqb_eq. rewrite (proj2 (outside_sign c s p F)).
  fold z r2. split.
  - intros [Hp Z]. split; auto. intros q Hq. generalize (Empty q Hq). unfold power in *. lra.
  - intros [Hp Near]. split; auto. destruct Some_ as [v [Hv Zv]]. generalize (Near v Hv).
    generalize (Empty _ (in_map (fun i => emb (place rows i)) _ _ Hp)). unfold power in *. lra.
Qed.
End ListSound.
