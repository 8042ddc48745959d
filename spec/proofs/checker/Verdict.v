(* What a certificate proves that the checker accepts: a Delaunay triangulation (FC-CERT-02), and all stationary points,
   each once, with their contact sets (FC-CERT-03 and 05). *)
From Coq Require Import Reals ZArith Lra Lia List Bool.
From Flowcert Require Import algebra.Vector3 spec.Hull spec.HalfSpace algebra.Sphere spec.CriticalPoint spec.Stationary
  spec.Delaunay judge.Judge judge.Dimension.
From Flowcert Require Import checker.Simplices checker.Certificate checker.Conditions checker.Faces.
From Flowcert Require Import checker.StationaryList checker.Affine checker.Volumes checker.Tiling checker.Delaunay.
From Flowcert Require Import checker.StationarySimplices checker.Centres checker.Sound checker.ListSound
  checker.Checked.
From Flowcert Require Import checker.HullFan checker.HullSound checker.TilingSound.
Import ListNotations.
Open Scope R_scope.

Section Real.
Variable P : list vec.
Variable cells : list (list vec).
Variable b : list vec -> vec -> vec -> R.
Hypothesis proper : proper_cells (in_conv P) affine P cells b.
Hypothesis glued : glued_cells (in_conv P) cells b.
Hypothesis local : local_delaunay P cells.
Hypothesis once : NoDup cells.

Lemma weights_of : forall c w, In c cells -> length w = length c -> sum w = 1 ->
  w = map (fun v => b c v (comb w c)) c.
Proof.
  intros c w Hc L S.
  assert (G : forall (w' : list R) (c' : list vec) (f : vec -> R), length w' = length c' ->
    (forall a v, In (a, v) (combine w' c') -> a = f v) -> w' = map f c').
  { clear. induction w' as [|a w IH]; intros [|v c] f L H; simpl in L; try discriminate; auto. simpl. f_equal.
    - apply H. left. auto.
    - apply IH; [congruence|]. intros a' v' Hi. apply H. right. auto. }
  apply G; auto. intros a v Hi. assert (Hv : In v c) by (apply in_combine_r in Hi; auto).
  rewrite affine_comb by (auto; apply (coord_lin proper); auto).
  symmetry. apply (weight_at w c (b c v) a v); auto.
  - apply (cell_nodup proper); auto.
  - apply (coord_one proper); auto.
  - intros p Hp D. apply (coord_zero proper); auto.
Qed.
Lemma cell_is_conv : forall c x, In c cells -> (in_cell (in_conv P) b c x <-> in_conv c x).
Proof.
  intros c x Hc. split.
  - intros [Hx I]. exists (map (fun v => b c v x) c). split; [apply map_length|]. split; [|split].
    + apply Forall_forall. intros a Ha. apply in_map_iff in Ha. destruct Ha as [v [<- Hv]]. auto.
    + assert (E := expand proper c (fun _ => 1) x Hc (affine_const 1) Hx). rewrite E. unfold total. f_equal.
      apply map_ext. intro v. ring.
    + rewrite comb_total. rewrite <- !(expand proper c) by auto using affine_vx, affine_vy, affine_vz.
      destruct x; reflexivity.
  - intro Hx. split.
    + apply (conv_incl c); auto. apply (cell_points proper); auto.
    + intros v Hv. apply (hull_nonneg (b c v) c); auto; [apply (coord_lin proper); auto|]. intros w Hw.
      destruct (vec_eq_dec w v) as [->|D]; [rewrite (coord_one proper) by auto; lra|].
      rewrite (coord_zero proper) by auto. lra.
Qed.

