(* FC-IN-03: rows have a merged set, and what a record says of rows is what CriticalPoint.v says of the merged set. *)
From Coq Require Import Reals ZArith Lia List Sorted.
From Flowcert Require Import algebra.Vector3 spec.Hull spec.CriticalPoint spec.Stationary spec.StationaryPoint.
Import ListNotations.

(* N is the names of the classes, ascending, and Q the points of the classes in this order. *)
Definition merged P N Q :=
  StronglySorted Z.lt N /\ (forall i, In i N <-> exists p, class_name P i p) /\ Forall2 (class_name P) N Q.
Definition place_in (N : list Z) l k := (0 <= l)%Z /\ nth_error N (Z.to_nat l) = Some k.

(* ---- Names ---- *)

Lemma class_name_exists : forall P p, In p P -> exists i, class_name P i p.
Proof.
  intros P p H. apply In_nth_error in H. destruct H as [n H]. revert H.
  induction n as [n IH] using (well_founded_induction lt_wf). intros H.
  destruct (Classical_Prop.classic (exists m, (m < n)%nat /\ nth_error P m = Some p)) as [[m [Hm E]]|No].
  - apply (IH m Hm E).
  - exists (Z.of_nat n). split; [split; [lia | rewrite Nat2Z.id; auto]|]. intros j [Hj Ej].
    destruct (Z_le_gt_dec (Z.of_nat n) j) as [|G]; auto. exfalso. apply No. exists (Z.to_nat j). split; [lia | auto].
Qed.

