(* What the checker computes with lists of samples: sorted faces and their parity, the samples' names, and places that
   are put back. *)
From Coq Require Import ZArith Lia List Bool Permutation.
From Flowcert Require Import judge.Judge checker.Simplices checker.Conditions.
Import ListNotations.
Open Scope Z_scope.

(* ---- Sorted faces ---- *)

Lemma insert_insert : forall a b l, insert a (insert b l) = insert b (insert a l).
Proof.
  intros a b.
  assert (Done : forall x y l, Nat.leb x y = Nat.leb y x -> x :: y :: l = y :: x :: l).
  { intros x y l H. destruct (Nat.leb_spec x y); destruct (Nat.leb_spec y x); try discriminate; try lia.
    replace x with y by lia. auto. }
  induction l as [|c l IH]; simpl.
  - destruct (Nat.leb a b) eqn:A; destruct (Nat.leb b a) eqn:B; auto; apply Done; congruence.
  - destruct (Nat.leb b c) eqn:B; destruct (Nat.leb a c) eqn:A; simpl; rewrite ?A, ?B; auto; try (rewrite IH; auto);
      destruct (Nat.leb a b) eqn:C; destruct (Nat.leb b a) eqn:D; rewrite ?A, ?B; auto; try (apply Done; congruence).
    all: exfalso; rewrite ?Nat.leb_le, ?Nat.leb_gt in *; lia.
Qed.
Lemma sorted_permutation : forall s t, Permutation s t -> sorted s = sorted t.
Proof.
  unfold sorted. induction 1; simpl; auto.
  - rewrite IHPermutation. auto.
  - apply insert_insert.
  - congruence.
Qed.
Lemma insert_permutation : forall a l, Permutation (insert a l) (a :: l).
Proof.
  intros a. induction l as [|b l IH]; simpl; auto. destruct (Nat.leb a b); auto.
  apply perm_trans with (b :: a :: l); [constructor; auto | constructor].
Qed.
Lemma sorted_is_permutation : forall s, Permutation (sorted s) s.
Proof.
  unfold sorted. induction s as [|a s IH]; simpl; auto.
  apply perm_trans with (a :: fold_right insert [] s); [apply insert_permutation | constructor; auto].
Qed.
Lemma in_sorted : forall s a, In a (sorted s) <-> In a s.
Proof.
  intros s a. split; apply Permutation_in; [|apply Permutation_sym]; apply sorted_is_permutation.
Qed.

Lemma same_samples_spec : forall s t, same_samples s t = true <-> s = t.
Proof.
  unfold same_samples. induction s as [|a s IH]; intros [|b t]; split; intro H; auto; try discriminate.
  - apply andb_true_iff in H. destruct H as [H K]. apply Nat.eqb_eq in H. apply IH in K. congruence.
  - injection H. intros -> ->. rewrite Nat.eqb_refl. simpl. apply IH. auto.
Qed.
Lemma has_sample_spec : forall s p, has_sample s p = true <-> In p s.
Proof.
  intros s p. unfold has_sample. rewrite existsb_exists. split.
  - intros [q [H E]]. apply Nat.eqb_eq in E. congruence.
  - intro H. exists p. split; auto. apply Nat.eqb_refl.
Qed.
Lemma is_face_spec : forall s t, is_face s t = true <-> incl s t.
Proof.
  intros s t. unfold is_face. rewrite forallb_forall. split; intros H p Hp; apply has_sample_spec; auto.
Qed.

Lemma without_split : forall (l1 : simplex) p l2, without (length l1) (l1 ++ p :: l2) = l1 ++ l2.
Proof.
  intros. unfold without. rewrite firstn_app, Nat.sub_diag, firstn_all, firstn_O, app_nil_r.
  rewrite skipn_app. replace (S (length l1) - length l1)%nat with 1%nat by lia.
  rewrite skipn_all2 by lia. reflexivity.
Qed.

(* ---- Volumes and orientation ---- *)

Definition signed (odd : bool) (v : Z) : Z := if odd then - v else v.
Lemma signed_signed : forall a b v, signed a (signed b v) = signed (xorb a b) v.
Proof. intros [] [] v; simpl; lia. Qed.

