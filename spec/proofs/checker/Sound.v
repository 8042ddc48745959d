(* What the conditions T0 to T3 and T8, as the checker computes them, say of points of real numbers: the cells have
   barycentric coordinates, paired facets have their cells on either side, and neighbours are locally Delaunay. *)
From Coq Require Import Reals ZArith Lra Lia List Bool Permutation.
From Flowcert Require Import algebra.Vector3 spec.Hull spec.HalfSpace algebra.Sphere judge.Judge judge.Dimension.
From Flowcert Require Import checker.Simplices checker.Certificate checker.Conditions checker.Faces.
From Flowcert Require Import checker.Affine checker.Volumes checker.Tiling checker.Delaunay checker.Centres.
Import ListNotations.

Definition real (rows : list zvec) (c : simplex) : list vec := map (fun i => emb (place rows i)) c.
Definition samples (rows : list zvec) : list vec := real rows (names rows).

(* ---- Lists of facets ---- *)

Lemma in_numbered : forall l i k (c : simplex), In (k, c) (combine (seq i (length l)) l) <->
  (i <= k)%nat /\ nth_error l (k - i) = Some c.
Proof.
  induction l as [|d l IH]; intros i k c; simpl.
  - split; [intros [] | intros [_ H]; destruct (k - i)%nat; discriminate].
  - rewrite IH. split.
    + intros [E|[B E]].
      * injection E; intros; subst. split; [lia|]. rewrite Nat.sub_diag. auto.
      * split; [lia|]. replace (k - i)%nat with (S (k - S i)) by lia. auto.
    + intros [B E]. destruct (Nat.eq_dec k i) as [->|D].
      * rewrite Nat.sub_diag in E. injection E; intros; subst. left. auto.
      * right. split; [lia|]. replace (k - i)%nat with (S (k - S i)) in E by lia. auto.
Qed.
Lemma in_facets : forall cells f, In f (facets cells) <->
  exists k c i, nth_error cells k = Some c /\ (i < length c)%nat /\ f = facet_at k c i.
Proof.
  intros cells f. unfold facets, numbered. rewrite in_flat_map. split.
  - intros [[k c] [H F]]. apply in_numbered in H. destruct H as [_ H]. rewrite Nat.sub_0_r in H.
    unfold facets_of in F. apply in_map_iff in F. destruct F as [i [E B]]. apply in_seq in B.
    exists k, c, i. repeat split; auto; lia.
  - intros [k [c [i [H [B ->]]]]]. exists (k, c). split.
    + apply in_numbered. rewrite Nat.sub_0_r. split; [lia | auto].
    + unfold facets_of. apply in_map. apply in_seq. lia.
Qed.
Lemma in_mates : forall all f g, In g (mates all f) <->
  In g all /\ samples_of g = samples_of f /\ ~ (cell_number f = cell_number g /\ place_of f = place_of g).
Proof.
  intros all f g. unfold mates. rewrite filter_In, andb_true_iff, same_samples_spec, negb_true_iff.
  unfold is_same_facet. rewrite andb_false_iff, !Nat.eqb_neq. split.
  - intros [H [E D]]. repeat split; auto. intros [F G]. destruct D; auto.
  - intros [H [E D]]. repeat split; auto. destruct (Nat.eq_dec (cell_number f) (cell_number g)); auto.
Qed.

Lemma nth_parts : forall (c : simplex) i, (i < length c)%nat ->
  exists l1 l2, c = l1 ++ nth i c 0%nat :: l2 /\ length l1 = i /\ without i c = l1 ++ l2.
Proof.
  intros c i H. destruct (nth_split c 0%nat H) as [l1 [l2 [E L]]]. exists l1, l2. repeat split; auto.
  rewrite E at 1. rewrite <- L at 1. apply without_split.
Qed.

(* ---- Volumes ---- *)

Lemma places_app : forall rows s t, places rows (s ++ t) = places rows s ++ places rows t.
Proof. intros. apply map_app. Qed.
Lemma real_places : forall rows c, real rows c = map emb (places rows c).
Proof. intros. unfold real, places. rewrite map_map. reflexivity. Qed.
Lemma volume_real : forall n v, IZR (volume n v) = volume_of (emb n) (map emb v).
Proof.
  intros n [|a [|b [|c [|d v]]]]; simpl; auto.
  - apply emb_dot.
  - rewrite emb_dot, emb_cross. reflexivity.
  - apply emb_det.
