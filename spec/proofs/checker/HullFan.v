(* The facets without a mate, as they are seen from the middle o of the first cell: by T4, T5 and T7 the cones over them
   tile all directions (step 2 of the proof of FC-CERT-02), and by T6 none of their planes cuts off a point that is
   behind none of them in its own direction (step 3).
   Vectors from o are taken d + 1 times as long, so that they are integers. *)
From Coq Require Import Reals ZArith Lra Lia List Bool Permutation.
From Flowcert Require Import algebra.Vector3 spec.Hull judge.Judge judge.Dimension.
From Flowcert Require Import checker.Simplices checker.Certificate checker.Conditions checker.Faces.
From Flowcert Require Import checker.Affine checker.Volumes checker.Tiling checker.Sound checker.Checked.
Import ListNotations.
Local Arguments Z.mul : simpl never.
Local Arguments Z.add : simpl never.
Local Arguments Z.sub : simpl never.

(* ---- Lists of ridges ---- *)

Definition key_of (f : facet) (i : nat) : simplex := sorted (without i (vertices f)).
Definition ridge_at (f : facet) (i : nat) : ridge :=
  Ridge f (xorb (Nat.odd (place_of f)) (xorb (Nat.odd i) (is_odd (without i (vertices f))))) (nth i (vertices f) 0%nat).

Lemma in_ridges : forall hull key r, In (key, r) (ridges hull) <->
  exists f i, In f hull /\ (i < length (vertices f))%nat /\ key = key_of f i /\ r = ridge_at f i.
Proof.
  intros hull key r. unfold ridges. rewrite in_flat_map. split.
  - intros [f [Hf H]]. unfold ridges_of in H. apply in_map_iff in H. destruct H as [i [E H]]. apply in_seq in H.
    unfold face_of in E. injection E. intros <- <-. exists f, i. repeat split; auto; lia.
  - intros [f [i [Hf [B [-> ->]]]]]. exists f. split; auto. unfold ridges_of. apply in_map_iff. exists i.
    split; [reflexivity|]. apply in_seq. lia.
