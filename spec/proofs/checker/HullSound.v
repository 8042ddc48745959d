(* The cones over the facets without a mate are glued well, so that they tile all directions (steps 1 and 2 of the proof
   of FC-CERT-02).
   Of the planes of these facets, a point is least inside of the one in whose cone it is (step 3). *)
From Coq Require Import Reals ZArith Lra Lia List Bool Permutation.
From Flowcert Require Import algebra.Vector3 spec.Hull judge.Judge judge.Dimension.
From Flowcert Require Import checker.Simplices checker.Certificate checker.Conditions checker.Faces.
From Flowcert Require Import checker.Affine checker.Volumes checker.Tiling checker.Sound checker.Checked
  checker.HullFan.
Import ListNotations.

(* ---- Facets of lists, and of their points ---- *)

Lemma nodup_without : forall (s : simplex) i q, NoDup s -> (i < length s)%nat ->
  (In q (without i s) <-> In q s /\ q <> nth i s 0%nat).
Proof.
  intros s i q N B. destruct (nth_parts s i B) as [l1 [l2 [E [_ W]]]]. rewrite W. rewrite E in N.
  rewrite E at 1. set (p := nth i s 0%nat) in *. clearbody p.
  apply NoDup_remove_2 in N. rewrite !in_app_iff in *. simpl. split.
  - intros [H|H]; (split; [tauto | intros ->; tauto]).
  - intros [[H|[->|H]] D]; tauto.
Qed.
Lemma without_is_nodup : forall (s : simplex) i, NoDup s -> (i < length s)%nat -> NoDup (without i s).
Proof.
  intros s i N B. destruct (nth_parts s i B) as [l1 [l2 [E [_ W]]]]. rewrite W. rewrite E in N.
  apply NoDup_remove_1 in N. auto.
Qed.
Lemma parts_of : forall A (l1 : list A) x l2 i, length l1 = i ->
  firstn i (l1 ++ x :: l2) = l1 /\ skipn (S i) (l1 ++ x :: l2) = l2.