Lemma maximal : forall c c', In c cells -> In c' cells -> incl c c' -> c = c'.
Proof.
  intros c c' Hc Hc' I. destruct (covered_once glued) as [first [o [_ [[Po _] _]]]].
  destruct (cell_has_vertex P cells b proper c o Hc Po) as [v Hv].
  destruct (perturb proper (in_cell (in_conv P) b c) v 1 (coordinates (cells := cells) (b := b))
    (movable_cell proper c Hc)
    (vertex_in_cell proper c v Hc Hv) ltac:(lra) (coordinates_nonzero proper)) as [y [Iy [_ Ny]]].
  apply (cells_disjoint proper glued c c' y); auto.
  - split; [apply Iy|]. intros w Hw.
    generalize (proj2 Iy w Hw), (Ny (b c w) (in_coordinates c w Hc Hw)). lra.
  - apply cell_is_conv; auto. apply (conv_incl c); auto. apply cell_is_conv; auto.
Qed.

Theorem triangulation_of : delaunay_triangulation P cells.
Proof.
  split.
  - intro p. split; [apply (all_in_cells _ _ local)|]. intros [c [Hc Hp]]. apply (cell_points proper c); auto.
  - intros c w w' Hc L L' S S' E. rewrite (weights_of c w Hc L S), (weights_of c w' Hc L' S'), E. auto.
  - apply maximal.
  - exact once.
  - intro x. split.
    + intro Hx. destruct (cells_cover proper glued x Hx) as [c [Hc I]]. exists c. split; auto. apply cell_is_conv; auto.
    + intros [c [Hc I]]. apply (conv_incl c); auto. apply (cell_points proper); auto.
  - intros c c' x Hc Hc' I I'. apply cell_is_conv in I, I'; auto.
    set (positive := fun v => if Rlt_dec 0 (b c v x) then true else false).
    assert (Pos : forall v, positive v = true <-> 0 < b c v x)
      by (intro v; unfold positive; destruct (Rlt_dec 0 (b c v x)); split; intros; auto; congruence).
    assert (Not : forall v, In v c -> positive v = false -> b c v x = 0).
    { intros v J F. destruct (Rle_lt_or_eq_dec 0 (b c v x) (proj2 I v J)) as [H|H]; auto. apply Pos in H. congruence. }
    assert (Sum : forall k, affine k -> k x = total (filter positive c) (fun v => b c v x * k v)).
    { intros k Ak. rewrite total_filter; [apply (expand proper c k); auto; apply I|].
      intros v J F. rewrite (Not v J F). ring. }
    exists (filter positive c). split; [intros v Hv; apply filter_In in Hv; tauto|]. split.
    + intros v Hv. apply filter_In in Hv. destruct Hv as [Hv F]. apply Pos in F.
      apply (face_to_face P cells b proper glued c c' x v); auto.
    + exists (map (fun v => b c v x) (filter positive c)). split; [apply map_length|]. split; [|split].
      * apply Forall_forall. intros a Ha. apply in_map_iff in Ha. destruct Ha as [v [<- Hv]].
        apply filter_In in Hv. apply I. tauto.
      * rewrite (Sum (fun _ => 1)) by apply affine_const. unfold total. f_equal. apply map_ext. intro v. ring.
      * rewrite comb_total. rewrite <- !Sum by auto using affine_vx, affine_vy, affine_vz. destruct x; reflexivity.
  - intros c Hc. destruct (has_sphere _ _ local c Hc) as [z [r2 S]]. exists z, r2. intros v Hv.
    generalize (S v Hv). unfold power. lra.
  - intros c z r2 p Hc S Hp. assert (0 <= power z r2 p); [|unfold power in *; lra].
    apply (empty_spheres P cells b proper glued local c); auto. intros v Hv. unfold power. rewrite S by auto. ring.
Qed.
End Real.

Definition centre (rows : list zvec) (r : stationary_point) : vec := centre_of (places rows (simplex_of r)).

Lemma samples_are_rows : forall rows v, In v (samples rows) <-> In v (map emb rows).
Proof.
  intros rows v. split; intro H.
  - apply in_map_iff in H. destruct H as [i [<- Hi]]. apply in_map. apply name_is_row. auto.
  - apply in_map_iff in H. destruct H as [p [<- Hp]]. destruct (names_whole rows p Hp) as [i [Hi <-]].
    apply (in_map (fun i => emb (place rows i))). auto.
Qed.
Lemma sample_is_stationary : forall P p, In p P -> is_stationary P p.
Proof.
  intros P p Hp. apply stationary_iff_nearest. exists [p]. split.
  - intros q [<-|[]]. split; auto. intros r _. rewrite dist2_refl. apply dot_self_nonneg.
  - apply point_in_conv. left. auto.
Qed.
Lemma sample_centre : forall rows p, centre_of (places rows [p]) = emb (place rows p).
Proof.
  intros. unfold centre_of, places. simpl. apply vec_eq; simpl; ring.
Qed.
(* Where there is one point at most, only it is stationary. *)
Lemma few_samples : forall P z, (length P < 2)%nat -> is_stationary P z -> In z P.
Proof.
  intros P z L H. apply stationary_iff_nearest in H. destruct H as [C [HC Hz]].
  assert (Q : in_conv P z) by (apply (conv_incl C); auto; intros p Hp; apply HC; auto).
  destruct Q as [w [Lw [_ [S E]]]]. destruct P as [|p [|q P]]; simpl in L; try lia.
  - destruct w; simpl in *; [lra | discriminate].
  - destruct w as [|a [|c w]]; try discriminate. simpl in S, E. left. rewrite <- E. assert (a = 1) by lra. subst a.
    apply vec_eq; simpl; ring.
Qed.

Section Verdict.
Variable rows : list zvec.
Variable d_plus_1 count : nat.
Variable body : list Z.
Variable cells : list simplex.
Variable points : list stationary_point.
Hypothesis accepts : check_certificate rows d_plus_1 count body = Holds (cells, points).
Let P := samples rows.

Lemma accepts_cells : check_cells_of rows d_plus_1 cells = Holds points.
Proof.
  unfold check_certificate in accepts. apply and_then_holds in accepts. destruct accepts as [cs [_ H]].
  apply and_then_holds in H. destruct H as [ps [H E]]. injection E. intros; subst. auto.
Qed.

Theorem certificate_is_delaunay : (cells = [] /\ (length P < 2)%nat) \/
  delaunay_triangulation P (map (real rows) cells).
Proof.
  destruct (checked_holds _ _ _ _ accepts_cells) as [_ [[H1 [H2 H3]]|[first [Hf [acc checked]]]]].
  - left. split; auto. unfold P, samples, real. rewrite map_length. lia.
  - right. apply (triangulation_of P _ _ (accepted_proper rows first cells acc)
      (accepted_glued rows first cells acc checked) (accepted_local rows first cells acc)).
    apply (accepted_once rows first cells acc).
Qed.

Lemma points_shape : points = map (fun p => StationaryPoint Index0 [p] [p]) (names rows) ++
  map (fun s => StationaryPoint (kind_at rows d_plus_1 cells s) (contact_samples rows s) s)
      (stationary_simplices rows cells).
Proof. apply (checked_holds _ _ _ _ accepts_cells). Qed.

(* What is listed for simplices. *)
Lemma simplices_right :
  (forall s, In s (stationary_simplices rows cells) -> is_stationary P (centre_of (places rows s)) /\
     ~ In (centre_of (places rows s)) P) /\
  (forall z, is_stationary P z -> ~ In z P -> exists s, In s (stationary_simplices rows cells) /\
     centre_of (places rows s) = z) /\
  (forall s s', In s (stationary_simplices rows cells) -> In s' (stationary_simplices rows cells) ->
     centre_of (places rows s) = centre_of (places rows s') -> s = s') /\
  (forall s p, In s (stationary_simplices rows cells) -> (In p (contact_samples rows s) <-> In p (names rows) /\
     forall q, In q P -> dist2 (centre_of (places rows s)) (emb (place rows p)) <= dist2 (centre_of (places rows s))
       q)).
Proof.
  destruct (checked_holds _ _ _ _ accepts_cells) as [_ [[H1 [H2 H3]]|[first [Hf [acc checked]]]]].
  - subst cells. change (stationary_simplices rows []) with (@nil simplex).
    split; [intros s []|]. split; [|split; [intros s s' [] | intros s p []]].
    intros z Hz N. exfalso. apply N. apply few_samples; auto. unfold P, samples, real. rewrite map_length. lia.
  - assert (G := accepted_glued rows first cells acc checked).
    assert (Pr := accepted_proper rows first cells acc). assert (Lo := accepted_local rows first cells acc).
    split; [|split; [|split]].
    + intros s Hs. apply (centred_is_stationary _ _ _ Pr G Lo (real rows s)).
      apply (listed_is_centred rows first cells acc); auto.
    + intros z Hz N. destruct (stationary_is_centred _ _ _ Pr G Lo z Hz N) as [t Ht].
      destruct (centred_is_listed rows first cells acc t z Ht) as [s [Hs [E _]]]. exists s. auto.
    + intros s s' Hs Hs'. apply (listed_once rows first cells acc G); auto.
    + intros s p Hs. apply (contacts_right rows first cells acc G); auto.
Qed.

(* The points of the list are the stationary points, one to one. *)
Theorem list_is_whole : forall z, is_stationary P z <-> exists r, In r points /\ centre rows r = z.
Proof.
  destruct simplices_right as [R1 [R2 _]]. intro z. rewrite points_shape. split.
  - intro Hz. destruct (in_dec vec_eq_dec z P) as [I|I].
    + apply in_map_iff in I. destruct I as [p [E Hp]]. exists (StationaryPoint Index0 [p] [p]). split.
      * apply in_or_app. left. apply (in_map (fun p => StationaryPoint Index0 [p] [p])). auto.
      * unfold centre. simpl simplex_of. rewrite sample_centre. auto.
    + destruct (R2 z Hz I) as [s [Hs E]]. eexists. split.
      * apply in_or_app. right. apply in_map_iff. exists s. split; [reflexivity | auto].
      * exact E.
  - intros [r [Hr E]]. apply in_app_or in Hr. destruct Hr as [Hr|Hr]; apply in_map_iff in Hr;
      destruct Hr as [s [<- Hs]].
    + unfold centre in E. simpl simplex_of in E. rewrite sample_centre in E. subst z. apply sample_is_stationary.
      apply (in_map (fun i => emb (place rows i))). auto.
    + subst z. apply R1. auto.
Qed.
Theorem list_has_each_once : NoDup (map (centre rows) points).
Proof.
  destruct simplices_right as [R1 [_ [R3 _]]]. rewrite points_shape, map_app, !map_map.
  assert (G : forall A (f : A -> vec) l, NoDup l -> (forall x y, In x l -> In y l -> f x = f y -> x = y) ->
    NoDup (map f l)).
  { clear. intros A f l. induction 1 as [|x l Hx N IH]; intro Inj; simpl; constructor.
    - intro F. apply in_map_iff in F. destruct F as [y [E Hy]]. apply Hx.
      rewrite <- (Inj y x); auto; [right; auto | left; auto].
    - apply IH. intros a c Ha Hc. apply Inj; right; auto. }
  assert (Apart : forall (l l' : list vec), NoDup l -> NoDup l' -> (forall x, In x l -> ~ In x l') -> NoDup (l ++ l')).
  { clear. induction 1 as [|x l Hx N IH]; intros N' D; simpl; auto. constructor.
    - intro F. apply in_app_or in F. destruct F as [F|F]; [auto | apply (D x); [left|]; auto].
    - apply IH; auto. intros y Hy. apply D. right. auto. }
  apply Apart.
  - apply G; [apply names_nodup|]. intros p q Hp Hq E. unfold centre in E. simpl simplex_of in E.
    rewrite !sample_centre in E. apply emb_injective in E. apply (names_distinct rows); auto.
  - apply G; [apply NoDup_filter, NoDup_nodup|]. intros s s' Hs Hs' E. apply R3; auto.
  - intros x Hx F. apply in_map_iff in Hx, F. destruct Hx as [p [<- Hp]]. destruct F as [s [E Hs]].
    destruct (R1 s Hs) as [_ N]. apply N. unfold centre in E. simpl simplex_of in E. rewrite E, sample_centre.
    apply (in_map (fun i => emb (place rows i))). auto.
Qed.
(* The contact set of each point: the samples that are nearest to it. *)
Theorem list_has_contact_sets : forall r p, In r points -> (In p (contact_of r) <-> In p (names rows) /\
  forall q, In q P -> dist2 (centre rows r) (emb (place rows p)) <= dist2 (centre rows r) q).
Proof.
  destruct simplices_right as [_ [_ [_ R4]]]. intros r p Hr. rewrite points_shape in Hr.
  apply in_app_or in Hr. destruct Hr as [Hr|Hr]; apply in_map_iff in Hr; destruct Hr as [s [<- Hs]].
  - unfold centre. simpl simplex_of. simpl contact_of. rewrite sample_centre. split.
    + intros [<-|[]]. split; auto. intros q _. rewrite dist2_refl. apply dot_self_nonneg.
    + intros [Hp Near]. left. assert (I : In (emb (place rows s)) P) by (apply (in_map (fun i => emb (place rows i)));
        auto).
      generalize (Near _ I). rewrite dist2_refl. intro Le.
      assert (D : dist2 (emb (place rows s)) (emb (place rows p)) = 0).
      { generalize (dot_self_nonneg (vsub (emb (place rows s)) (emb (place rows p)))). unfold dist2 in *. lra. }
      apply dist2_zero, emb_injective in D. apply (names_distinct rows); auto.
  - apply R4. auto.
Qed.
End Verdict.