Qed.
Lemma edges_real : forall s, map emb (edges s) = edges_of (map emb s).
Proof.
  intros [|o s]; simpl; auto. rewrite !map_map. apply map_ext. intro p. apply emb_sub.
Qed.
Lemma cell_volume_real : forall n s, cell_volume (emb n) (map emb s) = IZR (volume n (edges s)).
Proof. intros. unfold cell_volume. rewrite <- edges_real, volume_real. reflexivity. Qed.
Lemma emb_injective : forall a b, emb a = emb b -> a = b.
Proof.
  intros [x y z] [x' y' z'] H. unfold emb in H. simpl in H. injection H. intros H3 H2 H1.
  apply eq_IZR in H1, H2, H3. congruence.
Qed.

Lemma inner_side_turn : forall rows n k c i x, (i < length c <= 4)%nat ->
  inner_side rows n (facet_at k c i) x =
  signed (turn_of (facet_at k c i)) (volume n (seen_from x (places rows (samples_of (facet_at k c i))))).
Proof.
  intros rows n k c i x [B L].
  change (signed (Nat.odd i) (volume n (seen_from x (places rows (without i c)))) =
          signed (xorb false (xorb (Nat.odd i) (is_odd (without i c))))
            (volume n (seen_from x (places rows (sorted (without i c)))))).
  rewrite volume_sorted.
  - rewrite xorb_false_l, <- signed_signed. reflexivity.
  - destruct (nth_parts c i B) as [l1 [l2 [E [_ W]]]]. rewrite W. rewrite E in L.
    rewrite app_length in *. simpl in L. lia.
Qed.
Lemma inner_side_in_place : forall rows n k c i x l1 p l2, (length c <= 4)%nat -> c = l1 ++ p :: l2 -> length l1 = i ->
  inner_side rows n (facet_at k c i) x = volume n (edges (places rows l1 ++ x :: places rows l2)).
Proof.
  intros rows n k c i x l1 p l2 L -> <-. rewrite volume_in_place.
  - rewrite <- places_app. replace (length (places rows l1)) with (length l1) by (symmetry; apply map_length).
    change (signed (Nat.odd (length l1)) (volume n (seen_from x (places rows (without (length l1) (l1 ++ p :: l2))))) =
            signed (Nat.odd (length l1)) (volume n (seen_from x (places rows (l1 ++ l2))))).
    rewrite without_split. reflexivity.
  - rewrite app_length in *. simpl in *. unfold places. rewrite !map_length. auto.
Qed.
Lemma inner_side_own : forall rows n k c i, (i < length c <= 4)%nat ->
  inner_side rows n (facet_at k c i) (place rows (nth i c 0%nat)) = volume n (edges (places rows c)).
Proof.
  intros rows n k c i [B L]. destruct (nth_parts c i B) as [l1 [l2 [E [Li _]]]].
  rewrite (inner_side_in_place rows n k c i _ l1 (nth i c 0%nat) l2) by auto.
  rewrite E at 2. rewrite places_app. reflexivity.
Qed.

Lemma level_mix : forall d n o a y x, level d n o y -> level d n o x -> level d n o (mix a y x).
Proof.
  intros d n o a y x. unfold level, mix. destruct d as [|[|[|k]]]; auto; intros Hy Hx.
  - transitivity (vadd (vscale (1 - a) (cross n (vsub y o))) (vscale a (cross n (vsub x o)))).
    + apply vec_eq; vdestruct; vunfold; ring.
    + rewrite Hy, Hx. apply vec_eq; vunfold; ring.
  - transitivity ((1 - a) * dot n (vsub y o) + a * dot n (vsub x o))%R.
    + vdestruct; vunfold; ring.
    + rewrite Hy, Hx. ring.
Qed.

(* ---- What is accepted ---- *)

Record accepted (rows : list zvec) (first : simplex) (cells : list simplex) : Prop := {
  acc_names : forall c p, In c cells -> In p c -> In p (names rows);
  acc_length : forall c, In c cells -> length c = length first;
  acc_first : In first cells;
  acc_positive : forall c, In c cells -> (0 < volume (normal (places rows first)) (edges (places rows c)))%Z;
  acc_level : forall p, In p rows -> is_in_hull_of (places rows first) p = true;
  acc_delaunay : forall f g, In f (facets cells) -> In g (mates (facets cells) f) ->
    (0 <= outside (places rows (cell_of f)) (place rows (opposite g)))%Z;
  acc_paired : forall f, In f (facets cells) -> is_paired_well (facets cells) f = true;
  acc_whole : forall p, In p (names rows) -> exists c, In c cells /\ In p c }.

Section Sound.
Variable rows : list zvec.
Variable first : simplex.
Variable cells : list simplex.
Hypothesis acc : accepted rows first cells.
Let n := normal (places rows first).
Let all := facets cells.
Let P := samples rows.
Let real_cells := map (real rows) cells.
Let b := coordinate (emb n).
Let d := (length first - 1)%nat.
Let o := emb (origin (places rows first)).

Lemma cell_length : forall c, In c cells -> (2 <= length c <= 4)%nat.
Proof.
  intros c Hc. generalize (acc_positive _ _ _ acc c Hc). unfold places.
  destruct c as [|p [|q [|r [|s [|t c]]]]]; simpl; try lia.
Qed.
Lemma real_volume : forall c, In c cells -> (0 < cell_volume (emb n) (real rows c))%R.
Proof.
  intros c Hc. rewrite real_places, cell_volume_real. apply IZR_lt. apply (acc_positive _ _ _ acc); auto.
Qed.
Lemma real_volume_nonzero : forall c, In c cells -> cell_volume (emb n) (real rows c) <> 0%R.
Proof. intros c Hc. apply Rgt_not_eq. apply real_volume; auto. Qed.
Lemma real_nodup : forall c, In c cells -> NoDup (real rows c).
Proof. intros c Hc. apply (volume_nodup (emb n)). apply real_volume_nonzero; auto. Qed.
Lemma cell_of_nodup : forall c, In c cells -> NoDup c.
Proof. intros c Hc. apply (NoDup_map_inv (fun i => emb (place rows i))). apply real_nodup; auto. Qed.
Lemma place_injective : forall p q, In p (names rows) -> In q (names rows) ->
  emb (place rows p) = emb (place rows q) -> p = q.
Proof. intros p q Hp Hq E. apply emb_injective in E. apply (names_distinct rows); auto. Qed.
Lemma in_real_cells : forall u, In u real_cells <-> exists c, In c cells /\ u = real rows c.
Proof.
  intro u. unfold real_cells. rewrite in_map_iff. split; intros [c [H1 H2]]; exists c; auto.
Qed.
Lemma in_real : forall c v, In v (real rows c) -> exists i, (i < length c)%nat /\ v = emb (place rows (nth i c 0%nat)).
Proof.
  intros c v H. apply in_map_iff in H. destruct H as [p [<- H]].
  destruct (In_nth c p 0%nat H) as [i [B E]]. exists i. split; auto. congruence.
Qed.
Lemma sample_cell_points : forall c, In c cells -> incl (real rows c) P.
Proof.
  intros c Hc v Hv. apply in_map_iff in Hv. destruct Hv as [p [<- Hp]].
  apply (in_map (fun i => emb (place rows i))). apply (acc_names _ _ _ acc c); auto.
Qed.
Lemma sample_is_row : forall v, In v P -> exists p, In p (names rows) /\ v = emb (place rows p).
Proof. intros v H. apply in_map_iff in H. destruct H as [p [<- H]]. eauto. Qed.

Lemma sample_level : forall v, In v P -> level d (emb n) o v.
Proof.
  intros v Hv. destruct (sample_is_row v Hv) as [p [Hp ->]].
  generalize (acc_level _ _ _ acc _ (name_is_row rows p Hp)), (cell_length first (acc_first _ _ _ acc)).
  unfold d, o, n, is_in_hull_of, normal. generalize (place rows p). intros z.
  unfold places. destruct first as [|p0 [|p1 [|p2 [|p3 [|p4 c]]]]]; simpl length; intros H L; try lia;
    simpl edges in *; simpl level; simpl origin in *; auto.
  - rewrite <- emb_sub, <- emb_cross. apply emb_zero. apply negb_true_iff in H. rewrite <- H. reflexivity.
  - apply Z.eqb_eq in H. rewrite <- emb_sub, <- emb_dot. f_equal. exact H.
Qed.

(* The affine hull of the samples. *)
Definition in_level x := level d (emb n) o x.
Lemma in_level_mix : forall a y x, (0 <= a <= 1)%R -> in_level y -> in_level x -> in_level (mix a y x).
Proof. intros a y x _. apply level_mix. Qed.

(* Coordinates in the whole affine hull. *)
Theorem accepted_proper_level : proper_cells in_level affine P real_cells b.
Proof.
  split; auto using affine_scale, affine_minus, in_level_mix.
  - apply sample_level.
  - intros u H. apply in_real_cells in H. destruct H as [c [Hc ->]]. apply real_nodup; auto.
  - intros u H. apply in_real_cells in H. destruct H as [c [Hc ->]]. apply sample_cell_points; auto.
  - intros u v H Hv. apply in_real_cells in H. destruct H as [c [Hc ->]].
    apply coordinate_affine; auto. apply real_volume_nonzero; auto.
  - intros u v H Hv. apply in_real_cells in H. destruct H as [c [Hc ->]].
    apply coordinate_one; auto. apply real_volume_nonzero; auto.
  - intros u v w H Hv Hw D. apply in_real_cells in H. destruct H as [c [Hc ->]].
    apply coordinate_zero; auto. apply real_volume_nonzero; auto.
  - intros u h p H Ah Hp. apply in_real_cells in H. destruct H as [c [Hc ->]].
    apply (expand_vectors (emb n) (real rows c) d o); auto.
    + apply real_volume_nonzero; auto.
    + unfold real, d. rewrite map_length, (acc_length _ _ _ acc c Hc).
      generalize (cell_length first (acc_first _ _ _ acc)). lia.
    + intros v Hv. apply sample_level. apply (sample_cell_points c); auto.
Qed.
(* Coordinates in the convex hull. *)
Theorem accepted_proper : proper_cells (in_conv P) affine P real_cells b.
Proof.
  destruct accepted_proper_level as [A1 A2 A3 A4 A5 A6 A7 A8 A9 A10 A11].
  split; auto using hull_mix, point_in_conv.
  intros u h x Hu Ah Hx. apply (hull_equal h (fun x => total u (fun v => b u v x * h v)%R) P); auto.
  apply affine_total. intros. apply A1. auto.
Qed.

(* ---- Facets of real cells are those of the lists ---- *)

Lemma in_without : forall c i q, In c cells -> (i < length c)%nat ->
  (In q (without i c) <-> In q c /\ q <> nth i c 0%nat).
Proof.
  intros c i q Hc B. destruct (nth_parts c i B) as [l1 [l2 [E [_ W]]]]. rewrite W.
  generalize (cell_of_nodup c Hc). rewrite E at 1 2. set (p := nth i c 0%nat) in *. clearbody p. intro N.
  apply NoDup_remove_2 in N. rewrite !in_app_iff in *. simpl. split.
  - intros [H|H]; (split; [tauto | intros ->; tauto]).
  - intros [[H|[->|H]] D]; tauto.
Qed.
Lemma without_nodup : forall c i, In c cells -> (i < length c)%nat -> NoDup (without i c).
Proof.
  intros c i Hc B. destruct (nth_parts c i B) as [l1 [l2 [E [_ W]]]]. rewrite W.
  generalize (cell_of_nodup c Hc). rewrite E at 1. apply NoDup_remove_1.
Qed.
Lemma across_samples : forall c c' v v', In c cells -> In c' cells -> across (real rows c) v (real rows c') v' ->
  exists i j, (i < length c)%nat /\ (j < length c')%nat /\ v = emb (place rows (nth i c 0%nat)) /\
    v' = emb (place rows (nth j c' 0%nat)) /\ sorted (without i c) = sorted (without j c').
Proof.
  intros c c' v v' Hc Hc' [Hv [Hv' A]].
  destruct (in_real c v Hv) as [i [Bi Ei]]. destruct (in_real c' v' Hv') as [j [Bj Ej]].
  exists i, j. repeat split; auto.
  assert (Half : forall c c' i j, In c cells -> In c' cells -> (i < length c)%nat -> (j < length c')%nat ->
    (forall x, (In x (real rows c) /\ x <> emb (place rows (nth i c 0%nat))) ->
               (In x (real rows c') /\ x <> emb (place rows (nth j c' 0%nat)))) ->
    forall q, In q (without i c) -> In q (without j c')).
  { intros c1 c2 i1 i2 H1 H2 B1 B2 A12 q Hq. apply in_without in Hq; auto. destruct Hq as [Hq D].
    assert (Nq : In q (names rows)) by (apply (acc_names _ _ _ acc c1); auto).
    destruct (A12 (emb (place rows q))) as [I J].
    { split; [apply (in_map (fun i => emb (place rows i))); auto|]. intro E. apply D.
      apply place_injective; auto. apply (acc_names _ _ _ acc c1); auto. apply nth_In; auto. }
    apply in_map_iff in I. destruct I as [q' [E I]].
    assert (q' = q) by (apply place_injective; auto; apply (acc_names _ _ _ acc c2); auto). subst q'.
    apply in_without; auto. split; auto. intros ->. apply J. reflexivity. }
  apply sorted_permutation. apply NoDup_Permutation; try (apply without_nodup; auto).
  intro q. split; apply Half; auto; intros x Hx; subst v v'; apply A; auto.
Qed.
Lemma samples_across : forall c c' i j, In c cells -> In c' cells -> (i < length c)%nat -> (j < length c')%nat ->
  sorted (without i c) = sorted (without j c') ->
  across (real rows c) (emb (place rows (nth i c 0%nat))) (real rows c') (emb (place rows (nth j c' 0%nat))).
Proof.
  intros c c' i j Hc Hc' Bi Bj E. split; [|split].
  - apply (in_map (fun i => emb (place rows i))). apply nth_In; auto.
  - apply (in_map (fun i => emb (place rows i))). apply nth_In; auto.
  - assert (Half : forall c c' i j x, In c cells -> In c' cells -> (i < length c)%nat -> (j < length c')%nat ->
      sorted (without i c) = sorted (without j c') -> In x (real rows c) -> x <> emb (place rows (nth i c 0%nat)) ->
      In x (real rows c') /\ x <> emb (place rows (nth j c' 0%nat))).
    { intros c1 c2 i1 i2 x H1 H2 B1 B2 E12 Hx D. apply in_map_iff in Hx. destruct Hx as [q [<- Hq]].
      assert (W : In q (without i2 c2)).
      { apply in_sorted. rewrite <- E12. apply in_sorted. apply in_without; auto. split; auto. congruence. }
      apply in_without in W; auto. destruct W as [W F]. split.
      - apply (in_map (fun i => emb (place rows i))); auto.
      - intro G. apply F. apply place_injective; auto; apply (acc_names _ _ _ acc c2); auto. apply nth_In; auto. }
    intro x. split; intros [H1 H2]; [apply (Half c c' i j) | apply (Half c' c j i)]; auto.
Qed.

(* The coordinate of a sample in a cell. *)
Lemma sample_coordinate : forall k c i z, In c cells -> (i < length c)%nat ->
  b (real rows c) (emb (place rows (nth i c 0%nat))) (emb z) =
  (IZR (inner_side rows n (facet_at k c i) z) / cell_volume (emb n) (real rows c))%R.
Proof.
  intros k c i z Hc B. destruct (nth_parts c i B) as [l1 [l2 [E [Li _]]]].
  rewrite (inner_side_in_place rows n k c i z l1 (nth i c 0%nat) l2); auto; [|apply cell_length; auto].
  unfold b, coordinate. f_equal.
  assert (M : real rows c = real rows l1 ++ emb (place rows (nth i c 0%nat)) :: real rows l2).
  { rewrite E at 1. unfold real. rewrite map_app. reflexivity. }
  rewrite M, map_swap by (rewrite <- M; apply real_nodup; auto).
  rewrite <- cell_volume_real. rewrite map_app. simpl. rewrite <- !real_places. reflexivity.
Qed.
Lemma sample_coordinate_sign : forall k c i z, In c cells -> (i < length c)%nat ->
  ((0 <= inner_side rows n (facet_at k c i) z)%Z -> (0 <= b (real rows c) (emb (place rows (nth i c 0%nat))) (emb
    z))%R) /\
  ((inner_side rows n (facet_at k c i) z < 0)%Z -> (b (real rows c) (emb (place rows (nth i c 0%nat))) (emb z) < 0)%R).
Proof.
  intros k c i z Hc B. rewrite (sample_coordinate k c i z Hc B). generalize (Rinv_0_lt_compat _ (real_volume c Hc)).
  intro V. unfold Rdiv. split; intro H.
  - apply IZR_le in H. apply Rmult_le_pos; lra.
  - apply IZR_lt in H. generalize (Rmult_lt_compat_r _ _ _ V H). lra.
Qed.

(* A pair of facets: their cells are on different sides of them. *)
Lemma mate_of : forall k c i k' c' j, nth_error cells k = Some c -> nth_error cells k' = Some c' ->
  (i < length c)%nat -> (j < length c')%nat -> ~ (k = k' /\ i = j) -> sorted (without i c) = sorted (without j c') ->
  mates all (facet_at k c i) = [facet_at k' c' j] /\
  (inner_side rows n (facet_at k c i) (place rows (nth j c' 0%nat)) < 0)%Z.
Proof.
  intros k c i k' c' j Hk Hk' Bi Bj D E.
  assert (Hc : In c cells) by (eapply nth_error_In; eauto). assert (Hc' : In c' cells) by (eapply nth_error_In; eauto).
  set (f := facet_at k c i). set (g := facet_at k' c' j).
  assert (Hf : In f all) by (apply in_facets; exists k, c, i; auto).
  assert (Hg : In g (mates all f)).
  { apply in_mates. split; [apply in_facets; exists k', c', j; auto|]. split; [symmetry; exact E | exact D]. }
  generalize (acc_paired _ _ _ acc f Hf). unfold is_paired_well. fold all.
  destruct (mates all f) as [|g' [|h r]] eqn:M; [destruct Hg | | discriminate].
  destruct Hg as [->|[]]. intro T. split; auto. unfold f.
  generalize (cell_length c Hc), (cell_length c' Hc'). intros L L'.
  rewrite inner_side_turn by lia. fold f.
  generalize (inner_side_own rows n k' c' j ltac:(lia)), (acc_positive _ _ _ acc c' Hc'). fold n.
  rewrite inner_side_turn by lia. fold g.
  assert (S : samples_of g = samples_of f) by (symmetry; exact E). rewrite S.
  destruct (turn_of f), (turn_of g); simpl in *; try discriminate; lia.
Qed.
Lemma in_cells_number : forall c, In c cells -> exists k, nth_error cells k = Some c.
Proof. intros c H. apply In_nth_error. auto. Qed.

Lemma accepted_across : forall u v u' v', In u real_cells -> In u' real_cells -> u <> u' -> across u v u' v' ->
  exists k c i k' c' j, nth_error cells k = Some c /\ nth_error cells k' = Some c' /\ u = real rows c /\
    u' = real rows c' /\ (i < length c)%nat /\ (j < length c')%nat /\ v = emb (place rows (nth i c 0%nat)) /\
    v' = emb (place rows (nth j c' 0%nat)) /\
    mates all (facet_at k c i) = [facet_at k' c' j] /\
    (inner_side rows n (facet_at k c i) (place rows (nth j c' 0%nat)) < 0)%Z.
Proof.
  intros u v u' v' Hu Hu' D A. apply in_real_cells in Hu, Hu'.
  destruct Hu as [c [Hc ->]]. destruct Hu' as [c' [Hc' ->]].
  destruct (across_samples c c' v v' Hc Hc' A) as [i [j [Bi [Bj [Ev [Ev' E]]]]]].
  destruct (in_cells_number c Hc) as [k Hk]. destruct (in_cells_number c' Hc') as [k' Hk'].
  destruct (mate_of k c i k' c' j Hk Hk' Bi Bj) as [M S]; auto.
  { intros [-> _]. apply D. congruence. }
  exists k, c, i, k', c', j. repeat split; auto.
Qed.

Theorem accepted_other_side : forall u v u' v', In u real_cells -> In u' real_cells -> u <> u' -> across u v u' v' ->
  (b u v v' < 0)%R.
Proof.
  intros u v u' v' Hu Hu' D A.
  destruct (accepted_across u v u' v' Hu Hu' D A)
    as [k [c [i [k' [c' [j [Hk [Hk' [-> [-> [Bi [Bj [-> [-> [M S]]]]]]]]]]]]]]].
  apply (sample_coordinate_sign k c i); auto. eapply nth_error_In; eauto.
Qed.
Theorem accepted_one_behind : forall u v u1 v1 u2 v2, In u real_cells -> In u1 real_cells -> In u2 real_cells ->
  u <> u1 -> u <> u2 -> across u v u1 v1 -> across u v u2 v2 -> u1 = u2.
Proof.
  intros u v u1 v1 u2 v2 Hu H1 H2 D1 D2 A1 A2.
  apply in_real_cells in Hu, H1, H2. destruct Hu as [c [Hc ->]]. destruct H1 as [c1 [Hc1 ->]].
  destruct H2 as [c2 [Hc2 ->]].
  destruct (across_samples c c1 v v1 Hc Hc1 A1) as [i [j1 [Bi [B1 [Ev [_ E1]]]]]].
  destruct (across_samples c c2 v v2 Hc Hc2 A2) as [i' [j2 [Bi' [B2 [Ev' [_ E2]]]]]].
  assert (i = i').
  { apply (NoDup_nth c 0%nat); auto; [apply cell_of_nodup; auto|].
    apply place_injective; try congruence; apply (acc_names _ _ _ acc c); auto; apply nth_In; auto. }
  subst i'. destruct (in_cells_number c Hc) as [k Hk]. destruct (in_cells_number c1 Hc1) as [k1 Hk1].
  destruct (in_cells_number c2 Hc2) as [k2 Hk2].
  destruct (mate_of k c i k1 c1 j1 Hk Hk1 Bi B1) as [M1 _]; auto; [intros [-> _]; apply D1; congruence|].
  destruct (mate_of k c i k2 c2 j2 Hk Hk2 Bi B2) as [M2 _]; auto; [intros [-> _]; apply D2; congruence|].
  rewrite M1 in M2. injection M2. intros. subst. congruence.
Qed.
(* No cell is there twice. *)
Theorem accepted_once : NoDup real_cells.
Proof.
  assert (N : NoDup cells).
  { apply NoDup_nth_error. intros k k' B E. destruct (Nat.eq_dec k k') as [|D]; auto. exfalso.
    destruct (nth_error cells k) as [c|] eqn:Hk; [|apply nth_error_None in Hk; lia]. symmetry in E.
    assert (Hc : In c cells) by (eapply nth_error_In; eauto). generalize (cell_length c Hc). intro L.
    destruct (mate_of k c 0 k' c 0 Hk E) as [_ S]; auto; try lia.
    rewrite inner_side_own in S by lia. generalize (acc_positive _ _ _ acc c Hc). fold n. lia. }
  assert (Inj : forall c c', (forall p, In p c -> In p (names rows)) -> (forall p, In p c' -> In p (names rows)) ->
    real rows c = real rows c' -> c = c').
  { induction c as [|p c IH]; intros [|p' c'] H H' E; auto; try discriminate.
    assert (E1 := f_equal (hd vzero) E). assert (E2 := f_equal (@tl vec) E). f_equal.
    - apply place_injective; auto; [apply H | apply H']; left; auto.
    - apply IH; auto; intros; [apply H | apply H']; right; auto. }
  assert (G : forall l, NoDup l -> incl l cells -> NoDup (map (real rows) l)).
  { induction 1 as [|c l Hc Nl IH]; intro I; simpl; constructor.
    - intro F. apply in_map_iff in F. destruct F as [c' [E Hc']]. apply Hc. replace c with c'; auto.
      apply Inj; auto; intros; [apply (acc_names _ _ _ acc c') | apply (acc_names _ _ _ acc c)]; auto; apply I;
        [right | left]; auto.
    - apply IH. intros x Hx. apply I. right. auto. }
  apply G; auto. intros x Hx. auto.
Qed.
(* A facet has a cell on its other side, or it is on the list of facets without a mate. *)
Theorem accepted_paired : forall k c i, nth_error cells k = Some c -> (i < length c)%nat ->
  (exists u' v', In u' real_cells /\ real rows c <> u' /\ across (real rows c) (emb (place rows (nth i c 0%nat))) u'
    v') \/
  In (facet_at k c i) (hull_facets all).
Proof.
  intros k c i Hk B. assert (Hc : In c cells) by (eapply nth_error_In; eauto).
  destruct (mates all (facet_at k c i)) as [|g r] eqn:M.
  - right. unfold hull_facets. apply filter_In. split; [apply in_facets; exists k, c, i; auto|]. rewrite M. auto.
  - left. assert (Hg : In g (mates all (facet_at k c i))) by (rewrite M; left; auto).
    apply in_mates in Hg. destruct Hg as [Hg [E D]]. apply in_facets in Hg.
    destruct Hg as [k' [c' [j [Hk' [Bj ->]]]]]. simpl in E, D.
    assert (Hc' : In c' cells) by (eapply nth_error_In; eauto).
    destruct (mate_of k c i k' c' j Hk Hk' B Bj D (eq_sym E)) as [_ S].
    exists (real rows c'), (emb (place rows (nth j c' 0%nat))). split; [apply in_real_cells; eauto|].
    assert (A : across (real rows c) (emb (place rows (nth i c 0%nat))) (real rows c') (emb (place rows (nth j c'
      0%nat))))
      by (apply samples_across; auto).
    split; auto. intro F.
    (* one cell cannot be on both sides *)
    destruct A as [Hv [Hv' A]]. rewrite <- F in *.
    assert (G : emb (place rows (nth j c' 0%nat)) = emb (place rows (nth i c 0%nat))).
    { destruct (vec_eq_dec (emb (place rows (nth j c' 0%nat))) (emb (place rows (nth i c 0%nat)))) as [|N]; auto.
      destruct (proj1 (A _) (conj Hv' N)) as [_ N']. contradiction. }
    apply emb_injective in G. rewrite G in S.
    generalize (cell_length c Hc). intro L. rewrite inner_side_own in S by lia.
    generalize (acc_positive _ _ _ acc c Hc). fold n. lia.
Qed.

(* ---- T3 and T8 ---- *)

Lemma cell_scale : forall c, In c cells -> scale_of (places rows c) <> 0%Z.
Proof.
  intros c Hc. generalize (acc_positive _ _ _ acc c Hc), (cell_length c Hc). fold n. unfold scale_of, places.
  destruct c as [|p [|q [|r [|s [|t c]]]]]; simpl length; intros V L; try lia; simpl in *; try lia.
  intro Z. set (x := zcross (zsub (place rows q) (place rows p)) (zsub (place rows r) (place rows p))) in *.
  assert (zx x = 0 /\ zy x = 0 /\ zz x = 0)%Z as [X [Y W]] by (unfold zdot in Z; nia).
  unfold zdot in V. rewrite X, Y, W in V. lia.
Qed.

Theorem accepted_local : local_delaunay P real_cells.
Proof.
  split.
  - intros u Hu. apply in_real_cells in Hu. destruct Hu as [c [Hc ->]].
    exists (centre_of (places rows c)), (radius2_of (places rows c)). intros v Hv. rewrite real_places in Hv.
    apply in_map_iff in Hv. destruct Hv as [p [<- Hp]]. apply centre_on_sphere; auto.
    + unfold places. rewrite map_length. apply cell_length; auto.
    + apply cell_scale; auto.
  - intros u v u' v' z r2 Hu Hu' D A S.
    destruct (accepted_across u v u' v' Hu Hu' D A)
      as [k [c [i [k' [c' [j [Hk [Hk' [-> [-> [Bi [Bj [-> [-> [M _]]]]]]]]]]]]]]].
    assert (Hc : In c cells) by (eapply nth_error_In; eauto).
    assert (Hc' : In c' cells) by (eapply nth_error_In; eauto).
    assert (K := cell_scale c Hc).
    assert (T : (0 <= outside (places rows c) (place rows (nth j c' 0%nat)))%Z).
    { apply (acc_delaunay _ _ _ acc (facet_at k c i) (facet_at k' c' j)).
      - apply in_facets. exists k, c, i. auto.
      - fold all. rewrite M. left. auto. }
    apply IZR_le in T. rewrite outside_power in T by auto.
    rewrite (same_power P real_cells b accepted_proper (real rows c) z r2 (centre_of (places rows c))
      (radius2_of (places rows c))); auto.
    + assert (N : IZR (scale_of (places rows c)) <> 0%R) by (intro F; apply eq_IZR in F; auto).
      assert (0 < IZR (scale_of (places rows c)) * IZR (scale_of (places rows c)))%R by nra.
      apply Rmult_le_reg_l with (IZR (scale_of (places rows c)) * IZR (scale_of (places rows c)))%R; auto. lra.
    + apply point_in_conv. apply (sample_cell_points c'); auto. apply (in_map (fun i => emb (place rows i))).
      apply nth_In; auto.
    + intros v Hv. rewrite real_places in Hv. apply in_map_iff in Hv. destruct Hv as [p [<- Hp]].
      apply centre_on_sphere; auto. unfold places. rewrite map_length. apply cell_length; auto.
  - intros p Hp. destruct (sample_is_row p Hp) as [i [Hi ->]]. destruct (acc_whole _ _ _ acc i Hi) as [c [Hc Ic]].
    exists (real rows c). split; [apply in_real_cells; eauto|]. apply (in_map (fun i => emb (place rows i))); auto.
Qed.
End Sound.
