(* FC-CERT-03: the stationary points that are no samples are, one to one, the simplices with the centre of their sphere
   inside and no link sample strictly inside that sphere. *)
From Coq Require Import Reals ZArith Lra Lia List FinFun Psatz Classical.
From Flowcert Require Import algebra.Vector3 spec.Hull spec.HalfSpace algebra.Sphere spec.Stationary.
From Flowcert Require Import checker.Affine checker.Tiling checker.Delaunay.
Import ListNotations.
Open Scope R_scope.

(* A sample of a cell that has s as a face, but none of s. *)
Definition link_sample (cells : list (list vec)) s p := exists t, In t cells /\ incl s t /\ In p t /\ ~ In p s.
(* z is the centre of the sphere through the samples of s in aff s, as in_relint says that it lies there. *)
Definition centred_simplex (cells : list (list vec)) s z :=
  (exists t, In t cells /\ incl s t) /\ NoDup s /\ (2 <= length s)%nat /\ in_relint s z /\
  exists r2, on_sphere z r2 s /\ forall p, link_sample cells s p -> 0 <= power z r2 p.

Section Stationary.
Variable P : list vec.
Variable cells : list (list vec).
Variable b : list vec -> vec -> vec -> R.
Hypothesis proper : proper_cells (in_conv P) affine P cells b.
Hypothesis glued : glued_cells (in_conv P) cells b.
Hypothesis local : local_delaunay P cells.
Let b_affine := coord_lin proper.
Let b_one := coord_one proper.
Let b_zero := coord_zero proper.