Proof. intros A l1 x l2 i <-. induction l1 as [|a l1 [H1 H2]]; simpl; auto. rewrite H1. auto. Qed.
Section Lists.
Variable place_at : nat -> vec.
Variable known : nat -> Prop.
Hypothesis injective : forall p q, known p -> known q -> place_at p = place_at q -> p = q.
Lemma across_map : forall s s' v v', NoDup s -> NoDup s' -> (forall p, In p s -> known p) ->
  (forall p, In p s' -> known p) -> across (map place_at s) v (map place_at s') v' ->
  exists i j, (i < length s)%nat /\ (j < length s')%nat /\ v = place_at (nth i s 0%nat) /\
    v' = place_at (nth j s' 0%nat) /\ sorted (without i s) = sorted (without j s').
Proof.
  intros s s' v v' N N' Kn Kn' [Hv [Hv' A]].
  apply in_map_iff in Hv, Hv'. destruct Hv as [p [<- Hp]]. destruct Hv' as [p' [<- Hp']].
  destruct (In_nth s p 0%nat Hp) as [i [Bi Ei]]. destruct (In_nth s' p' 0%nat Hp') as [j [Bj Ej]].
  exists i, j. rewrite Ei, Ej. repeat split; auto.
  apply sorted_permutation. apply NoDup_Permutation; try (apply without_is_nodup; auto).
  intro q. rewrite !nodup_without by auto. rewrite Ei, Ej. split; intros [Hq D].
  - assert (I : In (place_at q) (map place_at s') /\ place_at q <> place_at p').
    { apply A. split; [apply in_map; auto | intro E; apply D; apply injective; auto]. }
    destruct I as [I J]. apply in_map_iff in I. destruct I as [r [E I]].
    assert (r = q) by (apply injective; auto). subst r. split; [auto | congruence].
  - assert (I : In (place_at q) (map place_at s) /\ place_at q <> place_at p).
    { apply A. split; [apply in_map; auto | intro E; apply D; apply injective; auto]. }
    destruct I as [I J]. apply in_map_iff in I. destruct I as [r [E I]].
    assert (r = q) by (apply injective; auto). subst r. split; [auto | congruence].
Qed.
Lemma map_across : forall s s' i j, NoDup s -> NoDup s' -> (forall p, In p s -> known p) ->
  (forall p, In p s' -> known p) -> (i < length s)%nat -> (j < length s')%nat ->
  sorted (without i s) = sorted (without j s') ->
  across (map place_at s) (place_at (nth i s 0%nat)) (map place_at s') (place_at (nth j s' 0%nat)).
Proof.
  intros s s' i j N N' Kn Kn' Bi Bj E. split; [apply in_map, nth_In; auto|]. split; [apply in_map, nth_In; auto|].
  assert (Half : forall s s' i j x, NoDup s -> NoDup s' -> (forall p, In p s' -> known p) ->
    (i < length s)%nat -> (j < length s')%nat -> sorted (without i s) = sorted (without j s') ->
    In x (map place_at s) -> x <> place_at (nth i s 0%nat) -> In x (map place_at s') /\ x <> place_at (nth j s' 0%nat)).
  { clear - injective. intros s s' i j x N N' Kn' Bi Bj E Hx D. apply in_map_iff in Hx. destruct Hx as [q [<- Hq]].
    assert (W : In q (without j s')).
    { apply in_sorted. rewrite <- E. apply in_sorted. apply nodup_without; auto; split; auto; congruence. }
    apply nodup_without in W; auto. destruct W as [W F]. split; [apply in_map; auto|].
    intro G. apply F. apply injective; auto. apply Kn'. apply nth_In; auto. }
  intro x. split; intros [H1 H2]; [apply (Half s s' i j) | apply (Half s' s j i)]; auto.
Qed.
End Lists.

Section HullSound.
Variable rows : list zvec.
Variable first : simplex.
Variable cells : list simplex.
Hypothesis acc : accepted rows first cells.
Hypothesis checked : hull_checked rows first cells.
Let n := normal (places rows first).
Let hull := hull_facets (facets cells).
Let toward := toward rows first.
Let rays := rays rows first.
Let fan := fan rows first cells.
Let cone := cone rows first.
Let in_directions := in_directions rows first.
Let form := ridge_form rows first.
Let corner (f : facet) i := nth i (vertices f) 0%nat.

Lemma hull_same : forall f g, In f hull -> In g hull -> rays f = rays g -> f = g.
Proof.
  intros f g Hf Hg E.
  assert (V : vertices f = vertices g).
  { destruct (hull_vertices rows first cells acc f Hf) as [_ [_ Nf]].
    destruct (hull_vertices rows first cells acc g Hg) as [_ [_ Ng]].
    unfold rays, HullFan.rays, seen in E. revert E Nf Ng. generalize (vertices f), (vertices g).
    induction s as [|a s IH]; intros [|b t] E Nf Ng; simpl in E; try discriminate; auto.
    assert (E1 := f_equal (@tl vec) E). assert (E2 := f_equal (hd vzero) E). cbn [hd tl] in E1, E2. f_equal.
    - apply (toward_injective rows first cells acc); auto; [apply Nf | apply Ng]; left; auto.
    - apply IH; auto; intros; [apply Nf | apply Ng]; right; auto. }
  destruct (hull_facet cells f Hf) as [k [c [i [Hk [_ [B [Ef Vf]]]]]]].
  destruct (hull_facet cells g Hg) as [k' [c' [j [Hk' [_ [B' [Eg Vg]]]]]]].
  assert (S : samples_of g = samples_of f) by (subst f g; simpl; congruence).
  unfold hull, hull_facets in Hf. apply filter_In in Hf. destruct Hf as [_ M].
  apply filter_In in Hg. destruct Hg as [Hg _].
  destruct (Nat.eq_dec k k') as [Ek|Dk]; [destruct (Nat.eq_dec i j) as [Ei|Di]|].
  - subst k' j. rewrite Hk in Hk'. injection Hk'. intros. subst c'. congruence.
  - exfalso. assert (F : In g (mates (facets cells) f)).
    { apply in_mates. split; auto. split; auto. subst f g. simpl. tauto. }
    destruct (mates (facets cells) f); [destruct F | discriminate].
  - exfalso. assert (F : In g (mates (facets cells) f)).
    { apply in_mates. split; auto. split; auto. subst f g. simpl. tauto. }
    destruct (mates (facets cells) f); [destruct F | discriminate].
Qed.

(* T4 and T6: what is at a ridge. *)
Lemma ridge_pair : forall f i, In f hull -> (i < length (vertices f))%nat -> exists f' i', In f' hull /\
  (i' < length (vertices f'))%nat /\ key_of f i = key_of f' i' /\
  xorb (ridge_turn (ridge_at f i)) (ridge_turn (ridge_at f' i')) = true /\
  (forall f2 i2, In f2 hull -> (i2 < length (vertices f2))%nat -> key_of f2 i2 = key_of f i ->
     ridge_at f2 i2 = ridge_at f i \/ ridge_at f2 i2 = ridge_at f' i') /\
  ((0 <= inner_side rows n f (place rows (corner f' i')))%Z \/ (0 <= inner_side rows n f' (place rows (corner f i)))%Z).
Proof.
  intros f i Hf B. assert (R := hull_ridges _ _ _ checked). fold n hull in R. unfold check_ridges in R.
  assert (Hr : In (key_of f i, ridge_at f i) (ridges hull)) by (apply in_ridges; exists f, i; auto).
  destruct (ridges hull) as [|r0 rs] eqn:Er; [destruct Hr|].
  destruct (ridges_checked rows n (r0 :: rs) _ R (key_of f i)) as [a [c [At [X T]]]]; [eapply in_keys; eauto|].
  rewrite <- Er in *.
  assert (Each : forall r, In r [a; c] -> exists f' i', In f' hull /\ (i' < length (vertices f'))%nat /\
    key_of f i = key_of f' i' /\ r = ridge_at f' i').
  { intros r H. rewrite <- At in H. apply in_at_ridge in H. apply in_ridges in H. auto. }
  assert (Any : forall f2 i2, In f2 hull -> (i2 < length (vertices f2))%nat -> key_of f2 i2 = key_of f i ->
    ridge_at f2 i2 = a \/ ridge_at f2 i2 = c).
  { intros f2 i2 H2 B2 E2. assert (H : In (ridge_at f2 i2) [a; c]).
    { rewrite <- At. apply in_at_ridge. apply in_ridges. exists f2, i2. auto. }
    destruct H as [H|[H|[]]]; auto. }
  destruct (Any f i Hf B eq_refl) as [Ea|Ec].
  - destruct (Each c) as [f' [i' [Hf' [B' [Ek Ec]]]]]; [right; left; auto|]. subst c. rewrite <- Ea in *.
    exists f', i'. repeat split; auto.
  - destruct (Each a) as [f' [i' [Hf' [B' [Ek Ea]]]]]; [left; auto|]. subst a. rewrite <- Ec in *.
    exists f', i'. repeat split; auto.
    + rewrite xorb_comm. auto.
    + intros f2 i2 H2 B2 E2. destruct (Any f2 i2 H2 B2 E2); auto.
Qed.
Lemma pair_of : forall f i f' i', In f hull -> (i < length (vertices f))%nat -> In f' hull ->
  (i' < length (vertices f'))%nat -> key_of f i = key_of f' i' -> f <> f' ->
  xorb (ridge_turn (ridge_at f i)) (ridge_turn (ridge_at f' i')) = true /\
  (forall f2 i2, In f2 hull -> (i2 < length (vertices f2))%nat -> key_of f2 i2 = key_of f i -> f2 <> f -> f2 = f') /\
  ((0 <= inner_side rows n f (place rows (corner f' i')))%Z \/ (0 <= inner_side rows n f' (place rows (corner f i)))%Z).
Proof.
  intros f i f' i' Hf B Hf' B' E D. destruct (ridge_pair f i Hf B) as [g [j [Hg [Bj [Ek [X [Any T]]]]]]].
  assert (Same : forall f2 i2, ridge_at f2 i2 = ridge_at f i -> f2 = f) by (intros f2 i2 F; injection F; auto).
  destruct (Any f' i' Hf' B' (eq_sym E)) as [F|F]; [exfalso; apply D; symmetry; eapply Same; eauto|].
  assert (Fg : f' = g /\ corner f' i' = corner g j) by (injection F; auto). destruct Fg as [Fg Fc].
  rewrite F, Fc, Fg. split; auto. split; auto.
  intros f2 i2 H2 B2 E2 D2. destruct (Any f2 i2 H2 B2 E2) as [G|G]; [exfalso; apply D2; eapply Same; eauto|].
  injection G. auto.
Qed.
Lemma form_opposite : forall f i f' i' z, key_of f i = key_of f' i' ->
  xorb (ridge_turn (ridge_at f i)) (ridge_turn (ridge_at f' i')) = true -> form f i z = (- form f' i' z)%Z.
Proof.
  intros f i f' i' z E X. unfold form, ridge_form. rewrite E.
  destruct (ridge_turn (ridge_at f i)), (ridge_turn (ridge_at f' i')); try discriminate; simpl; lia.
Qed.
Lemma rays_across : forall f f' v v', In f hull -> In f' hull -> across (rays f) v (rays f') v' ->
  exists i j, (i < length (vertices f))%nat /\ (j < length (vertices f'))%nat /\ v = emb (toward (corner f i)) /\
    v' = emb (toward (corner f' j)) /\ key_of f i = key_of f' j.
Proof.
  intros f f' v v' Hf Hf' A. destruct (hull_vertices rows first cells acc f Hf) as [N [_ Nf]].
  destruct (hull_vertices rows first cells acc f' Hf') as [N' [_ Nf']].
  apply (across_map (fun p => emb (toward p)) (fun p => In p (names rows))); auto.
  apply (toward_injective rows first cells acc).
Qed.
Lemma cone_behind : forall f i f' i', In f hull -> (i < length (vertices f))%nat -> In f' hull ->
  (i' < length (vertices f'))%nat -> key_of f i = key_of f' i' ->
  xorb (ridge_turn (ridge_at f i)) (ridge_turn (ridge_at f' i')) = true ->
  (form f i (toward (corner f' i')) < 0)%Z /\ (cone (rays f) (emb (toward (corner f i))) (emb (toward (corner f' i')))
    < 0)%R.
Proof.
  intros f i f' i' Hf B Hf' B' E X.
  assert (L : (form f i (toward (corner f' i')) < 0)%Z).
  { rewrite (form_opposite f i f' i') by auto. unfold form, corner, toward.
    rewrite (form_own rows first cells acc) by auto. generalize (spread_positive rows first cells checked f' Hf'). lia.
      }
  split; auto. apply (cone_sign rows first cells acc checked f i); auto.
Qed.

Theorem fan_pairs : paired_cells fan cone (nothing_behind in_directions cone).
Proof.
  split.
  - intros u v u' v' Hu Hu' D A. apply in_fan in Hu, Hu'. destruct Hu as [f [Hf ->]]. destruct Hu' as [f' [Hf' ->]].
    destruct (rays_across f f' v v' Hf Hf' A) as [i [j [Bi [Bj [-> [-> E]]]]]].
    destruct (pair_of f i f' j) as [X _]; auto; [congruence|]. apply cone_behind; auto.
  - intros u v u1 v1 u2 v2 Hu H1 H2 D1 D2 A1 A2. apply in_fan in Hu, H1, H2.
    destruct Hu as [f [Hf ->]]. destruct H1 as [f1 [Hf1 ->]]. destruct H2 as [f2 [Hf2 ->]].
    destruct (rays_across f f1 v v1 Hf Hf1 A1) as [i [j1 [Bi [B1 [Ev [_ E1]]]]]].
    destruct (rays_across f f2 v v2 Hf Hf2 A2) as [i' [j2 [Bi' [B2 [Ev' [_ E2]]]]]].
    destruct (hull_vertices rows first cells acc f Hf) as [N [_ Nf]].
    assert (i = i').
    { apply (NoDup_nth (vertices f) 0%nat); auto. apply (toward_injective rows first cells acc);
        [apply Nf, nth_In; auto | apply Nf, nth_In; auto |]. unfold corner, toward in *. congruence. }
    subst i'. destruct (pair_of f i f1 j1) as [_ [U _]]; auto; [congruence|].
    rewrite (U f2 j2); auto. congruence.
  - intros u v Hu Hv. apply in_fan in Hu. destruct Hu as [f [Hf ->]]. left.
    destruct (in_rays rows first f v Hv) as [i [B ->]].
    destruct (ridge_pair f i Hf B) as [f' [i' [Hf' [B' [E [X _]]]]]].
    exists (rays f'), (emb (toward (corner f' i'))). split; [apply in_fan; eauto|].
    destruct (hull_vertices rows first cells acc f Hf) as [N [_ Nf]].
    destruct (hull_vertices rows first cells acc f' Hf') as [N' [_ Nf']].
    split.
    + intro F. apply hull_same in F; auto. subst f'.
      destruct (cone_behind f i f i' Hf B Hf B' E X) as [L _].
      assert (C : corner f i' = corner f i).
      { destruct (Nat.eq_dec (corner f i') (corner f i)) as [|D]; auto. exfalso.
        assert (I : In (corner f i') (without i (vertices f))).
        { apply nodup_without; auto. split; auto. apply nth_In; auto. }
        apply (proj2 (in_sorted _ _)) in I. unfold key_of in E. rewrite E in I. apply (proj1 (in_sorted _ _)) in I.
        apply nodup_without in I; auto. tauto. }
      rewrite C in L. unfold form, corner, toward in L. rewrite (form_own rows first cells acc) in L by auto.
      generalize (spread_positive rows first cells checked f Hf). lia.
    + apply (map_across (fun p => emb (toward p)) (fun p => In p (names rows))); auto.
      apply (toward_injective rows first cells acc).
Qed.

(* ---- T7: the ray through the first facet ---- *)

Lemma linear_sum : forall h (l : list zvec), linear h -> h (emb (fold_right zadd (ZV 0 0 0) l)) = sum (map h (map emb
  l)).
Proof.
  intros h l [[g [c H]] Z]. assert (C : c = 0%R).
  { rewrite H in Z. rewrite <- Z. unfold dot, vzero. simpl. ring. }
  subst c. induction l as [|p l IH]; simpl.
  - rewrite H. unfold emb, dot. simpl. ring.
  - rewrite <- IH, !H. unfold emb, zadd, dot. simpl. rewrite !plus_IZR. ring.
Qed.
Lemma directions_sum : forall l, (forall p, In p l -> in_directions (emb p)) ->
  in_directions (emb (fold_right zadd (ZV 0 0 0) l)).
Proof.
  induction l as [|p l IH]; intro H; simpl.
  - replace (emb (ZV 0 0 0)) with vzero by reflexivity. apply zero_direction.
  - replace (emb (zadd p (fold_right zadd (ZV 0 0 0) l))) with
      (vadd (vscale 1 (emb p)) (vscale 1 (emb (fold_right zadd (ZV 0 0 0) l)))).
    + apply directions_linear; [apply H; left; auto | apply IH; intros; apply H; right; auto].
    + unfold emb, zadd. apply vec_eq; simpl; rewrite plus_IZR; ring.
Qed.

Definition first_ray (f : facet) : vec := emb (fold_right zadd (ZV 0 0 0) (map toward (vertices f))).

Theorem ray_once : exists f, In f hull /\ inside in_directions cone (rays f) (first_ray f) /\
  (forall v, In v (rays f) -> cone (rays f) v (first_ray f) = 1%R) /\
  forall g, In g hull -> g <> f -> exists v, In v (rays g) /\ (cone (rays g) v (first_ray f) < 0)%R.
Proof.
  assert (T := hull_ray _ _ _ checked). assert (R := hull_ridges _ _ _ checked). fold hull n in T, R.
  destruct hull as [|f others] eqn:Eh; [discriminate|].
  assert (Hf : In f hull) by (rewrite Eh; left; auto). exists f. split; [left; auto|].
  assert (Own : forall v, In v (rays f) -> cone (rays f) v (first_ray f) = 1%R).
  { intros v Hv. unfold first_ray.
    assert (Lc : linear (cone (rays f) v)).
    { apply (coord_lin (fan_proper rows first cells acc checked)); auto. apply in_fan. eauto. }
    rewrite (linear_sum _ _ Lc). rewrite map_map.
    change (map (fun x => emb (toward x)) (vertices f)) with (rays f).
    fold (total (rays f) (cone (rays f) v)). rewrite map_map.
    rewrite <- (map_map (fun p => emb (toward p)) (cone (rays f) v)).
    change (map (fun p => emb (toward p)) (vertices f)) with (rays f). fold (total (rays f) (cone (rays f) v)).
    assert (Nr : NoDup (rays f)) by (generalize (rays_nodup rows first cells checked f Hf); intro N; inversion N; auto).
    rewrite (total_one (rays f) v); auto.
    - apply (coord_one (fan_proper rows first cells acc checked)); auto. apply in_fan. eauto.
    - intros w Hw D. apply (coord_zero (fan_proper rows first cells acc checked)); auto. apply in_fan. eauto. }
  split; [split|split; auto].
  - apply directions_sum. intros z Hz. apply in_map_iff in Hz. destruct Hz as [p [<- Hp]].
    apply (direction_level rows first cells acc). apply (hull_vertices rows first cells acc f Hf). auto.
  - intros v Hv. rewrite Own by auto. lra.
  - intros g [<-|Hg] D; [contradiction|].
    assert (Hg' : In g hull) by (rewrite Eh; right; auto).
    unfold ray_is_free in T. rewrite forallb_forall in T. apply T in Hg. apply negb_true_iff in Hg.
    unfold meets_ray in Hg.
    assert (G : forall (h : nat -> bool) l, forallb h l = false -> exists i, In i l /\ h i = false).
    { clear. induction l as [|i l IH]; intro H; [discriminate|]. simpl in H. destruct (h i) eqn:E.
      - destruct (IH H) as [j [Hj Ej]]. exists j. split; [right; auto | auto].
      - exists i. split; [left; auto | auto]. }
    apply G in Hg. destruct Hg as [i [Hi F]]. apply in_seq in Hi. rewrite map_length in Hi. apply Z.leb_gt in F.
    assert (B : (i < length (vertices g))%nat) by lia.
    exists (emb (toward (corner g i))). split.
    + unfold rays, HullFan.rays, seen. apply (in_map (fun p => emb (HullFan.toward rows first p))). apply nth_In; auto.
    + apply (cone_sign rows first cells acc checked g i); auto.
      destruct (nth_parts (vertices g) i B) as [l1 [l2 [E [Li _]]]].
      rewrite (form_in_place rows first cells acc g i _ l1 (nth i (vertices g) 0%nat) l2) by auto.
      assert (W : map toward (vertices g) = map toward l1 ++ toward (nth i (vertices g) 0%nat) :: map toward l2)
        by (rewrite E at 1; apply map_app).
      set (ray := fold_right zadd (ZV 0 0 0) (map toward (vertices f))).
      assert (F' : (sided g (volume n (firstn i (map toward (vertices g)) ++ ray :: skipn (S i) (map toward (vertices
        g))))
        < 0)%Z) by exact F.
      rewrite W in F'. destruct (parts_of _ (map toward l1) (toward (nth i (vertices g) 0%nat)) (map toward l2) i) as
        [P1 P2];
        [rewrite map_length; auto|]. rewrite P1, P2 in F'. exact F'.
Qed.
Theorem fan_glued : glued_cells in_directions fan cone.
Proof.
  split; [exact fan_pairs|]. destruct ray_once as [f [Hf [I [_ Far]]]].
  exists (rays f), (first_ray f). split; [apply in_fan; eauto|]. split; auto.
  intros u Hu D. apply in_fan in Hu. destruct Hu as [g [Hg ->]]. apply Far; auto. intro F. apply D. rewrite F.
    reflexivity.
Qed.

(* ---- How far a point is inside of a facet's plane: 1 at o, 0 on the plane ---- *)

Definition depth (u : list vec) (x : vec) : R := coordinate (emb n) (vzero :: u) vzero x.

Lemma depth_affine : forall f, In f hull -> affine (depth (rays f)).
Proof.
  intros f Hf. apply coordinate_affine; [apply (rays_volume rows first cells checked); auto | left; auto].
Qed.
Lemma depth_middle : forall f, In f hull -> depth (rays f) vzero = 1%R.
Proof. intros f Hf. apply coordinate_one; [apply (rays_volume rows first cells checked); auto | left; auto]. Qed.
Lemma depth_ray : forall f v, In f hull -> In v (rays f) -> depth (rays f) v = 0%R.
Proof.
  intros f v Hf Hv. apply coordinate_zero; [apply (rays_volume rows first cells checked); auto | left; auto |
    right; auto | apply (not_zero rows first cells checked f); auto].
Qed.

Lemma depth_sample : forall f q, In f hull ->
  ((0 <= inner_side rows n f (place rows q))%Z -> (0 <= depth (rays f) (emb (toward q)))%R) /\
  ((inner_side rows n f (place rows q) < 0)%Z -> (depth (rays f) (emb (toward q)) < 0)%R).
Proof.
  intros f q Hf. set (m := Z.of_nat (length first)).
  assert (Pm : (0 < m)%Z) by (unfold m; generalize (first_length rows first cells acc); lia).
  destruct (hull_vertices rows first cells acc f Hf) as [_ [L _]]. assert (Lf := first_length rows first cells acc).
  assert (Ed : depth (rays f) (emb (toward q)) =
    (IZR (volume n (seen_from (toward q) (map toward (vertices f)))) / IZR (volume n (map toward (vertices f))))%R).
  { unfold depth, coordinate. change (vzero :: rays f) with ([] ++ vzero :: rays f).
    rewrite map_swap by (apply (rays_nodup rows first cells checked); auto). simpl app.
    assert (C1 : cell_volume (emb n) (vzero :: rays f) = IZR (volume n (map toward (vertices f)))).
    { unfold rays, HullFan.rays. rewrite seen_toward. apply cone_volume. }
    assert (C2 : emb (toward q) :: rays f = map emb (toward q :: map toward (vertices f))).
    { unfold rays, HullFan.rays. rewrite seen_toward. reflexivity. }
    rewrite C1, C2, cell_volume_real. reflexivity. }
  assert (Scaled : exists k, (0 < k)%Z /\ volume n (seen_from (toward q) (map toward (vertices f))) =
    (k * volume n (seen_from (place rows q) (places rows (vertices f))))%Z).
  { assert (Diff : forall p, zsub (toward p) (toward q) = zscale m (zsub (place rows p) (place rows q))).
    { intro p. unfold toward, HullFan.toward, from_middle. fold m. unfold zsub, zscale. simpl. f_equal; ring. }
    unfold seen_from, places. rewrite !map_map. revert L. generalize (vertices f).
    intros w L. destruct w as [|a [|b [|c [|e w]]]]; simpl in L; try lia; simpl; rewrite ?Diff.
    - exists m. split; auto. zvolumes. unfold zscale. simpl. ring.
    - exists (m * m)%Z. split; [nia|]. zvolumes. unfold zscale. simpl. ring.
    - exists (m * m * m)%Z. split; [nia|]. zvolumes. unfold zscale. simpl. ring. }
  destruct Scaled as [k [Pk Ek]]. rewrite Ed, Ek, mult_IZR. apply IZR_lt in Pk.
  generalize (spread_positive rows first cells checked f Hf). unfold spread, inner_side, sided. fold toward n.
  generalize (volume n (seen_from (place rows q) (places rows (vertices f)))) as x.
  generalize (volume n (map toward (vertices f))) as s. intros s x.
  destruct (Nat.odd (place_of f)); intro S; apply IZR_lt in S; split; intro H;
    first [apply IZR_le in H | apply IZR_lt in H]; rewrite ?opp_IZR in *.
  - replace (IZR k * IZR x / IZR s)%R with (IZR k * (- IZR x) * / (- IZR s))%R by (field; lra).
    apply Rmult_le_pos; [apply Rmult_le_pos; lra | apply Rlt_le, Rinv_0_lt_compat; lra].
  - replace (IZR k * IZR x / IZR s)%R with (- (IZR k * IZR x * / (- IZR s)))%R by (field; lra).
    assert (0 < IZR k * IZR x * / (- IZR s))%R; [|lra].
    apply Rmult_lt_0_compat; [apply Rmult_lt_0_compat; lra | apply Rinv_0_lt_compat; lra].
  - apply Rmult_le_pos; [apply Rmult_le_pos; lra | apply Rlt_le, Rinv_0_lt_compat; lra].
  - replace (IZR k * IZR x / IZR s)%R with (- (IZR k * (- IZR x) * / IZR s))%R by (field; lra).
    assert (0 < IZR k * (- IZR x) * / IZR s)%R; [|lra].
    apply Rmult_lt_0_compat; [apply Rmult_lt_0_compat; lra | apply Rinv_0_lt_compat; lra].
Qed.

(* T6, both ways. *)
Lemma depth_behind : forall f i f' i', In f hull -> (i < length (vertices f))%nat -> In f' hull ->
  (i' < length (vertices f'))%nat -> key_of f i = key_of f' i' -> f <> f' ->
  (0 <= depth (rays f) (emb (toward (corner f' i'))))%R.
Proof.
  intros f i f' i' Hf B Hf' B' E D. assert (FP := fan_proper rows first cells acc checked).
  destruct (pair_of f i f' i') as [X [_ T]]; auto.
  destruct T as [T|T]; [apply (depth_sample f); auto|].
  (* the difference of both depths vanishes on the ridge *)
  assert (T' : (0 <= depth (rays f') (emb (toward (corner f i))))%R) by (apply (depth_sample f'); auto).
  set (v := emb (toward (corner f i))) in *. set (v' := emb (toward (corner f' i'))).
  assert (A : across (rays f) v (rays f') v').
  { destruct (hull_vertices rows first cells acc f Hf) as [N [_ Nf]].
    destruct (hull_vertices rows first cells acc f' Hf') as [N' [_ Nf']].
    apply (map_across (fun p => emb (toward p)) (fun p => In p (names rows))); auto.
    apply (toward_injective rows first cells acc). }
  set (h := fun x => (depth (rays f') x - depth (rays f) x)%R).
  assert (Lh : linear h).
  { split; [apply affine_minus; apply depth_affine; auto|]. unfold h. rewrite !depth_middle by auto. ring. }
  assert (Hu : In (rays f) fan) by (apply in_fan; eauto).
  assert (Dv : in_directions v').
  { apply (direction_level rows first cells acc). apply (hull_vertices rows first cells acc f' Hf'). apply nth_In;
      auto. }
  destruct A as [Hv [Hv' A]].
  assert (Ex : h v' = (cone (rays f) v v' * h v)%R).
  { rewrite (expand FP (rays f) h v') by auto. apply (total_one (rays f) v (fun w => (cone (rays f) w v' * h w)%R));
      auto.
    - apply (cell_nodup FP); auto.
    - intros w Hw Dw. destruct (proj1 (A w)) as [Iw _]; auto. unfold h. rewrite !depth_ray by auto. ring. }
  destruct (cone_behind f i f' i' Hf B Hf' B' E X) as [_ Neg]. fold v v' in Neg.
  unfold h in Ex. rewrite (depth_ray f' v'), (depth_ray f v) in Ex by auto.
  assert (0 <= (- cone (rays f) v v') * depth (rays f') v)%R by (apply Rmult_le_pos; lra). lra.
Qed.

(* A point is least inside of the facet in whose cone it is. *)
Theorem least_depth : forall f g x, In f hull -> In g hull -> in_cell in_directions cone (rays f) x ->
  (depth (rays f) x <= depth (rays g) x)%R.
Proof.
  intros f g x Hf Hg Hx. assert (FP := fan_proper rows first cells acc checked).
  destruct (hull_vertices rows first cells acc g Hg) as [_ [L _]].
  assert (Lf := first_length rows first cells acc).
  assert (Hv : In (emb (toward (corner g 0))) (rays g)).
  { unfold rays, HullFan.rays, seen. apply (in_map (fun p => emb (HullFan.toward rows first p))). apply nth_In. lia. }
  apply (least_value FP fan_glued depth (rays f) (rays g) x (emb (toward (corner g 0)))); auto; try (apply in_fan;
    eauto).
  split.
  - intros u u' Hu Hu'. apply in_fan in Hu, Hu'. destruct Hu as [h [Hh ->]]. destruct Hu' as [h' [Hh' ->]].
    split; [apply affine_minus; apply depth_affine; auto | rewrite !depth_middle by auto; ring].
  - intros u v u' v' Hu Hu' D A. apply in_fan in Hu, Hu'. destruct Hu as [h [Hh ->]]. destruct Hu' as [h' [Hh' ->]].
    split.
    + intros w Hw Dw. destruct A as [_ [_ A]]. destruct (proj2 (A w)) as [Iw _]; auto. rewrite !depth_ray; auto.
    + destruct (rays_across h h' v v' Hh Hh' A) as [i [j [Bi [Bj [-> [-> E]]]]]].
      apply Rle_trans with 0%R; [right; apply (depth_ray h'); auto; apply (proj1 (proj2 A))|].
      apply (depth_behind h i h' j); auto. intro F. apply D. rewrite F. reflexivity.
Qed.
End HullSound.