Qed.
Lemma in_at_ridge : forall all key r, In r (at_ridge all key) <-> In (key, r) all.
Proof.
  intros all key r. unfold at_ridge. rewrite in_map_iff. split.
  - intros [[k r'] [E H]]. simpl in E. subst r'. apply filter_In in H. destruct H as [H E].
    apply same_samples_spec in E. subst k. auto.
  - intro H. exists (key, r). split; auto. apply filter_In. split; auto. apply same_samples_spec. auto.
Qed.
Lemma in_keys : forall all key r, In (key, r) all -> In key (ridge_keys all).
Proof.
  assert (Keep : forall k key keys, In key keys -> In key (insert_key k keys)).
  { intros k key. induction keys as [|j keys IH]; intro H; [destruct H|]. simpl.
    destruct (same_samples j k); auto. destruct (precedes k j); [right; auto|].
    destruct H as [->|H]; [left; auto | right; auto]. }
  assert (New : forall k keys, In k (insert_key k keys)).
  { intros k. induction keys as [|j keys IH]; simpl; auto. destruct (same_samples j k) eqn:E.
    - apply same_samples_spec in E. left. auto.
    - destruct (precedes k j); [left; auto | right; auto]. }
  induction all as [|[k s] all IH]; intros key r H; [destruct H|]. simpl.
  destruct H as [E|H]; [injection E; intros; subst; apply New | apply Keep; eapply IH; eauto].
Qed.
Lemma ridges_checked : forall rows n all keys,
  fold_right (fun key rest => check_ridge rows n (at_ridge all key) rest) (Holds tt) keys = Holds tt ->
  forall key, In key keys -> exists a b, at_ridge all key = [a; b] /\ xorb (ridge_turn a) (ridge_turn b) = true /\
    (0 <= inner_side rows n (ridge_facet a) (place rows (ridge_opposite b)))%Z.
Proof.
  intros rows n all. induction keys as [|k keys IH]; intros H key Hin; [destruct Hin|]. simpl in H.
  unfold check_ridge in H at 1. destruct (at_ridge all k) as [|a [|b [|c l]]] eqn:E; try discriminate.
  apply require_holds in H. destruct H as [X H]. apply require_holds in H. destruct H as [T H].
  destruct Hin as [<-|Hin]; [|apply IH; auto]. exists a, b. apply Z.leb_le in T. auto.
Qed.

Lemma volume_first_sorted : forall n z (g : nat -> zvec) w, (length w <= 2)%nat ->
  volume n (z :: map g w) = signed (is_odd w) (volume n (z :: map g (sorted w))).
Proof.
  intros n z g w L. destruct w as [|a [|b [|c w]]]; simpl in L; try lia; auto. unfold sorted. simpl.
  rewrite Nat.ltb_antisym. destruct (Nat.leb a b); simpl; zvolumes; ring.
Qed.

Definition linear (h : vec -> R) := affine h /\ h vzero = 0%R.

Section Fan.
Variable rows : list zvec.
Variable first : simplex.
Variable cells : list simplex.
Hypothesis acc : accepted rows first cells.
Hypothesis checked : hull_checked rows first cells.
Let n := normal (places rows first).
Let all := facets cells.
Let hull := hull_facets all.
Let d := (length first - 1)%nat.

Definition toward (p : nat) : zvec := from_middle rows first p.
Definition seen (s : simplex) : list vec := map (fun p => emb (toward p)) s.
Definition rays (f : facet) : list vec := seen (vertices f).
Definition fan : list (list vec) := map rays hull.
Definition cone (u : list vec) (v x : vec) : R := coordinate (emb n) (vzero :: u) v x.
Definition in_directions (x : vec) := level d (emb n) vzero x.
Definition directions : list vec := seen (names rows).

Lemma hull_facet : forall f, In f hull -> exists k c i, nth_error cells k = Some c /\ In c cells /\
  (i < length c)%nat /\
  f = facet_at k c i /\ vertices f = without i c.
Proof.
  intros f H. unfold hull, hull_facets in H. apply filter_In in H. destruct H as [H _]. apply in_facets in H.
  destruct H as [k [c [i [Hk [B ->]]]]]. exists k, c, i. repeat split; auto. eapply nth_error_In; eauto.
Qed.
Lemma first_length : (2 <= length first <= 4)%nat.
Proof. apply (cell_length rows first cells acc). apply (acc_first _ _ _ acc). Qed.
Lemma hull_vertices : forall f, In f hull -> NoDup (vertices f) /\ length (vertices f) = d /\
  forall p, In p (vertices f) -> In p (names rows).
Proof.
  intros f H. destruct (hull_facet f H) as [k [c [i [Hk [Hc [B [-> ->]]]]]]]. split; [|split].
  - apply (without_nodup rows first cells acc); auto.
  - destruct (nth_parts c i B) as [l1 [l2 [E [_ W]]]]. rewrite W. unfold d. rewrite <- (acc_length _ _ _ acc c Hc).
    apply (f_equal (@length nat)) in E. rewrite app_length in *. simpl in E. lia.
  - intros p Hp. apply (in_without rows first cells acc) in Hp; auto. apply (acc_names _ _ _ acc c); tauto.
Qed.
Lemma toward_injective : forall p q, In p (names rows) -> In q (names rows) -> emb (toward p) = emb (toward q) -> p = q.
Proof.
  intros p q Hp Hq E. apply emb_injective in E. apply (names_distinct rows); auto.
  unfold toward, from_middle in E. set (m := Z.of_nat (length first)) in *.
  assert (0 < m)%Z by (unfold m; generalize first_length; lia).
  destruct (place rows p) as [x y z], (place rows q) as [x' y' z'], (middle rows first) as [a b c].
  unfold zsub, zscale in E. simpl in E. injection E. intros E3 E2 E1.
  f_equal; apply (Z.mul_cancel_l _ _ m); lia.
Qed.

Definition spread (f : facet) : Z := sided f (volume n (map toward (vertices f))).
Lemma spread_positive : forall f, In f hull -> (0 < spread f)%Z.
Proof. intros f H. apply Z.ltb_lt. apply (hull_sees_middle _ _ _ checked f H). Qed.
Lemma cone_volume : forall ws, cell_volume (emb n) (vzero :: map emb ws) = IZR (volume n ws).
Proof.
  intro ws. unfold cell_volume. simpl. rewrite volume_real. f_equal. rewrite map_map. apply map_ext.
  intro p. apply vec_eq; vdestruct; vunfold; ring.
Qed.
Lemma seen_toward : forall s, seen s = map emb (map toward s).
Proof. intro s. unfold seen. rewrite map_map. reflexivity. Qed.
Lemma sided_zero : forall f v, sided f v <> 0%Z -> v <> 0%Z.
Proof. intros f v H. unfold sided in H. destruct (Nat.odd (place_of f)); lia. Qed.
Lemma rays_volume : forall f, In f hull -> cell_volume (emb n) (vzero :: rays f) <> 0%R.
Proof.
  intros f H. unfold rays. rewrite seen_toward, cone_volume. intro E. apply eq_IZR in E. generalize E.
  apply (sided_zero f). generalize (spread_positive f H). unfold spread. lia.
Qed.
Lemma in_fan : forall u, In u fan <-> exists f, In f hull /\ u = rays f.
Proof. intro u. unfold fan. rewrite in_map_iff. split; intros [f [H1 H2]]; exists f; auto. Qed.
Lemma in_rays : forall f v, In v (rays f) -> exists i, (i < length (vertices f))%nat /\
  v = emb (toward (nth i (vertices f) 0%nat)).
Proof.
  intros f v H. apply in_map_iff in H. destruct H as [p [<- H]].
  destruct (In_nth _ p 0%nat H) as [i [B E]]. exists i. split; auto. congruence.
Qed.

Lemma direction_level : forall p, In p (names rows) -> in_directions (emb (toward p)).
Proof.
  clear checked. intros p Hp. unfold in_directions.
  assert (Lv : forall q, In q (names rows) -> level d (emb n) (emb (origin (places rows first))) (emb (place rows q))).
  { intros q Hq. apply (sample_level rows first cells acc). apply (in_map (fun i => emb (place rows i))). auto. }
  assert (Nf : forall q, In q first -> In q (names rows)) by (intros; apply (acc_names _ _ _ acc first); auto;
    apply acc).
  assert (Lz := Lv p Hp). assert (Lf : forall q, In q first -> level d (emb n) (emb (origin (places rows first)))
    (emb (place rows q))) by auto. clear Lv Nf. revert Lz Lf.
  unfold toward, from_middle, middle. generalize (place rows p) as z. unfold d.
  generalize (emb (origin (places rows first))) as o, (emb n) as N.
  generalize first_length. intros L o N z Lz.
  destruct first as [|q0 [|q1 [|q2 [|q3 [|q4 c]]]]]; simpl in L; try lia; simpl; intro Lf.
  - generalize (Lf q0 (or_introl eq_refl)), (Lf q1 (or_intror (or_introl eq_refl))). simpl in Lz. intros L0 L1.
    unfold places. simpl. transitivity (vsub (vscale 2 (cross N (vsub (emb z) o)))
      (vadd (cross N (vsub (emb (place rows q0)) o)) (cross N (vsub (emb (place rows q1)) o)))).
    + unfold emb, zsub, zscale, zadd. simpl. rewrite !minus_IZR, !plus_IZR, !mult_IZR.
      clear. apply vec_eq; vunfold; ring.
    + rewrite Lz, L0, L1. apply vec_eq; vunfold; ring.
  - generalize (Lf q0 (or_introl eq_refl)), (Lf q1 (or_intror (or_introl eq_refl))),
      (Lf q2 (or_intror (or_intror (or_introl eq_refl)))). simpl in Lz. intros L0 L1 L2.
    unfold places. simpl. transitivity (3 * dot N (vsub (emb z) o) - (dot N (vsub (emb (place rows q0)) o) +
      dot N (vsub (emb (place rows q1)) o) + dot N (vsub (emb (place rows q2)) o)))%R.
    + unfold emb, zsub, zscale, zadd. simpl. rewrite !minus_IZR, !plus_IZR, !mult_IZR. clear. vunfold; ring.
    + rewrite Lz, L0, L1, L2. ring.
  - exact I.
Qed.
Lemma directions_linear : forall a y c x, in_directions y -> in_directions x ->
  in_directions (vadd (vscale a y) (vscale c x)).
Proof.
  intros a y c x. unfold in_directions, level. generalize (emb n). intro N. destruct d as [|[|[|k]]]; auto.
  - intros Hy Hx. transitivity (vadd (vscale a (cross N (vsub y vzero))) (vscale c (cross N (vsub x vzero)))).
    + clear. apply vec_eq; vdestruct; vunfold; ring.
    + rewrite Hy, Hx. apply vec_eq; vunfold; ring.
  - intros Hy Hx. transitivity (a * dot N (vsub y vzero) + c * dot N (vsub x vzero))%R.
    + clear. vdestruct; vunfold; ring.
    + rewrite Hy, Hx. ring.
Qed.
Lemma zero_direction : in_directions vzero.
Proof.
  unfold in_directions, level. generalize (emb n). intro N. destruct d as [|[|[|k]]]; auto.
  - apply vec_eq; vdestruct; vunfold; ring.
  - vdestruct; vunfold; ring.
Qed.

Lemma rays_nodup : forall f, In f hull -> NoDup (vzero :: rays f).
Proof. intros f H. apply (volume_nodup (emb n)). apply rays_volume; auto. Qed.
Lemma not_zero : forall f v, In f hull -> In v (rays f) -> v <> vzero.
Proof. intros f v H Hv E. subst v. generalize (rays_nodup f H). intro N. inversion N. contradiction. Qed.

Theorem fan_proper : proper_cells in_directions linear directions fan cone.
Proof.
  split.
  - intros h [A _]. auto.
  - intros h k [A Z]. split; [apply affine_scale; auto | rewrite Z; ring].
  - intros f h [A Z] [A' Z']. split; [apply affine_minus; auto | rewrite Z, Z'; ring].
  - intros a y x _ Hy Hx. apply directions_linear; auto.
  - intros v Hv. apply in_map_iff in Hv. destruct Hv as [p [<- Hp]]. apply direction_level; auto.
  - intros u Hu. apply in_fan in Hu. destruct Hu as [f [Hf ->]]. generalize (rays_nodup f Hf). intro N. inversion N.
      auto.
  - intros u Hu. apply in_fan in Hu. destruct Hu as [f [Hf ->]]. apply incl_map. intros p Hp.
    apply (hull_vertices f Hf). auto.
  - intros u v Hu Hv. apply in_fan in Hu. destruct Hu as [f [Hf ->]]. split.
    + apply coordinate_affine; [apply rays_volume; auto | right; auto].
    + apply coordinate_zero; [apply rays_volume; auto | right; auto | left; auto |].
      intro E. apply (not_zero f v); auto.
  - intros u v Hu Hv. apply in_fan in Hu. destruct Hu as [f [Hf ->]].
    apply coordinate_one; [apply rays_volume; auto | right; auto].
  - intros u v w Hu Hv Hw D. apply in_fan in Hu. destruct Hu as [f [Hf ->]].
    apply coordinate_zero; [apply rays_volume; auto | right; auto | right; auto | auto].
  - intros u h x Hu [Ah Zh] Hx. apply in_fan in Hu. destruct Hu as [f [Hf ->]].
    destruct (hull_vertices f Hf) as [_ [L Nv]].
    rewrite (expand_vectors (emb n) (vzero :: rays f) d vzero h x); auto.
    + unfold total. simpl. rewrite Zh. unfold cone. ring.
    + apply rays_volume; auto.
    + simpl. unfold rays, seen. rewrite map_length, L. auto.
    + intros v [<-|Hv]; [apply zero_direction|]. apply in_map_iff in Hv. destruct Hv as [p [<- Hp]].
      apply direction_level; auto.
Qed.

(* ---- The coordinate of a direction in a cone, in integers ---- *)

Definition ridge_form (f : facet) (i : nat) (z : zvec) : Z :=
  signed (ridge_turn (ridge_at f i)) (volume n (z :: map toward (key_of f i))).

Lemma form_in_place : forall f i z l1 p l2, In f hull -> vertices f = l1 ++ p :: l2 -> length l1 = i ->
  ridge_form f i z = sided f (volume n (map toward l1 ++ z :: map toward l2)).
Proof.
  intros f i z l1 p l2 Hf E Li. destruct (hull_vertices f Hf) as [_ [L _]].
  assert (B : (length l1 + length l2 <= 2)%nat).
  { rewrite E, app_length in L. simpl in L. unfold d in L. generalize first_length. lia. }
  unfold ridge_form, ridge_at, key_of. simpl. rewrite E, <- Li, without_split.
  rewrite volume_first by (rewrite app_length; simpl; rewrite !map_length; lia).
  rewrite <- map_app, volume_first_sorted by (rewrite app_length; lia). rewrite map_length.
  rewrite <- !signed_signed. reflexivity.
Qed.
Lemma form_own : forall f i, In f hull -> (i < length (vertices f))%nat ->
  ridge_form f i (toward (nth i (vertices f) 0%nat)) = spread f.
Proof.
  intros f i Hf B. destruct (nth_parts (vertices f) i B) as [l1 [l2 [E [Li _]]]].
  rewrite (form_in_place f i _ l1 (nth i (vertices f) 0%nat) l2) by auto. unfold spread. rewrite E at 2.
  rewrite map_app. reflexivity.
Qed.
Lemma cone_form : forall f i z, In f hull -> (i < length (vertices f))%nat ->
  cone (rays f) (emb (toward (nth i (vertices f) 0%nat))) (emb z) = (IZR (ridge_form f i z) / IZR (spread f))%R.
Proof.
  intros f i z Hf B. destruct (nth_parts (vertices f) i B) as [l1 [l2 [E [Li _]]]].
  rewrite (form_in_place f i z l1 (nth i (vertices f) 0%nat) l2) by auto.
  set (p := nth i (vertices f) 0%nat) in *.
  assert (M : vzero :: rays f = (vzero :: seen l1) ++ emb (toward p) :: seen l2).
  { unfold rays. rewrite E at 1. unfold seen. rewrite map_app. reflexivity. }
  unfold cone, coordinate. rewrite M at 1. rewrite map_swap by (rewrite <- M; apply rays_nodup; auto).
  simpl app. rewrite !seen_toward. change (emb z :: map emb (map toward l2)) with (map emb (z :: map toward l2)).
  rewrite <- map_app, cone_volume. unfold rays. rewrite seen_toward, cone_volume. unfold spread.
  assert (S : IZR (volume n (map toward (vertices f))) <> 0%R).
  { intro F. apply eq_IZR in F. revert F. apply (sided_zero f). generalize (spread_positive f Hf). unfold spread. lia. }
  unfold sided. destruct (Nat.odd (place_of f)); auto. rewrite !opp_IZR. field. auto.
Qed.
Lemma cone_sign : forall f i z, In f hull -> (i < length (vertices f))%nat -> (ridge_form f i z < 0)%Z ->
  (cone (rays f) (emb (toward (nth i (vertices f) 0%nat))) (emb z) < 0)%R.
Proof.
  intros f i z Hf B H. rewrite cone_form by auto. apply IZR_lt in H.
  assert (V : (0 < / IZR (spread f))%R) by (apply Rinv_0_lt_compat; apply IZR_lt; apply spread_positive; auto).
  unfold Rdiv. generalize (Rmult_lt_compat_r _ _ _ V H). lra.
Qed.
End Fan.