(* The centre's coordinates in a cell that has s as a face. *)
Lemma relint_coordinate : forall t s z v, In t cells -> incl s t -> in_relint s z -> In v t ->
  (In v s -> 0 < b t v z) /\ (~ In v s -> b t v z = 0).
Proof.
  intros t s z v Ht I Hz Hv. apply relint_iff_positive_weights in Hz. destruct Hz as [w [L [Pos [S E]]]].
  rewrite <- E, affine_comb by auto. clear E S.
  assert (One : forall q, In q s -> b t v q = if vec_eq_dec q v then 1 else 0).
  { intros q Hq. destruct (vec_eq_dec q v) as [->|D]; auto. }
  clear I. revert s L One. induction Pos as [|a w Ha Pos IH]; intros [|q s] L One; try discriminate; simpl.
  - split; [intros [] | auto].
  - destruct (IH s) as [H1 H2]; [simpl in L; congruence | intros; apply One; right; auto |].
    rewrite (One q (or_introl eq_refl)).
    assert (NN : 0 <= sum (map (fun '(a, p) => a * b t v p) (combine w s))).
    { destruct (in_dec vec_eq_dec v s) as [J|J]; [apply H1 in J; lra | rewrite H2; auto; lra]. }
    destruct (vec_eq_dec q v) as [->|D].
    + split; [intros; lra | intro F; exfalso; apply F; left; auto].
    + split.
      * intros [->|J]; [congruence|]. apply H1 in J. lra.
      * intro F. rewrite H2; [ring|]. intro J. apply F. right; auto.
Qed.
Lemma relint_in_cell : forall t s z, In t cells -> incl s t -> in_relint s z -> in_cell (in_conv P) b t z.
Proof.
  intros t s z Ht I Hz. split.
  - apply (conv_incl s); [|apply Hz]. intros p Hp. apply (cell_points proper t); auto.
  - intros v Hv. destruct (relint_coordinate t s z v Ht I Hz Hv) as [H1 H2].
    destruct (in_dec vec_eq_dec v s) as [J|J]; [apply H1 in J; lra | rewrite H2; auto; lra].
Qed.

(* No sample is strictly inside the sphere of a centred simplex. *)
Lemma empty_sphere_of_simplex : forall s z r2 p, (exists t, In t cells /\ incl s t) -> in_relint s z ->
  on_sphere z r2 s -> (forall q, link_sample cells s q -> 0 <= power z r2 q) -> In p P -> 0 <= power z r2 p.
Proof.
  intros s z r2 p [t0 [Ht0 I0]] Hz S Link Hp.
  destruct (far_near proper z) as [e [He Far]].
  destruct (soon_some _ (soon_near z p z e ltac:(rewrite dist2_refl; auto))) as [t' [Bt D]].
  set (z1 := mix t' z p) in *.
  assert (It0 : in_cell (in_conv P) b t0 z) by (apply relint_in_cell with s; auto).
  assert (P1 : in_conv P z1) by (apply hull_mix; [lra | apply It0 | apply point_in_conv; auto]).
  destruct (cells_cover proper glued z1 P1) as [t [Ht I1]].
  assert (It : in_cell (in_conv P) b t z).
  { split; [apply It0|]. intros v Hv. apply Rnot_lt_le. intro L. generalize (Far t v z1 Ht Hv L D).
    generalize (proj2 I1 v Hv). lra. }
  assert (It' : incl s t).
  { intros v Hv. apply (face_to_face P cells b proper glued t0 t z v); auto.
    apply (relint_coordinate t0 s z v); auto. }
  destruct (has_sphere _ _ local t Ht) as [zt [rt St]].
  set (h := fun x => power z r2 x - power zt rt x).
  assert (Ah : affine h) by apply power_difference.
  assert (Hv : forall v, In v t -> 0 <= h v).
  { intros v Hv. unfold h. rewrite (St v) by auto. destruct (in_dec vec_eq_dec v s) as [J|J].
    - rewrite (S v) by auto. lra.
    - assert (0 <= power z r2 v); [|lra]. apply Link. exists t. auto. }
  assert (H1 : 0 <= h z1).
  { rewrite (expand proper t h z1) by auto. apply total_nonneg. intros v J. apply Rmult_le_pos; auto.
    apply I1; auto. }
  assert (H0 : h z = 0).
  { rewrite (expand proper t h z) by (auto; apply It). apply total_zero. intros v J.
    destruct (relint_coordinate t s z v Ht It' Hz J) as [_ Z].
    destruct (in_dec vec_eq_dec v s) as [K|K]; [|rewrite Z; auto; ring].
    unfold h. rewrite (S v), (St v) by auto. ring. }
  unfold z1 in H1. rewrite affine_mix, H0 in H1 by auto.
  assert (0 <= h p) by nra. generalize (empty_spheres P cells b proper glued local t zt rt p Ht Hp St).
  unfold h in H. lra.
Qed.

Theorem centred_is_stationary : forall s z, centred_simplex cells s z -> is_stationary P z /\ ~ In z P.
Proof.
  intros s z [T [N [L [Hz [r2 [S Link]]]]]].
  assert (Empty : forall p, In p P -> 0 <= power z r2 p) by (intros; apply (empty_sphere_of_simplex s); auto).
  destruct T as [t [Ht I]].
  assert (IP : incl s P) by (intros v Hv; apply (cell_points proper t); auto).
  split.
  - apply stationary_iff_nearest. exists s. split; [|apply Hz]. intros p Hp. split; auto. intros q Hq.
    generalize (S p Hp), (Empty q Hq). unfold power. lra.
  - intro Hp. generalize (Empty z Hp). unfold power. rewrite dist2_refl. intro R.
    assert (All : forall v, In v s -> v = z).
    { intros v Hv. symmetry. apply dist2_zero. generalize (S v Hv), (dot_self_nonneg (vsub z v)).
      unfold power, dist2 in *. lra. }
    destruct s as [|v [|w s]]; simpl in L; try lia. inversion N as [|? ? F _]. apply F.
    rewrite (All v (or_introl eq_refl)), <- (All w (or_intror (or_introl eq_refl))). left. auto.
Qed.

Theorem stationary_is_centred : forall z, is_stationary P z -> ~ In z P -> exists s, centred_simplex cells s z.
Proof.
  intros z H Nz. apply stationary_iff_nearest in H. destruct H as [C [HC Hz]].
  assert (Pz : in_conv P z) by (apply (conv_incl C); auto; intros p Hp; apply HC; auto).
  destruct (cells_cover proper glued z Pz) as [t [Ht [_ I]]].
  destruct (has_sphere _ _ local t Ht) as [zt [rt St]].
  destruct C as [|p0 C'] eqn:EC.
  { destruct Hz as [w [L [_ [S _]]]]. destruct w; simpl in *; [lra | discriminate]. }
  rewrite <- EC in *. set (r2 := dist2 z p0).
  assert (I0 : In p0 C) by (rewrite EC; left; auto).
  assert (Empty : forall p, In p P -> 0 <= power z r2 p).
  { intros p Hp. unfold power, r2. generalize (proj2 (HC p0 I0) p Hp). lra. }
  assert (On : forall p, In p C -> power z r2 p = 0).
  { intros p Hp. generalize (Empty p (proj1 (HC p Hp))), (proj2 (HC p Hp) p0 (proj1 (HC p0 I0))).
    unfold power, r2. lra. }
  set (h := fun x => power z r2 x - power zt rt x).
  assert (Ah : affine h) by apply power_difference.
  assert (Hle : h z <= 0).
  { assert (0 <= -1 * h z); [|lra]. apply (hull_nonneg (fun x => -1 * h x) C); auto using affine_scale.
    intros p Hp. unfold h. rewrite On by auto.
    generalize (empty_spheres P cells b proper glued local t zt rt p Ht (proj1 (HC p Hp)) St). lra. }
  assert (Hv : forall v, In v t -> 0 <= h v).
  { intros v Hv. unfold h. rewrite (St v) by auto. generalize (Empty v (cell_points proper t Ht v Hv)). lra. }
  assert (Term : forall v, In v t -> 0 <= b t v z * h v) by (intros; apply Rmult_le_pos; auto).
  assert (Zero : forall v, In v t -> b t v z * h v = 0).
  { apply total_nonneg_zero; auto.
    assert (Ex : h z = total t (fun v => b t v z * h v)) by (apply (expand proper t h); auto).
    generalize (total_nonneg t _ Term). lra. }
  set (positive := fun v => if Rlt_dec 0 (b t v z) then true else false).
  assert (Pos : forall v, positive v = true <-> 0 < b t v z)
    by (intro v; unfold positive; destruct (Rlt_dec 0 (b t v z)); split; intros; auto; congruence).
  assert (Not : forall v, In v t -> positive v = false -> b t v z = 0).
  { intros v J F. destruct (Rle_lt_or_eq_dec 0 (b t v z) (I v J)) as [K|K]; auto. apply Pos in K. congruence. }
  set (s := filter positive t).
  assert (Ns : NoDup s) by (apply NoDup_filter; apply (cell_nodup proper); auto).
  assert (Is : incl s t) by (intros v J; apply filter_In in J; tauto).
  assert (Sum : forall k, affine k -> k z = total s (fun v => b t v z * k v)).
  { intros k Ak. unfold s. rewrite total_filter; [apply (expand proper t k); auto|].
    intros v J F. rewrite (Not v J F). ring. }
  assert (Weights : has_positive_weights s z).
  { exists (map (fun v => b t v z) s). split; [apply map_length|]. split; [|split].
    - apply Forall_forall. intros a Ha. apply in_map_iff in Ha. destruct Ha as [v [<- J]].
      apply filter_In in J. apply Pos. tauto.
    - rewrite (Sum (fun _ => 1)) by apply affine_const. unfold total. f_equal. apply map_ext. intro v. ring.
    - rewrite comb_total. rewrite <- !Sum by auto using affine_vx, affine_vy, affine_vz. destruct z; reflexivity. }
  exists s. split; [exists t; auto|]. split; auto. split; [|split].
  - destruct s as [|v [|w s']] eqn:Es; simpl; try lia.
    + destruct Weights as [w [L [_ [Sw _]]]]. destruct w; simpl in *; [lra | discriminate].
    + exfalso. destruct Weights as [w [L [_ [Sw E]]]]. destruct w as [|a [|c w]]; try discriminate. simpl in Sw, E.
      apply Nz. apply (cell_points proper t Ht). apply Is.
      replace z with v; [left; auto|]. rewrite <- E. assert (a = 1) by lra. subst a.
      apply vec_eq; simpl; ring.
  - apply positive_weights_sound. auto.
  - exists r2. split.
    + intros v J. apply filter_In in J. destruct J as [J K]. apply Pos in K.
      destruct (Rmult_integral _ _ (Zero v J)) as [F|F]; [lra|]. unfold h in F. rewrite (St v J) in F. lra.
    + intros p [t' [Ht' [_ [J _]]]]. apply Empty. apply (cell_points proper t'); auto.
Qed.

Theorem centred_simplex_unique : forall s s' z, centred_simplex cells s z -> centred_simplex cells s' z ->
  forall v, In v s -> In v s'.
Proof.
  intros s s' z [[t [Ht I]] [_ [_ [Hz _]]]] [[t' [Ht' I']] [_ [_ [Hz' _]]]] v Hv.
  assert (It : in_cell (in_conv P) b t z) by (apply relint_in_cell with s; auto).
  assert (It' : in_cell (in_conv P) b t' z) by (apply relint_in_cell with s'; auto).
  assert (Sub : forall w, In w t -> 0 < b t w z -> In w t')
    by (intros w J K; apply (face_to_face P cells b proper glued t t' z w); auto).
  assert (Pos : 0 < b t v z) by (apply (relint_coordinate t s z v); auto).
  assert (Vt' : In v t') by (apply Sub; auto).
  destruct (support_coordinate P cells b proper t t' z v Ht Ht' It Sub Vt') as [E _].
  destruct (relint_coordinate t' s' z v Ht' I' Hz' Vt') as [_ Z].
  destruct (in_dec vec_eq_dec v s') as [|J]; auto. exfalso. rewrite <- E in Pos by auto. rewrite Z in Pos by auto. lra.
Qed.
End Stationary.