Ltac zvolumes := unfold volume, zdet, zdot, zcross, zsub; simpl.

Lemma volume_sorted : forall rows n x w, (length w <= 3)%nat ->
  volume n (seen_from x (places rows w)) = signed (is_odd w) (volume n (seen_from x (places rows (sorted w)))).
Proof.
  intros rows n x w L. unfold places, seen_from. rewrite !map_map.
  generalize (fun y => zsub (place rows y) x). intro f.
  assert (G : forall a b, Nat.ltb b a = negb (Nat.leb a b)) by (intros; apply Nat.ltb_antisym).
  destruct w as [|a [|b [|c [|d w]]]]; simpl in L; try lia; unfold sorted; simpl; auto.
  - rewrite G. destruct (Nat.leb a b); zvolumes; ring.
  - rewrite !G. destruct (Nat.leb b c) eqn:BC; simpl; destruct (Nat.leb a b) eqn:AB; destruct (Nat.leb a c) eqn:AC;
      simpl; rewrite ?AB, ?AC; zvolumes; try ring.
    all: rewrite ?Nat.leb_le, ?Nat.leb_gt in *; lia.
Qed.

(* The volume of a cell with x in the place i is that of the others, as they are seen from x. *)
Lemma volume_in_place : forall n l1 x l2, (length (l1 ++ x :: l2) <= 4)%nat ->
  volume n (edges (l1 ++ x :: l2)) = signed (Nat.odd (length l1)) (volume n (seen_from x (l1 ++ l2))).
Proof.
  intros n l1 x l2 L. rewrite app_length in L. simpl in L.
  destruct l1 as [|p [|q [|r [|s l1]]]]; destruct l2 as [|p' [|q' [|r' [|s' l2]]]]; simpl in L; try lia;
    try reflexivity; simpl; zvolumes; ring.
Qed.
(* The same of the vectors of a facet: the one at the place i comes first. *)
Lemma volume_first : forall n l1 x l2, (length (l1 ++ x :: l2) <= 3)%nat ->
  volume n (l1 ++ x :: l2) = signed (Nat.odd (length l1)) (volume n (x :: l1 ++ l2)).
Proof.
  intros n l1 x l2 L. rewrite app_length in L. simpl in L.
  destruct l1 as [|p [|q [|r [|s l1]]]]; destruct l2 as [|p' [|q' [|r' [|s' l2]]]]; simpl in L; try lia;
    try reflexivity; simpl; zvolumes; ring.
Qed.

(* ---- Names ---- *)

Lemma same_place_spec : forall p q, same_place p q = true <-> p = q.
Proof.
  intros [a b c] [d e f]. unfold same_place. simpl. rewrite !andb_true_iff, !Z.eqb_eq. split.
  - intros [[-> ->] ->]. auto.
  - intro H. injection H. auto.
Qed.
Lemma names_from_range : forall l i before j, In j (names_from i before l) ->
  (i <= j < i + length l)%nat /\ ~ In (nth (j - i) l (ZV 0 0 0)) before.
Proof.
  induction l as [|p l IH]; intros i before j H; simpl in H; [destruct H|].
  assert (Rec : forall b', In j (names_from (S i) b' l) -> (forall q, In q before -> In q b') ->
    (i <= j < i + length (p :: l))%nat /\ ~ In (nth (j - i) (p :: l) (ZV 0 0 0)) before).
  { intros b' H' Sub. apply IH in H'. destruct H' as [B N]. split; [simpl; lia|].
    replace (j - i)%nat with (S (j - S i)) by lia. simpl. intro F. apply N. auto. }
  destruct (existsb (same_place p) before) eqn:E.
  - apply (Rec before); auto.
  - destruct H as [<-|H]; [|apply (Rec (p :: before)); auto; intros; right; auto].
    split; [simpl; lia|]. rewrite Nat.sub_diag. simpl. intro F.
    assert (existsb (same_place p) before = true); [|congruence].
    apply existsb_exists. exists p. split; auto. apply same_place_spec. auto.