Lemma class_name_point : forall P i p q, class_name P i p -> class_name P i q -> p = q.
Proof. intros P i p q [[_ H] _] [[_ H'] _]. rewrite H in H'. injection H'; auto. Qed.
Lemma class_name_in : forall P i p, class_name P i p -> In p P.
Proof. intros P i p [H _]. eapply point_at_in; eauto. Qed.

Lemma class_name_app : forall P q i p, class_name P i p -> class_name (P ++ [q]) i p.
Proof.
  intros P q i p [[Hi E] Least]. assert (L : (Z.to_nat i < length P)%nat) by (apply nth_error_Some; congruence).
  split; [split; [auto | rewrite nth_error_app1; auto]|]. intros j [Hj Ej].
  destruct (Z_lt_le_dec j (Z.of_nat (length P))) as [B|B]; [|lia].
  apply Least. split; auto. rewrite nth_error_app1 in Ej by lia. auto.
Qed.
Lemma class_name_app_inv : forall P q i p, class_name (P ++ [q]) i p ->
  class_name P i p \/ (p = q /\ ~ In q P /\ i = Z.of_nat (length P)).
Proof.
  intros P q i p [[Hi E] Least]. destruct (Z_lt_le_dec i (Z.of_nat (length P))) as [B|B].
  - left. rewrite nth_error_app1 in E by lia. split; [split; auto|]. intros j [Hj Ej]. apply Least. split; auto.
    rewrite nth_error_app1; auto. apply nth_error_Some. congruence.
  - right. rewrite nth_error_app2 in E by lia.
    destruct (Z.to_nat i - length P)%nat as [|n] eqn:D; [|destruct n; discriminate].
    injection E; intros <-. split; auto. split; [|lia]. intros H. apply In_nth_error in H. destruct H as [m Hm].
    assert (M : (m < length P)%nat) by (apply nth_error_Some; congruence).
    assert (i <= Z.of_nat m)%Z; [|lia]. apply Least. split; [lia|]. rewrite Nat2Z.id, nth_error_app1; auto.
Qed.

Lemma sorted_app : forall N k, StronglySorted Z.lt N -> (forall i, In i N -> (i < k)%Z) ->
  StronglySorted Z.lt (N ++ [k]).
Proof.
  induction N as [|a N IH]; intros k S H; simpl; [repeat constructor|]. inversion S as [|? ? S' F]; subst.
  constructor; [apply IH; auto; intros; apply H; right; auto|]. apply Forall_app. split; auto. constructor; auto.
  apply H. left. auto.
Qed.
Lemma Forall2_impl_in : forall (A B : Type) (R S : A -> B -> Prop) l m,
  (forall a b, R a b -> S a b) -> Forall2 R l m -> Forall2 S l m.
Proof. intros A B R S l m H F. induction F; constructor; auto. Qed.

Theorem merged_exists : forall P, exists N Q, merged P N Q.
Proof.
  induction P as [|q P IH] using rev_ind.
  - exists [], []. split; [constructor|]. split; [|constructor]. intros i. split; [intros []|].
    intros [p [[_ H] _]]. destruct (Z.to_nat i); discriminate.
  - destruct IH as [N [Q [S [Names Points]]]].
    assert (Points' := Forall2_impl_in _ _ _ _ _ _ (class_name_app P q) Points).
    assert (Keep : forall i, In i N -> exists p, class_name (P ++ [q]) i p).
    { intros i Hi. apply Names in Hi. destruct Hi as [p Hp]. exists p. apply class_name_app; auto. }
    destruct (Classical_Prop.classic (In q P)) as [Old|New].
    + exists N, Q. split; auto. split; auto. intros i. split; auto. intros [p H].
      destruct (class_name_app_inv _ _ _ _ H) as [H'|[_ [No _]]]; [|contradiction]. apply Names. exists p. auto.
    + set (k := Z.of_nat (length P)).
      assert (K : class_name (P ++ [q]) k q).
      { split; [split; [unfold k; lia | unfold k; rewrite Nat2Z.id, nth_error_app2, Nat.sub_diag by lia; auto]|].
        intros j [Hj Ej]. destruct (Z_lt_le_dec j k) as [B|B]; auto. exfalso. apply New.
        rewrite nth_error_app1 in Ej by (unfold k in B; lia). eapply nth_error_In; eauto. }
      exists (N ++ [k]), (Q ++ [q]). split; [|split].
      * apply sorted_app; auto. intros i Hi. apply Names in Hi. destruct Hi as [p [[Hi E] _]].
        assert (Z.to_nat i < length P)%nat by (apply nth_error_Some; congruence). unfold k. lia.
      * intros i. rewrite in_app_iff. split.
        -- intros [Hi|[<-|[]]]; [auto | exists q; auto].
        -- intros [p H]. destruct (class_name_app_inv _ _ _ _ H) as [H'|[_ [_ E]]]; [left; apply Names; eauto|].
           right. left. auto.
      * apply Forall2_app; auto.
Qed.

(* ---- Contact sets ---- *)

Lemma sorted_once : forall N l m k, StronglySorted Z.lt N -> nth_error N l = Some k -> nth_error N m = Some k -> l = m.
Proof.
  intros N l m k S. revert l m. induction S as [|a N S IH F]; intros [|l] [|m] L M; simpl in *; try discriminate; auto.
  - injection L; intros ->. apply nth_error_In in M. rewrite Forall_forall in F. apply F in M. lia.
  - injection M; intros ->. apply nth_error_In in L. rewrite Forall_forall in F. apply F in L. lia.
Qed.
Lemma Forall2_nth : forall (A B : Type) (R : A -> B -> Prop) l m n a, Forall2 R l m -> nth_error l n = Some a ->
  exists b, nth_error m n = Some b /\ R a b.
Proof.
  intros A B R l m n a F. revert n. induction F as [|x y l m H F IH]; intros [|n] E; simpl in *; try discriminate; auto.
  injection E; intros <-. exists y. auto.
Qed.
Lemma Forall2_nth_right : forall (A B : Type) (R : A -> B -> Prop) l m n b, Forall2 R l m -> nth_error m n = Some b ->
  exists a, nth_error l n = Some a /\ R a b.
Proof.
  intros A B R l m n b F. revert n. induction F as [|x y l m H F IH]; intros [|n] E; simpl in *; try discriminate; auto.
  injection E; intros <-. exists x. auto.
Qed.
Lemma Forall2_in : forall (A B : Type) (R : A -> B -> Prop) l m a, Forall2 R l m -> In a l -> exists b, In b m /\ R a b.
Proof.
  intros A B R l m a F H. apply In_nth_error in H. destruct H as [n H].
  destruct (Forall2_nth _ _ _ _ _ _ _ F H) as [b [E Q]]. exists b. split; auto. eapply nth_error_In; eauto.
Qed.
Lemma Forall2_in_right : forall (A B : Type) (R : A -> B -> Prop) l m b, Forall2 R l m -> In b m ->
  exists a, In a l /\ R a b.
Proof.
  intros A B R l m b F H. apply In_nth_error in H. destruct H as [n H].
  destruct (Forall2_nth_right _ _ _ _ _ _ _ F H) as [a [E Q]]. exists a. split; auto. eapply nth_error_In; eauto.
Qed.

Theorem merged_points_differ : forall P N Q, merged P N Q -> NoDup Q.
Proof.
  intros P N Q [S [_ F]]. apply NoDup_nth_error. intros m n Hm E. destruct (nth_error Q m) as [q|] eqn:Em.
  - destruct (Forall2_nth_right _ _ _ _ _ _ _ F Em) as [i [Ei [Ri Li]]].
    destruct (Forall2_nth_right _ _ _ _ _ _ _ F (eq_sym E)) as [j [Ej [Rj Lj]]].
    assert (i = j) by (apply Z.le_antisymm; auto). subst j. eapply sorted_once; eauto.
  - apply nth_error_None in Em. lia.
Qed.

Lemma places_of_names : forall N K, incl K N -> exists L, Forall2 (place_in N) L K.
Proof.
  induction K as [|k K IH]; intros H; [exists []; constructor|].
  destruct IH as [L HL]; [intros i Hi; apply H; right; auto|].
  destruct (In_nth_error N k (H k (or_introl eq_refl))) as [n E].
  exists (Z.of_nat n :: L). constructor; auto. split; [lia | rewrite Nat2Z.id; auto].
Qed.
Lemma places_differ : forall N L K, Forall2 (place_in N) L K -> StronglySorted Z.lt K -> NoDup L.
Proof.
  induction 1 as [|l k L K [_ E] F IH]; intros S; constructor; inversion S as [|? ? S' A]; subst; auto.
  intros H. destruct (Forall2_in _ _ _ _ _ _ F H) as [m [Hm [_ Em]]]. rewrite E in Em. injection Em; intros <-.
  rewrite Forall_forall in A. apply A in Hm. lia.
Qed.

(* The contact set of rows, by names, is that of the merged set, by places. *)
Theorem contact_set_of_merged : forall P N Q x K C, merged P N Q -> contact_names P x K C ->
  exists L, Forall2 (place_in N) L K /\ contact_set Q x L /\ Forall2 (point_at Q) L C.
Proof.
  intros P N Q x K C [SN [Names Points]] [SK [Contacts KC]].
  assert (Sub : incl K N). { intros k Hk. apply Contacts in Hk. destruct Hk as [p [Hp _]]. apply Names. eauto. }
  assert (In_P : forall q, In q Q <-> In q P).
  { intros q. split; intros H.
    - destruct (Forall2_in_right _ _ _ _ _ _ Points H) as [i [_ Hi]]. eapply class_name_in; eauto.
    - destruct (class_name_exists P q H) as [i Hi]. assert (HN : In i N) by (apply Names; eauto).
      destruct (Forall2_in _ _ _ _ _ _ Points HN) as [p [Hp Ei]]. rewrite (class_name_point P i q p); auto. }
  destruct (places_of_names N K Sub) as [L HL]. exists L. split; [auto|]. split; [split|].
  - eapply places_differ; eauto.
  - intros l. split.
    + intros H. destruct (Forall2_in _ _ _ _ _ _ HL H) as [k [Hk [Hl El]]]. apply Contacts in Hk.
      destruct Hk as [p [Hp [_ Near]]]. destruct (Forall2_nth _ _ _ _ _ _ _ Points El) as [p' [Ep Hp']].
      rewrite (class_name_point P k p p') in Near by auto. exists p'. split; [split; auto|].
      intros q Hq. apply Near, In_P, Hq.
    + intros [p [[Hl Ep] Near]]. destruct (Forall2_nth_right _ _ _ _ _ _ _ Points Ep) as [k [Ek Hk]].
      assert (HK : In k K).
      { apply Contacts. exists p. split; auto. split; [eapply class_name_in; eauto|].
        intros q Hq. apply Near, In_P, Hq. }
      destruct (Forall2_in_right _ _ _ _ _ _ HL HK) as [m [Hm [H0 Em]]].
      assert (E := sorted_once _ _ _ _ SN Ek Em). replace l with m by lia. auto.
  - clear - HL KC Points. revert C KC. induction HL as [|l k L K [Hl El] F IH]; intros C KC; inversion KC; subst;
      constructor; auto.
    destruct (Forall2_nth _ _ _ _ _ _ _ Points El) as [p [Ep Hp]]. split; auto. rewrite Ep. f_equal.
    eapply class_name_point; eauto.
Qed.

(* A critical point of rows is one of the merged set. *)
Corollary critical_of_merged : forall P N Q x K C k, merged P N Q -> contact_names P x K C -> has_index C x k ->
  exists L, Forall2 (place_in N) L K /\ critical Q x L k.
Proof.
  intros P N Q x K C k M H [R D]. destruct (contact_set_of_merged P N Q x K C M H) as [L [HL [S F]]].
  exists L. split; auto. split; auto. exists C. auto.
Qed.