Qed.
Lemma names_from_distinct : forall l i before j k, In j (names_from i before l) -> In k (names_from i before l) ->
  nth (j - i) l (ZV 0 0 0) = nth (k - i) l (ZV 0 0 0) -> j = k.
Proof.
  induction l as [|p l IH]; intros i before j k Hj Hk E; simpl in Hj, Hk; [destruct Hj|].
  assert (Shift : forall b' m, In m (names_from (S i) b' l) ->
    nth (m - i) (p :: l) (ZV 0 0 0) = nth (m - S i) l (ZV 0 0 0)).
  { intros b' m H. apply names_from_range in H. replace (m - i)%nat with (S (m - S i)) by lia. reflexivity. }
  destruct (existsb (same_place p) before).
  - rewrite (Shift before j), (Shift before k) in E by auto. eapply IH; eauto.
  - assert (New : forall m, In m (names_from (S i) (p :: before) l) -> nth (m - S i) l (ZV 0 0 0) <> p).
    { intros m H F. apply names_from_range in H. apply H. rewrite F. left. auto. }
    destruct Hj as [<-|Hj]; destruct Hk as [<-|Hk]; auto.
    + rewrite Nat.sub_diag, (Shift _ k Hk) in E. simpl in E. exfalso. apply (New k); auto.
    + rewrite Nat.sub_diag, (Shift _ j Hj) in E. simpl in E. exfalso. apply (New j); auto.
    + rewrite (Shift _ j Hj), (Shift _ k Hk) in E. eapply IH; eauto.
Qed.
Lemma names_from_whole : forall l i before p, In p l -> In p before \/ exists j, In j (names_from i before l) /\
  nth (j - i) l (ZV 0 0 0) = p.
Proof.
  induction l as [|q l IH]; intros i before p H; [destruct H|]. simpl.
  assert (Rec : forall b', In p l -> In p b' \/ exists j, In j (names_from (S i) b' l) /\
    nth (j - i) (q :: l) (ZV 0 0 0) = p).
  { intros b' Hp. destruct (IH (S i) b' p Hp) as [B|[j [Hj E]]]; [left; auto|]. right. exists j. split; auto.
    apply names_from_range in Hj. replace (j - i)%nat with (S (j - S i)) by lia. auto. }
  destruct (existsb (same_place q) before) eqn:E.
  - apply existsb_exists in E. destruct E as [r [Hr E]]. apply same_place_spec in E. subst r.
    destruct H as [<-|H]; auto.
  - destruct H as [<-|H].
    + right. exists i. split; [left; auto|]. rewrite Nat.sub_diag. reflexivity.
    + destruct (Rec (q :: before) H) as [[<-|B]|[j [Hj F]]]; auto.
      * right. exists i. split; [left; auto|]. rewrite Nat.sub_diag. reflexivity.
      * right. exists j. split; [right; auto | auto].
Qed.

Lemma name_is_row : forall rows i, In i (names rows) -> In (place rows i) rows.
Proof. intros rows i H. apply names_from_range in H. apply nth_In. lia. Qed.
Lemma names_distinct : forall rows i j, In i (names rows) -> In j (names rows) -> place rows i = place rows j -> i = j.
Proof.
  intros rows i j Hi Hj E. apply (names_from_distinct rows 0 [] i j); auto. rewrite !Nat.sub_0_r. exact E.
Qed.
Lemma names_whole : forall rows p, In p rows -> exists i, In i (names rows) /\ place rows i = p.
Proof.
  intros rows p H. destruct (names_from_whole rows 0 [] p H) as [[]|[j [Hj E]]].
  exists j. split; auto. rewrite Nat.sub_0_r in E. exact E.
Qed.
Lemma names_nodup : forall rows, NoDup (names rows).
Proof.
  intro rows. unfold names. generalize 0%nat, (@nil zvec). induction rows as [|p rows IH]; intros i before; simpl;
    [constructor|]. destruct (existsb (same_place p) before); auto. constructor; auto.
  intro F. apply names_from_range in F. lia.
Qed.
